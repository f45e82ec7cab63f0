/* ms_pme.h: the minimizer on the problems of More, Garbow and Hillstrom (1981) free and with bounds, on functions that
   are noisy or not finite and in any units, and the match of a picture by a small renderer made up here. */
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "pme_inside.h"
#include "test.h"
#include "stack.h"
#include "json.h"
#include <float.h>
#include <limits.h>
#include <stddef.h>

/* --- the problems of More, Garbow and Hillstrom (1981), with differences for Jacobians checked against closed forms
   --- */

typedef struct problem {
    const char *name;
    int n, m, calls;
    void (*residuals)(const struct problem *p, const double *x, double *r);
    int noise; /* relative noise of 1e-k on the values, 0: none */
    uint64_t state;
} problem;

static double nan_value(void) { return strtod("nan", NULL); }
static float nan_f(void) { return (float)nan_value(); }

static const double bard_y[] = {.14, .18, .22, .25, .29, .32, .35, .39, .37, .58, .73, .96, 1.34, 2.10, 4.39};

static void rosenbrock(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
}
static void freudenstein_roth(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = -13 + x[0] + ((5 - x[1]) * x[1] - 2) * x[1];
    r[1] = -29 + x[0] + ((x[1] + 1) * x[1] - 14) * x[1];
}
static void powell_badly_scaled(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = 1e4 * x[0] * x[1] - 1;
    r[1] = exp(-x[0]) + exp(-x[1]) - 1.0001;
}
static void beale(const problem *p, const double *x, double *r)
{
    static const double y[3] = {1.5, 2.25, 2.625};
    int i;
    (void)p;
    for (i = 0; i < 3; ++i) r[i] = y[i] - x[0] * (1 - pow(x[1], i + 1));
}
static void jennrich_sampson(const problem *p, const double *x, double *r)
{
    int i;
    (void)p;
    for (i = 1; i <= 10; ++i) r[i - 1] = 2 + 2 * i - (exp(i * x[0]) + exp(i * x[1]));
}
static void bard(const problem *p, const double *x, double *r)
{
    int i;
    (void)p;
    for (i = 1; i <= 15; ++i) {
        double u = i, v = 16 - i, w = u < v ? u : v;
        r[i - 1] = bard_y[i - 1] - (x[0] + u / (v * x[1] + w * x[2]));
    }
}
static void box3d(const problem *p, const double *x, double *r)
{
    int i;
    (void)p;
    for (i = 1; i <= 10; ++i) {
        double t = 0.1 * i;
        r[i - 1] = exp(-t * x[0]) - exp(-t * x[1]) - x[2] * (exp(-t) - exp(-10 * t));
    }
}
static void wood(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
    r[2] = sqrt(90.0) * (x[3] - x[2] * x[2]);
    r[3] = 1 - x[2];
    r[4] = sqrt(10.0) * (x[1] + x[3] - 2);
    r[5] = (x[1] - x[3]) / sqrt(10.0);
}
static void brown_dennis(const problem *p, const double *x, double *r)
{
    int i;
    (void)p;
    for (i = 1; i <= 20; ++i) {
        double t = i / 5.0, a = x[0] + t * x[1] - exp(t), b = x[2] + x[3] * sin(t) - cos(t);
        r[i - 1] = a * a + b * b;
    }
}
static void biggs_exp6(const problem *p, const double *x, double *r)
{
    int i;
    (void)p;
    for (i = 1; i <= 13; ++i) {
        double t = 0.1 * i, y = exp(-t) - 5 * exp(-10 * t) + 3 * exp(-4 * t);
        r[i - 1] = x[2] * exp(-t * x[0]) - x[3] * exp(-t * x[1]) + x[5] * exp(-t * x[4]) - y;
    }
}
static void watson(const problem *p, const double *x, double *r)
{
    int i, j;
    for (i = 1; i <= 29; ++i) {
        double t = i / 29.0, a = 0, b = 0, power = 1;
        for (j = 0; j < p->n; ++j) {
            b += x[j] * power;
            if (j + 1 < p->n) a += (j + 1) * x[j + 1] * power;
            power *= t;
        }
        r[i - 1] = a - b * b - 1;
    }
    r[29] = x[0];
    r[30] = x[1] - x[0] * x[0] - 1;
}
static void variably_dimensioned(const problem *p, const double *x, double *r)
{
    int j;
    double sum = 0;
    for (j = 0; j < p->n; ++j) {
        r[j] = x[j] - 1;
        sum += (j + 1) * (x[j] - 1);
    }
    r[p->n] = sum;
    r[p->n + 1] = sum * sum;
}
static void brown_almost_linear(const problem *p, const double *x, double *r)
{
    int j;
    double sum = 0, product = 1;
    for (j = 0; j < p->n; ++j) {
        sum += x[j];
        product *= x[j];
    }
    for (j = 0; j < p->n; ++j) r[j] = x[j] + sum - (p->n + 1);
    r[p->n - 1] = product - 1;
}
static void linear_rank1(const problem *p, const double *x, double *r)
{
    int i, j;
    double sum = 0;
    for (j = 0; j < p->n; ++j) sum += (j + 1) * x[j];
    for (i = 0; i < p->m; ++i) r[i] = (i + 1) * sum - 1;
}
static void helical_valley(const problem *p, const double *x, double *r)
{
    double theta = x[0] > 0 ? atan(x[1] / x[0]) / 6.283185307179586
        : x[0] < 0          ? atan(x[1] / x[0]) / 6.283185307179586 + 0.5
        : x[1] >= 0         ? 0.25
                            : -0.25;
    (void)p;
    r[0] = 10 * (x[2] - 10 * theta);
    r[1] = 10 * (sqrt(x[0] * x[0] + x[1] * x[1]) - 1);
    r[2] = x[2];
}
static void powell_singular(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = x[0] + 10 * x[1];
    r[1] = sqrt(5.0) * (x[2] - x[3]);
    r[2] = (x[1] - 2 * x[2]) * (x[1] - 2 * x[2]);
    r[3] = sqrt(10.0) * (x[0] - x[3]) * (x[0] - x[3]);
}
static void kowalik_osborne(const problem *p, const double *x, double *r)
{
    static const double y[] = {.1957, .1947, .1735, .1600, .0844, .0627, .0456, .0342, .0323, .0235, .0246};
    static const double u[] = {4, 2, 1, .5, .25, .167, .125, .1, .0833, .0714, .0625};
    int i;
    (void)p;
    for (i = 0; i < 11; ++i) r[i] = y[i] - x[0] * (u[i] * u[i] + u[i] * x[1]) / (u[i] * u[i] + u[i] * x[2] + x[3]);
}
static void meyer(const problem *p, const double *x, double *r)
{
    static const double y[] = {34780, 28610, 23650, 19630, 16370, 13720, 11540, 9744,
                               8261,  7030,  6005,  5147,  4427,  3820,  3307,  2872};
    int i;
    (void)p;
    for (i = 0; i < 16; ++i) r[i] = x[0] * exp(x[1] / (45 + 5 * (i + 1) + x[2])) - y[i];
}
static void gaussian(const problem *p, const double *x, double *r)
{
    static const double y[] = {.0009, .0044, .0175, .0540, .1295, .2420, .3521, .3989,
                               .3521, .2420, .1295, .0540, .0175, .0044, .0009};
    int i;
    (void)p;
    for (i = 0; i < 15; ++i) {
        double t = (8 - (i + 1)) / 2.0;
        r[i] = x[0] * exp(-x[1] * (t - x[2]) * (t - x[2]) / 2) - y[i];
    }
}
static void brown_badly_scaled(const problem *p, const double *x, double *r)
{
    (void)p;
    r[0] = x[0] - 1e6;
    r[1] = x[1] - 2e-6;
    r[2] = x[0] * x[1] - 2;
}
static void osborne1(const problem *p, const double *x, double *r)
{
    static const double y[] = {.844, .908, .932, .936, .925, .908, .881, .850, .818, .784, .751,
                               .718, .685, .658, .628, .603, .580, .558, .538, .522, .506, .490,
                               .478, .467, .457, .448, .438, .431, .424, .420, .414, .411, .406};
    int i;
    (void)p;
    for (i = 0; i < 33; ++i) r[i] = y[i] - (x[0] + x[1] * exp(-10 * i * x[3]) + x[2] * exp(-10 * i * x[4]));
}
static void trigonometric(const problem *p, const double *x, double *r)
{
    int i, j;
    double sum = 0;
    for (j = 0; j < p->n; ++j) sum += cos(x[j]);
    for (i = 0; i < p->n; ++i) r[i] = p->n - sum + (i + 1) * (1 - cos(x[i])) - sin(x[i]);
}
static void broyden_tridiagonal(const problem *p, const double *x, double *r)
{
    int i;
    for (i = 0; i < p->n; ++i)
        r[i] = (3 - 2 * x[i]) * x[i] - (i > 0 ? x[i - 1] : 0) - 2 * (i + 1 < p->n ? x[i + 1] : 0) + 1;
}
static void chebyquad(const problem *p, const double *x, double *r)
{
    int i, j;
    for (i = 0; i < p->m; ++i) r[i] = 0;
    for (j = 0; j < p->n; ++j) {
        double t0 = 1, t1 = 2 * x[j] - 1, y = 2 * t1;
        for (i = 0; i < p->m; ++i) {
            double t2 = y * t1 - t0;
            r[i] += t1;
            t0 = t1;
            t1 = t2;
        }
    }
    for (i = 0; i < p->m; ++i) {
        r[i] /= p->n;
        if (i % 2 == 1) r[i] += 1.0 / ((i + 1.0) * (i + 1.0) - 1);
    }
}

static ms_status evaluate(void *user, const double *x, double *r, double *jacobian)
{
    problem *p = (problem *)user;
    int i, j;
    (void)jacobian;
    p->calls++;
    p->residuals(p, x, r);
    if (p->noise)
        for (i = 0; i < p->m; ++i) r[i] *= 1 + pow(10.0, -p->noise) * (2 * test_uniform(&p->state) - 1);
    if (jacobian) { /* complex steps are not to be had in C++: fourth-order differences, good to about 1e-11 */
        double moved[64], a[64], b[64], c[64], d[64];
        memcpy(moved, x, (size_t)p->n * sizeof(double));
        for (j = 0; j < p->n; ++j) {
            double h = 1e-3 * (fabs(x[j]) > 1e-2 ? fabs(x[j]) : 1e-2);
            moved[j] = x[j] + h;
            p->residuals(p, moved, a);
            moved[j] = x[j] - h;
            p->residuals(p, moved, b);
            moved[j] = x[j] + 2 * h;
            p->residuals(p, moved, c);
            moved[j] = x[j] - 2 * h;
            p->residuals(p, moved, d);
            moved[j] = x[j];
            for (i = 0; i < p->m; ++i) jacobian[i * p->n + j] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * h);
        }
    }
    return MS_OK;
}

/* The sum of squares at x. */
static double evaluate_value(const ms_pme_function *f, const double *x)
{
    double r[64], sum = 0;
    size_t i;
    evaluate(f->user, x, r, NULL);
    for (i = 0; i < f->residual_count; ++i) sum += r[i] * r[i];
    return sum;
}

/* Sets x to its start and f to the problem; returns what MGH print as the minimum (of the sum of squares). */
typedef struct published {
    const char *name;
    int n, m;
    void (*residuals)(const problem *, const double *, double *);
    double start[10]; /* repeated cyclically */
    int starts;
    double minimum, tolerance; /* absolute; published digits, or what rounding leaves of 0 */
} published;

static const published extra[] = {
    {"rosenbrock", 2, 2, rosenbrock, {-1.2, 1}, 2, 0, 1e-20},
    {"beale", 2, 3, beale, {1, 1}, 2, 0, 1e-20},
    {"powell_badly_scaled", 2, 2, powell_badly_scaled, {0, 1}, 2, 0, 1e-20},
    {"brown_badly_scaled", 2, 3, brown_badly_scaled, {1, 1}, 2, 0, 1e-12},
    {"jennrich_sampson", 2, 10, jennrich_sampson, {0.3, 0.4}, 2, 124.362, 6e-4},
    {"helical_valley", 3, 3, helical_valley, {-1, 0, 0}, 3, 0, 1e-20},
    {"bard", 3, 15, bard, {1, 1, 1}, 3, 8.21487e-3, 1e-8}, /* printed digits are cut, not rounded */
    {"gaussian", 3, 15, gaussian, {0.4, 1, 0}, 3, 1.12793e-8, 6e-14},
    {"meyer", 3, 16, meyer, {0.02, 4000, 250}, 3, 87.9458, 6e-5},
    {"powell_singular", 4, 4, powell_singular, {3, -1, 0, 1}, 4, 0, 1e-15}, /* singular Jacobian at 0: linear
                                                                               convergence */
    {"wood", 4, 6, wood, {-3, -1, -3, -1}, 4, 0, 1e-20},
    {"kowalik_osborne", 4, 11, kowalik_osborne, {0.25, 0.39, 0.415, 0.39}, 4, 3.07505e-4, 1e-9},
    {"brown_dennis", 4, 20, brown_dennis, {25, 5, -5, -1}, 4, 85822.2, 6e-2},
    {"osborne1", 5, 33, osborne1, {0.5, 1.5, -1, 0.01, 0.02}, 5, 5.46489e-5, 6e-11},
    {"watson6", 6, 31, watson, {0}, 1, 2.28767e-3, 6e-9},
    {"watson9", 9, 31, watson, {0}, 1, 1.39976e-6, 6e-12},
    {"trigonometric", 10, 10, trigonometric, {0.1}, 1, 2.79506e-5, 1e-10}, /* this or 0 */
    {"broyden_tridiagonal", 10, 10, broyden_tridiagonal, {-1}, 1, 0, 1e-20},
    {"broyden_tridiagonal_60", 60, 60, broyden_tridiagonal, {-1}, 1, 0, 1e-20},
    {"chebyquad8",
     8,
     8,
     chebyquad,
     {1 / 9., 2 / 9., 3 / 9., 4 / 9., 5 / 9., 6 / 9., 7 / 9., 8 / 9.},
     8,
     3.51687e-3,
     6e-9},
    {"variably_dimensioned_1", 1, 3, variably_dimensioned, {0}, 1, 0, 1e-20},
    {"linear_rank1_10", 10, 20, linear_rank1, {1}, 1, 20. * 19 / (2 * 41), 1e-8}, /* m(m-1)/(2(2m+1)), rank deficient */
};

