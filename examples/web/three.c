/* What sss_three.js and sss_babylon.js ask of ms_sss.h, in WebAssembly: kernels of materials and the constants of both passes.
     clang --target=wasm32-wasi -mexec-model=reactor -Os -I. examples/web/three.c -o three.wasm
   Calls return 0, or a status, and then message() says why. */
#define MS_NO_SIMD
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define CALL(type, name, arguments) \
    type web_##name arguments;      \
    __attribute__((export_name(#name))) type web_##name arguments

enum { MATERIALS = MS_SSS_SHADER_PROFILES_MAX, CONSTANTS = 1024 };

static ms_error error;
static ms_sss_kernel kernel[MATERIALS];
static double number[512];
static float constant[CONSTANTS][4];

CALL(double *, numbers, (void)) { return number; }
CALL(float *, constants, (void)) { return constant[0]; }
CALL(const char *, message, (void)) { return error.message; }

static int make(ms_sss_profile *profile, int index, int taps, double radius_px)
{
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    ms_status status;
    int c;
    options.tap_count = taps;
    status = ms_sss_kernel_make(&kernel[index], NULL, profile, radius_px, &options, NULL, &error);
    ms_sss_profile_destroy(profile);
    if (status != MS_OK) return (int)status;
    number[0] = (double)kernel[index].radius_mm;
    for (c = 0; c < 3; ++c) {
        number[1 + c] = (double)kernel[index].reflectance[c];
        number[4 + c] = (double)kernel[index].decay[c];
    }
    return 0;
}

/* Numbers 0 to 2: diffuse reflectance, 3 to 5: mean free path in mm. Afterwards 0: radius in mm, 1 to 3: reflectance, 4
   to 6: decay a mm, as ms_sss_transmission takes them, 7 to 9: Burley's d in mm. radius_px: what the taps are optimized for. */
CALL(int, material, (int index, int taps, double radius_px))
{
    ms_sss_profile *profile;
    double d[3];
    ms_status status;
    int c;
    if (index < 0 || index >= MATERIALS)
        return (int)ms__fail(&error, MS_INVALID_ARGUMENT, 0, "at most %d materials", MATERIALS);
    for (c = 0; c < 3; ++c) d[c] = ms_sss_burley_d_mm(number[c], number[3 + c]);
    status = ms_sss_profile_from_burley(&profile, number, d, NULL, &error);
    if (status != MS_OK || (status = (ms_status)make(profile, index, taps, radius_px)) != MS_OK) return (int)status;
    for (c = 0; c < 3; ++c) number[7 + c] = d[c];
    return 0;
}

/* The same for a profile of `count` rings: in numbers their edges [count + 1] in mm, then three channels [count] in
   1/mm^2. The taps are optimized for the radius that 99% of its light leaves within, at pixels_per_mm. */
CALL(int, rings, (int index, int count, int taps, double pixels_per_mm))
{
    const double *value[3];
    double radius_mm[3];
    ms_sss_profile *profile;
    ms_status status;
    int c;
    if (index < 0 || index >= MATERIALS || count < 1 || 4 * count + 1 > (int)(sizeof number / sizeof *number))
        return (int)ms__fail(&error, MS_INVALID_ARGUMENT, 0, "at most %d materials of 127 rings", MATERIALS);
    for (c = 0; c < 3; ++c) value[c] = number + count + 1 + c * count;
    status = ms_sss_profile_from_rings(&profile, count, number, value, 1, NULL, &error);
    if (status != MS_OK) return (int)status;
    ms_sss_profile_radius(profile, 0.99, radius_mm);
    return make(profile, index, taps, pixels_per_mm * fmax(fmax(radius_mm[0], radius_mm[1]), radius_mm[2]));
}

/* How many vec4 there are in constants(), the same for both passes; 0: message() says why not. */
CALL(int, fill,
     (int taps, int materials, int width, int height, double fov_degrees, double mm_per_unit, double center_x,
      double center_y))
{
    ms_sss_shader shader = ms_sss_shader_defaults();
    ms_sss_filter_options view = ms_sss_filter_defaults();
    int count;
    shader.tap_count = taps;
    shader.profile_count = materials;
    view.fov_degrees = (float)fov_degrees;
    view.mm_per_unit = (float)mm_per_unit;
    view.center[0] = (float)center_x;
    view.center[1] = (float)center_y;
    count = ms_sss_shader_constant_count(&shader);
    return count <= CONSTANTS &&
            ms_sss_shader_constants(kernel, 0, &view, width, height, &shader, constant, &error) == MS_OK
        ? count
        : 0;
}
