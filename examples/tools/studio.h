/* The workflow as a tool with a window would run it: a few calls, each short enough for a frame of 16 ms up to some 200
   scores. ms_gpr.h comes first; pictures come from a callback, such as a neural renderer (neural.h).

     studio s;
     studio_open(&s, &renderer, &error);         19 parameters, what draws them, and how large a picture is
     studio_gallery(&s, 10, x, planes, &error);  materials to be scored next                         any state
     if (studio_wants_picks(s.gp)) ...           show nine, ask for the best two: scores alone find nothing
     studio_score(&s, x, 7, &error);             whenever the user has scored a material             any state -> SCORED
     studio_rescore(&s, 3, 2, &error);           thought again about the fourth one
     studio_pick(&s, x, 9, best, 2, &error);     of 9 materials that were shown the two that were clicked     any state
     -> SCORED
     studio_better(&s, a, b, &error);            this one rather than that one
     studio_like(&s, x, 3, &error);              more like these
     studio_avoid(&s, x, &error);                not like this one
     studio_undo(&s, &error);                    takes back the last of these six
     studio_update(&s, &error);                  every frame until s.settled                         SCORED    ->
     LEARNED
     studio_recommend(&s, 8, x, planes, &error); a row of recommendations                            LEARNED
     studio_choose(&s, x, &error);               a material was picked: the plane around it          LEARNED   ->
     EXPLORING
     studio_move(&s, dx, dy, &view, &error);     the mouse moved                                     EXPLORING
     if (s.outlier.row >= 0) ...                 an answer that looks like a slip: ask         after an update
     studio_save(&s, "session.txt", &error);     all of it as text: answers, what is avoided and kept, undo, the plane
     studio_load(&s, "session.txt", &error);     in place of what a studio that is open holds
     studio_close(&s);

   Scores may come one by one with updates between them, in any order, on any scale, and picks beside or in place of
   them: after five galleries of "the best 2 of 9" half as many scores do. Without any score predictions have a scale of
   their own: 0 is indifferent. LEARNED and EXPLORING outlast further scores and picks:
   the model takes them up at once, with the length scales it has, and s.settled says that studio_update has something
   to do again. A call in the wrong state is MS_INVALID_ARGUMENT and changes nothing. */
#ifndef EXAMPLES_STUDIO_H
#define EXAMPLES_STUDIO_H
#include "files.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
    STUDIO_LIKED = 15 /* materials in the plane besides the chosen one */,
    STUDIO_OTHERS = 20 /* that likes are compared with */,
    STUDIO_ANSWERS = 60 /* materials after which something should be liked */,
    STUDIO_UNDO = 64
};

typedef enum studio_state { STUDIO_EMPTY, STUDIO_SCORED, STUDIO_LEARNED, STUDIO_EXPLORING } studio_state;

/* Draws `count` materials x [count][parameters] into planes [count][values]. */
typedef struct studio_renderer {
    int parameters;
    size_t values; /* of a picture */
    void (*render)(void *user, const float *x, int count, float *planes);
    void *user;
} studio_renderer;

typedef struct studio {
    studio_state state;
    int settled;              /* studio_update has nothing left to do */
    double objective;         /* of the model, after the last update */
    ms_gpr_fit_options learn; /* may be set after studio_open: floor, noise, ... */
    studio_renderer renderer;
    ms_gpr *gp;
    ms_gpr_latent *plane;
    double at[2];                /* where in the plane */
    uint64_t seed;               /* of the next recommendations */
    int search;                  /* which start studio_update works on: 0 where it stands, 1 to 3 the fit's own */
    double *theta, reached;      /* [m + 2] how far that start has come, and its objective */
    int probe, switched, probed; /* the next column to be probed, or -1; whether one was switched; all were, once */
    double cost[2];              /* processor seconds that an evaluation takes, and a probe, as measured; 0: not yet */
    ms_gpr_outlier outlier;      /* of the last update; row -1: none */
    double *embedded;            /* [embedded_count][m] materials of the plane */
    int embedded_count;
    double *owned[3];    /* what a loaded space points at: low, high, steps; */
    int *equal;          /* equal columns, */
    ms_gpr_list *lists;  /* and lists, [space.list_count] */
    double *x;           /* [m] a material, */
    float *row, *planes; /* [m] the same, and its picture */
    ms_gpr_space space;  /* what galleries, recommendations and the plane keep; may be set after studio_open, of arrays
                            that last */
    double least;        /* what "none of these" scores; may be set after studio_open where scores do not begin at 0 */
    double *others,
        *avoid; /* [STUDIO_OTHERS][m] what likes are compared with; [avoids][m] what recommendations keep away from */
    int avoids;
    struct {
        int kind, index;
        double score;
        int pairs;
    } undo[STUDIO_UNDO]; /* kind: the row `index` was added, scored anew, rows from
              `index` on and comparisons were added, a material is avoided */
    int undos;
} studio;

typedef struct studio_view {
    const float *planes; /* the picture, valid until the next call */
    const double *x;     /* [parameters] the material, as long */
    double score, sigma; /* predicted */
} studio_view;

