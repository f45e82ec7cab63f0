// One pass in place of X and Y, for engines that sample a disc: MS_SSS_STEP 9; this text follows ms_sss.glsl. It reads the
// engine's textures and writes the result. MS_SSS_TAPS is 1 more than the samples, which lie in pairs on both sides of
// the pixel, at angles that differ by the golden ratio from ring to ring; with MS_SSS_ROTATED each pixel has rings turned by
// its own angle, which a rotation by frame and the engine's temporal filter average. The kernel is that of disc_kernel in
// examples/engine/disc.h, the constants are those of X.

float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    if (!(own.a > 0.0)) { return float4(ms_sss_fetch_color(pixel), 1.0); }
    int at = kernel_of(own);
    float2 pixels = pixels_at(own.a, at);
    bool wide = radius_of(pixels, at) > 0.5;
    float turn = pick(0.0, angle_of(p, 3.14159265359), MS_SSS_ROTATED > 0);

    // The plane's depth a column and a row, and its tangents over a pixel along x and y, at depth 1.
    float2 slopes = slopes_of(p, own, RADIUS_MM(at));
    float2 ray = ray_of(p);
    float2 plane = slopes / focal();
    float3 across = float3(1.0 + slopes.x * ray.x, slopes.x * ray.y, slopes.x);
    float3 down = float3(slopes.y * ray.x, 1.0 + slopes.y * ray.y, slopes.y);
    // A point (a, b) mm away, by an orthonormal base of the plane, is a (1 / |across|, 0) + b (-shear, 1) / |rest| pixels.
    float shear = dot(across, down) / dot(across, across);
    float3 rest = down - shear * across;
    float2 lengths = float2(1.0 / sqrt(dot(across, across)), 1.0 / sqrt(dot(rest, rest)));
    float mm = MM_PER_UNIT / DEPTH_SCALE(at); // of a unit of dz
    float facing = mm / area_of(slopes, ray);

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight;
    for (int k = 1; k < pick(1, MS_SSS_TAPS, wide); k++) {
        float4 tap = TAP(at, (k + 1) / 2);
        float r = pick(tap.w, -tap.w, k % 2 == 0);
        float angle = 2.39996323 * float((k + 1) / 2) + turn;
        float b = r * sin(angle) * lengths.y;
        float2 away = float2(r * cos(angle) * lengths.x - shear * b, b) * pixels;
        int2 beside = int2(floor(away + float2(0.5, 0.5)));
        float4 there = texel(p + beside);
        // As in X and Y: the height over the plane, the weight by it, and the factor of the elevation, but by each
        // sample's own height: none lies further out on its line, and turned rings average what a mesh adds.
        float dz = there.a - own.a - dot(plane, float2(beside)) * relative(there.a);
        dz = dz * DEPTH_SCALE(at);
        if (!(same(there, own) && dz * dz < 1.0)) { continue; }
        float f = (1.0 - dz * dz) / (min(SLOPE_SCALE * mm * mm / max(r * r, 1e-30), 1e6) * dz * dz + 1.0);
        float rounding = rounding_of(own.a, away) * DEPTH_SCALE(at);
        float below = facing * (dz - clamp(dz, -rounding, rounding));
        float3 lift = lift_of(below / max(abs(r), 1e-20), LEAST_SINE(at), ELEVATION(at)) * tap.rgb * f;
        weight = weight + tap.rgb * f;
        lifted = lifted + lift;
        result = result + lift * there.rgb;
    }
    lifted = max(weight, lifted * ROOT(at) * ROOT(at));
    float strength = pick(0.0, GAIN * strength_of(pixel), wide);
    return float4(own.rgb + strength * (mean_of(result, lifted, own.rgb) - own.rgb), 1.0);
}
