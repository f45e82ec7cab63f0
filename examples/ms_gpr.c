/* A taste, learned from scores: somebody likes the first of five parameters near 0.8 and ignores the others.
     cc -O2 -I. examples/ms_gpr.c -o build/ms_gpr -lm && build/ms_gpr */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include <stdio.h>

enum { SCORED = 60, PARAMETERS = 5, WANTED = 5 };

static double score(const double *x) /* 0 to 10; a person in your tool */
{
    double off = (x[0] - 0.8) / 0.2;
    return off * off < 1 ? 10 * (1 - off * off) : 0;
}

int main(void)
{
    double x[SCORED * PARAMETERS], y[SCORED], found[WANTED * PARAMETERS], mean[WANTED], sigma[WANTED];
    ms_gpr_view nothing = ms_gpr_view_of(NULL); /* of a person who was asked nothing yet */
    ms_gpr *blank, *taste;
    ms_error error;
    ms_status status;
    int i;
    nothing.m = PARAMETERS;
    status = ms_gpr_create(&nothing, NULL, &blank, &error);
    if (status == MS_OK) status = ms_gpr_gallery(blank, NULL, SCORED, x, &error);
    if (status != MS_OK) return puts(error.message), 1;
    ms_gpr_destroy(blank);
    for (i = 0; i < SCORED; ++i) y[i] = score(x + i * PARAMETERS);
    status = ms_gpr_fit(x, y, SCORED, PARAMETERS, NULL, &taste, NULL, &error);
    if (status == MS_OK) status = ms_gpr_recommend(taste, NULL, WANTED, found, mean, sigma, NULL, &error);
    if (status != MS_OK) return puts(error.message), 1;
    for (i = 0; i < WANTED; ++i)
        printf("x0 = %.2f: predicted score %.1f +- %.1f, true score %.1f\n", found[i * PARAMETERS], mean[i], sigma[i],
               score(found + i * PARAMETERS));
    ms_gpr_destroy(taste);
    return 0;
}
