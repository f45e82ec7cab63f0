/* The shader files of examples/engine/shader against the filter on the CPU, half resolution and rotated axes against
   plain loops in double: GLSL through EGL without a window, on a software rasteriser where there is no GPU; OpenGL ES
   (as WebGL 2) and WGSL in a headless Chromium where it is installed; every text through glslangValidator where that
   is. libraries: -lEGL */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "image.h"
#define GPU_FILE "sss"
#include "gpu.h"
#include "sss_passes.h"
#include "disc.h"
#include "profile_csv.h"

/* --- a small picture: a bump over a tilted plane; three materials and none; holes, NaN and infinity --- */

enum { WIDTH = 97, HEIGHT = 75, PIXELS = WIDTH * HEIGHT, PROFILES = 3, NOTHING = 255 };
static float light[PIXELS * 4], output[PIXELS * 4], drawn[PIXELS * 4], depth[PIXELS], strength_of[PIXELS],
    index_of[PIXELS];
static float normal[PIXELS * 4], input[PIXELS * 4]; /* light with what a case packs in alpha */
static uint8_t profile[PIXELS];
static uint8_t jumps[PIXELS]; /* pixels at which the filter itself jumps when depths change by their rounding */

static void make_picture(void)
{
    uint64_t seed = test_seed;
    int x, y, c;
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const int i = y * WIDTH + x;
            const double u = 2.0 * x / WIDTH - 1.0071, v = 2.0 * y / HEIGHT - 1.0137,
                         bump = 0.7 - u * u - v * v; /* off the middle: no ties */
            depth[i] = (float)(bump > 0 ? 50 - 10 * sqrt(bump)
                                        : 60 + u + 0.5 * v); /* which of four is the nearest is no matter of rounding */
            strength_of[i] = (float)(x % 9 == 0 && y % 5 == 0 ? 0 : 0.2 + 0.9 * test_uniform(&seed));
            for (c = 0; c < 4; ++c) light[4 * i + c] = (float)((x / 5 + y / 7) % 2 ? test_uniform(&seed) : 0.5);
            profile[i] = (uint8_t)(x + y < 60 ? 0 : x - y < 20 ? 1 : 2);
            if (x % 31 < 3 || y > 70) profile[i] = NOTHING;
            if ((x ^ y) % 23 == 7) profile[i] = (uint8_t)(x % 5);
            index_of[i] = (float)profile[i] / 255.0f;
            normal[4 * i] = (float)((bump > 0 ? 2 * u : 0.01) + 0.1 * test_uniform(&seed));
            normal[4 * i + 1] = (float)((bump > 0 ? 2 * v : -0.3) + 0.1 * test_uniform(&seed));
            normal[4 * i + 2] = (float)(bump > 0 ? bump : 1);
        }
    }
    depth[17 * WIDTH + 20] = -1;
    depth[18 * WIDTH + 30] = INFINITY;
    depth[19 * WIDTH + 31] = NAN;
    light[4 * (30 * WIDTH + 40)] = INFINITY;
    light[4 * (31 * WIDTH + 50) + 2] = NAN;
    for (c = 0; c < 3; ++c) normal[4 * (40 * WIDTH + 50) + c] = NAN;
    memset(normal + 4 * (41 * WIDTH + 50), 0, 3 * sizeof(float));
    for (c = 0; c < 4; ++c)
        memset(light + 4 * ((50 + c) * WIDTH + 40), 0, 80 * sizeof(float)); /* black, whose bits are few */
}

/* Terms of 1 (positive weights) to 3 (both signs) and a center term. */
static ms_sss_kernel make_kernel(int taps, int terms, double size)
{
    ms_sss_kernel k;
    int t, i, c;
    memset(&k, 0, sizeof k);
    k.tap_count = taps;
    k.term_count = terms;
    k.radius_mm = k.profile_radius_mm = (float)(4 * size);
    for (c = 0; c < 3; ++c) {
        k.reflectance[c] = 0.3f + 0.2f * (float)c;
        k.elevation_axis[c] = 1.9f - 0.5f * (float)c;
    }
    for (i = 1; i <= taps / 2; ++i) {
        double u = (double)i / (double)(taps / 2);
        k.offset_mm[i] = (float)(3.7 * size * u * u);
    }
    for (c = 0; c < 3; ++c) {
        double total = (double)(k.delta[c] = 0.1f);
        for (t = terms - 1; t >= 0; --t) {
            double sum = 0;
            for (i = 0; i <= taps / 2; ++i) {
                double u = (double)k.offset_mm[i] / (4 * size);
                k.weight[t][i][c] = (float)((t ? cos((2 * t + 0.1 * c) * u) : 1.6 * exp(-u * u * (2 + c))) / taps);
                sum += (i ? 2 : 1) * (double)k.weight[t][i][c];
            }
            k.scale[t][c] = (float)(t ? 0.2 * (t % 2 ? 1 : -1) : (1 - total) / (sum * sum));
            total += (double)k.scale[t][c] * sum * sum;
        }
    }
    return k;
}

/* --- one case: kernels, options, what the shader reads --- */

typedef struct one_case {
    ms_sss_kernel kernel[MS_SSS_SHADER_PROFILES_MAX];
    ms_sss_filter_options options;
    ms_sss_shader shader; /* pyramids: a pyramid in place of kernels */
    sss_text text;
    int terms;
} one_case;

/* An engine's own fetch functions: depth in alpha, whose last four bits are the index. */
static const char *const own_fetch =
    "uniform sampler2D ms_sss_color, ms_sss_strength, ms_sss_normal;\n"
    "vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(ms_sss_color, p, 0).rgb; }\n"
    "float ms_sss_fetch_depth(ivec2 p) { return texelFetch(ms_sss_color, p, 0).a; }\n"
    "int ms_sss_fetch_profile(ivec2 p) { return floatBitsToInt(texelFetch(ms_sss_color, p, 0).a) & 15; }\n"
    "float ms_sss_fetch_strength(ivec2 p) { return texelFetch(ms_sss_strength, p, 0).r; }\n"
    "vec3 ms_sss_fetch_normal(ivec2 p) { return texelFetch(ms_sss_normal, p, 0).rgb; }\n";

static int shaped(const one_case *t)
{
    return !t->text.without_depth && t->options.depth_mode == MS_SSS_DEPTH_AWARE && t->options.flat < 1;
}

/* Half resolution and rotated axes are the shader's alone. */
static int needs_plain(const one_case *t)
{
    return t->shader.half_resolution || t->shader.rotation > 0 || t->shader.jitter > 0;
}

/* Case i of those that run: the engine's fetch functions and ours, sizes of a pixel, depth modes, terms, both kinds of
 * kernel constants. */
static void make_case(one_case *t, int i, int language, int max_terms)
{
    const int taps = i % 2 ? 7 : 11;
    int k;
    memset(t, 0, sizeof *t);
    t->terms = 1 + i % max_terms;
    t->options = ms_sss_filter_defaults();
    t->text.language = language;
    t->shader.tap_count = taps;
    t->text.without_depth = i % 3 == 0;
    if (i % 3 == 2 && language <= SSS_GLSL_ES_300) t->text.fetch = own_fetch;
    t->text.strength = i / 2 % 2;
    t->shader.profile_count = i / 3 % 3 == 0 ? 0 : i % 5 == 4 ? 1 : PROFILES;
    for (k = 0; k < PROFILES; ++k) t->kernel[k] = make_kernel(k == 2 ? 5 : taps, k == 1 ? 1 : t->terms, 1 - 0.3 * k);
    if (!t->text.without_depth && i % 4 < 2) {
        t->options.fov_degrees = 30;
        t->options.center[0] = i % 8 < 2 ? 11.5f : 0.0f;
        t->options.center[1] = i % 8 < 2 ? -7.0f : 0.0f;
    } else if (i % 2) t->options.ortho_height = 40;
    else t->options.pixels_per_mm[0] = 1.7f;
    if (i % 6 == 1) t->options.pixels_per_mm[1] = t->options.pixels_per_mm[0] > 0 ? 2.1f : 0;
    t->options.depth_mode = i % 8 == 6 ? MS_SSS_DEPTH_SCALE : MS_SSS_DEPTH_AWARE;
    t->shader.fade = i % 4 == 1 ? 0.3f : 0.0f;
    if (i % 7 == 3) t->shader.rotation = 0.4f;
    if (i % 8 == 5) t->shader.jitter = 1;
    t->options.flat = i % 7 < 2 || t->text.without_depth ? 1 : i % 7 == 2 ? 0.4f : 0;
    t->text.normal = i % 5 == 2;
}

/* The same at half resolution: radii of 6 to 40 pixels, under and over those where every tap leaves the pixel. */
static void make_half_case(one_case *t, int i, int language, int max_terms)
{
    int k;
    make_picture();
    make_case(t, i, language, max_terms);
    t->shader.half_resolution = 1;
    t->shader.term_count = t->terms;
    for (k = 0; k < PROFILES; ++k)
        t->kernel[k] = make_kernel(k == 2 ? 5 : t->shader.tap_count, k == 1 ? 1 : t->terms,
                                   (1 - 0.3 * k) *
                                       (i % 4 == 2  ? 5
                                            : i % 4 ? 1.5
                                                    : 0.4));
}

/* The same with a pyramid: radii of 3 to 60 pixels. */
static void make_tower_case(one_case *t, int i, int language)
{
    static ms_sss_pyramid pyramid[PROFILES];
    static int made;
    int k;
    for (k = 0; k < PROFILES && !made; ++k) {
        const double reflectance[3] = {0.8 - 0.2 * k, 0.5, 0.2}, d[3] = {3.0 / (k * k + 1), 1.2, 0.5};
        ms_sss_profile *p;
        if (ms_sss_profile_from_burley(&p, reflectance, d, NULL, NULL) != MS_OK ||
            ms_sss_pyramid_make(&pyramid[k], p, NULL) != MS_OK)
            TEST_FAIL("no pyramid");
        ms_sss_profile_destroy(p);
    }
    made = 1;
    make_picture();
    make_case(t, i, language, 1);
    t->shader.tap_count = 0;
    t->shader.pyramids = pyramid;
    t->shader.rotation = t->shader.jitter = 0;
    t->options.pixels_per_mm[1] = 0;
    t->options.mm_per_unit = i % 11 == 5 ? 4.0f : 1.0f; /* smaller kernels */
}

static float with_bits(float value, unsigned low)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits = ((bits + 8) & ~15u) | low;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* --- the passes as plain loops in double, for what the CPU's filter has not: half resolution and rotated axes --- */

typedef struct plain_pixel {
    double light[3], depth; /* 0: masked */
    int profile;
} plain_pixel;

typedef struct plain_picture {
    int width, height, side; /* side: pixels of the full picture along one of these */
    plain_pixel *pixel;
} plain_picture;

/* What the constants say of the picture and of a profile, in the order in which ms_sss.glsl lists them. */
typedef struct plain_view {
    double width, height, pixels, gain, aspect[2], rotation, jitter, first, focal[2], slope_scale, center[2];
    const float (*of)[4]; /* of profile 0, then every `stride` */
    int stride, taps, terms, profiles, perspective, flat;
} plain_view;

static plain_view plain_view_of(const one_case *t, const float (*c)[4])
{
    plain_view v;
    memset(&v, 0, sizeof v);
    v.width = (double)c[0][0], v.height = (double)c[0][1];
    v.center[0] = (double)c[0][2], v.center[1] = (double)c[0][3];
    v.pixels = (double)c[1][2], v.aspect[0] = 1, v.aspect[1] = (double)c[1][3] / v.pixels;
    v.focal[0] = (double)c[1][2] * (double)c[2][0], v.focal[1] = (double)c[1][3] * (double)c[2][0];
    v.slope_scale = (double)c[2][2], v.gain = (double)c[2][3];
    v.rotation = (double)c[3][0], v.jitter = (double)c[3][1], v.first = (double)c[3][2];
    v.of = c + 4;
    v.taps = t->shader.tap_count;
    v.stride = 6 + v.taps / 2;
    v.profiles = t->shader.profile_count > 0 ? t->shader.profile_count : 1;
    v.terms = t->shader.term_count > 1 ? t->shader.term_count : 1;
    v.perspective = t->options.fov_degrees > 0;
    v.flat = !shaped(t);
    return v;
}

static plain_pixel plain_at(const plain_picture *p, int x, int y)
{
    static const plain_pixel none = {{0, 0, 0}, 0, 0};
    if (x < 0 || y < 0 || x >= p->width || y >= p->height) return none;
    return p->pixel[y * p->width + x];
}

