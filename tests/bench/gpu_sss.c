/* Milliseconds of the shaders of ms_sss.h on this machine's GPU, by timer queries: make bench-gpu. Beside them a shader
   with the structure of the released one (one filtered read of color and one of depth a tap, no masks) and a disc of
   64 samples, both without masks, slopes or elevation. A software driver is timed at 1080p only, once: --full for
   all. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "bench.h"
#include "egl.h"
#include "disc.h"
#include "sss_shader.h"

enum {
    COLOR,
    DEPTH,
    MIDDLE,
    MIDDLE_HALF,
    TARGET,
    SMALL,
    SMALL_MIDDLE,
    SMALL_TARGET,
    TOWER,
    TEXTURES = TOWER + 4 * MS_SSS_PYRAMID_LEVELS
};

enum { TAPS, RELEASED, DISC, HALF, PYRAMID, ONE_PASS }; /* what runs */

typedef struct contender {
    const char *name, *reads;
    int slopes, profiles, half, other; /* half: a target of 16 bits */
} contender;

/* One draw: a step of ms_sss.h of a level, its program, the textures it writes. */
typedef struct draw {
    ms_sss_step step;
    int level, to, other;
    GLuint program;
} draw;
enum { DRAWS = 2 * MS_SSS_PYRAMID_LEVELS };

static const contender contenders[] = {
    {"ours, 7 taps", "27", 0, 1, 0, 0},
    {"ours, 16 profiles", "27", 0, 16, 0, 0},
    {"**ours, slopes and elevation**", "35", 1, 1, 0, 0},
    {"ours, slopes, 16 profiles", "35", 1, 16, 0, 0},
    {"structure of the released shader, 7 taps", "28 filtered", 0, 1, 1, RELEASED},
    {"disc of 64 samples", "130", 0, 1, 0, DISC},
    {"**ours, disc of 20 in one pass**", "48", 1, 1, 0, ONE_PASS},
    {"ours, half resolution", "17", 0, 1, 0, HALF},
    {"**ours, half resolution, slopes and elevation**", "23", 1, 1, 0, HALF},
    {"ours, pyramid, flat", "68", 0, 1, 0, PYRAMID},
    {"**ours, pyramid, slopes and elevation**", "68 or more", 1, 1, 0, PYRAMID},
};

/* One pass: color and depth filtered at each tap, the tap's color fades to the pixel's own with the depth between. */
static const char *const released =
    "#version 330\n"
    "uniform sampler2D color, depth; uniform vec4 taps[7], frame; out vec4 result;\n"
    "void main() {\n"
    "    vec2 uv = gl_FragCoord.xy / frame.xy;\n"
    "    vec4 own = texture(color, uv);\n"
    "    float z = texture(depth, uv).r;\n"
    "    vec2 axis = (frame.z > 0.5 ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * frame.w / z / frame.xy;\n"
    "    vec3 sum = own.rgb * taps[0].rgb;\n"
    "    for (int i = 1; i < 7; ++i) {\n"
    "        vec2 at = uv + axis * taps[i].a;\n"
    "        vec3 c = texture(color, at).rgb;\n"
    "        sum += taps[i].rgb * mix(c, own.rgb, clamp(0.3 * abs(z - texture(depth, at).r), 0.0, 1.0));\n"
    "    }\n"
    "    result = vec4(sum, own.a);\n"
    "}\n";

/* 64 samples of a disc by the golden angle, radii by exp(-r / d), weighted by profile over density at the true
   distance. */
