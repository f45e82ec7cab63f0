/* Random walks in simple bodies, for what curvature does to a diffusion profile: below a plane, in a ball or around a
   hollow, in a cylinder, through a slab. Isotropic scattering, mean free path 1, any index of refraction; light enters
   with a cosine distribution. One walk serves every albedo: its weight is albedo^collisions. */
#ifndef TESTS_RENDER_BALL_H
#define TESTS_RENDER_BALL_H
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define BALL_ALBEDOS 12 /* at most */
#define BALL_BINS 56    /* rings of distance between entry and exit, straight through the body */
#define BALL_COLLISIONS 4000
#define BALL_SURVIVAL 0.997 /* roulette a collision: lengths stay bounded, weights in range for albedos to 0.999 */

typedef enum ball_shape { BALL_SPHERE, BALL_CYLINDER, BALL_SLAB } ball_shape;

typedef struct ball_tally {
    double total[BALL_ALBEDOS], through[BALL_ALBEDOS]; /* leaves on the side of entry; a slab's other side */
    double ring[BALL_ALBEDOS][BALL_BINS];              /* of total, by distance */
    double square[BALL_ALBEDOS];                       /* variance of one walk's total */
} ball_tally;

/* Rings: 0 to 0.05, then growing by a constant factor to 200 mean free paths. */
static inline double ball_edge(int i) { return i == 0 ? 0 : 0.05 * pow(4000, (i - 1) / (BALL_BINS - 1.0)); }

typedef struct ball_random {
    uint64_t a, b;
} ball_random;

static inline double ball__uniform(ball_random *r) /* xorshift128+ */
{
    uint64_t x = r->a, y = r->b, sum = x + y;
    r->a = y;
    x ^= x << 23;
    r->b = x ^ y ^ (x >> 17) ^ (y >> 26);
    return ((double)(sum >> 11) + 0.5) / 9007199254740992.0;
}

/* Unpolarised reflection of light with cosine ci against the normal, into index n times its own. */
static inline double ball_fresnel(double ci, double n)
{
    double s2 = (1 - ci * ci) / (n * n), ct, a, b;
    if (s2 >= 1) return 1;
    ct = sqrt(1 - s2);
    a = (ci - n * ct) / (ci + n * ct);
    b = (n * ci - ct) / (n * ci + ct);
    return 0.5 * (a * a + b * b);
}

/* curvature: 1 / radius, positive for a body, negative for a hollow in a medium without end, 0 for a half-space; of a
   slab 1 / thickness. Entry at the origin, outward normal +z. */
