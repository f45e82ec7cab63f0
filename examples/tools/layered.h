/* Layers of isotropic scattering without noise: totals, rings of reflectance and transmittance, absorption over depth.
   Include after ms_mcml.h, whose implementation may be in another file. C99 and C++11.

     ms_mcml_layered solution;
     double error_per_cm2;
     status = ms_mcml_layered_solve(&tissue, NULL, &solution, &error);
     printf("R %g, T %g\n", solution.rd, solution.tt);
     printf("R at 1 mm: %g\n", ms_mcml_layered_ring(&solution, 0, 0.1, 0.11, &error_per_cm2));

   Which media. 1 to 4 layers; g = 0 in every layer that scatters (scale a tissue of another g to mu_s (1 - g), or trace
   photons); no clear layer; refractive indices 1 to 2.5; extinction coefficients mu_a + mu_s within a factor of 50 of
   each other; layers of at least 0.2 mean free paths. ms_mcml_layered_solve refuses others with MS_UNSUPPORTED and a
   sentence that says which of these fails: ms_mcml_simulate answers for them.

   Errors. rd_error and tt_error bound the totals. Each ring has an error that bounds it. tests/test_mcml_layered.c draws
   random media of that domain and compares their rings with photons.

   Costs. 5 to 200 ms for one to three layers, below 2 s for four; 0.1 to 6 MB; one thread.

   Method
   ------
   For a lateral spatial frequency k the fluence phi(z) of the layers obeys, with the emission S = mu_s phi,

     phi(z) = phi_beam(z) + integral G(z, z') S(z') dz'

   G holds the flights within a layer and, ray by ray, those by way of the boundaries. Galerkin's method solves it with
   decaying exponentials from both sides of each layer, exp(-b z) and exp(-b (d - z)). All integrals over depth have
   closed forms; rays are Gauss nodes in n sin(theta) and in the azimuth. phi / n^2 makes the system symmetric and
   positive.

   The light that leaves is single scattering of the layer at that surface, which is known in space, and a spectrum
   v(k). A ridge regression turns v(k) into a sum of  energy / (1 + k^2 / rate^2),  each of which has a closed form in
   space, x K1(x). Unlike in a half-space, energies may be negative.

   Sources: Williams 2007 ("The searchlight problem in radiative transfer with internal reflection"); Case & Zweifel
   1967 ("Linear Transport Theory"), for the slowest decay; Hoerl & Kennard 1970, for the ridge. */
#ifndef LAYERED_H
#define LAYERED_H
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    LAYERED_LAYERS = 4,
    LAYERED_RATES = 110,
    LAYERED_SINGLES = 40, /* rays of single scattering: 3e-4 of a ring */
    LAYERED_RADII = 96    /* of the table of errors */
};

/* All zero: the defaults. */
typedef struct ms_mcml_layered_options {
    int totals_only; /* not 0: no rings, only what does not depend on r: one frequency in place of some 30 */
    double dz_cm;    /* > 0 with a_z */
    int nz;
    double
        *a_z; /* [nz] out: absorbed between i dz and (i + 1) dz, 1/cm, the last of them all that lies below; or NULL */
    double *a_l; /* [layer_count] out: part absorbed in each layer; or NULL */
    ms_progress progress;
    ms_allocator allocator;
} ms_mcml_layered_options;

/* Scattered light that leaves one surface, over radius; read it with ms_mcml_layered_outside and _ring. */
typedef struct ms_mcml_layered_side {
    int rates, singles;
    double energy[LAYERED_RATES];   /* of ms_mcml_layered.rate_per_cm */
    double weight[LAYERED_SINGLES]; /* of single scattering along a ray: times two exponentials in depth */
    double cotangent[LAYERED_SINGLES];
    double rate_per_cm[2][LAYERED_SINGLES], beam[2]; /* of the beam that enters and of the one that is reflected */
    double depth_cm;                                 /* of the layer at this surface; above 1e200: without end */
    double falling[LAYERED_RADII];                   /* energy beyond each radius of the table, made to fall */
    double tail_cm, tail, tail_rate;                 /* beyond tail_cm: tail exp(-tail_rate (r - tail_cm)) */
    double error[LAYERED_RADII]; /* of the energy between the radii radius_cm exp(0.25 (i - 1)) and 0.25 i; 0: from 0 */
} ms_mcml_layered_side;

/* Reflectance and transmittance of layers under a pencil beam at normal incidence. A plain value: copy it freely.
   Totals are parts of the light that arrives, and count as MCML counts: specular is what the surface reflects at entry;
   rd and tt include light that never scattered. The fields from side[] on belong to the solver. */
typedef struct ms_mcml_layered {
    double specular, rd, rd_error, tt, tt_error, a, rd_unscattered, tt_unscattered;
    ms_mcml_layered_side side[2]; /* top, bottom */
    double rate_per_cm[LAYERED_RATES], radius_cm;
    int totals_only;
} ms_mcml_layered;

/* ---- numbers --------------------------------------------------------------------------------------------------- */

typedef struct layered__complex {
    double re, im;
} layered__complex;

static inline layered__complex layered__make(double re, double im)
{
    layered__complex x;
    x.re = re;
    x.im = im;
    return x;
}

