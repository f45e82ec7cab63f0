/* The filter of ms_sss.h at 1920 x 1080: 7 taps beside a plain loop and a memory copy of the same run, masks, layouts,
   two threads, the pyramid. Build: see Makefile (make bench).
   peer source: opencv.cpp -lopencv_imgproc -lopencv_core */
#define MS_SSS_WITH_SCALAR /* the reference of the other levels */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "bench.h"
#include "plot.h"
#include "test.h"
#include "pool.h"

enum { W = 1920, H = 1080, N = W * H, RUNS = 7 };
static float *in[3], *out[3], *between[3], *expected[3], *depth, *mask, *packed, *packed_out, *packed_depth,
    *packed_between;
static ms_sss_kernel kernel, more[2],
    whole; /* 7 taps of 24 pixels in the middle of the picture; 17, 33; 7 at whole pixels */
static ms_sss_pyramid pyramid;

/* --- what it is compared with --- */

/* Of tap i: the center, then each pair at -offset and +offset. */
static float tap_mm(const ms_sss_kernel *k, int i) { return (i % 2 ? -1.0f : 1.0f) * k->offset_mm[(i + 1) / 2]; }

static void pass(float *const *from, float *const *to, int dx, int dy, int nearest)
{
    const float size = (float)H / (2 * tanf(17.5f * 3.14159265f / 180)),
                far = 3.0746f * 0.12f * kernel.profile_radius_mm;
    const float end = far < kernel.radius_mm ? far : kernel.radius_mm; /* the filter's law with flat 1 */
    int x, y, i, c, h;
    for (y = 0; y < H; ++y) {
        for (x = 0; x < W; ++x) {
            const float z = depth[y * W + x], pixels = size / z;
            float sum[3] = {0, 0, 0}, norm[3] = {0, 0, 0};
            for (i = 0; i < kernel.tap_count; ++i) {
                const float t = tap_mm(&kernel, i) * pixels;
                const int whole_part = (int)floorf(nearest ? t + 0.5f : t);
                for (h = 0; h < (nearest ? 1 : 2); ++h) {
                    const int px = x + dx * (whole_part + h), py = y + dy * (whole_part + h);
                    const float share = nearest ? 1 : h ? t - (float)whole_part : 1 - (t - (float)whole_part);
                    float dz, f;
                    if (px < 0 || py < 0 || px >= W || py >= H) continue;
                    dz = depth[py * W + px] - z;
                    if (!(fabsf(dz) < end)) continue;
                    f = 1 - dz * dz / (end * end);
                    f = share * f * f * f * f;
                    for (c = 0; c < 3; ++c) {
                        sum[c] += kernel.weight[0][(i + 1) / 2][c] * f * from[c][py * W + px];
                        norm[c] += kernel.weight[0][(i + 1) / 2][c] * f;
                    }
                }
            }
            for (c = 0; c < 3; ++c) to[c][y * W + x] = sum[c] / norm[c];
        }
    }
}

static void plain_linear(void *unused)
{
    (void)unused;
    pass(in, between, 1, 0, 0);
    pass(between, expected, 0, 1, 0);
}

static void plain_nearest(void *unused)
{
    (void)unused;
    pass(in, between, 1, 0, 1);
    pass(between, out, 0, 1, 1);
}

