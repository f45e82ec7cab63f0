/* The kernel designer's side of WebAssembly: profiles, kernels, the shaders' constants and their WGSL, the CPU's filter
   and the layers of the objects of scene.h, behind calls of numbers, for kernels.worker.js.
     clang --target=wasm32-wasi -mexec-model=reactor -O3 -msimd128 -I. examples/web/kernels.c -o kernels.wasm
   Calls return 0, or a status, and then message() says why. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "../demo/scene.h"
#include "../tools/layered.h"
#include "../tools/skin.h"
#include "../tools/wgsl.h"

#define CALL(type, name, arguments) \
    type web_##name arguments;      \
    __attribute__((export_name(#name))) type web_##name arguments

enum { SIDE = 1024, CURVE = 96, TEXT = 1 << 17, CONSTANTS = 160 };

static ms_error error;
static ms_sss_profile *profile;
static ms_sss_kernel kernel;
static ms_sss_pyramid pyramid;
static int grown; /* the pyramid is of this profile */
static ms_sss_errors errors;
static ms_sss_filter_options view;
static double number[64 + 8 * CURVE];
static float constant[CONSTANTS][4];
static char text[TEXT];
static scene_grid grid[2];
static double made_for[8]; /* what the profile was made of */

CALL(double *, numbers, (void)) { return number; }
CALL(float *, constants, (void)) { return constant[0]; }
CALL(char *, text, (void)) { return text; }
CALL(const char *, message, (void)) { return error.message; }
CALL(void *, room, (int bytes)) { return malloc((size_t)bytes); }
CALL(void, leave, (void *block)) { free(block); }

CALL(int, materials, (void)) /* their names, a line each; how many */
{
    int count, i;
    const ms_mcml_material *m = ms_mcml_materials(&count);
    size_t n = 0;
    for (i = 0; i < count; ++i) n += (size_t)snprintf(text + n, sizeof text - n, "%s\n", m[i].name);
    return count;
}

/* ---------------------------------------------------------------------------------------------------------- kernels */

static ms_status make_profile(int material, const double *own)
{
    ms_mcml_medium medium[3];
    ms_mcml_profile rings;
    const double *rd[3];
    double d[3];
    int c, count;
    ms_status status;
    const ms_mcml_material *all = ms_mcml_materials(&count);
    ms_mcml_profile_options options;
    ms_sss_profile *made;
    if (material == -2) {
        skin_parameters skin = skin_defaults();
        skin.melanin = own[0];
        skin.blood = own[1];
        status = skin_profile(&rings, &skin, NULL, &error);
        if (status != MS_OK) return status;
        for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
        status = ms_sss_profile_from_rings(&made, rings.rings, rings.edge_mm, rd, 1, NULL, &error);
        ms_mcml_profile_destroy(&rings);
    } else if (material < 0) {
        for (c = 0; c < 3; ++c) d[c] = ms_sss_burley_d_mm(own[c], own[3 + c]);
        status = ms_sss_profile_from_burley(&made, own, d, NULL, &error);
    } else {
        for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(&all[material < count ? material : 0], c);
        memset(&options, 0, sizeof options);
        options.depth_step = 0.5; /* a quarter of the time; 1e-8 of a total, 0.6% of a ring with 1e-5 of the energy */
        options.frequency_step = 0.4;
        status = ms_mcml_profile_make(&rings, medium, 3, &options, &error);
        if (status != MS_OK) return status;
        for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
        status = ms_sss_profile_from_rings(&made, rings.rings, rings.edge_mm, rd, 1, NULL, &error);
        ms_mcml_profile_destroy(&rings);
    }
    if (status != MS_OK) return status;
    ms_sss_profile_destroy(profile);
    profile = made;
    grown = 0;
    return MS_OK;
}

/* A kernel (rough: its errors are not measured; taps 0: as few as show no bands): material; -1 and numbers 0 to 5,
   color and mean free paths in mm; -2 and numbers 0 and 1, melanin and blood of skin; its place on the screen by pixels
   a millimeter of material. Numbers then: 0 to 4 ms_sss_errors, 7 taps, 8 radius in mm, 9 radius in pixels, 10 to 12
   reflectance, 13 to 15 decay; from 64 on CURVE rows of r, R_d in three channels, x, a_p in three channels. */
