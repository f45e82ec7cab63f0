/* The pyramid filter of ms_sss.h: error against the round 2D kernel on 1/f texture by Fourier transform, against a
   plain 2D sum over the surface on a bust-like depth, on tilted planes and in corners, and its promises. */
#define MS_SSS_WITH_SCALAR /* the reference of the other levels */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"

static const double pi = 3.14159265358979323846;

/* d'Eon's skin (GPU Gems 3, chapter 14): six Gaussians, standard deviations in mm. */
static const double skin_sigma[6] = {0.0800,   0.2200,   0.432435,
                                     0.752994, 1.410674, 2.722132}; /* roots of the variances there */
static const double skin_weight[6][3] = {{0.233, 0.455, 0.649}, {0.100, 0.336, 0.344}, {0.118, 0.198, 0.000},
                                         {0.113, 0.007, 0.007}, {0.358, 0.004, 0.000}, {0.078, 0.000, 0.000}};

static ms_sss_profile *skin(void)
{
    double sigma[6][3];
    ms_sss_profile *p = NULL;
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = skin_sigma[i];
    CHECK_INT(ms_sss_profile_from_gaussians(&p, 6, (const double(*)[3])sigma, skin_weight, NULL, NULL), MS_OK);
    return p;
}

static ms_sss_pyramid skin_pyramid(void)
{
    ms_sss_pyramid pyramid;
    ms_sss_profile *p = skin();
    memset(&pyramid, 0, sizeof pyramid);
    CHECK_INT(ms_sss_pyramid_make(&pyramid, p, NULL), MS_OK);
    ms_sss_profile_destroy(p);
    return pyramid;
}

/* --- Fourier transform of 2^m values: radix 2, in place --- */

static void fourier(double *re, double *im, int n, ptrdiff_t step)
{
    int i, j = 0, size;
    for (i = 1; i < n; ++i) {
        int bit = n / 2;
        for (; j & bit; bit /= 2) j ^= bit;
        j ^= bit;
        if (i < j) {
            double t = re[i * step];
            re[i * step] = re[j * step];
            re[j * step] = t;
            t = im[i * step];
            im[i * step] = im[j * step];
            im[j * step] = t;
        }
    }
    for (size = 2; size <= n; size *= 2) {
        for (j = 0; j < size / 2; ++j) {
            const double wr = cos(2 * pi * j / size), wi = -sin(2 * pi * j / size);
            for (i = j; i < n; i += size) {
                double *ar = re + i * step, *ai = im + i * step, *br = re + (i + size / 2) * step,
                       *bi = im + (i + size / 2) * step;
                const double tr = *br * wr - *bi * wi, ti = *br * wi + *bi * wr;
                *br = *ar - tr;
                *bi = *ai - ti;
                *ar += tr;
                *ai += ti;
            }
        }
    }
}

static void fourier_2d(double *re, double *im, int n)
{
    int i;
    for (i = 0; i < n; ++i) fourier(re + (ptrdiff_t)i * n, im + (ptrdiff_t)i * n, n, 1);
    for (i = 0; i < n; ++i) fourier(re + i, im + i, n, n);
}

static int exact; /* options.exact of all runs: every promise holds for the wide gather, too */

static ms_status run(const ms_sss_frame *f, const ms_sss_pyramid *pyramid, const ms_sss_filter_options *options)
{
    ms_sss_filter_options o = *options;
    const size_t size = ms_sss_pyramid_workspace(f->width, f->height);
    void *workspace = malloc(size);
    ms_error error;
    ms_status status;
    memset(workspace, 0xff, size); /* NaN */
    o.exact = exact;
    status = ms_sss_pyramid_filter(f, pyramid, 1, &o, workspace, size, &error);
    if (status != MS_OK) TEST_FAIL("status %d: %s", (int)status, error.message);
    free(workspace);
    return status;
}

enum { TILE = 512, SIDE = 2 * TILE };

