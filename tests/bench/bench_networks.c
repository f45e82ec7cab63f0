/* The networks that ship: PSNR of the renderers on the 64 stored path-traced pictures (all of them in networks.csv, as
   a plot in networks.svg, the worst as pictures in networks_worst.png), the best of nine inversion networks, time
   (build/bench/networks.md). The files are made by `make train`. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "bench.h"
#include "networks.h"
#include "plot.h"

enum { COUNT = 500, WORST = 5, RENDERERS = 3 };
static const char *const paths[RENDERERS] = {"examples/data/renderer_128.safetensors",
                                             "examples/data/renderer_64.safetensors",
                                             "examples/data/preview_64.safetensors"};
static const char *const names[RENDERERS] = {"128 x 128", "64 x 64", "64 x 64, previews"};

static double uniform(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static double quantile(const double *sorted, int n, double q) { return sorted[(int)(q * (n - 1) + 0.5)]; }

typedef struct drawing {
    const neural *n;
    const float *x;
    float *planes;
} drawing;

static void draw(void *context)
{
    drawing *d = (drawing *)context;
    neural_render(d->n, d->x, 1, d->planes);
}

static double file_mb(const char *path)
{
    FILE *f = fopen(path, "rb");
    long size = 0;
    if (f && fseek(f, 0, SEEK_END) == 0) size = ftell(f);
    if (f) fclose(f);
    return 1e-6 * (double)size;
}

/* The worst of dB [64], worst first: the network's picture over the truth over four times their difference. */
static void draw_worst(const neural *n, const double *dB)
{
    int order[NETWORKS_TILES], i, k, size = n->size;
    size_t pixels = ms_nn_output_size(n->nn), p;
    materials list;
    image sheet = image_new(WORST * size, 3 * size, 3);
    float *truth = networks_truth(size);
    if (sheet.pixels && truth && materials_read("examples/data/materials.csv", NETWORKS_PARAMETERS, &list) == NULL) {
        for (i = 0; i < NETWORKS_TILES; ++i) {
            for (k = i; k > 0 && dB[order[k - 1]] > dB[i]; --k) order[k] = order[k - 1];
            order[k] = i;
        }
        for (i = 0; i < WORST; ++i) {
            float *t = truth + (size_t)order[i] * pixels;
            neural_render(n, list.x + order[i] * NETWORKS_PARAMETERS, 1, n->planes);
            neural_paste(n->planes, size, &sheet, i * size, 0);
            neural_paste(t, size, &sheet, i * size, size);
            for (p = 0; p < pixels; ++p) t[p] = 4 * fabsf(n->planes[p] - t[p]);
            neural_paste(t, size, &sheet, i * size, 2 * size);
        }
        image_write("build/bench/networks_worst.png", &sheet);
        materials_free(&list);
    }
    image_free(&sheet);
    free(truth);
}

