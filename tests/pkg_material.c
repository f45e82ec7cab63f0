/* The material-test tracer (tests/render/material.h): its sampler and lobes against closed forms, their densities and
   quadrature, the whole against furnaces, an absorbing ball and a variant that finds lamps by chance alone; the
   extended shader's textures and reliefs. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h" /* for ms_parallel */
#include "test.h"
#include "image.h"
#include "render/material.h"

static void parameters(float x[19])
{
    int k;
    for (k = 0; k < 19; ++k) x[k] = 0;
    for (k = 0; k < 3; ++k) x[k] = x[3 + k] = x[8 + k] = x[13 + k] = 1;
    x[12] = 0.5f;
}

static void test_fresnel(void)
{
    static const float etas[] = {1.01f, 1.33f, 1.5f, 2, 1 / 1.5f, 1 / 2.0f};
    int e, k;
    double worst = 0;
    for (e = 0; e < 6; ++e)
        for (k = 1; k <= 1000; ++k) {
            double c = k / 1000.0, s2 = (1 - c * c) / ((double)etas[e] * (double)etas[e]), ct, rs, rp, exact = 1;
            if (s2 < 1) { /* Snell, then the amplitudes of both polarisations */
                ct = sqrt(1 - s2);
                rs = (c - (double)etas[e] * ct) / (c + (double)etas[e] * ct);
                rp = ((double)etas[e] * c - ct) / ((double)etas[e] * c + ct);
                exact = 0.5 * (rs * rs + rp * rp);
            }
            worst = fmax(worst, fabs((double)material_fresnel((float)c, etas[e]) - exact));
        }
    CHECK_LE(worst, 1e-4); /* float near the critical angle, where the reflectance rises as a square root */
    TEST_NOTE("largest error %.1e", worst);
}

/* The first 2^k points of a pair fill every elementary interval once: a scrambled (0, 2)-sequence keeps that. */
static void test_sobol(void)
{
    enum { BITS = 8, POINTS = 1 << BITS };
    uint32_t seed;
    int uneven = 0, split, k;
    for (seed = 0; seed < 50; ++seed)
        for (split = 0; split <= BITS; ++split) { /* boxes of 2^-split by 2^(split - BITS) */
            int filled[POINTS];
            memset(filled, 0, sizeof filled);
            for (k = 0; k < POINTS; ++k) {
                trace_sampler s;
                float u, v;
                memset(&s, 0, sizeof s);
                s.seed = seed;
                s.index = (uint32_t)k;
                trace_sample(&s, &u, &v);
                filled[(int)(u * (float)(1 << split)) << (BITS - split) | (int)(v * (float)(1 << (BITS - split)))] += 1;
            }
            for (k = 0; k < POINTS; ++k) uneven += filled[k] != 1;
        }
    CHECK(uneven == 0);
}

static void test_beckmann(void)
{
    static const float alphas[] = {0.05f, 0.3f, 0.9f};
    int a;
    for (a = 0; a < 3; ++a) {
        enum { BINS = 40, TURNS = 6, SAMPLES = 400000 };
        double count[BINS][TURNS], chi2 = 0;
        int k, j, bins = 0;
        uint64_t state = test_seed;
        memset(count, 0, sizeof count);
        for (k = 0; k < SAMPLES; ++k) {
            scene_vec h = material_half(alphas[a], (float)test_uniform(&state) * 0.9999999f,
                                        (float)test_uniform(&state));
            double t = tan(acos((double)h.z)) / (double)alphas[a],
                   turn = atan2((double)h.y, (double)h.x) / 6.283185307179586 + 0.5;
            int bin = (int)(t * BINS / 3), around = (int)(turn * TURNS);
            if (bin < BINS) count[bin][around < TURNS ? around : 0] += 1;
        }
        for (k = 0; k < BINS; ++k) { /* D(h) cos integrated by the midpoint rule over each bin of tan / alpha */
            double expected = 0;
            int i;
            for (i = 0; i < 200; ++i) {
                double t = (k + (i + 0.5) / 200) * 3 / BINS * (double)alphas[a], c = 1 / sqrt(1 + t * t);
                double dt = 3.0 / BINS / 200 * (double)alphas[a]; /* solid angle: sin dtheta = t c^3 dt */
                expected += (double)material_beckmann((float)c, alphas[a]) * c * 6.283185307179586 * t * c * c * c * dt;
            }
            expected *= (double)SAMPLES / TURNS;
            if (expected < 20) continue;
            for (j = 0; j < TURNS; ++j) chi2 += (count[k][j] - expected) * (count[k][j] - expected) / expected;
            bins += TURNS;
        }
        CHECK(test_chi2_p(chi2, bins) > 1e-4);
        TEST_NOTE("alpha %.2f: chi2 %.0f of %d", (double)alphas[a], chi2, bins);
    }
}

