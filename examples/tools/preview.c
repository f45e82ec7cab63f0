/* Draws materials with a neural renderer: a gallery sheet, one picture for each row of parameters.

     cc -O2 -I. examples/tools/preview.c -o build/preview -lm
     build/preview WEIGHTS.safetensors PARAMS.csv OUT.png [TRUTH.png]

   WEIGHTS: a network from parameters to a square RGB picture, such as examples/data/renderer_128.safetensors. PARAMS:
   as many columns as the network has inputs, all in [0, 1]; a header line is optional. OUT: .png or .ppm. TRUTH: a
   sheet of rendered pictures of the same size and order, without gaps, such as examples/data/materials.png; then OUT
   shows three blocks - network, truth, and 8 times their difference - and the peak signal-to-noise ratios are
   printed. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "neural.h"
#include "materials.h"
#include <time.h>

static const char usage[] = "usage: preview WEIGHTS.safetensors PARAMS.csv OUT.png [TRUTH.png]\n";

enum { GAP = 2, DIFFERENCE = 8 };

static int fail(const char *what, const char *problem)
{
    fprintf(stderr, "preview: %s: %s\n", what, problem);
    return 1;
}

/* Network, truth and difference side by side in `sheet`, whose first block is drawn already; prints how far they are
   apart. NULL, or what is wrong with the truth. */
static const char *compare(const char *path, int count, int columns, int size, image *sheet)
{
    int pitch = size + GAP, block = columns * pitch, tiles, i, x, y, c;
    double sum = 0, least = 1e30;
    const char *problem;
    image truth, wide;
    problem = image_read(path, &truth);
    if (problem) return problem;
    tiles = truth.width / size;
    if (truth.channels != 3 || truth.width % size || truth.height % size)
        problem = "not an RGB sheet of pictures of the network's size";
    else if (tiles * (truth.height / size) < count) problem = "fewer pictures than there are materials";
    wide = image_new(3 * block + GAP, sheet->height, 3);
    if (!problem && wide.pixels == NULL) problem = "out of memory";
    for (y = 0; !problem && y < sheet->height; ++y) /* the same background and gaps three times */
        for (i = 0; i < 3; ++i)
            memcpy(wide.pixels + 3 * ((size_t)y * (size_t)wide.width + (size_t)(i * block)),
                   sheet->pixels + 3 * (size_t)y * (size_t)sheet->width, 3 * (size_t)sheet->width * sizeof(float));
    for (i = 0; !problem && i < count; ++i) {
        double squares = 0, psnr;
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x)
                for (c = 0; c < 3; ++c) {
                    size_t row = (size_t)(GAP + i / columns * pitch + y),
                           column = (size_t)(GAP + i % columns * pitch + x);
                    float *ours = wide.pixels + 3 * (row * (size_t)wide.width + column) + c;
                    float true_value = truth.pixels[3 *
                                                        ((size_t)(i / tiles * size + y) * (size_t)truth.width +
                                                         (size_t)(i % tiles * size + x)) +
                                                    (size_t)c];
                    float d = *ours - true_value;
                    squares += (double)d * (double)d;
                    ours[3 * block] = true_value;
                    ours[6 * block] = fabsf(d) * (float)DIFFERENCE;
                }
        psnr = squares > 0 ? 10 * log10(3.0 * size * size / squares) : 99;
        sum += psnr;
        if (psnr < least) least = psnr;
    }
    image_free(&truth);
    if (problem) {
        image_free(&wide);
        return problem;
    }
    image_free(sheet);
    *sheet = wide;
    printf("network | truth | %d x difference; PSNR, with the truth's noise: mean %.2f dB, least %.2f dB\n", DIFFERENCE,
           sum / count, least);
    return NULL;
}

int main(int argc, char **argv)
{
    const char *problem;
    materials list;
    neural net;
    image sheet;
    clock_t took;
    int columns = 1;
    if (file_help(argc, argv, usage)) return file_end_stdout("preview");
    if ((argc != 4 && argc != 5) || argv[1][0] == '-') return file_usage(usage);
    if ((problem = neural_load(argv[1], &net)) != NULL) return fail(argv[1], problem);
    if ((problem = materials_read(argv[2], net.parameters, &list)) != NULL) return fail(argv[2], problem);
    while (columns * columns < list.count) ++columns;
    took = clock();
    if ((problem = neural_sheet(&net, list.x, list.count, columns, GAP, &sheet)) != NULL) return fail(argv[2], problem);
    took = clock() - took;
    if (argc == 5 && (problem = compare(argv[4], list.count, columns, net.size, &sheet)) != NULL)
        return fail(argv[4], problem);
    if ((problem = image_write(argv[3], &sheet)) != NULL) return fail(argv[3], problem);
    printf("%d materials, %d x %d pixels, %.2f ms each\n", list.count, net.size, net.size,
           1e3 * (double)took / CLOCKS_PER_SEC / list.count);
    image_free(&sheet);
    materials_free(&list);
    neural_free(&net);
    return file_end_stdout("preview");
}
