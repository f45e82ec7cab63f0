/* ms_mcml.h, the direct layered Monte Carlo: totals and profiles against exact and published values, energy,
   absorption, exact merging, hostile input. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "mcml_inside.h"

#include "json.h"
#include "tally.h"
#include "test.h"

/* Of ring i of those dr wide. */
static double ring_area(int i, double dr) { return 6.283185307179586 * (i + 0.5) * dr * dr; }

static ms_mcml_layer layer(double n, double mu_a, double mu_s, double g, double d)
{
    ms_mcml_layer l;
    l.n = n;
    l.mu_a_per_cm = mu_a;
    l.mu_s_per_cm = mu_s;
    l.g = g;
    l.thickness_cm = d;
    return l;
}

static ms_mcml_tissue tissue_of(const ms_mcml_layer *layers, int count, double above, double below)
{
    ms_mcml_tissue t;
    t.n_above = above;
    t.n_below = below;
    t.layer_count = count;
    t.layers = layers;
    return t;
}

static ms_mcml_grid grid_of(double dr, int nr, double dz, int nz, int na)
{
    ms_mcml_grid g;
    memset(&g, 0, sizeof g);
    g.dr_cm = dr;
    g.dz_cm = dz;
    g.nr = nr;
    g.nz = nz;
    g.na = na;
    return g;
}

static ms_mcml_options options_of(double photons)
{
    ms_mcml_options o = ms_mcml_defaults();
    o.photons = (uint64_t)photons;
    o.seed = test_seed;
    return o;
}

/* Runs, and fails the case on any status. */
static ms_mcml_result run(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_mcml_options *options)
{
    ms_mcml_result r;
    ms_error error;
    memset(&r, 0, sizeof r);
    if (ms_mcml_simulate(tissue, grid, options, &r, &error) != MS_OK) TEST_FAIL("%s", error.message);
    return r;
}

/* --- against exact and published values --- */

/* Every total of the reference file within 4 standard errors: one chance in 16000 each. */
static void totals(void)
{
    TEST_METHOD;
    json *all = json_load("tests/data/mcml_totals.json"), *cases = json_get(all, "cases");
    double worst = 0, largest = 0;
    int i, k;
    for (i = 0; i < cases->count; ++i) {
        json *c = &cases->child[i], *list = json_find(c, "layers_n_mua_mus_g_d");
        ms_mcml_layer layers[8];
        ms_mcml_tissue tissue = tissue_of(layers, 1, 1, 1);
        ms_mcml_grid grid = grid_of(0.01, 100, 0.01, 10, 1);
        ms_mcml_options options = options_of(test_full ? 4e6 : 1e5);
        ms_mcml_result r;
        double d, scale;
        if (list) {
            tissue.layer_count = list->count;
            for (k = 0; k < list->count; ++k) {
                int n;
                double *v = json_numbers(&list->child[k], &n);
                layers[k] = layer(v[0], v[1], v[2], v[3], v[4]);
                free(v);
            }
            tissue.n_above = json_number(json_get(c, "n_above"));
            tissue.n_below = json_number(json_get(c, "n_below"));
        } else {
            layers[0] = layer(json_number(json_get(c, "n")), json_number(json_get(c, "mua_per_cm")),
                              json_number(json_get(c, "mus_per_cm")), json_number(json_get(c, "g")), 1e7);
        }
        scale = layers[0].mu_s_per_cm > 0 ? layers[0].mu_a_per_cm / layers[0].mu_s_per_cm : 1;
        if (scale > 0.1) options.photons *= scale > 10 ? 16 : 4; /* short paths: more photons in the same time */
        r = run(&tissue, &grid, &options);
        CHECK_NEAR(r.specular, json_number(json_get(c, "Rsp")), 1e-12);
        d = (r.rd - json_number(json_get(c, "Rd"))) / (r.rd_error + json_number(json_get(c, "Rd_se")));
        if (!(fabs(d) <= 4)) TEST_FAIL("%s: Rd %.7f +- %.7f, %+.1f errors", c->key, r.rd, r.rd_error, d);
        worst = fmax(worst, fabs(d));
        largest = fmax(largest, r.rd_error / r.rd);
        if (json_find(c, "Tt") && json_number(json_get(c, "Tt")) > 0) {
            d = (r.tt - json_number(json_get(c, "Tt"))) / (r.tt_error + 3e-6);
            if (!(fabs(d) <= 4)) TEST_FAIL("%s: Tt %.7f +- %.7f, %+.1f errors", c->key, r.tt, r.tt_error, d);
            worst = fmax(worst, fabs(d));
        }
        ms_mcml_result_destroy(&r);
    }
    CHECK_LE(largest, 0.01); /* or the comparison says little */
    TEST_NOTE("%d media, worst %.1f standard errors, errors up to %.2f%%", cases->count, worst, 100 * largest);
    json_free(all);
}

/* van de Hulst 1980 for the slab, Giovanelli 1955 for the half-space: his 0.2600 includes the specular 0.04. */
static void published(void)
{
    ms_mcml_layer slab = layer(1, 10, 90, 0.75, 0.02), half = layer(1.5, 10, 90, 0, 1e7);
    ms_mcml_tissue t = tissue_of(&slab, 1, 1, 1);
    ms_mcml_grid grid = grid_of(0.001, 200, 0.001, 20, 30);
    ms_mcml_options o = options_of(test_full ? 2e7 : 2e6);
    ms_mcml_result r;
    TEST_METHOD;
    r = run(&t, &grid, &o);
    CHECK_NEAR(r.rd, 0.09739, 4 * r.rd_error + 5e-6); /* 4 standard errors and half a printed digit */
    CHECK_NEAR(r.tt, 0.66096, 4 * r.tt_error + 5e-6);
    TEST_NOTE("slab Rd %.5f Tt %.5f", r.rd, r.tt);
    ms_mcml_result_destroy(&r);
    t.layers = &half;
    r = run(&t, &grid, &o);
    CHECK_NEAR(r.rd + r.specular, 0.2600, 4 * r.rd_error + 1e-4);
    TEST_NOTE("half-space %.5f with specular", r.rd + r.specular);
    ms_mcml_result_destroy(&r);
}