static ms_pme_function function_of(problem *p, int n, int m,
                                   void (*residuals)(const problem *, const double *, double *))
{
    ms_pme_function f;
    memset(&f, 0, sizeof f);
    memset(p, 0, sizeof *p);
    p->n = n;
    p->m = m;
    p->residuals = residuals;
    f.user = p;
    f.parameter_count = n;
    f.residual_count = (size_t)m;
    f.residuals = evaluate;
    return f;
}

static void test_published(void)
{
    size_t k, i;
    double most = 0;
    for (k = 0; k < sizeof extra / sizeof extra[0]; ++k) {
        int differences;
        for (differences = 0; differences < 2; ++differences) {
            problem p;
            ms_pme_function f = function_of(&p, extra[k].n, extra[k].m, extra[k].residuals);
            ms_pme_options o = ms_pme_defaults();
            ms_pme_result result;
            double x[64], slack = extra[k].tolerance;
            f.residuals_only = differences;
            o.max_cost = 1e5;
            o.tolerance = 1e-12;
            for (i = 0; i < (size_t)extra[k].n; ++i) x[i] = extra[k].start[i % (size_t)extra[k].starts];
            CHECK_INT(ms_pme_minimize(&f, &o, x, &result, NULL), MS_OK);
            /* forward differences leave a Jacobian good to 1e-8: minima that are 0 are reached to about its square */
            if (differences && slack < 1e-13) slack = 1e-13;
            if (!(result.value <= extra[k].minimum + slack))
                TEST_FAIL("%s%s: %.9g, published %.9g", extra[k].name, differences ? " by differences" : "",
                          result.value, extra[k].minimum);
            most = result.cost > most ? result.cost : most;
        }
    }
    TEST_NOTE("%d problems, with Jacobian and by differences; at most %.0f evaluations", (int)k, most);
}

static const struct {
    const char *name;
    void (*residuals)(const problem *, const double *, double *);
} named[] = {{"rosenbrock", rosenbrock},
             {"freudenstein_roth", freudenstein_roth},
             {"powell_badly_scaled", powell_badly_scaled},
             {"beale", beale},
             {"jennrich_sampson", jennrich_sampson},
             {"bard", bard},
             {"box3d", box3d},
             {"wood", wood},
             {"brown_dennis", brown_dennis},
             {"biggs_exp6", biggs_exp6},
             {"watson", watson},
             {"variably_dim", variably_dimensioned},
             {"brown_almost_linear", brown_almost_linear},
             {"linear_rank1", linear_rank1}};

/* tests/data/pme_problems.json: how many problems end within `slack` of the minimum that a trust-region solver reached
   from the same start. Every answer must lie in the box and not above the start. */
static int solved(double slack)
{
    json *file = json_load("tests/data/pme_problems.json"), *list = json_get(file, "problems");
    int k, j, count = 0;
    size_t t;
    for (k = 0; k < list->count; ++k) {
        json *e = &list->child[k];
        const char *name = json_get(e, "name")->text;
        double *start = json_numbers(json_get(e, "start"), NULL), *low = NULL, *high = NULL, x[64];
        double reached = json_number(json_get(e, "sum_sq_reached_from_start"));
        problem p;
        ms_pme_options o = ms_pme_defaults();
        ms_pme_result result;
        ms_pme_function f = function_of(&p, (int)json_number(json_get(e, "n")), (int)json_number(json_get(e, "m")),
                                        NULL);
        for (t = 0; t < sizeof named / sizeof named[0]; ++t)
            if (strncmp(name, named[t].name, strlen(named[t].name)) == 0) p.residuals = named[t].residuals;
        if (json_get(e, "lower")->kind == 'a') {
            low = json_numbers(json_get(e, "lower"), NULL);
            high = json_numbers(json_get(e, "upper"), NULL);
        }
        f.lower = low;
        f.upper = high;
        o.max_cost = 20000;
        memcpy(x, start, (size_t)p.n * sizeof *x);
        CHECK_INT(ms_pme_minimize(&f, &o, x, &result, NULL), MS_OK);
        CHECK_LE(result.value, json_number(json_get(e, "start_sum_sq")) * (1 + 1e-12));
        CHECK_LE(result.cost, o.max_cost);
        for (j = 0; j < p.n && low; ++j)
            if (x[j] < low[j] || x[j] > high[j]) TEST_FAIL("%s: x%d = %.17g is outside its bounds", name, j, x[j]);
        if (result.value <= reached * (1 + slack) + 1e-9 * slack) ++count;
        free(start);
        free(low);
        free(high);
    }
    json_free(file);
    return count;
}

static void test_reference(void)
{
    int count = solved(1e-7);
    CHECK_INT(count, 14);
    TEST_NOTE("14 problems within 1e-7 of the trust-region solver's minima");
}

/* --- NIST StRD: certified values of nonlinear regression --- */

enum { NIST_ROWS = 250, NIST_PARAMETERS = 9 };
typedef struct nist {
    char name[16];
    int n, m, predictors;
    double start[2][NIST_PARAMETERS], certified[NIST_PARAMETERS], sum_of_squares;
    double y[NIST_ROWS], x[NIST_ROWS][2];
} nist;

/* The model of a data set at observation i. */
static double nist_model(const nist *d, const double *b, int i)
{
    const double x = d->x[i][0], pi = 3.14159265358979323846;
    const char *name = d->name;
    if (strcmp(name, "Bennett5") == 0) return b[0] * pow(b[1] + x, -1 / b[2]);
    if (strcmp(name, "BoxBOD") == 0 || strcmp(name, "Misra1a") == 0) return b[0] * (1 - exp(-b[1] * x));
    if (strncmp(name, "Chwirut", 7) == 0) return exp(-b[0] * x) / (b[1] + b[2] * x);
    if (strcmp(name, "DanWood") == 0) return b[0] * pow(x, b[1]);
    if (strcmp(name, "ENSO") == 0)
        return b[0] + b[1] * cos(2 * pi * x / 12) + b[2] * sin(2 * pi * x / 12) + b[4] * cos(2 * pi * x / b[3]) +
            b[5] * sin(2 * pi * x / b[3]) + b[7] * cos(2 * pi * x / b[6]) + b[8] * sin(2 * pi * x / b[6]);
    if (strcmp(name, "Eckerle4") == 0) return b[0] / b[1] * exp(-0.5 * (x - b[2]) / b[1] * ((x - b[2]) / b[1]));
    if (strncmp(name, "Gauss", 5) == 0)
        return b[0] * exp(-b[1] * x) + b[2] * exp(-(x - b[3]) / b[4] * ((x - b[3]) / b[4])) +
            b[5] * exp(-(x - b[6]) / b[7] * ((x - b[6]) / b[7]));
    if (strcmp(name, "Hahn1") == 0 || strcmp(name, "Thurber") == 0)
        return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1 + x * (b[4] + x * (b[5] + x * b[6])));
    if (strcmp(name, "Kirby2") == 0) return (b[0] + x * (b[1] + x * b[2])) / (1 + x * (b[3] + x * b[4]));
    if (strncmp(name, "Lanczos", 7) == 0) return b[0] * exp(-b[1] * x) + b[2] * exp(-b[3] * x) + b[4] * exp(-b[5] * x);
    if (strcmp(name, "MGH09") == 0) return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
    if (strcmp(name, "MGH10") == 0) return b[0] * exp(b[1] / (x + b[2]));
    if (strcmp(name, "MGH17") == 0) return b[0] + b[1] * exp(-x * b[3]) + b[2] * exp(-x * b[4]);
    if (strcmp(name, "Misra1b") == 0) return b[0] * (1 - pow(1 + b[1] * x / 2, -2));
    if (strcmp(name, "Misra1c") == 0) return b[0] * (1 - pow(1 + 2 * b[1] * x, -0.5));
    if (strcmp(name, "Misra1d") == 0) return b[0] * b[1] * x / (1 + b[1] * x);
    if (strcmp(name, "Nelson") == 0) return b[0] - b[1] * x * exp(-b[2] * d->x[i][1]);
    if (strcmp(name, "Rat42") == 0) return b[0] / (1 + exp(b[1] - b[2] * x));
    if (strcmp(name, "Rat43") == 0) return b[0] / pow(1 + exp(b[1] - b[2] * x), 1 / b[3]);
    if (strcmp(name, "Roszman1") == 0) return b[0] - b[1] * x - atan(b[2] / (x - b[3])) / pi;
    return nan_value();
}

static ms_status nist_residuals(void *user, const double *b, double *r, double *jacobian)
{
    const nist *d = (const nist *)user;
    int i, j, k;
    for (i = 0; i < d->m; ++i) r[i] = nist_model(d, b, i) - d->y[i];
    for (j = 0; j < d->n && jacobian; ++j) /* fourth-order differences, good to about 1e-11 */
        for (i = 0; i < d->m; ++i) {
            static const double weight[4] = {-1, 8, -8, 1};
            double h = 1e-3 * fabs(b[j]) + 1e-12, moved[NIST_PARAMETERS], sum = 0;
            memcpy(moved, b, (size_t)d->n * sizeof *b);
            for (k = 0; k < 4; ++k) {
                moved[j] = b[j] + h * (k < 2 ? 2 - k : 1 - k);
                sum += weight[k] * nist_model(d, moved, i);
            }
            jacobian[i * d->n + j] = sum / (12 * h);
        }
    return MS_OK;
}

/* All 27 problems from both starts of the data sets at the default tolerance: every parameter to four digits of its
   certified value. */
static void test_nist(void)
{
    char *text = test_read_file("tests/data/nist_strd.txt", NULL), *at = text;
    static nist d;
    int sets = 0, good = 0, s, i, j;
    double least = 99;
    if (text == NULL) TEST_FAIL("%s", "tests/data/nist_strd.txt cannot be read");
    while (at != NULL && *at == '#') at = strchr(at, '\n') + 1;
    while (at != NULL && *at != 0 && sscanf(at, "%15s %d %d %d", d.name, &d.n, &d.m, &d.predictors) == 4) {
        at = strchr(at, '\n') + 1;
        for (i = 0; i < 3 * d.n; ++i) (i < 2 * d.n ? d.start[i / d.n] : d.certified)[i % d.n] = strtod(at, &at);
        d.sum_of_squares = strtod(at, &at);
        for (i = 0; i < d.m; ++i) {
            d.y[i] = strtod(at, &at);
            for (j = 0; j < d.predictors; ++j) d.x[i][j] = strtod(at, &at);
            if (strcmp(d.name, "Nelson") == 0) d.y[i] = log(d.y[i]);
        }
        at += strspn(at, " \n");
        for (s = 0; s < 2; ++s) {
            ms_pme_function f;
            ms_pme_options o = ms_pme_defaults();
            ms_pme_result result;
            double b[NIST_PARAMETERS], worst = 0;
            memset(&f, 0, sizeof f);
            f.user = &d;
            f.parameter_count = d.n;
            f.residual_count = (size_t)d.m;
            f.residuals = nist_residuals;
            o.max_cost = 20000;
            memcpy(b, d.start[s], sizeof b);
            memset(&result, 0, sizeof result);
            CHECK_INT(ms_pme_minimize(&f, &o, b, &result, NULL), MS_OK);
            for (j = 0; j < d.n; ++j) worst = fmax(worst, fabs(b[j] / d.certified[j] - 1));
            least = fmin(least, worst < 1e-4 ? -log10(worst) : 99);
            good += worst < 1e-4;
            if (!(worst < 1e-4)) TEST_FAIL("%s, start %d: %.1f digits", d.name, s + 1, -log10(worst));
            /* Lanczos1: residuals of 8e-14 beside values of 2.5, each good to an ulp of 4e-16 as exp is elsewhere */
            if (worst < 1e-4)
                CHECK_NEAR(result.value, d.sum_of_squares, (d.sum_of_squares < 1e-24 ? 1e-2 : 2e-3) * d.sum_of_squares);
        }
        ++sets;
    }
    CHECK_INT(sets, 27);
    CHECK_INT(good, 54);
    free(text);
    TEST_NOTE("%d of 54 starts to four digits, %.1f at least", good, least);
}

/* --- functions that misbehave --- */

typedef struct odd {
    int kind; /* 0: x'x shifted; 1: NaN for x0 > 0.6; 2: noise; 3: fails at a call; 4: NaN everywhere; 5, 6: Jacobian
                 not finite */
    int calls, fail_at;
    uint64_t state;
} odd;

static ms_status odd_residuals(void *user, const double *x, double *r, double *jacobian)
{
    odd *o = (odd *)user;
    if (++o->calls == o->fail_at) return MS_IO;
    r[0] = sqrt(3.0) * (x[0] - 0.7);
    r[1] = x[1] + 0.2;
    r[2] = 1;
    if (o->kind == 1 && x[0] > 0.6) r[0] = nan_value();
    if (o->kind == 2) r[2] = sqrt(1 + 1e-3 * test_uniform(&o->state));
    if (o->kind == 4) r[2] = nan_value();
    if (jacobian) {
        memset(jacobian, 0, 6 * sizeof *jacobian);
        jacobian[0] = o->kind == 5 ? (double)HUGE_VAL : sqrt(3.0);
        jacobian[3] = 1;
        if (o->kind == 6) jacobian[5] = nan_value();
    }
    return MS_OK;
}

