/* Recommendation, active learning, latent space and maps of ms_gpr.h: what they cost and how good they are, on
   synthetic users who score 10% of uniform materials above 0. Writes build/bench/gpr_recommend.csv, gpr_recommend.md,
   gpr_recommend.svg (time of 300 recommendations against tau) and gpr_active.svg (divergence against the number of
   scores, for every kind of gallery). */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "users.h"
#include "plane.h"
#include "thesis.h"
#include "json.h"
#include "bench.h"
#include "plot.h"

enum {
    M = 19,
    USERS = 12,
    N = 250,
    COUNT = 300,
    TAUS = 5,
    SEARCHES = 4,
    HELD_OUT = 3000,
    STEPS = 9,
    FIRST = 50,
    STEP = 25,
    KINDS = 3
};

static FILE *csv, *md;

typedef struct member {
    person u;
    double x[N * M], y[N];
    ms_gpr *gp;
} member;

static member members[USERS];

/* --- 300 recommendations --- */

/* Root mean square difference. */
static double distance(const double *a, const double *b)
{
    double sum = 0;
    int k;
    for (k = 0; k < M; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]) / (int)M;
    return sqrt(sum);
}

static void table_of_searches(void)
{
    static const char *const name[SEARCHES] = {"auto", "threshold", "variants",
                                               "hill climbing (thesis), a prediction at a time"};
    static double time[SEARCHES][TAUS], tau[TAUS], worst[SEARCHES][TAUS];
    static plot p;
    int search, t, i, k, j;
    fprintf(
        md,
        "300 recommendations, n = 250, m = 19, medians over %d users who like 10%%; acceptance is that of uniform candidates at\n"
        "the model's threshold; true score: mean u* of the recommended (of 10; uniform materials: 0.4);\n"
        "precision: share of them with u* >= 10 tau.\n\n"
        "| tau | search | time, ms (worst user) | acceptance | true score | precision | mean distance of pairs |\n"
        "|---:|---|---:|---:|---:|---:|---:|\n",
        USERS);
    for (t = 0; t < TAUS; ++t) {
        tau[t] = 0.4 + 0.1 * t;
        for (search = 0; search < SEARCHES; ++search) {
            double ms[USERS], acceptance[USERS], score[USERS], precision[USERS], pairs[USERS];
            int gave_up = 0;
            for (i = 0; i < USERS; ++i) {
                static double x[COUNT * M];
                ms_gpr_recommend_options o;
                ms_gpr_recommend_report report;
                double start;
                memset(&o, 0, sizeof o);
                o.tau = tau[t];
                o.seed = (uint64_t)i;
                o.search = search < 3 ? (ms_gpr_search)search : MS_GPR_SEARCH_THRESHOLD;
                start = bench_cpu();
                if (ms_gpr_recommend(members[i].gp, &o, COUNT, x, NULL, NULL, &report, NULL) != MS_OK) ++gave_up;
                ms[i] = 1e3 * (bench_cpu() - start);
                if (search == 3) { /* the same threshold */
                    double candidates;
                    start = bench_cpu();
                    report.found = thesis_climb(members[i].gp, report.threshold, COUNT, (uint64_t)i, x, &candidates);
                    ms[i] = 1e3 * (bench_cpu() - start);
                    gave_up += report.found < COUNT;
                }
                if (ms[i] > worst[search][t]) worst[search][t] = ms[i];
                acceptance[i] = report.acceptance;
                score[i] = precision[i] = pairs[i] = 0;
                for (k = 0; k < report.found; ++k) {
                    double u = user_true(&members[i].u, x + k * M);
                    score[i] += u / report.found;
                    precision[i] += (u >= 10 * tau[t]) / (double)report.found;
                    for (j = 0; j < k; ++j)
                        pairs[i] += distance(x + k * M, x + j * M) * 2 / (report.found * (report.found - 1.0));
                }
                fprintf(csv, "recommend,%s,%g,%d,%.3f,%g,%g,%g,%g\n", name[search], tau[t], i, ms[i], acceptance[i],
                        score[i], precision[i], pairs[i]);
            }
            time[search][t] = bench_median(ms, USERS);
            fprintf(md, "| %.1f | %s%s%s | %.0f (%.0f%s) | %.2g%% | %.1f | %.0f%% | %.3f |\n", tau[t],
                    search ? "" : "**", name[search], search ? "" : "**", time[search][t], worst[search][t],
                    gave_up ? ", gave up" : "", 100 * bench_median(acceptance, USERS), bench_median(score, USERS),
                    100 * bench_median(precision, USERS), bench_median(pairs, USERS));
        }
    }
    plot_begin(&p, "300 recommendations for users who like 10%", "tau", "milliseconds, one core", PLOT_LOG_Y);
    for (search = 1; search < SEARCHES; ++search)
        plot_series(&p, name[search], tau, time[search], TAUS, PLOT_LINE | PLOT_DOTS);
    plot_series_color(&p, "auto", tau, time[0], TAUS, PLOT_LINE | PLOT_DASHED, "#222");
    plot_write(&p, "build/bench/gpr_recommend.svg");
}

