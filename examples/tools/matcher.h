/* The glue between ms_pme.h and ms_nn.h: a neural renderer and inversion networks as a renderer that ms_pme_match
   takes.

     static matcher m;                                               it must not move while it is open
     matcher_open(&m, "renderer.safetensors", &error);               n parameters -> picture [3][size][size]
     matcher_add_inversions(&m, "networks", &error);                 pictures -> n parameters
     matcher_aim(&m, target, weight, &error);                        [3][size][size] each; weight may be NULL
     ms_pme_match(&m.renderer, target, weight, NULL, x, picture, &result, &error);
     matcher_close(&m);

   matcher_match does the last two but one for pictures with parts that no material explains, or that slipped;
   matcher_views stacks several pictures of one material. Where the renderer ends in a linear layer the objective is
   collapsed: an evaluation runs the layers before it and a small triangle, not every pixel. ms_nn.h and ms_pme.h, their
   implementations too, come first. POSIX, for the names of the files in a folder. */
#ifndef EXAMPLES_MATCHER_H
#define EXAMPLES_MATCHER_H
#include "neural.h"
#include <dirent.h>
#include <math.h>

enum { matcher_inversions_max = 64 };

typedef struct matcher_block {
    void *data;
    size_t size;
} matcher_block;

typedef struct matcher {
    neural network; /* phi */
    ms_nn *inversion[matcher_inversions_max];
    char name[matcher_inversions_max][64]; /* of their files, without folder and extension */
    ms_nn_collapse *collapse;              /* NULL: pictures are compared as they are */
    int plain;                             /* non-zero: it is made for weights of 1 */
    ms_pme_function reduced;               /* what is left between picture and target, collapsed */
    ms_pme_renderer renderer;
    matcher_block x, small, workspace; /* parameters as floats, the picture that an inversion network takes */
} matcher;

/* What went wrong with a file; returns status. */
static inline ms_status matcher__fail(ms_error *error, ms_status status, const char *path, const char *sentence)
{
    if (error == NULL) return status;
    error->status = status;
    error->position = 0;
    snprintf(error->message, sizeof error->message, "%.100s: %.130s", path, sentence);
    return status;
}

/* Makes a block at least that large; what it held is lost. */
static inline ms_status matcher__room(matcher_block *block, size_t size)
{
    if (size <= block->size) return MS_OK;
    free(block->data);
    block->data = size < (size_t)-1 ? malloc(size) : NULL;
    block->size = block->data != NULL ? size : 0;
    return block->data != NULL ? MS_OK : MS_OUT_OF_MEMORY;
}

/* --- what ms_pme.h calls: phi(x), its Jacobian, the collapsed residuals, the inversion networks --- */

static inline float *matcher__floats(const matcher *m, const double *x)
{
    float *copy = (float *)m->x.data;
    int j;
    for (j = 0; j < m->renderer.parameter_count; ++j) copy[j] = (float)x[j];
    return copy;
}

static inline ms_status matcher__render(void *user, const double *x, float *picture)
{
    const matcher *m = (const matcher *)user;
    return ms_nn_forward(m->network.nn, 1, matcher__floats(m, x), picture, m->network.workspace);
}

static inline ms_status matcher__jacobian(void *user, const double *x, float *picture, float *jacobian)
{
    matcher *m = (matcher *)user;
    ms_status status = matcher__room(
        &m->workspace, ms_nn_workspace_size(m->network.nn, MS_NN_JACOBIAN, 1)); /* more than a collapse needs */
    return status != MS_OK ? status
                           : ms_nn_jacobian(m->network.nn, matcher__floats(m, x), picture, jacobian, m->workspace.data);
}

static inline ms_status matcher__residuals(void *user, const double *x, double *r, double *jacobian)
{
    const matcher *m = (const matcher *)user;
    return ms_nn_collapse_residual(m->collapse, matcher__floats(m, x), r, jacobian, m->workspace.data);
}

