// sources 217819341
(() => {
const SHADER = `
// Subsurface scattering in screen space: the passes X and Y, half resolution, and light through thin parts.
//
// One text for GLSL 330, GLSL ES 300 (WebGL 2), GLSL for Vulkan and HLSL; examples/tools/sss_wgsl.c makes WGSL of it.
// A fragment shader is a line of #version, #defines, the engine's functions that read its textures, and this file:
//
//     #version 330
//     #define MS_SSS_STEP 0
//     uniform sampler2D light, depth;
//     vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
//     float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depth, p, 0).r; }
//
// A triangle over the target runs it. ms_sss_shader_constants of ms_sss.h fills the array ms_sss: an array of
// uniforms, or the constant buffer at binding 0.
//
//     #define             default
//     MS_SSS_STEP                  0 X, 1 Y, 2 DOWN, 3 UP; 8 ms_sss_transmission alone, for the engine's light loop;
//                                  4 to 7: those of ms_sss_pyramid.glsl, which follows this file; 9: ms_sss_disc.glsl
//     MS_SSS_TAPS         7        ms_sss_shader.tap_count
//     MS_SSS_PROFILES     0        kernels that ms_sss_fetch_profile selects from, up to 16; 0: one, no profiles
//     MS_SSS_TERMS        1        of UP: the most terms of any of the kernels
//     MS_SSS_PERSPECTIVE  1        0: orthographic, or a light map
//     MS_SSS_FLAT         0        1: without slopes and elevation, where options.flat is 1
//     MS_SSS_NORMAL       0        1: slopes from normals; 0: from depth
//     MS_SSS_STRENGTH     0        1: with strength
//     MS_SSS_ROTATED      0        1: rotation or jitter of ms_sss_shader
//     MS_SSS_HALF         0        1: X and Y lie between DOWN and UP
//     MS_SSS_HLSL, MS_SSS_VULKAN   defined: the language, where it is not the GLSL of OpenGL (MS_SSS_WGSL: by sss_wgsl.c)
//
// The engine defines those of these functions that a step reads; p is the pixel plus the viewport's corner:
//
//     float3 ms_sss_fetch_color(int2 p)     light before the albedo; not below 1e30: masked     X, Y, DOWN, UP
//     float ms_sss_fetch_depth(int2 p)      along the view axis; not > 0: masked                X, DOWN, UP
//     int ms_sss_fetch_profile(int2 p)      index of the kernel; without one: masked            X, DOWN, UP
//     float ms_sss_fetch_strength(int2 p)   0 to 1; 0: masked                                   X, Y, DOWN, UP
//     float3 ms_sss_fetch_normal(int2 p)    in view space: x right, y down, z to the camera     X, Y
//
// BASE and the disc read what X reads, RESOLVE color and strength. At half resolution X and Y read DOWN's target in their
// place. Without depth the second returns 1.0, with MS_SSS_FLAT 1. Depth of 16-bit floats also wants MS_SSS_FLAT 1: its
// steps are seen as elevation, even where slopes are from normals.
// Targets are textures of 32-bit floats (OpenGL: GL_NEAREST), at these bindings:
//
//     X     writes light, and depth (0: masked) in alpha; the profile in the last 4 bits of blue
//     Y     the result; reads ms_sss_input (4): X's target. The Y of further terms are added to it by blending
//     DOWN  writes as X. Then X reads ms_sss_input: DOWN's target, and Y also ms_sss_half (12): DOWN's target
//     UP    the result; reads ms_sss_half (12): DOWN's target, and ms_sss_sum (6): Y's target

#ifndef MS_SSS_TAPS
#define MS_SSS_TAPS 7
#endif
#ifndef MS_SSS_PROFILES
#define MS_SSS_PROFILES 0
#endif
#ifndef MS_SSS_TERMS
#define MS_SSS_TERMS 1
#endif
#ifndef MS_SSS_PERSPECTIVE
#define MS_SSS_PERSPECTIVE 1
#endif
#ifndef MS_SSS_FLAT
#define MS_SSS_FLAT 0
#endif
#ifndef MS_SSS_NORMAL
#define MS_SSS_NORMAL 0
#endif
#ifndef MS_SSS_STRENGTH
#define MS_SSS_STRENGTH 0
#endif
#ifndef MS_SSS_ROTATED
#define MS_SSS_ROTATED 0
#endif
#ifndef MS_SSS_HALF
#define MS_SSS_HALF 0
#endif

// ---- languages -------------------------------------------------------------------------------------------------------

#if defined(MS_SSS_HLSL)
#define bits_of asuint
#define float_of asfloat
#define TEXTURE(name, read, slot, at) Texture2D<float4> name : register(at); float4 read(int2 p) { return name.Load(int3(p, 0)); }
#elif !defined(MS_SSS_WGSL) // whose macros the tool has
#define int2 ivec2
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define bits_of floatBitsToUint
#define float_of uintBitsToFloat
#ifdef MS_SSS_VULKAN
#define TEXTURE(name, read, slot, at) layout(set = 0, binding = slot) uniform sampler2D name; vec4 read(ivec2 p) { return texelFetch(name, p, 0); }
#else
#define TEXTURE(name, read, slot, at) uniform sampler2D name; vec4 read(ivec2 p) { return texelFetch(name, p, 0); }
#endif
#endif
#ifndef MS_SSS_WGSL
#define CONSTANT ms_sss
#define pick(if_not, if_so, condition) ((condition) ? (if_so) : (if_not))
#endif
#define zero2 float2(0.0, 0.0)
#define zero3 float3(0.0, 0.0, 0.0)
#define zero4 float4(0.0, 0.0, 0.0, 0.0)
#define one3 float3(1.0, 1.0, 1.0)

#if MS_SSS_STEP != 8
// ---- what the step is ------------------------------------------------------------------------------------------------

#define PASS (MS_SSS_STEP < 2)
#define SECOND (MS_SSS_STEP == 1)
#define DOWN (MS_SSS_STEP == 2)
#define UP (MS_SSS_STEP == 3)
#define PYRAMID (MS_SSS_STEP > 3 && MS_SSS_STEP < 8)
#define BASE (MS_SSS_STEP == 4)
#define GATHER (MS_SSS_STEP == 6)
#define RESOLVE (MS_SSS_STEP == 7)
#define DISC (MS_SSS_STEP == 9)
#define HALVED (PASS && MS_SSS_HALF > 0)
// RAW: it reads the engine's textures and masks their pixels, where others read the target of a step.
#define RAW (BASE || DOWN || UP || DISC || (MS_SSS_STEP == 0 && !HALVED))
#define SLOPES (MS_SSS_FLAT == 0 && (PASS || BASE || DISC))
#define NORMALS (MS_SSS_NORMAL > 0 && SLOPES && !HALVED)
#define PACKED (MS_SSS_PROFILES > 0 && !PYRAMID)

// Float4 of the constants: before the profiles (HEAD), of a profile (STRIDE), and in all.
#define STRIDE (6 + MS_SSS_TAPS / 2)
#if MS_SSS_PROFILES > 0
#define KERNELS MS_SSS_PROFILES
#else
#define KERNELS 1
#endif
#define SIZES 49 // of a pyramid's table
#if RESOLVE
#define HEAD 7
#define COUNT (HEAD + 3 * SIZES)
#elif GATHER
#define HEAD 7
#define COUNT (HEAD + SIZES)
#elif PYRAMID
#define HEAD 7
#define COUNT HEAD
#elif UP
#define HEAD 4
#define COUNT (HEAD + MS_SSS_TERMS * KERNELS * STRIDE)
#else
#define HEAD 4
#define COUNT (HEAD + KERNELS * STRIDE)
#endif

// ---- constants and textures ------------------------------------------------------------------------------------------

#if defined(MS_SSS_HLSL)
cbuffer ms_sss_block : register(b0) { float4 ms_sss[COUNT]; };
#elif defined(MS_SSS_VULKAN)
layout(set = 0, binding = 0) uniform ms_sss_block { vec4 ms_sss[COUNT]; };
#elif !defined(MS_SSS_WGSL)
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
#endif
uniform vec4 ms_sss[COUNT];
#endif

#define PICTURE_SIZE CONSTANT[0].xy // in pixels, of the picture at full resolution
#define CENTER CONSTANT[HEAD - 1].xy // of the projection, in pixels
#define ORIGIN CONSTANT[HEAD - 1].zw // the viewport's corner
// of X, Y, DOWN and UP
#define PIXELS_PER_MM CONSTANT[0].z // perspective: at depth 1
#define GAIN CONSTANT[0].w // 1 - fade
#define ASPECT CONSTANT[1].xy // pixels a mm along x and y, relative to PIXELS_PER_MM
#define ROTATION CONSTANT[1].z // radians
#define JITTER CONSTANT[1].w
#define FIRST_TERM CONSTANT[2].x // 1: the term that adds the light itself
#define FOCAL CONSTANT[2].yz // pixels a unit of depth; perspective: at depth 1
#define SLOPE_SCALE CONSTANT[2].w // 1 - flat
// of a profile's kernel, which begins at HEAD + STRIDE * profile
#define TOTAL(at) CONSTANT[at] // sums of the weights; radius
#define RADIUS_MM(at) CONSTANT[at].w
#define SCALE(at) CONSTANT[at + 1].rgb // of the term
#define DEPTH_SCALE(at) CONSTANT[at + 1].w // to units of depth in which weights vanish at a difference of 1
#define DELTA(at) CONSTANT[at + 2].rgb // the part of the light that the filter leaves where it is
#define SPLIT(at) CONSTANT[at + 2].w // square of the difference of depth that DOWN and UP do not cross
#define ELEVATION(at) CONSTANT[at + 3].rgb // K / 4
#define MIXED(at) CONSTANT[at + 3].w // bits: channels with weights of both signs
#define ROOT(at) CONSTANT[at + 4].rgb // of the reflectance
#define REACH(at) CONSTANT[at + 4].w // square of the kernel's radius in units of depth
#define TAP(at, i) CONSTANT[at + 5 + i] // weight; offset in mm. 0: the center; then one of each pair

#if !RAW
TEXTURE(ms_sss_input, fetch_input, 4, t4)
#endif
#if UP || GATHER || RESOLVE
TEXTURE(ms_sss_sum, fetch_sum, 6, t6)
#endif
#if UP || (SECOND && HALVED)
TEXTURE(ms_sss_half, fetch_half, 12, t12)
#endif

// ---- a pixel: its light, depth, profile, and the slopes of its surface ------------------------------------------------

// Pixels of the picture along the side of one of this step's.
float side() { return pick(pick(1.0, 2.0, HALVED), 0.5 * CONSTANT[2].z, PYRAMID); }

// The corner of the viewport; targets of half the size have none.
int2 origin() { return int2(int(ORIGIN.x), int(ORIGIN.y)) * pick(1, 0, HALVED); }

bool inside(int2 p) {
    int step = int(side());
    return p.x >= 0 && p.y >= 0 && step * p.x < int(PICTURE_SIZE.x) && step * p.y < int(PICTURE_SIZE.y);
}

// In perspective a pixel shows a width in proportion to its depth.
float relative(float depth) { return pick(1.0, depth, MS_SSS_PERSPECTIVE > 0); }

// (x, y) / z of a pixel's ray.
float2 ray_of(int2 p) {
    float2 middle = float2(float(p.x) + 0.5, float(p.y) + 0.5) * side();
#if PYRAMID
    return (middle - CENTER) * CONSTANT[1].w; // its tangent
#else
    return (middle - CENTER) * float(MS_SSS_PERSPECTIVE) / FOCAL.x;
#endif
}

// The area of a surface over that of a surface that faces the ray, at the same depth: |(slope, 1 + slope . ray)|.
float area_of(float2 slope, float2 ray) {
    float towards = dot(slope, ray) + 1.0;
    return sqrt(dot(slope, slope) + towards * towards);
}

#if PASS || DOWN || UP || BASE || DISC
// Below 1e30, by its bits: compilers may assume that no number is NaN.
bool finite(float x) { return (bits_of(x) & 0x7fffffffu) < 0x7149f2cau; }

#if PACKED
// The last 4 bits of blue hold the profile. Those of 0 would be flushed, so 0 becomes 1e-30.
float pack(float blue, int profile) {
    return float_of(((bits_of(pick(blue, 1e-30, abs(blue) < 1e-30)) + 8u) & 0xfffffff0u) | uint(profile));
}
int profile_of(float4 c) { return int(bits_of(c.b) & 15u); }
#else
float pack(float blue, int profile) { return blue; }
int profile_of(float4 c) { return 0; }
#endif

// Light and depth of a pixel; alpha 0: masked.
float4 source(int2 p) {
#if RAW
    int2 at = p + origin();
    float3 c = ms_sss_fetch_color(at);
    float depth = ms_sss_fetch_depth(at);
    int profile = 0;
    bool valid = finite(c.r) && finite(c.g) && finite(c.b) && depth > 0.0 && finite(depth);
#if MS_SSS_STRENGTH
    float strength = ms_sss_fetch_strength(at);
    valid = valid && strength > 0.0 && (bits_of(strength) & 0x7fffffffu) <= 0x7f800000u;
#endif
#if MS_SSS_PROFILES > 0
    profile = ms_sss_fetch_profile(at);
#if PYRAMID
    valid = valid && profile == int(CONSTANT[0].w);
#else
    valid = valid && profile >= 0 && profile < MS_SSS_PROFILES;
#endif
#endif
    if (!valid) { return zero4; }
    return float4(c.rg, pack(c.b, profile), depth);
#else
    float4 c = fetch_input(p + origin());
    return pick(zero4, c, c.a > 0.0);
#endif
}

float4 texel(int2 p) {
    if (!inside(p)) { return zero4; }
    return source(p);
}

// Neither is masked, and both have one profile.
bool same(float4 a, float4 b) { return a.a > 0.0 && profile_of(a) == profile_of(b); }
#endif

#if SLOPES && !NORMALS
// The slope along a step of one pixel, from differences of depth to the pixels before and after. A difference above
// most is an edge. Where the slopes on both sides agree, their mean. Else the smaller one: near a silhouette depth
// falls as the root of the distance to it, a difference of one pixel underestimates the slope, and the ratio of the last
// two differences tells by how much, if it is more than rounding.
float slope_along(int2 p, int2 step, float4 own, float focal, float most) {
    float4 before = texel(p - step);
    float4 after = texel(p + step);
    float a = own.a - before.a;
    float b = after.a - own.a;
#if !PYRAMID
    bool on_a = same(before, own) && abs(a) < most;
    bool on_b = same(after, own) && abs(b) < most;
#endif
    a = focal * a / relative(before.a);
    b = focal * b / relative(after.a);
#if PYRAMID // there most is of slopes
    bool on_a = same(before, own) && abs(a) < most;
    bool on_b = same(after, own) && abs(b) < most;
#endif
    a = pick(pick(0.0, b, on_b), a, on_a);
    b = pick(a, b, on_b);
    float slope = 0.5 * (a + b);
    if ((on_a || on_b) && !(on_a && on_b && abs(a - b) < 0.5 * (a * b + 1.0))) {
        bool back = on_a && (!on_b || abs(a) < abs(b));
        if (abs(a) < abs(b)) { slope = a; }
        if (abs(b) < abs(a)) { slope = b; }
        float next = pick(after.a, before.a, back);
        float4 beyond = texel(p + step * pick(2, -2, back));
        float outer_step = (own.a - next) * relative(beyond.a);
        float inner_step = (next - beyond.a) * relative(own.a);
#if PYRAMID
        float rounding = 2.0 * CONSTANT[5].z * own.a * relative(own.a);
#else
        float rounding = 4.7683716e-7 * own.a * relative(own.a);
#endif
        float more = min(abs(outer_step) - abs(inner_step), abs(inner_step)) - rounding;
        if (same(beyond, own) && outer_step * inner_step > 0.0 && more > 0.0) {
            more = min(more / abs(inner_step), 0.85);
            slope = slope + slope * more * (0.5 + more * (0.5 + 0.7 * more * more));
        }
    }
    return clamp(slope, -8.0, 8.0);
}
#endif

#if SLOPES
// Change of depth along x and y over the width of surface that a pixel shows.
float2 slopes_of(int2 p, float4 own, float2 focal, float most) {
#if NORMALS
    float3 normal = ms_sss_fetch_normal(p + origin());
    float least = max(abs(normal.x), abs(normal.y)) * 0.125;
    float facing = max(normal.z - dot(ray_of(p), normal.xy), least);
    bool valid = finite(normal.x) && finite(normal.y) && finite(normal.z);
    return pick(zero2, normal.xy / facing, facing > 0.0 && valid);
#else
    return float2(slope_along(p, int2(1, 0), own, focal.x, most), slope_along(p, int2(0, 1), own, focal.y, most));
#endif
}
#endif

#if PASS || DOWN || UP || DISC
float pixels_at(float depth) { return PIXELS_PER_MM / relative(depth); }
int profile_at(float4 own) { return HEAD + STRIDE * profile_of(own); }

#if DOWN || UP
// ---- half resolution -------------------------------------------------------------------------------------------------

// Weight of a pixel near another in depth: (1 - dz^2 / split^2)^4.
float nearness(float4 there, float4 own, int at) {
    float dz = (there.a - own.a) * DEPTH_SCALE(at);
    float f = max(1.0 - dz * dz / max(SPLIT(at), 1e-30), 0.0);
    return pick(0.0, f * f * f * f, same(there, own));
}
#endif

#if DOWN
float4 nearer(float4 a, float4 b) { return pick(a, b, b.a > 0.0 && (!(a.a > 0.0) || b.a < a.a)); }

// Four pixels to one: the mean of those that lie near the nearest of them.
float4 filter_pixel(int2 p) {
    float4 a = texel(2 * p);
    float4 b = texel(2 * p + int2(1, 0));
    float4 c = texel(2 * p + int2(0, 1));
    float4 d = texel(2 * p + int2(1, 1));
    float4 own = nearer(nearer(a, b), nearer(c, d));
    int at = profile_at(own);
    float4 f = float4(nearness(a, own, at), nearness(b, own, at), nearness(c, own, at), nearness(d, own, at));
    if (!(own.a > 0.0)) { return own; }
    float4 mean = (f.x * a + f.y * b + f.z * c + f.w * d) / (f.x + f.y + f.z + f.w);
    return float4(mean.rg, pack(mean.b, profile_of(own)), mean.a);
}
#endif

#if UP
// The weight of a pixel's own light in its result: DELTA, and of each term the product of what the taps along x and
// along y take from the pixel itself by linear interpolation.
float3 self_weight(float depth, int at) {
    float pixels = min(pixels_at(depth), max(PICTURE_SIZE.x, PICTURE_SIZE.y) / RADIUS_MM(at));
    float3 share = DELTA(at);
    for (int t = 0; t < MS_SSS_TERMS; t++) {
        int block = at + t * KERNELS * STRIDE;
        float3 across = zero3;
        float3 down = zero3;
        for (int k = 0; k < MS_SSS_TAPS; k++) {
            float4 tap = TAP(block, (k + 1) / 2);
            float away = pixels * abs(tap.w);
            across = across + tap.rgb * max(1.0 - away * ASPECT.x, 0.0);
            down = down + tap.rgb * max(1.0 - away * ASPECT.y, 0.0);
        }
        share = share + SCALE(block) * across * down;
    }
    return clamp(share, zero3, 0.999 * one3);
}

// out = s own + (1 - s) rest, s the self weight at full resolution. The rest is that of the four larger pixels around,
// each solved from after = s' before + (1 - s') rest with its own s', interpolated (3/4, 1/4) where depths are near.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = source(p);
    float3 light = ms_sss_fetch_color(pixel);
    if (!(own.a > 0.0)) { return float4(light, 1.0); }
    int at = profile_at(own);
    float3 share = self_weight(own.a, at);
    float3 rest = zero3;
    float weight = 0.0;
    for (int i = 0; i < 4; i++) {
        int2 q = int2((p.x + 1) / 2 - 1 + i % 2, (p.y + 1) / 2 - 1 + i / 2);
        if (!inside(q * 2)) { continue; }
        float4 there = fetch_half(q);
        float f = nearness(there, own, at) * pick(0.2, 0.8, q.x == p.x / 2) * pick(0.2, 0.8, q.y == p.y / 2);
        if (!(f > 0.0)) { continue; }
        float3 after = fetch_sum(q).rgb;
        float3 least = min(min(there.rgb, after), zero3);
        rest = rest + f * max(there.rgb + (after - there.rgb) / (one3 - self_weight(there.a, at)), least);
        weight = weight + f;
    }
    float strength = GAIN;
#if MS_SSS_STRENGTH
    strength = strength * min(ms_sss_fetch_strength(pixel), 1.0);
#endif
    bool wide = pixels_at(own.a) * RADIUS_MM(at) * max(ASPECT.x, ASPECT.y) > 0.5;
    if (wide && weight > 1e-6) { light = light + strength * (one3 - share) * (rest / weight - light); }
    return float4(light, 1.0);
}
#endif

#if PASS
// ---- X and Y ---------------------------------------------------------------------------------------------------------

#if SECOND
// The light before the filter; only the pass of the first term adds it.
float3 unfiltered(int2 p) {
    if (FIRST_TERM < 0.5) { return zero3; }
#if HALVED
    return fetch_half(p).rgb;
#else
    return ms_sss_fetch_color(p + origin());
#endif
}
#endif

// A weighted sum becomes a mean, of the same total weight. Where weights have both signs, what is missing is replaced by
// the pixel's own light, for a sum of weights near 0 is no divisor.
float normalize_sum(float sum, float weight, float lifted, float own, float total, bool mixed) {
    if (mixed) { return sum + own * (total - weight); }
    return pick(own, sum / lifted, lifted > 1e-30) * total;
}

// One pass: taps on the tangent plane along one axis of the picture. A tap at the distance s on the surface reads two
// texels, which count
//     f = share of linear interpolation * (1 - dz^2) / (1 + (1 - flat) h^2 / s^2)
// with h the height of the texel over the tangent plane in mm, dz the same in units in which weights vanish at 1. Light
// that enters below the plane, at an elevation theta, reaches the pixel by a factor (1 + K / 4 sin theta)^4; where the
// surface bends away from the plane there is more of it, by a factor 1 + (1 - flat) (dh/ds)^2 / 2. Near taps would see a
// mesh's triangles: they follow the sine of the next ones outwards, in proportion to s. The sum is divided by
// the larger of its weights and its factors' weights times the root of the reflectance: no mean exceeds 1 / reflectance
// after two passes.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
#if SECOND
    if (!(own.a > 0.0)) { return float4(unfiltered(p), 1.0); }
#else
    if (!(own.a > 0.0)) { return own; }
#endif
    int at = profile_at(own);
    float4 total = TOTAL(at);
    float2 aspect = ASPECT;

    // The effect fades from kernels of a pixel to those of half a pixel; one wider than the picture is reduced to it.
    float pixels = pixels_at(own.a) / side();
    float radius = pixels * total.w * max(aspect.x, aspect.y);
    bool wide = radius > 0.5;
    pixels = min(pixels, max(PICTURE_SIZE.x, PICTURE_SIZE.y) / (total.w * side()));
    float2 axis = pick(float2(1.0, 0.0), float2(0.0, 1.0), SECOND);
#if MS_SSS_ROTATED
    // One of 64 angles a pixel, of a linear congruence in which neighbors differ widely.
    float turn = float(((uint(p.x) * 49472u + uint(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    float angle = ROTATION + JITTER * turn * (1.57079632679 / 64.0);
    axis = axis.x * float2(cos(angle), sin(angle)) + axis.y * float2(-sin(angle), cos(angle));
#endif
#if SLOPES
    // A mm along the tangent plane has the picture of 1 / |(axis + slope ray, slope)| mm that face the camera.
    float2 ray = ray_of(p);
    float2 focal = FOCAL / side();
    float2 slopes = SLOPE_SCALE * slopes_of(p, own, focal, sqrt(REACH(at)) / DEPTH_SCALE(at));
    float slope = dot(axis, slopes);
    pixels = pixels / sqrt(slope * (slope * (dot(ray, ray) + 1.0) + 2.0 * dot(axis, ray)) + 1.0);
    // The plane's depth a column and a row; in perspective relative to the depth of the texel that is compared with it.
    float2 plane = slopes / focal;
    float mm = FOCAL.x / (PIXELS_PER_MM * DEPTH_SCALE(at)); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = -1.0 / max(1.0, max(elevation.r, max(elevation.g, elevation.b)));
#endif
    axis = axis * aspect * pixels;

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight; // the weight with the factors of elevation
    for (int side = pick(2, 0, wide); side < 2; side++) {
        // Each tap is added once the next one inwards is known.
        float4 outer = zero4; // its light and weight
        float outer_sine = 0.0; // times the weight
        float outer_lower = 0.0; // mm below the plane
        for (int k = MS_SSS_TAPS / 2; k >= 0; k--) {
            float offset = abs(TAP(at, k).w);
            float2 along = axis * pick(offset, -offset, side == 1);
            float2 whole = floor(along);
            float2 part = along - whole;
            float4 sum = zero4;
#if SLOPES
            float below = 0.0;
            float elongation = min(SLOPE_SCALE * mm * mm / max(offset * offset, 1e-30), 1e6);
#endif
            for (int i = pick(2 + 2 * MS_SSS_ROTATED, 0, k > 0); i < 2 + 2 * MS_SSS_ROTATED; i++) {
                int2 corner = pick(pick(int2(i, 0), int2(0, i), SECOND), int2(i % 2, i / 2), MS_SSS_ROTATED > 0);
                float2 away = abs(float2(1.0 - float(corner.x), 1.0 - float(corner.y)) - part);
                float share = away.x * away.y;
                if (!(share > 0.0)) { continue; }
                int2 beside = int2(int(whole.x), int(whole.y)) + corner;
                float4 there = texel(p + beside);
                float dz = there.a - own.a;
#if SLOPES
                dz = dz - dot(plane, float2(float(beside.x), float(beside.y))) * relative(there.a);
#endif
                dz = dz * DEPTH_SCALE(at);
                if (!(same(there, own) && dz * dz < 1.0)) { continue; }
                float f = share * (1.0 - dz * dz);
#if SLOPES
                f = f / (elongation * dz * dz + 1.0);
                below = below + f * dz;
#else
                f = f * (1.0 - dz * dz) * (1.0 - dz * dz) * (1.0 - dz * dz);
#endif
                sum = sum + float4(there.rgb * f, f);
            }
            float4 tap = TAP(at, min(k + 1, MS_SSS_TAPS / 2)); // the one before
#if SLOPES
            // The sine of the elevation, without what may be rounding of depths; near by that of the tap before, as far
            // as it was found.
            float rounding = own.a * DEPTH_SCALE(at) * 2.3841858e-7 * (2.0 + abs(along.x) + abs(along.y));
            below = facing * (below - clamp(below, -rounding, rounding));
            float sine = below / max(offset, 1e-20);
            float gap = abs(tap.w) - offset;
            if (gap > 0.0) {
                float follow = offset * offset / (0.0289 * total.w * total.w); // 0.17 radii
                follow = outer.a * outer.a * outer.a * outer.a / (1.0 + follow * follow);
                sine = sine + follow * (outer_sine * sum.a * offset / abs(tap.w) - sine);
            }
            // The area of the tap before: by the slope from this one to it.
            float lower = below / (sum.a + 0.001);
            float bend = 0.0;
            if (gap > 1e-20 && MIXED(at) < 0.5) { bend = (outer_lower - lower) / gap; }
            outer = outer * min(0.5 * SLOPE_SCALE * bend * bend + 1.0, 3.0);
#endif
            weight = weight + tap.rgb * outer.a;
#if SLOPES
            float3 lift = one3 + elevation * clamp(outer_sine, least_sine, 1.0);
            tap = float4(tap.rgb * lift * lift * lift * lift, tap.w);
            outer_sine = sine;
            outer_lower = lower;
#endif
            lifted = lifted + tap.rgb * outer.a;
            result = result + tap.rgb * outer.rgb;
            outer = sum;
        }
    }

    int mixed = int(MIXED(at));
#if SLOPES
    lifted = max(weight, lifted * ROOT(at));
#endif
    result = float3(normalize_sum(result.r, weight.r, lifted.r, own.r, total.r, (mixed & 1) != 0),
        normalize_sum(result.g, weight.g, lifted.g, own.g, total.g, (mixed & 2) != 0),
        normalize_sum(result.b, weight.b, lifted.b, own.b, total.b, (mixed & 4) != 0));
#if SECOND
    float strength = pick(0.0, pick(GAIN * min(2.0 * radius - 1.0, 1.0), 1.0, HALVED), wide);
#if MS_SSS_STRENGTH && !HALVED
    strength = strength * min(ms_sss_fetch_strength(pixel), 1.0);
#endif
    float3 delta = DELTA(at);
    result = strength * SCALE(at) * result;
    if (strength < 1.0 || dot(abs(delta), one3) > 0.0) {
        result = result + (strength * delta + (1.0 - strength) * one3) * unfiltered(p);
    }
    return float4(result, 1.0);
#else
    return float4(result.rg, pack(result.b, profile_of(own)), own.a);
#endif
}
#endif

#if defined(MS_SSS_HLSL)
#define MS_SSS_MAIN float4 main(float4 position : SV_Position) : SV_Target0 { return filter_pixel(int2(position.xy)); }
#elif defined(MS_SSS_WGSL)
#define MS_SSS_MAIN
#else
#define MS_SSS_MAIN layout(location = 0) out vec4 ms_sss_out; void main() { ms_sss_out = filter_pixel(ivec2(gl_FragCoord.xy)); }
#endif
#if !DISC
MS_SSS_MAIN
#endif
#endif
#endif

#if MS_SSS_STEP == 8
// ---- light through thin parts ----------------------------------------------------------------------------------------

// What part of diffuse light that enters a slab on one side leaves it on the other, parallel: the cosine between
// the two sides.
float ms_sss_through(float reflectance, float decay, float thickness, float parallel) {
    float dark = max(1.0 - reflectance, 1e-4);
    float R = 1.0 - dark;
    float y = decay * max(thickness, 0.0);
    float x = exp(-y);
    float gone = 1.0 - x;
    if (y < 0.02) { gone = y * (1.0 - 0.5 * y * (1.0 - y / 3.0)); } // the difference would lose digits
    float slab = 1.0 - 0.85 * dark * dark * dark * dark * dark * (1.0 - exp(-0.8 * y));
    slab = slab * dark * (1.0 + R) * x / ((dark + R * gone) * (1.0 + R * x));
    if (!(reflectance > 0.0)) { return 0.0; }
    return slab * (1.0 + dark / R * max(parallel, 0.0));
}

// ms_sss_transmission of ms_sss.h, with reflectance and decay of the kernel: light of a lamp behind the pixel's surface.
// Unit vectors; entry_normal: where the light enters, as a shadow map with normals holds it. Before the albedo.
float3 ms_sss_transmission(float3 reflectance, float3 decay, float thickness_mm, float3 normal, float3 entry_normal, float3 to_light, float3 light) {
    float entry = dot(entry_normal, to_light);
    float parallel = -dot(normal, entry_normal);
    if (!(dot(normal, to_light) < 0.0 && entry > 0.0)) { return zero3; }
    return entry * light * float3(ms_sss_through(reflectance.r, decay.r, thickness_mm, parallel),
        ms_sss_through(reflectance.g, decay.g, thickness_mm, parallel),
        ms_sss_through(reflectance.b, decay.b, thickness_mm, parallel));
}
#endif
`;
// Separable subsurface scattering for Babylon.js, by ms_sss.h, in place of the engine's own pass: its prepass draws light, depth and
// color of materials that scatter; two passes of ms_sss.glsl then do what subSurfaceScattering.fragment.fx does, and write where it does.
// `make web` writes this file with examples/engine/shader/ms_sss.glsl (SHADER) and the header in WebAssembly (BINARY).
//
//   <script src="babylon.js"></script> <script src="sss_babylon.js"></script>        or import 'sss_babylon.js' beside @babylonjs/core
//   const sss = await BabylonSubsurface.create(BABYLON, scene, [
//     { reflectance: [0.44, 0.22, 0.13], path: [1.8, 1.2, 0.73] },    a material's diffuse reflectance and mean free
//     { reflectance: [0.83, 0.79, 0.75], path: [0.41, 0.66, 1.03] }], path in mm, red, green, blue; at most 5, as Babylon has
//     { mmPerUnit: 40, radius: 60 });                               the widest kernel on the screen, in pixels
//   sss.apply(head.material, 0);                    a PBRMaterial, and which of them it is
//   sss.enabled = false;                            Babylon's own pass, with the same profiles
//
// Lights, shadows, specular light, image processing and post-processes are Babylon's. WebGL 2.
globalThis.BabylonSubsurface = class BabylonSubsurface {
  // options: mmPerUnit (1000: meters), radius (pixels that the taps are made for), taps (odd, 3 to 63; 7 serve up to some 20 pixels, or 0: as
  // few as show no bands at that radius, by the table of ms_sss_shader_constants)
  static async create(BABYLON, scene, materials, { mmPerUnit = 1000, radius = 40, taps = 0 } = {}) {
    if (!BABYLON || !scene.getEngine()._gl || scene.getEngine().webGLVersion < 2) throw new Error('BabylonSubsurface: wants Babylon.js with WebGL 2');
    if (!materials.length || materials.length > 5) throw new Error('BabylonSubsurface: wants one to five materials');
    return new BabylonSubsurface(BABYLON, scene, await BabylonSubsurface.core(), materials, mmPerUnit, taps || BabylonSubsurface.tapsOf(radius), radius);
  }

  static tapsOf(radius) { return 2 * [1, 4, 8, 12, 16, 23, 29, 47, 65, 90, 115, 150].findIndex(most => Math.min(radius, 150) <= most) + 3; }

  // The header in WebAssembly: kernels and constants (examples/web/three.c).
  static async core() {
    const packed = Uint8Array.from(atob(BINARY), c => c.charCodeAt(0));
    const binary = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    const nothing = new Proxy({}, { get: () => () => 52 }); // the header asks for no file
    const { instance } = await WebAssembly.instantiate(binary, { wasi_snapshot_preview1: nothing });
    const wasm = instance.exports;
    wasm._initialize();
    return {
      wasm,
      numbers: (count = 16) => new Float64Array(wasm.memory.buffer, wasm.numbers(), count),
      check: status => {
        if (!status) return;
        const bytes = new Uint8Array(wasm.memory.buffer, wasm.message());
        throw new Error('BabylonSubsurface: ' + new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0))));
      },
      constants(taps, materials, width, height, fov, mmPerUnit) { // of both passes
        const n = wasm.fill(taps, materials, width, height, fov, mmPerUnit, 0, 0);
        if (!n) this.check(1);
        return new Float32Array(wasm.memory.buffer, wasm.constants(), 4 * n).slice();
      },
    };
  }

  // The text of a pass, 0 or 1, for textures as Babylon's prepass leaves them: light with the profile's index in alpha, 255 where there is
  // none, and the depth of the view. The second one adds the result, times the albedo, to what does not scatter.
  static text(pass, taps, materials) {
    return `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
#define MS_SSS_STEP ${pass}
#define MS_SSS_TAPS ${taps}
#define MS_SSS_PROFILES ${materials}
#define ms_sss_input textureSampler
uniform sampler2D irradianceSampler, depthSampler, albedoSampler, colorSampler;
int index_of(ivec2 p) { return int(round(texelFetch(irradianceSampler, p, 0).a * 255.0)); }
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(irradianceSampler, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depthSampler, p, 0).r; }
int ms_sss_fetch_profile(ivec2 p) { return index_of(p); }
${pass ? '#define main scatter' : ''}
${SHADER}
${pass ? `#undef main
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(colorSampler, p, 0);
  scatter();
  ms_sss_out = index_of(p) < ${materials} ? vec4(color.rgb + texelFetch(albedoSampler, p, 0).rgb * ms_sss_out.rgb, 1.0) : color;
}` : ''}`;
  }

  constructor(BABYLON, scene, core, materials, mmPerUnit, taps, radius) {
    Object.assign(this, { BABYLON, scene, core, mmPerUnit, taps, radius, count: materials.length, ours: true });
    this.materials = materials.map(({ reflectance, path }, i) => {
      core.numbers().set([...reflectance, ...path]);
      core.check(core.wasm.material(i, taps, radius));
      const n = Array.from(core.numbers());
      return { radiusMm: n[0], reflectance: n.slice(1, 4), d: n.slice(7, 10) };
    });
    const config = this.config = scene.enableSubSurfaceForPrePass();
    if (!config) throw new Error('BabylonSubsurface: this engine has no prepass');
    config.metersPerUnit = mmPerUnit / 1000;
    config.clearAllDiffusionProfiles();
    for (const { d } of this.materials) { // Burley's profile of the same distances: S = 1 / d, and the widest one is sampled
      const widest = Math.max(...d);
      config.ssDiffusionS.push(...d.map(v => 1 / v));
      config.ssDiffusionD.push(widest);
      config.ssFilterRadii.push(config._sampleBurleyDiffusionProfile(0.997, widest));
      config.ssDiffusionProfileColors.push(new BABYLON.Color3(...d.map(v => 1 / v)));
    }
    this.passes = [0, 1].map(pass => this.pass(pass));
    const self = this;
    this.passes.forEach((postProcess, pass) => scene.prePassRenderer.addEffectConfiguration({
      name: 'ms_sss' + pass, texturesRequired: config.texturesRequired, needsImageProcessing: true, postProcess,
      get enabled() { return self.ours && config.enabled; }, set enabled(yes) { /* follows Babylon's own */ },
    }));
    this.enabled = true;
  }

  pass(pass) {
    const { BABYLON, scene } = this, name = `ms_sss${pass}_${this.taps}_${this.count}`;
    BABYLON.Effect.ShadersStore[name + 'FragmentShader'] = BabylonSubsurface.text(pass, this.taps, this.count);
    const p = new BABYLON.PostProcess(name, name, ['ms_sss'], ['irradianceSampler', 'depthSampler', 'albedoSampler', 'colorSampler'], 1, null,
      BABYLON.Texture.NEAREST_SAMPLINGMODE, scene.getEngine(), false, null, BABYLON.Constants.TEXTURETYPE_FLOAT);
    p.autoClear = false;
    p.onApplyObservable.add(effect => {
      const renderer = scene.prePassRenderer, { textures } = renderer.getRenderTarget(), of = type => textures[renderer.getIndex(type)];
      const { width, height } = of(0).getSize();
      effect.setTexture('irradianceSampler', of(0));
      effect.setTexture('depthSampler', of(5));
      if (pass) {
        effect.setTexture('albedoSampler', of(7));
        effect.setTexture('colorSampler', of(4));
      }
      effect.setArray4('ms_sss', this.core.constants(this.taps, this.count, width, height, scene.activeCamera.fov * 180 / Math.PI, this.mmPerUnit));
    });
    return p;
  }

  get enabled() { return this.ours; }
  set enabled(yes) { // one of two post-processes: Babylon's, or these
    const { config } = this;
    this.ours = yes;
    if (yes) {
      this.theirs = config.postProcess || this.theirs;
      config.postProcess = null;
      config.createPostProcess = () => null;
    } else {
      delete config.createPostProcess;
      config.postProcess = this.theirs || config.createPostProcess();
    }
    this.scene.prePassRenderer.markAsDirty();
  }

  apply(material, index) {
    if (!this.materials[index] || material.getClassName() !== 'PBRMaterial') throw new Error(`BabylonSubsurface: wants a PBRMaterial and an index below ${this.count}`);
    material.subSurface.isScatteringEnabled = true;
    material.subSurface.scatteringDiffusionProfile = this.config.ssDiffusionProfileColors[index];
  }

  dispose() {
    this.enabled = false;
    for (const p of this.passes) p.dispose();
  }
};
const BINARY = 'H4sIAAAAAAACA+X9B3gV1RM4DJ/dvb0kNw0Coey9gISm2GhGNotUGxawKyCEkoQWQlGRhCJSJRQVsHBzg4odFQUleEMVAZGmoqJGRKmSgKBYMN/MnLN79wb05/t/3+99vuf5ULh79pw9Zc6cOTNzZuawAWOGS4wx6XW5RX+5qEgq6q8UFRWx/jb4t0ia2J8xegHv7UVF/IGymEgz/Ir1lzDDVST+wLMz9ugwn6QirG0ifTSRVznRbBMasxVRpjJx4kSeEg1PjNU5Ma5ORg8Tje5MpEomUoaTl8XCjLcwUfR9otHVidhOUX+ZWpPwH3ki9WYiVYR9nIgjmwhvJk3C50lUHN4o48cpis1uszGH0+lyM5vH63M4vF6738W8fikhMcGVEEhiyf5kKcXvcEjOVGZLq1M3HdK+evUdSRlJUh1bgwYNGjZq1FhOlWWXJMlut9/vVlXFZguq9lCTYLBp02bNgpfAf2qzYFBtfklmsEnQZpdGSXa7XZFYgsMFndMrtlztdd7mcgzPGT6y4CGZefsNGzGscNiA/GEP5zDJOWLs8AdzCsawLu6BI0eMKRwwonAMu845PGfMmAFDclhX1/ABhTkFUJp1sxcMGzFkDOthGzwsP5/1dHskpkte2429brjF89Yy2zio2sUCxfCHefMkuagJPeqBvJDSlD+yoE3OViW9KFdl8E+BXlxs6+VnqoIP7WSXqqhSO9kGP6ydDJUHbaqsSzrTj86Gz1UlMBWrqe+FDwK5vE7V5n3eZ3MDyKVJDqPJCpYXtENLrBtUboeyeuPcoENlqoy1M2wE3qvQpA864soNOqFUh1zdnht08SdnbtAN3fUo2fJF/1OVNoyFbHqz7tCCrZvfBoW98FeGvz6fhD2UcoN+LCaFZP0Q6+GXoEV7puyDpC0XW/ZDFTjCTBm+gSLwsRT0qv6g4oVOsE4sCfvYiQWgPqw29lKGlwCZX1h3v4zlsXEvdErW/2DdxZAJdoehXYdoF8akTxgNrbuwdSzdSmGhhHWhxC7F/M+5GjbV8nwb1XRiCUL0yTkI68QuRX0z9MNL+HMN/+OcektGSM5kMGUB7BuMDgbWiaX6HNjtALSE31FlbaDjMMiAV4exqAlL1QQ1oSsTfwZmhGKJQSE5I5gkcoumXaoP9is+m7c2DAkkl3EYyqojaFOyVRugVghGD13xjAgFdE9+nt62oBOD6dfdNwST1QAUTfYz6J8XkMGTCxDBapjPeUH9VLENGoZ6k3BKk8wON80uC1m7x2gKLCNA5EvoeiX8qRl2LnsgJKmSovhKIqG4TyTrJ1in7tAlFWCRwseqEfYZn1RqYfPzan2gpfXBo6n5V4Myxx7Zq7rUlFwYvTvoh374EUh+A0ipFiAlhxCAUJCglaamArTSoCdyNi4GNUWXb/bj2kz2QZ0pWDRFtSEqywR5wru2gIWYCQBL9sKYGfy15ereXhmhNL3xWDVtNExQcs9gqpKttw3KMk4a6wkdTtUl6rhfJSzCbiMyq/C/jJ0LYJWpUBp+ZAKFTU3rAR/AjN4sMF9NzdUv5YXl3CCuHhhDwItFoEXoHXVZxo7CG/wWHlPUtJ40SKgyTU3CKgMwRMlsH1DiR8aRSMrV2+itcFg9M8x2kuHDJHjXeGxIhs6OgfLu640eJefqbXlJhSDCp9KYCgJ4bDKSxGSEAibOpqpJAN5U6CCUFzWqlJ1MMOYTEOBwsakBRByzZey1V9AERFEvp4q0cHyqz+zx/+UFRAjv04twmB79pHQD/BrrqQ0W92B3PEAMg34sip0MBbpZSov+eoIyNOtU5Vxd0zU1AHCqkUaHPHoN654BhdVeGQbkgx6zGsn4XIbaekG3PEa3ALshQ/Hho+Rd57DZiqRHpYnm/lDJYnuShHsSTTuDtR6y638/mqvXPNqLYCSN9hMtnyzz3cnOdyfaP6A3sJVtecq6MwG+8IpsIYf+UK7+0A20uznayenwGfyk8q8Dxt4GNTzNa4DpiVWispbyiiVSyLk26KK+Oa/DRf0Aws617h/o9a1+3GHd+hwX7lswE25dLsTJaCmztaF/+QzXnxvnrqXsonbu8yte2tD2LZZg3/EQmgIdhHcJfEeEZeenev+lM1DG97/L6M8ukf611G00BWpCO/lG+HG3k3vCj7ed3JWDMtsCyv1zOCgrmAlLhxeasCGWJABOhBJ0pQeSJp/uy4WR+fU56bhNezHPqzooz4N5HoAevHOrdnrH9PIliGtWCECnZ1/Hmhb26teNBpKeG3tj9vku/tOHd/YWS2enLeGd3RXrrO3inQWGRZUDj2EZ2ItkrNnVUcnkVaqWKleK8atWVKLCHTjoruLftLV8M3cu/6ZtroW7qmQx9mqBLHn/kZcTa0ZGMopoj1wWMVTQgovWtAuREABDjwhRkZ5zb9ADFcDu1pPwFoYZ9MF2wIgEeWDL8MEeEPLriwmBYaqW08O9GUgCAEpANX1iLnESfXGTiMvQg2sPR40r1xVbubqNBm+DwU+eF7d6ZZxoqIthr3NDwAvinoBdqsVy/uBwSkhSiuRHkf+XHhXwqZbyQrIoJeN68oWUDvIhiSfSO8hHxKPaQT4hGbQHXwAU+dJTFf6bS8sx5BCpEEC0O+1zTpg/6DqyxR8sooZic8fpD6/pXqRgQD+wHlvQbb7/n0REdVO5/ljO/e/LUkbcwk6513ZUXIRVvGc/zaCexXXLYXTLfKau4ONV193Pq3NAPaqlnvVL+AjjMBr4adiCbYhlhC3IjptDVohkihf/PtbYENJVZF7OYGO5gNEGgeZ9WDqH9yFGoGXazXQXTogTsBSmL6iIpQsdxB6eY7m8pZLSp9ez9ggkvdryTuevFksXFiuRLii2xngF/db4q5XwSnxwhBGyBNbSXOgrpFxci5mreXIGJvVUorH8zfc4Oe1IXvjgaXrsr8rW+u+CJNR9CxR4kRcoBrzVv+bfhfF5+1x6rhD43BSq7gmvd8V6tf/CPm/lPWuwhvcDyLRuV6XAXE7ZEGzVUmyRlcg2XGLSo/JEIIEKF91k3HoZVvwXTEYFVKwifcSlYuNTHrLjiqd36SHHWoM71gycywg5OyoBWnf2bsSxKKtxFtd27fjcbZHu383XIiZ3HQmcxc4AJXCFI2WAJxyTJVzYFhQWVTjWGmV48yyE6JyOjzajd7y4TXU82UFuiuXktzFDW4SlAgs6yJkwWa1zVcV8zacOcpj3J6cb+RiZyI4yUSqyAemBEk0JAwGUrZR0oMASEmIn/jBY/jKxEkE3NqAC7QRiq69oEfiKgA6sGIg88PeBDPjepTqvD3otUq4Nu6vAjHWjpdJSXgNMiWetqHNtCHgDAdSg3/c/S6gKIEoI08UarndTWAnCdhdM9JlvYLI8a0vhLQsmepGIBYDAgNQE/VO9GTA0H1alhuxrQVBI6Lp81LWeL8oqYN7WNHrs+K1rPtTCEYPYhVwZXddkTzn40WIXiFrJarLqG5QB/yaCRCUGmYg0AtlJpiNaAaLtz+RbQSxJU5pMraW+0eP7h1NPQ2v08MYX0Foopey9DlAOZB01EAFW1LkahsvUFHi7LxOxoZUSCAVUKBZK7SDvyrwIdNl1/UbNbEu9xqlzZfCSXhMZ1eSyIHYhqQxAwTv3SDt5UQv+vBw6eg6bSngv5O4gn8HHFJCvUyIR6MRiKAVQSykLpcAbeFGdCcBViE1UcCv9KxNEAHx06vs4Q4bT1HmR6l4UsgPuAXWb0SJXdeqv8dyQZz7vqjG9UAZXFBKDRS0W4cfR+wnZ6VG1A74vaoHbKOzciti5+UBDsKYrMlUHQi6FaiPljQxfx/ABIBe04xfQmUOZANigBwdgbKF8IMBahGgIB2A0Eo5G0TOxtzgAp34kE/KIPUKGwsMHhi3RlpQaW6BOGEfqk7jioH4k7NJovteoTkAT2Q/7lJoEwroCYpnDp1ykFEoeDjV1bSTowE4nAcS34ow44GETPiR3DW84/vcNPVd1tDwOyoDsHZneU4odqB7JLLC+Zb64cd0WS3zdhhyIN5khJ+ooaMFXZIYYUkgHcgh6+CTLzyUVBuMAdRnoRh82CNm6tRO8PlAIm58mSaP1uTDooiXnhqKuDrKK1bfEPsvEpCzqADIMqpTg5dZMSBF5O5IJHXRcd/eXsJMTVrAMfH0uE8jWBCK8ULv9SQR4A17hgcwOcmvg/trCROmV5iQ5xLqFCjrIV3FNG6302OTY18YWtOqGBWUPemB9xkYQsi+8znXtNdqiGPbY15ZejEqo7kjtuhagvOpQPUiIHYhsTVUXXwlBEJmDEiAa9B8Rq0MuarvwmembDtCiWIRDUPRNLJf3hum7eEbI9SR/44qtFhg3LAWJLwXvYcWuwIS7gajLE1FfAwX76/BPGBWm7PqQknFdz++XZsObrgCTDNxHfSFbBtDAoMMcKHDNUt5qQHJnOHAEEaVUZMGwg64YPCS9aMzFisGOF3THyLIn9mgh1r7Yo18QEU+sall3jl4tkgkVYWwkAi+VcbVfhkMJqqOslBdwxiqwZUTMBsz3qBBMhJ07DBuYU3WrCfi1qzQUiISSVF8YuH+nmrAsonrDQU6DVX8YNxw1MReWJioOQshvGFQHVZXEUtyFYjIsukIij36k4qPgEYQKfMxXLRTIg2+GqmKp2OcDfRikktA8wdyqsZm3YRkUX7VoAbxU9UWY3wA1eIVvL4IvJnonS5JchJiEfL/OAnMQ/iABLZWCEk5qADrq7E4UCWQUlI066E54dHTPSERCI1EGCoZY2gUIhFKcdH1GEPcQ1DygXCfjG1XKJwFNl4frjtx8ZE8lVIgcsUuKIdHtkk2JhYsipNtTBOv7/mIS9ayKCeghQXQrMLOzfnz89+0fzf31I8HyAUNn4Ulrc3+VsVzgSbscWzLlk4XbP120Rbwrtrzrzl91IL62tWBb93M2VxXJczzZVCSnc+a0bYyTfaICas7krKyKm9saYvT1zbOoJGrQP+dcLDK62/jbUfD4IX8skTgzXXsc4RiPu9WSW2EAwcKYXyS7MpY9QzazFxvZxbKZvViiAWaKAa7hzHO6YOv3E1vfAMUV8eYcL2ATyU2cc1+Jo1jJn3fhcxkHVDU+L+bPJajqC8daXhHr2ByjY1vNd9PWmEOVc2l95HzyyfrYQlF05XqgTLwXi2XqlEt0ag1PGl1+gre/UibxSvcYwkBIQY0K6QUUrmNgqIsjobodkU7Ezn3zrEImoi2KELtkQ4RQvO9JsgyMssB19YKTKK6TR5m/lUJcBy1KF6ZCqMkI0JNzMN857Tl+vgKQb1bgI9WOw0DNgOqkJ9UBYvCFx1e/X0TNoKKaAY/CQhJxC8iWmKLPZKfihH1ANvUKLfJCLmOVwrbj5GQj5PYL/kVHBt9JjX31dO01CxxBYLpRHnoHDEpgiuV7R9z3O2t/jy3CqidihJooqgG2e6hlHgkRbqH2jKvm2AXdsCNxcgNxchO58hhKH/hF/SKQX6hxmugXkjkfTrwbv2OhhBuRS0dVGshiqNSxwY+fg5maVP367CcRei4LmH1mb52BEqNm1QeUkFftha3EC31BJVIlKvhAXCHlccjfwzgNkPjJBBDO63H6Xah7TIUfocY1xlv8NDUep8aFkYFUCJuyPTCb5tFWKOQuN5SsaJHLuxd4nKbdjfQTNi1XK2V/i1Ai/u5qEQkGjDNIPgtE+Z347Arh0ZCDKL0nvzcMzKl6RgBDCgOXQAyEVC8/HWAQlcBDTpQAk5CTawqSBFSRHpShWUTkFnLT9jL2AWiu/DayJ9DFFsqRFu2BpLpBIuXbXvJCygKJUw28R4/E0PBMKQP5RTcIrHx0XC4NJYvaWsqVLToA2XXz0klQlQ/eJ0I9MKOqDVq1wa/CW9ezYFGJR+DmA2ryWpRbSMWNI3RhtzkQER6eUTiB+bkgcMKaC8wgiCJvTOX8hER8H1SdsBMW5gbmUxEnnhQ46aTABcvMWIJu7/tep4NUfP5HpUkO+CuWYslmKS/kNA8PYLXDZMqoyyRFlEeX8TjErSt4HOUKerGvqEqGxqGgRzx5dF/QyxWiLsEBqrZMuS1y45lyKvIz+rmWyBt3CHxJ6AQvtuILRBmOMLKph24qtPYME5mcxfQzrnfwG5yzRCoJ1X8v4IRuAz7KodsAb5+adeFyd9FKxhKI2X9csJJtmVyjyFmYnjResaxVdgPinNMggcSuGZkkoFCdW2ipOq2t0lkSVeZTvT15JbTUQNznS83oUBX/uPZSg6b0Na1yocD+JUJOAqh1mQwPgfbKylaogYb+HjiAaJJAAsf+TcjQO/WVrXJVD+qm57hyDakfB7UP9uBY2oMMu0fIrk7j/bOtUOCScsUE8cpo9gw8hL7BatRRdYadgGlo2oF/puaKbxPML2YKtIQsX2AWJvhycbaUq5EqODNRh4LaFHhzlZrIcz0ZTwbFI6CAujAI/O3bsNSVt/Eg9+1gCpbuEEzlh0kgOoLIt+10r9HBNJxPyMtS/U8G07zUsJ6pN8U5Duj27hmkWqoD74F9w8e6vMhWnkrnqR08VQ+/SseJaCn3CdbHn+xghupsodwVbICpGVKwIf4OCjbCnzlSsDH+lkhBFX+flYJB/F0sBUPwlXxjsAlaIACjZ+M0jOiBnRSeHv6sNmkv94dXB+CVjw5NAHngCfgMb89cUR45xxB/3MeQGgQX8Y/VDsD72bH7amOeD+NS6/FHEOPUdF6uUQckv0iSGvI8oJJ1eVYDJJB2JJAx8Qzw+PoMXjAT5lRNKBQdAbLJ36t1kFQiZVbr8yygUmn8CchnKi+U2IFMKpKQUNrVANJJu5qMZNKupvDC1QwFHJ/uuZ70dwK98TwVSYPYdlw3Eyvl4WdHDiR/IQmYPeKkXIDT9IxDxLNZVMMDN5gPWKmn5+OqSOdKcdz93bDqWshYnJYcboCkfSF0caKVi0cvceSrRNgWO3JDXt6OC97CK5GINQHLKR8XlU3UqvLzN94erXk36lVcOu2ZZBDBOCHIhe3vck45nUiVDdLt8R6T7ag2Vkh1HDMJCjlECX64SltzII6iclbTRaQam+HUtXXIG9M+4IYNf4FngCG0AvHCuTYS9HGdsCtWDEjY2rKgD3iv1SE/nrKr/kEZIV9MzMbTLZDgM4DSwwAL0SYBp0gWh4uwpZCa7HpuHbUUDybwiF/hJ3pKPud10QoC5lxGXtKnKqsH8eMqD2Z1J56VIcPkoOMvTmKXGH3QB1JHX+EWIgiZCWhu4SAVO20QdtogDtMBocM8HXQgmxKDtSJ7AM4oVOv8CDBkA04pI4SWQCWoVNSfzcwNLCg2DzuBFtr1OekgmuYiuYVpQDwGLMCjKmLLdKkn5w4BrxTVi1o9Xy5WqPrwQLDE0BaJg2jpRsPMwgUFiGYLbRLDtDhfDiYYxhxIiIVaLAHfAKVN4IupLdAG1ISKz+04Ungzo4XZIB4qki2WA5abk/hWu+o3ywdy4bVfpzNlpEHAjbh7cmUgSt+4C+CxlTiqFMe7ikBIXOUKUgTgz3ZlclVSa0rtzwSyliC0S1kI03AmLhFAHLRQepbAvJy/kgs51VOIqsHH1Zm85246aYX3QCpJnQiwR/2N7+JjcF0wBu902W7H005STMJ8WyYRD8btNF12nC4HKmERzDHDCuB1bjYVuowLDXqciglYQNKv0cmJdy2tKr7ySJEMnBqd/dCpBjLuvjAeauBhvUR8Vcijunrys18criGQRsNLup4a+sOMd88d6owoT7skSh6qw0QOcXoICOJ+L+ilg0jYP7jam87j7Vi/nU+Y96jN5gbpTIpJlgGTJbQoUQxe5+CFShTdkGJRgUhMoEoKZNWWAVKJI7CIZBUbjRpQGAkvCFyBJ2OvUfvnARkAzy91pdBgElGgDCLDqRSSvtKH1fdEPIVu+Un68/EJIsM2IPYO4kBJHkrAsyMyxXGoNhB8UaSFoefSSFyIvmg7FZIRabEubD+U2EpxAbeRiAJ0EnHbWFUyVyVInAwlqUkRYEECqOFPJQ25l6wDEvCEX+byNjdHTCtVE/ElUuaQG9/gR2qKRUFZFkoio0JSZ6dBlybg56VqKnSSHukT6wdo/JUMtZKhGSoHTZzLIYqepqaF4fOU0rIQPC4NpWAhNRCO4G+4DOtTUwZmwL9pg1Ct4SVw4IBBmOHjxkHwIdsQUjY+5FQ+5BQAC8CNdi/OpPjE0vcEnuL7juppR6KNzUt8rakIKLfLsI1NtNgtWfGMC/4u+GQ/cfF78V8CegbiF0e/hYsvxmoj9HS+5lyEHC6YNpIs3ZzZdonPTy+uzWzbUHCxIbnmJjJ8LIj2Ki5x5HDbyU25CKBaanqnxOBsjZro5AQtboEyocCvcBKFU8p3fLEbupBJIfzw/JvdQoyWDDRTOZ98og9CAQUFIA/K1Ky065OfX3LEe2kSkgMSMzx4eE0jzzb6C2N7+wneX4s1kR1IA4p8YuSGpQkj2gYddvnIcIqomGrPR5PI+IFkkuGYUkh46ul6bE64492dW3QfdGHv/9Vogbp8F+9yHw7wW8yeS/qZBbznu+J6fpFJwy5zAiSpqByH7nstM7b1AsrlRBO4tiJ7gZhQi+mQ02I65PLOkiXJVDQ78kJ2kWPHpbIV+QAXN77V1zgMgc2O/AeyuzAmMuTg1oqbgCArUFYwonZVIX6x3OGlWpBzd+QGnubVo7S/wxGCGtbgUZWiSoHFXK3YTt7q4KdKWCs3B5Lp8E5GXJ9Jn8dJlbijQZM7HBe2w7CdrdQOUWgcSoVDkGLs1y5HTBV5VLI5i+jsHo93JFNV31Ocwkq4c4dsICKQSRURE6OfSFLsZGGGVBuIMyfYQGZQtRqMHZLgcT8im0pn+cTaI6J5VW8E/nHiM/CiQBzT23Tt82fQnR1BJpZZ2FIoWhoh6h+OhENk3SNovyBsojOeIMr1QNXcRNU4Don98YgsOfGIQxZ7v2EbJosTX5gHvUgvIjsFGHGFA5k7GF+vDEhpuXr2aGgs+wZI4danAC1zUXkb/JXFRlwIHUHrcwmK/dP3Qf4BlJWNsnRAK4vzYhlr8uXi1ms0JCQxSydtqhO3Z9e/dU+IdrW/+h+DYqIkdF/BPlzYfdxWuuOJM65cmRt0CKtWdF6webvD+uIeFT2Q/iR6DacHjl3iiXMaUoYqJxE2QjnxJrCbvDWO2GRUNxvKZnYxbsb1P7gZgatAAGgrOi62Ipm2Isv3F9mOVM7ofI2Chv7RDMuHgQs/jNP60FnYyFx9VC+xmyloHEiCgwctAon4+gXx9ZG/g0n8B3P7fGOTyCFTMSySGDOix3eJsSKk/8UNP5GALpMqloSERFwoTjUBLS2dqJdua5Jjv/76glp0EqkxUUrLd3fx7/pwon6LZR/6av4F1NyGfIQL1dW4NUJJrrM2uAoUQDwgZKRzXpDsWOWYKamFl3T5JX5E2BaXgQzyfshl8JL0fqWSCyhqvKMtTiIehW/xcvwW/1ntLR6LVlt2hN6SXCRwlPbNNcSIIpoG9mKRRDK1pZchSaDvKvTcgd+VDn60maFKSZMJj73enmIBUH1W5MepkmJ1IqeqxJaDKipSzIq2KE48ebeRfIO8vVEZX0QIBzwVXYrSbQTFJ6LEqOAHXEOTC9jTSb2h8I44zFVIcpdkOVQHJEUEBZn7UWIiAU/xxy/0uQDJHuQBYSe9gS8cKQv8hL1EnYEvIkh3vexImeoJk+mD6o/3IPGj5bX4CB9FrivbqAk4W5+opyNsARKwyB482fAQc2viDafuPpncZKTAc4QxXuM4BAdHOm7Uv9PmJRRFUIFSGPISUw9EJkLQV725oQRj/1ETxBkbJsLG7hONQL/cfGtT6fNwyIfrI2ZwQCoLDmUvsQMwJ6jBB2mTbz3eAslWxLcdV0jmE6AIfkuVaI0rRCUVzrIVJQpXLdgqgowEWBDDxoFYSw4QttinIXtGCI+SgNZnhIBCQrHraUV59yDqKP8ddRAmaCdNZzK4ogiDXIRB7hgGOU0M8tTCIHSoQKndZ2CQn2hbMIF/x/EHZHj8D7HnGB05kYGeTfWXhfz8jahwF+z6fhNFyuLyjmiRcNBPp2QgrPkjpSEvTYhOBtcexBDPBRgitPhulXHj71AiZ2rgM8ALD028vyNxNz4Ti9zQWQfHFA/IRwbXYuVUEgV6UQ0WlsVBtND8Agv6YgWRjfETXvvj0cgdj0biLEagUTcJWDUxjUhcTE69FlNDKisDSziDA/t04HnaVr0LFJudMEKyqiEV8yDXgiXcan+ZcThNKIH1huwgDJvMIOqq4IUzBgDuZ2ZuaqhDMxOqwjtiUbHIpKLhbCHxg4CLg+O+17dwTY4L9gx3mKQzmGU72UfCWhdVqnEVdBNykKvr3b+c29B4xAsSOb+BrFEK79au++LL7yZ+fW1kkDhux8PAcGwCYdqMWokIWWvGVRdXq4S1Qjl4X6tyYXPnorlGzyBYonw2uUcIh7r3nUQFV2maKZe0rCWXnAsa/kA0+XhaJsz7YIP7/B+5HzlbjKgDTp1swnxARkiO9wmU4xkKEHg6KgFLG6/Sfm+vzeiggFEcQgkkHMoNRLgZYKxmYbfDq3ht9gWH77B4IKMyGJOzHGYv+2cvDzktLoVyWUdFtdhkDRJeSHIt5bH8ClfjceWxG8eCZ30u4NzSY6JbdfBioptyJMh7Bf+cC+YGyoxugUz1VzDkaicfCpLs5orJbjg1QnJzxUtun/yz5PZX8IJmULedCbVxqABMvuRbG6qynKo3U76L9P+4Cr1oRYqn+gL6Sq5QjLnwVJrmgr+D3cZZxqmaLN67BV2gWfcix34XMKduk+RYkdScXgdsn6hxWB6/ctF8iiRF7BBMnMkFGFOoRQKV+AkZ1pgzFwaxAVuDTbBSpXa8gRcI1yUcJ0PWA/ZmvSQIRDfwoiA/KHd7uSqeb/b6s8Fck492mWrcCk1IJbjlIG+8GkmgxCuVI6hAB1R9VtSq8DSB1Q+jyKRjIQBRTNnIRcw4G2GX6ElPQaNR/UKL2gsjyg0mwO8q6Fwi8bnBACRXQDJJn0DgDyl5wWQO7xR44S1E98TiQC6pIdPQH1dN41bDmXTM6eP9CtYF+SFdTQ3Wg2L1ST+GoAhl0PlYfTWQj/0ONiBJnkYFMl2KsbSwREp+3Ku6dFSAsKmfr9coo/FzFABg4Dr5YWWsjgRlXpXaAKWz0RlBECWRtSeA4akTgimiKripxUGLkMktdjACmh9dff14XNeD2/KhjhzBBjWKDsP7dPi6HrEfLqqbqi69sGohY7iFlC8UR4oaoJ6l0woRXaelQDJSmJtGCURHh1KatXTsWbpaT03ODdZT62OF9fXJRp0NAOz1CNwZRDqonzr3PHTx0yCo7CLwcwH8uLq6gaXjAQtMvDDUdLUBn01+HBJ3HoGe+zEOIejkNMRleWOFm+U77JZQYdv4b0R1hqG4Qq8oLeM6dKHzr0TmYgQT8tEnRzM/auFU941iG/WrwnMYIeonLKbqY5jH4czr9ap1OBwVxC3gXRvkUhEQzmgOBMSVYH1yZCX8qIfv6qkN8LMGxss6CLT6whorgRoG2BFfoyZCElg5XBqSboPu16e553gTcpKxPToYRcjaF3aQC5fztDkCN7moyn0t0zCRZvo5erkWnAIg7GoZU571lcgHSOIMErA43PWiSlPlQDieUCK6MGKfCDtCNjIAUwZloCUhUkKmp/NjN2+pTfIWxTRRQGKDXBUj94JNW6hiZFLFyPwQSxEUuxDVcaotP+TAZzxI5volJE54Guu2Old4kCJx5ZAXXZxhmKb2R9ZnLA6g16L3oo06DG8cOvBOkGWJljBQRdIC41GVB2k3r93Ha/fx2oM+3gJKXv9Qv6jbzSvGlUWjIK4ED689SPd53R5etyfWczyM9aC1wEX6He/lQQTaq1v2r3+oEnHkf1aabljmkQ/eZDmfZkUMQTEmAmQTmHAPDsWmzwjQebkkOq7EZlkRbSjYBponUc8k3jMpw3tctivoZUWynYWHtxknNGj9AhNoF4c/Xcjk2MZNjnGl8/eKeTyk0A9aBFkoi0V/S0hjUJ1Lje09/+nsMgoLceWVzSvCQrKXI8Ci2wTn7ERmXRyaW2omvtHLZe14LtQDCOwVVAukCnq0HJpFVF9Z0ImH014MTeBU/QZN9+Ii8opFZCc61kLho1dtLRQXAQCfCAYuCysCWwitFTLdOOClCmwW1vwth89hCNHkVyvDX1+RPEmynLNKhhGHjq5s5UGkSYGXxKtz+E9F/LutlCQ7iU38EQnBmmBMg74qSGel1hlBnZZFbDJhWq0BW2yKpBbe6xfiIAF1I2X4b/g97sbiwI0cT5x7qI4MWAMyWWzWnK+pcY5G2w+nBTx+DpoE1YFkPBhTQwYD0Lsk0uonqYm5oWTkWFJyeQteNYlMimxA0sVxOXondQ8xeq3AaxAJZPTI8eVT+0lG+/mh1LcNMwqHdS/0GKeEDr3uTRiVYzW9QpbJUgg6BLzTuGAd/c1LgzAdwbo6GoQlc6YJ/mZAiQw1fQxs63VeDzaE3YuNUeu93uWLpX+c8E0KNeqiznhpDDBd6fpj3zz/9SO4SzH9/V++OfUQ2rM07LL3w00L/JNCDV8KZqiNXoL9qwG8xG9CDWDzqotMRV3OOjdAKxdJrcMPYhp1xoWsNuwsozkv9HE0AEyVCkLsapl1Uaer8Gub1sU344OYzCOeVmZFAidpKhurjcOlQfocdig1tRfxEG6V3FXwWDccahzTXPGnyEfZhtqtcRmgQsgTRnZfxqnxkLlswDLfAYooE0pS+b4omFs/LBE8iE8wtmXZMGXIviqbLGCBjhknxN4yvxeXi8LNMiaitgEN3mPuHTMkK7GqME+p8WeNi/+uFL+7hqrS6hhIgvauc39+N/zblpWdgw7dRZpOm74Lje+cuWjpDojWdekS/PO7FiHjFhdq4nZxbq4eiREO1d51zvt57t/Dv1r8asMh+0AeNCF8jKEfdz0RLYBqdfKQTAIgDlPYMBVWMZdIIzMze2CGmQhAIhyClgcKezGrSxMOAarnRwSoWRZDMo5FxdEsii82vcSVa+g7VEcY/7EopCJkus6hstKFQAkhkYRK/fxTeIN1kZOAF2EGMncp0FVjjAArTkUNjavABOLXyfk1Zn5O7CJqCZAOJK42Jf/KaDiUHPOXQrdWYNYS8oOpJjhwKn1C3AlYpl/MOrqJpq0O2S0Vxo6i1bSMwHESmR0gG9ktE1hHvK+rukiL6ab5g20I7ZtDfgOsfkOD6sgJeTOAU/Sj+iYj5M7j+lOydUP7RD4vaI2ej7AwZ0Wo1uyxKXQQJayLh/fQpzoXn0B7YAXNWzIUEM8AevR0NhLJsUQ4lA4zY6rz6fDOT1NGPY/ENr+LTRu6XIupA4ZWTQX2D34S8tH3rB65ANiIpVagPs4E1iMG3U9eJhw5qN8c+4XpFVqKQUs+C5tMYYm8RhyqRFXqDnUnYiqRtMXiHDaYBj9KIVaTiAG28kHCAi41w4hdwg92SEmsAJlBDW0A3zA1wxBXSe2caoTmSFIMP4iQl/vgQB/SyT6UdNZ6W9LIfnJN0eDncZmXcUiKYaNe12nBLy0cCXxPc+NQLUgnXlpYEAsw0oSWn4Od7M1Rq+5WA2QNBq3Vo3mrZ6CLg7hkG3pT0JQ6yVDHmMoI6RfDcdAmkiMJyzyheUhE+lNPlXpAVj2EbD3h2isId2oP09xMLFMBUOxVvXjCA1hLu687YzVwG0VYIwcP9sseoT3aySOYOHuBNAv0BikJ756X903IbohXKI33oDN4CeGA3VKt2kAef4Ym11lrcjEd59Nm7klBB67H+t3iB+IEYc/PVzfBsMxCo3kYMYJJXMgaG+48xia1zmbnhyMKbFCGS9eKoM5Q+BEOMbYYDCVVykcVNIFLyQhygw07mb3mrV5m6qrDz4actRSSzlfofFIoJF0AktXkaiMV6lLB6jh/VjSO0+UgSKOc1NJ5ilyoTxgNYPcQ55xIersYwQfq5bmA5zNZOPMN8c14rE8+OO5IbJF6Lbs/t71JQPceXCB0WBKv2OC2GYSlIFbSVsgtMQII9ACFvlH9PIyRjFiSQPsGNCY4BwVRxMHPtxTk8LzWUTMukHEomyxpIi+egOeGwIWSgItNo8E24AOxokiAA/ysHLkhQl2ov3uGmpgfz+Hmr+Yci9AgBdCOAT1vuQzQ48IhMGycAVgUkwHyfipJtommNWeMEY8xrAPV2OnYwDEo6UtLkLVfwqNAqgBKPHQLo2I+EnLQMSDa0CuRCB0G2ulMXB6YEULqZuN/ISWV4lFxOLIsZKNvJLTVxW9UJe78Cb4qC3wtjluNx1Js1BahEyHYbhhVFAmHIxccgu8LXuQQfH8w7hB8V5Afgu8IXngI/oXb5iIm0G414bCZro4wUJ2J8JoUmkzEQsL6nbhbu7j9hlMvovVHFr1u+CgMPIdHWPUqhSEnyn2BXJpie8ZqLgwudqEJvVPEGZu9Fu04XWUWU3dYpsICvnRJ1zbXNTh+sF19bWAGV5Wb4Z8SQDZMhHUXoBBQTjXAz8hhl3OakWu8+sq2uOHGbY2JFP0pEXBrhguRK0HIUHw7xiNpcrtyoUWEXXV1Jz2ehCZM5paJFuPQAUVfWYoZGLSSOsbN9ig0WgIKrtCKXXTLafQJ7XPJoBt5SugMrMxEfuaEwf6Q+ur7I7V9iJ16BbwDsAUoQpsRAQ3rS8AlkkC26NBFDHcYCgiaiotM0asjZC5sC7wqbNBselt+fkFOqWveQdWFvrKSGeRepjOU1wxcoOlEdS1xXCw38LpFfzZKM4kZ2lcJmpDEzZ8BfiSYopVNgrBylLndGmq4MsljCqmFg9dMXAg/n9b5SbeXFItePBHGfoZAAiLbiVp0L+QjygdilkH/EvVdP0D5RMSiCNkac24MjZOdhkZiRoDAlAAPCEKrSRoglh2QgBMUtACLbQTJyDggH9yT/2TrkydZVQGWaAcpscfU2COy1Sl4BA9wcgDeNB4LC0V1jiEYoSLBSxICWgmhlUgoEceNZguL2+aj3f6MgMFJEVBwiw2Ytg+Wc0UWM4So1pZbjSLQsaTe6sfHbHxhmEZ0ytf1izKMdtEiO8Kj0fq6vvoK/vlKC1TRdKP2tMf31SCStbhv3oazma9Fw6jws6EdUGKuUXnlyGzkwnSJuyyMDiaSzy4iuJqKqt8OMFVJalK4NAwsGqTbhlLI6KA0XLoklAosNvwdlBFMVpNAHvEDYyqUP4Zoy+MyGNrf5I5KW+iCaS/k/VIGwiZZz8/VmDTLo+K9ZqVxsBK+EsIKVzrCtkrHQRiaTMTzFWiIZlAePE2Iw3/G3ZEVg3VtJfbeTDLx49hcir4YER50QrBnVnUn6s+BVCic4YfNjX/Lg96tReMXpdbpiF+nOHdCocZpk4hlRxbGBo/HfRwM2DE6/rILraoDlZp+wUzy04GyZUYb0LW2giszfMy9a2xyYszkr0QyzRJg3aygkwmJyL+dWx1yhp52DxdRRmyfid0hSOpiw9KO6KUXHZJgEbqIsQKyJk74yOsEqRwS6wQrvfTqRNt9RON9cQZtsX1CwhinXB4hzSaRWNyCkBdJfjaUUosfTHklyGL8IEM3gJRSFX1SWT7s9bBrCdLDj1eYJRlKgQ08JYzxksLBFJpVHGgSWt78yyDVFNjxjQn+PxotCBculO9gD+oRFBFvA2iE6fWavZAtvfAFsSfxvSCmi+nTRPO1W/cB7eERE6kXca0LW1NhVWVwkhiUTmDOLklx0qJE0ybaMJEvIubQQZZ1+ER2TTH7N8ITG532hgixAc1yaRMkzTTnBTBeoyMIvAQehOKJpjgzpXM0mZ8uSfzHJyzDJBoiNoq/cmxFmVKJg4bqIHLL43zTxhpn7fOCQ5FJeSZWQ3FMZ8bNHriqypVLUUeEKSRZU3Hj9XPGXuu9iOUIdgpNMp6/wHLEhh6ALgz3AuwcRa2TyY/SR60hk0VOlWQI6yMz2VbKBIvJx4NYzspYTLAKcrzDSuBN0mbKxNftQpIoxFXOdHIbYZIQF/9uMw2EuRQFb7iBMEhSwitcpvGgxcWZWReamJCLu0uv3Cwjt+UiXiUunpzEe+UKrDR7ZSfbZdXLiwtORqah+xX8oJWiklsxngoF3uLZPKoFesqH7AXo2Q5U2oUcDQLs0dEZ/Cs3/84beJt/5cWZlHj0Rt40WfBykyLs764jSi4UfweLUxO8aj0mXaDyKrCK1gGpYWmYJe+ggAUyvd3w4MS+5sYZafk5KcbYe20NzkyJ5wpdaJDu1rdulmuxi2595WYRnMVLnkY0CUg5FMMxTe7FbTveNWw7UCoJvCeOhlw0lc+IrVLmjhyWl2T6W2tKEVw2DMpjhDP1znPItpjLmzXUKROnKoC7ZLRuCf5TbMa9iUX/QXds2xozOuUFoWaKL4y58+9heChSTisl3RIYKBYH5/PZRmAgI9wNxvh5a4YR+ceot6SCmEAKF4Rm5Qdmx6IAfT/bjKVDVn9r0M47LvzPjH8P/1NsDf9TayBreO9VS1yfVsooniqeIQL3kKV721zdYYbIsfu5SWBRd1iXk2U9qNoyKCCe3XC5tOkKqY5V5Xoea3s0D3iqoO22jPZIqoik80vJRcKsMpyoIDNirJKoegsPjRNHg5g+NA7X6Z31xQAKm8NLkWLFEX8UyZPF0y7lRvjO+FxnfC7WHHLFm+jHDhnJok5Gcy8mOA7ZjM4j8+g8NHBkJezkBGHTVy6Mi1VL0Xlo47TaZyGLGR+g1O6tCsgpRQ6Th2oU46FoQZBPLK1XgPCRiBGSQpfIkZIuuuB9iYW/l5GXQc0pHX2Qzs2+mouZ58bHCd7GGYkgAIYnGsZT1Cfl6soNpKg1xX3sOrJ1blw4RLaoCXxNezjeg4G7g5+MTolhgHLE7wdIzAsAvckHtsTkxYDvQFnSHo/NwjvIgRuwQ6hKsT0HVUHmrCQPh5LjvjP2TTJu5VGX4kinI640j8YJ/FFgtSBpKXF3cwggJDiZJMl2m+L0ope0jcepdvBPEZJ4D4kcWEPULsVHgRoDOqpKsXQsh39M2nA7XQgRopOpNNSMx+SGOmoiKcZwnCjYJRFrisBFrK8bK5gee6xHvo0485Zs0g3LHLgcFHhuxBWC6eFgugFjl0UnbqkSP1XTSOl9wef1wpAvPnfiFIlAlcSfOtS6ajqUiah1wjAaq4qbQxTWgV2tY12csWS1NhCTyWodQE5yk0SHrxQgT0cA/cMYv0DPNJxIpCCGwU/RpcJ2cjVqpQLt5DMibNYJHFYmnmHADtcwF0oB0rjwioOU1XTAbAY7LArW5zF36FIKKR6I/GuEBJKLOiqqMfUSCqOAopE4tnxfC4cy+HkvAKZOTKcn8j/WwmpGmShQB6R8x0UwXgWGBj5W0y0HHGrdMhIABKzTLXrf9NjiAOmY4MM7qz8lde00p+3BJx7q1hkZbndu4H0i9Olq/YEFdC+GQnHaBWRMPx0FWkiG6Uvhk066E34KbfHeqz3ranqQR4f/jx3AUQTrQ4/tvCuyl+gY3tdBbE8qxg7x8nnHyVBIYPQIqz0nX/pkbaImQXKGKz8XCQOPNR/4QBjECzJIo6TiAC4XisPi0A+QHxG540UpjYvQ2FgW1BOozGcjs3Bm6Nq4oirB4OIVUpMj3aEwMbRpVDQkjWcm9Rf2EVeoXlkImIuV/H0FFVPhXb2OypqG0O30+L0P6QsHaWAtZ69aQTnAMPhd2TCYjlaQNipijh0wyMZhHveW4CFbQuu1gs6F0kuxLixMRxUIHqcVPFAZ6c/CcXBycTGIzz86+mJQYhVtLnicaKpQ3xq3VMkY0cUPUJTcfFICC3NsO0kDKTykDABnhRsXsIBySZBbe4fdPPT+YreVYIuBJuGOpGeZJvyqneNbffJ9cnLWVPh/W2w1QbpJ91mDRyOKOEFaJIqJy70eELo4UhnD+lioVDW9FOePdg+1ntU1RDbqotrU9DILGE1HfkvziF7IeiKPkIKbMIjsuP2moPMgselonIy/qMPBXw9I4CSAC+GeiKUDI8cjLcOdmzPyJHg3MhiOFO85u8L1YToPkSyZoxnAA/vFRCiMDYd+s5zhMiJw4OJyEI+B69MuzrsVwWRYHKpQcQljBk5CHgdJeHT0yqBVImJs4JkVxRjgrm90DMCDPLq4tspBTXhIN+UhTTieHYR8hi8L3/f0uJN9Pz+E41wOfgcoUc5d3/zciwfkrziGBw3VDf2Pv5byx/9K0B5T/thR4CYdXtCHrI2IVpKLZg2GTb8dZwcIAezaQu1BAPGozu6kP6brZzBovCFBOkiHQee5Cm0Nf65Ys27Rgec3WJkhMhpVuIgGcBMymoP4ogQQScn02KmIaGpAjPA4EN4F1sUWGoZBh0+yAh8KNwmU2IFh4/4S1SuShCBnM0gtP2EAum+qWbiShTBB+PA5TF7GLeLA4OfI55GrFhFoig31zxOGJ3VoSUMhoX18skhhE5sx0z7dMnEYH6kHgAaDYeDFZuIAGddGQpxDH2e77d7nFbzDh+ycyFfeIpEDJeUSOTGQdBKpF8Es4Y0ZAoQuAUKXfu5pYoJd+pqzCbnmeTDwEl4OATrL9Om27iF/RjB2mxZZ4mDIE4SLXm3wETyUaQSD1OO8JWDsEtVj9gZnrohOtkiZ3IVQY9YbnxJyCNWxODUXyOHhyIHQxjMrPtuhRNU7kEcg9cQWeH3gN2PhRAisQI8T0KAcABLl/rYGlrjw0cSSOEA5TUTzi4u3dHdPEhx06foCsyq/UZUfH82qdIqhlOB9S7JJ8Z5ubc14WzEgO00DrSB0k0yGyNUbBDjOcL2sRQRMKSjXKqHoV2iSXxV9x7BbIViTBBM7PxIzYOLBs3dTOswmm1Od1CoppCHBgONCj7nN7TTM5qQie0z7V+Iye86pJ5cocKWwCyIYcWrnwU7fhSsH1Zq4rpnVW9MhfCxQJF1ikuyYEZszAwNXc9dKIXqKA3NPnN0LRrd286CiQLpp2DwavI/ESFhUOG0U6cvgpHyoo2IxeZJ7Szi5DGm0ZWmEVNKleDZJP3qJCVmfvovOLOlHGPz69K383VbLO1VqoQDJaY//8NR+TO3HlF7Jy1da6zjC3x0x31H3JW71Jiw3AC1Xk3snUkxdBtqBseGQ8qzmCkYKXQcUGyAZURPKgl6cHDcm/GXW4OWJJtiDAevUimNo1EA7KTwE2bp4ycjMlLXROiHEg4i78DSBe5tjgAlHLo89ZEqElVGzKWBYxBWOFqxIwqNttjoMXBHIyKVkRWCcPOCLGJ8CqUEZZWFa7GIndeKWF4LucZpOAfBoDzSXUTiUNJD7lSaRPyTI+3jyLbYwcfLNsYJfF5KMeyIec6TSRpTM4U9nPyjoovBjp5w0YxsQIQat4qsVqdFCAcQD2k3qEL/PA9/g8sD9AYOIw5RaLApj9jGV0XCMvssZoUAp7VCoc3AaqijrSkziMQk4DFSnYAgsLqYAbgupJ/pHXsdGUYzCecE3xI3hNMHfgRkUEwr+DsooDXlraajIo5b0/GhnvZpw0F1GnqxhAv9FMAgVcWlowSWi+DnFnX0ziGeog+XqqMm8ZArtjCkobeWGUsVBjQPHK2jZxzanXWyPEpkAQ0NIhuLCzOAMizhtxiWm1is2iAHl/AFxgK4LDGfp4JTi5OULy0xTv2E5JbecnfvJqCRev+GgLZEbXCUKBUUidz8QNm+J3HLRKfbGeP2GHz+F1Zdwsc8p5r/4PAE59QRx2DaDrDN8ZP8XobAJcWExLDCQsy2BmAbxJURcYyiRFFfUnsFSlaqesmV41uKxCICknKr1Scgf+yjkMavFxUFSsF/1lOJxrVf4txpxEPksOFVJWG4Kf8wEAgHORiLQjURDJBYj9+LIvYKl4iePhkjcQ1i8IDqR6rPtBcHtvvQ5nQKVbEXO2NVmJbYLTIow4rJx4B6jpU7DYHki33LsITdF0nQTk0MhRGOHtujKBJW5kYvkPs7kGWQpoXrp7IQHL7XrtlwKlQZPE3P5JoAq8FzyAaLQy0jXMApzYS7GUWHWqFfYkMr3Un5JUsjHr0xx8m2mHd0SA71HC7Y5xJ5JgktHLYCpDQ2IgJ1JGMCOS7zIHRHfHUwmbUJseIFuJGo4gHbYQynoVhTICNnFzYx4zg88WArSjEQylaMoyER7/SIqpoeOUpOJW3KbB/4edKOyG0e9JLjQpFj8rjxkGYWYPsPFmV6yHOLRpkn/nYL7AJA1Em+ELIriDQV0+CcQebmAGIh5GQO15vvOl1qZSRvTTfeYdGDDUoG2D6Y/P2mRrp/swD9/aeFgmknzd0UNrZuSjfpHb9cTt+JFLW/Be7y4ZdS1B6F8XX1FIIgqZdiwQNq2+jqlx0Ankdow11h9ZIrrsioMkgEsSRa3HmTTeOiMnvyIwWV1v8Fw6hjtk0Q8flcAerpzmmMXO8cSnEF+/4gp9yFe8hUHHUKi6bISzZCM/pv1RdCOeN4yMU7DkUgdCIgOGEpdD+9AYhjt0i5oEiOfA/rgfb2FPCiqKhOueAgdYmiRDvsbCBORiFqvDHUmcWgC1VAFgLFopSYgG1JMqVKgH94Kxb0dFXFpAoZ1twyoPg/CQGvC4jyLVrZdG710pOelNVWa5XFgRqhefISL2Deq92I5wCnVK4VMWa23TLw6BNKEzLW3wnnuB0Amfg8QMBxhmK4yfsPw1iUGeKhDcfQ/LdZA4sUeBwJDkKimcsOqiFoH0aBuGCYWK8ZbQ9X674XE9VgAa1O1jBErIPkwm/3XH8GjWpmF44t1IAPVS3a6kkvNgIlKL3uPwsAm04JPVpPoN4muWg6lGJwBNxW9i5DNosX0IoVZs0QywsTEMA64YcQ4IHfIWNpJD4CzrnC6ZjmPOQcwRTybmHtBFgbwQVHYgQwTNrViCe4xJTaDS1kpUZgxpGCxI0qxWUg8wh0/e3IY8fCEIjFE/BOPk6NwnwNgDxS0RzT8dTgnTDFBXSjwkHWim58WouAEmz4VMoQey80bLjTVpgCsPciEkqylyd7G+7bP6aGNkIu2bjLbRTE45IhxShgdLh92a1thyCOUo16ucECdgskCkWaGC/3xo8MYBsgOmVJrDBN8GUhnuTYGyF4RmUYng+SP91cDp64m44JKM4KBWk6jcDaTcOZTidmuA0ykxfnMbIozpHVV1isjskxNU+uUEieRrPMjFx43IRV/UtW6QWR163IjS7TaRn2HHzkOH+yqyJ1zbQ6LxeA1uxRgpLRFtOKRGJRCOs1JtuSjPRUymDQkgFHdXHM8MYhAp0ZmWOYxXU1b0vWZVqXTn5nmuDYS+IK4kXSYebwYO8T5Z52ftDmNqwqg7fokNNF8hJJy0VORguV6gw3UjGBD3RVshJ2Dv42hR41DKo6sMdShqk6UGxqo9REiXkjD1PtVlVzug0G1IUCjEVChxoJh45AysDRtiZpuJVlRq5SXAFWpCUZZNUj8JYamLQulWWw9Ybz4NhI7UlpmKQE11cqEPJh+nAwe8TXFADP6bydD6WQKmYuEiyIiYjJCQSDQdQre8xL8MAHESQR6igpgSxFhoQErU9QGhJVYb60qzdqYURszaxNYJmbSKYgYt+pGANclmc+F27yaiiG54uuuS6/+tbu8ZrykPpTip9v8krHuJERaYUiTgNwPM3wnGJeMG2CRBmpD/GlohNprhD+NEAW4H47e4AbgFIVfkHEdulBcCI8u+MqGrhtJxHPnA3EhQdjOlUSpXFnLuH0e3jZEtyuwnmgAB1/ggbtbiZ1rk60WN/cT4SmS4TFFBDxIxgsfkRHB2GyIS8zApSWwjeCk1cWl57KsDFESO5GcS/oH4FDpes1khBtaS1k2a7oqAsllgpqSC11LtmRxZoxAb/qBWS5vzIB5QWZPzLjLMtU8LClhKGrU6yxZFqqzFKbSivNUf7KaSm2kGDh0kYaSM+iwRtAtU79lGTFvDFVDismLXWQ51rG0TuYW3KYnlXimVKHSV5OMoxDU3Ap9qPddmwP3ChSiPKSuxhCtdh4gn4fIZ0lTuJWdg6x6uKYLNfn5wsvChQ6Ibu504UFzSQ8Pt4abR9dH6ALSaRp5CYBcL6QStEYgLTRsqapTKAaTUWKEvvFUirVxOjxH2EBhbnSH9CwFCvNUmol2iUQ36gDTXBe+qIt9S1fTkUYlqHVpIgwaHqZVVxc3hbqqocTowU+601R7YD3WTDfRQH4ahtvBMzrAi0S/TJFksDq1jsFSoM1P4HNThQzJ9ZzA82YQHHV51BL0IXeh/3gaLvU0cb5paRSl8oSYZGKq9quLgvV8lGewZWYhpJC1ZyxUT3UMDNXNQDVkXb9sOALqRoQZyKXhoaYudoTqAM4Uj3sjGNi5HjlwoVuHKuMtN/AV8kzeg7JNppAHtol6vDsc8UYWBQps/cD81IpPgDcYrzYdd4G7VRnKYnyJgMwlXC49MQ0bFvDULlDL/dJrUclFItyoAIOOqhijw3NBFkaoxJh99ua/Nl7ot2WXkU6bm7JmQO9IL4ZR+z20DoW+x3T3JpW3XZhdCU/oGAh4FCQyBnZTsPgIXh8p3BFleiMS4sRJEPhY8CHvDlmWYycUK2Wra3yYogGzFkoYFrKI5A6pxTy1WObJEp4skbnt74pnrKfl6PzVTsazfYYhrG205k0e3LSac2WXmfJymIsnHakB83T6KrPEx7ESok3kqOVc/RDrmnSszeQlT4++lrw2jKNzxXLpKTVayoP5l1D4qMXyoBADghagw+ISmRP9gjiDkViONKZWpgtVRrIZewD98oTdlmQ1xCfNri1earNjGEWJyuHGVGLcsWcbDG9t6BevwD9liRZdHHp82gbWqoXHb+3uZ2ZVYbOqHDojs9FaKy3jB4e73Q6fiCRi8Y8rTo7d4cXDnfHDLZveeCxekMtC7tHo78S9yvGNLZ/ocJ6ukM0g65kR8uVjqEq/6uVXGtKxrVMvVnID24jcJlBNqDdJhu0SrezRiEL15+O+rBe/nAQ0XsgL5GkKhFx1C1KdiMqr6hXo5U1B8xJR65WJms52cgNkuxHPEjEYeyp9ZxN9IpvORFXBgxRAQWTN8RbgpmYP9WI3+iEV+0Qv6SoFcjJM5JFxE/UViwO53K+Gc/EBnaH9aCKaadmwtXYyBQFO1FcedZAnOn1i5QeIJ0E7r/iQIXXosi3sQZpQmoXqInzr5qPpeLqK11qj+7+H9xBKIQ9VT627OlRfrR8hF3YXaT1RO4oCKt2VXpfuBdFPzKdLuLB6l1G9j2e9VgYInSaKrYJJcBFQcXrQPQhjG6RzZxogkURpUOfF4vx+LBGtGKrZGFezGeCTYCetqyLIKYQBwYb7FllYqPqCV/OI4FQN1AYRtX4YxBFraKpashN814DLTggTl+FU10Cthz8N1QzVtzrUSG0UCYca/UtEkkZlwM824N66aaqre8bqSCTYwEsdJk5oiy1XbYCjbICwbsAt/tU0HBy2pGaUwXsyDkQGGb1ijEjTbu61KzRH3GQQzyqApRCRCwKCq+coRLcSxa6kSdTXQNtBi5Qnl6opZRiqDUhLfc7tWfh5S9z5AJp0Mg4a3VUQZBwBdFtB0CZOCBO545RD9eRz/24+VIzSIzQjjIJ94LEzoVmZWqfMKj6IK2AcMNCA4VeaCJ2mFYxW4Xv8OCRa7WoC8XA2ylglMnhqjUgl6CV4AR28KRdvvKTSgBcV4gUFzWgnb8IkerHDmJJjMbS3yrIr7pzdsDoWDgaZpn+BTh7C3POXIf0gG/30dnKA61/UEMU/ahqy3ywO+9BsiBsgWw6z0fGcWb1hXbhrC9seuj/AiBPD2TOL2aERIpjM81BV5RLbuyoMQZi+dY8fj39jh/i8b5l0RiIFPuGGULjA4C1AKLDTHKx4o8pmB/ANgI3vhnTJjygiBT4VnxkGAKrXu1pWpIkOblMi6x5ubkHKKUlogrmdiI3MfnmQKFLBYjxm4d3pImIhW5xXeOBj8i8S+LbrfAIyF6jqd2FAqNV8b/aYZqgRQz+JtqNCU0UnUUaBgdxVHJeqMArxwFZ/G91kXq1FxFmvW7eLMXjwyFcRbqBVogDe9RkDM3l1ejAumotbNdu5ir8nP1ykJSPdjMfffKJgjI2E+ZH3LcvFHta7j8gdmkxLMMR8qeHkY9hlc/MhI7gU3WEkG45IduohOrrrRxbC94YnEplwwRvhiYSbuvBDcpAf0hOzL7i/kiCFtZPZyBsxVyNOp0WePfCK1SEGIxx7jV45Yj75du6Tj0UccU75DnLKt1NvTV98+jzwMsdZy00+srfKpiRw2z0JMSwm+eGpuPAVwNNRiUzyUL8v5/MIjFwOdJOZiYhbIaLFkwDnx6Ab3K2YDBCg5gTqH8UNUVBhSHFO/UaEz0gp7Nmm5yqxysm4TJNNvR1Ilr3Rf45OvFHM411RE8l4uiO3wE+yqsnRmTZpGQ8fjzcteVU/yAl0gOvn+hLTSEOiXpK2WXVzBU4wiTwb7XTAkayiH7VfhI+n30hpKMkSrCXuYAUNSYmSE+uPPfdL/H4EsphG6VzcvCblCt9/vEquB1cHKWIW9Ak0DyFvHoXi9HKPBTyazxds5gTOH6BpfiL5D5M/JffxTzAAn6jKSEnt3AUYaGQyebzHAV8MBdu4CPypNAJezlcDhgKHW6CqwpAXeuKgroshJerS9VBVIJiocp9HBTXPXhfTK6ZNLuYPy8XD1uVT4GEvykHyhTuIcPJJvMFvBCGnu61tyBjvx7pEvMAK4zlkF2d5h6wWG+ZLbVCGeHsmGoHXnJodjYaXAG0xhJ0G2RGQ5IzDv/Mgt5SGw2UGtxWyGeE6gdMTsUoALtQDHQcG4wksEfeiSbgHtxae4VuMlzx+LPLE6e2V4sfoQ0wF2ivnpomUrnLboxmYze3iA+IOb94GuUk9NdN6j7fXupnYvAekGE0sjou6Fu8kyqVEvHYJLywGAljxItSPB8Nc9qLSfFwVRPKAYgWWCvpKJBRdy6JTi5kIGkGwgHcn6F1Q0l1cwSumifvMcn5mv3ijNzADTkjI3UgG/6kKo0sp3vlP8j4jy7b4MPa2C3DG2DXxcAM2Er3Ydr2Q02Bv2UpNx2Js6VfxMHLciNhuXI5oxvXAO47gWz44LE0zwOGykFs4+8lD1hcLBotB0ng8WHIADVJ42gD+k845E9UlTgjommUfmUECcxThyMItYGzGzDssM/8qzbzNnHlL2ErV4V0jSXKRJfSKyxQt6Z5vnFy9tTH9Lkh0EGKeCy97dfIQOXgZVRaaCLWTO6BfF7xNxwC7dD02sGDwGyAz3A65/FpXmK5i1/WEEIwjkc6vVlWoEF/0AmJP4AcZGIzQZbmPxe2t9PhsQjyWRfxAu7ilykDlg5Zwp2hNxKNJocBZnGoIkXZ+4YYDxThy8CO23HotFV2UTiyj27ipQXVx80wXN4wXjKL4Fm3ZvcTSwy6uVyr06Fddy3i0Jq76DAhCzE8EKcJXAlEOieLG8PeGdrKCt+wyyc5y01A0UDEwg991JQaI8ybEJjfvCe+E6agSMO7mSMLSZIuAaFapBCkuRrWXwoIAiOrnoqTgyIf9mx+de9CuK5WTt+LOubh/efAELo2zfMmGOjjFEGHToTM+2Pv9eMqALjgAtDQy/iGpLAkgGB8/JZShZoRDGQK+JORkCMsEt2oNh1MPfzAIN4C+PkWAptsTQIz10k7OlfQGp44xrPD+6Zjlvb1WCO0E41AC+LIedDH9aLz2WbcV0gXSeORHdiQwfQg78he2RI8JNrRUJQJU+Ym7NmJPk0mU6iZtQYAjoBlgMNhIda8ONta58gGN2RuJEj5Rgou+ftWHoi/qt/FS1p7i4iB/HLoiHWisNo5QFCze9mo85sUr0f5FxHaVobQGwjVUb5H6XWJFhJLi14QNlUV4BSMiArlkArrAhEh4dXYwnQ6wPWqysAn1qCl8diPcD6Jurlof06lqagT+yaCY6qQW5fG96RSMytYDBMR6PfTrgQnHQN9qKi2I+GWYjriQTlEoaA3yDtI17hRiz616zBN1Wm8ufmAsMErUUg9rqSfiITYEZiYGRvN801Ua8qKhZDADoNOAn02iTJIODFYSqXrrc7YXJJ003hNhcgMTAV96YmHwsZNkz6Omi05ytI9QF8P/0j9YPXVQg5WOnFS6CEevJvJjnQw1IRxMMA6TuKG9yq1/zZNL0nvw+BnGOrEhyTQobIL3d0lGiqor6LqdQcojZTjtbWNhV5w0nHZE4FdIX8ZZf0ncmMYN4m4kocUBFGg4GQR6Sf1Emg6JG5VSnKNiuScPC1Msczu2SSS3opmcxLVOwmmIB6eAKkjfB//koVDFuC2wfTVZ2vKwaTa+p7t4Sf4FFSZvjtVhC/tg3BRA57g8iqnTu0fx2EwLeyM4rWOicT2TLZ58JHrFhTfCYRELBTC4NqojVl9ojipbDYlwvZMWyk+Xc0I1CXjGK6kJZKmGVDwfQ5OSHYUljlIYptRVFkpWDeVlr4pIRFyYlAI4D9Qcw2kCznit7iB1SE5Jjlj8X8NA1qGmumrdSJiCEcROUrhpEN4nYQR34ltRPRAG6gO1rXtB22qKmh6JhOpGgJbXj5BpGx3+JsHKrks+ukkGZidABQET2SMU/oXHzAIE5q8STTvkdG77Kgw6xGoQ8WGMozOMDeGgsFrIlaEgh3cz8fMYj3dKsgcZhUTBMKBljC9OlLCwCirikei69fzKjponJ/40DblIw4DaJmBnjhz055L6xJ6rV+Mz3dNSvscPBAceMkNEykN+3mF4gzIP/DSAOXaKMKWJfAPFmznhOzz55Wbtqhu3ZJkbt8cb29WJM7ZDU3dYdoKH3r+HS6JMTePElZyjLzQisgFQUURG/2cAJR4Tpwl7bTXR8M63oxs17x75h4fqIs8dPpvAm9BnwFMIT1bRwTNJd+QHMXxbkurMAxrqy8sPZZjXjjSkG+QYOdULG1zuqoJQCSVylb1dbUhxWutydTR5M1LtjWLDbUzKD1R6kCuLSgpmHF4Q364CGPJ6UNsukfIcN+KQMBtIyw02oeMf1LBjRlORAVU1wwpWUgVQ7BKK+RNsji9twUz8WbPHH2xh6QlxUZ5gSxEV0w+rQOU6EKGmbQFvgKHKNF42NTYTBGfb/NxQK2H4ee4XAmmoUQRWZSNoOWSY4LSOhBrxY+rmMMuXwCQFyMYklbuZ9hQ3VFFzqKlQG6GpSRptpoLgUcShNJ1mWCBCKiJCKiFCHbV1JNgaOLZktSWUawaFmqClRzBm2suJPFaeZraQyrfrWOyo+HbEihXNWdQFrdXG4WBjtSVhXEtAkyASPMG5JYoY/f+ABW1oXfhRSWH69wHb04pQOcRiYKwDWI/HmbQC0E4UmK1k6IcKPbOTpZ0BMXO9NALaVoeztKl+bv0j8f17Wai12poYE29sHYmxCgqEcbqCuMFaF5DaRm0MmOs1sDyVr/IG5FxDT6SNQb5/Qm7sKKExdLeUBryMxhERZvYBYyE2NE8/OMqnB1vC5os0I5kUIMA9Q3d8PeFfChlFmBckpxGYCMFaIprFJg93dH7lqFDxqS35suDhVDDEVZq4g1bglmXeQ6n8PmYfUsZaaKYmcz9BeOjN74Gmg1co0QDAi43wLY5dvO742lIs9/lwZh+WHzeV4ec1XoANpBoS3SLuAkk2ciBG4PqbUfEnXJoNF2ek7kEn3VJrp1utUMEfYkL/ToYwXIXPpzGTe/ExoejnL9VQM749BG8ONYH8ZnQcYewKIU7kVBQBm8IKa0X42xTKtUKa6eckxkdyYghJSWwm7FCEXJISeQgCseMQ/Uvhd7mgTaPqy0dmiJOoloKOkZiXKiRYMljiYSdgv+BUJJkvBYN01N4rauN4S5hGV25s10gG1I3hvLC/NsKaCulL5W9DBOsQDEZCohe0bjAIl7jtjbQazYA+Qkk7X9QUkbNlXHBq+LoJAailOFhFUo+B54i04z4LOcZK4fIWbcAutRUyCAC4ZsSFYbF04UGMNMQgOXZUos7gW10pQU9shYnckBgjSKBATc/JFNgbn1LELODpRj4dMgKwnQRoNFhMzY1BmwmhpxSBzi3YLgQ6BitHVYRO0eAaqXUi+D/ZoQgOnwMTRgGplgbAbTFNn8N7wGbj/I9i8rJCl89ox+ShsBBjhFqfHykAtnIvb6dw/0E4u+jYmh81KGS0L3bSfFPpbwO6iX4yemuyrkVJ2U8RWYzA1Vxnb1yBy2243aQWCXFb/KRanvFJtcJk8wNnA8dQJlATrzetVi/ydXLs62QL65REjsvJqAL3ITOQQudg+Va+PYmrbMQBGXcYRxE2jBcDXBAAOykM3LobL6tyw/IQVlawKHLJrZGuvqUwlC4RXS7RvAPAsEVJezaUWqv/qa8EU2L9T8HzL+ptspqSD11OjgsKiaaKlqCQdfDsxMNhm0jt8lsOXcLP0ovRU2G7LlWTcPmHMDgqD+BN4bKNpBvt5BONw2TrmYTX+6Es+4skgVmZ6NjEdaphV65xL2i8NYIZEc44FTEOd+38cNdBRxLWA10nZqTyAI0BM0CjCMFI2OolU246lXEapszCip2OlECgNzEPD4rwaGMZ34mxd8EAujcG4q6As/bVEovScFETQrTbIGUufmIpcfsLw91kGQ/phZV4SWywnOlwaHr/limao6eoFgRlDkFaQMIuR85dTc5ZNs6N2YWxoeFEGzvNFr0X5ORCSDs4pMk23EGQlo2jc4K0m0MaL/JFzR1C04A0Gc37KQK2i4NUFRfoJkKLfjoS4/0zr1BA2y41geuB/qlntMFxP0iKh+0x4OrmcKW47iCC80DUVLtqxytPhM+UqVSPcKDEWNLYSb44JBaO40bMkkqM9o9X0AB1NK/MUuOcB1G5rmQbc2tePRqoILPA/6iidZoqWjJXoBs6YU8P2XP5jVZ2I4gO3sFEAUkd5PTmjPMntaoUkIS0UgKW6HIDrf6xHkucuUFkBeHBA0gP3t7K/cdE14wbkHHOrXcKumkqPeLCLeNyX67S4pcXinHwG35DCRQoiXtTlaLRni2GAJ7SUIAH7uLGMS70FxRhbBMipSAIJAIH7qETM2/G6lBCRPVEKIyFzHVtqGFKUmXO5HLfcwzuAh+HXFCULBS4fg22xmSAW5IIMuQSwbnNAv8UYYphGBwJOMp07qlEt5bYhAu0obV1+bg5DZmFelVfdz+/gyNI4YkCQY+Pb78VauzQwoOR8vcQsk1vL3mLLrgcTM7WAfb7NzxZzHCsgc84Em55t5jlwVb9JetFIFB4ucVbnqSDQnjVpai9vByTOt6QMY3HbZSf5W8I//VRo/X9r3z2in0M2tot5jloEvda7PGvzfCIwrncTp4mXlPj7eTi+OSuDbxmqOoQf9SL2smV+Eiyx1/4hCGhqukhRGEeMFDUEZ62Y1rRz/BiIjVto/jonKWQnYeIUPQ5Rm7xRmuV4tsZPFeUVdGdr5iflVOP9QkCinriaGMUCJTE0RkhBcmJDb38eyImKXlIeAvoQkeE8goceTv5gBix0k7eERs8TRWvDlnUDhix0BrSLy68H7CmGF+JT14FfgnMFTKqKTg78OulywOVcSHbOLz8fTTdZwJEQLUV6NKYkJ07XXCQcic03KL4hYLi3ngDwKju1RHFJ6n28aPb8eZ4/EE6xJXJ1NcILYRVF6CFmw3XMMX3tREMbD4fhlqE/m6l/jpv8kuCdeCO+KoNdiP4J4TyppJXMFo8jCaCDr33jdMD8BLGpNvH6a7RCOECbAeHKI/TbaNDtgKsB9PSOF2ulZbMdO5FAICjVv5p1BhA0jJuxbQn8/Egw7i7o/WEMXJO2NCAJY/jng39ipAFIVAYV9s7cYZI2cRbDRJ89uEzmr/zQJOqqzDkGs17o7oKREeAbNERjYxMsAsZOBsaXFM0TRc/X0fbHxekcBlCV/cJXIP+0AzAfGBrm2g23GiZjI4S7v+vwBtPw6s3GbCm++InjAbgIC+CGlLFVNvR1dZ6KpVTMMYeWR7z0uSVCX97hex4ioCx1uzo1qME7UQi0bCPtjDiKoDvwLCweHEIAYyEFOWG+njazecPgANAoF0LWgyR370IPRDAxhXukGTHg0Y7UGOFDqtj5VyUi3GFqN8YZQEtlX0edAjDFRQtuoEs6FKQiIwazaeXA9zJtyCKogX0BalxY4pFWlNT47yBh0oeR9NQ/LeWqwdoAtCsEg9XKhvTG5yAQmRagI9PpDcwBfZCPXEcQr1AtRcQASokl9G0XJyRAr0B7CtEmPM4iokAYnETZOd7gy6CYLMgD45cD7elcXnwb+PuGYWkx3EZM2dMkUO19SbLK5gp5I+4GQ0924MKjzVozK+DQmYxvSEOBY85qO3uGSgF8rtqJWiFh8YiCuEqoOowvpPXpBOqczSfrH8iF3aBvgzRF9qLoa8d0dMeQ9+4tGSm49EXzQUVtJTD7Slu4L1IwakgOthpBmmYeFrkwE2f46wLHwgYIuaXi4dWNwgj1IUAdCEukxCAuAzpOFx2GbgcR4t8bvogHkdNXHZZcNkBuFwL5zkuMxOXHRyXUTKOEW28MZb3w0qkFFqbeqCXvzahs5AbCxEih0DVoIucavJo8IpJQvkFtebmwbkKQcLwkeo0iC+sON5L2k/xBqObeC/3G73GrYjxblo6Vnv7pSDgvAdKrGILi9SNVxveQoOntfG/+CWfhV/6V24JFrEtaPMK13AEzEewDznxrhDoYV7IOxpImkx2aXrbdvJK/Nwc+LnNNNBuBk9QTWmbyl3Zb+JRwm7y88UcX4HO2jDeAdtovyAJMdihO7lOLJuIT0KuIXZ+MGqnGcrFhEKE2sUlL4PfBBwr6u63o7E0r5PAEiIRDeZjNFcbsDxSrPPVm4uxZBw4gWjn9zenhvbag7QO0SGGiLREucGPn4vWFTyqlnxOCgcAZAu2caNGm1lIGK3TQLojyYf1bQYVxwDnwAs6biLbY6fqyDOnP2TLpXkBGswrvYlitDBoDqdPMNxUibgIjWfiNp7Hc+ujkaZCDvdFPfx2II5EcZ0UJ8tHJ9LwXvZy7lHMUYHBXMOCFoMBFoFXGDQ5faKeRShJKPwHGuntp8u7kFTJeodcjg0mJBGOQEvomcYPGWcwQUsJyQylTJ70n1BEeAGEOG6EXABU2UQN9Ek0Pt61wZhN0TnBp9B7gadoGyfEB9UiOhgCAu/+Ys5WH4oRhzlb/n9PelDRwFZIDWqcxAB4Hi8u2P6ruKCaogLFoG3DfDpyiqpYnoyvfNihAE95wzajYTsKoAbFxLn3qnaTOtI25cj9p55YKCczeoI3afOeSJyhMmfY1dvPLDOrMrLfwCVhN7AmXrrh+yo0051bs3LMwXg8YoS4+f4vmsSTgioBIef3kZEjGd9X+PguOisIDGMfsEO+XeTbzXx0d4Y9BXgoO9FqB5cWZEOMs4DWTsuKP9NFKLTbKYJu8/0w9vm+2OdbLZ9vjf+cLnBHhGBUEdrh20jME1ea4g2O/Chc0WsoEK+DrE1wf40TOEKse33+vS+kkIEDb5tEDBB9XDGBj4IcQ3FkLbmIoSDLgT4ByKq4ubjCmRVHdyLsjotzKRK/zSiVx1ZBrQOkArEUUT/OXqGFGGdUzKLEqCicUbHxS6MZhWRyG5KkA89BbTGejb4lGBsYwPwSH+cmMU4bjnOTMU63HtBTVTe0gDc65opvuvGwZu52cjpvJGASr3ZygFedTtBIFRlo2apwjON5dFmbHX0QxTaHE6dPGs2n1C4IkGwRE+1i/uwky1skRcUgo1z6t6NLJkgHXE4E3DflRIX4FL4MbF5DMlQM2V2JSY24/zQm5sNuSiH2/yqF4HAtUgiLSSHMkELs8VKIIu7haED3jSAEY1OGjGVMVmJo8s6FYN5/oickC28SC8OGzqCyMSgcIooadhJaFBJaFC60KOTlxk+HQzbBvttpjwI5hAe/oVJoYkZCSchFMiu/DlfmExRrzida5XdmXJzCezmFd1koPHaf00tSF7S30JhenMboOkXVIYPuXhmwaJv8h43Ba5BjZPZ11kKegUXbUww4SBXzFF4ThK7m7Xj2P26zxk4KhZvm8uvcdCffC3mUtRs4UGzIN1F8XQOZqeN5IQffGh0mOjsMcqSTXPaP6IwzbgfRlqMzNGhBZ7uJzugIxdUecTSJb8YuYK4EOjtMdHZcHJ1JhI6hs/0f0dluQWfHBehs43hsg6RY9xaMtv8TRnPGohZG2/D+FiEhiaHhQJFhdFwMqe0xpDaEcUd3komtSG2/OFJzDia+RZ9oGJeR0I0JlRJfY4gc6Xwl+Pg6dnn5FaAKcq52/gnl2sUIoAEi1Xx+fHy2XN6Y3KbUkttIlrRz8dLkjKzobo9xH6byjXdBuUDQoSuvvMYeQdjagIIQWneJ2nsE2pCS/s9p2R68tD14cXtwXbA9ePn24Pqn7cEV021dZIfgCljuSeLisrQhErtqi8QUeplL2+INJkVpRh5LxsU6fNHZ/p/bQxhfdORXy/iiYxxdJGPR2cxFZ/uviw69zSyLTo4tOtlYdLYLFh3jewi7cA+x8xBvuNBkvtAYX2hOqM9YaIRE6SozxiI4FFTI/MMqk4lDlc11ZuNSFqwzObbOZGOdUYB5WYSkI0SxNOgT7QrrLVJA8xXDe8MXGePLhYlF5uIYTlyUx8BnUlr+Ez6Tp7+L8NltaPFNbPYQNnsQmxliMy9M2OzCiAvpXJ8qsNllYLOLsJlZsdllwWZXbWxm8djMLobNjK93m7lFmky4BZv/p+KcYzVXm6sOjszw8M+KcyVGwlTFYI8Mxbk9pji3mVonsmdS+PV3huM5P5LbR0dy1X7JaVxvjVwB2rIxHi8wJAPOhPjiQ+fK0dz9dTSPmUP+50DtpJj4ZOvlpyvXcoPMKjJg/A+qga9tifP3cq19NeQg/l4iN+OL8PeWAx1ix6B4/BECYoiE/L0ZBN6HPtFcq0GNysDfOwzGy2Hy9xIy7bLBtCOgzJTO7bFwEWHAw5AjriiKAujZbPL3dsHfw8RLRifi+XuZjPN78EN9cqb7F/5eIadkQHknoryEKM+/ocMGutIjnTcS4DdD0uACvOp0gkYqZkgkwhgMIeYJEomxptFahq89mXNEnLHiYhzggtg0ECsI1xPpCh7SIIlg1aONlS3rSLws+hZV4dKidBFhk1EMhR1GM2IhSSba9MBLiUz1qUWpmhgnj8ZauEAe5S1srd2CMaRElJyBKHJ0tSCo8q8IqvwHBJUvjqAc6AaCKhxBlThtufIveKrEIZ/y/wyeMqMvF8FT5T/iqRyHp4oVTyULnir/hKeKwFN2AZ56L4aBcUgiWdCVUFNg8cU+5NoePskMZ1e2kGUWz2EAZVdlvhuT/6RsEmURgYACxdFES3zLk8hNmO+KEs1eIjIYMm9UMBgMGQxiHmIMhnwxIRXvJrcwGA5iMGQUUh0FaBUBDAZSYwuDgeSPcxboMCygGC+nWvl6Bx+gwiVVibMbgI4muyEhl23jABRjkwQWM+I4ZOI4ZM5xyFxYdRDH4TDFVYYch4wcB92iSOXQkY9zHKQpobvVFOpB7TZ9omnicnBlMP7WJjpksukSZ98J+i6hKuZqV3T50ItUKUPoYb3emxm/kEBjeqAwUeBEDcEBit/IQ3cA2LPpTKBH3CGGXoSXx9B3gf08hkSIh/rAu8TIqFHCy50Yv2NmOdpfSf9a5AVexMagqhKP5CgSVqHcDkLmbLnUhrFOeLkCxjFXuPeXjduD28WGjMd8vKTUiSHIJ/GSMi8pX6yk3IkhKj7KSyq8pHKxkkonpnDvNIX7s9m4KxkJuDK+xDcg5YpDWmDdR6OrjVDs4XEbPYzC2QhwlLO3kEncpydXe5nrDyjAPb/JXLAtwFSQJZZZHkPJoH7TTJMxWSCWRukQ/jHTKq9V5TG3+yNrh4weqlmDggNwEbhjjQjzKG6vx4vYjCJ0Vxqj6PZUxGYWkY0ilzF2DaN7oXnTMh5n4oSNNm40VnS1VyzUCsxrgsIkWfGKBkKOTvyyJEBEnCUb6QNwZhU+XzacLzSTkyiaIA/Sgz8y9/wDltMFgr+ePq6Ai8xk6+Pih9mY5Ypl0VXZvot+hfFhxGl3/Fd0nbLEpxQm+AbuiUZ4id3A3tlxYzCGg+BQOFISVP6964FCGvnFuh7ATgQu2vX4r+K6bv0qvutJF3RdFnhtnQmFrzwbv2zt37qeXkhTdbGup2MnXBftevxXcV23fhXf9eQLuo6xJzl2BQxUFKQDB8OkdkwiJGf29szOEdV/DfPzcomdWGL8GuRVxdYGY+2ZacTKlwgvElsbjLVjZhAuvkR4kf+xNhTiIznUeZeBPHr/lGWlSJpkOFQCAIgMImuHMyKSutLLyJT5D18mPBuxzijoNAsqFBXdeO+m98hK5CHlQoUhwLpGGq1PnjLNlR+SuKgo4+HURMqX6Ws+XfS1wvck+kHmcYLIlvVCs2A9s2A6/0nlPwH+A6IdTKzxWb75NNR8GmRURTDX0wtCdmQGVLqq4/UuGNYoMAnPb1F7L5HRrqO9IvZV8RQwn1zmk4pYJSNphO2ck0bm3WNTpEmScJtYF5K6qDNeQkamxgk8CzAnFTVKLyHZQaIY4fFSAcKxa3qbrn3+DP6uGbFmR3UIJ8aseHErxNiRBtNdU/M3vwAZqsnORUP/00ov2nngvwiK3sZ/Xd2/nfd/f60MFc94WxpbWdVLC0e6XjNv6LuZU5ZH4bFv1xkJfdd/jG8fHXlcSf58H72lP5sxWpdR0ZQFl761ec07UNHd0tyMfMdPWG7rrLuf/bEly4bHG9rMatC8k1IRtgTnLouoLGwJeamyJZYArCGmmv/93++nUdH/UT/RVG2ZGbbqnZ/KaaLMWUEVNEAijD0Od3Xel3rlJS/OLw+X0lGWKHUUSq2jq3NHTY2i/iuMIT+VMHxpfJFFYa/sEcywh8uottLSUrOCMN25tRSXWxd2ewalvAskSZlogSBOsGwBolIasphN26DuUjy1wP+6lqRtrxeW/ugc6Tr+1vV18tffgbC4kWD2AsIMyhC20FPXfR1mfHj0jxXrIl03vbVq3fMng52h9Ou3PVvce9KCD8PkvKlKkdJw2Ls5aPMUyROTi2xmrFlbXshuGsA7iEfS04fjZTkY8ft6POMYil4DeJaokty0C2PLEsUWV9x4cS2RYblL9eZhQGjUIznRut1v0DMnyCroSaAqeVjHEaqDXCQqZFIUoeH9hbehMR4H1Idn4UnGbQWkslkdc+WAAkl6EeVRBom7sOITjWvW8RYrHss3AeNdgHxLZ/9Ya9DnVf2GbOir5X9NbiMYIEKvNMZMzVKnuacCdQAPJ4fmkhseuh1iVAeAHEXRglEnEcWnO6eVQv5tLhA/uilKxnsYaNOQLmgZAxLFgwEV5WoCGjGSmwLat1OQSB5zuJXwQKFUIBzG+ALYjsylYgfdbyyb9+ml8G3Gaboq06B8GDXWmWe4j0I9NGAeq4Q7zgi3fB+/Hsyn+kUYrNhQUzFqzphgmn6Z6s4L1tHb4k9duvwImqlUYPwTc+kWXGgSw4bV46/xbX3xCB3PgMdRGO7erQ/BcPceBBaZ+pMPn0x2+gHhQ4lx9Cm2Gt2Q4DS8XHtQZHqZTyT00K82UAXCOXlL3McQHW8NEt45Ekqs5ZqV+AoPIsNdsxJENLrVIQNPR61HUIUCtT4L1PoMpM4EUpgSueKzlwif/b/RMjJoCbS38laDAcNBQmCJ34IeeHNGHsrZjfjilQvFTVr/o6vOWJtOL4cvmVnxuIr/pdfxNYjLfGVaOeIqQ+q7iACsJgdOk8GY0a8KLfKseFQr/qmNxrE2GuM1U41Xl/JLF2UjDgPgk0r4ZMVY1GaQKhjoTt2x8FO3UJymOtQ6Y4NBeN04l8ctSPZLtT5Gz666UMirBtHtCzFSl+GbgLklDCblVtCIFJnSzVR2cbwOodebzoPzw4vu1L9JHN/9ApcFIeVhQZ2kiwkmcPsLNAcrLnbhpWt+9LFJIIEWr5nII40IIgny9qEUy7cO04WTf+ygj0WvUnB68kRMMq/hQtcIoyLlhvzCIZi8qAkPKFhSKIFOa3jtTmu/nHjNglF1Ah4HmVXj/SZ+0iwpqGSCZMMEWWKyF19JiKa1JspJO4EqjybdX2O6JAXgjiZfsS03AJNOU+AgtLBc1sBxqpSwzMxgQqkB2xtGvoGfPNIpcw8uIDIJlJmWy3l04JqR2mTwAEN8YrCQmBxViFGGzGQISKqjAP7EFmUC0kR0QoRR+YXJNR221Icsqtio0MG/msh3O+Hr5OWD4xPAY1pRAX5rmw9FPR/fvNwcZ8wq8Du6oj4diTz1W1xFcmE5jOukqD7u4u+nQLR8L1Ho7qfCXMOF2ZUbv5nS5v1/bfvz/z+0/aVedPtL+R97nwj06VMTKOxAQtDHL0enuA3psM3VIkej9MHdBB35bwRUjpEm+QICKq/+PyOf/P4jg7Bc5Kv4VpMxHJ8FZUjB6jX9P2MLxc1HKy6s5YFNze3WhJu1KrpCuSPdrluEU2OBBl9tPtIFGiFR8TvUBGIAP8R1umsckYzmPx6WhJe8csQMjFTKlxh/h2Iq4cIoxIVEa7sUk0osF+EhaTeutsLR4EpR5ZA/zxppCV0rZd1QA8v6yreMu7eTVDmGP3g39s2kGCbiCPt/LxgZBbN2mFerhiXYmmNIloRdxUi4BCI/hczx1nI7U20JNkmWmcPiMtqEB5OwceAmiYp5aCJcJOhlKeaJvHgD5lRRwSQqyANnh5oSX8JvsEhUmwKxJJfKpCCp9JLMWXKIvRlrIKaN6BGtyVAzGjV3Gb0E8RWqbGrw5DA/l6iJvFaMbdFMbcoTYtE2Jf5kEk69dIOYGpkPTuJenWafES9iQyWmMNaJptSw4Z0NrTY1WhUYkUgNcRwjLZPZziREwiTUkjj8sgXMZN75D+KCAeFc/MwZlwvQdsSgzfFLrpVPZK0Ixxeg7nMqNqEWTffxLUaERHdYJmAonwD8iK6DDBOsxYNLPJj19uf1TjTqldTAUozUgzcL+Wz/fzBI9BUOS5wTkOj8SoRj8eHGzhmtIrGh+3BDF4sKtUiyCBgbILWVaH2U8TChdjfwC9qCbAaLTWHyZHOHRnjJHF68VvNTTjkIRWuPwMUNKi8K6yaxHb6JqK1JjAyatTmN4VE0at+FcG7yv+HcxICzA+Hs0O38vluCLm3dQYoVGOAhUJugy7iEuSskHILEhyQyl1py4dmF41tpXNUIvJxztPdFD95kNQnjnEhxFw7IsdC/3ABnXUhBXV7IZmjz7Pof+9YV27gFVE2NNlr/c2PT7uT0atf/ens2ZSFH0oXdzoOyA0CzUZkUDYdY18sHPlh/wKpd68IhB+8uIGhp7C10FyMzo62d5UvN8uW1F/3yWvqyCL6k45ULGndXxKqovGjjlbxxmaqwfplt+fKijVfyxicFuf07gGHtnFMGGOx6+Z9fcHAheLYX27r75do9bFs08ctk6uG2RQtfmp9wtFYPzbfYjmIFD32Zbfny2ot+yXv4KB+bHWbsEPZDuhik6lkgVX1RSFXzfthqQ6qeBVLVF4VUNe/HRIIU9OOPjYdmAmgIfVGDOXXrx8Pb9jtk6oI7XGfEHu+wMUy3LHFEioRBQHGYcx8JuUpDFMfCrqeOC7kBa7tchfrnxNF5elJPEavQUYtrc7zCXd0410ZoQ0Hs0R8KSvYXVbPSkAdejBmlXDqrXtk1Ecj2lKqstNRolALsWFu8AmOFeIiRxCASPBw6/xhrw+rX91KbLZ36SMcI3pcVV5uXOsBKVVcpX9mEQ6hAd/YSdxwwMVh4Rmhyjz0uBXSp4X+cU0kfC39WrmfToiFWa+ys1tjxtGI1TlhAmN05Sk3+O/Lfv0bL2drfdlRUXqdJVwfQLQ9ukp7RntuFN7rI/BZspLZuHmiGPHworIv1Sy//iLwJUsfpx8bzi5x0KfANcdI2IqjcY7VLUV8OMkEZIce1lECm2vK47SfB0MgjWilbI78vRRW05WghElGVrhM/+/SeTl/+eG2k6/FnW8366cd7PuSHBV0f/futO39o+FHnSNfPBqyvF5ZaotL5xXOBpKSkyRrIU+TbHSEDTpm79KCKvBfX5EfD/MiAYsVLMTU3HnJFSiOqVKrajbJaJFzqPSdZrzyzhsgguh1/AvPnxuU1eHASi3mCZ/TPr18qjk9MEAcOcD87jnlyDPMQ78RrY29QpcC31Lgy2jiRlkTQLpdZj/UlzNJ3+HopvJcvKLyUqr+w9AUmibtkBfcuyXrYFJKNwSpmny1nB2VowaI3QvuYvNXhRH7MWFPzKgFFJKKn6GjJ+EzNhgnpOuzr1CkfjKgGiMf0YzRJhBTo5gD/dX2tDkv+/Ni5DyNdDw0d3GR+ZDzOfO96X3x9a8vn8DHl/QbDHv2EDm6GUoUVWli1Gf91VQdEulz37C74PFC/Qejj+4N42JOYt3dTaFchPn6ws13fG19YiY/uA1998tD4L7V/O2yiOwZxRN/RxhMDA6Bf4CDXzKC981I0jsHzFu9WO134RtYtn5qIUvzHvo2aKi2J3QYfklXzv66a8ylPh+iAKKyDJ5++u13LCHbqRGbnaxcPLMeRHlJvLd7Wbx++PbVxzZ/Ze77Atze9s+B1NvcrfNth7G8frrl7YDSsWqttmHb1nX1mz4BNoME3t+Zt+Hk2Fm189cDD/S+pwMeXji778r6Bb+PjlSOPL6i+/nt8bPLDyfTBndfGw6XUegInqVKkDDgsaYkI4cj0E+89w7dmOa4HDy4tPHm66g0Y2MLrez5R1aM+np61fqPnybLMe/ExVRl1Z3DXw/g4NPNEsF6rafg4uv6sz/wtHsHH4OHc23xXD8DHx8eNWvf+i1dmh3HBxbVy34alW6rCTSoiXU/vOXRnzm198GDu7Vd3HL8vZQg+Dg5lTnvrxkH4OLds+yFP2974eMnhlbqtUTN87D/mg0N1rqJTvqsH+fsnXzUtGuZULW4wbUZ3OTiqHTQz8PCyw4UrHsVe/XTNdzvrnS7Dx9ymc4aurlmBj+m3Ppd+XF6Mj55lGaE37ivEx5JbG14y+47OtUfQVetw4JmbO0yCihfcfWnuAFsJ9inz9NiUGSem4uPinzdfd38q9f+eJf36ujdcjo/fPrZh1AcLj2Knrx95pKPoNCxw6wki0DrgX8NI+2QgupYZDfPAUOLNwSg/VTTuqJTKMPiWtBTJegZMtzcltpxZIPADWTFb340S7w7LNqQo8kS0HzAYX8nY0oG2rJ6Qq2sYwEAmImVZakBWPgZiI4lwEjNdvaziHC4wsRNPuJUYLqBTGPRUjS1LTo4k2q10FjiEPcJ7XgI/Gk+tlOq3KPJyBJ/PvUXXn4TRprwU71lvpcx4m8ZPz8X8mYXp0JZoVATtFUAcoBx8CuMTwZcyFpsZJSLDDsN/SbcV6tU0/Mq3Dd0MVBsO0j0l9KoF0uoubaZPJFmPIi6oDtgXDvOuq44oesRDQzTJNu8y3FARCgQV19Qu7DacMQNG57InRtFbAI+cDSAWRQR8RJlqTZRBx0/kOA04ct7EErYbrVagYGnY8pbuoAnHKBodNZvX3Ea8P8t2NGSgW+En/SMm9Kq9kxIK0OzWQgAlDgHkf0UA5MRj025++M7W7D7xmIGGpF2k6UbFcycX3ZERJE89mMKVb4sgAWEEEHCWBvsisGC/Odm7xGQrPGOrmVEhMuj1GoFbVoywxzCC4wPiAN6YZSAFxwfZxIejMXwQ00vxRrxL/h0fJsTQgWwG/t/EhN/tZNLCL0K1CsS1jFv+2DV3ik1wSA9iTAecybstV8Eju9C1quMff3e5dHr2oG4WdqsScRsQYuOB/X8DH4YGlm9t3mDwJBwhqHAlfAuEPqigkqXruKyHrq7qeOzaIPnHm/ka5hfF8tfFBAPW9e8prXJ6pP1milaVwBS9GA4ptVh7pbYqW14dUswGI0FycTE7FOGziHwsoFkp/Cv2H2TBDimcKsrELVnsNuzxdjptNrpHrD4/C5ifjrf9NH3bp7vQ+GL11688X29nKm4Tj/X9G3jpe3BnP4OsdFJp1LrJWy7fxbg7kdKQvdR60zO8KYvx3OSoFMFlQUwcUtAINx0x3PVJKwvsrCxRxxWL2U7shmVuCizSu6IcdJZBho2vWAXnFpVSbkFjWfJICJy5r3e5anqUGDZZ78ixyGwSR2f5CrAF/Y0iCF5X94wY5gJJqMHTPl6XiMyvp8SxfvZSqjkcNGJ9oZlOrB1CfqibW978IivKJLyvGuWIGuMPmwrsnxT/AlkCpU9GyBYlkcuGhBKoQ00iRRkhMzjljoyQHEWeS7XdQjdUEPRkKuoQxJC/c6C/8Hp+MbRY7eTn+re3l2VBt02NIMWxpIznlXkkdcdIMx6BlNusXP3KPOvHmIpVhAc+TuITQy7O37sN1JUZC4M064G0pzQc8nCqildlh8VvRHUDPcGvLeVpHFAeRHasFmsLi98ISPhh/LNMAL2uOVs15hXmwMZ4fUzI/CDFeI/ZgFFxiM2JEyNBDGdmT+Qzs2yDdIeV/EXD3NxMpLFbMnDcpcjLE7VfvJE2jAhnKYRk44jgGTDdewxFjmykPcCBz5X8me8lG829BJ9gNKLQVkuhCrPQmvhCKy2FVpiFwmYhhrfFKvTLeRVOsg28kLq0BQxy6SXFk3L1ZcWTDKppwU/aTkCOPFFrSy0+V8NuFX5XLiBW5Ejp0qvRihP+6UFOr4GfxVcm4l0XWWdUUDlxIlnjm3tw9sSQu8tVj7+0OsShtIHG5u7SBvcKNhp2TujquY3GrhnCa9GrjSRG0Df3vKmPRjFvr8grhcQ5MwE4FcY9T5jDof0awa/EhN+MjZbNu9h8fW4DgRWpB/KTG2ITeoQ/4ymSwlGSI2TE7ZAmkUkt/HVPhKUf4otWIVbIpm8Yn8upDUdFB2U69cmjcvUpo3ggTrzismbSDfwCThl4FgBS0URjikb2iY/C6jCnRwNeSXXf4ufGCg780MwchejtJgNWTPXhHsoSklSzTDXOb0yVT4sa2tdgMqQxccX6dM/gtAcZqviuEYwp8p6Dq5I8S2Gly4FqUnpI3TMwTKyMWbIlfGtZolfcPM6/woHzT0J463IMrZwIRjyZsWJsEAOFS9315EKK3i3AFwclm/6hE5mFeGiRyF8c6AWvJxuv+3S3MpQxDpLHKbditXXNWDDc4TV4s2wQzCi0B2Wv/OyrOYDwsgVnxfy4JppyHIDKxH6MeqCvOSSwOOSLxFMnQlXMDfkjoQQ6i+ZrKUDI+gMhqF3feshcPniVpg/YSSDHkVByGFeFB6/8SYQZ8gGfl6wmqH5cIn5AearlnFHLLrMWFc+aPYTztKKgcQ8Rc8FJHzIWz4pDljUVNl8vPiTWFF+C5vsZ4n04lAA9W2fAzwO9EcuEVpDdFCZoorc6LRMdjWGUCxAUskGwIEsZinMcw0mXOamumOSgektxR0oAEBHTi4OEFRDGs3AhTFpESYQd7TAWUZJZREl/2JAl+SZ2cVlS+idZ0gNjNiUH54WypNMiSwL2vz6R5ElZ6OPJvS9wSoxMjqLPMTQWpouQvX1RBzqJ38qhMouYRgpAXSZT9Xdc/NpTkJngGRml6SEF1rpqbBB0+SikbsngHlbbJK4O+78npYakOOlkSbx4YpYsLi6aGlUvNvExMXJgRsgexliMhhSDdhyIt7AjhphVQ55RW4x5QzIuDyh29bQse+AmiWWTAGC9yZd58oTcoGRIFGYRyDhfl/7plQFkHYsgjKD09Zba+itGbWtG3US1fewUReOK4HXgQ+mfGzL0BYkUdBxfGpwwCOCWGzf/o1Kbyxu1NdlA7rj6mF1cl83+sy7bVEQz30VU3CxOlR1TcbM4Zbah4mZxumzmXaUouMkqE2sft56jUeorVjxVo/SiO7TjLO4ZmsvjCUfIkVEqzOwnZ+E+t1SFN2E6Pmk8LmiLqSIkr+EqALwdsLhdB9Jpwmcanmm5kNVDhlf813XM7f2/3j72FxDLXlzQPjxjUioKYFLO6dP7u16Hj5nKHR+Hhg/Hx/afO6adGfQUPj78N4po67UwVBera9/D0cJRLf/sHOl69KXqKxLXJGPRoYG59X+7pC0+pk2t/Hvr13fi48JpI47+cMkUfPxbfyfjg9JXNTLAl+gvsE1hsqPHUK4SeYnmrQ7Rxd/YEPBbUKgMGG5IhEtD7qV4PRzf3y1XlVVHVXcZ0rKYzhEP3dyxpBuP5JCkuS2SJvUALbvc3uf+D5G0+CJIeuZ/IWkMOVF7bSAURVkwPq6FVN6KiRJeIetdM3HYiEE5E9iInAEFOWMKWeGAUf0Gjhw7Ap5yCoaLx1EFIwcPy88xUvkDBuYMz4Gn4cP7jcop6Dd2xLBCNj5n2JChhWxkQeHQkf2G8kTOhAEDC9ng/AHw0bAJOfljqPjw4WqzIa3hbyc1Z8KonIGFOYPUUSPHDCscNi5HHTF2+IM5BWPYgEJ1+MgxhWqzQerwAdCVYQPyL/5SHTlYvfyK9mrBsBFDxrARI9XhOcNHFjykDh5ZoA5QB+WMGTZkRE4Blmr2sPrgQ4U5FxYSw4srA28fKhgwfNggddgYtQDGPai1On4YjG1sISQLBxQOGzlCha9zhxVCR9iYwpxRzHjPcIwsZ9CQHPwdRP/kjCoc2g/6MnwAJmM9KBypDh5WCJ3IyykYkZMfnzM8Z8CYsQU5sdzCoTlmb4eOzB80RoXy+QhrddgIdcCIh9SBQweMwJLDRw6CfwcBhNiQscMG5fTLY+OHDSoc2lrlcwMwhCkYZJmCy7FFgGzOgIFDWZthIwazZmNgknD8I0YWmjPEeFfo24IBg4aNHcMn9N/KISpRg4Bd9Ct6ic2JzwYPAySK+2jk4MFjcgqh8nubDbofizUbco0KWAegaasOHwto8GCO2ra1OiA/3/iaQxmHzgYPgH8Kcgbnw+AGjBiYw6ApjoM0jdgydGaMOmboyPHqgwNGDBrTSR06IH+wCqtgZP5YnMbWZiGYZ4I8xwjGhy06DyMfPvwa0YPW0DWA4uU5HaFfIyB/xMACmENATUAreN2mowo4nA+vCk3AxwEKW4N68Vv8gbmHCR41YFjBNQIeY9Q2Eyib/5szeuyAfJWvvTGxKs1VTLUOAEwdNEgsrVghmt5OOACc+CGxjDGFBYAxNLhB18CIYPiAkTmxArxqkW8OCHHnoiVMzLqwe6IEdK+1eiUv1hrbu+n2frfffnu/rt1uvr1b7DuBb6MmGOgw4MGR4zgSCMoAkI8V7zFg7Jgxw2D08SjXSTXWIdGh8WI9QHU0QXz+CLrGZFrGZallkFGDBc3+YzW39RuE1KYAcO/C5YBV1EKnK9vGvh1QUDhsTOHFBoQ03OgTfzM49oIyLWOlAmMuBsF2kDCgAp3kXaBZwaVm6UkzGkQcZW8NJHVcv0E5QwpycsbQ4K0bAiE0IDGsY9wZ8h9SR44gPBuRkzPIuhJgKY4xVl9rjnyFMFxahWOGwtIuaD5GtSK5sUVZKAou82G1PoGC+Tnj4giPpdioYQMLgdzycrXIl9lSre8EbtdaxBeUjl+CgwtGDje/FMTxIv3hdY5pjqUGAuXLKbj38vthhx02ZNgIfBLv2prv8GksLaqb+954Ixs5CsnYGDMt6jPTHCxtOgu6FstoVvsbnHxzK43/3EyOG5A/NsdMxTbeAnPHiitpUHVrK7QfwQTRLkoF4GvzRb8BE4aNMT57MOehkYBdgK3MinGxfUjAMRNQ+/IObVuwEQNGMIa7Gv652cbYNfA3xw4JyebyBeo2vEy/Z8xTBtfFrsqmn+I7smX23/4o7P/Kn10av2nqS+1K+vOD+D2uXbx8pWb7j+1gvk38dcDfqb9HWNebR7C/WqSx3Xc2Z99cdZY9+HUFy1ryJNNLrmMDb/2brf32VbZ6wGbWaURTtuemLqyXo5K5j13KGizYzY43/Ju1eKsBO9L5JXb26ims69pL2bNHp7FVl4xi+qR+7PP5HdntUzuyZ890ZLP7TWOZv69j5xpfw76teZolLrazpMuqmOee2Wx44+Hs00ntmHt7c9a992r2/GCNtTnWj33QfCz78fhH7NpHTrHfOjrZgttmsT/zjrHGb/VjrvvnsrbKHeyRv7qz6lfzmFr+KWt3Zin74eWG7IEB85kr4yf22JIcFk7tx+ZmD2XF+2tY8zE3MYfjcrbtjjT28Yox7JGD/VnenApWb1MP9smQjcx95AC7e2pLNnvcJvZig6dY1ze/YfXu3M1e6GxndmcNu3KSxjZccYQt7v0tW/voFeySazeyRnlVbNm5B9jVjTuxotPb2KnHG7KJJUGW23Qi+2zEH6xtm/Es7Zrr2LupW9jGes+x1zdtYK1v0pmP3c+mP9qd/TC6DXtmy1J25YOMrdozka166WnWvu9n7IvOv7KyQDq7adxfbNBzLdmoL15lAyeeYw+vvJPVTTvMKnrdwa75/Ev20rQOrGmT7ezzWePZPX2aMNb4fXbKk8Hq7fyOLbu8hg1ulMuW3DmAvfZnDzapaD8L5axmVxyZyX6K9mdVmz5h+e3c7H5tH6vz7Rfsrmu+Zd8+s4DtCWWyzOlH2MG7bmJbtl3BXD/UYZWPbmd1K25hvzR8iaVX3ssuTbmKTU1+kE3tKbGzT9zLXl9ZxBodPc16Xn8dCwzZy175Zj97o18XljtgJ/NkLmd7l6xijhdPs/vGF7GyDVPZgKwZbNaYCezNOfewkV+sY21eHMjORLezuZOr2CXrh7C+27qxbV+2Y5kr9rANA+ay5I/HM9slqSy5+zNs092b2NbNXdlNb89nrO4vbN91r7MWvX5k5z8LMPbhX6zRoh1s1M6TLKXzWXbiVDF75/BG9tG5TLbQvoitH92ZXep+h3m7/cJmJD/LXlUfYZe+u4z1WLCBPXLFZczXdzgreKmE5R1uzC7f/hR7qM71TH/oIDvz3Ux2ZNHT7OBP09iSy59mM37OY/36tWNrzyewnktXsSHL89nogi5s7v1XsGVpa1j5j2429/Jm7LfCjqytvQHz+yR2g2soa33yLtbjlRJWeFhm6z5vyn579EU2omcBW1anij2x6EW2av6vbPftt7JPPaeZuvhKdvaGSextYLu/6dyPZd+vsMdmFrG+t7Vg7QdVsOH7A+yKnlewe28cy24evY916zOCed3rWcuzw1jq4M9Yc+dz7H7bLWzVNV+zY+M2s8d/r8t65T3KGjb/gD01rAXbsuM19npqH1ZyMJfN+HIma11wC7Mt/5CNdy5iv7Qdxdhfzdmx0SvY4A292KDKa9nT30xlZdrT7LpF55l/+hx2uf4tW9DxOfbNqDms7urDzPXdNSytfSt2X3GY3VO8kAWSFrDEI/tZfvGb7OuaG1iHkkR2d/o49uALaWzA9rXso5nvs0D2OrbntI31GtucHX/vV/Z1aC3zpL7CZl5yGRs0dRxzX3MlS1hUn93a6RXWsGwDe/PnN9h9lySz4RtuYm0efpZV3PE0U7SpzF39K2uVPYcNv3wJ67jKyXxqGtu/8V52dsEmtuX1G9jN215gL7X/hP30cjv26oJF7JsuQ1m9gd+ycXOq2NDZt7G/vm7P3ih9lX2XdjmDB+b78ys26KbB7Gf7atYipy27844o61HTieX+/j4b++EvLHPhd+zV4rZs8JxfmW17Gvsj5GBfHmrIrn1nObszYx5r94mb3dzlKEv5cDm7ssm7rPqV+qx3zgq2Z/0LzKslsnsnfMKa/D6OPTLbxmbWLWBbXrydjRxxkFUdZ+yZ6+9im75azV4Z/AEb9+mnbLfckL11qg2bs2Q92/j6eDa951fst/vDbEvxGfZa9WXsmxNLmXZfOdv17XBW8lFj1vLr91hZs06MvbmUvX77QvbenTbWos0qdkPxJPaV8yU27pUE9sjdpaxOckt2YHUb9seP59nMr/9mMz88zw6Ny2eOl/9inYtHscdGpLHzj9ewzM5ONmDIlaxl+nR207pjsJ7eZPOGj2BPDunILo/ey6Z90ZO1/a4O+6jNdazZgKvZx6N2srbb17Bo/nm2nEWYPf8Qu+ebMAuO7MEeTN7D3r9vGhs1oBfLu6OSLblNYrf0bc8afbaaXXlqE0sZ0Y/d3/YQe+zSl1nDtzey0ivaMdfq5ezYW0CjfguyecMOseY145lPKQa63ob1/iTM1BeWsHcie9ll93vYqt+7sKSvtrNHP9zFnvl6PXu17jq2LTKZuXLvY5f2rcuas76sKLWafe+czlK9g9hT+lz2+Iffsq/Ot2R5zd5jj8y8itl/+Zu9H32eDc3tza5vuYL13nQPa3OunH1xz2J25qMnmf+muUzt9CJbfmc/lqq9xYo7PMl2qBIb/c109vG377Fo/7PsppwkJjnz2JyVr7G3K3axW/v2ZI3+TGBPFmxkZY5rWEX21cxx4BFW2W0Hu7nFH+zzbVvZkV90NnHQt+yZQfvZlx9ezpY/vZGNv2sfG/bDZlb9VQr7oFMW657enfUd24/tWXeWjViwhb126f0soevPrEHnLmzApsdZi/NH2eHPf2GhidvYyPlXM1flZlbzxVw2IvcgW3l+C1voWs8m3l/I8l5/m30y4jnWueARtiUpl/326cusxZjv2Lsff8BWs1vZwbf9rPCDpuzHR/uzwv2zmD+tNZuc7mOTBi9iUos6bNnD49j58x+yO7pVsS9h7z7xZQqb/cH7bNPTf7HLVzRnp0ZsZIs2t2P7V9zBVq14l326I4Elz2zDRt55FWt9x0y2ZOcP7HP1fZb3wCusc8tnWVK/Hey893r2/Zk/2RPXDGcHp7dmR/dNY3+teplVndzNLr36Y3ZZxwGsQ7Ary/hyK5v8l4f9eX0uu6zBfnb7qmns5iVzWJ/QDtay7wFWseVz5q33FKs/ag0b9uQgdsk9/Zl220lWlJTIzrybxP7afpZdVd4G/p5kR+7fwb55oD8b8sQzbMGVVezjumvYgLueYd/fWc5unbqF7e8cYN+M7snaNPiGvZleyoKtu7O7f/mCffnwYvZ8nwrWe/of7A7HX+zHh95gM0PtWIfXQ2zIwgOs75FX2JRLOrBth59ht/qXsyVXvsVe/iKBDbP3ZDlvV7OiGS+xGTc+zX7f3Y4FF7zDHplyPVv8aZBlLzvADvToy74v7MSGHO/C/n7uO/bAvn7skSHL2QevPcz6/hphrWY0YfoHfdndI1ws2HI669hjKpv5w0/sx+f3sV5/ZrOaO46yBonb2Oa7Z7FFf7Rie9dvZombP2Vf3/MG67F5OnvsugdZcPo1rPVDi1hgwOOs5Y2PsOLW9dl10WQ245ISNiFrJlux6RD78etH2KZOG9glZ46x34YADiyIspyyVuzahW+xdRO9bPmtB1jzbwayYd9/w5YuqsdWtHiSDd2Zydw/r2Jdl6ns5sXb2KgpA9mkiU1Y4vtXsJfOPsFS7zjMgqdc7F3gaUZOuom9UO9W9u7vr7Ip333OnvpmAKvTToY2l7GpkVJW8PNw1nHuw2zKmpdZ3hX3se7N7wX2+2e2h41nf53py6S7b2KVo4utLG42evzgQ5uuhZ2RS1/c/VwWHiDcumPCNZiemlHdEcupzR7ugOnQlB/aYfmGvwy7mts5Dck2HEgYQ7urcdFO1zxfvvQ337p151Ez+52W1Ydb0s9vVfdTjAlTd9fyIWimz7/b2oXba/2kNd00pWZddKf27hnfF66817Qdt3Tf8+rbU7VpnW5+pvKLvrX4+WptRHRG/d7XPJN19ZV/vnztr1Xa/Qf2P5vSf3T5gOLxnZeeqNJ2D3488PADJeWPFY04kvZDlZby65Crb9szJ6vwsbS9K7+s0v544vcmxTtnl3/76zct8nZVaQO2/jTg5t/6Z219Zmx6t4+qtCV7r7z3UFlJ1tRftmzr/GGVNvyRqfe/uPTprMSZv+ff9W6V9lfV+QX1330i67ceBa0WvAbtPXvZqGs/7JwV2b33ihNlVZp3RMnMq5Tc8oy9f785+JkqLWHdZS1vu+PJ8lvvTd4lLazS+h67eU5V8S3lOy7Pr1g3q0qrc+az95t8PL+8ss3LbyydUqW92fe+oz/sLc669YkXti5+uErrufCFY2kZxeWP3Ppo1pqCKu3aK77tW914XvmxuXM6/J5bpUVvT9HmzJydNXb7yOP3DqzSLjmeNO7ZL58q33efbVrlvVVa/8s6df7txNKsV94fevnjfaq05zpM3z7l8Lzyhl/+Fbrlpipt7sYXu+ojZ2V9PufBGdd0r9IetR1aaX+4OOupA4/O76VVaYtWrPjh/BNPZXV4cOyIhztAfs/C0+kPPJ6lvfh2752XV2mnDzde3KpHcdY3Ew/mdGtVpT3gGq09suap8skDz37/XdMq7fJX3cO//21K1vffNj77XCOAf3Rk/WeC15aXfPnVrqL0Km2Vx1cwpf3sLK9y6MXHkqu0edt3zlyQOiLrjss6v/ymr0p779WVN429aWpW2urLPX87qrQbC187KHWZnnX5/hv/GiVVadef23t/x2/mZdXUGfS266+Tmu3eJ64pLptefmrZgn6bfz2pDb3lhh0/X7+gfPvLndq/dOqk9kSbWzPOOZeUD95vH/7GiZPannaLOh/ZPbr8t2U/XvX14ZNaWsbOd+rVW1L+44qUjW1+OKkNv7HlSz2XPZYVuir5xhe/PanNGpb5cP/kheUNil+zdfvqpHbvzLo95710V3nLS38Lej4/qWUs7TXkmdYTy59eccuXZ3ef1JJe29D/54HXZbWZOaC/a+dJrWqQ4xr34Key7mQNf9a3ndQeUkq/+n7HiKxdWevfjWw5qbVNTtSeqFmY9e3eL6pbbjyprXzz4bU7S8ZlNW/Z7rOvoie18ZV9jq9ruDDL/835JW+Xw3jKRrOrFs0rf6n1c+Pefv+k1qts4YEd3z5e3mXwp5Gv3jup9euQuG7LtxPKp/R+7o5Wq05qv973yInuydPLExfcv235W/D9F+fT7VcvzPqq+bvterx5UrM/M+uy1YsfyTr/0dP7kl8/qbn7NDj4/cCSrBZ9en7jfPWkdmxLvVse++iqrNXd7551ycsntasrBrX66YpFWT2Dr6eNfOmktmzckgHXH5pT7j4w7v3vXziprbip6prNV84pf6xvp5WTlp/U3jjaauaE26eVqxt3XNW97KR21113TPhm58LyZqG+UzpETmqD6k0qfiVwZ9aYl2/c17f0pJYZeiBa9c7C8k+uKRr8fPikNuX9qx5/PTm3PPqVd2wypE++PHxN1ZCB5ZfVz8l6e9lJ7dYZlX2uPVBcPm3Rrb8/CulPO98zaVDjCeWF/U4cGQvplY/Orrj+5PTywskv9FwK6Vk/9W10Rb3p5R8P6XLHcUjv3ed+YPuzJVna/d/2Hgb1N3zhpvcPXPFI+ePS8TGp0J+8iiF9zp9YlHXF+rbSz5Dum//5q98fz8l68OZP2/0C/e/y6TuXbS6dUZ5cv3Of5jDeq9pfc+q9YQvLU3beuGQmwKNRTb1O0x4oLn/9oybd6wO8RtxZsP+WfYvKf17Q9ZkvV5zU2KyEe4e8XpK1ZPCsLz965aS26lj1+stWz836Otyyy4+vndRqDm9+tv97OeVzur5b5wqYr679frl76q+PZLUbn7bkDZjPqdc2eqmxe2H5lpr53nthvls0yp+95uX7y3/c/MnK9qtPane/XzLx9yb55Ym3bd3e9YOT2iu/nwldd92C8ltu/nbZlHUntRueGPxF/rbHyj9wbht1quKk1nzn/FZ/vTk6q6S6bMr8TSe1tWM831+9Z3hWkyY/1Bu49aQ2MPRgyLb58fKcH+9/ZPCOk9pnlx/8YXqD2VlXtrn+xDO7YD2tLd+7e+388vubdX5b+QzW2+Unn718R0nWXe+0TXn+y5PaO/eMGTFt2LSs6PmH+ubB+lr13BNPf/LdlPKHf9kbzYP19/iV2xeMrz8n6/W99yxZduSk9seXu6+f90hJ+eD35rZwnjypffDGgTu+3Ni3/M+03msiv5zUsn998dqE5SXlne7+cW7B7wD/ha93OPP50PIeD/x5elwN4Ousu/IOnpxffr2jtO1Ke5X2yTf9PF/UFGbtWX9DSSOgN68tXvDHn+vml7sbfXHvBqBH7/jebPvGiDFZz9722DfP1AN6eH7ZfVf88ETWw7tq+r2qQvm73bvnVU7LumH3nZeeal6lDal/c4c3PxmY9e5hx6Lhl1VpQ+styG+dNyRrWEnVAbV9lbbn3R1T02cVl/+x8f6+XqCvI/+o0e5/fV75xJnO69v0qNJ6vTy2wxv+kvLTM/2ux3tXaS85r33xsbLCrMeX/3kg/a4qLTGUrT4/f0r54qkf1/mhP7S/YP1nt9zzRNZjV3yt/DSsSrshT3rt7k7Tsvqvkn4JjqnSGnde5Qx+NqW83zOPXPn0xCrtY3+Pa95vObO8RenZ1O7Tq7S9Mzr1t71XmPWrNvvwpSVV2uiC5249sXlq1tQbP/rz1qVVWvX8vfOSf5tX/lXJ8siby4H+FzY5uPiNueWnhjzRpuebVZpLfUUv3/hEVvN7BpzM+KBKu+L4yxsXtZqW9fQHee1bba7STj62+/KXB83Kyu424t5xsN/+/MM1hz5o/0R56ofPvn7+a9iPPpl/0zUzx2ftL3l+8vrDVdrMHf319fbbs06Nntdqwy9VGuvA+YS2Qz5aeOcvl14rCRPhe9veSmfrJd2OA7/xaTRJOtX0nSUfa8u2On4c23dz1DAlHi/O4LcTX/Jp1PfNk0uWQLmXug0hr8C233Yta9prg5ZzbZflNTXR6LbPW2ZOG12u1Qxded3xJe9HH9v15m9TJq/WPum2e2zKbe9Gl31bubH6qt80VvLTQ0U7vog2Pto6d0IKpJl/w8mRX0TD7/7h6n/6V41V3pryQ8oX0UfnpDR+cTekJ2R2uHfN59HdqzZ7e72F6eKSvvd/Hv3Ad9mVPeZDmqWP2yV/Hm3SJZS+bDSkS0qmb1vxWfTLRi8s6X0bpG9R7riu92fRTU3nvXLHlZDOztvY/td90dQDz+W9k4r5K86/9Ny+6I33bblt0K9nNbZiZscF3fZFe7ee/+6Q/ZBes7LjmZ/3Rr8tuXd7+QeQHjWv686n9kYn1P/y9IDnIB1eV7dR9t7o43d0T76jGNLF3asOHt0T3Zt3eOfTAyFd2bZDxqI90YVFLx1s1gPSM76as7nznujUbo4uNS0hXdK8xfdHd0e/W/f216FESJ/r2Wr4k7ujX3x7VY95v5yB9PtLh+i7o9mZ33563X5IL65atOvnXdGtZRMqOq+DdODr9BeW7orOala5sSgC6TUDb/upx67oVdP2NbXPgHT19G6h459GvW3qZewcDumVdcde3+PTaJ/0jnu/vB3SbQPXdl2+M3rPtFVdm3fC/KNd/fLO6J/n0vR3Vfx+fItI/0+ib53p/NUUJ6RLnrRJFTui8/6+8/55J3+B9mfe0ULdET16ozf85WeYnjy37uTt0VbrAxX910F6194dHx/cFl3z1dhWTV+AdEnypdndtkXlXcs+Cc2FdHXDoeNXfBxt8PC0zfeOhXTbnsOG+z6OHmz3eq+d90O6otuL6uit0ex9Ny1+qDvmp66a9/lH0abba3bedxmkRz2YtSbro2gvf+nY8emQ7t/+maVlW6IlHTu33ypBOry6z+XeLVH93JNrbz5+Gr5vOu7RMZuju1+uJ3s+w/SGeY8c2BRteX71it8/hDTbc2vr7puir2b4Hm7wMqanls9auTHa9t3U/gULMd0rb0nGxujZ0jvv/ONRSGcvL+nz+IZo9JqGz7wzFNLhh869/8v66Lqz86Y+dzumWzfb2n999BrXx6+s7gxp9bc7i3ZWRN/LfrmV1BLz/+51IKsieoW+46mH0iBdfEP5ujuj0Wf+2tNQlbD+7Kdc7T+Menve1OvMiVOQ/r3z4rrrosNy5t12dj+kw/tvHvL72ujESXcmNdkM6f6XqQ8d+CB69JLthRPfgnRx5uGNFe9H36vf2ic9D+mKgne6v7gmum7Ue4+snAVp9to70tzV0ffKq5rNGo/pDt1OFb4X/eryG6+eOwi/f3x4wgPvRr/p17zk/VshXVn67X09V0Vv3HPF8gQN28+96csr34l+9XugYHZrbH/zuYfUt6OXv3sis219SKsPLu6e8Fb0zaumffWnE+vfk5v/x5vRd/JuTjx5thrGM/76uV+9Ht25rOX9jkOQZo8dOlH+ajT4QuuBXfdAuiI5e2bpy9H6iw9OfKkC0/KVd814Kbq73Zapl70J6eLPhzww+oVox5Tw4q+fw3ROr1n3lUW/O3zbm6/OwfrTBv3QqzT6Z+bNly17BPOPT6koeD5ab97Vc97NxfRtt53quzTa+vcTL5y8G9OTP33w2qeiJa13f9KrF/bnlTl/Zi6Ivvx69ZYtHTD9u/rI5XOiL1/xUEpOJuXff3W9adGeY441b5qO6RMblOQJ0SffSnXYXJhu+pDb1j9a/49LfmtcCXSZlUz7pWqkVnhswIYGpZi+9mr9wOPapUsmrwyAHMKKN2wq27lQ++T1k1m/NsP8manrlz2jHU6Zr2w9CnwOS9q5f2Wp9upb2ycUvwHpCmnXvbNe0J7xPRepXwjp4v3ZU+97WXt3iWfq/E6YvrMqt/nr2h1L+7srJSy/+MfFY1dqi9eO/1Ha9jPMj/+Hs7e/rSnzJ3pPL/gZ53/2N5eu0nbe9+fg1+6DdMWdj9/teE977tsHXmndHPNzrx73FdD11nmdR5w+AfPd4ObrXn1fkx96KTL8Q0z71340Ya023NV++CWzIa0eviLlunWa7a771y26C/O/HX25J6rNWbb2yncvgXT2/FZpQyo07fCJk1PPHgf6s2DKYz3Wa+uf+nrs+U2QbrvtkxGXbNAyr5/ua/QkpG/Z/OIXykatdeeqzQdzIB24Mmvjdxu12TM+HtKzPaSLH85r98Em7fq2DYM3uCFdvTuz48LN2qSq048d+foYpNObfpK7RYtc2//yhm9CumTwiXPZH2kv3bVX+2kK5tc/W5G2VZs9xl2VfSeki3/t0+LoVq35Da+WtGwN6exzcru1H2u7Ty9MCUuQZq0b/Dx7m5aR9XXTZV8cBXon3Xfrvdu1krc+sjd7A9IV5TuGtNihXbbz6dOXPgbp/j0/u/rXHdrYG5af/OA+zO9+1br1n2gdeh5+bstVkK78dI00Z6f2021DLuvth3RJ3Qp330+1576oeeK2n44AfW+cnJ+wS5vIdizbGYX0roUJa0bv0hI2fvhVxRJIj5r+fN6+XdqfdZu80rwQ82+48vF2uzXX0ndeY70h3bPJEP/i3VrfzjlHerWEdPGOyppzu7X+8pknJQekhw78ot/de7QWZZUDmx08DPthqrvt+3u01989MP6dDyHd/7pAQfpebUOzp4e88gyk008Mv2T8Xu1OR93Tzocg3fbNP3t/tlfzpXz+9bY7IF152Q8nr9in5b3XW2KBn7Sse7vMz5cnZT256iaFtf1J0+9nPY9F52ZN2LfIz275SVv9wufTXyp6Iuv1kTc72aiftBub9ck79teArDcSv/u7Zt5P2vmEu29sPmliefnmgU628idN+upAz6HrZ5X/uv6+RmzXT1rSwl7PNdCmZnX+1X68puon7fY2B+vbiieVFz89PYEFDmu3PeQePbjmkazko0P+qrnssNb08XWXHGRzsnKTJn9X0/uwtkc6NWK+PKK85NkhiWzUYa3w2T6fjP5rSPnVWyf9UTPvsDbVdvb59R9Ozvppg/p3zZuHtZxBO1rUnTSqnH2s/Vzz6WGtwexHXAXFxeXj6l9ytKbqsPbG788Nz6yYm3Wk7FkbCxzRrrzxx1v3FM3Mmtd6YV3W9og2+Ze27x39e1b5s2OudLBbjmjlV+fkRaMzs7bM7KKyUUe0sY8k/ZITnV1ue+js8Zp5R7Q7t18bGcFmln9nKw+xlUc0zw2VHb5jj5bPyvD9WPPpEc2+rKb7aDaj/Lon5v9VU3VE6zDq4V2PTJ6a9VG/PxqxwFFNWfXduPmdZ2a9/0j3FNb2qDZOXnzDzcVFWSOdJ3+q6X1Uu/TBmi+rJ80r352c9W3NyKPaBx0ueeqVKaPK/bO6namZd1SrWjFofkbx4+WdL138Tc2bR7X2C++ZVZn9ePngP3vB+BF/n1nv2qll3frsKZVVH9U8985o/oo2q9yxslsSCxzT7vjqriU9QW7449e1Ttb2mJY+vNWsVz+ck/VQw6cD7JZjWtuHJnyz7e8ZWT0vPduQjTqmff3q/mvH6fPKb7vy7gas5JiWPG7DNDn6RPkNnXu3ZCuPaf20mizb+WHluxu98UXNp8e0VaNKkg93nlI+wXbryZqqY1rZtwmVnR25Wff6c76uSTyuve9p3GGr456sO7e98nfNZce1hllNChtJD5Uf+ODJL2t6H9eWtZw+NFDzUPmzOc83ZaOOa517T9/VrQb48DqP/14z77j2+8YNT43/e2JW7+22PTVvHtc2tTp9snnNwPJu9+l7aj49rgWPXXNydU1++Xfugedqqo5r93kvfVrRJ5ffPu7d72sST2j1clcvGrR+dtYPd/5xquayE9rPW9rOrfp7UHnTQ9EDNb1PaGN7nCgfqk0r/+39Pj/XjDyhnai8vbps0rSsz+Ytgfk/oZ1a8Ptcx9QxWUuDzYJs5QnNlpA+6InzQ8uf7b7om5pPT2gFxz5q8OGkJ7LGbTp/rKbqhPb3jGWvd/zwiaxW55bWYYGftdH3vL9i/qNjsxr+luhnbX/Wvvpo1LCS9TOzNiU+dKym98+a7++7NrdPuKv8x8cPXMpG/ax1TVx/0+fFReWvTDkQZCU/a/fdd37RvImF5VPlvP01b/6sTRoQ3NywaE5Wxx75Ldiun7Xb36p5+3lpRtbZkq4/1lT9DHLJbVv2sBFZi3599ZOaRJBjh7VRs6cWlX+z9bavay47qQ1yZWxbzx7JqqrT5XRN75Para8uWrmipiAr6YFZR2pGgtz9YdVbY369s9xf83wSKzmpSVu9D8wtnlbete4L39WAHP+uet1nDjYhq7QouT4DuXnBfXf0PyffUr4JJHFWfVJL+unq+7tmP1Yuz334bE1ilWafX9Xx8j97l38068dGrG2V1jdpzOnXJs/KWnTVlLM1IDde99EX+3RtVlbejS//VTOyShs7YXGDM/KD5fqm37+vmQdy4uHxZ3Y/Oj5r0g+VMP9V2uVlE5fWk0aWP39ofAMGctpbr+284eTk0VmXb6z8raaqSrvn8VFSe/uI8hH9c87UJFZrX3ka9Hp90qzyux6e/kvNZdVa5dt/bRxW9HR5Xf9f52t6V2v3Ltp+1d/Rp7Om3PSJwkZVa9vvOFQxlU3JOrL9NOBftVZ/bPsPv6sZXp7zlU9iK6u145f89EaRNr+8w97lEttVrf22rOdDfzxanHX+/Fd/1FRVaxV5n4+y28aXP3X+Ay8LnNIe9A6ftq/4iaz7z/z4R81lp7SqducH/RF9LuvLpZ8B/T2lvXFL8qjxbGnW0r5BoH+ntJPf/nDw9/Nzsy7p0/yvmnmntDEF1xxoy+Zn3Z11bTJbeUqbISnFDxUtyVr9fItzNZ+e0obMWfbqFb/nlLN9s87UVJ3Sjt/70nPRooVZy6fP9rHAaS107/n5ecXLspTrHgP6f1q7Mrrs+IaahVnTfi2vqel9Wiu49NJJh6VxWV8GW5ytGXlaG+ArGrf2r6KsrE4LU1nJaa2VLmdtkwvKUwb2TWUrT2ty49NXTileUH7NbX8fr/n0tHb6QO8Ok2pmlD/1+hovqz6tbdbb3nJrzWPlbx58+M+axF+05zIfmDGaTS4v6vcarP9ftLTVq7X7a+aX3zHkRR+75Rdt3ZTZoSlFT2YFf/sziY36RdvxmX/TB6w46/3L7gb4/6Ld+tLbbZ7TFpV32fONja38Rfu+w7hReUWPZd358dtnaz79Rbs8ORroJD+clb5qJay/X7SVt701eHjR4qwzb16RxgJntKaP1evX/tyQrBazewD9P6Ndd+uBgp+kqVkDVz15uKb3Ge2emW+vGVYzM6tyrA3w/4zW5/SGZ96qeLL88PqRVTXzzmgFLTuddmc/k2V76cMfa948o3V71B9dXbOo/Nvmgbps1xnt2twDowdVLCk/2Lk6kVWf0Rrc/ph3ZtHTWbtvOJDMAme1dssHj86x9c96uLm9Dmt7VnNf0WTnzuhT5TeO+vpETe+z2heldnuBPLP85T79qmpGntWSB32c8FP0mazkwE91WclZraTqzcmbJ83IWtD5Y4WtPKtV+KIel76svLxer4Zs11mtRY9mf7acvLh85sNrDtdUndVsw34uXj1pUXltfYShZ+hPeoYfow5hb3Rz37uXLFlyVHt4eQt6f7Rbz2fu7XU6ulG7ZHYrVs3PNcK/xs43tr5/ekrrz6PFd7TPbLrqjyxuP2XJd90VXbf7s6j6W+V+1wsN1nGXD0v+Xd3qjh/3WXT4Le99tvzBJjw/25J/rs3jr9f/LPrZkJXPH5r2Uzl327PkTxj/ZL8P90UrO7dYOCzDxr9nlvz+DTbMHrAvumPajT0v25/Cx115Npa/Yvr0trZ90U7eKT//0uUA73+FJb/nsL43vrg32n/RrdO3vKXy78OW/OLFS7/psTe6oHjzvpvubsbziy356vcfHDyyJ7q/1eoljR65hOf3t+TP+Dblnpl7otrKT99L3Zb23/KzLfkTPv1Tb7EnOu6r2zOb3lOHj1+15C8etn7x1t1RW5/DQ8vfbCzgYx3/q6/eN2R3tHrFlCu3NG4s4HPGMv43fp9t3x0dfI/9/KYVl/DvKyz5JWMONi3bFU1Qzkw6mefj+WFL/q5Vi5pl74oWtTnz/Jp21eX/Kb/Ykp/9wPD09z+NPp615NWWd/oFfCz5/Q9sf716Z7Tpm9OfXX1JKwEfS351yxHO5jujgRqtT+/L6gr4WPIreucF7/skmjF029r5HwTFurDkh5d+9Nu8HdGrpi0b2vuh5v8tv/IXC3zaFE7fsD06b/Xsy1feXI/nV1jyK4pv/viXbdHBJZ9oA2/+gONf2JK/8mDj8ibbosfWdz8waE6zdf8pv9iSf8uZZ++57ePoD/vW277c3VKsP0v+LjUnXLQ16v7j66LoOgN+lvzKgDzz1Y+id11/e0HJ1/8xX7XWX+9w4udbooMPvl2Weygg8M8Kn5dGta3ZHO14S2DZdc83+m/5lact4y/94cdLNkfn3essmf2tKvDTkl+8Pb/VTZuiWROuHrDeV/fa/5QftuSXNFL/Gr0x2qlP85umTzgl6Jslv7rxudue3BB1bRpdt+3cpgK+lvz+l33WcvX66FNlSenLiy/9b/nZ1vZ3TZz0RUX0zL1HZjw1zHPtf8pXLfmVX18+/0Q0evrKsvv6jBX4wSz5rBWsjw+jWbBQWl/V8tr/lF95yoK/987r80B51PFhv7vu9DUU8LfkV17fafiCD6JbX7n3yNUdBX38X/lhS3748s+7bVwTHXrHZTe1mJjy3/KLLfn9f5y1p/q96Fdjrvy4/dOCfvW35KsOzZnxbvTOB7YMuFcW9O9/5Wdb+5/x1Bf6O9HvUn7f8dUDrf9bvmrJLy472S7nrai7bN64ByamCvhb85Mq2nrejM5/ot3U5+9u89/yK6st+fVGf9Pl1eiNoz7/8eEpDf5bfoUlv+KKX+8qfCl6svT0Vd3/ar3uP+WHrfl/v//482XRV/6+5Oxq+WzWf8ovtuSzCQnPTFkWPeSeNPGS4hbr/lN+f+v4PnNmvP90tOOLfyzsMzdTrC/r93+tXFExL/rsi3t/ndjou/L/lK9a8wN5LSuLooeyv/JrB+ut+0/5rFr7d2vu/5FfUWXJnzk2LVCsHWn13JK8jwR9LbbkFy+86w61RNvz20HHvQcM/sr6/ceZzXot1q7y3XPFB2GxPzBLfvbhmffrYe32L07dV5EkCfw4afn+0n1vDF6uZZ5fN3ZMHTH/xZb8imWpryxaoT16yT27nnxIjD/bmv/NJ2O2v6Y5M/f3OD20voCfNd9RcfmxN7RHrvm4d+ekBEH/f7as7+67r3n6Le2Z5/133H+FsT9a8it3v3R23TvaFzd//cIDW8X662/JDz990z1H39UaNbw/yzFM9D/bkl9xzLOXrdau+Pm5l+c2OsHxk1nys+++/4Er39e+6rGu031JTQR8Tlj69/rcrblrtR+H/taquCRF9M+Sn10u3TWjXNv72j1bdnc3+ENLvuqZ2vGjD7XKbj+9ObSijejfCSt97zj/SFQ77ynt/flVBn235jef8kTd9dppZ5udE6oEf1Np8TeobjKp1SvrtauWdOj6xEsCPmFLfvF034DdG7TSVZO35z+nCPpqyS9JW/lXzkZtZsENTVZctoXDJ9uSv/LKqdfO36RNeO98n4emCvquWvNLD/3YfLP20aPDfjxypRh/5bFYfmDOhzffuUWbcGlW69mfGvyTJX/U2NnJ1Vu074PP/jg3yZh/S/4tXR+bO/MjzX7d/FGBwYb8YclnHY+/+eFWbXfro6/0udYp4GvN/+3APfd8rI2sCd+Vedop6K8lv3JW1s8Lt2nDgnfccl2BoC+VRy38z7137r98u/bK96/dPPdqwR9XWPIrr+nw+K7t2nvJfe7edIOY37AlP1C95c+RO7Q9rZ7aXHDiFKc//S35JftWXvvWJ9rVK9N+a1kj1m+29fvDNQm379TantH7N0/ewOdHteSzbw69fnanlvTE2py04DZeP7Pkr3wnv8GST7W23/m2ndieIeB/xCK/3dS/w+hd2vybf67z9bPnBH235PcfMKTNpl3a0WNZdWanC/642JJ/BPFzt9ag+oWBCUGx/vpb8s+9tv2+vN3a5Dov/PbJUoP/tOQPvWfgkuhubfW6Hrf+/KKxv1ry1yQM75a6Rzv2QfcPvn1c8EeVhy3wOzCx+sM92hnbLdf/8azgbyos+f33fn8qda+2Jiu49+GDYn7DlvzAh+OG5O3Vto4/tfKTEUlifJb8tleOv23DXu2+dY73+lyTLta3Jf/IZ01W1dunPVdZcqLdIZcYnyV/6+gNc0fv08Z+PsS9s/llgj5a66/7fOXH+7Tl+z0ZM1XBPzJLfriD843QZ9rdHw2aPOpDIfdX/mTBz623//bIZ1pV9v0nf35d8DcVlvz+d3+37rPPtAM5y10tvZ51/x9rEnoJH1ABAA==';
})();
