/* A network of dense layers as fragment shaders: GLSL, HLSL or WGSL text over the public calls of ms_nn.h, which comes
   first. examples/engine/previews.c draws a gallery with it.

     nn_shader s;
     nn_shader_sizes sizes;
     memset(&s, 0, sizeof s);                                    two steps, GLSL 330
     s.width = s.height = 64;                                    the last step draws pictures
     nn_shader_layout(nn, &s, &sizes, &error);                   sizes of the textures
     nn_shader_weights(nn, MS_NN_F16, weights, &error);          the texture of weights
     nn_shader_text(nn, &s, text, sizeof text, &error);          the text of step s.step
     nn_shader_inputs(nn, count, x, inputs);                     the texture of inputs, the only one that changes

   A step is one draw of a full-screen triangle. The network may have dense layers and after the first one activations
   and added skips, and shared_channels. Its dense layers are cut into steps: the last `steps` - 1 are steps of their
   own, those before are the first step, which keeps their values in registers. A gallery is two steps: features of all
   pictures, then all pixels. Wide layers run faster in a step each. */
#ifndef EXAMPLES_NN_SHADER_H
#define EXAMPLES_NN_SHADER_H
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    NN_SHADER_WIDTH = 2048,     /* texels of a row of the weights' texture */
    NN_SHADER_ROWS_MAX = 16384, /* rows that it may have: 134 million weights */
    NN_SHADER_OPS_MAX = 64      /* layers that compute something */
};

/* Metal: translate the Vulkan text (glslangValidator -V, spirv-cross --msl). */
typedef enum nn_language {
    NN_GLSL_330 = 0,    /* desktop OpenGL 3.3; constants: uniform vec4 ms_nn */
    NN_GLSL_ES_300 = 1, /* OpenGL ES 3.0, WebGL 2; the same. Targets of floats need EXT_color_buffer_float */
    NN_GLSL_VULKAN = 2, /* GLSL 450 for SPIR-V; set 0; constants: uniform block, binding 0 */
    NN_HLSL = 3,        /* shader model 4 and later; constants: cbuffer b0 */
    NN_WGSL = 4         /* WebGPU; group 0; constants: uniform buffer, binding 0 */
} nn_language;

/* All zero but step: steps 2, GLSL 330, values out. */
typedef struct nn_shader {
    int step;          /* 0 to steps - 1 */
    int steps;         /* 1 to the number of dense layers; 0: 2, or 1 where there is one layer only */
    int width, height; /* of a picture, if the last step draws pictures; 0: it writes values as the others do */
    nn_language language;
} nn_shader;

/* Sizes of the textures, all RGBA and read by texel (OpenGL: GL_NEAREST for both filters):
     ms_nn_weights  HLSL t0, Vulkan and WGSL binding 1: NN_SHADER_WIDTH x weight_rows, 16 or 32 bits
     ms_nn_values   HLSL t1, Vulkan and WGSL binding 2: input_width x rows a picture, 32-bit floats: the output of
                    nn_shader_inputs for the first step, the target of the step before for the others
   Without width and height the target is target_width x rows a picture, 32-bit floats: four values a texel, row
   r x rows + c is channel c of picture r. With them it is a sheet of pictures: the outputs are one to four planes of
   width x height, gray, two channels, RGB or RGBA. The step then has the constants
     ms_nn  {pictures in a row of the sheet, pictures, flip, 0}; flip 0: row 0 of the sheet is row 0 of the target,
   which OpenGL shows at the bottom; the height of the target: it is the last row.
   Values agree with ms_nn_forward within some 1e-6 of the largest; 16-bit weights are rounded by up to 2^-12. */
typedef struct nn_shader_sizes {
    int steps, rows, input_width, target_width, weight_rows;
} nn_shader_sizes;

/* --- the network as the shaders see it --- */

/* Operation k reads value k and makes value k + 1; value 0 is the input of a channel. */
typedef struct nn_shader__op {
    int dense, add, skip; /* skip: the value that add adds */
    int activation;       /* index in nn_shader__activation */
    float alpha;
    int layer;   /* in the file's list */
    size_t size; /* of value k + 1 */
    const ms_nn_tensor *weight, *bias, *scale;
} nn_shader__op;

