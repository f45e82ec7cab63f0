/* The reader of saved shares, and sums of any kind. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "tally.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const ms_mcml_layer layers[2] = {{1.4, 1, 60, 0.8, 0.05}, {1.5, 2, 20, -0.3, 0.4}};
    static const ms_mcml_tissue tissue = {1, 1, 2, layers};
    static const ms_mcml_grid grid = {0.1, 0.1, 3, 4, 2};
    const tally_run run = {&tissue, &grid, 0};
    const size_t words = size / 8 < 4096 ? size / 8 : 4096;
    int64_t sums[4096] = {0};
    ms_mcml_result result;
    ms_mcml *tally;
    size_t count;
    if (ms_mcml_create(&tissue, &grid, NULL, &tally, NULL) != MS_OK) return 0;
    ms_mcml_sums(tally, &count);
    if (words > 0) memcpy(sums, data, 8 * words);
    if (count <= 4096) ms_mcml_add(tally, sums, count, NULL);
    if (tally_add(tally, &run, data, size, NULL, NULL) == MS_OK || ms_mcml_photons(tally) > 0) {
        ms_mcml_run(tally, 0, 1, NULL);
        if (ms_mcml_results(tally, &result, NULL) == MS_OK) ms_mcml_result_destroy(&result);
    }
    ms_mcml_destroy(tally);
    return 0;
}
