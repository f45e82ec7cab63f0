/* What scores do not support, as a sentence; ms_gpr.h comes first.

     char text[WARNINGS_TEXT];
     if (warning_of(gp, report.explained, text)) fprintf(stderr, "warning: %s\n", text);

   gp: a model of scores in the order in which they were given; report: of its fit.
   The limits were measured on persons of twelve kinds (tests/users.h), active galleries, 60 to 80 scores. The last 20
   scores of honest ones were at most 0.41 deviations below what those before them predict. Of persons whose taste had
   changed 20 scores ago, half were more than 0.5 below. Of honest ones the others predicted 0.55 of the variance or
   more in 95 of 100 sessions; with one answer in five at random, 0.31 in the median. */
#ifndef EXAMPLES_WARNINGS_H
#define EXAMPLES_WARNINGS_H
#include <math.h>
#include <stdio.h>

enum { WARNINGS_TEXT = 200, WARNINGS_RECENT = 20, WARNINGS_SCORES = 40, WARNINGS_LIKED = 8 };

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
    return above / ((int)WARNINGS_RECENT * sqrt(sum2));
}

/* 1 and the sentence into text [WARNINGS_TEXT], or 0: nothing to say. explained: of the report of the fit. */
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