static inline ms_status studio__refuse(ms_error *error, ms_status status, const char *sentence)
{
    if (error) {
        error->status = status;
        error->position = 0;
        snprintf(error->message, sizeof error->message, "%s", sentence);
    }
    return status;
}

static inline void studio_close(studio *s)
{
    int i;
    ms_gpr_latent_destroy(s->plane);
    ms_gpr_destroy(s->gp);
    free(s->theta);
    free(s->x);
    free(s->row);
    free(s->planes);
    free(s->others);
    free(s->avoid);
    free(s->embedded);
    for (i = 0; i < 3; ++i) free(s->owned[i]);
    free(s->equal);
    for (i = 0; s->lists && i < s->space.list_count; ++i)
        free((void *)(uintptr_t)s->lists[i].columns), free((void *)(uintptr_t)s->lists[i].rows);
    free(s->lists);
    memset(s, 0, sizeof *s);
}

static inline ms_status studio_open(studio *s, const studio_renderer *renderer, ms_error *error)
{
    size_t m = (size_t)renderer->parameters;
    int k;
    memset(s, 0, sizeof *s);
    s->outlier.row = s->probe = -1;
    s->renderer = *renderer;
    s->theta = (double *)malloc((m + 2) * sizeof(double));
    s->x = (double *)malloc(m * sizeof(double));
    s->row = (float *)malloc(m * sizeof(float));
    s->planes = (float *)malloc(renderer->values * sizeof(float));
    if (s->theta && s->x && s->row && s->planes) {
        for (k = 0; k < (int)m + 2; ++k) s->theta[k] = k < (int)m ? log(sqrt((double)m)) : 0;
        s->theta[m + 1] = -2;
        if (ms_gpr_create(NULL, NULL, 0, (int)m, s->theta, NULL, &s->gp, error) == MS_OK) return MS_OK;
    }
    studio_close(s);
    return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a session");
}

static inline void studio__changed(studio *s)
{
    s->settled = 0;
    s->search = s->switched = s->probed = 0;
    s->outlier.row = s->probe = -1;
    s->reached = s->objective = -1e300;
    memcpy(s->theta, ms_gpr_view_of(s->gp).theta, ((size_t)s->renderer.parameters + 2) * sizeof(double));
}

enum { STUDIO__ADDED, STUDIO__SCORED, STUDIO__COMPARED, STUDIO__AVOIDED };

static inline void studio__remember(studio *s, int kind, int index, double score, int pairs)
{
    if (s->undos == STUDIO_UNDO) memmove(s->undo, s->undo + 1, sizeof s->undo - sizeof s->undo[0]), --s->undos;
    s->undo[s->undos].kind = kind;
    s->undo[s->undos].index = index;
    s->undo[s->undos].score = score;
    s->undo[s->undos++].pairs = pairs;
}

/* n^2 multiply-adds for the n-th score. */
static inline ms_status studio_score(studio *s, const double *x, double score, ms_error *error)
{
    ms_status status = ms_gpr_append(s->gp, x, score, error);
    if (status != MS_OK) return status;
    studio__remember(s, STUDIO__ADDED, ms_gpr_view_of(s->gp).n - 1, 0, 0);
    studio__changed(s);
    if (s->state == STUDIO_EMPTY) s->state = STUDIO_SCORED;
    return MS_OK;
}

/* Another score for material `index`, counted from 0 in the order of studio_score. */
static inline ms_status studio_rescore(studio *s, int index, double score, ms_error *error)
{
    double before = index >= 0 && index < ms_gpr_view_of(s->gp).n ? ms_gpr_view_of(s->gp).y[index] : 0;
    ms_status status = ms_gpr_rescore(s->gp, index, score, error);
    if (status != MS_OK) return status;
    studio__remember(s, STUDIO__SCORED, index, before, 0);
    studio__changed(s);
    return MS_OK;
}

/* The rows of materials x [count][m] in the model, into row [count]: those that are there already, or new ones behind
   them, which are copied to fresh [count][m]. How many are fresh. */
static inline int studio__rows(const studio *s, const double *x, int count, int *row, double *fresh)
{
    const double *rows = ms_gpr_view_of(s->gp).x;
    int m = s->renderer.parameters, n = ms_gpr_view_of(s->gp).n, added = 0, i, k;
    size_t size = (size_t)m * sizeof *x;
    for (i = 0; i < count; ++i, x += m) {
        for (k = 0; k < n + added; ++k)
            if (memcmp(k < n ? rows + (size_t)k * (size_t)m : fresh + (size_t)(k - n) * (size_t)m, x, size) == 0) break;
        if (k == n + added) memcpy(fresh + (size_t)added++ * (size_t)m, x, size);
        row[i] = k;
    }
    return added;
}

