/* ms_gpr.h: what answers are worth: uniform galleries, the thesis's rounds, active galleries of scores, and those after
   five galleries of "the best 2 of 9" or where the studio asks for them, on users of twelve kinds (tests/users.h).
   Writes build/bench/gpr_active.md: mean true score of 300 recommendations (tau 0.6), Jensen-Shannon divergence, share
   of the liked classes that are recommended. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "users.h"
#include "bench.h"
#include "../../examples/tools/studio.h"

enum {
    USERS = 3,
    MANY = 38,
    HELD = 1200,
    COUNT = 300,
    ROUND = 10,
    SHOWN = 9,
    GALLERIES = 5,
    ASKED = 20,
    STEPS = 11,
    TAUS = 7
};

typedef struct worth {
    double score, jsd, lobes;
    double ms; /* thread time of the session: galleries, the last model, its recommendations */
} worth;

static const double taus[TAUS] = {0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.9};

static double x[500 * MANY], y[500], held[HELD * MANY], truth[HELD];
static int rows[4 * ASKED * SHOWN], sizes[4 * ASKED], choices, chosen; /* of all, the preferred one first */
static double spent;                                                   /* seconds of the session's galleries so far */

static ms_gpr *fit(int n, int m)
{
    ms_gpr_fit_options o;
    ms_gpr *gp;
    memset(&o, 0, sizeof o);
    o.choices.rows = rows;
    o.choices.sizes = sizes;
    o.choices.count = choices;
    if (ms_gpr_fit(x, y, n, m, &o, &gp, NULL, NULL) != MS_OK) exit(1);
    return gp;
}

/* Mean true score of materials, and the share of the liked classes that 5 or more of them belong to. */
static worth judge_materials(const person *u, const double *r, int count)
{
    double found[USER_CLASSES] = {0, 0, 0};
    worth w = {0, 0, 0, 0};
    int i, c;
    for (i = 0; i < count; ++i) {
        double u_true = user_true(u, r + i * u->m);
        w.score += u_true / count;
        if (u_true > 3) found[user_class_of(u, r + i * u->m)] += 1;
    }
    for (c = 0; c < u->classes; ++c) w.lobes += (found[c] >= 5) / (double)u->classes;
    return w;
}

/* What was answered for the first n rows is worth; curve: by every threshold in place of the default's, or NULL. */
static worth judge(const person *u, int n, worth *curve)
{
    static double mean[HELD], r[COUNT * MANY];
    double clock = bench_cpu(), jsd, ms;
    ms_gpr *gp = fit(n, u->m);
    worth w = {0, 0, 0, 0};
    int t, some = ms_gpr_recommend(gp, NULL, COUNT, r, NULL, NULL, NULL, NULL) == MS_OK;
    ms = 1e3 * (spent + bench_cpu() - clock);
    ms_gpr_predict(gp, held, HELD, mean, NULL, NULL);
    jsd = user_jsd(mean, truth, HELD);
    if (some) w = judge_materials(u, r, COUNT);
    w.jsd = jsd;
    w.ms = ms;
    for (t = 0; t < TAUS && curve; ++t) {
        ms_gpr_recommend_options o;
        memset(&o, 0, sizeof o);
        o.tau = taus[t];
        memset(&curve[t], 0, sizeof curve[t]);
        if (ms_gpr_recommend(gp, &o, COUNT, r, NULL, NULL, NULL, NULL) == MS_OK)
            curve[t] = judge_materials(u, r, COUNT);
    }
    ms_gpr_destroy(gp);
    return w;
}

/* The same of a model that knows everything: uniform materials whose true score is 10 tau or more. */
static void judge_truth(const person *u, uint64_t state, worth *curve)
{
    static double r[TAUS][COUNT * MANY];
    int count[TAUS] = {0}, t, k, i;
    for (i = 0; i < 300000; ++i) {
        double *p = x, u_true;
        for (k = 0; k < u->m; ++k) p[k] = test_uniform(&state);
        u_true = user_true(u, p);
        for (t = 0; t < TAUS; ++t)
            if (u_true >= 10 * taus[t] && count[t] < COUNT)
                memcpy(r[t] + count[t]++ * u->m, p, (size_t)u->m * sizeof *p);
    }
    for (t = 0; t < TAUS; ++t) curve[t] = judge_materials(u, r[t], count[t]);
}

/* The next materials of an active gallery as rows n and on: `count`, or with `asks` SHOWN of them where the studio asks
   for picks: 1 then. */
