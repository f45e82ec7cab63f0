/* Runs a network: each row of a CSV file is one input (row-major, channels first), each printed row one output.
     cc -O2 -I. examples/tools/nn_run.c -o build/nn_run -lm
     build/nn_run FILE INPUT.csv               outputs
     build/nn_run FILE INPUT.csv --vjp G.csv   input gradients for the output gradients in G, row by row */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "files.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] = "usage: nn_run FILE INPUT.csv [--vjp G.csv]\n";

/* The next row of count numbers, separated by commas or spaces. 1: read, 0: end of the text, -1: malformed. */
static int next_row(char **text, float *row, size_t count, const char *path, int line)
{
    char *p = *text + strspn(*text, " \t\r\n"), *end;
    size_t n = 0;
    if (*p == 0) return 0;
    while (*p != 0 && *p != '\n') {
        float value = strtof(p, &end);
        if (end == p || n == count) break;
        row[n++] = value;
        p = end + strspn(end, " \t\r");
        if (*p == ',') p += 1 + strspn(p + 1, " \t\r");
    }
    *text = p;
    if (n == count && (*p == 0 || *p == '\n')) return 1;
    fprintf(stderr, "%s: row %d: expected %lu numbers, read %lu\n", path, line, (unsigned long)count, (unsigned long)n);
    return -1;
}

static char *read_text(const char *path)
{
    const char *problem = "cannot read it";
    FILE *f = file_open(path, &problem);
    size_t size = 0, used = 0, got = 1;
    char *text = NULL;
    const char *begin;
    while (f != NULL && got > 0) {
        if (used + 1 >= size) {
            char *larger = (char *)realloc(text, size = 2 * size + 65536);
            if (larger == NULL) break;
            text = larger;
        }
        got = fread(text + used, 1, size - used - 1, f);
        used += got;
        text[used] = 0;
    }
    if (f != NULL && ferror(f)) got = 1;
    if (f != NULL) fclose(f);
    begin = f != NULL && got == 0 ? csv_begin(text, used, &problem) : NULL;
    if (begin == NULL) {
        fprintf(stderr, "nn_run: %s: %s\n", path, problem);
        exit(1);
    }
    memmove(text, begin, used + 1 - (size_t)(begin - text)); /* without a byte order mark */
    return text;
}

int main(int argc, char **argv)
{
    int vjp = argc == 5 && strcmp(argv[3], "--vjp") == 0, line, row = 1;
    ms_nn *nn;
    ms_error error;
    ms_status status = MS_OK;
    if (file_help(argc, argv, usage)) return file_end_stdout("nn_run");
    if (argc != 3 && !vjp) return file_usage(usage);
    if (ms_nn_load_file(argv[1], NULL, &nn, &error) != MS_OK) {
        fprintf(stderr, "%s: byte %lu: %s\n", argv[1], (unsigned long)error.position, error.message);
        return 1;
    }
    {
        size_t inputs = ms_nn_input_size(nn), outputs = ms_nn_output_size(nn), i, k, printed = vjp ? inputs : outputs;
        void *workspace = malloc(ms_nn_workspace_size(nn, vjp ? MS_NN_JACOBIAN : MS_NN_FORWARD, 1));
        float *jacobian = vjp ? (float *)malloc(inputs * outputs * sizeof(float)) : NULL;
        float *x = (float *)malloc(2 * (inputs + outputs) * sizeof(float)), *y = x + inputs, *g_y = y + outputs,
              *g_x = g_y + outputs;
        char *text = read_text(argv[2]), *text_at = text, *gradients = vjp ? read_text(argv[4]) : NULL,
             *gradients_at = gradients;
        if (workspace == NULL || x == NULL || (vjp && jacobian == NULL)) {
            fprintf(stderr, "out of memory\n");
            return 1;
        }
        for (line = 1; (row = next_row(&text_at, x, inputs, argv[2], line)) > 0; ++line) {
            if (vjp && (row = next_row(&gradients_at, g_y, outputs, argv[4], line)) <= 0) {
                if (row == 0) fprintf(stderr, "%s: fewer rows than %s\n", argv[4], argv[2]);
                row = -1;
                break;
            }
            status = vjp ? ms_nn_jacobian(nn, x, NULL, jacobian, workspace) : ms_nn_forward(nn, 1, x, y, workspace);
            if (status != MS_OK) break;
            for (i = 0; vjp && i < inputs; ++i) {
                double sum = 0;
                for (k = 0; k < outputs; ++k) sum += (double)g_y[k] * (double)jacobian[k * inputs + i];
                g_x[i] = (float)sum;
            }
            for (i = 0; i < printed; ++i) printf("%s%.9g", i ? "," : "", (double)(vjp ? g_x[i] : y[i]));
            printf("\n");
        }
        if (status != MS_OK) fprintf(stderr, "%s\n", ms_status_string(status));
        if (file_end_stdout("nn_run")) status = MS_IO;
        free(text);
        free(gradients);
        free(x);
        free(jacobian);
        free(workspace);
    }
    ms_nn_destroy(nn);
    return row < 0 || status != MS_OK;
}
