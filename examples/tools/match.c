/* From an edited picture to a material: finds the parameters whose picture, drawn by a neural renderer, is closest to
   it. cc -O2 -I. examples/tools/match.c -o build/match -lm

     build/match RENDERER.safetensors TARGET.(png|ppm|pgm|pfm) [--inversion DIR] [--weights MASK.(png|pgm|ppm|pfm)]
                 [--start X.csv] [--cost 50] [--robust] [--align] [--exposure] [--tint] [--freeze
                 NAME,NUMBER,...] [--pull 0] [--change 1] [--view RENDERER.safetensors TARGET]... [--out-params CSV]
                 [--out-png PNG]

   The renderer takes parameters in [0, 1] and makes 3 x S x S display values. The target may have any size and be gray,
   RGB or with alpha (a pixel counts as much as it covers); display values in PNG, PPM and PGM, linear light in a PFM,
   which is converted. DIR holds inversion networks for first guesses, X.csv one more: the source material, or the last
   frame's answer; without either the search starts in the middle of the box. MASK: the weight of each pixel, a channel
   each where it has color. --cost: renders to spend on the refinement. --robust: what fits badly (a logo, a stitch)
   counts as an outlier. --exposure, --tint: a gain of the picture, or one a channel with an offset, is found along, and
   is not the material's. --align: the target has slipped by up to an eighth of its width; it is moved back. --freeze
   keeps parameters as X.csv has them, --pull holds all of them to it (0.01: a change by 1 costs as much as an RMSE of
   0.1), --change lets none go further from it: for frames of a sequence. --view: another picture of the same material,
   by a renderer of its own (another view, light or size), up to seven; all count in one objective, without --weights,
   --robust, --align, --exposure and --tint. The parameters go to CSV as a line of names and a row: the names of the
   renderer's metadata "ms_parameters" (separated by commas), else those of X.csv. The PNG has gain and offset applied.
   The line "verdict:" says how good the match is; the exit code is 3, with all files written, where the renderer can
   draw nothing like the picture, or nothing nearer than one color. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "matcher.h"
#include "materials.h"

static const char usage_text[] =
    "usage: match RENDERER.safetensors TARGET.(png|ppm|pgm|pfm) [--inversion DIR] [--weights MASK] [--start X.csv] [--cost 50] "
    "[--robust] [--align] [--exposure] [--tint] [--freeze NAME,...] [--pull 0] [--change 1] [--view RENDERER TARGET]... [--out-params CSV] [--out-png PNG]";

static int fail(const char *path, const char *what)
{
    fprintf(stderr, "match: %s: %s\n", path, what);
    return 1;
}

/* A number from low to 1e9, the whole word; 0: it is none. */
static int number(const char *text, double low, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == 0 && *value >= low && *value <= 1e9;
}

/* To the renderer's size by areas, in linear light where the values are displayed ones; says so. */
static const char *fit(const char *path, int size, int displayed, image *im)
{
    image other;
    if (im->width == size && im->height == size) return NULL;
    fprintf(stderr, "match: %s: %d x %d pixels, brought to the renderer's %d x %d%s\n", path, im->width, im->height,
            size, size, im->width != im->height ? " (its sides are not equal: it is stretched)" : "");
    if (displayed) image_to_linear(im);
    other = image_resize(im, size, size);
    if (other.pixels == NULL) return "out of memory";
    if (displayed) image_to_srgb(&other);
    image_free(im);
    *im = other;
    return NULL;
}

/* Channel c of pixel i as a picture in color has it. */
static float sample(const image *im, int i, int c)
{
    return im->pixels[i * im->channels + (im->channels == 1 ? 0 : c)];
}

/* The picture as planes [3][size][size] of display values; alpha [size][size] of one that has it (*has_alpha), else
   untouched. Where weight [3][size][size] (NULL: 1) is 0, a picture of that size may hold anything. */
static const char *read_target(const char *path, int size, const float *weight, float *planes, float *alpha,
                               int *has_alpha)
{
    static char wrong[120];
    image im;
    const char *problem = image_read(path, &im);
    int linear = image__has_extension(path, ".pfm"), pixels, i, c, above = 0;
    if (problem) return problem;
    pixels = im.width * im.height;
    for (i = 0; i < pixels && !problem; ++i)
        for (c = 0; c < (im.channels == 1 ? 1 : 3); ++c) {
            float v = sample(&im, i, c);
            if (v > 1 && v < 1e30f) ++above;
            if (v >= 0 && v < 1e30f) continue;
            if (weight && im.width == size && im.height == size && !(weight[c * pixels + i] > 0)) {
                im.pixels[i * im.channels + c] = 0;
                continue;
            }
            snprintf(wrong, sizeof wrong, "column %d, row %d has a value that is negative or not finite", i % im.width,
                     i / im.width);
            problem = wrong;
        }
    if (above) fprintf(stderr, "match: %s: %d values above 1 shine as brightly as 1\n", path, above);
    for (i = 0; i < (int)image_count(&im); ++i)
        if (im.pixels[i] > 1) im.pixels[i] = 1;
    if (!problem && linear) image_to_srgb(&im);
    if (!problem) problem = fit(path, size, 1, &im);
    for (i = 0; i < size * size && !problem; ++i) {
        for (c = 0; c < 3; ++c) planes[c * size * size + i] = sample(&im, i, c);
        if (im.channels == 4) alpha[i] = im.pixels[4 * i + 3];
    }
    *has_alpha = im.channels == 4;
    image_free(&im);
    return problem;
}

