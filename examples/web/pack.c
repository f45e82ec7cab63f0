/* Networks for a page: matrices of more than 4096 values become I8 with a scale a row, the other weights F16; a sixth
   of the size of F32 at about 50 dB.  pack IN.safetensors OUT.safetensors */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };

static int fail(const char *path, const char *problem)
{
    fprintf(stderr, "pack: %s: %s\n", path, problem);
    return 1;
}

/* A matrix of F16 or F32, as floats. */
static float *floats(const ms_nn_tensor *t, size_t count)
{
    float *f = (float *)malloc(count * sizeof *f);
    size_t i;
    for (i = 0; f && i < count; ++i) {
        const unsigned char *p = (const unsigned char *)t->data + i * (t->dtype == MS_NN_F32 ? 4 : 2);
        if (t->dtype == MS_NN_F32) {
            memcpy(f + i, p, 4);
        } else { /* subnormals too */
            unsigned bits = p[0] | (unsigned)p[1] << 8, e = bits >> 10 & 31;
            double v = e ? ldexp(1024 + (bits & 1023), (int)e - 25) : ldexp(bits & 1023, -24);
            f[i] = (float)(bits >> 15 ? -v : v);
        }
    }
    return f;
}

int main(int argc, char **argv)
{
    static char scale_name[MOST][300];
    static size_t scale_shape[MOST];
    ms_nn_tensor out[2 * MOST];
    ms_nn_entry entries[MOST];
    size_t n, e, i, k, j, count = 0;
    ms_nn_file *file;
    ms_error error;
    size_t size;
    void *bytes;
    FILE *f;
    if (argc != 3) return fail("usage", "pack IN.safetensors OUT.safetensors");
    if (ms_nn_file_read(argv[1], NULL, &file, &error) != MS_OK) return fail(argv[1], error.message);
    n = ms_nn_file_tensor_count(file);
    e = ms_nn_file_entry_count(file);
    if (n > MOST || e > MOST) return fail(argv[1], "too many tensors");
    for (i = 0; i < n; ++i) {
        const ms_nn_tensor *t = ms_nn_file_tensor(file, i);
        size_t rows = t->rank == 2 ? t->shape[0] : 0, columns = t->rank == 2 ? t->shape[1] : 0;
        out[count] = *t;
        if (rows * columns > 4096 && (t->dtype == MS_NN_F32 || t->dtype == MS_NN_F16)) {
            float *weight = floats(t, rows * columns), *scale = (float *)malloc(rows * sizeof *scale);
            signed char *integer = (signed char *)malloc(rows * columns);
            if (!weight || !scale || !integer) return fail(argv[1], "out of memory");
            for (k = 0; k < rows; ++k) {
                float most = 1e-30f;
                for (j = 0; j < columns; ++j) most = fmaxf(most, fabsf(weight[k * columns + j]));
                scale[k] = most / 127;
                for (j = 0; j < columns; ++j)
                    integer[k * columns + j] = (signed char)lrintf(weight[k * columns + j] / scale[k]);
            }
            free(weight);
            out[count].dtype = MS_NN_I8;
            out[count].data = integer;
            out[count++].bytes = rows * columns;
            snprintf(scale_name[i], sizeof scale_name[i], "%s_scale", t->name);
            scale_shape[i] = rows;
            out[count].name = scale_name[i];
            out[count].dtype = MS_NN_F32;
            out[count].rank = 1;
            out[count].shape = &scale_shape[i];
            out[count].data = scale;
            out[count].bytes = rows * sizeof *scale;
        }
        ++count;
    }
    for (i = 0; i < e; ++i) entries[i] = *ms_nn_file_entry(file, i);
    if (ms_nn_file_write(out, count, entries, e, NULL, 0, &size, &error) != MS_OK) return fail(argv[2], error.message);
    bytes = malloc(size);
    if (bytes == NULL || ms_nn_file_write(out, count, entries, e, bytes, size, &size, &error) != MS_OK)
        return fail(argv[2], "out of memory");
    f = fopen(argv[2], "wb");
    if (f == NULL || fwrite(bytes, 1, size, f) != size || fclose(f) != 0) return fail(argv[2], "cannot write it");
    free(bytes);
    return 0;
}
