/* A sheet of materials of the extended shader: gallery OUT.png [SIZE 128] [SAMPLES 64] [SEED 1]

     sh tests/package.sh tests/render/gallery.c build/gallery && build/gallery build/gallery.png

   Each of four rows starts with a random material of 19 parameters; five random textures and reliefs of it follow. */
#define MS_SSS_IMPLEMENTATION /* for the random numbers that all headers share */
#include "ms_sss.h"
#include "image.h"
#include "render/material.h"

enum { ROWS = 4, COLUMNS = 6 };

int main(int argc, char **argv)
{
    int size = argc > 2 ? atoi(argv[2]) : 128, samples = argc > 3 ? atoi(argv[3]) : 64, row, column, y, k;
    ms__rng rng = ms__rng_make(argc > 4 ? (uint64_t)atoi(argv[4]) : 1, 0);
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
        float x[MATERIAL_EXTENDED];
        for (k = 0; k < MATERIAL_PARAMETERS; ++k) x[k] = (float)ms__rng_uniform(&rng);
        x[7] = x[7] < 0.5f ? 0.2f : 1; /* lacquer or metal */
        x[16] = x[16] < 0.5f ? 0.0f : 0.7f;
        x[17] = (float)(row % 2); /* opaque and transmissive ones in turn */
        x[11] *= 0.3f;
        x[18] *= 0.3f;
        memset(x + MATERIAL_PARAMETERS, 0, (MATERIAL_EXTENDED - MATERIAL_PARAMETERS) * sizeof *x);
        for (column = 0; column < COLUMNS && problem == NULL; ++column) {
            image tile;
            for (k = MATERIAL_PARAMETERS; k < MATERIAL_EXTENDED && column > 0; ++k) x[k] = (float)ms__rng_uniform(&rng);
            if (!material_render_extended(s, x, size, size, samples, (uint32_t)(row * COLUMNS + column), &tile)) problem = "no memory";
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