/* What one writes to be fast without intrinsics: color and depth in one vector of four floats, the two pixels beside a
   tap mixed before one expf, coordinates kept inside; -O3 for a processor with AVX2. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
__attribute__((optimize("O3"), target("avx2,fma")))
#endif
static void
packed_pass(const float *from, float *to, int dx, int dy)
{
    const float size = (float)H / (2 * tanf(17.5f * 3.14159265f / 180)), sigma = 0.12f * kernel.profile_radius_mm,
                k = -1 / (2 * sigma * sigma);
    int x, y, i, c;
    for (y = 0; y < H; ++y) {
        for (x = 0; x < W; ++x) {
            const float *own = from + 4 * (y * W + x);
            const float pixels = size / own[3];
            float sum[4] = {0, 0, 0, 0}, norm[4] = {0, 0, 0, 0};
            for (i = 0; i < kernel.tap_count; ++i) {
                const float t = tap_mm(&kernel, i) * pixels, whole_part = floorf(t), r = t - whole_part;
                const int p = (int)whole_part, limit = dx ? W - 1 : H - 1, at = dx ? x : y;
                const int a = at + p < 0 ? 0
                    : at + p > limit     ? limit
                                         : at + p,
                          b = at + p + 1 < 0 ? 0
                    : at + p + 1 > limit     ? limit
                                             : at + p + 1;
                const float *u = own + 4 * (dx * (a - x) + dy * W * (a - y)),
                            *v = own + 4 * (dx * (b - x) + dy * W * (b - y));
                float mix[4], f;
                for (c = 0; c < 4; ++c) mix[c] = u[c] + r * (v[c] - u[c]);
                f = expf((mix[3] - own[3]) * (mix[3] - own[3]) * k);
                for (c = 0; c < 4; ++c) {
                    const float w = kernel.weight[0][(i + 1) / 2][c < 3 ? c : 0] * f;
                    sum[c] += w * mix[c];
                    norm[c] += w;
                }
            }
            for (c = 0; c < 3; ++c) to[4 * (y * W + x) + c] = sum[c] / norm[c];
            to[4 * (y * W + x) + 3] = own[3];
        }
    }
}

static void plain_packed(void *unused)
{
    (void)unused;
    packed_pass(packed_depth, packed_between, 1, 0);
    packed_pass(packed_between, packed_out, 0, 1);
}

static void copies(void *unused) /* what two passes must read and write at least */
{
    int c;
    (void)unused;
    for (c = 0; c < 3; ++c) memcpy(between[c], in[c], (size_t)N * sizeof(float));
    for (c = 0; c < 3; ++c) memcpy(out[c], between[c], (size_t)N * sizeof(float));
}

#ifdef HAVE_OPENCV
void opencv_offsets(float *const in_[3], float *const out_[3], int width, int height, int reach,
                    const float *const taps[3]);
void opencv_gaussian(const float *in_, float *out_, int width, int height, int size, double sigma);

/* The taps at whole pixels as rows of 49 coefficients; difference: to the filter's result in `expected`, away from the
   borders. */
static void opencv(double ms[2], double *difference)
{
    float rows[3][49] = {{0}};
    const float *taps[3];
    double t[2][RUNS];
    int c, i, x, y;
    *difference = 0;
    for (c = 0; c < 3; ++c) {
        double sum = 0;
        taps[c] = rows[c];
        for (i = 0; i < whole.tap_count; ++i) sum += (double)whole.weight[0][(i + 1) / 2][c];
        for (i = 0; i < whole.tap_count; ++i)
            rows[c][24 + (int)floorf(tap_mm(&whole, i) * 24 / whole.radius_mm + 0.5f)] +=
                whole.weight[0][(i + 1) / 2][c] / (float)sum;
    }
    for (i = 0; i < RUNS; ++i) {
        t[0][i] = bench_cpu();
        opencv_offsets(in, out, W, H, 24, taps);
        t[0][i] = bench_cpu() - t[0][i];
        t[1][i] = bench_cpu();
        opencv_gaussian(packed, packed_out, W, H, 49, 8);
        t[1][i] = bench_cpu() - t[1][i];
    }
    for (c = 0; c < 3; ++c)
        for (y = 24; y < H - 24; ++y)
            for (x = 24; x < W - 24; ++x) {
                const double d = fabs((double)out[c][y * W + x] - (double)expected[c][y * W + x]);
                if (!(d <= *difference)) *difference = d;
            }
    for (i = 0; i < 2; ++i) ms[i] = 1e3 * bench_median(t[i], RUNS);
}
#endif

/* --- the filter --- */

