/* Attacks on ms_sss.h: pictures of any size, aspect, camera and depth through both filters, kernels and profiles over
   their whole ranges, kernels with damaged fields. */
#define MS_SSS_IMPLEMENTATION
#define MS_SSS_WITH_SCALAR
#include "ms_sss.h"
#include "attack.h"

enum { MODELS = 9 };

static int finite_float(float f) { return f - f == 0; }

/* ---- profiles and kernels ------------------------------------------------------------------------------------------ */

static ms_status draw_profile(ms_sss_profile **p, double base_mm, ms_error *error)
{
    int c, i;
    double r[3], d[3];
    for (c = 0; c < 3; ++c) {
        r[c] = attack_one_in(12) ? 0 : attack_linear(1e-3, 1);
        d[c] = base_mm * attack_log(0.01, 1);
    }
    if (r[0] + r[1] + r[2] == 0) r[0] = 0.5;
    switch (attack_index(4)) {
    case 1: {
        double sigma[4][3], weight[4][3];
        const int n = 1 + attack_index(4);
        for (i = 0; i < n; ++i)
            for (c = 0; c < 3; ++c) {
                sigma[i][c] = base_mm * attack_log(1e-2, 1);
                weight[i][c] = r[c] / n;
            }
        attack_say("%d gaussians of %.4g mm; ", n, base_mm);
        return ms_sss_profile_from_gaussians(p, n, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, error);
    }
    case 2: {
        enum { RINGS = 12 };
        double edge[RINGS + 1], v[3][RINGS];
        const double *value[3];
        edge[0] = attack_one_in(3) ? 0.01 * base_mm : 0;
        for (i = 0; i < RINGS; ++i) {
            edge[i + 1] = edge[i] + base_mm * 0.02 * attack_log(0.01, 10);
            for (c = 0; c < 3; ++c)
                v[c][i] = r[c] * exp(-edge[i] / d[c]) / (6.3 * d[c] * d[c]) * (attack_one_in(6) ? 0 : 1);
        }
        for (c = 0; c < 3; ++c) value[c] = v[c];
        attack_say("rings to %.4g mm; ", edge[RINGS]);
        return ms_sss_profile_from_rings(p, RINGS, edge, value, 1, NULL, error);
    }
    default:
        attack_say("burley %.4g %.4g %.4g, d %.4g %.4g %.4g mm; ", r[0], r[1], r[2], d[0], d[1], d[2]);
        return ms_sss_profile_from_burley(p, r, d, NULL, error);
    }
}

static void draw_kernel_options(ms_sss_kernel_options *o)
{
    *o = ms_sss_kernel_defaults();
    o->model = (ms_sss_model)attack_index(MODELS);
    o->placement = (ms_sss_placement)attack_index(3);
    o->tap_count = attack_one_in(8) ? MS_SSS_DENSE
                                    : 3 + 2 * (int)attack_int(0, o->placement == MS_SSS_OPTIMIZED ? 15 : 40);
    if (o->tap_count == MS_SSS_DENSE && o->model == MS_SSS_IMAGE_OPTIMAL) o->model = MS_SSS_PREINTEGRATED;
    o->term_count = attack_one_in(2) ? (int)attack_int(1, MS_SSS_TERMS_MAX) : 0;
    o->no_delta = attack_one_in(4);
    o->dial = attack_one_in(2) ? attack_linear(0, 1) : 0;
    o->guide_k = attack_linear(0, 4);
    o->index = attack_one_in(2) ? attack_linear(1, 2) : 0;
    attack_say("model %d placement %d taps %d terms %d no_delta %d dial %.3g k %.3g; ", (int)o->model,
               (int)o->placement, o->tap_count, o->term_count, o->no_delta, o->dial, o->guide_k);
}

/* delta + sum over terms of scale (sum of weights)^2. */
static double kernel_sum(const ms_sss_kernel *k, int c)
{
    double sum = (double)k->delta[c];
    int t, i;
    for (t = 0; t < k->term_count; ++t) {
        double w = 0;
        for (i = 0; i <= k->tap_count / 2; ++i) w += (i ? 2 : 1) * (double)k->weight[t][i][c];
        sum += (double)k->scale[t][c] * w * w;
    }
    return sum;
}

static int kernel_positive(const ms_sss_kernel *k)
{
    int t, i, c;
    for (c = 0; c < 3; ++c) {
        if (!(k->delta[c] >= 0)) return 0;
        for (t = 0; t < k->term_count; ++t) {
            if (!(k->scale[t][c] >= 0)) return 0;
            for (i = 0; i <= k->tap_count / 2; ++i)
                if (!(k->weight[t][i][c] >= 0)) return 0;
        }
    }
    return 1;
}

