/* Gaussian Material Synthesis from start to end (thesis, algorithm 1): scores of a few random materials, a taste
   learned from them, 300 recommendations, a plane of variants of one of them, and an edited picture turned into a
   material.

     cc -O2 -I. examples/tools/workflow.c -o build/workflow -lm
     build/workflow OUT [--taste metal|glass|jade] [--scores SCORES.csv] [--networks examples/data] [--seed S]

   OUT: a folder, made if it is missing. A scripted user scores 120 materials, or SCORES.csv does (19 parameters and a
   score a row, such as OUT/gallery.csv after an earlier run, edited). Written into OUT:
     gallery.csv       what was scored, with the scores
     recommended.csv   300 materials with predicted score and its standard deviation
     chosen.csv        the chosen material, its 7 variants, and the one matched to the edited picture
     workflow.mtlx     all of these as MaterialX (see materialx.h)
     workflow.png      120 of the gallery with their scores | 100 recommendations | the plane: preference, similarity,
                       product; the chosen material and its variants | chosen, edited, first guess, match, difference x
                       8, and a walk through the plane
     times.md          what each stage took, beside the thesis's Table 3.3 */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "workflow.h"
#include "scores.h"
#include "studio.h"

static const char usage[] =
    "usage: workflow OUT [--taste metal|glass|jade] [--scores SCORES.csv] [--networks examples/data] [--seed S]\n";

static int fail(const char *what, const char *problem)
{
    fprintf(stderr, "workflow: %s: %s\n", what, problem);
    return 1;
}

/* ------------------------------------------------------------------------------------------------ the scripted user */

static double step(double a, double b, double v) /* 0 below a, 1 above b; smooth */
{
    double t = (v - a) / (b - a);
    t = t > 0 ? t < 1 ? t : 1 : 0;
    return t * t * (3 - 2 * t);
}

static double likes_glass(const double *x)
{
    return step(0.25, 0.8, x[17] * (1 - x[16])) * (1 - step(0.3, 0.9, x[11])) * step(-0.5, 0.6, x[10] - x[8]) *
        (1 - step(0, 1, x[18]));
}

static double likes_metal(const double *x)
{
    return step(0.25, 0.8, (1 - x[17]) * x[7]) * (1 - step(0.3, 0.9, x[6])) * step(-0.5, 0.6, x[3] - x[5]);
}

static double likes_jade(const double *x)
{
    return step(0.2, 0.7, x[17] * x[16]) * step(-0.4, 0.6, x[14] - 0.5 * (x[13] + x[15])) * (1 - 0.6 * x[18]);
}

static const taste tastes[] = {{"metal", "polished metals, gold and copper before blue steel", likes_metal},
                               {"glass", "clear glass, blue and green before red", likes_glass},
                               {"jade", "translucent stones, green ones most", likes_jade}};

/* Whole scores from 0 to 10. */
static double score_of(const taste *user, const double *x) { return floor(10 * user->likes(x) + 0.5); }

static double mean_score(const taste *user, const double *x, int count)
{
    double sum = 0;
    int i;
    for (i = 0; i < count; ++i) sum += score_of(user, x + i * M) / count;
    return sum;
}

/* ------------------------------------------------------------------------------------------------------- the stages */

/* Lines 2 to 4 of algorithm 1, in rounds: the first gallery is spread evenly, the later ones show what recommendations
   depend on. */
static ms_status score_gallery(flow *f)
{
    ms_gpr_gallery_options options;
    ms_status status;
    int i;
    memset(&options, 0, sizeof options);
    options.seed = f->seed;
    f->x = (double *)malloc(sizeof(double) * GALLERY * M);
    f->y = (double *)malloc(sizeof(double) * GALLERY);
    if (f->x == NULL || f->y == NULL) {
        snprintf(f->error.message, sizeof f->error.message, "out of memory");
        return MS_OUT_OF_MEMORY;
    }
    for (f->n = 0; f->n < GALLERY; f->n += ROUND) {
        ms_gpr *known;
        status = ms_gpr_fit(f->x, f->y, f->n, M, NULL, &known, NULL, &f->error);
        if (status == MS_OK) status = ms_gpr_gallery(known, &options, ROUND, f->x + f->n * M, &f->error);
        ms_gpr_destroy(known);
        if (status != MS_OK) return status;
        for (i = f->n; i < f->n + ROUND; ++i) f->y[i] = score_of(f->user, f->x + i * M);
    }
    return MS_OK;
}

