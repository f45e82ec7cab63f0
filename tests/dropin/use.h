/* A user of whatever ms_*.h headers stand before this line: one or two calls of each, checked against what is known in
   advance, all memory from an arena of its own. Prints a line a header; exits with 1 if a number is wrong or memory is
   lost. Valid in every mode in which tests/dropin and tests/cross.sh build it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

static union {
    double align[2];
    unsigned char byte[1 << 22];
} use_arena;
static size_t use_top, use_live;

static void *use_alloc(void *user, size_t size)
{
    unsigned char *p = use_arena.byte + use_top;
    (void)user;
    size = (size + 15) / 16 * 16;
    if (size > sizeof use_arena.byte - use_top) return NULL;
    use_top += size;
    use_live += size;
    return p;
}

static void use_release(void *user, void *pointer, size_t size)
{
    (void)user;
    (void)pointer;
    use_live -= (size + 15) / 16 * 16;
    if (use_live == 0) use_top = 0;
}

static ms_allocator use_allocator(void)
{
    ms_allocator allocator;
    allocator.user = NULL;
    allocator.alloc = use_alloc;
    allocator.release = use_release;
    return allocator;
}

/* 0, or 1 with a line that says what was wrong. Tolerances hold with -ffast-math and at every SIMD level. */
static int use_check(const char *what, double value, double expected, double tolerance)
{
    int bad = !(value >= expected - tolerance && value <= expected + tolerance);
    printf("%s: %.6g%s\n", what, value, bad ? ", wrong" : "");
    return bad;
}

#ifdef MS_MCML_H
/* All light ends somewhere, but for the roulette of 1000 photons; a half-space that does not absorb returns all of
   it. */
static int use_mcml(void)
{
    const ms_mcml_layer layer = {1.4, 1.0, 100, 0.9, 0.1};
    ms_mcml_medium medium;
    ms_mcml_tissue tissue;
    ms_mcml_grid grid;
    ms_mcml_options options = ms_mcml_defaults();
    ms_mcml_profile_options solver;
    ms_mcml_profile profile;
    ms_mcml_result r;
    int bad = 0;
    memset(&grid, 0, sizeof grid);
    tissue.n_above = tissue.n_below = 1;
    tissue.layer_count = 1;
    tissue.layers = &layer;
    grid.dr_cm = grid.dz_cm = 0.01;
    grid.nr = grid.nz = 10;
    grid.na = 1;
    options.photons = 1000;
    options.allocator = use_allocator();
    if (ms_mcml_simulate(&tissue, &grid, &options, &r, NULL) != MS_OK) return 1;
    bad += use_check("ms_mcml.h, where light ends", r.specular + r.rd + r.tt + r.a, 1, 0.01);
    ms_mcml_result_destroy(&r);
    memset(&solver, 0, sizeof solver);
    memset(&medium, 0, sizeof medium);
    solver.depth_step = 0.8;
    solver.frequency_step = 0.8;
    solver.allocator = options.allocator;
    medium.mu_s_per_mm = 1;
    medium.eta = 1.3;
    if (ms_mcml_profile_make(&profile, &medium, 1, &solver, NULL) != MS_OK) return 1;
    bad += use_check("ms_mcml.h, white half-space", profile.total[0], 1 - 0.3 * 0.3 / (2.3 * 2.3), 1e-3);
    ms_mcml_profile_destroy(&profile);
    return bad;
}
#endif

#ifdef MS_SSS_H
/* A picture of one color stays as it is. */
static int use_sss(void)
{
    static ms_sss_kernel kernel;
    static float light[16 * 16 * 3];
    const double sigma_mm[1][3] = {{1, 0.5, 0.25}}, weight[1][3] = {{1, 1, 1}};
    ms_allocator allocator = use_allocator();
    ms_sss_profile *profile;
    ms_sss_kernel_options design = ms_sss_kernel_defaults();
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_frame frame;
    size_t size;
    void *workspace;
    int i, bad;
    for (i = 0; i < 16 * 16 * 3; ++i) light[i] = 0.5f;
    if (ms_sss_profile_from_gaussians(&profile, 1, sigma_mm, weight, &allocator, NULL) != MS_OK) return 1;
    design.model = MS_SSS_PREINTEGRATED;
    design.placement = MS_SSS_QUANTILE;
    bad = ms_sss_kernel_make(&kernel, NULL, profile, 8, &design, &allocator, NULL) != MS_OK;
    ms_sss_profile_destroy(profile);
    memset(&frame, 0, sizeof frame);
    frame.width = frame.height = 16;
    frame.input = frame.output = ms_sss_interleaved(light, 3);
    options.pixels_per_mm[0] = 2;
    size = ms_sss_filter_workspace(16, 16, &kernel, 1, &options);
    workspace = use_alloc(NULL, size);
    bad += workspace == NULL || ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL) != MS_OK;
    use_release(NULL, workspace, size);
    return bad + use_check("ms_sss.h, a constant", (double)light[400], 0.5, 1e-5);
}
#endif

