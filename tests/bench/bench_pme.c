/* ms_pme.h on edited pictures, with the networks and held-out materials of examples/data: the tables of the thesis's
   chapter 4, times, and what pictures tell about parameters. About three minutes. bench_pme --full gives basin hopping
   a minute for every target instead of 0.3 s (40 minutes); --times, --minima, --edits,
   --sequence, --recovery, --targets, --optimizers and --bounds make one table alone, --known searches the least RMSE of
   the targets of targets.h (half an hour, into build/bench/pme_targets.csv). Writes pme.md, pme_minima.md,
   pme_targets.md, pme_optimizers.md, pme_sequence.md, pme_time.md, pme_recovery.md, pme_edits.md, pme_bounds.md,
   pme.csv and pme.svg. RMSE in levels of 255. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "bench.h"
#include "nets.h"
#include "matcher.h"
#include "materials.h"
#include "edits.h"
#include "plot.h"
#include "targets.h"
#include "thesis_methods.h"

enum { TARGETS = 30, N = 19, RUNS = 9 };

typedef struct target {
    const char *name;
    float *planes;           /* [3][size][size] */
    double random[N], nn[N]; /* the two starts: a random material, the best of the inversion networks */
    double random_rmse, nn_rmse;
} target;

static int full;
static materials held_out;
static image sheet;

static void check(ms_status status, const ms_error *error)
{
    if (status == MS_OK) return;
    fprintf(stderr, "bench_pme: %s\n", error->message);
    exit(1);
}

static void check_picture(const char *problem)
{
    if (problem == NULL) return;
    fprintf(stderr, "bench_pme: %s\n", problem);
    exit(1);
}

static void aim(matcher *m, const float *planes)
{
    ms_error error;
    check(matcher_aim(m, planes, NULL, &error), &error);
}

/* Edit i of material `source`, with material `other` as the second picture, as planes. */
static float *edited(const matcher *m, const edit *e, int source, int other)
{
    float *planes = (float *)malloc(m->renderer.image_size * sizeof(float));
    image a, b, c;
    check_picture(edit_tile(&sheet, source, m->network.size, &a));
    check_picture(edit_tile(&sheet, other, m->network.size, &b));
    if (planes == NULL || !edit_apply(e, &a, &b, &c)) check_picture("out of memory");
    neural_planes(&c, planes);
    image_free(&a);
    image_free(&b);
    image_free(&c);
    return planes;
}

typedef enum how {
    OURS,  /* collapsed objective, Jacobian, projection */
    THESIS /* the picture in floats, differences of 1.5e-8, an infinite barrier */
} how;

enum { LM = -1 }; /* the library's own method, beside thesis_methods.h's */

/* The RMSE of picture and target, for the methods of the thesis. */
typedef struct plain_picture {
    const matcher *m;
    const float *target;
    float *picture;
} plain_picture;

static ms_status plain_residual(void *user, const double *x, double *r, double *jacobian)
{
    const plain_picture *p = (const plain_picture *)user;
    size_t i, count = p->m->renderer.image_size;
    ms_status status = p->m->renderer.render(p->m->renderer.user, x, p->picture);
    (void)jacobian;
    for (i = 0, *r = 0; i < count; ++i)
        *r += ((double)p->picture[i] - (double)p->target[i]) * ((double)p->picture[i] - (double)p->target[i]) /
            (double)count;
    *r = sqrt(*r);
    return status;
}

/* One refinement from a start: its RMSE of 1, and x unless out is NULL (which may be start). */
static double refine(const matcher *m, const float *planes, const double *start, int method, double cost, how h,
                     double *out)
{
    static const double zero[N] = {0}, one[N] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    ms_pme_renderer renderer = m->renderer;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    double x[N];
    renderer.prediction_count = 0;
    options.candidates = start;
    options.candidate_count = 1;
    options.refine.max_cost = cost;
    if (method != LM) {
        thesis_options o = {0, 0, 0, 0, 0, 0};
        ms_pme_function f = m->reduced;
        plain_picture p;
        o.method = method;
        o.max_cost = cost;
        if (h == THESIS) {
            memset(&f, 0, sizeof f);
            p.m = m;
            p.target = planes;
            p.picture = (float *)malloc(renderer.image_size * sizeof(float));
            if (p.picture == NULL) check_picture("out of memory");
            f.user = &p;
            f.parameter_count = N;
            f.residual_count = 1;
            f.residuals = plain_residual;
            f.residuals_only = 1;
            o.barrier = 1;
            o.difference_step = 1.5e-8;
        }
        f.lower = zero;
        f.upper = one;
        memcpy(x, start, sizeof x);
        check(thesis_minimize(&f, &o, x, NULL), &error);
        if (h == THESIS) free(p.picture);
        options.candidates = x;
        options.initial_only = 1;
    }
    check(ms_pme_match(&renderer, planes, NULL, &options, x, NULL, &result, &error), &error);
    if (out) memcpy(out, x, sizeof x);
    return result.rmse;
}

/* The best inversion network's answer. */
static double guess(const matcher *m, const target *t, double x[N])
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    options.initial_only = 1;
    check(ms_pme_match(&m->renderer, t->planes, NULL, &options, x, NULL, &result, &error), &error);
    return 255 * result.rmse;
}

/* That, and the other start. */
static void starts(const matcher *m, target *t, int index)
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    ms_pme_renderer renderer = m->renderer;
    t->nn_rmse = guess(m, t, t->nn);
    renderer.prediction_count = 0;
    options.initial_only = 1;
    options.random_count = 1;
    options.refine.seed = (uint64_t)index;
    check(ms_pme_match(&renderer, t->planes, NULL, &options, t->random, NULL, &result, &error), &error);
    t->random_rmse = 255 * result.rmse;
}

/* --- Table 4.1, and basin hopping --- */

enum {
    OPTIMIZER_50,
    OPTIMIZER_300,
    OPTIMIZER_1500,
    HYBRID_50,
    HYBRID_300,
    HYBRID_1500,
    OURS_50,
    OURS_300,
    OURS_1500,
    HOPPING,
    COLUMNS
};

