/* The shader texts of examples/engine/nn_shader.h against ms_nn_forward: GLSL through EGL without a window, on a
   software rasteriser where there is no GPU; Vulkan and HLSL translated to it through SPIR-V; OpenGL ES (as WebGL 2)
   and WGSL in a headless Chromium where it is installed; every text through glslangValidator where that is.
   libraries: -lEGL */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "nn_shader.h"
#define GPU_FILE "nn"
#include "gpu.h"

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

static void tensor(recipe *r, const char *name, const char *part, ms_nn_dtype type, int rank, int rows, int cols,
                   double size)
{
    ms_nn_tensor *t = &r->tensor[r->count];
    size_t i, n = (size_t)rows * (size_t)(rank > 1 ? cols : 1),
              width = type == MS_NN_F32 ? 4
        : type == MS_NN_I8              ? 1
                                        : 2;
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
        uint16_t half = test_half_of(f);
        unsigned char *to = r->room + r->used + i * width;
        memcpy(&bits, &f, 4);
        if (type == MS_NN_F32) memcpy(to, &f, 4);
        else if (type == MS_NN_F16) memcpy(to, &half, 2);
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
            memcpy((unsigned char *)r->room + ((const unsigned char *)r->tensor[r->count - 1].data - r->room) + 4 * i,
                   &scale, 4);
        }
    }
    if (!strstr(rest, "false")) tensor(r, name, "bias", type == MS_NN_F16 ? MS_NN_F16 : MS_NN_F32, 1, out, 1, 0.5);
}

