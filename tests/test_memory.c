/* Memory over long use. Every call that allocates, in a few workflows of all five headers in one file: each allocation
   fails in turn, and nothing may stay behind (the tests of each header do this to its single calls). And the same
   frames and fits many times: no byte more after the last than after the first. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "test.h"
#include <unistd.h>

/* What the calls with files write; programs of several builds run at once. */
static const char *scratch(void)
{
    static char path[64];
    snprintf(path, sizeof path, "build/test_memory.%ld", (long)getpid());
    return path;
}

/* Runs `call` while the step before it went well. */
#define STEP(call)                            \
    do {                                      \
        if (status == MS_OK) status = (call); \
    } while (0)

/* --- workflows --- */

/* Optical coefficients to profiles: the solver, Monte Carlo, the sums of a tally added to another. */
static ms_status transport(const ms_allocator *allocator)
{
    const ms_mcml_layer layer = {1.4, 1, 100, 0.9, 0.1};
    ms_mcml_tissue tissue;
    ms_mcml_grid grid;
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_medium medium;
    ms_mcml_profile_options how;
    ms_mcml_profile profile;
    ms_mcml_result result;
    ms_mcml *tally = NULL, *copy = NULL;
    ms_status status;
    memset(&result, 0, sizeof result);
    memset(&grid, 0, sizeof grid);
    memset(&medium, 0, sizeof medium);
    memset(&how, 0, sizeof how);
    tissue.n_above = tissue.n_below = 1;
    tissue.layer_count = 1;
    tissue.layers = &layer;
    grid.dr_cm = grid.dz_cm = 0.1;
    grid.nr = grid.nz = 4;
    grid.na = 1;
    medium.mu_a_per_mm = 0.1;
    medium.mu_s_per_mm = 1;
    medium.eta = 1.3;
    how.depth_step = how.frequency_step = 1;
    options.allocator = how.allocator = *allocator;
    status = ms_mcml_create(&tissue, &grid, &options, &tally, NULL);
    STEP(ms_mcml_run(tally, 0, 10, NULL));
    STEP(ms_mcml_create(&tissue, &grid, &options, &copy, NULL));
    if (status == MS_OK) {
        size_t count;
        const int64_t *sums = ms_mcml_sums(tally, &count);
        status = ms_mcml_add(copy, sums, count, NULL);
    }
    STEP(ms_mcml_results(tally, &result, NULL));
    STEP(ms_mcml_profile_make(&profile, &medium, 1, &how, NULL));
    if (status == MS_OK) ms_mcml_profile_destroy(&profile);
    ms_mcml_result_destroy(&result);
    ms_mcml_destroy(copy);
    ms_mcml_destroy(tally);
    return status;
}

/* Every source of a profile, every way to a kernel. */
static ms_status kernels(const ms_allocator *allocator)
{
    static ms_sss_kernel kernel;
    const double edge[3] = {0, 1, 2}, radius[3] = {0.5, 1, 2}, fall[3] = {3, 1, 0.1}, *value[3];
    const double one[3] = {1, 1, 1}, sigma[1][3] = {{1, 0.5, 0.25}}, weight[1][3] = {{1, 1, 1}};
    ms_sss_profile *profile[4] = {NULL, NULL, NULL, NULL};
    ms_sss_designer *designer = NULL;
    ms_sss_errors errors;
    ms_status status;
    int i;
    value[0] = value[1] = value[2] = fall;
    status = ms_sss_profile_from_rings(&profile[0], 2, edge, value, 1, allocator, NULL);
    STEP(ms_sss_profile_from_samples(&profile[1], 3, radius, value, 1, allocator, NULL));
    STEP(ms_sss_profile_from_gaussians(&profile[2], 1, sigma, weight, allocator, NULL));
    STEP(ms_sss_profile_from_burley(&profile[3], one, one, allocator, NULL));
    STEP(ms_sss_designer_create(&designer, profile[2], 4, allocator, NULL));
    STEP(ms_sss_kernel_build(&kernel, designer, NULL, NULL));
    STEP(ms_sss_kernel_measure(&errors, &kernel, designer));
    ms_sss_designer_destroy(designer);
    for (i = 0; i < 4; ++i) ms_sss_profile_destroy(profile[i]);
    return status;
}

static ms_status render(void *user, const double *x, float *picture)
{
    (void)user;
    picture[0] = (float)(x[0] * x[0]);
    picture[1] = (float)(x[0] * x[1]);
    picture[2] = (float)(x[0] + 2 * x[1]);
    return MS_OK;
}