/* A kernel of any options is normalized, can be measured, and every call that takes kernels takes it. */
static void family_kernels(void)
{
    static ms_sss_kernel k;
    ms_sss_kernel_options o;
    ms_sss_profile *p = NULL;
    ms_sss_errors e;
    ms_error error = attack_no_error();
    ms_status status;
    const double base = attack_log(1e-3, 1e3), radius = attack_one_in(3) ? attack_log(1e-3, 1) : attack_log(1, 200);
    float light[8 * 8 * 3], out[8 * 8 * 3];
    ms_sss_frame f;
    ms_sss_filter_options fo = ms_sss_filter_defaults();
    int c, i;
    if (draw_profile(&p, base, &error) != MS_OK) {
        attack_fail("a valid profile is refused: %s", error.message);
        return;
    }
    draw_kernel_options(&o);
    attack_say("radius %.5g px", radius);
    memset(&k, 0x55, sizeof k);
    status = ms_sss_kernel_make(&k, &e, p, radius, &o, NULL, &error);
    ms_sss_profile_destroy(p);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        for (i = 0; i < (int)sizeof k; ++i)
            if (((unsigned char *)&k)[i] != 0x55) {
                attack_fail("output touched on failure: kernel");
                break;
            }
        return; /* options may not fit each other */
    }
    for (c = 0; c < 3; ++c)
        if (o.model != MS_SSS_SVD)
            ATTACK_CHECK(fabs(kernel_sum(&k, c) - 1) < 2e-5, "kernel not normalized: channel %d sums to %.7g", c,
                         kernel_sum(&k, c));
        else
            ATTACK_CHECK(kernel_sum(&k, c) < 1 + 2e-5, "svd gains energy: channel %d sums to %.7g", c,
                         kernel_sum(&k, c));
    ATTACK_CHECK(e.texture >= 0 && e.texture < 1e6 && e.dot >= 0 && e.bands >= 0, "errors not finite: %g %g %g",
                 e.texture, e.dot, e.bands);
    memset(&f, 0, sizeof f);
    for (i = 0; i < 8 * 8 * 3; ++i) light[i] = 1;
    f.width = f.height = 8;
    f.input = ms_sss_interleaved(light, 3);
    f.output = ms_sss_interleaved(out, 3);
    fo.pixels_per_mm[0] = (float)(2 / base);
    status = ms_sss_filter(&f, &k, 1, &fo, NULL, 0, &error);
    if (status != MS_OK) attack_fail("a kernel that was made is refused: %s", error.message);
    else
        for (i = 0; i < 8 * 8 * 3; ++i)
            if (!finite_float(out[i]) ||
                (o.model != MS_SSS_SVD && kernel_positive(&k) && fabs((double)out[i] - 1) > 1e-5))
                attack_fail("a constant of 1: %.7g", (double)out[i]);
}

/* ---- pictures ------------------------------------------------------------------------------------------------------ */

/* Kernels of every kind, made when first wanted. */
enum { POOL = 14 };
static ms_sss_kernel pool[POOL];
static ms_sss_pyramid pool_pyramid[3];
static int pool_made[POOL], pyramid_made[3];

static const ms_sss_kernel *pool_kernel(int i)
{
    static const int taps[POOL] = {7, 17, 3, 33, 7, 7, 5, 41, 7, 11, 65, 9, 25, 1};
    static const double radius[3] = {24, 8, 60}, r[3] = {0.44, 0.22, 0.13}, d[3] = {1.2, 0.5, 0.3};
    static const double bright[3] = {0.95, 0.9, 0.8}, far[3] = {3, 2, 1};
    if (!pool_made[i]) {
        ms_sss_profile *p = NULL;
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        o.tap_count = taps[i];
        if (i == 4) o.model = MS_SSS_RESIDUAL;
        if (i == 5) o.model = MS_SSS_GAUSSIANS, o.term_count = 3;
        if (i == 6) o.model = MS_SSS_SVD, o.term_count = 3;
        if (i == 8) o.model = MS_SSS_GUIDED;
        if (i == 9) o.model = MS_SSS_ARTIST;
        if (i == 11) o.model = MS_SSS_SLICE, o.placement = MS_SSS_QUADRATIC;
        if (taps[i] > 33) o.placement = MS_SSS_QUANTILE;
        if (i == 13) o.model = MS_SSS_PREINTEGRATED, o.tap_count = MS_SSS_DENSE;
        if (ms_sss_profile_from_burley(&p, i % 2 ? bright : r, i % 2 ? far : d, NULL, NULL) != MS_OK ||
            ms_sss_kernel_make(&pool[i], NULL, p, radius[i % 3], &o, NULL, NULL) != MS_OK)
            attack_fail("a kernel of the pool is refused: %d", i);
        ms_sss_profile_destroy(p);
        pool_made[i] = 1;
    }
    return &pool[i];
}

