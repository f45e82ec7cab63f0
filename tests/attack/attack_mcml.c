/* Attacks on ms_mcml.h: tissues and media over the whole of their documented ranges, energy, grids inside grids, splits,
   colors there and back, and the layered solver against photons. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "layered.h"
#include "attack.h"

enum { LAYERS = 16 };

static double case_start;

/* Stops a call after this many seconds of processor time. */
static double seconds_allowed;
static double last_fraction;
static int stop_late(void *user, double fraction)
{
    (void)user;
    ATTACK_CHECK(fraction >= 0 && fraction <= 1, "progress out of 0 to 1: %g", fraction);
    ATTACK_CHECK(fraction >= last_fraction, "progress goes back: from %g to %g", last_fraction, fraction);
    last_fraction = fraction;
    return attack_clock() - case_start > seconds_allowed;
}

static ms_progress progress_of(double seconds)
{
    ms_progress p;
    p.user = NULL;
    p.report = stop_late;
    case_start = attack_clock();
    seconds_allowed = seconds;
    last_fraction = 0;
    return p;
}

static double draw_mu(double most) { return attack_one_in(5) ? 0 : attack_log(attack_one_in(6) ? 1e-300 : 1e-9, most); }

/* Any tissue that the declaration allows; `most`: of absorption and scattering. */
static void draw_tissue(ms_mcml_tissue *t, ms_mcml_layer *l, int layers, double most)
{
    int i;
    const int usual = attack_one_in(2);
    t->layers = l;
    t->layer_count = (int)attack_int(1, layers);
    t->n_above = attack_one_in(3) ? attack_log(0.01, 100) : 1;
    t->n_below = attack_one_in(3) ? attack_log(0.01, 100) : 1;
    for (i = 0; i < t->layer_count; ++i) {
        l[i].n = usual || attack_one_in(2) ? attack_linear(1, 2) : attack_log(0.01, 100);
        l[i].mu_a_per_cm = draw_mu(most);
        l[i].mu_s_per_cm = draw_mu(most);
        l[i].g = !attack_one_in(2) ? 0 : attack_one_in(3) ? -attack_linear(0, 0.999) : attack_linear(0, 1);
        if (attack_one_in(12)) l[i].g = (attack_one_in(2) ? -1 : 1) * (1 - attack_log(2e-16, 1e-3));
        if (l[i].g <= -1) l[i].g = -0.999;
        l[i].thickness_cm = attack_one_in(3) ? 1e8 : attack_log(usual ? 1e-4 : 1e-12, usual ? 10 : 1e8);
        if (!usual && attack_one_in(8)) l[i].thickness_cm = attack_log(1e-300, 1e300);
    }
}

static void say_tissue(const ms_mcml_tissue *t)
{
    int i;
    attack_say("n above %.9g, below %.9g", t->n_above, t->n_below);
    for (i = 0; i < t->layer_count; ++i)
        attack_say("\n     n %.9g mu_a %.9g mu_s %.9g g %.9g d %.9g cm", t->layers[i].n, t->layers[i].mu_a_per_cm,
                   t->layers[i].mu_s_per_cm, t->layers[i].g, t->layers[i].thickness_cm);
}

static int all_finite(const double *v, size_t count, double least)
{
    size_t i;
    for (i = 0; i < count; ++i)
        if (!(v[i] >= least && v[i] <= 1e300)) return 0;
    return 1;
}

/* ---- photons ----------------------------------------------------------------------------------------------------- */

static void draw_grid(ms_mcml_grid *g)
{
    const double least = attack_one_in(4) ? 1e-30 : 1e-9, most = attack_one_in(4) ? 1e30 : 1e6;
    g->dr_cm = attack_log(least, most);
    g->dz_cm = attack_log(least, most);
    g->nr = (int)attack_int(1, 60);
    g->nz = (int)attack_int(1, 60);
    g->na = (int)attack_int(1, 20);
    if (attack_one_in(100)) { /* around the largest whole number that a float holds */
        const int large = (1 << 24) - 4 + attack_index(50);
        if (attack_one_in(2)) {
            g->nr = large;
            g->nz = attack_one_in(2) ? 8 : 1;
        } else {
            g->nz = large;
            g->nr = (int)attack_int(1, 4);
        }
        g->na = 1;
    }
}

