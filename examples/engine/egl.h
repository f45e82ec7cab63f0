/* OpenGL through EGL alone, without a window or a loader: on the GPU where its driver has EGL, else on Mesa's software
   rasteriser. Link with -lEGL. Functions are gl_Name for glName. */
#ifndef GL_EGL_H
#define GL_EGL_H
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <stdio.h>
#include <stdlib.h>

#define GL_LIST(X)                                                                                     \
    X(void, ActiveTexture, (GLenum))                                                                   \
    X(void, AttachShader, (GLuint, GLuint))                                                            \
    X(void, BeginQuery, (GLenum, GLuint))                                                              \
    X(void, BindFramebuffer, (GLenum, GLuint))                                                         \
    X(void, BindImageTexture, (GLuint, GLuint, GLint, GLboolean, GLint, GLenum, GLenum))               \
    X(void, BindTexture, (GLenum, GLuint))                                                             \
    X(void, BindVertexArray, (GLuint))                                                                 \
    X(void, BlendFunc, (GLenum, GLenum))                                                               \
    X(GLenum, CheckFramebufferStatus, (GLenum))                                                        \
    X(void, CompileShader, (GLuint))                                                                   \
    X(GLuint, CreateProgram, (void))                                                                   \
    X(GLuint, CreateShader, (GLenum))                                                                  \
    X(void, DeleteProgram, (GLuint))                                                                   \
    X(void, DeleteShader, (GLuint))                                                                    \
    X(void, DeleteTextures, (GLsizei, const GLuint *))                                                 \
    X(void, Disable, (GLenum))                                                                         \
    X(void, DispatchCompute, (GLuint, GLuint, GLuint))                                                 \
    X(void, DrawArrays, (GLenum, GLint, GLsizei))                                                      \
    X(void, DrawBuffers, (GLsizei, const GLenum *))                                                    \
    X(void, Enable, (GLenum))                                                                          \
    X(void, EndQuery, (GLenum))                                                                        \
    X(void, Finish, (void))                                                                            \
    X(void, FramebufferTexture2D, (GLenum, GLenum, GLenum, GLuint, GLint))                             \
    X(void, GenFramebuffers, (GLsizei, GLuint *))                                                      \
    X(void, GenQueries, (GLsizei, GLuint *))                                                           \
    X(void, GenTextures, (GLsizei, GLuint *))                                                          \
    X(void, GenVertexArrays, (GLsizei, GLuint *))                                                      \
    X(void, GetProgramInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *))                                 \
    X(void, GetProgramiv, (GLuint, GLenum, GLint *))                                                   \
    X(void, GetShaderInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *))                                  \
    X(const GLubyte *, GetString, (GLenum))                                                            \
    X(GLint, GetUniformLocation, (GLuint, const GLchar *))                                             \
    X(void, LinkProgram, (GLuint))                                                                     \
    X(void, MemoryBarrier, (GLbitfield))                                                               \
    X(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                      \
    X(void, ShaderSource, (GLuint, GLsizei, const GLchar *const *, const GLint *))                     \
    X(void, TexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *)) \
    X(void, TexParameteri, (GLenum, GLenum, GLint))                                                    \
    X(void, Uniform1i, (GLint, GLint))                                                                 \
    X(void, Uniform4fv, (GLint, GLsizei, const GLfloat *))                                             \
    X(void, UseProgram, (GLuint))                                                                      \
    X(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

#define GL_POINTER(type, name, arguments) static type(*gl_##name) arguments;
GL_LIST(GL_POINTER)
#define GL_ASSIGN(type, name, arguments) gl_##name = (type(*) arguments)eglGetProcAddress("gl" #name);
#define GL_MISSING(type, name, arguments) || gl_##name == NULL

typedef enum gl_api { GL_API_33, GL_API_ES_30, GL_API_43 } gl_api;

/* Makes a context current: OpenGL 3.3 or 4.3 core, OpenGL ES 3.0; 0: this machine has none. A vertex array and a
   framebuffer are bound. */
static int gl_open(gl_api api)
{
    static const EGLint attributes[3][7] = {
        {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE},
        {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE, 0, 0, 0, 0},
        {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE}};
    PFNEGLGETPLATFORMDISPLAYEXTPROC get = (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress(
        "eglGetPlatformDisplayEXT");
    PFNEGLQUERYDEVICESEXTPROC devices = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    EGLDeviceEXT device[8];
    EGLint count = 0, i;
    GLuint object;
    if (!get) return 0;
    if (!devices || !devices(8, device, &count)) count = 0;
    for (i = 0; i <= count; ++i) { /* GPUs come before software; last the rasteriser that needs no device */
        EGLDisplay display = i < count ? get(EGL_PLATFORM_DEVICE_EXT, device[i], NULL)
                                       : get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
        EGLContext context;
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) continue;
        if (!eglBindAPI(api == GL_API_ES_30 ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) continue;
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes[api]);
        if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) break;
    }
    if (i > count) return 0;
    GL_LIST(GL_ASSIGN)
    if (0 GL_LIST(GL_MISSING)) return 0;
    gl_GenVertexArrays(1, &object);
    gl_BindVertexArray(object);
    gl_GenFramebuffers(1, &object);
    gl_BindFramebuffer(GL_FRAMEBUFFER, object);
    return 1;
}

/* A texture that is read by texel, bound to a unit: NEAREST, for with OpenGL's default a texture without smaller levels
   is incomplete and reads as black, and floats need not be filtered at all. */
static GLuint gl_texture(int unit, GLenum format, int width, int height, const float *pixels)
{
    GLuint texture;
    gl_GenTextures(1, &texture);
    gl_ActiveTexture((GLenum)(GL_TEXTURE0 + unit));
    gl_BindTexture(GL_TEXTURE_2D, texture);
    gl_TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0,
                  format == GL_R32F || format == GL_R8 ? GL_RED : GL_RGBA,
                  format == GL_RGBA8 || format == GL_R8 ? GL_UNSIGNED_BYTE : GL_FLOAT, pixels);
    gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/* Compiles, links and uses; corner: the vertex shader, NULL with a compute shader. log gets what the driver says, which
   may be warnings. 0: it did not link. */
static GLuint gl_program(const char *corner, const char *text, char *log, GLsizei log_size)
{
    GLuint program = gl_CreateProgram();
    int i, linked = 0;
    log[0] = 0;
    for (i = corner ? 0 : 1; i < 2; ++i) {
        GLuint shader = gl_CreateShader(i == 0 ? GL_VERTEX_SHADER : corner ? GL_FRAGMENT_SHADER : GL_COMPUTE_SHADER);
        gl_ShaderSource(shader, 1, i == 0 ? &corner : &text, NULL);
        gl_CompileShader(shader);
        if (!log[0]) gl_GetShaderInfoLog(shader, log_size, NULL, log);
        gl_AttachShader(program, shader);
        gl_DeleteShader(shader);
    }
    gl_LinkProgram(program);
    gl_GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!log[0]) gl_GetProgramInfoLog(program, log_size, NULL, log);
    if (linked) gl_UseProgram(program);
    return linked ? program : 0;
}

/* The vertex shader of a triangle that covers the target. */
#define GL_CORNER_BODY \
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n"
static const char *const gl_corner[2] = {"#version 330\n" GL_CORNER_BODY, "#version 300 es\n" GL_CORNER_BODY};

#endif
