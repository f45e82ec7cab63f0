/* What a person's comparisons alone teach: 3 tastes over 6 parameters, 40 persons each, whose noise is a third of their
   signal, equal to it, or three times as large. Held-out pairs: log loss of the model's probabilities, the person's
   own, the worst person's, and how many pairs are in the right order. Table in build/bench/gpr_compare.md. */
#include "bench.h"
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"

enum { N = 100, M = 6, HELD = 2000, PERSONS = 40, TASTES = 3, NOISES = 3, COUNTS = 4 };

static double uniform(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u; /* splitmix64 */
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

static double normal(uint64_t *state)
{
    double a = uniform(state), b = uniform(state);
    return sqrt(-2 * log(1 - a)) * cos(6.283185307179586 * b);
}

static double cdf(double x) { return 0.5 * erfc(-x / sqrt(2.0)); }

static double taste_of(int taste, const double *x)
{
    double a = x[0] - 0.3, b = x[1] - 0.6, c = x[4] - 0.5;
    return taste == 0 ? sin(4 * x[0]) + x[3]
        : taste == 1  ? 3 * x[0] - 2 * x[1] + x[2]
                      : exp(-8 * (a * a + b * b + c * c));
}

static void two_rows(uint64_t *state, int *a, int *b)
{
    *a = (int)((int)N * uniform(state));
    *b = (*a + 1 + (int)((N - 1) * uniform(state))) % N;
}

static double loss_of(double truth, double p)
{
    p = fmin(fmax(p, 1e-9), 1 - 1e-9);
    return -truth * log(p) - (1 - truth) * log(1 - p);
}

/* [0] the model's loss, [1] the person's own, [2] share in the right order; 0: the fit failed. */
static int person(int taste, double noise, int count, uint64_t state, double out[3])
{
    static double x[N * M], y[N], f[N], mean[N];
    static int pairs[2 * 300];
    double sum = 0, squares = 0;
    ms_gpr_fit_options options;
    ms_gpr *gp;
    int i, a, b;
    for (i = 0; i < N * M; ++i) x[i] = uniform(&state);
    for (i = 0; i < N; ++i) {
        y[i] = MS_GPR_UNSCORED;
        f[i] = taste_of(taste, x + i * M);
        sum += f[i] / (int)N;
        squares += f[i] * f[i] / (int)N;
    }
    for (i = 0; i < N; ++i) f[i] = (f[i] - sum) / sqrt(squares - sum * sum);
    for (i = 0; i < count; ++i) {
        two_rows(&state, &a, &b);
        if (f[a] + noise * normal(&state) > f[b] + noise * normal(&state)) pairs[2 * i] = a, pairs[2 * i + 1] = b;
        else pairs[2 * i] = b, pairs[2 * i + 1] = a;
    }
    memset(&options, 0, sizeof options);
    options.choices.rows = pairs;
    options.choices.count = count;
    if (ms_gpr_fit(x, y, N, M, &options, &gp, NULL, NULL) != MS_OK) return 0;
    if (ms_gpr_predict(gp, x, N, mean, NULL, NULL) != MS_OK) return 0;
    out[0] = out[1] = out[2] = 0;
    for (i = 0; i < HELD; ++i) {
        double truth, p;
        two_rows(&state, &a, &b);
        if (ms_gpr_preference(gp, x + a * M, x + b * M, 1, &p, NULL) != MS_OK) return 0;
        truth = cdf((f[a] - f[b]) / (noise * sqrt(2.0)));
        out[0] += loss_of(truth, p) / (int)HELD;
        out[1] += loss_of(truth, truth) / (int)HELD;
        out[2] += ((f[a] > f[b]) == (mean[a] > mean[b])) / (double)HELD;
    }
    ms_gpr_destroy(gp);
    return 1;
}

int main(void)
{
    static const double noise[NOISES] = {0.35, 1, 3};
    static const int count[COUNTS] = {20, 50, 100, 300};
    FILE *md = bench_open("gpr_compare.md");
    int taste, n, c, i, k;
    fprintf(
        md,
        "Comparisons alone, 3 tastes of 6 parameters, 40 persons each: log loss of held-out pairs by the model / by the person's own\n"
        "probabilities / of the worst person; share of pairs in the right order. A coin: 0.693, 0.5. `make bench FILTER=gpr_compare`.\n\n"
        "| noise over signal | 20 pairs | 50 pairs | 100 pairs | 300 pairs |\n|---|---:|---:|---:|---:|\n");
    for (n = 0; n < NOISES; ++n) {
        fprintf(md, "| %g |", noise[n]);
        for (c = 0; c < COUNTS; ++c) {
            double mean[3] = {0, 0, 0}, worst = 0;
            for (taste = 0; taste < TASTES; ++taste)
                for (i = 0; i < PERSONS; ++i) {
                    double one[3];
                    if (!person(taste, noise[n], count[c], (uint64_t)(1000 * (100 * taste + 10 * n + c) + 7919 * i),
                                one))
                        return 1;
                    for (k = 0; k < 3; ++k) mean[k] += one[k] / ((int)TASTES * (int)PERSONS);
                    worst = fmax(worst, one[0]);
                }
            fprintf(md, " %.2f / %.2f / %.2f; %.2f |", mean[0], mean[1], worst, mean[2]);
        }
        fprintf(md, "\n");
    }
    return fclose(md) != 0;
}
