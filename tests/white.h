/* White Monte Carlo: a reference for the half-space solver that shares nothing with it but Fresnel's formulae. Photons
   that leave a half-space of isotropic scattering without absorption are counted by ring and by the number j of
   collisions before they left: R_d(r) of any albedo a is the sum over j of a^j times the share of j. Lengths in mean
   free paths. */
#ifndef WHITE_H
#define WHITE_H
#include "test.h"

#define WHITE_RINGS 138   /* 0, then 0.05 to 2000, 8% apart */
#define WHITE_HALVING 64u /* at collisions 64, 128, 256, ... half of the photons end and the rest count double */
#define WHITE_BINS (64 + 24 * 32) /* of j: one each below 64, then 32 an octave */

typedef struct white {
    double eta, photons, edge[WHITE_RINGS + 1];
    uint32_t count[WHITE_BINS][WHITE_RINGS + 1]; /* the last is beyond the rings */
} white;

static int white_bin(uint32_t j)
{
    int octave = 0;
    while (j >> (octave + 6)) ++octave;
    if (octave > 24) return WHITE_BINS - 1;
    return octave ? 32 + 32 * octave + (int)((j >> octave) - 32) : (int)j;
}

static void white_run(white *w, double eta, int photons, uint64_t *seed)
{
    int i, p;
    memset(w, 0, sizeof *w);
    w->eta = eta;
    w->photons = photons;
    for (i = 0; i <= WHITE_RINGS; ++i) w->edge[i] = i ? 0.05 * pow(1.08, i - 1) : 0;
    for (p = 0; p < photons; ++p) {
        double x = 0, y = 0, z = 0, mu = 1, cosine = 1, sine = 0;
        uint32_t j;
        for (j = 0;; ++j) {
            const double s = -log(test_uniform(seed)), across = sqrt((1 - mu) * (1 + mu)), below = z + s * mu;
            if (j >= WHITE_HALVING && (j & (j - 1)) == 0 && test_random_u64(seed) >> 63) break;
            if (below < 0) { /* Fresnel, unpolarised */
                const double in = -mu, square = 1 - eta * eta * (1 - mu * mu), out = square > 0 ? sqrt(square) : 0,
                             part = z / in;
                const double rs = (eta * in - out) / (eta * in + out), rp = (eta * out - in) / (eta * out + in);
                if (test_uniform(seed) >= 0.5 * (rs * rs + rp * rp)) {
                    const double u = x + part * across * cosine, v = y + part * across * sine, r = sqrt(u * u + v * v);
                    for (i = r < w->edge[1] ? 0 : 1 + (int)(log(r / 0.05) / log(1.08));
                         i > 0 && i < WHITE_RINGS && r < w->edge[i];)
                        --i;
                    while (i < WHITE_RINGS && r >= w->edge[i + 1]) ++i;
                    ++w->count[white_bin(j)][i < WHITE_RINGS ? i : WHITE_RINGS];
                    break;
                }
            }
            x += s * across * cosine;
            y += s * across * sine;
            z = fabs(below); /* reflected: the mirror image */
            do {             /* any direction: a point in the disc gives the azimuth */
                cosine = 2 * test_uniform(seed) - 1;
                sine = 2 * test_uniform(seed) - 1;
                mu = cosine * cosine + sine * sine;
            } while (mu > 1 || !(mu > 1e-12));
            cosine /= sqrt(mu);
            sine /= sqrt(mu);
            mu = 2 * mu - 1; /* uniform in (-1, 1), apart from the azimuth */
        }
    }
}

/* Ring averages per mean free path squared and the total, each with one standard error. */
static void white_profile(const white *w, double albedo, double *rd, double *rd_error, double *total,
                          double *total_error)
{
    static double power[WHITE_BINS];
    double sum_all = 0, squares_all = 0, n = w->photons, entering = (w->eta - 1) / (w->eta + 1);
    int ring, bin;
    for (bin = 0; bin < WHITE_BINS; ++bin) {
        const int octave = bin < 64 ? 0 : (bin - 32) / 32;
        const double wide = (double)(1u << octave),
                     j = (bin < 64 ? bin : ((bin - 32) % 32 + 32) * wide) + 0.5 * (wide - 1);
        double doubled = 1, at;
        for (at = j; at >= WHITE_HALVING; at *= 0.5) doubled *= 2;
        power[bin] = (1 - entering * entering) * doubled * pow(albedo, j);
    }
    for (ring = 0; ring <= WHITE_RINGS; ++ring) {
        double sum = 0, squares = 0, area;
        for (bin = 0; bin < WHITE_BINS; ++bin) {
            sum += w->count[bin][ring] * power[bin];
            squares += w->count[bin][ring] * power[bin] * power[bin];
        }
        sum_all += sum;
        squares_all += squares;
        if (ring == WHITE_RINGS) continue;
        area = 3.14159265358979324 * (w->edge[ring + 1] - w->edge[ring]) * (w->edge[ring + 1] + w->edge[ring]);
        rd[ring] = sum / n / area;
        rd_error[ring] = sqrt((squares / n - sum / n * sum / n) / (n - 1)) / area;
    }
    *total = sum_all / n;
    *total_error = sqrt((squares_all / n - *total * *total) / (n - 1));
}
#endif
