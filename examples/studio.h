/* The workflow as a tool with a window would run it: a few calls, each short enough for a frame of 16 ms. ms_gpr.h,
   ms_nn.h and neural.h come first; scores.h is not needed.

     studio s;
     studio_open(&s, &renderer);                 a neural renderer that outlives it
     studio_score(&s, x, 7, &error);             whenever the user has scored a material      any state -> SCORED
     studio_update(&s, &error);                  every frame until s.settled                  SCORED    -> LEARNED
     studio_recommend(&s, 8, x, planes, &error); a row of the gallery                         LEARNED
     studio_choose(&s, x, &error);               a material was picked: the plane around it   LEARNED   -> EXPLORING
     studio_move(&s, dx, dy, &view, &error);     the mouse moved                              EXPLORING
     studio_close(&s);

   LEARNED and EXPLORING outlast further scores: the model takes them up at once, with the length scales it has, and
   s.settled says that studio_update has something to do again. A call in the wrong state is MS_INVALID_ARGUMENT and
   changes nothing. */
#ifndef EXAMPLES_STUDIO_H
#define EXAMPLES_STUDIO_H

enum { STUDIO_LIKED = 15 }; /* materials in the plane besides the chosen one */

typedef enum studio_state { STUDIO_EMPTY, STUDIO_SCORED, STUDIO_LEARNED, STUDIO_EXPLORING } studio_state;

typedef struct studio {
    studio_state state;
    int settled;            /* studio_update has nothing left to do */
    double likelihood;      /* of the scores, after the last update */
    const neural *renderer;
    ms_gpr *gp;
    ms_gpr_latent *plane;
    double at[2];           /* where in the plane */
    uint64_t seed;          /* of the next recommendations */
} studio;

typedef struct studio_view {
    const float *planes; /* the picture, valid until the next call */
    double score, sigma; /* predicted */
    double x[256];
} studio_view;

static inline ms_status studio__refuse(ms_error *error, const char *sentence)
{
    if (error) {
        error->status = MS_INVALID_ARGUMENT;
        error->position = 0;
        snprintf(error->message, sizeof error->message, "%s", sentence);
    }
    return MS_INVALID_ARGUMENT;
}

static inline void studio_open(studio *s, const neural *renderer)
{
    memset(s, 0, sizeof *s);
    s->renderer = renderer;
}

static inline void studio_close(studio *s)
{
    ms_gpr_latent_destroy(s->plane);
    ms_gpr_destroy(s->gp);
    memset(s, 0, sizeof *s);
}

/* n^2 multiply-adds for the n-th score. */
static inline ms_status studio_score(studio *s, const double *x, double score, ms_error *error)
{
    int m = s->renderer->parameters, k;
    double theta[258];
    ms_status status = MS_OK;
    if (m > 256) return studio__refuse(error, "more than 256 parameters");
    for (k = 0; k < m; ++k) theta[k] = log(sqrt((double)m)); /* a wide start: short length scales have no slope */
    theta[m] = log(3.0);
    theta[m + 1] = log(0.5);
    if (s->gp == NULL) status = ms_gpr_create(x, &score, 0, m, theta, NULL, &s->gp, error);
    if (status == MS_OK) status = ms_gpr_append(s->gp, x, score, error);
    if (status != MS_OK) return status;
    s->settled = 0;
    if (s->state == STUDIO_EMPTY) s->state = STUDIO_SCORED;
    return MS_OK;
}

/* Some steps of the fit from where it stands: as many evaluations of the likelihood as 8e7 multiply-adds make. */
static inline ms_status studio_update(studio *s, ms_error *error)
{
    int n = s->gp ? ms_gpr_count(s->gp) : 0, m = s->renderer->parameters;
    double evaluations = 8e7 / (0.5 * n * n * n + (double)n * n * m + 1);
    ms_gpr_fit_options options;
    ms_gpr_fit_report report;
    ms_gpr *better;
    ms_status status;
    if (s->state == STUDIO_EMPTY) return studio__refuse(error, "nothing was scored yet");
    memset(&options, 0, sizeof options);
    options.method = MS_GPR_METHOD_ML;
    options.floor_offset = 0.5;
    options.start = ms_gpr_theta(s->gp);
    options.evaluations = evaluations < 3 ? 3 : evaluations > 40 ? 40 : (int)evaluations;
    status = ms_gpr_fit(ms_gpr_inputs(s->gp), ms_gpr_scores(s->gp), n, m, &options, &better, &report, error);
    if (status != MS_OK) return status;
    s->settled = s->state != STUDIO_SCORED && report.likelihood - s->likelihood < 0.05;
    s->likelihood = report.likelihood;
    ms_gpr_destroy(s->gp);
    s->gp = better;
    if (s->state == STUDIO_SCORED) s->state = STUDIO_LEARNED;
    return MS_OK;
}

