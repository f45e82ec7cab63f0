/* A plane of variants: embeds the materials that were scored highest, and colors the plane by what is known about it.

     cc -O2 -I. examples/tools/latent.c -o build/latent -lm
     build/latent SCORES.csv OUT.png [RENDERER.safetensors]

   SCORES.csv: parameters and a score a line, as scores.h reads them. Three panels: predicted score, similarity to the
   best material, and their product; gray where the plane knows nothing. White dots: the embedded materials; red: the
   best one; black: automatic variants of it, from most similar to best liked. RENDERER: a network from parameters to a
   picture, such as examples/data/renderer_64.safetensors: then materials lie on the plane as pictures, and similarity
   is between pictures. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "neural.h"
#include "maps.h"
#include "scores.h"

enum {
    SIDE = 480 /* pixels of a panel */,
    HEAD = 28,
    FOOT = 58,
    GRID = 50,
    COARSE = 20,
    LIKED = 48,
    VARIANTS = 7,
    PICTURES = 14,
    PICTURE = 64
};

static const char usage[] = "usage: latent SCORES.csv OUT.png [RENDERER.safetensors]\n";

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

/* The picture of material x. */
static ms_status render(void *user, const double *x, float *picture)
{
    const neural *n = (const neural *)user;
    float parameter[1000];
    int k;
    for (k = 0; k < n->parameters; ++k) parameter[k] = (float)(x[k] > 0 ? x[k] < 1 ? x[k] : 1 : 0);
    neural_render(n, parameter, 1, picture);
    return MS_OK;
}

/* Pictures where the plane knows something, far from each other. */
static ms_status draw_pictures(image *im, const neural *n, const ms_gpr_latent *plane, const map_grid *grid,
                               const double *confidence, ms_error *error)
{
    double nearest[GRID * GRID], at[2], other[2], x[1000];
    double apart = 1.1 * (double)PICTURE / (double)SIDE * (grid->x1 - grid->x0);
    ms_status status = MS_OK;
    int count, i, best;
    for (i = 0; i < GRID * GRID; ++i) nearest[i] = 1e30;
    for (count = 0; count < PICTURES && status == MS_OK; ++count) {
        for (i = 0, best = -1; i < GRID * GRID; ++i) /* the first is where most is known */
            if (confidence[i] > 0.5 && nearest[i] > apart &&
                (best < 0 || (count ? nearest[i] > nearest[best] : confidence[i] > confidence[best])))
                best = i;
        if (best < 0) break;
        map_point(grid, best % GRID, best / GRID, at);
        for (i = 0; i < GRID * GRID; ++i) {
            map_point(grid, i % GRID, i / GRID, other);
            nearest[i] = fmin(nearest[i], hypot(at[0] - other[0], at[1] - other[1]));
        }
        status = ms_gpr_latent_map(plane, at, 1, x, NULL, error);
        if (status == MS_OK) status = render((void *)(size_t)n, x, n->planes);
        if (status == MS_OK) map_picture(im, 0, HEAD, SIDE, grid, at, n->planes, n->size, PICTURE);
    }
    return status;
}