static int plain_same(plain_pixel a, plain_pixel b) { return a.depth > 0 && a.profile == b.profile; }

/* The slope along (dx, dy): the mean of the differences on both sides where they agree, else the smaller one, made
   steeper by the ratio of the last two differences. */
static double plain_slope(const plain_view *v, const plain_picture *p, int x, int y, int dx, int dy, double focal,
                          double most)
{
    const plain_pixel own = plain_at(p, x, y), before = plain_at(p, x - dx, y - dy),
                      after = plain_at(p, x + dx, y + dy);
    double a = own.depth - before.depth, b = after.depth - own.depth, slope;
    const int on_a = plain_same(before, own) && fabs(a) < most, on_b = plain_same(after, own) && fabs(b) < most;
    a *= focal / (v->perspective ? before.depth : 1);
    b *= focal / (v->perspective ? after.depth : 1);
    if (!on_a && !on_b) return 0;
    if (!on_a) a = b;
    if (!on_b) b = a;
    slope = (a + b) / 2;
    if (!(on_a && on_b && fabs(a - b) < (a * b + 1) / 2)) {
        const int back = on_a && (!on_b || fabs(a) < fabs(b));
        const plain_pixel next = back ? before : after;
        const plain_pixel beyond = plain_at(p, x + (back ? -2 : 2) * dx, y + (back ? -2 : 2) * dy);
        double outer = own.depth - next.depth, inner = next.depth - beyond.depth, more;
        if (v->perspective) outer *= beyond.depth, inner *= own.depth;
        if (fabs(a) < fabs(b)) slope = a;
        if (fabs(b) < fabs(a)) slope = b;
        more = fmin(fabs(outer) - fabs(inner), fabs(inner)) -
            4.7683716e-7 * own.depth * (v->perspective ? own.depth : 1);
        if (plain_same(beyond, own) && outer * inner > 0 && more > 0) {
            more = fmin(more / fabs(inner), 0.85);
            slope += slope * more * (0.5 + more * (0.5 + 0.7 * more * more));
        }
    }
    return fmax(-8, fmin(8, slope));
}

/* Slopes of the surface along x and y, and the pixel's ray; returns the area over that of one that faces the ray. */
static double plain_tangent(const one_case *t, const plain_view *v, const plain_picture *in, int x, int y,
                            double slopes[2], double ray[2])
{
    const float(*of)[4] = v->of + v->stride * plain_at(in, x, y).profile;
    const double most = (double)of[0][3] * v->pixels / v->focal[0]; /* the radius, as depth */
    int c;
    for (c = 0; c < 2; ++c) ray[c] = v->perspective ? (((c ? y : x) + 0.5) * in->side - v->center[c]) / v->focal[0] : 0;
    if (t->text.normal && in->side == 1) {
        const float *n = normal + 4 * (y * in->width + x);
        const double facing = fmax((double)n[2] - ray[0] * (double)n[0] - ray[1] * (double)n[1],
                                   fmax(fabs((double)n[0]), fabs((double)n[1])) / 8);
        for (c = 0; c < 2; ++c) slopes[c] = facing > 0 ? (double)n[c] / facing : 0;
        for (c = 0; c < 3; ++c)
            if (!isfinite(n[c])) slopes[0] = slopes[1] = 0;
    } else {
        slopes[0] = plain_slope(v, in, x, y, 1, 0, v->focal[0] / in->side, most);
        slopes[1] = plain_slope(v, in, x, y, 0, 1, v->focal[1] / in->side, most);
    }
    for (c = 0; c < 2; ++c) slopes[c] *= v->slope_scale;
    return sqrt(slopes[0] * slopes[0] + slopes[1] * slopes[1] + pow(1 + slopes[0] * ray[0] + slopes[1] * ray[1], 2));
}

/* A step of 1 along the axis on the tangent plane, at depth 1, is (axis + slope ray, slope); of a plane that faces the
   camera, the axis. */
static double plain_shortened(const double axis[2], const double slopes[2], const double ray[2])
{
    const double slope = axis[0] * slopes[0] + axis[1] * slopes[1];
    return 1 / sqrt(pow(axis[0] + slope * ray[0], 2) + pow(axis[1] + slope * ray[1], 2) + slope * slope);
}

/* What a tap finds: light and weight, the weight times the sine of elevation, mm under the tangent plane; where it is. */
typedef struct plain_tap {
    double all[4], sine, lower, distance;
} plain_tap;

/* X or Y of one term. X writes out; Y adds its result to sum_of, where `before` is the
   light that the filter began with. */
static void plain_pass(const one_case *t, const plain_view *v, const plain_picture *in, const plain_picture *before,
                       int second, plain_picture *out, double (*sum_of)[3])
{
    int x, y, c, i, k;
    for (y = 0; y < in->height; ++y)
        for (x = 0; x < in->width; ++x) {
            const int at = y * in->width + x;
            const plain_pixel own = in->pixel[at];
            const float(*of)[4] = v->of + v->stride * own.profile;
            const double relative = v->perspective ? own.depth : 1, largest = fmax(v->aspect[0], v->aspect[1]);
            double pixels = v->pixels / relative / in->side, axis[2] = {!second, second}, slopes[2] = {0, 0};
            double ray[2] = {0, 0}, focal[2], area, mm, least = 1;
            double sum[3], weight[3], lifted[3], strength;
            plain_tap found[MS_SSS_TAPS_MAX];
            int mixed;
            if (second && !(own.depth > 0)) {
                for (c = 0; c < 3 && v->first > 0.5; ++c) sum_of[at][c] += before->pixel[at].light[c];
                continue;
            }
            if (!second) out->pixel[at] = own;
            if (!(own.depth > 0)) continue;
            strength = pixels * (double)of[0][3] * largest > 0.5
                ? in->side > 1 ? 1 : v->gain * fmin(2 * pixels * (double)of[0][3] * largest - 1, 1)
                : 0;
            if (second && in->side == 1 && t->text.strength) strength *= fmin((double)strength_of[at], 1);
            if (strength > 0 || !second) {
                const int wide = pixels * (double)of[0][3] * largest > 0.5;
                pixels = fmin(pixels, fmax(v->width, v->height) / ((double)of[0][3] * in->side));
                if (t->shader.rotation > 0 || t->shader.jitter > 0) {
                    const unsigned bits = ((unsigned)x * 49472u + (unsigned)y * 37345u) & 65535u;
                    const double turn = (double)(bits >> 10) + 0.5,
                                 angle = v->rotation + v->jitter * turn * 1.57079632679 / 64;
                    axis[0] = second ? -sin(angle) : cos(angle);
                    axis[1] = second ? cos(angle) : sin(angle);
                }
                for (c = 0; c < 2; ++c) focal[c] = v->focal[c] / in->side;
                mm = v->focal[0] / (v->pixels * (double)of[1][3]);
                area = 1;
                if (!v->flat) {
                    area = plain_tangent(t, v, in, x, y, slopes, ray);
                    pixels *= plain_shortened(axis, slopes, ray);
                    for (c = 0; c < 3; ++c) least = fmax(least, (double)of[3][c]);
                }
                for (c = 0; c < 2; ++c) axis[c] *= v->aspect[c] * pixels;
                for (c = 0; c < 3; ++c) {
                    lifted[c] = weight[c] = (double)of[5][c];
                    sum[c] = own.light[c] * (double)of[5][c];
                }
                mixed = (int)of[3][3];
                for (k = v->taps; wide && --k > 0;) { /* from the outside inwards */
                    plain_tap *to = &found[k];
                    const float *tap = of[5 + (k + 1) / 2];
                    const double offset = k % 2 ? (double)tap[3] : -(double)tap[3], s = fabs(offset);
                    const double px = floor(axis[0] * offset), py = floor(axis[1] * offset);
                    double all[4] = {0, 0, 0, 0}, below = 0, rounding;
                    for (i = 0; i < 4; ++i) {
                        const double sx = fabs(1 - i % 2 - (axis[0] * offset - px)),
                                     sy = fabs(1 - i / 2 - (axis[1] * offset - py));
                        const int qx = (int)px + i % 2, qy = (int)py + i / 2;
                        const plain_pixel there = plain_at(in, x + qx, y + qy);
                        double dz = there.depth - own.depth, f;
                        if (!v->flat)
                            dz -= (slopes[0] / focal[0] * qx + slopes[1] / focal[1] * qy) *
                                (v->perspective ? there.depth : 1);
                        dz *= (double)of[1][3];
                        if (!plain_same(there, own) || !(dz * dz < 1) || !(sx * sy > 0)) continue;
                        f = sx * sy * (1 - dz * dz);
                        f *= v->flat ? pow(1 - dz * dz, 3)
                                     : 1 / (fmin(v->slope_scale * mm * mm / fmax(s * s, 1e-30), 1e6) * dz * dz + 1);
                        below += f * dz;
                        for (c = 0; c < 3; ++c) all[c] += f * there.light[c];
                        all[3] += f;
                    }
                    if (!v->flat) {
                        const double outer = k + 2 < v->taps ? fabs((double)of[5 + (k + 3) / 2][3]) : 0;
                        rounding = own.depth * (double)of[1][3] * 2.3841858e-7 *
                            (2 + (fabs(axis[0]) + fabs(axis[1])) * s);
                        below = mm / area * (fabs(below) > rounding ? below - copysign(rounding, below) : 0);
                        to->distance = s;
                        to->lower = below / (all[3] + 0.001);
                        to->sine = below / fmax(s, 1e-20);
                        if (outer > s) /* near by that of the next tap outwards, as far as that was found */
                            to->sine += pow(to[2].all[3], 4) / (1 + pow(s / (0.17 * (double)of[0][3]), 4)) *
                                (to[2].sine * all[3] * s / outer - to->sine);
                    }
                    memcpy(to->all, all, sizeof all);
                }
                for (k = 1; wide && k < v->taps; ++k) {
                    const float *tap = of[5 + (k + 1) / 2];
                    const double lower = k > 2 ? found[k - 2].lower : 0, inner = k > 2 ? found[k - 2].distance : 0,
                                 sine = fmax(-1 / least, fmin(1, found[k].sine));
                    double all[4], bend = 0, factor;
                    memcpy(all, found[k].all, sizeof all);
                    if (!v->flat) {
                        if (found[k].distance - inner > 1e-20 && !mixed)
                            bend = (found[k].lower - lower) / (found[k].distance - inner);
                        for (c = 0; c < 4; ++c) all[c] *= fmin(0.5 * v->slope_scale * bend * bend + 1, 3);
                    }
                    for (c = 0; c < 3; ++c) {
                        factor = pow(1 + (double)of[3][c] * sine, 4);
                        weight[c] += (double)tap[c] * all[3];
                        lifted[c] += (double)tap[c] * all[3] * (v->flat ? 1 : factor);
                        sum[c] += (double)tap[c] * all[c] * (v->flat ? 1 : factor);
                    }
                }
                for (c = 0; c < 3; ++c) {
                    const double total = (double)of[0][c];
                    if (!v->flat) lifted[c] = fmax(weight[c], lifted[c] * (double)of[4][c]);
                    if (mixed >> c & 1) sum[c] += own.light[c] * (total - weight[c]);
                    else sum[c] = (lifted[c] > 1e-30 ? sum[c] / lifted[c] : own.light[c]) * total;
                }
            } else {
                memset(sum, 0, sizeof sum);
            }
            for (c = 0; c < 3; ++c) {
                if (!second) out->pixel[at].light[c] = sum[c];
                else
                    sum_of[at][c] += strength * (double)of[1][c] * sum[c] +
                        (strength * (double)of[2][c] + 1 - strength) *
                            (v->first > 0.5 ? before->pixel[at].light[c] : 0);
            }
        }
}

/* (1 - dz^2 / split^2)^4 */
static double plain_near(const plain_view *v, plain_pixel a, plain_pixel own)
{
    const float(*of)[4] = v->of + v->stride * own.profile;
    const double dz = (a.depth - own.depth) * (double)of[1][3];
    return plain_same(a, own) ? pow(fmax(1 - dz * dz / fmax((double)of[2][3], 1e-30), 0), 4) : 0;
}

