/* Taste, pictures and matches behind plain arrays, for other languages: no structs, no callbacks.

     cc -O2 -shared -fPIC -fvisibility=hidden -I. -Iexamples/tools examples/blender/flat.c -o libms_flat.so -lm
     x86_64-w64-mingw32-gcc -O2 -shared -static -I. -Iexamples/tools examples/blender/flat.c -o ms_flat.dll

   Calls that return int answer 0, or a status and a sentence in why [240]. Materials are x [count][m], each parameter
   in [0, 1]; low, high [m] is the box that answers keep, a locked parameter has low = high. What a call makes (a taste,
   a plane, a renderer) belongs to the caller until its _free. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "matcher.h"
#include "plane.h"

#ifdef _WIN32
#define FLAT __declspec(dllexport)
#else
#define FLAT __attribute__((visibility("default")))
#endif
#if defined(__GNUC__) && !defined(__cplusplus)
#pragma GCC diagnostic ignored "-Wmissing-prototypes" /* the callers are of other languages */
#endif

static int flat_answer(ms_status status, const ms_error *error, char *why)
{
    if (status != MS_OK) memcpy(why, error->message, sizeof error->message);
    return (int)status;
}

/* --- a taste: scores y [n], NaN where a material has none, and pairs [pair_count][2] of rows, the better one first ---
 */

FLAT int flat_taste(const double *x, double *y, int n, int m, const int *pairs, int pair_count, ms_gpr **taste,
                    char *why)
{
    static const double floor_score = 0;
    ms_gpr_fit_options options;
    ms_error error;
    int i;
    memset(&options, 0, sizeof options);
    options.floor = &floor_score;
    options.choices.rows = pairs;
    options.choices.count = pair_count;
    for (i = 0; i < n; ++i)
        if (y[i] != y[i]) y[i] = MS_GPR_UNSCORED;
    return flat_answer(ms_gpr_fit(x, y, n, m, &options, taste, NULL, &error), &error, why);
}

FLAT void flat_taste_free(ms_gpr *taste) { ms_gpr_destroy(taste); }

FLAT int flat_predict(const ms_gpr *taste, const double *x, int count, double *mean, double *variance, char *why)
{
    ms_error error;
    return flat_answer(ms_gpr_predict(taste, x, count, mean, variance, &error), &error, why);
}

/* What to score next; without a taste, the first gallery of m parameters. */
FLAT int flat_gallery(const ms_gpr *taste, int m, int count, int seed, const double *low, const double *high, double *x,
                      char *why)
{
    ms_gpr_gallery_options options;
    ms_gpr_view none;
    ms_gpr *blank = NULL;
    ms_error error;
    ms_status status = MS_OK;
    memset(&options, 0, sizeof options);
    options.seed = (uint64_t)seed;
    options.space.low = low;
    options.space.high = high;
    memset(&none, 0, sizeof none);
    none.m = m;
    if (taste == NULL) status = ms_gpr_create(&none, NULL, &blank, &error);
    if (status == MS_OK) status = ms_gpr_gallery(taste ? taste : blank, &options, count, x, &error);
    ms_gpr_destroy(blank);
    return flat_answer(status, &error, why);
}

/* Materials whose predicted scores (mean [count]) reach tau of the best; while too little is known, variants of what is
   liked. */
FLAT int flat_recommend(const ms_gpr *taste, int count, double tau, int seed, const double *low, const double *high,
                        double *x, double *mean, char *why)
{
    ms_gpr_recommend_options options;
    ms_error error;
    memset(&options, 0, sizeof options);
    options.tau = tau;
    options.seed = (uint64_t)seed;
    options.space.low = low;
    options.space.high = high;
    return flat_answer(ms_gpr_recommend(taste, &options, count, x, mean, NULL, NULL, &error), &error, why);
}

/* --- a renderer: a network from m parameters to a picture [3][size][size], as displayed --- */

FLAT int flat_renderer(const char *path, matcher **renderer, int *parameters, int *size, char *why)
{
    ms_error error;
    matcher *m = (matcher *)malloc(sizeof *m);
    ms_status status = MS_OUT_OF_MEMORY;
    snprintf(error.message, sizeof error.message, "%s", ms_status_string(status));
    if (m) status = matcher_open(m, path, &error); /* it must not move, so it is made where it stays */
    if (status != MS_OK) {
        free(m);
        return flat_answer(status, &error, why);
    }
    *renderer = m;
    *parameters = m->network.parameters;
    *size = m->network.size;
    return 0;
}

FLAT void flat_renderer_free(matcher *m)
{
    if (m) matcher_close(m);
    free(m);
}

/* A string of the file's metadata, or NULL; it lives as long as the renderer. */
FLAT const char *flat_metadata(const matcher *m, const char *key)
{
    return ms_nn_file_metadata(ms_nn_tensors(m->network.nn), key);
}

FLAT void flat_pictures(const matcher *m, const float *x, int count, float *planes)
{
    neural_render(&m->network, x, count, planes);
}

/* The material x whose picture comes nearest to target; weight (both [3][size][size]) says what of it counts, source is
   a first guess; either may be NULL. What no material explains, such as a stroke of the brush, is left out. */
FLAT int flat_match(matcher *m, const float *target, const float *weight, const double *source, const double *low,
                    const double *high, double *x, float *picture, double *rmse, char *why)
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    ms_status status;
    options.candidates = source;
    options.candidate_count = source != NULL;
    options.random_count = 64;
    options.refine.max_cost = 300;
    options.refine.restarts = 4;
    m->renderer.lower = low;
    m->renderer.upper = high;
    status = matcher_match(m, target, weight, &options, MATCHER_ROBUST, x, picture, &result, NULL, &error);
    m->renderer.lower = m->renderer.upper = NULL;
    if (status == MS_OK) *rmse = result.rmse;
    return flat_answer(status, &error, why);
}

/* --- a plane of variants: liked materials [count][m] laid out so that neighbors look alike --- */

/* box [4]: x0, y0, x1, y1 of a square that holds the plane. */
FLAT int flat_plane(const double *liked, int count, int m, const double *low, const double *high, ms_gpr_latent **plane,
                    double *box, char *why)
{
    ms_gpr_latent_options options;
    map_grid grid;
    ms_error error;
    ms_status status;
    memset(&options, 0, sizeof options);
    options.space.low = low;
    options.space.high = high;
    status = ms_gpr_latent_fit(liked, count, m, &options, plane, NULL, &error);
    if (status != MS_OK) return flat_answer(status, &error, why);
    grid = map_around(*plane, 2);
    memcpy(box, &grid, 4 * sizeof *box);
    return 0;
}

FLAT void flat_plane_free(ms_gpr_latent *plane) { ms_gpr_latent_destroy(plane); }

FLAT int flat_plane_map(const ms_gpr_latent *plane, const double *latent, int count, double *x, char *why)
{
    ms_error error;
    return flat_answer(ms_gpr_latent_map(plane, latent, count, x, NULL, &error), &error, why);
}
