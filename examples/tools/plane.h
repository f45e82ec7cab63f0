/* The latent plane of ms_gpr.h: maps of what is liked, known and similar there, and automatic variants of a material
   (thesis 3.7); ms_gpr.h comes first.

     map_grid grid = map_around(plane, 50);                 50 x 50 points over a square around the embedded materials
     map_preference(plane, gp, &grid, value, &error);       [rows][columns] predicted score of every point's material
     map_confidence(plane, &grid, confidence, &error);      how much the plane knows: 0 nothing, 1 all
     map_value(&grid, value, x, y)                          bilinear interpolation
     variants_map(plane, &similarity, &grid, map, &error);  similarity of every point's material
     variants_find(plane, gp, &similarity, &grid, lambda, 7, 0, 0.07, variant, x, &error);   seven variants, x [7][m] or NULL
 */
#ifndef EXAMPLES_PLANE_H
#define EXAMPLES_PLANE_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A grid of columns x rows points over a rectangle of the plane, its corners included. Maps are [rows][columns], from
   low to high coordinates. */
typedef struct map_grid {
    double x0, y0, x1, y1;
    int columns, rows; /* at least 2 */
} map_grid;

/* A square that holds the embedded materials and one length scale (at most a quarter of their range) around them;
   resolution below 2 is taken as 2. */
static inline map_grid map_around(const ms_gpr_latent *plane, int resolution)
{
    const ms_gpr_latent_view view = ms_gpr_latent_view_of(plane);
    double low[2], high[2], side = 0;
    map_grid grid;
    int i, k;
    for (k = 0; k < 2; ++k) {
        double margin;
        low[k] = high[k] = view.points[k];
        for (i = 1; i < view.z; ++i) {
            low[k] = fmin(low[k], view.points[2 * i + k]);
            high[k] = fmax(high[k], view.points[2 * i + k]);
        }
        margin = 0.25 * (high[k] - low[k]);
        if (!(margin < 1 && margin > 0)) margin = 1;
        low[k] -= margin;
        high[k] += margin;
        side = fmax(side, high[k] - low[k]);
    }
    grid.x0 = 0.5 * (low[0] + high[0] - side), grid.x1 = grid.x0 + side;
    grid.y0 = 0.5 * (low[1] + high[1] - side), grid.y1 = grid.y0 + side;
    grid.columns = grid.rows = resolution < 2 ? 2 : resolution;
    return grid;
}

static inline void map_point(const map_grid *grid, int column, int row, double latent[2])
{
    latent[0] = grid->x0 + (grid->x1 - grid->x0) * column / (grid->columns - 1);
    latent[1] = grid->y0 + (grid->y1 - grid->y0) * row / (grid->rows - 1);
}

/* Clamped to the rectangle; NaN is its low end. */
static inline double map_value(const map_grid *grid, const double *map, double x, double y)
{
    const int columns = grid->columns, rows = grid->rows;
    double u = x > grid->x0 ? fmin((x - grid->x0) / (grid->x1 - grid->x0), 1) * (columns - 1) : 0;
    double v = y > grid->y0 ? fmin((y - grid->y0) / (grid->y1 - grid->y0), 1) * (rows - 1) : 0;
    const int i = u < columns - 2 ? (int)u : columns - 2, j = v < rows - 2 ? (int)v : rows - 2;
    const double *p = map + (size_t)j * (size_t)columns + (size_t)i;
    u -= i;
    v -= j;
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[columns] + u * p[columns + 1]);
}

/* The materials of a grid, [rows * columns][m], to be freed, and how much is known there (NULL: not wanted). */
static inline ms_status map_materials(const ms_gpr_latent *plane, const map_grid *grid, double **x, double *confidence,
                                      ms_error *error)
{
    const ms_gpr_latent_view view = ms_gpr_latent_view_of(plane);
    const int count = grid->columns * grid->rows;
    ms_status status;
    double *latent = (double *)malloc((size_t)count * 2 * sizeof *latent);
    int i;
    *x = (double *)malloc((size_t)count * (size_t)view.m * sizeof **x);
    for (i = 0; i < count && latent; ++i) map_point(grid, i % grid->columns, i / grid->columns, latent + 2 * i);
    status = latent && *x ? ms_gpr_latent_map(plane, latent, count, *x, confidence, error) : MS_OUT_OF_MEMORY;
    if (status == MS_OUT_OF_MEMORY) snprintf(error->message, sizeof error->message, "no memory for a map");
    for (i = 0; i < count && confidence && status == MS_OK; ++i)
        confidence[i] = 1 - confidence[i] / (view.sf * view.sf);
    free(latent);
    if (status != MS_OK) free(*x);
    return status;
}

