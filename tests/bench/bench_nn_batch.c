/* ms_nn.h: batches. Every element type, of dense, shared-channel and convolutional networks:
   the time of a sample in batches of 2 to 1000 beside that of one alone, and the share of the processor's multiply-adds
   at the largest; then 300 previews by the network that ships, on one thread and on two. Writes
   build/bench/nn_batch.md. `bench_nn_batch [PART OF A NETWORK'S NAME [TYPE [LEVEL, 1 to 4]]]` */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "bench.h"
#include "nets.h"
#include <pthread.h>
#include "pool.h"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

enum { MOST = 1000 };
static const int counts[] = {2, 3, 4, 5, 12, 13, 47, 49, 100, 300, MOST};
enum { COUNTS = sizeof counts / sizeof counts[0] };

/* --- the processor's multiply-adds: independent sums in registers, nothing else --- */

static volatile float sink;

#if defined(__x86_64__)
#define PEAK(name, isa, vector, set, madd, lanes)                                      \
    static __attribute__((target(isa))) double name(void)                              \
    {                                                                                  \
        vector s[12], a = set(1.0000001f), b = set(1e-9f);                             \
        double start;                                                                  \
        int i, k;                                                                      \
        float out[lanes];                                                              \
        for (k = 0; k < 12; ++k) s[k] = set((float)k);                                 \
        start = bench_cpu();                                                           \
        for (i = 0; i < 2000000; ++i) {                                                \
            _Pragma("GCC unroll 12") for (k = 0; k < 12; ++k) s[k] = madd(s[k], a, b); \
            __asm__ volatile("");                                                      \
        }                                                                              \
        start = bench_cpu() - start;                                                   \
        for (k = 1; k < 12; ++k) s[0] = madd(s[k], a, s[0]);                           \
        memcpy(out, &s[0], sizeof out);                                                \
        sink = out[0];                                                                 \
        return 12.0 * lanes * 2000000 / start;                                         \
    }
PEAK(peak_avx512, "avx512f", __m512, _mm512_set1_ps, _mm512_fmadd_ps, 16)
PEAK(peak_avx2, "avx2,fma", __m256, _mm256_set1_ps, _mm256_fmadd_ps, 8)
#endif

/* Multiply-adds a second, the best of several; 0: not known here. */
static double peak(ms_simd level)
{
    double best = 0;
#if defined(__x86_64__)
    int i;
    for (i = 0; i < 9; ++i) {
        if (level == MS_SIMD_AVX512) best = fmax(best, peak_avx512());
        if (level == MS_SIMD_AVX2) best = fmax(best, peak_avx2());
    }
#else
    (void)level;
#endif
    return best;
}

/* --- batches --- */

typedef struct job {
    ms_nn *nn;
    float *x, *y;
    void *workspace;
} job;

/* The samples from `at` on. */
static void run(const job *j, int at, int count)
{
    if (ms_nn_forward(j->nn, count, j->x + (size_t)at * ms_nn_input_size(j->nn),
                      j->y + (size_t)at * ms_nn_output_size(j->nn), j->workspace) != MS_OK)
        exit(1);
}

/* Seconds a sample of runs of count samples, `all` of them in all, so that alone or together they fill the same
   memory. */
static double sample(const job *j, int count, int all, int times)
{
    double start = bench_cpu();
    int i, at;
    for (i = 0; i < times; ++i)
        for (at = 0; at < all; at += count) run(j, at, count);
    return (bench_cpu() - start) / ((double)times * all);
}

static FILE *md;

