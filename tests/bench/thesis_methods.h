/* The optimizers that the thesis compares (section 4.3, Table 4.3), for the benchmarks: Nelder-Mead with an infinite
   barrier, L-BFGS, SQP (what SLSQP is when bounds are the only constraints) and conjugate gradient, each with
   projection and exact derivatives, or with the barrier and differences of 1.5e-8 as there. ms_pme.h, its
   implementation too, comes first. And basin hopping, a reference for the global minimum. */
#ifndef BENCH_THESIS_METHODS_H
#define BENCH_THESIS_METHODS_H
#include <float.h>
#include <math.h>

enum {
    THESIS_NELDER_MEAD,
    THESIS_NELDER_MEAD_BARRIER,
    THESIS_LBFGS,
    THESIS_CONJUGATE_GRADIENT,
    THESIS_SQP,
    THESIS_METHODS
};
static const char *const thesis_name[THESIS_METHODS] = {"nelder-mead", "nelder-mead-barrier", "l-bfgs",
                                                        "conjugate-gradient", "sqp"};

typedef struct thesis_options {
    int method, barrier; /* barrier: no projection, f is infinite outside the box */
    double max_cost, tolerance, start_step, difference_step;
} thesis_options;

/* ---- small maths ------------------------------------------------------------------------------------------------- */

#define THESIS__INF ((double)HUGE_VAL)
#define THESIS__MEMORY 8 /* pairs that L-BFGS keeps */
#define THESIS__ROWS 32  /* rows of the Jacobian that one QR update takes: they stay in the cache */

static double thesis__dot(const double *a, const double *b, int n)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

