/* Three lit objects for the examples, modeled, lit and rendered by this file alone: a life-size bust, a knotted tube,
   85 mm wide, and a broken bowl, 66 mm high, with walls of 3 mm. All are distance fields (smooth unions of ellipsoids
   and capsules, grooves as Gaussian bumps), found by sphere tracing; the soft shadows of the round lamps are marched
   through the same field. C99 and C++11, no assets, no dependency but image.h.

     scene s;
     float color[3] = {0.44f, 0.22f, 0.13f};                  diffuse reflectance of the material
     const char *problem = scene_render(&s, SCENE_BUST, 1920, 1080, color);      NULL: fine
     ... filter s.irradiance with s.depth and s.mask ...
     problem = scene_compose(&s, &s.irradiance, &picture);    albedo * irradiance + specular, outlines, tone map, sRGB
     scene_free(&s);

   Lengths are millimeters, y is up. Under ten seconds on one core at 1080p. */
#ifndef EXAMPLES_SCENE_H
#define EXAMPLES_SCENE_H
#include "../tools/image.h"

typedef enum scene_object { SCENE_BUST, SCENE_KNOT, SCENE_BOWL } scene_object;

/* --- vectors --- */

typedef struct scene_vec {
    float x, y, z;
} scene_vec;

static inline scene_vec scene_v(float x, float y, float z)
{
    scene_vec r;
    r.x = x;
    r.y = y;
    r.z = z;
    return r;
}

