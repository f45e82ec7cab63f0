/* Tests of ms_gpr.h: recommendations, galleries, latent space; and of what tools make of it: space.h, plane.h. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "test.h"
#include "json.h"
#include "space.h"
#include "users.h"
#include "gpr_inside.h"
#include "plane.h"
#include "warnings.h"

/* --- help --- */

static double largest(const double *x, int n)
{
    double v = 0;
    int i;
    for (i = 0; i < n; ++i) v = fabs(x[i]) > v ? fabs(x[i]) : v;
    return v;
}

static double largest_difference(const double *a, const double *b, int n)
{
    double v = 0;
    int i;
    for (i = 0; i < n; ++i) v = !(fabs(a[i] - b[i]) <= v) ? fabs(a[i] - b[i]) : v;
    return v;
}

/* Numbers of a JSON array of numbers or of arrays of numbers; caller frees. */
static double *numbers(const json *object, const char *key, int *count)
{
    const json *a = json_get(object, key);
    double *out;
    int i, k, n = 0;
    for (i = 0; i < a->count; ++i) n += a->child[i].kind == 'a' ? a->child[i].count : 1;
    out = (double *)malloc(((size_t)n + 1) * sizeof *out);
    if (count) *count = n;
    for (i = 0, n = 0; i < a->count; ++i) {
        if (a->child[i].kind != 'a') out[n++] = a->child[i].number;
        else
            for (k = 0; k < a->child[i].count; ++k) out[n++] = a->child[i].child[k].number;
    }
    return out;
}

/* Kolmogorov-Smirnov distance of two samples; sorts both. */
static double two_sample(double *a, int n, double *b, int m)
{
    double worst = 0;
    int i = 0, j = 0;
    qsort(a, (size_t)n, sizeof *a, user__compare);
    qsort(b, (size_t)m, sizeof *b, user__compare);
    while (i < n && j < m) {
        double d;
        if (a[i] <= b[j]) ++i;
        else ++j;
        d = fabs((double)i / n - (double)j / m);
        if (d > worst) worst = d;
    }
    return worst;
}

/* The score of a KS distance of samples of n and m that chance exceeds with probability 1e-4 (Smirnov's limit). */
static double two_sample_limit(int n, int m) { return sqrt(-0.5 * log(0.5e-4)) * sqrt((n + m) / ((double)n * m)); }

/* A user's 250 scores and a model of them: lengths from the user's own terms stand in for a fit. */
typedef struct taste {
    person u;
    int n, m;
    double *x, *y;
    double theta[USER_DIMENSIONS_MAX + 2];
    ms_gpr *gp;
} taste;

static taste taste_make(uint64_t seed, int n, int m, double liking, const ms_gpr_options *options)
{
    taste t;
    uint64_t state = seed + 1000 * test_seed;
    int c, k;
    memset(&t, 0, sizeof t);
    t.u = user_make(seed + 1000 * test_seed, m, liking);
    t.n = n;
    t.m = m;
    t.x = (double *)malloc((size_t)n * (size_t)m * sizeof(double));
    t.y = (double *)malloc((size_t)n * sizeof(double));
    user_gallery(&t.u, n, t.x, t.y, &state);
    for (k = 0; k < m; ++k) t.theta[k] = log(30.0);
    for (c = 0; c < t.u.classes; ++c)
        for (k = 0; k < t.u.liked[c].gates + t.u.liked[c].tastes; ++k)
            t.theta[t.u.liked[c].dimension[k]] = k < t.u.liked[c].gates ? log(0.4) : log(0.8);
    t.theta[m] = log(3.0);
    t.theta[m + 1] = log(0.7);
    CHECK_INT(inside_create(t.x, t.y, n, m, t.theta, 0, options, &t.gp, NULL), MS_OK);
    return t;
}

static void taste_free(taste *t)
{
    ms_gpr_destroy(t->gp);
    free(t->x);
    free(t->y);
}

/* Uniform materials of a space whose means reach a threshold, x [count][m]: the reference for chains. low, high: [m] */
static int rejection(const ms_gpr *gp, const ms_gpr_space *space, double threshold, int count, int most, uint64_t seed,
                     double *x)
{
    enum { BATCH = 512 };
    const int m = ms_gpr_view_of(gp).m;
    double *batch = (double *)malloc(BATCH * (size_t)m * sizeof *batch), mean[BATCH];
    uint64_t state = seed;
    int found = 0, tried, i, k;
    for (tried = 0; found < count && tried < most; tried += BATCH) {
        for (i = 0; i < BATCH; ++i) {
            double *row = batch + i * m;
            for (k = 0; k < m; ++k)
                row[k] = space ? space->low[k] + (space->high[k] - space->low[k]) * test_uniform(&state)
                               : test_uniform(&state);
            if (space && space->snap) space->snap(space->user, row);
        }
        ms_gpr_predict(gp, batch, BATCH, mean, NULL, NULL);
        for (i = 0; i < BATCH && found < count; ++i)
            if (mean[i] >= threshold) memcpy(x + (size_t)found++ * (size_t)m, batch + i * m, (size_t)m * sizeof *x);
    }
    free(batch);
    return found;
}

/* Mean root-mean-square distance of materials x [count][m] to the nearest other one. */
static double spread_of(const double *x, int count, int m)
{
    double sum = 0;
    int i, j, k;
    for (i = 0; i < count; ++i) {
        double nearest = 1e300;
        for (j = 0; j < count; ++j) {
            double d2 = 0;
            for (k = 0; k < m; ++k) d2 += (x[i * m + k] - x[j * m + k]) * (x[i * m + k] - x[j * m + k]) / m;
            if (j != i) nearest = fmin(nearest, d2);
        }
        sum += sqrt(nearest) / count;
    }
    return sum;
}

static ms_gpr_recommend_options recommend_options(void)
{
    ms_gpr_recommend_options o;
    memset(&o, 0, sizeof o);
    o.seed = test_seed;
    return o;
}

/* --- recommendation --- */

/* One score of 1 at the center: u = exp(-d^2 / 2) up to a factor, and {u >= tau best} is a ball of radius
   r = l sqrt(-2 log tau). The m-th power of distance / r is uniform on [0, 1] for uniform points. */
static void test_ball(void)
{
    enum { M = 3, N = 2000 };
    double x[M] = {0.5, 0.5, 0.5}, y = 1, theta[M + 2], *r, *p, *even;
    double radius = 0.1 * sqrt(-2 * log(0.5));
    ms_gpr *gp;
    int i, k;
    for (k = 0; k < M; ++k) theta[k] = log(0.1);
    theta[M] = 0;
    theta[M + 1] = log(1e-3);
    r = (double *)malloc(N * M * sizeof *r);
    p = (double *)malloc(N * sizeof *p);
    even = (double *)malloc(N * sizeof *even);
    CHECK_INT(inside_create(x, &y, 1, M, theta, 0, NULL, &gp, NULL), MS_OK);
    {
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        double d, middle[M] = {0, 0, 0};
        o.tau = 0.5;
        o.search = MS_GPR_SEARCH_THRESHOLD;
        CHECK_INT(ms_gpr_recommend(gp, &o, N, r, NULL, NULL, &report, NULL), MS_OK);
        CHECK_INT(report.found, N);
        CHECK_INT(report.search, MS_GPR_SEARCH_THRESHOLD);
        /* best is the score itself less the noise's 1e-6 */
        CHECK_NEAR(report.best, 1, 2e-6);
        CHECK_NEAR(report.threshold, 0.5, 1e-6);
        for (i = 0; i < N; ++i) {
            double d2 = 0;
            for (k = 0; k < M; ++k) {
                d2 += (r[i * M + k] - 0.5) * (r[i * M + k] - 0.5);
                middle[k] += r[i * M + k] / (int)N;
            }
            p[i] = pow(sqrt(d2) / radius, M);
            even[i] = (i + 0.5) / (int)N;
        }
        CHECK_LE(largest(p, N), 1);
        d = two_sample(p, N, even, N);
        TEST_NOTE("KS %.3f", d);
        CHECK_LE(d, sqrt(-0.5 * log(0.5e-4)) / sqrt((double)N)); /* one sample against a distribution: chance 1e-4 */
        for (k = 0; k < M; ++k)
            CHECK_NEAR(middle[k], 0.5, 4.5 * radius / sqrt(5.0 * (int)N)); /* variance r^2 / 5 in 3D; 4.5 sigma */
        { /* volume of the ball; 4.5 binomial sigma of 4096 candidates */
            double volume = 4.0 / 3 * 3.141592653589793 * radius * radius * radius;
            CHECK_NEAR(report.acceptance, volume, 4.5 * sqrt(volume / 4096));
        }
    }
    ms_gpr_destroy(gp);
    free(r);
    free(p);
    free(even);
}

/* On scarce users chains give what rejection gives: same scores, same coordinates. */
static void test_walk_like_rejection(void)
{
    enum { N = 400 };
    int seed, i, k, compared = 0;
    TEST_METHOD;
    for (seed = 1; compared < (test_full ? 6 : 2); ++seed) {
        taste t = taste_make((uint64_t)seed, 250, 19, 0.10, NULL);
        double *walk = (double *)malloc(N * 19 * sizeof *walk), *reject = (double *)malloc(N * 19 * sizeof *reject);
        double mean_walk[N], mean_reject[N], a[N], b[N], worst = 0, d;
        int repeated = 0, j;
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        o.tau = 0.5;
        o.search = MS_GPR_SEARCH_THRESHOLD;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, N, walk, mean_walk, NULL, &report, NULL), MS_OK);
        CHECK_INT(rejection(t.gp, NULL, report.threshold, N, 1000000, (uint64_t)seed, reject), N);
        ms_gpr_predict(t.gp, reject, N, mean_reject, NULL, NULL);
        for (i = 0; i < N; ++i) {
            CHECK(mean_walk[i] >= report.threshold);
            CHECK(mean_reject[i] >= report.threshold);
        }
        /* chains that start from one seed move along every parameter, also those that the mean hardly depends on: no
           value is found twice, but where all transitions of a chain were refused (one in a hundred is allowed to be)
         */
        for (k = 0; k < 19; ++k)
            for (i = 0; i < N; ++i) {
                for (j = 0; j < i && fabs(walk[i * 19 + k] - walk[j * 19 + k]) > 0; ++j) {}
                repeated += j < i;
            }
        CHECK_LE(repeated, 19 * N / 100);
        if (t.u.classes == 1 && ++compared) { /* the walk does not promise the shares of separate classes */
            for (k = 0; k < 19; ++k) {
                for (i = 0; i < N; ++i) {
                    a[i] = walk[i * 19 + k];
                    b[i] = reject[i * 19 + k];
                }
                d = two_sample(a, N, b, N);
                if (d > worst) worst = d;
            }
            CHECK_LE(worst, two_sample_limit(N, N));
            d = two_sample(mean_walk, N, mean_reject, N);
            CHECK_LE(d, two_sample_limit(N, N));
            TEST_NOTE("coordinates KS %.3f, scores %.3f", worst, d);
        }
        free(walk);
        free(reject);
        taste_free(&t);
    }
}

/* Every search at every level reaches what it promises, and the report says what was done. */
static void test_searches(void)
{
    int level, search, i;
    double top;
    for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
        ms_gpr_options options;
        taste t;
        memset(&options, 0, sizeof options);
        options.simd = (ms_simd)level;
        t = taste_make(3, 200, 19, 0.10, &options);
        if ((int)ms_gpr_view_of(t.gp).level != level) { /* a level that this machine or build lacks: seen already */
            taste_free(&t);
            continue;
        }
        TEST_NOTE("%s", ms_simd_string(ms_gpr_view_of(t.gp).level));
        for (i = 0, top = 0; i < t.n; ++i) top = fmax(top, t.y[i]);
        for (search = MS_GPR_SEARCH_AUTO; search <= MS_GPR_SEARCH_VARIANTS; ++search) {
            double x[100 * 19], mean[100], sigma[100], again[100], variance[100];
            ms_gpr_recommend_options o = recommend_options();
            ms_gpr_recommend_report report;
            o.search = (ms_gpr_search)search;
            CHECK_INT(ms_gpr_recommend(t.gp, &o, 100, x, mean, sigma, &report, NULL), MS_OK);
            CHECK_INT(report.found, 100);
            CHECK(report.search != MS_GPR_SEARCH_AUTO);
            if (report.search == MS_GPR_SEARCH_THRESHOLD)
                CHECK_NEAR(report.threshold, 0.6 * fmin(report.best, top), 1e-12 * top);
            if (search) CHECK_INT(report.search, search);
            CHECK(report.liked > 0 && report.liked < 200);
            CHECK(report.acceptance >= 0 && report.acceptance < 0.3);
            CHECK(spread_of(x, 100, 19) > 0.05);
            ms_gpr_predict(t.gp, x, 100, again, variance, NULL);
            for (i = 0; i < 100; ++i) {
                CHECK(mean[i] >= report.threshold);
                CHECK(mean[i] == again[i] && sigma[i] == sqrt(variance[i]));
            }
            for (i = 0; i < 1900; ++i) CHECK(x[i] >= 0 && x[i] <= 1);
        }
        taste_free(&t);
    }
}