/* The library as a user calls it: all first guesses, restarts from the others where cost is left. */
static double ours(const matcher *m, const target *t, double cost)
{
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    double x[N];
    options.refine.max_cost = cost;
    options.refine.restarts = 1000;
    check(ms_pme_match(&m->renderer, t->planes, NULL, &options, x, NULL, &result, &error), &error);
    return 255 * result.rmse;
}

/* The collapsed objective in the box of the parameters. */
static ms_pme_function boxed(const matcher *m)
{
    static const double zero[N] = {0}, one[N] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    ms_pme_function f = m->reduced;
    f.lower = zero;
    f.upper = one;
    return f;
}

static double hop(const matcher *m, const target *t)
{
    ms_pme_function f = boxed(m);
    double x[N];
    memcpy(x, t->nn, sizeof x);
    return 255 * sqrt(thesis_basin_hopping(&f, x, full ? 60000 : 3000, 0) / (double)m->renderer.image_size);
}

static void table_targets(matcher *m, target *targets)
{
    static const double budget[3] = {50, 300, 1500};
    static double rmse[TARGETS][COLUMNS], x_axis[3], y_axis[3][3];
    static plot p;
    static double ms[COLUMNS][TARGETS],
        guess_ms[TARGETS]; /* thread time; the guesses' is a part of all but the optimizer's */
    FILE *f = bench_open("pme_targets.md"), *csv = bench_open("pme.csv"), *summary = bench_open("pme.md");
    int t, b, k, no_worse = 0, hopping[2] = {0, 0};
    for (t = 0; t < TARGETS; ++t) {
        target *to = &targets[t];
        double *row = rmse[t], x[N], clock = bench_cpu();
        aim(m, to->planes);
        guess(m, to, x);
        guess_ms[t] = 1e3 * (bench_cpu() - clock);
        for (k = 0; k < COLUMNS; ++k) {
            b = k % 3;
            clock = bench_cpu();
            if (k < HYBRID_50)
                row[k] = 255 * refine(m, to->planes, to->random, THESIS_NELDER_MEAD_BARRIER, budget[b], OURS, NULL);
            else if (k < OURS_50)
                row[k] = 255 * refine(m, to->planes, to->nn, THESIS_NELDER_MEAD_BARRIER, budget[b], OURS, NULL);
            else if (k < HOPPING) row[k] = ours(m, to, budget[b]);
            else row[k] = hop(m, to);
            ms[k][t] = 1e3 * (bench_cpu() - clock) + (k < OURS_50 || k == HOPPING ? guess_ms[t] : 0);
        }
        no_worse += row[OURS_50] <= row[HYBRID_1500];
        hopping[0] += row[OURS_50] <= 1.01 * row[HOPPING];
        hopping[1] += row[OURS_1500] <= 1.01 * row[HOPPING];
    }
    fprintf(
        f,
        "Table 4.1 on %d edited pictures of held-out materials, 64 x 64, RMSE in levels of 255 after 50 / 300 / 1500 units of cost (pictures by the\n"
        "network; a Jacobian counts 5). Optimizer and hybrid: Nelder-Mead with a barrier, as in the thesis. `make bench FILTER=pme`\n\n"
        "| edit | random | best of 9 | optimizer | hybrid | ours | basin hopping, %s |\n|---|---:|---:|---:|---:|---:|---:|\n",
        TARGETS, full ? "60 s" : "0.3 s");
    fprintf(
        csv,
        "edit,random,best_of_9,optimizer_50,optimizer_300,optimizer_1500,hybrid_50,hybrid_300,hybrid_1500,ours_50,ours_300,ours_1500,hopping\n");
    for (t = 0; t < TARGETS; ++t) {
        const double *r = rmse[t];
        fprintf(f, "| %s | %.2f | %.2f | %.2f / %.2f / %.2f | %.2f / %.2f / %.2f | %.2f / %.2f / %.2f | %.2f |\n",
                targets[t].name, targets[t].random_rmse, targets[t].nn_rmse, r[0], r[1], r[2], r[3], r[4], r[5], r[6],
                r[7], r[8], r[9]);
        fprintf(csv, "%s,%g,%g", targets[t].name, targets[t].random_rmse, targets[t].nn_rmse);
        for (k = 0; k < COLUMNS; ++k) fprintf(csv, ",%g", r[k]);
        fprintf(csv, "\n");
    }
    fprintf(
        summary,
        "Edited 64 x 64 pictures of held-out materials, RMSE in levels of 255, means of three targets, one core of %s, `make bench FILTER=pme`.\n"
        "After 50 pictures' worth of work ours is no worse than the thesis's hybrid after 1500 on %d of %d targets, and within 1%% of basin\n"
        "hopping (%s a target) on %d, after 1500 on %d.\n\n"
        "| edit | random start | best of 9 networks | thesis: optimizer, 1500 | thesis: hybrid, 1500 | **ours, 50** | ours, 1500 | basin hopping |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|\n",
        bench_processor(), no_worse, TARGETS, full ? "60 s" : "0.3 s", hopping[0], hopping[1]);
    for (k = 0; k < EDIT_COUNT; ++k) {
        double mean[COLUMNS] = {0}, random = 0, nn = 0;
        for (t = k; t < TARGETS; t += EDIT_COUNT) {
            random += targets[t].random_rmse / 3;
            nn += targets[t].nn_rmse / 3;
            for (b = 0; b < COLUMNS; ++b) mean[b] += rmse[t][b] / 3;
        }
        fprintf(summary, "| %s | %.1f | %.1f | %.2f | %.2f | **%.2f** | %.2f | %.2f |\n", edits[k].name, random, nn,
                mean[OPTIMIZER_1500], mean[HYBRID_1500], mean[OURS_50], mean[OURS_1500], mean[HOPPING]);
    }
    fprintf(summary, "| *time, ms, median* | | %.1f | %.0f | %.0f | %.1f | %.0f | %.0f |\n",
            bench_median(guess_ms, TARGETS), bench_median(ms[OPTIMIZER_1500], TARGETS),
            bench_median(ms[HYBRID_1500], TARGETS), bench_median(ms[OURS_50], TARGETS),
            bench_median(ms[OURS_1500], TARGETS), bench_median(ms[HOPPING], TARGETS));
    plot_begin(&p, "Edited pictures: RMSE, times basin hopping's, geometric means of 30", "pictures by the network", "",
               PLOT_LOG_X | PLOT_LOG_Y);
    for (b = 0; b < 3; ++b) {
        x_axis[b] = budget[b];
        for (k = 0; k < 3; ++k) {
            double sum = 0;
            for (t = 0; t < TARGETS; ++t) sum += log(rmse[t][3 * k + b] / rmse[t][HOPPING]);
            y_axis[k][b] = exp(sum / (int)TARGETS);
        }
    }
    plot_series(&p, "thesis: optimizer", x_axis, y_axis[0], 3, PLOT_LINE | PLOT_DOTS);
    plot_series(&p, "thesis: hybrid", x_axis, y_axis[1], 3, PLOT_LINE | PLOT_DOTS);
    plot_series(&p, "ours", x_axis, y_axis[2], 3, PLOT_LINE | PLOT_DOTS);
    plot_write(&p, "build/bench/pme.svg");
    fclose(f);
    fclose(csv);
    fclose(summary);
    printf(
        "Table 4.1: ours after 50 no worse than the hybrid after 1500 on %d of %d, within 1%% of basin hopping on %d, after 1500 on %d\n",
        no_worse, TARGETS, hopping[0], hopping[1]);
}

