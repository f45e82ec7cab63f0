/* ms_gpr.h: speed of the likelihood, of predictions and of fits, and what the fits are worth: Jensen-Shannon divergence
   between the predicted and the true preference of synthetic users. Writes build/bench/gpr.csv, gpr.md, gpr_jsd.svg,
   gpr_time.svg.

   Peers, both on one thread: scikit-learn through python3, if it can be imported; libgp (Blum & Riedmiller 2013), if
   LIBGP_DRIVER names a program that is called as `DRIVER data.csv n m iterations` (rows x..., y; start log l = 0, log
   sf = 0, log sn = log 0.1), fits with RProp and prints: CPU seconds of the fit, log likelihood reached, CPU seconds of
   one gradient, predictions a second. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "bench.h"
#include "plot.h"
#include "users.h"
#include "thesis.h" /* calls ms_gpr__ functions */

/* peer libraries: -lopenblas */
#ifdef HAVE_OPENBLAS
extern void openblas_set_num_threads(int count);
extern void dpotrf_(const char *part, const int *n, double *a, const int *stride, int *info);
extern void dpotri_(const char *part, const int *n, double *a, const int *stride, int *info);
#endif

static FILE *csv, *md;

/* --- likelihood and gradient --- */

/* As a fit asks for it: again and again in the same memory, which the peer keeps as well. */
typedef struct evaluated {
    ms_gpr__problem problem;
    double sf2, sn2;
} evaluated;

static void run_likelihood(void *context)
{
    static double value, gradient[64];
    evaluated *l = (evaluated *)context;
    if (!ms_gpr__evaluate(&l->problem, l->sf2, l->sn2, &value, gradient)) exit(1);
}

/* n materials of a synthetic user, standardised scores; theta of a fit that is on its way. */
static ms_gpr *model(int n, int m, ms_simd level, double *x, double *y)
{
    double theta[64], sum = 0, sum2 = 0;
    uint64_t state = 17;
    person u = user_make(21, m, 0.19);
    ms_gpr_options options;
    ms_gpr *gp;
    int i;
    user_gallery(&u, n, x, y, &state);
    for (i = 0; i < n; ++i) sum += y[i] / n;
    for (i = 0; i < n; ++i) sum2 += (y[i] - sum) * (y[i] - sum) / n;
    for (i = 0; i < n; ++i) y[i] = (y[i] - sum) / sqrt(sum2);
    for (i = 0; i < m + 2; ++i) theta[i] = i < m ? 1 : i == m ? 0 : -2;
    memset(&options, 0, sizeof options);
    options.simd = level;
    if (inside_create(x, y, n, m, theta, 0, &options, &gp, NULL) != MS_OK) exit(1);
    return gp;
}

/* Cholesky and inverse of a covariance matrix of n points by OpenBLAS, at whatever level it likes; 0: it is not
   there. */
static double peer_factor(int n)
{
    double seconds[5] = {0};
#ifdef HAVE_OPENBLAS
    double *a = (double *)malloc((size_t)n * (size_t)n * sizeof *a);
    int run, i, j, info;
    if (a == NULL) exit(1);
    openblas_set_num_threads(1);
    for (run = 0; run < 5; ++run) {
        double start;
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) a[(size_t)i * (size_t)n + (size_t)j] = exp(-0.01 * abs(i - j)) + (i == j);
        start = bench_cpu();
        dpotrf_("L", &n, a, &n, &info);
        dpotri_("L", &n, a, &n, &info);
        seconds[run] = bench_cpu() - start;
    }
    free(a);
    return bench_median(seconds, 5);
#else
    (void)n;
    return seconds[0];
#endif
}

/* Fits of many scores. */
static void bench_large_fits(void)
{
    static const int sizes[][2] = {{500, 38}, {1000, 19}, {2000, 19}};
    static double x[2000 * 38], y[2000];
    int s, i;
    fprintf(md, "\n| fit, scores of a user who likes 10%% | time, medians of 3 users |\n|---|---:|\n");
    for (s = 0; s < 3; ++s) {
        double seconds[3];
        for (i = 0; i < 3; ++i) {
            uint64_t state = 100 + (uint64_t)i;
            person u = user_make((uint64_t)i + 1, sizes[s][1], 0.1);
            double start;
            ms_gpr *gp;
            user_gallery(&u, sizes[s][0], x, y, &state);
            start = bench_cpu();
            if (ms_gpr_fit(x, y, sizes[s][0], sizes[s][1], NULL, &gp, NULL, NULL) != MS_OK) exit(1);
            seconds[i] = bench_cpu() - start;
            ms_gpr_destroy(gp);
        }
        fprintf(md, "| n = %d, m = %d | %.2g s |\n", sizes[s][0], sizes[s][1], bench_median(seconds, 3));
        fprintf(csv, "large_fit,%d,%d,,%.6g,\n", sizes[s][0], sizes[s][1], bench_median(seconds, 3));
    }
}