static ms_status photons_of(const ms_mcml_tissue *t, const ms_mcml_grid *g, const ms_mcml_options *o, int parts,
                            ms_mcml_result *r, ms_error *error)
{
    ms_mcml *tally = NULL;
    ms_status status = ms_mcml_create(t, g, o, &tally, error);
    uint64_t at = 0;
    int i;
    for (i = 0; i < parts && status == MS_OK; ++i) {
        const uint64_t end = o->photons * (uint64_t)(i + 1) / (uint64_t)parts;
        last_fraction = 0;
        if (end > at) status = ms_mcml_run(tally, at, end - at, error);
        at = end;
    }
    if (status == MS_OK) status = ms_mcml_results(tally, r, error);
    ms_mcml_destroy(tally);
    return status;
}

static void family_photons(void)
{
    static ms_mcml_layer l[LAYERS];
    ms_mcml_tissue t;
    ms_mcml_grid g, one;
    ms_mcml_options o = ms_mcml_defaults();
    ms_mcml_result r, s;
    ms_error error = attack_no_error();
    ms_status status;
    int i, k, large;
    double sum, part;
    draw_tissue(&t, l, LAYERS, 1e9);
    draw_grid(&g);
    large = g.nr > 1000000 || g.nz > 1000000;
    o.photons = (uint64_t)attack_int(1, large ? 200 : 3000);
    o.seed = attack_draw();
    o.no_absorption = attack_one_in(8);
    o.simd = (ms_simd)attack_index(5);
    if (attack_one_in(4)) o.roulette_weight = attack_log(1e-6, 1);
    o.allocator = attack_allocator((size_t)3 << 30);
    o.progress = progress_of(1);
    say_tissue(&t);
    attack_say("\n     grid dr %.9g dz %.9g, %d x %d x %d; %llu photons, seed %llu, simd %d", g.dr_cm, g.dz_cm, g.nr,
               g.nz, g.na, (unsigned long long)o.photons, (unsigned long long)o.seed, (int)o.simd);
    memset(&r, 0x55, sizeof r);
    status = ms_mcml_simulate(&t, &g, &o, &r, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        for (i = 0; i < (int)sizeof r; ++i)
            if (((unsigned char *)&r)[i] != 0x55) {
                attack_fail("output touched on failure: result");
                break;
            }
        if (status == MS_INVALID_ARGUMENT && g.nr <= 1 << 24 && g.nz <= 1 << 24)
            attack_fail("a valid tissue is refused: %s", error.message);
        return;
    }
    ATTACK_CHECK(r.photons == o.photons, "photons lost: %llu", (unsigned long long)r.photons);
    sum = r.specular + r.rd + r.a + r.tt;
    ATTACK_CHECK(sum == sum, "not a number: %g %g %g %g", r.specular, r.rd, r.a, r.tt);
    /* roulette and the halving of old photons keep energy on the average only */
    if (r.rd_error < 1 && r.tt_error < 1 && r.a_error < 1 && o.photons > 100)
        /* what is caught without absorption ends by halving: a few photons of large weight, of which a run may have none */
        ATTACK_CHECK(fabs(sum - 1) <= 8 * (r.rd_error + r.tt_error + r.a_error) + (r.a > 1e-9 || sum > 1 ? 1e-6 : 0.2) +
                             10 / (double)o.photons,
                     "energy: %.9g + %.9g + %.9g + %.9g = %.9g", r.specular, r.rd, r.a, r.tt, sum);
    ATTACK_CHECK(all_finite(r.rd_r, (size_t)g.nr, 0) && all_finite(r.tt_r, (size_t)g.nr, 0), "not finite: a ring");
    ATTACK_CHECK(all_finite(r.rd_ra, (size_t)g.nr * (size_t)g.na, 0) && all_finite(r.rd_a, (size_t)g.na, 0),
                 "not finite: an angle");
    for (sum = 0, i = 0; i < g.nr; ++i) sum += r.rd_r[i] * 3.14159265358979324 * (2.0 * i + 1) * g.dr_cm * g.dr_cm;
    ATTACK_CHECK(fabs(sum - r.rd) <= 1e-6 * r.rd + 2e-7, "rings do not add up: %.9g for rd %.9g", sum, r.rd);
    for (sum = 0, i = 0; i < t.layer_count; ++i) sum += r.a_l[i];
    ATTACK_CHECK(fabs(sum - r.a) <= 1e-9 + 1e-6 * r.a, "layers do not add up: %.9g for a %.9g", sum, r.a);
    if (!o.no_absorption) {
        for (sum = 0, i = 0; i < g.nz; ++i) sum += r.a_z[i] * g.dz_cm;
        for (part = 1, i = 0; i < t.layer_count; ++i)
            if (l[i].mu_a_per_cm > 0) part = fmin(part, l[i].mu_a_per_cm / (l[i].mu_a_per_cm + l[i].mu_s_per_cm));
        /* What a photon leaves in a layer is added up in a float for up to 4096 events, of which each rounds by up to 2^-25
           of the sum; small parts of equal size may be rounded the same way each time: 2048 2^-25 of the sum in all. */
        ATTACK_CHECK(fabs(sum - r.a) <= (part < 1e-5 ? 6.2e-5 : 1e-6) * r.a + 2e-7,
                     "slabs do not add up: %.9g for a %.9g", sum, r.a);
    }
    /* the same photons on another grid, in parts, in another order of tasks */
    one = g;
    one.nz = 1;
    one.na = 1;
    if (attack_one_in(2)) one.nr = 1;
    if (attack_one_in(2)) o.parallel = attack_parallel();
    o.progress = progress_of(2);
    memset(&s, 0, sizeof s);
    status = photons_of(&t, &one, &o, 1 + attack_index(3), &s, &error);
    if (status == MS_OK) {
        ATTACK_CHECK(memcmp(&r.rd, &s.rd, sizeof r.rd) == 0 && memcmp(&r.tt, &s.tt, sizeof r.tt) == 0 &&
                         memcmp(&r.a, &s.a, sizeof r.a) == 0,
                     "another grid, split or order: rd %.17g %.17g, tt %.17g %.17g, a %.17g %.17g", r.rd, s.rd, r.tt,
                     s.tt, r.a, s.a);
        if (!o.no_absorption && one.nr == g.nr) /* in each ring what was absorbed at any depth */
            for (i = 0; i < g.nr && !attack->failed; ++i) {
                for (sum = 0, k = 0; k < g.nz; ++k) sum += r.a_rz[(size_t)i * (size_t)g.nz + (size_t)k];
                if (fabs(sum - s.a_rz[i]) > 1e-9 * (s.a_rz[i] + sum))
                    attack_fail("a ring's absorption: %d has %.9g in %d slabs, %.9g in one", i, sum, g.nz, s.a_rz[i]);
            }
        ms_mcml_result_destroy(&s);
    } else if (status != MS_CANCELLED) attack_fail("the second run fails: %s", error.message);
    ms_mcml_result_destroy(&r);
}