/* The largest mean is one: nothing in a large random sample, nor any training point, is above it. */
static void test_best(void)
{
    int seed, i;
    for (seed = 1; seed <= 4; ++seed) {
        taste t = taste_make((uint64_t)seed, 150, 8, 0.1, NULL);
        enum { N = 50000 };
        double *x = (double *)malloc(N * 8 * sizeof *x), *mean = (double *)malloc(N * sizeof *mean), r[8], top = -1e300;
        uint64_t state = 77 + test_seed;
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        for (i = 0; i < N * 8; ++i) x[i] = test_uniform(&state);
        ms_gpr_predict(t.gp, x, N, mean, NULL, NULL);
        for (i = 0; i < N; ++i) top = mean[i] > top ? mean[i] : top;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 1, r, NULL, NULL, &report, NULL), MS_OK);
        TEST_NOTE("best %.3f, of 50000 %.3f", report.best, top);
        CHECK(report.best >= top);
        free(x);
        free(mean);
        taste_free(&t);
    }
}

/* More tau: higher scores, less spread. */
static void test_controls(void)
{
    taste t = taste_make(5, 250, 19, 0.15, NULL);
    double x[150 * 19], mean[150], before = 0, spread = 1;
    int step, i;
    for (step = 0; step < 3; ++step) {
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        double sum = 0;
        o.search = MS_GPR_SEARCH_THRESHOLD;
        o.tau = 0.4 + 0.25 * step;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 150, x, mean, NULL, &report, NULL), MS_OK);
        for (i = 0; i < 150; ++i) sum += mean[i] / 150;
        CHECK(sum > before);
        CHECK(spread_of(x, 150, 19) < spread);
        before = sum;
        spread = spread_of(x, 150, 19);
    }
    taste_free(&t);
}

/* A box of its own: fixed parameters stay fixed to the bit; dropped dimensions are drawn uniformly. */
static void test_box(void)
{
    enum { N = 300 };
    taste t = taste_make(2, 200, 10, 0.2, NULL);
    double low[10], high[10], x[N * 10], even[N], a[N];
    int search, i, k, kept = 10;
    ms_error error;
    CHECK_INT(inside_simplify(t.gp, 0.2, &kept), MS_OK);
    CHECK(kept < 10);
    for (k = 0; k < 10; ++k) {
        low[k] = 0.1;
        high[k] = 0.9;
    }
    low[4] = high[4] = 1.0 / 3;
    for (search = MS_GPR_SEARCH_THRESHOLD; search <= MS_GPR_SEARCH_VARIANTS; ++search) {
        ms_gpr_recommend_options o = recommend_options();
        o.search = (ms_gpr_search)search;
        o.space.low = low;
        o.space.high = high;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, N, x, NULL, NULL, NULL, NULL), MS_OK);
        for (i = 0; i < N; ++i)
            for (k = 0; k < 10; ++k) {
                CHECK(x[i * 10 + k] >= low[k] && x[i * 10 + k] <= high[k]);
                if (k == 4) CHECK(x[i * 10 + k] == low[4]);
            }
        for (k = 0; k < 10; ++k) {
            if (ms_gpr_view_of(t.gp).theta[k] < 700 || k == 4 || search == MS_GPR_SEARCH_VARIANTS) continue;
            for (i = 0; i < N; ++i) {
                a[i] = x[i * 10 + k];
                even[i] = 0.1 + 0.8 * (i + 0.5) / (int)N;
            }
            CHECK_LE(two_sample(a, N, even, N), sqrt(-0.5 * log(0.5e-5) / (int)N)); /* chance 1e-5 a dimension */
        }
    }
    {
        ms_gpr_recommend_options o = recommend_options();
        o.space.low = low;
        o.space.high = high;
        low[7] = 2;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, "dimension 7") != NULL);
        low[7] = (double)NAN;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    }
    taste_free(&t);
}

/* Bits do not depend on threads. */
static void test_threads(void)
{
    static double reference[2][200 * 19], x[200 * 19];
    int threads[] = {1, 2, 7}, i, search;
    for (i = 0; i < 3; ++i) {
        test_pool pool;
        ms_gpr_options options;
        taste t;
        memset(&options, 0, sizeof options);
        options.parallel = test_parallel(&pool, threads[i]);
        t = taste_make(4, 120, 19, 0.15, &options);
        for (search = MS_GPR_SEARCH_THRESHOLD; search <= MS_GPR_SEARCH_VARIANTS; ++search) {
            ms_gpr_recommend_options o = recommend_options();
            o.search = (ms_gpr_search)search;
            CHECK_INT(ms_gpr_recommend(t.gp, &o, 200, i ? x : reference[search - 1], NULL, NULL, NULL, NULL), MS_OK);
            if (i) CHECK(memcmp(x, reference[search - 1], sizeof x) == 0);
        }
        for (search = 0; search < 2; ++search) {
            static double gallery[2][40 * 19];
            ms_gpr_gallery_options g;
            memset(&g, 0, sizeof g);
            g.seed = (uint64_t)search;
            CHECK_INT(ms_gpr_gallery(t.gp, &g, 40, i ? x : gallery[search], NULL), MS_OK);
            if (i) CHECK(memcmp(x, gallery[search], sizeof gallery[search]) == 0);
        }
        taste_free(&t);
    }
}

/* Without a box: the range of the materials, [0, 1] where they lie there, the value of what is locked; with space_round
   the units that columns come in and whole ranges where those are round. */
static void test_natural_box(void)
{
    enum { N = 60, M = 9, COUNT = 200, EVEN = 500 };
    static const double low[M] = {0, -1, 0, 0, -5, 1, 42, 0, -180},
                        high[M] = {1, 1, 100, 255, 5, 2, 42, 360, 180}; /* drawn from */
    static double even[EVEN * M];
    double x[N * M], y[N], r[COUNT * M], least, most;
    space_wish none;
    space_kept kept;
    ms_gpr_gallery_options g;
    ms_gpr_recommend_options o = recommend_options();
    uint64_t state = 13;
    ms_gpr *gp;
    int i, k;
    for (i = 0; i < N; ++i) {
        for (k = 0; k < M; ++k) x[i * M + k] = low[k] + (high[k] - low[k]) * test_uniform(&state);
        y[i] = 10 * (x[i * M + 2] / 100 + x[i * M + 4] / 10);
    }
    CHECK_INT(ms_gpr_fit(x, y, N, M, NULL, &gp, NULL, NULL), MS_OK);
    o.search = MS_GPR_SEARCH_THRESHOLD;
    memset(&g, 0, sizeof g);
    CHECK_INT(ms_gpr_gallery(gp, &g, EVEN, even, NULL), MS_OK);
    for (k = 0; k < M; ++k) {
        double drawn[2] = {1e300, -1e300}, shown[2] = {1e300, -1e300};
        for (i = 0; i < N; ++i) drawn[0] = fmin(drawn[0], x[i * M + k]), drawn[1] = fmax(drawn[1], x[i * M + k]);
        for (i = 0; i < EVEN; ++i)
            shown[0] = fmin(shown[0], even[i * M + k]), shown[1] = fmax(shown[1], even[i * M + k]);
        if (k == 0) drawn[0] = 0, drawn[1] = 1;
        CHECK(shown[0] >= drawn[0] && shown[1] <= drawn[1]);
        if (k == 2 || k == 4) continue;                            /* what is liked is looked at most */
        CHECK_NEAR(shown[0], drawn[0], 0.03 * (high[k] - low[k])); /* of 500: half of them uniform, chance e^-7 */
        CHECK_NEAR(shown[1], drawn[1], 0.03 * (high[k] - low[k]));
    }
    memset(&none, 0, sizeof none);
    CHECK(space_make(&kept, &none, M) == NULL);
    space_round(&kept, x, N);
    o.space = g.space = space_of(&kept);
    CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, r, NULL, NULL, NULL, NULL), MS_OK);
    for (k = 0; k < M; ++k) {
        for (i = 0, least = 1e300, most = -1e300; i < COUNT; ++i) {
            least = fmin(least, r[i * M + k]);
            most = fmax(most, r[i * M + k]);
        }
        CHECK(least >= low[k] && most <= high[k]);
        if (k != 2 && k != 4)
            CHECK_NEAR(most - least, high[k] - low[k],
                       0.1 * (high[k] - low[k])); /* of 200: 5% at each end, chance e^-10 */
        CHECK(most >= high[k] - 0.1 * (high[k] - low[k]));
    }
    CHECK_INT(ms_gpr_gallery(gp, &g, EVEN, even, NULL), MS_OK);
    for (k = 0; k < M; ++k) {
        for (i = 0, least = 1e300, most = -1e300; i < EVEN; ++i) {
            least = fmin(least, even[i * M + k]);
            most = fmax(most, even[i * M + k]);
        }
        if (k == 2 || k == 4) continue;                       /* what is liked is looked at most */
        CHECK_NEAR(least, low[k], 0.03 * (high[k] - low[k])); /* of 500: half of them uniform, chance e^-7 */
        CHECK_NEAR(most, high[k], 0.03 * (high[k] - low[k]));
    }
    space_free(&kept);
    ms_gpr_destroy(gp);
    for (i = 7; i < 9; ++i) {
        int moves = 0;
        for (k = 0; k < i; ++k) x[2 * k] = 0.5, x[2 * k + 1] = 0.1 * k;
        CHECK_INT(ms_gpr_fit(x, y, i, 2, NULL, &gp, NULL, NULL), MS_OK);
        memset(&g, 0, sizeof g);
        CHECK_INT(ms_gpr_gallery(gp, &g, COUNT, r, NULL), MS_OK);
        for (k = 0; k < COUNT; ++k) moves |= fabs(r[2 * k] - 0.5) > 0;
        CHECK_INT(moves, i < 8); /* equal in 8 rows: locked */
        ms_gpr_destroy(gp);
    }
}

/* Steps, things to keep away from, and more of the same sequence, by both searches. */
static void test_wishes(void)
{
    enum { M = 8, COUNT = 60 };
    taste t = taste_make(5, 150, M, 0.15, NULL);
    static const double zero[M] = {0}, one[M] = {1, 1, 1, 1, 1, 1, 1, 1};
    double x[COUNT * M], more[COUNT * M], steps[M] = {0.25, 0, 0.1, 0, 0, 1, 0, 0.5}, avoid[2 * M];
    ms_gpr_recommend_report report;
    ms_error error;
    space_wish wish;
    space_kept kept;
    int search, i, k, j;
    memset(&wish, 0, sizeof wish);
    wish.low = zero, wish.high = one, wish.steps = steps;
    CHECK(space_make(&kept, &wish, M) == NULL);
    for (search = MS_GPR_SEARCH_THRESHOLD; search <= MS_GPR_SEARCH_VARIANTS; ++search) {
        ms_gpr_recommend_options o = recommend_options();
        int seen[11] = {0};
        o.search = (ms_gpr_search)search;
        o.space = space_of(&kept);
        CHECK_INT(ms_gpr_recommend(t.gp, &o, COUNT, x, NULL, NULL, &report, &error), MS_OK);
        for (i = 0; i < COUNT; ++i) {
            for (k = 0; k < M; ++k) {
                double cell = steps[k] > 0 ? x[i * M + k] / steps[k] : 0;
                CHECK_NEAR(cell, floor(cell + 0.5), 1e-12);
                CHECK(x[i * M + k] >= 0 && x[i * M + k] <= 1);
            }
            ++seen[(int)(10 * x[i * M + 2] + 0.5)];
        }
        for (i = 0, k = 0; i < 11; ++i) k += seen[i] > 0;
        CHECK(k > 2);            /* several of its eleven values */
        o = recommend_options(); /* few are the beginning of many */
        o.search = (ms_gpr_search)search;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, COUNT, x, NULL, NULL, NULL, NULL), MS_OK);
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 20, more, NULL, NULL, &report, NULL), MS_OK);
        CHECK_INT(report.found, 20);
        CHECK(memcmp(more, x, 20 * M * sizeof *x) == 0);
        o.avoid = memcpy(avoid, x, sizeof avoid) ? avoid : NULL;
        o.avoid_count = 2;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, COUNT, x, NULL, NULL, NULL, NULL), MS_OK);
        for (i = 0; i < COUNT; ++i)
            for (j = 0; j < 2; ++j) {
                double d2 = 0;
                for (k = 0; k < M; ++k)
                    d2 += (x[i * M + k] - avoid[j * M + k]) * (x[i * M + k] - avoid[j * M + k]) / (int)M;
                CHECK(sqrt(d2) >= 0.15);
            }
    }
    space_free(&kept);
    {
        ms_gpr_recommend_options o = recommend_options();
        steps[2] = -1;
        CHECK(strstr(space_make(&kept, &wish, M), "has a step that is not") != NULL);
        o = recommend_options();
        o.avoid_count = 1;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
        o.avoid_count = 0;
        o.tau = 1.1;
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, "tau is 1.1") != NULL);
    }
    taste_free(&t);
}

