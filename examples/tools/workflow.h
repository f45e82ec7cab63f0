/* What workflow.c works on and leaves behind: the state of the run, the page of pictures, the CSV and MaterialX files,
   the table of times. ms_gpr.h, ms_nn.h and ms_pme.h come first. */
#ifndef EXAMPLES_WORKFLOW_H
#define EXAMPLES_WORKFLOW_H
#include "neural.h"
#include "files.h"
#include "maps.h"
#include "matcher.h"
#include "materialx.h"
#include "text.h"
#include "warnings.h"
#include <time.h>

enum { M = 19, GALLERY = 120, ROUND = 20, RECOMMENDED = 300, FINE = 50, COARSE = 20, VARIANTS = 7, STEPS = 5 };

/* A scripted user: what is liked, from 0 to 1, and the words for it. */
typedef struct taste {
    const char *name, *words;
    double (*likes)(const double *x);
} taste;

typedef struct stage {
    const char *name, *thesis;
    char size[24];
    double seconds;
} stage;

typedef struct flow {
    const taste *user;
    neural small, large; /* 64^2 for searching, 128^2 for looking */
    uint64_t seed;
    int n;         /* scored */
    double *x, *y; /* [n][M], [n] */
    ms_gpr *gp;
    double recommended[RECOMMENDED * M], mean[RECOMMENDED], sigma[RECOMMENDED];
    double chosen[M];
    ms_gpr_latent *plane;
    map_grid fine, coarse;
    double preference[FINE * FINE], confidence[FINE * FINE], product[FINE * FINE], similar[COARSE * COARSE];
    variant_found variant[VARIANTS];
    double variants[VARIANTS * M];
    float *edited; /* the target picture, [3][64][64], and the one before the edit */
    double guess[M], matched[M];
    matcher match;
    ms_pme_match_result found;
    stage stages[16];
    int stage_count;
    char warning[WARNINGS_TEXT]; /* what the scores do not support; empty: nothing */
    ms_error error;
} flow;

typedef struct call {
    const char *name;
    int count;
    double sum, most; /* seconds */
} call;

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* Notes what a stage took since `begin`; count 0: it has no size. */
static double note(flow *f, const char *name, int count, const char *unit, const char *thesis, double begin)
{
    stage *s = &f->stages[f->stage_count++];
    double now = seconds();
    s->name = name;
    s->thesis = thesis;
    s->seconds = now - begin;
    if (count) snprintf(s->size, sizeof s->size, "%d%s", count, unit);
    return now;
}

/* The network's pictures of x [count][M], clipped to [0, 1] first, as variants may leave it. */
static void pictures(const neural *net, const double *x, int count, float *planes)
{
    float row[NEURAL_BATCH * M];
    int i, k, batch;
    for (i = 0; i < count; i += batch) {
        batch = count - i < NEURAL_BATCH ? count - i : (int)NEURAL_BATCH;
        for (k = 0; k < batch * M; ++k) row[k] = (float)fmin(fmax(x[i * M + k], 0), 1);
        neural_render(net, row, batch, planes + (size_t)i * ms_nn_output_size(net->nn));
    }
}

/* An edit as in any picture editor: hues turned by 50 degrees around the gray axis; what has no color stays as it
   is. */
static void edit(const float *planes, int pixels, float *edited)
{
    const double angle = 50 * 3.14159265358979 / 180, c = cos(angle), s = sin(angle) / sqrt(3.0);
    int i, k;
    for (i = 0; i < pixels; ++i)
        for (k = 0; k < 3; ++k) {
            double own = (double)planes[k * pixels + i], next = (double)planes[(k + 1) % 3 * pixels + i];
            double last = (double)planes[(k + 2) % 3 * pixels + i], gray = (own + next + last) / 3;
            edited[k * pixels + i] = (float)fmin(fmax(gray + c * (own - gray) + s * (last - next), 0), 1);
        }
}

/* --------------------------------------------------------------------------------------------------------- the page */

enum { PAGE = 1320, GAP = 8, HEAD = 30 };

/* Words above a block of pictures, in the middle of a width where one is given. */
static void words(image *page, int left, int top, int width, const char *text)
{
    static const float white[3] = {0.92f, 0.92f, 0.92f};
    if (width) image_text_in(page, left, top + 5, width, text, 20, white);
    else image_text(page, left, top + 5, text, 20, white);
}

/* A bar below a picture: how much of `width` is lit. */
static void bar(image *page, int left, int top, int width, double share)
{
    static const float gold[3] = {1, 0.76f, 0.22f};
    int x, y, c;
    for (y = 0; y < 3; ++y)
        for (x = 0; x < width; ++x)
            for (c = 0; c < 3; ++c)
                page->pixels[3 * ((top + y) * page->width + left + x) + c] = x < share * width ? gold[c] : 0.2f;
}

/* A picture, `light` times as bright. */
static void tile(image *page, int left, int top, const float *planes, int size, float light)
{
    int x, y, c;
    for (c = 0; c < 3; ++c)
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x)
                page->pixels[3 * ((top + y) * page->width + left + x) + c] = fminf(
                    fmaxf(light * planes[(c * size + y) * size + x], 0), 1);
}