static const char *const disc =
    "#version 330\n"
    "uniform sampler2D color, depth; uniform vec4 taps[7], frame; out vec4 result;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    float z = texelFetch(depth, p, 0).r, scale = frame.w / z;\n"
    "    vec3 d = vec3(1.2, 0.5, 0.3), sum = vec3(0.0), weight = vec3(0.0);\n"
    "    for (int i = 0; i < 64; ++i) {\n"
    "        float u = (float(i) + 0.5) / 64.0, r = -3.0 * log(1.0 - 0.98 * u), angle = 2.39996 * float(i);\n"
    "        ivec2 at = clamp(p + ivec2(r * scale * vec2(cos(angle), sin(angle))), ivec2(0), ivec2(frame.xy) - 1);\n"
    "        float dz = texelFetch(depth, at, 0).r - z, s = sqrt(r * r + dz * dz) + 1e-3;\n"
    "        vec3 w = (exp(-s / d) + exp(-s / (3.0 * d))) / (s * d) * r * exp(r / 3.0);\n"
    "        sum += w * texelFetch(color, at, 0).rgb;\n"
    "        weight += w;\n"
    "    }\n"
    "    result = vec4(sum / weight, texelFetch(color, p, 0).a);\n"
    "}\n";

static char text[100000], log_text[2000];
static float constants[400][4];
static ms_sss_kernel kernel[MS_SSS_SHADER_PROFILES_MAX], rings;
static ms_sss_pyramid pyramid;

static void stop(const char *what, const char *why)
{
    fprintf(stderr, "gpu_sss: %s: %s\n", what, why);
    exit(1);
}

static int side_of(int side, int which)
{
    int i;
    for (i = which >= TOWER ? (which - (int)TOWER) / 4 : which >= SMALL; i > 0; --i) side = (side + 1) / 2;
    return side;
}

/* Nanoseconds by the GPU's own clock; software: of this process on its processors, for its driver draws after the
   query's end. */
static double timed(void (*get)(GLuint, GLenum, uint64_t *), GLuint query, int software, const draw *d, int draws,
                    const GLuint *texture, int width, int height)
{
    static const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    uint64_t ns = 0;
    double start;
    int i;
    gl_Finish();
    start = bench__clock(CLOCK_PROCESS_CPUTIME_ID);
    gl_BeginQuery(0x88BF /* GL_TIME_ELAPSED */, query);
    for (i = 0; i < draws; ++i, ++d) {
        const int w = side_of(width, d->to), h = side_of(height, d->to);
        gl_UseProgram(d->program);
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, d->other ? texture[d->other] : 0,
                                0);
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[d->to], 0);
        gl_DrawBuffers(d->other ? 2 : 1, both);
        gl_Viewport(0, 0, w, h);
        gl_DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_EndQuery(0x88BF);
    gl_Finish();
    if (software) return 1e9 * (bench__clock(CLOCK_PROCESS_CPUTIME_ID) - start);
    get(query, 0x8866 /* GL_QUERY_RESULT: waits */, &ns);
    return (double)ns;
}

/* The draws of a contender, in order; returns how many. */
static int plan(const contender *c, int levels, draw *d)
{
    const int middle = c->half ? MIDDLE_HALF : MIDDLE;
    int n = 0, l;
    memset(d, 0, DRAWS * sizeof *d);
    if (c->other == PYRAMID) {
        d[n].step = MS_SSS_STEP_BASE, d[n].to = TOWER, d[n++].other = TOWER + 1;
        for (l = 0; l + 1 < levels; ++l, ++n)
            d[n].step = MS_SSS_STEP_SHRINK, d[n].level = l, d[n].to = TOWER + 4 * l + 4, d[n].other = TOWER + 4 * l + 5;
        for (l = levels - 2; l > 0; --l, ++n)
            d[n].step = MS_SSS_STEP_GATHER, d[n].level = l, d[n].to = TOWER + 4 * l + 2, d[n].other = TOWER + 4 * l + 3;
        d[n].step = MS_SSS_STEP_RESOLVE, d[n++].to = TARGET;
        return n;
    }
    if (c->other == HALF) d[n].step = MS_SSS_STEP_DOWN, d[n++].to = SMALL;
    d[n].step = MS_SSS_STEP_X;
    d[n++].to = c->other == HALF ? SMALL_MIDDLE : c->other == DISC || c->other == ONE_PASS ? TARGET : middle;
    if (c->other != DISC && c->other != ONE_PASS)
        d[n].step = MS_SSS_STEP_Y, d[n++].to = c->other == HALF ? SMALL_TARGET : TARGET;
    if (c->other == HALF) d[n].step = MS_SSS_STEP_UP, d[n++].to = TARGET;
    return n;
}