/* --- Table 4.3: what the optimizers make of float32 differences and a barrier, and what they are otherwise --- */

static void table_optimizers(matcher *m, target *targets)
{
    static const struct {
        const char *name;
        int method;
        how h;
    } column[] = {{"Nelder-Mead", THESIS_NELDER_MEAD_BARRIER, THESIS},
                  {"L-BFGS", THESIS_LBFGS, THESIS},
                  {"SQP", THESIS_SQP, THESIS},
                  {"CG", THESIS_CONJUGATE_GRADIENT, THESIS},
                  {"Nelder-Mead", THESIS_NELDER_MEAD, OURS},
                  {"L-BFGS", THESIS_LBFGS, OURS},
                  {"SQP", THESIS_SQP, OURS},
                  {"CG", THESIS_CONJUGATE_GRADIENT, OURS},
                  {"**LM**", LM, OURS}};
    enum { METHODS = 9 };
    FILE *f = bench_open("pme_optimizers.md");
    int t, s, k, stuck[METHODS] = {0};
    fprintf(
        f,
        "Table 4.3: RMSE after at most 1500 units of cost. First four: as in the thesis, an infinite barrier and differences of 1.5e-8 on\n"
        "pictures of float32, whose rounding (6e-8 of a value) is larger than what such a step changes: the gradient is noise. The others: the same\n"
        "methods with projection and exact Jacobians. Italics: not 1%% better than the start. `make bench FILTER=pme`\n\n| edit | start | RMSE");
    for (k = 0; k < METHODS; ++k) fprintf(f, " | %s%s", column[k].name, column[k].h == THESIS ? ", thesis" : "");
    fprintf(f, " |\n|---|---|---:");
    for (k = 0; k < METHODS; ++k) fprintf(f, "|---:");
    fprintf(f, "|\n");
    for (t = 0; t < EDIT_COUNT; ++t) {
        aim(m, targets[t].planes);
        for (s = 0; s < 2; ++s) {
            double before = s ? targets[t].nn_rmse : targets[t].random_rmse;
            fprintf(f, "| %s | %s | %.2f", targets[t].name, s ? "NN" : "random", before);
            for (k = 0; k < METHODS; ++k) {
                double after = 255 *
                    refine(m, targets[t].planes, s ? targets[t].nn : targets[t].random, column[k].method, 1500,
                           column[k].h, NULL);
                int same = after > 0.99 * before;
                stuck[k] += same;
                fprintf(f, same ? " | *%.2f*" : " | %.2f", after);
            }
            fprintf(f, " |\n");
        }
    }
    fprintf(f, "| stuck | of %d | ", 2 * EDIT_COUNT);
    for (k = 0; k < METHODS; ++k) fprintf(f, " | %d", stuck[k]);
    fprintf(f, " |\n");
    fclose(f);
    printf(
        "Table 4.3: stuck at the start, of %d: L-BFGS %d, SQP %d, CG %d with the thesis's differences; %d, %d, %d with Jacobians\n",
        2 * EDIT_COUNT, stuck[1], stuck[2], stuck[3], stuck[5], stuck[6], stuck[7]);
}

/* --- Table 4.2: a sequence of 300 frames, the black level rising --- */

