#pragma once
#include "crt.h"
#define CRT_1(name)          \
    CRT double name(double); \
    CRT float name##f(float);
#define CRT_2(name)                  \
    CRT double name(double, double); \
    CRT float name##f(float, float);
/* clang-format off */
CRT_1(fabs) CRT_1(sqrt) CRT_1(cbrt) CRT_1(exp) CRT_1(exp2) CRT_1(expm1) CRT_1(log) CRT_1(log2) CRT_1(log10)
CRT_1(log1p) CRT_1(sin) CRT_1(cos) CRT_1(tan) CRT_1(asin) CRT_1(acos) CRT_1(atan) CRT_1(sinh) CRT_1(cosh) CRT_1(tanh)
CRT_1(asinh) CRT_1(acosh) CRT_1(atanh) CRT_1(floor) CRT_1(ceil) CRT_1(round) CRT_1(trunc) CRT_1(rint) CRT_1(nearbyint)
CRT_1(erf) CRT_1(erfc) CRT_1(lgamma) CRT_1(tgamma) CRT_2(pow) CRT_2(fmod) CRT_2(atan2) CRT_2(hypot) CRT_2(fmin)
CRT_2(fmax) CRT_2(copysign) CRT_2(nextafter)
    /* clang-format on */
    CRT double ldexp(double, int);
CRT double frexp(double, int *);
CRT double modf(double, double *);
CRT double fma(double, double, double);
CRT float fmaf(float, float, float);
CRT float ldexpf(float, int);
CRT long lround(double);
CRT long long llround(double);
#define INFINITY ((float)(1e300 * 1e300))
#define NAN ((float)(INFINITY * 0.0F))
#define HUGE_VAL ((double)INFINITY)
#define isnan(x) ((x) != (x))
#define isfinite(x) ((x) - (x) == 0)
#define isinf(x) ((x) == (x) && !isfinite(x))