static double thesis__clip(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

static double thesis__max(double a, double b) { return a > b ? a : b; }

static void thesis__copy(double *to, const double *from, int n) { memcpy(to, from, (size_t)n * sizeof *to); }

/* Rows [k][n + 1] (the last column is the right-hand side) are folded into the upper triangle r [n + 1][n + 1] by
   Householder reflections of (r_jj, column j of the rows): the R of a QR factorization, built row block by row block
   (TSQR with a chain for a tree). The rows are destroyed. */
static void thesis__qr_append(double *r, int n, double *rows, int k)
{
    int w = n + 1, i, j, c;
    for (j = 0; j <= n; ++j) {
        double largest = fabs(r[j * w + j]), norm, head, beta;
        for (i = 0; i < k; ++i) largest = thesis__max(largest, fabs(rows[i * w + j]));
        if (!(largest > 0)) continue;
        norm = (r[j * w + j] / largest) * (r[j * w + j] / largest);
        for (i = 0; i < k; ++i) norm += (rows[i * w + j] / largest) * (rows[i * w + j] / largest);
        norm = largest * sqrt(norm);
        if (r[j * w + j] > 0) norm = -norm;
        head = r[j * w + j] - norm; /* v = (head, column), |v|^2 = -2 norm head */
        beta = 1 / (norm * head);
        r[j * w + j] = norm;
        for (c = j + 1; c <= n; ++c) {
            double t = head * r[j * w + c];
            for (i = 0; i < k; ++i) t += rows[i * w + j] * rows[i * w + c];
            t *= beta;
            r[j * w + c] += t * head;
            for (i = 0; i < k; ++i) rows[i * w + c] += t * rows[i * w + j];
        }
        for (i = 0; i < k; ++i) rows[i * w + j] = 0;
    }
}

/* ---- the run: budgets and evaluations ---------------------------------------------------------------------------- */

typedef struct thesis__run {
    const ms_pme_function *function;
    const thesis_options *options;
    int n, barrier, ranged; /* ranged: every parameter has one that means something */
    size_t m;
    double max_cost, tolerance, jacobian_cost, start_time;
    double *lower, *upper; /* [n] */
    double *best;          /* [n] the best point evaluated, and its value */
    double best_value;
    double *residual, *residual_step; /* [m] of the last evaluation; of a difference */
    double *jacobian;                 /* [m][n] of the last one with derivatives */
    double *triangle;                 /* [n + 1][n + 1] */
    double *rows;                     /* [ROWS][n + 1] */
    double *scratch;                  /* what the methods share out among themselves */
    ms_pme_result result;
    int stopped; /* a budget, the target, a failure: nothing more may be evaluated */
    ms_status status;
} thesis__run;

static int thesis__stop(thesis__run *run, ms_pme_stop why)
{
    if (!run->stopped) run->result.stop = why;
    return run->stopped = 1;
}

static int thesis__fail(thesis__run *run, ms_status status)
{
    run->status = status;
    return run->stopped = 1;
}

/* Asked before every callback: is there budget for one of this cost? Non-zero: no, the run is over. */
static int thesis__spend(thesis__run *run, double cost)
{
    if (run->stopped) return 1;
    if (run->result.cost + cost > run->max_cost * (1 + 1e-12)) return thesis__stop(run, MS_PME_STOP_COST);
    run->result.cost += cost;
    return 0;
}

/* Every value goes through here: NaN becomes infinity, the best point is kept, the target is looked for. */
static double thesis__seen(thesis__run *run, const double *x, double f)
{
    if (!isfinite(f)) return THESIS__INF;
    if (f < run->best_value) {
        run->best_value = f;
        thesis__copy(run->best, x, run->n);
    }
    return f;
}

static int thesis__outside(const thesis__run *run, const double *x)
{
    int j;
    for (j = 0; j < run->n; ++j)
        if (!(x[j] >= run->lower[j] && x[j] <= run->upper[j])) return 1;
    return 0;
}

static double thesis__sum_of_squares(const double *r, size_t m)
{
    double sum = 0;
    size_t i;
    for (i = 0; i < m; ++i) sum += r[i] * r[i];
    return sum;
}

/* f(x); infinity outside the box, for NaN, and once the run has stopped. With residuals they go to r [m]. */
static double thesis__value_to(thesis__run *run, const double *x, double *r)
{
    const ms_pme_function *function = run->function;
    double f = 0;
    ms_status status;
    if (thesis__spend(run, 1)) return THESIS__INF;
    run->result.evaluations++;
    if (thesis__outside(run, x)) return THESIS__INF;
    status = function->residuals(function->user, x, r, NULL);
    if (status == MS_OK) f = thesis__sum_of_squares(r, run->m);
    if (status != MS_OK) {
        thesis__fail(run, status);
        return THESIS__INF;
    }
    return thesis__seen(run, x, f);
}

static double thesis__value(thesis__run *run, const double *x) { return thesis__value_to(run, x, run->residual_step); }

/* The step of a difference in x_j and whether it may be central; inside the box unless there is a barrier. */
static double thesis__difference_step(const thesis__run *run, double x, int j, int central, double *back)
{
    double range = run->upper[j] - run->lower[j], scale = isfinite(range) ? range : 1;
    double h = run->options->difference_step;
    if (!(h > 0)) h = (central ? 6.1e-6 : 1.5e-8) * thesis__max(fabs(x), 1e-2 * scale); /* eps^(1/3), eps^(1/2) */
    if (!(h > 1e-15 * fabs(x))) h = 1e-15 * fabs(x) + DBL_MIN;
    *back = central && !(run->options->difference_step > 0) ? h : 0;
    if (run->barrier) return h;
    if (x + h > run->upper[j]) {
        if (x - h < run->lower[j]) h = run->upper[j] - x > x - run->lower[j] ? run->upper[j] - x : run->lower[j] - x;
        else h = -h;
        *back = 0;
    } else if (x - *back < run->lower[j]) {
        *back = 0;
    }
    return h;
}

/* Residuals and Jacobian at x into run->residual and run->jacobian; returns f. */
static double thesis__linearize(thesis__run *run, const double *x)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j;
    size_t i;
    double f;
    if (!function->residuals_only) {
        ms_status status;
        if (thesis__spend(run, run->jacobian_cost)) return THESIS__INF;
        run->result.jacobians++;
        status = function->residuals(function->user, x, run->residual, run->jacobian);
        if (status != MS_OK) {
            thesis__fail(run, status);
            return THESIS__INF;
        }
        return thesis__seen(run, x, thesis__sum_of_squares(run->residual, run->m));
    }
    f = thesis__value_to(run, x, run->residual);
    if (!isfinite(f)) return f;
    for (j = 0; j < n; ++j) {
        double back, h = thesis__difference_step(run, x[j], j, 0, &back), *moved = run->scratch;
        thesis__copy(moved, x, n);
        moved[j] = x[j] + h;
        h = moved[j] - x[j];
        thesis__value_to(run, moved, run->residual_step);
        if (run->stopped) return THESIS__INF;
        for (i = 0; i < run->m; ++i)
            run->jacobian[i * (size_t)n + (size_t)j] = h != 0 ? (run->residual_step[i] - run->residual[i]) / h : 0;
    }
    return f;
}

