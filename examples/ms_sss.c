/* Subsurface scattering of a picture: the edge of a shadow on skin, which red light crosses. Writes before and after.
     cc -O2 -I. examples/ms_sss.c -o build/ms_sss -lm && build/ms_sss shadow.ppm */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 256 };
static float light[SIDE * SIDE * 3], glow[SIDE * SIDE * 3];

int main(int argc, char **argv)
{
    const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3}; /* a color, and how far light walks */
    static ms_sss_kernel kernel;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_profile *profile;
    ms_sss_frame frame;
    ms_error error;
    size_t size;
    void *workspace;
    FILE *file = argc == 2 ? fopen(argv[1], "wb") : NULL;
    int x, y, c;
    if (!file) return fprintf(stderr, "usage: ms_sss OUT.ppm\n"), 2;
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < SIDE; ++x)
            for (c = 0; c < 3; ++c) light[3 * (y * SIDE + x) + c] = hypot(x - 128, y - 128) < 80;
    if (ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, &error) != MS_OK ||
        ms_sss_kernel_make(&kernel, NULL, profile, 24, NULL, NULL, &error) != MS_OK)
        return fprintf(stderr, "ms_sss: %s\n", error.message), 1;
    ms_sss_profile_destroy(profile);
    memset(&frame, 0, sizeof frame);
    frame.width = frame.height = SIDE;
    frame.input = ms_sss_interleaved(light, 3);
    frame.output = ms_sss_interleaved(glow, 3);
    options.pixels_per_mm[0] = 8;
    size = ms_sss_filter_workspace(SIDE, SIDE, &kernel, 1, &options);
    workspace = malloc(size);
    if (!workspace || ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, &error) != MS_OK) return 1;
    free(workspace);
    printf("1 mm inside the shadow: red %.2f, green %.2f, blue %.2f of the light\n",
           (double)glow[3 * (128 * SIDE + 216)], (double)glow[3 * (128 * SIDE + 216) + 1],
           (double)glow[3 * (128 * SIDE + 216) + 2]);
    fprintf(file, "P6 %d %d 255\n", 2 * SIDE, SIDE);
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < 2 * SIDE; ++x)
            for (c = 0; c < 3; ++c) {
                double v = (double)(x < SIDE ? light : glow)[3 * (y * SIDE + x % SIDE) + c] * reflectance[c];
                fputc((int)(255 * pow(fmin(fmax(v, 0), 1), 1 / 2.2) + 0.5), file);
            }
    return fclose(file) != 0;
}