/* ---- layers without noise ------------------------------------------------------------------------------------------ */

/* The domain of layered.h: scattering is isotropic, extinctions within a factor of 100. */
static void draw_mild(ms_mcml_tissue *t, ms_mcml_layer *l, int layers)
{
    const double base = attack_log(0.1, 1e4);
    int i;
    t->layers = l;
    t->layer_count = (int)attack_int(1, layers);
    t->n_above = attack_one_in(4) ? attack_linear(1, 2.5) : 1;
    t->n_below = attack_one_in(4) ? attack_linear(1, 2.5) : 1;
    for (i = 0; i < t->layer_count; ++i) {
        const double mu = base * attack_log(1, 100), albedo = attack_one_in(4) ? 1 : 1 - attack_log(1e-6, 0.999);
        l[i].n = attack_one_in(2) ? attack_linear(1, 2.5) : 1.4;
        l[i].mu_s_per_cm = mu * albedo;
        l[i].mu_a_per_cm = mu - l[i].mu_s_per_cm;
        l[i].g = 0;
        l[i].thickness_cm = i + 1 == t->layer_count && attack_one_in(2) ? 1e8 : attack_log(0.011, 50) / mu;
    }
}

static void check_solution(const ms_mcml_tissue *t, const ms_mcml_layered *s, ms_status status, int totals_only)
{
    const double sum = s->specular + s->rd + s->tt + s->a, stated = s->rd_error + s->tt_error;
    int side, k, absorbing = 0;
    for (k = 0; k < t->layer_count; ++k) absorbing |= t->layers[k].mu_a_per_cm > 0;
    if (!(s->rd >= -1e-6 && s->rd <= 1 + 1e-6 && s->tt >= -1e-6 && s->tt <= 1 + 1e-6 && s->a >= -1e-3 && sum == sum))
        attack_fail("totals: specular %.9g rd %.9g tt %.9g a %.9g", s->specular, s->rd, s->tt, s->a);
    if (status == MS_OK && !(fabs(sum - 1) <= 4 * stated + 1e-7))
        attack_fail("energy: specular %.9g + rd %.9g + tt %.9g + a %.9g = 1 %+.2g, stated %.2g", s->specular, s->rd,
                    s->tt, s->a, sum - 1, stated);
    if (status == MS_OK && !absorbing && !(fabs(s->specular + s->rd + s->tt - 1) <= 4 * stated + 1e-7))
        attack_fail("without absorption: specular + rd + tt = 1 %+.2g, stated %.2g", s->specular + s->rd + s->tt - 1,
                    stated);
    for (side = 0; side < 2 && !attack->failed; ++side) {
        double last = HUGE_VAL, total = side ? s->tt : s->rd;
        for (k = 0; k < 120 && !totals_only; ++k) {
            const double r = k ? 1e-9 * pow(10, k * 0.14) : 0, v = ms_mcml_layered_outside(s, side, r);
            double e = 0, ring;
            if (v != v) attack_fail("not a number: energy beyond %.3g cm, side %d", r, side);
            else if (v > last * (1 + 1e-6) + 1e-6 * total + 1e-9)
                attack_fail("energy rises with the radius: %.9g beyond %.3g cm, side %d, %.9g nearer", v, r, side,
                            last);
            ring = ms_mcml_layered_ring(s, side, r, r > 0 ? r * 1.3 : 1e-9, &e);
            if (!(ring >= 0 && e >= 0 && ring < 1e300))
                attack_fail("a ring: %.9g +- %.9g at %.3g cm, side %d", ring, e, r, side);
            last = v;
        }
    }
}

