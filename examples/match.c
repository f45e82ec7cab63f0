/* From an edited picture to a material: finds the parameters whose picture, drawn by a neural renderer, is closest to it.

     cc -O2 -I. examples/match.c -o build/match -lm
     build/match RENDERER.safetensors TARGET.(ppm|pfm) [--inversion DIR] [--weights MASK.pgm] [--start X.csv]
                 [--cost 50] [--out-params CSV] [--out-png PNG]

   The renderer takes parameters in [0, 1] and makes 3 x S x S values; the target is S x S pixels of them, display values
   in a PPM, any floats in a PFM (taken as they are). DIR holds inversion networks for first guesses, X.csv one more: the
   source material, or the last frame's answer; without either the search starts in the middle of the box. MASK: the
   weight of each pixel. --cost: renders to spend on the refinement. The parameters go to CSV as one row. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "matcher.h"
#include "materials.h"
#include <time.h>

static int usage(void)
{
    fprintf(stderr, "usage: match RENDERER.safetensors TARGET.(ppm|pfm) [--inversion DIR] [--weights MASK.pgm] [--start X.csv]\n"
                    "             [--cost 50] [--out-params CSV] [--out-png PNG]\n");
    return 2;
}

static int fail(const char *path, const char *what)
{
    fprintf(stderr, "match: %s: %s\n", path, what);
    return 1;
}

/* A picture of this size and number of channels, or NULL and a message. */
static float *read_picture(const char *path, int size, int channels, image *im)
{
    const char *problem = image_read(path, im);
    if (problem) {
        fail(path, problem);
    } else if (im->width != size || im->height != size || im->channels != channels) {
        fprintf(stderr, "match: %s: %d x %d pixels of %d channels, the renderer needs %d x %d of %d\n", path, im->width, im->height,
                im->channels, size, size, channels);
    } else {
        return im->pixels;
    }
    image_free(im);
    return NULL;
}

/* Parameters that the picture leaves open: errors of the size of the RMSE in every value would move them by more than a
   tenth of their range. */
static void print_open(const matcher *m, const double *x, double rmse)
{
    double singular_value[MS_PME_PARAMETERS_MAX], deviation[MS_PME_PARAMETERS_MAX];
    int i, count = 0;
    if (m->collapse == NULL || ms_pme_sensitivity(&m->reduced, NULL, x, singular_value, NULL, deviation, NULL) != MS_OK) return;
    for (i = 0; i < m->renderer.parameter_count; ++i)
        if (!(rmse * deviation[i] < 0.1)) printf("%s%d", count++ ? ", " : "parameters that the picture hardly determines: ", i);
    if (count) printf("\n");
}

int main(int argc, char **argv)
{
    static const char *const stop[] = {"converged", "target reached", "cost spent", "time spent"};
    static matcher m;
    const char *renderer = NULL, *target_path = NULL, *inversions = NULL, *mask_path = NULL, *start = NULL, *csv = NULL, *png = NULL;
    const char *problem;
    double x[MS_PME_PARAMETERS_MAX], source[MS_PME_PARAMETERS_MAX], cost = 50, seconds;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    image target_image, mask, answer;
    materials guess;
    float *target, *weight = NULL, *picture;
    ms_error error;
    ms_status status;
    clock_t began;
    FILE *f;
    int i, n, pixels;
    for (i = 1; i < argc; ++i) {
        if (argv[i][0] != '-' && renderer == NULL) renderer = argv[i];
        else if (argv[i][0] != '-' && target_path == NULL) target_path = argv[i];
        else if (argv[i][0] != '-' || i + 1 == argc) return usage();
        else if (strcmp(argv[i], "--inversion") == 0) inversions = argv[++i];
        else if (strcmp(argv[i], "--weights") == 0) mask_path = argv[++i];
        else if (strcmp(argv[i], "--start") == 0) start = argv[++i];
        else if (strcmp(argv[i], "--cost") == 0) cost = strtod(argv[++i], NULL);
        else if (strcmp(argv[i], "--out-params") == 0) csv = argv[++i];
        else if (strcmp(argv[i], "--out-png") == 0) png = argv[++i];
        else return usage();
    }
    if (target_path == NULL || !(cost > 0)) return usage();

    /* networks, target, weights, first guess */
    status = matcher_open(&m, renderer, &error);
    if (status == MS_OK && inversions) status = matcher_add_inversions(&m, inversions, &error);
    if (status != MS_OK) {
        fprintf(stderr, "match: %s\n", error.message);
        return 1;
    }
    n = m.renderer.parameter_count;
    pixels = m.network.size * m.network.size;
    if (!read_picture(target_path, m.network.size, 3, &target_image)) return 1;
    if (mask_path && !read_picture(mask_path, m.network.size, 1, &mask)) return 1;
    if (start && (problem = materials_read(start, n, &guess)) != NULL) return fail(start, problem);
    for (i = 0; start && i < n; ++i) source[i] = (double)guess.x[i];
    target = (float *)malloc(9 * (size_t)pixels * sizeof(float));
    answer = image_new(m.network.size, m.network.size, 3);
    if (target == NULL || answer.pixels == NULL) return fail(target_path, "out of memory");
    picture = target + 3 * pixels;
    neural_planes(&target_image, target);
    if (mask_path) weight = picture + 3 * pixels;
    for (i = 0; weight && i < 3 * pixels; ++i) {
        weight[i] = mask.pixels[i % pixels];
        if (!(weight[i] > 0) && !(fabsf(target[i]) < 1e30f)) target[i] = 0; /* NaN where nothing counts */
    }

    /* the match */
    options.refine.max_cost = cost;
    options.refine.restarts = 1000; /* while cost is left: from the other first guesses, then from random points */
    options.candidates = source;
    options.candidate_count = start != NULL;
    status = matcher_aim(&m, target, weight, &error);
    began = clock();
    if (status == MS_OK) status = ms_pme_match(&m.renderer, target, weight, &options, x, picture, &result, &error);
    if (status != MS_OK) return fail(target_path, error.message);
    seconds = (double)(clock() - began) / CLOCKS_PER_SEC;

    /* what was found */
    printf("first guess: %s, RMSE %.5f (%.2f of 255)\n",
           result.best_candidate < m.renderer.prediction_count ? m.name[result.best_candidate] : start ? start : "middle of the box",
           result.rmse_initial, 255 * result.rmse_initial);
    printf("match: RMSE %.5f (%.2f of 255) after %.0f renders, %.1f ms, %s\n", result.rmse, 255 * result.rmse, result.cost, 1e3 * seconds,
           stop[result.refine.stop]);
    for (i = 0; i < n; ++i) printf("%s%.4f", i ? " " : "x: ", x[i]);
    printf("\n");
    print_open(&m, x, result.rmse);
    if (csv) {
        f = fopen(csv, "w");
        for (i = 0; f && i < n; ++i) fprintf(f, "%.9g%s", x[i], i + 1 < n ? "," : "\n");
        if (f == NULL || fclose(f) != 0) return fail(csv, "cannot be written");
    }
    neural_paste(picture, m.network.size, &answer, 0, 0);
    problem = png ? image_write(png, &answer) : NULL;
    if (problem) return fail(png, problem);
    matcher_close(&m);
    image_free(&target_image);
    if (mask_path) image_free(&mask);
    if (start) materials_free(&guess);
    image_free(&answer);
    free(target);
    return 0;
}