/* What taps of a pixel take from itself at full resolution; tilt: what a mm along x and y is shortened to. */
static void plain_self(const plain_view *v, plain_pixel own, const double tilt[2], double out[3])
{
    const float(*of)[4] = v->of + v->stride * own.profile;
    const double pixels = fmin(v->pixels / (v->perspective ? own.depth : 1),
                               fmax(v->width, v->height) / (double)of[0][3]);
    int c, i, k, term;
    for (c = 0; c < 3; ++c) {
        out[c] = (double)of[2][c];
        for (term = 0; term < v->terms; ++term) {
            const float(*block)[4] = of + term * v->profiles * v->stride;
            double along[2] = {0, 0};
            for (k = 0; k < v->taps; ++k)
                for (i = 0; i < 2; ++i)
                    along[i] += (double)block[5 + (k + 1) / 2][c] *
                        fmax(1 - pixels * fabs((double)block[5 + (k + 1) / 2][3]) * v->aspect[i] * tilt[i], 0);
            out[c] += (double)block[1][c] * along[0] * along[1];
        }
        out[c] = fmax(0, fmin(0.999, out[c]));
    }
}

/* The picture of the case as doubles. */
static void plain_load(const one_case *t, const float *deep, plain_pixel *out)
{
    int i, c;
    memset(out, 0, PIXELS * sizeof *out);
    for (i = 0; i < PIXELS; ++i) {
        int valid = t->text.without_depth || (deep[i] > 0 && deep[i] < 1e30f);
        for (c = 0; c < 3; ++c) {
            out[i].light[c] = (double)light[4 * i + c];
            valid = valid && light[4 * i + c] < 1e30f && light[4 * i + c] > -1e30f;
        }
        if (t->text.strength && !(strength_of[i] > 0)) valid = 0;
        if (t->shader.profile_count > 0) {
            out[i].profile = profile[i];
            if (profile[i] >= t->shader.profile_count) valid = out[i].profile = 0;
        }
        if (valid) out[i].depth = t->text.without_depth ? 1 : (double)deep[i];
    }
}

/* The whole filter of a case: to [PIXELS][4]. */
static void plain_filter(one_case *t, const float *deep, float *to)
{
    static plain_pixel full[PIXELS], small[PIXELS], between[PIXELS];
    static double after[PIXELS][3];
    static float c_of[1000][4];
    const int half = t->shader.half_resolution, side = half ? 2 : 1;
    plain_picture in = {WIDTH, HEIGHT, 1, full}, work, middle;
    plain_view v;
    int i, c, x, y, term;
    plain_load(t, deep, full);
    work = in;
    work.side = side;
    work.width = (WIDTH + side - 1) / side;
    work.height = (HEIGHT + side - 1) / side;
    work.pixel = half ? small : full;
    middle = work;
    middle.pixel = between;
    memset(after, 0, sizeof after);
    t->shader.step = MS_SSS_STEP_UP; /* whose constants hold all terms */
    if (ms_sss_shader_constants(t->kernel, 0, &t->options, WIDTH, HEIGHT, &t->shader, c_of, NULL) != MS_OK)
        TEST_FAIL("constants");
    v = plain_view_of(t, (const float(*)[4])c_of);
    for (y = 0; half && y < work.height; ++y)
        for (x = 0; x < work.width; ++x) {
            plain_pixel own = plain_at(&in, 2 * x, 2 * y), mean;
            double all = 0;
            for (i = 1; i < 4; ++i) {
                const plain_pixel p = plain_at(&in, 2 * x + i % 2, 2 * y + i / 2);
                if (p.depth > 0 && (!(own.depth > 0) || p.depth < own.depth)) own = p;
            }
            mean = own;
            if (own.depth > 0) mean.depth = mean.light[0] = mean.light[1] = mean.light[2] = 0;
            for (i = 0; i < 4 && own.depth > 0; ++i) {
                const plain_pixel p = plain_at(&in, 2 * x + i % 2, 2 * y + i / 2);
                const double f = plain_near(&v, p, own);
                for (c = 0; c < 3; ++c) mean.light[c] += f > 0 ? f * p.light[c] : 0;
                mean.depth += f * p.depth;
                all += f;
            }
            for (c = 0; c < 3 && all > 0; ++c) mean.light[c] /= all;
            if (all > 0) mean.depth /= all;
            small[y * work.width + x] = mean;
        }
    for (term = 0; term < t->terms; ++term) {
        for (i = 0; i < 2; ++i) {
            t->shader.step = i ? MS_SSS_STEP_Y : MS_SSS_STEP_X;
            ms_sss_shader_constants(t->kernel, term, &t->options, WIDTH, HEIGHT, &t->shader, c_of, NULL);
            v = plain_view_of(t, (const float(*)[4])c_of);
            plain_pass(t, &v, i ? &middle : &work, &work, i, &middle, after);
        }
    }
    for (i = 0; i < PIXELS && !half; ++i)
        for (c = 0; c < 3; ++c) to[4 * i + c] = (float)after[i][c];
    if (!half) return;
    t->shader.step = MS_SSS_STEP_UP;
    ms_sss_shader_constants(t->kernel, 0, &t->options, WIDTH, HEIGHT, &t->shader, c_of, NULL);
    v = plain_view_of(t, (const float(*)[4])c_of);
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < WIDTH; ++x) {
            const plain_pixel own = full[y * WIDTH + x];
            const double radius = (double)v.of[v.stride * own.profile][3];
            double share[3], other[3], rest[3] = {0, 0, 0}, tilt[2] = {1, 1}, weight = 0, strength = v.gain;
            for (c = 0; c < 3; ++c) to[4 * (y * WIDTH + x) + c] = light[4 * (y * WIDTH + x) + c];
            if (!(own.depth > 0)) continue;
            for (i = 0; i < 2 && !v.flat; ++i) {
                const double axis[2] = {i == 0, i == 1};
                double slopes[2], ray[2];
                plain_tangent(t, &v, &in, x, y, slopes, ray);
                tilt[i] = plain_shortened(axis, slopes, ray);
            }
            plain_self(&v, own, tilt, share);
            for (i = 0; i < 4; ++i) {
                const int qx = (x + 1) / 2 - 1 + i % 2, qy = (y + 1) / 2 - 1 + i / 2;
                const plain_pixel there = plain_at(&work, qx, qy);
                const double f = plain_near(&v, there, own) * (qx == x / 2 ? 0.75 : 0.25) * (qy == y / 2 ? 0.75 : 0.25);
                if (!(f > 0)) continue;
                plain_self(&v, there, tilt, other);
                for (c = 0; c < 3; ++c) {
                    const double b = there.light[c], a = after[qy * work.width + qx][c];
                    rest[c] += f * fmax(b + (a - b) / (1 - other[c]), fmin(fmin(a, b), 0));
                }
                weight += f;
            }
            if (t->text.strength) strength *= fmin((double)strength_of[y * WIDTH + x], 1);
            if (!(v.pixels / (v.perspective ? own.depth : 1) * radius * fmax(v.aspect[0], v.aspect[1]) > 0.5)) continue;
            for (c = 0; c < 3 && weight > 1e-6; ++c)
                to[4 * (y * WIDTH + x) + c] = (float)(own.light[c] +
                                                      strength * (1 - share[c]) * (rest[c] / weight - own.light[c]));
        }
}

/* Halving rounds depths, where slopes are choices: of the smaller of two equal ones, of steepening where the next step
   is level. There the last bit of a depth decides, on one machine as on another: pixels that change when it does. */
static ms_status filter_on_cpu(const one_case *t, const ms_sss_frame *f, int count, ms_error *error);

static void find_jumps(one_case *t, const ms_sss_frame *frame, const float *given, int count)
{
    static float moved[PIXELS], other[PIXELS * 4];
    ms_sss_frame f = *frame;
    uint64_t seed = 1;
    int i, k, c, found = 0;
    f.output = ms_sss_interleaved(other, 4);
    f.depth = ms_sss_map(moved, 1);
    for (k = 0; k < 4; ++k) {
        for (i = 0; i < PIXELS; ++i)
            moved[i] = (float)((double)given[i] * (1 + 1.2e-7 * (2 * test_uniform(&seed) - 1)));
        if (needs_plain(t)) plain_filter(t, moved, other);
        else if (filter_on_cpu(t, &f, count, NULL) != MS_OK) TEST_FAIL("moved depths");
        for (i = 0; i < PIXELS; ++i)
            for (c = 0; c < 3; ++c)
                if (!jumps[i] && fabs((double)other[4 * i + c] - (double)output[4 * i + c]) > 3e-5) jumps[i] = 1;
    }
    for (i = 0; i < PIXELS; ++i) found += jumps[i];
    if (found > PIXELS / 200) TEST_FAIL("the filter jumps at %d pixels", found);
}

/* Taps or pyramid, and the fade, which is composition. */
static ms_status filter_on_cpu(const one_case *t, const ms_sss_frame *f, int count, ms_error *error)
{
    const ms_status status = t->shader.pyramids
        ? ms_sss_pyramid_filter(f, t->shader.pyramids, count, &t->options, NULL, 0, error)
        : ms_sss_filter(f, t->kernel, count, &t->options, NULL, 0, error);
    const float *in = f->input.channel[0];
    float *to = f->output.channel[0];
    int i, c;
    for (i = 0; i < PIXELS && t->shader.fade > 0; ++i)
        for (c = 0; c < 3; ++c)
            if (in[4 * i + c] - in[4 * i + c] == 0) to[4 * i + c] += t->shader.fade * (in[4 * i + c] - to[4 * i + c]);
    return status;
}

/* The right result in output, the input as the case packs it. Where the CPU's filter can do the case, the plain loops
   have to agree with it. */
static void make_reference(one_case *t)
{
    static float packed[PIXELS];
    const int count = t->shader.profile_count > 0 ? t->shader.profile_count : 1;
    ms_sss_frame f;
    ms_error error;
    int i;
    memcpy(input, light, sizeof input);
    for (i = 0; i < PIXELS; ++i) {
        packed[i] = profile[i] > 15 || !(depth[i] > 0) || depth[i] > 1e30f ? 0 : with_bits(depth[i], profile[i]);
        if (t->text.fetch) input[4 * i + 3] = packed[i];
    }
    memset(&f, 0, sizeof f);
    f.width = WIDTH;
    f.height = HEIGHT;
    f.input = ms_sss_interleaved(light, 4);
    f.output = ms_sss_interleaved(output, 4);
    if (!t->text.without_depth) f.depth = ms_sss_map(t->text.fetch ? packed : depth, 1);
    if (t->text.strength) f.strength = ms_sss_map(strength_of, 1);
    if (t->shader.profile_count > 0) f.profile = profile;
    if (t->text.normal && shaped(t)) f.normal = ms_sss_interleaved(normal, 4);
    if (needs_plain(t)) plain_filter(t, t->text.fetch ? packed : depth, output);
    else if (filter_on_cpu(t, &f, count, &error) != MS_OK) TEST_FAIL("%s", error.message);
    memset(jumps, 0, sizeof jumps);
    if ((t->shader.half_resolution || t->shader.pyramids) && shaped(t))
        find_jumps(t, &f, t->text.fetch ? packed : depth, count);
}

/* Largest difference between output and what was drawn. */
static double difference(void)
{
    double worst = 0;
    int i, c;
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 3; ++c) {
            double e = fabs((double)drawn[4 * i + c] - (double)output[4 * i + c]);
            if (!isfinite(light[4 * i + c]) || jumps[i]) continue; /* NaN and infinity come back as they may */
            if (!(e <= worst)) worst = e == e ? e : 1e9;
        }
    }
    return worst;
}

/* The same sums in another order, exp2 and division of the rasteriser: about 1e-6 of values up to 1; the depth factor
   squares differences of depths near 50 whose rounding is 4e-6. */
#define GPU_TOLERANCE 1e-5
/* Slopes: differences of depths near 50 over steps of 0.36 mm, so rounding of 1e-5, and what lies
   below the plane over distances of as little. Sines and cosines of turned axes: Mesa's are within 1e-6 to 1e-5, which
   moves taps 10 pixels away by as much as 1e-4 pixels. */
#define WIDER_TOLERANCE 1e-4
static double tolerance_of(const one_case *t)
{
    if (t->shader.half_resolution && !t->text.without_depth)
        return WIDER_TOLERANCE; /* divided by 1 - share of the one, times that of the other */
    return shaped(t) || t->shader.jitter > 0 || t->shader.rotation > 0 || t->shader.profile_count > 0 ? WIDER_TOLERANCE
                                                                                                      : GPU_TOLERANCE;
}

/* --- OpenGL against the CPU --- */

