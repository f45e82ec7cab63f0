/* What the declarations of all headers say of memory and of numbers:
     memory    workspaces and outputs have exactly the stated size, any content before, any address where that is said;
               one byte less is refused, and so is a size that no machine has
     defaults  an option that says "0: value" gives the same bits with 0 and with the value, and others with `other`
     limits    the last value that is accepted and the first that is refused
   A line of the tables below is one fact: add yours where your header's lines stand. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"

#include "nn_shader.h"
#include "test.h"
#include <limits.h>
#include <stddef.h>

static const int counts[] = {1, 3, 64, 300};
static const int fills[] = {0x00, 0xFF, 0xCD}; /* 0xFF: NaN, whatever the type */
enum { COUNTS = 4, FILLS = 3 };
static const uint64_t print_0 = 14695981039346656037u;

/* --- memory: ms_nn.h --- */

/* Elements of a type, small numbers, in the file's order of bytes. */
static void net_fill(unsigned char *to, ms_nn_dtype type, size_t n, uint64_t *state)
{
    size_t i, k;
    for (i = 0; i < n; ++i) {
        const double v = test_uniform(state) - 0.5;
        const float f = (float)v;
        const uint16_t half = test_half_of(f);
        uint32_t bits;
        memcpy(&bits, &f, 4);
        for (k = 0; type == MS_NN_F32 && k < 4; ++k) to[4 * i + k] = (unsigned char)(bits >> (8 * k));
        for (k = 0; type == MS_NN_F16 && k < 2; ++k) to[2 * i + k] = (unsigned char)(half >> (8 * k));
        if (type == MS_NN_I8) to[i] = (unsigned char)(signed char)(v * 200);
    }
}

enum { NET_DENSE, NET_SHARED, NET_CONV, NETS };

/* Two layers with weights of one type; *file is freed after it. The file is written where it fits to the byte, and not
   one byte short of that. */
static ms_nn *net_of(int kind, ms_nn_dtype type, unsigned char **file)
{
    static const char *const layers[NETS] = {
        "[{\"type\":\"dense\",\"name\":\"a\",\"activation\":\"elu\"},{\"type\":\"dense\",\"name\":\"b\"}]",
        "[{\"type\":\"shared_channels\",\"inputs\":[[0,3],[1,3],[2,4]]},"
        "{\"type\":\"dense\",\"name\":\"a\",\"activation\":\"elu\"},{\"type\":\"dense\",\"name\":\"b\"}]",
        "[{\"type\":\"conv1d\",\"name\":\"a\",\"activation\":\"elu\"},{\"type\":\"upsample1d\",\"factor\":2},"
        "{\"type\":\"flatten\"},{\"type\":\"dense\",\"name\":\"b\"}]"};
    static const size_t shapes[NETS][2][3] = {
        {{18, 5, 1}, {7, 18, 1}}, {{18, 2, 1}, {7, 18, 1}}, {{4, 2, 3}, {7, 56, 1}}}; /* outputs first */
    static const char *const names[2][3] = {{"a.weight", "a.bias", "a.weight_scale"},
                                            {"b.weight", "b.bias", "b.weight_scale"}};
    static unsigned char data[6][8 * 7 * 56];
    ms_nn_entry entries[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[5]"}, {"ms_nn_layers", NULL}};
    ms_nn_tensor t[6];
    size_t size = 0, room, i, n = 0;
    uint64_t state = test_seed + 5;
    int layer;
    ms_nn *nn = NULL;
    ms_error error;
    if (kind == NET_CONV) entries[1].value = "[2,9]";
    entries[2].value = layers[kind];
    for (layer = 0; layer < 2; ++layer)
        for (i = 0; i < (type == MS_NN_I8 ? 3u : 2u); ++i, ++n) {
            const size_t *shape = shapes[kind][layer];
            t[n].name = names[layer][i];
            t[n].dtype = i == 0 ? type : MS_NN_F32;
            t[n].shape = shape;
            t[n].rank = i > 0 ? 1 : shape[2] > 1 ? 3 : 2;
            t[n].data = data[n];
            t[n].bytes = shape[0] *
                (i > 0 ? 4
                       : shape[1] * shape[2] *
                         (type == MS_NN_F32      ? 4u
                              : type == MS_NN_I8 ? 1u
                                                 : 2u));
            net_fill(data[n], t[n].dtype, i > 0 ? shape[0] : shape[0] * shape[1] * shape[2], &state);
        }
    CHECK_INT(ms_nn_file_write(t, n, entries, 3, NULL, 0, &size, &error), MS_OK);
    room = size;
    *file = test_guarded(room, 0, 0xCD);
    CHECK_INT(ms_nn_file_write(t, n, entries, 3, *file, room - 1, &size, &error), MS_INVALID_ARGUMENT);
    CHECK((*file)[0] == 0xCD);
    CHECK_INT(ms_nn_file_write(t, n, entries, 3, *file, room, &size, &error), MS_OK);
    if (ms_nn_load(*file, room, NULL, &nn, &error) != MS_OK) TEST_FAIL("%s", error.message);
    for (i = 0; i != TEST_GUARD; ++i) CHECK((*file)[room + i] == (unsigned char)(0x5A ^ i));
    return nn;
}

/* One call with all its memory guarded. */
static uint64_t net_call(const ms_nn *nn, const ms_nn_collapse *c, int call, int count, const float *x, int fill)
{
    const size_t in = ms_nn_input_size(nn), out = ms_nn_output_size(nn), offset = (size_t)(fill & 7) * 3;
    const size_t rows = call == 2 ? ms_nn_collapse_features(c) + 1 : out;
    const size_t y_size = (call == 0 ? (size_t)count * out : call == 1 ? out : 2 * rows) * sizeof(float);
    const size_t j_size = call == 0 ? 0 : call == 1 ? rows * in * sizeof(float) : rows * in * sizeof(double);
    const size_t size = call == 0 ? ms_nn_workspace_size(nn, MS_NN_FORWARD, count)
        : call == 1               ? ms_nn_workspace_size(nn, MS_NN_JACOBIAN, 1)
                                  : ms_nn_collapse_workspace_size(c, 1);
    unsigned char *workspace = test_guarded(size, offset, fill), *y = test_guarded(y_size, 0, fill),
                  *j = test_guarded(j_size, 0, fill);
    uint64_t print;
    ms_status status = call == 0 ? ms_nn_forward(nn, count, x, (float *)(void *)y, workspace)
        : call == 1              ? ms_nn_jacobian(nn, x, (float *)(void *)y, (float *)(void *)j, workspace)
                                 : ms_nn_collapse_residual(c, x, (double *)(void *)y, (double *)(void *)j, workspace);
    CHECK_INT(status, MS_OK);
    print = test_print(test_print(print_0, y, y_size), j, j_size);
    CHECK(test_unguard(workspace, size, offset));
    CHECK(test_unguard(y, y_size, 0));
    CHECK(test_unguard(j, j_size, 0));
    return print;
}

static void memory_nn(void)
{
    static const ms_nn_dtype types[] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    static float x[300 * 18];
    uint64_t state = test_seed;
    int kind, type, i, call, fill;
    for (i = 0; i < 300 * 18; ++i) x[i] = (float)(test_uniform(&state) - 0.5);
    for (kind = 0; kind < NETS; ++kind)
        for (type = 0; type < 3; ++type) {
            unsigned char *file;
            ms_nn *nn = net_of(kind, types[type], &file);
            ms_nn_collapse *c = NULL;
            ms_error error;
            if (nn == NULL) return;
            CHECK_INT(ms_nn_collapse_create(nn, NULL, &c, &error), MS_OK);
            CHECK_INT(ms_nn_collapse_target(c, x, &error), MS_OK);
            for (call = 0; call < 3; ++call)
                for (i = 0; i < (call == 0 ? COUNTS : 1); ++i) {
                    uint64_t print = net_call(nn, c, call, counts[i], x, fills[0]);
                    for (fill = 1; fill < FILLS; ++fill)
                        CHECK(net_call(nn, c, call, counts[i], x, fills[fill]) == print);
                }
            CHECK(ms_nn_workspace_size(nn, MS_NN_FORWARD, 0) == SIZE_MAX);
            CHECK(ms_nn_workspace_size(nn, MS_NN_FORWARD, -1) == SIZE_MAX);
            ms_nn_collapse_destroy(c);
            ms_nn_destroy(nn);
            free(file);
        }
}

/* --- memory: ms_sss.h --- */

static const ms_sss_kernel *sss_kernel(int terms)
{
    static ms_sss_kernel kernel[2];
    static const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
    ms_sss_kernel *k = &kernel[terms > 1];
    if (k->tap_count == 0) {
        ms_sss_profile *profile = NULL;
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        o.model = terms > 1 ? MS_SSS_RESIDUAL : MS_SSS_IMAGE_OPTIMAL;
        CHECK_INT(ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL), MS_OK);
        CHECK_INT(ms_sss_kernel_make(k, NULL, profile, 24, &o, NULL, NULL), MS_OK);
        ms_sss_profile_destroy(profile);
    }
    return k;
}

