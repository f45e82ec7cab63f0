/* Filters a rendered irradiance picture so that light seems to scatter below the surface:

     cc -O2 -I. examples/tools/sss_filter.c -o build/sss_filter -lm
     build/sss_filter IRRADIANCE.pfm DEPTH.pfm OUT.(pfm|png) --material NAME|--profile CSV
                      [--method M] [--model M] [--taps N] [--mm-per-unit S] [--fov DEG|--ortho HEIGHT] [--strength S]
                      [--back IRRADIANCE.pfm --back-depth DEPTH.pfm]

   IRRADIANCE: linear light that arrives, before the surface's color, without specular reflection. DEPTH: distance along
   the viewing axis in scene units; 0, negative and non-finite values mark pixels that take no part. The back layer,
   drawn with front faces culled, brings the light of lamps behind thin parts. A PFM result holds the light that leaves,
   to be multiplied by the surface's color; a PNG is clamped to [0, 1] and sRGB-encoded. Which method it took is
   printed. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "../engine/compose.h"
#include "choose.h"
#include "gather.h"
#include "image.h"
#include "profile_csv.h"

static const char usage[] =
    "usage: sss_filter IRRADIANCE.pfm DEPTH.pfm OUT.(pfm|png) --material NAME|--profile CSV [options]\n"
    "  --material NAME    one of the 11 materials of build/profile --list, such as skin1\n"
    "  --profile CSV      lines of r_mm,R,G,B in 1/mm^2, as build/profile prints them\n"
    "  --method M         taps: two passes; pyramid; gather: from every pixel, in space;\n"
    "                     auto (auto): gather, in large pictures the pyramid or taps\n"
    "  --model M          of the taps: image, preintegrated, residual, gaussians, guided, artist, slice (image)\n"
    "  --taps N           samples of each of the two passes, odd, 3 to 257 (as many as show no bands)\n"
    "  --mm-per-unit S    millimeters in a unit of the depth (1; has to be said where that makes the light cover half of\n"
    "                     the picture)\n"
    "  --fov DEG          perspective, full vertical angle (45)\n"
    "  --ortho HEIGHT     orthographic, units from top to bottom\n"
    "  --strength S       0 none to 1 full (1)\n"
    "  --back IRRADIANCE.pfm --back-depth DEPTH.pfm    what lies first behind each pixel; then it gathers\n";

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
    if (problem) snprintf(error->message, sizeof error->message, "%s", problem);
    else status = profile_from_csv(profile, (const char *)text.data, text.size, error);
    free(text.data);
    return status;
}

static const struct {
    const char *name;
    ms_sss_model model;
} models[] = {{"image", MS_SSS_IMAGE_OPTIMAL}, {"preintegrated", MS_SSS_PREINTEGRATED},
              {"residual", MS_SSS_RESIDUAL},   {"gaussians", MS_SSS_GAUSSIANS},
              {"guided", MS_SSS_GUIDED},       {"artist", MS_SSS_ARTIST},
              {"slice", MS_SSS_SLICE}};
enum { MODELS = sizeof models / sizeof models[0] };

typedef enum method { AUTO, TAPS, PYRAMID, GATHER, METHODS } method;
static const char *const method_names[METHODS] = {"auto", "taps", "pyramid", "gather"};
static const int gather_pixels = 600000; /* up to which a gather takes seconds */
static const double taps_pixels =
    10; /* up to this radius taps are nearer to the profile than the pyramid on textures */

typedef struct settings {
    int method, model;                              /* model -1: not said */
    const char *path[3], *material, *csv;           /* irradiance, depth, result; one of the other two is NULL */
    const char *back[2];                            /* irradiance, depth; both or neither NULL */
    double taps, mm_per_unit, fov, ortho, strength; /* taps 0: not said; ortho 0: perspective */
} settings;

/* What has to be released, however the program ends. */
typedef struct job {
    image input, depth, output, back[2]; /* back: irradiance, depth */
    ms_sss_profile *profile;
    void *workspace;
} job;