/* The side s of the square pictures [3][s][s] that a shape holds; 0: it holds something else. */
static inline int matcher__side(ms_nn_shape shape)
{
    size_t count = shape.size[0], s = 1;
    int i;
    for (i = 1; i < shape.rank; ++i) count *= shape.size[i];
    while (s < 8192 && 3 * s * s < count) ++s;
    if ((shape.rank > 1 && shape.size[0] != 3) || (shape.rank == 3 && shape.size[1] != s)) return 0;
    return 3 * s * s == count ? (int)s : 0;
}

/* phi^-1_(i): means over boxes bring the target to the network's size; where that is larger, pixels repeat. */
static inline ms_status matcher__predict(void *user, int i, const float *target, double *x)
{
    const matcher *m = (const matcher *)user;
    int size = m->network.size, s = matcher__side(ms_nn_input_shape(m->inversion[i])), box = size > s ? size / s : 1;
    int c, row, column, u, v, j;
    float *small = (float *)m->small.data, *answer = (float *)m->x.data;
    ms_status status;
    for (c = 0; c < 3; ++c)
        for (row = 0; row < s; ++row)
            for (column = 0; column < s; ++column) {
                const float *from = target + (c * size + row * size / s) * size + column * size / s;
                float sum = 0;
                for (u = 0; u < box; ++u)
                    for (v = 0; v < box; ++v) sum += from[u * size + v];
                small[(c * s + row) * s + column] = sum / (float)(box * box);
            }
    status = ms_nn_forward(m->inversion[i], 1, small, answer, m->workspace.data);
    for (j = 0; j < m->renderer.parameter_count; ++j) x[j] = (double)answer[j];
    return status;
}

/* --- making one --- */

static inline void matcher_close(matcher *m)
{
    int i;
    ms_nn_collapse_destroy(m->collapse);
    for (i = 0; i < m->renderer.prediction_count; ++i) ms_nn_destroy(m->inversion[i]);
    neural_free(&m->network);
    free(m->workspace.data);
    free(m->small.data);
    free(m->x.data);
    memset(m, 0, sizeof *m);
}

/* On failure there is nothing to close. */
static inline ms_status matcher_open(matcher *m, const char *path, ms_error *error)
{
    const char *problem;
    memset(m, 0, sizeof *m);
    problem = neural_load(path, &m->network);
    if (problem)
        return matcher__fail(error, m->network.error.status == MS_OK ? MS_BAD_DATA : m->network.error.status, path,
                             problem);
    m->renderer.user = m;
    m->renderer.parameter_count = m->network.parameters;
    m->renderer.image_size = ms_nn_output_size(m->network.nn);
    m->renderer.render = matcher__render;
    m->renderer.jacobian = matcher__jacobian;
    if (matcher__room(&m->x, (size_t)m->network.parameters * sizeof(float)) == MS_OK) return MS_OK;
    matcher_close(m);
    return matcher__fail(error, MS_OUT_OF_MEMORY, path, ms_status_string(MS_OUT_OF_MEMORY));
}

/* One inversion network more; its pictures and the renderer's are multiples of each other. */
static inline ms_status matcher_add_inversion(matcher *m, const char *path, ms_error *error)
{
    const char *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    char wrong[160] = "";
    ms_error why;
    ms_nn_options options;
    ms_nn *nn;
    int i = m->renderer.prediction_count, size = m->network.size, s, n;
    ms_status status;
    if (i == matcher_inversions_max)
        return matcher__fail(error, MS_UNSUPPORTED, path, "more than 64 inversion networks");
    options = ms_nn_defaults();
    options.copy = 1;
    status = ms_nn_load_file(path, &options, &nn, &why);
    if (status != MS_OK) return matcher__fail(error, status, path, why.message);
    s = matcher__side(ms_nn_input_shape(nn));
    n = (int)ms_nn_output_size(nn);
    status = MS_BAD_DATA;
    if (s == 0) {
        snprintf(wrong, sizeof wrong, "no inversion network: that takes a square picture of 3 channels");
    } else if (size % s != 0 && s % size != 0) {
        snprintf(wrong, sizeof wrong, "takes %d x %d pixels, the renderer makes %d x %d: not a multiple", s, s, size,
                 size);
    } else if (n != m->renderer.parameter_count) {
        snprintf(wrong, sizeof wrong, "predicts %d parameters, the renderer has %d", n, m->renderer.parameter_count);
    } else {
        status = matcher__room(&m->small, (size_t)(3 * s * s) * sizeof(float));
        if (status == MS_OK) status = matcher__room(&m->workspace, ms_nn_workspace_size(nn, MS_NN_FORWARD, 1));
        snprintf(wrong, sizeof wrong, "%s", ms_status_string(status));
    }
    if (status != MS_OK) {
        ms_nn_destroy(nn);
        return matcher__fail(error, status, path, wrong);
    }
    snprintf(m->name[i], sizeof m->name[i], "%.*s", (int)strcspn(base, "."), base);
    m->inversion[i] = nn;
    m->renderer.predict = matcher__predict;
    m->renderer.prediction_count = i + 1;
    return MS_OK;
}