static const ms_sss_pyramid *pool_pyramid_of(int i)
{
    static const double r[3][3] = {{0.44, 0.22, 0.13}, {0.95, 0.9, 0.8}, {0.1, 0.5, 0.01}},
                        d[3][3] = {{1.2, 0.5, 0.3}, {3, 2, 1}, {0.1, 4, 0.7}};
    if (!pyramid_made[i]) {
        ms_sss_profile *p = NULL;
        if (ms_sss_profile_from_burley(&p, r[i], d[i], NULL, NULL) != MS_OK ||
            ms_sss_pyramid_make(&pool_pyramid[i], p, NULL) != MS_OK)
            attack_fail("a pyramid of the pool is refused: %d", i);
        ms_sss_profile_destroy(p);
        pyramid_made[i] = 1;
    }
    return &pool_pyramid[i];
}

typedef struct picture {
    ms_sss_image image;
    float *memory;
    size_t floats;
} picture;

/* Three channels or one of w x h in a drawn layout; what lies between the pixels is 77. */
static void draw_picture(picture *p, int w, int h, int channels)
{
    const int layout = attack_index(4), gap = (int)attack_int(0, 5);
    size_t i, stride = layout == 1 ? 4 : layout == 2 || channels == 1 ? 1 : 3, row = (size_t)w * stride + (size_t)gap;
    int c;
    p->floats = row * (size_t)h * (stride == 1 ? 3 : 1) + 8;
    p->memory = (float *)malloc(p->floats * sizeof(float));
    for (i = 0; i < p->floats; ++i) p->memory[i] = 77;
    memset(&p->image, 0, sizeof p->image);
    for (c = 0; c < channels; ++c)
        p->image.channel[c] = p->memory + (stride == 1 ? (size_t)c * row * (size_t)h : (size_t)c);
    p->image.pixel_stride = (ptrdiff_t)stride;
    p->image.row_stride = (ptrdiff_t)row;
    if (layout == 3) { /* bottom-up */
        for (c = 0; c < channels; ++c) p->image.channel[c] = (float *)p->image.channel[c] + row * (size_t)(h - 1);
        p->image.row_stride = -(ptrdiff_t)row;
    }
}

static float *at(const picture *p, int x, int y, int c)
{
    return (float *)p->image.channel[c] + x * p->image.pixel_stride + y * p->image.row_stride;
}

/* A surface of a drawn kind; returns 1 where it is a plane across the view. */
static int draw_depth(picture *p, int w, int h)
{
    const double base = attack_log(1e-2, 1e4), size = attack_log(1e-5, 3), a = attack_linear(-0.01, 0.01),
                 b = attack_linear(-0.01, 0.01);
    const int kind = attack_index(6);
    uint64_t state = attack_draw();
    int x, y;
    for (y = 0; y < h; ++y)
        for (x = 0; x < w; ++x) {
            double z = 1;
            if (kind == 1) z = fmax(1e-3, 1 + a * x + b * y);
            if (kind == 2) z = 1 + size * (double)(attack_mix(&state) >> 40) / 16777216.0;
            if (kind == 3) z = 1 + size * ((x / 7 + y / 5) % 2);
            if (kind == 4) { /* a ball in front of a wall */
                const double dx = (x - 0.5 * w) / (0.4 * w + 1), dy = (y - 0.5 * h) / (0.4 * h + 1),
                             q = 1 - dx * dx - dy * dy;
                z = 1 + size - (q > 0 ? size * sqrt(q) : 0);
            }
            if (kind == 5) z = 1 + (x == w / 2 ? size : 0);
            *at(p, x, y, 0) = (float)(base * z);
        }
    attack_say("depth kind %d about %.4g, steps %.3g; ", kind, base, size);
    return kind == 0;
}

typedef struct call {
    ms_sss_frame frame;
    ms_sss_filter_options options;
    ms_sss_kernel kernel[3];
    ms_sss_pyramid pyramid[3];
    int kernels, by_pyramid;
} call;

