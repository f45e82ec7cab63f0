/* The validation pictures of examples/data, for the tests and the benchmark of the networks there. Include ms_nn.h with
   its implementation first. */
#ifndef TESTS_NETWORKS_H
#define TESTS_NETWORKS_H
#include <math.h>
#include "materials.h"
#include "neural.h"

enum { NETWORKS_TILES = 64, NETWORKS_ACROSS = 8, NETWORKS_PARAMETERS = 19, NETWORKS_INVERSIONS = 9 };

/* truth [64][3][size][size]: display values of the stored tiles, averaged to size x size in linear light; malloc'd.
   The pictures' own noise is about 50 dB (128 paths a pixel, averaged), their 8 bits 59 dB. NULL: no file. */
static inline float *networks_truth(int size)
{
    image sheet;
    float *truth = (float *)malloc((size_t)NETWORKS_TILES * 3 * (size_t)size * (size_t)size * sizeof(float)), *out = truth;
    int tile, factor, t, c, x, y, i, j;
    if (truth == NULL || image_read("examples/data/materials.ppm", &sheet) != NULL) {
        free(truth);
        return NULL;
    }
    tile = sheet.width / NETWORKS_ACROSS;
    factor = tile / size;
    for (t = 0; t < NETWORKS_TILES; ++t)
        for (c = 0; c < 3; ++c)
            for (y = 0; y < size; ++y)
                for (x = 0; x < size; ++x) {
                    int left = t % NETWORKS_ACROSS * tile + x * factor, top = t / NETWORKS_ACROSS * tile + y * factor;
                    float sum = 0;
                    for (j = 0; j < factor; ++j)
                        for (i = 0; i < factor; ++i) sum += image_srgb_decode(sheet.pixels[3 * ((top + j) * sheet.width + left + i) + c]);
                    *out++ = image_srgb_encode(sum / (float)(factor * factor));
                }
    image_free(&sheet);
    return truth;
}

/* Root mean square of a - b; a is clipped to [0, 1] as it would be for display. */
static inline double networks_rmse(const float *a, const float *b, size_t n)
{
    double sum = 0;
    size_t i;
    for (i = 0; i < n; ++i) {
        double d = fmin(fmax((double)a[i], 0), 1) - (double)b[i];
        sum += d * d;
    }
    return sqrt(sum / (double)n);
}

/* dB [64] of a renderer against the stored pictures; NULL, or what went wrong (in n->error or static). The caller frees n. */
static inline const char *networks_psnr(const char *path, neural *n, double *dB)
{
    materials list;
    float *truth, *planes;
    const char *problem = neural_load(path, n);
    size_t pixels;
    int t;
    if (problem) return problem;
    pixels = ms_nn_output_size(n->nn);
    truth = networks_truth(n->size);
    planes = (float *)malloc(NETWORKS_TILES * pixels * sizeof(float));
    problem = truth == NULL || planes == NULL ? "examples/data/materials.ppm cannot be read" : NULL;
    if (problem == NULL && (materials_read("examples/data/materials.csv", NETWORKS_PARAMETERS, &list) || list.count != NETWORKS_TILES))
        problem = "examples/data/materials.csv: not 64 materials";
    if (problem == NULL) {
        neural_render(n, list.x, NETWORKS_TILES, planes);
        for (t = 0; t < NETWORKS_TILES; ++t)
            dB[t] = -20 * log10(fmax(networks_rmse(planes + (size_t)t * pixels, truth + (size_t)t * pixels, pixels), 1e-9));
        materials_free(&list);
    }
    free(truth);
    free(planes);
    return problem;
}

/* x [count][19] as the training pictures were drawn: half uniform, half sharp (mix factors 0 or 1). */
static inline void networks_materials(float *x, int count, double (*uniform)(uint64_t *state), uint64_t *state)
{
    static const int mix[3] = {7, 16, 17};
    int i, k;
    for (i = 0; i < count * NETWORKS_PARAMETERS; ++i) x[i] = (float)uniform(state);
    for (i = 0; i < count; i += 2)
        for (k = 0; k < 3; ++k) x[i * NETWORKS_PARAMETERS + mix[k]] = x[i * NETWORKS_PARAMETERS + mix[k]] < 0.5f ? 0.0f : 1.0f;
}

/* RMSE of 255 of every inversion network, [9][count], on planes [count][3][64][64]: its parameters rendered again and
   compared. guess [9][count][19] out, or NULL. NULL, or what went wrong. */
static inline const char *networks_invert(const neural *renderer, const float *planes, int count, double *rmse, float *guess, ms_error *error)
{
    size_t pixels = ms_nn_output_size(renderer->nn);
    float *x = (float *)malloc((size_t)count * NETWORKS_PARAMETERS * sizeof(float));
    float *again = (float *)malloc((size_t)count * pixels * sizeof(float));
    const char *problem = x == NULL || again == NULL ? "out of memory" : NULL;
    int k, i;
    for (k = 0; k < NETWORKS_INVERSIONS && problem == NULL; ++k) {
        char path[80];
        ms_nn *inversion;
        snprintf(path, sizeof path, "examples/data/inversion_%d.safetensors", k + 1);
        if (ms_nn_load_file(path, NULL, &inversion, error) != MS_OK) {
            problem = error->message;
            break;
        }
        if (ms_nn_input_size(inversion) != pixels || ms_nn_output_size(inversion) != NETWORKS_PARAMETERS) problem = "an inversion network of another size";
        else if (ms_nn_forward(inversion, count, planes, x, NULL) != MS_OK) problem = "out of memory";
        ms_nn_destroy(inversion);
        if (problem) break;
        neural_render(renderer, x, count, again);
        for (i = 0; i < count; ++i)
            rmse[k * count + i] = 255 * networks_rmse(again + (size_t)i * pixels, planes + (size_t)i * pixels, pixels);
        if (guess) memcpy(guess + (size_t)k * (size_t)count * NETWORKS_PARAMETERS, x, (size_t)count * NETWORKS_PARAMETERS * sizeof(float));
    }
    free(x);
    free(again);
    return problem;
}
#endif