/* Every inversion*.safetensors of a folder in the order of their names; where there is none, every *.safetensors. */
static inline ms_status matcher_add_inversions(matcher *m, const char *folder, ms_error *error)
{
    char name[matcher_inversions_max][200], path[600];
    int count = 0, any, i, k;
    ms_status status = MS_OK;
    for (any = 0; any < 2 && count == 0; ++any) {
        DIR *list = opendir(folder);
        struct dirent *entry;
        if (list == NULL) return matcher__fail(error, MS_IO, folder, "cannot open the folder");
        while ((entry = readdir(list)) != NULL) {
            size_t length = strlen(entry->d_name);
            if (length < 13 || length >= sizeof name[0] || strcmp(entry->d_name + length - 12, ".safetensors") != 0)
                continue;
            if ((!any && strncmp(entry->d_name, "inversion", 9) != 0) || count == matcher_inversions_max) continue;
            for (i = count++; i > 0 && strcmp(name[i - 1], entry->d_name) > 0; --i) strcpy(name[i], name[i - 1]);
            strcpy(name[i], entry->d_name);
        }
        closedir(list);
    }
    if (count == 0) return matcher__fail(error, MS_IO, folder, "no *.safetensors in the folder");
    for (k = 0; k < count && status == MS_OK; ++k) {
        snprintf(path, sizeof path, "%.390s/%.199s", folder, name[k]);
        status = matcher_add_inversion(m, path, error);
    }
    return status;
}

/* The objective for these weights, collapsed where the last layer is linear. */
static inline ms_status matcher__collapse(matcher *m, const float *weight, ms_error *error)
{
    ms_status status;
    m->renderer.reduced = NULL;
    ms_nn_collapse_destroy(m->collapse);
    m->collapse = NULL;
    status = ms_nn_collapse_create(m->network.nn, weight, &m->collapse, error);
    if (status != MS_OK && status != MS_UNSUPPORTED) return status;
    m->reduced.user = m;
    m->reduced.parameter_count = m->renderer.parameter_count;
    if (status != MS_OK) return MS_OK;
    m->reduced.residual_count = ms_nn_collapse_features(m->collapse) + 1;
    m->reduced.residuals = matcher__residuals;
    m->reduced.jacobian_cost = 5; /* pictures: with a value 6, as measured at 64 x 64 (`make bench FILTER=pme`) */
    m->renderer.reduced = &m->reduced;
    return matcher__room(&m->workspace, ms_nn_collapse_workspace_size(m->collapse, 1));
}

/* Once for every target, before ms_pme_match, with the same weights. Where a weight is 0 the target may be anything
   finite. Other weights than the last time cost a QR factorisation of the last layer. */
static inline ms_status matcher_aim(matcher *m, const float *target, const float *weight, ms_error *error)
{
    ms_status status = MS_OK;
    if (weight != NULL || !m->plain) status = matcher__collapse(m, weight, error);
    m->plain = status == MS_OK && weight == NULL;
    if (status == MS_OUT_OF_MEMORY) return matcher__fail(error, status, "objective", ms_status_string(status));
    return status == MS_OK && m->collapse ? ms_nn_collapse_target(m->collapse, target, error) : status;
}

/* --- edits that are not of the material --- */

enum { MATCHER_ROBUST = 1, MATCHER_ALIGN = 2 };

