/* ms_sss.h: profiles, pre-integration, kernels and what they report of their errors. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "json.h"
#include <fenv.h>
#include "render/ball.h"
#include "test.h"
#include "choose.h"
#include "profile_csv.h"

static const double PI = 3.14159265358979323846;

/* --- profiles --- */

/* d'Eon and Luebke's six Gaussians for skin (GPU Gems 3, chapter 14). */
static const double skin_variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
static const double skin_weight[6][3] = {{0.233, 0.455, 0.649}, {0.1, 0.336, 0.344}, {0.118, 0.198, 0},
                                         {0.113, 0.007, 0.007}, {0.358, 0.004, 0},   {0.078, 0, 0}};

static ms_sss_profile *skin_profile(void)
{
    ms_sss_profile *p;
    double sigma[6][3];
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(skin_variance[i]);
    CHECK(ms_sss_profile_from_gaussians(&p, 6, (const double(*)[3])sigma, skin_weight, NULL, NULL) == MS_OK);
    return p;
}

static ms_sss_profile *burley_profile(double a, double b, double c)
{
    ms_sss_profile *p;
    double reflectance[3] = {1, 1, 1}, d[3];
    d[0] = a;
    d[1] = b;
    d[2] = c;
    CHECK(ms_sss_profile_from_burley(&p, reflectance, d, NULL, NULL) == MS_OK);
    return p;
}

/* Averages over n rings of equal width of a profile's own discs, so that energy is exact. */
static ms_sss_profile *rings_of(const ms_sss_profile *source, int n, double outer, double noise)
{
    ms_sss_profile *p;
    uint64_t random = test_seed;
    double *edge = (double *)malloc(sizeof *edge * (size_t)(n + 1)), *rd = (double *)malloc(sizeof *rd * 3 * (size_t)n);
    const double *value[3];
    int i, c;
    for (i = 0; i <= n; ++i) edge[i] = outer * i / n;
    for (i = 0; i < n; ++i) {
        double in[3], out[3];
        ms_sss_profile_disc(source, edge[i], in);
        ms_sss_profile_disc(source, edge[i + 1], out);
        for (c = 0; c < 3; ++c) {
            double v = (out[c] - in[c]) / (PI * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]));
            v *= 1 + noise * test_normal(&random);
            rd[c * n + i] = v > 0 ? v : 0;
        }
    }
    for (c = 0; c < 3; ++c) value[c] = rd + c * n;
    CHECK(ms_sss_profile_from_rings(&p, n, edge, value, 1, NULL, NULL) == MS_OK);
    free(edge);
    free(rd);
    return p;
}

static ms_sss_profile *gaussian_profile(double sigma)
{
    ms_sss_profile *p;
    double s[1][3], w[1][3] = {{1, 1, 1}};
    s[0][0] = s[0][1] = s[0][2] = sigma;
    CHECK(ms_sss_profile_from_gaussians(&p, 1, (const double(*)[3])s, (const double(*)[3])w, NULL, NULL) == MS_OK);
    return p;
}

static void strips_of_gaussian_rings(void)
{
    ms_sss_profile *g = gaussian_profile(1), *p = rings_of(g, 40000, 8.6, 0);
    double strip = 0, disc = 0, x, v[3];
    for (x = 0; x < 6; x += 0.0371) {
        ms_sss_profile_strip(p, x, v);
        strip = fmax(strip, fabs(v[1] - erf(x * sqrt(0.5))));
        ms_sss_profile_disc(p, x, v);
        disc = fmax(disc, fabs(v[1] + expm1(-0.5 * x * x)));
    }
    CHECK_LE(strip, 1e-12); /* sums of 40000 exact pieces: rounding */
    CHECK_LE(disc, 1e-12);
    ms_sss_profile_strip(g, 0.7, v);
    CHECK_NEAR(v[0], erf(0.7 * sqrt(0.5)), 1e-15);
    TEST_NOTE("strips of 40000 rings within %.1e, discs %.1e", strip, disc);
    ms_sss_profile_destroy(p);
    ms_sss_profile_destroy(g);
}

/* The part of a disc of radius r that lies within x of a line through its center. */
static double disc_within(double r, double x)
{
    return x < r ? 2 * (x * sqrt((r - x) * (r + x)) + r * r * asin(x / r)) : PI * r * r;
}

/* A uniform ring with a dark middle and a hole. */
static void exact_chords(void)
{
    const double edge[3] = {0.5, 2, 3}, rd[2] = {0, 1}, *const value[3] = {rd, rd, rd};
    double x, v[3], worst = 0;
    ms_sss_profile *p;
    CHECK(ms_sss_profile_from_rings(&p, 2, edge, value, 1, NULL, NULL) == MS_OK);
    for (x = 0; x < 3.2; x += 0.01) {
        ms_sss_profile_strip(p, x, v);
        worst = fmax(worst, fabs(v[2] - (disc_within(3, x) - disc_within(2, x))));
    }
    CHECK_LE(worst, 1e-13); /* a few roundings of numbers up to 81, the fourth power of the radius */
    CHECK_NEAR(v[0], PI * 5, 1e-12);
    TEST_NOTE("strips of a ring within %.1e", worst);
    ms_sss_profile_destroy(p);
}

/* The integral of R_d along a line at distance x, with y = x sinh u, by the trapezoidal rule. */
static double line_integral(const ms_sss_profile *p, double x, int c)
{
    double sum = 0, h = 1.0 / 64, u, v[3];
    for (u = -20; u <= 20; u += h) {
        ms_sss_profile_value(p, x * cosh(u), v);
        sum += v[c] * x * cosh(u);
    }
    return sum * h;
}

static void strips_of_burley(void)
{
    ms_sss_profile *p = burley_profile(0.4, 1, 2.5);
    double worst = 0, x, step, s0[3], s1[3];
    int c;
    for (x = 0.01; x < 8; x *= 1.7)
        for (c = 0; c < 3; ++c) { /* Simpson's rule over a 500th of x: its error, step^5, is below rounding */
            step = 0.002 * x;
            ms_sss_profile_strip(p, x, s0);
            ms_sss_profile_strip(p, x + step, s1);
            worst = fmax(worst,
                         fabs(s1[c] - s0[c] -
                              2 * step / 6 *
                                  (line_integral(p, x, c) + 4 * line_integral(p, x + step / 2, c) +
                                   line_integral(p, x + step, c))));
        }
    CHECK_LE(worst, 1e-13);
    ms_sss_profile_strip(p, 0, s0);
    ms_sss_profile_strip(p, 200, s1);
    CHECK_NEAR(s0[0], 0, 1e-14);
    CHECK_NEAR(s1[0], 1, 1e-14);
    TEST_NOTE("strips by Ki_1 within %.1e of quadrature", worst);
    ms_sss_profile_destroy(p);
}

/* Values and radii of the study (printed with 10 to 15 digits), and its a_p: the lines through the values, the slope of
   the strips. */
static void reference_profiles(void)
{
    json *j = json_load("tests/data/sss_profiles.json");
    const json *x = json_get(j, "x");
    const char *const name[2] = {"deon_skin", "burley"}, *const radius[4] = {"r50", "r90", "r99", "r999"};
    const double fraction[4] = {0.5, 0.9, 0.99, 0.999};
    double worst = 0, slope = 0;
    int n, c, i;
    for (n = 0; n < 2; ++n) {
        ms_sss_profile *p = n == 0 ? skin_profile() : burley_profile(1, 0.5, 0.25);
        for (c = 0; c < 3; ++c) {
            const json *channel = &json_get(j, name[n])->child[c];
            for (i = 0; i < x->count; ++i) {
                double v[3], at = x->child[i].number, h = 1e-3 * at, low[2][3], high[2][3];
                double rd = json_number(&json_get(channel, "Rd")->child[i]),
                       ap = json_number(&json_get(channel, "ap")->child[i]);
                int k;
                ms_sss_profile_value(p, at, v);
                worst = fmax(worst, fabs(v[c] / rd - 1));
                worst = fmax(worst, fabs(line_integral(p, at, c) / ap - 1));
                for (k = 0; k < 2; ++k) {
                    ms_sss_profile_strip(p, at - (k + 1) * h, low[k]);
                    ms_sss_profile_strip(p, at + (k + 1) * h, high[k]);
                }
                v[c] = (8 * (high[0][c] - low[0][c]) - (high[1][c] - low[1][c])) / (24 * h);
                slope = fmax(slope, fabs(v[c] - ap) * h);
            }
            for (i = 0; i < 4; ++i) {
                double r[3];
                ms_sss_profile_radius(p, fraction[i], r);
                CHECK_NEAR(r[c] / json_number(json_get(channel, radius[i])), 1, 2e-9); /* printed with 10 digits */
            }
        }
        ms_sss_profile_destroy(p);
    }
    CHECK_LE(worst, 1e-11); /* printed with 15 digits; a_p by adaptive quadrature */
    CHECK_LE(slope, 1e-14); /* times the step: what rounding of strips, up to 1, leaves of their differences */
    TEST_NOTE("R_d and a_p within %.1e, strips' slope times step %.1e", worst, slope);
    json_free(j);
}

static void samples_and_noise(void)
{
    ms_sss_profile *skin = skin_profile(), *p, *noisy;
    double r[400], rd[3][400], v[3], total[3], expected, worst = 0;
    const double *value[3];
    int i, c;
    for (i = 0; i < 400; ++i) { /* uneven, from a distance above 0 */
        r[i] = 0.01 * pow(1.018, i);
        ms_sss_profile_value(skin, r[i], v);
        for (c = 0; c < 3; ++c) rd[c][i] = v[c];
    }
    for (c = 0; c < 3; ++c) value[c] = rd[c];
    CHECK(ms_sss_profile_from_samples(&p, 400, r, value, 0, NULL, NULL) == MS_OK);
    ms_sss_profile_reflectance(p, total);
    for (c = 0; c < 3; ++c) CHECK_NEAR(total[c], 1, 1e-3); /* linear in r^2 over 1.8% steps */
    for (i = 0; i < 300; ++i) {
        double a[3];
        ms_sss_profile_strip(p, r[i], a);
        ms_sss_profile_strip(skin, r[i], v);
        worst = fmax(worst, fabs(a[0] - v[0]));
    }
    CHECK_LE(worst, 1e-3); /* of a total of 1, by the same steps */
    noisy = rings_of(skin, 600, 12, 0.3);
    ms_sss_profile_reflectance(noisy, total);
    for (c = 0; c < 3; ++c) { /* the slopes within rings must not change the energy: strip, disc and rings agree */
        ms_sss_profile_strip(noisy, 13, v);
        CHECK_NEAR(v[c], total[c], 1e-12);
        CHECK_NEAR(total[c], 1, 0.3); /* 30% noise over a few rings that matter */
    }
    ms_sss_profile_value(noisy, 11.99, v);
    CHECK(v[0] >= 0);
    ms_sss_profile_value(noisy, 12.01, v);
    CHECK(v[0] == 0 && v[1] == 0 && v[2] == 0);
    expected = worst;
    TEST_NOTE("a_p of 400 samples within %.1e", expected);
    ms_sss_profile_destroy(noisy);
    ms_sss_profile_destroy(p);
    ms_sss_profile_destroy(skin);
}

