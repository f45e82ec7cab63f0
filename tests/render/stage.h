/* A path tracer of small studios on Embree 3 or 4: objects, each with a material of shader.h, on a ground that curves
   up into a wall, under a sky and lamps (rectangles). tests/render/material.h and hero.c are two such studios.

     stage *s = stage_create();
     int ball = stage_mesh(s, vertices, triangles);              fill s->mesh[ball].position, normal, index
     stage_place(s, ball, NULL, &material);                      or instances, each in its frame and with its material
     s->lamp[s->lamps++] = stage_lamp_at(corner, a, b, towards, radiance);
     stage_commit(s);                                            before rendering
     stage_sample(s, NULL, &camera, width, height, x, y, seed, first, count, sum);
     stage_destroy(s);

   Lamps are sampled as well as found by chance, combined by the power heuristic (Veach 1997). A sample depends on its
   arguments alone: the same bytes for any number of threads. */
#ifndef TESTS_RENDER_STAGE_H
#define TESTS_RENDER_STAGE_H
#include "shader.h"

enum { STAGE_MESHES = 16, STAGE_OBJECTS = 512, STAGE_LAMPS = 4 };

typedef struct stage_mesh_data {
    float *position, *normal; /* [vertices][3]; room for one more position, since Embree reads 16 bytes from each */
    uint32_t *index;          /* [triangles][3], counter-clockwise seen from outside */
    int vertices, triangles;
    RTCGeometry geometry;
    RTCScene scene; /* of the instances */
} stage_mesh_data;

typedef struct stage_frame { /* where an instance stands: its axes have length 1 */
    scene_vec x, y, z, origin;
    float scale;
} stage_frame;

typedef struct stage_object {
    int mesh, flat, instance; /* flat: shaded with the triangles' normals */
    stage_frame frame;
    int dressed; /* 0: wears what the picture is asked for */
    material wears;
} stage_object;

typedef struct stage_lamp { /* a rectangle that shines to one side */
    scene_vec corner, a, b, normal;
    float radiance, area, color[3];
} stage_lamp;

typedef struct stage_ground { /* a chequered floor y = height that bends up into a wall z = wall */
    float height, wall, bend, tile, light, dark, color[3];
} stage_ground;

typedef struct stage_camera {
    scene_vec eye, at;
    float degrees, lens, focus; /* vertical angle; radius of the lens (0: a pinhole), distance of the sharp plane */
} stage_camera;

typedef struct stage {
    RTCDevice device;
    RTCScene embree;
    stage_mesh_data mesh[STAGE_MESHES];
    stage_object object[STAGE_OBJECTS];
    stage_lamp lamp[STAGE_LAMPS];
    int meshes, objects, lamps;
    stage_ground ground;
    float sky[3]; /* radiance of the sky in direction d: sky[0] + sky[1] d.y + sky[2] d.z */
    float sky_color[3];
    scene_vec low, high; /* box of the objects */
    int bare;            /* non-zero: the objects alone under the sky (for tests) */
    int brute;           /* non-zero: lamps are found by chance only (for tests) */
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context); /* NULL: no threads */
    void *run_user;
} stage;

/* --- building --- */

static inline void stage_destroy(stage *s)
{
    int k;
    if (s == NULL) return;
    for (k = 0; k < s->meshes; ++k) {
        if (s->mesh[k].scene) rtcReleaseScene(s->mesh[k].scene);
        if (s->mesh[k].geometry) rtcReleaseGeometry(s->mesh[k].geometry);
    }
    if (s->embree) rtcReleaseScene(s->embree);
    if (s->device) rtcReleaseDevice(s->device);
    for (k = 0; k < s->meshes; ++k) {
        free(s->mesh[k].position);
        free(s->mesh[k].normal);
        free(s->mesh[k].index);
    }
    free(s);
}

/* NULL: Embree or memory failed. */
static inline stage *stage_create(void)
{
    stage *s = (stage *)calloc(1, sizeof *s);
    int c;
    if (s == NULL) return NULL;
    s->device = rtcNewDevice("threads=1,set_affinity=0");
    s->embree = s->device ? rtcNewScene(s->device) : NULL;
    if (s->embree == NULL) {
        stage_destroy(s);
        return NULL;
    }
    for (c = 0; c < 3; ++c) s->ground.color[c] = s->sky_color[c] = 1;
    return s;
}

