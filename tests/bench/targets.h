/* Edited pictures of the held-out materials of examples/data, 64 x 64, for the benchmarks of the match, in four sets.
   Sets 0 and 1, 60 targets each: each of the 13 further edits of examples/demo/edits.h of three materials, and 21 by
   the thesis's ten; set 1 has other materials. Sets 2 and 3, 48 targets each: twelve other kinds of edits, four of
   each, whose place, strength and color come from a seed a target; set 3 has other seeds. Sets 1 and 3 are a check:
   nothing was chosen with a look at them. tests/data/pme_targets.csv has the least RMSE known for each, from
   `build/bench/bench_pme --known`. */
#ifndef MS_BENCH_TARGETS_H
#define MS_BENCH_TARGETS_H
#include "edits.h"

enum { TARGETS_SETS = 4, TARGETS_KINDS = 12, TARGETS_ALL = 216, TARGETS_SIZE = 64 };
static const int targets_count[TARGETS_SETS] = {60, 60, 48, 48};
static const char *const targets_kind[TARGETS_KINDS] = {
    "hue",   "contrast",     "vignette", "noise",      "crop",          "painted highlights",
    "gamma", "color filter", "blur",     "sharpening", "brush strokes", "local brightness"};

/* Uniform in (low, high): the next number of a seed (PCG, O'Neill 2014). */
static float targets_random(uint64_t *state, float low, float high)
{
    uint32_t word, turn;
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    word = (uint32_t)(((*state >> 18) ^ *state) >> 27);
    turn = (uint32_t)(*state >> 59);
    word = (word >> turn) | (word << ((32 - turn) & 31));
    return low + (high - low) * ((float)(word >> 8) + 0.5f) / 16777216.0f;
}

/* Edits of each pixel's color, on the ball or everywhere. */
static void targets_tone(image *im, int kind, int on_ball, uint64_t *state)
{
    float amount = targets_random(state, 0, 1), sign = targets_random(state, -1, 1) < 0 ? -1.0f : 1.0f, tint[3];
    float angle = 6.2831853f * (0.08f + 0.84f * amount), cosine = cosf(angle), sine = sinf(angle) * 0.57735027f;
    int x, y, c;
    for (c = 0; c < 3; ++c) tint[c] = targets_random(state, 0.4f, 1);
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), t = on_ball ? edit_ball(im, x, y, 0, 0) : 1, v[3], gray,
                  u = ((float)x + 0.5f) / (float)im->width - 0.5f, w = ((float)y + 0.5f) / (float)im->height - 0.5f;
            gray = (p[0] + p[1] + p[2]) / 3;
            for (c = 0; c < 3; ++c) {
                if (kind == 0) /* a turn around the gray axis */
                    v[c] = gray + cosine * (p[c] - gray) + sine * (p[(c + 2) % 3] - p[(c + 1) % 3]);
                else if (kind == 1) v[c] = 0.5f + (1 + sign * (0.2f + 0.5f * amount)) * (p[c] - 0.5f);
                else if (kind == 2) v[c] = p[c] * (1 - (0.6f + 1.4f * amount) * (u * u + w * w));
                else if (kind == 6) v[c] = powf(p[c], sign < 0 ? 1 / (1.2f + amount) : 1.2f + amount);
                else v[c] = p[c] * tint[c];
            }
            for (c = 0; c < 3; ++c) p[c] += t * (edit__clip(v[c]) - p[c]);
        }
}

/* Discs with a soft edge: bright highlights, colored strokes (rows of discs), or darker and brighter places. */
static void targets_paint(image *im, int kind, uint64_t *state)
{
    int count = 1 + (int)targets_random(state, 0, 3), steps = kind == 10 ? 12 : 1, i, k, x, y, c;
    for (i = 0; i < count; ++i) {
        float u = targets_random(state, -0.22f, 0.22f), v = targets_random(state, -0.25f, 0.15f), color[3];
        float r = targets_random(state, 0.02f, 0.06f) * (kind == 11 ? 4 : 1),
              way = targets_random(state, 0, 6.2831853f);
        float opacity = targets_random(state, 0.5f, 1), gain = targets_random(state, 0, 1) < 0.5f ? 0.5f : 1.5f;
        for (c = 0; c < 3; ++c) color[c] = kind == 5 ? 1 : targets_random(state, 0, 1);
        for (k = 0; k < steps; ++k, u += 0.5f * r * cosf(way), v += 0.5f * r * sinf(way))
            for (y = 0; y < im->height; ++y)
                for (x = 0; x < im->width; ++x) {
                    float dx = ((float)x + 0.5f) / (float)im->width - 0.5f - u,
                          dy = ((float)y + 0.5f) / (float)im->height - 0.457f - v, *p;
                    float t = edit__clip(1.5f - sqrtf(dx * dx + dy * dy) / r) * opacity * edit_ball(im, x, y, 0, 0);
                    p = im->pixels + 3 * (y * im->width + x);
                    for (c = 0; c < 3; ++c) p[c] += t * ((kind == 11 ? edit__clip(gain * p[c]) : color[c]) - p[c]);
                }
    }
}

