/* Random calls of both filters of ms_sss.h, sizes 1 to 65, all options, NaN, infinity and other hostile numbers in a
   third: a call is refused by name or everything is as promised. The seed is new in every run and printed; a run is
   repeated with --seed. Under the sanitizers nothing is read or written outside, and no number overflows. */
#define MS_SSS_WITH_SCALAR
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"
#include <time.h>

enum { SIDE = 65, KERNELS = 11, GUARD = 8 };

static ms_sss_kernel kernels[KERNELS];
static ms_sss_pyramid pyramids[2];

static void make_kernels(void)
{
    static const int taps[KERNELS] = {7, 3, 17, 33, 7, 7, 5, 11, 65, 9, MS_SSS_DENSE};
    const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3}, other[3] = {0.95, 0.6, 0};
    ms_sss_profile *profile = NULL;
    int i;
    for (i = 0; i < KERNELS; ++i) {
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        ms_error error;
        o.tap_count = taps[i];
        if (taps[i] > 33) o.placement = MS_SSS_QUANTILE;
        if (i == 4) o.model = MS_SSS_RESIDUAL;
        if (i == 5) o.model = MS_SSS_GAUSSIANS, o.term_count = 3;
        if (i == 6) o.model = MS_SSS_GUIDED;
        if (i == 7) o.model = MS_SSS_ARTIST;
        if (i == 10) o.model = MS_SSS_PREINTEGRATED;
        if (i == 9) o.model = MS_SSS_SLICE, o.placement = MS_SSS_QUADRATIC;
        ms_sss_profile_destroy(profile);
        CHECK_INT(ms_sss_profile_from_burley(&profile, i % 2 ? other : reflectance, d_mm, NULL, NULL), MS_OK);
        if (ms_sss_kernel_make(&kernels[i], NULL, profile, i % 3 == 0 ? 24 : i % 3 == 1 ? 8 : 20, &o, NULL, &error))
            TEST_FAIL("kernel %d: %s", i, error.message);
        if (i < 2) CHECK_INT(ms_sss_pyramid_make(&pyramids[i], profile, NULL), MS_OK);
    }
    ms_sss_profile_destroy(profile);
}

static float *pixel(const ms_sss_image *image, int c, int x, int y)
{
    return (float *)image->channel[c] + x * image->pixel_stride + y * image->row_stride;
}

static int integer(uint64_t *seed, int low, int high)
{
    return low + (int)(test_random_u64(seed) % (uint64_t)(high - low + 1));
}

static double log_uniform(uint64_t *seed, double low, double high) { return low * pow(high / low, test_uniform(seed)); }

static void run_tasks(void *user, int count, void (*task)(void *context, int index), void *context)
{
    const int from = *(const int *)user % count;
    int i;
    for (i = 0; i < count; ++i) task(context, (from + i) % count);
}

/* Pictures of a call. depth_kind: even, a plane, noise, steps. */
typedef struct pictures {
    float light[SIDE * SIDE * 4], out[SIDE * SIDE * 4 + 2 * GUARD], depth[SIDE * SIDE], strength[SIDE * SIDE],
        normal[SIDE * SIDE * 4];
    uint8_t profile[SIDE * SIDE];
} pictures;

static void fill(pictures *p, int n, int width, int constant, uint64_t *seed)
{
    const float even = (float)test_uniform(seed);
    const double base = log_uniform(seed, 1, 1000), bump = log_uniform(seed, 1e-4, 3),
                 slope = 4 * test_uniform(seed) - 2;
    const int kind = integer(seed, 0, 3);
    int i;
    for (i = 0; i < 4 * n; ++i) {
        p->light[i] = constant ? even : (float)test_uniform(seed);
        p->normal[i] = (float)(2 * test_uniform(seed) - 1);
    }
    for (i = 0; i < n; ++i) {
        const int x = i % width, y = i / width;
        const double steps[4] = {0, 0.001 * slope * x + 0.0007 * y, bump * test_uniform(seed),
                                 (x / 7 + y / 5) % 2 * bump};
        p->depth[i] = (float)(base * (1 + steps[kind]));
        p->strength[i] = (float)(1.2 * test_uniform(seed));
        p->profile[i] = (uint8_t)integer(seed, 0, 2);
    }
}

