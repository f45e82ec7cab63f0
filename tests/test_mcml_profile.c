/* Half-space solver, profiles and materials of ms_mcml.h: against adding-doubling and Galerkin
   tables, against an independent solution by H functions that this file contains, and against each other. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "json.h"
#include "layered.h"
#include "ordinates.h"
#include "photon_profile.h"
#include "stack.h"
#include "test.h"
#include "white.h"

#define PI 3.14159265358979324

static ms_mcml_medium medium_of(double albedo, double eta)
{
    ms_mcml_medium m;
    m.mu_a_per_mm = 1 - albedo;
    m.mu_s_per_mm = albedo;
    m.g = 0;
    m.eta = eta;
    return m;
}

static ms_mcml__halfspace solve_by(ms_mcml_medium medium, double depth_step, double frequency_step)
{
    static double work[MS_MCML__SOLVE_DOUBLES];
    ms_mcml__halfspace s;
    CHECK_INT(ms_mcml__check_medium(&medium, NULL), MS_OK);
    ms_mcml__solve(&medium, depth_step, frequency_step, &s, work);
    return s;
}

static ms_mcml__halfspace solve(ms_mcml_medium medium) { return solve_by(medium, 0.3, 0.25); }

static double reflectance_of(const ms_mcml_medium *m)
{
    return ordinates_total(m->mu_a_per_mm / (m->mu_a_per_mm + m->mu_s_per_mm), m->g, m->eta);
}

/* --- the independent reference: totals by Chandrasekhar's H function and Fresnel's boundary as a linear system.

   A matched half-space of isotropic scattering reflects  I(mu) = a/2 int mu' H(mu) H(mu') / (mu + mu') I_in(mu') dmu'
   (Chandrasekhar 1960, chapter V), with 1 / H = sqrt(1 - a) + a/2 int mu' H(mu') / (mu + mu') dmu'. What comes up is
   reflected with R(mu) and comes in again. Nothing is shared with the solver but Fresnel's formulae. --- */

#define PANEL 56 /* tanh-sinh nodes a panel: 1e-12 with endpoint square roots */

typedef struct reference_nodes {
    int count;
    double mu[2 * PANEL], weight[2 * PANEL], reflect[2 * PANEL];
} reference_nodes;

static void reference_panel(reference_nodes *n, double low, double high, double eta)
{
    int i;
    for (i = 0; i < PANEL; ++i) {
        double t = (i + 0.5 - 0.5 * PANEL) * (7.0 / PANEL), e = exp(-PI * sinh(t)), from_low = (high - low) / (1 + e);
        double mu = low + from_low, out2, out, rs, rp;
        n->mu[n->count] = mu;
        n->weight[n->count] = (high - low) * (7.0 / PANEL) * PI * cosh(t) * e / ((1 + e) * (1 + e));
        out2 = low > 0 ? eta * eta * from_low * (mu + low) : 1 - eta * eta * (1 - mu * mu);
        out = out2 > 0 ? sqrt(out2) : 0;
        rs = (eta * mu - out) / (eta * mu + out);
        rp = (eta * out - mu) / (eta * out + mu);
        n->reflect[n->count++] = high < 1 ? 1 : 0.5 * (rs * rs + rp * rp);
    }
}

static double reference_total(double albedo, double absorption, double eta)
{
    static double matrix[2 * PANEL][2 * PANEL + 1];
    static reference_nodes q;
    double h[2 * PANEL], next[2 * PANEL], h1 = 1, entering = (eta - 1) / (eta + 1), change, total = 0;
    double mu_c = eta > 1 ? sqrt((eta - 1) * (eta + 1)) / eta : 0;
    int i, j, k, round, n;
    q.count = 0;
    if (mu_c > 0) reference_panel(&q, 0, mu_c, eta);
    reference_panel(&q, mu_c, 1, eta);
    n = q.count;
    entering = 1 - entering * entering;
    for (i = 0; i < n; ++i) h[i] = 1;
    for (round = 0; round < 4000; ++round) { /* damped, so that it also settles for conservative scattering */
        for (change = 0, i = 0; i <= n; ++i) {
            double mu = i < n ? q.mu[i] : 1, sum = 0;
            for (j = 0; j < n; ++j) sum += q.weight[j] * q.mu[j] * h[j] / (mu + q.mu[j]);
            sum = 1 / (sqrt(absorption) + 0.5 * albedo * sum);
            if (i == n) {
                h1 = sum;
                break;
            }
            next[i] = 0.5 * (sum + h[i]);
            if (fabs(next[i] / h[i] - 1) > change) change = fabs(next[i] / h[i] - 1);
        }
        memcpy(h, next, sizeof h);
        if (change < 1e-15) break;
    }
    for (i = 0; i < n; ++i) { /* I_i - sum_j S_ij R_j I_j = direct light of the beam */
        for (j = 0; j < n; ++j)
            matrix[i][j] = (i == j) -
                0.5 * albedo * q.weight[j] * q.mu[j] * h[i] * h[j] / (q.mu[i] + q.mu[j]) * q.reflect[j];
        matrix[i][n] = albedo * entering / (4 * PI) * h[i] * h1 / (q.mu[i] + 1);
    }
    for (i = 0; i < n; ++i) { /* diagonally dominant for a < 1: no pivoting */
        for (j = i + 1; j < n; ++j) {
            double f = matrix[j][i] / matrix[i][i];
            for (k = i + 1; k <= n; ++k) matrix[j][k] -= f * matrix[i][k];
        }
    }
    for (i = n - 1; i >= 0; --i) {
        for (k = i + 1; k < n; ++k) matrix[i][n] -= matrix[i][k] * matrix[k][n];
        matrix[i][n] /= matrix[i][i];
        total += 2 * PI * q.weight[i] * q.mu[i] * (1 - q.reflect[i]) * matrix[i][n];
    }
    return total;
}

/* --- totals --- */

static void totals_of_the_reference_data(void)
{
    json *data = json_load("tests/data/mcml_totals.json"), *cases = json_get(data, "cases");
    int i, count = 0;
    double worst = 0, worst_own = 0;
    for (i = 0; i < cases->count; ++i) {
        json *c = &cases->child[i];
        ms_mcml_medium m;
        double expected, error, own;
        if (json_find(c, "diff_exact_minus_ad") == NULL) continue;
        m.mu_a_per_mm = 0.1 * json_number(json_get(c, "mua_per_cm"));
        m.mu_s_per_mm = 0.1 * json_number(json_get(c, "mus_per_cm"));
        m.g = 0;
        m.eta = json_number(json_get(c, "n"));
        expected = json_number(json_get(c, "Rd"));
        error = solve(m).total - expected;
        CHECK_NEAR(error, 0, 1e-7); /* the file's numbers are exact to about 1e-7 */
        own = reference_total(m.mu_s_per_mm / (m.mu_a_per_mm + m.mu_s_per_mm),
                              m.mu_a_per_mm / (m.mu_a_per_mm + m.mu_s_per_mm), m.eta) -
            expected;
        CHECK_NEAR(own, 0, 1e-7);
        if (fabs(error) > worst) worst = fabs(error);
        if (fabs(own) > worst_own) worst_own = fabs(own);
        ++count;
    }
    CHECK(count >= 10);
    TEST_NOTE("%d cases, largest difference %.1e; H functions %.1e", count, worst, worst_own);
    json_free(data);
}

static void totals_of_every_index_and_albedo(void)
{
    static const double eta[] = {0.5, 0.8, 0.999, 1.0, 1.000001, 1.01, 1.1, 1.3, 1.5, 2.0, 2.5, 4.0};
    static const double albedo[] = {1e-12, 1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999, 0.9999, 0.99999, 0.999999};
    unsigned i, j;
    double worst = 0, relative = 0;
    for (i = 0; i < sizeof eta / sizeof eta[0]; ++i) {
        for (j = 0; j < sizeof albedo / sizeof albedo[0]; ++j) {
            double total = solve(medium_of(albedo[j], eta[i])).total;
            double expected = reference_total(albedo[j], 1 - albedo[j], eta[i]), error = fabs(total - expected);
            CHECK_NEAR(total, expected, 1e-9 * (expected < 0.1 ? 10 * expected : 1)); /* as stated */
            if (error > worst) worst = error;
            if (error / expected > relative) relative = error / expected;
        }
    }
    TEST_NOTE("largest difference %.1e, relative %.1e", worst, relative);
}

/* Largest relative misfit of the terms' spectrum of multiple scattering at the frequencies t that are `spacing` apart in
   log t, from the solver's least to its last, 200: with 0.25 its own. */
