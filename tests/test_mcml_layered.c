/* The layered solver of ms_mcml.h: totals against adding-doubling (written here, nothing shared with the header), published
   numbers and identities; rings against the half-space solver where g = 0 and against direct Monte Carlo where it is not. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "test.h"

#define NODES 120 /* at most: rays of a layer, the beam last */

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
    double nu[NODES], wn[NODES], x[64], w[64], breaks[20], mu[NODES], weight[NODES], power;
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
            const double f = y->g > 0 ? pow(y->g, order + 1) : 0, mu_s = y->mu_s_per_cm * (1 - f), mu_t = y->mu_a_per_cm + mu_s;
            double *p = (double *)calloc((size_t)(6 * n * n), sizeof(double)), *q = p + n * n, *m1 = q + n * n, *m2 = m1 + n * n;
            double *b1 = m2 + n * n, *b2 = b1 + n * n, thickness = y->thickness_cm < 1e7 ? y->thickness_cm : 0, step;
            int doublings;
            if (!(thickness > 0)) thickness = 60 / sqrt(3 * y->mu_a_per_cm * (y->mu_a_per_cm + y->mu_s_per_cm * (1 - y->g))) + 60 / mu_t;
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
                        const double g = ((l ? pow(y->g, l) : 1) - f) / (1 - f), next_i = ((2 * l + 3) * mu[i] * pi1 - (l + 1) * pi0) / (l + 2);
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
        for (i = 0; i < n; ++i) { /* Fresnel; radiance scales with n squared, the beam does not */
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
    *rd -= ms_mcml__specular(tissue, i);
    free(all.r);
}

