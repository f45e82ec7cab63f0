/* Subsurface scattering in an engine's frame, in plain OpenGL 3.3 core: G-buffer, two passes, composition. A knot of
   jade and a ball of wax before cloth, which must not glow; a lamp shines through the rims from behind. OUT.png: without
   scattering on the left, with it on the right.

     make build/engine && build/engine OUT.png, or
     xxd -i <examples/engine/shader/ms_sss.glsl >build/ms_sss.glsl.inc
     cc -O2 -I. -Ibuild examples/engine/engine.c -o build/engine -lEGL -lm

   To port it: ms_sss.glsl is HLSL and Vulkan's GLSL as well, by a #define, and x.wgsl and y.wgsl beside it are WGSL;
   what stands here as a uniform array is one constant buffer there, filled with the same bytes; "texture unit n" is a
   descriptor at the binding that the file names; between two draws, where the target of one is read by the next, Vulkan
   and D3D12 want a barrier from render target to shader resource. Nothing else depends on the API. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "egl.h"
#include "../tools/image.h"

/* The shader file in this program; by a compiler of C23: #embed "shader/ms_sss.glsl". */
static const char sss_file[] = {
#include "ms_sss.glsl.inc"
    , 0};

enum { WIDTH = 480, HEIGHT = 540, SHOWN = 2 * WIDTH, KERNELS = 2 }; /* jade, wax */
enum { IRRADIANCE, ALBEDO, SPECULAR, THROUGH, MIDDLE, FILTERED, PICTURE, TARGETS };

/* What stands for the engine's mesh pass. It writes what every engine has: light that arrives, before the albedo and
   without the specular part, with depth (along the view axis) and the material's index in alpha. Materials that do not
   scatter write 0 there. Its light loop calls ms_sss_transmission, with which ms_sss.glsl goes before this text. */
static const char *const scene =
    "uniform vec4 reflectance[2], decay[2];\n"
    "layout(location = 0) out vec4 irradiance; layout(location = 1) out vec4 albedo;\n"
    "layout(location = 2) out vec4 specular; layout(location = 3) out vec4 through;\n"
    "const vec4 ball = vec4(2.35, -2.45, -10.9, 1.0);\n"
    "const vec3 middle = vec3(0.0, 0.3, -12.0), turn[3] = vec3[3](vec3(0.95, 0.0, 0.31), vec3(-0.09, 0.96, 0.28), vec3(-0.30, -0.29, 0.91));\n"
    "const vec3 lamp[2] = vec3[2](vec3(-0.80, 0.42, 0.43), vec3(0.52, 0.50, -0.69)), power[2] = vec3[2](vec3(1.05, 1.0, 0.92), vec3(3.0, 2.8, 2.5));\n"
    "/* Distance to the knot, two strands that turn around a ring, and to the ball. */\n"
    "vec2 distances(vec3 p) {\n"
    "    vec3 q = vec3(dot(turn[0], p - middle), dot(turn[1], p - middle), dot(turn[2], p - middle));\n"
    "    float angle = 1.5 * atan(q.y, q.x), c = cos(angle), s = sin(angle), ring = length(q.xy) - 1.9;\n"
    "    vec2 strand = vec2(abs(c * ring + s * q.z) - 0.82, c * q.z - s * ring);\n"
    "    return vec2(0.6 * (length(strand) - 0.56), length(p - ball.xyz) - ball.w);\n"
    "}\n"
    "float nearest(vec3 p) { vec2 d = distances(p); return min(d.x, d.y); }\n"
    "vec3 normal(vec3 p) {\n"
    "    vec2 h = vec2(0.004, 0.0);\n"
    "    return normalize(vec3(nearest(p + h.xyy) - nearest(p - h.xyy), nearest(p + h.yxy) - nearest(p - h.yxy), nearest(p + h.yyx) - nearest(p - h.yyx)));\n"
    "}\n"
    "/* Along the ray from `from`, the first place outside (side 1) or inside (side -1), at most `far` away. */\n"
    "float march(vec3 from, vec3 ray, float start, float far, float side) {\n"
    "    float t = start;\n"
    "    for (int i = 0; i < 160 && t < far; ++i) {\n"
    "        float d = -side * nearest(from + t * ray);\n"
    "        if (d < 0.0005) return t;\n"
    "        t += max(d, 0.002);\n"
    "    }\n"
    "    return far;\n"
    "}\n"
    "/* How much of a lamp 5 degrees wide is seen. */\n"
    "float seen(vec3 from, vec3 ray) {\n"
    "    float t = 0.02, open = 1.0;\n"
    "    for (int i = 0; i < 100 && t < 9.0 && open > 0.0; ++i) {\n"
    "        float d = nearest(from + t * ray);\n"
    "        open = min(open, 0.5 + 11.0 * d / t);\n"
    "        t += clamp(d, 0.02, 0.5);\n"
    "    }\n"
    "    return smoothstep(0.0, 1.0, open);\n"
    "}\n"
    "void main() {\n"
    "    vec3 ray = normalize(vec3((gl_FragCoord.xy - vec2(240.0, 270.0)) / 741.8, -1.0)); /* 270 / tan(20 degrees) */\n"
    "    float wall = 16.0 / -ray.z, t = march(vec3(0.0), ray, 8.0, wall, -1.0), depth = -ray.z * t;\n"
    "    vec3 p = ray * t, n = vec3(0.0, 0.0, 1.0), light = vec3(0.1, 0.11, 0.13), shine = vec3(0.0), behind = vec3(0.0);\n"
    "    vec2 d = distances(p);\n"
    "    int what = t < wall ? (d.x < d.y ? 0 : 1) : -1;\n"
    "    if (what >= 0) n = normal(p);\n"
    "    for (int i = 0; i < 2; ++i) {\n"
    "        float cosine = dot(n, lamp[i]);\n"
    "        float shadow = cosine > 0.0 ? seen(p + 0.02 * n, lamp[i]) : 0.0;\n"
    "        light += power[i] * shadow * max(cosine, 0.0);\n"
    "        shine += power[i] * shadow * pow(max(dot(n, normalize(lamp[i] - ray)), 0.0), 80.0) * 0.35;\n"
    "        if (what >= 0 && cosine < 0.3) { /* an engine has the thickness and the entry's normal in a shadow map */\n"
    "            float way = march(p - 0.02 * n, lamp[i], 0.0, 9.0, 1.0);\n"
    "            vec3 entry = p - 0.02 * n + way * lamp[i], out_there = normal(entry);\n"
    "            float lit = seen(entry + 0.02 * out_there, lamp[i]);\n"
    "            behind += lit * ms_sss_transmission(reflectance[what].rgb, decay[what].rgb, 10.0 * way, n, out_there, lamp[i], power[i]);\n"
    "        }\n"
    "    }\n"
    "    irradiance = vec4(light, what < 0 ? 0.0 : intBitsToFloat(floatBitsToInt(depth) + 8 & ~15 | what));\n"
    "    vec2 weave = step(fract(p.xy * 2.0), vec2(0.5));\n"
    "    albedo = vec4(what == 0 ? vec3(0.42, 0.72, 0.5) : what == 1 ? vec3(0.9, 0.82, 0.55) : vec3(0.05, 0.09, 0.2) * (0.7 + 0.6 * abs(weave.x - weave.y)), 1.0);\n"
    "    specular = vec4(what < 0 ? vec3(0.0) : shine, 1.0);\n"
    "    through = vec4(behind, 1.0);\n"
    "}\n";