static ms_pme_function odd_function(odd *o, int kind, int differences, const double *low, const double *high)
{
    ms_pme_function f;
    memset(&f, 0, sizeof f);
    memset(o, 0, sizeof *o);
    o->kind = kind;
    f.user = o;
    f.parameter_count = 2;
    f.residual_count = 3;
    f.residuals = odd_residuals;
    f.residuals_only = differences;
    f.lower = low;
    f.upper = high;
    return f;
}

static void test_misbehavior(void)
{
    static const double low[2] = {-1, -1}, high[2] = {1, 1};
    int differences;
    ms_error error;
    odd o;
    for (differences = 0; differences < 2; ++differences) {
        ms_pme_function f = odd_function(&o, 0, differences, low, high);
        ms_pme_options options = ms_pme_defaults();
        ms_pme_result result;
        double x[2] = {0.125, 0.125};
        options.max_cost = 600;
        CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), MS_OK);
        CHECK_NEAR(result.value, 1, 1e-9); /* the tolerance, relative 1e-10, on a value of 1 */
        /* NaN beyond x0 = 0.6: the edge is the best there is; a quadratic is lost there, so 0.05 is asked for */
        f = odd_function(&o, 1, differences, low, high);
        x[0] = x[1] = 0.125;
        CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), MS_OK);
        CHECK(result.value < 1 + 3 * 0.15 * 0.15 + 0.05 && x[0] <= 0.6);
        /* never finite, and a Jacobian that is not */
        f = odd_function(&o, 4, differences, low, high);
        x[0] = x[1] = 0.125;
        CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), MS_INVALID_ARGUMENT);
        f = odd_function(&o, 5, 0, low, high);
        x[0] = x[1] = 0.125;
        CHECK_INT(ms_pme_minimize(&f, &options, x, &result, &error), MS_BAD_DATA);
        CHECK(x[0] >= 0.125 && x[0] <= 0.125 && strstr(error.message, "derivative by parameter 0") != NULL);
    }
}

static void test_failing_callback(void)
{
    static const double low[2] = {-1, -1}, high[2] = {1, 1};
    int k;
    for (k = 1; k < 6; ++k) {
        odd o;
        ms_pme_function f = odd_function(&o, 0, k % 2, low, high);
        ms_pme_options options = ms_pme_defaults();
        test_memory memory;
        ms_error error;
        double x[2] = {0.125, 0.125};
        memset(&memory, 0, sizeof memory);
        options.allocator.user = &memory;
        options.allocator.alloc = test_memory_alloc;
        options.allocator.release = test_memory_release;
        o.fail_at = k;
        CHECK_INT(ms_pme_minimize(&f, &options, x, NULL, &error), MS_IO);
        CHECK_INT(error.status, MS_IO);
        CHECK(x[0] == 0.125 && x[1] == 0.125);
        CHECK_INT(memory.blocks, 0);
    }
}

/* Constant residuals: every start ends with its first Jacobian. */
static ms_status plain(void *calls, const double *x, double *r, double *jacobian)
{
    (void)x;
    r[0] = 1;
    if (jacobian != NULL) jacobian[0] = 0;
    return ++*(int *)calls > 100000 ? MS_CANCELLED : MS_OK;
}

static void test_budgets(void)
{
    { /* Jacobians that cost next to nothing end as well */
        ms_pme_function f;
        ms_pme_options options = ms_pme_defaults();
        ms_pme_result result;
        int calls = 0;
        double x = 0;
        memset(&f, 0, sizeof f);
        f.user = &calls;
        f.parameter_count = 1;
        f.residual_count = 1;
        f.residuals = plain;
        f.jacobian_cost = 1e-300;
        options.max_cost = 10;
        options.restarts = INT_MAX;
        CHECK_INT(ms_pme_minimize(&f, &options, &x, &result, NULL), MS_OK);
        CHECK(calls >= 9 && calls <= 10); /* 1 each */
        CHECK_INT(result.stop, MS_PME_STOP_COST);
    }
    {
        problem p;
        ms_pme_function f = function_of(&p, 4, 6, wood);
        ms_pme_options options = ms_pme_defaults();
        ms_pme_result result;
        double x[4] = {-3, -1, -3, -1}, budget;
        memset(&result, 0, sizeof result);
        for (budget = 1; budget < 40; budget += 6.5) {
            options.max_cost = budget;
            CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), budget < 2 ? MS_INVALID_ARGUMENT : MS_OK);
            CHECK(result.cost <= budget || (budget < 2 && result.cost == 0));
        }
        /* what fits exactly is spent: whole numbers of evaluations, and more starts than the budget holds */
        f.jacobian_cost = 1;
        options.restarts = 1000;
        for (budget = 20; budget < 60; budget += 7) {
            options.max_cost = budget;
            CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), MS_OK);
            CHECK_NEAR(result.cost, budget, 0);
        }
    }
}

static void test_starts(void)
{
    /* outside the box, on its corner, a parameter that cannot move, one side open */
    static const double low[4] = {0, 0, 2, -1e9}, high[4] = {0.5, 0.9, 2, 1.5};
    static const double start[3][4] = {{-100, 50, 7, 3}, {0, 0.9, 2, 1.5}, {0.5, 0, 2, -5}};
    int k, j;
    double value[3];
    for (k = 0; k < 3; ++k) {
        problem p;
        ms_pme_function f = function_of(&p, 4, 6, wood);
        ms_pme_options options = ms_pme_defaults();
        ms_pme_result result;
        double x[4];
        f.lower = low;
        f.upper = high;
        options.max_cost = 4000;
        memcpy(x, start[k], sizeof x);
        CHECK_INT(ms_pme_minimize(&f, &options, x, &result, NULL), MS_OK);
        for (j = 0; j < 4; ++j) CHECK(x[j] >= low[j] && x[j] <= high[j]);
        value[k] = result.value;
    }
    CHECK_NEAR(value[1], value[0], 1e-9 * value[0]);
    CHECK_NEAR(value[2], value[0], 1e-9 * value[0]);
    TEST_NOTE("minimum %.9g on a face, from three starts", value[0]);
}