typedef struct setup {
    int by_pyramid;
    ms_sss_frame frame;
    ms_sss_filter_options options;
    const ms_sss_kernel *kernel;
    void *workspace;
    size_t size;
} setup;

enum {
    DEPTH = 1,
    MASK = 2,
    IN_PLACE = 4,
    RGB = 8,
    RGBZ = 16,
    PYRAMID = 64,
    DELTA = 128,
    SHAPED = 256,
    WIDE = 1024,
    TAPS17 = 2048,
    TAPS33 = 4096
};

static setup prepare(int kind, ms_simd level)
{
    setup s;
    memset(&s, 0, sizeof s);
    s.kernel = kind & TAPS17 ? &more[0] : kind & TAPS33 ? &more[1] : kind & (DEPTH | DELTA) ? &kernel : &whole;
    s.options.simd = level;
    s.options.flat = kind & SHAPED ? 0.0f : 1.0f;
    s.by_pyramid = (kind & PYRAMID) != 0;
    s.frame.width = W;
    s.frame.height = H;
    s.frame.input = ms_sss_planar(in[0], in[1], in[2]);
    s.frame.output = ms_sss_planar(out[0], out[1], out[2]);
    if (kind & RGB) {
        s.frame.input = ms_sss_interleaved(packed, 3);
        s.frame.output = ms_sss_interleaved(packed_out, 3);
    }
    if (kind & RGBZ) {
        s.frame.input = ms_sss_interleaved(packed, 4);
        s.frame.output = ms_sss_interleaved(packed_out, 4);
    }
    if (kind & IN_PLACE) s.frame.output = s.frame.input;
    if (kind & DEPTH) {
        s.frame.depth = ms_sss_map(depth, 1);
        s.options.fov_degrees = 35;
        s.options.mm_per_unit = kind & WIDE ? 0.096f
            : kind & PYRAMID                ? 0.375f
                                            : 1; /* radius 250 or 64 pixels instead of 24 */
    } else {
        s.options.pixels_per_mm[0] = (kind & PYRAMID ? 64 : 24) / kernel.radius_mm;
    }
    if (kind & MASK) s.frame.strength = ms_sss_map(mask, 1);
    s.size = s.by_pyramid ? ms_sss_pyramid_workspace(W, H) : ms_sss_filter_workspace(W, H, s.kernel, 1, &s.options);
    s.workspace = malloc(s.size);
    return s;
}

static void filter(void *context)
{
    setup *s = (setup *)context;
    ms_error error;
    ms_status status = s->by_pyramid
        ? ms_sss_pyramid_filter(&s->frame, &pyramid, 1, &s->options, s->workspace, s->size, &error)
        : ms_sss_filter(&s->frame, s->kernel, 1, &s->options, s->workspace, s->size, &error);
    if (status != MS_OK) {
        fprintf(stderr, "bench_sss_filter: %s\n", error.message);
        exit(1);
    }
}

static bench_time time_of(int kind, ms_simd level, int runs)
{
    setup s = prepare(kind, level);
    bench_time t = bench_run(filter, &s, runs);
    free(s.workspace);
    return t;
}

static void own_call(void *calls, int index) { filter((setup *)calls + index); }

/* How much less time than one thread two take by the wall, in turn in one loop; and what two calls at once, each with a
   workspace and a thread of its own, gain over one after the other: what the machine gives to two threads at that
   minute. */