static void table_sequence(matcher *m)
{
    static const struct {
        const char *name;
        int method;
        double cost;
    } row[] = {{"Nelder-Mead, 100", THESIS_NELDER_MEAD_BARRIER, 100},
               {"Nelder-Mead, 300", THESIS_NELDER_MEAD_BARRIER, 300},
               {"Nelder-Mead, 600", THESIS_NELDER_MEAD_BARRIER, 600},
               {"**ours, 20**", LM, 20}};
    enum { FRAMES = 300, ROWS = 4 };
    static double rmse[ROWS][2][FRAMES], seconds[2][FRAMES];
    double previous[N], x[N], from;
    float *source = edited(m, &edits[0], 40, 40), *planes = (float *)malloc(m->renderer.image_size * sizeof(float));
    FILE *f = bench_open("pme_sequence.md");
    ms_error error;
    int frame, k, again, i;
    if (planes == NULL) check_picture("out of memory");
    for (k = 0; k < ROWS; ++k)
        for (again = 0; again < 2; ++again)
            for (frame = 0; frame < FRAMES; ++frame) {
                ms_pme_match_options options = ms_pme_match_defaults();
                ms_pme_match_result result;
                float black = 0.3f * (float)frame / (FRAMES - 1);
                size_t p;
                for (p = 0; p < m->renderer.image_size; ++p) planes[p] = black + (1 - black) * source[p];
                options.refine.max_cost = row[k].cost;
                options.initial_only = row[k].method != LM;
                options.candidates = previous;
                options.candidate_count = again && frame > 0;
                from = bench_cpu();
                aim(m, planes);
                check(ms_pme_match(&m->renderer, planes, NULL, &options, x, NULL, &result, &error), &error);
                if (row[k].method != LM) result.rmse = refine(m, planes, x, row[k].method, row[k].cost, OURS, x);
                if (k == ROWS - 1) seconds[again][frame] = bench_cpu() - from;
                rmse[k][again][frame] = 255 * result.rmse;
                memcpy(previous, x, sizeof x);
            }
    fprintf(
        f,
        "Table 4.2: the black level of an unedited picture rises from 0 to 0.3 over 300 frames, 64 x 64; RMSE of frames, mean of all, with and\n"
        "without the last frame's answer among the candidates. `make bench FILTER=pme`\n\n| units a frame | reinitialized");
    for (i = 0; i <= 10; ++i) fprintf(f, " | %d", i * 299 / 10);
    fprintf(f, " | mean |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < ROWS; ++k)
        for (again = 0; again < 2; ++again) {
            double mean = 0;
            fprintf(f, "| %s | %s", row[k].name, again ? "yes" : "no");
            for (i = 0; i <= 10; ++i) fprintf(f, " | %.2f", rmse[k][again][i * 299 / 10]);
            for (frame = 0; frame < FRAMES; ++frame) mean += rmse[k][again][frame] / (int)FRAMES;
            fprintf(f, " | %.3f |\n", mean);
            printf("Table 4.2: %s, %s: mean RMSE %.3f\n", row[k].name, again ? "reinitialized" : "from scratch", mean);
        }
    from = bench_median(seconds[1], FRAMES);
    fprintf(
        f,
        "\nOurs takes %.1f ms a frame (median; slowest %.1f): %.0f frames a second with the target, 9 inversion networks and 20 units.\n",
        1e3 * from, 1e3 * seconds[1][FRAMES - 1], 1 / from);
    free(source);
    free(planes);
    printf("sequence: %.1f ms a frame, %.0f frames a second\n", 1e3 * from, 1 / from);
    fclose(f);
}

/* --- the right minimum: targets against long global searches --- */

/* tests/data/pme_targets.csv anew: the least of four runs of 20,000 units each, three with restarts and one of basin
   hopping. */
static void search_globally(matcher *m)
{
    FILE *f = bench_open("pme_targets.csv");
    float *planes = (float *)malloc(m->renderer.image_size * sizeof(float));
    int t, run;
    if (planes == NULL) check_picture("out of memory");
    fprintf(f, "edit,rmse\n");
    for (t = 0; t < TARGETS_ALL; ++t) {
        double least = 1e9;
        check_picture(targets_make(&sheet, t, planes));
        aim(m, planes);
        for (run = 0; run < 4; ++run) {
            ms_pme_match_options options = ms_pme_match_defaults();
            ms_pme_match_result result;
            ms_error error;
            double x[N];
            options.refine.max_cost = 20000;
            options.refine.restarts = 1000000;
            options.refine.seed = (uint64_t)run;
            options.random_count = 20 * run;
            options.initial_only = run == 3;
            check(ms_pme_match(&m->renderer, planes, NULL, &options, x, NULL, &result, &error), &error);
            if (run == 3) {
                ms_pme_function function = boxed(m);
                result.rmse = sqrt(thesis_basin_hopping(&function, x, 20000, 3) / (double)m->renderer.image_size);
            }
            least = fmin(least, 255 * result.rmse);
        }
        fprintf(f, "%s,%.4f\n", targets_name(t), least);
        fflush(f);
    }
    fclose(f);
    free(planes);
}

static void table_minima(matcher *m)
{
    static const double budget[] = {50, 100, 300, 1000};
    static float planes[3 * TARGETS_SIZE * TARGETS_SIZE];
    FILE *f = bench_open("pme_minima.md"), *known = fopen("tests/data/pme_targets.csv", "r");
    char line[100];
    double least[TARGETS_ALL], ms[TARGETS_ALL], x[N];
    int t, b, number;
    if (known == NULL || fgets(line, sizeof line, known) == NULL)
        check_picture("tests/data/pme_targets.csv cannot be read");
    for (t = 0; t < TARGETS_ALL; ++t)
        least[t] = fgets(line, sizeof line, known) && strchr(line, ',') ? strtod(strchr(line, ',') + 1, NULL) : 0;
    fclose(known);
    fprintf(
        f,
        "Edited pictures, 64 x 64 (tests/bench/targets.h), with restarts: how many end within 1%% of the least RMSE of four searches of\n"
        "20,000 units each. Ours: the 23 edits of examples/demo/edits.h; others: twelve kinds whose place, strength and color are random; and\n"
        "each again with other materials and seeds, for a check. Means of the RMSE over the least of all; median thread time of target, first\n"
        "guesses and match, one core of %s. `make bench FILTER=pme`\n\n"
        "| units | ours | check | others | check | RMSE over the least: ours | others | ms |\n"
        "|---:|---:|---:|---:|---:|---:|---:|---:|\n",
        bench_processor());
    for (b = 0; b < 4; ++b) {
        int within[TARGETS_SETS] = {0}, k, set;
        double mean[2] = {0, 0};
        for (t = 0; t < TARGETS_ALL; ++t) {
            ms_pme_match_options options = ms_pme_match_defaults();
            ms_pme_match_result result;
            ms_error error;
            double from;
            set = targets_set(t, &number);
            check_picture(targets_make(&sheet, t, planes));
            options.refine.max_cost = budget[b];
            options.refine.restarts = 1000;
            from = bench_cpu();
            aim(m, planes);
            check(ms_pme_match(&m->renderer, planes, NULL, &options, x, NULL, &result, &error), &error);
            ms[t] = 1e3 * (bench_cpu() - from);
            within[set] += 255 * result.rmse <= 1.01 * least[t];
            mean[set / 2] += 255 * result.rmse / least[t] / (2 * targets_count[set]);
        }
        fprintf(f, "| %.0f", budget[b]);
        printf("minima: %.0f units: within 1%% on", budget[b]);
        for (k = 0; k < TARGETS_SETS; ++k) {
            fprintf(f, " | %d of %d", within[k], targets_count[k]);
            printf(" %d of %d,", within[k], targets_count[k]);
        }
        fprintf(f, " | %.4f | %.4f | %.1f |\n", mean[0], mean[1], bench_median(ms, TARGETS_ALL));
        printf(" %.1f ms\n", bench_median(ms, TARGETS_ALL));
    }
    fclose(f);
}

/* --- many active bounds --- */

/* |A x - b| of `rows` and N_MANY parameters; nearby columns of A differ by little if it is correlated. */
enum { N_MANY = 256, ROWS_MANY = 400 };
typedef struct linear {
    double a[ROWS_MANY][N_MANY], b[ROWS_MANY];
} linear;

static ms_status linear_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const linear *l = (const linear *)user;
    int i, j;
    for (i = 0; i < ROWS_MANY; ++i) {
        r[i] = -l->b[i];
        for (j = 0; j < N_MANY; ++j) r[i] += l->a[i][j] * x[j];
    }
    if (jacobian != NULL) memcpy(jacobian, l->a, sizeof l->a);
    return MS_OK;
}