static int show(const person *u, int n, int count, int asks, int seed)
{
    ms_gpr_gallery_options g;
    double clock = bench_cpu();
    ms_gpr *gp = fit(n, u->m);
    asks = asks && studio_wants_picks(gp);
    if (asks) count = SHOWN;
    memset(&g, 0, sizeof g);
    g.seed = (uint64_t)seed;
    if (ms_gpr_gallery(gp, &g, count, x + n * u->m, NULL) != MS_OK) exit(1);
    ms_gpr_destroy(gp);
    spent += bench_cpu() - clock;
    return asks;
}

/* A click each on at most the best two of those shown that are liked at all, or one on "none of these", which scores
   them 0; a user who answers at random does so here. Returns the clicks. */
static int click(const person *u, int n, uint64_t *state)
{
    double s[SHOWN];
    int best[2] = {-1, -1}, random = test_uniform(state) < u->wrong, i, k;
    for (i = 0; i < SHOWN; ++i) {
        s[i] = user_true(u, x + (n + i) * u->m);
        if (s[i] > 0) s[i] += u->human * test_normal(state);
        if (random) s[i] = test_uniform(state);
        y[n + i] = MS_GPR_UNSCORED;
    }
    for (k = 0; k < 2; ++k)
        for (i = 0; i < SHOWN; ++i)
            if (s[i] > 0 && i != best[0] && (best[k] < 0 || s[i] > s[best[k]])) best[k] = i;
    for (i = 0; i < SHOWN && best[0] < 0; ++i) y[n + i] = 0;
    for (k = 0; k < 2 && best[k] >= 0; ++k) {
        int first = chosen;
        rows[chosen++] = n + best[k];
        for (i = 0; i < SHOWN; ++i)
            if (i != best[0] && i != best[1]) rows[chosen++] = n + i;
        sizes[choices++] = chosen - first;
    }
    return best[1] < 0 ? 1 : 2;
}

/* The thesis's rounds: a first gallery of uniform materials, then twice `more` recommendations are scored and learned
   from as well. */
static worth rounds(const person *u, int first, int more, int seed, uint64_t *state)
{
    int n = first, k;
    choices = chosen = 0;
    spent = 0;
    user_gallery(u, first, x, y, state);
    while (n < first + 2 * more) {
        ms_gpr_recommend_options o;
        double clock = bench_cpu();
        ms_gpr *gp = fit(n, u->m);
        ms_status status;
        memset(&o, 0, sizeof o);
        o.seed = (uint64_t)(seed + n);
        user_gallery(u, more, x + n * u->m, y + n, state); /* stays where nothing is liked yet */
        status = ms_gpr_recommend(gp, &o, more, x + n * u->m, NULL, NULL, NULL, NULL);
        spent += bench_cpu() - clock;
        if (status == MS_OK)
            for (k = n; k < n + more; ++k) y[k] = user_score(u, x + k * u->m, state);
        ms_gpr_destroy(gp);
        n += more;
    }
    return judge(u, n, NULL);
}

/* One user by all ways: uniform 100 and 250; active 60, 80, 100; clicks first, 60, 80, 100 answers; the thesis's rounds
   to 100 and 250; active 100 with clicks where the studio asks for them. curve: of 250 uniform, of 100 with clicks
   first, and of the truth. */
static void try_user(const person *u, int seed, uint64_t state, worth *w, worth curve[3][TAUS])
{
    uint64_t first, last = 0;
    int way, g, n, answers, k;
    for (k = 0; k < HELD * u->m; ++k) held[k] = test_uniform(&state);
    for (k = 0; k < HELD; ++k) truth[k] = user_true(u, held + k * u->m);
    choices = chosen = 0;
    spent = 0;
    user_gallery(u, 250, x, y, &state);
    w[0] = judge(u, 100, NULL);
    w[1] = judge(u, 250, curve[0]);
    for (way = 0, first = state; way < 3; ++way) {
        int next = 60;
        n = answers = choices = chosen = 0;
        spent = 0;
        if (way == 2) last = state, state = first; /* the same answers as of way 0 */
        for (g = 0; g < GALLERIES && way == 1; ++g) {
            show(u, n, SHOWN, 0, seed);
            answers += click(u, n, &state);
            n += SHOWN;
        }
        for (;;) {
            int count = next - answers < ROUND ? next - answers : ROUND;
            if (count <= 0) {
                if (way < 2) w[2 + 3 * way + (next - 60) / 20] = judge(u, n, way == 1 && next == 100 ? curve[1] : NULL);
                else if (next == 100) w[10] = judge(u, n, NULL);
                if (next == 100) break;
                next += 20;
                continue;
            }
            if (show(u, n, count, way == 2, seed)) {
                answers += click(u, n, &state);
                n += SHOWN;
                continue;
            }
            for (k = n; k < n + count; ++k) y[k] = user_score(u, x + k * u->m, &state);
            n += count;
            answers += count;
        }
    }
    state = last;
    w[8] = rounds(u, 50, 25, seed, &state);
    w[9] = rounds(u, 150, 50, seed, &state);
    judge_truth(u, state, curve[2]);
}

