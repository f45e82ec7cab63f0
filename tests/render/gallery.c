/* A sheet of materials of the extended shader: gallery OUT.png [SIZE 128] [SAMPLES 64] [SEED 1]

     sh tests/package.sh tests/render/gallery.c build/gallery && build/gallery build/gallery.png

   Rows start with a material of 19 parameters; then lacquer with textures, glass with textures, metal with reliefs, and
   all of it by chance. */
#include "image.h"
#include "render/material.h"
#include "render/random.h"

enum { ROWS = 4, COLUMNS = 6, SETTINGS = 9 };

typedef struct setting {
    int parameter;
    float value;
} setting;

/* A parameter 0 ends a list. */
static const setting base[ROWS][16] = {
    {{0, 0}, {1, 0.10f}, {2, 0.30f}, {3, 0.9f}, {4, 0.9f}, {5, 0.9f}, {6, 0.15f}, {7, 0.25f}},
    {{8, 0.95f}, {9, 0.98f}, {10, 0.95f}, {11, 0.05f}, {12, 0.5f}, {13, 0.9f}, {14, 0.9f}, {15, 0.9f}, {17, 1}},
    {{3, 0.95f}, {4, 0.70f}, {5, 0.35f}, {6, 0.3f}, {7, 1}},
    {{0, 0.7f}, {1, 0.6f}, {2, 0.5f}, {3, 0.9f}, {4, 0.8f}, {5, 0.7f}, {6, 0.3f}, {7, 0.5f}}};
static const setting more[ROWS][COLUMNS - 1][SETTINGS] = {
    {{{19, 0.9f}, {20, 0.75f}, {21, 0.4f}, {22, 1}, {23, 0.2f}, {24, 0.7f}, {25, 0.3f}, {26, 0.5f}}, /* clouds */
     {{19, 0.9f}, {20, 0.75f}, {21, 0.4f}, {22, 1}, {23, 0.5f}, {24, 0.5f}, {25, 1}, {26, 0.5f}},    /* patches */
     {{19, 0.9f}, {20, 0.75f}, {21, 0.4f}, {22, 1}, {23, 0.5f}, {25, 0.95f}, {26, 0.5f}, {27, 1}},   /* spots */
     {{19, 0.9f}, {20, 0.75f}, {21, 0.4f}, {22, 1}, {23, 0.3f}, {24, 0.8f}, {25, 0.9f}, {26, 0.5f}, {28, 1}},  /* veins
                                                                                                                */
     {{19, 0.5f}, {20, 0.3f}, {21, 0.15f}, {22, 1}, {23, 0.4f}, {24, 0.9f}, {25, 0.8f}, {26, 0.5f}, {30, 1}}}, /* rust
                                                                                                                */
    {{{23, 0.2f}, {24, 0.5f}, {25, 0.8f}, {26, 0.5f}, {29, 1}}, /* etched */
     {{23, 0.5f}, {25, 0.9f}, {26, 0.45f}, {27, 1}, {29, 1}},
     {{19, 0.1f}, {20, 0.3f}, {21, 0.9f}, {22, 1}, {23, 0.3f}, {24, 0.6f}, {25, 0.5f}, {26, 0.5f}, {28, 1}}, /* streaks
                                                                                                              */
     {{23, 0.3f}, {24, 0.5f}, {25, 0.9f}, {26, 0.5f}, {30, 1}}, /* painted */
     {{19, 0.9f}, {20, 0.2f}, {21, 0.2f}, {22, 1}, {23, 0.5f}, {25, 1}, {26, 0.4f}, {27, 1}, {30, 1}}},
    {{{31, 0.8f}, {32, 0.2f}},             /* rolling */
     {{31, 0.8f}, {32, 0.3f}, {33, 0.8f}}, /* rocky */
     {{31, 0.8f}, {32, 0.3f}, {34, 1}},    /* ridged */
     {{35, 0.8f}, {36, 0.4f}},             /* pits */
     {{35, 0.8f}, {36, 0.4f}, {37, 1}}}};  /* pebbles */

static void apply(const setting *list, int limit, float x[MATERIAL_EXTENDED])
{
    int k;
    for (k = 0; k < limit && (k == 0 || list[k].parameter); ++k) x[list[k].parameter] = list[k].value;
}

int main(int argc, char **argv)
{
    int size = argc > 2 ? atoi(argv[2]) : 128, samples = argc > 3 ? atoi(argv[3]) : 64, row, column, y, k;
    random_stream rng = random_start(argc > 4 ? (uint64_t)atoi(argv[4]) : 1, 0);
    const char *problem;
    material_scene *s;
    image sheet;
    if (argc < 2 || argc > 5 || size < 1 || size > 1024 || samples < 1) {
        fprintf(stderr, "usage: gallery OUT.png [SIZE 128] [SAMPLES 64] [SEED 1]\n");
        return 2;
    }
    s = material_scene_create(1);
    sheet = image_new(COLUMNS * size, ROWS * size, 3);
    problem = s && sheet.pixels ? NULL : "Embree or memory failed";
    for (row = 0; row < ROWS && problem == NULL; ++row) {
        for (column = 0; column < COLUMNS && problem == NULL; ++column) {
            float x[MATERIAL_EXTENDED];
            image tile;
            memset(x, 0, sizeof x);
            apply(base[row], 16, x);
            if (column > 0 && row < ROWS - 1) apply(more[row][column - 1], SETTINGS, x);
            for (k = MATERIAL_PARAMETERS; k < MATERIAL_EXTENDED && column > 0 && row == ROWS - 1; ++k)
                x[k] = (float)random_uniform(&rng);
            if (!material_render_extended(s, x, size, size, samples, (uint32_t)(row * COLUMNS + column), &tile))
                problem = "no memory";
            for (y = 0; y < size && problem == NULL; ++y)
                memcpy(sheet.pixels + 3 * ((size_t)(row * size + y) * (size_t)sheet.width + (size_t)(column * size)),
                       tile.pixels + 3 * (size_t)y * (size_t)size, 3 * (size_t)size * sizeof(float));
            image_free(&tile);
        }
    }
    image_to_srgb(&sheet);
    if (problem == NULL) problem = image_write(argv[1], &sheet);
    if (problem) fprintf(stderr, "gallery: %s: %s\n", argv[1], problem);
    material_scene_destroy(s);
    image_free(&sheet);
    return problem != NULL;
}
