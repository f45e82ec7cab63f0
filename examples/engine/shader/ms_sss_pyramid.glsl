// The pyramid of ms_sss.h, for kernels of any radius. This text follows ms_sss.glsl, whose #defines it shares:
//
//     MS_SSS_STEP  4 BASE, 5 SHRINK, 6 GATHER, 7 RESOLVE, for each profile in this order:
//     BASE     level 0 from the engine's textures; writes light[0], surface[0]
//     SHRINK   of levels l = 0 to n - 2 (ms_sss_shader_levels): reads ms_sss_input (4): light[l], ms_sss_surface (8):
//              surface[l]; writes light[l + 1], surface[l + 1]
//     GATHER   of levels n - 2 to 1: reads the same, of level l + 1 ms_sss_coarse (9): light, ms_sss_coarse_surface (10):
//              surface, ms_sss_sum (6): sums, ms_sss_weight (11): weights (l = n - 2: anything); writes sums[l], weights[l]
//     RESOLVE  reads as GATHER of level 0; writes the result. ms_sss_fetch_color reads the light, or what RESOLVE wrote for
//              the profile before
//
// Level l has ceil(width / 2^l) x ceil(height / 2^l) pixels. Its two textures hold the light and d (0: masked), and the
// area of surface relative to a pixel's with the change of d a pixel along x and y. d is linear on planes: -1 / depth in
// perspective, else depth.

#define COARSE_SIDE CONSTANT[3].x // pixels of the picture in one of the coarser level
#define PROFILE CONSTANT[3].y
#define KERNEL_MM CONSTANT[3].z // radius
#define PLANE_REACH CONSTANT[3].w // distance from a tangent plane at which weights reach 0, in radii
#define K_4 CONSTANT[4].rgb // K / 4 of the elevation
#define COARSER CONSTANT[4].w // 0: this is the last level; 1: there is a coarser one; 2: which has sums
#define RAISE_MAX CONSTANT[5].rgb // 1 / reflectance
#define TAP_RADIUS_2 CONSTANT[5].w // square of the radius of a gather in pixels of the coarser level
#define TAP_NORM CONSTANT[6].x // of the gather's taps of weight w at distance r: 1 / sum w
#define TAP_MEAN CONSTANT[6].y // E r / E r^2
#define TAP_SPREAD CONSTANT[6].z // E r^2 / E r^4
#define TAP_ROUNDING CONSTANT[6].w
#define TAP_BEND 0.743933 // E r^2 / 2 E x^2 of the picture's gather, x from pixel to pixel
#define FACET 0.02 // what triangles of a mesh bulge, in pixels

#if !BASE
TEXTURE(ms_sss_surface, fetch_surface, 8, t8)
#endif
#if GATHER || RESOLVE
TEXTURE(ms_sss_coarse, fetch_coarse, 9, t9)
TEXTURE(ms_sss_coarse_surface, fetch_coarse_surface, 10, t10)
TEXTURE(ms_sss_weight, fetch_weight, 11, t11)
#endif

// Pixels of the picture that lie as far apart as a step of d is deep.
float deep_of(float d) { return focal().x / relative(-d); }

// The kernel's radius in pixels of the picture.
float kernel_pixels(float d) {
    return min(PIXELS_PER_MM.x * KERNEL_MM * relative(-d), max(PICTURE_SIZE.x, PICTURE_SIZE.y));
}

float falloff(float x) {
    float f = max(1.0 - x * x, 0.0);
    return f * f * f * f;
}

#if BASE
float4 filter_pixel(int2 p) {
    float4 own = texel(p);
    ms_sss_other = zero4;
    if (!(own.a > 0.0)) { return zero4; }
    float d = pick(own.a, -1.0 / own.a, PERSPECTIVE > 0.5);
    float2 slope = slopes_of(p, own, KERNEL_MM);
    ms_sss_other = float4(min(area_of(slope, ray_of(p)), 10.0), slope / deep_of(d), 0.0);
    return float4(own.rgb, d);
}
#endif