CALL(int, design, (int material, int taps, int model, double pixels_per_mm, int rough))
{
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    ms_sss_kernel next;
    double key[8], radius[3], most, strip[2][3];
    int i, c, same = profile != NULL;
    ms_status status = MS_OK;
    key[0] = material;
    key[7] = 0;
    for (i = 0; i < 6; ++i) key[1 + i] = material < 0 ? number[i] : 0;
    for (i = 0; i < 8; ++i) same = same && fabs(key[i] - made_for[i]) <= 0;
    if (!same) status = make_profile(material, number);
    if (status != MS_OK) return (int)status;
    memcpy(made_for, key, sizeof key);
    ms_sss_profile_radius(profile, 0.99, radius);
    most = fmax(fmax(radius[0], radius[1]), radius[2]);
    options.model = (ms_sss_model)model;
    options.index = 1.3;
    for (i = taps ? taps : 7; i <= 33; i += 2) {
        options.tap_count = i;
        status = ms_sss_kernel_make(&next, rough ? NULL : &errors, profile, fmax(most * pixels_per_mm, 1), &options,
                                    NULL, &error);
        if (status != MS_OK) return (int)status;
        if (taps || errors.bands <= MS_SSS_BANDS_SEEN) break;
    }
    kernel = next;
    memcpy(number, &errors, sizeof errors);
    number[7] = kernel.tap_count;
    number[8] = most;
    number[9] = most * pixels_per_mm;
    for (c = 0; c < 3; ++c) {
        number[10 + c] = (double)kernel.reflectance[c];
        number[13 + c] = (double)kernel.decay[c];
    }
    for (i = 0; i < CURVE; ++i) {
        double *row = number + 64 + 8 * i, r = most * (i + 0.5) / (double)CURVE,
               x = (double)kernel.radius_mm * (i + 0.5) / (double)CURVE,
               h = 0.5 * (double)kernel.radius_mm / (double)CURVE;
        row[0] = r;
        ms_sss_profile_value(profile, r, row + 1);
        row[4] = x;
        ms_sss_profile_strip(profile, x + h, strip[1]);
        ms_sss_profile_strip(profile, x - h, strip[0]);
        for (c = 0; c < 3; ++c)
            row[5 + c] = (strip[1][c] - strip[0][c]) / (4 * h) / fmax((double)kernel.reflectance[c], 1e-6);
    }
    return 0;
}

/* What scattering makes of a shadow's straight edge, at distances first_mm + i step_mm on its lit side, as a share of the
   light far away: into numbers from 64 on, [count][3], at most 256. */
CALL(void, edge, (int count, double first_mm, double step_mm))
{
    double within[3];
    int i, c;
    for (i = 0; i < count && i < 256; ++i) {
        ms_sss_profile_strip(profile, first_mm + i * step_mm, within);
        for (c = 0; c < 3; ++c)
            number[64 + 3 * i + c] = 0.5 + 0.5 * within[c] / fmax((double)kernel.reflectance[c], 1e-6);
    }
}

/* The center, then each pair at -offset and +offset. */
static float tap_mm(int i) { return (i % 2 ? -1.0f : 1.0f) * kernel.offset_mm[(i + 1) / 2]; }

/* Taps into numbers from 64 on: [taps] of weights and offset. */
CALL(int, taps, (void))
{
    int i, c;
    for (i = 0; i < kernel.tap_count && i < 2 * CURVE; ++i) {
        for (c = 0; c < 3; ++c) number[64 + 4 * i + c] = (double)kernel.weight[0][(i + 1) / 2][c];
        number[67 + 4 * i] = (double)tap_mm(i);
    }
    return kernel.tap_count;
}

/* ------------------------------------------------------------------------------------------------------- the shaders
 */

/* The camera. Ways to filter: 0 taps, 1 taps at half resolution, 2 a pyramid. */
static void see(double mm_per_unit, double flat)
{
    view = ms_sss_filter_defaults();
    view.fov_degrees = 24;
    view.mm_per_unit = (float)mm_per_unit;
    view.flat = (float)flat;
}

/* The pyramid of the profile, once. */
CALL(int, grow, (void))
{
    const ms_status status = grown ? MS_OK : ms_sss_pyramid_make(&pyramid, profile, &error);
    grown = status == MS_OK;
    return (int)status;
}

CALL(int, levels, (int size)) { return ms_sss_shader_levels(size, size); }

/* WGSL of a shader file behind its #defines, into text. */
CALL(int, wgsl, (const char *source))
{
    const char *problem = wgsl_make("", source, NULL, text, sizeof text);
    return problem ? (int)ms__fail(&error, MS_BAD_DATA, 0, "WGSL: %s", problem) : 0;
}