/* The first `better` of the materials x [count][m] are preferred to each of the others; 0: all have the least score. */
static inline ms_status studio__prefer(studio *s, const double *x, int count, int better, ms_error *error)
{
    int n = ms_gpr_view_of(s->gp).n, before = ms_gpr_view_of(s->gp).pair_count, pairs = before, added, i, k;
    int *row = (int *)malloc((size_t)count * sizeof *row),
        *pair = (int *)malloc(2 * (size_t)(before + better * (count - better) + 1) * sizeof *pair);
    double *fresh = (double *)malloc((size_t)count * (size_t)s->renderer.parameters * sizeof *fresh);
    ms_status status = row && pair && fresh ? MS_OK
                                            : studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
    if (status == MS_OK) {
        added = studio__rows(s, x, count, row, fresh);
        if (before > 0) memcpy(pair, ms_gpr_view_of(s->gp).pairs, 2 * (size_t)before * sizeof *pair);
        for (i = 0; i < better; ++i)
            for (k = better; k < count; ++k) {
                if (row[i] == row[k]) continue;
                pair[2 * pairs] = row[i];
                pair[2 * pairs++ + 1] = row[k];
            }
        status = ms_gpr_compare(s->gp, fresh, added, pair, pairs, error);
        for (i = 0; i < count && better == 0 && status == MS_OK; ++i)
            if (row[i] >= n) status = ms_gpr_rescore(s->gp, row[i], s->least, error);
    }
    free(row), free(pair), free(fresh);
    if (status != MS_OK) return status;
    studio__remember(s, STUDIO__COMPARED, n, 0, before);
    studio__changed(s);
    if (s->state == STUDIO_EMPTY) s->state = STUDIO_SCORED;
    return MS_OK;
}

/* Of the materials x [count][m] that were shown those whose indices picked [picks] names, rather than all the others:
   "the best 2 of 9". picks 0: none of these; those that were not scored before get the least score. Some 2 n^3
   multiply-adds, n the materials that were scored or shown. */