static float constants[1000][4];
enum { NAMES = 12, LEVELS = 7 }; /* 97 x 75 to 2 x 2 */
static const char *const texture_name[NAMES] = {
    "ms_sss_color",  "ms_sss_depth",   "ms_sss_strength", "ms_sss_input",          "ms_sss_profile", "ms_sss_sum",
    "ms_sss_normal", "ms_sss_surface", "ms_sss_coarse",   "ms_sss_coarse_surface", "ms_sss_weight",  "ms_sss_half"};
enum { SURFACE = 7, COARSE, COARSE_SURFACE, WEIGHT, BEFORE_HALF }; /* of the names */
enum {
    COLOR,
    DEPTH,
    STRENGTH,
    INPUT,
    PROFILE,
    SUM,
    NORMAL,
    MIDDLE,
    RESULT,
    SMALL,
    SMALL_MIDDLE,
    SMALL_RESULT,
    TOWER,
    TEXTURES = TOWER + 4 * LEVELS
}; /* TOWER: light, surface, sums, weights of each level */
static const char *image_name(int which)
{
    static const char *const name[TOWER] = {"input",  "depth",  "strength", "input", "profile",      "sum",
                                            "normal", "middle", "result",   "small", "small_middle", "small_result"};
    static char level[2][40];
    static int turn;
    if (which < TOWER) return name[which];
    turn = !turn;
    snprintf(level[turn], sizeof level[turn], "level%d", which - (int)TOWER);
    return level[turn];
}

/* What a case draws, in order: of half resolution or not, with all terms. Returns how many. */
enum { STEPS = 60 };
typedef struct one_step {
    ms_sss_step step;
    int term; /* of a pyramid: index of the profile */
    int level;
} one_step;

static int plan_steps(const one_case *t, one_step step[STEPS])
{
    const int half = t->shader.half_resolution;
    int n = 0, term, i;
    memset(step, 0, STEPS * sizeof *step);
    for (term = 0; t->shader.pyramids && term < (t->shader.profile_count > 0 ? t->shader.profile_count : 1); ++term) {
        for (i = 0; i < 2 * LEVELS - 1; ++i, ++n) {
            step[n].term = term;
            step[n].step = i == 0    ? MS_SSS_STEP_BASE
                : i < LEVELS         ? MS_SSS_STEP_SHRINK
                : i < 2 * LEVELS - 2 ? MS_SSS_STEP_GATHER
                                     : MS_SSS_STEP_RESOLVE;
            step[n].level = i == 0 ? 0 : i < LEVELS ? i - 1 : 2 * LEVELS - 2 - i;
        }
    }
    if (n) return n;
    if (half) step[n++].step = MS_SSS_STEP_DOWN;
    for (term = 0; term < t->terms; ++term) {
        for (i = 0; i < 2; ++i) {
            step[n].step = i ? MS_SSS_STEP_Y : MS_SSS_STEP_X;
            step[n++].term = term;
        }
    }
    step[n].step = MS_SSS_STEP_UP;
    step[n].term = t->terms - 1;
    return half ? n + 1 : n;
}

/* The image that a step reads by a name, and the one that it writes. */
static int read_by(const one_case *t, one_step s, int name)
{
    const int half = t->shader.half_resolution, x = s.step == MS_SSS_STEP_X, y = s.step == MS_SSS_STEP_Y;
    const int level = TOWER + 4 * s.level, next = s.level + 1 < LEVELS ? level + 4 : level;
    if (s.step >= MS_SSS_STEP_BASE) {
        switch (name) {
        case INPUT: return level;
        case SURFACE: return level + 1;
        case COARSE: return next;
        case COARSE_SURFACE: return next + 1;
        case SUM: return next + 2;
        case WEIGHT: return next + 3;
        case COLOR: /* of RESOLVE: what it wrote before */
            return s.step == MS_SSS_STEP_BASE || s.term == 0 ? COLOR : s.term % 2 ? RESULT : SUM;
        default: return name;
        }
    }
    if (name == INPUT) return y ? half ? SMALL_MIDDLE : MIDDLE : x && half ? SMALL : INPUT;
    if (name == BEFORE_HALF) return SMALL;
    if (name == SUM && half) return SMALL_RESULT;
    return name;
}

static int written_by(const one_case *t, one_step s)
{
    const int half = t->shader.half_resolution;
    switch (s.step) {
    case MS_SSS_STEP_X: return half ? SMALL_MIDDLE : MIDDLE;
    case MS_SSS_STEP_Y: return half ? SMALL_RESULT : RESULT;
    case MS_SSS_STEP_DOWN: return SMALL;
    case MS_SSS_STEP_BASE: return TOWER;
    case MS_SSS_STEP_SHRINK: return TOWER + 4 * s.level + 4;
    case MS_SSS_STEP_GATHER: return TOWER + 4 * s.level + 2;
    case MS_SSS_STEP_RESOLVE: return s.term % 2 ? SUM : RESULT;
    default: return RESULT;
    }
}

static int targets_of(one_step s) /* the other is the next image */
{
    return s.step >= MS_SSS_STEP_BASE && s.step < MS_SSS_STEP_RESOLVE ? 2 : 1;
}

static int halved(int side, int which)
{
    int i;
    for (i = which >= TOWER ? (which - (int)TOWER) / 4 : which >= SMALL; i > 0; --i) side = (side + 1) / 2;
    return side;
}

static int width_of(int which) { return halved(WIDTH, which); }
static int height_of(int which) { return halved(HEIGHT, which); }

/* The shader and its constants become those of a step. */
static void set_step(one_case *t, one_step s)
{
    ms_error error;
    t->shader.step = s.step;
    t->shader.level = s.level;
    if (ms_sss_shader_constants(t->kernel, s.term, &t->options, WIDTH, HEIGHT, &t->shader, constants, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
}

static void bind_reads(const one_case *t, one_step step, GLuint program)
{
    int i;
    for (i = 0; i < NAMES; ++i)
        if (texture_name[i][0]) gpu_read(program, t->text.language, texture_name[i], read_by(t, step, i));
}

/* The text of the case's step, into text. */
static void make_text(const one_case *t)
{
    sss_text about = t->text;
    about.flat = !shaped(t);
    about.rotated = t->shader.rotation > 0 || t->shader.jitter > 0;
    if (!sss_shader_text(&t->shader, &about, text, sizeof text)) TEST_FAIL("no text of step %d", (int)t->shader.step);
}

static GLuint gl_step(const one_case *t, one_step step)
{
    const ms_sss_shader *shader = &t->shader;
    GLuint program;
    make_text(t);
    program = gpu_program(t->text.language, 0, "ms_sss", &constants[0][0], ms_sss_shader_constant_count(shader));
    bind_reads(t, step, program);
    return program;
}

static GLuint plain_program(const char *shader)
{
    strcpy(text, shader);
    return gpu_program(GPU_GLSL_330, 0, "ms_sss", &constants[0][0], (int)(sizeof constants / sizeof constants[0]));
}

/* Draws a case, whose input make_reference made. */
static void gl_draw(one_case *t)
{
    const ms_sss_shader *s = &t->shader;
    one_step step[STEPS];
    GLuint texture[TEXTURES] = {0};
    int i, n = plan_steps(t, step);
    texture[COLOR] = gl_texture(COLOR, GL_RGBA32F, WIDTH, HEIGHT, input);
    texture[DEPTH] = gl_texture(DEPTH, GL_R32F, WIDTH, HEIGHT, depth);
    texture[STRENGTH] = gl_texture(STRENGTH, GL_R32F, WIDTH, HEIGHT, strength_of);
    texture[INPUT] = gl_texture(INPUT, GL_RGBA32F, WIDTH, HEIGHT, input);
    texture[PROFILE] = gl_texture(PROFILE, GL_R32F, WIDTH, HEIGHT, index_of);
    texture[NORMAL] = gl_texture(NORMAL, GL_RGBA32F, WIDTH, HEIGHT, normal);
    for (i = 0; i < TEXTURES; ++i)
        if (i == SUM || (i >= MIDDLE && i < TOWER) || (i >= TOWER && t->shader.pyramids))
            texture[i] = gl_texture(i, GL_RGBA32F, width_of(i), height_of(i), NULL);
    for (i = 0; i < n; ++i) {
        const int to = written_by(t, step[i]);
        GLuint program;
        set_step(t, step[i]);
        program = gl_step(t, step[i]);
        gpu_draw(texture[to], targets_of(step[i]) > 1 ? texture[to + 1] : 0, width_of(to), height_of(to),
                 s->step == MS_SSS_STEP_Y && step[i].term > 0);
        gl_DeleteProgram(program);
    }
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[written_by(t, step[n - 1])],
                            0);
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
    gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, drawn);
    gl_DeleteTextures(TEXTURES, texture);
}

/* Largest difference between the two in one case. */
static double gl_compare(one_case *t)
{
    make_reference(t);
    gl_draw(t);
    return difference();
}

enum { FULL, HALF, PYRAMID };

static void compare_all(gl_api which, int language, int method, int count)
{
    double worst = 0, worst_wider = 0;
    int i;
    if (!gl_open(which))
        SKIP("no %s context without a window",
             which == GL_API_ES_30    ? "OpenGL ES 3.0"
                 : which == GL_API_33 ? "OpenGL 3.3"
                                      : "OpenGL 4.3");
    if (language >= SSS_VULKAN && !gpu_can_translate()) SKIP("no glslangValidator or spirv-cross on this machine");
    make_picture();
    for (i = 0; i < count; ++i) {
        one_case t;
        double e, *w;
        if (method == PYRAMID) make_tower_case(&t, i, language);
        else (method == HALF ? make_half_case : make_case)(&t, i, language, which == GL_API_ES_30 ? 1 : 3);
        e = gl_compare(&t);
        w = tolerance_of(&t) > GPU_TOLERANCE ? &worst_wider : &worst;
        if (!(e <= tolerance_of(&t)))
            TEST_FAIL("case %d (depth %d, profile %d, depth mode %d, flat %g, normal %d, turned %d): %g", i,
                      !t.text.without_depth, t.shader.profile_count, (int)t.options.depth_mode, (double)t.options.flat,
                      t.text.normal, t.shader.rotation > 0 || t.shader.jitter > 0, e);
        if (e > *w) *w = e;
    }
    TEST_NOTE("%s: largest difference %.1e, with slopes, turned axes or two numbers in one %.1e",
              (const char *)gl_GetString(GL_RENDERER), worst, worst_wider);
}

/* What is squared of light must neither overflow nor vanish: light of 2^66 and 2^-40 times gives as much more or less. */
static void case_scales(void)
{
    static const double scale[2] = {7.378697629483821e19, 9.094947017729282e-13};
    static float usual[4 * PIXELS];
    double worst[2] = {0, 0};
    int k, i, j;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    make_picture();
    for (i = 0; i < 12; ++i) {
        one_case t;
        if (i % 3 == 0) make_case(&t, i, SSS_GLSL_330, 3);
        if (i % 3 == 1) make_half_case(&t, i, SSS_GLSL_330, 3);
        if (i % 3 == 2) make_tower_case(&t, i, SSS_GLSL_330);
        make_reference(&t);
        gl_draw(&t);
        memcpy(usual, drawn, sizeof usual);
        for (k = 0; k < 2; ++k) {
            const double from = k ? scale[0] : 1;
            for (j = 0; j < 4 * PIXELS; ++j)
                if (j % 4 < 3) input[j] = (float)((double)input[j] / from * scale[k]);
            gl_draw(&t);
            for (j = 0; j < 4 * PIXELS; ++j) {
                const double e = fabs((double)drawn[j] / scale[k] - (double)usual[j]);
                if (j % 4 < 3 && isfinite(light[j])) worst[k] = e <= worst[k] ? worst[k] : e == e ? e : HUGE_VAL;
            }
            if (!(worst[k] < 1e-5)) TEST_FAIL("light times %g, case %d: %g", scale[k], i, worst[k]);
        }
    }
    TEST_NOTE("largest difference, in this unit, %.1e and %.1e", worst[0], worst[1]);
}