/* f and gradient at x by the best way that there is; infinity if the run has stopped. */
static double thesis__gradient(thesis__run *run, const double *x, double *g)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j;
    double f = 0;
    if (run->barrier && thesis__outside(run, x)) {
        for (j = 0; j < n; ++j) g[j] = 0;
        return thesis__value(run, x);
    }
    if (!function->residuals_only && !(run->options->difference_step > 0)) {
        size_t i;
        f = thesis__linearize(run, x);
        for (j = 0; j < n; ++j) g[j] = 0;
        if (!isfinite(f)) return f;
        for (i = 0; i < run->m; ++i)
            for (j = 0; j < n; ++j) g[j] += 2 * run->residual[i] * run->jacobian[i * (size_t)n + (size_t)j];
    } else {
        f = thesis__value(run, x);
        for (j = 0; j < n && !run->stopped; ++j) {
            double back, h = thesis__difference_step(run, x[j], j, 1, &back), *moved = run->scratch, high, low = f;
            thesis__copy(moved, x, n);
            moved[j] = x[j] + h;
            h = moved[j] - x[j];
            high = thesis__value(run, moved);
            if (back > 0) {
                moved[j] = x[j] - back;
                h += x[j] - moved[j];
                low = thesis__value(run, moved);
            }
            g[j] = h != 0 ? (high - low) / h : 0;
        }
    }
    for (j = 0; j < n; ++j)
        if (!isfinite(g[j])) {
            if (!run->barrier) return THESIS__INF;
            g[j] = 0; /* a difference over the barrier: the direction is lost, as it was for the thesis */
        }
    return run->stopped && run->status != MS_OK ? THESIS__INF : f;
}

/* Is x_j held by its bound against a descent along -g? */
static int thesis__held(const thesis__run *run, const double *x, const double *g, int j)
{
    if (run->barrier) return 0;
    return (x[j] <= run->lower[j] && g[j] >= 0) || (x[j] >= run->upper[j] && g[j] <= 0);
}

static double thesis__projected_gradient(const thesis__run *run, const double *x, const double *g)
{
    double largest = 0;
    int j;
    for (j = 0; j < run->n; ++j)
        if (!thesis__held(run, x, g, j)) largest = thesis__max(largest, fabs(g[j]));
    return largest;
}

/* ---- bounded least squares --------------------------------------------------------------------------------------- */

/* d [n] minimizes |A d - b| over low <= d <= high, low <= 0 <= high: the active-set method of Stark and Parker (1995),
   exact after finitely many changes of the set. A [rows][n] has full rank; work holds (n + 1)^2 + rows (n + 1) + n
   doubles, state n ints, which come in as the first guess of the set (0 free, -1 at low, 1 at high). */
static void thesis__bounded_least_squares(const double *a, const double *b, int rows, int n, const double *low,
                                          const double *high, double *d, int *state, double *work)
{
    int w = n + 1, change, i, j, released = -1;
    double *triangle = work, *part = work + w * w, *z = part + rows * w;
    for (j = 0; j < n; ++j) d[j] = state[j] < 0 ? low[j] : state[j] > 0 ? high[j] : 0;
    for (change = 0; change < 4 * n + 8; ++change) {
        int count = 0, worst = -1, hit = -1;
        double alpha = 1, steepest = 0;
        /* the free columns, and what the held ones leave of b */
        for (j = 0; j < n; ++j) count += state[j] == 0;
        for (i = 0; i < rows; ++i) {
            double rest = b[i];
            int c = 0;
            for (j = 0; j < n; ++j) {
                if (state[j] == 0) part[i * (count + 1) + c++] = a[i * n + j];
                else rest -= a[i * n + j] * d[j];
            }
            part[i * (count + 1) + count] = rest;
        }
        memset(triangle, 0, (size_t)((count + 1) * (count + 1)) * sizeof *triangle);
        for (i = 0; i < rows; i += THESIS__ROWS)
            thesis__qr_append(triangle, count, part + i * (count + 1),
                              rows - i < THESIS__ROWS ? rows - i : THESIS__ROWS);
        for (i = count - 1; i >= 0; --i) {
            double t = triangle[i * (count + 1) + count], pivot = triangle[i * (count + 1) + i];
            for (j = i + 1; j < count; ++j) t -= triangle[i * (count + 1) + j] * z[j];
            z[i] = pivot != 0 ? t / pivot : 0;
        }
        /* as far towards z as the box allows */
        for (j = 0, i = 0; j < n; ++j) {
            if (state[j] != 0) continue;
            if (z[i] < low[j] || z[i] > high[j]) {
                double limit = z[i] < low[j] ? low[j] : high[j];
                double t = z[i] != d[j] ? (limit - d[j]) / (z[i] - d[j]) : 0;
                if (t < alpha || hit < 0) {
                    alpha = thesis__clip(t, 0, 1);
                    hit = j;
                }
            }
            ++i;
        }
        for (j = 0, i = 0; j < n; ++j) {
            if (state[j] != 0) continue;
            d[j] += alpha * (z[i] - d[j]);
            if (j == hit) {
                state[j] = z[i] < low[j] ? -1 : 1;
                d[j] = state[j] < 0 ? low[j] : high[j];
            } else if (d[j] < low[j] || d[j] > high[j]) {
                d[j] = thesis__clip(d[j], low[j], high[j]);
            }
            ++i;
        }
        if (hit >= 0) {
            if (hit == released) break; /* rounding frees it again and again */
            continue;
        }
        /* on the face: which bound holds against the descent? */
        for (i = 0; i < rows; ++i) {
            part[i] = b[i];
            for (j = 0; j < n; ++j) part[i] -= a[i * n + j] * d[j];
        }
        for (j = 0; j < n; ++j) {
            double t = 0, size = 0, push;
            if (state[j] == 0 || !(low[j] < high[j])) continue;
            for (i = 0; i < rows; ++i) {
                t += a[i * n + j] * part[i];
                size += fabs(a[i * n + j] * part[i]);
            }
            push = state[j] < 0 ? t : -t;
            if (push > 1e-14 * size && push > steepest) {
                steepest = push;
                worst = j;
            }
        }
        if (worst < 0) break;
        released = worst;
        state[worst] = 0;
    }
}