static void bench_likelihood(void)
{
    static const int sizes[][2] = {{250, 19}, {500, 38}, {2000, 19}};
    static double x[2000 * 38], y[2000];
    int s, l;
    fprintf(
        md,
        "\n| log likelihood + gradient | scalar | base | avx2 | OpenBLAS: potrf + potri alone |\n|---|---:|---:|---:|---:|\n");
    for (s = 0; s < 3; ++s) {
        fprintf(md, "| n = %d, m = %d |", sizes[s][0], sizes[s][1]);
        for (l = MS_SIMD_SCALAR; l <= MS_SIMD_AVX2; ++l) {
            ms_gpr *gp = model(sizes[s][0], sizes[s][1], (ms_simd)l, x, y);
            ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
            evaluated of;
            bench_time t;
            if (inside_problem(gp, &of.problem, &memory, NULL) != MS_OK) exit(1);
            of.sf2 = ms_gpr__sf2(gp);
            of.sn2 = ms_gpr__sn2(gp) + ms_gpr_view_of(gp).jitter * of.sf2;
            t = bench_run(run_likelihood, &of, sizes[s][0] < 2000 ? 15 : l == MS_SIMD_AVX2 ? 5 : 1);
            if ((int)ms_gpr_view_of(gp).level != l) fprintf(md, " - |");
            else fprintf(md, " %.2f ms |", 1e3 * t.median);
            fprintf(csv, "likelihood,%d,%d,%s,%.6g,%.2g\n", sizes[s][0], sizes[s][1], ms_simd_string((ms_simd)l),
                    t.median, t.spread);
            ms_gpr__release(&memory);
            ms_gpr_destroy(gp);
        }
        fprintf(md, " %.2f ms |\n", 1e3 * peer_factor(sizes[s][0]));
    }
}

/* --- predictions --- */

#define CANDIDATES 20000

typedef struct prediction {
    const ms_gpr *gp;
    double *x, *mean, *variance;
    float *x_f, *mean_f;
    int count;
} prediction;

static void run_mean(void *context)
{
    prediction *p = (prediction *)context;
    if (ms_gpr_predict(p->gp, p->x, p->count, p->mean, NULL, NULL) != MS_OK) exit(1);
}

static void run_variance(void *context)
{
    prediction *p = (prediction *)context;
    if (ms_gpr_predict(p->gp, p->x, 2000, p->mean, p->variance, NULL) != MS_OK) exit(1);
}

static void bench_predictions(void)
{
    enum { N = 250, M = 19 };
    static double x[CANDIDATES * M], mean[CANDIDATES], variance[CANDIDATES], xt[N * M], y[N], training[N];
    uint64_t state = 3;
    int l, i, variant;
    for (i = 0; i < CANDIDATES * M; ++i) x[i] = test_uniform(&state);
    fprintf(md, "\n| predictions, n = 250, m = 19, a second | mean | mean and variance |\n|---|---:|---:|\n");
    for (l = MS_SIMD_SCALAR; l <= MS_SIMD_AVX2; ++l) {
        for (variant = 0; variant < (l == MS_SIMD_AVX2 ? 2 : 1); ++variant) {
            ms_gpr_fit_options o;
            person u = user_make(21, M, 0.19);
            uint64_t gallery = 17;
            ms_gpr *gp;
            prediction p;
            bench_time t[2];
            int kept = M;
            memset(&o, 0, sizeof o);
            o.simd = (ms_simd)l;
            user_gallery(&u, N, xt, training, &gallery);
            memcpy(y, training, sizeof y);
            if (ms_gpr_fit(xt, y, N, M, &o, &gp, NULL, NULL) != MS_OK) exit(1);
            if ((int)ms_gpr_view_of(gp).level != l) {
                ms_gpr_destroy(gp);
                continue;
            }
            if (variant) inside_simplify(gp, 0.02, &kept);
            p.gp = gp, p.x = x, p.mean = mean, p.variance = variance, p.count = CANDIDATES;
            t[0] = bench_run(run_mean, &p, 9);
            t[1] = bench_run(run_variance, &p, 5);
            fprintf(md, "| %s", ms_simd_string((ms_simd)l));
            if (variant) fprintf(md, ", simplified to %d dimensions", kept);
            fprintf(md, " | %.2f M | %.3f M |\n", 1e-6 * CANDIDATES / t[0].median, 2e-3 / t[1].median);
            fprintf(csv, "predict_f64,%d,%d,%s,%.6g,%.2g\n", N, kept, ms_simd_string((ms_simd)l),
                    t[0].median / CANDIDATES, t[0].spread / CANDIDATES);
            ms_gpr_destroy(gp);
        }
    }
}