static ms_status run(const call *c, const ms_sss_frame *f, const ms_sss_filter_options *o, ms_error *error, int lend)
{
    size_t bytes = 0;
    unsigned char *work = NULL;
    ms_status status;
    if (lend) {
        bytes = c->by_pyramid ? ms_sss_pyramid_workspace(f->width, f->height)
                              : ms_sss_filter_workspace(f->width, f->height, c->kernel, c->kernels, o);
        if (bytes > (size_t)1 << 28) return MS_OUT_OF_MEMORY;
        work = (unsigned char *)attack_alloc(&attack_heap, bytes + 3);
        if (work == NULL) return MS_OUT_OF_MEMORY;
    }
    if (c->by_pyramid)
        status = ms_sss_pyramid_filter(f, c->pyramid, c->kernels, o, work ? work + 3 : NULL, bytes, error);
    else status = ms_sss_filter(f, c->kernel, c->kernels, o, work ? work + 3 : NULL, bytes, error);
    if (work) attack_release(&attack_heap, work, bytes + 3);
    return status;
}

static int masked_light(const float v[3])
{
    int c;
    for (c = 0; c < 3; ++c)
        if (!(fabsf(v[c]) < 1e30f)) return 1;
    return 0;
}

static void filter(int by_pyramid)
{
    static call k;
    ms_sss_filter_options o = ms_sss_filter_defaults(), other;
    picture in, out, depth, strength, normal, again;
    uint8_t *profile = NULL;
    ms_error error = attack_no_error();
    ms_status status;
    const int w = (int)attack_int(1, attack_one_in(20) ? 2000 : 65), h = (int)attack_int(1, w > 65 ? 8 : 65);
    const int constant = attack_one_in(3), camera = attack_index(3), with_depth = camera != 0 || attack_one_in(3);
    const double level = attack_one_in(4) ? attack_log(1e-30, 1e29) : 1;
    int x, y, c, flat_depth = 1, dirty = 0, i, svd = 0, positive = 1, mirror, empty = 0;
    float most = 0, least_reflectance[3] = {1, 1, 1};
    memset(&k, 0, sizeof k);
    k.by_pyramid = by_pyramid;
    k.kernels = 1;
    k.frame.width = w;
    k.frame.height = h;
    attack_say("%d x %d, camera %d; ", w, h, camera);
    draw_picture(&in, w, h, 3);
    draw_picture(&out, w, h, 3);
    draw_picture(&again, w, h, 3);
    draw_picture(&depth, w, h, 1);
    draw_picture(&strength, w, h, 1);
    draw_picture(&normal, w, h, 3);
    {
        uint64_t state = attack_draw();
        const int dots = attack_one_in(3);
        const double value = attack_unit();
        for (y = 0; y < h; ++y)
            for (x = 0; x < w; ++x)
                for (c = 0; c < 3; ++c) {
                    double u = (double)(attack_mix(&state) >> 40) / 16777216.0;
                    if (dots) u = u > 0.95 ? u : 0;
                    *at(&in, x, y, c) = (float)(level * (constant ? 0.1 + value : u));
                    *at(&normal, x, y, c) = (float)((c == 2 ? 1.2 : 0) + u - 0.5);
                    *at(&out, x, y, c) = -7;
                    if (c == 0) *at(&strength, x, y, 0) = (float)(u < 0.2 ? 0 : u > 0.8 ? 1 : u);
                }
    }
    if (with_depth) {
        flat_depth = draw_depth(&depth, w, h);
        k.frame.depth = depth.image;
    }
    if (attack_one_in(4)) k.frame.strength = strength.image;
    if (with_depth && attack_one_in(4)) {
        k.frame.normal = normal.image;
        flat_depth = 0;
    }
    if (attack_one_in(4)) {
        profile = (uint8_t *)malloc((size_t)w * (size_t)h);
        k.kernels = 1 + attack_index(3);
        for (i = 0; i < w * h; ++i) profile[i] = (uint8_t)((i / 5 + i / w / 3) % (k.kernels + 1));
        k.frame.profile = profile;
    }
    for (i = 0; i < k.kernels; ++i) {
        if (by_pyramid) {
            k.pyramid[i] = *pool_pyramid_of(attack_index(3));
            for (c = 0; c < 3; ++c) least_reflectance[c] = fminf(least_reflectance[c], k.pyramid[i].reflectance[c]);
        } else {
            const int which = attack_index(POOL);
            k.kernel[i] = *pool_kernel(which);
            svd |= which == 6;
            positive &= kernel_positive(&k.kernel[i]);
            attack_say("kernel %d; ", which);
            for (c = 0; c < 3; ++c) least_reflectance[c] = fminf(least_reflectance[c], k.kernel[i].reflectance[c]);
        }
    }
    if (camera == 0) {
        o.pixels_per_mm[0] = (float)attack_log(1e-3, 1e3);
        if (!by_pyramid && attack_one_in(2)) o.pixels_per_mm[1] = (float)attack_log(1e-3, 1e3);
    } else if (camera == 1) {
        o.fov_degrees = (float)attack_log(0.1, 179);
        if (attack_one_in(3)) {
            o.center[0] = (float)attack_linear(-300, 300);
            o.center[1] = (float)attack_linear(-300, 300);
        }
    } else o.ortho_height = (float)attack_log(1e-2, 1e4);
    o.mm_per_unit = (float)attack_log(1e-3, 1e3);
    if (attack_one_in(3)) o.depth_sigma_mm = (float)attack_log(1e-3, 1e3);
    o.flat = attack_one_in(3) ? 1 : attack_one_in(3) ? (float)attack_unit() : 0;
    o.depth_mode = attack_one_in(5) ? MS_SSS_DEPTH_SCALE : MS_SSS_DEPTH_AWARE;
    o.exact = attack_one_in(3);
    o.simd = (ms_simd)attack_index(5);
    attack_say("ppm %.5g %.5g, fov %.4g, ortho %.4g, center %.4g %.4g, mm %.4g, sigma %.4g, flat %.3g, mode %d, exact "
               "%d, simd %d, strength %d, normals %d, profiles %d, level %.3g, constant %d",
               (double)o.pixels_per_mm[0], (double)o.pixels_per_mm[1], (double)o.fov_degrees, (double)o.ortho_height,
               (double)o.center[0], (double)o.center[1], (double)o.mm_per_unit, (double)o.depth_sigma_mm,
               (double)o.flat, (int)o.depth_mode, o.exact, (int)o.simd, k.frame.strength.channel[0] != NULL,
               k.frame.normal.channel[0] != NULL, k.frame.profile ? k.kernels : 0, level, constant);
    if (attack_one_in(3)) { /* pixels that must be masked, or odd depths and normals */
        dirty = 1;
        for (i = 0; i < 12; ++i) {
            const float v = attack_odd_float();
            x = attack_index(w);
            y = attack_index(h);
            switch (attack_index(4)) {
            case 0: *at(&in, x, y, attack_index(3)) = v; break;
            case 1: *at(&depth, x, y, 0) = v; break;
            case 2: *at(&strength, x, y, 0) = v; break;
            default: *at(&normal, x, y, attack_index(3)) = v;
            }
        }
        flat_depth = 0;
    }
    k.frame.input = in.image;
    k.frame.output = out.image;
    for (y = 0; y < h; ++y)
        for (x = 0; x < w; ++x)
            for (c = 0; c < 3; ++c)
                if (fabsf(*at(&in, x, y, c)) < 1e30f) most = fmaxf(most, fabsf(*at(&in, x, y, c)));
    if (attack_one_in(24)) { /* the last of several that was never made is refused before anything is written */
        empty = 1;
        if (by_pyramid) memset(&k.pyramid[k.kernels - 1], 0, sizeof k.pyramid[0]);
        else memset(&k.kernel[k.kernels - 1], 0, sizeof k.kernel[0]);
        attack_say(", the last kernel is empty");
    }
    status = run(&k, &k.frame, &o, &error, attack_one_in(2));
    if (empty && status == MS_OK) attack_fail("an empty kernel is taken: of %d", k.kernels);
    if (status != MS_OK) {
        if (status != MS_OUT_OF_MEMORY) attack_check_error(status, &error);
        for (y = 0; y < h; ++y)
            for (x = 0; x < w; ++x)
                for (c = 0; c < 3; ++c)
                    if (*at(&out, x, y, c) != -7) attack_fail("output touched on failure: %s", error.message);
    } else {
        for (y = 0; y < h && !attack->failed; ++y)
            for (x = 0; x < w && !attack->failed; ++x) {
                float v[3], r[3];
                int masked;
                for (c = 0; c < 3; ++c) {
                    v[c] = *at(&in, x, y, c);
                    r[c] = *at(&out, x, y, c);
                }
                masked = masked_light(v);
                if (with_depth) masked |= !(*at(&depth, x, y, 0) > 0 && finite_float(*at(&depth, x, y, 0)));
                if (masked) {
                    if (memcmp(v, r, sizeof v) != 0)
                        attack_fail("a masked pixel changes: %d, %d: %g %g %g to %g %g %g", x, y, (double)v[0],
                                    (double)v[1], (double)v[2], (double)r[0], (double)r[1], (double)r[2]);
                    continue;
                }
                for (c = 0; c < 3; ++c) {
                    if (!finite_float(r[c])) attack_fail("not finite of finite: %d, %d is %g", x, y, (double)r[c]);
                    else if (constant && !dirty && !svd &&
                             (!with_depth || flat_depth || o.flat == 1 || o.depth_mode == MS_SSS_DEPTH_SCALE) &&
                             fabs((double)r[c] - (double)v[c]) > 1.5e-6 * (double)v[c])
                        attack_fail("a constant changes: %.7g at %d, %d for %.7g", (double)r[c], x, y, (double)v[c]);
                    else if (positive && !dirty && (double)r[c] < -1e-6 * (double)most)
                        attack_fail("negative light: %.7g at %d, %d", (double)r[c], x, y);
                    else if (positive && !dirty && (double)r[c] * (double)least_reflectance[c] > (double)most * 1.00001)
                        attack_fail("brighter than the brightest: %.7g times %.4g at %d, %d, brightest %.7g",
                                    (double)r[c], (double)least_reflectance[c], x, y, (double)most);
                }
            }
        for (i = 0; i < (int)out.floats && !attack->failed; ++i) { /* what lies between pixels */
            const ptrdiff_t stride = out.image.pixel_stride;
            if (stride == 4 && i % 4 == 3 && out.image.row_stride == (ptrdiff_t)w * 4 && i < w * h * 4 &&
                out.memory[i] != 77)
                attack_fail("written between pixels: float %d", i);
        }
        /* in place, in another order of tasks, with other light under the mask: the same bits */
        other = o;
        if (attack_one_in(2)) other.parallel = attack_parallel();
        for (y = 0; y < h; ++y)
            for (x = 0; x < w; ++x) {
                float v[3];
                int masked;
                for (c = 0; c < 3; ++c) v[c] = *at(&in, x, y, c);
                masked = masked_light(v);
                for (c = 0; c < 3; ++c) *at(&again, x, y, c) = masked ? (c == x % 3 ? NAN : 3e33f) : v[c];
            }
        {
            ms_sss_frame f = k.frame;
            f.input = f.output = again.image;
            status = run(&k, &f, &other, &error, attack_one_in(2));
            if (status != MS_OK && status != MS_OUT_OF_MEMORY) attack_fail("refused in place: %s", error.message);
            if (status == MS_OK)
                for (y = 0; y < h && !attack->failed; ++y)
                    for (x = 0; x < w && !attack->failed; ++x) {
                        float v[3];
                        for (c = 0; c < 3; ++c) v[c] = *at(&in, x, y, c);
                        for (c = 0; c < 3 && !masked_light(v); ++c)
                            if (memcmp(at(&again, x, y, c), at(&out, x, y, c), sizeof(float)) != 0)
                                attack_fail("other bits in place, by tasks or under a mask: %.9g, %.9g at %d, %d",
                                            (double)*at(&again, x, y, c), (double)*at(&out, x, y, c), x, y);
                    }
        }
        /* turned by 180 degrees, without depth: turned */
        mirror = !with_depth && !profile && !dirty && !by_pyramid;
        if (mirror && !k.frame.strength.channel[0] && !attack->failed) {
            ms_sss_frame f = k.frame;
            for (y = 0; y < h; ++y)
                for (x = 0; x < w; ++x)
                    for (c = 0; c < 3; ++c) *at(&again, w - 1 - x, h - 1 - y, c) = *at(&in, x, y, c);
            f.input = f.output = again.image;
            if (run(&k, &f, &o, &error, 0) == MS_OK)
                for (y = 0; y < h && !attack->failed; ++y)
                    for (x = 0; x < w && !attack->failed; ++x)
                        for (c = 0; c < 3; ++c) {
                            const double a = (double)*at(&again, w - 1 - x, h - 1 - y, c),
                                         b = (double)*at(&out, x, y, c);
                            if (fabs(a - b) > 4e-6 * (double)most)
                                attack_fail("turned by 180 degrees: %.8g for %.8g at %d, %d", a, b, x, y);
                        }
        }
        /* Another level of instructions. Over normals of no surface the last two bits of one depth, in the case that was
           looked at, count for 3e-5: three times that. Taps with weights of both signs reach 7e-6 there. Where weights
           by depth fall within few roundings of the depths, these decide. */
        if (!attack->failed) {
            double close = k.frame.normal.channel[0] ? 1e-4 : 4e-6, deepest = 0;
            for (y = 0; y < h && with_depth; ++y)
                for (x = 0; x < w; ++x)
                    if (finite_float(*at(&depth, x, y, 0))) deepest = fmax(deepest, (double)*at(&depth, x, y, 0));
            if (o.depth_sigma_mm > 0)
                close += 4 * deepest / 8388608 * (o.mm_per_unit > 0 ? (double)o.mm_per_unit : 1) /
                    (3.0746 * (double)o.depth_sigma_mm);
            other = o;
            other.simd = MS_SIMD_SCALAR;
            k.frame.output = again.image;
            if (run(&k, &k.frame, &other, &error, 0) == MS_OK)
                for (y = 0; y < h && !attack->failed; ++y)
                    for (x = 0; x < w && !attack->failed; ++x)
                        for (c = 0; c < 3; ++c) {
                            const double a = (double)*at(&again, x, y, c), b = (double)*at(&out, x, y, c);
                            if (a - a == 0 && b - b == 0 && fabs(a) < 1e30 && !dirty &&
                                fabs(a - b) > close * fmax((double)most, fabs(a)))
                                attack_fail("levels differ: %.8g scalar, %.8g at %d, %d, largest input %.4g", a, b, x,
                                            y, (double)most);
                        }
        }
    }
    free(in.memory);
    free(out.memory);
    free(again.memory);
    free(depth.memory);
    free(strength.memory);
    free(normal.memory);
    free(profile);
}