/* What a click and a score cost in a session: thread time, medians of five sessions. */
static void time_clicks(FILE *md)
{
    enum { M = 19, RUNS = 5, SIZES = 3 };
    static const int galleries[SIZES] = {5, 15, 30}, scores[SIZES] = {100, 250, 500};
    static double points[500 * M], none[500], t[SIZES][3][RUNS], r[20 * M];
    static int row[30 * 2 * (SHOWN - 1)], size[60];
    int run, i, k, g;
    for (run = 0; run < RUNS; ++run) {
        uint64_t state = (uint64_t)run + 5;
        person u = user_make(state, M, 0.2);
        double theta[M + 2], given[500], clock;
        ms_gpr_view parts;
        ms_gpr *gp;
        for (k = 0; k < M + 2; ++k) theta[k] = k < M ? log(2.5) : k == M ? 0 : log(0.2);
        memset(&parts, 0, sizeof parts);
        parts.m = M;
        parts.theta = theta;
        if (ms_gpr_create(&parts, NULL, &gp, NULL) != MS_OK) exit(1);
        for (k = 0; k < 500 * M; ++k) points[k] = test_uniform(&state);
        for (i = 0; i < 500; ++i) none[i] = MS_GPR_UNSCORED;
        for (g = 0; g < 30; ++g) { /* two of nine, the nearest to a corner */
            int first[2] = {0, 1}, at = g * 2 * (SHOWN - 1);
            for (i = 0; i < SHOWN; ++i)
                for (k = 0; k < 2; ++k)
                    if (points[(SHOWN * g + i) * M] > points[(SHOWN * g + first[k]) * M]) {
                        if (k == 0) first[1] = first[0];
                        first[k] = i;
                        break;
                    }
            for (k = 0; k < 2; ++k) {
                row[at++] = SHOWN * g + first[k];
                for (i = 0; i < SHOWN; ++i)
                    if (i != first[0] && i != first[1]) row[at++] = SHOWN * g + i;
                size[2 * g + k] = SHOWN - 1;
            }
            parts.n = SHOWN * (g + 1);
            parts.x = points;
            parts.y = none;
            parts.choices.count = 2 * (g + 1);
            parts.choices.rows = row;
            parts.choices.sizes = size;
            clock = bench_cpu();
            if (ms_gpr_update(gp, &parts, NULL) != MS_OK) exit(1);
            for (k = 0; k < SIZES; ++k)
                if (g + 1 == galleries[k]) t[k][0][run] = bench_cpu() - clock;
        }
        ms_gpr_destroy(gp);
        for (i = 0; i < 500; ++i) given[i] = user_score(&u, points + i * M, &state);
        for (k = 0; k < SIZES; ++k) {
            if (ms_gpr_fit(points, given, scores[k] - 1, M, NULL, &gp, NULL, NULL) != MS_OK) exit(1);
            parts = ms_gpr_view_of(gp);
            parts.n = scores[k];
            parts.x = points;
            parts.y = given;
            clock = bench_cpu();
            ms_gpr_update(gp, &parts, NULL);
            t[k][1][run] = bench_cpu() - clock;
            clock = bench_cpu();
            ms_gpr_recommend(gp, NULL, 20, r, NULL, NULL, NULL, NULL);
            t[k][2][run] = bench_cpu() - clock;
            ms_gpr_destroy(gp);
        }
    }
    fprintf(
        md,
        "\nOne more gallery of the best 2 of 9 in the model, one more score (`ms_gpr_update`), and 20 recommendations at once.\n\n"
        "| galleries (clicks), materials | a gallery more | scores | a score more | 20 recommendations |\n|---|---:|---:|---:|---:|\n");
    for (k = 0; k < SIZES; ++k)
        fprintf(md, "| %d (%d), %d | %.1f ms | %d | %.2f ms | %.1f ms |\n", galleries[k], 2 * galleries[k],
                (int)SHOWN * galleries[k], 1e3 * bench_median(t[k][0], RUNS), scores[k],
                1e3 * bench_median(t[k][1], RUNS), 1e3 * bench_median(t[k][2], RUNS));
}

static int ascending(const void *a, const void *b)
{
    double x0 = *(const double *)a, x1 = *(const double *)b;
    return (x0 > x1) - (x0 < x1);
}

