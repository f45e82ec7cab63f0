/* Why a model recommends what it does, in words: "liked for: x4 below 0.31, x2 above 0.66"; ms_gpr.h comes first.

     char text[400];
     if (explain(gp, x, count, &space, NULL, 4, text, sizeof text)) puts(text);   x [count][m]: recommendations

   A parameter is named if the model does not take it as irrelevant (a twentieth of the largest relevance) and nine in
   ten of the recommendations lie in less than 0.6 of its range. Several kinds of liked materials share no such range.
 */
#ifndef EXAMPLES_EXPLAIN_H
#define EXAMPLES_EXPLAIN_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXPLAIN_MOST = 16 };

static inline int explain__order(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* How much each parameter matters, [m] out: the mean of ((a_k - b_k) / l_k)^2 over pairs of the model's materials; 0 for
   one that is left out. */
static inline void explain_relevance(const ms_gpr *gp, double *relevance)
{
    const ms_gpr_view v = ms_gpr_view_of(gp);
    const size_t m = (size_t)v.m;
    int i, k;
    for (k = 0; k < v.m; ++k) {
        double center = 0, sum = 0;
        for (i = 0; i < v.n; ++i) center += v.x[(size_t)i * m + (size_t)k] / v.n;
        for (i = 0; i < v.n; ++i) sum += pow((v.x[(size_t)i * m + (size_t)k] - center) * exp(-v.theta[k]), 2);
        relevance[k] = v.n > 1 && v.theta[k] < 700 ? 2 * sum / (v.n - 1) : 0;
    }
}

/* The digits of v that tell a hundredth of the range, and whole ones: 240 of 360, 100.3 of 100 to 101. */
static inline int explain__digits(double v, double range)
{
    const double size = fabs(v) > 0 ? floor(log10(fabs(v))) : 0;
    return (int)fmax(fmax(2, fmin(size + 1, 6)), fmin(size - floor(log10(range)) + 2, 17));
}

/* How many parameters were named, at most `most`; 0 also where memory runs out. The narrowest ranges come first. space:
   what was allowed (a range that was asked for is no reason), or NULL; name [m]: NULL for x0, x1 ... */
static inline int explain(const ms_gpr *gp, const double *x, int count, const ms_gpr_space *space,
                          const char *const *name, int most, char *text, size_t size)
{
    const ms_gpr_view view = ms_gpr_view_of(gp);
    const int m = view.m;
    double *relevance = (double *)malloc((size_t)(m + count) * sizeof *relevance), *sorted = relevance + m;
    double from[EXPLAIN_MOST], to[EXPLAIN_MOST], share[EXPLAIN_MOST], least[EXPLAIN_MOST], range[EXPLAIN_MOST];
    double largest = 0;
    int named = 0, which[EXPLAIN_MOST], i, k;
    size_t used;
    if (size > 0) *text = 0;
    if (relevance == NULL || count < 1 || size < 1) {
        free(relevance);
        return 0;
    }
    if (most > EXPLAIN_MOST) most = EXPLAIN_MOST;
    explain_relevance(gp, relevance);
    for (k = 0; k < m; ++k) largest = fmax(largest, relevance[k]);
    for (k = 0; k < m; ++k) {
        double low = HUGE_VAL, high = -HUGE_VAL, wide, a, b;
        if (!(relevance[k] > 0.05 * largest)) continue;
        for (i = 0; i < view.n; ++i) {
            low = fmin(low, view.x[(size_t)i * (size_t)m + (size_t)k]);
            high = fmax(high, view.x[(size_t)i * (size_t)m + (size_t)k]);
        }
        if (low >= 0 && high <= 1) low = 0, high = 1; /* as the box of ms_gpr_space is without wishes */
        if (space && space->low && space->low[k] > -1e300) low = space->low[k];
        if (space && space->high && space->high[k] < 1e300) high = space->high[k];
        if (!(high > low)) continue;
        for (i = 0; i < count; ++i) sorted[i] = x[(size_t)i * (size_t)m + (size_t)k];
        qsort(sorted, (size_t)count, sizeof *sorted, explain__order);
        a = sorted[count / 20];
        b = sorted[count - 1 - count / 20];
        wide = (b - a) / (high - low);
        if (wide >= 0.6) continue;
        for (i = named < most ? named++ : most; i > 0 && share[i - 1] > wide; --i)
            if (i < most) {
                share[i] = share[i - 1], from[i] = from[i - 1], to[i] = to[i - 1], which[i] = which[i - 1];
                least[i] = least[i - 1], range[i] = range[i - 1];
            }
        if (i < most) share[i] = wide, from[i] = a, to[i] = b, which[i] = k, least[i] = low, range[i] = high - low;
    }
    free(relevance);
    for (i = 0; i < named; ++i) {
        const int at_low = from[i] - least[i] < 0.1 * range[i], at_high = least[i] + range[i] - to[i] < 0.1 * range[i];
        const int low_digits = explain__digits(from[i], range[i]), high_digits = explain__digits(to[i], range[i]);
        used = strlen(text);
        snprintf(text + used, size - used, "%s", i ? ", " : "liked for: ");
        used = strlen(text);
        if (name) snprintf(text + used, size - used, "%s", name[which[i]]);
        else snprintf(text + used, size - used, "x%d", which[i]);
        used = strlen(text);
        if (at_low && !at_high) snprintf(text + used, size - used, " below %.*g", high_digits, to[i]);
        else if (at_high && !at_low) snprintf(text + used, size - used, " above %.*g", low_digits, from[i]);
        else snprintf(text + used, size - used, " %.*g to %.*g", low_digits, from[i], high_digits, to[i]);
    }
    return named;
}
#endif
