/* The main call of each header: time beside error, in one run (build/bench/calls.md, README's second table). */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "users.h"
#include "networks.h"
#include "matcher.h"
#include "targets.h"
#include "bench.h"

enum { RUNS = 9, WIDTH = 1920, HEIGHT = 1080, PIXELS = WIDTH * HEIGHT, M = 19, SCORES = 250, COUNT = 300, USERS = 12 };
static FILE *md;

static void check(ms_status status, const ms_error *error)
{
    if (status == MS_OK) return;
    fprintf(stderr, "bench_calls: %s\n", error->message);
    exit(1);
}

static void check_problem(const char *problem)
{
    if (problem == NULL) return;
    fprintf(stderr, "bench_calls: %s\n", problem);
    exit(1);
}

static void row(const char *call, const char *input, double seconds, const char *error)
{
    const double ms = 1e3 * seconds;
    fprintf(md, "| `%s` | %s | %.*f | %s |\n", call, input, ms < 1 ? 2 : ms < 20 ? 1 : 0, ms, error);
    printf("%s: %.2f ms\n", call, ms);
}

/* --- ms_sss.h: a screen that is skin everywhere, smoothly curved --- */

typedef struct filtering {
    ms_sss_frame frame;
    ms_sss_kernel kernel;
    ms_sss_filter_options options;
    void *workspace;
    size_t size;
} filtering;

static void run_filter(void *context)
{
    filtering *f = (filtering *)context;
    ms_error error;
    check(ms_sss_filter(&f->frame, &f->kernel, 1, &f->options, f->workspace, f->size, &error), &error);
}

typedef struct making {
    ms_sss_kernel kernel;
    ms_sss_profile *profile;
} making;

static void run_kernel(void *context)
{
    making *k = (making *)context;
    ms_error error;
    check(ms_sss_kernel_make(&k->kernel, NULL, k->profile, 24, NULL, NULL, &error), &error);
}

static void subsurface_scattering(void)
{
    static const double reflectance[3] = {0.44, 0.22, 0.13}, distance_mm[3] = {1.2, 0.5, 0.3};
    static making k;
    static filtering f;
    float *light = (float *)malloc((size_t)PIXELS * 3 * sizeof(float)),
          *filtered = (float *)malloc((size_t)PIXELS * 3 * sizeof(float)),
          *depth = (float *)malloc((size_t)PIXELS * sizeof(float));
    ms_sss_errors errors;
    ms_error error;
    char text[80];
    int i;
    if (light == NULL || filtered == NULL || depth == NULL) check_problem("out of memory");
    check(ms_sss_profile_from_burley(&k.profile, reflectance, distance_mm, NULL, &error), &error);
    check(ms_sss_kernel_make(&f.kernel, &errors, k.profile, 24, NULL, NULL, &error), &error);
    f.options = ms_sss_filter_defaults();
    f.options.fov_degrees = 35;
    f.options.mm_per_unit = 1;
    for (i = 0; i < PIXELS; ++i) {
        const double x = (i % WIDTH) / 240.0, y = (i / WIDTH) / 240.0;
        depth[i] = (float)(600 + 8 * sin(x) * cos(y));
        light[3 * i] = light[3 * i + 1] = light[3 * i + 2] = (float)(0.5 + 0.5 * sin(9 * x + 5 * y));
    }
    f.frame.width = WIDTH;
    f.frame.height = HEIGHT;
    f.frame.input = ms_sss_interleaved(light, 3);
    f.frame.output = ms_sss_interleaved(filtered, 3);
    f.frame.depth = ms_sss_map(depth, 1);
    f.size = ms_sss_filter_workspace(WIDTH, HEIGHT, &f.kernel, 1, &f.options);
    f.workspace = malloc(f.size);
    row("ms_sss_filter", "1920 x 1080, skin everywhere, 7 taps", bench_run(run_filter, &f, RUNS).median,
        "the table above");
    snprintf(text, sizeof text, "%.1f%% of texture convolved in 2D", 100 * errors.texture);
    row("ms_sss_kernel_make", "7 taps from a color and three lengths", bench_run(run_kernel, &k, RUNS).median, text);
    ms_sss_profile_destroy(k.profile);
    free(light);
    free(filtered);
    free(depth);
    free(f.workspace);
}

/* --- ms_mcml.h: skin1 against the solver at its finest options --- */

static void make_profile(ms_mcml_profile *profile, double depth_step, double frequency_step, const double *edge_mm,
                         int rings)
{
    ms_mcml_medium skin[3];
    ms_mcml_profile_options options;
    ms_error error;
    int c;
    memset(&options, 0, sizeof options);
    options.depth_step = depth_step;
    options.frequency_step = frequency_step;
    options.edge_mm = edge_mm;
    options.rings = rings;
    for (c = 0; c < 3; ++c) skin[c] = ms_mcml_material_medium(ms_mcml_find_material("skin1"), c);
    check(ms_mcml_profile_make(profile, skin, 3, &options, &error), &error);
}

static void run_profile(void *context)
{
    ms_mcml_profile profile;
    (void)context;
    make_profile(&profile, 0, 0, NULL, 0);
    ms_mcml_profile_destroy(&profile);
}