typedef struct nn_shader__net {
    nn_shader__op op[NN_SHADER_OPS_MAX];
    int ops, dense;
    size_t inputs, channels; /* inputs of a channel */
} nn_shader__net;

/* What a step is: operations [first, end), and where its weights begin. */
typedef struct nn_shader__step {
    nn_shader_sizes sizes;
    int first, end;
    int planes; /* of a picture and channel; 0: values */
    size_t base;
} nn_shader__step;

static inline ms_status nn_shader__fail(ms_error *error, ms_status status, const char *format, ...)
{
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = 0;
    va_start(list, format);
    vsnprintf(error->message, sizeof error->message, format, list);
    va_end(list);
    return status;
}

/* x becomes its activation; z is |x|, so that (x + z) / 2 is its positive part in every language. $a: alpha. The normal
   distribution: Abramowitz and Stegun 7.1.26, within 1.5e-7. */
enum { NN_SHADER__LINEAR = 0, NN_SHADER__GELU = 8, NN_SHADER__ACTIVATIONS = 9 };
static const char *const nn_shader__activation[NN_SHADER__ACTIVATIONS][2] = {
    {"linear", ""},
    {"relu", "0.5 * (x + z)"},
    {"leaky_relu", "0.5 * (x + z) + $a * 0.5 * (x - z)"},
    {"elu", "0.5 * (x + z) + $a * (exp(0.5 * (x - z)) - 1.0)"},
    {"tanh", "sign(x) * (1.0 - exp(-2.0 * z)) / (1.0 + exp(-2.0 * z))"},
    {"sigmoid", "0.5 + 0.5 * sign(x) * (1.0 - exp(-z)) / (1.0 + exp(-z))"},
    {"softplus", "0.5 * (x + z) + log(1.0 + exp(-z))"},
    {"silu", "x * (0.5 + 0.5 * sign(x) * (1.0 - exp(-z)) / (1.0 + exp(-z)))"},
    {"gelu",
     "0.5 * (x + z) - z * exp(-0.5 * z * z) * t * "
     "(0.127414796 + t * (-0.142248368 + t * (0.7107068705 + t * (-0.7265760135 + t * 0.5307027145))))"}};

/* Texels of n values, and of a dense layer: its weights, then its biases. */
static inline size_t nn_shader__vec4_count(size_t n) { return n / 4 + (n % 4 != 0); }
static inline size_t nn_shader__texels(const nn_shader__op *op)
{
    const size_t rows = op->weight->shape[0], cols = op->weight->shape[1];
    return nn_shader__vec4_count(rows) * (4 * nn_shader__vec4_count(cols) + 1);
}

/* Values of a channel, and of value v. */
static inline size_t nn_shader__value_size(const nn_shader__net *n, int v) { return v ? n->op[v - 1].size : n->inputs; }

/* Tensor <layer>.<part> of the network, or NULL. */
static inline const ms_nn_tensor *nn_shader__tensor(const ms_nn *nn, const char *layer, const char *part)
{
    char name[MS_NN_MAX_NAME + 20];
    snprintf(name, sizeof name, "%s.%s", layer, part);
    return ms_nn_file_find(ms_nn_tensors(nn), name);
}

/* The value that the layer before layer l with this name makes; "input": 0. */
static inline int nn_shader__value_of(const ms_nn *nn, const int *value, int l, const char *name)
{
    while (l-- > 0)
        if (strcmp(ms_nn_layer_at(nn, l).name, name) == 0 && *name) return value[l];
    return 0;
}

