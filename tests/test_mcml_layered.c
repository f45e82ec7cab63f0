/* The layered solver of examples/tools: totals against adding-doubling (written here, nothing shared with it),
   published numbers and identities; rings of random media against photons (half-spaces: test_mcml_profile.c). */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "layered.h"
#include "mci.h"
#include "skin.h"

#include "test.h"

#define NODES 120 /* at most: rays of a layer, the beam last */

/* Of ring i of those dr wide. */
static double ring_area(int i, double dr) { return 6.283185307179586 * (i + 0.5) * dr * dr; }

/* --- adding-doubling: van de Hulst 1980, Prahl, van Gemert, Welch 1993 --- */

typedef struct slab {
    int n;
    double *r, *t, *r_up, *t_up; /* [n][n] radiance out over radiance in, from above and from below */
} slab;

static int gauss(int n, double *x, double *w) /* on (0, 1) */
{
    int i, k, turn;
    for (i = 0; i < n; ++i) {
        double t = cos(3.14159265358979 * (i + 0.75) / (n + 0.5)), slope = 1;
        for (turn = 0; turn < 50; ++turn) {
            double p = 1, q = 0, next;
            for (k = 1; k <= n; ++k) {
                next = ((2 * k - 1) * t * p - (k - 1) * q) / k;
                q = p;
                p = next;
            }
            slope = n * (t * p - q) / (t * t - 1);
            t -= p / slope;
        }
        x[i] = 0.5 * (1 - t);
        w[i] = 1 / ((1 - t * t) * slope * slope);
    }
    return n;
}

/* x = a^-1 b, both destroyed; partial pivots. */
static void solve_linear(double *a, double *b, int n)
{
    int i, j, k;
    for (k = 0; k < n; ++k) {
        int best = k;
        for (i = k + 1; i < n; ++i)
            if (fabs(a[i * n + k]) > fabs(a[best * n + k])) best = i;
        for (j = 0; j < n && best != k; ++j) {
            double x = a[k * n + j], y = b[k * n + j];
            a[k * n + j] = a[best * n + j];
            a[best * n + j] = x;
            b[k * n + j] = b[best * n + j];
            b[best * n + j] = y;
        }
        for (i = 0; i < n; ++i) {
            const double q = a[i * n + k] / a[k * n + k];
            if (i == k || (!(q < 0) && !(q > 0))) continue;
            for (j = k; j < n; ++j) a[i * n + j] -= q * a[k * n + j];
            for (j = 0; j < n; ++j) b[i * n + j] -= q * b[k * n + j];
        }
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) b[i * n + j] /= a[i * n + i];
}

static void product(const double *a, const double *b, int n, double *out)
{
    int i, j, k;
    memset(out, 0, sizeof(double) * (size_t)(n * n));
    for (i = 0; i < n; ++i)
        for (k = 0; k < n; ++k)
            for (j = 0; j < n; ++j) out[i * n + j] += a[i * n + k] * b[k * n + j];
}

static slab slab_make(int n)
{
    slab s;
    s.n = n;
    s.r = (double *)calloc((size_t)(4 * n * n), sizeof(double));
    s.t = s.r + n * n;
    s.r_up = s.t + n * n;
    s.t_up = s.r_up + n * n;
    return s;
}

/* a above b:  R = Ra + Tau (1 - Rb Rau)^-1 Rb Ta  and so on; the result replaces a */
static void add(slab *a, const slab *b)
{
    const int n = a->n;
    slab out = slab_make(n);
    double *m = (double *)malloc(sizeof(double) * (size_t)(3 * n * n)), *x = m + n * n, *y = x + n * n;
    int i;
    product(a->r_up, b->r, n, m); /* down = (1 - Rau Rb)^-1 Ta */
    for (i = 0; i < n * n; ++i) m[i] = (i % (n + 1) == 0) - m[i];
    memcpy(x, a->t, sizeof(double) * (size_t)(n * n));
    solve_linear(m, x, n);
    product(b->t, x, n, out.t);
    product(b->r, x, n, y);
    product(a->t_up, y, n, out.r);
    for (i = 0; i < n * n; ++i) out.r[i] += a->r[i];
    product(b->r, a->r_up, n, m); /* up = (1 - Rb Rau)^-1 Tbu */
    for (i = 0; i < n * n; ++i) m[i] = (i % (n + 1) == 0) - m[i];
    memcpy(x, b->t_up, sizeof(double) * (size_t)(n * n));
    solve_linear(m, x, n);
    product(a->t_up, x, n, out.t_up);
    product(a->r_up, x, n, y);
    product(b->t, y, n, out.r_up);
    for (i = 0; i < n * n; ++i) out.r_up[i] += b->r_up[i];
    memcpy(a->r, out.r, sizeof(double) * (size_t)(4 * n * n));
    free(out.r);
    free(m);
}

