/* A reference for the tests: totals of half-spaces of any g by discrete ordinates. It shares Fresnel's formula and
   Gauss nodes with layered.h, nothing else. */
#ifndef ORDINATES_H
#define ORDINATES_H
#include "layered.h"
#include <math.h>
#include <string.h>

enum { ORDINATES = 28 };

/* Inverse of a symmetric positive matrix in place, rows of NODES apart, by sweeping its lower half; the logarithm of
   its determinant. */
static double ordinates_inverse(double a[][ORDINATES], int n)
{
    double column[ORDINATES], log_determinant = 0;
    int i, j, k;
    for (k = 0; k < n; ++k) {
        const double p = 1 / a[k][k];
        log_determinant += log(a[k][k]);
        for (i = 0; i < n; ++i) column[i] = i < k ? a[k][i] : a[i][k];
        column[k] = -1;
        for (i = 0; i < n; ++i) {
            const double q = p * column[i];
            if (i == k) continue;
            for (j = 0; j <= i; ++j) a[i][j] -= q * column[j];
            if (i > k) a[i][k] = q;
        }
        for (j = 0; j < k; ++j) a[k][j] = p * column[j];
        a[k][k] = -p;
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j) a[j][i] = a[i][j] = -a[i][j];
    return log_determinant;
}

/* Diffuse reflectance of a half-space of Henyey-Greenstein scattering under a beam at normal incidence. By reciprocity
   it is the radiance along the normal under even light from outside. Discrete ordinates, Gauss on both sides of the
   critical angle (Stamnes et al. 1988 for the equations); with S and D the sums and differences of up and down, M the
     cosines, M S' = -A D,  M D' = -B S,  A, B = 1 - albedo x odd, even moments,
   the solution that decays is D = Y S, Y A Y = B: symmetric after scaling by sqrt(M), where it is the geometric mean of
   B and 1 / A, found by Newton's iteration (Denman & Beavers 1976, with Higham's scaling). Single scattering with the
   whole phase function (Nakajima & Tanaka 1988). nodes: of each of the two panels. */