/* Parameters that come in steps, equal ones of which one is constant in the scores, rows of a list: chains give what
   rejection gives, every material keeps what it should, and the box may lie far from 0. */
static void test_snap(void)
{
    enum { M = 6, N = 90, COUNT = 400, FEW = 10 };
    static double x[COUNT * M], ref[COUNT * M], data[N * M], y[N], a[COUNT], b[COUNT];
    static const double few[FEW] = {0.05, 0.11, 0.23, 0.31, 0.42, 0.5, 0.61, 0.77, 0.83, 0.97};
    static const int equal[2] = {1, 2}, column[1] = {3};
    double low[M], high[M], steps[M], offset;
    int round, i, k;
    for (round = 0; round < 8; ++round) {
        uint64_t state = test_seed + (uint64_t)round;
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        space_wish wish;
        space_kept kept;
        ms_gpr_space s;
        space_list list;
        ms_gpr *gp;
        double rows[FEW];
        offset = round % 4 == 3 ? 1e7 : 0;
        for (k = 0; k < M; ++k) low[k] = offset, high[k] = offset + 1, steps[k] = k == 0 ? 0.125 : 0;
        for (i = 0; i < N; ++i) {
            for (k = 0; k < M; ++k) data[i * M + k] = offset + test_uniform(&state);
            if (round % 2) data[i * M + 2] = offset + 0.5; /* constant: the model drops it */
            y[i] = 0;
            for (k = 0; k < 4; ++k) y[i] += (data[i * M + k] - offset - 0.6) * (data[i * M + k] - offset - 0.6);
            y[i] = fmax(10 - 20 * y[i], 0);
        }
        for (i = 0; i < FEW; ++i) rows[i] = offset + few[i];
        memset(&wish, 0, sizeof wish);
        memset(&list, 0, sizeof list);
        wish.low = low, wish.high = high, wish.steps = steps;
        wish.equal = equal, wish.equal_count = 1;
        list.columns = column, list.rows = rows, list.width = 1, list.count = FEW;
        wish.lists = &list, wish.list_count = 1;
        CHECK(space_make(&kept, &wish, M) == NULL);
        s = space_of(&kept);
        CHECK_INT(ms_gpr_fit(data, y, N, M, NULL, &gp, NULL, NULL), MS_OK);
        o.space = s;
        o.tau = round < 4 ? 0.5 : 0.8;
        o.search = MS_GPR_SEARCH_THRESHOLD;
        CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, x, NULL, NULL, &report, NULL), MS_OK);
        for (i = 0; i < COUNT; ++i) {
            const double *row = x + i * M;
            int in_list = 0;
            CHECK(memcmp(&row[1], &row[2], sizeof *row) == 0);
            CHECK_NEAR((row[0] - offset) * 8, floor((row[0] - offset) * 8 + 0.5), 1e-12 + 1e-8 * (offset > 0));
            for (k = 0; k < FEW; ++k) in_list |= memcmp(&row[3], &rows[k], sizeof *row) == 0;
            CHECK(in_list);
            for (k = 0; k < M; ++k) CHECK(row[k] >= low[k] && row[k] <= high[k]);
            for (k = 0; k < i; ++k) CHECK(memcmp(row, x + k * M, M * sizeof *row) != 0); /* all different */
        }
        if (rejection(gp, &s, report.threshold, COUNT, 2000000, (uint64_t)round, ref) == COUNT)
            for (k = 0; k < M; ++k) {
                for (i = 0; i < COUNT; ++i) { /* ties broken alike */
                    a[i] = x[i * M + k] + 1e-6 * i / (int)COUNT;
                    b[i] = ref[i * M + k] + 1e-6 * i / (int)COUNT;
                }
                CHECK_LE(two_sample(a, COUNT, b, COUNT), two_sample_limit(COUNT, COUNT));
            }
        ms_gpr_destroy(gp);
        space_free(&kept);
    }
}

/* A space of ten materials: galleries show different ones, recommendations are different, and say when there are no
   more; what keeps away from everything says so. */
static void test_few_materials(void)
{
    enum { M = 3, FEW = 10, N = 40 };
    static double rows[FEW * M], x[100 * M], data[N * M], y[N];
    static const int columns[M] = {0, 1, 2};
    uint64_t state = test_seed;
    ms_gpr_recommend_options o = recommend_options();
    ms_gpr_recommend_report report;
    ms_gpr_gallery_options g;
    space_wish wish;
    space_kept kept;
    space_list list;
    ms_error error;
    ms_gpr *gp;
    int kind, i, j;
    for (i = 0; i < FEW * M; ++i) rows[i] = test_uniform(&state);
    for (i = 0; i < N * M; ++i) data[i] = test_uniform(&state);
    for (i = 0; i < N; ++i) y[i] = fmax(10 * data[i * M] - 2, 0);
    memset(&wish, 0, sizeof wish);
    memset(&list, 0, sizeof list);
    memset(&g, 0, sizeof g);
    list.columns = columns, list.rows = rows, list.width = M, list.count = FEW;
    wish.lists = &list, wish.list_count = 1;
    CHECK(space_make(&kept, &wish, M) == NULL);
    o.space = g.space = space_of(&kept);
    CHECK_INT(ms_gpr_fit(data, y, N, M, NULL, &gp, NULL, NULL), MS_OK);
    for (kind = 0; kind < 2; ++kind) {
        g.seed = (uint64_t)kind;
        CHECK_INT(ms_gpr_gallery(gp, &g, 6, x, NULL), MS_OK);
        for (i = 0; i < 6; ++i)
            for (j = 0; j < i; ++j) CHECK(memcmp(x + i * M, x + j * M, M * sizeof *x) != 0);
    }
    for (kind = 0; kind < 3; ++kind) {
        o.search = (ms_gpr_search)kind;
        o.tau = 0.3;
        CHECK_INT(ms_gpr_recommend(gp, &o, 100, x, NULL, NULL, &report, &error), MS_NOT_CONVERGED);
        CHECK(strstr(error.message, "no other materials") != NULL);
        CHECK(report.found > 0 && report.found <= FEW);
        if (report.search == MS_GPR_SEARCH_VARIANTS) CHECK_INT(report.found, FEW); /* the worst of them too */
        CHECK_INT(strstr(error.message, "reach the threshold") != NULL, report.search == MS_GPR_SEARCH_THRESHOLD);
        for (i = 0; i < report.found; ++i)
            for (j = 0; j < i; ++j) CHECK(memcmp(x + i * M, x + j * M, M * sizeof *x) != 0);
    }
    o = recommend_options();
    o.space = g.space;
    o.avoid = rows;
    o.avoid_count = FEW; /* all there are */
    CHECK_INT(ms_gpr_recommend(gp, &o, 10, x, NULL, NULL, &report, &error), MS_NOT_CONVERGED);
    CHECK(strstr(error.message, "to avoid") != NULL);
    CHECK_INT(report.found, 0);
    ms_gpr_destroy(gp);
    space_free(&kept);
}

/* Four times as many recommendations take four times as long, not sixteen: 20,000, all different. */
static void test_many_materials(void)
{
    enum { M = 2, N = 12, COUNT = 20000 };
    double *x = (double *)malloc(COUNT * M * sizeof *x), data[N * M], y[N], seconds[2];
    uint64_t state = test_seed;
    ms_gpr_recommend_options o = recommend_options();
    ms_gpr *gp;
    int i;
    for (i = 0; i < N * M; ++i) data[i] = test_uniform(&state);
    for (i = 0; i < N; ++i) y[i] = i;
    o.search = MS_GPR_SEARCH_VARIANTS;
    CHECK_INT(ms_gpr_fit(data, y, N, M, NULL, &gp, NULL, NULL), MS_OK);
    for (i = 0; i < 2; ++i) {
        const clock_t began = clock();
        CHECK_INT(ms_gpr_recommend(gp, &o, i ? COUNT : COUNT / 4, x, NULL, NULL, NULL, NULL), MS_OK);
        seconds[i] = (double)(clock() - began) / CLOCKS_PER_SEC;
    }
    TEST_NOTE("%d in %.3f s, %d in %.3f s", COUNT / 4, seconds[0], COUNT, seconds[1]);
    CHECK_LE(seconds[1], 8 * seconds[0]);          /* quadratic: 13 */
    qsort(x, COUNT, 2 * sizeof *x, user__compare); /* by x0: rows that are equal stand together */
    for (i = 1; i < COUNT; ++i) CHECK(memcmp(x + i * M, x + (i - 1) * M, M * sizeof *x) != 0);
    ms_gpr_destroy(gp);
    free(x);
}

/* Offsets of 1e5 to 1e9 cost no material and no score: what is found is what is found at 0. */
static void test_offsets(void)
{
    enum { M = 3, N = 80, COUNT = 300 };
    static double x[COUNT * M], data[N * M], y[N], moved[N * M];
    uint64_t state = test_seed;
    double acceptance = 0;
    int power, i;
    for (i = 0; i < N * M; ++i) data[i] = floor(1048576 * test_uniform(&state)) / 1048576; /* exact behind an offset */
    for (i = 0; i < N; ++i) y[i] = fmax(10 - 60 * pow(data[i * M] - 0.3, 2) - 60 * pow(data[i * M + 1] - 0.7, 2), 0);
    for (power = 4; power < 10; ++power) {
        const double offset = power > 4 ? pow(10, power) : 0;
        double low[M], high[M], theta[M + 2] = {-1, -1, 1, 1.5, -1}, sum = 0;
        ms_gpr_recommend_options o = recommend_options();
        ms_gpr_recommend_report report;
        ms_gpr *gp;
        for (i = 0; i < N * M; ++i) moved[i] = data[i] + offset;
        for (i = 0; i < M; ++i) low[i] = offset, high[i] = offset + 1;
        CHECK_INT(inside_create(moved, y, N, M, theta, 0, NULL, &gp, NULL), MS_OK);
        o.space.low = low, o.space.high = high;
        o.search = MS_GPR_SEARCH_THRESHOLD;
        CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, x, NULL, NULL, &report, NULL), MS_OK);
        for (i = 0; i < COUNT; ++i) sum += (x[i * M] - offset) / (int)COUNT;
        if (power == 4) acceptance = report.acceptance;
        CHECK_NEAR(report.acceptance, acceptance, 0.003); /* a few candidates at the edge */
        CHECK_NEAR(sum, 0.3, 0.05);
        ms_gpr_destroy(gp);
    }
}

static void count_candidates(void *user, double *x)
{
    (void)x;
    ++*(int *)user;
}

/* Never nothing: one liked material of twenty, none at all, a model that is flat, no score: 300 different materials of
   the box, and the report says that they are variants. */
static void test_never_nothing(void)
{
    enum { M = 19, COUNT = 300 };
    static double x[COUNT * M], data[100 * M], y[100];
    int n, liked, candidates[2] = {0, 0}, i, j, c;
    for (n = 0; n <= 100; n += 20)
        for (liked = 0; liked < 3; ++liked) {
            uint64_t state = test_seed + (uint64_t)(n + liked);
            ms_gpr_recommend_options o = recommend_options();
            ms_gpr_recommend_report report;
            ms_gpr *gp;
            for (i = 0; i < n * M; ++i) data[i] = test_uniform(&state);
            for (i = 0; i < n; ++i) y[i] = i < liked ? 5 : 0;
            CHECK_INT(ms_gpr_fit(data, y, n, M, NULL, &gp, NULL, NULL), MS_OK);
            CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, x, NULL, NULL, &report, NULL), MS_OK);
            CHECK_INT(report.found, COUNT);
            if (n == 0 || liked == 0) CHECK_INT(report.search, MS_GPR_SEARCH_VARIANTS);
            CHECK_INT(report.liked, n ? liked : 0);
            for (i = 0; i < COUNT; ++i) {
                for (j = 0; j < M; ++j) CHECK(x[i * M + j] >= 0 && x[i * M + j] <= 1);
                for (j = 0; j < i; ++j) CHECK(memcmp(x + i * M, x + j * M, M * sizeof *x) != 0);
                for (j = 0, c = 0; j < M && n && liked; ++j) /* most parameters are those of a liked one */
                    c += fabs(x[i * M + j] - data[j]) < 1e-12 || fabs(x[i * M + j] - data[M + j]) < 1e-12;
                if (n && liked && report.search == MS_GPR_SEARCH_VARIANTS)
                    CHECK(c >= 6); /* 0.3 are drawn anew: 13 of 19 */
            }
            o.search = MS_GPR_SEARCH_VARIANTS;
            o.space.snap = count_candidates;
            for (i = 0; i < 2; ++i) {
                candidates[i] = 0;
                o.space.user = &candidates[i];
                CHECK_INT(ms_gpr_recommend(gp, &o, 64 + 64 * i, x, NULL, NULL, NULL, NULL), MS_OK);
            }
            CHECK_INT(candidates[1] - candidates[0], 64 * 10); /* the best of ten each */
            ms_gpr_destroy(gp);
        }
}