/* ---- line search ------------------------------------------------------------------------------------------------- */

/* Where the gradient methods stand: a point, its value and gradient, and a trial. */
typedef struct thesis__point {
    double f;
    double *x, *g; /* [n] each */
} thesis__point;

/* Strong Wolfe conditions along d by bracketing and cubic interpolation (Nocedal and Wright 2006, algorithms 3.5 and
   3.6), the step at most longest; at longest decrease alone is enough. From p to q; the step, or 0 if none was
   found. */
static double thesis__line_search(thesis__run *run, const thesis__point *p, const double *d, double first,
                                  double longest, double curvature, thesis__point *q)
{
    int n = run->n, j, tries;
    double slope = thesis__dot(p->g, d, n), t = first < longest ? first : longest;
    double low = 0, f_low = p->f, slope_low = slope, high = 0, f_high = 0, slope_high = 0, s;
    int bracketed = 0;
    if (!(slope < 0) || !(longest > 0)) return 0;
    for (tries = 0; tries < 40 && !run->stopped; ++tries) {
        for (j = 0; j < n; ++j) {
            q->x[j] = p->x[j] + t * d[j];
            if (!run->barrier) q->x[j] = thesis__clip(q->x[j], run->lower[j], run->upper[j]);
        }
        q->f = thesis__gradient(run, q->x, q->g);
        s = thesis__dot(q->g, d, n);
        if (!(q->f <= p->f + 1e-4 * t * slope) || (bracketed && q->f >= f_low) || !isfinite(q->f)) {
            high = t;
            f_high = q->f;
            slope_high = s;
            bracketed = 1;
        } else {
            if (fabs(s) <= -curvature * slope || (t >= longest && s < 0)) return t;
            if (s * (bracketed ? high - low : 1) >= 0) {
                high = low;
                f_high = f_low;
                slope_high = slope_low;
                bracketed = 1;
            }
            low = t;
            f_low = q->f;
            slope_low = s;
        }
        if (!bracketed) {
            t = 4 * t < longest ? 4 * t : longest;
        } else { /* minimum of the cubic through both ends, well inside; the middle where that fails */
            double width = high - low, theta, radical, next = low + 0.5 * width;
            if (isfinite(f_high) && width != 0) {
                theta = 3 * (f_low - f_high) / width + slope_low + slope_high;
                radical = theta * theta - slope_low * slope_high;
                if (radical >= 0) {
                    double root = sqrt(radical) * (width > 0 ? 1 : -1), below = slope_high - slope_low + 2 * root;
                    if (below != 0) next = high - width * (slope_high + root - theta) / below;
                }
            } else if (width != 0) {
                next = low + 0.1 * width;
            }
            t = (next - low) / width > 0.05 && (next - low) / width < 0.95
                ? next
                : low + (isfinite(f_high) ? 0.5 : 0.1) * width;
            if (fabs(width) <= 1e-15 * (fabs(low) + fabs(high))) break;
        }
    }
    /* rounding or noise: the best bracketed point will do if it is lower at all */
    if (low > 0 && f_low < p->f && !run->stopped) {
        for (j = 0; j < n; ++j) {
            q->x[j] = p->x[j] + low * d[j];
            if (!run->barrier) q->x[j] = thesis__clip(q->x[j], run->lower[j], run->upper[j]);
        }
        q->f = thesis__gradient(run, q->x, q->g);
        if (q->f < p->f) return low;
    }
    return 0;
}

/* The longest step along d inside the box. */
static double thesis__longest_step(const thesis__run *run, const double *x, const double *d)
{
    double longest = 1e10;
    int j;
    if (run->barrier) return longest;
    for (j = 0; j < run->n; ++j) {
        double room = d[j] > 0 ? run->upper[j] - x[j] : d[j] < 0 ? run->lower[j] - x[j] : 0;
        if (d[j] != 0 && room / d[j] < longest) longest = room / d[j];
    }
    return longest;
}

/* ---- quasi-Newton, conjugate gradient, SQP ----------------------------------------------------------------------- */

