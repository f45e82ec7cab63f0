/* What the comments of ms_sss.h state in numbers and no other test holds: the tables of errors, light that bodies and
   slabs return, bytes, radii. tests/statements_sss says which words each check stands for. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/ball.h"
#include "test.h"

#define PI 3.14159265358979323846

/* d'Eon's skin (GPU Gems 3, chapter 14): six Gaussians. */
static ms_sss_profile *skin(void)
{
    static const double variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
    static const double weight[6][3] = {{0.233, 0.455, 0.649}, {0.100, 0.336, 0.344}, {0.118, 0.198, 0.000},
                                        {0.113, 0.007, 0.007}, {0.358, 0.004, 0.000}, {0.078, 0.000, 0.000}};
    double sigma[6][3];
    ms_sss_profile *p = NULL;
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(variance[i]);
    CHECK_INT(ms_sss_profile_from_gaussians(&p, 6, (const double(*)[3])sigma, weight, NULL, NULL), MS_OK);
    return p;
}

static ms_sss_errors measured(const ms_sss_designer *d, ms_sss_model model, int taps, int terms)
{
    static ms_sss_kernel k;
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_errors e;
    memset(&e, 0, sizeof e);
    o.model = model;
    o.tap_count = taps;
    o.term_count = terms;
    if (model == MS_SSS_PREINTEGRATED) o.placement = MS_SSS_QUADRATIC;
    CHECK_INT(ms_sss_kernel_build(&k, d, &o, NULL), MS_OK);
    CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_OK);
    return e;
}

/* The tables of "What it costs", in %, with two digits behind the point: half of the last digit, and 0.3% of the value
   for a descent that a build without SIMD or with other rounding ends elsewhere. */
