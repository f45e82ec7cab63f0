/* gather.h: against the profile on planes and balls, thin plates with a back layer, and what must hold of any
   picture. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"
#include "gather.h"

enum { W = 96, H = 80 };
static const double PI = 3.14159265358979323846;
static float light[W * H * 3], out[W * H * 3], depth[W * H], back_light[W * H * 3], back_depth[W * H];

static ms_sss_profile *burley(double R, double d)
{
    ms_sss_profile *p = NULL;
    double reflectance[3], d_mm[3];
    int c;
    for (c = 0; c < 3; ++c) reflectance[c] = R * (1 - 0.25 * c), d_mm[c] = d / (1 + c);
    CHECK(ms_sss_profile_from_burley(&p, reflectance, d_mm, NULL, NULL) == MS_OK);
    return p;
}

static ms_sss_frame frame_of(void)
{
    ms_sss_frame f;
    memset(&f, 0, sizeof f);
    f.width = W;
    f.height = H;
    f.input = ms_sss_interleaved(light, 3);
    f.output = ms_sss_interleaved(out, 3);
    f.depth = ms_sss_map(depth, 1);
    return f;
}

/* A millimeter a pixel unless the field of view is set. */
static ms_sss_filter_options options_of(float fov)
{
    ms_sss_filter_options o = ms_sss_filter_defaults();
    if (fov > 0) o.fov_degrees = fov;
    else o.ortho_height = H;
    return o;
}

static ms_status gather(const ms_sss_frame *f, const gather_back *back, const ms_sss_profile *p,
                        const ms_sss_filter_options *o)
{
    return gather_filter(f, back, p, o, NULL);
}

/* A plane that turns about x by the angle; light where the way up along it, from the middle, is positive. */
static void plane(double degrees, int step)
{
    int x, y, c;
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x) {
            depth[y * W + x] = (float)(400 + (y + 0.5 - H / 2) * tan(degrees * PI / 180));
            for (c = 0; c < 3; ++c) light[3 * (y * W + x) + c] = !step || y < H / 2;
        }
}

/* On a plane at any tilt the profile's own step response, by the distance on the plane: strip(x) / 2 from the middle.
   The nearest patch is a disc and rings round it, not squares: 2.5% of the step at one pixel, less farther out. */
static void test_plane(void)
{
    static const double tilt[] = {0, 30, 60, 75};
    ms_sss_profile *p = burley(0.8, 2.5);
    ms_sss_frame f = frame_of();
    double total[3], worst = 0;
    int n, y, c, i;
    ms_sss_profile_reflectance(p, total);
    for (n = 0; n < 4; ++n) {
        ms_sss_filter_options o = options_of(0);
        plane(tilt[n], 0);
        CHECK(gather(&f, NULL, p, &o) == MS_OK);
        for (i = 0; i < W * H * 3; ++i)
            if (!(fabsf(out[i] - 1) < 1e-5f)) { /* depth in floats: 3e-5 mm of rounding tilt normals by as much */
                TEST_FAIL("tilt %g: a constant became %.9g at %d", tilt[n], (double)out[i], i);
                break;
            }
        plane(tilt[n], 1);
        CHECK(gather(&f, NULL, p, &o) == MS_OK);
        for (y = H / 2 - 10; y < H / 2 + 10; ++y)
            for (c = 0; c < 3; ++c) {
                double x = (H / 2 - y - 0.5) / cos(tilt[n] * PI / 180), strip[3], right,
                       got = (double)out[3 * (y * W + W / 2) + c];
                ms_sss_profile_strip(p, fabs(x), strip);
                right = 0.5 + 0.5 * (x > 0 ? 1 : -1) * strip[c] / total[c];
                if (fabs(got - right) > worst) worst = fabs(got - right);
                CHECK_NEAR(got, right, 0.04);
            }
    }
    TEST_NOTE("steps within %.3f", worst);
    ms_sss_profile_destroy(p);
}

/* A plate of constant thickness, lit on its far side alone. Both sides are planes without end compared to the radius,
   so that the answer is an integral over r: weights 2 pi r R_d at the true distance, the back's times the factor at
   sin(theta) = s / r. */
