/* Synthetic users: a true preference u*(x) over materials x in [0,1]^m, and the whole scores 0 to 10 that such a
   user gives. A user likes one or two classes of material; a class is a product of gates ("mostly glass": a mix
   weight below or above a limit) and of tastes (a favoured value of roughness, of an albedo, ...); every other
   dimension means nothing to the user, as in chapter 3 of the thesis, where 81 to 90% of a first gallery scores 0.

     user u = user_make(seed, 19, 0.10);      one who scores 10% of uniform materials above 0
     double s = user_true(&u, x), k = user_score(&u, x, &state); */
#ifndef TEST_USERS_H
#define TEST_USERS_H
#include "test.h"

#define USER_CLASSES 2
#define USER_TERMS 7
#define USER_DIMENSIONS_MAX 64

typedef struct user_class {
    int gates, tastes;
    int dimension[USER_TERMS];   /* the gates first */
    double center[USER_TERMS];
    double width[USER_TERMS];    /* negative: a gate that is open below its center */
} user_class;

typedef struct user {
    int m, classes;
    user_class liked[USER_CLASSES];
    double cut, top;             /* g at u* = 0 and at u* = 10 */
    double human;                /* standard deviation of the user's own inconsistency, in scores */
} user;

static double user__product(const user_class *c, const double *x)
{
    double g = 1;
    int t;
    for (t = 0; t < c->gates + c->tastes; ++t) {
        double d = (x[c->dimension[t]] - c->center[t]) / c->width[t];
        g *= t < c->gates ? 1 / (1 + exp(-d)) : exp(-0.5 * d * d);
    }
    return g;
}

static double user__g(const user *u, const double *x)
{
    double g = user__product(&u->liked[0], x);
    if (u->classes > 1) {
        double h = user__product(&u->liked[1], x);
        if (h > g) g = h;
    }
    return g;
}

/* The true preference, 0 to about 10. */
static TEST_UNUSED double user_true(const user *u, const double *x)
{
    double v = 10 * (user__g(u, x) - u->cut) / (u->top - u->cut);
    return v > 0 ? v : 0;
}

/* What the user says: the nearest whole score after an inconsistency of u->human. */
static TEST_UNUSED double user_score(const user *u, const double *x, uint64_t *state)
{
    double s = user_true(u, x);
    if (s > 0) s = floor(s + u->human * test_normal(state) + 0.5);
    return s < 0 ? 0 : s > 10 ? 10 : s;
}

static int user__compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* liking: the share of uniform materials with u* > 0. The cut is that quantile of g on 4000 materials. */
static TEST_UNUSED user user_make(uint64_t seed, int m, double liking)
{
    enum { SAMPLES = 4000 };
    static double g[SAMPLES];
    uint64_t state = seed * 0x9E3779B97F4A7C15u + 1;
    double x[USER_DIMENSIONS_MAX];
    user u;
    int c, t, k, i;
    memset(&u, 0, sizeof u);
    u.m = m;
    u.human = 0.5;
    u.classes = m >= 8 && test_uniform(&state) < 0.4 ? 2 : 1;
    for (c = 0; c < u.classes; ++c) {
        user_class *k_class = &u.liked[c];
        k_class->gates = m < 4 ? 1 : 2 + (int)(2 * test_uniform(&state));
        k_class->tastes = m < 4 ? m - 1 : 2 + (int)(2 * test_uniform(&state));
        if (k_class->tastes > m - k_class->gates) k_class->tastes = m - k_class->gates;
        for (t = 0; t < k_class->gates + k_class->tastes; ++t) {
            int fresh;
            do {
                k_class->dimension[t] = (int)(m * test_uniform(&state));
                fresh = 1;
                for (k = 0; k < t; ++k)
                    if (k_class->dimension[k] == k_class->dimension[t]) fresh = 0;
            } while (!fresh);
            if (t < k_class->gates) {
                k_class->center[t] = 0.35 + 0.3 * test_uniform(&state);
                k_class->width[t] = (0.06 + 0.06 * test_uniform(&state)) * (test_uniform(&state) < 0.5 ? 1 : -1);
            } else {
                k_class->center[t] = 0.15 + 0.7 * test_uniform(&state);
                k_class->width[t] = 0.3 + 0.4 * test_uniform(&state);
            }
        }
    }
    for (i = 0; i < SAMPLES; ++i) {
        for (k = 0; k < m; ++k) x[k] = test_uniform(&state);
        g[i] = user__g(&u, x);
    }
    qsort(g, SAMPLES, sizeof *g, user__compare);
    u.cut = g[(int)((1 - liking) * (int)SAMPLES)];
    u.top = g[SAMPLES - 1];
    return u;
}

/* n uniform materials and their scores; x is [n][m]. */
static TEST_UNUSED void user_gallery(const user *u, int n, double *x, double *score, uint64_t *state)
{
    int i, k;
    for (i = 0; i < n; ++i) {
        for (k = 0; k < u->m; ++k) x[i * u->m + k] = test_uniform(state);
        score[i] = user_score(u, x + i * u->m, state);
    }
}

/* Jensen-Shannon divergence (3.12), in nats, of predicted and true preference over n materials: both clamped at 0
   and normalised to sum 1. 0: equal; log 2: nothing in common, or nothing predicted at all. */
static TEST_UNUSED double user_jsd(const double *predicted, const double *truth, int n)
{
    double sum_p = 0, sum_q = 0, d = 0;
    int i;
    for (i = 0; i < n; ++i) {
        sum_p += predicted[i] > 0 ? predicted[i] : 0;
        sum_q += truth[i] > 0 ? truth[i] : 0;
    }
    if (!(sum_p > 0) || !(sum_q > 0)) return log(2.0);
    for (i = 0; i < n; ++i) {
        double p = (predicted[i] > 0 ? predicted[i] : 0) / sum_p, q = (truth[i] > 0 ? truth[i] : 0) / sum_q;
        double mean = 0.5 * (p + q);
        if (p > 0) d += 0.5 * p * log(p / mean);
        if (q > 0) d += 0.5 * q * log(q / mean);
    }
    return d;
}
#endif