static double spectrum_misfit(const ms_mcml_medium *m, const ms_mcml__halfspace *s, double spacing)
{
    const double absorption = m->mu_a_per_mm / (m->mu_a_per_mm + m->mu_s_per_mm);
    const double nu = ms_mcml__case_eigenvalue(s->albedo, absorption);
    double matrix[MS_MCML__TRIANGLE], t, worst = 0;
    ms_mcml__cone cone;
    ms_mcml__cone_make(&cone, m->eta);
    for (t = fmax(0.01 * nu, 1e-7); t < 200; t *= exp(spacing)) {
        const double k2 = t * t - nu * nu;
        const double expected = (1 - s->specular) * ms_mcml__multiple(&cone, s->albedo, k2, t, 0.3, matrix);
        double sum = 0;
        int i;
        for (i = 0; i < s->rates; ++i) {
            const double rate = s->rate_per_mm[i] / s->mu_t_per_mm;
            /* 1 + k^2 / rate^2 without cancellation: rate^2 - nu^2 is 0 for the tail */
            sum += s->energy[i] * rate * rate / (t * t + fmax(0, (rate - nu) * (rate + nu)));
        }
        worst = fmax(worst, fabs(sum / expected - 1));
    }
    return worst;
}

/* With little absorption what is lost over what leaves is A t (1 + B t): the law that stands in below t = 4e-6 leaves
   out B t, and the albedo, rounded by 2^-54 of 1 = t^2 / 3 / (1 - albedo), is felt as 1.5 2^-54 / t^2. They meet there. */
static void slow_decay(void)
{
    static const double eta[] = {0.1, 0.3, 0.8, 1, 1.3, 1.5, 2, 5, 10};
    double matrix[MS_MCML__TRIANGLE], worst = 0;
    size_t n;
    for (n = 0; n < sizeof eta / sizeof *eta; ++n) {
        double single = 0, ratio[2];
        ms_mcml__cone cone;
        int i;
        ms_mcml__cone_make(&cone, eta[n]);
        for (i = 0; i < cone.count; ++i) single += cone.weight[i] * cone.mu[i] / (1 + cone.mu[i]);
        for (i = 0; i < 2; ++i) {
            const double t = 1e-4 * (i + 1), albedo = t / atanh(t);
            const double left = albedo * single + ms_mcml__multiple(&cone, albedo, 0, t, 0.3, matrix);
            ratio[i] = (1 - left) / left / t;
        }
        worst = fmax(worst, (ratio[1] / ratio[0] - 1) / 1e-4);
    }
    CHECK_LE(worst, 1.25); /* as stated */
    CHECK_NEAR(pow(1.5 * pow(2, -54) / 1.25, 1 / 3.0), 4e-6, 0.1e-6);
}

/* Random media, absorption down to 1e-14 and up to all but 1e-10 of what is met, indices 0.1 to 10 and within 1e-8 of
   1. */
static void random_media(void)
{
    uint64_t state = test_seed;
    int n, count = test_full ? 2000 : 150;
    double worst = 0, worst_fit = 0;
    for (n = 0; n < count; ++n) {
        ms_mcml_medium m;
        ms_mcml__halfspace s;
        double r, last = 1e300, misfit, u = test_uniform(&state), v = test_uniform(&state);
        m.eta = n % 7 == 0 ? 1 + 1e-8 * u : n % 3 == 0 ? 0.1 * pow(100, u) : 1 + 1.5 * u;
        m.mu_a_per_mm = n % 5 == 0 ? 1 - pow(10, -10 * v) : n % 2 ? v : pow(10, -14 * v);
        m.mu_s_per_mm = 1 - m.mu_a_per_mm;
        m.g = 0;
        s = solve(m);
        CHECK(s.total >= 0 && s.total <= 1 - s.specular);
        CHECK_LE(spectrum_misfit(&m, &s, 0.37), 8e-5); /* between them: what the manual says of the rings */
        misfit = spectrum_misfit(&m, &s, 0.25);
        CHECK_LE(misfit, 1e-6); /* a few times what 3000 media showed */
        if (misfit > worst_fit) worst_fit = misfit;
        for (r = 1e-3; r < 1e4; r *= 2) {
            double rd = ms_mcml__halfspace_ring(&s, r, 2 * r);
            CHECK(rd >= 0 && rd <= last);
            last = rd;
        }
        if (n % 10 == 0) {
            double error = fabs(s.total - reference_total(m.mu_s_per_mm, m.mu_a_per_mm, m.eta));
            CHECK_LE(error, 1e-9); /* as stated */
            if (error > worst) worst = error;
        }
    }
    TEST_NOTE("%d media, totals %.1e, misfit %.1e", count, worst, worst_fit);
}

static void totals_at_the_edges(void)
{
    ms_mcml__halfspace s = solve(medium_of(0, 1.5));
    ms_mcml_medium m = medium_of(1, 1.5);
    CHECK(s.total <= 0 && s.total >= 0);
    CHECK(ms_mcml__halfspace_ring(&s, 0, 1) <= 0);
    s = solve(m); /* no absorption: all that enters leaves */
    CHECK_NEAR(s.total, 0.96, 1e-15);
    CHECK_NEAR(s.rate_per_mm[0], 1e-7, 1e-7); /* no slowest rate: as slow as the lattice of frequencies */
    m.mu_a_per_mm = 1e-9;
    CHECK_NEAR(solve(m).total, reference_total(1, 1e-9, 1.5), 1e-9);
    m.mu_a_per_mm = 1e-30; /* below the rounding of the albedo; absorbed: about 3 sqrt(mu_a) */
    CHECK_NEAR(solve(m).total, 0.96, 1e-14);
    /* a^2 and more of small albedos: the total is single scattering to first order */
    s = solve(medium_of(1e-9, 1.3));
    CHECK_NEAR(s.total / s.total_single, 1, 1e-8);
    CHECK_NEAR(solve(medium_of(1e-90, 1.3)).total / s.total, 1e-81, 1e-89);
    CHECK(solve(medium_of(1e-300, 1.3)).total <= 1e-100);
    /* units: per km and per nm */
    m = medium_of(0.9, 1.3);
    m.mu_a_per_mm *= 1e-6;
    m.mu_s_per_mm *= 1e-6;
    CHECK_NEAR(solve(m).total, solve(medium_of(0.9, 1.3)).total, 1e-14);
    m.mu_a_per_mm *= 1e12;
    m.mu_s_per_mm *= 1e12;
    CHECK_NEAR(solve(m).total, solve(medium_of(0.9, 1.3)).total, 1e-14);
}

/* --- profiles --- */

typedef struct table {
    double eta, mu_a, mu_s; /* per cm */
    int count;
    double r0[200], r1[200], rd[200], se[200]; /* cm */
} table;

