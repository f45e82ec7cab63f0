/* The shader texts of ms_nn.h against ms_nn_forward: GLSL through EGL without a window, on a software rasteriser where there is no
   GPU; Vulkan and HLSL translated to it through SPIR-V; OpenGL ES (as WebGL 2) and WGSL in a headless Chromium where it is
   installed; every text through glslangValidator where that is.   libraries: -lEGL */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "test.h"
#include "gl/egl.h"

/* --- networks of random weights --- */

enum { TENSORS = 24, MAX_ROOM = 1 << 23 };

typedef struct recipe {
    char layers[4000], input[40], names[TENSORS][32];
    ms_nn_tensor tensor[TENSORS];
    size_t shape[TENSORS][2];
    int count;
    uint64_t seed;
    unsigned char *room; /* the tensors' data */
    size_t used;
} recipe;

static void begin(recipe *r, const char *input)
{
    memset(r, 0, sizeof *r);
    strcpy(r->input, input);
    strcpy(r->layers, "[");
    r->seed = test_seed + 77;
    r->room = (unsigned char *)malloc(MAX_ROOM);
}

static void layer(recipe *r, const char *json)
{
    size_t n = strlen(r->layers);
    snprintf(r->layers + n, sizeof r->layers - n, "%s%s", n > 1 ? "," : "", json);
}

static void tensor(recipe *r, const char *name, const char *part, ms_nn_dtype type, int rank, int rows, int cols, double size)
{
    ms_nn_tensor *t = &r->tensor[r->count];
    size_t i, n = (size_t)rows * (size_t)(rank > 1 ? cols : 1), width = type == MS_NN_F64 ? 8 : type == MS_NN_F32 ? 4 : type == MS_NN_I8 ? 1 : 2;
    snprintf(r->names[r->count], sizeof r->names[0], "%s.%s", name, part);
    r->shape[r->count][0] = (size_t)rows;
    r->shape[r->count][1] = (size_t)cols;
    t->name = r->names[r->count];
    t->dtype = type;
    t->rank = rank;
    t->shape = r->shape[r->count++];
    t->data = r->room + r->used;
    t->bytes = n * width;
    for (i = 0; i < n; ++i) {
        double v = size * (2 * test_uniform(&r->seed) - 1);
        float f = (float)v;
        uint32_t bits;
        uint16_t half = ms__half_from_float(f);
        unsigned char *to = r->room + r->used + i * width;
        memcpy(&bits, &f, 4);
        if (type == MS_NN_F64) memcpy(to, &v, 8);
        else if (type == MS_NN_F32) memcpy(to, &f, 4);
        else if (type == MS_NN_F16) memcpy(to, &half, 2);
        else if (type == MS_NN_BF16) to[0] = (unsigned char)(bits >> 16 & 255), to[1] = (unsigned char)(bits >> 24);
        else *to = (unsigned char)(signed char)(v * 127);
    }
    r->used += (t->bytes + 63) / 64 * 64;
}

/* rest: what else the layer says, such as ,"activation":"elu". */
static void dense(recipe *r, const char *name, int out, int in, ms_nn_dtype type, const char *rest)
{
    char json[200];
    double size = type == MS_NN_I8 ? 1 : sqrt(3.0 / in);
    snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"%s\"%s}", name, rest);
    layer(r, json);
    tensor(r, name, "weight", type, 2, out, in, size);
    if (type == MS_NN_I8) {
        int i;
        tensor(r, name, "weight_scale", MS_NN_F32, 1, out, 1, 0);
        for (i = 0; i < out; ++i) {
            float scale = (float)(sqrt(3.0 / in) / 127 * (0.5 + test_uniform(&r->seed)));
            memcpy((unsigned char *)r->room + ((const unsigned char *)r->tensor[r->count - 1].data - r->room) + 4 * i, &scale, 4);
        }
    }
    if (!strstr(rest, "false")) tensor(r, name, "bias", type == MS_NN_F16 ? MS_NN_F16 : MS_NN_F32, 1, out, 1, 0.5);
}

typedef struct memory {
    unsigned char *bytes;
    size_t size;
} memory;

