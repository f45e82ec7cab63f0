/* Prints what a network file holds, or why it is refused (exit 1).
     cc -O2 -I. examples/tools/nn_info.c -o build/nn_info -lm
     build/nn_info FILE */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "files.h"
#include <stdio.h>

static const char usage[] = "usage: nn_info FILE\n";

static void print_shape(const ms_nn_shape *s)
{
    char text[80];
    int n = 0, i;
    for (i = 0; i < s->rank; ++i)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%lu", i ? "x" : "", (unsigned long)s->size[i]);
    printf(" %-16s", text);
}

/* A safetensors file without a layer list: its tensors. */
static void print_tensors(const ms_nn_file *file)
{
    size_t i;
    int d;
    for (i = 0; i < ms_nn_file_tensor_count(file); ++i) {
        const ms_nn_tensor *t = ms_nn_file_tensor(file, i);
        printf("%-32s %-8s %14lu bytes  [", t->name, ms_nn_dtype_string(t->dtype), (unsigned long)t->bytes);
        for (d = 0; d < t->rank; ++d) printf("%s%lu", d ? "," : "", (unsigned long)t->shape[d]);
        printf("]\n");
    }
    printf("%lu tensors; no layer list (ms_nn_layers): not a network\n", (unsigned long)ms_nn_file_tensor_count(file));
}

static void print_network(const ms_nn *nn)
{
    unsigned long parameters = 0, bytes = 0, multiply_adds = 0;
    ms_nn_shape shape = ms_nn_input_shape(nn);
    ms_error error;
    int i;
    printf("%-16s %-14s %-11s %-5s %-16s %12s %14s %14s\n", "layer", "name", "activation", "type", "output",
           "parameters", "bytes", "multiply-adds");
    printf("%-16s %-14s %-11s %-5s", "input", "", "", "");
    print_shape(&shape);
    printf("\n");
    for (i = 0; i < ms_nn_layer_count(nn); ++i) {
        ms_nn_layer l = ms_nn_layer_at(nn, i);
        printf("%-16s %-14s %-11s %-5s", l.type, l.name, l.activation,
               l.dtype == MS_NN_DTYPE_COUNT ? "" : ms_nn_dtype_string(l.dtype));
        print_shape(&l.output);
        printf(" %12lu %14lu %14lu\n", (unsigned long)l.parameters, (unsigned long)l.bytes,
               (unsigned long)l.multiply_adds);
        parameters += (unsigned long)l.parameters;
        bytes += (unsigned long)l.bytes;
        multiply_adds += (unsigned long)l.multiply_adds;
    }
    printf("%-66s %12lu %14lu %14lu\n", "total", parameters, bytes, multiply_adds);
    printf("workspace of a forward run: %lu bytes; level: %s\n",
           (unsigned long)ms_nn_workspace_size(nn, MS_NN_FORWARD, 1), ms_simd_string(ms_nn_simd(nn)));
    if (ms_nn_check_weights(nn, &error) != MS_OK) printf("warning: %s\n", error.message);
}

int main(int argc, char **argv)
{
    ms_nn_file *file = NULL;
    ms_nn *nn = NULL;
    ms_error error;
    ms_status status;
    if (file_help(argc, argv, usage)) return file_end_stdout("nn_info");
    if (argc != 2) return file_usage(usage);
    status = ms_nn_file_read(argv[1], NULL, &file, &error);
    if (status == MS_OK && ms_nn_file_metadata(file, "ms_nn_layers") == NULL) print_tensors(file);
    else if (status == MS_OK && (status = ms_nn_load_file(argv[1], NULL, &nn, &error)) == MS_OK) print_network(nn);
    if (status != MS_OK) printf("%s: refused: byte %lu: %s\n", argv[1], (unsigned long)error.position, error.message);
    if (file_end_stdout("nn_info")) status = MS_IO;
    ms_nn_destroy(nn);
    ms_nn_file_close(file);
    return status != MS_OK;
}
