/* Designs a separable kernel for a material and prints its weights, its errors and the array for a shader.

     cc -O2 -I. examples/tools/sss_kernel.c -o build/sss_kernel -lm
     build/sss_kernel skin1                                   7 taps, least error where the radius covers 24 pixels
     build/sss_kernel skin1 --radius 96 --tolerance 0.05      the cheapest kernel within 5% on natural textures
     build/sss_kernel skin1 --model pre --taps 33 --tolerance 0.06     the fewest taps of one model, at most 33
     build/sss_kernel profile.csv --model svd --terms 3 --taps dense
     build/sss_kernel deon --model guided --k 1 --taps 17 --placement quantile

   profile.csv is what build/profile prints. Exit: 0, 1 if something failed or the tolerance is out of reach, 2 if the
   arguments are wrong. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "files.h"
#include "profile_csv.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "choose.h"

static const char *const model_names[] = {"image",     "preintegrated", "residual", "svd",  "svdn",
                                          "gaussians", "guided",        "artist",   "slice"};
static const char *const placement_names[] = {"optimized", "quantile", "quadratic"};

static const char usage_text[] =
    "usage: sss_kernel MATERIAL|CSV [--radius PIXELS] [--taps N|dense] [--tolerance E] [--model NAME] [more: --help]\n"
    "       [--terms N] [--placement NAME] [--budget N] [--dial D] [--k K] [--no-delta]\n"
    "       --tolerance: the cheapest kernel, at most N taps in all its terms (66); of --model or --taps: its fewest taps\n"
    "       models: image preintegrated residual svd svdn gaussians guided artist slice\n"
    "       placements: optimized quantile quadratic; materials: deon and those of build/profile --list\n";

static int usage(const char *problem, const char *value)
{
    fprintf(stderr, "sss_kernel: %s%s%s\n", problem, value ? ": " : "", value ? value : "");
    return file_usage(usage_text);
}

/* d'Eon and Luebke's six Gaussians for skin (GPU Gems 3, chapter 14): variances in mm^2. */
static ms_status deon_skin(ms_sss_profile **profile)
{
    static const double variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
    static const double weight[6][3] = {{0.233, 0.455, 0.649}, {0.1, 0.336, 0.344}, {0.118, 0.198, 0},
                                        {0.113, 0.007, 0.007}, {0.358, 0.004, 0},   {0.078, 0, 0}};
    double sigma[6][3];
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(variance[i]);
    return ms_sss_profile_from_gaussians(profile, 6, (const double(*)[3])sigma, weight, NULL, NULL);
}

static ms_status material_profile(const ms_mcml_material *material, ms_sss_profile **profile, ms_error *error)
{
    ms_mcml_medium medium[3];
    ms_mcml_profile rings;
    const double *rd[3];
    ms_status status;
    int c;
    for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(material, c);
    status = ms_mcml_profile_make(&rings, medium, 3, NULL, error);
    if (status != MS_OK) return status;
    for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
    status = ms_sss_profile_from_rings(profile, rings.rings, rings.edge_mm, rd, 1, NULL, error);
    ms_mcml_profile_destroy(&rings);
    return status;
}

static ms_status csv_profile(const char *path, ms_sss_profile **profile, ms_error *error)
{
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    char *text = NULL;
    size_t size = 0, got = 1;
    ms_status status;
    if (f == NULL) {
        snprintf(error->message, sizeof error->message, "%.160s is no material; as a file: %s", path, problem);
        return MS_IO;
    }
    while (got > 0) {
        char *more = (char *)realloc(text, size + 65536);
        if (more == NULL) break;
        text = more;
        got = fread(text + size, 1, 65536, f);
        size += got;
    }
    fclose(f);
    if (text == NULL) return MS_OUT_OF_MEMORY;
    status = profile_from_csv(profile, text, size, error);
    free(text);
    return status;
}

/* The index of a name, or of the one name that starts like it; -1: none, or several. */
static int find(const char *name, const char *const *names, int count)
{
    int i, found = -1;
    for (i = 0; i < count; ++i) {
        if (strcmp(name, names[i]) == 0) return i;
        if (strncmp(name, names[i], strlen(name)) == 0) found = found == -1 ? i : -2;
    }
    return found < 0 ? -1 : found;
}

/* The model of options with as few taps as keep its texture error within the tolerance, options->tap_count at most. */
static ms_status fewest_taps(ms_sss_kernel *kernel, ms_sss_errors *errors, const ms_sss_designer *designer,
                             ms_sss_kernel_options options, double tolerance, ms_error *error)
{
    const int most = options.tap_count == 0 ? 33 : options.tap_count;
    ms_status status = MS_OK;
    for (options.tap_count = most == MS_SSS_DENSE ? most : 3; status == MS_OK; options.tap_count += 2) {
        status = ms_sss_kernel_build(kernel, designer, &options, error);
        if (status == MS_OK) status = ms_sss_kernel_measure(errors, kernel, designer);
        if (status != MS_OK || errors->texture <= tolerance) return status;
        if (options.tap_count == MS_SSS_DENSE || options.tap_count + 2 > most) break;
    }
    snprintf(error->message, sizeof error->message, "%d taps of this model reach an error of %g; %g was asked for",
             kernel->tap_count, errors->texture, tolerance);
    return MS_NOT_CONVERGED;
}