static void family_filter(void) { filter(0); }
static void family_pyramid(void) { filter(1); }

/* A kernel with a damaged field: refused, or harmless. */
static void family_damaged(void)
{
    static ms_sss_kernel k;
    static ms_sss_designer *designer; /* one a process: it costs more than the rest */
    ms_sss_errors e;
    ms_error error;
    float light[16 * 9 * 3], out[16 * 9 * 3], depth[16 * 9];
    ms_sss_frame f;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    const int which = attack_index(POOL), field = attack_index(13);
    int i, hit = (int)attack_int(0, MS_SSS_TAPS_MAX / 2), c = attack_index(3);
    const float v = attack_one_in(2) ? attack_odd_float()
                                     : (float)(attack_log(1e-38, 1e38) * (attack_one_in(2) ? -1 : 1));
    const int count = attack_one_in(2) ? (int)attack_int(-3, 700) : (int)attack_int(-2147483647, 2147483647);
    k = *pool_kernel(which);
    if (hit > k.tap_count / 2 && attack_one_in(2)) hit = attack_index(k.tap_count / 2 + 1);
    switch (field) {
    case 0: k.tap_count = count; break;
    case 1: k.term_count = count; break;
    case 2:
    case 3: k.offset_mm[hit] = v; break;
    case 4: k.weight[attack_index(MS_SSS_TERMS_MAX)][hit][c] = v; break;
    case 5: k.scale[attack_index(MS_SSS_TERMS_MAX)][c] = v; break;
    case 6: k.delta[c] = v; break;
    case 7: k.radius_mm = v; break;
    case 8: k.reflectance[c] = v; break;
    case 9: k.profile_radius_mm = v; break;
    case 10: k.elevation[c] = v; break;
    case 11: k.decay[c] = v; break;
    default: k.elevation_axis[c] = v;
    }
    attack_say("kernel %d, field %d of tap %d, channel %d: %g or %d", which, field, hit, c, (double)v, count);
    for (i = 0; i < 16 * 9 * 3; ++i) light[i] = (float)(i % 7);
    for (i = 0; i < 16 * 9; ++i) depth[i] = 10 + 0.1f * (float)(i % 16);
    memset(&f, 0, sizeof f);
    f.width = 16;
    f.height = 9;
    f.input = ms_sss_interleaved(light, 3);
    f.output = ms_sss_interleaved(out, 3);
    f.depth = ms_sss_map(depth, 1);
    o.pixels_per_mm[0] = 2;
    o.flat = attack_one_in(2) ? 1 : 0;
    o.simd = (ms_simd)attack_index(5);
    if (ms_sss_filter(&f, &k, 1, &o, NULL, 0, &error) == MS_OK && field != 4 && field != 5 && field != 6)
        for (i = 0; i < 16 * 9 * 3; ++i)
            if (!finite_float(out[i])) {
                attack_fail("not finite of a damaged kernel: field %d", field);
                break;
            }
    ms_sss_filter_workspace(16, 9, &k, 1, &o);
    if (attack_one_in(2)) {
        static float constants[4 + 6 + MS_SSS_TAPS_MAX / 2][4];
        ms_sss_shader s = ms_sss_shader_defaults();
        s.tap_count = MS_SSS_TAPS_MAX;
        ms_sss_shader_constants(&k, attack_index(3), &o, 16, 9, &s, constants, &error);
    }
    if (designer == NULL) {
        static const double r[3] = {0.44, 0.22, 0.13}, d[3] = {1.2, 0.5, 0.3};
        ms_sss_profile *p = NULL;
        if (ms_sss_profile_from_burley(&p, r, d, NULL, NULL) == MS_OK)
            ms_sss_designer_create(&designer, p, 24, NULL, NULL);
        ms_sss_profile_destroy(p);
    }
    if (designer && attack_one_in(4)) {
        ms_sss_kernel_measure(&e, &k, designer);
    }
}

