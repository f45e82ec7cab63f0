/* Milliseconds of the shaders of ms_sss.h on this machine's GPU, by timer queries: make bench-gpu. Beside them a shader with
   the structure of the released one (one filtered read of colour and one of depth a tap, no masks) and a disc of 64
   samples. A software driver is timed at 1080p only, once: --full for all. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "bench.h"
#include "gl/egl.h"

enum { COLOUR, DEPTH, MIDDLE, MIDDLE_HALF, TARGET, TEXTURES };
static const char *const binding_name[TEXTURES] = {"colour", "depth", "", "", ""};

typedef struct contender {
    const char *name, *reads;
    int slopes, profiles, half, compute, other; /* other: 1 released, 2 disc */
} contender;

static const contender contenders[] = {
    {"ours, 7 taps", "27", 0, 1, 0, 0, 0},
    {"ours, targets of 16 bits", "27", 0, 1, 1, 0, 0},
    {"ours, 16 profiles", "27", 0, 16, 0, 0, 0},
    {"ours, compute", "27 of a tile", 0, 1, 0, 1, 0},
    {"**ours, slopes and elevation**", "35", 1, 1, 0, 0, 0},
    {"ours, slopes, 16 profiles", "35", 1, 16, 0, 0, 0},
    {"ours, slopes, compute", "35 of a tile", 1, 1, 0, 1, 0},
    {"structure of the released shader, 7 taps", "28 filtered", 0, 1, 1, 0, 1},
    {"disc of 64 samples", "130", 0, 1, 0, 0, 2},
};

/* One pass: colour and depth filtered at each tap, the tap's colour fades to the pixel's own with the depth between. */
static const char *const released =
    "#version 330\n"
    "uniform sampler2D colour, depth; uniform vec4 taps[7], frame; out vec4 result;\n"
    "void main() {\n"
    "    vec2 uv = gl_FragCoord.xy / frame.xy;\n"
    "    vec4 own = texture(colour, uv);\n"
    "    float z = texture(depth, uv).r;\n"
    "    vec2 axis = (frame.z > 0.5 ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * frame.w / z / frame.xy;\n"
    "    vec3 sum = own.rgb * taps[0].rgb;\n"
    "    for (int i = 1; i < 7; ++i) {\n"
    "        vec2 at = uv + axis * taps[i].a;\n"
    "        vec3 c = texture(colour, at).rgb;\n"
    "        sum += taps[i].rgb * mix(c, own.rgb, clamp(0.3 * abs(z - texture(depth, at).r), 0.0, 1.0));\n"
    "    }\n"
    "    result = vec4(sum, own.a);\n"
    "}\n";

/* 64 samples of a disc by the golden angle, radii by exp(-r / d), weighted by profile over density at the true distance. */
static const char *const disc =
    "#version 330\n"
    "uniform sampler2D colour, depth; uniform vec4 taps[7], frame; out vec4 result;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    float z = texelFetch(depth, p, 0).r, scale = frame.w / z;\n"
    "    vec3 d = vec3(1.2, 0.5, 0.3), sum = vec3(0.0), weight = vec3(0.0);\n"
    "    for (int i = 0; i < 64; ++i) {\n"
    "        float u = (float(i) + 0.5) / 64.0, r = -3.0 * log(1.0 - 0.98 * u), angle = 2.39996 * float(i);\n"
    "        ivec2 at = clamp(p + ivec2(r * scale * vec2(cos(angle), sin(angle))), ivec2(0), ivec2(frame.xy) - 1);\n"
    "        float dz = texelFetch(depth, at, 0).r - z, s = sqrt(r * r + dz * dz) + 1e-3;\n"
    "        vec3 w = (exp(-s / d) + exp(-s / (3.0 * d))) / (s * d) * r * exp(r / 3.0);\n"
    "        sum += w * texelFetch(colour, at, 0).rgb;\n"
    "        weight += w;\n"
    "    }\n"
    "    result = vec4(sum / weight, texelFetch(colour, p, 0).a);\n"
    "}\n";

static char text[40000], log_text[2000];
static float constants[400][4];
static ms_sss_kernel kernel[MS_SSS_SHADER_PROFILES_MAX];

static void stop(const char *what, const char *why)
{
    fprintf(stderr, "gpu_sss: %s: %s\n", what, why);
    exit(1);
}

