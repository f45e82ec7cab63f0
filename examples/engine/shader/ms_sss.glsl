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
//     MS_SSS_SLOPES       1        from depth; 2: from normals; 0: no slopes and elevation, where options.flat is 1
//     MS_SSS_STRENGTH     0        1: with strength
//     MS_SSS_ROTATED      0        1: rotation or jitter of ms_sss_shader
//     MS_SSS_HALF         0        1: X and Y lie between DOWN and UP; for kernels from a radius of 16 pixels on
//     MS_SSS_HLSL, MS_SSS_VULKAN   defined: the language, where it is not the GLSL of OpenGL (MS_SSS_WGSL: by sss_wgsl.c)
//
// The engine defines those of these functions that a step reads; p is the pixel plus the viewport's corner:
//
//     float3 ms_sss_fetch_color(int2 p)     light before the albedo; not below 1e30: masked     X, Y, DOWN, UP
//     float ms_sss_fetch_depth(int2 p)      along the view axis; not > 0: masked                X, DOWN, UP
//     int ms_sss_fetch_profile(int2 p)      index of the kernel; without one: masked            X, DOWN, UP
//     float ms_sss_fetch_strength(int2 p)   0 to 1; 0: masked                                   X, Y, DOWN, UP
//     float3 ms_sss_fetch_normal(int2 p)    in view space: x right, y down, z to the camera     X, Y, UP
//
// BASE and the disc read what X reads, RESOLVE color and strength. At half resolution X and Y read DOWN's target in their
// place. Without depth the second returns 1.0, with MS_SSS_SLOPES 0. Depth of 16-bit floats also wants MS_SSS_SLOPES 0:
// its steps are seen as elevation, even where slopes are from normals.
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
#ifndef MS_SSS_SLOPES
#define MS_SSS_SLOPES 1
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
#define SLOPES (MS_SSS_SLOPES > 0 && (PASS || UP || BASE || DISC))
#define NORMALS (MS_SSS_SLOPES == 2 && SLOPES && !HALVED)
#define PACKED (MS_SSS_PROFILES > 0 && !PYRAMID)

#if MS_SSS_PROFILES > 0
#define KERNELS MS_SSS_PROFILES
#define fetch_profile ms_sss_fetch_profile
#else
#define KERNELS 1
#define fetch_profile(p) 0
#endif

// Float4 of the constants: before the profiles (HEAD), of a profile (STRIDE), of a pyramid's three tables (SIZES), in all.
#define HEAD 4
#define STRIDE (6 + MS_SSS_TAPS / 2)
#define SIZES 49
#if PYRAMID
#define COUNT (HEAD + 3 + 3 * SIZES)
#elif UP
#define COUNT (HEAD + MS_SSS_TERMS * KERNELS * STRIDE)
#else
#define COUNT (HEAD + KERNELS * STRIDE)
#endif

// ---- constants and textures ------------------------------------------------------------------------------------------

#define PICTURE_SIZE CONSTANT[0].xy // in pixels, of the picture at full resolution
#define CENTER CONSTANT[0].zw // of the projection, in pixels
#define ORIGIN CONSTANT[1].xy // the viewport's corner
#define PIXELS_PER_MM CONSTANT[1].zw // along x and y; perspective: at depth 1
#define MM_PER_UNIT CONSTANT[2].x // of depth
#define PERSPECTIVE CONSTANT[2].y // 1; 0: orthographic, or a light map
#define SLOPE_SCALE CONSTANT[2].z // 1 - flat
#define GAIN CONSTANT[2].w // 1 - fade
// of X and Y; those of the pyramid stand in its file
#define ROTATION CONSTANT[3].x // radians
#define JITTER CONSTANT[3].y
#define FIRST_TERM CONSTANT[3].z // 1: the term that adds the light itself
// of a profile's kernel, which begins at HEAD + STRIDE * profile
#define TOTAL(at) CONSTANT[at].rgb // sums of the weights
#define RADIUS_MM(at) CONSTANT[at].w
#define SCALE(at) CONSTANT[at + 1].rgb // of the term
#define DEPTH_SCALE(at) CONSTANT[at + 1].w // to units of depth in which weights vanish at a difference of 1
#define DELTA(at) CONSTANT[at + 2].rgb // the part of the light that the filter leaves where it is
#define SPLIT(at) CONSTANT[at + 2].w // square of the difference of depth that DOWN and UP do not cross
#define ELEVATION(at) CONSTANT[at + 3].rgb // K / 4
#define MIXED(at) CONSTANT[at + 3].w // bits: channels with weights of both signs
#define ROOT(at) CONSTANT[at + 4].rgb // of the reflectance
#define LEAST_SINE(at) CONSTANT[at + 4].w // where 1 + K / 4 sin(theta) is 0, or -1
#define TAP(at, i) CONSTANT[at + 5 + i] // weight; offset in mm. 0: the center; then one of each pair