static void two_threads(int kind, FILE *to)
{
    setup s[3];
    pool p;
    double one[RUNS], two[RUNS], apart[RUNS], gain[RUNS], most[RUNS];
    float *second[3];
    int i, c;
    for (i = 0; i < 3; ++i) s[i] = prepare(kind, MS_SIMD_AUTO);
    pool_start(&p, 2);
    s[2].options.parallel = pool_parallel(&p);
    for (c = 0; c < 3; ++c) second[c] = (float *)malloc((size_t)N * sizeof(float));
    s[1].frame.output = ms_sss_planar(second[0], second[1], second[2]);
    for (i = -1; i < RUNS; ++i) {
        const int at = i < 0 ? 0 : i; /* the first is not counted */
        one[at] = bench_wall();
        filter(&s[0]);
        one[at] = bench_wall() - one[at];
        two[at] = bench_wall();
        filter(&s[2]);
        two[at] = bench_wall() - two[at];
        apart[at] = bench_wall();
        s[2].options.parallel.run(&p, 2, own_call, s);
        apart[at] = bench_wall() - apart[at];
        gain[at] = one[at] / two[at];
        most[at] = 2 * one[at] / apart[at];
    }
    pool_stop(&p);
    for (c = 0; c < 3; ++c) free(second[c]);
    for (i = 0; i < 3; ++i) free(s[i].workspace);
    fprintf(to, " %.2f (%.2f) |", bench_median(gain, RUNS), bench_median(most, RUNS));
}

static void make_inputs(void)
{
    static const double variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
    static const double weight[6][3] = {{0.233, 0.455, 0.649}, {0.1, 0.336, 0.344}, {0.118, 0.198, 0},
                                        {0.113, 0.007, 0.007}, {0.358, 0.004, 0},   {0.078, 0, 0}}; /* d'Eon's skin */
    double sigma[6][3];
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_profile *profile;
    int i, c, x, y;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(variance[i]);
    o.no_delta = 1;
    if (ms_sss_profile_from_gaussians(&profile, 6, (const double(*)[3])sigma, weight, NULL, NULL) != MS_OK ||
        ms_sss_kernel_make(&kernel, NULL, profile, 24, &o, NULL, NULL) != MS_OK ||
        ms_sss_pyramid_make(&pyramid, profile, NULL) != MS_OK)
        exit(1);
    for (i = 0; i < 2; ++i) {
        o.tap_count = i == 0 ? 17 : 33;
        if (ms_sss_kernel_make(&more[i], NULL, profile, 24, &o, NULL, NULL) != MS_OK) exit(1);
    }
    ms_sss_profile_destroy(profile);
    whole = kernel;
    for (i = 0; i <= kernel.tap_count / 2; ++i)
        whole.offset_mm[i] = floorf(kernel.offset_mm[i] * 24 / kernel.radius_mm + 0.5f) * kernel.radius_mm / 24;
    for (c = 0; c < 3; ++c) {
        in[c] = (float *)malloc((size_t)N * sizeof(float));
        out[c] = (float *)malloc((size_t)N * sizeof(float));
        between[c] = (float *)malloc((size_t)N * sizeof(float));
        expected[c] = (float *)malloc((size_t)N * sizeof(float));
    }
    depth = (float *)malloc((size_t)N * sizeof(float));
    mask = (float *)malloc((size_t)N * sizeof(float));
    packed = (float *)malloc((size_t)N * 4 * sizeof(float));
    packed_out = (float *)malloc((size_t)N * 4 * sizeof(float));
    packed_depth = (float *)malloc((size_t)N * 4 * sizeof(float));
    packed_between = (float *)malloc((size_t)N * 4 * sizeof(float));
    for (y = 0; y < H; ++y) {
        for (x = 0; x < W; ++x) { /* a ball in front of a wall; the mask: a disc that covers a quarter */
            const double u = (x - W / 2) / 540.0, v = (y - H / 2) / 540.0, r = 0.8 - u * u - v * v;
            i = y * W + x;
            depth[i] = (float)((r > 0 ? 100 - 20 * sqrt(r) : 130 + 5 * u) * (double)kernel.radius_mm / 1.25);
            mask[i] = u * u + v * v < 0.5659 ? 1.0f : 0.0f;
            for (c = 0; c < 4; ++c) {
                const float value = (float)(((uint32_t)i * 2654435761u >> (8 + c)) & 255u) / 255 + 0.1f;
                if (c < 3) in[c][i] = value;
                packed_depth[4 * i + c] = c < 3 ? value : depth[i];
                packed[4 * i + c] = value;
            }
        }
    }
}

