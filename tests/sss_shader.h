/* The shader files of examples/engine/shader as the tests and benches use them: what stands before them, and their
 * text.
 */
#ifndef SSS_SHADER_H
#define SSS_SHADER_H
#include "wgsl.h"

enum { SSS_GLSL_330, SSS_GLSL_ES_300, SSS_VULKAN, SSS_HLSL, SSS_WGSL };
enum { SSS_TRANSMISSION = 8, SSS_DISC = 9 }; /* steps that ms_sss_step has not */

/* What a text depends on beside ms_sss_shader. */
typedef struct sss_text {
    int language, flat, normal, strength, without_depth, rotated;
    const char *fetch; /* the engine's functions, in the language; NULL: of the textures ms_sss_color and so on */
} sss_text;

/* The functions that read these textures of one channel, or three; without depth all pixels lie at 1. */
static const char *sss_fetch_text(const sss_text *t)
{
    static char out[3000];
    static const struct {
        const char *name, *type, *part;
        int binding;
    } read[5] = {{"color", "float3", "rgb", 1},
                 {"depth", "float", "r", 2},
                 {"strength", "float", "r", 3},
                 {"profile", "int", "r", 5},
                 {"normal", "float3", "rgb", 7}};
    size_t n = 0;
    int i;
    out[0] = 0;
    for (i = 0; i < 5; ++i) {
        const char *const name = read[i].name, *const part = read[i].part;
        const int glsl = t->language <= SSS_VULKAN, vector = strcmp(read[i].type, "float3") == 0;
        const char *const type = t->language == SSS_WGSL ? (vector       ? "vec3<f32>"
                                                                : i == 3 ? "i32"
                                                                         : "f32")
            : glsl && vector                             ? "vec3"
                                                         : read[i].type;
        char texel[100];
        if ((i == 2 && !t->strength) || (i == 4 && !t->normal)) continue;
        if (i == 1 && t->without_depth) strcpy(texel, "1.0");
        else if (t->language == SSS_WGSL) {
            n += (size_t)snprintf(out + n, sizeof out - n, "@group(0) @binding(%d) var ms_sss_%s: texture_2d<f32>;\n",
                                  read[i].binding, name);
            snprintf(texel, sizeof texel, "textureLoad(ms_sss_%s, p, 0).%s", name, part);
        } else if (t->language == SSS_HLSL) {
            n += (size_t)snprintf(out + n, sizeof out - n, "Texture2D<float4> ms_sss_%s : register(t%d);\n", name,
                                  read[i].binding);
            snprintf(texel, sizeof texel, "ms_sss_%s.Load(int3(p, 0)).%s", name, part);
        } else {
            if (t->language == SSS_VULKAN)
                n += (size_t)snprintf(out + n, sizeof out - n, "layout(set = 0, binding = %d) ", read[i].binding);
            n += (size_t)snprintf(out + n, sizeof out - n, "uniform sampler2D ms_sss_%s;\n", name);
            snprintf(texel, sizeof texel, "texelFetch(ms_sss_%s, p, 0).%s", name, part);
        }
        if (t->language == SSS_WGSL)
            n += (size_t)snprintf(out + n, sizeof out - n, "fn ms_sss_fetch_%s(p: vec2<i32>) -> %s { return ", name,
                                  type);
        else
            n += (size_t)snprintf(out + n, sizeof out - n, "%s ms_sss_fetch_%s(%s p) { return ", type, name,
                                  glsl ? "ivec2" : "int2");
        n += i == 3 ? (size_t)snprintf(out + n, sizeof out - n, "%s(floor(%s * 255.0 + 0.5)); }\n", type, texel)
                    : (size_t)snprintf(out + n, sizeof out - n, "%s; }\n", texel);
    }
    return out;
}

/* The text of a step into out; 0: it does not fit, or a file is not there (from the repository's root). */
static int sss_shader_text(const ms_sss_shader *s, const sss_text *t, char *out, size_t capacity)
{
    static char *file[3];
    static const char *const path[3] = {"examples/engine/shader/ms_sss.glsl",
                                        "examples/engine/shader/ms_sss_pyramid.glsl",
                                        "examples/engine/shader/ms_sss_disc.glsl"};
    char defines[600];
    const char *fetch = t->fetch ? t->fetch : sss_fetch_text(t);
    static const char *const head[4] = {
        "#version 330\n", "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n",
        "#version 450\n#define MS_SSS_VULKAN\n", "#define MS_SSS_HLSL\n"};
    const int more = (int)s->step == SSS_DISC ? 2 : (int)s->step > 3 && (int)s->step < 8 ? 1 : 0;
    int i;
    for (i = 0; i < 3 && !file[i]; ++i) {
        FILE *f = fopen(path[i], "rb");
        file[i] = (char *)calloc(1, 1 << 16);
        if (!f || !file[i] || fread(file[i], 1, (1 << 16) - 1, f) == 0) return 0;
        fclose(f);
    }
    snprintf(
        defines, sizeof defines,
        "#define MS_SSS_STEP %d\n#define MS_SSS_TAPS %d\n#define MS_SSS_PROFILES %d\n#define MS_SSS_TERMS %d\n"
        "#define MS_SSS_SLOPES %d\n#define MS_SSS_STRENGTH %d\n#define MS_SSS_ROTATED %d\n#define MS_SSS_HALF %d\n",
        (int)s->step, s->tap_count, s->profile_count, s->term_count > 1 ? s->term_count : 1,
        t->flat ? 0 : 1 + t->normal, t->strength, t->rotated, s->half_resolution);
    if (t->language == SSS_WGSL) {
        size_t n;
        if (wgsl_make(defines, file[0], more ? file[more] : NULL, out, capacity)) return 0;
        n = strlen(out);
        if (n + strlen(fetch) >= capacity) return 0;
        strcpy(out + n, fetch);
        return 1;
    }
    return snprintf(out, capacity, "%s%s%s%s%s", head[t->language], defines, fetch, file[0], more ? file[more] : "") <
        (int)capacity;
}

#endif