static void diffusion_profile(void)
{
    ms_mcml_profile ours, fine;
    char input[80], text[80];
    double worst = 0;
    int c, i;
    make_profile(&ours, 0, 0, NULL, 0);
    make_profile(&fine, 0.28, 0.2, ours.edge_mm, ours.rings);
    for (c = 0; c < 3; ++c)
        for (i = 0; i < ours.rings; ++i) {
            const double *within = fine.within + c * (fine.rings + 1) + i, *rd = ours.rd_per_mm2 + c * ours.rings;
            if (within[1] - within[0] > 1e-5 * fine.total[c])
                worst = fmax(worst, fabs(rd[i] / fine.rd_per_mm2[c * fine.rings + i] - 1));
        }
    snprintf(input, sizeof input, "skin in 3 channels, %d rings", ours.rings);
    snprintf(text, sizeof text, "%.0e of a ring with 1e-5 of the light", worst);
    row("ms_mcml_profile_make", input, bench_run(run_profile, NULL, RUNS).median, text);
    ms_mcml_profile_destroy(&ours);
    ms_mcml_profile_destroy(&fine);
}

/* --- ms_gpr.h: users who like 10% of all materials --- */

static void taste(void)
{
    static double x[SCORES * M], y[SCORES], found[COUNT * M], fit_time[USERS], recommend_time[USERS], fresh[1000 * M],
        fresh_score[1000], mean[1000];
    double score = 0, uniform = 0, off = 0;
    char text[80];
    int i, k;
    for (i = 0; i < USERS; ++i) {
        person u = user_make((uint64_t)i, M, 0.1);
        uint64_t state = 900 + (uint64_t)i;
        ms_gpr *gp;
        ms_error error;
        double start;
        user_gallery(&u, SCORES, x, y, &state);
        user_gallery(&u, 1000, fresh, fresh_score, &state);
        start = bench_cpu();
        check(ms_gpr_fit(x, y, SCORES, M, NULL, &gp, NULL, &error), &error);
        fit_time[i] = bench_cpu() - start;
        check(ms_gpr_predict(gp, fresh, 1000, mean, NULL, &error), &error);
        for (k = 0; k < 1000; ++k) {
            const double truth = user_true(&u, fresh + k * M);
            off += pow(fmin(fmax(mean[k], 0), 10) - truth, 2) / 1000;
            uniform += truth / 1000;
        }
        start = bench_cpu();
        check(ms_gpr_recommend(gp, NULL, COUNT, found, NULL, NULL, NULL, &error), &error);
        recommend_time[i] = bench_cpu() - start;
        for (k = 0; k < COUNT; ++k) score += user_true(&u, found + k * M) / (int)COUNT;
        ms_gpr_destroy(gp);
    }
    snprintf(text, sizeof text, "%.1f of 10 from the true score, RMS", sqrt(off / (int)USERS));
    row("ms_gpr_fit", "250 scores of materials with 19 parameters", bench_median(fit_time, USERS), text);
    snprintf(text, sizeof text, "true score %.1f of 10 (any materials: %.1f)", score / (int)USERS,
             uniform / (int)USERS);
    row("ms_gpr_recommend", "300 new materials", bench_median(recommend_time, USERS), text);
}

/* --- ms_nn.h and ms_pme.h: the networks of examples/data --- */

typedef struct drawing {
    neural n;
    float x[NETWORKS_PARAMETERS];
} drawing;

static void run_forward(void *context)
{
    drawing *d = (drawing *)context;
    neural_render(&d->n, d->x, 1, d->n.planes);
}

static void picture(void)
{
    static drawing d;
    double dB[NETWORKS_TILES], mean = 0;
    char text[80];
    int i;
    check_problem(networks_psnr("examples/data/renderer_128.safetensors", &d.n, dB));
    for (i = 0; i < NETWORKS_TILES; ++i) mean += dB[i] / (int)NETWORKS_TILES;
    for (i = 0; i < NETWORKS_PARAMETERS; ++i) d.x[i] = 0.5f;
    snprintf(text, sizeof text, "%.1f dB from path-traced pictures", mean);
    row("ms_nn_forward", "a material's picture of 128 x 128", bench_run(run_forward, &d, 33).median, text);
    neural_free(&d.n);
}

static void match(void)
{
    enum { FIRST = 39, TARGETS = 21 }; /* the thesis's edits */
    static matcher m;
    image sheet;
    ms_error error;
    double x[NETWORKS_PARAMETERS], time[TARGETS], rmse[TARGETS];
    float *planes, *out;
    char text[80];
    int t;
    check(matcher_open(&m, "examples/data/renderer_64.safetensors", &error), &error);
    check(matcher_add_inversions(&m, "examples/data", &error), &error);
    check_problem(image_read("examples/data/materials.png", &sheet));
    planes = (float *)malloc(m.renderer.image_size * sizeof(float));
    out = (float *)malloc(m.renderer.image_size * sizeof(float));
    if (planes == NULL || out == NULL) check_problem("out of memory");
    for (t = 0; t < TARGETS; ++t) {
        ms_pme_match_result result;
        double start;
        check_problem(targets_make(&sheet, FIRST + t, planes));
        start = bench_cpu();
        check(matcher_aim(&m, planes, NULL, &error), &error);
        check(ms_pme_match(&m.renderer, planes, NULL, NULL, x, out, &result, &error), &error);
        time[t] = bench_cpu() - start;
        rmse[t] = 255 * result.rmse;
    }
    snprintf(text, sizeof text, "%.1f of 255 left, median of %d edits", bench_median(rmse, TARGETS), (int)TARGETS);
    row("ms_pme_match", "an edited picture of 64 x 64", bench_median(time, TARGETS), text);
    matcher_close(&m);
    image_free(&sheet);
    free(planes);
    free(out);
}

int main(void)
{
    md = bench_open("calls.md");
    fprintf(md,
            "One core of %s, gcc -O2, thread CPU time, medians; `make bench FILTER=calls`.\n\n"
            "| call | input | ms | error |\n|---|---|---:|---|\n",
            bench_processor());
    subsurface_scattering();
    diffusion_profile();
    taste();
    picture();
    match();
    return fclose(md) != 0;
}
