/* An inner call of ms_pme.h that tests look at: the linear problem in a box. Static behind the implementation; in an
   object of its own where the build compiles the header once (tests/run.sh). */
#ifndef TEST_PME_INSIDE_H
#define TEST_PME_INSIDE_H
#include "ms_pme.h"
#include "test.h"
#ifdef TEST_INSIDE /* an object of the header and these functions */
#define TEST_INSIDE_BODY
#elif MS_PME_IMPLEMENTED + 0 /* 1 by the build, which links such an object; the header defines it as nothing */
#define TEST_INSIDE
#else
#define TEST_INSIDE static TEST_UNUSED
#define TEST_INSIDE_BODY
#endif

#ifdef __cplusplus
extern "C" {
#endif

TEST_INSIDE void inside_bounded_least_squares(const double *triangle, int n, const double *low, const double *high,
                                              double *d, int *state);

#ifdef TEST_INSIDE_BODY
TEST_INSIDE void inside_bounded_least_squares(const double *triangle, int n, const double *low, const double *high,
                                              double *d, int *state)
{
    enum { MOST = 16, ROWS = 32 };
    const double weight[MOST] = {0};
    double z[MOST], work[(MOST + 1) * (MOST + 1 + ROWS)];
    ms_pme__bounded_least_squares(triangle, n, weight, low, high, d, state, z, work);
}
#endif
#ifdef __cplusplus
}
#endif
#endif