/* 0, or the exit code after saying what is wrong. */
static int parse(int argc, char **argv, settings *s)
{
    int i, paths = 0, perspective = 0;
    memset(s, 0, sizeof *s);
    s->model = -1;
    s->fov = 45;
    s->strength = 1;
    for (i = 1; i < argc; ++i) {
        const char *name = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        int known = 1, good = 1;
        if (name[0] != '-' || name[1] != '-') {
            if (paths == 3) return fail(2, name, "a fourth file name is not expected");
            s->path[paths++] = name;
            continue;
        }
        if (strcmp(name, "--material") == 0) s->material = value;
        else if (strcmp(name, "--profile") == 0) s->csv = value;
        else if (strcmp(name, "--taps") == 0)
            good = value && number(value, 3, MS_SSS_TAPS_MAX, &s->taps) && fmod(s->taps, 2) == 1;
        else if (strcmp(name, "--method") == 0) {
            for (s->method = 0; s->method < METHODS && value && strcmp(value, method_names[s->method]) != 0;
                 ++s->method) {}
            good = s->method < METHODS;
        } else if (strcmp(name, "--model") == 0) {
            for (s->model = 0; s->model < MODELS && value && strcmp(value, models[s->model].name) != 0; ++s->model) {}
            good = s->model < MODELS;
        } else if (strcmp(name, "--mm-per-unit") == 0) good = value && number(value, 1e-9, 1e9, &s->mm_per_unit);
        else if (strcmp(name, "--fov") == 0) good = perspective = value && number(value, 0.01, 179.9, &s->fov);
        else if (strcmp(name, "--ortho") == 0) good = value && number(value, 1e-9, 1e9, &s->ortho);
        else if (strcmp(name, "--strength") == 0) good = value && number(value, 0, 1, &s->strength);
        else if (strcmp(name, "--back") == 0) s->back[0] = value;
        else if (strcmp(name, "--back-depth") == 0) s->back[1] = value;
        else known = 0;
        if (!known) return fail(2, name, "unknown option; --help lists them");
        if (value == NULL) return fail(2, name, "a value is expected behind it");
        if (!good) return fail(2, name, "its value is malformed or out of range; --help lists the ranges");
        ++i;
    }
    if (paths < 3) {
        fail(2, "arguments", "three file names are expected");
        return file_usage(usage);
    }
    if (s->method > TAPS && (s->taps > 0 || s->model >= 0))
        return fail(2, method_names[s->method], "--taps and --model belong to the method taps");
    if ((s->back[0] == NULL) != (s->back[1] == NULL))
        return fail(2, "arguments", "--back and --back-depth are expected together");
    if (s->back[0] && (s->taps > 0 || s->model >= 0 || (s->method != AUTO && s->method != GATHER)))
        return fail(2, "--back", "a back layer belongs to the method gather");
    if (s->back[0]) s->method = GATHER;
    if (s->method == AUTO && (s->taps > 0 || s->model >= 0)) s->method = TAPS;
    if ((s->material == NULL) == (s->csv == NULL))
        return fail(2, "arguments", "one of --material and --profile is expected");
    if (perspective && s->ortho > 0) return fail(2, "arguments", "--fov and --ortho exclude each other");
    if (!image__has_extension(s->path[2], ".pfm") && !image__has_extension(s->path[2], ".png"))
        return fail(2, s->path[2], "the result's name should end in .pfm or .png");
    return 0;
}

/* A picture of `channels` channels and the irradiance's size; 0, or the exit code after saying what is wrong. */
static int read_picture(const job *j, const char *path, int channels, image *out)
{
    const char *problem = image_read(path, out);
    if (problem) return fail(1, path, problem);
    if (out->channels != channels)
        return fail(1, path, channels == 3 ? "three channels (RGB) are expected" : "one channel is expected");
    if (out->width != j->input.width || out->height != j->input.height)
        return fail(1, path, "its size differs from the irradiance's");
    return 0;
}