/* Texture of amplitude 1/f that repeats after TILE pixels; the picture is 2 x 2 of it, compared in the middle. */
static double texture_error(const ms_sss_pyramid *pyramid, double radius_px)
{
    const int n = TILE * TILE;
    double *wave_re = (double *)malloc((size_t)n * sizeof(double)),
           *wave_im = (double *)malloc((size_t)n * sizeof(double));
    double *re = (double *)malloc((size_t)n * sizeof(double)), *im = (double *)malloc((size_t)n * sizeof(double));
    float *in[3], *out[3];
    double wrong = 0, right = 0;
    const double pixels = radius_px / (double)pyramid->radius_mm;
    uint64_t seed = test_seed;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f;
    int i, c, x, y, g;
    for (i = 0; i < n; ++i) {
        wave_re[i] = test_normal(&seed);
        wave_im[i] = 0;
    }
    fourier_2d(wave_re, wave_im, TILE);
    for (y = 0; y < TILE; ++y) {
        for (x = 0; x < TILE; ++x) {
            const double k = hypot(x < TILE / 2 ? x : x - TILE, y < TILE / 2 ? y : y - TILE);
            wave_re[y * TILE + x] *= k > 0 ? 1 / k : 0;
            wave_im[y * TILE + x] *= k > 0 ? 1 / k : 0;
        }
    }
    for (c = 0; c < 3; ++c) {
        in[c] = (float *)malloc((size_t)(SIDE * SIDE) * sizeof(float));
        out[c] = (float *)malloc((size_t)(SIDE * SIDE) * sizeof(float));
    }
    for (i = 0; i < n; ++i) { /* inverse by conjugation */
        re[i] = wave_re[i];
        im[i] = -wave_im[i];
    }
    fourier_2d(re, im, TILE);
    for (c = 0; c < 3; ++c)
        for (y = 0; y < SIDE; ++y)
            for (x = 0; x < SIDE; ++x) in[c][y * SIDE + x] = (float)(re[y % TILE * TILE + x % TILE] / n);
    memset(&f, 0, sizeof f);
    f.width = f.height = SIDE;
    f.input = ms_sss_planar(in[0], in[1], in[2]);
    f.output = ms_sss_planar(out[0], out[1], out[2]);
    o.pixels_per_mm[0] = (float)pixels;
    run(&f, pyramid, &o);
    for (c = 0; c < 3; ++c) {
        double total = 0;
        for (g = 0; g < 6; ++g) total += skin_weight[g][c];
        for (y = 0; y < TILE; ++y) {
            for (x = 0; x < TILE; ++x) {
                const double k = 2 * pi / (int)TILE * hypot(x < TILE / 2 ? x : x - TILE, y < TILE / 2 ? y : y - TILE);
                double T = 0;
                for (g = 0; g < 6; ++g)
                    T += skin_weight[g][c] / total * exp(-k * k * pixels * pixels * skin_sigma[g] * skin_sigma[g] / 2);
                re[y * TILE + x] = wave_re[y * TILE + x] * T;
                im[y * TILE + x] = -wave_im[y * TILE + x] * T;
            }
        }
        fourier_2d(re, im, TILE);
        for (y = 0; y < TILE; ++y) {
            for (x = 0; x < TILE; ++x) {
                const double reference = re[y * TILE + x] / n;
                const int yy = y < TILE / 2 ? y + TILE : y,
                          xx = x < TILE / 2 ? x + TILE : x; /* the middle of the picture */
                const double e = (double)out[c][yy * SIDE + xx] - reference;
                wrong += e * e;
                right += reference * reference;
            }
        }
    }
    for (c = 0; c < 3; ++c) {
        free(in[c]);
        free(out[c]);
    }
    free(wave_re);
    free(wave_im);
    free(re);
    free(im);
    return sqrt(wrong / right);
}

static void case_texture(void)
{
    static const double radius[] = {64, 90, 24, 128};
    const ms_sss_pyramid pyramid = skin_pyramid();
    int i;
    TEST_METHOD;
    for (i = 0; i < (test_full ? 4 : 3); ++i) {
        const double e = texture_error(&pyramid, radius[i]);
        CHECK_LE(e,
                 radius[i] < 64 || exact
                     ? 0.012
                     : 0.01); /* the target from 64 pixels on; below, narrow channels fit less well: 1.08%, 1.28% where
the weights are fitted to waves along an axis; wide gathers are bumps of sharper ends: 1.06% to 1.10% */
        TEST_NOTE("R %g px: %.2f%%", radius[i], 100 * e);
    }
}

static void case_weights(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    int s, l, b, c;
    for (s = 0; s < 2 * MS_SSS_PYRAMID_SIZES; ++s) {
        for (c = 0; c < 3; ++c) {
            double sum = 0;
            for (l = 0; l < MS_SSS_PYRAMID_LEVELS; ++l) {
                for (b = 0; b < 2; ++b) {
                    const double weight = (double)pyramid.weight[s % 2][s / 2][l][b][c];
                    CHECK(weight >= 0);
                    sum += weight;
                }
            }
            CHECK_NEAR(sum, 1, 1e-6); /* 24 floats' rounding */
        }
    }
}

/* A ball in front of a wall, textured; the middle third masked by stripes. */
enum { W = 220, H = 180, N = W * H };
static float rgb[3][N], out[3][N], again[3][N], depth[N], strength[N];

static void make_scene(void)
{
    uint64_t seed = test_seed;
    int x, y, c;
    for (y = 0; y < H; ++y) {
        for (x = 0; x < W; ++x) {
            const double u = (x - W / 2) / 90.0, v = (y - H / 2) / 90.0, r = 0.6 - u * u - v * v;
            depth[y * W + x] = (float)(r > 0 ? 100 - 9 * sqrt(r) : 112);
            strength[y * W + x] = x > W / 3 && x < 2 * W / 3 && x % 40 < 12 ? 0.0f : 1.0f;
            for (c = 0; c < 3; ++c)
                rgb[c][y * W + x] = (float)(1 + 0.5 * sin(x * 0.07 + c) * cos(y * 0.05) +
                                            0.4 * ((x / 16 + y / 16) % 2) + 0.3 * test_uniform(&seed));
        }
    }
}

static ms_sss_frame scene_frame(float (*to)[N], int with_depth, int with_mask)
{
    ms_sss_frame f;
    memset(&f, 0, sizeof f);
    f.width = W;
    f.height = H;
    f.input = ms_sss_planar(rgb[0], rgb[1], rgb[2]);
    f.output = ms_sss_planar(to[0], to[1], to[2]);
    if (with_depth) f.depth = ms_sss_map(depth, 1);
    if (with_mask) f.strength = ms_sss_map(strength, 1);
    return f;
}