static inline scene_vec scene_add(scene_vec a, scene_vec b) { return scene_v(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline scene_vec scene_sub(scene_vec a, scene_vec b) { return scene_v(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline scene_vec scene_mul(scene_vec a, float s) { return scene_v(a.x * s, a.y * s, a.z * s); }
static inline scene_vec scene_mad(scene_vec a, float s, scene_vec b) { return scene_add(scene_mul(a, s), b); }
static inline float scene_dot(scene_vec a, scene_vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline float scene_length(scene_vec a) { return sqrtf(scene_dot(a, a)); }
static inline scene_vec scene_normalize(scene_vec a) { return scene_mul(a, 1 / scene_length(a)); }
static inline scene_vec scene_cross(scene_vec a, scene_vec b)
{
    return scene_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline float scene__min(float a, float b) { return a < b ? a : b; }
static inline float scene__max(float a, float b) { return a > b ? a : b; }
static inline float scene__clamp(float v, float low, float high) { return v < low ? low : v > high ? high : v; }
static inline float scene__mix(float a, float b, float t) { return a + (b - a) * t; }
static inline float scene__step(float a, float b, float v) /* smoothstep */
{
    float t = scene__clamp((v - a) / (b - a), 0, 1);
    return t * t * (3 - 2 * t);
}
static inline float scene__bump(float v, float sigma) { return expf(-0.5f * v * v / (sigma * sigma)); }

/* --- noise in [-1, 1]: random values at the integers, joined by cubics --- */

static inline float scene__lattice(int x, int y, int z)
{
    uint32_t h = (uint32_t)x * 0x8da6b343u ^ (uint32_t)y * 0xd8163841u ^ (uint32_t)z * 0xcb1ab31fu;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (float)((h ^ h >> 15) >> 8) * (2.0f / 16777216.0f) - 1;
}

static inline float scene_noise(scene_vec p)
{
    float fx = floorf(p.x), fy = floorf(p.y), fz = floorf(p.z), u = p.x - fx, v = p.y - fy, w = p.z - fz, c[4];
    int x = (int)fx, y = (int)fy, z = (int)fz, i;
    u = u * u * (3 - 2 * u);
    v = v * v * (3 - 2 * v);
    w = w * w * (3 - 2 * w);
    for (i = 0; i < 4; ++i)
        c[i] = scene__mix(scene__lattice(x, y + (i & 1), z + (i >> 1)),
                          scene__lattice(x + 1, y + (i & 1), z + (i >> 1)), u);
    return scene__mix(scene__mix(c[0], c[1], v), scene__mix(c[2], c[3], v), w);
}

/* Octaves of noise, each half as strong and twice as fine. */
static inline float scene_fractal(scene_vec p, int octaves)
{
    float sum = 0, weight = 0.5f;
    for (; octaves > 0; --octaves, weight *= 0.5f, p = scene_mul(p, 2.03f)) sum += weight * scene_noise(p);
    return sum;
}

/* --- distance fields --- */

static inline float scene__join(float a, float b, float k) /* smooth minimum: a fillet of size k */
{
    float h = scene__max(k - fabsf(a - b), 0) / k;
    return scene__min(a, b) - 0.25f * k * h * h;
}

static inline float scene__cut(float a, float b, float k) { return -scene__join(-a, b, k); } /* a without b */

static inline float scene__ellipsoid(scene_vec p, float x, float y, float z, float rx, float ry, float rz)
{
    scene_vec q = scene_v((p.x - x) / rx, (p.y - y) / ry, (p.z - z) / rz);
    float k0 = scene_length(q), k1 = scene_length(scene_v(q.x / rx, q.y / ry, q.z / rz));
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -scene__min(rx, scene__min(ry, rz));
}

static inline float scene__capsule(scene_vec p, scene_vec a, scene_vec b, float ra, float rb)
{
    scene_vec ab = scene_sub(b, a), ap = scene_sub(p, a);
    float t = scene__clamp(scene_dot(ap, ab) / scene_dot(ab, ab), 0, 1);
    return scene_length(scene_mad(ab, -t, ap)) - scene__mix(ra, rb, t);
}

/* The right eye: its center, its radius, and the almond opening between the lids seen from the front, negative inside
   (x is |x|: the left eye is its mirror image). */
#define SCENE_EYE_X 31.0f
#define SCENE_EYE_Z 66.0f
#define SCENE_EYE_RADIUS 12.4f

static inline float scene__eyeball(scene_vec p)
{
    return scene_length(scene_v(fabsf(p.x) - SCENE_EYE_X, p.y, p.z - SCENE_EYE_Z)) - SCENE_EYE_RADIUS;
}

static inline float scene__eye_opening(float ax, float y)
{
    float u = ax - SCENE_EYE_X, v = y - 0.06f * u, w = 1 - u * u / (13.0f * 13.0f);
    return 0.85f * scene__max(v - 4.6f * w, -v - 3.4f * w);
}

static inline float scene__ear(scene_vec p) /* from the ear's center; x points outwards, z to the front */
{
    float x = 0.93f * p.x + 0.37f * p.z, z0 = 0.93f * p.z - 0.37f * p.x, d, k, rim; /* stands off by 22 degrees */
    scene_vec q = scene_v(x, 0.985f * p.y + 0.17f * z0, 0.985f * z0 - 0.17f * p.y); /* and leans back by 10 */
    k = sqrtf(q.y * q.y / (30.0f * 30.0f) + q.z * q.z / (17.5f * 17.5f));
    d = scene__ellipsoid(q, 0, 0, 0, 4.5f, 30, 17.5f);
    d = scene__cut(d, scene__ellipsoid(q, 5.5f, -6, 4, 8.5f, 13, 8.5f), 3);
    d = scene__cut(d, scene__ellipsoid(q, 4.5f, 12, 0, 4, 11, 9), 4);
    rim = sqrtf((k - 0.9f) * (k - 0.9f) * 420 + (q.x - 2) * (q.x - 2)) - 2.7f;
    d = scene__join(d, rim, 2.5f);
    d = scene__join(d, scene__capsule(q, scene_v(2, 12, -6), scene_v(1.5f, -14, -6), 2.4f, 2.2f), 3); /* antihelix */
    d = scene__join(d, scene__ellipsoid(q, 0.5f, -27, 5, 3.6f, 8, 6.5f), 5);                          /* lobe */
    return scene__join(d, scene__ellipsoid(q, 1, -5, 14, 3.5f, 6, 4), 4);                             /* tragus */
}

static inline float scene__face(scene_vec p, scene_vec q, float d) /* adds the features to the head's distance d */
{
    float ax = q.x, opening, lids, u = ax - SCENE_EYE_X, seam;

    /* eyes: a socket, the lids as a thicker ball joined to it, then the opening */
    d = scene__cut(d, scene__ellipsoid(q, 33, 4, 92, 19, 10, 15), 15);
    lids = scene_length(scene_v(u, p.y, p.z - SCENE_EYE_Z)) - SCENE_EYE_RADIUS - 1.7f;
    d = scene__join(d, lids, 7);
    d += 1.3f * scene__bump(p.y - 0.06f * u - 8.2f + 0.03f * u * u, 1.1f) * scene__step(15, 9, fabsf(u)) *
        scene__step(66, 72, p.z);
    opening = scene__eye_opening(ax, p.y);
    if (p.z > 55) d = scene__cut(d, opening, 1.3f);

    /* nose */
    d = scene__join(d, scene__capsule(p, scene_v(0, 12, 83), scene_v(0, -29, 99), 5.5f, 7.5f), 13);
    d = scene__join(d, scene__capsule(p, scene_v(0, 0, 76), scene_v(0, -33, 86), 8, 11.5f), 8);
    d = scene__join(d, scene__ellipsoid(p, 0, -33.5f, 101, 9.5f, 8.2f, 10), 10);
    d = scene__join(d, scene__ellipsoid(q, 12, -38.5f, 90, 6, 6.8f, 11), 9);
    d = scene__cut(d, scene__ellipsoid(q, 6.3f, -45.5f, 97, 3.3f, 3.6f, 5.5f), 3);

    /* mouth: a mound, two lips, the seam between them, its corners, the hollows above and below */
    d = scene__join(d, scene__ellipsoid(p, 0, -68, 66, 29, 24, 25), 16);
    d = scene__cut(d, scene__capsule(p, scene_v(0, -50, 97), scene_v(0, -61, 96.5f), 2.2f, 2.8f), 6);
    d = scene__join(d, scene__capsule(q, scene_v(0, -66.8f, 90.5f), scene_v(23, -70.5f, 81.5f), 4.6f, 2.2f), 5);
    d = scene__join(d, scene__capsule(q, scene_v(0, -76, 89.5f), scene_v(21, -73, 82), 5.8f, 3), 5);
    seam = p.y + 70.8f + 1.1f * scene__bump(ax, 3.5f) - 0.9f * scene__bump(ax - 11, 5);
    d += 1.5f * scene__bump(seam, 0.75f) * scene__step(25, 15, ax) * scene__step(72, 78, p.z);
    d = scene__cut(d, scene__ellipsoid(q, 25.5f, -71.5f, 86, 2.5f, 2, 3.5f), 6);
    d = scene__cut(d, scene__ellipsoid(p, 0, -86.5f, 94, 15, 3.6f, 5), 8);
    return scene__min(d, scene__eyeball(p));
}

static inline float scene_bust(scene_vec p)
{
    scene_vec q = scene_v(fabsf(p.x), p.y, p.z); /* one half; the other is its mirror image */
    float d = scene__ellipsoid(p, 0, 36, -10, 72, 76, 95);
    d = scene__join(d, scene__ellipsoid(p, 0, -28, 20, 59, 82, 62), 26);
    d = scene__join(d, scene__capsule(q, scene_v(45, -58, 2), scene_v(7, -99, 58), 16, 14), 26);
    d = scene__join(d, scene__ellipsoid(p, 0, -98, 74, 17, 14, 14), 20);
    d = scene__join(d, scene__ellipsoid(q, 39, -18, 52, 18, 13, 17), 28);
    d = scene__join(d, scene__capsule(q, scene_v(0, 17, 79), scene_v(50, 17, 54), 8, 2.5f), 20);
    if (p.y < 20) { /* neck, shoulders, chest */
        float body = scene__capsule(p, scene_v(0, -50, -34), scene_v(0, -200, -36), 46, 55);
        body = scene__join(body, scene__capsule(q, scene_v(22, -128, -55), scene_v(118, -212, -42), 30, 26), 40);
        body = scene__join(body, scene__capsule(q, scene_v(0, -238, -30), scene_v(150, -246, -34), 46, 44), 34);
        body = scene__join(body, scene__ellipsoid(q, 160, -262, -32, 52, 60, 52), 30);
        body = scene__join(body, scene__ellipsoid(p, 0, -292, -14, 160, 92, 72), 40);
        body = scene__join(body, scene__capsule(q, scene_v(58, -52, -22), scene_v(12, -196, 20), 9, 7), 18);
        body = scene__join(body, scene__capsule(q, scene_v(26, -204, 12), scene_v(140, -198, -2), 5, 7), 16);
        body = scene__join(body, scene__ellipsoid(p, 0, -138, 17, 8, 15, 7), 18);
        body = scene__cut(body, scene__ellipsoid(p, 0, -198, 38, 8, 10, 10), 14);
        d = scene__max(scene__join(d, body, 24), -p.y - 250);
    }
    if (q.x > 45 && p.z < 40) d = scene__join(d, scene__ear(scene_v(q.x - 70, p.y + 12, p.z + 6)), 9);
    return p.z > 35 && p.y < 45 && p.y > -125 ? scene__face(p, q, d) : d;
}

/* A trefoil tube. Its center line runs twice around the axis z on a torus (radii 27 and 10.5) and winds 3/2 times a
   turn: C(t) = ((27 + 10.5 cos 1.5t) cos t, (27 + 10.5 cos 1.5t) sin t, 10.5 sin 1.5t). The nearest point of both
   strands is found by Newton's method from the one with the angle of p. */
static inline float scene_knot(scene_vec p)
{
    scene_vec q = scene_v(p.x, 0.94f * p.y - 0.342f * p.z, 0.342f * p.y + 0.94f * p.z); /* leans back by 20 degrees */
    float nearest = 1e30f, angle = atan2f(q.y, q.x);
    int strand, i;
    for (strand = 0; strand < 2; ++strand, angle += 6.2831853f) {
        float t = angle, step;
        scene_vec to = q;
        for (i = 0; i < 4; ++i) {
            float c = cosf(t), s = sinf(t), rho, rho1, rho2, c15, s15;
            scene_vec first, second;
            c15 = 10.5f * cosf(1.5f * t + 0.5f);
            s15 = 10.5f * sinf(1.5f * t + 0.5f);
            rho = 27 + c15;
            rho1 = -1.5f * s15;
            rho2 = -2.25f * c15;
            to = scene_sub(q, scene_v(rho * c, rho * s, s15));
            first = scene_v(rho1 * c - rho * s, rho1 * s + rho * c, 1.5f * c15);
            second = scene_v((rho2 - rho) * c - 2 * rho1 * s, (rho2 - rho) * s + 2 * rho1 * c, -2.25f * s15);
            step = scene_dot(first, first);
            step = scene_dot(to, first) / scene__max(step - scene_dot(to, second), 0.4f * step);
            t += scene__clamp(step, -0.4f, 0.4f);
        }
        nearest = scene__min(nearest, scene_length(to));
    }
    return nearest - 7.6f;
}

/* An ellipsoid's shell, dented, its opening towards the camera and up, with a wavy rim. */
static inline float scene_bowl(scene_vec p)
{
    scene_vec q = scene_mad(p, 0.05f * scene_noise(scene_mul(p, 0.05f)), p);
    float along = 0.74f * p.z + 0.5f * p.y - 0.45f * p.x, turn = atan2f(0.9f * p.x + 0.4f * p.y, p.y - 0.6f * p.z);
    float d = fabsf(scene__ellipsoid(q, 0, 0, 0, 24, 32, 24)) - 1.5f;
    return scene__cut(d, 5 + 3 * sinf(3 * turn) - along, 2);
}

/* Ground, and a wall behind it, joined by a round corner. */
static inline float scene__backdrop(scene_object object, scene_vec p)
{
    return object == SCENE_BUST ? scene__join(p.y + 250, p.z + 900, 160) : scene__join(p.y + 37.0f, p.z + 260, 200);
}

static inline float scene_distance(scene_object object, scene_vec p)
{
    return object == SCENE_BUST ? scene_bust(p) : object == SCENE_KNOT ? scene_knot(p) : scene_bowl(p);
}

/* The outward normal: differences over the corners of a tetrahedron of size e. */
static inline scene_vec scene_gradient(scene_object object, scene_vec p, float e)
{
    float a = scene_distance(object, scene_v(p.x + e, p.y - e, p.z - e)),
          b = scene_distance(object, scene_v(p.x - e, p.y - e, p.z + e));
    float c = scene_distance(object, scene_v(p.x - e, p.y + e, p.z - e)),
          d = scene_distance(object, scene_v(p.x + e, p.y + e, p.z + e));
    return scene_normalize(scene_v(a - b - c + d, -a - b + c + d, -a + b - c + d));
}

/* A box around the object, with room for fillets. */
static inline void scene_bounds(scene_object object, scene_vec *low, scene_vec *high)
{
    *low = object == SCENE_BUST ? scene_v(-218, -254, -112) : scene_v(-50, -48, -30);
    *high = object == SCENE_BUST ? scene_v(218, 124, 124) : scene_v(50, 48, 30);
}

/* --- camera and lamps --- */

/* A pinhole: right, up and back are orthonormal; the pixel (x, y) of [-1, 1]^2 looks along
   (x aspect right + y up) tan_half_fov - back. */
typedef struct scene_camera {
    scene_vec eye, right, up, back;
    float tan_half_fov;
} scene_camera;

static inline scene_camera scene_camera_of(scene_object object)
{
    scene_camera c;
    float yaw = object == SCENE_BUST ? 0.42f : 0.25f, pitch = object == SCENE_BUST ? 0.03f : 0.33f;
    scene_vec target = object == SCENE_BUST ? scene_v(0, -14, 10) : scene_v(0, -4, 0);
    c.tan_half_fov = 0.2126f; /* 24 degrees */
    c.back = scene_v(sinf(yaw) * cosf(pitch), sinf(pitch), cosf(yaw) * cosf(pitch));
    c.right = scene_normalize(scene_cross(scene_v(0, 1, 0), c.back));
    c.up = scene_cross(c.back, c.right);
    c.eye = scene_mad(c.back, object == SCENE_BUST ? 660.0f : 265.0f, target);
    return c;
}

/* A round lamp; `power` is the irradiance that it gives the object's center at right angle. */
typedef struct scene_light {
    scene_vec position;
    float radius, power[3];
} scene_light;

enum { SCENE_LIGHTS = 3 };

static inline void scene_lights(scene_object object, scene_light light[SCENE_LIGHTS])
{
    static const float bust[SCENE_LIGHTS][7] = {{-560, 330, 250, 55, 3.3f, 2.95f, 2.5f}, /* key: warm, from the left */
                                                {400, 260, -560, 60, 1.2f, 1.6f, 2.2f},  /* rim: cold, from behind */
                                                {560, 40, 420, 220, 0.07f, 0.09f, 0.125f}}; /* fill: large and weak */
    static const float knot[SCENE_LIGHTS][7] = {{-190, 210, 60, 20, 3.3f, 3.0f, 2.6f},
                                                {170, 120, -190, 30, 1.0f, 1.35f, 1.9f},
                                                {150, 90, 260, 90, 0.10f, 0.125f, 0.16f}};
    int i, c;
    for (i = 0; i < SCENE_LIGHTS; ++i) {
        const float *l = object == SCENE_BUST ? bust[i] : knot[i];
        light[i].position = scene_v(l[0], l[1], l[2]);
        light[i].radius = l[3];
        for (c = 0; c < 3; ++c) light[i].power[c] = l[4 + c];
    }
}

/* --- the distance field on a grid: shadows and the way to the surface read this, ten times faster --- */

typedef struct scene_grid {
    scene_object object;
    scene_vec low, high;
    float cell;
    int nx, ny, nz;
    float *distance; /* [nz][ny][nx] at the corners of the cells */
} scene_grid;

static inline int scene__grid_make(scene_grid *g, scene_object object, float cell)
{
    int x, y, z;
    float *d;
    g->object = object;
    g->cell = cell;
    scene_bounds(object, &g->low, &g->high);
    g->nx = (int)ceilf((g->high.x - g->low.x) / cell) + 1;
    g->ny = (int)ceilf((g->high.y - g->low.y) / cell) + 1;
    g->nz = (int)ceilf((g->high.z - g->low.z) / cell) + 1;
    g->high = scene_mad(scene_v((float)(g->nx - 1), (float)(g->ny - 1), (float)(g->nz - 1)), cell, g->low);
    d = g->distance = (float *)malloc((size_t)g->nx * (size_t)g->ny * (size_t)g->nz * sizeof *d);
    if (d == NULL) return 0;
    for (z = 0; z < g->nz; ++z)
        for (y = 0; y < g->ny; ++y)
            for (x = 0; x < g->nx; ++x)
                *d++ = scene_distance(object, scene_mad(scene_v((float)x, (float)y, (float)z), cell, g->low));
    return 1;
}

/* Outside the grid: the distance to its box, and what the field says at the nearest point of it. */
static inline float scene__grid_distance(const scene_grid *g, scene_vec p)
{
    float qx = scene__clamp(p.x, g->low.x, g->high.x), qy = scene__clamp(p.y, g->low.y, g->high.y);
    float qz = scene__clamp(p.z, g->low.z, g->high.z), u, v, w, inside, a, b;
    float outside = fabsf(p.x - qx) + fabsf(p.y - qy) + fabsf(p.z - qz);
    const float *d;
    int x, y, z, row = g->nx, slice = g->nx * g->ny;
    if (outside > 0) outside = scene_length(scene_v(p.x - qx, p.y - qy, p.z - qz));
    if (outside > 30) return outside;
    u = (qx - g->low.x) / g->cell;
    v = (qy - g->low.y) / g->cell;
    w = (qz - g->low.z) / g->cell;
    x = (int)u < g->nx - 2 ? (int)u : g->nx - 2;
    y = (int)v < g->ny - 2 ? (int)v : g->ny - 2;
    z = (int)w < g->nz - 2 ? (int)w : g->nz - 2;
    u -= (float)x;
    v -= (float)y;
    w -= (float)z;
    d = g->distance + (size_t)z * (size_t)slice + (size_t)(y * row + x);
    a = scene__mix(scene__mix(d[0], d[1], u), scene__mix(d[row], d[row + 1], u), v);
    d += slice;
    b = scene__mix(scene__mix(d[0], d[1], u), scene__mix(d[row], d[row + 1], u), v);
    inside = scene__mix(a, b, w);
    return outside > 0 ? sqrtf(outside * outside + inside * inside) : inside;
}

/* --- rays --- */

enum { SCENE_OBJECT, SCENE_EYE, SCENE_BACKDROP };

typedef struct scene_hit {
    int what;
    float t;
} scene_hit;

/* The part of a ray, from *t0 to *t1, that lies within `margin` of the object's box; 0 where it misses the box. */
static inline int scene__clip(const scene_grid *g, scene_vec from, scene_vec direction, float margin, float *t0,
                              float *t1)
{
    const float o[3] = {from.x, from.y, from.z}, d[3] = {direction.x, direction.y, direction.z};
    const float low[3] = {g->low.x, g->low.y, g->low.z}, high[3] = {g->high.x, g->high.y, g->high.z};
    int i;
    for (i = 0; i < 3; ++i) {
        float inverse = 1 / (fabsf(d[i]) > 1e-9f ? d[i] : 1e-9f);
        float a = (low[i] - margin - o[i]) * inverse, b = (high[i] + margin - o[i]) * inverse;
        *t0 = scene__max(*t0, scene__min(a, b));
        *t1 = scene__min(*t1, scene__max(a, b));
    }
    return *t0 < *t1;
}

/* start: where the ray is known to have met nothing yet */
static inline scene_hit scene__trace_from(const scene_grid *g, scene_vec from, scene_vec direction, float start)
{
    scene_hit hit;
    int i;
    float t = 0, end = 6000, d;
    if (scene__clip(g, from, direction, 0, &t, &end)) {
        if (t < start) t = start;
        for (i = 0; t < end; ++i) {
            scene_vec p = scene_mad(direction, t, from);
            d = scene__grid_distance(g, p);
            if (d < 0.3f * g->cell) d = scene_distance(g->object, p); /* near the surface: the field itself */
            if (d < 3e-5f * t || i == 250) {                          /* or it crept along an outline */
                hit.what = g->object == SCENE_BUST && scene__eyeball(p) < 0.05f ? SCENE_EYE : SCENE_OBJECT;
                hit.t = t;
                return hit;
            }
            t += 0.9f * d;
        }
    }
    for (i = 0, t = 0, end = 6000; i < 200 && t < end; ++i) {
        d = scene__backdrop(g->object, scene_mad(direction, t, from));
        if (d < 1e-4f * t) break;
        t += d;
    }
    hit.what = SCENE_BACKDROP;
    hit.t = t;
    return hit;
}

static inline scene_hit scene__trace(const scene_grid *g, scene_vec from, scene_vec direction)
{
    return scene__trace_from(g, from, direction, 0);
}

/* The part of a round lamp that is seen from p, whose normal is n: the nearest pass of the ray to its center by the
   object, in lamp radii, as the area of a disk cut by a straight edge. */
static inline float scene__visible(const scene_grid *g, scene_vec p, scene_vec n, scene_vec lamp, float radius)
{
    scene_vec to = scene_sub(lamp, p), direction;
    float length = scene_length(to), t = 0.6f * g->cell, end = length, gap = 1;
    direction = scene_mul(to, 1 / length);
    p = scene_mad(n, 0.25f * g->cell, p);
    if (!scene__clip(g, p, direction, scene__min(radius, 40), &t, &end)) return 1;
    while (t < end && gap > -1) {
        float d = scene__grid_distance(g, scene_mad(direction, t, p));
        gap = scene__min(gap, d / (t * radius / length));
        t += scene__clamp(0.7f * d, 0.5f * g->cell, 60);
    }
    gap = scene__max(gap, -1);
    return 0.25f * (1 + gap) * (1 + gap) * (2 - gap);
}

/* How open the half-space above n is, from the field at growing heights. */
static inline float scene__openness(const scene_grid *g, scene_vec p, scene_vec n)
{
    float sum = 0, weight = 1, reach = g->object == SCENE_BUST ? 7.0f : 3.5f, h = 0.35f * reach;
    int i;
    for (i = 0; i < 5; ++i, h *= 1.9f, weight *= 0.62f) {
        scene_vec q = scene_mad(n, h, p);
        float d = scene__min(scene__grid_distance(g, q), scene__backdrop(g->object, q));
        sum += weight * scene__max(0, 1 - d / h);
    }
    return scene__clamp(1 - 0.52f * sum, 0, 1);
}

static inline scene_vec scene__normal(const scene_grid *g, int what, scene_vec p)
{
    scene_vec n = scene_v(0, 1, 0);
    float e = 1;
    if (what != SCENE_BACKDROP) return scene_gradient(g->object, p, 0.02f);
    n.y = scene__backdrop(g->object, scene_v(p.x, p.y + e, p.z)) -
        scene__backdrop(g->object, scene_v(p.x, p.y - e, p.z));
    n.z = scene__backdrop(g->object, scene_v(p.x, p.y, p.z + e)) -
        scene__backdrop(g->object, scene_v(p.x, p.y, p.z - e));
    return scene_normalize(n);
}

/* --- surfaces --- */

typedef struct scene_surface {
    float albedo[3];
    float reflectance, roughness, coat; /* at normal incidence; of the rough lobe; weight of a lobe half as rough */
    float mask;                         /* 1: light scatters below it */
} scene_surface;

static inline scene_surface scene__matte(const float albedo[3], float brightness)
{
    scene_surface s;
    int c;
    memset(&s, 0, sizeof s);
    for (c = 0; c < 3; ++c) s.albedo[c] = brightness * albedo[c];
    s.roughness = 0.5f;
    return s;
}

/* albedo times a tint, as far as `amount` says. */
static inline void scene__tint(scene_surface *s, float red, float green, float blue, float amount)
{
    s->albedo[0] *= scene__mix(1, red, amount);
    s->albedo[1] *= scene__mix(1, green, amount);
    s->albedo[2] *= scene__mix(1, blue, amount);
}

static inline scene_surface scene__wall(scene_object object, scene_vec p)
{
    static const float gray[2][3] = {{0.042f, 0.048f, 0.056f}, {0.20f, 0.19f, 0.18f}};
    return scene__matte(gray[object == SCENE_KNOT], 1 + 0.05f * scene_fractal(scene_mul(p, 0.02f), 4));
}

/* White, an iris with spokes and a dark rim, a pupil; both eyes look at the camera. */
static inline scene_surface scene__eye(scene_vec p)
{
    static const float white[3] = {0.50f, 0.45f, 0.43f}, iris[3] = {0.16f, 0.21f, 0.20f};
    scene_vec look = scene_normalize(scene_v(0.30f, 0.01f, 1)), side = scene_cross(look, scene_v(0, 1, 0));
    scene_vec q = scene_sub(p, scene_v(p.x < 0 ? -SCENE_EYE_X : SCENE_EYE_X, 0, SCENE_EYE_Z));
    float ahead = scene_dot(q, look), r = scene_length(scene_mad(look, -ahead, q)),
          angle = atan2f(q.y, scene_dot(q, side));
    float spokes = 0.75f + 0.6f * scene_noise(scene_v(6 * cosf(angle), 6 * sinf(angle), 0.5f * r));
    float inside = ahead > 0 ? scene__step(5.9f, 5.3f, r) : 0;
    float rings = scene__step(2.3f, 2.7f, r) * (1 - 0.75f * scene__step(4.2f, 5.9f, r));
    scene_surface s = scene__matte(white, 1);
    int c;
    for (c = 0; c < 3; ++c) s.albedo[c] = scene__mix(white[c], iris[c] * spokes * rings + 0.004f, inside);
    s.reflectance = 0.025f;
    s.roughness = 0.10f;
    return s;
}

/* 1 on the lips. */
static inline float scene__lips(scene_vec p)
{
    float ax = fabsf(p.x), bottom = -80.5f + 0.012f * ax * ax;
    float top = -64.2f - 0.22f * ax + 1.6f * scene__bump(ax - 6, 4) - 0.006f * ax * ax;
    if (p.z < 74) return 0;
    return scene__step(-0.6f, 1.2f, scene__min(top - p.y, p.y - bottom)) * scene__step(27.5f, 22, ax) *
        scene__step(74, 80, p.z);
}

/* Fine relief of the skin, mm outwards: pores and creases, upright wrinkles on the lips. */
static inline float scene__relief(scene_vec p)
{
    float lips = scene__lips(p), pores = 0.05f * scene_noise(scene_mul(p, 0.42f));
    pores += 0.045f * scene_noise(scene_mul(p, 0.95f)) + 0.03f * scene_noise(scene_mul(p, 1.9f));
    return (1 - 0.8f * lips) * pores + lips * 0.20f * scene_noise(scene_v(1.1f * p.x, 0.16f * p.y, 0.2f * p.z));
}

/* Eyebrows: single hairs along an arc. */
static inline float scene__brow(float ax, scene_vec p)
{
    float off = fabsf(p.y - 20.5f - 4.5f * (1 - (ax - 35) * (ax - 35) / 400)) + 0.11f * fabsf(ax - 22);
    float hairs = scene_noise(scene_v(1.3f * (ax - 0.6f * p.y), 0.5f * (p.y + 0.2f * ax), 0.5f * p.z));
    float arc = scene__step(4.6f, 1.2f, off) * scene__step(10, 16, ax) * scene__step(56, 46, ax) *
        scene__step(45, 60, p.z);
    return arc * scene__clamp(0.72f + 0.8f * hairs, 0, 1);
}

/* Where blood shows: cheeks, the nose's tip, ears, the lids' edges. */
static inline float scene__blush(float ax, scene_vec p)
{
    float cheek = scene__bump(ax - 42, 15) * scene__bump(p.y + 26, 13) * scene__step(30, 60, p.z);
    float nose = scene__bump(p.x, 10) * scene__bump(p.y + 38, 10) * scene__step(95, 108, p.z);
    float ear = 0.9f * scene__step(70, 84, ax) * scene__bump(p.y + 14, 30);
    float lids = 0.6f * scene__step(6, -1, fabsf(scene__eye_opening(ax, p.y))) * scene__step(60, 68, p.z);
    return scene__max(scene__max(cheek, nose), scene__max(ear, lids));
}

static inline scene_surface scene__skin(scene_vec p, const float color[3])
{
    float mottle = 0.16f * scene_fractal(scene_mul(p, 0.07f), 4) + 0.07f * scene_noise(scene_mul(p, 0.9f));
    float lips = scene__lips(p), ax = fabsf(p.x), brow = scene__brow(ax, p);
    scene_surface s = scene__matte(color, 1);
    scene__tint(&s, 1 + 0.6f * mottle, 1 + mottle, 1 + mottle, 1);
    scene__tint(&s, 1.0f, 0.80f, 0.80f, 0.7f * scene__blush(ax, p));
    scene__tint(&s, 0.86f, 0.52f, 0.55f, lips);
    scene__tint(&s, 0.16f, 0.13f, 0.12f, 0.9f * brow);
    s.reflectance = 0.028f * (1 - 0.6f * brow); /* index 1.4 */
    s.roughness = scene__mix(0.54f, 0.36f, lips);
    s.coat = scene__mix(0.10f, 0.4f, lips);
    s.mask = 1;
    return s;
}

/* Polished marble: dark veins where a folded noise crosses zero, broad ones and fine ones. */
static inline scene_surface scene__marble(scene_vec p, const float color[3])
{
    scene_vec q = scene_mul(p, 0.05f), fold, at;
    float broad, fine;
    scene_surface s = scene__matte(color, 1 + 0.08f * scene_fractal(scene_mul(p, 0.12f), 3));
    fold.x = scene_fractal(q, 4);
    fold.y = scene_fractal(scene_v(q.y + 1.55f, q.z, q.x), 4);
    fold.z = scene_fractal(scene_v(q.z, q.x + 2.85f, q.y), 4);
    at = scene_mad(fold, 0.9f, scene_mul(p, 0.045f));
    broad = scene__step(0.055f, 0, fabsf(scene_fractal(at, 3)));
    fine = scene__step(0.05f, 0, fabsf(scene_fractal(scene_mad(at, 2.1f, scene_v(9, 4, 1)), 3)));
    scene__tint(&s, 0.36f, 0.39f, 0.43f, scene__max(0.85f * broad, 0.45f * fine));
    s.reflectance = 0.04f; /* index 1.5 */
    s.roughness = 0.16f;
    s.mask = 1;
    return s;
}

/* Microfacet reflection (GGX, Smith, Schlick) times the cosine, for one lobe. */
static inline float scene__lobe(float nl, float nv, float nh, float vh, float roughness, float reflectance)
{
    float a2 = roughness * roughness * roughness * roughness, d = nh * nh * (a2 - 1) + 1;
    float gl = nl + sqrtf(a2 + (1 - a2) * nl * nl), gv = nv + sqrtf(a2 + (1 - a2) * nv * nv);
    float fresnel = reflectance + (1 - reflectance) * powf(1 - vh, 5);
    return fresnel * a2 / (3.14159265f * d * d) * nl / (gl * gv);
}

/* Both lobes of a surface with normal n that is lit from l and seen from v. */
static inline float scene__gloss(const scene_surface *m, scene_vec n, scene_vec l, scene_vec v, float nv)
{
    scene_vec h = scene_normalize(scene_add(l, v));
    float nl = scene_dot(n, l), nh = scene_dot(n, h), vh = scene_dot(v, h), sum;
    if (m->reflectance <= 0) return 0;
    sum = (1 - m->coat) * scene__lobe(nl, nv, nh, vh, m->roughness, m->reflectance);
    if (m->coat > 0) sum += m->coat * scene__lobe(nl, nv, nh, vh, 0.55f * m->roughness, m->reflectance);
    return sum;
}

/* What a mirror would see: a dim studio, lighter above, with one soft window on the left. */
static inline void scene__studio(scene_vec d, float spread, float out[3])
{
    static const float low[3] = {0.035f, 0.035f, 0.04f}, high[3] = {0.24f, 0.27f, 0.31f},
                       glass[3] = {0.76f, 0.72f, 0.66f};
    float up = 0.5f + 0.5f * d.y, soft = 0.06f + spread, window = d.z > 0 ? 1.0f : 0.0f;
    int c;
    window *= scene__step(0.24f + soft, 0.24f - soft, fabsf(d.x + 0.55f));
    window *= scene__step(0.26f + soft, 0.26f - soft, fabsf(d.y - 0.42f));
    for (c = 0; c < 3; ++c) out[c] = scene__mix(low[c], high[c], up * up) + window * glass[c];
}

/* The normal n of the skin at p, tilted by the slope of its relief. */
static inline scene_vec scene__roughen(scene_vec n, scene_vec p)
{
    float h = 0.22f, here = scene__relief(p);
    scene_vec slope;
    slope.x = scene__relief(scene_v(p.x + h, p.y, p.z)) - here;
    slope.y = scene__relief(scene_v(p.x, p.y + h, p.z)) - here;
    slope.z = scene__relief(scene_v(p.x, p.y, p.z + h)) - here;
    slope = scene_mul(slope, 1 / h);
    return scene_normalize(scene_sub(n, scene_mad(n, -scene_dot(slope, n), slope)));
}

/* --- the picture's layers --- */

typedef struct scene {
    scene_object object;
    int width, height;
    scene_camera camera;
    image irradiance, albedo, specular; /* RGB; irradiance is divided by pi: times albedo it is radiance */
    image depth;                        /* mm along the viewing direction */
    image mask;                         /* 1 where light scatters below the surface; 0 on eyes, ground and wall */
    unsigned char *coverage;            /* [height][width][9]: how much of a pixel its 3x3 neighbors show, of 16 */
} scene;

static inline void scene_free(scene *s)
{
    image_free(&s->irradiance);
    image_free(&s->albedo);
    image_free(&s->specular);
    image_free(&s->depth);
    image_free(&s->mask);
    free(s->coverage);
    memset(s, 0, sizeof *s);
}

static inline scene_vec scene_ray(const scene_camera *c, int width, int height, float x, float y)
{
    float u = (2 * x - (float)width) / (float)height * c->tan_half_fov,
          v = (1 - 2 * y / (float)height) * c->tan_half_fov;
    return scene_normalize(scene_sub(scene_add(scene_mul(c->right, u), scene_mul(c->up, v)), c->back));
}

static inline void scene__shade(scene *s, const scene_grid *g, const scene_light *light, scene_hit hit, scene_vec ray,
                                const float color[3], size_t pixel)
{
    static const float sky[3] = {0.045f, 0.054f, 0.068f}, ground[3] = {0.026f, 0.022f, 0.020f};
    scene_vec p = scene_mad(ray, hit.t, s->camera.eye), v = scene_mul(ray, -1), smooth = scene__normal(g, hit.what, p),
              n = smooth;
    scene_surface m;
    float open = scene__openness(g, p, smooth), nv;
    float *e = s->irradiance.pixels + 3 * pixel, *specular = s->specular.pixels + 3 * pixel;
    int i, c;
    if (hit.what == SCENE_BACKDROP) m = scene__wall(g->object, p);
    else if (hit.what == SCENE_EYE) m = scene__eye(p);
    else if (g->object == SCENE_BUST) m = scene__skin(p, color), n = scene__roughen(n, p);
    else m = scene__marble(p, color);
    nv = scene__max(scene_dot(n, v), 0.03f);
    for (c = 0; c < 3; ++c) {
        e[c] = open * scene__mix(ground[c], sky[c], 0.5f + 0.5f * n.y);
        s->albedo.pixels[3 * pixel + (size_t)c] = m.albedo[c];
    }
    for (i = 0; i < SCENE_LIGHTS; ++i) {
        scene_vec to = scene_sub(light[i].position, p), l = scene_normalize(to);
        float nl = scene_dot(n, l), seen, gloss;
        if (nl <= 0) continue;
        seen = scene__visible(g, p, smooth, light[i].position, light[i].radius);
        seen *= scene_dot(light[i].position, light[i].position) / scene_dot(to, to);
        gloss = scene__gloss(&m, n, l, v, nv);
        for (c = 0; c < 3; ++c) {
            e[c] += seen * nl * light[i].power[c] / 3.14159265f;
            specular[c] += seen * gloss * light[i].power[c];
        }
    }
    if (m.reflectance > 0) { /* the studio's reflection, hidden where the field rises */
        scene_vec r = scene_sub(scene_mul(n, 2 * scene_dot(n, v)), v);
        float studio[3], fresnel = m.reflectance + (1 - m.roughness - m.reflectance) * powf(1 - nv, 5);
        fresnel *= open * open * scene__visible(g, p, smooth, scene_mad(r, 300, p), 300 * (0.1f + 0.5f * m.roughness));
        scene__studio(r, m.roughness, studio);
        for (c = 0; c < 3; ++c) specular[c] += fresnel * studio[c];
    }
    s->mask.pixels[pixel] = m.mask;
}

/* Outlines: where neighbors differ in depth or in what they show, 16 rays a pixel ask which of the 3x3 pixels shows
   what they hit. */
static inline void scene__cover(scene *s, const scene_grid *g)
{
    int x, y, i, k;
    for (y = 0; y < s->height; ++y)
        for (x = 0; x < s->width; ++x) {
            size_t pixel = (size_t)y * (size_t)s->width + (size_t)x;
            unsigned char *weight = s->coverage + 9 * pixel;
            float near_depth = 1e30f, far_depth = 0, depth[9], mask[9];
            int edge = 0;
            for (i = 0; i < 9; ++i) {
                int nx = x + i % 3 - 1, ny = y + i / 3 - 1;
                int beside = nx < 0 || ny < 0 || nx >= s->width || ny >= s->height;
                size_t neighbor = beside ? pixel : (size_t)ny * (size_t)s->width + (size_t)nx;
                depth[i] = beside ? 1e30f : s->depth.pixels[neighbor];
                mask[i] = s->mask.pixels[neighbor];
                if (beside) continue;
                near_depth = scene__min(near_depth, depth[i]);
                far_depth = scene__max(far_depth, depth[i]);
                edge |= fabsf(mask[i] - s->mask.pixels[pixel]) > 0;
            }
            if (!edge && far_depth < 1.01f * near_depth) {
                weight[4] = 16;
                continue;
            }
            for (k = 0; k < 16; ++k) { /* 16 points of a rotated grid, 4 to a row */
                float dx = (float)(k % 4) / 4 + (float)(k / 4) / 16 + 0.03125f,
                      dy = (float)(k / 4) / 4 + (float)(k % 4) / 16 + 0.03125f;
                scene_vec ray = scene_ray(&s->camera, s->width, s->height, (float)x + dx, (float)y + dy);
                scene_hit hit = scene__trace_from(g, s->camera.eye, ray, near_depth - 8 * g->cell);
                float z = -scene_dot(ray, s->camera.back) * hit.t, best = 1e30f;
                int choice = 4;
                for (i = 0; i < 9; ++i) {
                    float aside = fabsf(dx + 0.5f - (float)(i % 3)) + fabsf(dy + 0.5f - (float)(i / 3));
                    float cost = fabsf(depth[i] - z) + 0.004f * z * aside +
                        ((mask[i] > 0) != (hit.what == SCENE_OBJECT) ? z : 0);
                    if (cost >= best) continue;
                    best = cost;
                    choice = i;
                }
                weight[choice]++;
            }
        }
}

/* Renders the layers as `camera` sees them under three lamps. color: diffuse reflectance of the object, RGB. */
static inline const char *scene_render_lit(scene *s, scene_object object, const scene_camera *camera,
                                           const scene_light light[SCENE_LIGHTS], int width, int height,
                                           const float color[3])
{
    scene_grid grid;
    size_t count;
    int x, y;
    memset(s, 0, sizeof *s);
    s->object = object;
    s->width = width;
    s->height = height;
    s->camera = *camera;
    s->irradiance = image_new(width, height, 3);
    s->albedo = image_new(width, height, 3);
    s->specular = image_new(width, height, 3);
    s->depth = image_new(width, height, 1);
    s->mask = image_new(width, height, 1);
    count = image_count(&s->mask);
    s->coverage = (unsigned char *)calloc(9, count ? count : 1);
    if (!s->irradiance.pixels || !s->albedo.pixels || !s->specular.pixels || !s->depth.pixels || !s->mask.pixels ||
        !s->coverage || !scene__grid_make(&grid, object, object == SCENE_BUST ? 2.5f : 1.0f)) {
        scene_free(s);
        return "out of memory";
    }
    for (y = 0; y < height; ++y)
        for (x = 0; x < width; ++x) {
            size_t pixel = (size_t)y * (size_t)width + (size_t)x;
            scene_vec ray = scene_ray(&s->camera, width, height, (float)x + 0.5f, (float)y + 0.5f);
            scene_hit hit = scene__trace(&grid, s->camera.eye, ray);
            s->depth.pixels[pixel] = -scene_dot(ray, s->camera.back) * hit.t;
            scene__shade(s, &grid, light, hit, ray, color, pixel);
        }
    scene__cover(s, &grid);
    free(grid.distance);
    return NULL;
}

/* The same by the object's own camera and lamps. */
static inline const char *scene_render(scene *s, scene_object object, int width, int height, const float color[3])
{
    scene_camera camera = scene_camera_of(object);
    scene_light light[SCENE_LIGHTS];
    scene_lights(object, light);
    return scene_render_lit(s, object, &camera, light, width, height, color);
}

/* --- from layers to a picture --- */

/* Filmic curve, Narkowicz's fit of the ACES reference (2016). */
static inline float scene_tone(float v)
{
    return scene__clamp(v * (2.51f * v + 0.03f) / (v * (2.43f * v + 0.59f) + 0.14f), 0, 1);
}

/* out: sRGB-encoded RGB in [0, 1], for image_write. irradiance: the scene's own, or a filtered copy of it. */
static inline const char *scene_compose(const scene *s, const image *irradiance, image *out)
{
    float exposure = s->object == SCENE_BUST ? 2.2f : 1.3f;
    int x, y, i, c;
    *out = image_new(s->width, s->height, 3);
    if (out->pixels == NULL) return "out of memory";
    for (y = 0; y < s->height; ++y)
        for (x = 0; x < s->width; ++x) {
            size_t pixel = (size_t)y * (size_t)s->width + (size_t)x;
            for (i = 0; i < 9; ++i) {
                int weight = s->coverage[9 * pixel + (size_t)i];
                size_t from = 3 * (weight ? pixel + (size_t)((i / 3 - 1) * s->width + i % 3 - 1) : pixel);
                if (weight == 0) continue;
                for (c = 0; c < 3; ++c, ++from) {
                    float v = s->albedo.pixels[from] * irradiance->pixels[from] + s->specular.pixels[from];
                    out->pixels[3 * pixel + (size_t)c] += (float)weight / 16 *
                        image_srgb_encode(scene_tone(exposure * v));
                }
            }
        }
    return NULL;
}
#endif