static double ordinates_reflected(double absorbed, double g, double eta, int nodes)
{
    enum { N = ORDINATES };
    double a[N][N], x[N][N], v[N][N], t[N][N], mu[N], w[N], rho[N], root[N], s[N], q[N], y[N], z[N];
    const double cut = eta > 1 ? sqrt((eta - 1) * (eta + 1)) / eta : 0,
                 r = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    const int most = nodes + nodes / 4, below = eta > 1 ? most / 2 + 1 : 0, n = nodes + below;
    const double f = g > 0 ? pow(g, most + 1) : 0, left = absorbed + (1 - absorbed) * (1 - f),
                 albedo = (1 - absorbed) * (1 - f) / left;
    double(*legendre)[N] = t, out = 0, odd = 0, single = 0, even = 1, more, power;
    int i, j, l, turn;
    layered__gauss(nodes, mu, w);
    for (i = 0; i < nodes; ++i) { /* the root at the critical angle becomes smooth */
        w[i] *= 2 * (1 - cut) * mu[i];
        mu[i] = cut + (1 - cut) * mu[i] * mu[i];
    }
    layered__gauss(below, mu + nodes, w + nodes);
    for (i = nodes; i < n; ++i) {
        mu[i] *= cut;
        w[i] *= cut;
    }
    for (i = 0; i < n; ++i) {
        double p0 = 1, p1 = mu[i];
        rho[i] = layered__fresnel(eta, 1, eta * sqrt((1 - mu[i]) * (1 + mu[i])));
        root[i] = sqrt(mu[i]);
        for (l = 0; l <= most; ++l) {
            legendre[l][i] = p0 * sqrt(w[i]);
            power = ((2 * l + 3) * mu[i] * p1 - (l + 1) * p0) / (l + 2);
            p0 = p1;
            p1 = power;
        }
        for (j = 0; j < n; ++j) a[i][j] = x[i][j] = i == j;
    }
    for (l = 0, power = 1; l <= most; ++l, power *= g) {
        const double moment = (2 * l + 1) * albedo * (power - f) / (1 - f);
        double surplus =
            0; /* of the quadrature, which would make or lose light: it goes to or comes from straight ahead */
        for (i = 0; i < n; ++i) {
            surplus += l > 0 ? legendre[l][i] * sqrt(w[i]) : 0;
            for (j = 0; j <= i; ++j) (l & 1 ? a : x)[i][j] -= moment * legendre[l][i] * legendre[l][j];
        }
        for (i = 0; i < n && !(l & 1); ++i) {
            const double ahead = moment * surplus * legendre[l][i] / sqrt(w[i]);
            x[i][i] += ahead;
            a[i][i] += ahead;
        }
        if (!(l & 1)) even += moment / albedo * surplus;
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j) {
            x[j][i] = x[i][j] /= root[i] * root[j];
            v[j][i] = v[i][j] = a[j][i] = a[i][j] /= root[i] * root[j];
        }
    memcpy(t, a, sizeof t);
    more = ordinates_inverse(t, n);
    for (turn = 0; turn < 40;
         ++turn) { /* x to Z, v to 1 / Z: each to its mean with the other's inverse; 1 / x v stays */
        double change = 0, scale = 1, size;
        memcpy(t, x, sizeof t);
        size = ordinates_inverse(t, n);
        if (turn == 0) more -= size; /* by which the logarithm of v's determinant is above that of x */
        if (turn < 6) scale = exp(-(size + 0.5 * more) / n);
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) t[i][j] = 0.5 * (scale * v[i][j] + t[i][j] / scale);
        ordinates_inverse(v, n);
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) {
                const double b = 0.5 * (scale * x[i][j] + v[i][j] / scale);
                if (i == j && fabs(b - x[i][j]) > change * b) change = fabs(b - x[i][j]) / b;
                x[i][j] = b;
            }
        memcpy(v, t, sizeof t);
        if (turn > 2 && change < 1e-9) break; /* quadratic: the next would be 1e-18 */
    }
    /* at the surface: ((1 + rho) Z (1 + rho) + (1 + rho) (1 - rho)) u = (1 + rho) (1 - Z) s, u: up, s: what comes in */
    for (i = 0; i < n; ++i) s[i] = (1 - rho[i]) * root[i] * sqrt(w[i]);
    for (i = 0; i < n; ++i) {
        q[i] = s[i];
        for (j = 0; j < n; ++j) {
            q[i] -= x[i][j] * s[j];
            t[i][j] = (1 + rho[i]) * x[i][j] * (1 + rho[j]) + (i == j ? (1 + rho[i]) * (1 - rho[i]) : 0);
        }
        q[i] *= 1 + rho[i];
    }
    ordinates_inverse(t, n);
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) s[i] += (1 + rho[i]) * t[i][j] * q[j];
    /* integrals times exp(-depth): of D (1 / Z + A) z = s, of S z / Z */
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) t[i][j] = v[i][j] + a[i][j];
    ordinates_inverse(t, n);
    for (i = 0; i < n; ++i)
        for (z[i] = 0, j = 0; j < n; ++j) z[i] += t[i][j] * s[j];
    for (i = 0; i < n; ++i)
        for (y[i] = 0, j = 0; j < n; ++j) y[i] += v[i][j] * z[j];
    for (i = 0; i < n;
         ++i) { /* scattered along the normal, and what the peak of the phase function adds to single scattering */
        const double b = 1 + g * g + 2 * g * mu[i], whole = (1 - absorbed) / left * (1 - g * g) / (b * sqrt(b));
        double p0 = 1, p1 = -mu[i], phase = 0;
        for (l = 0, power = 1; l <= most; ++l, power *= g) {
            const double moment = (2 * l + 1) * albedo * (power - f) / (1 - f),
                         next = ((2 * l + 3) * -mu[i] * p1 - (l + 1) * p0) / (l + 2);
            const double here = (l & 1 ? -moment * p0 : moment * p0) * sqrt(w[i]); /* p0: P_l(-mu) */
            if (l & 1) odd += here * z[i] / root[i];
            else out += here * y[i] / root[i];
            phase += moment * p0;
            p0 = p1;
            p1 = next;
        }
        single += w[i] * mu[i] / (1 + mu[i]) * (whole - phase) * (1 - rho[i]);
    }
    return 0.5 * ((out - odd) / even + single) * (1 - r);
}

/* Reflectance of a half-space. Below an absorption of 1e-12 the matrices are singular, and what is lost goes as its
   root. */
static double ordinates_total(double absorbed, double g, double eta)
{
    const double least = 1e-12, r = (eta - 1) / (eta + 1), most = 1 - r * r;
    const double total = ordinates_reflected(absorbed > least ? absorbed : least, g, eta, fabs(g) < 0.5 ? 14 : 17);
    return absorbed < least ? most - (most - total) * sqrt(absorbed / least) : total;
}
#endif
