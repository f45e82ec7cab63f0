/* Psi, the edits that make targets of material pictures (thesis, 4.3 and 4.4; edits_further are not from there): what a
   raster editor offers, on display values in [0, 1], most of them inside a selection around the ball of the test scene.

     edit_apply(&edits[i], &source, &other, &target)       target: a new picture; 0: out of memory
     edit_tile(&sheet, i, 64, &source)                     picture i of a sheet of 128-pixel tiles, at 64 pixels

   The results are no pictures of any material, as a rule; that is the point. */
#ifndef EXAMPLES_EDITS_H
#define EXAMPLES_EDITS_H
#include "../tools/image.h"

/* The selection: 1 on the ball, 0 outside, a soft edge of two hundredths of the width. The silhouette of a unit ball at
   the origin seen by the scene's camera; grow and drop make a careless one. */
static inline float edit_ball(const image *im, int x, int y, float grow, float drop)
{
    float u = ((float)x + 0.5f) / (float)im->width - 0.5f, v = ((float)y + 0.5f) / (float)im->height - 0.457f - drop;
    float t = (0.377f + grow - sqrtf(u * u + v * v)) * 50 + 0.5f;
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

static inline float edit__luma(const float *rgb) { return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]; }
static inline float edit__clip(float v) { return v < 0 ? 0 : v > 1 ? 1 : v; }

/* Towards (amount < 1) or away from gray inside the selection. */
static inline void edit_saturate(image *im, const image *other, float amount)
{
    int x, y, c;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), gray = edit__luma(p),
                  t = edit_ball(im, x, y, 0, 0) * (amount - 1);
            for (c = 0; c < 3; ++c) p[c] = edit__clip(p[c] + t * (p[c] - gray));
        }
}

/* Brightness stays, the hue of `amount` turns replaces the color; highlights stay white. */
static inline void edit__tint(image *im, float amount, float grow, float drop)
{
    float tint[3], luma;
    int x, y, c;
    for (c = 0; c < 3; ++c) tint[c] = 0.5f + 0.4f * cosf(6.2831853f * (amount - (float)c / 3));
    luma = edit__luma(tint);
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), gray = edit__luma(p), t = edit_ball(im, x, y, grow, drop);
            for (c = 0; c < 3; ++c) {
                float color = gray < luma ? tint[c] * gray / luma : 1 - (1 - tint[c]) * (1 - gray) / (1 - luma);
                p[c] += t * (color - p[c]);
            }
        }
}

static inline void edit_colorize(image *im, const image *other, float amount)
{
    (void)other;
    edit__tint(im, amount, 0, 0);
}

/* The same with a selection that is too large and has slipped: it takes some of the floor and misses the top. */
static inline void edit_poor_mask(image *im, const image *other, float amount)
{
    (void)other;
    edit__tint(im, amount, 0.05f, 0.07f);
}

static inline void edit_mix(image *im, const image *other, float amount)
{
    size_t i;
    for (i = 0; i < image_count(im); ++i) im->pixels[i] += amount * (other->pixels[i] - im->pixels[i]);
}

/* What lies right of `amount` comes from the other picture. */
static inline void edit_stitch(image *im, const image *other, float amount)
{
    int x, y, c;
    for (y = 0; y < im->height; ++y)
        for (x = (int)(amount * (float)im->width); x < im->width; ++x)
            for (c = 0; c < 3; ++c)
                im->pixels[3 * (y * im->width + x) + c] = other->pixels[3 * (y * im->width + x) + c];
}

/* A disc of radius `amount` on the ball is taken out and filled smoothly from its rim (Laplace's equation, relaxed). */
static inline void edit_inpaint(image *im, const image *other, float amount)
{
    int x, y, c, sweep, w = im->width;
    (void)other;
    for (sweep = 0; sweep < 200; ++sweep)
        for (y = 1; y + 1 < im->height; ++y)
            for (x = 1; x + 1 < w; ++x) {
                float u = ((float)x + 0.5f) / (float)w - 0.42f, v = ((float)y + 0.5f) / (float)im->height - 0.36f;
                float *p = im->pixels + 3 * (y * w + x);
                if (u * u + v * v > amount * amount) continue;
                for (c = 0; c < 3; ++c) p[c] = 0.25f * (p[c - 3] + p[c + 3] + p[c - 3 * w] + p[c + 3 * w]);
            }
}

