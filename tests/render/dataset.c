/* Pairs of material and picture for training: dataset FOLDER FIRST COUNT [SIZE] [SAMPLES] [TAKE]

   Material i is a function of i alone, so that any range can be made anywhere: jobs on several machines take ranges of
   indices, their folders are copied together. 32 pictures go to a file part_NNNNNN.bin (NNNNNN = first index / 32),
   which appears under its name only when it is whole: start again after an interruption and what is there is skipped.
   The last file of a COUNT that is no multiple of 32 holds fewer, and is made again when more of it are asked for.

   A file: "msds", then little-endian u32: version 1, size, samples, first index, pictures n; then n times 19 f32
   parameters; then n times size x size x 3 f16, linear radiance, top row first.

   Even materials are uniform in [0, 1]^19. Odd ones are sharp: the three mix factors (x7, x16, x17) are 0 or 1. Every
   fourth one (i = 1 mod 4) has glass of low roughness: x11 = 0.3 u^2. Indices from 2^30 on are the held-out ones.
   Pictures of the same materials with another TAKE (0) have independent noise: the mean of (p - a)(p - b) over two
   takes a and b is the squared error of p without the noise. */
#include "image.h"
#include "render/material.h"
#include "render/random.h"

enum { PART = 32 };

static void choose_material(uint32_t index, float x[MATERIAL_PARAMETERS])
{
    random_stream rng = random_start(20190501, index);
    int k;
    for (k = 0; k < MATERIAL_PARAMETERS; ++k) x[k] = (float)random_uniform(&rng);
    if (index % 2 == 1) {
        static const int mixes[3] = {7, 16, 17};
        for (k = 0; k < 3; ++k) x[mixes[k]] = x[mixes[k]] < 0.5f ? 0.0f : 1.0f;
    }
    if (index % 4 == 1) x[11] = 0.3f * x[11] * x[11];
}

static void put_u32(FILE *f, uint32_t v)
{
    int k;
    for (k = 0; k < 4; ++k) fputc((int)(v >> 8 * k & 255), f);
}

/* How many pictures a file holds, from its header; 0: there is no such file. */
static uint32_t pictures_in(const char *path)
{
    unsigned char header[24];
    FILE *f = fopen(path, "rb");
    size_t got = f ? fread(header, 1, sizeof header, f) : 0;
    if (f) fclose(f);
    return got == sizeof header ? header[20] | (uint32_t)header[21] << 8 : 0;
}

/* One file of n pictures; 0 where it could not be written. */
static int write_part(const material_scene *stage, const char *folder, uint32_t first, uint32_t n, int size,
                      int samples, uint32_t take)
{
    char path[1024], temporary[1040];
    FILE *f;
    float x[MATERIAL_PARAMETERS];
    uint32_t i, bits;
    int k, bad;
    size_t p;
    snprintf(path, sizeof path, "%s/part_%06u.bin", folder, (unsigned)(first / PART));
    snprintf(temporary, sizeof temporary, "%s.part", path);
    if (pictures_in(path) >= n) return 1;
    f = fopen(temporary, "wb");
    if (f == NULL) return 0;
    fputs("msds", f);
    put_u32(f, 1);
    put_u32(f, (uint32_t)size);
    put_u32(f, (uint32_t)samples);
    put_u32(f, first);
    put_u32(f, n);
    for (i = 0; i < n; ++i) {
        choose_material(first + i, x);
        for (k = 0; k < MATERIAL_PARAMETERS; ++k) {
            memcpy(&bits, &x[k], 4);
            put_u32(f, bits);
        }
    }
    for (i = 0; i < n; ++i) {
        image picture;
        choose_material(first + i, x);
        if (!material_render(stage, x, size, size, samples, (first + i) ^ trace__hash(take), &picture)) break;
        for (p = 0; p < image_count(&picture); ++p) {
            uint16_t h = image_to_half(picture.pixels[p] > 0 ? picture.pixels[p] : 0);
            fputc(h & 255, f);
            fputc(h >> 8, f);
        }
        image_free(&picture);
    }
    bad = i < n || ferror(f);
    bad |= fclose(f) != 0;
    if (bad || rename(temporary, path) != 0) {
        remove(temporary);
        return 0;
    }
    printf("%s\n", path);
    fflush(stdout);
    return 1;
}

int main(int argc, char **argv)
{
    unsigned long first = argc > 3 ? strtoul(argv[2], NULL, 10) : 1, count = argc > 3 ? strtoul(argv[3], NULL, 10) : 0,
                  i;
    int size = argc > 4 ? atoi(argv[4]) : 128, samples = argc > 5 ? atoi(argv[5]) : 32,
        take = argc > 6 ? atoi(argv[6]) : 0;
    material_scene *stage;
    if (argc < 4 || argc > 7 || first % PART || count < 1 || first + count > 0xfffffff0ul || size < 1 || size > 4096 ||
        samples < 1 || take < 0) {
        fprintf(stderr,
                "usage: dataset FOLDER FIRST COUNT [SIZE 128] [SAMPLES 32] [TAKE 0]   (FIRST a multiple of %d)\n",
                PART);
        return 2;
    }
    stage = material_scene_create(1);
    if (stage == NULL) {
        fprintf(stderr, "dataset: Embree or memory failed\n");
        return 1;
    }
    for (i = first; i < first + count; i += PART)
        if (!write_part(stage, argv[1], (uint32_t)i, (uint32_t)(first + count - i < PART ? first + count - i : PART),
                        size, samples, (uint32_t)take)) {
            fprintf(stderr, "dataset: cannot write to %s\n", argv[1]);
            material_scene_destroy(stage);
            return 1;
        }
    material_scene_destroy(stage);
    return 0;
}
