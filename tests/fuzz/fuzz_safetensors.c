/* Any bytes as a safetensors file and as a network: refused or run, never a crash, a hang or a large allocation.
     clang -g -O1 -fsanitize=fuzzer,address,undefined -I. -Iexamples/engine tests/fuzz/fuzz_safetensors.c -o
   build/fuzz_safetensors -lm build/fuzz_safetensors -max_len=4096 tests/fuzz/corpus_safetensors */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "nn_shader.h"
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C"
#endif
    int
    LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What is listed can be read to its last byte, found by name, and written again. */
static void fuzz_file(const ms_nn_file *file)
{
    ms_error error;
    size_t n = ms_nn_file_tensor_count(file), i, k, written = 0;
    unsigned sum = 0;
    ms_nn_tensor copy[16];
    for (i = 0; i < n; ++i) {
        const ms_nn_tensor *t = ms_nn_file_tensor(file, i);
        for (k = 0; k < t->bytes; ++k) sum += ((const unsigned char *)t->data)[k];
        if (ms_nn_file_find(file, t->name) != t) abort();
        if (i < 16) copy[i] = *t;
    }
    if (n == 0) memset(copy, 0, sizeof copy);
    if (n <= 16 && ms_nn_file_write(copy, n, NULL, 0, NULL, 0, &written, &error) != MS_OK) abort();
    if (sum == 1u && written == 1) abort(); /* keeps the reads */
}

/* The network as an objective. */
static void fuzz_collapse(const ms_nn *nn, const float *x, const float *target)
{
    ms_nn_collapse *c;
    ms_error error;
    double *residual;
    size_t n;
    if (ms_nn_collapse_create(nn, NULL, &c, &error) != MS_OK) return;
    n = ms_nn_collapse_features(c) + 1;
    residual = (double *)malloc(n * (ms_nn_input_size(nn) + 1) * sizeof(double));
    if (ms_nn_collapse_target(c, target, &error) == MS_OK) ms_nn_collapse_residual(c, x, residual, residual + n, NULL);
    free(residual);
    ms_nn_collapse_destroy(c);
}

/* As shaders: refused, or as long as it says. */
static void fuzz_shader(const ms_nn *nn, size_t size)
{
    nn_shader s;
    nn_shader_sizes z;
    ms_error error;
    memset(&s, 0, sizeof s);
    s.steps = (int)(size / 4 % 4);
    s.language = (nn_language)(size % 5);
    if (size / 16 % 2) s.width = s.height = 2;
    for (z.steps = 1; s.step < z.steps && nn_shader_layout(nn, &s, &z, &error) == MS_OK; ++s.step) {
        size_t length = nn_shader_text(nn, &s, NULL, 0, &error);
        char *text = (char *)malloc(length + 1);
        if (text && (nn_shader_text(nn, &s, text, length + 1, &error) != length || strlen(text) != length)) abort();
        free(text);
    }
    s.step = 0;
    if (nn_shader_layout(nn, &s, &z, &error) == MS_OK && z.weight_rows < 16) {
        void *weights = malloc((size_t)z.weight_rows * NN_SHADER_WIDTH * 16);
        if (weights) nn_shader_weights(nn, size % 2 ? MS_NN_F16 : MS_NN_F32, weights, &error);
        free(weights);
    }
}

/* No block over 16 MB: a file may ask for any size. */
static void *small_alloc(void *user, size_t size)
{
    (void)user;
    return size <= 1 << 24 ? malloc(size) : NULL;
}

static void small_release(void *user, void *pointer, size_t size)
{
    (void)user;
    (void)size;
    free(pointer);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ms_nn_options options = ms_nn_defaults();
    ms_nn_file *file;
    ms_nn *nn;
    ms_error error;
    options.allocator.alloc = small_alloc;
    options.allocator.release = small_release;
    if (ms_nn_file_open(data, size, &options, &file, &error) != MS_OK) return 0;
    fuzz_file(file);
    ms_nn_file_close(file);
    if (ms_nn_load(data, size, &options, &nn, &error) != MS_OK) return 0;
    {
        size_t in = ms_nn_input_size(nn), out = ms_nn_output_size(nn), i;
        if (in < 4096 && out < 4096 && ms_nn_workspace_size(nn, MS_NN_FORWARD, 1) < 1 << 24) {
            float *x = (float *)malloc((in + 2 * out + 1) * sizeof(float)), *y = x + in, *target = y + out;
            for (i = 0; i < in; ++i) x[i] = (float)i;
            for (i = 0; i < out; ++i) target[i] = 1;
            ms_nn_forward(nn, 1, x, y, NULL);
            if (in * out < 4096 && ms_nn_workspace_size(nn, MS_NN_JACOBIAN, 1) < 1 << 24) {
                float *jacobian = (float *)malloc((in * out + 1) * sizeof(float));
                ms_nn_jacobian(nn, x, y, jacobian, NULL);
                free(jacobian);
            }
            if (in < 256 && out < 256) fuzz_collapse(nn, x, target);
            fuzz_shader(nn, size);
            free(x);
        }
    }
    ms_nn_check_weights(nn, &error);
    ms_nn_destroy(nn);
    return 0;
}