/* Pixels that 99% of the light span where the object is nearest; 0: no pixel takes part. */
static double radius_px(const settings *s, const job *j)
{
    double reach[3], radius_mm = 0, nearest = HUGE_VAL, height_mm;
    int i, pixel_count = j->depth.width * j->depth.height;
    for (i = 0; i < pixel_count; ++i)
        if (j->depth.pixels[i] > 0 && (double)j->depth.pixels[i] < nearest) nearest = (double)j->depth.pixels[i];
    ms_sss_profile_radius(j->profile, 0.99, reach);
    for (i = 0; i < 3; ++i) radius_mm = reach[i] > radius_mm ? reach[i] : radius_mm;
    height_mm = (s->mm_per_unit > 0 ? s->mm_per_unit : 1) *
        (s->ortho > 0 ? s->ortho : 2 * tan(s->fov * 3.14159265358979 / 360) * nearest);
    return nearest < HUGE_VAL ? radius_mm / height_mm * j->depth.height : 0;
}

/* Is the mean over the object of the light's radius, which is `radius` where it is nearest, above half of the picture?
 */
static int covers_half(const settings *s, const job *j, double radius)
{
    const int pixel_count = j->depth.width * j->depth.height;
    const double side = j->depth.width > j->depth.height ? j->depth.width : j->depth.height;
    double nearest = HUGE_VAL, sum = 0;
    int i, count = 0;
    for (i = 0; i < pixel_count; ++i)
        if (j->depth.pixels[i] > 0 && (double)j->depth.pixels[i] < nearest) nearest = (double)j->depth.pixels[i];
    for (i = 0; i < pixel_count; ++i) {
        const double z = (double)j->depth.pixels[i], here = s->ortho > 0 ? radius : radius * nearest / z;
        if (!(z > 0) || !(z < HUGE_VAL)) continue;
        sum += here < side ? here : side;
        ++count;
    }
    return sum > 0.5 * side * count;
}

static ms_status make_kernel(const settings *s, const job *j, double radius, ms_sss_kernel *kernel, ms_error *error)
{
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    ms_sss_designer *designer;
    ms_status status;
    if (s->taps > 0 || s->model > 0) {
        options.model = models[s->model > 0 ? s->model : 0].model;
        options.tap_count = s->taps > 0 ? (int)s->taps : 17;
        options.placement = options.tap_count <= 33 ? MS_SSS_OPTIMIZED : MS_SSS_QUANTILE;
        return ms_sss_kernel_make(kernel, NULL, j->profile, radius, &options, NULL, error);
    }
    status = ms_sss_designer_create(&designer, j->profile, radius, NULL, error);
    if (status != MS_OK) return status;
    status = choose_kernel(kernel, NULL, designer, 0.1, 33, NULL, error);
    ms_sss_designer_destroy(designer);
    return status == MS_NOT_CONVERGED ? MS_OK : status; /* it then holds the best */
}