/* d = -H g on the variables that no bound holds, H from the last pairs by the two-loop recursion (Nocedal 1980). */
static void thesis__lbfgs_direction(const thesis__run *run, const thesis__point *p, const double *s, const double *y,
                                    int newest, int count, double *d)
{
    int n = run->n, j, k;
    double alpha[THESIS__MEMORY], rho[THESIS__MEMORY];
    for (j = 0; j < n; ++j) d[j] = thesis__held(run, p->x, p->g, j) ? 0 : -p->g[j];
    for (k = 0; k < count; ++k) {
        int at = (newest - k + THESIS__MEMORY) % THESIS__MEMORY;
        double sy = 0, sd = 0;
        for (j = 0; j < n; ++j)
            if (!thesis__held(run, p->x, p->g, j)) {
                sy += s[at * n + j] * y[at * n + j];
                sd += s[at * n + j] * d[j];
            }
        rho[k] = sy;
        alpha[k] = sy > 0 ? sd / sy : 0;
        for (j = 0; j < n; ++j)
            if (!thesis__held(run, p->x, p->g, j)) d[j] -= alpha[k] * y[at * n + j];
    }
    if (count > 0) {
        double yy = 0;
        for (j = 0; j < n; ++j)
            if (!thesis__held(run, p->x, p->g, j)) yy += y[newest * n + j] * y[newest * n + j];
        if (rho[0] > 0 && yy > 0)
            for (j = 0; j < n; ++j) d[j] *= rho[0] / yy;
    }
    for (k = count - 1; k >= 0; --k) {
        int at = (newest - k + THESIS__MEMORY) % THESIS__MEMORY;
        double yd = 0;
        if (!(rho[k] > 0)) continue;
        for (j = 0; j < n; ++j)
            if (!thesis__held(run, p->x, p->g, j)) yd += y[at * n + j] * d[j];
        for (j = 0; j < n; ++j)
            if (!thesis__held(run, p->x, p->g, j)) d[j] += (alpha[k] - yd / rho[k]) * s[at * n + j];
    }
}

/* Damped BFGS update of the dense model B (Powell 1978). */
static void thesis__bfgs_update(double *model, int n, const double *s, const double *y, double *bs)
{
    double sy = thesis__dot(s, y, n), sbs = 0, theta = 1, sr;
    int i, j;
    for (i = 0; i < n; ++i) {
        bs[i] = thesis__dot(model + i * n, s, n);
        sbs += s[i] * bs[i];
    }
    if (!(sbs > 0)) return;
    if (sy < 0.2 * sbs) theta = 0.8 * sbs / (sbs - sy);
    sr = theta * sy + (1 - theta) * sbs;
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j)
            model[i * n + j] += (theta * y[i] + (1 - theta) * bs[i]) * (theta * y[j] + (1 - theta) * bs[j]) / sr -
                bs[i] * bs[j] / sbs;
}

/* Step of the quadratic program min g'd + d'B d / 2 over the box, as the least-squares problem |L'd + L^-1 g|. */
static int thesis__sqp_direction(const thesis__run *run, const thesis__point *p, const double *model, double *d,
                                 double *work)
{
    int n = run->n, i, j, c;
    double *l = work, *a = l + n * n, *b = a + n * n, *low = b + n, *high = low + n, *rest = high + n;
    int *state = (int *)(void *)(rest + (n + 1) * (n + 1) + n * (n + 1) + n);
    for (j = 0; j < n; ++j) {
        for (i = j; i < n; ++i) {
            double t = model[i * n + j];
            for (c = 0; c < j; ++c) t -= l[i * n + c] * l[j * n + c];
            if (i == j && !(t > 0)) return 0;
            l[i * n + j] = i == j ? sqrt(t) : t / l[j * n + j];
        }
    }
    for (i = 0; i < n; ++i) {
        double t = -p->g[i];
        for (c = 0; c < i; ++c) t -= l[i * n + c] * b[c];
        b[i] = t / l[i * n + i];
        for (j = 0; j < n; ++j) a[i * n + j] = j >= i ? l[j * n + i] : 0;
        low[i] = run->barrier ? -THESIS__INF : run->lower[i] - p->x[i];
        high[i] = run->barrier ? THESIS__INF : run->upper[i] - p->x[i];
        state[i] = !thesis__held(run, p->x, p->g, i) ? 0 : low[i] >= 0 ? -1 : 1;
    }
    thesis__bounded_least_squares(a, b, n, n, low, high, d, state, rest);
    return 1;
}