/* Plane value at (x, y) by cubics through the pixels (Keys 1981, a = -1/2), which blur less than lines; outside *inside
   becomes 0. */
static inline float matcher__sample(const float *plane, int size, double x, double y, int *inside)
{
    int column = (int)floor(x), row = (int)floor(y), i, k;
    float u = (float)(x - column), v = (float)(y - row), wide[4], high[4], sum = 0;
    if (x < 0 || y < 0 || x > size - 1 || y > size - 1) return (float)(*inside = 0);
    if (!(u > 0) && !(v > 0)) return plane[row * size + column];
    for (k = 0; k < 2; ++k) {
        float t = k ? v : u, *w = k ? high : wide;
        w[0] = t * (-0.5f + t * (1 - 0.5f * t));
        w[1] = 1 + t * t * (-2.5f + 1.5f * t);
        w[2] = t * (0.5f + t * (2 - 1.5f * t));
        w[3] = t * t * (-0.5f + 0.5f * t);
    }
    for (i = 0; i < 4; ++i)
        for (k = 0; k < 4; ++k) {
            int r = row - 1 + i, c = column - 1 + k;
            r = r < 0 ? 0 : r < size ? r : size - 1;
            c = c < 0 ? 0 : c < size ? c : size - 1;
            sum += high[i] * wide[k] * plane[r * size + c];
        }
    return sum;
}

/* The weight of the pixel nearest to (x, y) of a plane; 1 for no weights, 0 outside. */
static inline float matcher__weight(const float *plane, int size, double x, double y)
{
    if (x < 0 || y < 0 || x > size - 1 || y > size - 1) return 0;
    return plane ? plane[(int)(y + 0.5) * size + (int)(x + 0.5)] : 1;
}

/* target as if it had never slipped by shift, and its weights, 0 where nothing is known. NULL weight: all 1. */
static inline void matcher__shift(const float *target, const float *weight, int size, const double *shift, float *moved,
                                  float *moved_weight)
{
    int c, x, y;
    for (c = 0; c < 3; ++c)
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x) {
                int at = (c * size + y) * size + x, inside = 1;
                moved[at] = matcher__sample(target + c * size * size, size, x + shift[0], y + shift[1], &inside);
                moved_weight[at] = matcher__weight(weight ? weight + c * size * size : NULL, size, x + shift[0],
                                                   y + shift[1]);
            }
}

/* Mean square of picture and target moved by shift, and, unless NULL, the step of Gauss and Newton towards less. */
static inline double matcher__shift_error(const float *picture, const float *target, const float *weight, int size,
                                          const double *shift, double *step)
{
    double sum = 0, total = 0, xx = 0, xy = 0, yy = 0, ex = 0, ey = 0, det;
    int c, x, y, jump = step ? 1 : 1 + size / 64;
    for (c = 0; c < 3; ++c)
        for (y = 1; y + 1 < size; y += jump)
            for (x = 1; x + 1 < size; x += jump) {
                const float *plane = target + c * size * size, *p = picture + (c * size + y) * size + x;
                int inside = 1;
                double t = (double)matcher__sample(plane, size, x + shift[0], y + shift[1], &inside), w, e, gx, gy;
                w = (double)matcher__weight(weight ? weight + c * size * size : NULL, size, x + shift[0], y + shift[1]);
                e = t - (double)*p;
                sum += w * e * e;
                total += w;
                gx = 0.5 *
                    (double)(p[1] -
                             p[-1]); /* near the answer the picture's slope is the target's, and it has no noise */
                gy = 0.5 * (double)(p[size] - p[-size]);
                xx += w * gx * gx;
                xy += w * gx * gy;
                yy += w * gy * gy;
                ex += w * gx * e;
                ey += w * gy * e;
            }
    det = xx * yy - xy * xy;
    if (step) step[0] = det > 1e-6 * xx * yy ? -(yy * ex - xy * ey) / det : 0;
    if (step) step[1] = det > 1e-6 * xx * yy ? -(xx * ey - xy * ex) / det : 0;
    return total > 0 ? sum / total : 1e30;
}

/* How far the target lies right of the picture and below it: the best whole pixels, up to an eighth of the width, then
   fractions. again: from where shift stands. */
