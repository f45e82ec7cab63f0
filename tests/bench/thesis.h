/* How the thesis fitted a taste and looked for recommendations, on the public calls of ms_gpr.h, to compare with:

     ms_gpr *gp = thesis_fit(x, y, n, m, THESIS_RPROP, 1, &report);       every length starts at 1 width; NULL: failed
     int found = thesis_climb(gp, threshold, count, seed, r, &candidates); rejection with hill climbing

   Resilient backpropagation (Riedmiller & Braun 1992) as in Blum & Riedmiller 2013, 100 evaluations; scaled conjugate
   gradients (Moller 1993, steps 1 to 9). Scores are taken as they are: no prior, no floor. */
#ifndef BENCH_THESIS_H
#define BENCH_THESIS_H
#include "test.h"
#include "gpr_inside.h"

enum { THESIS_RPROP, THESIS_SCG, THESIS_VARIABLES = 64 };

typedef struct thesis_report {
    double likelihood;
    int evaluations;
} thesis_report;

typedef struct thesis_search {
    ms_gpr *gp;
    int count, evaluations;
    double low[THESIS_VARIABLES], high[THESIS_VARIABLES];
} thesis_search;

static double thesis__clip(const thesis_search *s, int i, double v)
{
    return v < s->low[i] ? s->low[i] : v > s->high[i] ? s->high[i] : v;
}

/* Minus the log likelihood and its slopes; 0 where it is not defined. */
static int thesis__value(thesis_search *s, const double *theta, double *value, double *slope)
{
    int i;
    ++s->evaluations;
    if (inside_set_theta(s->gp, theta, NULL) != MS_OK || inside_likelihood(s->gp, value, slope, NULL) != MS_OK)
        return 0;
    *value = -*value;
    for (i = 0; i < s->count; ++i) slope[i] = -slope[i];
    return 1;
}

/* Each variable keeps a step of its own that grows by 1.2 while the sign of its slope stays, and halves when it
   turns. */
static double thesis__rprop(thesis_search *s, double *q)
{
    double at[THESIS_VARIABLES], slope[THESIS_VARIABLES], before[THESIS_VARIABLES], step[THESIS_VARIABLES], value,
        best = HUGE_VAL;
    int i;
    for (i = 0; i < s->count; ++i) {
        at[i] = q[i];
        before[i] = 0;
        step[i] = 0.1;
    }
    while (s->evaluations < 100 && thesis__value(s, at, &value, slope)) {
        if (value < best) {
            best = value;
            memcpy(q, at, sizeof at);
        }
        for (i = 0; i < s->count; ++i) {
            double turn = before[i] * slope[i];
            if (turn > 0) step[i] = fmin(step[i] * 1.2, 50);
            if (turn < 0) step[i] = fmax(step[i] * 0.5, 1e-6);
            before[i] = turn < 0 ? 0 : slope[i];
            if (turn >= 0) at[i] = thesis__clip(s, i, at[i] - (slope[i] > 0 ? step[i] : slope[i] < 0 ? -step[i] : 0));
        }
    }
    return best;
}

