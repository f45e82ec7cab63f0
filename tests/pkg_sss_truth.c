/* ms_sss.h against a random walk through the bust and the knot (tests/render): the closer a kernel is to the profile,
   the closer is its picture to the truth. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/truth.h"
#include "oiio.h"
#include "test.h"
#include "golden.h"

/* --- the tracer itself --- */

/* Stratification: 64 points of one pair fall into 64 columns, 64 rows and 8 x 8 cells, one in each. */
static void test_sampler(void)
{
    int columns[64] = {0}, rows[64] = {0}, cells[64] = {0}, i, pair;
    for (pair = 0; pair < 3; ++pair)
        for (i = 0; i < 64; ++i) {
            trace_sampler s;
            float u = 0, v = 0;
            int k;
            s.seed = 17;
            s.index = (uint32_t)i;
            s.pair = 0;
            for (k = 0; k <= pair; ++k) trace_sample(&s, &u, &v);
            columns[(int)(64 * u)]++;
            rows[(int)(64 * v)]++;
            cells[(int)(8 * u) * 8 + (int)(8 * v)]++;
        }
    for (i = 0; i < 64; ++i) CHECK(columns[i] == 3 && rows[i] == 3 && cells[i] == 3);
}

static void test_mesh_closed(void)
{
    int object;
    for (object = SCENE_BUST; object <= SCENE_BOWL; ++object) {
        mesh m;
        int i, k, wrong = 0;
        double volume = 0, sum[3] = {0, 0, 0};
        if (!mesh_make(&m, (scene_object)object, object == SCENE_BUST ? 4.0f : 1.5f)) {
            TEST_FAIL("no mesh of object %d", object);
            continue;
        }
        for (i = 0; i < m.triangles;
             ++i) { /* a closed surface's area vectors add up to nothing; its volume is positive */
            scene_vec p[3], n;
            for (k = 0; k < 3; ++k) {
                const float *v = m.position + 3 * m.triangle[3 * i + k];
                p[k] = scene_v(v[0], v[1], v[2]);
            }
            n = scene_mul(scene_cross(scene_sub(p[1], p[0]), scene_sub(p[2], p[0])), 0.5f);
            volume += (double)scene_dot(n, p[0]) / 3;
            sum[0] += (double)n.x;
            sum[1] += (double)n.y;
            sum[2] += (double)n.z;
            if (scene_length(n) > 0 &&
                scene_dot(scene_gradient((scene_object)object,
                                         scene_mul(scene_add(p[0], scene_add(p[1], p[2])), 1 / 3.0f), 0.5f),
                          n) < 0)
                ++wrong;
        }
        for (k = 0; k < 3; ++k) CHECK_NEAR(sum[k], 0, 1e-6 * volume); /* float rounding of 1e5 triangles */
        CHECK_LE(wrong, m.triangles / 200); /* cells of 4 mm do not resolve the folds of lids and ears */
        CHECK(volume > 0);
        TEST_NOTE("%d triangles, %.0f cm^3", m.triangles, volume / 1000);
        mesh_free(&m);
    }
}

/* Below a flat surface: with no absorption every walk returns; otherwise the total is Chandrasekhar's for diffuse
   light, 1 - 2 sqrt(1 - a) int_0^1 H(mu) mu dmu, here by its moment identity from H of the same albedo. */
static double diffuse_albedo(double a)
{
    double mu[128], h[128], moment = 0;
    int i, j, round, n = 128;
    for (i = 0; i < n; ++i) {
        mu[i] = (i + 0.5) / n;
        h[i] = 1;
    }
    for (round = 0; round < 400; ++round) /* 1 / H = sqrt(1 - a) + a/2 int mu' H(mu') / (mu + mu') dmu' */
        for (i = 0; i < n; ++i) {
            double sum = 0;
            for (j = 0; j < n; ++j) sum += mu[j] * h[j] / (mu[i] + mu[j]) / n;
            h[i] = 1 / (sqrt(1 - a) + 0.5 * a * sum);
        }
    for (i = 0; i < n; ++i) moment += h[i] * mu[i] / n;
    return 1 - 2 * sqrt(1 - a) * moment;
}

static void test_flat_total(void)
{
    static const double albedo[] = {0.3, 0.68, 0.96, 0.999};
    double radius = 1e9, energy;
    int i, walks = 1 << 17;
    for (i = 0; i < 4; ++i) {
        double expected = diffuse_albedo(albedo[i]);
        double total = trace_flat_profile((float)albedo[i], (float)(1 - albedo[i]), &radius, 1, walks, 5, &energy);
        CHECK_NEAR(total, expected,
                   4 * sqrt(0.25 / walks) + 2e-4); /* 4 standard errors at most; the midpoint rule's error */
        CHECK_NEAR(energy, total, 1e-12);
    }
}

static void test_threads(void)
{
    static const int threads[] = {1, 2, 7};
    const char *problem;
    image first = {0, 0, 0, NULL};
    truth t;
    int i;
    float mu_s[3] = {0.2f, 0.2f, 0.3f}, mu_a[3] = {0.01f, 0.05f, 0.1f};
    if (!truth_make(&t, SCENE_KNOT, TRUTH_MARBLE, 48, 27, 1, 1, NULL, &problem)) {
        TEST_FAIL("%s", problem);
        truth_free(&t);
        return;
    }
    for (i = 0; i < 3; ++i) {
        test_pool pool;
        ms_parallel parallel = test_parallel(&pool, threads[i]);
        t.t->run = parallel.run;
        t.t->run_user = parallel.user;
        memset(t.lamp[0].half[0].pixels, 0, image_count(&t.lamp[0].half[0]) * sizeof(float));
        trace_subsurface(t.t, &t.layers, mu_s, mu_a, 8, 3, &t.lamp[0].half[0]);
        if (i == 0) {
            first = image_new(48, 27, 3);
            memcpy(first.pixels, t.lamp[0].half[0].pixels, image_count(&first) * sizeof(float));
        }
        CHECK(memcmp(first.pixels, t.lamp[0].half[0].pixels, image_count(&first) * sizeof(float)) == 0);
    }
    image_free(&first);
    truth_free(&t);
}