static void spoil(pictures *p, int n, uint64_t *seed)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY, 0, -1, 1e31f, 1e-38f, 3e38f};
    int i;
    for (i = 0; i < 20; ++i) {
        float *const picture[4] = {p->light, p->depth, p->strength, p->normal};
        const int which = integer(seed, 0, 3), count = which == 1 || which == 2 ? n : 4 * n;
        picture[which][integer(seed, 0, count - 1)] = bad[integer(seed, 0, 7)];
    }
}

static ms_sss_filter_options draw_options(int *first, uint64_t *seed)
{
    ms_sss_filter_options o = ms_sss_filter_defaults();
    const int camera = integer(seed, 0, 2);
    if (camera == 0) o.fov_degrees = (float)log_uniform(seed, 1, 170);
    if (camera == 1) o.ortho_height = (float)log_uniform(seed, 1, 1000);
    if (camera == 2) o.pixels_per_mm[0] = (float)log_uniform(seed, 0.01, 100);
    if (camera == 2 && integer(seed, 0, 1)) o.pixels_per_mm[1] = (float)log_uniform(seed, 0.01, 100);
    if (integer(seed, 0, 9)) o.mm_per_unit = (float)log_uniform(seed, 0.1, 1000);
    if (integer(seed, 0, 2) == 0) o.depth_sigma_mm = (float)log_uniform(seed, 0.01, 100);
    if (integer(seed, 0, 2) == 0) o.flat = integer(seed, 0, 1) ? 1 : (float)test_uniform(seed);
    if (integer(seed, 0, 2) == 0) o.center[0] = (float)(200 * test_uniform(seed) - 100);
    o.depth_mode = integer(seed, 0, 5) ? MS_SSS_DEPTH_AWARE : MS_SSS_DEPTH_SCALE;
    o.simd = (ms_simd)integer(seed, 0, 4);
    o.exact = integer(seed, 0, 1);
    if (integer(seed, 0, 1)) o.parallel.user = first, o.parallel.run = run_tasks;
    *first = integer(seed, 0, 15);
    if (integer(seed, 0, 49) == 0) { /* a hostile option */
        static const float bad[] = {NAN, INFINITY, -1, 1e38f, 1e-38f};
        float *const field[] = {&o.pixels_per_mm[1], &o.mm_per_unit, &o.depth_sigma_mm, &o.flat, &o.center[1]};
        *field[integer(seed, 0, 4)] = bad[integer(seed, 0, 4)];
    }
    return o;
}

/* Without slopes, or without depth, a constant stays constant; in any case reflectance times the output is at most the
   brightest input. Masked pixels keep their bits. */
static void check_output(const ms_sss_frame *f, const ms_sss_filter_options *o, const ms_sss_kernel *k, int count,
                         int by_pyramid, int constant, int dirty, int number)
{
    const int even = o->flat >= 1 || o->depth_mode == MS_SSS_DEPTH_SCALE || !f->depth.channel[0];
    float brightest = 0, factor[3];
    int x, y, c, i;
    for (c = 0; c < 3; ++c) {
        factor[c] = by_pyramid ? pyramids[0].reflectance[c] : k[0].reflectance[c];
        for (i = 1; i < count; ++i)
            factor[c] = fminf(factor[c], by_pyramid ? pyramids[i].reflectance[c] : k[i].reflectance[c]);
    }
    for (y = 0; y < f->height; ++y)
        for (x = 0; x < f->width; ++x)
            for (c = 0; c < 3; ++c) brightest = fmaxf(brightest, *pixel(&f->input, c, x, y));
    for (y = 0; y < f->height; ++y)
        for (x = 0; x < f->width; ++x)
            for (c = 0; c < 3; ++c) {
                const float v = *pixel(&f->output, c, x, y), e = *pixel(&f->input, c, x, y);
                if (dirty) continue;
                if (!(v > -1e6f && v < 1e6f)) TEST_FAIL("call %d, pixel %d, %d: %g", number, x, y, (double)v);
                if (constant && even && !(fabsf(v - e) <= 1e-6f + 1e-6f * fabsf(e)))
                    TEST_FAIL("call %d, pixel %d, %d: constant %g becomes %g", number, x, y, (double)e, (double)v);
                if (factor[c] > 0 && k[0].term_count == 1 && k[count - 1].term_count == 1 &&
                    !(v * factor[c] <= brightest * (1 + 2e-6f) + 1e-30f))
                    TEST_FAIL("call %d, pixel %d, %d: %g of %g", number, x, y, (double)v, (double)brightest);
            }
}