static const ms_sss_pyramid *sss_pyramid(void)
{
    static ms_sss_pyramid pyramid;
    static const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
    if (!(pyramid.radius_mm > 0)) {
        ms_sss_profile *profile = NULL;
        CHECK_INT(ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL), MS_OK);
        CHECK_INT(ms_sss_pyramid_make(&pyramid, profile, NULL), MS_OK);
        ms_sss_profile_destroy(profile);
    }
    return &pyramid;
}

typedef struct sss_call {
    const char *name;
    int pyramid, depth, terms;
    float flat;
} sss_call;

/* A picture with all of its memory guarded: input, output, depth and workspace. short_by bytes are kept from the call.
 */
static uint64_t sss_run(const sss_call *call, int width, int height, int fill, size_t short_by)
{
    const size_t n = (size_t)width * (size_t)height, element = 4, offset = (size_t)(fill & 7) * 3;
    unsigned char *in = test_guarded(3 * n * element, 0, 0), *out = test_guarded(3 * n * element, 0, fill);
    unsigned char *depth = test_guarded(n * 4, 0, 0), *workspace;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame frame;
    size_t i, size;
    uint64_t state = test_seed + 2, print;
    ms_status status;
    ms_error error;
    for (i = 0; i < 3 * n; ++i) {
        const float v = (float)test_uniform(&state);
        memcpy(in + element * i, &v, element);
    }
    for (i = 0; i < n; ++i) {
        const float v = 100 + (float)(i % (size_t)width) * 0.05f + (float)test_uniform(&state) * 0.1f;
        memcpy(depth + 4 * i, &v, 4);
    }
    memset(&frame, 0, sizeof frame);
    frame.width = width;
    frame.height = height;
    frame.input = ms_sss_interleaved((const float *)(const void *)in, 3);
    frame.output = ms_sss_interleaved((const float *)(const void *)out, 3);
    if (call->depth) {
        frame.depth = ms_sss_map((const float *)(const void *)depth, 1);
        o.ortho_height = (float)height * 0.25f;
    } else o.pixels_per_mm[0] = 4;
    o.flat = call->flat;
    o.mm_per_unit = 1;
    size = call->pyramid ? ms_sss_pyramid_workspace(width, height)
                         : ms_sss_filter_workspace(width, height, sss_kernel(call->terms), 1, &o);
    workspace = test_guarded(size - short_by, offset, fill);
    if (call->pyramid) status = ms_sss_pyramid_filter(&frame, sss_pyramid(), 1, &o, workspace, size - short_by, &error);
    else status = ms_sss_filter(&frame, sss_kernel(call->terms), 1, &o, workspace, size - short_by, &error);
    if (short_by) {
        CHECK_INT(status, MS_INVALID_ARGUMENT);
        for (i = 0; i < 3 * n * element; ++i) CHECK_INT(out[i], fill);
    } else {
        if (status != MS_OK) TEST_FAIL("%s, %d x %d: %s", call->name, width, height, error.message);
    }
    print = test_print(print_0, out, 3 * n * element);
    CHECK(test_unguard(workspace, size - short_by, offset));
    CHECK(test_unguard(out, 3 * n * element, 0));
    CHECK(test_unguard(in, 3 * n * element, 0));
    CHECK(test_unguard(depth, n * 4, 0));
    return print;
}