/* --- fits and what they are worth --- */

enum { REFERENCE = 1500 };

/* The synthetic users of the tests, m = 19 or 38: materials, scores, true preference. */
static void reference_user(int m, double *x, double *y, double *truth)
{
    char *materials = test_read_file(m == 19 ? "tests/data/X19.csv" : "tests/data/X38.csv", NULL), *p = materials;
    char *scores = test_read_file(m == 19 ? "tests/data/user_glassy19.csv" : "tests/data/user_glassy38.csv", NULL),
         *q = scores;
    int i;
    if (materials == NULL || scores == NULL) {
        fprintf(stderr, "run from the repository's root\n");
        exit(1);
    }
    for (i = 0; i < REFERENCE * m; ++i, ++p) x[i] = strtod(p, &p);
    q = strchr(q, '\n');
    for (i = 0; i < REFERENCE; ++i) {
        y[i] = strtod(q + 1, &q);
        truth[i] = strtod(q + 1, &q);
    }
    free(materials), free(scores);
}

/* Table 3.2 of the thesis, which does not state the start: with all lengths 0.33 it looks like this. */
static void bench_table_3_2(void)
{
    static const int size[] = {150, 250, 500};
    static double x[REFERENCE * 38], y[REFERENCE], truth[REFERENCE], mean[REFERENCE / 2];
    int m, s, c;
    fprintf(
        md,
        "\n| Table 3.2: JSD, every length starts at 0.33 | RProp | SCG | **default of this header, starts of its own** |\n"
        "|---|---:|---:|---:|\n");
    for (m = 19; m <= 38; m += 19) {
        reference_user(m, x, y, truth);
        for (s = 0; s < 3; ++s) {
            fprintf(md, "| m = %d, n = %d |", m, size[s]);
            for (c = 0; c < 3; ++c) {
                ms_gpr *gp;
                double jsd;
                if (c < 2) gp = thesis_fit(x, y, size[s], m, c ? THESIS_SCG : THESIS_RPROP, 0.33, NULL);
                else if (ms_gpr_fit(x, y, size[s], m, NULL, &gp, NULL, NULL) != MS_OK) exit(1);
                ms_gpr_predict(gp, x + REFERENCE / 2 * m, REFERENCE / 2, mean, NULL, NULL); /* held out */
                jsd = user_jsd(mean, truth + REFERENCE / 2, REFERENCE / 2);
                fprintf(md, " %.3f |", jsd);
                fprintf(csv, "table_3_2,%d,%d,%d,%.6g,\n", size[s], m, c, jsd);
                ms_gpr_destroy(gp);
            }
            fprintf(md, "\n");
        }
    }
}

typedef struct contender {
    const char *name;
    int method; /* 0: of this header; 2 and 3: RProp and SCG of the thesis */
    int no_floor;
    int classes; /* how many classes of material its users like; the thesis's like one */
    int exact;   /* learns from the true preference, which goes on below 0, in place of scores */
} contender;

static const contender contenders[] = {{"default (MAP)", 0, 0, 1, 0},
                                       {"MAP, no floor", 0, 1, 1, 0},
                                       {"RProp (thesis)", 2, 0, 1, 0},
                                       {"SCG", 3, 0, 1, 0},
                                       {"two classes liked: default", 0, 0, 2, 0},
                                       {"two classes liked: RProp", 2, 0, 2, 0},
                                       {"two classes liked: exact scores", 0, 1, 2, 1}};
#define CONTENDERS 7
#define SIZES 6