/* The network; *file is freed after it. */
static ms_nn *made(recipe *r, unsigned char **file)
{
    ms_nn_entry entries[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", NULL}, {"ms_nn_layers", NULL}};
    size_t size;
    ms_nn *nn = NULL;
    ms_error error;
    strcat(r->layers, "]");
    entries[1].value = r->input;
    entries[2].value = r->layers;
    *file = (unsigned char *)malloc(r->used + 100000);
    if (ms_nn_file_write(r->tensor, (size_t)r->count, entries, 3, *file, r->used + 100000, &size, &error) != MS_OK ||
        ms_nn_load(*file, size, NULL, &nn, &error) != MS_OK)
        TEST_FAIL("%s", error.message);
    free(r->room);
    return nn;
}

/* The i-th network: every activation, type, kind of skip; sizes that are no multiples of four; and its picture, 0 x 0:
   none. */
enum { NETWORKS = 14 };
static ms_nn *network(int i, unsigned char **file, int *width, int *height)
{
    static const char *const activation[] = {"relu",    "leaky_relu\",\"alpha\":0.2,\"bias\":false,\"name\":\"",
                                             "elu",     "tanh",
                                             "sigmoid", "softplus",
                                             "silu",    "gelu",
                                             "linear"};
    static const ms_nn_dtype type[] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    recipe r;
    char rest[100];
    *width = *height = 0;
    if (i < 9) { /* a perceptron a picture: RGB, then one, two and four planes */
        int planes = i == 1 ? 1 : i == 2 ? 2 : i == 3 ? 4 : 3;
        begin(&r, "[7]");
        snprintf(rest, sizeof rest, ",\"activation\":\"%s\"", i == 1 ? "leaky_relu" : activation[i]);
        if (i == 1) strcat(rest, ",\"alpha\":0.2,\"bias\":false");
        if (i == 2) strcat(rest, ",\"alpha\":1.7");
        dense(&r, "a", 13, 7, type[i % 3], rest);
        layer(&r, "{\"type\":\"dropout\",\"rate\":0.3}");
        dense(&r, "b", 18, 13, type[(i + 1) % 3], rest);
        *width = 5;
        *height = 3;
        dense(&r, "c", planes * 15, 18, type[i % 3], i % 2 ? ",\"activation\":\"sigmoid\"" : "");
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
    } else { /* slopes that are tiny and huge */
        begin(&r, "[7]");
        dense(&r, "a", 17, 7, MS_NN_F32, ",\"activation\":\"leaky_relu\",\"alpha\":1e-9");
        layer(&r, "{\"type\":\"activation\",\"activation\":\"leaky_relu\",\"alpha\":2000}");
        layer(&r, "{\"type\":\"activation\",\"activation\":\"tanh\"}");
        dense(&r, "b", 9, 17, MS_NN_I8, "");
    }
    return made(&r, file);
}

/* Sums of up to 72 products of values up to about 3 in another order, exp and tanh of a rasteriser: some 1e-6. Weights
   rounded to 11 bits: 2^-12 of each, a few times that after three layers. */
#define TOLERANCE_F32 2e-5
#define TOLERANCE_F16 (1.0 / 255)

/* --- one gallery --- */

enum { COUNT = 7, ACROSS = 3 };

/* A program of the text, its textures named. */
static GLuint program_of(nn_language language, const float constants[4])
{
    const GLuint program = gpu_program((int)language, 0, "ms_nn", constants, 1);
    gpu_read(program, (int)language, "ms_nn_weights", 0);
    gpu_read(program, (int)language, "ms_nn_values", 1);
    return program;
}

/* What the last target must hold, the sheet or the values of ms_nn_forward's y [COUNT][outputs]; NaN: anything. */
static void expect(const ms_nn *nn, const nn_shader *s, const nn_shader_sizes *z, const float *y, int width, int height,
                   int flip, float *out)
{
    int outputs = (int)ms_nn_output_size(nn), row = outputs / z->rows, i, c, px, py;
    for (i = 0; s->width == 0 && i < 4 * width * height; ++i) {
        c = i % (4 * width);
        out[i] = c < row ? y[i / (4 * width) * row + c] : NAN;
    }
    for (i = 0; s->width && i < 4 * width * height; ++i) {
        int planes = outputs / (s->width * s->height), picture;
        c = i % 4;
        px = i / 4 % width;
        py = i / 4 / width;
        if (flip) py = height - 1 - py;
        picture = py / s->height * ACROSS + px / s->width;
        if (px >= ACROSS * s->width || picture >= COUNT) out[i] = 0;
        else if (c < planes || (planes == 1 && c < 3))
            out[i] =
                y[picture * outputs + ((planes == 1 ? 0 : c) * s->height + py % s->height) * s->width + px % s->width];
        else out[i] = planes == 2 && c == 2 ? 0.0f : 1.0f;
    }
}

static double difference(const float *pixels, const float *expected, int count)
{
    double worst = 0;
    int i;
    for (i = 0; i < count; ++i) {
        double e = expected[i] != expected[i] ? 0 : fabs((double)pixels[i] - (double)expected[i]);
        worst = e <= worst ? worst : e;
    }
    return worst;
}

/* A gallery through all its steps: the largest difference; or into a page. */
static double gallery(int number, int steps, nn_language language, ms_nn_dtype type, int flip, FILE *page)
{
    unsigned char *file;
    int width, height, k, i, sheet_w = 0, sheet_h = 0;
    ms_nn *nn = network(number, &file, &width, &height);
    nn_shader s;
    nn_shader_sizes z;
    ms_error error;
    GLuint texture[10], textures = 0;
    float *x, *y, *inputs, *pixels, *expected;
    void *weights;
    double e = 0;
    uint64_t seed = test_seed;
    if (!nn) return 1e9;
    memset(&s, 0, sizeof s);
    s.steps = steps;
    s.width = width;
    s.height = height;
    s.language = language;
    if (nn_shader_layout(nn, &s, &z, &error) != MS_OK) TEST_FAIL("network %d: %s", number, error.message);
    x = (float *)malloc(COUNT * ms_nn_input_size(nn) * sizeof(float));
    y = (float *)malloc(COUNT * ms_nn_output_size(nn) * sizeof(float));
    inputs = (float *)malloc((size_t)(COUNT * z.rows * z.input_width) * 16);
    weights = malloc((size_t)z.weight_rows * NN_SHADER_WIDTH * 16);
    for (i = 0; i < COUNT * (int)ms_nn_input_size(nn); ++i) x[i] = (float)(4 * test_uniform(&seed) - 2);
    CHECK(ms_nn_forward(nn, COUNT, x, y, NULL) == MS_OK);
    CHECK(nn_shader_inputs(nn, COUNT, x, inputs) == MS_OK);
    CHECK(nn_shader_weights(nn, type, weights, &error) == MS_OK);
    if (page) {
        fprintf(page, "{api: '%s', tolerance: %g, images: {", language == NN_WGSL ? "webgpu" : "webgl", TOLERANCE_F32);
        gpu_put_image(page, "weights", NN_SHADER_WIDTH, z.weight_rows, 4, (const float *)weights);
        gpu_put_image(page, "values0", z.input_width, COUNT * z.rows, 4, inputs);
        fputs("}, steps: [", page);
    } else {
        texture[textures++] = gl_texture(0, GL_RGBA32F, 1, 1, NULL);
        gl_TexImage2D(GL_TEXTURE_2D, 0, type == MS_NN_F16 ? GL_RGBA16F : GL_RGBA32F, NN_SHADER_WIDTH, z.weight_rows, 0,
                      GL_RGBA, type == MS_NN_F16 ? GL_HALF_FLOAT : GL_FLOAT, weights);
        texture[textures++] = gl_texture(1, GL_RGBA32F, z.input_width, COUNT * z.rows, inputs);
    }
    for (k = 0; k < z.steps; ++k) {
        float constants[4] = {ACROSS, COUNT, 0, 0};
        GLuint program;
        s.step = k;
        CHECK(nn_shader_layout(nn, &s, &z, &error) == MS_OK);
        if (!nn_shader_text(nn, &s, text, sizeof text, &error)) TEST_FAIL("%s", error.message);
        sheet_w = z.target_width;
        sheet_h = COUNT * z.rows;
        if (k == z.steps - 1 && width) { /* a column and a row of pictures more than there are */
            sheet_w = (ACROSS + 1) * width - 2;
            sheet_h = ((COUNT + ACROSS - 1) / ACROSS + 1) * height - 1;
            constants[2] = (float)(flip ? sheet_h : 0);
        }
        if (page) {
            gpu_put_step(page, "ms_nn", constants, 1, sheet_w, sheet_h);
            fprintf(page, "read: {ms_nn_weights: 'weights', ms_nn_values: 'values%d'}, write: ['values%d']},\n", k,
                    k + 1);
            continue;
        }
        program = program_of(language, constants);
        texture[textures] = gl_texture(2, GL_RGBA32F, sheet_w, sheet_h, NULL);
        gl_ActiveTexture(GL_TEXTURE0);
        gl_BindTexture(GL_TEXTURE_2D, texture[0]);
        gl_ActiveTexture(GL_TEXTURE1);
        gl_BindTexture(GL_TEXTURE_2D, texture[textures - 1]);
        gpu_draw(texture[textures++], 0, sheet_w, sheet_h, 0);
        gl_DeleteProgram(program);
    }
    pixels = (float *)malloc((size_t)(sheet_w * sheet_h) * 16);
    expected = (float *)malloc((size_t)(sheet_w * sheet_h) * 16);
    expect(nn, &s, &z, y, sheet_w, sheet_h, flip, expected);
    if (page) {
        fputs("], expected: ", page);
        gpu_put_floats(page, expected, (size_t)(4 * sheet_w * sheet_h));
        fputs("},\n", page);
    } else {
        gl_ReadPixels(0, 0, sheet_w, sheet_h, GL_RGBA, GL_FLOAT, pixels);
        e = difference(pixels, expected, 4 * sheet_w * sheet_h);
        gl_DeleteTextures((GLsizei)textures, texture);
    }
    free(expected);
    free(pixels);
    free(x);
    free(y);
    free(inputs);
    free(weights);
    ms_nn_destroy(nn);
    free(file);
    return e;
}

static int layers_of(int number)
{
    static const int dense_layers[NETWORKS] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 2, 3, 1, 2};
    return dense_layers[number];
}