/* "# key: text" of a profile file. */
static const char *header(const char *text, const char *key)
{
    const char *p = strstr(text, key);
    return p ? p + strlen(key) : NULL;
}

static void one_profile(const char *path, double photons)
{
    char *text = test_read_file(path, NULL);
    const char *p, *line;
    ms_mcml_layer layers[8];
    ms_mcml_tissue tissue = tissue_of(layers, 0, 1, 1);
    ms_mcml_grid grid = grid_of(1, 1, 0.01, 1, 1);
    ms_mcml_options options = options_of(photons);
    ms_mcml_result r;
    double chi2 = 0, v[6];
    int n = 0, i;
    if (text == NULL) {
        TEST_FAIL("cannot read %s", path);
        return;
    }
    p = header(text, "# layers:");
    if (p) {
        for (line = p; (line = strstr(line, " n=")) != NULL; line += 3) {
            ms_mcml_layer *l = &layers[tissue.layer_count++];
            if (sscanf(line, " n=%lf mua=%lf mus=%lf g=%lf d=%lf", &l->n, &l->mu_a_per_cm, &l->mu_s_per_cm, &l->g,
                       &l->thickness_cm) != 5)
                TEST_FAIL("%s: layers", path);
        }
    } else {
        layers[0] = layer(atof(header(text, "# n:")), atof(header(text, "# mua_per_cm:")),
                          atof(header(text, "# mus_per_cm:")), 0, 1e7);
        tissue.layer_count = 1;
    }
    grid.dr_cm = atof(header(text, "# dr_cm:"));
    grid.nr = atoi(header(text, "# nr:"));
    options.no_absorption = 1;
    r = run(&tissue, &grid, &options);
    for (line = strstr(text, "\ni0,"); line && (line = strchr(line + 1, '\n')) != NULL && line[1];) {
        double sum = 0, square = 0, area = 0, scale, error;
        if (sscanf(line + 1, "%lf,%lf,%lf,%lf,%lf,%lf", &v[0], &v[1], &v[2], &v[3], &v[4], &v[5]) != 6) break;
        for (i = (int)v[0]; i < (int)v[1]; ++i) {
            const double a = ring_area(i, grid.dr_cm);
            sum += a * r.rd_r[i];
            square += a * a * r.rd_r_error[i] * r.rd_r_error[i];
            area += a;
        }
        /* rings of fewer than 50 photons are not Gaussian; the choice rests on the reference, not on the result */
        if (v[4] * area * photons < 50 || i > grid.nr - 1) continue;
        scale = v[4] * area;
        error = square + v[5] * v[5] * area * area;
        chi2 += (sum - scale) * (sum - scale) / error;
        ++n;
    }
    CHECK(n > 10);
    /* one case in 10000 by chance; far below 1 as well, or the errors would be too large */
    if (!(test_chi2_p(chi2, n) > 1e-4 && test_chi2_p(chi2, n) < 1 - 1e-4))
        TEST_FAIL("%s: chi2 %.1f for %d rings", path, chi2, n);
    p = strrchr(path, '/') + 1;
    TEST_NOTE("%.*s %.2f", (int)strcspn(p, "."), p, chi2 / n);
    ms_mcml_result_destroy(&r);
    free(text);
}

static void profiles(void)
{
    static const char *const names[] = {"exact_giovanelli",  "exact_ketchup_R",    "exact_marble_G",   "exact_skin1_G",
                                        "exact_skin1_R",     "mcml_fluence_n1.37", "mcml_g_0.95",      "mcml_glass_top",
                                        "mcml_sample3layer", "mcml_skin1_R",       "mcml_vdhulst_slab"};
    size_t i;
    TEST_METHOD;
    TEST_NOTE("chi2 / n:");
    for (i = 0; i < sizeof names / sizeof *names; ++i) {
        char path[128];
        snprintf(path, sizeof path, "tests/data/mcml_profiles/%s.csv", names[i]);
        one_profile(path, test_full ? 3e6 : 2e5);
    }
}

/* --- standard errors --- */

/* The spread of 100 runs is what each of them claims: variances of 100 samples are good to 14%, so 1/2 to 2 is 5
   sigma. */
static void errors_are_honest(void)
{
    enum { RUNS = 100 };
    ms_mcml_layer layers[2];
    ms_mcml_tissue tissue = tissue_of(layers, 2, 1, 1.3);
    ms_mcml_grid grid = grid_of(0.02, 20, 0.02, 10, 4);
    double sum[7] = {0}, square[7] = {0}, claimed[7] = {0}, groups = 0, groups_square = 0;
    static const char *const name[7] = {"Rd", "Rd_r", "Rd_a", "Rd_ra", "Tt", "A", "A_l"};
    int i, k;
    TEST_METHOD;
    layers[0] = layer(1.4, 2, 60, 0.8, 0.05);
    layers[1] = layer(1.3, 5, 20, 0, 0.1);
    for (i = 0; i < RUNS; ++i) {
        ms_mcml_options o = options_of(65536);
        ms_mcml_result r;
        double v[7], e[7];
        o.seed = test_seed + 1000 + (uint64_t)i;
        r = run(&tissue, &grid, &o);
        v[0] = r.rd, e[0] = r.rd_error;
        v[1] = r.rd_r[2], e[1] = r.rd_r_error[2];
        v[2] = r.rd_a[1], e[2] = r.rd_a_error[1];
        v[3] = r.rd_ra[5], e[3] = r.rd_ra_error[5];
        v[4] = r.tt, e[4] = r.tt_error;
        v[5] = r.a, e[5] = r.a_error;
        v[6] = r.a_l[1], e[6] = r.a_l_error[1];
        for (k = 0; k < 7; ++k) {
            sum[k] += v[k];
            square[k] += v[k] * v[k];
            claimed[k] += e[k] * e[k] / (double)RUNS;
        }
        groups += r.a_error / (double)RUNS;
        groups_square += r.a_error * r.a_error / (double)RUNS;
        ms_mcml_result_destroy(&r);
    }
    TEST_NOTE("variance found / claimed:");
    for (k = 0; k < 7; ++k) {
        double variance = (square[k] - sum[k] * sum[k] / (double)RUNS) / (double)(RUNS - 1),
               ratio = variance / claimed[k];
        if (!(ratio > 0.5 && ratio < 2)) TEST_FAIL("%s: variance %.3g, claimed %.3g", name[k], variance, claimed[k]);
        TEST_NOTE("%s %.2f", name[k], ratio);
    }
    /* errors by 64 groups are good to 1 / sqrt(2 * 63) = 9%, as stated, known to 7% of that from 100 runs */
    CHECK_NEAR(sqrt(groups_square / (groups * groups) - 1), 0.09, 0.03);
}

