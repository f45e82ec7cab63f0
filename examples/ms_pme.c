/* From a picture to its parameters: a ball with a highlight is drawn, its picture is made brighter by somebody, and the
   parameters of the nearest picture are found.
     cc -O2 -I. examples/ms_pme.c -o build/ms_pme -lm && build/ms_pme */
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include <math.h>
#include <stdio.h>

enum { SIDE = 32, PARAMETERS = 3 };

/* Your renderer: x = brightness, strength of the highlight, its sharpness, each from 0 to 1. */
static ms_status render(void *user, const double *x, float *picture)
{
    int i;
    (void)user;
    for (i = 0; i < SIDE * SIDE; ++i) {
        double u = (2 * (i % SIDE) + 1) / (double)SIDE - 1, v = (2 * (i / SIDE) + 1) / (double)SIDE - 1,
               r = u * u + v * v;
        double lit = r < 1 ? 0.5 * sqrt(1 - r) - 0.4 * u - 0.4 * v : 0;
        picture[i] = lit > 0 ? (float)(x[0] * lit + x[1] * pow(lit, 2 + 30 * x[2])) : 0;
    }
    return MS_OK;
}

int main(void)
{
    const double source[PARAMETERS] = {0.4, 0.3, 0.5};
    static float target[SIDE * SIDE], match[SIDE * SIDE];
    ms_pme_renderer renderer = ms_pme_renderer_defaults();
    ms_pme_match_result result;
    ms_error error;
    double x[PARAMETERS];
    int i;
    render(NULL, source, target);
    for (i = 0; i < SIDE * SIDE; ++i) target[i] *= 1.5f; /* the edit */
    renderer.parameter_count = PARAMETERS;
    renderer.image_size = SIDE * SIDE;
    renderer.render = render;
    if (ms_pme_match(&renderer, target, NULL, NULL, x, match, &result, &error) != MS_OK) return puts(error.message), 1;
    printf("brightness %.3f, highlight %.3f, sharpness %.3f: RMSE %.4f after %.0f renders\n", x[0], x[1], x[2],
           result.rmse, result.cost);
    return !(result.rmse < 0.01);
}