static inline ms_status map_preference(const ms_gpr_latent *plane, const ms_gpr *gp, const map_grid *grid,
                                       double *score, ms_error *error)
{
    double *x;
    ms_status status = map_materials(plane, grid, &x, NULL, error);
    if (status != MS_OK) return status;
    status = ms_gpr_predict(gp, x, grid->columns * grid->rows, score, NULL, error);
    free(x);
    return status;
}

static inline ms_status map_confidence(const ms_gpr_latent *plane, const map_grid *grid, double *confidence,
                                       ms_error *error)
{
    double *x;
    ms_status status = map_materials(plane, grid, &x, confidence, error);
    if (status == MS_OK) free(x);
    return status;
}

/* How similar two materials look: s = exp(-d^2 / (2 scale^2)), d the root mean square difference of their pictures. */
typedef struct variant_similarity {
    const double *x; /* [m] the material to be fine-tuned */
    double scale;    /* 0.1: a PSNR of 20 dB (pictures of range 1) means s = 0.61, and 30 dB 0.95 */
    size_t pixels;   /* floats of a picture; 0: no pictures, d is between the parameters */
    ms_status (*render)(void *user, const double *x, float *picture); /* a failure ends the call with its status */
    void *user;
} variant_similarity;

typedef struct variant_found {
    double latent[2], similarity, score, confidence;
    double value; /* confidence (lambda s + (1 - lambda) (score - floor) / (best - floor)) */
} variant_found;

/* Points of the plane that were looked at. */
typedef struct variants {
    const ms_gpr_latent *plane;
    const ms_gpr *gp;
    const variant_similarity *like;
    float *pictures; /* [2][pixels], the first of them the reference's */
    double *x;       /* [4][m] */
    variant_found *seen;
    int count;
    const variant_found *chosen; /* [choices] what the next one keeps `apart` from */
    int choices;
    double apart;
    double best, floor; /* the scores that count as 1 and 0 */
} variants;

/* 0 where a picture has a value that is not finite. */
static inline ms_status variants__similarity(const variant_similarity *s, int m, const double *x, float *pictures,
                                             double *value)
{
    const float *picture = pictures + s->pixels;
    const size_t count = s->pixels > 0 ? s->pixels : (size_t)m;
    double sum = 0;
    ms_status status = s->pixels > 0 ? s->render(s->user, x, pictures + s->pixels) : MS_OK;
    size_t i;
    for (i = 0; i < count && status == MS_OK; ++i) {
        const double d = s->pixels > 0 ? (double)picture[i] - (double)pictures[i] : x[i] - s->x[i];
        sum += d * d;
    }
    *value = sum - sum == 0 ? exp(-0.5 * sum / ((double)count * s->scale * s->scale)) : 0;
    return status;
}

/* Two pictures, the first of them the reference's, to be freed. */
static inline ms_status variants__pictures(const variant_similarity *s, float **pictures, ms_error *error)
{
    ms_status status = MS_OK;
    *pictures = (float *)malloc((2 * s->pixels + 1) * sizeof **pictures);
    if (*pictures == NULL) status = MS_OUT_OF_MEMORY;
    else if (s->pixels > 0) status = s->render(s->user, s->x, *pictures);
    if (status == MS_OK) return MS_OK;
    free(*pictures);
    snprintf(error->message, sizeof error->message, "no picture of the reference: %s", ms_status_string(status));
    return status;
}

static inline ms_status variants_map(const ms_gpr_latent *plane, const variant_similarity *s, const map_grid *grid,
                                     double *map, ms_error *error)
{
    const int m = ms_gpr_latent_view_of(plane).m;
    double *x;
    float *pictures;
    int i;
    ms_status status = map_materials(plane, grid, &x, NULL, error);
    if (status != MS_OK) return status;
    status = variants__pictures(s, &pictures, error);
    if (status == MS_OK) {
        for (i = 0; i < grid->columns * grid->rows && status == MS_OK; ++i)
            status = variants__similarity(s, m, x + (size_t)i * (size_t)m, pictures, &map[i]);
        if (status != MS_OK) snprintf(error->message, sizeof error->message, "a picture failed");
        free(pictures);
    }
    free(x);
    return status;
}

