/* A neural renderer: the 19 parameters of a material become its picture.
     cc -O2 -I. examples/ms_nn.c -o build/ms_nn -lm && build/ms_nn examples/data/renderer_128.safetensors ball.ppm */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PARAMETERS = 19 };

int main(int argc, char **argv)
{
    /* blue glass; examples/data/README.md names the parameters */
    const float x[PARAMETERS] = {0.5f,  0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.3f,  0,     0.35f, 0.6f,
                                 0.95f, 0.1f, 0.5f, 0.5f, 0.5f, 0.5f, 0.05f, 0.95f, 0.1f};
    ms_nn *network;
    ms_error error;
    float *picture; /* three planes: all red, all green, all blue values, as displayed */
    FILE *file;
    size_t pixels, i, c;
    unsigned side;
    if (argc != 3) return fprintf(stderr, "usage: ms_nn RENDERER.safetensors OUT.ppm\n"), 2;
    if (ms_nn_load_file(argv[1], NULL, &network, &error) != MS_OK) return fprintf(stderr, "%s\n", error.message), 1;
    pixels = ms_nn_output_size(network) / 3;
    side = (unsigned)sqrt((double)pixels);
    picture = (float *)malloc(3 * pixels * sizeof *picture);
    file = fopen(argv[2], "wb");
    if (ms_nn_input_size(network) != PARAMETERS || !picture || !file) return 1;
    if (ms_nn_forward(network, 1, x, picture, NULL) != MS_OK) return 1;
    fprintf(file, "P6 %u %u 255\n", side, side);
    for (i = 0; i < pixels; ++i)
        for (c = 0; c < 3; ++c) fputc((int)(255 * fminf(fmaxf(picture[c * pixels + i], 0), 1) + 0.5f), file);
    printf("%u x %u pixels\n", side, side);
    free(picture);
    ms_nn_destroy(network);
    return fclose(file) != 0;
}
