/* Kernels of ms_sss.h: errors of every model on d'Eon's skin beside the study in design.md, on the thesis's 11
   materials, error against taps, and how long making a kernel takes. Build: see Makefile (make bench). */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "bench.h"
#include "plot.h"

typedef struct bench_model {
    const char *name;
    ms_sss_model model;
    int terms;
    double study[3]; /* vertical step, 45 degree step, texture, % (design.md, skin at 96 pixels) */
} bench_model;

static const bench_model models[] = {
    {"R_d sampled along the axis", MS_SSS_SLICE, 1, {7.7, 8.2, 22.2}},
    {"one Gaussian", MS_SSS_GAUSSIANS, 1, {7.2, 8.7, 18.8}},
    {"SVD rank 1, normalized", MS_SSS_SVD_NORMALIZED, 1, {6.5, 6.3, 16.4}},
    {"pre-integrated", MS_SSS_PREINTEGRATED, 1, {0, 3.0, 7.4}},
    {"image-optimal, 33 taps", MS_SSS_IMAGE_OPTIMAL, 1, {2.0, 1.2, 3.7}},
    {"SVD rank 2, normalized", MS_SSS_SVD_NORMALIZED, 2, {1.6, 1.2, 2.6}},
    {"pre-integrated + 1 residual", MS_SSS_RESIDUAL, 2, {0, 0.9, 1.2}},
    {"six Gaussians", MS_SSS_GAUSSIANS, 6, {0.05, 0.06, 0.11}},
};
enum { MODELS = sizeof models / sizeof models[0] };

static void stop(const char *what, const ms_error *error)
{
    fprintf(stderr, "bench_sss_kernel: %s: %s\n", what, error->message);
    exit(1);
}

/* d'Eon and Luebke's six Gaussians for skin (GPU Gems 3, chapter 14). */
static ms_sss_profile *skin(void)
{
    static const double variance[6] = {0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};
    static const double weight[6][3] = {{0.233, 0.455, 0.649}, {0.1, 0.336, 0.344}, {0.118, 0.198, 0},
                                        {0.113, 0.007, 0.007}, {0.358, 0.004, 0},   {0.078, 0, 0}};
    double sigma[6][3];
    ms_sss_profile *p = NULL;
    ms_error error;
    int i, c;
    for (i = 0; i < 6; ++i)
        for (c = 0; c < 3; ++c) sigma[i][c] = sqrt(variance[i]);
    if (ms_sss_profile_from_gaussians(&p, 6, (const double(*)[3])sigma, weight, NULL, &error) != MS_OK)
        stop("skin", &error);
    return p;
}

static ms_sss_profile *material(const ms_mcml_material *m)
{
    ms_mcml_medium medium[3];
    ms_mcml_profile rings;
    const double *rd[3];
    ms_sss_profile *p = NULL;
    ms_error error;
    int c;
    for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(m, c);
    if (ms_mcml_profile_make(&rings, medium, 3, NULL, &error) != MS_OK) stop(m->name, &error);
    for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
    if (ms_sss_profile_from_rings(&p, rings.rings, rings.edge_mm, rd, 1, NULL, &error) != MS_OK) stop(m->name, &error);
    ms_mcml_profile_destroy(&rings);
    return p;
}

static ms_sss_designer *designer(const ms_sss_profile *p, double radius_px)
{
    ms_sss_designer *d = NULL;
    ms_error error;
    if (ms_sss_designer_create(&d, p, radius_px, NULL, &error) != MS_OK) stop("designer", &error);
    return d;
}

static ms_sss_errors errors_of(const ms_sss_designer *d, const ms_sss_kernel_options *o, double *milliseconds)
{
    static ms_sss_kernel k;
    ms_sss_errors e;
    ms_error error;
    double t[5];
    int n, runs = milliseconds ? 5 : 1;
    for (n = 0; n < runs; ++n) {
        t[n] = bench_cpu();
        if (ms_sss_kernel_build(&k, d, o, &error) != MS_OK) stop("kernel", &error);
        t[n] = bench_cpu() - t[n];
    }
    ms_sss_kernel_measure(&e, &k, d);
    if (milliseconds) *milliseconds = 1e3 * bench_median(t, runs);
    return e;
}

static ms_sss_kernel_options dense(const bench_model *m)
{
    ms_sss_kernel_options o = ms_sss_kernel_defaults();
    o.model = m->model;
    o.term_count = m->terms;
    if (m->model == MS_SSS_IMAGE_OPTIMAL) {
        o.tap_count = 33;
    } else {
        o.tap_count = MS_SSS_DENSE;
        o.no_delta = 1;
    }
    return o;
}

static void table_of_models(FILE *md, FILE *csv, const ms_sss_profile *p)
{
    ms_sss_designer *d = designer(p, 96);
    int n;
    fprintf(
        md,
        "Relative RMSE in %% against the 2D convolution, d'Eon's skin, 99%% radius 96 pixels, a tap every pixel where none are\n"
        "named; in brackets the "
        "float64 study of design.md.\n\n"
        "| model | 1D passes | vertical step | 45 degree step | 1/f texture | made in ms |\n|---|---:|---:|---:|---:|---:|\n");
    for (n = 0; n < MODELS; ++n) {
        ms_sss_kernel_options o = dense(&models[n]);
        double ms;
        ms_sss_errors e = errors_of(d, &o, &ms);
        fprintf(md, "| %s | %d | %.2f (%g) | %.2f (%g) | %.2f (%g) | %.1f |\n", models[n].name, 2 * models[n].terms,
                100 * e.vertical_step, models[n].study[0], 100 * e.diagonal_step, models[n].study[1], 100 * e.texture,
                models[n].study[2], ms);
        fprintf(csv, "model,deon,%s,%.6g,%.6g,%.6g,%.4g\n", models[n].name, e.vertical_step, e.diagonal_step, e.texture,
                ms);
    }
    ms_sss_designer_destroy(d);
}

