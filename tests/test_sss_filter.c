/* The filter of ms_sss.h against a plain one in double precision, its exact promises, layouts, levels, threads,
   hostile pixels and refused arguments. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"

/* --- inputs --- */

/* A kernel of n taps whose weights fall off differently per channel; share: what is left to the delta. */
static ms_sss_kernel test_kernel(int n, double radius, double share)
{
    ms_sss_kernel k;
    int i, c;
    memset(&k, 0, sizeof k);
    k.tap_count = n;
    k.term_count = 1;
    for (i = 1; i < n; ++i) {
        double u = (double)((i + 1) / 2) / (double)(n / 2);
        k.offset_mm[i] = (float)((i % 2 ? -1 : 1) * 0.9 * radius * u * u);
    }
    for (c = 0; c < 3; ++c) {
        double sum = 0, w[MS_SSS_TAPS_MAX];
        for (i = 0; i < n; ++i) {
            double u = (double)k.offset_mm[i] / radius;
            w[i] = (0.05 + fabs(u)) * exp(-u * u * (2 + 3 * c));
            sum += w[i];
        }
        for (i = 0; i < n; ++i) k.weight[0][i][c] = (float)(w[i] / sum);
        k.scale[0][c] = (float)(1 - share);
        k.delta[c] = (float)share;
        k.reflectance[c] = 1;
    }
    k.radius_mm = (float)radius;
    return k;
}

/* Three terms, the last two with weights of both signs: as from an SVD. */
static ms_sss_kernel test_kernel_terms(int n, double radius)
{
    ms_sss_kernel k = test_kernel(n, radius, 0.1);
    int t, i, c;
    k.term_count = 3;
    for (c = 0; c < 3; ++c) {
        double total = (double)k.delta[c];
        for (t = 1; t < 3; ++t) {
            double sum = 0;
            for (i = 0; i < n; ++i) {
                k.weight[t][i][c] = (float)(cos(2.0 * t * (double)k.offset_mm[i] / radius + 0.3 * c) / n);
                sum += (double)k.weight[t][i][c];
            }
            k.scale[t][c] = t == 1 ? -0.3f : 0.2f;
            total += (double)k.scale[t][c] * sum * sum;
        }
        k.scale[0][c] = (float)(1 - total);
    }
    return k;
}

typedef struct test_scene {
    int width, height;
    float *rgb[3], *depth, *strength, *albedo[3], *specular[3];
    uint8_t *profile;
} test_scene;

static float *test_floats(int n) { return (float *)malloc((size_t)n * sizeof(float)); }

/* A textured picture with a bump in front of a wall, and a strength map with holes. */
static test_scene test_scene_make(int width, int height, uint64_t seed)
{
    test_scene s;
    const int n = width * height;
    int x, y, c;
    s.width = width;
    s.height = height;
    for (c = 0; c < 3; ++c) {
        s.rgb[c] = test_floats(n);
        s.albedo[c] = test_floats(n);
        s.specular[c] = test_floats(n);
    }
    s.depth = test_floats(n);
    s.strength = test_floats(n);
    s.profile = (uint8_t *)malloc((size_t)n);
    for (y = 0; y < height; ++y) {
        for (x = 0; x < width; ++x) {
            const int i = y * width + x;
            const double u = 2.0 * x / width - 1, v = 2.0 * y / height - 1, bump = 0.7 - u * u - v * v;
            s.depth[i] = (float)(bump > 0 ? 110 - 20 * sqrt(bump) : 140 + 3 * u);
            s.strength[i] = (float)(test_uniform(&seed) < 0.1 ? 0 : 0.2 + 0.8 * test_uniform(&seed));
            s.profile[i] = (uint8_t)(v > 0.2 * u ? (x % 37 == 3 ? 7 : 1) : 0);
            for (c = 0; c < 3; ++c) {
                s.rgb[c][i] = (float)((x / 5 + y / 7) % 2 ? 0.2 + test_uniform(&seed) : 2 * test_uniform(&seed));
                s.albedo[c][i] = (float)(0.1 + 0.9 * test_uniform(&seed));
                s.specular[c][i] = (float)(0.5 * test_uniform(&seed));
            }
        }
    }
    return s;
}

static void test_scene_free(test_scene *s)
{
    int c;
    for (c = 0; c < 3; ++c) {
        free(s->rgb[c]);
        free(s->albedo[c]);
        free(s->specular[c]);
    }
    free(s->depth);
    free(s->strength);
    free(s->profile);
}

enum { WITH_DEPTH = 1, WITH_STRENGTH = 2, WITH_ALBEDO = 4, WITH_SPECULAR = 8, WITH_PROFILE = 16 };

