/* 60 edited pictures of the held-out materials of examples/data, 64 x 64, for the match's tests and benchmarks: each of
   the 13 further edits of examples/demo/edits.h of three materials, and 21 by the thesis's ten; and the same of 60
   other materials, for a check: of the header only the halving's schedule was chosen with a look at them.
   tests/data/pme_targets.csv holds the least RMSE known for each, from `build/bench/bench_pme --known`. */
#ifndef MS_BENCH_TARGETS_H
#define MS_BENCH_TARGETS_H
#include "edits.h"

enum { TARGETS_COUNT = 60, TARGETS_CHECK = 60, TARGETS_ALL = 120, TARGETS_SIZE = 64 };

static const edit *targets_edit(int t)
{
    t %= TARGETS_COUNT;
    return t < 39 ? &edits_further[t % EDIT_FURTHER_COUNT] : &edits[(t - 39) % EDIT_COUNT];
}

/* Planes [3][64][64] of target t; sheet: examples/data/materials.png. NULL, or what went wrong. */
static const char *targets_make(const image *sheet, int t, float *planes)
{
    image a, b, c;
    int k;
    size_t i, pixels = TARGETS_SIZE * TARGETS_SIZE;
    const char *problem = edit_tile(sheet, (t < TARGETS_COUNT ? 7 * t + 3 : 13 * t + 5) % 64, TARGETS_SIZE, &a);
    if (problem == NULL)
        problem = edit_tile(sheet, (t < TARGETS_COUNT ? 11 * t + 30 : 5 * t + 30) % 64, TARGETS_SIZE, &b);
    if (problem == NULL && !edit_apply(targets_edit(t), &a, &b, &c)) problem = "out of memory";
    if (problem) return problem;
    for (k = 0; k < 3; ++k)
        for (i = 0; i < pixels; ++i) *planes++ = c.pixels[3 * i + (size_t)k];
    image_free(&a);
    image_free(&b);
    image_free(&c);
    return NULL;
}
#endif