/* Slopes of make_scene's ball and wall where a pixel is 1 / pixels mm wide, within the filter's bounds. */
static void scene_slope(int x, int y, double pixels, double s[2])
{
    const double u = (x - W / 2) / 90.0, v = (y - H / 2) / 90.0, r = 0.6 - u * u - v * v;
    int i;
    s[0] = r > 0 ? 9 * u / (90 * sqrt(r)) * pixels : 0;
    s[1] = r > 0 ? 9 * v / (90 * sqrt(r)) * pixels : 0;
    for (i = 0; i < 2; ++i) s[i] = s[i] > 8 ? 8 : s[i] < -8 ? -8 : s[i];
}

/* Relative RMS difference, over the blurred picture's standard deviation, from a sum over the surface: the profile at
   the distance in space, times the area that a pixel shows, times (1 + K sin(theta) / 4)^4, none beyond the radius in
   depth. The sums are made once, for both gathers, and with and without the mask at once. */
static double plain_error(const ms_sss_pyramid *pyramid, double pixels, int with_depth, int with_mask, double *worst)
{
    static double truth[4][400][3];
    static int made[2];
    const double radius_mm = (double)pyramid->radius_mm;
    const int reach = (int)(1.6 * radius_mm * pixels);
    uint64_t seed = test_seed;
    double wrong = 0, sum1[3] = {0, 0, 0}, sum2 = 0, mean2 = 0;
    int k, c, x, y, g, count = 0;
    *worst = 0;
    for (k = 0; k < 400; ++k) {
        const int px = (int)(test_uniform(&seed) * (int)W), py = (int)(test_uniform(&seed) * (int)H), p = py * W + px;
        double s[2][3] = {{0, 0, 0}, {0, 0, 0}}, n[2][3] = {{0, 0, 0}, {0, 0, 0}}, own[2], area;
        scene_slope(px, py, pixels, own);
        area = sqrt(1 + own[0] * own[0] + own[1] * own[1]);
        for (y = -reach; y <= reach && !made[with_depth]; ++y) {
            for (x = -reach; x <= reach; ++x) {
                const int q = p + y * W + x;
                double share = 1, lift[3] = {1, 1, 1}, gauss[6], r2 = x * x + y * y;
                if (px + x < 0 || py + y < 0 || px + x >= W || py + y >= H) continue;
                if (with_depth) {
                    const double dz = ((double)depth[q] - (double)depth[p]) * pixels;
                    double slope[2], turn;
                    if (!(fabs(dz) < radius_mm * pixels)) continue;
                    scene_slope(px + x, py + y, pixels, slope);
                    share = sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]);
                    r2 += dz * dz;
                    turn = r2 > 0 ? (dz - own[0] * x - own[1] * y) / (area * sqrt(r2)) : 0;
                    for (c = 0; c < 3; ++c) lift[c] = pow(fmax(0, 1 + (double)pyramid->elevation[c] * turn / 4), 4);
                }
                for (g = 0; g < 6; ++g) { /* averaged over the pixel: 1/12 more variance */
                    const double v = skin_sigma[g] * skin_sigma[g] * pixels * pixels + 1.0 / 12;
                    gauss[g] = share * exp(-r2 / (2 * v)) / (2 * pi * v);
                }
                for (c = 0; c < 3; ++c) {
                    double w = 0;
                    for (g = 0; g < 6; ++g) w += skin_weight[g][c] * gauss[g];
                    s[0][c] += w * lift[c] * (double)rgb[c][q];
                    n[0][c] += w;
                    if (!(strength[q] > 0)) continue;
                    s[1][c] += w * lift[c] * (double)rgb[c][q];
                    n[1][c] += w;
                }
            }
        }
        for (c = 0; c < 3 && !made[with_depth]; ++c) {
            truth[with_depth][k][c] = s[0][c] / n[0][c];
            truth[2 + with_depth][k][c] = s[1][c] / n[1][c];
        }
        if (with_mask && !(strength[p] > 0)) continue;
        ++count;
        for (c = 0; c < 3; ++c) {
            const double reference = truth[(with_mask ? 2 : 0) + with_depth][k][c];
            const double e = (double)out[c][p] - reference;
            wrong += e * e;
            sum1[c] += reference;
            sum2 += reference * reference;
            if (fabs(e) / reference > *worst) *worst = fabs(e) / reference;
        }
    }
    made[with_depth] = 1;
    for (c = 0; c < 3; ++c) mean2 += sum1[c] * sum1[c] / count;
    return sqrt(wrong / (sum2 - mean2));
}

static void case_depth_and_mask(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    /* Found, not derived: a ball of 12 radii's width has its rim in half of the picture; bounds are half as much again
       as measured. */
    static const double bound[4] = {0.035, 0.12, 0.055, 0.115};
    int kind;
    make_scene();
    for (kind = 0; kind < 4; ++kind) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_frame f = scene_frame(out, kind & 1, kind & 2);
        double worst, e;
        o.pixels_per_mm[0] = 8;
        run(&f, &pyramid, &o);
        e = plain_error(&pyramid, 8, kind & 1, kind & 2, &worst);
        CHECK_LE(e, bound[kind]);
        TEST_NOTE("%s%s %.2f%% (worst pixel %.1f%%)", kind & 1 ? "depth" : "flat", kind & 2 ? " + mask" : "", 100 * e,
                  100 * worst);
    }
}

