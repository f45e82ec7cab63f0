/* The studio's side of WebAssembly: examples/tools/studio.h and its friends behind calls of numbers, for
   studio.worker.js. Files are read and written where the page's WASI (wasi.js) keeps them, in memory. clang
   --target=wasm32-wasi -mexec-model=reactor -O3 -msimd128 -I. examples/web/studio.c -o studio.wasm Calls return 0, or a
   status, and then message() says why. Materials go through x(), numbers through numbers(), pictures through rgba(), 4
   bytes a pixel as a canvas takes them. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "../tools/studio.h"
#include "../tools/matcher.h"
#include "../tools/maps.h"
#include "../tools/materialx.h"

#define CALL(type, name, arguments) \
    type web_##name arguments;      \
    __attribute__((export_name(#name))) type web_##name arguments

enum { M = 19, SIZE = 128, PIXELS = SIZE * SIZE, ROOM = 128, GRID = 24, MAP = 192, TEXT = 1 << 14 };

static matcher the_matcher;
static studio session;
static ms_error error;
static double material[ROOM * M], number[4 * ROOM];
static float picture[3 * PIXELS], source[3 * PIXELS], target[3 * PIXELS];
static unsigned char bytes[MAP * MAP * 4];
static char text[TEXT];
static int targets; /* non-zero: aimed at `target` */

CALL(double *, x, (void)) { return material; }
CALL(double *, numbers, (void)) { return number; }
CALL(unsigned char *, rgba, (void)) { return bytes; }
CALL(char *, text, (void)) { return text; }
CALL(const char *, message, (void)) { return error.message; }

static void to_rgba(const float *planes)
{
    int i, c;
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 3; ++c) bytes[4 * i + c] = image_to_byte(planes[c * PIXELS + i]);
        bytes[4 * i + 3] = 255;
    }
}

static void render(void *user, const float *x, int count, float *planes)
{
    neural_render((const neural *)user, x, count, planes);
}

/* A network of I8 and F16 as the page holds it becomes one of F32, which plain C multiplies fastest. */
static ms_status widen(const char *path)
{
    enum { MOST = 64 };
    ms_nn_tensor out[MOST];
    ms_nn_entry entries[MOST];
    ms_nn_file *file;
    size_t i, k, e, count = 0, size = 0;
    ms_status status;
    status = ms_nn_file_read(path, NULL, &file, &error);
    if (status != MS_OK) return status;
    for (i = 0; i < ms_nn_file_tensor_count(file) && count < MOST; ++i) {
        const ms_nn_tensor *t = ms_nn_file_tensor(file, i);
        char name[300];
        const ms_nn_tensor *scale;
        size_t values = 1, row;
        float *wide;
        if (strlen(t->name) > 6 && strcmp(t->name + strlen(t->name) - 6, "_scale") == 0) continue;
        for (k = 0; k < (size_t)t->rank; ++k) values *= t->shape[k];
        out[count] = *t;
        if (t->dtype == MS_NN_I8 && t->rank == 2) {
            snprintf(name, sizeof name, "%s_scale", t->name);
            scale = ms_nn_file_find(file, name);
            wide = (float *)malloc(values * sizeof *wide);
            if (wide == NULL || scale == NULL)
                return studio__refuse(&error, MS_OUT_OF_MEMORY, "no memory for a network");
            row = values / t->shape[0];
            for (k = 0; k < values; ++k) {
                float s;
                memcpy(&s, (const char *)scale->data + k / row * 4, 4);
                wide[k] = s * (float)((const signed char *)t->data)[k];
            }
            out[count].dtype = MS_NN_F32;
            out[count].data = wide;
            out[count].bytes = values * sizeof *wide;
        }
        ++count;
    }
    for (e = 0; e < ms_nn_file_entry_count(file) && e < MOST; ++e) entries[e] = *ms_nn_file_entry(file, e);
    status = ms_nn_file_write(out, count, entries, e, NULL, 0, &size, &error);
    if (status == MS_OK) {
        void *saved = malloc(size);
        FILE *f = fopen(path, "wb");
        if (saved == NULL || f == NULL) status = studio__refuse(&error, MS_OUT_OF_MEMORY, "no memory for a network");
        else status = ms_nn_file_write(out, count, entries, e, saved, size, &size, &error);
        if (status == MS_OK && fwrite(saved, 1, size, f) != size)
            status = studio__refuse(&error, MS_IO, "a network cannot be written");
        if (f) fclose(f);
        free(saved);
    }
    for (i = 0; i < count; ++i)
        if (out[i].data != NULL && out[i].dtype == MS_NN_F32 && ms_nn_file_find(file, out[i].name)->dtype == MS_NN_I8)
            free((void *)(uintptr_t)out[i].data);
    ms_nn_file_close(file);
    return status;
}

