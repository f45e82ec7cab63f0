// sources 496654089
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
const BINARY = 'H4sIAAAAAAACA+X9B3gU1Rc4DN+Z2V6STYNAKLMLQmiKjWZkMki1YQEbKiCEkoQWQlGRRECkSigqYGGzQcWOioIS2FBFQARERUWNiFIlAUGxYL5zzr0zOxvQn+//fb/3+Z7nQ2Hnzr1z67nnnn7ZwLEjJMaY9LrcYoBcVCQVDVCKiorYABv8WyRNGsAYvYD39qIi/kBZTKQZfsUGSJjhKhJ/4NkZe3SYT1IR1jaJPprEq5xktgmN2YooU5k0aRJPiYYnxeqcFFcno4dJRncmUSWTKMPJy2JhxluYJPo+yejqJGynaIBMrUn4jzyJejOJKsI+TsKRTYI3kyfj82QqDm+UCeMVxWa32ZjD6XS5mc3j9TkcXq/d72Jev5SQmOBKCCSxZH+ylOJ3OCRnKrOl1ambDmlfvfqOpIwkqY6tQYMGDRs1aiynyrJLkmS32+93q6piswVVe6hJMNi06SWXBJvBf+olwaDavFlmsEnQZpdGS3a7XZFYgsMFndMrtl7tdd7mcozIGTGq4EGZefsPHzm8cPjA/OEP5TDJOXLciAdyCsayLu5Bo0aOLRw4snAsu845Imfs2IFDc1hX14iBhTkFUJp1sxcMHzl0LOthGzI8P5/1dHskpkte2429brjFs/J523io2sUCxfCHefMkuagJPeqBvJDSlD+yoE3OViW9KFdl8E+BXlxs6+VnqoIP7WSXqqhSO9kGP6ydDJUHbaqsSzrTj86Gz1UlMBWrqe+FDwK5vE7V5n3eZ3PDlEuTHUaTFSwvaIeWWDeo3A5l9ca5QYfKVBlrZ9gIvFehSR90xJUbdEKpDrm6PTfo4k/O3KAbuutRsuWL/qcqbRgL2fRLukMLtm5+GxT2wl8Z/vp8EvZQyg36sZgUkvVDrIdfghbtmbIPkrZcbNkPVeAIM2X4BorAx1LQq/qDihc6wTqxJOxjJxaA+rDa2EsZXsLM/MK6+2Usj417oVOy/gfrLoZMc3cY2nWIdmFM+sQx0LoLW8fSrRQWSlgXSuxSzP+cq2FTLc+3UU0nluCMPjkH5zqxS1HfDP3wEv5cw/84p96SEZIzGSxZAPsGo4OBdWKpPgd2OwAt4XdUWRvoOAwy4NVhLGrCUjVBTejKxJ9BGaFYYnBIzggmidyiaZfqQ/yKz+atPYc0JZfxOZRVR9CmZKs2AK0QjB664hkZCuie/Dy9bUEnBsuvu28IJqsBKJrsZ9A/LwCDJxdmBKthPucF9VPFNmgY6k3CJU0yO9w0uyxk7R6jJbCMAIEvoeuV8Kdm+LnsQZCkSoriK4mE4j6RrJ9gnbpDl1SYixQ+Vo2gz/ikUgubn1frgyytDxlDzb8alDn0yF7VpabkwujdQT/0w4+T5DcmKdUySckhnEAoSLOVpqbCbKVBT+Rs3Axqii7f7Me9meyDOlOwaIpqQ1CWaeYJ7toCFGImTFiyF8bM4K8tV/f2ygil6Y3HqWljYIGSewZTlWy9bVCWcdFYT+hwqi5Rx/0qQRF2G4FZhf9l7FwAq0yF0vAj01TY1LQe8AGs6M0C8tXUXP1SXljODeLugTEEvFgEWoTeUZdl7Ci8wW/hMUVN60mDhCrT1CSsMgBDlMz2ASR+ZByIpFy9jd4Kh9Uzw2wnGT5MgneNx4Vk6OxYKO++3uhRcq7elpdUaEb4UhpLQRMeW4wksRihgAmzqWoSTG8qdBDKixpVyk6mOeYLEODzYlMDCDhmy9hrr8AJCKJejhVp4/hUn9nj/8sbiADepxfhMD36SekG+DX2Uxss7sHueAAZBv1YFDsZCnSzlBb99QRlaNapyrm6pmtqAOapRhoT8ug1rHsGFFZ7ZRgzH/SY1UjG5zLU1gu65TG6BdANGYoPHyXvOofNViQ9Ik0yz4dKFjuTJDyTaNkZ7PWQXf/7kVy95pFeNEfSGD/h8kdlfjrZ+elE5wf0Bo6yrU9ZTyaAF16RLeTQH8zVH7yBTjdHOzkdPoOfVP51wDjboIaneQ2wPLFKVNZSXrFECjnXBl3UN+d1uKnvx7lzrfsHfH2rH09Ytz7HhecWrIRblwtxMVrKbG3oXz7D/efGtWspu6ide/2Klw60fYslOHc8BKaAB+FdAj8RYdv5qd5/6QyU8f3vMvqzS6R/LXUbLYGa0E6+EX7c7eSe8ONtJ3flU5ltmcr9c/hUVjBzLh1eaMKGUJIAMBFK0JUeiJp8ui8XRubX56TjMe3FPK/qoDwP5nlg9uCdW7XTO6aXL0FYs84AdHr2daxpYa/+3Wgg6bmxN2af7+I/fXhnb7F0dtoS3tndsc7aLt5ZIFhUOfAYloGzSMaaXR2VTF6laqlypRi/agUlKtyBT91V/Ju2lm/mzuXftM21UFeVLEZeLZAl7z/ScmLPyIhGEeyRyiKCClpw0Z52IRDCxNAjzqhIz+kX9EAFcLr1JLiFYQZ9cBwwQkEeODJ8cAaE/PpiAmBYquX00C8DUQDMEmBNn1hLXERf3CLiNvTg3sNR4851xXaubqPB22Dwj86L270yLjTUxbDXuSGgBfFMwC7VIjl/cDglRClF8iNI/0uPiPmplvJCsigl437yhZQO8iGJJ9I7yEfEo9pBPiEZuAdfwCzyracq/DeXtmPIIVIhmNHudM45Yf2g60gWf7CIGoqtHcc/vKZ+iMEAf2A9tqDbfP8/kYjqpnIDsJz737eljLCFnXKv7ai4CKp4z36aQT2L65bD6Jb5TF3Bx6uuu49X54B6VEs9G5bwEcZBNNDTcATbEMoIWpAcN4esEMoUL/59rLEhpKtIvJzBxnIBog0EzfuwdA7vQwxBy3Sa6S5cECdAKSxfUBFbFzqIPTzHcnlLJaVPb2DtcZL0ass7nb9aLF1YrES6oNga4xX0W+OvVsIr8cERRsASWEtroa+QcnEvZq7myRmY1FMJx/I33+PitCN+4YOn6XGAKlvrvwuSUPctUOBFXqAY4Fb/mn8Xxucdc+m5QsBzU6i6J7zeHevV/gv7vI33rMEa3g9A07pdlQJzOWbDaauWYpusRLbhFpMekScBClQ46ybj0cuw4r9gMSqgYhXxI24VG1/ykB13PL1LDznWGtSxZsBcRsjZUQnQvrN3I4pFWY2ruLZrx+dui3T/br4WManrSOAsdgYwgSscKQM44ZAs4ca2gLCowrHWKMObZyEE53R8tBm948VtquPJDnJTLCe/jRnaIiwVWNBBzoTFap2rKuZrvnSQw7w/Od1Ix8iEdpRJUpENUA+UaEoQCFPZSkkHDCwhInbiD4PtLxMpEXRjAyrgTkC2+ooWga9o0oEUA5YH/t6fAd+7VOf1Qa+Fy7VhdxVYsW60VVrKa4Ao8awVda4NAW0gJjXo9/3PEqoCgBLCdLGG+91kVoJw3AUTfeYbWCzP2lJ4y4KJXkRiAUAwwDVB/1RvBgzNh1WpIftaYBQSui4ffa3ni7IKWLc1jR47fuua9Vo4YiC7kCuj65rsKQc/XOwCVitZTVZ9gzPg30TgqMQgExFHIDnJdAQrALT9mfwoiCVpSZOptdQ3enz/UOppaI0e3vgCWgullL3XAcoBr6MGIkCKOlfDcJmaAm/3ZSI0tFICoYAKxUKpHeTdmReZXXZd/9Ez21KvcelcGbyk1wRGNbksiF1IKoOp4J17uJ28qAV/Xg4dPYdNJbwXcneQz+BjCvDXKZEIdGIxlIJZSykLpcAbeFGdCZOrEJmo4FH6VyawAPjo1PdxggyXqfMi1b0oZAfYA+w2o0Wu6tRf47khz3zeVWN5oQzuKEQGi1oswo+j9xGw06NqB3hf1AKPUTi5FXFy84GGYE9XZKoOnLkUqo2ENzJ8HYMHmLmgHb+AzhzKhIkNenAAxhHKBwKkRYiGcABGI+FoFD0Te4sDcOpHMiGPyCMkKDx8YNgSHUmpsQ3qhHGkPok7DupHxC6N4WeN6gQwkf1wTqlJwKwrwJY5fMpFSiHn4VBT10aCDux0Esz4NlwRBzxsxofkruGNx/++oeeqjpbHwRmQvTPTe0qxA9YjngX2t8w3N+7bYonv25AD4SYz5EQZBW34iswQQwzpQApBD59k+bkkwmB8Ql0GuNGHDUK2bu0ErQ8YwuanRdJofy4MumjLuaGoq4OsYvUtsc8yESmLOgAPgyIleLktE1KE3o5kQgcd1939JZzkBBUsA1+fywS0NZEQL9RufxInvAGv8EBmB7k1UH9tYaH0SnORHGLfQgUd5Ku4pI12emxx7GtjG1p1w4ayBz2wP2MjCNkXXue69hptUQx67GtLL4YlVHekdl0LkF91qB5ExA4Etqaqi++EILDMQQkADfqPgNUhF6Vd+Mz0zQdoUyzCISj6ZpbLe8P03Twj5HqSv3HFdguMG7aCxLeC97BiV2DB3YDU5Ukor4GCA3T4J4wCU3Z9SMm4ruf3S7PhTVeYkww8R30hWwbgwKDDHChQzVLeagByZzhwBAGlVGTBsIOu2HxIetHYixWDEy/ojqFlT+zRgqx9sUe/QCKeWNWy7hyzWiQTKsLYSAReKuNrvwyHElRHWSkv4IxVYMuImA2Y71EgmAgndxgOMKfqVhPwa1dpKBAJJam+MFD/TjVhWUT1hoMcB6v+MB44amIubE0UHISQ3jCwDooqiaS4C9lk2HSFhB79iMVHwyMwFfiYr1owkAffDFPFVrHPB/wwWCWmeaJ5VGMzb8M2KL5q0QJ4qeqLML8BSvAK314EX0zyPipJchFCEtL9OgvMwfkHDmipFJRwUQPQUWd3wkjAoyBv1EF3wqOje0YiIhqJMpAxxNIuACDk4qTrM4J4hqDkAfk6Gd+oUj4xaLo8Qnfk5iN5KqFA5IhdUgyObrdsciycFSHZniJI3/cXE6tnFUxAD2lGtwExO+vHx3/f8eHcXz8UJB8QdBaatDb1VxnLBZq0y7ElUz5euOOTRVvFu2LLu+78VQeia1sLsnU/J3NVkTzHk01FcjonTtvGKNknKqDmTE7Kqni4rSFCX98yi0qiBP1zTsUiobudvx0Nj+v5Y4nEiena4wjHaNxtltwKYxIshPlFsitj2TNkM3uxkV0sm9mLJRpgphjgGk48pwuyfj+R9Q2QXRFvzvECNpHczCn3lTiKlfx5Nz6X8YmqxufF/LkERX3hWMsrYh2bY3Rsm/lu2hpzqHIu7Y+cjz/eENsoiq5cD5iJ92KxTJ1yiU6t4Umjy0/w9lfKxF7pHoMZCCkoUSG5gMJlDAxlccRUtyPUidC5b56VyUSwRRZit2ywEIr3PUmWgVAWsK5eoIniMnnk+VspRHXQpnRhKoSSjAA9OYfwk9Oe4+c7AOlmBT5S7TgMlAyoTnpSHcAGX6i++v0iYgYVxQyoCgtJRC0gWWKyPo86FSecA7IpV2iRF3IZuxSOHSdHGyG3X9AvOhL4Tmrsq6dr71mgCALTjfLQOyBQAlMs3zvivt9V+3tsEXY9ISOURFENcNxDLfOIiXALsWdcNccu6IYdkZMbkJOb0JXHEPrAL8oXAf1CjdNEvxDN+XDh3fgdCyXciFQ6itKAF0Ohjg1+/HyaqUnVr89+EmfPZZlmn9lbZ6DEqFn1ASbkVXvhKPFCX1CIVIkCPmBXSHgc8vcwtAES10wA4rwel9+FssdU+BFiXGO8xU9T43FiXBgZcIVwKNsDs2kdbYWC73JDyYoWubx7gcdp2d2IP+HQcrVS9rcIJeLv7haRYMDQQfJVIMzvxGdXCFVDDsL0nvzeMDCn6hkJBCkMXAI2EFK9/KTAICyBSk7kAJOQkmsKnARUkR6UoVkE5BZy0/Yy9gFwrvw2kifQxRbKkRbtAaW6gSPlx17yQsoCjlMNvEePRNDwTCkD6UU3MKx8dJwvDSWL2lrKlS06ANp189JJUJUP3idCPbCiqg1atcGvwlvXs2BTiUeg5gNq8lrkW0jEjSN0Ybf5JOJ8eEbjAubnAsMJey4wg2YUaWMq5ycg4ueg6oSTsDA3MJ+KOFFT4CRNgQu2mbEF3d73vU4Hifj8j0iTHfBXbMWSLVJeyGkqD2C3w2LKKMskQZRHl1Ed4tYVVEe5gl7sK4qSoXEo6BFPHt0X9HKBqEtQgKotU26L1HimnIr0jH6uJdLGHQJfEjjBi234AkGGA4xsyqGbCqk9w0QmJzH9jMsd/AblLJFIQvX3A5jQbUBHOXQbwO1Tsy7c7i7ayVgCIfuPC3ayLZNLFDkJ05PGK7a1ym5AmHMaKJDINSOTGBSqcyttVae1VdIlUWU+1duTV0JbDdh9vtWMDlXxj2tvNWhKX9MqFwrsXyL4JJi1Lo/CQ6C9srIVSqChvwcOIJgkEMOxfzMS9E59Zatc1YOy6TmuXIPrx0HtgzM4lvYgwe4RvKvTeP9sK2S4pFyxQLwyWj0DDqFvsBt1FJ1hJ2AZmnbgn6m54tsE84uZAiwhyxeYhQm+XZwt5WrECs5MlKGgNAXeXKUm8lxPxpNB8QggoC4MAn37Nmx15W1U5L4dTMHSHYKpXJkErCOwfNtP9xoTTMP1hLws1f9kMM1LDeuZelNc44Bu755BoqU68B7IN3ysy4ts46l0ntrJU/Xwq3RciJZyn2B9/MkOZqjOFspdwQaYmiEFG+Lv4GAj/JkjBRvjb4kUVPH3WSkYxN/FUjAEX8k3BpugBQIQejaOwwgf2Eng6eHPapP28gB4dQBe+UhpAsADT0BneHvmivJIOYb44z6G2CC4iH+sdgDaz47dVxvzfBiXWo8/AhunpvNyjTog+kWU1JDnAZasy7MaIIK0I4KMsWcAx9dn8IKZsKZqQqHoCKBN/l6tg6gSMbNan2cBlkrjT4A+U3mhxA5kUpGEiNKuBhBP2tVkRJN2NYUXrmbI4Ph0z/UkvxPgjfpURA3i2HHdTKSUh+uOHIj+QhIQe0RJuQCm6RmHiLpZFMMDNZgPUKmn5+OuSOdCcTz93bDrWshYnLYcHoAkfSFwcaKVi0cvceSrhNgWO3JDXt6OC97CK5GINQHbKR83lU3UqnL9G2+P9rwb5Sounc5MMohgHBHkwvF3OcecTsTKBur2eI/JdhQbKyQ6jpkEhRyiBFeu0tEciMOonNR0EarGZjh2bR3yxqQPeGDDX6AZYAitgL1wro0EfVwm7IoVAxS2tizoA9prdciPWnbVPzgj5Iux2ajdAg4+AzA9DLAQbRJwiWShXIQjhcRk13PrqKWomEAVv8I1eko+p3XRCgLWXEZa0qcqqwdzdZUHs7oTzcqQYHKQ+ouj2CVGH/RB1NFXuIUIzsxENLdwkIidDgg7HRCHSUHoMLWDDiRTYnOtyB6YZ2Sqda4CDNmAUsoIoSVQCQoV9WczcwMLik1lJ+BCuz4nHVjTXES3sAwIxwAFqKoiskyXenLqEOBKUb0o1fPlYoWqDxWCJYa0SCiipRsNMwsXFCCcLaRJDNNCvxxMMIw5EBELsVgCvgFMm8A3U1vADSgJFZ/bcaTwZkYLs0FUKpItlgO2m5PoVrvqN8sHcuG1XyedMuIgoEbcPbkwELlvPAVQbSVUlUK9qwiAxF2uIEYA+mx3JhcltabU/kxAawlCupSFcxrOxC0CgIMWSs/SNC/nr+RCjvUUwmrwcXUm77mbNK3wHlAliRNh7lF+47v4GFwXjME7XbbbUdtJgklYb8siomLcTstlx+VyoBAWpzlmWAG0zs2mQJdxpkGPEzEBCUjyNdKceNfSruI7jwTJQKmR7oe0Gki4+8Ko1EBlvUR0Vcijunpy3S8O12BIo+ElXU8N+2HGu+cOdUaQp1MSOQ/VYQKH0B4CgLjfC3pJEQnnBxd7kz7ejvXb+YJ5j9psbuDOpBhnGTBJQosQxaB1Dl4oRNENLhYFiEQEqiRAVm0ZwJU4AouIV7HRqAGEEfECwxV4MvYapX8e4AFQf6krhQaRiAxlEAlOpZDklT6svifCKXTLT9yfjy8QGbYBsncQBUr8UALqjsgUx6HagPFFlhaGnksjcSH4ou1USEagxbqw/VBiK8UF1EYiMtBJRG1jVclclCBxNJSkJkWABAmghD+VJOResg5IQA2/zPltbo6YVqom4kvEzCE3vsGP1BSLgLIslERGhSTOToMuTcTPS9VU6CQ90ifWD9D4KxlqJUMzFA6aMJdDGD1NTQvD5ymlZSF4XBpKwUJqIBzB33AZ1qemDMqAf9MGo1jDS9OBAwZmho8bB8GHbMOZsvEhp/Ihp8C0wLzR6cWJFJ/Y+p7AU/zcUT3tiLWxeYmuNQUB5XYZjrFJFrslK5xxxt8Fn+wnKv5T/JcmPQPhi4PfwsUXI7Vx9nS+51wEHC5YNuIs3ZzYdonPTy+uTWzbkHGxIbrmJjJ8LAj2Km5xpHDbyU05C6BaanqnxKBsjZpIc4IWt4CZkOFXOIrCJeUnvjgNXUikEHx4/s1uIYZLBpmpnI8/1gcjg4IMkAd5alba9cnPmx3xXpqE6IDYDA8qr2nk2UZ/YWxvP8H7a7EmsgNqQJZPjNywNGGE26DDLh8ZThEWU+35aBIZP5BMMhxTCglOPV2PzQl3vLtzi+6DL+z9vxotUJfv4l3uwyf8FrPnkn5mAe/57rieX2TRsMscAUkqCseh+17Lim27AHM50QSurcheIBbUYjrktJgOubyzZEkyBc2OvJBd5Nhxq2xDOsDFjW/1NQ6DYbMj/YHkLoyJDDm4teJmQMgKlBWEqF1ViF4sd3ipFqTcHbmBp3n1yO3vdISghjWoqlJUKbCYixXbydscXKuEtXJzIJmUdzLC+kz6PI6rxBMNmtzpuLAdhu1so3YIQ+NQKhwCFWO/djtiosijks1ZRLp7VO9Ipqi+p9DCSnhyh2zAIpBJFSETo5+IUuxkYYZYG5AzR9iAZlC0GowpSVDdj8Cmki6fSHsENK/qjcA/TnwGWhSQY3qbrn3+DLqzI0jEMgtZCkVLI4T9w5FwiKx7BO4XiE10xhNEvh6wmpuwGochcT4ekSUnqjhkcfYbtmGy0PjCOuhFehHZKcCIKxxI3MH4emVASsvVs8dAY9k3QAqPPgVwmYvK2+CvLA7iQugIWp9LUOyfvg/yD6CsbJQlBa0s9MUy1uTLxaPXaEhwYpZO2lQnHs+uf+ueYO1qf/U/BsVESei+gn24sPt4rHRHjTPuXJkbdAirVnResHm7w/7iHhU9EP8keg2nBw5d4olTGlKGKicRNEI58Sawh7w1jthkFDcbwmZ2MWrG9T+oGQGrgADoKDoujiKZjiLL9xc5jlRO6HyNjIb+4QzLh4ELP4yT+pAubFSuPrqXOM0UNA4kxsGDFoGEfP0C+frI38FE/kO4fb5xSOSQqRgWSYwZ0eO7xFgRkv/igZ9Iky6TKJaYhETcKE41AS0tnSiXbmuiY7/++oJaeBKxMWFKy3d38e/6cKR+i+Uc+mr+BdjchnSEC8XVeDRCSS6zNqgKZEA8wGSkc1qQ7FjlmCmphZZ0+SWuImyL20AGfj/kMmhJer9SyQUQNd7REScRjcKPeDn+iP+s9hGPRastJ0JvSS4SMErn5hoiRBFMA59ikUQytaWXIUmA7yr03IHflQ6u2sxQpaRHCY693p5iA1B9VuDHpZJidSKlqsS2gyoqUsyKtipO1LzbiL9B2t6ojG8inAfUii5F7jaC7BNhYhTwA6yhyQWc6STeUHhHHOYuJL5LsijVAUgRQIHnfoSISIBT/PELeS7MZA/ygLCT3MAXjpQFfsJeoszAFxGou152pEz1hMn0QfXHe5D40fJafISPIteVbdQElK1P1NMRjgAJSGQPajY8RNyacMOxu08mNxkp8BxBjNdQh+DgSMaN8nc6vISgCCpQCkNeIuoByURo9lVvbijBOH/UBKFjw0TYOH2iEeiXmx9tKn0eDvlwf8QMDkhkwWfZS+QArAlK8IHb5EePt0CyFfFjxxWS+QIogt5SJdrjCmFJhZNsRYnCVQuOiiAjBhbYsPHA1pIDhC32acieEUJVEuD6jBBgSCh2Pe0o714EHeW/gw7OCdpJk04GdxRBkIsgyB2DIKcJQZ5aEIQOFci1+wwI8hNuCybw7zj8AA+P/yH0HCOVExno2VR/WcjP34gKd8Op7zdBpCwu74gWCQf9pCUDZs0fKQ15aUF0Mrj2IIR4LoAQIcV3q4wbf4cSOVEDnwFceGjh/R2JuvGZUOSGzjo4pHiAPzKoFiulkijAi2qwkCwOwoXmF1jQFyuIZIyf4NofD0bueDASuhgBRt0kINXEMiJyMSn1WkQNiawMKOEEDpzTgefpWPWekW12ggjJKoZUTEWuBUq41f4yQzlNIIH1huzADJvEIMqq4IUzNgHcz8w81FCGZiZUhXfEImKRSUTDyUKiBwEWh8R9r2/lkhwXnBnuMHFnsMp2so+EvS6qVOMq6Cb4IGAuSlVX17Xrvvjyu0lfXxsZLPTrqP0Lx1YM1smohrCOtSrcZi6CN3ioVZuwqnPRaqLvD2xCvl7c54PPq/edRAX3YZrJebSsxXmcCxoeP7S8qA8TBnxwhH3+j/SNnC2G0AEXRzZndWBGSI73+pPjSQZgaToqAUsbr9KJbq9NyiALURxCHiMcyg1EuKFfrGZhmcOreG32Bep12B6QURmMcVIOs5cDspeHnBanQbmso6JarK4GCz8juZZ4WH6FC+q4eNiNY0Ftngtos/QYc1YdvBhzphwJ8l7BP+eCuYEyo1vANf0VDLnayYeCxJ25YtwZLo3gzVzxvNnH/8yb/RW8oBmUXmdCbXxWYE6+5IcXCqucqjdTvosk/LjPvGgninp7MftKrhB9uVDvTGvB38F54izjeEsW791i59Oqe5EmvwvIT7eJVKxAai6vAw5IlCksj9+baCBFvCB2CBbOPOeNJdQigUr8hExnzJULA2OArcExV6lSO97ACwTrEo6TIXEBp69eEgS0GnhRIBjkrL1c2M6Pc/3ZYK5JKbtMQW2FJvgOPFSQ+l2NSE7ilcoRFJEDqD4ralV4mqbVD6PIJMUPTFFMnMiZyDgrYJfoSU+BhVHAQpvaCyPKDSbA7yroXCJRssEAJFdAMkmfSNMfUvKCyXy+U+CFtxAdEIsDuSRoTEOPWzWN2wVnkiLTx/sVrAscQrqaGqwHxeqTBAynIpRBGrD6aiAf+x1sQLw6jQq4thRja2GJlPy4V3VJGYBzUz9fr1HG4OdI4sPAdfK0ylgdCcq8KrUB8l9jMoLALCLxThOGeiWcpoiq4LEVN1sETG5xRtGk+dGZ148KuR7cWg+l4DhtUKPoMLxPh6/rEYHhorqp6tILqxZchFvw8UI0pKgB6lk67RDRddoKxAWFufGTAHR0GaVVS8eepav11OTcYD21PlZYX3/UqLMBTHs9mu4MQh3UT537Frq4vgcqu8j8uWD+uEC6gaXjAcuceGGo6WoDvppc4RGncUDf/BgNEHRyHOKyvLHOm+U77JYQUtv4b0R1hqG4Qq8oLeM+dKF7r0QGYTQn5IVPrmR+lLOp7hvFQelXhW8wzqifoJiqj0Een2der1etw+dRQdgC6rRBLhUB9ovWQMy4EqxPrqoEH/XwXT21AX7WwHhZByetvrC3SqCGYe6IclETIQnEGm4NSbdB9+vT2nO4CTnJnB5diCJkzwsnyIXbedocAZucGeXelGmYSDM9Gb1czk0hDna3jInH+krk5SNxEgiIGO5cUaWpciAcjygRXBgRSAQdIRuZeCmDM9BWEDEh09O5Ys1bapO8RTFZE6DYIBe2yL3g0BbCFpmELTJXUykCYxeiwE215Ycc+IyqYi5BQuSE+la31X3CgxiJi3+86MQMwzTlO7I+Y3EA/RK9F23UYfjbkEo7QZYl2sKAFUnOi8ooD+JuXruP1+7jtQd9vAXkrf6hflG3m1eMO4tGQVQJqqc9iPd53R5etyfWc1S3etAe4CL9jvfjIATt1S3n1z9UiTDyPytNN2zvyMvuUTmfVkUMQTEWArgPWHAPDsWmzwiQRlwSHVdiq6yINhRsAw2QqGcS75mU4T0u2xX0oyLuzUKl2wwdDNq3wALahXqnCxkV27hRMe50/l4xFUAK/aDNjwWzWCS0BDQG1rnUON7zn84uo8APV17ZvCIseHc5AkS4TZDKTiTHhVrcUjPRjV7OTcdToR4AYK/AWsA30KNFLRZRfWVBJ6qfvRh8wKn6DZzuxU3kFZvITnishcJHr9paKC6aAHyiOXBZSBE4QmivkHHGAS9VYLOQ5m85fA6DTSbPWRn++orkyZJFkyoZZho6OquVBxEnBV4Sr87hPxXx77ZRkiwhNvNHRARrgjEZ+aogaUOtK4JSKwtjZM5ptQZkscl0WmivX4iCBNCNlOG/4fe4o4oDD3LUKfdQHRmwB2Syyaw5X1PjHIPWHU7L9Pj51CSoDkTjwZigMRiA3iWR3D5JTcwNJSPFkpLLW/CqSWQ0ZAOULhTi6H/UPcTotQKvgSWQ0efGl0/tJxnt54dS3zYMJRzWs9Bj6AEdet2bMO7GanqFJJOlEHQIaKfxwTr6m5cGYTmCdXU0+UrmRBP8zYASGWr6WDjW67webAinFxur1nu9yxdL/zjhmxxq1EWd8dJYILrS9ce+ef7rh/GUYvr7v3xz6kG0WGnY5dP1mxf4J4cavhTMUBu9BOdXA3iJ34QawOFVF4mKupx0boB2LJJah6taGnXGjaw27CyjwS70cQxMmCoVhNjVMuuiTlfh1zati2/GBzGeRzytzIoETtJSNlYbh0uD9DmcUGpqL6Ih3Co5pKDiNhxqHJNN8afIh9mGYK1xGYBCyBNGcl/GpfGQQWzAst4BihkTSlL5uSiIWz9sEVS1JxjHsmwYK2RflU02roDHDB2wt8zvxe2icMOLSShPQJP2mAPHDMmKrCpMPTT+rHHx35Xid/cwVVodm5Kgvevcn98N/7Z1ZeegQ3eRLNOm70bzOmcu2rIDoHVdugT//K5FyHzFhbK23Zyaq0dshEO1d53zfp779/CvFs/ZcMg+iIdFCB9j6KldT8QDoFqdPOiSmBCHyWyYIqmY06ORmZk9KMNMBCARDkHLg4RFmNVpCYcA1XMlAMqOxZAMxadQviL7YtNLXLmGREN1hPEfi8gpQsbpfFZWunBSQogkoVI//xTeYF3kBuDFOQOeuxTwqjFGmCuORQ2ZqoAEotfJvTVmYE7kIkoJEA8krjY5/8poOJQc84hCx1Ug1hLyg6nmdOBS+gS7E7Asv1h1dARNWx2yWyqMKZvVtIzAcWKZHcAb2S0LWEe8r6u6SE7ppvWDYwgtmEN+Y1r9hozUkRPyZgCl6EfxTUbIncclpGTNhhaIfF3Q3jwf58JcFSE8s8eW0EGYsC6q56FPdS6+gPbAClq3ZCggnmHq0ZfZSCTHEuFQOqyMKbAn9Zyflox6HokdfhdbNnSqFksHBK2aCuQf/CTko3dZPTLytxFJrUB9nAisRwS6n/xIOHBQvzn0C+MqtAWDlnwWMpkCD3mNSFOJqtQd6k7EVCLJg4WmNZgGP0ohVpOIIbTygcMCKjXDiE7CVTckBlYAzaAMNoBvmJphsKskWE41gm8kKYanQ8jLvWygD+lkAUpSab0tyVw/vqZoyPO4zcv4TIpho+TWaYEvLRwJfE9r41AtQCdeWkgQy2SkCTk+n3ayKEe5uVsNkL0XtFaP1q2eAS4OopJt6C9BS+okUxxjKSMkUAzHzTahHEnY3gnJQyLin3qq1AOy6uHM1hPOuwJxp/YwDcrENhUTir2qF494AGrp9HVnrAZqowhr5NOD/bJH6Ix28hglzl7AzQK+QUzCu+flfRO8G8IVcuM9SMsu4Txgt1SrNJBHmKHFddZaXEzHea2ZZ1LQgfuxfrf4gTiB2fPz3U1zWGbB0TxQGM1JXFAaG548xiG1zmbn6g8FDijDaWtFUGfI/AiXF1tsDiVVykchM02XkhHkJhl2MmzNW73MlEaHnw05awkkna+QBlIIJF0wJavJmUYq1KWC1XEeq2j+pstB4EY5qiWNiVyoTxwD0+4hyjmR5HYxhA/Yy3MBzWeScOYboptRcU9eNu5IbJN6Lac/t65JQAce3CCkDokXbHDrC4JSYCvpKOS2FgGc9AAFt1H9PFCRjFCSQOcGNCYoBwVBxME1WApSeF7rqBlnyPgsmyRpIi+egJpBoEKJwcWm0SQb4IFIUUTAAa4NR2qIQBfq756hJubHU7j5qznFIiRIAbRUQN9azgP0uHAIDBtnMC2KSQB5P5Ek2yTTXjNGiMcI1kFqTP81aCxy+tISJO2X8DiPKkwlqtXCKJiPhByk6EMreSUSIXWfnbTe8qCMEGI3G/8LKakUlcHhyLKQjb6R0BoXv1GVOA0TfFUW+FooVI3HUmzUFiGdDxw3jCqKhMORC9Tc+4IXUXPvD8apuXcHuZp7Z/BCNfcXbpuLiEC71UjDZjozwkB1JgJoUvAxEe0I63fiae3iFhpOvYj2H9nsuuGjMNAcHmG3qxSGnMj3BXJpie0ZqzkzuNiFRvJOEUls9lq01HSVWYzZYZsKG/fSJV3bXNfg+MF29bVBGVxUbgZ4SgDeMBH2XYCCPDnVANeCwynnNGPTePWVbfHAjTsaEym+UyLA1gwXAleC4KH4cYxKZ3KscqHNg111dSc5noRGSuaRiTbh0AFFX1mKGRiWkjrGDfMo+FkCMq7Qil10y2n0CS1wyWQbaUroDOzMRK5zwnB+iH31/ZHaXsJOvQLewbQFKAabEeMM60vALZJA1ubQRQxoGAoInIqbTNGrI2QQbAu8KqzMbHpbrr8gt9M176DoQl9ZyQx0L5MO5TUDFmg5UVxLFBfLDbxukZ+N1kxkhhZUAickcQNnmD9iTNGOJkHYMcrcMg0lXJnkE4XYwsFrJiqEa6B1rsv2kmDRizpf7GcIOCCyjqiF90I+wnzAZhn4L1Hf/QOUT0QoipA1MafG0PzYaUgkZgRomhLgAafQanQGgGUHIOAIBW28YgdBMhIOSAf35D/Z+qOTraIASzyDlNhjauwRyeoUVLLDPDkAbhqPg42iOsfSHKEgwUscAtoBoR1IKBHHjYYJi9vmo2X+jIBBSdGk4BEbMK0bLHpFFjN1qNaWW80e0HWk3urHx256YbhGeMrX9YsyjGfRIjvC4836ur76Cv75SgtU0XKj9LTH99XAkrW4d97Gs5mvRcMo8LOhpU9irlF55ahspMJ0iTsljAkmklcuAriaiqLfDrBUSWpSuDQMJBqk24ZSyKygNFy6JJQKJDb8HZwRTFaTgB/xA2EqhD8Ga8sjLxjS3+SOSlvogmkR5P1SBsQmWTXkaoyb5XHvXrPiONgJXwlmhQsd4VgldRAGHxMRewUYoqGTB7UJcfDPuMOxYpCurcTZm0lGfByaS9HbIsLDSgjyzCruRPk5oAqFE/xwuPFveVi7tWjeotTSjvh1imQnBGocN4lodWRDbNB43IvBmDtG6i+7kKo6UKjpF8Qk1w6ULTPagK61FVSZ4UXuXWOTE2NGfSWSaXgA+2YFaSYkQv92blfICXo6PVyEGbF9Jk6HIImLDVs6wpdedDmCTegiwgrQmtDwkV8JYjlE1glWfOnVCbf7CMf74kzWYueEhFFMOT9Ckk1CsXgEIS2S/GwopRY9mPJKkMXoQYaG/imlKnqdsnw46+HUEqiHq1eYJRlKgQM8JYwRkcLBFFpVHGgS2tb8yyDVFDjxjQX+PxotMBcu5O/gDOoRFDFtA2hm6fWavZAtvfAFsSfxvSCii+nTRPO1W/cB7uExEakXca0La1JhN2VQkhh2TkDObklx0qZE4yU6MJEuIuLQQbZz+ESWSzELN4ITG2l7QwTYAGa5dAiSZJrTAhiR0REEWgIVoajRFDpT0qPJXLsk8R+fsP2SaIjYKP7KsR1lciUOGqqD0C2P5E0Ha5w9zwsORSbhmdgNxTGZGTd74KIqVy7FFRHGjmQvxc3TzxlnrfciliPYKTTJeP4CyxEb+vi5MKALkHMUl04mT0kftYZEFrlNkqmrjwxhWykTLSYfD2A5K2Ex0crI8Q4rgTdJmikTXbcbUaJgVznRya2AiUNc/LvNNAHmXBS84SbAwEkJv2+ZxoMWF2dmXWhiQk7sLr1yi4zUlotolbiIcRLvlSuw0uyVnayTVS8vLigZmYbuV/CDVopKjsOoFQq8xbN53Ar0hQ/ZC9B3HbC0CykanLBHxmTwr9z8O2/gbf6VF1dS4vEZedNko4sfu9H7Q999RMmF4u9gcWqCV63HuAsUXgVW0T4gMSwNs+QdZLCAp7cbPprY19w4Myw/R8UYXa+tQZkp8VShC03O3fq2LXItctGtr9wiwq94yZeIFgExh2K4nsm9uG3Hu4ZtB3IlgfeEashFS/mMOCpl7qpheUnGvbWWFKfLhmF3jICl3nkO2RZzarMGM2VCqwKwS2bplvA+xWZkm1h8H3S4tq0x409eEEym+MKoOv8eaIdi4bRS0i2hf2KRbj6fbYT+MQLaYBSft2YYsX2MeksqiAikgEBoOH5gdizOz/ezzWg5ZNe3Bi254wL8zPj3AD/F1gA/tQayhvdetUTuaaWM5qniGSI0D9myt83VHWYQHLufG/0VdYd9+aisB1VbBoW8sxtOlTZdIdGxqlzPo2mP4SFNFbTOltEeSRWxcn4puUggVYYLFWRGFFViVW/hwW/icBDTh8XBOr2zvhhIgXF4KRKsOOJVkTxZPO1SbmbvjM91xudizSFXvBF+TMlIFnUymnsxQXHIZvwdmcffoYEjKWEnNwebvnJhXDRair9DB6fVPgtJzPgQpHZvVUBOKXKYNFSjGA1FG4K8Xmm/wgwfiRhBJ3SJXCXpKgvel1iAexlpGZSckuqDZG721ZzNPDchjvE2dCQCARi+ZhgxUZ+cqys3kKDWZPex60jWuXHjENqiJvA1neF40wWeDn4yKyWCAcoRvR8gNi8A+CYfyBKTFgO6A3lJezw0C/8fBx7ADiEqxfYcVAUZrBI/HEqO+844N8l8lcdVikOdjrjSPN4m0EeB1QKlpcTdviEmIcHJJEm22xSnF/2gbTwStYN/ijOJN43IgTWE7VJ8FIoxoKOoFEvHcvjHJA2305UPIdJMpaFkPMY31FETSTCG40TGLolIU5xchPq6sYLpscd65L2IK2/JJtmwzCeXTwXqjbhAMD0cTDfm2GWRiVuqxE/VNBJ6X/B5vTDki8+duEQiFCXRpw61rpoOZSJqnTCMxiri5jMK+8Cu1rFuzliyWhuEyWS1DgAnOUKiS1cKoKcjAP5hjFCgZxpuIlIQA92n6FJhO7kapVKBdvIZERjrBA4rE3UYcMI1zIVSADQuvMQgZTUpmM1whkXB+jyqDl07IcVPIv8aZwLRRR0VxZh6CQVKQNZIqC3f18KhDK7vhYmpE5PpifyPtLCaUSYK1AEu33ERiFeBoIGP1XSLgkOtW0YMgJjrdIvcNz22OYA7pvnhndWfkrp2mtP24BMPduuMBLc7N/A+Ifp0tf6gArr5QqFI7GJmTE8cBVpIhuVL4YtOshOuhbb459VedTU9yOO//8cO4CiC9aHHdt4V2Ut4DG/kILInFaODePm642IoxDB6hNWek299sjZRkyA5w5Wfi4iBR5MPfCBM3gUapFFScZguF7LDQukHwI+A3PGimMZFYGxsC+oJVOazkVk4M2RtXFCVYFDxConJEe9QIBg6NCoaksQzk/oL54grVK8sBMTFSv6+goqp8K5eR2VNQ+h2evzZh/iFT2lgLSevWkE5gDD4XdkwmI5WkDYqYo4dIMjG5zzuLc2HbAme1wo6F0ovxbqwMKkqcHqc1umBykh+Fo6bJxdng/j6oysvhh1W0eaCR4KmCvVtcVuVjBFdXIGi5OaTEFiYY9uJG0jhQWNgcla4cQOLWS4JcmvvsJsH11/stiJsMdAkPJH0LNOEX7VzeKtP3k1OTpoKD2+LrSZwN+k+a3hoBBEncIuEMXG71wNEF4cqY1AfC4aqppfi+tHpodazOn/IRl1Um5peZplG01Xf0jyCF5KeSCOk4CEMLDsevynoHkhkOhon4y/KcPDXAxw4MeCCuSdk6cDY8IjL8OTmhDwx3o0MgiPFe86ucHmYzoMgS+ZoBvLQfTEWCqO/oWcsJ7iMGBu4uRxEY+D+tAt9tyKIDIvLFAouYcxAScjjIQmPjl4ZtEtEFA3UWVEUAe7cRmoAHsbRxaVVDmrCQ7IpD0nCUXcQ8hneKvzc0+M0+36uhONUDn4HIFHOndv83E8H+K84ggcN1Q35j7+W8Mf/StAeE/7YkeEmGV7Qh6SNiEeSi2YNhk2/HVcHEAGc2kLsQRPiUZ3dSX5MF8xgWHiDg3SQDIP0uQodDX+uWLNu0YHnN1qJITIaVTiLBvMmeDQH0UUJwJKS6bFTEfHSABmhOhDeBdbFNhoGOodPsgLrhZsEcuxAsHF/ieoVSYKRsxmolmsYAO+bYhYuZCFIEF56DpOWcYtIL/g50nnkjEUImqI//fOCoaYOLWko6LOPLxYJbGIrZtqnWxYOIyD1gKnBcBd4dZlQIOPeSIhz2eNkt937vIK39JCdE3nDWzhywKScIycCkjSRehGsEt6JIabQJabQpZ97mohgl77mbEKuqQ8GWsLLZ4B0mT7d1j3kzwjG7ssiSxwMaoLzolcbdAQPVhrBMPS4bgkYnUT1mL3BlSsizRYJk7sQaMx64xMCDiE6FlpzARweDhzkLOXRXXy1Q4mqdxCPMeqJbfD6QG/GAobQtAI+TkCDcpiQKPeoNaDEhY8mlMRNlNMENL+4Wkt39yTGQZeuLzCr8htV+fHRrEqnKEkJ3rckmxTvy9bWjKgVm2SnaaAVhG6SyRA5cwMDxwmul7WImFMKu7VKCPoVWuRXRd8xsFYI9iTNiZ2rxIw58aDu3eQOs8nmVCexSgpJSDCkuJBjbnc7DbM5qcgek/6VuMyec+zJOQrcKeyCGEUc23mw03fhzkGxJu5rZvXHdAgfC2RJl5goO2bE5szA0NTceVKwnkJh7omze8H41W4eNhRQNw2bx3v3ERsJmwqXjWJ5GZSUD2VULMZPcm8JJ+chjbYsjZBIuhR1k/Sjl5gz69N3k86SfoTBr0/fxt9ts7xTpRYKoJz2+A9P7cfUfkzplbx8pbWOI/zdEfMddV/iVm/CcgPAcjU5cCLG1GXAHRj9DTHPai5gpOB0gLFhJiNqQlnQi4vjxoS/zBqePNGc9mDAurRCDY0SaCcFgCBbFy8ZmZm8NlonhHiYcBdqE7g/OYaQcOTy6EImR1gZNZsCgkVc0miBiiRUbbPVYaCKgEcuJSsCQ/OAL2J0CqQGZ5SFabOLk9SJR14IusdxOoW4ozPQ3EbhUNIg7jmaRP6QwO+j5lscYULzzaGCXwiSjGciqjlS6SBK5vNPuh9kdJH5sVNOmnEMiCCCVvbVCtRooQDsAZ0mdYje56FtcHvg+YBhwmFJLRaFMfuYymg4ht/ljFCglE4olDk4DVGUdScm8agDfA5UpyAILD6lMN0WVE/4j/yKjaIYZ/OCb4gaw2WCv4MyKOoT/B2cURry1pJQkc8syfnRzno1waC7jFxXwzT9F4EgFMSloQWXiNPnFLfyzSCaoQ6Wq6Mm85IpdDKmILeVG0oVihoHjlfgsp8Uu0tYWMlFuJJ4XQniIdPJXeppRGETETWIEHBwUi/Oz8mtSuKGODsJMlxxgox/iPRPYqF4QYaPzj5uWZUoJBGJ3OtaaE8TuYmiQxyC8YIMP36qOtFk8cLPKXy/+DwBSfIEfnzS7KFa1xdBQwF3OGi4xamKpXrYkT5LEDixjELFG0okCRW1Z9BOpbCcy0hB7jfDQIqZc6iyMKvkBBJQRNhtnEE0V0g0+FXRW8MrnugdrhbkOnFV+CrLtNZoV4G/UnxsuS99Tqcgg2xFztjNYiW2C+x9MOCxoQ2PITqnYU08iZ8H9pCbAlm6iQKhCJ4xjSr6GUFlbiTxuAMyue1YSqheUmzw2KF23ZZLkcrgaVIux9Aon84lBx2KfIxIB4MgF+ZiGBNmDTqFDan8oON3FIV8/MYSJz8D2tElLdB7NC+bQ7STJEhoZNFNUWVAxMtMwvhxnB1F0oWI4mAysfqx4QW6ER/ggI1tD6Wgz08gI2QXFyOiEh4IpBTc0Ilkx0ZBiAkx+kVQSg/pOZOJlHGb2ngP+jjZDT0scRW0KBanKA+ZLWH80hmu3BiU8mDPJJxOQSQNOId4D8EoIu9B8RT+aYq8nHsLxFyAAZXyQ+FLrcxEXOmm70o60EipgHiH0J+ftEjXj3fin7+0cDDNRMi7o4ZITMlG4aC364lb8Z6Ut+A93psy+tqDUL4uMPRBlPfCaQKssNURKT02dRLJ9HKNTUZ2si4rN58M05Jk8blBGopHrujJ5f8uq28MRjPHYJvEf/FQ/eiGzvGEXaD1JbiC/PoPkylDuOQGYNChCxBdSEbnyvoiZkY84ZcYJ35IpA4ERAcMiatAVIlhNBq7oEkMPA7gg9flFvKYpKpMsGJgMAMs0gGXAaUfiaj1ylCgEQcmUA1VABCLJmRiZkOKyfIJ8MNLmbgroiLuLMCo6pYB1ecREmrhd4xlkdi10UtHel5aU6VZHgdlhOrFB5iIfaN6L5YDZEy9UsiU1XrLxKtDQOrLXLQqPNt+AGDi1/AANRCG5SrjF/xuW2JMD3UoDmenxRpIvNjjIDitE9VUbvUUUesgGNQNw8JixXhpp1r/vZC4nQrm2pT7YjgJSD7EZv/1R/CoVmYhx2IdyEDZj51uxFIzYKHSy96jKKzJtOGT1ST6TaKbjkMpxrHN7TjvImCziBi9iGHWLJGMKC0xiANSFSEO0B1SfXZi0nHVFY7XLMqSczCnCGeTci/Iwvg5yKc6kJrBplYsQd1Xic0gIVZKFOULMVhMfygOC4kHmOOKIYcRjk5I+UJE3PAwNQp3CACKSEFjQcOZhpOpFJLThdwImQ66uSoPuRrVE6ZCBkdiufjChXbUFP+0B9k3kikzGcN43/Y5PXQQcr7TTTa1yKOGePickJNvFlc+sH+2wpBHSC69XBqADD/f3D2JEuSj89caHQYYQBLGZCljkODLQDzLRSWA9orIbjkZ2HK8PhrIaDUZN1SaEYvToirC1UzClU8lSrgOUHgWzzCzKU4t1lVZr4zIMjVNrVNKlESyzvUhPKhBKv6kqnWDSIfW5RaQaFKNwgg/Uhw+OFWRdOaiFhYLgWt2KcBIoopgxcMkKIWkakm25KOxExKFNCSYo7q55nhiMwKdGpVhWcd0NW1J12dalU5/Zprj2kjgC6JG0mHl8V7qECduda4Gcxo3BUDb9YmjofUIJeWiGyHFqvUGG6gZwYa6K9gIOwd/G0OPGodUHFljqENVnUjUN1Dr44x4IQ1L71dV8ocPBtWGMBuNAAs1FgQbnykDStOWqOlWlBW1smAJUJWaYJRVg0QTYmTYslCaxRATxotvIzF9zzJLCaipVibkwfLjYvCAqynGNKNzdTKUTqaItYi4KCAhJiMUoQH9muA9L8El/cDr4aSnqDBtKSIqM0BlitqAoBLrrVWlWRszamNmbQLKxEo6BRLjJtc4wXWJIXPhMa+mYkSs+Lrr0qt/7S6vGe+ID6X46TK9ZKw7CYFWWLkkIPXDDMcGxtnWBlikgdoQfxoake4a4U8jBAHuJKM3uAEoReG0Y9xGLqQKwt0KvrKhX0US0dr5gFyIS7VzCU4ql6QybjyHl/3Q5QasJ1qnwReoDXcrMaUzGVJxWzwROyIZHlNENIJkvG8RCREMjYawxAxYWgLHCC5aXdx6LsvOECWxE8m5JBwACpVut0zGeUNTJsthTTc1ILpMUFNyoWvJlixOjNHUm05alrsTM2BdkNgTK+6yLDWPCkoQiuLuOkuWheoshaW0wjzVn6ymUhspBgxdpKHkDNKkCLxlCp8sI+aNodxGMWmxi2zHOpbWyRaCG9ykEs2UKuTtapKhp0CxqhBWet+1OfCsQCbKQ7JkjJBq5/HpeYR6ljSFm8A5yOSGi6FQzJ4vXCBc6B3o5h4RHrRl9PBoZ3h4dH2Y7v+cppEJP/DcgitBUwESEcORqjqF1C4ZY8pA33gqxdo4abZxbqAwt4hDfJYChXkqzQS7RMIbdYBorgtf1MW+pavpiKMS1Lq0EAYOD9Ouq4uHQl3VkDD04GroNNUe2IA100UwkJ+GsXBQgQZwkeiXKcwLVqfWMUgKNMgJfG7KdyG5gSN43gxOR10eUgQdvF3o3J2GWz1NKB8tjaLNTkKMMzHl7tVFwXo+yjPIMrMQYsjaKxaqpzoGhepmoIywrl82vPR0I/wL5NLwUIwW0286gDJFXWwE4yrXI+8q9LlQZbxkBr5Cmsl7ULbJFI/ANkmP91Uj2sji5QdHPxA/tYIH4AXCq02vWqBuVYa8GN8iwHMJf0hPTPyFBTy1C9TyjfRa5GWRCNf4Y8xPFQNoeC7IwgCRGDLP3vzXxgv9tuwyEjhzO9MM6B0JrVBg4qF9KBwQTV9skkfbhU2UcFOOTQEPUUSWum6K1R7B2xuFr6BMb0RCqIMEgo9FBvLulGU5pj5YKVv91sMUjJe1UMKwkUUgdUgt5qnFMk+W8GSJzA1zVzxjVWWjZ1Y7GRXvDCNI22jPmzS4adLmyi4z+eUwZ086UgOm6vgqs8RHsRKiTaSo5Vz9EOuadKzNo0ueHnMtuVQYem3FcucoNVrKY+mXUGynxfLgEAOEFiBNbonMkX5BnDVHLEcaWyvThaZsshkYAJ3mhFGVZLWSJ7GrLZ5rs2MUQ4nK4cFUYlxxZxsCb23otK7AP2WJFvkZumPaBtWqhYdP7e5nZlVhs6ocUmDZaK+VlnGt3h63wyfCfFic14qTY1do8VhkXPNk0xuPw/tpWcg9Bp2RuMs3vrHlEx7O0xUy6GM9M0K+fIwU6Ve9/EZB0qk69WIlN7Cd0G0C1YRyk2Q4LtEEHi0cVH8+nst68ctJgOMFv0BuoIDIVbdA1YkovKpegS7YFNEuEaVemSgobic3QLIb4SwRY6Gn0nc20ScyuExUFdRyAAgiaY6X8DY1e6gXu9FJqNgnekk3GZAHYCIPTJuor1gcyOVOL5yKD+gMjTsT0YbKhq21kykGb6K+8qiD3MTpEys9QDQJGmHFx/OoQ3ddYQ/ShNAsVBfnt24+2nWnq3irNPrme3gPoRTSUPXUuqtD9dX6EfIvd5HUE+PGIYNKV5XXpWs59BPz6Q4srN5lVO/jWa+VAUCniWKrYBFcNKm4POi7g4EH0rmnC6BIwjQo82JxTjmWcFMMxWyMi9mM6ZPgJK2L0lgeX4Dmhjv+WEio+oJW84jIUQ3UBhG1fhjYEWvcqFq8E3zXgPNOOCcuw+OtgVoPfxqqGapvdaiR2igSDjX6l3AhjcqAnm3AXWnTVFf3jNWRSLCBlzpMlNBWW67aAEfZAOe6ATfHV9NwcNiSmlEG78lyDwlkdFkxAj27uUutkBxxez5UJABJIcIKBARVz0GILgWK3QiTqK+BtoMWLk8uVVPKMI4aoJb6nNqz0POWsO8BtLdkfGp0V0GQcQDQbQVBm1DfJXKvJofqyefO13yoGEJHSEYYReJAnTCBWZlap8zKPogbWBww0IDh9JkInaYdjCbbe/04JNrtagLRcDbKWCUyeGqNSCXoJXj/G7wpF2+8JNKAFxXiBUW0aCdvxiS6mMOYkmMhrLfJsitOCW6YBAvr/0zT+F8n913ulssQf5ABfXo7OcDlL2qIghM1DdlvFpo4oa5BPB/TNLtI8WJxVXXhqS0Mbyh8vxHEhZNnFptAiy7CRaIqlzjeVWGlwfRte/2om41p2HnfMkldIgU+5lZKuMHgLcxQYJc5WPFGlc0O4BuYNn4a0h07oogU+ER8ZmjnVa93taxIkxzc4EPWPdwWgoRTkpAEcyMOG9nk8ghOJILFcMjC9dJFyEK2eJbwuMPk/CPgbff5BCQuUNTvwmhNq/nZ7DFtRCOGfBINO4WkCl08zAKDuB83blVhseGBo/42uki8WosIRaxbt4sxeFAfqwgfzSpRAK/ajE0zuVx6MGiZi5sc27mIvyfX/NGWkW5G3TRfKBhjI2Eb5H3Lcq+G9eoh8lUmuw+M8F5qeOAYRtPctseI/ERXCMmGl5Cdeohe6PqRhfC94SZE9lXwRrgJ4aEunIQc5CT0xOwLro+kmcLayabjjZgfEMfTIs8eeMXqrYIBhr1Grxwxh3k7d5jHIo44j3kHeczbqbemozx9HniZw6zlIh3ZW2VTErhhnYQQFuP8UGUtDPnRCVIiezmU78v5PDwi5wPdZAMigkqIYO3EwPkxIgb3+SXrAKg5gfpHQT0UFBhSEFK/EX4zUgpntulWSqRyMm7TZFNuB5xlb3RuI3U0snm8K2oiWTZ35ObxSVYxOXq6Ji3j0dvxoiOv6gc+gZSufi4vMS0oJOolSZtVNxfgBJPI7dBOCo5kFZ2c/SJ6O/1GSkNJlkgqcYoVtPIkTE6kP/bcL/HrCcicGblzcfGZlCsc8/Emtx5cHKSIVdAn0jqEvHkUJ9PL3QlQb54vyMyJnD5Au/lEcu4lZ0fugJ9gTHyiKiMmtXP/XMCRyeSOHjf5YijYxkXmn0rjxMv5asAQ4HDzUFVY2UJPHNR1MaREXboeqgoEE1XukKig5NnrYnrFtEeL+cNy8bBt+RR4+BT5IPnCE0R44CTe4DdigNPV0jYkjPdjXSKYX4XxHLILXd4hqzmF+VIbnCHenolG4DXHZkej4SWAWwxmp0F2BDg5Q/l3HviW0nC4zKC2QjYjliZQeiKQCMwL9UDHgcF4AkvEtWQSnsGthdv2VuMlD+6KNHF6e6X4MfoQU4H2yrlpIqWr3DBoBmZzo/WAuEKbt0E+TE/NtF6j7bUeJjbvASmGE4vjQqLFe3ByLhFvPcL7ggEBVrwI9aNimPNeVJqPq4JQHmCswFKBXwmFot9XdGoxExEdaC7g3Ql6F5R0FxfwimXiDq2cntkv3ugNzGgQElI3kkF/qsIiUor3zJO8z8iyLT6KvO0CmDFOTVRuwEGiF9uuF3wanC3bqOlYACz9Kh7jjVv42o27Cc2gG3jFEHzLB4elaQX4vCzk5sd+cl/1xSK1YgQzHqyVvDODFDs2gP+kc8pEdQkNAd1y7CMbRSCOIhxYyD4aK+Er77Cs/Ku08jZz5S0xJVWHd40kyUWWuCguk7Wka7ZxcfXWxvK7INFBsHkuvGvVyePX4F1QWWi/007ugE5X8DYdo9/S7dRAgsFvgExAOuTyW1VhuYpd1xNAMA5EOr/ZVKFCfNOLGXsCP8jASIEuy3Uobm+lx2cT7LEsgvvZxSVRBigftMQiRUsfHuoJGc7iVIOJtPP7LhzIxpH3HZHl1luh6J5yIhndxkUJqovbTrq41bogFMW3aGjuJZIeTnG9UqFHv+paxkMpcdFnQCBirhGk8FsJhDkkCurC3xvSyQresstEO8tNK85AxaAMftWUGCCum2Cb3LwnvBOmF0nAuBojCUuTLQKCWaUSpKAV1V6K2QFTVD8XOQVHPpzfXHXuQaOrVI7eijvn4vnlQQ1cGif5kg1xcIrBwqZDZ3xw9vtRy4D+MTBpaRRggriyJJjB+OAmoQw1IxzKEPNLTE6GsExwq9ZYNfXwByNkw9TXp/DMdLUBsLFeOsm5kN6g1DHAFF7/HDOLt9eKb51gKCWALutB98KPwVuXdVsh3d+MKj+yI4Hlw7kjZ15LaJdgQ0tVInqUn6hrIzB0iKQxbpIWBDgAmtH/go1U9+pgY50LH9DSvJEo4RMlOOvrV33I+qJ8G+9E7Snu7fHHgSvigcZq4wiFqOJtr0Y1L95I9i8stqsMuTVgrqF6C9fvEjsilBS/J2woLMIbEBEQyF8SwAUWRMKbq4PppMD2qMnCYNOjpvDVjXAnhbq5an1Mp6qpEfgngwKek1iUB98mLRiVrQcAiPV66NcDC45RuNVU2hDx2zAdYSGdQkTQHuQdpFvUKf6dW/WYGnXaby6uMBYQJWqph7XUE8EKGwIxE5tGU7/pKg150YoxmAGz04DrJpEnSQcCK4lEvfU52QucThrviTC5gYWALz2xGPXYSbLnUdNFJznYR6iL4X/pH+yeOijBSkdKKl3EilcTuVonQ00IBxMMZRK3gle5aa6puSS5Bw9uYewTG6JMA8MmeH+XZMSouoJ+1RkkPFJG0Nk2Dk7FySPoRAR6heRlnPSXxIVl3CDuRmJaHICBRpAxrZfETyTpkLjFJwUhKpZ78pgtxTK3Y5tMfCuayUlc6iQ8enjkCKiC5H3wTx4yVYwb6tpXkxksj2lm42e6i5fkX1BhcrVYHbaQD0YYf9Lj8hCjTu9exWMzzd+NyLGOScbtSLZ49JHoFffNCG9CLBTAyNcojljNb7G0BlmV4wxFlWwuhfLT3ZhQTQLqeCU1gSzVEIvnY9xQsqOwBDkKw5K6ykLJqiG87FURiYj7ilIA5gGbY6xLgBmv1VejDvEpyRGLc2oY0DrUVFetGwlTpICYJoWbBuFlD0bkJX4U1QNmoD5g27oXtK2mqOmRSKhuBHB5/QiZtpHyNwl2dl1yoE0yIDsBKgiYwB6h2Cw8oBUAMH+VaBoJp9ONXYZBh9gNIniLoTrDwA0OinmFVBkycng1EtfHeLxTkj1IKCQKggEtY3xxrISFVFARjkTXrforO0qenPjTNOQiCQNKm4CcOXLQn0viE3uuXo3PdIlK+V4/IBx4yAwRKg/5eYfhDfI88NMA1tgpYogm8gMUL8aE71Dzy23OVTceyTK3PI83tqsTZ2yHduiw7QQNvX8v50SZmsaRK3kuX2hEZINJRRYZnZNhKlFNnCaMqdVEw3Xejj7OvHvkvB2qizR3+GwCb0KfAU8h1Kyi92WS7sgPYmy1JNWZBzjUl5cfyjDvBGlIF7gx8ngXNrjcjwRnJZTIRfZ2tSEFUa3LxdHkaki1N4oNtzEJP1DoQfbGKgmYcXhBfLsK5pDXg9J2iYTneBCHhNlAWm6wCal/UMKOGU1FBlR1CVawkiqAYs0oIE+wOb60BTPxZ81ef7CFpSdERXmCLUXISj/sApXLQISYtgW8AYIq03jZ1DhMcDrb5ueGWgnDz3O/0JSGGkVgVzaClkOGCU7rSKgRV1M3h1VuBosUIBuTVO4D2lPcF0XNoaRCbYSmJml0mAqER+GA0nRaYQEIqQgIqQQIddTWkWBroNiS1ZZQ7hIo1AQtPYIx016O5LHyNLOFVH5cxwI7xbcjdqxoziIuaK02Dgcbqy0J4loCmAQR4QnKLVEE0P8HKGhD+8KPQoqYbXljtRWBcojFprEOQD2qM2kHoJ0oEFvJ0A8VemYnSztjxsz90ghwWx1O0qb6ufWPxM/vZaHWamsiTLyxfSTGKjAQBtEK4gFr3UBqG7UxQK7XgPJUvssbkOcLPZE0Bun+ibkxVUJj6G4pDXgZjYMa5h60PcUWMbQfHOTTgy3h8EWckUwCEKCeoTu+nvAvxXMiyAuSRwcshCAtEcxii4cnOr/xU4j41JZ8W/BYJxh/Kk1cAStgy7LuoVR+HbIPMWMtMFOTuRMfPPTm1zCT4hVKNIDpxUb4EccuXnd8bSmWy3Y4sQ/bj5vKcH2NF+YGUg0JbxF1gSgbKRAjqvzNKPgT/saG/zFi96CTLom105VTKOAPMSF/J0MYLsLny5jJXeyYEPTzl2roEn48BG8ONYH8S0gdYZwKIY7kVGQBm8IOa0Xw2xTKtUKc6ecoxkd8YghRSWwl7FCE/IUSeXwAceIQ/kvhF62gTaPqy0diiKOolgKPEZuXKjhYMljiMSHgvOBYJJlvBQN11D4rasN4S1hGV27s1EgG0I3BvLC/NmKOCu5L5W9DNNchGIyESC9oPWBwXuKON5JqXAL4EUra+aamcJkt4yJHw9dNaIJaCsUqonqMCkeoHc9ZyDF2Cue36AB2qa2QQICJu4SoMCyWLtx7EYcYKMeOQtQZ/KgrpdkTR2EiNyTG8A7IUNNzMkXdxqcUsQqo3cgnJSNMtpMmGg0WU3Njs80E01OKk84t2C6cdIwkjqIInUK1NVLrRPB/skMRFD6fTBgFpFoaE26LSfoc3gM2G6d/FJOWFbJ8Ricmj1OFECPE+lylANDKXbCdwhMI59lFamuualDIaF+cpPmm0N8GeBP9ZPTWZF2LnLKfwqUYUaW5zN64gZbbcLtJLBLitvhJtdzWk2rFsOYKZwPGkCdQE683rVYv8nVy7OtkC+mURF7FySgC9yExkEJ6sHwr3Z7ERTZCQca9uZGFDWPU/guiUyeFgVp3401SbtgewsoKNkUu+RzSzbMUI9IlQr8lmgH6DVuUtGdDqbX6n/pKMCXW/xTUf1Fvk9WUfOhyclzERjRVtERsrIO6Ew+f20Rql19B6BJOkF4MbQrHdamahNs/hJFLeXRtimVtJN1oJ59oKJOtOgmvd70s+4skAVmZ5FdHbFjYlWtcyxlvjWCGazO0IoZy186Vuw5SSVgVuk7MSOXREwNm9EQRH5Gg1Uum3KSVcRqmzMKKnVRKwNCbkIeKIlRtLOMnMfYuGEDfw0Dc/WzWvloCRRouaoKJdhuozMU1lhK3vzDcTZbxeFtYiZfYBotOh8+m92+ZQi16imrNoMxnkDaQsMuRc1eTc5aNU2N2YWxoeLjGtNmi9wKdXDjTDj7TZBvuoJmWDdU5zbSbzzTeo4uSO5xNY6bJaN5P4aldfEpVcX9tIrToJ5UY7595vwHadqkJXA70Tz2jA477LlKwao8xr24+rxR0HVhwHiWaalfteB+J8JkyheoRPikxkjSmyRdKYuHVbQQUqcRQ/Hg/DDqKGvoCNc55EIXrSraxtua9oIEKMgv8jyJapymiJXMFuj4TzvSQPZdfN2U3ItzgBUncj5Kc3pxxPqBWkQKikFZKwBL6bZA1JIzHEgRuMFlBeFAB6cGrVbn/mOiacQExrrn1wj83LaVH3IZl3K3LRVr8ZkExDn7BbiiBohhxb6pSNNqzxQDAUxoK8Kha3DjGhf6CIsZsQqQUGIFEoMA9pDHzZqwOJURUT4RiTMhc1oYSpiRV5kQudwzHyCvwccgFRclCgcvX4GhMhnlLEhGAXCJytlngn8I/MYxRIwFFmc49lehKEZvwTzakti4fN6chs1Cv6uvu5xdkBCl2UCDo8fHjt0KNKS08GMZ+LwHb9PaSt+iCm7vkbB3mfv/GJ4sZjjXwGQfCre8Wszw4qr9kvWgKFF5u8dYnSVEIr7oUtZeXY1LH6yum8aCK8rP8DcG/PnqMvv+Vz16xj0Vbu8U8B03iXos9/rUFHpE5l9vJ08RrarydXByf3L2R1wxVHeKPelE7uRIfiff4C58wXlM1PYQoBgNGcTrC03ZMK/oZXkykpm0SH52zFLLz+A2KPsfILd5krVJ8O4PnirIquvMVc1059VifKGZRTxxjjAInJXFMRkhBdGJDF/yeCElKHiLeArptEWd5BY68nXxAjFhpJ++MDZ6WileHJGoHDCdojbcXF3sPSFMMfsQXrwK/BOIKCdUUXB349dLNfsr4kG083r0+hi4bASSg2gp0aWzIzp0u+JRyJzQ8ovhtf+LadmOCUdyrI4hPVu0TxrTjzfHggKTElcnU14j7g1UXoIWbDfcwBd+10RzYfD50u4b+bqP+Om/yS4J0oGbhfITTCP4JIb+p5BWMEQ9jCKFD733j9QC8hDHp9vG6awzOcAG2g0OUx+u2MSFbAdaDaWm8LtdKS2Y69yITgKNW/mnUGN3RMm7FtCfz8QjAeLqj9YQxco7Y0IAlj8OeDf2KkAShqTBulnfiCpGwibcapPnZh89o/s6jQKquwpBrDO+N6ioQHQG0RSoaGYlgFxJwNjS4plCXLq5fR9sfF6RwG0JX9wlYg/7QCsB6YGubaTXcaJmMjhLu/6/MN2rDqzcbc03XtU8cA5ODtAhKSBVTbEf3TuupVE7BAHhkecxLk1cm/O0VsqMWAQOh2dGtRwnaCUWiYR8dYURVAN2BMVvxVg+aMGJSlBvqo7abrx9MDkwCnVrQYoj87hVxaGHjCndIsqOi0Q7YWCFldayci3Ix6A/1G+ONo6Wyz4MOYbiDokU3kAVdCiKR0WP48vIJd/IjiEJcAX5BbNyYAoXW1NQ4b+BxjMfTMhT/reXqAVoANKtE5UplY3qDC1CIRAvQ8Yn0BpbAXqgnjsdZL1DtBYSACsllNC0XV6RAbwDnCiHmPA5iIrpX3ALZ+dmgiwjVLMgjF9fDY2l8HvzbuHtGIclxXMbKGUvkUG29yfIKVgrpI25GQ8/2oMIDARrr66B4VkxviENBNQe13T0DuUB+kawErfC4VYQhXAVUHQZf8pp4QnWO4Yv1T+jCLsCXIfhCezHwtSN42mPgG5eWzHQ8+KK5oIKWcng8xQ28Fwk4FQQHO60gDRO1RQ489DnMuvCBJkME5HLxuOcGYoS6cAJdCMvEBCAsQzoOll0GLMfhIp+bPoiHUROWXRZYdgAs14J5DsvMhGUHh2XkjGNIG69z5f2wIimF9qYe6OWvjegs6MaChMghUDXwIseaPFS7YqJQfnuseXhwqkKgMHykOg3kCzuO95LOU7xe6Cbey/1Gr/EoYryblo7VPn4pQjfvgRKr2EIidePVhrfS4Glv/C96yWehl/6VWoJNbAvavMI1HCfmQziHnHiRB/QwL+QdAyhNJrs0vW07eSV+bg783BYaaDeDJqimtE3lruw38RBeN/n5Zo6vQGdtGO+AbYxfoITY3KE7uU4km4hPQq4hdq4YtdMK5WJCIUTt4pyXQW8CjBV199vRWJrXSdMSIhYN1mMMFxuwPBKs892bi0H1HbiAaOf3N8eG9tqDtA7RIYaIuES5wY+fi9YVVFVLPieFAwC0Bce4UaPNLCSM1mkg3RHlw/42I35j9HGgBR03ke2xU3XkmcsfsuXSugAO5pXeRDFaGDSHyycIbqpE3FLGM/EYz+O59dFIUyGH+6IefjsgR8K4Tgpi5SONNLyXvZx6FGtUYBDXsKHFYIBE4BUGTUqfsGcRchIK/4FGevvpZi1EVbLeIZdDgzmTOI+AS+iZxg8ZZzBBWwnRDKVMmvSfQER4AYQ4bIRcMKmyCRrok2h8vHujsZqic4JOofcCTtE2TrAPqoV1MBgE3v3FnKw+FEMOc7b+/x73oKKBreAa1DiOAeA8nl2w/Vd2QTVZBQoQ24b5dKQUVbE9Gd/5cEIBnPKGbUbDdmRADYyJa+9V7SZ2pGPKkftPPbFgTmb0BK+55j2ROEFlrrCrt59ZVlZlZL+BW8JuQE08d8PPVWimO7dm5ZCD8XjECPHw/V84iScFVgJEzi8LI0cyfq7w8V10VXAyjHPADvl2kW8389HdGc4UoKHshKsdnFuQDTbOMrV22lb8mW4podNOEXibn4exz/fFPt9m+Xxb/Od0uzoCBKOK0A7fRmyeuG8Ur1fkqnBFr6EouQ6yNsHzNY7hCLHu9fn3vpBCBg68bWIxgPVxxRg+ikAMxZG05CyGgiQH+gQgqeLm7AonVhzdCbE7Lk6lSPyqoVQeWwWlDpAKxFKE/Th5hRZinFAxixKhonBCxcZvdGYUksltcJIO1IPaYjQbfUtzbEAA80t8nJvFOG04zs3GON16QE9V3dACXreYK77pRvcroFNiOm8kYCKvdnKAV51Os5EqMtCyVeEQx/PoJjU7+iCKYw4XTp88hi+pXSAg2cIm2sX62YmXt3CKioFGOfdvR5dM4A44nwiwb/KJCtEpfBvYvAZnqBi8uxLjGvH8aUzEh93kQuz/lQvB4Vq4EBbjQpjBhdjjuRBFXJLRgC4DwRmMLRkSljFeiaHJO2eCef8JnxAvvFlsDBs6g8rGoHCIyGrYiWlRiGlRONOikJcb1w6HbIJ8t9MZBXwID35DpdDEjJiSkIt4Vn5XrcwXKNacT7TKL7S4OIb3cgzvsmB47D7HlyQuaG/BMb04jtF1iqpDBt29MmDTNvkPB4PXQMdI7OushTwDi7anGHCQKuYpvMMHXc3b8ex/PGaNkxQKN83ld63pTn4W8ihrN/BJsSHdRMFvDWCmjueFHPxodJjg7DDQkU582T+CM664HVhbDs7QoAWc7SY4oyMUF3vE4SR+GLuAuBLg7DDB2XFxcCYWOgbO9n8EZ7sFnB0XgLONw7ENkmLfWyDa/k8QzQmLWhBtw8tVBIckhoYDRYLRcTGgtseA2mDGHd2JJ7YCtf3iQM0pmPgWfaJh3EZCNiZESnyPIXCk853g4/vY5eX3cypIudr5J5RrFyOABghV8/Xx8dVyeWN8m1KLbyNe0s7ZS5MysoK7PUZ9mMI33gXlAkaH7qPyGmcEQWsDCkJoPSVqnxFoQ0ryP6flePDS8eDF48F1wfHg5ceD65+OB1dMtnWRE4ILYLkniYvz0gZL7KrNElNcZM5tizeYFKUZeSwZt97wTWf7f+4MYXzTkV8t45uOcXCRjE1nMzed7b9uOvQ2s2w6ObbpZGPT2S7YdIyfIezCM8TOQ7zhRpP5RmN8ozmhPmOjERClq8wYi6BQUCDzD7tMJgpVNveZjXNZsM/k2D6TjX1G0d9lEZKOAMXSoE+0K6y3SADNdwzvDd9kjG8XJjaZi0M4UVEeA55JaPlP8Eye/i6CZ7chxTeh2UPQ7EFoZgjNvDBBswsjLqRzeaqAZpcBzS6CZmaFZpcFml21oZnFQzO7GDQzvt9t5hFpEuEWaP6fgnMO1Vxsrjo4MMPDPwvOlRgKUxWDPDIE5/aY4NxmSp3Inknhd9MZjudcJbePVHLVfslp3D2NVAHasjEeLzAkA8yE+OZD58ox3P11DI+ZQ/7ngO2kGPtk6+Wn+9Byg8zKMmD8D6qB722J0/dyrXM15CD6XiI344vQ9xaFDpFjUDxehYAQIiF9b0Zo96FPNJdqUKMy0PcOg/BymPS9hES7bBDtOFFmSuf2WLiJMOBhyBFXFFkB9Gw26Xu7oO9h4SWjE/H0vUzG+T24Up+c6f6FvlfIKRlA3okgLyHI829I2UD3baTzRgL82kYaXIBXnU6zkYoZErEwBkGIeQJF2lDxNobiUJI8kSgiTlhxNg5gQRwaCBUE64l0Pw5JkHgF6LgrrsXUEXlZ5C0UwlgnF4kLmE1GMRR2Gs2IjSSZYNMDbwwyxacWoWpiHD8aa+ECfpS3sK12C8aQEpFzBqTIwdUCoMq/AqjyHwBUvjiA8kk3AFThAKrEScuVf4FTJQ74lP9n4JQZfbkInCr/EU7lODhVrHAqWeBU+Sc4VQScsgvg1HsxCIwDEskCrgSaAoov9iGX9vBFZri6sgUts3gKAzC7KvPTmPwnZRMpiwgEFCiOFlriR55EbsL8VJRo9RKRwJB5o4LAYEhgEPEQIzDkizGpeHG4hcBwEIEhI5PqKECrCCAwEBtbCAxEf5yyQIdhMYvxfKqVrnfwASqcU5U4uQHgaJIbElLZNj6BYmySgGJGFIdMFIfMKQ6ZM6sOojgcJrvKkOKQkeKgKw6pHDrycYqDJCV08ZlCPajdpk80TVQO7gzG39pEh0wyXeLkO82+S4iKudgVXT70IlXKEHJYr/dmxm8L0JgeKEwUMFFD8wDFb+ShO2Das0kn0CNOiaEX4c0u9F1gP48hEeKhPvCiLzJqlPDmJcYvgFmO9lfSvxZ5gRexMaiqxCM5ioRVKLeDkDlZLrVhrBPefIBxzBXu/WXj9uB2cSCjmo+XlDoxnPLJvKTMS8oXKyl3YgiKj/CSCi+pXKyk0okp3DtN4f5sNu5KRgyujC/xDXC5QkkLpPsYdLURgj1Ut9HDaFyNAAc5ewuZ2H16crWXufwAFbBcvycJsgWICrLEMstjKBmUb5ppMiYLxNLIHcI/Zlrltao85vYAJO2Q0EMxa1BQAC6a7lgjwjyK2+vxIjajCF1kxii6PRWxmUVko8hljF3D6NJm3rSM6kxcsDHGdcOKrvaKhVqBdU1QmCQrXtFAyNGJ32QEgIirZCN5AK6swtfLhuuFZnISRRPkQXrwR+aef0ByuoDx19PHF3CWmWx9XFyZjVmuWBbdY+276FcYH0Zou+O/oruOJb6ksMA3cE80gkvsBvbOjgeDMRycDoUDJc3Kv3c9UEgjv1jXA9iJwEW7Hv9VXNetX8V3PemCrssCrq0rofCdZzMuefjnrqcX0lJdrOvp2AnXRbse/1Vc161fxXc9+YKuY+xJDl0BAxQF6sDBMKkdkwjImb09s3NA9V/D/LxcYieWGL8HeVWxvcFYe2YasfItwovE9gZj7ZgZhItvEV7kf+wNhehIPuu8y4AevX/KslIkTTYcKmECCA0iaYcrIpK60svIlPkP3yY8G6HOKOg0CyoUFd1476b3SErkIeZCgSHMdY00Rn90yjRXfkjirKKMyqlJlC/T13y56GuFn0n0g8TjRJEt64VmwXpmwXT+k8p/AvwHWDtYWOOzfPNpmPk02KiK5lxPLwjZkRhQ6aqO17tgWKPAZNTfovReIqNdR3tFnKviKWA+ucwnFaFKRtQIxzlHjcy716ZIkyXhNrEuJHVRZ7yEhEyNE2gWIE4qapRegrODRDHOx0sFOI9d09t07fNn8HfNiDU7ukM4MWbFi0chxo40iO6amr/57cRQTXYuGvqfVnrRyQP/RZD1Nv7r6v7tvP/7a2WoeMbb0rjKql5aONL1mnnD3s2csjwKj327zkjou+EjfPvIqONK8uf76C392YLRuoyKpiy49K0ta96Biu6W5mbkO37Ccttm3f3sjy1ZNjze0GZWg+adlIqwJTh3WURlYUvIS5UtsQRgDTHV/O//fj+Niv6P+ommasvMsFXv/FROC2WuCoqgYSbC2ONwV+e9qVc2e3F+ebiUVFmi1FEotY7utR09NYryrzCG/FTC8KXxRRaFvbJHMMMeLqPaSktLzQrCdCHWUtxuXdjtGZTyLpAkZZJlBnGBZcskKqUhi9m0DeouRa0F/te1JG1HvbD0R+dI1wm3bqiTv+EOnIsbac5ewDmDMgQt9NR1X4cZ64/+sWJdpOvmt1ate/5ksDOUfv22Z4t7T16wPkzOm6oUKQ2HvVuCNk+RPCm5yGbGmrXlheymAbyDaCQ9fQReloMRv69HHccw9BpAXaJKfNNujC1LGFtccePFvUSG5S7Vm4cBoVGO5ETrdr+Bz5zAq6AngarkYR1HqA5ykaiQSVCEhvcXXlXGeBxQH+rCk4zbCkhkszrmygEFkvQiyqMMYndhxycad6DjFVM8li/eOAQEInlkUK14sZHf4A19tfyvyW0EA0TolcaYqVnqNPdUoA6gcnJYLrnhodshRnWAmaMoWjDqJML4dCG0Usi/zQXkR7c7yXgPAx0a0gUtY0Ci+GlAQbmagEaM5KaA9u0UJJLHHG4lPFAoFQiHMb4AtiNzrthBlw/L5mV3KfyYcZquyjQoH0aNdeYZ7qNQDw2YxyrhjjPCLd/H7+7yqX4RBis21FSMmjM2mKZfprrzgnX0tvhTly4/gmYqFRj/pFy6ohaaxLBh9fhrfFtfPELHM+BxNIa7d+tDMdy9ByeLTP3Jh08mO/2A8KHEOPoUW41uSHAaXq49KDK9zBcSeuhXG6gC4Jy8Je5jiI63BgrvHAkl1nLNSnyFB5HhrlkJIhrd6pABp6M34FSFArU+C9T6DO/7IoEpoSu+eonw2f8bLSOBlkBnK281GDAcJASU+C3ggTdn5CGf3YhvXrlQ3KT1P7rqjLXp9PL5JTMrHlfxv/Q6vgZx065MO0fcM0h9FxGA1eTAaTIYM/pVoUWeFY9qxT+10TjWRmO8Zqrx6lJ+I6JsxGEAeFIJnqwQi9IMEgUD3qk7Dn7qFgptqkOtMy4YhNeNc3ncgmS/VOtj9OyqC4W8ahDdvhAidRm+CZhHwhASbgWNSJEp3UxhF4frEHq96Tw4P7zoTv2bzOHdL2BZIFIeFtRJsphgAre/QHOw4mIXXjLrRx+bBGJo8ZqJPJKIIJAgbR9KsXzrMF04+ccO+lj0KgWXJ0/EJPMaLnSNMCpSbsgvHILJi5rggIIlhRJIW8Nrd1r75cRrFoyqE1AdZFaN95v4SbKkoJAJkg0TZInJXnwlIZjWWignnQSqPIZkf43pkhSYdzT5ih25AVh0WgIHgYXlsgYOU6UEZWYGE0INON4w8g385JFMWdyE58N5hrdpuZxGB6oZsU0GDzDEFwYLicVRBRtl8EwGg6Q6CuBPbFMmIE5EJ0QYlV+YXJOypT5kUcVGhQ7+1SR+2glfJy8fHF8AHtOKCvBb23zI6vn44eXmMGNWgd/R/fHpiOSp3+IqkgvLYVwnRfVxF38/BaLlZ4lCdz8V5houzK7c+MOUDu//a8ef//+h4y/1osdfyv84+0SgT5+aQGEHEoI+fnM5xW1Ih2OuFjoarQ/pJvDIf0Ogcgw1yRcgUHn1/xn65PcfGYjlIl/Ft5qM4fgsIEMCVq/p/xnbKG4+WnGbLA9sah635rxZq6L7jTvS1bdFuDSW2eC7zUeyQCMkKn6HkkAM4IewTheBI5DR+sfPJcElrxwhAyOV8i3G3yGbSrAwGmEh0douxaQS20V4SNqNq61wNLhTVDnkz7NGWkLXSlk3xMCyvvIt42LsJFWOwQ9eXH0zCYYJOcL53wtGRsGsHea9p2EJjuYYkCVhVzESLk2Rn0LmeGu5nam2BJsky8xhcRltwoNJ2PjkJomKeWgi3CToZSnWibx4A+ZSUcEkKsgDZ4eaEl3Cb7BIVJsCsiSXyqQgifSSzFVyiLMZayCijfAR7cnQJTRq7jLaDOEVqmxq0OSwPs3URF4rxra4RG3KE2LTNiX6ZDIuvXSDWBqZD07iXp1mnxEuYkMlojDWiabUsOGdDa02NVoVEJFIDXEYIymT2c5kBMIklJI4/LJlmsm88x/YBWOGc/EzZ1wuzLYjNtscvuRa+YTWinB8Aeo+x2ITa+F0Hz9iREh0h2UBhvEFwI/oOsgwzbV4cIkHs94BvN5JRr2SGliKkXrwZiGf7f8PBom+wmGJUwIS6a9EOBYfHuyc0CoSB7oPD3SxqVCKJIuAsQESW4nWRxsPE2t3A7+gI8hmkNgUJk82T2icL5nPF6/V/JRjDgLR2iNwcYPKi851k9gJ30TU1iSGBs3anMbwKBq178J5bvK/57mJMc8OnGeHbuf33dLs0tEdpFiBAR4CtQm6jEuYu0LCIUh8SCJzqSUXnl04vpXGVY1AyznHeF/04E1WkzHOiRR34YAcC/3LDXDWhRSU5YVshjTPrv+xb12xjVtA1dRoY/Q/NzXtTk6vdv2vt2dTFlIkXdjtPCg7TGg2CpOi4RDrevmgB+oPXLV7XTjk4N0FAC2NvYXuYmRmtLWzfKlZvrz2ol9eS18WwZekXrmgcXdFrIrKizZeyRuXqQrrl9mWLy/aeCVvfHKQ27/DNKydc8qYBrte/ucXfLpwenYU27r75do9bFs06ctk6uH2RQtfmp9wtFYPzbfYjmKdHvoy2/LltRf9kvfwET42O6zYIeyHdLGZqmeZqeqLzlQ174et9kzVs8xU9UVnqpr3YxLNFPTjj02HZsLUEPiiBHPqto9GtO1/yJQFd7jOiD3eYVOYblnigBQJA4PiMNc+EnKVhiiOhV1PHR9yA9R2uQrlz4lj8vSkniJWoaMW1eZ4hbu6caqNwIaC2KM/FJQcIKpmpSEPvBg7Wrl0Vr2yayKQ7SlVWWmp0SgF2LG2eAXGCvEQIYlBJHg4dP4x1obVb+ilXrJ06sMdI3hfVlxtXuoAK1VdpXxnEwyhAN3ZS9xxwMRg4Rlnk3vscS6gSw3/45xK8lj4s3IDmxYNsVpjZ7XGjtqK1bhgAWF25yg16e/If/8aLWdrf9tRUXmdJl4dSLc8uIl7RntuF97oIvNbsBHbunmgGfLwobAu1i+9/CPyJkgdrx+bwC9y0qXAN0RJ2wihco/VLkV9+ZQJzAg5rqU0Zaotj9t+0hwaeYQrZWvk96UograoFiIRVek66bNP7un05Y/XRroef7bVrJ9+vGc9VxZ0feTvt+78oeGHnSNdPxu4oV5YaolC5xfPBZKSkh7VgJ8i3+4IGXDK3KUHReS9uCQ/GuYqA4oVL8XE3KjkipRGVKlUtRtltUi41HtOsl55Zg2RQXg7XgPz56blNag4icU8QR398xuWCvWJOcWBA9zPjkOeHIM8hDvx2jgbVCnwLTWujDE00pII2uUy67G+hFX6Dl8vhffyBYWXUvUXlr7AJHG3rODZJVmVTSHZGKxi9tmiOyhDCxa9EdrH5K0OJ3I1Y03NqzQpIhE9Raol4zM1Gxak6/CvU6d8MLIaZjwmH6NFIqBANwf4r+trdVjy58fOrY90PTRsSJP5kQm48r3rffH1rS2fw8eU9xsMf+RjUtwMowortLBqM/7rqg6MdLnu2d3weaB+g9BH9wVR2ZOY9+nm0O5CfPxgV7u+N76wEh/dB776+MEJX2r/pmyiOwZxRN/RwRObBgC/wEEumUF756VoHIP6Fu82O134RtYtn5iAUvzHvk2aKi2J3QYfklXzv66a8ylPh+jAKOyDJ5++u13LCHbqRGbnaxcPKseRHlJvLd7efx++PbVpzZ/Ze7/Atze9s+B1NvcrfNth3G/r19w9KBpWrdU2TLv6zj6zZ8Ah0OCbW/M2/jwbiza+etDhAc0q8PGlo8u+vHfQ2/h45ajjC6qv/x4fm/xwMn1I57Xx81Jq1cBJqhQpAwpLWiJCODL9xHvP8KNZjuvBA0sLT56uegMGtvD6nk9U9aiP2rPWb/Q8WZbZDx9TldF3Bnc/hI/DMk8E67Waho9j6s/6zN/iYXwMHs69zXf1QHx8fPzode+/eGV2GDdcXCv3bly6tSrcpCLS9fTeQ3fm3NYHFXNvv7rz+L0pQ/FxSChz2ls3DsbHuWU7Dnna9sbHZodX6rZGl+DjgLEfHKpzFWn5rh7sH5B81bRomGO1uMG0GdPl4Oh20Mygw8sOF654BHv10zXf7ap3ugwfc5vOGba6ZgU+pt/6XPpxeTE+epZlhN64txAfS25t2Gz2HZ1rj6Cr1uHAMzd3mAwVL7j70tyBthLsU+bpcSkzTkzFx8U/b7nuvlTq/z1L+vd1b7wcH799bOPoDxYexU5fP+pIR9Fp2OBWDSLgOqBfw4j7ZEC6lhUN88BQ4s3BKNcqGndUSmUYfEtaimg9A5bbmxLbziwQ+IGsmK3vRot3h2UbYhR5EtoPGISvZBzpgFtWT8zVNQxgIBOSsmw1QCsfAbKRRDiJma5eVnYON5g4iSfeSgQX4CkMeqrGtiVHRxKdVjoLHMIe4T0vgR+Np1ZK9VsUeTmCz+feoutPwmhTXor3rLdSZrxN46fnYv7MwqS0JRwVQXsFYAcoB5/C+ETzSxmLzYwSkWGH4b+k2wr1ahp+5duGbAaqDQfpnhJ61QJxdZc20ycRr0cRF1QHnAuHeddVRxQ94qEhWmSbdxkeqDgLNCuuqV3Ybbhixhydy54URW8BVDkbk1gUEfMjylRrogw6fiLFacwjp00sYbvRagUKloYtb+kOmnAMo5Gq2bzmNuL9WbajIQPdCj/5HyGhV+2TlECAVrcWAChxACD/KwAgJR5bdvPDd7Zl94mHDDQk7SJNNyqe+2jRHRlB8tSDJVz5tggSEMYJAsrSIF8EFOw3F3u3WGyFZ2wzMypEBr1eI2DLChH2GERweEAYwBuzDKDg8CCb8HA0Bg9ieSneiHfJv8PDxBg4kM3A/5uQ8LudTFr4RahWhriWccsfu+dOsQkK6QGM6YArebflKngkF7pWdfzj7y6XTs8e3M1CblUibANAbDqw/2+gw9DA8q0tGw2ahAMEFa6EbwHRBxUUsnQdn/Xg1VUdj10bJP94M1/D/KJY/roYY8C6/j2lVU6PtN9M1qoSiKIXwyGlFmmv1BZly6tDitlgJEguLmaHInwVkY4FMCuFf8X5gyTYIYVjRZmoJYvdhj3eTqfNJvfI1ednAfHT8bafpm//ZDcaX6z++pXn6+1KxWPisb5/Ay19D57sZ5CUTiqNWg95y+W7GHcnUhqyl1pveoY3ZTGamxyVIrgtiIhDDBrhpiOGuz5JZYGclSXquGIx24ndsMxNgUV6d5RPnWWQYeMrVsGpRaWUW9BYtjwiAmfu612umh4lgk3WO3IoMpvE0Vm+AmhBf6MITq+re0YMcgEl1KC2j9clIvPrKXGkn72Uag4HjVhfaKYTa4eAH+rmlje/yIoyGe+rRj6ixvjDpgL5J8W/QJJA6ZMRskWJ5bIhogTsUJNIUUbIDE65IyMkR5HmUm230A0VNHsyFXUIZMjfOdBfeAO/GFrsdvJz/dvby7Kh26ZGEONYUsbzyjziumOoGVUg5TYrVb8yz/oxpmIVocLHSXRiyMXpe7cBujJjYeBmPZD2lIZDHo5V8arssPiNqG7AJ/i1pTyNA8oDy47VYm1h8RsBDj+Mf5aJSa9rrlaNeYU5kDFeHxM8P3Ax3mM2IFQc4nDiyEggw5nZk/jKLNso3WFFf9EwNzcTaeyWDBR3KdLyhO0Xb6IDI8JJCsHZOCKoA6Z7j6HIkU10BjjwuZI/87Nkk3mW4BOMRhTaZilUYRZaE19opaXQCrNQ2CzE8LZYhX45rcJRtgEXUpe2AEEuvaR4cq6+rHiygTUt8EnHCfCRJ2odqcXnatitwu/KBciKHCldejVaccI/PcjpNfCz+MoEvOsi64wKKidNImt88wzOnhRyd7nq8ZdWh/gsbaSxubu0wbOCjYGTE7p6bpNxaobwWvRqI4kR9M0zb+ojUcz7VOSVQuKcmQCYCuOZJ8zh0H6N5q/EnL8ZmyyHd7H5+txGmlbEHkhPbowt6BH+jFokhYMkB8iI2yFNJpNa+OueBFs/xDetQqSQTd84IZdjGw6KDsp06o+OztWnjOaBOPGKy5rJN/ALOGWgWWCSiiYZSzSqT3wUVoe5PBrQSqr7Fj83VnDgh2bmaARvNxmwYqoP91CWEKWaZapxfWOifNrU0L4GiyGNjSvWp3sGxz1IUMV3jeaYIu85uCjJsxR2uhyoJqGH1D0Dw8TKmCVbwreWJXrFzeP8Kxw4/ySEty7HwMqJ04iaGSvEBjFQuNRdTy6k6N1i+uJmyaavdyKxED9bxPIXB3rB60eN1326WwnKGAXJ45Rbodq6ZywQ7vAatFk2MGYU2oOyV3721RwAeNkCs2J9XJNMPg6myoR+jHqgrzkkoDjki8RjJwJVzA35I6EE0kXzvRQgYP2BANSubztkbh+8StMH5CSg40goOYy7woNX/iTCCvmAzktWE1Q/bhE/gDzVcs6oZbdZi4q6Zg/BPO0oaNxDyFxQ0oeMzbPikGVPhc3Xiw+JPcW3oPl+hngfDiVAz9YZ8+eB3ohtQjvIbjITtNDbnJaFjsYgygUACtnAWJClDMU5jsGky1xUV4xzUL2leCIlwBQR0YuDhB0QRl24YCYtrCTOHZ0wFlaSWVhJf9jgJfkhdnFeUvonXtIDYzY5B+eFvKTTwksC9L8+ifhJWcjjyb0vcEqMTI6izzE0FqaLkL19UQY6md/KoTILm0YCQF0mU/V3XPzaU+CZ4BkJpekhBfa6ahwQdPkopG7J4B5W2yUuDvu/x6WGpDjuZEk8e2KWLC4umhpVL7bwMTZyUEbIHsZYjAYXg3YcCLdwIoaYVUKeUZuNeUMyLg8odvW0bHugJolkk2DCepMv86MTc4OSwVGYRSDjfF36p1cGoHUsgnMEpa+31DZAMWpbM/omqu0jpygaVwSvAx9G/9yQoS9IpKDj+NKghIEBt9y4+R+F2pzfqC3JBnTHxcfs4rJs9p9l2aYgmvkuIuJmcaLsmIibxQmzDRE3i5NlM+8qRcFDVplUW916jkapr1jxVI3Si+7QjrO4Z2gujxqOkCOjVJjZP5qF59xSFd6ESX3SeHzQFhNFSF7DVQBoOyBxuw4ibcJnGuq0XEjqIcEr/us69vYBX+8Y9wuwZS8uaB+eMTkVGTAp5/Tp/V2vw8dM5Y6PQiNG4GP7zx3Tzgx+Ch8f+htZtA1aGKqL1bXvoWjh6JZ/do50PfpS9RWJa5Kx6LDA3Pq/NWuLj2lTK//e9vWd+Lhw2sijPzSbgo9/6+9kfFD6qkYG+BL9BbIpTHb0GMpVIi/RvNUhuvgbGwJ6CwqVAcENiXBpyL0Ur4fj57vlqrLqqOouQ1wWkzmi0s0dS7pRJYcozW3hNKkHaNnl9j73fwikxRcB0jP/C0hjwInSawOgKMqC8XEtoPJWTJLwClnvmknDRw7OmchG5gwsyBlbyAoHju4/aNS4kfCUUzBCPI4uGDVkeH6OkcofOChnRA48jRjRf3ROQf9xI4cXsgk5w4cOK2SjCgqHjeo/jCdyJg4cVMiG5A+Ej4ZPzMkfS8VHjFAvGdoa/nZScyaOzhlUmDNYHT1q7PDC4eNz1JHjRjyQUzCWDSxUR4waW6heMlgdMRC6Mnxg/sVfqqOGqJdf0V4tGD5y6Fg2cpQ6ImfEqIIH1SGjCtSB6uCcscOHjswpwFKXPKQ+8GBhzoWFxPDiysDbBwsGjhg+WB0+Vi2AcQ9urU4YDmMbVwjJwoGFw0eNVOHr3OGF0BE2tjBnNDPeMxwjyxk8NAd/B9M/OaMLh/WHvowYiMlYDwpHqUOGF0In8nIKRubkx+eMyBk4dlxBTiy3cFiO2dtho/IHj1WhfD7OtTp8pDpw5IPqoGEDR2LJEaMGw7+DYYbY0HHDB+f0z2MThg8uHNZa5WsDcwhLMNiyBJdjizCzOQMHDWNtho8cwi4ZC4uE4x85qtBcIca7Qt8WDBw8fNxYvqD/Vg5BiRoE6KJf0UtsTnw2ZDgAUdxHo4YMGZtTCJX3u2TwfVjskqHXqAB1MDVt1RHjAAweyFHbtlYH5ucbX/NZxqGzIQPhn4KcIfkwuIEjB+UwaIrDIC0jtgydGauOHTZqgvrAwJGDx3ZShw3MH6LCLhiVPw6XsbVZCNaZZp5DBOPDFp2HkY8YcY3oQWvoGszi5TkdoV8jIX/koAJYQwBNACt43aajCjCcD68KzYmPmyhsDerFb/EH1h4WePTA4QXXiPkYq7aZSNn835wx4wbmq3zvjY1Vae5iqnUgQOrgwWJrxQrR8nbCAeDCD41ljC0sAIihwQ2+BkYEwweIzIkV4FWLfHNACDsXLWFC1oXdEyWge63VK3mx1tjeTbf3v/322/t37Xbz7d1i3wl4Gz3RAIeBD4waz4FAYAaY+VjxHgPHjR07HEYfD3KdVGMfEh6aIPYDVEcLxNePZtdYTMu4LLUMNmqwgNl/rOa2/oMR2xQA7F24HbCKWuB0ZdvYtwMLCoePLbzYgBCHG33ib4bEXlCmZaxUYOzFZrAdJIxZgU7yLtCq4Faz9OQSGkQcZm8NKHV8/8E5QwtycsbS4K0HAgE0ADHsYzwZ8h9UR40kOBuZkzPYuhNgK441dl9rDnyFMFzahWOHwdYuaD5WtQK5cURZMApu8+G1PoGC+Tnj4xCPpdjo4YMKAd3ycrXQl9lSre8EbNfaxBeUjt+CQwpGjTC/FMjxIv3hdY5tjqUGAebLKeh3+X1wwg4fOnwkPol3bc13+DSONtXNfW+8kY0ajWhsrJkW9ZlpPi1tOgu8Fsu4pPY3uPjmURr/uZkcPzB/XI6Zih28BeaJFVfSwOrWVug8ggWiU5QKwNfmi/4DJw4fa3z2QM6DowC6AFqZFeJi55CYx0wA7cs7tG3BRg4cyRieavjnZhtj18DfHDskJJvLF6jb8DL9nrFPGVQXuyqbforvyJbZf/ujsP8rf3Zr/KapL7Ur6c8P4ve4dvHylZrtP7aD+Tbx1wF/p/4eYV1vHsn+apHG9tzZnH1z1Vn2wNcVLGvJk0wvuY4NuvVvtvbbV9nqgVtYp5FN2d6burBejkrmPnYpa7BgDzve8G/W4q0G7Ejnl9jZq6ewrmsvZc8encZWNRvN9Mn92efzO7Lbp3Zkz57pyGb3n8Yyf1/HzjW+hn1b8zRLXGxnSZdVMc89s9mIxiPYJ5PbMfeO5qx779Xs+SEaa3OsP/ug+Tj24/EP2bUPn2K/dXSyBbfNYn/mHWON3+rPXPfNZW2VO9jDf3Vn1a/mMbX8E9buzFL2w8sN2f0D5zNXxk/ssSU5LJzan83NHsaK99ew5mNvYg7H5Wz7HWnsoxVj2cMHB7C8ORWs3uYe7OOhm5j7yAF299SWbPb4zezFBk+xrm9+w+rduYe90NnO7M4aduVkjW284ghb3PtbtvaRK1izazexRnlVbNm5+9nVjTuxotPb2anHG7JJJUGW23QS+2zkH6xtmwks7Zrr2LupW9mmes+x1zdvZK1v0pmP3cemP9Kd/TCmDXtm61J25QOMrdo7ia166WnWvu9n7IvOv7KyQDq7afxfbPBzLdnoL15lgyadYw+tvJPVTTvMKnrdwa75/Ev20rQOrGmTHezzWRPYPX2aMNb4fXbKk8Hq7fqOLbu8hg1plMuW3DmQvfZnDza5aD8L5axmVxyZyX6KDmBVmz9m+e3c7D5tH6vz7Rfsrmu+Zd8+s4DtDWWyzOlH2MG7bmJbt1/BXD/UYZWP7GB1K25hvzR8iaVX9mOXplzFpiY/wKb2lNjZJ/qx11cWsUZHT7Oe11/HAkM/Za98s5+90b8Lyx24i3kyl7NPl6xijhdPs3snFLGyjVPZwKwZbNbYiezNOfewUV+sY21eHMTORHewuY9WsWYbhrK+27ux7V+2Y5kr9rKNA+ey5I8mMFuzVJbc/Rm2+e7NbNuWruymt+czVvcXtu+611mLXj+y858FGFv/F2u0aCcbveskS+l8lp04VczeObyJfXguky20L2IbxnRml7rfYd5uv7AZyc+yV9WH2aXvLmM9FmxkD19xGfP1HcEKXipheYcbs8t3PMUerHM90x88yM58N5MdWfQ0O/jTNLbk8qfZjJ/zWP/+7dja8wms59JVbOjyfDamoAube98VbFnaGlb+o5vNvfwS9lthR9bW3oD5fRK7wTWMtT55F+vxSgkrPCyzdZ83Zb898iIb2bOALatTxZ5Y9CJbNf9Xtuf2W9knntNMXXwlO3vDZPY2kN3fdO7Psu9T2GMzi1jf21qw9oMr2Ij9AXZFzytYvxvHsZvH7GPd+oxkXvcG1vLscJY65DPW3Pkcu892C1t1zdfs2Pgt7PHf67JeeY+whs0/YE8Nb8G27nyNvZ7ah5UczGUzvpzJWhfcwmzL17MJzkXsl7ajGfurOTs2ZgUbsrEXG1x5LXv6m6msTHuaXbfoPPNPn8Mu179lCzo+x74ZPYfVXX2Yub67hqW1b8XuLQ6ze4oXskDSApZ4ZD/LL36TfV1zA+tQksjuTh/PHnghjQ3csZZ9OPN9Fshex/aetrFe45qz4+/9yr4OrWWe1FfYzGaXscFTxzP3NVeyhEX12a2dXmENyzayN39+g93bLJmN2HgTa/PQs6zijqeZok1l7upfWavsOWzE5UtYx1VO5lPT2P5N/djZBZvZ1tdvYDdvf4G91P5j9tPL7dirCxaxb7oMY/UGfcvGz6liw2bfxv76uj17o/RV9l3a5QwemO/Pr9jgm4awn+2rWYuctuzOO6KsR00nlvv7+2zc+l9Y5sLv2KvFbdmQOb8y24409kfIwb481JBd+85ydmfGPNbuYze7uctRlrJ+Obuyybus+pX6rHfOCrZ3wwvMqyWyfhM/Zk1+H88enm1jM+sWsK0v3s5GjTzIqo4z9sz1d7HNX61mrwz5gI3/5BO2R27I3jrVhs1ZsoFten0Cm97zK/bbfWG2tfgMe636MvbNiaVMu7ec7f52BCv5sDFr+fV7rOySToy9uZS9fvtC9t6dNtaizSp2Q/Fk9pXzJTb+lQT28N2lrE5yS3ZgdRv2x4/n2cyv/2Yz159nh8bnM8fLf7HOxaPZYyPT2PnHa1hmZycbOPRK1jJ9Ortp3THYT2+yeSNGsieHdmSXR/uxaV/0ZG2/q8M+bHMdu2Tg1eyj0btY2x1rWDT/PFvOIsyef4jd802YBUf1YA8k72Xv3zuNjR7Yi+XdUcmW3CaxW/q2Z40+W82uPLWZpYzsz+5re4g9dunLrOHbm1jpFe2Ya/VyduwtwFG/Bdm84YdY85oJzKcUA15vw3p/HGbqC0vYO5FP2WX3ediq37uwpK92sEfW72bPfL2BvVp3HdseeZS5cu9ll/aty5qzvqwotZp975zOUr2D2VP6XPb4+m/ZV+dbsrxL3mMPz7yK2X/5m70ffZ4Ny+3Nrm+5gvXefA9rc66cfXHPYnbmwyeZ/6a5TO30Ilt+Z3+Wqr3Fijs8yXaqEhvzzXT20bfvseiAs+ymnCQmOfPYnJWvsbcrdrNb+/Zkjf5MYE8WbGJljmtYRfbVzHHgYVbZbSe7ucUf7PPt29iRX3Q2afC37JnB+9mX6y9ny5/exCbctY8N/2ELq/4qhX3QKYt1T+/O+o7rz/auO8tGLtjKXrv0PpbQ9WfWoHMXNnDz46zF+aPs8Oe/sNCk7WzU/KuZq3ILq/liLhuZe5CtPL+VLXRtYJPuK2R5r7/NPh75HOtc8DDbmpTLfvvkZdZi7Hfs3Y8+YKvZrezg235W+EFT9uMjA1jh/lnMn9aaPZruY5OHLGJSizps2UPj2fnz69kd3arYl3B2n/gyhc3+4H22+em/2OUrmrNTIzexRVvasf0r7mCrVrzLPtmZwJJntmGj7ryKtb5jJluy6wf2ufo+y7v/Fda55bMsqf9Odt57Pfv+zJ/siWtGsIPTW7Oj+6axv1a9zKpO7mGXXv0Ru6zjQNYh2JVlfLmNPfqXh/15fS67rMF+dvuqaezmJXNYn9BO1rLvAVax9XPmrfcUqz96DRv+5GDW7J4BTLvtJCtKSmRn3k1if+04y64qbwN/T7Ij9+1k39w/gA194hm24Moq9lHdNWzgXc+w7+8sZ7dO3cr2dw6wb8b0ZG0afMPeTC9lwdbd2d2/fMG+fGgxe75PBes9/Q92h+Mv9uODb7CZoXasw+shNnThAdb3yCtsSrMObPvhZ9it/uVsyZVvsZe/SGDD7T1ZztvVrGjGS2zGjU+z3/e0Y8EF77CHp1zPFn8SZNnLDrADPfqy7ws7saHHu7C/n/uO3b+vP3t46HL2wWsPsb6/RlirGU2Y/kFfdvdIFwu2nM469pjKZv7wE/vx+X2s15/ZrOaOo6xB4na25e5ZbNEfrdinG7awxC2fsK/veYP12DKdPXbdAyw4/RrW+sFFLDDwcdbyxodZcev67LpoMpvRrIRNzJrJVmw+xH78+mG2udNG1uzMMfbbUICBBVGWU9aKXbvwLbZukpctv/UAa/7NIDb8+2/Y0kX12IoWT7JhuzKZ++dVrOsyld28eDsbPWUQmzypCUt8/wr20tknWOodh1nwlIu9CzTNqMk3sRfq3cre/f1VNuW7z9lT3wxkddrJ0OYyNjVSygp+HsE6zn2ITVnzMsu74l7WvXk/IL9/ZnvZBPbXmb5MuvsmVjmm2EriZqPHDz606VrYGan0xd3PZaEC4dadE6/B9NSM6o5YTr3koQ6YDk35oR2Wb/jL8Ku5ndPQbMOBhDG0uxof7XTN8+VLf/OtW3ceJbPfaVl9uCX9/FZ1P8GYMHV3Lx+KZvr8u21duL3WT1rTzVNq1kV3ae+e8X3hyntN23lL972vvj1Vm9bp5mcqv+hbi56v1kZGZ9Tvfc0zWVdf+efL1/5apd13YP+zKQPGlA8sntB56Ykqbc+QxwMP3V9S/ljRyCNpP1RpKb8Ovfq2vXOyCh9L+3Tll1XaH0/83qR41+zyb3/9pkXe7ipt4LafBt7824Csbc+MS+/2YZW25NMr+x0qK8ma+svW7Z3XV2kjHp5634tLn85KnPl7/l3vVml/VZ1fUP/dJ7J+61HQasFr0N6zl42+dn3nrMieT684UValeUeWzLxKyS3P+PTvN4c8U6UlrLus5W13PFl+a7/k3dLCKq3vsZvnVBXfUr7z8vyKdbOqtDpnPnu/yUfzyyvbvPzG0ilV2pt97z36w6fFWbc+8cK2xQ9VaT0XvnAsLaO4/OFbH8laU1ClXXvFt32rG88rPzZ3Toffc6u06O0p2pyZs7PG7Rh1vN+gKq3Z8aTxz375VPm+e23TKvtVaQMu69T5txNLs155f9jlj/ep0p7rMH3HlMPzyht++VfolpuqtLmbXuyqj5qV9fmcB2Zc071Ke8R2aKX9oeKspw48Mr+XVqUtWrHih/NPPJXV4YFxIx/qAPk9C0+n3/94lvbi2713XV6lnT7ceHGrHsVZ30w6mNOtVZV2v2uM9vCap8ofHXT2+++aVmmXv+oe8f1vU7K+/7bx2ecawfxHR9V/JnhtecmXX+0uSq/SVnl8BVPaz87yKodefCy5Spu3Y9fMBakjs+64rPPLb/qqtPdeXXnTuJumZqWtvtzzt6NKu7HwtYNSl+lZl++/8a/RUpV2/blP7+v4zbysmjqD33b9dVKz9XvimuKy6eWnli3ov+XXk9qwW27Y+fP1C8p3vNyp/UunTmpPtLk145xzSfmQ/fYRb5w4qe1tt6jzkT1jyn9b9uNVXx8+qaVl7HqnXr0l5T+uSNnU5oeT2ogbW77Uc9ljWaGrkm988duT2qzhmQ8NSF5Y3qD4NVu3r05q/WbW7TnvpbvKW176W9Dz+UktY2mvoc+0nlT+9Ipbvjy756SW9NrGAT8Pui6rzcyBA1y7TmpVgx3XuIc8lXUna/izvv2k9qBS+tX3O0dm7c7a8G5k60mtbXKi9kTNwqxvP/2iuuWmk9rKNx9au6tkfFbzlu0++yp6UptQ2ef4uoYLs/zfnF/ydjmMp2wMu2rRvPKXWj83/u33T2q9yhYe2Pnt4+VdhnwS+eq9k1r/Donrtn47sXxK7+fuaLXqpPbrvQ+f6J48vTxxwX3bl78F339xPt1+9cKsr5q/267Hmyc1+zOzLlu9+OGs8x8+vS/59ZOau0+Dg98PKslq0afnN85XT2rHtta75bEPr8pa3f3uWc1ePqldXTG41U9XLMrqGXw9bdRLJ7Vl45cMvP7QnHL3gfHvf//CSW3FTVXXbLlyTvljfTutnLz8pPbG0VYzJ94+rVzdtPOq7mUntbvuumPiN7sWll8S6julQ+SkNrje5OJXAndmjX35xn19S09qmaH7o1XvLCz/+JqiIc+HT2pT3r/q8deTc8ujX3nHJUP65Msj1lQNHVR+Wf2crLeXndRunVHZ59oDxeXTFt36+yOQ/qTzPZMHN55YXtj/xJFxkF75yOyK609OLy989IWeSyE966e+ja6oN738o6Fd7jgO6U/3ue/f8WxJlnbft72HQ/0NX7jp/QNXPFz+uHR8bCr0J69iaJ/zJxZlXbGhrfQzpPvmf/7q98dzsh64+ZN2v0D/u3zyzmVbSmeUJ9fv3Kc5jPeq9tecem/4wvKUXTcumQnz0aimXqdp9xeXv/5hk+71Yb5G3lmw/5Z9i8p/XtD1mS9XnNTYrIR+Q18vyVoyZNaXH75yUlt1rHrDZavnZn0dbtnlx9dOajWHtzw74L2c8jld361zBaxX1/6/3D3114ez2k1IW/IGrOfUaxu91Ni9sHxrzXxvP1jvFo3yZ695+b7yH7d8vLL96pPa3e+XTPq9SX554m3bdnT94KT2yu9nQtddt6D8lpu/XTZl3UnthieGfJG//bHyD5zbR5+qOKk13zW/1V9vjskqqS6bMn/zSW3tWM/3V+8dkdWkyQ/1Bm07qQ0KPRCybXm8POfH+x4esvOk9tnlB3+Y3mB21pVtrj/xzG7YT2vLP92zdn75fZd0flv5DPbb5SefvXxnSdZd77RNef7Lk9o794wdOW34tKzo+Qf75sH+WvXcE09//N2U8od++TSaB/vv8St3LJhQf07W65/es2TZkZPaH1/uuX7ewyXlQ96b28J58qT2wRsH7vhyU9/yP9N6r4n8clLL/vXFaxOWl5R3uvvHuQW/w/wvfL3Dmc+Hlfe4/8/T42sAXmfdlXfw5Pzy6x2lbVfaq7SPv+nv+aKmMGvvhhtKGgG+eW3xgj/+XDe/3N3oi34bAR+943uz7Rsjx2Y9e9tj3zxTD/Dh+WX3XvHDE1kP7a7p/6oK5e9275lXOS3rhj13XnqqeZU2tP7NHd78eFDWu4cdi0ZcVqUNq7cgv3Xe0KzhJVUH1PZV2t53d05Nn1Vc/sem+/p6Ab+O+qNGu+/1eeWTZjqvb9OjSuv18rgOb/hLyk/P9Lse712lveS89sXHygqzHl/+54H0u6q0xFC2+vz8KeWLp35U54cB0P6CDZ/dcs8TWY9d8bXy0/Aq7YY86bW7O03LGrBK+iU4tkpr3HmVM/jZlPL+zzx85dOTqrSP/D2ueb/lzPIWpWdTu0+v0j6d0WmA7b3CrF+12YcvLanSxhQ8d+uJLVOzpt744Z+3Lq3Squd/Oi/5t3nlX5Usj7y5HPB/YZODi9+YW35q6BNter5ZpbnUV/TyTU9kNb9n4MmMD6q0K46/vGlRq2lZT3+Q177Vlirt5GN7Ln958Kys7G4j+42H8/bnH6459EH7J8pT1z/7+vmv4Tz6eP5N18yckLW/5PlHNxyu0mbuHKBvsN+edWrMvFYbf6nSWAdOJ7Qd+uHCO3+59FpJmAj3a3sr6dZLuh0HeuOTaJJ0quk7Sz7Slm1z/Diu75aoYUo8QejgdxBd8knU982TS5ZAuZe6DSWvwLbfdi1r2mujlnNtl+U1NdHo9s9bZk4bU67VDFt53fEl70cf2/3mb1MeXa193G3PuJTb3o0u+7ZyU/VVv2ms5KcHi3Z+EW18tHXuxBRIM//Gk6O+iIbf/cM14PSvGqu8NeWHlC+ij8xJafziHkhPzOzQb83n0T2rtnh7vYXp4pK+930e/cB32ZU95kOapY/fLX8ebdIllL5sDKRLSqZvX/FZ9MtGLyzpfRukb1HuuK73Z9HNTee9cseVkM7O29T+133R1APP5b2Tivkrzr/03L7ojfduvW3wr2c1tmJmxwXd9kV7t57/7tD9kF6zsuOZnz+NflvSb0f5B5AePa/rrqc+jU6s/+Xpgc9BOryubqPsT6OP39E9+Y5iSBd3rzp4dG/007zDu54eBOnKth0yFu2NLix66eAlPSA946s5WzrvjU7t5uhS0xLSJc1bfH90T/S7dW9/HUqE9LmerUY8uSf6xbdX9Zj3yxlIv790qL4nmp357SfX7Yf04qpFu3/eHd1WNrGi8zpIB75Of2Hp7uisSyo3FUUgvWbQbT/12B29atq+pvYZkK6e3i10/JOot029jF0jIL2y7rjre3wS7ZPe8dMvb4d028C1XZfvit4zbVXX5p0w/2hXv7wr+ue5NP1dFb+f0CIy4OPoW2c6fzXFCemSJ21Sxc7ovL/vvG/eyV+g/Zl3tFB3Ro/e6A1/+RmmH51b99Ed0VYbAhUD1kF696c7Pzq4Pbrmq3Gtmr4A6ZLkS7O7bY/Ku5d9HJoL6eqGwyas+Cja4KFpW/qNg3TbnsNH+D6KHmz3eq9d90G6otuL6pht0ex9Ny1+sDvmp66a9/mH0aY7anbdexmkRz+QtSbrw2gvf+m4CemQHtD+maVlW6MlHTu33yZBOry6z+XerVH93JNrbz5+Gr5vOv6RsVuie16uJ3s+w/TGeQ8f2BxteX71it/XQ5rtvbV1983RVzN8DzV4GdNTy2et3BRt+27qgIKFmO6VtyRjU/Rs6Z13/vEIpLOXl/R5fGM0ek3DZ94ZBunwg+fe/2VDdN3ZeVOfux3TrS/ZNmBD9BrXR6+s7gxp9bc7i3ZVRN/LfrmV1BLz/+51IKsieoW+86kH0yBdfEP5ujuj0Wf+2ttQlbD+7Kdc7ddHvT1v6nXmxClI/955cd110eE58247ux/S4f03D/19bXTS5DuTmmyB9IDL1AcPfBA92mxH4aS3IF2ceXhTxfvR9+q39knPQ7qi4J3uL66Jrhv93sMrZ0GavfaONHd19L3yqktmTcB0h26nCt+LfnX5jVfPHYzfPz4i4f53o9/0b17y/q2Qriz99t6eq6I37r1ieYKG7efe9OWV70S/+j1QMLs1tr/l3IPq29HL3z2R2bY+pNUHFndPeCv65lXTvvrTifXvzc3/483oO3k3J548Ww3jmXD93K9ej+5a1vI+xyFIs8cOnSh/NRp8ofWgrnshXZGcPbP05Wj9xQcnvVSBafnKu2a8FN3TbuvUy96EdPHnQ+8f80K0Y0p48dfPYTqn16x7y6LfHb7tzVfnYP1pg3/oVRr9M/Pmy5Y9jPnHp1QUPB+tN+/qOe/mYvq22071XRpt/fuJF07ejelHP3ng2qeiJa33fNyrF/bnlTl/Zi6Ivvx69datHTD9u/rw5XOiL1/xYEpOJuXfd3W9adGeY481b5qO6RMbleSJ0SffSnXYXJhu+qDbNiBa/49mvzWuBLzMSqb9UjVKKzw2cGODUkxfe7V+4HHt0iWPrgwAH8KKN24u27VQ+/j1k1m/XoL5M1M3LHtGO5wyX9l2FOgclrRr/8pS7dW3dkwsfgPSFdLufrNe0J7xPRepXwjp4v3ZU+99WXt3iWfq/E6YvrMqt/nr2h1LB7grJSy/+MfF41Zqi9dO+FHa/jOsj/+Hs7e/rSnzJ3lPL/gZ13/2N5eu0nbd++eQ1+6FdMWdj9/teE977tv7X2ndHPNzrx7/FeD11nmdR54+Aevd4ObrXn1fkx98KTJiPab9az+cuFYb4Wo/otlsSKuHr0i5bp1mu+u+dYvuwvxvx1zuiWpzlq298t1mkM6e3yptaIWmHT5xcurZ44B/Fkx5rMcGbcNTX487vxnSbbd/PLLZRi3z+um+Rk9C+pYtL36hbNJad67acjAH0oErszZ9t0mbPeOjoT3bQ7r4obx2H2zWrm/bMHiDG9LVezI7LtyiTa46/diRr49BOr3px7lbtci1Ay5v+CakS4acOJf9ofbSXZ9qP03B/PpnK9K2abPHuquy74R08a99WhzdpjW/4dWSlq0hnX1Obrf2I23P6YUpYQnSrHWDn2dv1zKyvm667IujgO+ke2/tt0MreetD+yVvQLqifOfQFju1y3Y9ffrSxyA9oOdnV/+6Uxt3w/KTH9yL+d2vWrfhY61Dz8PPbb0K0pWfrJHm7NJ+um3oZb39kC6pW+Hu+4n23Bc1T9z20xHA742T8xN2a5PYzmW7opDevTBhzZjdWsKm9V9VLIH06OnP5+3brf1Zt8krzQsx/4YrH2+3R3Mtfec11hvSPZsM9S/eo/XtnHOkV0tIF++srDm3Rxsgn3lSckB62KAv+t+9V2tRVjnokoOH4TxMdbd9f6/2+rsHJryzHtIDrgsUpH+qbbzk6aGvPAPp9BMjmk34VLvTUfe080FIt33zz96ffar5Uj7/evsdkK687IeTV+zT8t7rLbHAT1pWvy7z8+XJWU+uuklhbX/S9PtYz2PRuVkT9y3ys1t+0la/8Pn0l4qeyHp91M1ONvon7cZL+uQd+2tg1huJ3/1dM+8n7XzC3Tc2nzypvHzLICdb+ZMmfXWg57ANs8p/3XBvI7b7Jy1pYa/nGmhTszr/aj9eU/WTdnubg/VtxZPLi5+ensACh7XbHnSPGVLzcFby0aF/1Vx2WGv6+LpmB9mcrNykR7+r6X1Y2yudGjlfHlle8uzQRDb6sFb4bJ+Px/w1tPzqbZP/qJl3WJtqO/v8hvWPZv20Uf275s3DWs7gnS3qTh5dzj7Sfq755LDWYPbDroLi4vLx9Zsdrak6rL3x+3MjMivmZh0pe9bGAke0K2/88da9RTOz5rVeWJe1PaI9+kvb947+Pav82bFXOtgtR7Tyq3PyotGZWVtndlHZ6CPauIeTfsmJzi63PXj2eM28I9qdO66NjGQzy7+zlYfYyiOa54bKDt+xR8pnZfh+rPnkiGZfVtN9DJtRft0T8/+qqTqidRj90O6HH52a9WH/PxqxwFFNWfXd+PmdZ2a9/3D3FNb2qDZeXnzDzcVFWaOcJ3+q6X1Uu/SBmi+rJ88r35Oc9W3NqKPaBx2aPfXKlNHl/lndztTMO6pVrRg8P6P48fLOly7+pubNo1r7hffMqsx+vHzIn71g/Ai/z2xw7dKybn32lMqqj2qefjOav6LNKnes7JbEAse0O766a0lP4Bv++HWtk7U9pqWPaDXr1fVzsh5s+HSA3XJMa/vgxG+2/z0jq+elZxuy0ce0r1/df+14fV75bVfe3YCVHNOSx2+cJkefKL+hc++WbOUxrb9Wk2U7P7x8T6M3vqj55Ji2anRJ8uHOU8on2m49WVN1TCv7NqGysyM3q58/5+uaxOPa+57GHbY57sm6c/srf9dcdlxrmNWksJH0YPmBD578sqb3cW1Zy+nDAjUPlj+b83xTNvq41rn39N3daoAOr/P47zXzjmu/b9r41IS/J2X13mHbW/PmcW1zq9Mnm9cMKu92r7635pPjWvDYNSdX1+SXf+cedK6m6rh2r/fSpxX90fLbx7/7fU3iCa1e7upFgzfMzvrhzj9O1Vx2Qvt5a9u5VX8PLm96KHqgpvcJbVyPE+XDtGnlv73f5+eaUSe0E5W3V5dNnpb12bwlsP4ntFMLfp/rmDo2a2nwkiBbeUKzJaQPfuL8sPJnuy/6puaTE1rBsQ8brJ/8RNb4zeeP1VSd0P6esez1juufyGp1bmkdFvhZG3PP+yvmPzIuq+FviX7W9mftqw9HDy/ZMDNrc+KDx2p6/6z5/r5rS/uEu8p/fPzApWz0z1rXxA03fV5cVP7KlANBVvKzdu+95xfNm1RYPlXO21/z5s/a5IHBLQ2L5mR17JHfgu3+Wbv9rZq3n5dmZJ0t6fpjTdXPwJfctnUvG5m16NdXP65JBD52eBs1e2pR+Tfbbvu65rKT2mBXxvYN7OGsqjpdTtf0Pqnd+uqilStqCrKS7p91pGYU8N3rq94a++ud5f6a55NYyUlN2ua9f27xtPKudV/4rgb4+HfV6z5zsIlZpUXJ9RnwzQvuvWPAOfmW8s3AibPqk1rST1ff1zX7sXJ57kNnaxKrNPv8qo6X/9m7/MNZPzZibau0vkljT7/26KysRVdNOVsDfON1H36xT9dmZeXd+PJfNaOqtHETFzc4Iz9Qrm/+/fuaecAnHp5wZs8jE7Im/1AJ61+lXV42aWk9aVT584cmNGDAp7312q4bTj46JuvyTZW/1VRVafc8Plpqbx9ZPnJAzpmaxGrtK0+DXq9PnlV+10PTf6m5rFqrfPuvTcOLni6v6//rfE3vaq3foh1X/R19OmvKTR8rbHS1tuOOQxVT2ZSsIztOA/xVa/XHtV//Xc2I8pyvfBJbWa0db/bTG0Xa/PIOny6X2O5q7bdlPR/845HirPPnv/qjpqpaq8j7fLTdNqH8qfMfeFnglPaAd8S0fcVPZN135sc/ai47pVW1Oz/4j+hzWV8u/Qzw7yntjVuSR09gS7OW9g0C/julnfz2h4O/n5+b1axP879q5p3SxhZcc6Atm591d9a1yWzlKW2GpBQ/WLQka/XzLc7VfHJKGzpn2atX/J5TzvbNOlNTdUo73u+l56JFC7OWT5/tY4HTWqjf+fl5xcuylOseA/x/Wrsyuuz4xpqFWdN+La+p6X1aK7j00smHpfFZXwZbnK0ZdVob6Csav/avoqysTgtTWclprZUuZ22XC8pTBvVNZStPa3Lj01dOKV5Qfs1tfx+v+eS0dvpA7w6Ta2aUP/X6Gi+rPq1t0dvecmvNY+VvHnzoz5rEX7TnMu+fMYY9Wl7U/zXY/79oaatXa/fVzC+/Y+iLPnbLL9q6KbNDU4qezAr+9mcSG/2LtvMz/+YPWHHW+5fdDfP/i3brS2+3eU5bVN5l7zc2tvIX7fsO40fnFT2WdedHb5+t+eQX7fLkaKCT/FBW+qqVsP9+0Vbe9taQEUWLs868eUUaC5zRmj5Wr3/7c0OzWszuAfj/jHbdrQcKfpKmZg1a9eThmt5ntHtmvr1meM3MrMpxNoD/M1qf0xufeaviyfLDG0ZV1cw7oxW07HTanf1Mlu2l9T/WvHlG6/aIP7q6ZlH5t80DddnuM9q1uQfGDK5YUn6wc3Uiqz6jNbj9Me/Moqez9txwIJkFzmrtlg8Zk2MbkPVQc3sd1vas5r6iya5d0afKbxz99Yma3me1L0rt9gJ5ZvnLffpX1Yw6qyUP/ijhp+gzWcmBn+qykrNaSdWbj26ZPCNrQeePFLbyrFbhi3pc+rLy8nq9GrLdZ7UWPS75s+Wji8tnPrTmcE3VWc02/Ofi1ZMXldeWRxhyhgEkZ/gx6hD2Rjf3vXvJkiVHtYeWt6D3R7v1fKZfr9PRTVqz2a1YNddrhH+N6Te2vX96SuvPo8V3tM9suuqPLG4/Zcl33RVdt+ezqPpb5X7XCw3WcZcPS/5d3epOGP9ZdMQt7322/IEmPD/bkn+uzeOv1/8s+tnQlc8fmvZTOXfbs+RPnPBk//X7opWdWywcnmHj3zNL/oAGG2cP3BfdOe3GnpftT+Hjrjwby18xfXpb275oJ++Un3/pcoD3v8KS33N43xtf/DQ6YNGt07e+pfLvw5b84sVLv+nxaXRB8ZZ9N919Cc8vtuSr339w8Mje6P5Wq5c0ergZzx9gyZ/xbco9M/dGtZWfvJe6Pe2/5Wdb8id+8qfeYm90/Fe3Zza9pw4fv2rJXzx8w+Jte6K2PoeHlb/ZWMyPdfyvvnrv0D3R6hVTrtzauLGYnzOW8b/x+2z7nuiQe+znN69oxr+vsOSXjD3YtGx3NEE5M/lkno/nhy35u1ctuiR7d7SozZnn17SrLv9P+cWW/Oz7R6S//0n08awlr7a80y/mx5I/4MCO16t3RZu+Of3Z1c1aifmx5Fe3HOlsvisaqNH69L6srpgfS35F77zgvR9HM4ZtXzv/g6DYF5b88NIPf5u3M3rVtGXDej/Y/L/lV/5imZ82hdM37ojOWz378pU31+P5FZb8iuKbP/ple3RIycfaoJs/4PAXtuSvPNi4vMn26LEN3Q8MnnPJuv+UX2zJv+XMs/fc9lH0h30bbF/uaSn2nyV/t5oTLtoWdf/xdVF0nTF/lvzKgDzz1Q+jd11/e0HJ1/8xX7XWX+9w4udbo0MOvl2Weygg4M86Py+NbluzJdrxlsCy655v9N/yK09bxl/6w4/NtkTn9XOWzP5WFfBpyS/ekd/qps3RrIlXD9zgq3vtf8oPW/JLGql/jdkU7dSn+U3TJ54S+M2SX9343G1Pboy6No+p23ZuUzG/lvwBl33WcvWG6FNlSenLiy/9b/nZ1vZ3T5r8RUX0TL8jM54a7rn2P+WrlvzKry+ffyIaPX1l2b19xgn4YJZ81gr2x/poFmyU1le1vPY/5VeessBvv3l97i+POtb3v+tOX0Mx/5b8yus7jVjwQXTbK/2OXN1R4Mf/lR+25Icv/7zbpjXRYXdcdlOLSSn/Lb/Ykj/gx1l7q9+LfjX2yo/aPy3w1wBLvurQnBnvRu+8f+vAfrLAf/8rP9va/4ynvtDfiX6X8vvOr+5v/d/yVUt+cdnJdjlvRd1l88bfPylVzL81P6mirefN6Pwn2k19/u42/y2/stqSX2/MN11ejd44+vMfH5rS4L/lV1jyK6749a7Cl6InS09f1f2v1uv+U37Ymv/3+48/XxZ95e9mZ1fLZ7P+U36xJZ9NTHhmyrLoIffkSc2KW6z7T/kDrOP7zJnx/tPRji/+sbDP3Eyxv6zf/7VyRcW86LMvfvrrpEbflf+nfNWaH8hrWVkUPZT9lV87WG/df8pn1dq/W3P/j/yKKkv+zHFpgWLtSKvnluR9KPBrsSW/eOFdd6gl2t7fDjr6HTDoK+v3H2Ve0muxdpXvnis+CIvzgVnysw/PvE8Pa7d/cereiiRJwMdJy/eX7ntjyHIt8/y6cWPriPUvtuRXLEt9ZdEK7ZFm9+x+8kEx/mxr/jcfj93xmubM3N/j9LD6Yv6s+Y6Ky4+9oT18zUe9OyclCPz/s2V/d99zzdNvac8877/jviuM89GSX7nnpbPr3tG+uPnrF+7fJvbfAEt++Omb7jn6rtao4X1ZjuGi/9mW/Ipjnk/Zau2Kn597eW6jExw+mSU/++777r/yfe2rHus63ZvURMzPCUv/Xp+7LXet9uOw31oVl6SI/lnys8ulu2aUa5++ds/WPd0N+tCSr3qmdvxwvVbZ7ac3h1W0Ef07YcXvHecfiWrnPaW9P7/KwO/W/OZTnqi7QTvtbLNrYpWgbyot/gbVTSa3emWDdtWSDl2feEnMT9iSXzzdN3DPRq101aM78p9TBH615JekrfwrZ5M2s+CGJisu28rnJ9uSv/LKqdfO36xNfO98nwenCvyuWvNLD/3YfIv24SPDfzxypRh/5bFYfmDO+pvv3KpNvDSr9exPDPrJkj963Ozk6q3a98Fnf5ybZKy/Jf+Wro/NnfmhZr9u/ujAEIP/sOSzjsffXL9N29P66Ct9rnWK+bXm/3bgnns+0kbVhO/KPO0U+NeSXzkr6+eF27XhwTtuua5A4JfKoxb6p9+d+y/fob3y/Ws3z71a0McVlvzKazo8vnuH9l5yn7s33yDWN2zJD1Rv/XPUTm1vq6e2FJw4xfHPAEt+yb6V1771sXb1yrTfWtaI/Ztt/f5wTcLtu7S2Z/QBzZM38vVRLfnsm0Ovn92lJT2xNictuJ3Xzyz5K9/Jb7DkE63td77tJ3ZkiPk/YuHfbhrQYcxubf7NP9f5+tlzAr9b8gcMHNpm827t6LGsOrPTBX1cbMk/gvC5R2tQ/cKghKDYfwMs+ede23Fv3h7t0Tov/PbxUoP+tOQPu2fQkugebfW6Hrf+/KJxvlry1ySM6Ja6Vzv2QfcPvn1c0EeVhy3zd2BS9fq92hnbLdf/8aygbyos+QM+/f5U6qfamqzgpw8dFOsbtuQH1o8fmveptm3CqZUfj0wS47Pkt71ywm0bP9XuXed4r8816WJ/W/KPfNZkVb192nOVJSfaHXKJ8Vnyt43ZOHfMPm3c50Pdu5pfJvCjtf66z1d+tE9bvt+TMVMV9COz5Ic7ON8Ifabd/eHgR0evF3x/5U8W+Nx2+28Pf6ZVZd938ufXBX1TYckfcPd36z77TDuQs9zV0utZ9/8BY3cCsp5PAQA=';
})();
