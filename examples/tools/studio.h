/* The workflow as a tool with a window would run it: a few calls, each short enough for a frame of 16 ms up to some 200
   scores. ms_gpr.h and space.h come first; pictures come from a callback, such as a neural renderer (neural.h).

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
     studio_keep(&s, &wish, &error);             what galleries, recommendations and the plane keep (space.h)
     studio_undo(&s, &error);                    takes back the last of these six
     studio_update(&s, &error);                  every frame until s.settled                         SCORED    ->
     LEARNED
     studio_recommend(&s, 8, x, planes, &error); a row of recommendations                            LEARNED
     studio_choose(&s, x, &error);               a material was picked: the plane around it          LEARNED   ->
     EXPLORING
     studio_move(&s, dx, dy, &view, &error);     the mouse moved                                     EXPLORING
     if (s.outlier.row >= 0) ...                 an answer that looks like a slip: ask         after an update
     if (studio_warning(&s, text)) puts(text);   what the scores do not support                once s.settled
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
#include "space.h"
#include "warnings.h"
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
    double at[2];             /* where in the plane */
    uint64_t seed;            /* of the next recommendations */
    int search;               /* which start studio_update works on: 0 where it stands, 1 to 3 the fit's own */
    double *theta, reached;   /* [m + 2] how far that start has come, and its objective */
    double cost;              /* processor seconds that an evaluation takes, as measured; 0: not yet */
    warnings_outlier outlier; /* of the last update; row -1: none */
    double explained;         /* as of warnings_judge */
    double *embedded;         /* [embedded_count][m] materials of the plane */
    int embedded_count;
    space_kept *kept;    /* by studio_keep, or NULL */
    double *x;           /* [m] a material, */
    float *row, *planes; /* [m] the same, and its picture */
    ms_gpr_space space;  /* of kept */
    double least;        /* what "none of these" scores; may be set after studio_open where scores do not begin at 0 */
    double *others,
        *avoid; /* [STUDIO_OTHERS][m] what likes are compared with; [avoids][m] what recommendations keep away from */
    int avoids;
    struct {
        int kind, index;
        double score;
        int choices;
    } undo[STUDIO_UNDO]; /* kind: the row `index` was added, scored anew, rows from
              `index` on and choices from `choices` on were added, a material is avoided */
    int undos;

    ms_gpr_recommend_report found; /* of the last recommendations */
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
    ms_gpr_latent_destroy(s->plane);
    ms_gpr_destroy(s->gp);
    free(s->theta);
    free(s->x);
    free(s->row);
    free(s->planes);
    free(s->others);
    free(s->avoid);
    free(s->embedded);
    if (s->kept) space_free(s->kept);
    free(s->kept);
    memset(s, 0, sizeof *s);
}

static inline ms_status studio_open(studio *s, const studio_renderer *renderer, ms_error *error)
{
    size_t m = (size_t)renderer->parameters;
    ms_gpr_view none;
    memset(s, 0, sizeof *s);
    s->outlier.row = -1;
    s->renderer = *renderer;
    s->theta = (double *)malloc((m + 2) * sizeof(double));
    s->x = (double *)malloc(m * sizeof(double));
    s->row = (float *)malloc(m * sizeof(float));
    s->planes = (float *)malloc(renderer->values * sizeof(float));
    if (s->theta && s->x && s->row && s->planes) {
        memset(&none, 0, sizeof none);
        none.m = (int)m;
        if (ms_gpr_create(&none, NULL, &s->gp, error) == MS_OK) return MS_OK;
    }
    studio_close(s);
    return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a session");
}

static inline void studio__changed(studio *s)
{
    s->settled = 0;
    s->search = 0;
    s->outlier.row = -1;
    s->reached = s->objective = -1e300;
    memcpy(s->theta, ms_gpr_view_of(s->gp).theta, ((size_t)s->renderer.parameters + 2) * sizeof(double));
}

enum { STUDIO__ADDED, STUDIO__SCORED, STUDIO__COMPARED, STUDIO__AVOIDED };

static inline void studio__remember(studio *s, int kind, int index, double score, int choices)
{
    if (s->undos == STUDIO_UNDO) memmove(s->undo, s->undo + 1, sizeof s->undo - sizeof s->undo[0]), --s->undos;
    s->undo[s->undos].kind = kind;
    s->undo[s->undos].index = index;
    s->undo[s->undos].score = score;
    s->undo[s->undos++].choices = choices;
}

