/* What tests/render/hero.c does around the tracer: tastes, the arrangement, the development of passes. */
#define main hero_main
#include "render/hero.c"
#undef main
#include "test.h"

/* Scores lie in [0, 10], a random gallery has few good ones, and what the taste describes is among the best. */
static void test_tastes(void)
{
    static const char *const tastes[] = {"crystal", "glass", "metal", "lacquer", "wax"};
    float ideal[5][MATERIAL_PARAMETERS];
    uint64_t state = test_seed;
    int t, k, i;
    memset(ideal, 0, sizeof ideal);
    for (t = 0; t < 5; ++t) { /* orange where it has a color */
        float *x = ideal[t];
        for (k = 0; k < 4; ++k) {
            static const int color[4] = {0, 3, 8, 13};
            x[color[k]] = 1;
            x[color[k] + 1] = 0.6f;
            x[color[k] + 2] = 0.4f;
        }
        x[12] = 0.5f;
        x[17] = t < 2 || t == 4;
    }
    ideal[0][9] = ideal[0][10] = 1;
    ideal[2][6] = 0.35f;
    ideal[2][7] = 1;
    ideal[3][4] = ideal[3][5] = 1;
    ideal[3][7] = 0.3f;
    ideal[4][16] = 0.7f;
    for (t = 0; t < 5; ++t) {
        int good = 0;
        float best = taste_of(tastes[t], ideal[t]);
        CHECK(best > 9.9f && best <= 10.001f);
        for (i = 0; i < 2000; ++i) {
            float x[MATERIAL_PARAMETERS], score;
            for (k = 0; k < MATERIAL_PARAMETERS; ++k) x[k] = (float)test_uniform(&state);
            score = taste_of(tastes[t], x);
            CHECK(score >= 0 && score <= best);
            good += score > 5;
        }
        CHECK(good < 400);
        TEST_NOTE("%s: %.1f, %d of 2000 above 5", tastes[t], (double)best, good);
    }
}

/* Everything stands on the ground, and no two of the smaller things share a place. */
static void test_arrangement(void)
{
    enum { COUNT = 209 };
    static float x[COUNT][MATERIAL_PARAMETERS];
    static const float *row[COUNT];
    uint64_t state = test_seed;
    stage *s;
    double closest = 10;
    int i, k;
    for (i = 0; i < COUNT; ++i) {
        for (k = 0; k < MATERIAL_PARAMETERS; ++k) x[i][k] = (float)test_uniform(&state);
        row[i] = x[i];
    }
    s = make_scene(row, COUNT);
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    CHECK(s->objects == COUNT);
    for (i = 0; i < COUNT; ++i) {
        const stage_object *o = &s->object[i];
        const stage_mesh_data *m = &s->mesh[o->mesh];
        float lowest = 10;
        for (k = 0; k < m->vertices; ++k) {
            const float *p = m->position + 3 * k;
            lowest = scene__min(
                lowest, o->frame.origin.y + o->frame.scale * stage__turn(&o->frame, scene_v(p[0], p[1], p[2])).y);
        }
        CHECK_NEAR((double)lowest, 0.002, 1e-5);
    }
    CHECK(row[0] == x[0]); /* the first stays in the middle */
    for (i = 1; i < COUNT; ++i)
        for (k = 1; k < i; ++k) {
            const stage_frame *a = &s->object[i].frame, *b = &s->object[k].frame;
            double dx = (double)(a->origin.x - b->origin.x), dz = (double)(a->origin.z - b->origin.z);
            closest = fmin(closest, sqrt(dx * dx + dz * dz) / (double)(a->scale + b->scale));
        }
    CHECK(closest > 1);
    for (i = 2; i < COUNT; ++i) CHECK(hue_of(row[i - 1]) <= hue_of(row[i]));
    TEST_NOTE("%.3f of the sum of radii at least", closest);
    stage_destroy(s);
}

static void test_robust_mean(void)
{
    float estimate[16][3], out[3];
    const float *sorted[16];
    int k, c;
    for (k = 0; k < 16; ++k) {
        sorted[k] = estimate[k];
        for (c = 0; c < 3; ++c) estimate[k][c] = 0.95f + 0.1f * (float)k / 15;
    }
    robust_mean(sorted, 16, out);
    CHECK_NEAR((double)out[1], 1, 1e-6); /* nothing is cut: the plain mean, rounding */
    for (c = 0; c < 3; ++c) estimate[15][c] = 500;
    robust_mean(sorted, 16, out);
    CHECK_NEAR((double)out[1], 1, 0.05); /* within the others */
    for (k = 0; k < 16; ++k) estimate[k][0] = estimate[k][1] = estimate[k][2] = 0;
    robust_mean(sorted, 16, out);
    CHECK(out[0] == 0);
}

static float developed(float v) { return image_srgb_encode(scene_tone(1.15f * v)); }

/* Two flat halves with an edge: without noise they come out exactly, with noise smoother than the plain mean. */
static void test_develop(void)
{
    enum { PASSES = 8, SIZE = 40 };
    image pass[PASSES], out;
    uint64_t state = test_seed;
    double plain = 0, smoothed = 0;
    int noisy, k, i;
    for (noisy = 0; noisy < 2; ++noisy) {
        for (k = 0; k < PASSES; ++k) {
            pass[k] = image_new(SIZE, SIZE, 3);
            for (i = 0; i < SIZE * SIZE * 3; ++i)
                pass[k].pixels[i] = (i / 3 % SIZE < SIZE / 2 ? 0.1f : 0.6f) *
                    (noisy ? 0.5f + (float)test_uniform(&state) : 1);
        }
        CHECK(develop(pass, PASSES, &out) == NULL);
        for (i = 0; i < SIZE * SIZE * 3; ++i) {
            float truth = i / 3 % SIZE < SIZE / 2 ? 0.1f : 0.6f, mean = 0;
            double gap = (double)(out.pixels[i] - developed(truth));
            for (k = 0; k < PASSES; ++k) mean += pass[k].pixels[i] / (float)PASSES;
            if (!noisy) CHECK_LE(fabs(gap), 1e-5);
            smoothed += gap * gap;
            gap = (double)(developed(mean) - developed(truth));
            plain += gap * gap;
        }
        for (k = 0; k < PASSES; ++k) image_free(&pass[k]);
        image_free(&out);
    }
    CHECK(smoothed < 0.1 * plain); /* 15 x 15 pixels look alike, half of them at the edge */
    TEST_NOTE("squared error %.3f of the plain mean's", smoothed / plain);
}

static const test_case cases[] = {{"tastes", test_tastes},
                                  {"arrangement", test_arrangement},
                                  {"mean without outliers", test_robust_mean},
                                  {"development", test_develop}};
TEST_MAIN(cases)