static void test_arguments(void)
{
    double x[2] = {0.5, 0.5}, low[2] = {0, 0}, high[2] = {1, 1};
    odd o;
    ms_pme_function f = odd_function(&o, 0, 1, low, high), bad;
    ms_pme_options options = ms_pme_defaults();
    ms_error error;
    CHECK_INT(ms_pme_minimize(NULL, NULL, x, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_pme_minimize(&f, NULL, NULL, NULL, NULL), MS_INVALID_ARGUMENT);
    bad = f;
    bad.residuals = NULL;
    CHECK_INT(ms_pme_minimize(&bad, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strcmp(error.message, "function->residuals is NULL") == 0);
    bad = f;
    bad.residual_count = 0;
    CHECK_INT(ms_pme_minimize(&bad, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    bad = f;
    bad.parameter_count = 0;
    CHECK_INT(ms_pme_minimize(&bad, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    bad.parameter_count = MS_PME_PARAMETERS_MAX + 1;
    CHECK_INT(ms_pme_minimize(&bad, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    low[1] = 2; /* an empty box */
    CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 1);
    CHECK(strstr(error.message, "bounds of parameter 1 are 2 and 1") != NULL);
    low[1] = nan_value();
    CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    low[1] = 0;
    x[1] = nan_value();
    CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 1);
    x[1] = 0.5;
    options.tolerance = nan_value();
    CHECK_INT(ms_pme_minimize(&f, &options, x, NULL, &error), MS_INVALID_ARGUMENT);
}

/* --- a renderer: 6 parameters -> 48 float pixels through a fixed smooth network; its last layer is linear --- */

enum { N = 6, H = 20, P = 48 };
typedef struct renderer_state {
    double w1[H][N + 1], w2[P][H + 1];
    int renders, jacobians, fail_at;
    const double *truth; /* of the predictions */
} renderer_state;

static void renderer_make(renderer_state *s)
{
    uint64_t state = 7 + test_seed;
    int i, j;
    memset(s, 0, sizeof *s);
    for (i = 0; i < H; ++i)
        for (j = 0; j <= N; ++j) s->w1[i][j] = 1.2 * test_normal(&state);
    for (i = 0; i < P; ++i)
        for (j = 0; j <= H; ++j) s->w2[i][j] = 0.3 * test_normal(&state);
}

static void renderer_features(const renderer_state *s, const double *x, double *h, double dh[][N])
{
    int i, j;
    for (i = 0; i < H; ++i) {
        double a = s->w1[i][N];
        for (j = 0; j < N; ++j) a += s->w1[i][j] * x[j];
        h[i] = tanh(a);
        for (j = 0; j < N && dh; ++j) dh[i][j] = (1 - h[i] * h[i]) * s->w1[i][j];
    }
}

static ms_status render(void *user, const double *x, float *image)
{
    renderer_state *s = (renderer_state *)user;
    double h[H];
    int i, k;
    if (++s->renders == s->fail_at) return MS_UNSUPPORTED;
    renderer_features(s, x, h, NULL);
    for (i = 0; i < P; ++i) {
        double y = s->w2[i][H];
        for (k = 0; k < H; ++k) y += s->w2[i][k] * h[k];
        image[i] = (float)y;
    }
    return MS_OK;
}

static ms_status render_jacobian(void *user, const double *x, float *image, float *jacobian)
{
    renderer_state *s = (renderer_state *)user;
    double h[H], dh[H][N];
    int i, j, k;
    ms_status status = render(user, x, image);
    s->jacobians++;
    renderer_features(s, x, h, dh);
    for (i = 0; i < P; ++i)
        for (j = 0; j < N; ++j) {
            double t = 0;
            for (k = 0; k < H; ++k) t += s->w2[i][k] * dh[k][j];
            jacobian[i * N + j] = (float)t;
        }
    return status;
}

static ms_status predict(void *user, int i, const float *target, double *x)
{
    const renderer_state *s = (const renderer_state *)user;
    int j;
    (void)target;
    for (j = 0; j < N; ++j) x[j] = i == 0 ? 0.9 : i == 1 ? s->truth[j] + (j % 2 ? 0.15 : -0.15) : nan_value();
    return MS_OK;
}

static ms_pme_renderer renderer_of(renderer_state *s)
{
    ms_pme_renderer r;
    memset(&r, 0, sizeof r);
    r.user = s;
    r.parameter_count = N;
    r.image_size = P;
    r.render = render;
    r.jacobian = render_jacobian;
    return r;
}

static const double truth[N] = {0.3, 0.8, 0.55, 0.1, 0.65, 0.4};

static void test_match(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P], image[P], weight[P];
    double x[N];
    int i, j;
    renderer_make(&s);
    r = renderer_of(&s);
    s.truth = truth;
    r.predict = predict;
    r.prediction_count = 3;
    render(&s, truth, target);
    /* from the predictions: the third is refused, the second is best */
    CHECK_INT(ms_pme_match(&r, target, NULL, NULL, x, image, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 1);
    CHECK_LE(result.rmse, 1e-6); /* the picture is float32 of size 1 */
    for (j = 0; j < N; ++j) CHECK_NEAR(x[j], truth[j], 1e-4);
    CHECK_LE(result.refine.cost, 50);
    TEST_NOTE("rmse %.2g -> %.2g in %.0f renders", result.rmse_initial, result.rmse, result.cost);
    /* the answer of the frame before beats them; its result is what a sequence carries over */
    options.candidates = x;
    options.candidate_count = 1;
    options.initial_only = 1;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, image, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 3);
    CHECK_NEAR(result.rmse, result.rmse_initial, 1e-9);
    /* no predictions at all: the middle; then random ones */
    memset(&options, 0, sizeof options);
    r.prediction_count = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 0);
    options.random_count = 20;
    options.refine.seed = 3;
    options.refine.max_cost = 300;
    options.refine.restarts = 5;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_LE(result.rmse, 1e-6);
    /* pixels with weight 0 may hold anything */
    for (i = 0; i < P; ++i) weight[i] = i % 3 == 0 ? 0.0f : 0.5f;
    for (i = 0; i < P; i += 3) target[i] = i % 2 ? nan_f() : 1e30f;
    CHECK_INT(ms_pme_match(&r, target, weight, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_LE(result.rmse, 1e-6);
    for (j = 0; j < N; ++j) CHECK_NEAR(x[j], truth[j], 1e-4);
    /* by differences alone */
    r.jacobian = NULL;
    CHECK_INT(ms_pme_match(&r, target, weight, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_LE(result.rmse, 2e-3); /* forward differences of 1e-3 */
}

/* One pixel, a shallow dip at 0.2 and the deep one at 0.8. */
static ms_status two_dips(void *user, const double *x, float *image)
{
    (void)user;
    image[0] = (float)(0.1 - 0.09 * exp(-pow((x[0] - 0.2) / 0.08, 2)) - 0.1 * exp(-pow((x[0] - 0.8) / 0.05, 2)));
    return MS_OK;
}

static void test_restarts(void)
{
    static const double candidates[2] = {0.25, 0.84}, none[1] = {HUGE_VAL};
    const float target = 0;
    ms_pme_renderer r = ms_pme_renderer_defaults();
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    double x;
    r.parameter_count = 1;
    r.image_size = 1;
    r.render = two_dips;
    /* the better candidate leads to the worse dip; what is left of the budget goes to the other one */
    options.candidates = candidates;
    options.candidate_count = 2;
    options.refine.max_cost = 300;
    CHECK_INT(ms_pme_match(&r, &target, NULL, &options, &x, NULL, &result, NULL), MS_OK);
    CHECK_NEAR(x, 0.2, 0.02);
    options.refine.restarts = 1;
    CHECK_INT(ms_pme_match(&r, &target, NULL, &options, &x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 0);
    CHECK_NEAR(x, 0.8, 0.02);
    CHECK_LE(result.refine.cost, 300);
    /* candidates that are not finite: the middle of the box takes their place */
    options.candidates = none;
    options.candidate_count = 1;
    options.initial_only = 1;
    CHECK_INT(ms_pme_match(&r, &target, NULL, &options, &x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 1);
    CHECK_NEAR(x, 0.5, 0);
}

/* A restart that improves is finished at the full tolerance: large residuals, so that steps converge linearly, and the
   better candidate leads to the worse minimum. */
static ms_status slow_basins(void *user, const double *x, double *r, double *jacobian)
{
    const double u = 5 * (x[0] - 0.8), v = (x[0] - 0.2) / 0.05, w = exp(-v * v), wide = exp(-0.5 * u * u);
    (void)user;
    r[0] = 1 - 0.4 * u * u;
    r[1] = u;
    r[2] = 6 * (1 - w - wide);
    if (jacobian != NULL) {
        jacobian[0] = -4 * u;
        jacobian[1] = 5;
        jacobian[2] = 6 * (2 * v / 0.05 * w + 5 * u * wide);
    }
    return MS_OK;
}

static void test_finished_restarts(void)
{
    static const double low[1] = {0}, high[1] = {1};
    ms_pme_function f;
    ms_pme_options o = ms_pme_defaults();
    ms_pme_result result;
    double x, least = HUGE_VAL, value;
    int i, seed, improved = 0;
    memset(&f, 0, sizeof f);
    f.parameter_count = 1;
    f.residual_count = 3;
    f.residuals = slow_basins;
    f.lower = low;
    f.upper = high;
    for (i = 0; i <= 1000000; ++i) { /* the minimum, by trying them all */
        double at = 1e-6 * i, r[3];
        slow_basins(NULL, &at, r, NULL);
        value = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        if (value < least) least = value;
    }
    for (seed = 0; seed < 20; ++seed) {
        o.seed = (uint64_t)seed;
        o.restarts = 8;
        o.max_cost = 2000;
        x = 0.2;
        CHECK_INT(ms_pme_minimize(&f, &o, &x, &result, NULL), MS_OK);
        if (!(result.value < 1.01 * least)) continue; /* stayed in the worse one */
        ++improved;
        CHECK_NEAR(result.value, least, 1e-8 * least); /* steps shrink by a fifth: some times the tolerance is left */
    }
    CHECK(improved > 10);
}

/* The first step of a match of two parameters, one with a hundredth of the other's effect: the damping of 1e-3 is that
   of the columns, but no less than 0.3 of the largest, so that the weak one goes a third of its way. */
enum { WEAK_CALLS = 4 };
static double weak_tried[WEAK_CALLS][2];
static int weak_calls;
static ms_status weak_render(void *user, const double *x, float *image)
{
    (void)user;
    if (weak_calls < WEAK_CALLS) memcpy(weak_tried[weak_calls++], x, sizeof weak_tried[0]);
    image[0] = image[1] = (float)x[0];
    image[2] = (float)(0.01 * x[1]);
    return MS_OK;
}
static ms_status weak_jacobian(void *user, const double *x, float *image, float *jacobian)
{
    (void)user;
    image[0] = image[1] = (float)x[0];
    image[2] = (float)(0.01 * x[1]);
    memset(jacobian, 0, 6 * sizeof *jacobian);
    jacobian[0] = jacobian[2] = 1;
    jacobian[5] = 0.01f;
    return MS_OK;
}

static void test_weak_parameter(void)
{
    static const double start[2] = {0.5, 0.5};
    static const float target[3] = {0.6f, 0.6f, 0.006f};
    ms_pme_renderer r = ms_pme_renderer_defaults();
    ms_pme_match_options options = ms_pme_match_defaults();
    double x[2];
    r.parameter_count = 2;
    r.image_size = 3;
    r.render = weak_render;
    r.jacobian = weak_jacobian;
    options.candidates = start;
    options.candidate_count = 1;
    weak_calls = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL), MS_OK);
    CHECK(weak_calls >= 2); /* the candidate, then the first trial; pictures of floats */
    CHECK_NEAR(weak_tried[1][0] - 0.5, 0.1 / (1 + 1e-3), 1e-6);
    CHECK_NEAR(weak_tried[1][1] - 0.5, 0.1 * 1e-4 / (1e-4 + 1e-3 * 0.3 * 0.3 * 2), 1e-5);
}

/* By differences from the ends of the range inwards: there the step is taken to the other side. */
static ms_status from_the_ends(void *user, const double *x, double *r, double *jacobian)
{
    (void)user, (void)jacobian;
    r[0] = x[0] - 0.3;
    r[1] = x[1] - 0.6;
    return MS_OK;
}

static void test_from_the_ends(void)
{
    static const double low[2] = {0, 0}, high[2] = {1, 1};
    int start;
    for (start = 0; start < 4; ++start) {
        ms_pme_function f;
        double x[2];
        memset(&f, 0, sizeof f);
        x[0] = start & 1;
        x[1] = start >> 1;
        f.parameter_count = 2;
        f.residual_count = 2;
        f.residuals = from_the_ends;
        f.residuals_only = 1;
        f.lower = low;
        f.upper = high;
        CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, NULL), MS_OK);
        CHECK_NEAR(x[0], 0.3, 1e-9); /* linear: the difference is exact but for rounding, 1e-16 / 1e-8 */
        CHECK_NEAR(x[1], 0.6, 1e-9);
    }
}

/* Rosenbrock's valley (1960) over [-2, 2]^2. */
static ms_status valley(void *user, const double *x, float *image)
{
    const double u = 4 * x[0] - 2, v = 4 * x[1] - 2;
    (void)user;
    image[0] = (float)(10 * (v - u * u));
    image[1] = (float)(1 - u);
    return MS_OK;
}

/* A budget that is not enough for two starts goes to the best one: the way is that without restarts. */
static void test_short_budget(void)
{
    static const double candidates[6] = {0.1, 0.9, 0.2, 0.75, 0.3, 0.9};
    static const float target[2] = {0, 0};
    ms_pme_renderer r = ms_pme_renderer_defaults();
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result[2];
    double x[2][2];
    int budget, k;
    r.parameter_count = 2;
    r.image_size = 2;
    r.render = valley;
    options.candidates = candidates;
    options.candidate_count = 3;
    options.initial_only = 1; /* the second is the nearest: u = -1.2, v = 1 */
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x[0], NULL, &result[0], NULL), MS_OK);
    CHECK_INT(result[0].best_candidate, 1);
    CHECK_NEAR(result[0].rmse_initial, sqrt((4.4 * 4.4 + 2.2 * 2.2) / 2), 1e-5); /* a picture of floats */
    CHECK_NEAR(result[0].rmse, result[0].rmse_initial, 1e-5);
    options.initial_only = 0;
    for (budget = 12; budget < 30; budget += 2) { /* ten steps of a value and two differences */
        options.refine.max_cost = budget;
        for (k = 0; k < 2; ++k) {
            options.refine.restarts = 2 * k;
            CHECK_INT(ms_pme_match(&r, target, NULL, &options, x[k], NULL, &result[k], NULL), MS_OK);
            CHECK_INT(result[k].refine.stop, MS_PME_STOP_COST);
        }
        CHECK_NEAR(result[1].rmse, result[0].rmse, 0);
        CHECK_NEAR(x[1][0], x[0][0], 0);
        CHECK_NEAR(x[1][1], x[0][1], 0);
    }
}

static double walked[300][2];
static int walked_count;
static ms_status walking(void *user, const double *x, float *image)
{
    if (walked_count < 300) memcpy(walked[walked_count++], x, sizeof walked[0]);
    return valley(user, x, image);
}

/* Without a Jacobian several starts take turns: differences follow a value at their own point, whoever stepped before.
 */
static void test_turns(void)
{
    static const double candidates[8] = {0.1, 0.9, 0.2, 0.7, 0.3, 0.85, 0.9, 0.2};
    static const float target[2] = {0, 0};
    ms_pme_renderer r = ms_pme_renderer_defaults();
    ms_pme_match_options options = ms_pme_match_defaults();
    double x[2];
    int k, found = 0;
    r.parameter_count = 2;
    r.image_size = 2;
    r.render = walking;
    options.candidates = candidates;
    options.candidate_count = 4;
    options.refine.max_cost = 200;
    options.refine.restarts = 3;
    walked_count = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL), MS_OK);
    for (k = 1; k + 1 < walked_count; ++k) {
        const double base[2] = {walked[k + 1][0], walked[k][1]}; /* of two differences, by a thousandth of the range */
        if (fabs(fabs(walked[k][0] - base[0]) - 1e-3) > 1e-9 || fabs(fabs(walked[k + 1][1] - base[1]) - 1e-3) > 1e-9)
            continue;
        ++found;
        CHECK(!memcmp(walked[k - 1], base, sizeof base));
    }
    CHECK(found > 20);
}

/* A parameter without effect, between the others: the same steps as without it, and it stays where it was. */
static void idle_middle(const problem *p, const double *x, double *r)
{
    const double y[3] = {x[0], x[2], x[3]};
    helical_valley(p, y, r);
}
static void test_no_effect(void)
{
    problem p[2];
    ms_pme_function with = function_of(&p[0], 4, 3, idle_middle), without = function_of(&p[1], 3, 3, helical_valley);
    ms_pme_result a, b;
    double x[4] = {-1, 0.25, 0, 0}, y[3] = {-1, 0, 0};
    CHECK_INT(ms_pme_minimize(&with, NULL, x, &a, NULL), MS_OK);
    CHECK_INT(ms_pme_minimize(&without, NULL, y, &b, NULL), MS_OK);
    CHECK_INT(a.evaluations, b.evaluations);
    CHECK_INT(a.jacobians, b.jacobians);
    CHECK_NEAR(x[1], 0.25, 0);
    CHECK_NEAR(x[0], y[0], 1e-12); /* rounding of the steps */
    CHECK_NEAR(x[2], y[1], 1e-12);
    CHECK_NEAR(x[3], y[2], 1e-12);
}

/* The budget is the caller's, 50 unless said; the second of two candidates behind predictions is taken where it is
   best. */
static void test_match_budget(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P];
    double x[N], candidates[2 * N];
    uint64_t state = 3;
    int i, j;
    renderer_make(&s);
    r = renderer_of(&s);
    s.truth = truth;
    r.predict = predict;
    r.prediction_count = 1;
    render(&s, truth, target);
    for (i = 0; i < P; ++i) target[i] += (float)(0.3 * test_normal(&state));
    for (j = 0; j < N; ++j) {
        candidates[j] = 0.95;
        candidates[N + j] = truth[j];
    }
    options.candidates = candidates;
    options.candidate_count = 2;
    options.refine.restarts = 1000;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.best_candidate, 2);
    CHECK(result.refine.cost > 46 && result.refine.cost <= 50);
    options.refine.max_cost = 7;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK(result.refine.cost > 3 && result.refine.cost <= 7);
    options.refine.max_cost = 200;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK(result.refine.cost > 190 && result.refine.cost <= 200);
}

