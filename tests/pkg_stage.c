/* The studio of tests/render/stage.h beyond the material-test scene: instances, the thin lens, many objects. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h" /* for ms_parallel */
#include "test.h"
#include "image.h"
#include "render/material.h"

static stage_frame random_frame(uint64_t *state)
{
    stage_frame f;
    scene_vec up = scene_v((float)test_uniform(state) - 0.5f, (float)test_uniform(state) - 0.5f,
                           (float)test_uniform(state) + 0.1f);
    f.y = scene_normalize(up);
    trace__frame(f.y, &f.z, &f.x);
    f.scale = 0.2f + 2 * (float)test_uniform(state);
    f.origin = scene_v(4 * (float)test_uniform(state), 4 * (float)test_uniform(state), 4 * (float)test_uniform(state));
    return f;
}

static stage *balls(const stage_frame *frame, const material *wears, int count)
{
    stage *s = stage_create();
    int ball = s ? material_ball(s, 256, 1, NULL) : -1, k;
    if (ball < 0) return NULL;
    for (k = 0; k < count; ++k) stage_place(s, ball, &frame[k], wears);
    stage_commit(s);
    s->bare = 1;
    s->sky[0] = 1;
    return s;
}

/* What a ray meets on an instance: the object's own place and normal, carried over by its frame. */
static void test_instances(void)
{
    uint64_t state = test_seed;
    double place = 0, radius = 0, tilt = 0;
    int k;
    for (k = 0; k < 20; ++k) {
        stage_frame f = random_frame(&state);
        material wears;
        stage *s;
        int i, met = 0;
        memset(&wears, 0, sizeof wears);
        s = balls(&f, &wears, 1);
        if (s == NULL) {
            TEST_FAIL("no scene");
            return;
        }
        for (i = 0; i < 200; ++i) {
            scene_vec aim = scene_v((float)test_uniform(&state) - 0.5f, (float)test_uniform(&state) - 0.5f,
                                    (float)test_uniform(&state) - 0.5f),
                      back, d;
            scene_vec from = scene_mad(
                scene_normalize(scene_v((float)test_uniform(&state) - 0.5f, (float)test_uniform(&state) - 0.5f, 0.3f)),
                5 * f.scale, f.origin);
            stage_hit hit;
            d = scene_normalize(scene_sub(scene_mad(aim, f.scale, f.origin), from)); /* at a point inside */
            hit = stage__nearest(s, from, d);
            if (hit.kind != STAGE_OBJECT) continue;
            ++met;
            back = scene_add(f.origin, scene_mul(stage__turn(&f, hit.place), f.scale));
            place = fmax(place, (double)(scene_length(scene_sub(back, hit.position)) / f.scale));
            radius = fmax(radius, fabs((double)scene_length(hit.place) - 1));
            tilt = fmax(tilt, 1 - (double)scene_dot(hit.shading, scene_normalize(scene_sub(hit.position, f.origin))));
        }
        CHECK(met == 200);
        stage_destroy(s);
    }
    CHECK_LE(place, 5e-6);  /* float at a distance of ten radii */
    CHECK_LE(radius, 1e-4); /* facets of 0.012 lie 0.012^2 / 8 below the ball, and rounding */
    CHECK_LE(tilt, 1e-5);
    TEST_NOTE("place %.1e, radius %.1e, normal %.1e", place, radius, tilt);
}

/* Absorption is per radius of the object: exp(-2 absorption) through the middle of an index-matched ball of any
   size. */
static void test_sizes(void)
{
    uint64_t state = test_seed;
    int k;
    for (k = 0; k < 6; ++k) {
        float x[19];
        stage_frame f = random_frame(&state);
        material m;
        stage *s;
        double sum = 0, expected = exp(-2 * 4 * 0.15);
        int i;
        memset(x, 0, sizeof x);
        x[8] = x[9] = x[10] = x[17] = 1;
        x[12] = 0.01f;
        x[18] = 0.15f;
        m = material_from(x);
        s = balls(&f, &m, 1);
        if (s == NULL) {
            TEST_FAIL("no scene");
            return;
        }
        for (i = 0; i < 4000; ++i) {
            trace_sampler sampler;
            float out[3];
            memset(&sampler, 0, sizeof sampler);
            sampler.seed = 7;
            sampler.index = (uint32_t)i;
            stage_path(s, NULL, &sampler, scene_mad(scene_normalize(scene_v(0.3f, 0.4f, 1)), 6 * f.scale, f.origin),
                       scene_mul(scene_normalize(scene_v(0.3f, 0.4f, 1)), -1), out);
            sum += (double)out[0] / 4000;
        }
        CHECK_NEAR(sum, expected,
                   5e-3 * expected); /* facets of 0.01, the start 2e-4 below the surface of a ball of 0.2 */
        stage_destroy(s);
    }
}

