/* Synthetic users: a true preference u*(x) over materials x in [0,1]^m, and the whole scores 0 to 10 that such a
   user gives. A user likes one or two classes of material; a class is a product of gates ("mostly glass": a mix
   weight below or above a limit) and of tastes (a favored value of roughness, of an albedo, ...); every other
   dimension means nothing to the user, as in chapter 3 of the thesis, where 81 to 90% of a first gallery scores 0.

     person u = user_make(seed, 19, 0.10);      one who scores 10% of uniform materials above 0
     person v = user_of_kind(kind, seed, 19);   one of the USER_KINDS, see user_kinds
     double s = user_true(&u, x), k = user_score(&u, x, &state); */
#ifndef TEST_USERS_H
#define TEST_USERS_H
#include "test.h"

#define USER_CLASSES 3
#define USER_KINDS 12
#define USER_TERMS 8
#define USER_DIMENSIONS_MAX 64

typedef struct user_class {
    int gates, tastes;
    int dimension[USER_TERMS]; /* the gates first */
    double center[USER_TERMS];
    double width[USER_TERMS]; /* negative: a gate that is open below its center */
} user_class;

typedef struct person {
    int m, classes;
    user_class liked[USER_CLASSES];
    double cut, top; /* g at u* = 0 and at u* = 10 */
    double human;    /* standard deviation of the user's own inconsistency, in scores */
    double wrong;    /* share of answers that are random */
    int stars;       /* says 0 to `stars` in place of 0 to 10 */
} person;

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

static double user__g(const person *u, const double *x)
{
    double g = 0;
    int c;
    for (c = 0; c < u->classes; ++c) g = fmax(g, user__product(&u->liked[c], x));
    return g;
}

/* The true preference, 0 to about 10. */
static TEST_UNUSED double user_true(const person *u, const double *x)
{
    double v = 10 * (user__g(u, x) - u->cut) / (u->top - u->cut);
    return v > 0 ? v : 0;
}

/* What the user says: the nearest whole score after an inconsistency of u->human. */
static TEST_UNUSED double user_score(const person *u, const double *x, uint64_t *state)
{
    double s = user_true(u, x), top = u->stars ? u->stars : 10;
    if (u->wrong > 0 && test_uniform(state) < u->wrong) return floor((top + 1) * test_uniform(state));
    if (s > 0) s = floor(s * top / 10 + u->human * top / 10 * test_normal(state) + 0.5);
    return s < 0 ? 0 : s > top ? top : s;
}

static int user__compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* liking: the share of uniform materials with u* > 0. The cut is that quantile of g on 4000 materials. classes: 0: one
   or two. scale: of all widths. and_terms: more tastes a class, all of which must be met. */
static TEST_UNUSED person user__make(uint64_t seed, int m, double liking, int classes, double scale, int and_terms)
{
    enum { SAMPLES = 4000 };
    static double g[SAMPLES];
    uint64_t state = seed * 0x9E3779B97F4A7C15u + 1;
    double x[USER_DIMENSIONS_MAX];
    person u;
    int c, t, k, i;
    memset(&u, 0, sizeof u);
    u.m = m;
    u.human = 0.5;
    u.classes = m >= 8 && test_uniform(&state) < 0.4 ? 2 : 1;
    if (classes) u.classes = classes;
    for (c = 0; c < u.classes; ++c) {
        user_class *k_class = &u.liked[c];
        k_class->gates = m < 4 ? 1 : 2 + (int)(2 * test_uniform(&state));
        k_class->tastes = m < 4 ? m - 1 : and_terms + 2 + (int)(2 * test_uniform(&state));
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
            k_class->width[t] *= scale;
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

static TEST_UNUSED person user_make(uint64_t seed, int m, double liking)
{
    return user__make(seed, m, liking, 0, 1, 0);
}

static TEST_UNUSED const char *const user_kinds[USER_KINDS] = {"one class, 10% liked",
                                                               "one class, 20%",
                                                               "two classes, 10%",
                                                               "two classes, 20%",
                                                               "three classes, 20%",
                                                               "sharp edges",
                                                               "soft edges",
                                                               "seven conditions",
                                                               "3% liked",
                                                               "2% liked",
                                                               "five stars",
                                                               "10% of the answers random"};

static TEST_UNUSED person user_of_kind(int kind, uint64_t seed, int m)
{
    static const double liking[USER_KINDS] = {0.10, 0.20, 0.10, 0.20, 0.20, 0.10, 0.10, 0.10, 0.03, 0.02, 0.10, 0.10};
    static const int classes[USER_KINDS] = {1, 1, 2, 2, 3, 1, 1, 1, 1, 1, 1, 1};
    person u = user__make(seed + 1000 * (uint64_t)kind, m, liking[kind], classes[kind],
                          kind == 5       ? 0.5
                              : kind == 6 ? 2
                                          : 1,
                          kind == 7 ? 2 : 0);
    if (kind == 10) u.stars = 5;
    if (kind == 11) u.wrong = 0.1;
    return u;
}

/* Which class x belongs to, most. */
static TEST_UNUSED int user_class_of(const person *u, const double *x)
{
    int best = 0, c;
    for (c = 1; c < u->classes; ++c)
        if (user__product(&u->liked[c], x) > user__product(&u->liked[best], x)) best = c;
    return best;
}

/* n uniform materials and their scores; x is [n][m]. */
static TEST_UNUSED void user_gallery(const person *u, int n, double *x, double *score, uint64_t *state)
{
    int i, k;
    for (i = 0; i < n; ++i) {
        for (k = 0; k < u->m; ++k) x[i * u->m + k] = test_uniform(state);
        score[i] = user_score(u, x + i * u->m, state);
    }
}

/* Jensen-Shannon divergence (3.12), in nats, of predicted and true preference over n materials: both clamped at 0
   and normalized to sum 1. 0: equal; log 2: nothing in common, or nothing predicted at all. */
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