static void load_table(const char *name, table *t)
{
    char path[200], line[400];
    FILE *f;
    snprintf(path, sizeof path, "tests/data/mcml_profiles/%s.csv", name);
    f = fopen(path, "r");
    memset(t, 0, sizeof *t);
    CHECK(f != NULL);
    while (f && fgets(line, sizeof line, f)) {
        double i0, i1;
        int k = t->count;
        if (sscanf(line, "# n: %lf", &t->eta) == 1 || sscanf(line, "# mua_per_cm: %lf", &t->mu_a) == 1 ||
            sscanf(line, "# mus_per_cm: %lf", &t->mu_s) == 1 ||
            sscanf(line, "# layers: n=%lf mua=%lf mus=%lf", &t->eta, &t->mu_a, &t->mu_s) == 3)
            continue;
        if (k < 200 &&
            sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf", &i0, &i1, &t->r0[k], &t->r1[k], &t->rd[k], &t->se[k]) == 6)
            t->count++;
    }
    if (f) fclose(f);
}

static ms_mcml_medium table_medium(const table *t)
{
    ms_mcml_medium m;
    m.mu_a_per_mm = 0.1 * t->mu_a;
    m.mu_s_per_mm = 0.1 * t->mu_s;
    m.g = 0;
    m.eta = t->eta;
    return m;
}

static void profiles_of_the_exact_tables(void)
{
    static const char *const name[] = {"exact_skin1_R", "exact_skin1_G", "exact_ketchup_R", "exact_marble_G",
                                       "exact_giovanelli"};
    static table t;
    unsigned k;
    for (k = 0; k < sizeof name / sizeof name[0]; ++k) {
        ms_mcml__halfspace s;
        double worst = 0;
        int i, j, rings = 0;
        load_table(name[k], &t);
        CHECK(t.count > 50);
        s = solve(table_medium(&t));
        for (i = 0; i < t.count; ++i) {
            double energy = t.rd[i] * PI * (t.r1[i] * t.r1[i] - t.r0[i] * t.r0[i]), se = 0;
            double rd = 100 * ms_mcml__halfspace_ring(&s, 10 * t.r0[i], 10 * t.r1[i]);
            /* The tables' uncertainty is the difference of two discretizations, which changes sign from ring to ring:
               the largest within six rings is meant. */
            for (j = i - 6; j <= i + 6; ++j)
                if (j >= 0 && j < t.count && t.se[j] / t.rd[j] > se) se = t.se[j] / t.rd[j];
            if (energy < 1e-5) continue;
            CHECK_NEAR(rd / t.rd[i], 1, 1e-4 + 2 * se);
            if (se < 1e-4 && fabs(rd / t.rd[i] - 1) > worst) worst = fabs(rd / t.rd[i] - 1);
            rings += se < 1e-4;
        }
        TEST_NOTE("%s %.0e in the %d rings that are sure to 1e-4", name[k] + 6, worst, rings);
        CHECK_LE(worst, 1e-4);
    }
}

/* Original MCML, 7.5e6 photons: chi-square of its rings. */
static void profile_of_original_mcml(void)
{
    static table t;
    ms_mcml__halfspace s;
    double chi2 = 0, p;
    int i, n = 0;
    load_table("mcml_skin1_R", &t);
    s = solve(table_medium(&t));
    for (i = 0; i < t.count; ++i) {
        double z = (t.rd[i] - 100 * ms_mcml__halfspace_ring(&s, 10 * t.r0[i], 10 * t.r1[i])) / t.se[i];
        if (t.se[i] > 0.1 * t.rd[i]) continue; /* too few photons to be normal */
        chi2 += z * z;
        ++n;
    }
    p = test_chi2_p(chi2, n);
    CHECK(n > 80);
    CHECK(p > 1e-4);
    TEST_NOTE("chi2 %.1f of %d, p %.2f", chi2, n, p);
}

/* The two knobs, moved: every ring with 1e-5 of the energy within 1e-4 of a finer solution, for hard media. */
static void profiles_settle(void)
{
    static const double hard[][2] = {{1, 0.9},      {1.000001, 0.3}, {1.3, 0.01},        {1.3, 0.3},
                                     {1.3, 0.9585}, {1.5, 0.998},    {2.5, 0.99},        {2.5, 0.3},
                                     {0.8, 0.7},    {1.3, 0.99999},  {1.4, 0.999999999}, {1.4, 1}};
    unsigned k;
    double worst = 0;
    for (k = 0; k < sizeof hard / sizeof hard[0]; ++k) {
        ms_mcml_medium m = medium_of(hard[k][1], hard[k][0]);
        ms_mcml__halfspace a = solve(m), b = solve_by(m, 0.28, 0.2);
        double r = 0, next;
        CHECK_NEAR(a.total, b.total, 1e-9);
        for (next = 1e-4; next < 1e6; r = next, next *= 1.1) {
            double ra = ms_mcml__halfspace_ring(&a, r, next), rb = ms_mcml__halfspace_ring(&b, r, next);
            CHECK(ra > 0 || next * a.rate_per_mm[0] > 700);
            if (rb * PI * (next * next - r * r) < 1e-5 * b.total) continue;
            if (fabs(ra / rb - 1) > 1e-4)
                TEST_FAIL("eta %g albedo %g r %g: %g", hard[k][0], hard[k][1], r, ra / rb - 1);
            if (fabs(ra / rb - 1) > worst) worst = fabs(ra / rb - 1);
        }
    }
    CHECK_LE(worst, 8e-5); /* as stated */
    TEST_NOTE("largest change %.1e", worst);
}

/* exp(-nu r) / r^2 far out, nu the root of a atanh(nu) = nu; falling and positive everywhere. */
static void tail_is_the_one_of_transport_theory(void)
{
    static const double albedo[] = {0.9, 0.99, 0.999, 0.99999}; /* for smaller ones the cut that starts at 1 mixes in */
    unsigned k;
    for (k = 0; k < 4; ++k) {
        ms_mcml__halfspace s = solve(medium_of(albedo[k], 1.4));
        double nu = ms_mcml__case_eigenvalue(albedo[k], 1 - albedo[k]), last = 1e300, r, slope, r1 = 40 / nu,
               r2 = 60 / nu;
        CHECK_NEAR(albedo[k] * atanh(nu) / nu, 1, 1e-12);
        for (r = 1e-6; r * nu < 500; r *= 1.3) {
            double rd = ms_mcml__halfspace_ring(&s, r, 1.05 * r);
            CHECK(rd > 0 && rd < last);
            last = rd;
        }
        slope = log(ms_mcml__halfspace_ring(&s, r1, 1.001 * r1) * r1 * r1 /
                    (ms_mcml__halfspace_ring(&s, r2, 1.001 * r2) * r2 * r2)) /
            (r2 - r1);
        CHECK_NEAR(slope / nu, 1,
                   0.005); /* the next term of the tail is of relative size 1 / (nu r) = 1/40 to 1/60: slope 0.004 */
        TEST_NOTE("albedo %g: slope / nu_0 = %.4f", albedo[k], slope / nu);
    }
}

static void bessel_k1(void)
{
    static ms_mcml__halfspace one; /* of one rate: what leaves beyond x is x K1(x) */
    double x, worst = 0;
    one.rates = 1;
    one.rate_per_mm[0] = one.energy[0] = one.total = 1;
    for (x = 1e-8; x < 700;
         x *= 1.07) { /* x K1(x) = x int_0^inf exp(-x cosh t) cosh t dt: the trapezoid rule is exact to rounding */
        double sum = 0.5 * exp(-x), t, h = 0.02;
        for (t = h; x * cosh(t) < 740; t += h) sum += exp(-x * cosh(t)) * cosh(t);
        sum *= x * h;
        worst = fmax(worst, fabs(ms_mcml__halfspace_outside(&one, x) / sum - 1));
    }
    CHECK_LE(worst, 1e-11); /* 6e-12 of the fit and the rule's rounding */
    CHECK_NEAR(ms_mcml__halfspace_outside(&one, 0), 1, 0);
    TEST_NOTE("relative error %.1e", worst);
}

static double bessel_j0(double x)
{
    int i, n = 64 + (int)(2 * x);
    double sum = 0;
    for (i = 0; i < n; ++i) sum += cos(x * sin(PI * (i + 0.5) / n));
    return sum / n;
}

/* The spectrum of a solution's terms, by the formula beside the struct. */
static double spectrum_at(const ms_mcml__halfspace *s, double k)
{
    double sum = 0;
    int i;
    for (i = 0; i < s->singles; ++i) sum += s->single_energy[i] / hypot(1, k / s->single_rate_per_mm[i]);
    for (i = 0; i < s->rates; ++i) sum += s->energy[i] / (1 + k / s->rate_per_mm[i] * (k / s->rate_per_mm[i]));
    return sum;
}

/* Two faces of a solution: rings, and the spectrum computed from the rings. */
static void rings_and_spectrum_agree(void)
{
    static const double hard[][2] = {{1.3, 0.9}, {1.5, 0.3}, {1.0, 0.99}};
    static const double at[] = {0.01, 0.1, 1, 3};
    unsigned k, q;
    double worst_k = 0;
    for (k = 0; k < 3; ++k) {
        ms_mcml__halfspace s = solve(medium_of(hard[k][1], hard[k][0]));
        for (q = 0; q < 4; ++q) {
            double r = 0, next, spectrum = 0;
            for (next = 1e-5; next < 500; r = next, next += 0.003 * next < 0.01 ? 0.003 * next : 0.01) {
                double e = ms_mcml__halfspace_outside(&s, r) - ms_mcml__halfspace_outside(&s, next);
                spectrum += e * bessel_j0(at[q] * 0.5 * (r + next));
                if (e < 1e-13) break;
            }
            CHECK_NEAR(spectrum_at(&s, at[q]), spectrum, 2e-5); /* rings 0.3% wide as points: 1e-5 */
            worst_k = fmax(worst_k, fabs(spectrum_at(&s, at[q]) - spectrum));
        }
        CHECK_NEAR(spectrum_at(&s, 0), s.total, 1e-14);
        CHECK_NEAR(ms_mcml__halfspace_outside(&s, 0), s.total, 1e-14);
    }
    TEST_NOTE("spectrum %.1e", worst_k);
}

static void narrow_and_wide_rings(void)
{
    ms_mcml__halfspace s = solve(medium_of(0.95, 1.3));
    double at;
    for (at = 1e-9; at < 30;
         at *= 10) { /* a ring of no width has the density: twelve digits narrower changes nothing */
        double a = ms_mcml__halfspace_ring(&s, at, at * (1 + 1e-5)),
               b = ms_mcml__halfspace_ring(&s, at, at * (1 + 1e-15) + 1e-300);
        double c = ms_mcml__halfspace_ring(&s, at * (1 - 0.5e-3), at * (1 + 0.5e-3));
        CHECK_NEAR(a / c, 1, 1e-5 + 1e-4 * at); /* the density varies by r^-1 exp(-r) over the rings */
        CHECK_NEAR(b / a, 1, 1e-4);
    }
    /* 1 / r near the beam: single scattering, R_d r -> a (1 - R_sp) T / (2 pi) int (1 - u^2) / (1 + u^2)^2 exp(-r / u)
       du */
    CHECK_NEAR(ms_mcml__halfspace_ring(&s, 0, 1e-9) / ms_mcml__halfspace_ring(&s, 0, 1e-8), 10, 1e-5);
    CHECK(ms_mcml__halfspace_ring(&s, 0, 1e9) * PI * 1e18 <= s.total * (1 + 1e-12));
    CHECK_NEAR(ms_mcml__halfspace_ring(&s, 0, 1e9) * PI * 1e18, s.total, 1e-12);
    CHECK(ms_mcml__halfspace_ring(&s, 1e8, 1e9) >= 0);
}

/* --- colors --- */

/* Discrete ordinates against the half-space solver. */
static void reflectance_without_a_profile(void)
{
    static const double eta[] = {0.5, 1, 1.1, 1.4, 2.5, 10}, albedo[] = {1e-3, 0.3, 0.9, 0.999, 0.999999, 1};
    double worst = 0;
    unsigned i, j;
    for (i = 0; i < 6; ++i)
        for (j = 0; j < 6; ++j) {
            ms_mcml_medium m = medium_of(albedo[j], eta[i]);
            worst = fmax(worst, fabs(reflectance_of(&m) - solve(m).total));
        }
    CHECK_LE(worst, 1e-8);
    TEST_NOTE("worst %.1e", worst);
}

/* Christensen, Burley 2015, equations 6 and 8, of a medium and its color. */
static double length_of(const ms_mcml_medium *m, int kind, double color)
{
    const double reduced = 1 / (m->mu_a_per_mm + m->mu_s_per_mm * (1 - m->g));
    const double d = reduced / (1.85 - color + 7 * pow(fabs(color - 0.8), 3));
    if (kind == MS_MCML_MEAN_FREE_PATH) return 1 / (m->mu_a_per_mm + m->mu_s_per_mm);
    return kind == MS_MCML_BURLEY_D ? d : d * (3.5 + 100 * pow(color - 0.33, 4));
}

/* An artist picks colors and lengths: the medium has them, of every index, and its profile the color. */
static void medium_from_a_color(void)
{
    static const double color[] = {1e-6, 1e-3, 0.04, 0.39, 0.52, 0.8, 0.97, 0.999, 0.9999999},
                        eta[] = {0.6, 1, 1.33, 1.5, 3};
    double worst = 0, worst_length = 0, total;
    unsigned i, j;
    int kind;
    ms_mcml_medium m;
    for (i = 0; i < 9; ++i)
        for (j = 0; j < 5; ++j)
            for (kind = 0; kind < 3; ++kind) {
                double specular = (eta[j] - 1) / (eta[j] + 1), back;
                CHECK_INT(ms_mcml_medium_from_color(color[i], 0.7, kind, eta[j], &m, NULL), MS_OK);
                back = reflectance_of(&m) / (1 - specular * specular);
                worst = fmax(worst, fabs(back - color[i]));
                worst_length = fmax(worst_length, fabs(length_of(&m, kind, back) / 0.7 - 1));
                if (!(m.mu_a_per_mm >= 0 && m.mu_s_per_mm >= 0))
                    TEST_FAIL("color %g eta %g: mu_a %g, mu_s %g", color[i], eta[j], m.mu_a_per_mm, m.mu_s_per_mm);
            }
    CHECK_LE(worst, 1e-7);        /* as stated */
    CHECK_LE(worst_length, 1e-6); /* Burley's fits amplify the error of the color by up to 6 */
    for (i = 1; i < 8; ++i) {     /* its profile's total */
        CHECK_INT(ms_mcml_medium_from_color(color[i], 1, MS_MCML_MEAN_FREE_PATH, 1.5, &m, NULL), MS_OK);
        total = solve(m).total;
        CHECK_NEAR(total, 0.96 * color[i], 1e-9 * color[i]);
        CHECK_NEAR(m.mu_a_per_mm + m.mu_s_per_mm, 1, 1e-14);
    }
    /* Christensen and Burley's figures: A = 0.8 has s = 1.05 of the path, 3.5 + 100 * 0.47^4 of the diffuse path */
    CHECK_INT(ms_mcml_medium_from_color(0.8, 2, MS_MCML_BURLEY_D, 1.4, &m, NULL), MS_OK);
    CHECK_NEAR(m.mu_a_per_mm + m.mu_s_per_mm, 1 / 2.1, 1e-14);
    CHECK_INT(ms_mcml_medium_from_color(0.8, 2 * (3.5 + 100 * 0.47 * 0.47 * 0.47 * 0.47), MS_MCML_DIFFUSE_PATH, 1.4, &m,
                                        NULL),
              MS_OK);
    CHECK_NEAR(m.mu_a_per_mm + m.mu_s_per_mm, 1 / 2.1, 1e-14);
    CHECK_INT(ms_mcml_medium_from_color(0, 2, 0, 1.4, &m, NULL), MS_OK); /* black and white */
    CHECK_NEAR(m.mu_a_per_mm, 0.5, 1e-15);
    CHECK_NEAR(m.mu_s_per_mm, 0, 0);
    CHECK_INT(ms_mcml_medium_from_color(1, 2, 0, 1.4, &m, NULL), MS_OK);
    CHECK_NEAR(m.mu_a_per_mm, 0, 0);
    TEST_NOTE("color %.1e, length %.1e", worst, worst_length);
}

/* Random colors of every size and index: given back to 1e-7, as stated, and to 1e-4 of themselves, however dark. */
static void random_colors(void)
{
    uint64_t state = test_seed + 71;
    double worst = 0, relative = 0;
    int i;
    for (i = 0; i < (test_full ? 3000 : 300); ++i) {
        const double u = test_uniform(&state), drawn = 0.1 * pow(100, test_uniform(&state));
        const double eta = i == 0 ? 6.3747119181415863 : i == 1 ? 9.5934239192326789 : drawn; /* were off by 1.5e-7, */
        const double color = i == 0 ? 0.99998496310403584
            : i == 1                ? 6.1547030062375723e-08 /* and by 1.1e-4 of itself */
            : i % 3 == 0            ? pow(10, -20 * u)
            : i % 3 == 1            ? 1 - pow(10, -12 * u)
                                    : u;
        const double specular = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
        double back;
        ms_mcml_medium m;
        CHECK_INT(ms_mcml_medium_from_color(color, 1, MS_MCML_MEAN_FREE_PATH, eta, &m, NULL), MS_OK);
        back = solve_by(m, 0.3, 1).total / (1 - specular);
        if (!(fabs(back - color) <= 1e-7 && fabs(back - color) <= 1e-4 * color))
            TEST_FAIL("eta %.17g, color %.17g gives back %.17g", eta, color, back);
        worst = fmax(worst, fabs(back - color));
        relative = fmax(relative, color > 0 ? fabs(back / color - 1) : 0);
    }
    TEST_NOTE("%d colors, worst %.1e, %.1e of the color", i, worst, relative);
}

static void colors_refused(void)
{
    static const double wrong[][4] = {{-0.1, 1, 0, 1.3}, {1.1, 1, 0, 1.3},  {0.5, 0, 0, 1.3},  {0.5, -1, 0, 1.3},
                                      {0.5, 1, 4, 1.3},  {0.5, 1, -1, 1.3}, {0.5, 1, 0, 0.01}, {0.5, 1e31, 0, 1.3}};
    static const char *const says[] = {"color", "color", "length_mm", "length_mm",
                                       "kind",  "kind",  "eta",       "1e-30 to 1e30"};
    ms_mcml_medium m = medium_of(0.5, 1.3), same = m;
    ms_error error;
    unsigned i;
    for (i = 0; i < 8; ++i) {
        CHECK_INT(ms_mcml_medium_from_color(wrong[i][0], wrong[i][1], (int)wrong[i][2], wrong[i][3], &m, &error),
                  MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, says[i]) != NULL);
        CHECK(memcmp(&m, &same, sizeof m) == 0);
    }
    CHECK_INT(ms_mcml_medium_from_color(0.5, 1, 0, 1.3, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_medium_from_color(strtod("nan", NULL), 1, 0, 1.3, &m, &error), MS_INVALID_ARGUMENT);
}

/* --- the kernels' functions, of the scalar text that all levels share --- */

/* Words to flights, -log u, and to directions: Henyey-Greenstein's cosine and an even azimuth, in the basis of Duff et
   al. 2017 about the old direction; all in double. */
static void kernel_functions(void)
{
    static const double g[] = {0, 0.3, -0.6, 0.9, 0.999, -0.99, 1};
    uint64_t state = test_seed + 91;
    double worst_flight = 0, worst = 0;
    int i, k;
    for (i = 0; i < 20000; ++i) {
        const uint32_t word = i < 64 ? (i & 1 ? ~0u >> i / 2 : 1u << i / 2)
                                     : (uint32_t)(4294967295.0 * test_uniform(&state));
        const double u = ((word >> 1) + 0.5) / 2147483648.0, flight = -log(u);
        /* u and the logarithm of its power of 2 are floats: 2^-24 of 1 and of the flight, twice */
        worst_flight = fmax(worst_flight, fabs((double)ms_mcml__exponential_scalar(word) - flight) / (1 + 2 * flight));
    }
    CHECK_LE(worst_flight, 7e-8); /* 2^-24 and the polynomial's 1e-8 */
    for (i = 0; i < 4000; ++i) {
        const uint32_t to_cosine = (uint32_t)(4294967295.0 * test_uniform(&state)),
                       to_azimuth = (uint32_t)(4294967295.0 * test_uniform(&state));
        const double of = g[i % 7], xi = (to_cosine >> 8) / 16777216.0, part = (1 - of * of) / (1 - of + 2 * of * xi);
        const double cosine = of < 1 ? fabs(of) > 0 ? (1 + of * of - part * part) / (2 * of) : 2 * xi - 1 : 1;
        const double sine = sqrt(fmax(0, 1 - cosine * cosine)),
                     azimuth = 2 * PI * ((to_azimuth >> 8) / 16777216.0 - 0.5);
        const double z = i < 40 ? (i & 1 ? 1 : -1) : 2 * test_uniform(&state) - 1,
                     around = 2 * PI * test_uniform(&state);
        const double flat = sqrt(1 - z * z), u[3] = {flat * cos(around), flat * sin(around), z};
        const double sign = z < 0 ? -1 : 1, a = -1 / (sign + z), b = u[0] * u[1] * a;
        const double first[3] = {1 + sign * u[0] * u[0] * a, sign * b, -sign * u[0]};
        const double second[3] = {b, sign + u[1] * u[1] * a, -u[1]};
        float v[3], kept[3];
        for (k = 0; k < 3; ++k) v[k] = kept[k] = (float)u[k];
        ms_mcml__deflect_scalar(0, (float)of, to_cosine, to_azimuth, &v[0], &v[1], &v[2]);
        for (k = 0; k < 3; ++k) {
            const double want = sine * (cos(azimuth) * first[k] + sin(azimuth) * second[k]) + cosine * u[k];
            worst = fmax(worst, fabs((double)v[k] - want));
        }
        ms_mcml__deflect_scalar(-1, (float)of, to_cosine, to_azimuth, &kept[0], &kept[1], &kept[2]); /* at a boundary */
        for (k = 0; k < 3; ++k) CHECK(kept[k] == (float)u[k]);
    }
    CHECK_LE(worst, 1e-5); /* 1 - g of a float g = 0.999 is off by 3e-5 of itself, and so is the sine, up to a third */
    TEST_NOTE("flights %.1e, directions %.1e", worst_flight, worst);
}

/* Philox 4x32-10 (Salmon et al. 2011), by products of 64 bits. */
static void philox(uint32_t c[4], uint64_t key)
{
    uint32_t k0 = (uint32_t)key, k1 = (uint32_t)(key >> 32);
    int i;
    for (i = 0; i < 10; ++i, k0 += 0x9E3779B9u, k1 += 0xBB67AE85u) {
        const uint64_t a = (uint64_t)0xD2511F53u * c[0], b = (uint64_t)0xCD9E8D57u * c[2];
        const uint32_t c0 = (uint32_t)(b >> 32) ^ c[1] ^ k0, c2 = (uint32_t)(a >> 32) ^ c[3] ^ k1;
        c[0] = c0, c[1] = (uint32_t)b, c[2] = c2, c[3] = (uint32_t)a;
    }
}

/* A photon's state is Philox's of the seed and its index, which the published answer for zeros confirms. */
static void states_of_photons(void)
{
    static const uint64_t index[] = {0, 1, 4095, 4294967295u, ((uint64_t)7 << 33) + 12345};
    static ms_mcml__tracer t;
    const ms_mcml_layer layer = {1.4, 1, 20, 0.5, 0.5};
    const ms_mcml_tissue tissue = {1, 1, 1, &layer};
    uint32_t want[4] = {0, 0, 0, 0};
    ms_mcml_options o = ms_mcml_defaults();
    ms_mcml_grid grid;
    ms_mcml *m;
    int i, k;
    philox(want, 0);
    CHECK(want[0] == 0x6627e8d5u && want[1] == 0xe169c58du && want[2] == 0xbc57ac4cu && want[3] == 0x9b00dbd8u);
    memset(&grid, 0, sizeof grid);
    grid.dr_cm = grid.dz_cm = 0.1;
    grid.nr = grid.nz = grid.na = 1;
    o.seed = 0x123456789abcdef0u + test_seed;
    CHECK_INT(ms_mcml_create(&tissue, &grid, &o, &m, NULL), MS_OK);
    for (i = 0; i < 5; ++i) {
        t.tally = m;
        t.next = index[i];
        ms_mcml__seed_scalar(&t);
        want[0] = (uint32_t)index[i], want[1] = (uint32_t)(index[i] >> 32), want[2] = 0x4D434D4Cu, want[3] = 0;
        philox(want, o.seed);
        for (k = 0; k < 4; ++k) CHECK(t.fresh[k][0] == want[k]);
    }
    ms_mcml_destroy(m);
}

/* Reflected with Fresnel's R, unpolarized; beyond the critical angle all is. */
static void kernel_reflects(void)
{
    static ms_mcml__tracer t;
    static const double ratio[] = {1, 1.4, 1 / 1.4, 2.5, 0.4, 1.0001};
    int i, k, up;
    for (i = 0; i < 6; ++i)
        for (k = 1; k <= 40; ++k)
            for (up = 0; up < 2; ++up) {
                const double cosine = k / 40.0, out2 = 1 - ratio[i] * ratio[i] * (1 - cosine * cosine),
                             out = sqrt(fmax(0, out2));
                const double rs = (ratio[i] * cosine - out) / (ratio[i] * cosine + out);
                const double rp = (ratio[i] * out - cosine) / (ratio[i] * out + cosine);
                const double reflected = out2 > 0 ? 0.5 * (rs * rs + rp * rp) : 1;
                t.ratio_up[0] = (float)(up ? ratio[i] : 3.3);
                t.ratio_down[0] = (float)(up ? 3.3 : ratio[i]);
                if (fabs(out2) < 1e-3) continue; /* next to the critical angle a float decides */
                CHECK(ms_mcml__fresnel_scalar(&t, -up, (float)cosine, (float)(reflected * 0.999 - 1e-6)));
                CHECK(!ms_mcml__fresnel_scalar(&t, -up, (float)cosine, (float)(reflected * 1.001 + 1e-6)));
                CHECK_NEAR((double)t.cos_t[0], out, 3e-4); /* a root of the rounding, 1e-7 */
            }
}

/* --- against walks --- */

/* Photons for a test: fewer where there are no vectors, so that it ends in the same time. */
static uint64_t scaled(uint64_t photons) { return test_simd_best() > 2 ? photons : photons / 4; }

static void walks_agree_with_the_solver(void)
{
    static const double eta[] = {1.0, 1.3, 1.5}, albedo[] = {0.02, 0.5, 0.9, 0.99, 0.999, 1};
    static white w;
    unsigned k, q;
    double least = 1;
    uint64_t seed = test_seed + 6;
    TEST_METHOD;
    for (k = 0; k < 3; ++k) {
        double rd[WHITE_RINGS], se[WHITE_RINGS];
        int i;
        white_run(&w, eta[k], test_full ? 2000000 : 200000, &seed);
        for (q = 0; q < 6; ++q) {
            ms_mcml__halfspace s = solve(medium_of(albedo[q], eta[k]));
            double total = 0, total_se = 0, chi2 = 0, p;
            int n = 0;
            white_profile(&w, albedo[q], rd, se, &total, &total_se);
            CHECK_NEAR(total, s.total, 4.5 * total_se); /* 18 totals: 1e-4 that one fails by chance, for some seed */
            for (i = 0; i < WHITE_RINGS; ++i) {
                double z = (rd[i] - ms_mcml__halfspace_ring(&s, w.edge[i], w.edge[i + 1])) / se[i];
                /* at least 150 photons' worth, and not so far out that the few short paths there decide: normal
                   enough */
                if (!(se[i] < 0.08 * rd[i]) || ms_mcml__halfspace_outside(&s, w.edge[i]) < 1e-3 * s.total) continue;
                chi2 += z * z;
                ++n;
            }
            p = test_chi2_p(chi2, n);
            CHECK(n > 10);
            if (!(p > 1e-4)) TEST_FAIL("eta %g albedo %g: chi2 %g of %d rings", eta[k], albedo[q], chi2, n);
            if (p < least) least = p;
        }
    }
    TEST_NOTE("18 profiles, least p of chi-square %.3f", least);
}

/* --- profiles of several channels --- */

static void materials_table(void)
{
    /* Jensen, Marschner, Levoy, Hanrahan 2001, figure 5: mu_a and reduced mu_s of R, G, B in 1/mm, and eta */
    static const struct {
        const char *name;
        double mu_a[3], mu_s[3], eta;
    } published[] = {{"apple", {0.0030, 0.0034, 0.046}, {2.29, 2.39, 1.97}, 1.3},
                     {"chicken1", {0.015, 0.077, 0.19}, {0.15, 0.21, 0.38}, 1.3},
                     {"chicken2", {0.018, 0.088, 0.20}, {0.19, 0.25, 0.32}, 1.3},
                     {"cream", {0.0002, 0.0028, 0.0163}, {7.38, 5.47, 3.15}, 1.3},
                     {"ketchup", {0.061, 0.97, 1.45}, {0.18, 0.07, 0.03}, 1.3},
                     {"marble", {0.0021, 0.0041, 0.0071}, {2.19, 2.62, 3.00}, 1.5},
                     {"potato", {0.0024, 0.0090, 0.12}, {0.68, 0.70, 0.55}, 1.3},
                     {"skimmilk", {0.0014, 0.0025, 0.0142}, {0.70, 1.22, 1.90}, 1.3},
                     {"skin1", {0.032, 0.17, 0.48}, {0.74, 0.88, 1.01}, 1.3},
                     {"skin2", {0.013, 0.070, 0.145}, {1.09, 1.59, 1.79}, 1.3},
                     {"wholemilk", {0.0011, 0.0024, 0.014}, {2.55, 3.21, 3.77}, 1.3}};
    int count = 0, i, c;
    const ms_mcml_material *all = ms_mcml_materials(&count), *m;
    ms_mcml_medium medium;
    CHECK_INT(count, 11);
    CHECK(ms_mcml_materials(NULL) == all);
    for (i = 0; i < count; ++i) CHECK(ms_mcml_find_material(all[i].name) == &all[i]);
    for (i = 0; i < 11; ++i)
        for (c = 0; c < 3; ++c) {
            m = ms_mcml_find_material(published[i].name);
            medium = ms_mcml_material_medium(m, c);
            if (m == NULL || medium.mu_a_per_mm != published[i].mu_a[c] || medium.mu_s_per_mm != published[i].mu_s[c] ||
                medium.eta != published[i].eta || medium.g != 0)
                TEST_FAIL("%s, channel %d: %g %g %g", published[i].name, c, medium.mu_a_per_mm, medium.mu_s_per_mm,
                          medium.eta);
        }
    m = ms_mcml_find_material("SkimMilk");
    CHECK(m && strcmp(m->name, "skimmilk") == 0);
    CHECK(ms_mcml_find_material("skin") == NULL && ms_mcml_find_material("skin11") == NULL);
    CHECK(ms_mcml_find_material("") == NULL && ms_mcml_find_material(NULL) == NULL);
}

static int all_media(ms_mcml_medium *media)
{
    int count, i;
    const ms_mcml_material *m = ms_mcml_materials(&count);
    for (i = 0; i < 3 * count; ++i) media[i] = ms_mcml_material_medium(&m[i / 3], i % 3);
    return 3 * count;
}

/* Checks that hold for any profile of the solver. */
static void check_profile(const ms_mcml_profile *p, double left)
{
    int c, i;
    for (c = 0; c < p->channels; ++c) {
        const double *rd = p->rd_per_mm2 + (size_t)c * (size_t)p->rings;
        const double *within = p->within + (size_t)c * (size_t)(p->rings + 1);
        double energy = within[0];
        for (i = 0; i < p->rings; ++i) {
            double r0 = p->edge_mm[i], r1 = p->edge_mm[i + 1];
            CHECK(rd[i] >= 0 && (i == 0 || rd[i] <= rd[i - 1]));
            energy += rd[i] * PI * (r1 - r0) * (r1 + r0);
            CHECK_NEAR(energy, within[i + 1], 1e-9);
        }
        CHECK(within[p->rings] <= p->total[c]);
        CHECK(p->total[c] - within[p->rings] <= left * p->total[c]);
        CHECK(p->total_error[c] <= 0);
    }
}

static void profile_of_all_channels_at_once(void)
{
    ms_mcml_medium media[33];
    ms_mcml_profile p, q;
    ms_mcml_profile_options o;
    int n = all_media(media), threads, i;
    memset(&o, 0, sizeof o);
    CHECK_INT(ms_mcml_profile_make(&p, media, n, NULL, NULL), MS_OK);
    check_profile(&p, 1e-5 * (1 + 1e-6));
    for (i = 0; i < n; ++i) CHECK_NEAR(p.total[i], solve(media[i]).total, 0);
    for (threads = 1; threads <= 7; threads += 3) {
        test_pool pool;
        o.parallel = test_parallel(&pool, threads);
        CHECK_INT(ms_mcml_profile_make(&q, media, n, &o, NULL), MS_OK);
        CHECK_INT(p.rings, q.rings);
        CHECK(memcmp(p.rd_per_mm2, q.rd_per_mm2, (size_t)(n * p.rings) * sizeof(double)) == 0);
        CHECK(memcmp(p.within, q.within, (size_t)(n * (p.rings + 1)) * sizeof(double)) == 0);
        CHECK(memcmp(p.total, q.total, (size_t)n * sizeof(double)) == 0);
        ms_mcml_profile_destroy(&q);
    }
    TEST_NOTE("%d rings", p.rings);
    ms_mcml_profile_destroy(&p);
    CHECK(p.memory == NULL);
    ms_mcml_profile_destroy(&p);
    ms_mcml_profile_destroy(NULL);
}

/* Rings that nobody gave: a twentieth of the shortest mean free path up to it, then 4% wider each, out to where every
   channel has 1e-5 of its energy left, and not much further. */
static void rings_of_ones_own(void)
{
    ms_mcml_medium media[2];
    ms_mcml_profile p;
    double most = 0, before = 0;
    int i, c;
    media[0] = medium_of(0.9, 1.3);
    media[1] = medium_of(0.99, 1.3);
    media[1].mu_a_per_mm *= 0.5;
    media[1].mu_s_per_mm *= 0.5;
    CHECK_INT(ms_mcml_profile_make(&p, media, 2, NULL, NULL), MS_OK);
    for (i = 0; i <= p.rings; ++i)
        CHECK_NEAR(p.edge_mm[i], i <= 20 ? 0.05 * i : pow(1.04, i - 20), 1e-9 * p.edge_mm[i]);
    for (c = 0; c < 2; ++c) {
        most = fmax(most, 1 - p.within[c * (p.rings + 1) + p.rings] / p.total[c]);
        before = fmax(before, 1 - p.within[c * (p.rings + 1) + p.rings - 1] / p.total[c]);
    }
    CHECK(most <= 1e-5 && before > 1e-5);
    ms_mcml_profile_destroy(&p);
    media[0] = medium_of(0, 1.3); /* nothing comes back: one mean free path */
    media[0].mu_a_per_mm = 4;
    CHECK_INT(ms_mcml_profile_make(&p, media, 1, NULL, NULL), MS_OK);
    CHECK_INT(p.rings, 20);
    CHECK_NEAR(p.edge_mm[20], 0.25, 1e-15);
    ms_mcml_profile_destroy(&p);
}

/* Every call on a stack of its own; the memory of a channel. */
static void every_call(void *user)
{
    const ms_mcml_layer layer = {1.4, 1, 20, 0.5, 0.5};
    const ms_mcml_tissue tissue = {1, 1, 1, &layer};
    ms_mcml_options o = ms_mcml_defaults();
    ms_mcml_medium medium;
    ms_mcml_profile profile;
    ms_mcml_result result;
    ms_mcml_grid grid;
    (void)user;
    memset(&grid, 0, sizeof grid);
    grid.dr_cm = grid.dz_cm = 0.1;
    grid.nr = grid.nz = grid.na = 5;
    o.photons = 5000;
    if (ms_mcml_simulate(&tissue, &grid, &o, &result, NULL) == MS_OK) ms_mcml_result_destroy(&result);
    if (ms_mcml_medium_from_color(0.7, 1, MS_MCML_BURLEY_D, 1.4, &medium, NULL) == MS_OK &&
        ms_mcml_profile_make(&profile, &medium, 1, NULL, NULL) == MS_OK)
        ms_mcml_profile_destroy(&profile);
}

static void stack_and_memory(void)
{
    size_t used;
    if (TEST_STACK_LIMIT == 0) return;
    used = test_stack(every_call, NULL);
    CHECK(used > 1000);
    CHECK_LE(used, TEST_STACK_LIMIT);
    CHECK_NEAR(sizeof(ms_mcml__channel), 0.3e6, 0.05e6); /* as stated, 0.3 MB */
    TEST_NOTE("%d bytes of stack", (int)used);
}

static void profile_rings_of_all_kinds(void)
{
    static const double wild[] = {0, 1e-12, 1e-9, 1e-6, 1.000001e-6, 1e-3, 1, 1.0000000001, 2, 100, 1e4, 1e6, 1e30};
    ms_mcml_medium media[3];
    ms_mcml_profile p;
    ms_mcml_profile_options o;
    double hole;
    int i;
    for (i = 0; i < 3; ++i) media[i] = ms_mcml_material_medium(ms_mcml_find_material("cream"), i);
    memset(&o, 0, sizeof o);
    o.edge_mm = wild;
    o.rings = 12;
    CHECK_INT(ms_mcml_profile_make(&p, media, 3, &o, NULL), MS_OK);
    check_profile(&p, 1e-12);
    hole = p.within[3];
    ms_mcml_profile_destroy(&p);
    o.edge_mm = wild + 3; /* a hole in the middle */
    o.rings = 9;
    CHECK_INT(ms_mcml_profile_make(&p, media, 3, &o, NULL), MS_OK);
    check_profile(&p, 1e-12);
    CHECK_NEAR(p.within[0], hole, 1e-15);
    ms_mcml_profile_destroy(&p);
    { /* the shortest lengths: a finite mean, within what single scattering's 1 / r says */
        static const double least[] = {0, 1e-100, 3e-100, 1};
        o.edge_mm = least;
        o.rings = 3;
        CHECK_INT(ms_mcml_profile_make(&p, media, 3, &o, NULL), MS_OK);
        check_profile(&p, 1);
        for (i = 0; i < 3; ++i) CHECK_NEAR(p.rd_per_mm2[3 * i] / p.rd_per_mm2[3 * i + 1], 4, 1e-6);
        ms_mcml_profile_destroy(&p);
    }
    o.edge_mm = NULL;
    o.rings = 60000; /* huge, uniform */
    o.ring_mm = 0.001;
    CHECK_INT(ms_mcml_profile_make(&p, media, 1, &o, NULL), MS_OK);
    check_profile(&p, 0.1);
    ms_mcml_profile_destroy(&p);
    media[0] = medium_of(0, 1.3);
    media[1] = medium_of(1, 1.3);
    CHECK_INT(ms_mcml_profile_make(&p, media, 2, NULL, NULL), MS_OK);
    check_profile(&p, 1e-5 * (1 + 1e-6));
    ms_mcml_profile_destroy(&p);
}

static void profile_by_direct_monte_carlo(void)
{
    ms_mcml_medium media[3];
    ms_mcml_profile p, d;
    ms_mcml_profile_options o;
    ms_mcml_options direct = ms_mcml_defaults();
    int c, i;
    for (i = 0; i < 3; ++i) media[i] = ms_mcml_material_medium(ms_mcml_find_material("ketchup"), i);
    memset(&o, 0, sizeof o);
    o.rings =
        3931; /* section 5.9's for ketchup: a twentieth of the shortest mean free path, out to 32 of the longest */
    o.ring_mm = 1e300;
    for (i = 0; i < 3; ++i) o.ring_mm = fmin(o.ring_mm, 0.05 / (media[i].mu_a_per_mm + media[i].mu_s_per_mm));
    direct.photons = scaled(500000);
    direct.seed = test_seed + 2;
    CHECK_INT(photon_profile(&p, media, 3, o.rings, o.ring_mm, &direct, NULL), MS_OK);
    CHECK_INT(ms_mcml_profile_make(&d, media, 3, &o, NULL), MS_OK);
    for (c = 0; c < 3; ++c) {
        double chi2 = 0;
        int n = 0;
        CHECK_NEAR(p.total[c], d.total[c], 4.5 * p.total_error[c]);
        for (i = c * p.rings; i < (c + 1) * p.rings; ++i) {
            double z = (p.rd_per_mm2[i] - d.rd_per_mm2[i]) / p.rd_error_per_mm2[i];
            if (!(p.rd_error_per_mm2[i] < 0.08 * p.rd_per_mm2[i])) continue;
            chi2 += z * z;
            ++n;
        }
        CHECK(test_chi2_p(chi2, n) > 1e-4);
        TEST_NOTE("chi2 %.1f of %d", chi2, n);
    }
    ms_mcml_profile_destroy(&p);
    ms_mcml_profile_destroy(&d);
    media[0].mu_a_per_mm = 0; /* paths without a mean length */
    media[0].g = 0.5;
    direct.photons = 20000;
    CHECK_INT(photon_profile(&p, media, 1, 100, 0.1, &direct, NULL), MS_OK);
    CHECK_NEAR(p.total[0], 1 - solve(media[0]).specular, 4.5 * p.total_error[0]);
    ms_mcml_profile_destroy(&p);
}

/* Media of g != 0, by similarity: the stated errors bound the totals of random media by discrete ordinates, and rings
   by photons. At g = 0 they are 0. */
static void similarity(void)
{
    uint64_t state = test_seed + 31;
    double worst = 0, worst_ring = 0;
    int k, i;
    TEST_METHOD;
    for (k = 0; k < (test_full ? 400 : 60); ++k) {
        const double g = k % 4 ? 0.95 * test_uniform(&state) : -0.6 * test_uniform(&state);
        const double u = test_uniform(&state), albedo = k % 2 ? u : 1 - pow(10, -4 * u), eta = 1 + test_uniform(&state);
        ms_mcml_medium m;
        ms_mcml_profile p;
        double off;
        m.mu_a_per_mm = 1 - albedo;
        m.mu_s_per_mm = albedo / (1 - g);
        m.g = g;
        m.eta = eta;
        CHECK_INT(ms_mcml_profile_make(&p, &m, 1, NULL, NULL), MS_OK);
        CHECK_NEAR(p.total[0], solve(medium_of(albedo, eta)).total, 1e-12);
        off = fabs(reflectance_of(&m) - p.total[0]) / p.total_error[0];
        if (!(off <= 1))
            TEST_FAIL("g %g, albedo %g, eta %g: total off by %.2f of the stated error", g, albedo, eta, off);
        worst = fmax(worst, off);
        if (k % 10 == 0) {
            static const int edge[] = {0, 1, 2, 4, 8, 16, 32, 64, 120};
            ms_mcml_options direct = ms_mcml_defaults();
            ms_mcml_profile_options o;
            ms_mcml_profile d, q;
            memset(&o, 0, sizeof o);
            o.rings = 120;
            o.ring_mm = 0.05;
            direct.photons = scaled(100000);
            CHECK_INT(photon_profile(&d, &m, 1, o.rings, o.ring_mm, &direct, NULL), MS_OK);
            CHECK_INT(ms_mcml_profile_make(&q, &m, 1, &o, NULL), MS_OK);
            for (i = 0; i < 8; ++i) {
                double a = 0, b = 0, stated = 0, noise = 0;
                int r;
                for (r = edge[i]; r < edge[i + 1]; ++r) {
                    const double area = PI * 0.0025 * (2 * r + 1), e = area * d.rd_error_per_mm2[r];
                    a += area * d.rd_per_mm2[r];
                    b += area * q.rd_per_mm2[r];
                    stated += area * q.rd_error_per_mm2[r];
                    noise += e * e;
                }
                if (!(a > 1e-3 * d.total[0])) continue;
                if (!(fabs(a - b) <= stated + 4 * sqrt(noise)))
                    TEST_FAIL("g %g, albedo %g, eta %g, ring %d: %g, photons %g, stated %g", g, albedo, eta, i, b, a,
                              stated);
                worst_ring = fmax(worst_ring, (fabs(a - b) - 2 * sqrt(noise)) / stated);
            }
            ms_mcml_profile_destroy(&d);
            ms_mcml_profile_destroy(&q);
        }
        ms_mcml_profile_destroy(&p);
    }
    TEST_NOTE("totals off by at most %.2f, rings by %.2f of what is stated", worst, worst_ring);
}

/* total is of the light that arrives; of the light that enters it is the color that was asked for. */
static void totals_and_colors(void)
{
    ms_mcml_medium m;
    ms_mcml_profile p;
    CHECK_INT(ms_mcml_medium_from_color(0.92, 1, MS_MCML_MEAN_FREE_PATH, 1.4, &m, NULL), MS_OK);
    CHECK_INT(ms_mcml_profile_make(&p, &m, 1, NULL, NULL), MS_OK);
    CHECK_NEAR(p.entering[0], 1 - 0.4 * 0.4 / (2.4 * 2.4), 1e-15);
    CHECK_NEAR(p.total[0] / p.entering[0], 0.92, 1e-7);
    ms_mcml_profile_destroy(&p);
}

/* --- what is refused --- */

static void bad_arguments(void)
{
    ms_mcml_profile p;
    ms_mcml_profile_options o;
    ms_mcml_medium good = medium_of(0.9, 1.3), m;
    ms_error error;
    double edges[] = {0, 1, 1, 2}, nan_value = strtod("nan", NULL);
    static const double wrong[][4] = {{-1, 1, 0, 1.3}, {1, -1, 0, 1.3}, {0, 0, 0, 1.3},
                                      {1, 1, 1, 1.3},  {1, 1, -1, 1.3}, {1, 1, 0, 0},
                                      {1, 1, 0, 11},   {1, 1, 0, -1.3}, {1e200, 1e200, 0, 1.3}};
    static const char *const says[] = {"mu_a", "mu_s", "mu_a", "g is", "g is", "eta", "eta", "eta", "mu_a"};
    unsigned i;
    for (i = 0; i < sizeof wrong / sizeof wrong[0]; ++i) {
        m.mu_a_per_mm = wrong[i][0];
        m.mu_s_per_mm = wrong[i][1];
        m.g = wrong[i][2];
        m.eta = wrong[i][3];
        CHECK_INT(ms_mcml_profile_make(&p, &m, 1, NULL, &error), MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, says[i]) != NULL && p.memory == NULL);
    }
    for (i = 0; i < 4; ++i) {
        m = good;
        if (i == 0) m.mu_a_per_mm = nan_value;
        if (i == 1) m.mu_s_per_mm = nan_value;
        if (i == 2) m.g = nan_value;
        if (i == 3) m.eta = nan_value;
        CHECK_INT(ms_mcml_profile_make(&p, &m, 1, NULL, &error), MS_INVALID_ARGUMENT);
        CHECK(strstr(error.message, "nan") != NULL);
    }
    memset(&o, 0, sizeof o);
    o.depth_step = 0.01;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "depth_step") != NULL);
    o.depth_step = 0.5;
    o.frequency_step = nan_value;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "frequency_step") != NULL);

    memset(&o, 0, sizeof o);
    o.edge_mm = edges;
    o.rings = 3;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "edge") != NULL && error.position == 2);
    edges[2] = nan_value;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    o.rings = 0;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "rings") != NULL);
    o.edge_mm = NULL;
    o.rings = 10;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT); /* ring_mm 0 */
    CHECK(strstr(error.message, "ring_mm") != NULL);
    o.ring_mm = 0.99e-100; /* its square would be 0 */
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    edges[0] = 0;
    edges[1] = 0.99e-100;
    edges[2] = 1;
    o.edge_mm = edges;
    o.rings = 2;
    CHECK_INT(ms_mcml_profile_make(&p, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "1e-100") != NULL && error.position == 1);
    memset(&o, 0, sizeof o);
    CHECK_INT(ms_mcml_profile_make(&p, &good, 0, &o, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_profile_make(NULL, &good, 1, &o, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_profile_make(&p, NULL, 1, &o, &error), MS_INVALID_ARGUMENT);
}

static void memory_runs_out(void)
{
    ms_mcml_medium media[2];
    media[0] = media[1] = medium_of(0.5, 1.3);
    TEST_ALLOCATION_SWEEP(10, {
        ms_mcml_profile p;
        ms_mcml_profile_options o;
        memset(&o, 0, sizeof o);
        o.allocator = allocator;
        status = ms_mcml_profile_make(&p, media, 2, &o, NULL);
        ms_mcml_profile_destroy(&p);
    });
}

/* The layered solver says the same as this one, whose rings are good to 1e-4. */
static void rings_of_isotropic_half_spaces(void)
{
    static const double albedo[] = {0.5, 0.9, 0.99, 0.999}, index[] = {1, 1.3, 1.5};
    double worst = 0;
    int a, n, i;
    for (a = 0; a < 4; ++a)
        for (n = 0; n < 3; ++n) {
            ms_mcml_medium m;
            ms_mcml__halfspace h;
            ms_mcml_layer layer;
            ms_mcml_tissue t;
            ms_mcml_layered s;
            double r = 0, next;
            memset(&s, 0, sizeof s);
            m.mu_a_per_mm = 1 - albedo[a];
            m.mu_s_per_mm = albedo[a];
            m.g = 0;
            m.eta = index[n];
            h = solve(m);
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
                const double want = ms_mcml__halfspace_ring(&h, r, next = r > 0 ? r * 1.3 : 0.01);
                double error, got = 0.01 * ms_mcml_layered_ring(&s, 0, 0.1 * r, 0.1 * next, &error);
                if (want * 3.14159265 * (next * next - r * r) < 1e-5 * h.total) continue;
                if (want * 3.14159265 * (next * next - r * r) > 1e-3 * h.total)
                    CHECK_NEAR(got / want, 1, next < 1 ? 0.01 : 0.005); /* good to that */
                CHECK(fabs(got - want) <= 0.01 * error + 1e-4 * want);  /* stated, and that of the other solver */
                if (next >= 1 && want * 3.14159265 * (next * next - r * r) > 1e-3 * h.total &&
                    fabs(got / want - 1) > worst)
                    worst = fabs(got / want - 1);
            }
            for (i = 0; i < 6; ++i) {
                const double x = 0.1 * pow(2, i);
                CHECK_NEAR(ms_mcml_layered_outside(&s, 0, 0.1 * x), ms_mcml__halfspace_outside(&h, x), 1e-3 * h.total);
            }
        }
    TEST_NOTE("12 half-spaces, worst ring beyond a mean free path %.1e", worst);
}