static int keep(void *user, const void *bytes, size_t size)
{
    memory *m = (memory *)user;
    memcpy(m->bytes + m->size, bytes, size);
    m->size += size;
    return 0;
}

/* The network; *file is freed after it. */
static ms_nn *made(recipe *r, unsigned char **file)
{
    ms_nn_entry entries[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", NULL}, {"ms_nn_layers", NULL}};
    ms_nn_sink sink;
    memory m;
    ms_nn *nn = NULL;
    ms_error error;
    strcat(r->layers, "]");
    entries[1].value = r->input;
    entries[2].value = r->layers;
    m.bytes = *file = (unsigned char *)malloc(r->used + 100000);
    m.size = 0;
    sink.user = &m;
    sink.write = keep;
    if (ms_nn_file_write(r->tensor, (size_t)r->count, entries, 3, NULL, sink, &error) != MS_OK || ms_nn_load(m.bytes, m.size, NULL, &nn, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    free(r->room);
    return nn;
}

/* The i-th network: every activation, type, kind of skip; sizes that are no multiples of four; and its picture, 0 x 0: none. */
enum { NETWORKS = 14 };
static ms_nn *network(int i, unsigned char **file, int *width, int *height)
{
    static const char *const activation[] = {"relu", "leaky_relu\",\"alpha\":0.2,\"bias\":false,\"name\":\"", "elu", "tanh", "sigmoid", "softplus", "silu", "gelu", "linear"};
    static const ms_nn_dtype type[] = {MS_NN_F32, MS_NN_F16, MS_NN_BF16, MS_NN_I8, MS_NN_F64};
    recipe r;
    char rest[100];
    *width = *height = 0;
    if (i < 9) { /* a perceptron a picture: RGB, then one, two and four planes */
        int planes = i == 1 ? 1 : i == 2 ? 2 : i == 3 ? 4 : 3;
        begin(&r, "[7]");
        snprintf(rest, sizeof rest, ",\"activation\":\"%s\"", i == 1 ? "leaky_relu" : activation[i]);
        if (i == 1) strcat(rest, ",\"alpha\":0.2,\"bias\":false");
        if (i == 2) strcat(rest, ",\"alpha\":1.7");
        dense(&r, "a", 13, 7, type[i % 5], rest);
        layer(&r, "{\"type\":\"dropout\",\"rate\":0.3}");
        dense(&r, "b", 18, 13, type[(i + 1) % 5], rest);
        *width = 5;
        *height = 3;
        dense(&r, "c", planes * 15, 18, type[i % 5], i % 2 ? ",\"activation\":\"sigmoid\"" : "");
    } else if (i == 9) { /* shared channels that share inputs, more than 2048 texels of weights */
        begin(&r, "[9]");
        layer(&r, "{\"type\":\"shared_channels\",\"inputs\":[[0,3,6,1,8],[1,4,7,0,8],[2,5,6,2,8]]}");
        dense(&r, "a", 70, 5, MS_NN_F32, ",\"activation\":\"elu\"");
        dense(&r, "b", 61, 70, MS_NN_F16, ",\"activation\":\"elu\"");
        dense(&r, "c", 22, 61, MS_NN_F32, "");
        *width = 16;
        *height = 11;
        dense(&r, "d", 176, 22, MS_NN_F16, "");
    } else if (i == 10) { /* two channels of two planes */
        begin(&r, "[3]");
        layer(&r, "{\"type\":\"shared_channels\",\"inputs\":[[0,2],[1,2]]}");
        dense(&r, "a", 6, 2, MS_NN_F32, ",\"activation\":\"tanh\"");
        *width = 3;
        *height = 7;
        dense(&r, "b", 42, 6, MS_NN_F32, "");
    } else if (i == 11) { /* skips: from the input, of what is kept before an activation, around a layer, around two */
        begin(&r, "[10]");
        dense(&r, "a", 10, 10, MS_NN_F32, "");
        layer(&r, "{\"type\":\"activation\",\"activation\":\"tanh\"}");
        layer(&r, "{\"type\":\"add\",\"name\":\"s\",\"from\":\"a\",\"activation\":\"silu\"}");
        dense(&r, "b", 10, 10, MS_NN_F32, ",\"activation\":\"elu\"");
        layer(&r, "{\"type\":\"add\",\"from\":\"input\"}");
        dense(&r, "c", 10, 10, MS_NN_F32, "");
        layer(&r, "{\"type\":\"add\",\"from\":\"s\"}");
        layer(&r, "{\"type\":\"activation\",\"activation\":\"gelu\",\"name\":\"g\"}");
        layer(&r, "{\"type\":\"add\",\"from\":\"g\"}");
    } else if (i == 12) { /* a single layer */
        begin(&r, "[5]");
        *width = 4;
        *height = 4;
        dense(&r, "a", 48, 5, MS_NN_F32, ",\"activation\":\"softplus\"");
    } else { /* an input that is flattened, an upsampling that goes into the weights */
        begin(&r, "[2,3,3]");
        layer(&r, "{\"type\":\"upsample2d\"}");
        layer(&r, "{\"type\":\"flatten\"}");
        dense(&r, "a", 17, 72, MS_NN_F32, ",\"activation\":\"sigmoid\"");
        dense(&r, "b", 9, 17, MS_NN_I8, "");
    }
    return made(&r, file);
}

/* --- one gallery --- */

enum { COUNT = 7, ACROSS = 3, TEXT = 30000 };
static char text[TEXT];

static void render(GLuint target, int width, int height)
{
    gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    CHECK_INT(gl_CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    gl_Viewport(0, 0, width, height);
    gl_Disable(GL_BLEND);
    gl_DrawArrays(GL_TRIANGLES, 0, 3);
}

/* HLSL and Vulkan's GLSL cannot run here: through SPIR-V they become GLSL 330 again. */
static int translate(ms_nn_language language)
{
    FILE *f = fopen("build/nn_step.frag", "w");
    char *back;
    if (!f) return 0;
    fputs(text, f);
    fclose(f);
    if (system(language == MS_NN_HLSL ? "glslangValidator -D -V -S frag -e main -o build/nn_step.spv build/nn_step.frag >build/nn_glslang.txt 2>&1"
                                      : "glslangValidator -V -S frag -o build/nn_step.spv build/nn_step.frag >build/nn_glslang.txt 2>&1") != 0 ||
        system("spirv-cross --version 330 --no-es --no-420pack-extension --flatten-ubo --output build/nn_step.glsl build/nn_step.spv >build/nn_glslang.txt 2>&1") != 0)
        return 0;
    back = test_read_file("build/nn_step.glsl", NULL);
    if (back && strlen(back) < sizeof text) strcpy(text, back);
    free(back);
    return 1;
}

/* A program of the text, its textures named. */
static GLuint program_of(ms_nn_language language, const float constants[4])
{
    static const char *const name[2] = {"ms_nn_weights", "ms_nn_values"};
    char log[2000];
    GLuint program;
    int i;
    if (language >= MS_NN_GLSL_VULKAN && !translate(language)) TEST_FAIL("no translation: build/nn_glslang.txt");
    program = gl_program(gl_corner[language == MS_NN_GLSL_ES_300], text, log, sizeof log);
    if (!program || (log[0] && language < MS_NN_GLSL_VULKAN)) TEST_FAIL("%.600s", log);
    for (i = 0; i < 2; ++i) {
        char full[100];
        snprintf(full, sizeof full, language == MS_NN_HLSL ? "SPIRV_Cross_Combined%sSPIRV_Cross_DummySampler" : "%s", name[i]);
        gl_Uniform1i(gl_GetUniformLocation(program, full), i);
    }
    gl_Uniform4fv(gl_GetUniformLocation(program, language < MS_NN_GLSL_VULKAN ? "ms_nn" : "ms_nn_block"), 1, constants);
    return program;
}

static float at(const float *pixels, int width, int x, int y, int c) { return pixels[4 * (y * width + x) + c]; }

/* What the last target must hold: the sheet or the values of ms_nn_forward's y [COUNT][outputs]. Largest difference. */
static double difference(const ms_nn *nn, const ms_nn_shader *s, const ms_nn_shader_sizes *z, const float *y, const float *pixels, int width, int height, int flip)
{
    int outputs = (int)ms_nn_output_size(nn), row = outputs / z->rows, i, c, px, py;
    double worst = 0;
    if (s->width == 0) {
        for (i = 0; i < COUNT * z->rows; ++i)
            for (c = 0; c < row; ++c) {
                double e = fabs((double)pixels[4 * z->target_width * i + c] - (double)y[i * row + c]);
                worst = e <= worst ? worst : e;
            }
        return worst;
    }
    for (py = 0; py < height; ++py)
        for (px = 0; px < width; ++px) {
            int planes = outputs / (s->width * s->height), sy = flip ? height - 1 - py : py, picture = sy / s->height * ACROSS + px / s->width;
            for (c = 0; c < 4; ++c) {
                double want = planes == 2 && c == 2 ? 0 : 1, e;
                if (picture >= COUNT) want = 0;
                else if (c < planes || (planes == 1 && c < 3))
                    want = (double)y[picture * outputs + ((planes == 1 ? 0 : c) * s->height + sy % s->height) * s->width + px % s->width];
                e = fabs((double)at(pixels, width, px, py, c) - want);
                worst = e <= worst ? worst : e;
            }
        }
    return worst;
}

/* A gallery through all its steps. */
static double gallery(int number, int steps, ms_nn_language language, ms_nn_dtype type, int flip)
{
    unsigned char *file;
    int width, height, k, i, sheet_w = 0, sheet_h = 0;
    ms_nn *nn = network(number, &file, &width, &height);
    ms_nn_shader s;
    ms_nn_shader_sizes z;
    ms_error error;
    GLuint texture[10], textures = 0;
    float *x, *y, *inputs, *pixels;
    void *weights;
    double e;
    uint64_t seed = test_seed;
    if (!nn) return 1e9;
    memset(&s, 0, sizeof s);
    s.steps = steps;
    s.width = width;
    s.height = height;
    s.language = language;
    if (ms_nn_shader_layout(nn, &s, &z, &error) != MS_OK) TEST_FAIL("network %d: %s", number, error.message);
    x = (float *)malloc(COUNT * ms_nn_input_size(nn) * sizeof(float));
    y = (float *)malloc(COUNT * ms_nn_output_size(nn) * sizeof(float));
    inputs = (float *)malloc((size_t)(COUNT * z.rows * z.input_width) * 16);
    weights = malloc((size_t)z.weight_rows * MS_NN_SHADER_WIDTH * 16);
    for (i = 0; i < COUNT * (int)ms_nn_input_size(nn); ++i) x[i] = (float)(4 * test_uniform(&seed) - 2);
    CHECK(ms_nn_forward(nn, COUNT, x, y, NULL) == MS_OK);
    CHECK(ms_nn_shader_inputs(nn, COUNT, x, inputs) == MS_OK);
    CHECK(ms_nn_shader_weights(nn, type, weights, &error) == MS_OK);
    texture[textures++] = gl_texture(0, GL_RGBA32F, 1, 1, NULL);
    gl_TexImage2D(GL_TEXTURE_2D, 0, type == MS_NN_F16 ? GL_RGBA16F : GL_RGBA32F, MS_NN_SHADER_WIDTH, z.weight_rows, 0, GL_RGBA,
                  type == MS_NN_F16 ? GL_HALF_FLOAT : GL_FLOAT, weights);
    texture[textures++] = gl_texture(1, GL_RGBA32F, z.input_width, COUNT * z.rows, inputs);
    for (k = 0; k < z.steps; ++k) {
        float constants[4] = {ACROSS, COUNT, 0, 0};
        GLuint program;
        s.step = k;
        CHECK(ms_nn_shader_layout(nn, &s, &z, &error) == MS_OK);
        if (!ms_nn_shader_text(nn, &s, text, sizeof text, &error)) TEST_FAIL("%s", error.message);
        sheet_w = z.target_width;
        sheet_h = COUNT * z.rows;
        if (k == z.steps - 1 && width) { /* a column and a row of pictures more than there are */
            sheet_w = (ACROSS + 1) * width - 2;
            sheet_h = ((COUNT + ACROSS - 1) / ACROSS + 1) * height - 1;
            constants[2] = (float)(flip ? sheet_h : 0);
        }
        program = program_of(language, constants);
        texture[textures] = gl_texture(2, GL_RGBA32F, sheet_w, sheet_h, NULL);
        gl_ActiveTexture(GL_TEXTURE0);
        gl_BindTexture(GL_TEXTURE_2D, texture[0]);
        gl_ActiveTexture(GL_TEXTURE1);
        gl_BindTexture(GL_TEXTURE_2D, texture[textures - 1]);
        render(texture[textures++], sheet_w, sheet_h);
        gl_DeleteProgram(program);
    }
    pixels = (float *)malloc((size_t)(sheet_w * sheet_h) * 16);
    gl_ReadPixels(0, 0, sheet_w, sheet_h, GL_RGBA, GL_FLOAT, pixels);
    /* the columns beyond ACROSS are 0 as well */
    for (i = 0; width && i < sheet_h; ++i) CHECK(at(pixels, sheet_w, sheet_w - 1, i, 1) == 0);
    if (width) {
        for (i = 0; i < sheet_h; ++i) memmove(pixels + 4 * i * ACROSS * width, pixels + 4 * i * sheet_w, (size_t)(ACROSS * width) * 16);
        sheet_w = ACROSS * width;
    }
    e = difference(nn, &s, &z, y, pixels, sheet_w, sheet_h, flip);
    gl_DeleteTextures((GLsizei)textures, texture);
    free(pixels);
    free(x);
    free(y);
    free(inputs);
    free(weights);
    ms_nn_destroy(nn);
    free(file);
    return e;
}

/* Sums of up to 72 products of values up to about 3 in another order, exp and tanh of a rasteriser: some 1e-6. Weights rounded to
   11 bits: 2^-12 of each, a few times that after three layers. */
#define TOLERANCE_F32 2e-5
#define TOLERANCE_F16 (1.0 / 255)

static int layers_of(int number)
{
    static const int dense_layers[NETWORKS] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 2, 3, 1, 2};
    return dense_layers[number];
}

static void run_all(gl_api api, ms_nn_language language, int each)
{
    double worst[2] = {0, 0};
    int i, steps, half;
    if (!gl_open(api)) SKIP("no OpenGL context without a window");
    if (language >= MS_NN_GLSL_VULKAN && system("glslangValidator --version >build/nn_glslang.txt 2>&1 && spirv-cross --revision >>build/nn_glslang.txt 2>&1") != 0)
        SKIP("no glslangValidator or spirv-cross on this machine");
    for (i = 0; i < NETWORKS; i += each)
        for (steps = 0; steps <= layers_of(i); ++steps)
            for (half = 0; half < 2; ++half) {
                double e;
                if (i == 11 && steps > 1) continue; /* its skips cross steps, see the refusals; alone it is one step */
                if (steps == 0 && i == 11) continue;
                if (steps == 1 && layers_of(i) > 1 && i != 11 && i != 13) continue; /* pictures need two */
                e = gallery(i, steps, language, half ? MS_NN_F16 : MS_NN_F32, (i + steps) % 2);
                if (!(e <= (half ? TOLERANCE_F16 : TOLERANCE_F32))) TEST_FAIL("network %d, %d steps, %s: %g", i, steps, half ? "F16" : "F32", e);
                if (e > worst[half]) worst[half] = e;
            }
    TEST_NOTE("%s: largest difference %.1e, with weights of 16 bits %.1e", (const char *)gl_GetString(GL_RENDERER), worst[0], worst[1]);
}

static void case_desktop(void) { run_all(GL_API_33, MS_NN_GLSL_330, 1); }
static void case_es(void) { run_all(GL_API_ES_30, MS_NN_GLSL_ES_300, 1); }
static void case_vulkan(void) { run_all(GL_API_33, MS_NN_GLSL_VULKAN, test_full ? 1 : 3); }
static void case_hlsl(void) { run_all(GL_API_33, MS_NN_HLSL, test_full ? 1 : 3); }

static const test_case cases[] = {{"OpenGL 3.3", case_desktop}, {"OpenGL ES 3.0", case_es}, {"Vulkan's text", case_vulkan}, {"HLSL", case_hlsl}};
TEST_MAIN(cases)