/* The operations of a network; refused by the name of a layer that has no shader. */
static inline ms_status nn_shader__read(const ms_nn *nn, nn_shader__net *n, ms_error *error)
{
    int value[MS_NN_MAX_LAYERS], l;
    memset(n, 0, sizeof *n);
    if (nn == NULL) return nn_shader__fail(error, MS_INVALID_ARGUMENT, "nn is NULL");
    ms_nn_channel_inputs(nn, &n->channels, &n->inputs);
    for (l = 0; l < ms_nn_layer_count(nn); ++l) {
        const ms_nn_layer layer = ms_nn_layer_at(nn, l);
        nn_shader__op *op = &n->op[n->ops];
        const int flat = layer.output.rank == 1 && ms_nn_layer_at(nn, l > 0 ? l - 1 : 0).output.rank == 1;
        int known;
        value[l] = n->ops;
        if (strcmp(layer.type, "dropout") == 0 || strcmp(layer.type, "shared_channels") == 0) continue;
        if (n->ops == NN_SHADER_OPS_MAX)
            return nn_shader__fail(error, MS_UNSUPPORTED, "more than %d layers", (int)NN_SHADER_OPS_MAX);
        memset(op, 0, sizeof *op);
        op->layer = l;
        op->size = layer.output.size[0];
        op->alpha = layer.alpha;
        while (strcmp(nn_shader__activation[op->activation][0], *layer.activation ? layer.activation : "linear") != 0)
            ++op->activation;
        op->dense = strcmp(layer.type, "dense") == 0;
        op->add = strcmp(layer.type, "add") == 0;
        known = op->dense || op->add || strcmp(layer.type, "activation") == 0;
        if (!known || !flat || (n->dense == 0 && !op->dense))
            return nn_shader__fail(error, MS_UNSUPPORTED,
                                   "layer %d, %s '%.100s', has no shader: only dense layers and, after them, "
                                   "activations and additions have",
                                   l, layer.type, layer.name);
        if (op->dense) {
            ++n->dense;
            op->weight = nn_shader__tensor(nn, layer.name, "weight");
            op->bias = nn_shader__tensor(nn, layer.name, "bias");
            op->scale = nn_shader__tensor(nn, layer.name, "weight_scale");
        }
        if (op->add) op->skip = nn_shader__value_of(nn, value, l, layer.from);
        value[l] = ++n->ops;
    }
    if (n->dense == 0) return nn_shader__fail(error, MS_UNSUPPORTED, "the network has no dense layer");
    return MS_OK;
}

