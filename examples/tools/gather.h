#ifndef GATHER_H
#define GATHER_H
/* The slow, good filter: every pixel gathers from points of the surface in space, at their true distances, with the
   round profile and the elevation factor, from the visible surface and, if given, the one behind it: the light of ears,
   leaves and fingers against the sun, which no filter of one layer has. Points farther than four pixels are taken
   together by twos, fours and so on: some hundred reads a pixel and layer. Over the public calls of ms_sss.h; pictures
   of floats. */
#include "ms_sss.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The surface behind: what lies first behind each pixel along the view, as an engine draws it with front faces culled.
 */
typedef struct gather_back {
    ms_sss_image input;  /* its irradiance, as ms_sss_frame.input */
    ms_sss_image depth;  /* its depth, as ms_sss_frame.depth; not finite or not positive: nothing */
    ms_sss_image normal; /* optional, as ms_sss_frame.normal; it points away from the camera */
} gather_back;

enum { GATHER__NEAR = 4, GATHER__LEVELS = 16, GATHER__STEPS = 2048 };

/* A patch of surface in view space, mm: x right, y down, z away from the camera. size 0: nothing. */
typedef struct gather__patch {
    float p[3], n[3], e[3], size; /* size: side of the square of its area */
} gather__patch;

typedef struct gather__state {
    ms_sss_frame frame;
    gather_back back;
    ms_sss_filter_options options;
    int layers, levels, width[GATHER__LEVELS], height[GATHER__LEVELS];
    gather__patch *level[2][GATHER__LEVELS];
    float (*disc)[3]; /* [steps + 2] light within steps of reach / GATHER__STEPS */
    float reach, elevation[3], reflectance[3];
    float pixel, slope; /* mm of a pixel's side at depth 0, and a mm of depth */
} gather__state;

static float gather__get(const ms_sss_image *picture, int c, int x, int y)
{
    return picture->channel[c][y * picture->row_stride + x * picture->pixel_stride];
}

static void gather__put(const ms_sss_image *picture, int c, int x, int y, float value)
{
    picture->channel[c][y * picture->row_stride + x * picture->pixel_stride] = value;
}

static int gather__finite(float x) { return x - x == 0; }

/* Place of a pixel's middle at depth z mm. */
static void gather__place(const gather__state *g, int x, int y, float z, float p[3])
{
    const float side = g->pixel + g->slope * z;
    p[0] = ((float)x + 0.5f - 0.5f * (float)g->frame.width) * side;
    p[1] = ((float)y + 0.5f - 0.5f * (float)g->frame.height) * side;
    p[2] = z;
}

/* mm; 0: no surface there that takes part. */
static float gather__depth(const gather__state *g, int layer, int x, int y)
{
    float z, strength;
    if (x < 0 || y < 0 || x >= g->frame.width || y >= g->frame.height) return 0;
    z = gather__get(layer ? &g->back.depth : &g->frame.depth, 0, x, y);
    if (!layer && g->frame.strength.channel[0]) {
        strength = gather__get(&g->frame.strength, 0, x, y);
        if (!(strength > 0)) return 0;
    }
    z *= g->options.mm_per_unit > 0 ? g->options.mm_per_unit : 1;
    return z > 0 && gather__finite(z) ? z : 0;
}

/* The way along the surface past a pixel on one axis, per pixel: the mean of both sides where they lie on one surface
   with it, else from the nearer side, carried on to the pixel by the next step; untouched where there is none. */