static void memory_sss(void)
{
    static const sss_call calls[] = {
        {"taps", 0, 0, 1, 0},      {"taps, depth", 0, 1, 1, 0},       {"taps, depth, flat", 0, 1, 1, 1},
        {"two terms", 0, 1, 2, 0}, {"pyramid, no depth", 1, 0, 1, 0}, {"pyramid", 1, 1, 1, 0}};
    ms_sss_filter_options o = ms_sss_filter_defaults();
    size_t k;
    int i, fill;
    for (k = 0; k < sizeof calls / sizeof calls[0]; ++k)
        for (i = 0; i < COUNTS; ++i) {
            const int width = counts[i], height = counts[(i + 2) % COUNTS] / (i < 2 ? 1 : 7) + 1;
            const uint64_t print = sss_run(&calls[k], width, height, fills[0], 0);
            for (fill = 1; fill < FILLS; ++fill)
                if (sss_run(&calls[k], width, height, fills[fill], 0) != print)
                    TEST_FAIL("%s, %d x %d: the content of the memory matters", calls[k].name, width, height);
            sss_run(&calls[k], width, height, 0xCD, 1);
        }
    o.pixels_per_mm[0] = 4;
    CHECK(ms_sss_filter_workspace(65536, 1, sss_kernel(1), 1, &o) < (size_t)1 << 30);
    CHECK(ms_sss_filter_workspace(65537, 1, sss_kernel(1), 1, &o) == SIZE_MAX);
    CHECK(ms_sss_filter_workspace(0, 1, sss_kernel(1), 1, &o) == SIZE_MAX);
    CHECK(ms_sss_pyramid_workspace(65537, 1) == SIZE_MAX && ms_sss_pyramid_workspace(1, 0) == SIZE_MAX);
    CHECK(ms_sss_pyramid_workspace(1, 1) > 0);
    if (sizeof(size_t) > 4) CHECK(ms_sss_pyramid_workspace(65536, 65536) / 65536 / 65536 >= 30);
    else CHECK(ms_sss_pyramid_workspace(65536, 65536) == SIZE_MAX);
}

/* Texts and constants: untouched where they do not fit. */
static void memory_texts(void)
{
    int language, step;
    for (step = 0; step <= (int)MS_SSS_STEP_RESOLVE; ++step) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_shader s = ms_sss_shader_defaults();
        unsigned char *out;
        size_t size;
        o.pixels_per_mm[0] = 4;
        s.pyramids = sss_pyramid();
        s.step = (ms_sss_step)step;
        s.tap_count = 11;
        size = (size_t)ms_sss_shader_constant_count(&s) * 4 * sizeof(float);
        out = test_guarded(size, 0, 0xCD);
        CHECK_INT(ms_sss_shader_constants(sss_kernel(1), 0, &o, 640, 480, &s, (float(*)[4])(void *)out, NULL), MS_OK);
        CHECK(test_unguard(out, size, 0));
    }
    {
        unsigned char *file;
        ms_nn *nn = net_of(NET_DENSE, MS_NN_F32, &file);
        nn_shader s;
        nn_shader_sizes sizes;
        size_t size, rows;
        unsigned char *text, *out;
        float x[15] = {0.1f};
        memset(&s, 0, sizeof s);
        CHECK_INT(nn_shader_layout(nn, &s, &sizes, NULL), MS_OK);
        size = nn_shader_text(nn, &s, NULL, 0, NULL);
        text = test_guarded(size + 1, 0, 0xCD);
        CHECK(nn_shader_text(nn, &s, (char *)text, size, NULL) == size && text[0] == 0xCD);
        CHECK(nn_shader_text(nn, &s, (char *)text, size + 1, NULL) == size && text[size] == 0);
        CHECK(test_unguard(text, size + 1, 0));
        for (language = 2; language <= 4; language += 2) { /* bytes of an element */
            rows = (size_t)sizes.weight_rows * NN_SHADER_WIDTH * 4 * (size_t)language;
            out = test_guarded(rows, 0, 0xCD);
            CHECK_INT(nn_shader_weights(nn, language == 2 ? MS_NN_F16 : MS_NN_F32, out, NULL), MS_OK);
            CHECK(test_unguard(out, rows, 0));
        }
        rows = 3 * (size_t)sizes.rows * (size_t)sizes.input_width * 4 * sizeof(float);
        out = test_guarded(rows, 0, 0xCD);
        CHECK_INT(nn_shader_inputs(nn, 3, x, (float *)(void *)out), MS_OK);
        CHECK(test_unguard(out, rows, 0));
        ms_nn_destroy(nn);
        free(file);
    }
}

/* --- memory: ms_gpr.h, ms_mcml.h --- */

enum { USER_N = 40, USER_M = 4 };
static double user_x[USER_N * USER_M], user_y[USER_N];

static void user_make(void)
{
    uint64_t state = test_seed + 3;
    int i;
    for (i = 0; i < USER_N * USER_M; ++i) user_x[i] = test_uniform(&state);
    for (i = 0; i < USER_N; ++i) {
        const double off = (user_x[USER_M * i] - 0.7) / 0.3;
        user_y[i] = off * off < 1 ? 10 * (1 - off * off) + 0.1 * test_normal(&state) : 0;
    }
}