static void layered_options(ms_mcml_layered_options *o, size_t limit)
{
    memset(o, 0, sizeof *o);
    o->allocator = attack_allocator(limit);
    o->totals_only = attack_one_in(6);
    o->progress = progress_of(10);
}

static void family_layered(void)
{
    static ms_mcml_layer l[LAYERS];
    static ms_mcml_layered s;
    ms_mcml_tissue t;
    ms_mcml_layered_options o;
    ms_error error = attack_no_error();
    ms_status status;
    double depth[10], parts[LAYERS];
    int i;
    if (attack_one_in(3)) draw_mild(&t, l, 8);
    else draw_tissue(&t, l, 16, attack_one_in(2) ? 1e9 : 1e3);
    say_tissue(&t);
    layered_options(&o, (size_t)1 << 30);
    if (attack_one_in(2)) {
        o.dz_cm = attack_log(1e-6, 10);
        o.nz = 10;
        o.a_z = depth;
        o.a_l = parts;
        for (i = 0; i < 10; ++i) depth[i] = 7e77;
        for (i = 0; i < LAYERS; ++i) parts[i] = 7e77;
    }
    attack_say("\n     totals only %d", o.totals_only);
    memset(&s, 0x55, sizeof s);
    status = ms_mcml_layered_solve(&t, &o, &s, &error);
    if (status != MS_OK && status != MS_NOT_CONVERGED) {
        attack_check_error(status, &error);
        for (i = 0; i < (int)sizeof s; ++i)
            if (((unsigned char *)&s)[i] != 0x55) {
                attack_fail("output touched on failure: solution (%s)", error.message);
                break;
            }
        if (o.a_z) ATTACK_CHECK(depth[0] == 7e77 && parts[0] == 7e77, "output touched on failure: a_z, a_l");
        if (status == MS_INVALID_ARGUMENT) attack_fail("a valid tissue is refused: %s", error.message);
        return;
    }
    check_solution(&t, &s, status, o.totals_only);
    if (o.totals_only) { /* what is not known is not a number */
        const double beyond = ms_mcml_layered_outside(&s, 0, 1e-12), all = s.rd - s.rd_unscattered;
        if (all > 1e-3 && fabs(beyond) < 0.5 * all)
            attack_fail("totals only, and rings answer: %.9g beyond 1e-12 cm, rd %.9g", beyond, s.rd);
    }
    if (o.a_z) {
        double sum = 0;
        ATTACK_CHECK(all_finite(depth, 10, -1e-6 / o.dz_cm), "not finite: absorption over depth");
        for (i = 0; i < t.layer_count; ++i) sum += parts[i];
        if (status == MS_OK)
            ATTACK_CHECK(fabs(sum - s.a) <= 4 * (s.rd_error + s.tt_error) + 1e-6, "layers absorb %.9g: a is %.9g", sum,
                         s.a);
    }
}