/* s NULL: sizes of the whole network only. */
static inline ms_status nn_shader__plan(const nn_shader__net *n, const nn_shader *s, nn_shader__step *p,
                                        ms_error *error)
{
    int k, seen = 0, last;
    size_t texels = 0, pixels, outputs;
    memset(p, 0, sizeof *p);
    for (k = 0; k < n->ops; ++k)
        if (n->op[k].dense && texels <= (size_t)NN_SHADER_WIDTH * NN_SHADER_ROWS_MAX)
            texels += nn_shader__texels(&n->op[k]);
    if (texels >= (size_t)NN_SHADER_WIDTH * NN_SHADER_ROWS_MAX || n->channels > NN_SHADER_ROWS_MAX ||
        n->inputs > INT_MAX / 4)
        return nn_shader__fail(error, MS_UNSUPPORTED, "the network is too large for a texture");
    p->sizes.weight_rows = (int)(texels / NN_SHADER_WIDTH + 1);
    p->sizes.rows = (int)n->channels;
    p->sizes.input_width = (int)nn_shader__vec4_count(n->inputs);
    p->sizes.steps = s && s->steps ? s->steps : n->dense > 1 ? 2 : 1;
    if (s == NULL) return MS_OK;
    if ((int)s->language < 0 || (int)s->language > (int)NN_WGSL)
        return nn_shader__fail(error, MS_INVALID_ARGUMENT, "language %d is unknown", (int)s->language);
    if (p->sizes.steps < 1 || p->sizes.steps > n->dense || s->step < 0 || s->step >= p->sizes.steps)
        return nn_shader__fail(error, MS_INVALID_ARGUMENT, "step %d of %d: the network has %d dense layers", s->step,
                               p->sizes.steps, n->dense);
    last = n->dense - p->sizes.steps + s->step; /* the dense layer that the step ends with */
    for (k = 0; k < n->ops && seen <= last + 1; ++k) {
        seen += n->op[k].dense;
        if (s->step > 0 && seen <= last) p->first = k + 1;
        if (s->step > 0 && seen <= last && n->op[k].dense) p->base += nn_shader__texels(&n->op[k]);
        if (seen <= last + 1) p->end = k + 1;
    }
    for (k = p->first; k < p->end; ++k)
        if (n->op[k].add && n->op[k].skip < p->first)
            return nn_shader__fail(error, MS_UNSUPPORTED,
                                   "layer %d adds what a step before this one made: %d steps are too many",
                                   n->op[k].layer, p->sizes.steps);
    p->sizes.input_width = (int)nn_shader__vec4_count(nn_shader__value_size(n, p->first));
    outputs = nn_shader__value_size(n, p->end);
    p->sizes.target_width = (int)nn_shader__vec4_count(outputs);
    if (s->step < p->sizes.steps - 1 || (s->width == 0 && s->height == 0)) return MS_OK;
    /* pictures */
    pixels = s->width > 0 && s->height > 0 && s->width < INT_MAX / s->height ? (size_t)s->width * (size_t)s->height : 0;
    if (pixels == 0 || outputs % pixels || outputs / pixels * n->channels > 4)
        return nn_shader__fail(error, MS_INVALID_ARGUMENT,
                               "%d x %d pixels: %.0f outputs are not one to four such planes", s->width, s->height,
                               (double)outputs * (double)n->channels);
    if (p->sizes.steps == 1 && n->dense > 1)
        return nn_shader__fail(error, MS_UNSUPPORTED, "pictures of %d dense layers need two steps", n->dense);
    for (k = p->first; k < p->end; ++k)
        if (n->op[k].add)
            return nn_shader__fail(error, MS_UNSUPPORTED,
                                   "layer %d, an addition, stands after the last dense layer: pictures have none",
                                   n->op[k].layer);
    p->planes = (int)(outputs / pixels);
    p->sizes.target_width = s->width;
    return MS_OK;
}

/* --- text: counted first, then written --- */

typedef struct nn_shader__writer {
    char *out; /* NULL while counting */
    size_t length;
    nn_language language;
} nn_shader__writer;

static inline void nn_shader__put(nn_shader__writer *t, const char *text)
{
    const size_t n = strlen(text);
    if (t->out) memcpy(t->out + t->length, text, n);
    t->length += n;
}

/* A number >= 0 as 9 digits and an exponent of ten, which every language and locale reads. */
static inline void nn_shader__put_float(nn_shader__writer *t, float value)
{
    char text[32];
    double digits = (double)value;
    int exponent = 0;
    for (; digits >= 1e9; ++exponent) digits /= 10;
    for (; digits > 0 && digits < 1e8; --exponent) digits *= 10;
    snprintf(text, sizeof text, "%.0fe%d", digits, exponent);
    nn_shader__put(t, text);
}

/* Appends format: $d is the next argument, an int, $a the next one, a double >= 0; $v and $i begin a declaration of
   four floats or an integer, $4 makes four floats, $I an integer, $L is what HLSL wants before a loop. */
static inline void nn_shader__emit(nn_shader__writer *t, const char *format, ...)
{
    static const char key[] = "vi4IL",
                      word[3][5][11] = {{"vec4 ", "int ", "vec4", "int", ""},
                                        {"float4 ", "int ", "float4", "int", "[loop] "},
                                        {"var ", "var ", "vec4<f32>", "i32", ""}};
    va_list list;
    va_start(list, format);
    for (; *format; ++format) {
        char text[16] = {*format, 0};
        if (*format != '$') {
            nn_shader__put(t, text);
        } else if (*++format == 'd') {
            snprintf(text, sizeof text, "%d", va_arg(list, int));
            nn_shader__put(t, text);
        } else if (*format == 'a') {
            nn_shader__put_float(t, (float)va_arg(list, double));
        } else {
            nn_shader__put(t, word[t->language < NN_HLSL ? 0 : (int)t->language - 2][strchr(key, *format) - key]);
        }
    }
    va_end(list);
}

