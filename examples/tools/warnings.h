/* What scores do not support, as a sentence; ms_gpr.h comes first.

     double explained;
     char text[WARNINGS_TEXT];
     warnings_outlier slip = warnings_judge(gp, &explained);
     if (slip.row >= 0) fprintf(stderr, "warning: %g of row %d, about %g was expected\n", slip.value, slip.row, slip.expected);
     if (warning_of(gp, explained, text)) fprintf(stderr, "warning: %s\n", text);

   gp: a model of scores in the order in which they were given.
   The limits were measured on persons of twelve kinds (tests/users.h), active galleries, 60 to 80 scores. The last 20
   scores of honest ones were at most 0.41 deviations below what those before them predict. Of persons whose taste had
   changed 20 scores ago, half were more than 0.5 below. Of honest ones the others predicted 0.55 of the variance or
   more in 95 of 100 sessions; with one answer in five at random, 0.31 in the median. */
#ifndef EXAMPLES_WARNINGS_H
#define EXAMPLES_WARNINGS_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WARNINGS_TEXT = 200, WARNINGS_RECENT = 20, WARNINGS_SCORES = 40, WARNINGS_LIKED = 8 };

/* A score that looks like a slip, because all others contradict it: ask the user about it. One can spoil all
   recommendations. */
typedef struct warnings_outlier {
    int row; /* -1: none */
    double value;
    double expected;  /* predicted from the other answers */
    double deviation; /* value - expected, in standard deviations of that prediction */
} warnings_outlier;

enum {
    WARNINGS_ROWS = 8, /* scores at least before one of them is an outlier */
    WARNINGS_GROUP = 3 /* slips at most that may hide each other */
};

typedef struct warnings_ranked {
    double value;
    int row;
} warnings_ranked;

static inline int warnings_order(const void *a, const void *b)
{
    const warnings_ranked *x = (const warnings_ranked *)a, *y = (const warnings_ranked *)b;
    return x->value < y->value ? 1 : x->value > y->value ? -1 : x->row - y->row;
}

/* Whether up to WARNINGS_GROUP scores lie three ranges of all others above them (sign 1) or below them (-1). */
static inline int warnings_outside(const warnings_ranked *sorted, int count, double sign)
{
    int group;
    for (group = 1; group <= WARNINGS_GROUP && group < count - 1; ++group) {
        const double edge = sign * sorted[sign > 0 ? group : count - 1 - group].value;
        const double extreme = sign * sorted[sign > 0 ? group - 1 : count - group].value;
        const double other = sign * sorted[sign > 0 ? count - 1 : 0].value;
        if (extreme - edge > 3 * (edge - other)) return 1;
    }
    return 0;
}

/* The score that the others contradict most, by leave-one-out predictions mean and variance. It is an outlier if a few
   that are contradicted so much stand apart from the rest, or if it is far outside the range of the others. list: [n]
   scratch. */
static inline warnings_outlier warnings_find(const ms_gpr_view *v, const double *mean, const double *variance,
                                             double least, warnings_ranked *list)
{
    warnings_outlier o = {-1, 0, 0, 0};
    double largest, z[WARNINGS_GROUP + 2];
    int count = 0, above = 0, apart = 0, row, i;
    for (i = 0; i < v->n; ++i) {
        const double modeled = v->y[i] <= v->floor ? v->floor_value : v->y[i];
        if (!(v->y[i] > 0.5 * MS_GPR_UNSCORED)) continue;
        above += v->y[i] > least;
        list[count].row = i;
        list[count++].value = fabs(modeled - mean[i]) / sqrt(variance[i]);
    }
    qsort(list, (size_t)count, sizeof *list, warnings_order);
    row = list[0].row;
    for (i = 0; i < WARNINGS_GROUP + 2; ++i) z[i] = list[i].value;
    for (i = 0; i < WARNINGS_GROUP; ++i) apart |= z[i] > 5 && z[i] > 2 * z[i + 1] && above > 4 + i;

    /* scores far outside the range of the others */
    for (i = 0; i < count; ++i) list[i].value = v->y[list[i].row];
    qsort(list, (size_t)count, sizeof *list, warnings_order);
    if (above > 2 && warnings_outside(list, count, 1)) apart = 1, row = list[0].row;
    else if (warnings_outside(list, count, -1)) apart = 1, row = list[count - 1].row;
    if (!apart) return o;
    least = list[count - 1].row == row ? list[count - 2].value : list[count - 1].value;
    largest = list[0].row == row ? list[1].value : list[0].value;
    o.row = row;
    o.value = v->y[row];
    o.expected = fmin(fmax(mean[row], least), largest);
    o.deviation = (o.value - o.expected) / sqrt(variance[row]);
    return o;
}

/* The slip, and the share of the variance of the scores that the other scores predict (leave-one-out). 0 or less: they
   predict each other no better than their mean. 0 below 8 scores, or without memory. */