/* The mean of f / density over material_sample equals the integral of f by quadrature, and no lobe gains energy. */
static void test_lobes(void)
{
    int lobe, k, r;
    for (lobe = 0; lobe < 4; ++lobe) {
        double worst = 0, most = 0;
        for (r = 0; r < 6; ++r) {
            float x[19], eta, f[3];
            double sampled = 0, square = 0, integral = 0, density = 0;
            material m;
            scene_vec o = scene_v(sqrtf(1 - 0.49f), 0, 0.7f), i;
            uint64_t state = 5 + (uint64_t)r;
            enum { SAMPLES = 100000, N = 600 };
            int a, b;
            parameters(x);
            x[6] = x[11] = 0.5f + 0.08f * (float)r;
            x[7] = lobe == MATERIAL_GLOSSY;
            x[16] = lobe == MATERIAL_TRANSLUCENT;
            x[17] = lobe >= MATERIAL_GLASS;
            m = material_from(x);
            eta = r % 2 ? m.ior : 1 / m.ior;
            for (k = 0; k < SAMPLES; ++k) {
                double w = 0;
                if (material_sample(&m, o, eta, (float)test_uniform(&state) * 0.9999999f,
                                    (float)test_uniform(&state) * 0.9999999f, (float)test_uniform(&state), &i)) {
                    float pdf = material_eval(&m, o, i, eta, f);
                    if (pdf > 0) w = (double)f[0] / (double)pdf;
                }
                sampled += w;
                square += w * w;
            }
            sampled /= SAMPLES;
            square = sqrt((square / SAMPLES - sampled * sampled) / SAMPLES);
            for (a = 0; a < N; ++a)
                for (b = 0; b < N; ++b) { /* uniform in cosine and angle over the whole sphere */
                    double z = -1 + 2 * (a + 0.5) / N, s = sqrt(1 - z * z), phi = 6.283185307179586 * (b + 0.5) / N,
                           cell = 2.0 / N * 6.283185307179586 / N;
                    double p = (double)material_eval(
                        &m, o, scene_v((float)(s * cos(phi)), (float)(s * sin(phi)), (float)z), eta, f);
                    integral += (double)f[0] * cell;
                    density += p * cell;
                }
            CHECK_NEAR(sampled, integral,
                       5 * square + 4e-3 * integral); /* 5 standard errors and the quadrature's own error */
            CHECK_LE(density, 1 + 5e-3);
            CHECK_LE(integral, 1 + 5e-3);
            worst = fmax(worst, fabs(sampled - integral));
            most = fmax(most, integral);
        }
        TEST_NOTE("lobe %d: sampling and quadrature differ by %.1e, albedo at most %.3f", lobe, worst, most);
    }
}

