// Of ms_sss.glsl by examples/tools/sss_wgsl.c, with
//     #define MS_SSS_STEP 0
//     #define MS_SSS_PROFILES 16
//     #define MS_SSS_SLOPES 2
//     #define MS_SSS_STRENGTH 1
// and the defaults. The module adds the functions ms_sss_fetch_... that it calls.

// ---- a pixel: its light, depth, profile, and the slopes of its surface ------------------------------------------------

// Pixels of the picture along the side of one of this step's.
fn side() -> f32 { return select(select(1.0, 2.0, false), 0.5 * ms_sss.v[3].x, false); }

// The corner of the viewport; targets of half the size have none.
fn origin() -> vec2<i32> { return vec2<i32>(ms_sss.v[1].xy) * select(1, 0, false); }

fn inside(p: vec2<i32>) -> bool {
    var at: vec2<f32> = vec2<f32>(p) * side();
    return p.x >= 0 && p.y >= 0 && at.x < ms_sss.v[0].xy.x && at.y < ms_sss.v[0].xy.y;
}

// In perspective a pixel shows a width in proportion to its depth.
fn relative(depth: f32) -> f32 { return select(1.0, depth, ms_sss.v[2].y > 0.5); }

// Pixels a unit of depth along x and y; perspective: at depth 1. A slope is this times the change of depth a pixel.
fn focal() -> vec2<f32> { return ms_sss.v[1].zw * ms_sss.v[2].x; }

// (x, y) / z of a pixel's ray.
fn ray_of(p: vec2<i32>) -> vec2<f32> {
    var middle: vec2<f32> = (vec2<f32>(p) + 0.5) * side();
    return (middle - ms_sss.v[0].zw) * ms_sss.v[2].y / focal().x;
}

// The area of a surface over that of a surface that faces the ray, at the same depth: |(slope, 1 + slope . ray)|.
fn area_of(slope: vec2<f32>, ray: vec2<f32>) -> f32 {
    var towards: f32 = dot(slope, ray) + 1.0;
    return sqrt(dot(slope, slope) + towards * towards);
}

// Below 1e30, by its bits: compilers may assume that no number is NaN.
fn finite(x: f32) -> bool { return (bitcast<u32>(x) & 0x7fffffffu) < 0x7149f2cau; }

// 0 to 1; NaN as 0. At half resolution UP is where it counts.
fn strength_of(p: vec2<i32>) -> f32 {
    var strength: f32 = ms_sss_fetch_strength(p);
    var number: bool = (bitcast<u32>(strength) & 0x7fffffffu) <= 0x7f800000u;
    return select(0.0, min(strength, 1.0), number);
}

// Where kernels differ the last 4 bits of blue hold the profile. Those of 0 would be flushed, so 0 becomes 1e-30.
fn pack(blue: f32, profile: i32) -> f32 {
    var bits: u32 = bitcast<u32>(select(blue, 1e-30, abs(blue) < 1e-30)) + 8u;
    return select(blue, bitcast<f32>((bits & 0xfffffff0u) | u32(profile)), true);
}
fn profile_of(c: vec4<f32>) -> i32 { return select(0, i32(bitcast<u32>(c.b) & 15u), true); }

// Light and depth of a pixel; alpha 0: masked.
fn texel(p: vec2<i32>) -> vec4<f32> {
    if (!inside(p)) { return vec4<f32>(0.0, 0.0, 0.0, 0.0); }
    var at: vec2<i32> = p + origin();
    var c: vec3<f32> = ms_sss_fetch_color(at);
    var depth: f32 = ms_sss_fetch_depth(at);
    var profile: i32 = ms_sss_fetch_profile(at);
    var known: bool = select(profile >= 0 && profile < 16, profile == i32(ms_sss.v[3].y), false);
    var lit: bool = finite(c.r) && finite(c.g) && finite(c.b) && strength_of(at) > 0.0;
    if (!(known && lit && depth > 0.0 && finite(depth))) { return vec4<f32>(0.0, 0.0, 0.0, 0.0); }
    return vec4<f32>(c.rg, pack(c.b, profile), depth);
}

// Neither is masked, and both have one profile.
fn same(a: vec4<f32>, b: vec4<f32>) -> bool { return a.a > 0.0 && profile_of(a) == profile_of(b); }

