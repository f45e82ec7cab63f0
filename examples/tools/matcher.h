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
#include <sys/time.h>

enum { matcher_inversions_max = 64 };

typedef struct matcher_block {
    void *data;
    size_t size;
} matcher_block;

/* The objective of one set of weights, collapsed. */
typedef struct matcher_objective {
    ms_nn_collapse *collapse; /* NULL: pictures are compared */
    double *light;        /* [4][features]: phi(middle), its bias, white and the target, projected on the features; or
                             NULL */
    double rest[3][3][3]; /* R of (target - bias, bias, white) of each channel, less their projections */
} matcher_objective;

typedef struct matcher {
    neural network; /* phi */
    ms_nn *inversion[matcher_inversions_max];
    char name[matcher_inversions_max][64];         /* of their files, without folder and extension */
    matcher_objective plain, weighted, *objective; /* without weights: kept; with the last weights; the present one */
    ms_pme_function reduced;                       /* the collapsed residuals */
    ms_pme_renderer renderer;
    int gains, offsets;  /* of the light: 0, 1 or 3, and 0 or 3; matcher_light sets them */
    ms_pme_renderer lit; /* made by matcher_aim: takes x, the logarithms of the gains, and the offsets */
    double lit_low[MS_PME_PARAMETERS_MAX + 6], lit_high[MS_PME_PARAMETERS_MAX + 6];
    matcher_block x, small, workspace, slopes; /* parameters as floats, the picture that an inversion network takes */
} matcher;

/* What is found with a material: pixels right and down that the target had slipped; gain phi(x) + offset of each
   channel. */
typedef struct matcher_found {
    double shift[2], gain[3], offset[3];
} matcher_found;

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
    return ms_nn_collapse_residual(m->objective->collapse, matcher__floats(m, x), r, jacobian, m->workspace.data);
}

/* --- light: gain phi(x) + offset, found with the material --- */

enum { MATCHER_ROBUST = 1, MATCHER_ALIGN = 2, MATCHER_EXPOSURE = 4, MATCHER_TINT = 8 };

/* Before matcher_aim. MATCHER_EXPOSURE: one gain, 1/8 to 8. MATCHER_TINT: a gain and an offset, -1 to 1, for each
   channel. Else: none. */
static inline void matcher_light(matcher *m, int flags)
{
    m->gains = flags & MATCHER_TINT ? 3 : flags & MATCHER_EXPOSURE ? 1 : 0;
    m->offsets = flags & MATCHER_TINT ? 3 : 0;
}

/* z [n + gains + offsets] */
static inline void matcher__light_at(const matcher *m, const double *z, double *gain, double *offset)
{
    const double *logs = z + m->renderer.parameter_count;
    int c;
    for (c = 0; c < 3; ++c) {
        gain[c] = m->gains ? exp(logs[m->gains > 1 ? c : 0]) : 1;
        offset[c] = m->offsets ? logs[m->gains + c] : 0;
    }
}

/* Derivatives of a value of channel c by gain and offset, into its row of derivatives by z. */
static inline int matcher__light_column(const matcher *m, int c)
{
    return m->renderer.parameter_count + (m->gains > 1 ? c : 0);
}

static inline ms_status matcher__lit_jacobian(void *user, const double *z, float *picture, float *jacobian)
{
    matcher *m = (matcher *)user;
    const size_t p = m->renderer.image_size, n = (size_t)m->renderer.parameter_count,
                 wide = (size_t)m->lit.parameter_count;
    double gain[3], offset[3];
    float *slopes = jacobian ? jacobian + p * (wide - n) : NULL; /* rows of n, at the end of the rows of z */
    size_t i, j;
    ms_status status = jacobian ? matcher__jacobian(m, z, picture, slopes) : matcher__render(m, z, picture);
    matcher__light_at(m, z, gain, offset);
    for (i = 0; i < p && status == MS_OK; ++i) {
        const int c = (int)(3 * i / p);
        float *row = jacobian + (jacobian ? i * wide : 0);
        for (j = 0; j < n && jacobian; ++j) row[j] = (float)gain[c] * slopes[i * n + j];
        for (j = n; j < wide && jacobian; ++j) row[j] = 0;
        if (jacobian) row[matcher__light_column(m, c)] = (float)gain[c] * picture[i];
        if (jacobian && m->offsets) row[n + (size_t)(m->gains + c)] = 1;
        picture[i] = (float)(gain[c] * (double)picture[i] + offset[c]);
    }
    return status;
}

