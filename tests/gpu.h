/* What the tests of shader texts share: texts that cannot run here become GLSL through SPIR-V; programs; and pages that
   a headless Chromium runs with tests/gpu.js. GPU_FILE "name" stands before the names of files in build/. */
#ifndef GPU_H
#define GPU_H
#include "egl.h"
#include "test.h"

enum { GPU_GLSL_330, GPU_GLSL_ES_300, GPU_VULKAN, GPU_HLSL, GPU_WGSL }; /* languages, as the headers number them */
#define GPU_LOG "build/" GPU_FILE "_log.txt"

static char text[100000];

static int gpu_can_translate(void)
{
    return system("glslangValidator --version >" GPU_LOG " 2>&1 && spirv-cross --revision >>" GPU_LOG " 2>&1") == 0;
}

/* HLSL and Vulkan's GLSL cannot run here: through SPIR-V text becomes GLSL 330 again. */
static void gpu_translate(int language)
{
    static const char step[] = "build/" GPU_FILE "_step.frag";
    FILE *f = fopen(step, "w");
    char *back;
    if (f) {
        fputs(text, f);
        fclose(f);
    }
    if (!f ||
        system(language == GPU_HLSL ? "glslangValidator -D -V -S frag -e main -o build/" GPU_FILE
                                      "_step.spv build/" GPU_FILE "_step.frag >" GPU_LOG " 2>&1"
                                    : "glslangValidator -V -S frag -o build/" GPU_FILE "_step.spv build/" GPU_FILE
                                      "_step.frag >" GPU_LOG " 2>&1") != 0 ||
        system("spirv-cross --version 330 --no-es --no-420pack-extension --flatten-ubo --output build/" GPU_FILE
               "_step.glsl build/" GPU_FILE "_step.spv >" GPU_LOG " 2>&1") != 0)
        TEST_FAIL("no translation: " GPU_LOG);
    back = test_read_file("build/" GPU_FILE "_step.glsl", NULL);
    if (back && strlen(back) < sizeof text) strcpy(text, back);
    free(back);
}

/* A program of text; without a word from the driver, but about what a translation left undefined. constants:
   [count][4], the uniform of this name. */
static GLuint gpu_program(int language, int compute, const char *name, const float *constants, int count)
{
    char log[2000], block[40];
    GLuint program;
    if (language >= GPU_VULKAN) gpu_translate(language);
    program = gl_program(compute ? NULL : gl_corner[language == GPU_GLSL_ES_300], text, log, sizeof log);
    if ((log[0] && language < GPU_VULKAN) || !program) TEST_FAIL("%.600s", log);
    snprintf(block, sizeof block, language < GPU_VULKAN ? "%s" : "%s_block", name);
    gl_Uniform4fv(gl_GetUniformLocation(program, block), count, constants);
    return program;
}

/* The texture of this name is on that unit. */
static void gpu_read(GLuint program, int language, const char *name, int unit)
{
    char full[100];
    GLint at;
    snprintf(full, sizeof full, language == GPU_HLSL ? "SPIRV_Cross_Combined%sSPIRV_Cross_DummySampler" : "%s", name);
    at = gl_GetUniformLocation(program, full);
    if (at >= 0) gl_Uniform1i(at, unit);
}

/* Draws into one target or two (other: 0 or a texture), in place of what is there or added to it. */
static void gpu_draw(GLuint target, GLuint other, int width, int height, int add)
{
    static const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, other, 0);
    gl_DrawBuffers(other ? 2 : 1, both);
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    CHECK_INT(gl_CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    gl_Viewport(0, 0, width, height);
    if (add) gl_Enable(GL_BLEND);
    else gl_Disable(GL_BLEND);
    gl_BlendFunc(GL_ONE, GL_ONE);
    gl_DrawArrays(GL_TRIANGLES, 0, 3);
}

/* --- pages --- */

