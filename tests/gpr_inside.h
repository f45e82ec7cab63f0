/* Inner calls of ms_gpr.h that tests and benches look at: the likelihood and its gradient, the objective of a fit, the
   mode, other hyperparameters for a model, a latent space from given latents. Static behind the implementation; in an object
   of their own where the build compiles the header once (tests/run.sh). */
#ifndef TEST_GPR_INSIDE_H
#define TEST_GPR_INSIDE_H
#include "ms_gpr.h"
#include "test.h"
#include "explain.h"
#ifdef TEST_INSIDE /* an object of the header and these functions */
#define TEST_INSIDE_BODY
#elif MS_GPR_IMPLEMENTED + 0 /* 1 by the build, which links such an object; the header defines it as nothing */
#define TEST_INSIDE
#else
#define TEST_INSIDE static TEST_UNUSED
#define TEST_INSIDE_BODY
#endif

#ifdef __cplusplus
extern "C" {
#endif

TEST_INSIDE ms_status inside_set_theta(ms_gpr *gp, const double *theta, ms_error *error);
TEST_INSIDE ms_status inside_simplify(ms_gpr *gp, double tolerance, int *kept);
TEST_INSIDE ms_status inside_likelihood(const ms_gpr *gp, double *likelihood, double *gradient, ms_error *error);
TEST_INSIDE ms_status inside_latent(const double *x, int z, int m, const double *latent, const double *theta,
                                    const ms_gpr_latent_options *options, ms_gpr_latent **out, ms_error *error);
TEST_INSIDE ms_status inside_latent_likelihood(const ms_gpr_latent *plane, double *likelihood, double *gradient_theta,
                                               double *gradient_latent, ms_error *error);
TEST_INSIDE double inside_latent_jitter(const ms_gpr_latent *plane);
TEST_INSIDE ms_simd inside_level(ms_simd cap);
TEST_INSIDE void inside_exponentials(ms_simd level, double *c, int count);
TEST_INSIDE double inside_leave_one_out(const ms_gpr *gp, double *mean, double *variance);
TEST_INSIDE int inside_fit_objective(const double *x, const double *y, int n, int m, const double *q, double *value,
                                     double *gradient);
TEST_INSIDE int inside_mode(const ms_gpr *gp, double *likelihood, double *latent);

/* Edits of a model and models of parts, on the public calls. */
static TEST_UNUSED ms_status inside_create(const double *x, const double *y, int n, int m, const double *theta,
                                           double mean, const ms_gpr_options *options, ms_gpr **out, ms_error *error)
{
    ms_gpr_view parts;
    memset(&parts, 0, sizeof parts);
    parts.n = n, parts.m = m;
    parts.x = x, parts.y = y, parts.theta = theta;
    parts.mean = mean;
    return ms_gpr_create(&parts, options, out, error);
}

/* Without row `from` (-1: with all), with `count` more materials of scores y (NULL: none), and with these pairs in
   place of the choices (pair_count -1: with those there are, but what the row took part in). */
static TEST_UNUSED ms_status inside_edit(ms_gpr *gp, int from, const double *x, const double *y, int count,
                                         const int *pairs, int pair_count, ms_error *error)
{
    ms_gpr_view parts = ms_gpr_view_of(gp);
    const size_t m = (size_t)parts.m, before = (size_t)parts.n, all = before + (size_t)count;
    double *copy = (double *)malloc((all + 1) * (m + 1) * sizeof *copy), *scores = copy + all * m;
    int *kept = (int *)malloc((2 * (size_t)parts.choices.count + 1) * sizeof *kept), i, k = 0;
    ms_status status;
    if (before > 0) memcpy(copy, parts.x, before * m * sizeof *copy), memcpy(scores, parts.y, before * sizeof *copy);
    for (i = 0; i < count; ++i) {
        memcpy(copy + (before + (size_t)i) * m, x + (size_t)i * m, m * sizeof *copy);
        scores[before + (size_t)i] = y ? y[i] : MS_GPR_UNSCORED;
    }
    if (from >= 0) {
        memmove(copy + (size_t)from * m, copy + ((size_t)from + 1) * m, (all - (size_t)from - 1) * m * sizeof *copy);
        memmove(scores + from, scores + from + 1, (all - (size_t)from - 1) * sizeof *copy);
        for (i = 0; i < parts.choices.count; ++i) { /* pairs alone */
            const int a = parts.choices.rows[2 * i], b = parts.choices.rows[2 * i + 1];
            if (a == from || b == from) continue;
            kept[k++] = a - (a > from), kept[k++] = b - (b > from);
        }
        parts.choices.rows = kept, parts.choices.count = k / 2;
    }
    parts.n = (int)all - (from >= 0), parts.x = copy, parts.y = scores;
    if (pair_count >= 0) {
        parts.choices.count = pair_count;
        parts.choices.rows = pairs;
        parts.choices.sizes = NULL;
    }
    status = ms_gpr_update(gp, &parts, error);
    free(copy), free(kept);
    return status;
}

static TEST_UNUSED ms_status inside_append(ms_gpr *gp, const double *x, double y, ms_error *error)
{
    return inside_edit(gp, -1, x, &y, 1, NULL, -1, error);
}

static TEST_UNUSED ms_status inside_drop(ms_gpr *gp, int row, ms_error *error)
{
    return inside_edit(gp, row, NULL, NULL, 0, NULL, -1, error);
}

static TEST_UNUSED ms_status inside_compare(ms_gpr *gp, const double *x, int count, const int *pairs, int pair_count,
                                            ms_error *error)
{
    return inside_edit(gp, -1, x, NULL, count, pairs, pair_count, error);
}

static TEST_UNUSED ms_status inside_rescore(ms_gpr *gp, int row, double y, ms_error *error)
{
    ms_gpr_view parts = ms_gpr_view_of(gp);
    double *scores = (double *)malloc((size_t)parts.n * sizeof *scores);
    ms_status status;
    memcpy(scores, parts.y, (size_t)parts.n * sizeof *scores);
    scores[row] = y;
    parts.y = scores;
    status = ms_gpr_update(gp, &parts, error);
    free(scores);
    return status;
}

#ifdef TEST_INSIDE_BODY
/* The level that a cap leads to. */
TEST_INSIDE ms_simd inside_level(ms_simd cap) { return ms_gpr__kernels_of(cap)->level; }

/* c = exp(-c / 2), count a multiple of 8. */
TEST_INSIDE void inside_exponentials(ms_simd level, double *c, int count)
{
    ms_gpr__kernels_of(level)->exponentials(c, count, 1);
}

/* What the other scores say about each, and the sum of log N(y_i; mean_i, variance_i); mean, variance: [n] or NULL. */
TEST_INSIDE double inside_leave_one_out(const ms_gpr *gp, double *mean, double *variance)
{
    const size_t n = (size_t)gp->n + 1;
    double *memory = (double *)malloc(2 * n * sizeof *memory), *other = memory, *own = memory + n, density = 0;
    int i;
    ms_gpr_leave_one_out(gp, other, own, NULL);
    for (i = 0; i < gp->n; ++i) {
        const double residual = gp->view.y[i] - other[i];
        density -= 0.5 * (log(2 * 3.14159265358979323846 * own[i]) + residual * residual / own[i]);
        if (mean) mean[i] = other[i];
        if (variance) variance[i] = own[i];
    }
    free(memory);
    return density;
}

/* The objective of a fit of the whole data at q [m + 2], and its gradient; 0: not defined there, or no room. */
TEST_INSIDE int inside_fit_objective(const double *x, const double *y, int n, int m, const double *q, double *value,
                                     double *gradient)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr__fit f;
    int defined;
    memset(&f, 0, sizeof f);
    f.o.simd = MS_SIMD_SCALAR;
    f.o.evaluations = 1;
    f.data.n = n, f.data.m = m;
    f.data.x = x, f.data.y = y;
    defined = ms_gpr__fit_begin(&f, &memory, NULL) == MS_OK;
    f.starts = 1;
    f.part = n;
    defined = defined && ms_gpr__fit_run(&f, NULL) == MS_OK && ms_gpr__fit_objective(&f, q, value, gradient);
    ms_gpr__release(&memory);
    return defined;
}