static void unknown_errors_are_infinite(void)
{
    ms_mcml_layer l = layer(1.4, 1, 10, 0.5, 1);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    ms_mcml_options o = options_of(1);
    ms_mcml_result r = run(&t, &g, &o);
    CHECK_INT(r.photons, 1);
    CHECK(r.rd_error > 1e300 && r.a_error > 1e300);
    CHECK_NEAR(r.specular + r.rd + r.tt + r.a, 1, 0.5); /* one photon: only roulette can be off */
    ms_mcml_result_destroy(&r);
}

/* --- hard cases --- */

static void survives(const char *name, const ms_mcml_layer *layers, int count, double above, double below,
                     double photons, double tolerance)
{
    ms_mcml_tissue tissue = tissue_of(layers, count, above, below);
    ms_mcml_grid grid = grid_of(0.01, 50, 0.01, 50, 10);
    int level;
    for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
        ms_mcml_options o = options_of(photons);
        ms_mcml_result r;
        double sum;
        size_t i;
        o.simd = (ms_simd)level;
        if (level == MS_SIMD_SCALAR) o.photons = o.photons / 4 + 1;
        r = run(&tissue, &grid, &o);
        sum = r.specular + r.rd + r.tt + r.a;
        if (!(fabs(sum - 1) <= tolerance))
            TEST_FAIL("%s, %s: specular %.5f + Rd %.5f + Tt %.5f + A %.5f = %.5f", name, ms_simd_string((ms_simd)level),
                      r.specular, r.rd, r.tt, r.a, sum);
        for (i = 0; i < (size_t)50 * 50; ++i) CHECK(r.a_rz[i] >= 0 && isfinite(r.a_rz[i]));
        for (i = 0; i < (size_t)50 * 10; ++i) CHECK(r.rd_ra[i] >= 0 && isfinite(r.rd_ra[i]) && isfinite(r.tt_ra[i]));
        ms_mcml_result_destroy(&r);
    }
}

/* Energy adds up to 1 but for roulette, which the tolerance allows for: sqrt(0.1 / photons) and less is usual. */
static void hard_media(void)
{
    ms_mcml_layer l[3];
    TEST_METHOD;
    l[0] = layer(1.3, 1e-4, 9.9999, 0, 1e7);
    survives("albedo 0.99999", l, 1, 1, 1, 3000, 0.05);
    l[0] = layer(1.3, 99, 1, 0, 1e7);
    survives("albedo 0.01", l, 1, 1, 1, 20000, 0.01);
    l[0] = layer(1.4, 0.1, 100, 0.99, 1);
    survives("g 0.99", l, 1, 1, 1, 20000, 0.01);
    l[0] = layer(1.4, 0.1, 100, -0.9, 1);
    survives("g -0.9", l, 1, 1, 1, 20000, 0.01);
    l[0] = layer(1.4, 0.1, 100, 0.999999, 1);
    survives("g nearly 1", l, 1, 1, 1, 20000, 0.01);
    l[0] = layer(1.5, 1, 50, 0.5, 0.1);
    survives("1 | 1.5 | 1.33", l, 1, 1, 1.33, 20000, 0.01);
    l[0] = layer(2.5, 1, 50, 0, 1);
    survives("n 2.5", l, 1, 1, 1, 20000, 0.01);
    l[0] = layer(1, 1, 50, 0, 1);
    survives("less dense than outside", l, 1, 2.5, 2.5, 20000, 0.01);
    l[0] = layer(1.4, 1, 50, 0.9, 1e-6);
    l[1] = layer(1.3, 1, 50, 0.9, 1e-6);
    l[2] = layer(1.4, 1, 50, 0.9, 1e7);
    survives("1e-6 cm layers", l, 3, 1, 1, 20000, 0.01);
    l[0] = layer(1.33, 1, 50, 0, 0.1);
    l[1] = layer(2.5, 0, 0, 0, 0.1); /* light guide */
    l[2] = layer(1.33, 1, 50, 0, 0.1);
    survives("clear layer within", l, 3, 1, 1, 20000, 0.01);
    l[1] = layer(1.01, 0, 0, 0, 1e-6); /* total internal reflection into it from both sides */
    survives("thin gap", l, 3, 1, 1, 20000, 0.01);
    l[2] = layer(1.5, 0, 0, 1, 1e7);
    survives("clear and endless below", l, 3, 1, 1, 20000, 0.01);
    l[0] = layer(1.4, 0, 10, 0, 1);
    survives("mu_a 0", l, 1, 1, 1, 5000, 1e-6);
    l[0] = layer(1.4, 0, 1, 0, 1e7);
    survives("mu_a 0, endless: everything comes back", l, 1, 1, 1, 2000, 0.2);
    l[0] = layer(1.4, 1e9, 1e9, 0.5, 1);
    survives("mean free path of 0.5 nm", l, 1, 1, 1, 20000, 0.02);
    l[0] = layer(1.4, 1e-9, 1e-9, 0.5, 1);
    survives("almost empty", l, 1, 1, 1, 20000, 1e-6);
}

