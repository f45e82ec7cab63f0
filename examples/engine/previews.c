/* A gallery that follows a slider: 300 materials of a neural renderer, drawn by the GPU in two draws (or STEPS)
   whenever one of their parameters moves. Only their parameters are sent again.

     cc -O2 -I. examples/engine/previews.c -o build/previews -lEGL -lm
     build/previews WEIGHTS.safetensors OUT.png [SLIDER [STEPS]]

   WEIGHTS: as of build/preview, such as examples/data/renderer_128.safetensors, with dense layers only. SLIDER: which
   parameter moves, from 0 to 1 in three frames; 0 if it is not given. OUT: the last frame, which is compared with
   ms_nn_forward. Time is of the clock; on a software rasteriser it is no measure of anything. */
#define _POSIX_C_SOURCE 200809L
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "egl.h"
#include "nn_shader.h"
#include "../tools/neural.h"
#include <time.h>

enum { COUNT = 300, ACROSS = 20, FRAMES = 3, STEPS_MAX = 16 };

static int fail(const char *what, const char *problem)
{
    fprintf(stderr, "previews: %s: %s\n", what, problem);
    return 1;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The steps of a network: programs, the textures that they read and write, and sizes. */
typedef struct gallery {
    nn_shader_sizes size[STEPS_MAX];
    int steps, width, height;
    GLuint program[STEPS_MAX], weights, values[STEPS_MAX + 1]; /* values[0]: inputs; the last: the sheet */
    float *inputs;
} gallery;

static GLuint values_texture(GLenum format, int width, int height)
{
    return gl_texture(0, format, width, height, NULL);
}

/* NULL, or what is wrong. */
static const char *gallery_make(gallery *g, const neural *n, int steps, ms_error *error)
{
    static char text[60000], log[2000];
    const float constants[4] = {ACROSS, COUNT, 0,
                                0}; /* row 0 of the sheet is row 0 of the target: as image_write wants it */
    nn_shader s;
    void *weights;
    memset(g, 0, sizeof *g);
    memset(&s, 0, sizeof s);
    s.steps = steps;
    s.width = s.height = n->size;
    if (nn_shader_layout(n->nn, &s, &g->size[0], error) != MS_OK) return error->message;
    g->steps = g->size[0].steps;
    if (g->steps > STEPS_MAX) return "more steps than this program holds";
    weights = malloc((size_t)g->size[0].weight_rows * NN_SHADER_WIDTH * 4 * 2);
    g->inputs = (float *)malloc((size_t)(COUNT * g->size[0].rows * g->size[0].input_width) * 16);
    if (weights == NULL || g->inputs == NULL) return "out of memory";
    if (nn_shader_weights(n->nn, MS_NN_F16, weights, error) != MS_OK) return error->message;
    g->weights = values_texture(GL_RGBA32F, 1, 1);
    gl_TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, NN_SHADER_WIDTH, g->size[0].weight_rows, 0, GL_RGBA, GL_HALF_FLOAT,
                  weights);
    free(weights);
    g->values[0] = values_texture(GL_RGBA32F, g->size[0].input_width, COUNT * g->size[0].rows);
    for (s.step = 0; s.step < g->steps; ++s.step) {
        nn_shader_sizes *z = &g->size[s.step];
        int last = s.step == g->steps - 1;
        nn_shader_layout(n->nn, &s, z, NULL);
        if (nn_shader_text(n->nn, &s, text, sizeof text, error) == 0) return error->message;
        g->program[s.step] = gl_program(gl_corner[0], text, log, sizeof log);
        if (!g->program[s.step]) return log;
        gl_Uniform1i(gl_GetUniformLocation(g->program[s.step], "ms_nn_weights"), 0);
        gl_Uniform1i(gl_GetUniformLocation(g->program[s.step], "ms_nn_values"), 1);
        if (last) gl_Uniform4fv(gl_GetUniformLocation(g->program[s.step], "ms_nn"), 1, constants);
        g->width = last ? ACROSS * n->size : z->target_width;
        g->height = last ? (COUNT + ACROSS - 1) / ACROSS * n->size : COUNT * z->rows;
        g->values[s.step + 1] = values_texture(last ? GL_RGBA8 : GL_RGBA32F, g->width, g->height);
    }
    return NULL;
}