/* Four classes in four of twelve dimensions, some broad and some narrow: each keeps the share of the region that it
   has, as uniform candidates tell, wherever the threshold lies. */
static void test_shares(void)
{
    enum {
        M = 12,
        D = 4,
        MODES = 4,
        EACH = 40,
        FIRST = 80,
        N = FIRST + MODES * EACH,
        MANY = 400000,
        COUNT = 300,
        SEEDS = 4
    };
    static const double center[MODES][D] = {
        {0.2, 0.2, 0.2, 0.2}, {0.8, 0.8, 0.8, 0.8}, {0.2, 0.8, 0.2, 0.8}, {0.8, 0.2, 0.8, 0.2}};
    static const double width[MODES] = {0.15, 0.2, 0.15, 0.18};
    static double x[N * M], y[N], r[COUNT * M];
    double theta[M + 2], worst = 0;
    double *cube = (double *)malloc(sizeof(double) * MANY * M), *mean = (double *)malloc(sizeof(double) * MANY);
    uint64_t state = 21;
    ms_gpr *gp;
    int i, k, c, step;
    for (i = 0; i < N; ++i) {
        for (c = 0, y[i] = 0; c < MODES; ++c) {
            double d2 = 0;
            for (k = 0; k < M && c == 0; ++k) {
                double v = i < FIRST || k >= D
                    ? test_uniform(&state)
                    : center[(i - FIRST) / EACH][k] + width[(i - FIRST) / EACH] * test_normal(&state);
                x[i * M + k] = fmin(fmax(v, 0), 1);
            }
            for (k = 0; k < D; ++k)
                d2 += (x[i * M + k] - center[c][k]) * (x[i * M + k] - center[c][k]) / (width[c] * width[c]);
            y[i] = fmax(y[i], 10 * exp(-0.5 * d2));
        }
    }
    for (k = 0; k < M + 2; ++k) theta[k] = k < D ? log(0.3) : k < M ? log(50.0) : k == M ? log(5.0) : log(0.1);
    CHECK_INT(inside_create(x, y, N, M, theta, 0, NULL, &gp, NULL), MS_OK);
    for (i = 0; i < MANY * M; ++i) cube[i] = test_uniform(&state);
    CHECK_INT(ms_gpr_predict(gp, cube, MANY, mean, NULL, NULL), MS_OK);
    for (step = 0; step < 3; ++step) {
        double share[MODES] = {0, 0, 0, 0}, got[MODES] = {0, 0, 0, 0}, all = 0;
        ms_gpr_recommend_report report;
        int seed;
        for (seed = 0; seed < SEEDS; ++seed) {
            ms_gpr_recommend_options o = recommend_options();
            o.seed = (uint64_t)seed + 100 * test_seed;
            o.tau = 0.45 + 0.15 * step;
            o.search = MS_GPR_SEARCH_THRESHOLD;
            CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, r, NULL, NULL, &report, NULL), MS_OK);
            for (i = 0; i < COUNT; ++i)
                got[2 * (r[i * M] > 0.5 ? r[i * M + 1] <= 0.5 : r[i * M + 1] > 0.5) + (r[i * M] > 0.5)] += 1.0 /
                    (COUNT * (int)SEEDS);
        }
        for (i = 0; i < MANY; ++i) {
            const double *p = cube + i * M;
            if (mean[i] < report.threshold) continue;
            all += 1;
            share[2 * (p[0] > 0.5 ? p[1] <= 0.5 : p[1] > 0.5) + (p[0] > 0.5)] += 1;
        }
        CHECK(all > 500);
        for (c = 0; c < MODES; ++c) worst = fmax(worst, fabs(share[c] / all - got[c]));
        CHECK_NEAR(report.acceptance, all / (int)MANY, 4.5 * sqrt(all / (int)MANY / 4096)); /* binomial */
    }
    CHECK_LE(worst, 0.1); /* a half of 25 candidates that reach the threshold: 0.1 a seed, so 0.05 of four; twice */
    TEST_NOTE("shares within %.3f", worst);
    ms_gpr_destroy(gp);
    free(cube), free(mean);
}

/* More modes than the shares are measured of, wide and narrow, joined and apart: all that comes back reaches the
   threshold. */
static void test_many_modes(void)
{
    enum { COUNT = 300, M = 5, MODES = 24, N = 5 * MODES };
    static double x[COUNT * M], mean[COUNT], score_x[N * M], score[N];
    static const double tau[4] = {0.2, 0.4, 0.7, 0.95}, length[3] = {0.12, 0.25, 0.5}, low[M] = {0},
                        high[M] = {1, 1, 1, 1, 1};
    double theta[M + 2];
    int seed, step, wide, i, k;
    uint64_t state = 11 + test_seed;
    TEST_METHOD;
    for (i = 0; i < N; ++i) {
        for (k = 0; k < M; ++k) score_x[i * M + k] = test_uniform(&state);
        score[i] = i < MODES ? 10 - 0.01 * i : 0;
    }
    for (wide = 0; wide < 3; ++wide) {
        ms_gpr_recommend_options o;
        ms_gpr *gp;
        for (k = 0; k < M + 2; ++k) theta[k] = log(k < M ? length[wide] : k == M ? 5 : 0.05);
        CHECK_INT(inside_create(score_x, score, N, M, theta, 0, NULL, &gp, NULL), MS_OK);
        memset(&o, 0, sizeof o);
        o.search = MS_GPR_SEARCH_THRESHOLD;
        o.space.low = low;
        o.space.high = high;
        for (step = 0; step < 4; ++step)
            for (seed = 0; seed < 3; ++seed) {
                ms_gpr_recommend_report report;
                o.tau = tau[step];
                o.seed = (uint64_t)seed + 100 * test_seed;
                CHECK_INT(ms_gpr_recommend(gp, &o, COUNT, x, mean, NULL, &report, NULL), MS_OK);
                for (i = 0; i < COUNT; ++i) CHECK(mean[i] >= report.threshold);
                for (i = 0; i < COUNT * M; ++i) CHECK(x[i] >= 0 && x[i] <= 1);
            }
        ms_gpr_destroy(gp);
    }
}

/* tau is relative to what can be had: at every tau there are materials, and a model that overshoots the scale is not
   believed. */
static void test_every_tau(void)
{
    int seed, step, i;
    TEST_METHOD;
    for (seed = 1; seed <= 3; ++seed) {
        taste t = taste_make((uint64_t)seed + 40, 150, 19, 0.10, NULL);
        double x[40 * 19], mean[40], top = 0;
        for (i = 0; i < t.n; ++i) top = fmax(top, t.y[i]);
        for (step = 1; step <= 10; ++step) {
            ms_gpr_recommend_options o = recommend_options();
            ms_gpr_recommend_report report;
            o.search = MS_GPR_SEARCH_THRESHOLD;
            o.tau = 0.1 * step;
            CHECK_INT(ms_gpr_recommend(t.gp, &o, 40, x, mean, NULL, &report, NULL), MS_OK);
            CHECK_LE(report.threshold, o.tau * top + 1e-9);
            for (i = 0; i < 40; ++i) CHECK(mean[i] >= report.threshold);
        }
        taste_free(&t);
    }
}

/* What contradicts itself is refused by name; what only says things twice is not. A grid of equal columns, of which one
   comes in steps that the other's range cuts, keeps to the steps. */
static void test_space_refusals(void)
{
    enum { M = 10 };
    static const int outside[2] = {5, 10}, listed[2] = {5, 1}, steps_apart[2] = {4, 7}, apart[2] = {8, 3},
                     twice[6] = {0, 1, 1, 0, 1, 1}, columns[2] = {5, 6}, beyond[2] = {5, 10}, same[2] = {5, 5};
    static const double rows[4] = {0.1, 0.9, 0.5, 0.3};
    double low[M], high[M], steps[M], x[M], v;
    int i, k;
    for (i = 0; i < 14; ++i) {
        const char *says = NULL, *said;
        space_wish w;
        space_list list[2];
        space_kept kept;
        memset(&w, 0, sizeof w);
        memset(list, 0, sizeof list);
        for (k = 0; k < M; ++k) low[k] = 0, high[k] = 1, steps[k] = k == 7 ? 0.25 : 0;
        list[0].columns = columns, list[0].width = 2, list[0].rows = rows, list[0].count = 2;
        list[1] = list[0];
        w.low = low, w.high = high, w.steps = steps, w.lists = list, w.list_count = 1, w.equal_count = 1;
        w.equal = twice;
        switch (i) {
        case 0: w.equal = outside, says = "parameters 5 and 10 are to be equal, but there is no such parameter"; break;
        case 1: w.equal = listed, says = "parameters 5 and 1 are to be equal, but are in a list"; break;
        case 2:
            w.equal = steps_apart, steps[4] = 0.5, says = "parameters 4 and 7 are to be equal, but come in different";
            break;
        case 3: w.equal = apart, low[3] = 0.8, high[8] = 0.7, says = "but no value is in both ranges"; break;
        case 4: low[5] = high[5] = 0.45, says = "list 1 contradicts the box: none of its 2 rows"; break;
        case 5: w.list_count = 2, says = "parameter 5 of list 2 is in two lists"; break;
        case 6: steps[6] = 0.1, says = "parameter 6 of list 1 is in a list and comes in steps"; break;
        case 7: list[0].columns = beyond, says = "parameter 10 of list 1 is not there"; break;
        case 8: list[0].columns = same, says = "parameter 5 of list 1 is in two lists or twice in one"; break;
        case 9: list[0].count = 0, says = "a list has no columns or no rows"; break;
        case 10: low[2] = 0.9, high[2] = 0.2, says = "parameter 2 has an empty range"; break;
        case 11: steps[3] = -1, says = "parameter 3 has a step that is not a number"; break;
        case 12: low[7] = -HUGE_VAL, says = "parameter 7 comes in steps but has no range"; break;
        default: w.equal_count = 3;
        }
        said = space_make(&kept, &w, M);
        if ((said == NULL) != (says == NULL) || (says && strstr(said, says) == NULL))
            TEST_FAIL("case %d says '%s'", i, said ? said : "nothing");
        if (!said) space_free(&kept);
    }
    { /* steps of 0.25 from 0, equal to a column of [0.1, 1]: 0.25 to 1; a snapped material stays as it is */
        static const int equal[2] = {0, 1};
        uint64_t state = test_seed;
        space_wish w;
        space_kept kept;
        ms_gpr_space s;
        memset(&w, 0, sizeof w);
        low[0] = 0, high[0] = 1, steps[0] = 0.25, low[1] = 0.1, high[1] = 1, steps[1] = 0;
        w.low = low, w.high = high, w.steps = steps, w.equal = equal, w.equal_count = 1;
        CHECK(space_make(&kept, &w, 2) == NULL);
        s = space_of(&kept);
        for (i = 0; i < 2000; ++i) {
            double again[2];
            for (k = 0; k < 2; ++k) x[k] = s.low[k] + (s.high[k] - s.low[k]) * test_uniform(&state);
            s.snap(s.user, x);
            v = x[0] / 0.25;
            CHECK(memcmp(&x[0], &x[1], sizeof *x) == 0 && fabs(v - floor(v + 0.5)) < 1e-12 && v > 0.9 && v < 4.1);
            memcpy(again, x, sizeof again);
            s.snap(s.user, again);
            CHECK(memcmp(again, x, sizeof again) == 0);
        }
        space_free(&kept);
    }
}

/* A plane whose space has a snap: all of its materials satisfy it. */
static void test_plane_keeps(void)
{
    enum { M = 6, Z = 12 };
    static double x[Z * M], low[M], high[M], steps[M];
    static const int equal[2] = {1, 2};
    ms_gpr_latent_options l;
    ms_gpr_latent *plane;
    space_wish wish;
    space_kept kept;
    int i, k;
    for (i = 0; i < Z * M; ++i) x[i] = 0.5 + 0.4 * sin(1.7 * i);
    for (k = 0; k < M; ++k) low[k] = 0, high[k] = k == 3 ? 0.4 : 1, steps[k] = k == 4 ? 0.2 : 0;
    memset(&wish, 0, sizeof wish);
    memset(&l, 0, sizeof l);
    wish.low = low, wish.high = high, wish.steps = steps, wish.equal = equal, wish.equal_count = 1;
    CHECK(space_make(&kept, &wish, M) == NULL);
    l.space = space_of(&kept);
    CHECK_INT(ms_gpr_latent_fit(x, Z, M, &l, &plane, NULL, NULL), MS_OK);
    for (i = 0; i <= 400; ++i) {
        double at[2], far[M];
        at[0] = -4 + 0.02 * i;
        at[1] = 0.3 * at[0];
        CHECK_INT(ms_gpr_latent_map(plane, at, 1, far, NULL, NULL), MS_OK);
        CHECK(memcmp(&far[1], &far[2], sizeof *far) == 0 && far[3] <= 0.4);
        CHECK_NEAR(far[4] * 5, floor(far[4] * 5 + 0.5), 1e-12);
        for (k = 0; k < M; ++k) CHECK(far[k] >= 0 && far[k] <= 1);
    }
    ms_gpr_latent_destroy(plane);
    space_free(&kept);
}