/* The box cuts off most parameters: how long each method takes to which value, in evaluations and in seconds. */
static double normal(uint64_t *state)
{
    double sum = 0;
    int i;
    for (i = 0; i < 12; ++i) {
        *state = *state * 6364136223846793005u + 1442695040888963407u;
        sum += (double)(*state >> 11) / 9007199254740992.0;
    }
    return sum - 6;
}

static void table_bounds(void)
{
    static const struct {
        const char *name;
        int method;
    } row[] = {{"**ours**", LM}, {"L-BFGS, projected", THESIS_LBFGS}};
    enum { KINDS = 4, METHODS = 2 };
    static const char *const kind[KINDS] = {"independent columns, box of 1", "independent columns, box of 0.2",
                                            "correlated columns, box of 1", "correlated columns, box of 0.01"};
    static const double reach[KINDS] = {1, 0.2, 1, 0.01};
    static linear l;
    FILE *f = bench_open("pme_bounds.md");
    int k, method, run, i, j, q;
    fprintf(
        f,
        "Least squares of %d residuals and %d parameters whose box cuts most of them off; callbacks that cost next to nothing. Each method\n"
        "from 0 with at most 5,000 units; value over the least of the row; medians of %d, one core of %s. `make bench FILTER=pme`\n\n"
        "| problem | at bounds | method | value | units | ms |\n|---|---:|---|---:|---:|---:|\n",
        ROWS_MANY, N_MANY, RUNS, bench_processor());
    for (k = 0; k < KINDS; ++k) {
        uint64_t state = (uint64_t)k + 1;
        double x[N_MANY], low[N_MANY], high[N_MANY], value[METHODS], ms[METHODS][RUNS], least;
        int at_bounds = 0;
        ms_pme_result result[METHODS];
        for (i = 0; i < ROWS_MANY; ++i) {
            double common[8];
            for (q = 0; q < 8; ++q) common[q] = normal(&state);
            for (j = 0; j < N_MANY; ++j) {
                l.a[i][j] = normal(&state);
                for (q = 0; q < 8 && k >= 2; ++q) l.a[i][j] += 1e4 * common[q] * sin(0.37 * j * (q + 1) + q);
            }
            l.b[i] = (k >= 2 ? 4e5 : 40) * normal(&state);
        }
        for (j = 0; j < N_MANY; ++j) {
            high[j] = reach[k] * (j % 3 ? 1 : 0.5);
            low[j] = -reach[k];
        }
        for (run = 0; run < RUNS; ++run)
            for (method = 0; method < METHODS; ++method) {
                ms_pme_function function;
                ms_error error;
                double from = bench_cpu();
                memset(&function, 0, sizeof function);
                memset(x, 0, sizeof x);
                memset(&result[method], 0, sizeof result[method]);
                function.user = &l;
                function.parameter_count = N_MANY;
                function.residual_count = ROWS_MANY;
                function.residuals = linear_residuals;
                function.lower = low;
                function.upper = high;
                function.jacobian_cost = 2; /* a copy */
                if (row[method].method == LM) {
                    ms_pme_options options = ms_pme_defaults();
                    options.max_cost = 5000;
                    check(ms_pme_minimize(&function, &options, x, &result[method], &error), &error);
                } else {
                    thesis_options options = {0, 0, 0, 0, 0, 0};
                    options.method = row[method].method;
                    options.max_cost = 5000;
                    check(thesis_minimize(&function, &options, x, &result[method]), &error);
                }
                ms[method][run] = 1e3 * (bench_cpu() - from);
                value[method] = result[method].value;
                for (j = 0; j < N_MANY && method == 0 && run == 0; ++j) at_bounds += x[j] <= low[j] || x[j] >= high[j];
            }
        for (least = value[0], method = 1; method < METHODS; ++method) least = fmin(least, value[method]);
        for (method = 0; method < METHODS; ++method) {
            if (method == 0) fprintf(f, "| %s | %d of %d |", kind[k], at_bounds, N_MANY);
            fprintf(f, "%s %s | %.6f | %.0f | %.0f |\n", method ? "| | |" : "", row[method].name, value[method] / least,
                    result[method].cost, bench_median(ms[method], RUNS));
            printf("bounds: %s, %d at bounds, %s: value %.6f of the least, %.0f units, %.1f ms\n", kind[k], at_bounds,
                   row[method].name, value[method] / least, result[method].cost, bench_median(ms[method], RUNS));
        }
    }
    fclose(f);
}

/* --- times --- */

/* Median over the targets of the whole match at its defaults, as a user calls it; masked: each target with a soft
   selection of its own around the ball. */
static void time_matches(FILE *f, matcher *m, target *targets, int masked)
{
    static float masks[3 * 128 * 128];
    const float *weight = masked ? masks : NULL;
    double whole[TARGETS], first[TARGETS], aims[TARGETS], worst = 0, from, x[N];
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    int t;
    for (t = 0; t < TARGETS; ++t) {
        float *planes = targets[t].planes;
        image selected;
        int i, size = m->network.size;
        selected.width = selected.height = size;
        for (i = 0; i < 3 * size * size; ++i)
            masks[i] = edit_ball(&selected, i % size, i / size % size, -0.002f * (float)t, 0);
        from = bench_cpu();
        check(matcher_aim(m, planes, weight, &error), &error);
        aims[t] = bench_cpu() - from;
        options.initial_only = 1;
        from = bench_cpu();
        check(ms_pme_match(&m->renderer, planes, weight, &options, x, NULL, &result, &error), &error);
        first[t] = bench_cpu() - from;
        options.initial_only = 0;
        from = bench_cpu();
        check(ms_pme_match(&m->renderer, planes, weight, &options, x, NULL, &result, &error), &error);
        whole[t] = bench_cpu() - from + aims[t];
        worst = fmax(worst, whole[t]);
    }
    fprintf(f, "| %d x %d, shared channels%s | %.1f | %.1f | **%.1f** | %.1f |\n", m->network.size, m->network.size,
            masked ? ", a mask each" : "", 1e3 * bench_median(aims, TARGETS), 1e3 * bench_median(first, TARGETS),
            1e3 * bench_median(whole, TARGETS), 1e3 * worst);
    printf("%d x %d%s: %.1f ms a match (slowest %.1f), of it %.1f the target, %.1f the first guesses\n",
           m->network.size, m->network.size, masked ? " masked" : "", 1e3 * bench_median(whole, TARGETS), 1e3 * worst,
           1e3 * bench_median(aims, TARGETS), 1e3 * bench_median(first, TARGETS));
}