/* x [count][m] and their pictures, planes [count][3][size][size]. Other ones at every call. */
static inline ms_status studio_recommend(studio *s, int count, double *x, float *planes, ms_error *error)
{
    int m = s->renderer->parameters, i, k;
    size_t pixels = 3 * (size_t)s->renderer->size * (size_t)s->renderer->size;
    ms_gpr_recommend_options options;
    ms_status status;
    float row[256];
    if (s->state < STUDIO_LEARNED) return studio__refuse(error, "no taste was learned yet");
    memset(&options, 0, sizeof options);
    options.seed = s->seed++;
    status = ms_gpr_recommend(s->gp, &options, count, x, NULL, NULL, NULL, error);
    for (i = 0; i < count && status == MS_OK; ++i) {
        for (k = 0; k < m; ++k) row[k] = (float)x[i * m + k];
        neural_render(s->renderer, row, 1, planes + (size_t)i * pixels);
    }
    return status;
}

/* The rows of the `limit` best scores above 0, best first, into liked [limit][m]; how many. */
static inline int studio_liked(const ms_gpr *gp, int limit, double *liked)
{
    const double *y = ms_gpr_scores(gp), *x = ms_gpr_inputs(gp);
    int n = ms_gpr_count(gp), m = ms_gpr_dimensions(gp), taken[64], count, i, k;
    for (count = 0; count < limit && count < 64; ++count) {
        int best = -1;
        for (i = 0; i < n; ++i) {
            for (k = 0; k < count && taken[k] != i; ++k) {}
            if (k == count && y[i] > (best < 0 ? 0 : y[best])) best = i;
        }
        if (best < 0) break;
        taken[count] = best;
        memcpy(liked + (size_t)count * (size_t)m, x + (size_t)best * (size_t)m, (size_t)m * sizeof *liked);
    }
    return count;
}

/* Embeds the best-scored materials and the chosen one, x [m], and stands on it. */
static inline ms_status studio_choose(studio *s, const double *x, ms_error *error)
{
    static double liked[(STUDIO_LIKED + 1) * 256];
    int m = s->renderer->parameters, count;
    ms_gpr_latent_options options;
    ms_gpr_latent *plane;
    ms_status status;
    if (s->state < STUDIO_LEARNED) return studio__refuse(error, "no taste was learned yet");
    memset(&options, 0, sizeof options);
    options.prior = 0.1; /* keeps the plane compact */
    count = studio_liked(s->gp, STUDIO_LIKED, liked);
    memcpy(liked + (size_t)count * (size_t)m, x, (size_t)m * sizeof *liked);
    status = ms_gpr_latent_fit(liked, count + 1, m, &options, &plane, NULL, error);
    if (status != MS_OK) return status;
    ms_gpr_latent_destroy(s->plane);
    s->plane = plane;
    memcpy(s->at, ms_gpr_latent_points(plane) + 2 * count, sizeof s->at);
    s->state = STUDIO_EXPLORING;
    return MS_OK;
}

/* A step in the plane, in length scales, and what is seen there. */
static inline ms_status studio_move(studio *s, double dx, double dy, studio_view *view, ms_error *error)
{
    int m = s->renderer->parameters, k;
    double to[2], variance;
    float row[256];
    ms_status status;
    if (s->state != STUDIO_EXPLORING) return studio__refuse(error, "no material was chosen yet");
    to[0] = s->at[0] + dx;
    to[1] = s->at[1] + dy;
    status = ms_gpr_latent_map(s->plane, to, 1, view->x, NULL, error);
    for (k = 0; k < m && status == MS_OK; ++k) {
        view->x[k] = view->x[k] > 0 ? view->x[k] < 1 ? view->x[k] : 1 : 0;
        row[k] = (float)view->x[k];
    }
    if (status == MS_OK) status = ms_gpr_predict(s->gp, view->x, 1, &view->score, &variance, error);
    if (status != MS_OK) return status;
    view->sigma = sqrt(variance);
    neural_render(s->renderer, row, 1, s->renderer->planes);
    view->planes = s->renderer->planes;
    memcpy(s->at, to, sizeof to);
    return MS_OK;
}
#endif