static ms_status learn(flow *f)
{
    double explained = 0;
    ms_status status = ms_gpr_fit(f->x, f->y, f->n, M, NULL, &f->gp, NULL, &f->error);
    if (status == MS_OK) warnings_judge(f->gp, &explained);
    if (status == MS_OK && warning_of(f->gp, explained, f->warning)) fprintf(stderr, "warning: %s\n", f->warning);
    return status;
}

/* Lines 6 to 9, and 10: one that is only just good enough is chosen, to be improved in the plane. */
static ms_status recommend(flow *f)
{
    ms_gpr_recommend_options options;
    ms_status status;
    int i, pick = 0;
    memset(&options, 0, sizeof options);
    options.tau = 0.7;
    options.seed = f->seed;
    status = ms_gpr_recommend(f->gp, &options, RECOMMENDED, f->recommended, f->mean, f->sigma, NULL, &f->error);
    if (status != MS_OK) return status;
    for (i = 1; i < RECOMMENDED; ++i)
        if (f->mean[i] < f->mean[pick]) pick = i;
    memcpy(f->chosen, f->recommended + pick * M, sizeof f->chosen);
    return MS_OK;
}

/* Lines 5 and 14: the best-scored materials and the chosen one in a plane. */
static ms_status embed(flow *f)
{
    double liked[(STUDIO_LIKED + 1) * M];
    ms_gpr_latent_options options;
    int count = studio_liked(f->gp, STUDIO_LIKED, f->chosen, liked);
    ms_status status;
    if (count == 0) {
        snprintf(f->error.message, sizeof f->error.message,
                 "no score is above the lowest: nothing is known to be liked");
        return f->error.status = MS_BAD_DATA;
    }
    memset(&options, 0, sizeof options);
    options.prior = 0.1; /* keeps the plane compact */
    memcpy(liked + count * M, f->chosen, sizeof f->chosen);
    status = ms_gpr_latent_fit(liked, count + 1, M, &options, &f->plane, NULL, &f->error);
    if (status != MS_OK) return status;
    f->fine = map_around(f->plane, FINE);
    f->coarse = map_around(f->plane, COARSE);
    return status;
}

/* Lines 16 and 12 to 18. */
static ms_status color_preference(flow *f)
{
    ms_status status = map_preference(f->plane, f->gp, &f->fine, f->preference, &f->error);
    return status == MS_OK ? map_confidence(f->plane, &f->fine, f->confidence, &f->error) : status;
}

static ms_status draw_small(void *user, const double *x, float *picture)
{
    pictures((const neural *)user, x, 1, picture);
    return MS_OK;
}

static variant_similarity to_the_chosen(flow *f)
{
    variant_similarity similarity;
    memset(&similarity, 0, sizeof similarity);
    similarity.x = f->chosen;
    similarity.scale = 0.07; /* s = 0.61 at a PSNR of 23 dB */
    similarity.pixels = ms_nn_output_size(f->small.nn);
    similarity.render = draw_small;
    similarity.user = &f->small;
    return similarity;
}

/* Line 15. */
static ms_status color_similarity(flow *f)
{
    variant_similarity similarity = to_the_chosen(f);
    ms_status status = variants_map(f->plane, &similarity, &f->coarse, f->similar, &f->error);
    if (status == MS_OK) map_product(&f->fine, f->preference, &f->coarse, f->similar, f->product);
    return status;
}