static void measure(const char *name, const char *type, nets_file *f, int largest, ms_simd level, double most)
{
    ms_nn_options o = ms_nn_defaults();
    ms_error error;
    uint64_t state = 99;
    double macs = 0, alone = 0, worst = 0, last = 0, lowest = 1e30, rate;
    size_t in, out, i;
    int k, r, where = 0, times, reps;
    job j;
    o.simd = level;
    if (ms_nn_load(f->bytes, f->size, &o, &j.nn, &error) != MS_OK) {
        fprintf(stderr, "%s: %s\n", name, error.message);
        exit(1);
    }
    for (k = 0; k < ms_nn_layer_count(j.nn); ++k) macs += (double)ms_nn_layer_at(j.nn, k).multiply_adds;
    in = ms_nn_input_size(j.nn);
    out = ms_nn_output_size(j.nn);
    if (strcmp(ms_nn_layer_at(j.nn, 0).type, "shared_channels") == 0) macs *= 3;
    j.x = (float *)malloc((size_t)largest * in * sizeof(float));
    j.y = (float *)malloc((size_t)largest * out * sizeof(float));
    for (i = 0; i < (size_t)largest * in; ++i) j.x[i] = 0.5f + 0.5f * nets_uniform(&state);
    j.workspace = malloc(ms_nn_workspace_size(j.nn, MS_NN_FORWARD, largest));
    sample(&j, 1, 1, 1);
    times = (int)(3e-4 / sample(&j, 1, 1, 1)) + 1;
    for (k = 0; k < (int)COUNTS && counts[k] <= largest; ++k) {
        double a = 1e30, c = 1e30;
        reps = counts[k] < 100 ? 7 : 3;
        for (r = 0; r < reps; ++r) { /* in turn, the best of each: whatever disturbs them makes them slower */
            a = fmin(a, sample(&j, 1, counts[k], times / counts[k] + 1));
            c = fmin(c, sample(&j, counts[k], counts[k], times / counts[k] + 1));
        }
        lowest = fmin(lowest, a);
        last = c / a;
        alone = c;
        if (last > worst) {
            worst = last;
            where = counts[k];
        }
    }
    rate = macs / alone;
    printf("%-22s %-5s alone %9.1f us, worst %.2f at %4d, largest %.2f: %6.1f G/s %3.0f%%\n", name, type, 1e6 * lowest,
           worst, where, last, 1e-9 * rate, 100 * rate / most);
    fflush(stdout);
    fprintf(md, "| %s | %s | %.1f | %.2f (%d) | %.2f (%d) | %.1f | %.0f%% |\n", name, type, 1e6 * lowest, worst, where,
            last, largest, 1e-9 * rate, 100 * rate / most);
    free(j.workspace);
    free(j.x);
    free(j.y);
    ms_nn_destroy(j.nn);
}

/* A last layer that comes from memory. */
static int wide(nets_file *f, ms_nn_dtype dtype)
{
    nets_begin(f, "[1000]");
    nets_layer(f, "{\"type\":\"dense\",\"name\":\"fc\",\"units\":12288}", "fc", dtype, 2, 12288, 1000, 0, 0);
    return nets_end(f);
}

/* Four dense layers of 512. */
static int square(nets_file *f, ms_nn_dtype dtype)
{
    char json[120], name[16];
    int i;
    nets_begin(f, "[512]");
    for (i = 1; i <= 4; ++i) {
        snprintf(name, sizeof name, "fc%d", i);
        snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"%s\",\"units\":512,\"activation\":\"elu\"}", name);
        nets_layer(f, json, name, dtype, 2, 512, 512, 0, 0);
    }
    return nets_end(f);
}

/* 300 pictures of the network that ships: thread CPU time on one thread, the wall's on two; seconds, the best of
   several. */
static double previews(const char *path, ms_simd level, int threads)
{
    enum { COUNT = 300 };
    ms_nn_options o = ms_nn_defaults();
    uint64_t state = 3;
    double best = 1e30;
    float *x, *y;
    pool p;
    job j;
    int i;
    o.simd = level;
    if (threads > 1) {
        pool_start(&p, threads);
        o.parallel = pool_parallel(&p);
    }
    if (ms_nn_load_file(path, &o, &j.nn, NULL) != MS_OK) exit(1);
    j.x = x = (float *)malloc(COUNT * ms_nn_input_size(j.nn) * sizeof(float));
    j.y = y = (float *)malloc(COUNT * ms_nn_output_size(j.nn) * sizeof(float));
    j.workspace = malloc(ms_nn_workspace_size(j.nn, MS_NN_FORWARD, COUNT));
    for (i = 0; i < COUNT * (int)ms_nn_input_size(j.nn); ++i) x[i] = 0.5f + 0.5f * nets_uniform(&state);
    for (i = 0; i < 40; ++i) {
        double start = threads > 1 ? bench_wall() : bench_cpu();
        run(&j, 0, COUNT);
        best = fmin(best, (threads > 1 ? bench_wall() : bench_cpu()) - start);
    }
    ms_nn_destroy(j.nn);
    if (threads > 1) pool_stop(&p);
    free(x);
    free(y);
    free(j.workspace);
    return best;
}

