/* ms_sss_filter on pictures such as a renderer makes, beside two loops that a good programmer writes (sss_peers.cpp): a
   bust, a crowd of heads, leaves, hair, anti-aliased edges, a head at 4K, a face from nearby, a close-up. All are made
   here. Build: see Makefile (make bench).
   peer source: sss_peers.cpp -lm */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "bench.h"
#include "../../examples/demo/scene.h"

enum { RUNS = 5, PICTURES = 9 };

/* [height][width][4]: linear RGB and depth in mm, 0 where nothing scatters */
typedef struct picture {
    const char *name;
    int width, height;
    float radius_px; /* of the kernel at the median depth */
    float *texels;
} picture;

static ms_sss_kernel kernel;
static ms_sss_pyramid pyramid;

static float *texels_new(int width, int height)
{
    float *p = (float *)calloc((size_t)width * (size_t)height * 4, sizeof *p);
    if (p == NULL) exit(1);
    return p;
}

static picture picture_new(const char *name, int width, int height, float radius_px)
{
    picture p;
    p.name = name;
    p.width = width;
    p.height = height;
    p.radius_px = radius_px;
    p.texels = texels_new(width, height);
    return p;
}

static float random_of(uint32_t *state) /* [0, 1) */
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f;
}

/* --- the pictures --- */

static picture full_screen(void)
{
    picture p = picture_new("ball and wall, full screen", 1920, 1080, 24);
    int x, y, c;
    for (y = 0; y < p.height; ++y)
        for (x = 0; x < p.width; ++x) {
            float *t = p.texels + 4 * (y * p.width + x);
            const float u = (float)(x - 960) / 540, v = (float)(y - 540) / 540, r = 0.8f - u * u - v * v;
            t[3] = r > 0 ? 800 - 160 * sqrtf(r) : 1040 + 40 * u;
            for (c = 0; c < 3; ++c)
                t[c] = (float)(((uint32_t)(y * p.width + x) * 2654435761u >> (8 + c)) & 255u) / 255 + 0.1f;
        }
    return p;
}

static picture bust(void)
{
    static const float skin[3] = {0.44f, 0.22f, 0.13f};
    picture p = picture_new("bust", 1920, 1080, 24);
    scene s;
    int i, c;
    if (scene_render(&s, SCENE_BUST, p.width, p.height, skin) != NULL) exit(1);
    for (i = 0; i < p.width * p.height; ++i) {
        if (!(s.mask.pixels[i] > 0)) continue;
        for (c = 0; c < 3; ++c) p.texels[4 * i + c] = s.irradiance.pixels[3 * i + c];
        p.texels[4 * i + 3] = s.depth.pixels[i];
    }
    scene_free(&s);
    return p;
}

/* Nearest texel of `from`, `scale` times as large, drawn over what lies behind it, with its left upper corner at (x0,
   y0); `nearer` is subtracted from its depth. */
static void stamp(picture *to, const picture *from, int x0, int y0, float scale, float nearer)
{
    const int w = (int)((float)from->width * scale), h = (int)((float)from->height * scale);
    int x, y;
    for (y = y0 < 0 ? -y0 : 0; y < h && y + y0 < to->height; ++y)
        for (x = x0 < 0 ? -x0 : 0; x < w && x + x0 < to->width; ++x) {
            const float *f = from->texels + 4 * ((int)((float)y / scale) * from->width + (int)((float)x / scale));
            float *t = to->texels + 4 * ((y + y0) * to->width + x + x0);
            if (!(f[3] > 0) || (t[3] > 0 && t[3] < f[3] - nearer)) continue;
            memcpy(t, f, 4 * sizeof *t);
            t[3] -= nearer;
        }
}

static picture crowd(const picture *one)
{
    picture p = picture_new("40 heads", 1920, 1080, 24);
    uint32_t state = 7;
    int i;
    for (i = 0; i < 40; ++i) {
        const float near_ = (float)i * 6;
        const int x = (int)(random_of(&state) * 2400) - 600, y = (int)(random_of(&state) * 1000) - 250;
        stamp(&p, one, x, y, 0.3f + 0.003f * (float)i, near_);
    }
    return p;
}