/* Adds what is seen at points [count][2]; x: [count][m] scratch. */
static inline ms_status variants__look(variants *v, const double *point, int count, double *x, ms_error *error)
{
    const ms_gpr_latent_view view = ms_gpr_latent_view_of(v->plane);
    double *list = (double *)malloc(2 * (size_t)count * sizeof *list);
    ms_status status = list ? ms_gpr_latent_map(v->plane, point, count, x, list, error) : MS_OUT_OF_MEMORY;
    int i;
    if (status == MS_OK) status = ms_gpr_predict(v->gp, x, count, list + count, NULL, error);
    for (i = 0; i < count && status == MS_OK; ++i) {
        variant_found *to = &v->seen[v->count++];
        memcpy(to->latent, point + 2 * i, sizeof to->latent);
        to->confidence = 1 - list[i] / (view.sf * view.sf);
        to->score = list[count + i];
        status = variants__similarity(v->like, view.m, x + (size_t)i * (size_t)view.m, v->pictures, &to->similarity);
        if (status != MS_OK) snprintf(error->message, sizeof error->message, "a picture failed");
    }
    free(list);
    return status;
}

static inline double variants__value(const variants *v, const variant_found *at, double lambda)
{
    return at->confidence * (lambda * at->similarity + (1 - lambda) * (at->score - v->floor) / (v->best - v->floor));
}

/* How far a point is from the nearest that was chosen. */
static inline double variants__distance(const variants *v, const variant_found *at)
{
    double least = HUGE_VAL;
    int i;
    for (i = 0; i < v->choices; ++i)
        least = fmin(least, hypot(at->latent[0] - v->chosen[i].latent[0], at->latent[1] - v->chosen[i].latent[1]));
    return least;
}

/* The best so far that keeps apart, or the farthest where none does; of those that are two steps away from a point,
   where one is given. */
static inline variant_found variants__best(const variants *v, double lambda, const double *away, const double *step)
{
    variant_found chosen = v->seen[0];
    double apart = 0;
    int i;
    for (i = 0; i < v->count; ++i) apart = fmax(apart, fmin(v->apart, variants__distance(v, &v->seen[i])));
    chosen.value = -HUGE_VAL;
    for (i = 0; i < v->count; ++i) {
        const variant_found *at = &v->seen[i];
        const double value = variants__value(v, at, lambda);
        if (!(value > chosen.value) || variants__distance(v, at) < apart) continue;
        if (away && fabs(at->latent[0] - away[0]) < 2 * step[0] && fabs(at->latent[1] - away[1]) < 2 * step[1])
            continue;
        chosen = *at;
        chosen.value = value;
    }
    return chosen;
}

/* Adds the embedded material that is nearest to the one to be fine-tuned. */
static inline ms_status variants__look_nearest(variants *v, ms_error *error)
{
    const ms_gpr_latent_view view = ms_gpr_latent_view_of(v->plane);
    double least = HUGE_VAL;
    ms_status status = MS_OK;
    int best = 0, i, k;
    for (i = 0; i < view.z && status == MS_OK; ++i) {
        double d2 = 0;
        status = ms_gpr_latent_map(v->plane, view.points + 2 * i, 1, v->x, NULL, error);
        for (k = 0; k < view.m; ++k) d2 += (v->x[k] - v->like->x[k]) * (v->x[k] - v->like->x[k]);
        if (d2 < least) least = d2, best = i;
    }
    return status == MS_OK ? variants__look(v, view.points + 2 * best, 1, v->x, error) : status;
}

enum { VARIANTS__ROUNDS = 20, VARIANTS__HALVINGS = 6 };

/* Pattern searches from the best so far and from the best elsewhere, inside the grid: the four neighbors at a step,
   which is halved, six times, where none is better. */