/* Gaussian blur of standard deviation `amount` (of the width) where the ball is bright. */
static inline void edit_blur_highlights(image *im, const image *other, float amount)
{
    float sigma = amount * (float)im->width, brightest = 0;
    image blurred = image_new(im->width, im->height, 3);
    int x, y, c, u, v, r = (int)(3 * sigma) + 1;
    (void)other;
    if (blurred.pixels == NULL) return;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float sum[3] = {0, 0, 0}, total = 0, luma = edit__luma(im->pixels + 3 * (y * im->width + x));
            if (edit_ball(im, x, y, 0, 0) > 0.5f && luma > brightest) brightest = luma;
            for (v = y - r; v <= y + r; ++v)
                for (u = x - r; u <= x + r; ++u) {
                    float weight = expf(-0.5f * (float)((u - x) * (u - x) + (v - y) * (v - y)) / (sigma * sigma));
                    if (u < 0 || v < 0 || u >= im->width || v >= im->height) continue;
                    for (c = 0; c < 3; ++c) sum[c] += weight * im->pixels[3 * (v * im->width + u) + c];
                    total += weight;
                }
            for (c = 0; c < 3; ++c) blurred.pixels[3 * (y * im->width + x) + c] = sum[c] / total;
        }
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), *q = blurred.pixels + 3 * (y * im->width + x);
            float bright = edit__luma(p) > edit__luma(q) ? edit__luma(p) : edit__luma(q);
            float t = edit_ball(im, x, y, 0, 0) * edit__clip((bright - 0.6f * brightest) / (0.2f * brightest + 1e-6f));
            for (c = 0; c < 3; ++c) p[c] += t * (q[c] - p[c]);
        }
    image_free(&blurred);
}

/* Black becomes `amount`, white stays; the whole picture. */
static inline void edit_black_level(image *im, const image *other, float amount)
{
    size_t i;
    (void)other;
    for (i = 0; i < image_count(im); ++i) im->pixels[i] = amount + (1 - amount) * im->pixels[i];
}

/* --- further edits, which no parameter of a material explains: people make them all the same --- */

/* Red, green and blue change places where the ball is right of its middle. */
static inline void edit_hue_half(image *im, const image *other, float amount)
{
    int x, y;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = (int)(amount * (float)im->width); x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), t = edit_ball(im, x, y, 0, 0), red = p[0];
            p[0] += t * (p[2] - p[0]);
            p[2] += t * (p[1] - p[2]);
            p[1] += t * (red - p[1]);
        }
}

/* A disc with a bar in it, in two flat colors, of radius `amount` beside the middle of the ball. */
static inline void edit_logo(image *im, const image *other, float amount)
{
    int x, y, c;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float u = ((float)x + 0.5f) / (float)im->width - 0.58f, v = ((float)y + 0.5f) / (float)im->height - 0.5f;
            if (u * u + v * v > amount * amount) continue;
            for (c = 0; c < 3; ++c)
                im->pixels[3 * (y * im->width + x) + c] = fabsf(v) < 0.3f * amount ? 0.95f : c == 2 ? 0.8f : 0.05f;
        }
}

/* What JPEG keeps of blocks of 8 x 8 at a quality of `amount` (below 50): cosines, rounded to steps that grow with
   frequency. */
static inline void edit_jpeg(image *im, const image *other, float amount)
{
    float basis[8][8], block[8][8], half[8][8];
    int x, y, c, i, j, k;
    (void)other;
    for (k = 0; k < 8; ++k)
        for (i = 0; i < 8; ++i) basis[k][i] = (k ? 0.5f : 0.35355339f) * cosf(0.19634954f * (float)(k * (2 * i + 1)));
    for (c = 0; c < 3; ++c)
        for (y = 0; y + 8 <= im->height; y += 8)
            for (x = 0; x + 8 <= im->width; x += 8) {
                float *p = im->pixels + 3 * (y * im->width + x) + c;
                for (k = 0; k < 8; ++k)
                    for (j = 0; j < 8; ++j)
                        for (half[k][j] = 0, i = 0; i < 8; ++i) half[k][j] += basis[k][i] * p[3 * (i * im->width + j)];
                for (k = 0; k < 8; ++k)
                    for (j = 0; j < 8; ++j) {
                        float step = (16 + 5 * (float)(k + j)) * 50 / amount / 255;
                        for (block[k][j] = 0, i = 0; i < 8; ++i) block[k][j] += basis[j][i] * half[k][i];
                        block[k][j] = step * floorf(block[k][j] / step + 0.5f);
                    }
                for (i = 0; i < 8; ++i)
                    for (j = 0; j < 8; ++j)
                        for (half[i][j] = 0, k = 0; k < 8; ++k) half[i][j] += basis[k][i] * block[k][j];
                for (i = 0; i < 8; ++i)
                    for (j = 0; j < 8; ++j) {
                        float sum = 0;
                        for (k = 0; k < 8; ++k) sum += basis[k][j] * half[i][k];
                        p[3 * (i * im->width + j)] = edit__clip(sum);
                    }
            }
}