int main(void)
{
    static const struct row {
        const char *name;
        int kind;
    } rows[] = {
        {"**depth-aware, flat, planar**", DEPTH},
        {"**depth-aware with slope and elevation, planar (default)**", DEPTH | SHAPED},
        {"the same, 17 taps", DEPTH | SHAPED | TAPS17},
        {"the same, 33 taps", DEPTH | SHAPED | TAPS33},
        {"depth-aware, RGB + depth packed", DEPTH | RGBZ},
        {"depth-aware, a quarter masked in", DEPTH | MASK},
        {"the same in place", DEPTH | MASK | IN_PLACE},
        {"texture space, whole-pixel offsets, planar", 0},
        {"texture space, offsets between pixels", DELTA},
        {"texture space, RGB", RGB},
        {"texture space, a quarter masked in, in place", MASK | IN_PLACE},
        {"pyramid, R 64 px, no depth", PYRAMID},
        {"pyramid, R 64 px, depth", PYRAMID | DEPTH},
        {"pyramid, R 250 px, depth", PYRAMID | DEPTH | WIDE},
        {"pyramid, R 64 px, slope and elevation", PYRAMID | DEPTH | SHAPED},
        {"pyramid, R 64 px, depth, a quarter masked in", PYRAMID | DEPTH | MASK},
    };
    static const int threaded[] = {DEPTH, DEPTH | SHAPED, 0, PYRAMID | DEPTH, PYRAMID | DEPTH | MASK};
    enum { ROWS = sizeof rows / sizeof rows[0] };
    static const ms_simd levels[4] = {MS_SIMD_SCALAR, MS_SIMD_BASE, MS_SIMD_AVX2, MS_SIMD_AVX512};
    static plot p;
    FILE *csv = bench_open("sss_filter.csv"), *md = bench_open("sss_filter.md");
    bench_time linear, nearest, honest, copy, t[ROWS][4];
    double worst = 0, pixels = (double)N * 1e-6;
    int r, l, c, i;
    make_inputs();
    linear = bench_run(plain_linear, NULL, 1);
    honest = bench_run(plain_packed, NULL, 5);
    copy = bench_run(copies, NULL, RUNS);
    fprintf(csv,
            "setting,level,ms,spread_ms\nplain loop with linear taps,compiler,%.3f,%.3f\ncopies,memcpy,%.3f,%.3f\n",
            1e3 * linear.median, 1e3 * linear.spread, 1e3 * copy.median, 1e3 * copy.spread);
    for (r = 0; r < ROWS; ++r) {
        for (l = 0; l < 4; ++l) {
            setup check;
            t[r][l].median = 0;
            if (ms__simd_pick(levels[l]) != levels[l]) continue;
            if (rows[r].kind & IN_PLACE)
                for (c = 0; c < 3; ++c) memcpy(between[c], in[c], (size_t)N * sizeof(float)); /* put back below */
            t[r][l] = time_of(rows[r].kind, levels[l], l == 0 ? 1 : l == 1 ? 3 : RUNS);
            if (rows[r].kind & IN_PLACE)
                for (c = 0; c < 3; ++c) memcpy(in[c], between[c], (size_t)N * sizeof(float));
            fprintf(csv, "%s,%s,%.3f,%.3f\n", rows[r].name, ms_simd_string(levels[l]), 1e3 * t[r][l].median,
                    1e3 * t[r][l].spread);
            if (r > 0) continue;
            check = prepare(DEPTH, levels[l]); /* the same picture as the plain loop's */
            filter(&check);
            free(check.workspace);
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i)
                    if (!(fabs((double)out[c][i] - (double)expected[c][i]) <= worst))
                        worst = fabs((double)out[c][i] - (double)expected[c][i]);
        }
    }
    nearest = bench_run(plain_nearest, NULL, 1);
    fprintf(
        md,
        "%s, %s -O2, 1920 x 1080, one core, medians of %d runs (scalar 1, SSE2 3), `make bench FILTER=sss_filter`. 7 taps of d'Eon's skin, R = 24 pixels.\n"
        "**The peer**: a loop over packed color and depth, one expf a tap, gcc -O3 for AVX2: %.0f +- %.0f ms. The same sums as\n"
        "here pixel by pixel in planes, -O2: %.0f ms (largest difference %.0e); reading the nearest pixel only: %.0f ms.\n"
        "Copying what two passes read and write: %.2f ms.\n"
        "\n"
        "| setting | scalar ms | SSE2/NEON | AVX2 | AVX-512 | x the peer (AVX2) | x copies (AVX2) |\n|---|---:|---:|---:|---:|---:|---:|\n",
        bench_processor(),
#if defined(__clang__)
        "clang",
#else
        "gcc",
#endif
        RUNS, 1e3 * honest.median, 1e3 * honest.spread, 1e3 * linear.median, worst, 1e3 * nearest.median,
        1e3 * copy.median);
    for (r = 0; r < ROWS; ++r) {
        fprintf(md, "| %s |", rows[r].name);
        for (l = 0; l < 4; ++l) {
            if (t[r][l].median > 0) fprintf(md, " %.2f +- %.2f |", 1e3 * t[r][l].median, 1e3 * t[r][l].spread);
            else fprintf(md, " - |");
        }
        if (t[r][2].median > 0)
            fprintf(md, " %.1f | %.2f |\n", honest.median / t[r][2].median, t[r][2].median / copy.median);
        else fprintf(md, " - | - |\n");
    }
    fprintf(
        md,
        "\nTwo threads against one, by the wall, medians of pairs; in brackets two calls at once, each with its own thread and workspace, against one after\n"
        "the other: what the machine gives to two threads.\n\n"
        "| taps | slope and elevation | texture space | pyramid | pyramid, a quarter masked in |\n|---:|---:|---:|---:|---:|\n|");
    for (r = 0; r < (int)(sizeof threaded / sizeof *threaded); ++r) two_threads(threaded[r], md);
    fprintf(md, "\n");
