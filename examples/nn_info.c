/* Prints what a network file holds, or why it is refused (exit 1).
     cc -O2 -I. examples/nn_info.c -o build/nn_info -lm
     build/nn_info FILE */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include <stdio.h>

static void print_shape(const ms_nn_shape *s)
{
    char text[80];
    int n = 0, i;
    for (i = 0; i < s->rank; ++i) n += snprintf(text + n, sizeof text - (size_t)n, "%s%lu", i ? "x" : "", (unsigned long)s->size[i]);
    printf(" %-16s", text);
}

int main(int argc, char **argv)
{
    ms_nn *nn;
    ms_error error;
    ms_nn_shape shape;
    unsigned long parameters = 0, bytes = 0, multiply_adds = 0;
    int i;
    if (argc != 2) {
        fprintf(stderr, "usage: nn_info FILE\n");
        return 1;
    }
    if (ms_nn_load_file(argv[1], NULL, &nn, &error) != MS_OK) {
        printf("%s: refused: byte %lu: %s\n", argv[1], (unsigned long)error.position, error.message);
        return 1;
    }
    printf("%-16s %-14s %-11s %-5s %-16s %12s %14s %14s\n", "layer", "name", "activation", "type", "output", "parameters", "bytes",
           "multiply-adds");
    shape = ms_nn_input_shape(nn);
    printf("%-16s %-14s %-11s %-5s", "input", "", "", "");
    print_shape(&shape);
    printf("\n");
    for (i = 0; i < ms_nn_layer_count(nn); ++i) {
        ms_nn_layer l = ms_nn_layer_at(nn, i);
        printf("%-16s %-14s %-11s %-5s", l.type, l.name, l.activation, l.dtype == MS_NN_DTYPE_COUNT ? "" : ms_nn_dtype_string(l.dtype));
        print_shape(&l.output);
        printf(" %12lu %14lu %14lu%s\n", (unsigned long)l.parameters, (unsigned long)l.bytes, (unsigned long)l.multiply_adds,
               l.folded ? "  folded" : "");
        parameters += (unsigned long)l.parameters;
        bytes += (unsigned long)l.bytes;
        multiply_adds += (unsigned long)l.multiply_adds;
    }
    printf("%-66s %12lu %14lu %14lu\n", "total", parameters, bytes, multiply_adds);
    printf("workspace of a forward run: %lu bytes; level: %s\n", (unsigned long)ms_nn_workspace_size(nn, MS_NN_FORWARD, 1),
           ms_simd_string(ms_nn_simd(nn)));
    if (ms_nn_check_weights(nn, &error) != MS_OK) printf("warning: %s\n", error.message);
    ms_nn_destroy(nn);
    return 0;
}