/* Totals and rings within the stated error and five of the photons' standard errors. */
static void family_statement(void)
{
    static ms_mcml_layer l[LAYERS];
    static ms_mcml_layered s;
    ms_mcml_tissue t;
    ms_mcml_layered_options o;
    ms_mcml_options m = ms_mcml_defaults();
    ms_mcml_grid g;
    ms_mcml_result r;
    ms_mcml *tally = NULL;
    ms_error error;
    ms_status status;
    uint64_t at = 0, count = 64;
    double mu = 0, start;
    int i, side, thin = attack_one_in(3);
    draw_mild(&t, l, thin ? 1 : 3);
    if (thin) l[0].thickness_cm = attack_log(0.002, 0.5) / (l[0].mu_a_per_cm + l[0].mu_s_per_cm);
    for (i = 0; i < t.layer_count; ++i) mu = fmax(mu, l[i].mu_a_per_cm + l[i].mu_s_per_cm);
    say_tissue(&t);
    layered_options(&o, (size_t)1 << 30);
    o.totals_only = 0;
    status = ms_mcml_layered_solve(&t, &o, &s, &error);
    if (status != MS_OK) return;
    g.dr_cm = (thin ? 1 : attack_log(0.1, 3)) / mu;
    g.dz_cm = 1;
    g.nr = 12;
    g.nz = g.na = 1;
    m.no_absorption = 1;
    m.allocator = attack_allocator((size_t)1 << 30);
    m.seed = attack_draw();
    m.progress = progress_of(3); /* a stop adds nothing: what ran before is compared */
    if (ms_mcml_create(&t, &g, &m, &tally, &error) != MS_OK) return;
    /* few at first: without absorption, 4096 photons take half a minute in the thickest of these tissues */
    for (start = attack_clock(); attack_clock() - start < 0.5 && at < 100000000; at += count) {
        if (attack_clock() - start < 0.05 && at > 0) count *= 2;
        last_fraction = 0;
        if (ms_mcml_run(tally, at, count, &error) != MS_OK) break;
    }
    if (at > 0 && ms_mcml_results(tally, &r, &error) == MS_OK) {
        const double rd[2] = {r.rd, r.tt}, re[2] = {r.rd_error, r.tt_error}, sd[2] = {s.rd, s.tt},
                     se[2] = {s.rd_error, s.tt_error};
        for (side = 0; side < 2; ++side) {
            const double *ring = side ? r.tt_r : r.rd_r, *ring_error = side ? r.tt_r_error : r.rd_r_error;
            if (re[side] > 0 && re[side] < 0.1 * rd[side] && fabs(rd[side] - sd[side]) > se[side] + 5 * re[side] + 1e-9)
                attack_fail("a total: side %d has %.6g +- %.2g by photons, %.6g +- %.2g by the solver (%.1f sigma)",
                            side, rd[side], re[side], sd[side], se[side],
                            fabs(rd[side] - sd[side]) / (se[side] + re[side]));
            for (i = 0; i + 1 < g.nr; ++i) { /* ring 0 has the unscattered light */
                double e, v;
                if (i == 0 && (side ? s.tt_unscattered : s.rd_unscattered) > 0) continue;
                v = ms_mcml_layered_ring(&s, side, i * g.dr_cm, (i + 1) * g.dr_cm, &e);
                if (ring[i] > 0 && ring_error[i] < 0.1 * ring[i] && fabs(v - ring[i]) > e + 5.5 * ring_error[i])
                    attack_fail("a ring: %d of %.3g cm, side %d: %.5g +- %.2g%% by %llu photons, %.5g +- %.2g%% by the "
                                "solver",
                                i, g.dr_cm, side, ring[i], 100 * ring_error[i] / ring[i], (unsigned long long)at, v,
                                100 * e / v);
            }
        }
        ms_mcml_result_destroy(&r);
    }
    ms_mcml_destroy(tally);
}