/* L-BFGS, conjugate gradient and SQP differ in their direction alone. */
static double thesis__gradient_method(thesis__run *run, double *x, int method, double *memory)
{
    int n = run->n, i, j, count = 0, newest = 0, fresh = 1;
    double *d = memory, *s = d + n, *y = s + THESIS__MEMORY * n, *model = y + THESIS__MEMORY * n, *work = model + n * n;
    double previous = 0, gain = 0;
    thesis__point p, q;
    p.x = work;
    p.g = p.x + n;
    q.x = p.g + n;
    q.g = q.x + n;
    work = q.g + n;
    thesis__copy(p.x, x, n);
    p.f = thesis__gradient(run, p.x, p.g);
    while (!run->stopped && isfinite(p.f)) {
        double step, longest, slope, steep = 0, first = 1, sy = 0, size = 0, moved = 0;
        if (!(thesis__projected_gradient(run, p.x, p.g) > 0)) break;
        if (fresh) { /* the model starts as the gradient, or the identity */
            for (i = 0; i < n * n; ++i) model[i] = i % (n + 1) == 0;
            count = 0;
        }
        if (method == THESIS_SQP) {
            if (!thesis__sqp_direction(run, &p, model, d, work)) {
                if (fresh) break;
                fresh = 1;
                continue;
            }
        } else if (method == THESIS_CONJUGATE_GRADIENT) {
            double now = 0, along = 0; /* Polak-Ribiere+ over the variables that may move */
            for (j = 0; j < n; ++j)
                if (!thesis__held(run, p.x, p.g, j)) {
                    now += p.g[j] * p.g[j];
                    along += p.g[j] * (p.g[j] - y[j]);
                }
            for (j = 0; j < n; ++j) {
                double beta = !fresh && previous > 0 ? thesis__max(along / previous, 0) : 0;
                d[j] = thesis__held(run, p.x, p.g, j) ? 0 : -p.g[j] + beta * d[j];
                y[j] = p.g[j];
            }
            previous = now;
        } else {
            thesis__lbfgs_direction(run, &p, s, y, newest, count, d);
        }
        for (j = 0; j < n && !run->barrier; ++j) /* no pushing against a bound */
            if ((p.x[j] <= run->lower[j] && d[j] < 0) || (p.x[j] >= run->upper[j] && d[j] > 0)) d[j] = 0;
        for (j = 0; j < n; ++j)
            if (d[j] != 0) steep += p.g[j] * p.g[j];
        slope = thesis__dot(p.g, d, n);
        if (!(slope < -1e-12 * sqrt(steep * thesis__dot(d, d, n)))) { /* (a NaN too) */
            if (fresh) break;
            fresh = 1;
            continue;
        }
        longest = thesis__longest_step(run, p.x, d);
        if (fresh) { /* no idea of the scale yet: a step of 1% of the box, or what the last gain suggests */
            double reach = 0;
            for (j = 0; j < n; ++j) {
                double range = run->upper[j] - run->lower[j];
                reach = thesis__max(reach,
                                    fabs(d[j]) / (isfinite(range) && range > 0 ? range : thesis__max(fabs(p.x[j]), 1)));
            }
            first = reach > 0 ? 0.01 / reach : 1;
        } else if (method == THESIS_CONJUGATE_GRADIENT) {
            first = gain > 0 ? 1.01 * 2 * gain / -slope : 1;
        }
        step = thesis__line_search(run, &p, d, first, longest, method == THESIS_CONJUGATE_GRADIENT ? 0.1 : 0.9, &q);
        if (step == 0) {
            if (fresh || run->stopped) break;
            fresh = 1; /* once more along the gradient */
            continue;
        }
        gain = p.f - q.f;
        newest = (newest + 1) % THESIS__MEMORY;
        for (j = 0; j < n; ++j) {
            double sj = q.x[j] - p.x[j], yj = q.g[j] - p.g[j];
            if (step >= longest && d[j] != 0 && !run->barrier) { /* all that reach their bound together land on it */
                double bound = d[j] > 0 ? run->upper[j] : run->lower[j];
                if ((bound - p.x[j]) / d[j] <= longest * (1 + 1e-9)) q.x[j] = bound;
            }
            if (method != THESIS_CONJUGATE_GRADIENT) {
                s[newest * n + j] = sj;
                y[newest * n + j] = yj;
            }
            sy += sj * yj;
            moved = thesis__max(moved, fabs(sj));
            size = thesis__max(size, fabs(q.x[j]));
        }
        if (method == THESIS_SQP) {
            if (fresh && sy > 0) /* size of the first model (Shanno and Phua 1978) */
                for (i = 0; i < n; ++i) model[i * (n + 1)] = thesis__dot(y + newest * n, y + newest * n, n) / sy;
            thesis__bfgs_update(model, n, s + newest * n, y + newest * n, work);
        } else if (method == THESIS_LBFGS) {
            double yy = thesis__dot(y + newest * n, y + newest * n, n);
            if (sy > 1e-14 * yy) count = count < THESIS__MEMORY ? count + 1 : count;
            else newest = (newest + THESIS__MEMORY - 1) % THESIS__MEMORY;
        }
        i = fresh;
        fresh = 0;
        thesis__copy(p.x, q.x, n);
        thesis__copy(p.g, q.g, n);
        p.f = q.f;
        if (gain <= run->tolerance * (fabs(p.f) + DBL_MIN) && moved <= run->tolerance * size) break;
        if (gain <= 1e-16 * fabs(p.f)) {
            if (i) break;
            fresh = 1;
        }
    }
    thesis__copy(x, p.x, n);
    return p.f;
}