/* The renderer, and for the one who matches the inversion network as well. */
CALL(int, open, (int matches))
{
    studio_renderer r;
    ms_status status = widen("renderer.safetensors");
    if (status == MS_OK) status = matcher_open(&the_matcher, "renderer.safetensors", &error);
    if (status == MS_OK && (the_matcher.network.parameters != M || the_matcher.network.size != SIZE))
        status = studio__refuse(&error, MS_UNSUPPORTED, "the renderer has other parameters or pixels than the page");
    if (status == MS_OK && matches) {
        status = widen("inversion.safetensors");
        if (status == MS_OK) status = matcher_add_inversion(&the_matcher, "inversion.safetensors", &error);
        if (status == MS_OK) status = matcher_aim(&the_matcher, target, NULL, &error); /* the factorisation, once */
    }
    r.parameters = M;
    r.values = 3 * PIXELS;
    r.render = render;
    r.user = &the_matcher.network;
    return status == MS_OK ? (int)studio_open(&session, &r, &error) : (int)status;
}

/* --------------------------------------------------------------------------------------- scores and recommendations */

CALL(int, scores, (void)) { return ms_gpr_view_of(session.gp).n; }
CALL(int, state, (void)) { return (int)session.state; }
CALL(int, settled, (void)) { return session.settled || session.state == STUDIO_EMPTY; }

CALL(int, gallery, (int count)) { return (int)studio_gallery(&session, count, material, NULL, &error); }
CALL(int, score, (double score)) { return (int)studio_score(&session, material, score, &error); }
CALL(int, rescore, (int index, double score)) { return (int)studio_rescore(&session, index, score, &error); }
CALL(int, better, (void))
{
    return (int)studio_better(&session, material, material + M, &error);
} /* material 0 of x than material 1 */
CALL(int, neither, (int count)) { return (int)studio_pick(&session, material, count, NULL, 0, &error); }
CALL(int, like, (int count)) { return (int)studio_like(&session, material, count, &error); }
CALL(int, avoid, (void)) { return (int)studio_avoid(&session, material, &error); }
CALL(int, undo, (void)) { return (int)studio_undo(&session, &error); }
CALL(int, wants_picks, (void)) { return studio_wants_picks(session.gp); }
CALL(int, update, (void)) { return (int)studio_update(&session, &error); }

/* The row of a score that the others contradict, with what it is and what was expected in numbers [2]; -1: none. */
CALL(int, outlier, (void))
{
    number[0] = session.outlier.value;
    number[1] = session.outlier.expected;
    return session.outlier.row;
}

/* 1: what the scores do not support is in message. */
CALL(int, warning, (void))
{
    char says[WARNINGS_TEXT];
    if (!studio_warning(&session, says)) return 0;
    snprintf(error.message, sizeof error.message, "%s", says);
    return 1;
}

/* Means and standard deviations of x [count] into numbers [count] each. */
CALL(int, predict, (int count))
{
    int i;
    ms_status status = ms_gpr_predict(session.gp, material, count, number, number + count, &error);
    for (i = 0; i < count && status == MS_OK; ++i) number[count + i] = sqrt(number[count + i]);
    return (int)status;
}

/* 0: recommendations reach what is liked; 1: too little is known, they are variants of liked materials; 2: nothing was
   liked yet. */
CALL(int, guessed, (void))
{
    return session.found.search != MS_GPR_SEARCH_VARIANTS ? 0 : session.found.liked > 0 ? 1 : 2;
}
CALL(int, recommend, (int count))
{
    ms_status status = studio_recommend(&session, count, material, NULL, &error);
    return status == MS_OK ? web_predict(count) : (int)status;
}

/* -------------------------------------------------------------------------------------------------------- the plane */