/* --- active learning --- */

static double divergence(const ms_gpr *gp, const double *x, const double *truth)
{
    static double mean[HELD_OUT];
    ms_gpr_predict(gp, x, HELD_OUT, mean, NULL, NULL);
    return user_jsd(mean, truth, HELD_OUT);
}

static void figure_of_galleries(void)
{
    static const char *const name[KINDS] = {"active", "evenly spread", "uniform (thesis)"};
    static double jsd[KINDS][STEPS], n_axis[STEPS], held_out[HELD_OUT * M], truth[HELD_OUT],
        x[(FIRST + STEPS * STEP) * M], y[FIRST + STEPS * STEP];
    static plot p;
    int i, k, step, kind;
    for (i = 0; i < USERS; ++i) {
        const person *u = &members[i].u;
        for (kind = 0; kind < KINDS; ++kind) {
            uint64_t state = 500 + (uint64_t)i;
            double unused[1];
            for (k = 0; k < HELD_OUT; ++k) {
                user_gallery(u, 1, held_out + k * M, unused, &state);
                truth[k] = user_true(u, held_out + k * M);
            }
            user_gallery(u, FIRST, x, y, &state);
            for (step = 0; step < STEPS; ++step) {
                int n = FIRST + step * STEP;
                ms_gpr_gallery_options g;
                ms_gpr *gp;
                double d;
                memset(&g, 0, sizeof g);
                g.seed = (uint64_t)(1000 * i + step);
                if (ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL) != MS_OK) continue;
                d = divergence(gp, held_out, truth);
                if (kind == 1) ms_gpr_destroy(gp); /* one that knows nothing spreads its galleries */
                if (kind == 1 && ms_gpr_fit(NULL, NULL, 0, M, NULL, &gp, NULL, NULL) != MS_OK) continue;
                if (kind == 2) user_gallery(u, STEP, x + n * M, y + n, &state);
                else ms_gpr_gallery(gp, &g, STEP, x + n * M, NULL);
                for (k = n; kind < 2 && k < n + STEP; ++k) y[k] = user_score(u, x + k * M, &state);
                ms_gpr_destroy(gp);
                jsd[kind][step] += d / (int)USERS;
                n_axis[step] = n;
                fprintf(csv, "active,%s,%d,%d,%g\n", name[kind], i, n, d);
            }
        }
    }
    fprintf(
        md,
        "\nActive learning: Jensen-Shannon divergence (nats) to the true preference on %d held-out materials after n scores, a first\n"
        "gallery of %d and then galleries of %d, each scored and concatenated; mean of %d users.\n\n| gallery |",
        HELD_OUT, FIRST, STEP, USERS);
    for (step = 0; step < STEPS; step += 2) fprintf(md, " n = %d |", FIRST + step * STEP);
    fprintf(md, "\n|---|");
    for (step = 0; step < STEPS; step += 2) fprintf(md, "---:|");
    fprintf(md, "\n");
    plot_begin(&p, "Active learning: divergence after n scores", "scores", "Jensen-Shannon divergence, nats", 0);
    for (kind = 0; kind < KINDS; ++kind) {
        fprintf(md, "| %s |", name[kind]);
        for (step = 0; step < STEPS; step += 2) fprintf(md, " %.3f |", jsd[kind][step]);
        fprintf(md, "\n");
        plot_series(&p, name[kind], n_axis, jsd[kind], STEPS, PLOT_LINE | PLOT_DOTS | (kind == 2 ? PLOT_DASHED : 0));
    }
    plot_write(&p, "build/bench/gpr_active.svg");
}

