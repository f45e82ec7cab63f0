/* Filters a lightmap in texture space: light that leaves a skin-like surface from light that arrives.

     cc -O2 -I. examples/engine/lightmap.c -o build/lightmap -lm
     build/lightmap LIGHT.pfm OUT.(pfm|png) --texels-per-mm S [--coverage MASK.pgm] [--scale MM]

   MASK is 0 where no surface uses the texel: charts do not bleed into gutters, nor gutters into charts. MM (1)
   stretches the profile. Radii from 64 texels on go through the pyramid, whose cost does not grow with them. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "../tools/image.h"

static const char usage[] =
    "usage: lightmap LIGHT.pfm OUT.(pfm|png) --texels-per-mm S [--coverage MASK.pgm] [--scale MM]\n";

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "lightmap: %s: %s\n", what, why);
    return 1;
}

static const char *value_of(int argc, char **argv, const char *name, const char *otherwise)
{
    int i;
    for (i = 3; i + 1 < argc; i += 2)
        if (strcmp(argv[i], name) == 0) return argv[i + 1];
    return otherwise;
}

int main(int argc, char **argv)
{
    const char *mask_path = value_of(argc, argv, "--coverage", NULL), *problem;
    const double texels = atof(value_of(argc, argv, "--texels-per-mm", "0")),
                 scale = atof(value_of(argc, argv, "--scale", "1"));
    const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2 * scale, 0.55 * scale, 0.35 * scale};
    ms_sss_filter_options options = ms_sss_filter_defaults();
    static ms_sss_kernel kernel;
    static ms_sss_pyramid pyramid;
    ms_sss_profile *profile = NULL;
    ms_sss_frame frame;
    ms_error error;
    ms_status status;
    image light, mask = {0, 0, 0, NULL};
    double radius[3];
    size_t size;
    void *workspace;
    int large;
    if (file_help(argc, argv, usage)) return file_end_stdout("lightmap");
    if (argc < 5 || argc % 2 == 0 || !(texels > 0) || !(scale > 0)) return file_usage(usage);
    if ((problem = image_read(argv[1], &light)) != NULL) return fail(argv[1], problem);
    if (mask_path && (problem = image_read(mask_path, &mask)) != NULL) return fail(mask_path, problem);
    if (light.channels != 3 || (mask_path && (mask.width != light.width || mask.height != light.height)))
        return fail(argv[1], "expected RGB, and a mask of the same size");

    status = ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, &error);
    if (status != MS_OK) return fail("profile", error.message);
    ms_sss_profile_radius(profile, 0.99, radius);
    large = radius[0] * texels >= 64;
    if (large) status = ms_sss_pyramid_make(&pyramid, profile, &error);
    else status = ms_sss_kernel_make(&kernel, NULL, profile, radius[0] * texels, NULL, NULL, &error);
    ms_sss_profile_destroy(profile);
    if (status != MS_OK) return fail("kernel", error.message);

    memset(&frame, 0, sizeof frame);
    frame.width = light.width;
    frame.height = light.height;
    frame.input = frame.output = ms_sss_interleaved(light.pixels, 3);
    if (mask_path) frame.strength = ms_sss_map(mask.pixels, mask.channels);
    options.pixels_per_mm[0] = (float)texels;
    size = large ? ms_sss_pyramid_workspace(light.width, light.height)
                 : ms_sss_filter_workspace(light.width, light.height, &kernel, 1, &options);
    if ((workspace = malloc(size)) == NULL) return fail(argv[1], "out of memory");
    status = large ? ms_sss_pyramid_filter(&frame, &pyramid, 1, &options, workspace, size, &error)
                   : ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, &error);
    free(workspace);
    if (status != MS_OK) return fail("filter", error.message);
    if (strlen(argv[2]) > 4 && strcmp(argv[2] + strlen(argv[2]) - 4, ".pfm") != 0) image_to_srgb(&light);
    if ((problem = image_write(argv[2], &light)) != NULL) return fail(argv[2], problem);
    printf("radius %.1f texels, %s\n", radius[0] * texels, large ? "pyramid" : "7 taps");
    image_free(&light);
    image_free(&mask);
    return file_end_stdout("lightmap");
}