static void test_match_arguments(void)
{
    renderer_state s;
    ms_pme_renderer r, bad;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    float target[P], weight[P];
    double x[N] = {7, 7, 7, 7, 7, 7}, low[N] = {0}, high[N];
    int i, k;
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    for (i = 0; i < P; ++i) weight[i] = 0;
    CHECK_INT(ms_pme_match(&r, target, weight, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "every weight is 0") != NULL);
    weight[5] = -1;
    CHECK_INT(ms_pme_match(&r, target, weight, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 5);
    target[9] = nan_f();
    CHECK_INT(ms_pme_match(&r, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 9);
    target[9] = 0;
    bad = r;
    bad.image_size = 0;
    CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    bad = r;
    bad.render = NULL;
    CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_pme_match(NULL, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_pme_match(&r, NULL, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    bad = r;
    bad.prediction_count = 1;
    CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    bad = r;
    bad.parameter_count = 0;
    CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    for (i = 0; i < N; ++i) high[i] = i == 2 ? -1 : 1;
    bad = r;
    bad.lower = low;
    bad.upper = high;
    CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 2);
    for (k = 0; k < 3; ++k) { /* a range that is no number: where would its middle be? */
        low[2] = k == 1 ? -1.7e308 : 0;
        high[2] = k == 0 ? (double)HUGE_VAL : 1.7e308;
        if (k == 2) low[2] = -(double)HUGE_VAL;
        CHECK_INT(ms_pme_match(&bad, target, NULL, NULL, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
        CHECK_INT(error.position, 2);
        CHECK(strstr(error.message, "no finite range between them") != NULL);
    }
    options.candidate_count = 1;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    for (k = 1; k < 8; ++k) { /* a renderer that fails midway, the last render included */
        s.renders = 0;
        s.fail_at = k;
        CHECK_INT(ms_pme_match(&r, target, NULL, NULL, x, NULL, &result, &error), MS_UNSUPPORTED);
        CHECK(strstr(error.message, "callback failed") != NULL);
    }
    for (i = 0; i < N; ++i) CHECK(x[i] == 7);
}

/* The collapsed objective: with the last layer linear, |W h + b - t|^2 = |R h - q|^2 + rest. Here R and q by normal
   equations in double, good enough for a test: R'R = W'W. */
typedef struct collapse {
    renderer_state *s;
    double r[H][H], q[H], rest;
} collapse;

static void collapse_make(collapse *c, renderer_state *s, const float *target)
{
    double g[H][H], b[H];
    int i, j, k;
    memset(c, 0, sizeof *c);
    c->s = s;
    for (i = 0; i < H; ++i) {
        b[i] = 0;
        for (k = 0; k < P; ++k) b[i] += s->w2[k][i] * ((double)target[k] - s->w2[k][H]);
        for (j = 0; j < H; ++j) {
            g[i][j] = 0;
            for (k = 0; k < P; ++k) g[i][j] += s->w2[k][i] * s->w2[k][j];
        }
    }
    for (j = 0; j < H; ++j) /* Cholesky, R upper; then R'q = b */
        for (i = 0; i <= j; ++i) {
            double t = g[i][j];
            for (k = 0; k < i; ++k) t -= c->r[k][i] * c->r[k][j];
            c->r[i][j] = i == j ? sqrt(t) : t / c->r[i][i];
        }
    for (i = 0; i < H; ++i) {
        double t = b[i];
        for (k = 0; k < i; ++k) t -= c->r[k][i] * c->q[k];
        c->q[i] = t / c->r[i][i];
    }
    for (k = 0; k < P; ++k) c->rest += ((double)target[k] - s->w2[k][H]) * ((double)target[k] - s->w2[k][H]);
    for (i = 0; i < H; ++i) c->rest -= c->q[i] * c->q[i];
}

static double collapse_scale = 1; /* of all residuals: a function made for something else */
static ms_status collapse_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const collapse *c = (const collapse *)user;
    double h[H], dh[H][N];
    int i, j, k;
    renderer_features(c->s, x, h, dh);
    r[H] = sqrt(c->rest); /* what no parameter changes */
    for (j = 0; j < N && jacobian; ++j) jacobian[H * N + j] = 0;
    for (i = 0; i < H; ++i) {
        r[i] = -c->q[i];
        for (k = i; k < H; ++k) r[i] += c->r[i][k] * h[k];
        for (j = 0; j < N && jacobian; ++j) {
            jacobian[i * N + j] = 0;
            for (k = i; k < H; ++k) jacobian[i * N + j] += c->r[i][k] * dh[k][j];
        }
    }
    for (i = 0; i <= H; ++i) r[i] *= collapse_scale;
    return MS_OK;
}

static void test_reduced(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result direct, reduced;
    ms_pme_function f;
    collapse c;
    float target[P];
    double x[N], y[N], worst = 0, size = 0;
    int i, j;
    uint64_t state = 99;
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    for (i = 0; i < P; ++i) target[i] += (float)(0.2 * test_normal(&state)); /* out of reach */
    collapse_make(&c, &s, target);
    memset(&f, 0, sizeof f);
    f.user = &c;
    f.parameter_count = N;
    f.residual_count = H + 1;
    f.residuals = collapse_residuals;
    options.candidates = truth;
    options.candidate_count = 1;
    options.refine.max_cost = 500;
    options.refine.tolerance = 1e-14;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &direct, NULL), MS_OK);
    r.reduced = &f;
    s.renders = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, y, NULL, &reduced, NULL), MS_OK);
    CHECK_INT(s.renders, 1);
    CHECK_NEAR(reduced.rmse, direct.rmse, 1e-6 * direct.rmse); /* the issue's bound; float32 pictures on one side */
    CHECK_NEAR(sqrt(reduced.refine.value), reduced.rmse, 1e-6);
    for (j = 0; j < N; ++j) worst = fabs(x[j] - y[j]) > worst ? fabs(x[j] - y[j]) : worst;
    CHECK_LE(worst, 1e-3); /* flat directions: 1e-6 in the value is its root in x */
    for (i = 0; i < P; ++i) size += (double)target[i] * (double)target[i] / (double)P;
    for (i = 0; i < 4; ++i) { /* a thousandth of the RMSE and 1e-5 of the target may be off, on both sides */
        const double allowed = 1e-3 + 1e-5 * sqrt(size) / direct.rmse;
        collapse_scale = 1 + (i % 2 ? 1.02 : 0.98) * (i < 2 ? allowed : -allowed);
        options.initial_only = 1;
        options.candidates = x;
        CHECK_INT(ms_pme_match(&r, target, NULL, &options, y, NULL, NULL, NULL), i % 2 ? MS_INVALID_ARGUMENT : MS_OK);
    }
    collapse_scale = 1;
    TEST_NOTE("rmse %.9g direct, %.9g collapsed, x differs by %.1e", direct.rmse, reduced.rmse, worst);
}

/* The standard deviations of a match are the diagonal of (J'J / sigma^2 + 12 I)^-1, sigma the RMSE of the answer: here
   by Gauss and Jordan. Two parameters that count only by their sum have half the variance of a uniform one each. One
   that is locked has 0, and is no unknown to the others, whatever it does to the picture. */
static void test_deviations(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P], image[P], jacobian[P * N];
    double x[N], deviation[N], a[N][2 * N];
    uint64_t state = 12;
    int i, j, k, way;
    enum { ALL_FREE, TWO_BY_THEIR_SUM, ONE_LOCKED, WAYS };
    const int locked = 2;
    for (way = 0; way < WAYS; ++way) {
        double low[N] = {0}, high[N] = {1, 1, 1, 1, 1, 1};
        renderer_make(&s);
        for (i = 0; i < H && way == TWO_BY_THEIR_SUM; ++i) s.w1[i][4] = s.w1[i][3];
        r = renderer_of(&s);
        if (way == ONE_LOCKED) low[locked] = high[locked] = truth[locked];
        r.lower = low;
        r.upper = high;
        render(&s, truth, target);
        for (i = 0; i < P; ++i) target[i] += (float)(1e-3 * test_normal(&state));
        options.candidates = truth;
        options.candidate_count = 1;
        options.deviation = deviation;
        CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
        render_jacobian(&s, x, image, jacobian);
        for (k = 0; k < P && way == ONE_LOCKED; ++k) jacobian[k * N + locked] = 0;
        for (i = 0; i < N; ++i)
            for (j = 0; j < 2 * N; ++j) {
                a[i][j] = j == i ? 12 : j == i + N;
                for (k = 0; k < P && j < N; ++k)
                    a[i][j] += (double)jacobian[k * N + i] * (double)jacobian[k * N + j] / (result.rmse * result.rmse);
            }
        for (k = 0; k < N; ++k)
            for (i = 0; i < N; ++i) {
                double t = a[i][k] / a[k][k];
                for (j = 0; j < 2 * N && i != k; ++j) a[i][j] -= t * a[k][j];
            }
        for (j = 0; j < N; ++j) /* derivatives in float32 */
            CHECK_NEAR(deviation[j], way == ONE_LOCKED && j == locked ? 0 : sqrt(a[j][N + j] / a[j][j]),
                       1e-5 * deviation[j]);
        for (j = 3; j < 5 && way == TWO_BY_THEIR_SUM; ++j) CHECK_NEAR(deviation[j], sqrt(1 / 24.0), 1e-3);
    }
}

/* Random candidates are uniform in the box, all different, others for another seed, and the best of them is taken. */
typedef struct recorder {
    renderer_state s;
    double x[64][N];
    int count;
} recorder;

static ms_status record(void *user, const double *x, float *image)
{
    recorder *r = (recorder *)user;
    if (r->count < 64) memcpy(r->x[r->count++], x, sizeof r->x[0]);
    return render(&r->s, x, image);
}

static void test_random_candidates(void)
{
    enum { COUNT = 50 };
    static recorder r[2];
    const double low[N] = {-1, 0, 5, 0, 0, 0}, high[N] = {3, 1, 5, 1, 1, 1e-3};
    float target[P];
    int way, i, j, k;
    for (way = 0; way < 2; ++way) {
        ms_pme_match_options options = ms_pme_match_defaults();
        ms_pme_match_result result;
        ms_pme_renderer renderer;
        double x[N];
        renderer_make(&r[way].s);
        render(&r[way].s, truth, target);
        renderer = renderer_of(&r[way].s);
        renderer.user = &r[way];
        renderer.render = record;
        renderer.lower = low;
        renderer.upper = high;
        options.random_count = COUNT;
        options.initial_only = 1;
        options.refine.seed = (uint64_t)(3 + way);
        r[way].count = 0;
        CHECK_INT(ms_pme_match(&renderer, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
        CHECK_INT(r[way].count, COUNT + 1); /* and the answer once more */
        CHECK(result.best_candidate >= 0 && memcmp(x, r[way].x[result.best_candidate], sizeof x) == 0);
        for (j = 0; j < N; ++j) {
            const double range = high[j] - low[j];
            double sum = 0, least = HUGE_VAL, largest = -HUGE_VAL;
            for (i = 0; i < COUNT; ++i) {
                const double v = r[way].x[i][j];
                CHECK(v >= low[j] && v <= high[j]);
                for (k = 0; k < i && range > 0; ++k) CHECK(v < r[way].x[k][j] || v > r[way].x[k][j]);
                sum += (v - low[j]) / (double)COUNT;
                least = fmin(least, v);
                largest = fmax(largest, v);
            }
            if (!(range > 0)) continue;
            CHECK_NEAR(sum, 0.5 * range, 5 * range / sqrt(12 * (double)COUNT)); /* five standard errors */
            /* 0.8^50 = 1e-5: none within a fifth of an end */
            CHECK(least < low[j] + 0.2 * range && largest > high[j] - 0.2 * range);
        }
    }
    CHECK(memcmp(r[0].x[0], r[1].x[0], sizeof r[0].x[0]) != 0);
}

static void test_repeatable(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result a, b;
    float target[P];
    double x[N], y[N];
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    options.random_count = 5;
    options.refine.restarts = 3;
    options.refine.max_cost = 200;
    options.refine.seed = 11;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &a, NULL), MS_OK);
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, y, NULL, &b, NULL), MS_OK);
    CHECK(memcmp(x, y, sizeof x) == 0 && a.cost == b.cost);
}

static void test_allocation(void)
{
    renderer_state s;
    ms_pme_renderer r;
    problem p;
    ms_pme_function f = function_of(&p, 4, 6, wood);
    float target[P];
    double x[N];
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    TEST_ALLOCATION_SWEEP(10, {
        ms_pme_match_options options = ms_pme_match_defaults();
        options.refine.allocator = allocator;
        status = ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL);
    });
    TEST_ALLOCATION_SWEEP(10, {
        ms_pme_options options = ms_pme_defaults();
        options.allocator = allocator;
        x[0] = x[2] = -3;
        x[1] = x[3] = -1;
        status = ms_pme_minimize(&f, &options, x, NULL, NULL);
    });
}

/* The value is f at x, whatever ended the run. */
static void test_result_value(void)
{
    static const double low[4] = {-1, -1, -1, -1}, high[4] = {0.5, 2, 2, 2};
    int bounded, restarts;
    double cost;
    for (bounded = 0; bounded < 2; ++bounded)
        for (restarts = 0; restarts < 3; restarts += 2)
            for (cost = 3; cost < 2000; cost *= 1.37) {
                problem p;
                ms_pme_function f = function_of(&p, 4, 6, wood);
                ms_pme_options o = ms_pme_defaults();
                ms_pme_result result;
                double x[4] = {-3, -1, -3, -1};
                f.lower = bounded ? low : NULL;
                f.upper = bounded ? high : NULL;
                o.max_cost = cost;
                o.restarts = restarts;
                CHECK_INT(ms_pme_minimize(&f, &o, x, &result, NULL), MS_OK);
                CHECK_LE(result.cost, cost);
                CHECK_NEAR(result.value, evaluate_value(&f, x), 1e-12 * result.value + 1e-25);
                CHECK_NEAR(result.cost, (double)result.evaluations + 2 * (double)result.jacobians, 1e-9);
            }
}

/* --- residuals of many sizes, bounds of any number, clocks --- */

typedef struct scaled {
    double scale;
} scaled;

static ms_status scaled_rosenbrock(void *user, const double *x, double *r, double *jacobian)
{
    double scale = ((scaled *)user)->scale;
    r[0] = scale * (10 * (x[1] - x[0] * x[0]));
    r[1] = scale * (1 - x[0]);
    r[2] = scale * 0.5;
    if (jacobian) {
        jacobian[0] = scale * (-20 * x[0]);
        jacobian[1] = scale * 10;
        jacobian[2] = -scale;
        jacobian[3] = jacobian[4] = jacobian[5] = 0;
    }
    return MS_OK;
}

/* Residuals up to 1e300 are numbers; larger ones are worse than any. */
static void test_sizes(void)
{
    static const double sizes[] = {1, 1e120, 1e-120, 1e301};
    size_t k;
    int differences;
    for (differences = 0; differences < 2; ++differences)
        for (k = 0; k < 4; ++k) {
            scaled s;
            ms_pme_function f;
            ms_pme_result result;
            double x[2] = {-1.2, 1};
            memset(&f, 0, sizeof f);
            s.scale = sizes[k];
            f.user = &s;
            f.parameter_count = 2;
            f.residual_count = 3;
            f.residuals = scaled_rosenbrock;
            f.residuals_only = differences;
            CHECK_INT(ms_pme_minimize(&f, NULL, x, &result, NULL), k < 3 ? MS_OK : MS_INVALID_ARGUMENT);
            if (k == 3) continue;
            CHECK_INT(result.stop, MS_PME_STOP_CONVERGED);
            CHECK_NEAR(x[0], 1, differences ? 1e-5 : 1e-8);
            CHECK_NEAR(x[1], 1, differences ? 2e-5 : 2e-8);
            CHECK_NEAR(result.value, 0.25 * sizes[k] * sizes[k], 1e-9 * sizes[k] * sizes[k]);
        }
}

/* |A x - b| for a random A, 400 x n. */
typedef struct linear {
    int m, n;
    double *a, *b;
} linear;

static ms_status linear_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const linear *l = (const linear *)user;
    int i, j;
    for (i = 0; i < l->m; ++i) {
        r[i] = -l->b[i];
        for (j = 0; j < l->n; ++j) r[i] += l->a[i * l->n + j] * x[j];
    }
    if (jacobian) memcpy(jacobian, l->a, (size_t)(l->m * l->n) * sizeof *jacobian);
    return MS_OK;
}