/* A frame: parameters to the GPU, then a draw a step. */
static void gallery_draw(gallery *g, const neural *n, const float *x)
{
    int k;
    nn_shader_inputs(n->nn, COUNT, x, g->inputs);
    gl_ActiveTexture(GL_TEXTURE1);
    gl_BindTexture(GL_TEXTURE_2D, g->values[0]);
    gl_TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, g->size[0].input_width, COUNT * g->size[0].rows, 0, GL_RGBA, GL_FLOAT,
                  g->inputs);
    gl_ActiveTexture(GL_TEXTURE0);
    gl_BindTexture(GL_TEXTURE_2D, g->weights);
    gl_ActiveTexture(GL_TEXTURE1);
    for (k = 0; k < g->steps; ++k) {
        gl_UseProgram(g->program[k]);
        gl_BindTexture(GL_TEXTURE_2D, g->values[k]);
        gl_FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, g->values[k + 1], 0);
        gl_Viewport(0, 0, k == g->steps - 1 ? g->width : g->size[k].target_width,
                    k == g->steps - 1 ? g->height : COUNT * g->size[k].rows);
        gl_DrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_Finish();
}

/* The sheet as an image, and how far it is from the CPU's in levels of 255. */
static const char *gallery_read(const gallery *g, const neural *n, const float *x, image *out, double *worst)
{
    size_t i, pixels = (size_t)g->width * (size_t)g->height;
    unsigned char *bytes = (unsigned char *)malloc(4 * pixels);
    image cpu;
    const char *problem = neural_sheet(n, x, COUNT, ACROSS, 0, &cpu);
    *out = image_new(g->width, g->height, 3);
    if (!problem && (bytes == NULL || out->pixels == NULL)) problem = "out of memory";
    *worst = 0;
    if (!problem) gl_ReadPixels(0, 0, g->width, g->height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    for (i = 0; !problem && i < 3 * pixels; ++i) {
        out->pixels[i] = (float)bytes[i / 3 * 4 + i % 3] / 255.0f;
        *worst = fmax(*worst, 255 * fabs((double)out->pixels[i] - (double)cpu.pixels[i]));
    }
    free(bytes);
    image_free(&cpu);
    return problem;
}

int main(int argc, char **argv)
{
    static const char usage[] = "usage: previews WEIGHTS.safetensors OUT.png [SLIDER [STEPS]]\n";
    const int slider = argc > 3 ? atoi(argv[3]) : 0, steps = argc > 4 ? atoi(argv[4]) : 0;
    const char *problem;
    double best = 1e30, worst;
    gallery g;
    neural n;
    image sheet;
    ms_error error;
    float *x;
    int i, frame;
    if (file_help(argc, argv, usage)) return file_end_stdout("previews");
    if (argc < 3 || argc > 5) return file_usage(usage);
    if ((problem = neural_load(argv[1], &n)) != NULL) return fail(argv[1], problem);
    if (slider < 0 || slider >= n.parameters) return fail("SLIDER", "the network has no such parameter");
    if (!gl_open(GL_API_33)) return fail("OpenGL 3.3", "this machine has none without a window");
    if ((problem = gallery_make(&g, &n, steps, &error)) != NULL) return fail(argv[1], problem);
    x = (float *)malloc(COUNT * (size_t)n.parameters * sizeof(float));
    if (x == NULL) return fail(argv[1], "out of memory");
    for (i = 0; i < COUNT * n.parameters; ++i) x[i] = (float)((unsigned)i * 2654435761u >> 8) / 16777216.0f;
    for (frame = 0; frame < FRAMES; ++frame) {
        double start = now();
        for (i = 0; i < COUNT; ++i) x[i * n.parameters + slider] = (float)frame / (float)(FRAMES - 1);
        gallery_draw(&g, &n, x);
        best = fmin(best, now() - start);
    }
    problem = gallery_read(&g, &n, x, &sheet, &worst);
    if (!problem) problem = image_write(argv[2], &sheet);
    if (problem) return fail(argv[2], problem);
    printf("%d pictures of %d x %d in %d draws, %.1f ms on %s, at most %.2f of 255 from the CPU's\n", COUNT, n.size,
           n.size, g.steps, 1e3 * best, (const char *)gl_GetString(GL_RENDERER), worst);
    image_free(&sheet);
    free(x);
    free(g.inputs);
    neural_free(&n);
    return file_end_stdout("previews");
}