/* What goes before ms_sss.glsl in a pass: how it reads the G-buffer. The same functions over a raw depth buffer, a
   stencil index or an array layer do. */
static const char *const pass_head =
    "#version 330\n"
    "#define MS_SSS_STEP %d\n"
    "#define MS_SSS_TAPS %d\n"
    "#define MS_SSS_PROFILES %d\n"
    "uniform sampler2D irradiance;\n"
    "vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(irradiance, p, 0).rgb; }\n"
    "float ms_sss_fetch_depth(ivec2 p) { return texelFetch(irradiance, p, 0).a; }\n"
    "int ms_sss_fetch_profile(ivec2 p) { return floatBitsToInt(texelFetch(irradiance, p, 0).a) & 15; }\n";

/* The engine's composition. Light through thin parts by max: near a shadow's border the filter holds it already.
   left: the column where the picture begins; 0: that without scattering, which an engine has no use for. */
static const char *const compose =
    "#version 330\n"
    "uniform sampler2D irradiance, filtered, albedo, specular, through; uniform int left; out vec4 color;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - ivec2(left, 0);\n"
    "    vec3 light = left == 0 ? texelFetch(irradiance, p, 0).rgb : max(texelFetch(filtered, p, 0).rgb, texelFetch(through, p, 0).rgb);\n"
    "    vec3 c = light * texelFetch(albedo, p, 0).rgb + texelFetch(specular, p, 0).rgb;\n"
    "    color = vec4(pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);\n"
    "}\n";

static char text[60000], log_text[2000];
static GLuint texture[TARGETS]; /* of which texture unit n holds number n */

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "engine: %s: %s\n", what, why);
    return 1;
}

static void read_by(GLuint program, const char *name, int unit)
{
    gl_Uniform1i(gl_GetUniformLocation(program, name), unit);
}

static void draw(int first, int count)
{
    static const GLenum to[4] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                 GL_COLOR_ATTACHMENT3};
    int i;
    for (i = 0; i < 4; ++i)
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, to[i], GL_TEXTURE_2D, i < count ? texture[first + i] : 0, 0);
    gl_DrawBuffers(count, to);
    gl_DrawArrays(GL_TRIANGLES, 0, 3);
}