/* A box that cuts off most of the parameters: the conditions of Karush, Kuhn and Tucker hold at the answer. */
static void test_many_bounds(void)
{
    static const int sizes[] = {3, 20, 256};
    int k, i, j;
    for (k = 0; k < 3; ++k) {
        linear l;
        ms_pme_function f;
        ms_pme_options o = ms_pme_defaults();
        ms_pme_result result;
        double x[256], low[256], high[256], *r, size = 0;
        int at_bounds = 0;
        uint64_t state = test_seed + (uint64_t)k;
        l.n = sizes[k];
        l.m = 400;
        l.a = (double *)malloc((size_t)(l.m * (l.n + 2)) * sizeof(double));
        l.b = l.a + l.m * l.n;
        r = l.b + l.m;
        for (i = 0; i < l.m * l.n; ++i) l.a[i] = test_normal(&state);
        for (i = 0; i < l.m; ++i) l.b[i] = 40 * test_normal(&state);
        for (j = 0; j < l.n; ++j) {
            low[j] = -1;
            high[j] = j % 3 ? 1 : 0.5;
            x[j] = 0;
        }
        memset(&f, 0, sizeof f);
        f.user = &l;
        f.parameter_count = l.n;
        f.residual_count = (size_t)l.m;
        f.residuals = linear_residuals;
        f.lower = low;
        f.upper = high;
        CHECK_INT(ms_pme_minimize(&f, &o, x, &result, NULL), MS_OK);
        linear_residuals(&l, x, r, NULL);
        for (i = 0; i < l.m; ++i) size += r[i] * r[i];
        for (j = 0; j < l.n; ++j) {
            double g = 0, column = 0;
            for (i = 0; i < l.m; ++i) {
                g += l.a[i * l.n + j] * r[i];
                column += l.a[i * l.n + j] * l.a[i * l.n + j];
            }
            g /= sqrt(size * column);
            CHECK(x[j] >= low[j] && x[j] <= high[j]);
            if (x[j] <= low[j]) CHECK(g > -1e-7);
            else if (x[j] >= high[j]) CHECK(g < 1e-7);
            else CHECK_NEAR(g, 0, 1e-5); /* a decrease of 1e-10 is converged: its root is the slope */
            at_bounds += x[j] <= low[j] || x[j] >= high[j];
        }
        if (l.n == 256) CHECK(at_bounds > 150);
        CHECK_LE(result.jacobians, 7); /* the model is exact: what is left is the damping, which falls by tens */
        TEST_NOTE("n = %d: %d at bounds, %.0f evaluations", l.n, at_bounds, result.cost);
        free(l.a);
    }
}

/* The step's own problem, from every first guess of the set: all free, all held low, all high. What was held wrongly is
   let go. */
static void test_active_set(void)
{
    enum { M = 12 };
    int guess, i, j, round;
    uint64_t state = test_seed + 9;
    for (round = 0; round < 20; ++round) {
        double a[M * (M + 1)], low[M], high[M], d[3][M];
        int set[M];
        for (i = 0; i < M; ++i) {
            for (j = 0; j <= M; ++j) a[i * (M + 1) + j] = j < i ? 0 : test_normal(&state) + (i == j ? 3 : 0);
            low[i] = -0.3 * test_uniform(&state);
            high[i] = 0.3 * test_uniform(&state);
        }
        for (guess = 0; guess < 3; ++guess) {
            for (j = 0; j < M; ++j) set[j] = guess == 2 ? -1 : guess;
            inside_bounded_least_squares(a, M, low, high, d[guess], set);
            for (j = 0; j < M; ++j) {
                double g = 0;
                for (i = 0; i < M; ++i) {
                    double r = -a[i * (M + 1) + M];
                    int k;
                    for (k = 0; k < M; ++k) r += a[i * (M + 1) + k] * d[guess][k];
                    g += a[i * (M + 1) + j] * r;
                }
                if (d[guess][j] <= low[j]) CHECK(g > -1e-10);
                else if (d[guess][j] >= high[j]) CHECK(g < 1e-10);
                else CHECK_NEAR(g, 0, 1e-10);            /* sums of some hundred products of size 10 */
                CHECK_NEAR(d[guess][j], d[0][j], 1e-10); /* the answer is the only one */
            }
        }
    }
}

/* Finite at one point alone: no difference can be taken there, on either side. */
static ms_status needle(void *user, const double *x, double *r, double *jacobian)
{
    (void)user;
    (void)jacobian;
    r[0] = x[0] >= 0.5 && x[0] <= 0.5 ? 1 : nan_value();
    r[1] = x[1];
    return MS_OK;
}

/* The steps of differences: those of a float32 picture are 1e-3, and where neither side is finite the derivative is bad
   data. */
static double stepped[3];
static int step_calls;
static ms_status stepping_render(void *user, const double *x, float *image)
{
    if (step_calls < 3) stepped[step_calls] = x[0];
    ++step_calls;
    return render(user, x, image);
}
static void test_differences(void)
{
    ms_pme_function f;
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_error error;
    float target[P];
    double x[N] = {0.5, 0.2}, start[N] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
    memset(&f, 0, sizeof f);
    f.parameter_count = 2;
    f.residual_count = 2;
    f.residuals = needle;
    f.residuals_only = 1;
    CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, &error), MS_BAD_DATA);
    CHECK_INT(error.position, 0);
    CHECK(x[0] >= 0.5 && x[0] <= 0.5);
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    r.render = stepping_render;
    r.jacobian = NULL;
    options.candidates = start;
    options.candidate_count = 1;
    options.refine.max_cost = 20;
    step_calls = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL), MS_OK);
    CHECK(stepped[0] >= 0.5 && stepped[0] <= 0.5); /* the candidate, again with derivatives in mind, then x_0 moved */
    CHECK_NEAR(stepped[2], 0.501, 1e-12);
}

/* The renderer in other units: x = (y - from) / range. */
typedef struct in_units {
    renderer_state s;
    double from[N], range[N];
} in_units;
static const double *plain_units(const in_units *u, const double *y)
{
    static double x[N];
    int j;
    for (j = 0; j < N; ++j) x[j] = (y[j] - u->from[j]) / u->range[j];
    return x;
}
static ms_status units_render(void *user, const double *y, float *image)
{
    in_units *u = (in_units *)user;
    return render(&u->s, plain_units(u, y), image);
}
static ms_status units_jacobian(void *user, const double *y, float *image, float *jacobian)
{
    in_units *u = (in_units *)user;
    ms_status status = render_jacobian(&u->s, plain_units(u, y), image, jacobian);
    int i;
    for (i = 0; i < P * N; ++i) jacobian[i] = (float)((double)jacobian[i] / u->range[i % N]);
    return status;
}

/* A match takes the same way whatever the units of the parameters: ranges by powers of two leave every rounding as it
   is but those of the bounds' differences. Restarts and deviations too. */
static void test_units(void)
{
    static const double from[N] = {-1, 3, 0, -8, 0.25, -64}, range[N] = {2, 0.5, 8, 16, 0.125, 128};
    in_units u;
    ms_pme_renderer r;
    float target[P];
    double x[2][N], deviation[2][N], low[N], high[N], candidate[2 * N], rmse[2], moved = 0;
    int units, restarts, budget, i, j;
    uint64_t state = 3;
    renderer_make(&u.s);
    render(&u.s, truth, target);
    for (i = 0; i < P; ++i) target[i] += (float)(0.2 * test_normal(&state));
    for (restarts = 0; restarts < 3; ++restarts)
        for (budget = 8; budget <= 800; budget *= 10) {
            for (units = 0; units < 2; ++units) {
                ms_pme_match_options options = ms_pme_match_defaults();
                ms_pme_match_result result;
                r = renderer_of(&u.s);
                r.user = &u;
                r.render = units_render;
                r.jacobian = units_jacobian;
                for (j = 0; j < N; ++j) {
                    u.from[j] = low[j] = units ? from[j] : 0;
                    u.range[j] = units ? range[j] : 1;
                    high[j] = low[j] + u.range[j];
                    candidate[j] = low[j] + 0.75 * u.range[j];
                    candidate[N + j] = low[j] + (j % 2 ? 0.25 : 0.5) * u.range[j];
                }
                r.lower = low;
                r.upper = high;
                options.candidates = candidate;
                options.candidate_count = 2;
                options.refine.max_cost = budget;
                options.refine.restarts = 4 * restarts;
                options.deviation = deviation[units];
                CHECK_INT(ms_pme_match(&r, target, NULL, &options, x[units], NULL, &result, NULL), MS_OK);
                CHECK_NEAR(result.cost, result.refine.cost + 3, 1e-9); /* two candidates and the last render */
                rmse[units] = result.rmse;
                memcpy(x[units], plain_units(&u, x[units]), sizeof x[units]);
                for (j = 0; j < N; ++j) {
                    deviation[units][j] /= u.range[j];
                    moved = fmax(moved, fabs(x[units][j] - 0.75));
                }
            }
            CHECK_NEAR(rmse[0], rmse[1], 1e-9 * rmse[0]);
            for (j = 0; j < N; ++j) CHECK_NEAR(deviation[0][j], deviation[1][j], 1e-5 * deviation[0][j]);
        }
    CHECK(moved > 0.1);
}

/* Hosts that unmask invalid operations, divisions by zero and overflows: nothing traps, whatever the function does. */
static void test_traps(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    static const double low[2] = {-1, -1}, high[2] = {1, 1};
    unsigned state = __builtin_ia32_stmxcsr();
    int kind, differences, open;
    scaled huge;
    huge.scale = 1e160;
    __builtin_ia32_ldmxcsr((state & ~0x3fu) & ~(0x80u | 0x200u | 0x400u));
    for (differences = 0; differences < 2; ++differences)
        for (open = 0; open < 2; ++open)
            for (kind = 0; kind < 6; ++kind) {
                odd o;
                ms_pme_function f = odd_function(&o, kind, differences, open ? NULL : low, open ? NULL : high);
                ms_pme_options options = ms_pme_defaults();
                double x[2] = {0.1, 0.1};
                options.max_cost = 300;
                options.restarts = 2;
                ms_pme_minimize(&f, &options, x, NULL, NULL);
                f.residuals = scaled_rosenbrock;
                f.user = &huge;
                ms_pme_minimize(&f, &options, x, NULL, NULL);
            }
    __builtin_ia32_ldmxcsr(state);
#else
    SKIP("no control of traps here");
#endif
}

/* An option that is out of range is named, with its value. */
static void test_option_messages(void)
{
    static const struct {
        size_t offset;
        const char *words;
    } list[] = {{offsetof(ms_pme_options, max_cost), "max_cost is -1"},
                {offsetof(ms_pme_options, tolerance), "tolerance is -1"}};
    problem p;
    ms_pme_function f = function_of(&p, 4, 6, wood);
    double x[4] = {-3, -1, -3, -1}, wrong;
    ms_error error;
    size_t k, v;
    for (k = 0; k < sizeof list / sizeof list[0]; ++k)
        for (v = 0; v < 3; ++v) {
            ms_pme_options o = ms_pme_defaults();
            wrong = v == 0 ? -1 : v == 1 ? nan_value() : (double)HUGE_VAL;
            memcpy((char *)&o + list[k].offset, &wrong, sizeof wrong);
            CHECK_INT(ms_pme_minimize(&f, &o, x, NULL, &error), MS_INVALID_ARGUMENT);
            if (strncmp(error.message, list[k].words, strlen(list[k].words) - (v ? 2 : 0)) != 0)
                TEST_FAIL("%s", error.message);
        }
    f.jacobian_cost = -1;
    CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strncmp(error.message, "jacobian_cost is -1", 19) == 0);
}

/* --- control of a match --- */

static void test_control(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P];
    double x[N], low[N], high[N], source[N], pull[N], deviation[N], free_rmse, sum = 0;
    int i, j;
    ms_error error;
    uint64_t state = 5;
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    options.candidates = truth;
    options.candidate_count = 1;
    options.refine.max_cost = 500;
    for (i = 0; i < P; ++i) target[i] += (float)(0.05 * test_normal(&state));
    options.deviation = deviation;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    free_rmse = result.rmse;
    for (j = 0; j < N; ++j) {
        CHECK(deviation[j] > 0 && deviation[j] <= 1 / sqrt(12.0));
        sum += (x[j] - truth[j]) * (x[j] - truth[j]) / (deviation[j] * deviation[j]);
    }
    sum /= (double)N;
    CHECK(sum > 0.05 && sum < 5); /* chi-square of 6: beyond these once in some thousand seeds */
    TEST_NOTE("errors over deviations: %.2f", sqrt(sum));
    { /* frozen where it is: the others are known no worse than before */
        double y[N], known[N], at_low[N], at_high[N];
        for (j = 0; j < N; ++j) {
            at_low[j] = j == 2 ? x[2] : 0;
            at_high[j] = j == 2 ? x[2] : 1;
        }
        r.lower = at_low;
        r.upper = at_high;
        options.deviation = known;
        CHECK_INT(ms_pme_match(&r, target, NULL, &options, y, NULL, &result, NULL), MS_OK);
        CHECK_NEAR(result.rmse, free_rmse, 1e-6 * free_rmse);
        for (j = 0; j < N; ++j) CHECK(known[j] <= deviation[j] * (1 + 1e-4) && (j == 2) == !(known[j] > 0));
        options.deviation = deviation;
    }
    /* frozen: equal bounds */
    for (j = 0; j < N; ++j) {
        low[j] = j == 2 ? 0.7 : 0;
        high[j] = j == 2 ? 0.7 : 1;
        source[j] = 0.9;
        pull[j] = j == 3 ? 1e6 : 0;
    }
    r.lower = low;
    r.upper = high;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_NEAR(x[2], 0.7, 0);
    CHECK_NEAR(deviation[2], 0, 0);
    CHECK(result.rmse > free_rmse);
    /* pulled */
    r.lower = r.upper = NULL;
    options.source = source;
    options.pull = pull;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_NEAR(x[3], 0.9, 1e-4); /* 1e6 (x - 0.9)^2 against an RMSE^2 below 1 */
    pull[1] = -1;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 1);
}