/* A map over the plane with its dots: white the embedded materials, red the chosen one, black its variants. */
static void map(const flow *f, image *page, int left, int top, int side, const map_grid *grid, const double *value)
{
    static const float white[3] = {1, 1, 1}, red[3] = {1, 0.15f, 0.1f}, black[3] = {0, 0, 0};
    const double *latent = ms_gpr_latent_view_of(f->plane).points;
    int last = ms_gpr_latent_view_of(f->plane).z - 1, i;
    map_draw(page, left, top, side, grid, value, &f->fine, f->confidence);
    for (i = 0; i < last; ++i) map_dot(page, left, top, side, grid, latent + 2 * i, 3, white);
    map_dot(page, left, top, side, grid, latent + 2 * last, 5, red);
    for (i = 0; i < VARIANTS; ++i) map_dot(page, left, top, side, grid, f->variant[i].latent, 2.5, black);
}

/* Gallery and recommendations come as pictures of f->small, the walk as pictures of f->large. */
static const char *draw_page(const flow *f, const float *gallery, const float *recommended, const float *walk,
                             image *page)
{
    enum { WIDE = 20, PITCH = PAGE / WIDE, TALL = PITCH + 5, ROWS = 6, SHOWN = 100, SIDE = 264, TILE = 132 };
    static const char *const last[] = {"chosen", "edited", "first guess", "match", "8 \xd7 difference"};
    int small = f->small.size, large = f->large.size, shown = f->n < WIDE * ROWS ? f->n : WIDE * ROWS;
    int rows = (shown + WIDE - 1) / WIDE, i, k, top = 0;
    size_t pixels = ms_nn_output_size(f->small.nn), large_pixels = ms_nn_output_size(f->large.nn);
    double best = 1e-300; /* score */
    char text[80];
    const char *from;
    const int lines = (int)(strlen(f->warning) + 59) / 60; /* no word has 20 letters */
    float *planes = (float *)malloc((VARIANTS + 1) * large_pixels * sizeof(float));
    *page = image_new(
        PAGE, HEAD * (1 + lines) + rows * TALL + HEAD + SHOWN / WIDE * PITCH + HEAD + SIDE + HEAD + TILE + GAP, 3);
    if (page->pixels == NULL || planes == NULL) return "out of memory";
    for (i = 0; i < f->n; ++i) best = fmax(best, f->y[i]);
    for (i = 0; (size_t)i < image_count(page); ++i) page->pixels[i] = 0.09f;
    if (shown < f->n)
        snprintf(text, sizeof text, "gallery: %d of %d scored materials; the bar is the score", shown, f->n);
    else snprintf(text, sizeof text, "gallery: %d scored materials; the bar is the score", f->n);
    words(page, GAP, top, 0, text);
    top += HEAD;
    for (from = f->warning; *from; from += strlen(text)) { /* in lines of up to 79 letters */
        snprintf(text, sizeof text, "%.79s", from);
        if (from[strlen(text)] && strrchr(text, ' ')) strrchr(text, ' ')[1] = 0;
        words(page, GAP, top, 0, text);
        top += HEAD;
    }
    for (i = 0; i < shown; ++i) {
        tile(page, i % WIDE * PITCH, top + i / WIDE * TALL, gallery + (size_t)i * pixels, small, 1);
        bar(page, i % WIDE * PITCH, top + i / WIDE * TALL + small, small, fmax(f->y[i], 0) / best);
    }
    top += rows * TALL;
    snprintf(text, sizeof text, "recommended: %d of %d new materials to that taste", (int)SHOWN, (int)RECOMMENDED);
    words(page, GAP, top, 0, text);
    top += HEAD;
    for (i = 0; i < SHOWN; ++i)
        tile(page, i % WIDE * PITCH, top + i / WIDE * PITCH, recommended + (size_t)i * pixels, small, 1);
    top += SHOWN / WIDE * PITCH;

    words(page, 0, top, SIDE, "predicted score");
    words(page, SIDE, top, SIDE, "likeness to the red one");
    words(page, 2 * SIDE, top, SIDE, "score \xd7 likeness");
    words(page, 3 * SIDE, top, TILE, "chosen");
    words(page, 3 * SIDE + TILE, top, 3 * TILE, "variants");
    top += HEAD;
    map(f, page, 0, top, SIDE - 2, &f->fine, f->preference);
    map(f, page, SIDE, top, SIDE - 2, &f->coarse, f->similar);
    map(f, page, 2 * SIDE, top, SIDE - 2, &f->fine, f->product);
    pictures(&f->large, f->chosen, 1, planes);
    pictures(&f->large, f->variants, VARIANTS, planes + large_pixels);
    for (i = 0; i <= VARIANTS; ++i)
        tile(page, 3 * SIDE + i % 4 * TILE, top + i / 4 * TILE, planes + (size_t)i * large_pixels, large, 1);
    top += SIDE;

    for (i = 0; i < 5; ++i) words(page, i * TILE, top, TILE, last[i]);
    words(page, 5 * TILE, top, 5 * TILE, "a walk through the plane");
    top += HEAD;
    edit(planes, large * large, planes + large_pixels); /* of the chosen one, which stands first */
    pictures(&f->large, f->guess, 1, planes + 2 * large_pixels);
    pictures(&f->large, f->matched, 1, planes + 3 * large_pixels);
    for (k = 0; k < (int)large_pixels; ++k)
        planes[4 * large_pixels + (size_t)k] = fabsf(planes[3 * large_pixels + (size_t)k] -
                                                     planes[large_pixels + (size_t)k]);
    for (i = 0; i < 5; ++i) tile(page, i * TILE, top, planes + (size_t)i * large_pixels, large, i < 4 ? 1 : 8);
    for (i = 0; i < STEPS; ++i) tile(page, (5 + i) * TILE, top, walk + (size_t)i * large_pixels, large, 1);
    free(planes);
    return NULL;
}