/* The texture that a draw of ours reads by a name of ms_sss.h's list. */
static int read_by(const contender *c, const draw *d, int name)
{
    const int level = TOWER + 4 * d->level, next = d->level + 1 < MS_SSS_PYRAMID_LEVELS ? level + 4 : level;
    const int x = d->step == MS_SSS_STEP_X, y = d->step == MS_SSS_STEP_Y, half = c->other == HALF;
    switch (name) {
    case 0: return COLOR;
    case 3:
        return d->step > MS_SSS_STEP_BASE ? level
            : y                           ? half    ? SMALL_MIDDLE
                                          : c->half ? MIDDLE_HALF
                                                    : MIDDLE
            : x && half                   ? SMALL
                                          : COLOR;
    case 11: return SMALL;
    case 5: return half ? SMALL_TARGET : next + 2;
    case 7: return level + 1;
    case 8: return next;
    case 9: return next + 1;
    default: return next + 3;
    }
}

/* Depth, whose last four bits are the profile, in alpha. */
static const char *const in_alpha =
    "uniform sampler2D ms_sss_color;\n"
    "vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(ms_sss_color, p, 0).rgb; }\n"
    "float ms_sss_fetch_depth(ivec2 p) { return texelFetch(ms_sss_color, p, 0).a; }\n"
    "int ms_sss_fetch_profile(ivec2 p) { return floatBitsToInt(texelFetch(ms_sss_color, p, 0).a) & 15; }\n";