static void case_desktop(void) { compare_all(GL_API_33, SSS_GLSL_330, FULL, test_full ? 360 : 36); }
static void case_es(void) { compare_all(GL_API_ES_30, SSS_GLSL_ES_300, FULL, test_full ? 360 : 12); }
static void case_vulkan_runs(void) { compare_all(GL_API_33, SSS_VULKAN, FULL, test_full ? 72 : 8); }
static void case_hlsl_runs(void) { compare_all(GL_API_33, SSS_HLSL, FULL, test_full ? 72 : 8); }
static void case_half_resolution(void) { compare_all(GL_API_33, SSS_GLSL_330, HALF, test_full ? 360 : 36); }
static void case_half_es(void)
{
    TEST_LONG;
    compare_all(GL_API_ES_30, SSS_GLSL_ES_300, HALF, 120);
}
static void case_half_vulkan(void)
{
    TEST_LONG;
    compare_all(GL_API_33, SSS_VULKAN, HALF, 72);
}
static void case_half_hlsl(void)
{
    TEST_LONG;
    compare_all(GL_API_33, SSS_HLSL, HALF, 72);
}
static void case_tower(void) { compare_all(GL_API_33, SSS_GLSL_330, PYRAMID, test_full ? 360 : 24); }
static void case_tower_es(void)
{
    TEST_LONG;
    compare_all(GL_API_ES_30, SSS_GLSL_ES_300, PYRAMID, 120);
}
static void case_tower_vulkan(void)
{
    TEST_LONG;
    compare_all(GL_API_33, SSS_VULKAN, PYRAMID, 24);
}
static void case_tower_hlsl(void)
{
    TEST_LONG;
    compare_all(GL_API_33, SSS_HLSL, PYRAMID, 24);
}

/* A viewport with an origin in larger textures, and a projection whose center is not the picture's: as the CPU's filter
   on the picture alone. */
static void case_viewport(void)
{
    enum { LEFT = 13, BELOW = 9, WIDE = WIDTH + LEFT + 4, HIGH = HEIGHT + BELOW + 2 };
    static float color[WIDE * HIGH * 4], deep[WIDE * HIGH];
    static const GLenum to[1] = {GL_COLOR_ATTACHMENT0};
    GLuint texture[4];
    one_case t;
    int i, x, y;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    make_picture();
    make_case(&t, 1, SSS_GLSL_330, 1);
    t.options = ms_sss_filter_defaults();
    t.options.fov_degrees = 30;
    t.options.center[0] = -20;
    t.options.center[1] = 15;
    t.shader.fade = 0;
    t.shader.profile_count = t.text.strength = t.text.normal = 0;
    t.shader.origin[0] = LEFT;
    t.shader.origin[1] = BELOW;
    make_reference(&t);
    for (i = 0; i < WIDE * HIGH; ++i) { /* around it: what must not be read */
        color[4 * i] = color[4 * i + 1] = color[4 * i + 2] = 9;
        deep[i] = 50;
    }
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < WIDTH; ++x) {
            memcpy(color + 4 * ((y + BELOW) * WIDE + x + LEFT), input + 4 * (y * WIDTH + x), 4 * sizeof(float));
            deep[(y + BELOW) * WIDE + x + LEFT] = depth[y * WIDTH + x];
        }
    texture[0] = gl_texture(COLOR, GL_RGBA32F, WIDE, HIGH, color);
    texture[1] = gl_texture(DEPTH, GL_R32F, WIDE, HIGH, deep);
    texture[2] = gl_texture(MIDDLE, GL_RGBA32F, WIDE, HIGH, NULL);
    texture[3] = gl_texture(RESULT, GL_RGBA32F, WIDE, HIGH, NULL);
    for (i = 0; i < 2; ++i) {
        const one_step step = {i ? MS_SSS_STEP_Y : MS_SSS_STEP_X, 0, 0};
        set_step(&t, step);
        gl_step(&t, step);
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[2 + i], 0);
        gl_DrawBuffers(1, to);
        gl_Viewport(LEFT, BELOW, WIDTH, HEIGHT);
        gl_DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_ReadPixels(LEFT, BELOW, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, drawn);
    CHECK_LE(difference(), WIDER_TOLERANCE);
    TEST_NOTE("largest difference %.1e", difference());
    t.options.center[0] = t.options.center[1] = 0; /* and the center is not without effect */
    make_reference(&t);
    CHECK(difference() > 10 * WIDER_TOLERANCE);
    gl_DeleteTextures(4, texture);
}

/* What the light loop's function returns for column x and row y of a picture, as a fragment shader. */
static const char *transmission_shader(int language)
{
    static char all[sizeof text + 1000];
    const char *const vec3 = language == SSS_HLSL ? "float3" : language == SSS_WGSL ? "vec3<f32>" : "vec3";
    const int glsl = language < SSS_HLSL;
    ms_sss_shader s = ms_sss_shader_defaults();
    sss_text about;
    memset(&about, 0, sizeof about);
    about.language = language;
    about.fetch = glsl ? "layout(location = 0) out vec4 color;\n" : "";
    s.step = (ms_sss_step)SSS_TRANSMISSION;
    CHECK(sss_shader_text(&s, &about, text, sizeof text));
    snprintf(
        all, sizeof all,
        "%s%s%s(ms_sss_transmission(%s(0.02, 0.6, 1.0), %s(3.0, 0.8, 0.05), 0.07 * x, %s(0.6, 0.0, -0.8), "
        "%s(-0.8 * (y - 20.0) / 20.0, 0.6, 0.8 * (y - 20.0) / 20.0), %s(0.0, 0.6, 0.8), %s(1.0, 2.0, 3.0)), 1.0); }\n",
        text,
        glsl ? "void main() { float x = gl_FragCoord.x - 0.5; float y = gl_FragCoord.y - 0.5; color = "
            : language == SSS_HLSL
            ? "float4 main(float4 p : SV_Position) : SV_Target { float x = p.x - 0.5; float y = p.y - 0.5; return "
            : "@fragment fn main(@builtin(position) p: vec4<f32>) -> @location(0) vec4<f32> { let x = p.x - 0.5; let y = p.y - 0.5; return ",
        language == SSS_WGSL       ? "vec4<f32>"
            : language == SSS_HLSL ? "float4"
                                   : "vec4",
        vec3, vec3, vec3, vec3, vec3, vec3);
    return all;
}

/* As many kernels as a pass takes, in patches that a tap crosses several of, one of them without a kernel. */
static void case_sixteen(void)
{
    static one_case t;
    int i, k;
    if (!gl_open(GL_API_ES_30)) SKIP("no OpenGL ES 3.0 context without a window");
    for (i = 0; i < 4; ++i) {
        double e;
        make_picture();
        make_case(&t, i, SSS_GLSL_ES_300, 1);
        t.shader.profile_count = MS_SSS_SHADER_PROFILES_MAX;
        for (k = 0; k < MS_SSS_SHADER_PROFILES_MAX; ++k)
            t.kernel[k] = make_kernel(t.shader.tap_count - (k % 3 ? 2 : 0), 1, 1.5 - 0.08 * k);
        for (k = 0; k < PIXELS; ++k) {
            profile[k] = (uint8_t)((k % WIDTH / 7 + 3 * (k / WIDTH / 6)) % 17);
            index_of[k] = (float)profile[k] / 255;
        }
        CHECK(ms_sss_shader_constant_count(&t.shader) <= 224);
        e = gl_compare(&t);
        if (!(e <= tolerance_of(&t))) TEST_FAIL("case %d: %g", i, e);
    }
}

/* The i-th combination of everything that changes a text, into text; few of them, but with --full. */
enum { VARIANTS = 27 * 8192 };

static int variant(int i, int language)
{
    sss_text about;
    ms_sss_shader s = ms_sss_shader_defaults();
    const int bits = i / 27;
    if (i % (test_full ? 97 : 5273)) return 0; /* primes: every choice meets every other */
    memset(&about, 0, sizeof about);
    about.language = language;
    about.without_depth = i % 3 == 0;
    if (i % 3 == 2 && language <= SSS_GLSL_ES_300) about.fetch = own_fetch;
    s.step = i / 9 % 3 == 1 ? MS_SSS_STEP_Y : MS_SSS_STEP_X;
    about.strength = bits & 1;
    about.rotated = bits >> 2 & 1;
    s.profile_count = i / 3 % 3 > 0 ? 1 + (bits >> 3 & 1) * 15 : 0;
    about.flat = (bits >> 4 & 1) | about.without_depth;
    about.normal = bits >> 5 & 1;
    s.tap_count = bits >> 6 & 1 ? 7 : 25;
    if (bits >> 7 & 1) {
        s.half_resolution = 1;
        s.term_count = 1 + (bits & 2);
        if (i / 9 % 3 == 2) s.step = bits >> 8 & 1 ? MS_SSS_STEP_UP : MS_SSS_STEP_DOWN;
    } else if (bits >> 9 & 1) {
        s.step = (ms_sss_step)((int)MS_SSS_STEP_BASE + i / 9 % 3 + (bits >> 8 & 1));
        about.rotated = 0;
    } else if (bits >> 10 & 1) {
        s.step = (ms_sss_step)SSS_DISC;
    }
    if (!sss_shader_text(&s, &about, text, sizeof text)) TEST_FAIL("variant %d has no text", i);
    return 1;
}

/* --- OpenGL ES and WGSL in a browser --- */

static void put_case(FILE *f, one_case *t)
{
    one_step step[STEPS];
    /* The browser's SwiftShader is off by as much as 1.9e-4 in sines and cosines (Vulkan allows 4.9e-4): of turned
     * axes, taps 10 pixels away move by 2e-3 pixels, over which light changes by up to 2e-4. With a power series in
     * their place: 5e-5. */
    const double tolerance = t->shader.jitter > 0 || t->shader.rotation > 0 ? 2e-4 : tolerance_of(t);
    int i, k, n = plan_steps(t, step);
    make_reference(t);
    for (i = 0; i < 4 * PIXELS; ++i)
        if (jumps[i / 4] || i % 4 == 3 || !isfinite(input[i])) output[i] = NAN;
    fprintf(f, "{api: '%s', tolerance: %g, expected: ", t->text.language == SSS_WGSL ? "webgpu" : "webgl", tolerance);
    gpu_put_floats(f, output, PIXELS * 4);
    fputs(", images: {", f);
    gpu_put_image(f, "input", WIDTH, HEIGHT, 4, input);
    gpu_put_image(f, "profile", WIDTH, HEIGHT, 1, index_of);
    fputs("}, steps: [", f);
    for (i = 0; i < n; ++i) {
        const ms_sss_shader *s = &t->shader;
        const int to = written_by(t, step[i]);
        set_step(t, step[i]);
        make_text(t);
        gpu_put_step(f, "ms_sss", &constants[0][0], ms_sss_shader_constant_count(s), width_of(to), height_of(to));
        fprintf(f, "write: ['%s'", image_name(to));
        if (targets_of(step[i]) > 1) fprintf(f, ", '%s'", image_name(to + 1));
        fputs("], read: {", f);
        for (k = 0; k < NAMES; ++k)
            if (texture_name[k][0]) fprintf(f, "%s: '%s', ", texture_name[k], image_name(read_by(t, step[i], k)));
        fputs("}},\n", f);
    }
    fputs("]},\n", f);
}

static void browser(int language, const char *path)
{
    const int cases = test_full ? 72 : 12, step = test_full ? 1 : 7;
    FILE *f;
    int i;
    if (!gpu_has_browser()) SKIP("no chromium on this machine");
    if ((f = gpu_page(path)) == NULL) SKIP("cannot write %s", path);
    make_picture();
    fputs("images: {", f);
    gpu_put_image(f, "depth", WIDTH, HEIGHT, 1, depth);
    gpu_put_image(f, "strength", WIDTH, HEIGHT, 1, strength_of);
    gpu_put_image(f, "normal", WIDTH, HEIGHT, 4, normal);
    fputs("}, cases: [\n", f);
    for (i = 0; i < cases; ++i) { /* one term: not every browser blends floats */
        one_case t;
        make_case(&t, i * step, language, 1);
        put_case(f, &t);
    }
    for (i = 0; i < cases / 2; ++i) {
        one_case t;
        make_half_case(&t, i * step, language, 1);
        put_case(f, &t);
        if (i % 2) continue;
        make_tower_case(&t, i * step, language);
        put_case(f, &t);
    }
    fputs("], compile: [", f);
    strcpy(text, transmission_shader(language));
    gpu_put_text(f);
    for (i = 0; i < VARIANTS; ++i)
        if (variant(i, language)) gpu_put_text(f);
    fputs("]", f);
    gpu_run(f, path);
}

static void case_webgl(void) { browser(SSS_GLSL_ES_300, "build/sss_webgl.html"); }
static void case_wgsl(void) { browser(SSS_WGSL, "build/sss_wgsl.html"); }