static double thesis__scg(thesis_search *s, double *q)
{
    double slope[THESIS_VARIABLES], direction[THESIS_VARIABLES], trial[THESIS_VARIABLES], there[THESIS_VARIABLES],
        residual[THESIS_VARIABLES];
    double value, best, lambda = 1e-6, raised = 0, delta = 0;
    int success = 1, k = 1, i;
    if (!thesis__value(s, q, &best, slope)) return HUGE_VAL;
    for (i = 0; i < s->count; ++i) direction[i] = residual[i] = -slope[i];
    while (s->evaluations < 200) {
        double p2 = 0, mu = 0, comparison, r2 = 0, gain, cross = 0;
        for (i = 0; i < s->count; ++i) {
            p2 += direction[i] * direction[i];
            mu += direction[i] * residual[i];
        }
        if (!(p2 > 1e-20)) break;
        if (success) { /* second-order information from a short step */
            double sigma = 1e-4 / sqrt(p2);
            for (i = 0; i < s->count; ++i) trial[i] = q[i] + sigma * direction[i];
            if (!thesis__value(s, trial, &value, there)) break;
            for (i = 0, delta = 0; i < s->count; ++i) delta += direction[i] * (there[i] - slope[i]) / sigma;
        }
        delta += (lambda - raised) * p2;
        if (delta <= 0) { /* make the Hessian positive definite */
            raised = 2 * (lambda - delta / p2);
            delta = -delta + lambda * p2;
            lambda = raised;
        }
        for (i = 0; i < s->count; ++i) trial[i] = thesis__clip(s, i, q[i] + mu / delta * direction[i]);
        if (!thesis__value(s, trial, &value, there) || !(value < HUGE_VAL)) value = HUGE_VAL;
        comparison = value < HUGE_VAL ? 2 * delta * (best - value) / (mu * mu) : -1;
        if (comparison >= 0) {
            gain = best - value;
            best = value;
            for (i = 0; i < s->count; ++i) {
                cross += residual[i] * -there[i];
                q[i] = trial[i];
                slope[i] = there[i];
                residual[i] = -there[i];
                r2 += residual[i] * residual[i];
            }
            raised = 0;
            success = 1;
            for (i = 0; i < s->count; ++i)
                direction[i] = residual[i] + (k % s->count == 0 ? 0 : (r2 - cross) / mu) * direction[i];
            ++k;
            if (comparison >= 0.75) lambda *= 0.25;
            if (gain < 1e-4 && r2 < 1e-4 * s->count) break;
        } else {
            raised = lambda;
            success = 0;
        }
        if (comparison < 0.25) lambda += delta * (1 - comparison) / p2;
        if (!(lambda < 1e100)) break;
    }
    return best;
}

static TEST_UNUSED ms_gpr *thesis_fit(const double *x, const double *y, int n, int m, int method, double length,
                                      thesis_report *report)
{
    thesis_search s;
    double theta[THESIS_VARIABLES], sum = 0, sum2 = 0, best;
    int i, k;
    memset(&s, 0, sizeof s);
    memset(theta, 0, sizeof theta);
    if (m + 2 > (int)THESIS_VARIABLES) return NULL;
    for (i = 0; i < n; ++i) sum += y[i] / n;
    for (i = 0; i < n; ++i) sum2 += (y[i] - sum) * (y[i] - sum) / n;
    s.count = m + 2;
    for (k = 0; k < m + 2; ++k) {
        double unit = sqrt(sum2), middle = 0, square = 0;
        for (i = 0; k < m && i < n; ++i) middle += x[i * m + k] / n;
        for (i = 0; k < m && i < n; ++i) square += (x[i * m + k] - middle) * (x[i * m + k] - middle) / n;
        if (k < m) unit = sqrt(12 * square);
        theta[k] = log(unit * (k < m ? length : k == m ? 1 : 0.1));
        s.low[k] = log(unit * (k < m ? 0.01 : 0.001));
        s.high[k] = log(unit * (k < m ? 1000 : k == m ? 1000 : 10));
    }
    if (inside_create(x, y, n, m, theta, sum, NULL, &s.gp, NULL) != MS_OK) return NULL;
    best = method == THESIS_RPROP ? thesis__rprop(&s, theta) : thesis__scg(&s, theta);
    inside_set_theta(s.gp, theta, NULL);
    if (report) {
        report->likelihood = -best;
        report->evaluations = s.evaluations;
    }
    return s.gp;
}

/* From a uniform place of the unit box, random steps of 0.1 that are kept where the mean grows; a climb that has not
   arrived after 20 starts anew. How many of `count` were found with 2e6 candidates. */
static TEST_UNUSED int thesis_climb(const ms_gpr *gp, double threshold, int count, uint64_t seed, double *found,
                                    double *candidates)
{
    double x[THESIS_VARIABLES], value, best = 0;
    int m = ms_gpr_view_of(gp).m, i = 0, k, step = 0;
    uint64_t state = seed;
    for (*candidates = 0; i < count && *candidates < 2e6; *candidates += 1, step = (step + 1) % 21) {
        double *kept = found + i * m;
        for (k = 0; k < m; ++k)
            x[k] = step == 0 ? test_uniform(&state) : fmin(fmax(kept[k] + 0.1 * test_normal(&state), 0), 1);
        if (ms_gpr_predict(gp, x, 1, &value, NULL, NULL) != MS_OK) return i;
        if (step > 0 && !(value > best)) continue;
        memcpy(kept, x, (size_t)m * sizeof *x);
        best = value;
        if (value >= threshold) {
            ++i;
            step = 20;
        }
    }
    return i;
}
#endif
