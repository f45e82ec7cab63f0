/* The glue between ms_pme.h and ms_nn.h: a neural renderer and inversion networks as a renderer that ms_pme_match takes.

     static matcher m;                                               it must not move while it is open
     matcher_open(&m, "renderer.safetensors", &error);               n parameters -> picture [3][size][size]
     matcher_add_inversions(&m, "networks", &error);                 pictures -> n parameters
     matcher_aim(&m, target, weight, &error);                        [3][size][size] each; weight may be NULL
     ms_pme_match(&m.renderer, target, weight, NULL, x, picture, &result, &error);
     matcher_close(&m);

   Where the renderer ends in a linear layer the objective is collapsed: an evaluation runs the layers before it and a
   small triangle, not every pixel. ms_nn.h and ms_pme.h, their implementations too, come first. POSIX, for the names of
   the files in a folder. */
#ifndef EXAMPLES_MATCHER_H
#define EXAMPLES_MATCHER_H
#include "neural.h"
#include <dirent.h>

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
    const float *target, *weight;          /* of the last aim: the caller's */
    ms_pme_function reduced;               /* what is left between picture and target, collapsed or not */
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
    ms_status status = matcher__room(&m->workspace, ms_nn_workspace_size(m->network.nn, MS_NN_JACOBIAN, 1)); /* more than a collapse needs */
    return status != MS_OK ? status : ms_nn_jacobian(m->network.nn, matcher__floats(m, x), picture, jacobian, m->workspace.data);
}

/* The pictures' own residuals, where nothing is collapsed: for the sensitivity. */
static inline ms_status matcher__plain_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const matcher *m = (const matcher *)user;
    size_t i, j, p = m->renderer.image_size, n = (size_t)m->renderer.parameter_count;
    float *picture = (float *)malloc(p * (jacobian ? n + 1 : 1) * sizeof(float)), *slopes = picture + p;
    ms_status status = picture == NULL ? MS_OUT_OF_MEMORY
                       : jacobian      ? matcher__jacobian(user, x, picture, slopes)
                                       : matcher__render(user, x, picture);
    for (i = 0; i < p && status == MS_OK; ++i) {
        double w = m->weight ? sqrt((double)m->weight[i]) : 1;
        r[i] = w > 0 ? w * ((double)picture[i] - (double)m->target[i]) : 0;
        for (j = 0; j < n && jacobian; ++j) jacobian[i * n + j] = w * (double)slopes[i * n + j];
    }
    free(picture);
    return status;
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
    if (problem) return matcher__fail(error, m->network.error.status == MS_OK ? MS_BAD_DATA : m->network.error.status, path, problem);
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
    if (i == matcher_inversions_max) return matcher__fail(error, MS_UNSUPPORTED, path, "more than 64 inversion networks");
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
        snprintf(wrong, sizeof wrong, "takes %d x %d pixels, the renderer makes %d x %d: not a multiple", s, s, size, size);
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
            if (length < 13 || length >= sizeof name[0] || strcmp(entry->d_name + length - 12, ".safetensors") != 0) continue;
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
    m->reduced.residual_count = m->renderer.image_size;
    m->reduced.residuals = matcher__plain_residuals;
    if (status != MS_OK) return MS_OK;
    m->reduced.residual_count = ms_nn_collapse_features(m->collapse) + 1;
    m->reduced.residuals = matcher__residuals;
    m->reduced.jacobian_cost = 5; /* pictures: with a value 6, as measured at 64 x 64 (`make bench FILTER=pme`) */
    m->renderer.reduced = &m->reduced;
    return matcher__room(&m->workspace, ms_nn_collapse_workspace_size(m->collapse, 1));
}

/* Once for every target, before ms_pme_match, with the same weights; both stay the caller's and must stay. Where a weight is 0 the target may be anything finite.
   Other weights than the last time cost a QR factorisation of the last layer. */
static inline ms_status matcher_aim(matcher *m, const float *target, const float *weight, ms_error *error)
{
    ms_status status = MS_OK;
    m->target = target;
    m->weight = weight;
    if (weight != NULL || !m->plain) status = matcher__collapse(m, weight, error);
    m->plain = status == MS_OK && weight == NULL;
    if (status == MS_OUT_OF_MEMORY) return matcher__fail(error, status, "objective", ms_status_string(status));
    return status == MS_OK && m->collapse ? ms_nn_collapse_target(m->collapse, target, error) : status;
}
#endif
