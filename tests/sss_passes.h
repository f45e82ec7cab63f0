/* Whole pictures by the shader files in OpenGL 3.3: X and Y at full resolution, or DOWN, X, Y and UP. */
#ifndef SSS_PASSES_H
#define SSS_PASSES_H
#include "egl.h"
#include "sss_shader.h"

/* light: [width * height][4]; out as well. With the context that gl_open made; one term. 0: something did not work,
   which stderr names. */
static int sss_passes(const float *light, const float *depth, int width, int height, const ms_sss_kernel *kernel,
                      const ms_sss_filter_options *options, int half, float *out)
{
    enum { LIGHT, DEPTH, SMALL, MIDDLE, SMALL_RESULT, RESULT, TEXTURES };
    static const char *const name[RESULT] = {"ms_sss_color", "ms_sss_depth", "ms_sss_half", "ms_sss_input",
                                             "ms_sss_sum"};
    static const struct {
        ms_sss_step step;
        int to, input;
    } draws[2][4] = {{{MS_SSS_STEP_X, MIDDLE, LIGHT}, {MS_SSS_STEP_Y, RESULT, MIDDLE}},
                     {{MS_SSS_STEP_DOWN, SMALL, LIGHT},
                      {MS_SSS_STEP_X, MIDDLE, SMALL},
                      {MS_SSS_STEP_Y, SMALL_RESULT, MIDDLE},
                      {MS_SSS_STEP_UP, RESULT, LIGHT}}};
    static char source[100000], log[2000];
    static float constants[256][4];
    const int small[2] = {(width + 1) / 2, (height + 1) / 2};
    const GLenum target = GL_COLOR_ATTACHMENT0;
    ms_sss_shader shader = ms_sss_shader_defaults();
    GLuint texture[TEXTURES];
    ms_error error;
    sss_text about;
    int i, k, good = 1;
    memset(&about, 0, sizeof about);
    about.flat = options->flat >= 1;
    shader.tap_count = kernel->tap_count;
    shader.half_resolution = half;
    texture[LIGHT] = gl_texture(LIGHT, GL_RGBA32F, width, height, light);
    texture[DEPTH] = gl_texture(DEPTH, GL_R32F, width, height, depth);
    for (i = SMALL; i < TEXTURES; ++i) {
        const int halved = i != RESULT && (half || i != MIDDLE);
        texture[i] = gl_texture(i, GL_RGBA32F, halved ? small[0] : width, halved ? small[1] : height, NULL);
    }
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
    gl_Disable(GL_BLEND);
    for (i = 0; i < (half ? 4 : 2) && good; ++i) {
        const int to = draws[half][i].to, halved = half && to != RESULT;
        GLuint program = 0;
        shader.step = draws[half][i].step;
        good = ms_sss_shader_constants(kernel, 0, options, width, height, &shader, constants, &error) == MS_OK;
        if (!good) fprintf(stderr, "%s\n", error.message);
        good = good && sss_shader_text(&shader, &about, source, sizeof source);
        if (good) program = gl_program(gl_corner[0], source, log, sizeof log);
        if (!program) fprintf(stderr, "step %d: %s\n", (int)shader.step, log);
        good = program != 0;
        if (!good) continue;
        gl_Uniform4fv(gl_GetUniformLocation(program, "ms_sss"), ms_sss_shader_constant_count(&shader), constants[0]);
        for (k = 0; k < RESULT; ++k) {
            const GLint at = gl_GetUniformLocation(program, name[k]);
            if (at >= 0) gl_Uniform1i(at, k == MIDDLE ? draws[half][i].input : k);
        }
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, target, GL_TEXTURE_2D, texture[to], 0);
        gl_DrawBuffers(1, &target);
        gl_Viewport(0, 0, halved ? small[0] : width, halved ? small[1] : height);
        gl_DrawArrays(GL_TRIANGLES, 0, 3);
        gl_DeleteProgram(program);
    }
    if (good) gl_ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, out);
    gl_DeleteTextures(TEXTURES, texture);
    return good;
}

#endif