#if defined(MS_SSS_HLSL)
cbuffer ms_sss_block : register(b0) { float4 ms_sss[COUNT]; };
#elif defined(MS_SSS_VULKAN)
layout(set = 0, binding = 0) uniform ms_sss_block { vec4 ms_sss[COUNT]; };
#elif !defined(MS_SSS_WGSL)
precision highp float; // for GLSL ES
precision highp int;
precision highp sampler2D;
uniform vec4 ms_sss[COUNT];
#endif

#if !RAW
TEXTURE(ms_sss_input, fetch_input, 4, t4)
#endif
#if UP || GATHER || RESOLVE
TEXTURE(ms_sss_sum, fetch_sum, 6, t6)
#endif
#if UP || (SECOND && HALVED)
TEXTURE(ms_sss_half, fetch_half, 12, t12)
#endif

// Each step is a function filter_pixel. Those of a pyramid write a second target, ms_sss_other.
#if defined(MS_SSS_HLSL)
float4 filter_pixel(int2 pixel);
#if PYRAMID
static float4 ms_sss_other;
void main(float4 position : SV_Position, out float4 first : SV_Target0, out float4 other : SV_Target1) {
    first = filter_pixel(int2(position.xy));
    other = ms_sss_other;
}
#else
float4 main(float4 position : SV_Position) : SV_Target0 { return filter_pixel(int2(position.xy)); }
#endif
#elif !defined(MS_SSS_WGSL)
float4 filter_pixel(int2 pixel);
layout(location = 0) out vec4 ms_sss_out;
#if PYRAMID
layout(location = 1) out vec4 ms_sss_other;
#endif
void main() { ms_sss_out = filter_pixel(ivec2(gl_FragCoord.xy)); }
#endif

// ---- a pixel: its light, depth, profile, and the slopes of its surface ------------------------------------------------

// Pixels of the picture along the side of one of this step's.
float side() { return pick(pick(1.0, 2.0, HALVED), 0.5 * CONSTANT[3].x, PYRAMID); }

// The corner of the viewport; targets of half the size have none.
int2 origin() { return int2(ORIGIN) * pick(1, 0, HALVED); }

bool inside(int2 p) {
    float2 at = float2(p) * side();
    return p.x >= 0 && p.y >= 0 && at.x < PICTURE_SIZE.x && at.y < PICTURE_SIZE.y;
}

// In perspective a pixel shows a width in proportion to its depth.
float relative(float depth) { return pick(1.0, depth, PERSPECTIVE > 0.5); }

// Pixels a unit of depth along x and y; perspective: at depth 1. A slope is this times the change of depth a pixel.
float2 focal() { return PIXELS_PER_MM * MM_PER_UNIT; }

// (x, y) / z of a pixel's ray.
float2 ray_of(int2 p) {
    float2 middle = (float2(p) + 0.5) * side();
    return (middle - CENTER) * PERSPECTIVE / focal().x;
}

// The area of a surface over that of a surface that faces the ray, at the same depth: |(slope, 1 + slope . ray)|.
float area_of(float2 slope, float2 ray) {
    float towards = dot(slope, ray) + 1.0;
    return sqrt(dot(slope, slope) + towards * towards);
}