#if MS_SSS_STEP == 5
// 4 x 4 pixels to one of the next level, by weights 1, 3, 3, 1 along each side: the mean of those that lie near the
// tangent plane of one of the middle four, the nearest that has a quarter of the largest area of the four.
float4 filter_pixel(int2 p) {
    float most = 0.0;
    for (int i = 0; i < 4; i++) {
        int2 q = p * 2 + int2(i % 2, i / 2);
        if (inside(q)) { most = max(most, fetch_surface(q).r); }
    }
    ms_sss_other = zero4;
    if (!(most > 0.0)) { return zero4; }
    float nearest = 3e38;
    float2 change = zero2; // of d a pixel
    float middle = 0.0; // d of the plane between the four
    for (int i = 0; i < 4; i++) {
        int2 q = p * 2 + int2(i % 2, i / 2);
        if (!inside(q)) { continue; }
        float4 surface = fetch_surface(q);
        float d = fetch_input(q).a;
        if (surface.r > 0.25 * most && d < nearest) {
            nearest = d;
            change = surface.gb;
            middle = d - dot(float2(q - p * 2) - 0.5, change);
        }
    }
    float scale = deep_of(nearest) / kernel_pixels(nearest);
    float least = nearest;
    float greatest = nearest;
    float4 light = zero4;
    float3 surfaces = zero3; // area, and slopes of what is seen of it
    float seen = 0.0;
    for (int i = 0; i < 16; i++) {
        int2 q = p * 2 + int2(i % 4 - 1, i / 4 - 1);
        if (!inside(q)) { continue; }
        float4 there = fetch_input(q);
        float4 surface = fetch_surface(q);
        float2 away = float2(q - p * 2) - 0.5;
        float rise = dot(away, change);
        float f = falloff((there.a - rise - middle) * scale / PLANE_REACH) * surface.r;
        f = f * pick(0.125, 0.375, abs(away.x) < 1.0) * pick(0.125, 0.375, abs(away.y) < 1.0);
        if (!(f > 0.0 && abs((there.a - nearest) * scale) < 1.0)) { continue; }
        least = min(least, there.a);
        greatest = max(greatest, there.a);
        light = light + f * float4(there.rgb, there.a - rise);
        float part = f / max(surface.r, 1.0);
        surfaces = surfaces + float3(f, part * surface.gb);
        seen = seen + part;
    }
    if (!(surfaces.r > 1e-20)) { return zero4; }
    light = light / surfaces.r;
    ms_sss_other = float4(surfaces.r, 2.0 * surfaces.gb / seen, 0.0);
    return float4(light.rgb, clamp(light.a, least, greatest));
}
#endif

#if GATHER || RESOLVE
// Weights of a kernel of this radius in pixels, of which a table has SIZES, four an octave from 1 on; linear between them.
float3 weight_at(float size, int table) {
    int i = clamp((int(bits_of(size)) - 0x3f800000) >> 21u, 0, SIZES - 2);
    float low = float_of(uint(0x3f800000 + (i << 21u)));
    float high = float_of(uint(0x3f800000 + ((i + 1) << 21u)));
    float t = clamp((size - low) / (high - low), 0.0, 1.0);
    i = i + HEAD + 3 + table * SIZES;
    return CONSTANT[i].rgb + t * (CONSTANT[i + 1].rgb - CONSTANT[i].rgb);
}

// light times the mean of (1 + K / 4 sin theta)^4, of a sine of mean m = moment / light and mean square s:
// u^2 (u^2 + 6 (K / 4)^2 (s - m^2)) with u = 1 + K / 4 m, the terms up to the variance. of m, grain may be rounding.
float3 raise(float3 light, float3 moment, float square, float grain) {
    float3 size = max(abs(light), 1e-30 * one3);
    float3 mean = moment / size * (light / size);
    mean = clamp(mean - clamp(mean, -grain * one3, grain * one3), -one3, one3);
    float3 u = max(1.0 + K_4 * mean, zero3);
    float3 spread = max(square - (grain * grain + mean * mean), zero3);
    return light * min(u * u * (6.0 * spread * K_4 * K_4 + u * u), RAISE_MAX);
}

// What rounding of d may add to a sine of the gather.
float grain_of(float d) { return TAP_ROUNDING * pick(abs(d), 1.0, PERSPECTIVE > 0.5); }

// Distance from the tangent plane that says nothing of the shape next to a pixel: triangles of a mesh, flattened slopes.
float facet_of(float area, float2 slope) {
    return FACET * area + (abs(slope.x) + abs(slope.y)) * (2.0 / max(SLOPE_SCALE, 1e-3) - 2.0);
}

