/* The shader texts of ms_sss.h, both passes on a software rasteriser without a window, against the filter on the CPU;
   HLSL and Vulkan GLSL through glslangValidator where it is installed.   libraries: -lEGL */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"

/* --- OpenGL through EGL alone --- */

#define GL_LIST(X)                                                                                                     \
    X(void, ActiveTexture, (GLenum))                                                                                   \
    X(void, AttachShader, (GLuint, GLuint))                                                                            \
    X(void, BindFramebuffer, (GLenum, GLuint))                                                                         \
    X(void, BindTexture, (GLenum, GLuint))                                                                             \
    X(void, BindVertexArray, (GLuint))                                                                                 \
    X(void, BlendFunc, (GLenum, GLenum))                                                                               \
    X(GLenum, CheckFramebufferStatus, (GLenum))                                                                        \
    X(void, CompileShader, (GLuint))                                                                                   \
    X(GLuint, CreateProgram, (void))                                                                                   \
    X(GLuint, CreateShader, (GLenum))                                                                                  \
    X(void, DeleteProgram, (GLuint))                                                                                   \
    X(void, DeleteTextures, (GLsizei, const GLuint *))                                                                 \
    X(void, Disable, (GLenum))                                                                                         \
    X(void, DrawArrays, (GLenum, GLint, GLsizei))                                                                      \
    X(void, Enable, (GLenum))                                                                                          \
    X(void, FramebufferTexture2D, (GLenum, GLenum, GLenum, GLuint, GLint))                                             \
    X(void, GenFramebuffers, (GLsizei, GLuint *))                                                                      \
    X(void, GenTextures, (GLsizei, GLuint *))                                                                          \
    X(void, GenVertexArrays, (GLsizei, GLuint *))                                                                      \
    X(void, GetProgramInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *))                                                 \
    X(void, GetProgramiv, (GLuint, GLenum, GLint *))                                                                   \
    X(void, GetShaderInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *))                                                  \
    X(const GLubyte *, GetString, (GLenum))                                                                            \
    X(GLint, GetUniformLocation, (GLuint, const GLchar *))                                                             \
    X(void, LinkProgram, (GLuint))                                                                                     \
    X(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                                      \
    X(void, ShaderSource, (GLuint, GLsizei, const GLchar *const *, const GLint *))                                     \
    X(void, TexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *))                 \
    X(void, TexParameteri, (GLenum, GLenum, GLint))                                                                    \
    X(void, Uniform1i, (GLint, GLint))                                                                                 \
    X(void, Uniform4fv, (GLint, GLsizei, const GLfloat *))                                                             \
    X(void, UseProgram, (GLuint))                                                                                      \
    X(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

#define GL_POINTER(type, name, arguments) static type(*gl_##name) arguments;
GL_LIST(GL_POINTER)
#define GL_ASSIGN(type, name, arguments) gl_##name = (type(*) arguments)eglGetProcAddress("gl" #name);
#define GL_MISSING(type, name, arguments) || gl_##name == NULL

/* A context of the API without a window: desktop OpenGL 3.3 or OpenGL ES 3.0. */
static int gl_open(int es)
{
    static const EGLint desktop[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    static const EGLint embedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    EGLDisplay display;
    EGLContext context;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get = (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    GLuint object;
    if (!get) return 0;
    display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) return 0;
    if (!eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return 0;
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, es ? embedded : desktop);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return 0;
    GL_LIST(GL_ASSIGN)
    if (0 GL_LIST(GL_MISSING)) return 0;
    gl_GenVertexArrays(1, &object);
    gl_BindVertexArray(object);
    gl_GenFramebuffers(1, &object);
    gl_BindFramebuffer(GL_FRAMEBUFFER, object);
    return 1;
}

static GLuint gl_texture(int unit, int width, int height, int channels, const float *pixels)
{
    GLuint texture;
    gl_GenTextures(1, &texture);
    gl_ActiveTexture((GLenum)(GL_TEXTURE0 + unit));
    gl_BindTexture(GL_TEXTURE_2D, texture);
    gl_TexImage2D(GL_TEXTURE_2D, 0, channels == 4 ? GL_RGBA32F : GL_R32F, width, height, 0, channels == 4 ? GL_RGBA : GL_RED,
                  GL_FLOAT, pixels);
    gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

static GLuint gl_stage(GLuint program, GLenum type, const char *text)
{
    char log[2000];
    GLuint shader = gl_CreateShader(type);
    gl_ShaderSource(shader, 1, &text, NULL);
    gl_CompileShader(shader);
    gl_AttachShader(program, shader);
    gl_GetShaderInfoLog(shader, sizeof log, NULL, log);
    if (log[0]) TEST_FAIL("%.600s", log);
    return shader;
}

/* --- a small picture --- */

enum { WIDTH = 97, HEIGHT = 75, PIXELS = WIDTH * HEIGHT };
static float input[PIXELS * 4], output[PIXELS * 4], drawn[PIXELS * 4], middle[PIXELS * 4], depth[PIXELS], strength[PIXELS];

static void make_picture(void)
{
    uint64_t seed = test_seed;
    int x, y, c;
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const int i = y * WIDTH + x;
            const double u = 2.0 * x / WIDTH - 1, v = 2.0 * y / HEIGHT - 1, bump = 0.7 - u * u - v * v;
            depth[i] = (float)(bump > 0 ? 50 - 10 * sqrt(bump) : 60 + u);
            strength[i] = (float)(x % 9 == 0 && y % 5 == 0 ? 0 : 0.2 + 0.9 * test_uniform(&seed));
            for (c = 0; c < 4; ++c) input[4 * i + c] = (float)((x / 5 + y / 7) % 2 ? test_uniform(&seed) : 0.5);
        }
    }
    depth[17 * WIDTH + 20] = -1;
    depth[18 * WIDTH + 30] = INFINITY;
    input[4 * (30 * WIDTH + 40)] = INFINITY;
}

/* Terms of 1 (positive weights) to 3 (both signs) and a centre term; pairs equal, so that half kernels can be used. */
static ms_sss_kernel make_kernel(int taps, int terms)
{
    ms_sss_kernel k;
    int t, i, c;
    memset(&k, 0, sizeof k);
    k.tap_count = taps;
    k.term_count = terms;
    k.radius_mm = 4;
    for (i = 1; i < taps; ++i) {
        double u = (double)((i + 1) / 2) / (double)(taps / 2);
        k.offset_mm[i] = (float)((i % 2 ? -1 : 1) * 3.7 * u * u);
    }
    for (c = 0; c < 3; ++c) {
        double total = (double)(k.delta[c] = 0.1f);
        for (t = terms - 1; t >= 0; --t) {
            double sum = 0;
            for (i = 0; i < taps; ++i) {
                double u = (double)k.offset_mm[i] / 4;
                k.weight[t][i][c] = (float)((t ? cos((2 * t + 0.1 * c) * u) : 1.6 * exp(-u * u * (2 + c))) / taps);
                sum += (double)k.weight[t][i][c];
            }
            k.scale[t][c] = (float)(t ? 0.2 * (t % 2 ? 1 : -1) : (1 - total) / (sum * sum));
            total += (double)k.scale[t][c] * sum * sum;
        }
    }
    return k;
}

/* --- the shader against the filter --- */

static char text[20000];

/* Draws one pass of a term into target. */
static void draw(const ms_sss_shader *shader, const ms_sss_filter_options *o, float (*constants)[4], GLuint target, int add)
{
    static const char *const name[4] = {"ms_sss_colour", "ms_sss_depth", "ms_sss_strength", "ms_sss_input"};
    const char *corner = shader->language == MS_SSS_GLSL_330
                             ? "#version 330\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n"
                             : "#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n";
    GLuint program = gl_CreateProgram();
    char log[2000];
    int linked = 0, i;
    CHECK(ms_sss_shader_text(shader, o, text, sizeof text) > 1000);
    gl_stage(program, GL_VERTEX_SHADER, corner);
    gl_stage(program, GL_FRAGMENT_SHADER, text);
    gl_LinkProgram(program);
    gl_GetProgramiv(program, GL_LINK_STATUS, &linked);
    gl_GetProgramInfoLog(program, sizeof log, NULL, log);
    if (!linked) TEST_FAIL("%.600s", log);
    gl_UseProgram(program);
    for (i = 0; i < 4; ++i) {
        GLint at = gl_GetUniformLocation(program, name[i]);
        if (at >= 0) gl_Uniform1i(at, i == 0 && shader->second ? 4 : i);
    }
    gl_Uniform4fv(gl_GetUniformLocation(program, "ms_sss"), ms_sss_shader_constant_count(shader->tap_count, shader->half_kernel),
                  &constants[0][0]);
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    CHECK_INT(gl_CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    gl_Viewport(0, 0, WIDTH, HEIGHT);
    if (add) gl_Enable(GL_BLEND);
    else gl_Disable(GL_BLEND);
    gl_BlendFunc(GL_ONE, GL_ONE);
    gl_DrawArrays(GL_TRIANGLES, 0, 3);
    gl_DeleteProgram(program);
}

/* Largest difference between the two for one set of options. */
static double compare(ms_sss_language language, const ms_sss_kernel *k, const ms_sss_filter_options *o, int with_depth,
                      int with_strength, int half_kernel)
{
    static float constants[MS_SSS_TAPS_MAX + 7][4];
    const size_t size = ms_sss_filter_workspace(WIDTH, HEIGHT, k, 1, o);
    void *workspace = malloc(size);
    ms_sss_frame f;
    ms_sss_shader shader;
    ms_error error;
    GLuint texture[6];
    double worst = 0;
    int i, c, term;
    memset(&f, 0, sizeof f);
    f.width = WIDTH;
    f.height = HEIGHT;
    f.input = ms_sss_interleaved(input, 4, 0);
    f.output = ms_sss_interleaved(output, 4, 0);
    if (with_depth) f.depth = ms_sss_map(depth, 1, 0);
    if (with_strength) f.strength = ms_sss_map(strength, 1, 0);
    if (ms_sss_filter(&f, k, 1, o, workspace, size, &error) != MS_OK) TEST_FAIL("%s", error.message);
    free(workspace);
    texture[0] = gl_texture(0, WIDTH, HEIGHT, 4, input);
    texture[1] = gl_texture(1, WIDTH, HEIGHT, 1, depth);
    texture[2] = gl_texture(2, WIDTH, HEIGHT, 1, strength);
    texture[3] = gl_texture(3, WIDTH, HEIGHT, 4, input);
    texture[4] = gl_texture(4, WIDTH, HEIGHT, 4, NULL);
    texture[5] = gl_texture(5, WIDTH, HEIGHT, 4, NULL);
    memset(&shader, 0, sizeof shader);
    shader.language = language;
    shader.tap_count = k->tap_count;
    shader.half_kernel = half_kernel;
    shader.with_depth = with_depth;
    shader.with_strength = with_strength;
    for (term = 0; term < k->term_count; ++term) {
        if (ms_sss_shader_constants(k, term, o, WIDTH, HEIGHT, &shader, constants, &error) != MS_OK) TEST_FAIL("%s", error.message);
        shader.second = 0;
        draw(&shader, o, constants, texture[4], 0);
        gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, middle);
        shader.second = 1;
        draw(&shader, o, constants, texture[5], term > 0);
    }
    gl_ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, drawn);
    gl_DeleteTextures(6, texture);
    for (i = 0; i < PIXELS; ++i) {
        for (c = 0; c < 3; ++c) {
            double e = fabs((double)drawn[4 * i + c] - (double)output[4 * i + c]);
            if (!ms__finite_f(output[4 * i + c]) || !ms__finite_f(input[4 * i])) continue; /* infinity comes back as it may */
            if (!(e <= worst)) worst = e == e ? e : 1e9;
        }
    }
    return worst;
}

