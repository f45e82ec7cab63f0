/* A plane of variants: embeds the materials that were scored highest, and colours the plane by what is known about it.

     cc -O2 -I. examples/latent.c -o build/latent -lm
     build/latent SCORES.csv OUT.png

   SCORES.csv: columns x0 .. x{m-1}, score; a header line is optional. Three panels: predicted score, similarity to the best
   material (here between parameters; a renderer or a neural network makes it one between pictures), and their product; grey where
   the plane knows nothing. White dots: the embedded materials; red: the best one; black: automatic variants of it, from most
   similar to best liked. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "image.h"
#include "maps.h"
#include "scores.h"

#define SIDE 320 /* pixels of a panel */
enum { GRID = 50, COARSE = 20, LIKED = 48, VARIANTS = 7 };

static const char usage[] = "usage: latent SCORES.csv OUT.png\n";

static int fail(const char *what)
{
    fprintf(stderr, "latent: %s\n", what);
    return 1;
}

/* The rows of the `limit` highest scores above 0, best first, into x; how many. */
static int liked(const scores *s, double *x, int limit)
{
    char *taken = (char *)calloc((size_t)s->n, 1);
    int count, i;
    for (count = 0; taken && count < limit; ++count) {
        int best = -1;
        for (i = 0; i < s->n; ++i)
            if (!taken[i] && s->y[i] > (best < 0 ? 0 : s->y[best])) best = i;
        if (best < 0) break;
        taken[best] = 1;
        memcpy(x + (size_t)count * (size_t)s->m, s->x + (size_t)best * (size_t)s->m, (size_t)s->m * sizeof *x);
    }
    free(taken);
    return count;
}

int main(int argc, char **argv)
{
    static double preference[GRID * GRID], confidence[GRID * GRID], product[GRID * GRID], similar[COARSE * COARSE];
    static const float white[3] = {1, 1, 1}, red[3] = {1, 0.15f, 0.1f}, black[3] = {0, 0, 0};
    double lambda[VARIANTS], *x;
    ms_gpr_variant variant[VARIANTS];
    ms_gpr_similarity similarity;
    ms_gpr_latent_options options;
    ms_gpr_latent_report report;
    ms_gpr_latent *plane = NULL;
    ms_gpr_grid grid, coarse;
    ms_gpr *gp = NULL;
    ms_status status;
    ms_error error;
    const char *problem;
    image im;
    scores s;
    int count, i, k;
    if (file_help(argc, argv, usage)) return file_end_stdout("latent");
    if (argc != 3) return file_usage(usage);
    problem = scores_read(argv[1], &s);
    if (problem) {
        fprintf(stderr, "latent: %s: %s (line %d)\n", argv[1], problem, s.line);
        return 1;
    }
    x = (double *)malloc(LIKED * (size_t)s.m * sizeof *x);
    im = image_new(3 * SIDE, SIDE, 3);
    if (x == NULL || im.pixels == NULL) return fail("out of memory");
    count = liked(&s, x, LIKED);
    if (count < 2) return fail("a plane needs at least two materials with scores above 0");

    memset(&options, 0, sizeof options);
    options.prior = 0.1; /* keeps the plane compact */
    status = ms_gpr_fit(s.x, s.y, s.n, s.m, NULL, &gp, NULL, &error);
    if (status == MS_OK) status = ms_gpr_latent_fit(x, count, s.m, &options, &plane, &report, &error);
    if (status != MS_OK) return fail(error.message);

    grid = ms_gpr_grid_around(plane, GRID);
    coarse = ms_gpr_grid_around(plane, COARSE);
    memset(&similarity, 0, sizeof similarity);
    similarity.x = x;
    similarity.scale = 0.3; /* of parameters in [0, 1] */
    for (i = 0; i < VARIANTS; ++i) lambda[i] = (i + 1.0) / (VARIANTS + 1);
    status = ms_gpr_map_preference(plane, gp, &grid, preference, NULL, &error);
    if (status == MS_OK) status = ms_gpr_map_confidence(plane, &grid, confidence, &error);
    if (status == MS_OK) status = ms_gpr_map_similarity(plane, &similarity, &coarse, similar, &error);
    if (status == MS_OK)
        status = ms_gpr_variants(plane, gp, &similarity, &grid, lambda, VARIANTS, 0, variant, NULL, &error);
    if (status != MS_OK) return fail(error.message);
    ms_gpr_map_product(&grid, preference, &coarse, similar, product);

    map_draw(&im, 0, 0, SIDE, &grid, preference, &grid, confidence);
    map_draw(&im, SIDE, 0, SIDE, &coarse, similar, &grid, confidence);
    map_draw(&im, 2 * SIDE, 0, SIDE, &grid, product, &grid, confidence);
    for (k = 0; k < 3; ++k) {
        for (i = count - 1; i >= 0; --i)
            map_dot(&im, k * SIDE, 0, SIDE, &grid, ms_gpr_latent_points(plane) + 2 * i, i ? 3 : 5, i ? white : red);
        for (i = 0; i < VARIANTS; ++i) map_dot(&im, k * SIDE, 0, SIDE, &grid, variant[i].latent, 2.5, black);
    }
    problem = image_write(argv[2], &im);
    if (problem) {
        fprintf(stderr, "latent: %s: %s\n", argv[2], problem);
        return 1;
    }
    printf("%d materials embedded: log likelihood %.1f, error %.3f\nlambda similarity score\n", count, report.likelihood, report.error);
    for (i = 0; i < VARIANTS; ++i) printf("%6.3f %10.3f %5.2f\n", lambda[i], variant[i].similarity, variant[i].score);
    ms_gpr_latent_destroy(plane);
    ms_gpr_destroy(gp);
    image_free(&im);
    scores_free(&s);
    free(x);
    return file_end_stdout("latent");
}
