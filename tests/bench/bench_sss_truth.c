/* Pictures filtered by every kernel model of ms_sss.h against a random walk through the bust (skin1) and the knot
   (marble): a table of PSNR in build/bench/sss_truth.md and .csv, and the pictures.
   peer libraries: -lembree3 -lembree4 */
#include "bench.h"
#if defined(HAVE_EMBREE3) || defined(HAVE_EMBREE4)
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/truth.h"

enum { ROWS = TRUTH_MODELS + 3, SCENES = 4, SIGMAS = 7, SWEPT = 2 };

/* The first two scenes fill the table of kernels, all the one of depth sigmas. */
static const struct {
    const char *name;
    scene_object object;
    truth_substance substance;
    int walks;
} scenes[SCENES] = {{"bust, skin1", SCENE_BUST, TRUTH_SKIN, 256},
                    {"knot, marble", SCENE_KNOT, TRUTH_MARBLE, 256},
                    {"bust, marble", SCENE_BUST, TRUTH_MARBLE, 64},
                    {"knot, skin1", SCENE_KNOT, TRUTH_SKIN, 64}};
static const double sigmas[SIGMAS] = {0.06, 0.085, TRUTH_SIGMA, 0.17, 0.24, 0.333, 0.5};
static const truth_model swept[SWEPT] = {{"pre-integrated", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0, 0},
                                         {"image-optimal, 7 taps", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0, 0}};

/* Rows of the table of depth sigmas for one scene. */
static int sweep(const truth *t, const char *name, const ms_sss_designer *designer, image *picture, FILE *out)
{
    int k, i;
    for (k = 0; k < SWEPT; ++k) {
        ms_sss_kernel kernel;
        double error[SIGMAS], least = 1e9;
        if (truth_kernel(designer, &swept[k], &kernel) != MS_OK) return 0;
        for (i = 0; i < SIGMAS; ++i) {
            if (truth_filter(t, &kernel, sigmas[i], picture) != MS_OK) return 0;
            error[i] = truth_compare(t, picture).relative;
            if (error[i] < least) least = error[i];
        }
        fprintf(out, "| %s; %s |", name, swept[k].name);
        for (i = 0; i < SIGMAS; ++i) fprintf(out, error[i] > least ? " %.1f%% |" : " **%.1f%%** |", 100 * error[i]);
        fputs("\n", out);
    }
    return 1;
}

static void row(const truth *t, const char *file, const image *picture, truth_error *result)
{
    *result = truth_compare(t, picture);
    truth_save(t, picture, file);
}

int main(void)
{
    static const char *const object_name[] = {"bust", "knot"};
    static truth_error result[2][ROWS];
    const char *name[ROWS];
    char path[100];
    double radius_px[2] = {0, 0}, seconds[2];
    int object, i;
    FILE *md = bench_open("sss_truth.md"), *csv = bench_open("sss_truth.csv");
    FILE *depths = tmpfile();
    if (depths == NULL) return 1;
    for (object = 0; object < SCENES; ++object) {
        truth t;
        const char *problem;
        ms_sss_designer *designer;
        image picture;
        double start = bench_cpu();
        if (!truth_make(&t, scenes[object].object, scenes[object].substance, 240, 135, scenes[object].walks, 1, NULL, &problem)) {
            fprintf(stderr, "%s\n", problem);
            return 1;
        }
        picture = image_new(t.width, t.height, 3);
        if (picture.pixels == NULL || ms_sss_designer_create(&designer, t.profile, t.radius_px, NULL, NULL) != MS_OK)
            return 1;
        if (!sweep(&t, scenes[object].name, designer, &picture, depths)) return 1;
        if (object < 2) {
            seconds[object] = bench_cpu() - start;
            radius_px[object] = t.radius_px;
        }
        for (i = 0; i < ROWS && object < 2; ++i) {
            snprintf(path, sizeof path, "build/bench/sss_truth_%s_%d.png", object_name[object], i);
            name[i] = i == 0          ? "unfiltered"
                      : i == ROWS - 2 ? "2D kernel, distances on the screen"
                      : i == ROWS - 1 ? "2D kernel, distances in space"
                                      : truth_models[i - 1].name;
            if (i == 0) {
                memcpy(picture.pixels, t.lit->unfiltered.pixels, image_count(&picture) * sizeof(float));
            } else if (i >= ROWS - 2) {
                truth_filter_2d(&t, i == ROWS - 1, &picture);
            } else {
                ms_sss_kernel kernel;
                if (truth_kernel(designer, &truth_models[i - 1], &kernel) != MS_OK ||
                    truth_filter(&t, &kernel, truth_models[i - 1].sigma, &picture) != MS_OK)
                    return 1;
            }
            row(&t, path, &picture, &result[object][i]);
        }
        for (i = 0; i < (int)image_count(&picture); ++i)
            picture.pixels[i] = 0.5f * (t.lit->half[0].pixels[i] + t.lit->half[1].pixels[i]);
        if (object < 2) {
            snprintf(path, sizeof path, "build/bench/sss_truth_%s.png", object_name[object]);
            truth_save(&t, &picture, path);
        }
        ms_sss_designer_destroy(designer);
        image_free(&picture);
        truth_free(&t);
    }
    fprintf(
        md,
        "Random walk: 240 x 135 pixels, 2 x 256 walks a pixel and channel, %.0f and %.0f s on one core of %s; skin1 on "
        "a bust of\n"
        "70 mm (99%% radius %.0f px), marble on a knot of 50 mm (%.0f px), one lamp. Error: root mean square over that "
        "of the truth,\n"
        "on the object's pixels, the truth's noise taken out. PSNR: below the brightest unfiltered value. `make "
        "bench`.\n\n"
        "| kernel (dense taps) | bust, error | bust, PSNR | knot, error | knot, PSNR |\n|---|---:|---:|---:|---:|\n",
        seconds[0], seconds[1], bench_processor(), radius_px[0], radius_px[1]);
    fprintf(csv, "kernel,bust_error,bust_psnr,knot_error,knot_psnr\n");
    for (i = 0; i < ROWS; ++i) {
        const truth_error *a = &result[0][i], *b = &result[1][i];
        const char *bold = strstr(name[i], "(default)") ? "**" : "";
        fprintf(md, "| %s%s%s | %.1f%% | %.1f dB | %.1f%% | %.1f dB |\n", bold, name[i], bold, 100 * a->relative, a->psnr,
                100 * b->relative, b->psnr);
        fprintf(csv, "\"%s\",%.5f,%.3f,%.5f,%.3f\n", name[i], a->relative, a->psnr, b->relative, b->psnr);
        printf("%-36s bust %5.1f%% %5.1f dB   knot %5.1f%% %5.1f dB\n", name[i], 100 * a->relative, a->psnr,
               100 * b->relative, b->psnr);
    }
    fprintf(md, "\nThe same error against the sigma of the depth weights, in 99%% radii; default %.2f, least in bold. Bust of marble, knot\n"
                "of skin: 2 x 64 walks.\n\n| scene; kernel |",
            TRUTH_SIGMA);
    for (i = 0; i < SIGMAS; ++i) fprintf(md, " %.3g |", sigmas[i]);
    fprintf(md, "\n|---|%s\n", "---:|---:|---:|---:|---:|---:|---:|");
    rewind(depths);
    while ((i = getc(depths)) != EOF) putc(i, md);
    fclose(depths);
    return (fclose(md) | fclose(csv)) != 0;
}
#else
int main(void)
{
    puts("bench_sss_truth: Embree is not installed (make deps); skipped");
    return 0;
}
#endif