static void test_recommend_refusals(void)
{
    taste t = taste_make(1, 60, 5, 0.3, NULL);
    double x[50 * 5], zero[60], low[5];
    ms_gpr_recommend_options o = recommend_options();
    ms_gpr_recommend_report report;
    ms_error error;
    ms_gpr *gp;
    memset(zero, 0, sizeof zero);
    CHECK_INT(ms_gpr_recommend(NULL, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 0, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    o.tau = 1.5;
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "tau is 1.5") != NULL);
    o.tau = (double)NAN;
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    o = recommend_options();
    o.avoid_count = -1;
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
#ifndef __cplusplus /* where no enum can hold such a value */
    o = recommend_options();
    o.search = (ms_gpr_search)9;
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
#endif
    o = recommend_options();
    memset(low, 0, sizeof low);
    o.space.low = o.space.high = o.avoid = low; /* one material alone */
    o.avoid_count = 1;
    if (ms_gpr_recommend(t.gp, &o, 5, x, NULL, NULL, &report, &error) == MS_OK) TEST_FAIL("all of the box is avoided");
    CHECK_INT(report.found, 0);
    o = recommend_options();
    o.tau = 1; /* the best alone */
    CHECK_INT(ms_gpr_recommend(t.gp, &o, 3, x, NULL, NULL, &report, &error), MS_OK);
    /* all zero, and no score at all */
    CHECK_INT(inside_create(t.x, zero, 60, 5, t.theta, 0, NULL, &gp, NULL), MS_OK);
    o = recommend_options();
    CHECK_INT(ms_gpr_recommend(gp, &o, 5, x, NULL, NULL, &report, &error), MS_OK);
    CHECK(report.search == MS_GPR_SEARCH_VARIANTS && report.liked == 0);
    ms_gpr_destroy(gp);
    CHECK_INT(inside_create(NULL, NULL, 0, 5, t.theta, 0, NULL, &gp, NULL), MS_OK);
    CHECK_INT(ms_gpr_recommend(gp, &o, 5, x, NULL, NULL, &report, &error), MS_OK);
    CHECK(report.search == MS_GPR_SEARCH_VARIANTS && report.liked == 0);
    memset(&report, 0x55, sizeof report); /* a call that is refused leaves it alone */
    CHECK_INT(ms_gpr_recommend(gp, &o, 0, x, NULL, NULL, &report, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(report.found, 0x55555555);
    ms_gpr_destroy(gp);
    taste_free(&t);
}

/* One and two scores, duplicates that disagree, near-duplicates, tiny noise, constant scores, scores of 1e6 and 1e-6
   and below zero, inputs of 1e4 with an offset of 1e8, one and 200 dimensions, lengths of 1e3 and 1e-3. None
   gives up. */
static void test_recommend_hard(void)
{
    enum { N = 40 };
    static double x[N * 200], y[N], theta[202], low[200], high[200], r[30 * 200], mean[30];
    int problem, search, i, k;
    for (problem = 0; problem < 13; ++problem) {
        uint64_t state = (uint64_t)problem + 9;
        int n = problem == 0 ? 1 : problem == 1 ? 2 : N, m = problem == 8 ? 1 : problem == 9 ? 200 : 6;
        double inputs = problem == 7 ? 1e4 : 1, offset = problem == 7 ? 1e8 : 0,
               scores = problem == 5 ? 1e6
            : problem == 6           ? 1e-6
                                     : 1;
        double length = problem == 10 ? 1e3
            : problem == 12           ? 1e-3
            : problem == 9            ? 3
                                      : 0.5,
               shift = problem == 11 ? -5 : 0;
        ms_gpr *gp;
        for (i = 0; i < n; ++i) {
            double s = 0;
            for (k = 0; k < m; ++k) {
                double v = test_uniform(&state);
                if (problem == 2 && i > 0) v = (x[k] - offset) / inputs;            /* duplicates */
                if (problem == 3 && i > 0) v = (x[k] - offset) / inputs + 1e-9 * v; /* near-duplicates */
                x[i * m + k] = offset + inputs * v;
                if (k < 3) s += v;
            }
            y[i] = scores * (problem == 4 ? 7 : problem == 2 || problem == 3 ? i % 5 : s * 3 + shift);
        }
        for (k = 0; k < m; ++k) {
            theta[k] = log(length * inputs);
            low[k] = offset;
            high[k] = offset + inputs;
        }
        theta[m] = log(3 * scores);
        theta[m + 1] = log((problem == 3 ? 1e-16 : 0.1) * scores);
        CHECK_INT(inside_create(x, y, n, m, theta, 0, NULL, &gp, NULL), MS_OK);
        for (search = MS_GPR_SEARCH_AUTO; search <= MS_GPR_SEARCH_VARIANTS; ++search) {
            ms_gpr_recommend_options o = recommend_options();
            ms_gpr_recommend_report report;
            ms_error error;
            ms_status status;
            o.search = (ms_gpr_search)search;
            o.space.low = low;
            o.space.high = high;
            error.message[0] = 0;
            status = ms_gpr_recommend(gp, &o, 30, r, mean, NULL, &report, &error);
            if (status != MS_OK) TEST_FAIL("problem %d: %s", problem, error.message);
            for (i = 0; i < report.found; ++i) {
                CHECK(mean[i] >= report.threshold - 1e-9 * fabs(report.threshold)); /* two sums */
                for (k = 0; k < m; ++k) CHECK(r[i * m + k] >= low[k] && r[i * m + k] <= high[k]);
            }
        }
        ms_gpr_destroy(gp);
    }
}

/* Users as scarce as 10%: what is recommended is liked far more often than a uniform material. */
static void test_precision(void)
{
    int seed, i, users = test_full ? 8 : 3;
    double precision = 0, base = 0;
    for (seed = 1; seed <= users; ++seed) {
        taste t = taste_make((uint64_t)seed + 20, 250, 19, 0.10, NULL);
        double x[300 * 19];
        uint64_t state = (uint64_t)seed;
        ms_gpr_recommend_options o = recommend_options();
        CHECK_INT(ms_gpr_recommend(t.gp, &o, 300, x, NULL, NULL, NULL, NULL), MS_OK);
        for (i = 0; i < 300; ++i) {
            double y[1], p[19];
            precision += (user_true(&t.u, x + i * 19) >= 4) / (300.0 * users);
            user_gallery(&t.u, 1, p, y, &state);
            base += (user_true(&t.u, p) >= 4) / (300.0 * users);
        }
        taste_free(&t);
    }
    TEST_NOTE("truly >= 4 of 10: %.0f%%, uniform %.1f%%", 100 * precision, 100 * base);
    CHECK(precision > 0.6); /* with lengths that are right; measured 0.8 to 0.95 */
    CHECK(base < 0.1);
}

static void test_recommend_memory(void)
{
    double x[10 * 4], y[10], theta[6] = {-0.7, -0.7, -0.7, -0.7, 1, -2}, r[20 * 4], mean[20], sigma[20];
    uint64_t state = 5;
    int i;
    for (i = 0; i < 40; ++i) x[i] = test_uniform(&state);
    for (i = 0; i < 10; ++i) y[i] = 10 * x[4 * i];
    TEST_ALLOCATION_SWEEP(400, {
        ms_gpr *gp;
        ms_gpr_options options;
        ms_gpr_gallery_options g;
        memset(&options, 0, sizeof options);
        options.allocator = allocator;
        status = inside_create(x, y, 10, 4, theta, 0, &options, &gp, NULL);
        if (status == MS_OK) status = ms_gpr_recommend(gp, NULL, 20, r, mean, sigma, NULL, NULL);
        memset(&g, 0, sizeof g);
        if (status == MS_OK) status = ms_gpr_gallery(gp, &g, 20, r, NULL);
        ms_gpr_destroy(gp);
    });
}

static int filled; /* blocks */

static void *alloc_filled(void *fill, size_t size)
{
    void *p = malloc(size);
    ++filled;
    if (p) memset(p, *(int *)fill, size);
    return p;
}

static void release_filled(void *fill, void *p, size_t size)
{
    (void)fill;
    (void)size;
    free(p);
}

/* Whatever memory held before, zeros or NaN, results are the same to the bit. */
static void test_memory_content(void)
{
    static double first[2000], second[2000];
    int fills[] = {0, 0xff}, i, kind;
    for (i = 0; i < 2; ++i) {
        double *out = i ? second : first;
        ms_gpr_options options;
        ms_gpr_latent_options latent_options;
        ms_gpr_latent *plane;
        taste t;
        memset(&options, 0, sizeof options);
        memset(&latent_options, 0, sizeof latent_options);
        options.allocator.user = &fills[i];
        options.allocator.alloc = alloc_filled;
        options.allocator.release = release_filled;
        latent_options.allocator = options.allocator;
        t = taste_make(9, 61, 5, 0.3, &options); /* 61: three padded points */
        memset(out, 0, sizeof first);
        for (kind = 0; kind < 3; ++kind) {
            ms_gpr_recommend_options o = recommend_options();
            o.search = (ms_gpr_search)kind;
            filled = 0;
            CHECK_INT(ms_gpr_recommend(t.gp, &o, 40, out + 200 * kind, NULL, NULL, NULL, NULL), MS_OK);
            CHECK(filled > 10);
        }
        for (kind = 0; kind < 2; ++kind) {
            ms_gpr_gallery_options g;
            memset(&g, 0, sizeof g);
            g.seed = (uint64_t)kind;
            filled = 0;
            CHECK_INT(ms_gpr_gallery(t.gp, &g, 20, out + 600 + 100 * kind, NULL), MS_OK);
            CHECK(filled > 10);
        }
        CHECK_INT(ms_gpr_latent_fit(t.x, 19, 5, &latent_options, &plane, NULL, NULL), MS_OK);
        {
            const double *points = ms_gpr_latent_view_of(plane).points;
            filled = 0;
            CHECK_INT(ms_gpr_latent_map(plane, points, 19, out + 1300, out + 1500, NULL), MS_OK);
            CHECK(filled > 1);
            filled = 0;
            CHECK_INT(ms_gpr_preference(t.gp, t.x, t.x + 20, 40, out + 1550, NULL), MS_OK);
            CHECK(filled > 1);
            CHECK_INT(inside_latent_likelihood(plane, out + 1600, out + 1601, out + 1610, NULL), MS_OK);
        }
        ms_gpr_latent_destroy(plane);
        taste_free(&t);
    }
    CHECK(memcmp(first, second, sizeof first) == 0);
}

/* --- galleries --- */

/* Choices of the active gallery: each is at least as good as all later ones, once the model has seen those before it:
   here by appending them with their own mean, which changes no mean. Near the threshold; in a model that has choices,
   here one between two equal materials, every second one by P(score > floor) sigma. */
static void test_gallery_greedy(void)
{
    enum { Q = 24, M = 8 };
    int chosen, q, r, i;
    for (chosen = 0; chosen < 2; ++chosen) {
        taste t = taste_make(3, 60, M, 0.2, NULL);
        double x[Q * M], top = 0, threshold;
        /* both ways lose about half the digits in differences of variances; with choices every row that is appended is
           also held to the prior mean by 1e-5 of sf^2 */
        double tolerance = chosen ? 1e-3 : 1e-6;
        const int equals[2] = {0, 60};
        if (chosen) CHECK_INT(inside_compare(t.gp, t.x, 1, equals, 1, NULL), MS_OK);
        for (i = 0; i < ms_gpr_view_of(t.gp).n; ++i) top = fmax(top, ms_gpr_view_of(t.gp).value[i]);
        threshold = 0.6 * top; /* the floor is 0 */
        CHECK_INT(ms_gpr_gallery(t.gp, NULL, Q, x, NULL), MS_OK);
        for (q = 0; q < Q; ++q) {
            double worth[Q], mean[Q], variance[Q];
            CHECK_INT(ms_gpr_predict(t.gp, x + q * M, Q - q, mean, variance, NULL), MS_OK);
            for (r = 0; r < Q - q; ++r) {
                double sigma = sqrt(variance[r]);
                worth[r] = chosen && q % 2 ? 0.5 * erfc(-mean[r] / (sqrt(2.0) * sigma)) * sigma
                                           : 1.96 * sigma - fabs(mean[r] - threshold);
            }
            for (r = 1; r < Q - q; ++r) CHECK_LE(worth[r], worth[0] + tolerance);
            CHECK_INT(inside_append(t.gp, x + q * M, mean[0], NULL), MS_OK);
        }
        taste_free(&t);
    }
}

/* What the active gallery is for: after rounds of 10, recommendations are better than after as many uniform scores; the
   first one is spread, and every round differs. */
static void test_gallery_active(void)
{
    enum { M = 19, N = 80, ROUND = 10, SOLD = 100, USERS = 6 };
    static double x[N * M], y[N], r[SOLD * M];
    double sum[2] = {0, 0}, nearest[2] = {0, 0}, apart = 0;
    int i, k, n, way, users = test_full ? 2 * USERS : USERS;
    for (i = 0; i < users; ++i)
        for (way = 0; way < 2; ++way) {
            uint64_t state = 70 + (uint64_t)i + 1000 * test_seed;
            person u = user_make(state, M, 0.15);
            ms_gpr_recommend_options o = recommend_options();
            ms_gpr *gp;
            for (n = 0; n <= N; n += ROUND) {
                ms_gpr_gallery_options g;
                CHECK_INT(ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL), MS_OK);
                if (n == N) break;
                memset(&g, 0, sizeof g);
                if (way)
                    for (k = 0; k < ROUND * M; ++k) x[n * M + k] = test_uniform(&state);
                else CHECK_INT(ms_gpr_gallery(gp, &g, ROUND, x + n * M, NULL), MS_OK);
                for (k = 0; n == 0 && k < ROUND * ROUND; ++k) { /* the two that are nearest each other */
                    const double *a = x + k / ROUND * M, *b = x + k % ROUND * M;
                    double d2 = 0;
                    int d;
                    for (d = 0; d < M; ++d) d2 += (a[d] - b[d]) * (a[d] - b[d]);
                    if (a < b) nearest[way] = k == 1 ? d2 : fmin(nearest[way], d2);
                }
                if (n == 0 && way == 1) apart += (sqrt(nearest[0]) - sqrt(nearest[1])) / users;
                if (n > 0) CHECK(memcmp(x + n * M, x + (n - ROUND) * M, ROUND * M * sizeof *x) != 0);
                for (k = n; k < n + ROUND; ++k) y[k] = user_score(&u, x + k * M, &state);
                ms_gpr_destroy(gp);
            }
            if (ms_gpr_recommend(gp, &o, SOLD, r, NULL, NULL, NULL, NULL) == MS_OK)
                for (k = 0; k < SOLD; ++k) sum[way] += user_true(&u, r + k * M) / ((int)SOLD * users);
            ms_gpr_destroy(gp);
        }
    TEST_NOTE("true score of recommendations after %d scores: %.1f, uniform galleries %.1f", N, sum[0], sum[1]);
    CHECK(sum[0] > sum[1] + 1);
    TEST_NOTE("first gallery: its nearest two %.2f farther apart than uniform ones", apart);
    CHECK(apart > 0);
}

/* Galleries stay in the box, and no two materials are the same; a model without scores gives galleries as well. */
static void test_gallery_kinds(void)
{
    enum { Q = 40 };
    int kind, q, i, k, n;
    for (n = 0; n <= 80; n += 80) {
        taste t = taste_make(8, 80, 6, 0.3, NULL);
        ms_gpr *gp;
        double low[6] = {0, 0, 0, 0, 0, 0.5}, high[6] = {1, 1, 1, 1, 1, 0.5};
        CHECK_INT(inside_create(t.x, t.y, n, 6, t.theta, 0, NULL, &gp, NULL), MS_OK);
        for (kind = 0; kind < 2; ++kind) {
            double x[Q * 6];
            ms_gpr_gallery_options g;
            memset(&g, 0, sizeof g);
            g.seed = (uint64_t)kind;
            g.space.low = low;
            g.space.high = high;
            g.seed = test_seed;
            CHECK_INT(ms_gpr_gallery(gp, &g, Q, x, NULL), MS_OK);
            for (q = 0; q < Q; ++q) {
                double least = 1e300;
                for (k = 0; k < 6; ++k) CHECK(x[q * 6 + k] >= low[k] && x[q * 6 + k] <= high[k]);
                for (i = 0; i < n + q; ++i) {
                    const double *other = i < n ? t.x + i * 6 : x + (i - n) * 6;
                    double d2 = 0;
                    for (k = 0; k < 6; ++k) {
                        double d = (other[k] - x[q * 6 + k]) / exp(t.theta[k]);
                        d2 += d * d;
                    }
                    if (d2 < least) least = d2;
                }
                CHECK(least > 0);
            }
        }
        ms_gpr_destroy(gp);
        taste_free(&t);
    }
    {
        taste t = taste_make(8, 10, 6, 0.3, NULL);
        ms_gpr_gallery_options g;
        ms_error error;
        double x[6];
        memset(&g, 0, sizeof g);
        CHECK_INT(ms_gpr_gallery(NULL, &g, 1, x, &error), MS_INVALID_ARGUMENT);
        CHECK_INT(ms_gpr_gallery(t.gp, &g, 0, x, &error), MS_INVALID_ARGUMENT);
        taste_free(&t);
    }
}

/* --- latent space --- */

/* Reference values computed with 113-bit floats. */
static void test_latent_reference(void)
{
    json *problems = json_load("tests/data/gplvm_problems.json");
    int i, level, k;
    double worst = 0;
    for (i = 0; i < problems->count; ++i) {
        const json *p = &problems->child[i], *rounding = json_get(p, "f64_err");
        int z = (int)json_number(json_get(p, "z")), m = (int)json_number(json_get(p, "d")), count, n;
        double *x = numbers(p, "X", NULL), *latent = numbers(p, "L", NULL), *theta = numbers(p, "theta", NULL);
        double *gradient = numbers(p, "grad", NULL), *slopes = numbers(p, "grad_latent", &n),
               *places = numbers(p, "Ls", &count);
        double *mean = numbers(p, "mean", NULL), *variance = numbers(p, "var", NULL);
        double ll = json_number(json_get(p, "ll"));
        count /= 2;
        for (k = 0; k < 2 * z; ++k) latent[k] /= exp(theta[k % 2]); /* the header's lengths are 1 */
        for (k = 0; k < 2 * count; ++k) places[k] /= exp(theta[k % 2]);
        for (k = 0; k < n; ++k) slopes[k] *= exp(theta[k % 2]);
        for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
            ms_gpr_latent_options o;
            ms_gpr_latent *plane;
            double value, g[4], *s = (double *)malloc((size_t)n * sizeof *s), got[10 * 19], v[10], tolerance, e;
            memset(&o, 0, sizeof o);
            o.simd = (ms_simd)level;
            CHECK_INT(inside_latent(x, z, m, latent, theta + 2, &o, &plane, NULL), MS_OK);
            CHECK_INT(inside_latent_likelihood(plane, &value, g, s, NULL), MS_OK);
            /* 20 times what double precision with direct differences loses, as data/README.md says */
            tolerance = 20 * json_number(json_get(rounding, "ll"));
            CHECK_NEAR(value, ll, (tolerance > 1e-12 ? tolerance : 1e-12) * fabs(ll));
            tolerance = 20 * json_number(json_get(rounding, "grad"));
            e = largest_difference(g, gradient + 2, 2) / largest(gradient, 4);
            CHECK_LE(e, tolerance > 1e-12 ? tolerance : 1e-12);
            tolerance = 20 * json_number(json_get(rounding, "grad_latent"));
            e = largest_difference(s, slopes, n) / largest(slopes, n);
            CHECK_LE(e, tolerance > 1e-12 ? tolerance : 1e-12);
            CHECK_INT(ms_gpr_latent_map(plane, places, count, got, v, NULL), MS_OK);
            /* the mapping has the gradient's condition: its rounding bounds that of the map */
            e = largest_difference(got, mean, count * m) / largest(mean, count * m);
            CHECK_LE(e, tolerance > 1e-12 ? tolerance : 1e-12);
            e = largest_difference(v, variance, count) / exp(2 * theta[2]);
            CHECK_LE(e, tolerance > 1e-12 ? tolerance : 1e-12);
            if (e > worst) worst = e;
            for (k = 0; k < count; ++k) CHECK(v[k] >= 0);
            CHECK(inside_latent_jitter(plane) <= 0);
            CHECK_INT(ms_gpr_latent_view_of(plane).z, z);
            ms_gpr_latent_destroy(plane);
            free(s);
        }
        free(x), free(latent), free(theta), free(gradient), free(slopes), free(places), free(mean), free(variance);
    }
    TEST_NOTE("%d problems, variance within %.1e sf^2", problems->count, worst);
    json_free(problems);
}

