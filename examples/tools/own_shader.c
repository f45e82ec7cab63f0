/* A shader of one's own, for examples/tools/own_shader.md: lacquered fabric and metal on a ball, under two lamps, in a
   few lines.

     cc -O2 -I. examples/tools/own_shader.c -o build/own_shader -lm
     build/own_shader FOLDER COUNT [SIZE 64] [SEED 1]

   Writes COUNT pictures of random materials, FOLDER/00000.png and so on, and FOLDER.csv: a line of names, then a
   material in each line. This is the only file to replace: pictures and a table are all that build/train wants to know
   of a shader. */
#include "image.h"
#include <math.h>

enum { PARAMETERS = 10 };
static const char names[] =
    "base red,base green,base blue,sheen red,sheen green,sheen blue,sheen,roughness,metal,lacquer";
static const char usage[] = "usage: own_shader FOLDER COUNT [SIZE 64] [SEED 1]\n";

static double random_number(unsigned long *state) /* in [0, 1): a linear congruential generator's high bits */
{
    *state = (*state * 1103515245ul + 12345ul) & 0xfffffffful;
    return (double)(*state >> 8) / 16777216.0;
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void unit(double *a)
{
    double s = 1 / sqrt(dot(a, a));
    int k;
    for (k = 0; k < 3; ++k) a[k] *= s;
}

/* Linear light of the point (u, v) in [-1, 1]^2. */
static void shade(const double *x, double u, double v, double *rgb)
{
    static const double lamp[2][3] = {{-0.55, 0.6, 0.58}, {0.75, 0.15, 0.55}}, power[2] = {2.2, 0.8};
    double r2 = u * u + v * v, n[3], alpha = 0.06 + 0.6 * x[7] * x[7];
    int c, k;
    if (r2 >= 0.8) { /* the wall behind, darker towards its bottom, and the ball's shadow on it */
        double d = (u - 0.35) * (u - 0.35) + (v + 0.45) * (v + 0.45);
        for (c = 0; c < 3; ++c) rgb[c] = (0.28 + 0.1 * v) * (1 - 0.6 * exp(-1.5 * d));
        return;
    }
    n[0] = u / sqrt(0.8);
    n[1] = v / sqrt(0.8);
    n[2] = sqrt(1 - r2 / 0.8);
    for (c = 0; c < 3; ++c) rgb[c] = (0.10 + 0.08 * n[1]) * x[c] * (1 - 0.5 * x[8]);
    for (k = 0; k < 2; ++k) {
        double h[3], cosine = dot(n, lamp[k]), edge, lobe, coat;
        h[0] = lamp[k][0], h[1] = lamp[k][1], h[2] = lamp[k][2] + 1; /* the eye is far along z */
        unit(h);
        cosine = cosine > 0 ? cosine : 0;
        edge = pow(1 - n[2], 4);
        lobe = exp((dot(n, h) - 1) * 2 / (alpha * alpha)) / (0.2 + 4 * alpha);
        coat = exp((dot(n, h) - 1) * 700);
        for (c = 0; c < 3; ++c)
            rgb[c] += power[k] * cosine *
                    ((1 - x[8]) * x[c] / 3.14159 + (0.05 + 0.95 * x[8] * x[c]) * lobe * 0.4 + x[9] * coat * 1.5) +
                power[k] * x[6] * x[3 + c] * edge * (0.2 + 0.8 * cosine);
    }
}

int main(int argc, char **argv)
{
    int count = argc > 2 ? atoi(argv[2]) : 0, size = argc > 3 ? atoi(argv[3]) : 64, i, j, c, s, px, py;
    unsigned long state = argc > 4 ? strtoul(argv[4], NULL, 10) : 1;
    char path[1000];
    file_out table;
    const char *problem = NULL;
    if (file_help(argc, argv, usage)) return file_end_stdout("own_shader");
    if (argc < 3 || argc > 5 || count < 1 || count > 99999 || size < 4 || size > 2048) return file_usage(usage);
    snprintf(path, sizeof path, "%.960s.csv", argv[1]);
    if (file_create(path, &table) == NULL) {
        fprintf(stderr, "own_shader: %s: %s\n", path, table.problem);
        return 1;
    }
    fprintf(table.f, "%s\n", names);
    for (i = 0; i < count && !problem; ++i) {
        image im = image_new(size, size, 3);
        double x[PARAMETERS], rgb[3];
        char number[48];
        if (im.pixels == NULL) problem = "out of memory";
        for (j = 0; j < PARAMETERS; ++j) {
            x[j] = floor(1e6 * random_number(&state)) / 1e6;
            fprintf(table.f, "%s%s", number_text(number, "%.6f", x[j]), j + 1 < PARAMETERS ? "," : "\n");
        }
        for (py = 0; py < size && !problem; ++py)
            for (px = 0; px < size; ++px)
                for (s = 0; s < 9; ++s) { /* 3 x 3 samples a pixel */
                    shade(x, 2 * (px + (s % 3 + 0.5) / 3) / size - 1, 1 - 2 * (py + (s / 3 + 0.5) / 3) / size, rgb);
                    for (c = 0; c < 3; ++c) im.pixels[3 * (py * size + px) + c] += (float)(rgb[c] / 9);
                }
        if (!problem) {
            image_to_srgb(&im);
            snprintf(path, sizeof path, "%.960s/%05d.png", argv[1], i);
            problem = image_write(path, &im);
        }
        image_free(&im);
    }
    if (problem) {
        (void)file_finish(&table, 0);
        fprintf(stderr, "own_shader: %s: %s\n", path, problem);
        return 1;
    }
    problem = file_finish(&table, 1);
    if (problem) fprintf(stderr, "own_shader: %s.csv: %s\n", argv[1], problem);
    return problem ? 1 : file_end_stdout("own_shader");
}
