/* Subsurface scattering in an engine's frame, in plain OpenGL 3.3 core: G-buffer, two passes, composition. A ball of
   skin and one of wax before cloth, which must not glow; a lamp shines through the rims from behind.

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

enum { WIDTH = 960, HEIGHT = 540, SKIN = 0, WAX = 1, KERNELS = 2 };
enum { IRRADIANCE, ALBEDO, SPECULAR, THROUGH, MIDDLE, FILTERED, PICTURE, TARGETS };

/* What stands for the engine's mesh pass. It writes what every engine has: light that arrives, before the albedo and
   without the specular part, with depth (along the view axis) and the material's index in alpha. Materials that do not
   scatter write 0 there. Its light loop calls ms_sss_transmission, with which ms_sss.glsl goes before this text. */
static const char *const scene =
    "uniform vec4 reflectance[2], decay[2];\n"
    "layout(location = 0) out vec4 irradiance; layout(location = 1) out vec4 albedo;\n"
    "layout(location = 2) out vec4 specular; layout(location = 3) out vec4 through;\n"
    "const vec4 ball[2] = vec4[2](vec4(-2.3, -0.2, -12.0, 2.1), vec4(2.2, -0.7, -11.0, 1.6));\n"
    "const vec3 lamp[2] = vec3[2](vec3(-0.48, 0.64, 0.6), vec3(0.51, 0.22, -0.83)), power[2] = vec3[2](vec3(0.95), vec3(1.5, 1.35, 1.2));\n"
    "/* Where the ray enters and leaves a ball; x > y: never. */\n"
    "vec2 hit(vec3 from, vec3 ray, vec4 b) {\n"
    "    float k = dot(b.xyz - from, ray), q = k * k - dot(b.xyz - from, b.xyz - from) + b.w * b.w;\n"
    "    return q > 0.0 ? vec2(k - sqrt(q), k + sqrt(q)) : vec2(1.0, 0.0);\n"
    "}\n"
    "void main() {\n"
    "    vec3 ray = normalize(vec3((gl_FragCoord.xy - vec2(480.0, 270.0)) / 741.8, -1.0)); /* 270 / tan(20 degrees) */\n"
    "    float depth = 16.0; int what = -1;\n"
    "    for (int i = 0; i < 2; ++i) {\n"
    "        vec2 t = hit(vec3(0.0), ray, ball[i]);\n"
    "        if (t.x < t.y && -ray.z * t.x < depth) { depth = -ray.z * t.x; what = i; }\n"
    "    }\n"
    "    vec3 p = ray * depth / -ray.z, n = what < 0 ? vec3(0.0, 0.0, 1.0) : normalize(p - ball[what].xyz), light = vec3(0.12), shine = vec3(0.0), behind = vec3(0.0);\n"
    "    for (int i = 0; i < 2; ++i) {\n"
    "        float shadow = 1.0;\n"
    "        for (int k = 0; k < 2; ++k) {\n"
    "            vec2 t = hit(p, lamp[i], ball[k]);\n"
    "            if (k != what && t.x < t.y && t.y > 0.0) shadow = 0.0;\n"
    "        }\n"
    "        light += power[i] * shadow * max(dot(n, lamp[i]), 0.0);\n"
    "        shine += power[i] * shadow * step(0.0, dot(n, lamp[i])) * pow(max(dot(n, normalize(lamp[i] - ray)), 0.0), 60.0) * 0.25;\n"
    "        if (what >= 0) { /* an engine has the thickness and the entry's normal in a shadow map */\n"
    "            float way = max(hit(p, lamp[i], ball[what]).y, 0.0);\n"
    "            behind += shadow * ms_sss_transmission(reflectance[what].rgb, decay[what].rgb, 10.0 * way, n, normalize(p + way * lamp[i] - ball[what].xyz), lamp[i], power[i]);\n"
    "        }\n"
    "    }\n"
    "    irradiance = vec4(light, what < 0 ? 0.0 : intBitsToFloat(floatBitsToInt(depth) + 8 & ~15 | what));\n"
    "    vec2 weave = step(fract(p.xy * 2.0), vec2(0.5));\n"
    "    albedo = vec4(what == 0 ? vec3(0.78, 0.5, 0.38) : what == 1 ? vec3(0.9, 0.82, 0.55) : vec3(0.05, 0.09, 0.2) * (0.7 + 0.6 * abs(weave.x - weave.y)), 1.0);\n"
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

/* The engine's composition. Light through thin parts by max: near a shadow's border the filter holds it already. */
static const char *const compose =
    "#version 330\n"
    "uniform sampler2D filtered, albedo, specular, through; out vec4 color;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    vec3 c = max(texelFetch(filtered, p, 0).rgb, texelFetch(through, p, 0).rgb) * texelFetch(albedo, p, 0).rgb + texelFetch(specular, p, 0).rgb;\n"
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
    static const double reflectance[KERNELS][3] = {{0.78, 0.5, 0.38}, {0.9, 0.82, 0.55}},
                        distance_mm[KERNELS][3] = {{1.2, 0.47, 0.23}, {0.8, 0.6, 0.3}};
    static ms_sss_kernel kernel[KERNELS];
    ms_sss_kernel_options taps = ms_sss_kernel_defaults();
    ms_sss_errors errors;
    static float constants[64][4], factor[2][KERNELS][4];
    static unsigned char picture[WIDTH * HEIGHT * 4], rgb[WIDTH * HEIGHT * 3];
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
        taps.tap_count = 25;
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
    for (i = 0; i < TARGETS; ++i) texture[i] = gl_texture(i, i == PICTURE ? GL_RGBA8 : GL_RGBA32F, WIDTH, HEIGHT, NULL);
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
    shader.nearest = 9.4f; /* of the wax ball: too wide a kernel for its taps is refused */
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
    read_by(program, "filtered", FILTERED);
    read_by(program, "albedo", ALBEDO);
    read_by(program, "specular", SPECULAR);
    read_by(program, "through", THROUGH);
    draw(PICTURE, 1);
    gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (i = 0; i < WIDTH * HEIGHT; ++i) /* OpenGL's rows go up */
        memcpy(rgb + 3 * i, picture + 4 * ((HEIGHT - 1 - i / WIDTH) * WIDTH + i % WIDTH), 3);
    problem = image_write_png8(argv[1], rgb, WIDTH, HEIGHT, 3);
    return problem ? fail(argv[1], problem) : 0;
}