static void test_reciprocity(void)
{
    uint64_t state = test_seed;
    int k;
    double worst = 0;
    for (k = 0; k < 20000; ++k) {
        float x[19], f[3], g[3], eta;
        double z1 = test_uniform(&state), p1 = 6.28 * test_uniform(&state), z2 = 2 * test_uniform(&state) - 1,
               p2 = 6.28 * test_uniform(&state), a, b;
        scene_vec o = scene_v((float)(sqrt(1 - z1 * z1) * cos(p1)), (float)(sqrt(1 - z1 * z1) * sin(p1)), (float)z1), i,
                  o2, i2;
        material m;
        int j;
        i = scene_v((float)(sqrt(1 - z2 * z2) * cos(p2)), (float)(sqrt(1 - z2 * z2) * sin(p2)), (float)z2);
        for (j = 0; j < 19; ++j) x[j] = (float)test_uniform(&state);
        x[6] = 0.3f + 0.7f * x[6];
        x[11] = 0.3f + 0.7f * x[11];
        m = material_from(x);
        eta = m.ior;
        o2 = i;
        i2 = o;
        if (i.z < 0) { /* seen from behind: the frame turns over, the index is inverted */
            o2 = scene_v(i.x, i.y, -i.z);
            i2 = scene_v(o.x, o.y, -o.z);
            m.share[MATERIAL_TRANSLUCENT] = 0;
        }
        if (fabs(z2) < 0.05 || z1 < 0.05) continue;
        material_eval(&m, o, i, eta, f);
        material_eval(&m, o2, i2, i.z < 0 ? 1 / eta : eta, g);
        a = (double)f[0] / fabs(z2);
        b = (double)g[0] / z1;
        if (i.z < 0)
            a /= (double)eta * (double)eta; /* f(o, i) / eta^2 is symmetric under refraction (Veach 1997, 5.2) */
        worst = fmax(worst, fabs(a - b) / (1e-3 + fmax(a, b)));
    }
    CHECK_LE(worst, 5e-3); /* float */
    TEST_NOTE("largest relative difference %.1e", worst);
}

static double mean_of(const image *im, int channel, double *deviation)
{
    size_t k, n = (size_t)im->width * (size_t)im->height;
    double sum = 0, square = 0;
    for (k = 0; k < n; ++k) {
        double v = (double)im->pixels[3 * k + (size_t)channel];
        sum += v;
        square += v * v;
    }
    if (deviation) *deviation = sqrt(square / (double)n - sum / (double)n * (sum / (double)n));
    return sum / (double)n;
}

/* The ball alone under a sky of 1; NULL: no scene. */
static material_scene *furnace(void)
{
    material_scene *s = material_scene_create(-0.5f);
    if (s == NULL) return NULL;
    s->bare = 1;
    s->sky[0] = 1;
    s->sky[1] = s->sky[2] = 0;
    return s;
}

/* Under a sky of 1 a ball that absorbs nothing is invisible: diffuse and translucent exactly, glass but for the
   directions that microfacets lose. */
static void test_furnace(void)
{
    static const struct {
        int lobe;
        float roughness;
        double loss;
    } cases[] = {{MATERIAL_DIFFUSE, 0, 1e-5},
                 {MATERIAL_TRANSLUCENT, 0, 2e-3},
                 {MATERIAL_GLASS, 0, 2e-2},
                 {MATERIAL_GLOSSY, 0, 2e-3}};
    material_scene *s = furnace();
    int k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    for (k = 0; k < 4; ++k) {
        float x[19];
        image im;
        double mean;
        parameters(x);
        x[7] = cases[k].lobe == MATERIAL_GLOSSY;
        x[16] = cases[k].lobe == MATERIAL_TRANSLUCENT;
        x[17] = cases[k].lobe >= MATERIAL_GLASS;
        CHECK(material_render(s, x, 24, 24, 64, 3, &im));
        mean = mean_of(&im, 0, NULL);
        /* lost: paths cut after 32 bounces, sides that the interpolated normal confuses at the rim */
        CHECK(mean <= 1 + 2e-3 && mean >= 1 - cases[k].loss);
        TEST_NOTE("lobe %d: mean %.5f", cases[k].lobe, mean);
        image_free(&im);
    }
    material_scene_destroy(s);
}