/* Without scattering: the slab's multiple reflections summed in closed form. */
static void absorber_alone(void)
{
    const double n = 1.5, mu = 3, d = 0.2, f = 0.04, e = exp(-mu * d);
    ms_mcml_layer l = layer(n, mu, 0, 0, d);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.02, 10, 5);
    ms_mcml_options o = options_of(1e6);
    ms_mcml_result r = run(&t, &g, &o);
    int i;
    CHECK_NEAR(r.tt, (1 - f) * (1 - f) * e / (1 - f * f * e * e), 4 * r.tt_error);
    CHECK_NEAR(r.rd, (1 - f) * (1 - f) * f * e * e / (1 - f * f * e * e), 4 * r.rd_error);
    CHECK_NEAR(r.rd_unscattered, r.rd, 1e-12);
    CHECK_NEAR(r.tt_unscattered, r.tt, 1e-12);
    for (i = 0; i < 10; ++i) { /* down and up beams; 4.5 standard errors of a count, ten bins */
        const double z0 = 0.02 * i, z1 = z0 + 0.02, down = (1 - f) / (1 - f * f * e * e);
        const double a = down * (exp(-mu * z0) - exp(-mu * z1) + f * e * (exp(-mu * (d - z1)) - exp(-mu * (d - z0))));
        CHECK_NEAR(r.a_z[i] * 0.02, a, 4.5 * sqrt(a / 1e6));
    }
    ms_mcml_result_destroy(&r);
    l.g = 1; /* scatters straight ahead: the same medium */
    l.mu_s_per_cm = 50;
    r = run(&t, &g, &o);
    CHECK_NEAR(r.tt, (1 - f) * (1 - f) * e / (1 - f * f * e * e), 4 * r.tt_error);
    ms_mcml_result_destroy(&r);
}

static void clear_stacks(void)
{
    ms_mcml_layer l[3];
    ms_mcml_tissue t = tissue_of(l, 2, 1, 1.33);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    ms_mcml_options o = options_of(1000);
    ms_mcml_result r;
    double r1 = 0.04, r2 = pow(0.5 / 3.5, 2), r3 = pow((2 - 1.33) / 3.33, 2), s;
    l[0] = layer(1.5, 0, 0, 0, 0.1);
    l[1] = layer(2, 0, 0, 0, 0.1);
    r = run(&t, &g, &o);
    s = r1 + (1 - r1) * (1 - r1) * r2 / (1 - r1 * r2); /* two boundaries, then the third, by summing to and fro */
    s = s + (1 - s) * (1 - s) * r3 / (1 - s * r3);
    CHECK_NEAR(r.specular, s, 1e-15);
    CHECK_NEAR(r.tt, 1 - s, 1e-9);
    CHECK_NEAR(r.tt_unscattered, 1 - s, 1e-9);
    CHECK_NEAR(r.rd + r.a, 0, 0);
    ms_mcml_result_destroy(&r);
    l[1] = layer(1.33, 1, 50, 0.8, 0.5); /* MCML's Rspecular for glass on top, from the reference profile's file */
    r = run(&t, &g, &o);
    CHECK_NEAR(r.specular, 0.04332606037, 1e-11);
    ms_mcml_result_destroy(&r);
}

/* Optical depths of media so thin, or layers so thick, that floats near their ends count them. */
static void hardly_absorbing(void)
{
    static const double mu[4] = {1e-15, 1e-13, 1e-30, 1e-300}, depth[4] = {1e8, 1e13, 1e17, 1e308};
    ms_mcml_layer l[2];
    ms_mcml_tissue t = tissue_of(l, 2, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    ms_mcml_options o = options_of(1e5);
    int i;
    for (i = 0; i < 4; ++i) { /* a standard error below half a photon: none was lost */
        ms_mcml_result r;
        const double kept = exp(-2 * mu[i] * fmin(depth[i], 1e18));
        l[0] = l[1] = layer(1, mu[i], 0, 0, depth[i]);
        r = run(&t, &g, &o);
        CHECK_NEAR(r.tt, kept, 4 * sqrt(kept * (1 - kept) / 1e5) + 5e-6);
        CHECK_NEAR(r.a + r.tt, 1, 1e-9);
        ms_mcml_result_destroy(&r);
    }
    /* g that a float rounds to 1 is 1: 1e5 collisions of each photon, none of which deflects or loses it */
    l[0] = layer(1, 0, 1e9, 1 - 1e-9, 1e-4);
    t.layer_count = 1;
    o = options_of(1000);
    {
        ms_mcml_result r = run(&t, &g, &o);
        CHECK_NEAR(r.tt_unscattered, 1, 1e-12);
        ms_mcml_result_destroy(&r);
    }
}

static void largest_grid(void)
{
    ms_mcml_layer l = layer(1.4, 1, 50, 0.8, 1e7);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(1e-4, 32767, 0.1, 3, 3);
    ms_mcml_options o = options_of(20000);
    ms_mcml_result r = run(&t, &g, &o);
    double sum = 0;
    int i;
    for (i = 0; i < 32767; ++i) sum += r.rd_r[i] * ring_area(i, g.dr_cm);
    CHECK_NEAR(sum, r.rd, 1e-9);
    ms_mcml_result_destroy(&r);
}

/* --- absorption --- */

static void absorption_adds_up(void)
{
    ms_mcml_layer l[2];
    ms_mcml_tissue t = tissue_of(l, 2, 1, 1);
    ms_mcml_grid g = grid_of(0.02, 30, 0.01, 30, 10);
    ms_mcml_options o = options_of(100000);
    ms_mcml_result r;
    double total = 0, rd = 0, tt = 0, first = 0;
    int i, k;
    l[0] = layer(1.4, 2, 60, 0.8, 0.1);
    l[1] = layer(1.4, 4, 20, 0.1, 0.2);
    r = run(&t, &g, &o);
    for (k = 0; k < 30; ++k) {
        double column = 0;
        for (i = 0; i < 30; ++i) column += r.a_rz[i * 30 + k] * ring_area(i, g.dr_cm);
        CHECK_NEAR(column, r.a_z[k], 1e-9 * r.a);
        total += r.a_z[k] * g.dz_cm;
        if (k < 10) first += r.a_z[k] * g.dz_cm;
    }
    CHECK_NEAR(total, r.a, 1e-6); /* rounding to 2^-30 of every deposit, and of every layer's */
    CHECK_NEAR(first, r.a_l[0],
               1e-4); /* z at a layer's boundary is rounded to a float: a cell's edge is blurred by 1e-7 */
    CHECK_NEAR(r.a_l[0] + r.a_l[1], r.a, 1e-12);
    for (i = 0; i < 30; ++i) {
        double row = 0, back = 0;
        for (k = 0; k < 10; ++k) {
            const double angle = (k + 0.5) * 0.15707963267948966, cosine = cos(angle);
            const double solid = 12.566370614359172 * sin(angle) * sin(0.15707963267948966 / 2);
            row += r.rd_ra[i * 10 + k] * solid * cosine;
            back += r.tt_ra[i * 10 + k] * solid * cosine;
        }
        CHECK_NEAR(row, r.rd_r[i], 1e-9 * r.rd_r[0]);
        CHECK_NEAR(back, r.tt_r[i], 1e-9 * r.rd_r[0]);
        rd += r.rd_r[i] * ring_area(i, g.dr_cm);
        tt += r.tt_r[i] * ring_area(i, g.dr_cm);
    }
    CHECK_NEAR(rd, r.rd, 1e-12);
    CHECK_NEAR(tt, r.tt, 1e-12);
    ms_mcml_result_destroy(&r);
}

/* Without absorption, and before a photon's 4096th event, each leaves with its weight of 1: whole units in the sums, and in
   those of the squares. */
static void whole_photons(void)
{
    const ms_mcml_layer l = layer(1.4, 0, 20, 0.3, 0.1);
    const ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    const ms_mcml_grid g = grid_of(0.05, 4, 0.05, 3, 3);
    int level, i;
    for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
        ms_mcml_options o = options_of(0);
        int64_t sum = 0, square = 0;
        const int64_t *of;
        ms_mcml *m;
        ms_error e;
        o.simd = (ms_simd)level;
        CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_OK);
        CHECK_INT(ms_mcml_run(m, 0, 5000, &e), MS_OK);
        of = inside_sums(m, 0);
        for (i = 0; i < 2 * 4 * 3; ++i) sum += of[2 * i], square += of[2 * i + 1];
        CHECK_INT(sum, (int64_t)5000 << 30);
        CHECK_INT(square, (int64_t)5000 << 30);
        ms_mcml_destroy(m);
    }
}