/* A mask into weight [3][size][size]. */
static const char *read_mask(const char *path, int size, float *weight)
{
    image im;
    const char *problem = image_read(path, &im);
    int i, c, total = size * size;
    if (!problem) problem = fit(path, size, 0, &im);
    for (i = 0; i < total && !problem; ++i)
        for (c = 0; c < 3; ++c)
            weight[c * total + i] = sample(&im, i, c) * (im.channels == 4 ? im.pixels[4 * i + 3] : 1);
    image_free(&im);
    return problem;
}

/* Name i of a list separated by commas or semicolons, quotes and spaces around it dropped; an empty one where there is
   none. */
static void name_of(const char *list, int i, char *name, size_t size)
{
    size_t length;
    while (list && i-- > 0) list = strpbrk(list, ",;") ? strpbrk(list, ",;") + 1 : NULL;
    *name = 0;
    if (list == NULL) return;
    list += strspn(list, " \t\"");
    length = strcspn(list, ",;\r\n");
    while (length > 0 && strchr(" \t\"", list[length - 1])) --length;
    snprintf(name, size, "%.*s", (int)(length < size ? length : size - 1), list);
}

/* The first line of a CSV where it holds names, into text. */
static void header_of(const char *path, char *text, size_t size)
{
    FILE *f = fopen(path, "rb");
    char *start = text, *end;
    *text = 0;
    if (f == NULL) return;
    if (fgets(text, (int)size, f) == NULL) *text = 0;
    fclose(f);
    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) memmove(text, text + 3, strlen(text + 3) + 1);
    (void)strtod(start, &end);
    if (end != start || *text == '#') *text = 0;
}

/* The parameters in a list of names or numbers, separated by commas, get equal bounds; 0 where a word is neither. */
static int freeze(const char *list, const char *names, int n, const double *source, double *low, double *high)
{
    int word, i, k;
    for (word = 0;; ++word) {
        char text[64], name[64], *end;
        name_of(list, word, text, sizeof text);
        if (*text == 0) return word > 0;
        k = (int)strtol(text, &end, 10);
        if (*end != 0) k = -1;
        for (i = 0; i < n && k < 0; ++i) {
            name_of(names, i, name, sizeof name);
            if (strcmp(name, text) == 0) k = i;
        }
        if (k < 0 || k >= n) return 0;
        low[k] = high[k] = source[k];
    }
}

/* The standard deviations, and the parameters that the picture leaves open: errors of the size of the RMSE in every
   value would move them by more than a tenth of their range. */
static void print_open(const double *deviation, int n, const char *names)
{
    char name[64];
    int i, count = 0;
    for (i = 0; i < n; ++i) printf("%s%.4f", i ? " " : "standard deviations: ", deviation[i]);
    printf("\n");
    for (i = 0; i < n; ++i)
        if (!(deviation[i] < 0.1)) {
            name_of(names, i, name, sizeof name);
            printf("%s%d%s%s", count++ ? ", " : "parameters that the picture hardly determines: ", i, *name ? " " : "",
                   name);
        }
    if (count) printf("\n");
}