/* The thesis's renderer with random weights in int8, as a file. */
static int write_full_size(const char *path)
{
    static nets_file net;
    FILE *out;
    if (nets_renderer(&net, 410, 64, 1000, MS_NN_I8)) return 0;
    out = fopen(path, "wb");
    if (out == NULL || fwrite(net.bytes, 1, net.size, out) != net.size || fclose(out) != 0) return 0;
    free(net.bytes);
    return 1;
}

static void time_full_size(FILE *f)
{
    static const char *const path = "build/bench/renderer_410.safetensors";
    static matcher m;
    static const double zero[N] = {0}, one[N] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    double truth[N], x[N], times[RUNS], aims[RUNS], from;
    ms_pme_options options = ms_pme_defaults(); /* what a match does, but without its check of the collapse */
    ms_pme_function function;
    ms_error error;
    float *planes;
    int k, j;
    if (!write_full_size(path)) return;
    check(matcher_open(&m, path, &error), &error);
    planes = (float *)malloc(m.renderer.image_size * sizeof(float));
    if (planes == NULL) return;
    options.max_cost = 51;
    for (k = 0; k < RUNS; ++k) {
        for (j = 0; j < N; ++j) {
            truth[j] = (double)held_out.x[k * N + j];
            x[j] = (double)held_out.x[(k + RUNS) * N + j];
        }
        check(m.renderer.render(&m, truth, planes), &error);
        if (k == 0) aim(&m, planes); /* R comes with the first target: a minute */
        from = bench_cpu();
        aim(&m, planes);
        aims[k] = bench_cpu() - from;
        function = m.reduced;
        function.lower = zero;
        function.upper = one;
        check(ms_pme_minimize(&function, &options, x, NULL, &error), &error);
        check(m.renderer.render(&m, x, planes), &error);
        times[k] = bench_cpu() - from;
    }
    from = bench_median(times, RUNS);
    fprintf(f, "| 410 x 410, 524 million parameters (int8, random) | %.0f | | **%.0f** | %.0f |\n",
            1e3 * bench_median(aims, RUNS), 1e3 * from, 1e3 * times[RUNS - 1]);
    printf("410 x 410: %.0f ms a match without inversion networks, of it %.0f the target\n", 1e3 * from,
           1e3 * aims[RUNS / 2]);
    matcher_close(&m);
    free(planes);
    remove(path);
}

/* Pictures, collapsed values and Jacobians: what a unit of cost is. */
static void time_units(FILE *f, const matcher *m, const target *t)
{
    enum { REPEATS = 20 };
    size_t rows = m->reduced.residual_count;
    double *r = (double *)malloc(rows * (N + 1) * sizeof(double)), time[3][RUNS], x[N];
    float *picture = (float *)malloc(m->renderer.image_size * sizeof(float));
    int run, i, k;
    if (r == NULL || picture == NULL) return;
    memcpy(x, t->nn, sizeof x);
    for (run = 0; run < RUNS; ++run)
        for (k = 0; k < 3; ++k) {
            double from = bench_cpu();
            for (i = 0; i < REPEATS; ++i) {
                x[0] = 0.3 + 0.01 * i;
                if (k == 0) m->renderer.render(m->renderer.user, x, picture);
                else m->reduced.residuals(m->reduced.user, x, r, k == 2 ? r + rows : NULL);
            }
            time[k][run] = (bench_cpu() - from) / (int)REPEATS;
        }
    fprintf(
        f,
        "\nAt %d x %d a picture takes %.3f ms, a collapsed value %.2f of that, one with its Jacobian %.2f (counted as 1 and 5).\n",
        m->network.size, m->network.size, 1e3 * bench_median(time[0], RUNS),
        bench_median(time[1], RUNS) / bench_median(time[0], RUNS),
        bench_median(time[2], RUNS) / bench_median(time[0], RUNS));
    free(r);
    free(picture);
}

/* Singular values of the Jacobian at x, largest first, and the standard deviation of each parameter if every residual
   has independent noise of standard deviation 1, by one-sided Jacobi rotations (Hestenes 1958). */
static void sensitivity(const ms_pme_function *function, const double *x, double *singular_value, double *deviation)
{
    size_t m = function->residual_count, i;
    double *r = (double *)malloc(m * (N + 1) * sizeof(double)), *a = r + m, v[N][N];
    size_t j, k, l;
    int sweep, changed = 1;
    ms_error error;
    if (r == NULL) check_picture("out of memory");
    error.message[0] = 0;
    check(function->residuals(function->user, x, r, a), &error);
    for (j = 0; j < N; ++j)
        for (k = 0; k < N; ++k) v[j][k] = j == k;
    for (sweep = 0; changed && sweep < 60; ++sweep)
        for (changed = 0, j = 0; j < N; ++j)
            for (k = j + 1; k < N; ++k) {
                double jj = 0, kk = 0, jk = 0, zeta, t, c, s;
                for (i = 0; i < m; ++i) {
                    jj += a[i * N + j] * a[i * N + j];
                    kk += a[i * N + k] * a[i * N + k];
                    jk += a[i * N + j] * a[i * N + k];
                }
                if (!(fabs(jk) > 1e-15 * sqrt(jj * kk))) continue;
                changed = 1;
                zeta = (kk - jj) / (2 * jk);
                t = (zeta >= 0 ? 1 : -1) / (fabs(zeta) + sqrt(1 + zeta * zeta));
                c = 1 / sqrt(1 + t * t);
                s = c * t;
                for (i = 0; i < m; ++i) {
                    double p = a[i * N + j], q = a[i * N + k];
                    a[i * N + j] = c * p - s * q;
                    a[i * N + k] = c * q + s * p;
                }
                for (l = 0; l < N; ++l) {
                    double p = v[j][l], q = v[k][l];
                    v[j][l] = c * p - s * q;
                    v[k][l] = c * q + s * p;
                }
            }
    for (j = 0; j < N; ++j) deviation[j] = 0;
    for (k = 0; k < N; ++k) {
        double square = 0;
        for (i = 0; i < m; ++i) square += a[i * N + k] * a[i * N + k];
        for (j = 0; j < N; ++j) deviation[j] += v[k][j] * v[k][j] / fmax(square, 1e-300);
        for (j = k; j > 0 && singular_value[j - 1] < sqrt(square); --j) singular_value[j] = singular_value[j - 1];
        singular_value[j] = sqrt(square);
    }
    for (j = 0; j < N; ++j) deviation[j] = sqrt(deviation[j]);
    free(r);
}