static picture leaves(void) /* 2500 ellipses, inclined and lit each in its own way */
{
    picture p = picture_new("leaves", 1920, 1080, 24);
    uint32_t state = 11;
    int i, x, y, c;
    for (i = 0; i < 2500; ++i) {
        const float cx = random_of(&state) * 1920, cy = random_of(&state) * 1080, z = 600 + 200 * random_of(&state);
        const float angle = 6.2832f * random_of(&state), size = 15 + 25 * random_of(&state);
        const float sx = random_of(&state) - 0.5f, sy = random_of(&state) - 0.5f, light = random_of(&state);
        for (y = (int)(cy - size); y <= (int)(cy + size); ++y)
            for (x = (int)(cx - size); x <= (int)(cx + size); ++x) {
                const float dx = (float)x - cx, dy = (float)y - cy;
                const float u = (cosf(angle) * dx + sinf(angle) * dy) / size,
                            v = (cosf(angle) * dy - sinf(angle) * dx) / (0.4f * size);
                const float d = z + 0.5f * (sx * dx + sy * dy);
                float *t;
                if (x < 0 || y < 0 || x >= p.width || y >= p.height || u * u + v * v > 1) continue;
                t = p.texels + 4 * (y * p.width + x);
                if (t[3] > 0 && t[3] < d) continue;
                t[3] = d;
                for (c = 0; c < 3; ++c) t[c] = light * (c == 1 ? 0.9f : 0.5f) + (fabsf(v) < 0.08f ? 0.3f : 0.0f);
            }
    }
    return p;
}

static picture hair(void) /* 6000 curved strands, one to three pixels wide, before a head */
{
    picture p = picture_new("hair", 1920, 1080, 24);
    uint32_t state = 13;
    int i, x, y, c, k;
    for (y = 0; y < p.height; ++y)
        for (x = 0; x < p.width; ++x) {
            const float u = (float)(x - 960) / 500, v = (float)(y - 540) / 500, r = 1 - u * u - v * v;
            float *t = p.texels + 4 * (y * p.width + x);
            if (!(r > 0)) continue;
            t[3] = 700 - 90 * sqrtf(r);
            for (c = 0; c < 3; ++c) t[c] = 0.2f + 0.6f * sqrtf(r) * (u < 0 ? 1.0f : 0.4f);
        }
    for (i = 0; i < 6000; ++i) {
        float at[2] = {400 + 1120 * random_of(&state), 700 * random_of(&state)};
        float bend = 0.02f * (random_of(&state) - 0.5f), angle = 1.57f + 0.8f * (random_of(&state) - 0.5f);
        const float z = 560 + 60 * random_of(&state), light = random_of(&state);
        const int wide = 1 + (int)(3 * random_of(&state)), length = 200 + (int)(300 * random_of(&state));
        for (k = 0; k < length; ++k) {
            for (x = (int)at[0]; x < (int)at[0] + wide; ++x) {
                float *t;
                y = (int)at[1];
                if (x < 0 || y < 0 || x >= p.width || y >= p.height) continue;
                t = p.texels + 4 * (y * p.width + x);
                if (t[3] > 0 && t[3] < z) continue;
                t[3] = z;
                for (c = 0; c < 3; ++c) t[c] = light * (0.4f + 0.1f * (float)c);
            }
            at[0] += cosf(angle);
            at[1] += sinf(angle);
            angle += bend;
        }
    }
    return p;
}

/* The mean over 3 x 3 pixels of a grid of spheres, background included: at outlines depth is between the two. */
static picture antialiased(void)
{
    picture p = picture_new("edges by multisampling", 1920, 1080, 24);
    int x, y, i, c;
    for (y = 0; y < p.height; ++y)
        for (x = 0; x < p.width; ++x) {
            float *t = p.texels + 4 * (y * p.width + x);
            for (i = 0; i < 9; ++i) {
                const float px = (float)x + (float)(i % 3) / 3, py = (float)y + (float)(i / 3) / 3;
                const float u = fmodf(px, 160) / 80 - 1, v = fmodf(py, 160) / 80 - 1, r = 0.9f - u * u - v * v;
                const float light = r > 0 ? 0.1f + 0.9f * fmaxf(0, 0.6f * sqrtf(r) - 0.7f * u) : 0.15f;
                t[3] += (r > 0 ? 800 - 30 * sqrtf(r) : 900) / 9;
                for (c = 0; c < 3; ++c) t[c] += light * (1 - 0.2f * (float)c) / 9;
            }
        }
    return p;
}

/* Part of a picture from (x0, y0) on, `scale` times as large, linear between texels of the object. */
static picture enlarged(const char *name, const picture *from, int width, int height, int x0, int y0, float scale,
                        float radius_px)
{
    picture p = picture_new(name, width, height, radius_px);
    int x, y, c;
    for (y = 0; y < height; ++y)
        for (x = 0; x < width; ++x) {
            const float u = (float)x0 + (float)x / scale, v = (float)y0 + (float)y / scale;
            const int i = (int)u < from->width - 2 ? (int)u : from->width - 2,
                      j = (int)v < from->height - 2 ? (int)v : from->height - 2;
            const float a = u - (float)i, b = v - (float)j, *t = from->texels + 4 * (j * from->width + i),
                        *s = t + 4 * from->width;
            float *to = p.texels + 4 * (y * width + x);
            if (!(t[3] > 0 && t[7] > 0 && s[3] > 0 && s[7] > 0)) continue;
            for (c = 0; c < 4; ++c)
                to[c] = (1 - b) * ((1 - a) * t[c] + a * t[4 + c]) + b * ((1 - a) * s[c] + a * s[4 + c]);
        }
    return p;
}