static inline ms_status studio_pick(studio *s, const double *x, int count, const int *picked, int picks,
                                    ms_error *error)
{
    int m = s->renderer.parameters, at = 0, pass, i, k;
    double *sorted;
    ms_status status;
    if (count < 1 || picks < 0 || picks >= count)
        return studio__refuse(error, MS_INVALID_ARGUMENT, "a pick is of none, or some, but not of all");
    for (i = 0; i < picks; ++i) {
        if (picked[i] < 0 || picked[i] >= count)
            return studio__refuse(error, MS_INVALID_ARGUMENT, "a picked material was not shown");
        for (k = 0; k < i; ++k)
            if (picked[i] == picked[k])
                return studio__refuse(error, MS_INVALID_ARGUMENT, "a material was picked twice");
    }
    sorted = (double *)malloc((size_t)count * (size_t)m * sizeof *sorted);
    if (sorted == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
    for (pass = 1; pass >= 0; --pass)
        for (i = 0; i < count; ++i) {
            int is = 0;
            for (k = 0; k < picks; ++k) is |= picked[k] == i;
            if (is == pass) memcpy(sorted + (size_t)at++ * (size_t)m, x + (size_t)i * (size_t)m, (size_t)m * sizeof *x);
        }
    status = studio__prefer(s, sorted, count, picks, error);
    free(sorted);
    return status;
}

/* Material a [m] rather than b [m]. */
static inline ms_status studio_better(studio *s, const double *a, const double *b, ms_error *error)
{
    size_t m = (size_t)s->renderer.parameters;
    double *both = (double *)malloc(2 * m * sizeof *both);
    ms_status status;
    if (both == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
    memcpy(both, a, m * sizeof *both);
    memcpy(both + m, b, m * sizeof *both);
    status = memcmp(a, b, m * sizeof *a) ? studio__prefer(s, both, 2, 1, error)
                                         : studio__refuse(error, MS_INVALID_ARGUMENT, "both materials are the same");
    free(both);
    return status;
}

/* More like these, x [count][m]: each is preferred to materials that are spread evenly over all there are. */
static inline ms_status studio_like(studio *s, const double *x, int count, ms_error *error)
{
    size_t m = (size_t)s->renderer.parameters;
    double *all;
    ms_status status = MS_OK;
    if (count < 1) return studio__refuse(error, MS_INVALID_ARGUMENT, "nothing is liked");
    if (s->others == NULL) {
        ms_gpr_gallery_options options;
        memset(&options, 0, sizeof options);
        options.kind = MS_GPR_GALLERY_SPREAD;
        s->others = (double *)malloc(STUDIO_OTHERS * m * sizeof *s->others);
        if (s->others == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
        status = ms_gpr_gallery(s->gp, &options, STUDIO_OTHERS, s->others, error);
        if (status != MS_OK) {
            free(s->others);
            s->others = NULL;
            return status;
        }
    }
    all = (double *)malloc(((size_t)count + STUDIO_OTHERS) * m * sizeof *all);
    if (all == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
    memcpy(all, x, (size_t)count * m * sizeof *all);
    memcpy(all + (size_t)count * m, s->others, STUDIO_OTHERS * m * sizeof *all);
    status = studio__prefer(s, all, count + STUDIO_OTHERS, count, error);
    free(all);
    return status;
}

/* Not like this one, x [m]: recommendations keep away from it; what was learned stays as it is. */
static inline ms_status studio_avoid(studio *s, const double *x, ms_error *error)
{
    size_t m = (size_t)s->renderer.parameters;
    double *more = (double *)realloc(s->avoid, ((size_t)s->avoids + 1) * m * sizeof *more);
    if (more == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a material");
    s->avoid = more;
    memcpy(s->avoid + (size_t)s->avoids++ * m, x, m * sizeof *x);
    studio__remember(s, STUDIO__AVOIDED, 0, 0, 0);
    return MS_OK;
}

/* Takes back the last score, rescore, pick, like or avoid, up to STUDIO_UNDO of them. */
static inline ms_status studio_undo(studio *s, ms_error *error)
{
    ms_status status = MS_OK;
    int index, n = ms_gpr_view_of(s->gp).n, i;
    if (s->undos == 0) return studio__refuse(error, MS_INVALID_ARGUMENT, "there is nothing to undo");
    index = s->undo[s->undos - 1].index;
    switch (s->undo[s->undos - 1].kind) {
    case STUDIO__ADDED: status = ms_gpr_drop(s->gp, index, error); break;
    case STUDIO__SCORED: status = ms_gpr_rescore(s->gp, index, s->undo[s->undos - 1].score, error); break;
    case STUDIO__COMPARED: {
        size_t size = 2 * (size_t)s->undo[s->undos - 1].pairs * sizeof(int);
        int *pairs = (int *)malloc(size + 1);
        if (pairs == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for comparisons");
        if (size > 0) memcpy(pairs, ms_gpr_view_of(s->gp).pairs, size);
        status = ms_gpr_compare(s->gp, NULL, 0, pairs, s->undo[s->undos - 1].pairs, error);
        free(pairs);
        for (i = n - 1; i >= index && status == MS_OK; --i) status = ms_gpr_drop(s->gp, i, error);
        break;
    }
    default: --s->avoids;
    }
    if (status != MS_OK) return status;
    if (s->undo[--s->undos].kind == STUDIO__AVOIDED) return MS_OK;
    studio__changed(s);
    if (ms_gpr_view_of(s->gp).n == 0) s->state = STUDIO_EMPTY;
    return MS_OK;
}

/* Some steps of the fit: from where the model stands, then from each of the fit's own starts, until it gains no more
   and no other length of a column is better; the best of all is the model. As many evaluations of the likelihood at a
   time as fit into 8 ms, by what they took before. */
static inline ms_status studio_update(studio *s, ms_error *error)
{
    static const double length[] = {0.25, 0.5, 3}; /* widths, times sqrt(m) */
    int n = ms_gpr_view_of(s->gp).n, m = s->renderer.parameters, probing = s->probe >= 0, next = 0, count,
        least = s->reached > -1e300 ? 3 : 2;
    size_t size = ((size_t)m + 2) * sizeof(double);
    double cost = probing && !(s->cost[1] > 0) ? 2 * s->cost[0] : s->cost[probing], gain; /* a first probe: a guess */
    ms_gpr_fit_options options = s->learn;
    ms_gpr_fit_report report;
    ms_gpr *found;
    ms_status status;
    clock_t clocks;
    if (s->state == STUDIO_EMPTY) return studio__refuse(error, MS_INVALID_ARGUMENT, "nothing was scored yet");
    if (s->settled) return MS_OK;
    if (s->search == 0 || s->reached > -1e300) options.start = s->theta;
    else options.length_start = length[s->search - 1] * sqrt((double)m);
    count = cost > 0 ? (int)fmin(0.008 / cost, 40) : 2;
    options.evaluations = probing ? 1 : count < least ? least : count;
    options.probe_first = probing ? s->probe : 0;
    options.probes = !probing ? -1 : count < 3 ? 1 : count - 1; /* the model is conditioned once more, too */
    options.pairs = ms_gpr_view_of(s->gp).pairs;
    options.pair_count = ms_gpr_view_of(s->gp).pair_count;
    clocks = clock();
    status = ms_gpr_fit(ms_gpr_view_of(s->gp).x, ms_gpr_view_of(s->gp).y, n, m, &options, &found, &report, error);
    if (status != MS_OK) return status;
    s->cost[probing] = (double)(clock() - clocks) / CLOCKS_PER_SEC / (report.evaluations + 1);
    memcpy(s->theta, ms_gpr_view_of(found).theta, size);
    gain = report.objective - s->reached;
    s->reached = report.objective;
    if (report.objective > s->objective) {
        ms_gpr_destroy(s->gp);
        s->gp = found;
        s->objective = report.objective;
        s->outlier = report.outlier;
    } else {
        ms_gpr_destroy(found);
    }
    if (s->probe >= 0) {
        s->switched |= report.probes > 0;
        s->probe += options.probes;
        if (s->probe >= m) {
            s->probe = -1;
            s->probed = 1;
            next = !s->switched;
        }
    } else if (gain < 0.05) { /* this start is at its end, but for columns that it overlooked */
        next = s->probed;
        if (!next) s->probe = s->switched = 0;
    }
    if (next) {
        s->settled = s->search == 3;
        ++s->search;
        s->probed = 0;
        s->reached = -1e300;
    }
    if (s->state == STUDIO_SCORED) s->state = STUDIO_LEARNED;
    return MS_OK;
}

static inline void studio__draw(studio *s, const double *x, float *planes)
{
    int k;
    for (k = 0; k < s->renderer.parameters; ++k) s->row[k] = (float)x[k];
    s->renderer.render(s->renderer.user, s->row, 1, planes);
}

/* Materials x [count][m] to be scored next, and their pictures, planes [count][values] (NULL: none): the first ones
   evenly spread, later ones those that the recommendations depend on most. */
static inline ms_status studio_gallery(studio *s, int count, double *x, float *planes, ms_error *error)
{
    ms_gpr_gallery_options options;
    ms_status status;
    int i;
    memset(&options, 0, sizeof options);
    options.seed = s->seed++;
    options.space = s->space;
    status = ms_gpr_gallery(s->gp, &options, count, x, error);
    for (i = 0; i < count && planes && status == MS_OK; ++i)
        studio__draw(s, x + i * s->renderer.parameters, planes + (size_t)i * s->renderer.values);
    return status;
}

/* Whether a tool should ask for picks (studio_pick: the best two of nine, or none of them) in place of scores. It
   should where fewer than three of STUDIO_ANSWERS materials or more are liked and confirmed: predicted from the other
   answers (leave-one-out) halfway from the floor to the best score. A wrong answer alone is not confirmed. */
static inline int studio_wants_picks(const ms_gpr *gp)
{
    const ms_gpr_view view = ms_gpr_view_of(gp);
    double best = view.floor, noise, *mean, *variance;
    int confirmed = 0, i;
    if (view.n < STUDIO_ANSWERS || (mean = (double *)malloc(2 * (size_t)view.n * sizeof *mean)) == NULL) return 0;
    variance = mean + view.n;
    noise = exp(2 * view.theta[view.m + 1]);
    for (i = 0; i < view.n; ++i) best = fmax(best, view.value[i]);
    if (ms_gpr_predict(gp, view.x, view.n, mean, variance, NULL) != MS_OK) confirmed = view.n;
    for (i = 0; i < view.n && confirmed < view.n; ++i) {
        double expected = mean[i];
        if (view.y[i] > MS_GPR_UNSCORED)
            expected = view.y[i] - (view.y[i] - mean[i]) / fmax(1 - variance[i] / noise, 1e-6);
        confirmed += view.value[i] > view.floor && expected > 0.5 * (view.floor + best);
    }
    free(mean);
    return confirmed < 3;
}

/* x [count][m] and their pictures, planes [count][values] (NULL: none). Other ones at every call. */
static inline ms_status studio_recommend(studio *s, int count, double *x, float *planes, ms_error *error)
{
    ms_gpr_recommend_options options;
    ms_status status;
    int i;
    if (s->state < STUDIO_LEARNED) return studio__refuse(error, MS_INVALID_ARGUMENT, "no taste was learned yet");
    memset(&options, 0, sizeof options);
    options.seed = s->seed++;
    options.space = s->space;
    options.avoid = s->avoid;
    options.avoid_count = s->avoids;
    status = ms_gpr_recommend(s->gp, &options, count, x, NULL, NULL, NULL, error);
    for (i = 0; i < count && planes && status == MS_OK; ++i)
        studio__draw(s, x + i * s->renderer.parameters, planes + (size_t)i * s->renderer.values);
    return status;
}

/* The rows of the `limit` best scores above the floor, best first, into liked [limit][m]; how many. x [m] is left out
   where it is one of them (NULL: nothing is). */
static inline int studio_liked(const ms_gpr *gp, int limit, const double *x, double *liked)
{
    const double *y = ms_gpr_view_of(gp).value, *rows = ms_gpr_view_of(gp).x;
    int n = ms_gpr_view_of(gp).n, count = 0, last = -1, i;
    size_t m = (size_t)ms_gpr_view_of(gp).m;
    while (count < limit) {
        int best = -1;
        for (i = 0; i < n; ++i) /* the next in the order of falling scores, then of rows */
            if (y[i] > ms_gpr_view_of(gp).floor && (last < 0 || y[i] < y[last] || (!(y[i] > y[last]) && i > last)) &&
                (best < 0 || y[i] > y[best]))
                best = i;
        if (best < 0) break;
        last = best;
        if (x == NULL || memcmp(x, rows + (size_t)best * m, m * sizeof *x) != 0)
            memcpy(liked + (size_t)count++ * m, rows + (size_t)best * m, m * sizeof *liked);
    }
    return count;
}

/* The plane of materials x [count][m]. */
static inline ms_status studio__embed(studio *s, const double *x, int count, ms_error *error)
{
    ms_gpr_latent_options options;
    ms_gpr_latent *plane;
    ms_status status;
    memset(&options, 0, sizeof options);
    options.prior = 0.1; /* keeps the plane compact */
    options.space = s->space;
    status = ms_gpr_latent_fit(x, count, s->renderer.parameters, &options, &plane, NULL, error);
    if (status != MS_OK) return status;
    ms_gpr_latent_destroy(s->plane);
    s->plane = plane;
    return MS_OK;
}

/* Embeds the best-scored materials and the chosen one, x [m], and stands on it. */
static inline ms_status studio_choose(studio *s, const double *x, ms_error *error)
{
    int m = s->renderer.parameters, count;
    ms_status status;
    double *liked;
    if (s->state < STUDIO_LEARNED) return studio__refuse(error, MS_INVALID_ARGUMENT, "no taste was learned yet");
    liked = (double *)malloc((STUDIO_LIKED + 1) * (size_t)m * sizeof *liked);
    if (liked == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for the materials of a plane");
    count = studio_liked(s->gp, STUDIO_LIKED, x, liked);
    memcpy(liked + (size_t)count * (size_t)m, x, (size_t)m * sizeof *liked);
    status = count > 0
        ? studio__embed(s, liked, count + 1, error)
        : studio__refuse(
              error, MS_INVALID_ARGUMENT,
              "nothing else is liked yet: a plane needs another material that was scored above the lowest score");
    if (status != MS_OK) free(liked);
    if (status != MS_OK) return status;
    free(s->embedded);
    s->embedded = liked;
    s->embedded_count = count + 1;
    memcpy(s->at, ms_gpr_latent_points(s->plane) + 2 * count, sizeof s->at);
    s->state = STUDIO_EXPLORING;
    return MS_OK;
}

static inline int studio__keeps(const studio *s)
{
    return s->space.low || s->space.high || s->space.steps || s->space.equal_count || s->space.list_count;
}

/* A step in the plane, in length scales, and what is seen there. It ends where the plane knows less than a quarter, but
   may always lead to where it knows more. */
static inline ms_status studio_move(studio *s, double dx, double dy, studio_view *view, ms_error *error)
{
    int m = s->renderer.parameters, k;
    double to[2], variance, here, there, sf2;
    ms_status status;
    int halvings;
    if (s->state != STUDIO_EXPLORING) return studio__refuse(error, MS_INVALID_ARGUMENT, "no material was chosen yet");
    sf2 = exp(2 * ms_gpr_latent_theta(s->plane)[2]);
    status = ms_gpr_latent_map(s->plane, s->at, 1, NULL, &here, error);
    for (halvings = 0; halvings < 8 && status == MS_OK; ++halvings, dx *= 0.5, dy *= 0.5) {
        to[0] = s->at[0] + dx;
        to[1] = s->at[1] + dy;
        status = ms_gpr_latent_map(s->plane, to, 1, NULL, &there, error);
        if (status != MS_OK || there < 0.75 * sf2 || there < here)
            break; /* variances: knowing a quarter leaves three */
    }
    if (status != MS_OK) return status;
    if (halvings == 8) memcpy(to, s->at, sizeof to);
    status = ms_gpr_latent_map(s->plane, to, 1, s->x, NULL, error);
    for (k = 0; k < m && status == MS_OK && !studio__keeps(s); ++k)
        s->x[k] = s->x[k] > 0 ? s->x[k] < 1 ? s->x[k] : 1 : 0;
    if (status == MS_OK) status = ms_gpr_predict(s->gp, s->x, 1, &view->score, &variance, error);
    if (status != MS_OK) return status;
    view->sigma = sqrt(variance);
    studio__draw(s, s->x, s->planes);
    view->planes = s->planes;
    view->x = s->x;
    memcpy(s->at, to, sizeof to);
    return MS_OK;
}

/* --- a session as text: a line for every array, its name, how many numbers, the numbers --- */

static inline void studio__put(FILE *f, const char *name, const double *v, int count)
{
    char text[48];
    int i;
    fprintf(f, "%s %d", name, v ? count : 0);
    for (i = 0; v && i < count; ++i) fprintf(f, " %s", number_text(text, "%.17g", v[i]));
    fprintf(f, "\n");
}

static inline void studio__put_ints(FILE *f, const char *name, const int *v, int count)
{
    int i;
    fprintf(f, "%s %d", name, count);
    for (i = 0; i < count; ++i) fprintf(f, " %d", v[i]);
    fprintf(f, "\n");
}

/* The whole session in one file: answers, what is avoided, what is kept, undo, the plane and the place in it. */
static inline ms_status studio_save(const studio *s, const char *path, ms_error *error)
{
    int m = s->renderer.parameters, n = ms_gpr_view_of(s->gp).n, i;
    double numbers[7], undo[4 * STUDIO_UNDO];
    file_out out;
    FILE *f = file_create(path, &out);
    const char *problem;
    if (f == NULL) return studio__refuse(error, MS_IO, out.problem);
    numbers[0] = m, numbers[1] = (int)s->state, numbers[2] = s->settled, numbers[3] = (double)s->seed;
    numbers[4] = s->least, numbers[5] = s->at[0], numbers[6] = s->at[1];
    for (i = 0; i < s->undos; ++i) {
        undo[4 * i] = s->undo[i].kind, undo[4 * i + 1] = s->undo[i].index;
        undo[4 * i + 2] = s->undo[i].score, undo[4 * i + 3] = s->undo[i].pairs;
    }
    fprintf(f, "studio session 1\n");
    studio__put(f, "session", numbers, 7);
    studio__put(f, "theta", ms_gpr_view_of(s->gp).theta, m + 2);
    studio__put(f, "materials", ms_gpr_view_of(s->gp).x, n * m);
    studio__put(f, "scores", ms_gpr_view_of(s->gp).y, n);
    studio__put_ints(f, "pairs", ms_gpr_view_of(s->gp).pairs, 2 * ms_gpr_view_of(s->gp).pair_count);
    studio__put(f, "others", s->others, STUDIO_OTHERS * m);
    studio__put(f, "avoid", s->avoid, s->avoids * m);
    studio__put(f, "undo", undo, 4 * s->undos);
    studio__put(f, "plane", s->embedded, s->embedded_count * m);
    studio__put(f, "low", s->space.low, m);
    studio__put(f, "high", s->space.high, m);
    studio__put(f, "steps", s->space.steps, m);
    studio__put_ints(f, "equal", s->space.equal, 2 * s->space.equal_count);
    fprintf(f, "lists %d\n", s->space.list_count);
    for (i = 0; i < s->space.list_count; ++i) {
        studio__put_ints(f, "columns", s->space.lists[i].columns, s->space.lists[i].width);
        studio__put(f, "rows", s->space.lists[i].rows, s->space.lists[i].width * s->space.lists[i].count);
    }
    problem = file_finish(&out, !ferror(f));
    return problem ? studio__refuse(error, MS_IO, problem) : MS_OK;
}

/* The array that must come next, to be freed (NULL where it has no numbers); *count: -1 where it is not there. */
static inline double *studio__get(char **text, const char *name, int *count)
{
    size_t length = strlen(name);
    double *v = NULL;
    char *end;
    long numbers;
    int i;
    *count = -1;
    if (strncmp(*text, name, length) != 0 || (*text)[length] != ' ') return NULL;
    numbers = strtol(*text + length, &end, 10);
    if (end == *text + length || numbers < 0 || numbers > 100000000 || (size_t)numbers > strlen(end)) return NULL;
    if (numbers > 0 && (v = (double *)malloc((size_t)numbers * sizeof *v)) == NULL) return NULL;
    for (i = 0; i < numbers; ++i) {
        char *from = end;
        v[i] = number_read(from, '.', &end);
        if (end == from) break;
    }
    if (i == numbers && *end == '\n') {
        *text = end + 1;
        *count = (int)numbers;
        return v;
    }
    free(v);
    return NULL;
}

/* The same as whole numbers. */
static inline int *studio__get_ints(char **text, const char *name, int *count)
{
    double *v = studio__get(text, name, count);
    int *whole = *count > 0 ? (int *)malloc((size_t)*count * sizeof *whole) : NULL, i;
    for (i = 0; i < *count && whole; ++i) {
        whole[i] = v[i] >= -2e9 && v[i] <= 2e9 ? (int)v[i] : -1;
    }
    if (*count > 0 && whole == NULL) *count = -1;
    free(v);
    return whole;
}

/* The session from its text into s, which is open and empty. */
static inline ms_status studio__parse(studio *s, char *text, ms_error *error)
{
    static const char title[] = "studio session 1\n";
    static const char *const space[] = {"low", "high", "steps"};
    int m = s->renderer.parameters, count[6], n, lists, pair_numbers, i, good;
    double *v, *theta, *x, *y, *undo;
    int *pairs;
    ms_gpr_fit_options options = s->learn;
    ms_gpr *gp = NULL;
    ms_status status;
    if (strncmp(text, title, sizeof title - 1) != 0)
        return studio__refuse(error, MS_BAD_DATA, "it does not begin as a session of a studio does");
    text += sizeof title - 1;
    v = studio__get(&text, "session", &count[0]);
    good = count[0] == 7 && v[0] <= m && v[0] >= m && v[1] >= 0 && v[1] <= (double)STUDIO_EXPLORING && v[3] >= 0 &&
        v[3] < 9e15;
    if (good) {
        s->state = (studio_state)(int)v[1];
        s->settled = v[2] > 0;
        s->seed = (uint64_t)v[3];
        s->least = v[4], s->at[0] = v[5], s->at[1] = v[6];
    }
    free(v);
    if (!good) return studio__refuse(error, MS_BAD_DATA, "the session is of other parameters, or was changed");
    theta = studio__get(&text, "theta", &count[0]);
    x = studio__get(&text, "materials", &count[1]);
    y = studio__get(&text, "scores", &n);
    pairs = studio__get_ints(&text, "pairs", &pair_numbers);
    s->others = studio__get(&text, "others", &count[3]);
    s->avoid = studio__get(&text, "avoid", &count[4]);
    undo = studio__get(&text, "undo", &count[5]);
    good = count[0] == m + 2 && n >= 0 && n <= 30000 && count[1] == n * m && pair_numbers >= 0 &&
        pair_numbers % 2 == 0 && (count[3] == 0 || count[3] == STUDIO_OTHERS * m) && count[4] >= 0 &&
        count[4] % m == 0 && count[5] >= 0 && count[5] % 4 == 0 && count[5] <= 4 * STUDIO_UNDO;
    for (i = 0; good && i < count[5]; i += 4) {
        good = undo[i] >= 0 && undo[i] <= (double)STUDIO__AVOIDED && undo[i + 1] >= 0 && undo[i + 1] <= n &&
            undo[i + 3] >= 0 && 2 * undo[i + 3] <= pair_numbers;
        if (!good) break;
        s->undo[s->undos].kind = (int)undo[i], s->undo[s->undos].index = (int)undo[i + 1];
        s->undo[s->undos].score = undo[i + 2], s->undo[s->undos++].pairs = (int)undo[i + 3];
    }
    s->avoids = good ? count[4] / m : 0;
    s->embedded = studio__get(&text, "plane", &count[3]);
    good = good && count[3] >= 0 && count[3] % m == 0 && (count[3] > 0 || s->state != STUDIO_EXPLORING);
    s->embedded_count = good ? count[3] / m : 0;
    for (i = 0; i < 3; ++i) {
        s->owned[i] = studio__get(&text, space[i], &count[i]);
        good = good && (count[i] == 0 || count[i] == m);
    }
    s->space.low = s->owned[0], s->space.high = s->owned[1], s->space.steps = s->owned[2];
    s->space.equal = s->equal = studio__get_ints(&text, "equal", &count[3]);
    good = good && count[3] >= 0 && count[3] % 2 == 0;
    s->space.equal_count = good ? count[3] / 2 : 0;
    good = good && sscanf(text, "lists %d", &lists) == 1 && lists >= 0 && lists <= 10000;
    if (good && lists > 0) good = (s->lists = (ms_gpr_list *)calloc((size_t)lists, sizeof *s->lists)) != NULL;
    for (i = 0, text = strchr(text, '\n'), text = text ? text + 1 : NULL; good && text && i < lists; ++i) {
        int width, numbers;
        s->lists[i].columns = studio__get_ints(&text, "columns", &width);
        s->lists[i].rows = studio__get(&text, "rows", &numbers);
        s->space.list_count = i + 1;
        good = width > 0 && numbers > 0 && numbers % width == 0;
        s->lists[i].width = width;
        s->lists[i].count = good ? numbers / width : 0;
    }
    s->space.lists = s->lists;
    good = good && text && *text == 0;
    status = good ? MS_OK : studio__refuse(error, MS_BAD_DATA, "not a session of this studio, or it was changed");
    if (good && n > 0) { /* the model of these answers at that theta: a fit that does not move */
        options.start = theta;
        options.evaluations = 1;
        options.probes = -1;
        options.pairs = pairs;
        options.pair_count = pair_numbers / 2;
        status = ms_gpr_fit(x, y, n, m, &options, &gp, NULL, error);
        if (status == MS_OK) {
            ms_gpr_destroy(s->gp);
            s->gp = gp;
            memcpy(s->theta, theta, ((size_t)m + 2) * sizeof *theta);
        }
        s->reached = s->objective = -1e300;
    }
    if (status == MS_OK && s->embedded) status = studio__embed(s, s->embedded, s->embedded_count, error);
    free(theta), free(x), free(y), free(pairs), free(undo);
    return status;
}

/* The session of a file in place of the one that s, which is open, holds. s is as it was unless MS_OK. */
static inline ms_status studio_load(studio *s, const char *path, ms_error *error)
{
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    char *text = NULL, *more;
    size_t size = 0, got = 1;
    ms_status status = MS_OK;
    studio fresh;
    if (f == NULL) return studio__refuse(error, MS_IO, problem);
    while (got > 0 && status == MS_OK) {
        more = (char *)realloc(text, 2 * size + 65537);
        if (more == NULL) {
            status = studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a session");
            break;
        }
        text = more;
        got = fread(text + size, 1, size + 65536, f);
        size += got;
    }
    if (status == MS_OK && ferror(f)) status = studio__refuse(error, MS_IO, "cannot be read to its end");
    fclose(f);
    if (status == MS_OK) status = studio_open(&fresh, &s->renderer, error);
    if (status == MS_OK) {
        text[size] = 0;
        fresh.learn = s->learn;
        status = studio__parse(&fresh, text, error);
        if (status == MS_OK) {
            studio_close(s);
            *s = fresh;
        } else {
            studio_close(&fresh);
        }
    }
    free(text);
    return status;
}
#endif