/* ---- Nelder-Mead ------------------------------------------------------------------------------------------------- */

/* Nelder and Mead 1965 with the customary coefficients 1, 2, 1/2, 1/2; a simplex that collapsed is built anew around
   the best point until that gains nothing. */
static double thesis__nelder_mead(thesis__run *run, double *x, int barrier, double *memory)
{
    int n = run->n, i, j, rounds;
    double *vertex = memory, *value = vertex + (n + 1) * n, *middle = value + n + 1, *trial = middle + n,
           *farther = trial + n;
    double best_before = THESIS__INF;
    for (rounds = 0; !run->stopped; ++rounds) {
        double edge = run->options->start_step > 0 ? run->options->start_step : 0.1;
        for (i = 0; i <= n; ++i) {
            double *v = vertex + i * n;
            thesis__copy(v, x, n);
            if (i > 0) {
                double range = run->upper[i - 1] - run->lower[i - 1], *c = &v[i - 1];
                if (barrier) {
                    *c = *c != 0 ? 1.05 * *c : 0.00025;
                } else {
                    double h = edge * (isfinite(range) ? range : thesis__max(fabs(*c), 1));
                    *c = *c + h <= run->upper[i - 1] ? *c + h : thesis__max(*c - h, run->lower[i - 1]);
                }
            }
            value[i] = thesis__value(run, v);
        }
        while (!run->stopped) {
            int low = 0, high = 0, next, inside, c;
            double f_trial, f_far, spread = 0, size = 0;
            for (i = 1; i <= n; ++i) {
                if (value[i] < value[low]) low = i;
                if (value[i] >= value[high]) high = i;
            }
            for (i = 0, next = low; i <= n; ++i)
                if (i != high && value[i] > value[next]) next = i;
            for (i = 0; i <= n; ++i)
                for (j = 0; j < n; ++j) {
                    spread = thesis__max(spread, fabs(vertex[i * n + j] - vertex[low * n + j]));
                    size = thesis__max(size, fabs(vertex[low * n + j]));
                }
            if ((value[high] - value[low] <= run->tolerance * fabs(value[low]) &&
                 spread <= 1e-4 * thesis__max(size, 1e-30)) ||
                spread <= 1e-14 * thesis__max(size, 1e-290))
                break;
            for (j = 0; j < n; ++j) {
                middle[j] = 0;
                for (i = 0; i <= n; ++i)
                    if (i != high) middle[j] += vertex[i * n + j];
                middle[j] /= n;
                trial[j] = middle[j] + (middle[j] - vertex[high * n + j]);
                if (!barrier) trial[j] = thesis__clip(trial[j], run->lower[j], run->upper[j]);
            }
            f_trial = thesis__value(run, trial);
            if (f_trial < value[low]) { /* expand */
                for (j = 0; j < n; ++j) {
                    farther[j] = middle[j] + 2 * (middle[j] - vertex[high * n + j]);
                    if (!barrier) farther[j] = thesis__clip(farther[j], run->lower[j], run->upper[j]);
                }
                f_far = thesis__value(run, farther);
                c = f_far < f_trial;
                thesis__copy(vertex + high * n, c ? farther : trial, n);
                value[high] = c ? f_far : f_trial;
                continue;
            }
            if (f_trial < value[next]) {
                thesis__copy(vertex + high * n, trial, n);
                value[high] = f_trial;
                continue;
            }
            inside = !(f_trial < value[high]); /* contract towards the better of the two */
            for (j = 0; j < n; ++j)
                farther[j] = middle[j] + 0.5 * ((inside ? vertex[high * n + j] : trial[j]) - middle[j]);
            f_far = thesis__value(run, farther);
            if (f_far < (inside ? value[high] : f_trial)) {
                thesis__copy(vertex + high * n, farther, n);
                value[high] = f_far;
                continue;
            }
            for (i = 0; i <= n && !run->stopped; ++i) { /* shrink */
                if (i == low) continue;
                for (j = 0; j < n; ++j)
                    vertex[i * n + j] = vertex[low * n + j] + 0.5 * (vertex[i * n + j] - vertex[low * n + j]);
                value[i] = thesis__value(run, vertex + i * n);
            }
        }
        thesis__copy(x, run->best, n);
        if (barrier || run->best_value >= best_before - run->tolerance * fabs(best_before)) break;
        best_before = run->best_value;
    }
    return run->best_value;
}

