/* ms_gpr.h: how many scores an active gallery is worth, on users of twelve kinds (tests/users.h). Writes build/bench/gpr_active.md:
   mean true score of 300 recommendations (tau 0.6), Jensen-Shannon divergence, share of the liked classes that are recommended. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "users.h"
#include "bench.h"

enum { M = 19, USERS = 3, HELD = 1200, COUNT = 300, MOST = 250, ROUND = 10, STEPS = 5 };

typedef struct worth {
    double score, jsd, lobes;
} worth;

static double x[MOST * M], y[MOST], held[HELD * M], truth[HELD];

/* Adds what n scores are worth. */
static void judge(const user *u, int n, worth *w)
{
    static double mean[HELD], r[COUNT * M];
    double found[USER_CLASSES] = {0, 0, 0};
    ms_gpr *gp;
    int i, c;
    if (ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL) != MS_OK) exit(1);
    ms_gpr_predict(gp, held, HELD, mean, NULL, NULL);
    w->jsd += user_jsd(mean, truth, HELD) / (int)USERS;
    if (ms_gpr_recommend(gp, NULL, COUNT, r, NULL, NULL, NULL, NULL) == MS_OK)
        for (i = 0; i < COUNT; ++i) {
            double u_true = user_true(u, r + i * M);
            w->score += u_true / ((int)COUNT * (int)USERS);
            if (u_true > 3) found[user_class_of(u, r + i * M)] += 1;
        }
    for (c = 0; c < u->classes; ++c) w->lobes += (found[c] >= 5) / ((double)u->classes * (int)USERS);
    ms_gpr_destroy(gp);
}

int main(void)
{
    static const char *const column[STEPS] = {"100 uniform", "250 uniform", "60 active", "80 active", "100 active"};
    FILE *md = bench_open("gpr_active.md");
    worth all[STEPS];
    int kind, i, k, n;
    memset(all, 0, sizeof all);
    fprintf(md, "Users of twelve kinds, %d each, m = %d: mean true score of %d recommendations / divergence / share of the liked classes that are\n"
                "recommended, after so many scores; active galleries in batches of %d.\n\n| user |", (int)USERS, (int)M, (int)COUNT, (int)ROUND);
    for (k = 0; k < STEPS; ++k) fprintf(md, " %s |", column[k]);
    fprintf(md, "\n|---|---:|---:|---:|---:|---:|\n");
    for (kind = 0; kind < USER_KINDS; ++kind) {
        worth w[STEPS];
        memset(w, 0, sizeof w);
        for (i = 0; i < USERS; ++i) {
            uint64_t state = (uint64_t)(77 + i + 100 * kind);
            user u = user_of_kind(kind, (uint64_t)i + 1, M);
            for (k = 0; k < HELD * M; ++k) held[k] = test_uniform(&state);
            for (k = 0; k < HELD; ++k) truth[k] = user_true(&u, held + k * M);
            user_gallery(&u, 250, x, y, &state);
            judge(&u, 100, &w[0]);
            judge(&u, 250, &w[1]);
            for (n = 0; n <= 100; n += ROUND) {
                ms_gpr_gallery_options g;
                ms_gpr *gp;
                if (n >= 60 && n % 20 == 0) judge(&u, n, &w[n / 20 - 1]);
                memset(&g, 0, sizeof g);
                g.seed = (uint64_t)i;
                if (ms_gpr_fit(x, y, n, M, NULL, &gp, NULL, NULL) != MS_OK || ms_gpr_gallery(gp, &g, ROUND, x + n * M, NULL) != MS_OK) exit(1);
                for (k = n; k < n + ROUND; ++k) y[k] = user_score(&u, x + k * M, &state);
                ms_gpr_destroy(gp);
            }
        }
        fprintf(md, "| %s |", user_kinds[kind]);
        for (k = 0; k < STEPS; ++k) {
            fprintf(md, " %.1f / %.3f / %.2f |", w[k].score, w[k].jsd, w[k].lobes);
            all[k].score += w[k].score / USER_KINDS;
            all[k].jsd += w[k].jsd / USER_KINDS;
            all[k].lobes += w[k].lobes / USER_KINDS;
        }
        fprintf(md, "\n");
        fflush(md);
    }
    fprintf(md, "| **all** |");
    for (k = 0; k < STEPS; ++k) fprintf(md, " %.2f / %.3f / %.2f |", all[k].score, all[k].jsd, all[k].lobes);
    fprintf(md, "\n");
    return fclose(md) != 0;
}