/* --- recovery: unedited pictures --- */

/* Every held-out material, as its picture by the network and by the path tracer. */
static void table_recovery(matcher *m)
{
    static const char *const name[N] = {
        "diffuse red",      "diffuse green",     "diffuse blue",        "glossy red",      "glossy green",
        "glossy blue",      "glossy roughness",  "glossy share",        "glass red",       "glass green",
        "glass blue",       "glass roughness",   "index of refraction", "translucent red", "translucent green",
        "translucent blue", "translucent share", "transmissive share",  "absorption"};
    enum { MATERIALS = 60 };
    static double error_of[2][N][MATERIALS], noise[N][MATERIALS], spectrum[N], rmse[2][MATERIALS];
    int known[N] = {0};
    double x[N], singular_value[N], deviation[N];
    FILE *f = bench_open("pme_recovery.md");
    float *planes;
    ms_pme_match_options options = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error;
    int traced, i, j;
    options.refine.max_cost = 300;
    for (traced = 0; traced < 2; ++traced)
        for (i = 0; i < MATERIALS; ++i) {
            const float *truth = held_out.x + i * N;
            planes = edited(m, &edits[0], i, i);
            for (j = 0; j < N; ++j) x[j] = (double)truth[j];
            if (!traced) check(m->renderer.render(m, x, planes), &error);
            aim(m, planes);
            sensitivity(&m->reduced, x, singular_value, deviation);
            check(ms_pme_match(&m->renderer, planes, NULL, &options, x, NULL, &result, &error), &error);
            rmse[traced][i] = 255 * result.rmse;
            for (j = 0; j < N; ++j) {
                error_of[traced][j][i] = fabs(x[j] - (double)truth[j]);
                noise[j][i] = deviation[j] / 255;
                known[j] += noise[j][i] < 0.05 && !traced;
                spectrum[j] += log(fmax(singular_value[j], 1e-12)) / (2 * (int)MATERIALS);
            }
            free(planes);
        }
    fprintf(
        f,
        "%d unedited pictures of held-out materials, 64 x 64, after 300 units: median errors of the parameters. Median RMSE: %.4f levels of 255 for\n"
        "pictures by the network, %.2f for path-traced ones. Noise: how far independent noise of one level in every value would move a parameter,\n"
        "from the singular values of the Jacobian at the truth; determined: below 0.05. The rest colors a lobe that the mix hides. The network's own\n"
        "error in a path-traced picture is smooth, and moves parameters further than noise of its size. `make bench FILTER=pme`\n\n"
        "| parameter | determined in | noise, median | error, pictures by the network | error, path-traced |\n|---|---:|---:|---:|---:|\n",
        MATERIALS, bench_median(rmse[0], MATERIALS), bench_median(rmse[1], MATERIALS));
    for (j = 0; j < N; ++j)
        fprintf(f, "| %d %s | %.0f%% | %.4f | %.1e | %.3f |\n", j, name[j], 100.0 * known[j] / (int)MATERIALS,
                bench_median(noise[j], MATERIALS), bench_median(error_of[0][j], MATERIALS),
                bench_median(error_of[1][j], MATERIALS));
    fprintf(f, "\nSingular values of the Jacobian, geometric means:");
    for (j = 0; j < N; ++j) fprintf(f, " %.2g", exp(spectrum[j]));
    fprintf(f, "\n");
    fclose(f);
    printf("recovery: median RMSE %.4f by the network, %.2f path-traced\n", bench_median(rmse[0], MATERIALS),
           bench_median(rmse[1], MATERIALS));
}

/* --- edits that are not of the material: what becomes of its parameters --- */