static ms_gpr *user_model(void)
{
    static const double theta[USER_M + 2] = {-1, 0, 0.3, 0.2, 1, -2};
    ms_gpr_view parts;
    ms_gpr *gp = NULL;
    user_make();
    memset(&parts, 0, sizeof parts);
    parts.n = USER_N, parts.m = USER_M;
    parts.x = user_x, parts.y = user_y, parts.theta = theta;
    CHECK_INT(ms_gpr_create(&parts, NULL, &gp, NULL), MS_OK);
    return gp;
}

static void memory_gpr(void)
{
    ms_gpr *gp = user_model();
    int i, what;
    for (i = 0; i < COUNTS; ++i)
        for (what = 0; what < 3; ++what) {
            const int count = counts[i];
            const size_t points = (size_t)count * USER_M * sizeof(double), values = (size_t)count * sizeof(double);
            unsigned char *x = test_guarded(points, 0, 0), *mean = test_guarded(values, 0, 0xFF),
                          *sigma = test_guarded(values, 0, 0xFF);
            double *px = (double *)(void *)x, *pm = (double *)(void *)mean, *ps = (double *)(void *)sigma;
            ms_status status;
            if (what == 0) status = ms_gpr_predict(gp, px, count, pm, ps, NULL);
            else if (what == 1) status = ms_gpr_recommend(gp, NULL, count, px, pm, ps, NULL, NULL);
            else status = ms_gpr_gallery(gp, NULL, count, px, NULL);
            CHECK_INT(status, MS_OK);
            if (what < 2) CHECK(isfinite(pm[count - 1]) && ps[count - 1] >= 0);
            CHECK(test_unguard(x, points, 0));
            CHECK(test_unguard(mean, values, 0));
            CHECK(test_unguard(sigma, values, 0));
        }
    CHECK_INT(ms_gpr_predict(gp, user_x, -1, user_y, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_gpr_recommend(gp, NULL, 0, user_x, NULL, NULL, NULL, NULL), MS_INVALID_ARGUMENT);
    ms_gpr_destroy(gp);
}

static void memory_mcml(void)
{
    ms_mcml_layer layer = {1.4, 10, 90, 0.8, 0.02};
    ms_mcml_tissue tissue = {1, 1, 1, NULL};
    int i;
    tissue.layers = &layer;
    for (i = 0; i < COUNTS; ++i) {
        ms_mcml_grid grid;
        ms_mcml *tally = NULL, *again = NULL;
        ms_mcml_result a, b;
        size_t count;
        const int64_t *sums;
        int64_t *lent;
        memset(&grid, 0, sizeof grid);
        grid.dr_cm = grid.dz_cm = 0.01;
        grid.nr = counts[i];
        grid.nz = counts[COUNTS - 1 - i];
        grid.na = i + 1;
        CHECK_INT(ms_mcml_create(&tissue, &grid, NULL, &tally, NULL), MS_OK);
        CHECK_INT(ms_mcml_run(tally, 0, 3000, NULL), MS_OK);
        sums = ms_mcml_sums(tally, &count);
        lent = (int64_t *)(void *)test_guarded(count * sizeof *lent, 0, 0xCD);
        memcpy(lent, sums, count * sizeof *lent);
        CHECK_INT(ms_mcml_create(&tissue, &grid, NULL, &again, NULL), MS_OK);
        CHECK_INT(ms_mcml_add(again, lent, count - 1, NULL), MS_INVALID_ARGUMENT);
        CHECK_INT(ms_mcml_add(again, lent, count, NULL), MS_OK);
        CHECK(test_unguard((unsigned char *)(void *)lent, count * sizeof *lent, 0));
        CHECK_INT(ms_mcml_results(tally, &a, NULL), MS_OK);
        CHECK_INT(ms_mcml_results(again, &b, NULL), MS_OK);
        CHECK(a.rd > 0 && memcmp(a.rd_r, b.rd_r, (size_t)grid.nr * sizeof(double)) == 0 &&
              memcmp(a.a_z, b.a_z, (size_t)grid.nz * sizeof(double)) == 0);
        ms_mcml_result_destroy(&a);
        ms_mcml_result_destroy(&b);
        ms_mcml_destroy(again);
        ms_mcml_destroy(tally);
    }
}

/* --- defaults and limits: one run a header, told apart by its outputs' bits --- */

/* A number inside an options structure. */
typedef struct field {
    const char *name;
    size_t at;
    char type; /* d double, f float, i int, u uint64_t, z size_t */
} field;
#define FIELD(structure, member, type)             \
    {                                              \
#member, offsetof(structure, member), type \
    }

static void field_set(void *options, const field *f, double v)
{
    char *to = (char *)options + f->at;
    const float as_float = (float)v;
    const int as_int = (int)v;
    const uint64_t as_u = (uint64_t)(f->type == 'u' ? v : 0);
    const size_t as_z = (size_t)(f->type == 'z' ? v : 0);
    if (f->type == 'd') memcpy(to, &v, sizeof v);
    if (f->type == 'f') memcpy(to, &as_float, sizeof as_float);
    if (f->type == 'i') memcpy(to, &as_int, sizeof as_int);
    if (f->type == 'u') memcpy(to, &as_u, sizeof as_u);
    if (f->type == 'z') memcpy(to, &as_z, sizeof as_z);
}

typedef struct runs {
    ms_status status;
    uint64_t print;
    char message[240];
} runs;

static runs ended(ms_status status, const ms_error *error, const void *bytes, size_t size)
{
    runs r;
    r.status = status;
    r.print = status == MS_OK || status == MS_NOT_CONVERGED ? test_print(print_0, bytes, size) : 0;
    r.message[0] = 0;
    if (status != MS_OK) snprintf(r.message, sizeof r.message, "%s", error->message);
    return r;
}

/* --- ms_pme.h --- */

static ms_status valley(void *user, const double *x, double *r, double *jacobian)
{
    const double offset = *(const double *)user;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
    r[2] = offset;
    (void)jacobian;
    return MS_OK;
}

static runs run_pme(const void *options)
{
    static double offset = 0.5;
    ms_pme_function f;
    ms_pme_result result;
    ms_error error;
    double x[2] = {-1.2, 1}, out[6];
    ms_status status;
    memset(&f, 0, sizeof f);
    memset(&result, 0, sizeof result);
    f.user = &offset;
    f.parameter_count = 2;
    f.residual_count = 3;
    f.residuals = valley;
    f.residuals_only = 1;
    status = ms_pme_minimize(&f, (const ms_pme_options *)options, x, &result, &error);
    out[0] = x[0], out[1] = x[1], out[2] = result.value, out[3] = result.cost, out[4] = (double)result.evaluations;
    out[5] = (double)result.stop;
    return ended(status, &error, out, sizeof out);
}

static ms_status valley_of_three(void *user, const double *x, double *r, double *jacobian)
{
    (void)user, (void)jacobian;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0] + x[2];
    r[2] = 0.5;
    return MS_OK;
}

