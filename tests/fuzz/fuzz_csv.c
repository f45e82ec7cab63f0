/* The examples' readers of CSV files, scores and materials: refused with a sentence, or finite numbers in their range.
   They take paths; here every path is the bytes, without a file. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>

static const uint8_t *fuzz_data;
static size_t fuzz_size;

static FILE *fuzz_open(const char *path, const char *mode)
{
    (void)path;
    return fuzz_size ? fmemopen((void *)(uintptr_t)fuzz_data, fuzz_size, mode) : fopen("/dev/null", mode);
}

#define fopen fuzz_open
#define stat(path, info) ((void)(path), memset((info), 0, sizeof *(info)), -1) /* no folder there */
#include "materials.h"
#include "scores.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const int parameters = (int)(size % 19) + 1;
    scores s;
    materials m;
    const char *problem;
    int i;
    fuzz_data = data;
    fuzz_size = size;
    if (scores_read("x", &s) == NULL)
        for (i = 0; i < s.n * s.m; ++i)
            if (!(s.x[i] - s.x[i] == 0) || !(s.y[i / s.m] - s.y[i / s.m] == 0)) abort();
    scores_free(&s);
    if (scores_read_table("x", &s) == NULL)
        for (i = 0; i < s.n * s.m; ++i)
            if (!(s.x[i] - s.x[i] == 0)) abort();
    scores_free(&s);
    problem = materials_read("x", parameters, &m);
    if (problem != NULL && problem[0] == 0) abort();
    for (i = 0; problem == NULL && i < m.count * parameters; ++i)
        if (!(m.x[i] >= 0 && m.x[i] <= 1)) abort();
    materials_free(&m);
    return 0;
}
