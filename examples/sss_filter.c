/* Filters a rendered irradiance picture so that light seems to scatter below the surface:

     build/sss_filter IRRADIANCE.pfm DEPTH.pfm OUT.(pfm|png) --material NAME|--profile CSV [--taps N]
                      [--mm-per-unit S] [--fov DEG|--ortho HEIGHT] [--strength S]

   IRRADIANCE: linear light that arrives, before the surface's color, without specular reflection. DEPTH: distance along
   the viewing axis in scene units; 0, negative and non-finite values mark pixels that take no part. A PFM result holds
   the light that leaves, to be multiplied by the surface's color; a PNG is clamped to [0, 1] and sRGB-encoded. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "image.h"

static const char usage[] =
    "usage: sss_filter IRRADIANCE.pfm DEPTH.pfm OUT.(pfm|png) --material NAME|--profile CSV [options]\n"
    "  --material NAME    one of the 11 materials of build/profile --list, such as skin1\n"
    "  --profile CSV      lines of r_mm,R,G,B in 1/mm^2, as build/profile prints them\n"
    "  --taps N           samples of each of the two passes, odd, 3 to 257 (17)\n"
    "  --mm-per-unit S    millimetres in a unit of the depth (1)\n"
    "  --fov DEG          perspective, full vertical angle (45)\n"
    "  --ortho HEIGHT     orthographic, units from top to bottom\n"
    "  --strength S       0 none to 1 full (1)\n";

static int fail(int code, const char *what, const char *why)
{
    fprintf(stderr, "sss_filter: %s: %s\n", what, why);
    return code;
}

/* A number in [low, high] and nothing behind it. */
static int number(const char *text, double low, double high, double *out)
{
    char *end;
    *out = strtod(text, &end);
    return end != text && *end == 0 && *out >= low && *out <= high;
}

/* The diffusion profile of a material, without noise: from optical parameters by the deterministic solver. */
static ms_status profile_of_material(const char *name, ms_sss_profile **profile, ms_error *error)
{
    const ms_mcml_material *material = ms_mcml_find_material(name);
    ms_mcml_medium medium[3];
    ms_mcml_profile rings;
    const double *rd[3];
    ms_status status;
    int c;
    if (material == NULL) {
        snprintf(error->message, sizeof error->message, "no such material; build/profile --list names them");
        return MS_INVALID_ARGUMENT;
    }
    for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(material, c);
    status = ms_mcml_profile_make(&rings, medium, 3, NULL, error);
    if (status != MS_OK) return status;
    for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
    status = ms_sss_profile_from_rings(profile, rings.rings, rings.edge_mm, rd, 1, NULL, error);
    ms_mcml_profile_destroy(&rings);
    return status;
}

static ms_status profile_of_file(const char *path, ms_sss_profile **profile, ms_error *error)
{
    image__bytes text;
    const char *problem;
    ms_status status = MS_IO;
    memset(&text, 0, sizeof text);
    problem = image__load(path, &text);
    if (problem)
        snprintf(error->message, sizeof error->message, "%s", problem);
    else
        status = ms_sss_profile_from_csv(profile, (const char *)text.data, text.size, NULL, error);
    free(text.data);
    return status;
}

