/* The reader of .mci files: what it accepts makes a simulation, and some are written back as an .mco file without
   photons. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "../../examples/tools/mci.h"
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    mci_file file = {0, NULL, NULL};
    ms_error error;
    if (mci_read((const char *)data, size, &file, &error) == MS_OK) {
        ms_mcml_options options = ms_mcml_defaults();
        int i;
        options.memory_limit = 1 << 16;
        for (i = 0; i < file.run_count && i < 3; ++i) { /* what was read is what a run takes: made, not simulated */
            const mci_run *run = &file.runs[i];
            ms_mcml *tally = NULL;
            ms_mcml_result result;
            if (run->photons == 0 || run->line == 0 || run->tissue.layer_count < 1) abort();
            if (ms_mcml_create(&run->tissue, &run->grid, &options, &tally, &error) != MS_OK) continue;
            if (size % 64 == 0 &&
                ms_mcml_results(tally, &result, &error) == MS_OK) { /* some of them written back, empty */
                FILE *f = tmpfile();
                if (f) mco_print(f, run, &result, NULL, 0), fclose(f);
                ms_mcml_result_destroy(&result);
            }
            ms_mcml_destroy(tally);
        }
        mci_destroy(&file);
    }
    return 0;
}