#ifdef MS_GPR_H
/* One score y at x: the mean there is y sf^2 / (sf^2 + sn^2). */
static int use_gpr(void)
{
    const double x[2] = {0.25, 0.75}, y[1] = {3}, theta[4] = {0, 0, 0, 0};
    ms_gpr_view parts;
    ms_gpr_options options;
    double mean = 0;
    ms_gpr *gp;
    int bad;
    memset(&options, 0, sizeof options);
    options.allocator = use_allocator();
    memset(&parts, 0, sizeof parts);
    parts.n = 1, parts.m = 2;
    parts.x = x, parts.y = y, parts.theta = theta;
    if (ms_gpr_create(&parts, &options, &gp, NULL) != MS_OK) return 1;
    bad = ms_gpr_predict(gp, x, 1, &mean, NULL, NULL) != MS_OK;
    ms_gpr_destroy(gp);
    return bad + use_check("ms_gpr.h, a score seen once", mean, 1.5, 1e-9);
}
#endif

#ifdef MS_NN_H
/* A file written and read again, and a dense layer of it: y = relu(W x + b). The numbers are bytes, little-endian. */
static int use_nn(void)
{
    static const unsigned char w[16] = {0, 0, 0x80, 0x3f, 0, 0, 0,    0x40,
                                        0, 0, 0x40, 0x40, 0, 0, 0x80, 0x40}; /* 1 2, 3 4 */
    static const unsigned char b[8] = {0, 0, 0x80, 0x3f, 0, 0, 0x80, 0xbf};  /* 1 -1 */
    static const size_t shape[2] = {2, 2};
    static const char layers[] = "[{\"type\":\"dense\",\"name\":\"d\",\"activation\":\"relu\"}]";
    static unsigned char file[4096];
    size_t size = 0;
    const float x[2] = {1, -0.5f};
    float out[2] = {0, 0};
    ms_nn_tensor tensor[2];
    ms_nn_entry entry[4];
    ms_nn_options options = ms_nn_defaults();
    ms_nn *nn;
    ms_error error;
    int bad;
    tensor[0].name = "d.weight";
    tensor[1].name = "d.bias";
    tensor[0].dtype = tensor[1].dtype = MS_NN_F32;
    tensor[0].rank = 2;
    tensor[1].rank = 1;
    tensor[0].shape = tensor[1].shape = shape;
    tensor[0].data = w;
    tensor[1].data = b;
    tensor[0].bytes = sizeof w;
    tensor[1].bytes = sizeof b;
    entry[0].key = "format";
    entry[0].value = "pt";
    entry[1].key = "ms_nn_version";
    entry[1].value = "1";
    entry[2].key = "ms_nn_input";
    entry[2].value = "[2]";
    entry[3].key = "ms_nn_layers";
    entry[3].value = layers;
    options.allocator = use_allocator();
    if (ms_nn_file_write(tensor, 2, entry, 4, file, sizeof file, &size, NULL) != MS_OK) return 1;
    if (ms_nn_load(file, size, &options, &nn, &error) != MS_OK) {
        printf("ms_nn.h: %s\n", error.message);
        return 1;
    }
    bad = ms_nn_forward(nn, 1, x, out, NULL) != MS_OK;
    ms_nn_destroy(nn);
    bad += use_check("ms_nn.h, 1 - 1 + 1", (double)out[0], 1, 0);
    return bad + use_check("ms_nn.h, relu(3 - 2 - 1)", (double)out[1], 0, 0);
}
#endif

#ifdef MS_PME_H
/* Rosenbrock's valley ends at (1, 1). */
static ms_status use_valley(void *user, const double *x, double *r, double *jacobian)
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

static int use_pme(void)
{
    ms_pme_function function;
    ms_pme_options options = ms_pme_defaults();
    double x[2] = {-1.2, 1};
    memset(&function, 0, sizeof function);
    function.parameter_count = 2;
    function.residual_count = 2;
    function.residuals = use_valley;
    options.allocator = use_allocator();
    if (ms_pme_minimize(&function, &options, x, NULL, NULL) != MS_OK) return 1;
    return use_check("ms_pme.h, the end of the valley", x[0] + x[1], 2, 1e-6);
}
#endif

int main(void)
{
    int bad = 0;
#ifdef MS_MCML_H
    bad += use_mcml();
#endif
#ifdef MS_SSS_H
    bad += use_sss();
#endif
#ifdef MS_GPR_H
    bad += use_gpr();
#endif
#ifdef MS_NN_H
    bad += use_nn();
#endif
#ifdef MS_PME_H
    bad += use_pme();
#endif
    bad += use_live != 0;
    printf("%s\n", bad ? "wrong" : "right");
    return bad != 0;
}