static int one_call(pictures *p, uint64_t *seed, int number)
{
    static float before[SIDE * SIDE * 4];
    const int w = integer(seed, 1, SIDE), h = integer(seed, 1, SIDE), n = w * h;
    const int constant = integer(seed, 0, 3) == 0, dirty = integer(seed, 0, 2) == 0, by_pyramid = integer(seed, 0, 1),
              in_place = integer(seed, 0, 3) == 0, channels = integer(seed, 3, 4);
    int first, count = 1, i, touched = 0;
    ms_sss_filter_options o = draw_options(&first, seed);
    ms_sss_kernel k[2];
    ms_sss_frame f;
    ms_error error;
    ms_status status;
    fill(p, n, w, constant, seed);
    if (dirty) spoil(p, n, seed);
    for (i = 0; i < 4 * n + 2 * GUARD; ++i) p->out[i] = -7;
    memset(&f, 0, sizeof f);
    f.width = w;
    f.height = h;
    f.input = ms_sss_interleaved(p->light, channels);
    f.output = integer(seed, 0, 3) ? ms_sss_interleaved(p->out + GUARD, integer(seed, 3, 4))
                                   : ms_sss_planar(p->out + GUARD, p->out + GUARD + n, p->out + GUARD + 2 * n);
    if (!f.output.pixel_stride) f.output.pixel_stride = 1;
    f.input.row_stride = f.input.pixel_stride * w;
    f.output.row_stride = f.output.pixel_stride * w;
    if (o.fov_degrees > 0 || integer(seed, 0, 2)) f.depth = ms_sss_map(p->depth, 1);
    if (integer(seed, 0, 3) == 0) f.strength = ms_sss_map(p->strength, 1);
    if (integer(seed, 0, 5) == 0) f.normal = ms_sss_interleaved(p->normal, 4);
    if (integer(seed, 0, 4) == 0) f.profile = p->profile, count = 2;
    k[0] = kernels[integer(seed, 0, KERNELS - 1)];
    k[1] = kernels[integer(seed, 0, KERNELS - 1)];
    memcpy(before, p->light, sizeof(float) * 4 * (size_t)n);
    if (by_pyramid) status = ms_sss_pyramid_filter(&f, pyramids, count, &o, NULL, 0, &error);
    else status = ms_sss_filter(&f, k, count, &o, NULL, 0, &error);
    for (i = 0; i < GUARD; ++i) touched += p->out[i] > -7 || p->out[4 * n + GUARD + i] > -7;
    for (i = 0; i < 4 * n && status != MS_OK; ++i) touched += !(p->out[GUARD + i] <= -7);
    if (touched || memcmp(before, p->light, sizeof(float) * 4 * (size_t)n))
        TEST_FAIL("call %d writes elsewhere", number);
    if (status != MS_OK && strlen(error.message) < 5) TEST_FAIL("call %d says nothing", number);
    if (status == MS_OK) check_output(&f, &o, k, count, by_pyramid, constant, dirty, number);
    if (status == MS_OK && in_place && channels == 3) { /* the same bits */
        ms_sss_frame same = f;
        int x, y, c;
        same.output = same.input;
        if (by_pyramid) ms_sss_pyramid_filter(&same, pyramids, count, &o, NULL, 0, NULL);
        else ms_sss_filter(&same, k, count, &o, NULL, 0, NULL);
        for (y = 0; y < h; ++y)
            for (x = 0; x < w; ++x)
                for (c = 0; c < 3; ++c)
                    if (memcmp(pixel(&f.output, c, x, y), pixel(&same.output, c, x, y), sizeof(float)))
                        TEST_FAIL("call %d: other bits in place", number);
    }
    return status == MS_OK;
}

static void random_calls(void)
{
    static pictures p;
    const int calls = test_full ? 100000 : 2500;
    uint64_t seed = test_seed != 1 ? test_seed : (uint64_t)time(NULL) & 0xffffff;
    int i, done = 0;
    printf("test_sss_random --seed %lu\n", (unsigned long)seed);
    make_kernels();
    for (i = 0; i < calls; ++i) {
        uint64_t own = seed * 1000003u + (uint64_t)i;
        done += one_call(&p, &own, i);
    }
    CHECK(done > calls / 2);
    TEST_NOTE("%d of %d calls filter, the others are refused", done, calls);
}

static const test_case cases[] = {{"random calls", random_calls}};
TEST_MAIN(cases)