static void test_plate(void)
{
    ms_sss_profile *p = burley(0.7, 2);
    ms_sss_frame f = frame_of();
    gather_back back;
    ms_sss_filter_options o = options_of(0);
    double total[3], thickness = 4, reach[3];
    int i, c;
    memset(&back, 0, sizeof back);
    back.input = ms_sss_interleaved(back_light, 3);
    back.depth = ms_sss_map(back_depth, 1);
    for (i = 0; i < W * H; ++i) {
        depth[i] = 300;
        back_depth[i] = 304;
        for (c = 0; c < 3; ++c) light[3 * i + c] = 0, back_light[3 * i + c] = 1;
    }
    CHECK(gather(&f, &back, p, &o) == MS_OK);
    ms_sss_profile_reflectance(p, total);
    ms_sss_profile_radius(p, 0.99, reach);
    for (c = 0; c < 3; ++c) {
        double front[3], all = 0, with = 0, K = ms_sss_elevation(total[c], 1), inner[3], outer[3], r, right;
        double end = 1.5 * reach[0], got = (double)out[3 * (H / 2 * W + W / 2) + c];
        ms_sss_profile_disc(p, end, front);
        for (r = thickness; r < end; r += 0.002) { /* the plane at distance s holds 2 pi r dr in distances r > s */
            ms_sss_profile_disc(p, r, inner);
            ms_sss_profile_disc(p, r + 0.002, outer);
            all += outer[c] - inner[c];
            with += (outer[c] - inner[c]) * pow(1 + K * thickness / (4 * r), 4);
        }
        right = with / (front[c] + all);
        if (total[c] * with / (front[c] + all) > 1) right = 1 / total[c];
        CHECK_NEAR(got / right, 1, 0.03); /* patches of a pixel against an integral */
    }
    for (i = 0; i < W * H; ++i) back_depth[i] = i % 2 ? -1.0f : (float)NAN; /* nothing behind: dark */
    CHECK(gather(&f, &back, p, &o) == MS_OK);
    for (i = 0; i < W * H * 3; ++i) CHECK(out[i] == 0);
    ms_sss_profile_destroy(p);
}

/* A ball or a hollow of the given radius in the picture's middle, seen in perspective from 400 mm. */
static void ball(double radius, int hollow, float fov)
{
    double slope = 2 * tan((double)fov * PI / 360) / (double)H;
    int x, y, c;
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x) {
            double u = (x + 0.5 - W / 2) * slope, v = (y + 0.5 - H / 2) * slope, a = u * u + v * v + 1, b = -400, d;
            d = b * b - a * (160000 - radius * radius); /* (u, v, 1) z - (0, 0, 400) has the length of the radius */
            depth[y * W + x] = d >= 0 ? (float)((-b + (hollow ? 1 : -1) * sqrt(d)) / a) : -1;
            for (c = 0; c < 3; ++c) light[3 * (y * W + x) + c] = 1;
        }
}

/* Evenly lit, a ball returns more than the plane, a hollow less, and never more than it gets. In the middle, where the
   far side is out of reach, by the integral of the law over rings of the sphere. */
static void test_ball(void)
{
    static const double R[] = {0.3, 0.6, 0.95};
    int n, hollow, i;
    for (n = 0; n < 3; ++n)
        for (hollow = 0; hollow < 2; ++hollow) {
            ms_sss_profile *p = burley(R[n], 1.6);
            ms_sss_frame f = frame_of();
            ms_sss_filter_options o = options_of(10);
            double K = ms_sss_elevation(R[n], 1), with = 0, all, disc[3], before = 0, r, radius[3];
            double got;
            float most = 0, least = 9;
            ball(20, hollow, 10);
            CHECK(gather(&f, NULL, p, &o) == MS_OK);
            ms_sss_profile_radius(p, 0.99, radius);
            for (r = 0; r < 1.5 * radius[0]; r += 0.01) {
                ms_sss_profile_disc(p, r + 0.01, disc);
                with += (disc[0] - before) * pow(1 + (hollow ? -1 : 1) * K * (r + 0.005) / (2 * 20) / 4, 4);
                before = disc[0];
            }
            all = before;
            got = (double)out[3 * (H / 2 * W + W / 2)];
            CHECK_NEAR(got, fmin(with / all, 1 / R[n]), 0.02 * with / all); /* facets of a pixel */
            CHECK(hollow ? got < 0.97 : got > 1.01);
            for (i = 0; i < W * H; ++i)
                if (depth[i] > 0) {
                    int c;
                    for (c = 0; c < 3; ++c) {
                        float whole = out[3 * i + c] * (float)R[n] * (1 - 0.25f * (float)c);
                        if (whole > most) most = whole;
                    }
                    if (out[3 * i] < least) least = out[3 * i];
                }
            CHECK_LE((double)most, 1 + 1e-6); /* no more leaves than entered */
            CHECK(least > 0);
            o.flat = 1; /* then a constant stays one */
            CHECK(gather(&f, NULL, p, &o) == MS_OK);
            for (i = 0; i < W * H; ++i)
                if (depth[i] > 0) CHECK(fabsf(out[3 * i] - 1) < 2e-6f);
            ms_sss_profile_destroy(p);
        }
}

static void lumpy(float scale)
{
    uint64_t random = test_seed;
    int i, x, y;
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x)
            depth[y * W + x] = (float)(300 + 6 * sin(0.2 * x) + 5 * cos(0.15 * y + 0.1 * x) + (x > 60 ? 40 : 0));
    for (i = 0; i < W * H * 3; ++i) light[i] = scale * (float)test_uniform(&random);
}