static void refused_profiles(void)
{
    double edge[4] = {0, 1, 2, 3}, rd[3] = {3, 2, 1}, bad[4], sigma[1][3] = {{1, 1, 0}}, weight[1][3] = {{1, 1, 1}};
    double d[3] = {1, 1, 1}, reflectance[3] = {1, 1, -1};
    const double *value[3];
    ms_sss_profile *p = (ms_sss_profile *)(void *)rd;
    ms_error error;
    value[0] = value[1] = value[2] = rd;
    CHECK(ms_sss_profile_from_rings(&p, 0, edge, value, 1, NULL, &error) == MS_INVALID_ARGUMENT && p == NULL);
    memcpy(bad, edge, sizeof bad);
    bad[2] = 1;
    CHECK(ms_sss_profile_from_rings(&p, 3, bad, value, 1, NULL, &error) == MS_INVALID_ARGUMENT && error.position == 2);
    CHECK(strstr(error.message, "increasing") != NULL);
    bad[2] = sqrt(-1.0);
    CHECK(ms_sss_profile_from_samples(&p, 3, bad, value, 1, NULL, &error) == MS_INVALID_ARGUMENT &&
          error.position == 2);
    rd[1] = -1e-9;
    CHECK(ms_sss_profile_from_rings(&p, 3, edge, value, 1, NULL, &error) == MS_INVALID_ARGUMENT && error.position == 1);
    rd[1] = HUGE_VAL;
    CHECK(ms_sss_profile_from_samples(&p, 3, edge, value, 1, NULL, &error) == MS_INVALID_ARGUMENT &&
          error.position == 1);
    CHECK(ms_sss_profile_from_samples(&p, 1, edge, value, 1, NULL, &error) == MS_INVALID_ARGUMENT);
    CHECK(ms_sss_profile_from_rings(&p, 3, edge, NULL, 1, NULL, NULL) == MS_INVALID_ARGUMENT);
    CHECK(ms_sss_profile_from_gaussians(&p, 1, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, &error) ==
          MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "channel 2") != NULL);
    CHECK(ms_sss_profile_from_gaussians(&p, 17, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, &error) ==
          MS_INVALID_ARGUMENT);
    CHECK(ms_sss_profile_from_burley(&p, reflectance, d, NULL, &error) == MS_INVALID_ARGUMENT && error.position == 2);
    ms_sss_profile_destroy(NULL);
}

static ms_sss_designer *designer_for(const ms_sss_profile *p, double radius_px)
{
    ms_sss_designer *d = NULL;
    ms_error error;
    if (ms_sss_designer_create(&d, p, radius_px, NULL, &error) != MS_OK) TEST_FAIL("designer: %s", error.message);
    return d;
}

/* Every argument that may not be NULL is named where it is. */
static void named_arguments(void)
{
    const double edge[3] = {0, 1, 2}, rd[2] = {1, 0.5}, three[1][3] = {{0.5, 0.5, 0.5}};
    const double *value[3] = {rd, rd, rd}, *hole[3] = {rd, rd, NULL};
    ms_sss_profile *p;
    ms_error e;
    int n;
    for (n = 0; n < 12; ++n) {
        static const char *const name[12] = {"profile", "edge_mm",  "value",  "value[2]", "stride",      "count",
                                             "r_mm",    "sigma_mm", "weight", "d_mm",     "reflectance", "count"};
        ms_status status = MS_OK;
        e.message[0] = 0;
        if (n == 0) status = ms_sss_profile_from_rings(NULL, 2, edge, value, 1, NULL, &e);
        if (n == 1) status = ms_sss_profile_from_rings(&p, 2, NULL, value, 1, NULL, &e);
        if (n == 2) status = ms_sss_profile_from_rings(&p, 2, edge, NULL, 1, NULL, &e);
        if (n == 3) status = ms_sss_profile_from_samples(&p, 2, edge, hole, 1, NULL, &e);
        if (n == 4) status = ms_sss_profile_from_rings(&p, 2, edge, value, -1, NULL, &e);
        if (n == 5) status = ms_sss_profile_from_samples(&p, 1, edge, value, 1, NULL, &e);
        if (n == 6) status = ms_sss_profile_from_samples(&p, 2, NULL, value, 1, NULL, &e);
        if (n == 7) status = ms_sss_profile_from_gaussians(&p, 1, NULL, three, NULL, &e);
        if (n == 8) status = ms_sss_profile_from_gaussians(&p, 1, three, NULL, NULL, &e);
        if (n == 9) status = ms_sss_profile_from_burley(&p, three[0], NULL, NULL, &e);
        if (n == 10) status = ms_sss_profile_from_burley(&p, NULL, three[0], NULL, &e);
        if (n == 11) status = ms_sss_profile_from_gaussians(&p, 0, three, three, NULL, &e);
        CHECK_INT(status, MS_INVALID_ARGUMENT);
        if (!strstr(e.message, name[n])) TEST_FAIL("%s: '%s'", name[n], e.message);
    }
}

/* Mean of r over a profile's red light, by thin rings to 400 mm. */
static double mean_distance(const ms_sss_profile *p)
{
    double inside = 0, r = 0, mean = 0, total[3], disc[3];
    int i;
    ms_sss_profile_reflectance(p, total);
    for (i = 0; i < 4000; ++i) {
        const double outer = 1e-4 * exp(15.2 * i / 3999);
        ms_sss_profile_disc(p, outer, disc);
        mean += (disc[0] - inside) * 0.5 * (r + outer) / total[0];
        inside = disc[0];
        r = outer;
    }
    return mean;
}

/* ms_sss_burley_d_mm takes the mean free path that ms_mcml.h takes: against its half-spaces with a mean free path of 1
   mm, isotropic scattering and no boundary. */
static void burley_mean_free_path(void)
{
    static const double scattered[] = {0.5, 0.7, 0.85, 0.93, 0.97, 0.985, 0.99, 0.993, 0.996, 0.998, 0.999, 0.9995};
    double worst = 0, least = 1, most = 0;
    int n, stated = 0;
    for (n = 0; n < 12; ++n) { /* scattered: of all interactions */
        const double d_unit = ms_sss_burley_d_mm(0.5, 1);
        double A[3], d[3], truth, found;
        const double *rd[3];
        ms_mcml_medium medium;
        ms_mcml_profile walk;
        ms_sss_profile *p = NULL, *q = NULL;
        ms_error error;
        memset(&medium, 0, sizeof medium);
        medium.mu_s_per_mm = scattered[n];
        medium.mu_a_per_mm = 1 - scattered[n];
        medium.eta = 1;
        CHECK_INT(ms_mcml_profile_make(&walk, &medium, 1, NULL, &error), MS_OK);
        rd[0] = rd[1] = rd[2] = walk.rd_per_mm2;
        CHECK_INT(ms_sss_profile_from_rings(&p, walk.rings, walk.edge_mm, rd, 1, NULL, &error), MS_OK);
        ms_sss_profile_reflectance(p, A);
        d[0] = d[1] = d[2] = ms_sss_burley_d_mm(A[0], 1);
        CHECK_NEAR(ms_sss_burley_d_mm(0.5, 3), 3 * d_unit, 1e-12); /* a length */
        CHECK_INT(ms_sss_profile_from_burley(&q, A, d, NULL, &error), MS_OK);
        truth = mean_distance(p);
        found = mean_distance(q);
        worst = fmax(worst, fabs(found / truth - 1));
        found *= 1 / (1.85 - A[0] + 7 * pow(fabs(A[0] - 0.8), 3)) / d[0]; /* the paper's equation: the mean is as d */
        if (fabs(A[0] - 0.75) < 0.01 || fabs(A[0] - 0.91) < 0.01) {
            CHECK_NEAR(1 - found / truth, A[0] < 0.8 ? 0.11 : 0.35, 0.01); /* as the declaration says */
            ++stated;
        }
        least = fmin(least, A[0]);
        most = fmax(most, A[0]);
        ms_sss_profile_destroy(p);
        ms_sss_profile_destroy(q);
        ms_mcml_profile_destroy(&walk);
    }
    CHECK(least < 0.12 && most > 0.93 && most < 0.95 && stated == 2);
    CHECK_LE(worst, 0.09); /* as the declaration says */
    TEST_NOTE("mean distance within %.1f%% for albedos of %.2f to %.2f", 100 * worst, least, most);
}