/* A net of wires one pixel wide, 20 mm in front of a wall of another light: neither takes any from the other, at any
   level; evenly lit, the wall stays as it is, and no wire becomes brighter than 1 / reflectance. */
static void case_thin(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    int kind, i, c, crossed, uneven, bright;
    for (kind = 0; kind < 4; ++kind) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_frame f = scene_frame(out, 1, 0);
        const int space = kind < 2
            ? 7
            : 40; /* 1 to 20 pixels of the wall between wires are a few pixels of the levels, or none */
        if (kind % 2) o.fov_degrees = 12;
        else o.ortho_height = 30;
        for (i = 0; i < N; ++i) {
            depth[i] = i % W % space == 3 || i / W % space == 5 ? 100.0f : 120.0f;
            for (c = 0; c < 3; ++c) rgb[c][i] = depth[i] < 110 ? 0.25f : 1e4f;
        }
        run(&f, &pyramid, &o);
        for (crossed = uneven = i = 0; i < N; ++i)
            for (c = 0; c < 3; ++c) {
                /* a wire's depth is level along it: no slope, so even light stays to the rounding of a dozen sums */
                const double change = fabs((double)(out[c][i] / rgb[c][i]) - 1);
                crossed += change > 0.01;
                uneven += change > 2e-6;
            }
        if (crossed || uneven)
            TEST_FAIL("kind %d: %d values with light of another depth, %d not even", kind, crossed, uneven);
        for (i = 0; i < N; ++i) /* wires that wind in depth: no slope of theirs is beyond the filter's bounds */
            if (depth[i] < 110) depth[i] = (float)(100 + 2 * sin(i % W * 0.5) + 2 * cos(i / W * 0.4));
        for (c = 0; c < 3; ++c)
            for (i = 0; i < N; ++i) rgb[c][i] = 1;
        run(&f, &pyramid, &o);
        for (bright = i = 0; i < N; ++i)
            for (c = 0; c < 3; ++c) bright += !(out[c][i] >= 0 && out[c][i] * pyramid.reflectance[c] <= 1 + 1e-6f);
        CHECK_INT(bright, 0);
    }
}

/* Masks of rows that differ: what a mask leaves out by columns counts as little as pixels that are not finite, which
   are looked at one by one. */
static void case_masks(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    int shape, kind, i, c, wrong = 0, threads = 0;
    double worst = 0;
    for (shape = 0; shape < 4; ++shape) {
        for (kind = 0; kind < 3; ++kind) {
            ms_sss_filter_options o = ms_sss_filter_defaults();
            ms_sss_frame f = scene_frame(out, kind > 0, 1);
            test_pool pool;
            if (kind) o.fov_degrees = 12;
            else o.pixels_per_mm[0] = 10;
            o.flat = kind < 2 ? 1.0f : 0.0f;
            o.simd = (ms_simd)(1 + (shape + kind) % 4); /* all levels */
            make_scene();
            for (i = 0; i < N; ++i) {
                const int x = i % W, y = i / W;
                strength[i] = shape == 0 ? abs(x - y) < 9
                    : shape == 1         ? (x - W / 2) * (x - W / 2) + (y - H / 2) * (y - H / 2) < 900
                    : shape == 2         ? i == 0 || i == N - 1 || (y == 50 && x > W - 9)
                                         : x / 30 % 2 == y / 20 % 2;
            }
            run(&f, &pyramid, &o);
            o.parallel = test_parallel(&pool, 5);
            f = scene_frame(again, kind > 0, 1);
            run(&f, &pyramid, &o);
            threads += memcmp(out, again, sizeof out) != 0;
            for (i = 0; i < N; ++i)
                for (c = 0; c < 3; ++c) {
                    if (strength[i] > 0) continue;
                    wrong += memcmp(&out[c][i], &rgb[c][i], sizeof(float)) != 0;
                    rgb[c][i] = NAN;
                }
            f = scene_frame(again, kind > 0, 0);
            run(&f, &pyramid, &o);
            for (i = 0; i < N; ++i)
                for (c = 0; c < 3; ++c)
                    if (strength[i] > 0 && !(fabs((double)out[c][i] - (double)again[c][i]) <= worst))
                        worst = fabs((double)out[c][i] - (double)again[c][i]);
        }
    }
    CHECK_INT(wrong, 0);
    CHECK_INT(threads, 0);
    CHECK(worst < 1e-6); /* rounding */
    TEST_NOTE("largest difference %.1e", worst);
}