static ms_sss_frame test_frame(const test_scene *s, int with, float *const out[3])
{
    ms_sss_frame f;
    memset(&f, 0, sizeof f);
    f.width = s->width;
    f.height = s->height;
    f.input = ms_sss_planar(s->rgb[0], s->rgb[1], s->rgb[2], 0);
    f.output = ms_sss_planar(out[0], out[1], out[2], 0);
    if (with & WITH_DEPTH) f.depth = ms_sss_map(s->depth, 1, 0);
    if (with & WITH_STRENGTH) f.strength = ms_sss_map(s->strength, 1, 0);
    if (with & WITH_ALBEDO) f.albedo = ms_sss_planar(s->albedo[0], s->albedo[1], s->albedo[2], 0);
    if (with & WITH_SPECULAR) f.specular = ms_sss_planar(s->specular[0], s->specular[1], s->specular[2], 0);
    if (with & WITH_PROFILE) f.profile = s->profile;
    return f;
}

/* Filters with a workspace of exactly the promised size, filled with NaN first. */
static ms_status test_run(const ms_sss_frame *f, const ms_sss_kernel *kernels, int count,
                          const ms_sss_filter_options *options)
{
    const size_t size = ms_sss_filter_workspace(f->width, f->height, kernels, count, options);
    void *workspace = malloc(size);
    ms_error error;
    ms_status status;
    memset(workspace, 0xff, size);
    status = ms_sss_filter(f, kernels, count, options, workspace, size, &error);
    if (status != MS_OK) TEST_FAIL("status %d: %s", (int)status, error.message);
    free(workspace);
    return status;
}

/* --- the plain filter, as the declaration of ms_sss_filter describes it --- */

typedef struct plain {
    const test_scene *s;
    const ms_sss_kernel *kernels;
    int count, with;
    ms_sss_filter_options o;
} plain;

static int plain_part(const plain *p, int i)
{
    int c;
    for (c = 0; c < 3; ++c)
        if (!ms__finite_f(p->s->rgb[c][i])) return 0;
    if ((p->with & WITH_DEPTH) && !(p->s->depth[i] > 0 && ms__finite_f(p->s->depth[i]))) return 0;
    if ((p->with & WITH_STRENGTH) && !(p->s->strength[i] > 0)) return 0;
    if ((p->with & WITH_PROFILE) && p->s->profile[i] >= p->count) return 0;
    return p->o.fade < 1;
}

static int plain_profile(const plain *p, int i) { return p->with & WITH_PROFILE ? p->s->profile[i] : 0; }

/* Pixels a mm along x and y. */
static void plain_size(const plain *p, int i, double size[2])
{
    const int w = p->s->width, h = p->s->height;
    const double mm = p->o.mm_per_unit > 0 ? (double)p->o.mm_per_unit : 1;
    const double radius = (double)p->kernels[plain_profile(p, i)].radius_mm, most = (w > h ? w : h) / radius;
    if (p->o.pixels_per_mm[0] > 0) size[0] = (double)p->o.pixels_per_mm[0];
    else if (p->o.ortho_height > 0) size[0] = h / ((double)p->o.ortho_height * mm);
    else size[0] = h / (2 * tan((double)p->o.fov_degrees * 3.14159265358979323846 / 360) * (double)p->s->depth[i] * mm);
    if (size[0] > most) size[0] = most;
    size[1] = size[0];
    if (p->o.pixels_per_mm[0] > 0 && p->o.pixels_per_mm[1] > 0)
        size[1] *= (double)p->o.pixels_per_mm[1] / (double)p->o.pixels_per_mm[0];
    if (p->o.uv_steps && !(p->o.pixels_per_mm[0] > 0)) size[0] *= (double)w / h;
}

static int plain_small(const plain *p, int i)
{
    double size[2];
    plain_size(p, i, size);
    return (double)p->kernels[plain_profile(p, i)].radius_mm * (size[0] > size[1] ? size[0] : size[1]) < 0.5;
}

static double plain_depth_factor(const plain *p, const ms_sss_kernel *k, int i, int j)
{
    const double mm = p->o.mm_per_unit > 0 ? (double)p->o.mm_per_unit : 1;
    double dz, sigma = p->o.depth_sigma_mm > 0 ? (double)p->o.depth_sigma_mm : (double)k->radius_mm / 3;
    double follow = p->o.follow_mm > 0 ? (double)p->o.follow_mm : (double)k->radius_mm;
    if (!(p->with & WITH_DEPTH) || p->o.depth_mode == MS_SSS_DEPTH_SCALE) return 1;
    dz = fabs((double)p->s->depth[i] - (double)p->s->depth[j]) * mm;
    if (p->o.depth_mode == MS_SSS_DEPTH_FOLLOW) return dz < follow ? 1 - dz / follow : 0;
    return dz < (double)k->radius_mm ? exp(-dz * dz / (2 * sigma * sigma)) : 0;
}