static inline ms_status variants__refine(variants *v, const map_grid *grid, double lambda, ms_error *error)
{
    double cell[2], top[2] = {0, 0};
    int start, halvings, rounds, side;
    cell[0] = (grid->x1 - grid->x0) / (grid->columns - 1), cell[1] = (grid->y1 - grid->y0) / (grid->rows - 1);
    for (start = 0; start < 2; ++start) {
        variant_found at = variants__best(v, lambda, start ? top : NULL, cell);
        double step = 1;
        if (start == 0) memcpy(top, at.latent, sizeof top);
        for (halvings = 0, rounds = 0; halvings < VARIANTS__HALVINGS && rounds < VARIANTS__ROUNDS; ++rounds) {
            double around[8], value = at.value;
            ms_status status;
            for (side = 0; side < 4; ++side) {
                const double sign = side % 2 ? -step : step;
                around[2 * side] = fmin(fmax(at.latent[0] + (side < 2 ? sign * cell[0] : 0), grid->x0), grid->x1);
                around[2 * side + 1] = fmin(fmax(at.latent[1] + (side < 2 ? 0 : sign * cell[1]), grid->y0), grid->y1);
            }
            status = variants__look(v, around, 4, v->x, error);
            if (status != MS_OK) return status;
            for (side = 1; side <= 4; ++side) {
                const variant_found *seen = &v->seen[v->count - side];
                if (!(variants__value(v, seen, lambda) > at.value) || variants__distance(v, seen) < v->apart) continue;
                at = *seen;
                at.value = variants__value(v, seen, lambda);
            }
            if (at.value > value) continue;
            step *= 0.5;
            ++halvings;
        }
    }
    return MS_OK;
}

/* The variants of largest value over the plane, for several lambda.
   lambda   [count], each in [0, 1]: 1 asks for the most similar material, 0 for the best
   best     the score that counts as 1; NaN, or the floor or less: the largest on the grid
   apart    no variant is nearer to one before it, while the plane has room: a share of the range that the embedded
            materials have there. Most lambdas have one of a few places, so that variants look alike with 0; 0.07 is
            3 to 17 of 255 in pictures
   found    [count] out; x [count][m] out, or NULL: their materials
   All lambdas share what was looked at: with 0, more lambda never means less similarity times confidence. */
static inline ms_status variants_find(const ms_gpr_latent *plane, const ms_gpr *gp, const variant_similarity *like,
                                      const map_grid *grid, const double *lambda, int count, double best, double apart,
                                      variant_found *found, double *x, ms_error *error)
{
    const ms_gpr_latent_view view = ms_gpr_latent_view_of(plane);
    const int m = view.m, points = grid->columns * grid->rows;
    double least[2] = {0, 0};
    double *grid_x = (double *)malloc((size_t)points * (size_t)m * sizeof *grid_x);
    double *at = (double *)malloc(2 * (size_t)points * sizeof *at);
    variants v;
    ms_status status = MS_OUT_OF_MEMORY;
    int i;
    memset(&v, 0, sizeof v);
    v.plane = plane, v.gp = gp, v.like = like;
    v.chosen = found;
    for (i = 0; i < 2 * view.z; ++i) least[i % 2] = i < 2 ? view.points[i] : fmin(least[i % 2], view.points[i]);
    for (i = 0; i < 2 * view.z; ++i) v.apart = fmax(v.apart, apart * (view.points[i] - least[i % 2]));
    v.floor = ms_gpr_view_of(gp).floor;
    v.best = best > v.floor ? best : -HUGE_VAL;
    v.x = (double *)malloc(4 * (size_t)m * sizeof *v.x);
    v.seen = (variant_found *)malloc(((size_t)points + 1 + (size_t)count * 8 * VARIANTS__ROUNDS) * sizeof *v.seen);
    if (grid_x && at && v.x && v.seen) status = variants__pictures(like, &v.pictures, error);
    else snprintf(error->message, sizeof error->message, "no memory for variants");
    if (status == MS_OK) {
        for (i = 0; i < points; ++i) map_point(grid, i % grid->columns, i / grid->columns, at + 2 * i);
        status = variants__look(&v, at, points, grid_x, error);
        if (status == MS_OK) status = variants__look_nearest(&v, error);
        for (i = 0; i < v.count && !(best > v.floor); ++i) v.best = fmax(v.best, v.seen[i].score);
        if (!(v.best > v.floor)) v.best = v.floor + 1;
        for (i = 0; i < count && status == MS_OK && (i == 0 || !(v.apart > 0)); ++i)
            status = variants__refine(&v, grid, lambda[i], error);
        for (i = 0; i < count && status == MS_OK; ++i) {
            v.choices = i;
            if (i > 0 && v.apart > 0) status = variants__refine(&v, grid, lambda[i], error); /* beside those before */
            found[i] = variants__best(&v, lambda[i], NULL, NULL);
            if (x && status == MS_OK)
                status = ms_gpr_latent_map(plane, found[i].latent, 1, x + (size_t)i * (size_t)m, NULL, error);
        }
        free(v.pictures);
    }
    free(grid_x), free(at), free(v.x), free(v.seen);
    return status;
}
#endif
