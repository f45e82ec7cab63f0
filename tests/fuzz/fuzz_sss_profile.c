/* ms_sss_profile_from_csv, and a kernel from whatever it lets through. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static ms_sss_kernel kernel;
    ms_sss_profile *profile;
    ms_error error;
    if (ms_sss_profile_from_csv(&profile, (const char *)data, size, NULL, &error) == MS_OK) {
        ms_sss_kernel_options options = ms_sss_kernel_defaults();
        ms_sss_errors errors;
        double line[3];
        options.model = MS_SSS_PREINTEGRATED;
        options.placement = MS_SSS_QUANTILE;
        ms_sss_profile_line(profile, 1, line);
        if (size < 4096) (void)ms_sss_kernel_make(&kernel, &errors, profile, 4, &options, NULL, &error);
    }
    ms_sss_profile_destroy(profile);
    return 0;
}