static double plain_albedo(const plain *p, int c, int i, int side)
{
    const double a = (p->with & WITH_ALBEDO) ? (double)p->s->albedo[c][i] : 1;
    if (p->o.albedo_mode == MS_SSS_ALBEDO_BOTH) return sqrt(a);
    return (p->o.albedo_mode == MS_SSS_ALBEDO_PRE) == (side == 0) ? a : 1;
}

/* One pass of a term over in[3][n]. */
static void plain_pass(const plain *p, int term, int second, double *const in[3], double *const out[3])
{
    const int w = p->s->width, h = p->s->height;
    int x, y, k, c, sub;
    for (y = 0; y < h; ++y) {
        for (x = 0; x < w; ++x) {
            const int i = y * w + x;
            const ms_sss_kernel *kernel;
            double size[2], dx = second ? 0 : 1, dy = second ? 1 : 0, sum[3] = {0, 0, 0}, norm[3] = {0, 0, 0};
            double total[3] = {0, 0, 0};
            int mixed[3] = {0, 0, 0};
            if (!plain_part(p, i)) continue;
            kernel = &p->kernels[plain_profile(p, i)];
            plain_size(p, i, size);
            if (p->o.rotation != 0 || p->o.jitter > 0) {
                const double angle = (double)p->o.rotation +
                                     (double)p->o.jitter * ((((unsigned)x * 49472u + (unsigned)y * 37345u) % 65536u / 1024u) + 0.5) / 64 * 3.14159265358979323846 / 2;
                dx = second ? -sin(angle) : cos(angle);
                dy = second ? cos(angle) : sin(angle);
            }
            for (k = 0; k < kernel->tap_count; ++k) {
                const double tx = (double)kernel->offset_mm[k] * dx * size[0], ty = (double)kernel->offset_mm[k] * dy * size[1];
                for (c = 0; c < 3; ++c) {
                    total[c] += (double)kernel->weight[term][k][c];
                    if (kernel->weight[term][k][c] < 0) mixed[c] = 1;
                }
                for (sub = 0; sub < 4; ++sub) {
                    const int px = x + (int)floor(tx) + sub % 2, py = y + (int)floor(ty) + sub / 2, j = py * w + px;
                    const double ax = tx - floor(tx), ay = ty - floor(ty);
                    double f = (sub % 2 ? ax : 1 - ax) * (sub / 2 ? ay : 1 - ay);
                    if (f <= 0 || px < 0 || py < 0 || px >= w || py >= h || !plain_part(p, j)) continue;
                    if (plain_profile(p, i) != plain_profile(p, j)) continue;
                    f *= plain_depth_factor(p, kernel, i, j);
                    for (c = 0; c < 3; ++c) {
                        sum[c] += (double)kernel->weight[term][k][c] * f * in[c][j];
                        norm[c] += (double)kernel->weight[term][k][c] * f;
                    }
                }
            }
            for (c = 0; c < 3; ++c) {
                if (mixed[c] || ((p->with & WITH_DEPTH) && p->o.depth_mode == MS_SSS_DEPTH_FOLLOW))
                    out[c][i] = sum[c] + (total[c] - norm[c]) * in[c][i];
                else out[c][i] = norm[c] > 0 ? sum[c] * total[c] / norm[c] : total[c] * in[c][i];
                if (plain_small(p, i)) out[c][i] = total[c] * in[c][i];
            }
        }
    }
}

static void plain_filter(const plain *p, double *const out[3])
{
    const int n = p->s->width * p->s->height;
    double *e[3], *a[3], *b[3];
    int t, c, i, terms = 1;
    for (c = 0; c < 3; ++c) {
        e[c] = (double *)malloc((size_t)n * sizeof(double));
        a[c] = (double *)calloc((size_t)n, sizeof(double));
        b[c] = (double *)calloc((size_t)n, sizeof(double));
        for (i = 0; i < n; ++i) {
            e[c][i] = plain_part(p, i) ? (double)p->s->rgb[c][i] * plain_albedo(p, c, i, 0) : 0;
            out[c][i] = 0;
        }
    }
    for (i = 0; i < p->count; ++i)
        if (p->kernels[i].term_count > terms) terms = p->kernels[i].term_count;
    for (t = 0; t < terms; ++t) {
        plain_pass(p, t, 0, e, a);
        plain_pass(p, t, 1, a, b);
        for (c = 0; c < 3; ++c)
            for (i = 0; i < n; ++i)
                if (plain_part(p, i)) out[c][i] += (double)p->kernels[plain_profile(p, i)].scale[t][c] * b[c][i];
    }
    for (c = 0; c < 3; ++c) {
        for (i = 0; i < n; ++i) {
            if (plain_part(p, i)) {
                double s = 1 - (double)p->o.fade;
                if (p->with & WITH_STRENGTH) s *= (double)p->s->strength[i] < 1 ? (double)p->s->strength[i] : 1;
                out[c][i] += (double)p->kernels[plain_profile(p, i)].delta[c] * e[c][i];
                if (plain_small(p, i)) out[c][i] = e[c][i];
                out[c][i] = ((1 - s) * e[c][i] + s * out[c][i]) * plain_albedo(p, c, i, 1);
            } else {
                out[c][i] = (double)p->s->rgb[c][i];
                if (ms__finite_f(p->s->rgb[c][i]) && (p->with & WITH_ALBEDO)) out[c][i] *= (double)p->s->albedo[c][i];
            }
            if (p->with & WITH_SPECULAR) out[c][i] += (double)p->s->specular[c][i];
        }
        free(e[c]);
        free(a[c]);
        free(b[c]);
    }
}