/* Section 3.7: from most similar to least, which are liked best; no two look alike. */
static ms_status vary(flow *f)
{
    variant_similarity similarity = to_the_chosen(f);
    double lambda[VARIANTS], row[M];
    ms_status status;
    int i, k;
    for (i = 0; i < VARIANTS; ++i)
        lambda[i] = 0.7 * pow(1 - (i + 0.5) / (int)VARIANTS, 2); /* beyond 0.5 little changes */
    status = variants_find(f->plane, f->gp, &similarity, &f->coarse, lambda, VARIANTS, 0, 0.07, f->variant, f->variants,
                           &f->error);
    for (i = 1; i < VARIANTS && status == MS_OK; ++i)
        for (k = i; k > 0 && f->variant[k].similarity > f->variant[k - 1].similarity; --k) {
            const variant_found better = f->variant[k];
            f->variant[k] = f->variant[k - 1];
            f->variant[k - 1] = better;
            memcpy(row, f->variants + k * M, sizeof row);
            memcpy(f->variants + k * M, f->variants + (k - 1) * M, sizeof row);
            memcpy(f->variants + (k - 1) * M, row, sizeof row);
        }
    for (i = 0; i < VARIANTS * M && status == MS_OK; ++i) f->variants[i] = fmin(fmax(f->variants[i], 0), 1);
    return status;
}

/* Chapter 4: the picture of the chosen material, edited, and the material that looks like it; first the best of the
   inversion networks' guesses, then the match that starts there. */
static ms_status match_edit(flow *f)
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_status status;
    pictures(&f->match.network, f->chosen, 1, f->edited + ms_nn_output_size(f->small.nn));
    edit(f->edited + ms_nn_output_size(f->small.nn), f->small.size * f->small.size, f->edited);
    options.initial_only = 1;
    status = matcher_aim(&f->match, f->edited, NULL, &f->error);
    if (status == MS_OK)
        status = ms_pme_match(&f->match.renderer, f->edited, NULL, &options, f->guess, NULL, &f->found, &f->error);
    if (status == MS_OK)
        status = ms_pme_match(&f->match.renderer, f->edited, NULL, NULL, f->matched, NULL, &f->found, &f->error);
    return status;
}

/* ---------------------------------------------------------------------------------- the same, frame by frame */

static void draw_large(void *user, const float *x, int count, float *planes)
{
    neural_render((const neural *)user, x, count, planes);
}

static void timed(call *c, double begin)
{
    double t = seconds() - begin;
    ++c->count;
    c->sum += t;
    c->most = fmax(c->most, t);
}

/* A session with studio.h: the scores one by one, the fit in steps, recommendations, a circle around the chosen
   material in the plane, of which STEPS pictures are kept. */