static void run_all(gl_api api, nn_language language, int each)
{
    double worst[2] = {0, 0};
    int i, steps, half;
    if (!gl_open(api)) SKIP("no OpenGL context without a window");
    if (language >= NN_GLSL_VULKAN && !gpu_can_translate()) SKIP("no glslangValidator or spirv-cross on this machine");
    for (i = 0; i < NETWORKS; i += each)
        for (steps = 0; steps <= layers_of(i); ++steps)
            for (half = 0; half < (test_full || i % (3 * each) == 0 ? 2 : 1); ++half) { /* the text is the same */
                double e;
                if (i == 11 && steps > 1) continue; /* its skips cross steps, see the refusals; alone it is one step */
                if (steps == 0 && i == 11) continue;
                if (steps == 1 && layers_of(i) > 1 && i != 11 && i != 13) continue; /* pictures need two */
                e = gallery(i, steps, language, half ? MS_NN_F16 : MS_NN_F32, (i + steps) % 2, NULL);
                if (!(e <= (half ? TOLERANCE_F16 : TOLERANCE_F32)))
                    TEST_FAIL("network %d, %d steps, %s: %g", i, steps, half ? "F16" : "F32", e);
                if (e > worst[half]) worst[half] = e;
            }
    TEST_NOTE("%s: largest difference %.1e, with weights of 16 bits %.1e", (const char *)gl_GetString(GL_RENDERER),
              worst[0], worst[1]);
}