/* Largest difference from the plain filter over all levels of this machine. The inputs are at most 3. */
static double test_against_plain(const test_scene *s, const ms_sss_kernel *kernels, int count,
                                 const ms_sss_filter_options *options, int with)
{
    const int n = s->width * s->height;
    plain p;
    double *expected[3], worst = 0;
    float *out[3];
    int level, c, i;
    p.s = s;
    p.kernels = kernels;
    p.count = count;
    p.with = with;
    p.o = *options;
    for (c = 0; c < 3; ++c) {
        expected[c] = (double *)malloc((size_t)n * sizeof(double));
        out[c] = test_floats(n);
    }
    plain_filter(&p, expected);
    for (level = MS_SIMD_SCALAR; level <= MS_SIMD_AVX512; ++level) {
        ms_sss_filter_options o = *options;
        ms_sss_frame f = test_frame(s, with, out);
        o.simd = (ms_simd)level;
        for (c = 0; c < 3; ++c) memset(out[c], 0xff, (size_t)n * sizeof(float));
        test_run(&f, kernels, count, &o);
        for (c = 0; c < 3; ++c) {
            for (i = 0; i < n; ++i) {
                double e = fabs((double)out[c][i] - expected[c][i]);
                if (!(e <= worst)) worst = e == e ? e : (expected[c][i] != expected[c][i] ? worst : 1e9);
            }
        }
    }
    for (c = 0; c < 3; ++c) {
        free(expected[c]);
        free(out[c]);
    }
    return worst;
}

/* Two passes of at most 50 float products each, inputs up to 3: rounding adds up to about 50 * 6e-8 * 3 = 1e-5 at
   worst; the depth differences of float depths near 100 with sigma about 1 add 1e-5 where a weight is steep. */
#define PLAIN_TOLERANCE 1e-5

static ms_sss_filter_options test_options(int kind)
{
    ms_sss_filter_options o = ms_sss_filter_defaults();
    if (kind == 0) o.pixels_per_mm[0] = 2.1f;
    if (kind == 1) o.fov_degrees = 35;
    if (kind == 2) o.ortho_height = 40;
    return o;
}

static void case_plain(void)
{
    test_scene s = test_scene_make(83, 61, test_seed);
    ms_sss_kernel kernel[3];
    int kind, with, variant;
    double worst = 0;
    kernel[0] = test_kernel(7, 5.0, 0.0);
    kernel[1] = test_kernel(11, 2.0, 0.2);
    kernel[2] = test_kernel_terms(9, 4.0);
    for (kind = 0; kind < 3; ++kind) {
        for (with = 0; with < 32; ++with) {
            if (kind == 1 && !(with & WITH_DEPTH)) continue;
            for (variant = 0; variant < 8; ++variant) {
                ms_sss_filter_options o = test_options(kind);
                const ms_sss_kernel *k = &kernel[with & WITH_PROFILE ? 0 : variant % 3];
                double e;
                if (!test_full && (with * 8 + variant + kind) % 5) continue;
                if (variant & 1) o.pixels_per_mm[1] = kind == 0 ? 3.3f : 0.0f;
                if (variant & 2) o.rotation = 0.6f;
                if (variant & 4) o.jitter = 0.8f;
                o.depth_mode = (ms_sss_depth_mode)((with + variant) % 3);
                o.albedo_mode = (ms_sss_albedo_mode)((with / 4 + variant) % 3);
                o.uv_steps = variant % 2;
                o.fade = variant % 3 ? 0.0f : 0.25f;
                e = test_against_plain(&s, k, with & WITH_PROFILE ? 2 : 1, &o, with);
                if (!(e <= PLAIN_TOLERANCE)) TEST_FAIL("kind %d with %d variant %d: %g", kind, with, variant, e);
                if (e > worst) worst = e;
            }
        }
    }
    TEST_NOTE("largest difference %.1e", worst);
    test_scene_free(&s);
}

static const test_case cases[] = {
    {"plain filter in double", case_plain},
};
TEST_MAIN(cases)