static int run(const settings *s, job *j)
{
    static ms_sss_kernel kernel;
    static ms_sss_pyramid pyramid;
    const char *problem;
    double radius;
    int way = s->method, i, count = 0;
    ms_error error;
    ms_status status;
    ms_sss_frame frame;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    gather_back back;
    size_t size;

    if (read_picture(j, s->path[0], 3, &j->input) || read_picture(j, s->path[1], 1, &j->depth)) return 1;
    if (s->back[0] && (read_picture(j, s->back[0], 3, &j->back[0]) || read_picture(j, s->back[1], 1, &j->back[1])))
        return 1;

    memset(&error, 0, sizeof error);
    status = s->material ? profile_of_material(s->material, &j->profile, &error)
                         : profile_of_file(s->csv, &j->profile, &error);
    if (status != MS_OK && error.position)
        fprintf(stderr, "sss_filter: %s:%lu: %s\n", s->csv, (unsigned long)error.position, error.message);
    if (status != MS_OK) return error.position ? 1 : fail(1, s->material ? s->material : s->csv, error.message);
    radius = radius_px(s, j);
    for (i = 0; i < j->depth.width * j->depth.height; ++i) count += j->depth.pixels[i] > 0;
    if (way == AUTO && radius > 0.5 && count <= gather_pixels) way = GATHER;
    if (way == GATHER && !(s->mm_per_unit > 0) && covers_half(s, j, radius)) /* as ms_sss_filter does */
        return fail(1, s->path[1],
                    "the light covers half of the picture: --mm-per-unit (mm_per_unit) is needed, 1000 where the depth "
                    "is in meters, 1 to confirm millimeters");
    if (way == AUTO) way = radius > taps_pixels ? PYRAMID : TAPS;
    status = way == TAPS ? make_kernel(s, j, radius > 0 ? radius : 1, &kernel, &error)
        : way == PYRAMID ? ms_sss_pyramid_make(&pyramid, j->profile, &error)
                         : MS_OK;
    if (status != MS_OK) return fail(1, "kernel", error.message);

    j->output = image_new(j->input.width, j->input.height, 3);
    memset(&frame, 0, sizeof frame);
    frame.width = j->input.width;
    frame.height = j->input.height;
    frame.input = ms_sss_interleaved(j->input.pixels, 3);
    frame.output = ms_sss_interleaved(j->output.pixels, 3);
    frame.depth = ms_sss_map(j->depth.pixels, 1);
    options.ortho_height = (float)s->ortho;
    options.fov_degrees = s->ortho > 0 ? 0 : (float)s->fov;
    options.mm_per_unit = (float)s->mm_per_unit;
    size = way == TAPS ? ms_sss_filter_workspace(frame.width, frame.height, &kernel, 1, &options)
                       : ms_sss_pyramid_workspace(frame.width, frame.height);
    j->workspace = size < SIZE_MAX ? malloc(size) : NULL; /* sides beyond the filters' range, which they name */
    if (j->output.pixels == NULL || (j->workspace == NULL && size < SIZE_MAX))
        return fail(1, s->path[2], "out of memory");
    memset(&back, 0, sizeof back);
    if (s->back[0]) {
        back.input = ms_sss_interleaved(j->back[0].pixels, 3);
        back.depth = ms_sss_map(j->back[1].pixels, 1);
    }
    status = way == GATHER ? gather_filter(&frame, s->back[0] ? &back : NULL, j->profile, &options, &error)
        : way == PYRAMID   ? ms_sss_pyramid_filter(&frame, &pyramid, 1, &options, j->workspace, size, &error)
                           : ms_sss_filter(&frame, &kernel, 1, &options, j->workspace, size, &error);
    if (status != MS_OK) return fail(1, s->path[0], error.message);
    for (i = 0; i < frame.width * frame.height; ++i)
        compose_pixel(j->input.pixels + 3 * i, j->output.pixels + 3 * i, (float)(1 - s->strength), NULL, NULL, NULL,
                      j->output.pixels + 3 * i);
    if (way == GATHER) printf("gathered in space%s", s->back[0] ? ", front and back" : "");
    else if (way == PYRAMID) printf("pyramid");
    else
        printf("two passes of %d taps, %d term%s", kernel.tap_count, kernel.term_count,
               kernel.term_count > 1 ? "s" : "");
    printf("; 99%% of the light within %.1f pixels\n", radius);

    if (image__has_extension(s->path[2], ".png")) image_to_srgb(&j->output);
    problem = image_write(s->path[2], &j->output);
    return problem ? fail(1, s->path[2], problem) : 0;
}

int main(int argc, char **argv)
{
    settings s;
    job j;
    int code;
    if (file_help(argc, argv, usage)) return file_end_stdout("sss_filter");
    code = parse(argc, argv, &s);
    if (code) return code;
    memset(&j, 0, sizeof j);
    code = run(&s, &j);
    image_free(&j.input);
    image_free(&j.depth);
    image_free(&j.output);
    image_free(&j.back[0]);
    image_free(&j.back[1]);
    ms_sss_profile_destroy(j.profile);
    free(j.workspace);
    return code ? code : file_end_stdout("sss_filter");
}