/* Specular, diffuse reflectance and transmittance as MCML counts them. per: nodes of a panel of nu. */
static void reference(const ms_mcml_tissue *tissue, int per, int order, double *rd, double *tt)
{
    double nu[NODES], wn[NODES], x[64], w[64], breaks[20], mu[NODES], weight[NODES], power, specular, n_over;
    int count = 0, i, j, l, layer, panels = 0, n, side;
    slab all = slab_make(NODES);
    breaks[panels++] = 0;
    for (;;) { /* the indices in rising order, each once */
        double next = 1e300, high = 0;
        for (i = -1; i <= tissue->layer_count; ++i) {
            double m = i < 0 ? tissue->n_above : i < tissue->layer_count ? tissue->layers[i].n : tissue->n_below;
            if (m > breaks[panels - 1] * (1 + 1e-9) && m < next) next = m;
            if (i >= 0 && i < tissue->layer_count && m > high) high = m;
        }
        if (next > high) break;
        breaks[panels++] = next;
    }
    if (panels == 1) breaks[panels++] = tissue->layers[0].n;
    gauss(per, x, w);
    for (i = 1; i < panels; ++i)
        for (j = 0; j < per; ++j) { /* clustered at the upper end, as x (2 - x) */
            nu[count] = breaks[i - 1] + (breaks[i] - breaks[i - 1]) * x[j] * (2 - x[j]);
            wn[count++] = (breaks[i] - breaks[i - 1]) * 2 * (1 - x[j]) * w[j];
        }
    nu[count] = 0; /* the beam */
    wn[count++] = 0;
    n = all.n = count;
    all.t = all.r + n * n;
    all.r_up = all.t + n * n;
    all.t_up = all.r_up + n * n;
    for (i = 0; i < n; ++i) all.t[i * n + i] = all.t_up[i * n + i] = 1;
    for (layer = -1; layer < tissue->layer_count; ++layer) {
        const double here = layer < 0 ? tissue->n_above : tissue->layers[layer].n;
        const double below = layer + 1 < tissue->layer_count ? tissue->layers[layer + 1].n : tissue->n_below;
        slab one = slab_make(n);
        for (i = 0; i < n && layer >= 0; ++i) {
            const double s = nu[i] / here;
            mu[i] = s < 1 ? sqrt(1 - s * s) : 0;
            weight[i] = i == n - 1 ? 1 : s < 1 ? wn[i] * nu[i] / (here * here * mu[i]) : 0;
        }
        if (layer >= 0 && tissue->layers[layer].mu_a_per_cm + tissue->layers[layer].mu_s_per_cm > 0) {
            const ms_mcml_layer *y = &tissue->layers[layer];
            const double f = y->g > 0 ? pow(y->g, order + 1) : 0, mu_s = y->mu_s_per_cm * (1 - f),
                         mu_t = y->mu_a_per_cm + mu_s;
            double *p = (double *)calloc((size_t)(6 * n * n), sizeof(double)), *q = p + n * n, *m1 = q + n * n,
                   *m2 = m1 + n * n;
            double *b1 = m2 + n * n, *b2 = b1 + n * n, thickness = y->thickness_cm < 1e7 ? y->thickness_cm : 0, step;
            int doublings;
            if (!(thickness > 0))
                thickness = 60 / sqrt(3 * y->mu_a_per_cm * (y->mu_a_per_cm + y->mu_s_per_cm * (1 - y->g))) + 60 / mu_t;
            doublings = (int)ceil(log(thickness * mu_t / 3e-6) / log(2.0));
            if (doublings < 0) doublings = 0;
            step = thickness / pow(2.0, doublings);
            for (i = 0; i < n; ++i)
                for (j = 0; j < n; ++j) {
                    double pi1 = mu[i], pi0 = 1, pj1 = mu[j], pj0 = 1, even = 0, odd = 0;
                    if (!(mu[i] > 0) || !(mu[j] > 0)) {
                        p[i * n + j] = i == j ? 1e6 / step : 0; /* no such ray: opaque */
                        continue;
                    }
                    for (l = 0; l <= order; ++l) {
                        const double g = ((l ? pow(y->g, l) : 1) - f) / (1 - f),
                                     next_i = ((2 * l + 3) * mu[i] * pi1 - (l + 1) * pi0) / (l + 2);
                        const double next_j = ((2 * l + 3) * mu[j] * pj1 - (l + 1) * pj0) / (l + 2);
                        if (l & 1) odd += (2 * l + 1) * g * pi0 * pj0;
                        else even += (2 * l + 1) * g * pi0 * pj0;
                        pi0 = pi1;
                        pi1 = next_i;
                        pj0 = pj1;
                        pj1 = next_j;
                    }
                    if (i == n - 1) even = odd = 0; /* nothing is scattered into the beam itself */
                    p[i * n + j] = ((i == j ? mu_t : 0) - 0.5 * mu_s * (even + odd) * weight[j]) / mu[i];
                    q[i * n + j] = 0.5 * mu_s * (even - odd) * weight[j] / mu[i];
                }
            for (i = 0; i < n * n; ++i) { /* diamond scheme of a thin layer */
                const double unit = i % (n + 1) == 0, a = 0.5 * step * p[i], b = 0.5 * step * q[i];
                m1[i] = unit + a - b;
                b1[i] = unit - a + b;
                m2[i] = unit + a + b;
                b2[i] = unit - a - b;
            }
            solve_linear(m1, b1, n);
            solve_linear(m2, b2, n);
            for (i = 0; i < n * n; ++i) {
                one.t[i] = one.t_up[i] = 0.5 * (b1[i] + b2[i]);
                one.r[i] = one.r_up[i] = 0.5 * (b1[i] - b2[i]);
            }
            for (i = 0; i < doublings; ++i) {
                slab twin = slab_make(n);
                memcpy(twin.r, one.r, sizeof(double) * (size_t)(4 * n * n));
                add(&one, &twin);
                free(twin.r);
            }
            free(p);
            add(&all, &one);
            memset(one.r, 0, sizeof(double) * (size_t)(4 * n * n));
        }
        for (i = 0; i < n; ++i) {                     /* Fresnel; radiance scales with n squared, the beam does not */
            double power_r = 1 - 1e-10, a, b, rs, rp; /* not 1: rays that are caught in glass would never end */
            if (nu[i] < here && nu[i] < below) {
                a = sqrt(1 - nu[i] * nu[i] / (here * here));
                b = sqrt(1 - nu[i] * nu[i] / (below * below));
                rs = (here * a - below * b) / (here * a + below * b);
                rp = (here * b - below * a) / (here * b + below * a);
                power_r = 0.5 * (rs * rs + rp * rp);
            }
            power = i == n - 1 ? 1 : below * below / (here * here);
            one.r[i * n + i] = one.r_up[i * n + i] = power_r;
            one.t[i * n + i] = (1 - power_r) * power;
            one.t_up[i * n + i] = (1 - power_r) / power;
        }
        add(&all, &one);
        free(one.r);
    }
    for (side = 0; side < 2; ++side) {
        const double outside = side ? tissue->n_below : tissue->n_above, *m = side ? all.t : all.r;
        double sum = m[n * n - 1];
        for (i = 0; i < n - 1; ++i)
            if (nu[i] < outside) sum += m[i * n + n - 1] * wn[i] * nu[i] / (outside * outside);
        if (side) *tt = sum;
        else *rd = sum;
    }
    i = 0;
    while (i < tissue->layer_count && !(tissue->layers[i].mu_a_per_cm + tissue->layers[i].mu_s_per_cm > 0)) ++i;
    for (side = 0, specular = 0, n_over = tissue->n_above; side <= i; ++side) { /* of clear layers on top as well */
        const double under = side < tissue->layer_count ? tissue->layers[side].n : tissue->n_below;
        const double one_more = (n_over - under) * (n_over - under) / ((n_over + under) * (n_over + under));
        specular = (specular + one_more - 2 * specular * one_more) / (1 - specular * one_more);
        n_over = under;
    }
    *rd -= specular;
    free(all.r);
}

