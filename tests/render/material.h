/* The material-test scene of the thesis (3.5.3, fig. 3.4) as a path tracer: one fixed colorless scene, and a ball in
   it that wears any of the materials of the 19-parameter shader (tests/render/shader.h). Since nothing else has a
   color, every channel of the picture depends on that channel's parameters alone, and swapping two channels of x swaps
   those of the picture exactly.

     material_scene *s = material_scene_create(detail);     detail: 1 for pictures of 128 pixels
     material_render(s, x, size, size, samples, seed, &picture);   linear radiance, image of 3 channels
     material_render_extended(s, x, ...);                    the same for x in [0, 1]^38: textures and reliefs
     material_scene_destroy(s);

   The same bytes for any number of threads: a picture depends on x, its size, samples and seed. */
#ifndef TESTS_RENDER_MATERIAL_H
#define TESTS_RENDER_MATERIAL_H
#include "stage.h"

typedef stage material_scene;

/* Radius of the ball in the direction at angle theta from the top and phi around: a fluted belt between two grooves, a
   rosette on the cap. */
static inline float material__relief(float theta, float phi)
{
    float belt = scene__step(1.16f, 1.22f, theta) * (1 - scene__step(1.92f, 1.98f, theta));
    float groove = scene__bump(theta - 1.10f, 0.035f) + scene__bump(theta - 2.04f, 0.035f);
    float cap = scene__step(0.10f, 0.30f, theta) * (1 - scene__step(0.62f, 0.82f, theta));
    return 1 - 0.075f * groove + 0.020f * belt * cosf(28 * phi) + 0.024f * cap * cosf(8 * phi) -
        0.03f * scene__bump(theta, 0.09f);
}

/* Vertices and normals of the ball, rows x 2 rows; carved: a material with reliefs, or NULL. */
static inline void material__ball(stage_mesh_data *ball, int rows, int smooth, const material *carved)
{
    int columns = 2 * rows, r, c, k;
    for (r = 0; r <= rows; ++r)
        for (c = 0; c <= columns; ++c) {
            float theta = MATERIAL_PI * (float)r / (float)rows,
                  phi = TRACE_TURN * (float)(c % columns) / (float)columns, e = 1e-3f;
            scene_vec corner[3], n;
            for (k = 0; k < 3; ++k) {
                float t = theta + (k == 1 ? e : 0), p = phi + (k == 2 ? e : 0),
                      radius = smooth ? 1 : material__relief(t, p);
                if (carved) radius -= material_depth(carved, scene_v(sinf(t) * cosf(p), cosf(t), sinf(t) * sinf(p)));
                corner[k] = scene_v(radius * sinf(t) * cosf(p), radius * cosf(t), radius * sinf(t) * sinf(p));
            }
            n = scene_cross(scene_sub(corner[2], corner[0]), scene_sub(corner[1], corner[0]));
            if ((smooth && !carved) || scene_length(n) < 1e-9f || r == 0 || r == rows) n = corner[0];
            n = scene_normalize(n);
            if (scene_dot(n, corner[0]) < 0) n = scene_mul(n, -1);
            memcpy(ball->position + 3 * (r * (columns + 1) + c), &corner[0], 3 * sizeof(float));
            memcpy(ball->normal + 3 * (r * (columns + 1) + c), &n, 3 * sizeof(float));
        }
}

/* A ball of radius 1 around the origin as a mesh; its number, or -1. */
static inline int material_ball(stage *s, int rows, int smooth, const material *carved)
{
    int ball = stage_mesh(s, (rows + 1) * (2 * rows + 1), 4 * rows * rows);
    if (ball < 0) return -1;
    material__ball(&s->mesh[ball], rows, smooth, carved);
    stage_grid(s->mesh[ball].index, rows, 2 * rows);
    return ball;
}

/* A ring that lies around the origin at height y; its number, or -1. */
static inline int material_ring(stage *s, float radius, float thickness, float height)
{
    int rows = 48, columns = 160, r, c, ring = stage_mesh(s, (rows + 1) * (columns + 1), 2 * rows * columns);
    if (ring < 0) return -1;
    for (r = 0; r <= rows; ++r)
        for (c = 0; c <= columns; ++c) {
            float a = TRACE_TURN * (float)(r % rows) / (float)rows,
                  b = TRACE_TURN * (float)(c % columns) / (float)columns;
            float *v = s->mesh[ring].position + 3 * (r * (columns + 1) + c), out = radius + thickness * cosf(a);
            v[0] = out * cosf(b);
            v[1] = height + thickness * sinf(a);
            v[2] = out * sinf(b);
        }
    stage_grid(s->mesh[ring].index, rows, columns);
    return ring;
}