/* The plane around x, as a map of what is liked (rgba [MAP][MAP]) and in numbers: the window x0, x1, y0, y1, where one
   stands, how many materials it holds, and where they are. */
CALL(int, choose, (void))
{
    static double value[GRID * GRID], sure[GRID * GRID], one[GRID * GRID];
    map_grid grid;
    ms_status status = studio_choose(&session, material, &error);
    image im;
    int i, x, y, c, count;
    double least = 1e30, most = -1e30;
    if (status != MS_OK) return (int)status;
    grid = map_around(session.plane, GRID);
    status = map_preference(session.plane, session.gp, &grid, value, &error);
    if (status == MS_OK) status = map_confidence(session.plane, &grid, sure, &error);
    im = image_new(MAP, MAP, 3);
    if (status == MS_OK && im.pixels == NULL)
        status = studio__refuse(&error, MS_OUT_OF_MEMORY, "no memory for the map");
    if (status == MS_OK) {
        for (i = 0; i < GRID * GRID; ++i) { /* colors of what is known; the rest is seen through */
            one[i] = 1;
            if (sure[i] >= 0.25) least = fmin(least, value[i]), most = fmax(most, value[i]);
        }
        for (i = 0; i < GRID * GRID && least < most; ++i) value[i] = fmin(fmax(value[i], least), most);
        map_draw(&im, 0, 0, MAP, &grid, value, &grid, one);
        for (y = 0; y < MAP; ++y)
            for (x = 0; x < MAP; ++x) {
                double a = grid.x0 + (grid.x1 - grid.x0) * (x + 0.5) / (double)MAP,
                       b = grid.y1 - (grid.y1 - grid.y0) * (y + 0.5) / (double)MAP;
                i = y * MAP + x;
                for (c = 0; c < 3; ++c) bytes[4 * i + c] = image_to_byte(im.pixels[3 * i + c]);
                bytes[4 * i + 3] = image_to_byte((float)map_value(&grid, sure, a, b));
            }
        number[0] = grid.x0;
        number[1] = grid.x1;
        number[2] = grid.y0;
        number[3] = grid.y1;
        memcpy(number + 4, session.at, sizeof session.at);
        count = ms_gpr_latent_view_of(session.plane).z;
        number[6] = count;
        memcpy(number + 7, ms_gpr_latent_view_of(session.plane).points, 2 * sizeof(double) * (size_t)count);
    }
    image_free(&im);
    return (int)status;
}

/* What stands at numbers [count][2] of the plane, into x, and how sure the plane is of it, into numbers [count]. */
CALL(int, look, (int count))
{
    static double variance[ROOM];
    ms_status status;
    int i;
    if (session.state != STUDIO_EXPLORING)
        return (int)studio__refuse(&error, MS_INVALID_ARGUMENT, "no material was chosen yet");
    status = ms_gpr_latent_map(session.plane, number, count, material, variance, &error);
    for (i = 0; i < count * M && status == MS_OK; ++i) material[i] = fmin(fmax(material[i], 0), 1);
    memcpy(number, variance, sizeof(double) * (size_t)count);
    return (int)status;
}

/* Walks to a place; its material in x, predicted score and deviation in numbers, its picture in rgba. */
CALL(int, move, (double to_x, double to_y))
{
    studio_view view;
    ms_status status = studio_move(&session, to_x - session.at[0], to_y - session.at[1], &view, &error);
    if (status != MS_OK) return (int)status;
    memcpy(material, view.x, M * sizeof(double));
    number[0] = view.score;
    number[1] = view.sigma;
    to_rgba(view.planes);
    return 0;
}

/* ----------------------------------------------------------------------------------------------- pictures and paint */

/* The picture of material `index` of x. */
CALL(int, draw, (int index))
{
    float row[M];
    int k;
    for (k = 0; k < M; ++k) row[k] = (float)material[index * M + k];
    neural_render(&the_matcher.network, row, 1, picture);
    to_rgba(picture);
    return 0;
}