static inline warnings_outlier warnings_judge(const ms_gpr *gp, double *explained)
{
    const ms_gpr_view v = ms_gpr_view_of(gp);
    const size_t n = (size_t)v.n;
    warnings_outlier o = {-1, 0, 0, 0};
    double *mean = (double *)malloc((2 * n + 1) * sizeof *mean), *variance = mean + n;
    warnings_ranked *list = (warnings_ranked *)malloc((n + 1) * sizeof *list);
    double least = HUGE_VAL, largest = -HUGE_VAL, sum = 0, sum2 = 0, unexplained = 0, factor;
    int scored = 0, i, pass;
    *explained = 0;
    for (i = 0; i < v.n; ++i) {
        if (!(v.y[i] > 0.5 * MS_GPR_UNSCORED)) continue;
        ++scored;
        least = fmin(least, v.y[i]);
        largest = fmax(largest, v.y[i]);
    }
    if (scored >= WARNINGS_ROWS && largest > least && mean && list &&
        ms_gpr_leave_one_out(gp, mean, variance, NULL) == MS_OK) {
        for (pass = 0; pass < 2; ++pass)
            for (i = 0; i < v.n; ++i) {
                const double modeled = v.y[i] <= v.floor ? v.floor_value : v.y[i];
                if (!(v.y[i] > 0.5 * MS_GPR_UNSCORED)) continue;
                if (pass == 0) sum += modeled / scored;
                else sum2 += (modeled - sum) * (modeled - sum);
                if (pass == 0) unexplained += (modeled - mean[i]) * (modeled - mean[i]);
            }
        factor = scored / (scored - 1.0); /* the mean of the others is as far off as that */
        if (sum2 > 0) *explained = 1 - unexplained / (factor * factor * sum2);
        o = warnings_find(&v, mean, variance, least, list);
    }
    free(mean), free(list);
    return o;
}

/* How far the last scores lie above what those before them predict, in the mean, in standard deviations of all; below
   0: they are lower. 0 also for fewer than 40 scores, and where anything was chosen. */
static inline double warnings_recent(const ms_gpr *gp)
{
    ms_gpr_view v = ms_gpr_view_of(gp);
    const int all = v.n, first = all - WARNINGS_RECENT;
    double mean[WARNINGS_RECENT], sum = 0, sum2 = 0, above = 0;
    ms_gpr *earlier = NULL;
    int i;
    if (all < WARNINGS_SCORES || v.choices.count > 0) return 0;
    for (i = 0; i < all; ++i) {
        if (!(v.y[i] > 0.5 * MS_GPR_UNSCORED)) return 0;
        sum += v.y[i] / all;
    }
    for (i = 0; i < all; ++i) sum2 += (v.y[i] - sum) * (v.y[i] - sum) / all;
    v.n = first;
    if (!(sum2 > 0) || ms_gpr_create(&v, NULL, &earlier, NULL) != MS_OK) return 0;
    v = ms_gpr_view_of(gp);
    if (ms_gpr_predict(earlier, v.x + (size_t)first * (size_t)v.m, WARNINGS_RECENT, mean, NULL, NULL) == MS_OK)
        for (i = 0; i < WARNINGS_RECENT; ++i) {
            const double score = v.y[first + i];
            above += (score <= v.floor ? v.floor_value : score) - mean[i];
        }
    ms_gpr_destroy(earlier);
    return above / ((double)WARNINGS_RECENT * sqrt(sum2));
}

/* 1 and the sentence into text [WARNINGS_TEXT], or 0: nothing to say. explained: of warnings_judge. */
static inline int warning_of(const ms_gpr *gp, double explained, char *text)
{
    const ms_gpr_view v = ms_gpr_view_of(gp);
    int scored = 0, liked = 0, i;
    for (i = 0; i < v.n; ++i) {
        scored += v.y[i] > 0.5 * MS_GPR_UNSCORED;
        liked += v.y[i] > v.floor;
    }
    *text = 0;
    if (liked >= WARNINGS_LIKED && warnings_recent(gp) < -0.5)
        snprintf(text, WARNINGS_TEXT,
                 "the last %d scores are lower than the ones before them predict: did the taste change? If so, leave "
                 "the earlier ones out.",
                 (int)WARNINGS_RECENT);
    else if (scored >= 8 && liked > 2 && !(explained > 0.05)) /* random scores are as good: tests/test_gpr.c */
        snprintf(text, WARNINGS_TEXT, "these scores predict each other no better than their mean.");
    else if (scored >= WARNINGS_SCORES && liked >= WARNINGS_LIKED && explained < 0.4)
        snprintf(text, WARNINGS_TEXT,
                 "these scores predict only %.0f%% of each other's variance: a rare taste needs more answers, or some "
                 "of these are random.",
                 100 * explained);
    return *text != 0;
}
#endif