/* ---- half-spaces ---------------------------------------------------------------------------------------------------- */

static ms_mcml_medium draw_medium(int any_g)
{
    ms_mcml_medium m;
    const double base = attack_one_in(8) ? attack_log(1e-90, 1e90) : attack_log(1e-6, 1e6);
    m.mu_s_per_mm = attack_one_in(10) ? 0 : base;
    m.mu_a_per_mm = attack_one_in(8) && m.mu_s_per_mm > 0 ? 0 : base * attack_log(1e-9, 1e6);
    m.g = any_g && attack_one_in(6) ? attack_linear(-0.9, 0.95) : 0;
    m.eta = attack_one_in(2) ? attack_linear(1, 1.6) : attack_log(0.1, 10);
    return m;
}

static void family_profiles(void)
{
    ms_mcml_medium media[3], scaled[3];
    ms_mcml_profile_options o;
    ms_mcml_profile p, q;
    ms_error error = attack_no_error();
    ms_status status;
    double edges[9], other[9];
    const int channels = (int)attack_int(1, 3), give = attack_one_in(2);
    int c, i, scattered = 0;
    double factor;
    memset(&o, 0, sizeof o);
    memset(scaled, 0, sizeof scaled);
    for (c = 0; c < channels; ++c) {
        media[c] = draw_medium(1);
        scattered |= media[c].g != 0;
        attack_say("%smu_a %.9g mu_s %.9g g %.9g eta %.9g", c ? "; " : "", media[c].mu_a_per_mm, media[c].mu_s_per_mm,
                   media[c].g, media[c].eta);
    }
    if (give) {
        const double least = attack_one_in(6) ? 1e-100 : 1e-9, most = attack_one_in(6) ? 1e98 : 1e6;
        edges[0] = attack_one_in(2) ? 0 : attack_log(least, 1e3);
        for (i = 1; i < 9; ++i) edges[i] = edges[i - 1] + attack_log(least, most);
        o.edge_mm = edges;
        o.rings = 8;
    } else if (attack_one_in(2)) {
        o.rings = (int)attack_int(1, 200);
        o.ring_mm = attack_one_in(6) ? attack_log(1e-100, 1e97) : attack_log(1e-6, 1e6);
    }
    if (attack_one_in(4)) o.depth_step = attack_linear(0.28, 1);
    if (attack_one_in(4)) o.frequency_step = attack_linear(0.2, 1);
    if (attack_one_in(2)) o.parallel = attack_parallel();
    o.allocator = attack_allocator((size_t)1 << 30);
    memset(&p, 0, sizeof p);
    for (i = 1; give && i < 9; ++i)
        if (!(edges[i] > edges[i - 1])) return;
    status = ms_mcml_profile_make(&p, media, channels, &o, &error);
    if (status != MS_OK && status != MS_NOT_CONVERGED) {
        attack_check_error(status, &error);
        if (status == MS_INVALID_ARGUMENT) attack_fail("valid media are refused: %s", error.message);
        return;
    }
    for (c = 0; c < channels; ++c) {
        const double *ring = p.rd_per_mm2 + c * p.rings, *within = p.within + c * (p.rings + 1);
        if (!(p.total[c] >= 0 && p.total[c] <= 1 + 1e-9)) attack_fail("a total: %.9g", p.total[c]);
        for (i = 0; i < p.rings; ++i) {
            const double a = p.edge_mm[i], b = p.edge_mm[i + 1], area = 3.14159265358979324 * (b - a) * (b + a);
            if (!(ring[i] >= 0 && ring[i] < 1e300)) attack_fail("a ring: %.9g from %.9g to %.9g mm", ring[i], a, b);
            if (!(within[i + 1] >= within[i] * (1 - 1e-9) - 1e-12))
                attack_fail("energy falls with the radius: %.9g within %.9g mm, %.9g before", within[i + 1], b,
                            within[i]);
            if (!scattered && !(fabs(ring[i] * area - (within[i + 1] - within[i])) <= 1e-7 * p.total[c] + 1e-12))
                attack_fail("rings and energy differ: %.9g for %.9g", ring[i] * area, within[i + 1] - within[i]);
        }
        if (!(within[p.rings] <= p.total[c] * (1 + 1e-7) + 1e-12))
            attack_fail("more within the rings than in all: %.9g of %.9g", within[p.rings], p.total[c]);
    }
    if (give && status == MS_OK && !scattered) {
        /* one channel alone has the same bits; all lengths twice as long give the same energies */
        ms_mcml_profile_options plain = o;
        memset(&plain.parallel, 0, sizeof plain.parallel);
        memset(&q, 0, sizeof q);
        c = attack_index(channels);
        if (ms_mcml_profile_make(&q, &media[c], 1, &plain, &error) == MS_OK) {
            ATTACK_CHECK(memcmp(q.within, p.within + c * 9, 9 * sizeof(double)) == 0 &&
                             memcmp(q.rd_per_mm2, p.rd_per_mm2 + c * 8, 8 * sizeof(double)) == 0,
                         "another value for a channel alone: channel %d", c);
            ms_mcml_profile_destroy(&q);
        }
        factor = attack_one_in(2) ? 2 : 3;
        for (i = 0; i < channels; ++i) {
            scaled[i] = media[i];
            scaled[i].mu_a_per_mm /= factor;
            scaled[i].mu_s_per_mm /= factor;
        }
        for (i = 0; i < 9; ++i) other[i] = edges[i] * factor;
        plain.edge_mm = other;
        if (ms_mcml_profile_make(&q, scaled, channels, &plain, &error) == MS_OK) {
            for (i = 0; i < channels * 9; ++i)
                if (!(fabs(q.within[i] - p.within[i]) <= 1e-6 * p.total[i / 9] + 1e-12))
                    attack_fail("another unit of length: %.9g for %.9g within edge %d", q.within[i], p.within[i],
                                i % 9);
            ms_mcml_profile_destroy(&q);
        }
    }
    ms_mcml_profile_destroy(&p);
}