/* Mixes a Gaussian blur of standard deviation `sigma` pixels in; a negative amount sharpens. */
static int targets_blur(image *im, float sigma, float amount)
{
    image from = image_new(im->width, im->height, 3);
    int x, y, c, u, v, r = (int)(3 * sigma) + 1;
    if (from.pixels == NULL) return 0;
    memcpy(from.pixels, im->pixels, image_count(im) * sizeof(float));
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float sum[3] = {0, 0, 0}, total = 0, *p = im->pixels + 3 * (y * im->width + x);
            for (v = y - r; v <= y + r; ++v)
                for (u = x - r; u <= x + r; ++u) {
                    float weight = expf(-0.5f * (float)((u - x) * (u - x) + (v - y) * (v - y)) / (sigma * sigma));
                    if (u < 0 || v < 0 || u >= im->width || v >= im->height) continue;
                    for (c = 0; c < 3; ++c) sum[c] += weight * from.pixels[3 * (v * im->width + u) + c];
                    total += weight;
                }
            for (c = 0; c < 3; ++c) p[c] = edit__clip(p[c] + amount * (sum[c] / total - p[c]));
        }
    image_free(&from);
    return 1;
}

/* The edit of one of the twelve kinds by its seed. 0: out of memory. */
static int targets_apply(image *im, int kind, uint64_t seed)
{
    uint64_t state = (seed + 1) * 0x9E3779B97F4A7C15u;
    float sigma, deviation, noise;
    size_t i;
    int k;
    targets_random(&state, 0, 1);
    switch (kind) {
    case 3:
        deviation = targets_random(&state, 0.03f, 0.15f);
        for (i = 0; i < image_count(im); ++i) {
            for (k = 0, noise = -2; k < 4; ++k) noise += targets_random(&state, 0, 1);
            im->pixels[i] = edit__clip(im->pixels[i] + deviation * 1.7320508f * noise);
        }
        return 1;
    case 4:
        sigma = targets_random(&state, 0.75f, 0.97f);
        deviation = targets_random(&state, -2, 2);
        edit__frame(im, sigma, deviation, targets_random(&state, -2, 2));
        return 1;
    case 8: return targets_blur(im, targets_random(&state, 0.6f, 2.5f), 1);
    case 9: return targets_blur(im, targets_random(&state, 0.6f, 1.5f), -targets_random(&state, 0.5f, 2));
    case 5:
    case 10:
    case 11: targets_paint(im, kind, &state); return 1;
    default: targets_tone(im, kind, kind == 0 || targets_random(&state, 0, 1) < 0.5f, &state); return 1;
    }
}

/* Its set, and its number in the set. */
static int targets_set(int t, int *number)
{
    int set = 0;
    while (set + 1 < TARGETS_SETS && t >= targets_count[set]) t -= targets_count[set++];
    *number = t;
    return set;
}

static inline const char *targets_name(int t)
{
    int k, set = targets_set(t, &k);
    return set > 1 ? targets_kind[k % TARGETS_KINDS]
        : k < 39   ? edits_further[k % EDIT_FURTHER_COUNT].name
                   : edits[(k - 39) % EDIT_COUNT].name;
}

/* Planes [3][64][64] of target t of all sets; sheet: examples/data/materials.png. NULL, or what went wrong. */
static const char *targets_make(const image *sheet, int t, float *planes)
{
    static const int step[TARGETS_SETS][4] = {{7, 3, 11, 30}, {13, 785, 5, 330}, {9, 2, 0, 0}, {19, 11, 0, 0}};
    image a, b, c;
    int k, set = targets_set(t, &k), channel;
    size_t i, pixels = TARGETS_SIZE * TARGETS_SIZE;
    const char *problem = edit_tile(sheet, (step[set][0] * k + step[set][1]) % 64, TARGETS_SIZE, &a);
    if (problem == NULL) problem = edit_tile(sheet, (step[set][2] * k + step[set][3]) % 64, TARGETS_SIZE, &b);
    if (problem == NULL &&
        !edit_apply(set > 1      ? &edits[0]
                        : k < 39 ? &edits_further[k % EDIT_FURTHER_COUNT]
                                 : &edits[(k - 39) % EDIT_COUNT],
                    &a, &b, &c))
        problem = "out of memory";
    if (problem == NULL && set > 1 && !targets_apply(&c, k % TARGETS_KINDS, (uint64_t)(100 * set + k)))
        problem = "out of memory";
    if (problem) return problem;
    for (channel = 0; channel < 3; ++channel)
        for (i = 0; i < pixels; ++i) *planes++ = c.pixels[3 * i + (size_t)channel];
    image_free(&a);
    image_free(&b);
    image_free(&c);
    return NULL;
}
#endif