static void case_desktop(void) { run_all(GL_API_33, NN_GLSL_330, 1); }
static void case_es(void) { run_all(GL_API_ES_30, NN_GLSL_ES_300, test_full ? 1 : 3); }
static void case_vulkan(void) { run_all(GL_API_33, NN_GLSL_VULKAN, test_full ? 1 : 3); }
static void case_hlsl(void) { run_all(GL_API_33, NN_HLSL, test_full ? 1 : 3); }

/* What has no shader is refused by the name of the layer or field, and nothing is written. */
static void refused(recipe *r, const nn_shader *s, ms_status status, const char *name)
{
    unsigned char *file, before[16];
    char small[8] = "before";
    ms_nn *nn = made(r, &file);
    nn_shader_sizes z = {9, 9, 9, 9, 9};
    ms_error error;
    memset(&error, 0, sizeof error);
    CHECK_INT(nn_shader_text(nn, s, small, sizeof small, &error), 0);
    CHECK_INT(error.status, status);
    if (!strstr(error.message, name)) TEST_FAIL("'%s' does not name %s", error.message, name);
    CHECK_INT(nn_shader_layout(nn, s, &z, NULL), status);
    CHECK(strcmp(small, "before") == 0 && z.steps == 9);
    memset(before, 7, sizeof before);
    if (status == MS_UNSUPPORTED && s->steps == 0) CHECK_INT(nn_shader_weights(nn, MS_NN_F32, before, &error), status);
    CHECK(before[0] == 7);
    ms_nn_destroy(nn);
    free(file);
}

