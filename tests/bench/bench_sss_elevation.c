/* How the elevation of ms_sss.h stands to random walks in balls, hollows and cylinders: the light that returns by
   reflectance sum(w f) / sum(w), 1 at most, with the rings of a walk below a plane, over the light that the walk
   returns. */
#include "bench.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/ball.h"

enum { ALBEDOS = 7, SHAPES = 8 };
static const double albedo[ALBEDOS] = {0.3, 0.5, 0.7, 0.9, 0.98, 0.993, 0.999};
static const double radius[SHAPES] = {32, 8, 4, 2, -16, -4, 8, 4}; /* mean free paths; negative: a hollow */

/* What the rings of the plane return on a ball or hollow, or on a cylinder, with elevation K. */
static double returned(const ball_tally *plane, int i, ball_shape shape, double a, double K)
{
    double with = 0, without = 0;
    int b, k;
    for (b = 0; b < BALL_BINS; ++b) {
        double r0 = ball_edge(b), r1 = ball_edge(b + 1), r = 0.5 * (r0 + r1), f;
        double density = plane->ring[i][b] / (3.14159265358979 * (r1 * r1 - r0 * r0));
        if (shape == BALL_SPHERE) { /* the area within a distance r on a ball is pi r^2, as on a plane */
            if (r > 2 * fabs(a)) break;
            f = 1 + K * r / (8 * a);
            with += plane->ring[i][b] * (f > 0 ? f * f * f * f : 0);
            without += plane->ring[i][b];
        } else {
            for (k = 0; k < 400; ++k) {
                double turn = 3.14159265358979 * (k + 0.5) / 400, c = 2 * a * sin(turn / 2), area;
                if (c >= r1) break;
                area = 4 * a * 3.14159265358979 / 400 * (sqrt(r1 * r1 - c * c) - (r0 > c ? sqrt(r0 * r0 - c * c) : 0));
                f = 1 + K * c * c / (8 * a * (r > c ? r : c));
                with += density * area * f * f * f * f;
                without += density * area;
            }
        }
    }
    with *= plane->total[i] / without;
    return with < 1 ? with : 1;
}

int main(void)
{
    static const double index[] = {1, 1.2, 1.4, 1.5};
    const long walks = 300000;
    static ball_tally plane, body;
    static double ratio[ALBEDOS][SHAPES], flat[ALBEDOS][SHAPES];
    double error = 0, start = bench_cpu();
    FILE *md = bench_open("sss_elevation.md");
    int n, i, s;
    fprintf(
        md,
        "Light that a body returns by the elevation over what %ld random walks return, - 1 in %%; in brackets by the flat profile alone.\n"
        "Radii in mean free paths; R: reflectance of the plane, K: ms_sss_elevation. `make bench FILTER=sss_elevation`.\n\n"
        "| index | albedo | R | K |",
        walks);
    for (s = 0; s < SHAPES; ++s)
        fprintf(md, " %s %g |", s >= 6 ? "cylinder" : radius[s] > 0 ? "ball" : "hollow", fabs(radius[s]));
    fprintf(md, "\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (n = 0; n < 4; ++n) {
        ball_walk(BALL_SPHERE, 0, index[n], albedo, ALBEDOS, 3 * walks, 1, &plane);
        for (s = 0; s < SHAPES; ++s) {
            ball_shape shape = s >= 6 ? BALL_CYLINDER : BALL_SPHERE;
            ball_walk(shape, 1 / radius[s], index[n], albedo, ALBEDOS, walks, 2 + (uint64_t)s, &body);
            for (i = 0; i < ALBEDOS; ++i) {
                ratio[i][s] = returned(&plane, i, shape, radius[s], ms_sss_elevation(plane.total[i], index[n])) /
                        body.total[i] -
                    1;
                flat[i][s] = plane.total[i] / body.total[i] - 1;
                if (sqrt(body.square[i] / (double)walks) / body.total[i] > error)
                    error = sqrt(body.square[i] / (double)walks) / body.total[i];
            }
        }
        for (i = 0; i < ALBEDOS; ++i) {
            fprintf(md, "| %g | %g | %.3f | %.2f |", index[n], albedo[i], plane.total[i],
                    ms_sss_elevation(plane.total[i], index[n]));
            for (s = 0; s < SHAPES; ++s) fprintf(md, " %+.1f (%+.0f) |", 100 * ratio[i][s], 100 * flat[i][s]);
            fprintf(md, "\n");
        }
    }
    fprintf(md, "\nStandard error of a total at most %.1f%%.\n", 100 * error);
    printf("elevation: %.0f s\n", bench_cpu() - start);
    return fclose(md) != 0;
}