/* Fits reach at least the likelihoods of the references, and what L-BFGS-B of SciPy reached as the best of 20 starts
   (two kinds of components at 5 scales, 2 noises): 434.790, 2506.779, 1992.102. */
static void test_latent_likelihood(void)
{
    json *problems = json_load("tests/data/gplvm_problems.json"), *data = json_load("tests/data/gplvm_data.json");
    const char *name[] = {"clusters16", "circle60", "clusters48"};
    double best[] = {434.790, 2506.779, 1992.102};
    int i, level;
    for (i = 0; i < problems->count; ++i) {
        const json *p = &problems->child[i];
        int z = (int)json_number(json_get(p, "z")), m = (int)json_number(json_get(p, "d"));
        double *x = numbers(p, "X", NULL);
        ms_gpr_latent *plane;
        ms_gpr_latent_report report;
        CHECK_INT(ms_gpr_latent_fit(x, z, m, NULL, &plane, &report, NULL), MS_OK);
        CHECK(report.likelihood >= json_number(json_get(p, "ll")));
        ms_gpr_latent_destroy(plane);
        free(x);
    }
    for (i = 0; i < 3; ++i) {
        for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
            int z = i == 0 ? 16 : i == 1 ? 60 : 48;
            double *x = i == 0 ? numbers(&problems->child[0], "X", NULL) : numbers(json_get(data, name[i]), "X", NULL),
                   value;
            ms_gpr_latent_options o;
            ms_gpr_latent *plane;
            ms_gpr_latent_report report;
            memset(&o, 0, sizeof o);
            o.simd = (ms_simd)level;
            CHECK_INT(ms_gpr_latent_fit(x, z, 19, &o, &plane, &report, NULL), MS_OK);
            CHECK(report.likelihood >=
                  best[i] - 0.5); /* other rounding takes other paths; 0.5 in 2000 shows in no picture */
            CHECK_INT(inside_latent_likelihood(plane, &value, NULL, NULL, NULL), MS_OK);
            CHECK_NEAR(value, report.likelihood, 1e-9 * fabs(value)); /* center and scale differ by rounding */
            CHECK(report.error < 0.05 && report.evaluations > 0 && report.evaluations <= 2000);
            if (level == MS_SIMD_AVX2) TEST_NOTE("%s %.3f in %d", name[i], report.likelihood, report.evaluations);
            ms_gpr_latent_destroy(plane);
            free(x);
        }
    }
    json_free(problems);
    json_free(data);
}

/* Known structure comes out: the nearest latent of a clusters48 material is of its own cluster; neighbors on the
   circle stay neighbors. */
static void test_latent_structure(void)
{
    json *data = json_load("tests/data/gplvm_data.json");
    const char *name[] = {"clusters48", "circle60"};
    int set, i, j;
    for (set = 0; set < 2; ++set) {
        const json *d = json_get(data, name[set]);
        double *x = numbers(d, "X", NULL), *label = numbers(d, "label", NULL), *where = numbers(d, "true", NULL);
        int z = set ? 60 : 48, right = 0;
        ms_gpr_latent *plane;
        const double *l;
        CHECK_INT(ms_gpr_latent_fit(x, z, 19, NULL, &plane, NULL, NULL), MS_OK);
        l = ms_gpr_latent_view_of(plane).points;
        for (i = 0; i < z; ++i) {
            int nearest = -1;
            double least = 1e300;
            for (j = 0; j < z; ++j) {
                double a = l[2 * i] - l[2 * j], b = l[2 * i + 1] - l[2 * j + 1];
                if (j == i || !(a * a + b * b < least)) continue;
                least = a * a + b * b;
                nearest = j;
            }
            if (set == 0) right += fabs(label[i] - label[nearest]) < 0.5;
            else
                right += hypot(where[2 * i] - where[2 * nearest], where[2 * i + 1] - where[2 * nearest + 1]) <
                    0.35; /* of radius 1 */
        }
        TEST_NOTE("%s %d of %d", name[set], right, z);
        CHECK(right >= z - 1);
        ms_gpr_latent_destroy(plane);
        free(x), free(label), free(where);
    }
    json_free(data);
}