static void bench_taste(void)
{
    enum { M = 19, USERS = 10, HELD = 1500 };
    static const double no_floor = -1e30, size[SIZES] = {50, 100, 150, 250, 350, 500};
    static double jsd[CONTENDERS][SIZES], seconds[CONTENDERS][SIZES], x[500 * M], y[500], held[HELD * M], truth[HELD],
        mean[HELD], exact[500];
    static plot p;
    int c, s, i, users[USER_CLASSES + 1] = {0, 0, 0}, k;
    for (i = 0; users[1] < USERS || users[2] < USERS; ++i) {
        uint64_t state = 900 + (uint64_t)i;
        person u = user_make(300 + (uint64_t)i, M, i % 2 ? 0.19 : 0.10);
        if (users[u.classes] == USERS) continue;
        ++users[u.classes];
        user_gallery(&u, 500, x, y, &state);
        for (k = 0; k < 500; ++k) exact[k] = 10 * (user__g(&u, x + k * M) - u.cut) / (u.top - u.cut);
        for (k = 0; k < HELD * M; ++k) held[k] = test_uniform(&state);
        for (k = 0; k < HELD; ++k) truth[k] = user_true(&u, held + k * M);
        for (s = 0; s < SIZES; ++s) {
            for (c = 0; c < CONTENDERS; ++c) {
                ms_gpr_fit_options o;
                double start = bench_cpu();
                ms_gpr *gp;
                if (contenders[c].classes != u.classes) continue;
                memset(&o, 0, sizeof o);
                if (contenders[c].no_floor) o.floor = &no_floor;
                if (contenders[c].method >= 2)
                    gp = thesis_fit(x, y, (int)size[s], M, contenders[c].method - 2, 1, NULL);
                else {
                    if (ms_gpr_fit(x, contenders[c].exact ? exact : y, (int)size[s], M, &o, &gp, NULL, NULL) != MS_OK)
                        exit(1);
                }
                seconds[c][s] += (bench_cpu() - start) / (int)USERS;
                ms_gpr_predict(gp, held, HELD, mean, NULL, NULL);
                jsd[c][s] += user_jsd(mean, truth, HELD) / (int)USERS;
                ms_gpr_destroy(gp);
            }
        }
    }
    fprintf(md, "\n| JSD (nats) and fit time, m = 19, mean of %d users |", USERS);
    for (s = 0; s < SIZES; ++s) fprintf(md, " n = %.0f |", size[s]);
    fprintf(md, "\n|---|");
    for (s = 0; s < SIZES; ++s) fprintf(md, "---:|");
    for (c = 0; c < CONTENDERS; ++c) {
        fprintf(md, "\n| %s%s%s |", c ? "" : "**", contenders[c].name, c ? "" : "**");
        for (s = 0; s < SIZES; ++s) {
            fprintf(md, " %.3f, %.0f ms |", jsd[c][s], 1e3 * seconds[c][s]);
            fprintf(csv, "jsd,%.0f,%d,%s,%.6g,%.6g\n", size[s], M, contenders[c].name, jsd[c][s], seconds[c][s]);
        }
    }
    fprintf(md, "\n");
    plot_begin(&p, "Divergence from the true preference, m = 19", "scores n", "Jensen-Shannon divergence (nats)",
               PLOT_LOG_X | PLOT_LOG_Y);
    for (c = 0; c < CONTENDERS; ++c) plot_series(&p, contenders[c].name, size, jsd[c], SIZES, PLOT_LINE | PLOT_DOTS);
    plot_write(&p, "build/bench/gpr_jsd.svg");
    plot_begin(&p, "Time of a fit on one core, m = 19", "scores n", "seconds", PLOT_LOG_X | PLOT_LOG_Y);
    for (c = 0; c < CONTENDERS; ++c)
        plot_series(&p, contenders[c].name, size, seconds[c], SIZES, PLOT_LINE | PLOT_DOTS);
    plot_write(&p, "build/bench/gpr_time.svg");
}

/* --- peers: the same data, the same start, likelihood reached and time --- */

static const char sklearn_script[] =
    "import os, sys, time\n"
    "os.environ.update(OMP_NUM_THREADS='1', OPENBLAS_NUM_THREADS='1')\n"
    "import numpy as np, sklearn, warnings\n"
    "warnings.simplefilter('ignore')\n"
    "from sklearn.gaussian_process import GaussianProcessRegressor as G\n"
    "from sklearn.gaussian_process.kernels import RBF, WhiteKernel, ConstantKernel as C\n"
    "d = np.loadtxt('build/bench/gpr_peer.csv', delimiter=',')\n"
    "x, y = d[:, :-1], d[:, -1]\n"
    "g = G(C(1.0, (1e-6, 1e6)) * RBF(np.ones(x.shape[1]), (1e-2, 1e3)) + WhiteKernel(0.01, (1e-6, 1e2)), alpha=0)\n"
    "t = time.process_time()\n"
    "g.fit(x, y)\n"
    "print('%s %.6g %.9g' % (sklearn.__version__, time.process_time() - t, g.log_marginal_likelihood_value_))\n";