static void case_promises(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    int kind, level, i, c, changed = 0, lifted = 0, crossed = 0, spread = 0, small = 0, threads = 0;
    make_scene();
    for (kind = 0; kind < 3; ++kind) {
        for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
            ms_sss_filter_options o = ms_sss_filter_defaults();
            ms_sss_frame f = scene_frame(out, kind > 0, 1);
            test_pool pool;
            o.simd = (ms_simd)level;
            if (kind == 0) o.pixels_per_mm[0] = 10;
            if (kind == 1) o.fov_degrees = 12;
            if (kind == 2) o.ortho_height = 30;
            make_scene();
            run(&f, &pyramid, &o);
            f = scene_frame(again, kind > 0, 1);
            o.parallel = test_parallel(&pool, 5);
            run(&f, &pyramid, &o);
            o.parallel.run = NULL;
            threads += memcmp(out, again, sizeof out) != 0;
            /* constant */
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i) rgb[c][i] = 0.3f;
            run(&f, &pyramid, &o);
            for (c = 0; c < 3; ++c) /* reflectance times what the shape adds is at most 1 */
                for (i = 0; i < N; ++i) lifted += !(again[c][i] * pyramid.reflectance[c] < 0.3f + 1e-6f);
            o.flat = 1;
            run(&f, &pyramid, &o);
            o.flat = 0;
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i) changed += !(fabsf(again[c][i] - 0.3f) < 1e-6f);
            /* light on the wall only, 12 to 19 mm behind the ball: none may reach it */
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i) rgb[c][i] = depth[i] > 111 ? 1000.0f : 0.0f;
            run(&f, &pyramid, &o);
            for (c = 0; c < 3 && kind > 0; ++c)
                for (i = 0; i < N; ++i)
                    crossed += depth[i] < 111 ? again[c][i] > 0 || again[c][i] < 0 : !(again[c][i] > 999.99f);
            /* hostile pixels come back and spread nowhere */
            make_scene();
            rgb[0][77 * W + 50] = NAN;
            rgb[2][20 * W + 20] = INFINITY;
            depth[99 * W + 100] = NAN;
            depth[30 * W + 100] = -1;
            run(&f, &pyramid, &o);
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i)
                    spread += !isfinite(rgb[c][i]) ? memcmp(&again[c][i], &rgb[c][i], sizeof(float)) != 0
                                                   : !isfinite(again[c][i]);
            for (c = 0; c < 3 && kind > 0; ++c)
                spread += memcmp(&again[c][99 * W + 100], &rgb[c][99 * W + 100], sizeof(float)) != 0;
            /* under half a pixel */
            make_scene();
            o.pixels_per_mm[0] *= 0.005f;
            o.ortho_height *= 200;
            if (kind == 1) o.mm_per_unit = 1000;
            run(&f, &pyramid, &o);
            small += memcmp(rgb, again, sizeof rgb) != 0;
        }
    }
    CHECK_INT(threads, 0);
    CHECK_INT(changed, 0);
    CHECK_INT(lifted, 0);
    CHECK_INT(crossed, 0);
    CHECK_INT(spread, 0);
    CHECK_INT(small, 0);
}

/* A wave on a plane, tilted about an axis on the screen (orthographic): the profile's transfer says how much of it
   stays. across 0: along the slope. Returns the part that stays, of which only the red channel is looked at. */
enum { PLANE = 256, MIRRORED_W = 192, MIRRORED_H = 128 /* whole pixels in all levels but the coarsest */ };
static double plane_wave(const ms_sss_pyramid *pyramid, double tilt, double angle, double k, int across,
                         double *constant)
{
    static float in[3][PLANE * PLANE], to[3][PLANE * PLANE], z[PLANE * PLANE];
    const double pixels = 6, dx = cos(angle), dy = sin(angle);
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f;
    double stays = 0, is = 0;
    int i, c, pass;
    memset(&f, 0, sizeof f);
    f.width = f.height = PLANE;
    f.input = ms_sss_planar(in[0], in[1], in[2]);
    f.output = ms_sss_planar(to[0], to[1], to[2]);
    f.depth = ms_sss_map(z, 1);
    o.pixels_per_mm[0] = (float)pixels;
    *constant = 0;
    for (pass = 0; pass < 2; ++pass) {
        for (i = 0; i < PLANE * PLANE; ++i) {
            const double x = i % PLANE - PLANE / 2, y = i / PLANE - PLANE / 2, down = (x * dx + y * dy) / pixels;
            const double at = across ? (y * dx - x * dy) / pixels : down / cos(tilt);
            z[i] = (float)(120 + down * tan(tilt));
            for (c = 0; c < 3; ++c) in[c][i] = pass ? (float)(1 + cos(k * at)) : 1.0f;
        }
        run(&f, pyramid, &o);
        for (i = 0; i < PLANE * PLANE; ++i) {
            const int x = i % PLANE, y = i / PLANE;
            if (pass == 0)
                for (c = 0; c < 3; ++c) *constant = fmax(*constant, fabs((double)to[c][i] - 1));
            if (pass == 1 && abs(x - PLANE / 2) < PLANE / 6 && abs(y - PLANE / 2) < PLANE / 6) {
                stays += ((double)to[0][i] - 1) * ((double)in[0][i] - 1);
                is += ((double)in[0][i] - 1) * ((double)in[0][i] - 1);
            }
        }
    }
    return stays / is;
}

static double skin_transfer(double k)
{
    double sum = 0, total = 0;
    int g;
    for (g = 0; g < 6; ++g) {
        total += skin_weight[g][0];
        sum += skin_weight[g][0] * exp(-k * k * skin_sigma[g] * skin_sigma[g] / 2);
    }
    return sum / total;
}