static void print_kernel(const ms_sss_kernel *k, const ms_sss_errors *e)
{
    int i, t;
    printf("taps %d, terms %d: %d reads a pixel; radius %.5g mm\n", k->tap_count, k->term_count,
           2 * k->tap_count * k->term_count, (double)k->radius_mm);
    printf("errors %%: texture %.3f, vertical step %.3f, diagonal step %.3f, dot %.3f\n", 100 * e->texture,
           100 * e->vertical_step, 100 * e->diagonal_step, 100 * e->dot);
    printf("reflectance %.6f %.6f %.6f\n", (double)k->reflectance[0], (double)k->reflectance[1],
           (double)k->reflectance[2]);
    printf(
        "\n// out = delta * E + sum over terms of scale * (E * term along x) * term along y; xyz: weights, w: offset in mm\n");
    printf("const vec3 delta = vec3(%.7g, %.7g, %.7g);\n", (double)k->delta[0], (double)k->delta[1],
           (double)k->delta[2]);
    for (t = 0; t < k->term_count; ++t) {
        printf("const vec3 scale%d = vec3(%g, %g, %g);\n", t, (double)k->scale[t][0], (double)k->scale[t][1],
               (double)k->scale[t][2]);
        printf("const vec4 term%d[%d] = vec4[%d](\n", t, k->tap_count, k->tap_count);
        for (i = 0; i < k->tap_count; ++i) { /* the center, then each pair at -offset and +offset */
            const float *weight = k->weight[t][(i + 1) / 2];
            printf("    vec4(%.7g, %.7g, %.7g, %.7g)%s\n", (double)weight[0], (double)weight[1], (double)weight[2],
                   (i % 2 ? -1 : 1) * (double)k->offset_mm[(i + 1) / 2], i + 1 < k->tap_count ? "," : ");");
        }
    }
}

static int report(void *user, double fraction)
{
    (void)user;
    fprintf(stderr, "\r%3.0f%% of the budget tried ", 100 * fraction);
    return 0;
}

int main(int argc, char **argv)
{
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    static ms_sss_kernel kernel;
    ms_sss_profile *profile = NULL;
    ms_sss_designer *designer = NULL;
    ms_sss_errors errors;
    ms_error error = {MS_OK, 0, ""};
    ms_status status;
    const ms_progress progress = {NULL, report};
    double radius = 0, tolerance = 0, number;
    int budget = 66, i, index, one_model = 0;
    if (file_help(argc, argv, usage_text)) return file_end_stdout("sss_kernel");
    if (argc < 2 || argv[1][0] == '-') return usage("a material or a CSV file is missing", NULL);
    for (i = 2; i < argc; ++i) {
        const char *name = argv[i], *value = i + 1 < argc ? argv[i + 1] : "";
        char *end;
        if (strcmp(name, "--no-delta") == 0) {
            options.no_delta = 1;
            continue;
        }
        if (*value == 0) return usage("an unknown option or a missing value", name);
        ++i;
        if (strcmp(name, "--model") == 0 || strcmp(name, "--taps") == 0) one_model = 1;
        if (strcmp(name, "--model") == 0) {
            if ((index = find(value, model_names, (int)(sizeof model_names / sizeof model_names[0]))) < 0)
                return usage("no such model", value);
            options.model = (ms_sss_model)index;
            continue;
        }
        if (strcmp(name, "--placement") == 0) {
            if ((index = find(value, placement_names, 3)) < 0) return usage("no such placement", value);
            options.placement = (ms_sss_placement)index;
            continue;
        }
        if (strcmp(name, "--taps") == 0 && strcmp(value, "dense") == 0) {
            options.tap_count = MS_SSS_DENSE;
            continue;
        }
        number = strtod(value, &end);
        if (*end != 0 || !(number >= 0 && number <= 1e6)) return usage("not a number from 0 to 1e6", value);
        if (strcmp(name, "--taps") == 0) options.tap_count = (int)number;
        else if (strcmp(name, "--terms") == 0) options.term_count = (int)number;
        else if (strcmp(name, "--budget") == 0) budget = (int)number;
        else if (strcmp(name, "--radius") == 0) radius = number;
        else if (strcmp(name, "--tolerance") == 0) tolerance = number;
        else if (strcmp(name, "--dial") == 0) options.dial = number;
        else if (strcmp(name, "--k") == 0) options.guide_k = number;
        else return usage("an unknown option", name);
    }
    if (strcmp(argv[1], "deon") == 0) status = deon_skin(&profile);
    else if (ms_mcml_find_material(argv[1]) != NULL)
        status = material_profile(ms_mcml_find_material(argv[1]), &profile, &error);
    else status = csv_profile(argv[1], &profile, &error);
    if (status == MS_OK) status = ms_sss_designer_create(&designer, profile, radius, NULL, &error);
    if (status == MS_OK && tolerance > 0 && one_model) {
        status = fewest_taps(&kernel, &errors, designer, options, tolerance, &error);
    } else if (status == MS_OK && tolerance > 0) {
        status = choose_kernel(&kernel, &errors, designer, tolerance, budget, &progress, &error);
    } else if (status == MS_OK) {
        status = ms_sss_kernel_build(&kernel, designer, &options, &error);
        if (status == MS_OK) status = ms_sss_kernel_measure(&errors, &kernel, designer);
    }
    if (status == MS_OK || status == MS_NOT_CONVERGED) print_kernel(&kernel, &errors);
    if (status != MS_OK) fprintf(stderr, "sss_kernel: %s (%s)\n", error.message, ms_status_string(status));
    ms_sss_designer_destroy(designer);
    ms_sss_profile_destroy(profile);
    return file_end_stdout("sss_kernel") || status != MS_OK;
}
