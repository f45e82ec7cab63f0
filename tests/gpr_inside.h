/* Inner calls of ms_gpr.h that tests and benches look at: the likelihood and its gradient, other hyperparameters for a
   model, means in single precision, a latent space from given latents. Static behind the implementation; in an object
   of their own where the build compiles the header once (tests/run.sh). */
#ifndef TEST_GPR_INSIDE_H
#define TEST_GPR_INSIDE_H
#include "ms_gpr.h"
#ifdef TEST_INSIDE /* an object of the header and these functions */
#define TEST_INSIDE_BODY
#elif MS_GPR_IMPLEMENTED + 0 /* 1 by the build, which links such an object; the header defines it as nothing */
#define TEST_INSIDE
#else
#include "test.h"
#define TEST_INSIDE static TEST_UNUSED
#define TEST_INSIDE_BODY
#endif

#ifdef __cplusplus
extern "C" {
#endif

TEST_INSIDE ms_status inside_set_theta(ms_gpr *gp, const double *theta, ms_error *error);
TEST_INSIDE ms_status inside_simplify(ms_gpr *gp, double tolerance, int *kept);
TEST_INSIDE ms_status inside_likelihood(const ms_gpr *gp, double *likelihood, double *gradient, ms_error *error);
TEST_INSIDE ms_status inside_predict_f(const ms_gpr *gp, const float *x, int count, float *mean, ms_error *error);
TEST_INSIDE ms_status inside_latent(const double *x, int z, int m, const double *latent, const double *theta,
                                    const ms_gpr_latent_options *options, ms_gpr_latent **out, ms_error *error);
TEST_INSIDE ms_status inside_latent_likelihood(const ms_gpr_latent *plane, double *likelihood, double *gradient_theta,
                                               double *gradient_latent, ms_error *error);
TEST_INSIDE double inside_latent_jitter(const ms_gpr_latent *plane);

#ifdef TEST_INSIDE_BODY
/* What was added to the diagonal, in units of sf^2. */
TEST_INSIDE double inside_latent_jitter(const ms_gpr_latent *plane) { return plane->jitter; }

/* Other hyperparameters [m + 2] for the same data. The model is unchanged unless MS_OK. */
TEST_INSIDE ms_status inside_set_theta(ms_gpr *gp, const double *theta, ms_error *error)
{
    ms_gpr *edited;
    ms_status status;
    if (gp == NULL) return ms_gpr__null("gp", error);
    status = ms_gpr__check_theta(theta, gp->m, error);
    if (status == MS_OK) status = ms_gpr__edit(gp, 0, gp->pairs, gp->pair_count, &edited, error);
    if (status != MS_OK) return status;
    memcpy(edited->theta, theta, ((size_t)gp->m + 2) * sizeof *theta);
    return ms_gpr__commit(gp, edited, error);
}

/* Drops the dimensions of least relevance while the sum of those is at most `tolerance`. kept: out, or NULL. */
TEST_INSIDE ms_status inside_simplify(ms_gpr *gp, double tolerance, int *kept)
{
    double relevance[64], theta[66], dropped = 0;
    memcpy(theta, gp->theta, ((size_t)gp->m + 2) * sizeof *theta);
    ms_gpr_relevance(gp, relevance);
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
    void *memory = NULL;
    double sf2, sn2, value;
    ms_status status;
    int k;
    if (gp == NULL) return ms_gpr__null("gp", error);
    sf2 = ms_gpr__sf2(gp);
    sn2 = ms_gpr__sn2(gp);
    status = ms_gpr__problem_of(gp, &p, &memory, error);
    if (status != MS_OK) return status;
    if (!ms_gpr__evaluate(&p, sf2, sn2 + gp->jitter * sf2, &value, gradient)) {
        status = ms__fail(error, MS_NOT_CONVERGED, 0, "the covariance matrix is not positive definite");
    } else {
        if (likelihood) *likelihood = value;
        if (gradient) {
            double with_jitter = sn2 + gp->jitter * sf2;
            gradient[gp->m + 1] = gradient[gp->active + 1] * (with_jitter > 0 ? sn2 / with_jitter : 1);
            gradient[gp->m] = gradient[gp->active];
            for (k = gp->m - 1, p.m = gp->active; k >= 0; --k)
                gradient[k] = p.m > 0 && gp->dimension[p.m - 1] == k ? gradient[--p.m] : 0;
        }
    }
    ms_gpr__release(&gp->allocator, memory);
    return status;
}

/* The mean alone, in single precision. */
TEST_INSIDE ms_status inside_predict_f(const ms_gpr *gp, const float *x, int count, float *mean, ms_error *error)
{
    ms_gpr__batch b;
    size_t i, values;
    if (gp == NULL || (count > 0 && (x == NULL || mean == NULL)))
        return ms_gpr__null(gp == NULL ? "gp" : x ? "mean" : "x", error);
    if (count < 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d: expected at least 0", count);
    values = (size_t)count * (size_t)gp->m;
    for (i = 0; i < values; ++i)
        if (!ms__finite_f(x[i]))
            return ms__fail(error, MS_BAD_DATA, i / (size_t)gp->m + 1, "candidate %z has a value that is not finite",
                            i / (size_t)gp->m + 1);
    memset(&b, 0, sizeof b);
    b.gp = gp;
    b.x_f = x;
    b.count = count;
    b.mean_f = mean;
    return ms_gpr__predict_run(&b, ms_gpr__predict_task_f, error);
}

/* A latent space whose latents [z][2] and theta [4] are given; x is modeled as it is, not centered. */
TEST_INSIDE ms_status inside_latent(const double *x, int z, int m, const double *latent, const double *theta,
                                    const ms_gpr_latent_options *options, ms_gpr_latent **out, ms_error *error)
{
    ms_gpr_latent_options o;
    ms_gpr_latent *p;
    ms_status status;
    int l, i, k;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    if (latent == NULL || theta == NULL) return ms_gpr__null(latent ? "theta" : "latent", error);
    if (options) o = *options;
    else memset(&o, 0, sizeof o);
    l = MS_GPR__PLANE;
    status = ms_gpr__latent_make(x, z, m, &o, &p, error);
    if (status != MS_OK) return status;
    status = ms_gpr__check_rows(latent, z, l, MS_GPR__LARGEST, "latent", error);
    if (status == MS_OK) status = ms_gpr__check_theta(theta, l, error);
    if (status == MS_OK) {
        memcpy(p->latent, latent, (size_t)z * (size_t)l * sizeof *latent);
        memcpy(p->theta, theta, ((size_t)l + 2) * sizeof *theta);
        for (i = 0; i < z; ++i)
            for (k = 0; k < m; ++k) p->x[(size_t)i * p->columns + (size_t)k] += p->center[k];
        memset(p->center, 0, (size_t)m * sizeof *p->center);
        status = ms_gpr__latent_condition(p, error);
    }
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

/* log p(X | L, theta) and where not NULL its gradients by theta [4] and by the latents [z][2]. */
TEST_INSIDE ms_status inside_latent_likelihood(const ms_gpr_latent *plane, double *likelihood, double *gradient_theta,
                                               double *gradient_latent, ms_error *error)
{
    const ms_gpr_latent *p = plane;
    double sf2, sn2, noise, value = 0, gradient[5];
    ms__arena arena = {NULL, 0};
    ms_gpr__embedding e;
    double *slopes = NULL;
    int pass, i, k, wanted = gradient_theta || gradient_latent, defined;
    if (plane == NULL) return ms_gpr__null("plane", error);
    sf2 = exp(2 * p->theta[MS_GPR__PLANE]);
    sn2 = exp(2 * p->theta[MS_GPR__PLANE + 1]);
    noise = sn2 + p->jitter * sf2;
    for (pass = 0; pass < 2; ++pass) {
        slopes = ms_gpr__take(&arena, MS_GPR__PLANE, p->stride);
        ms_gpr__embedding_layout(&e, p, &arena);
        if (pass == 0 && !ms_gpr__place(&p->allocator, &arena))
            return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the likelihood of %d materials", p->z);
    }
    defined = ms_gpr__embedding_evaluate(&e, p->points, sf2, noise, &value, wanted ? gradient : NULL, slopes);
    for (k = 0; defined && gradient_latent && k < MS_GPR__PLANE; ++k)
        for (i = 0; i < p->z; ++i)
            gradient_latent[i * MS_GPR__PLANE + k] = slopes[(size_t)k * p->stride + (size_t)i] * exp(-p->theta[k]);
    ms_gpr__release(&p->allocator, slopes);
    if (!defined) return ms__fail(error, MS_NOT_CONVERGED, 0, "the covariance matrix is not positive definite");
    if (likelihood) *likelihood = value;
    for (k = 0; gradient_theta && k < MS_GPR__PLANE + 2; ++k)
        gradient_theta[k] = gradient[k] * (k == MS_GPR__PLANE + 1 ? 2 * sn2 : 1); /* of log sn */
    return MS_OK;
}

#endif
#ifdef __cplusplus
}
#endif
#endif
