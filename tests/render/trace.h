/* A path tracer on Embree 3 or 4, for reference pictures. Here: what a camera sees of a closed mesh, the light that
   arrives on it from round lamps, and its subsurface scattering by a random walk. One sampler, pixel by pixel: the same
   bytes for any number of threads.

     tracer *t = trace_create(&m, lights, count);      m: tests/render/mesh.h; lights: examples/demo/scene.h
     trace_primary(t, &camera, width, height, layers); the G-buffer: position, normal, depth
     trace_irradiance, trace_subsurface                what arrives, and what leaves, lamp by lamp
     trace_destroy(t);

   The mesh is index-matched: light enters with a cosine distribution, scatters isotropically, and leaves where the walk
   meets the surface again, with a cosine distribution. */
#ifndef TESTS_RENDER_TRACE_H
#define TESTS_RENDER_TRACE_H
#if defined(__has_include)
#if __has_include(<embree4/rtcore.h>)
#define TRACE_EMBREE 4
#include <embree4/rtcore.h>
#endif
#endif
#ifndef TRACE_EMBREE
#define TRACE_EMBREE 3
#include <embree3/rtcore.h>
#endif
#include "mesh.h"

/* --- samples: Owen-scrambled Sobol points, a fresh scramble and order for each pair of dimensions ---
   Burley, "Practical hash-based Owen scrambling", JCGT 9(4), 2020. */

#define TRACE_SOBOL_PAIRS 8u       /* pairs of a walk that are stratified; the rest is white noise */
#define TRACE_LAMP_PAIR (1u << 20) /* lamps draw these pairs, however long the walk before was */

typedef struct trace_sampler {
    uint32_t seed, index; /* of the pixel; of the sample */
    uint32_t pair;        /* pairs drawn so far */
} trace_sampler;

static inline uint32_t trace__hash(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

static inline uint32_t trace__reverse(uint32_t x)
{
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
}

/* Nested uniform scrambling of the bits from the highest down (Laine and Karras's hash on reversed bits). */
static inline uint32_t trace__scramble(uint32_t x, uint32_t seed)
{
    x = trace__reverse(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return trace__reverse(x);
}

/* Sobol's second dimension from the first: Pascal's triangle mod 2, the fifth Kronecker power of (1 1; 0 1). */
static inline uint32_t trace__pascal(uint32_t x)
{
    x ^= x << 16;
    x ^= (x & 0x00ff00ffu) << 8;
    x ^= (x & 0x0f0f0f0fu) << 4;
    x ^= (x & 0x33333333u) << 2;
    return x ^ (x & 0x55555555u) << 1;
}

/* The next pair of numbers in [0, 1). */
static inline void trace_sample(trace_sampler *s, float *u, float *v)
{
    uint32_t seed = trace__hash(s->seed ^ trace__hash(s->pair++)), i, x, y;
    if (s->pair > TRACE_SOBOL_PAIRS && s->pair < TRACE_LAMP_PAIR) { /* deep in a walk order no longer helps */
        *u = (float)(trace__hash(seed ^ s->index) >> 8) * (1.0f / 16777216.0f);
        *v = (float)(trace__hash(seed + 0x9e3779b9u + s->index) >> 8) * (1.0f / 16777216.0f);
        return;
    }
    i = trace__scramble(s->index, seed);
    x = trace__reverse(i);
    y = trace__pascal(x);
    x = trace__scramble(x, trace__hash(seed ^ 0xa511e9b3u));
    y = trace__scramble(y, trace__hash(seed ^ 0x63d83595u));
    *u = (float)(x >> 8) * (1.0f / 16777216.0f);
    *v = (float)(y >> 8) * (1.0f / 16777216.0f);
}

/* --- directions --- */

static inline void trace__frame(scene_vec n, scene_vec *a, scene_vec *b)
{
    *a = scene_normalize(fabsf(n.x) > 0.7f ? scene_cross(n, scene_v(0, 1, 0)) : scene_cross(n, scene_v(1, 0, 0)));
    *b = scene_cross(n, *a);
}

static inline scene_vec trace__around(scene_vec axis, float cosine, float turn)
{
    scene_vec a, b;
    float sine = sqrtf(scene__max(0, 1 - cosine * cosine));
    trace__frame(axis, &a, &b);
    return scene_add(scene_mul(axis, cosine),
                     scene_mul(scene_add(scene_mul(a, cosf(turn)), scene_mul(b, sinf(turn))), sine));
}

#define TRACE_TURN 6.28318531f

/* --- the scene --- */

typedef struct tracer {
    RTCDevice device;
    RTCScene scene;
    const mesh *m;
    scene_light light[8];
    int lights;
    float nudge; /* mm by which rays start off the surface */
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context); /* NULL: no threads */
    void *run_user;
} tracer;

static inline void trace_destroy(tracer *t)
{
    if (t == NULL) return;
    if (t->scene) rtcReleaseScene(t->scene);
    if (t->device) rtcReleaseDevice(t->device);
    free(t);
}

/* The mesh must live as long as the tracer. NULL: Embree or memory failed. */
static inline tracer *trace_create(const mesh *m, const scene_light *light, int lights)
{
    tracer *t = (tracer *)calloc(1, sizeof *t);
    RTCGeometry g;
    if (t == NULL) return NULL;
    t->device = rtcNewDevice("threads=1,set_affinity=0");
    t->scene = t->device ? rtcNewScene(t->device) : NULL;
    g = t->device ? rtcNewGeometry(t->device, RTC_GEOMETRY_TYPE_TRIANGLE) : NULL;
    if (t->scene == NULL || g == NULL || lights > 8) {
        trace_destroy(t);
        return NULL;
    }
    t->m = m;
    t->lights = lights;
    memcpy(t->light, light, (size_t)lights * sizeof *light);
    t->nudge = 1e-3f;
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, m->position, 0, 12,
                               (size_t)m->vertices);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, m->triangle, 0, 12, (size_t)m->triangles);
    rtcCommitGeometry(g);
    rtcAttachGeometry(t->scene, g);
    rtcReleaseGeometry(g);
    rtcSetSceneFlags(t->scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(t->scene);
    return t;
}