/* Through the middle of a clear ball of index 1.01 light keeps exp(-2 absorption) (and all but 5e-5 of Fresnel's). */
static void test_absorption(void)
{
    material_scene *s = material_scene_create(-1);
    static const float absorptions[] = {0, 0.1f, 0.5f, 1};
    int k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    s->bare = 1;
    s->sky[0] = 1;
    s->sky[1] = s->sky[2] = 0;
    for (k = 0; k < 4; ++k) {
        float x[19], out[3];
        double sum = 0, expected = exp(-2 * 4 * (double)absorptions[k]);
        material m;
        int i;
        parameters(x);
        x[12] = 0.01f;
        x[17] = 1;
        x[18] = absorptions[k];
        m = material_from(x);
        for (i = 0; i < 20000; ++i) {
            trace_sampler sampler;
            memset(&sampler, 0, sizeof sampler);
            sampler.seed = 77;
            sampler.index = (uint32_t)i;
            stage_path(s, &m, &sampler, scene_v(0.001f, 0.002f, 6), scene_v(0, 0, -1), out);
            sum += (double)out[0];
        }
        CHECK_NEAR(sum / 20000, expected, 2e-3 * expected + 1e-4); /* facets of 0.01, reflections 5e-5 */
        TEST_NOTE("%.5f of %.5f", sum / 20000, expected);
    }
    material_scene_destroy(s);
}

/* Of parallel light on a smooth absorbing ball F + (1 - F)^2 T / (1 - F T) leaves in all, F Fresnel's reflectance and T
   what a chord keeps: all inner reflections meet the surface at one angle. The mean over the disc, by the midpoint
   rule. */
static void test_absorbing_total(void)
{
    static const float ior[] = {0.01f, 0.5f, 1}, absorptions[] = {0, 0.05f, 0.3f, 1};
    material_scene *s = material_scene_create(-1);
    int n, k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    s->bare = 1;
    s->sky[0] = 1;
    s->sky[1] = s->sky[2] = 0;
    for (n = 0; n < 3; ++n)
        for (k = 0; k < 4; ++k) {
            enum { RAYS = 20000, STEPS = 20000 };
            double sum = 0, square = 0, expected = 0, eta = 1 + (double)ior[n], error;
            float x[19], out[3];
            material m;
            int i;
            parameters(x);
            x[12] = ior[n];
            x[17] = 1;
            x[18] = absorptions[k];
            m = material_from(x);
            for (i = 0; i < STEPS; ++i) {
                double b2 = (i + 0.5) / STEPS, c = sqrt(1 - b2), ct = sqrt(1 - b2 / (eta * eta));
                double rs = (c - eta * ct) / (c + eta * ct), rp = (eta * c - ct) / (eta * c + ct),
                       f = 0.5 * (rs * rs + rp * rp);
                double t = exp(-2 * ct * 4 * (double)absorptions[k]);
                expected += (f + (1 - f) * (1 - f) * t / (1 - f * t)) / STEPS;
            }
            for (i = 0; i < RAYS; ++i) {
                trace_sampler sampler;
                float u, v, r;
                memset(&sampler, 0, sizeof sampler);
                sampler.seed = 78;
                sampler.index = (uint32_t)i;
                trace_sample(&sampler, &u, &v);
                r = 0.9999f * sqrtf(u);
                stage_path(s, &m, &sampler, scene_v(r * cosf(TRACE_TURN * v), r * sinf(TRACE_TURN * v), 6),
                           scene_v(0, 0, -1), out);
                sum += (double)out[0];
                square += (double)out[0] * (double)out[0];
            }
            sum /= RAYS;
            error = sqrt(fmax(0, square / RAYS - sum * sum) / RAYS);
            CHECK_NEAR(sum, expected,
                       5 * error + 3e-3); /* 5 standard errors; facets of 0.01 and microfacets of 0.002 at the rim */
            TEST_NOTE("index %.2f: %.5f of %.5f", eta, sum, expected);
        }
    material_scene_destroy(s);
}