/* The problem of this model's data and theta, in memory that is to be released whatever is returned. */
static ms_status inside_problem(const ms_gpr *gp, ms_gpr__problem *p, ms_gpr__memory *memory, ms_error *error)
{
    ms_status status;
    int i;
    ms_gpr__problem_make(p, gp->kernels, &gp->view, gp->active, memory);
    status = ms_gpr__taken(memory, "a likelihood", error);
    if (status != MS_OK) return status;
    memcpy(p->points, gp->points, (size_t)gp->active * gp->stride * sizeof *p->points);
    for (i = 0; i < gp->n; ++i) p->target[i] = ms_gpr__target(&gp->view, i);
    return MS_OK;
}

/* The mode of what was said, [n], and the likelihood by Laplace's approximation, computed anew; 0: it fails. */
TEST_INSIDE int inside_mode(const ms_gpr *gp, double *likelihood, double *latent)
{
    ms_gpr__problem problem;
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    int found = inside_problem(gp, &problem, &memory, NULL) == MS_OK;
    found = found && ms_gpr__evaluate(&problem, ms_gpr__sf2(gp), ms_gpr__sn2(gp), likelihood, NULL);
    if (found) memcpy(latent, problem.latent, (size_t)gp->n * sizeof *latent);
    ms_gpr__release(&memory);
    return found;
}