int main(int argc, char **argv)
{
    const char *path[3] = {NULL, NULL, NULL}, *material = NULL, *csv = NULL, *problem;
    double taps = 17, mm_per_unit = 1, fov = 45, ortho = 0, strength = 1, reach[3], radius_mm = 0, nearest = HUGE_VAL;
    int i, paths = 0, perspective = 0, pixel_count;
    image input, depth, output;
    ms_error error;
    ms_sss_profile *profile = NULL;
    ms_sss_kernel_options design = ms_sss_kernel_defaults();
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_frame frame;
    static ms_sss_kernel kernel;
    size_t workspace_size;
    void *workspace;

    for (i = 1; i < argc; ++i) {
        const char *name = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        int known = 1, good = 1;
        if (name[0] != '-' || name[1] != '-') {
            if (paths == 3) return fail(2, name, "a fourth file name is not expected");
            path[paths++] = name;
            continue;
        }
        if (strcmp(name, "--help") == 0) return fputs(usage, stdout) < 0;
        if (strcmp(name, "--material") == 0)
            material = value;
        else if (strcmp(name, "--profile") == 0)
            csv = value;
        else if (strcmp(name, "--taps") == 0)
            good = value && number(value, 3, MS_SSS_TAPS_MAX, &taps) && fmod(taps, 2) == 1;
        else if (strcmp(name, "--mm-per-unit") == 0)
            good = value && number(value, 1e-9, 1e9, &mm_per_unit);
        else if (strcmp(name, "--fov") == 0)
            good = perspective = value && number(value, 0.01, 179.9, &fov);
        else if (strcmp(name, "--ortho") == 0)
            good = value && number(value, 1e-9, 1e9, &ortho);
        else if (strcmp(name, "--strength") == 0)
            good = value && number(value, 0, 1, &strength);
        else
            known = 0;
        if (!known) return fail(2, name, "unknown option; --help lists them");
        if (value == NULL) return fail(2, name, "a value is expected behind it");
        if (!good) return fail(2, name, "its value is malformed or out of range; --help lists the ranges");
        ++i;
    }
    if (paths < 3 || (material == NULL) == (csv == NULL) || (perspective && ortho > 0)) {
        fputs(usage, stderr);
        return fail(2, "arguments",
                    paths < 3                  ? "three file names are expected"
                    : perspective && ortho > 0 ? "--fov and --ortho exclude each other"
                                               : "one of --material and --profile is expected");
    }
    if (!image__has_extension(path[2], ".pfm") && !image__has_extension(path[2], ".png"))
        return fail(2, path[2], "the result's name should end in .pfm or .png");

    if ((problem = image_read(path[0], &input)) != NULL) return fail(1, path[0], problem);
    if ((problem = image_read(path[1], &depth)) != NULL) return fail(1, path[1], problem);
    if (input.channels != 3) return fail(1, path[0], "three channels (RGB) are expected");
    if (depth.channels != 1) return fail(1, path[1], "one channel is expected");
    if (depth.width != input.width || depth.height != input.height)
        return fail(1, path[1], "its size differs from the irradiance's");

    memset(&error, 0, sizeof error);
    if ((material ? profile_of_material(material, &profile, &error) : profile_of_file(csv, &profile, &error)) !=
        MS_OK) {
        if (error.position)
            fprintf(stderr, "sss_filter: %s:%lu: %s\n", csv, (unsigned long)error.position, error.message);
        else
            fail(1, material ? material : csv, error.message);
        return 1;
    }

    pixel_count = depth.width * depth.height; /* the kernel is designed for the nearest pixel, where it is largest */
    for (i = 0; i < pixel_count; ++i)
        if (depth.pixels[i] > 0 && (double)depth.pixels[i] < nearest) nearest = (double)depth.pixels[i];
    ms_sss_profile_radius(profile, 0.99, reach);
    for (i = 0; i < 3; ++i) radius_mm = reach[i] > radius_mm ? reach[i] : radius_mm;
    design.model = MS_SSS_PREINTEGRATED;
    design.tap_count = (int)taps;
    design.placement = taps <= 33 ? MS_SSS_OPTIMISED : MS_SSS_QUANTILE;
    {
        double height_mm = mm_per_unit * (ortho > 0 ? ortho : 2 * tan(fov * 3.14159265358979 / 360) * nearest);
        double radius_px = nearest < HUGE_VAL ? radius_mm / height_mm * depth.height : 1;
        if (ms_sss_kernel_make(&kernel, NULL, profile, radius_px, &design, NULL, &error) != MS_OK)
            return fail(1, "kernel", error.message);
    }
    ms_sss_profile_destroy(profile);

    output = image_new(input.width, input.height, 3);
    memset(&frame, 0, sizeof frame);
    frame.width = input.width;
    frame.height = input.height;
    frame.input = ms_sss_interleaved(input.pixels, 3, 0);
    frame.output = ms_sss_interleaved(output.pixels, 3, 0);
    frame.depth = ms_sss_map(depth.pixels, 1, 0);
    if (ortho > 0)
        options.ortho_height = (float)ortho;
    else
        options.fov_degrees = (float)fov;
    options.mm_per_unit = (float)mm_per_unit;
    options.fade = (float)(1 - strength);
    workspace_size = ms_sss_filter_workspace(frame.width, frame.height, &kernel, 1, &options);
    workspace = malloc(workspace_size);
    if (output.pixels == NULL || workspace == NULL) return fail(1, path[2], "out of memory");
    if (ms_sss_filter(&frame, &kernel, 1, &options, workspace, workspace_size, &error) != MS_OK)
        return fail(1, path[0], error.message);
    if (image__has_extension(path[2], ".png")) image_to_srgb(&output);
    if ((problem = image_write(path[2], &output)) != NULL) return fail(1, path[2], problem);
    free(workspace);
    image_free(&input);
    image_free(&depth);
    image_free(&output);
    return 0;
}