/* Nanoseconds by the GPU's own clock; software: of this process on its processors, for its driver draws after the query's end. */
static double timed(void (*get)(GLuint, GLenum, uint64_t *), GLuint query, int software, const contender *c, GLuint program[2], const GLuint *texture,
                    const ms_sss_shader *shader, int width, int height)
{
    uint64_t ns = 0;
    double start;
    int step;
    gl_Finish();
    start = bench__clock(CLOCK_PROCESS_CPUTIME_ID);
    gl_BeginQuery(0x88BF /* GL_TIME_ELAPSED */, query);
    for (step = 0; step < (c->other == 2 ? 1 : 2); ++step) {
        const GLuint middle = texture[c->half ? MIDDLE_HALF : MIDDLE], to = step || c->other == 2 ? texture[TARGET] : middle;
        gl_UseProgram(program[step]);
        if (c->compute) {
            ms_sss_shader s = *shader;
            int gx, gy;
            s.step = step ? MS_SSS_STEP_Y : MS_SSS_STEP_X;
            gx = ms_sss_shader_group(&s, 0);
            gy = ms_sss_shader_group(&s, 1);
            gl_BindImageTexture(0, to, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
            gl_DispatchCompute((GLuint)((width + gx - 1) / gx), (GLuint)((height + gy - 1) / gy), 1);
            gl_MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
        } else {
            gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to, 0);
            gl_DrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    gl_EndQuery(0x88BF);
    gl_Finish();
    if (software) return 1e9 * (bench__clock(CLOCK_PROCESS_CPUTIME_ID) - start);
    get(query, 0x8866 /* GL_QUERY_RESULT: waits */, &ns);
    return (double)ns;
}

static bench_time measure(const contender *c, int width, int height, const GLuint *texture, int runs, int software)
{
    void (*get)(GLuint, GLenum, uint64_t *) = (void (*)(GLuint, GLenum, uint64_t *))eglGetProcAddress("glGetQueryObjectui64v");
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_shader s;
    ms_error error;
    GLuint program[2] = {0, 0}, query;
    double t[64];
    int i, step;
    o.fov_degrees = 40;
    o.flat = c->slopes ? 0.0f : 1.0f;
    memset(&s, 0, sizeof s);
    s.tap_count = 7;
    s.half_kernel = 1;
    s.profile_count = c->profiles;
    s.depth = MS_SSS_ALPHA;
    s.profile = c->profiles > 1 ? MS_SSS_ALPHA : MS_SSS_NONE;
    s.compute = c->compute;
    s.half_target = c->half && !c->compute;
    if (ms_sss_shader_constants(kernel, 0, &o, width, height, &s, constants, &error) != MS_OK) stop(c->name, error.message);
    for (step = 0; step < 2; ++step) {
        const float frame[4] = {(float)width, (float)height, (float)step, constants[0][2]};
        s.step = step ? MS_SSS_STEP_Y : MS_SSS_STEP_X;
        if (!ms_sss_shader_text(&s, &o, text, sizeof text, &error)) stop(c->name, error.message);
        program[step] = gl_program(c->compute ? NULL : gl_corner[0], c->other == 1 ? released : c->other ? disc : text, log_text, sizeof log_text);
        if (!program[step]) stop(c->name, log_text);
        gl_Uniform4fv(gl_GetUniformLocation(program[step], "ms_sss"), ms_sss_shader_constant_count(&s), constants[0]);
        gl_Uniform4fv(gl_GetUniformLocation(program[step], "frame"), 1, frame);
        if (c->other == 1) {
            static float taps[7][4];
            ms_sss_kernel_upload(kernel, 0, 0, 0, taps, NULL);
            gl_Uniform4fv(gl_GetUniformLocation(program[step], "taps"), 7, taps[0]);
        }
        gl_Uniform1i(gl_GetUniformLocation(program[step], "ms_sss_colour"), step ? (c->half ? MIDDLE_HALF : MIDDLE) : COLOUR);
        gl_Uniform1i(gl_GetUniformLocation(program[step], "ms_sss_input"), COLOUR);
        gl_Uniform1i(gl_GetUniformLocation(program[step], binding_name[COLOUR]), step ? MIDDLE_HALF : COLOUR);
        gl_Uniform1i(gl_GetUniformLocation(program[step], binding_name[DEPTH]), DEPTH);
    }
    gl_GenQueries(1, &query);
    timed(get, query, software, c, program, texture, &s, width, height); /* compiles and warms up */
    for (i = 0; i < runs; ++i) t[i] = 1e-6 * timed(get, query, software, c, program, texture, &s, width, height);
    gl_DeleteProgram(program[0]);
    gl_DeleteProgram(program[1]);
    return bench_summary(t, runs);
}

int main(int argc, char **argv)
{
    static const int size[2][2] = {{1920, 1080}, {3840, 2160}};
    const int full = argc > 1 && strcmp(argv[1], "--full") == 0, count = (int)(sizeof contenders / sizeof *contenders);
    const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
    bench_time result[2][16];
    const char *renderer;
    int software, sizes, i, k, x, y;
    ms_sss_profile *profile;
    if (!gl_open(GL_API_43)) {
        printf("no OpenGL 4.3 without a window on this machine\n");
        return 0;
    }
    renderer = (const char *)gl_GetString(GL_RENDERER);
    software = strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "SwiftShader");
    sizes = software && !full ? 1 : 2;
    if (ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL) != MS_OK ||
        ms_sss_kernel_make(&kernel[0], NULL, profile, 24, NULL, NULL, NULL) != MS_OK) stop("kernel", "not made");
    ms_sss_profile_destroy(profile);
    for (i = 1; i < MS_SSS_SHADER_PROFILES_MAX; ++i) kernel[i] = kernel[0];
    for (k = 0; k < sizes; ++k) {
        const int w = size[k][0], h = size[k][1];
        float *pixels = (float *)malloc((size_t)(w * h) * 4 * sizeof(float)), *depth = (float *)malloc((size_t)(w * h) * sizeof(float));
        GLuint texture[TEXTURES];
        if (!pixels || !depth) stop("memory", "none");
        for (y = 0; y < h; ++y) { /* bumps 300 mm away, strips of 8 materials: a kernel's radius is some 20 pixels at 1080p */
            for (x = 0; x < w; ++x) {
                float *p = pixels + 4 * (y * w + x);
                const double u = 20.0 * x / w, v = 20.0 * y / w;
                uint32_t bits;
                p[0] = (float)(0.5 + 0.5 * sin(3 * u) * cos(2 * v));
                p[1] = (float)(0.5 + 0.4 * sin(u + v));
                p[2] = 0.3f;
                p[3] = depth[y * w + x] = (float)(300 + 5 * sin(u) * sin(v));
                memcpy(&bits, &p[3], sizeof bits);
                bits = (bits & ~15u) | (uint32_t)(x * 8 / w);
                memcpy(&p[3], &bits, sizeof bits);
            }
        }
        texture[COLOUR] = gl_texture(COLOUR, GL_RGBA32F, w, h, pixels);
        texture[DEPTH] = gl_texture(DEPTH, GL_R32F, w, h, depth);
        texture[MIDDLE] = gl_texture(MIDDLE, GL_RGBA32F, w, h, NULL);
        texture[MIDDLE_HALF] = gl_texture(MIDDLE_HALF, GL_RGBA16F, w, h, NULL);
        texture[TARGET] = gl_texture(TARGET, GL_RGBA32F, w, h, NULL);
        gl_Viewport(0, 0, w, h);
        for (i = 0; i < count; ++i) {
            const GLint filter = contenders[i].other == 1 ? GL_LINEAR : GL_NEAREST;
            for (x = 0; x < 4; ++x) {
                gl_ActiveTexture((GLenum)(GL_TEXTURE0 + x));
                gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
                gl_TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
            }
            result[k][i] = measure(&contenders[i], w, h, texture, software ? 1 : 15, software);
        }
        gl_DeleteTextures(TEXTURES, texture);
        free(pixels);
        free(depth);
    }
    printf("%s%s\n\n", renderer, software ? " - a SOFTWARE driver, in ms of processor time: how much work there is, nothing of a GPU" : "");
    printf("| both passes | texels read | ms at 1080p | ms at 4K | x ours |\n|---|---:|---:|---:|---:|\n");
    for (i = 0; i < count; ++i) {
        printf("| %s | %s | %.3g +- %.2g | ", contenders[i].name, contenders[i].reads, result[0][i].median, result[0][i].spread);
        if (sizes > 1) printf("%.3g +- %.2g | ", result[1][i].median, result[1][i].spread);
        else printf("- | ");
        printf("%.2f |\n", result[0][i].median / result[0][0].median);
    }
    return 0;
}
