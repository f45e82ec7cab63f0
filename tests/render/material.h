/* The material-test scene of the thesis (3.5.3, fig. 3.4) as a path tracer: one fixed colourless scene, and a ball in it
   that wears any of the materials of the 19-parameter shader. Since nothing else has a colour, every channel of the
   picture depends on that channel's parameters alone, and swapping two channels of x swaps those of the picture exactly.

     material_scene *s = material_scene_create(detail);     detail: 1 for pictures of 128 pixels
     material_render(s, x, size, size, samples, seed, &picture);   linear radiance, image of 3 channels
     material_scene_destroy(s);

   x in [0, 1]^19: 0-2 diffuse rgb; 3-5 glossy rgb; 6 glossy roughness, alpha = max(x^2, 0.002); 7 mix of diffuse and
   glossy (1: glossy); 8-10 glass rgb; 11 glass roughness, as 6; 12 index of refraction 1 + max(x, 0.01); 13-15
   translucent rgb; 16 mix of glass and translucent (1: translucent); 17 mix of opaque and transmissive (1: transmissive);
   18 absorption, 4 x per ball radius, shared by the transmissive ones.

   Diffuse: Lambert. Glossy: Beckmann microfacets without Fresnel. Glass: Walter, Marschner, Li, Torrance 2007 with
   Beckmann's distribution and the exact Fresnel reflectance; colour multiplies both. Translucent: Lambert on the other
   side. One lobe is sampled at a time; lamps are sampled as well, combined by the power heuristic (Veach 1997). The
   same bytes for any number of threads: a picture depends on x, its size, samples and seed. */
#ifndef TESTS_RENDER_MATERIAL_H
#define TESTS_RENDER_MATERIAL_H
#include "trace.h"

#define MATERIAL_PARAMETERS 19
#define MATERIAL_PI 3.14159265f

typedef struct material {
    float diffuse[3], glossy[3], glass[3], translucent[3];
    float glossy_alpha, glass_alpha, ior, absorption; /* per ball radius */
    float share[4]; /* of the lobes diffuse, glossy, glass, translucent: weights of the mix, sum 1 */
} material;

enum { MATERIAL_DIFFUSE, MATERIAL_GLOSSY, MATERIAL_GLASS, MATERIAL_TRANSLUCENT };

static inline material material_from(const float x[MATERIAL_PARAMETERS])
{
    material m;
    int c;
    for (c = 0; c < 3; ++c) {
        m.diffuse[c] = x[c];
        m.glossy[c] = x[3 + c];
        m.glass[c] = x[8 + c];
        m.translucent[c] = x[13 + c];
    }
    m.glossy_alpha = scene__max(x[6] * x[6], 2e-3f);
    m.glass_alpha = scene__max(x[11] * x[11], 2e-3f);
    m.ior = 1 + scene__max(x[12], 0.01f);
    m.absorption = 4 * x[18];
    m.share[MATERIAL_DIFFUSE] = (1 - x[17]) * (1 - x[7]);
    m.share[MATERIAL_GLOSSY] = (1 - x[17]) * x[7];
    m.share[MATERIAL_GLASS] = x[17] * (1 - x[16]);
    m.share[MATERIAL_TRANSLUCENT] = x[17] * x[16];
    return m;
}

/* --- lobes, in a frame where the normal on the side of o is +z --- */

/* Fresnel reflectance of unpolarised light at a smooth boundary; eta = index behind / index in front. */
static inline float material_fresnel(float cosine, float eta)
{
    float g2 = eta * eta - 1 + cosine * cosine, g, a, b;
    if (g2 <= 0) return 1; /* total reflection */
    g = sqrtf(g2);
    a = (g - cosine) / (g + cosine);
    b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return 0.5f * a * a * (1 + b * b);
}

static inline float material_beckmann(float cosine_h, float alpha)
{
    float c2 = cosine_h * cosine_h, a2 = alpha * alpha;
    if (cosine_h <= 0) return 0;
    return expf((c2 - 1) / (c2 * a2)) / (MATERIAL_PI * a2 * c2 * c2);
}