int main(int argc, char **argv)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    static const char *const names[] = {"4 x 512", "shared, 64 x 64", "Conv1D, 32 x 32", "Conv2D from 64 x 64",
                                        "1000 to 12288, memory"};
    const char *only = argc > 1 ? argv[1] : "", *type = argc > 2 ? argv[2] : "";
    ms_simd level = argc > 3 ? ms__simd_pick((ms_simd)atoi(argv[3])) : ms__simd_pick(MS_SIMD_AUTO);
    nets_file *f = (nets_file *)malloc(sizeof *f);
    static const char *const shipped[2] = {"examples/data/preview_64.safetensors",
                                           "examples/data/renderer_64.safetensors"};
    double most = peak(level), one[2], two[2], macs[2];
    int k, t, bad;
    md = bench_open("nn_batch.md");
    fprintf(
        md,
        "%s, one thread, thread CPU time, the best of several runs in turn; `make bench FILTER=nn_batch`. Multiply-adds in registers alone: %.1f G/s.\n\n",
        bench_processor(), 1e-9 * most);
    fprintf(
        md,
        "| network | weights | one alone, us | slowest batch: a sample over one alone (samples) | the largest | G multiply-adds/s | of the peak |\n"
        "|---|---|---:|---:|---:|---:|---:|\n");
    printf("peak %.1f G/s\n", 1e-9 * most);
    for (k = 0; k < 2; ++k) {
        ms_nn *nn;
        int l;
        one[k] = previews(shipped[k], level, 1);
        two[k] = previews(shipped[k], level, 2);
        if (ms_nn_load_file(shipped[k], NULL, &nn, NULL) != MS_OK) return 1;
        for (macs[k] = 0, l = 0; l < ms_nn_layer_count(nn); ++l)
            macs[k] += 3.0 * (double)ms_nn_layer_at(nn, l).multiply_adds;
        ms_nn_destroy(nn);
        printf("300 previews by %s: %.1f ms, two threads (wall) %.1f\n", shipped[k], 1e3 * one[k], 1e3 * two[k]);
    }
    for (k = 0; k < 5; ++k)
        for (t = 0; t < 3; ++t) {
            if (!strstr(names[k], only) || !strstr(ms_nn_dtype_string(types[t]), type)) continue;
            if (k < 2) bad = k == 0 ? square(f, types[t]) : nets_shared(f, 64, 96, types[t]);
            else
                bad = k == 2 ? nets_renderer(f, 32, 32, 200, types[t])
                    : k == 3 ? nets_inversion(f, 8, 64, 19, types[t])
                             : wide(f, types[t]);
            if (bad) return 1;
            measure(names[k], ms_nn_dtype_string(types[t]), f, k == 0 ? MOST : k == 1 ? 300 : 49, level, most);
            free(f->bytes);
        }
    fprintf(
        md,
        "\n| 300 previews of 64 x 64, F16 | ms | at the rate of multiply-adds alone | of the peak | two threads, by the wall |\n|---|---:|---:|---:|---:|\n");
    for (k = 0; k < 2; ++k)
        fprintf(md, "| `%s` | %.1f | %.1f | %.0f%% | %.1f |\n", shipped[k], 1e3 * one[k], 300e3 * macs[k] / most,
                30000 * macs[k] / most / one[k], 1e3 * two[k]);
    fclose(md);
    free(f);
    return 0;
}
