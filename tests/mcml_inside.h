/* An inner call of ms_mcml.h that tests look at: the sums of a tally. Static behind the implementation; in an
   object of its own where the build compiles the header once (tests/run.sh). */
#ifndef TEST_MCML_INSIDE_H
#define TEST_MCML_INSIDE_H
#include "ms_mcml.h"
#include "test.h"
#ifdef TEST_INSIDE /* an object of the header and these functions */
#define TEST_INSIDE_BODY
#elif MS_MCML_IMPLEMENTED + 0 /* 1 by the build, which links such an object; the header defines it as nothing */
#define TEST_INSIDE
#else
#define TEST_INSIDE static TEST_UNUSED
#define TEST_INSIDE_BODY
#endif

#ifdef __cplusplus
extern "C" {
#endif

TEST_INSIDE const int64_t *inside_sums(const ms_mcml *m, int absorbed);

#ifdef TEST_INSIDE_BODY
/* Of light that left above, by ring and angle and with squares; absorbed: of what was, by ring and slab. */
TEST_INSIDE const int64_t *inside_sums(const ms_mcml *m, int absorbed)
{
    return m->sum + (absorbed ? m->at.a : m->at.leave);
}
#endif
#ifdef __cplusplus
}
#endif
#endif