// Below 1e30, by its bits: compilers may assume that no number is NaN.
bool finite(float x) { return (bits_of(x) & 0x7fffffffu) < 0x7149f2cau; }

// 0 to 1; NaN as 0. At half resolution UP is where it counts.
float strength_of(int2 p) {
#if MS_SSS_STRENGTH && !HALVED
    float strength = ms_sss_fetch_strength(p);
    bool number = (bits_of(strength) & 0x7fffffffu) <= 0x7f800000u;
    return pick(0.0, min(strength, 1.0), number);
#else
    return 1.0;
#endif
}

// Where kernels differ the last 4 bits of blue hold the profile. Those of 0 would be flushed, so 0 becomes 1e-30.
float pack(float blue, int profile) {
    uint bits = bits_of(pick(blue, 1e-30, abs(blue) < 1e-30)) + 8u;
    return pick(blue, float_of((bits & 0xfffffff0u) | uint(profile)), PACKED);
}
int profile_of(float4 c) { return pick(0, int(bits_of(c.b) & 15u), PACKED); }

// Light and depth of a pixel; alpha 0: masked.
float4 texel(int2 p) {
    if (!inside(p)) { return zero4; }
    int2 at = p + origin();
#if RAW
    float3 c = ms_sss_fetch_color(at);
    float depth = ms_sss_fetch_depth(at);
    int profile = fetch_profile(at);
    bool known = pick(profile >= 0 && profile < KERNELS, profile == int(CONSTANT[3].y), PYRAMID);
    bool lit = finite(c.r) && finite(c.g) && finite(c.b) && strength_of(at) > 0.0;
    if (!(known && lit && depth > 0.0 && finite(depth))) { return zero4; }
    return float4(c.rg, pack(c.b, profile), depth);
#else
    float4 c = fetch_input(at);
    return pick(zero4, c, c.a > 0.0);
#endif
}

// Neither is masked, and both have one profile.
bool same(float4 a, float4 b) { return a.a > 0.0 && profile_of(a) == profile_of(b); }

#if SLOPES && !NORMALS
// The slope along a step of one pixel, from differences of depth to the pixels before and after. A difference above
// most is an edge. Where the slopes on both sides agree, their mean. Else the smaller one: near a silhouette depth
// falls as the root of the distance to it, a difference of one pixel underestimates the slope, and the ratio of the last
// two differences tells by how much, if it is more than rounding.
float slope_along(int2 p, int2 step, float4 own, float scale, float most) {
    float4 before = texel(p - step);
    float4 after = texel(p + step);
    float a = own.a - before.a;
    float b = after.a - own.a;
    float2 width = float2(relative(before.a), relative(after.a));
    float2 edge = most * pick(float2(1.0, 1.0), width / relative(own.a), PYRAMID); // a pyramid's is one of slopes
    bool on_a = same(before, own) && abs(a) < edge.x;
    bool on_b = same(after, own) && abs(b) < edge.y;
    a = scale * a / width.x;
    b = scale * b / width.y;
    a = pick(pick(0.0, b, on_b), a, on_a);
    b = pick(a, b, on_b);
    float slope = 0.5 * (a + b);
    if ((on_a || on_b) && !(on_a && on_b && abs(a - b) < 0.5 * (a * b + 1.0))) {
        bool back = on_a && (!on_b || abs(a) < abs(b));
        slope = pick(pick(slope, b, abs(b) < abs(a)), a, abs(a) < abs(b));
        float next = pick(after.a, before.a, back);
        float4 beyond = texel(p + step * pick(2, -2, back));
        float outer_step = (own.a - next) * relative(beyond.a);
        float inner_step = (next - beyond.a) * relative(own.a);
        float rounding = 4.7683716e-7 * own.a * relative(own.a);
        float more = min(abs(outer_step) - abs(inner_step), abs(inner_step)) - rounding;
        if (same(beyond, own) && outer_step * inner_step > 0.0 && more > 0.0) {
            more = min(more / abs(inner_step), 0.85);
            slope = slope + slope * more * (0.5 + more * (0.5 + 0.7 * more * more));
        }
    }
    return clamp(slope, -8.0, 8.0);
}
#endif