/* What was added to the diagonal, in units of sf^2. */
TEST_INSIDE double inside_latent_jitter(const ms_gpr_latent *plane) { return plane->gp->view.jitter; }

/* Other hyperparameters [m + 2] for the same data. The model is unchanged unless MS_OK. */
TEST_INSIDE ms_status inside_set_theta(ms_gpr *gp, const double *theta, ms_error *error)
{
    ms_gpr_view parts = ms_gpr_view_of(gp);
    if (theta == NULL) return ms_gpr__null("theta", error);
    parts.theta = theta;
    return ms_gpr_update(gp, &parts, error);
}

/* Drops the dimensions of least relevance while the sum of those is at most `tolerance`. kept: out, or NULL. */
TEST_INSIDE ms_status inside_simplify(ms_gpr *gp, double tolerance, int *kept)
{
    double relevance[64], theta[66], dropped = 0;
    memcpy(theta, gp->view.theta, ((size_t)gp->m + 2) * sizeof *theta);
    explain_relevance(gp, relevance);
    for (;;) {
        int least = -1, k;
        for (k = 0; k < gp->m; ++k)
            if (theta[k] < 700 && (least < 0 || relevance[k] < relevance[least])) least = k;
        if (least < 0 || dropped + relevance[least] > tolerance) break;
        dropped += relevance[least];
        theta[least] = 700;
    }
    if (inside_set_theta(gp, theta, NULL) != MS_OK) return MS_NOT_CONVERGED;
    if (kept) *kept = gp->active;
    return MS_OK;
}