int main(void)
{
    static plot p;
    double dB[RENDERERS][NETWORKS_TILES], sorted[RENDERERS][NETWORKS_TILES], share[NETWORKS_TILES], nine_ms = 0;
    double *rmse = (double *)malloc((NETWORKS_INVERSIONS + 1) * COUNT * sizeof(double)),
           *best = rmse + NETWORKS_INVERSIONS * COUNT;
    float *planes, x[COUNT * NETWORKS_PARAMETERS];
    neural n[RENDERERS];
    ms_error error;
    uint64_t state = 7;
    const char *problem;
    FILE *md, *csv;
    int k, i;
    md = bench_open("networks.md");
    csv = bench_open("networks.csv");
    if (md == NULL || csv == NULL || rmse == NULL) return 1;
    fprintf(
        md,
        "%s, one core, `make bench FILTER=networks`. PSNR of display values on 64 held-out path-traced materials.\n\n",
        bench_processor());
    fprintf(
        md,
        "| renderer | file, MB | mean, dB | least | 5%% | median | 95%% | ms a picture |\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < RENDERERS; ++k) {
        drawing d;
        bench_time time;
        double mean = 0;
        problem = networks_psnr(paths[k], &n[k], dB[k]);
        if (problem) {
            printf("%s: %s\n", paths[k], problem);
            return 1;
        }
        for (i = 0; i < NETWORKS_TILES; ++i) {
            mean += dB[k][i] / (double)NETWORKS_TILES;
            sorted[k][i] = dB[k][i];
        }
        bench_median(sorted[k], NETWORKS_TILES); /* sorts */
        for (i = 0; i < NETWORKS_PARAMETERS; ++i) x[i] = 0.5f;
        d.n = &n[k];
        d.x = x;
        d.planes = n[k].planes;
        time = bench_run(draw, &d, 33);
        fprintf(md, "| %s | %.1f | **%.2f** | %.1f | %.1f | %.1f | %.1f | %.3f |\n", names[k], file_mb(paths[k]), mean,
                sorted[k][0], quantile(sorted[k], NETWORKS_TILES, 0.05), quantile(sorted[k], NETWORKS_TILES, 0.5),
                quantile(sorted[k], NETWORKS_TILES, 0.95), 1e3 * time.median);
    }
    fprintf(md, "| thesis, 410 x 410, its own scene | 2097 | 37.96 | 26.05 | | | | |\n\n");
    fprintf(csv, "material,dB_128,dB_64,dB_preview\n");
    for (i = 0; i < NETWORKS_TILES; ++i) fprintf(csv, "%d,%.3f,%.3f,%.3f\n", i, dB[0][i], dB[1][i], dB[2][i]);
    fclose(csv);
    draw_worst(&n[0], dB[0]);
    plot_begin(&p, "Neural renderers: share of the held-out pictures below a PSNR", "PSNR, dB", "share", 0);
    for (i = 0; i < NETWORKS_TILES; ++i) share[i] = (i + 0.5) / (double)NETWORKS_TILES;
    for (k = 0; k < RENDERERS; ++k) plot_series(&p, names[k], sorted[k], share, NETWORKS_TILES, PLOT_LINE);
    plot_write(&p, "build/bench/networks.svg");

    planes = (float *)malloc(COUNT * ms_nn_output_size(n[1].nn) * sizeof(float));
    if (planes == NULL) return 1;
    networks_materials(x, COUNT, uniform, &state);
    neural_render(&n[1], x, COUNT, planes);
    problem = networks_invert(&n[1], planes, COUNT, rmse, NULL, &error);
    if (problem) {
        printf("inversion: %s\n", problem);
        return 1;
    }
    fprintf(
        md,
        "| inversion network, 64 x 64 | file, MB | ms | RMSE of 255: mean | median | 95%% | largest |\n|---|---:|---:|---:|---:|---:|---:|\n");
    for (i = 0; i < COUNT; ++i) best[i] = 1e9;
    for (k = 0; k <= NETWORKS_INVERSIONS; ++k) {
        double *e = k < NETWORKS_INVERSIONS ? rmse + k * COUNT : best, mean = 0;
        for (i = 0; i < COUNT; ++i) {
            mean += e[i] / (double)COUNT;
            if (k < NETWORKS_INVERSIONS) best[i] = fmin(best[i], e[i]);
        }
        bench_median(e, COUNT); /* sorts */
        if (k < NETWORKS_INVERSIONS) {
            char path[80];
            ms_nn *inversion;
            float out[NETWORKS_PARAMETERS];
            double t[33];
            snprintf(path, sizeof path, "examples/data/inversion_%d.safetensors", k + 1);
            if (ms_nn_load_file(path, NULL, &inversion, &error) != MS_OK) return 1;
            for (i = 0; i < 33; ++i) {
                double start = bench_cpu();
                ms_nn_forward(inversion, 1, planes, out, NULL);
                t[i] = 1e3 * (bench_cpu() - start);
            }
            ms_nn_destroy(inversion);
            nine_ms += bench_median(t, 33);
            fprintf(md, "| %d | %.1f | %.3f |", k + 1, file_mb(path), bench_median(t, 33));
        } else fprintf(md, "| **best of nine** | | %.2f |", nine_ms);
        fprintf(md, " %.2f | %.2f | %.2f | %.1f |\n", mean, quantile(e, COUNT, 0.5), quantile(e, COUNT, 0.95),
                e[COUNT - 1]);
    }
    fprintf(
        md,
        "\nOn %d pictures that the renderer makes of random materials. Thesis, Table 4.1, the reproducible picture: 5.94 (random start: 41.93).\n",
        (int)COUNT);
    fclose(md);
    free(rmse);
    free(planes);
    for (k = 0; k < RENDERERS; ++k) neural_free(&n[k]);
    return 0;
}