/* Smith's shadowing for one direction, exact for Beckmann. */
static inline float material_smith(float cosine, float alpha)
{
    float c = fabsf(cosine), sine = sqrtf(scene__max(0, 1 - c * c)), a;
    if (sine <= 0) return 1;
    a = c / (alpha * sine);
    return a > 5 ? 1 : 2 / (1 + erff(a) + expf(-a * a) / (a * 1.7724539f));
}

/* A half vector with density D(h) cos. */
static inline scene_vec material_half(float alpha, float u, float v)
{
    float t2 = -alpha * alpha * logf(1 - u), c = 1 / sqrtf(1 + t2), s = sqrtf(scene__max(0, 1 - c * c));
    return scene_v(s * cosf(TRACE_TURN * v), s * sinf(TRACE_TURN * v), c);
}

/* f(o, i) |cos i| into f[3], and the density with which material_sample draws i, of all lobes together. eta: the index
   behind the surface over that in front, seen from o. */
static inline float material_eval(const material *m, scene_vec o, scene_vec i, float eta, float f[3])
{
    float density = 0, cosine = fabsf(i.z);
    int c, reflect = i.z > 0;
    f[0] = f[1] = f[2] = 0;
    if (o.z <= 0 || cosine <= 0) return 0;
    if (reflect && m->share[MATERIAL_DIFFUSE] > 0) {
        for (c = 0; c < 3; ++c) f[c] += m->share[MATERIAL_DIFFUSE] * m->diffuse[c] * cosine / MATERIAL_PI;
        density += m->share[MATERIAL_DIFFUSE] * cosine / MATERIAL_PI;
    }
    if (!reflect && m->share[MATERIAL_TRANSLUCENT] > 0) {
        for (c = 0; c < 3; ++c) f[c] += m->share[MATERIAL_TRANSLUCENT] * m->translucent[c] * cosine / MATERIAL_PI;
        density += m->share[MATERIAL_TRANSLUCENT] * cosine / MATERIAL_PI;
    }
    if (reflect && m->share[MATERIAL_GLOSSY] > 0) {
        scene_vec h = scene_normalize(scene_add(o, i));
        float d = material_beckmann(h.z, m->glossy_alpha);
        float value = d * material_smith(o.z, m->glossy_alpha) * material_smith(i.z, m->glossy_alpha) / (4 * o.z);
        for (c = 0; c < 3; ++c) f[c] += m->share[MATERIAL_GLOSSY] * m->glossy[c] * value;
        density += m->share[MATERIAL_GLOSSY] * d * h.z / (4 * scene__max(scene_dot(o, h), 1e-6f));
    }
    if (m->share[MATERIAL_GLASS] > 0) {
        scene_vec h = reflect ? scene_normalize(scene_add(o, i)) : scene_normalize(scene_mad(i, -eta, scene_mul(o, -1)));
        float oh, ih, d, g, fresnel, value, jacobian;
        if (h.z < 0) h = scene_mul(h, -1);
        oh = scene_dot(o, h);
        ih = scene_dot(i, h);
        if (oh > 0 && (reflect ? ih > 0 : ih < 0)) {
            d = material_beckmann(h.z, m->glass_alpha);
            g = material_smith(o.z, m->glass_alpha) * material_smith(i.z, m->glass_alpha);
            fresnel = material_fresnel(oh, eta);
            if (reflect) {
                value = fresnel * d * g / (4 * o.z);
                jacobian = fresnel * d * h.z / (4 * oh);
            } else { /* Walter et al. 2007, eq. 21 and 17; radiance is not scaled by eta^2: every path leaves the ball again */
                float denominator = oh + eta * ih;
                denominator *= denominator;
                value = (1 - fresnel) * d * g * fabsf(ih) * oh * eta * eta / (o.z * scene__max(denominator, 1e-9f));
                jacobian = (1 - fresnel) * d * h.z * eta * eta * fabsf(ih) / scene__max(denominator, 1e-9f);
            }
            for (c = 0; c < 3; ++c) f[c] += m->share[MATERIAL_GLASS] * m->glass[c] * value;
            density += m->share[MATERIAL_GLASS] * jacobian;
        }
    }
    return density;
}