// Change of depth along x and y over the width of surface that a pixel shows. A step of depth of radius_mm is an edge.
float2 slopes_of(int2 p, float4 own, float radius_mm) {
#if NORMALS
    float3 normal = ms_sss_fetch_normal(p + origin());
    float least = max(abs(normal.x), abs(normal.y)) * 0.125;
    float facing = max(normal.z - dot(ray_of(p), normal.xy), least);
    bool valid = finite(normal.x) && finite(normal.y) && finite(normal.z);
    return SLOPE_SCALE * pick(zero2, normal.xy / facing, facing > 0.0 && valid);
#elif SLOPES
    float most = radius_mm / MM_PER_UNIT;
    float2 scale = focal() / side();
    float along_x = slope_along(p, int2(1, 0), own, scale.x, most);
    float along_y = slope_along(p, int2(0, 1), own, scale.y, most);
    return SLOPE_SCALE * float2(along_x, along_y);
#else
    return zero2;
#endif
}

// How much shorter than a mm that faces the camera a mm along an axis of the tangent plane is in the picture.
float shortened(float2 axis, float slope, float2 ray) {
    float2 across = axis + slope * ray;
    return 1.0 / sqrt(dot(across, across) + slope * slope);
}

// ---- kernels ---------------------------------------------------------------------------------------------------------

int kernel_of(float4 own) { return HEAD + STRIDE * profile_of(own); }

// Pixels a mm along x and y; a kernel wider than the picture is reduced to it.
float2 pixels_at(float depth, int at) {
    float2 pixels = PIXELS_PER_MM / relative(depth);
    float widest = max(PICTURE_SIZE.x, PICTURE_SIZE.y);
    return pixels * min(widest / (RADIUS_MM(at) * pixels.x), 1.0);
}

float radius_of(float2 pixels, int at) { return RADIUS_MM(at) * max(pixels.x, pixels.y); }

// How much more light enters below the tangent plane, at this sine of the elevation; not below 0.
float3 lift_of(float sine, float least, float3 elevation) {
    float3 lift = 1.0 + elevation * clamp(sine, least, 1.0);
    return lift * lift * lift * lift;
}

// A mean; where there is no weight, the pixel's own light.
float3 mean_of(float3 sum, float3 weight, float3 own) {
    return (sum + 1e-30 * own) / (weight + 1e-30);
}