static inline void matcher_find_shift(const float *picture, const float *target, const float *weight, int size,
                                      int again, double *shift)
{
    double least = 1e30, trial[2], step[2], error;
    int x, y, reach = size / 8, i;
    for (y = -reach; y <= reach && !again; ++y)
        for (x = -reach; x <= reach; ++x) {
            trial[0] = x;
            trial[1] = y;
            error = matcher__shift_error(picture, target, weight, size, trial, NULL);
            if (error < least) {
                least = error;
                shift[0] = x;
                shift[1] = y;
            }
        }
    least = matcher__shift_error(picture, target, weight, size, shift, step);
    for (i = 0; i < 10 && fabs(step[0]) + fabs(step[1]) > 1e-3; ++i) {
        double next[2];
        trial[0] = shift[0] + step[0];
        trial[1] = shift[1] + step[1];
        error = matcher__shift_error(picture, target, weight, size, trial, next);
        if (!(error < least) || fabs(trial[0]) > reach + 1 || fabs(trial[1]) > reach + 1) {
            step[0] *= 0.5;
            step[1] *= 0.5;
            continue;
        }
        least = error;
        memcpy(shift, trial, sizeof trial);
        memcpy(step, next, sizeof next);
    }
}

/* Aims and matches: with MATCHER_ROBUST what fits badly loses its weight (Tukey), with MATCHER_ALIGN the target is
   moved to where the renderer's pictures lie, in some rounds, each from the last one's answer. picture may not be NULL.
   shift [2] out: pixels right and down that the target had slipped; may be NULL. The result's RMSE is of what counts in
   the end. */
static inline ms_status matcher_match(matcher *m, const float *target, const float *weight,
                                      const ms_pme_match_options *options, int flags, double *x, float *picture,
                                      ms_pme_match_result *result, double *shift, ms_error *error)
{
    size_t p = m->renderer.image_size, count = (size_t)m->renderer.parameter_count, i;
    ms_pme_match_options again = *options;
    ms_pme_renderer alone;
    float *moved = flags ? (float *)malloc(3 * p * sizeof(float)) : NULL, *known = moved ? moved + p : NULL,
          *counted = known;
    double at[2] = {0, 0}, last[2], cost;
    int round, n = options->candidate_count;
    ms_status status = matcher_aim(m, target, weight, error);
    if (status == MS_OK) status = ms_pme_match(&m->renderer, target, weight, options, x, picture, result, error);
    if (flags && moved == NULL && status == MS_OK)
        status = matcher__fail(error, MS_OUT_OF_MEMORY, "match", ms_status_string(MS_OUT_OF_MEMORY));
    for (round = 0; round < 6 && flags && status == MS_OK; ++round) {
        double *guesses = (double *)malloc((size_t)(n + 1) * count * sizeof(double));
        int slipped;
        memcpy(last, at, sizeof at);
        if (flags & MATCHER_ALIGN) matcher_find_shift(picture, target, weight, m->network.size, round > 0, at);
        slipped = fabs(at[0] - last[0]) + fabs(at[1] - last[1]) > 0.02;
        if (guesses == NULL || (round > 0 && !(flags & MATCHER_ROBUST) && !slipped)) {
            free(guesses);
            break;
        }
        matcher__shift(target, weight, m->network.size, at, moved, known);
        if (flags & MATCHER_ROBUST)
            status = ms_pme_reweigh(MS_PME_TUKEY, 0, p, 3, picture, moved, known, counted = known + p, NULL, error);
        if (status == MS_OK) status = matcher_aim(m, moved, counted, error);
        memcpy(guesses, x,
               count * sizeof(double)); /* where it slipped far, the other first guesses have another chance */
        if (n > 0) memcpy(guesses + count, options->candidates, (size_t)n * count * sizeof(double));
        again.candidates = guesses;
        again.candidate_count = slipped ? n + 1 : 1;
        again.refine.restarts = slipped ? options->refine.restarts : 0;
        alone = m->renderer;
        if (!slipped) alone.prediction_count = 0;
        cost = result->cost;
        if (status == MS_OK) {
            ms_pme_match_result better;
            status = ms_pme_match(&alone, moved, counted, &again, x, picture, &better, error);
            if (status == MS_OK) {
                better.rmse_initial = result->rmse_initial;
                better.best_candidate = result->best_candidate;
                better.cost += cost;
                *result = better;
            }
        }
        free(guesses);
    }
    for (i = 0; i < 2 && shift; ++i) shift[i] = at[i];
    free(moved);
    return status;
}