/* A parameter that equal bounds freeze costs nothing: the problem is that of the others, evaluation by evaluation. */
static void frozen_by_equal_bounds(void)
{
    static double offset = 0.5;
    static const double low[3] = {-5, -5, 0}, high[3] = {5, 5, 0};
    ms_pme_function two, three;
    ms_pme_result of_two, of_three;
    double x[2] = {-1.2, 1}, y[3] = {-1.2, 1, 0};
    memset(&two, 0, sizeof two);
    two.user = &offset;
    two.parameter_count = 2;
    two.residual_count = 3;
    two.residuals = valley;
    two.residuals_only = 1;
    two.lower = low;
    two.upper = high;
    three = two;
    three.parameter_count = 3;
    three.residuals = valley_of_three;
    CHECK_INT(ms_pme_minimize(&two, NULL, x, &of_two, NULL), MS_OK);
    CHECK_INT(ms_pme_minimize(&three, NULL, y, &of_three, NULL), MS_OK);
    CHECK_NEAR(x[0], 1, 1e-7);
    CHECK(y[0] == x[0] && y[1] == x[1] && y[2] == 0);
    CHECK_INT(of_three.evaluations, of_two.evaluations);
}

static ms_status picture(void *user, const double *x, float *image)
{
    int i;
    (void)user;
    for (i = 0; i < 12; ++i) image[i] = (float)(0.5 + 0.3 * sin(x[0] * i) * x[1] + 0.1 * x[0] * x[0]);
    return MS_OK;
}

static runs run_match(const void *options)
{
    ms_pme_renderer renderer = ms_pme_renderer_defaults();
    ms_pme_match_result result;
    ms_error error;
    float target[12];
    double x[2] = {0.3, 0.6}, out[6];
    int i;
    ms_status status;
    picture(NULL, x, target);
    for (i = 0; i < 12; ++i) target[i] = target[i] * (i % 2 ? 1.2f : 0.9f) + (i < 6 ? 0.02f : 0);
    renderer.parameter_count = 2;
    renderer.image_size = 12;
    renderer.render = picture;
    memset(&result, 0, sizeof result);
    status = ms_pme_match(&renderer, target, NULL, (const ms_pme_match_options *)options, x, NULL, &result, &error);
    out[0] = x[0], out[1] = x[1], out[2] = result.rmse, out[3] = result.cost, out[4] = result.refine.cost;
    out[5] = (double)result.refine.stop;
    return ended(status, &error, out, sizeof out);
}

/* --- ms_gpr.h --- */

static runs run_fit(const void *options)
{
    ms_gpr_fit_report report;
    ms_error error;
    ms_gpr *gp = NULL;
    double out[USER_M + 3] = {0};
    ms_status status;
    user_make();
    status = ms_gpr_fit(user_x, user_y, USER_N, USER_M, (const ms_gpr_fit_options *)options, &gp, &report, &error);
    if (status == MS_OK) {
        const ms_gpr_view view = ms_gpr_view_of(gp);
        memcpy(out, view.theta, (USER_M + 2) * sizeof(double));
        out[USER_M + 2] = view.floor_value;
    }
    ms_gpr_destroy(gp);
    return ended(status, &error, out, sizeof out);
}

static runs run_recommend(const void *options)
{
    ms_gpr *gp = user_model();
    ms_gpr_recommend_options o = *(const ms_gpr_recommend_options *)options;
    double x[12 * USER_M];
    ms_error error;
    ms_status status;
    o.avoid = user_x;
    o.avoid_count = 3;
    memset(x, 0, sizeof x);
    status = ms_gpr_recommend(gp, &o, 12, x, NULL, NULL, NULL, &error);
    ms_gpr_destroy(gp);
    return ended(status, &error, x, sizeof x);
}

/* --- ms_mcml.h --- */

static runs run_simulate(const void *options)
{
    static const ms_mcml_layer layers[2] = {{1.4, 200, 100, 0.5, 0.02}, {1.4, 300, 3, 0, 0.02}};
    const ms_mcml_tissue tissue = {1, 1, 2, layers};
    ms_mcml_grid grid;
    ms_mcml_result result;
    ms_error error;
    double out[4] = {0};
    ms_status status;
    memset(&grid, 0, sizeof grid);
    grid.dr_cm = grid.dz_cm = 0.01;
    grid.nr = grid.nz = grid.na = 2;
    status = ms_mcml_simulate(&tissue, &grid, (const ms_mcml_options *)options, &result, &error);
    if (status == MS_OK) {
        out[0] = result.rd, out[1] = result.tt, out[2] = result.a, out[3] = (double)result.photons;
        ms_mcml_result_destroy(&result);
    }
    return ended(status, &error, out, sizeof out);
}

static runs profile_of(const ms_mcml_medium *medium, ms_mcml_profile_options *o)
{
    ms_mcml_profile profile;
    ms_error error;
    ms_status status;
    double out[6] = {0};
    o->rings = 5;
    o->ring_mm = 0.3;
    memset(&profile, 0, sizeof profile);
    status = ms_mcml_profile_make(&profile, medium, 1, o, &error);
    if (status == MS_OK) memcpy(out, profile.rd_per_mm2, 5 * sizeof(double)), out[5] = profile.total[0];
    ms_mcml_profile_destroy(&profile);
    return ended(status, &error, out, sizeof out);
}