static bench_time measure(const contender *c, int width, int height, const GLuint *texture, int runs, int software)
{
    static const char *const name[12] = {"ms_sss_color",
                                         "",
                                         "",
                                         "ms_sss_input",
                                         "",
                                         "ms_sss_sum",
                                         "",
                                         "ms_sss_surface",
                                         "ms_sss_coarse",
                                         "ms_sss_coarse_surface",
                                         "ms_sss_weight",
                                         "ms_sss_half"};
    void (*get)(GLuint, GLenum,
                uint64_t *) = (void (*)(GLuint, GLenum, uint64_t *))eglGetProcAddress("glGetQueryObjectui64v");
    ms_sss_filter_options o = ms_sss_filter_defaults();
    ms_sss_shader s;
    sss_text about;
    ms_error error;
    ms_status status;
    draw d[DRAWS];
    GLuint query;
    double t[64];
    int i, k, count, n = plan(c, ms_sss_shader_levels(width, height), d);
    o.fov_degrees = 40;
    o.flat = c->slopes ? 0.0f : 1.0f;
    s = ms_sss_shader_defaults();
    s.profile_count = c->profiles > 1 ? c->profiles : 0;
    s.pyramids = &pyramid;
    memset(&about, 0, sizeof about);
    about.language = SSS_GLSL_330;
    about.flat = !c->slopes;
    about.fetch = in_alpha;
    s.half_resolution = c->other == HALF;
    for (i = 0; i < n; ++i) {
        float frame[4] = {(float)width, (float)height, (float)i, 0};
        s.step = d[i].step;
        s.level = d[i].level;
        s.tap_count = c->other == ONE_PASS ? rings.tap_count : 7;
        status = ms_sss_shader_constants(c->other == ONE_PASS ? &rings : kernel, 0, &o, width, height, &s, constants,
                                         &error);
        if (status != MS_OK) stop(c->name, error.message);
        count = ms_sss_shader_constant_count(&s);
        if (c->other == ONE_PASS) s.step = (ms_sss_step)SSS_DISC;
        if (!sss_shader_text(&s, &about, text, sizeof text)) stop(c->name, "no shader file");
        frame[3] = constants[1][2];
        d[i].program = gl_program(gl_corner[0],
                                  c->other == RELEASED   ? released
                                      : c->other == DISC ? disc
                                                         : text,
                                  log_text, sizeof log_text);
        if (!d[i].program) stop(c->name, log_text);
        gl_Uniform4fv(gl_GetUniformLocation(d[i].program, "ms_sss"), count, constants[0]);
        gl_Uniform4fv(gl_GetUniformLocation(d[i].program, "frame"), 1, frame);
        if (c->other == RELEASED) {
            static float taps[7][4];
            for (k = 0; k < 7; ++k) {
                memcpy(taps[k], kernel->weight[0][(k + 1) / 2], 3 * sizeof(float));
                taps[k][3] = (k % 2 ? -1.0f : 1.0f) * kernel->offset_mm[(k + 1) / 2];
            }
            gl_Uniform4fv(gl_GetUniformLocation(d[i].program, "taps"), 7, taps[0]);
        }
        for (k = 0; k < 12; ++k)
            if (name[k][0]) gl_Uniform1i(gl_GetUniformLocation(d[i].program, name[k]), read_by(c, &d[i], k));
        gl_Uniform1i(gl_GetUniformLocation(d[i].program, "color"), i ? MIDDLE_HALF : COLOR);
        gl_Uniform1i(gl_GetUniformLocation(d[i].program, "depth"), DEPTH);
    }
    gl_GenQueries(1, &query);
    timed(get, query, software, d, n, texture, width, height); /* compiles and warms up */
    for (i = 0; i < runs; ++i) t[i] = 1e-6 * timed(get, query, software, d, n, texture, width, height);
    for (i = 0; i < n; ++i) gl_DeleteProgram(d[i].program);
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
        ms_sss_kernel_make(&kernel[0], NULL, profile, 24, NULL, NULL, NULL) != MS_OK ||
        disc_kernel(&rings, profile, 20, 24, NULL) != MS_OK || ms_sss_pyramid_make(&pyramid, profile, NULL) != MS_OK)
        stop("kernel", "not made");
    ms_sss_profile_destroy(profile);
    for (i = 1; i < MS_SSS_SHADER_PROFILES_MAX; ++i) kernel[i] = kernel[0];
    for (k = 0; k < sizes; ++k) {
        const int w = size[k][0], h = size[k][1];
        float *pixels = (float *)malloc((size_t)(w * h) * 4 * sizeof(float)),
              *depth = (float *)malloc((size_t)(w * h) * sizeof(float));
        GLuint texture[TEXTURES] = {0};
        if (!pixels || !depth) stop("memory", "none");
        for (y = 0; y < h;
             ++y) { /* bumps 300 mm away, strips of 8 materials: a kernel's radius is some 20 pixels at 1080p */
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
        texture[COLOR] = gl_texture(COLOR, GL_RGBA32F, w, h, pixels);
        texture[DEPTH] = gl_texture(DEPTH, GL_R32F, w, h, depth);
        texture[MIDDLE] = gl_texture(MIDDLE, GL_RGBA32F, w, h, NULL);
        texture[MIDDLE_HALF] = gl_texture(MIDDLE_HALF, GL_RGBA16F, w, h, NULL);
        for (i = TARGET; i < TOWER + 4 * ms_sss_shader_levels(w, h); ++i)
            texture[i] = gl_texture(i, GL_RGBA32F, side_of(w, i), side_of(h, i), NULL);
        for (i = 0; i < count; ++i) {
            const GLint filter = contenders[i].other == RELEASED ? GL_LINEAR : GL_NEAREST;
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
    printf("%s%s\n\n", renderer,
           software ? " - a SOFTWARE driver, in ms of processor time: how much work there is, nothing of a GPU" : "");
    printf("| all passes | texels read | ms at 1080p | ms at 4K | x ours |\n|---|---:|---:|---:|---:|\n");
    for (i = 0; i < count; ++i) {
        printf("| %s | %s | %.3g +- %.2g | ", contenders[i].name, contenders[i].reads, result[0][i].median,
               result[0][i].spread);
        if (sizes > 1) printf("%.3g +- %.2g | ", result[1][i].median, result[1][i].spread);
        else printf("- | ");
        printf("%.2f |\n", result[0][i].median / result[0][0].median);
    }
    return 0;
}