int main(int argc, char **argv)
{
    static const char *const stop[] = {"converged", "cost spent"};
    static matcher m, further[matcher_views_max];
    static matcher_views views;
    static char header[32768], text[40000];
    const char *renderer = NULL, *target_path = NULL, *inversions = NULL, *mask_path = NULL, *start = NULL, *csv = NULL,
               *png = NULL;
    char sentence[240];
    const char *problem, *names, *frozen = NULL, *view[2 * matcher_views_max];
    matcher *all[matcher_views_max];
    double low[MS_PME_PARAMETERS_MAX], high[MS_PME_PARAMETERS_MAX], pulls[MS_PME_PARAMETERS_MAX],
        pull = 0, change = 1, deviation[MS_PME_PARAMETERS_MAX], x[MS_PME_PARAMETERS_MAX], source[MS_PME_PARAMETERS_MAX],
        cost = 50, seconds;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    matcher_found found;
    image answer;
    materials guess;
    float *target, *weight, *alpha, *picture;
    ms_error error;
    ms_status status;
    size_t used = 0, total;
    int i, k, n, pixels, has_alpha = 0, flags = 0, light, count = 1, verdict;
    memset(&found, 0, sizeof found);
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) return puts(usage_text) < 0 || file_end_stdout("match");
        if (strcmp(argv[i], "--robust") == 0) flags |= MATCHER_ROBUST;
        else if (strcmp(argv[i], "--align") == 0) flags |= MATCHER_ALIGN;
        else if (strcmp(argv[i], "--exposure") == 0) flags |= MATCHER_EXPOSURE;
        else if (strcmp(argv[i], "--tint") == 0) flags |= MATCHER_TINT;
        else if (argv[i][0] != '-' && renderer == NULL) renderer = argv[i];
        else if (argv[i][0] != '-' && target_path == NULL) target_path = argv[i];
        else if (argv[i][0] != '-' || i + 1 == argc) break;
        else if (strcmp(argv[i], "--inversion") == 0) inversions = argv[++i];
        else if (strcmp(argv[i], "--weights") == 0) mask_path = argv[++i];
        else if (strcmp(argv[i], "--start") == 0) start = argv[++i];
        else if (strcmp(argv[i], "--out-params") == 0) csv = argv[++i];
        else if (strcmp(argv[i], "--out-png") == 0) png = argv[++i];
        else if (strcmp(argv[i], "--freeze") == 0) frozen = argv[++i];
        else if (strcmp(argv[i], "--view") == 0 && i + 2 < argc && count < matcher_views_max) {
            view[2 * count] = argv[++i];
            view[2 * count++ + 1] = argv[++i];
        } else if (strcmp(argv[i], "--change") == 0) {
            if (!number(argv[++i], 0, &change)) return fail(argv[i], "--change takes a number from 0 to 1e9") + 1;
        } else if (strcmp(argv[i], "--pull") == 0) {
            if (!number(argv[++i], 0, &pull)) return fail(argv[i], "--pull takes a number from 0 to 1e9") + 1;
        } else if (strcmp(argv[i], "--cost") == 0) {
            if (!number(argv[++i], 1, &cost)) return fail(argv[i], "--cost takes a number from 1 to 1e9") + 1;
        } else break;
    }
    if (i < argc || target_path == NULL || (count > 1 && (flags || mask_path))) {
        fprintf(stderr, "%s\n", usage_text);
        return 2;
    }
    light = flags & (MATCHER_EXPOSURE | MATCHER_TINT);

    /* networks, target, weights, first guess */
    status = matcher_open(&m, renderer, &error);
    if (status == MS_OK && inversions) status = matcher_add_inversions(&m, inversions, &error);
    if (status != MS_OK) {
        fprintf(stderr, "match: %s\n", error.message);
        return 1;
    }
    for (k = 1, all[0] = &m, total = m.renderer.image_size; k < count; ++k) {
        all[k] = &further[k];
        status = matcher_open(all[k], view[2 * k], &error);
        if (status != MS_OK) return fail(view[2 * k], error.message);
        if (all[k]->renderer.parameter_count != m.renderer.parameter_count)
            return fail(view[2 * k], "a renderer of other parameters");
        total += all[k]->renderer.image_size;
    }
    n = m.renderer.parameter_count;
    pixels = m.network.size * m.network.size;
    target = (float *)malloc(4 * total * sizeof(float)); /* target, picture, weight, alpha */
    answer = image_new(m.network.size, m.network.size, 3);
    if (target == NULL || answer.pixels == NULL) return fail(target_path, "out of memory");
    picture = target + total;
    weight = picture + total;
    alpha = weight + total;
    for (i = 0; i < 3 * pixels; ++i) weight[i] = 1;
    problem = mask_path ? read_mask(mask_path, m.network.size, weight) : NULL;
    if (problem) return fail(mask_path, problem);
    problem = read_target(target_path, m.network.size, mask_path ? weight : NULL, target, alpha, &has_alpha);
    if (problem) return fail(target_path, problem);
    for (i = 0; i < 3 * pixels && has_alpha; ++i) weight[i] *= alpha[i % pixels];
    if (!mask_path && !has_alpha) weight = NULL;
    for (k = 1, used = m.renderer.image_size; k < count; used += all[k++]->renderer.image_size) {
        problem = read_target(view[2 * k + 1], all[k]->network.size, NULL, target + used, alpha, &has_alpha);
        if (!problem && (has_alpha || weight)) problem = "--view takes pictures without alpha";
        if (problem) return fail(view[2 * k + 1], problem);
    }
    used = 0;
    names = ms_nn_file_metadata(ms_nn_tensors(m.network.nn), "ms_parameters");
    if (start && (problem = materials_read(start, n, &guess)) != NULL) return fail(start, problem);
    for (i = 0; start && i < n; ++i) source[i] = (double)guess.x[i];
    if (start && names == NULL) header_of(start, header, sizeof header);
    if (names == NULL && header[0]) names = header;
    for (i = 0; i < n; ++i) {
        low[i] = start && source[i] > change ? (source[i] < 1 ? source[i] : 1) - change
                                             : 0; /* the source is clipped to [0, 1] */
        high[i] = start && source[i] + change < 1 ? (source[i] > 0 ? source[i] : 0) + change : 1;
        low[i] = low[i] > 0 ? low[i] : 0;
        high[i] = high[i] < 1 ? high[i] : 1;
        pulls[i] = pull;
    }
    if ((frozen || pull > 0 || change < 1) && !start)
        return fail("--freeze, --pull and --change", "need --start, which says where") + 1;
    if (frozen && !freeze(frozen, names, n, source, low, high))
        return fail(frozen, "--freeze takes names or numbers of parameters") + 1;

    /* the match */
    seconds = matcher_clock();
    m.renderer.lower = low;
    m.renderer.upper = high;
    if (pull > 0) {
        options.source = source;
        options.pull = pulls;
    }
    options.refine.max_cost = cost;
    if (light && matcher_hides_surroundings(weight, m.network.size))
        fprintf(stderr,
                "match: the weights hide the surroundings: the picture cannot tell the color of the light from the "
                "material's; leave some of them, or drop --exposure and --tint\n");
    options.refine.restarts = 1000; /* while cost is left: from the other first guesses, then from random points */
    options.candidates = source;
    options.candidate_count = start != NULL;
    options.deviation = deviation;
    if (count == 1) {
        status = matcher_match(&m, target, weight, &options, flags, x, picture, &result, &found, &error);
    } else {
        status = matcher_views_aim(&views, all, count, target, NULL, &error);
        if (status == MS_OK)
            status = ms_pme_match(&views.renderer, target, NULL, &options, x, picture, &result, &error);
    }
    if (status != MS_OK) return fail(target_path, error.message);
    seconds = matcher_clock() - seconds;

    /* what was found */
    printf("first guess: %s, RMSE %.5f (%.2f of 255)\n",
           result.best_candidate < m.renderer.prediction_count ? m.name[result.best_candidate]
               : start                                         ? start
                                                               : "middle of the box",
           result.rmse_initial, 255 * result.rmse_initial);
    printf("match: RMSE %.5f (%.2f of 255) after %.0f renders, %.1f ms, %s\n", result.rmse, 255 * result.rmse,
           result.cost, 1e3 * seconds, stop[result.refine.stop]);
    if (result.refine.steps == 0 && result.refine.stop != MS_PME_STOP_CONVERGED)
        printf("this is the first guess: %s before the first step\n", stop[result.refine.stop]);
    verdict = matcher_judge(target, weight, total, result.rmse, sentence, sizeof sentence);
    printf("verdict: %s\n", sentence);
    for (i = 0; i < n; ++i) {
        char name[64];
        name_of(names, i, name, sizeof name);
        if (*name) printf("%s%s %.4f", i ? ", " : "x: ", name, x[i]);
        else printf("%s%.4f", i ? " " : "x: ", x[i]);
    }
    printf("\n");
    if (light)
        printf("gain %.3f %.3f %.3f, offset %.3f %.3f %.3f, applied to the PNG\n", found.gain[0], found.gain[1],
               found.gain[2], found.offset[0], found.offset[1], found.offset[2]);
    if (flags & MATCHER_ALIGN) printf("the target lies %.2f pixels right, %.2f down\n", found.shift[0], found.shift[1]);
    print_open(deviation, n, names);
    for (i = 0; i < n && names; ++i) {
        char name[64];
        name_of(names, i, name, sizeof name);
        if (*name == 0) snprintf(name, sizeof name, "x%d", i);
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", name, i + 1 < n ? "," : "\n");
    }
    for (i = 0; i < n; ++i)
        used += (size_t)snprintf(text + used, sizeof text - used, "%.9g%s", x[i], i + 1 < n ? "," : "\n");
    problem = csv ? image_save(csv, text, used) : NULL;
    if (problem) return fail(csv, problem);
    neural_paste(picture, m.network.size, &answer, 0, 0);
    problem = png ? image_write(png, &answer) : NULL;
    if (problem) return fail(png, problem);
    if (file_end_stdout("match")) return 1;
    for (k = 0; k < count; ++k) matcher_close(all[k]);
    if (start) materials_free(&guess);
    image_free(&answer);
    free(target);
    return verdict == 2 ? 3 : 0;
}