static void gather__tangent(const gather__state *g, int layer, int x, int y, int dx, int dy, const float p[3],
                            float t[3])
{
    const float pixel = g->pixel + g->slope * p[2];
    float side[2][3], off[2], z;
    int has[2], s, i;
    for (s = 0; s < 2; ++s) {
        const int way = s ? 1 : -1;
        z = gather__depth(g, layer, x + way * dx, y + way * dy);
        has[s] = z > 0;
        off[s] = fabsf(z - p[2]);
        if (!has[s]) continue;
        gather__place(g, x + way * dx, y + way * dy, z, side[s]);
        for (i = 0; i < 3; ++i) side[s][i] = (float)way * (side[s][i] - p[i]);
    }
    if (!has[0] && !has[1]) return;
    if (has[0] && has[1] && off[0] <= 2 * off[1] + pixel && off[1] <= 2 * off[0] + pixel) {
        for (i = 0; i < 3; ++i) t[i] = 0.5f * (side[0][i] + side[1][i]);
        return;
    }
    s = has[1] && (!has[0] || off[1] < off[0]);
    memcpy(t, side[s], 3 * sizeof *t);
    z = gather__depth(g, layer, x + (s ? 2 : -2) * dx, y + (s ? 2 : -2) * dy);
    if (z > 0) { /* near an outline depth goes with the root of the distance to it: so much is the slope above the first
                    step */
        const float first = t[2], second = (s ? 1.0f : -1.0f) * (z - p[2]) - first;
        float more = first * second > 0 ? first / second - 1 : 0;
        if (more > 0.85f) more = 0.85f;
        if (more > 0) t[2] *= 1 + more * (0.5f + more * (0.5f + 0.7f * more * more));
    }
}

/* The outward normal from depth. */
static void gather__normal(const gather__state *g, int layer, int x, int y, const float p[3], float n[3])
{
    float u[3] = {1, 0, 0}, v[3] = {0, 1, 0}, length;
    int c;
    gather__tangent(g, layer, x, y, 1, 0, p, u);
    gather__tangent(g, layer, x, y, 0, 1, p, v);
    n[0] = u[1] * v[2] - u[2] * v[1];
    n[1] = u[2] * v[0] - u[0] * v[2];
    n[2] = u[0] * v[1] - u[1] * v[0];
    length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    length = length > 0 ? (layer ? 1 : -1) / length : 0; /* right x down looks away from the camera, as back faces do */
    for (c = 0; c < 3; ++c) n[c] *= length;
}

static void gather__load(void *context, int task)
{
    const gather__state *g = (const gather__state *)context;
    const int y = task / g->layers, layer = task % g->layers, w = g->frame.width;
    int x, c;
    for (x = 0; x < w; ++x) {
        gather__patch *q = &g->level[layer][0][(size_t)y * (size_t)w + (size_t)x];
        const ms_sss_image *normal = layer ? &g->back.normal : &g->frame.normal;
        float z = gather__depth(g, layer, x, y), length, facing, side;
        int given = 0;
        memset(q, 0, sizeof *q);
        if (!(z > 0)) continue;
        for (c = 0; c < 3; ++c) q->e[c] = gather__get(layer ? &g->back.input : &g->frame.input, c, x, y);
        if (!gather__finite(q->e[0]) || !gather__finite(q->e[1]) || !gather__finite(q->e[2])) continue;
        gather__place(g, x, y, z, q->p);
        side = g->pixel + g->slope * z;
        if (normal->channel[0]) { /* z towards the camera there */
            for (c = 0; c < 3; ++c) q->n[c] = gather__get(normal, c, x, y) * (c == 2 ? -1.0f : 1.0f);
            length = sqrtf(q->n[0] * q->n[0] + q->n[1] * q->n[1] + q->n[2] * q->n[2]);
            given = length > 0 && length <= 3.4e38f;
            for (c = 0; c < 3 && given; ++c) q->n[c] /= length;
        }
        if (!given) gather__normal(g, layer, x, y, q->p, q->n);
        if (g->slope > 0) { /* cosine between the normal and the way to the camera */
            facing = fabsf(q->n[0] * q->p[0] + q->n[1] * q->p[1] + q->n[2] * q->p[2]) /
                sqrtf(q->p[0] * q->p[0] + q->p[1] * q->p[1] + q->p[2] * q->p[2]);
        } else {
            facing = fabsf(q->n[2]);
        }
        q->size = side / sqrtf(facing > 0.1f ? facing : 0.1f); /* edges on, depth says little of the area */
    }
}