/* How many float4 there are in constants(), 0: message() says why not. */
CALL(int, fill, (int width, int height, int way, int step, int level, double mm_per_unit, double flat))
{
    ms_sss_shader shader = ms_sss_shader_defaults();
    int count;
    shader.step = (ms_sss_step)step;
    shader.tap_count = kernel.tap_count;
    shader.half_resolution = way == 1;
    shader.pyramids = &pyramid;
    shader.level = level;
    shader.pyramids = &pyramid;
    count = ms_sss_shader_constant_count(&shader);
    see(mm_per_unit, flat);
    return count <= CONSTANTS &&
            ms_sss_shader_constants(&kernel, 0, &view, width, height, &shader, constant, &error) == MS_OK
        ? count
        : 0;
}

/* The kernel as source: 0 C, 1 HLSL, 2 GLSL, 3 JSON. */
CALL(int, code, (int kind))
{
    static const char *const head[4] = {"static const float sss_kernel[%d][4] = {",
                                        "static const float4 sss_kernel[%d] = {", "const vec4 sss_kernel[%d] = vec4[](",
                                        "{\"taps\": %d, \"kernel\": ["};
    static const char *const open[4] = {"{", "float4(", "vec4(", "["}, *const close[4] = {"}", ")", ")", "]"},
                             *const end[4] = {"\n};\n", "\n};\n", "\n);\n", "\n]"};
    size_t n = 0;
    int i, c;
    if (kind < 0 || kind > 3) return (int)MS_INVALID_ARGUMENT;
    if (kind != 3)
        n += (size_t)snprintf(
            text + n, sizeof text - n,
            "// red, green, blue weight and offset in mm of a pass along x, then along y; then the light itself, times delta, added\n");
    n += (size_t)snprintf(text + n, sizeof text - n, head[kind], kernel.tap_count);
    for (i = 0; i < kernel.tap_count; ++i) {
        n += (size_t)snprintf(text + n, sizeof text - n, "%s\n    %s", i ? "," : "", open[kind]);
        for (c = 0; c < 4; ++c)
            n += (size_t)snprintf(text + n, sizeof text - n, kind == 0 ? "%s%.7ff" : "%s%.7f", c ? ", " : "",
                                  (double)(c < 3 ? kernel.weight[0][(i + 1) / 2][c] *
                                                   (kernel.scale[0][c] > 0 ? sqrtf(kernel.scale[0][c]) : 1)
                                                 : tap_mm(i)));
        n += (size_t)snprintf(text + n, sizeof text - n, "%s", close[kind]);
    }
    n += (size_t)snprintf(text + n, sizeof text - n, "%s", end[kind]);
    n += (size_t)snprintf(
        text + n, sizeof text - n,
        kind == 3
            ? ", \"delta\": [%.7f, %.7f, %.7f], \"reflectance\": [%.7f, %.7f, %.7f], \"decay_per_mm\": [%.7f, %.7f, %.7f]}\n"
            : kind == 0
            ? "static const float sss_delta[3] = {%.7ff, %.7ff, %.7ff}, sss_reflectance[3] = {%.7ff, %.7ff, %.7ff}, sss_decay_per_mm[3] = {%.7ff, %.7ff, %.7ff};\n"
            : kind == 1
            ? "static const float3 sss_delta = float3(%.7f, %.7f, %.7f), sss_reflectance = float3(%.7f, %.7f, %.7f), sss_decay_per_mm = float3(%.7f, %.7f, %.7f);\n"
            : "const vec3 sss_delta = vec3(%.7f, %.7f, %.7f), sss_reflectance = vec3(%.7f, %.7f, %.7f), sss_decay_per_mm = vec3(%.7f, %.7f, %.7f);\n",
        (double)kernel.delta[0], (double)kernel.delta[1], (double)kernel.delta[2], (double)kernel.reflectance[0],
        (double)kernel.reflectance[1], (double)kernel.reflectance[2], (double)kernel.decay[0], (double)kernel.decay[1],
        (double)kernel.decay[2]);
    return 0;
}

/* ------------------------------------------------------------------------------------------------- the CPU's filter */

/* light [height][width][4] with depth in alpha, normals [height][width][4]; out [height][width][4], which may not be
   the light. */