/* What stands before main: a language's first lines and its names for what is read; then for GLSL, HLSL and WGSL
   how. */
static const char *const nn_shader__names[5][2] = {
    {"#version 330\nuniform sampler2D ms_nn_weights, ms_nn_values;\n", "uniform vec4 ms_nn;\n"},
    {"#version 300 es\nprecision highp float;\nprecision highp int;\n"
     "uniform highp sampler2D ms_nn_weights, ms_nn_values;\n",
     "uniform vec4 ms_nn;\n"},
    {"#version 450\nlayout(set = 0, binding = 1) uniform sampler2D ms_nn_weights;\n"
     "layout(set = 0, binding = 2) uniform sampler2D ms_nn_values;\n",
     "layout(set = 0, binding = 0) uniform ms_nn_block { vec4 ms_nn; };\n"},
    {"Texture2D<float4> ms_nn_weights : register(t0), ms_nn_values : register(t1);\n",
     "cbuffer ms_nn_block : register(b0) { float4 ms_nn; };\n"},
    {"@group(0) @binding(1) var ms_nn_weights: texture_2d<f32>;\n"
     "@group(0) @binding(2) var ms_nn_values: texture_2d<f32>;\n",
     "@group(0) @binding(0) var<uniform> ms_nn: vec4<f32>;\n"}};
static const char *const nn_shader__main[3] = {
    "vec4 weight(int i) { return texelFetch(ms_nn_weights, ivec2(i & 2047, i >> 11), 0); }\n"
    "vec4 value(int i, int row) { return texelFetch(ms_nn_values, ivec2(i, row), 0); }\n"
    "layout(location = 0) out vec4 ms_nn_target;\nvec4 shade(vec4 position);\n"
    "void main() { ms_nn_target = shade(gl_FragCoord); }\nvec4 shade(vec4 position)\n{\n",
    "float4 weight(int i) { return ms_nn_weights.Load(int3(i & 2047, i >> 11, 0)); }\n"
    "float4 value(int i, int row) { return ms_nn_values.Load(int3(i, row, 0)); }\n"
    "float4 main(float4 position : SV_Position) : SV_Target\n{\n",
    "fn weight(i: i32) -> vec4<f32> { return textureLoad(ms_nn_weights, vec2<i32>(i & 2047, i >> 11u), 0); }\n"
    "fn value(i: i32, row: i32) -> vec4<f32> { return textureLoad(ms_nn_values, vec2<i32>(i, row), 0); }\n"
    "@fragment\nfn main(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32>\n{\n"};

static inline void nn_shader__emit_activation(nn_shader__writer *t, const nn_shader__op *op)
{
    if (op->activation == NN_SHADER__LINEAR) return;
    nn_shader__emit(t, "{ $v z = abs(x); ");
    if (op->activation == NN_SHADER__GELU) nn_shader__emit(t, "$v t = 1.0 / (1.0 + 0.2316418882 * z); ");
    nn_shader__emit(t, "x = ");
    nn_shader__emit(t, nn_shader__activation[op->activation][1], (double)op->alpha);
    nn_shader__emit(t, "; }\n");
}

/* Operations [k, end): a dense layer and what follows it, of the four outputs u. The layer reads the step's first value
   (k == first) or value k. base: where its weights begin. inner: the values are kept for all u. */
static inline void nn_shader__emit_dense(nn_shader__writer *t, const nn_shader__net *n, int first, int k, int end,
                                         int base, int inner)
{
    const ms_nn_tensor *w = n->op[k].weight;
    const int rows = (int)nn_shader__vec4_count(w->shape[0]), cols = (int)nn_shader__vec4_count(w->shape[1]), start = k;
    nn_shader__emit(t, "$v x = weight(u + $d);\n$Lfor ($i j = 0; j < $d; j++) {\n", base + 4 * rows * cols, cols);
    if (k == first) nn_shader__emit(t, "$v a = value(j, row);\n");
    else nn_shader__emit(t, "$v a = v$d[j];\n", k);
    nn_shader__emit(
        t,
        "$i i = (u * $d + j) * 4 + $d;\n"
        "x = x + $4(dot(weight(i), a), dot(weight(i + 1), a), dot(weight(i + 2), a), dot(weight(i + 3), a));\n}\n",
        cols, base);
    for (; k < end; ++k) {
        const nn_shader__op *op = &n->op[k];
        if (op->add && op->skip == first) nn_shader__emit(t, "x = x + value(u, row);\n");
        else if (op->add)
            nn_shader__emit(t, inner || op->skip <= start ? "x = x + v$d[u];\n" : "x = x + v$d;\n", op->skip);
        nn_shader__emit_activation(t, op);
        nn_shader__emit(t, inner ? "v$d[u] = x;\n" : "$v v$d = x;\n", k + 1);
    }
}

