/* The direct layered Monte Carlo of ms_mcml.h, all tallies of an .mco file on, and original MCML beside it where the
   environment names its program: MCML=path/to/mcml make bench. MCML 1.2.2 is at https://omlc.org/software/mc/mcml;
   build it with cc -O3 *.c -lm. Runs are taken in turn, the median of five is shown. MEDIUM=0 to 7: that row alone,
   half a minute; SCALE: of the photons; the tables are joined from the rows that there are. To build/bench/mcml.csv,
   .svg (of whole runs), .md. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "bench.h"
#include "plot.h"
#include <sys/resource.h>

#define RUNS 5
#define LEVELS 4

typedef struct medium {
    const char *name;
    double photons; /* for half a second or so at AVX2 */
    double dr, dz;
    int nr, nz, na, layer_count;
    ms_mcml_layer layers[3];
} medium;

static const medium media[] = {
    {"skin1 R", 1e6, 0.0033557, 0.01, 400, 100, 1, 1, {{1.3, 0.32, 7.4, 0, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"skin1 G", 2e6, 0.0033557, 0.01, 400, 100, 1, 1, {{1.3, 1.7, 8.8, 0, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"skin1 B", 3e6, 0.0033557, 0.01, 400, 100, 1, 1, {{1.3, 4.8, 10.1, 0, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"marble G", 2e5, 0.0016627, 0.01, 400, 100, 1, 1, {{1.5, 0.041, 26.2, 0, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"three layers (sample.mci)",
     8e5,
     0.01,
     0.01,
     50,
     40,
     1,
     3,
     {{1.37, 1, 100, 0.9, 0.1}, {1.37, 1, 10, 0, 0.1}, {1.37, 2, 10, 0.7, 0.2}}},
    {"ketchup B, dark", 4e6, 0.01, 0.01, 100, 100, 1, 1, {{1.3, 14.5, 0.3, 0, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"thin dark layer on bright",
     1e6,
     0.01,
     0.01,
     200,
     100,
     1,
     2,
     {{1.4, 90, 10, 0.8, 0.005}, {1.4, 0.5, 100, 0.8, 1e7}, {0, 0, 0, 0, 0}}},
    {"g = 0.9", 3e5, 0.01, 0.01, 100, 100, 30, 1, {{1.4, 1, 100, 0.9, 1e7}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
};
#define MEDIA ((int)(sizeof media / sizeof *media))

/* SCALE: more or less of them, on machines that are faster or have less time. */
static double photons_of(int m) { return media[m].photons * (getenv("SCALE") ? atof(getenv("SCALE")) : 1); }

static ms_mcml_result simulate(const medium *m, double photons, ms_mcml_options options)
{
    ms_mcml_tissue tissue;
    ms_mcml_grid grid;
    ms_mcml_result result;
    ms_error error;
    tissue.n_above = tissue.n_below = 1;
    tissue.layer_count = m->layer_count;
    tissue.layers = m->layers;
    memset(&grid, 0, sizeof grid);
    grid.dr_cm = m->dr;
    grid.dz_cm = m->dz;
    grid.nr = m->nr;
    grid.nz = m->nz;
    grid.na = m->na;
    options.photons = (uint64_t)photons;
    if (ms_mcml_simulate(&tissue, &grid, &options, &result, &error) != MS_OK) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    return result;
}

/* Variance of one photon: of Rd, of the profile Rd(r) in the L2 norm, and of the rings beyond 99% of Rd, each over its
   squared value; far rings with less than 1e-5 of Rd each do not count. */
static void variances(const ms_mcml_result *r, double *total, double *profile, double *far)
{
    double error = 0, value = 0, within = 0;
    int i;
    *far = 0;
    for (i = 0; i + 1 < r->grid.nr; ++i) {
        const double energy = r->rd_r[i] * ms_mcml__ring_area(i, r->grid.dr_cm), e = r->rd_r_error[i] / r->rd_r[i];
        within += energy;
        if (!(r->rd_r[i] > 0)) continue;
        if (within > 0.99 * r->rd && energy > 1e-5 * r->rd) *far += (double)r->photons * e * e;
    }
    for (i = 0; i + 1 < r->grid.nr; ++i) {
        error += (2 * i + 1) * r->rd_r_error[i] * r->rd_r_error[i];
        value += (2 * i + 1) * r->rd_r[i] * r->rd_r[i];
    }
    *total = (double)r->photons * (r->rd_error / r->rd) * (r->rd_error / r->rd);
    *profile = (double)r->photons * error / value;
}

static double children(void)
{
    struct rusage u;
    getrusage(RUSAGE_CHILDREN, &u);
    return (double)u.ru_utime.tv_sec + 1e-6 * (double)u.ru_utime.tv_usec;
}

/* Seconds a photon of original MCML. */
static double run_peer(const medium *m, const char *program, double photons)
{
    FILE *f = bench_open("peer.mci");
    char command[1200];
    double start;
    int i;
    fprintf(f, "1.0\n1\npeer.mco A\n%.0f\n%g %g\n%d %d %d\n%d\n1\n", photons, m->dz, m->dr, m->nz, m->nr, m->na,
            m->layer_count);
    for (i = 0; i < m->layer_count; ++i)
        fprintf(f, "%g %g %g %g %g\n", m->layers[i].n, m->layers[i].mu_a_per_cm, m->layers[i].mu_s_per_cm,
                m->layers[i].g, m->layers[i].thickness_cm);
    fprintf(f, "1\n");
    fclose(f);
    snprintf(command, sizeof command, "cd build/bench && '%s' peer.mci >/dev/null", program);
    start = children();
    if (system(command) != 0) {
        fprintf(stderr, "'%s' failed (give an absolute path in MCML)\n", program);
        exit(1);
    }
    return (children() - start) / photons;
}

/* What the options cost, at the best level: time, and time to equal error of Rd(r), against the defaults. */
static void options_row(FILE *md, int m)
{
    double t[4][RUNS], total, far, profile[4];
    int k, i;
    for (k = 0; k < RUNS; ++k)
        for (i = 0; i < 4; ++i) {
            ms_mcml_options options = ms_mcml_defaults();
            ms_mcml_result r;
            const double start = bench_cpu();
            options.roulette_weight = i == 1 ? 1e-4 : i == 2 ? 0.1 : 0;
            options.no_absorption = i == 3;
            r = simulate(&media[m], photons_of(m) / 2, options);
            t[i][k] = bench_cpu() - start;
            variances(&r, &total, &profile[i], &far);
            ms_mcml_result_destroy(&r);
        }
    fprintf(md, "| %s |", media[m].name);
    for (i = 0; i < 4; ++i) {
        const double ratio = bench_median(t[i], RUNS) / bench_median(t[0], RUNS);
        fprintf(md, " %.2f (%.2f) |", ratio, ratio * profile[i] / profile[0]);
    }
    fprintf(md, "\n");
}

static FILE *row_open(const char *kind, int m)
{
    char name[64];
    snprintf(name, sizeof name, "mcml_%s_%d.txt", kind, m);
    return bench_open(name);
}

/* The rows of all media, as far as they were run. */
static void join(FILE *out, const char *kind)
{
    int m, c;
    for (m = 0; m < MEDIA; ++m) {
        char path[100];
        FILE *f;
        snprintf(path, sizeof path, "build/bench/mcml_%s_%d.txt", kind, m);
        if ((f = fopen(path, "r")) == NULL) continue;
        while ((c = getc(f)) != EOF) putc(c, out);
        fclose(f);
    }
}

int main(void)
{
    static double peer[MEDIA], speed[LEVELS + 1][MEDIA];
    static plot p;
    const char *program = getenv("MCML"), *only = getenv("MEDIUM");
    const ms_simd best = ms__simd_pick(MS_SIMD_AUTO);
    FILE *csv, *md, *all;
    int m, level, k;

    if (program == NULL) printf("original MCML: not named (MCML=path), its columns stay empty\n");
    for (m = 0; m < MEDIA; ++m) {
        double t[LEVELS + 1][RUNS], peer_total = 0, peer_profile = 0, peer_far = 0, total = 0, profile = 0, far = 0,
                                    fastest = 0;
        if (only && atoi(only) != m) continue;
        md = row_open("row", m);
        csv = row_open("csv", m);
        for (k = 0; k < RUNS; ++k) {
            for (level = 1; level <= (int)best; ++level) {
                const double photons = photons_of(m) / (level == 1 ? 5 : level == 2 ? 2 : 1), start = bench_cpu();
                ms_mcml_options options = ms_mcml_defaults();
                ms_mcml_result r;
                options.simd = (ms_simd)level;
                r = simulate(&media[m], photons, options);
                t[level][k] = (bench_cpu() - start) / photons;
                if (level == (int)best) variances(&r, &total, &profile, &far);
                ms_mcml_result_destroy(&r);
            }
            t[0][k] = program ? run_peer(&media[m], program, photons_of(m) / 20) : 0;
        }
        if (program) { /* MCML prints no errors: its estimator is ours with its roulette, so that its variance is, too
                        */
            ms_mcml_options options = ms_mcml_defaults();
            ms_mcml_result r;
            options.roulette_weight = 1e-4;
            r = simulate(&media[m], photons_of(m), options);
            variances(&r, &peer_total, &peer_profile, &peer_far);
            ms_mcml_result_destroy(&r);
        }
        peer[m] = 1e9 * bench_median(t[0], RUNS);
        fprintf(md, "| %s |", media[m].name);
        if (program) fprintf(md, " %.0f |", peer[m]);
        else fprintf(md, " |");
        printf("%-26s MCML %7.0f ns", media[m].name, peer[m]);
        for (level = 1; level <= LEVELS; ++level) {
            double ns = level <= (int)best ? 1e9 * bench_median(t[level], RUNS) : 0;
            if (level > (int)best) {
                fprintf(md, " |");
                continue;
            }
            speed[level][m] = peer[m] / ns;
            fastest = ns;
            printf("  %s %.0f (%.1fx)", ms_simd_string((ms_simd)level), ns, peer[m] / ns);
            if (program) fprintf(md, " %.0f (%.1fx) |", ns, peer[m] / ns);
            else fprintf(md, " %.0f |", ns);
            fprintf(csv, "%s,%s,%.1f,%.1f,%.2f,%.2f,%.2f,%.2f\n", media[m].name, ms_simd_string((ms_simd)level), ns,
                    peer[m], peer[m] / ns, peer[m] * peer_total / (ns * total), peer[m] * peer_profile / (ns * profile),
                    far > 0 ? peer[m] * peer_far / (ns * far) : 0);
        }
        printf("  equal error: Rd %.1fx, Rd(r) %.1fx, far %.1fx\n", peer[m] * peer_total / (fastest * total),
               peer[m] * peer_profile / (fastest * profile), far > 0 ? peer[m] * peer_far / (fastest * far) : 0);
        if (program)
            fprintf(md, " %.1fx | %.1fx |", peer[m] * peer_total / (fastest * total),
                    peer[m] * peer_profile / (fastest * profile));
        else fprintf(md, " | |");
        if (program && far > 0 && peer_far > 0) fprintf(md, " %.1fx |\n", peer[m] * peer_far / (fastest * far));
        else fprintf(md, " |\n"); /* no ring out there holds 1e-5 */
        fclose(md);
        fclose(csv);
        md = row_open("option", m);
        options_row(md, m);
        fclose(md);
    }
    all = bench_open("mcml.csv");
    fprintf(
        all,
        "medium,level,ns_per_photon,mcml_ns_per_photon,times_mcml,equal_error_rd,equal_error_profile,equal_error_far\n");
    join(all, "csv");
    if (fclose(all) != 0) return 1;
    all = bench_open("mcml.md");
    fprintf(
        all,
        "\nNanoseconds a photon on one core of %s, all tallies of an `.mco` file (%s; `MCML=... make bench`). Equal error:\n"
        "how many times less time than MCML for the same standard error, at the best level.\n\n",
        bench_processor(), program ? "MCML 1.2.2 built with -O3, in turn with ours" : "without MCML");
    fprintf(
        all,
        "| medium | MCML | scalar | base | AVX2 | AVX-512 | equal error of Rd | of Rd(r) | of far rings |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    join(all, "row");
    fprintf(
        all,
        "\nTime against the defaults, and in brackets time for an equal error of Rd(r).\n\n"
        "| medium | defaults | roulette_weight 1e-4 | roulette_weight 0.1 | no_absorption |\n|---|---:|---:|---:|---:|\n");
    join(all, "option");
    fprintf(all, "\n");
    if (program && !only) {
        plot_begin(&p, "Layered Monte Carlo: photons a second over original MCML's", "MCML, ns a photon", "times MCML",
                   PLOT_LOG_X | PLOT_LOG_Y);
        for (level = 1; level <= (int)best; ++level)
            plot_series(&p, ms_simd_string((ms_simd)level), peer, speed[level], MEDIA, PLOT_DOTS);
        if (!plot_write(&p, "build/bench/mcml.svg")) return 1;
    }
    return fclose(all) != 0;
}