/* --- several pictures of one material: views, lights, sizes, each by its own renderer --- */

enum { matcher_views_max = 8 };

/* Their pictures follow each other in the target, the weights and the answer; the first one's inversion networks guess.
     matcher_views v;                    matchers that are open, of equal parameters
     matcher_views_aim(&v, view, count, target, weight, &error);
     ms_pme_match(&v.renderer, target, weight, NULL, x, picture, &result, &error); */
typedef struct matcher_views {
    matcher *view[matcher_views_max];
    int count;
    ms_pme_function reduced;
    ms_pme_renderer renderer;
} matcher_views;

static inline ms_status matcher__views_jacobian(void *user, const double *x, float *picture, float *jacobian)
{
    const matcher_views *v = (const matcher_views *)user;
    size_t at = 0, n = (size_t)v->renderer.parameter_count;
    ms_status status = MS_OK;
    int i;
    for (i = 0; i < v->count && status == MS_OK; at += v->view[i++]->renderer.image_size)
        status = jacobian ? matcher__jacobian(v->view[i], x, picture + at, jacobian + at * n)
                          : matcher__render(v->view[i], x, picture + at);
    return status;
}

static inline ms_status matcher__views_render(void *user, const double *x, float *picture)
{
    return matcher__views_jacobian(user, x, picture, NULL);
}

static inline ms_status matcher__views_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const matcher_views *v = (const matcher_views *)user;
    size_t at = 0, n = (size_t)v->renderer.parameter_count;
    ms_status status = MS_OK;
    int i;
    for (i = 0; i < v->count && status == MS_OK; at += v->view[i++]->reduced.residual_count)
        status = matcher__residuals(v->view[i], x, r + at, jacobian ? jacobian + at * n : NULL);
    return status;
}

static inline ms_status matcher__views_predict(void *user, int i, const float *target, double *x)
{
    return matcher__predict(((matcher_views *)user)->view[0], i, target, x);
}

static inline ms_status matcher_views_aim(matcher_views *v, matcher *const *view, int count, const float *target,
                                          const float *weight, ms_error *error)
{
    ms_status status = MS_OK;
    size_t at = 0;
    int i, collapsed = 1;
    memset(v, 0, sizeof *v);
    if (count < 1 || count > matcher_views_max)
        return matcher__fail(error, MS_INVALID_ARGUMENT, "views", "from 1 to 8");
    for (i = 0; i < count && status == MS_OK; at += view[i++]->renderer.image_size) {
        if (view[i]->renderer.parameter_count != view[0]->renderer.parameter_count)
            return matcher__fail(error, MS_INVALID_ARGUMENT, "views", "renderers of other parameters");
        v->view[i] = view[i];
        status = matcher_aim(view[i], target + at, weight ? weight + at : NULL, error);
        collapsed = collapsed && view[i]->renderer.reduced != NULL;
        v->reduced.residual_count += view[i]->reduced.residual_count;
        v->reduced.jacobian_cost = view[i]->reduced.jacobian_cost;
    }
    v->count = count;
    v->reduced.user = v->renderer.user = v;
    v->reduced.parameter_count = v->renderer.parameter_count = view[0]->renderer.parameter_count;
    v->reduced.residuals = matcher__views_residuals;
    v->renderer.lower = view[0]->renderer.lower;
    v->renderer.upper = view[0]->renderer.upper;
    v->renderer.image_size = at;
    v->renderer.render = matcher__views_render;
    v->renderer.jacobian = matcher__views_jacobian;
    v->renderer.prediction_count = view[0]->renderer.prediction_count;
    v->renderer.predict = matcher__views_predict;
    if (collapsed) v->renderer.reduced = &v->reduced;
    return status;
}
#endif