/* A kernel of any content is measured or refused: nothing outside of it is read, nothing overflows. */
static void measured_garbage(void)
{
    ms_sss_profile *p = burley_profile(0.4, 1, 2.5);
    ms_sss_designer *d = NULL;
    ms_sss_kernel good, k;
    ms_sss_errors e;
    uint64_t seed = test_seed;
    int i, refused = 0;
    CHECK_INT(ms_sss_designer_create(&d, p, 24, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_kernel_build(&good, d, NULL, NULL), MS_OK);
    for (i = 0; i < 200; ++i) {
        static const int counts[] = {-1, 0, 2, 8, 40, 257, 258, 601, 2147483647};
        static const float values[] = {NAN, INFINITY, -INFINITY, 1e7f, 3e38f, -0.5f};
        ms_status status;
        k = good;
        if (i % 4 == 0) k.tap_count = counts[test_random_u64(&seed) % 9];
        if (i % 4 == 1) k.term_count = counts[test_random_u64(&seed) % 9];
        if (i % 4 == 2) k.offset_mm[1 + test_random_u64(&seed) % 3] = values[test_random_u64(&seed) % 6];
        if (i % 4 == 3)
            k.weight[0][1 + test_random_u64(&seed) % 3][test_random_u64(&seed) % 3] =
                values[test_random_u64(&seed) % 6];
        e.texture = -7;
        status = ms_sss_kernel_measure(&e, &k, d);
        refused += status != MS_OK;
        CHECK(status == MS_OK ? e.texture >= 0 : e.texture < -6);
    }
    CHECK(refused > 140); /* all but those whose tap_count 257 or 40 terms happen to be valid */
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

/* Designs for any radius, below half a pixel too, by every model and placement: the filter takes each, and constants
   stay. */
static void small_designs(void)
{
    static const double radius[] = {0.01, 0.3, 0.49, 0.6, 1, 2.3};
    ms_sss_profile *p = burley_profile(1.2, 0.5, 0.3);
    int r, m, t;
    for (r = 0; r < 6; ++r) {
        ms_sss_designer *d = designer_for(p, radius[r]);
        for (m = 0; m < 9; ++m)
            for (t = 0; t < 4; ++t) {
                ms_sss_kernel_options o = ms_sss_kernel_defaults();
                ms_sss_filter_options by = ms_sss_filter_defaults();
                float light[8 * 8 * 3], out[8 * 8 * 3];
                ms_sss_kernel k;
                ms_sss_frame f;
                ms_error error;
                int i;
                o.model = (ms_sss_model)m;
                if (m == MS_SSS_IMAGE_OPTIMAL && t == 3) continue; /* it has no dense kernel */
                if (t == 3) o.tap_count = MS_SSS_DENSE;
                else o.placement = (ms_sss_placement)t;
                if (ms_sss_kernel_build(&k, d, &o, &error) != MS_OK) {
                    TEST_FAIL("radius %g, model %d, %d: %s", radius[r], m, t, error.message);
                    continue;
                }
                for (i = 0; i < 8 * 8 * 3; ++i) light[i] = 0.5f;
                memset(&f, 0, sizeof f);
                f.width = f.height = 8;
                f.input = ms_sss_interleaved(light, 3);
                f.output = ms_sss_interleaved(out, 3);
                by.pixels_per_mm[0] = 1;
                if (ms_sss_filter(&f, &k, 1, &by, NULL, 0, &error) != MS_OK)
                    TEST_FAIL("radius %g, model %d, %d: %s", radius[r], m, t, error.message);
                for (i = 0; i < 8 * 8 * 3 && m != MS_SSS_SVD; ++i) CHECK_NEAR(out[i], 0.5, 1e-6);
            }
        ms_sss_designer_destroy(d);
    }
    ms_sss_profile_destroy(p);
}

static void csv_files(void)
{
    static const struct {
        const char *text;
        size_t line;
        const char *message;
    } bad[] = {{"r_mm,R,G,B\n0.5,1,1\n1.5,1,1,1\n", 2, "not r_mm"},
               {"0.5,1,1,1\n1.5,1,1,1,1\n", 2, "not r_mm"},
               {"0.5,1,1,1\n0.5,1,1,1\n", 2, "increasing"},
               {"0.5,1,1,1\n1.5,1,-1,1\n", 2, "outside"},
               {"0.5,1,1,1\nnan,1,1,1\n", 2, "not r_mm"},
               {"0.5,1,1,1\n1.5,1e999,1,1\n", 2, "outside"},
               {"0.5,1,1,1\nr_mm,R,G,B\n", 2, "not r_mm"},
               {"0.5,1,1,1\n", 1, "at least 2"},
               {"0.5;1;1;1\n1;1;1\n", 2, "not r_mm"},
               {"", 0, "at least 2"},
               {"# only\n\n", 2, "at least 2"},
               {"0.5,1,1,1\n1.5,1,1,0x10\n", 2, "not r_mm"},
               {"0.5,1,1,1\n1.5,1,1,1e\n", 2, "not r_mm"},
               {"0.5,1,1,1\n1.5,1,1,\n", 2, "not r_mm"},
               {"-0.5,1,1,1\n1.5,1,1,1\n", 1, "increasing"}};
    static const char good[] =
        "# a comment, with 1,2,3,4\r\n\r\nr_mm,R,G,B\r\n 0.25 , 4e-1, .3,2.E-1\r\n0.75,0.2,0.15,+0.1\r\n1.25,0,0,0";
    ms_sss_profile *p;
    ms_error error;
    double v[3];
    size_t i;
    CHECK(profile_from_csv(&p, good, sizeof good - 1, &error) == MS_OK);
    ms_sss_profile_disc(p, 0.5, v); /* the middles 0.25, 0.75, 1.25 make rings 0, 0.5, 1, 1.5 */
    CHECK_NEAR(v[0], 0.4 * PI * 0.25, 1e-15);
    ms_sss_profile_reflectance(p, v);
    CHECK_NEAR(v[1], 0.3 * PI * 0.25 + 0.15 * PI * 0.75, 1e-15);
    ms_sss_profile_destroy(p);
    CHECK(profile_from_csv(&p, "0,2,2,2\n1,1,1,1\n3,0,0,0\n", 24, &error) == MS_OK); /* point samples */
    ms_sss_profile_value(p, 1, v);
    CHECK_NEAR(v[0], 1, 1e-15);
    ms_sss_profile_value(p, sqrt(0.5), v);
    CHECK_NEAR(v[0], 1.5, 1e-15);
    ms_sss_profile_destroy(p);
    CHECK(profile_from_csv(&p, "0,12345678901234567890123,1,1\n1,0.1,123456.789e-3,1e-5\n", 55, &error) == MS_OK);
    ms_sss_profile_value(p, 1 - 1e-13, v);
    CHECK_NEAR(v[1], 123.456789, 1e-9);
    ms_sss_profile_destroy(p);
    { /* as spreadsheets of many countries write it, behind a byte order mark; in UTF-16 */
        static const char commas[] = "\xEF\xBB\xBFr_mm;R;G;B\r\n0,25;4e-1;,3;0.2\r\n0,75;0,2;0,15;0,1\r\n1,25;0;0;0";
        CHECK(profile_from_csv(&p, commas, sizeof commas - 1, &error) == MS_OK);
        ms_sss_profile_reflectance(p, v);
        CHECK_NEAR(v[1], 0.3 * PI * 0.25 + 0.15 * PI * 0.75, 1e-15);
        ms_sss_profile_destroy(p);
        CHECK(profile_from_csv(&p,
                               "\xFF\xFE"
                               "0\0,\0",
                               6, &error) == MS_UNSUPPORTED &&
              strstr(error.message, "UTF-16") != NULL);
    }
    for (i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        ms_status status = profile_from_csv(&p, bad[i].text, strlen(bad[i].text), &error);
        if (status != MS_BAD_DATA || p != NULL || error.position != bad[i].line ||
            strstr(error.message, bad[i].message) == NULL)
            TEST_FAIL("file %d: status %d, line %d: %s", (int)i, (int)status, (int)error.position, error.message);
    }
    TEST_NOTE("%d malformed files", (int)(sizeof bad / sizeof bad[0]));
}

/* Against random walks through slabs. The profile is the rings of a walk below a plane, so that the decay comes from
   data with noise; 7%: what the header states. */
static void slab_transmits(const ms_sss_kernel *kernel, double thickness_mm, double out[3])
{
    const float front[3] = {0, 0, -1}, back[3] = {0, 0, 1}, light[3] = {1, 1, 1};
    float through[3];
    int c;
    ms_sss_transmission(kernel, (float)thickness_mm, front, back, back, light, through);
    for (c = 0; c < 3; ++c) out[c] = (double)(kernel->reflectance[c] * through[c]);
}

static void translucency(void)
{
    static const double albedo[3] = {0.98, 0.9, 0.7}, thickness[4] = {0.25, 1, 3, 8};
    static ball_tally plane, slab;
    const long walks = 100000;
    double edge[BALL_BINS + 1], ring[3][BALL_BINS], t[3], worst = 0;
    const double *value[3];
    float light[3] = {1, 2, 3}, out[3];
    ms_sss_profile *p;
    ms_sss_kernel k;
    int c, i;
    ball_walk(BALL_SPHERE, 0, 1, albedo, 3, walks, test_seed, &plane);
    for (i = 0; i <= BALL_BINS; ++i) edge[i] = ball_edge(i);
    for (c = 0; c < 3; ++c) {
        for (i = 0; i < BALL_BINS; ++i)
            ring[c][i] = plane.ring[c][i] / (PI * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]));
        value[c] = ring[c];
    }
    CHECK(ms_sss_profile_from_rings(&p, BALL_BINS, edge, value, 1, NULL, NULL) == MS_OK);
    CHECK(ms_sss_kernel_make(&k, NULL, p, 16, NULL, NULL, NULL) == MS_OK);
    for (i = 0; i < 4; ++i) {
        ball_walk(BALL_SLAB, 1 / thickness[i], 1, albedo, 3, walks, test_seed + 1, &slab);
        slab_transmits(&k, thickness[i], t);
        for (c = 0; c < 3; ++c) {
            if (slab.through[c] < 0.002) continue; /* 200 walks: noise */
            CHECK_NEAR(t[c] / slab.through[c], 1, 0.07 + 3 / sqrt((double)walks * slab.through[c]));
            worst = fmax(worst, fabs(t[c] / slab.through[c] - 1));
        }
    }
    for (i = 0; i < 65; ++i) { /* falls from 1, which is unscattered light */
        double next[3];
        slab_transmits(&k, 0.125 * i, t);
        slab_transmits(&k, 0.125 * (i + 1), next);
        for (c = 0; c < 3; ++c) {
            CHECK(next[c] < t[c]);
            if (i == 0) CHECK_NEAR(t[c], 1, 1e-6);
        }
    }
    /* nothing towards the lamp or from a far side in shade */
    for (i = 0; i < 2; ++i) { /* a slab lit askew; a wedge, whose faces stand at right angle, passes R of that */
        const float front[3] = {0, 0, -1}, side[3] = {0, 1, 0}, entry[3] = {0, 0, 1}, lamp[3] = {0, -0.6f, 0.8f},
                    away[3] = {0, 0.6f, -0.8f};
        ms_sss_transmission(&k, 8, i ? side : front, entry, lamp, light, out);
        for (c = 0; c < 3; ++c) CHECK_NEAR((double)(out[c] * (i ? 1 : k.reflectance[c])), t[c] * 0.8 * (c + 1), 1e-5);
        ms_sss_transmission(&k, 8, i ? side : front, entry, away, light, out); /* the entry lies in shade */
        CHECK(out[0] == 0 && out[1] == 0 && out[2] == 0);
        ms_sss_transmission(&k, 8, lamp, entry, lamp, light, out); /* the filter has it */
        CHECK(out[0] == 0 && out[1] == 0 && out[2] == 0);
        ms_sss_transmission(&k, NAN, i ? side : front, entry, lamp, light, out); /* an unknown thickness is dark */
        CHECK(out[0] == 0 && out[1] == 0 && out[2] == 0);
        ms_sss_transmission(&k, -1, i ? side : front, entry, lamp, light, out); /* below 0: as 0 */
        CHECK(out[0] > 0);
    }
    TEST_NOTE("within %.1f%% of random walks", 100 * worst);
    ms_sss_profile_destroy(p);
}

/* --- kernels against the study --- */

static ms_sss_errors built(ms_sss_kernel *kernel, const ms_sss_designer *d, const ms_sss_kernel_options *o)
{
    ms_sss_errors e;
    ms_error error;
    if (ms_sss_kernel_build(kernel, d, o, &error) != MS_OK) TEST_FAIL("kernel: %s", error.message);
    CHECK(ms_sss_kernel_measure(&e, kernel, d) == MS_OK);
    return e;
}