/* --- pictures --- */

static void check_order(scene_object object, const char *name, int samples)
{
    const char *problem;
    char path[200], golden[100];
    truth t;
    truth_error unfiltered, exact;
    ms_sss_designer *designer = NULL;
    image picture;
    int i;
    if (!truth_make(&t, object, object == SCENE_BUST ? TRUTH_SKIN : TRUTH_MARBLE, 160, 90, samples, 1, NULL,
                    &problem)) {
        TEST_FAIL("%s", problem);
        truth_free(&t);
        return;
    }
    picture = image_new(t.width, t.height, 3);
    unfiltered = truth_compare(&t, &t.lamp[0].unfiltered);
    truth_filter_2d(&t, 1, &picture);
    exact = truth_compare(&t, &picture);
    TEST_NOTE("unfiltered %.1f dB, 2D kernel %.1f", unfiltered.psnr, exact.psnr);
    CHECK(ms_sss_designer_create(&designer, t.profile, t.radius_px, NULL, NULL) == MS_OK);
    for (i = 0; designer && i < TRUTH_MODELS; ++i) {
        ms_sss_kernel kernel;
        truth_error e;
        if (truth_models[i].model != MS_SSS_PREINTEGRATED && truth_models[i].model != MS_SSS_IMAGE_OPTIMAL) continue;
        CHECK(truth_kernel(designer, &truth_models[i], &kernel) == MS_OK);
        CHECK(truth_filter(&t, &kernel, truth_models[i].sigma, 1, &picture) == MS_OK);
        e = truth_compare(&t, &picture);
        TEST_NOTE("%s %.1f", truth_models[i].name, e.psnr);
        if (!(exact.relative < e.relative && e.relative < unfiltered.relative))
            TEST_FAIL("%s: error %.4f, 2D kernel %.4f, unfiltered %.4f", truth_models[i].name, e.relative,
                      exact.relative, unfiltered.relative);
        if (truth_models[i].model == MS_SSS_PREINTEGRATED && truth_models[i].sigma > 0.3) {
            snprintf(golden, sizeof golden, "%s_filtered", name);
            snprintf(path, sizeof path, "build/%s.png", golden);
            CHECK(truth_save(&t, &picture, path) == NULL);
            check_golden(golden, 45); /* other compilers round the mesh's vertices otherwise: single pixels differ */
        }
    }
    if (designer) { /* slope and elevation bring taps nearer, the round kernel in space nearer still */
        ms_sss_kernel kernel;
        truth_error flat, shaped, gathered;
        CHECK(ms_sss_kernel_build(&kernel, designer, NULL, NULL) == MS_OK);
        CHECK(truth_filter(&t, &kernel, 0, 1, &picture) == MS_OK);
        flat = truth_compare(&t, &picture);
        CHECK(truth_filter(&t, &kernel, 0, 0, &picture) == MS_OK);
        shaped = truth_compare(&t, &picture);
        CHECK(truth_gather(&t, 0, 0, &picture) == MS_OK);
        gathered = truth_compare(&t, &picture);
        TEST_NOTE("error of 7 taps flat %.1f%%, shaped %.1f%%, gathered in space %.1f%%", 100 * flat.relative,
                  100 * shaped.relative, 100 * gathered.relative);
        CHECK(shaped.relative < 0.95 * flat.relative && gathered.relative < 0.85 * shaped.relative);
        { /* the pyramid is nearer than taps, its wide gathers nearer than its narrow ones */
            ms_sss_pyramid pyramid;
            truth_error narrow, wide;
            CHECK(ms_sss_pyramid_make(&pyramid, t.profile, NULL) == MS_OK);
            CHECK(truth_pyramid(&t, &pyramid, 0, 0, &picture) == MS_OK);
            narrow = truth_compare(&t, &picture);
            CHECK(truth_pyramid(&t, &pyramid, 0, 1, &picture) == MS_OK);
            wide = truth_compare(&t, &picture);
            TEST_NOTE("pyramid %.1f%%, exact %.1f%%", 100 * narrow.relative, 100 * wide.relative);
            /* marble bends little light at its shape: nothing to gain there, 5% for the walks' noise */
            CHECK(narrow.relative < 0.95 * shaped.relative &&
                  wide.relative < (object == SCENE_BUST ? 1 : 1.05) * narrow.relative);
        }
    }
    snprintf(golden, sizeof golden, "%s_truth", name);
    snprintf(path, sizeof path, "build/%s.png", golden);
    CHECK(truth_save(&t, &t.lamp[0].half[0], path) == NULL);
    check_golden(golden, 26); /* a walk that meets another triangle first is another walk: noise differs */
    ms_sss_designer_destroy(designer);
    image_free(&picture);
    truth_free(&t);
}

static void test_bust(void) { check_order(SCENE_BUST, "bust", 96); }
static void test_knot(void)
{
    TEST_LONG;
    check_order(SCENE_KNOT, "knot", 64);
}

static const test_case cases[] = {{"sampler", test_sampler},
                                  {"mesh_closed", test_mesh_closed},
                                  {"flat_total", test_flat_total},
                                  {"threads", test_threads},
                                  {"bust", test_bust},
                                  {"knot", test_knot}};
TEST_MAIN(cases)
