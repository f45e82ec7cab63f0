/* Maps over the latent plane of ms_gpr.h as pictures; ms_gpr.h and image.h come first.

     map_draw(&im, left, top, side, &grid, value, &confidence_grid, confidence);   a square of side x side pixels
     map_dot(&im, left, top, side, &grid, latent, radius, rgb);                    a dot at a latent point in it */
#ifndef EXAMPLES_MAPS_H
#define EXAMPLES_MAPS_H

/* Violet, blue, green and yellow from the least to the largest value that is known to some extent; grey where the confidence is 0, and
   a thin line where it is a half: beyond, the map guesses. */
static inline void map_draw(image *im, int left, int top, int side, const ms_gpr_grid *grid, const double *value,
                            const ms_gpr_grid *confidence_grid, const double *confidence)
{
    static const double stop[4][3] = {{0.27, 0.0, 0.33}, {0.19, 0.41, 0.56}, {0.21, 0.72, 0.47}, {0.99, 0.91, 0.14}};
    double least = value[0], most = value[0];
    int x, y, c, i, known = 0;
    for (y = 0; y < grid->rows; ++y)
        for (x = 0; x < grid->columns; ++x) {
            double at[2];
            ms_gpr_grid_point(grid, x, y, at);
            i = y * grid->columns + x;
            if (ms_gpr_grid_value(confidence_grid, confidence, at[0], at[1]) < 0.25) continue;
            least = !known || value[i] < least ? value[i] : least;
            most = !known || value[i] > most ? value[i] : most;
            known = 1;
        }
    for (y = 0; y < side; ++y)
        for (x = 0; x < side; ++x) {
            double a = grid->x0 + (grid->x1 - grid->x0) * (x + 0.5) / side, b = grid->y1 - (grid->y1 - grid->y0) * (y + 0.5) / side;
            double at = most > least ? 3 * (ms_gpr_grid_value(grid, value, a, b) - least) / (most - least) : 0;
            double sure = ms_gpr_grid_value(confidence_grid, confidence, a, b), pixel = (grid->x1 - grid->x0) / side;
            double beside = ms_gpr_grid_value(confidence_grid, confidence, a + pixel, b), below = ms_gpr_grid_value(confidence_grid, confidence, a, b + pixel);
            int edge = (sure < 0.5) != (beside < 0.5) || (sure < 0.5) != (below < 0.5);
            at = at > 0 ? at < 3 ? at : 3 : 0;
            i = at < 2 ? (int)at : 2;
            sure = sure > 0 ? sure < 1 ? sure : 1 : 0;
            for (c = 0; c < 3; ++c)
                im->pixels[3 * ((top + y) * im->width + left + x) + c] =
                    (float)(edge ? 0.6 : sure * (stop[i][c] + (at - i) * (stop[i + 1][c] - stop[i][c])) + (1 - sure) * 0.2);
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