static const struct {
    const char *name;
    double n_above, n_below;
    int layers;
    ms_mcml_layer layer[3];
} media[] = {
    {"half-space n 1.5", 1, 1, 1, {{1.5, 10, 90, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"slab", 1, 1, 1, {{1, 10, 90, 0, 0.02}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"sample.mci, isotropic", 1, 1, 3, {{1.37, 1, 10, 0, 0.1}, {1.37, 1, 10, 0, 0.1}, {1.37, 2, 3, 0, 0.2}}},
    {"skin", 1, 1.44, 3, {{1.4, 3, 40, 0, 0.01}, {1.4, 0.5, 30, 0, 0.15}, {1.44, 0.2, 20, 0, 1e8}}},
    {"albedo 0.99999", 1, 1, 1, {{1.3, 0.001, 99.999, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"albedo 0.01", 1, 1, 1, {{1.4, 99, 1, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"mu_s 0", 1, 1.3, 2, {{1.4, 20, 0, 0, 0.02}, {1.37, 1, 20, 0, 0.5}, {0, 0, 0, 0, 0}}},
    {"index 2.5", 1, 1, 1, {{2.5, 0.05, 20, 0, 0.2}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"mu_a 0", 1, 1.5, 1, {{1.4, 0, 50, 0, 0.2}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"thin on a deep layer", 1, 1, 2, {{1.5, 50, 50, 0, 0.002}, {1.37, 1, 20, 0, 1e8}, {0, 0, 0, 0, 0}}},
    {"weak in between", 1, 1.5, 3, {{1.5, 1, 50, 0, 0.05}, {1.33, 0.05, 2, 0, 0.2}, {1.6, 0.5, 60, 0, 0.1}}},
};

static ms_mcml_tissue tissue_of(unsigned i)
{
    ms_mcml_tissue t;
    t.n_above = media[i].n_above;
    t.n_below = media[i].n_below;
    t.layer_count = media[i].layers;
    t.layers = media[i].layer;
    return t;
}

static void totals(void)
{
    double worst = 0;
    unsigned i;
    for (i = 0; i < sizeof media / sizeof *media; ++i) {
        const ms_mcml_tissue t = tissue_of(i);
        ms_mcml_layered_options o;
        ms_mcml_layered s;
        double rd = 0, tt = 0, a_l[3], a_z[50], sum = 0, sum_z = 0;
        int l;
        memset(&o, 0, sizeof o);
        o.totals_only = 1;
        o.a_l = a_l;
        o.a_z = a_z;
        o.nz = 50;
        o.dz_cm = 0.01;
        ms_error error;
        if (ms_mcml_layered_solve(&t, &o, &s, &error)) TEST_FAIL("%s: %s", media[i].name, error.message);
        reference(&t, 24, 0, &rd, &tt);
        CHECK_NEAR(s.rd, rd, 1e-5); /* the promise; adding-doubling itself is good to about 1e-6 */
        CHECK_NEAR(s.tt, tt, 1e-5);
        CHECK(s.rd_error < 5e-5 && s.tt_error < 5e-5 && fabs(s.rd - rd) < s.rd_error + 3e-6 &&
              fabs(s.tt - tt) < s.tt_error + 3e-6);
        CHECK_NEAR(s.specular + s.rd + s.tt + s.a, 1, 2e-5); /* nothing is lost; two interpolations of the same field */
        for (l = 0; l < t.layer_count; ++l) sum += a_l[l];
        for (l = 0; l < 50; ++l) {
            CHECK(a_z[l] >= 0);
            sum_z += 0.01 * a_z[l];
        }
        CHECK_NEAR(sum, s.a, 1e-12);
        CHECK_NEAR(sum_z, s.a, 1e-6);
        if (fabs(s.rd - rd) > worst) worst = fabs(s.rd - rd);
        if (fabs(s.tt - tt) > worst) worst = fabs(s.tt - tt);
    }
    TEST_NOTE("%d media, worst %.1e", (int)i, worst);
}

/* Giovanelli 1955: a half-space of index 1.5 and albedo 0.9, with what its surface reflects. */
static void published(void)
{
    const ms_mcml_tissue t = tissue_of(0);
    ms_mcml_layered s;
    ms_error error;
    if (ms_mcml_layered_solve(&t, NULL, &s, &error)) TEST_FAIL("%s", error.message);
    CHECK_NEAR(s.specular, 0.04, 1e-15);
    CHECK_NEAR(s.rd + s.specular, 0.2600, 1e-4); /* the last digit printed */
}

/* --- random media against photons --- */

enum { EDGES = 14 };

typedef struct random_tissue {
    ms_mcml_tissue tissue;
    ms_mcml_layer layer[LAYERED_LAYERS];
} random_tissue;

static double between(uint64_t *state, double low, double high) { return low + (high - low) * test_uniform(state); }

static double log_between(uint64_t *state, double low, double high) { return exp(between(state, log(low), log(high))); }

/* Layers over all of the domain that layered.h names: 1 to 4; extinctions within a factor of 50; 0.2 mean free paths
   and more; indices 1 to 2.5, or all the same; albedos 1e-3 to 1. */
static void draw(random_tissue *m, uint64_t *s)
{
    const double kind = test_uniform(s), first = log_between(s, 1, 300), highest = between(s, 0, 1) < 0.7 ? 1.6 : 2.5;
    const int matched = test_uniform(s) < 0.25;
    int i;
    m->tissue.layers = m->layer;
    m->tissue.layer_count = kind < 0.3 ? 1 : 1 + (int)between(s, 0, LAYERED_LAYERS);
    m->tissue.n_above = matched || test_uniform(s) < 0.7 ? 1 : between(s, 1, 1.6);
    m->tissue.n_below = matched || test_uniform(s) < 0.5 ? 1 : between(s, 1, 1.6);
    for (i = 0; i < m->tissue.layer_count; ++i) {
        ms_mcml_layer *y = &m->layer[i];
        const double mu_t = first * (test_uniform(s) < 0.5 ? log_between(s, 1, 4) : log_between(s, 1, 49.9));
        const double albedo = test_uniform(s),
                     absorbed = albedo < 0.2 ? log_between(s, 1e-8, 1e-3)
            : albedo < 0.3                   ? 1 - log_between(s, 1e-3, 0.3)
            : albedo < 0.35                  ? 0
                                             : log_between(s, 1e-3, 0.7);
        y->n = matched ? 1 : between(s, 1, highest);
        y->g = 0;
        y->mu_a_per_cm = mu_t * absorbed;
        y->mu_s_per_cm = mu_t * (1 - absorbed);
        y->thickness_cm = (test_uniform(s) < 0.3 ? log_between(s, 0.201, 1) : log_between(s, 0.3, 30)) / mu_t;
        if (i + 1 == m->tissue.layer_count && test_uniform(s) < 0.4) y->thickness_cm = 1e8;
    }
}

/* Rings that part the scattered light of each side at quantiles, by a few photons. */
static void choose_rings(const random_tissue *m, ms_mcml_grid *grid, int at[2][EDGES])
{
    static const double quantile[EDGES - 1] = {0.997, 0.99, 0.97, 0.93, 0.85, 0.7,  0.5,
                                               0.3,   0.15, 0.07, 0.03, 0.01, 0.003};
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_result r;
    int side, i, e;
    grid->dr_cm = grid->dz_cm = 1;
    grid->nr = 60000;
    grid->nz = grid->na = 1;
    for (i = 0; i < m->tissue.layer_count; ++i)
        grid->dr_cm = fmin(grid->dr_cm, 0.01 / (m->layer[i].mu_a_per_cm + m->layer[i].mu_s_per_cm));
    options.photons = 20000;
    options.no_absorption = 1;
    options.seed = 4711;
    for (;; grid->dr_cm *= 6) {
        int far_out = 0;
        CHECK_INT(ms_mcml_simulate(&m->tissue, grid, &options, &r, NULL), MS_OK);
        for (side = 0; side < 2; ++side) {
            const double *ring = side ? r.tt_r : r.rd_r, none = side ? r.tt_unscattered : r.rd_unscattered;
            const double total = (side ? r.tt : r.rd) - none;
            double left = total;
            for (e = 0, i = 0; i + 1 < grid->nr && e < EDGES - 1; ++i) {
                left -= ring[i] * ring_area(i, grid->dr_cm) - (i ? 0 : none);
                if (left < quantile[e] * total && (e == 0 || i + 1 > at[side][e - 1])) at[side][e++] = i + 1;
            }
            for (; e < EDGES - 1; ++e) at[side][e] = (e ? at[side][e - 1] : 0) + 1;
            far_out |= total > 1e-3 && at[side][EDGES - 2] >= grid->nr - 1;
        }
        ms_mcml_result_destroy(&r);
        if (!far_out) return;
    }
}

/* Rings of a solution that hold 1e-3 of their side's light against so many photons: how many are farther off than the
   stated error and four standard errors. *worst: by how many errors at most. */
static int rings_beyond(const random_tissue *m, const ms_mcml_layered *y, const ms_mcml_grid *grid, int at[2][EDGES],
                        double photons, uint64_t seed, int *rings)
{
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_result r;
    int side, e, i, beyond = 0;
    options.photons = (uint64_t)photons;
    options.no_absorption = 1;
    options.seed = seed;
    CHECK_INT(ms_mcml_simulate(&m->tissue, grid, &options, &r, NULL), MS_OK);
    beyond += !(fabs(y->rd - r.rd) <= y->rd_error + 4.5 * r.rd_error + 1 / photons);
    beyond += !(fabs(y->tt - r.tt) <= y->tt_error + 4.5 * r.tt_error + 1 / photons);
    for (side = 0; side < 2; ++side)
        for (e = 0; e < EDGES - 1; ++e) {
            const int from = e ? at[side][e - 1] : 0;
            const double r0 = from * grid->dr_cm, r1 = at[side][e] * grid->dr_cm,
                         area = 3.14159265358979 * (r1 - r0) * (r1 + r0);
            double energy = 0, square = 0, stated, got;
            for (i = from; i < at[side][e] && i < grid->nr; ++i) {
                const double a = ring_area(i, grid->dr_cm), p = a * (side ? r.tt_r : r.rd_r)[i];
                const double sigma = a * (side ? r.tt_r_error : r.rd_r_error)[i];
                energy += p;
                square += sigma * sigma + p * p / photons;
            }
            square = fmax(square - energy * energy / photons, 0);
            if (!(energy > 1e-3 * (side ? r.tt : r.rd)) || !((side ? r.tt : r.rd) > 1e-3)) continue;
            got = area * ms_mcml_layered_ring(y, side, r0, r1, &stated);
            CHECK(got >= 0 && stated > 0);
            beyond += !(fabs(got - energy) <= area * stated + 4 * sqrt(square));
            ++*rings;
        }
    ms_mcml_result_destroy(&r);
    return beyond;
}

/* None of random media (24, or 300 in the long version; another seed in each run, which is printed) has a ring or a
   total beyond the stated error and four standard errors. One of 16000 rings is, by chance: what seems beyond is asked
   again with sixteen times as many other photons. */
static void random_media(void)
{
    const uint64_t seed = test_seed > 1 ? test_seed : (uint64_t)time(NULL);
    const double photons = test_full ? 400000 : 100000;
    double slowest = 0;
    int i, rings = 0, again = 0;
    TEST_METHOD;
    for (i = 0; i < (test_full ? 300 : 24); ++i) {
        uint64_t state = seed * 1000003 + (uint64_t)i * 7919;
        int at[2][EDGES], beyond;
        random_tissue m;
        ms_mcml_layered y;
        ms_mcml_grid grid;
        ms_error error;
        clock_t start;
        draw(&m, &state);
        start = clock();
        if (ms_mcml_layered_solve(&m.tissue, NULL, &y, &error) != MS_OK) {
            if (strstr(error.message, "a factor of 50") == NULL) TEST_FAIL("medium %d: %s", i, error.message);
            continue;
        }
        slowest = fmax(slowest, (double)(clock() - start) / CLOCKS_PER_SEC);
        choose_rings(&m, &grid, at);
        beyond = rings_beyond(&m, &y, &grid, at, photons, seed + 815, &rings);
        if (beyond == 0) continue;
        ++again;
        beyond = rings_beyond(&m, &y, &grid, at, 16 * photons, seed + 816, &rings);
        if (beyond) TEST_FAIL("seed %lu, medium %d: %d beyond", (unsigned long)seed, i, beyond);
    }
    TEST_NOTE("seed %lu, %d media, %d rings, %d asked again, slowest %.2f s", (unsigned long)seed, i, rings, again,
              slowest);
}

/* The same tissue said in another way. */
static void identities(void)
{
    static const ms_mcml_layer one[1] = {{1.4, 1, 60, 0, 0.1}};
    static const ms_mcml_layer three[3] = {{1.4, 1, 60, 0, 0.02}, {1.4, 1, 60, 0, 0.05}, {1.4, 1, 60, 0, 0.03}};
    ms_mcml_tissue t;
    ms_mcml_layered a, b;
    int i;
    t.n_above = 1;
    t.n_below = 1.3;
    t.layer_count = 1;
    t.layers = one;
    CHECK_INT(ms_mcml_layered_solve(&t, NULL, &a, NULL), MS_OK);
    t.layer_count = 3;
    t.layers = three;
    CHECK_INT(ms_mcml_layered_solve(&t, NULL, &b, NULL), MS_OK);
    CHECK_NEAR(b.rd, a.rd, 1e-6); /* other panels */
    CHECK_NEAR(b.tt, a.tt, 1e-6);
    for (i = 1; i < 20; ++i) {
        const double r = 0.01 * i;
        CHECK_NEAR(ms_mcml_layered_outside(&b, 0, r), ms_mcml_layered_outside(&a, 0, r), 3e-4 * a.rd);
        CHECK_NEAR(ms_mcml_layered_outside(&b, 1, r), ms_mcml_layered_outside(&a, 1, r), 3e-4 * a.tt);
    }
}

static int stop(void *user, double fraction)
{
    *(int *)user += 1;
    return fraction > 0.5;
}

/* What is outside the domain is refused with a sentence that names photons, in whatever layer it is: paint on acrylic,
   thin films, glass, sharp scattering among them. Nothing is written. */
static void refusals(void)
{
    static const struct {
        const char *says;
        double n_below;
        int layers;
        ms_mcml_layer layer[2];
    } bad[] = {
        {"factor of 50", 1, 2, {{1.5, 1, 1e4, 0, 0.005}, {1.49, 1e-4, 0, 0, 1e8}}},
        {"g is 0.5", 1, 2, {{1.5, 1, 10, 0, 0.5}, {1.5, 1, 10, 0.5, 0.5}}},
        {"g is -0.95", 1, 1, {{1.5, 1, 10, -0.95, 0.5}, {0, 0, 0, 0, 0}}},
        {"clear", 1, 2, {{1.5, 1, 10, 0, 0.5}, {1.5, 0, 0, 0, 1}}},
        {"mean free paths", 1, 1, {{1.4, 0, 20, 0, 1.5e-4}, {0, 0, 0, 0, 0}}},
        {"n is 3", 1, 1, {{3, 0, 20, 0, 1}, {0, 0, 0, 0, 0}}},
        {"n is 0.9", 0.9, 1, {{1.5, 0, 20, 0, 1}, {0, 0, 0, 0, 0}}},
    };
    ms_mcml_layer layer = {1.4, 1, 100, 0, 1e8}, many[5];
    ms_mcml_tissue t;
    ms_mcml_layered s, before;
    ms_mcml_layered_options o;
    ms_error error;
    double depth[1] = {7}, bound;
    int asked = 0, i;
    unsigned k;
    memset(&before, 7, sizeof before);
    s = before;
    memset(&o, 0, sizeof o);
    t.n_above = 1;
    for (k = 0; k < sizeof bad / sizeof *bad; ++k) {
        t.n_below = bad[k].n_below;
        t.layer_count = bad[k].layers;
        t.layers = bad[k].layer;
        CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_UNSUPPORTED);
        if (strstr(error.message, bad[k].says) == NULL || strstr(error.message, "photons") == NULL)
            TEST_FAIL("'%s' does not say '%s' and photons", error.message, bad[k].says);
    }
    t.n_below = 1;
    t.layer_count = 1;
    t.layers = &layer;
    CHECK_INT(ms_mcml_layered_solve(NULL, &o, &s, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_layered_solve(&t, &o, NULL, &error), MS_INVALID_ARGUMENT);
    o.a_z = depth;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "nz is 0") != NULL);
    o.nz = 1;
    o.dz_cm = 1;
    o.progress.user = &asked;
    o.progress.report = stop;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_CANCELLED);
    CHECK(asked > 1 && depth[0] >= 7 && depth[0] <= 7);
    for (i = 0; i < 5; ++i) many[i] = layer;
    t.layer_count = 5;
    t.layers = many;
    CHECK_INT(ms_mcml_layered_solve(&t, NULL, &s, &error), MS_UNSUPPORTED);
    CHECK(memcmp(&s, &before, sizeof s) == 0);
    CHECK(ms_mcml_layered_outside(&s, 0, -1) != ms_mcml_layered_outside(&s, 0, -1)); /* NaN */
    CHECK(ms_mcml_layered_outside(NULL, 0, 1) != ms_mcml_layered_outside(NULL, 0, 1));
    CHECK(ms_mcml_layered_ring(&s, 2, 0, 1, NULL) != ms_mcml_layered_ring(&s, 2, 0, 1, NULL));
    CHECK(ms_mcml_layered_ring(&s, 0, 1, 1, NULL) != ms_mcml_layered_ring(&s, 0, 1, 1, NULL));
    memset(&o, 0, sizeof o);
    o.totals_only = 1; /* readings that need rings are NaN; the total is there */
    t.layer_count = 1;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_OK);
    CHECK_NEAR(ms_mcml_layered_outside(&s, 0, 0), s.rd, 0);
    CHECK(ms_mcml_layered_outside(&s, 0, 1e-9) != ms_mcml_layered_outside(&s, 0, 1e-9));
    CHECK(ms_mcml_layered_ring(&s, 0, 0, 1, &bound) != 0 && bound != bound);
}

static void memory_runs_out(void)
{
    const ms_mcml_tissue t = tissue_of(1);
    TEST_ALLOCATION_SWEEP(40, {
        ms_mcml_layered s;
        ms_mcml_layered_options o;
        memset(&o, 0, sizeof o);
        o.allocator = allocator;
        status = ms_mcml_layered_solve(&t, &o, &s, NULL);
    });
}

/* --- over a grid, and as a file --- */

/* The text of an .mco file; free it. */
static char *printed(const mci_run *spec, const ms_mcml_result *r)
{
    char *text = (char *)calloc(1, 60000);
    FILE *f = tmpfile();
    CHECK(f != NULL && text != NULL);
    mco_print(f, spec, r, "Layered solver", 0);
    rewind(f);
    CHECK(fread(text, 1, 59999, f) > 1000);
    fclose(f);
    return text;
}

/* The numbers behind a line that starts with a name, up to a blank line or count; how many are nan goes to *nans. */
static int numbers_of(const char *text, const char *name, double *out, int count, int *nans)
{
    const char *at = strstr(text, name);
    char *end;
    int n = 0;
    *nans = 0;
    if (at == NULL) return 0;
    for (at = strchr(at, '\n'); n < count; ++n, at = end) {
        const double x = strtod(at, &end);
        if (end == at) break;
        *nans += x != x;
        out[n] = x;
    }
    return n;
}

/* A file's run, solved and written, read back: every number in its place, energy adds up, Monte Carlo says the same. */
static void a_file_without_noise(void)
{
    static const char text[] =
        "1.0\n3\nfive.mco A\n300000\n0.01 0.02\n8 12 5\n2\n1\n1.4 2 60 0 0.04\n1.5 1 40 0 0.1\n1.2\n"
        "one.mco A\n300000\n0.01 0.02\n8 12 1\n1\n1\n1.4 2 60 0 0.04\n1\n"
        "four.mco A\n300000\n0.01 0.02\n8 12 1\n4\n1\n" /* as many layers as the solver takes */
        "1.4 2 60 0 0.01\n1.5 1 40 0 0.02\n1.35 3 50 0 0.03\n1.4 0.1 20 0 0.05\n1.2\n";
    char *text_of = NULL;
    TEST_METHOD;
    mci_file f = {0, NULL, NULL};
    ms_error error;
    int run, i, side, nans;
    CHECK_INT(mci_read(text, sizeof text - 1, &f, &error), MS_OK);
    for (run = 0; run < 3; ++run) {
        const mci_run *spec = &f.runs[run];
        const int na = spec->grid.na;
        ms_mcml_result r, mc;
        ms_mcml_options o = ms_mcml_defaults();
        double x[200], sum;
        if (mci_layered(&spec->tissue, &spec->grid, NULL, &r, &error)) TEST_FAIL("%s", error.message);
        text_of = printed(spec, &r);
        CHECK(strstr(text_of, "\t\t\t# No. of photons\n") != NULL && strstr(text_of, "# Layered solver\n") != NULL);
        CHECK_INT(numbers_of(text_of, "A_l #", x, 200, &nans), spec->tissue.layer_count);
        for (sum = 0, i = 0; i < spec->tissue.layer_count; ++i) sum += x[i];
        CHECK_NEAR(sum, r.a, 1e-4); /* four digits are printed */
        CHECK_INT(numbers_of(text_of, "A_z #", x, 200, &nans), 8);
        for (sum = 0, i = 0; i < 8; ++i) sum += 0.01 * x[i];
        CHECK_NEAR(sum, r.a, 1e-5);
        CHECK_INT(nans, 0);
        for (side = 0; side < 2; ++side) {
            const double total = side ? r.tt : r.rd;
            CHECK_INT(numbers_of(text_of, side ? "Tt_r #" : "Rd_r #", x, 200, &nans), 12);
            for (sum = 0, i = 0; i < 12; ++i) sum += x[i] * ring_area(i, 0.02);
            CHECK_NEAR(sum, total, 1e-5 + 2e-5 * total);
            CHECK_INT(numbers_of(text_of, side ? "Tt_a #" : "Rd_a #", x, 200, &nans), na);
            CHECK_INT(nans, na > 1 ? na : 0);
            /* a single bin: sin(pi / 4) pi / 2 of 2 pi sr, as MCML counts it */
            if (na == 1) CHECK_NEAR(x[0] * 6.2831853 * 0.70710678 * 1.57079633, total, 1e-4 * total);
            CHECK_INT(numbers_of(text_of, side ? "\nTt_ra\n" : "\nRd_ra\n", x, 200, &nans),
                      0); /* the name's own line first */
            CHECK_INT(numbers_of(text_of, side ? "Tt_ra\n" : "Rd_ra\n", x, 200, &nans), 12 * na);
            CHECK_INT(nans, na > 1 ? 12 * na : 0);
        }
        CHECK_INT(numbers_of(text_of, "A_rz\n", x, 200, &nans), 96);
        CHECK_INT(nans, 96);
        free(text_of);
        o.photons = spec->photons;
        o.seed = test_seed + 5;
        CHECK_INT(ms_mcml_simulate(&spec->tissue, &spec->grid, &o, &mc, &error), MS_OK);
        CHECK(fabs(r.rd - mc.rd) < 4.5 * mc.rd_error && fabs(r.tt - mc.tt) < 4.5 * mc.tt_error &&
              fabs(r.a - mc.a) < 4.5 * mc.a_error);
        CHECK_NEAR(r.specular, mc.specular, 1e-15);
        CHECK_NEAR(r.tt_unscattered, mc.tt_unscattered, 4.5 * mc.tt_error);
        for (i = 0; i < 12; ++i) { /* claimed errors are added to Monte Carlo's */
            CHECK(fabs(r.rd_r[i] - mc.rd_r[i]) < 4.5 * mc.rd_r_error[i] + 2 * r.rd_r_error[i]);
            CHECK(fabs(r.tt_r[i] - mc.tt_r[i]) < 4.5 * mc.tt_r_error[i] + 2 * r.tt_r_error[i]);
            if (na == 1) CHECK(fabs(r.rd_ra[i] - mc.rd_ra[i]) < 4.5 * mc.rd_ra_error[i] + 2 * r.rd_ra_error[i]);
        }
        for (i = 0; i < 8; ++i)
            CHECK_NEAR(r.a_z[i], mc.a_z[i], 0.02 * mc.a_z[i] + 1e-3); /* 3e5 photons: 0.3% a bin; floats at its edge */
        ms_mcml_result_destroy(&mc);
        ms_mcml_result_destroy(&r);
    }
    mci_destroy(&f);
}

/* What leaves next to nothing by rounding below 0 has totals and errors of at least 0. */
static void next_to_nothing(void)
{
    ms_mcml_layer l[2] = {{2.46687071, 75705.7794, 151304.434, 0, 0.000141500026},
                          {1.63830754, 4629.46648, 4.63410058, 0, 0.00439295416}};
    ms_mcml_tissue t = {1, 1, 2, l};
    ms_mcml_layered s;
    double e = -1;
    int i;
    CHECK_INT(ms_mcml_layered_solve(&t, NULL, &s, NULL), MS_OK);
    CHECK(s.tt >= 0 && ms_mcml_layered_outside(&s, 1, 0) >= 0);
    for (i = 0; i < 60; ++i) {
        CHECK(ms_mcml_layered_ring(&s, 1, i ? 1e-9 * pow(1.5, i - 1) : 0, 1e-9 * pow(1.5, i), &e) >= 0);
        CHECK(e >= 0);
    }
}

/* The last ring of a grid stands for all that lies beyond, and so does its error: it does not depend on its width. */
static void the_last_ring(void)
{
    ms_mcml_layer l = {1.4, 1, 60, 0, 0.1};
    ms_mcml_tissue t = {1, 1, 1, &l};
    ms_mcml_grid g = {0.001, 0.1, 1, 1, 1};
    ms_mcml_result narrow, wide;
    int side;
    CHECK_INT(mci_layered(&t, &g, NULL, &narrow, NULL), MS_OK);
    g.dr_cm = 1e4;
    CHECK_INT(mci_layered(&t, &g, NULL, &wide, NULL), MS_OK);
    for (side = 0; side < 2; ++side) {
        const double *r[2], *e[2], area[2] = {3.14159265358979324e-6, 3.14159265358979324e8};
        r[0] = side ? narrow.tt_r : narrow.rd_r;
        r[1] = side ? wide.tt_r : wide.rd_r;
        e[0] = side ? narrow.tt_r_error : narrow.rd_r_error;
        e[1] = side ? wide.tt_r_error : wide.rd_r_error;
        CHECK_NEAR(r[0][0] * area[0], side ? narrow.tt : narrow.rd, 1e-9);
        CHECK_NEAR(r[1][0] * area[1], r[0][0] * area[0], 1e-9);
        CHECK_NEAR(e[1][0] * area[1], e[0][0] * area[0], 1e-6 * e[0][0] * area[0]); /* the table ends before 1e4 cm */
    }
    ms_mcml_result_destroy(&narrow);
    ms_mcml_result_destroy(&wide);
}

/* --- skin --- */

/* CIE 1931 2 degree observer and D65, every 10 nm from 400 to 700: the published tables. */
static const double cie[31][4] = {
    {0.0143, 0.0004, 0.0679, 82.75},  {0.0435, 0.0012, 0.2074, 91.49},  {0.1344, 0.0040, 0.6456, 93.43},
    {0.2839, 0.0116, 1.3856, 86.68},  {0.3483, 0.0230, 1.7471, 104.86}, {0.3362, 0.0380, 1.7721, 117.01},
    {0.2908, 0.0600, 1.6692, 117.81}, {0.1954, 0.0910, 1.2876, 114.86}, {0.0956, 0.1390, 0.8130, 115.92},
    {0.0320, 0.2080, 0.4652, 108.81}, {0.0049, 0.3230, 0.2720, 109.35}, {0.0093, 0.5030, 0.1582, 107.80},
    {0.0633, 0.7100, 0.0782, 104.79}, {0.1655, 0.8620, 0.0422, 107.69}, {0.2904, 0.9540, 0.0203, 104.41},
    {0.4334, 0.9950, 0.0087, 104.05}, {0.5945, 0.9950, 0.0039, 100.00}, {0.7621, 0.9520, 0.0021, 96.33},
    {0.9163, 0.8700, 0.0017, 95.79},  {1.0263, 0.7570, 0.0011, 88.69},  {1.0622, 0.6310, 0.0008, 90.01},
    {1.0026, 0.5030, 0.0003, 89.60},  {0.8544, 0.3810, 0.0002, 87.70},  {0.6424, 0.2650, 0, 83.29},
    {0.4479, 0.1750, 0, 83.70},       {0.2835, 0.1070, 0, 80.03},       {0.1649, 0.0610, 0, 80.21},
    {0.0874, 0.0320, 0, 82.28},       {0.0468, 0.0170, 0, 78.28},       {0.0227, 0.0082, 0, 69.72},
    {0.0114, 0.0041, 0, 71.61}};

static double skin_total(const skin_parameters *skin, double nm, int specular)
{
    ms_mcml_layer layers[3];
    ms_mcml_tissue tissue;
    ms_mcml_layered_options o;
    ms_mcml_layered y;
    memset(&o, 0, sizeof o);
    memset(&y, 0, sizeof y);
    o.totals_only = 1;
    tissue.n_above = 1;
    tissue.n_below = 1.4;
    tissue.layers = layers;
    CHECK_INT(skin_layers(skin, nm, layers, &tissue.layer_count, NULL), MS_OK);
    CHECK_INT(ms_mcml_layered_solve(&tissue, &o, &y, NULL), MS_OK);
    return y.rd + specular * y.specular;
}

/* Layers as the cited laws say, worked out by hand at 500, 540 and 700 nm. */
static void skin_is_made_of_its_laws(void)
{
    skin_parameters skin = skin_defaults();
    ms_mcml_layer l[3];
    int count = 0;
    skin.melanin = skin.eumelanin = 1;
    skin.blood = skin.oxygen = 1;
    skin.scattering = 1;
    skin.g = 0.5;
    CHECK_INT(skin_layers(&skin, 500, l, &count, NULL), MS_OK);
    CHECK_INT(count, 2);
    CHECK_NEAR(l[0].mu_a_per_cm, 679, 1);     /* 6.6e11 500^-3.33 */
    CHECK_NEAR(l[1].mu_a_per_cm, 112.1, 0.1); /* 2.303 x 20932.8 x 150 / 64500 */
    CHECK_NEAR(l[0].mu_s_per_cm, 92, 1e-9);   /* 46 / (1 - g) */
    CHECK_NEAR(l[0].thickness_cm, 0.006, 1e-15);
    CHECK(l[0].g == 0.5 && l[1].thickness_cm == 1e8 && l[0].n == 1.4);
    CHECK_INT(skin_layers(&skin, 540, l, &count, NULL), MS_OK);
    CHECK_NEAR(l[1].mu_a_per_cm, 285.1, 0.1);
    skin.melanin = skin.blood = 0;
    CHECK_INT(skin_layers(&skin, 500, l, &count, NULL), MS_OK);
    CHECK_NEAR(l[0].mu_a_per_cm, 0.244 + 85.3 * 0.005372, 1e-4); /* exp(-346 / 66.2) */
    CHECK_NEAR(l[1].mu_a_per_cm, l[0].mu_a_per_cm, 0);
    skin.melanin = 1;
    skin.eumelanin = 0;
    skin.dermis_mm = 1.5;
    skin.blood = 1;
    skin.oxygen = 0;
    CHECK_INT(skin_layers(&skin, 700, l, &count, NULL), MS_OK);
    CHECK_INT(count, 3);
    CHECK_NEAR(l[0].mu_a_per_cm, 88.8, 0.5);  /* 2.9e15 700^-4.75 */
    CHECK_NEAR(l[1].mu_a_per_cm, 9.61, 0.01); /* 1794.3 */
    CHECK_NEAR(l[1].thickness_cm, 0.15, 1e-15);
    CHECK_NEAR(l[2].mu_s_per_cm, 2 * 12.2, 0.1); /* 1050 x 700^-0.68 */
    CHECK_NEAR(l[2].mu_a_per_cm, 0.1 * 9.61 + 0.9 * 0.2659, 0.01);
}

/* Reflectance, specular included, of people inside the forearm: Cooksey, Allen, Tsai 2017, NIST, read from plots of the
   data to 0.005: the darkest and the lightest of 100 and the median. Three numbers of the skin fitted to each, the rest
   the defaults; the model is one of homogeneous layers, and the mean laws of scattering and pale skin need not be those
   of a person: 0.02 at worst. */
static void skin_of_people(void)
{
    static const double nm[9] = {500, 520, 545, 570, 580, 600, 620, 650, 700};
    static const double seen[3][9] = {{0.099, 0.106, 0.111, 0.124, 0.131, 0.177, 0.219, 0.262, 0.340},
                                      {0.433, 0.445, 0.415, 0.421, 0.417, 0.566, 0.638, 0.654, 0.677},
                                      {0.342, 0, 0, 0, 0, 0.467, 0, 0, 0.614}};
    static const double made[3][3] = {{0.119, 0.134, 2.29}, {0.0144, 0.0237, 3.92}, {0.016, 0.037, 2.2}};
    int i, p;
    for (p = 0; p < 3; ++p) {
        skin_parameters skin = skin_defaults();
        double sum = 0, worst = 0;
        int n = 0;
        skin.melanin = made[p][0];
        skin.blood = made[p][1];
        skin.scattering = made[p][2];
        skin.g = 0;
        for (i = 0; i < 9; ++i) {
            double d = skin_total(&skin, nm[i], 1) - seen[p][i];
            if (!(seen[p][i] > 0)) continue;
            sum += d * d;
            worst = fmax(worst, fabs(d));
            ++n;
        }
        CHECK_LE(sqrt(sum / n), 0.012);
        CHECK_LE(worst, 0.025);
        TEST_NOTE("%s: rms %.4f, worst %.3f",
                  p == 0       ? "darkest"
                      : p == 1 ? "lightest"
                               : "median",
                  sqrt(sum / n), worst);
    }
}

/* Linear sRGB of the 13 wavelengths' totals. */
static void skin_color(const skin_parameters *skin, double rgb[3])
{
    double weight[SKIN_BANDS][3];
    int i, c;
    skin_band_weights(weight);
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (i = 0; i < SKIN_BANDS; ++i) {
        const double total = skin_total(skin, skin_bands[i], 0);
        for (c = 0; c < 3; ++c) rgb[c] += weight[i][c] * total;
    }
}

/* 13 wavelengths and the observer's formula against 31 and the published tables; what more melanin, blood and oxygen
   do. */
static void skin_color_of_the_observer(void)
{
    static const double matrix[3][3] = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}; /* IEC 61966-2-1 */
    static const double melanin[] = {0.005, 0.03, 0.1, 0.3};
    double worst = 0, before[3] = {1, 1, 1}, rgb[3], more[3];
    skin_parameters skin = skin_defaults();
    int i, c, k;
    skin.g = 0;
    for (k = 0; k < 4; ++k) {
        double sum[3] = {0, 0, 0}, white[3] = {0, 0, 0};
        skin.melanin = melanin[k];
        skin_color(&skin, rgb);
        for (i = 0; i < 31; ++i) {
            double r = skin_total(&skin, 400 + 10 * i, 0);
            for (c = 0; c < 3; ++c) {
                double v = cie[i][3] * (matrix[c][0] * cie[i][0] + matrix[c][1] * cie[i][1] + matrix[c][2] * cie[i][2]);
                white[c] += v;
                sum[c] += v * r;
            }
        }
        for (c = 0; c < 3; ++c) {
            worst = fmax(worst, fabs(rgb[c] - sum[c] / white[c]));
            CHECK(rgb[c] < before[c] && rgb[c] > 0);
            before[c] = rgb[c];
        }
        CHECK(rgb[0] > rgb[1] && rgb[1] > rgb[2]);
    }
    CHECK_LE(worst, 0.006); /* the formula's 1% of an observer, and lines between bands */
    skin.melanin = 0.02;
    skin_color(&skin, rgb);
    skin.blood *= 2; /* green falls most: a blush */
    skin_color(&skin, more);
    CHECK(more[1] / rgb[1] < more[0] / rgb[0] - 0.02 && more[1] / rgb[1] < more[2] / rgb[2]);
    skin.oxygen = 0; /* blue lips */
    skin_color(&skin, rgb);
    CHECK(rgb[0] < more[0] && rgb[2] > more[2]);
    TEST_NOTE("worst %.4f", worst);
}

/* A profile of R, G, B: its totals are the color, its rings add up to them, none is negative; g changes the middle, not
   the color much. */
static void skin_profile_of_a_color(void)
{
    skin_parameters skin = skin_defaults();
    ms_mcml_profile p;
    double rgb[3];
    int c, i;
    TEST_METHOD;
    skin.dermis_mm = 2;
    skin.g = 0;
    skin_color(&skin, rgb);
    CHECK_INT(skin_profile(&p, &skin, NULL, NULL), MS_OK);
    CHECK_INT(p.channels, 3);
    for (c = 0; c < 3; ++c) {
        const double *rd = p.rd_per_mm2 + c * p.rings, *within = p.within + c * (p.rings + 1);
        double sum = 0;
        CHECK_NEAR(p.total[c], rgb[c], 1e-6); /* totals do not depend on the rings */
        for (i = 0; i < p.rings; ++i) {
            CHECK(rd[i] >= 0);
            sum += rd[i] * 3.14159265358979 * (p.edge_mm[i + 1] * p.edge_mm[i + 1] - p.edge_mm[i] * p.edge_mm[i]);
        }
        CHECK_NEAR(sum, within[p.rings], 3e-5); /* noise below zero far out counts as none */
        CHECK_NEAR(sum, rgb[c], 1e-4);          /* the rings end where 1e-5 of a wavelength's energy is left */
    }
    CHECK(p.within[p.rings / 2] <
          p.within[2 * (p.rings + 1) + p.rings / 2] * p.total[0] / p.total[2]); /* red goes farther than blue */
    ms_mcml_profile_destroy(&p);
    { /* far out, where rounding would rule: rings fall, none is negative, out to where doubles end */
        ms_mcml_profile_options o;
        double edge[121];
        for (i = 0; i < 121; ++i) edge[i] = 0.05 * (pow(1.08, i) - 1);
        memset(&o, 0, sizeof o);
        o.edge_mm = edge;
        o.rings = 120;
        CHECK_INT(skin_profile(&p, &skin, &o, NULL), MS_OK);
        for (c = 0; c < 3; ++c)
            for (i = 1; i < 120; ++i) {
                const double *rd = p.rd_per_mm2 + c * 120 + i;
                CHECK(rd[0] >= 0 && rd[0] <= rd[-1]);
            }
        CHECK(p.rd_per_mm2[119] > 0 && p.rd_per_mm2[119] < 1e-20); /* 480 mm from the beam */
        ms_mcml_profile_destroy(&p);
    }
}

static void skin_refused(void)
{
    skin_parameters skin = skin_defaults();
    ms_mcml_profile p;
    ms_mcml_profile_options o;
    ms_error error;
    int i;
    memset(&o, 0, sizeof o);
    for (i = 0; i < 8; ++i) {
        static const char *const name[8] = {"melanin",      "eumelanin", "blood",      "oxygen",
                                            "epidermis_mm", "dermis_mm", "scattering", "g is"};
        skin_parameters bad = skin;
        *(i == 0       ? &bad.melanin
              : i == 1 ? &bad.eumelanin
              : i == 2 ? &bad.blood
              : i == 3 ? &bad.oxygen
              : i == 4 ? &bad.epidermis_mm
              : i == 5 ? &bad.dermis_mm
              : i == 6 ? &bad.scattering
                       : &bad.g) = -0.1;
        CHECK_INT(skin_profile(&p, &bad, NULL, &error), MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, name[i]) != NULL && p.memory == NULL);
    }
    CHECK_INT(ms_mcml_profile_layers(&p, NULL, 1, NULL, &error), MS_INVALID_ARGUMENT);
    skin.g = 0;
    for (i = 1; i <= 4; ++i) {
        /* The profile's own memory and the first wavelength's: each solve's is swept in memory_runs_out. */
        test_memory memory;
        memset(&memory, 0, sizeof memory);
        memset(&o, 0, sizeof o);
        memory.fail_at = i;
        o.allocator.user = &memory;
        o.allocator.alloc = test_memory_alloc;
        o.allocator.release = test_memory_release;
        o.rings = 2;
        o.ring_mm = 1;
        CHECK_INT(skin_profile(&p, &skin, &o, NULL), MS_OUT_OF_MEMORY);
        CHECK(memory.blocks == 0 && memory.errors == 0 && p.memory == NULL);
    }
}

static const test_case cases[] = {
    {"totals", totals},
    {"published", published},
    {"random_media", random_media},
    {"identities", identities},
    {"refusals", refusals},
    {"memory_runs_out", memory_runs_out},
    {"a_file_without_noise", a_file_without_noise},
    {"next_to_nothing", next_to_nothing},
    {"the_last_ring", the_last_ring},
    {"skin_is_made_of_its_laws", skin_is_made_of_its_laws},
    {"skin_of_people", skin_of_people},
    {"skin_color_of_the_observer", skin_color_of_the_observer},
    {"skin_profile_of_a_color", skin_profile_of_a_color},
    {"skin_refused", skin_refused},
};

TEST_MAIN(cases)
