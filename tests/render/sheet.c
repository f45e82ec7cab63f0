/* The 64 validation pictures that ship, 8 x 8 tiles, and their parameters, from takes of the held-out materials
   (tests/render/dataset.c):

     sheet OUT_FOLDER TAKE_FOLDER...

   Each take's first 64 pictures count by their samples a pixel. Writes materials.png and materials_64.png (display
   values; averages in linear light, clipped last: clipping noisy pixels would darken them) and materials.csv. */
#include "image.h"

enum { TILES = 64, PARAMETERS = 19, PART = 32 };

static int read_take(const char *folder, int *size, float **sum, float *weight, float x[TILES][PARAMETERS])
{
    int tile;
    unsigned char head[24], two[2];
    char path[1000];
    FILE *f = NULL;
    size_t k;
    for (tile = 0; tile < TILES; ++tile) {
        size_t pixels;
        unsigned samples;
        if (tile % PART == 0) {
            snprintf(path, sizeof path, "%.900s/part_%06u.bin", folder, ((1u << 30) + (unsigned)tile) / PART);
            f = fopen(path, "rb");
            if (f == NULL || fread(head, 1, 24, f) != 24 || memcmp(head, "msds\1\0\0\0", 8) != 0 || head[20] != PART ||
                (*size && *size != head[8] + 256 * head[9]))
                break;
            *size = head[8] + 256 * head[9];
            if (fread(x[tile], sizeof x[tile], PART, f) != PART) break; /* little-endian machines */
        }
        pixels = 3 * (size_t)*size * (size_t)*size;
        samples = head[12] + 256u * head[13];
        if (*sum == NULL) *sum = (float *)calloc(TILES * pixels, sizeof(float));
        for (k = 0; k < pixels && *sum && fread(two, 1, 2, f) == 2; ++k)
            (*sum)[(size_t)tile * pixels + k] += (float)samples * image_from_half((uint16_t)(two[0] | two[1] << 8));
        if (k < pixels) break;
        if (tile == 0) *weight += (float)samples;
        if (tile % PART == PART - 1) fclose(f), f = NULL;
    }
    if (f) fclose(f);
    return tile == TILES;
}

/* Tiles [64][size][size][3], boxed to `side`, as one picture. */
static const char *write_tiles(const char *path, const float *sum, float weight, int size, int side)
{
    image im = image_new(8 * side, 8 * side, 3);
    int box = size / side, y, x, c, j;
    const char *problem;
    for (y = 0; y < 8 * side && im.pixels; ++y)
        for (x = 0; x < 8 * side; ++x)
            for (c = 0; c < 3; ++c) {
                const float *tile = sum +
                    ((size_t)(y / side * 8 + x / side) * (size_t)size * (size_t)size +
                     (size_t)(y % side * box * size + x % side * box)) *
                        3;
                float v = 0;
                for (j = 0; j < box * box; ++j) v += tile[(j / box * size + j % box) * 3 + c];
                im.pixels[(y * 8 * side + x) * 3 + c] = fminf(v / (weight * (float)(box * box)), 1);
            }
    image_to_srgb(&im);
    problem = im.pixels ? image_write(path, &im) : "out of memory";
    image_free(&im);
    return problem;
}

int main(int argc, char **argv)
{
    static float x[TILES][PARAMETERS];
    float *sum = NULL, weight = 0;
    char path[1000];
    const char *problem = NULL;
    FILE *f;
    int size = 0, i, j;
    if (argc < 3) {
        fprintf(stderr, "usage: sheet OUT_FOLDER TAKE_FOLDER...\n");
        return 2;
    }
    for (i = 2; i < argc; ++i)
        if (!read_take(argv[i], &size, &sum, &weight, x)) {
            fprintf(stderr, "sheet: %s: not the held-out materials of a data set, or of another size\n", argv[i]);
            return 1;
        }
    for (i = 0; i < 2 && problem == NULL; ++i) {
        snprintf(path, sizeof path, "%.900s/materials%s.png", argv[1], i ? "_64" : "");
        problem = size % (i ? 64 : 128) ? "pictures of no multiple of this size"
                                        : write_tiles(path, sum, weight, size, i ? 64 : 128);
    }
    free(sum);
    if (problem == NULL) {
        snprintf(path, sizeof path, "%.900s/materials.csv", argv[1]);
        f = fopen(path, "wb");
        if (f == NULL) problem = "cannot be written";
        for (i = 0; i < TILES && f; ++i)
            for (j = 0; j < PARAMETERS; ++j) fprintf(f, "%.6g%s", (double)x[i][j], j + 1 < PARAMETERS ? "," : "\n");
        if (f && (ferror(f) | fclose(f))) problem = "cannot be written";
    }
    if (problem) fprintf(stderr, "sheet: %s: %s\n", path, problem);
    return problem != NULL;
}