static void test_brute_force(void)
{
    material_scene *s = material_scene_create(0.5f);
    float x[19];
    image a, b;
    double mean_a, mean_b, error, deviation;
    int k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    for (k = 0; k < 3; ++k) {
        int runs;
        double sum = 0, square = 0;
        enum { RUNS = 8 };
        parameters(x);
        x[6] = x[11] = 0.6f;
        x[7] = k == 1 ? 1 : 0.3f;
        x[16] = 0.4f;
        x[17] = k == 2 ? 0.7f : 0;
        CHECK(material_render(s, x, 16, 16, 512, 5, &a));
        mean_a = mean_of(&a, 0, &deviation);
        s->brute = 1;
        for (runs = 0; runs < RUNS; ++runs) {
            CHECK(material_render(s, x, 16, 16, 256, 100 + (uint32_t)runs, &b));
            mean_b = mean_of(&b, 0, NULL);
            sum += mean_b;
            square += mean_b * mean_b;
            image_free(&b);
        }
        s->brute = 0;
        mean_b = sum / RUNS;
        error = sqrt((square / RUNS - mean_b * mean_b) / (RUNS - 1));
        CHECK_NEAR(mean_a, mean_b,
                   5 * error + 5e-3 * mean_a); /* 5 standard errors of the brute one, 0.5% for the other */
        TEST_NOTE("%.4f, by chance %.4f +- %.4f", mean_a, mean_b, error);
        image_free(&a);
    }
    material_scene_destroy(s);
}

/* Rays that all but follow the floor meet it as far out as a float goes: what they bring is finite, and small. */
static void test_far(void)
{
    material_scene *s = material_scene_create(0.25f);
    float x[19], out[3], slope;
    material m;
    int k, rays = 0;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    parameters(x);
    m = material_from(x);
    for (slope = 1e-2f; slope > 1e-30f; slope *= 0.1f)
        for (k = 0; k < 64; ++k) {
            trace_sampler sampler;
            memset(&sampler, 0, sizeof sampler);
            sampler.seed = 3;
            sampler.index = (uint32_t)k;
            stage_path(s, &m, &sampler, scene_v(0, 0, 3), scene_normalize(scene_v(0.3f, -slope, 1)), out);
            CHECK(out[0] >= 0 && out[0] < 10 && out[0] == out[1] && out[0] == out[2]);
            ++rays;
        }
    TEST_NOTE("%d rays", rays);
    material_scene_destroy(s);
}

static void test_same_bytes(void)
{
    material_scene *s = material_scene_create(0.5f);
    float x[19], swapped[19];
    image a, b;
    test_pool pool;
    static const int threads[] = {2, 3, 7};
    uint64_t state = test_seed;
    int k, c, same = 1;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    for (k = 0; k < 19; ++k) x[k] = (float)test_uniform(&state);
    CHECK(material_render(s, x, 20, 12, 16, 9, &a));
    for (k = 0; k < 3; ++k) {
        ms_parallel parallel = test_parallel(&pool, threads[k]);
        s->run = parallel.run;
        s->run_user = parallel.user;
        CHECK(material_render(s, x, 20, 12, 16, 9, &b));
        CHECK(memcmp(a.pixels, b.pixels, 20 * 12 * 3 * sizeof(float)) == 0);
        image_free(&b);
    }
    memcpy(swapped, x, sizeof x);
    for (c = 0; c < 4; ++c) {
        static const int at[4] = {0, 3, 8, 13};
        swapped[at[c]] = x[at[c] + 1];
        swapped[at[c] + 1] = x[at[c]];
    }
    CHECK(material_render(s, swapped, 20, 12, 16, 9, &b));
    for (k = 0; k < 20 * 12; ++k)
        same &= a.pixels[3 * k] == b.pixels[3 * k + 1] && a.pixels[3 * k + 1] == b.pixels[3 * k] &&
            a.pixels[3 * k + 2] == b.pixels[3 * k + 2];
    CHECK(same);
    image_free(&a);
    image_free(&b);
    material_scene_destroy(s);
}

/* --- the extended shader --- */

static void random_extended(uint64_t *state, float x[38])
{
    int k;
    for (k = 0; k < 38; ++k) x[k] = (float)test_uniform(state);
}

static void make_neutral(float x[38]) { x[22] = x[29] = x[30] = x[31] = x[35] = 0; }

