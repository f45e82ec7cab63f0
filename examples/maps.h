/* Maps over the latent plane of ms_gpr.h as pictures; ms_gpr.h and image.h come first.

     map_draw(&im, left, top, side, &grid, value, &confidence_grid, confidence);   a square of side x side pixels
     map_dot(&im, left, top, side, &grid, latent, radius, rgb);                    a dot at a latent point in it */
#ifndef EXAMPLES_MAPS_H
#define EXAMPLES_MAPS_H

/* Violet, blue, green and yellow from the least to the largest value; dark where the confidence is 0. */
static inline void map_draw(image *im, int left, int top, int side, const ms_gpr_grid *grid, const double *value,
                            const ms_gpr_grid *confidence_grid, const double *confidence)
{
    static const double stop[4][3] = {{0.27, 0.0, 0.33}, {0.19, 0.41, 0.56}, {0.21, 0.72, 0.47}, {0.99, 0.91, 0.14}};
    double least = value[0], most = value[0];
    int x, y, c, i;
    for (i = 0; i < grid->columns * grid->rows; ++i) {
        least = value[i] < least ? value[i] : least;
        most = value[i] > most ? value[i] : most;
    }
    for (y = 0; y < side; ++y)
        for (x = 0; x < side; ++x) {
            double a = grid->x0 + (grid->x1 - grid->x0) * (x + 0.5) / side, b = grid->y1 - (grid->y1 - grid->y0) * (y + 0.5) / side;
            double at = most > least ? 3 * (ms_gpr_grid_value(grid, value, a, b) - least) / (most - least) : 0;
            double light = 0.25 + 0.75 * ms_gpr_grid_value(confidence_grid, confidence, a, b);
            i = at < 2 ? (int)at : 2;
            for (c = 0; c < 3; ++c)
                im->pixels[3 * ((top + y) * im->width + left + x) + c] =
                    (float)(light * (stop[i][c] + (at - i) * (stop[i + 1][c] - stop[i][c])));
        }
}

static inline void map_dot(image *im, int left, int top, int side, const ms_gpr_grid *grid, const double *latent, double radius,
                           const float *rgb)
{
    double cx = (latent[0] - grid->x0) / (grid->x1 - grid->x0) * side, cy = (grid->y1 - latent[1]) / (grid->y1 - grid->y0) * side;
    int x, y, c;
    for (y = 0; y < side; ++y)
        for (x = 0; x < side; ++x)
            for (c = 0; c < 3; ++c)
                if (hypot(x + 0.5 - cx, y + 0.5 - cy) < radius) im->pixels[3 * ((top + y) * im->width + left + x) + c] = rgb[c];
}
#endif
