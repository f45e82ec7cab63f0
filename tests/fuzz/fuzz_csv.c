/* The examples' readers of CSV files, scores and materials: refused with a sentence, or finite numbers in their range. They
   take paths, so the bytes go through a file. */
#include "materials.h"
#include "scores.h"
#include <stdint.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[64];
    int parameters, i;
    scores s;
    materials m;
    FILE *f;
    snprintf(path, sizeof path, "build/fuzz_csv.%ld", (long)getpid());
    f = fopen(path, "wb");
    if (f == NULL || fwrite(data, 1, size, f) != size || fclose(f) != 0) abort();
    if (scores_read(path, &s) == NULL)
        for (i = 0; i < s.n * s.m; ++i)
            if (!(s.x[i] - s.x[i] == 0) || !(s.y[i / s.m] - s.y[i / s.m] == 0)) abort();
    scores_free(&s);
    for (parameters = 1; parameters < 20; parameters += 9) {
        const char *problem = materials_read(path, parameters, &m);
        if (problem != NULL && problem[0] == 0) abort();
        for (i = 0; problem == NULL && i < m.count * parameters; ++i)
            if (!(m.x[i] >= 0 && m.x[i] <= 1)) abort();
        materials_free(&m);
    }
    remove(path);
    return 0;
}