/* Without amounts and depths the other parameters do nothing, also right after a carved picture. */
static void test_extended_neutral(void)
{
    material_scene *s = material_scene_create(0.25f);
    uint64_t state = test_seed;
    int k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    for (k = 0; k < 6; ++k) {
        float x[38], wild[38];
        image a, b, c;
        random_extended(&state, x);
        random_extended(&state, wild);
        make_neutral(x);
        CHECK(material_render(s, x, 20, 20, 8, (uint32_t)k, &a));
        CHECK(material_render_extended(s, wild, 20, 20, 8, (uint32_t)k, &c));
        CHECK(material_render_extended(s, x, 20, 20, 8, (uint32_t)k, &b));
        CHECK(memcmp(a.pixels, b.pixels, 20 * 20 * 3 * sizeof(float)) == 0);
        CHECK(memcmp(a.pixels, c.pixels, 20 * 20 * 3 * sizeof(float)) != 0);
        image_free(&a);
        image_free(&b);
        image_free(&c);
    }
    material_scene_destroy(s);
}

/* A textured material lies between its two phases everywhere; coverage goes from none to all. */
static void test_extended_bounds(void)
{
    uint64_t state = test_seed;
    double outside = 0, worst_share = 0, deepest = 0;
    int k, c, i;
    for (k = 0; k < 3000; ++k) {
        float x[38], share = 0;
        material m, place;
        const material *here;
        scene_vec p = scene_v((float)test_uniform(&state) * 2 - 1, (float)test_uniform(&state) * 2 - 1,
                              (float)test_uniform(&state) * 2 - 1);
        random_extended(&state, x);
        m = material_from_extended(x);
        here = material_at(&m, p, &place);
        CHECK(here == &place);
        for (c = 0; c < 3; ++c) {
            const float first[4] = {m.diffuse[c], m.glossy[c], m.glass[c], m.translucent[c]};
            const float now[4] = {here->diffuse[c], here->glossy[c], here->glass[c], here->translucent[c]};
            for (i = 0; i < 4; ++i) {
                outside = fmax(outside, (double)(now[i] - scene__max(first[i], m.second[c])));
                outside = fmax(outside, (double)(scene__min(first[i], m.second[c]) - now[i]));
            }
        }
        for (i = 0; i < 4; ++i) {
            share += here->share[i];
            outside = fmax(outside, -(double)here->share[i]);
        }
        worst_share = fmax(worst_share, fabs((double)share - 1));
        CHECK(here->glossy_alpha >= m.glossy_alpha && here->glossy_alpha <= 1 && here->glass_alpha >= m.glass_alpha &&
              here->glass_alpha <= 1);
        deepest = fmax(deepest, (double)material_depth(&m, p));
        CHECK(material_depth(&m, p) >= 0);
        m.coverage = 0;
        CHECK(material__pattern(&m, p) == 0);
        m.coverage = 1;
        CHECK(material__pattern(&m, p) == 1);
    }
    CHECK_LE(outside, 1e-6); /* rounding */
    CHECK_LE(worst_share, 1e-6);
    CHECK_LE(deepest, 0.3 + 1e-6);
    TEST_NOTE("deepest %.3f radii", deepest);
}

/* Rays to the center end where the carved radius says, less what facets of 0.02 miss, and nothing rises above the ball
   without reliefs. */
static void test_extended_relief(void)
{
    material_scene *s = material_scene_create(1);
    float x[38];
    material m;
    double worst = 0, least = 1, most = 0, mean = 0;
    int k;
    enum { RAYS = 4000 };
    uint64_t state = test_seed;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    parameters(x);
    memset(x + 19, 0, 19 * sizeof(float));
    x[31] = x[35] = 1;
    x[33] = 0.3f;
    x[37] = 1;
    m = material_from_extended(x);
    material_scene_carve(s, &m);
    for (k = 0; k < RAYS; ++k) {
        double z = test_uniform(&state),
               phi = 6.283185307179586 * test_uniform(&state); /* the upper half: the ring is below */
        float theta = (float)acos(z), around = (float)phi, expected;
        scene_vec d = scene_v(sinf(theta) * cosf(around), cosf(theta), sinf(theta) * sinf(around));
        stage_hit hit = stage__nearest(s, scene_mul(d, 2), scene_mul(d, -1));
        double radius = 2 - (double)hit.t;
        expected = material__relief(theta, around) - material_depth(&m, d);
        CHECK(hit.kind == STAGE_OBJECT && hit.which == 0);
        CHECK_LE(radius, (double)material__relief(theta, around) + 4e-3);
        worst = fmax(worst, fabs(radius - (double)expected));
        mean += fabs(radius - (double)expected) / RAYS;
        least = fmin(least, radius);
        most = fmax(most, radius);
    }
    CHECK_LE(worst, 1e-2); /* where a facet spans the edge of a cell or a flute */
    CHECK_LE(mean, 1e-3);
    CHECK(most - least > 0.1);
    TEST_NOTE("radius %.3f to %.3f, mean distance from the formula %.1e, largest %.1e", least, most, mean, worst);
    material_scene_destroy(s);
}