/* Scores to a preference; recommendations, a plane of them. */
static ms_status preference(const ms_allocator *allocator)
{
    enum { N = 8, M = 2 };
    double x[N * M], y[N], material[2], at[2] = {0, 0};
    uint64_t state = 7;
    ms_gpr_fit_options how;
    ms_gpr_latent_options flat;
    ms_gpr_latent *plane = NULL;
    ms_gpr *gp = NULL;
    ms_gpr_view parts;
    ms_status status;
    int i;
    for (i = 0; i < N * M; ++i) x[i] = test_uniform(&state);
    for (i = 0; i < N; ++i) y[i] = 10 * x[M * i];
    memset(&how, 0, sizeof how);
    memset(&flat, 0, sizeof flat);
    how.evaluations = 2;
    how.allocator = flat.allocator = *allocator;
    status = ms_gpr_fit(x, y, N, M, &how, &gp, NULL, NULL);
    parts = ms_gpr_view_of(gp);
    parts.n -= 1;
    STEP(ms_gpr_update(gp, &parts, NULL));
    STEP(ms_gpr_preference(gp, x, x + M, 3, y, NULL));
    STEP(ms_gpr_recommend(gp, NULL, 4, x, NULL, NULL, NULL, NULL));
    for (i = 0; i < N * M; ++i) x[i] = test_uniform(&state);
    STEP(ms_gpr_latent_fit(x, N, M, &flat, &plane, NULL, NULL));
    STEP(ms_gpr_latent_map(plane, at, 1, material, NULL, NULL));
    ms_gpr_latent_destroy(plane);
    ms_gpr_destroy(gp);
    return status;
}

/* A network of two dense layers, written to a file, read again, run every way and collapsed. */
static ms_status network(const ms_allocator *allocator)
{
    enum { IN = 3, HIDDEN = 4, OUT = 6, SAMPLES = 8 };
    static const unsigned char zero[HIDDEN * OUT * 4] = {0};
    static const size_t shape[4][2] = {{HIDDEN, IN}, {HIDDEN, 0}, {OUT, HIDDEN}, {OUT, 0}};
    static const char *const name[4] = {"a.weight", "a.bias", "b.weight", "b.bias"};
    static unsigned char bytes[4096];
    float weight[HIDDEN * OUT], x[IN * SAMPLES], y[OUT * SAMPLES], jacobian[OUT * IN];
    double residual[HIDDEN + 1], slope[(HIDDEN + 1) * IN];
    size_t size = 0;
    FILE *saved;
    ms_nn_tensor tensor[4];
    ms_nn_entry entry[3];
    ms_nn_options options = ms_nn_defaults();
    ms_nn_file *file = NULL;
    ms_nn *nn = NULL;
    ms_nn_collapse *collapse = NULL;
    uint64_t state = 3;
    ms_status status;
    int i;
    for (i = 0; i < HIDDEN * OUT; ++i) weight[i] = (float)(test_uniform(&state) - 0.5);
    for (i = 0; i < IN * SAMPLES; ++i) x[i] = (float)test_uniform(&state);
    for (i = 0; i < OUT * SAMPLES; ++i) y[i] = 1;
    for (i = 0; i < 4; ++i) {
        tensor[i].name = name[i];
        tensor[i].dtype = MS_NN_F32;
        tensor[i].rank = i % 2 ? 1 : 2;
        tensor[i].shape = shape[i];
        tensor[i].data = i % 2 ? (const void *)zero
                               : (const void *)weight; /* of a big-endian host: other numbers, as good */
        tensor[i].bytes = shape[i][0] * (i % 2 ? 1 : shape[i][1]) * sizeof(float);
    }
    entry[0].key = "ms_nn_version";
    entry[0].value = "1";
    entry[1].key = "ms_nn_input";
    entry[1].value = "[3]";
    entry[2].key = "ms_nn_layers";
    entry[2].value =
        "[{\"type\":\"dense\",\"name\":\"a\",\"activation\":\"tanh\"},{\"type\":\"dense\",\"name\":\"b\"}]";
    options.allocator = *allocator;
    status = ms_nn_file_write(tensor, 4, entry, 3, bytes, sizeof bytes, &size, NULL);
    saved = fopen(scratch(), "wb");
    if (saved == NULL || fwrite(bytes, 1, size, saved) != size) status = MS_IO;
    if (saved) fclose(saved);
    STEP(ms_nn_file_read(scratch(), &options, &file, NULL));
    STEP(ms_nn_load_file(scratch(), &options, &nn, NULL));
    STEP(ms_nn_forward(nn, SAMPLES, x, y, NULL));
    STEP(ms_nn_jacobian(nn, x, NULL, jacobian, NULL));
    STEP(ms_nn_check_weights(nn, NULL));
    STEP(ms_nn_collapse_create(nn, NULL, &collapse, NULL));
    STEP(ms_nn_collapse_target(collapse, y, NULL));
    STEP(ms_nn_collapse_residual(collapse, x, residual, slope, NULL));
    ms_nn_collapse_destroy(collapse);
    ms_nn_destroy(nn);
    ms_nn_file_close(file);
    remove(scratch());
    return status;
}