#ifdef HAVE_OPENCV
    {
        setup same = prepare(0, MS_SIMD_AUTO);
        double ms[2], difference;
        same.frame.output = ms_sss_planar(expected[0], expected[1], expected[2]);
        filter(&same);
        free(same.workspace);
        opencv(ms, &difference);
        fprintf(
            md,
            "\nOpenCV's sepFilter2D with the same 7 whole-pixel offsets (rows of 49 coefficients): %.1f ms, largest difference %.0e; its\n"
            "Gaussian of 49 x 49, one width for all channels: %.1f ms (thread CPU time).\n",
            ms[0], difference, ms[1]);
    }
#endif
    plot_begin(&p, "Filter, 1920 x 1080, 7 taps", "level (0 plain loop, 1 scalar ... 4 AVX-512)", "megapixels a second",
               PLOT_LOG_Y);
    for (r = 0; r < ROWS; ++r) {
        double x[5], y[5];
        int n = 0;
        if (rows[r].kind != DEPTH && rows[r].kind != 0 && rows[r].kind != (PYRAMID | DEPTH)) continue;
        if (rows[r].kind == DEPTH) {
            x[n] = 0;
            y[n++] = pixels / linear.median;
        }
        for (l = 0; l < 4; ++l) {
            if (!(t[r][l].median > 0)) continue;
            x[n] = l + 1;
            y[n++] = pixels / t[r][l].median;
        }
        plot_series(&p,
                    rows[r].kind == DEPTH ? "depth-aware"
                        : rows[r].kind    ? "pyramid"
                                          : "texture space",
                    x, y, n, PLOT_LINE);
    }
    plot_write(&p, "build/bench/sss_filter.svg");
    fclose(csv);
    fclose(md);
    md = fopen("build/bench/sss_filter.md", "r");
    while (md && (c = getc(md)) != EOF) putchar(c);
    if (md) fclose(md);
    return 0;
}
