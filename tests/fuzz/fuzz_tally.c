/* The reader of saved tallies. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_result result;
    ms_mcml *tally;
    options.memory_limit = 1 << 20;
    if (ms_mcml_load(data, size, &options, &tally, NULL) == MS_OK) {
        ms_mcml_run(tally, 0, 1, NULL);
        if (ms_mcml_results(tally, &result, NULL) == MS_OK) ms_mcml_result_destroy(&result);
        ms_mcml_destroy(tally);
    }
    return 0;
}