/* Integrals of a profile agree with each other. */
static void family_profiles(void)
{
    ms_sss_profile *p = NULL;
    ms_error error = attack_no_error();
    double total[3], disc[3], strip[3], last_disc[3] = {0, 0, 0}, last_strip[3] = {0, 0, 0}, v[3], radius[3];
    const double base = attack_log(1e-2, 1e6); /* rings at least 1e-9 mm wide */
    int i, c;
    if (draw_profile(&p, base, &error) != MS_OK) {
        attack_fail("a valid profile is refused: %s", error.message);
        return;
    }
    ms_sss_profile_reflectance(p, total);
    for (i = 0; i < 40; ++i) {
        const double r = base * 1e-6 * pow(10, i * 0.25);
        ms_sss_profile_disc(p, r, disc);
        ms_sss_profile_strip(p, r, strip);
        ms_sss_profile_value(p, r, v);
        for (c = 0; c < 3; ++c) {
            if (!(v[c] >= 0)) attack_fail("a profile's value: %.9g at %.4g mm", v[c], r);
            if (!(disc[c] >= last_disc[c] - 1e-9 * total[c] && disc[c] <= total[c] * (1 + 1e-6)))
                attack_fail("light of discs: %.9g within %.4g mm, %.9g before, %.9g in all", disc[c], r, last_disc[c],
                            total[c]);
            if (!(strip[c] >= last_strip[c] - 1e-9 * total[c] && strip[c] >= disc[c] - 1e-6 * total[c] &&
                  strip[c] <= total[c] * (1 + 1e-6)))
                attack_fail("light of strips: %.9g within %.4g mm, %.9g before, %.9g in the disc", strip[c], r,
                            last_strip[c], disc[c]);
            last_disc[c] = disc[c];
            last_strip[c] = strip[c];
        }
    }
    {
        const double part = attack_linear(0, 1);
        ms_sss_profile_radius(p, part, radius);
        for (c = 0; c < 3; ++c) {
            ms_sss_profile_disc(p, radius[c], disc);
            if (total[c] > 0 && part < 1 && !(fabs(disc[c] - part * total[c]) <= 1e-6 * total[c]))
                attack_fail("a radius does not come back: %.9g of the light within that of %.9g", disc[c] / total[c],
                            part);
        }
    }
    {
        static const float up[3] = {0, 0, 1}, down[3] = {0, 0, -1}, one[3] = {1, 1, 1};
        float out[3], thin[3];
        const ms_sss_kernel *k = pool_kernel(attack_index(POOL));
        ms_sss_transmission(k, NAN, up, down, down, one, out);
        ms_sss_transmission(k, 1e6f, up, down, down, one, thin);
        for (c = 0; c < 3; ++c)
            if (!(out[c] <= 0.01f || out[c] != out[c]))
                attack_fail("an unknown thickness is bright: %.4g", (double)out[c]);
    }
    ms_sss_profile_destroy(p);
}

int main(int argc, char **argv)
{
    static const attack_family families[] = {{"filter", family_filter},
                                             {"pyramid", family_pyramid},
                                             {"damaged", family_damaged},
                                             {"kernels", family_kernels},
                                             {"profiles", family_profiles}};
    return attack_main(argc, argv, families, (int)(sizeof families / sizeof *families));
}
