/* The reader of .mci files; what it accepts is written back as a short .mco file where that is small. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

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
        const ms_mcml_run_spec *run = &file.runs[0];
        ms_mcml_options options = ms_mcml_defaults();
        ms_mcml_result result;
        size_t written = 0;
        options.photons = 1;
        options.memory_limit = 1 << 20;
        if (ms_mcml_simulate(&run->tissue, &run->grid, &options, &result, &error) == MS_OK) {
            ms_mcml_mco_write(run, &result, 0, drop, &written, &error);
            ms_mcml_result_destroy(&result);
        }
        ms_mcml_mci_destroy(&file);
    }
    return 0;
}