/* Hundreds of white diffuse and clear glass balls under a sky of 1 are invisible. */
static void test_crowd(void)
{
    enum { COUNT = 200 };
    static stage_frame frame[COUNT];
    int k, glass;
    for (k = 0; k < COUNT; ++k) { /* on a grid: no two touch */
        frame[k].x = scene_v(1, 0, 0);
        frame[k].y = scene_v(0, 1, 0);
        frame[k].z = scene_v(0, 0, 1);
        frame[k].scale = 0.45f;
        frame[k].origin = scene_v((float)(k % 10) - 4.5f, 0, -(float)(k / 10));
    }
    for (glass = 0; glass < 2; ++glass) {
        float x[19];
        material m;
        stage_camera camera;
        stage *s;
        double sum[3] = {0, 0, 0};
        memset(x, 0, sizeof x);
        x[0] = x[8] = 1;
        x[12] = 0.5f;
        x[17] = (float)glass;
        m = material_from(x);
        s = balls(frame, &m, COUNT);
        if (s == NULL) {
            TEST_FAIL("no scene");
            return;
        }
        memset(&camera, 0, sizeof camera);
        camera.eye = scene_v(0, 4, 4);
        camera.at = scene_v(0, 0, -3);
        camera.degrees = 40;
        for (k = 0; k < 24 * 24; ++k) stage_sample(s, NULL, &camera, 24, 24, k % 24, k / 24, 3, 0, 16, sum);
        sum[0] /= 24 * 24 * 16;
        /* the roulette is unbiased, its noise below 1%; lost: paths of more than 32 bounces, which glass has among
           glass */
        CHECK(sum[0] <= 1 + 1e-2 && sum[0] >= 1 - (glass ? 5e-2 : 1e-2));
        TEST_NOTE("%s: mean %.4f", glass ? "glass" : "white", sum[0]);
        stage_destroy(s);
    }
}

/* A lamp in the sharp plane looks the same through any lens; nearer, the same light spreads over more pixels. */
static void test_lens(void)
{
    stage *s = stage_create();
    stage_camera camera;
    double sum[3], spread[3];
    int k, j;
    if (s == NULL) {
        TEST_FAIL("no scene");
        return;
    }
    stage_commit(s);
    s->ground.height = -1000;
    s->ground.wall = -1000;
    s->ground.bend = 1;
    s->ground.tile = 1;
    memset(&camera, 0, sizeof camera);
    camera.eye = scene_v(0, 0, 10);
    camera.degrees = 30;
    camera.focus = 10;
    s->lamps = 1;
    for (k = 0; k < 3; ++k) { /* pinhole; lens, lamp in focus; lens, lamp half as far and half as large */
        float f = k == 2 ? 0.5f : 1;
        s->lamp[0] = stage_lamp_at(scene_v(-0.8f * f, -0.8f * f, k == 2 ? 5.0f : 0), scene_v(1.6f * f, 0, 0),
                                   scene_v(0, 1.6f * f, 0), camera.eye, 1);
        camera.lens = k == 0 ? 0 : 0.4f;
        sum[k] = spread[k] = 0;
        for (j = 0; j < 64 * 64; ++j) {
            double v[3] = {0, 0, 0};
            stage_sample(s, NULL, &camera, 64, 64, j % 64, j / 64, 5, 0, 64, v);
            sum[k] += v[0] / 64;
            spread[k] += v[0] > 0;
        }
    }
    CHECK_NEAR(sum[1], sum[0], 2e-3 * sum[0]); /* the rim of pixels that the lamp covers in part, 64 samples each */
    CHECK_NEAR(sum[2], sum[0], 1e-2 * sum[0]); /* the lens sees the near lamp under other angles, cos^4 at most */
    CHECK(fabs(spread[1] - spread[0]) <= 4);   /* corners that one in 64 samples may meet or not */
    CHECK(spread[2] > 1.5 * spread[0]);
    TEST_NOTE("light %.1f, %.1f, %.1f on %.0f, %.0f, %.0f pixels", sum[0], sum[1], sum[2], spread[0], spread[1],
              spread[2]);
    stage_destroy(s);
}

static const test_case cases[] = {
    {"instances", test_instances}, {"absorption of any size", test_sizes}, {"crowd", test_crowd}, {"lens", test_lens}};
TEST_MAIN(cases)