/* Rounds: 150 scores, then 50 recommendations are scored and concatenated, twice. */
static void table_of_rounds_of_scores(void)
{
    static double x[300 * M], y[300], r[COUNT * M];
    int i, k, round;
    double score[3][USERS], precision[3][USERS];
    for (i = 0; i < USERS; ++i) {
        uint64_t state = 900 + (uint64_t)i;
        const person *u = &members[i].u;
        user_gallery(u, 150, x, y, &state);
        for (round = 0; round < 3; ++round) {
            int n = 150 + 50 * round;
            ms_gpr *gp;
            ms_gpr_recommend_options o;
            memset(&o, 0, sizeof o);
            o.seed = (uint64_t)(10 * i + round);
            score[round][i] = precision[round][i] = 0;
            if (ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL) != MS_OK) continue;
            if (ms_gpr_recommend(gp, &o, COUNT, r, NULL, NULL, NULL, NULL) == MS_OK)
                for (k = 0; k < COUNT; ++k) {
                    double t = user_true(u, r + k * M);
                    score[round][i] += t / (int)COUNT;
                    precision[round][i] += (t >= 6) / (double)COUNT;
                }
            memcpy(x + n * M, r, 50 * M * sizeof *x);
            for (k = n; k < n + 50; ++k) y[k] = user_score(u, x + k * M, &state);
            ms_gpr_destroy(gp);
        }
    }
    fprintf(
        md,
        "\nRounds: 150 uniform scores, then 50 recommendations (tau 0.6) are scored and concatenated, twice; medians over %d users.\n\n"
        "| round | scores | true score of 300 recommendations | precision (u* >= 6) |\n|---:|---:|---:|---:|\n",
        USERS);
    for (round = 0; round < 3; ++round) {
        double middle = bench_median(score[round], USERS), share = bench_median(precision[round], USERS);
        fprintf(csv, "rounds,%d,%g,%g\n", round + 1, middle, share);
        fprintf(md, "| %d | %d | %.1f | %.0f%% |\n", round + 1, 150 + 50 * round, middle, 100 * share);
    }
}

/* --- latent space and maps --- */

typedef struct latent_run {
    const double *x;
    int z;
    ms_simd simd;
    ms_gpr_latent *plane;
    ms_gpr_latent_report report;
    const ms_gpr *gp;
    map_grid grid;
    double *map;
    ms_error error;
} latent_run;

static void run_fit(void *context)
{
    latent_run *r = (latent_run *)context;
    ms_gpr_latent_options o;
    memset(&o, 0, sizeof o);
    o.simd = r->simd;
    ms_gpr_latent_destroy(r->plane);
    ms_gpr_latent_fit(r->x, r->z, M, &o, &r->plane, &r->report, NULL);
}

static void run_map(void *context)
{
    latent_run *r = (latent_run *)context;
    double x[M];
    int i;
    for (i = 0; i < 1000; ++i) ms_gpr_latent_map(r->plane, ms_gpr_latent_view_of(r->plane).points, 1, x, NULL, NULL);
}

static void run_preference(void *context)
{
    latent_run *r = (latent_run *)context;
    map_preference(r->plane, r->gp, &r->grid, r->map, &r->error);
}

static void run_confidence(void *context)
{
    latent_run *r = (latent_run *)context;
    map_confidence(r->plane, &r->grid, r->map, &r->error);
}