static inline layered__complex layered__times(layered__complex a, layered__complex b)
{
    return layered__make(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

static inline layered__complex layered__scale(layered__complex a, double s)
{
    return layered__make(a.re * s, a.im * s);
}

static inline layered__complex layered__over(layered__complex a, layered__complex b)
{
    const double s = 1 / (b.re * b.re + b.im * b.im);
    return layered__make(s * (a.re * b.re + a.im * b.im), s * (a.im * b.re - a.re * b.im));
}

/* s / (1 - a b): what a source of s sends out when a and b reflect it to and fro. */
static inline layered__complex layered__to_and_fro(layered__complex s, layered__complex a, layered__complex b)
{
    const layered__complex loop = layered__times(a, b);
    return layered__over(s, layered__make(1 - loop.re, -loop.im));
}

static inline ms_status layered__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    if (error) {
        va_list list;
        error->status = status;
        error->position = position;
        va_start(list, format);
        vsnprintf(error->message, sizeof error->message, format, list);
        va_end(list);
    }
    return status;
}

static inline void *layered__alloc(const ms_allocator *a, size_t size)
{
    return a->alloc ? a->alloc(a->user, size) : malloc(size);
}

static inline void layered__release(const ms_allocator *a, void *block, size_t size)
{
    if (block == NULL) return;
    if (a->alloc == NULL) free(block);
    else if (a->release) a->release(a->user, block, size);
}

static inline int layered__between(double x, double low, double high) { return x >= low && x <= high; }

/* Gauss nodes and weights on [0, 1]. */
static inline void layered__gauss(int count, double *node, double *weight)
{
    int i, k, turn;
    for (i = 0; i < count; ++i) {
        double x = cos(3.14159265358979324 * (i + 0.75) / (count + 0.5)), slope = 1;
        for (turn = 0; turn < 30; ++turn) { /* Newton on Legendre's polynomial */
            double p = 1, before = 0, step;
            for (k = 1; k <= count; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = count * (x * p - before) / (x * x - 1);
            step = p / slope;
            x -= step;
            if (fabs(step) < 1e-15) break;
        }
        node[i] = 0.5 * (1 - x);
        weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* x K1(x), relative error 6e-12: the power series up to 2, then sqrt(x) exp(x) K1(x) as a polynomial in 2 / x. */
static inline double layered__x_bessel_k1(double x)
{
    static const double p[] = {1.2533141373223884,     0.23499639828639249,    -0.036718040184640545,
                               0.016060675864789022,   -0.011250123789009064,  0.010517606692691388,
                               -0.01136402908770562,   0.012188203438317703,   -0.011308843515876503,
                               0.0081313856435097981,  -0.0040970924956295601, 0.0012653699962738531,
                               -0.00017867465249178075};
    double sum = 0, y;
    int i;
    if (!(x > 0)) return 1;
    if (x <= 2) { /* 1 + x^2 / 2 sum (x^2 / 4)^m / (m! (m+1)!) (ln(x / 2) - (psi(m+1) + psi(m+2)) / 2) */
        double term = 1, log_half = log(0.5 * x), psi = -0.57721566490153286 + 0.5;
        y = 0.25 * x * x;
        for (i = 0; i < 12; ++i) {
            sum += term * (log_half - psi);
            term *= y / ((i + 1) * (i + 2));
            psi += 0.5 / (i + 1) + 0.5 / (i + 2);
        }
        return 1 + 2 * y * sum;
    }
    y = 2 / x;
    for (i = (int)(sizeof p / sizeof p[0]) - 1; i >= 0; --i) sum = sum * y + p[i];
    return sum * sqrt(x) * exp(-x);
}

/* Fresnel reflectance from n1 to n2 for nu = n sin(theta); 1 for total reflection. */
static inline double layered__fresnel(double n1, double n2, double nu)
{
    double cos1, cos2, s, p;
    if (!(nu < n1) || !(nu < n2)) return 1;
    cos1 = sqrt((n1 - nu) * (n1 + nu)) / n1;
    cos2 = sqrt((n2 - nu) * (n2 + nu)) / n2;
    s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
    p = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
    return 0.5 * (s * s + p * p);
}

/* The slowest decay in depth, per mean free path: the root of  albedo atanh(nu) = nu  (Case & Zweifel 1967), by
   bisection of y = atanh(nu) in  tanh(y) = albedo y. */
static inline double layered__slowest_decay(double albedo, double absorption)
{
    double low = 0, high = 40;
    int i;
    if (absorption < 1e-4) return sqrt(3 * absorption) * (1 - 0.4 * absorption);
    for (i = 0; i < 60; ++i) {
        const double y = 0.5 * (low + high);
        if (tanh(y) > albedo * y) low = y;
        else high = y;
    }
    return tanh(low);
}

/* Integral over a layer of exp(-a z) exp(-b (d - z)); ea = exp(-a d), eb = exp(-b d). */
static inline double layered__crossing(double a, double ea, double b, double eb, double d)
{
    const double y = (b - a) * d;
    if (d > 1e200) return 0;
    return fabs(y) < 1e-3 ? d * ea * (1 - y / 2 * (1 - y / 3 * (1 - y / 4))) : (ea - eb) / (b - a);
}

/* Minus its derivative by a, at a = b, mixed with b: the integral over z < z' of exp(-a z - b (z' - z) - a (d - z')).
 */
static inline double layered__crossing_twice(double a, double ea, double b, double eb, double d)
{
    const double y = (b - a) * d;
    if (d > 1e200) return 0;
    return fabs(y) < 0.02 ? d * d * ea * (0.5 - y / 6 * (1 - y / 4 * (1 - y / 5 * (1 - y / 6))))
                          : (d * ea - (ea - eb) / (b - a)) / (b - a);
}

/* ---- layers and beam ------------------------------------------------------------------------------------------- */

/* Constants of the method. Each was halved, doubled, or moved by a third: what stands here changes v(k) of the tests'
   media by 1e-6 or less. */
enum {
    LAYERED__SIDE_MAX = 40,     /* exponentials from one side of a layer: from 1/11 to 60 k / mu_t, 0.8 apart */
    LAYERED__FLIGHT_NODES = 56, /* of a flight within a layer */
    LAYERED__RAYS = 20,         /* of a panel of nu = n sin(theta), where all layers are a mean free path thick */
    LAYERED__AZIMUTHS = 16,     /* at most, in a quarter of the circle */
    LAYERED__RAYS_THIN = 20,    /* the same in thinner layers, where slant light goes far between two surfaces */
    LAYERED__AZIMUTHS_THIN = 24,
    LAYERED__RAYS_AT_0 = 40 /* at k = 0, where there is one azimuth */
};

/* Spacing of the logarithms of the exponentials' rates. What leaves has the square of the error of phi, and 0.8 is
   enough for it; what is absorbed has the error itself: 1e-5 at 0.4. */
static const double layered__spacing = 0.8, layered__spacing_at_0 = 0.4;

typedef struct layered__layer {
    double n, d, mu_a, mu_s, mu_t; /* d above 1e200: without end */
    double decay;                  /* the slowest, per cm */
    double down, up;               /* the beam: at the top going down, at the bottom going up */
    int endless, first, count;     /* its exponentials */
} layered__layer;

/* exp(-b z), or mirrored exp(-b (d - z)), and integrals over the flights exp(-w |z - z'|), w = mu_t / cos(theta) at k =
   0: the sums over w of the flights' weights times 1 / (b + w), exp(-w d) / (b + w), their squares, and the crossing.
 */
typedef struct layered__function {
    double b, end; /* exp(-b d) */
    double beam;   /* the beam's phi / n^2 is the sum of beam times function */
    double flight, flight_end, flight2, flight2_end, cross, cross2;
    int layer, mirrored;
} layered__function;

typedef struct layered__solver {
    int layers, functions, room;                       /* room: a multiple of 4, the length of a row */
    int rays, azimuths, ray_count, azimuth_count;      /* to take, at most, and that the nodes are of */
    double n_above, n_below, k, specular, unscattered; /* reflected and transmitted without scattering */
    double least;                                      /* of mu_t, or of 1 / d of thinner layers */
    double spacing;                                    /* of the logarithms of rates */
    layered__layer layer[LAYERED_LAYERS];
    double edge[LAYERED_LAYERS + 2]; /* of the panels of nu, ascending */
    int edges;
    double ray[64], ray_weight[64], azimuth[64], azimuth_weight[64];
    double single[2];             /* of the layer at each surface, of the spectrum at k */
    layered__function *f;         /* [functions] */
    double *gram, *exchange;      /* [functions][room] mu_s n^2 <f, g>, and <mu_s n^2 f, G mu_s g> */
    double *solution, *escape[2]; /* [room] */
    layered__complex *up, *down;  /* [room] of a ray: what each function sends out at the top and at the bottom */
    double *in[4]; /* [layers][room] what enters a layer then, real and imaginary: at its top, at its bottom */
    ms_allocator allocator;
    size_t size;
} layered__solver;

/* Whether the solver answers for these layers. */
static inline ms_status layered__check(const ms_mcml_tissue *t, ms_error *error)
{
    double least = 1e300, most = 0;
    int i;
    if (t->layer_count < 1 || t->layer_count > LAYERED_LAYERS || t->layers == NULL)
        return layered__fail(error, MS_UNSUPPORTED, 0, "%d layers: the layered solver takes 1 to %d; photons take more",
                             t->layer_count, LAYERED_LAYERS);
    for (i = -1; i <= t->layer_count; ++i) {
        const double n = i < 0 ? t->n_above : i < t->layer_count ? t->layers[i].n : t->n_below;
        if (!layered__between(n, 1, 2.5))
            return layered__fail(error, MS_UNSUPPORTED, (size_t)(i + 1),
                                 "n is %g: the layered solver takes 1 to 2.5; photons take 0.01 to 100", n);
    }
    for (i = 0; i < t->layer_count; ++i) {
        const ms_mcml_layer *y = &t->layers[i];
        const double mu_t = y->mu_a_per_cm + y->mu_s_per_cm;
        if (!layered__between(y->mu_a_per_cm, 0, 1e9) || !layered__between(y->mu_s_per_cm, 0, 1e9) ||
            !layered__between(y->thickness_cm, 1e-300, 1e300))
            return layered__fail(error, MS_INVALID_ARGUMENT, (size_t)(i + 1),
                                 "layer %d: mu_a %g, mu_s %g, expected 0 to 1e9 per cm; thickness %g, above 0 cm",
                                 i + 1, y->mu_a_per_cm, y->mu_s_per_cm, y->thickness_cm);
        if (y->mu_s_per_cm > 0 && (y->g < 0 || y->g > 0 || !(y->g <= 0)))
            return layered__fail(
                error, MS_UNSUPPORTED, (size_t)(i + 1),
                "layer %d: g is %g: the layered solver takes 0 (with mu_s (1 - g)); photons take any g", i + 1, y->g);
        if (!(mu_t > 0))
            return layered__fail(error, MS_UNSUPPORTED, (size_t)(i + 1),
                                 "layer %d is clear: photons take it, the layered solver does not", i + 1);
        if (!(mu_t * y->thickness_cm >= 0.2))
            return layered__fail(error, MS_UNSUPPORTED, (size_t)(i + 1),
                                 "layer %d is %g mean free paths thick: the layered solver takes 0.2 and more; "
                                 "photons take any",
                                 i + 1, mu_t * y->thickness_cm);
        least = fmin(least, mu_t);
        most = fmax(most, mu_t);
    }
    if (most > 50 * least)
        return layered__fail(error, MS_UNSUPPORTED, 0,
                             "mu_a + mu_s is from %g to %g per cm: the layered solver takes a factor of 50; photons "
                             "take any",
                             least, most);
    return MS_OK;
}

/* The beam in every layer, down and up, by reflectances from the bottom upwards: rho is up over down. */
static inline void layered__beam(layered__solver *s)
{
    double ratio[LAYERED_LAYERS], pass[LAYERED_LAYERS], through[LAYERED_LAYERS], rho = 0, top, down;
    int i;
    for (i = s->layers - 1; i >= 0; --i) {
        const layered__layer *y = &s->layer[i];
        const double below = i + 1 < s->layers ? s->layer[i + 1].n : s->n_below;
        const double r = y->endless ? 0 : layered__fresnel(y->n, below, 0);
        through[i] = y->endless ? 0 : exp(-y->mu_t * y->d);
        ratio[i] = r + (1 - r) * (1 - r) * rho / (1 - r * rho);
        pass[i] = (1 - r) / (1 - r * rho);
        rho = ratio[i] * through[i] * through[i];
    }
    top = layered__fresnel(s->n_above, s->layer[0].n, 0);
    down = (1 - top) / (1 - top * rho);
    s->specular = top + (1 - top) * (1 - top) * rho / (1 - top * rho);
    for (i = 0; i < s->layers; ++i) {
        s->layer[i].down = down;
        s->layer[i].up = down * through[i] * ratio[i];
        down *= through[i] * pass[i];
    }
    s->unscattered = down;
}

/* The panels of nu end at every index that light can come from or go to, below the highest of the layers. */
static inline void layered__panels(layered__solver *s)
{
    double all[LAYERED_LAYERS + 2], highest = 0, x;
    int i, j, count = 0;
    all[count++] = s->n_above;
    if (!s->layer[s->layers - 1].endless) all[count++] = s->n_below;
    for (i = 0; i < s->layers; ++i) {
        all[count++] = s->layer[i].n;
        highest = fmax(highest, s->layer[i].n);
    }
    for (i = 0; i < count; ++i) {
        for (j = i + 1; j < count; ++j)
            if (all[j] < all[i]) {
                x = all[i];
                all[i] = all[j];
                all[j] = x;
            }
        x = fmin(all[i], highest);
        if (s->edges == 0 || x > s->edge[s->edges - 1] * (1 + 1e-9)) s->edge[s->edges++] = x;
    }
}

static inline void layered__destroy(layered__solver *s)
{
    const ms_allocator allocator = s->allocator;
    layered__release(&allocator, s, s->size);
}

/* Layers, beam and room for the functions. */
static inline ms_status layered__create(layered__solver **out, const ms_mcml_tissue *t, const ms_allocator *allocator,
                                        ms_error *error)
{
    const size_t room = (size_t)(2 * LAYERED__SIDE_MAX * t->layer_count), layers = (size_t)t->layer_count;
    const size_t numbers = 2 * room * room + (7 + 4 * layers) * room;
    const size_t size = sizeof(layered__solver) + room * sizeof(layered__function) + numbers * sizeof(double);
    layered__solver *s = (layered__solver *)layered__alloc(allocator, size);
    double *at;
    int i;
    if (s == NULL)
        return layered__fail(error, MS_OUT_OF_MEMORY, 0, "no %.0f bytes for the layered solver", (double)size);
    memset(s, 0, size);
    s->allocator = *allocator;
    s->size = size;
    s->f = (layered__function *)(s + 1);
    at = (double *)(s->f + room);
    s->up = (layered__complex *)at;
    s->down = s->up + room;
    at += 4 * room;
    for (i = 0; i < 4; ++i, at += layers * room) s->in[i] = at;
    s->solution = at;
    s->escape[0] = at + room;
    s->escape[1] = at + 2 * room;
    s->gram = at + 3 * room;
    s->exchange = s->gram + room * room;

    s->n_above = t->n_above;
    s->n_below = t->n_below;
    s->spacing = layered__spacing;
    s->least = 1e300;
    for (i = 0; i < t->layer_count && (i == 0 || !s->layer[i - 1].endless); ++i) {
        const ms_mcml_layer *from = &t->layers[i];
        layered__layer *y = &s->layer[s->layers++];
        y->n = from->n;
        y->d = from->thickness_cm;
        y->mu_s = fmax(from->mu_s_per_cm, 1e-9 * from->mu_a_per_cm); /* so that each layer has functions */
        y->mu_a = fmax(from->mu_a_per_cm, 1e-14 * y->mu_s);          /* so that depth ends: 3e-7 of the light */
        y->mu_t = y->mu_a + y->mu_s;
        y->decay = y->mu_t * layered__slowest_decay(y->mu_s / y->mu_t, y->mu_a / y->mu_t);
        y->endless = y->decay * y->d > 30;
        if (y->endless) y->d = 1e300;
        s->least = fmin(s->least, y->mu_t * y->d > 1 ? y->mu_t : 1 / y->d);
    }
    layered__beam(s);
    layered__panels(s);
    *out = s;
    return MS_OK;
}

/* ---- functions of depth ---------------------------------------------------------------------------------------- */

static inline void layered__add_function(layered__solver *s, int layer, int mirrored, double b, double beam)
{
    layered__function *f = &s->f[s->functions++];
    memset(f, 0, sizeof *f);
    f->b = b;
    f->end = s->layer[layer].endless ? 0 : exp(-b * s->layer[layer].d);
    f->beam = beam;
    f->layer = layer;
    f->mirrored = mirrored;
}

/* The functions at frequency k. The field of a layer is two waves of the slowest decay t = sqrt(decay^2 + k^2), one
   from each side, and what decays faster near its surfaces: the beam, at the rate mu_t, and a lattice of rates. Two
   rates nearer than half the spacing would be the same in double precision. */
static inline void layered__choose_functions(layered__solver *s)
{
    int i, side;
    s->functions = 0;
    for (i = 0; i < s->layers; ++i) {
        layered__layer *y = &s->layer[i];
        const double paths = y->mu_t * y->d, slow = sqrt(y->decay * y->decay + s->k * s->k) / y->mu_t;
        const double t = y->endless ? slow : fmax(slow, 0.01 / paths); /* slower is linear, and a sum of both */
        const double low = y->endless ? 0.09 : fmax(0.09, 0.7 / paths), high = fmax(60 * fmax(t, 1), 3 * low);
        const int apart = fabs(log(t)) > 0.5;
        y->first = s->functions;
        for (side = 0; side < (y->endless ? 1 : 2); ++side) {
            double b = exp(s->spacing * ceil(log(low) / s->spacing));
            layered__add_function(s, i, side, y->mu_t, (side ? y->up : y->down) / (y->n * y->n));
            if (apart) layered__add_function(s, i, side, t * y->mu_t, 0);
            for (; b < high && s->functions - y->first < (side + 1) * LAYERED__SIDE_MAX; b *= exp(s->spacing))
                if (fabs(log(b)) > 0.5 * s->spacing && (!apart || fabs(log(b / t)) > 0.5 * s->spacing))
                    layered__add_function(s, i, side, b * y->mu_t, 0);
        }
        y->count = s->functions - y->first;
    }
    s->room = (s->functions + 3) / 4 * 4;
}

/* Flights within a layer, k > 0 or not:  G(z) = 1/2 int_1^inf exp(-w z) / w ds,  w = sqrt((mu_t s)^2 + k^2), the sum
   over nodes of x = 1 / s of a double exponential rule: it clusters them at both ends. */
static inline void layered__sum_flights(layered__solver *s)
{
    const double nodes = (double)(int)LAYERED__FLIGHT_NODES, step = 6.6 / nodes;
    int i, c;
    for (c = 0; c < (int)LAYERED__FLIGHT_NODES; ++c) {
        const double u = (c + 0.5 - 0.5 * nodes) * step;
        const double e = exp(-3.14159265358979324 * sinh(u)), x = 1 / (1 + e);
        const double dx = step * 3.14159265358979324 * cosh(u) * e * x * x;
        for (i = 0; i < s->layers; ++i) {
            const layered__layer *y = &s->layer[i];
            const double kx = s->k / y->mu_t * x, root = sqrt(1 + kx * kx), w = root / x * y->mu_t;
            const double weight = 0.5 * dx / (x * root), end = y->endless ? 0 : exp(-w * y->d);
            layered__function *f = s->f + y->first, *stop = f + y->count;
            for (; f < stop; ++f) {
                const double q = 1 / (f->b + w);
                f->flight += weight * q;
                f->flight_end += weight * q * end;
                f->flight2 += weight * q * q;
                f->flight2_end += weight * q * q * end;
                f->cross += weight * layered__crossing(f->b, f->end, w, end, y->d);
                f->cross2 += weight * layered__crossing_twice(f->b, f->end, w, end, y->d);
            }
        }
    }
}

/* gram and exchange by flights within each layer. With b, c the rates, E = 1 / (b + w) summed over flights, X the
   crossing, both from the same side and from opposite sides:
     <f, g>   = (1 - e_b e_c) / (b + c)                                         and the crossing of b and c
     <f, G g> = (E_b + E_c - e_c (E'_c + X_b) - e_b (E'_b + X_c)) / (b + c)     E': with exp(-w d)
              = ((X_b - X_c) - e_c ((E_b - e_b E'_b) - (E_c - e_b E'_c))) / (c - b) + <f, g> E_c */
static inline void layered__direct(layered__solver *s)
{
    const size_t room = (size_t)s->room;
    int i, j;
    memset(s->gram, 0, room * (size_t)s->functions * sizeof(double));
    memset(s->exchange, 0, room * (size_t)s->functions * sizeof(double));
    for (i = 0; i < s->functions; ++i) {
        const layered__function *f = &s->f[i];
        const layered__layer *y = &s->layer[f->layer];
        for (j = y->first; j <= i; ++j) {
            const layered__function *g = &s->f[j];
            const double b = f->b, c = g->b;
            double inner, flights;
            if (f->mirrored == g->mirrored) {
                inner = (y->endless ? 1 : -expm1(-(b + c) * y->d)) / (b + c);
                flights = f->flight + g->flight - g->end * (g->flight_end + f->cross) -
                    f->end * (f->flight_end + g->cross);
                flights /= b + c;
            } else {
                inner = layered__crossing(b, f->end, c, g->end, y->d);
                if (fabs(b - c) < 1e-9 * b) { /* the limit */
                    flights = f->cross2 + f->end * (y->d * f->flight - f->flight2 + f->end * f->flight2_end);
                } else {
                    flights = f->cross - g->cross -
                        g->end * ((f->flight - f->end * f->flight_end) - (g->flight - f->end * g->flight_end));
                    flights = flights / (c - b) + inner * g->flight;
                }
            }
            s->gram[(size_t)i * room + (size_t)j] = y->mu_s * y->n * y->n * inner;
            s->exchange[(size_t)i * room + (size_t)j] = y->mu_s * y->mu_s * y->n * y->n * flights;
        }
    }
}

/* ---- rays ------------------------------------------------------------------------------------------------------ */

/* A ray through all layers. Amplitudes are radiance / n^2, which refraction keeps. */
typedef struct layered__ray {
    double weight;                                /* nu dnu / 2 times the part of the azimuth */
    double nu, mu[LAYERED_LAYERS];                /* mu: cos(theta), 0 where the ray does not exist */
    double r[LAYERED_LAYERS + 1];                 /* of the boundary above layer i */
    layered__complex rate[LAYERED_LAYERS];        /* exp(-rate z) along z */
    layered__complex pass[LAYERED_LAYERS];        /* exp(-rate d) */
    layered__complex floor[LAYERED_LAYERS];       /* up over down at its bottom, by all that lies below */
    layered__complex ceiling[LAYERED_LAYERS];     /* down over up at its top, by all that lies above */
    layered__complex floor_far[LAYERED_LAYERS];   /* floor as seen from its top: floor pass^2 */
    layered__complex ceiling_far[LAYERED_LAYERS]; /* ceiling as seen from its bottom */
} layered__ray;

/* Reflectance of a boundary r with rho behind it:  r + (1 - r)^2 rho / (1 - r rho). */
static inline layered__complex layered__behind(double r, layered__complex rho)
{
    layered__complex sum = layered__to_and_fro(layered__scale(rho, (1 - r) * (1 - r)), layered__make(r, 0), rho);
    sum.re += r;
    return sum;
}

/* Boundaries and layers along the ray nu at an azimuth whose cosine to the wave is given. */
static inline void layered__trace(const layered__solver *s, double nu, double cosine, layered__ray *ray)
{
    int i;
    ray->nu = nu;
    for (i = 0; i < s->layers; ++i) {
        const layered__layer *y = &s->layer[i];
        const double sine = nu / y->n, above = i > 0 ? s->layer[i - 1].n : s->n_above;
        ray->r[i] = layered__fresnel(above, y->n, nu);
        ray->mu[i] = sine < 1 ? sqrt((1 - sine) * (1 + sine)) : 0;
        ray->pass[i] = layered__make(0, 0);
        if (!(ray->mu[i] > 0)) continue;
        ray->rate[i] = layered__make(y->mu_t / ray->mu[i], s->k * sine * cosine / ray->mu[i]);
        if (!y->endless && ray->rate[i].re * y->d < 700) {
            const double e = exp(-ray->rate[i].re * y->d), angle = ray->rate[i].im * y->d;
            ray->pass[i] = layered__make(e * cos(angle), -e * sin(angle));
        }
    }
    ray->r[i] = s->layer[i - 1].endless ? 0 : layered__fresnel(s->layer[i - 1].n, s->n_below, nu);
    for (i = s->layers - 1; i >= 0; --i) {
        const int open = i + 1 < s->layers && ray->r[i + 1] < 1;
        if (!(ray->mu[i] > 0)) continue;
        ray->floor[i] = open ? layered__behind(ray->r[i + 1], ray->floor_far[i + 1]) : layered__make(ray->r[i + 1], 0);
        ray->floor_far[i] = layered__times(ray->floor[i], layered__times(ray->pass[i], ray->pass[i]));
    }
    for (i = 0; i < s->layers; ++i) {
        const int open = i > 0 && ray->r[i] < 1;
        if (!(ray->mu[i] > 0)) continue;
        ray->ceiling[i] = open ? layered__behind(ray->r[i], ray->ceiling_far[i - 1]) : layered__make(ray->r[i], 0);
        ray->ceiling_far[i] = layered__times(ray->ceiling[i], layered__times(ray->pass[i], ray->pass[i]));
    }
}

/* What light enters the layers below `from`, at their tops and bottoms, when `flux` reaches the bottom of `from` (-1:
   from outside), and the layers above it likewise; layers that it does not reach keep what they have. */
static inline void layered__spread_down(const layered__solver *s, const layered__ray *ray, int from,
                                        layered__complex flux, layered__complex *top, layered__complex *bottom)
{
    int i;
    for (i = from + 1; i < s->layers && ray->r[i] < 1; ++i) {
        flux = layered__scale(flux, 1 - ray->r[i]);
        top[i] = layered__to_and_fro(flux, layered__make(ray->r[i], 0), ray->floor_far[i]);
        flux = layered__times(ray->pass[i], top[i]);
        bottom[i] = layered__times(ray->floor[i], flux);
    }
}

static inline void layered__spread_up(const layered__solver *s, const layered__ray *ray, int from,
                                      layered__complex flux, layered__complex *top, layered__complex *bottom)
{
    int i;
    (void)s;
    for (i = from - 1; i >= 0 && ray->r[i + 1] < 1; --i) {
        flux = layered__scale(flux, 1 - ray->r[i + 1]);
        bottom[i] = layered__to_and_fro(flux, layered__make(ray->r[i + 1], 0), ray->ceiling_far[i]);
        flux = layered__times(ray->pass[i], bottom[i]);
        top[i] = layered__times(ray->ceiling[i], flux);
    }
}

/* What each function sends out along the ray, times mu_s / mu:  integral of f exp(-rate z) at the top, of
   f exp(-rate (d - z)) at the bottom. One of them is  (1 - e_b e) / (b + rate),  the other the crossing
   (e - e_b) / (b - rate). */
static inline void layered__emit(layered__solver *s, const layered__ray *ray)
{
    int i, j;
    for (i = 0; i < s->layers; ++i) {
        const layered__layer *y = &s->layer[i];
        const layered__complex rate = ray->rate[i], e = ray->pass[i];
        if (!(ray->mu[i] > 0)) continue;
        for (j = y->first; j < y->first + y->count; ++j) {
            const layered__function *f = &s->f[j];
            const layered__complex apart = layered__make(f->b - rate.re, -rate.im);
            const double scale = y->mu_s / ray->mu[i];
            layered__complex near = layered__make(1 - f->end * e.re, -f->end * e.im), far = layered__make(0, 0);
            near = layered__over(near, layered__make(f->b + rate.re, rate.im));
            if (!y->endless) {
                const double size = (apart.re * apart.re + apart.im * apart.im) * y->d * y->d;
                if (size > 1e-6) {
                    far = layered__over(layered__make(e.re - f->end, e.im), apart);
                } else { /* the series of the crossing */
                    const layered__complex x = layered__scale(apart, y->d), xx = layered__times(x, x);
                    far = layered__make(1 + x.re / 2 + xx.re / 6, x.im / 2 + xx.im / 6);
                    far = layered__scale(far, y->d * f->end);
                }
            }
            s->up[j] = layered__scale(f->mirrored ? far : near, scale);
            s->down[j] = layered__scale(f->mirrored ? near : far, scale);
        }
    }
}

/* in: what of each function's light enters each layer, at its top and bottom, after all reflections. */
static inline void layered__enter(layered__solver *s, const layered__ray *ray)
{
    const size_t room = (size_t)s->room;
    int source, side, i, j;
    for (source = 0; source < s->layers; ++source) {
        const layered__layer *y = &s->layer[source];
        layered__complex top[2][LAYERED_LAYERS], bottom[2][LAYERED_LAYERS];
        memset(top, 0, sizeof top);
        memset(bottom, 0, sizeof bottom);
        for (side = 0; side < 2 && ray->mu[source] > 0; ++side) { /* 1 sent out at its top; at its bottom */
            const layered__complex pass = ray->pass[source], one = layered__make(1, 0);
            layered__complex *a = &top[side][source], *c = &bottom[side][source], up, down;
            if (side == 0) {
                *a = layered__to_and_fro(ray->ceiling[source], ray->ceiling[source], ray->floor_far[source]);
                *c = layered__times(ray->floor[source], layered__times(pass, *a));
            } else {
                *c = layered__to_and_fro(ray->floor[source], ray->floor[source], ray->ceiling_far[source]);
                *a = layered__times(ray->ceiling[source], layered__times(pass, *c));
            }
            down = layered__times(pass, *a);
            up = layered__times(pass, *c);
            if (side == 0) up.re += one.re;
            else down.re += one.re;
            layered__spread_down(s, ray, source, down, top[side], bottom[side]);
            layered__spread_up(s, ray, source, up, top[side], bottom[side]);
        }
        for (i = 0; i < s->layers; ++i) {
            double *const to[4] = {s->in[0] + (size_t)i * room, s->in[1] + (size_t)i * room,
                                   s->in[2] + (size_t)i * room, s->in[3] + (size_t)i * room};
            for (j = y->first; j < y->first + y->count; ++j) {
                const layered__complex u = s->up[j], d = s->down[j];
                const layered__complex t0 = top[0][i], t1 = top[1][i], b0 = bottom[0][i], b1 = bottom[1][i];
                to[0][j] = u.re * t0.re - u.im * t0.im + d.re * t1.re - d.im * t1.im;
                to[1][j] = u.re * t0.im + u.im * t0.re + d.re * t1.im + d.im * t1.re;
                to[2][j] = u.re * b0.re - u.im * b0.im + d.re * b1.re - d.im * b1.im;
                to[3][j] = u.re * b0.im + u.im * b0.re + d.re * b1.im + d.im * b1.re;
            }
        }
    }
}

/* exchange += weight Re(up_i top_j + down_i bottom_j): the light of j that enters the layer of i. By reciprocity what i
   collects along a ray is what it would send out. */
static inline void layered__collect(layered__solver *s, const layered__ray *ray)
{
    const size_t room = (size_t)s->room;
    int i, j;
    for (i = 0; i < s->functions; ++i) {
        const size_t layer = (size_t)s->f[i].layer * room;
        const double ur = ray->weight * s->up[i].re, ui = ray->weight * s->up[i].im;
        const double dr = ray->weight * s->down[i].re, di = ray->weight * s->down[i].im;
        double *row = s->exchange + (size_t)i * room;
        const double *tr = s->in[0] + layer, *ti = s->in[1] + layer, *br = s->in[2] + layer, *bi = s->in[3] + layer;
        if (!(ray->mu[s->f[i].layer] > 0)) continue;
#if defined(__GNUC__) && __FLT_EVAL_METHOD__ != 2 /* x87's products are long doubles, which have no vectors */
        for (j = 0; j <= i; j += 4) {             /* a row has room for whole vectors */
            typedef double four __attribute__((vector_size(32), aligned(8), may_alias));
            *(four *)(row + j) += ur * *(const four *)(tr + j) - ui * *(const four *)(ti + j) +
                dr * *(const four *)(br + j) - di * *(const four *)(bi + j);
        }
#else
        for (j = 0; j <= i; ++j) row[j] += ur * tr[j] - ui * ti[j] + dr * br[j] - di * bi[j];
#endif
    }
}

/* escape: what leaves at the top and at the bottom of each function, which is what light from there brings to it; and
   the single scattering of the layer there, without a reflection. */
static inline void layered__leave(layered__solver *s, const layered__ray *ray)
{
    int side, i, j;
    for (side = 0; side < 2; ++side) {
        const int at = side ? s->layers - 1 : 0, boundary = side ? s->layers : 0;
        const layered__layer *y = &s->layer[at];
        layered__complex top[LAYERED_LAYERS], bottom[LAYERED_LAYERS];
        if ((side && y->endless) || !(ray->r[boundary] < 1)) continue;
        memset(top, 0, sizeof top);
        memset(bottom, 0, sizeof bottom);
        if (side) layered__spread_up(s, ray, s->layers, layered__make(1, 0), top, bottom);
        else layered__spread_down(s, ray, -1, layered__make(1, 0), top, bottom);
        for (i = 0; i < s->layers; ++i)
            for (j = s->layer[i].first; j < s->layer[i].first + s->layer[i].count; ++j)
                s->escape[side][j] += ray->weight *
                    (top[i].re * s->up[j].re - top[i].im * s->up[j].im + bottom[i].re * s->down[j].re -
                     bottom[i].im * s->down[j].im);
        for (j = y->first; j < y->first + y->count; ++j)
            s->single[side] += ray->weight * (1 - ray->r[boundary]) * s->f[j].beam *
                (side ? s->down[j].re : s->up[j].re);
    }
}

/* All rays. The first panel of nu is in two: the part at the normal is sinh-spaced on the scale of mu_t / k, on which
   the wave's phase changes; the other panels cluster at their upper ends, where Fresnel's law has a root and light goes
   along the layers. Azimuths are evenly spaced if so few suffice, else sinh-spaced around the direction in which the
   phase does not change. */
static inline void layered__rays(layered__solver *s)
{
    const double right = 1.5707963267948966, slant = s->k / s->least, t = slant / (1 + sqrt(1 + slant * slant));
    const double unit = s->edge[0] / fmax(slant, 1e-9), cut = 0.6 * s->edge[0], most = asinh(cut / unit);
    const double enough = t > 1e-9 ? fmin(ceil(log(1e-10) / (4 * log(t))), 1e6) : 1;
    const int even = enough <= s->azimuths;
    const int azimuths = even ? (int)enough : s->azimuths;
    const int rays = s->rays;
    layered__ray ray;
    int panel, i, a;
    if (rays != s->ray_count) layered__gauss(s->ray_count = rays, s->ray, s->ray_weight);
    if (azimuths != s->azimuth_count) layered__gauss(s->azimuth_count = azimuths, s->azimuth, s->azimuth_weight);
    memset(&ray, 0, sizeof ray);
    for (panel = 0; panel <= s->edges; ++panel)
        for (i = 0; i < rays; ++i) {
            const double low = panel < 2 ? cut : s->edge[panel - 2], high = panel ? s->edge[panel - 1] : cut;
            const double x = s->ray[i];
            double nu = high - (high - low) * x * x * x, dnu = (high - low) * 3 * x * x * s->ray_weight[i];
            if (panel == 0) {
                nu = most > 1e-5 ? unit * sinh(most * x) : cut * x;
                dnu = s->ray_weight[i] * (most > 1e-5 ? most * unit * cosh(most * x) : cut);
            }
            for (a = 0; a < azimuths; ++a) {
                double angle = right * (a + 0.5) / azimuths, part = 1.0 / azimuths;
                if (!even) {
                    const double scale = unit / nu, top = asinh(right / scale);
                    angle = scale * sinh(top * s->azimuth[a]);
                    part = s->azimuth_weight[a] * top * scale * cosh(top * s->azimuth[a]) / right;
                }
                layered__trace(s, nu, sin(angle), &ray);
                ray.weight = 0.5 * nu * dnu * part;
                layered__emit(s, &ray);
                layered__enter(s, &ray);
                layered__collect(s, &ray);
                layered__leave(s, &ray);
            }
        }
}

/* ---- the system at one frequency ------------------------------------------------------------------------------- */

/* solution, with the beam in it, of  (gram - exchange) (solution - beam) = exchange beam, by Cholesky's method on rows
   and columns of unit diagonal. A function that depends on the others to 1e-9 drops out. */
static inline void layered__factor_and_solve(layered__solver *s)
{
    const size_t room = (size_t)s->room;
    double *u = s->solution, *scale = s->in[0]; /* the rays are done with it */
    int i, j, c;
    for (i = 0; i < s->functions; ++i)
        for (j = 0; j < i; ++j) s->exchange[(size_t)j * room + (size_t)i] = s->exchange[(size_t)i * room + (size_t)j];
    for (i = 0; i < s->functions; ++i) {
        scale[i] = 1 / sqrt(s->gram[(size_t)i * room + (size_t)i]);
        for (u[i] = 0, j = 0; j < s->functions; ++j) u[i] += s->exchange[(size_t)i * room + (size_t)j] * s->f[j].beam;
        u[i] *= scale[i];
    }
    for (i = 0; i < s->functions; ++i) { /* the factor over gram: its diagonal inverted, and the forward solution */
        double *row = s->gram + (size_t)i * room, sum = 0;
        for (j = 0; j <= i; ++j) {
            const double *other = s->gram + (size_t)j * room;
            sum = (row[j] - s->exchange[(size_t)i * room + (size_t)j]) * scale[i] * scale[j];
            for (c = 0; c < j; ++c) sum -= row[c] * other[c];
            if (j < i) row[j] = sum * other[j];
        }
        row[i] = sum > 1e-9 ? 1 / sqrt(sum) : 0;
        for (c = 0; c < i; ++c) u[i] -= row[c] * u[c];
        u[i] *= row[i];
    }
    for (i = s->functions - 1; i >= 0; --i) {
        const double *row = s->gram + (size_t)i * room;
        u[i] *= row[i];
        for (c = 0; c < i; ++c) u[c] -= row[c] * u[i];
    }
    for (i = 0; i < s->functions; ++i) u[i] = u[i] * scale[i] + s->f[i].beam;
}

/* leave: the spectra at k of the scattered light that leaves at the top and at the bottom, by so many rays. */
static inline void layered__solve(layered__solver *s, double k, int rays, int azimuths, double leave[2])
{
    int side, i;
    s->k = k;
    s->rays = rays;
    s->azimuths = azimuths;
    layered__choose_functions(s);
    layered__sum_flights(s);
    layered__direct(s);
    for (side = 0; side < 2; ++side) {
        s->single[side] = 0;
        memset(s->escape[side], 0, (size_t)s->room * sizeof(double));
    }
    layered__rays(s);
    layered__factor_and_solve(s);
    for (side = 0; side < 2; ++side)
        for (leave[side] = 0, i = 0; i < s->functions; ++i) leave[side] += s->solution[i] * s->escape[side][i];
}

/* ---- totals and depth ------------------------------------------------------------------------------------------ */

/* Absorbed above z in a layer, by the solution at k = 0:  mu_a n^2 integral phi / n^2. */
static inline double layered__absorbed(const layered__solver *s, const layered__layer *y, double z)
{
    double sum = 0;
    int i;
    z = fmin(z, y->d);
    for (i = y->first; i < y->first + y->count; ++i) {
        const layered__function *f = &s->f[i];
        if (f->mirrored) sum += s->solution[i] * (exp(-f->b * (y->d - z)) - f->end) / f->b;
        else sum += s->solution[i] * (z < 1e200 ? -expm1(-f->b * z) : 1) / f->b;
    }
    return y->mu_a * y->n * y->n * sum;
}

/* a_l and a_z, which may be NULL, and all that is absorbed. left: what leaves. In a layer without end phi is known
   less well; its part is what is missing to 1. */
static inline double layered__depth(const layered__solver *s, const ms_mcml_tissue *t, const ms_mcml_layered_options *o,
                                    double left)
{
    double top = 0, sum = 0;
    int i, layer;
    for (i = 0; o->a_z && i < o->nz; ++i) o->a_z[i] = 0;
    for (layer = 0; layer < t->layer_count; ++layer) {
        const layered__layer *y = layer < s->layers ? &s->layer[layer] : NULL; /* NULL: light does not come so deep */
        const double by_phi = y ? layered__absorbed(s, y, y->d) : 0, end = t->layers[layer].thickness_cm;
        const double all = y && y->endless ? fmax(1 - left - sum, 0) : by_phi, scale = by_phi > 0 ? all / by_phi : 1;
        double before = 0;
        if (o->a_l) o->a_l[layer] = all;
        for (i = 0; o->a_z && i < o->nz && y; ++i) {
            const double from = i * o->dz_cm, to = from + o->dz_cm;
            double here;
            if ((to <= top && i + 1 < o->nz) || from >= top + end) continue;
            here = i + 1 == o->nz ? all : scale * layered__absorbed(s, y, to - top);
            o->a_z[i] += fmax(here - before, 0) / o->dz_cm;
            before = fmax(here, before); /* rounding, where next to nothing is left */
        }
        sum += all;
        top += end;
    }
    return sum;
}

/* Totals. Their errors: the change by rates twice as dense and by more rays. */
static inline void layered__totals(layered__solver *s, const ms_mcml_tissue *t, const ms_mcml_layered_options *o,
                                   ms_mcml_layered *out)
{
    double leave[2], coarse[2];
    layered__solve(s, 0, LAYERED__RAYS, 1, coarse);
    s->spacing = layered__spacing_at_0;
    layered__solve(s, 0, LAYERED__RAYS_AT_0, 1, leave);
    out->specular = layered__fresnel(s->n_above, s->layer[0].n, 0);
    out->rd_unscattered = s->specular - out->specular;
    out->tt_unscattered = s->unscattered;
    out->rd = fmax(leave[0], 0) + out->rd_unscattered; /* next to nothing may be below 0 by rounding */
    out->tt = fmax(leave[1], 0) + out->tt_unscattered;
    out->rd_error = 3e-7 + fabs(leave[0] - coarse[0]);
    out->tt_error = 3e-7 + fabs(leave[1] - coarse[1]);
    out->a = layered__depth(s, t, o, out->specular + out->rd + out->tt);
}

/* ---- rings ----------------------------------------------------------------------------------------------------- */

/* The frequencies of a solution and the spectra there: of all scattered light that leaves a side, and of it without the
   single scattering of the layer there. */
typedef struct layered__spectra {
    int count;
    double k[LAYERED_RATES], whole[2][LAYERED_RATES], value[2][LAYERED_RATES];
    double coarse[2][LAYERED_RATES]; /* value at every second frequency, by two thirds of the rays */
    double matrix[(2 * LAYERED_RATES) * (LAYERED_RATES + 1)], prior[LAYERED_RATES];
    ms_mcml_layered_side trial;
} layered__spectra;

/* k = low sinh(step i), from the scale of the slowest decay or of the thickness to where 5e-6 of either side is left,
   or to 300 of the densest layer. */
static inline ms_status layered__solve_spectra(layered__solver *s, const ms_progress *progress, layered__spectra *p,
                                               ms_mcml_layered *out, ms_error *error)
{
    const double fine = 0.2, wide = 0.35;
    double u = 0;
    double thickness = 0, least = 1e300, most = 0, low = 1e300, shift;
    int i, side, small, rays = LAYERED__RAYS, azimuths = LAYERED__AZIMUTHS;
    for (i = 0; i < s->layers; ++i) {
        const layered__layer *y = &s->layer[i];
        if (!y->endless) thickness += y->d;
        least = fmin(least, y->mu_t);
        most = fmax(most, y->mu_t);
        low = fmin(low, y->decay);
        if (y->mu_t * y->d < 1) rays = LAYERED__RAYS_THIN, azimuths = LAYERED__AZIMUTHS_THIN;
    }
    if (!s->layer[s->layers - 1].endless) low = fmax(low, 1 / (thickness + 4 / least));
    low = fmax(low, 1e-4 * most);
    for (p->count = 0; p->count < LAYERED_RATES; ++p->count) {
        const double k = low * sinh(u);
        double leave[2];
        u += k < 2 * most ? fine : wide;
        if (progress->report && progress->report(progress->user, fmin(0.1 + p->count * 0.02, 0.95)))
            return layered__fail(error, MS_CANCELLED, 0, "stopped by the progress callback");
        if (p->count % 2 == 0) {
            layered__solve(s, k, rays * 2 / 3, azimuths * 2 / 3, leave);
            for (side = 0; side < 2; ++side) p->coarse[side][p->count] = leave[side] - s->single[side];
        }
        layered__solve(s, k, rays, azimuths, leave);
        p->k[p->count] = k;
        for (small = 1, side = 0; side < 2; ++side) {
            p->whole[side][p->count] = leave[side];
            p->value[side][p->count] = leave[side] - s->single[side];
            small = small && fabs(leave[side] - s->single[side]) <= 5e-6 * p->whole[side][0];
        }
        if (k > 300 * most || (small && k > 5 * most)) {
            ++p->count;
            break;
        }
    }
    for (i = 0; i < LAYERED_RATES; ++i) { /* rates: none is below low, and none above the last frequency */
        shift = exp(0.2 * (i - 5));
        if (low * shift > p->k[p->count - 1]) break;
        out->rate_per_cm[i] = low * sqrt(1 + shift * shift);
    }
    out->side[0].rates = out->side[1].rates = i;
    out->radius_cm = 5e-4 / most;
    return MS_OK;
}

/* Least squares by Householder reflections: x of  |A x - b|^2 + |x|^2;  matrix: [columns + 1][rows + columns], A and b
   in the first rows of each column, which is destroyed. */
static inline void layered__ridge(double *matrix, int rows, int columns, double *x)
{
    const size_t height = (size_t)(rows + columns);
    double diagonal[LAYERED_RATES], *b = matrix + (size_t)columns * height;
    int c, j, i;
    for (c = 0; c <= columns; ++c)
        for (i = 0; i < columns; ++i) matrix[(size_t)c * height + (size_t)(rows + i)] = i == c;
    for (c = 0; c < columns; ++c) {
        double *v = matrix + (size_t)c * height, norm = 0, square;
        const int end = rows + c + 1;
        for (i = c; i < end; ++i) norm += v[i] * v[i];
        norm = v[c] > 0 ? -sqrt(norm) : sqrt(norm);
        square = norm * (norm - v[c]); /* half of |v|^2; a column is never 0 below its diagonal: the ridge */
        v[c] -= norm;
        diagonal[c] = norm;
        for (j = c + 1; j <= columns; ++j) {
            double *other = matrix + (size_t)j * height, dot = 0;
            for (i = c; i < end; ++i) dot += v[i] * other[i];
            dot /= square;
            for (i = c; i < end; ++i) other[i] -= dot * v[i];
        }
    }
    for (c = columns - 1; c >= 0; --c) {
        double sum = b[c];
        for (j = c + 1; j < columns; ++j) sum -= matrix[(size_t)j * height + (size_t)c] * x[j];
        x[c] = sum / diagonal[c];
    }
}

/* What the spectrum may be off by at a frequency: a part of all light there, more above the scale of the layers, where
   rays are few for the waves. */
static inline double layered__noise(const layered__spectra *p, int side, int i, double most)
{
    const double x = p->k[i] / (20 * most);
    return (1 + x * x) * (p->whole[side][i] + 1e-3 * p->whole[side][0]);
}

/* Energies of a side from every stride-th frequency. A row counts as the inverse of its noise, times `quality`.
   Energies are expected to be up to five times the total, and to fall with the rate above that of the densest layer. */
static inline void layered__fit(layered__spectra *p, const double *value, int side, int stride, double quality,
                                const ms_mcml_layered *s, double most, double *energy)
{
    const int columns = s->side[side].rates, rows = (p->count + stride - 1) / stride;
    const double total = p->whole[side][0];
    int i, j;
    for (j = 0; j < columns; ++j) p->prior[j] = 5 * total * fmin(1, 3 * most / s->rate_per_cm[j]);
    for (i = 0; i < rows; ++i) {
        const double noise = quality * layered__noise(p, side, i * stride, most);
        for (j = 0; j <= columns; ++j) {
            double *at = p->matrix + (size_t)j * (size_t)(rows + columns) + i;
            const double x = j < columns ? p->k[i * stride] / s->rate_per_cm[j] : 0;
            *at = (j < columns ? p->prior[j] / (1 + x * x) : value[i * stride]) / noise;
        }
    }
    layered__ridge(p->matrix, rows, columns, energy);
    for (j = 0; j < columns; ++j) energy[j] *= p->prior[j];
}

/* Single scattering of the layer at a surface: of each ray, mu_s / 2 T dmu times the beam, along the depth from which
   it comes, r cot(theta). */
static inline void layered__single_rays(const layered__solver *s, int side, ms_mcml_layered_side *out)
{
    const layered__layer *y = &s->layer[side ? s->layers - 1 : 0];
    const double outside = side ? s->n_below : s->n_above, far_end = y->endless ? 0 : exp(-y->mu_t * y->d);
    const double least = y->n > outside ? sqrt(1 - outside * outside / (y->n * y->n)) : 0;
    double node[LAYERED_SINGLES], weight[LAYERED_SINGLES];
    int i;
    out->depth_cm = y->d;
    out->singles = side && y->endless ? 0 : LAYERED_SINGLES;
    out->beam[0] = side ? y->up : y->down; /* here, of the beam that goes into the layer; and that comes out of it */
    out->beam[1] = side ? y->down * far_end : y->up * far_end;
    layered__gauss(LAYERED_SINGLES, node, weight);
    for (i = 0; i < out->singles; ++i) {
        const double x = node[i], mu = least + (1 - least) * x * x * (3 - 2 * x), sine = sqrt((1 - mu) * (1 + mu));
        const double transmitted = 1 - layered__fresnel(y->n, outside, y->n * sine);
        out->weight[i] = (1 - least) * 3 * x * (1 - x) * weight[i] * y->mu_s * transmitted; /* dense at both ends */
        out->cotangent[i] = mu / sine;
        out->rate_per_cm[0][i] = y->mu_t * (1 / mu + 1);
        out->rate_per_cm[1][i] = y->mu_t * (1 / mu - 1);
    }
}

/* Single scattering that leaves beyond r:  integral from r cot(theta) to d of exp(-rate z). */
static inline double layered__single_outside(const ms_mcml_layered_side *side, double r)
{
    const double d = side->depth_cm;
    double sum = 0;
    int i, b;
    for (i = 0; i < side->singles; ++i)
        for (b = 0; b < (d > 1e200 ? 1 : 2); ++b) {
            const double from = r * side->cotangent[i], rate = side->rate_per_cm[b][i], y = rate * (d - from);
            if (!(from < d) || rate * from > 700) continue;
            sum += side->weight[i] * side->beam[b] * exp(-rate * from) *
                (d > 1e200      ? 1 / rate
                     : y < 1e-6 ? d - from
                                : -expm1(-y) / rate);
        }
    return sum;
}

/* Scattered light that leaves beyond r. */
static inline double layered__outside(const ms_mcml_layered *s, const ms_mcml_layered_side *side, double r)
{
    double sum;
    int i;
    if (r > side->tail_cm) return side->tail * exp(-fmin(side->tail_rate * (r - side->tail_cm), 700));
    sum = layered__single_outside(side, r);
    for (i = 0; i < side->rates; ++i)
        if (s->rate_per_cm[i] * r < 700) sum += side->energy[i] * layered__x_bessel_k1(s->rate_per_cm[i] * r);
    return sum;
}

/* Energy between two radii of the table of errors. */
static inline double layered__cell(const ms_mcml_layered *s, const ms_mcml_layered_side *side, int i)
{
    const double radius = s->radius_cm * exp(0.25 * i);
    return layered__outside(s, side, i ? radius * exp(-0.25) : 0) - layered__outside(s, side, radius);
}

/* Rings of a side: the fit, scaled to the total, and its errors, from a fit to half of the frequencies. */
static inline void layered__rings(const layered__solver *s, layered__spectra *p, int side, double most,
                                  ms_mcml_layered *out)
{
    ms_mcml_layered_side *y = &out->side[side], *other = &p->trial;
    const double scattered = side ? out->tt - out->tt_unscattered : out->rd - out->rd_unscattered;
    double sum = 0, off[LAYERED_RADII], near, quality = 1e-7;
    int i, j;
    if (side && s->layer[s->layers - 1].endless) y->rates = 0;
    if (side && s->layer[s->layers - 1].endless) return;
    layered__single_rays(s, side, y);
    for (i = 0; i < p->count; i += 2)
        quality = fmax(quality, 0.01 * fabs(p->coarse[side][i] - p->value[side][i]) / layered__noise(p, side, i, most));
    layered__fit(p, p->value[side], side, 1, quality, out, most, y->energy);
    y->tail_cm = 1e300;
    *other = *y;
    layered__fit(p, p->coarse[side], side, 2, quality, out, most, other->energy);
    for (i = 0; i < y->rates; ++i) sum += y->energy[i];
    sum = (scattered - layered__single_outside(y, 0)) / sum;
    if (layered__between(sum, 0.99, 1.01))
        for (i = 0; i < y->rates; ++i) y->energy[i] *= sum, other->energy[i] *= sum;
    for (i = 0; i < LAYERED_RADII; ++i) off[i] = fabs(layered__cell(out, other, i) - layered__cell(out, y, i));
    for (i = 0; i < LAYERED_RADII; ++i) { /* differences change sign: the largest of the cells nearby */
        for (near = 0, j = i > 2 ? i - 2 : 0; j <= i + 2 && j < LAYERED_RADII; ++j) near = fmax(near, off[j]);
        y->error[i] = 5e-5 * scattered + 4e-3 * fabs(layered__cell(out, y, i)) + 3 * near;
    }
}

/* Where 2e-5 of a side's light is left, or less than 3e-3 and it rises, rings are not known: the rest falls
   exponentially, as fast as the light before it. */
static inline void layered__end(ms_mcml_layered *s, int side, double scattered)
{
    ms_mcml_layered_side *y = &s->side[side];
    double before = scattered, at = 0, radius;
    int i;
    for (i = 0; i < LAYERED_RADII && y->singles; ++i) {
        const double here = layered__outside(s, y, radius = s->radius_cm * exp(0.25 * i));
        if (here > 2e-5 * scattered && (here < before || here > 3e-3 * scattered)) {
            before = here;
            at = radius;
            continue;
        }
        radius = at * exp(-0.25);
        y->tail = before;
        y->tail_rate = at > 0 ? log(layered__outside(s, y, radius) / before) / (at - radius) : 1 / s->radius_cm;
        y->tail_rate = fmax(y->tail_rate, s->rate_per_cm[0]);
        y->tail_cm = at;
        for (; i < LAYERED_RADII; ++i) y->error[i] += 2 * before;
        return;
    }
}

/* The energies beyond the radii of the table, each at most the one before. Where the fit rises it is wrong, by that
   much or more, up and down: twice the rise joins the errors of the cells from there on and of the four before. */
static inline void layered__tabulate(ms_mcml_layered *s, int side, double scattered)
{
    ms_mcml_layered_side *y = &s->side[side];
    double least = fmax(scattered, 0), rise[LAYERED_RADII + 4] = {0}, largest = 0;
    int i;
    for (i = 0; i < LAYERED_RADII; ++i) {
        const double here = fmax(layered__outside(s, y, s->radius_cm * exp(0.25 * i)), 0);
        rise[i] = fmax(here - least, 0);
        least = fmin(least, here);
        y->falling[i] = least;
    }
    for (i = 0; i < 4; ++i) largest = fmax(largest, rise[i]);
    for (i = 0; i < LAYERED_RADII; ++i) {
        largest = fmax(largest, rise[i + 4]);
        y->error[i] += 2 * largest;
    }
}

/* Scattered light that leaves beyond r, between what leaves beyond the table's radii around it. */
static inline double layered__falling(const ms_mcml_layered *s, int side, double r)
{
    const double place = r > 0 ? 4 * log(r / s->radius_cm) : -1;
    const double all = side ? s->tt - s->tt_unscattered : s->rd - s->rd_unscattered;
    const int i = place < 0 ? -1 : place < LAYERED_RADII - 1 ? (int)place : LAYERED_RADII - 1;
    const double high = i < 0 ? all : s->side[side].falling[i];
    const double low = i + 1 < LAYERED_RADII ? s->side[side].falling[i + 1] : 0;
    if (i < 0) return high - (high - low) * r / s->radius_cm; /* single scattering: a density of 1 / r */
    return fmax(fmin(layered__outside(s, &s->side[side], r), high), low);
}

/* ---- calls ----------------------------------------------------------------------------------------------------- */

/* Solves the layers. options may be NULL. progress is called at every frequency, with 0 first and 1 last.
   MS_UNSUPPORTED, MS_INVALID_ARGUMENT (position: the layer, from 1): layers that the head comment does not name.
   MS_OUT_OF_MEMORY, MS_CANCELLED. *out, a_z and a_l are untouched then. */
static inline ms_status ms_mcml_layered_solve(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *options,
                                              ms_mcml_layered *out, ms_error *error)
{
    ms_mcml_layered_options o;
    ms_mcml_layered r;
    layered__solver *s = NULL;
    layered__spectra *p = NULL;
    double most = 0;
    ms_status status;
    int i;
    memset(&o, 0, sizeof o);
    memset(&r, 0, sizeof r);
    if (options) o = *options;
    if (tissue == NULL || out == NULL) return layered__fail(error, MS_INVALID_ARGUMENT, 0, "tissue or out is NULL");
    if (o.a_z && (o.nz < 1 || !layered__between(o.dz_cm, 1e-30, 1e30)))
        return layered__fail(error, MS_INVALID_ARGUMENT, 0, "nz is %d and dz_cm %g, expected at least 1 and above 0",
                             o.nz, o.dz_cm);
    if ((status = layered__check(tissue, error)) != MS_OK) return status;
    if ((status = layered__create(&s, tissue, &o.allocator, error)) != MS_OK) return status;
    r.totals_only = o.totals_only;
    for (i = 0; i < s->layers; ++i) most = fmax(most, s->layer[i].mu_t);
    if (!o.totals_only) {
        p = (layered__spectra *)layered__alloc(&o.allocator, sizeof *p);
        if (p == NULL) status = layered__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the spectra");
        else status = layered__solve_spectra(s, &o.progress, p, &r, error);
    } else if (o.progress.report && o.progress.report(o.progress.user, 0)) {
        status = layered__fail(error, MS_CANCELLED, 0, "stopped by the progress callback");
    }
    if (status == MS_OK) {
        layered__totals(s, tissue, &o, &r);
        for (i = 0; i < 2 && p; ++i) {
            layered__rings(s, p, i, most, &r);
            layered__end(&r, i, i ? r.tt - r.tt_unscattered : r.rd - r.rd_unscattered);
            layered__tabulate(&r, i, i ? r.tt - r.tt_unscattered : r.rd - r.rd_unscattered);
        }
        *out = r;
        if (o.progress.report) o.progress.report(o.progress.user, 1);
    }
    layered__release(&o.allocator, p, sizeof *p);
    layered__destroy(s);
    return status;
}

/* Energy that leaves at the top (side 0) or the bottom (side 1) farther than r_cm >= 0 from the beam; unscattered light
   leaves at 0. NaN outside these ranges, and of a solution with totals_only unless r_cm is 0. */
static inline double ms_mcml_layered_outside(const ms_mcml_layered *s, int side, double r_cm)
{
    if (s == NULL || side < 0 || side > 1 || !layered__between(r_cm, 0, 1e300)) return (double)NAN;
    if (!(r_cm > 0)) return side ? s->tt : s->rd;
    return s->totals_only ? (double)NAN : fmax(layered__falling(s, side, r_cm), 0);
}

/* Where r is among the cells of the table of errors: 0 to 1 within the first radius. */
static inline double layered__position(const ms_mcml_layered *s, double r)
{
    const double x = r / s->radius_cm;
    return x < 1 ? x : fmin(1 + 4 * log(x), LAYERED_RADII);
}

/* Mean over r0_cm <= r < r1_cm in 1/cm^2, not negative. *ring_error (may be NULL) gets a bound of its error. NaN as
   above. */
static inline double ms_mcml_layered_ring(const ms_mcml_layered *s, int side, double r0_cm, double r1_cm,
                                          double *ring_error)
{
    double r0 = r0_cm, r1 = r1_cm, total, energy, per_area, from, to, bound = 0;
    int i;
    if (s == NULL || side < 0 || side > 1 || s->totals_only || !layered__between(r0, 0, 1e150) ||
        !layered__between(r1, 0, 1e150) || !(r0 < r1)) {
        if (ring_error) *ring_error = (double)NAN;
        return (double)NAN;
    }
    if (r1 - r0 < 1e-4 * r1) { /* the mean of a narrower ring is the same to 1e-8, but would cancel */
        r0 = (1 - 0.5e-4) * 0.5 * (r0_cm + r1_cm);
        r1 = (1 + 0.5e-4) * 0.5 * (r0_cm + r1_cm);
    }
    per_area = 1 / (3.14159265358979324 * (r1 - r0) * (r1 + r0));
    total = side ? s->tt : s->rd;
    energy = (r0 > 0 ? layered__falling(s, side, r0) : total) - layered__falling(s, side, r1);
    energy = fmax(energy, 0);
    from = layered__position(s, r0);
    to = layered__position(s, r1);
    for (i = (int)from; i < LAYERED_RADII && i < to; ++i)
        bound += s->side[side].error[i] * (fmin(to, i + 1) - fmax(from, i));
    if (total > 0) bound += energy / total * (side ? s->tt_error : s->rd_error);
    if (ring_error) *ring_error = bound * per_area;
    return energy * per_area;
}

/* Radius beyond which 1e-5 of the reflectance is left, in mm. */
static inline double layered__far_mm(const ms_mcml_layered *s)
{
    double low = 0.1 * s->radius_cm, high = 1e12 * low;
    int i;
    for (i = 0; i < 40; ++i) {
        const double middle = sqrt(low * high);
        if (layered__outside(s, &s->side[0], middle) > 1e-5 * s->rd) low = middle;
        else high = middle;
    }
    return 10 * high;
}

/* The reflectance of tissues[0 .. channels - 1] over common rings, with its errors; as ms_mcml_profile_make, and its
   rings where the options give none. Of the options, edge_mm, rings, ring_mm and allocator are read. MS_UNSUPPORTED and
   others as from ms_mcml_layered_solve (position: the channel, from 1): *profile is zeroed. */
static inline ms_status ms_mcml_profile_layers(ms_mcml_profile *profile, const ms_mcml_tissue *tissues, int channels,
                                               const ms_mcml_profile_options *options, ms_error *error)
{
    ms_mcml_profile_options o;
    ms_mcml_profile p;
    ms_mcml_layered_options how;
    ms_mcml_layered *solution;
    ms_status status = MS_OK;
    double shortest = 1e300, longest = 0, r, *at;
    size_t size, n, count;
    int c, i;
    if (profile) memset(profile, 0, sizeof *profile);
    if (profile == NULL || tissues == NULL || channels < 1 || channels > 65536)
        return layered__fail(error, MS_INVALID_ARGUMENT, 0, "%d channels, expected 1 to 65536; NULL is none", channels);
    memset(&o, 0, sizeof o);
    memset(&p, 0, sizeof p);
    memset(&how, 0, sizeof how);
    if (options) o = *options;
    if (o.rings < 0 || o.rings > 1 << 24 ||
        (o.rings > 0 && o.edge_mm == NULL && !layered__between(o.ring_mm, 1e-100, 1e100)))
        return layered__fail(error, MS_INVALID_ARGUMENT, 0, "rings is %d and ring_mm %g", o.rings, o.ring_mm);
    for (i = 0; i < o.rings && o.edge_mm; ++i)
        if (!layered__between(o.edge_mm[i + 1], 1e-100, 1e100) ||
            !(o.edge_mm[i] >= 0 && o.edge_mm[i + 1] > o.edge_mm[i]))
            return layered__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                                 "ring edge %d is %g, expected increasing numbers, 0 or 1e-100 to 1e100", i + 1,
                                 o.edge_mm[i + 1]);
    how.allocator = o.allocator;
    size = (size_t)channels * sizeof *solution;
    solution = (ms_mcml_layered *)layered__alloc(&o.allocator, size);
    if (solution == NULL) return layered__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d channels", channels);
    for (c = 0; c < channels && status == MS_OK; ++c) {
        status = ms_mcml_layered_solve(&tissues[c], &how, &solution[c], error);
        if (status) {
            if (error) error->position = (size_t)(c + 1);
            break;
        }
        shortest = fmin(shortest, 2000 * 10 * solution[c].radius_cm); /* the densest mean free path, in mm */
        longest = fmax(longest, layered__far_mm(&solution[c]));
    }
    for (i = 0, r = 0; o.rings == 0 && (r < longest || i < 20); ++i) r = i < 20 ? (i + 1) * 0.05 * shortest : r * 1.04;
    n = (size_t)(o.rings ? o.rings : i);
    count = (size_t)channels;
    p.memory_size = (n + 1 + count * (3 * n + 4)) * sizeof(double);
    if (status == MS_OK && (p.memory = layered__alloc(&o.allocator, p.memory_size)) == NULL)
        status = layered__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d channels", channels);
    if (status) {
        layered__release(&o.allocator, solution, size);
        return status;
    }
    p.allocator = o.allocator;
    p.channels = channels;
    p.rings = (int)n;
    at = (double *)p.memory;
    p.edge_mm = at, at += n + 1;
    p.within = at, at += count * (n + 1);
    p.rd_per_mm2 = at, at += count * n;
    p.rd_error_per_mm2 = at, at += count * n;
    p.entering = at, at += count;
    p.total = at, at += count;
    p.total_error = at;
    for (i = 0, p.edge_mm[0] = o.edge_mm ? o.edge_mm[0] : 0; i < p.rings; ++i)
        p.edge_mm[i + 1] = o.rings == 0 ? (i < 20 ? (i + 1) * 0.05 * shortest : p.edge_mm[i] * 1.04)
            : o.edge_mm                 ? o.edge_mm[i + 1]
                                        : (i + 1) * o.ring_mm;
    for (c = 0; c < channels; ++c) {
        const ms_mcml_layered *s = &solution[c];
        double *within = p.within + (size_t)c * (n + 1);
        p.entering[c] = 1 - s->specular;
        p.total[c] = s->rd;
        p.total_error[c] = s->rd_error;
        within[0] = s->rd - ms_mcml_layered_outside(s, 0, 0.1 * p.edge_mm[0]);
        for (i = 0; i < p.rings; ++i) {
            const double r0 = p.edge_mm[i], r1 = p.edge_mm[i + 1], area = 3.14159265358979324 * (r1 - r0) * (r1 + r0);
            const size_t at_ring = (size_t)c * n + (size_t)i;
            double bound;
            p.rd_per_mm2[at_ring] = 0.01 * ms_mcml_layered_ring(s, 0, 0.1 * r0, 0.1 * r1, &bound);
            p.rd_error_per_mm2[at_ring] = 0.01 * bound;
            within[i + 1] = within[i] + p.rd_per_mm2[at_ring] * area;
        }
    }
    layered__release(&o.allocator, solution, size);
    *profile = p;
    return MS_OK;
}
#endif /* LAYERED_H */