static void family_colors(void)
{
    ms_mcml_medium m;
    ms_mcml_profile_options o;
    ms_mcml_profile p;
    ms_error error = attack_no_error();
    ms_status status;
    const double edges[2] = {0, 1};
    const int kind = attack_index(3);
    double color = attack_one_in(3) ? attack_linear(0, 1)
        : attack_one_in(2)          ? attack_log(1e-300, 1)
                                    : 1 - attack_log(1e-16, 1);
    const double length = attack_one_in(2) ? attack_log(1e-30, 1e30) : attack_log(1e-9, 1e9),
                 eta = attack_one_in(2) ? attack_linear(1, 1.6) : attack_log(0.1, 10);
    const double mirror = (eta - 1) / (eta + 1) * ((eta - 1) / (eta + 1));
    attack_say("color %.17g, length %.9g mm (%d), eta %.17g", color, length, kind, eta);
    memset(&m, 0x55, sizeof m);
    status = ms_mcml_medium_from_color(color, length, kind, eta, &m, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        attack_fail("a valid color is refused: %s", error.message);
        return;
    }
    if (!(m.mu_a_per_mm >= 0 && m.mu_s_per_mm >= 0 && m.mu_a_per_mm + m.mu_s_per_mm > 0 && m.mu_a_per_mm < 1e300)) {
        attack_fail("a medium: mu_a %.9g, mu_s %.9g", m.mu_a_per_mm, m.mu_s_per_mm);
        return;
    }
    if (kind == MS_MCML_MEAN_FREE_PATH)
        ATTACK_CHECK(fabs((m.mu_a_per_mm + m.mu_s_per_mm) * length - 1) < 1e-9,
                     "another mean free path: %.12g for %.12g", 1 / (m.mu_a_per_mm + m.mu_s_per_mm), length);
    memset(&o, 0, sizeof o);
    o.edge_mm = edges;
    o.rings = 1;
    if (ms_mcml_profile_make(&p, &m, 1, &o, &error) == MS_OK) {
        if (!(fabs(p.total[0] / (1 - mirror) - color) <= 1.5e-7))
            attack_fail("a color does not come back: %.9g for %.9g", p.total[0] / (1 - mirror), color);
        ms_mcml_profile_destroy(&p);
    } else attack_fail("the medium of a color has no profile: %s", error.message);
}

int main(int argc, char **argv)
{
    static const attack_family families[] = {{"photons", family_photons},
                                             {"layered", family_layered},
                                             {"statement", family_statement},
                                             {"profiles", family_profiles},
                                             {"colors", family_colors}};
    return attack_main(argc, argv, families, (int)(sizeof families / sizeof *families));
}
