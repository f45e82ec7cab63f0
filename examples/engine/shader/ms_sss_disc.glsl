// One pass in place of X and Y, for engines that sample a disc: MS_SSS_STEP 9; this text follows ms_sss.glsl. It reads the
// engine's textures and writes the result. MS_SSS_TAPS is 1 more than the samples, which lie in pairs on both sides of
// the pixel, at angles that differ by the golden ratio from ring to ring; with MS_SSS_ROTATED each pixel has rings turned by
// its own angle, which a rotation by frame and the engine's temporal filter average. The kernel is that of disc_kernel in
// examples/engine/disc.h, the constants are those of X.

float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    if (!(own.a > 0.0)) { return float4(ms_sss_fetch_color(pixel), 1.0); }
    int at = profile_at(own);
    float pixels = pixels_at(own.a);
    bool wide = pixels * RADIUS_MM(at) * max(ASPECT.x, ASPECT.y) > 0.5;
    pixels = min(pixels, max(PICTURE_SIZE.x, PICTURE_SIZE.y) / RADIUS_MM(at));
    float turn = 0.0;
#if MS_SSS_ROTATED
    turn = float(((uint(p.x) * 49472u + uint(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    turn = ROTATION + JITTER * turn * (3.14159265359 / 64.0);
#endif

    // The plane's depth a column and a row, and its tangents over a pixel along x and y, at depth 1.
    float2 slopes = zero2;
#if SLOPES
    slopes = SLOPE_SCALE * slopes_of(p, own, FOCAL, sqrt(REACH(at)) / DEPTH_SCALE(at));
#endif
    float2 ray = ray_of(p);
    float2 plane = slopes / FOCAL;
    float3 across = float3(1.0 + slopes.x * ray.x, slopes.x * ray.y, slopes.x);
    float3 down = float3(slopes.y * ray.x, 1.0 + slopes.y * ray.y, slopes.y);
    // A point (a, b) mm away, by an orthonormal base of the plane, is a (1 / |across|, 0) + b (-shear, 1) / |rest| pixels.
    float shear = dot(across, down) / dot(across, across);
    float3 rest = down - shear * across;
    float2 lengths = float2(1.0 / sqrt(dot(across, across)), 1.0 / sqrt(dot(rest, rest)));
    float mm = FOCAL.x / (PIXELS_PER_MM * DEPTH_SCALE(at)); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = -1.0 / max(1.0, max(elevation.r, max(elevation.g, elevation.b)));

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight;
    for (int k = 1; k < pick(1, MS_SSS_TAPS, wide); k++) {
        float4 tap = TAP(at, (k + 1) / 2);
        float r = pick(tap.w, -tap.w, k % 2 == 0);
        float angle = 2.39996323 * float((k + 1) / 2) + turn;
        float b = r * sin(angle) * lengths.y;
        float2 away = float2(r * cos(angle) * lengths.x - shear * b, b) * pixels * ASPECT;
        int2 beside = int2(int(floor(away.x + 0.5)), int(floor(away.y + 0.5)));
        float4 there = texel(p + beside);
        // As in X and Y: the height over the plane, the weight by it, and the factor of the elevation, but by each
        // sample's own height: none lies further out on its line, and turned rings average what a mesh adds.
        float dz = there.a - own.a - dot(plane, float2(float(beside.x), float(beside.y))) * relative(there.a);
        dz = dz * DEPTH_SCALE(at);
        if (!(same(there, own) && dz * dz < 1.0)) { continue; }
        float f = (1.0 - dz * dz) / (min(SLOPE_SCALE * mm * mm / max(r * r, 1e-30), 1e6) * dz * dz + 1.0);
        float rounding = own.a * DEPTH_SCALE(at) * 2.3841858e-7 * (2.0 + abs(away.x) + abs(away.y));
        float below = facing * (dz - clamp(dz, -rounding, rounding));
        float3 lift = one3 + elevation * clamp(below / max(abs(r), 1e-20), least_sine, 1.0);
        lift = lift * lift * lift * lift * tap.rgb * f;
        weight = weight + tap.rgb * f;
        lifted = lifted + lift;
        result = result + lift * there.rgb;
    }
    lifted = max(weight, lifted * ROOT(at) * ROOT(at));
    result = float3(pick(own.r, result.r / lifted.r, lifted.r > 1e-30), pick(own.g, result.g / lifted.g, lifted.g > 1e-30),
        pick(own.b, result.b / lifted.b, lifted.b > 1e-30));
    float strength = pick(0.0, GAIN, wide);
#if MS_SSS_STRENGTH
    strength = strength * min(ms_sss_fetch_strength(pixel), 1.0);
#endif
    return float4(own.rgb + strength * (result - own.rgb), 1.0);
}

MS_SSS_MAIN