/* Nothing crosses between materials: each is lit in one color of its own, which must come back unchanged. */
static void case_bleeding(void)
{
    one_case t;
    int i, c;
    double worst = 0;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    make_picture();
    make_case(&t, 4, SSS_GLSL_330, 1);
    t.text.without_depth = 1;
    t.text.fetch = NULL;
    t.shader.profile_count = PROFILES;
    t.options = ms_sss_filter_defaults();
    t.options.flat = 1;
    t.options.pixels_per_mm[0] = 4;
    for (i = 0; i < PIXELS; ++i)
        for (c = 0; c < 3; ++c) light[4 * i + c] = profile[i] == c ? 1 : profile[i] >= PROFILES ? 9 : 0;
    gl_compare(&t);
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 3; ++c) {
            const double e = fabs((double)drawn[4 * i + c] - (double)light[4 * i + c]);
            if (!(e <= worst)) worst = e;
        }
    }
    CHECK_NEAR(worst, 0, 1e-6); /* as the filter promises for what is constant */
}

/* What constants cannot be made for is refused by the name of the field, and nothing is written. */
static void refuses(const ms_sss_shader *s, const ms_sss_filter_options *o, const ms_sss_kernel *k, int term,
                    ms_status status, const char *name)
{
    float out[1][4] = {{7, 7, 7, 7}};
    ms_error error;
    memset(&error, 0, sizeof error);
    CHECK_INT(ms_sss_shader_constants(k, term, o, 64, 48, s, out, &error), status);
    CHECK_INT(error.status, status);
    if (!strstr(error.message, name)) TEST_FAIL("'%s' does not name %s", error.message, name);
    CHECK((double)out[0][0] == 7);
}

static void case_refused(void)
{
    ms_sss_kernel k = make_kernel(7, 1, 1);
    ms_sss_filter_options o = ms_sss_filter_defaults(), p;
    ms_sss_shader good = ms_sss_shader_defaults(), s;
    static ms_sss_pyramid pyramid;
    o.pixels_per_mm[0] = 4;
    refuses(NULL, &o, &k, 0, MS_INVALID_ARGUMENT, "NULL");
    CHECK_INT(ms_sss_shader_constant_count(NULL), 0);
    s = good, s.tap_count = 8;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "tap_count 8");
    CHECK_INT(ms_sss_shader_constant_count(&s), 0);
    s = good, s.profile_count = 17;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "profile_count 17");
    s = good, s.step = (ms_sss_step)8;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "step 8");
    s = good, s.step = MS_SSS_STEP_RESOLVE, s.jitter = 1;
    refuses(&s, &o, NULL, 0, MS_UNSUPPORTED, "jitter");
    s = good, s.step = MS_SSS_STEP_RESOLVE, p = o, p.pixels_per_mm[1] = 3;
    refuses(&s, &p, NULL, 0, MS_UNSUPPORTED, "round");
    s = good, s.jitter = 2;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "jitter 2");
    s = good, s.rotation = NAN;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "rotation");
    s = good, s.step = MS_SSS_STEP_GATHER;
    refuses(&s, &o, NULL, 0, MS_INVALID_ARGUMENT, "pyramids is NULL");
    s.pyramids = &pyramid;
    refuses(&s, &o, NULL, 1, MS_INVALID_ARGUMENT, "profile 1");
    s.level = 6;
    refuses(&s, &o, NULL, 0, MS_INVALID_ARGUMENT, "level 6");
    s = good, s.term_count = MS_SSS_TERMS_MAX + 1;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "term_count");
    s = good, s.origin[1] = -1;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "origin[1] -1");
    s = good, s.nearest = 2; /* 4 mm of the kernel, 48 pixels of height 30 degrees wide, at depth 2 */
    p = o, p.pixels_per_mm[0] = 0, p.fov_degrees = 30;
    refuses(&s, &p, &k, 0, MS_UNSUPPORTED, "pixels with 7 taps show bands");
    p = o, p.center[0] = NAN;
    refuses(&good, &p, &k, 0, MS_INVALID_ARGUMENT, "center[0]");
    s = good, s.fade = 2;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "fade 2");
    refuses(&good, &o, NULL, 0, MS_INVALID_ARGUMENT, "kernels is NULL");
    refuses(&good, NULL, &k, 0, MS_INVALID_ARGUMENT, "options is NULL");
    s = good, s.tap_count = 5;
    refuses(&s, &o, &k, 0, MS_INVALID_ARGUMENT, "7 taps");
    refuses(&good, &o, &k, 1, MS_INVALID_ARGUMENT, "term 1");
    k.offset_mm[1] *= -1;
    refuses(&good, &o, &k, 0, MS_INVALID_ARGUMENT, "offset_mm[1]");
    k.tap_count = 4;
    refuses(&good, &o, &k, 0, MS_INVALID_ARGUMENT, "tap_count 4");
}

/* Texels that one pixel reads at most, and usually: the texts, told to count and to return that. */
static int count_reads(one_case *t, ms_sss_step which, int *usual)
{
    static char counted[100000];
    const one_step step = {which, 0, which == MS_SSS_STEP_GATHER};
    char *to = counted;
    const char *from;
    int most = 0, often[100], i, width, height;
    t->shader.step = which;
    width = width_of(written_by(t, step));
    height = height_of(written_by(t, step));
    for (i = MIDDLE; i < TOWER + 12; ++i) { /* what other steps make: of a plane */
        plain_program(i > TOWER && (i - TOWER) % 4 == 1
                          ? "#version 330\nout vec4 c; void main() { c = vec4(1.0, 0.0, 0.0, 0.0); }\n"
                          : "#version 330\nout vec4 c; void main() { c = vec4(0.5, 0.5, 0.5, 50.0); }\n");
        gpu_draw(gl_texture(i, GL_RGBA32F, WIDTH, HEIGHT, NULL), 0, WIDTH, HEIGHT, 0);
    }
    gl_texture(COLOR, GL_RGBA32F, WIDTH, HEIGHT, input);
    gl_texture(INPUT, GL_RGBA32F, WIDTH, HEIGHT, input);
    gl_texture(DEPTH, GL_R32F, WIDTH, HEIGHT, depth);
    gl_texture(NORMAL, GL_RGBA32F, WIDTH, HEIGHT, normal);
    make_text(t);
    for (from = text; *from; ++from) {
        if (strncmp(from, "#define MS_SSS_STEP", 19) == 0 && to - counted < 20)
            to += sprintf(to, "float reads = 0.0;\n");
        if (strncmp(from, "return texelFetch", 17) == 0) to += sprintf(to, "reads += 1.0; ");
        if (strncmp(from, "ms_sss_out = filter_pixel(ivec2(gl_FragCoord.xy));", 50) == 0) { /* with one target or two */
            to += sprintf(to, "filter_pixel(ivec2(gl_FragCoord.xy)); ms_sss_out = vec4(reads);");
            from += 49;
            continue;
        }
        *to++ = *from;
    }
    *to = 0;
    bind_reads(t, step, plain_program(counted));
    gpu_draw(gl_texture(RESULT, GL_RGBA32F, width, height, NULL), 0, width, height, 0);
    gl_ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, drawn);
    memset(often, 0, sizeof often);
    for (i = 0; i < width * height; ++i) {
        const int reads = (int)drawn[4 * i];
        if (reads > most) most = reads;
        if (reads > 3 && reads < 100) ++often[reads]; /* with fewer a pixel takes no part */
    }
    for (i = *usual = 0; i < 100; ++i)
        if (often[i] > often[*usual]) *usual = i;
    return most;
}

static void case_reads(void)
{
    static const struct {
        float flat, delta;
        int depth, normal, usual, most;
    } kinds[5] = {{1, 0, 1, 0, 39, 39},
                  {0, 0, 1, 0, 51, 57},
                  {0, 0, 1, 1, 41, 41},
                  {1, 0, 0, 0, 26, 26},
                  {1, 0.1f, 1, 0, 40, 40}};
    int i, c, k, both, usual[2];
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    make_picture();
    for (i = 0; i < 5; ++i) {
        one_case t;
        memset(&t, 0, sizeof t);
        t.kernel[0] = make_kernel(7, 1, 1);
        for (c = 0; c < 3; ++c) t.kernel[0].delta[c] = kinds[i].delta;
        t.options = ms_sss_filter_defaults();
        t.options.ortho_height = 40;
        t.options.flat = kinds[i].flat;
        t.shader.tap_count = 7;
        t.text.without_depth = !kinds[i].depth;
        t.text.normal = kinds[i].normal;
        make_reference(&t);
        if (ms_sss_shader_constants(t.kernel, 0, &t.options, WIDTH, HEIGHT, &t.shader, constants, NULL) != MS_OK)
            TEST_FAIL("constants");
        both = count_reads(&t, MS_SSS_STEP_X, &usual[0]);
        both += count_reads(&t, MS_SSS_STEP_Y, &usual[1]);
        if (usual[0] + usual[1] != kinds[i].usual || both < kinds[i].usual || both > kinds[i].most)
            TEST_FAIL("kind %d: usually %d, at most %d texels read, the header says %d, %d", i, usual[0] + usual[1],
                      both, kinds[i].usual, kinds[i].most);
        if (!kinds[i].depth) { /* rotated axes: two texels of each tap, four for two */
            t.shader.rotation = 0.4f;
            if (ms_sss_shader_constants(t.kernel, 0, &t.options, WIDTH, HEIGHT, &t.shader, constants, NULL) != MS_OK)
                TEST_FAIL("constants");
            count_reads(&t, MS_SSS_STEP_X, &usual[0]);
            count_reads(&t, MS_SSS_STEP_Y, &usual[1]);
            CHECK_INT(usual[0] + usual[1], 2 * kinds[i].usual - 2); /* the center is one */
            continue;
        }
        /* DOWN reads 4 of color and of depth for every 4 pixels, UP 11 for each, and for slopes those of 4 pixels, of 6
           at edges, or a normal */
        t.shader.half_resolution = 1;
        CHECK_INT(count_reads(&t, MS_SSS_STEP_DOWN, &usual[0]), 8);
        CHECK_INT(count_reads(&t, MS_SSS_STEP_UP, &usual[0]), kinds[i].flat > 0 ? 11 : kinds[i].normal ? 12 : 23);
        count_reads(&t, MS_SSS_STEP_X, &usual[0]);
        count_reads(&t, MS_SSS_STEP_Y, &usual[1]);
        CHECK_INT(usual[0] + usual[1], kinds[i].flat < 1 ? 34 : kinds[i].delta > 0 ? 27 : 26); /* slopes from depth */
        if (i != 1) continue;
        for (k = 0; k < 4; ++k) {
            static ms_sss_pyramid pyramid;
            static const int reads[4] = {10, 44, 40, 35};
            pyramid.radius_mm = 10;
            t.shader.half_resolution = 0;
            t.shader.step = (ms_sss_step)((int)MS_SSS_STEP_BASE + k);
            t.shader.level = k == 2;
            t.shader.pyramids = &pyramid;
            if (ms_sss_shader_constants(NULL, 0, &t.options, WIDTH, HEIGHT, &t.shader, constants, NULL) != MS_OK)
                TEST_FAIL("constants");
            count_reads(&t, t.shader.step, &usual[0]);
            CHECK_INT(usual[0], reads[k]);
        }
    }
}