/* --- times --- */

extern
#ifdef __cplusplus
    "C"
#endif
    void
    sss_peer(int polynomial, int taps, const float *offset, const float (*weight)[4], const float *in, float *between,
             float *out, int width, int height, float size, float k);

typedef struct run {
    const picture *shown;
    ms_sss_frame frame;
    ms_sss_filter_options options;
    float *between, *out, weight[MS_SSS_TAPS_MAX][4], offset[MS_SSS_TAPS_MAX], size, k;
    int polynomial, by_pyramid;
    void *workspace;
    size_t bytes;
} run;

static void filter(void *context)
{
    run *r = (run *)context;
    ms_error error;
    const ms_status status = r->by_pyramid
        ? ms_sss_pyramid_filter(&r->frame, &pyramid, 1, &r->options, r->workspace, r->bytes, &error)
        : ms_sss_filter(&r->frame, &kernel, 1, &r->options, r->workspace, r->bytes, &error);
    if (status == MS_OK) return;
    fprintf(stderr, "bench_sss_pictures: %s\n", error.message);
    exit(1);
}

#ifdef HAVE_SSS_PEERS
static void peer(void *context)
{
    const run *r = (const run *)context;
    sss_peer(r->polynomial, kernel.tap_count, r->offset, (const float(*)[4])r->weight, r->shown->texels, r->between,
             r->out, r->shown->width, r->shown->height, r->size, r->k);
}
#endif

static float median_depth(const picture *p, int *count)
{
    double *z = (double *)malloc((size_t)p->width * (size_t)p->height * sizeof *z), middle;
    int i;
    *count = 0;
    for (i = 0; i < p->width * p->height; ++i)
        if (p->texels[4 * i + 3] > 0) z[(*count)++] = (double)p->texels[4 * i + 3];
    middle = bench_median(z, *count);
    free(z);
    return (float)middle;
}

static run prepare(const picture *p, int *count)
{
    const float size = (float)p->height / (2 * tanf(12 * 3.14159265f / 180)); /* pixels of one unit at depth 1 */
    const float z = median_depth(p, count), sigma = 0.12f * kernel.profile_radius_mm;
    run r;
    int i, c;
    memset(&r, 0, sizeof r);
    r.shown = p;
    r.out = texels_new(p->width, p->height);
    r.between = texels_new(p->width, p->height);
    r.frame.width = p->width;
    r.frame.height = p->height;
    r.frame.input = ms_sss_interleaved(p->texels, 4);
    r.frame.output = ms_sss_interleaved(r.out, 4);
    r.frame.depth = ms_sss_map(p->texels + 3, 4);
    r.options = ms_sss_filter_defaults();
    r.options.fov_degrees = 24;
    r.options.mm_per_unit = kernel.radius_mm * size / (z * p->radius_px);
    r.size = size / r.options.mm_per_unit;
    r.k = 0.5f * r.options.mm_per_unit * r.options.mm_per_unit / (sigma * sigma);
    for (i = 0; i < kernel.tap_count; ++i) { /* the center, then each pair at -offset and +offset */
        r.offset[i] = (i % 2 ? -1.0f : 1.0f) * kernel.offset_mm[(i + 1) / 2];
        for (c = 0; c < 4; ++c) r.weight[i][c] = kernel.weight[0][(i + 1) / 2][c < 3 ? c : 0];
    }
    return r;
}

enum { WAYS = 6, FLAT_AVX2 = 2, TAPS_AVX2 };