/* Under a sky of 1 white phases stay invisible, whatever the pattern; reliefs lose the paths on whose side the
   interpolated and the true normal disagree, and gain nothing. */
static void test_extended_furnace(void)
{
    material_scene *s = furnace();
    int k;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    for (k = 0; k < 4; ++k) {
        float x[38];
        image im;
        double mean;
        parameters(x);
        memset(x + 19, 0, 19 * sizeof(float));
        x[7] = k == 1;
        x[17] = k == 2;
        x[19] = x[20] = x[21] = x[22] = x[24] = x[25] = 1;
        x[26] = 0.5f;
        x[28] = 0.6f;
        x[30] = 1;
        x[31] = x[35] = k == 3 ? 0.6f : 0;
        CHECK(material_render_extended(s, x, 24, 24, 64, 3, &im));
        mean = mean_of(&im, 0, NULL);
        CHECK(mean <= 1 + 2e-3 && mean >= 1 - 1e-2);
        TEST_NOTE("%s: mean %.5f",
                  k == 0       ? "diffuse"
                      : k == 1 ? "glossy and diffuse"
                      : k == 2 ? "glass and translucent"
                               : "carved",
                  mean);
        image_free(&im);
    }
    material_scene_destroy(s);
}

static void test_extended_same_bytes(void)
{
    material_scene *s = material_scene_create(0.25f);
    float x[38], swapped[38];
    image a, b;
    test_pool pool;
    ms_parallel parallel = test_parallel(&pool, 3);
    uint64_t state = test_seed;
    int k, c, same = 1;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    random_extended(&state, x);
    CHECK(material_render_extended(s, x, 20, 12, 16, 9, &a));
    s->run = parallel.run;
    s->run_user = parallel.user;
    CHECK(material_render_extended(s, x, 20, 12, 16, 9, &b));
    CHECK(memcmp(a.pixels, b.pixels, 20 * 12 * 3 * sizeof(float)) == 0);
    image_free(&b);
    memcpy(swapped, x, sizeof x);
    for (c = 0; c < 5; ++c) {
        static const int at[5] = {0, 3, 8, 13, 19};
        swapped[at[c]] = x[at[c] + 1];
        swapped[at[c] + 1] = x[at[c]];
    }
    CHECK(material_render_extended(s, swapped, 20, 12, 16, 9, &b));
    for (k = 0; k < 20 * 12; ++k)
        same &= a.pixels[3 * k] == b.pixels[3 * k + 1] && a.pixels[3 * k + 1] == b.pixels[3 * k] &&
            a.pixels[3 * k + 2] == b.pixels[3 * k + 2];
    CHECK(same);
    image_free(&a);
    image_free(&b);
    material_scene_destroy(s);
}

static const test_case cases[] = {{"sobol points", test_sobol},
                                  {"fresnel", test_fresnel},
                                  {"beckmann density", test_beckmann},
                                  {"lobes", test_lobes},
                                  {"reciprocity", test_reciprocity},
                                  {"furnace", test_furnace},
                                  {"absorbing ball", test_absorption},
                                  {"absorbing ball, all that leaves", test_absorbing_total},
                                  {"lamps by chance", test_brute_force},
                                  {"far out on the floor", test_far},
                                  {"same bytes, swapped channels", test_same_bytes},
                                  {"extended, neutral", test_extended_neutral},
                                  {"extended, between the phases", test_extended_bounds},
                                  {"extended, reliefs", test_extended_relief},
                                  {"extended, furnace", test_extended_furnace},
                                  {"extended, same bytes, swapped channels", test_extended_same_bytes}};
TEST_MAIN(cases)