static void table_of_materials(FILE *md, FILE *csv)
{
    int count, i, n;
    const ms_mcml_material *m = ms_mcml_materials(&count);
    fprintf(
        md,
        "\nThe thesis's materials from the half-space solver, the same way: vertical step / 45 degree step / 1/f texture, %%.\n\n| material |");
    for (n = 0; n < MODELS; ++n) fprintf(md, " %s |", models[n].name);
    fprintf(md, "\n|---|");
    for (n = 0; n < MODELS; ++n) fprintf(md, "---:|");
    fprintf(md, "\n");
    for (i = 0; i < count; ++i) {
        ms_sss_profile *p = material(&m[i]);
        ms_sss_designer *d = designer(p, 96);
        fprintf(md, "| %s |", m[i].name);
        for (n = 0; n < MODELS; ++n) {
            ms_sss_kernel_options o = dense(&models[n]);
            ms_sss_errors e = errors_of(d, &o, NULL);
            fprintf(md, " %.1f / %.1f / %.1f |", 100 * e.vertical_step, 100 * e.diagonal_step, 100 * e.texture);
            fprintf(csv, "model,%s,%s,%.6g,%.6g,%.6g,\n", m[i].name, models[n].name, e.vertical_step, e.diagonal_step,
                    e.texture);
        }
        fprintf(md, "\n");
        ms_sss_designer_destroy(d);
        ms_sss_profile_destroy(p);
    }
}

enum { COUNTS = 7, KINDS = 5 };
static void table_of_taps(FILE *md, FILE *csv, const ms_sss_profile *p, double radius, plot *picture,
                          double error[KINDS][COUNTS], double taps[COUNTS])
{
    static const int count[COUNTS] = {5, 7, 9, 11, 17, 25, 33};
    static const char *const name[KINDS] = {"a_p, quadratic (thesis)", "a_p, quantiles", "optimized",
                                            "optimized + delta", "two terms, optimized"};
    ms_sss_designer *d = designer(p, radius);
    double ms[KINDS];
    int i, n;
    fprintf(
        md,
        "\nError on 1/f texture, %%, against taps of one pass, 99%% radius %g pixels; in brackets ms to make the kernel.\n\n| taps |",
        radius);
    for (n = 0; n < KINDS; ++n) fprintf(md, " %s |", name[n]);
    fprintf(md, "\n|---:|");
    for (n = 0; n < KINDS; ++n) fprintf(md, "---:|");
    for (i = 0; i < COUNTS; ++i) {
        fprintf(md, "\n| %s%d%s |", count[i] == 7 ? "**" : "", count[i], count[i] == 7 ? "**" : "");
        taps[i] = count[i];
        for (n = 0; n < KINDS; ++n) {
            ms_sss_kernel_options o = ms_sss_kernel_defaults();
            o.tap_count = count[i];
            o.no_delta = n == 2;
            if (n < 2) o.model = MS_SSS_PREINTEGRATED;
            if (n == 0) o.placement = MS_SSS_QUADRATIC;
            if (n == 1) o.placement = MS_SSS_QUANTILE;
            if (n == 4) o.model = MS_SSS_RESIDUAL;
            if (n == 4 && count[i] > 17) { /* seconds, for errors nobody sees */
                error[n][i] = sqrt(-1.0);
                fprintf(md, " |");
                continue;
            }
            error[n][i] = errors_of(d, &o, &ms[n]).texture;
            fprintf(md, " %.2f (%.1f) |", 100 * error[n][i], ms[n]);
            fprintf(csv, "taps,%g,%s,%d,%.6g\n", radius, name[n], count[i], error[n][i]);
        }
    }
    fprintf(md, "\n");
    if (picture)
        for (n = 0; n < KINDS; ++n) plot_series(picture, name[n], taps, error[n], COUNTS, PLOT_LINE | PLOT_DOTS);
    ms_sss_designer_destroy(d);
}

int main(void)
{
    static plot picture;
    static double error[2][KINDS][COUNTS], taps[COUNTS];
    ms_sss_profile *p = skin();
    FILE *md, *csv;
    md = bench_open("sss_kernel.md");
    csv = bench_open("sss_kernel.csv");
    fprintf(md, "%s, one core, -O2; `make bench FILTER=sss_kernel`\n\n", bench_processor());
    plot_begin(&picture, "Kernels for skin, 99% radius 24 pixels", "taps of one pass", "relative error on 1/f texture",
               PLOT_LOG_X | PLOT_LOG_Y);
    table_of_models(md, csv, p);
    table_of_materials(md, csv);
    table_of_taps(md, csv, p, 96, NULL, error[0], taps);
    table_of_taps(md, csv, p, 24, &picture, error[1], taps);
    fclose(md);
    fclose(csv);
    if (!plot_write(&picture, "build/bench/sss_kernel.svg")) return 1;
    ms_sss_profile_destroy(p);
    return 0;
}