/* A mesh to be filled, by its number; -1: no memory. */
static inline int stage_mesh(stage *s, int vertices, int triangles)
{
    stage_mesh_data *m = &s->mesh[s->meshes];
    if (s->meshes == STAGE_MESHES) return -1;
    memset(m, 0, sizeof *m);
    m->vertices = vertices;
    m->triangles = triangles;
    m->position = (float *)calloc(3 * (size_t)vertices + 4, sizeof(float));
    m->normal = (float *)calloc(3 * (size_t)vertices, sizeof(float));
    m->index = (uint32_t *)calloc(3 * (size_t)triangles, sizeof(uint32_t));
    m->geometry = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    ++s->meshes; /* from here on stage_destroy frees it */
    if (!m->position || !m->normal || !m->index || !m->geometry) return -1;
    rtcSetSharedGeometryBuffer(m->geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, m->position, 0, 12,
                               (size_t)vertices);
    rtcSetSharedGeometryBuffer(m->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, m->index, 0, 12,
                               (size_t)triangles);
    return s->meshes - 1;
}

/* The filled mesh in the scene; frame NULL: as it is, once; otherwise an instance. -1: too many. */
static inline int stage_place(stage *s, int which, const stage_frame *frame, const material *wears)
{
    stage_mesh_data *m = &s->mesh[which];
    stage_object *o = &s->object[s->objects];
    if (s->objects == STAGE_OBJECTS) return -1;
    memset(o, 0, sizeof *o);
    o->mesh = which;
    if (wears) o->wears = *wears;
    o->dressed = wears != NULL;
    o->frame.scale = 1;
    rtcCommitGeometry(m->geometry);
    if (frame == NULL) {
        rtcAttachGeometryByID(s->embree, m->geometry, (unsigned)s->objects);
    } else {
        RTCGeometry g = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_INSTANCE);
        scene_vec x = scene_mul(frame->x, frame->scale), y = scene_mul(frame->y, frame->scale),
                  z = scene_mul(frame->z, frame->scale);
        float columns[12];
        if (m->scene == NULL) {
            m->scene = rtcNewScene(s->device);
            rtcSetSceneFlags(m->scene, RTC_SCENE_FLAG_ROBUST);
            rtcAttachGeometry(m->scene, m->geometry);
            rtcCommitScene(m->scene);
        }
        memcpy(columns, &x, sizeof x);
        memcpy(columns + 3, &y, sizeof y);
        memcpy(columns + 6, &z, sizeof z);
        memcpy(columns + 9, &frame->origin, sizeof frame->origin);
        rtcSetGeometryInstancedScene(g, m->scene);
        rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        rtcCommitGeometry(g);
        rtcAttachGeometryByID(s->embree, g, (unsigned)s->objects);
        rtcReleaseGeometry(g);
        o->instance = 1;
        o->frame = *frame;
    }
    return s->objects++;
}