static int ask(const char *command, char *line, size_t size)
{
    FILE *pipe = popen(command, "r");
    int good = pipe != NULL && fgets(line, (int)size, pipe) != NULL;
    if (pipe) pclose(pipe);
    return good;
}

static void bench_peers(void)
{
    enum { N = 250, M = 19 };
    static double x[REFERENCE * M], y[REFERENCE], truth[REFERENCE];
    const char *driver = getenv("LIBGP_DRIVER");
    char line[256], command[600], version[32];
    double seconds, likelihood, evaluation, rate, full, sum = 0, sum2 = 0;
    FILE *f = bench_open("gpr_peer.csv");
    ms_gpr *gp;
    int i, k;
    reference_user(M, x, y, truth);
    for (i = 0; i < N; ++i) sum += y[i] / (int)N;
    for (i = 0; i < N; ++i) sum2 += (y[i] - sum) * (y[i] - sum) / (int)N;
    for (i = 0; i < N; ++i) y[i] = (y[i] - sum) / sqrt(sum2);
    for (i = 0; i < N; ++i) {
        for (k = 0; k < M; ++k) fprintf(f, "%.17g,", x[i * M + k]);
        fprintf(f, "%.17g\n", y[i]);
    }
    fclose(f);
    {
        ms_gpr_fit_report r;
        double t[5];
        for (i = 0; i < 5; ++i) {
            double start = bench_cpu();
            if (ms_gpr_fit(x, y, N, M, NULL, &gp, &r, NULL) != MS_OK) exit(1);
            t[i] = bench_cpu() - start;
            ms_gpr_destroy(gp);
        }
        full = bench_median(t, 5);
    }
    fprintf(md,
            "\n| fit, n = 250, m = 19, one core | log likelihood | time | the default of this header | times faster |\n"
            "|---|---:|---:|---:|---:|\n");
    if (driver) {
        snprintf(command, sizeof command, "%s build/bench/gpr_peer.csv %d %d 100", driver, N, M);
        if (ask(command, line, sizeof line) &&
            sscanf(line, "%lf %lf %lf %lf", &seconds, &likelihood, &evaluation, &rate) == 4) {
            fprintf(md, "| libgp, RProp(100) | %.3f | %.0f ms | %.1f ms | %.1f |\n", likelihood, 1e3 * seconds,
                    1e3 * full, seconds / full);
            fprintf(csv, "peer,%d,%d,libgp,%.6g,%.6g\n", N, M, seconds, full);
            fprintf(md, "| libgp, one gradient; predictions a second | - | %.2f ms; %.0f | - | - |\n", 1e3 * evaluation,
                    rate);
        }
    } else {
        printf("LIBGP_DRIVER is not set: no comparison with libgp\n");
    }
    f = bench_open("gpr_peer.py");
    fputs(sklearn_script, f);
    fclose(f);
    if ((ask("python3 build/bench/gpr_peer.py 2>/dev/null", line, sizeof line) ||
         ask("/usr/bin/python3 build/bench/gpr_peer.py 2>/dev/null", line, sizeof line)) &&
        sscanf(line, "%31s %lf %lf", version, &seconds, &likelihood) == 3) {
        fprintf(md, "| scikit-learn %s, L-BFGS-B | %.3f | %.0f ms | %.1f ms | %.1f |\n", version, likelihood,
                1e3 * seconds, 1e3 * full, seconds / full);
        fprintf(csv, "peer,%d,%d,scikit-learn %s,%.6g,%.6g\n", N, M, version, seconds, full);
    } else {
        printf("scikit-learn was not found: no comparison\n");
    }
    fprintf(md, "| **default of this header (MAP, 3 starts)** | - | %.0f ms | - | - |\n", 1e3 * full);
}

int main(void)
{
    csv = bench_open("gpr.csv");
    md = bench_open("gpr.md");
    fprintf(csv, "what,n,m,setting,value,second\n");
    fprintf(md, "%s, one thread, compiler's -O2, medians; `make bench`.\n", bench_processor());
    bench_likelihood();
    bench_predictions();
    bench_peers();
    bench_taste();
    bench_table_3_2();
    bench_large_fits();
    fclose(csv);
    fclose(md);
    return 0;
}
