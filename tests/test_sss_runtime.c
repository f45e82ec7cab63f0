/* The run-time part of ms_sss.h alone, as an engine takes it that carries its kernels as data; depth as engines store
   it. */
#define MS_SSS_NO_DESIGN
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "compose.h"
#include "test.h"

enum { W = 96, H = 64 };

/* Three taps by hand: half of the light stays, a quarter goes to either side, 6 mm away. */
static const ms_sss_kernel shipped = {3,           1,         {0, 6},    {{{0.5f, 0.5f, 0.5f}, {0.25f, 0.25f, 0.25f}}},
                                      {{1, 1, 1}}, {0, 0, 0}, 8,         {0.5f, 0.5f, 0.5f},
                                      8,           {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

static float light[3 * W * H], result[3 * W * H], depth[W * H], stored[W * H];

static ms_sss_frame frame_of(int with_depth)
{
    ms_sss_frame f;
    memset(&f, 0, sizeof f);
    f.width = W;
    f.height = H;
    f.input = ms_sss_interleaved(light, 3);
    f.output = ms_sss_interleaved(result, 3);
    if (with_depth) f.depth = ms_sss_map(depth, 1);
    return f;
}

static ms_status run(const ms_sss_frame *f, const ms_sss_filter_options *o, ms_error *error)
{
    const size_t size = ms_sss_filter_workspace(f->width, f->height, &shipped, 1, o);
    void *workspace = malloc(size);
    const ms_status status = ms_sss_filter(f, &shipped, 1, o, workspace, size, error);
    free(workspace);
    return status;
}

static void case_shipped(void)
{
    ms_sss_filter_options o = ms_sss_filter_defaults();
    const ms_sss_frame f = frame_of(0);
    ms_error error;
    int i;
    for (i = 0; i < 3 * W * H; ++i) light[i] = i / 3 % W < W / 2 ? 1.0f : 0.0f;
    o.pixels_per_mm[0] = 1;
    CHECK_INT(run(&f, &o, &error), MS_OK);
    for (i = 0; i < W; ++i) { /* the edge of a shadow: three steps, six pixels away */
        const double expected = i < W / 2 - 6 ? 1 : i < W / 2 ? 0.75 : i < W / 2 + 6 ? 0.25 : 0;
        CHECK_NEAR(result[3 * (H / 2 * W + i)], expected, 1e-6);
    }
}

/* Stores distances as an engine does, in double, and gets them back. */
static void case_depth(void)
{
    int reversed, way, i;
    for (reversed = 0; reversed < 2; ++reversed) {
        for (way = 0; way < 3; ++way) { /* a far plane, none, orthographic */
            const double near_plane = 0.25, far_plane = 80;
            for (i = 0; i < W * H; ++i) {
                const double z = near_plane + (i % 71 + 0.5) / 71 * 40;
                /* the textbook matrices: d = f (z - n) / (z (f - n)), 1 - n / z, (z - n) / (f - n); reversed: 1 - d */
                double d = way == 0 ? far_plane * (z - near_plane) / (z * (far_plane - near_plane))
                    : way == 1      ? 1 - near_plane / z
                                    : (z - near_plane) / (far_plane - near_plane);
                if (i % 10 == 3) d = 1; /* the sky: what a buffer is cleared to */
                stored[i] = i % 10 == 4 ? NAN : (float)(reversed ? 1 - d : d);
            }
            compose_linear_depth(stored, W * H, (float)near_plane, way == 1 ? 0.0f : (float)far_plane, reversed,
                                 way == 2, depth);
            for (i = 0; i < W * H; ++i) {
                const double z = near_plane + (i % 71 + 0.5) / 71 * 40;
                if (i % 10 == 3 || i % 10 == 4) CHECK(depth[i] > 3e38f);
                else { /* an ulp of d, at most 6e-8, moves z by z^2 / near: why engines reverse depth */
                    CHECK(fabs((double)depth[i] - z) < (way == 2       ? 1e-5
                                                            : reversed ? 4e-7 * z
                                                                       : 1.2e-7 * z * z / near_plane + 1e-6));
                }
            }
        }
    }
}

/* The same picture with its first row at the bottom, colors or depth or both, gives the same light. */
static void case_origins(void)
{
    static float turned[3 * W * H], turned_depth[W * H], top[3 * W * H];
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_frame f = frame_of(1);
    ms_error error;
    int x, y, c, wrong = 0;
    o.fov_degrees = 40;
    o.mm_per_unit = 1;
    for (y = 0; y < H; ++y)
        for (x = 0; x < W; ++x) {
            depth[y * W + x] = turned_depth[(H - 1 - y) * W + x] = (float)(90 + 0.3 * x + 0.1 * y + (y > 40 ? 25 : 0));
            for (c = 0; c < 3; ++c)
                light[3 * (y * W + x) + c] = turned[3 * ((H - 1 - y) * W + x) + c] = (float)((x / 7 + y / 5 + c) % 3) /
                    2;
        }
    CHECK_INT(run(&f, &o, &error), MS_OK);
    memcpy(top, result, sizeof top);
    f.input = ms_sss_interleaved(turned + 3 * W * (H - 1), 3);
    f.input.row_stride = -3 * W;
    CHECK_INT(run(&f, &o, &error), MS_OK);
    wrong += memcmp(top, result, sizeof top) != 0;
    f.depth = ms_sss_map(turned_depth + W * (H - 1), 1);
    f.depth.row_stride = -W;
    f.output = ms_sss_interleaved(result + 3 * W * (H - 1), 3);
    f.output.row_stride = -3 * W;
    CHECK_INT(run(&f, &o, &error), MS_OK);
    for (y = 0; y < H; ++y) wrong += memcmp(top + 3 * W * y, result + 3 * W * (H - 1 - y), 3 * W * sizeof(float)) != 0;
    CHECK_INT(wrong, 0);
}

static void case_field_of_view(void)
{
    const double degree = 3.14159265358979 / 180;
    CHECK_NEAR(compose_fov_along_y(90, 1920, 1080), 2 * atan(1080.0 / 1920) / degree, 1e-4);
    CHECK_NEAR(compose_fov_along_y(60, 500, 500), 60, 1e-4);
}

/* Light through thin parts: the larger of both, before albedo and specular. */
static void case_compose(void)
{
    const float in[3] = {1, 2, 3}, filtered[3] = {0.5f, 2.5f, 3}, through[3] = {0.6f, 0.1f, 4},
                albedo[3] = {0.5f, 1, 2}, specular[3] = {0.25f, 0.25f, 0.25f};
    float out[3];
    int c;
    compose_pixel(in, filtered, 0, NULL, NULL, NULL, out);
    for (c = 0; c < 3; ++c) CHECK_NEAR(out[c], filtered[c], 0);
    compose_pixel(in, filtered, 0.5f, through, albedo, specular, out);
    for (c = 0; c < 3; ++c)
        CHECK_NEAR(out[c], fmaxf(0.5f * (in[c] + filtered[c]), through[c]) * albedo[c] + specular[c], 1e-6);
}

/* A head in a room, in meters: refused until mm_per_unit says so. The same in millimeters works without. */
static void case_metres(void)
{
    ms_sss_filter_options o = ms_sss_filter_defaults();
    const ms_sss_frame f = frame_of(1);
    ms_error error;
    int i, unit;
    for (unit = 0; unit < 3; ++unit) { /* mm, m, cm */
        const float mm = unit == 0 ? 1.0f : unit == 1 ? 1000.0f : 10.0f;
        for (i = 0; i < W * H; ++i) depth[i] = (i % W > 30 && i % W < 60 ? 450.0f : 3000.0f) / mm;
        depth[77] = 1e-6f; /* one pixel of rubbish decides nothing */
        for (i = 0; i < 3 * W * H; ++i) result[i] = -7;
        o.ortho_height = 0;
        o.fov_degrees = 35;
        o.mm_per_unit = 0;
        if (unit == 1) {
            CHECK_INT(run(&f, &o, &error), MS_INVALID_ARGUMENT);
            CHECK(strstr(error.message, "mm_per_unit") != NULL);
            CHECK(result[0] < -6);
        } else if (unit == 0) {
            CHECK_INT(run(&f, &o, &error), MS_OK);
        }
        o.mm_per_unit = mm;
        CHECK_INT(run(&f, &o, &error), MS_OK);
        o.fov_degrees = 0;
        o.ortho_height = 300 / mm;
        CHECK_INT(run(&f, &o, &error), MS_OK);
        o.mm_per_unit = 0;
        if (unit != 2) CHECK_INT(run(&f, &o, &error), unit == 1 ? MS_INVALID_ARGUMENT : MS_OK);
    }
}

static const test_case cases[] = {
    {"a kernel as data", case_shipped},    {"depth as stored", case_depth}, {"origins", case_origins},
    {"field of view", case_field_of_view}, {"composition", case_compose},   {"meters", case_metres},
};
TEST_MAIN(cases)