static inline void material_scene_destroy(material_scene *s) { stage_destroy(s); }

/* The ball on a ring. detail 1: 260000 triangles of 0.01; a smooth ball alone with detail < 0 (for tests). NULL: Embree
   or memory failed. */
static inline material_scene *material_scene_create(float detail)
{
    static const float gray[MATERIAL_PARAMETERS] = {0.45f, 0.45f, 0.45f};
    material_scene *s = stage_create();
    material ring_wears = material_from(gray);
    int ball, ring;
    if (s == NULL) return NULL;
    ball = material_ball(s, (int)(256 * fabsf(detail)), detail < 0, NULL);
    ring = ball < 0 ? -1 : material_ring(s, 0.68f, 0.15f, -0.91f);
    if (ring < 0) {
        stage_destroy(s);
        return NULL;
    }
    stage_place(s, ball, NULL, NULL);
    if (detail > 0) s->object[stage_place(s, ring, NULL, &ring_wears)].flat = 1;
    stage_commit(s);
    s->lamp[s->lamps++] = stage_lamp_at(scene_v(-4.2f, 2.6f, 1.2f), scene_v(1.6f, 1.9f, -1.0f), scene_v(1.5f, 0, 2.4f),
                                        scene_v(0, 0, 0), 9);
    s->lamp[s->lamps++] = stage_lamp_at(scene_v(3.2f, 0.6f, -2.6f), scene_v(0, 2.8f, 0), scene_v(0.5f, 0, 0.9f),
                                        scene_v(0, 0, 0), 12);
    s->ground.height = -1.06f;
    s->ground.wall = -3.4f;
    s->ground.bend = 1.5f;
    s->ground.tile = 0.6f;
    s->ground.light = 0.58f;
    s->ground.dark = 0.22f;
    s->sky[0] = 0.22f;
    s->sky[1] = 0.18f;
    s->sky[2] = 0.08f;
    return s;
}

typedef struct material__job {
    const material_scene *s;
    material m;
    stage_camera camera;
    int samples;
    uint32_t seed;
    image *out;
} material__job;

static inline void material__row(void *context, int y)
{
    const material__job *job = (const material__job *)context;
    int x, c;
    for (x = 0; x < job->out->width; ++x) {
        double sum[3] = {0, 0, 0};
        stage_sample(job->s, &job->m, &job->camera, job->out->width, job->out->height, x, y, job->seed, 0, job->samples,
                     sum);
        for (c = 0; c < 3; ++c)
            job->out->pixels[((size_t)y * (size_t)job->out->width + (size_t)x) * 3 + (size_t)c] = (float)(sum[c] /
                                                                                                          job->samples);
    }
}

static inline int material__render(const material_scene *s, const material *m, int width, int height, int samples,
                                   uint32_t seed, image *out)
{
    material__job job;
    int y;
    *out = image_new(width, height, 3);
    if (out->pixels == NULL) return 0;
    job.s = s;
    job.m = *m;
    job.camera.eye = scene_v(0, 1.25f, 5.6f);
    job.camera.at = scene_v(0, -0.10f, 0);
    job.camera.degrees = 27;
    job.camera.lens = job.camera.focus = 0;
    job.samples = samples;
    job.seed = seed;
    job.out = out;
    if (s->run) s->run(s->run_user, height, material__row, &job);
    else
        for (y = 0; y < height; ++y) material__row(&job, y);
    return 1;
}

/* Linear radiance; 0 where memory ran out. */
static inline int material_render(const material_scene *s, const float x[MATERIAL_PARAMETERS], int width, int height,
                                  int samples, uint32_t seed, image *out)
{
    material m = material_from(x);
    return material__render(s, &m, width, height, samples, seed, out);
}

/* Gives the ball the reliefs of m; NULL: as it was made. */
static inline void material_scene_carve(material_scene *s, const material *m)
{
    int ball = s->object[0].mesh, rows = (int)lroundf(sqrtf(0.25f * (float)s->mesh[ball].triangles));
    material__ball(&s->mesh[ball], rows, s->objects == 1, m);
    stage_mesh_changed(s, ball);
}

/* As material_render; the ball is carved for the picture where the material has reliefs. */
static inline int material_render_extended(material_scene *s, const float x[MATERIAL_EXTENDED], int width, int height,
                                           int samples, uint32_t seed, image *out)
{
    material m = material_from_extended(x);
    int done;
    if (m.carved) material_scene_carve(s, &m);
    done = material__render(s, &m, width, height, samples, seed, out);
    if (m.carved) material_scene_carve(s, NULL);
    return done;
}
#endif