static inline ms_status matcher__lit_render(void *user, const double *z, float *picture)
{
    return matcher__lit_jacobian(user, z, picture, NULL);
}

/* The residuals of gain phi(x) + offset - target, collapsed: with Q an orthonormal basis of the features of a channel,
     Q' (...) = gain r + (gain - 1) Q't + offset Q'1,   r = Q' (phi - t) from ms_nn_collapse_residual,
   and what is outside of Q depends on the light alone: three residuals a channel. */
static inline ms_status matcher__light_residuals(void *user, const double *z, double *r, double *jacobian)
{
    const matcher *m = (const matcher *)user;
    const matcher_objective *o = m->objective;
    size_t count = ms_nn_collapse_features(o->collapse), n = (size_t)m->renderer.parameter_count,
           wide = (size_t)m->lit.parameter_count, i, j;
    const double *white = o->light + 2 * count, *target = white + count;
    double *plain = (double *)m->slopes.data, *slopes = jacobian ? plain + count + 1 : NULL, gain[3], offset[3];
    ms_status status = matcher__residuals(user, z, plain, slopes);
    if (status != MS_OK) return status;
    matcher__light_at(m, z, gain, offset);
    if (jacobian) memset(jacobian, 0, (count + 9) * wide * sizeof(double));
    for (i = 0; i < count + 9; ++i) {
        const int outside = i >= count, c = (int)(outside ? (i - count) / 3 : i / (count / 3));
        const double *rest = o->rest[c][(i - (outside ? count : 0)) % 3];
        double *row = jacobian + (jacobian ? i * wide : 0), by_gain = outside ? rest[1] : plain[i] + target[i],
               by_offset = outside ? rest[2] : white[i];
        r[i] = outside ? rest[1] * (gain[c] - 1) + rest[2] * offset[c] - rest[0]
                       : gain[c] * plain[i] + (gain[c] - 1) * target[i] + offset[c] * white[i];
        if (jacobian == NULL) continue;
        for (j = 0; j < n && !outside; ++j) row[j] = gain[c] * slopes[i * n + j];
        row[matcher__light_column(m, c)] = gain[c] * by_gain;
        if (m->offsets) row[n + (size_t)(m->gains + c)] = by_offset;
    }
    return MS_OK;
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

static inline ms_status matcher__lit_predict(void *user, int i, const float *target, double *z)
{
    const matcher *m = (const matcher *)user;
    int j;
    for (j = m->renderer.parameter_count; j < m->lit.parameter_count; ++j) z[j] = 0;
    return matcher__predict(user, i, target, z);
}

/* The renderer with its light as further parameters. */
static inline void matcher__make_lit(matcher *m)
{
    const int n = m->renderer.parameter_count;
    int j;
    m->lit = m->renderer;
    m->lit.parameter_count = n + m->gains + m->offsets;
    m->lit.render = matcher__lit_render;
    m->lit.jacobian = matcher__lit_jacobian;
    m->lit.predict = matcher__lit_predict;
    m->lit.lower = m->lit_low;
    m->lit.upper = m->lit_high;
    for (j = 0; j < m->lit.parameter_count; ++j) {
        m->lit_high[j] = j >= n + m->gains ? 1 : j >= n ? log(8.0) : m->renderer.upper ? m->renderer.upper[j] : 1;
        m->lit_low[j] = j >= n ? -m->lit_high[j] : m->renderer.lower ? m->renderer.lower[j] : 0;
    }
}

/* --- making one --- */

static inline void matcher_close(matcher *m)
{
    int i;
    ms_nn_collapse_destroy(m->plain.collapse);
    ms_nn_collapse_destroy(m->weighted.collapse);
    free(m->plain.light);
    free(m->weighted.light);
    free(m->slopes.data);
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
    ms_nn *nn;
    int i = m->renderer.prediction_count, size = m->network.size, s, n;
    ms_status status;
    if (i == matcher_inversions_max)
        return matcher__fail(error, MS_UNSUPPORTED, path, "more than 64 inversion networks");
    status = ms_nn_load_file(path, NULL, &nn, &why);
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

/* The biases of the last layer where all three channels share them, as floats [size][size]; NULL: they do not. */
static inline const float *matcher__bias(const matcher *m)
{
    const ms_nn *nn = m->network.nn;
    const ms_nn_tensor *bias;
    char name[MS_NN_MAX_NAME + 8];
    int l = ms_nn_layer_count(nn) - 1;
    while (l > 0 && ms_nn_layer_at(nn, l).dtype == MS_NN_DTYPE_COUNT) --l;
    snprintf(name, sizeof name, "%s.bias", ms_nn_layer_at(nn, l).name);
    bias = ms_nn_file_find(ms_nn_tensors(nn), name);
    if (bias == NULL || bias->dtype != MS_NN_F32 || 3 * bias->bytes != m->renderer.image_size * sizeof(float))
        return NULL;
    return (const float *)bias->data;
}

/* Projects a picture on the features: out [features] = Q' phi(middle) - Q' picture. */
static inline ms_status matcher__project(const matcher *m, const float *picture, double *out, ms_error *error)
{
    double x[MS_PME_PARAMETERS_MAX], *r = (double *)m->slopes.data;
    int j;
    ms_status status = ms_nn_collapse_target(m->objective->collapse, picture, error);
    for (j = 0; j < m->renderer.parameter_count; ++j) x[j] = 0.5;
    if (status == MS_OK) status = matcher__residuals((void *)(uintptr_t)m, x, r, NULL);
    if (status == MS_OK) memcpy(out, r, ms_nn_collapse_features(m->objective->collapse) * sizeof(double));
    return status;
}

/* The light of the present objective: projections of bias and white once for its weights, then of the target, which is
   set; and the triangles of what is outside of the features. Leaves light NULL where the channels share no last layer.
 */
static inline ms_status matcher__light(matcher *m, const float *target, const float *weight, ms_error *error)
{
    matcher_objective *o = m->objective;
    const float *bias = matcher__bias(m);
    size_t count = ms_nn_collapse_features(o->collapse), p = m->renderer.image_size, i, k, l, c, v;
    int made = o->light == NULL;
    double *q[4];
    float *picture = m->network.planes;
    ms_status status = matcher__room(&m->slopes,
                                     (count + 1) * (size_t)(m->renderer.parameter_count + 1) * sizeof(double));
    if (bias == NULL || count % 3 != 0) return MS_OK;
    if (made) o->light = (double *)malloc(4 * count * sizeof(double));
    if (o->light == NULL || status != MS_OK) return MS_OUT_OF_MEMORY;
    for (k = 0; k < 4; ++k) q[k] = o->light + k * count;
    for (v = made ? 0 : 3; v < 4 && status == MS_OK; ++v) { /* black: gives phi(middle); bias; white; target */
        for (i = 0; i < p && v < 3; ++i) picture[i] = v == 1 ? bias[i % (p / 3)] : (float)(v / 2);
        status = matcher__project(m, v < 3 ? picture : target, q[v], error);
        for (i = 0; i < count && v > 0; ++i) q[v][i] = q[0][i] - q[v][i];
    }
    for (c = 0; c < 3 && status == MS_OK; ++c) {
        double(*a)[3] = o->rest[c], size[3];
        memset(a, 0, sizeof o->rest[c]);
        for (i = c * p / 3; i < (c + 1) * p / 3; ++i) {
            double w = weight ? (double)weight[i] : 1, b = (double)bias[i % (p / 3)], value[3];
            value[0] = (double)target[i] - b;
            value[1] = b;
            value[2] = 1;
            for (k = 0; k < 3 && w > 0; ++k)
                for (l = k; l < 3; ++l) a[k][l] += w * value[k] * value[l];
        }
        for (k = 0; k < 3; ++k) size[k] = a[k][k];
        for (i = c * count / 3; i < (c + 1) * count / 3; ++i) {
            const double value[3] = {q[3][i] - q[1][i], q[1][i], q[2][i]};
            for (k = 0; k < 3; ++k)
                for (l = k; l < 3; ++l) a[k][l] -= value[k] * value[l];
        }
        for (k = 0; k < 3; ++k) { /* Cholesky; a column within rounding of the others' span has no row of its own */
            double pivot = a[k][k] > 1e-13 * size[k] ? sqrt(a[k][k]) : 0;
            for (l = k; l < 3; ++l) a[k][l] = pivot > 0 ? a[k][l] / pivot : 0;
            for (v = k + 1; v < 3; ++v)
                for (l = v; l < 3; ++l) a[v][l] -= a[k][v] * a[k][l];
        }
    }
    return status;
}

/* Once for every target, before ms_pme_match, with the same weights. Where a weight is 0 the target may be anything
   finite. Other weights than the last time cost a QR factorization of the last layer; the one without weights is kept.
 */
static inline ms_status matcher_aim(matcher *m, const float *target, const float *weight, ms_error *error)
{
    matcher_objective *o = m->objective = weight != NULL ? &m->weighted : &m->plain;
    ms_status status = MS_OK;
    const int light = m->gains > 0;
    m->renderer.reduced = NULL;
    matcher__make_lit(m);
    if (weight != NULL || o->collapse == NULL) {
        ms_nn_collapse_destroy(o->collapse);
        free(o->light);
        memset(o, 0, sizeof *o);
        status = ms_nn_collapse_create(m->network.nn, weight, &o->collapse, error);
    }
    m->reduced.user = m;
    m->reduced.parameter_count = m->lit.parameter_count;
    m->reduced.residual_count = 0;
    if (status == MS_UNSUPPORTED) return MS_OK; /* the last layer is not linear */
    if (status == MS_OK) status = matcher__room(&m->workspace, ms_nn_collapse_workspace_size(o->collapse, 1));
    if (status == MS_OK && light) status = matcher__light(m, target, weight, error);
    if (status == MS_OK && !light) status = ms_nn_collapse_target(o->collapse, target, error);
    if (status == MS_OUT_OF_MEMORY) return matcher__fail(error, status, "objective", ms_status_string(status));
    if (status != MS_OK || (light && o->light == NULL)) return status;
    m->reduced.residuals = light ? matcher__light_residuals : matcher__residuals;
    m->reduced.residual_count = ms_nn_collapse_features(o->collapse) + (light ? 9 : 1);
    m->reduced.jacobian_cost = 5; /* pictures: with a value 6, as measured at 64 x 64 (`make bench FILTER=pme`) */
    if (light) m->lit.reduced = &m->reduced;
    else m->renderer.reduced = &m->reduced;
    return MS_OK;
}

/* --- edits that are not of the material --- */

/* How good a match is, 0 to 2, and a sentence, from its RMSE at the defaults by the shipped networks: 60 held-out
   materials end within 4.4 levels of 255 (renderer_64) and 8.8 (renderer_128), 57 of 60 within 7; 22 edits of 20
   materials within 35, a crop within 56; six pictures of other scenes at 53 to 97. */
static inline int matcher_verdict(double rmse, const char **sentence)
{
    static const char *const text[3] = {
        "as close as pictures of the renderer's own materials",
        "a part of the picture is not a material's: an edit, another light, view or shape",
        "the renderer can draw nothing like this picture; the parameters mean nothing"};
    int verdict = rmse <= 7.0 / 255 ? 0 : rmse <= 45.0 / 255 ? 1 : 2;
    *sentence = text[verdict];
    return verdict;
}

/* The share of the target's variance around its mean color that the match explains: 1 - RMSE^2 / variance; 0 or less:
   a picture of one color is as near. p values, in three planes; weight may be NULL. */
static inline double matcher_explained(const float *target, const float *weight, size_t p, double rmse)
{
    double square = 0, total = 0;
    size_t c, i;
    for (c = 0; c < 3; ++c) {
        double sum = 0, sum_square = 0, all = 0;
        for (i = c * p / 3; i < (c + 1) * p / 3; ++i) {
            double w = weight ? (double)weight[i] : 1, v = w > 0 ? (double)target[i] : 0;
            sum += w * v;
            sum_square += w * v * v;
            all += w;
        }
        if (all > 0) square += sum_square - sum * sum / all;
        total += all;
    }
    square = fmax(square / total, 1e-12); /* float rounding of a flat picture */
    return 1 - rmse * rmse / square;
}

/* How good a match is, 0 to 2, as matcher_verdict has it, but 2 where a picture of one color is as near; one sentence
   with its numbers. */
static inline int matcher_judge(const float *target, const float *weight, size_t p, double rmse, char *sentence,
                                size_t size)
{
    const double share = matcher_explained(target, weight, p, rmse);
    const char *text;
    const int verdict = matcher_verdict(rmse, &text);
    if (share > 0 || verdict == 0)
        snprintf(sentence, size, "%s (RMSE %.2f of 255; %.1f%% of what varies in the picture)", text, 255 * rmse,
                 100 * fmax(share, 0));
    else
        snprintf(sentence, size,
                 "the renderer can draw nothing like this picture: one color is as near; the parameters mean nothing "
                 "(RMSE %.2f of 255)",
                 255 * rmse);
    return share > 0 || verdict == 0 ? verdict : 2;
}

/* Do the weights hide the border of a picture? Of a material alone nobody can tell the color of its light. */
static inline int matcher_hides_surroundings(const float *weight, int size)
{
    double border = 0, all = 0;
    int c, x, y, edge = (size + 15) / 16, count = 0;
    if (weight == NULL) return 0;
    for (c = 0; c < 3; ++c)
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x) {
                double w = (double)weight[(c * size + y) * size + x];
                all += w / (3.0 * size * size);
                if (x >= edge && y >= edge && x < size - edge && y < size - edge) continue;
                border += w;
                ++count;
            }
    return border < 0.1 * all * count;
}

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

/* Seconds on the wall. */
static inline double matcher_clock(void)
{
    struct timeval t;
    gettimeofday(&t, NULL);
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* The median of count values >= 0 by bisection of their bits, which sort as they do; infinite values do not count. */
static inline double matcher__median(const float *value, size_t count)
{
    uint32_t low = 0, high = 0x7f800000u, bits;
    size_t i, below, finite = 0;
    float median;
    for (i = 0; i < count; ++i) finite += (double)value[i] < HUGE_VAL;
    while (high - low > 1 && finite > 0) {
        uint32_t middle = low + (high - low) / 2;
        for (i = below = 0; i < count; ++i) {
            memcpy(&bits, &value[i], sizeof bits);
            below += bits < middle;
        }
        if (2 * below > finite) high = middle;
        else low = middle;
    }
    memcpy(&median, &low, sizeof median);
    return (double)median;
}

/* Iteratively reweighted least squares (Huber 1981) with Tukey's biweight: each pixel's three weights times
   (1 - (e / 4.685 s)^2)^2, e the root mean square of its errors, s 1.4826 times the median of all e; 0 beyond 4.685 s.
   picture, target, weight [3][pixels]; reweighted [3][pixels] out, other memory. */
static inline void matcher_reweigh(size_t pixels, const float *picture, const float *target, const float *weight,
                                   float *reweighted)
{
    double scale;
    size_t i;
    int c;
    for (i = 0; i < pixels; ++i) { /* e; infinite where all weights are 0 */
        double sum = 0, total = 0;
        for (c = 0; c < 3; ++c) {
            size_t at = (size_t)c * pixels + i;
            double w = (double)weight[at], d = (double)picture[at] - (double)target[at];
            if (w > 0) sum += w * d * d;
            total += w;
        }
        reweighted[i] = total > 0 ? (float)sqrt(sum / total) : (float)HUGE_VAL;
    }
    scale = 4.685 * 1.4826 * matcher__median(reweighted, pixels);
    for (i = pixels; i-- > 0;) {
        double t = scale > 0 ? (double)reweighted[i] / scale : 0, factor = t < 1 ? (1 - t * t) * (1 - t * t) : 0;
        for (c = 2; c >= 0; --c) {
            size_t at = (size_t)c * pixels + i;
            reweighted[at] = (float)(factor * (double)weight[at]);
        }
    }
}

/* Each log(gain) and offset is pulled to 0 by this times its square, added to RMSE^2: it stays near 0 if the picture
   does not determine it. */
#define MATCHER__LIGHT_PULL 1e-4

/* ms_pme_match after matcher_aim, without the light's parameters in x and options. */
static inline ms_status matcher__match(const matcher *m, const ms_pme_renderer *renderer, const float *target,
                                       const float *weight, const ms_pme_match_options *options, double *x,
                                       float *picture, ms_pme_match_result *result, matcher_found *found,
                                       ms_error *error)
{
    const size_t n = (size_t)m->renderer.parameter_count, wide = (size_t)m->lit.parameter_count,
                 count = (size_t)options->candidate_count;
    ms_pme_match_options lit = *options;
    double *z, *source, *pull, *deviation, *candidates;
    size_t i, j;
    ms_status status;
    for (i = 0; i < 3; ++i) found->gain[i] = 1, found->offset[i] = 0;
    if (m->gains == 0) return ms_pme_match(renderer, target, weight, options, x, picture, result, error);
    z = (double *)calloc((count + 4) * wide, sizeof(double));
    if (z == NULL) return matcher__fail(error, MS_OUT_OF_MEMORY, "match", ms_status_string(MS_OUT_OF_MEMORY));
    source = z + wide;
    pull = source + wide;
    deviation = pull + wide;
    candidates = deviation + wide;
    for (j = 0; j < n && options->pull; ++j) source[j] = options->source[j], pull[j] = options->pull[j];
    for (j = n; j < wide; ++j) pull[j] = MATCHER__LIGHT_PULL;
    for (i = 0; i < count; ++i) memcpy(candidates + i * wide, options->candidates + i * n, n * sizeof *z);
    lit.source = source;
    lit.pull = pull;
    lit.deviation = options->deviation ? deviation : NULL;
    lit.candidates = candidates;
    status = ms_pme_match(renderer, target, weight, &lit, z, picture, result, error);
    if (status == MS_OK) {
        memcpy(x, z, n * sizeof *x);
        if (options->deviation) memcpy(options->deviation, deviation, n * sizeof *x);
        matcher__light_at(m, z, found->gain, found->offset);
    }
    free(z);
    return status;
}

/* Aims and matches: with MATCHER_ROBUST what fits badly loses its weight (Tukey), with MATCHER_ALIGN the target is
   moved to where the renderer's pictures lie, in some rounds, each from the last one's answer; with MATCHER_EXPOSURE
   and MATCHER_TINT the light is found. picture may not be NULL; found may. The result's RMSE is of what counts in the
   end. */
static inline ms_status matcher_match(matcher *m, const float *target, const float *weight,
                                      const ms_pme_match_options *options, int flags, double *x, float *picture,
                                      ms_pme_match_result *result, matcher_found *found, ms_error *error)
{
    const int rounds = flags & (MATCHER_ROBUST | MATCHER_ALIGN) ? 6 : 0;
    size_t p = m->renderer.image_size, count = (size_t)m->renderer.parameter_count;
    ms_pme_match_options again = *options;
    ms_pme_renderer renderer;
    matcher_found answer;
    float *moved = rounds ? (float *)malloc(3 * p * sizeof(float)) : NULL, *known = moved ? moved + p : NULL,
          *counted = known;
    double at[2] = {0, 0}, last[2], cost;
    int round, n = options->candidate_count;
    ms_status status;

    /* the picture as it is */
    matcher_light(m, flags);
    status = matcher_aim(m, target, weight, error);
    renderer = m->gains ? m->lit : m->renderer;
    if (status == MS_OK)
        status = matcher__match(m, &renderer, target, weight, &again, x, picture, result, &answer, error);
    if (rounds && moved == NULL && status == MS_OK)
        status = matcher__fail(error, MS_OUT_OF_MEMORY, "match", ms_status_string(MS_OUT_OF_MEMORY));

    /* moved, and without what fits badly, from the last answer */
    for (round = 0; round < rounds && status == MS_OK; ++round) {
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
        if (flags & MATCHER_ROBUST) matcher_reweigh(p / 3, picture, moved, known, counted = known + p);
        status = matcher_aim(m, moved, counted, error);
        memcpy(guesses, x, count * sizeof(double)); /* where it slipped far, the other first guesses come again */
        if (n > 0) memcpy(guesses + count, options->candidates, (size_t)n * count * sizeof(double));
        again.candidates = guesses;
        again.candidate_count = slipped ? n + 1 : 1;
        again.refine.restarts = slipped ? options->refine.restarts : 0;
        renderer = m->gains ? m->lit : m->renderer;
        if (!slipped) renderer.prediction_count = 0;
        cost = result->cost;
        if (status == MS_OK) {
            ms_pme_match_result better;
            status = matcher__match(m, &renderer, moved, counted, &again, x, picture, &better, &answer, error);
            if (status == MS_OK) {
                better.rmse_initial = result->rmse_initial;
                better.best_candidate = result->best_candidate;
                better.cost += cost;
                *result = better;
            }
        }
        free(guesses);
    }
    matcher_light(m, 0); /* of this call alone */
    memcpy(answer.shift, at, sizeof at);
    if (found && status == MS_OK) *found = answer;
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
        matcher_light(view[i], 0);
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