static ms_sss_kernel_options dense_model(ms_sss_model model, int terms)
{
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    o.model = model;
    o.term_count = terms;
    o.tap_count = MS_SSS_DENSE;
    o.no_delta = 1;
    return o;
}

/* The study's kernels on 65 x 65 cells, printed with 10 to 12 digits; ours are stored as float. */
static void reference_kernels(void)
{
    json *j = json_load("tests/data/sss_kernels.json");
    const json *channels = json_get(json_get(j, "deon_skin"), "channels");
    ms_sss_profile *skin = skin_profile();
    ms_sss_designer *d = designer_for(skin, 32);
    static ms_sss_kernel k;
    ms_sss_kernel_options o = dense_model(MS_SSS_PREINTEGRATED, 1);
    double ap = 0, svd = 0, residual = 0, guided = 0;
    int c, i, t, g;
    built(&k, d, &o);
    CHECK_NEAR((double)k.offset_mm[1], 0.170435227406572, 1e-7);
    CHECK_INT(k.tap_count, 65);
    for (c = 0; c < 3; ++c)
        for (i = 0; i <= 32; ++i)
            ap = fmax(ap,
                      fabs((double)k.weight[0][i][c] - json_number(&json_get(&channels->child[c], "ap")->child[i])));
    CHECK_LE(ap, 1e-7); /* float */
    o = dense_model(MS_SSS_SVD, 6);
    built(&k, d, &o);
    for (c = 0; c < 3; ++c)
        for (t = 0; t < 3; ++t) {
            const json *vec = &json_get(&channels->child[c], "vec")->child[t];
            double lambda = json_number(&json_get(&channels->child[c], "eig")->child[t]);
            for (i = 0; i <= 32; ++i)
                svd = fmax(svd, fabs((double)k.weight[t][i][c] - sqrt(fabs(lambda)) * json_number(&vec->child[i])));
            CHECK_NEAR(k.scale[t][c], lambda > 0 ? 1 : -1, 0);
        }
    CHECK_LE(svd, 1e-6); /* vectors printed with 10 digits, floats */
    o = dense_model(MS_SSS_RESIDUAL, 3);
    built(&k, d, &o);
    for (c = 0; c < 3; ++c)
        for (t = 0; t < 2; ++t) {
            double norm = 0, sum = 0;
            for (i = 0; i <= k.tap_count / 2; ++i) {
                norm += (i ? 2 : 1) * (double)k.weight[t + 1][i][c] * (double)k.weight[t + 1][i][c];
                sum += (i ? 2 : 1) * (double)k.weight[t + 1][i][c];
            }
            norm *= (double)k.scale[t + 1][c];
            residual = fmax(residual,
                            fabs(norm - json_number(&json_get(&channels->child[c], "residual_eig")->child[t])));
            CHECK_NEAR(sum, 0, 1e-6); /* exact on separable signals */
        }
    CHECK_LE(residual, 1e-6);
    for (g = 0; g <= 4; ++g) {
        o = dense_model(MS_SSS_GUIDED, 1);
        o.guide_k = g;
        built(&k, d, &o);
        for (c = 0; c < 3; ++c)
            for (i = 0; i <= 32; ++i)
                guided = fmax(guided,
                              fabs((double)k.weight[0][i][c] -
                                   json_number(&json_get(&channels->child[c], "guided")->child[g].child[i])));
    }
    CHECK_LE(guided, 0.02); /* where Gamma is tiny the study stopped at its iteration limit */
    TEST_NOTE("largest differences of weights: a_p %.1e, SVD %.1e, residual %.1e, guided %.1e", ap, svd, residual,
              guided);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(skin);
    json_free(j);
}

/* Every model of the study at R = 96. Signals without chance agree to the digits printed; the texture is another
   picture, within 5%. */
/* A two-Gaussian model (5.6): the near and the far one's sigma in mm, and the near one's share. */
typedef struct two_gaussians {
    double sigma_mm[2][3], near_share[3];
} two_gaussians;

/* The thesis's table 5.2: the fit to d'Eon's skin, and the look that an artist chose. */
static const two_gaussians close_fit = {{{0.034, 0.029, 0.016}, {1, 0.48, 0.2}}, {0.37, 0.37, 0.37}};
static const two_gaussians production = {{{0.25, 0.08, 0.02}, {1, 0.3, 0.05}}, {0.6, 0.6, 0.6}};

/* The kernel of a two-Gaussian model by its own profile, with d's cells. */
static ms_sss_errors artist_errors(const two_gaussians *a, const ms_sss_designer *d)
{
    const ms_sss_kernel_options o = dense_model(MS_SSS_PREINTEGRATED, 1);
    static ms_sss_kernel k;
    double weight[2][3], radius[3];
    ms_sss_designer *own;
    ms_sss_profile *p;
    ms_sss_errors e;
    int c;
    for (c = 0; c < 3; ++c) {
        weight[0][c] = a->near_share[c];
        weight[1][c] = 1 - a->near_share[c];
    }
    CHECK_INT(ms_sss_profile_from_gaussians(&p, 2, a->sigma_mm, (const double(*)[3])weight, NULL, NULL), MS_OK);
    ms_sss_kernel_build(&k, d, &o, NULL);
    ms_sss_profile_radius(p, 0.99, radius);
    own = designer_for(p, fmax(radius[0], fmax(radius[1], radius[2])) / (double)k.offset_mm[1] - 0.5);
    CHECK_INT(ms_sss_kernel_build(&k, own, &o, NULL), MS_OK);
    CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_OK);
    ms_sss_designer_destroy(own);
    ms_sss_profile_destroy(p);
    return e;
}

/* The part of a Gaussian that cell i holds. */
static double gaussian_cell(double sigma_mm, double cell_mm, int i)
{
    const double unit = cell_mm / (sigma_mm * sqrt(2.0));
    return 0.5 * (erf((i + 0.5) * unit) - erf((i - 0.5) * unit));
}

static void reference_errors(void)
{
    static const struct {
        const char *name;
        ms_sss_model model;
        int terms;
        int better;     /* at most the study's error: it stopped short of the optimum, or had no weight on the input */
        double texture; /* tolerance there: 5% in design.md's table as the issue asks, else that of another picture */
    } row[] = {{"radial_slice_(iryoku_code,strength1)", MS_SSS_SLICE, 1, 0, 0.05},
               {"sog1", MS_SSS_GAUSSIANS, 1, 0, 0.05},
               {"svd1_norm", MS_SSS_SVD_NORMALIZED, 1, 0, 0.05},
               {"preint", MS_SSS_PREINTEGRATED, 1, 0, 0.05},
               {"img_rank1", MS_SSS_IMAGE_OPTIMAL, 1, 1, 0.05},
               {"svd2_norm", MS_SSS_SVD_NORMALIZED, 2, 0, 0.05},
               {"preint+res1", MS_SSS_RESIDUAL, 2, 0, 0.05},
               {"sog6", MS_SSS_GAUSSIANS, 6, 1, 0.05},
               {"svd3_norm", MS_SSS_SVD_NORMALIZED, 3, 0, 0.08},
               {"svd4_norm", MS_SSS_SVD_NORMALIZED, 4, 0, 0.08},
               {"preint+res2", MS_SSS_RESIDUAL, 3, 0, 0.08},
               {"sog2", MS_SSS_GAUSSIANS, 2, 1, 0.08},
               {"sog3", MS_SSS_GAUSSIANS, 3, 1, 0.08},
               {"sog4", MS_SSS_GAUSSIANS, 4, 1, 0.08},
               {"artist_LSfit_to_ap", MS_SSS_ARTIST, 1, 0, 0.08},
               {"artist_close_mm", MS_SSS_PREINTEGRATED, 1, 0, 0.08},
               {"artist_production_mm", MS_SSS_PREINTEGRATED, 1, 0, 0.08},
               {"guided_k0", MS_SSS_GUIDED, 1, 0, 0.08}};
    json *j = json_load("tests/data/sss_errors_deon_skin.json");
    const json *models = json_get(json_get(j, "deon_skin"), "models");
    ms_sss_profile *skin = skin_profile();
    ms_sss_designer *d = designer_for(skin, 96);
    static ms_sss_kernel k;
    const ms_sss_kernel_options artist = dense_model(MS_SSS_ARTIST, 1);
    double worst = 0, worst_texture = 0, off_artist = 0;
    size_t n;
    int c, i;
    for (n = 0; n < sizeof row / sizeof row[0]; ++n) {
        const json *err = json_get(json_get(models, row[n].name), "err");
        const char *const signal[3] = {"vstep", "dstep", "natural_1f"};
        ms_sss_kernel_options o = dense_model(row[n].model, row[n].terms);
        ms_sss_errors e;
        double found[3];
        int s;
        if (row[n].model == MS_SSS_IMAGE_OPTIMAL) o.tap_count = 33, o.no_delta = 0; /* the study: a tap every cell */
        if (strcmp(row[n].name, "artist_close_mm") == 0) e = artist_errors(&close_fit, d);
        else if (strcmp(row[n].name, "artist_production_mm") == 0) e = artist_errors(&production, d);
        else e = built(&k, d, &o);
        found[0] = e.vertical_step;
        found[1] = e.diagonal_step;
        found[2] = e.texture;
        for (s = 0; s < 3; ++s) {
            double expected = json_number(&json_get(err, signal[s])->child[0]);
            double tolerance = s < 2 ? 0.05 : row[n].texture;
            /* 1e-6: weights are floats */
            if (found[s] > (1 + tolerance) * expected + 1e-6 ||
                (!row[n].better && found[s] < (1 - tolerance) * expected - 1e-6))
                TEST_FAIL("%s, %s: %.5f, study %.5f", row[n].name, signal[s], found[s], expected);
            if (!row[n].better && expected > 1e-6) {
                double off = fabs(found[s] / expected - 1);
                if (s < 2) worst = fmax(worst, off);
                else worst_texture = fmax(worst_texture, off);
            }
        }
    }
    TEST_NOTE("%d models: steps within %.2f%%, texture within %.1f%%", (int)n, 100 * worst, 100 * worst_texture);
    CHECK_INT(ms_sss_kernel_build(&k, d, &artist, NULL), MS_OK);
    for (c = 0; c < 3; ++c) { /* the study's parameters, printed with 5 digits, from its own few starts */
        const json *fit = &json_get(json_get(json_get(j, "deon_skin"), "info"),
                                    "artist_fit_to_ap_[sigma_n_mm,sigma_f_mm,w]")
                               ->child[c];
        const double near_mm = json_number(&fit->child[0]), far_mm = json_number(&fit->child[1]);
        const double share = json_number(&fit->child[2]), cell_mm = (double)k.offset_mm[1];
        for (i = 0; i <= k.tap_count / 2; ++i) {
            const double expected = share * gaussian_cell(near_mm, cell_mm, i) +
                (1 - share) * gaussian_cell(far_mm, cell_mm, i);
            off_artist = fmax(off_artist, fabs((double)k.weight[0][i][c] - expected));
        }
    }
    CHECK_LE(off_artist, 1e-3); /* parameters from other starts, which agree within 1%, move weights by as much */
    TEST_NOTE("the fitted artist's weights within %.1e of the study's parameters", off_artist);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(skin);
    json_free(j);
}