/* Every "0: value" by 0 and by the value: the same bits. */
static void test_defaults(void)
{
    static const double middle[N] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, zero[N] = {0}, one[N] = {1, 1, 1, 1, 1, 1};
    renderer_state s;
    ms_pme_renderer r;
    float target[P];
    double x[2][N];
    uint64_t state = 8;
    int given, differences, i;
    renderer_make(&s);
    render(&s, truth, target);
    for (i = 0; i < P; ++i) target[i] += (float)(0.3 * test_normal(&state));
    for (differences = 0; differences < 2; ++differences) {
        ms_pme_result result[2];
        ms_pme_match_result matched[2];
        for (given = 0; given < 2; ++given) {
            problem p;
            ms_pme_function f = function_of(&p, 4, 6, wood);
            ms_pme_options o = ms_pme_defaults();
            ms_pme_match_options options = ms_pme_match_defaults();
            double start[4] = {-3, -1, -3, -1};
            f.residuals_only = differences;
            r = renderer_of(&s);
            if (differences) r.jacobian = NULL;
            options.refine.restarts = 1000;
            if (given) {
                o.max_cost = 1000;
                o.tolerance = 1e-10;
                f.jacobian_cost = 1 + 4 / 4.0;
                r.jacobian_cost = 1 + (double)N / 4;
                r.lower = zero;
                r.upper = one;
                options.refine.max_cost = differences ? 8 * (1 + N) : 50;
                options.refine.tolerance = 1e-10;
                options.candidates = middle;
                options.candidate_count = 1;
            }
            CHECK_INT(ms_pme_minimize(&f, &o, start, &result[given], NULL), MS_OK);
            CHECK_INT(ms_pme_match(&r, target, NULL, &options, x[given], NULL, &matched[given], NULL), MS_OK);
        }
        CHECK(memcmp(x[0], x[1], sizeof x[0]) == 0);
        CHECK(result[0].value <= result[1].value && result[0].value >= result[1].value);
        CHECK_NEAR(result[0].cost, result[1].cost, 0);
        CHECK_NEAR(matched[0].cost, matched[1].cost, 0);
    }
    { /* as many parameters as there may be; one more is refused */
        problem p;
        ms_pme_function f = function_of(&p, MS_PME_PARAMETERS_MAX, 2, rosenbrock);
        ms_pme_options o = ms_pme_defaults();
        static double start[MS_PME_PARAMETERS_MAX + 1];
        f.residuals_only = 1; /* the problems have no derivatives of so many */
        o.max_cost = 300;
        CHECK_INT(ms_pme_minimize(&f, &o, start, NULL, NULL), MS_OK);
        f.parameter_count++;
        CHECK_INT(ms_pme_minimize(&f, &o, start, NULL, NULL), MS_INVALID_ARGUMENT);
    }
}

/* The reason of a stop: the budget. */
static void test_stop(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P];
    double x[N];
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    target[3] += 0.5f;
    options.random_count = 100;
    options.refine.max_cost = 20;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.refine.stop, MS_PME_STOP_COST);
}

/* --- contracts at any scale --- */

static double log_uniform(uint64_t *state, double low, double high)
{
    return pow(10.0, low + (high - low) * test_uniform(state));
}

/* Two Rosenbrock valleys in units of their own: u_j = x_j / unit_j, residuals times `size`. */
typedef struct any_units {
    double unit[4], size;
} any_units;
static ms_status any_units_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const any_units *a = (const any_units *)user;
    int k;
    for (k = 0; k < 2; ++k) {
        double u = x[2 * k] / a->unit[2 * k], v = x[2 * k + 1] / a->unit[2 * k + 1];
        r[2 * k] = 10 * (v - u * u) * a->size;
        r[2 * k + 1] = (1 - u) * a->size;
        if (jacobian == NULL) continue;
        memset(jacobian + 8 * k, 0, 8 * sizeof *jacobian);
        jacobian[8 * k + 2 * k] = -20 * u * a->size / a->unit[2 * k];
        jacobian[8 * k + 2 * k + 1] = 10 * a->size / a->unit[2 * k + 1];
        jacobian[8 * k + 4 + 2 * k] = -a->size / a->unit[2 * k];
    }
    return MS_OK;
}

/* Parameters and residuals of any size are found: each parameter's unit from 1e-200 to 1e200, residuals as far as
   their derivatives stay numbers. In a box and without one, by Jacobian and by differences. */
static void test_any_units(void)
{
    uint64_t state = 77 + test_seed;
    int round, bounded, differences, j;
    double worst = 0;
    for (round = 0; round < 200; ++round)
        for (bounded = 0; bounded < 2; ++bounded)
            for (differences = 0; differences < 2; ++differences) {
                any_units a;
                ms_pme_function f;
                ms_pme_options o = ms_pme_defaults();
                ms_pme_result result;
                double x[4], low[4], high[4];
                for (j = 0; j < 4; ++j) {
                    a.unit[j] = log_uniform(&state, -200, 200);
                    low[j] = -3 * a.unit[j];
                    high[j] = 2 * a.unit[j];
                    x[j] = (j % 2 ? 1.0 : -1.2) * a.unit[j];
                }
                a.size = log_uniform(&state, -90, 90);
                memset(&f, 0, sizeof f);
                f.user = &a;
                f.parameter_count = 4;
                f.residual_count = 4;
                f.residuals = any_units_residuals;
                f.residuals_only = differences;
                f.lower = bounded ? low : NULL;
                f.upper = bounded ? high : NULL;
                CHECK_INT(ms_pme_minimize(&f, &o, x, &result, NULL), MS_OK);
                CHECK_INT(result.stop, MS_PME_STOP_CONVERGED);
                CHECK(result.steps > 5);
                for (j = 0; j < 4; ++j) worst = fmax(worst, fabs(x[j] / a.unit[j] - 1));
            }
    CHECK_LE(worst, 1e-5); /* by differences, whose Jacobian is good to 1e-8 */
    TEST_NOTE("largest relative error %.1e", worst);
}

/* A picture without a Jacobian: ranges from 1e-200 to 1e200 away from 0 or around it, the same way in each. With a
   Jacobian of floats, from 1e-30 to 1e30. */
static void test_any_ranges(void)
{
    in_units u;
    ms_pme_renderer r;
    float target[P];
    double low[N], high[N], deviation[N], plain[N], candidate[N], worst = 0;
    uint64_t state = 78 + test_seed;
    int round, j, jacobian;
    renderer_make(&u.s);
    render(&u.s, truth, target);
    for (jacobian = 0; jacobian < 2; ++jacobian) {
        double first = -1;
        for (round = 0; round < 60; ++round) {
            ms_pme_match_options options = ms_pme_match_defaults();
            ms_pme_match_result result;
            double x[N];
            const double reach = jacobian ? 30 : 200;
            r = renderer_of(&u.s);
            r.user = &u;
            r.render = units_render;
            r.jacobian = jacobian ? units_jacobian : NULL;
            for (j = 0; j < N; ++j) {
                u.range[j] = round ? log_uniform(&state, -reach, reach) : 1;
                u.from[j] = round ? u.range[j] * (test_uniform(&state) - 0.5) : 0;
                low[j] = u.from[j];
                high[j] = u.from[j] + u.range[j];
                candidate[j] = low[j] + 0.6 * u.range[j];
            }
            r.lower = low;
            r.upper = high;
            options.candidates = candidate;
            options.candidate_count = 1;
            options.refine.max_cost = 300;
            options.deviation = deviation;
            CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
            CHECK_LE(result.rmse, jacobian ? 1e-5 : 2e-3); /* forward differences of a thousandth */
            memcpy(plain, plain_units(&u, x), sizeof plain);
            for (j = 0; j < N; ++j) {
                CHECK(deviation[j] >= 0 && deviation[j] <= 0.3 * u.range[j]);
                worst = fmax(worst, fabs(plain[j] - truth[j]));
            }
            if (first < 0) first = result.rmse;
        }
    }
    CHECK_LE(worst, 0.05);
    TEST_NOTE("largest error %.1e of the range", worst);
}

/* Deviations where some ranges are next to nothing or next to everything: the picture does not depend on those
   parameters, which must not change the deviations of the others. */
typedef struct lone_ranges {
    double low[N], range[N], slope[P][N];
    int dead[N], flushes; /* flushes: a call in a host that takes subnormals for 0, as tests/calls.sh makes one */
} lone_ranges;
static ms_status lone_render(void *user, const double *x, float *image)
{
    lone_ranges *s = (lone_ranges *)user;
    volatile double least = DBL_MIN;
    int i, j;
    s->flushes = !(least * 0.5 > 0);
    for (i = 0; i < P; ++i) {
        double sum = 0;
        for (j = 0; j < N; ++j) sum += s->dead[j] ? 0 : s->slope[i][j] * (x[j] - s->low[j]) / s->range[j];
        image[i] = (float)sum;
    }
    return MS_OK;
}
static ms_status lone_jacobian(void *user, const double *x, float *image, float *jacobian)
{
    const lone_ranges *s = (const lone_ranges *)user;
    int i, j;
    for (i = 0; i < P; ++i)
        for (j = 0; j < N; ++j) jacobian[i * N + j] = (float)(s->dead[j] ? 0 : s->slope[i][j] / s->range[j]);
    return lone_render(user, x, image);
}
static void test_lone_ranges(void)
{
    static const double extreme[] = {
        4.9406564584124654e-324, 1e-323, 1e-310, 2.2250738585072014e-308, 1e-170, 1e170, 1e307};
    uint64_t state = 91 + test_seed;
    int round, part, i, j;
    for (round = 0; round < 40; ++round) {
        lone_ranges s;
        ms_pme_renderer r = ms_pme_renderer_defaults();
        double low[N], high[N], deviation[2][N], x[N];
        float target[P];
        for (i = 0; i < P; ++i)
            for (j = 0; j < N; ++j) s.slope[i][j] = test_uniform(&state) - 0.5;
        for (j = 0; j < N; ++j) {
            s.dead[j] = test_uniform(&state) < 0.4;
            s.low[j] = low[j] = 0;
            s.range[j] = s.dead[j] ? extreme[(int)(7 * test_uniform(&state))] : log_uniform(&state, -20, 20);
        }
        for (j = 0; j < N; ++j) x[j] = s.range[j] * 0.6;
        lone_render(&s, x, target);
        for (i = 0; i < P; ++i) target[i] += (float)((round % 2) * 1e-3 * test_normal(&state)); /* or an exact match */
        r.parameter_count = N;
        r.image_size = P;
        r.user = &s;
        r.lower = low;
        r.upper = high;
        r.render = lone_render;
        r.jacobian = round % 4 < 2 ? lone_jacobian : NULL;
        for (part = 0; part < 2; ++part) { /* the odd ranges, then none */
            ms_pme_match_options options = ms_pme_match_defaults();
            for (j = 0; j < N; ++j) high[j] = s.dead[j] && part ? 0 : s.range[j];
            options.candidates = x;
            options.candidate_count = 1;
            options.initial_only = 1;
            options.deviation = deviation[part];
            CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL), MS_OK);
        }
        for (j = 0; j < N; ++j) {
            const double even = s.range[j] / sqrt(12.0);
            if (s.dead[j] && s.flushes && even < DBL_MIN) CHECK_NEAR(deviation[0][j], 0, 0);
            else if (s.dead[j]) CHECK_NEAR(deviation[0][j], even, 1e-9 * s.range[j] + 5e-324);
            else CHECK_NEAR(deviation[0][j], deviation[1][j], 1e-6 * deviation[1][j]); /* the same triangle, turned */
        }
    }
}

/* Far more parameters than residuals: after the first columns of the factorization only rounding of rounding is left. */
typedef struct wide {
    int n, m;
    double slope[8][256], aim[8];
} wide;
static ms_status wide_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const wide *w = (const wide *)user;
    int i, j;
    for (i = 0; i < w->m; ++i) {
        r[i] = -w->aim[i];
        for (j = 0; j < w->n; ++j) r[i] += w->slope[i][j] * x[j];
        for (j = 0; j < w->n && jacobian; ++j) jacobian[i * w->n + j] = w->slope[i][j];
    }
    return MS_OK;
}
static void test_wide(void)
{
    static wide w;
    uint64_t state = 17 + test_seed;
    int round, i, j;
    for (round = 0; round < 30; ++round) {
        ms_pme_function f;
        ms_pme_result result;
        double x[256] = {0}, begin = 0;
        w.m = 1 + round % 8;
        w.n = round < 8 ? 256 : w.m + 1 + (int)((255 - w.m) * test_uniform(&state));
        for (i = 0; i < w.m; ++i)
            for (j = 0; j < w.n; ++j) w.slope[i][j] = 2 * test_uniform(&state) - 1;
        for (i = 0; i < w.m; ++i) w.aim[i] = 1 + test_uniform(&state);
        for (i = 0; i < w.m; ++i) begin += w.aim[i] * w.aim[i];
        memset(&f, 0, sizeof f);
        f.user = &w;
        f.parameter_count = w.n;
        f.residual_count = (size_t)w.m;
        f.residuals = wide_residuals;
        CHECK_INT(ms_pme_minimize(&f, NULL, x, &result, NULL), MS_OK);
        CHECK_LE(result.value, 1e-9 * begin); /* a linear system with solutions; the tolerance is 1e-10 */
    }
}