static const struct {
    const char *name;
    double n_above, n_below;
    int layers;
    ms_mcml_layer layer[3];
} media[] = {
    {"half-space g 0 n 1.5", 1, 1, 1, {{1.5, 10, 90, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"slab g 0.75", 1, 1, 1, {{1, 10, 90, 0.75, 0.02}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"sample.mci", 1, 1, 3, {{1.37, 1, 100, 0.9, 0.1}, {1.37, 1, 10, 0, 0.1}, {1.37, 2, 10, 0.7, 0.2}}},
    {"skin", 1, 1.44, 3, {{1.4, 3, 200, 0.8, 0.01}, {1.4, 0.5, 150, 0.8, 0.15}, {1.44, 0.2, 100, 0.8, 1e8}}},
    {"albedo 0.99999", 1, 1, 1, {{1.3, 0.001, 99.999, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"albedo 0.01", 1, 1, 1, {{1.4, 99, 1, 0.5, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"g -0.5", 1, 1, 1, {{1.37, 1, 20, -0.5, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"g -0.7", 1, 1.2, 1, {{1.37, 1, 20, -0.7, 0.5}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"index 2.5", 1, 1, 1, {{2.5, 0.05, 20, 0, 0.2}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"mu_a 0", 1, 1.5, 1, {{1.4, 0, 50, 0.5, 0.2}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"1e-6 cm on a deep layer", 1, 1, 2, {{1.5, 50, 500, 0.8, 1e-6}, {1.37, 1, 100, 0.8, 1e8}, {0, 0, 0, 0, 0}}},
    {"glass, tissue, glass", 1, 1, 3, {{1.5, 0, 0, 0, 0.1}, {1.37, 1, 100, 0.8, 0.1}, {1.5, 0, 0, 0, 0.1}}},
    {"less dense in between", 1, 1.5, 3, {{1.5, 1, 50, 0.8, 0.05}, {1.33, 0.5, 60, 0.7, 0.05}, {1.6, 0.5, 60, 0.5, 0.1}}},
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
        reference(&t, 24, 47, &rd, &tt);
        CHECK_NEAR(s.rd, rd, 1e-5); /* the promise; adding-doubling itself is good to about 1e-6 */
        CHECK_NEAR(s.tt, tt, 1e-5);
        CHECK(s.rd_error < 5e-5 && s.tt_error < 5e-5 && fabs(s.rd - rd) < s.rd_error + 3e-6 && fabs(s.tt - tt) < s.tt_error + 3e-6);
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

/* van de Hulst 1980, table 35: a slab of optical thickness 2, albedo 0.9, g = 0.75, matched indices. */
static void published(void)
{
    const ms_mcml_tissue t = tissue_of(1);
    ms_mcml_layered s;
    ms_error error;
    if (ms_mcml_layered_solve(&t, NULL, &s, &error)) TEST_FAIL("%s", error.message);
    CHECK_NEAR(s.rd, 0.09739, 5e-6 + 1e-6); /* the last digit printed */
    CHECK_NEAR(s.tt, 0.66096, 5e-6 + 1e-6);
}

/* Where g = 0 the half-space solver, whose rings are good to 1e-4, says the same. */
static void rings_of_isotropic_half_spaces(void)
{
    static const double albedo[] = {0.5, 0.9, 0.99, 0.999}, index[] = {1, 1.3, 1.5};
    double worst = 0;
    int a, n, i;
    for (a = 0; a < 4; ++a)
        for (n = 0; n < 3; ++n) {
            ms_mcml_medium m;
            ms_mcml_halfspace h;
            ms_mcml_layer layer;
            ms_mcml_tissue t;
            ms_mcml_layered s;
            double r = 0, next;
            m.mu_a_per_mm = 1 - albedo[a];
            m.mu_s_per_mm = albedo[a];
            m.g = 0;
            m.eta = index[n];
            CHECK_INT(ms_mcml_halfspace_solve(&m, NULL, &h, NULL), MS_OK);
            layer.n = index[n];
            layer.mu_a_per_cm = 10 * m.mu_a_per_mm;
            layer.mu_s_per_cm = 10 * m.mu_s_per_mm;
            layer.g = 0;
            layer.thickness_cm = 1e8;
            t.n_above = t.n_below = 1;
            t.layer_count = 1;
            t.layers = &layer;
            CHECK_INT(ms_mcml_layered_solve(&t, NULL, &s, NULL), MS_OK);
            CHECK_NEAR(s.rd, h.total, 3e-6);
            for (i = 0; i < 40; ++i, r = next) { /* mm; from a hundredth of a mean free path */
                const double want = ms_mcml_halfspace_ring(&h, r, next = r > 0 ? r * 1.3 : 0.01);
                double error, got = 0.01 * ms_mcml_layered_ring(&s, 0, 0.1 * r, 0.1 * next, &error);
                if (want * 3.14159265 * (next * next - r * r) < 1e-5 * h.total) continue;
                if (want * 3.14159265 * (next * next - r * r) > 1e-3 * h.total) CHECK_NEAR(got / want, 1, next < 1 ? 0.01 : 0.003); /* the promise */
                CHECK(fabs(got - want) < 2.5 * 0.01 * error + 1e-4 * want); /* its own error, as large as standard errors go, and that of the other solver */
                if (next >= 1 && want * 3.14159265 * (next * next - r * r) > 1e-3 * h.total && fabs(got / want - 1) > worst) worst = fabs(got / want - 1);
            }
            for (i = 0; i < 6; ++i) {
                const double x = 0.1 * pow(2, i);
                CHECK_NEAR(ms_mcml_layered_line_beyond(&s, 0, 0.1 * x), ms_mcml_halfspace_line_beyond(&h, x), 1e-3 * h.total);
                CHECK_NEAR(ms_mcml_layered_beyond(&s, 0, 0.1 * x), ms_mcml_halfspace_beyond(&h, x), 1e-3 * h.total);
            }
            for (i = 0; i < s.frequencies; ++i) { /* at high frequencies as well as eight rays a panel do */
                const double k = 0.1 * s.frequency_per_cm[i], want = ms_mcml_halfspace_spectrum(&h, k);
                CHECK_NEAR(s.rd_spectrum[i], want, k < 5 ? 1e-4 * h.total : 0.03 * want);
            }
        }
    TEST_NOTE("12 half-spaces, worst ring beyond a mean free path %.1e", worst);
}

/* Rings of all else against Monte Carlo, wide ones, so that its noise is small. */
static void rings_of_layers(void)
{
    static const unsigned which[] = {1, 3, 6, 12, 2}; /* the last takes a second: in the long version */
    static const double edge[] = {0, 0.5, 1, 2, 3, 5, 8, 12, 20, 40};
    double chi2 = 0;
    int n = 0, side, i, k;
    unsigned q;
    for (q = 0; q < (test_full ? 5u : 4u); ++q) {
        const ms_mcml_tissue t = tissue_of(which[q]);
        ms_mcml_options options = ms_mcml_defaults();
        ms_mcml_grid grid;
        ms_mcml_result r;
        ms_mcml_layered s;
        ms_error error;
        memset(&grid, 0, sizeof grid);
        grid.dr_cm = 0.5 / (t.layers[0].mu_a_per_cm + t.layers[0].mu_s_per_cm); /* half a mean free path of the top layer */
        grid.dz_cm = 1;
        grid.nr = 81;
        grid.nz = grid.na = 1;
        options.photons = test_full ? 20000000 : 400000;
        options.no_absorption = 1;
        options.seed = test_seed + 77 + q;
        if (ms_mcml_layered_solve(&t, NULL, &s, &error)) TEST_FAIL("%s: %s", media[which[q]].name, error.message);
        CHECK_INT(ms_mcml_simulate(&t, &grid, &options, &r, NULL), MS_OK);
        for (side = 0; side < 2; ++side)
            for (i = 0; i + 1 < (int)(sizeof edge / sizeof *edge); ++i) {
                const int from = (int)(2 * edge[i]), to = (int)(2 * edge[i + 1]);
                const double r0 = from * grid.dr_cm, r1 = to * grid.dr_cm, area = 3.14159265358979 * (r1 - r0) * (r1 + r0);
                double sum = 0, square = 0, claim, got = ms_mcml_layered_ring(&s, side, r0, r1, &claim);
                for (k = from; k < to; ++k) {
                    const double a = ms_mcml__ring_area(k, grid.dr_cm), e = side ? r.tt_r_error[k] : r.rd_r_error[k];
                    sum += a * (side ? r.tt_r[k] : r.rd_r[k]);
                    square += a * a * e * e;
                }
                CHECK(got >= 0);
                if (!(sum > 1e-4)) continue;
                square += area * area * claim * claim;
                chi2 += (got * area - sum) * (got * area - sum) / square;
                ++n;
                if (fabs(got * area - sum) > 4.5 * sqrt(square))
                    TEST_FAIL("%s, side %d, %g to %g cm: %g, Monte Carlo %g +- %g", media[which[q]].name, side, r0, r1, got * area, sum, sqrt(square));
            }
        ms_mcml_result_destroy(&r);
    }
    CHECK(test_chi2_p(chi2, n) > 1e-4);
    TEST_NOTE("%d rings, chi2 %.1f", n, chi2);
}

/* The same tissue said in another way. */
static void identities(void)
{
    static const ms_mcml_layer one[1] = {{1.4, 1, 60, 0.8, 0.1}};
    static const ms_mcml_layer three[3] = {{1.4, 1, 60, 0.8, 0.02}, {1.4, 1, 60, 0.8, 0.05}, {1.4, 1, 60, 0.8, 0.03}};
    ms_mcml_tissue t;
    ms_mcml_layered a, b;
    ms_mcml_layered_options o;
    double moment[34];
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
        CHECK_NEAR(ms_mcml_layered_beyond(&b, 0, r), ms_mcml_layered_beyond(&a, 0, r), 3e-4 * a.rd);
        CHECK_NEAR(ms_mcml_layered_beyond(&b, 1, r), ms_mcml_layered_beyond(&a, 1, r), 3e-4 * a.tt);
    }
    for (i = 0; i < 34; ++i) moment[i] = pow(0.8, i); /* Henyey-Greenstein, given by its moments */
    memset(&o, 0, sizeof o);
    o.moment = moment;
    o.order = a.order;
    t.layer_count = 1;
    t.layers = one;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &b, NULL), MS_OK);
    CHECK_NEAR(b.rd, a.rd, 1e-9);
    CHECK_NEAR(ms_mcml_layered_beyond(&b, 1, 0.02), ms_mcml_layered_beyond(&a, 1, 0.02), 1e-9);
}

static int stop(void *user, double fraction)
{
    *(int *)user += 1;
    return fraction > 0.5;
}

static void refusals(void)
{
    ms_mcml_layer layer = {1.4, 1, 100, 0.99, 1e8};
    ms_mcml_layer many[17];
    ms_mcml_tissue t;
    ms_mcml_layered s, before;
    ms_mcml_layered_options o;
    ms_error error;
    int asked = 0, i;
    t.n_above = t.n_below = 1;
    t.layer_count = 1;
    t.layers = &layer;
    memset(&o, 0, sizeof o);
    o.totals_only = 1;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_NOT_CONVERGED); /* says so, and how far it is */
    CHECK(s.rd > 0 && s.rd_error > 5e-5 && error.message[0]);
    memset(&before, 7, sizeof before);
    s = before;
    memset(&o, 0, sizeof o);
    layer.g = 0.5;
    CHECK_INT(ms_mcml_layered_solve(NULL, &o, &s, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_layered_solve(&t, &o, NULL, &error), MS_INVALID_ARGUMENT);
    o.order = 32;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "order is 32") != NULL);
    o.order = 0;
    o.tolerance = 0.5;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_INVALID_ARGUMENT);
    o.tolerance = 0;
    o.frequency_step = -1;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_INVALID_ARGUMENT);
    o.frequency_step = 0;
    o.progress.user = &asked;
    o.progress.report = stop;
    CHECK_INT(ms_mcml_layered_solve(&t, &o, &s, &error), MS_CANCELLED);
    CHECK(asked > 1);
    for (i = 0; i < 17; ++i) many[i] = layer;
    t.layer_count = 17;
    t.layers = many;
    CHECK_INT(ms_mcml_layered_solve(&t, NULL, &s, &error), MS_UNSUPPORTED);
    CHECK(memcmp(&s, &before, sizeof s) == 0);
    CHECK(ms_mcml_layered_beyond(&s, 0, -1) != ms_mcml_layered_beyond(&s, 0, -1)); /* NaN */
    CHECK(ms_mcml_layered_beyond(NULL, 0, 1) != ms_mcml_layered_beyond(NULL, 0, 1));
    CHECK(ms_mcml_layered_ring(&s, 2, 0, 1, NULL) != ms_mcml_layered_ring(&s, 2, 0, 1, NULL));
    CHECK(ms_mcml_layered_ring(&s, 0, 1, 1, NULL) != ms_mcml_layered_ring(&s, 0, 1, 1, NULL));
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

static const test_case cases[] = {
    {"totals", totals},
    {"published", published},
    {"rings_of_isotropic_half_spaces", rings_of_isotropic_half_spaces},
    {"rings_of_layers", rings_of_layers},
    {"identities", identities},
    {"refusals", refusals},
    {"memory_runs_out", memory_runs_out},
};

TEST_MAIN(cases)