static runs run_profile(const void *options)
{
    const ms_mcml_medium medium = {0.02, 1.2, 0, 1.3};
    ms_mcml_profile_options o = *(const ms_mcml_profile_options *)options;
    return profile_of(&medium, &o);
}

static runs run_medium(const void *medium)
{
    ms_mcml_profile_options o;
    memset(&o, 0, sizeof o);
    return profile_of((const ms_mcml_medium *)medium, &o);
}

/* --- ms_sss.h --- */

static ms_sss_designer *designer(void)
{
    static ms_sss_designer *made;
    static const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
    ms_sss_profile *profile = NULL;
    if (made) return made;
    CHECK_INT(ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL), MS_OK);
    CHECK_INT(ms_sss_designer_create(&made, profile, 24, NULL, NULL), MS_OK);
    ms_sss_profile_destroy(profile);
    return made;
}

static runs run_kernel(const void *options)
{
    static ms_sss_kernel kernel;
    ms_error error;
    memset(&kernel, 0, sizeof kernel);
    return ended(ms_sss_kernel_build(&kernel, designer(), (const ms_sss_kernel_options *)options, &error), &error,
                 &kernel, sizeof kernel);
}

typedef struct radius_of {
    double radius_px;
} radius_of;

static runs run_radius(const void *radius)
{
    static const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
    static ms_sss_kernel kernel;
    ms_sss_profile *profile = NULL;
    ms_error error;
    ms_status status;
    memset(&kernel, 0, sizeof kernel);
    CHECK_INT(ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL), MS_OK);
    status = ms_sss_kernel_make(&kernel, NULL, profile, ((const radius_of *)radius)->radius_px, NULL, NULL, &error);
    ms_sss_profile_destroy(profile);
    return ended(status, &error, &kernel, sizeof kernel);
}

static runs run_filter(const void *options)
{
    static float in[40 * 24 * 3], out[40 * 24 * 3], depth[40 * 24];
    ms_sss_filter_options o = *(const ms_sss_filter_options *)options;
    ms_sss_frame frame;
    ms_error error;
    int i;
    const int texture = o.pixels_per_mm[0] > 0;
    for (i = 0; i < 40 * 24; ++i) {
        in[3 * i] = in[3 * i + 1] = in[3 * i + 2] = i % 40 < 17 ? 1.0f : 0.1f;
        depth[i] = 50 + 0.3f * (float)(i % 7);
    }
    memset(out, 0, sizeof out);
    memset(&frame, 0, sizeof frame);
    frame.width = 40;
    frame.height = 24;
    frame.input = ms_sss_interleaved(in, 3);
    frame.output = ms_sss_interleaved(out, 3);
    if (!texture) frame.depth = ms_sss_map((const float *)(const void *)depth, 1);
    return ended(ms_sss_filter(&frame, sss_kernel(1), 1, &o, NULL, 0, &error), &error, out, sizeof out);
}

static runs run_shader(const void *shader)
{
    static float out[600][4];
    static ms_sss_kernel kernel[MS_SSS_SHADER_PROFILES_MAX];
    const ms_sss_shader *s = (const ms_sss_shader *)shader;
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_error error;
    ms_status status;
    int i;
    o.pixels_per_mm[0] = 4;
    for (i = 0; i < MS_SSS_SHADER_PROFILES_MAX; ++i) kernel[i] = *sss_kernel(1);
    memset(out, 0, sizeof out);
    error.status = MS_OK;
    if (ms_sss_shader_constant_count(s) > 600) return ended(MS_UNSUPPORTED, &error, out, sizeof out);
    status = ms_sss_shader_constants(kernel, 0, &o, 640, 480, s, out, &error);
    CHECK((ms_sss_shader_constant_count(s) > 0) == (status == MS_OK));
    return ended(status, &error, out, sizeof out);
}

/* --- ms_nn.h --- */

static runs run_nn_shader(const void *shader)
{
    static char text[200000];
    unsigned char *file;
    ms_nn *nn = net_of(NET_DENSE, MS_NN_F32, &file);
    ms_error error;
    size_t size;
    memset(text, 0, sizeof text);
    error.status = MS_OK;
    size = nn_shader_text(nn, (const nn_shader *)shader, text, sizeof text, &error);
    ms_nn_destroy(nn);
    free(file);
    return ended(size ? MS_OK : error.status, &error, text, sizeof text);
}

/* --- the tables --- */

/* Every options structure, all zero but for what `set` says. */
typedef union options_of {
    ms_pme_options pme;
    ms_pme_match_options match;
    ms_gpr_fit_options fit;
    ms_gpr_recommend_options recommend;
    ms_gpr_latent_options plane;
    ms_mcml_options mcml;
    ms_mcml_profile_options profile;
    ms_mcml_medium medium;
    ms_sss_kernel_options kernel;
    radius_of radius;
    ms_sss_filter_options filter;
    ms_sss_shader shader;
    nn_shader shader_nn;
    char bytes[512];
} options_of;

static void set_fast(options_of *o) { o->mcml.photons = 20000; }
static void set_gaussians(options_of *o) { o->kernel.model = MS_SSS_GAUSSIANS; }
static void set_residual(options_of *o) { o->kernel.model = MS_SSS_RESIDUAL; }
static void set_texture(options_of *o) { o->filter.pixels_per_mm[0] = 2; }
static void set_camera(options_of *o) { o->filter.ortho_height = 12; }
static void set_medium(options_of *o) { o->medium.mu_a_per_mm = 0.1, o->medium.mu_s_per_mm = 1, o->medium.eta = 1.3; }
static void set_taps(options_of *o) { o->shader.tap_count = 7; }
static void set_up(options_of *o)
{
    o->shader.tap_count = 7, o->shader.step = MS_SSS_STEP_UP, o->shader.half_resolution = 1;
}
static void set_threshold(options_of *o) { o->recommend.search = MS_GPR_SEARCH_THRESHOLD; }