static void case_refused(void)
{
    static const char *const alone[] = {"", "upsample1d", "avgpool1d", "globalpool"};
    nn_shader good, s;
    nn_shader_sizes z;
    ms_error error;
    unsigned char *file;
    char small[100] = "before";
    float x[7] = {0}, out[8];
    uint16_t *half;
    recipe r;
    ms_nn *nn;
    int i, w, h;
    memset(&good, 0, sizeof good);
    for (i = 1; i < 4; ++i) {
        char json[100];
        begin(&r, "[2,8]");
        snprintf(json, sizeof json, "{\"type\":\"%s\",\"name\":\"here\"}", alone[i]);
        layer(&r, json);
        layer(&r, "{\"type\":\"flatten\",\"order\":\"channels_last\"}");
        dense(&r, "d", 4, i == 1 ? 32 : i == 2 ? 8 : 2, MS_NN_F16, "");
        refused(&r, &good, MS_UNSUPPORTED, alone[i]);
    }
    begin(&r, "[2,2]");
    layer(&r, "{\"type\":\"flatten\"}");
    dense(&r, "a", 3, 4, MS_NN_F32, "");
    refused(&r, &good, MS_UNSUPPORTED, "flatten");
    begin(&r, "[4]");
    layer(&r, "{\"type\":\"activation\",\"activation\":\"tanh\"}");
    dense(&r, "a", 3, 4, MS_NN_F32, "");
    refused(&r, &good, MS_UNSUPPORTED, "activation");
    begin(&r, "[4]"); /* the input is added in the second step */
    dense(&r, "a", 5, 4, MS_NN_F32, "");
    dense(&r, "b", 4, 5, MS_NN_F32, "");
    layer(&r, "{\"type\":\"add\",\"from\":\"input\"}");
    s = good, s.step = 1, s.steps = 2;
    refused(&r, &s, MS_UNSUPPORTED, "layer 2 adds");
    begin(&r, "[4]"); /* an addition of pixels */
    dense(&r, "a", 4, 4, MS_NN_F32, "");
    dense(&r, "b", 4, 4, MS_NN_F32, "");
    layer(&r, "{\"type\":\"add\",\"from\":\"a\"}");
    s = good, s.step = 1, s.steps = 2, s.width = s.height = 2;
    refused(&r, &s, MS_UNSUPPORTED, "pictures have none");
    for (i = 0; i < 7; ++i) {
        begin(&r, "[4]");
        dense(&r, "a", 4, 4, MS_NN_F32, "");
        dense(&r, "b", 20, 4, MS_NN_F32, "");
        s = good, s.step = 1;
        if (i == 0) s.steps = 3;
        else if (i == 1) s.step = 2;
        else if (i == 2) s.step = -1;
        else if (i == 3) s.language = (nn_language)5;
        else if (i == 4) s.width = 3, s.height = 2;
        else if (i == 5) s.width = 2, s.height = 2; /* five planes */
        else s.width = 20;
        refused(&r, &s, MS_INVALID_ARGUMENT,
                i == 0       ? "of 3"
                    : i == 1 ? "step 2"
                    : i == 2 ? "step -1"
                    : i == 3 ? "language 5"
                    : i == 4 ? "3 x 2"
                    : i == 5 ? "2 x 2"
                             : "20 x 0");
    }
    begin(&r, "[4]");
    dense(&r, "a", 4, 4, MS_NN_F32, "");
    {
        float large = -70000;
        memcpy(r.room + 20, &large, 4);
    }
    nn = made(&r, &file);
    half = (uint16_t *)calloc((size_t)NN_SHADER_WIDTH * 4, 2);
    half[0] = 7;
    CHECK_INT(nn_shader_weights(nn, MS_NN_F16, half, &error), MS_UNSUPPORTED);
    CHECK(strstr(error.message, "'a'") != NULL && half[0] == 7);
    CHECK_INT(nn_shader_weights(nn, MS_NN_BF16, half, &error), MS_INVALID_ARGUMENT);
    free(half);
    ms_nn_destroy(nn);
    free(file);
    nn = network(0, &file, &w, &h);
    CHECK(nn_shader_text(nn, &good, small, sizeof small, NULL) > 1000); /* it does not fit: the length alone */
    CHECK(strcmp(small, "before") == 0);
    CHECK_INT(nn_shader_text(nn, &good, NULL, 0, NULL), nn_shader_text(nn, &good, text, sizeof text, NULL));
    CHECK_INT(strlen(text), nn_shader_text(nn, &good, NULL, 0, NULL));
    CHECK_INT(nn_shader_text(NULL, &good, NULL, 0, &error), 0);
    CHECK_INT(nn_shader_text(nn, NULL, NULL, 0, &error), 0);
    CHECK_INT(nn_shader_layout(nn, &good, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(nn_shader_layout(nn, &good, &z, &error), MS_OK);
    CHECK_INT(nn_shader_inputs(nn, 0, x, out), MS_INVALID_ARGUMENT);
    CHECK_INT(nn_shader_inputs(nn, 1, x, out), MS_OK);
    ms_nn_destroy(nn);
    free(file);
}

/* Networks of every kind in WebGL 2 and WebGPU. */
static void case_browser(void)
{
    static const int picks[] = {0, 1, 5, 6, 7, 8, 9, 10, 11, 12};
    FILE *f;
    int i, language;
    if (!gpu_has_browser()) SKIP("no chromium on this machine");
    if ((f = gpu_page("build/nn_gpu.html")) == NULL) SKIP("cannot write build/nn_gpu.html");
    fputs("compile: [], images: {}, cases: [\n", f);
    for (language = (int)NN_GLSL_ES_300; language <= (int)NN_WGSL; language += (int)NN_WGSL - (int)NN_GLSL_ES_300)
        for (i = 0; i < (int)(sizeof picks / sizeof picks[0]); ++i)
            gallery(picks[i],
                    picks[i] == 11 ? 1
                        : i % 2    ? layers_of(picks[i])
                                   : 0,
                    (nn_language)language, MS_NN_F32, i / 2 % 2, f);
    fputs("]", f);
    gpu_run(f, "build/nn_gpu.html");
}

static const test_case cases[] = {{"refused", case_refused},      {"browser", case_browser},
                                  {"OpenGL 3.3", case_desktop},   {"OpenGL ES 3.0", case_es},
                                  {"Vulkan's text", case_vulkan}, {"HLSL", case_hlsl}};
TEST_MAIN(cases)