typedef struct trace_hit {
    float t;
    int triangle;     /* -1: nothing */
    scene_vec normal; /* of the triangle, outwards */
} trace_hit;

static inline struct RTCRay trace__ray(scene_vec from, scene_vec direction, float end)
{
    struct RTCRay r;
    memset(&r, 0, sizeof r);
    r.org_x = from.x;
    r.org_y = from.y;
    r.org_z = from.z;
    r.dir_x = direction.x;
    r.dir_y = direction.y;
    r.dir_z = direction.z;
    r.tfar = end;
    r.mask = 0xffffffffu;
    return r;
}

static inline trace_hit trace_nearest(const tracer *t, scene_vec from, scene_vec direction, float end)
{
    struct RTCRayHit r;
    trace_hit hit;
    r.ray = trace__ray(from, direction, end);
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if TRACE_EMBREE == 4
    rtcIntersect1(t->scene, &r, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(t->scene, &context, &r);
#endif
    hit.t = r.ray.tfar;
    hit.triangle = r.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : (int)r.hit.primID;
    hit.normal = scene_v(0, 0, 0);
    if (hit.triangle >= 0) hit.normal = scene_normalize(scene_v(r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z));
    return hit;
}

static inline int trace_blocked(const tracer *t, scene_vec from, scene_vec direction, float end)
{
    struct RTCRay r = trace__ray(from, direction, end);
#if TRACE_EMBREE == 4
    rtcOccluded1(t->scene, &r, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(t->scene, &context, &r);
#endif
    return r.tfar < 0;
}

/* Irradiance over pi at p from lamp i, added to out, by one point on it: uniform in the cone that the lamp fills. */
static inline void trace__lamp(const tracer *t, int i, trace_sampler *s, scene_vec p, scene_vec n, float out[3])
{
    const scene_light *l = &t->light[i];
    scene_vec from = scene_mad(n, t->nudge, p), to = scene_sub(l->position, from), direction;
    float d2 = scene_dot(to, to), d = sqrtf(d2), u, v, least, cosine;
    int c;
    trace_sample(s, &u, &v);
    least = sqrtf(scene__max(0, 1 - l->radius * l->radius / d2));
    direction = trace__around(scene_mul(to, 1 / d), 1 - u * (1 - least), TRACE_TURN * v);
    cosine = scene_dot(n, direction);
    if (cosine <= 0 || trace_blocked(t, from, direction, d - l->radius)) return;
    for (c = 0; c < 3; ++c) out[c] += l->power[c] * cosine * scene_dot(l->position, l->position) / (d2 * 3.14159265f);
}

/* --- layers: what is seen through the middle of every pixel --- */

typedef struct trace_layers {
    int width, height;
    scene_vec *position, *normal; /* [height][width] */
    int *triangle;                /* -1: the background */
    image depth;                  /* mm along the viewing direction; 0 for the background */
} trace_layers;

static inline void trace_layers_free(trace_layers *l)
{
    free(l->position);
    free(l->normal);
    free(l->triangle);
    image_free(&l->depth);
    memset(l, 0, sizeof *l);
}

/* What each row's task gets. */
typedef struct trace__job {
    const tracer *t;
    const scene_camera *camera;
    trace_layers *layers;
    image *out;
    int samples;
    int lamp;
    uint32_t seed;
    const float *mu_s, *mu_a;
} trace__job;

static inline void trace__rows(const tracer *t, int count, void (*task)(void *context, int index), trace__job *job)
{
    int i;
    if (t->run) t->run(t->run_user, count, task, job);
    else
        for (i = 0; i < count; ++i) task(job, i);
}

static inline void trace__primary_row(void *context, int y)
{
    trace__job *job = (trace__job *)context;
    trace_layers *l = job->layers;
    int x;
    for (x = 0; x < l->width; ++x) {
        int at = y * l->width + x;
        scene_vec ray = scene_ray(job->camera, l->width, l->height, (float)x + 0.5f, (float)y + 0.5f);
        trace_hit hit = trace_nearest(job->t, job->camera->eye, ray, 1e9f);
        l->triangle[at] = hit.triangle;
        if (hit.triangle < 0) continue;
        l->position[at] = scene_mad(ray, hit.t, job->camera->eye);
        l->normal[at] = hit.normal;
        l->depth.pixels[at] = -scene_dot(ray, job->camera->back) * hit.t;
    }
}

/* 0 where memory ran out. */
static inline int trace_primary(const tracer *t, const scene_camera *camera, int width, int height, trace_layers *l)
{
    trace__job job;
    size_t n = (size_t)width * (size_t)height;
    memset(l, 0, sizeof *l);
    memset(&job, 0, sizeof job);
    l->width = width;
    l->height = height;
    l->position = (scene_vec *)calloc(n, sizeof *l->position);
    l->normal = (scene_vec *)calloc(n, sizeof *l->normal);
    l->triangle = (int *)calloc(n, sizeof *l->triangle);
    l->depth = image_new(width, height, 1);
    if (!l->position || !l->normal || !l->triangle || !l->depth.pixels) {
        trace_layers_free(l);
        return 0;
    }
    job.t = t;
    job.camera = camera;
    job.layers = l;
    trace__rows(t, height, trace__primary_row, &job);
    return 1;
}

static inline trace_sampler trace__sampler(const trace__job *job, int pixel, int index)
{
    trace_sampler s;
    s.seed = trace__hash(trace__hash((uint32_t)pixel) ^ job->seed);
    s.index = (uint32_t)index;
    s.pair = 0;
    return s;
}

static inline void trace__irradiance_row(void *context, int y)
{
    trace__job *job = (trace__job *)context;
    int x, i, c, width = job->layers->width;
    for (x = 0; x < width; ++x) {
        int at = y * width + x;
        double sum[3] = {0, 0, 0};
        if (job->layers->triangle[at] < 0) continue;
        for (i = 0; i < job->samples; ++i) {
            trace_sampler s = trace__sampler(job, at, i);
            float e[3] = {0, 0, 0};
            trace__lamp(job->t, job->lamp, &s, job->layers->position[at], job->layers->normal[at], e);
            for (c = 0; c < 3; ++c) sum[c] += (double)e[c];
        }
        for (c = 0; c < 3; ++c) job->out->pixels[3 * at + c] = (float)(sum[c] / job->samples);
    }
}

/* out: RGB of the layers' size, irradiance over pi from one lamp. */
static inline void trace_irradiance(const tracer *t, const trace_layers *l, int lamp, int samples, uint32_t seed,
                                    image *out)
{
    trace__job job;
    memset(&job, 0, sizeof job);
    job.t = t;
    job.layers = (trace_layers *)l;
    job.out = out;
    job.lamp = lamp;
    job.samples = samples;
    job.seed = seed;
    trace__rows(t, l->height, trace__irradiance_row, &job);
}

/* --- subsurface scattering --- */

/* Where a walk that enters at p (normal n) comes out: its weight (the product of albedos, or 1 and 0 by roulette), the
   place and the normal there. 0: absorbed, or lost through a gap of the mesh. */
static inline float trace__walk(const tracer *t, trace_sampler *s, float mu_s, float mu_a, scene_vec *p, scene_vec *n)
{
    float mu_t = mu_s + mu_a, albedo = mu_s / mu_t, weight = 1, u, v;
    scene_vec at = scene_mad(*n, -t->nudge, *p), direction;
    trace_sample(s, &u, &v);
    direction = trace__around(scene_mul(*n, -1), sqrtf(1 - u), TRACE_TURN * v);
    while (weight > 0) {
        float length;
        trace_hit hit;
        trace_sample(s, &u, &v);
        length = -logf(1 - u) / mu_t;
        hit = trace_nearest(t, at, direction, length);
        if (hit.triangle >= 0) {
            if (scene_dot(hit.normal, direction) <= 0) return 0; /* seen from outside: it slipped through an edge */
            *p = scene_mad(direction, hit.t, at);
            *n = hit.normal;
            return weight;
        }
        at = scene_mad(direction, length, at);
        weight *= albedo;
        if (weight < 0.2f) weight = v < weight ? 1.0f : 0.0f; /* Russian roulette */
        trace_sample(s, &u, &v);
        direction = trace__around(scene_v(0, 0, 1), 1 - 2 * u, TRACE_TURN * v);
    }
    return 0;
}

static inline void trace__subsurface_row(void *context, int y)
{
    trace__job *job = (trace__job *)context;
    int x, i, c, k, width = job->layers->width;
    for (x = 0; x < width; ++x) {
        int at = y * width + x;
        if (job->layers->triangle[at] < 0) continue;
        for (c = 0; c < 3; ++c) {
            double sum[8] = {0, 0, 0, 0, 0, 0, 0, 0};
            for (i = 0; i < job->samples; ++i) {
                trace_sampler s = trace__sampler(job, at, i);
                scene_vec p = job->layers->position[at], n = job->layers->normal[at];
                float weight = trace__walk(job->t, &s, job->mu_s[c], job->mu_a[c], &p, &n);
                if (weight <= 0) continue;
                s.pair = TRACE_LAMP_PAIR;
                for (k = 0; k < job->t->lights; ++k) {
                    float e[3] = {0, 0, 0};
                    trace__lamp(job->t, k, &s, p, n, e);
                    sum[k] += (double)(weight * e[c]);
                }
            }
            for (k = 0; k < job->t->lights; ++k) job->out[k].pixels[3 * at + c] = (float)(sum[k] / job->samples);
        }
    }
}

/* The same walk below a flat surface, z = 0: how much of the light that enters at the origin with a cosine distribution
   leaves up to each radius[i] (growing, in mm): energy[i], a fraction of what enters, and in all. */
static inline double trace_flat_profile(float mu_s, float mu_a, const double *radius, int n, int walks, uint32_t seed,
                                        double *energy)
{
    float mu_t = mu_s + mu_a, albedo = mu_s / mu_t, u, v;
    double total = 0;
    int i, k;
    for (i = 0; i < n; ++i) energy[i] = 0;
    for (k = 0; k < walks; ++k) {
        scene_vec at = scene_v(0, 0, 0), direction;
        trace_sampler s;
        float weight = 1, length;
        s.seed = seed;
        s.index = (uint32_t)k;
        s.pair = 0;
        trace_sample(&s, &u, &v);
        direction = trace__around(scene_v(0, 0, -1), sqrtf(1 - u), TRACE_TURN * v);
        while (weight > 0) {
            trace_sample(&s, &u, &v);
            length = -logf(1 - u) / mu_t;
            if (at.z + length * direction.z > 0) break;
            at = scene_mad(direction, length, at);
            weight *= albedo;
            if (weight < 0.2f) weight = v < weight ? 1.0f : 0.0f; /* Russian roulette */
            trace_sample(&s, &u, &v);
            direction = trace__around(scene_v(0, 0, 1), 1 - 2 * u, TRACE_TURN * v);
        }
        if (weight > 0) {
            at = scene_mad(direction, -at.z / direction.z, at);
            total += (double)weight;
            for (i = n - 1; i >= 0 && radius[i] > sqrt((double)(at.x * at.x + at.y * at.y)); --i)
                energy[i] += (double)weight;
        }
    }
    for (i = 0; i < n; ++i) energy[i] /= walks;
    return total / walks;
}

/* out [t->lights]: RGB radiance that leaves towards the camera by each lamp alone. Coefficients per mm; isotropic
   scattering. */
static inline void trace_subsurface(const tracer *t, const trace_layers *l, const float mu_s_per_mm[3],
                                    const float mu_a_per_mm[3], int samples, uint32_t seed, image *out)
{
    trace__job job;
    memset(&job, 0, sizeof job);
    job.t = t;
    job.layers = (trace_layers *)l;
    job.out = out;
    job.samples = samples;
    job.seed = seed;
    job.mu_s = mu_s_per_mm;
    job.mu_a = mu_a_per_mm;
    trace__rows(t, l->height, trace__subsurface_row, &job);
}
#endif