/* Four patches as one, by their areas. */
static void gather__join(const gather__state *g, int layer, int level)
{
    const int w = g->width[level], h = g->height[level], below_w = g->width[level - 1], below_h = g->height[level - 1];
    int x, y, i, c;
    for (y = 0; y < h; ++y)
        for (x = 0; x < w; ++x) {
            gather__patch *to = &g->level[layer][level][(size_t)y * (size_t)w + (size_t)x];
            float area = 0;
            memset(to, 0, sizeof *to);
            for (i = 0; i < 4; ++i) {
                const int bx = 2 * x + i % 2, by = 2 * y + i / 2;
                const gather__patch *from = &g->level[layer][level - 1][(size_t)by * (size_t)below_w + (size_t)bx];
                float a;
                if (bx >= below_w || by >= below_h || !(from->size > 0)) continue;
                a = from->size * from->size;
                area += a;
                for (c = 0; c < 3; ++c) {
                    to->p[c] += a * from->p[c];
                    to->n[c] += a * from->n[c];
                    to->e[c] += a * from->e[c];
                }
            }
            if (!(area > 0)) continue;
            to->size = sqrtf(area);
            for (c = 0; c < 3; ++c) {
                to->p[c] /= area;
                to->n[c] /= area;
                to->e[c] /= area;
            }
        }
}

static void gather__add(const gather__state *g, const gather__patch *p, const gather__patch *q, float light[3],
                        float factor[3], float total[3])
{
    const float dx = p->p[0] - q->p[0], dy = p->p[1] - q->p[1], dz = p->p[2] - q->p[2],
                square = dx * dx + dy * dy + dz * dz;
    float r, low, high, area, sine = 0, step = (float)(int)GATHER__STEPS / g->reach;
    int inner, outer, c;
    if (!(square < g->reach * g->reach)) return;
    r = sqrtf(square);
    low = r - 0.5f * q->size; /* the ring as wide as the patch; round the pixel itself the disc of its area */
    high = r + 0.5f * q->size;
    if (r < 0.02f * q->size) high = 0.564189584f * q->size;
    if (low < 0) low = 0;
    if (high > g->reach) high = g->reach;
    if (!(high > low)) return;
    area = q->size * q->size / (high * high - low * low);
    if (r > 0) sine = 0.5f * ((p->n[0] - q->n[0]) * dx + (p->n[1] - q->n[1]) * dy + (p->n[2] - q->n[2]) * dz) / r;
    low *= step;
    high *= step;
    inner = (int)low;
    outer = (int)high;
    for (c = 0; c < 3; ++c) {
        const float a = g->disc[inner][c] + (low - (float)inner) * (g->disc[inner + 1][c] - g->disc[inner][c]);
        const float b = g->disc[outer][c] + (high - (float)outer) * (g->disc[outer + 1][c] - g->disc[outer][c]);
        float weight = area * (b - a), f = 1 + 0.25f * g->elevation[c] * sine;
        f = f > 0 ? f * f * f * f * weight : 0;
        total[c] += weight;
        factor[c] += f;
        light[c] += f * q->e[c];
    }
}

