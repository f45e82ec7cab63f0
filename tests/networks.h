/* The validation pictures of examples/data, for the tests and the benchmark of the networks there. Include ms_nn.h with
   its implementation first. */
#ifndef TESTS_NETWORKS_H
#define TESTS_NETWORKS_H
#include <math.h>
#include "materials.h"
#include "neural.h"

enum { NETWORKS_TILES = 64, NETWORKS_ACROSS = 8, NETWORKS_PARAMETERS = 19, NETWORKS_INVERSIONS = 9 };

/* truth [64][3][size][size]: display values of the stored tiles; malloc'd. size 128 or 64: highlights are clipped after
   the average, so one does not follow from the other. The pictures' own noise is about 50 dB, their 8 bits 59 dB. NULL:
   no such file. */
static inline float *networks_truth(int size)
{
    image sheet;
    float *truth = (float *)malloc((size_t)NETWORKS_TILES * 3 * (size_t)size * (size_t)size * sizeof(float)),
          *out = truth;
    int t, c, x, y;
    if (truth == NULL ||
        image_read(size == 64 ? "examples/data/materials_64.png" : "examples/data/materials.png", &sheet) != NULL) {
        free(truth);
        return NULL;
    }
    if (sheet.width != NETWORKS_ACROSS * size || sheet.height != NETWORKS_TILES / NETWORKS_ACROSS * size ||
        sheet.channels != 3) {
        image_free(&sheet);
        free(truth);
        return NULL;
    }
    for (t = 0; t < NETWORKS_TILES; ++t)
        for (c = 0; c < 3; ++c)
            for (y = 0; y < size; ++y)
                for (x = 0; x < size; ++x)
                    *out++ =
                        sheet.pixels
                            [3 * ((t / NETWORKS_ACROSS * size + y) * sheet.width + t % NETWORKS_ACROSS * size + x) + c];
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

/* dB [64] of a renderer against the stored pictures; NULL, or what went wrong (in n->error or static). The caller frees
   n. */
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
    problem = truth == NULL || planes == NULL ? "examples/data/materials.png cannot be read" : NULL;
    if (problem == NULL &&
        (materials_read("examples/data/materials.csv", NETWORKS_PARAMETERS, &list) || list.count != NETWORKS_TILES))
        problem = "examples/data/materials.csv: not 64 materials";
    if (problem == NULL) {
        neural_render(n, list.x, NETWORKS_TILES, planes);
        for (t = 0; t < NETWORKS_TILES; ++t)
            dB[t] = -20 *
                log10(fmax(networks_rmse(planes + (size_t)t * pixels, truth + (size_t)t * pixels, pixels), 1e-9));
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
        for (k = 0; k < 3; ++k)
            x[i * NETWORKS_PARAMETERS + mix[k]] = x[i * NETWORKS_PARAMETERS + mix[k]] < 0.5f ? 0.0f : 1.0f;
}

/* RMSE of 255 of every inversion network, [9][count], on planes [count][3][64][64]: its parameters rendered again and
   compared. guess [9][count][19] out, or NULL. NULL, or what went wrong. */
static inline const char *networks_invert(const neural *renderer, const float *planes, int count, double *rmse,
                                          float *guess, ms_error *error)
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
        if (ms_nn_input_size(inversion) != pixels || ms_nn_output_size(inversion) != NETWORKS_PARAMETERS)
            problem = "an inversion network of another size";
        else if (ms_nn_forward(inversion, count, planes, x, NULL) != MS_OK) problem = "out of memory";
        ms_nn_destroy(inversion);
        if (problem) break;
        neural_render(renderer, x, count, again);
        for (i = 0; i < count; ++i)
            rmse[k * count + i] = 255 * networks_rmse(again + (size_t)i * pixels, planes + (size_t)i * pixels, pixels);
        if (guess)
            memcpy(guess + (size_t)k * (size_t)count * NETWORKS_PARAMETERS, x,
                   (size_t)count * NETWORKS_PARAMETERS * sizeof(float));
    }
    free(x);
    free(again);
    return problem;
}
#endif