/* Medians in ms; the peers' in [0] (expf) and [1] (polynomial), 0 where they were not built or this processor has no such level. */
static void measure(const picture *p, double ms[2 + WAYS], int *count)
{
    static const struct {
        int by_pyramid;
        float flat;
        ms_simd level;
    } ways[WAYS] = {{0, 1, MS_SIMD_AVX2},   {0, 0, MS_SIMD_AVX2},   {1, 0, MS_SIMD_AVX2},
                    {0, 1, MS_SIMD_AVX512}, {0, 0, MS_SIMD_AVX512}, {1, 0, MS_SIMD_AVX512}};
    run r = prepare(p, count);
    int i;
    ms[0] = ms[1] = 0;
#ifdef HAVE_SSS_PEERS
    for (r.polynomial = 0; r.polynomial < 2; ++r.polynomial) ms[r.polynomial] = 1e3 * bench_run(peer, &r, RUNS).median;
#endif
    for (i = 0; i < WAYS; ++i) {
        ms[2 + i] = 0;
        if (ms__simd_pick(ways[i].level) != ways[i].level) continue;
        r.options.simd = ways[i].level;
        r.by_pyramid = ways[i].by_pyramid;
        r.options.flat = ways[i].flat;
        r.bytes = r.by_pyramid ? ms_sss_pyramid_workspace(p->width, p->height)
                               : ms_sss_filter_workspace(p->width, p->height, &kernel, 1, &r.options);
        r.workspace = malloc(r.bytes);
        ms[2 + i] = 1e3 * bench_run(filter, &r, RUNS).median;
        free(r.workspace);
    }
    free(r.out);
    free(r.between);
}

static void make_kernel(void)
{
    static const double variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
    static const double weight[6][3] = {{0.233, 0.455, 0.649}, {0.1, 0.336, 0.344}, {0.118, 0.198, 0},
                                        {0.113, 0.007, 0.007}, {0.358, 0.004, 0},   {0.078, 0, 0}}; /* d'Eon's skin */
    double sigma[6][3];
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_profile *profile;
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(variance[i]);
    o.no_delta = 1;
    if (ms_sss_profile_from_gaussians(&profile, 6, (const double(*)[3])sigma, weight, NULL, NULL) != MS_OK ||
        ms_sss_kernel_make(&kernel, NULL, profile, 24, &o, NULL, NULL) != MS_OK ||
        ms_sss_pyramid_make(&pyramid, profile, NULL) != MS_OK)
        exit(1);
    ms_sss_profile_destroy(profile);
}

int main(void)
{
    FILE *md = bench_open("sss_pictures.md"), *csv = bench_open("sss_pictures.csv");
    picture p[PICTURES];
    int i, k, c;
    make_kernel();
    p[0] = full_screen();
    p[1] = bust();
    p[2] = crowd(&p[1]);
    p[3] = leaves();
    p[4] = hair();
    p[5] = antialiased();
    p[6] = enlarged("bust at 4K", &p[1], 3840, 2160, 0, 0, 2, 24);
    p[7] = enlarged("face, R 100", &p[1], 1920, 1080, 720, 200, 3, 100);
    p[8] = enlarged("close-up of 200 x 200, R 48", &p[1], 200, 200, 900, 350, 4, 48);
    fprintf(
        csv,
        "picture,pixels,peer_exp,peer_polynomial,flat_avx2,taps_avx2,pyramid_avx2,flat_avx512,taps_avx512,pyramid_avx512\n");
    fprintf(
        md,
        "%s, one thread, medians of %d runs in ms, `make bench FILTER=sss_pictures`. d'Eon's skin, 7 taps; R is the kernel's\n"
        "radius in pixels at the median depth (24 where nothing else is said). The peers are loops over packed color and depth\n"
        "that skip masked pixels, gcc -O3 -march=native -ffast-math; they know no slopes. Ours at AVX2 / AVX-512; last, the polynomial\n"
        "peer's time over that of the taps.\n\n"
        "| picture | pixels | peer, expf | peer, polynomial | taps, flat | **taps** | pyramid | peer / taps |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|\n",
        bench_processor(), RUNS);
    for (i = 0; i < PICTURES; ++i) {
        double ms[2 + WAYS];
        int count;
        measure(&p[i], ms, &count);
        fprintf(csv, "%s,%d", p[i].name, count);
        for (k = 0; k < 2 + WAYS; ++k) fprintf(csv, ",%.3f", ms[k]);
        fprintf(csv, "\n");
        fprintf(md, "| %s | %d | %.2f | %.2f |", p[i].name, count, ms[0], ms[1]);
        for (k = FLAT_AVX2; k < FLAT_AVX2 + WAYS / 2; ++k)
            fprintf(md, k == TAPS_AVX2 ? " **%.2f** / %.2f |" : " %.2f / %.2f |", ms[k], ms[k + WAYS / 2]);
        fprintf(md, " %.2f / %.2f |\n", ms[1] / ms[TAPS_AVX2],
                ms[TAPS_AVX2 + WAYS / 2] > 0 ? ms[1] / ms[TAPS_AVX2 + WAYS / 2] : 0.0);
        free(p[i].texels);
    }
    fclose(csv);
    fclose(md);
    md = fopen("build/bench/sss_pictures.md", "r");
    while (md && (c = getc(md)) != EOF) putchar(c);
    if (md) fclose(md);
    return 0;
}