static void case_tables(void)
{
    static const struct {
        ms_sss_model model;
        int taps, terms;
        double vertical, diagonal, texture;
    } dense[5] = {{MS_SSS_SLICE, MS_SSS_DENSE, 0, 7.80, 8.23, 22.80},
                  {MS_SSS_SVD_NORMALIZED, MS_SSS_DENSE, 0, 6.48, 6.29, 16.62},
                  {MS_SSS_PREINTEGRATED, MS_SSS_DENSE, 0, 0.00, 3.03, 7.33},
                  {MS_SSS_IMAGE_OPTIMAL, 33, 0, 1.72, 1.18, 3.61},
                  {MS_SSS_RESIDUAL, MS_SSS_DENSE, 2, 0.00, 0.88, 1.22}};
    static const struct {
        ms_sss_model model;
        int terms;
        double texture[2][3]; /* radii of 24 and 96 pixels; 7, 11, 17 taps */
    } taps[3] = {{MS_SSS_PREINTEGRATED, 0, {{4.48, 4.45, 5.80}, {11.59, 8.58, 7.71}}},
                 {MS_SSS_IMAGE_OPTIMAL, 0, {{2.50, 1.61, 1.37}, {9.25, 5.62, 4.14}}},
                 {MS_SSS_RESIDUAL, 2, {{1.89, 0.67, 0.28}, {8.12, 3.74, 1.89}}}};
    static const int count[3] = {7, 11, 17};
    ms_sss_profile *p = skin();
    ms_sss_designer *d[2] = {NULL, NULL};
    double worst = 0;
    int i, n, r;
    CHECK_INT(ms_sss_designer_create(&d[0], p, 24, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_designer_create(&d[1], p, 96, NULL, NULL), MS_OK);
    for (i = 0; i < 5; ++i) {
        const ms_sss_errors e = measured(d[1], dense[i].model, dense[i].taps, dense[i].terms);
        CHECK_NEAR(100 * e.vertical_step, dense[i].vertical, 0.005 + 0.003 * dense[i].vertical);
        CHECK_NEAR(100 * e.diagonal_step, dense[i].diagonal, 0.005 + 0.003 * dense[i].diagonal);
        CHECK_NEAR(100 * e.texture, dense[i].texture, 0.005 + 0.003 * dense[i].texture);
    }
    for (i = 0; i < 3; ++i)
        for (r = 0; r < 2; ++r)
            for (n = 0; n < 3; ++n) {
                const double stated = taps[i].texture[r][n];
                const double found = 100 * measured(d[r], taps[i].model, count[n], taps[i].terms).texture;
                CHECK_NEAR(found, stated, 0.005 + 0.003 * stated);
                worst = fmax(worst, fabs(found - stated));
            }
    TEST_NOTE("texture errors by taps within %.3f of the table", worst);
    ms_sss_designer_destroy(d[0]);
    ms_sss_designer_destroy(d[1]);
    ms_sss_profile_destroy(p);
}

/* The radius that holds a fraction of the light, against the disc's closed form: both sides of it. */
static void case_radius(void)
{
    const double reflectance[3] = {0.9, 0.5, 0.1}, d_mm[3] = {3, 0.7, 0.002};
    ms_sss_profile *p[2] = {NULL, NULL};
    double fraction;
    int n, c;
    CHECK_INT(ms_sss_profile_from_burley(&p[0], reflectance, d_mm, NULL, NULL), MS_OK);
    p[1] = skin();
    for (n = 0; n < 2; ++n) {
        double total[3], radius[3], inside[3], outside[3], at[3];
        ms_sss_profile_reflectance(p[n], total);
        for (fraction = 0.01; fraction < 1; fraction += 0.049) {
            ms_sss_profile_radius(p[n], fraction, radius);
            for (c = 0; c < 3; ++c) {
                ms_sss_profile_disc(p[n], radius[c] * (1 - 1e-9), at);
                inside[c] = at[c];
                ms_sss_profile_disc(p[n], radius[c] * (1 + 1e-9), at);
                outside[c] = at[c];
                CHECK(inside[c] <= fraction * total[c] && fraction * total[c] <= outside[c]); /* to 1e-9, as stated */
            }
        }
        ms_sss_profile_destroy(p[n]);
    }
}

/* The weight by depth nearly is a Gaussian's. */
static void case_falloff(void)
{
    const double end = 3.0746;
    double worst = 0;
    int i;
    for (i = 0; i <= 1000; ++i) {
        const double z = 5.0 * i / 1000, q = z < end ? 1 - z * z / (end * end) : 0;
        worst = fmax(worst, fabs(q * q * q * q - exp(-z * z / 2)));
    }
    CHECK_LE(worst, 0.034); /* as stated */
    CHECK(worst > 0.033);
}

/* --- bodies and slabs, against random walks --- */

/* What the rings of a plane return on a ball or around a hollow, or on a cylinder, by the law of ms_sss_elevation. On a
   ball the area within a straight distance r is pi r^2, as on a plane; on a cylinder it is summed by strips. */
static double returned(const ball_tally *plane, int i, ball_shape shape, double a, double K)
{
    double with = 0, without = 0;
    int b, k;
    for (b = 0; b < BALL_BINS; ++b) {
        const double r0 = ball_edge(b), r1 = ball_edge(b + 1), r = 0.5 * (r0 + r1);
        const double density = plane->ring[i][b] / (PI * (r1 * r1 - r0 * r0));
        if (shape == BALL_SPHERE) {
            if (r > 2 * fabs(a)) break;
            with += plane->ring[i][b] * pow(fmax(0, 1 + K * r / (8 * a)), 4);
            without += plane->ring[i][b];
            continue;
        }
        for (k = 0; k < 100; ++k) {
            const double turn = PI * (k + 0.5) / 100, c = 2 * a * sin(turn / 2);
            double area;
            if (c >= r1) break;
            area = 4 * a * PI / 100 * (sqrt(r1 * r1 - c * c) - (r0 > c ? sqrt(r0 * r0 - c * c) : 0));
            with += density * area * pow(1 + K * c * c / (8 * a * fmax(r, c)), 4);
            without += density * area;
        }
    }
    return fmin(1, with * plane->total[i] / without);
}

/* Bodies of 8 mean free paths within 4%, of 4 within 8%, where the plane returns more than a tenth; hollows of 4 at most
   40% too bright. Three standard errors of the walks beside. */
static void case_bodies(void)
{
    static const double albedo[5] = {0.5, 0.7, 0.9, 0.98, 0.999}, index[2] = {1, 1.4};
    static const struct {
        ball_shape shape;
        double radius, stated;
    } body[5] = {{BALL_SPHERE, 8, 0.04},
                 {BALL_CYLINDER, 8, 0.04},
                 {BALL_SPHERE, 4, 0.08},
                 {BALL_CYLINDER, 4, 0.08},
                 {BALL_SPHERE, -4, 0.4}};
    static ball_tally plane, walked;
    const long walks = 60000;
    double worst[3] = {0, 0, 0};
    int n, s, i;
    TEST_METHOD;
    for (n = 0; n < 2; ++n) {
        ball_walk(BALL_SPHERE, 0, index[n], albedo, 5, 3 * walks, test_seed, &plane);
        for (s = 0; s < 5; ++s) {
            ball_walk(body[s].shape, 1 / body[s].radius, index[n], albedo, 5, walks, test_seed + 1, &walked);
            for (i = 0; i < 5; ++i) {
                const double error = sqrt((plane.square[i] / 3 + walked.square[i]) / (double)walks) / walked.total[i];
                const double K = ms_sss_elevation(plane.total[i], index[n]);
                const double off = returned(&plane, i, body[s].shape, body[s].radius, K) / walked.total[i] - 1;
                if (plane.total[i] < 0.1) continue;
                CHECK_LE(off, body[s].stated + 3 * error);
                if (body[s].radius > 0) CHECK_LE(-off, body[s].stated + 3 * error);
                worst[s / 2] = fmax(worst[s / 2], body[s].radius > 0 ? fabs(off) : off);
            }
        }
    }
    CHECK(worst[2] > 0.3);
    TEST_NOTE("8 mean free paths within %.1f%%, 4 within %.1f%%; hollows %.0f%% too bright", 100 * worst[0],
              100 * worst[1], 100 * worst[2]);
}

/* Slabs from an eighth to 24 mean free paths, reflectances from 0.15 to 0.95: within 7% where more than a thousandth
   passes; with an index of 1.4 inside less passes: up to a fifth for reflectances from 0.4 on, a third below. The profile is a walk's own below a plane. */
static void case_slabs(void)
{
    static const double albedo[6] = {0.52, 0.7, 0.9, 0.97, 0.99, 0.999}, thickness[5] = {0.125, 0.5, 2, 6, 24};
    static const double index[2] = {1, 1.4};
    static ball_tally plane, slab;
    const long walks = 100000;
    const float front[3] = {0, 0, -1}, back[3] = {0, 0, 1}, light[3] = {1, 1, 1};
    double edge[BALL_BINS + 1], ring[6][BALL_BINS], worst = 0, lost[2] = {0, 0};
    ms_sss_kernel k[2];
    int n, i, b, s;
    TEST_METHOD;
    for (i = 0; i <= BALL_BINS; ++i) edge[i] = ball_edge(i);
    for (n = 0; n < 2; ++n) {
        ball_walk(BALL_SPHERE, 0, index[n], albedo, 6, walks, test_seed, &plane);
        for (i = 0; i < 6; ++i)
            for (b = 0; b < BALL_BINS; ++b)
                ring[i][b] = plane.ring[i][b] / (PI * (edge[b + 1] * edge[b + 1] - edge[b] * edge[b]));
        for (i = 0; i < 2; ++i) {
            const double *value[3];
            ms_sss_profile *p = NULL;
            for (b = 0; b < 3; ++b) value[b] = ring[3 * i + b];
            CHECK_INT(ms_sss_profile_from_rings(&p, BALL_BINS, edge, value, 1, NULL, NULL), MS_OK);
            CHECK_INT(ms_sss_kernel_make(&k[i], NULL, p, 8, NULL, NULL, NULL), MS_OK);
            ms_sss_profile_destroy(p);
        }
        for (s = 0; s < 5; ++s) {
            ball_walk(BALL_SLAB, 1 / thickness[s], index[n], albedo, 6, walks, test_seed + 1, &slab);
            for (i = 0; i < 6; ++i) {
                float out[3];
                double off, noise;
                const ms_sss_kernel *of = &k[i / 3];
                ms_sss_transmission(of, (float)thickness[s], front, back, back, light, out);
                if (slab.through[i] < 1e-3 || plane.total[i] < 0.15 || plane.total[i] > 0.95) continue;
                off = (double)(of->reflectance[i % 3] * out[i % 3]) / slab.through[i] - 1;
                noise = 3 / sqrt((double)walks * slab.through[i]);
                if (index[n] > 1)
                    lost[plane.total[i] < 0.4] = fmax(lost[plane.total[i] < 0.4], 1 - 1 / (1 + off) - noise);
                else worst = fmax(worst, fabs(off) - noise);
            }
        }
    }
    TEST_NOTE("slabs within %.1f%% but for noise, with an index of 1.4 %.1f and %.1f%% less", 100 * worst,
              100 * lost[0], 100 * lost[1]);
    CHECK_LE(worst, 0.07); /* as stated */
    CHECK_LE(lost[0], 0.2);
    CHECK_LE(lost[1], 1.0 / 3);
}

/* --- bytes, pixels --- */

/* Workspaces of a picture of 1920 x 1080, in bytes a pixel. */
static void case_bytes(void)
{
    static ms_sss_kernel k;
    const double n = 1920.0 * 1080.0;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    double with_slope, flat;
    memset(&k, 0, sizeof k);
    k.tap_count = 7;
    k.term_count = 1;
    k.radius_mm = 1;
    o.fov_degrees = 30;
    with_slope = (double)ms_sss_filter_workspace(1920, 1080, &k, 1, &o) / n;
    CHECK_NEAR(with_slope, 30, 1);
    o.flat = 1;
    flat = (double)ms_sss_filter_workspace(1920, 1080, &k, 1, &o) / n;
    CHECK_NEAR(flat, 18, 1);
    k.term_count = 2;
    CHECK_NEAR((double)ms_sss_filter_workspace(1920, 1080, &k, 1, &o) / n - flat, 12, 0.5);
    CHECK_LE((double)ms_sss_pyramid_workspace(1920, 1080) / n, 40); /* one plane of floats more is too much */
    CHECK_NEAR((double)ms_sss_pyramid_workspace(1920, 1080) / n, 40, 4);
    TEST_NOTE("%.1f bytes a pixel, flat %.1f, the pyramid %.1f", with_slope, flat,
              (double)ms_sss_pyramid_workspace(1920, 1080) / n);
}

/* From how many pixels on a kernel is refused at shader.nearest. */
static void case_nearest(void)
{
    static const struct {
        int taps;
        double pixels;
    } stated[4] = {{7, 8}, {11, 16}, {17, 47}, {25, 150}};
    int i;
    for (i = 0; i < 4; ++i) {
        static ms_sss_kernel k;
        static float constants[600][4];
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_shader s = ms_sss_shader_defaults();
        int t, more;
        memset(&k, 0, sizeof k);
        k.tap_count = s.tap_count = stated[i].taps;
        k.term_count = 1;
        for (t = 0; t <= k.tap_count / 2; ++t) {
            k.offset_mm[t] = (float)t / (float)(k.tap_count / 2);
            k.weight[0][t][0] = k.weight[0][t][1] = k.weight[0][t][2] = 1 / (float)k.tap_count;
        }
        for (t = 0; t < 3; ++t) k.scale[0][t] = k.reflectance[t] = 1;
        k.radius_mm = 1;
        o.fov_degrees = 90; /* 2 mm of height at depth 1 */
        s.nearest = 1;
        for (more = 0; more < 2; ++more) {
            const int height = (int)(2 * stated[i].pixels) + (more ? 2 : -2); /* of one pixel more or less of radius */
            CHECK_INT(ms_sss_shader_constants(&k, 0, &o, 640, height, &s, constants, NULL),
                      more ? MS_UNSUPPORTED : MS_OK);
        }
    }
}

/* A wave down a plane's slope, by what its amplitude is multiplied in the middle of the picture; parallel rays. */
static double wave_kept(const ms_sss_kernel *k, double degrees, double *constant)
{
    enum { W = 96, H = 256 };
    static float in[W * H * 3], out[W * H * 3], depth[W * H];
    const double pixels_per_mm = 24, slope = tan(degrees * PI / 180), length = 8, phase = 0.4;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f;
    double a = 0, b = 0;
    int i, flat;
    o.ortho_height = (float)((int)H / pixels_per_mm);
    memset(&f, 0, sizeof f);
    f.width = W;
    f.height = H;
    f.input = ms_sss_interleaved(in, 3);
    f.output = ms_sss_interleaved(out, 3);
    f.depth = ms_sss_map(depth, 1);
    for (flat = 0; flat < 2; ++flat) {
        for (i = 0; i < W * H; ++i) {
            const double down = (i / W - H / 2) / pixels_per_mm, along = down / cos(degrees * PI / 180);
            depth[i] = (float)(512 + down * slope);
            in[3 * i] = in[3 * i + 1] = in[3 * i + 2] = flat ? 1
                                                             : (float)(1 + 0.5 * cos(2 * PI * along / length + phase));
        }
        CHECK_INT(ms_sss_filter(&f, k, 1, &o, NULL, 0, NULL), MS_OK);
        for (i = 0; i < W * H && flat; ++i) *constant = fmax(*constant, fabs((double)out[3 * i] - 1));
        for (i = W * (H / 2 - 8) + W / 2; i < W * (H / 2 + 8) && !flat; i += W) {
            a += ((double)out[3 * i] - 1) * ((double)in[3 * i] - 1);
            b += ((double)in[3 * i] - 1) * ((double)in[3 * i] - 1);
        }
    }
    return a / b;
}

/* Steep planes are filtered as planes that face the camera, to 83 degrees and not beyond. */
static void case_steep(void)
{
    const double sigma[1][3] = {{0.6, 0.6, 0.6}}, weight[1][3] = {{0.8, 0.8, 0.8}};
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_profile *p = NULL;
    ms_sss_kernel k;
    double facing, steep, steeper, constant = 0, none = 0;
    o.tap_count = 17;
    CHECK_INT(ms_sss_profile_from_gaussians(&p, 1, sigma, weight, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_kernel_make(&k, NULL, p, 24, &o, NULL, NULL), MS_OK);
    ms_sss_profile_destroy(p);
    facing = wave_kept(&k, 0, &constant);
    steep = wave_kept(&k, 82.8, &constant);
    steeper = wave_kept(&k, 87, &none);
    CHECK_NEAR(steep, facing, 0.01 * facing); /* a pixel is 8 times as long there, a third of a millimeter */
    CHECK_LE(constant, 2e-6);
    CHECK(fabs(steeper - facing) > 0.02);
    TEST_NOTE("a wave keeps %.4f, at 82.8 degrees %.4f, at 87 %.4f; constants within %.1e", facing, steep, steeper,
              constant);
}

/* Root mean square error of both filters on a picture with a 1/f spectrum, over the truth's: waves of one amplitude and
   evenly spread logarithms of their frequencies, of which the profile's Fourier transform says what stays. */
static void case_pyramid_from(void)
{
    enum { N = 256, WAVES = 120, MARGIN = 64 };
    static float in[N * N * 3], out[2][N * N * 3];
    static double truth[N * N];
    static const double radius[2] = {10, 16}, sigma[2][3] = {{0.3, 0.3, 0.3}, {1, 1, 1}};
    static const double weight[2][3] = {{0.5, 0.5, 0.5}, {0.3, 0.3, 0.3}};
    static ms_sss_pyramid shrinking;
    ms_sss_profile *p = NULL;
    double pyramid[2], taps[2], *error[2];
    int n, i, w, way;
    error[0] = taps, error[1] = pyramid;
    CHECK_INT(ms_sss_profile_from_gaussians(&p, 2, sigma, weight, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_pyramid_make(&shrinking, p, NULL), MS_OK);
    for (n = 0; n < 2; ++n) {
        const double pixels_per_mm = radius[n] / (double)shrinking.radius_mm;
        uint64_t seed = test_seed;
        ms_sss_kernel k;
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_frame f;
        double square = 0;
        memset(truth, 0, sizeof truth);
        memset(in, 0, sizeof in);
        for (w = 0; w < WAVES; ++w) {
            const double size = 2 * PI / (int)N * pow((int)N / 2.0, test_uniform(&seed)),
                         turn = 2 * PI * test_uniform(&seed);
            const double x = size * cos(turn), y = size * sin(turn), phase = 2 * PI * test_uniform(&seed);
            double kept = 0;
            for (i = 0; i < 2; ++i) kept += weight[i][0] / 0.8 * exp(-pow(size * sigma[i][0] * pixels_per_mm, 2) / 2);
            for (i = 0; i < N * N; ++i) {
                const double value = cos(x * (i % N) + y * (i / N) + phase);
                in[3 * i] += (float)value;
                truth[i] += kept * value;
            }
        }
        for (i = 0; i < N * N; ++i) in[3 * i + 1] = in[3 * i + 2] = in[3 * i];
        memset(&f, 0, sizeof f);
        f.width = f.height = N;
        f.input = ms_sss_interleaved(in, 3);
        o.pixels_per_mm[0] = (float)pixels_per_mm;
        CHECK_INT(ms_sss_kernel_make(&k, NULL, p, radius[n], NULL, NULL, NULL), MS_OK);
        f.output = ms_sss_interleaved(out[0], 3);
        CHECK_INT(ms_sss_filter(&f, &k, 1, &o, NULL, 0, NULL), MS_OK);
        f.output = ms_sss_interleaved(out[1], 3);
        CHECK_INT(ms_sss_pyramid_filter(&f, &shrinking, 1, &o, NULL, 0, NULL), MS_OK);
        taps[n] = pyramid[n] = 0;
        for (i = 0; i < N * N; ++i) {
            if (abs(i % N - N / 2) > N / 2 - MARGIN || abs(i / N - N / 2) > N / 2 - MARGIN) continue;
            for (way = 0; way < 2; ++way) error[way][n] += pow((double)out[way][3 * i] - truth[i], 2);
            square += truth[i] * truth[i];
        }
        taps[n] = sqrt(taps[n] / square);
        pyramid[n] = sqrt(pyramid[n] / square);
    }
    ms_sss_profile_destroy(p);
    CHECK(pyramid[0] < taps[0]); /* 10 pixels */
    CHECK(pyramid[1] < taps[1]); /* 16 pixels */
    TEST_NOTE("10 pixels: 7 taps %.2f%%, pyramid %.2f%%; 16: %.2f%%, %.2f%%", 100 * taps[0], 100 * pyramid[0],
              100 * taps[1], 100 * pyramid[1]);
}

/* --- the ends of stated ranges --- */

static ms_status profile_of(double edge, double gap, double value, double sigma, double weight, int count)
{
    const double edges[3] = {0, edge - gap, edge}, values[2] = {1, value};
    const double *const rings[3] = {values, values, values};
    const double sigmas[1][3] = {{sigma, sigma, sigma}}, weights[1][3] = {{weight, weight, weight}};
    ms_sss_profile *p = NULL;
    const ms_status status = count ? ms_sss_profile_from_rings(&p, 2, edges, rings, 1, NULL, NULL)
        : edge > 0                 ? ms_sss_profile_from_gaussians(&p, 1, sigmas, weights, NULL, NULL)
                                   : ms_sss_profile_from_burley(&p, weights[0], sigmas[0], NULL, NULL);
    CHECK((p != NULL) == (status == MS_OK));
    ms_sss_profile_destroy(p);
    return status;
}

static void case_ranges(void)
{
    const double reflectance[3] = {0.5, 0.4, 0.3}, d_mm[3] = {1, 0.5, 0.2};
    ms_sss_kernel k, kept;
    ms_sss_profile *p = NULL;
    ms_sss_designer *d = NULL;
    ms_sss_errors e;
    int gaussians;
    CHECK_INT(profile_of(1e9, 1, 1e30, 1, 1, 2), MS_OK); /* rings to 1e9 mm, values to 1e30 */
    CHECK_INT(profile_of(1.0001e9, 1, 1, 1, 1, 2), MS_INVALID_ARGUMENT);
    CHECK_INT(profile_of(1e9, 1, 1.0001e30, 1, 1, 2), MS_INVALID_ARGUMENT);
    CHECK_INT(profile_of(2e-9, 1.01e-9, 1, 1, 1, 2), MS_INVALID_ARGUMENT); /* rings of 1e-9 mm at least */
    CHECK_INT(profile_of(2.02e-9, 1.01e-9, 1, 1, 1, 2), MS_OK);
    for (gaussians = 0; gaussians < 2; ++gaussians) { /* sizes of 1e-9 to 1e9 mm, weights of 0 to 1e9 */
        CHECK_INT(profile_of(gaussians, 1, 1, 1e-9, 0, 0), MS_OK);
        CHECK_INT(profile_of(gaussians, 1, 1, 1e9, 1e9, 0), MS_OK);
        CHECK_INT(profile_of(gaussians, 1, 1, 0.999e-9, 1, 0), MS_INVALID_ARGUMENT);
        CHECK_INT(profile_of(gaussians, 1, 1, 1.0001e9, 1, 0), MS_INVALID_ARGUMENT);
        CHECK_INT(profile_of(gaussians, 1, 1, 1, 1.0001e9, 0), MS_INVALID_ARGUMENT);
        CHECK_INT(profile_of(gaussians, 1, 1, 1, -1e-9, 0), MS_INVALID_ARGUMENT);
    }
    CHECK_INT(ms_sss_profile_from_burley(&p, reflectance, d_mm, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_designer_create(&d, p, 1.0001e9, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_sss_designer_create(&d, p, 8, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_kernel_build(&k, d, NULL, NULL), MS_OK);
    kept = k;
    { /* a cell is the radius of the widest channel over 8.5 */
        double radius[3];
        ms_sss_profile_radius(p, 0.99, radius);
        k.offset_mm[k.tap_count / 2] = (float)(0.99e6 * radius[0] / 8.5);
        CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_OK);
        k.offset_mm[k.tap_count / 2] = (float)(1.01e6 * radius[0] / 8.5);
        CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_INVALID_ARGUMENT);
    }
    kept.tap_count = 0;
    CHECK_INT(ms_sss_kernel_measure(&e, &kept, d), MS_INVALID_ARGUMENT);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

static const test_case cases[] = {
    {"tables", case_tables},   {"radius", case_radius}, {"falloff", case_falloff},
    {"bodies", case_bodies},   {"slabs", case_slabs},   {"bytes", case_bytes},
    {"nearest", case_nearest}, {"steep", case_steep},   {"pyramid from", case_pyramid_from},
    {"ranges", case_ranges}};

TEST_MAIN(cases)