/* Noise of standard deviation `amount` in every value: sums of four uniform numbers. */
static inline void edit_noise(image *im, const image *other, float amount)
{
    uint32_t state = 12345;
    size_t i;
    int k;
    (void)other;
    for (i = 0; i < image_count(im); ++i) {
        float sum = -2;
        for (k = 0; k < 4; ++k) {
            state = state * 1664525u + 1013904223u;
            sum += (float)(state >> 8) / 16777216.0f;
        }
        im->pixels[i] = edit__clip(im->pixels[i] + amount * 1.7320508f * sum);
    }
}

/* Linear light of the whole picture times a factor a channel. */
static inline void edit__gain(image *im, float red, float green, float blue)
{
    const float gain[3] = {red, green, blue};
    size_t i;
    for (i = 0; i < image_count(im); ++i)
        im->pixels[i] = edit__clip(image_srgb_encode(gain[i % 3] * image_srgb_decode(im->pixels[i])));
}

static inline void edit_colored_light(image *im, const image *other, float amount)
{
    (void)other;
    edit__gain(im, 1 + amount, 1, 1 - amount);
}

static inline void edit_exposure(image *im, const image *other, float amount)
{
    (void)other;
    edit__gain(im, amount, amount, amount);
}

/* Darker on the left, brighter on the right. */
static inline void edit_gradient(image *im, const image *other, float amount)
{
    int x, y, c;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x)
            for (c = 0; c < 3; ++c) {
                float *p = im->pixels + 3 * (y * im->width + x) + c;
                *p = edit__clip(*p * (1 + amount * (2 * ((float)x + 0.5f) / (float)im->width - 1)));
            }
}

/* The picture through another frame: pixel u comes from middle + (u - middle) scale + shift, bilinearly, edges
   repeated. */
static inline void edit__frame(image *im, float scale, float shift_x, float shift_y)
{
    image from = image_new(im->width, im->height, 3);
    int x, y, c, i, j;
    if (from.pixels == NULL) return;
    memcpy(from.pixels, im->pixels, image_count(im) * sizeof(float));
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float u = 0.5f * (float)(im->width - 1), v = 0.5f * (float)(im->height - 1), fx, fy;
            u += ((float)x - u) * scale + shift_x;
            v += ((float)y - v) * scale + shift_y;
            u = u < 0 ? 0 : u > (float)(im->width - 1) ? (float)(im->width - 1) : u;
            v = v < 0 ? 0 : v > (float)(im->height - 1) ? (float)(im->height - 1) : v;
            fx = u - floorf(u);
            fy = v - floorf(v);
            for (c = 0; c < 3; ++c) {
                float sum = 0;
                for (j = 0; j < 2; ++j)
                    for (i = 0; i < 2; ++i) {
                        int column = (int)u + i < im->width ? (int)u + i : im->width - 1,
                            row = (int)v + j < im->height ? (int)v + j : im->height - 1;
                        sum += (i ? fx : 1 - fx) * (j ? fy : 1 - fy) * from.pixels[3 * (row * im->width + column) + c];
                    }
                im->pixels[3 * (y * im->width + x) + c] = sum;
            }
        }
    image_free(&from);
}

static inline void edit_crop(image *im, const image *other, float amount)
{
    (void)other;
    edit__frame(im, amount, 0, 0);
}

static inline void edit_shift(image *im, const image *other, float amount)
{
    (void)other;
    edit__frame(im, 1, amount * (float)im->width, -0.5f * amount * (float)im->width);
}

static inline void edit_posterise(image *im, const image *other, float amount)
{
    size_t i;
    (void)other;
    for (i = 0; i < image_count(im); ++i) im->pixels[i] = floorf(im->pixels[i] * amount + 0.5f) / amount;
}

/* The ball in one flat color. */
static inline void edit_flat_paint(image *im, const image *other, float amount)
{
    int x, y, c;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x)
            for (c = 0; c < 3; ++c) {
                float *p = im->pixels + 3 * (y * im->width + x) + c;
                *p += edit_ball(im, x, y, 0, 0) * ((0.5f + 0.4f * cosf(6.2831853f * (amount - (float)c / 3))) - *p);
            }
}