/* The constants lie where the structs say, and change at a resize as the table says. */
static void case_constants(void)
{
    static float wanted[200][4];
    static ms_sss_pyramid pyramids[3], *const pyramid = pyramids + 2;
    const double reflectance[3] = {0.5, 0.4, 0.3}, d_mm[3] = {1, 0.5, 0.2};
    ms_sss_profile *profile;
    one_case t;
    ms_error error;
    int i;
    CHECK_INT(ms_sss_shader_levels(97, 75), LEVELS);
    CHECK_INT(ms_sss_shader_levels(1, 2), 1);
    CHECK_INT(ms_sss_shader_levels(65536, 65536), MS_SSS_PYRAMID_LEVELS);
    make_case(&t, 4, SSS_GLSL_330, 1);
    t.shader.profile_count = PROFILES;
    t.text.without_depth = 0;
    t.options = ms_sss_filter_defaults();
    t.options.fov_degrees = 40;
    t.options.mm_per_unit = 10;
    if (ms_sss_shader_constants(t.kernel, 0, &t.options, 640, 360, &t.shader, constants, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    /* a resize changes size, center, and pixels and focal in proportion to the height */
    memcpy(wanted, constants, sizeof wanted);
    CHECK_NEAR((double)wanted[1][2], 360 / (2 * tan(20 * 3.14159265358979 / 180) * 10), 1e-4);
    wanted[0][0] = 1280;
    wanted[0][1] = 720;
    wanted[0][2] = 640;
    wanted[0][3] = 360;
    wanted[1][2] *= 2;
    wanted[1][3] *= 2;
    if (ms_sss_shader_constants(t.kernel, 0, &t.options, 1280, 720, &t.shader, constants, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    for (i = 0; i < 4 * ms_sss_shader_constant_count(&t.shader); ++i)
        CHECK_NEAR((double)(&wanted[0][0])[i], (double)(&constants[0][0])[i],
                   1e-6 * fabs((double)(&constants[0][0])[i]));
    CHECK_NEAR((double)constants[4][3], (double)t.kernel[0].radius_mm, 0);
    /* those of a pyramid lie where ms_sss_pyramid.glsl says */
    if (ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, &error) != MS_OK ||
        ms_sss_pyramid_make(pyramid, profile, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    ms_sss_profile_destroy(profile);
    t.shader.step = MS_SSS_STEP_SHRINK;
    t.shader.half_resolution = 0;
    t.shader.fade = 0.25f;
    t.shader.pyramids = pyramids;
    for (i = 0; i < 3; ++i) {
        t.shader.level = i;
        if (ms_sss_shader_constants(NULL, 2, &t.options, 640, 360, &t.shader, constants, &error) != MS_OK)
            TEST_FAIL("%s", error.message);
        CHECK(constants[0][0] == 640 && constants[0][1] == 360 && constants[2][2] == 1 && constants[2][3] == 0.75f);
        CHECK_NEAR(1 / ((double)constants[1][2] * (double)constants[2][0]), tan(20 * 3.14159265358979 / 180) / 180,
                   1e-9); /* of a pixel's ray */
        CHECK(constants[3][0] == (float)(2 << i) && constants[3][1] == 2);
        CHECK_NEAR((double)constants[4][0], ms_sss_elevation(0.5, 1) / 4, 1e-6);
        CHECK_NEAR((double)constants[5][0], 2, 1e-6);
    }
}

static void case_transmission(void)
{
    GLuint texture;
    ms_sss_kernel k;
    double worst = 0, most = 0;
    int x, y, c;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    plain_program(transmission_shader(SSS_GLSL_330));
    texture = gl_texture(0, GL_RGBA32F, WIDTH, HEIGHT, NULL);
    gpu_draw(texture, 0, WIDTH, HEIGHT, 0);
    gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, drawn);
    memset(&k, 0, sizeof k);
    for (c = 0; c < 3; ++c) {
        k.reflectance[c] = c == 0 ? 0.02f : c == 1 ? 0.6f : 1.0f;
        k.decay[c] = c == 0 ? 3.0f : c == 1 ? 0.8f : 0.05f;
    }
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const float tilt = 0.8f * ((float)y - 20) / 20, to_light[3] = {0, 0.6f, 0.8f}, light_of[3] = {1, 2, 3};
            const float n[3] = {0.6f, 0, -0.8f}, entry[3] = {-tilt, 0.6f, tilt};
            float out[3];
            ms_sss_transmission(&k, 0.07f * (float)x, n, entry, to_light, light_of, out);
            for (c = 0; c < 3; ++c) {
                const double e = fabs((double)out[c] - (double)drawn[4 * (y * WIDTH + x) + c]) /
                    fmax(1, fabs((double)out[c]));
                if (!(e <= worst)) worst = e;
                if ((double)out[c] > most) most = (double)out[c];
            }
        }
    }
    CHECK(most > 1);
    CHECK_NEAR(worst, 0, 2e-5); /* exp of the rasteriser to 1e-6, times 1 / (1 - R) where the slab hardly absorbs */
    TEST_NOTE("largest difference %.1e", worst);
}

/* Depth of 16 bits: its steps are seen as elevation, with slopes from depth or from normals; flat 1 does not see them.
 */
static void case_half_depth(void)
{
    static float exact[PIXELS], coarse[PIXELS];
    double rough[2][3]; /* [16 bits][kind]: RMS of the Laplacian of what constant light becomes on a ball */
    int bits, kind, i, x, y;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    for (i = 0; i < PIXELS; ++i) {
        const double u = 2.2 * (i % WIDTH) / WIDTH - 1.1, v = 2.2 * (i / WIDTH) / HEIGHT - 1.1;
        exact[i] = (float)(60 - 10 * sqrt(2.5 - u * u - v * v > 0 ? 2.5 - u * u - v * v : 0));
        coarse[i] = test_half_value(test_half_of(exact[i]));
        normal[4 * i] = (float)u, normal[4 * i + 1] = (float)v;
        normal[4 * i + 2] = (float)sqrt(fmax(2.5 - u * u - v * v, 0));
        input[4 * i] = input[4 * i + 1] = input[4 * i + 2] = 1;
    }
    for (bits = 0; bits < 2; ++bits)
        for (kind = 0; kind < 3; ++kind) {
            one_case t;
            GLuint texture[4];
            double sum = 0;
            memset(&t, 0, sizeof t);
            t.kernel[0] = make_kernel(7, 1, 1);
            t.options = ms_sss_filter_defaults();
            t.options.ortho_height = 40;
            t.options.flat = kind == 2;
            t.shader.tap_count = 7;
            t.text.normal = kind == 1;
            t.terms = 1;
            texture[0] = gl_texture(COLOR, GL_RGBA32F, WIDTH, HEIGHT, input);
            texture[1] = gl_texture(DEPTH, GL_R32F, WIDTH, HEIGHT, bits ? coarse : exact);
            texture[2] = gl_texture(NORMAL, GL_RGBA32F, WIDTH, HEIGHT, normal);
            texture[3] = gl_texture(MIDDLE, GL_RGBA32F, WIDTH, HEIGHT, NULL);
            for (i = 0; i < 2; ++i) {
                const one_step step = {i ? MS_SSS_STEP_Y : MS_SSS_STEP_X, 0, 0};
                const GLuint to = i ? gl_texture(RESULT, GL_RGBA32F, WIDTH, HEIGHT, NULL) : texture[3];
                set_step(&t, step);
                gl_step(&t, step);
                gpu_draw(to, 0, WIDTH, HEIGHT, 0);
            }
            gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, drawn);
            gl_DeleteTextures(4, texture);
            for (y = HEIGHT / 4; y < 3 * HEIGHT / 4; ++y)
                for (x = WIDTH / 4; x < 3 * WIDTH / 4; ++x) {
                    const float *p = drawn + 4 * (y * WIDTH + x);
                    const double lap = 4 * (double)p[0] - (double)p[-4] - (double)p[4] - (double)p[-4 * WIDTH] -
                        (double)p[4 * WIDTH];
                    sum += lap * lap;
                }
            rough[bits][kind] = sqrt(4 * sum / PIXELS);
        }
    CHECK_LE(20 * rough[0][0], rough[1][0]); /* steps of depth of 0.03 mm over pixels of 0.5 mm */
    CHECK_LE(20 * rough[0][1], rough[1][1]);
    CHECK_LE(rough[1][2], 1e-6); /* a constant stays one */
    TEST_NOTE("32 bits %.1e, normals %.1e, flat %.1e; 16 bits %.1e, %.1e, %.1e", rough[0][0], rough[0][1], rough[0][2],
              rough[1][0], rough[1][1], rough[1][2]);
}

/* --- streaks beside a lit strip --- */

enum { STRIP_W = 256, STRIP_H = 80 };

/* sRGB of a film curve, in levels. */
static double strip_level(double light_of)
{
    const double x = 0.5 * light_of, tone = fmin(1, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
    return 255 * (tone < 0.0031308 ? 12.92 * tone : 1.055 * pow(tone, 1 / 2.4) - 0.055);
}

/* The largest root mean square of the second difference in levels, beside strips of light of 1 and 2 pixels on a plane,
   3 pixels from them to where their light ends: by the pyramid, or by the shader with or without half resolution. */
static double strip_ripple(const ms_sss_pyramid *pyramid, const ms_sss_kernel *k, int half, float radius, double tilt)
{
    static float deep[STRIP_W * STRIP_H], lit[4 * STRIP_W * STRIP_H], seen[4 * STRIP_W * STRIP_H];
    const float radius_mm = pyramid ? pyramid->radius_mm : k->radius_mm, size = radius / radius_mm;
    const float *row = seen + 4 * (STRIP_H / 2) * STRIP_W;
    const int reach = (int)((double)radius * cos(tilt));
    double worst = 0;
    int width, from, x, i, c;
    for (width = 1; width <= 2; ++width)
        for (from = STRIP_W / 2; from <= STRIP_W / 2 + 1; ++from) { /* of a larger pixel the first or the second */
            ms_sss_filter_options o = ms_sss_filter_defaults();
            double sum = 0;
            int n = 0;
            o.pixels_per_mm[0] = size;
            for (i = 0; i < STRIP_W * STRIP_H; ++i) {
                x = i % STRIP_W;
                deep[i] = 200 + (float)(tan(tilt) * (x - from)) / size;
                for (c = 0; c < 4; ++c) lit[4 * i + c] = x >= from && x < from + width ? 1.5f : 0.05f;
            }
            if (pyramid) {
                ms_sss_frame f;
                memset(&f, 0, sizeof f);
                f.width = STRIP_W;
                f.height = STRIP_H;
                f.input = ms_sss_interleaved(lit, 4);
                f.output = ms_sss_interleaved(seen, 4);
                f.depth = ms_sss_map(deep, 1);
                CHECK_INT(ms_sss_pyramid_filter(&f, pyramid, 1, &o, NULL, 0, NULL), MS_OK);
            } else if (!sss_passes(lit, deep, STRIP_W, STRIP_H, k, &o, half, seen)) TEST_FAIL("the passes do not run");
            for (x = from - reach; x <= from + width - 1 + reach; ++x) {
                const double bend = strip_level((double)row[4 * x - 4]) - 2 * strip_level((double)row[4 * x]) +
                    strip_level((double)row[4 * x + 4]);
                if (x > from - 3 && x < from + width + 2) continue;
                sum += bend * bend;
                ++n;
            }
            worst = fmax(worst, sqrt(sum / n));
        }
    return worst;
}

/* Taps show a strip again that is narrower than the gaps between them. At half resolution gaps are half as wide, and the
   strip is a smaller part of a pixel: what is left is near the pyramid's, which has no gaps. */
static void case_streaks(void)
{
    static const double reflectance[3] = {0.44, 0.44, 0.44}, d_mm[3] = {0.91, 0.91, 0.91};
    static const struct {
        int radius, taps;
    } kind[3] = {{16, 11}, {27, 17}, {38, 17}};
    static ms_sss_pyramid pyramid;
    ms_sss_profile *p = NULL;
    int i, t;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    CHECK_INT(ms_sss_profile_from_burley(&p, reflectance, d_mm, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_pyramid_make(&pyramid, p, NULL), MS_OK);
    for (i = 0; i < 3; ++i) {
        ms_sss_kernel_options build = ms_sss_kernel_defaults();
        ms_sss_kernel k;
        double ripple[3][6]; /* full and half resolution, pyramid */
        build.tap_count = kind[i].taps;
        CHECK_INT(ms_sss_kernel_make(&k, NULL, p, kind[i].radius, &build, NULL, NULL), MS_OK);
        for (t = 0; t < 6; ++t) {
            const double tilt = t * 3.14159265358979323846 / 12;
            ripple[0][t] = strip_ripple(NULL, &k, 0, (float)kind[i].radius, tilt);
            ripple[1][t] = strip_ripple(NULL, &k, 1, (float)kind[i].radius, tilt);
            ripple[2][t] = strip_ripple(&pyramid, NULL, 0, (float)kind[i].radius, tilt);
            if (t < 4) CHECK_LE(ripple[1][t], 0.5 * ripple[0][t]);
            CHECK_LE(0.5 * ripple[2][t], ripple[1][t]); /* the strip's light is there */
            CHECK_LE(ripple[1][t], 2.1 * ripple[2][t]); /* 1.98 at most */
        }
        TEST_NOTE(
            "%d pixels, %d taps, facing, at 45 and 75 degrees: %.2f %.2f %.2f, half %.2f %.2f %.2f, pyramid %.2f %.2f %.2f",
            kind[i].radius, kind[i].taps, ripple[0][0], ripple[0][3], ripple[0][5], ripple[1][0], ripple[1][3],
            ripple[1][5], ripple[2][0], ripple[2][3], ripple[2][5]);
    }
    ms_sss_profile_destroy(p);
}

/* --- the disc and half resolution against random walks: the demo's pictures of a bust of skin and a knot of marble --- */

enum { WALK_PIXELS = 320 * 180 };
static float walk_depth[WALK_PIXELS], walk_light[4 * WALK_PIXELS], walk_shown[3 * WALK_PIXELS];

/* A picture that truth_data.c wrote: depth, then light before the albedo and what the walk shows as binary16. */
static ms_sss_profile *read_walk(const char *picture, const char *profile, ms_sss_filter_options *options)
{
    static unsigned char half[12 * WALK_PIXELS];
    ms_sss_profile *p = NULL;
    size_t size;
    char line[100] = "", *text_of = test_read_file(profile, &size);
    int width = 0, height = 0, i, c;
    FILE *f = fopen(picture, "rb");
    if (!f || !fgets(line, sizeof line, f) ||
        sscanf(line, "ms_truth %d %d %f %f", &width, &height, &options->fov_degrees, &options->mm_per_unit) != 4 ||
        width * height != WALK_PIXELS || fread(walk_depth, 4, WALK_PIXELS, f) != WALK_PIXELS ||
        fread(half, 12, WALK_PIXELS, f) != WALK_PIXELS || !text_of || profile_from_csv(&p, text_of, size, NULL))
        TEST_FAIL("%s or %s cannot be read", picture, profile);
    if (f) fclose(f);
    free(text_of);
    for (i = 0; i < WALK_PIXELS; ++i)
        for (c = 0; c < 3; ++c) {
            const unsigned char *b = half + 12 * i + 2 * c;
            walk_light[4 * i + c] = (float)test_half_value((uint16_t)(b[0] | b[1] << 8));
            walk_shown[3 * i + c] = (float)test_half_value((uint16_t)(b[6] | b[7] << 8));
        }
    return p;
}

/* Error in % of the walk's RMS, of the object's pixels, of pixels[..][stride] times the reflectance. */
static double walk_error(const float *pixels, int stride, const double reflectance[3])
{
    double difference_2 = 0, walk_2 = 0;
    int i, c;
    for (i = 0; i < WALK_PIXELS; ++i)
        for (c = 0; c < 3 && walk_depth[i] > 0; ++c) {
            const double walk = (double)walk_shown[3 * i + c],
                         e = reflectance[c] * (double)pixels[stride * i + c] - walk;
            difference_2 += e * e;
            walk_2 += walk * walk;
        }
    return 100 * sqrt(difference_2 / walk_2);
}

/* Errors unfiltered, and of the mean of 1 to 8 frames of the disc, whose rings turn; then of 7 taps in two passes, and
   of these at half resolution. */
enum { WALK_FULL = 9, WALK_HALF, WALK_ERRORS };
static void walk_errors(const char *picture, const char *profile_path, double out[WALK_ERRORS])
{
    static float sum[3 * WALK_PIXELS], mean[3 * WALK_PIXELS], seen[4 * WALK_PIXELS];
    static ms_sss_kernel rings, kernel;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_profile *p = read_walk(picture, profile_path, &o);
    ms_sss_shader s = ms_sss_shader_defaults();
    sss_text about;
    ms_error error;
    double reflectance[3];
    GLuint texture[3];
    int frame, i, c;
    if (!p) return;
    ms_sss_profile_reflectance(p, reflectance);
    if (disc_kernel(&rings, p, 20, 40, &error) != MS_OK ||
        ms_sss_kernel_make(&kernel, NULL, p, 40, NULL, NULL, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    ms_sss_profile_destroy(p);
    memset(&about, 0, sizeof about);
    about.rotated = 1;
    texture[0] = gl_texture(COLOR, GL_RGBA32F, 320, 180, walk_light);
    texture[1] = gl_texture(DEPTH, GL_R32F, 320, 180, walk_depth);
    texture[2] = gl_texture(RESULT, GL_RGBA32F, 320, 180, NULL);
    memset(sum, 0, sizeof sum);
    out[0] = walk_error(walk_light, 4, reflectance);
    for (frame = 1; frame <= 8; ++frame) {
        GLuint program;
        s.tap_count = rings.tap_count;
        s.step = MS_SSS_STEP_X;
        s.rotation = 1.2f * (float)frame;
        s.jitter = 1;
        if (ms_sss_shader_constants(&rings, 0, &o, 320, 180, &s, constants, &error) != MS_OK)
            TEST_FAIL("%s", error.message);
        i = ms_sss_shader_constant_count(&s);
        s.step = (ms_sss_step)SSS_DISC;
        if (!sss_shader_text(&s, &about, text, sizeof text)) TEST_FAIL("no text of the disc");
        program = gpu_program(SSS_GLSL_330, 0, "ms_sss", constants[0], i);
        gpu_read(program, SSS_GLSL_330, "ms_sss_color", COLOR);
        gpu_read(program, SSS_GLSL_330, "ms_sss_depth", DEPTH);
        gpu_draw(texture[2], 0, 320, 180, 0);
        gl_ReadPixels(0, 0, 320, 180, GL_RGBA, GL_FLOAT, seen);
        gl_DeleteProgram(program);
        for (i = 0; i < WALK_PIXELS; ++i)
            for (c = 0; c < 3; ++c) {
                sum[3 * i + c] += seen[4 * i + c];
                mean[3 * i + c] = sum[3 * i + c] / (float)frame;
            }
        out[frame] = walk_error(mean, 3, reflectance);
    }
    gl_DeleteTextures(3, texture);
    for (i = 0; i < 2; ++i) {
        if (!sss_passes(walk_light, walk_depth, 320, 180, &kernel, &o, i, seen)) TEST_FAIL("the passes do not run");
        out[WALK_FULL + i] = walk_error(seen, 4, reflectance);
    }
}

static void case_walks(void)
{
    static const char *const name[2][2] = {{"examples/data/truth_bust.bin", "examples/data/truth_skin1.csv"},
                                           {"examples/data/truth_knot.bin", "examples/data/truth_marble.csv"}};
    double e[2][WALK_ERRORS];
    int i;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    for (i = 0; i < 2; ++i) {
        walk_errors(name[i][0], name[i][1], e[i]);
        CHECK_LE(e[i][1], 0.65 * e[i][0]); /* 7 taps in two passes: 0.55 and 0.61 of the unfiltered picture's error */
        CHECK_LE(e[i][4], 0.97 * e[i][1]); /* the samples' noise leaves with frames */
        CHECK_LE(e[i][WALK_HALF], 1.05 * e[i][WALK_FULL]); /* RESULTS says 1.02 over 45 other pictures */
        TEST_NOTE("%s: unfiltered %.2f, 1 frame %.2f, 4: %.2f, 8: %.2f; 7 taps %.2f, at half resolution %.2f",
                  name[i][0], e[i][0], e[i][1], e[i][4], e[i][8], e[i][WALK_FULL], e[i][WALK_HALF]);
    }
}

/* The engine's sample runs: without scattering on the left, with it on the right. The cloth beside the glowing knot is
   the same on both; light passes through the knot's far side. */
static void case_engine(void)
{
    enum { SIDE = 480, CLOTH_ROW = 130, CLOTH = 865, GLOW_ROW = 330, GLOW = 880 };
    const char *problem;
    image im;
    int x, c, same = 1;
    if (!gl_open(GL_API_33)) SKIP("no OpenGL 3.3 context without a window");
    if (system(
            "make -s build/ms_sss.glsl.inc && ${CC:-cc} -std=c99 -O1 -D_POSIX_C_SOURCE=200809L -I. -Ibuild examples/engine/engine.c -o build/engine -lEGL -lm && build/engine build/engine.png") !=
        0)
        TEST_FAIL("examples/engine/engine.c does not build or run");
    problem = image_read("build/engine.png", &im);
    if (problem) TEST_FAIL("build/engine.png: %s", problem);
    if (problem) return;
    CHECK_INT(im.width, 2 * SIDE);
    CHECK_INT(im.height, 540);
    for (x = CLOTH; x < 2 * SIDE; ++x)
        for (c = 0; c < 3; ++c)
            same &= im.pixels[3 * (CLOTH_ROW * 2 * SIDE + x) + c] ==
                im.pixels[3 * (CLOTH_ROW * 2 * SIDE + x - SIDE) + c];
    CHECK(same);
    for (c = 0; c < 2; ++c) { /* red and green; the picture is jade */
        const float *with = im.pixels + 3 * (GLOW_ROW * 2 * SIDE + GLOW), *without = with - 3 * SIDE;
        CHECK((double)with[1] > (double)without[1] + 0.1);
        CHECK((double)with[1] > (double)with[c ? 2 : 0] + 0.1);
    }
    image_free(&im);
}

/* --- every text is valid --- */

static void validate_one(const char *shader, const char *flags, const char *path, int number)
{
    char command[300];
    FILE *f = fopen(path, "w");
    if (!f) TEST_FAIL("cannot write %s", path);
    if (!f) return;
    fputs(shader, f);
    fclose(f);
    snprintf(command, sizeof command, "glslangValidator %s %s >" GPU_LOG " 2>&1", flags, path);
    if (system(command) != 0) {
        char *log = test_read_file(GPU_LOG, NULL);
        TEST_FAIL("text %d: %.600s", number, log ? log : "no log");
        free(log);
    } else if (strstr(flags, "-V -S frag -o") && system("spirv-cross --version >" GPU_LOG " 2>&1") != 127 << 8) {
        if (system("spirv-cross --msl --output build/sss.metal build/sss.spv >" GPU_LOG " 2>&1") != 0)
            TEST_FAIL("text %d is not translated to Metal", number);
    }
}

static void validate(int language, const char *flags, const char *path)
{
    int i, count = 0;
    if (system("glslangValidator --version >" GPU_LOG " 2>&1") != 0) SKIP("no glslangValidator on this machine");
    for (i = 0; i < VARIANTS; ++i) {
        if (!variant(i, language)) continue;
        validate_one(text, flags, path, i);
        ++count;
    }
    validate_one(transmission_shader(language), flags, path, -1);
    TEST_NOTE("%d texts", count + 1);
}

static void case_glsl(void) { validate(SSS_GLSL_330, "", "build/sss_330.frag"); }
static void case_glsl_es(void) { validate(SSS_GLSL_ES_300, "", "build/sss_300.frag"); }
static void case_hlsl(void) { validate(SSS_HLSL, "-D -V -S frag -e main -o build/sss.spv", "build/sss_hlsl.frag"); }
static void case_vulkan(void) { validate(SSS_VULKAN, "-V -S frag -o build/sss.spv", "build/sss_vulkan.frag"); }

static const test_case cases[] = {
    {"OpenGL 3.3 against the CPU", case_desktop},
    {"OpenGL ES 3.0 against the CPU", case_es},
    {"sixteen materials in one pass", case_sixteen},
    {"very bright and very dark light", case_scales},
    {"half resolution against the CPU", case_half_resolution},
    {"half resolution, OpenGL ES 3.0", case_half_es},
    {"half resolution, Vulkan GLSL", case_half_vulkan},
    {"half resolution, HLSL", case_half_hlsl},
    {"pyramid against the CPU", case_tower},
    {"pyramid, OpenGL ES 3.0", case_tower_es},
    {"pyramid, Vulkan GLSL", case_tower_vulkan},
    {"pyramid, HLSL", case_tower_hlsl},
    {"Vulkan GLSL against the CPU", case_vulkan_runs},
    {"HLSL against the CPU", case_hlsl_runs},
    {"WebGL 2 in a browser against the CPU", case_webgl},
    {"WGSL in a browser against the CPU", case_wgsl},
    {"a viewport and a center of their own", case_viewport},
    {"nothing crosses between materials", case_bleeding},
    {"what is refused, by name", case_refused},
    {"texels read by 7 taps", case_reads},
    {"layout of the constants", case_constants},
    {"transmission in a light loop", case_transmission},
    {"depth of 16 bits", case_half_depth},
    {"streaks at half resolution", case_streaks},
    {"disc and half resolution against random walks", case_walks},
    {"examples/engine/engine.c", case_engine},
    {"GLSL 330 is valid", case_glsl},
    {"GLSL ES 300 is valid", case_glsl_es},
    {"HLSL is valid", case_hlsl},
    {"Vulkan GLSL is valid", case_vulkan},
};
TEST_MAIN(cases)