/* As ms_pme_minimize, with x in the box (barrier: anywhere). */
static ms_status thesis_minimize(const ms_pme_function *function, const thesis_options *options, double *x,
                                 ms_pme_result *result)
{
    thesis__run run;
    int n = function->parameter_count, j;
    size_t m = function->residuals ? function->residual_count : 0, un = (size_t)n,
           count = m * un + 2 * m + 3 * un + (un + 1) * (un + 1) + THESIS__ROWS * (un + 1);
    double *block, *p, *start;
    memset(&run, 0, sizeof run);
    count += 7 * un * un + (2 * THESIS__MEMORY + 40) * un + 64;
    block = p = (double *)malloc(count * sizeof(double));
    if (block == NULL) return MS_OUT_OF_MEMORY;
    run.function = function;
    run.options = options;
    run.n = n;
    run.m = m;
    run.barrier = options->barrier;
    run.max_cost = options->max_cost;
    run.tolerance = options->tolerance > 0 ? options->tolerance : 1e-10;
    run.jacobian_cost = function->jacobian_cost > 0 ? function->jacobian_cost : 1 + 0.25 * n;
    run.best_value = THESIS__INF;
    run.jacobian = p;
    p += m * un;
    run.residual = p;
    p += m;
    run.residual_step = p;
    p += m;
    run.lower = p;
    p += n;
    run.upper = p;
    p += n;
    run.best = p;
    p += n;
    run.triangle = p;
    p += (n + 1) * (n + 1);
    run.rows = p;
    p += THESIS__ROWS * (n + 1);
    run.scratch = p;
    start = p + n;
    for (j = 0; j < n; ++j) {
        run.lower[j] = function->lower ? function->lower[j] : -THESIS__INF;
        run.upper[j] = function->upper ? function->upper[j] : THESIS__INF;
        start[j] = thesis__clip(x[j], run.lower[j], run.upper[j]);
    }
    if (options->method <= THESIS_NELDER_MEAD_BARRIER)
        thesis__nelder_mead(&run, start, options->method == THESIS_NELDER_MEAD_BARRIER, start + n);
    else thesis__gradient_method(&run, start, options->method, start + n);
    if (run.status == MS_OK && isfinite(run.best_value)) {
        run.result.value = run.best_value;
        thesis__copy(x, run.best, n);
        if (result) *result = run.result;
    }
    free(block);
    if (run.status != MS_OK) return run.status;
    return isfinite(run.best_value) ? MS_OK : MS_INVALID_ARGUMENT;
}

static double thesis__uniform(uint64_t *state) /* splitmix64 */
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return ((double)((z ^ (z >> 31)) >> 11) + 0.5) / 9007199254740992.0;
}

/* Basin hopping (Wales and Doye 1997) by ms_pme_minimize, from x [n] of a box with finite bounds: f at the best point,
   which x becomes. The temperature follows the scatter of the minima; the hop is tuned to accept half. */
#if defined(__GNUC__)
__attribute__((unused)) /* of the bench alone */
#endif
static double
thesis_basin_hopping(const ms_pme_function *function, double *x, double max_cost, uint64_t seed)
{
    double trial[MS_PME_PARAMETERS_MAX], here[MS_PME_PARAMETERS_MAX], f_here = THESIS__INF, best = THESIS__INF,
                                                                      hop = 0.25, temperature = 0, rise;
    ms_pme_options options = ms_pme_defaults();
    ms_pme_result result;
    int n = function->parameter_count, j, hops, accepted = 0;
    thesis__copy(trial, x, n);
    for (hops = 0; max_cost >= 2; ++hops, max_cost -= result.cost) {
        for (j = 0; j < n && hops > 0; ++j) {
            double range = function->upper[j] - function->lower[j];
            trial[j] = thesis__clip(here[j] + hop * range * (2 * thesis__uniform(&seed) - 1), function->lower[j],
                                    function->upper[j]);
        }
        options.max_cost = max_cost;
        if (ms_pme_minimize(function, &options, trial, &result, NULL) != MS_OK) return best;
        if (result.value < best) {
            best = result.value;
            thesis__copy(x, trial, n);
        }
        rise = hops > 0 ? result.value - f_here : -1;
        if (hops > 0) temperature += (0.5 * fabs(rise) - temperature) / hops;
        if (rise <= 0 || thesis__uniform(&seed) < exp(-rise / (temperature > 0 ? temperature : 1))) {
            thesis__copy(here, trial, n);
            f_here = result.value;
            accepted += hops > 0;
        }
        if (hops > 0 && hops % 10 == 0) hop = thesis__clip(2 * accepted > hops ? hop / 0.9 : hop * 0.9, 0.01, 1);
    }
    return best;
}
#endif