static void table_edits(matcher *m)
{
    static const struct {
        const char *edit, *option;
        int flags;
    } row[] = {{"unedited", "", 0},       {"unedited", "`--robust --align`", MATCHER_ROBUST | MATCHER_ALIGN},
               {"logo", "", 0},           {"logo", "`--robust`", MATCHER_ROBUST},
               {"exposure", "", 0},       {"exposure", "`--exposure`", MATCHER_EXPOSURE},
               {"colored light", "", 0},  {"colored light", "`--tint`", MATCHER_TINT},
               {"shift", "", 0},          {"shift", "`--align`", MATCHER_ALIGN},
               {"logo and shift", "", 0}, {"logo and shift", "`--robust --align`", MATCHER_ROBUST | MATCHER_ALIGN}};
    enum { ROWS = 12, MATERIALS = 16 };
    FILE *f = bench_open("pme_edits.md");
    float *picture = (float *)malloc(m->renderer.image_size * sizeof(float));
    ms_error error;
    int k, i, j;
    if (picture == NULL) check_picture("out of memory");
    fprintf(
        f,
        "Edits that no material explains, %d held-out path-traced materials, 64 x 64, 300 units: what the options of build/match bring back. Medians of the\n"
        "RMSE, in levels of 255, between the answer's picture and the unedited one; of the RMS error of the 19 parameters; and of those that the\n"
        "picture determines (noise of one level would move them by less than 0.05). `make bench FILTER=pme`\n\n"
        "| edit | option | picture from the unedited one | parameters | determined ones | ms |\n|---|---|---:|---:|---:|---:|\n",
        MATERIALS);
    for (k = 0; k < ROWS; ++k) {
        double apart[MATERIALS], all[MATERIALS], known[MATERIALS], ms[MATERIALS];
        for (i = 0; i < MATERIALS; ++i) {
            const float *truth = held_out.x + 3 * i * N;
            const char *name = strcmp(row[k].edit, "logo and shift") == 0 ? "logo" : row[k].edit;
            float *source = edited(m, &edits[0], 3 * i, 3 * i), *planes;
            ms_pme_match_options options = ms_pme_match_defaults();
            ms_pme_match_result result;
            double x[N], singular_value[N], deviation[N], from;
            int e, count = 0;
            size_t p;
            for (e = 0; e < EDIT_FURTHER_COUNT && strcmp(edits_further[e].name, name) != 0;) ++e;
            planes = edited(m, e < EDIT_FURTHER_COUNT ? &edits_further[e] : &edits[0], 3 * i, 3 * i);
            if (strcmp(row[k].edit, "logo and shift") == 0) {
                image both = image_new(m->network.size, m->network.size, 3);
                if (both.pixels == NULL) check_picture("out of memory");
                neural_paste(planes, m->network.size, &both, 0, 0);
                edit_shift(&both, NULL, 0.03f);
                neural_planes(&both, planes);
                image_free(&both);
            }
            for (j = 0; j < N; ++j) x[j] = (double)truth[j];
            aim(m, source);
            sensitivity(&m->reduced, x, singular_value, deviation);
            options.refine.max_cost = 300;
            options.refine.restarts = 1000;
            from = bench_cpu();
            check(matcher_match(m, planes, NULL, &options, row[k].flags, x, picture, &result, NULL, &error), &error);
            ms[i] = 1e3 * (bench_cpu() - from);
            check(m->renderer.render(m, x, picture), &error);
            for (p = 0, apart[i] = 0; p < m->renderer.image_size; ++p)
                apart[i] += ((double)picture[p] - (double)source[p]) * ((double)picture[p] - (double)source[p]);
            apart[i] = 255 * sqrt(apart[i] / (double)m->renderer.image_size);
            for (j = 0, all[i] = known[i] = 0; j < N; ++j) {
                double d = x[j] - (double)truth[j];
                all[i] += d * d / (double)N;
                if (deviation[j] / 255 < 0.05) known[i] += d * d, ++count;
            }
            all[i] = sqrt(all[i]);
            known[i] = sqrt(known[i] / (count ? count : 1));
            free(source);
            free(planes);
        }
        fprintf(f, "| %s | %s | %.2f | %.3f | %.3f | %.0f |\n", row[k].edit, row[k].option,
                bench_median(apart, MATERIALS), bench_median(all, MATERIALS), bench_median(known, MATERIALS),
                bench_median(ms, MATERIALS));
        printf("%s %s: %.2f from the unedited picture, parameters %.3f\n", row[k].edit, row[k].option,
               apart[MATERIALS / 2], all[MATERIALS / 2]);
    }
    fclose(f);
    free(picture);
}

static void open_networks(matcher *m, int size, target *targets)
{
    char path[100];
    ms_error error;
    int t;
    snprintf(path, sizeof path, "examples/data/renderer_%d.safetensors", size);
    check(matcher_open(m, path, &error), &error);
    check(matcher_add_inversions(m, "examples/data", &error), &error);
    for (t = 0; t < TARGETS; ++t) {
        targets[t].name = edits[t % EDIT_COUNT].name;
        targets[t].planes = edited(m, &edits[t % EDIT_COUNT], t, t + TARGETS);
        aim(m, targets[t].planes);
        starts(m, &targets[t], t);
    }
}

int main(int argc, char **argv)
{
    static matcher small, large;
    static target small_targets[TARGETS], large_targets[TARGETS];
    const char *problem;
    FILE *f;
    int t;
    full = argc > 1 && strcmp(argv[1], "--full") == 0;
    problem = materials_read("examples/data/materials.csv", N, &held_out);
    if (!problem) problem = image_read("examples/data/materials.png", &sheet);
    check_picture(problem);
    open_networks(&small, 64, small_targets);
    if (argc > 1) { /* one table alone */
        static const struct {
            const char *option;
            void (*table)(matcher *m);
        } alone[] = {{"--minima", table_minima},
                     {"--edits", table_edits},
                     {"--sequence", table_sequence},
                     {"--recovery", table_recovery}};
        for (t = 0; t < 4; ++t)
            if (strcmp(argv[1], alone[t].option) == 0) {
                alone[t].table(&small);
                return 0;
            }
        if (strcmp(argv[1], "--targets") == 0) {
            table_targets(&small, small_targets);
            return 0;
        }
        if (strcmp(argv[1], "--bounds") == 0) {
            table_bounds();
            return 0;
        }
        if (strcmp(argv[1], "--optimizers") == 0) {
            table_optimizers(&small, small_targets);
            return 0;
        }
    }
    f = bench_open("pme_time.md");
    open_networks(&large, 128, large_targets);
    fprintf(
        f,
        "One match at the defaults, milliseconds of one core of %s, medians of %d edited pictures (of %d for the largest). `make bench FILTER=pme`\n\n"
        "| picture | setting the target | best of 9 networks | the whole match | slowest |\n|---|---:|---:|---:|---:|\n",
        bench_processor(), TARGETS, RUNS);
    for (t = 0; t < 2; ++t) {
        time_matches(f, &small, small_targets, t);
        time_matches(f, &large, large_targets, t);
    }
    time_full_size(f);
    time_units(f, &small, small_targets);
    time_units(f, &large, large_targets);
    fclose(f);
    if (argc > 1 && strcmp(argv[1], "--known") == 0) search_globally(&small);
    if (argc > 1 && strcmp(argv[1], "--times") == 0) return 0;
    table_minima(&small);
    table_targets(&small, small_targets);
    table_optimizers(&small, small_targets);
    table_sequence(&small);
    table_recovery(&small);
    table_edits(&small);
    table_bounds();
    for (t = 0; t < TARGETS; ++t) {
        free(small_targets[t].planes);
        free(large_targets[t].planes);
    }
    matcher_close(&small);
    matcher_close(&large);
    materials_free(&held_out);
    image_free(&sheet);
    return 0;
}