/* The channels of a pixel. row: of the first; pixel: in its plane. */
static inline void nn_shader__emit_pixel(nn_shader__writer *t, const nn_shader__net *n, const nn_shader__step *p,
                                         const nn_shader *s)
{
    const ms_nn_tensor *w = n->op[p->first].weight;
    const int cols = (int)nn_shader__vec4_count(w->shape[1]), base = (int)p->base, channels = (int)n->channels,
              biases = base + 4 * (int)nn_shader__vec4_count(w->shape[0]) * cols, outputs = p->planes * channels;
    int plane, c, k;
    nn_shader__emit(t,
                    "$i left = $I(position.x);\n$i top = $I(position.y);\n"
                    "if (ms_nn.z > 0.0) { top = $I(ms_nn.z) - 1 - top; }\n");
    nn_shader__emit(t, "$i column = left / $d;\n$i across = top / $d;\n", s->width, s->height);
    nn_shader__emit(t,
                    "$i picture = across * $I(ms_nn.x) + column;\n"
                    "if (column >= $I(ms_nn.x) || picture >= $I(ms_nn.y)) { return $4(0.0, 0.0, 0.0, 0.0); }\n");
    nn_shader__emit(t, "$i row = picture * $d;\n$i pixel = (top - across * $d) * $d + left - column * $d;\n", channels,
                    s->height, s->width, s->width);
    nn_shader__emit(t, "$v x = $4(0.0, 0.0, 0.0, 0.0);\n");
    for (plane = 0; plane < p->planes; ++plane) {
        nn_shader__emit(t, "$i u$d = pixel + $d;\n", plane, plane * s->width * s->height);
        nn_shader__emit(t, "$v b$d = weight((u$d >> 2) + $d);\n", plane, plane, biases);
        for (c = 0; c < channels; ++c)
            nn_shader__emit(t, "x[$d] = b$d[u$d & 3];\n", c * p->planes + plane, plane, plane);
    }
    nn_shader__emit(t, "$Lfor ($i j = 0; j < $d; j++) {\n", cols);
    for (c = 0; c < channels; ++c) nn_shader__emit(t, "$v a$d = value(j, row + $d);\n", c, c);
    for (plane = 0; plane < p->planes; ++plane) {
        nn_shader__emit(t, "$v w$d = weight(((u$d >> 2) * $d + j) * 4 + (u$d & 3) + $d);\n", plane, plane, cols, plane,
                        base);
        for (c = 0; c < channels; ++c)
            nn_shader__emit(t, "x[$d] = x[$d] + dot(w$d, a$d);\n", c * p->planes + plane, c * p->planes + plane, plane,
                            c);
    }
    nn_shader__emit(t, "}\n");
    for (k = p->first; k < p->end; ++k) nn_shader__emit_activation(t, &n->op[k]);
    nn_shader__emit(t, outputs == 1 ? "x[1] = x[0];\nx[2] = x[0];\n" : outputs == 2 ? "x[2] = 0.0;\n" : "");
    nn_shader__emit(t, outputs < 4 ? "x[3] = 1.0;\nreturn x;\n}\n" : "return x;\n}\n");
}

