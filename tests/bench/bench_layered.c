/* Layers: time against error of the layered solver and of the Monte Carlo beside it (and original MCML's by its
   nanoseconds a photon, RESULTS.md's table of bench_mcml), on the same rings. MEDIUM=0
   to 3: that medium alone; the table is joined from the rows that there are. To build/bench/layered_N.txt,
   layered.md. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "../../examples/tools/layered.h"
#include "bench.h"

#define RINGS 14

typedef struct medium {
    const char *name;
    double ring_cm; /* the first; each is 1.4 times as wide */
    int layer_count;
    double n_below;
    ms_mcml_layer layers[3];
} medium;

static const medium media[] = {
    {"skin, three layers", 0.003, 3, 1.44, {{1.4, 4, 40, 0, 0.006}, {1.4, 0.5, 36, 0, 0.15}, {1.44, 0.2, 24, 0, 1e8}}},
    {"half-space", 0.01, 1, 1, {{1.4, 1, 10, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"slab of 10 mean free paths", 0.01, 1, 1, {{1.4, 1, 99, 0, 0.1}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
    {"ketchup B, dark", 0.01, 1, 1, {{1.3, 14.5, 0.3, 0, 1e8}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}},
};

/* Root mean square over rings that hold 1e-3 of the energy of the relative difference, and of its standard error. */
static void compare(const double *got, const ms_mcml_result *r, const double *edge, double *error, double *noise)
{
    double sum = 0, noises = 0;
    int i, k, n = 0;
    for (i = 0; i < RINGS; ++i) {
        double energy = 0, square = 0, area = 3.14159265358979 * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]);
        for (k = 0; k < r->grid.nr - 1; ++k) {
            const double low = k * r->grid.dr_cm, high = low + r->grid.dr_cm,
                         a = 3.14159265358979 * (high * high - low * low);
            if (low < edge[i] * (1 - 1e-9) || high > edge[i + 1] * (1 + 1e-9)) continue;
            energy += a * r->rd_r[k];
            square += a * a * r->rd_r_error[k] * r->rd_r_error[k];
        }
        if (!(energy > 1e-3 * r->rd)) continue;
        if (got) sum += (got[i] * area / energy - 1) * (got[i] * area / energy - 1);
        noises += square / (energy * energy);
        ++n;
    }
    *error = n ? sqrt(sum / n) : 0;
    *noise = n ? sqrt(noises / n) : 0;
}

int main(void)
{
    FILE *md;
    char name[64];
    const char *only = getenv("MEDIUM"), *photons = getenv("PHOTONS");
    int m, i;
    for (m = 0; m < (int)(sizeof media / sizeof *media); ++m) {
        const medium *d = &media[m];
        ms_mcml_tissue tissue;
        ms_mcml_grid grid;
        ms_mcml_options options = ms_mcml_defaults();
        ms_mcml_result r;
        ms_error failure;
        double edge[RINGS + 1], got[RINGS], error, noise, seconds, t[5];
        if (only && atoi(only) != m) continue;
        snprintf(name, sizeof name, "layered_%d.txt", m);
        md = bench_open(name);
        tissue.n_above = 1;
        tissue.n_below = d->n_below;
        tissue.layer_count = d->layer_count;
        tissue.layers = d->layers;
        edge[0] = 0;
        for (i = 0; i < RINGS; ++i) edge[i + 1] = edge[i] + d->ring_cm * ceil(pow(1.4, i));
        memset(&grid, 0, sizeof grid);
        grid.dr_cm = d->ring_cm;
        grid.dz_cm = 1;
        grid.nr = (int)(edge[RINGS] / d->ring_cm + 1.5);
        grid.nz = grid.na = 1;
        options.photons = (uint64_t)(photons ? atof(photons) : 1.5e7);
        options.no_absorption = 1;
        seconds = bench_cpu();
        if (ms_mcml_simulate(&tissue, &grid, &options, &r, &failure) != MS_OK) return 1;
        seconds = bench_cpu() - seconds;
        compare(NULL, &r, edge, &error, &noise);
        fprintf(md, "| %s | Monte Carlo | %.3g s | 3e-03 | |\n", d->name, seconds * noise * noise / 9e-6);
        printf("%s: Monte Carlo %.3g s, noise %.2e; %.3g s for 0.3%%\n", d->name, seconds, noise,
               seconds * noise * noise / 9e-6);
        {
            ms_mcml_layered_options o;
            ms_mcml_layered y;
            memset(&o, 0, sizeof o);
            memset(&y, 0, sizeof y);
            for (i = 0; i < 5; ++i) {
                const double start = bench_cpu();
                const ms_status status = ms_mcml_layered_solve(&tissue, &o, &y, &failure);
                t[i] = bench_cpu() - start;
                if (status != MS_OK) return puts(failure.message), 1;
            }
            seconds = bench_median(t, 5);
            for (i = 0; i < RINGS; ++i) got[i] = ms_mcml_layered_ring(&y, 0, edge[i], edge[i + 1], NULL);
            compare(got, &r, edge, &error, &noise);
            fprintf(md, "| %s | layered solver | %.3g s | %.0e | %.0e |\n", d->name, seconds, error, noise);
            printf("%s: %.3g s, error %.2e\n", d->name, seconds, error);
        }
        fclose(md);
        ms_mcml_result_destroy(&r);
    }
    md = bench_open("layered.md");
    fprintf(
        md,
        "Reflectance in rings that hold 1e-3 of the energy, one core of %s, gcc -O2, `make bench FILTER=layered` (MEDIUM=0 to 3 alone,\n"
        "PHOTONS). Error: root mean square, relative to our Monte Carlo of %s photons, whose own noise stands beside it. Monte Carlo: its time\n"
        "for a noise of 0.3%%; MCML 1.2.2's is in the table above.\n\n"
        "| medium | way | time | error | noise of the reference |\n|---|---|---:|---:|---:|\n",
        bench_processor(), photons ? photons : "1.5e7");
    for (m = 0; m < (int)(sizeof media / sizeof *media); ++m) {
        char path[100];
        FILE *f;
        snprintf(path, sizeof path, "build/bench/layered_%d.txt", m);
        if ((f = fopen(path, "r")) == NULL) continue;
        while ((i = getc(f)) != EOF) putc(i, md);
        fclose(f);
    }
    return fclose(md) != 0;
}