/* 1 on the ball of the pictures, 0 beside it, a soft edge. */
static float ball(int x, int y)
{
    float u = ((float)x + 0.5f) / (float)SIZE - 0.5f, v = ((float)y + 0.5f) / (float)SIZE - 0.457f,
          t = (0.377f - sqrtf(u * u + v * v)) * 50 + 0.5f;
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

/* The picture of material 0 of x, edited: colors times `saturation`, turned by `hue` turns, times 2^light, towards the
   color red, green, blue by `tint` with its brightness kept; then the strokes in rgba, painted over. It becomes the
   target, and rgba. */
CALL(int, paint, (double saturation, double hue, double light, double tint, double red, double green, double blue))
{
    const float c = cosf((float)hue * 6.2831853f), s = sinf((float)hue * 6.2831853f) / 1.7320508f,
                gain = exp2f((float)light);
    const float amount = (float)tint, color[3] = {(float)red, (float)green, (float)blue};
    const float luma = 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2];
    float row[M];
    int x, y, k;
    for (k = 0; k < M; ++k) row[k] = (float)material[k];
    neural_render(&the_matcher.network, row, 1, source);
    for (y = 0; y < SIZE; ++y)
        for (x = 0; x < SIZE; ++x) {
            int i = y * SIZE + x;
            float inside = ball(x, y), stroke = (float)bytes[4 * i + 3] / 255, p[3], q[3], gray, mean;
            for (k = 0; k < 3; ++k) p[k] = source[k * PIXELS + i];
            mean = (p[0] + p[1] + p[2]) / 3;
            for (k = 0; k < 3; ++k) q[k] = mean + c * (p[k] - mean) + s * (p[(k + 2) % 3] - p[(k + 1) % 3]);
            gray = 0.2126f * q[0] + 0.7152f * q[1] + 0.0722f * q[2];
            for (k = 0; k < 3; ++k) {
                float v = gray + (float)saturation * (q[k] - gray), t;
                t = gray < luma ? color[k] * gray / fmaxf(luma, 1e-3f)
                                : 1 - (1 - color[k]) * (1 - gray) / fmaxf(1 - luma, 1e-3f);
                v = gain * (v + amount * (t - v));
                v = p[k] + inside * (v - p[k]);
                v += stroke * ((float)bytes[4 * i + k] / 255 - v);
                target[k * PIXELS + i] = fminf(fmaxf(v, 0), 1);
            }
        }
    targets = matcher_aim(&the_matcher, target, NULL, &error) == MS_OK;
    to_rgba(target);
    return targets ? 0 : (int)error.status;
}

/* The material nearest to the target, into x and rgba, from material 0 of x and what the inversion network guesses;
   cost: how many pictures may be tried, 0: the better of these two. In numbers: the distance at the end, that of
   the guess, and matcher_verdict's answer. */
CALL(int, match, (double cost))
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    const char *sentence;
    double from[M];
    ms_status status;
    if (!targets) return (int)studio__refuse(&error, MS_INVALID_ARGUMENT, "there is no picture to match yet");
    memcpy(from, material, sizeof from);
    options.candidates = from;
    options.candidate_count = 1;
    options.initial_only = !(cost > 0);
    options.refine.max_cost = cost;
    status = ms_pme_match(&the_matcher.renderer, target, NULL, &options, material, picture, &result, &error);
    if (status != MS_OK) return (int)status;
    number[0] = result.rmse;
    number[1] = result.rmse_initial;
    number[2] = matcher_verdict(result.rmse, &sentence);
    to_rgba(picture);
    return 0;
}

/* -------------------------------------------------------------------------------------------------------- the files */

/* materials.mtlx of x [count], named by the lines of text, with the scores of numbers [count]; below -1e6: none. */
CALL(int, save, (int count))
{
    file_out mtlx;
    FILE *doc = file_create("materials.mtlx", &mtlx);
    const char *name = text, *problem;
    char line[48], about[80], own[64];
    int i;
    if (doc == NULL) return (int)studio__refuse(&error, MS_IO, mtlx.problem);
    materialx_begin(doc);
    for (i = 0; i < count; ++i) {
        size_t length = strcspn(name, "\n");
        snprintf(own, sizeof own, "%.*s", (int)length, name);
        name += length + (name[length] != 0);
        snprintf(about, sizeof about, "score %s", number[i] > -1e6 ? number_text(line, "%.2f", number[i]) : "unknown");
        materialx_write(doc, own, material + i * M, about);
    }
    materialx_end(doc);
    problem = file_finish(&mtlx, 1);
    return problem ? (int)studio__refuse(&error, MS_IO, problem) : 0;
}