static const test_case cases[] = {
    {"materials_table", materials_table},
    {"totals_of_the_reference_data", totals_of_the_reference_data},
    {"totals_of_every_index_and_albedo", totals_of_every_index_and_albedo},
    {"slow_decay", slow_decay},
    {"random_media", random_media},
    {"totals_at_the_edges", totals_at_the_edges},
    {"profiles_of_the_exact_tables", profiles_of_the_exact_tables},
    {"profile_of_original_mcml", profile_of_original_mcml},
    {"profiles_settle", profiles_settle},
    {"tail_is_the_one_of_transport_theory", tail_is_the_one_of_transport_theory},
    {"bessel_k1", bessel_k1},
    {"rings_of_isotropic_half_spaces", rings_of_isotropic_half_spaces},
    {"rings_and_spectrum_agree", rings_and_spectrum_agree},
    {"narrow_and_wide_rings", narrow_and_wide_rings},
    {"reflectance_without_a_profile", reflectance_without_a_profile},
    {"medium_from_a_color", medium_from_a_color},
    {"random_colors", random_colors},
    {"colors_refused", colors_refused},
    {"kernel_functions", kernel_functions},
    {"states_of_photons", states_of_photons},
    {"kernel_reflects", kernel_reflects},
    {"walks_agree_with_the_solver", walks_agree_with_the_solver},
    {"profile_of_all_channels_at_once", profile_of_all_channels_at_once},
    {"rings_of_ones_own", rings_of_ones_own},
    {"stack_and_memory", stack_and_memory},
    {"profile_rings_of_all_kinds", profile_rings_of_all_kinds},
    {"profile_by_direct_monte_carlo", profile_by_direct_monte_carlo},
    {"similarity", similarity},
    {"totals_and_colors", totals_and_colors},
    {"bad_arguments", bad_arguments},
    {"memory_runs_out", memory_runs_out},
};

TEST_MAIN(cases)