/* What every call of a callback does when it fails: its status, and no output is touched. */
typedef struct fragile {
    renderer_state s;
    collapse c;
    int calls, fail_at;
} fragile;
static int fragile_fails(fragile *f) { return ++f->calls == f->fail_at; }
static ms_status fragile_render(void *user, const double *x, float *image)
{
    fragile *f = (fragile *)user;
    return fragile_fails(f) ? MS_CANCELLED : render(&f->s, x, image);
}
static ms_status fragile_jacobian(void *user, const double *x, float *image, float *jacobian)
{
    fragile *f = (fragile *)user;
    return fragile_fails(f) ? MS_CANCELLED : render_jacobian(&f->s, x, image, jacobian);
}
static ms_status fragile_predict(void *user, int i, const float *target, double *x)
{
    fragile *f = (fragile *)user;
    return fragile_fails(f) ? MS_CANCELLED : predict(&f->s, i, target, x);
}
static ms_status fragile_reduced(void *user, const double *x, double *r, double *jacobian)
{
    fragile *f = (fragile *)user;
    return fragile_fails(f) ? MS_CANCELLED : collapse_residuals(&f->c, x, r, jacobian);
}
static void test_every_failure(void)
{
    static fragile f;
    float target[P];
    int kind, call, j, calls = 0;
    uint64_t state = 4;
    renderer_make(&f.s);
    f.s.truth = truth;
    render(&f.s, truth, target);
    for (j = 0; j < P; ++j) target[j] += (float)(0.2 * test_normal(&state));
    collapse_make(&f.c, &f.s, target);
    for (kind = 0; kind < 3; ++kind) { /* Jacobian, differences, reduced */
        for (call = 1;; ++call) {
            ms_pme_renderer r = renderer_of(&f.s);
            ms_pme_function reduced;
            ms_pme_match_options options = ms_pme_match_defaults();
            ms_pme_match_result result;
            double x[N], deviation[N];
            float image[P];
            ms_error error;
            ms_status status;
            memset(&reduced, 0, sizeof reduced);
            reduced.user = &f;
            reduced.parameter_count = N;
            reduced.residual_count = H + 1;
            reduced.residuals = fragile_reduced;
            r.user = &f;
            r.render = fragile_render;
            r.jacobian = kind == 0 ? fragile_jacobian : NULL;
            r.predict = fragile_predict;
            r.prediction_count = 3;
            if (kind == 2) r.reduced = &reduced;
            options.deviation = deviation;
            options.refine.restarts = 2;
            options.random_count = 2;
            options.refine.max_cost = 40;
            memset(x, 7, sizeof x);
            memset(deviation, 7, sizeof deviation);
            memset(image, 7, sizeof image);
            memset(&result, 7, sizeof result);
            f.calls = 0;
            f.fail_at = call;
            status = ms_pme_match(&r, target, NULL, &options, x, image, &result, &error);
            if (status == MS_OK) break;
            CHECK_INT(status, MS_CANCELLED);
            CHECK_INT(error.status, MS_CANCELLED);
            for (j = 0; j < (int)sizeof x; ++j)
                CHECK(((char *)x)[j] == 7 && ((char *)deviation)[j] == 7 && image[j % P] > 0 && image[j % P] < 1e-30f);
            for (j = 0; j < (int)sizeof result; ++j) CHECK(((char *)&result)[j] == 7);
        }
        CHECK(call > 20);
        calls += call - 1;
    }
    TEST_NOTE("%d calls", calls);
}

/* What is said of the best candidate is its picture's RMSE, whatever the pulls add; and that nothing was refined. */
static void test_first_guess(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    float target[P];
    double x[N], source[N], pull[N], rmse;
    int j;
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    for (j = 0; j < N; ++j) {
        source[j] = 0.9 - 0.1 * j;
        pull[j] = 0.4;
        x[j] = truth[j] + 0.1;
    }
    options.candidates = x;
    options.candidate_count = 1;
    options.initial_only = 1;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    rmse = result.rmse;
    CHECK_NEAR(result.rmse_initial, rmse, 1e-6 * rmse);
    CHECK_INT(result.refine.stop, MS_PME_STOP_INITIAL);
    CHECK_INT(result.refine.steps, 0);
    options.source = source;
    options.pull = pull;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_NEAR(result.rmse_initial, rmse, 1e-6 * rmse);
    CHECK(result.refine.value > 2 * rmse * rmse);
    options.initial_only = 0;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_NEAR(result.rmse_initial, rmse, 1e-6 * rmse);
    CHECK(result.refine.steps > 0);
}

/* A linear renderer of n parameters without a Jacobian: the default budget finds them all; a budget too small for a
   step says so. */
static int linear_size;
static ms_status linear_render(void *user, const double *x, float *image)
{
    int i;
    (void)user;
    for (i = 0; i < linear_size; ++i) image[i] = (float)(x[i] + 0.1 * x[(i + 1) % linear_size]);
    return MS_OK;
}
static ms_status linear_function(void *user, const double *x, double *r, double *jacobian)
{
    int i;
    (void)user;
    (void)jacobian;
    for (i = 0; i < linear_size; ++i) r[i] = x[i] + 0.1 * x[(i + 1) % linear_size] - 0.3;
    return MS_OK;
}
static void test_default_budget(void)
{
    static const int sizes[] = {1, 3, 19, 40, 48, 49, 50, 100, 256};
    static float target[MS_PME_PARAMETERS_MAX];
    static double x[MS_PME_PARAMETERS_MAX];
    uint64_t state = 5 + test_seed;
    size_t k;
    int i;
    for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
        ms_pme_renderer r = ms_pme_renderer_defaults();
        ms_pme_match_options options = ms_pme_match_defaults();
        ms_pme_match_result result;
        ms_pme_function f;
        ms_pme_result found;
        linear_size = sizes[k];
        for (i = 0; i < linear_size; ++i) x[i] = test_uniform(&state);
        linear_render(NULL, x, target);
        r.parameter_count = linear_size;
        r.image_size = (size_t)linear_size;
        r.render = linear_render;
        CHECK_INT(ms_pme_match(&r, target, NULL, NULL, x, NULL, &result, NULL), MS_OK);
        CHECK_LE(result.rmse, 1e-3 * result.rmse_initial);
        CHECK(result.refine.steps > 1);
        CHECK_LE(result.refine.cost, fmax(50, 8 * (1.0 + linear_size)));
        options.refine.max_cost = linear_size; /* the derivatives and no trial */
        CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
        CHECK_INT(result.refine.steps, 0);
        CHECK_INT(result.refine.stop, MS_PME_STOP_COST);
        memset(&f, 0, sizeof f);
        f.parameter_count = linear_size;
        f.residual_count = (size_t)linear_size;
        f.residuals = linear_function;
        f.residuals_only = 1;
        for (i = 0; i < linear_size; ++i) x[i] = 0;
        CHECK_INT(ms_pme_minimize(&f, NULL, x, &found, NULL), MS_OK);
        CHECK_LE(found.value, 1e-6);
    }
}

/* Counts up to INT_MAX: no overflow, and the search goes on until a callback or the budget ends it. */
static int renders_left;
static ms_status counted_render(void *user, const double *x, float *image)
{
    return renders_left-- > 0 ? render(user, x, image) : MS_CANCELLED;
}
static void test_largest_counts(void)
{
    renderer_state s;
    ms_pme_renderer r;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    problem p;
    ms_pme_function f = function_of(&p, 60, 60, broyden_tridiagonal);
    ms_pme_options o = ms_pme_defaults();
    ms_pme_result found;
    float target[P];
    double x[60];
    int j;
    renderer_make(&s);
    r = renderer_of(&s);
    render(&s, truth, target);
    target[3] += 0.5f;
    r.render = counted_render;
    options.candidates = truth;
    options.candidate_count = 1;
    options.random_count = INT_MAX;
    options.refine.restarts = INT_MAX;
    renders_left = 1000;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_CANCELLED);
    CHECK_INT(renders_left, -1);
    renders_left = INT_MAX;
    options.random_count = 2;
    options.refine.max_cost = 1e4;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_OK);
    CHECK_INT(result.refine.stop, MS_PME_STOP_COST);
    o.restarts = INT_MAX;
    o.max_cost = 1e4;
    for (j = 0; j < 60; ++j) x[j] = -1;
    CHECK_INT(ms_pme_minimize(&f, &o, x, &found, NULL), MS_OK);
    r.predict = predict;
    r.prediction_count = INT_MAX;
    options.candidate_count = INT_MAX;
    CHECK_INT(ms_pme_match(&r, target, NULL, &options, x, NULL, &result, NULL), MS_INVALID_ARGUMENT);
}

/* A target of zeros that is reached: a parameter without effect is as uncertain as a uniform one, one with an effect is
   certain. */
static ms_status dim(void *user, const double *x, float *image)
{
    int i;
    for (i = 0; i < 8; ++i) image[i] = (float)(*(const double *)user * x[0] * (i + 1));
    return MS_OK;
}
static void test_black_target(void)
{
    static const double strength[] = {0, 1e-20, 0.1, 1e5};
    static const float black[8] = {0};
    static const double candidate[2] = {0, 0.5};
    size_t k;
    for (k = 0; k < 4; ++k) {
        ms_pme_renderer r = ms_pme_renderer_defaults();
        ms_pme_match_options options = ms_pme_match_defaults();
        double x[2], deviation[2], user = strength[k];
        r.user = &user;
        r.parameter_count = 2;
        r.image_size = 8;
        r.render = dim;
        options.candidates = candidate;
        options.candidate_count = 1;
        options.deviation = deviation;
        CHECK_INT(ms_pme_match(&r, black, NULL, &options, x, NULL, NULL, NULL), MS_OK);
        CHECK_NEAR(deviation[1], sqrt(1 / 12.0), 1e-6);
        if (k == 0) CHECK_NEAR(deviation[0], sqrt(1 / 12.0), 1e-6);
        else CHECK_NEAR(deviation[0], 1e-7 / sqrt(8.0), 1e-3 * 1e-7); /* noise: 1e-7 of what x_0 does, in 8 values */
    }
}

/* Random points fill a box whose range is beyond doubles. */
static double spread_low, spread_high;
static int spread_points[4];
static ms_status spread(void *user, const double *x, double *r, double *jacobian)
{
    (void)user;
    spread_low = fmin(spread_low, x[0]);
    spread_high = fmax(spread_high, x[0]);
    spread_points[(x[0] > 0) + 2 * (fabs(x[0]) > 0.85e308)]++;
    r[0] = sin(x[0]) + 2;
    if (jacobian) jacobian[0] = 0;
    return MS_OK;
}
static void test_huge_box(void)
{
    const double low = -1.7e308, high = 1.7e308;
    ms_pme_function f;
    ms_pme_options o = ms_pme_defaults();
    double x = 1;
    int k;
    memset(&f, 0, sizeof f);
    f.parameter_count = 1;
    f.residual_count = 1;
    f.residuals = spread;
    f.lower = &low;
    f.upper = &high;
    o.restarts = 400;
    o.max_cost = 1e5;
    CHECK_INT(ms_pme_minimize(&f, &o, &x, NULL, NULL), MS_OK);
    for (k = 0; k < 4; ++k) CHECK(spread_points[k] > 60); /* of 100: four standard deviations */
    CHECK(spread_low > low && spread_high < high);
}

static void every_call(void *context)
{
    renderer_state *s = (renderer_state *)context;
    ms_pme_renderer r = renderer_of(s);
    ms_pme_match_options options = ms_pme_match_defaults();
    static float target[P];
    static problem p;
    static double x[64], deviation[64];
    ms_pme_function f = function_of(&p, 60, 60, broyden_tridiagonal);
    render(s, truth, target);
    options.refine.restarts = 3;
    options.random_count = 3;
    options.deviation = deviation;
    ms_pme_match(&r, target, NULL, &options, x, NULL, NULL, NULL);
    {
        ms_pme_options o = ms_pme_defaults();
        o.max_cost = 300;
        ms_pme_minimize(&f, &o, x, NULL, NULL);
    }
}

static void test_stack_use(void)
{
    renderer_state s;
    size_t used;
    if (TEST_STACK_LIMIT == 0) SKIP("a sanitizer pads the stack");
    renderer_make(&s);
    used = test_stack(every_call, &s);
    CHECK_LE((double)used, TEST_STACK_LIMIT);
    TEST_NOTE("%d bytes, of %d", (int)used, TEST_STACK_LIMIT);
}

static const test_case cases[] = {{"published minima", test_published},
                                  {"reference", test_reference},
                                  {"certified values of NIST", test_nist},
                                  {"misbehaving functions", test_misbehavior},
                                  {"failing callback", test_failing_callback},
                                  {"budgets", test_budgets},
                                  {"starts and bounds", test_starts},
                                  {"arguments", test_arguments},
                                  {"match", test_match},
                                  {"match, restarts", test_restarts},
                                  {"restarts are finished", test_finished_restarts},
                                  {"from the ends of ranges", test_from_the_ends},
                                  {"a weak parameter", test_weak_parameter},
                                  {"match, short budget", test_short_budget},
                                  {"match, starts in turn", test_turns},
                                  {"a parameter without effect", test_no_effect},
                                  {"match, budget", test_match_budget},
                                  {"match, arguments", test_match_arguments},
                                  {"reduced objective", test_reduced},
                                  {"deviations", test_deviations},
                                  {"random candidates", test_random_candidates},
                                  {"repeatable", test_repeatable},
                                  {"allocation failures", test_allocation},
                                  {"value of a result", test_result_value},
                                  {"sizes of residuals", test_sizes},
                                  {"many bounds", test_many_bounds},
                                  {"active set", test_active_set},
                                  {"units of parameters", test_units},
                                  {"differences", test_differences},
                                  {"traps", test_traps},
                                  {"messages of options", test_option_messages},
                                  {"control", test_control},
                                  {"defaults and limits", test_defaults},
                                  {"the reason of a stop", test_stop},
                                  {"any units", test_any_units},
                                  {"any ranges", test_any_ranges},
                                  {"ranges of denormals", test_lone_ranges},
                                  {"more parameters than residuals", test_wide},
                                  {"every failure", test_every_failure},
                                  {"the first guess", test_first_guess},
                                  {"default budget", test_default_budget},
                                  {"largest counts", test_largest_counts},
                                  {"black target", test_black_target},
                                  {"a box beyond doubles", test_huge_box},
                                  {"stack", test_stack_use}};
TEST_MAIN(cases)
