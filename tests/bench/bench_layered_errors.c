/* Does the layered solver's stated error hold? 300 random media in ten families, rings of reflectance and transmittance
   against Monte Carlo with another seed. A ring that holds 1e-3 of its side's energy is a violation if it is farther
   off than the stated error plus four standard errors of the reference.
     SECONDS    of the reference a medium, 2
     MEDIA      "from-to" of 0-299
     VERBOSE    1: every medium, 2: every ring
     SEED       of the media and their reference, 31415926
   The reference is kept in build/bench/layered_SEED.bin and read from there by later runs; delete it for a new
   one. To build/bench/layered_errors.md. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "bench.h"

enum { FAMILIES = 10, EACH = 30, EDGES = 14, LAYERS = 16 };

static const char *const family_name[FAMILIES] = {
    "one layer, matched indices",
    "one layer, mismatched indices",
    "2 to 4 layers, matched indices",
    "2 to 4 layers, mismatched indices",
    "clear layers",
    "g 0.9 to 0.99",
    "layers of 0.01 to 100 mean free paths",
    "light guided in a weak layer",
    "5 to 16 layers",
    "albedo 1 - 1e-6 to 1 - 1e-3, index up to 2.5",
};

typedef struct random_medium {
    ms_mcml_tissue tissue;
    ms_mcml_layer layer[LAYERS];
} random_medium;

/* Energies of the rings between the edges, the last one without end, and their standard errors. */
typedef struct reference {
    double photons, edge[2][EDGES], energy[2][EDGES], error[2][EDGES], seconds;
} reference;

static uint64_t state, seed = 31415926;

static double uniform(double low, double high) /* splitmix64 */
{
    uint64_t z = state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) / 9007199254740992;
}

static double log_uniform(double low, double high) { return exp(uniform(log(low), log(high))); }

/* mu_t of the layer, its albedo 1 - gap, its thickness in mean free paths. */
static ms_mcml_layer layer_of(double n, double mu_t, double gap, double g, double paths)
{
    ms_mcml_layer y;
    y.n = n;
    y.mu_a_per_cm = mu_t * gap;
    y.mu_s_per_cm = mu_t * (1 - gap);
    y.g = g;
    y.thickness_cm = paths / mu_t;
    return y;
}

static double some_g(void)
{
    return uniform(0, 1) < 0.25 ? 0 : uniform(0, 1) < 0.15 ? uniform(-0.6, 0) : uniform(0, 0.9);
}

static void medium_make(int index, random_medium *m)
{
    const int family = index / EACH;
    int layers = 1, i, matched = family == 0 || family == 2 || family == 7;
    double n;
    state = (uint64_t)index * 7919 + seed;
    for (i = 0; i < 8; ++i) uniform(0, 1);
    n = uniform(1.3, 1.5);
    if (family == 2 || family == 3 || family == 6) layers = (int)uniform(2, 5);
    if (family == 4) layers = (int)uniform(2, 4);
    if (family == 5) layers = (int)uniform(1, 3);
    if (family == 7) layers = (int)uniform(2, 4);
    if (family == 8) layers = (int)uniform(5, 17);
    if (family == 9) layers = (int)uniform(1, 3);
    for (i = 0; i < layers; ++i) {
        const double index_here = matched ? 1 : family == 9 ? uniform(1, 2.5) : uniform(1.3, 1.6);
        const double mu_t = log_uniform(10, 300);
        double gap = log_uniform(1e-3, 0.5), g = some_g(), paths = log_uniform(1, 100);
        if (family == 5) g = uniform(0.9, 0.99), paths = log_uniform(5, 200);
        if (family == 6) paths = log_uniform(0.01, 100);
        if (family == 8) paths = log_uniform(0.1, 20);
        if (family == 9) gap = log_uniform(1e-6, 1e-3), paths = log_uniform(2, 60), g = uniform(0, 1) < 0.5 ? 0 : g;
        m->layer[i] = layer_of(index_here, mu_t, gap, g, paths);
    }
    if (family == 4) { /* one of them is clear */
        i = (int)uniform(0, layers);
        m->layer[i].mu_a_per_cm = m->layer[i].mu_s_per_cm = 0;
        m->layer[i].thickness_cm = log_uniform(0.01, 0.3);
    }
    if (family == 7) { /* one of them scatters 10 to 1000 times less and absorbs little */
        i = (int)uniform(0, layers);
        m->layer[i].mu_s_per_cm *= log_uniform(1e-3, 0.1);
        m->layer[i].mu_a_per_cm = 0.01 * m->layer[i].mu_s_per_cm;
        m->layer[i].thickness_cm = log_uniform(0.02, 0.5);
    }
    if (uniform(0, 1) < 0.4 && m->layer[layers - 1].mu_s_per_cm > 0 && m->layer[layers - 1].mu_a_per_cm > 0.01)
        m->layer[layers - 1].thickness_cm = 1e8;
    m->tissue.n_above = 1;
    m->tissue.n_below = matched ? 1 : uniform(0, 1) < 0.5 ? 1 : n;
    m->tissue.layer_count = layers;
    m->tissue.layers = m->layer;
}