/* The same sums in another order, exp2 and division of the rasteriser: about 1e-6 of values up to 1; the depth factor
   squares differences of depths near 50 whose rounding is 4e-6: 1e-5 covers it. */
#define GPU_TOLERANCE 1e-5

static void compare_all(int es)
{
    const ms_sss_language language = es ? MS_SSS_GLSL_ES_300 : MS_SSS_GLSL_330;
    double worst = 0;
    int i;
    if (!gl_open(es)) SKIP("no %s context without a window", es ? "OpenGL ES 3.0" : "OpenGL 3.3");
    make_picture();
    for (i = 0; i < 24; ++i) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_kernel k = make_kernel(i % 2 ? 7 : 11, es ? 1 : 1 + i % 3);
        int with_depth = i % 3 != 2 || i % 4 == 0;
        double e;
        if (i % 3 == 0) o.fov_degrees = 30;
        if (i % 3 == 1) o.ortho_height = 40;
        if (i % 3 == 2) o.pixels_per_mm[0] = 1.7f;
        o.depth_mode = (ms_sss_depth_mode)(i / 3 % 3);
        o.uv_steps = i % 5 == 0;
        o.fade = i % 4 == 1 ? 0.3f : 0.0f;
        if (i % 7 == 3) o.rotation = 0.4f;
        if (i % 8 == 5) o.jitter = 1;
        e = compare(language, &k, &o, with_depth, i % 2, i % 4 < 2);
        if (!(e <= GPU_TOLERANCE)) TEST_FAIL("options %d: %g", i, e);
        if (e > worst) worst = e;
    }
    TEST_NOTE("%s: largest difference %.1e", (const char *)gl_GetString(GL_RENDERER), worst);
}