static void case_planes(void)
{
    static const double tilt[5] = {0, 30, 45, 60, 75};
    /* Found, not derived, and half as much again: from 48 degrees on a gather reaches no further along the level
       line. */
    static const double bound[5] = {0.005, 0.02, 0.045, 0.06, 0.22};
    const ms_sss_pyramid pyramid = skin_pyramid();
    char note[400];
    int i, j, n = 0;
    for (i = 0; i < 5; ++i) {
        double worst = 0, constant = 0;
        for (j = 0; j < 8; ++j) {
            const double k = 2 * pi / (j & 1 ? 6.0 : 15.0); /* 1/mm; the radius is 7 */
            double c, stays = plane_wave(&pyramid, tilt[i] * pi / 180, j & 4 ? 0.6 : 0, k, j & 2, &c);
            worst = fmax(worst, fabs(stays - skin_transfer(k)));
            constant = fmax(constant, c);
        }
        CHECK_LE(
            constant,
            1e-6); /* what rounding of depths can do is left out; a dozen rounded sums of weights that add up to 1 */
        CHECK_LE(worst, bound[i]);
        n += snprintf(note + n, sizeof note - (size_t)n, "%g degrees %.3f (constant %.0e)  ", tilt[i], worst, constant);
    }
    TEST_NOTE("%s", note);
}

/* The weights are fitted to waves in one direction; those in all others must keep what the profile says too. */
static void case_directions(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    double worst = 0, least = 1, most = 0, constant;
    int i;
    for (i = 0; i <= 4; ++i) {
        const double k = 2 * pi / 3.0, stays = plane_wave(&pyramid, 0, i * pi / 16, k, 0, &constant);
        worst = fmax(worst, fabs(stays - skin_transfer(k)));
        least = fmin(least, stays);
        most = fmax(most, stays);
    }
    CHECK_LE(worst, 0.02);
    TEST_NOTE("off by %.4f, directions differ by %.4f", worst, most - least);
}

/* Two planes at 90 degrees: evenly lit, a valley is darker than a plane and a ridge brighter, by what the law gives the
   profile there within a quarter; a picture turned or mirrored gives the result turned or mirrored. */
static void case_corners(void)
{
    const double total[3] = {0.5, 0.5, 0.5}, d[3] = {1, 1, 1};
    static float in[3][N], first[3][N], second[3][N], z[2][N];
    ms_sss_profile *profile;
    ms_sss_pyramid pyramid;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f;
    int kind, i, c;
    CHECK_INT(ms_sss_profile_from_burley(&profile, total, d, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_pyramid_make(&pyramid, profile, NULL), MS_OK);
    ms_sss_profile_destroy(profile);
    memset(&f, 0, sizeof f);
    f.width = W;
    f.height = H;
    f.input = ms_sss_planar(in[0], in[1], in[2]);
    f.output = ms_sss_planar(first[0], first[1], first[2]);
    o.pixels_per_mm[0] = 8;
    for (kind = 0; kind < 2; ++kind) {
        const int middle = H / 2 * W + W / 2, far_off = H / 2 * W + 10;
        for (i = 0; i < N; ++i) {
            z[0][i] = (float)(100 + (kind ? 1 : -1) * fabs(i % W - W / 2 + 0.5) / 8);
            for (c = 0; c < 3; ++c) in[c][i] = 1;
        }
        f.depth = ms_sss_map(z[0], 1);
        run(&f, &pyramid, &o);
        if (kind == 0) CHECK(first[0][middle] < 0.9f);
        else CHECK(first[0][middle] > 1.1f);
        CHECK_NEAR((double)first[0][far_off], 1, 0.01); /* 12 mm away: under 1% of the profile's light */
        CHECK(first[0][middle] * pyramid.reflectance[0] <= 1.000001f);
        TEST_NOTE("%s %.3f", kind ? "ridge" : "valley", (double)first[0][middle]);
    }
    make_scene();
    f.width = MIRRORED_W;
    f.height = MIRRORED_H;
    for (kind = 0; kind < 3; ++kind) { /* columns, rows, both */
        double worst = 0;
        int turned;
        for (turned = 0; turned < 2; ++turned) {
            for (i = 0; i < MIRRORED_W * MIRRORED_H; ++i) {
                const int x = i % MIRRORED_W, y = i / MIRRORED_W;
                const int j = (turned && kind != 0 ? MIRRORED_H - 1 - y : y) * W +
                    (turned && kind != 1 ? MIRRORED_W - 1 - x : x);
                z[turned][i] = depth[j];
                for (c = 0; c < 3; ++c)
                    in[c][i] = rgb[c][j] * (turned ? 1e4f : 1.0f); /* and a light 10^4 times as strong */
            }
            f.depth = ms_sss_map(z[turned], 1);
            f.input = ms_sss_planar(in[0], in[1], in[2]);
            if (turned) f.output = ms_sss_planar(second[0], second[1], second[2]);
            else f.output = ms_sss_planar(first[0], first[1], first[2]);
            run(&f, &pyramid, &o);
        }
        for (i = 0; i < MIRRORED_W * MIRRORED_H; ++i) {
            const int x = i % MIRRORED_W, y = i / MIRRORED_W;
            const int j = (kind != 0 ? MIRRORED_H - 1 - y : y) * MIRRORED_W + (kind != 1 ? MIRRORED_W - 1 - x : x);
            for (c = 0; c < 3; ++c) worst = fmax(worst, fabs((double)second[c][i] / 1e4 - (double)first[c][j]));
        }
        CHECK_LE(worst, 1e-4); /* rounding: sums run the other way, of values up to 3 and slopes up to 8 */
        TEST_NOTE("mirrored: %.1e", worst);
    }
}

/* Depths of which many are alike to rounding: noise of 2^-10 to 2^-17 of the depth, and steps of as much. */
static void rough_depth(int kind, uint64_t *seed)
{
    const double step = 100 * pow(2, -10 - kind / 2);
    int i;
    for (i = 0; i < N; ++i)
        depth[i] = (float)(100 + step * (kind % 2 ? test_uniform(seed) : (i % W / 7 + i / W / 5) % 2));
}

/* Levels against scalar. What is chosen by comparing depths must be the same pixels; then only fused products and the
   order of sums differ, by 4e-6 of the brightest pixel, as stated. */
static void case_levels(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    uint64_t seed = test_seed;
    double worst = 0;
    int level, kind, c, i;
    make_scene();
    for (kind = -2; kind < 16; ++kind) {
        if (kind >= 0) rough_depth(kind, &seed);
        for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
            ms_sss_filter_options o = ms_sss_filter_defaults();
            ms_sss_frame f = scene_frame(level == MS_SIMD_SCALAR ? out : again, 1, kind < 0 && kind % 2);
            double most = 0;
            o.simd = (ms_simd)level;
            if (kind % 4 < 2) o.fov_degrees = 12;
            else o.ortho_height = 20;
            run(&f, &pyramid, &o);
            for (c = 0; c < 3; ++c)
                for (i = 0; i < N; ++i) most = fmax(most, fmax((double)rgb[c][i], (double)out[c][i]));
            for (c = 0; c < 3 && level > MS_SIMD_SCALAR; ++c) {
                for (i = 0; i < N; ++i) {
                    const double e = fabs((double)out[c][i] - (double)again[c][i]) / most;
                    if (!(e <= worst)) worst = e == e ? e : 1;
                }
            }
        }
    }
    CHECK_LE(worst, 4e-6);
    TEST_NOTE("largest difference %.1e", worst);
}