/* log p(y | X, theta), and where not NULL its gradient [m + 2] with respect to theta. */
TEST_INSIDE ms_status inside_likelihood(const ms_gpr *gp, double *likelihood, double *gradient, ms_error *error)
{
    ms_gpr__problem p;
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    double sf2, sn2, value;
    ms_status status;
    int k;
    if (gp == NULL) return ms_gpr__null("gp", error);
    sf2 = ms_gpr__sf2(gp);
    sn2 = ms_gpr__sn2(gp);
    status = inside_problem(gp, &p, &memory, error);
    if (status == MS_OK && !ms_gpr__evaluate(&p, sf2, sn2 + gp->view.jitter * sf2, &value, gradient)) {
        status = ms__fail(error, MS_NOT_CONVERGED, 0, "the covariance matrix is not positive definite");
    } else if (status == MS_OK) {
        if (likelihood) *likelihood = value;
        if (gradient) {
            double with_jitter = sn2 + gp->view.jitter * sf2;
            gradient[gp->m + 1] = gradient[gp->active + 1] * (with_jitter > 0 ? sn2 / with_jitter : 1);
            gradient[gp->m] = gradient[gp->active];
            for (k = gp->m - 1, p.m = gp->active; k >= 0; --k)
                gradient[k] = p.m > 0 && gp->dimension[p.m - 1] == k ? gradient[--p.m] : 0;
        }
    }
    ms_gpr__release(&memory);
    return status;
}

/* A latent space whose latents [z][2] and theta [2], log sf and log sn, are given; x is modeled as it is, not centered.
 */
TEST_INSIDE ms_status inside_latent(const double *x, int z, int m, const double *latent, const double *theta,
                                    const ms_gpr_latent_options *options, ms_gpr_latent **out, ms_error *error)
{
    ms_gpr_latent_options o;
    ms_gpr_latent *p;
    ms_status status;
    int i, k;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    if (latent == NULL || theta == NULL) return ms_gpr__null(latent ? "theta" : "latent", error);
    if (options) o = *options;
    else memset(&o, 0, sizeof o);
    status = ms_gpr__latent_make(x, z, m, &o, &p, error);
    if (status != MS_OK) return status;
    for (k = 0; k < m; ++k) {
        for (i = 0; i < z; ++i) p->x[(size_t)k * p->stride + (size_t)i] += p->center[k];
        p->center[k] = 0;
    }
    status = ms_gpr__latent_condition(p, o.simd, latent, theta[0], theta[1], error);
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

/* log p(X | L, theta) and where not NULL its gradients by theta [2] and by the latents [z][2]. */
TEST_INSIDE ms_status inside_latent_likelihood(const ms_gpr_latent *plane, double *likelihood, double *gradient_theta,
                                               double *gradient_latent, ms_error *error)
{
    static double gradient[2 + 2 * 1000];
    static double q[2 + 2 * 1000];
    double noise, data, value = 0;
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr__embedding e;
    int i, k, defined;
    if (plane == NULL) return ms_gpr__null("plane", error);
    memset(&e, 0, sizeof e);
    noise = ms_gpr__sn2(plane->gp) + plane->gp->view.jitter * ms_gpr__sf2(plane->gp);
    data = (double)plane->z * plane->m;
    if (ms_gpr__embedding_make(&e, plane, plane->gp->o.simd, &memory, error) != MS_OK) {
        ms_gpr__release(&memory);
        return MS_OUT_OF_MEMORY;
    }
    q[0] = plane->gp->view.theta[2];
    q[1] = 0.5 * log(noise);
    for (k = 0; k < 2; ++k)
        for (i = 0; i < plane->z; ++i) q[2 + k * plane->z + i] = plane->gp->view.x[2 * i + k];
    defined = ms_gpr__latent_objective(&e, q, &value, gradient);
    for (k = 0; defined && gradient_latent && k < 2; ++k)
        for (i = 0; i < plane->z; ++i) gradient_latent[2 * i + k] = -data * gradient[2 + k * plane->z + i];
    ms_gpr__release(&memory);
    if (!defined) return ms__fail(error, MS_NOT_CONVERGED, 0, "the covariance matrix is not positive definite");
    if (likelihood) *likelihood = -data * value;
    if (gradient_theta) gradient_theta[0] = -data * gradient[0]; /* of log sf, log sn */
    if (gradient_theta) gradient_theta[1] = -data * gradient[1] * ms_gpr__sn2(plane->gp) / noise;
    return MS_OK;
}

#endif
#ifdef __cplusplus
}
#endif
#endif