static inline void nn_shader__emit_step(nn_shader__writer *t, const nn_shader__net *n, const nn_shader__step *p,
                                        const nn_shader *s)
{
    size_t base = p->base;
    int k, end, v;
    nn_shader__emit(t, nn_shader__names[s->language][0]);
    if (p->planes) nn_shader__emit(t, nn_shader__names[s->language][1]);
    nn_shader__emit(t, nn_shader__main[s->language < NN_HLSL ? 0 : (int)s->language - 2]);
    if (p->planes) {
        nn_shader__emit_pixel(t, n, p, s);
        return;
    }
    nn_shader__emit(t, "$i row = $I(position.y);\n");
    for (k = p->first; k < p->end; k = end) { /* a dense layer and what follows it */
        for (end = k + 1; end < p->end && !n->op[end].dense;) ++end;
        if (end < p->end) {
            for (v = k + 1; v <= end; ++v)
                nn_shader__emit(t, t->language == NN_WGSL ? "var v$d: array<vec4<f32>, $d>;\n" : "$4 v$d[$d];\n", v,
                                (int)nn_shader__vec4_count(nn_shader__value_size(n, v)));
            nn_shader__emit(t, "$Lfor ($i u = 0; u < $d; u++) {\n",
                            (int)nn_shader__vec4_count(n->op[k].weight->shape[0]));
        } else {
            nn_shader__emit(t, "$i u = $I(position.x);\n");
        }
        nn_shader__emit_dense(t, n, p->first, k, end, (int)base, end < p->end);
        nn_shader__emit(t, end < p->end ? "}\n" : "return x;\n}\n");
        base += nn_shader__texels(&n->op[k]);
    }
}

/* --- calls --- */

/* MS_UNSUPPORTED, naming the layer: convolutions, resizing, pooling, flattening; an addition whose other value an
   earlier step made; a network without dense layers, or too large. MS_INVALID_ARGUMENT: step, steps, language; width x
   height does not divide the outputs into one to four planes. */
static inline ms_status nn_shader_layout(const ms_nn *nn, const nn_shader *shader, nn_shader_sizes *sizes,
                                         ms_error *error)
{
    nn_shader__net n;
    nn_shader__step p;
    ms_status status;
    if (shader == NULL || sizes == NULL) return nn_shader__fail(error, MS_INVALID_ARGUMENT, "shader or sizes is NULL");
    if ((status = nn_shader__read(nn, &n, error)) != MS_OK) return status;
    if ((status = nn_shader__plan(&n, shader, &p, error)) == MS_OK) *sizes = p.sizes;
    return status;
}

/* The text of a step, with entry point main.
   text    at least the returned length + 1 chars, or NULL with capacity 0 to ask; untouched where it does not fit
   Returns the length; 0 with error filled as by nn_shader_layout. */
static inline size_t nn_shader_text(const ms_nn *nn, const nn_shader *shader, char *text, size_t capacity,
                                    ms_error *error)
{
    nn_shader__net n;
    nn_shader__step p;
    nn_shader__writer t;
    if (shader == NULL) nn_shader__fail(error, MS_INVALID_ARGUMENT, "shader is NULL");
    if (shader == NULL || nn_shader__read(nn, &n, error) != MS_OK || nn_shader__plan(&n, shader, &p, error) != MS_OK)
        return 0;
    memset(&t, 0, sizeof t);
    t.language = shader->language;
    nn_shader__emit_step(&t, &n, &p, shader);
    if (text && capacity > t.length) {
        t.out = text;
        t.length = 0;
        nn_shader__emit_step(&t, &n, &p, shader);
        text[t.length] = 0;
    }
    return t.length;
}

/* IEEE binary16 of a number of at most 65504, to nearest even. */
static inline uint16_t nn_shader__half(float value)
{
    const double size = fabs((double)value);
    const uint16_t sign = value < 0 ? 0x8000u : 0;
    int exponent;
    if (size < 6.103515625e-05) return (uint16_t)(sign | (unsigned)rint(size * 16777216.0)); /* steps of 2^-24 */
    frexp(size, &exponent); /* 2^(exponent - 1) <= size */
    return (uint16_t)(sign | (unsigned)(rint(ldexp(size, 11 - exponent)) + (exponent + 13) * 1024.0));
}

