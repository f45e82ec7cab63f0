// sources 4186929635
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
const BINARY = 'H4sIAAAAAAACA+X9B3gU1Rc4DN+Z2V6STYNAKLNLC02xUTQyGaTasIANFRBCSUILoahIQhGpEooKWNhsUBEbKgpKYEMVAREQFRU1YqFKIoJiwXznnHtndjagP9//+37v8z3Ph8LOnXvn1nPPPf2ygWNHSIwx6VW55QC5qEgqGqAUFRWxATb4t0iaNIAxegHv7UVF/IGymEgz/IoNkDDDVST+wLMz9ugwn6QirG0SfTSJVznJbBMasxVRpjJp0iSeEg1PitU5Ka5ORg+TjO5MokomUYaTl8XCjLcwSfR9ktHVSdhO0QCZWpPwH3kS9WYSVYR9nIQjmwRvJk/G58lUHN4oE8Yris1uszGH0+lyM5vH63M4vF6738W8fikhMcGVEEhiyf5kKcXvcEjOVGZLq1M3HdK+evUdSRlJUh1bgwYNGjZq1FhOlWWXJMlut9/vVlXFZguq9lCTYLBp02bNgs3hP7VZMKi2aJ4ZbBK02aXRkt1uVySW4HBB5/Ti7Vd5nbe5HCNyRowqeFBm3v7DRw4vHD4wf/hDOUxyjhw34oGcgrGsi3vQqJFjCweOLBzLrnOOyBk7duDQHNbVNWJgYU4BlGbd7AXDRw4dy3rYhgzPz2c93R6J6ZLXdmOvG27xvPWsbTxU7WKBYvjDvHmSXNSEHvVAXkhpyh9Z0CZnq5JelKsy+KdALy629fIzVcGH9rJLVVSpvWyDH9ZehsqDNlXWJZ3px+bA56oSmIbV1PfCB4FcXqdq8z7ns7lhyqXJDqPJCpYXtENLrBtUboeyeuPcoENlqoy1M2wE3qvQpA864soNOqFUx1zdnht08SdnbtAN3fUo2fJF/1OVtoyFbHqz7tCCrZvfBoW98FeGvz6fhD2UcoN+LCaFZP171sMvQYv2TNkHSVsutuyHKnCEmTJ8A0XgYynoVf1BxQudYFezJOzj1SwA9WG1sZcyvISZ+YV198tYHhv3Qqdk/Q/WXQyZ5u4ItOsQ7cKY9IljoHUXto6lWysslLAhlNilmP85V8OmWZ5vo5peX4oz+sRcnOvELkV9M/RVS/lzDf/jnHZLRkjOZLBkAewbjA4GdjVL9Tmw2wFoCb+jytpCx2GQAa8OY1ETlqkJakJXJv4MygjFEoNDckYwSeQWTb9EH+JXfDZv7TmkKbmUz6GsOoI2JVu1AWiFYPTQFc/IUED35Ofp7QquZrD8uvuGYLIagKLJfgb98wIweHJhRrAa5nNeUD9VbIOGod4kXNIks8NNs8tC1u4xWgLLCBD4ErpeAX9qhp/LHgRJqqQovpJIKO4TyfoJ1qk7dEmFuUjhY9UI+oxPKrWw+Xm1PsjS+pAx1PzLQZlDj+xVXWpKLozeHfRDP/w4SX5jklItk5QcwgmEgjRbaWoqzFYa9ETOxs2gpujyzX7cm8k+qDMFi6aoNgRlmWae4K4dQCFmwoQle2HMDP7acnVvr4xQmt54nJo2BhYouWcwVcnW2wVlGReN9YQOp+oSddyvEhRhtxGYVfhfxs4FsMpUKA0/Mk2FTU3rAR/Ait4sIF9NzdUv4YXl3CDuHhhDwItFoEXoHXVZxo7CG/wWHlPUtJ40SKgyTU3CKgMwRMlsH0DiB8aBSMrV2+qtcVg9M8x2kuHDJHjXeFxIhs6OhfLu640eJefq7XhJhWaEL6WxFDThscVIEosRCpgwm6omwfSmQgehvKhRpexkmmO+AAE+LzY1gIBjtoy99gqcgCDq5ViRNo5P9Zk9/r+8gQjgfXoRDtOjn5JugF9jP7XF4h7sjgeQYdCPRbGToUA3S2nRX09Qhmadqpyra7qmBmCeaqQxIY9ew7pnQGG1V4Yx80GPWY1kfC5Dbb2gWx6jWwDdkKH48FHyVsAxXCQ9Ik0yz4e9LHYmSXgm0bIz2Oshu/73I7l6zSO9aI6kMX7C5VNkfjrZ+elE5wf0Bo6y7U9aTyaAF16RLeTQH8zVH7yBTjdHezkdPoOfVP51wDjboIaneA2wPLFKVNZKXrlUCjnXB13UN+d1uKnvx7lzbfgHfH2rH09Ytz7XhecWrIRblwtxMVrJbH3oXz7D/efGtWslu6ide/2Klw60A0skOHc8BKaAB+FdAj8RYdv5qd5/6QyU8f3vMvozS6V/LXUbLYGa0F6+EX7c7eWe8ONtL3flU5ltmcqDc/lUVjBzLh1eaMKGUJIAMBFK0JUeiJp8ui8XRubX56bjMe3FPK/qoDwP5nlg9uCdW7XTO6AZVDnwKNYJx4GMHXJ1UjJ5F1RLF1aLLqjW1aTCHXnvr+TftLN8M28e/6ZdroXA2ctiFM5CWfL+IzklwFZGTIaQh4QO0TTQgou2lQvhAKaYHnFQIj23X9ADFcAB05NAB4YZ9AFGZoQFPIC1fYCGQ359CcEQzNYKeuiXgbsQZhUQl09MJ86jL24ecSd4EPxx1Lh5XLHNo9to8DYY/JT5cRsIppbpUBfDXueGgBxDtIxdqkX1fedwSriri+RHkASXHhHzUy3lhWRRSkaQ9oWUjvL3Ek+kd5SPike1o3xSMrY/voBZ5NCvKvw3l3ZEyCFSIZjR7nTUOGH9oOtImb63mBqKrR1HAbymfohEYAtjPbag23z/P/ex6qZyA7Cc+993hoywhZ1yr++kuAiqeM9+nEk9i+uWw+iW+Uxdwccrr7uPV+eAelRLPdOX8hHGQTSQtHAK2hDKCFqQIjaHrBDWEi/+fayxIaSrSD+swcZyAaINHMn7sGwu70MMR8p0oOguXBAnQCksX1ARWx06iD08x3J5SyWlT21iHXCS9GrLO52/WiJdWKxEuqDYOuMV9Fvjr1bDK/HBUUbAElhPa6GvlHJxL2au5cmZmNRTCc3xN9/i4rQnkv29p+hxgCpb678LklD3LVDgBV6gGOBW/5J/F8bnXfPouULAc1Oouie83hvr1cEL+7yD96zBOt4PwJS6XZUC8zhmw2mrlmKbrES24RaTHpEnAQpUOPck4+nHsOK/YDEqoGIV8SNuFRtf8pAddzy9Sw851hsEqmbAXEbI2UkJ0L6zdyOiQVmLq7i+a6dnb4t0/2aBFjEJ3EjgLHYGMIErHCkDOOGQLOHGtoCwqMKx3ijDm2chBOd0fLQZvePFbarjiY5yUywnv4kZ2mIsFVjYUc6ExWqTqyrma750kMO8PzrdSErIhHaUSVKRDVAPlGhKEAhT2VpJBwwsISJ24g+D7S/TaR50YwMq4E5AtvrKloEvaNKBGgKuA/7enwHfu1Tn9UGvhdG0YXcVWLFutFVayeuALvCsF3WuD8HxLCY16Pf9zxKqAoASwnSxhvvd5BeCcDwGE33mG1gsz/pSeMuCiV5EYgFAMMC4QP9UbwYMzYdVqSH7eqDVE7quGH2t57OyCli3dY0ePXHruo1aOGIgu5Aro+u67KmH31/iAm4nWU1WfYMz4N9EYGrEIBMRRyBFx3QEKwC0g5n8KIglaUmTqbXU13p8+1DqaWiNHl77DFoLpZS90xHKAbuhBiJADTrXwnCZmgJvD2QiNLRWAqGACsVCqR3lvZkXmV12Xf/Rs9pRr3HpXBm8pNcERjW5LIhdSCqDqeCde7i9vLglf14BHT2HTSW8E3J3lM/gYwqwuCmRCHRiCZSCWUspC6XAG3hRnQmTqxClpuBR+lcmUOH46NQPcJoIl6nzYtW9OGQH2APsNrNlrurUX+G5Ic8C3lVjeaEM7ihEBotbLsaPo/cRsNOjagd4X9wSj1E4uRVxcvOBhmBPV2SqDpy5FKqN5CcyfB2DB5i5oB2/gM58nwkTG/TgAIwjlA8ESIsQDeEQjEbC0Sh6JvYWB+DUj2ZCHpFHSFB4+MCwJTqSUmMb1AnjSH0CdxzUj4hdGsPPGtUJYCL74ZxSk4BfVoAzcviUi5RC4t+hpq6PBB3Y6SSY8R24Ig542IoPyV3Dm0/8fUPPNZ0sj4MzIHt3pvdnxQ5Yj9gG2N8y39y4b4slvm9DDoSbzJATxQS04SsyQwwxpAMpBD18iuXnkhSB8Ql1GeBGHzYI2bq1F+Q2YAibnxZJo/25KOiiLeeGoq6OsorVt8I+y0SkLO4IbARKdeDljkxIEXo7mgkddFx39+dwkhNUsAx8fS4T0NZEQrxQu/0JnPAGvMJDmR3lNkD9tYOF0ivNRXKIfQsVdJSv5MIu2umxxbGvj21o1Q0byh70wP6MjSBkX3Sd69prtMUx6LGvL70YllDdkdp1LUSW0aF6EBE7ENiaqi6+E4LAtQYlADToPwJWx1wUOOEz07ceok2xGIeg6FtZLu8NMHs8I+R6gr9xxXYLjBu2gsS3gveIYldgwd2A1OVJKDKBggN0+CeMMkt2fUjJuK7nt8uy4U1XmJMMPEd9IVsG4MCgwxwoUM1S3loAcmc4cBQBpVRkwbCDrth8SHrR2IsVgxMv6I6hZU/s0YKsfbFHv0AinljVsu4cs1YkEyrC2EgEXirja78MhxJUR1kpL+CMVWDLiJgNmO9RJpcIJ3cYDjCn6lYT8GtXaSgQCSWpvjBQ/041YXlE9YaDHAer/jAeOGoisOLEu4eQ3jCwDkoLiaS4CzlV2HSFhB79iMVHwyMwFfiYr1owkAffDFPFVrEvAPwwWCW+daJ5VGMzb8I2KL5y8UJ4qeqLMb8BCtEK31wMX0zyTpEkuQghCel+nQXm4vwDB7RMCkq4qAHoqLM7YSTgUZA36qg74dHRPSMREY1EGchIYmkXABBycdL1GUE8Q5D5R75OxjeqlE8Mmi6P0B25+UieSiiTOGqXFFMaIZscC2dFSLymCNL33SXE6lllA9BDmtEdQMzO/uGx33e9P+/X9wXJBwSdhSatTf1VxnKBJu1yfOnUDxft+mjxdvGu2PKuO3/VkejaNoJsPcjJXFUkz/FkU5GcwYnTdjFK9vEKqDmTk7IqHm7riNDXt82mkijE/pRTsUjo7uRvR8PjRv5YInFiuvY4wjEad4clt8KYBAthfpHsylj2TNnMXmJkF8tm9hKJBpgpBriOE8/pgqw/SGR9A2RXxJtzvIBNJLdyyn01jmI1f96Lz2V8oqrxeQl/LkFpWzjW8spYx+YaHdthvpu+zhyqnEv7I+fDDzfFNoqiK9cDZuK9WCJTp1yiU+t40ujy47z91TKxV7rHYAZCCkpnSC6gcBkDQ3EYMdXtCXUidB6Yb2UyEWyRhdgrGyyE4n1HkmUglAWsqxcog7hYHHn+1gpRHbQpXZgKoSQjQE/OIfzktOf4+Q5AulmBj1Q7DgMlA6qTnlQHsMEXapB+v4iYQUUxA2qjQhJRC0iWmKzPFKfihHNANuUKLfNCLmOXwrHj5Ggj5PYL+kVHAt9JjX3xVO09CxRBYIZRHnoHBEpgquV7R9z3e2p/jy3CridkhJIoqgGOe6hlPjERbiF5jKvm+AXdsCNycgNychO68hhCH/hFER+gX6hxuugXojkfLrwbv2OhhBuRSkdBHPBiKNSxwY+fTzM1qfr1OU/g7Lks0+wze+sMlBg1qz7AhLxqLxwlXugLCpEqgbBFeSPJb0P+HoZAXuLKAUCc1+Pyu1D8lwo/QpJqjLf4KWo8TpIKIwOuEA5le2AOraOtUPBdbihZ0TKXdy/wGC27G/EnHFqu1srBlqFE/N3bMhIMGGpAvgqE+Z347AqhdsZBmN6T3xsG5lQ9I4EghYFLwAZCqpefdAiEJVDPiBxgElJyTYGTgCrSgzI0i4DcUm7aQcY+AM6V30TyBLrYUjnasgOgVDdwpPzYS15EWcBxqoF36JEIGp4pZSC96AaGlY+O86WhZFFbK7myZUdAu25eOgmq8sH7RKgHVlS1Qas2+FV463oWbCrxCNR8QE1ej3wLSZlxhC7sNp9EnA/PaFzA/FxgOGHPBWbSjCJtTOX8BET8HFSdcBIW5gYWUBEnCuudJKx3wTYztqDb+67X6SARn/8RabID/oqtWLJNygs5Tfk97HZYTBllmSSI8ugyaiTcuoIaIVfQi31FaS40DgU94smj+4JeLhB1CQpQtWXK7ZAaz5RTkZ7Rz7VC2rhj4HMCJ3ixA18gyHCAMXh0WE0hOGeYyOQkpp9xuYPfoJwlEkmo/n4AE7oN6CiHbgO4fXL2hdvdRTsZSyBk/3HBTrZlcokiJ2F60njFtlbZDQhzTgMFErlmZBKDQnVup63qtLZK6hyqzKd6e/JKaKsBu8+3mtGhKv5x7a0GTenrWudCgYNLBZ8Es9ZlCjwEOiirW6MEGvp76BCCSQIxHAe3IkHv1Fe3zlU9KJue68o1uH4c1AE4g2NpDxLsHsG7Oo33z7RGhkvKFQvEK6PVM+AQ+ga7UUfRGXYClqFpR/6Zmiu+TTC/mCXAErJ8gdmY4NvF2UquRqzgzEQZCkpT4M2VaiLP9WQ8ERSPAALqoiDQt2/CVlfeRF3qm8EULN0xmMr1OcA6Asu383SvMcE0XE/Iy1L9TwTTvNSwnqk3xTUO6PbuGSRaqgPvgXzDx7q8yA6eSuep3TxVD79Kx4VoJfcJ1sef7GCG6myp3BVsgKmZUrAh/g4ONsKfuVKwMf6WSEEVf5+RgkH8XSIFQ/CVfGOwCWCvk0Do2TgOI3xgJ4Gnhz+rTTrIA+DVIXjlIyULAA88AZ3h7ZkryiPlGOKPBxhig+Bi/rHaEWg/O3ZfbczzYVxqPf4IbJyazss16ojoF1FSQ54HWLIuz2qACNKOCDLGngEcX5/BC2bCmqoJhaIjgDb5e7UOokrEzGp9ngVYKo0/AfpM5YUSO5JVQxIiSrsaQDxpV5MRTdrVFF64miGD49M915P8ToA3qjQRNYhjx3UzkVIerjtyIPoLSUDsESXlApimZxwiqkdRDA/UYD5ApZ6ej7sinQvF8fR3w65rKWNx2nJ4AJL0hcDFiYYmHr3Eka8SYlviyA15eTsueAuvRCLWBGynfNxUNlGrylVgvD3a826Uq7h0OjPJJoFxRJALx99lHHM6ESsbqNvjPS7bUWyskOg4ZpUTcogSXL9JR3MgDqNyUtNFqBqb4di1Tcgbkz7ggQ1/gWaAIbQG9sK5PhL0cZmwK1YMUNj6sqAPaK+1IT8qulX/4IyQL8Zmo3YLOPgMwPQwwEI0C8AlkoWGE44UEpNdTyrcClJMoJZd4Ro9JZ/TumiIAGsuIy3pU5W1g7m6yoNZ3YlmZUgwOUj9xVHsUqMP+iDq6CpupIEzMxEtHhwkYqcDwk4HxBFSEDpM7aADyZTYXCuyB+YZmWqdqwBDNqCUMkJojFOCQkX9mczcwEJOkKNiEXChXZ+bDqxpLqJbWAaEY4ACVFURWaZLPTl1CHClqF6U6vlysULVhwrBEkNaJHTB0o2GpYMLChDOFtIkhmmh4g0mGPYUiIiFWCwB3wCmTeCbqR3gBpSEis/tOFJ4M7Ol2SAqFckcygHbzUl0q131m+UDufDar5NaF3EQUCPunlwYiNw3ngKothKqSqEOVgRA4i5XECMAfbY3k4uS2lDqYCagtQQhXcrCOQ1n4hYBwEEjoWdomlfwV3Ihx3oKYTX4uDqT99xNmlZ4D6iSxIkw9yi/8V18DK4LxuCdIdvtqO0kwSSst2URUTtvp+Wy43I5UAiL0xyzbQBa52ZToMs406DHiZiABCT5GmlOvOtpV/GdR4JkoNRI90NaDSTcfWFUaqC+XCK6KuRRXT257heHazCk0fDSrj8P+27m2+e+74wgT6ckch6qwwQOoT0EAHG/E/SSIhLODy72Jv29Heu38wXzHrPZ3MCdSTHOMmCShBYhikHrHL5QiKIbXCwKEIkIVEmArNoygCtxBBYTr2KjUQMII+IFhivwROw1Sv88wAOg/lJXCg0iERnKIBKcSiHJK31YfU+EU+iWn7g/H18gsi0DZO8gCpT4oQTUHZE1jEO1AeOLLC0MPZdG4kLwRfOlkIxAi3Vh+6HE1ooLqI1EZKCTiNrGqpK5KEHiaChJTYoACRJACX8qSci9ZB2QgBp+mfPb3CIwrVRNxJeImUNufIMfqSkWAWVZKIns+kicnQZdmoifl6qp0El6pE+sH6D9VTLUSrZeKBw0YS6HMHqamhaGz1NKy0LwuCyUgoXUQDiCv+EyrE9NGZQB/6YNRrGGl6YDBwzMDB83DoIP2YYzZeNDTuVDToFpgXmj04sTKT6x9T2BJ/m5o3raE2tj8xJdawoCyu0yHGMGmFWyeDjjjL8LPjlIVPzH+C9NegbCFwe/RUsuRmrj7Ol8z7kIOFywbMRZujmx7RKfn15Sm9i2IeNiQ3TNrVT4WBDsVdziSOG2l5tyFkC11PRWiUHZGjWR5gSNXgEzIcOvcBSFS8pPfHEaupBIIfjw/JvdQgyXDDJTOR9+qA9GBgUZIA/y1Ky06xOfNj/qvSQJ0QGxGR5UXtPIs43+wtjefJz312LQYwfUgCyfGLlhacIIt0GHXT6yXSIsptrz0SoxfiCZZLulFBKceroenxvudHfnlt0HX9j7fzVaoC7fxbvch0/4LWbPJf3MQt7zvXE9v8iiYZc5ApJUFI5D972WFdtxAeZyohVaO5G9UCyoxXSI2AQBvS7vbFmSTEGzIy9kFzl23Co7kA5wcftXfZ3DYNjsSH8guQtjIkMObjC4FRCyAmUFIWpXFaIXyx1eqgUpd0du4ClePXL7ux0hqGEdqqoUVQos4WLF9vIOB9cqYa3cHEgm5Z2MsD6LPo/jKvFEgyZ3Oy5sh2E7O6gdwtA4lAqHQMXYr72OmCjymGRzFpHuHtU7kimq7ym0sBKe3CEbsAhkUkXIxOgnohQ79JFwK6BhG0fYgGZQtBqMKUlQ3Y/AppIun0h7BDSv6o3AP058BloUkGN62659/gy6syNIxDILWQpFSyOE/cORcIisewTuF4hNdMYTRL4esJqbsBqHIXE+HpUlJ6o4ZHH2G7ZhstD4wjroRXoR2SnAiCscSNzB+HplQErL1bPHQGPZN0AKjz4FcJmLytvgrywO4kLoCBqAS1Dsn74P8g+grGyUJQWtLPTFMtbky8Wj12hIcGKWTtpUJx7Prn/rnmDtan/1PwbFREnovoJ9uLD7eKx0R40z7lyZG3QIw1L0H7B5u8P+4k4NPRD/JHoNvwMOXeKJUxpShionETRCOfEmsI8cJo7aZBQ3G8JmdjFqxvU/qBkBq4AA6Cg6IY4imY4iy/cXOY5UTuh8iYyG/v5My4eBCz+Mk/qQLmxUrj66lzjNFDQOJMbBgxaBhHz9Avn6yOXARP5DuIm8cUjkkKkYFkmM2bHju8RYEZL/4oGfSJMukyiWmIRE3ChONQEtLZ0ol25nomO//urCWngSsTFhSst3d/Hv+nCkfovlHPpiwQXY3IZ0hAvF1Xg0QkkuszaoCmRAPMBkpHNakExJ5ZgpqYWWdPklriJsh9tABn4/5DJoSXq/WskFEDXe0REnEY3Cj3g5/oj/pPYRj0WrLSdCb0kuEjBK5+Y6IkQRTAMfY5FEBKdyehmSBPiuQecZ+F3t4KrNDFVKmkJw7PX2FBuA6rMCPy6VFKsTKVUlth1UUZFiVrRdcaLm3Ub8DdL2RmV8E+E8oFZ0GXK3EWSfCBOjgB9gDU0u4Ewn8YbCO+IwdyHxXZJFqQ5AigAKPPcjREQCnOKPX8hzYSZ7kBOCneQGvnCkLPAj9hJlBr6IQN31siNlqidMpg+qP96Jw4/Gz+IjfBS5rmyjJqBsfaKeTnAESEAie1Cz4SHi1oQbjt19MnmqSIFnCWK8hjoEB0cybpS/0+ElBEVQgVIY8hJRD0gmQrOvenNDCcb5oyYIHRsmwsbpE41Av9z8aFPp83DIh/sjZnBAIgs+y14iB2BNUIIP3CY/erwFkq2IHzuukMwXQBH0lirRHlcISyqcZCtKFN5ScFQEGTGwwIaNB7aWfBBssU9D9owQqpIA12eEAENCsetpR3n3I+go/x10cE7QTpp0MrijCIJcBEHuGAQ5TQjy1IIg9GlArt1nQJCfcFswgX/H4Qd4ePwPoec4qZzIQM+m+stCfv5GVLgXTn2/CSJlcXlHtUg46CctGTBr/khpyEsLopPBtQchxHMBhAgpvltl3Pg7lMiJGvgM4MJDC+/vRNSNz4QiN3TWwSHFA/yRQbVYKZVEAV5Ug4VkcRAuNL/Agr5YQSRj/ATX/ngwcseDkdDFCDDqJgGpJpYRkYtJqdciakhkZUAJJ3DgnA48R8eq94xssxNESFYxpGIqci1Qwq32lxvKaQIJrDdkB2bYJAZRVgUvnLEJ4K5e5qGGMjQzoSq8IxYRi0wiGk4WEj0IsDgk7nt9O5fkuODMcIeJO4NVtpN9JOx1UaUaV0E3wQcBc1Gqurqu3/DZ599M+vLayGChX0ftXzi2YrBORjWEdaxV4TZzEbzBQ63ahFWdi1YT3W9gE/L14m4XfF69byUquA/TTM6jVS3O41zQcLqh5UV9mDDggyPs03+kb+RsMYSOuDiyOasDM0JyvOOdHE8yAEvTSQlY2niZTnR7bVIGWYjiEPIY4VBuIMIN/WI1C8scXsUrcy5Qr8P2gIzKYIyTcpi9HJC9IuS0+O3JZZ0U1WJ1NVi4+si1xMPyKi6o4+JhN44FtXkuoM3SY8xZdfBizJlyNMh7Bf+cC+YGyoxuAdf0VzDkai9/HyTuzBXjznBpBG/miufNPvxn3uyv4AXNoPQ6E2rjswJz8jk/vFBY5VS9mfJdJOHHfeZFO1HU24vZV3KF6MuFemdaC/4OzhNnGcdbsnjvFjufVt2LNPldQH66TaRiBVJzeR1wQKJMYUX83kQDKeIFsUOwcOY5byyhFglU4idkOmOuXBgYA2wNjrlKldrxBp4nWJdwnAyJCzh99ZIgoNXACwLBIGft5cJ2fpzrzwRzTUrZZQpqKzTBd+ChgtTvWkRyEq9UjqCIHED1GVGrwtM0rX4YRSYpfmCKYuJEzkTGWQG7RE96CiyMAhba1F4YUW4wAX7XQOcSiZINBiC5EpJJ+kSa/pCSF0zm850CL7yF6ANYHMglQWMaOr2qadwuOJMUmT7er2Bd4BDS1dRgPShWnyRgOBWhDNKA1VcD+djvYAPi1WlUwLWlGFsLS6Tkx72qS8oAnJv6+XqNMgY/RxIfBq6Tp1XG2khQ5lWpDZD/GpMRBGYRiXeaMNQr4TRFVAWPrbjZImByizOKJs2P/rR+VMj14NZ6KAXHaYMaRYfhfTp8XY8IDBfVTVWXXli14CLcgo8XoiFFDVDP0mmHiK7TViAuKMyNnwSgo9cmrVo69ixdracm5wbrqfWxwvr6FKPOBjDt9Wi6Mwh1UD917t7n4voeqOwi8+eC+eMC6QaWjgcsc+KFoaarDfhqcoVHnMYB3eNjNEDQyXGIy/LGOm+W77BbQkht478R1RmG4gq9orSM+9CFHrYSGYTRnJAjPLmS+VHOprpvFAelXxXuuTijfoJiqj4GeXyeeb1etQ6fRwVhC6jTBrlUBNgvWgMx40qwPnmLEnzUw3f11Ab4WQPjZR2ctPrC3iqBGoa5I8pFTYQkEGu4NSTdBt2vT2vP4SbkJHN6dCGKkD0vnCAXbufpcwVscmaUOzSmYSJNoECGFh2EKUg81iomHusrkZePxEkgIGK4c0WVpsqBcDyiRHBhRCARdIRsZOKlDM5AW0HEhExP54o1b6lN8hbFZE2AYoNc2CL3gkNbCFtkErbIXE2lCIxdiAI31ZYfcuAzqoq5BAmRE+pb3Vb3CQ9iJC7+8aIfMQzTlO/I+swlAfRL9F60UYfhb0Mq7QRZlmgLA1YkOS8qozyIu3ntPl67j9ce9PEWkLf6h/pF3W5eMe4sGgVRJaie9iDe53V7eN2eWM9R3epBe4CL9Dvej4MQtFe3nF//UCXCyP+sNN2wvSMvuylyPq2KGIJiLARwH7DgHhyKTZ8ZII24JDquxFZZEW0o2AYaIFHPJN4zKcN7QrYr6EdF3JuFSrcZOhi0b4EFtAv1ThcyKrZxo2Lc6fy9YiqAFPpBmx8LZrFIaAloDKxziXG85z+VXUaxF664okVFWPDucgSIcJsglZ1Ijgu1uKVmohu9nJuOp0I9AMBegbWAb6BHi1osovrKgk5UP3vR/9+p+g2c7sVN5BWbyE54rKXCR6/aWioumgB8ojlwWUgROEJor5BxxiEvVWCzkOZvOHwOg00mz1kZ/vqK5MmSRZMqGWYaOjqrlQcRJwVeFK/O4T8V8e92UJIsIbbyR0QE64IxGfmaIGlDrSuCUisLY2TOabUGZLHJdFpor1+IggTQjZThv+F3uKOKAw9y1Cn3UB0ZsAdkssmsOV9T4xyD1h1Oy/T4+dQkqA5E48GYoDEYgN4lkdw+SU3MDSUjxZKSy1vwqklkNGQDlC4U4uh/1D3E6LUCr4ElkNHnxpdP7ScZ7eeHUt80DCUc1rPQY+gBHXrdmzD0xVp6hSSTpRB0CGin8cE6+uuXBGE5gnV1NPlK5kQT/M2AEhlq+lg41uu8GmwIpxcbq9Z7tctny/446ZscatRFnfniWCC60vVHv3ruy4fxlGL6u7989fODaLHSsMvHG7cu9E8ONXwxmKE2ehHOrwbwEr8JNYDDqy4SFXU56dwA7VgktQ5XtTTqjBtZbdhZRoNd6OMYmDBVKgixq2TWRZ2hwq9tehffzPdiPI94Wp0VCZyipWysNg6XBulzOKHU1F5EQ7hVckhBxW041Dgmm+JPkfezDcFa4zIAhZAnjOS+jEvjIYPYgGW9AxS2JZSk8nNRELd+2CKoak8wjmXZMFbIvjKbbFwBjxk6YG+Z34vbReGGF5NQnoAm7TEHjpmSFVlVmHpo/Fnn4r+rxe/eYaq0NjYlQXvXeT+9Hf5t++rOQYfuIlmmTd+L5nXOXLRlB0Drumwp/vldi5D5igtlbXs5NVeP2AiHau8699089+/hXy2es+GQnRhImx4+ztBTu56IB0C1OnncIzEhDpPZMEVSMadHIzMze1CGmQhAIhyClgcJizCr0xIOAarnSgCUHYshGYpPoXxF9sWml7hyDYmG6gjjPxaRU4SM0/msrHbhpIQQSUKlfv4pvMG6yA3Ai3MGPHcp4FVjjDBXHIsaMlUBCUSvk3trzMCcyEWUEiAeSFxrcv6V0XAoOeYRhY6rQKwl5AdTzenApfQJdidgWX6x6ugImrY2ZLdUGFM2q2kZgRPEMjuAN7JbFrCOeF9XdZGc0k3rB8cQWjCH/Ma0+g0ZqSMn5M0AStGP4puMkDuPS0jJmg0tEPm6oL15Ps6FuSpCeGaPLaGDMGFdVM9Dn+pcfAHtgZW0bslQQDzD1KMvs5FIjiXCoXRYGVNgT+o5Py0Z9TwSO/wutmzoVC2WDghaNRXIP/hJyEfvsnpk5G8jklqB+jgRWI8IdD/5kXDgoH5z6BfGVWgLBi35LGQyxf7xGsGeElWpO9SdiKlEkgcLTWswDX6UQqwmEaNY5QOHBVRqhhEihatuSAysAJpBGWwA3zA1w2BXSbCcagTfSFIMT4eQl3vZQB/SyQKUpNJ6O5K5fnhN0ZDncJuX8ZkUw0bJrdMCX1o4EviW1sahWoBOvLSQIJbJSBNyfD7tZFGOcnO3GiB7L2itHq1bPQNcHEQl29BfgpbUSaY4xlJGSKAYjpttQjmSsL0TkodExD/1VKkHZNXDma0nnHcF4k7tYRqUiW0qJhR7VS8e8QDU0unrzlgL1EYR1sinB/tlj9AZ7eQxSpy9gJsFfIOYhHfPy/smeDeEK+TGe5CWXcJ5wG6pVmkgD0xDi+ustbiYjvNaM8+koAP3Y/1u8QNxArPn57ub5rDMgqN5rC6ak7ggNjY8eYxDaoPNztUfChxQhtPWyqDOkPkRLi+22BxKqpSPQmaaLiUjyE0y7GTYmrd2uSmNDj8TctYSSDpXkQZSCCRdMCVryZlGKtSlgrVxHqto/qbLQeBGOaoljYlcqE8cA9PuIco5keR2MYQP2MtzAc1nknDmG6KbUXFPXjbuSGyTei2nP7euSUAHHtwgpA6JF2xw6wuCUmAr6SjkthYBnPQABbdR/TxWkIxQkkDnBjQmKAcFQcTBNVgKUnhe66gZZ8j4LJskaSIvnoCaQaBCicHFptEkG+CBSFFEwAGuDUdqiEAX6u+eoSbmx1O4+Ws5xSIkSAG0VEDfWs4D9LhwCAwbZzAtikkAeT+SJNsk014zRojHCNZBakz/NWgscvrSUiTtl/JQiypMJarVwiiYj4QcpOhDK3klEiF1n5203vKgjBBiNxv/CympFJXB4cjykI2+kdAaF79RlTgNE3xVFvhSKFSNx1Js1BYhnQ8cN4wqioTDkQvU3AeCF1FzHwzGqbn3Brmae3fwQjX3Z26bi4hAu9VIw2Y6M8JAdSZiWFL8LxHtCOt34mnt4hYaTr2I9h/Z7LrhozDQHB5ht6sUhpzI9wVyaYntGWs5M7jEhUbyThHMa856tNR0lVmM2WGbChv30qVd217X4MTh9vW1QRlcVG4GeEoA3jAR9l2Agjw51QDXgsMp5zRj03j11e3wwI07GhMpvlMiwNZMFwJXguCh+HGMSmdyrHKhzYNddXUnOZ6ERkrmkYk24dABRV9dihkYGZI6xg3zKP5YAjKu0IpddMtp9AktcMlkG2lK6AzszESuc8KIeoh99YOR2l7CTr0C3sG0BSgMmhFmDOtLwC2SQNbm0EWMKRgKCJyKm0zRqyNkEGwLvCyszGx6O66/ILfTdW+h6EJfXckMdC+TDuUVAxZoOVFcSxQXyw28apGfjdZMZIYWVAInJHEDZ5g/YkzRjiZB2DHK3DINJVyZ5BOF2MLBayYqhGugda7L9pJg0Ys6X+xnCDggso6ohfdCPsJ8wGYZ+C9R3/sdlE9EKIqQNTGnxtD82GlIJGYGaJoS4AGn0Gp0BoBlByDgCAVtvGIHQTISDkgH9+Q/2fqUyVZRgCWeQUrsMTX2iGR1CirZYZ4cADeNx8FGUZ1jaY5QkOAlDgHtgNAOJJSI40bDhCXt8tEyf2bAoKRoUvCIDZjWDRa9IouZOlRrK6xmD+g6Um/tY2O3PD9cIzzl6/pZGcazaJkd4SFffV1fXoV/vtACVbTcKD3t8W01sGQt752/+WzmK9EwCvxsaOmTmGtUXjkqG6kwXeJOCWOCieSViwCupqLotyMsVZKaFC4NA4kG6XahFDIrKA2XLg2lAokNfwdnBJPVJOBH/ECYCuGPwdryyAuG9De5k9IOumBaBHk/lwGxSVYNuRrjZnncu1esOA52wheCWeFCRzhWSR2EwcdE0FwBhmjo5EFtQhz8M+5wrBika2tx9maSER+H5lL0tojwsBKCPLOKO1F+DqhC4QQ/HG78Wx7Wbj2atyi1tCN+nSLZCYEax00iWh3ZEBs0HvdiMOaOkfrLLqSqDhRq+gUxybUDZcuNNqBr7QRVZniRe9fZ5MSYUV+JZBoewL5ZSZoJidC/ndsVcoKeTg8XYUZsn4nTIUjiYsOWjvClF12OYBO6iLACtCY0fORXglgOkXWCFV96dcLtPsLxvjiTtdg5IWEgUc6PkGSTUCweQUiLJD8TSqlFD6asCrIYPcjQ0D+lVEWvU5YPZz2cWgL1cPUKsyRDKXCAp4QxIlI4mEKrigNNQtuafxmkmgInvrHA/0ejBebChfwdnEE9giKsbADNLL1esxeypRe+IPYkvhdEdDF9umi+dus+wD08JiL1Iq51YU0q7KYMShLDzgnI2SspTtqUaLxEBybSRUQcOsh2Dp/Icilm4UZwYiNtb4gAG8Aslw5BkkxzWgAjMjqCQEugIhQ1mkJnSno0mWuXJP7jE7ZfEg0RG8VfObajTK7EQUN1ELrlwbTpYI2z53neocgkPBO7oTgmM+NmD1xU5cqluCLC2JHspbh5+jnjrPVexHIEO4UmGc9dYDliQx8/FwZ0AXKO4tLJ5Cnpo9aQyCK3STJ19ZEhbGtlosXk4wEsZyUsJloZOd5hJfA6STNlouv2IkoU7ConOrkVMHGIS363mSbAnIuCN9wEGDgp4fct03jQ4uLM7AtNTMiJ3aVXbpOR2nIRrRIXMU7ivXIFVpu9spN1surlxQUlI9PQ/Qp+0FpRyXEYtUKBN3g2j1uBvvAhewH6rgOWdiFFgxP2yJgM/pWbf+cNvMm/8uJKSjw+I2+abHTxYzd6f+h7jyq5UPwtLE5N8Kr1GHeBwqvAGtoHJIalYZa8hQwW8PR2w0cT+5obZ4bl56gYo+u1MygzJZ4qdKHJuVvfsU2uRS669dXbRPgVL/kS0SIg5lAM1zO5F7fteNuw7UCuJPCOUA25aCmfFkelzF01LC/JuLfWkuJ02TDsjhGw1DvfIdtiTm3WYKZMaFUAdsks3RLep9iMbBOL74MO17Z1ZvzJC4LJFF8YVeffA+1QLJzWSrol9E8s0s2nc4zQP0ZAG4zi88ZMI7aPUW9JBRGBFBAIDccPzYnF+fl2jhkth+z61qEld1yAn5n/HuCn2Brgp9ZA1vHeq5bIPa2V0TxVPFOE5iFb9na5usMMgmP3c6O/ou6wL6fIelC1ZVDIO7vhVGnTFRIdq8r1PKD1GB7SVEHrbBntkVQRK+eXkosEUmW4UEFmRFElVvUWHvwmDgcxfVgcrNM764uBFBiHlyLBiiNeFcmTxdMv4Wb2zvhcZ3wu1hxyxRvhx5SMZFEno7kXExSHbMbfkXn8HRo4khJ2cnOw6asXxUWjpfg7dHBa7bOQxIwPQWr3VgXklCKHSUM1itFQtCHI65X2K8zw0YgRdEKXyFWSbpPgfYnFmJeRlkHJKak+SOZmX8vZzHMT4hhvQ0ciEIDha4YRE/XJubpyAwlqTXYfu45knRs3DqEtagJf0xmOl03g6eAns1IiGKAc0fsBYvMCgG/ygSwxaTGgO5CXtMdDs/D/ceAB7BCiUmzPQVWQwSrxw6HkuO+Mc5PMV3lcpTjU6YgrzeNtAn0UWCtQWkrcBRhiEhKcTJJku01xetEP2sYjUTv4pziTeNmHHFhH2C7FR6EYAzqKSrF0LId/TNJwO926ECLNVBpKxmN8Qx01kQRjOE5k7JKINMXJRaivGyuYHnusR96LuPKWbJINy3xy+VSg3ogLBNPDwXRjjl0WmbilSvxUTSOh9wWf1wtDvvjciUskQlESfepQ66rpUCai1gnDaKwibj6jsA/sah3r5owlq7VBmExW6wBwkiMkunSlAHo6CuBfSRd1ZBpuIlIQY82n6FJhe7kapVKB9vIZERjrJA4rE3UYcMI1zIVSADQuvEcgZS0pmM1whkXB+jyqDt38IMVPIv8aZwLRRR0VxZj6XgqUgKyRUFu+q4VDGVzfCxNTJybTE/kfaGE1o0wUqANcvuMiEK8CQQMfq+kWBYdat4wYADHX6Ra5b3pscwB3TPPDO6s/KXW9em67w48/2K0zEtzu3MC7hOjT1fqDCujyCYUisYuZMT1xFGghGZYvhS86yU64Ftrin1d71dX0II///h87gKMI1oce23lXZC/hMbwUg8ieVIwO4uXrjouhEMPoEVZ7Tr71ydpETYLkTFd+LiIGaAcIg8B7wuRdoEEaJRWH6XIhOyyUfgD8CMidLoppXATGxragnkBlPhuZhTND1sYFVQkGFa+QmBzxDgWCoUOjoiFJPDOpv3COuEL1ykJAXKzm7yuomArv6nVS1jWEbqfHn32IX/iUBtZz8qo1lAMIg9/VDYPpaAVpoyLm2AGCbHzO497SfMiW4HmtoXOh9FKsCwuTqgKnx2mdHqiM5GfhuHlycTaIrz+68mLYYRVtLngkaKpQn7nMulXJGNHFFShKbj4JgYU5tp24gRQeNAYmZ6UbN7CY5ZIgt/YOu3lw/SVuK8IWA03CE0nPMk34VTuHt/rk3eTkpKnw8LbYagJ3k+6zhodGEHECt0gYE7d7PUB0cagyBvWxYKhqeimuH50eaj2r84ds1EW1qelllmk0XfUtzSN4IemJNEIKHsLAsuPxm4LugUSmo3Ey/qIMB389wIETAy6Ye0KWDowNj7gMT25OyBPj3cggOFK85+wKl4fpPAiyZI5mIA/dF2OhMPobesZygsuIsYGby0E0Bu5Pu9B3K4LIsLhMoeASxgyUhDwekvDo6JVBu0RE0UCdFUUR4M5tpAbgYRxdXFrloCY8JJvykCQcdQchn+Gtws89PU6z7+dKOE7l4HcAEuXcuc3P/XSA/4ojeNBQ3ZD/+GsJf/yrgvaY8MeODDfJ8II+JG1EPJJcNGswbPrtuDqACODUFmIPmhCP6uxO8mO64wXDwhscpINkGKTPVeho+HPlug2LDz232UoMkdGowlk0mDfBozmILkoAlpRMj52KiJcGyAjVgfAusCG20TDQOXySFdgo3CSQYweCjftLVK9MEoyczUC1XMMAeN8Us3AhC0GC8NJzmLSMW0R6wc+RziNnLELQFP3pnxcMNXVoSUNBn318sUhgE1sx0z7dsnAYAakHTA2Gu8Dbw4QCGfdGQpzLHie77d7nFLwoh+ycyBvewpEDJuUcORGQpInUi2CV8E4MMYUuMYUu/dxTRAS79HVnE3JNfTDQEl4+A6TL9Om27iF/RjB2ZRVZ4mBQE5wXffUyQUfwYKURDEOP65aA0UlUj9kbXLki0myRMLkLgcbs1z4i4BCiY6E1F8Dh4cBBzlIe3cVXO5SoegfxGKOe2AavD/RmLGAITSvg4wQ0KIcJiXKPWgNKXPhoQkncRDlNQPOL2610d09iHHTp+gKzKr9RlR8fzap0ipKU4H1DsknxvmztzIhasUl2mgZaQegmmQyRMzcwcJzgekmLiDmlsFtrhKBfoUV+WfQdA2uFYE/SnNi5SsyYEw/q3k3uMJtsTnUSq6SQhARDigs55k630zCbk4rsMelficvsOceenKPAncIuiFHEsZ0HO30X7hwUa+K+ZlZ/TIfwsUCWdKmJsmNGbM4MDE3NnScF6ykU5p44uxeMX+3mYUMBddOwebx3H7GRsKlw2SiWl0FJ+VBGxWL8JPeWcHIe0mjL0giJpEtRN0k/eok5sz59L+ks6UcY/Pr0HfzdDss7VWqpAMrpgP/w1EFMHcSUXsnLV1rrOMrfHTXfUfclbvUmLDcALNeSAydiTF0G3IHR3xDzrOUCRgpOBxgbZjKiJpQFvbg4bkz4y6zhyRPNaQ8GrEsr1NAogXZSAAiydfGSkZnJa6N1QoiHCXehNoH7k2MICUcujy5kcoSVUbMpIFjEPYkWqEhC1TZbGwaqCHjkUrIiMDQP+CJGp0BqcEZZmDa7OEmdeOSFoHscp1OIOzoDzW0UDiUN4p6jSeQPCfw+ar7FESY03xwq+IUgyXgmopojlQ6iZD7/pPtBRheZHzvlpBnHgAgiaGVfrUCNFgrAHtBpUofofR7aBrcHng8YJhyW1GJRGLOPqYyGY/hdzggFSumEQpmD0xBFWXdiEo86wOdAdQqCwOJTCtNtQfWE/8iv2CiKcTYv+IaoMVwm+Dsog6I+wd/BGaUhby0JFfnMkpwf7azXEgy6y8h1NUzTfxEIQkFcGlpwiTh9TnEx3kyiGepguTpqMi+ZQidjCnJbuaFUoahx4HgFLvtRsbuEhZVchCuJ15UgHjKd3KWeRhQ2EVGDCAEHJ/Xi/JzcqiQuabOTIMMVJ8j4h0j/JBaKF2T46OzjllWJQhKRyL2uhfY0kZsoOsQhGC/I8OOnqhNNFi/8nML3i88TkCRP4McnzR6qdX0RNBRwh4OGW5yqWKqHHemzBIETyyhUvKFEklBRewbtVArLuZwU5H4zDKSYOYcqC7NKTiABRYTdxhlEc4VEg18VvTW84one4WpBrhNXha+yTGuNdhX4K8XHlvvc53QKMshW5IzdLFZiu8DeBwMeG9rwGKJzGtbEk/h5YA+5KZClmygQiuAZ06iinxFU5kYSjzsgk9uOpYTqJcUGjx1q1225FKkMniblcgyN8ulcctChyMeIdDAIcmEuhjFh1qBT2JDKDzp+R1HIx28scfIzoD1d0gK9R/OyuUQ7SYKERhbdFFUGRLzMJIwfx9lRJF2IKA4mE6sfG16gG/EBDtjY9lAK+vwEMkJ2cTchKuGBQErBDZ1IdmwUhJgQo18EpfSQnjOZSBm3qY33oI+T3dDDEldBi2JxivKQ2RLGL53pyo1BKQ/2TMLpFETSgHOI9xCMIvIeFE/hn6bIy7m3QMwFGFApPxQ+18pMxJVu+q6kA42UCoh3CP35UYt0/XA3/vlLCwfTTIS8N2qIxJRsFA56u568Fe9JeQPe470po689DOXrAkMfRHkvnCbAClsdkdJjUyeRTC/X2GRkJ+uycvPJMC1JFp8bpKF45IqeXP7vsvrGYDRzDLZJ/BcP1Y9u6BxP2AVaX4oryK//MJkyhEtuAAYdugDRhWR0rqwvYmbEE36JceKHROpAQHTAkLgKRJUYRqOxC5rEwOMAPnhjbSGPSarKBCsGBjPAIh1wGVD6kYharwwFGnFgAtVQBQCxaEImZjakmCyfAD+8lIm7IirizgKMqm4ZUH0eIaEWfsdYFoldG714tOclNVWa5XFQRqhefICJ2Deq92I5QMbUK4VMWa23XLz6Hkh9mYtWhWfbdwBM/BoeoAbCsFxl/I7dHUuN6aEOxeHstFgDiRd7HASndaKayq2eImodBIO6YVhYrLgcK67/TkjcTgVzbcp9MZwEJB9ic/76I3hMK7OQY7EOZKDsx043YqkZsFDpZe9QFNZk2vDJahL9JtFlw6EU49jmdpx3EbBZRIxexDDrlkpGlJYYxAGpihAH6A6pPjsx6bjqCsdrFmXJOZhThLNJuRdkYfwc5FMdSM1gUyuXou6rxGaQEKslivKFGCymPxSHhcQDzHHFkMMIRyekfCEibniYGoU7BABFpKCxoOFMw8lUCsnpQm6ETAfdXJWHXI3qCVMhgyOxXHzhQjtqin/ag+wbyZSZjGG8b/qcHjoIOd/pJpta5FFDPHxOyMk3iysf2D9bYcgjJJdeLg1Ahp9v7p5ECfLR+WuNDgMMIAljspQxSPBlIJ7lohJAe0Vkt5wMbDne4AxktJqMGyrNiMVpURXhaibhyqcSJVwHKDyLZ5jZFKcW66qsV0ZkuZqm1iklSiJZ5/oQHtQgFX9S1bpBpEPrcgtINKlGYYQfKQ4fnKpIOnNRC4uFwDW7FGAkUUWw4mESlEJStSRb8tHYCYlCGhLMUd1cczyxGYFOjcqwrGO6mra069OtS2c8Pd1xbSTwGVEj6bDyeDV0iBO3OleDOY2bAqDt+sTR0HqEknLRjZBi1XqDDdSMYEPdFWyEnYO/jaFHjUMqjqwx1KGqTiTqG6j1cUa8kIal96sq+cMHg2pDmI1GgIUaC4KNz5QBpWlL1XQryopaWbAEqEpNMMqqQaIJMTJsWSjNYogJ48W3kZi+Z7mlBNRUKxPyYPlxMXjA1RRjmtG5OhlKJ1PEWkRcFJAQkxGK0IB+TfCel+CSfuD1cNJTVJi2FBGVGaAyRW1AUIn11qrSrI0ZtTGzNgFlYiWdAolxk2uc4LrEkLnwmFdTMSJWfN116dW/dpfXjNe0h1L8dJleMtadhEArrFwSkPphhmMD42xrAyzSQG2IPw2NSHeN8KcRggB3ktEb3ACUonDaMS4EF1IF4W4FX9nQryKJaO18QC7Epdq5BCeVS1IZN57Dy37ocgPWE63T4AvUhruVmNKZDKm4LZ6IHZEMjykiGkEy3reIhAiGRkNYYgYsLYVjBBetLm49l2VniJLYieRcEg4AhUq3WybjvKEpk+WwppsaEF0mqCm50LVkSxYnxmjqTScty92JGbAuSOyJFXdZlppHBSUIRXF3naXLQ3WWwVJaYZ7qT1ZTqY0UA4Yu0lByBmlSBN4yhU+WEfPGUG6jmLTYRbZjHUvrZAvBDW5SiWZKFfJ2NcnQU6BYVQgrvW/bHHhWIBPlIVkyRki18/j0PEI9S5rKTeAcZHLDxVAoZs8XLhAu9A50c48ID9oyeni0Mzw8uj5M939O18iEH3huwZWgqQCJiOFIVZ1CapeMMWWgbzyVYm2cNNs4N1CYW8QhPkuBwjyVZoJdIuGNOkA014Uv6mLf0tV0xFEJal1aCAOHh2nX1cVDoa5qSBh6cDV0mmoPbMKa6SIYyE/DWDioQAO4SPTLFOYFq1PrGCQFGuQEPjXlu5DcxBE8bwanoy4PKYIO3i507k7DrZ4mlI+WRtFmJyHGmZhy9+qiYD0f5RlkmVkIMWTtFQvVUx2DQnUzUEZY1y8bXnq6Ef4Fcml4KEaL6TcdQJmiLjaCcZXrkXcV+lyoMl4yA18hzeQ9LNtkikdgm6TH+6oRbWTx8oOjH4ifWsED8ALhtaZXLVC3KkNejG8R4LmEP6QnJv7CAp7aBWr5Rnot8rJIhGv8MeanigE0PBdkYYBIDJlnb/Fr40V+W3YZCZy5nWkG9I6EVigw8dA+FA6Ipi82yaPtwiZKuCnHpoCHKCJLXTfFao/g7Y3CV1CmNyIh1EECwcciA3l3y7IcUx+slq1+62EKxstaKpWoeuGB1CF1kKeWyDy5lydLZG6YezROlY2eWe1lVLwzjCBtoz1v0uCmSZsru8zkl8OcPelEDZiq4yvNEh/ESog2kaKWc/XvWdek422nLH1qzLXkUmHotRXLnaPUaCmPpV9CsZ2WyINDDBBagDS5JTJH+gVx1hyxHGlsrUwXmrLJZmAAdJoTRlWS1UqexK62eK7NjlEMJSqHB1OJccWdbQi8taHTugL/lCVa5GfojmkbVKsWHj61u5+ZVYXNqnJIgWWjvVZaxrV6+9wOnwjzYXFeK06OXaHFY5FxzZNNbzwO76dlIfcYdEbiLt/4xpZPeDhPV8igj/XMCPnyMVKkX/XyGwVJp+rUi5XcwE5CtwlUE8pNkuG4RBN4tHBQ/fl4LuvFLyUBjhf8ArmBAiJX3QJVJ6LwqnolumBTRLtElHploqC4vdwAyW6Es0SMhZ5K39lEn8jgMlFVUMsBIIikOV7C29TsoV7sRiehYp/oJd1kQB6AiTwwbaK+ckkglzu9cCo+oDM07kxEGyobttZephi8ifrqYw5yE6dPrPQA0SRohBUfz6MO3XWFPUgTQrNQXZzfuvlo152u4q3S6Jvv4T2EUkhD1VPrrg3VV+tHyL/cRVJPjBuHDCpdVV6XruXQTy6gO7CwepdRvY9nvVIGAJ0miq2BRXDRpOLyoO8OBh5I554ugCIJ06DMi8U55VjCTTEUszEuZjOmT4KTtC5KY3l8AZob7vhjIaHqC1rNIyJHNVAbRNT6YWBHrHGjavFO8F0DzjvhnLgMj7cGaj38aahmqL61oUZqo0g41OhfwoU0KgN6tgF3pU1TXd0z1kYiwQZe6jBRQtttuWoDHGUDnOsG3BxfTcPBYUtqRhm8J8s9JJDRZcUI9OzmLrVCcsTt+VCRACSFCCsQEFQ9ByG6FCh2I0yivg7aDlq4PLlUTSnDOGqAWupzas9Cz1vCvgfQ3pLxqdFdBUHGAUC3FQRtQn2XyL2aHKonnztf86FiCB0hGWEUiQN1wgRmZWqdMiv7IG5gccBAA4bTZyJ0mnYwmmzv9+OQaLerCUTD2ShjjcjgqXUilaCX4P1v8KZcvPGSSANeVIgXFNGivbwVk+hiDmNKjoWw3iHLrjgluGESLKz/M03jf53cd7lbLkP8QQb06e3lAJe/qCEKTtQ0ZL9ZaOKEugbxfEzT7CLFi8VV1YWntjC8ofD9RhAXTp5ZbAItuggXiapc4nhXhZUG03fs96NuNqZh533LJHWJFPiQWynhBoO3MEOBPeZgxRtVNjuAb2Da+GlId+yIIlLgI/GZoZ1Xvd61siJNcnCDD1n3cFsIEk5JQhLMjThsZJPLIziRCBbDIQvXSxchC9niWcLjDpPzj4C3vecTkLhAUb8LozWt5Wezx7QRjRjySTTsFJIqdPEwCwzifty4VYXFhgeO+tvoIvFqLSIUsW7dLsbgQX2sInw0q0QBvGozNs3kcunBoGUubnJs5yL+nlzzR1tGuhl103yhYIyNhG2Q9w3LvRrWq4fIV5nsPjDCe6nhgWMYTXPbHiPyE10hJBteQnbqIXqh60cXwfeGmxDZV8Eb4SaEh7pwEnKQk9Djcy64PpJmCmsnm47XYn5AHE+LPHtgldVbBQMMe41eOWIO83buMI9FHHEe8w7ymLdTb01Hefo88BKHWctFOrK3yqYkcMM6CSEsxvmhyloY8qMTpET2cijfl/N5eETOB7rJBkQElRDB2omB82NEDO7zS9YBUHMC9Y+CeigoMKQgpH4j/GakFM5s062USOVk3KbJptwOOMve6NxG6mhk83hX1ESybO7EzeOTrGJy9HRNWs6jt+NFR17VD3wCKV39XF5iWlBI1EuSNqtuLsAJJpHboZ0UHMkqOjn7RfR2+o2UhpIskVTiFCto5UmYnEh/7Llf4tcTkDkzcufi4jMpVzjm401uPbg4SBGroE+kdQh58yhOppe7E6DePF+QmRM5fYB284nk3EvOjtwBP8GY+ERVRkxq5/65gCOTyR09bvLFULCNi8w/lcaJl/PVgCHA4eahqrCyhZ44qOtiSIm6dD1UFQgmqtwhUUHJs9cFZO70KcX8YYV4mLliKjx8jHyQfOEJIjxwEm/wGzHA6WppGxLGS7AuEcyv2HgO2YUu73urOYX5UhucId6eiUbgNcdmx6LhpYBbDGanQXYEODlD+Xce+JbScLjMoLZCNiOWJlB6IpAIzAv1AC89xvEEloprySQ8g9sIt+3txkse3BVp4vQOSgX/EFOBDso6I6Wr3DBoB77gRusBcYU2b4N8mJ6cZb1G22s9TGzeQ1IMJxbHhUSL9+DkXCLeeoT3BQMCLH4B6kfFMOe9qDQfVwWhPMBYgWUCvxIKRUeb6LRiJiI60FzAu1foXVDSXVzAK5aJO7RyemaJeKM3MKNBSEjdSAb9qQqLSCneM0/yPi3Ltvgo8rYLYMY4NVG5AQeJXmy7XvBpcLbMpKZjAbD0K3mMN27hazfuJjSDbuAVQ/AtHxyW5pdc07ws4ubHfnJf9cUitWIEMx6slbwzgxQ7NoD/pHPKRHUJDQHdcuwjG0UgjiIcWMg+GivhK++wrPzLtPI2c+UtMSVVh3edJMlFlrgoLpO1pGu2cXH1NsbyuyDRUbB5Lrxr1cnj1+BdUFlov9Ne7ohOV/A2HaPf0u3UQILBb4BMQDrm8ltVYbmKXdcTQDAORDq/2VShQnzTixl7HD/IwEiBLst1KG5vpcdnE+yxLIL72cUlUQYoH7bEIkVLHx7qCRnO4lSDibTz+y4cyMaR9x2R5dZboeieciIZ3cZFCaqL2066uNW6IBTFt2ho7iWSHk5xvVKhR7/qWs5DKXHRZ0AgYq4RpPBbCYQ5JArqwt8b0skK3rLLRDsrTCvOQMWgDH7VlBggrptgm9y8J7wTphdJwLgaIwlLky0CglmlEqSgFdVeitkBU1Q/FzkFRz6c31x17kGjq1SO3oo75+L55UENXBon+ZINcXCKwcKmQ2d8cPb7UcuA/jEwaWkUYIK4siSYwfjgJqEMNSMcyhDzS0xOhrBMcKvWWDX18AcjZMPU16fwzHS1AbCxXjrJuZDeoNQxwBRe/xwzi7fXim+dYCglgC7rQffCj8Fbl3VbId3fjCo/siOB5cO5I2deS2iXYENLVSJ6lJ+oayMwdIikMW6SFgQ4AJrR/4KNVPfaYGOdCx/Q0ryRKOETJTjr61d9yPqifBvvRO0p7u3xx4Er4oHGauMIhajiba9FNS/eSPYvLLarDLk1YK6hegvX7xI7IpQUvydsKCzCGxAREMhfEsAFFkTCm6uD6aTA9qjJwmDTo6bw1Y1wJ4W6uWp9TKeqqRH4J4MCnpNYlAffJi0Yla0HAIj1eujXAwuOUbjVVNoQ8dswHWEhnUJE0B7kHaRb1Cn+nVv1mBp12m8urjAWECVqqYe11BPBChsCMRObRlO/6SoNedGKMZgBs9OA6yaRJ0kHAiuJRL31OdkLnE4a74kwuYGFgC89sRj12Emy51HTRSc52Eeoi+F/6R/snjoowUpHSipdxIpXE7laJ0NNCAcTDGUSt4JXuWmuqbkkuQcPbmHsExuiTAPDJnh/l2TEqLqCftUZJDxSRtDZNg5Oxckj6EQEeoXkZZz0l8SFZdwg7kZiWhyAgUaQMa2XxE8k6ZC4xScFISqWe/KYLcUyt2ObTHwrmslJXOokPHp45AioguR98E8eMlWMG+ra15IZLI9pZuNnuouX5F9QYXK1WBu2kA9GGH/S4/IQo07vfsVjM83fjcixjknG7Ui2ePSR6BX3zQhvQiwUwMjXKI5Yy2+xtAZZleMMRZVsLoXy092YUE0C6nglNYEs1RCL52PcULKjsAQ5CsOSuspCyaohvOxVEYmI+4pSAOYBm2OsS4AZr9VXow7xKckRi3NqGNA61FRXrRsJU6SAmCaFmwbhZQ9G5CV+FNUDZqA+YNu6F7StpqjpkUiobgRwef0ImbaR8jcJdnZdcqBNMiA7ASoImMAeodgsPKAVADB/lWgaCafTjV2GQYfYDSJ4i6E6w8ANDop5hVQZMnJ4NRLXx3i8U5M9SCgkCoIBLWN8cayEhVRQEY5E1636KztKnpz40zTkIgkDSpuAnDl62J9L4hN7rl6Nz3SJSvl+PyAceMgMESoP+XmH4Q3yPPDTANbYKWKIJvIDFC/GhO9Q88ttzlU3HskytzyPN7arE2dsh3bosO0EDX1wP+dEmZrGkSt5Ll9oRGSDSUUWGZ2TYSpRTZwmjKnVRMN13o4+zrx75Lwdqos0d/hsAm9CnwlPIdSsovdlku7ID2JstSTVmQc41JeXH8ow7wRpSBe4MfJ4Fza43I8EZyWUyEX2drUhBVGty8XR5GpItTeKDbcxCT9Q6EH2xioJmHF4QXy7BuaQ14PSdomE53gQh4TZQFpusAmpf1DCjhlNRQZU1QwrWE0VQLHmFJAn2AJf2oKZ+LNuvz/Y0tIToqI8wVYiZKUfdoHKZSBCTNsS3gBBlWm8bGocJjid7fJzQ62F4ee5X2hKQ40isCsbQcshwwSnTSTUiKupW8AqN4dFCpCNSSr3Ae0p7oui5lBSoTZCU5M0OkwFwqNwQGk6rbAAhFQEhFQChDpqm0iwDVBsyWorKNcMCjVBS49gzLSXI3msPM1sIZUf17HATvHtiB0rmrOIC9qojcPBxmorgrhWACZBRHiCcksUAfT/AQra0r7wo5AiZlveWG1NoBxisWmsA1CP6kzaAWgnCsRWMvRDhZ7ZydLOmDFzvzQC3FaHk7Spfm79I/Hze3mojdqGCBNvbB+JsQoMhEG0gnjAWjeQ2lZtDJDrNaA8le/yBuT5Qk8kjUG6f2JuTJXQGLpbSgNeTuOghrkHbU+xRQztBwf59GArOHwRZySTAASoZ+iOryf8S/GcCPKC5NEBCyFISwSz2OLhic5v/BQiPrUV3xY81gnGn0oTV8AK2LKseyiVX4fsQ8xYC8zUZO7EBw+9+TXMpHiFEg1gerERfsSxi9cdX1uK5bIdTuzD9uOmMlxf44W5gVRDwltEXSDKRgrEiCp/Mwr+hL+x4X+M2D3opEti7XTlFAr4Q0zI38kQhovw+TJmchc7JgT9/KUaasaPh+DNoSaQ34zUEcapEOJITkUWsCnssNYEv02hXGvEmX6OYnzEJ4YQlcRWwg5FyF8okccHECcO4b8UftEK2jSqvnwkhjiKaiXwGLF5qYKDJYMlHhMCzguORZL5VjBQR+2zojaMt4JldOXGTo1kAN0YzAv7ayPmqOC+VP42RHMdgsFIiPSC1gMG5yXueCOpRjPAj1DSzjc1hctsFRc5Gr5uQhPUSihWEdVjVDhC7XjOQo6xUzi/RQewS22NBAJMXDOiwrBYunDvRRxioBw7ClFn8qOulGZPHIWJ3JAYwzsgQ03PyRR1G59SxCqgdiOflIww2U6aaDRYTM2NzTYTTE8pTjq3YLtw0jGSOIoidArV1kitE8H/yQ5FUPh8MmEUkGplTLgtJulzeA/ZbJz+UUxaVsjyGZ2YPE4VQowQ63OVAkArd8F2Ck8gnGcXqa25qkEho31xkuabQn8b4E30k9HbkHUtcsp+CpdiRJXmMnvjBlpuw+0msUiI2+In1XJbT6oVw5ornA0YQ55ATbzetFq9yNfJsa+TLaRTEnkVJ6MI3IfEQArpwfKtdHsSF9kIBRn35kYWNoxR+y+ITp0UBmrdjTdJuWF7CCsr2BS55HNIN89SjEiXCP2WaAboN2xR0p4Jpdbqf+qqYEqs/ymo/6LeJqsp+dDl5LiIjWiqaInYWAd1Jx4+t4nULr+C0CWcIL0Y2hSO61I1Cbd/CCOX8ujaFMvaSLrRTj7RUCZbdRJe70ZZ9hdJArIyya+O2LCwK9e4ljPeGsEM12ZoRQzlrp0rdx2kkrAqdJ2YkcqjJwbM6IkiPiJBq5dMuUkr4zRMmYUVO6mUgKE3IQ8VRajaWM5PYuxdMIC+h4G4+9msfbUEijRc1AQT7TZQmYtrLCVuf2G4myzn8bawEi+xDRadDp9N798yhVr0FNWaQZnPIG0gYZcj564l5ywbp8bswtjQ8HCNabNF7wU6uXCmHXymyTbcQTMtG6pzmmk3n2m8RxcldzibxkyT0byfwlO7+JSq4v7aRGjRTyox3j/zfgO07VITuBzon3pGBxz3XaRg1R5jXt18XinoOrDgPEo01a7a8T4S4TNlCtUjfFJiJGlMky+UxMKr2wgoUomh+PF+GHQUNfQFapzzIArXlWxjbc17QQMVZBb4H0W0TlNES+YKdH0mnOkhey6/bspuRLjBC5K4HyU5vTnjfECtIgVEIa2VgCX02yBrSBiPJQjcYLKC8KAC0oNXq3L/MdE14wJiXHPrhX9uWkqPuA3LuFuXi7T4zYJiHPyC3VACRTHi3lSlaLRniwGApzQU4FG1uHGMC/0FRYzZhEgpMAKJQIF7SGPmzVgbSoiongjFmJC5rA0lTEmqzIlc7hiOkVfg45ALipKFApevwdGYDPOWJCIAuUTkbLPAP4V/YhijRgKKMp17KtGVIjbhn2xIbV0+bk5DZqFe1dfdzy/ICFLsoEDQ4+PHb4UaU1p4MIz9fgK2GR0kb9EFN3fJ2TrM/ZLNTxQzHGvgE67J2P52McuDo/pz1oumQOHlDm57ghSF8KpLUQf5e0zqeH3FdB5UUT7E3xD866PH6AdXfbLKPhZt7Q7yHDSJOxl7LMdHZM7l9vJW8Zoaby9XxCdLNvOaoaoV/FEvai+H8ZF4j3J8othZ9BCiGAwYxWklT9sxrehreDGR2mp8tM5SyM7jNyj6biO3Iq5K8e0OnivKqujOV8x15dRjfaKYRT1xjDEKnJTEMRkhBdGJDV3weyIkKXmIeAvotkWc5aM48vbyM2LESnt5bmzwtFS8OiRRO2I4QWu8vbjYe0CaYvAjvnjF+CUQV0iopuDqwK+XbvZTxods4/Hu9TF02QggAdVWoEtjQ3budMGnlDuh4RHFb/sT17YbE4ziXh1BfLJqnzCmPW+OBwckJa5Mpr5G3B+sugAt3Gy4hyn4ro3mwObzods19Hcm9dd5k18SpAM1C+cjnEbwTwj5TSWvYIx4GEMIHXrvG68H4CWMSbeP111jcIYLsB0cojxet40J2QqwHkxL43W5Vloy07kXmQActfJPo8bojpZxK6Y9mY9HAMbTHa0njJFzxIYGLHkc9mzoV4QkCE2FcbO8E1eIhE281SDNz2J8RvN3HgVSdRWGXGN4b1RXgegIoC1S0chIBLuQgLOhwTWFunRx/Tra/rgghdsQurpYwBr0h1YA1gNbm06r4UbLZHSUcP9/Zb5RG756qzHXdF37xDEwOUiLoIRUMcV2dO+0nkrlFAyAR5bHvDR5ZcLfXiE7ahEwEJod3XqUoJ1QJBr20RFGVAXQHRizFZ4JxXAmRbmhPmq7+frB5MAk0KkFLYbI714RhxY2rnCHJDsqGu2AjRVSVsfKuSgXg/5QvzHeOFoq+zzoEIY7KFp0A1nQpSASGT2GLy+fcCc/gijEFeAXxMaNKVBoTU2N8wYex3g8LUPx31quHqAFQLNKVK5UNqY3uACFSLQAHZ9Ib2AJ7IV64nic9QLVXkAIqJBcRtNycUUK9AZwrhBizuMgJqJ7xS2QnZ8NuohQzYI8cnE9PJbG58G/jbtnFJIcx2WsnLFEDtXWmyyvYKWQPuJmNPRsDyo8EKCxvg6KZ8X0hjgUVHNQ290zkAvkF8lK0AqPW0UYwlVA1WHwJa+JJ1TnGL5Y/4Qu7AJ8GYIvtBcDXzuCpz0GvnFpyUzHgy+aCypoKYfHU9zAe5GAU0FwsNMK0jBRW+TAQ5/DrAsfaDJEQC4Xj3tuIEaoCyfQhbBMTADCMqTjYNllwHIcLvK56YN4GDVh2WWBZQfAci2Y57DMTFh2cFhGzjiGtPE6V94PK5JSaG/qgV7+2ojOgm4sSIgcAlUDL3KsyUO1KyYK5bfHmocHpyoECsNHqtNAvrDjeC/pPMXrhW7ivVxi9BqPIsa7aelY7eOXInTzHiixii0kUjdebeU2Gjztjf9FL/ks9NK/UkuwiW1Bm1e4huPEvA/nkBMv8oAe5oW8YwClyWSXprdrL1fjN+bA1xEBxw9TTK/mBJ3KXdlv4iG8bvLzzRxfgc7aMt4B2xi/QAmxuUN3cp1INhGfhFxD7FwxaqcVysWEQojaxTkvg94EGCvq7rejsTSv8xDvJrkjqWwMFxuwPBKs892bi0H1HbiAaOf3N8eG9tqDtA7RIYaIuES5wY+fi9YVVFVLPieFAwC0Bce4UaPNLCSM1mkg3RHlw/42I35j9HGgBR03ke2xU3XkmcsfsuXSugAO5pXeRDFaGDSHyycIbqpE3FLGM/EYz+O59dFIUyGH+6IefjsgR8K4Tgpi5SONNLyXvZx6FGtUYBDXsKHFYIBE4BUGTUqfsGcRchIK/4FGevvpZi1EVbLeMZdDgzmTOI+AS+iZxo+CPEzQVkI0QymTJv0nEBFeACEOGyEXTKpsggb6JBofl2w2VlN0TtAp9F7AKdrGCfZBtbAOBoPAu3+Qk9UrYshh97b/3+MeVDSwFVyDGscxAJzHswu2/8ouqCarQAFi2zKfjpSiKrYn4zsfTiiAU96wzWjYjgyogTFx7b2q3cSOdEw5cv+pJxbMyYye4DXXvCcSJ6jMFXb19jPLyqqM7DdwS9gNqInnbvi5Cs1059asHHIwHo8YIR6+/wsn8aTASoDI+WVh5EjGzxU+vouuCk6GcQ7YId8u8u1mPro7w5kCNJSdcLWDcwuywcZZptZO24o/0y0ldNopAm/z8zD2+eLY5zMtn8+M/5xuV0eAYFQR2uHbiM0T943i9YpcFa7oNRQl10HWJni+xjEcIda9Pv/eF1LIwIG3TSwGsD6uGMNHEYihOJKWnMVQkORAnwAkVdycXeHEiqM7IXbHxakUiV81lMpjq6DUAVKBWIqwHyev0EKMEypmUSJUFE6o2PiNzoxCMrkNTtKBelBbjGajb2mODQhgfomPc7oYpw3HOd0Yp1sP6KmqG1rA6xZzxTfd6H4FdEpM540ETOTVXg7wqtNpNlJFBlq2KhzieB7dpGZHH0RxzOHC6ZPH8CW1CwQkW9hEu1g/O/HyFk5RMdAo5/7t6JIJ3AHnEwH2TT5RITqFbwOb1+AMFYN3V2JcI54/jYn4sJtciP2/ciFkgBvjQliMC2EGF2KP50IUcUlGA7oMBGcwtmRIWMZ4JYYm75wJ5v0nfEK88HSxMWzoDCobg8IhIqthJ6ZFIaZF4UyLQl5uXDscsgny3U5nFPAhPPgNlUITM2JKQi7iWfldtTJfoFhzPtEqv9Di4hjeyzG8y4LhsfscX5K4oIMFx/TiOEbXKaoOGXT3yoBN2+Q/HAxeAx0jsa+zlvIOLNqBYsBBqoKn8A4fdDVvz7P/8Zg1TlIo3DSX37WmO/lZyKOs3cAnxYZ0EwW/NYCZOp4XcvCj0WGCs8NARzrxZf8IzrjidmBtOThDgxZwtpvgjI5QXOwRh5P4YewC4kqAs8MEZ8fFwZlY6Bg42/8RnO0WcHZcAM42Dsc2SIp9b4Fo+z9BNCcsakG0DS9XERySGBoOFAlGx8WA2h4DaoMZd3QnntgK1PaLAzWnYOJb9ImGcRsJ2ZgQKfE9hsCRzneCj+9jl5ffz6kg5Wrnn1CuXYwAGiBUzdfHx1fL5Y3xbUotvo14STtnL03KyAru9hj1YQrfeBeUCxgduo/Ka5wRBK0NKAih9ZSofUagDSnJ/5yW48FLx4MXjwfXBceDlx8Prn86Hlwx2dZFTggugOWeJC7OSxsssas2S0xxkTm3Ld5gUpRm5LFk3HrDN53t/7kzhPFNR361jG86xsFFMjadzdx0tv+66dDbzLLp5Nimk41NZ7tg0zF+hrALzxA7D/GGG03mG43xjeaE+oyNRkCUrjJjLIJCQYHMP+wymShU2dxnNs5lwT6TY/tMNvYZRX+XRUg6AhRLgz7RrrDeIgE03zG8N3yTMb5dmNhkLg7hREV5DHgmoeU/wTN5+rsInt2GFN+EZg9BswehmSE088IEzS6MuJDO5akCml0GNLsImpkVml0WaHbVhmYWD83sYtDM+H63mUekSYRboPl/Cs45VHOxuergwAwP/yw4V2IoTFUM8sgQnNtjgnObKXUieyaF301nOJ5zldwBUslV+yWncfc0UgVoy8Z4vMCQDDAT4psPnSvHcPfXMTxmDvmfA7aTYuyTrZef7kPLDTIry4DxP6gGvrclTt/Ltc7VkIPoe4ncjC9C31sUOkSOQfF4FQJCiIT0vRmh3Yc+0VyqQY3KQN87DMLLYdL3EhLtskG040SZKZ3bY+EmwoCHIUdcUWQF0LPZpO/tgr6HhZeMTsTT9zIZ5/fgSn1ypvsX+l4hp2QAeSeCvIQgz78hZQPdt5HOGwnwaxtpcAFedTrNRipmSMTCGAQh5gkUaUPF2xiKQ0nyRKKIOGHF2TiABXFoIFQQrCfS/TgkQeIVoOOuuBZTR+RlkbdQCGOdXCQuYDYZxVCYazQjNpJkgk0PvDHIFJ9ahKqJcfxorIUL+FHewszaLRhDSkTOGZAiB1cLgCr/CqDKfwBQ+eIAyifdAFCFA6gSJy1X/gVOlTjgU/6fgVNm9OUicKr8RziV4+BUscKpZIFT5Z/gVBFwyi6AU+/FIDAOSCQLuBJoCii+2Idc2sMXmeHqyha0zOIpDMDsqsxPY/KflE2kLCIQUKA4WmiJH3kSuQnzU1Gi1UtEAkPmjQoCgyGBQcRDjMCQL8ak4sXhFgLDQQSGjEyqowCtIoDAQGxsITAQ/XHKAh2GxSzG86lWut7BB6hwTlXi5AaAo0luSEhl2/gEirFJAooZURwyURwypzhkzqw6iOJwmOwqQ4pDRoqDrjikcujIxykOkpTQxWcK9aB2mz7RNFE5uDMYf2sTHTLJdImT7zT7LiEq5mJXdPnQi1QpQ8hhvd6bGb8tQGN6oDBRwEQNzQMUv5GH7oBpzyadQI84JYZehDe70HeBgzyGRIiH+sCLvsioUcKblxi/AGYF2l9J/1rkeV7ExqCqEo/kKBJWodwOQuZkudSWsavx5gOMY65w7y8btwe3iwMZ1Xy8pHQ1wymfzEvKvKR8sZLy1QxB8RFeUuEllYuVVK5mCvdOU7g/m427khGDK+NLfANcrlDSAuk+Bl1thGAP1W30MBpXI8BBzt5SJnafnlwdZC4/QAUs1+9JgmwBooIssczyGEoG5ZtmmozJArE0cofwj5lWea0qj7k9AEk7JPRQzBoUFICLpjvWiDCP4vZ6vIjNKEIXmTGKbk9FbGYR2ShyKWPXMLq0mTctozoTF2yMcd2woqu9YqFWYF0TFCbJilc0EHJczW8yAkDEVbKRPABXVuHrZcP1QjM5iaIJ8iA9+CNzzz8gOV3A+Ovp4ws4y0y2Pi6uzMYsVyyL7rH2XfQrjA8jtN3xX9FdxxJfUljgG7gnGsEldgN7Z8eDwRgOTofCgZJm5d+7HiikkV+s6wHsROCiXY//Kq7r1q/iu550QddlAdfWlVD4zrMZlzz8c9fTC2mpLtb1dOyE66Jdj/8qruvWr+K7nnxB1zH2JIeugAGKAnXgYJjUnkkE5Mzegdk5oPqvYX5eLvFqlhi/B3lVsb3BWAdmGrHyLcKLxPYGY+2ZGYSLbxFe5H/sDYXoSD7rvMuAHr1/yrJSJE02HCphAggNImmHKyKSutLLyJT5D98mPBuhzijoNAsqFBXdeO+m90hK5CHmQoEhzHWNNEafMnW6Kz8kcVZRRuXUJMqX6Wu+XPS1ws8k+kHicaLIlvVCs2A9s2A6/0nlPwH+A6wdLKzxWb75NMx8GmxURXOupxeE7EgMqHRVx6tdMKxRYDLqb1F6L5HRrqODIs5V8RQwn1zmk4pQJSNqhOOco0bm3W9TpMmScJvYEJK6qDNfREKmxjkG46AUV9QovQRnB4linI8XC3Aeu6a37drnz+DvmhFrdnTHcGLMihePQowdaRDdNTV/89uJoZrsXDT0P630opMH/osg623819X923n/t9fKUPHMN6VxlVW9tHCk6zXzh72dOXVFFB77dp2Z0HfTB/j2kVEnlORPD9Bb+rMNo3UZFU1deMkb29a9BRXdLc3LyHf8iOV2zL77mR9asWx4vKHt7AYtrlYqwpbg3GURlYUtIS9VttQSgDXEVPO///v9NCr6P+onmqotN8NWvfVjOS2UuSoogoaZCGOPw12d96Ze0fyFBeXhUlJliVLHoNQGutd29LQoyr/CGPJTCcOXxhdZFPbKHsEMe7iMaistLTUrCNOFWMtwu3Vht2dQyrtQkpRJlhnEBZYtk6iUhixm0zaouxS1Fvhf15K0XfXC0h+dI10n3LqpTv6mO3AubqQ5ex7nDMoQtNBT1wMdZ2489sfKDZGuW99Ys+G5U8HOUPrV254p7j154cYwOW+qUqQ0HPZuC9o8RfKk5CKbGWvWlheymwbwDqKR9PQReFkORvy+HnUcw9BrAHWJKvFNJU8XC4s0ccWNF/cSGZa7VG8eBoRGOZITrdv9Bj5zAq+CngSqkod1rKQ6yEWiQiZBERreX3hVGeNxQH2oC08ybisgkc3amCsHFEjSiyiPMojdhR2faNyBjldM8Vi+eOMQEIjkkUG14sVGfoM39NXyvya3EQwQoYeNMVOz1GnuqUAdQOXksFxyw0O3Q4zqADNHUbRg1EmE8elCaKWQf5sLyI9ud5LxHgY6NKQLWsaARPHTgIJyNQGNGMlNAe3bKUgkjzncWnigUCoQDmN8AWxH5lyxgy4fls3L7lL4MeM0XZVpUD6MGuvMM9xHoR4aMI9Vwh1nhFu+j9/d5VP9IgxWbKipGDVnbDBNv1R15wXr6O3wpy5dfgTNVCow/km5dEUtNIlhw+rx1/i2vniEjmfA42gMd+/Wh2K4ew9OFpn6kw+fTHb6AeFDiXH0KbYa3ZDgNLxce1BkepkvJPTQrzZQBcA5eUvcxxAdbw0U3jkSSqzlmpW4igeR4a5ZCSIa3dqQAaejN+FUhQK1PgvU+gzv+yKBKaErvnqJ8Nn/Gy0jgZZAZytvNRgwHCQElPgt4IE3Z+Qhn92Ib165UNyk9T+66oy16fTy+SUzKx5X8b/0Or4GcdOuTDtH3DNIfRcRgNXkwGkyGDP6VaFFnhGPasU/tdE41kZjvGaq8dpSfiOibMRhAHhSCZ6sEIvSDBIFA96pOw5+6hYKbapDrTMuGITXjXN53IJkv1TrY/TsqguFvGoQ3b4QInUZvgmYR8IQEm4FjUiRKd1MYReH6xB6vek8OD+86E79m8zh3S9gWSBSHhbUSbKYYAK3v/Cj7rTYhZfM+tHHJoEYWrxmIo8kIggkSNuHUizfOkwXTv6xgz4WvUrB5ckTMcm8hgtdI4yKlBvyC4dg8qImOKBgSaEE0tbw2p3WfjnxmgWj6gRUB5lV4/0mfpIsKShkgmTDBFlishdfSQimtRbKSSeBKo8h2V9juiQF5h1NvmJHbgAWnZbAQWBhuayBw1QpQZmZwYRQA443jHwDP3kkUxY34flwnuFtWi6n0YFqRmyTwQMM8YXBQmJxVMFGGTyTwSCpjgL4E9uUCYgT0QkRRuUXJtekbKkPWVSxUaGDfzWJn3bC18nLB8cXgMe0ogL81jYfsno+fni5OcyYVeB3dH98OiJ56re4iuTCchjXSVF93MXfT4Fo+Vmi0N1PhbmGC7MrN/4wpcP7/9rx5/9/6PhLvejxl/I/zj4R6NOnJlDYgYSgj99cTnEb0uGYq4WORutDugk88t8QqBxDTfIFCFRe+3+GPvn9RwZiuchX8a0mYzg+C8iQgNVr+n/GNoqbj1bcJssDm5rHrTlv1qrofuNOdPVtES6NZTb4bvORLNAIiYrfoSQQA/ghrNNF4AhktP7xc0lwyStHyMBIpXyL8XfIphIsjEZYSLS2SzGpxHYRHpJ242orHA3uFFUO+fOskZbQtVLWDTGwrFevNi7GTlLlGPzgxdU3k2CYkCOc/71gZBTM2mHeexqW4GiOAVkSdhUj4dIU+SlkjreW25lqS7BJsswcFpfRJjyYhI1PbpKomIcmwk2CXpZinciLN2AuFRVMooI8cHaoKdEl/AaLRLUpIEtyqUwKkkgvyVwlhzibsQYi2ggf0Z4MNaNRc5fR5givUGVTgyaH9WmuJvJaMbZFM7UpT4hN25Tok8m49NINYmlkPjiJe3WafUa4iA2ViMJYJ5pSw4Z3NrTa1GhVQEQiNcRhjKRMZjuTEQiTUEri8MuWaSbzzn9gF4wZzsXPnHG5MNuO2Gxz+JJr5RNaK8LxBaj7HItNrIXTffyIESHRHZYFGMYXAD+i6yDDNNfiwSUezHoH8HonGfVKamAZRurBm4V8tv8/GCT6CoclTglIpL8S4Vh8eLBzQqtIHOg+PNDFpkIpkiwCxgZIbCVaH208TKzdDfyCjiCbQWJTmDzZPKFxvmQ+X7xW81OOOQhEa4/AxQ0qLzrXTWInfBNRW5MYGjRrcxrDo2jUvgvnucn/nucmxjw7cJ4dup3fd0uzS0d3kGIFBngI1CboMi5h7koJhyDxIYnMZZZceHbh+FYbVzUCLecc433BgzdZTcY4J1LchQNyLPQvN8DZEFJQlheyGdI8u/7HgQ3FNm4BVVOjjdH/3NK0Ozm92vW/3pxDWUiRdGG386DsMKHZKEyKhkOs62WDHqg/cM3eDeGQg3cXALQ09ha6i5GZ0dbO8qVm+fLai355LX1ZBF+SeuWCxt0VsSoqL9p4JW9cpiqsX2Zbvrxo45W88clBbv8O07B+7s/GNNj18j8/49OF07Or2NbdL9fuYbuiSZ8nUw93Ll704oKEY7V6aL7FdhTr9NCX2ZYvr73ol7yHj/Cx2WHFvsd+SBebqXqWmaq+6ExV837Yas9UPctMVV90pqp5PybRTEE//tjy/SyYGgJflGBO2/HBiHb9vzdlwR2vM2KPd9wSpluWOCBFwsCgOMy1j4RcpSGKY2HXU8eH3AC1Xa5E+XPimDw9qaeIVeioRbU5VnFXN061EdhQEHv0h4KSA0TVrDTkgRdjRyuXzK5Xdk0Esj2lKistNRqlADvWFi/HWCEeIiQxiAQPh84/xtqw+k291GbLpj3cKYL3ZcXV5qUOsFLVVcp3NsEQCtCdvcQdB0wMFp5xNrnHHucCutTwP85pJI+FP6s3senREKs1dlZr7KitWIsLFhBmd45Sk/6O/Pev0XK29redFJXXaeLVgXTLg5u4Z7TnduGNLjK/BRuxrZsHmiEPHwrrYv3Syz8ib4LU8frxCfwiJ10KfEWUtI0QKvdY7VLUl0+ZwIyQ41pGU6ba8rjtJ82hkUe4UrZGfl+GImiLaiESUZWukz756J6rP//h2kjXE8+0nv3jD/ds5MqCro/8/cad3zV8v3Ok6ycDN9ULS61Q6PzCuUBSUtIUDfgp8u2OkAGnzF16UETei0vyo2GuMqBY8VJMzI1KrkhpRJVKVbtRVouES73nJOuVZ9YQGYS34zUwf25ZUYOKk1jME9TRP7dpmVCfmFMcOMT97DjkyTHIQ7gTr42zQZUCX1PjyhhDIy2JoF0usx7rS1ilb/D1MngvX1B4GVV/YekLTBL3ygqeXZJV2RSSjcEqZp8tuoMytGDRG6F9TN7acCJXM9bUvEyTIhLRn0m1ZHymZsOCdB3+ZerU90ZWw4zH5GO0SAQU6OYA/3V9pQ5L/vT4uY2Rrt8PG9JkQWQCrnzvep99eWurZ/Ex5d0Gwx/5kBQ3w6jCCi2s2oz/uqoDI12ue2YvfB6o3yD0wX1BVPYk5n28NbS3EB/f29O+743Pr8ZH96EvPnxwwufavymb6I5BHNE3dPDEpgHAL3CYS2bQ3nkZGsegvsW7w04XvpF1y0cmoBT/cWCLpkpLY7fBh2TV/K+r5nzS0zE6MAr74Imn7m7fKoKdOpnZ+dolg8pxpN+rtxbv7H8A3/68Zd2f2fs/w7c3vbXwVTbvC3zbcdxvG9fdPSgaVq3VNky76s4+c2bCIdDgq1vzNv80B4s2vmrQkQHNK/DxxWPLP7930Jv4eMWoEwurr/8WH5t8dyp9SOf18fNSatXASaoUKQMKS1oqQjgy/eQ7T/OjWY7rwQPLCk+drnoNBrbo+p6PV/Woj9qzNq/1PFWW2Q8fU5XRdwb3PoSPwzJPBuu1no6PY+rP/sTf8mF8DB7Jvc131UB8fGz86A3vvnBFdhg3XFwr925etr0q3KQi0vX0/u/vzLmtDyrm3nx594l7U4bi45BQ5vQ3bhyMj/PKdn3vadcbH5sfWa3bGjXDxwFj3/u+zpWk5btqsH9A8pXTo2GO1eIG03ZMl8Oj20Mzg44sP1K48hHs1Y/XfLOn3ukyfMxtOnfY2pqV+Jh+67PpJ+Ql+OhZnhF67d5CfCy5tWHzOXd0rj2CrlrHQ0/f3HEyVLzw7ktyB9pKsE+Zp8elzDw5DR+X/LTtuvtSqf/3LO3f1735Mnz8+tHNo99bdAw7ff2oo51Ep2GDWzWIgOuAfg0j7pMB6VpWNMwDQ4k3h6Ncq2jcUSmVYfAtaRmi9QxYbm9KbDuzQOA7smK2vhst3h2RbYhR5EloP2AQvpJxpANuWTsxV9cwgIFMSMqy1QCtfADIRhLhJGa5elnZOdxg4iSeeCsRXICnMOipGtuWHB1JdFrpLPA99gjveQn8YDy1Vla/QZGXI/i87g26/iSMNuWleM96a2XHGzR+eq7gzyxMSlvCURG0V2itHKUcfKrEJ5pfyjhoZuwVGXYY/ou6rVCvpuGH3zRkM1BtOEj3lNCrloiru7SdMYl4PYq4oDrgXDjCu646ougRDw3RItu8y/FAxVmgWXFN68JuwxUz5uhc9qQoegugytmYxKKImB9RploTZdDxEylOYx45bWIJ241WK1CwNGx5S3fQhGMYjVTN5jW3Ee9Psh0NGehW+Mn/CAm9ap+kBAK0urUAQIkDAPlfAQAp8diymx++tSO7TzxkoCFpF2mGUfG8KUV3ZATJUw+WsPoNESQgjBMElKVBvggoWPKmsdglb/LFVnjGTDOjWGTQ63MCtqwQYY9BBIcHhAGgyEyg4PAgm/BwLAYPYnkp3oh36b/Dw8QYOJDNwP+bkPC7nUxa+EWoVoa4lnHLH3vnTbUJCukBjOmAK3m35Sp4JBe6VnX64+8ul8zIHtzNQm5VImwDQGw5dPBvoMPQwPKNbZsNmoQDBBWuhG8B0QcVFLJ0HZ/14FVVnY5fGyT/eDNfw/yiWP6GGGPAuv49tXVOj7TfTNaqEoiiF8IhpRZpr9QWZctrQ4rZYCRILi5mhyJ8FZGOBTArhX/F+YMk2PcKx4oyUUsWuw17vJ1O2y3ukWvPzwbip9NtP87Y+dFeNL5Y++Wq5+rtScVj4tG+fwMtfQ+e7GeQlE4qjVoPecvluxh3J1Iaspdab3qGN2UxmpsclSK4LYiIQwwa4aYjhrs+SWWBnJUl6rhiMduJ3bDMTYFFem+UT51lkGHjK1bBqUWllFvQWLY8IgJn7qtdrpwRJYJN1jtxKDKbxNFZvgJoQX+jCE6vq3tGDHIBJdSgto/XJSLz6ylxpJ+9lGoOB41YX2imE2uHgB/q5pY3v8iKMhnvq0Y+osb4w6YB+SfFv0CSQOmTEbJFieWyIaIE7FCTSFFGyAxOuSMjJEeR5lJtt9ANFTR7MhV1CGTI3znQX3gTvxha7Hbyc/3b28uyodulRhDjWFLG8+o84rpjqBlVIOU2K1W/Os/6MaZiFaHCx0l0YsjF6Xu3AboyY2HgZj2Q9pSGQx6OVfGq7LD4jahuwCf4taU8jQPKA8uO1WJtYfEbAQ4/jH+Wi0mva65WjXmFOZAxXh8TPD9wMd7jNiBUHOJw4shIIMNZ2ZP4yizfLN1hRX/RMDc3E2nslgwUdynS8oTtD26mAyPCSQrB2TgiqAOme4+hyMotdAY48DnMn/lZssU8S/AJRiMKzbQUKjYLndscV6h6c6zQ0c0mbWIWYnhbrEK/nFbhKNuAC6lLO4Agl15SPDlXX1482cCaFvik4wT4yJO1jtTiczXsVuF35QJkRY6ULr0arTjhnx7k9Br4SXxlAt51kQ1GBZWTJpE1vnkGZ08Kubtc+diLa0N8lvjY3F3a4lnBxsDJCV1dt8U4NUN4LfpqI4kR9M0zb9ojUcz7WOSVQmKdmQCYCuOZJ8zh0H6N5m+vOX87NlsO7wrz9To+rYg9kJ7cHFvQlWIZYLEVDpIcICNuhzSZTGrhr3sSbP0Q37QKkUI2ffOEXI5tOCg6KNOpTxmdq08dzQNx4hWXNZNv4BdwykCzwCQVTTKWaFSf+CisDnN5NKCVVPctfm6s4MAPzczRCN5uMmDFVB/uoSwhSjXLVOP6xkT5tKmhfQ0WQxobV6xP9wyOe5Cgiu8azTFF3nNwUZJnGex0OVBNQg+pewaGiZUxS7aEby1L9Iqbx/lXOHD+SQhvXY6BlROnETUzVogNYqBwqbueXEjRu8X0xc2STd/oRGIhfraI5S8O9ILXU4zXfbpbCcoYBcnjlFuh2rpnLBDu8Bq0WTYwZhTag7JXf/LFXAB42QKzYn1ck0w+DqbKhH6MeqCf+05AccgXicdOBKqYG/JHQgmki+Z7KUDA+h0BqF2f+b25ffAqTR+Qk4COI6HkMO4KD175kwgr5AM6L1lNUP24RfwA8lTLOqOWErMWFXXNHoJ52lHQuIeQuaCkvzM2z9HvLHuq0nx98Duxp/gWNN/vEO/DoQTo2QZj/jzQG7FNaAfZTWaCFnqH07LQ0RhEuQBAIRsYC7KUoTjHMZh0mYvqinEOqrcUT6QEmCIienGQsAPCqAsXzKSFlcS5oxPGwkoyCyvpDxu8JD/ELs5LSv/ES3pgzCbn4LyQl3RaeEmA/lcnET8pC3k8ufcFfhYjk6PocwyNhekiZG9flIFO5rdyqMzCppEAUJfJVP0tF7/2FHgmeEZCaUZIgb2uGgcEXT4KqVsyuIfVTomLw/7vcakhKY47WRrPnpgli4uLpkXViy18jI0clBGyhzEWo8HFoB0Hwi2ciCFmlZBn1GZjXpOMywOKXT0t2x6oSSLZJJiw3uTLPGViblAyOAqzCGScr0v/9MoAtI5FcI6g9PWW2gYoRm3rRt9EtX3gFEXjiuB14MPonxsy9IWJFHQcXxqUMDDglhs3/6NQm/MbtSXZgO64+JhdXJbN/rMs2xREM99FRNwsTpQdE3GzOGG2IeJmcbJs5l2jKHjIKpNqq1vP0Sj1lSufrFF60R3acRb3DM3lUcMRcmSUCjP7KVl4zi1T4U2Y1CeNxwdtMVGE5DVcBYC2AxK36yDSJnyioU7LhaQeErziv65jbx/w5a5xvwBb9sLCDuGZk1ORAZNyTp8+2PU6fMxU7vggNGIEPnb41DH9zOAn8fGhv5FF26SFobpYXQceihaObvVn50jXYy9WX564LhmLDgvMq/9b83b4mDat8u8dX96Jj4umjzz2XfOp+Pi3/lbGe6Uva2SAL9FfIJvCZEePoVwl8hLNWxuii7+xIaC3oFAZENyQCJeG3Mvwejh+vluuKquOqu4yxGUxmSMq3dyxpBtVcojS3BZOk3qAll1u77P/h0BafBEgPfO/gDQGnCi9NgCKoiwYH9cCKm/xJAmvkPWee3j4yME5E9nInIEFOWMLWeHA0f0HjRo3Ep5yCkaIx9EFo4YMz88xUvkDB+WMyIGnESP6j84p6D9u5PBCNiFn+NBhhWxUQeGwUf2H8UTOxIGDCtmQ/IHw0fCJOfljqfiIEWqzoW3g79VqzsTROYMKcwaro0eNHV44fHyOOnLciAdyCsaygYXqiFFjC9Vmg9URA6ErwwfmX/ylOmqIetnlHdSC4SOHjmUjR6kjckaMKnhQHTKqQB2oDs4ZO3zoyJwCLNXsIfWBBwtzLiwkhhdXBt4+WDBwxPDB6vCxagGMe3AbdcJwGNu4QkgWDiwcPmqkCl/nDi+EjrCxhTmjmfGe4RhZzuChOfg7mP7JGV04rD/0ZcRATMZ6UDhKHTK8EDqRl1MwMic/PmdEzsCx4wpyYrmFw3LM3g4blT94rArl83Gu1eEj1YEjH1QHDRs4EkuOGDUY/h0MM8SGjhs+OKd/HpswfHDhsDYqXxuYQ1iCwZYluAxbhJnNGThoGGs7fOQQ1mwsLBKOf+SoQnOFGO8KfVswcPDwcWP5gv5bOQQlahCgi35FL7E58dmQ4QBEcR+NGjJkbE4hVN6v2eD7sFizodeoAHUwNe3UEeMADB7IUdu1UQfm5xtf81nGobMhA+Gfgpwh+TC4gSMH5TBoisMgLSO2DJ0Zq44dNmqC+sDAkYPHXq0OG5g/RIVdMCp/HC5jG7MQrDPNPIcIxoctOg8jHzHiGtGDNtA1mMXLcjpBv0ZC/shBBbCGAJoAVvC6bScVYDgfXhWaEx83Udga1Ivf4g+sPSzw6IHDC64R8zFWbTuRsvm/OWPGDcxX+d4bG6vS3MVU60CA1MGDxdaKFaLlvRoHgAs/NJYxtrAAIIYGN/gaGBEMHyAyJ1aAVy3yzQEh7Fy0hAlZF3ZPlIDutVGv4MXaYHs33d7/9ttv79+12823d4t9J+Bt9EQDHAY+MGo8BwKBGWDmY8V7DBw3duxwGH08yF2tGvuQ8NAEsR+gOlogvn40u8ZiWsZlqWWwUYMFzP5jNbf1H4zYpgBg78LtgFXUAqcr2sW+HVhQOHxs4cUGhDjc6BN/MyT2gjItY6UCYy82g+0hYcwKdJJ3gVYFt5qlJ81oEHGYvQ2g1PH9B+cMLcjJGUuDtx4IBNAAxLCP8WTIf1AdNZLgbGROzmDrToCtONbYfW048BXCcGkXjh0GW7ugxVjVCuTGEWXBKLjNh9f6BArm54yPQzyWYqOHDyoEdMvL1UJfZku1vhOwXWsTX1A6fgsOKRg1wvxSIMeL9IfXObYFlhoEmC+noN9l98EJO3zo8JH4JN61M9/h0zjaVDf3vfFGNmo0orGxZlrUZ6b5tLTtLPBaLKNZ7W9w8c2jNP5zMzl+YP64HDMVO3gLzBMrrqSB1emNFWhiR4mYikyAzss6tmvJRg4cyRgeTOxmG2PXwN8cO1BIks3lC9RteKl+z9gnDaqJXZlNP8V3ZMvsv/1R2P+VP3s1flPU59oV9Oc78XtCu3j5Ss32H9vBfJv464C/036PsK43j2R/tUxj++5swb668ix74MsKlrX0CaaXXMcG3fo3W//1y2ztwG3s6pFN2f6burBejkrmPn4Ja7BwHzvR8G/W8o0G7GjnF9nZq6ayrusvYc8cm87WNB/N9Mn92acLOrHbp3Viz5zpxOb0n84yf9/AzjW+hn1d8xRLXGJnSZdWMc89c9iIxiPYR5PbM/euFqx777XsuSEaa3u8P3uvxTj2w4n32bUP/8x+6+RkC2+bzf7MO84av9Gfue6bx9opd7CH/+rOql/OY2r5R6z9mWXsu5casvsHLmCujB/Zo0tzWDi1P5uXPYwVH6xhLcbexByOy9jOO9LYByvHsocPD2B5cytYva092IdDtzD30UPs7mmt2JzxW9kLDZ5kXV//itW7cx97vrOd2Z017IrJGtt8+VG2pPfXbP0jl7Pm125hjfKq2PJz97OrGl/Nik7vZD8/1pBNKgmy3KaT2Ccj/2Dt2k5gaddcx95O3c621HuWvbp1M2tzk8587D4245Hu7LsxbdnT25exKx5gbM3+SWzNi0+xDn0/YZ91/pWVBdLZTeP/YoOfbcVGf/YyGzTpHHto9Z2sbtoRVtHrDnbNp5+zF6d3ZE2b7GKfzp7A7unThLHG77KfPRms3p5v2PLLatiQRrls6Z0D2St/9mCTiw6yUM5advnRWezH6ABWtfVDlt/eze7TDrA6X3/G7rrma/b10wvZ/lAmy5xxlB2+6ya2feflzPVdHVb5yC5Wt+IW9kvDF1l6ZT92ScqVbFryA2xaT4mdfbwfe3V1EWt07DTref11LDD0Y7bqq4Pstf5dWO7APcyTuYJ9vHQNc7xwmt07oYiVbZ7GBmbNZLPHTmSvz72HjfpsA2v7wiB2JrqLzZtSxZpvGsr67uzGdn7enmWu3M82D5zHkj+YwGzNU1ly96fZ1ru3sh3burKb3lzAWN1f2IHrXmUte/3Azn8SYGzjX6zR4t1s9J5TLKXzWXby52L21pEt7P1zmWyRfTHbNKYzu8T9FvN2+4XNTH6Gvaw+zC55eznrsXAze/jyS5mv7whW8GIJyzvSmF2260n2YJ3rmf7gYXbmm1ns6OKn2OEfp7Ollz3FZv6Ux/r3b8/Wn09gPZetYUNX5LMxBV3YvPsuZ8vT1rHyH9xs3mXN2G+FnVg7ewPm90nsBtcw1ubUXazHqhJWeERmGz5tyn575AU2smcBW16nij2++AW2ZsGvbN/tt7KPPKeZuuQKdvaGyexNIJu/6tyfZd+nsEdnFbG+t7VkHQZXsBEHA+zynpezfjeOYzePOcC69RnJvO5NrNXZ4Sx1yCeshfNZdp/tFrbmmi/Z8fHb2GO/12W98h5hDVu8x54c3pJt3/0KezW1Dys5nMtmfj6LtSm4hdlWbGQTnIvZL+1GM/ZXC3Z8zEo2ZHMvNrjyWvbUV9NYmfYUu27xeeafMZddpn/NFnZ6ln01ei6ru/YIc31zDUvr0JrdWxxm9xQvYoGkhSzx6EGWX/w6+7LmBtaxJJHdnT6ePfB8Ghu4az17f9a7LJC9ge0/bWO9xrVgJ975lX0ZWs88qavYrOaXssHTxjP3NVewhMX12a1Xr2INyzaz1396jd3bPJmN2HwTa/vQM6zijqeYok1j7upfWevsuWzEZUtZpzVO5lPT2MEt/djZhVvZ9ldvYDfvfJ692OFD9uNL7dnLCxezr7oMY/UGfc3Gz61iw+bcxv76sgN7rfRl9k3aZQwemO/PL9jgm4awn+xrWcucduzOO6KsR83VLPf3d9m4jb+wzEXfsJeL27Ehc39ltl1p7I+Qg33+fUN27Vsr2J0Z81n7D93s5i7HWMrGFeyKJm+z6lX1We+clWz/pueZV0tk/SZ+yJr8Pp49PMfGZtUtYNtfuJ2NGnmYVZ1g7Onr72Jbv1jLVg15j43/6CO2T27I3vi5LZu7dBPb8uoENqPnF+y3+8Jse/EZ9kr1peyrk8uYdm852/v1CFbyfmPW6st3WFmzqxl7fRl79fZF7J07baxl2zXshuLJ7Avni2z8qgT28N2lrE5yK3ZobVv2xw/n2awv/2azNp5n34/PZ46X/mKdi0ezR0emsfOP1bDMzk42cOgVrFX6DHbThuOwn15n80eMZE8M7cQui/Zj0z/rydp9U4e93/Y61mzgVeyD0XtYu13rWDT/PFvBIsye/z2756swC47qwR5I3s/evXc6Gz2wF8u7o5ItvU1it/TtwBp9spZd8fNWljKyP7uv3ffs0UteYg3f3MJKL2/PXGtXsONvAI76LcjmD/+etaiZwHxKMeD1tqz3h2GmPr+UvRX5mF16n4et+b0LS/piF3tk41729Jeb2Mt1N7CdkSnMlXsvu6RvXdaC9WVFqdXsW+cMluodzJ7U57HHNn7NvjjfiuU1e4c9POtKZv/lb/Zu9Dk2LLc3u77VStZ76z2s7bly9tk9S9iZ959g/pvmMfXqF9iKO/uzVO0NVtzxCbZbldiYr2awD75+h0UHnGU35SQxyZnH5q5+hb1ZsZfd2rcna/RnAnuiYAsrc1zDKrKvYo5DD7PKbrvZzS3/YJ/u3MGO/qKzSYO/Zk8PPsg+33gZW/HUFjbhrgNs+HfbWPUXKey9q7NY9/TurO+4/mz/hrNs5MLt7JVL7mMJXX9iDTp3YQO3PsZanj/Gjnz6CwtN2slGLbiKuSq3sZrP5rGRuYfZ6vPb2SLXJjbpvkKW9+qb7MORz7LOBQ+z7Um57LePXmItx37D3v7gPbaW3coOv+lnhe81ZT88MoAVHpzN/Glt2JR0H5s8ZDGTWtZhyx8az86f38ju6FbFPoez++TnKWzOe++yrU/9xS5b2YL9PHILW7ytPTu48g62ZuXb7KPdCSx5Vls26s4rWZs7ZrGle75jn6rvsrz7V7HOrZ5hSf13s/Pe69m3Z/5kj18zgh2e0YYdOzCd/bXmJVZ1ah+75KoP2KWdBrKOwa4s4/MdbMpfHvbn9bns0gYH2e1rprObl85lfUK7Wau+h1jF9k+Zt96TrP7odWz4E4NZ83sGMO22U6woKZGdeTuJ/bXrLLuyvC38PcWO3rebfXX/ADb08afZwiuq2Ad117GBdz3Nvr2znN06bTs72DnAvhrTk7Vt8BV7Pb2UBdt0Z3f/8hn7/KEl7Lk+Faz3jD/YHY6/2A8PvsZmhdqzjq+G2NBFh1jfo6vY1OYd2c4jT7Nb/SvY0iveYC99lsCG23uynDerWdHMF9nMG59iv+9rz4IL32IPT72eLfkoyLKXH2KHevRl3xZezYae6ML+fvYbdv+B/uzhoSvYe688xPr+GmGtZzZh+nt92d0jXSzYagbr1GMam/Xdj+yH5w6wXn9ms5o7jrEGiTvZtrtns8V/tGYfb9rGErd9xL685zXWY9sM9uh1D7DgjGtYmwcXs8DAx1irGx9mxW3qs+uiyWxm8xI2MWsWW7n1e/bDlw+zrVdvZs3PHGe/DQUYWBhlOWWt2bWL3mAbJnnZilsPsRZfDWLDv/2KLVtcj61s+QQbtieTuX9aw7ouV9nNS3ay0VMHscmTmrDEdy9nL559nKXecYQFf3axt4GmGTX5JvZ8vVvZ27+/zKZ+8yl78quBrE57GdpczqZFSlnBTyNYp3kPsanrXmJ5l9/LurfoB+T3T2w/m8D+OtOXSXffxCrHFFtJ3Gz02MGHtl0LOyOVvqT7uSxUANy6e+I1mJ6WUd0Jy6nNHuqI6dDU79pj+Ya/DL+K2ykNzTYcQBhDu6nx0auvea582W++DRvOo2T1Gy2rD7eEX9C67kcY06Xu3hVD0cyef7ejC7e3+lFrunVqzYboHu3tM77PXHmvaLtv6b7/5TenadOvvvnpys/61qLnq7WR0Zn1e1/zdNZVV/z50rW/Vmn3HTr4TMqAMeUDiyd0XnaySts35LHAQ/eXlD9aNPJo2ndVWsqvQ6+6bf/crMJH0z5e/XmV9sfjvzcp3jOn/Otfv2qZt7dKG7jjx4E3/zYga8fT49K7vV+lLf34in7fl5VkTftl+87OG6u0EQ9Pu++FZU9lJc76Pf+ut6u0v6rOL6z/9uNZv/UoaL3wFWjvmUtHX7uxc1Zk38eXnyyr0rwjS2ZdqeSWZ3z89+tDnq7SEjZc2uq2O54ov7Vf8l5pUZXW9/jNc6uKbynffVl+xYbZVVqdM5+82+SDBeWVbV96bdnUKu31vvce++7j4qxbH39+x5KHqrSei54/npZRXP7wrY9krSuo0q69/Ou+1Y3nlx+fN7fj77lVWvT2FG3urDlZ43aNOtFvUJXW/ETS+Gc+f7L8wL226ZX9qrQBl17d+beTy7JWvTvsssf6VGnPdpyxa+qR+eUNP/8rdMtNVdq8LS901UfNzvp07gMzr+lepT1i+361/aHirCcPPbKgl1alLV658rvzjz+Z1fGBcSMf6gj5PQtPp9//WJb2wpu991xWpZ0+0nhJ6x7FWV9NOpzTrXWVdr9rjPbwuifLpww6++03Tau0y152j/j2t6lZ337d+OyzjWD+o6PqPx28trzk8y/2FqVXaWs8voKpHeZkeZXvX3g0uUqbv2vPrIWpI7PuuLTzS6/7qrR3Xl5907ibpmWlrb3M87ejSrux8JXDUpcZWZcdvPGv0VKVdv25j+/r9NX8rJo6g990/XVKs/V7/JrishnlPy9f2H/br6e0YbfcsPun6xeW73rp6g4v/nxKe7ztrRnnnEvLhxy0j3jt5Cltf/vFnY/uG1P+2/IfrvzyyCktLWPPW/XqLS3/YWXKlrbfndJG3NjqxZ7LH80KXZl84wtfn9JmD898aEDyovIGxa/Yun1xSus3q27P+S/eVd7qkt+Cnk9PaRnLeg19us2k8qdW3vL52X2ntKRXNg/4adB1WW1nDRzg2nNKqxrsuMY95MmsO1nDn/Sdp7QHldIvvt09Mmtv1qa3I9tPae2SE7XHaxZlff3xZ9WttpzSVr/+0Po9JeOzWrRq/8kX0VPahMo+JzY0XJTl/+r80jfLYTxlY9iVi+eXv9jm2fFvvntK61W26NDurx8r7zLko8gX75zS+ndM3LD964nlU3s/e0frNae0X+99+GT35BnliQvv27niDfj+s/Pp9qsWZX3R4u32PV4/pdmfnn3p2iUPZ51//6kDya+e0tx9Ghz+dlBJVss+Pb9yvnxKO7693i2Pvn9l1trud89u/tIp7aqKwa1/vHxxVs/gq2mjXjylLR+/dOD1388tdx8a/+63z5/SVt5Udc22K+aWP9r36tWTV5zSXjvWetbE26eXq1t2X9m97JR21113TPxqz6LyZqG+UztGTmmD600uXhW4M2vsSzce6Ft6SssM3R+temtR+YfXFA15LnxKm/rulY+9mpxbHv3COy4Z0qdeGrGuauig8kvr52S9ufyUduvMyj7XHioun7741t8fgfRHne+ZPLjxxPLC/iePjoP06kfmVFx/akZ54ZTney6D9Owf+za6vN6M8g+GdrnjBKQ/PuC+f9czJVnafV/3Hg71N3z+pncPXf5w+WPSibGp0J+8iqF9zp9cnHX5pnbST5Dum//py9+eyMl64OaP2v8C/e/y0VuXbiudWZ5cv3OfFjDeKztc8/M7wxeVp+y5ceksmI9GNfWunn5/cfmr7zfpXh/ma+SdBQdvObC4/KeFXZ/+fOUpjc1O6Df01ZKspUNmf/7+qlPamuPVmy5dOy/ry3CrLj+8ckqrObLtmQHv5JTP7fp2ncthvbr2/+Xuab8+nNV+QtrS12A9p13b6MXG7kXl22sWePvBerdslD9n3Uv3lf+w7cPVHdae0u5+t2TS703yyxNv27Gr63untFW/nwldd93C8ltu/nr51A2ntBseH/JZ/s5Hy99z7hz9c8UprcWeBa3/en1MVkl12dQFW09p68d6vr1q/4isJk2+qzdoxyltUOiBkG3bY+U5P9z38JDdp7RPLjv83YwGc7KuaHv9yaf3wn5aX/7xvvULyu9r1vlN5RPYb5edeuay3SVZd73VLuW5z09pb90zduT04dOzoucf7JsH+2vNs48/9eE3U8sf+uXjaB7sv8eu2LVwQv25Wa9+fM/S5UdPaX98vu/6+Q+XlA95Z15L56lT2nuvHbrj8y19y/9M670u8sspLfvXF65NWFFSfvXdP8wr+B3mf9GrHc98Oqy8x/1/nh5fA/A6+668w6cWlF/vKG232l6lffhVf89nNYVZ+zfdUNII8M0rSxb+8eeGBeXuRp/12wz46C3f6+1eGzk265nbHv3q6XqAD88vv/fy7x7PemhvTf+XVSh/t3vf/MrpWTfsu/OSn1tUaUPr39zx9Q8HZb19xLF4xKVV2rB6C/Pb5A3NGl5SdUjtUKXtf3v3tPTZxeV/bLmvrxfw66g/arT7Xp1fPmmW8/q2Paq0Xi+N6/iav6T89Cy/67HeVdqLzmtfeLSsMOuxFX8eSr+rSksMZavPLZhavmTaB3W+GwDtL9z0yS33PJ716OVfKj8Or9JuyJNeufvq6VkD1ki/BMdWaY07r3EGP5la3v/ph694alKV9oG/xzXvtppV3rL0bGr3GVXaxzOvHmB7pzDrV23OkUtKqrQxBc/eenLbtKxpN77/563LqrTqBR/PT/5tfvkXJSsir68A/F/Y5PCS1+aV/zz08bY9X6/SXOoqvXzL41kt7hl4KuO9Ku3yEy9tWdx6etZT7+V1aL2tSjv16L7LXho8Oyu728h+4+G8/em7a75/r8Pj5akbn3n1/JdwHn244KZrZk3IOljy3JRNR6q0WbsH6Jvst2f9PGZ+682/VGmsI6cT2g19f9Gdv1xyrSRMfPu1u5V04yXdTgC98VE0Sfq56VtLP9CW73D8MK7vtqhhCjxB6NB3EV3yUdT31RNLl0K5F7sNJa++dl93LWvaa7OWc22XFTU10ejOT1tlTh9TrtUMW33diaXvRh/d+/pvU6es1T7stm9cym1vR5d/Xbml+srfNFby44NFuz+LNj7WJndiCqSZf/OpUZ9Fw2//4Rpw+leNVd6a8l3KZ9FH5qY0fmEfpCdmduy37tPovjXbvL3ewHRxSd/7Po2+57v0ih4LIM3Sx++VP4026RJKXz4G0iUlM3au/CT6eaPnl/a+DdK3KHdc1/uT6Nam81fdcQWks/O2dPj1QDT10LN5b6Vi/srzLz57IHrjvdtvG/zrWY2tnNVpYbcD0d5tFrw99CCk163udOanj6Nfl/TbVf4epEfP77rnyY+jE+t/fnrgs5AOb6jbKPvj6GN3dE++oxjSxd2rDh/bH/0478iepwZBurJdx4zF+6OLil483KwHpGd+MXdb5/3Rad0cXWpaQbqkRctvj+2LfrPhzS9DiZA+17P1iCf2RT/7+soe8385A+l3lw3V90WzM7/+6LqDkF5StXjvT3ujO8omVnTeAOnAl+nPL9sbnd2scktRBNLrBt32Y4+90SunH2hqnwnp6hndQic+inrb1svYMwLSq+uOu77HR9E+6Z0+/vx2SLcLXNt1xZ7oPdPXdG1xNeYf6+qX90T/PJemv63i9xNaRgZ8GH3jTOcvpjohXfKETarYHZ3/9533zT/1C7Q/646W6u7osRu94c8/wfSUeXWn7Iq23hSoGLAB0ns/3v3B4Z3RdV+Ma930eUiXJF+S3W1nVN67/MPQPEhXNxw2YeUH0QYPTd/Wbxyk2/UcPsL3QfRw+1d77bkP0hXdXlDH7IhmH7hpyYPdMT91zfxP34823VWz595LIT36gax1We9He/lLx01Ih/SADk8vK9seLenUucMOCdLhtX0u826P6ueeWH/zidPwfdPxj4zdFt33Uj3Z8wmmN89/+NDWaKvza1f+vhHSbP+tbbpvjb6c4XuowUuYnlY+e/WWaLu3UwcULMJ0r7ylGVuiZ0vvvPOPRyCdvaKkz2Obo9FrGj791jBIhx889+4vm6Ibzs6f9uztmG7TbMeATdFrXB+sWtsZ0upvdxbtqYi+k/1Sa6kV5v/d61BWRfRyffeTD6ZBuviG8g13RqNP/7W/oSph/dlPujpsjHp73tTrzMmfIf175yV1N0SH58y/7exBSIcP3jz09/XRSZPvTGqyDdIDLlUfPPRe9FjzXYWT3oB0ceaRLRXvRt+p38YnPQfpioK3ur+wLrph9DsPr54NafbKW9K8tdF3yquazZ6A6Y7dfi58J/rFZTdeNW8wfv/YiIT7345+1b9Fybu3Qrqy9Ot7e66J3rj/8hUJGrafe9PnV7wV/eL3QMGcNtj+tnMPqm9GL3v7ZGa7+pBWH1jSPeGN6OtXTv/iTyfWvz83/4/Xo2/l3Zx46mw1jGfC9fO+eDW6Z3mr+xzfQ5o9+v3J8pejwefbDOq6H9IVydmzSl+K1l9yeNKLFZiWr7hr5ovRfe23T7v0dUgXfzr0/jHPRzulhJd8+Symc3rNvrcs+s2R215/eS7Wnzb4u16l0T8zb750+cOYf2JqRcFz0Xrzr5r7di6mb7vt577Lom1+P/n8qbsxPeWjB659MlrSZt+HvXphf1bN/TNzYfSlV6u3b++I6d/Vhy+bG33p8gdTcjIp/76r6k2P9hx7vEXTdEyf3KwkT4w+8Uaqw+bCdNMH3bYB0fp/NP+tcSXgZVYy/ZeqUVrh8YGbG5Ri+tqr9EOPaZcsnbI6AHwIK968tWzPIu3DV09l/doM82elblr+tHYkZYGy4xjQOSxpz8HVpdrLb+yaWPwapCukvf1mP6897Xs2Ur8Q0sUHs6fd+5L29lLPtAVXY/rOqtwWr2p3LBvgrpSw/JIfloxbrS1ZP+EHaedPsD7+787e/qamLJjkPb3wJ1z/OV9dskbbc++fQ165F9IVdz52t+Md7dmv71/VpgXm5141/gvA623yOo88fRLWu8HN1738riY/+GJkxEZM+9e/P3G9NsLVYUTzOZBWj1yect0GzXbXfRsW34X5X4+5zBPV5i5ff8XbzSGdvaB12tAKTTty8tS0sycA/yyc+miPTdqmJ78cd34rpNvt/HBk881a5vUzfI2egPQt2174TNmitelcte1wDqQDV2Rt+WaLNmfmB0N7doB08UN57d/bql3frmHwBjekq/dldlq0TZtcdfrRo18eh3R60w9zt2uRawdc1vB1SJcMOXku+33txbs+1n6civn1z1ak7dDmjHVXZd8J6eJf+7Q8tkNrccPLJa3aQDr7nNx+/QfavtOLUsISpFmbBj/N2allZH3ZdPlnxwDfSffe2m+XVvLG+/Zmr0G6onz30Ja7tUv3PHX6kkchPaDnJ1f9ulsbd8OKU+/di/ndr9yw6UOtY88jz26/EtKVH62T5u7Rfrxt6KW9/ZAuqVvh7vuR9uxnNY/f9uNRwO+Nk/MT9mqT2O7le6KQ3rsoYd2YvVrClo1fVCyF9OgZz+Ud2Kv9WbfJqhaFmH/DFY+136e5lr31CusN6Z5NhvqX7NP6ds452qsVpIt3V9ac26cNkM88ITkgPWzQZ/3v3q+1LKsc1OzwETgPU93t3t2vvfr2oQlvbYT0gOsCBekfa5ubPTV01dOQTj85ovmEj7U7HXVPOx+EdLvX/+z9yceaL+XTL3feAenKS787dfkBLe+d3hIL/Khl9euyIF+enPXEmpsU1u5HTb+P9TwenZc18cBiP7vlR23t85/OeLHo8axXR93sZKN/1G5s1ifv+F8Ds15L/Obvmvk/aucT7r6xxeRJ5eXbBjnZ6h816YtDPYdtml3+66Z7G7G9P2pJi3o920CbltX5V/uJmqoftdvbHq5vK55cXvzUjAQWOKLd9qB7zJCah7OSjw39q+bSI1rTxzY0P8zmZuUmTfmmpvcRbb/088gF8sjykmeGJrLRR7TCZ/p8OOavoeVX7Zj8R838I9o029nnNm2ckvXjZvXvmtePaDmDd7esO3l0OftA+6nmoyNagzkPuwqKi8vH129+rKbqiPba78+OyKyYl3W07BkbCxzVrrjxh1v3F83Kmt9mUV3W7qg25Zd27xz7e3b5M2OvcLBbjmrlV+XkRaOzsrbP6qKy0Ue1cQ8n/ZITnVNue/DsiZr5R7U7d10bGclmlX9jKw+x1Uc1zw2VHb9hj5TPzvD9UPPRUc2+vKb7GDaz/LrHF/xVU3VU6zj6ob0PT5mW9X7/PxqxwDFNWfPN+AWdZ2W9+3D3FNbumDZeXnLDzcVFWaOcp36s6X1Mu+SBms+rJ88v35ec9XXNqGPaex2bP7lq6uhy/+xuZ2rmH9OqVg5ekFH8WHnnS5Z8VfP6Ma3DontmV2Y/Vj7kz14wfoTfpze59mhZtz7zs8qqj2mefjNbrNJmlztWd0tigePaHV/ctbQn8A1//Lreydod19JHtJ798sa5WQ82fCrAbjmutXtw4lc7/56Z1fOSsw3Z6OPaly8fvHa8Pr/8tivubsBKjmvJ4zdPl6OPl9/QuXcrtvq41l+rybKdH16+r9Frn9V8dFxbM7ok+UjnqeUTbbeeqqk6rpV9nVDZ2ZGb1c+f82VN4gntXU/jjjsc92TduXPV3zWXntAaZjUpbCQ9WH7ovSc+r+l9QlveasawQM2D5c/kPNeUjT6hde49Y2+3GqDD6zz2e838E9rvWzY/OeHvSVm9d9n217x+Qtva+vSpFjWDyrvdq++v+eiEFjx+zam1Nfnl37gHnaupOqHd673kKUWfUn77+Le/rUk8qdXLXbt48KY5Wd/d+cfPNZee1H7a3m5e1d+Dy5t+Hz1U0/ukNq7HyfJh2vTy397t81PNqJPaycrbq8smT8/6ZP5SWP+T2s8Lf5/nmDY2a1mwWZCtPqnZEtIHP35+WPkz3Rd/VfPRSa3g+PsNNk5+PGv81vPHa6pOan/PXP5qp42PZ7U+t6wOC/ykjbnn3ZULHhmX1fC3RD9r95P2xfujh5dsmpW1NfHB4zW9f9J8f9+1rUPCXeU/PHboEjb6J61r4qabPi0uKl819VCQlfyk3Xvv+cXzJxWWT5PzDta8/pM2eWBwW8OiuVmdeuS3ZHt/0m5/o+bN56SZWWdLuv5QU/UT8CW3bd/PRmYt/vXlD2sSgY8d3lbNnlZU/tWO276sufSUNtiVsXMTezirqk6X0zW9T2m3vrx49cqagqyk+2cfrRkFfPfGqjfG/npnub/muSRWckqTdnjvn1c8vbxr3ee/qQE+/m31uk8cbGJWaVFyfQZ888J77xhwTr6lfCtw4qz6lJb041X3dc1+tFye99DZmsQqzb6gqtNlf/Yuf3/2D41Yuyqtb9LY069MmZ21+MqpZ2uAb7zu/c8O6NrsrLwbX/qrZlSVNm7ikgZn5AfK9a2/f1szH/jEIxPO7HtkQtbk7yph/au0y8omLasnjSp/7vsJDRjwaW+8sueGU1PGZF22pfK3mqoq7Z7HRksd7CPLRw7IOVOTWK194WnQ69XJs8vvemjGLzWXVmuVb/61ZXjRU+V1/X+dr+ldrfVbvOvKv6NPZU296UOFja7Wdt3xfcU0NjXr6K7TAH/VWv1xHTZ+UzOiPOcLn8RWV2snmv/4WpG2oLzjxysktrda+215zwf/eKQ46/z5L/6oqarWKvI+HW23TSh/8vx7Xhb4WXvAO2L6geLHs+4788MfNZf+rFW1Pz/4j+izWZ8v+wTw78/aa7ckj57AlmUt6xsE/Pezdurr7w7/fn5eVvM+Lf6qmf+zNrbgmkPt2IKsu7OuTWarf9ZmSkrxg0VLs9Y+1/JczUc/a0PnLn/58t9zytmB2Wdqqn7WTvR78dlo0aKsFTPm+FjgtBbqd35BXvHyLOW6RwH/n9auiC4/sblmUdb0X8tranqf1gouuWTyEWl81ufBlmdrRp3WBvqKxq//qygr6+pFqazktNZal7N2ygXlKYP6prLVpzW58ekrphYvLL/mtr9P1Hx0Wjt9qHfHyTUzy598dZ2XVZ/Wtuntbrm15tHy1w8/9GdN4i/as5n3zxzDppQX9X8F9v8vWtratdp9NQvK7xj6go/d8ou2Yeqc0NSiJ7KCv/2ZxEb/ou3+xL/1PVac9e6ld8P8/6Ld+uKbbZ/VFpd32f+Vja3+Rfu24/jReUWPZt35wZtnaz76RbssORq4Wn4oK33Nath/v2irb3tjyIiiJVlnXr88jQXOaE0frde/w7mhWS3n9AD8f0a77tZDBT9K07IGrXniSE3vM9o9s95cN7xmVlblOBvA/xmtz+nNT79R8UT5kU2jqmrmn9EKWl192p39dJbtxY0/1Lx+Ruv2iD+6tmZx+dctAnXZ3jPatbmHxgyuWFp+uHN1Iqs+ozW4/VHvrKKnsvbdcCiZBc5q7VcMGZNjG5D1UAt7HdburOa+vMmePdEny28c/eXJmt5ntc9K7fYCeVb5S336V9WMOqslD/4g4cfo01nJgR/rspKzWknV61O2TZ6ZtbDzBwpbfVar8EU9Ln15eXm9Xg3Z3rNayx7N/mw1ZUn5rIfWHampOqvZhv9UvHby4vLa8ghDzjCA5Aw/RB3C3ujmvncvXbr0mPbQipb0/li3nk/363U6ukVrPqc1q+Z6jfCvMf3GjndPT23zabT4jg6ZTdf8kcXtpyz5rruiG/Z9ElV/qzzoer7BBu6yYcm/q1vdCeM/iY645Z1PVjzQhOdnW/LPtX3s1fqfRD8Zuvq576f/WM7d7iz5Eyc80X/jgWhl55aLhmfY+PfMkj+gweY5Aw9Ed0+/seelB1P4uCvPxvJXzpjRznYgerV36k+/dDnE+19hye85vO+NL3wcHbD41hnb31D592FLfvGSZV/1+Di6sHjbgZvubsbziy356rfvHT66P3qw9dqljR5uzvMHWPJnfp1yz6z9UW31R++k7kz7b/nZlvyJH/2pt9wfHf/F7ZlN76nDx69a8pcM37Rkx76orc+RYeWvNxbzYx3/yy/fO3RftHrl1Cu2N24s5ueMZfyv/T7Hvi865B77+a0rm/PvKyz5JWMPNy3bG01Qzkw+lefj+WFL/t41i5tl740WtT3z3Lr21eX/Kb/Ykp99/4j0dz+KPpa19OVWd/rF/FjyBxza9Wr1nmjT12c8s7Z5azE/lvzqViOdLfZEAzVan96X1hXzY8mv6J0XvPfDaMawnesXvBcU+8KSH172/m/zd0evnL58WO8HW/y3/MpfLPPTtnDG5l3R+WvnXLb65no8v8KSX1F88we/7IwOKflQG3Tzexz+wpb81YcblzfZGT2+qfuhwXObbfhP+cWW/FvOPHPPbR9Evzuwyfb5vlZi/1ny96o54aIdUfcfXxZFNxjzZ8mvDMizXn4/etf1txeUfPkf81Vr/fWOJH66PTrk8Jtlud8HBPxZ5+fF0e1qtkU73RJYft1zjf5bfuVpy/hLv/uh+bbo/H7OkjlfqwI+LfnFu/Jb37Q1mjXxqoGbfHWv/U/5YUt+SSP1rzFbolf3aXHTjIk/C/xmya9ufO62JzZHXVvH1G03r6mYX0v+gEs/abV2U/TJsqT0FcWX/Lf8bGv7eydN/qwieqbf0ZlPDvdc+5/yVUt+5ZeXLTgZjZ6+ouzePuMEfDBLPmsN+2NjNAs2SpsrW137n/Irf7bAb7/5fe4vjzo29r/rTl9DMf+W/Mrrrx6x8L3ojlX9jl7VSeDH/5UftuSHL/u025Z10WF3XHpTy0kp/y2/2JI/4IfZ+6vfiX4x9ooPOjwl8NcAS77q0JwZb0fvvH/7wH6ywH//Kz/b2v+MJz/T34p+k/L77i/ub/Pf8lVLfnHZqfY5b0TdZfPH3z8pVcy/NT+pop3n9eiCx9tPe+7utv8tv7Lakl9vzFddXo7eOPrTHx6a2uC/5VdY8isu//Wuwhejp0pPX9n9rzYb/lN+2Jr/97uPPVcWXfV387Nr5bNZ/ym/2JLPJiY8PXV59Hv35EnNi1tu+E/5A6zj+8SZ8e5T0U4v/LGoz7xMsb+s3/+1emXF/OgzL3z866RG35T/p3zVmh/Ia1VZFP0++wu/drjehv+Uz6q1f7fm/h/5FVWW/Fnj0gLF2tHWzy7Ne1/g12JLfvGiu+5QS7T9vx129Dtk0FfW7z/IbNZriXal757L3wuL84FZ8rOPzLpPD2u3f/bzvRVJkoCPU5bvLznw2pAVWub5DePG1hHrX2zJr1ieumrxSu2R5vfsfeJBMf5sa/5XH47d9YrmzDzY4/Sw+mL+rPmOisuOv6Y9fM0HvTsnJQj8/5Nlf3ffd81Tb2hPP+e/477LjfPRkl+578WzG97SPrv5y+fv3yH23wBLfvipm+459rbWqOF9WY7hov/ZlvyK456P2Vrt8p+efWleo5McPpklP/vu++6/4l3tix4brr43qYmYn5OW/r06b0fueu2HYb+1Li5JEf2z5GeXS3fNLNc+fuWe7fu6G/ShJV/1TOv0/katstuPrw+raCv6d9KK3zstOBrVzntKe396pYHfrfktpj5ed5N22tl2z8QqQd9UWvwNqptMbr1qk3bl0o5dH39RzE/Ykl88wzdw32atdM2UXfnPKgK/WvJL0lb/lbNFm1VwQ5OVl27n85NtyV99xbRrF2zVJr5zvs+D0wR+V635pd//0GKb9v4jw384eoUYf+XxWH5g7sab79yuTbwkq82cjwz6yZI/etyc5Ort2rfBZ36Yl2SsvyX/lq6Pzpv1vma/bsHowBCD/7Dks04nXt+4Q9vX5tiqPtc6xfxa8387dM89H2ijasJ3ZZ52Cvxrya+cnfXTop3a8OAdt1xXIPBL5TEL/dPvzoOX7dJWffvKzfOuEvRxhSW/8pqOj+3dpb2T3OfurTeI9Q1b8gPV2/8ctVvb3/rJbQUnf+b4Z4Alv+TA6mvf+FC7anXab61qxP7Ntn5/pCbh9j1auzP6gBbJm/n6qJZ89tX3r57doyU9vj4nLbiT188s+avfym+w9COt3Te+nSd3ZYj5P2rh324a0HHMXm3BzT/V+fKZcwK/W/IHDBzadute7djxrDpz0gV9XGzJP4rwuU9rUP38oISg2H8DLPnnXtl1b94+bUqd53/7cJlBf1ryh90zaGl0n7Z2Q49bf3rBOF8t+esSRnRL3a8df6/7e18/JuijyiOW+Ts0qXrjfu2M7Zbr/3hG0DcVlvwBH3/7c+rH2rqs4McPHRbrG7bkBzaOH5r3sbZjws+rPxyZJMZnyW93xYTbNn+s3bvB8U6fa9LF/rbkH/2kyZp6B7RnK0tOtv/eJcZnyd8xZvO8MQe0cZ8Ode9pcanAj9b66z5X+cEBbcVBT8YsVdCPzJIf7uh8LfSJdvf7g6eM3ij4/sofLfC54/bfHv5Eq8q+79RPrwr6psKSP+DubzZ88ol2KGeFq5XXs+H/A5okt4/hTgEA';
})();
