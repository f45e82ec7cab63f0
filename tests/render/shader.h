/* The two shaders of the thesis: 19 parameters (3.5.3), and 38 with procedural textures and displacements (fig. 3.12).

     material m = material_from(x);                            x in [0, 1]^19
     material m = material_from_extended(x);                   x in [0, 1]^38
     here = material_at(&m, p, &place);                        the material at p where it is textured, m where not
     depth = material_depth(&m, p);                            how far the surface is carved in at p
     density = material_eval(&m, o, i, eta, f);                f(o, i) |cos i| and the density of drawing i
     drawn = material_sample(&m, o, eta, choice, u, v, &i);    a direction i for o; the normal on the side of o is +z

   0-2 diffuse rgb; 3-5 glossy rgb; 6 glossy roughness, alpha = max(x^2, 0.002); 7 mix of diffuse and glossy (1:
   glossy); 8-10 glass rgb; 11 glass roughness, as 6; 12 index of refraction 1 + max(x, 0.01); 13-15 translucent rgb; 16
   mix of glass and translucent (1: translucent); 17 mix of opaque and transmissive (1: transmissive); 18 absorption, 4
   x per ball radius, shared by the transmissive ones.

   Diffuse: Lambert. Glossy: Beckmann microfacets without Fresnel. Glass: Walter, Marschner, Li, Torrance 2007 with
   Beckmann's distribution and the exact Fresnel reflectance; color multiplies both. Translucent: Lambert on the other
   side. One lobe is sampled at a time.

   The other 19. A pattern w in [0, 1] over the ball joins two noises, fractal and cellular, and lays a second phase
   over the first: 19-21 its rgb, for every lobe; 22 how much of it (0: no texture); 23 cells per radius, 2 to 16; 24
   gain of the finer octaves; 25 contrast, from gradients to hard edges; 26 coverage; 27 fractal to cellular; 28 warp,
   which turns spots into veins; 29 how much rougher the second phase is (0: not); 30 how much more matt (0: not),
   diffuse in place of glossy and translucent in place of glass. Two reliefs are carved into the surface, never raised,
   so that the ball keeps its place: 31 depth of the fractal one, up to 0.15 radii (0: none); 32 cells per radius, 2 to
   16; 33 gain; 34 rolling to ridged; 35 depth of the cellular one, up to 0.15 radii (0: none); 36 cells per radius, 2
   to 16; 37 pits to pebbles. With 22, 29, 30, 31 and 35 at 0 the others do nothing: that is the 19-parameter shader,
   bit for bit. */
#ifndef TESTS_RENDER_SHADER_H
#define TESTS_RENDER_SHADER_H
#include "trace.h"

#define MATERIAL_PARAMETERS 19
#define MATERIAL_EXTENDED 38
#define MATERIAL_PI 3.14159265f

typedef struct material_noise { /* fractal noise */
    float frequency, gain;      /* cells per radius; of each octave over the last */
} material_noise;

typedef struct material { /* what is zeroed is not there */
    float diffuse[3], glossy[3], glass[3], translucent[3];
    float glossy_alpha, glass_alpha, ior, absorption; /* per ball radius */
    float share[4]; /* of the lobes diffuse, glossy, glass, translucent: weights of the mix, sum 1 */
    int textured, carved;
    float second[3], amount, rougher, matter; /* the second phase */
    material_noise noise;                     /* the pattern */
    float contrast, coverage, cellular, warp;
    material_noise ridge; /* the reliefs, depths in radii */
    float ridge_depth, ridged, cell_depth, cell_frequency, pebbles;
} material;

enum { MATERIAL_DIFFUSE, MATERIAL_GLOSSY, MATERIAL_GLASS, MATERIAL_TRANSLUCENT };