// One of 64 angles a pixel, of a linear congruence in which neighbors differ widely; range: of all of them.
float angle_of(int2 p, float range) {
    float turn = float(((uint(p.x) * 49472u + uint(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    return ROTATION + JITTER * turn * (range / 64.0);
}

// Rounding of a difference of depths to a tangent plane, so many pixels away.
float rounding_of(float depth, float2 away) { return 2.3841858e-7 * depth * (2.0 + abs(away.x) + abs(away.y)); }

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
    int at = kernel_of(own);
    float4 f = float4(nearness(a, own, at), nearness(b, own, at), nearness(c, own, at), nearness(d, own, at));
    if (!(own.a > 0.0)) { return own; }
    float4 mean = (f.x * a + f.y * b + f.z * c + f.w * d) / (f.x + f.y + f.z + f.w);
    return float4(mean.rg, pack(mean.b, profile_of(own)), mean.a);
}
#endif

#if UP
// The weight of a pixel's own light in its result: DELTA, and of each term the product of what the taps along x and
// along y take from the pixel itself by linear interpolation. pixels: of a mm.
float3 self_weight(float2 pixels, int at) {
    float3 share = DELTA(at);
    for (int t = 0; t < MS_SSS_TERMS; t++) {
        int block = at + t * KERNELS * STRIDE;
        float3 across = zero3;
        float3 down = zero3;
        for (int k = 0; k < MS_SSS_TAPS; k++) {
            float4 tap = TAP(block, (k + 1) / 2);
            float2 left = max(1.0 - pixels * abs(tap.w), zero2);
            across = across + tap.rgb * left.x;
            down = down + tap.rgb * left.y;
        }
        share = share + SCALE(block) * across * down;
    }
    return clamp(share, zero3, 0.999 * one3);
}

// out = s own + (1 - s) rest, s the self weight at full resolution. The rest is that of the four larger pixels around,
// each solved from after = s' before + (1 - s') rest with its own s', interpolated (3/4, 1/4) where depths are near.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    float3 light = ms_sss_fetch_color(pixel);
    if (!(own.a > 0.0)) { return float4(light, 1.0); }
    int at = kernel_of(own);
    float2 ray = ray_of(p);
    float2 slopes = slopes_of(p, own, RADIUS_MM(at));
    float2 tilt = float2(shortened(float2(1.0, 0.0), slopes.x, ray), shortened(float2(0.0, 1.0), slopes.y, ray));
    float3 share = self_weight(tilt * pixels_at(own.a, at), at);
    float3 rest = zero3;
    float weight = 0.0;
    for (int i = 0; i < 4; i++) {
        int2 q = (p + 1) / 2 - 1 + int2(i % 2, i / 2);
        if (!inside(q * 2)) { continue; }
        float4 there = fetch_half(q);
        float f = nearness(there, own, at) * pick(0.25, 0.75, q.x == p.x / 2) * pick(0.25, 0.75, q.y == p.y / 2);
        if (!(f > 0.0)) { continue; }
        float3 after = fetch_sum(q).rgb;
        float3 least = min(min(there.rgb, after), zero3);
        float3 other = 1.0 - self_weight(tilt * pixels_at(there.a, at), at);
        rest = rest + f * max(there.rgb + (after - there.rgb) / other, least);
        weight = weight + f;
    }
    bool wide = radius_of(pixels_at(own.a, at), at) > 0.5;
    if (wide && weight > 1e-6) {
        light = light + GAIN * strength_of(pixel) * (1.0 - share) * (rest / weight - light);
    }
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

// One pass: taps on the tangent plane along one axis of the picture. A tap at the distance s on the surface reads two
// texels, which count
//     f = share of linear interpolation * (1 - dz^2) / (1 + (1 - flat) h^2 / s^2)
// with h the height of the texel over the tangent plane in mm, dz the same in units in which weights vanish at 1. Light
// that enters below the plane, at an elevation theta, reaches the pixel by a factor (1 + K / 4 sin theta)^4; where the
// surface bends away from the plane there is more of it, by a factor 1 + (1 - flat) (dh/ds)^2 / 2. Near taps would see a
// mesh's triangles: they follow the sine of the next ones outwards, in proportion to s. The sum is divided by
// the larger of its weights and its factors' weights times the root of the reflectance: no mean exceeds 1 / reflectance
// after two passes. Where weights have both signs, what is missing is replaced by the pixel's own light instead, for a
// sum of weights near 0 is no divisor.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    if (!(own.a > 0.0)) {
#if SECOND
        return float4(unfiltered(p), 1.0);
#else
        return own;
#endif
    }
    int at = kernel_of(own);

    // The effect fades from kernels of a pixel to those of half a pixel.
    float2 pixels = pixels_at(own.a, at) / side();
    float radius = radius_of(pixels, at);
    bool wide = radius > 0.5;
    float2 axis = pick(float2(1.0, 0.0), float2(0.0, 1.0), SECOND);
#if MS_SSS_ROTATED
    float angle = angle_of(p, 1.57079632679);
    axis = axis.x * float2(cos(angle), sin(angle)) + axis.y * float2(-sin(angle), cos(angle));
#endif
    float2 plane = zero2; // the tangent plane's depth a column and a row; perspective: times that of the texel there
#if SLOPES
    float2 ray = ray_of(p);
    float2 slopes = slopes_of(p, own, RADIUS_MM(at));
    pixels = pixels * shortened(axis, dot(axis, slopes), ray);
    plane = slopes * side() / focal();
    float mm = MM_PER_UNIT / DEPTH_SCALE(at); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = LEAST_SINE(at);
#endif
    float radius_mm = RADIUS_MM(at);
    axis = axis * pixels;

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight; // the weight with the factors of elevation
    for (int way = pick(2, 0, wide); way < 2; way++) {
        // Each tap is added once the next one inwards is known.
        float4 outer = zero4; // its light and weight
        float outer_sine = 0.0; // times the weight
        float outer_lower = 0.0; // mm below the plane
        for (int k = MS_SSS_TAPS / 2; k >= 0; k--) {
            float offset = abs(TAP(at, k).w);
            float2 along = axis * pick(offset, -offset, way == 1);
            float2 whole = floor(along);
            float4 sum = zero4;
            float below = 0.0;
#if SLOPES
            float elongation = min(SLOPE_SCALE * mm * mm / max(offset * offset, 1e-30), 1e6);
#endif
            for (int i = pick(2 + 2 * MS_SSS_ROTATED, 0, k > 0); i < 2 + 2 * MS_SSS_ROTATED; i++) {
                int2 corner = pick(pick(int2(i, 0), int2(0, i), SECOND), int2(i % 2, i / 2), MS_SSS_ROTATED > 0);
                float2 away = abs(1.0 - float2(corner) - (along - whole));
                float share = away.x * away.y;
                if (!(share > 0.0)) { continue; }
                int2 beside = int2(whole) + corner;
                float4 there = texel(p + beside);
                float dz = there.a - own.a - dot(plane, float2(beside)) * relative(there.a);
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
            float3 lift = one3;
#if SLOPES
            // The sine of the elevation, without what may be rounding of depths; near by, within some
            // 0.17 radii, that of the tap before, as far as it was found.
            float rounding = rounding_of(own.a, along) * DEPTH_SCALE(at);
            below = facing * (below - clamp(below, -rounding, rounding));
            float sine = below / max(offset, 1e-20);
            float gap = abs(tap.w) - offset;
            if (gap > 0.0) {
                float s_2 = offset * offset / (0.0289 * radius_mm * radius_mm);
                float follow = outer.a * outer.a * outer.a * outer.a / (1.0 + s_2 * s_2);
                sine = sine + follow * (outer_sine * sum.a * offset / abs(tap.w) - sine);
            }
            // The area of the tap before: by the slope from this one to it.
            float lower = below / (sum.a + 0.001);
            float bend = 0.0;
            if (gap > 1e-20 && MIXED(at) < 0.5) { bend = (outer_lower - lower) / gap; }
            outer = outer * min(0.5 * SLOPE_SCALE * bend * bend + 1.0, 3.0);
            lift = lift_of(outer_sine, least_sine, elevation);
            outer_sine = sine;
            outer_lower = lower;
#endif
            weight = weight + tap.rgb * outer.a;
            lifted = lifted + lift * tap.rgb * outer.a;
            result = result + lift * tap.rgb * outer.rgb;
            outer = sum;
        }
    }

    int mixed = int(MIXED(at));
    float3 mean = TOTAL(at) * mean_of(result, max(weight, lifted * ROOT(at)), own.rgb);
    float3 filled = result + own.rgb * (TOTAL(at) - weight);
    result.r = pick(mean.r, filled.r, (mixed & 1) != 0);
    result.g = pick(mean.g, filled.g, (mixed & 2) != 0);
    result.b = pick(mean.b, filled.b, (mixed & 4) != 0);
#if SECOND
    float full = pick(GAIN * strength_of(pixel) * min(2.0 * radius - 1.0, 1.0), 1.0, HALVED);
    float strength = pick(0.0, full, wide);
    float3 kept = strength * DELTA(at) + (1.0 - strength);
    result = strength * SCALE(at) * result;
    if (dot(abs(kept), one3) > 0.0) { result = result + kept * unfiltered(p); }
    return float4(result, 1.0);
#else
    return float4(result.rg, pack(result.b, profile_of(own)), own.a);
#endif
}
#endif

#else
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