/* With a prior, the optimum balances it: dlogp/dL = prior L. And the latents draw together. */
static void test_latent_prior(void)
{
    json *problems = json_load("tests/data/gplvm_problems.json");
    double *x = numbers(&problems->child[0], "X", NULL), gradient[32], norm[3];
    int step, i;
    for (step = 0; step < 3; ++step) {
        ms_gpr_latent_options o;
        ms_gpr_latent *plane;
        const double *l;
        memset(&o, 0, sizeof o);
        o.prior = step == 0 ? 0 : step == 1 ? 1 : 30;
        CHECK_INT(ms_gpr_latent_fit(x, 16, 19, &o, &plane, NULL, NULL), MS_OK);
        l = ms_gpr_latent_view_of(plane).points;
        CHECK_INT(inside_latent_likelihood(plane, NULL, NULL, gradient, NULL), MS_OK);
        for (i = 0, norm[step] = 0; i < 32; ++i) norm[step] += l[i] * l[i];
        /* the fit ends where slopes of logp / 304 are about 3e-5 */
        for (i = 0; i < 32; ++i) CHECK_NEAR(gradient[i], o.prior * l[i], 0.1);
        ms_gpr_latent_destroy(plane);
    }
    CHECK(norm[1] < norm[0] && norm[2] < norm[1]);
    free(x);
    json_free(problems);
}

/* Two and three materials, equal rows, a constant column, one and 200 columns, offsets of 1e8, scales of 1e4 and 1e-6;
   refusals. */