static void case_sizes(void)
{
    static const int size[][2] = {{1, 1}, {1, 9}, {2, 1}, {3, 2}, {17, 33}, {16384, 1}, {1, 3000}, {333, 5}};
    const ms_sss_pyramid pyramid = skin_pyramid();
    int i, j, c, wrong = 0;
    for (i = 0; i < (int)(sizeof size / sizeof size[0]); ++i) {
        const int n = size[i][0] * size[i][1];
        float *a = (float *)malloc((size_t)n * 4 * sizeof(float)), *b = (float *)malloc((size_t)n * 4 * sizeof(float));
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_frame f;
        for (j = 0; j < 4 * n; ++j) {
            a[j] = j % 4 == 3 ? 5.0f : 1e6f;
            b[j] = -1;
        }
        memset(&f, 0, sizeof f);
        f.width = size[i][0];
        f.height = size[i][1];
        f.input = ms_sss_interleaved(a, 4);
        f.output = ms_sss_interleaved(b, 4);
        f.depth = ms_sss_map(a + 3, 4);
        o.fov_degrees = 30;
        o.mm_per_unit = 10;
        run(&f, &pyramid, &o);
        for (j = 0; j < n; ++j) {
            for (c = 0; c < 3; ++c) wrong += !(fabsf(b[4 * j + c] - 1e6f) < 2);
            wrong += b[4 * j + 3] > -1;
        }
        free(a);
        free(b);
    }
    CHECK_INT(wrong, 0);
}

/* What lies beyond a kernel's reach counts for nothing, nor does where the picture ends, whichever way its rows are
   shared out. */
static void case_heights(void)
{
    const ms_sss_pyramid pyramid = skin_pyramid();
    static float first[3][N];
    int height, tilted, c, i;
    for (tilted = 0; tilted < 2; ++tilted) {
        double worst = 0;
        make_scene();
        for (height = 120; height <= 160; ++height) {
            ms_sss_filter_options o = ms_sss_filter_defaults();
            ms_sss_frame f = scene_frame(height == 120 ? first : again, 1, 0);
            f.height = height;
            o.pixels_per_mm[0] = 1; /* radius 6 pixels: 5 levels of at most 16 pixels and their neighbors */
            o.flat = tilted ? 0.0f : 1.0f;
            run(&f, &pyramid, &o);
            for (c = 0; c < 3 && height > 120; ++c)
                for (i = 0; i < 24 * W; ++i) worst = fmax(worst, fabs((double)again[c][i] - (double)first[c][i]));
        }
        CHECK_LE(worst, 1e-6); /* the same sums of values up to 3; weights of coarser levels are 0 or 1e-7 */
        TEST_NOTE("%.1e", worst);
    }
}