/* A direction i for o; 0 where the sample is lost (below the surface). choice picks the lobe, then is used up. */
static inline int material_sample(const material *m, scene_vec o, float eta, float choice, float u, float v, scene_vec *i)
{
    int lobe = 0;
    while (lobe < 3 && choice >= m->share[lobe]) choice -= m->share[lobe++];
    while (lobe > 0 && m->share[lobe] <= 0) --lobe; /* rounding at the end of the last share */
    if (lobe == MATERIAL_DIFFUSE || lobe == MATERIAL_TRANSLUCENT) {
        float r = sqrtf(u), z = sqrtf(scene__max(0, 1 - u));
        *i = scene_v(r * cosf(TRACE_TURN * v), r * sinf(TRACE_TURN * v), lobe == MATERIAL_DIFFUSE ? z : -z);
        return z > 0;
    }
    if (lobe == MATERIAL_GLOSSY) {
        scene_vec h = material_half(m->glossy_alpha, u, v);
        *i = scene_mad(h, 2 * scene_dot(o, h), scene_mul(o, -1));
        return i->z > 0;
    } else {
        scene_vec h = material_half(m->glass_alpha, u, v);
        float oh = scene_dot(o, h), rest;
        if (oh <= 0) return 0;
        if (choice < m->share[lobe] * material_fresnel(oh, eta)) {
            *i = scene_mad(h, 2 * oh, scene_mul(o, -1));
            return i->z > 0;
        }
        rest = 1 - (1 - oh * oh) / (eta * eta);
        if (rest <= 0) return 0;
        *i = scene_normalize(scene_add(scene_mul(o, -1 / eta), scene_mul(h, oh / eta - sqrtf(rest))));
        return i->z < 0;
    }
}

/* --- the scene: ball radius 1 around the origin, on a ring, on a chequered floor that curves up into a wall --- */

typedef struct material_lamp { /* a rectangle that shines to one side */
    scene_vec corner, a, b, normal;
    float radiance, area;
} material_lamp;

typedef struct material_scene {
    RTCDevice device;
    RTCScene embree;
    float *ball, *ball_normal, *ring; /* vertices */
    uint32_t *ball_index, *ring_index;
    material_lamp lamp[2];
    float sky[3];  /* radiance of the sky in direction d: sky[0] + sky[1] d.y + sky[2] d.z */
    int bare;      /* non-zero: the ball alone under the sky (for tests) */
    int brute;     /* non-zero: lamps are found by chance only (for tests) */
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context); /* NULL: no threads */
    void *run_user;
} material_scene;

enum { MATERIAL_BALL, MATERIAL_RING };

/* Radius of the ball in the direction at angle theta from the top and phi around: a fluted belt between two grooves, a
   rosette on the cap. */
static inline float material__relief(float theta, float phi)
{
    float belt = scene__step(1.16f, 1.22f, theta) * (1 - scene__step(1.92f, 1.98f, theta));
    float groove = scene__bump(theta - 1.10f, 0.035f) + scene__bump(theta - 2.04f, 0.035f);
    float cap = scene__step(0.10f, 0.30f, theta) * (1 - scene__step(0.62f, 0.82f, theta));
    return 1 - 0.075f * groove + 0.020f * belt * cosf(28 * phi) + 0.024f * cap * cosf(8 * phi) - 0.03f * scene__bump(theta, 0.09f);
}

static inline void material_scene_destroy(material_scene *s)
{
    if (s == NULL) return;
    if (s->embree) rtcReleaseScene(s->embree);
    if (s->device) rtcReleaseDevice(s->device);
    free(s->ball);
    free(s->ball_normal);
    free(s->ring);
    free(s->ball_index);
    free(s->ring_index);
    free(s);
}

/* A grid of [rows + 1][columns + 1] vertices as triangles, counter-clockwise seen from where row x column points. */
static inline void material__grid(uint32_t *index, int rows, int columns)
{
    int r, c;
    for (r = 0; r < rows; ++r)
        for (c = 0; c < columns; ++c) {
            uint32_t a = (uint32_t)(r * (columns + 1) + c), b = a + 1, d = a + (uint32_t)columns + 1, e = d + 1;
            *index++ = a; *index++ = d; *index++ = b;
            *index++ = b; *index++ = d; *index++ = e;
        }
}