/* --- exact merging --- */

static ms_mcml_layer two_layers[2];

static ms_mcml *tally_of(const ms_mcml_options *options, uint64_t first, uint64_t count)
{
    ms_mcml_tissue t = tissue_of(two_layers, 2, 1, 1);
    ms_mcml_grid g = grid_of(0.02, 20, 0.02, 20, 5);
    ms_mcml *m = NULL;
    ms_error e;
    two_layers[0] = layer(1.4, 1, 60, 0.8, 0.05);
    two_layers[1] = layer(1.5, 2, 20, -0.3, 0.4);
    if (ms_mcml_create(&t, &g, options, &m, &e) != MS_OK || ms_mcml_run(m, first, count, &e) != MS_OK)
        TEST_FAIL("%s", e.message);
    return m;
}

/* The run of tally_of. */
static tally_run two_layer_run(uint64_t seed)
{
    static ms_mcml_tissue tissue;
    static ms_mcml_grid grid;
    tally_run run;
    tissue = tissue_of(two_layers, 2, 1, 1);
    grid = grid_of(0.02, 20, 0.02, 20, 5);
    run.tissue = &tissue;
    run.grid = &grid;
    run.seed = seed;
    return run;
}

static int same_bits(const ms_mcml *a, const ms_mcml *b)
{
    size_t count_a, count_b;
    const int64_t *x = ms_mcml_sums(a, &count_a), *y = ms_mcml_sums(b, &count_b);
    return ms_mcml_photons(a) == ms_mcml_photons(b) && count_a == count_b && memcmp(x, y, count_a * sizeof *x) == 0;
}

static void splits_and_threads(void)
{
    static const uint64_t cuts[] = {0, 1, 2, 63, 777, 1024, 30001, 65535, 65537, 100000};
    const int best = test_simd_best();
    int level, threads, i;
    for (level = MS_SIMD_SCALAR; level <= best; ++level) {
        ms_mcml_options o = options_of(0);
        ms_mcml *whole, *sum;
        ms_error e;
        o.simd = (ms_simd)level;
        whole = tally_of(&o, 0, 100000);
        CHECK_INT(ms_mcml_photons(whole), 100000);
        sum = tally_of(&o, 0, 0);
        for (i = 8; i >= 0; --i) { /* backwards, by way of bytes */
            ms_mcml *part = tally_of(&o, cuts[i], cuts[i + 1] - cuts[i]), *again = tally_of(&o, 0, 0);
            const tally_run run_of = two_layer_run(o.seed);
            size_t size;
            unsigned char *bytes = tally_pack(part, &run_of, cuts[i], &size);
            uint64_t first = 7;
            CHECK_INT(tally_add(again, &run_of, bytes, size, NULL, &e), MS_OK);
            CHECK(same_bits(part, again));
            CHECK_INT(tally_add(sum, &run_of, bytes, size, &first, &e), MS_OK);
            CHECK_INT(first, cuts[i]);
            free(bytes);
            ms_mcml_destroy(part);
            ms_mcml_destroy(again);
        }
        CHECK(same_bits(whole, sum));
        ms_mcml_destroy(sum);
        for (threads = 1; threads <= 7; threads += threads == 1 ? 1 : 5) {
            test_pool pool;
            o.parallel = test_parallel(&pool, threads);
            sum = tally_of(&o, 0, 100000);
            CHECK(same_bits(whole, sum));
            ms_mcml_destroy(sum);
        }
        ms_mcml_destroy(whole);
    }
    TEST_NOTE("levels scalar to %s, threads 1, 2, 7, nine parts", ms_simd_string((ms_simd)best));
}

static void levels_agree(void)
{
    double worst = 0;
    int level;
    ms_mcml_layer l[3];
    ms_mcml_tissue t = tissue_of(l, 3, 1, 1);
    ms_mcml_grid g = grid_of(0.01, 50, 0.01, 40, 10);
    ms_mcml_options o = options_of(test_full ? 1e6 : 1e5);
    ms_mcml_result a, b;
    l[0] = layer(1.37, 1, 100, 0.9, 0.1);
    l[1] = layer(1.5, 1, 10, 0, 0.1);
    l[2] = layer(1.2, 2, 10, 0.7, 0.2);
    o.simd = MS_SIMD_SCALAR;
    a = run(&t, &g, &o);
    for (level = MS_SIMD_BASE; level <= test_simd_best(); ++level) {
        o.simd = (ms_simd)level;
        b = run(&t, &g, &o);
        /* the same photons, rounded differently: far closer than independent runs, which differ by 1.4 errors */
        CHECK_NEAR(b.rd, a.rd, 0.3 * a.rd_error);
        CHECK_NEAR(b.tt, a.tt, 0.3 * a.tt_error);
        worst = fmax(worst, fabs(b.rd - a.rd) / a.rd_error);
        ms_mcml_result_destroy(&b);
    }
    TEST_NOTE("Rd differs by %.3f standard errors at most", worst);
    ms_mcml_result_destroy(&a);
}