CALL(int, filter,
     (const float *light, const float *normals, float *out, int width, int height, int way, double mm_per_unit,
      double flat))
{
    ms_sss_frame frame;
    memset(&frame, 0, sizeof frame);
    see(mm_per_unit, flat);
    frame.width = width;
    frame.height = height;
    frame.input = ms_sss_interleaved(light, 4);
    frame.output = ms_sss_interleaved(out, 4);
    frame.depth = ms_sss_map(light + 3, 4);
    if (flat < 1) frame.normal = ms_sss_interleaved(normals, 4);
    return (int)(way == 2 ? ms_sss_pyramid_filter(&frame, &pyramid, 1, &view, NULL, 0, &error)
                          : ms_sss_filter(&frame, &kernel, 1, &view, NULL, 0, &error));
}

/* ------------------------------------------------------------------------------------------------------ the objects */

/* The grid of distances of object 0 or 1 for shadows, as bytes: 128 at the surface, `step` mm each. Numbers: low and
   high corner, sides, cell, step, camera: eye, right, up, back. NULL: no memory. */
CALL(unsigned char *, volume, (int object))
{
    scene_grid *g = &grid[object];
    scene_camera c = scene_camera_of((scene_object)object);
    float step = object == SCENE_BUST ? 0.5f : 0.2f;
    unsigned char *out;
    int i, count;
    const scene_vec axes[4] = {c.eye, c.right, c.up, c.back};
    if (g->distance == NULL && !scene__grid_make(g, (scene_object)object, object == SCENE_BUST ? 4.0f : 1.5f))
        return NULL;
    count = g->nx * g->ny * g->nz;
    out = (unsigned char *)malloc((size_t)count);
    if (out == NULL) return NULL;
    for (i = 0; i < count; ++i) out[i] = (unsigned char)scene__clamp(floorf(g->distance[i] / step + 128.5f), 0, 255);
    number[0] = (double)g->low.x, number[1] = (double)g->low.y, number[2] = (double)g->low.z;
    number[3] = (double)g->high.x, number[4] = (double)g->high.y, number[5] = (double)g->high.z;
    number[6] = g->nx, number[7] = g->ny, number[8] = g->nz;
    number[9] = (double)g->cell;
    number[10] = (double)step;
    for (i = 0; i < 4; ++i) {
        number[11 + 3 * i] = (double)axes[i].x;
        number[12 + 3 * i] = (double)axes[i].y;
        number[13 + 3 * i] = (double)axes[i].z;
    }
    return out;
}

/* Rows y0 to y1 - 1 of a picture of an object: surface [rows][width][4], its normal towards the camera (x right, y
   down) and depth in mm; fine [rows][width][4], the normal with pores in the world, and how open it is; tint
   [rows][width][4], the color relative to the material's (object) or as it is, and 255: object, 170: eye, 85: what
   stands behind. */
CALL(int, layers, (int object, int width, int height, int y0, int y1, float *surface, float *fine, unsigned char *tint))
{
    static const float half[3] = {0.5f, 0.5f, 0.5f};
    scene_camera camera = scene_camera_of((scene_object)object);
    scene_grid *g = &grid[object];
    int x, y, c;
    for (y = y0; y < y1; ++y)
        for (x = 0; x < width; ++x, surface += 4, fine += 4, tint += 4) {
            scene_vec ray = scene_ray(&camera, width, height, (float)x + 0.5f, (float)y + 0.5f), p, n, m;
            scene_hit hit = scene__trace(g, camera.eye, ray);
            scene_surface s;
            p = scene_mad(ray, hit.t, camera.eye);
            m = n = scene__normal(g, hit.what, p);
            if (hit.what == SCENE_BACKDROP) s = scene__wall((scene_object)object, p);
            else if (hit.what == SCENE_EYE) s = scene__eye(p);
            else if (object == SCENE_BUST) s = scene__skin(p, half), m = scene__roughen(n, p);
            else s = scene__marble(p, half);
            surface[0] = scene_dot(n, camera.right);
            surface[1] = -scene_dot(n, camera.up);
            surface[2] = scene_dot(n, camera.back);
            surface[3] = -scene_dot(ray, camera.back) * hit.t;
            fine[0] = m.x;
            fine[1] = m.y;
            fine[2] = m.z;
            fine[3] = scene__openness(g, p, n);
            for (c = 0; c < 3; ++c) tint[c] = image_to_byte(s.albedo[c]);
            tint[3] = hit.what == SCENE_OBJECT ? 255 : hit.what == SCENE_EYE ? 170 : 85;
        }
    return 0;
}