/* The study's own taps, measured by us: its weights sum to 1 and are scaled by 1 - delta. */
static void reference_taps(void)
{
    json *j = json_load("tests/data/sss_taps_deon_skin_96.json");
    const char *const set[2] = {"R96", "R24"}, *const taps[3] = {"7", "11", "17"},
                      *const kind[2] = {"imgopt", "imgopt+delta"};
    ms_sss_profile *skin = skin_profile();
    static ms_sss_kernel k;
    double steps = 0, texture = 0, gain = 1e9, lose = 0;
    int r, n, m, c, i;
    for (r = 0; r < 2; ++r) {
        ms_sss_designer *d = designer_for(skin, r == 0 ? 96 : 24);
        double cell = 5.5391448907136 / (r == 0 ? 96.5 : 24.5);
        for (n = 0; n < 3; ++n)
            for (m = 0; m < 2; ++m) {
                const json *entry = json_get(
                    json_get(json_get(json_get(json_get(j, "deon_skin"), set[r]), taps[n]), kind[m]), "taps");
                const json *err = json_get(
                    json_get(json_get(json_get(json_get(json_get(j, "deon_skin"), set[r]), taps[n]), kind[m]), "err"),
                    "natural_1f");
                const json *all = json_get(
                    json_get(json_get(json_get(json_get(j, "deon_skin"), set[r]), taps[n]), kind[m]), "err");
                ms_sss_kernel_options o = ms_sss_kernel_defaults();
                ms_sss_errors e, ours;
                memset(&k, 0, sizeof k);
                k.tap_count = 2 * json_get(entry, "offset_px")->count + 1;
                k.term_count = 1;
                for (c = 0; c < 3; ++c) {
                    k.delta[c] = (float)json_number(&json_get(entry, "wdelta")->child[c]);
                    k.scale[0][c] = 1;
                    for (i = 0; i <= k.tap_count / 2; ++i) {
                        if (i > 0) k.offset_mm[i] = (float)(cell * json_get(entry, "offset_px")->child[i - 1].number);
                        k.weight[0][i][c] = (float)(sqrt(1 - (double)k.delta[c]) *
                                                    json_get(entry, "w")->child[c].child[i].number);
                    }
                }
                k.radius_mm = k.offset_mm[k.tap_count / 2];
                CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_OK);
                steps = fmax(steps, fabs(e.vertical_step / json_number(&json_get(all, "vstep")->child[0]) - 1));
                steps = fmax(steps, fabs(e.diagonal_step / json_number(&json_get(all, "dstep")->child[0]) - 1));
                texture = fmax(texture, fabs(e.texture / json_number(&err->child[0]) - 1));
                o.tap_count = k.tap_count;
                o.no_delta = m == 0;
                ours = built(&k, d, &o);
                CHECK_LE(ours.texture, 1.03 * e.texture); /* descents from other starts may end a little higher */
                gain = fmin(gain, ours.texture / e.texture);
                lose = fmax(lose, ours.texture / e.texture);
            }
        ms_sss_designer_destroy(d);
    }
    CHECK_LE(steps, 0.01);   /* offsets and weights printed with 5 digits */
    CHECK_LE(texture, 0.05); /* another picture with the same statistics */
    TEST_NOTE("12 sets: steps within %.2f%%, texture within %.1f%%; our texture errors are %.2f to %.2f of theirs",
              100 * steps, 100 * texture, gain, lose);
    ms_sss_profile_destroy(skin);
    json_free(j);
}

/* What the project set out to beat: the thesis's quadratic spacing at equal cost. */
static void targets(void)
{
    ms_sss_profile *skin = skin_profile();
    ms_sss_designer *near_view = designer_for(skin, 96), *far_view = designer_for(skin, 24);
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    static ms_sss_kernel k;
    double a, b, quadratic;
    a = built(&k, far_view, &o).texture;
    CHECK_LE(a, 0.032);
    o.tap_count = 17;
    b = built(&k, near_view, &o).texture;
    CHECK_LE(b, 0.050);
    o = ms_sss_kernel_defaults();
    o.model = MS_SSS_PREINTEGRATED;
    o.placement = MS_SSS_QUADRATIC;
    quadratic = built(&k, far_view, &o).texture;
    CHECK_LE(a, quadratic);
    TEST_NOTE("7 taps R 24: %.2f%% (a_p, quadratic: %.2f%%); 17 taps R 96: %.2f%%", 100 * a, 100 * quadratic, 100 * b);
    ms_sss_designer_destroy(near_view);
    ms_sss_designer_destroy(far_view);
    ms_sss_profile_destroy(skin);
}

/* --- kernels against plain convolution --- */

enum { SIDE = 64 };

/* K by midpoint quadrature within each cell: independent of rings, areas and spectra. */
static double true_cell(const ms_sss_profile *p, double h, int x, int y, int c)
{
    double sum = 0, v[3];
    int i, j;
    for (i = 0; i < 8; ++i)
        for (j = 0; j < 8; ++j) {
            double u = (x + (i + 0.5) / 8 - 0.5) * h, w = (y + (j + 0.5) / 8 - 0.5) * h;
            ms_sss_profile_value(p, sqrt(u * u + w * w), v);
            sum += v[c];
        }
    return sum * h * h / 64;
}

static double at_linear(const double *image, double x, double y) /* periodic */
{
    int i = (int)floor(x), j = (int)floor(y), i1 = (i + 1) & (SIDE - 1), j1 = (j + 1) & (SIDE - 1);
    double f = x - i, g = y - j;
    i &= SIDE - 1;
    j &= SIDE - 1;
    return (1 - g) * ((1 - f) * image[j * SIDE + i] + f * image[j * SIDE + i1]) +
        g * ((1 - f) * image[j1 * SIDE + i] + f * image[j1 * SIDE + i1]);
}

static void filter_plain(const ms_sss_kernel *k, double cell, const double *in, int c, double turn, double *out)
{
    static double pass[SIDE * SIDE];
    int x, y, i, t;
    for (y = 0; y < SIDE * SIDE; ++y) out[y] = (double)k->delta[c] * in[y];
    for (t = 0; t < k->term_count; ++t) {
        for (y = 0; y < SIDE; ++y)
            for (x = 0; x < SIDE; ++x) {
                double sum = 0;
                for (i = 0; i < k->tap_count; ++i) {
                    double o = (i % 2 ? -1 : 1) * (double)k->offset_mm[(i + 1) / 2] / cell;
                    sum += (double)k->weight[t][(i + 1) / 2][c] * at_linear(in, x + o * cos(turn), y + o * sin(turn));
                }
                pass[y * SIDE + x] = sum;
            }
        for (y = 0; y < SIDE; ++y)
            for (x = 0; x < SIDE; ++x) {
                double sum = 0;
                for (i = 0; i < k->tap_count; ++i) {
                    double o = (i % 2 ? -1 : 1) * (double)k->offset_mm[(i + 1) / 2] / cell;
                    sum += (double)k->weight[t][(i + 1) / 2][c] * at_linear(pass, x - o * sin(turn), y + o * cos(turn));
                }
                out[y * SIDE + x] += (double)k->scale[t][c] * sum;
            }
    }
}

static void convolve_plain(const ms_sss_profile *p, double cell, int reach, const double *in, int c, double *out)
{
    static double K[SIDE * SIDE];
    double total = 0;
    int x, y, i, j, row = 2 * reach + 1;
    for (j = -reach; j <= reach; ++j)
        for (i = -reach; i <= reach; ++i) total += K[(j + reach) * row + i + reach] = true_cell(p, cell, i, j, c);
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < SIDE; ++x) {
            double sum = 0;
            for (j = -reach; j <= reach; ++j)
                for (i = -reach; i <= reach; ++i)
                    sum += K[(j + reach) * row + i + reach] *
                        in[((y + j) & (SIDE - 1)) * SIDE + ((x + i) & (SIDE - 1))];
            out[y * SIDE + x] = sum / total;
        }
}