static inline void material__attach(material_scene *s, unsigned id, float *vertex, int vertices, uint32_t *index, int triangles)
{
    RTCGeometry g = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertex, 0, 12, (size_t)vertices);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, index, 0, 12, (size_t)triangles);
    rtcCommitGeometry(g);
    rtcAttachGeometryByID(s->embree, g, id);
    rtcReleaseGeometry(g);
}

static inline material_lamp material__lamp(scene_vec corner, scene_vec a, scene_vec b, float radiance)
{
    material_lamp l;
    scene_vec n = scene_cross(a, b);
    l.corner = corner;
    l.a = a;
    l.b = b;
    l.area = scene_length(n);
    l.normal = scene_mul(n, 1 / l.area);
    l.radiance = radiance;
    return l;
}

/* detail 1: 260000 triangles of 0.01; a smooth ball with detail < 0 (for tests). NULL: Embree or memory failed. */
static inline material_scene *material_scene_create(float detail)
{
    int smooth = detail < 0, rows = (int)(256 * fabsf(detail)), columns = 2 * rows, r, c, k, ring_rows = 48, ring_columns = 160;
    material_scene *s = (material_scene *)calloc(1, sizeof *s);
    size_t vertices = (size_t)(rows + 1) * (size_t)(columns + 1), ring_vertices = (size_t)(ring_rows + 1) * (size_t)(ring_columns + 1);
    if (s == NULL) return NULL;
    s->ball = (float *)malloc((3 * vertices + 4) * sizeof(float));
    s->ball_normal = (float *)malloc(3 * vertices * sizeof(float));
    s->ring = (float *)malloc((3 * ring_vertices + 4) * sizeof(float));
    s->ball_index = (uint32_t *)malloc((size_t)(6 * rows * columns) * sizeof(uint32_t));
    s->ring_index = (uint32_t *)malloc((size_t)(6 * ring_rows * ring_columns) * sizeof(uint32_t));
    s->device = rtcNewDevice("threads=1,set_affinity=0");
    s->embree = s->device ? rtcNewScene(s->device) : NULL;
    if (!s->ball || !s->ball_normal || !s->ring || !s->ball_index || !s->ring_index || !s->embree) {
        material_scene_destroy(s);
        return NULL;
    }
    for (r = 0; r <= rows; ++r)
        for (c = 0; c <= columns; ++c) {
            float theta = MATERIAL_PI * (float)r / (float)rows, phi = TRACE_TURN * (float)(c % columns) / (float)columns, e = 1e-3f;
            scene_vec corner[3], n;
            for (k = 0; k < 3; ++k) {
                float t = theta + (k == 1 ? e : 0), p = phi + (k == 2 ? e : 0), radius = smooth ? 1 : material__relief(t, p);
                corner[k] = scene_v(radius * sinf(t) * cosf(p), radius * cosf(t), radius * sinf(t) * sinf(p));
            }
            n = scene_cross(scene_sub(corner[2], corner[0]), scene_sub(corner[1], corner[0]));
            if (smooth || scene_length(n) < 1e-9f || r == 0 || r == rows) n = corner[0];
            n = scene_normalize(n);
            if (scene_dot(n, corner[0]) < 0) n = scene_mul(n, -1);
            memcpy(s->ball + 3 * (r * (columns + 1) + c), &corner[0], 3 * sizeof(float));
            memcpy(s->ball_normal + 3 * (r * (columns + 1) + c), &n, 3 * sizeof(float));
        }
    for (r = 0; r <= ring_rows; ++r)
        for (c = 0; c <= ring_columns; ++c) {
            float a = TRACE_TURN * (float)(r % ring_rows) / (float)ring_rows, b = TRACE_TURN * (float)(c % ring_columns) / (float)ring_columns;
            float *v = s->ring + 3 * (r * (ring_columns + 1) + c), out = 0.68f + 0.15f * cosf(a);
            v[0] = out * cosf(b);
            v[1] = -0.91f + 0.15f * sinf(a);
            v[2] = out * sinf(b);
        }
    material__grid(s->ball_index, rows, columns);
    material__grid(s->ring_index, ring_rows, ring_columns);
    material__attach(s, MATERIAL_BALL, s->ball, (int)vertices, s->ball_index, 2 * rows * columns);
    if (!smooth) material__attach(s, MATERIAL_RING, s->ring, (int)ring_vertices, s->ring_index, 2 * ring_rows * ring_columns);
    rtcSetSceneFlags(s->embree, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(s->embree);
    s->lamp[0] = material__lamp(scene_v(-4.2f, 2.6f, 1.2f), scene_v(1.6f, 1.9f, -1.0f), scene_v(1.5f, 0, 2.4f), 9);
    s->lamp[1] = material__lamp(scene_v(3.2f, 0.6f, -2.6f), scene_v(0, 2.8f, 0), scene_v(0.5f, 0, 0.9f), 12);
    for (k = 0; k < 2; ++k) /* they shine towards the ball */
        if (scene_dot(s->lamp[k].normal, s->lamp[k].corner) > 0) s->lamp[k].normal = scene_mul(s->lamp[k].normal, -1);
    s->sky[0] = 0.22f;
    s->sky[1] = 0.18f;
    s->sky[2] = 0.08f;
    return s;
}

/* What a ray meets. */
typedef struct material_hit {
    float t;
    int kind; /* -1 the sky, 0 ball, 1 ring, 2 floor, 3 + k: lamp k */
    scene_vec position, normal, shading; /* normal outwards (of the floor: up) */
    float grey;                          /* albedo of ring and floor */
} material_hit;

#define MATERIAL_FLOOR (-1.06f)
#define MATERIAL_WALL (-3.4f) /* z where the floor has become a wall; the bend has radius 1.5 */

/* The floor with its bend: a plane, a quarter of a cylinder, a plane. The nearest t, or end. */
static inline float material__floor(scene_vec p, scene_vec d, float end, scene_vec *n)
{
    float bend = 1.5f, t, yc = MATERIAL_FLOOR + bend, zc = MATERIAL_WALL + bend, a, b, c, disc;
    int k;
    if (d.y != 0) {
        t = (MATERIAL_FLOOR - p.y) / d.y;
        if (t > 1e-4f && t < end && p.z + t * d.z >= zc) { end = t; *n = scene_v(0, 1, 0); }
    }
    if (d.z != 0) {
        t = (MATERIAL_WALL - p.z) / d.z;
        if (t > 1e-4f && t < end && p.y + t * d.y >= yc) { end = t; *n = scene_v(0, 0, 1); }
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

static inline float material__lamp_hit(const material_lamp *l, scene_vec p, scene_vec d, float end)
{
    float towards = scene_dot(l->normal, d), t, u, v;
    scene_vec q;
    if (towards >= 0) return end;
    t = scene_dot(l->normal, scene_sub(l->corner, p)) / towards;
    if (t <= 1e-4f || t >= end) return end;
    q = scene_sub(scene_mad(d, t, p), l->corner);
    u = scene_dot(q, l->a) / scene_dot(l->a, l->a); /* a and b stand at right angles or nearly: solve the 2 x 2 system */
    v = scene_dot(q, l->b) / scene_dot(l->b, l->b);
    {
        float ab = scene_dot(l->a, l->b), aa = scene_dot(l->a, l->a), bb = scene_dot(l->b, l->b), det = aa * bb - ab * ab;
        float qa = u * aa, qb = v * bb;
        u = (qa * bb - qb * ab) / det;
        v = (qb * aa - qa * ab) / det;
    }
    return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? t : end;
}

static inline material_hit material__nearest(const material_scene *s, scene_vec p, scene_vec d)
{
    material_hit hit;
    struct RTCRayHit r;
    float t;
    int k;
    r.ray = trace__ray(p, d, 1e30f);
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
    memset(&hit, 0, sizeof hit);
    hit.kind = -1;
    hit.t = 1e30f;
    if (r.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        hit.kind = (int)r.hit.geomID;
        hit.t = r.ray.tfar;
        hit.normal = hit.shading = scene_normalize(scene_v(r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z));
        hit.grey = 0.45f;
        if (hit.kind == MATERIAL_BALL) {
            const uint32_t *index = s->ball_index + 3 * (size_t)r.hit.primID;
            float w[3];
            scene_vec n = scene_v(0, 0, 0);
            w[1] = r.hit.u;
            w[2] = r.hit.v;
            w[0] = 1 - w[1] - w[2];
            for (k = 0; k < 3; ++k) {
                const float *v = s->ball_normal + 3 * (size_t)index[k];
                n = scene_mad(scene_v(v[0], v[1], v[2]), w[k], n);
            }
            hit.shading = scene_normalize(n);
            if (scene_dot(hit.normal, hit.shading) < 0) hit.normal = scene_mul(hit.normal, -1);
        }
    }
    if (!s->bare) {
        scene_vec n;
        t = material__floor(p, d, hit.t, &n);
        if (t < hit.t) {
            scene_vec q = scene_mad(d, t, p);
            float bend = 1.5f, along = q.z; /* the chequer runs on around the bend, by arc length */
            if (n.y < 1) along = MATERIAL_WALL + bend - bend * (n.z > 0.9999f ? 0.5f * MATERIAL_PI : atan2f(n.z, n.y)) - (n.z >= 1 ? q.y - MATERIAL_FLOOR - bend : 0);
            hit.t = t;
            hit.kind = 2;
            hit.normal = hit.shading = n;
            hit.grey = ((int)floorf(q.x / 0.6f) + (int)floorf(along / 0.6f)) & 1 ? 0.58f : 0.22f;
        }
    }
    for (k = 0; k < 2 && !s->bare; ++k) {
        t = material__lamp_hit(&s->lamp[k], p, d, hit.t);
        if (t < hit.t) { hit.t = t; hit.kind = 3 + k; }
    }
    hit.position = scene_mad(d, hit.t, p);
    return hit;
}

static inline scene_vec material__local(scene_vec v, scene_vec a, scene_vec b, scene_vec n)
{
    return scene_v(scene_dot(v, a), scene_dot(v, b), scene_dot(v, n));
}

static inline float material__heuristic(float a, float b) { return a * a / (a * a + b * b); }

/* Radiance along one camera ray. */
static inline void material__path(const material_scene *s, const material *m, trace_sampler *sampler, scene_vec p, scene_vec d, float out[3])
{
    float through[3] = {1, 1, 1}, density = 0; /* of the last direction; 0: from the camera */
    int depth, c, k, inside = 0;
    material grey;
    memset(&grey, 0, sizeof grey);
    grey.share[MATERIAL_DIFFUSE] = 1;
    out[0] = out[1] = out[2] = 0;
    for (depth = 0; depth < 32; ++depth) {
        material_hit hit = material__nearest(s, p, d);
        const material *here = &grey;
        scene_vec n, ng, a, b, o, i;
        float u, v, choice, unused, f[3], eta = 1, pdf;
        if (inside)
            for (c = 0; c < 3; ++c) through[c] *= expf(-m->absorption * scene__min(hit.t, 1e3f));
        if (hit.kind < 0 || hit.kind >= 3) { /* sky or lamp */
            float light = hit.kind < 0 ? s->sky[0] + s->sky[1] * d.y + s->sky[2] * d.z : s->lamp[hit.kind - 3].radiance;
            if (hit.kind >= 3 && density > 0 && !s->brute) {
                const material_lamp *l = &s->lamp[hit.kind - 3];
                float other = hit.t * hit.t / (l->area * scene__max(-scene_dot(l->normal, d), 1e-6f));
                light *= material__heuristic(density, other);
            }
            for (c = 0; c < 3; ++c) out[c] += through[c] * light;
            return;
        }
        if (hit.kind == MATERIAL_BALL) here = m;
        else grey.diffuse[0] = grey.diffuse[1] = grey.diffuse[2] = hit.grey;
        n = hit.shading;
        ng = hit.normal;
        if (scene_dot(ng, d) > 0) { /* from inside the ball */
            n = scene_mul(n, -1);
            ng = scene_mul(ng, -1);
        }
        if (hit.kind == MATERIAL_BALL) eta = scene_dot(hit.normal, d) > 0 ? 1 / m->ior : m->ior;
        if (scene_dot(n, d) >= 0) n = ng; /* the interpolated normal turns away from the ray */
        trace__frame(n, &a, &b);
        o = material__local(scene_mul(d, -1), a, b, n);
        /* lamps */
        for (k = 0; k < 2 && !s->bare && !s->brute; ++k) {
            const material_lamp *l = &s->lamp[k];
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
            i = material__local(to, a, b, n);
            if ((i.z > 0) != (scene_dot(to, ng) > 0)) continue;
            pdf = material_eval(here, o, i, eta, f);
            if (!(f[0] + f[1] + f[2] > 0)) continue;
            {
                scene_vec start = scene_mad(ng, i.z > 0 ? 2e-4f : -2e-4f, hit.position), gap;
                struct RTCRay r = trace__ray(start, to, distance - 1e-3f);
                if (material__floor(start, to, distance - 1e-3f, &gap) < distance - 1e-3f) continue;
#if TRACE_EMBREE == 4
                rtcOccluded1(s->embree, &r, NULL);
#else
                struct RTCIntersectContext context;
                rtcInitIntersectContext(&context);
                rtcOccluded1(s->embree, &context, &r);
#endif
                if (r.tfar < 0) continue;
            }
            other = d2 / (l->area * facing);
            weight = material__heuristic(other, pdf) * l->radiance / other;
            for (c = 0; c < 3; ++c) out[c] += through[c] * f[c] * weight;
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
        if (hit.kind == MATERIAL_BALL && i.z < 0) inside = scene_dot(hit.normal, d) < 0;
        if (depth >= 4) { /* roulette; the largest channel decides, so that channels may be swapped */
            float go = scene__min(0.95f, scene__max(through[0], scene__max(through[1], through[2])));
            if (unused >= go) return;
            for (c = 0; c < 3; ++c) through[c] /= go;
        }
    }
}

typedef struct material__job {
    const material_scene *s;
    material m;
    int width, height, samples;
    uint32_t seed;
    image *out;
} material__job;

static inline void material__row(void *context, int y)
{
    const material__job *job = (const material__job *)context;
    scene_vec eye = scene_v(0, 1.25f, 5.6f), at = scene_v(0, -0.10f, 0), forward, right, up;
    float half = tanf(0.5f * 27.0f * MATERIAL_PI / 180);
    int x, k, c;
    forward = scene_normalize(scene_sub(at, eye));
    right = scene_normalize(scene_cross(forward, scene_v(0, 1, 0)));
    up = scene_cross(right, forward);
    for (x = 0; x < job->width; ++x) {
        double sum[3] = {0, 0, 0};
        uint32_t pixel = trace__hash(job->seed ^ trace__hash((uint32_t)(y * job->width + x) + 0x51ed270bu));
        for (k = 0; k < job->samples; ++k) {
            trace_sampler sampler;
            float u, v, r[3];
            scene_vec d;
            memset(&sampler, 0, sizeof sampler);
            sampler.seed = pixel;
            sampler.index = (uint32_t)k;
            trace_sample(&sampler, &u, &v);
            u = (2 * ((float)x + u) / (float)job->width - 1) * half * (float)job->width / (float)job->height;
            v = (1 - 2 * ((float)y + v) / (float)job->height) * half;
            d = scene_normalize(scene_add(forward, scene_add(scene_mul(right, u), scene_mul(up, v))));
            material__path(job->s, &job->m, &sampler, eye, d, r);
            for (c = 0; c < 3; ++c) sum[c] += (double)r[c];
        }
        for (c = 0; c < 3; ++c)
            job->out->pixels[((size_t)y * (size_t)job->width + (size_t)x) * 3 + (size_t)c] = (float)(sum[c] / job->samples);
    }
}

/* Linear radiance; 0 where memory ran out. */
static inline int material_render(const material_scene *s, const float x[MATERIAL_PARAMETERS], int width, int height, int samples, uint32_t seed, image *out)
{
    material__job job;
    int y;
    *out = image_new(width, height, 3);
    if (out->pixels == NULL) return 0;
    job.s = s;
    job.m = material_from(x);
    job.width = width;
    job.height = height;
    job.samples = samples;
    job.seed = seed;
    job.out = out;
    if (s->run) s->run(s->run_user, height, material__row, &job);
    else for (y = 0; y < height; ++y) material__row(&job, y);
    return 1;
}
#endif