static const struct {
    runs (*run)(const void *options);
    void (*set)(options_of *o); /* or NULL */
    field f;
    double value, other; /* what 0 means; one that gives another result */
} defaults[] = {
    {run_pme, NULL, FIELD(ms_pme_options, max_cost, 'd'), 1000, 12},
    {run_pme, NULL, FIELD(ms_pme_options, tolerance, 'd'), 1e-10, 1e-2},
    {run_match, NULL, FIELD(ms_pme_match_options, refine.max_cost, 'd'), 50, 9},
    {run_fit, NULL, FIELD(ms_gpr_fit_options, evaluations, 'i'), 200, 3},
    {run_recommend, NULL, FIELD(ms_gpr_recommend_options, tau, 'd'), 0.6, 0.4},
    {run_simulate, NULL, FIELD(ms_mcml_options, photons, 'u'), 1000000, 500000},
    {run_simulate, set_fast, FIELD(ms_mcml_options, roulette_weight, 'd'), 0.01 * (3.0 / 303), 0.1},
    {run_profile, NULL, FIELD(ms_mcml_profile_options, depth_step, 'd'), 0.3, 0.5},
    {run_profile, NULL, FIELD(ms_mcml_profile_options, frequency_step, 'd'), 0.25, 0.5},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, tap_count, 'i'), 7, 9},
    {run_kernel, set_gaussians, FIELD(ms_sss_kernel_options, term_count, 'i'), 1, 2},
    {run_kernel, set_residual, FIELD(ms_sss_kernel_options, term_count, 'i'), 2, 3},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, index, 'd'), 1, 1.4},
    {run_radius, NULL, FIELD(radius_of, radius_px, 'd'), 24, 30},
    {run_filter, set_texture, FIELD(ms_sss_filter_options, pixels_per_mm[1], 'f'), 2, 3},
    {run_filter, set_camera, FIELD(ms_sss_filter_options, mm_per_unit, 'f'), 1, 1.5},
    {run_shader, set_up, FIELD(ms_sss_shader, term_count, 'i'), 1, 2},
    {run_nn_shader, NULL, FIELD(nn_shader, steps, 'i'), 2, 1},
};

static void zero_is_the_default(void)
{
    size_t i;
    for (i = 0; i < sizeof defaults / sizeof defaults[0]; ++i) {
        options_of o;
        runs zero, value, other;
        memset(&o, 0, sizeof o);
        if (defaults[i].set) defaults[i].set(&o);
        zero = defaults[i].run(&o);
        field_set(&o, &defaults[i].f, defaults[i].value);
        value = defaults[i].run(&o);
        field_set(&o, &defaults[i].f, defaults[i].other);
        other = defaults[i].run(&o);
        if (zero.status != MS_OK || value.status != MS_OK)
            TEST_FAIL("%s: %s %s", defaults[i].f.name, zero.message, value.message);
        if (zero.print != value.print) TEST_FAIL("%s: 0 is not %g", defaults[i].f.name, defaults[i].value);
        if (other.print == value.print) TEST_FAIL("%s: %g changes nothing", defaults[i].f.name, defaults[i].other);
    }
    TEST_NOTE("%d options", (int)i);
}

#define NONE 1e99

/* Lowest and highest accepted values, and the first refused below and above; NONE: nothing to be tried there. */
static const struct {
    runs (*run)(const void *options);
    void (*set)(options_of *o);
    field f;
    double below, low, high, above;
} limits[] = {
    {run_pme, NULL, FIELD(ms_pme_options, max_cost, 'd'), -1, 0, 1e9, NONE},
    {run_pme, NULL, FIELD(ms_pme_options, tolerance, 'd'), -1e-9, 0, 1e-3, HUGE_VAL},
    {run_pme, NULL, FIELD(ms_pme_options, restarts, 'i'), -1, 0, 3, NONE},
    {run_match, NULL, FIELD(ms_pme_match_options, random_count, 'i'), -1, 0, 5, NONE},
    {run_fit, NULL, FIELD(ms_gpr_fit_options, evaluations, 'i'), -1, 0, 5, NONE},
    {run_recommend, NULL, FIELD(ms_gpr_recommend_options, tau, 'd'), -0.001, 0, 0.9, 1.001},
    {run_recommend, set_threshold, FIELD(ms_gpr_recommend_options, search, 'i'), -1, 0, 2, 3},
    {run_simulate, set_fast, FIELD(ms_mcml_options, roulette_weight, 'd'), -1e-9, 0, 1, 1.0001},
    {run_simulate, NULL, FIELD(ms_mcml_options, photons, 'u'), NONE, 1, 2, 4294967297.0},
    {run_profile, NULL, FIELD(ms_mcml_profile_options, depth_step, 'd'), 0.2799, 0.28, 1, 1.0001},
    {run_profile, NULL, FIELD(ms_mcml_profile_options, frequency_step, 'd'), 0.1999, 0.2, 1, 1.0001},
    {run_medium, set_medium, FIELD(ms_mcml_medium, mu_a_per_mm, 'd'), -1e-12, 0, 1e6, HUGE_VAL},
    {run_medium, set_medium, FIELD(ms_mcml_medium, mu_s_per_mm, 'd'), -1e-12, 0, 1e6, HUGE_VAL},
    {run_medium, set_medium, FIELD(ms_mcml_medium, g, 'd'), -1, -0.5, 0.9, 1},
    {run_medium, set_medium, FIELD(ms_mcml_medium, eta, 'd'), 0.0999, 0.1, 10, 10.001},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, tap_count, 'i'), 1, 3, 33, 35},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, tap_count, 'i'), 2, 3, 5, 6},
    {run_kernel, set_residual, FIELD(ms_sss_kernel_options, term_count, 'i'), -1, 1, 6, 7},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, model, 'i'), -1, 0, 8, 9},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, placement, 'i'), -1, 0, 2, 3},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, dial, 'd'), -0.001, 0, 1, 1.001},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, guide_k, 'd'), -0.001, 0, 4, 4.001},
    {run_kernel, NULL, FIELD(ms_sss_kernel_options, index, 'd'), 0.999, 1, 2, 2.001},
    {run_radius, NULL, FIELD(radius_of, radius_px, 'd'), -1, 0.5, 1e9, 1.001e9},
    {run_filter, set_texture, FIELD(ms_sss_filter_options, flat, 'f'), -0.001, 0, 1, 1.001},
    {run_filter, NULL, FIELD(ms_sss_filter_options, fov_degrees, 'f'), -1, 20, 120, 180},
    {run_filter, set_texture, FIELD(ms_sss_filter_options, exact, 'i'), -1, 0, 1, 2},
    {run_filter, set_texture, FIELD(ms_sss_filter_options, depth_mode, 'i'), -1, 0, 1, 2},
    {run_shader, set_taps, FIELD(ms_sss_shader, tap_count, 'i'), 6, 7, 257, 259},
    {run_shader, set_taps, FIELD(ms_sss_shader, profile_count, 'i'), -1, 0, 16, 17},
    {run_shader, set_taps, FIELD(ms_sss_shader, jitter, 'f'), -0.1, 0, 1, 1.1},
    {run_nn_shader, NULL, FIELD(nn_shader, step, 'i'), -1, 0, 1, 2},
    {run_nn_shader, NULL, FIELD(nn_shader, steps, 'i'), -1, 0, 2, 3},
    {run_nn_shader, NULL, FIELD(nn_shader, language, 'i'), -1, 0, 4, 5},
};