/* A smooth profile, so that midpoints are good to 1e-4 of it. */
static void separable_signals(void)
{
    static double in[SIDE * SIDE], right[SIDE * SIDE], ours[SIDE * SIDE];
    static ms_sss_kernel k;
    double sigma[2][3] = {{1, 0.8, 0.6}, {2.5, 2, 1.5}}, weight[2][3] = {{0.6, 0.5, 0.4}, {0.4, 0.5, 0.6}}, worst = 0,
           rest = 0, cell;
    ms_sss_kernel_options o = dense_model(MS_SSS_PREINTEGRATED, 1);
    ms_sss_profile *p;
    ms_sss_designer *d;
    uint64_t random = test_seed;
    double e1[SIDE], e2[SIDE];
    int i, c;
    CHECK(ms_sss_profile_from_gaussians(&p, 2, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL) ==
          MS_OK);
    d = designer_for(p, 10);
    for (i = 0; i < SIDE; ++i) {
        e1[i] = test_uniform(&random);
        e2[i] = test_uniform(&random);
    }
    for (i = 0; i < SIDE * SIDE; ++i) in[i] = e1[i % SIDE] + e2[i / SIDE];
    built(&k, d, &o);
    cell = (double)k.offset_mm[1];
    for (c = 0; c < 3; ++c) {
        convolve_plain(p, cell, 10, in, c, right);
        filter_plain(&k, cell, in, c, 0, ours);
        for (i = 0; i < SIDE * SIDE; ++i) worst = fmax(worst, fabs(ours[i] - right[i]));
    }
    o = dense_model(MS_SSS_RESIDUAL, 4);
    built(&k, d, &o);
    for (c = 0; c < 3; ++c) {
        convolve_plain(p, cell, 10, in, c, right);
        filter_plain(&k, cell, in, c, 0, ours);
        for (i = 0; i < SIDE * SIDE; ++i) rest = fmax(rest, fabs(ours[i] - right[i]));
    }
    CHECK_LE(worst, 2e-4); /* the midpoint rule of the reference */
    CHECK_LE(rest, 2e-4);
    TEST_NOTE("E1(x) + E2(y): a_p within %.1e, with three residual terms %.1e", worst, rest);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

/* What ms_sss_kernel_measure says of a dot, against a plain convolution of a dot: the picture is larger than
   kernels. */
static void measured_errors(void)
{
    static double in[SIDE * SIDE], right[SIDE * SIDE], ours[SIDE * SIDE];
    static ms_sss_kernel k;
    ms_sss_kernel_options o[2];
    ms_sss_profile *p;
    ms_sss_designer *d;
    double sigma[2][3] = {{1, 0.8, 0.6}, {2.5, 2, 1.5}}, weight[2][3] = {{0.6, 0.5, 0.4}, {0.4, 0.5, 0.6}}, cell;
    int n, c, i;
    CHECK(ms_sss_profile_from_gaussians(&p, 2, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL) ==
          MS_OK);
    d = designer_for(p, 10);
    o[0] = dense_model(MS_SSS_PREINTEGRATED, 1);
    built(&k, d, &o[0]);
    cell = (double)k.offset_mm[1];
    o[0] = ms_sss_kernel_defaults();
    o[1] = o[0];
    o[1].model = MS_SSS_RESIDUAL;
    o[1].tap_count = 9;
    memset(in, 0, sizeof in);
    in[SIDE / 2 * SIDE + SIDE / 2] = 1;
    for (n = 0; n < 2; ++n) {
        ms_sss_errors e = built(&k, d, &o[n]);
        double square = 0, variance = 0, found;
        for (c = 0; c < 3; ++c) {
            convolve_plain(p, cell, 10, in, c, right);
            filter_plain(&k, cell, in, c, 0, ours);
            for (i = 0; i < SIDE * SIDE; ++i) {
                square += (ours[i] - right[i]) * (ours[i] - right[i]);
                variance += right[i] * right[i];
            }
            variance -= 1.0 / (512 * 512); /* the mean, of 512 x 512 pixels */
        }
        found = sqrt(square / variance);
        CHECK_NEAR(e.dot, found, 0.01 * found + 1e-4); /* the reference's midpoint rule */
        TEST_NOTE("dot, kernel %d: %.4f, plain %.4f", n, e.dot, found);
    }
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

/* --- properties --- */

static void check_kernel(const ms_sss_kernel *k, ms_sss_model model, const char *what)
{
    int c, t, i;
    for (c = 0; c < 3; ++c) {
        double energy = (double)k->delta[c];
        for (t = 0; t < k->term_count; ++t) {
            double sum = 0;
            for (i = 0; i <= k->tap_count / 2; ++i) sum += (i ? 2 : 1) * (double)k->weight[t][i][c];
            energy += (double)k->scale[t][c] * sum * sum;
        }
        if (!(fabs(energy - 1) < 1e-6) && !(model == MS_SSS_SVD && energy < 1)) /* float weights */
            TEST_FAIL("%s: energy %.9f in channel %d", what, energy, c);
        if (k->delta[c] < 0 || !(k->delta[c] <= 1)) TEST_FAIL("%s: delta %g", what, (double)k->delta[c]);
    }
    if (k->tap_count % 2 == 0 || k->offset_mm[0] != 0) TEST_FAIL("%s: no center", what);
    for (i = 1; i <= k->tap_count / 2; ++i)
        if (!(k->offset_mm[i] > 0 && k->offset_mm[i] >= k->offset_mm[i - 1])) TEST_FAIL("%s: order of %d", what, i);
    if (!(k->radius_mm >= k->offset_mm[k->tap_count / 2])) TEST_FAIL("%s: radius %g", what, (double)k->radius_mm);
}

/* All models and placements on hard profiles: a channel 45 times as wide as another, an empty channel, poles, noise. */
static void every_model(void)
{
    static ms_sss_kernel k;
    ms_sss_profile *profile[4];
    double reflectance[3] = {0.145, 0.0053, 0}, widths[3] = {4, 0.089, 1};
    int n, m, placement, built_count = 0;
    profile[0] = skin_profile();
    CHECK(ms_sss_profile_from_burley(&profile[1], reflectance, widths, NULL, NULL) == MS_OK);
    profile[2] = rings_of(profile[0], 300, 9, 0.5);
    profile[3] = gaussian_profile(1e-6);
    for (n = 0; n < 4; ++n) {
        ms_sss_designer *d = designer_for(profile[n], n == 1 ? 40 : 12);
        for (m = 0; m <= (int)MS_SSS_SLICE; ++m)
            for (placement = 0; placement < 4; ++placement) {
                ms_sss_kernel_options o = ms_sss_kernel_defaults();
                ms_sss_errors e;
                char what[64];
                if (m == MS_SSS_IMAGE_OPTIMAL && placement == 3) continue; /* it has no dense kernel */
                o.model = (ms_sss_model)m;
                o.guide_k = 1.5;
                o.term_count = m == MS_SSS_SVD || m == MS_SSS_GAUSSIANS ? 3 : 0;
                if (placement == 3) o.tap_count = MS_SSS_DENSE;
                else o.placement = (ms_sss_placement)placement;
                sprintf(what, "profile %d, model %d, placement %d", n, m, placement);
                e = built(&k, d, &o);
                check_kernel(&k, o.model, what);
                if (!(e.texture >= 0 && e.texture < (m == MS_SSS_SVD ? 10 : 1.2)))
                    TEST_FAIL("%s: texture error %g", what, e.texture);
                if (n == 1 && !(k.weight[0][0][2] == 1 && k.delta[2] == 0))
                    TEST_FAIL("%s: empty channel is not the identity", what);
                ++built_count;
            }
        ms_sss_designer_destroy(d);
        ms_sss_profile_destroy(profile[n]);
    }
    TEST_NOTE("%d kernels", built_count);
}

/* Rings with gaps, whose kernels have eigenvalues of both signs: no model turns a constant into more than itself. The
   SVD without a bound reached 4 times. */
static void no_gain(void)
{
    static ms_sss_kernel k;
    uint64_t seed = test_seed;
    int n, i, c;
    for (n = 0; n < (test_full ? 2000 : 120); ++n) {
        double edge[13], rd[3][12];
        const double *const value[3] = {rd[0], rd[1], rd[2]};
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        ms_sss_profile *p;
        char what[64];
        edge[0] = test_uniform(&seed) < 0.3 ? 0.2 : 0;
        for (i = 0; i < 12; ++i) {
            edge[i + 1] = edge[i] + 0.02 + test_uniform(&seed);
            for (c = 0; c < 3; ++c) rd[c][i] = test_uniform(&seed) < 0.3 ? 0 : exp(-edge[i] * (1 + c));
        }
        CHECK_INT(ms_sss_profile_from_rings(&p, 12, edge, value, 1, NULL, NULL), MS_OK);
        o.model = n % 2 ? MS_SSS_SVD : (ms_sss_model)(n / 2 % 9);
        o.placement = n % 8 ? MS_SSS_QUANTILE : MS_SSS_OPTIMIZED; /* whose fits take most of the time */
        o.term_count = 1 + (int)((n % 8 ? 6 : 2) * test_uniform(&seed));
        o.tap_count = n % 3 || o.model == MS_SSS_IMAGE_OPTIMAL ? 3 + 2 * (int)(7 * test_uniform(&seed)) : MS_SSS_DENSE;
        CHECK_INT(ms_sss_kernel_make(&k, NULL, p, 1 + 20 * test_uniform(&seed), &o, NULL, NULL), MS_OK);
        sprintf(what, "random rings %d, model %d", n, (int)o.model);
        check_kernel(&k, o.model, what);
        ms_sss_profile_destroy(p);
    }
}

/* Unknowns that change nothing: more terms than taps can tell apart, weights that begin at 0. Fits went 1e6 along them,
   where floats keep nothing of a sum of 1 (6 of these 60 kernels), or stayed where they began: the texture's errors in %
   were 6.1 and 4.2; half as much again is for compilers that round otherwise and end elsewhere. */
static void idle_unknowns(void)
{
    static const struct {
        double reflectance[3], sigma[2][3], radius;
        ms_sss_model model;
        int taps, terms;
        double texture;
    } row[3] = {
        {{0.5, 0.394, 0.373}, {{0.182, 6.33, 1.212}, {6.87, 3.29, 5.02}}, 11.4, MS_SSS_SVD_NORMALIZED, 5, 4, 3.6},
        {{0.5, 0.051, 0.245}, {{2.17, 0.476, 0.641}, {0.191, 4.26, 1.92}}, 2.38, MS_SSS_SVD_NORMALIZED, 17, 3, 0.011},
        {{0.5, 0.029, 0.445}, {{5.95, 0.345, 0.279}, {0.118, 0.115, 0.206}}, 3.95, MS_SSS_RESIDUAL, 15, 2, 0.002}};
    static ms_sss_kernel k;
    uint64_t seed = 7;
    double most = 0;
    int n, t, i, c;
    for (n = 0; n < 63; ++n) {
        double sigma[2][3], weight[2][3], radius = pow(20, test_uniform(&seed));
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        ms_sss_profile *p;
        ms_sss_errors e;
        for (i = 0; i < 2; ++i)
            for (c = 0; c < 3; ++c) {
                sigma[i][c] = pow(0.01, test_uniform(&seed));
                weight[i][c] = c == n % 5 ? 0 : 0.2;
            }
        o.model = MS_SSS_SVD_NORMALIZED;
        o.tap_count = 3 + 4 * (n % 3 / 2);
        o.term_count = 4 + n / 2 % 3;
        if (n >= 60) {
            for (i = 0; i < 2; ++i)
                for (c = 0; c < 3; ++c) {
                    sigma[i][c] = row[n - 60].sigma[i][c];
                    weight[i][c] = row[n - 60].reflectance[c] / 2;
                }
            o.model = row[n - 60].model;
            o.tap_count = row[n - 60].taps;
            o.term_count = row[n - 60].terms;
            radius = row[n - 60].radius;
        }
        CHECK_INT(
            ms_sss_profile_from_gaussians(&p, 2, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL),
            MS_OK);
        CHECK_INT(ms_sss_kernel_make(&k, n < 60 ? NULL : &e, p, radius, &o, NULL, NULL), MS_OK);
        check_kernel(&k, o.model, "idle unknowns");
        for (t = 0; t < k.term_count; ++t)
            for (i = 0; i <= k.tap_count / 2; ++i)
                for (c = 0; c < 3; ++c) most = fmax(most, fabs((double)k.weight[t][i][c]));
        if (n >= 60) CHECK_LE(100 * e.texture, 1.5 * row[n - 60].texture);
        ms_sss_profile_destroy(p);
    }
    CHECK_LE(most, 10);
    TEST_NOTE("weights up to %.2f", most);
}

/* More taps than a small radius has pixels: fits got stuck along the idle ones, up to 8% above those of fewer taps. A
   local minimum may still lie by a twentieth and 0.7% above another count's, rarely (24 of 2,400 by more than a twentieth
   and 0.01%, by up to 0.46%). */
static void more_taps(void)
{
    static const int taps[] = {3, 5, 7, 9, 13, 17, 33};
    static ms_sss_kernel k;
    uint64_t seed = test_seed;
    int n, i, c, above = 0, cases = test_full ? 400 : 40;
    double worst = 0;
    for (n = 0; n < cases; ++n) {
        const double radius = 0.5 * pow(16, test_uniform(&seed));
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        double reflectance[3], length[3][3], weight[3][3], least = HUGE_VAL;
        ms_sss_profile *p;
        ms_sss_designer *d;
        for (c = 0; c < 3; ++c) {
            reflectance[c] = 0.05 + 0.9 * test_uniform(&seed);
            for (i = 0; i < 3; ++i) {
                length[i][c] = 0.1 * pow(100, test_uniform(&seed));
                weight[i][c] = reflectance[c] * test_uniform(&seed);
            }
        }
        if (n % 2) CHECK_INT(ms_sss_profile_from_burley(&p, reflectance, length[0], NULL, NULL), MS_OK);
        else
            CHECK_INT(ms_sss_profile_from_gaussians(&p, 1 + n / 2 % 3, (const double(*)[3])length,
                                                    (const double(*)[3])weight, NULL, NULL),
                      MS_OK);
        d = designer_for(p, radius);
        o.no_delta = n % 5 == 0;
        o.model = n % 8 == 7 ? MS_SSS_SVD_NORMALIZED : MS_SSS_IMAGE_OPTIMAL;
        o.term_count = n % 8 == 7 ? 2 : 1;
        for (i = 0; i < 7; ++i) {
            ms_sss_errors e;
            o.tap_count = taps[i];
            e = built(&k, d, &o);
            CHECK(k.tap_count <= taps[i] && (k.tap_count == taps[i] || k.tap_count / 2 >= radius - 0.51));
            worst = fmax(worst, e.texture - 1.05 * least);
            above += e.texture > 1.05 * least + 1e-4;
            least = fmin(least, e.texture);
        }
        ms_sss_designer_destroy(d);
        ms_sss_profile_destroy(p);
    }
    CHECK_LE(worst, 7e-3);
    CHECK_LE((double)above, 0.2 * cases); /* of 6 times as many kernels; 300 were, of 400 cases */
    TEST_NOTE("%d of %d above, by up to %.2f%%", above, 6 * cases, 100 * worst);
}

static void radii(void)
{
    static const double radius[] = {0.01, 0.5, 1, 3.3, 128, 1e4, 1e9};
    static ms_sss_kernel k;
    ms_sss_profile *skin = skin_profile();
    size_t n;
    int model;
    for (n = 0; n < sizeof radius / sizeof radius[0]; ++n) {
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        ms_sss_errors e;
        ms_sss_designer *d = designer_for(skin, radius[n]);
        e = built(&k, d, &o);
        check_kernel(&k, MS_SSS_IMAGE_OPTIMAL, "radius");
        CHECK(e.texture < (radius[n] <= 3.3 ? 0.02 : 0.2));
        o.tap_count = MS_SSS_DENSE;
        for (model = MS_SSS_PREINTEGRATED; model <= (int)MS_SSS_SLICE; ++model) {
            if (model > MS_SSS_PREINTEGRATED && radius[n] < 1e8) break; /* the others with full arrays */
            o.model = (ms_sss_model)model;
            o.term_count = model >= (int)MS_SSS_RESIDUAL && model <= (int)MS_SSS_GAUSSIANS ? 2 : 1;
            built(&k, d, &o);
            check_kernel(&k, o.model, "dense radius");
        }
        ms_sss_designer_destroy(d);
    }
    ms_sss_profile_destroy(skin);
}

static void dial(void)
{
    static ms_sss_kernel k;
    ms_sss_profile *skin = skin_profile();
    ms_sss_designer *d = designer_for(skin, 48);
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    double step = 1e9, texture = 0;
    int i;
    o.tap_count = 33;
    o.no_delta = 1;
    for (i = 0; i <= 4; ++i) {
        ms_sss_errors e;
        o.dial = 0.25 * i;
        e = built(&k, d, &o);
        CHECK(e.vertical_step < step + 1e-9 && e.texture > texture - 1e-4);
        step = e.vertical_step;
        texture = e.texture;
    }
    o.model = MS_SSS_PREINTEGRATED;
    CHECK_NEAR(step / built(&k, d, &o).vertical_step, 1, 0.2); /* at 1 it is a_p: two descents to the same minimum */
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(skin);
}

static void cheapest(void)
{
    static ms_sss_kernel k, untouched;
    ms_sss_profile *skin = skin_profile();
    ms_sss_designer *d = designer_for(skin, 24);
    const double tolerance[4] = {0.2, 0.05, 0.02, 0.01};
    ms_sss_errors e;
    ms_error error;
    int n, before = 0;
    for (n = 0; n < 4; ++n) {
        CHECK(choose_kernel(&k, &e, d, tolerance[n], 66, NULL, &error) == MS_OK);
        CHECK_LE(e.texture, tolerance[n]);
        CHECK(k.tap_count * k.term_count >= before);
        before = k.tap_count * k.term_count;
        TEST_NOTE("%.0f%%: %d x %d", 100 * tolerance[n], k.term_count, k.tap_count);
    }
    CHECK(choose_kernel(&k, &e, d, 1e-6, 7, NULL, &error) == MS_NOT_CONVERGED);
    CHECK(k.tap_count * k.term_count <= 7 && e.texture < 0.05);
    CHECK(strstr(error.message, "7 taps") != NULL);
    memset(&untouched, 7, sizeof untouched);
    k = untouched;
    CHECK(choose_kernel(&k, &e, d, 0, 7, NULL, &error) == MS_INVALID_ARGUMENT);
    CHECK(choose_kernel(&k, &e, d, 0.1, 2, NULL, &error) == MS_INVALID_ARGUMENT);
    CHECK(memcmp(&k, &untouched, sizeof k) == 0);
    CHECK(ms_sss_kernel_measure(NULL, &k, d) == MS_INVALID_ARGUMENT &&
          ms_sss_kernel_measure(&e, &k, NULL) == MS_INVALID_ARGUMENT);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(skin);
}

static void refused_options(void)
{
    static ms_sss_kernel k, untouched;
    double edge[2] = {0, 1}, dark[1] = {0};
    const double *value[3];
    ms_sss_profile *skin = skin_profile(), *black;
    ms_sss_designer *d = designer_for(skin, 8), *none = d;
    ms_sss_kernel_options o[11];
    const char *const word[11] = {"tap_count", "tap_count", "tap_count", "term_count", "term_count",  "dial",
                                  "dial",      "guide_k",   "model",     "placement",  "MS_SSS_DENSE"};
    ms_error error;
    int i;
    for (i = 0; i < 11; ++i) o[i] = ms_sss_kernel_defaults();
    o[0].tap_count = 8;
    o[1].tap_count = 35;
    o[2].tap_count = -3;
    o[3].term_count = 7;
    o[4].term_count = -1;
    o[5].dial = 1.5;
    o[6].dial = sqrt(-1.0);
    o[7].guide_k = 5;
    o[8].model = (ms_sss_model)9;
    o[9].placement = (ms_sss_placement)3;
    o[10].tap_count = MS_SSS_DENSE;
    memset(&untouched, 5, sizeof untouched);
    k = untouched;
    for (i = 0; i < 11; ++i) {
        CHECK(ms_sss_kernel_build(&k, d, &o[i], &error) == MS_INVALID_ARGUMENT);
        if (strstr(error.message, word[i]) == NULL) TEST_FAIL("options %d: %s", i, error.message);
    }
    CHECK(memcmp(&k, &untouched, sizeof k) == 0);
    ms_sss_designer_destroy(d);
    CHECK(ms_sss_designer_create(&none, skin, -1, NULL, &error) == MS_INVALID_ARGUMENT && none == NULL);
    CHECK(ms_sss_designer_create(&none, skin, sqrt(-1.0), NULL, &error) == MS_INVALID_ARGUMENT);
    value[0] = value[1] = value[2] = dark;
    CHECK(ms_sss_profile_from_rings(&black, 1, edge, value, 1, NULL, NULL) == MS_OK);
    CHECK(ms_sss_designer_create(&none, black, 8, NULL, &error) == MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "no light") != NULL);
    ms_sss_designer_destroy(NULL);
    ms_sss_profile_destroy(black);
    ms_sss_profile_destroy(skin);
}

static ms_status rings_with(const ms_allocator *allocator)
{
    static ms_sss_kernel k;
    const double edge[4] = {0, 1, 2, 3}, fall[3] = {3, 1, 0.5}, *value[3];
    ms_sss_errors errors;
    ms_sss_profile *p;
    ms_status status;
    value[0] = value[1] = value[2] = fall;
    status = ms_sss_profile_from_rings(&p, 3, edge, value, 1, allocator, NULL);
    if (status == MS_OK) status = ms_sss_kernel_make(&k, &errors, p, 6, NULL, allocator, NULL);
    ms_sss_profile_destroy(p);
    return status;
}

static ms_status model_with(int model, const ms_allocator *allocator)
{
    static ms_sss_kernel k;
    const double one[3] = {1, 1, 1};
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_errors errors;
    ms_sss_profile *p;
    ms_sss_designer *d = NULL;
    ms_status status = ms_sss_profile_from_burley(&p, one, one, allocator, NULL);
    o.model = (ms_sss_model)model;
    o.tap_count = model == MS_SSS_IMAGE_OPTIMAL ? 7 : MS_SSS_DENSE;
    if (status == MS_OK) status = ms_sss_designer_create(&d, p, 4, allocator, NULL);
    if (status == MS_OK) status = ms_sss_kernel_build(&k, d, &o, NULL);
    if (status == MS_OK) status = ms_sss_kernel_measure(&errors, &k, d);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
    return status;
}

static void allocations(void)
{
    int model;
    TEST_ALLOCATION_SWEEP(20, status = rings_with(&allocator));
    for (model = 0; model <= (int)MS_SSS_SLICE; ++model)
        TEST_ALLOCATION_SWEEP(20, status = model_with(model, &allocator));
}

static size_t bytes_held, bytes_most, bytes_refused; /* blocks from bytes_refused on are counted, not given */

static void *count_alloc(void *user, size_t size)
{
    (void)user;
    if (bytes_held + size > bytes_most) bytes_most = bytes_held + size;
    if (size >= bytes_refused) return NULL;
    bytes_held += size;
    return malloc(size);
}

static void count_release(void *user, void *pointer, size_t size)
{
    (void)user;
    bytes_held -= size;
    free(pointer);
}

/* What the head comment says of memory, at the most cells and taps. A fit that gets no memory ends at once. */
static void memory(void)
{
    static ms_sss_kernel k;
    const ms_allocator allocator = {NULL, count_alloc, count_release};
    ms_sss_profile *skin = skin_profile();
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_errors e;
    ms_sss_designer *d;
    size_t designer;
    int terms;
    bytes_held = bytes_most = 0;
    bytes_refused = SIZE_MAX;
    CHECK_INT(ms_sss_designer_create(&d, skin, 128, &allocator, NULL), MS_OK);
    designer = bytes_most = bytes_held;
    CHECK_LE(designer, 2.05e6);
    o.model = MS_SSS_PREINTEGRATED;
    o.placement = MS_SSS_QUANTILE;
    CHECK_INT(ms_sss_kernel_build(&k, d, &o, NULL), MS_OK);
    bytes_most = designer;
    CHECK_INT(ms_sss_kernel_measure(&e, &k, d), MS_OK);
    CHECK_LE((double)(bytes_most - designer), 60e3);
    bytes_refused = 300000; /* only a fit is as large */
    o.model = MS_SSS_GAUSSIANS;
    o.placement = MS_SSS_OPTIMIZED;
    o.tap_count = 33;
    for (terms = 1; terms <= 6; terms += 5) {
        bytes_most = designer;
        o.term_count = terms;
        CHECK_INT(ms_sss_kernel_build(&k, d, &o, NULL), MS_OUT_OF_MEMORY);
        CHECK_LE((double)(bytes_most - designer), terms == 1 ? 0.5e6 : 2.1e6);
    }
    CHECK((double)(bytes_most - designer) > 1.9e6);
    ms_sss_designer_destroy(d);
    CHECK(bytes_held == 0);
    ms_sss_profile_destroy(skin);
}

static void same_bits(void)
{
    static ms_sss_kernel a, b;
    ms_sss_profile *skin = skin_profile();
    ms_sss_errors e, f;
    CHECK(ms_sss_kernel_make(&a, &e, skin, 0, NULL, NULL, NULL) == MS_OK);
    CHECK(ms_sss_kernel_make(&b, &f, skin, 24, NULL, NULL, NULL) == MS_OK);
    CHECK(memcmp(&a, &b, sizeof a) == 0 && memcmp(&e, &f, sizeof e) == 0);
    CHECK_INT(a.tap_count, 7);
    ms_sss_profile_destroy(skin);
}

/* A Gaussian separates: its mean distance is sigma sqrt(pi / 2) in the plane and sigma sqrt(2 / pi) along an axis, so
   that an axis has pi / 4 of the plane's elevation. Cells of a 50th of sigma and the last percent of the light, which
   is moved inside, leave 1%. Half of the light unblurred does not change what the rest needs to make up the mean. */
static void elevation(void)
{
    double sigma[1][3] = {{1, 1, 1}}, weight[1][3] = {{0.9, 0.4, 0}};
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_profile *p;
    ms_sss_kernel k;
    int c;
    CHECK(ms_sss_profile_from_gaussians(&p, 1, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL) ==
          MS_OK);
    o.model = MS_SSS_PREINTEGRATED;
    o.tap_count = MS_SSS_DENSE;
    CHECK(ms_sss_kernel_make(&k, NULL, p, 120, &o, NULL, NULL) == MS_OK);
    for (c = 0; c < 2; ++c) {
        CHECK_NEAR((double)k.elevation[c], ms_sss_elevation(weight[0][c], 1), 1e-6);
        CHECK_NEAR((double)(k.elevation_axis[c] / k.elevation[c]), PI / 4, 0.01);
    }
    CHECK(k.elevation[2] == 0 && k.elevation_axis[2] == 0);
    CHECK(k.elevation[1] > k.elevation[0]);
    o.model = MS_SSS_IMAGE_OPTIMAL; /* any taps: over both passes the mean of K |x| is that of the plane */
    o.tap_count = 9;
    CHECK(ms_sss_kernel_make(&k, NULL, p, 30, &o, NULL, NULL) == MS_OK);
    for (c = 0; c < 2; ++c) {
        double sum = 0, mean = 0;
        int i;
        for (i = 0; i <= k.tap_count / 2; ++i) {
            sum += (i ? 2 : 1) * (double)k.weight[0][i][c];
            mean += 2 * (double)(k.weight[0][i][c] * k.offset_mm[i]);
        }
        mean *= 2 * sum * (double)k.elevation_axis[c];
        CHECK_NEAR(mean, (double)k.elevation[c] * sqrt(PI / 2), 1e-4 * mean); /* quadrature of the mean distance */
    }
    ms_sss_profile_destroy(p);
}

/* Random walks in a ball and around a hollow return what the elevation makes of the rings of a walk below a plane:
   within 2%, which the law keeps at these radii (bench_sss_elevation.c), and three standard errors. The flat profile
   alone is 14 to 18% off. */
static void elevation_of_balls(void)
{
    static const double albedo[2] = {0.7, 0.9}, radius[2] = {8, -8}, index[2] = {1, 1.4};
    static ball_tally plane, body;
    const long walks = 60000;
    int n, s, i, b;
    TEST_METHOD;
    for (n = 0; n < 2; ++n) {
        ball_walk(BALL_SPHERE, 0, index[n], albedo, 2, walks, test_seed, &plane);
        for (s = 0; s < 2; ++s) {
            ball_walk(BALL_SPHERE, 1 / radius[s], index[n], albedo, 2, walks, test_seed + 1, &body);
            for (i = 0; i < 2; ++i) {
                double with = 0, error = sqrt((plane.square[i] + body.square[i]) / (double)walks) / body.total[i];
                for (b = 0; b < BALL_BINS && ball_edge(b + 1) < 2 * fabs(radius[s]); ++b)
                    with += plane.ring[i][b] *
                        pow(1 +
                                ms_sss_elevation(plane.total[i], index[n]) * (ball_edge(b) + ball_edge(b + 1)) /
                                    (16 * radius[s]),
                            4);
                CHECK_NEAR(with / body.total[i], 1, 0.02 + 3 * error);
                CHECK(fabs(plane.total[i] / body.total[i] - 1) > 0.1);
            }
        }
    }
}

/* Hosts may unmask floating-point exceptions: no model raises one, also with a dark and a very narrow channel. */
static void no_exceptions(void)
{
    ms_sss_profile *p;
    double sigma[2][3] = {{0.5, 0.01, 1}, {2, 0.02, 1}}, weight[2][3] = {{0.3, 0.9, 0}, {0.4, 0.05, 0}};
    const int raised = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    ms_sss_designer *d;
    ms_sss_kernel k;
    ms_sss_errors e;
    int model, dense;
    CHECK(ms_sss_profile_from_gaussians(&p, 2, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL) ==
          MS_OK);
    feclearexcept(FE_ALL_EXCEPT);
    d = designer_for(p, 16);
    for (model = MS_SSS_IMAGE_OPTIMAL; model <= MS_SSS_SLICE; ++model)
        for (dense = 0; dense < 2; ++dense) {
            ms_sss_kernel_options o = ms_sss_kernel_defaults();
            o.model = (ms_sss_model)model;
            o.term_count = model == MS_SSS_RESIDUAL || model == MS_SSS_SVD || model == MS_SSS_SVD_NORMALIZED ||
                    model == MS_SSS_GAUSSIANS
                ? 4
                : 1;
            if (dense) o.tap_count = model == MS_SSS_IMAGE_OPTIMAL ? 33 : MS_SSS_DENSE;
            CHECK(ms_sss_kernel_build(&k, d, &o, NULL) == MS_OK);
            ms_sss_kernel_measure(&e, &k, d);
            if (fetestexcept(raised))
                TEST_FAIL("model %d, dense %d: exceptions %x", model, dense, (unsigned)fetestexcept(raised));
            feclearexcept(FE_ALL_EXCEPT);
        }
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

/* Stairs: few taps over many pixels show them, every pixel a tap does not; choosing spends taps on them. The size of
   the stairs by hand: 3 pre-integrated taps of a wide Gaussian stand at -x, 0 and x, so that black to white goes in
   three steps, the first from 0 to the outer weight. */
static void bands(void)
{
    double sigma[1][3] = {{10, 10, 10}}, weight[1][3] = {{0.5, 0.5, 0.5}}, step, share;
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    ms_sss_profile *p;
    ms_sss_designer *d;
    ms_sss_kernel k;
    ms_sss_errors e, few;
    CHECK(ms_sss_profile_from_gaussians(&p, 1, (const double(*)[3])sigma, (const double(*)[3])weight, NULL, NULL) ==
          MS_OK);
    d = designer_for(p, 100);
    o.model = MS_SSS_PREINTEGRATED;
    o.placement = MS_SSS_QUANTILE;
    o.tap_count = 3;
    CHECK(ms_sss_kernel_build(&k, d, &o, NULL) == MS_OK);
    ms_sss_kernel_measure(&e, &k, d);
    share = (double)
                k.weight[0][1][0]; /* linear interpolation spreads it over the two pixels beside the tap's position */
    step = 255 *
        share; /* at least, as sRGB lies above the diagonal; three second differences share it, two of them the bend */
    CHECK(e.bands > 0.25 * step && e.bands < 255);
    few = e;
    o.tap_count = MS_SSS_DENSE;
    CHECK(ms_sss_kernel_build(&k, d, &o, NULL) == MS_OK);
    ms_sss_kernel_measure(&e, &k, d);
    CHECK_LE(e.bands, 0.1); /* the cells themselves */
    CHECK(few.bands > 100 * e.bands);
    CHECK(choose_kernel(&k, &e, d, 0.5, 40, NULL, NULL) == MS_OK); /* any error will do */
    CHECK_LE(e.bands, MS_SSS_BANDS_SEEN);
    CHECK(k.tap_count > 5);
    ms_sss_designer_destroy(d);
    ms_sss_profile_destroy(p);
}

int main(int argc, char **argv)
{
    static const test_case cases[] = {{"strips of Gaussian rings", strips_of_gaussian_rings},
                                      {"exact chords", exact_chords},
                                      {"strips of Burley", strips_of_burley},
                                      {"reference profiles", reference_profiles},
                                      {"samples and noise", samples_and_noise},
                                      {"refused profiles", refused_profiles},
                                      {"named arguments", named_arguments},
                                      {"Burley's mean free path", burley_mean_free_path},
                                      {"measured garbage", measured_garbage},
                                      {"small designs", small_designs},
                                      {"csv files", csv_files},
                                      {"translucency", translucency},
                                      {"elevation", elevation},
                                      {"elevation of balls", elevation_of_balls},
                                      {"reference kernels", reference_kernels},
                                      {"reference errors", reference_errors},
                                      {"reference taps", reference_taps},
                                      {"targets", targets},
                                      {"separable signals", separable_signals},
                                      {"measured errors", measured_errors},
                                      {"every model", every_model},
                                      {"no gain", no_gain},
                                      {"idle unknowns", idle_unknowns},
                                      {"more taps", more_taps},
                                      {"radii", radii},
                                      {"the dial", dial},
                                      {"cheapest", cheapest},
                                      {"bands", bands},
                                      {"no exceptions", no_exceptions},
                                      {"refused options", refused_options},
                                      {"allocations", allocations},
                                      {"memory", memory},
                                      {"same bits", same_bits}};
    return test_main(argc, argv, cases, (int)(sizeof cases / sizeof cases[0]));
}