/* Brightness through a ramp of black, brown, gold and white. */
static inline void edit_gold(image *im, const image *other, float amount)
{
    static const float ramp[4][3] = {{0.05f, 0.02f, 0}, {0.45f, 0.25f, 0.05f}, {0.95f, 0.75f, 0.3f}, {1, 1, 0.9f}};
    int x, y, c;
    (void)other;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x) {
            float *p = im->pixels + 3 * (y * im->width + x), t = amount * edit_ball(im, x, y, 0, 0),
                  at = 3 * edit__luma(p);
            int k = at < 1 ? 0 : at < 2 ? 1 : 2;
            for (c = 0; c < 3; ++c) p[c] += t * (ramp[k][c] + (at - (float)k) * (ramp[k + 1][c] - ramp[k][c]) - p[c]);
        }
}

/* Stripes of two materials, `amount` of the width each. */
static inline void edit_two_materials(image *im, const image *other, float amount)
{
    int x, y, c;
    for (y = 0; y < im->height; ++y)
        for (x = 0; x < im->width; ++x)
            for (c = 0; c < 3; ++c)
                if ((int)((float)(x + y) / (amount * (float)im->width)) % 2)
                    im->pixels[3 * (y * im->width + x) + c] = other->pixels[3 * (y * im->width + x) + c];
}

typedef struct edit {
    const char *name;
    void (*apply)(image *im, const image *other, float amount); /* NULL: nothing */
    float amount;
} edit;

enum { EDIT_COUNT = 10 };
static const edit edits[EDIT_COUNT] = {{"unedited", NULL, 0},
                                       {"saturation", edit_saturate, 2},
                                       {"grayscale", edit_saturate, 0},
                                       {"colorize", edit_colorize, 0.08f},
                                       {"mix of two", edit_mix, 0.5f},
                                       {"stitching", edit_stitch, 0.5f},
                                       {"inpainting", edit_inpaint, 0.17f},
                                       {"highlight blur", edit_blur_highlights, 0.04f},
                                       {"black level", edit_black_level, 0.12f},
                                       {"poor mask", edit_poor_mask, 0.6f}};

enum { EDIT_FURTHER_COUNT = 13 };
static const edit edits_further[EDIT_FURTHER_COUNT] = {{"logo", edit_logo, 0.12f},
                                                       {"hue of one half", edit_hue_half, 0.5f},
                                                       {"JPEG", edit_jpeg, 8},
                                                       {"noise", edit_noise, 0.1f},
                                                       {"colored light", edit_colored_light, 0.3f},
                                                       {"gradient", edit_gradient, 0.4f},
                                                       {"crop", edit_crop, 0.85f},
                                                       {"shift", edit_shift, 0.03f},
                                                       {"exposure", edit_exposure, 1.6f},
                                                       {"posterise", edit_posterise, 4},
                                                       {"flat paint", edit_flat_paint, 0.55f},
                                                       {"gold", edit_gold, 1},
                                                       {"two materials", edit_two_materials, 0.2f}};

static inline int edit_apply(const edit *e, const image *source, const image *other, image *target)
{
    *target = image_new(source->width, source->height, 3);
    if (target->pixels == NULL) return 0;
    memcpy(target->pixels, source->pixels, image_count(source) * sizeof(float));
    if (e->apply) e->apply(target, other, e->amount);
    return 1;
}

/* Picture i of a sheet of 128-pixel tiles, row by row; means in linear light bring it to `size`, a divisor of 128. */
static inline const char *edit_tile(const image *sheet, int i, int size, image *out)
{
    int columns = sheet->width / 128, left = columns ? i % columns * 128 : 0, top = columns ? i / columns * 128 : 0, x,
        y, c, u, v;
    int box = 128 / size;
    *out = image_new(size, size, 3);
    if (columns < 1 || top + 128 > sheet->height || sheet->channels != 3) return "no such picture in the sheet";
    if (out->pixels == NULL) return "out of memory";
    for (y = 0; y < size; ++y)
        for (x = 0; x < size; ++x)
            for (c = 0; c < 3; ++c) {
                float sum = 0;
                for (v = 0; v < box; ++v)
                    for (u = 0; u < box; ++u)
                        sum += image_srgb_decode(
                            sheet->pixels[3 * ((top + y * box + v) * sheet->width + left + x * box + u) + c]);
                out->pixels[3 * (y * size + x) + c] = image_srgb_encode(sum / (float)(box * box));
            }
    return NULL;
}
#endif