// Change of depth along x and y over the width of surface that a pixel shows. A step of depth of radius_mm is an edge.
fn slopes_of(p: vec2<i32>, own: vec4<f32>, radius_mm: f32) -> vec2<f32> {
    var normal: vec3<f32> = ms_sss_fetch_normal(p + origin());
    var least: f32 = max(abs(normal.x), abs(normal.y)) * 0.125;
    var facing: f32 = max(normal.z - dot(ray_of(p), normal.xy), least);
    var valid: bool = finite(normal.x) && finite(normal.y) && finite(normal.z);
    return ms_sss.v[2].z * select(vec2<f32>(0.0, 0.0), normal.xy / facing, facing > 0.0 && valid);
}

// How much shorter than a mm that faces the camera a mm along an axis of the tangent plane is in the picture.
fn shortened(axis: vec2<f32>, slope: f32, ray: vec2<f32>) -> f32 {
    var across: vec2<f32> = axis + slope * ray;
    return 1.0 / sqrt(dot(across, across) + slope * slope);
}

// ---- kernels ---------------------------------------------------------------------------------------------------------

fn kernel_of(own: vec4<f32>) -> i32 { return 4 + 9 * profile_of(own); }

// Pixels a mm along x and y; a kernel wider than the picture is reduced to it.
fn pixels_at(depth: f32, at: i32) -> vec2<f32> {
    var pixels: vec2<f32> = ms_sss.v[1].zw / relative(depth);
    var widest: f32 = max(ms_sss.v[0].xy.x, ms_sss.v[0].xy.y);
    return pixels * min(widest / (ms_sss.v[at].w * pixels.x), 1.0);
}

fn radius_of(pixels: vec2<f32>, at: i32) -> f32 { return ms_sss.v[at].w * max(pixels.x, pixels.y); }

// How much more light enters below the tangent plane, at this sine of the elevation; not below 0.
fn lift_of(sine: f32, least: f32, elevation: vec3<f32>) -> vec3<f32> {
    var lift: vec3<f32> = 1.0 + elevation * clamp(sine, least, 1.0);
    return lift * lift * lift * lift;
}

// A mean; where there is no weight, the pixel's own light.
fn mean_of(sum: vec3<f32>, weight: vec3<f32>, own: vec3<f32>) -> vec3<f32> {
    return (sum + 1e-30 * own) / (weight + 1e-30);
}