static void gather__row(void *context, int y)
{
    const gather__state *g = (const gather__state *)context;
    const int w = g->frame.width, inner = GATHER__NEAR;
    int x, c, layer, level, i, j;
    for (x = 0; x < w; ++x) {
        const gather__patch *p = &g->level[0][0][(size_t)y * (size_t)w + (size_t)x];
        float light[3] = {0, 0, 0}, factor[3] = {0, 0, 0}, total[3] = {0, 0, 0}, strength = 1;
        const int takes_part = p->size > 0;
        if (takes_part) {
            const float reach = g->reach / (g->pixel + g->slope * p->p[2]); /* pixels */
            int top = 0;
            while (top + 1 < g->levels && (float)(inner << top) < reach) ++top;
            for (layer = 0; layer < g->layers; ++layer) {
                int x0 = (x >> top) - inner, x1 = (x >> top) + inner, y0 = (y >> top) - inner, y1 = (y >> top) + inner;
                for (level = top; level >= 0; --level) {
                    /* of the cells x0 to x1, those within `inner` of the pixel's own are left to the next level */
                    const int cx = x >> level, cy = y >> level, width = g->width[level], height = g->height[level];
                    const int first = x0 > 0 ? x0 : 0, last = x1 < width - 1 ? x1 : width - 1;
                    for (j = y0 > 0 ? y0 : 0; j <= (y1 < height - 1 ? y1 : height - 1); ++j) {
                        const gather__patch *row = g->level[layer][level] + (size_t)j * (size_t)width;
                        const int hole = level > 0 && j >= cy - inner && j <= cy + inner;
                        for (i = first; i <= last; ++i) {
                            if (hole && i >= cx - inner && i <= cx + inner) {
                                i = cx + inner;
                                continue;
                            }
                            if (row[i].size > 0) gather__add(g, p, &row[i], light, factor, total);
                        }
                    }
                    x0 = 2 * (cx - inner);
                    x1 = 2 * (cx + inner) + 1;
                    y0 = 2 * (cy - inner);
                    y1 = 2 * (cy + inner) + 1;
                }
            }
            if (g->frame.strength.channel[0]) {
                float s = gather__get(&g->frame.strength, 0, x, y);
                strength *= s < 1 ? s : 1;
            }
        }
        for (c = 0; c < 3; ++c) {
            float in = gather__get(&g->frame.input, c, x, y), out = in;
            if (takes_part && total[c] > 0 && g->reflectance[c] > 0) {
                float most = g->reflectance[c] * factor[c] / total[c]; /* of evenly lit surroundings this part leaves */
                out = light[c] / total[c] / (most > 1 ? most : 1);
                out = strength * out + (1 - strength) * in;
            }
            gather__put(&g->frame.output, c, x, y, out);
        }
    }
}