/* Mirrored input, mirrored output; scaled input, scaled output (lights of 1e4); the same bits for any number of
   threads. */
static void test_symmetry(void)
{
    static float first[W * H * 3], keep[W * H * 3], keep_depth[W * H];
    static const int threads[] = {1, 2, 7};
    ms_sss_profile *p = burley(0.6, 3);
    ms_sss_frame f = frame_of();
    ms_sss_filter_options o = options_of(20);
    int x, y, c, i;
    o.mm_per_unit = 0.5f;
    lumpy(1e4f);
    for (i = 0; i < 3; ++i) {
        test_pool pool;
        o.parallel = test_parallel(&pool, threads[i]);
        CHECK(gather(&f, NULL, p, &o) == MS_OK);
        if (i == 0) memcpy(first, out, sizeof first);
        CHECK(memcmp(first, out, sizeof first) == 0);
    }
    memset(&o.parallel, 0, sizeof o.parallel);
    memcpy(keep, light, sizeof keep);
    memcpy(keep_depth, depth, sizeof keep_depth);
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x) {
            depth[y * W + x] = keep_depth[y * W + W - 1 - x];
            for (c = 0; c < 3; ++c) light[3 * (y * W + x) + c] = 1e-4f * keep[3 * (y * W + W - 1 - x) + c];
        }
    CHECK(gather(&f, NULL, p, &o) == MS_OK);
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x)
            for (c = 0; c < 3; ++c) /* sums in another order; groups of an even width mirror onto groups */
                CHECK_NEAR((double)out[3 * (y * W + W - 1 - x) + c], 1e-4 * (double)first[3 * (y * W + x) + c], 2e-5);
    ms_sss_profile_destroy(p);
}

/* Pixels that take no part are copied and give nothing; a NaN stays where it is. Strength as stated. */
static void test_masks(void)
{
    static float strength[W * H], plain[W * H * 3];
    ms_sss_profile *p = burley(0.6, 3);
    ms_sss_frame f = frame_of();
    ms_sss_filter_options o = options_of(20);
    int i, hole = 30 * W + 40, shade = 31 * W + 50;
    lumpy(1);
    depth[hole] = (float)NAN;
    light[3 * hole] = 1e30f;
    light[3 * shade + 1] = (float)INFINITY;
    CHECK(gather(&f, NULL, p, &o) == MS_OK);
    for (i = 0; i < W * H * 3; ++i) CHECK(i / 3 == shade || i / 3 == hole || (out[i] >= 0 && out[i] <= 3));
    CHECK(out[3 * hole] == 1e30f && out[3 * shade + 1] == (float)INFINITY);
    memcpy(plain, out, sizeof plain);
    f.strength = ms_sss_map(strength, 1);
    for (i = 0; i < W * H; ++i) strength[i] = 0.5f;
    CHECK(gather(&f, NULL, p, &o) == MS_OK);
    for (i = 0; i < W * H * 3; ++i)
        if (i / 3 != shade && i / 3 != hole)
            CHECK_NEAR((double)out[i], 0.5 * (double)plain[i] + 0.5 * (double)light[i], 1e-6);
    ms_sss_profile_destroy(p);
}

static void test_refused(void)
{
    static uint8_t index[W * H];
    ms_sss_profile *p = burley(0.6, 3);
    ms_sss_frame f = frame_of();
    gather_back back;
    ms_sss_filter_options o = options_of(20);
    lumpy(1);
    out[5] = 77;
    memset(&back, 0, sizeof back);
    CHECK(gather(&f, &back, p, &o) == MS_INVALID_ARGUMENT);
    f.profile = index;
    CHECK(gather(&f, NULL, p, &o) == MS_UNSUPPORTED);
    f.profile = NULL;
    o = ms_sss_filter_defaults();
    CHECK(gather(&f, NULL, p, &o) == MS_INVALID_ARGUMENT);
    o.pixels_per_mm[0] = 1;
    CHECK(gather(&f, NULL, p, &o) == MS_UNSUPPORTED);
    o = options_of(20);
    f.depth.channel[0] = NULL;
    CHECK(gather(&f, NULL, p, &o) == MS_INVALID_ARGUMENT);
    f = frame_of();
    f.width = 70000;
    CHECK(gather(&f, NULL, p, &o) == MS_INVALID_ARGUMENT);
    f = frame_of();
    o.mm_per_unit = 1e20f; /* lengths whose squares are no floats any more */
    CHECK(gather(&f, NULL, p, &o) == MS_INVALID_ARGUMENT);
    CHECK(out[5] == 77);
    ms_sss_profile_destroy(p);
}

static const test_case cases[] = {{"plane", test_plane},       {"plate", test_plate}, {"ball", test_ball},
                                  {"symmetry", test_symmetry}, {"masks", test_masks}, {"refused", test_refused}};
TEST_MAIN(cases)