int main(int argc, char **argv)
{
    static const char *const title[3] = {"predicted score", "similarity to the best", "score \xd7 similarity"};
    static const char dots[] =
        "white: materials scored above 0; red: the best; black: variants of it; gray, ?: not known; line: half known";
    static const char *const unit[3] = {"score", "similar", "product"};
    static double preference[GRID * GRID], confidence[GRID * GRID], product[GRID * GRID], similar[COARSE * COARSE];
    static const float white[3] = {1, 1, 1}, red[3] = {1, 0.15f, 0.1f}, black[3] = {0, 0, 0};
    double lambda[VARIANTS], *x;
    variant_found variant[VARIANTS];
    variant_similarity similarity;
    ms_gpr_latent_options options;
    ms_gpr_latent_report report;
    ms_gpr_latent *plane = NULL;
    map_grid grid, coarse;
    ms_gpr *gp = NULL;
    ms_status status;
    ms_error error;
    const char *problem;
    char text[80];
    neural net;
    image im;
    scores s;
    int count, i, k;
    if (file_help(argc, argv, usage)) return file_end_stdout("latent");
    if (argc != 3 && argc != 4) return file_usage(usage);
    memset(&net, 0, sizeof net);
    problem = scores_read(argv[1], &s);
    if (problem) {
        fprintf(stderr, "latent: %s: %s", argv[1], problem);
        if (s.line > 0) fprintf(stderr, " (line %d)", s.line);
        fputs("\n", stderr);
        return 1;
    }
    if (argc == 4 && (problem = neural_load(argv[3], &net)) != NULL) {
        fprintf(stderr, "latent: %s: %s\n", argv[3], problem);
        return 1;
    }
    if (argc == 4 && net.parameters != s.m) return fail("the renderer draws materials of another number of parameters");
    x = (double *)malloc(LIKED * (size_t)s.m * sizeof *x);
    im = image_new(3 * SIDE, HEAD + SIDE + FOOT, 3);
    if (x == NULL || im.pixels == NULL) return fail("out of memory");
    count = liked(&s, x, LIKED);
    if (count < 2) return fail("a plane needs at least two materials with scores above 0");

    memset(&options, 0, sizeof options);
    options.prior = 0.1; /* keeps the plane compact */
    status = ms_gpr_fit(s.x, s.y, s.n, s.m, NULL, &gp, NULL, &error);
    if (status == MS_OK) status = ms_gpr_latent_fit(x, count, s.m, &options, &plane, &report, &error);
    if (status != MS_OK) return fail(error.message);

    grid = map_around(plane, GRID);
    coarse = map_around(plane, COARSE);
    memset(&similarity, 0, sizeof similarity);
    similarity.x = x;
    similarity.scale = argc == 4 ? 0.1 : 0.3; /* of pictures, of parameters in [0, 1] */
    similarity.pixels = 3 * (size_t)net.size * (size_t)net.size;
    similarity.render = render;
    similarity.user = &net;
    for (i = 0; i < VARIANTS; ++i) lambda[i] = (i + 1.0) / (VARIANTS + 1);
    status = map_preference(plane, gp, &grid, preference, &error);
    if (status == MS_OK) status = map_confidence(plane, &grid, confidence, &error);
    if (status == MS_OK) status = variants_map(plane, &similarity, &coarse, similar, &error);
    if (status == MS_OK)
        status = variants_find(plane, gp, &similarity, &grid, lambda, VARIANTS, 0, 0.07, variant, NULL, &error);
    if (status != MS_OK) return fail(error.message);
    map_product(&grid, preference, &coarse, similar, product);

    for (k = 0; k < 3; ++k) {
        const double *map = k == 0 ? preference : k == 1 ? similar : product;
        const map_grid *on = k == 1 ? &coarse : &grid;
        double least, most;
        int left = k * SIDE;
        map_draw(&im, left, HEAD, SIDE, on, map, &grid, confidence);
        map_range(on, map, &grid, confidence, &least, &most);
        if (k == 0 && argc == 4 && draw_pictures(&im, &net, plane, &grid, confidence, &error) != MS_OK)
            return fail(error.message);
        for (i = count - 1; i >= 0; --i)
            map_dot(&im, left, HEAD, SIDE, &grid, ms_gpr_latent_view_of(plane).points + 2 * i, i ? 3 : 5,
                    i ? white : red);
        for (i = 0; i < VARIANTS; ++i) map_dot(&im, left, HEAD, SIDE, &grid, variant[i].latent, 2.5, black);
        image_text_in(&im, left, 4, SIDE, title[k], 20, white);
        map_legend(&im, left + 4, HEAD + SIDE + 4, SIDE - 8, unit[k], least, most);
    }
    snprintf(text, sizeof text, "plane of ms_gpr_latent_fit, %.2g length scales wide", grid.x1 - grid.x0);
    image_text(&im, 6, HEAD + SIDE + 34, text, 16, white);
    image_text(&im, 3 * SIDE - 6 - image_text_width(dots, 16), HEAD + SIDE + 34, dots, 16, white);
    problem = image_write(argv[2], &im);
    if (problem) {
        fprintf(stderr, "latent: %s: %s\n", argv[2], problem);
        return 1;
    }
    printf("%d materials embedded: log likelihood %.1f, error %.3f\nlambda similarity score\n", count,
           report.likelihood, report.error);
    for (i = 0; i < VARIANTS; ++i) printf("%6.3f %10.3f %5.2f\n", lambda[i], variant[i].similarity, variant[i].score);
    ms_gpr_latent_destroy(plane);
    ms_gpr_destroy(gp);
    image_free(&im);
    neural_free(&net);
    scores_free(&s);
    free(x);
    return file_end_stdout("latent");
}
