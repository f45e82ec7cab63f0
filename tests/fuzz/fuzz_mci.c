/* The reader of .mci files: what it accepts makes a simulation, and some are written back as an .mco file without
   photons. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "../../examples/tools/mci.h"
#include <stdlib.h>

#if defined(__wasi__)
#define tmpfile() NULL /* it has none */
#endif

/* A tally without photons has no results; one photon is counted, and not traced. */
static int of_one_photon(ms_mcml *tally, const ms_mcml_grid *grid)
{
    size_t count;
    int64_t *sums;
    int made;
    ms_mcml_sums(tally, &count);
    sums = (int64_t *)calloc(count, sizeof *sums);
    if (sums) sums[4 * (size_t)grid->nr * (size_t)grid->na + 2] = 1; /* behind [2][nr][na][2] and [2] */
    made = sums && ms_mcml_add(tally, sums, count, NULL) == MS_OK && ms_mcml_photons(tally) == 1;
    free(sums);
    return made;
}

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
            if (size % 16 == 0 && of_one_photon(tally, &run->grid) &&
                ms_mcml_results(tally, &result, &error) ==
                    MS_OK) { /* some of them written back, of a photon that is nowhere */
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