// The light of the next coarser level from up to 6 x 6 of its pixels around, by weights (1 - r^2 / R^2)^2 of the distance
// in space, lifted by its elevation over the tangent plane; and that level's sums. Sums of weights go to ms_sss_other.
// Near a pixel of the picture the depth below its plane shows a mesh's triangles; there it is taken from half the change
// of slope along the way, unless a pixel lies deeper by more than a triangle bulges.
float3 gather(int2 p, float d, float2 change) {
    float deep = deep_of(d) / COARSE_SIDE;
    float radius = kernel_pixels(d);
    float2 slope = change * (2.0 * deep);
    float area = area_of(slope, ray_of(p));
    float cap = min(area, 1.5);
    float limit = radius / COARSE_SIDE;
    float reach = cap * cap * TAP_RADIUS_2;
    float facet = facet_of(area, slope);
    float weight = 0.0;
    float square = 0.0;
    float3 light = zero3;
    float3 moment = zero3;
    float3 sums = zero3;
    float3 weights = zero3;
    for (int i = 0; i < 36; i++) {
        int2 beside = int2(i % 6, i / 6) - 3 + p % 2;
        int2 q = p / 2 + beside;
        float2 away = float2(beside) + 0.25 - 0.5 * float2(p % 2);
        if (dot(away, away) > reach || !inside(q * 2)) { continue; }
        float4 there = fetch_coarse(q);
        float dz = (there.a - d) * deep;
        if (!(abs(there.a) > 0.0 && dz * dz < limit * limit)) { continue; }
        float4 surface = fetch_coarse_surface(q);
        float below = dz - dot(away, slope);
        float t = max(1.0 - (dz * dz + dot(away, away)) / reach, 0.0);
        float w = t * t * surface.r;
        float bend = below;
        if (COARSE_SIDE < 3.0) { bend = max(below - facet, min(TAP_BEND * dot(away, surface.gb * deep - slope), 0.5 * area)); }
        weight = weight + w;
        light = light + w * there.rgb;
        moment = moment + w * bend * there.rgb;
        square = square + w * bend * bend;
        if (abs(away.x) < 1.0 && abs(away.y) < 1.0 && COARSER > 1.5) {
            t = falloff(below / (limit * PLANE_REACH)) * pick(0.25, 0.75, abs(away.x) < 0.5) * pick(0.25, 0.75, abs(away.y) < 0.5);
            sums = sums + t * fetch_sum(q).rgb;
            weights = weights + t * fetch_weight(q).rgb;
        }
    }
    float facing = 1.0 / (cap * area);
    float turn = facing * TAP_MEAN;
    float grain = turn * grain_of(d);
    if (!((abs(slope.x) + abs(slope.y)) * 0.5 * COARSE_SIDE < radius)) { // too steep for a tangent plane on this level
        square = 0.0;
        moment = zero3;
    }
    square = square * facing * facing * TAP_SPREAD / max(weight, 1e-30);
    light = raise(light, moment * turn, square, grain);
    float3 share = weight_at(radius / cap, 0) * (TAP_NORM / (cap * cap));
    ms_sss_other = float4(weights + share * weight, 0.0);
    return sums + share * light;
}
#endif

#if GATHER
float4 filter_pixel(int2 p) {
    float d = fetch_input(p).a;
    ms_sss_other = zero4;
    if (!(abs(d) > 0.0)) { return zero4; }
    return float4(gather(p, d, fetch_surface(p).gb), 0.0);
}
#endif

#if RESOLVE
// The pixel's own light, that of its neighbors as far as they lie near its tangent plane, and the sums.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = fetch_input(p);
    if (!(abs(own.a) > 0.0)) { return float4(ms_sss_fetch_color(pixel), 1.0); }
    float4 surface = fetch_surface(p);
    float deep = deep_of(own.a);
    float radius = kernel_pixels(own.a);
    float size = radius / clamp(surface.r, 1.0, 1.5);
    float3 weight = weight_at(size, 1);
    float3 blurred = weight_at(size, 2);
    float area = max(surface.r, 1.0);
    float facet = facet_of(area, surface.gb * deep) + 2.0 * grain_of(own.a);
    float3 near_light = zero3;
    float3 near_factor = zero3; // sum of the weights times elevation
    float near_weight = 0.0;
    for (int i = 0; i < 9; i++) {
        int2 beside = int2(i % 3 - 1, i / 3 - 1);
        if (!inside(p + beside)) { continue; }
        float4 there = fetch_input(p + beside);
        float away = (there.a - own.a - dot(float2(beside), surface.gb)) * deep;
        float f = max(1.0 - 0.25 * away * away, 0.0);
        f = f * f * pick(0.25, 0.5, beside.x == 0) * pick(0.25, 0.5, beside.y == 0);
        if (!(abs(there.a) > 0.0)) { continue; }
        // Elevation: sin(theta) over the distance of 1 or sqrt(2) pixels; none from a radius of 20 on.
        float sine = max(away - facet, 0.0) / area * clamp(2.0 - 0.1 * radius, 0.0, 1.0);
        float3 lift = 1.0 + K_4 * min(sine * pick(0.70710678, 1.0, beside.x == 0 || beside.y == 0), 1.0);
        lift = lift * lift * lift * lift;
        near_light = near_light + f * lift * there.rgb;
        near_factor = near_factor + f * lift;
        near_weight = near_weight + f;
    }
    // Constant light is not amplified above 1 / reflectance.
    near_light = near_light * min(near_weight * RAISE_MAX / max(near_factor, 1e-30 * one3), one3);
    float3 sum = weight * own.rgb + blurred * near_light;
    weight = weight + blurred * near_weight;
    if (COARSER > 0.5) {
        sum = sum + gather(p, own.a, surface.gb);
        weight = weight + ms_sss_other.rgb;
    }
    float strength = GAIN * strength_of(pixel) * clamp(2.0 * radius - 1.0, 0.0, 1.0);
    return float4(own.rgb + strength * (mean_of(sum, weight, own.rgb) - own.rgb), 1.0);
}
#endif
