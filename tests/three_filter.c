/* What the passes of examples/web/sss_three.js are compared with (tests/three.py):
     three_filter WIDTH HEIGHT FOV MM_PER_UNIT TAPS RADIUS_PX SHIFT_X SHIFT_Y IN OUT < materials
   IN and OUT: float RGBA by rows, depth in IN's alpha, whose last four bits are the material's index; a material is a
   line of reflectance and mean free path in mm, three of each. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    static ms_sss_kernel kernel[MS_SSS_SHADER_PROFILES_MAX];
    ms_sss_kernel_options taps = ms_sss_kernel_defaults();
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_frame frame;
    ms_sss_profile *profile;
    ms_error error;
    double r[3], path[3], d[3];
    float *pixels, *out;
    uint8_t *index;
    size_t count;
    int kernels = 0, c;
    FILE *f;
    if (argc != 11) return 2;
    memset(&frame, 0, sizeof frame);
    frame.width = atoi(argv[1]);
    frame.height = atoi(argv[2]);
    options.fov_degrees = (float)atof(argv[3]);
    options.mm_per_unit = (float)atof(argv[4]);
    taps.tap_count = atoi(argv[5]);
    count = (size_t)frame.width * (size_t)frame.height;
    pixels = (float *)malloc(16 * count);
    out = (float *)malloc(16 * count);
    index = (uint8_t *)malloc(count);
    f = fopen(argv[9], "rb");
    if (!pixels || !out || !index || !f || fread(pixels, 16, count, f) != count) return 2;
    fclose(f);
    while (kernels < MS_SSS_SHADER_PROFILES_MAX &&
           scanf("%lf %lf %lf %lf %lf %lf", r, r + 1, r + 2, path, path + 1, path + 2) == 6) {
        for (c = 0; c < 3; ++c) d[c] = ms_sss_burley_d_mm(r[c], path[c]);
        if (ms_sss_profile_from_burley(&profile, r, d, NULL, NULL) != MS_OK ||
            ms_sss_kernel_make(&kernel[kernels++], NULL, profile, atof(argv[6]), &taps, NULL, NULL) != MS_OK)
            return 2;
        ms_sss_profile_destroy(profile);
    }
    for (size_t i = 0; i < count; ++i) {
        uint32_t bits;
        memcpy(&bits, pixels + 4 * i + 3, 4);
        index[i] = (uint8_t)(bits & 15u);
    }
    frame.input = ms_sss_interleaved(pixels, 4);
    frame.output = ms_sss_interleaved(out, 4);
    frame.depth = ms_sss_map(pixels + 3, 4);
    frame.profile = index;
    if (ms_sss_filter(&frame, kernel, kernels, &options, NULL, 0, &error) != MS_OK) {
        fprintf(stderr, "three_filter: %s\n", error.message);
        return 1;
    }
    f = fopen(argv[10], "wb");
    if (!f || fwrite(out, 16, count, f) != count || fclose(f) != 0) return 2;
    free(pixels), free(out), free(index);
    return 0;
}
