/* Maps over the latent plane of ms_gpr.h (plane.h) as pictures; ms_gpr.h and image.h come first.

     map_draw(&im, left, top, side, &grid, value, &confidence_grid, confidence);   a square of side x side pixels
     map_dot(&im, left, top, side, &grid, latent, radius, rgb);                    a dot at a latent point in it
     map_picture(&im, left, top, side, &grid, latent, planes, size, pixels);       a picture [3][size][size] there
     map_legend(&im, left, top, width, "score", least, most);   the colors and what they mean, 22 pixels high */
#ifndef EXAMPLES_MAPS_H
#define EXAMPLES_MAPS_H
#include "plane.h"
#include "text.h"

static inline void map__color(double at, float *rgb) /* at: from 0 to 1 */
{
    static const double stop[4][3] = {{0.27, 0.0, 0.33}, {0.19, 0.41, 0.56}, {0.21, 0.72, 0.47}, {0.99, 0.91, 0.14}};
    int i, c;
    at = at > 0 ? at < 1 ? 3 * at : 3 : 0;
    i = at < 2 ? (int)at : 2;
    for (c = 0; c < 3; ++c) rgb[c] = (float)(stop[i][c] + (at - i) * (stop[i + 1][c] - stop[i][c]));
}

/* The least and the largest value that is known to some extent. */
static inline void map_range(const map_grid *grid, const double *value, const map_grid *confidence_grid,
                             const double *confidence, double *least, double *most)
{
    int x, y, known = 0;
    *least = *most = value[0];
    for (y = 0; y < grid->rows; ++y)
        for (x = 0; x < grid->columns; ++x) {
            double at[2], v = value[y * grid->columns + x];
            map_point(grid, x, y, at);
            if (map_value(confidence_grid, confidence, at[0], at[1]) < 0.25) continue;
            *least = !known || v < *least ? v : *least;
            *most = !known || v > *most ? v : *most;
            known = 1;
        }
}

/* Violet, blue, green and yellow from the least to the largest value that is known to some extent; gray where the
   confidence is 0, and a thin line where it is a half: beyond, the map guesses. */
static inline void map_draw(image *im, int left, int top, int side, const map_grid *grid, const double *value,
                            const map_grid *confidence_grid, const double *confidence)
{
    double least, most;
    int x, y, c;
    map_range(grid, value, confidence_grid, confidence, &least, &most);
    for (y = 0; y < side; ++y)
        for (x = 0; x < side; ++x) {
            double a = grid->x0 + (grid->x1 - grid->x0) * (x + 0.5) / side,
                   b = grid->y1 - (grid->y1 - grid->y0) * (y + 0.5) / side;
            double sure = map_value(confidence_grid, confidence, a, b), pixel = (grid->x1 - grid->x0) / side;
            double beside = map_value(confidence_grid, confidence, a + pixel, b),
                   below = map_value(confidence_grid, confidence, a, b + pixel);
            int edge = (sure < 0.5) != (beside < 0.5) || (sure < 0.5) != (below < 0.5);
            float rgb[3];
            map__color(most > least ? (map_value(grid, value, a, b) - least) / (most - least) : 0, rgb);
            sure = sure > 0 ? sure < 1 ? sure : 1 : 0;
            for (c = 0; c < 3; ++c)
                im->pixels[3 * ((top + y) * im->width + left + x) + c] = (float)(edge ? 0.6
                                                                                      : sure * (double)rgb[c] +
                                                                                         (1 - sure) * 0.2);
        }
}

/* max(preference, 0) * similarity on the preference's grid; the similarity has a grid of its own. */
static inline void map_product(const map_grid *grid, const double *preference, const map_grid *similarity_grid,
                               const double *similarity, double *product)
{
    int row, column;
    for (row = 0; row < grid->rows; ++row)
        for (column = 0; column < grid->columns; ++column) {
            size_t i = (size_t)row * (size_t)grid->columns + (size_t)column;
            double at[2];
            map_point(grid, column, row, at);
            product[i] = fmax(preference[i], 0) * map_value(similarity_grid, similarity, at[0], at[1]);
        }
}

