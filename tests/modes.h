/* A taste of one to four separate modes whose shares are known exactly, however rare it is: all modes are the same
   function about their centers, in eight of m dimensions, but for the order of the dimensions; the center of one lies
   on a face of the box, which halves it, that of another on two. ms_gpr.h and test.h come first.

     modes_world w = modes_make(modes, m);      w.gp is to be destroyed
     int mode = modes_of(&w, x);
     w.share[mode], modes_tau[0 to 2]: about 1e-3, 1e-6 and 1e-9 of the box are above */
#ifndef TEST_MODES_H
#define TEST_MODES_H

enum { MODES_MAX = 4, MODES_D = 8, MODES_PAIRS = 30, MODES_M = 38 };

static const double modes_tau[3] = {0.42, 0.80, 0.974};
static const double modes_center[MODES_MAX][MODES_D] = {{0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25},
                                                        {0.75, 0.75, 0.75, 0.75, 0.75, 0.75, 1, 0.75},
                                                        {0.25, 0.25, 0.75, 0.75, 0.75, 0, 0, 0.25},
                                                        {0.75, 0.75, 0.25, 0.25, 0.25, 0.75, 0.25, 0.25}};

typedef struct modes_world {
    int modes, m;
    double share[MODES_MAX];
    ms_gpr *gp;
    ms_gpr_recommend_options options; /* the unit box */
} modes_world;

static modes_world modes_make(int modes, int m)
{
    static const double volume[MODES_MAX] = {1, 0.5, 0.25, 1};
    static double x[MODES_MAX * (2 * MODES_PAIRS + 1) * MODES_M], y[MODES_MAX * (2 * MODES_PAIRS + 1)],
        offset[MODES_PAIRS][MODES_M];
    static double low[MODES_M], high[MODES_M];
    modes_world w;
    uint64_t state = 3;
    double theta[MODES_M + 2], total = 0;
    int n = 0, i, k, c;
    memset(&w, 0, sizeof w);
    w.modes = modes;
    w.m = m;
    for (i = 0; i < MODES_PAIRS; ++i)
        for (k = 0; k < m; ++k)
            offset[i][k] = k < MODES_D ? (i % 2 ? 0.12 : 0.25) * test_normal(&state) : test_uniform(&state) - 0.5;
    for (c = 0; c < modes; ++c)
        for (i = -1; i < 2 * MODES_PAIRS;
             ++i, ++n) { /* the center, and pairs on either side of it, out of the box as well */
            double d2 = 0;
            for (k = 0; k < m; ++k) {
                double d = i < 0 ? 0 : offset[i / 2][k] * (i % 2 ? -1 : 1), width = k % 2 ? 0.3 : 0.2;
                int to = k < MODES_D ? (k + 2 * c) % MODES_D : k;
                x[n * m + to] = (k < MODES_D ? modes_center[c][to] : 0.5) + d;
                if (k < MODES_D) d2 += d * d / (width * width);
            }
            y[n] = 10 * exp(-0.5 * d2);
        }
    for (k = 0; k < m + 2; ++k) theta[k] = k < MODES_D ? log(0.3) : k < m ? log(50.0) : k == m ? log(5.0) : log(0.05);
    if (ms_gpr_create(x, y, n, m, theta, NULL, &w.gp, NULL) != MS_OK) exit(1);
    for (c = 0; c < modes; ++c) total += volume[c];
    for (c = 0; c < modes; ++c) w.share[c] = volume[c] / total;
    for (k = 0; k < m; ++k) high[k] = 1;
    w.options.space.low = low;
    w.options.space.high = high;
    return w;
}

static int modes_of(const modes_world *w, const double *x)
{
    double nearest = 1e300;
    int best = 0, c, k;
    for (c = 0; c < w->modes; ++c) {
        double d2 = 0;
        for (k = 0; k < MODES_D; ++k) d2 += (x[k] - modes_center[c][k]) * (x[k] - modes_center[c][k]);
        if (d2 < nearest) best = c, nearest = d2;
    }
    return best;
}

/* Mean squared error of the shares of `count` materials. */
static double modes_error2(const modes_world *w, const double *x, int count)
{
    double got[MODES_MAX] = {0, 0, 0, 0}, sum = 0;
    int i, c;
    for (i = 0; i < count; ++i) got[modes_of(w, x + i * w->m)] += 1.0 / count;
    for (c = 0; c < w->modes; ++c) sum += (got[c] - w->share[c]) * (got[c] - w->share[c]) / w->modes;
    return sum;
}

#endif