/* The model of its first n materials and choices [choices], of `added` more materials fresh with scores given [added],
   and of one choice more for each of the first `better` of row [count], which was preferred to those behind. */
static inline ms_status studio__change(studio *s, int n, int choices, const double *fresh, const double *given,
                                       int added, const int *row, int count, int better, ms_error *error)
{
    ms_gpr_view v = ms_gpr_view_of(s->gp);
    const size_t m = (size_t)v.m, rows = (size_t)(n + added);
    size_t chosen = 0;
    double *x = (double *)malloc((rows + 1) * m * sizeof *x), *y = (double *)malloc((rows + 1) * sizeof *y);
    int *sizes = (int *)malloc((size_t)(choices + better + 1) * sizeof *sizes), *list, i, k, j;
    ms_status status = MS_OUT_OF_MEMORY;
    for (i = 0; i < choices; ++i) chosen += (size_t)(v.choices.sizes ? v.choices.sizes[i] : 2);
    list = (int *)malloc((chosen + (size_t)better * (size_t)count + 1) * sizeof *list);
    if (x && y && sizes && list) {
        if (n > 0) memcpy(x, v.x, (size_t)n * m * sizeof *x), memcpy(y, v.y, (size_t)n * sizeof *y);
        if (added > 0) memcpy(x + (size_t)n * m, fresh, (size_t)added * m * sizeof *x);
        if (added > 0) memcpy(y + n, given, (size_t)added * sizeof *y);
        for (i = 0; i < choices; ++i) sizes[i] = v.choices.sizes ? v.choices.sizes[i] : 2;
        if (chosen > 0) memcpy(list, v.choices.rows, chosen * sizeof *list);
        for (i = 0; i < better; ++i) {
            int *own = list + chosen, size = 0;
            own[size++] = row[i];
            for (k = better; k < count; ++k) { /* the same material may have been shown twice */
                for (j = 0; j < size && own[j] != row[k]; ++j) {}
                if (j == size) own[size++] = row[k];
            }
            if (size < 2) continue;
            sizes[choices++] = size;
            chosen += (size_t)size;
        }
        v.n = n + added, v.x = x, v.y = y;
        v.choices.count = choices, v.choices.sizes = sizes, v.choices.rows = list;
        status = ms_gpr_update(s->gp, &v, error);
    } else {
        studio__refuse(error, status, "no memory for an answer");
    }
    free(x), free(y), free(sizes), free(list);
    return status;
}

/* n^3 / 6 multiply-adds for the n-th score. */
static inline ms_status studio_score(studio *s, const double *x, double score, ms_error *error)
{
    const ms_gpr_view v = ms_gpr_view_of(s->gp);
    ms_status status = studio__change(s, v.n, v.choices.count, x, &score, 1, NULL, 0, 0, error);
    if (status != MS_OK) return status;
    studio__remember(s, STUDIO__ADDED, v.n, 0, v.choices.count);
    studio__changed(s);
    if (s->state == STUDIO_EMPTY) s->state = STUDIO_SCORED;
    return MS_OK;
}

static inline ms_status studio__rescore(studio *s, int index, double score, ms_error *error)
{
    ms_gpr_view v = ms_gpr_view_of(s->gp);
    double *y;
    ms_status status;
    if (index < 0 || index >= v.n)
        return studio__refuse(error, MS_INVALID_ARGUMENT, "there is no material of that index");
    if ((y = (double *)malloc((size_t)v.n * sizeof *y)) == NULL)
        return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a score");
    memcpy(y, v.y, (size_t)v.n * sizeof *y);
    y[index] = score;
    v.y = y;
    status = ms_gpr_update(s->gp, &v, error);
    free(y);
    return status;
}

/* Another score for material `index`, counted from 0 in the order of studio_score. */
static inline ms_status studio_rescore(studio *s, int index, double score, ms_error *error)
{
    double before = index >= 0 && index < ms_gpr_view_of(s->gp).n ? ms_gpr_view_of(s->gp).y[index] : 0;
    ms_status status = studio__rescore(s, index, score, error);
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
    const ms_gpr_view v = ms_gpr_view_of(s->gp);
    int *row = (int *)malloc((size_t)count * sizeof *row), added, i;
    double *fresh = (double *)malloc((size_t)count * ((size_t)v.m + 1) * sizeof *fresh);
    ms_status status = MS_OUT_OF_MEMORY;
    if (row && fresh) {
        double *given = fresh + (size_t)count * (size_t)v.m;
        added = studio__rows(s, x, count, row, fresh);
        for (i = 0; i < added; ++i) given[i] = better ? MS_GPR_UNSCORED : s->least;
        status = studio__change(s, v.n, v.choices.count, fresh, given, added, row, count, better, error);
    } else {
        studio__refuse(error, status, "no memory for a comparison");
    }
    free(row), free(fresh);
    if (status != MS_OK) return status;
    studio__remember(s, STUDIO__COMPARED, v.n, 0, v.choices.count);
    studio__changed(s);
    if (s->state == STUDIO_EMPTY) s->state = STUDIO_SCORED;
    return MS_OK;
}