static inline void stage_commit(stage *s)
{
    const float margin = 1e-3f; /* more than the rounding of stage__box */
    struct RTCBounds b;
    rtcSetSceneFlags(s->embree, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(s->embree);
    rtcGetSceneBounds(s->embree, &b);
    s->low = scene_v(b.lower_x - margin, b.lower_y - margin, b.lower_z - margin);
    s->high = scene_v(b.upper_x + margin, b.upper_y + margin, b.upper_z + margin);
}

/* After a change of a mesh that is placed as it is. */
static inline void stage_mesh_changed(stage *s, int which)
{
    rtcUpdateGeometryBuffer(s->mesh[which].geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(s->mesh[which].geometry);
    stage_commit(s);
}

/* A parallelogram from a corner that shines to the side where `towards` lies. */
static inline stage_lamp stage_lamp_at(scene_vec corner, scene_vec a, scene_vec b, scene_vec towards, float radiance)
{
    stage_lamp l;
    scene_vec n = scene_cross(a, b);
    l.corner = corner;
    l.a = a;
    l.b = b;
    l.area = scene_length(n);
    l.normal = scene_mul(n, 1 / l.area);
    if (scene_dot(l.normal, scene_sub(towards, corner)) < 0) l.normal = scene_mul(l.normal, -1);
    l.radiance = radiance;
    l.color[0] = l.color[1] = l.color[2] = 1;
    return l;
}

/* The triangles of a grid of [rows + 1][columns + 1] vertices, counter-clockwise seen from where row x column
   points. */
static inline void stage_grid(uint32_t *index, int rows, int columns)
{
    int r, c;
    for (r = 0; r < rows; ++r)
        for (c = 0; c < columns; ++c) {
            uint32_t a = (uint32_t)(r * (columns + 1) + c), b = a + 1, d = a + (uint32_t)columns + 1, e = d + 1;
            *index++ = a;
            *index++ = d;
            *index++ = b;
            *index++ = b;
            *index++ = d;
            *index++ = e;
        }
}

/* --- what a ray meets --- */

static inline scene_vec stage__local(scene_vec v, scene_vec a, scene_vec b, scene_vec n)
{
    return scene_v(scene_dot(v, a), scene_dot(v, b), scene_dot(v, n));
}

typedef enum stage_kind { STAGE_SKY, STAGE_OBJECT, STAGE_GROUND, STAGE_LAMP } stage_kind;

typedef struct stage_hit {
    float t;
    stage_kind kind;
    int which;                           /* object or lamp */
    scene_vec position, normal, shading; /* normal outwards (of the ground: up) */
    scene_vec place;                     /* position in the object's own frame */
    float gray;                          /* albedo of the ground */
} stage_hit;

/* A plane, a quarter of a cylinder, a plane. The nearest t, or end. */
static inline float stage__ground(const stage_ground *g, scene_vec p, scene_vec d, float end, scene_vec *n)
{
    float bend = g->bend, t, yc = g->height + bend, zc = g->wall + bend, a, b, c, disc;
    int k;
    if (d.y != 0) {
        t = (g->height - p.y) / d.y;
        if (t > 1e-4f && t < end && p.z + t * d.z >= zc) {
            end = t;
            *n = scene_v(0, 1, 0);
        }
    }
    if (d.z != 0) {
        t = (g->wall - p.z) / d.z;
        if (t > 1e-4f && t < end && p.y + t * d.y >= yc) {
            end = t;
            *n = scene_v(0, 0, 1);
        }
    }
    a = d.y * d.y + d.z * d.z;
    b = (p.y - yc) * d.y + (p.z - zc) * d.z;
    c = (p.y - yc) * (p.y - yc) + (p.z - zc) * (p.z - zc) - bend * bend;
    disc = b * b - a * c;
    if (a > 0 && disc > 0)
        for (k = 0; k < 2; ++k) {
            t = (-b + (k ? sqrtf(disc) : -sqrtf(disc))) / a;
            if (t > 1e-4f && t < end && p.y + t * d.y < yc && p.z + t * d.z < zc) {
                end = t;
                *n = scene_v(0, (yc - p.y - t * d.y) / bend, (zc - p.z - t * d.z) / bend);
            }
        }
    return end;
}

/* The chequer at q with normal n; it runs on around the bend, by arc length. */
static inline float stage__gray(const stage_ground *g, scene_vec q, scene_vec n)
{
    float along = q.z;
    if (n.y < 1)
        along = g->wall + g->bend - g->bend * (n.z > 0.9999f ? 0.5f * MATERIAL_PI : atan2f(n.z, n.y)) -
            (n.z >= 1 ? q.y - g->height - g->bend : 0);
    return ((int)floorf(q.x / g->tile) + (int)floorf(along / g->tile)) & 1 ? g->light : g->dark;
}

static inline float stage__lamp(const stage_lamp *l, scene_vec p, scene_vec d, float end)
{
    float towards = scene_dot(l->normal, d), t, u, v;
    scene_vec q;
    if (towards >= 0) return end;
    t = scene_dot(l->normal, scene_sub(l->corner, p)) / towards;
    if (t <= 1e-4f || t >= end) return end;
    q = scene_sub(scene_mad(d, t, p), l->corner);
    u = scene_dot(q, l->a) /
        scene_dot(l->a, l->a); /* a and b stand at right angles or nearly: solve the 2 x 2 system */
    v = scene_dot(q, l->b) / scene_dot(l->b, l->b);
    {
        float ab = scene_dot(l->a, l->b), aa = scene_dot(l->a, l->a), bb = scene_dot(l->b, l->b),
              det = aa * bb - ab * ab;
        float qa = u * aa, qb = v * bb;
        u = (qa * bb - qb * ab) / det;
        v = (qb * aa - qa * ab) / det;
    }
    return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? t : end;
}

/* Does p + t d, 0 <= t <= end, come near the objects? Where d is parallel to a side a NaN counts as yes. */
static inline int stage__box(const stage *s, scene_vec p, scene_vec d, float end)
{
    const float low[3] = {s->low.x - p.x, s->low.y - p.y, s->low.z - p.z},
                high[3] = {s->high.x - p.x, s->high.y - p.y, s->high.z - p.z};
    const float along[3] = {d.x, d.y, d.z};
    float t0 = 0, t1 = end;
    int k;
    for (k = 0; k < 3; ++k) {
        float inverse = 1 / along[k], a = low[k] * inverse, b = high[k] * inverse;
        float first = a < b ? a : b, last = a < b ? b : a;
        if (first > t0) t0 = first;
        if (last < t1) t1 = last;
    }
    return !(t0 > t1);
}

static inline int stage__blocked(const stage *s, scene_vec from, scene_vec direction, float end)
{
    struct RTCRay r;
    scene_vec unused;
    if (stage__ground(&s->ground, from, direction, end, &unused) < end) return 1;
    if (!stage__box(s, from, direction, end)) return 0;
    r = trace__ray(from, direction, end);
#if TRACE_EMBREE == 4
    rtcOccluded1(s->embree, &r, NULL);
#else
    {
        struct RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(s->embree, &context, &r);
    }
#endif
    return r.tfar < 0;
}

static inline scene_vec stage__turn(const stage_frame *f, scene_vec v)
{
    return scene_add(scene_add(scene_mul(f->x, v.x), scene_mul(f->y, v.y)), scene_mul(f->z, v.z));
}

/* The nearest of ground and lamps first: Embree need not look beyond. */
static inline stage_hit stage__nearest(const stage *s, scene_vec p, scene_vec d)
{
    stage_hit hit;
    struct RTCRayHit r;
    int k;
    memset(&hit, 0, sizeof hit);
    hit.t = 1e30f;
    if (!s->bare) {
        const float horizon = 1e12f; /* beyond it squares of distances leave what Embree and floats take */
        float t = stage__ground(&s->ground, p, d, horizon, &hit.normal);
        if (t < horizon) {
            hit.t = t;
            hit.kind = STAGE_GROUND;
        }
        for (k = 0; k < s->lamps; ++k) {
            t = stage__lamp(&s->lamp[k], p, d, hit.t);
            if (t < hit.t) {
                hit.t = t;
                hit.kind = STAGE_LAMP;
                hit.which = k;
            }
        }
    }
    if (stage__box(s, p, d, hit.t)) {
        r.ray = trace__ray(p, d, hit.t);
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if TRACE_EMBREE == 4
        rtcIntersect1(s->embree, &r, NULL);
#else
        {
            struct RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcIntersect1(s->embree, &context, &r);
        }
#endif
        if (r.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
            hit.kind = STAGE_OBJECT;
            hit.t = r.ray.tfar;
            hit.which = (int)(r.hit.instID[0] != RTC_INVALID_GEOMETRY_ID ? r.hit.instID[0] : r.hit.geomID);
        }
    }
    hit.position = scene_mad(d, hit.t, p);
    if (hit.kind == STAGE_GROUND) {
        hit.shading = hit.normal;
        hit.gray = stage__gray(&s->ground, hit.position, hit.normal);
    }
    if (hit.kind == STAGE_OBJECT) {
        const stage_object *o = &s->object[hit.which];
        hit.normal = hit.shading = scene_normalize(scene_v(r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z));
        if (!o->flat) {
            const stage_mesh_data *m = &s->mesh[o->mesh];
            const uint32_t *index = m->index + 3 * (size_t)r.hit.primID;
            scene_vec n = scene_v(0, 0, 0);
            float w[3];
            w[1] = r.hit.u;
            w[2] = r.hit.v;
            w[0] = 1 - w[1] - w[2];
            for (k = 0; k < 3; ++k) {
                const float *v = m->normal + 3 * (size_t)index[k];
                n = scene_mad(scene_v(v[0], v[1], v[2]), w[k], n);
            }
            hit.shading = scene_normalize(n);
            if (scene_dot(hit.normal, hit.shading) < 0) hit.normal = scene_mul(hit.normal, -1);
        }
        hit.place = hit.position;
        if (o->instance) {
            scene_vec from = scene_mul(scene_sub(hit.position, o->frame.origin), 1 / o->frame.scale);
            hit.place = stage__local(from, o->frame.x, o->frame.y, o->frame.z);
            hit.normal = stage__turn(&o->frame, hit.normal);
            hit.shading = stage__turn(&o->frame, hit.shading);
        }
    }
    return hit;
}

/* --- paths --- */

/* Weight of a sample of density a that another way draws with density b; a may be huge, far out on the ground. */
static inline float stage__heuristic(float a, float b) { return a < 1e19f ? a * a / (a * a + b * b) : 1; }

/* Radiance along one camera ray. asked: what objects without a material wear. */
static inline void stage_path(const stage *s, const material *asked, trace_sampler *sampler, scene_vec p, scene_vec d,
                              float out[3])
{
    float through[3] = {1, 1, 1}, density = 0; /* of the last direction; 0: from the camera */
    const stage_object *inside = NULL;
    int depth, c, k;
    material gray, textured;
    memset(&gray, 0, sizeof gray);
    gray.share[MATERIAL_DIFFUSE] = 1;
    out[0] = out[1] = out[2] = 0;
    for (depth = 0; depth < 32; ++depth) {
        stage_hit hit = stage__nearest(s, p, d);
        const stage_object *object = NULL;
        const material *here = &gray;
        scene_vec n, ng, a, b, o, i;
        float u, v, choice, unused, f[3], eta = 1, pdf;
        if (inside) {
            const material *m = inside->dressed ? &inside->wears : asked;
            for (c = 0; c < 3; ++c) through[c] *= expf(-m->absorption * scene__min(hit.t / inside->frame.scale, 1e3f));
        }
        if (hit.kind == STAGE_SKY) {
            float light = s->sky[0] + s->sky[1] * d.y + s->sky[2] * d.z;
            for (c = 0; c < 3; ++c) out[c] += through[c] * (light * s->sky_color[c]);
            return;
        }
        if (hit.kind == STAGE_LAMP) {
            const stage_lamp *l = &s->lamp[hit.which];
            float light = l->radiance;
            if (density > 0 && !s->brute) {
                float other = hit.t * hit.t / (l->area * scene__max(-scene_dot(l->normal, d), 1e-6f));
                light *= stage__heuristic(density, other);
            }
            for (c = 0; c < 3; ++c) out[c] += through[c] * (light * l->color[c]);
            return;
        }
        n = hit.shading;
        ng = hit.normal;
        if (hit.kind == STAGE_OBJECT) {
            object = &s->object[hit.which];
            here = material_at(object->dressed ? &object->wears : asked, hit.place, &textured);
            eta = scene_dot(ng, d) > 0 ? 1 / here->ior : here->ior;
        } else {
            for (c = 0; c < 3; ++c) gray.diffuse[c] = hit.gray * s->ground.color[c];
        }
        if (scene_dot(ng, d) > 0) { /* from inside */
            n = scene_mul(n, -1);
            ng = scene_mul(ng, -1);
        }
        if (scene_dot(n, d) >= 0) n = ng; /* the interpolated normal turns away from the ray */
        trace__frame(n, &a, &b);
        o = stage__local(scene_mul(d, -1), a, b, n);
        /* lamps */
        for (k = 0; k < s->lamps && !s->bare && !s->brute; ++k) {
            const stage_lamp *l = &s->lamp[k];
            scene_vec to, q;
            float d2, distance, facing, other, weight;
            trace_sample(sampler, &u, &v);
            q = scene_mad(l->a, u, scene_mad(l->b, v, l->corner));
            to = scene_sub(q, hit.position);
            d2 = scene_dot(to, to);
            distance = sqrtf(d2);
            to = scene_mul(to, 1 / distance);
            facing = -scene_dot(l->normal, to);
            if (facing <= 0) continue;
            i = stage__local(to, a, b, n);
            if ((i.z > 0) != (scene_dot(to, ng) > 0)) continue;
            pdf = material_eval(here, o, i, eta, f);
            if (!(f[0] + f[1] + f[2] > 0)) continue;
            if (stage__blocked(s, scene_mad(ng, i.z > 0 ? 2e-4f : -2e-4f, hit.position), to, distance - 1e-3f))
                continue;
            other = d2 / (l->area * facing);
            weight = stage__heuristic(other, pdf) * l->radiance / other;
            for (c = 0; c < 3; ++c) out[c] += through[c] * f[c] * (weight * l->color[c]);
        }
        /* onwards */
        trace_sample(sampler, &choice, &unused);
        trace_sample(sampler, &u, &v);
        if (!material_sample(here, o, eta, choice, u, v, &i)) return;
        pdf = material_eval(here, o, i, eta, f);
        if (!(pdf > 0)) return;
        d = scene_normalize(scene_add(scene_add(scene_mul(a, i.x), scene_mul(b, i.y)), scene_mul(n, i.z)));
        if ((i.z > 0) != (scene_dot(d, ng) > 0)) return; /* shading and true normal disagree on the side */
        for (c = 0; c < 3; ++c) through[c] *= f[c] / pdf;
        density = pdf;
        p = scene_mad(ng, i.z > 0 ? 2e-4f : -2e-4f, hit.position);
        if (object && i.z < 0) inside = scene_dot(hit.normal, d) < 0 ? object : NULL;
        if (depth >= 4) { /* roulette; the largest channel decides, so that channels may be swapped */
            float go = scene__min(0.95f, scene__max(through[0], scene__max(through[1], through[2])));
            if (unused >= go) return;
            for (c = 0; c < 3; ++c) through[c] /= go;
        }
    }
}

/* Adds samples first to first + count - 1 of pixel (x, y) to sum. */
static inline void stage_sample(const stage *s, const material *asked, const stage_camera *camera, int width,
                                int height, int x, int y, uint32_t seed, int first, int count, double sum[3])
{
    scene_vec forward = scene_normalize(scene_sub(camera->at, camera->eye)),
              right = scene_normalize(scene_cross(forward, scene_v(0, 1, 0)));
    scene_vec up = scene_cross(right, forward);
    float half = tanf(0.5f * camera->degrees * MATERIAL_PI / 180);
    uint32_t pixel = trace__hash(seed ^ trace__hash((uint32_t)(y * width + x) + 0x51ed270bu));
    int k, c;
    for (k = first; k < first + count; ++k) {
        trace_sampler sampler;
        float u, v, r[3];
        scene_vec d, from = camera->eye;
        memset(&sampler, 0, sizeof sampler);
        sampler.seed = pixel;
        sampler.index = (uint32_t)k;
        trace_sample(&sampler, &u, &v);
        u = (2 * ((float)x + u) / (float)width - 1) * half * (float)width / (float)height;
        v = (1 - 2 * ((float)y + v) / (float)height) * half;
        d = scene_add(forward, scene_add(scene_mul(right, u), scene_mul(up, v)));
        if (camera->lens > 0) { /* a thin lens: the ray through its middle meets the others at the sharp plane */
            scene_vec sharp = scene_mad(d, camera->focus, camera->eye);
            trace_sample(&sampler, &u, &v);
            u = camera->lens * sqrtf(u);
            from = scene_add(
                camera->eye,
                scene_add(scene_mul(right, u * cosf(TRACE_TURN * v)), scene_mul(up, u * sinf(TRACE_TURN * v))));
            d = scene_sub(sharp, from);
        }
        stage_path(s, asked, &sampler, from, scene_normalize(d), r);
        for (c = 0; c < 3; ++c) sum[c] += (double)r[c];
    }
}
#endif