static inline void map_dot(image *im, int left, int top, int side, const map_grid *grid, const double *latent,
                           double radius, const float *rgb)
{
    double cx = (latent[0] - grid->x0) / (grid->x1 - grid->x0) * side,
           cy = (grid->y1 - latent[1]) / (grid->y1 - grid->y0) * side;
    const int x0 = (int)fmax(0, fmin(side, cx - radius - 1)),
              y0 = (int)fmax(0, fmin(side, cy - radius - 1)); /* NaN: nothing */
    int x, y, c;
    for (y = y0; y < side && y < cy + radius + 1; ++y)
        for (x = x0; x < side && x < cx + radius + 1; ++x) {
            double cover = fmin(radius + 0.5 - hypot(x + 0.5 - cx, y + 0.5 - cy), 1);
            float *pixel = &im->pixels[3 * ((top + y) * im->width + left + x)];
            for (c = 0; cover > 0 && c < 3; ++c) pixel[c] += (float)cover * (rgb[c] - pixel[c]);
        }
}

/* The middle of the picture is at the latent point, but all of it inside the map. */
static inline void map_picture(image *im, int left, int top, int side, const map_grid *grid, const double *latent,
                               const float *planes, int size, int pixels)
{
    int cx = (int)((latent[0] - grid->x0) / (grid->x1 - grid->x0) * side) - pixels / 2,
        cy = (int)((grid->y1 - latent[1]) / (grid->y1 - grid->y0) * side) - pixels / 2;
    int x, y, c, i, k;
    cx = cx < 0 ? 0 : cx > side - pixels ? side - pixels : cx;
    cy = cy < 0 ? 0 : cy > side - pixels ? side - pixels : cy;
    for (y = 0; y < pixels; ++y)
        for (x = 0; x < pixels; ++x)
            for (c = 0; c < 3; ++c) { /* the mean of what a pixel covers */
                int x0 = x * size / pixels, x1 = (x + 1) * size / pixels, y0 = y * size / pixels,
                    y1 = (y + 1) * size / pixels;
                double sum = 0, count = 0;
                x1 = x1 > x0 ? x1 : x0 + 1;
                y1 = y1 > y0 ? y1 : y0 + 1;
                for (k = y0; k < y1; ++k)
                    for (i = x0; i < x1; ++i) sum += (double)planes[(c * size + k) * size + i], count += 1;
                im->pixels[3 * ((top + cy + y) * im->width + left + cx + x) + c] = (float)(sum / count);
            }
}

/* name, the colors from least to most between both numbers, and the gray of what is not known. */
static inline void map_legend(image *im, int left, int top, int width, const char *name, double least, double most)
{
    static const float white[3] = {1, 1, 1}, gray[3] = {0.2f, 0.2f, 0.2f};
    char low[48], high[48];
    int x, y, c, from, to;
    snprintf(low, sizeof low, "%.2g", least);
    snprintf(high, sizeof high, "%.2g", most);
    from = left + image_text_width(name, 16) + 10 + image_text_width(low, 16) + 8;
    to = left + width - 24 - image_text_width(high, 16) - 8;
    image_text(im, left, top + 3, name, 16, white);
    image_text(im, from - 8 - image_text_width(low, 16), top + 3, low, 16, white);
    image_text(im, to + 8, top + 3, high, 16, white);
    for (y = 2; y < 20; ++y) {
        for (x = from; x < to; ++x) {
            float rgb[3];
            map__color((x + 0.5 - from) / (to - from), rgb);
            for (c = 0; c < 3; ++c) im->pixels[3 * ((top + y) * im->width + x) + c] = rgb[c];
        }
        for (x = left + width - 20; x < left + width - 2; ++x)
            for (c = 0; c < 3; ++c) im->pixels[3 * ((top + y) * im->width + x) + c] = gray[c];
    }
    image_text_in(im, left + width - 20, top + 3, 18, "?", 16, white);
}
#endif