static void case_refused(void)
{
    static uint8_t profile[N];
    const ms_sss_pyramid pyramid = skin_pyramid();
    int i, c;
    make_scene();
    for (i = 2; i < 12; ++i) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_frame f = scene_frame(out, 1, 0);
        size_t size = ms_sss_pyramid_workspace(W, H);
        void *workspace = malloc(size);
        ms_sss_pyramid two[2];
        ms_error error;
        int count = 1, j, touched = 0;
        two[0] = two[1] = pyramid;
        o.fov_degrees = 20;
        if (i == 2) o.fov_degrees = 0, o.pixels_per_mm[0] = 2, o.pixels_per_mm[1] = 3; /* not round */
        if (i == 3) memset(&two[1], 0, sizeof two[1]), count = 2; /* never made: before anything is written */
        if (i == 4) --size;
        if (i == 5) o.fov_degrees = NAN;
        if (i == 6) f.input.channel[2] = NULL;
        if (i == 7) count = 0;
        if (i == 8) two[0].weight[1][20][3][1][2] = NAN;
        if (i == 9) two[0].weight[0][0][0][0][0] = -1;
        if (i == 10) two[0].weight[0][0][0][0][0] = 1.01f; /* beyond what the message says */
        if (i == 11) two[0].elevation[1] = NAN;
        for (j = 0; j < W * H; ++j) profile[j] = (uint8_t)(j % 2);
        f.profile = count == 2 ? profile : NULL;
        for (c = 0; c < 3; ++c)
            for (j = 0; j < W * H; ++j) out[c][j] = -7;
        CHECK_INT(ms_sss_pyramid_filter(&f, two, count, &o, workspace, size, &error),
                  i == 2 ? MS_UNSUPPORTED : MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message,
                     i == 2       ? "pixels_per_mm"
                         : i == 3 ? "pyramid 1"
                         : i == 4 ? "workspace"
                         : i == 5 ? "fov_degrees"
                         : i == 6 ? "input"
                         : i == 7 ? "pyramid_count"
                                  : "pyramid 0") != NULL);
        for (c = 0; c < 3; ++c)
            for (j = 0; j < W * H; ++j) touched += out[c][j] < -7 || out[c][j] > -7;
        CHECK_INT(touched, 0);
        free(workspace);
    }
    CHECK(ms_sss_pyramid_workspace(0, 1) == SIZE_MAX);
    {
        ms_sss_pyramid untouched;
        CHECK_INT(ms_sss_pyramid_make(&untouched, NULL, NULL), MS_INVALID_ARGUMENT);
    }
}

/* Several pyramids: each profile's pixels as its pyramid filters them alone; the call that allocates makes the same. */
static void case_profiles(void)
{
    static uint8_t profile[N];
    static float mask[N], all[3][N];
    ms_sss_pyramid pyramid[2];
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f;
    ms_error error;
    int i, c, which;
    make_scene();
    pyramid[0] = pyramid[1] = skin_pyramid();
    pyramid[1].radius_mm *= 0.5f;
    o.fov_degrees = 20;
    o.mm_per_unit = 1;
    for (i = 0; i < N; ++i) profile[i] = (uint8_t)(i % W > W / 3 ? (i % 41 ? 1 : 7) : 0); /* 7: no pyramid */
    f = scene_frame(all, 1, 0);
    f.profile = profile;
    CHECK_INT(ms_sss_pyramid_filter(&f, pyramid, 2, &o, NULL, 0, &error), MS_OK);
    for (which = 0; which < 2; ++which) {
        for (i = 0; i < N; ++i) mask[i] = profile[i] == which;
        f = scene_frame(out, 1, 0);
        f.strength = ms_sss_map(mask, 1);
        CHECK_INT(run(&f, &pyramid[which], &o), MS_OK);
        for (c = 0; c < 3; ++c)
            for (i = 0; i < N; ++i)
                if (profile[i] == which || profile[i] == 7)
                    CHECK(memcmp(&out[c][i], profile[i] == 7 ? &rgb[c][i] : &all[c][i], sizeof(float)) == 0);
    }
    CHECK_INT(ms_sss_pyramid_filter(&f, pyramid, 1, &o, NULL, 1, &error), MS_INVALID_ARGUMENT);
}

#define BOTH(name)                                  \
    static void name##_both(void)                   \
    {                                               \
        for (exact = 0; exact < 2; ++exact) name(); \
        exact = 0;                                  \
    }
BOTH(case_texture)
BOTH(case_depth_and_mask)
BOTH(case_masks)
BOTH(case_planes)
BOTH(case_directions)
BOTH(case_corners)
BOTH(case_thin)
BOTH(case_promises)
BOTH(case_levels)
BOTH(case_sizes)
BOTH(case_heights)

static const test_case cases[] = {
    {"pyramid weights", case_weights},
    {"1/f texture", case_texture_both},
    {"depth and mask against a plain 2D sum", case_depth_and_mask_both},
    {"tilted planes", case_planes_both},
    {"directions", case_directions_both},
    {"corners, mirrors", case_corners_both},
    {"masks", case_masks_both},
    {"parts one pixel wide", case_thin_both},
    {"promises", case_promises_both},
    {"levels", case_levels_both},
    {"sizes", case_sizes_both},
    {"heights", case_heights_both},
    {"several profiles", case_profiles},
    {"refused", case_refused},
};
TEST_MAIN(cases)