static inline material material_from(const float x[MATERIAL_PARAMETERS])
{
    material m;
    int c;
    memset(&m, 0, sizeof m);
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

static inline material material_from_extended(const float x[MATERIAL_EXTENDED])
{
    material m = material_from(x);
    int c;
    for (c = 0; c < 3; ++c) m.second[c] = x[19 + c];
    m.amount = x[22];
    m.rougher = x[29];
    m.matter = x[30];
    m.noise.frequency = exp2f(1 + 3 * x[23]);
    m.noise.gain = 0.8f * x[24];
    m.contrast = x[25];
    m.coverage = x[26];
    m.cellular = x[27];
    m.warp = 1.5f * x[28];
    m.ridge_depth = 0.15f * x[31];
    m.ridge.frequency = exp2f(1 + 3 * x[32]);
    m.ridge.gain = 0.8f * x[33];
    m.ridged = x[34];
    m.cell_depth = 0.15f * x[35];
    m.cell_frequency = exp2f(1 + 3 * x[36]);
    m.pebbles = x[37];
    m.textured = m.amount > 0 || m.rougher > 0 || m.matter > 0;
    m.carved = m.ridge_depth > 0 || m.cell_depth > 0;
    return m;
}

/* --- procedural patterns over the ball, p in radii --- */

/* Octaves down to 1/64 of a radius, in [-1, 1]. */
static inline float material__fractal(material_noise n, scene_vec p)
{
    float sum = 0, weight = 1, total = 0, frequency = n.frequency;
    for (p = scene_mul(p, frequency); frequency <= 64 && weight > 0;
         p = scene_mul(p, 2.03f), frequency *= 2.03f, weight *= n.gain) {
        sum += weight * scene_noise(p);
        total += weight;
    }
    return sum / total;
}

/* Distance from p to the nearest of one random point in each unit cell, at most 1 (Worley 1996). */
static inline float material__cells(scene_vec p)
{
    int x = (int)floorf(p.x), y = (int)floorf(p.y), z = (int)floorf(p.z), i, j, k;
    float nearest = 1;
    for (i = x - 1; i <= x + 1; ++i)
        for (j = y - 1; j <= y + 1; ++j)
            for (k = z - 1; k <= z + 1; ++k) {
                scene_vec jitter = scene_v(scene__lattice(i, j, k), scene__lattice(i + 101, j, k),
                                           scene__lattice(i, j + 101, k));
                scene_vec q = scene_mad(jitter, 0.4f, scene_v((float)i + 0.5f, (float)j + 0.5f, (float)k + 0.5f));
                scene_vec to = scene_sub(q, p);
                nearest = scene__min(nearest, scene_dot(to, to));
            }
    return sqrtf(nearest);
}

/* Share of the second phase at p. */
static inline float material__pattern(const material *m, scene_vec p)
{
    float turn = m->warp / m->noise.frequency, width = 1 - 0.96f * m->contrast, from, smooth, cells;
    scene_vec q = scene_mul(p, 0.7f * m->noise.frequency);
    p = scene_mad(scene_v(scene_noise(scene_add(q, scene_v(31.4f, 0, 0))),
                          scene_noise(scene_add(q, scene_v(0, 27.2f, 0))),
                          scene_noise(scene_add(q, scene_v(0, 0, 14.1f)))),
                  turn, p);
    smooth = 0.5f + 0.8f * material__fractal(m->noise, p);
    cells = material__cells(scene_mul(p, m->noise.frequency));
    from = 1 - m->coverage * (1 + width); /* coverage 0: nothing, 1: all */
    return scene__step(from, from + width, scene__clamp(scene__mix(smooth, cells, m->cellular), 0, 1));
}

/* The material at p, in *place where it differs from m. */
static inline const material *material_at(const material *m, scene_vec p, material *place)
{
    float w;
    int c;
    if (!m->textured) return m;
    w = material__pattern(m, p);
    *place = *m;
    for (c = 0; c < 3; ++c) {
        place->diffuse[c] = scene__mix(m->diffuse[c], m->second[c], m->amount * w);
        place->glossy[c] = scene__mix(m->glossy[c], m->second[c], m->amount * w);
        place->glass[c] = scene__mix(m->glass[c], m->second[c], m->amount * w);
        place->translucent[c] = scene__mix(m->translucent[c], m->second[c], m->amount * w);
    }
    place->glossy_alpha = scene__mix(m->glossy_alpha, 1, m->rougher * w * w);
    place->glass_alpha = scene__mix(m->glass_alpha, 1, m->rougher * w * w);
    place->share[MATERIAL_DIFFUSE] += m->matter * w * m->share[MATERIAL_GLOSSY];
    place->share[MATERIAL_GLOSSY] -= m->matter * w * m->share[MATERIAL_GLOSSY];
    place->share[MATERIAL_TRANSLUCENT] += m->matter * w * m->share[MATERIAL_GLASS];
    place->share[MATERIAL_GLASS] -= m->matter * w * m->share[MATERIAL_GLASS];
    return place;
}

/* How far the surface lies below p, in [0, 0.3] radii. */
static inline float material_depth(const material *m, scene_vec p)
{
    float depth = 0;
    if (m->ridge_depth > 0) {
        float f = scene__clamp(1.6f * material__fractal(m->ridge, scene_add(p, scene_v(7.3f, 1.9f, 3.7f))), -1, 1);
        depth += m->ridge_depth * scene__mix(0.5f - 0.5f * f, fabsf(f), m->ridged);
    }
    if (m->cell_depth > 0) {
        float d = material__cells(scene_mul(scene_add(p, scene_v(2.3f, 5.9f, 8.1f)), m->cell_frequency));
        depth += m->cell_depth * scene__mix(1 - d, d * d, m->pebbles);
    }
    return depth;
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
        scene_vec h = reflect ? scene_normalize(scene_add(o, i))
                              : scene_normalize(scene_mad(i, -eta, scene_mul(o, -1)));
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
            } else { /* Walter et al. 2007, eq. 21 and 17; radiance is not scaled by eta^2: every path leaves the ball
                        again */
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
static inline int material_sample(const material *m, scene_vec o, float eta, float choice, float u, float v,
                                  scene_vec *i)
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
#endif
