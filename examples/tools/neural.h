/* A neural renderer for the examples: parameters in, pictures out. ms_nn.h, its implementation too, comes first.

     neural n;
     image sheet;
     const char *problem = neural_load("examples/data/renderer_128.safetensors", &n);   NULL: fine; otherwise a sentence
     if (!problem) problem = neural_sheet(&n, x, 64, 8, 2, &sheet);                      x [64][n.parameters]
     image_free(&sheet), neural_free(&n);

   The network takes a list of parameters and gives a square RGB picture: first all red, then all green, then all blue
   values, rows from the top, as displayed (sRGB-encoded, 0 to 1). Such planes are what networks and optimizers work on;
   neural_paste and neural_planes go from them to an image and back. */
#ifndef EXAMPLES_NEURAL_H
#define EXAMPLES_NEURAL_H
#include "image.h"

enum { NEURAL_BATCH = 48 }; /* pictures at once: the weights are read once for all of them */

typedef struct neural {
    ms_nn *nn;
    int parameters, size; /* size x size pixels */
    float *planes;        /* [NEURAL_BATCH][3][size][size] */
    void *workspace;
    ms_error error;
} neural;

static inline void neural_free(neural *n)
{
    ms_nn_destroy(n->nn);
    free(n->planes);
    free(n->workspace);
    memset(n, 0, sizeof *n);
}

/* On failure nothing needs to be freed; the sentence lives in n->error. */
static inline const char *neural_load(const char *path, neural *n)
{
    ms_nn_shape out;
    ms_error error;
    size_t outputs;
    memset(n, 0, sizeof *n);
    if (ms_nn_load_file(path, NULL, &n->nn, &n->error) != MS_OK) return n->error.message;
    out = ms_nn_output_shape(n->nn);
    outputs = ms_nn_output_size(n->nn);
    while (3 * (size_t)n->size * (size_t)n->size < outputs && n->size < 4096) ++n->size;
    memset(&error, 0, sizeof error);
    if (ms_nn_input_size(n->nn) > 1000 || 3 * (size_t)n->size * (size_t)n->size != outputs ||
        (out.rank > 1 && out.size[0] != 3))
        snprintf(error.message, sizeof error.message,
                 "turns %.0f numbers into %.0f; a renderer turns at most 1000 parameters into a square RGB picture",
                 (double)ms_nn_input_size(n->nn), (double)outputs);
    else if (ms_nn_check_weights(n->nn, &error) == MS_OK) {
        n->parameters = (int)ms_nn_input_size(n->nn);
        n->planes = (float *)malloc(NEURAL_BATCH * outputs * sizeof(float));
        n->workspace = malloc(ms_nn_workspace_size(n->nn, MS_NN_FORWARD, NEURAL_BATCH));
        if (n->planes && n->workspace) return NULL;
        snprintf(error.message, sizeof error.message, "out of memory");
    }
    neural_free(n);
    n->error = error;
    return n->error.message;
}

/* planes [count][3][size][size] of x [count][parameters], any count. */
static inline void neural_render(const neural *n, const float *x, int count, float *planes)
{
    size_t pixels = ms_nn_output_size(n->nn);
    int i, batch;
    for (i = 0; i < count; i += batch) {
        batch = count - i < NEURAL_BATCH ? count - i : (int)NEURAL_BATCH;
        ms_nn_forward(n->nn, batch, x + (size_t)i * (size_t)n->parameters, planes + (size_t)i * pixels, n->workspace);
    }
}

/* A picture of planes into an RGB image at column `left`, row `top`, clipped to [0, 1]. */
static inline void neural_paste(const float *planes, int size, image *canvas, int left, int top)
{
    int x, y, c;
    for (c = 0; c < 3; ++c)
        for (y = 0; y < size; ++y) {
            float *pixel = canvas->pixels + 3 * ((size_t)(top + y) * (size_t)canvas->width + (size_t)left) + c;
            for (x = 0; x < size; ++x, ++planes) pixel[3 * x] = *planes > 0 ? *planes < 1 ? *planes : 1 : 0;
        }
}

/* The other way: planes [3][height][width] of an RGB image. */
static inline void neural_planes(const image *im, float *planes)
{
    size_t i, pixels = (size_t)im->width * (size_t)im->height;
    int c;
    for (c = 0; c < 3; ++c)
        for (i = 0; i < pixels; ++i) *planes++ = im->pixels[3 * i + (size_t)c];
}

/* A sheet of pictures, `columns` in a row from the top left, `gap` dark pixels between and around them. One picture
   alone: count 1, columns 1, gap 0. */
static inline const char *neural_sheet(const neural *n, const float *x, int count, int columns, int gap, image *sheet)
{
    int pitch = n->size + gap, rows = (count + columns - 1) / columns, i, k, batch;
    size_t p;
    *sheet = columns < (1 << 30) / pitch - 1 && rows < (1 << 30) / pitch - 1
        ? image_new(columns * pitch + gap, rows * pitch + gap, 3)
        : image_new(0, 0, 3);
    if (sheet->pixels == NULL) return "the sheet is too large for memory";
    for (p = 0; p < image_count(sheet); ++p) sheet->pixels[p] = 0.09f;
    for (i = 0; i < count; i += batch) {
        batch = count - i < NEURAL_BATCH ? count - i : (int)NEURAL_BATCH;
        neural_render(n, x + (size_t)i * (size_t)n->parameters, batch, n->planes);
        for (k = 0; k < batch; ++k)
            neural_paste(n->planes + (size_t)k * ms_nn_output_size(n->nn), n->size, sheet,
                         gap + (i + k) % columns * pitch, gap + (i + k) / columns * pitch);
    }
    return NULL;
}
#endif