/* The weights' texture: for each dense layer, tiles of 4 outputs x 4 inputs (a texel holds 4 inputs of an output; zeros
   beyond the ends), inputs fastest; then its biases, 4 a texel. I8 weights are multiplied by their scales.
   dtype   MS_NN_F16 or MS_NN_F32, in the host's order of bytes
   out     [weight_rows][NN_SHADER_WIDTH][4] elements
   MS_UNSUPPORTED as above, and a weight over 65504 in F16; then nothing is written. */
static inline ms_status nn_shader_weights(const ms_nn *nn, ms_nn_dtype dtype, void *out, ms_error *error)
{
    const size_t size = dtype == MS_NN_F16 ? 2 : 4;
    unsigned char *to = (unsigned char *)out;
    nn_shader__net n;
    nn_shader__step p;
    ms_status status = nn_shader__read(nn, &n, error);
    int k, pass;
    if (status == MS_OK) status = nn_shader__plan(&n, NULL, &p, error);
    if (status != MS_OK) return status;
    if (out == NULL || (dtype != MS_NN_F16 && dtype != MS_NN_F32))
        return nn_shader__fail(error, MS_INVALID_ARGUMENT, "out is NULL, or dtype is neither F16 nor F32");
    for (pass = 0; pass < 2; ++pass) { /* checks, then writes */
        if (pass) memset(out, 0, (size_t)p.sizes.weight_rows * NN_SHADER_WIDTH * 4 * size);
        for (k = 0; k < n.ops; ++k) {
            const nn_shader__op *op = &n.op[k];
            size_t rows, cols, tiles, r, c;
            if (!op->dense) continue;
            rows = op->weight->shape[0];
            cols = op->weight->shape[1];
            tiles = nn_shader__vec4_count(cols);
            for (r = 0; r < rows; ++r) {
                float scale = 1;
                if (op->scale) ms_nn_tensor_read(op->scale, r, 1, &scale);
                for (c = 0; c <= cols; ++c) { /* after the last column the bias */
                    float v = 0;
                    size_t at;
                    if (c < cols) ms_nn_tensor_read(op->weight, r * cols + c, 1, &v);
                    else if (op->bias) ms_nn_tensor_read(op->bias, r, 1, &v);
                    if (c < cols) v *= scale;
                    if (size == 2 && !(fabsf(v) <= 65504.0f))
                        return nn_shader__fail(error, MS_UNSUPPORTED, "a weight of '%.100s' is %g, more than F16 holds",
                                               ms_nn_layer_at(nn, op->layer).name, (double)v);
                    if (!pass) continue;
                    at = c < cols ? (r / 4 * tiles + c / 4) * 16 + r % 4 * 4 + c % 4
                                  : nn_shader__vec4_count(rows) * tiles * 16 + r;
                    if (size == 2) {
                        const uint16_t half = nn_shader__half(v);
                        memcpy(to + 2 * at, &half, 2);
                    } else {
                        memcpy(to + 4 * at, &v, 4);
                    }
                }
            }
            if (pass) to += nn_shader__texels(op) * 4 * size;
        }
    }
    return MS_OK;
}

/* The first step's input, the only one that changes with the materials.
   x       [count][input size]
   out     [count][rows][input_width][4] */
static inline ms_status nn_shader_inputs(const ms_nn *nn, int count, const float *x, float *out)
{
    const size_t *seen;
    size_t channels, inputs, width, r, i;
    if (nn == NULL || count < 1 || x == NULL || out == NULL) return MS_INVALID_ARGUMENT;
    seen = ms_nn_channel_inputs(nn, &channels, &inputs);
    width = 4 * nn_shader__vec4_count(inputs);
    for (r = 0; r < (size_t)count * channels; ++r, out += width)
        for (i = 0; i < width; ++i) {
            const float *sample = x + r / channels * ms_nn_input_size(nn);
            out[i] = i < inputs ? sample[seen ? seen[r % channels * inputs + i] : i] : 0.0f;
        }
    return MS_OK;
}
#endif