static ms_status session(const flow *f, call calls[5], float *walk, ms_error *error)
{
    enum { ROW = 4, MOVES = 60 };
    static const char *const names[] = {"score", "update", "recommend 4", "choose", "move"};
    size_t pixels = ms_nn_output_size(f->large.nn);
    double x[ROW * M], begin;
    studio_renderer renderer;
    studio_view view;
    ms_status status;
    studio s;
    int i;
    memset(calls, 0, 5 * sizeof *calls);
    for (i = 0; i < 5; ++i) calls[i].name = names[i];
    renderer.parameters = M;
    renderer.values = pixels;
    renderer.render = draw_large;
    renderer.user = (void *)(uintptr_t)&f->large;
    status = studio_open(&s, &renderer, error);
    for (i = 0; i < f->n && status == MS_OK; ++i) {
        begin = seconds();
        status = studio_score(&s, f->x + i * M, f->y[i], error);
        timed(&calls[0], begin);
    }
    while (status == MS_OK && !s.settled && calls[1].count < 100) {
        begin = seconds();
        status = studio_update(&s, error);
        timed(&calls[1], begin);
    }
    for (i = 0; i < 10 && status == MS_OK; ++i) {
        begin = seconds();
        status = studio_recommend(&s, ROW, x, walk, error);
        timed(&calls[2], begin);
    }
    for (i = 0; i < 5 && status == MS_OK; ++i) {
        begin = seconds();
        status = studio_choose(&s, f->chosen, error);
        timed(&calls[3], begin);
    }
    for (i = 0; i < MOVES && status == MS_OK; ++i) {
        double turn = 2 * 3.14159265358979 / (int)MOVES;
        begin = seconds();
        status = studio_move(&s, -0.7 * turn * sin(turn * i), 0.7 * turn * cos(turn * i), &view, error);
        timed(&calls[4], begin);
        if (status == MS_OK && i % (MOVES / STEPS) == 0)
            memcpy(walk + (size_t)(i / (MOVES / STEPS)) * pixels, view.planes, pixels * sizeof *walk);
    }
    studio_close(&s);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- the run */

static const char *load(flow *f, const char *folder)
{
    char path[512];
    const char *problem;
    snprintf(path, sizeof path, "%s/preview_64.safetensors",
             folder); /* galleries: two thirds of the work of the one that is matched with */
    if ((problem = neural_load(path, &f->small)) != NULL) return problem;
    snprintf(path, sizeof path, "%s/renderer_64.safetensors", folder);
    if (matcher_open(&f->match, path, &f->error) != MS_OK) return f->error.message;
    snprintf(path, sizeof path, "%s/renderer_128.safetensors", folder);
    if ((problem = neural_load(path, &f->large)) != NULL) return problem;
    if (f->small.parameters != M || f->large.parameters != M) return "a renderer has not 19 parameters";
    if (f->small.size != 64 || f->large.size != 128) return "the pictures are not of 64 and 128 pixels";
    return matcher_add_inversions(&f->match, folder, &f->error) == MS_OK ? NULL : f->error.message;
}

static const char *read_scores(flow *f, const char *path)
{
    static scores s;
    static char text[320];
    const char *problem = scores_read(path, &s);
    int i, k;
    if (!problem && s.m != M) {
        snprintf(text, sizeof text, "has %d parameters, 19 and a score were expected", s.m);
        return text;
    }
    for (i = 0; !problem && i < s.n; ++i)
        for (k = 0; k < M; ++k)
            if (!(s.x[i * M + k] >= 0 && s.x[i * M + k] <= 1)) {
                snprintf(text, sizeof text, "%.40s is %.6g, outside of 0 to 1 (line %d)", s.name[k], s.x[i * M + k],
                         s.lines[i]);
                return text;
            }
    if (problem && s.line > 0) {
        snprintf(text, sizeof text, "%s (line %d)", problem, s.line);
        return text;
    }
    if (problem) return problem;
    if (*s.note) fprintf(stderr, "Of the scores, %s.\n", s.note);
    f->n = s.n;
    f->x = s.x;
    f->y = s.y;
    s.x = s.y = NULL;
    scores_free(&s);
    return NULL;
}

static int misused(const char *option, const char *value, const char *expected)
{
    fprintf(stderr, "workflow: %s %s: expected %s\n", option, value, expected);
    return file_usage(usage);
}

int main(int argc, char **argv)
{
    static flow flow_data;
    flow *f = &flow_data;
    const char *out = NULL, *file = NULL, *networks = "examples/data", *problem = NULL;
    float *gallery, *recommended, *walk;
    char path[512];
    call calls[5];
    double t;
    image page;
    file_out times;
    int i;
    if (file_help(argc, argv, usage)) return file_end_stdout("workflow");
    f->user = &tastes[0];
    for (i = 1; i < argc; ++i) {
        if (argv[i][0] != '-' && out == NULL) out = argv[i];
        else if (argv[i][0] != '-') return misused(argv[i], "", "one folder, and options that begin with --");
        else if (i + 1 == argc) return misused(argv[i], "", "a value behind it");
        else if (strcmp(argv[i], "--scores") == 0) file = argv[++i];
        else if (strcmp(argv[i], "--networks") == 0) networks = argv[++i];
        else if (strcmp(argv[i], "--seed") == 0) {
            char *end;
            const double seed = number_read(argv[++i], '.', &end);
            if (end == argv[i] || *end || !(seed >= 0 && seed <= 9007199254740992.0) || seed > floor(seed))
                return misused("--seed", argv[i], "a whole number from 0 to 2^53");
            f->seed = (uint64_t)seed;
        } else if (strcmp(argv[i], "--taste") == 0) {
            for (f->user = tastes, ++i; f->user < tastes + 3 && strcmp(f->user->name, argv[i]) != 0; ++f->user) {}
            if (f->user == tastes + 3) return misused("--taste", argv[i], "metal, glass or jade");
        } else return misused(argv[i], "", "one of the options below");
    }
    if (out == NULL) return file_usage(usage);

    t = seconds();
    if ((problem = load(f, networks)) != NULL) return fail(networks, problem);
    t = note(f, "load the networks", 0, "", "", t);
    if (file && (problem = read_scores(f, file)) != NULL) return fail(file, problem);
    if (!file && score_gallery(f) != MS_OK) return fail("gallery", f->error.message);
    t = note(f, file ? "read the scores" : "gallery in rounds of 20", f->n, "", "", t);
    gallery = (float *)malloc((size_t)f->n * ms_nn_output_size(f->small.nn) * sizeof(float));
    recommended = (float *)malloc(RECOMMENDED * ms_nn_output_size(f->small.nn) * sizeof(float));
    walk = (float *)malloc((STEPS + 3) * ms_nn_output_size(f->large.nn) * sizeof(float));
    f->edited = (float *)malloc(2 * ms_nn_output_size(f->small.nn) * sizeof(float));
    if (!gallery || !recommended || !walk || !f->edited) return fail("pictures", "out of memory");
    pictures(&f->small, f->x, f->n, gallery);
    t = note(f, "pictures of the gallery", f->n, " of 64^2", "", t);
    if (learn(f) != MS_OK) return fail("the taste", f->error.message);
    t = note(f, "GPR", f->n, "", "7220 (250)", t);
    if (recommend(f) != MS_OK) return fail("recommendations", f->error.message);
    t = note(f, "recommendation", RECOMMENDED, "", "17400 (300)", t);
    pictures(&f->small, f->recommended, RECOMMENDED, recommended);
    t = note(f, "their pictures", RECOMMENDED, " of 64^2", "40 (one of 410^2, GPU)", t);
    if (embed(f) != MS_OK) return fail("the plane", f->error.message);
    t = note(f, "GPLVM", ms_gpr_latent_view_of(f->plane).z, "", "1960 (16)", t);
    if (color_preference(f) != MS_OK) return fail("the preference map", f->error.message);
    t = note(f, "preference coding", FINE, "^2", "2750 (50^2)", t);
    if (color_similarity(f) != MS_OK) return fail("the similarity map", f->error.message);
    t = note(f, "similarity coding", COARSE, "^2", "8150 (20^2, GPU)", t);
    if (vary(f) != MS_OK) return fail("the variants", f->error.message);
    t = note(f, "variants", VARIANTS, "", "", t);
    if (match_edit(f) != MS_OK) return fail("the match", f->error.message);
    t = note(f, "match of an edited picture", f->small.size, "^2", "", t);
    if (session(f, calls, walk, &f->error) != MS_OK) return fail("the session", f->error.message);
    t = seconds(); /* the session repeats what was done above: it has a table of its own */
    if ((problem = write_files(f, out)) != NULL) return fail(out, problem);
    if ((problem = draw_page(f, gallery, recommended, walk, &page)) != NULL) return fail(out, problem);
    snprintf(path, sizeof path, "%s/workflow.png", out);
    if ((problem = image_write(path, &page)) != NULL) return fail(path, problem);
    note(f, "page, CSV and MaterialX", 0, "", "", t);
    snprintf(path, sizeof path, "%s/times.md", out);
    if (file_create(path, &times) == NULL) return fail(path, times.problem);
    report(times.f, f, calls);
    if ((problem = file_finish(&times, 1)) != NULL) return fail(path, problem);

    if (file) printf("%d score%s of %s.\n", f->n, f->n == 1 ? "" : "s", file);
    else
        printf("%d scores of a user who likes %s. Mean score of %d random materials: %.1f; "
               "of the recommended ones: %.1f.\n",
               f->n, f->user->words, GALLERY / 2, mean_score(f->user, f->x, GALLERY / 2),
               mean_score(f->user, f->recommended, RECOMMENDED));
    printf("Match: RMSE %.2f of 255 at the first guess, %.2f after %.0f renders.\n\n", 255 * f->found.rmse_initial,
           255 * f->found.rmse, f->found.cost);
    report(stdout, f, calls);
    ms_gpr_latent_destroy(f->plane);
    ms_gpr_destroy(f->gp);
    matcher_close(&f->match);
    neural_free(&f->small);
    neural_free(&f->large);
    image_free(&page);
    free(f->x), free(f->y), free(f->edited);
    free(gallery), free(recommended), free(walk);
    return file_end_stdout("workflow");
}