/* Rings by the quantiles of a pilot run, then as many photons as the seconds allow, at most 4e6. */
static int reference_make(const random_medium *m, double seconds, reference *out)
{
    static const double quantile[EDGES - 1] = {0.997, 0.99, 0.97, 0.93, 0.85, 0.7,  0.5,
                                               0.3,   0.15, 0.07, 0.03, 0.01, 0.003};
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_grid grid;
    ms_mcml_result r;
    ms_mcml *tally;
    double finest = 0, start;
    uint64_t done = 0;
    int i, k, e, side, at[2][EDGES];
    memset(&grid, 0, sizeof grid);
    memset(out, 0, sizeof *out);
    for (i = 0; i < m->tissue.layer_count; ++i)
        finest = fmax(finest, m->layer[i].mu_a_per_cm + m->layer[i].mu_s_per_cm);
    grid.dr_cm = 0.02 / finest;
    grid.nr = 100000;
    grid.dz_cm = 1;
    grid.nz = grid.na = 1;
    options.no_absorption = 1;
    options.seed = 4711;
    for (;;) {
        options.photons = 20000;
        if (ms_mcml_simulate(&m->tissue, &grid, &options, &r, NULL) != MS_OK) return 1;
        for (side = 0; side < 2; ++side) {
            const double *v = side ? r.tt_r : r.rd_r, total = side ? r.tt : r.rd;
            double left = total;
            for (e = 0, k = 0; k + 1 < grid.nr && e < EDGES - 1; ++k) {
                left -= v[k] * ms_mcml__ring_area(k, grid.dr_cm);
                if (left < quantile[e] * total && (e == 0 || k + 1 > at[side][e - 1])) at[side][e++] = k + 1;
            }
            while (e < EDGES - 1) at[side][e] = (e ? at[side][e - 1] : 0) + 1, ++e;
            i = at[side][EDGES - 2];
            if (total > 1e-3 && i >= grid.nr - 1) break;
        }
        ms_mcml_result_destroy(&r);
        if (side == 2) break;
        grid.dr_cm *= 8;
    }
    options.seed = seed + 815;
    start = bench_cpu();
    if (ms_mcml_create(&m->tissue, &grid, &options, &tally, NULL) != MS_OK) return 1;
    while (done == 0 || (bench_cpu() - start < seconds && done < 4000000)) {
        if (ms_mcml_run(tally, done, 16384, NULL) != MS_OK) return 1;
        done += 16384;
    }
    out->seconds = bench_cpu() - start;
    if (ms_mcml_results(tally, &r, NULL) != MS_OK) return 1;
    ms_mcml_destroy(tally);
    out->photons = (double)done;
    for (side = 0; side < 2; ++side)
        for (e = 0; e < EDGES; ++e) {
            const int from = e ? at[side][e - 1] : 0, to = e < EDGES - 1 ? at[side][e] : grid.nr;
            double sum = 0, square = 0;
            for (k = from; k < to && k < grid.nr; ++k) {
                const double a = ms_mcml__ring_area(k, grid.dr_cm), p = a * (side ? r.tt_r : r.rd_r)[k],
                             s = a * (side ? r.tt_r_error : r.rd_r_error)[k];
                sum += p;
                square += s * s + p * p / (double)done;
            }
            out->edge[side][e] = from * grid.dr_cm;
            out->energy[side][e] = sum;
            out->error[side][e] = sqrt(fmax(square - sum * sum / (double)done, 0));
        }
    ms_mcml_result_destroy(&r);
    return 0;
}

typedef struct family_row {
    int media, photons[2], refused, rings, violations, bad_media, judged, within_ten;
    double worst, seconds;
} family_row;