/* 'base64', of count floats. */
static void gpu_put_floats(FILE *f, const float *values, size_t count)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = (const unsigned char *)values;
    size_t i, n = count * sizeof *values;
    fputc('\'', f);
    for (i = 0; i < n; i += 3) {
        const unsigned long v = (unsigned long)b[i] << 16 | (unsigned long)(i + 1 < n ? b[i + 1] : 0) << 8 |
            (i + 2 < n ? b[i + 2] : 0);
        fputc(digit[v >> 18], f);
        fputc(digit[v >> 12 & 63], f);
        fputc(i + 1 < n ? digit[v >> 6 & 63] : '=', f);
        fputc(i + 2 < n ? digit[v & 63] : '=', f);
    }
    fputc('\'', f);
}

/* An image of RGBA, or of one channel that stands in all four. */
static void gpu_put_image(FILE *f, const char *name, int width, int height, int channels, const float *pixels)
{
    size_t i, n = (size_t)(width * height) * 4;
    float *all = (float *)malloc(n * sizeof *all);
    for (i = 0; i < n; ++i) all[i] = pixels[channels == 4 ? i : i / 4];
    fprintf(f, "%s: {size: [%d, %d], pixels: ", name, width, height);
    gpu_put_floats(f, all, n);
    fputs("}, ", f);
    free(all);
}

/* text, as a string of JavaScript. */
static void gpu_put_text(FILE *f)
{
    const char *c;
    fputc('\'', f);
    for (c = text; *c; ++c) {
        if (*c == '\n') fputs("\\n", f);
        else if (*c == '\'') fputs("\\'", f);
        else fputc(*c, f);
    }
    fputs("',\n", f);
}

/* The beginning of a step: what it reads, writes and, as a compute shader, its groups follow. */
static void gpu_put_step(FILE *f, const char *name, const float *constants, int count, int width, int height)
{
    int i;
    fprintf(f, "{size: [%d, %d], block: '%s', constants: [", width, height, name);
    for (i = 0; i < 4 * count; ++i) fprintf(f, "%.9g,", (double)constants[i]);
    fputs("], text: ", f);
    gpu_put_text(f);
}

static int gpu_has_browser(void) { return system("chromium --version >" GPU_LOG " 2>&1") == 0; }

/* A page; what tests/gpu.js calls data follows. */
static FILE *gpu_page(const char *path)
{
    FILE *f = fopen(path, "w");
    if (f) fputs("<!doctype html><meta charset=utf-8><body><script>const data = {", f);
    return f;
}

/* Ends the page at path and runs it. */
static void gpu_run(FILE *f, const char *path)
{
    char command[700], *script = test_read_file("tests/gpu.js", NULL), *log, *found;
    if (!script) TEST_FAIL("cannot read tests/gpu.js");
    fprintf(f, "};\n%s</script>", script ? script : "");
    fclose(f);
    free(script);
    /* until the page has logged its result: --dump-dom does not wait for the GPU */
    snprintf(
        command, sizeof command,
        "{ timeout 300 chromium --headless=new --no-sandbox --user-data-dir=build/" GPU_FILE "_chromium "
        "--enable-unsafe-webgpu --use-webgpu-adapter=swiftshader --use-angle=swiftshader --enable-unsafe-swiftshader "
        "--enable-logging=stderr \"file://$PWD/%s\" >" GPU_LOG " 2>&1 & i=0; "
        "while [ $i -lt 1200 ] && ! grep -q 'gpu worst.*gpu' " GPU_LOG
        "; do sleep 0.25; i=$((i + 1)); done; kill $!; wait; }",
        path);
    if (system(command) < 0) TEST_FAIL("no shell");
    log = test_read_file(GPU_LOG, NULL);
    found = log ? strstr(log, "gpu worst ") : NULL;
    if (!found) TEST_FAIL("chromium gave no result: " GPU_LOG);
    else if (strncmp(found + 10, "no ", 3) == 0) SKIP("chromium has no WebGL 2 or WebGPU here");
    else if (strstr(log, "off by") || strstr(log, "error: ")) TEST_FAIL("%.900s", strstr(log, "CONSOLE"));
    else TEST_NOTE("largest difference %.*s", (int)(strstr(found + 10, " gpu") - found - 10), found + 10);
    free(log);
}

#endif