/* -------------------------------------------------------------------------------------------------------- the files */

static const char *write_files(flow *f, const char *folder)
{
    static const char *const kinds[] = {"chosen", "variant", "matched"};
    double picked[(VARIANTS + 2) * M], score[VARIANTS + 2];
    const char *problem;
    char path[512], name[32], doc[80], text[48];
    file_out tables, materials;
    FILE *csv, *mtlx;
    int i, k, table;
    memcpy(picked, f->chosen, sizeof f->chosen);
    memcpy(picked + M, f->variants, sizeof f->variants);
    memcpy(picked + (VARIANTS + 1) * M, f->matched, sizeof f->matched);
    if (ms_gpr_predict(f->gp, picked, VARIANTS + 2, score, NULL, &f->error) != MS_OK) return f->error.message;
    snprintf(path, sizeof path, "%s/workflow.mtlx", folder);
    if ((mtlx = file_create(path, &materials)) == NULL) return materials.problem;
    materialx_begin(mtlx);
    for (table = 0; table < 3; ++table) {
        static const char *const names[] = {"gallery", "recommended", "chosen"};
        const double *x = table == 0 ? f->x : table == 1 ? f->recommended : picked;
        int rows = table == 0 ? f->n : table == 1 ? (int)RECOMMENDED : VARIANTS + 2;
        snprintf(path, sizeof path, "%s/%s.csv", folder, names[table]);
        if ((csv = file_create(path, &tables)) == NULL) {
            file_finish(&materials, 0);
            return tables.problem;
        }
        for (k = 0; k < M; ++k) fprintf(csv, "x%d,", k);
        fprintf(csv, table == 1 ? "mean,sigma\n" : table == 0 ? "score\n" : "mean\n");
        for (i = 0; i < rows; ++i) {
            for (k = 0; k < M; ++k) fprintf(csv, "%s,", number_text(text, "%.6f", x[i * M + k]));
            fprintf(csv, "%s",
                    number_text(text, table ? "%.4g" : "%g",
                                table == 0       ? f->y[i]
                                    : table == 1 ? f->mean[i]
                                                 : score[i]));
            if (table == 1) fprintf(csv, ",%s", number_text(text, "%.4g", f->sigma[i]));
            fprintf(csv, "\n");
            if (table == 0) continue;
            if (table == 1) snprintf(name, sizeof name, "recommended_%03d", i + 1);
            else if (i % (VARIANTS + 1) == 0) snprintf(name, sizeof name, "%s", kinds[i ? 2 : 0]);
            else snprintf(name, sizeof name, "%s_%d", kinds[1], i);
            snprintf(doc, sizeof doc, "predicted score %s",
                     number_text(text, "%.2f", table == 1 ? f->mean[i] : score[i]));
            materialx_write(mtlx, name, x + i * M, doc);
        }
        if ((problem = file_finish(&tables, 1)) != NULL) {
            file_finish(&materials, 0);
            return problem;
        }
    }
    materialx_end(mtlx);
    return file_finish(&materials, 1);
}

/* ------------------------------------------------------------------------------------------------------- the report */

static void report(FILE *out, const flow *f, const call calls[5])
{
    double sum = 0;
    int i;
    fprintf(out, "| stage | size | time, ms | thesis, ms (size) |\n|---|---|---:|---:|\n");
    for (i = 0; i < f->stage_count; ++i) {
        fprintf(out, "| %s | %s | %.1f | %s |\n", f->stages[i].name, f->stages[i].size, 1e3 * f->stages[i].seconds,
                f->stages[i].thesis);
        sum += f->stages[i].seconds;
    }
    fprintf(out, "| **sum** | | **%.0f** | 20180, with 300 recommendations 37520 |\n", 1e3 * sum);
    fprintf(out, "\n| interactive call | calls | mean, ms | longest, ms |\n|---|---:|---:|---:|\n");
    for (i = 0; i < 5; ++i)
        fprintf(out, "| %s | %d | %.2f | %.2f |\n", calls[i].name, calls[i].count, 1e3 * calls[i].sum / calls[i].count,
                1e3 * calls[i].most);
}
#endif