// One of 64 angles a pixel, of a linear congruence in which neighbors differ widely; range: of all of them.
fn angle_of(p: vec2<i32>, range: f32) -> f32 {
    var turn: f32 = f32(((u32(p.x) * 49472u + u32(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    return ms_sss.v[3].x + ms_sss.v[3].y * turn * (range / 64.0);
}

// Rounding of a difference of depths to a tangent plane, so many pixels away.
fn rounding_of(depth: f32, away: vec2<f32>) -> f32 { return 2.3841858e-7 * depth * (2.0 + abs(away.x) + abs(away.y)); }

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
fn filter_pixel(pixel: vec2<i32>) -> vec4<f32> {
    var p: vec2<i32> = pixel - origin();
    var own: vec4<f32> = texel(p);
    if (!(own.a > 0.0)) {
        return own;
    }
    var at: i32 = kernel_of(own);

    // The effect fades from kernels of a pixel to those of half a pixel.
    var pixels: vec2<f32> = pixels_at(own.a, at) / side();
    var radius: f32 = radius_of(pixels, at);
    var wide: bool = radius > 0.5;
    var axis: vec2<f32> = select(vec2<f32>(1.0, 0.0), vec2<f32>(0.0, 1.0), false);
    var plane: vec2<f32> = vec2<f32>(0.0, 0.0); // the tangent plane's depth a column and a row; perspective: times that of the texel there
    var ray: vec2<f32> = ray_of(p);
    var slopes: vec2<f32> = slopes_of(p, own, ms_sss.v[at].w);
    pixels = pixels * shortened(axis, dot(axis, slopes), ray);
    plane = slopes * side() / focal();
    var mm: f32 = ms_sss.v[2].x / ms_sss.v[at + 1].w; // of a unit of dz
    var facing: f32 = mm / area_of(slopes, ray);
    var elevation: vec3<f32> = ms_sss.v[at + 3].rgb;
    var least_sine: f32 = ms_sss.v[at + 4].w;
    var radius_mm: f32 = ms_sss.v[at].w;
    axis = axis * pixels;

    var result: vec3<f32> = own.rgb * ms_sss.v[at + 5 + 0].rgb;
    var weight: vec3<f32> = ms_sss.v[at + 5 + 0].rgb;
    var lifted: vec3<f32> = weight; // the weight with the factors of elevation
    for (var way: i32 = select(2, 0, wide); way < 2; way++) {
        // Each tap is added once the next one inwards is known.
        var outer: vec4<f32> = vec4<f32>(0.0, 0.0, 0.0, 0.0); // its light and weight
        var outer_sine: f32 = 0.0; // times the weight
        var outer_lower: f32 = 0.0; // mm below the plane
        for (var k: i32 = 7 / 2; k >= 0; k--) {
            var offset: f32 = abs(ms_sss.v[at + 5 + k].w);
            var along: vec2<f32> = axis * select(offset, -offset, way == 1);
            var whole: vec2<f32> = floor(along);
            var sum: vec4<f32> = vec4<f32>(0.0, 0.0, 0.0, 0.0);
            var below: f32 = 0.0;
            var elongation: f32 = min(ms_sss.v[2].z * mm * mm / max(offset * offset, 1e-30), 1e6);
            for (var i: i32 = select(2 + 2 * 0, 0, k > 0); i < 2 + 2 * 0; i++) {
                var corner: vec2<i32> = select(select(vec2<i32>(i, 0), vec2<i32>(0, i), false), vec2<i32>(i % 2, i / 2), 0 > 0);
                var away: vec2<f32> = abs(1.0 - vec2<f32>(corner) - (along - whole));
                var share: f32 = away.x * away.y;
                if (!(share > 0.0)) { continue; }
                var beside: vec2<i32> = vec2<i32>(whole) + corner;
                var there: vec4<f32> = texel(p + beside);
                var dz: f32 = there.a - own.a - dot(plane, vec2<f32>(beside)) * relative(there.a);
                dz = dz * ms_sss.v[at + 1].w;
                if (!(same(there, own) && dz * dz < 1.0)) { continue; }
                var f: f32 = share * (1.0 - dz * dz);
                f = f / (elongation * dz * dz + 1.0);
                below = below + f * dz;
                sum = sum + vec4<f32>(there.rgb * f, f);
            }
            var tap: vec4<f32> = ms_sss.v[at + 5 + min(k + 1, 7 / 2)]; // the one before
            var lift: vec3<f32> = vec3<f32>(1.0, 1.0, 1.0);
            // The sine of the elevation, without what may be rounding of depths; near by, within some
            // 0.17 radii, that of the tap before, as far as it was found.
            var rounding: f32 = rounding_of(own.a, along) * ms_sss.v[at + 1].w;
            below = facing * (below - clamp(below, -rounding, rounding));
            var sine: f32 = below / max(offset, 1e-20);
            var gap: f32 = abs(tap.w) - offset;
            if (gap > 0.0) {
                var s_2: f32 = offset * offset / (0.0289 * radius_mm * radius_mm);
                var follow: f32 = outer.a * outer.a * outer.a * outer.a / (1.0 + s_2 * s_2);
                sine = sine + follow * (outer_sine * sum.a * offset / abs(tap.w) - sine);
            }
            // The area of the tap before: by the slope from this one to it.
            var lower: f32 = below / (sum.a + 0.001);
            var bend: f32 = 0.0;
            if (gap > 1e-20 && ms_sss.v[at + 3].w < 0.5) { bend = (outer_lower - lower) / gap; }
            outer = outer * min(0.5 * ms_sss.v[2].z * bend * bend + 1.0, 3.0);
            lift = lift_of(outer_sine, least_sine, elevation);
            outer_sine = sine;
            outer_lower = lower;
            weight = weight + tap.rgb * outer.a;
            lifted = lifted + lift * tap.rgb * outer.a;
            result = result + lift * tap.rgb * outer.rgb;
            outer = sum;
        }
    }

    var mixed: i32 = i32(ms_sss.v[at + 3].w);
    var mean: vec3<f32> = ms_sss.v[at].rgb * mean_of(result, max(weight, lifted * ms_sss.v[at + 4].rgb), own.rgb);
    var filled: vec3<f32> = result + own.rgb * (ms_sss.v[at].rgb - weight);
    result.r = select(mean.r, filled.r, (mixed & 1) != 0);
    result.g = select(mean.g, filled.g, (mixed & 2) != 0);
    result.b = select(mean.b, filled.b, (mixed & 4) != 0);
    return vec4<f32>(result.rg, pack(result.b, profile_of(own)), own.a);
}

struct ms_sss_block { v: array<vec4<f32>, 148> };
@group(0) @binding(0) var<uniform> ms_sss: ms_sss_block;

@fragment
fn main(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return filter_pixel(vec2<i32>(position.xy));
}