static inline void ball_walk(ball_shape shape, double curvature, double index, const double *albedo, int albedos,
                             long walks, uint64_t seed, ball_tally *out)
{
    double(*power)[BALL_ALBEDOS] = (double(*)[BALL_ALBEDOS])malloc((BALL_COLLISIONS + 1) * sizeof *power);
    double size = curvature != 0 ? 1 / fabs(curvature) : 0, low = log(0.05), step = log(4000) / (BALL_BINS - 1);
    int side = curvature > 0 ? 1 : -1, i, m;
    ball_random r;
    long w;
    if (power == NULL) abort();
    r.a = seed * 0x9e3779b97f4a7c15u + 1;
    r.b = ~r.a * 0xbf58476d1ce4e5b9u;
    for (i = 0; i < albedos; ++i) {
        power[0][i] = 1;
        for (m = 1; m <= BALL_COLLISIONS; ++m) power[m][i] = power[m - 1][i] * albedo[i] / BALL_SURVIVAL;
    }
    memset(out, 0, sizeof *out);
    for (i = 0; i < 32; ++i) ball__uniform(&r);
    for (w = 0; w < walks; ++w) {
        double p[3] = {0, 0, 0}, d[3], mu, turn, s;
        do mu = sqrt(ball__uniform(&r));
        while (index > 1 && ball__uniform(&r) < ball_fresnel(mu, index));
        mu = sqrt(1 - (1 - mu * mu) / (index * index));
        turn = 6.283185307179586 * ball__uniform(&r);
        s = sqrt(1 - mu * mu);
        d[0] = s * cos(turn);
        d[1] = s * sin(turn);
        d[2] = -mu;
        for (m = 0; m < BALL_COLLISIONS;) {
            double length = -log(ball__uniform(&r)), t = HUGE_VAL, n[3] = {0, 0, 1};
            int below = 0;
            if (curvature == 0 || shape == BALL_SLAB) {
                if (d[2] > 0) t = -p[2] / d[2];
                if (d[2] < 0 && shape == BALL_SLAB) t = -(p[2] + size) / d[2], below = 1;
            } else { /* the center at z = -size of a body, at +size of a hollow; a cylinder's axis along y */
                double o[3], a = 0, b = 0, c = -size * size, root;
                for (i = 0; i < 3; ++i) {
                    o[i] = p[i] + (i == 2 ? side * size : 0);
                    if (i == 1 && shape == BALL_CYLINDER) continue;
                    a += d[i] * d[i];
                    b += o[i] * d[i];
                    c += o[i] * o[i];
                }
                root = b * b - a * c;
                if (side > 0) t = a > 1e-12 ? (sqrt(root > 0 ? root : 0) - b) / a : HUGE_VAL;
                else if (root > 0 && b < 0) t = (-b - sqrt(root)) / a;
                if (side < 0 && t < 1e-12 * size) t = HUGE_VAL; /* it just left the hollow's wall */
                if (t < 0) t = 0;
            }
            if (length < t) {
                double u, v, q;
                for (i = 0; i < 3; ++i) p[i] += length * d[i];
                ++m;
                if (ball__uniform(&r) > BALL_SURVIVAL) break;
                do { /* Marsaglia's point on the sphere */
                    u = 2 * ball__uniform(&r) - 1;
                    v = 2 * ball__uniform(&r) - 1;
                    q = u * u + v * v;
                } while (q >= 1);
                s = 2 * sqrt(1 - q);
                d[0] = u * s;
                d[1] = v * s;
                d[2] = 1 - 2 * q;
                continue;
            }
            for (i = 0; i < 3; ++i) p[i] += t * d[i];
            if (curvature == 0 || shape == BALL_SLAB) {
                p[2] = below ? -size : 0;
                if (below) n[2] = -1;
            } else { /* onto the surface, against drift */
                double scale = 0;
                n[0] = p[0];
                n[1] = shape == BALL_CYLINDER ? 0 : p[1];
                n[2] = p[2] + side * size;
                for (i = 0; i < 3; ++i) scale += n[i] * n[i];
                scale = size / sqrt(scale);
                p[0] = n[0] * scale;
                if (shape != BALL_CYLINDER) p[1] = n[1] * scale;
                p[2] = n[2] * scale - side * size;
                for (i = 0; i < 3; ++i) n[i] *= side * scale / size;
            }
            mu = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
            if (mu < 0) mu = 0;
            if (index > 1 && ball__uniform(&r) < ball_fresnel(mu, 1 / index)) {
                for (i = 0; i < 3; ++i) d[i] -= 2 * mu * n[i];
                continue;
            }
            s = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            turn = s > 0.05 ? 1 + floor((log(s) - low) / step) : 0;
            for (i = 0; i < albedos; ++i) {
                if (below) {
                    out->through[i] += power[m][i];
                    continue;
                }
                out->total[i] += power[m][i];
                out->square[i] += power[m][i] * power[m][i];
                if (turn < BALL_BINS) out->ring[i][(int)turn] += power[m][i];
            }
            break;
        }
    }
    for (i = 0; i < albedos; ++i) {
        out->total[i] /= (double)walks;
        out->through[i] /= (double)walks;
        out->square[i] = out->square[i] / (double)walks - out->total[i] * out->total[i];
        for (m = 0; m < BALL_BINS; ++m) out->ring[i][m] /= (double)walks;
    }
    free(power);
}
#endif