/* A picture to a material, and what the picture tells. */
static ms_status residuals(void *user, const double *x, double *r, double *jacobian)
{
    (void)user;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
    if (jacobian != NULL) {
        jacobian[0] = -20 * x[0];
        jacobian[1] = 10;
        jacobian[2] = -1;
        jacobian[3] = 0;
    }
    return MS_OK;
}

static ms_status matching(const ms_allocator *allocator)
{
    const float target[3] = {0.25f, 0.4f, 2.1f};
    ms_pme_renderer renderer = ms_pme_renderer_defaults();
    ms_pme_match_options how = ms_pme_match_defaults();
    ms_pme_options options = ms_pme_defaults();
    ms_pme_function function;
    double x[2], valley[2] = {-1.2, 1};
    ms_status status;
    renderer.parameter_count = 2;
    renderer.image_size = 3;
    renderer.render = render;
    how.refine.allocator = options.allocator = *allocator;
    memset(&function, 0, sizeof function);
    function.parameter_count = 2;
    function.residual_count = 2;
    function.residuals = residuals;
    options.max_cost = 20;
    status = ms_pme_match(&renderer, target, NULL, &how, x, NULL, NULL, NULL);
    STEP(ms_pme_minimize(&function, &options, valley, NULL, NULL));
    return status;
}

/* --- cases --- */

static void fail_transport(void) { TEST_ALLOCATION_SWEEP(100, status = transport(&allocator)); }
static void fail_kernels(void) { TEST_ALLOCATION_SWEEP(100, status = kernels(&allocator)); }
static void fail_preference(void) { TEST_ALLOCATION_SWEEP(1000, status = preference(&allocator)); }
static void fail_network(void) { TEST_ALLOCATION_SWEEP(200, status = network(&allocator)); }
static void fail_matching(void) { TEST_ALLOCATION_SWEEP(100, status = matching(&allocator)); }

/* One frame of a tool: a filtered picture, its memory lent by the caller. */
static ms_status frame(const ms_allocator *allocator)
{
    static ms_sss_kernel kernel;
    static float light[3 * 32 * 32];
    const double sigma[1][3] = {{1, 0.5, 0.25}}, weight[1][3] = {{1, 1, 1}};
    ms_sss_kernel_options design = ms_sss_kernel_defaults();
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_profile *profile = NULL;
    ms_sss_frame f;
    ms_status status;
    memset(&f, 0, sizeof f);
    f.width = f.height = 32;
    f.input = f.output = ms_sss_interleaved(light, 3);
    design.model = MS_SSS_PREINTEGRATED;
    design.placement = MS_SSS_QUANTILE;
    options.pixels_per_mm[0] = 2;
    status = ms_sss_profile_from_gaussians(&profile, 1, sigma, weight, allocator, NULL);
    STEP(ms_sss_kernel_make(&kernel, NULL, profile, 4, &design, allocator, NULL));
    if (status == MS_OK) {
        size_t size = ms_sss_filter_workspace(32, 32, &kernel, 1, &options);
        void *workspace = allocator->alloc(allocator->user, size);
        status = ms_sss_filter(&f, &kernel, 1, &options, workspace, size, NULL);
        allocator->release(allocator->user, workspace, size);
    }
    ms_sss_profile_destroy(profile);
    return status;
}

/* Many rounds on one allocator: as much memory at most in the last as in the second, none between two. --full: 1000. */
static void soak(void)
{
    static const struct {
        const char *name;
        ms_status (*run)(const ms_allocator *allocator);
    } work[] = {{"frames", frame},
                {"fits", preference},
                {"runs of photons", transport},
                {"networks", network},
                {"matches", matching}};
    int rounds = test_full ? 1000 : 20, i, k;
    for (i = 0; i < (int)(sizeof work / sizeof work[0]); ++i) {
        test_memory m;
        ms_allocator allocator;
        size_t peak = 0;
        long calls = 0;
        memset(&m, 0, sizeof m);
        allocator.user = &m;
        allocator.alloc = test_memory_alloc;
        allocator.release = test_memory_release;
        for (k = 0; k < rounds; ++k) {
            m.calls = 0;
            CHECK_INT(work[i].run(&allocator), MS_OK);
            CHECK_INT(m.blocks, 0);
            CHECK_INT(m.bytes, 0);
            CHECK_INT(m.errors, 0);
            if (k == 0) peak = m.peak, calls = m.calls;
            CHECK_INT(m.calls, calls);
        }
        CHECK_INT(m.peak, peak);
        TEST_NOTE("%d %s: %ld blocks, %.0f kB at most", rounds, work[i].name, calls, (double)peak / 1000);
    }
}

static const test_case cases[] = {
    {"transport runs out of memory", fail_transport},   {"kernels run out of memory", fail_kernels},
    {"preference runs out of memory", fail_preference}, {"network runs out of memory", fail_network},
    {"matching runs out of memory", fail_matching},     {"soak", soak}};
TEST_MAIN(cases)