/* Sums that no run has, one by one: another count, below 0, above what two tallies may add up to, too many photons. */
static void add_refuses(void)
{
    ms_mcml_options o = options_of(0);
    ms_mcml *a = tally_of(&o, 0, 10), *b = tally_of(&o, 0, 10);
    size_t count, i;
    const int64_t *of_a = ms_mcml_sums(a, &count);
    int64_t *sums = (int64_t *)malloc((count + 1) * sizeof *sums);
    const size_t first_group = 4 * 20 * 5 + 2; /* after [2][nr][na][2] and [2] sums: photons by their group */
    ms_error e;
    memcpy(sums, of_a, count * sizeof *sums);
    sums[count] = 0;
    CHECK_INT(ms_mcml_add(a, sums, count - 1, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_add(a, sums, count + 1, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_add(a, NULL, count, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_add(NULL, sums, count, &e), MS_INVALID_ARGUMENT);
    for (i = 0; i < count; i += i + 97 < count || i + 1 == count ? 97 : count - 1 - i) {
        const int64_t value = sums[i];
        sums[i] = -1;
        CHECK_INT(ms_mcml_add(a, sums, count, &e), MS_INVALID_ARGUMENT);
        CHECK_INT(e.position, i);
        sums[i] = ((int64_t)1 << 62) - of_a[i] + 1; /* one more than fits */
        CHECK_INT(ms_mcml_add(a, sums, count, &e), MS_INVALID_ARGUMENT);
        sums[i] = value;
    }
    sums[first_group] = ((int64_t)1 << 32) - 9; /* one photon too many */
    CHECK_INT(ms_mcml_add(a, sums, count, &e), MS_INVALID_ARGUMENT);
    CHECK(strstr(e.message, "2^32") != NULL);
    for (i = 0; i < 64; ++i) sums[first_group + i] = (int64_t)1 << 61; /* they would wrap to 0 in 64 bits */
    CHECK_INT(ms_mcml_add(a, sums, count, &e), MS_INVALID_ARGUMENT);
    CHECK(same_bits(a, b)); /* untouched by all of these */
    memcpy(sums, of_a, count * sizeof *sums);
    sums[first_group] = ((int64_t)1 << 32) - 10;
    sums[0] = ((int64_t)1 << 62) - of_a[0];
    CHECK_INT(ms_mcml_add(a, sums, count, &e), MS_OK); /* and these just fit */
    CHECK(ms_mcml_photons(a) == (uint64_t)1 << 32);
    CHECK_INT(ms_mcml_run(a, 10, 1, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_run(b, 10, (uint64_t)1 << 32, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_run(b, UINT64_MAX, 10, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_run(b, UINT64_MAX, 1, &e), MS_INVALID_ARGUMENT); /* its last photon is 2^64 - 1 */
    CHECK(strstr(e.message, "2^64 or more") != NULL);
    CHECK_INT(ms_mcml_photons(b), 10);
    of_a = ms_mcml_sums(b, &count);
    CHECK_INT(ms_mcml_add(b, of_a, count, &e), MS_OK); /* its own */
    CHECK_INT(ms_mcml_photons(b), 20);
    CHECK(ms_mcml_sums(NULL, &count) == NULL && count == 0);
    free(sums);
    ms_mcml_destroy(a);
    ms_mcml_destroy(b);
    ms_mcml_destroy(NULL);
}

/* A share of another seed, tissue or grid, any cut and any changed bit of the head are refused; a changed sum is
   refused or read. */
static void damaged_shares(void)
{
    ms_mcml_options o = options_of(0);
    ms_mcml *a = tally_of(&o, 0, 100), *b = tally_of(&o, 0, 0), *empty = tally_of(&o, 0, 0);
    const tally_run run_of = two_layer_run(o.seed), other = two_layer_run(o.seed + 1);
    const size_t head = tally_head_size(&run_of) + 16; /* with the first photon */
    uint64_t first = 7;
    size_t size, i;
    unsigned char *bytes = tally_pack(a, &run_of, 0, &size), *longer;
    ms_error e;
    long refused = 0;
    CHECK_INT(tally_add(b, &other, bytes, size, &first, &e), MS_BAD_DATA);
    CHECK(strstr(e.message, "another") != NULL);
    for (i = 0; i < head + 400; ++i) {
        ms_mcml *c = tally_of(&o, 0, 0);
        ms_status status;
        bytes[i] ^= (unsigned char)(1u << (i * 7 % 8));
        status = tally_add(c, &run_of, bytes, size, NULL, &e);
        if (i < head || status != MS_OK) CHECK_INT(status, MS_BAD_DATA);
        if (status == MS_OK) {
            ms_mcml_result r;
            CHECK_INT(ms_mcml_results(c, &r, &e), MS_OK);
            ms_mcml_result_destroy(&r);
        } else {
            CHECK(same_bits(c, empty));
            ++refused;
        }
        ms_mcml_destroy(c);
        bytes[i] ^= (unsigned char)(1u << (i * 7 % 8));
    }
    for (i = 0; i < size; i += i < 300 ? 1 : 97) CHECK_INT(tally_add(b, &run_of, bytes, i, &first, &e), MS_BAD_DATA);
    longer = (unsigned char *)calloc(size + 8, 1);
    memcpy(longer, bytes, size);
    for (i = 1; i <= 8; ++i) CHECK_INT(tally_add(b, &run_of, longer, size + i, &first, &e), MS_BAD_DATA);
    CHECK(same_bits(b, empty) && first == 7);
    CHECK_INT(tally_add(b, &run_of, bytes, size, NULL, NULL), MS_OK);
    CHECK(same_bits(a, b));
    TEST_NOTE("%ld of %ld changed bytes refused", refused, (long)head + 400);
    free(longer);
    free(bytes);
    ms_mcml_destroy(a);
    ms_mcml_destroy(b);
    ms_mcml_destroy(empty);
}

/* --- progress, cancel, arguments, memory --- */

typedef struct watch {
    int calls, stop_at;
    double first, last;
} watch;

static int watching(void *user, double fraction)
{
    watch *w = (watch *)user;
    if (w->calls == 0) w->first = fraction;
    if (fraction < w->last || fraction < 0 || fraction > 1) TEST_FAIL("progress from %g to %g", w->last, fraction);
    w->last = fraction;
    return ++w->calls == w->stop_at;
}

/* Progress goes from 0 to 1 with calls between, with and without threads, and in a tissue without photons to trace. */
static void progress_from_0_to_1(void)
{
    ms_mcml_layer l = layer(1.4, 1, 20, 0.5, 0.5);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    ms_mcml_result plain, r;
    test_pool pool;
    const int photons = test_simd_best() > MS_SIMD_SCALAR ? 1000000 : 200000; /* two slices of 16 tasks of all lanes */
    int way;
    memset(&plain, 0, sizeof plain);
    for (way = 0; way < 4; ++way) {
        ms_mcml_options o = options_of(photons);
        watch w;
        memset(&w, 0, sizeof w);
        if (way > 0) {
            o.progress.user = &w;
            o.progress.report = watching;
        }
        if (way == 2) o.parallel = test_parallel(&pool, 3);
        if (way == 3) l = layer(1.4, 0, 0, 0, 0.5);
        r = run(&t, &g, &o);
        CHECK_INT(r.photons, photons);
        if (way == 0) {
            plain = r;
            continue;
        }
        CHECK(w.first <= 0 && w.last >= 1 && w.calls >= (way < 3 ? 3 : 2));
        if (way < 3) CHECK(memcmp(plain.rd_ra, r.rd_ra, 25 * sizeof(double)) == 0);
        ms_mcml_result_destroy(&r);
    }
    ms_mcml_result_destroy(&plain);
}

/* A stop ends the call within some slices of work, whatever a photon takes: in the last medium one takes minutes. A
   tally then holds what it held. */
static void cancel_in_any_medium(void)
{
    static const ms_mcml_layer hard[] = {
        {1.4, 1, 20, 0.5, 0.5}, {1.4, 0.003, 1000, 0.999, 1e8}, {1.4, 0, 100, 0.9999999, 1e8}};
    const ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    int i, threads;
    for (i = 0; i < 3; ++i)
        for (threads = 0; threads < 3; threads += 2) {
            const ms_mcml_tissue t = tissue_of(&hard[i], 1, 1, 1);
            ms_mcml_options o = options_of(50000000);
            ms_mcml_result r, before;
            ms_mcml *tally;
            test_pool pool;
            ms_error e;
            watch w;
            memset(&w, 0, sizeof w);
            w.stop_at = 4;
            o.progress.user = &w;
            o.progress.report = watching;
            if (threads) o.parallel = test_parallel(&pool, threads);
            memset(&r, 0x5a, sizeof r);
            before = r;
            CHECK_INT(ms_mcml_simulate(&t, &g, &o, &r, &e), MS_CANCELLED);
            CHECK(memcmp(&r, &before, sizeof r) == 0);
            CHECK_INT(w.calls, 4);
            CHECK(w.last < 0.1);
            if (i > 0) continue;
            memset(&w, 0, sizeof w);
            CHECK_INT(ms_mcml_create(&t, &g, &o, &tally, &e), MS_OK);
            CHECK_INT(ms_mcml_run(tally, 0, 1000, &e), MS_OK);
            CHECK_INT(ms_mcml_results(tally, &before, &e), MS_OK);
            memset(&w, 0, sizeof w);
            w.stop_at = 3;
            CHECK_INT(ms_mcml_run(tally, 1000, 50000000, &e), MS_CANCELLED);
            CHECK_INT(ms_mcml_photons(tally), 1000);
            CHECK_INT(ms_mcml_results(tally, &r, &e), MS_OK);
            CHECK(r.rd == before.rd && r.a == before.a && r.rd_error == before.rd_error);
            ms_mcml_result_destroy(&r);
            ms_mcml_result_destroy(&before);
            ms_mcml_destroy(tally);
        }
}

/* Grids up to the limit of 2^24 slabs (and rings, in the long version: 0.5 GB), by the sums themselves. All of the
   tissue lies beyond the last bin, so that all light is there and in no other. One bin more is refused. */
static void long_grids(void)
{
    const int most = 1 << 24;
    const ms_mcml_layer l = layer(1, 1, 10, 0, 1e7);
    const ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_options o = options_of(0);
    ms_mcml *m;
    ms_error e;
    int way, i;
    for (way = 0; way < (test_full ? 2 : 1); ++way) {
        const ms_mcml_grid g = way ? grid_of(1e-15, most, 1, 1, 1) : grid_of(0.05, 2, 1e-15, most, 1);
        const int64_t *sum;
        int64_t last = 0, all = 0;
        CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_OK);
        CHECK_INT(ms_mcml_run(m, 0, 1024, &e), MS_OK);
        sum = inside_sums(m, !way);
        for (i = 0; i < 2 * most; ++i) all += sum[i];
        if (way) last = sum[2 * most - 2] + sum[2 * most - 1];
        else last = sum[most - 1] + sum[2 * most - 1];
        CHECK(all > 0 && last == all);
        ms_mcml_destroy(m);
    }
    for (way = 0; way < 2; ++way) {
        const ms_mcml_grid g = grid_of(1, way ? 1 : most + 1, 1, way ? most + 1 : 1, 1);
        CHECK_INT(ms_mcml_create(&t, &g, NULL, &m, &e), MS_INVALID_ARGUMENT);
        CHECK(strstr(e.message, "2^24") != NULL && m == NULL);
    }
}

static void refuses(const char *gist, double n, double mu_a, double mu_s, double g, double d, double dr, int nr)
{
    ms_mcml_layer l[2];
    ms_mcml_tissue t = tissue_of(l, 2, 1, 1);
    ms_mcml_grid grid = grid_of(dr, nr, 0.1, 5, 5);
    ms_mcml *m = (ms_mcml *)1;
    ms_error e;
    l[0] = layer(1.4, 1, 1, 0, 1);
    l[1] = layer(n, mu_a, mu_s, g, d);
    CHECK_INT(ms_mcml_create(&t, &grid, NULL, &m, &e), MS_INVALID_ARGUMENT);
    if (strstr(e.message, gist) == NULL) TEST_FAIL("'%s' does not say '%s'", e.message, gist);
    CHECK(m == NULL);
}

static void bad_arguments(void)
{
    const double nan = (double)NAN, inf = (double)INFINITY;
    ms_mcml_layer l = layer(1.4, 1, 1, 0, 1);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    ms_mcml_options o = ms_mcml_defaults();
    ms_mcml *m;
    ms_mcml_result r;
    ms_error e;
    refuses("mu_a", 1.4, -1, 1, 0, 1, 0.1, 5);
    refuses("mu_a", 1.4, nan, 1, 0, 1, 0.1, 5);
    refuses("mu_s", 1.4, 1, -1, 0, 1, 0.1, 5);
    refuses("mu_s", 1.4, 1, inf, 0, 1, 0.1, 5);
    refuses("refractive index", 0, 1, 1, 0, 1, 0.1, 5);
    refuses("refractive index", nan, 1, 1, 0, 1, 0.1, 5);
    refuses("refractive index", 0.0099, 1, 1, 0, 1, 0.1, 5);
    refuses("refractive index", 100.1, 1, 1, 0, 1, 0.1, 5);
    refuses("mu_a", 1.4, 1.001e9, 1, 0, 1, 0.1, 5);
    refuses("mu_s", 1.4, 1, 1.001e9, 0, 1, 0.1, 5);
    refuses("g is", 1.4, 1, 1, -1, 1, 0.1, 5);
    refuses("g is", 1.4, 1, 1, 1.01, 1, 0.1, 5);
    refuses("g is", 1.4, 1, 1, nan, 1, 0.1, 5);
    refuses("g is 1 + 1e-07", 1.4, 1, 1, 1 + 1e-7, 1, 0.1, 5);
    refuses("expected 1e-30 to 1e30", 1.4, 1, 1, 0, 1, 1e300, 5);
    refuses("thickness", 1.4, 1, 1, 0, 0, 0.1, 5);
    refuses("thickness", 1.4, 1, 1, 0, inf, 0.1, 5);
    refuses("dr", 1.4, 1, 1, 0, 1, 0, 5);
    refuses("dr", 1.4, 1, 1, 0, 1, nan, 5);
    refuses("nr", 1.4, 1, 1, 0, 1, 0.1, 0);
    l.g = -2;
    CHECK_INT(ms_mcml_create(&t, &g, NULL, &m, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(e.position, 1);
    l.g = 0;
    t.n_below = 0;
    CHECK_INT(ms_mcml_create(&t, &g, NULL, &m, &e), MS_INVALID_ARGUMENT);
    t.n_below = 1;
    t.layer_count = 0;
    CHECK_INT(ms_mcml_create(&t, &g, NULL, &m, &e), MS_INVALID_ARGUMENT);
    t.layer_count = 32768; /* one more than there may be */
    CHECK_INT(ms_mcml_create(&t, &g, NULL, &m, &e), MS_INVALID_ARGUMENT);
    t.layer_count = 1;
    o.photons = ((uint64_t)1 << 32) + 1;
    CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_INVALID_ARGUMENT);
    o.photons = 0;
    o.roulette_weight = 2;
    CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_INVALID_ARGUMENT);
    o.roulette_weight = 0;
    o.memory_limit = 1000;
    CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_UNSUPPORTED);
    o.memory_limit = 0;
    g.nr = g.nz = 1 << 24; /* sizes that overflow */
    g.na = 2147483647;
    CHECK_INT(ms_mcml_create(&t, &g, &o, &m, &e), MS_UNSUPPORTED);
    g.nr = g.nz = g.na = 5;
    CHECK_INT(ms_mcml_create(&t, &g, &o, &m, NULL), MS_OK);
    CHECK_INT(ms_mcml_results(m, &r, &e), MS_INVALID_ARGUMENT); /* empty */
    ms_mcml_destroy(m);
    CHECK_INT(ms_mcml_create(NULL, &g, &o, &m, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_create(&t, &g, &o, NULL, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_mcml_simulate(&t, &g, &o, NULL, &e), MS_INVALID_ARGUMENT);
    ms_mcml_result_destroy(NULL);
}

static void allocations(void)
{
    ms_mcml_layer l = layer(1.4, 1, 20, 0.5, 0.5);
    ms_mcml_tissue t = tissue_of(&l, 1, 1, 1);
    ms_mcml_grid g = grid_of(0.1, 5, 0.1, 5, 5);
    test_pool pool;
    ms_parallel parallel = test_parallel(&pool, 2);
    TEST_ALLOCATION_SWEEP(20, {
        ms_mcml_options o = options_of(1000);
        ms_mcml_result r;
        o.allocator = allocator;
        o.parallel = parallel;
        status = ms_mcml_simulate(&t, &g, &o, &r, NULL);
        if (status == MS_OK) ms_mcml_result_destroy(&r);
    });
}

static const test_case cases[] = {
    {"totals", totals},
    {"published", published},
    {"profiles", profiles},
    {"errors_are_honest", errors_are_honest},
    {"unknown_errors_are_infinite", unknown_errors_are_infinite},
    {"hard_media", hard_media},
    {"absorber_alone", absorber_alone},
    {"clear_stacks", clear_stacks},
    {"hardly_absorbing", hardly_absorbing},
    {"largest_grid", largest_grid},
    {"absorption_adds_up", absorption_adds_up},
    {"whole_photons", whole_photons},
    {"splits_and_threads", splits_and_threads},
    {"levels_agree", levels_agree},
    {"add_refuses", add_refuses},
    {"damaged_shares", damaged_shares},
    {"progress_from_0_to_1", progress_from_0_to_1},
    {"cancel_in_any_medium", cancel_in_any_medium},
    {"long_grids", long_grids},
    {"bad_arguments", bad_arguments},
    {"allocations", allocations},
};

TEST_MAIN(cases)
