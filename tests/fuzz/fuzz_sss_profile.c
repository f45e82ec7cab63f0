/* profile_from_csv of examples/tools/profile_csv.h; what it lets through has values that are finite and not negative at
 * every distance. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "profile_csv.h"
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const double r[5] = {0, 0.01, 1, 30, 1e9};
    ms_sss_profile *profile;
    ms_error error;
    if (profile_from_csv(&profile, (const char *)data, size, &error) == MS_OK) {
        double value[3], disc[3], total[3];
        int i, c;
        ms_sss_profile_reflectance(profile, total);
        for (i = 0; i < 5; ++i) {
            ms_sss_profile_value(profile, r[i], value);
            ms_sss_profile_disc(profile, r[i], disc);
            for (c = 0; c < 3; ++c)
                if (!(value[c] >= 0) || !(disc[c] >= 0) || !(total[c] >= 0)) abort();
        }
    }
    ms_sss_profile_destroy(profile);
    return 0;
}