static void case_desktop(void) { compare_all(0); }
static void case_es(void) { compare_all(1); }

/* --- the other languages --- */

static void validate(ms_sss_language language, const char *flags, const char *path)
{
    char command[300];
    int i, count = 0;
    if (system("glslangValidator --version >build/glslang.txt 2>&1") != 0) SKIP("no glslangValidator on this machine");
    for (i = 0; i < 64; ++i) {
        ms_sss_filter_options o = ms_sss_filter_defaults();
        ms_sss_shader shader;
        FILE *f;
        o.depth_mode = i & 16 ? MS_SSS_DEPTH_FOLLOW : MS_SSS_DEPTH_AWARE;
        if (i & 8) o.fov_degrees = 40;
        else o.ortho_height = 100;
        if (i & 32) o.rotation = 1;
        memset(&shader, 0, sizeof shader);
        shader.language = language;
        shader.second = i & 1;
        shader.half_kernel = (i & 2) != 0;
        shader.with_depth = 1;
        shader.with_strength = (i & 4) != 0;
        shader.tap_count = 7;
        if (!test_full && i % 5) continue;
        CHECK(ms_sss_shader_text(&shader, &o, text, sizeof text) > 0);
        f = fopen(path, "w");
        if (!f) SKIP("cannot write %s", path);
        fputs(text, f);
        fclose(f);
        snprintf(command, sizeof command, "glslangValidator %s %s >build/glslang.txt 2>&1", flags, path);
        if (system(command) != 0) {
            char *log = test_read_file("build/glslang.txt", NULL);
            TEST_FAIL("variant %d: %.600s", i, log ? log : "no log");
            free(log);
        }
        ++count;
    }
    TEST_NOTE("%d texts", count);
}

static void case_hlsl(void) { validate(MS_SSS_HLSL, "-D -V -S frag -e main -o build/sss.spv", "build/sss_hlsl.frag"); }
static void case_vulkan(void) { validate(MS_SSS_GLSL_VULKAN, "-V -S frag -o build/sss.spv", "build/sss_vulkan.frag"); }

static const test_case cases[] = {
    {"OpenGL 3.3 against the CPU", case_desktop},
    {"OpenGL ES 3.0 against the CPU", case_es},
    {"HLSL is valid", case_hlsl},
    {"Vulkan GLSL is valid", case_vulkan},
};
TEST_MAIN(cases)
