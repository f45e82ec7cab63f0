/* The cheapest kernel that keeps an error: builds and measures kernels of more and more taps. Used by sss_kernel and
   sss_filter. Include ms_sss.h before. */
#ifndef CHOOSE_H
#define CHOOSE_H
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The cheapest image-optimal or residual kernel whose texture error is at most `tolerance` and whose bands are not seen,
   at most tap_budget taps in all its terms together (each is read once in x and once in y). errors: out, optional.
   progress: the fraction of the budget that was tried, after each kernel (up to a second); NULL: none.
   MS_NOT_CONVERGED: none within the budget; kernel and errors then hold the one that came nearest to both.
   MS_INVALID_ARGUMENT: tolerance not above 0, tap_budget < 3. MS_OUT_OF_MEMORY, MS_CANCELLED. kernel untouched by
   these. */
static ms_status choose_kernel(ms_sss_kernel *kernel, ms_sss_errors *errors, const ms_sss_designer *designer,
                               double tolerance, int tap_budget, const ms_progress *progress, ms_error *error)
{
    static const signed char candidate[][2] = {/* terms, taps; by their product */
                                               {1, 3},  {1, 5},  {1, 7},  {1, 9},  {2, 5},  {1, 11}, {1, 13},
                                               {2, 7},  {1, 17}, {2, 9},  {1, 21}, {2, 11}, {1, 25}, {2, 13},
                                               {3, 9},  {1, 33}, {3, 11}, {2, 17}, {3, 13}, {2, 21}, {3, 17},
                                               {3, 21}, {3, 25}, {4, 21}, {3, 33}, {4, 33}};
    static ms_sss_kernel trial, nearest;
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    ms_sss_errors found, best;
    double least = HUGE_VAL;
    size_t n;
    memset(&best, 0, sizeof best);
    if (!(tolerance > 0) || tap_budget < 3) {
        if (error) error->status = MS_INVALID_ARGUMENT;
        if (error) snprintf(error->message, sizeof error->message, "a tolerance above 0 and 3 taps at least expected");
        return MS_INVALID_ARGUMENT;
    }
    for (n = 0; n < sizeof candidate / sizeof candidate[0] && least > 1; ++n) {
        ms_status status;
        double miss;
        options.term_count = candidate[n][0];
        options.tap_count = candidate[n][1];
        options.model = options.term_count > 1 ? MS_SSS_RESIDUAL : MS_SSS_IMAGE_OPTIMAL;
        if (options.term_count * options.tap_count > tap_budget) break;
        status = ms_sss_kernel_build(&trial, designer, &options, error);
        if (status == MS_OK) status = ms_sss_kernel_measure(&found, &trial, designer);
        if (status != MS_OK) return status;
        if (progress && progress->report &&
            progress->report(progress->user, (double)options.term_count * options.tap_count / tap_budget))
            return MS_CANCELLED;
        miss = fmax(found.texture / tolerance, found.bands / MS_SSS_BANDS_SEEN);
        if (miss >= least) continue;
        least = miss;
        best = found;
        nearest = trial;
    }
    *kernel = nearest;
    if (errors) *errors = best;
    if (least <= 1) return MS_OK;
    if (error) {
        error->status = MS_NOT_CONVERGED;
        error->position = 0;
        snprintf(error->message, sizeof error->message,
                 "%d taps reach an error of %g and bands of %g; %g and %d are asked for", tap_budget, best.texture,
                 best.bands, tolerance, MS_SSS_BANDS_SEEN);
    }
    return MS_NOT_CONVERGED;
}
#endif