static void test_latent_hard(void)
{
    static double x[30 * 200];
    double latent[60], theta[2] = {0, -36.8}; /* noise 1e-16 */
    ms_gpr_latent *plane;
    ms_gpr_latent_report report;
    ms_gpr_latent_options o;
    ms_error error;
    int problem, i, k;
    for (problem = 0; problem < 9; ++problem) {
        uint64_t state = (uint64_t)problem + 5;
        int z = problem == 0 ? 2 : problem == 1 ? 3 : 30, m = problem == 4 ? 1 : problem == 5 ? 200 : 12;
        double scale = problem == 7 ? 1e4 : problem == 8 ? 1e-6 : 1, offset = problem == 6 ? 1e8 : 0, norm = 0;
        memset(&o, 0, sizeof o);
        for (i = 0; i < z; ++i) {
            double a = test_uniform(&state), b = test_uniform(&state);
            for (k = 0; k < m; ++k) {
                double v = sin(3 * a + k) + cos(2 * b * k) + 0.05 * test_normal(&state);
                if (problem == 2 && i % 3 == 1) v = x[(i - 1) * m + k] / scale; /* equal rows */
                if (problem == 3 && k == 5) v = 0.25;
                x[i * m + k] = offset + scale * v;
                norm = fabs(scale * v) > norm ? fabs(scale * v) : norm;
            }
        }
        CHECK_INT(ms_gpr_latent_fit(x, z, m, &o, &plane, &report, &error), MS_OK);
        if (plane == NULL) continue;
        CHECK(isfinite(report.likelihood));
        CHECK(report.error < 0.5 * norm);
        for (i = 0; i < z * 2; ++i) CHECK(isfinite(ms_gpr_latent_view_of(plane).points[i]));
        if (problem == 2) { /* equal materials lie together */
            const double *l = ms_gpr_latent_view_of(plane).points;
            for (i = 0; i + 1 < z; i += 3) CHECK_LE(hypot(l[2 * i] - l[2 * i + 2], l[2 * i + 1] - l[2 * i + 3]), 0.05);
        }
        ms_gpr_latent_destroy(plane);
    }
    /* equal latents without noise: jitter is reported, and results are finite */
    for (i = 0; i < 60; ++i) latent[i] = i % 4;
    CHECK_INT(inside_latent(x, 30, 12, latent, theta, NULL, &plane, NULL), MS_OK);
    CHECK(inside_latent_jitter(plane) > 0 && inside_latent_jitter(plane) <= 1e-6);
    CHECK_INT(inside_latent_likelihood(plane, &report.likelihood, NULL, latent, NULL), MS_OK);
    CHECK(isfinite(report.likelihood));
    ms_gpr_latent_destroy(plane);
    /* refusals */
    CHECK_INT(ms_gpr_latent_fit(x, 1, 12, NULL, &plane, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(plane == NULL);
    memset(&o, 0, sizeof o);
    o.prior = -1;
    CHECK_INT(ms_gpr_latent_fit(x, 30, 12, &o, &plane, NULL, &error), MS_INVALID_ARGUMENT);
    x[7 * 12 + 3] = (double)NAN;
    CHECK_INT(ms_gpr_latent_fit(x, 30, 12, NULL, &plane, NULL, &error), MS_BAD_DATA);
    CHECK_INT(error.position, 8);
    x[7 * 12 + 3] = (double)INFINITY;
    CHECK_INT(inside_latent(x, 30, 12, latent, theta, NULL, &plane, &error), MS_BAD_DATA);
    for (i = 0; i < 360; ++i) x[i] = 1e8 + 0.1 * (i % 12);
    CHECK_INT(ms_gpr_latent_fit(x, 30, 12, NULL, &plane, NULL, &error), MS_BAD_DATA);
    CHECK(strstr(error.message, "equal") != NULL);
    ms_gpr_latent_destroy(NULL);
}

static void test_latent_memory(void)
{
    double x[8 * 4], at[2] = {0, 0}, material[4], theta[6] = {0, 0, 0, 0, 0, -2};
    uint64_t state = 2;
    int i;
    for (i = 0; i < 32; ++i) x[i] = test_uniform(&state);
    TEST_ALLOCATION_SWEEP(1000, {
        ms_gpr_latent_options o;
        ms_gpr_latent *plane;
        ms_gpr *gp = NULL;
        ms_gpr_options options;
        memset(&o, 0, sizeof o);
        memset(&options, 0, sizeof options);
        o.allocator = options.allocator = allocator;
        status = ms_gpr_latent_fit(x, 8, 4, &o, &plane, NULL, NULL);
        if (status == MS_OK) status = inside_create(x, x, 8, 4, theta, 0, &options, &gp, NULL);
        if (status == MS_OK) status = inside_latent_likelihood(plane, at, NULL, NULL, NULL);
        if (status == MS_OK) status = ms_gpr_latent_map(plane, at, 1, material, NULL, NULL);
        ms_gpr_destroy(gp);
        ms_gpr_latent_destroy(plane);
    });
}

/* --- maps --- */

static ms_error map_error;

typedef struct plane_of_taste {
    taste t;
    double *liked; /* [z][m] */
    int z;
    ms_gpr_latent *plane;
    map_grid grid;
} plane_of_taste;

static plane_of_taste plane_make(int resolution)
{
    plane_of_taste p;
    ms_gpr_recommend_options o = recommend_options();
    p.t = taste_make(2, 200, 12, 0.2, NULL);
    p.z = 24;
    p.liked = (double *)malloc(24 * 12 * sizeof(double));
    CHECK_INT(ms_gpr_recommend(p.t.gp, &o, p.z, p.liked, NULL, NULL, NULL, NULL), MS_OK);
    CHECK_INT(ms_gpr_latent_fit(p.liked, p.z, 12, NULL, &p.plane, NULL, NULL), MS_OK);
    p.grid = map_around(p.plane, resolution);
    return p;
}

static void plane_free(plane_of_taste *p)
{
    ms_gpr_latent_destroy(p->plane);
    free(p->liked);
    taste_free(&p->t);
}

/* A picture of 8 x 8 pixels: smooth in the parameters. */
static ms_status draw(void *calls, const double *x, float *picture)
{
    int i;
    ++*(int *)calls;
    for (i = 0; i < 64; ++i) picture[i] = (float)(0.5 + 0.5 * sin(3 * x[i % 12] + x[(i * 7) % 12] + 0.1 * i));
    return MS_OK;
}

static ms_status draw_nan(void *calls, const double *x, float *picture)
{
    draw(calls, x, picture);
    if (*(int *)calls == 5) picture[3] = (float)NAN;
    return *(int *)calls == 9 ? MS_UNSUPPORTED : MS_OK;
}

/* Each map is what its definition says, point by point. */
static void test_maps(void)
{
    enum { R = 21 };
    plane_of_taste p = plane_make(R);
    double mean[R * R], confidence[R * R], similarity[R * R], coarse[7 * 7], sf2;
    map_grid small = p.grid;
    variant_similarity s;
    int calls = 0, row, column, i, k;
    sf2 = pow(ms_gpr_latent_view_of(p.plane).sf, 2);
    memset(&s, 0, sizeof s);
    s.x = p.liked + 3 * 12;
    s.pixels = 64;
    s.render = draw;
    s.user = &calls;
    s.scale = 0.2;
    small.columns = small.rows = 7;
    CHECK_INT(map_preference(p.plane, p.t.gp, &p.grid, mean, &map_error), MS_OK);
    CHECK_INT(map_confidence(p.plane, &p.grid, confidence, &map_error), MS_OK);
    CHECK_INT(variants_map(p.plane, &s, &p.grid, similarity, &map_error), MS_OK);
    CHECK_INT(calls, R * R + 1);
    CHECK_INT(variants_map(p.plane, &s, &small, coarse, &map_error), MS_OK);
    for (row = 0; row < R; ++row)
        for (column = 0; column < R; ++column) {
            double at[2], x[12], v = 0, u, u2, d2 = 0;
            float a[64], b[64];
            i = row * R + column;
            map_point(&p.grid, column, row, at);
            ms_gpr_latent_map(p.plane, at, 1, x, &v, NULL);
            ms_gpr_predict(p.t.gp, x, 1, &u, &u2, NULL);
            CHECK_NEAR(mean[i], u, 1e-9); /* scores up to 10; the product of two exponentials against one of a sum */
            CHECK_NEAR(confidence[i], 1 - v / sf2, 1e-12);
            draw(&calls, s.x, a);
            draw(&calls, x, b);
            for (k = 0; k < 64; ++k) d2 += ((double)a[k] - (double)b[k]) * ((double)a[k] - (double)b[k]) / 64;
            CHECK_NEAR(similarity[i], exp(-d2 / (2 * 0.04)), 1e-6); /* float pictures */
        }
    /* training latents are well known, far corners are not */
    for (i = 0; i < p.z; ++i) {
        const double *l = ms_gpr_latent_view_of(p.plane).points + 2 * i;
        CHECK(l[0] > p.grid.x0 && l[0] < p.grid.x1 && l[1] > p.grid.y0 && l[1] < p.grid.y1);
        CHECK(map_value(&p.grid, confidence, l[0], l[1]) > 0.5);
    }
    /* without pictures: between the parameters; equal to 1 where the plane passes through the reference */
    s.pixels = 0;
    s.scale = 0.1;
    CHECK_INT(variants_map(p.plane, &s, &p.grid, similarity, &map_error), MS_OK);
    for (i = 0; i < R * R; ++i) CHECK(similarity[i] >= 0 && similarity[i] <= 1);
    plane_free(&p);
}

static void test_grid_value(void)
{
    map_grid g;
    double map[3 * 4], at[2], x, y;
    uint64_t state = test_seed;
    int row, column, i;
    g.x0 = -2;
    g.x1 = 4;
    g.y0 = 1;
    g.y1 = 3;
    g.columns = 4;
    g.rows = 3;
    for (row = 0; row < 3; ++row)
        for (column = 0; column < 4; ++column) {
            map_point(&g, column, row, at);
            map[row * 4 + column] = 1 + 2 * at[0] - 3 * at[1] + 0.5 * at[0] * at[1];
        }
    for (i = 0; i < 1000; ++i) { /* a bilinear function comes back */
        x = -2 + 6 * test_uniform(&state);
        y = 1 + 2 * test_uniform(&state);
        CHECK_NEAR(map_value(&g, map, x, y), 1 + 2 * x - 3 * y + 0.5 * x * y, 1e-13);
    }
    CHECK_NEAR(map_value(&g, map, -9, 9), map[2 * 4], 1e-14); /* clamped; corners are the grid's own */
    CHECK_NEAR(map_value(&g, map, 4, 3), map[11], 1e-14);
    CHECK_NEAR(map_value(&g, map, (double)INFINITY, 1), map[3], 1e-14);
    CHECK_NEAR(map_value(&g, map, (double)NAN, (double)NAN), map[0], 1e-14);
}

/* NULL where nothing says what it means: a status and the argument's name, or nothing. */
static void test_null(void)
{
    plane_of_taste p = plane_make(4);
    double map[16], at[2] = {0, 0}, x[12];
    ms_gpr_latent *other;
    ms_error error;
#define REFUSES(call, name)               \
    CHECK_INT(call, MS_INVALID_ARGUMENT); \
    CHECK(strcmp(error.message, name " is NULL") == 0)
    REFUSES(ms_gpr_recommend(NULL, NULL, 1, x, NULL, NULL, NULL, &error), "gp");
    REFUSES(ms_gpr_recommend(p.t.gp, NULL, 1, NULL, NULL, NULL, NULL, &error), "x");
    REFUSES(ms_gpr_gallery(NULL, NULL, 1, x, &error), "gp");
    REFUSES(ms_gpr_gallery(p.t.gp, NULL, 1, NULL, &error), "x");
    REFUSES(ms_gpr_latent_fit(NULL, 5, 2, NULL, &other, NULL, &error), "x");
    REFUSES(ms_gpr_latent_fit(p.liked, 5, 2, NULL, NULL, NULL, &error), "out");
    REFUSES(inside_latent(p.liked, 5, 2, NULL, at, NULL, &other, &error), "latent");
    REFUSES(inside_latent(p.liked, 5, 2, p.liked, NULL, NULL, &other, &error), "theta");
    REFUSES(inside_latent_likelihood(NULL, map, NULL, NULL, &error), "plane");
    REFUSES(ms_gpr_latent_map(NULL, at, 1, x, NULL, &error), "plane");
    REFUSES(ms_gpr_latent_map(p.plane, NULL, 1, x, NULL, &error), "latent");
#undef REFUSES
    CHECK(ms_gpr_latent_view_of(NULL).z == 0 && ms_gpr_latent_view_of(NULL).points == NULL);
    ms_gpr_latent_destroy(NULL);
    plane_free(&p);
}

/* A picture that fails ends the call with its status; one that is not finite is like nothing. A grid of one point is
   one of two by two. A model whose scores are all below 0 has variants as well. */
static void test_map_refusals(void)
{
    plane_of_taste p = plane_make(4);
    double map[16], x[12], lambda = 0.5;
    variant_similarity s;
    variant_found v, best;
    ms_gpr_view view;
    ms_gpr *below;
    double shifted[200];
    ms_error error;
    int calls = 0, i;
    memset(&s, 0, sizeof s);
    s.x = p.liked;
    s.pixels = 64;
    s.scale = 0.1;
    s.render = draw_nan;
    s.user = &calls;
    CHECK_INT(variants_map(p.plane, &s, &p.grid, map, &error), MS_UNSUPPORTED); /* the ninth picture fails */
    CHECK(map[3] <= 0); /* the fifth picture is the fourth point's, and has a NaN */
    CHECK(map[2] > 0);
    CHECK_INT(map_around(p.plane, 1).columns, 2);
    s.pixels = 0;
    CHECK_INT(variants_find(p.plane, p.t.gp, &s, &p.grid, &lambda, 1, 10, 0, &best, x, &error), MS_OK);
    view = ms_gpr_view_of(p.t.gp);
    for (i = 0; i < view.n; ++i) shifted[i] = view.y[i] - 100;
    view.y = shifted, view.mean -= 100, view.floor -= 100, view.floor_value -= 100;
    CHECK_INT(ms_gpr_create(&view, NULL, &below, &error), MS_OK);
    CHECK_INT(variants_find(p.plane, below, &s, &p.grid, &lambda, 1, -90, 0, &v, x, &error), MS_OK);
    CHECK_NEAR(v.value, best.value, 1e-9); /* the same, 100 lower */
    ms_gpr_destroy(below);
    plane_free(&p);
}

/* Variants: the largest value of their lambda over a fine grid; similarity grows and the score falls with lambda. */
static void test_variants(void)
{
    enum { L = 9, FINE = 61 };
    plane_of_taste p = plane_make(20);
    double lambda[L], x[L * 12], at[2], *score = (double *)malloc(FINE * FINE * sizeof *score),
                                        *similar = (double *)malloc(FINE * FINE * sizeof *similar),
                                        *known = (double *)malloc(FINE * FINE * sizeof *known), best, range = 0;
    variant_found v[L];
    variant_similarity s;
    map_grid fine = p.grid;
    int calls = 0, i, k;
    memset(&s, 0, sizeof s);
    s.x = p.liked + 5 * 12;
    s.pixels = 64;
    s.render = draw;
    s.user = &calls;
    s.scale = 0.1;
    for (i = 0; i < L; ++i) lambda[i] = i / (double)(L - 1);
    fine.columns = fine.rows = FINE;
    CHECK_INT(map_preference(p.plane, p.t.gp, &fine, score, &map_error), MS_OK);
    CHECK_INT(variants_map(p.plane, &s, &fine, similar, &map_error), MS_OK);
    CHECK_INT(map_confidence(p.plane, &fine, known, &map_error), MS_OK);
    CHECK_NEAR(fine.x1 - fine.x0, fine.y1 - fine.y0, 1e-12);
    calls = 0;
    CHECK_INT(variants_find(p.plane, p.t.gp, &s, &p.grid, lambda, L, 10, 0, v, x, &map_error), MS_OK);
    TEST_NOTE("%d pictures for %d variants", calls, L);
    CHECK_LE(calls, 20 * 20 + 2 + L * 160);
    for (i = 0; i < L; ++i) {
        double top = -1e300, again[12], u;
        CHECK_NEAR(v[i].value, v[i].confidence * (lambda[i] * v[i].similarity + (1 - lambda[i]) * v[i].score / 10),
                   1e-12);
        if (i) CHECK(v[i].confidence * v[i].similarity >= v[i - 1].confidence * v[i - 1].similarity - 1e-14);
        if (i) /* scores to 10: two searches that end in one place differ by the rounding of a product */
            CHECK(v[i].confidence * v[i].score <= v[i - 1].confidence * v[i - 1].score + 1e-13);
        CHECK(v[i].confidence > 0.5); /* not where the plane knows nothing */
        CHECK(v[i].latent[0] > p.grid.x0 && v[i].latent[0] < p.grid.x1 && v[i].latent[1] > p.grid.y0 &&
              v[i].latent[1] < p.grid.y1);
        for (k = 0; k < FINE * FINE; ++k) {
            double value = known[k] * (lambda[i] * similar[k] + (1 - lambda[i]) * score[k] / 10);
            if (value > top) top = value;
        }
        CHECK(v[i].value >= top - 1e-3); /* a fine grid of three times the resolution finds hardly better */
        at[0] = v[i].latent[0];
        at[1] = v[i].latent[1];
        ms_gpr_latent_map(p.plane, at, 1, again, NULL, NULL);
        CHECK_LE(largest_difference(again, x + i * 12, 12), 1e-15);
        ms_gpr_predict(p.t.gp, again, 1, &u, NULL, NULL);
        CHECK_NEAR(u, v[i].score, 1e-12);
    }
    CHECK(v[L - 1].similarity > 0.9); /* the reference is a training material of the plane */
    best = v[0].score;
    CHECK_INT(variants_find(p.plane, p.t.gp, &s, &p.grid, lambda, 1, 0, 0, v, NULL, &map_error), MS_OK);
    CHECK_NEAR(v[0].score, best, 1e-9); /* lambda 0 does not depend on the unit of scores */
    for (i = 0; i < 2 * p.z; ++i)
        for (k = i % 2; k < 2 * p.z; k += 2)
            range = fmax(range, ms_gpr_latent_view_of(p.plane).points[i] - ms_gpr_latent_view_of(p.plane).points[k]);
    CHECK_INT(variants_find(p.plane, p.t.gp, &s, &p.grid, lambda, L, 10, 0.05, v, x, &map_error), MS_OK);
    for (i = 0; i < L; ++i) /* those that keep apart look different */
        for (k = 0; k < i; ++k) {
            float one[64], other[64];
            double d2 = 0;
            int pixel;
            CHECK(hypot(v[i].latent[0] - v[k].latent[0], v[i].latent[1] - v[k].latent[1]) >= 0.05 * range);
            draw(&calls, x + i * 12, one);
            draw(&calls, x + k * 12, other);
            for (pixel = 0; pixel < 64; ++pixel) d2 += pow((double)one[pixel] - (double)other[pixel], 2) / 64;
            CHECK(sqrt(d2) > 3 / 255.0);
        }
    CHECK_NEAR(v[0].score, best, 1e-9); /* the first has no other to keep apart from */
    for (i = 1; i < L; ++i) CHECK(v[i].confidence > 0.5);
    /* no room: still as many, the farthest */
    CHECK_INT(variants_find(p.plane, p.t.gp, &s, &p.grid, lambda, L, 10, 9, v, x, &map_error), MS_OK);
    for (i = 1; i < L; ++i)
        CHECK(hypot(v[i].latent[0] - v[0].latent[0], v[i].latent[1] - v[0].latent[1]) > 0.1 * range);
    for (k = 0; k < 20; ++k) { /* on any grid, no variant is less like its reference than the latent of the reference */
        const double *own = ms_gpr_latent_view_of(p.plane).points + 2 * k, most = 1;
        double near[4], sure[4];
        map_grid coarse = p.grid, here = p.grid;
        coarse.columns = coarse.rows = 2;
        here.columns = here.rows = 2;
        here.x0 = own[0], here.y0 = own[1];
        here.x1 = own[0] + 1, here.y1 = own[1] + 1;
        s.x = p.liked + k * 12;
        CHECK_INT(variants_map(p.plane, &s, &here, near, &map_error), MS_OK);
        CHECK_INT(map_confidence(p.plane, &here, sure, &map_error), MS_OK);
        CHECK_INT(variants_find(p.plane, p.t.gp, &s, &coarse, &most, 1, 0, 0, v, NULL, &map_error), MS_OK);
        CHECK(v[0].value >= near[0] * sure[0] - 1e-9);
    }
    free(score);
    free(similar);
    free(known);
    plane_free(&p);
}

/* Persons of four kinds, active galleries, 80 scores: honest ones hear nothing; of those whose taste changed 20 scores
   ago, and of those who answer one time in five at random, most do. The kinds' first persons set the limits: these are
   others. */
static void test_warnings(void)
{
    enum { M = 19, N = 80, ROUND = 10, PERSONS = 3, KINDS = 4 };
    static const int kinds[KINDS] = {0, 1, 4, 6};
    static double x[N * M], y[N];
    int heard[3] = {0, 0, 0}, changed = 0, way, i, n, k;
    TEST_METHOD;
    for (way = 0; way < 3; ++way) /* honest, another taste from 60 on, partly random */
        for (i = 0; i < KINDS * PERSONS; ++i) {
            person u = user_of_kind(kinds[i / PERSONS], (uint64_t)(300 + i), M);
            person other = user_of_kind(kinds[(i / PERSONS + 1) % KINDS], (uint64_t)(400 + i), M);
            uint64_t state = (uint64_t)(50 + i);
            if (way == 2) u.wrong = 0.2;
            for (n = 0; n <= N; n += ROUND) {
                char text[WARNINGS_TEXT];
                ms_gpr_gallery_options g;
                double explained;
                ms_gpr *gp;
                memset(&g, 0, sizeof g);
                g.seed = (uint64_t)i;
                CHECK_INT(ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL), MS_OK);
                warnings_judge(gp, &explained);
                if (n == N && warning_of(gp, explained, text)) {
                    ++heard[way];
                    changed += way == 1 && strstr(text, "the last 20 scores are lower") != NULL;
                }
                if (n < N) CHECK_INT(ms_gpr_gallery(gp, &g, ROUND, x + n * M, NULL), MS_OK);
                for (k = n; k < n + ROUND && n < N; ++k)
                    y[k] = user_score(way == 1 && n >= 60 ? &other : &u, x + k * M, &state);
                ms_gpr_destroy(gp);
            }
        }
    TEST_NOTE("of %d honest %d, changed %d (%d by name), random %d", KINDS * PERSONS, heard[0], heard[1], changed,
              heard[2]);
    CHECK(heard[0] <= 1); /* one in twenty by the limits: more than one of twelve has a chance of 0.12 */
    CHECK(heard[1] >= KINDS * PERSONS / 2 && changed >= KINDS * PERSONS / 4);
    CHECK(heard[2] >= KINDS * PERSONS / 3);
}

static const test_case cases[] = {
    {"recommend uniform over a ball", test_ball},
    {"recommend walk like rejection", test_walk_like_rejection},
    {"recommend every search and level", test_searches},
    {"recommend best", test_best},
    {"recommend controls", test_controls},
    {"recommend box", test_box},
    {"recommend natural box", test_natural_box},
    {"recommend wishes", test_wishes},
    {"recommend snap", test_snap},
    {"recommend few materials", test_few_materials},
    {"recommend many materials", test_many_materials},
    {"recommend offsets", test_offsets},
    {"recommend never nothing", test_never_nothing},
    {"recommend shares", test_shares},
    {"recommend many modes", test_many_modes},
    {"space refusals", test_space_refusals},
    {"plane keeps", test_plane_keeps},
    {"recommend every tau", test_every_tau},
    {"recommend threads", test_threads},
    {"recommend refusals", test_recommend_refusals},
    {"recommend hard cases", test_recommend_hard},
    {"recommend precision", test_precision},
    {"recommend memory", test_recommend_memory},
    {"memory content", test_memory_content},
    {"gallery greedy choices", test_gallery_greedy},
    {"gallery active", test_gallery_active},
    {"gallery kinds", test_gallery_kinds},
    {"latent reference", test_latent_reference},
    {"latent likelihood", test_latent_likelihood},
    {"latent structure", test_latent_structure},
    {"latent prior", test_latent_prior},
    {"latent hard cases", test_latent_hard},
    {"latent memory", test_latent_memory},
    {"maps", test_maps},
    {"maps bilinear", test_grid_value},
    {"maps refusals", test_map_refusals},
    {"null", test_null},
    {"variants", test_variants},
    {"warnings", test_warnings},
};

TEST_MAIN(cases)
