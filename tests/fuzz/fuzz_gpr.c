/* ms_gpr_load on hostile bytes: refused with a status, or a model that predicts numbers.
     clang -g -O1 -fsanitize=fuzzer,address,undefined -I. tests/fuzz/fuzz_gpr.c -o build/fuzz_gpr -lm
     build/fuzz_gpr -max_len=4096 build/fuzz_gpr_corpus tests/fuzz/corpus_gpr */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C"
#endif
    int
    LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void use(ms_gpr *gp)
{
    static const double zero[512] = {0};
    double mean, variance;
    if (ms_gpr_dimensions(gp) <= 512 && ms_gpr_predict(gp, zero, 1, &mean, &variance, NULL) == MS_OK &&
        !(variance >= 0))
        abort();
    ms_gpr_destroy(gp);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ms_error error;
    ms_gpr *gp;
    ms_status status = ms_gpr_load(data, size, NULL, &gp, &error);
    if (status == MS_OK) use(gp);
    else if (gp != NULL || error.message[0] == 0) abort();
    if (size >= 32) { /* the same with a checksum that fits, so that mutations reach the values */
        uint8_t *copy = (uint8_t *)malloc(size);
        memcpy(copy, data, size);
        ms_gpr__put(copy + size - 8, 8, ms_gpr__checksum(copy, size - 8));
        if (ms_gpr_load(copy, size, NULL, &gp, NULL) == MS_OK) use(gp);
        free(copy);
    }
    return 0;
}