int main(void)
{
    const char *text = getenv("MEDIA");
    char path[64];
    const double seconds = getenv("SECONDS") ? atof(getenv("SECONDS")) : 2;
    const int verbose = getenv("VERBOSE") ? atoi(getenv("VERBOSE")) : 0;
    static reference all[FAMILIES * EACH];
    static family_row row[FAMILIES + 1];
    int from = 0, to = FAMILIES * EACH - 1, i, e, side, f;
    double times[FAMILIES * EACH];
    ms_mcml_layered_options options;
    FILE *file, *md = bench_open("layered_errors.md");
    if (text && sscanf(text, "%d-%d", &from, &to) != 2) return 2;
    if (getenv("SEED")) seed = strtoull(getenv("SEED"), NULL, 10);
    snprintf(path, sizeof path, "build/bench/layered_%llu.bin", (unsigned long long)seed);
    if ((file = fopen(path, "rb")) != NULL) {
        if (fread(all, sizeof all, 1, file) != 1) memset(all, 0, sizeof all);
        fclose(file);
    }
    for (i = from; i <= to; ++i) {
        random_medium m;
        if (all[i].photons > 0) continue;
        medium_make(i, &m);
        if (reference_make(&m, seconds, &all[i])) {
            printf("medium %d: no reference\n", i);
            continue;
        }
        if (i % 10 == 9 || i == to) {
            if ((file = fopen(path, "wb")) == NULL || fwrite(all, sizeof all, 1, file) != 1 || fclose(file)) return 1;
        }
    }
    memset(&options, 0, sizeof options);
    options.photons = (uint64_t)(getenv("PHOTONS") ? atof(getenv("PHOTONS")) : 2e5);
    for (i = from; i <= to; ++i) {
        random_medium m;
        ms_mcml_layered s;
        ms_error failure;
        ms_status status;
        family_row *r = &row[i / EACH];
        double start = bench_cpu(), worst = 0;
        int bad = 0;
        medium_make(i, &m);
        if (!(all[i].photons > 0)) continue;
        status = ms_mcml_layered_solve(&m.tissue, &options, &s, &failure);
        times[i] = bench_cpu() - start;
        ++r->media;
        r->seconds += times[i];
        r->photons[0] += s.side[0].photons > 0;
        r->photons[1] += s.side[1].photons > 0;
        if (status != MS_OK) {
            ++r->refused;
            if (verbose) printf("%3d %.3f s: %s\n", i, times[i], failure.message);
            continue;
        }
        for (side = 0; side < 2; ++side) {
            const double total = side ? s.tt : s.rd;
            for (e = 0; e < EDGES; ++e) {
                const double r0 = all[i].edge[side][e], r1 = e < EDGES - 1 ? all[i].edge[side][e + 1] : 1e100 * 1e20;
                const double area = e < EDGES - 1 ? 3.14159265358979 * (r1 - r0) * (r1 + r0) : 0;
                double stated = 0, got, off, allowed, sigma = all[i].error[side][e], want = all[i].energy[side][e];
                if (!(want > 1e-3 * total) || !(total > 1e-3)) continue;
                if (e == EDGES - 1) continue;
                got = area * ms_mcml_layered_ring(&s, side, r0, r1, &stated);
                stated *= area;
                off = fabs(got - want);
                allowed = s.side[side].photons ? 4 * sqrt(sigma * sigma + stated * stated) : stated + 4 * sigma;
                ++r->rings;
                if (off > allowed) ++r->violations, bad = 1;
                worst = fmax(worst, (off - allowed) / want);
                if (!s.side[side].photons &&
                    (stated > 10 * sigma || off > 3 * sigma)) { /* the true error is seen beside the noise */
                    ++r->judged;
                    if (stated <= 10 * fmax(off, sigma)) ++r->within_ten;
                }
                if (verbose > 1 || (verbose && off > allowed))
                    printf(
                        "   %3d %c%s %2d %.4g-%.4g cm: %.4e, stated %.1f%%, off %+.1f%%, noise %.1f%%, energy %.2f%%\n",
                        i, side ? 'T' : 'R', s.side[side].photons ? " photons" : "", e, r0, r1, got,
                        100 * stated / want, 100 * (got - want) / want, 100 * sigma / want, 100 * want / total);
            }
        }
        r->bad_media += bad;
        if (worst > r->worst) r->worst = worst;
        if (verbose) {
            printf("%3d %.3f s order %d photons %d%d %s", i, times[i], s.order, s.side[0].photons > 0,
                   s.side[1].photons > 0, bad ? "VIOLATION" : "");
            printf(" worst %.3f |", worst);
            for (f = 0; f < m.tissue.layer_count; ++f)
                printf(" (%.2f %.3g %.3g %.2f %.3g)", m.layer[f].n, m.layer[f].mu_a_per_cm, m.layer[f].mu_s_per_cm,
                       m.layer[f].g, m.layer[f].thickness_cm);
            printf(" %.2f\n", m.tissue.n_below);
        }
    }
    fprintf(
        md,
        "| family | media | refused | R, T by photons | rings | beyond stated + 4 sigma | media with such | worst excess | stated within 10 times | s a medium |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (f = 0; f <= FAMILIES; ++f) {
        family_row *r = &row[f], *sum = &row[FAMILIES];
        if (f < FAMILIES) {
            sum->media += r->media, sum->photons[0] += r->photons[0], sum->photons[1] += r->photons[1],
                sum->refused += r->refused, sum->rings += r->rings;
            sum->violations += r->violations, sum->bad_media += r->bad_media, sum->judged += r->judged;
            sum->within_ten += r->within_ten, sum->seconds += r->seconds, sum->worst = fmax(sum->worst, r->worst);
        }
        fprintf(md, "| %s | %d | %d | %d, %d | %d | %d | %d | %.1f%% | %d of %d | %.2f |\n",
                f < FAMILIES ? family_name[f] : "**all**", r->media, r->refused, r->photons[0], r->photons[1], r->rings,
                r->violations, r->bad_media, 100 * r->worst, r->within_ten, r->judged,
                r->media ? r->seconds / r->media : 0);
    }
    fclose(md);
    return 0;
}