/* Of the materials x [count][m] that were shown those whose indices picked [picks] names, rather than all the others:
   "the best 2 of 9", a choice for each pick. picks 0: none of these; those that were not scored before get the least
   score. Some 2 n^3 multiply-adds, n the materials that were scored or shown. */
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

/* More like these, x [count][m]: each is preferred to materials that are spread evenly over all that are kept, [0, 1]
   without wishes. */
static inline ms_status studio_like(studio *s, const double *x, int count, ms_error *error)
{
    size_t m = (size_t)s->renderer.parameters;
    double *all;
    ms_status status = MS_OK;
    if (count < 1) return studio__refuse(error, MS_INVALID_ARGUMENT, "nothing is liked");
    if (s->others == NULL) {
        ms_gpr_gallery_options options;
        ms_gpr *nothing; /* a model that knows nothing spreads its galleries */
        memset(&options, 0, sizeof options);
        options.seed = ~(uint64_t)0; /* not what a first gallery shows */
        options.space = s->space;
        s->others = (double *)malloc(STUDIO_OTHERS * m * sizeof *s->others);
        if (s->others == NULL) return studio__refuse(error, MS_OUT_OF_MEMORY, "no memory for a comparison");
        status = ms_gpr_fit(NULL, NULL, 0, s->renderer.parameters, NULL, &nothing, NULL, error);
        if (status == MS_OK) status = ms_gpr_gallery(nothing, &options, STUDIO_OTHERS, s->others, error);
        ms_gpr_destroy(nothing);
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
    int index, choices;
    if (s->undos == 0) return studio__refuse(error, MS_INVALID_ARGUMENT, "there is nothing to undo");
    index = s->undo[s->undos - 1].index;
    choices = s->undo[s->undos - 1].choices;
    switch (s->undo[s->undos - 1].kind) {
    case STUDIO__ADDED:
    case STUDIO__COMPARED: status = studio__change(s, index, choices, NULL, NULL, 0, NULL, 0, 0, error); break;
    case STUDIO__SCORED: status = studio__rescore(s, index, s->undo[s->undos - 1].score, error); break;
    default: --s->avoids;
    }
    if (status != MS_OK) return status;
    if (s->undo[--s->undos].kind == STUDIO__AVOIDED) return MS_OK;
    studio__changed(s);
    if (ms_gpr_view_of(s->gp).n == 0) s->state = STUDIO_EMPTY;
    return MS_OK;
}

/* Where the fit's start number `which` begins, into theta [m + 2]: lengths of so many widths (sqrt(12) deviations of a
   column) times sqrt(m), sf = 1 and sn = 0.1 deviations of the scores. */
static inline void studio__start(const ms_gpr *gp, int which, double *theta)
{
    static const double length[] = {0.25, 0.5, 3};
    const ms_gpr_view v = ms_gpr_view_of(gp);
    double sum = 0, sum2 = 0, scored = 0, differ = 0;
    int i, k;
    for (k = 0; k < v.m; ++k) {
        double mean = 0, square = 0;
        for (i = 0; i < v.n; ++i) mean += v.x[(size_t)i * (size_t)v.m + (size_t)k] / v.n;
        for (i = 0; i < v.n; ++i) square += pow(v.x[(size_t)i * (size_t)v.m + (size_t)k] - mean, 2) / v.n;
        differ += square > 0;
        theta[k] = square > 0 ? 0.5 * log(12 * square) : 0;
    }
    for (k = 0; k < v.m; ++k) theta[k] += log(length[which] * sqrt(fmax(differ, 1)));
    for (i = 0; i < v.n; ++i)
        if (v.y[i] > MS_GPR_UNSCORED) sum += v.y[i], scored += 1;
    for (i = 0; i < v.n && scored > 0; ++i)
        if (v.y[i] > MS_GPR_UNSCORED) sum2 += pow(v.y[i] - sum / scored, 2) / scored;
    theta[v.m] = sum2 > 0 ? 0.5 * log(sum2) : 0;
    theta[v.m + 1] = theta[v.m] + log(0.1);
}

/* 1 and a sentence into text [WARNINGS_TEXT] where the scores do not support what is learned from them: they contradict
   the earlier ones, or each other (warnings.h). 0: nothing to say, or not settled yet. */
static inline int studio_warning(const studio *s, char *text)
{
    *text = 0;
    return s->settled && warning_of(s->gp, s->explained, text);
}

/* Some steps of the fit: from where the model stands, then from each of the fit's own starts, until it gains no more;
   the best of all is the model. As many evaluations of the likelihood at a time as fit into 8 ms, by what they took
   before. */
static inline ms_status studio_update(studio *s, ms_error *error)
{
    const ms_gpr_view v = ms_gpr_view_of(s->gp);
    int count, least = s->reached > -1e300 ? 3 : 2;
    double gain;
    ms_gpr_fit_options options = s->learn;
    ms_gpr_fit_report report;
    ms_gpr *found;
    ms_status status;
    clock_t clocks;
    if (s->state == STUDIO_EMPTY) return studio__refuse(error, MS_INVALID_ARGUMENT, "nothing was scored yet");
    if (s->settled) return MS_OK;
    if (s->search > 0 && !(s->reached > -1e300)) studio__start(s->gp, s->search - 1, s->theta);
    options.start = s->theta;
    count = s->cost > 0 ? (int)fmin(0.008 / s->cost, 40) : 2;
    options.evaluations = count < least ? least : count;
    options.choices = v.choices;
    clocks = clock();
    status = ms_gpr_fit(v.x, v.y, v.n, v.m, &options, &found, &report, error);
    if (status != MS_OK) return status;
    s->cost = (double)(clock() - clocks) / CLOCKS_PER_SEC / (report.evaluations + 1); /* conditioned once more, too */
    memcpy(s->theta, ms_gpr_view_of(found).theta, ((size_t)v.m + 2) * sizeof(double));
    gain = report.objective - s->reached;
    s->reached = report.objective;
    if (report.objective > s->objective) {
        ms_gpr_destroy(s->gp);
        s->gp = found;
        s->objective = report.objective;
        s->outlier = warnings_judge(s->gp, &s->explained);
    } else {
        ms_gpr_destroy(found);
    }
    if (gain < 0.05) { /* this start is at its end */
        s->settled = s->search == 3;
        ++s->search;
        s->reached = -1e300;
    }
    if (s->state == STUDIO_SCORED) s->state = STUDIO_LEARNED;
    return MS_OK;
}

static inline ms_status studio__embed(studio *s, const double *x, int count, ms_error *error);

/* What galleries, recommendations and the plane keep, copied; MS_INVALID_ARGUMENT says what contradicts what. */
static inline ms_status studio_keep(studio *s, const space_wish *wish, ms_error *error)
{
    space_kept *fresh = (space_kept *)malloc(sizeof *fresh), *old = s->kept;
    const ms_gpr_space before = s->space;
    const char *problem = fresh ? space_make(fresh, wish, s->renderer.parameters) : "no memory for wishes";
    ms_status status = MS_OK;
    if (problem) {
        free(fresh);
        return studio__refuse(error, fresh ? MS_INVALID_ARGUMENT : MS_OUT_OF_MEMORY, problem);
    }
    s->kept = fresh;
    s->space = space_of(fresh);
    if (s->plane) status = studio__embed(s, s->embedded, s->embedded_count, error); /* it holds on to its space */
    if (status != MS_OK) {
        s->kept = old;
        s->space = before;
        old = fresh;
    } else {
        free(s->others); /* likes that follow are compared with what is kept now */
        s->others = NULL;
    }
    if (old) space_free(old);
    free(old);
    return status;
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

/* x [count][m] and their pictures, planes [count][values] (NULL: none). Other ones at every call. MS_NOT_CONVERGED:
   there are but s->found.found of them. */
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
    s->found.found = 0;
    status = ms_gpr_recommend(s->gp, &options, count, x, NULL, NULL, &s->found, error);
    for (i = 0; i < s->found.found && planes; ++i)
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
    memcpy(s->at, ms_gpr_latent_view_of(s->plane).points + 2 * count, sizeof s->at);
    s->state = STUDIO_EXPLORING;
    return MS_OK;
}

static inline int studio__keeps(const studio *s) { return s->space.low || s->space.high || s->space.snap; }

/* A step in the plane, in length scales, and what is seen there. It ends where the plane knows less than a quarter, but
   may always lead to where it knows more. */
static inline ms_status studio_move(studio *s, double dx, double dy, studio_view *view, ms_error *error)
{
    int m = s->renderer.parameters, k;
    double to[2], variance, here, there, sf2;
    ms_status status;
    int halvings;
    if (s->state != STUDIO_EXPLORING) return studio__refuse(error, MS_INVALID_ARGUMENT, "no material was chosen yet");
    sf2 = pow(ms_gpr_latent_view_of(s->plane).sf, 2);
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
    const ms_gpr_view v = ms_gpr_view_of(s->gp);
    double numbers[10], undo[4 * STUDIO_UNDO];
    int chosen = 0;
    file_out out;
    FILE *f = file_create(path, &out);
    const char *problem;
    if (f == NULL) return studio__refuse(error, MS_IO, out.problem);
    numbers[0] = m, numbers[1] = (int)s->state, numbers[2] = s->settled, numbers[3] = (double)s->seed;
    numbers[4] = s->least, numbers[5] = s->at[0], numbers[6] = s->at[1];
    numbers[7] = v.mean, numbers[8] = v.floor, numbers[9] = v.floor_value;
    for (i = 0; i < v.choices.count; ++i) chosen += v.choices.sizes ? v.choices.sizes[i] : 2;
    for (i = 0; i < s->undos; ++i) {
        undo[4 * i] = s->undo[i].kind, undo[4 * i + 1] = s->undo[i].index;
        undo[4 * i + 2] = s->undo[i].score, undo[4 * i + 3] = s->undo[i].choices;
    }
    fprintf(f, "studio session 2\n");
    studio__put(f, "session", numbers, 10);
    studio__put(f, "theta", v.theta, m + 2);
    studio__put(f, "materials", v.x, n * m);
    studio__put(f, "scores", v.y, n);
    studio__put_ints(f, "sizes", v.choices.sizes, v.choices.count);
    studio__put_ints(f, "choices", v.choices.rows, chosen);
    studio__put(f, "others", s->others, STUDIO_OTHERS * m);
    studio__put(f, "avoid", s->avoid, s->avoids * m);
    studio__put(f, "undo", undo, 4 * s->undos);
    studio__put(f, "plane", s->embedded, s->embedded_count * m);
    studio__put(f, "low", s->kept ? s->kept->low : NULL, m);
    studio__put(f, "high", s->kept ? s->kept->high : NULL, m);
    studio__put(f, "steps", s->kept ? s->kept->steps : NULL, m);
    studio__put_ints(f, "equal", s->kept ? s->kept->equal : NULL, s->kept ? 2 * s->kept->equal_count : 0);
    fprintf(f, "lists %d\n", s->kept ? s->kept->list_count : 0);
    for (i = 0; s->kept && i < s->kept->list_count; ++i) {
        const space_list *list = &s->kept->lists[i];
        studio__put_ints(f, "columns", list->columns, list->width);
        studio__put(f, "rows", list->rows, list->width * list->count);
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
    static const char title[] = "studio session 2\n";
    static const char *const names[] = {"low", "high", "steps"};
    int m = s->renderer.parameters, count[6], n, lists = 0, choices, chosen, i, good;
    double *v, *theta, *x, *y, *undo, *kept[3] = {NULL, NULL, NULL};
    int *sizes, *rows, *equal;
    space_list *list = NULL;
    space_wish wish;
    ms_gpr_view parts;
    ms_status status;
    if (strncmp(text, title, sizeof title - 1) != 0)
        return studio__refuse(error, MS_BAD_DATA, "it does not begin as a session of a studio does");
    text += sizeof title - 1;
    memset(&parts, 0, sizeof parts);
    memset(&wish, 0, sizeof wish);
    v = studio__get(&text, "session", &count[0]);
    good = count[0] == 10 && v[0] <= m && v[0] >= m && v[1] >= 0 && v[1] <= (double)STUDIO_EXPLORING && v[3] >= 0 &&
        v[3] < 9e15;
    if (good) {
        s->state = (studio_state)(int)v[1];
        s->settled = v[2] > 0;
        s->seed = (uint64_t)v[3];
        s->least = v[4], s->at[0] = v[5], s->at[1] = v[6];
        parts.mean = v[7], parts.floor = v[8], parts.floor_value = v[9];
    }
    free(v);
    if (!good) return studio__refuse(error, MS_BAD_DATA, "the session is of other parameters, or was changed");
    theta = studio__get(&text, "theta", &count[0]);
    x = studio__get(&text, "materials", &count[1]);
    y = studio__get(&text, "scores", &n);
    sizes = studio__get_ints(&text, "sizes", &choices);
    rows = studio__get_ints(&text, "choices", &chosen);
    s->others = studio__get(&text, "others", &count[3]);
    s->avoid = studio__get(&text, "avoid", &count[4]);
    undo = studio__get(&text, "undo", &count[5]);
    good = count[0] == m + 2 && n >= 0 && n <= 30000 && count[1] == n * m && choices >= 0 && chosen >= 2 * choices &&
        (count[3] == 0 || count[3] == STUDIO_OTHERS * m) && count[4] >= 0 && count[4] % m == 0 && count[5] >= 0 &&
        count[5] % 4 == 0 && count[5] <= 4 * STUDIO_UNDO;
    for (i = 0; good && i < count[5]; i += 4) {
        good = undo[i] >= 0 && undo[i] <= (double)STUDIO__AVOIDED && undo[i + 1] >= 0 && undo[i + 1] <= n &&
            undo[i + 3] >= 0 && undo[i + 3] <= choices;
        if (!good) break;
        s->undo[s->undos].kind = (int)undo[i], s->undo[s->undos].index = (int)undo[i + 1];
        s->undo[s->undos].score = undo[i + 2], s->undo[s->undos++].choices = (int)undo[i + 3];
    }
    for (i = 0; good && i < choices; ++i) good = sizes[i] >= 2 && sizes[i] <= chosen && (chosen -= sizes[i]) >= 0;
    good = good && chosen == 0;
    s->avoids = good ? count[4] / m : 0;
    s->embedded = studio__get(&text, "plane", &count[3]);
    good = good && count[3] >= 0 && count[3] % m == 0 && (count[3] > 0 || s->state != STUDIO_EXPLORING);
    s->embedded_count = good ? count[3] / m : 0;
    for (i = 0; i < 3; ++i) {
        kept[i] = studio__get(&text, names[i], &count[i]);
        good = good && (count[i] == 0 || count[i] == m);
    }
    equal = studio__get_ints(&text, "equal", &count[3]);
    good = good && count[3] >= 0 && count[3] % 2 == 0;
    good = good && sscanf(text, "lists %d", &lists) == 1 && lists >= 0 && lists <= 10000;
    if (good && lists > 0) good = (list = (space_list *)calloc((size_t)lists, sizeof *list)) != NULL;
    text = strchr(text, '\n');
    for (i = 0, text = text ? text + 1 : NULL; good && text && i < lists; ++i) {
        int width, numbers;
        list[i].columns = studio__get_ints(&text, "columns", &width);
        list[i].rows = studio__get(&text, "rows", &numbers);
        good = width > 0 && numbers > 0 && numbers % width == 0;
        list[i].width = width;
        list[i].count = good ? numbers / width : 0;
    }
    good = good && text && *text == 0;
    status = good ? MS_OK : studio__refuse(error, MS_BAD_DATA, "not a session of this studio, or it was changed");
    if (good) { /* the model as it was */
        parts.n = n, parts.m = m;
        parts.x = x, parts.y = y, parts.theta = theta;
        parts.choices.count = choices, parts.choices.sizes = sizes, parts.choices.rows = rows;
        status = ms_gpr_update(s->gp, &parts, error);
        memcpy(s->theta, theta, ((size_t)m + 2) * sizeof *theta);
        s->reached = s->objective = -1e300;
        wish.low = kept[0], wish.high = kept[1], wish.steps = kept[2];
        wish.equal = equal, wish.equal_count = count[3] / 2;
        wish.lists = list, wish.list_count = lists;
        if (status == MS_OK && (kept[0] || equal || lists)) status = studio_keep(s, &wish, error);
    }
    if (status == MS_OK && s->settled) s->outlier = warnings_judge(s->gp, &s->explained);
    if (status == MS_OK && s->embedded) status = studio__embed(s, s->embedded, s->embedded_count, error);
    for (i = 0; i < lists && list; ++i) free((void *)(uintptr_t)list[i].columns), free((void *)(uintptr_t)list[i].rows);
    free(theta), free(x), free(y), free(sizes), free(rows), free(undo), free(equal), free(list);
    for (i = 0; i < 3; ++i) free(kept[i]);
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
