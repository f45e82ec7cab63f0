/* The reader of .mci files: what it accepts makes a simulation, and some are written back as an .mco file without
   photons. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int drop(void *user, const char *text, size_t size)
{
    *(size_t *)user += size;
    return text == NULL;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ms_mcml_mci file;
    ms_error error;
    if (ms_mcml_mci_read((const char *)data, size, NULL, &file, &error) == MS_OK) {
        ms_mcml_options options = ms_mcml_defaults();
        int i;
        options.memory_limit = 1 << 16;
        for (i = 0; i < file.run_count && i < 3; ++i) { /* what was read is what a run takes: made, not simulated */
            const ms_mcml_run_spec *run = &file.runs[i];
            ms_mcml *tally = NULL;
            ms_mcml_result result;
            size_t written = 0;
            if (run->photons == 0 || run->line == 0 || run->tissue.layer_count < 1) abort();
            if (ms_mcml_create(&run->tissue, &run->grid, &options, &tally, &error) != MS_OK) continue;
            if (size % 64 == 0 &&
                ms_mcml_results(tally, &result, &error) == MS_OK) { /* some of them written back, empty */
                ms_mcml_mco_write(run, &result, 0, drop, &written, &error);
                ms_mcml_result_destroy(&result);
            }
            ms_mcml_destroy(tally);
        }
        ms_mcml_mci_destroy(&file);
    }
    return 0;
}