/* Patches of all levels of a layer. */
static size_t gather__patches(gather__state *g, int width, int height)
{
    size_t count = 0;
    g->levels = 0;
    while (g->levels < GATHER__LEVELS) {
        g->width[g->levels] = width;
        g->height[g->levels] = height;
        count += (size_t)width * (size_t)height;
        g->levels++;
        if (width == 1 && height == 1) break;
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
    return count;
}

static ms_status gather__refuse(ms_error *error, ms_status status, const char *why)
{
    if (error == NULL) return status;
    error->status = status;
    error->position = 0;
    snprintf(error->message, sizeof error->message, "%s", why);
    return status;
}

/* Fills in the strides. Whether the picture can be read: floats, all channels there. */
static int gather__takes(ms_sss_image *picture, int channels, int needed, int width)
{
    int c;
    if (picture->channel[0] == NULL) return !needed;
    if (picture->pixel_stride == 0) picture->pixel_stride = 1;
    if (picture->row_stride == 0) picture->row_stride = picture->pixel_stride * width;
    for (c = 1; c < channels; ++c)
        if (picture->channel[c] == NULL) return 0;
    return 1;
}

static void gather__run(const ms_parallel *parallel, int count, void (*task)(void *context, int index), void *context)
{
    int i;
    if (parallel->run != NULL) parallel->run(parallel->user, count, task, context);
    for (i = 0; i < count && parallel->run == NULL; ++i) task(context, i);
}

/* frame     depth is needed; no profile; the rest as in ms_sss_filter
   back      NULL: the visible surface alone
   options   the size of a pixel by fov_degrees or ortho_height, mm_per_unit, flat, parallel count
   What of the profile meets no point is renormalized away. No more than all light leaves. Bit-equal for any thread
   count. MS_INVALID_ARGUMENT, MS_UNSUPPORTED (pixels_per_mm, frame->profile), MS_OUT_OF_MEMORY: output untouched. */
static ms_status gather_filter(const ms_sss_frame *frame, const gather_back *back, const ms_sss_profile *profile,
                               const ms_sss_filter_options *options, ms_error *error)
{
    gather__state g;
    double total[3], radius[3], widest = 0;
    const int w = frame->width, h = frame->height;
    size_t patches;
    int c, i, layer, level;
    void *block;
    gather__patch *at;
    memset(&g, 0, sizeof g);
    g.frame = *frame;
    g.options = *options;
    if (back) g.back = *back;
    if (options->pixels_per_mm[0] > 0 || frame->profile)
        return gather__refuse(error, MS_UNSUPPORTED, "a gather takes one profile, and no pixels_per_mm");
    if (w < 1 || h < 1 || w > 65536 || h > 65536)
        return gather__refuse(error, MS_INVALID_ARGUMENT, "width, height: 1 to 65536 each expected");
    if ((options->fov_degrees > 0 && options->fov_degrees < 180) + (options->ortho_height > 0) != 1 ||
        !(options->mm_per_unit >= 0 && options->mm_per_unit <= 1e9f) || !(options->ortho_height <= 1e9f))
        return gather__refuse(error, MS_INVALID_ARGUMENT,
                              "either fov_degrees or ortho_height is needed, lengths to 1e9");
    if (!gather__takes(&g.frame.input, 3, 1, w) || !gather__takes(&g.frame.output, 3, 1, w) ||
        !gather__takes(&g.frame.depth, 1, 1, w) || !gather__takes(&g.frame.strength, 1, 0, w) ||
        !gather__takes(&g.frame.normal, 3, 0, w) || !gather__takes(&g.back.input, 3, back != NULL, w) ||
        !gather__takes(&g.back.depth, 1, back != NULL, w) || !gather__takes(&g.back.normal, 3, 0, w))
        return gather__refuse(error, MS_INVALID_ARGUMENT, "a picture is missing");
    ms_sss_profile_reflectance(profile, total);
    ms_sss_profile_radius(profile, 0.99, radius);
    for (c = 0; c < 3; ++c) {
        widest = radius[c] > widest ? radius[c] : widest;
        g.reflectance[c] = (float)total[c];
        g.elevation[c] = (float)ms_sss_elevation(total[c], 1) * (1 - options->flat);
    }
    if (!(widest > 0)) return gather__refuse(error, MS_INVALID_ARGUMENT, "the profile holds no light in any channel");
    g.reach = (float)(1.5 * widest); /* what is farther is worth less than the pixels' own shape */
    g.layers = back ? 2 : 1;
    if (options->fov_degrees > 0) g.slope = 2 * tanf(options->fov_degrees * (3.14159265f / 360)) / (float)h;
    else g.pixel = options->ortho_height * (options->mm_per_unit > 0 ? options->mm_per_unit : 1) / (float)h;
    patches = gather__patches(&g, w, h);
    block = malloc((size_t)g.layers * patches * sizeof(gather__patch) + (GATHER__STEPS + 2) * sizeof *g.disc);
    if (block == NULL) return gather__refuse(error, MS_OUT_OF_MEMORY, "out of memory");
    at = (gather__patch *)block;
    for (layer = 0; layer < g.layers; ++layer)
        for (level = 0; level < g.levels; ++level) {
            g.level[layer][level] = at;
            at += (size_t)g.width[level] * (size_t)g.height[level];
        }
    g.disc = (float(*)[3])(void *)at;
    for (i = 0; i < GATHER__STEPS + 2; ++i) {
        double disc[3];
        ms_sss_profile_disc(profile, (double)g.reach * i / (int)GATHER__STEPS, disc);
        for (c = 0; c < 3; ++c) g.disc[i][c] = (float)(total[c] > 0 ? disc[c] / total[c] : 0);
    }
    gather__run(&options->parallel, h * g.layers, gather__load, &g);
    for (layer = 0; layer < g.layers; ++layer)
        for (level = 1; level < g.levels; ++level) gather__join(&g, layer, level);
    gather__run(&options->parallel, h, gather__row, &g);
    free(block);
    return MS_OK;
}
#endif