static void limits_are_those_stated(void)
{
    size_t i;
    int k;
    for (i = 0; i < sizeof limits / sizeof limits[0]; ++i)
        for (k = 0; k < 4; ++k) {
            const double v = k == 0 ? limits[i].below
                : k == 1            ? limits[i].low
                : k == 2            ? limits[i].high
                                    : limits[i].above;
            options_of o;
            runs r;
            if (v > 0.9 * NONE && v < 1.1 * NONE) continue;
            memset(&o, 0, sizeof o);
            if (limits[i].set) limits[i].set(&o);
            field_set(&o, &limits[i].f, v);
            r = limits[i].run(&o);
            if (k == 1 || k == 2 ? r.status == MS_INVALID_ARGUMENT : r.status != MS_INVALID_ARGUMENT)
                TEST_FAIL("%s of %.10g: status %d, \"%s\"", limits[i].f.name, v, (int)r.status, r.message);
        }
    TEST_NOTE("%d arguments", (int)i);
}

/* Sizes that no machine has are refused before any memory is touched; the largest that are allowed work. */
static void extreme_sizes(void)
{
    static const size_t residuals[] = {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8, SIZE_MAX / 16 + 1};
    static const int grids[][3] = {
        {INT_MAX, 1, 1},  {1, INT_MAX, 1},     {INT_MAX, 1, INT_MAX}, {INT_MAX, INT_MAX, INT_MAX},
        {16777217, 1, 1}, {16777216, 1, 1000}, {65536, 65536, 65536}, {46341, 46341, 1}};
    static const sss_call taps = {"taps", 0, 1, 1, 0};
    static const sss_call pyramid = {"pyramid", 1, 1, 1, 0};
    static const ms_mcml_layer layer = {1.4, 10, 90, 0.8, 0.02};
    static double offset = 0.5;
    const ms_mcml_tissue tissue = {1, 1, 1, &layer};
    size_t i;
    for (i = 0; i < sizeof residuals / sizeof residuals[0]; ++i) {
        ms_pme_function f;
        double x[2] = {0, 0};
        memset(&f, 0, sizeof f);
        f.user = &offset;
        f.parameter_count = 2;
        f.residual_count = residuals[i];
        f.residuals = valley;
        CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, NULL), MS_OUT_OF_MEMORY);
        f.residual_count = 3;
        f.parameter_count = i == 0 ? MS_PME_PARAMETERS_MAX + 1 : i == 1 ? INT_MAX : i == 2 ? INT_MIN : 0;
        CHECK_INT(ms_pme_minimize(&f, NULL, x, NULL, NULL), MS_INVALID_ARGUMENT);
    }
    for (i = 0; i < sizeof grids / sizeof grids[0]; ++i) {
        ms_mcml *tally = NULL;
        ms_mcml_grid grid;
        memset(&grid, 0, sizeof grid);
        grid.dr_cm = grid.dz_cm = 0.01;
        grid.nr = grids[i][0], grid.nz = grids[i][1], grid.na = grids[i][2];
        CHECK_INT(ms_mcml_create(&tissue, &grid, NULL, &tally, NULL), i < 5 ? MS_INVALID_ARGUMENT : MS_UNSUPPORTED);
        CHECK(tally == NULL);
    }
    for (i = 0; i < 2; ++i) {
        const int width = i ? 1 : 65536, height = i ? 65536 : 1;
        sss_run(&taps, width, height, 0xCD, 0);
        sss_run(&pyramid, width, height, 0xCD, 0);
    }
    CHECK(ms_sss_shader_levels(65536, 65536) > 0 && ms_sss_shader_levels(1, 1) > 0);
}

static const test_case cases[] = {{"memory: ms_nn.h", memory_nn},
                                  {"memory: ms_sss.h", memory_sss},
                                  {"memory: texts", memory_texts},
                                  {"memory: ms_gpr.h", memory_gpr},
                                  {"memory: ms_mcml.h", memory_mcml},
                                  {"extreme sizes", extreme_sizes},
                                  {"frozen by equal bounds", frozen_by_equal_bounds},
                                  {"zero is the default", zero_is_the_default},
                                  {"limits", limits_are_those_stated}};
TEST_MAIN(cases)