int main(void)
{
    static const char *const column[STEPS] = {"100 uniform",
                                              "250 uniform",
                                              "60 active",
                                              "80 active",
                                              "100 active",
                                              "60, clicks first",
                                              "80, clicks first",
                                              "100, clicks first",
                                              "100, the thesis's rounds",
                                              "250, the thesis's rounds",
                                              "100 active, clicks where asked"};
    static double score[STEPS][USER_KINDS * USERS], jsd[STEPS][USER_KINDS * USERS], ms[STEPS][USER_KINDS * USERS];
    FILE *md = bench_open("gpr_active.md");
    static const char *const row[3] = {"250 uniform", "100, clicks first", "all that is liked so much"};
    worth all[STEPS], curve[2][3][TAUS];
    int kind, i, k, m, t;
    memset(curve, 0, sizeof curve);
    fprintf(
        md,
        "Users of twelve kinds, %d each: mean true score of %d recommendations / divergence / share of the liked classes that are\n"
        "recommended, after so many answers; active galleries in batches of %d. Clicks first: of five active galleries of %d the user\n"
        "clicks on the best two or as many as are liked, or on \"none of these\"; every click is an answer, then come scores. The thesis's rounds: 50 uniform materials, then twice 25 recommendations (150 and 50).\nTime: thread time of a session, its galleries, last model and recommendations; median, one core of %s.\n\n| user |",
        (int)USERS, (int)COUNT, (int)ROUND, (int)SHOWN, bench_processor());
    for (k = 0; k < STEPS; ++k) fprintf(md, " %s |", column[k]);
    fprintf(md, "\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 19; m <= MANY; m += 19) {
        int users = m == 19 ? USERS : 1, count = 0;
        memset(all, 0, sizeof all);
        for (kind = 0; kind < USER_KINDS; ++kind) {
            worth sum[STEPS];
            memset(sum, 0, sizeof sum);
            for (i = 0; i < users; ++i) {
                person u = user_of_kind(kind, (uint64_t)i + 1, m);
                worth w[STEPS], c[3][TAUS];
                try_user(&u, i, (uint64_t)(77 + i + 100 * kind), w, c);
                for (k = 0; k < 3; ++k)
                    for (t = 0; t < TAUS; ++t) {
                        curve[m > 19][k][t].score += c[k][t].score / (users * USER_KINDS);
                        curve[m > 19][k][t].lobes += c[k][t].lobes / (users * USER_KINDS);
                    }
                for (k = 0; k < STEPS; ++k) {
                    sum[k].score += w[k].score / users;
                    sum[k].jsd += w[k].jsd / users;
                    sum[k].lobes += w[k].lobes / users;
                    score[k][count] = w[k].score;
                    jsd[k][count] = w[k].jsd;
                    ms[k][count] = w[k].ms;
                }
                ++count;
            }
            if (m == 19) fprintf(md, "| %s |", user_kinds[kind]);
            for (k = 0; k < STEPS; ++k) {
                if (m == 19) fprintf(md, " %.1f / %.3f / %.2f |", sum[k].score, sum[k].jsd, sum[k].lobes);
                all[k].score += sum[k].score / USER_KINDS;
                all[k].jsd += sum[k].jsd / USER_KINDS;
                all[k].lobes += sum[k].lobes / USER_KINDS;
            }
            if (m == 19) fprintf(md, "\n");
            fflush(md);
        }
        if (m == 19) fprintf(md, "| **all** |");
        else fprintf(md, "| all, m = %d, %d each |", m, users);
        for (k = 0; k < STEPS; ++k) fprintf(md, " %.2f / %.3f / %.2f |", all[k].score, all[k].jsd, all[k].lobes);
        fprintf(md, "\n| 80%% of them have |");
        for (k = 0; k < STEPS; ++k) {
            qsort(score[k], (size_t)count, sizeof score[k][0], ascending);
            qsort(jsd[k], (size_t)count, sizeof jsd[k][0], ascending);
            fprintf(md, " %.1f or more / %.3f or less |", score[k][count / 5], jsd[k][count - 1 - count / 5]);
        }
        fprintf(md, "\n| *time, ms, m = %d* |", m);
        for (k = 0; k < STEPS; ++k) fprintf(md, " %.0f |", bench_median(ms[k], count));
        fprintf(md, "\n");
        fflush(md);
    }
    fprintf(
        md,
        "\nThe same users and answers at other thresholds (`tau`; the default is 0.6): mean true score / share of the liked classes. The last\n"
        "row is of a model that knows everything: uniform materials with a true score of 10 tau or more. The divergence does not depend on tau.\n\n| |");
    for (t = 0; t < TAUS; ++t) fprintf(md, " tau %g |", taus[t]);
    fprintf(md, "\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 0; m < 2; ++m)
        for (k = 0; k < 3; ++k) {
            fprintf(md, "| %s, m = %d |", row[k], 19 * (m + 1));
            for (t = 0; t < TAUS; ++t) fprintf(md, " %.2f / %.2f |", curve[m][k][t].score, curve[m][k][t].lobes);
            fprintf(md, "\n");
        }
    time_clicks(md);
    return fclose(md) != 0;
}
