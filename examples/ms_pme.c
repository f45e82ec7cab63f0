/* From a picture to its parameters: a ball with a highlight is drawn, its picture is made brighter by somebody, and the
   parameters of the nearest picture are found (ms_pme_match). Then a curve through measurements, by residuals and
   derivatives of its own (ms_pme_minimize).
     cc -O2 -I. examples/ms_pme.c -o build/ms_pme -lm && build/ms_pme */
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include <math.h>
#include <stdio.h>

enum { SIDE = 32, PARAMETERS = 3, MEASUREMENTS = 6 };

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

/* Your function: light behind layers of wax, I0 exp(-depth / length); how far it is from each measurement. */
static ms_status wax(void *user, const double *x, double *r, double *jacobian)
{
    static const double depth_mm[MEASUREMENTS] = {0.5, 1, 2, 3, 4, 6};
    static const double measured[MEASUREMENTS] = {0.773, 0.614, 0.382, 0.236, 0.149, 0.058};
    int i;
    (void)user;
    for (i = 0; i < MEASUREMENTS; ++i) {
        double passed = exp(-depth_mm[i] / x[1]);
        r[i] = x[0] * passed - measured[i];
        if (jacobian == NULL) continue;
        jacobian[2 * i] = passed;
        jacobian[2 * i + 1] = x[0] * passed * depth_mm[i] / (x[1] * x[1]);
    }
    return MS_OK;
}

int main(void)
{
    const double source[PARAMETERS] = {0.4, 0.3, 0.5}, shortest[2] = {0, 0.01};
    static float target[SIDE * SIDE], match[SIDE * SIDE];
    ms_pme_renderer renderer = ms_pme_renderer_defaults();
    ms_pme_match_result result;
    ms_pme_function function = {NULL, 2, MEASUREMENTS, wax, 0, 0, NULL, NULL};
    ms_pme_result fit;
    ms_error error;
    double x[PARAMETERS], curve[2] = {1, 1}; /* I0, and the length in mm */
    int i;

    render(NULL, source, target);
    for (i = 0; i < SIDE * SIDE; ++i) target[i] *= 1.5f; /* the edit */
    renderer.parameter_count = PARAMETERS;
    renderer.image_size = SIDE * SIDE;
    renderer.render = render;
    if (ms_pme_match(&renderer, target, NULL, NULL, x, match, &result, &error) != MS_OK) return puts(error.message), 1;
    printf("brightness %.3f, highlight %.3f, sharpness %.3f: RMSE %.4f after %.0f renders\n", x[0], x[1], x[2],
           result.rmse, result.cost);

    function.lower = shortest;
    if (ms_pme_minimize(&function, NULL, curve, &fit, &error) != MS_OK) return puts(error.message), 1;
    printf("wax: %.3f exp(-depth / %.3f mm), RMSE %.4f after %d steps\n", curve[0], curve[1],
           sqrt(fit.value / (int)MEASUREMENTS), (int)fit.steps);
    return !(result.rmse < 0.01 && fit.value < 1e-4);
}