int main(int argc, char **argv)
{
    /* Assets: built once, by a tool, for 90 pixels, about their radius where they are nearest. Materials as
       color and Burley's distance here. */
    static const double reflectance[KERNELS][3] = {{0.42, 0.72, 0.5}, {0.9, 0.82, 0.55}},
                        distance_mm[KERNELS][3] = {{0.6, 1.25, 0.7}, {1.2, 0.9, 0.5}};
    static ms_sss_kernel kernel[KERNELS];
    ms_sss_kernel_options taps = ms_sss_kernel_defaults();
    ms_sss_errors errors;
    static float constants[64][4], factor[2][KERNELS][4];
    static unsigned char picture[SHOWN * HEIGHT * 4], rgb[SHOWN * HEIGHT * 3];
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_shader shader;
    ms_error error;
    GLuint program;
    int i, c, step;
    const char *problem;
    if (argc != 2) return fail("usage", "engine OUT.png");
    for (i = 0; i < KERNELS; ++i) {
        ms_sss_profile *profile;
        if (ms_sss_profile_from_burley(&profile, reflectance[i], distance_mm[i], NULL, &error) != MS_OK)
            return fail("profile", error.message);
        taps.tap_count = 33;
        if (ms_sss_kernel_make(&kernel[i], &errors, profile, 90, &taps, NULL, &error) != MS_OK)
            return fail("kernel", error.message);
        printf("kernel %d: %d taps, bands %.0f (seen from %d), error on textures %.1f%%\n", i, kernel[i].tap_count,
               errors.bands, MS_SSS_BANDS_SEEN, 100 * errors.texture);
        ms_sss_profile_destroy(profile);
        for (c = 0; c < 3; ++c) {
            factor[0][i][c] = kernel[i].reflectance[c];
            factor[1][i][c] = kernel[i].decay[c];
        }
    }

    /* At start, and at a resize: targets. Depth and index in one alpha ask for 32 bits; the picture itself for 8. */
    if (!gl_open(GL_API_33)) return fail("OpenGL 3.3", "no context without a window on this machine");
    for (i = 0; i < TARGETS; ++i)
        texture[i] = gl_texture(i, i == PICTURE ? GL_RGBA8 : GL_RGBA32F, i == PICTURE ? SHOWN : WIDTH, HEIGHT, NULL);
    gl_Viewport(0, 0, WIDTH, HEIGHT);

    /* Every frame: 1. the G-buffer */
    snprintf(text, sizeof text, "#version 330\n#define MS_SSS_STEP 8\n%s%s", sss_file, scene);
    if (!(program = gl_program(gl_corner[0], text, log_text, sizeof log_text))) return fail("scene", log_text);
    gl_Uniform4fv(gl_GetUniformLocation(program, "reflectance"), KERNELS, &factor[0][0][0]);
    gl_Uniform4fv(gl_GetUniformLocation(program, "decay"), KERNELS, &factor[1][0][0]);
    draw(IRRADIANCE, 4);

    /* 2. the passes: programs are made once, constants again when what ms_sss.h names beside them changes */
    options.fov_degrees = 40;
    options.mm_per_unit = 10; /* the scene is in centimeters */
    shader = ms_sss_shader_defaults();
    shader.tap_count = kernel[0].tap_count;
    shader.profile_count = KERNELS;
    shader.nearest = 9.4f; /* of both: too wide a kernel for its taps is refused */
    if (ms_sss_shader_constant_count(&shader) > 64) return fail("constants", "more than 64");
    if (ms_sss_shader_constants(kernel, 0, &options, WIDTH, HEIGHT, &shader, constants, &error) != MS_OK)
        return fail("constants", error.message);
    for (step = 0; step < 2; ++step) {
        const int n = snprintf(text, sizeof text, pass_head, step, shader.tap_count, shader.profile_count);
        snprintf(text + n, sizeof text - (size_t)n, "%s", sss_file);
        if (!(program = gl_program(gl_corner[0], text, log_text, sizeof log_text))) return fail("pass", log_text);
        gl_Uniform4fv(gl_GetUniformLocation(program, "ms_sss"), ms_sss_shader_constant_count(&shader), constants[0]);
        read_by(program, "irradiance", IRRADIANCE);
        read_by(program, "ms_sss_input", MIDDLE);
        draw(step ? FILTERED : MIDDLE, 1);
    }

    /* 3. the composition, tone-mapped */
    if (!(program = gl_program(gl_corner[0], compose, log_text, sizeof log_text))) return fail("composition", log_text);
    read_by(program, "irradiance", IRRADIANCE);
    read_by(program, "filtered", FILTERED);
    read_by(program, "albedo", ALBEDO);
    read_by(program, "specular", SPECULAR);
    read_by(program, "through", THROUGH);
    for (i = 0; i < 2; ++i) {
        gl_Uniform1i(gl_GetUniformLocation(program, "left"), i * WIDTH);
        gl_Viewport(i * WIDTH, 0, WIDTH, HEIGHT);
        draw(PICTURE, 1);
    }
    gl_ReadPixels(0, 0, SHOWN, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (i = 0; i < SHOWN * HEIGHT; ++i) /* OpenGL's rows go up */
        memcpy(rgb + 3 * i, picture + 4 * ((HEIGHT - 1 - i / SHOWN) * SHOWN + i % SHOWN), 3);
    problem = image_write_png8(argv[1], rgb, SHOWN, HEIGHT, 3);
    return problem ? fail(argv[1], problem) : 0;
}
