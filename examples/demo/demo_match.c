/* Eight edits of held-out materials and the materials that match them best:

     cc -O2 -I. examples/demo/demo_match.c -o build/demo_match -lm
     build/demo_match OUT.png

   Source, edited target, match, and four times their difference, two edits a row, from the networks and pictures of
   examples/data. A star marks edits of a part of the picture, which no material explains. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "../tools/matcher.h"
#include "edits.h"
#include "../tools/text.h"
#include <time.h>

static const char usage[] = "usage: demo_match OUT.png\n";

enum { SIZE = 128, GAP = 2, PITCH = SIZE + GAP, BREAK = 12, COUNT = 8, DIFFERENCE = 4, HEAD = 28, TALL = PITCH + HEAD };

static const struct {
    const char *edit;
    int source, other; /* pictures of materials.png */
    int in_part;       /* of the object, or of what is around it */
} list[COUNT] = {{"saturation", 26, 26, 0},     {"grayscale", 14, 14, 0}, {"colorize", 9, 9, 0},
                 {"mix of two", 14, 12, 0},     {"stitching", 43, 17, 1}, {"inpainting", 35, 35, 1},
                 {"highlight blur", 16, 16, 0}, {"poor mask", 30, 30, 1}};

static int fail(const char *what)
{
    fprintf(stderr, "demo_match: %s\n", what);
    return 1;
}

/* Target, match and difference of an edited picture into the sheet at column `left`, row `top`. */
static ms_status row(matcher *m, const image *edited, float *planes, image *sheet, int left, int top,
                     ms_pme_match_result *result, ms_error *error)
{
    float *target = planes, *match = planes + m->renderer.image_size;
    ms_pme_match_options options = ms_pme_match_defaults();
    double x[MS_PME_PARAMETERS_MAX];
    size_t i;
    ms_status status;
    options.refine.max_cost = 300; /* a few hundredths of a second: looks beyond the best first guess */
    options.refine.restarts = 8;
    neural_planes(edited, target);
    status = matcher_aim(m, target, NULL, error);
    if (status == MS_OK) status = ms_pme_match(&m->renderer, target, NULL, &options, x, match, result, error);
    if (status != MS_OK) return status;
    neural_paste(target, SIZE, sheet, left + PITCH, top);
    neural_paste(match, SIZE, sheet, left + 2 * PITCH, top);
    for (i = 0; i < m->renderer.image_size; ++i) match[i] = (float)DIFFERENCE * fabsf(match[i] - target[i]);
    neural_paste(match, SIZE, sheet, left + 3 * PITCH, top);
    return MS_OK;
}

int main(int argc, char **argv)
{
    static const char *const panels[] = {"source", "edited", "match", "4 \xd7 difference"};
    static const char foot[] =
        "pictures: that the network computed on the way; *: edited in part, which no material explains";
    static const float ink[3] = {0.15f, 0.15f, 0.15f};
    static matcher m;
    image sheet, pictures, source, other, edited;
    const char *problem;
    float *planes;
    ms_error error;
    int i, k, x, y;
    if (file_help(argc, argv, usage)) return file_end_stdout("demo_match");
    if (argc != 2) return file_usage(usage);
    problem = image_read("examples/data/materials.png", &pictures);
    if (problem) return fail(problem);
    if (matcher_open(&m, "examples/data/renderer_128.safetensors", &error) != MS_OK ||
        matcher_add_inversions(&m, "examples/data", &error) != MS_OK)
        return fail(error.message);
    if (m.network.size != SIZE) return fail("the renderer makes pictures of another size");
    sheet = image_new(8 * PITCH + BREAK, HEAD + COUNT / 2 * TALL + HEAD, 3);
    planes = (float *)malloc(2 * m.renderer.image_size * sizeof(float));
    if (sheet.pixels == NULL || planes == NULL) return fail("out of memory");
    for (i = 0; i < (int)image_count(&sheet); ++i) sheet.pixels[i] = 1;
    for (i = 0; i < 8; ++i)
        image_text_in(&sheet, i * PITCH + (i > 3 ? (int)BREAK : 0), 5, SIZE, panels[i % 4], 19, ink);
    image_text_in(&sheet, 0, sheet.height - HEAD + 4, sheet.width, foot, 17, ink);
    for (i = 0; i < COUNT; ++i) {
        int left = i % 2 * (4 * PITCH + BREAK), top = HEAD + i / 2 * TALL;
        char text[80];
        ms_pme_match_result result;
        clock_t began;
        problem = edit_tile(&pictures, list[i].source, SIZE, &source);
        if (!problem) problem = edit_tile(&pictures, list[i].other, SIZE, &other);
        if (problem) return fail(problem);
        for (k = 0; strcmp(edits[k].name, list[i].edit) != 0;) ++k;
        if (!edit_apply(&edits[k], &source, &other, &edited)) return fail("out of memory");
        for (y = 0; y < SIZE; ++y)
            for (x = 0; x < 3 * SIZE; ++x)
                sheet.pixels[3 * ((top + y) * sheet.width + left) + x] = source.pixels[3 * SIZE * y + x];
        began = clock();
        if (row(&m, &edited, planes, &sheet, left, top, &result, &error) != MS_OK) return fail(error.message);
        snprintf(text, sizeof text, "%s%s: RMSE %.1f of 255 after %.0f pictures", list[i].edit,
                 list[i].in_part ? "*" : "", 255 * result.rmse, result.cost);
        image_text_in(&sheet, left, top + SIZE + 2, 4 * PITCH, text, 19, ink);
        printf("%-15s RMSE %5.2f of 255 from %5.2f by %s, %.0f ms\n", edits[k].name, 255 * result.rmse,
               255 * result.rmse_initial, m.name[result.best_candidate],
               1e3 * (double)(clock() - began) / CLOCKS_PER_SEC);
        image_free(&source);
        image_free(&other);
        image_free(&edited);
    }
    problem = image_write(argv[1], &sheet);
    if (problem) return fail(problem);
    matcher_close(&m);
    image_free(&pictures);
    image_free(&sheet);
    free(planes);
    return file_end_stdout("demo_match");
}