static void table_of_planes(void)
{
    json *problems = json_load("tests/data/gplvm_problems.json"), *data = json_load("tests/data/gplvm_data.json");
    static const char *const name[] = {"clusters16", "clusters48", "circle60"};
    static double map[50 * 50];
    static const struct {
        const char *what;
        void (*run)(void *);
        double unit;
    } task[] = {{"material of a latent point", run_map, 1e3},
                {"preference map 50 x 50 (thesis: 2.75 s)", run_preference, 1e6},
                {"confidence map 50 x 50", run_confidence, 1e6}};
    enum { TASKS = (int)(sizeof task / sizeof task[0]) };
    double microseconds[TASKS];
    latent_run r;
    int set, i, k;
    memset(&r, 0, sizeof r);
    fprintf(
        md,
        "\nLatent plane, 19 dimensions (thesis: 16 materials in 1.96 s). Best of 20 starts: L-BFGS-B of SciPy from two kinds of components,\n"
        "5 scales and 2 noises.\n\n| materials | log likelihood | given | best of 20 starts | evaluations | ms | ms without SIMD |\n|---|---:|---:|---:|---:|---:|---:|\n");
    for (set = 0; set < 3; ++set) {
        static const double best[] = {434.790, 1992.102, 2506.779};
        const json *d = set == 0 ? json_get(&problems->child[0], "X") : json_get(json_get(data, name[set]), "X");
        double *x = (double *)malloc((size_t)d->count * M * sizeof *x),
               given = set == 1 ? 0 : json_number(json_get(&problems->child[set / 2], "ll"));
        bench_time fast, scalar;
        for (i = 0; i < d->count; ++i)
            for (k = 0; k < M; ++k) x[i * M + k] = d->child[i].child[k].number;
        r.x = x;
        r.z = d->count;
        r.simd = MS_SIMD_SCALAR;
        scalar = bench_run(run_fit, &r, 9);
        r.simd = MS_SIMD_AUTO;
        fast = bench_run(run_fit, &r, 9);
        fprintf(md, "| %s | %.1f | ", name[set], r.report.likelihood);
        if (set == 1) fprintf(md, "| ");
        else fprintf(md, "%.1f | ", given);
        fprintf(md, "%.1f | %d | %.1f | %.1f |\n", best[set], r.report.evaluations, 1e3 * fast.median,
                1e3 * scalar.median);
        fprintf(csv, "latent,%s,%g,%d,%g,%g\n", name[set], r.report.likelihood, r.report.evaluations, fast.median,
                scalar.median);
        if (set == 1) {
            r.gp = members[0].gp;
            r.grid = map_around(r.plane, 50);
            r.map = map;
            for (i = 0; i < TASKS; ++i) microseconds[i] = task[i].unit * bench_run(task[i].run, &r, 21).median;
        }
        free(x);
    }
    fprintf(md, "\nOn the plane of 48 materials, model of n = 250, m = 19:\n\n| | microseconds |\n|---|---:|\n");
    for (i = 0; i < TASKS; ++i) {
        fprintf(md, microseconds[i] < 100 ? "| %s | %.2f |\n" : "| %s | %.0f |\n", task[i].what, microseconds[i]);
        fprintf(csv, "plane,%s,%g\n", task[i].what, 1e-6 * microseconds[i]);
    }
    ms_gpr_latent_destroy(r.plane);
    json_free(problems);
    json_free(data);
}

int main(void)
{
    int i;
    csv = bench_open("gpr_recommend.csv");
    md = bench_open("gpr_recommend.md");
    for (i = 0; i < USERS; ++i) {
        uint64_t state = 100 + (uint64_t)i;
        members[i].u = user_make((uint64_t)i + 1, M, 0.10);
        user_gallery(&members[i].u, N, members[i].x, members[i].y, &state);
        if (ms_gpr_fit(members[i].x, members[i].y, N, M, NULL, &members[i].gp, NULL, NULL) != MS_OK) return 1;
    }
    fprintf(md, "%s, one thread, %s.\n\n", bench_processor(), ms_simd_string(ms_gpr_view_of(members[0].gp).level));
    table_of_searches();
    figure_of_galleries();
    table_of_rounds_of_scores();
    table_of_planes();
    for (i = 0; i < USERS; ++i) ms_gpr_destroy(members[i].gp);
    fclose(csv);
    return fclose(md) != 0;
}
