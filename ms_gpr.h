/* ms_gpr.h - v0.3.0 - learn a material preference - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_GPR_IMPLEMENTATION
      #include "ms_gpr.h"

   A user scores a gallery of materials. A Gaussian process learns what the scores depend on. The header recommends
   thousands of new materials, says how sure it is, and lays variants out in a plane. Link with -lm. This example learns
   the taste of a user who wants the first of five parameters near 0.8.

   Example:
      #define MS_GPR_IMPLEMENTATION
      #include "ms_gpr.h"
      #include <stdio.h>
      int main(void)
      {
          enum { N = 60, M = 5, COUNT = 4 };
          double x[N * M], score[N], found[COUNT * M], mean[COUNT], sigma[COUNT];
          ms_gpr *gp;
          ms_gpr_fit_report report;
          ms_error error;
          int i;
          if (ms_gpr_fit(NULL, NULL, 0, M, NULL, &gp, NULL, &error) != MS_OK) return puts(error.message), 1;
          if (ms_gpr_gallery(gp, NULL, N, x, &error) != MS_OK) return puts(error.message), 1;
          ms_gpr_destroy(gp);
          for (i = 0; i < N; ++i) {
              double off = (x[i * M] - 0.8) / 0.2;
              score[i] = off * off < 1 ? 10 * (1 - off * off) : 0;
          }
          if (ms_gpr_fit(x, score, N, M, NULL, &gp, &report, &error) != MS_OK) return puts(error.message), 1;
          printf("log likelihood %.1f after %d evaluations\n", report.likelihood, report.evaluations);
          if (ms_gpr_recommend(gp, NULL, COUNT, found, mean, sigma, NULL, &error) != MS_OK)
              return puts(error.message), 1;
          for (i = 0; i < COUNT; ++i) printf("x0 = %.2f: score %.1f +- %.1f\n", found[i * M], mean[i], sigma[i]);
          ms_gpr_destroy(gp);
          return 0;
      }
   End of example.

   In the caller's order
   ---------------------
   1. ms_gpr_gallery     materials to be scored, in batches; a fit of nothing gives the first
   2. ms_gpr_fit         learns from scores, from choices such as "the best 2 of 9", or from both
      ms_gpr_update      other data for a model, under the same hyperparameters
   3. ms_gpr_predict, ms_gpr_leave_one_out, ms_gpr_preference     what was learned
      ms_gpr_view_of     all that a model consists of; ms_gpr_create makes a model of it again
   4. ms_gpr_recommend   new materials
   5. ms_gpr_latent_fit, ms_gpr_latent_map   a plane of variants. examples/tools/maps.h colors it

   What it costs
   -------------
   n materials, m parameters. A likelihood with its gradient takes n^3 / 2 + n^2 m multiply-adds. From 200 scores on
   most evaluations of a fit use a third of them. A mean takes n m, its variance n^2 / 2 more. A model has n^2 + 2 n m
   doubles; making it takes 3 n^2 more for a while, with choices 4 n^2. A fit has 7 n^2 at its peak, with choices 9 n^2.
   Figures: tests/bench/RESULTS.md, made by `make bench`.

   Threads, SIMD, determinism, errors
   ----------------------------------
   No globals; 32 KB of stack. Const calls may overlap. ms_parallel shares out predictions, recommendations and
   galleries. Kernels are scalar, or with GCC and Clang SSE2, NEON or AVX2, chosen under the cap options.simd. One level
   of one build gives the same bits for any thread count. Levels and builds differ by rounding, which may lead a fit
   along another path to the same optimum. -ffast-math by the user voids all promises. Outputs are untouched on failure,
   but where the call says otherwise.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_DEF           linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_GPR_FILENAME  this file's name, if it is not "ms_gpr.h"
   MS_NO_SIMD       scalar text only

   Limits
   ------
   n up to 30000 by memory; time grows with n^3. The kernel is the squared exponential with one length a dimension:
   preferences that jump are smoothed. Values beyond 1e30, and columns and scores that span less than 1e-30, are
   refused by name.

   Sources
   -------
   K. Zsolnai-Feher, Photorealistic Material Learning and Synthesis, TU Wien 2019, chapter 3 (numbers in brackets are
   its equations, misprints corrected); Rasmussen & Williams 2006, Gaussian Processes for Machine Learning; Nocedal &
   Wright 2006, Numerical Optimization; Plackett 1975; Lawrence 2004; Neal 2003, Slice sampling; Bryan and others 2005.
*/
#ifndef MS_GPR_H
#define MS_GPR_H
#include <stddef.h>
#include <stdint.h>

#define MS_GPR_VERSION_MAJOR 0
#define MS_GPR_VERSION_MINOR 3
#define MS_GPR_VERSION_PATCH 0
#define MS_GPR_VERSION 300 /* major * 10000 + minor * 100 + patch */
#define MS_GPR_VERSION_STRING "0.3.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON
#define MS_COMMON 4 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__) || defined(__clang__)
#define MS__UNUSED __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS__UNUSED
#endif
#define MS_API MS_DEF MS__UNUSED

/* NULL, in every header: where an argument's comment does not say what NULL means, it may not be NULL. A call that
   returns a status then answers MS_INVALID_ARGUMENT and names the argument; any other does nothing and returns 0 or
   NULL. destroy and free do nothing with NULL. */

/* What went wrong; each code asks for another remedy. ms_status_string has a sentence for each. */
typedef enum ms_status {
    MS_OK = 0,
    MS_INVALID_ARGUMENT = 1,
    MS_OUT_OF_MEMORY = 2,
    MS_BAD_DATA = 3,
    MS_UNSUPPORTED = 4,
    MS_NOT_CONVERGED = 5,
    MS_CANCELLED = 6,
    MS_IO = 7
} ms_status;

/* Details of a failure. Every call that takes one accepts NULL; it is written on failure only. */
typedef struct ms_error {
    ms_status status;
    size_t position;   /* line (from 1), byte offset or row, as the call says; 0 where there is none */
    char message[240]; /* a sentence: which value was wrong and what was expected; ends with NUL */
} ms_error;

/* Memory. All zero: malloc and free. alloc returns memory aligned as malloc's, or NULL.
   release gets the size that alloc was asked for, and is never called with NULL. */
typedef struct ms_allocator {
    void *user;
    void *(*alloc)(void *user, size_t size);
    void (*release)(void *user, void *pointer, size_t size);
} ms_allocator;

/* Threads. All zero: everything runs on the calling thread. run calls task(context, i) once for every i in [0, count),
   in any order, on any threads, and returns when all are done. The work is cut into tasks by the problem alone, so
   results do not depend on how many threads there are. */
typedef struct ms_parallel {
    void *user;
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context);
} ms_parallel;

/* Progress of a long call. All zero: none. report gets the fraction done, 0 to 1, from the thread that made the call;
   it returns non-zero to stop, and the call then returns MS_CANCELLED. */
typedef struct ms_progress {
    void *user;
    int (*report)(void *user, double fraction);
} ms_progress;

/* Instruction sets, in the order of their speed. Options take one as a cap: a level that the processor or the build
   lacks falls back to the next lower one. */
typedef enum ms_simd {
    MS_SIMD_AUTO = 0,   /* the best that the processor has */
    MS_SIMD_SCALAR = 1, /* plain C: the reference for all the others */
    MS_SIMD_BASE = 2,   /* SSE2 on x86-64, NEON on ARM64 */
    MS_SIMD_AVX2 = 3,   /* AVX2 and FMA */
    MS_SIMD_AVX512 = 4  /* AVX-512 F, BW, DQ, VL */
} ms_simd;

/* "unknown status" outside the codes. */
static inline const char *ms_status_string(ms_status status)
{
    static const char *const sentence[] = {"success",
                                           "an argument is outside its stated range",
                                           "the allocator returned NULL",
                                           "the file or the data set is malformed",
                                           "valid, but not handled by this build or call",
                                           "the iteration stopped short of its tolerance",
                                           "the progress callback asked to stop",
                                           "the operating system could not read or write"};
    return (int)status >= 0 && status <= MS_IO ? sentence[status] : "unknown status";
}

/* "auto", "scalar", "base", "avx2", "avx512"; "unknown" outside the list. */
static inline const char *ms_simd_string(ms_simd level)
{
    static const char *const name[] = {"auto", "scalar", "base", "avx2", "avx512"};
    return (int)level >= 0 && level <= MS_SIMD_AVX512 ? name[level] : "unknown";
}
#endif /* MS_COMMON */

#if MS_COMMON != 4 /* outside the guard: an earlier #include may have defined another */
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---- model ----------------------------------------------------------------------------------------------------- */

/* A Gaussian process that has seen n materials of m parameters and what was said about them. Scores are mean + N(0,
   K'), K'_ij = sf^2 exp(-d^2(x_i, x_j) / 2) + sn^2 delta_ij, d^2(a, b) = sum over k of ((a_k - b_k) / l_k)^2. */
typedef struct ms_gpr ms_gpr;

/* All zero: the defaults. */
typedef struct ms_gpr_options {
    ms_simd simd; /* a cap */
    ms_allocator allocator;
    ms_parallel parallel; /* of predictions, recommendations and galleries; nothing else runs on threads */
} ms_gpr_options;

/* Marks a material without a score, for example one that was only chosen. */
#define MS_GPR_UNSCORED (-1e38)

/* What was chosen. In a choice one material was preferred to all the others of it. "The best 2 of 9" are two choices:
   each of the two best, and the seven that were left. A choice of two is a comparison. The preferred material i of a
   choice has P = exp(f_i / s) / sum over its materials j of exp(f_j / s) (Plackett 1975, Luce 1959). s = sqrt(6) sn /
   pi: the noise of one material has the deviation sn. Without scores the unit is sf. */
typedef struct ms_gpr_choices {
    int count;
    const int *rows;  /* rows of the model, choice after choice, the preferred one first */
    const int *sizes; /* [count] materials of each choice, >= 2. NULL: two each */
} ms_gpr_choices;

/* What a model consists of. Pointers are valid until the model changes. */
typedef struct ms_gpr_view {
    int n, m;            /* n >= 0 materials (0 predicts the prior), m >= 1 parameters */
    const double *x;     /* [n][m] row-major, any units */
    const double *y;     /* [n] scores as they were given, or MS_GPR_UNSCORED */
    const double *theta; /* [m + 2] log l_k of every parameter (700: left out), log sf, log sn; in units of x, y */
    ms_gpr_choices choices;
    double mean;        /* prior mean */
    double floor;       /* the least score that can be given */
    double floor_value; /* below the floor: what scores at the floor, or less, are modeled as. Else there is no floor */
    const double *value; /* [n] y, and predictions for materials without a score */
    double jitter;       /* added to sn^2, in units of sf^2: 0, or what K' lacks, 1e-15 to 1e-6 */
    ms_simd level;       /* instruction set in use */
} ms_gpr_view;

/* All zero for NULL. Without a floor, floor and floor_value are the least score that was given. */
MS_API ms_gpr_view ms_gpr_view_of(const ms_gpr *gp);

/* A model of what a view shows, all of it copied. value, jitter and level are ignored. theta NULL: with n = 0, lengths
   of sqrt(m), sf = 1, sn = 0.1. *out is NULL unless MS_OK. MS_BAD_DATA: a value that is not finite or beyond 1e30
   (position: its row, from 1). MS_INVALID_ARGUMENT: also a choice of a row twice, or outside the model (position: the
   choice, from 1). MS_NOT_CONVERGED: K' is not positive definite even with the largest jitter. MS_OUT_OF_MEMORY. n^3 /
   6 multiply-adds. With choices, or materials without a score, more: Laplace's approximation, whose mean is corrected
   to third order. */
MS_API ms_status ms_gpr_create(const ms_gpr_view *parts, const ms_gpr_options *options, ms_gpr **out, ms_error *error);

/* gp becomes a model of other parts, of the same m and with the same options. They may point into gp's own view. For a
   new score: the view with one row more. The model is unchanged unless MS_OK. As ms_gpr_create. */
MS_API ms_status ms_gpr_update(ms_gpr *gp, const ms_gpr_view *parts, ms_error *error);

MS_API void ms_gpr_destroy(ms_gpr *gp);

/* ---- fit ------------------------------------------------------------------------------------------------------- */

/* All zero: the defaults. "Width" is sqrt(12) standard deviations: 1 for a column that is uniform on [0, 1]. */
typedef struct ms_gpr_fit_options {
    /* The least score that can be given, such as 1 of 5 stars. NULL: the least that was given, if two and an eighth of
       all share it; else there is none. Scores at the floor are modeled as 0.75 standard deviations below it: dislike
       has room below "barely liked". */
    const double *floor;
    /* [m + 2] theta, the only start; lengths are clipped to 0.01 to 1000 widths, sf and sn to 0.001 to 1000 and 10
       standard deviations of the scores. NULL: three starts, at 0.25, 0.5 and 3 times sqrt(m) widths. */
    const double *start;
    int evaluations; /* of the likelihood at most, a start; 0: 200 */
    ms_gpr_choices choices;
    ms_simd simd;
    ms_allocator allocator;
    ms_parallel parallel; /* kept by the model, see ms_gpr_options; the fit runs on the calling thread */
    ms_progress progress; /* asked before every evaluation */
} ms_gpr_fit_options;

typedef struct ms_gpr_fit_report {
    double likelihood; /* log p(y | X, theta) of the scores as they were modeled, and of the choices */
    double objective;  /* the same plus the log prior, of which the maximum counts as 0 */
    int evaluations;   /* of the likelihood, all starts */
} ms_gpr_fit_report;

/* Learns theta by maximizing its posterior, and makes the model with it. The prior mean is the mean of the scores as
   they are modeled.
   x, y, n, m  as in ms_gpr_view. Columns that differ by rounding only (1e-10 of the largest) are left out. Equal
               scores, or none, give a flat model
   report      out, or NULL
   MS_BAD_DATA as ms_gpr_create, and where scores or a column span less than 1e-30 (position: the column, from 1).
   MS_CANCELLED; the rest as ms_gpr_create. */
MS_API ms_status ms_gpr_fit(const double *x, const double *y, int n, int m, const ms_gpr_fit_options *options,
                            ms_gpr **out, ms_gpr_fit_report *report, ms_error *error);

/* ---- prediction ------------------------------------------------------------------------------------------------ */

/* Posterior mean and variance at `count` points.
   x         [count][m] row-major
   mean      [count] out, or NULL: in units of y
   variance  [count] out, or NULL: in units of y squared, of the latent function: add sn^2 for that of a score
   MS_BAD_DATA: an x that is not finite (position: its row, from 1). MS_OUT_OF_MEMORY.
   Rasmussen & Williams 2006, algorithm 2.1; thesis (3.4), (3.5). */
MS_API ms_status ms_gpr_predict(const ms_gpr *gp, const double *x, int count, double *mean, double *variance,
                                ms_error *error);

/* What the other answers of the model say about each score, under the same hyperparameters: mean [n] and variance [n]
   of its prediction, out; the variance is that of a score. At the floor a score is modeled as floor_value. Rows without
   a score get numbers that mean nothing. examples/tools/warnings.h names slips by it. n^3 / 3 multiply-adds.
   MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY. Rasmussen & Williams 2006, (5.10) to (5.12). */
MS_API ms_status ms_gpr_leave_one_out(const ms_gpr *gp, double *mean, double *variance, ms_error *error);

/* The probability that a [m] is chosen rather than b [m]; a, b, probability [count] out: `count` such pairs. The
   variance of f(a) - f(b) is that of both together. MS_BAD_DATA, MS_OUT_OF_MEMORY as ms_gpr_predict. MacKay 1992. */
MS_API ms_status ms_gpr_preference(const ms_gpr *gp, const double *a, const double *b, int count, double *probability,
                                   ms_error *error);

/* ---- search ---------------------------------------------------------------------------------------------------- */

/* What recommendations, galleries and planes satisfy. All zero: the box that the scores suggest. */
typedef struct ms_gpr_space {
    /* [m] the box of allowed parameters, low = high for a fixed one. NULL, or -INFINITY and INFINITY in a column: 0 to
       1 where all materials lie there, else their range. A column that is equal in 8 materials or more stays so. */
    const double *low, *high;
    /* Moves a material x [m] of the box to a near one that is allowed, which it leaves as it is: parameters in steps,
       equal ones, rows of a list (examples/tools/space.h). Called from all threads. NULL: the whole box is allowed. */
    void (*snap)(void *user, double *x);
    void *user;
} ms_gpr_space;

typedef enum ms_gpr_search {
    MS_GPR_SEARCH_AUTO = 0, /* the threshold; variants where nothing is predicted to reach it, or too uncertainly */
    MS_GPR_SEARCH_THRESHOLD = 1, /* slice sampling where the mean is above the threshold, uniform over that region */
    MS_GPR_SEARCH_VARIANTS = 2   /* variants of liked materials, those of the largest means */
} ms_gpr_search;

/* All zero: the defaults. */
typedef struct ms_gpr_recommend_options {
    double tau; /* threshold = floor + tau (best - floor), 0 < tau <= 1; 0: 0.6. floor: as in ms_gpr_view; best: the
                   largest score that was given, but at most the largest mean in the box */
    ms_gpr_space space;
    const double *avoid; /* [avoid_count][m] "not like these": nothing nearer to any of them than 0.15: root mean square
                            over the dimensions, in widths of the box */
    int avoid_count;
    uint64_t seed; /* stands for a sequence: larger counts go on with it */
    ms_gpr_search search;
} ms_gpr_recommend_options;

typedef struct ms_gpr_recommend_report {
    ms_gpr_search search; /* what was used */
    int found;            /* rows of x that are valid, no two of them equal */
    int liked;            /* materials that were scored, or are predicted where they were chosen, above the floor */
    double threshold;     /* in units of the score; of variants: the least of their means */
    double best;          /* largest mean that was found over the box */
    double acceptance;    /* share of 4096 uniform candidates whose mean reaches the threshold */
} ms_gpr_recommend_report;

/* Materials whose predicted score reaches a threshold. Where nothing is predicted to, or the predictions are uncertain
   (a mean sigma above a tenth of best - floor), they are variants of what was liked, and report->search says so: a
   material drawn in proportion to its score, up to 0.3 of its parameters drawn anew; of 10 such the one with the
   largest mean. Where nothing was liked yet, the 10 are uniform. All are different.
   count, x  how many, >= 1; [count][m] out
   mean      [count] out, or NULL: predicted scores
   sigma     [count] out, or NULL: their standard deviation
   report    out, or NULL
   Separate regions that are liked get recommendations in proportion to their volume, as far as 4096 candidates tell it;
   where fewer than 16 of them hit any, from the answered materials and a climb. MS_NOT_CONVERGED: 20000 candidates in a
   row were known or to be avoided, as where there are not so many different ones (that reach the threshold); then the
   first report->found rows are valid.
   MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY. Thesis 3.4.1; Neal 2003, slice sampling. */
MS_API ms_status ms_gpr_recommend(const ms_gpr *gp, const ms_gpr_recommend_options *options, int count, double *x,
                                  double *mean, double *sigma, ms_gpr_recommend_report *report, ms_error *error);

/* All zero: the defaults. */
typedef struct ms_gpr_gallery_options {
    ms_gpr_space space;
    uint64_t seed; /* the number of scores is part of it: every round gives another gallery */
} ms_gpr_gallery_options;

/* Materials x [count][m], out, that the user is to score next; different ones while the candidates are, 1024 or more
   and 10 for each. They are spread until something is liked; then they are near the threshold of recommendations:
   largest 1.96 sigma - |mean - threshold of tau = 0.6|. Choices do not tell what is liked at all: after some, every
   second material is of the largest P(score > floor) sigma. Half of the candidates are uniform, half variants of what
   was liked: a material drawn in proportion to its score, half of them crossed with a second one, some parameters drawn
   anew. Each choice takes those before it as scored. If few that were scored are liked, ask for choices ("the best 2 of
   9"): they find rare tastes sooner.
   MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY. Thesis 3.7; Bryan and others 2005, "Active learning for identifying function
   threshold boundaries". */
MS_API ms_status ms_gpr_gallery(const ms_gpr *gp, const ms_gpr_gallery_options *options, int count, double *x,
                                ms_error *error);

/* ---- plane ----------------------------------------------------------------------------------------------------- */

/* A plane of variants: the Gaussian-process latent variable model of thesis 3.4.3 with two latent coordinates.
   Neighbors in it look alike. It does not know what is liked. */
typedef struct ms_gpr_latent ms_gpr_latent;

/* All zero: the defaults. */
typedef struct ms_gpr_latent_options {
    double prior;       /* precision of a normal prior on every latent coordinate; 0: none */
    ms_gpr_space space; /* materials of the plane are moved to the nearest that satisfy it. All zero: not even a box;
                           else as in recommendations, for the range of the embedded materials */
    ms_simd simd;
    ms_allocator allocator;
} ms_gpr_latent_options;

typedef struct ms_gpr_latent_report {
    double likelihood; /* log p(X | L, theta), (3.8) */
    double error;      /* root mean square of x - map(latent of x) over the training materials */
    int evaluations;
} ms_gpr_latent_report;

/* Embeds materials x [z][m], z >= 2, by L-BFGS from principal components at three scales. Every column has the same
   kernel variance: scale parameters to comparable ranges. Length scales are 1, the unit of the plane.
   z^3 / 2 + 2 z^2 m multiply-adds an evaluation. *out is NULL unless MS_OK.
   MS_BAD_DATA: a value that is not finite (position: its row, from 1), or all materials equal. MS_INVALID_ARGUMENT,
   MS_OUT_OF_MEMORY. Lawrence 2004, "Gaussian process latent variable models"; thesis (3.8), (3.9). */
MS_API ms_status ms_gpr_latent_fit(const double *x, int z, int m, const ms_gpr_latent_options *options,
                                   ms_gpr_latent **out, ms_gpr_latent_report *report, ms_error *error);

MS_API void ms_gpr_latent_destroy(ms_gpr_latent *plane);

/* What a plane consists of; all zero for NULL. It lives as long as the plane. */
typedef struct ms_gpr_latent_view {
    int z, m;
    const double *points; /* [z][2] latents of the embedded materials */
    double sf, sn;        /* deviations of what the materials depend on, and of the noise */
} ms_gpr_latent_view;

MS_API ms_gpr_latent_view ms_gpr_latent_view_of(const ms_gpr_latent *plane);

/* Materials x [count][m], out or NULL, at points latent [count][2] (3.11). variance: [count] out, or NULL: of every
   coordinate of x, without the noise; 0 <= variance <= sf^2. 1 - variance / sf^2 says how much the plane knows. */
MS_API ms_status ms_gpr_latent_map(const ms_gpr_latent *plane, const double *latent, int count, double *x,
                                   double *variance, ms_error *error);

#ifdef __cplusplus
}
#endif
#endif /* MS_GPR_H */

#if defined(MS_GPR_IMPLEMENTATION) && !defined(MS_GPR__PASS) && !defined(MS_GPR_IMPLEMENTED)
#define MS_GPR_IMPLEMENTED /* included again, it is declarations only */
/* ms-common-private begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON_PRIVATE
#define MS_COMMON_PRIVATE
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* a * b and a + b; SIZE_MAX stands for overflow and stays so through further calls. */
static MS__UNUSED size_t ms__size_mul(size_t a, size_t b)
{
    if (a == SIZE_MAX || b == SIZE_MAX) return SIZE_MAX;
    return a != 0 && b > SIZE_MAX / a ? SIZE_MAX : a * b;
}

static MS__UNUSED size_t ms__size_add(size_t a, size_t b) { return b > SIZE_MAX - a ? SIZE_MAX : a + b; }

/* Pieces of one block, each on a multiple of 64 bytes. base NULL: take only counts; then the same calls with a block of
   `used` bytes place what was counted. used SIZE_MAX: overflow. */
typedef struct ms__arena {
    char *base; /* NULL, or aligned to 64 bytes */
    size_t used;
} ms__arena;

static MS__UNUSED void *ms__take(ms__arena *arena, size_t count, size_t size)
{
    const size_t at = arena->used, end = ms__size_add(at, ms__size_mul(count, size));
    arena->used = end > SIZE_MAX - 63 ? SIZE_MAX : (end + 63) / 64 * 64;
    return arena->base != NULL ? arena->base + at : NULL;
}

/* NULL for size SIZE_MAX (overflow). Size 0 gives a pointer that must be released as well. */
static MS__UNUSED void *ms__alloc(const ms_allocator *allocator, size_t size)
{
    if (size == SIZE_MAX) return NULL;
    if (allocator != NULL && allocator->alloc != NULL) return allocator->alloc(allocator->user, size ? size : 1);
    return malloc(size ? size : 1);
}

static MS__UNUSED void ms__release(const ms_allocator *allocator, void *pointer, size_t size)
{
    if (pointer == NULL) return;
    if (allocator == NULL || allocator->alloc == NULL) free(pointer);
    else if (allocator->release != NULL) allocator->release(allocator->user, pointer, size ? size : 1);
}

static MS__UNUSED void ms__run(const ms_parallel *parallel, int count, void (*task)(void *context, int index),
                               void *context)
{
    int i;
    if (parallel != NULL && parallel->run != NULL && count > 1) parallel->run(parallel->user, count, task, context);
    else
        for (i = 0; i < count; ++i) task(context, i);
}

/* By its bits: isfinite() is removed by -ffast-math. */
static MS__UNUSED int ms__finite(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

static MS__UNUSED int ms__finite_f(float x) { return ms__finite((double)x); }

/* The decimal digits of value before `end`, where a NUL is written. Returns the first. */
static MS__UNUSED char *ms__format_integer(char *end, size_t value)
{
    for (*end = 0; value || !*end; value /= 10) *--end = (char)('0' + (int)(value % 10));
    return end;
}

/* x with 6 significant digits and '.' in every locale, into 24 bytes. */
static MS__UNUSED void ms__format_number(char *out, double x)
{
    char text[8], *digit;
    int n = 0, exponent = 5, count = 6, point, i;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (!ms__finite(x)) {
        memcpy(out, bits << 12 ? "nan\0" : bits >> 63 ? "-inf" : "inf\0", 5);
        return;
    }
    if (bits >> 63) out[n++] = '-';
    x = x < 0 ? -x : x;
    if (!(x > 0)) exponent = 0, count = 1;
    for (; x >= 999999.5; ++exponent) x /= 10; /* to six digits before the point */
    for (; x > 0 && x < 99999.95; --exponent) x *= 10;
    digit = ms__format_integer(text + 7, (size_t)(x + 0.5));
    while (count > 1 && digit[count - 1] == '0') --count;
    point = exponent >= -4 && exponent < 7 ? exponent : 0; /* the digit that it follows */
    for (i = point < 0 ? point : 0; i < count || i <= point; ++i) {
        out[n++] = i < 0 || i >= count ? '0' : digit[i];
        if (i == point && i + 1 < count) out[n++] = '.';
    }
    if (point != exponent) {
        out[n++] = 'e';
        out[n++] = exponent < 0 ? '-' : '+';
        exponent = exponent < 0 ? -exponent : exponent;
        if (exponent < 10) out[n++] = '0';
        for (digit = ms__format_integer(text + 7, (size_t)exponent); *digit;) out[n++] = *digit++;
    }
    out[n] = 0;
}

/* Fills error (may be NULL) and returns status. The format knows %s (char pointer), %d (int), %z (size_t), %g (double)
   and %%; a text that is too long is cut, a control character becomes '?'. */
static MS__UNUSED ms_status ms__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    char number[32], *end = number + sizeof number - 1;
    size_t n = 0;
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = position;
    va_start(list, format);
    for (; *format; ++format) {
        const char *piece = number;
        const char kind = *format == '%' ? *++format : 0;
        const int value = kind == 'd' ? va_arg(list, int) : 0;
        number[0] = *format;
        number[1] = 0;
        if (kind == 's') piece = va_arg(list, const char *);
        if (kind == 'g') ms__format_number(number, va_arg(list, double));
        if (kind == 'z') piece = ms__format_integer(end, va_arg(list, size_t));
        if (kind == 'd') piece = ms__format_integer(end, value < 0 ? 0 - (size_t)value : (size_t)value);
        if (value < 0 && n < sizeof error->message - 1) error->message[n++] = '-';
        for (; *piece && n < sizeof error->message - 1; ++piece)
            error->message[n++] = (unsigned char)*piece < 32 || *piece == 127 ? '?' : *piece;
    }
    va_end(list);
    error->message[n] = 0;
    return status;
}
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* ms-common-simd begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_SIMD
#define MS_COMMON_SIMD
/* MS_NO_SIMD leaves the scalar text of every header. 32-bit x86 has no baseline that can be relied on. */
#if !defined(MS_NO_SIMD) && (defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC)))
#define MS__X64 1
#include <immintrin.h>
#if !defined(_MSC_VER)
#include <cpuid.h>
#elif !defined(__clang__)
#include <intrin.h>
#else
#include <cpuid.h>
#include <smmintrin.h> /* here immintrin.h leaves out what the command line's target lacks */
#include <avxintrin.h>
#include <avx2intrin.h>
#include <f16cintrin.h>
#include <fmaintrin.h>
#include <avx512fintrin.h>
#include <avx512bwintrin.h>
#include <avx512dqintrin.h>
#endif
#elif !defined(MS_NO_SIMD) && (defined(__aarch64__) || defined(_M_ARM64))
#define MS__NEON 1
#include <arm_neon.h>
#endif

#if defined(MS__X64)
static MS__UNUSED void ms__cpuid(uint32_t leaf, uint32_t subleaf, uint32_t r[4])
{
#if defined(_MSC_VER) && !defined(__clang__)
    __cpuidex((int *)r, (int)leaf, (int)subleaf);
#else
    __cpuid_count(leaf, subleaf, r[0], r[1], r[2], r[3]);
#endif
}

/* What both the processor and the operating system (XCR0) support. */
static MS__UNUSED ms_simd ms__simd_detect(void)
{
    uint32_t r[4], xcr0;
    ms__cpuid(0, 0, r);
    if (r[0] < 7) return MS_SIMD_BASE;
    ms__cpuid(1, 0, r);
    if ((r[2] & 0x28001000u) != 0x28001000u) return MS_SIMD_BASE; /* OSXSAVE (XCR0 can be read), F16C, FMA */
#if defined(_MSC_VER) && !defined(__clang__)
    xcr0 = (uint32_t)_xgetbv(0);
#else
    __asm__ volatile("xgetbv" : "=a"(xcr0), "=d"(r[3]) : "c"(0));
#endif
    ms__cpuid(7, 0, r);
    if ((xcr0 & 0x6u) != 0x6u || !(r[1] & 0x20u)) return MS_SIMD_BASE;                       /* YMM state, AVX2 */
    if ((xcr0 & 0xe6u) != 0xe6u || (r[1] & 0xC0030000u) != 0xC0030000u) return MS_SIMD_AVX2; /* ZMM; F, DQ, BW, VL */
    return MS_SIMD_AVX512;
}
#endif

/* The level to use under a cap. cpuid takes microseconds under a hypervisor: ask once when an object is made or at the
   start of a long call, never in a loop. Nothing is kept in a global. */
static MS__UNUSED ms_simd ms__simd_pick(ms_simd cap)
{
    ms_simd best = MS_SIMD_SCALAR;
#if defined(MS__X64)
    best = cap == MS_SIMD_SCALAR || cap == MS_SIMD_BASE ? cap : ms__simd_detect();
#elif defined(MS__NEON)
    best = MS_SIMD_BASE;
#endif
    return cap != MS_SIMD_AUTO && cap < best ? cap : best;
}
#endif /* MS_COMMON_SIMD */
/* ms-common-simd end */

/* Contents of the implementation:
     dense       kernels of every instruction set, Cholesky factors, triangular systems
     descent     projected L-BFGS
     posterior   likelihood and gradient: exact for scores, Laplace's approximation for choices
     model       data, theta, factor; prediction
     learn       priors, starts, the fit
     search      box, candidates, ascents, chains, variants; recommendations and galleries
     plane       latent space */

/* ---- dense ----------------------------------------------------------------------------------------------------- */

#include <math.h>

/* Columns of every matrix and rows of every triangular one come in blocks of 8: n is padded with points that are
   independent of everything. One vector of the widest level fits, and no kernel has a remainder. */
enum {
    MS_GPR__BLOCK = 8,
    MS_GPR__SLICE = 96, /* of the depth of a product: it stays in the first cache */
    MS_GPR__CHUNK = 64, /* candidates that are predicted together */
    MS_GPR__UPPER = 1,  /* parts of a product: only c_ij with i <= j is wanted */
    MS_GPR__LOWER = 2   /* b_kj = 0 for k < j */
};

/* The inner loops, one table a level. Matrices are row-major with a stride; a is [depth][rows], b is [depth][columns],
   c is [rows][columns]; rows is a multiple of 4, columns of 8; pointers need no alignment. */
typedef struct ms_gpr__kernels {
    ms_simd level;
    /* c -= a' b; parts: the sum of flags above, or 0 */
    void (*reduce)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride,
                   int rows, int columns, int depth, int parts);
    /* c_j = scale exp(-c_j / 2), j < columns */
    void (*exponentials)(double *c, int columns, double scale);
    /* slope_k += sum over j of w_j (points[k stride + j] - point[k stride])^2, k < m */
    void (*slopes)(double *slope, const double *w, const double *points, size_t stride, const double *point, int m,
                   int columns);
    void (*axpy)(double *y, double a, const double *x, int columns); /* y += a x */
    double (*dot)(const double *x, const double *y, int columns);
    /* d2_i = sum over k < m of (points[k stride + i] - point[k spacing])^2, i < n, a multiple of 8 */
    void (*distances)(double *d2, const double *points, size_t stride, const double *point, size_t spacing, int m,
                      int n);
    /* sum of weight_i exp(-(d2_i + constant + t slope_i) / 2) */
    double (*line_mean)(const double *d2, const double *slope, double t, double constant, const double *weight, int n);
} ms_gpr__kernels;

static double ms_gpr__pow2(double whole)
{
    uint64_t bits = (uint64_t)((int)whole + 1023) << 52;
    memcpy(&whole, &bits, sizeof whole);
    return whole;
}

#ifndef MS_GPR_FILENAME
#define MS_GPR_FILENAME "ms_gpr.h" /* it includes its own kernels, once a level */
#endif

/* Words of the kernels that mean the same in each level. */
#define MS_GPR__JOIN_(a, b) a##b
#define MS_GPR__JOIN(a, b) MS_GPR__JOIN_(a, b)
#define MS_GPR__KERNEL(name) MS_GPR__JOIN(ms_gpr__##name##_level, MS_GPR__PASS)
#define MS_GPR__V MS_GPR__KERNEL(v) /* a vector */
#define MS_GPR__LANES ((int)(sizeof(MS_GPR__V) / sizeof(double)))
#define MS_GPR__WIDE (2 * MS_GPR__LANES) /* divides MS_GPR__BLOCK */
#define MS_GPR__LOAD(p) ((MS_GPR__V) * (const MS_GPR__KERNEL(loose) *)(p))
#define MS_GPR__STORE(p, v) (*(MS_GPR__KERNEL(loose) *)(p) = (v))
#define MS_GPR__SET(x) MS_GPR__KERNEL(set)(x)

#define MS_GPR__PASS 1
#include MS_GPR_FILENAME

#if (defined(MS__X64) || defined(MS__NEON)) && (defined(__GNUC__) || defined(__clang__))
#define MS_GPR__VECTORS 1 /* kernels use the compilers' vectors; cl compiles the scalar text */
#define MS_GPR__PASS 2
#include MS_GPR_FILENAME
#else
#define MS_GPR__VECTORS 0
#endif

#if MS_GPR__VECTORS && defined(MS__X64)
#define MS_GPR__PASS 3
#include MS_GPR_FILENAME
#endif
#define MS_GPR__KERNELS_END /* what follows the kernels is read in this inclusion alone */
#endif

#ifdef MS_GPR__PASS
/* --- kernels: one level an inclusion, MS_GPR__PASS is the level (ms_simd) --- */

/* Vectors are the compiler's own, with the language's operators. MADD a b + c is fused where the level fuses. ROUND
   goes to the nearest whole number. POW2 is of one in the normal range. KEEP is v where x > limit, else 0. */
#if MS_GPR__PASS == 3
#define MS_GPR__STATIC static __attribute__((target("avx2,fma")))
#define MS_GPR__MADD(a, b, c) _mm256_fmadd_pd(a, b, c)
#elif MS_GPR__PASS == 2 && defined(MS__NEON)
#define MS_GPR__STATIC static
#define MS_GPR__MADD(a, b, c) vfmaq_f64(c, a, b)
#else
#define MS_GPR__STATIC static
#define MS_GPR__MADD(a, b, c) ((a) * (b) + (c))
#endif
#if MS_GPR__PASS == 1
typedef double MS_GPR__V;
typedef double MS_GPR__KERNEL(loose);
#define MS_GPR__ROUND(a) ((double)(int)((a)-0.5)) /* of a <= 0 */
#define MS_GPR__POW2(a) ms_gpr__pow2(a)
#define MS_GPR__KEEP(x, limit, v) ((x) > (limit) ? (v) : 0)
#else
typedef double MS_GPR__V __attribute__((vector_size(MS_GPR__PASS == 3 ? 32 : 16)));
typedef MS_GPR__V MS_GPR__KERNEL(loose) __attribute__((aligned(sizeof(double)), may_alias));
typedef int64_t MS_GPR__KERNEL(bits) __attribute__((vector_size(sizeof(MS_GPR__V))));
#define MS_GPR__ROUND(a) ((a) + MS_GPR__SET(6755399441055744.0) - MS_GPR__SET(6755399441055744.0)) /* 3 * 2^51 */
#define MS_GPR__POW2(a) ((MS_GPR__V)((MS_GPR__KERNEL(bits))((a) + MS_GPR__SET(6755399441055744.0 + 1023)) << 52))
#define MS_GPR__KEEP(x, limit, v) ((MS_GPR__V)(((x) > (limit)) & (MS_GPR__KERNEL(bits))(v)))
#endif

MS_GPR__STATIC inline MS_GPR__V MS_GPR__KERNEL(set)(double x)
{
    const MS_GPR__V zero = {0};
    return x - zero; /* -0 stays -0 */
}

/* exp(-d2 / 2) = 2^t, t = -d2 / (2 log 2) <= 0, as 2^round(t) times a polynomial in the rest f that interpolates (2^f -
   1) / f at the Chebyshev points of [-1/2, 1/2]: its error is less than rounding's. Below 2^-500 it is 0: products of
   two such terms would be subnormal and slow. */
MS_GPR__STATIC inline MS_GPR__V MS_GPR__KERNEL(exponential)(MS_GPR__V d2)
{
    MS_GPR__V t = d2 * MS_GPR__SET(-0.72134752044448170368), limit = MS_GPR__SET(-500.0);
    MS_GPR__V inside = MS_GPR__KEEP(t, limit, t);
    MS_GPR__V whole = MS_GPR__ROUND(inside), f = inside - whole, p = MS_GPR__SET(4.4549605981865186e-10);
    p = MS_GPR__MADD(p, f, MS_GPR__SET(7.0725859492692234e-09));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(1.0178062445845774e-07));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(1.3215442587921689e-06));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(1.5252733829836119e-05));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.0001540353044173605));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.0013333558146416936));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.0096181291076068882));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.055504108664821597));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.24022650695910097));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.69314718055994529));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(1.0));
    p = p * MS_GPR__POW2(whole);
    return MS_GPR__KEEP(t, limit, p);
}

MS_GPR__STATIC inline double MS_GPR__KERNEL(sum)(MS_GPR__V v)
{
    double lane[MS_GPR__LANES], total = 0;
    int i;
    MS_GPR__STORE(lane, v);
    for (i = 0; i < MS_GPR__LANES; ++i) total += lane[i];
    return total;
}

MS_GPR__STATIC double MS_GPR__KERNEL(line_mean)(const double *d2, const double *slope, double t, double constant,
                                                const double *weight, int n)
{
    MS_GPR__V ahead = MS_GPR__SET(t), rest = MS_GPR__SET(constant), sum = MS_GPR__SET(0.0);
    int i;
    for (i = 0; i < n; i += MS_GPR__LANES) {
        MS_GPR__V x = MS_GPR__MADD(ahead, MS_GPR__LOAD(slope + i), MS_GPR__LOAD(d2 + i) + rest);
        sum = MS_GPR__MADD(MS_GPR__LOAD(weight + i), MS_GPR__KERNEL(exponential)(x), sum);
    }
    return MS_GPR__KERNEL(sum)(sum);
}

MS_GPR__STATIC void MS_GPR__KERNEL(distances)(double *d2, const double *points, size_t stride, const double *point,
                                              size_t spacing, int m, int n)
{
    int i, k;
    for (i = 0; i < n; i += MS_GPR__WIDE) {
        const double *row = points + i, *at = point;
        MS_GPR__V sum0 = MS_GPR__SET(0.0), sum1 = sum0;
        for (k = 0; k < m; ++k, row += stride, at += spacing) {
            MS_GPR__V d0 = MS_GPR__SET(*at) - MS_GPR__LOAD(row);
            MS_GPR__V d1 = MS_GPR__SET(*at) - MS_GPR__LOAD(row + MS_GPR__LANES);
            sum0 = MS_GPR__MADD(d0, d0, sum0);
            sum1 = MS_GPR__MADD(d1, d1, sum1);
        }
        MS_GPR__STORE(d2 + i, sum0);
        MS_GPR__STORE(d2 + i + MS_GPR__LANES, sum1);
    }
}

/* A tile of 4 rows and 2 vectors. Depth goes in slices, and two vectors of a slice of -b are copied together, so that
   they stay in the first cache and on few pages. */
MS_GPR__STATIC void MS_GPR__KERNEL(reduce)(double *c, size_t c_stride, const double *a, size_t a_stride,
                                           const double *b, size_t b_stride, int rows, int columns, int depth,
                                           int parts)
{
    double strip[MS_GPR__SLICE * MS_GPR__WIDE];
    int from, i, j, k;
    for (from = 0; from < depth; from += MS_GPR__SLICE) {
        int to = depth - from > MS_GPR__SLICE ? from + MS_GPR__SLICE : depth;
        for (j = 0; j < columns; j += MS_GPR__WIDE) {
            int wanted = (parts & MS_GPR__UPPER) && j + MS_GPR__WIDE < rows ? (j + MS_GPR__WIDE + 3) & ~3 : rows;
            int first = (parts & MS_GPR__LOWER) && j > from ? j : from;
            if (first >= to) break;
            for (k = first; k < to; ++k)
                for (i = 0; i < MS_GPR__WIDE; i += MS_GPR__LANES)
                    MS_GPR__STORE(strip + (k - first) * MS_GPR__WIDE + i,
                                  -MS_GPR__LOAD(b + (size_t)k * b_stride + j + i));
            for (i = 0; i < wanted; i += 4) {
                const double *ak = a + (size_t)first * a_stride + i, *bk = strip;
                double *c0 = c + (size_t)i * c_stride + j, *c1 = c0 + c_stride, *c2 = c1 + c_stride,
                       *c3 = c2 + c_stride;
                MS_GPR__V c00 = MS_GPR__LOAD(c0), c01 = MS_GPR__LOAD(c0 + MS_GPR__LANES);
                MS_GPR__V c10 = MS_GPR__LOAD(c1), c11 = MS_GPR__LOAD(c1 + MS_GPR__LANES);
                MS_GPR__V c20 = MS_GPR__LOAD(c2), c21 = MS_GPR__LOAD(c2 + MS_GPR__LANES);
                MS_GPR__V c30 = MS_GPR__LOAD(c3), c31 = MS_GPR__LOAD(c3 + MS_GPR__LANES);
                for (k = first; k < to; ++k, ak += a_stride, bk += MS_GPR__WIDE) {
                    MS_GPR__V b0 = MS_GPR__LOAD(bk), b1 = MS_GPR__LOAD(bk + MS_GPR__LANES), x;
                    x = MS_GPR__SET(ak[0]), c00 = MS_GPR__MADD(x, b0, c00), c01 = MS_GPR__MADD(x, b1, c01);
                    x = MS_GPR__SET(ak[1]), c10 = MS_GPR__MADD(x, b0, c10), c11 = MS_GPR__MADD(x, b1, c11);
                    x = MS_GPR__SET(ak[2]), c20 = MS_GPR__MADD(x, b0, c20), c21 = MS_GPR__MADD(x, b1, c21);
                    x = MS_GPR__SET(ak[3]), c30 = MS_GPR__MADD(x, b0, c30), c31 = MS_GPR__MADD(x, b1, c31);
                }
                MS_GPR__STORE(c0, c00), MS_GPR__STORE(c0 + MS_GPR__LANES, c01);
                MS_GPR__STORE(c1, c10), MS_GPR__STORE(c1 + MS_GPR__LANES, c11);
                MS_GPR__STORE(c2, c20), MS_GPR__STORE(c2 + MS_GPR__LANES, c21);
                MS_GPR__STORE(c3, c30), MS_GPR__STORE(c3 + MS_GPR__LANES, c31);
            }
        }
    }
}

MS_GPR__STATIC void MS_GPR__KERNEL(exponentials)(double *c, int columns, double scale)
{
    int j;
    for (j = 0; j < columns; j += MS_GPR__LANES)
        MS_GPR__STORE(c + j, MS_GPR__SET(scale) * MS_GPR__KERNEL(exponential)(MS_GPR__LOAD(c + j)));
}

MS_GPR__STATIC void MS_GPR__KERNEL(slopes)(double *slope, const double *w, const double *points, size_t stride,
                                           const double *point, int m, int columns)
{
    int j, k;
    for (k = 0; k < m; ++k, points += stride, point += stride) {
        MS_GPR__V sum0 = MS_GPR__SET(0.0), sum1 = sum0, d;
        for (j = 0; j < columns; j += MS_GPR__WIDE) {
            d = MS_GPR__LOAD(points + j) - MS_GPR__SET(*point);
            sum0 = MS_GPR__MADD(MS_GPR__LOAD(w + j) * d, d, sum0);
            d = MS_GPR__LOAD(points + j + MS_GPR__LANES) - MS_GPR__SET(*point);
            sum1 = MS_GPR__MADD(MS_GPR__LOAD(w + j + MS_GPR__LANES) * d, d, sum1);
        }
        slope[k] += MS_GPR__KERNEL(sum)(sum0 + sum1);
    }
}

MS_GPR__STATIC void MS_GPR__KERNEL(axpy)(double *y, double a, const double *x, int columns)
{
    int j;
    for (j = 0; j < columns; j += MS_GPR__LANES)
        MS_GPR__STORE(y + j, MS_GPR__MADD(MS_GPR__SET(a), MS_GPR__LOAD(x + j), MS_GPR__LOAD(y + j)));
}

MS_GPR__STATIC double MS_GPR__KERNEL(dot)(const double *x, const double *y, int columns)
{
    MS_GPR__V sum0 = MS_GPR__SET(0.0), sum1 = sum0;
    int j;
    for (j = 0; j < columns; j += MS_GPR__WIDE) {
        sum0 = MS_GPR__MADD(MS_GPR__LOAD(x + j), MS_GPR__LOAD(y + j), sum0);
        sum1 = MS_GPR__MADD(MS_GPR__LOAD(x + j + MS_GPR__LANES), MS_GPR__LOAD(y + j + MS_GPR__LANES), sum1);
    }
    return MS_GPR__KERNEL(sum)(sum0 + sum1);
}

static const ms_gpr__kernels MS_GPR__KERNEL(table) = {
    (ms_simd)MS_GPR__PASS, MS_GPR__KERNEL(reduce), MS_GPR__KERNEL(exponentials), MS_GPR__KERNEL(slopes),
    MS_GPR__KERNEL(axpy),  MS_GPR__KERNEL(dot),    MS_GPR__KERNEL(distances),    MS_GPR__KERNEL(line_mean)};

#undef MS_GPR__STATIC
#undef MS_GPR__MADD
#undef MS_GPR__ROUND
#undef MS_GPR__POW2
#undef MS_GPR__KEEP
#undef MS_GPR__PASS
#endif /* MS_GPR__PASS */

#if defined(MS_GPR__KERNELS_END) && !defined(MS_GPR__PASS)
#undef MS_GPR__KERNELS_END
#undef MS_GPR__JOIN_
#undef MS_GPR__JOIN
#undef MS_GPR__KERNEL
#undef MS_GPR__V
#undef MS_GPR__LANES
#undef MS_GPR__WIDE
#undef MS_GPR__LOAD
#undef MS_GPR__STORE
#undef MS_GPR__SET

static const ms_gpr__kernels *ms_gpr__kernels_of(ms_simd cap)
{
    ms_simd level = ms__simd_pick(MS_GPR__VECTORS ? cap : MS_SIMD_SCALAR);
#if MS_GPR__VECTORS && defined(MS__X64)
    if (level >= MS_SIMD_AVX2) return &ms_gpr__table_level3;
#endif
#if MS_GPR__VECTORS
    if (level >= MS_SIMD_BASE) return &ms_gpr__table_level2;
#endif
    (void)level;
    return &ms_gpr__table_level1;
}
#undef MS_GPR__VECTORS

/* --- triangular systems --- */

static int ms_gpr__padded(int n) { return (n + MS_GPR__BLOCK - 1) / MS_GPR__BLOCK * MS_GPR__BLOCK; }

/* Doubles from one row of an n x n matrix to the next: not a multiple of 512 bytes, or columns would share cache
   sets. */
static size_t ms_gpr__stride(int n)
{
    size_t stride = (size_t)ms_gpr__padded(n);
    return stride % 64 == 0 ? stride + MS_GPR__BLOCK : stride;
}

/* The first half of a triangular matrix that is split in two, in whole blocks. */
static int ms_gpr__half(int n) { return ms_gpr__padded(n / 2); }

/* b [n][columns] = u'^-1 b. Recursion halves n, so that its depth is log2(n / 8) and all work but the leaves is
   `reduce`. */
static void ms_gpr__forward(const ms_gpr__kernels *f, const double *u, size_t u_stride, int n, double *b,
                            size_t b_stride, int columns)
{
    int h = ms_gpr__half(n), i, k;
    if (n > MS_GPR__BLOCK) {
        double *below = b + (size_t)h * b_stride;
        ms_gpr__forward(f, u, u_stride, h, b, b_stride, columns);
        f->reduce(below, b_stride, u + h, u_stride, b, b_stride, n - h, columns, h, 0);
        ms_gpr__forward(f, u + (size_t)h * (u_stride + 1), u_stride, n - h, below, b_stride, columns);
        return;
    }
    for (i = 0; i < n; ++i) { /* u_ii b_i = b_i - sum over k < i of u_ki b_k */
        double *row = b + (size_t)i * b_stride, scale = 1 / u[(size_t)i * (u_stride + 1)];
        for (k = 0; k < i; ++k) f->axpy(row, -u[(size_t)k * u_stride + (size_t)i], b + (size_t)k * b_stride, columns);
        for (k = 0; k < columns; ++k) row[k] *= scale;
    }
}

/* u' u = u in place, upper triangles. 0 if a pivot is not above `least`: not positive definite in double precision. */
static int ms_gpr__cholesky(const ms_gpr__kernels *f, double *u, size_t stride, int n, double least)
{
    int h = ms_gpr__half(n), i, j, k;
    if (n > MS_GPR__BLOCK) {
        double *right = u + h, *rest = u + (size_t)h * (stride + 1);
        if (!ms_gpr__cholesky(f, u, stride, h, least)) return 0;
        ms_gpr__forward(f, u, stride, h, right, stride, n - h);
        f->reduce(rest, stride, right, stride, right, stride, n - h, n - h, h, MS_GPR__UPPER);
        return ms_gpr__cholesky(f, rest, stride, n - h, least);
    }
    for (i = 0; i < n; ++i) {
        double *row = u + (size_t)i * stride, scale;
        for (k = 0; k < i; ++k)
            for (j = i; j < n; ++j) row[j] -= u[(size_t)k * stride + (size_t)i] * u[(size_t)k * stride + (size_t)j];
        if (!(row[i] > least) || !ms__finite(row[i])) return 0;
        scale = 1 / sqrt(row[i]);
        for (j = i; j < n; ++j) row[j] *= scale;
    }
    return 1;
}

/* y = u'^-1, the lower triangle of y; of the upper one the blocks on the diagonal are set to 0, the rest must be 0. */
static void ms_gpr__invert(const ms_gpr__kernels *f, const double *u, size_t stride, int n, double *y)
{
    int h = ms_gpr__half(n), i, j;
    if (n > MS_GPR__BLOCK) {
        const double *rest = u + (size_t)h * (stride + 1);
        double *below = y + (size_t)h * stride;
        ms_gpr__invert(f, u, stride, h, y);
        ms_gpr__invert(f, rest, stride, n - h, below + h);
        for (i = 0; i < n - h; ++i) memset(below + (size_t)i * stride, 0, (size_t)h * sizeof *below);
        f->reduce(below, stride, u + h, stride, y, stride, n - h, h, h, MS_GPR__LOWER);
        ms_gpr__forward(f, rest, stride, n - h, below, stride, h);
        return;
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) y[(size_t)i * stride + (size_t)j] = i == j;
    ms_gpr__forward(f, u, stride, n, y, stride, n);
}

/* v = u'^-1 v */
static void ms_gpr__forward_vector(const ms_gpr__kernels *f, const double *u, size_t stride, int n, double *v)
{
    int block, i, j;
    for (block = 0; block < n; block += MS_GPR__BLOCK) {
        int end = block + MS_GPR__BLOCK;
        for (i = block; i < end; ++i) {
            const double *row = u + (size_t)i * stride;
            v[i] /= row[i];
            for (j = i + 1; j < end; ++j) v[j] -= row[j] * v[i];
            f->axpy(v + end, -v[i], row + end, n - end);
        }
    }
}

/* v = u^-1 v */
static void ms_gpr__backward_vector(const ms_gpr__kernels *f, const double *u, size_t stride, int n, double *v)
{
    int block, i, j;
    for (block = n - MS_GPR__BLOCK; block >= 0; block -= MS_GPR__BLOCK) {
        int end = block + MS_GPR__BLOCK;
        for (i = end - 1; i >= block; --i) {
            const double *row = u + (size_t)i * stride;
            v[i] -= f->dot(row + end, v + end, n - end);
            for (j = i + 1; j < end; ++j) v[i] -= row[j] * v[j];
            v[i] /= row[i];
        }
    }
}

/* v = (u' u)^-1 v */
static void ms_gpr__solve(const ms_gpr__kernels *f, const double *u, size_t stride, int n, double *v)
{
    ms_gpr__forward_vector(f, u, stride, n, v);
    ms_gpr__backward_vector(f, u, stride, n, v);
}

/* --- memory --- */

typedef struct ms_gpr__block {
    struct ms_gpr__block *before;
    void *start;
    size_t size;
} ms_gpr__block;

/* Arrays that live as long as a call or an object. */
typedef struct ms_gpr__memory {
    ms_allocator allocator;
    ms_gpr__block *last; /* each stands in front of its array */
    int failed;          /* one had no room */
} ms_gpr__memory;

/* `count` zeros of `size` bytes, on a cache line; NULL where there is no room. */
static void *ms_gpr__take_bytes(ms_gpr__memory *memory, size_t count, size_t size)
{
    const size_t front = sizeof(ms_gpr__block) + 63, all = ms__size_add(ms__size_mul(count, size), front);
    char *start = (char *)ms__alloc(&memory->allocator, all);
    ms_gpr__block *block;
    memory->failed |= start == NULL;
    if (start == NULL) return NULL;
    memset(start, 0, all);
    block = (ms_gpr__block *)(void *)(start + front - ((uintptr_t)(start + front) & 63)) - 1;
    block->before = memory->last;
    block->start = start;
    block->size = all;
    memory->last = block;
    return block + 1;
}

static double *ms_gpr__take(ms_gpr__memory *memory, size_t a, size_t b)
{
    return (double *)ms_gpr__take_bytes(memory, ms__size_mul(a, b), sizeof(double));
}

/* The next `arrays` arguments (double **) become arrays of so many doubles. */
static void ms_gpr__take_each(ms_gpr__memory *memory, size_t doubles, int arrays, ...)
{
    va_list list;
    va_start(list, arrays);
    for (; arrays > 0; --arrays) *va_arg(list, double **) = ms_gpr__take(memory, doubles, 1);
    va_end(list);
}

static void ms_gpr__release(ms_gpr__memory *memory)
{
    while (memory->last) {
        const ms_gpr__block block = *memory->last;
        ms__release(&memory->allocator, block.start, block.size);
        memory->last = block.before;
    }
}

/* MS_OUT_OF_MEMORY where an array had no room. */
static ms_status ms_gpr__taken(const ms_gpr__memory *memory, const char *what, ms_error *error)
{
    return memory->failed ? ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %s", what) : MS_OK;
}

/* ---- descent --------------------------------------------------------------------------------------------------- */

/* f(q) and its gradient. 1: defined; 0: not defined here, the search steps back; -1: stop. */
typedef int (*ms_gpr__objective)(void *context, const double *q, double *value, double *gradient);

enum { MS_GPR__MEMORY = 20 }; /* pairs that L-BFGS remembers; more gained nothing, 10 cost a fifth more evaluations */

typedef struct ms_gpr__minimum {
    double value; /* of the last q; HUGE_VAL: not even the start is defined */
    int evaluations;
    int stopped; /* f asked to stop */
} ms_gpr__minimum;

/* How a search runs; q stays in the box [low, high]. */
typedef struct ms_gpr__search {
    ms_gpr__objective f;
    void *context;
    int count; /* of variables */
    const double *low, *high;
    double step;      /* no variable moves farther at a time */
    double tolerance; /* ends when an iteration gains less, and no projected slope is above its root */
    int evaluations;  /* at most */
} ms_gpr__search;

static size_t ms_gpr__minimize_doubles(int count)
{
    return ms__size_add(ms__size_mul((size_t)count, 2 * MS_GPR__MEMORY + 4), 2 * MS_GPR__MEMORY);
}

static double ms_gpr__clamp(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

/* Whether variable i sits on a bound and the gradient holds it there. */
static int ms_gpr__at_bound(const ms_gpr__search *s, int i, double x, double slope)
{
    return (x <= s->low[i] && slope > 0) || (x >= s->high[i] && slope < 0);
}

static double ms_gpr__product(const double *a, const double *b, size_t count)
{
    double sum = 0;
    size_t i;
    for (i = 0; i < count; ++i) sum += a[i] * b[i];
    return sum;
}

/* to += scale from */
static void ms_gpr__add(double *to, double scale, const double *from, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) to[i] += scale * from[i];
}

/* Projected L-BFGS (Nocedal & Wright 2006, algorithm 7.4) with a backtracking line search along the projected path.
   q: start in, best out. work: ms_gpr__minimize_doubles(count). Never leaves q worse than it was. */
static ms_gpr__minimum ms_gpr__minimize(const ms_gpr__search *s, double *q, double *work)
{
    size_t n = (size_t)s->count;
    double *moves = work, *changes = moves + MS_GPR__MEMORY * n, *gradient = changes + MS_GPR__MEMORY * n,
           *direction = gradient + n, *trial = direction + n, *trial_gradient = trial + n, *rho = trial_gradient + n,
           *a = rho + MS_GPR__MEMORY;
    ms_gpr__minimum best;
    double gain = HUGE_VAL;
    int stored = 0, newest = -1, i, k, defined;
    best.evaluations = 1;
    best.value = HUGE_VAL;
    for (i = 0; i < s->count; ++i) q[i] = ms_gpr__clamp(q[i], s->low[i], s->high[i]);
    defined = s->f(s->context, q, &best.value, gradient);
    best.stopped = defined < 0;
    if (defined != 1) return best;
    while (best.evaluations < s->evaluations) {
        double slope = 0, largest = 0, step = 1, value = 0, decrease = 0, steepest = 0;
        double *move, *change, length, curvature, shrink;
        for (i = 0; i < s->count; ++i) {
            direction[i] = ms_gpr__at_bound(s, i, q[i], gradient[i]) ? 0 : -gradient[i];
            if (fabs(direction[i]) > steepest) steepest = fabs(direction[i]);
        }
        if (!(steepest > 0) || gain < 1e-3 * s->tolerance) break;
        if (gain < s->tolerance && steepest * steepest < s->tolerance) break;
        length = 0.5 / fmax(steepest, 0.5);
        for (k = 0; k < stored; ++k) { /* two-loop recursion, on the free variables */
            const size_t at = (size_t)((newest - k + MS_GPR__MEMORY) % MS_GPR__MEMORY);
            a[at] = rho[at] * ms_gpr__product(moves + at * n, direction, n);
            ms_gpr__add(direction, -a[at], changes + at * n, n);
        }
        if (stored) {
            change = changes + (size_t)newest * n;
            length = 1 / (rho[newest] * ms_gpr__product(change, change, n));
        }
        for (k = 0; k < s->count; ++k) direction[k] *= length;
        for (k = stored - 1; k >= 0; --k) {
            const size_t at = (size_t)((newest - k + MS_GPR__MEMORY) % MS_GPR__MEMORY);
            const double b = rho[at] * ms_gpr__product(changes + at * n, direction, n);
            ms_gpr__add(direction, a[at] - b, moves + at * n, n);
        }
        for (i = 0; i < s->count; ++i) {
            if (ms_gpr__at_bound(s, i, q[i], gradient[i])) direction[i] = 0;
            slope += direction[i] * gradient[i];
            if (fabs(direction[i]) > largest) largest = fabs(direction[i]);
        }
        if (!(slope < 0) || !ms__finite(largest)) {
            if (stored == 0) break;
            stored = 0; /* forget, and go downhill */
            continue;
        }
        if (largest > s->step) step = s->step / largest;
        for (;;) {
            decrease = 0;
            for (i = 0; i < s->count; ++i) {
                trial[i] = ms_gpr__clamp(q[i] + step * direction[i], s->low[i], s->high[i]);
                decrease += gradient[i] * (trial[i] - q[i]);
            }
            defined = s->f(s->context, trial, &value, trial_gradient);
            ++best.evaluations;
            best.stopped = defined < 0;
            if (best.stopped) return best;
            if (defined && ms__finite(value) && value <= best.value + 1e-4 * decrease) break;
            if (best.evaluations >= s->evaluations || step * largest < 1e-12) {
                defined = 0;
                break;
            }
            shrink = 0.25;
            if (defined && ms__finite(value)) /* to the minimum of the parabola through both values and the slope */
                shrink = -0.5 * decrease / (value - best.value - decrease);
            step *= fmin(fmax(shrink, 0.1), 0.5);
        }
        if (!defined) {
            if (stored == 0 || best.evaluations >= s->evaluations) break;
            stored = 0;
            continue;
        }
        move = moves + (size_t)((newest + 1) % MS_GPR__MEMORY) * n;
        change = changes + (size_t)((newest + 1) % MS_GPR__MEMORY) * n;
        for (i = 0; i < s->count; ++i) {
            move[i] = trial[i] - q[i];
            change[i] = trial_gradient[i] - gradient[i];
            q[i] = trial[i];
            gradient[i] = trial_gradient[i];
        }
        gain = best.value - value;
        best.value = value;
        curvature = ms_gpr__product(move, change, n);
        if (curvature > 1e-10 * ms_gpr__product(change, change, n)) {
            newest = (newest + 1) % MS_GPR__MEMORY;
            rho[newest] = 1 / curvature;
            if (stored < MS_GPR__MEMORY) ++stored;
        }
    }
    return best;
}

/* From the best of the starts q [starts][count], after `trial` evaluations each, to a minimum, in the first row. */
static ms_gpr__minimum ms_gpr__minimize_starts(ms_gpr__search *s, double *q, int starts, int trial, double *work)
{
    const int budget = s->evaluations;
    const size_t row = (size_t)s->count;
    double best = HUGE_VAL, *won = q;
    int i;
    s->evaluations = budget < trial ? budget : trial;
    for (i = 0; i < starts && starts > 1; ++i) {
        ms_gpr__minimum found = ms_gpr__minimize(s, q + (size_t)i * row, work);
        if (found.stopped) return found;
        if (found.value < best) best = found.value, won = q + (size_t)i * row;
    }
    memmove(q, won, row * sizeof *q);
    s->evaluations = budget;
    return ms_gpr__minimize(s, q, work);
}

/* ---- posterior ------------------------------------------------------------------------------------------------- */

/* Part of K / sf^2 that every row is held to the prior mean by, so that W can be inverted. */
static const double MS_GPR__RIDGE = 1e-5;
static const double MS_GPR__SCALE_OF_CHOICES = 0.7796968012336761; /* sqrt(6) / pi: of Gumbel noise of deviation 1 */
static const double MS_GPR__LOG_2_PI = 1.8378770664093454836;

/* What one evaluation needs. Rows and columns behind n stand for points that are independent of everything.
   "Soft" problems have choices, or rows without a score: they have Laplace's approximation in place of the exact
   posterior, with f the most probable latent values and W = -d^2 log p(what was said | f) / df^2. */
typedef struct ms_gpr__problem {
    const ms_gpr__kernels *kernels;
    int n, m;        /* m: dimensions in use */
    size_t stride;   /* of every matrix here */
    double *points;  /* [m][stride] inputs in length scales, by dimension */
    double *target;  /* [stride] scores less the prior mean, or MS_GPR_UNSCORED */
    double *alpha;   /* [stride] K'^-1 target; of soft ones K^-1 f */
    double *kernel;  /* [n][stride] K, upper triangle */
    double *upper;   /* [n][stride] the factor U'U of K', of soft ones of K + W^-1; the gradient puts -(U'U)^-1 there */
    double *inverse; /* [n][stride] U'^-1 */
    double *weight;  /* [stride] a row of dL/dK * K */
    /* of soft problems: */
    int soft;
    ms_gpr_choices choices;
    int joined;          /* rows behind the last one that a choice has are independent given f */
    double *probability; /* of the materials of a choice */
    double *solved;      /* [n][stride] U'^-1 K; before that, W */
    double *latent;      /* [stride] f */
    double *list;        /* [6][stride] scratch */
} ms_gpr__problem;

/* K, upper triangle: sf^2 exp(-d^2 / 2), 0 for padding. */
static void ms_gpr__covariance(const ms_gpr__kernels *f, const double *points, size_t stride, int n, int m, double sf2,
                               double *kernel)
{
    int padded = ms_gpr__padded(n), i, j;
    for (i = 0; i < padded; ++i) {
        double *row = kernel + (size_t)i * stride;
        int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK;
        f->distances(row + block, points + block, stride, points + i, stride, m, padded - block);
        f->exponentials(row + block, padded - block, sf2);
        for (j = i < n ? n : block; j < padded; ++j) row[j] = 0;
    }
}

/* upper = the factor of kernel + noise I. 0: not positive definite by a margin of its rounding errors. */
static int ms_gpr__factor(const ms_gpr__kernels *f, const double *kernel, size_t stride, int n, double sf2,
                          double noise, double *upper)
{
    int padded = ms_gpr__padded(n), i;
    for (i = 0; i < padded; ++i) {
        const size_t at = (size_t)i * (stride + 1);
        memcpy(upper + at, kernel + at, (size_t)(padded - i) * sizeof *upper);
        upper[at] = sf2 + noise;
    }
    return ms_gpr__cholesky(f, upper, stride, padded, n * 2.220446049250313e-16 * (sf2 + noise));
}

static int ms_gpr__scored(double y) { return y > 0.5 * MS_GPR_UNSCORED; }

static double ms_gpr__log_determinant(const double *upper, size_t stride, int n)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) sum += log(upper[(size_t)i * (stride + 1)]);
    return 2 * sum;
}

/* matrix = -(U'U)^-1 = -(U'^-1)' U'^-1, upper triangle, of the first n rows of the factor U that it holds. */
static void ms_gpr__minus_inverse(ms_gpr__problem *p, double *matrix, int n)
{
    const size_t size = (size_t)n * p->stride * sizeof *matrix;
    memset(p->inverse, 0, size);
    ms_gpr__invert(p->kernels, matrix, p->stride, n, p->inverse);
    memset(matrix, 0, size);
    p->kernels->reduce(matrix, p->stride, p->inverse, p->stride, p->inverse, p->stride, n, n, n,
                       MS_GPR__UPPER | MS_GPR__LOWER);
}

/* --- choices: Laplace's approximation --- */

/* out = K v; K is whole. */
static void ms_gpr__times_kernel(const ms_gpr__problem *p, const double *v, double *out)
{
    int padded = ms_gpr__padded(p->n), i;
    for (i = 0; i < padded; ++i) out[i] = p->kernels->dot(p->kernel + (size_t)i * p->stride, v, padded);
}

static int ms_gpr__choice_size(const ms_gpr_choices *choices, int c) { return choices->sizes ? choices->sizes[c] : 2; }

/* p->probability of the materials of a choice at the latent values, scale s; returns the logarithm of the first one. */
static double ms_gpr__choose(const ms_gpr__problem *p, const int *row, int size, double s)
{
    double largest = p->latent[row[0]], sum = 0;
    int i;
    for (i = 1; i < size; ++i) largest = fmax(largest, p->latent[row[i]]);
    for (i = 0; i < size; ++i) sum += p->probability[i] = exp((p->latent[row[i]] - largest) / s);
    for (i = 0; i < size; ++i) p->probability[i] /= sum;
    return (p->latent[row[0]] - largest) / s - log(sum);
}

static double ms_gpr__scale_of(double noise) { return MS_GPR__SCALE_OF_CHOICES * sqrt(noise); }

/* log p(what was said | f) - alpha' f / 2, which Newton's method climbs. */
static double ms_gpr__log_posterior(const ms_gpr__problem *p, double ridge, double noise)
{
    const int *row = p->choices.rows;
    double sum = 0, s = ms_gpr__scale_of(noise);
    int size, i;
    for (i = 0; i < p->n; ++i) {
        double off = p->target[i] - p->latent[i];
        sum -= 0.5 * p->latent[i] * (p->alpha[i] + ridge * p->latent[i]);
        if (ms_gpr__scored(p->target[i])) sum -= 0.5 * (off * off / noise + log(noise) + MS_GPR__LOG_2_PI);
    }
    for (i = 0; i < p->choices.count; ++i, row += size) {
        size = ms_gpr__choice_size(&p->choices, i);
        sum += ms_gpr__choose(p, row, size, s);
    }
    return sum;
}

/* At the latent values: W into `solved`, upper triangle, and l1 = l' = d log p / df. A choice adds (diag(p) - p p') /
   s^2 to W. */
static void ms_gpr__laplace_terms(ms_gpr__problem *p, double ridge, double noise, double *l1)
{
    const int *row = p->choices.rows;
    double *w = p->solved, s = ms_gpr__scale_of(noise);
    int padded = ms_gpr__padded(p->n), size, c, i, j;
    memset(w, 0, (size_t)padded * p->stride * sizeof *w);
    for (i = 0; i < padded; ++i) {
        const int scored = i < p->n && ms_gpr__scored(p->target[i]);
        w[(size_t)i * (p->stride + 1)] = i < p->n ? ridge + (scored ? 1 / noise : 0) : 1;
        l1[i] = (scored ? (p->target[i] - p->latent[i]) / noise : 0) - ridge * p->latent[i];
    }
    for (c = 0; c < p->choices.count; ++c, row += size) {
        size = ms_gpr__choice_size(&p->choices, c);
        ms_gpr__choose(p, row, size, s);
        for (i = 0; i < size; ++i) {
            const double pi = p->probability[i] / (s * s);
            l1[row[i]] += ((i == 0) - p->probability[i]) / s;
            w[(size_t)row[i] * (p->stride + 1)] += pi;
            for (j = 0; j <= i; ++j) {
                const int first = row[i] < row[j] ? row[i] : row[j], second = row[i] < row[j] ? row[j] : row[i];
                w[(size_t)first * p->stride + (size_t)second] -= pi * p->probability[j];
            }
        }
    }
}

/* upper = the factor of K + W^-1 at the latent values; list[0] = f + W^-1 l', list[1] = l'. Returns log |W|, or 1e300
   where a factor fails. */
static double ms_gpr__laplace_factor(ms_gpr__problem *p, double ridge, double noise)
{
    const ms_gpr__kernels *f = p->kernels;
    const int padded = ms_gpr__padded(p->n), joined = ms_gpr__padded(p->joined);
    double *z = p->list, *l1 = z + p->stride, *w = p->solved, determinant;
    int i;
    ms_gpr__laplace_terms(p, ridge, noise, l1);
    if (!ms_gpr__cholesky(f, w, p->stride, joined, 0)) return 1e300;
    for (i = joined; i < padded; ++i) w[(size_t)i * (p->stride + 1)] = sqrt(w[(size_t)i * (p->stride + 1)]);
    determinant = ms_gpr__log_determinant(w, p->stride, p->n);
    memcpy(z, l1, (size_t)padded * sizeof *z);
    ms_gpr__solve(f, w, p->stride, padded, z);
    ms_gpr__minus_inverse(p, w, joined);
    memcpy(p->upper, p->kernel, (size_t)padded * p->stride * sizeof *p->upper);
    for (i = 0; i < padded; ++i) {
        const size_t at = (size_t)i * p->stride;
        const double root = w[at + (size_t)i];
        const int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK;
        z[i] += p->latent[i];
        if (i < joined) f->axpy(p->upper + at + block, -1, w + at + block, joined - block);
        else p->upper[at + (size_t)i] += 1 / (root * root);
    }
    return ms_gpr__cholesky(f, p->upper, p->stride, padded, 0) ? determinant : 1e300;
}

/* Laplace's approximation, from the alpha that is there: Newton's method in f (Rasmussen & Williams 2006, 3.4, with W
   that need not be diagonal) to f and alpha, the factor of K + W^-1, and log p(y) = log p(what was said | f) -
   alpha' f / 2 - log |I + K W| / 2. 0: no factor. */
static int ms_gpr__laplace(ms_gpr__problem *p, double sf2, double noise, double *likelihood)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), step, halving, i;
    size_t row = (size_t)padded * sizeof(double);
    double ridge = MS_GPR__RIDGE / sf2, determinant = 0, value, better = 0;
    double *z = p->list, *l1 = z + p->stride, *turn = l1 + p->stride, *move = turn + p->stride;
    ms_gpr__times_kernel(p, p->alpha, p->latent);
    value = ms_gpr__log_posterior(p, ridge, noise);
    for (step = 0; step < 100; ++step) {
        double slope = 0;
        /* Newton's step: to alpha = (K + W^-1)^-1 (f + W^-1 l'), f = K alpha */
        determinant = ms_gpr__laplace_factor(p, ridge, noise);
        if (determinant > 1e299 || !ms__finite(determinant)) return 0;
        memcpy(turn, z, row);
        ms_gpr__solve(f, p->upper, p->stride, padded, turn);
        ms_gpr__times_kernel(p, turn, move);
        for (i = 0; i < padded; ++i) {
            turn[i] -= p->alpha[i];
            move[i] -= p->latent[i];
            slope += (l1[i] - p->alpha[i]) * move[i];
        }
        /* the whole step, then half of it back, a quarter, ... until the posterior grows */
        for (halving = 0; halving < 40; ++halving) {
            double length = halving ? -0.5 / (1 << (halving < 30 ? halving - 1 : 29)) : 1;
            f->axpy(p->alpha, length, turn, padded);
            f->axpy(p->latent, length, move, padded);
            if (slope < 1e-8 * (1 + fabs(value))) break; /* whole steps converge; rounding hides what is gained */
            better = ms_gpr__log_posterior(p, ridge, noise);
            if (ms__finite(better) && better > value) break;
        }
        if (slope < 1e-12 * (1 + fabs(value)) || halving == 40) break;
        if (better > value) value = better;
    }
    *likelihood = ms_gpr__log_posterior(p, ridge, noise) -
        0.5 * (determinant + ms_gpr__log_determinant(p->upper, p->stride, p->n));
    return 1;
}

/* s = -1/2 d log |I + K W| / df = 1/2 sum over j, k of C_jk d^3 log p / df df_j df_k, at the latent values; C
   [n][stride]. by_s [stride], by_noise: the derivatives of l' and of the whole by log sn. For a choice with
   q_j = C_jj - 2 (C p)_j: W = (diag(p) - p p') / s^2, dp_j/df_i = p_j (delta_ij - p_i) / s. */
static void ms_gpr__laplace_third(ms_gpr__problem *p, double noise, const double *covariance, double *third,
                                  double *by_s, double *by_noise)
{
    const int *row = p->choices.rows;
    double s = ms_gpr__scale_of(noise), *q = p->list + 5 * p->stride;
    int size, c, i, j;
    memset(third, 0, p->stride * sizeof *third);
    memset(by_s, 0, p->stride * sizeof *by_s);
    for (i = 0; i < p->n; ++i) {
        double off = p->target[i] - p->latent[i];
        if (!ms_gpr__scored(p->target[i])) continue;
        by_s[i] = -2 * off / noise;
        *by_noise += off * off / noise - 1 + covariance[(size_t)i * (p->stride + 1)] / noise;
    }
    for (c = 0; c < p->choices.count; ++c, row += size) {
        double mean_q = 0, mean_variance = 0, quadratic = 0, mean_latent = 0, *probability = p->probability;
        size = ms_gpr__choice_size(&p->choices, c);
        ms_gpr__choose(p, row, size, s);
        for (i = 0; i < size; ++i) {
            const double *own = covariance + (size_t)row[i] * p->stride;
            double product = 0; /* (C p)_i */
            for (j = 0; j < size; ++j) product += own[row[j]] * probability[j];
            q[i] = own[row[i]] - 2 * product;
            mean_q += probability[i] * q[i];
            mean_variance += probability[i] * own[row[i]];
            quadratic += probability[i] * product;
            mean_latent += probability[i] * p->latent[row[i]];
        }
        for (i = 0; i < size; ++i) third[row[i]] -= 0.5 * probability[i] * (q[i] - mean_q) / (s * s * s);
        *by_noise += (mean_latent - p->latent[row[0]]) / s + (mean_variance - quadratic) / (s * s);
        for (i = 0; i < size; ++i) {
            double turn = probability[i] * (p->latent[row[i]] - mean_latent) / s; /* -dp_i/dlog s */
            by_s[row[i]] += (turn - (i == 0) + probability[i]) / s;
            *by_noise += 0.5 * turn * q[i] / (s * s);
        }
    }
}

/* What the gradient of Laplace's log p(y) has besides tr((alpha alpha' - (K + W^-1)^-1) dK) / 2 because f depends on
   theta (Rasmussen & Williams 2006, 5.5.1): u' dK alpha with u = (I - (K + W^-1)^-1 K) s, s as in
   ms_gpr__laplace_third; and by log sf and log sn through ridge and noise. Returns u, in the list of the problem. */
static const double *ms_gpr__laplace_implicit(ms_gpr__problem *p, double sf2, double noise, double *by_sf,
                                              double *by_sn)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), i;
    const size_t matrix = (size_t)padded * p->stride * sizeof *p->solved;
    double ridge = MS_GPR__RIDGE / sf2;
    double *s = p->list, *u = s + p->stride, *h = u + p->stride, *by_s = h + p->stride;
    *by_sf = *by_sn = 0;
    /* inverse = C = K - K (K + W^-1)^-1 K, the covariance of the latent values, whole; solved = U'^-1 K */
    memcpy(p->solved, p->kernel, matrix);
    memcpy(p->inverse, p->kernel, matrix);
    ms_gpr__forward(f, p->upper, p->stride, padded, p->solved, p->stride, padded);
    f->reduce(p->inverse, p->stride, p->solved, p->stride, p->solved, p->stride, padded, padded, padded, 0);
    ms_gpr__laplace_third(p, noise, p->inverse, s, by_s, by_sn);
    ms_gpr__times_kernel(p, s, u);
    ms_gpr__solve(f, p->upper, p->stride, padded, u);
    for (i = 0; i < padded; ++i) u[i] = s[i] - u[i];
    ms_gpr__times_kernel(p, u, h);
    *by_sn += f->dot(by_s, h, padded);
    for (i = 0; i < p->n; ++i)
        *by_sf += ridge *
            (p->latent[i] * p->latent[i] + p->inverse[(size_t)i * (p->stride + 1)] + 2 * p->latent[i] * h[i]);
    return u;
}

/* Moves alpha and f from the mode to the mean, to third order: E f = f + C s (Tierney & Kadane 1986). By the mode
   alone, the probability of a pair of a decisive person is wrong by 0.13. The factor is made anew at the mode: that of
   the last step is off by the length of that step. 0: no factor. */
static int ms_gpr__laplace_mean(ms_gpr__problem *p, double sf2, double noise)
{
    double by_sf, by_sn;
    int padded = ms_gpr__padded(p->n);
    if (ms_gpr__laplace_factor(p, MS_GPR__RIDGE / sf2, noise) > 1e299) return 0;
    p->kernels->axpy(p->alpha, 1, ms_gpr__laplace_implicit(p, sf2, noise, &by_sf, &by_sn), padded);
    p->kernels->axpy(p->latent, 1, p->list + 2 * p->stride, padded);
    return 1;
}

/* --- both --- */

/* log p(y | X, theta) = -1/2 y' alpha - 1/2 log |K'| - n/2 log 2 pi, or Laplace's approximation, and its gradient [m +
   2] with respect to log l_k, log sf, log sn (NULL: not wanted):  1/2 tr((alpha alpha' - K'^-1) dK'/dtheta). 0 where K'
   is not positive definite. */
static int ms_gpr__evaluate(ms_gpr__problem *p, double sf2, double noise, double *likelihood, double *gradient)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), i, k;
    size_t row = (size_t)padded * sizeof(double);
    double trace = 0, kernel_sum = 0, by_sf = 0, by_sn = 0;
    const double *implicit = NULL;
    ms_gpr__covariance(f, p->points, p->stride, p->n, p->m, sf2, p->kernel);
    if (p->soft) {
        for (i = 0; i < padded; ++i) { /* K, whole */
            p->kernel[(size_t)i * (p->stride + 1)] = i < p->n ? sf2 : 0;
            for (k = 0; k < i; ++k)
                p->kernel[(size_t)i * p->stride + (size_t)k] = p->kernel[(size_t)k * p->stride + (size_t)i];
        }
        if (!ms_gpr__laplace(p, sf2, noise, likelihood)) return 0;
    } else {
        if (!ms_gpr__factor(f, p->kernel, p->stride, p->n, sf2, noise, p->upper)) return 0;
        memcpy(p->alpha, p->target, row);
        ms_gpr__solve(f, p->upper, p->stride, padded, p->alpha);
        *likelihood = -0.5 *
            (f->dot(p->alpha, p->target, padded) + ms_gpr__log_determinant(p->upper, p->stride, p->n) +
             p->n * MS_GPR__LOG_2_PI);
    }
    if (gradient == NULL) return 1;
    if (p->soft) implicit = ms_gpr__laplace_implicit(p, sf2, noise, &by_sf, &by_sn);
    ms_gpr__minus_inverse(p, p->upper, padded);

    /* row by row: weights (alpha_i alpha_j - K'^-1_ij) K_ij, and their sums over d_ijk^2: dK_ij/dlog l_k = K_ij d_ijk^2
       and pairs count twice */
    memset(gradient, 0, (size_t)p->m * sizeof *gradient);
    for (i = 0; i < p->n; ++i) {
        int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK, j;
        size_t at = (size_t)i * p->stride;
        if (implicit) {
            f->axpy(p->upper + at + block, implicit[i], p->alpha + block, padded - block);
            f->axpy(p->upper + at + block, p->alpha[i], implicit + block, padded - block);
        }
        f->axpy(p->upper + at + block, p->alpha[i], p->alpha + block, padded - block);
        trace += p->upper[at + (size_t)i];
        for (j = block; j <= i; ++j) p->kernel[at + (size_t)j] = 0; /* each pair once; the diagonal has d = 0 */
        for (j = block; j < padded; ++j) {
            p->weight[j] = p->upper[at + (size_t)j] * p->kernel[at + (size_t)j];
            kernel_sum += p->weight[j];
        }
        f->slopes(gradient, p->weight + block, p->points + block, p->stride, p->points + i, p->m, padded - block);
    }
    gradient[p->m] = sf2 * trace + 2 * kernel_sum + by_sf; /* dK/dlog sf = 2 K */
    gradient[p->m + 1] = p->soft ? by_sn : noise * trace;  /* dK'/dlog sn = 2 sn^2 I */
    return 1;
}

/* How many materials all choices have. */
static size_t ms_gpr__choice_rows(const ms_gpr_choices *choices)
{
    size_t sum = 0;
    int i;
    for (i = 0; i < choices->count; ++i) sum += (size_t)ms_gpr__choice_size(choices, i);
    return sum;
}

/* The arrays, all 0, of a problem with the rows and the choices of `data`. */
static void ms_gpr__problem_make(ms_gpr__problem *p, const ms_gpr__kernels *kernels, const ms_gpr_view *data, int m,
                                 ms_gpr__memory *memory)
{
    const size_t padded = (size_t)ms_gpr__padded(data->n), stride = ms_gpr__stride(data->n);
    const size_t chosen = ms_gpr__choice_rows(&data->choices);
    size_t i;
    memset(p, 0, sizeof *p);
    p->kernels = kernels;
    p->n = data->n;
    p->m = m;
    p->stride = stride;
    p->choices = data->choices;
    p->soft = chosen > 0;
    for (i = 0; i < (size_t)data->n; ++i) p->soft |= !ms_gpr__scored(data->y[i]);
    p->points = ms_gpr__take(memory, (size_t)m, stride);
    ms_gpr__take_each(memory, padded * stride, 3, &p->kernel, &p->upper, &p->inverse);
    ms_gpr__take_each(memory, stride, 3, &p->target, &p->alpha, &p->weight);
    if (!p->soft) return;
    p->solved = ms_gpr__take(memory, padded, stride);
    p->list = ms_gpr__take(memory, 6, stride);
    ms_gpr__take_each(memory, stride, 2, &p->latent, &p->probability);
    for (i = 0; i < chosen; ++i)
        if (p->choices.rows[i] >= p->joined) p->joined = p->choices.rows[i] + 1;
}

/* ---- model ----------------------------------------------------------------------------------------------------- */

static const double MS_GPR__DROPPED = 700.0; /* log l_k of a dimension that is dropped: no exp of it overflows */
enum { MS_GPR__N_MAX = 30000 };              /* by memory */
static const double MS_GPR__LARGEST = 1e30;  /* of a score or an input: squares of sums stay finite */
static const double MS_GPR__INT_MAX = 2147483647;

struct ms_gpr {
    ms_gpr_view view; /* what it consists of; its arrays are in `memory`. floor_value >= floor: there is no floor */
    ms_gpr_options o;
    int n, m, active; /* active: dimensions in use */
    size_t stride;
    double likelihood;
    const ms_gpr__kernels *kernels;
    ms_gpr__memory memory; /* what follows */
    double *value;         /* [n] y, or what is predicted for a row without */
    double *center;        /* [m] subtracted from inputs, so that offsets cost no digits */
    double *scale;         /* [m] 1 / l_k */
    double *points;        /* [active][stride] (x - center) / l by dimension, padded with zeros */
    double *alpha;         /* [stride] */
    double *upper;         /* [n][stride] U'U = K', of soft ones K + W^-1 */
    int *dimension;        /* [active] which column of x */
};

static double ms_gpr__sf2(const ms_gpr *gp) { return exp(2 * gp->view.theta[gp->m]); }
static double ms_gpr__sn2(const ms_gpr *gp) { return exp(2 * gp->view.theta[gp->m + 1]); }

static double ms_gpr__modeled(double y, double floor, double floor_value)
{
    return floor_value < floor && y <= floor ? floor_value : y;
}

static double ms_gpr__target(const ms_gpr_view *v, int i)
{
    return ms_gpr__scored(v->y[i]) ? ms_gpr__modeled(v->y[i], v->floor, v->floor_value) - v->mean : MS_GPR_UNSCORED;
}

/* The input x [m] in length scales from the center, `spacing` apart. */
static void ms_gpr__scale(const ms_gpr *gp, const double *x, double *scaled, size_t spacing)
{
    int k;
    for (k = 0; k < gp->active; ++k) {
        int d = gp->dimension[k];
        scaled[(size_t)k * spacing] = (x[d] - gp->center[d]) * gp->scale[d];
    }
}

/* How many of n values, `spacing` apart, are not MS_GPR_UNSCORED, the least of them and the largest (HUGE_VAL and
   -HUGE_VAL where none is). */
static int ms_gpr__range(const double *values, int n, size_t spacing, double *least, double *largest)
{
    int count = 0, i;
    *least = HUGE_VAL, *largest = -HUGE_VAL;
    for (i = 0; i < n; ++i) {
        const double value = values[(size_t)i * spacing];
        if (!ms_gpr__scored(value)) continue;
        *least = fmin(*least, value);
        *largest = fmax(*largest, value);
        ++count;
    }
    return count;
}

/* The least score that counts: the floor; without one the least that was given, and 0 where all are equal and above, or
   none is. */
static double ms_gpr__floor_of(const ms_gpr *gp)
{
    double least, largest;
    if (gp->view.floor_value < gp->view.floor) return gp->view.floor;
    ms_gpr__range(gp->view.y, gp->n, 1, &least, &largest);
    return largest > least || least < 0 ? least : 0;
}

/* Everything that follows from x, y, choices and theta. The jitter, in units of sf^2, is the least power of ten that
   does. Newton's method starts where `before` (or NULL), a model of mostly the same rows, has its mean. */
static ms_status ms_gpr__condition(ms_gpr *gp, const ms_gpr *before, ms_error *error)
{
    ms_gpr__problem p;
    ms_gpr__memory memory = {gp->o.allocator, NULL, 0};
    double sf2 = ms_gpr__sf2(gp);
    size_t m = (size_t)gp->m, row = gp->stride * sizeof(double);
    int found = 0, i, k;
    ms_status status;

    /* points in length scales from the center of all, by the dimensions in use */
    for (k = 0; k < gp->m; ++k) {
        gp->scale[k] = exp(-gp->view.theta[k]);
        if (gp->view.theta[k] < MS_GPR__DROPPED) gp->dimension[gp->active++] = k;
        for (i = 0; i < gp->n; ++i) gp->center[k] += gp->view.x[(size_t)i * m + (size_t)k] / gp->n;
    }
    for (i = 0; i < gp->n; ++i) ms_gpr__scale(gp, gp->view.x + (size_t)i * m, gp->points + i, gp->stride);

    /* the posterior */
    ms_gpr__problem_make(&p, gp->kernels, &gp->view, gp->active, &memory);
    status = ms_gpr__taken(&memory, "a likelihood", error);
    if (status == MS_OK) memcpy(p.points, gp->points, (size_t)gp->active * row);
    for (i = 0; i < gp->n && status == MS_OK; ++i) p.target[i] = ms_gpr__target(&gp->view, i);
    for (; status == MS_OK && gp->view.jitter < 2e-6; gp->view.jitter = fmax(10 * gp->view.jitter, 1e-15)) {
        double noise = ms_gpr__sn2(gp) + gp->view.jitter * sf2;
        memset(p.alpha, 0, row);
        if (before) memcpy(p.alpha, before->alpha, (size_t)(before->n < gp->n ? before->n : gp->n) * sizeof *p.alpha);
        found = ms_gpr__evaluate(&p, sf2, noise, &gp->likelihood, NULL);
        if (found && p.choices.count > 0) found = ms_gpr__laplace_mean(&p, sf2, noise);
        if (found) break;
    }
    if (found) {
        memcpy(gp->alpha, p.alpha, row);
        memcpy(gp->upper, p.upper, (size_t)ms_gpr__padded(gp->n) * row);
        for (i = 0; i < gp->n; ++i)
            gp->value[i] = ms_gpr__scored(gp->view.y[i]) ? gp->view.y[i] : gp->view.mean + p.latent[i];
    } else if (status == MS_OK) {
        status = ms__fail(error, MS_NOT_CONVERGED, 0,
                          "the covariance of %d points is not positive definite even with 1e-6 sf^2 added", gp->n);
    }
    ms_gpr__release(&memory);
    return status;
}

/* --- checks --- */

/* MS_INVALID_ARGUMENT where `value` is not from low to high. */
static ms_status ms_gpr__check_range(const char *name, double value, double low, double high, ms_error *error)
{
    if (ms__finite(value) && value >= low && value <= high) return MS_OK;
    return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is %g: expected a number from %g to %g", name, value, low, high);
}

static ms_status ms_gpr__null(const char *name, ms_error *error)
{
    return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", name);
}

/* Position: the row, from 1. */
static ms_status ms_gpr__check_rows(const double *x, int rows, int columns, double limit, const char *what,
                                    ms_error *error)
{
    int i, k;
    for (i = 0; i < rows; ++i)
        for (k = 0; k < columns; ++k) {
            const double v = x[(size_t)i * (size_t)columns + (size_t)k];
            if (!ms__finite(v) || !(fabs(v) <= limit))
                return ms__fail(error, MS_BAD_DATA, (size_t)i + 1,
                                "%s %d, column %d is %g: expected a number from %g to %g", what, i + 1, k + 1, v,
                                -limit, limit);
        }
    return MS_OK;
}

static ms_status ms_gpr__check_choices(const ms_gpr_choices *choices, int n, ms_error *error)
{
    const int *row = choices->rows;
    int i, j, k, wrong;
    ms_status status = ms_gpr__check_range("choices.count", choices->count, 0, MS_GPR__INT_MAX, error);
    if (status != MS_OK) return status;
    if (choices->count > 0 && row == NULL) return ms_gpr__null("choices.rows", error);
    for (i = 0; i < choices->count; ++i) {
        const int size = ms_gpr__choice_size(choices, i);
        if (size < 2 || size > n)
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i + 1, "choice %d has %d materials: expected 2 to %d",
                            i + 1, size, n);
        for (j = 0; j < size; ++j) {
            wrong = row[j] < 0 || row[j] >= n;
            for (k = 0; k < j; ++k) wrong |= row[k] == row[j];
            if (wrong)
                return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i + 1,
                                "choice %d has row %d: expected different rows from 0 to %d", i + 1, row[j], n - 1);
        }
        row += size;
    }
    return MS_OK;
}

/* For a fit they need no theta. */
static ms_status ms_gpr__check_parts(const ms_gpr_view *parts, int fit, ms_error *error)
{
    const double unscored = MS_GPR_UNSCORED, *y = parts->y;
    const int n = parts->n, m = parts->m;
    ms_status status = ms_gpr__check_range("n", n, 0, MS_GPR__N_MAX, error);
    int i, k;
    if (status == MS_OK) status = ms_gpr__check_range("m", m, 1, MS_GPR__INT_MAX, error);
    if (status == MS_OK && n > 0 && (parts->x == NULL || y == NULL)) status = ms_gpr__null(parts->x ? "y" : "x", error);
    if (status == MS_OK) status = ms_gpr__check_rows(parts->x, n, m, MS_GPR__LARGEST, "input", error);
    for (i = 0; i < n && status == MS_OK; ++i)
        if (memcmp(&y[i], &unscored, sizeof unscored) != 0 && (!ms__finite(y[i]) || !(fabs(y[i]) <= MS_GPR__LARGEST)))
            status = ms__fail(error, MS_BAD_DATA, (size_t)i + 1, "score %d is %g: expected a number from %g to %g",
                              i + 1, y[i], -MS_GPR__LARGEST, MS_GPR__LARGEST);
    if (status == MS_OK && parts->theta == NULL && n > 0 && !fit) status = ms_gpr__null("theta", error);
    for (k = 0; status == MS_OK && parts->theta && k < m + 2; ++k) {
        double limit = k < m ? MS_GPR__DROPPED : 300;
        if (!ms__finite(parts->theta[k]) || !(fabs(parts->theta[k]) <= limit))
            status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "theta[%d] is %g: expected a logarithm from %g to %g", k,
                              parts->theta[k], -limit, limit);
    }
    if (status == MS_OK) status = ms_gpr__check_choices(&parts->choices, n, error);
    if (status == MS_OK) status = ms_gpr__check_range("mean", parts->mean, -1e100, 1e100, error);
    if (status == MS_OK) status = ms_gpr__check_range("floor", parts->floor, -1e100, 1e100, error);
    if (status == MS_OK) status = ms_gpr__check_range("floor_value", parts->floor_value, -1e100, 1e100, error);
    return status;
}

/* --- create, update --- */

/* before: as in ms_gpr__condition. */
static ms_status ms_gpr__make(const ms_gpr_view *parts, const ms_gpr_options *o, const ms_gpr *before, ms_gpr **out,
                              ms_error *error)
{
    const size_t n = (size_t)parts->n, m = (size_t)parts->m, chosen = ms_gpr__choice_rows(&parts->choices);
    ms_gpr *gp = (ms_gpr *)ms__alloc(&o->allocator, sizeof *gp);
    double *x, *y, *theta;
    int *rows, *sizes, k;
    ms_status status;
    if (gp == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model");
    memset(gp, 0, sizeof *gp);
    gp->o = *o;
    gp->n = parts->n;
    gp->m = parts->m;
    gp->stride = ms_gpr__stride(gp->n);
    gp->memory.allocator = o->allocator;
    gp->upper = ms_gpr__take(&gp->memory, (size_t)ms_gpr__padded(gp->n), gp->stride);
    gp->points = ms_gpr__take(&gp->memory, m, gp->stride);
    gp->alpha = ms_gpr__take(&gp->memory, gp->stride, 1);
    x = ms_gpr__take(&gp->memory, n, m);
    ms_gpr__take_each(&gp->memory, n, 2, &y, &gp->value);
    ms_gpr__take_each(&gp->memory, m + 2, 3, &theta, &gp->center, &gp->scale);
    gp->dimension = (int *)ms_gpr__take_bytes(&gp->memory, m, sizeof(int));
    rows = (int *)ms_gpr__take_bytes(&gp->memory, chosen, sizeof(int));
    sizes = (int *)ms_gpr__take_bytes(&gp->memory, (size_t)parts->choices.count, sizeof(int));
    status = ms_gpr__taken(&gp->memory, "a model", error);
    if (status == MS_OK) {
        if (n > 0) memcpy(x, parts->x, n * m * sizeof *x);
        if (n > 0) memcpy(y, parts->y, n * sizeof *y);
        if (chosen > 0) memcpy(rows, parts->choices.rows, chosen * sizeof *rows);
        for (k = 0; k < parts->choices.count; ++k) sizes[k] = ms_gpr__choice_size(&parts->choices, k);
        for (k = 0; k < gp->m; ++k) theta[k] = 0.5 * log((double)m); /* the default: lengths sqrt(m), sf 1, sn 0.1 */
        theta[m + 1] = -2.302585092994046;
        if (parts->theta) memcpy(theta, parts->theta, (m + 2) * sizeof *theta);
        gp->view = *parts;
        gp->view.x = x;
        gp->view.y = y;
        gp->view.theta = theta;
        gp->view.value = gp->value;
        gp->view.choices.rows = rows;
        gp->view.choices.sizes = sizes;
        gp->view.jitter = 0;
        gp->kernels = ms_gpr__kernels_of(o->simd);
        gp->view.level = gp->kernels->level;
        status = ms_gpr__condition(gp, before, error);
    }
    if (status == MS_OK) *out = gp;
    else ms_gpr_destroy(gp);
    return status;
}

MS_API ms_status ms_gpr_create(const ms_gpr_view *parts, const ms_gpr_options *options, ms_gpr **out, ms_error *error)
{
    ms_gpr_options o;
    ms_status status;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    if (parts == NULL) return ms_gpr__null("parts", error);
    memset(&o, 0, sizeof o);
    if (options) o = *options;
    status = ms_gpr__check_parts(parts, 0, error);
    return status == MS_OK ? ms_gpr__make(parts, &o, NULL, out, error) : status;
}

MS_API ms_status ms_gpr_update(ms_gpr *gp, const ms_gpr_view *parts, ms_error *error)
{
    ms_gpr *made, old;
    ms_status status;
    if (gp == NULL || parts == NULL) return ms_gpr__null(gp ? "parts" : "gp", error);
    status = ms_gpr__check_range("m", parts->m, gp->m, gp->m, error);
    if (status == MS_OK) status = ms_gpr__check_parts(parts, 0, error);
    if (status == MS_OK) status = ms_gpr__make(parts, &gp->o, gp, &made, error);
    if (status != MS_OK) return status;
    old = *gp;
    *gp = *made;
    *made = old;
    ms_gpr_destroy(made);
    return MS_OK;
}

MS_API void ms_gpr_destroy(ms_gpr *gp)
{
    ms_allocator allocator;
    if (gp == NULL) return;
    allocator = gp->o.allocator;
    ms_gpr__release(&gp->memory);
    ms__release(&allocator, gp, sizeof *gp);
}

MS_API ms_gpr_view ms_gpr_view_of(const ms_gpr *gp)
{
    ms_gpr_view view;
    memset(&view, 0, sizeof view);
    if (gp == NULL) return view;
    view = gp->view;
    view.floor = ms_gpr__floor_of(gp);
    if (!(gp->view.floor_value < gp->view.floor)) view.floor_value = view.floor;
    return view;
}

/* --- prediction --- */

/* Means, and where variance is not NULL variances, of CHUNK candidates: scaled [active] rows, in length scales.
   columns: scratch of one row; with variances [padded n] rows, left as U'^-1 k(training, candidates). Rows are `stride`
   apart. */
static void ms_gpr__chunk(const ms_gpr *gp, const double *scaled, double *columns, size_t stride, double *mean,
                          double *variance)
{
    const int padded = ms_gpr__padded(gp->n);
    const double sf2 = ms_gpr__sf2(gp);
    int i, j;
    for (j = 0; j < MS_GPR__CHUNK; ++j) mean[j] = gp->view.mean;
    for (i = 0; i < padded; ++i) {
        double *row = variance ? columns + (size_t)i * stride : columns;
        gp->kernels->distances(row, scaled, stride, gp->points + i, gp->stride, gp->active, MS_GPR__CHUNK);
        gp->kernels->exponentials(row, MS_GPR__CHUNK, i < gp->n ? sf2 : 0);
        gp->kernels->axpy(mean, gp->alpha[i], row, MS_GPR__CHUNK);
    }
    if (variance == NULL) return;
    ms_gpr__forward(gp->kernels, gp->upper, gp->stride, padded, columns, stride, MS_GPR__CHUNK);
    for (j = 0; j < MS_GPR__CHUNK; ++j) variance[j] = sf2;
    for (i = 0; i < gp->n; ++i) {
        const double *v = columns + (size_t)i * stride;
        for (j = 0; j < MS_GPR__CHUNK; ++j) variance[j] -= v[j] * v[j];
    }
    for (j = 0; j < MS_GPR__CHUNK; ++j) variance[j] = fmax(variance[j], 0);
}

/* row [stride] = k(training, x), 0 for padding; point [m] = x in length scales. */
static void ms_gpr__covariances(const ms_gpr *gp, const double *x, double *point, double *row)
{
    const int padded = ms_gpr__padded(gp->n);
    int i;
    ms_gpr__scale(gp, x, point, 1);
    gp->kernels->distances(row, gp->points, gp->stride, point, 1, gp->active, padded);
    gp->kernels->exponentials(row, padded, ms_gpr__sf2(gp));
    for (i = gp->n; i < padded; ++i) row[i] = 0;
}

/* Predictions that tasks share: chunks of candidates task, task + tasks, ... */
typedef struct ms_gpr__batch {
    const ms_gpr *gp;
    const double *x;
    int count, tasks;
    double *mean, *variance;
    double *scratch; /* [tasks][task_doubles] */
    size_t task_doubles;
} ms_gpr__batch;

static void ms_gpr__predict_task(void *context, int task)
{
    const ms_gpr__batch *b = (const ms_gpr__batch *)context;
    const ms_gpr *gp = b->gp;
    double *scaled = b->scratch + (size_t)task * b->task_doubles, *columns = scaled + gp->active * MS_GPR__CHUNK;
    double mean[MS_GPR__CHUNK], variance[MS_GPR__CHUNK];
    int start, j;
    for (start = task * MS_GPR__CHUNK; start < b->count; start += b->tasks * MS_GPR__CHUNK) {
        const int filled = b->count - start < MS_GPR__CHUNK ? b->count - start : MS_GPR__CHUNK;
        for (j = 0; j < filled; ++j)
            ms_gpr__scale(gp, b->x + (size_t)(start + j) * (size_t)gp->m, scaled + j, MS_GPR__CHUNK);
        ms_gpr__chunk(gp, scaled, columns, MS_GPR__CHUNK, mean, b->variance ? variance : NULL);
        for (j = 0; j < filled; ++j) {
            if (b->mean) b->mean[start + j] = mean[j];
            if (b->variance) b->variance[start + j] = variance[j];
        }
    }
}

static ms_status ms_gpr__check_candidates(const ms_gpr *gp, const double *x, int count, ms_error *error)
{
    ms_status status;
    if (gp == NULL || (count > 0 && x == NULL)) return ms_gpr__null(gp ? "x" : "gp", error);
    status = ms_gpr__check_range("count", count, 0, 0x7fffffff - 16 * MS_GPR__CHUNK, error);
    return status == MS_OK ? ms_gpr__check_rows(x, count, gp->m, 1.7e308, "candidate", error) : status;
}

MS_API ms_status ms_gpr_predict(const ms_gpr *gp, const double *x, int count, double *mean, double *variance,
                                ms_error *error)
{
    ms_gpr__batch b = {gp, x, count, 1, mean, variance, NULL, 0};
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_status status = ms_gpr__check_candidates(gp, x, count, error);
    int chunks = (count - 1) / MS_GPR__CHUNK + 1;
    if (status != MS_OK || count == 0) return status;
    memory.allocator = gp->o.allocator;
    if (gp->o.parallel.run) b.tasks = chunks < 16 ? chunks : 16;
    b.task_doubles = MS_GPR__CHUNK * ((size_t)gp->active + 1 + (variance ? (size_t)ms_gpr__padded(gp->n) : 0));
    b.scratch = ms_gpr__take(&memory, (size_t)b.tasks, b.task_doubles);
    status = ms_gpr__taken(&memory, "predictions", error);
    if (status == MS_OK) ms__run(&gp->o.parallel, b.tasks, ms_gpr__predict_task, &b);
    ms_gpr__release(&memory);
    return status;
}

MS_API ms_status ms_gpr_leave_one_out(const ms_gpr *gp, double *mean, double *variance, ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    double *inverse;
    ms_status status;
    int padded, i, j;
    if (gp == NULL || mean == NULL || variance == NULL)
        return ms_gpr__null(gp == NULL ? "gp" : mean == NULL ? "mean" : "variance", error);
    memory.allocator = gp->o.allocator;
    padded = ms_gpr__padded(gp->n);
    inverse = ms_gpr__take(&memory, (size_t)padded, gp->stride);
    status = ms_gpr__taken(&memory, "predictions of scores", error);
    if (status == MS_OK) ms_gpr__invert(gp->kernels, gp->upper, gp->stride, padded, inverse);
    for (i = 0; i < gp->n && status == MS_OK; ++i) {
        double diagonal = 0; /* of K'^-1 = Y'Y, which is 1 / variance */
        for (j = i; j < gp->n; ++j) diagonal += pow(inverse[(size_t)j * gp->stride + (size_t)i], 2);
        variance[i] = 1 / diagonal;
        mean[i] = gp->view.mean + ms_gpr__target(&gp->view, i) - gp->alpha[i] / diagonal;
    }
    ms_gpr__release(&memory);
    return status;
}

MS_API ms_status ms_gpr_preference(const ms_gpr *gp, const double *a, const double *b, int count, double *probability,
                                   ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    double sf2, scale2, *k, *other, *point, *than;
    int i, j, padded;
    ms_status status = ms_gpr__check_candidates(gp, b, count, error);
    if (status == MS_OK) status = ms_gpr__check_candidates(gp, a, count, error);
    if (status == MS_OK && probability == NULL && count > 0) status = ms_gpr__null("probability", error);
    if (status != MS_OK) return status;
    memory.allocator = gp->o.allocator;
    ms_gpr__take_each(&memory, gp->stride, 2, &k, &other);
    ms_gpr__take_each(&memory, (size_t)gp->m, 2, &point, &than);
    status = ms_gpr__taken(&memory, "pairs of materials", error);
    padded = ms_gpr__padded(gp->n);
    sf2 = ms_gpr__sf2(gp);
    scale2 = MS_GPR__SCALE_OF_CHOICES * MS_GPR__SCALE_OF_CHOICES * (ms_gpr__sn2(gp) + gp->view.jitter * sf2);
    for (i = 0; i < count && status == MS_OK; ++i) {
        /* f(a) - f(b): k(a) - k(b), variance 2 sf^2 - 2 k(a, b) - |U'^-1 (k(a) - k(b))|^2 */
        double d2 = 0, mean, variance;
        ms_gpr__covariances(gp, a + (size_t)i * (size_t)gp->m, point, k);
        ms_gpr__covariances(gp, b + (size_t)i * (size_t)gp->m, than, other);
        gp->kernels->axpy(k, -1, other, padded);
        for (j = 0; j < gp->active; ++j) d2 += (point[j] - than[j]) * (point[j] - than[j]);
        mean = gp->kernels->dot(k, gp->alpha, padded);
        ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, k);
        variance = fmax(-2 * sf2 * expm1(-0.5 * d2) - gp->kernels->dot(k, k, padded), 0);
        /* MacKay 1992: pi / 8 makes a logistic of a normal's tail */
        probability[i] = 1 / (1 + exp(-mean / sqrt(scale2 + 0.39269908169872414 * variance)));
    }
    ms_gpr__release(&memory);
    return status;
}

/* ---- learn ----------------------------------------------------------------------------------------------------- */

typedef struct ms_gpr__ranked {
    double value;
    int index;
} ms_gpr__ranked;

/* The values with their indices; sorted: the largest first, of equal ones the smallest index. */
static void ms_gpr__rank(ms_gpr__ranked *list, const double *values, int count, int sorted)
{
    int i, j;
    for (i = 0; i < count; ++i) {
        for (j = i; sorted && j > 0 && values[i] > list[j - 1].value; --j) list[j] = list[j - 1];
        list[j].value = values[i];
        list[j].index = i;
    }
}

static const double MS_GPR__PRIOR_TAIL = 1.0;    /* spreads of the noise, see ms_gpr__fit_starts */
static const double MS_GPR__FLOOR_OFFSET = 0.75; /* standard deviations that scores at the floor are modeled below it */

enum {
    MS_GPR__STARTS = 3,
    MS_GPR__TRIAL = 30, /* evaluations of each start before all but the best stop */
    MS_GPR__PART = 100  /* scores at least that the starts run on, and 4 m; a third of all, at most 400 */
};

/* The search over q = log l_k / width_k, log sf / unit, log sn / unit; unit: the standard deviation of the scores. */
typedef struct ms_gpr__fit {
    ms_gpr_fit_options o;    /* with the defaults filled in */
    ms_gpr_view data;        /* what the model is made of */
    int m, part, starts;     /* m: columns that are not constant; part: scores that the starts run on */
    ms_gpr__problem problem; /* its scores have mean 0 and standard deviation 1; the first `part` rows are the part */
    double *columns;         /* [m][stride] inputs in widths from their centers, by dimension */
    int *column;             /* [m] which column of x */
    double *width, *center;  /* [m] */
    double *low, *high;      /* [m + 2] bounds of q */
    double *prior, *spread;  /* [m + 2] */
    double *q;               /* [starts][m + 2]; the winner ends in the first row */
    double *theta;           /* [columns of x + 2] what the model gets */
    ms_gpr__ranked *order;   /* [n] */
    double *work, unit;
    int scored;
    int expected; /* evaluations, about */
    ms_gpr_fit_report report;
} ms_gpr__fit;

/* Minus the log prior, of which the maximum is 0; adds its gradient (NULL: not wanted). */
static double ms_gpr__fit_penalty(const ms_gpr__fit *fit, const double *q, double *gradient)
{
    double sum = 0;
    int k;
    for (k = 0; k < fit->m + 2; ++k) {
        double z = (q[k] - fit->prior[k]) / fit->spread[k], tail = k == fit->m + 1 ? MS_GPR__PRIOR_TAIL : 1e9;
        double slope = z > tail ? tail : z;
        sum += slope * (z - 0.5 * slope);
        if (gradient) gradient[k] += slope / fit->spread[k];
    }
    return sum;
}

static int ms_gpr__fit_objective(void *context, const double *q, double *value, double *gradient)
{
    ms_gpr__fit *fit = (ms_gpr__fit *)context;
    ms_gpr__problem *p = &fit->problem;
    const ms_progress *progress = &fit->o.progress;
    double likelihood, fraction = fmin((double)fit->report.evaluations / fit->expected, 1);
    int i, k;
    if (progress->report && progress->report(progress->user, fraction)) return -1;
    ++fit->report.evaluations;
    for (k = 0; k < p->m; ++k) {
        const double *column = fit->columns + (size_t)k * p->stride;
        double *row = p->points + (size_t)k * p->stride, scale = exp(-q[k]);
        for (i = 0; i < p->n; ++i) row[i] = column[i] * scale;
    }
    if (!ms_gpr__evaluate(p, exp(2 * q[p->m]), exp(2 * q[p->m + 1]), &likelihood, gradient)) return 0;
    for (k = 0; k < p->m + 2; ++k) gradient[k] = -gradient[k];
    *value = ms_gpr__fit_penalty(fit, q, gradient) - likelihood;
    return 1;
}

/* The floor, what scores there are modeled as, and what makes mean 0 and standard deviation 1 of them. 0: all scores
   are equal, and nothing was chosen. */
static int ms_gpr__fit_scores(ms_gpr__fit *fit)
{
    ms_gpr_view *data = &fit->data;
    const double *y = data->y;
    const int n = data->n;
    double least, largest, sum = 0, sum2 = 0;
    int i, pass, at_floor = 0, has_floor, scored = ms_gpr__range(y, n, 1, &least, &largest);
    if (scored == 0) least = largest = 0;
    fit->scored = scored;
    fit->unit = fabs(largest) > 0 ? fabs(largest) : 1;
    data->mean = 0.5 * (least + largest);
    for (i = 0; i < n; ++i) at_floor += ms_gpr__scored(y[i]) && y[i] <= least;
    has_floor = fit->o.floor || (at_floor >= 2 && 8.0 * at_floor >= scored && at_floor < scored);
    data->floor = data->floor_value = has_floor ? fit->o.floor ? *fit->o.floor : least : 0;
    if (scored > 0 && has_floor && largest <= data->floor) { /* nothing above it: a flat model there */
        fit->unit = fabs(data->floor) > 0 ? fabs(data->floor) : 1;
        data->mean = data->floor_value = data->floor - 1e-9 * fit->unit;
        return data->choices.count > 0;
    }
    if (!(largest - least > 1e-12 * (fabs(largest) + fabs(least)))) return data->choices.count > 0;
    for (pass = 0; pass < 2; ++pass) { /* of the scores (at most at the floor), then of what they are modeled as */
        for (i = 0, sum = sum2 = 0; i < n; ++i)
            if (ms_gpr__scored(y[i])) sum += (has_floor && y[i] <= data->floor ? data->floor_value : y[i]) / scored;
        for (i = 0; i < n; ++i) {
            double d = (has_floor && y[i] <= data->floor ? data->floor_value : y[i]) - sum;
            if (ms_gpr__scored(y[i])) sum2 += d * d / scored;
        }
        if (pass == 0 && has_floor) data->floor_value -= MS_GPR__FLOOR_OFFSET * sqrt(sum2);
    }
    data->mean = sum;
    fit->unit = sqrt(sum2);
    return 1;
}

/* Centers and widths of the columns that are not constant, but for rounding. */
static ms_status ms_gpr__fit_columns(ms_gpr__fit *fit, ms_error *error)
{
    const int n = fit->data.n, m = fit->data.m;
    int i, k;
    for (k = 0; k < m && n > 0; ++k) {
        const double *v = fit->data.x + k;
        double least, largest, sum = 0, sum2 = 0;
        ms_gpr__range(v, n, (size_t)m, &least, &largest);
        for (i = 0; i < n; ++i) sum += v[(size_t)i * (size_t)m] / n;
        if (!(largest - least > 1e-10 * fmax(fabs(least), fabs(largest)))) continue;
        if (largest - least < 1 / MS_GPR__LARGEST)
            return ms__fail(error, MS_BAD_DATA, (size_t)k + 1, "column %d spans %g: expected more than %g; scale it",
                            k + 1, largest - least, 1 / MS_GPR__LARGEST);
        for (i = 0; i < n; ++i) {
            double d = v[(size_t)i * (size_t)m] - sum;
            sum2 += d * d / n;
        }
        fit->center[fit->m] = sum;
        fit->width[fit->m] = 3.4641016151377544 * sqrt(sum2); /* sqrt 12 */
        fit->column[fit->m++] = k;
    }
    return MS_OK;
}

/* The rows of the problem. The first `part` are a part of the scores that stands for all: the better half of it is the
   best of all, the rest comes evenly from what is left. */
static void ms_gpr__fit_rows(ms_gpr__fit *fit)
{
    const ms_gpr_view *data = &fit->data;
    const double *y = data->y;
    const int n = data->n;
    ms_gpr__problem *p = &fit->problem;
    int best = fit->part / 2, even = fit->part - best, left = n - best, i, k;
    ms_gpr__rank(fit->order, y, n, fit->part < n);
    for (i = 0; i < even && fit->part < n; ++i) { /* what is swapped stands behind anything looked for later */
        int from = best + (int)((size_t)(2 * i + 1) * (size_t)left / (size_t)(2 * even));
        ms_gpr__ranked swap = fit->order[best + i];
        fit->order[best + i] = fit->order[from];
        fit->order[from] = swap;
    }
    for (i = 0; i < n; ++i) {
        const int row = fit->order[i].index;
        const double *x = data->x + (size_t)row * (size_t)data->m;
        for (k = 0; k < fit->m; ++k)
            fit->columns[(size_t)k * p->stride + (size_t)i] = (x[fit->column[k]] - fit->center[k]) / fit->width[k];
        p->target[i] = ms_gpr__target(data, row);
        if (ms_gpr__scored(y[row])) p->target[i] /= fit->unit;
    }
}

/* The box, the starts, and log-normal priors of l_k in widths, of sf and of sn in standard deviations of the scores.
   That of the lengths is close to the one of Hvarfner and others 2024, "Vanilla Bayesian optimization performs great
   in high dimensions". The prior of the noise is tight: a wide one lets a fit of few scores call all of them noise or
   none. More than MS_GPR__PRIOR_TAIL spreads above its mean the penalty is linear, so that scores which contradict
   each other raise it. Choices alone tell only the ratio of sf and sn, few of them not even that: its prior is a
   person who orders most random pairs as they like them (1/2 + atan(ratio) / pi of all). */
static void ms_gpr__fit_starts(ms_gpr__fit *fit)
{
    static const double lengths[MS_GPR__STARTS] = {0.25, 0.5, 3}; /* widths, times sqrt(m) */
    const double *start = fit->o.start;
    double root = sqrt((double)(fit->m > 0 ? fit->m : 1));
    int m = fit->m, i, k;
    for (k = 0; k < m; ++k) {
        fit->low[k] = log(0.01);
        fit->high[k] = log(1000.0);
        fit->prior[k] = log(2.1 * root);
        fit->spread[k] = 1.5;
    }
    fit->low[m] = fit->low[m + 1] = log(1e-3);
    fit->high[m] = log(1e3), fit->high[m + 1] = log(10.0);
    fit->prior[m] = fit->scored ? 0 : log(0.7);
    fit->spread[m] = fit->scored ? 1 : 0.5;
    fit->prior[m + 1] = log(0.5);
    fit->spread[m + 1] = 0.25;
    for (i = 0; i < fit->starts; ++i) {
        double *q = fit->q + i * (m + 2);
        for (k = 0; k < m; ++k) q[k] = start ? start[fit->column[k]] - log(fit->width[k]) : log(lengths[i] * root);
        q[m] = start ? start[fit->data.m] - log(fit->unit) : 0;
        q[m + 1] = start ? start[fit->data.m + 1] - log(fit->unit) : -2.302585092994046; /* log 0.1 */
    }
}

/* The optimum, in q's first row: the starts on a part of the scores, then some evaluations on all of them. */
static ms_gpr__minimum ms_gpr__fit_search(ms_gpr__fit *fit)
{
    ms_gpr__minimum found;
    ms_gpr__search s;
    int n = fit->data.n;
    s.f = ms_gpr__fit_objective;
    s.context = fit;
    s.count = fit->m + 2;
    s.low = fit->low;
    s.high = fit->high;
    s.step = 4;
    s.tolerance = 1e-4;
    s.evaluations = fit->o.evaluations;
    fit->problem.n = fit->part;
    found = ms_gpr__minimize_starts(&s, fit->q, fit->starts, MS_GPR__TRIAL, fit->work);
    fit->problem.n = n;
    if (found.stopped || fit->part == n) return found;
    s.tolerance = 0.1; /* of a log posterior: what is below it changes no prediction */
    if (s.evaluations > 1 + 9000 / n) s.evaluations = n < 3000 ? 1 + 9000 / n : 4; /* each takes n^3 */
    return ms_gpr__minimize(&s, fit->q, fit->work);
}

/* How many scores the starts run on, in whole blocks; n: all, where they are few or have choices. Below 200 scores a
   part loses; at 300 it is six times faster, at the same divergence. */
static int ms_gpr__fit_part(const ms_gpr__fit *fit)
{
    const int n = fit->data.n, m = fit->data.m;
    int least = 4 * m > MS_GPR__PART ? 4 * m : MS_GPR__PART, part = n / 3;
    if (fit->starts == 1 || fit->problem.soft || n / 2 < least) return n;
    part = part < least ? least : part > 400 ? 400 : part;
    return ms_gpr__padded(part) < n ? ms_gpr__padded(part) : n;
}

/* The checks and the arrays, in memory that is to be released whatever is returned. */
static ms_status ms_gpr__fit_begin(ms_gpr__fit *fit, ms_gpr__memory *memory, ms_error *error)
{
    const ms_gpr_view *data = &fit->data;
    const size_t m = (size_t)data->m, row = m + 2;
    ms_status status = ms_gpr__check_parts(data, 1, error);
    if (status == MS_OK && fit->o.floor)
        status = ms_gpr__check_range("floor", *fit->o.floor, -MS_GPR__LARGEST, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("evaluations", fit->o.evaluations, 0, MS_GPR__INT_MAX, error);
    if (status != MS_OK) return status;
    if (fit->o.evaluations == 0) fit->o.evaluations = 200;
    fit->starts = fit->o.start ? 1 : (int)MS_GPR__STARTS;
    fit->expected = 30 * fit->starts + fit->o.evaluations / 2;
    ms_gpr__problem_make(&fit->problem, ms_gpr__kernels_of(fit->o.simd), data, data->m, memory);
    fit->part = ms_gpr__fit_part(fit);
    fit->columns = ms_gpr__take(memory, m, ms_gpr__stride(data->n));
    fit->work = ms_gpr__take(memory, ms_gpr__minimize_doubles(data->m + 2), 1);
    fit->q = ms_gpr__take(memory, row, (size_t)fit->starts);
    ms_gpr__take_each(memory, row, 7, &fit->low, &fit->high, &fit->prior, &fit->spread, &fit->width, &fit->center,
                      &fit->theta);
    fit->column = (int *)ms_gpr__take_bytes(memory, row, sizeof(int));
    fit->order = (ms_gpr__ranked *)ms_gpr__take_bytes(memory, (size_t)data->n, sizeof *fit->order);
    return ms_gpr__taken(memory, "a fit", error);
}

static ms_status ms_gpr__fit_run(ms_gpr__fit *fit, ms_error *error)
{
    ms_gpr__minimum found;
    ms_status status = ms_gpr__fit_columns(fit, error);
    int differ = ms_gpr__fit_scores(fit), m = fit->data.m, k;
    if (status == MS_OK && differ && fit->unit < 1 / MS_GPR__LARGEST)
        status = ms__fail(error, MS_BAD_DATA, 0, "the scores span about %g: expected more than %g; scale them",
                          fit->unit, 1 / MS_GPR__LARGEST);
    if (status != MS_OK) return status;
    ms_gpr__fit_rows(fit);
    ms_gpr__fit_starts(fit);
    fit->problem.m = fit->m;
    memset(&found, 0, sizeof found);
    if (differ && fit->m > 0) found = ms_gpr__fit_search(fit);
    else if (fit->starts > 2) memcpy(fit->q, fit->q + 2 * (fit->m + 2), ((size_t)fit->m + 2) * sizeof *fit->q);
    if (found.stopped)
        return ms__fail(error, MS_CANCELLED, 0, "the fit was cancelled after %d evaluations", fit->report.evaluations);
    if (differ && fit->m > 0) fit->report.objective = -ms_gpr__fit_penalty(fit, fit->q, NULL);
    for (k = 0; k < m; ++k) fit->theta[k] = MS_GPR__DROPPED;
    for (k = 0; k < fit->m; ++k) fit->theta[fit->column[k]] = fit->q[k] + log(fit->width[k]);
    for (k = 0; k < 2; ++k) fit->theta[m + k] = fit->q[fit->m + k] + log(fit->unit);
    fit->data.theta = fit->theta;
    return MS_OK;
}

MS_API ms_status ms_gpr_fit(const double *x, const double *y, int n, int m, const ms_gpr_fit_options *options,
                            ms_gpr **out, ms_gpr_fit_report *report, ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr__fit fit;
    ms_gpr_options o;
    ms_status status;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    memset(&fit, 0, sizeof fit);
    if (options) fit.o = *options;
    fit.data.n = n;
    fit.data.m = m;
    fit.data.x = x;
    fit.data.y = y;
    fit.data.theta = fit.o.start;
    fit.data.choices = fit.o.choices;
    memory.allocator = o.allocator = fit.o.allocator;
    o.simd = fit.o.simd;
    o.parallel = fit.o.parallel;
    status = ms_gpr__fit_begin(&fit, &memory, error);
    if (status == MS_OK) status = ms_gpr__fit_run(&fit, error);
    if (status == MS_OK) status = ms_gpr__make(&fit.data, &o, NULL, out, error);
    if (status == MS_OK && report) {
        *report = fit.report;
        report->likelihood = (*out)->likelihood;
        report->objective += report->likelihood;
    }
    ms_gpr__release(&memory);
    return status;
}

/* ---- search ---------------------------------------------------------------------------------------------------- */

/* A stream of random numbers of its own for every seed and stream: splitmix64 (Steele, Lea & Flood 2014). */
typedef uint64_t ms_gpr__random;

static uint64_t ms_gpr__mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static ms_gpr__random ms_gpr__random_make(uint64_t seed, uint64_t stream)
{
    return ms_gpr__mix(seed + 0x9e3779b97f4a7c15u * ms_gpr__mix(stream + 0x9e3779b97f4a7c15u));
}

/* Uniform in the open interval (0, 1), 52 bits. */
static double ms_gpr__uniform(ms_gpr__random *random)
{
    uint64_t z = ms_gpr__mix(*random += 0x9e3779b97f4a7c15u);
    return ((double)(z >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}

/* --- box --- */

/* A ms_gpr_space made ready: a material in the box has a point in the unit box. */
typedef struct ms_gpr__box {
    int m;
    double *low, *high, *width, *per; /* [m] in units of x; per: 1 / width or 0 */
    void (*snap)(void *user, double *x);
    void *user;
} ms_gpr__box;

/* wish[k], where it is given and not infinite. */
static double ms_gpr__bound(const double *wish, int k, double sign, double otherwise)
{
    return wish == NULL || (!ms__finite(wish[k]) && sign * wish[k] > 0) ? otherwise : wish[k];
}

/* x [n][m]: what the box is made of where the space has none. */
static ms_status ms_gpr__box_make(const double *x, int n, int m, const ms_gpr_space *space, ms_gpr__memory *memory,
                                  ms_gpr__box *box, ms_error *error)
{
    ms_status status;
    int k;
    box->m = m;
    box->snap = space->snap;
    box->user = space->user;
    ms_gpr__take_each(memory, (size_t)m, 4, &box->low, &box->high, &box->width, &box->per);
    status = ms_gpr__taken(memory, "a box", error);
    for (k = 0; k < m && status == MS_OK; ++k) {
        double low, high;
        ms_gpr__range(x + k, n, (size_t)m, &low, &high);
        if (low >= 0 && high <= 1 && (n < 8 || high > low)) low = 0, high = 1;
        low = ms_gpr__bound(space->low, k, -1, low);
        high = ms_gpr__bound(space->high, k, 1, high);
        if (!(low <= high) || !(fabs(low) <= MS_GPR__LARGEST) || !(fabs(high) <= MS_GPR__LARGEST))
            status = ms__fail(error, MS_INVALID_ARGUMENT, 0,
                              "the box of dimension %d is [%g, %g]: expected low <= high, to 1e30 in size", k, low,
                              high);
        box->low[k] = low;
        box->high[k] = high;
        box->width[k] = high - low;
        box->per[k] = high > low ? 1 / (high - low) : 0;
    }
    return status;
}

/* The material at a point of the unit box, snapped. */
static void ms_gpr__box_material(const ms_gpr__box *box, const double *point, double *x)
{
    int k;
    for (k = 0; k < box->m; ++k) {
        double v = box->low[k] + box->width[k] * point[k];
        x[k] = v < box->high[k] ? v : box->high[k]; /* low + (high - low) may round up */
    }
    if (box->snap) box->snap(box->user, x);
}

/* A material as a point of the unit box; one from outside is moved to its surface. */
static void ms_gpr__box_point(const ms_gpr__box *box, const double *x, double *point)
{
    int k;
    for (k = 0; k < box->m; ++k) point[k] = ms_gpr__clamp((x[k] - box->low[k]) * box->per[k], 0, 1);
}

/* --- where candidates come from --- */

/* A box and the answers, as recommendations and galleries look at them. */
typedef struct ms_gpr__source {
    const ms_gpr *gp;
    ms_gpr__box box;
    double floor;    /* the least score */
    double top;      /* the largest score, or prediction of what was only chosen; the floor where nothing is above it */
    int liked;       /* rows above the floor */
    double *parents; /* [n] how likely each row is to be a parent, see ms_gpr__source_breed */
    double parents_sum;
    double *point, *scaled, *covariance; /* scratch: [m], [m], [stride] */
} ms_gpr__source;

/* Its arrays, in memory that is to be released whatever is returned. */
static ms_status ms_gpr__source_make(ms_gpr__source *s, const ms_gpr *gp, const ms_gpr_space *space,
                                     ms_gpr__memory *memory, ms_error *error)
{
    int i;
    s->gp = gp;
    s->floor = s->top = ms_gpr__floor_of(gp);
    for (i = 0; i < gp->n; ++i) {
        s->liked += gp->value[i] > s->floor;
        s->top = fmax(s->top, gp->value[i]);
    }
    ms_gpr__take_each(memory, gp->stride, 2, &s->parents, &s->covariance);
    ms_gpr__take_each(memory, (size_t)gp->m, 2, &s->point, &s->scaled);
    return ms_gpr__box_make(gp->view.x, gp->n, gp->m, space, memory, &s->box, error);
}

/* How likely each material is to be a parent of variants: its score above the floor, shared with those liked ones that
   the model takes for near, so that small classes have children too. */
static void ms_gpr__source_breed(ms_gpr__source *s)
{
    const ms_gpr *gp = s->gp;
    int i, j;
    s->parents_sum = 0;
    for (i = 0; i < gp->n; ++i) {
        double crowd = 0;
        if (!(gp->value[i] > s->floor)) continue;
        ms_gpr__covariances(gp, gp->view.x + (size_t)i * (size_t)gp->m, s->scaled, s->covariance);
        for (j = 0; j < gp->n; ++j) crowd += gp->value[j] > s->floor ? s->covariance[j] : 0;
        s->parents[i] = (gp->value[i] - s->floor) / crowd;
        s->parents_sum += s->parents[i];
    }
}

static int ms_gpr__source_parent(const ms_gpr__source *s, ms_gpr__random *random)
{
    double left = s->parents_sum * ms_gpr__uniform(random);
    int parent = 0, i;
    for (i = 0; i < s->gp->n; ++i) {
        if (!(s->parents[i] > 0)) continue;
        parent = i;
        if ((left -= s->parents[i]) < 0) break;
    }
    return parent;
}

/* A uniform point becomes a variant: what parameters are not drawn anew come from a parent, or from two. share: of the
   parameters that are drawn anew; one at least is. */
static void ms_gpr__source_vary(const ms_gpr__source *s, double share, ms_gpr__random *random, double *point)
{
    const int m = s->gp->m, crossed = ms_gpr__uniform(random) < 0.5;
    int anew = (int)(ms_gpr__uniform(random) * m), parent[2], k;
    for (k = 0; k < m && !(s->box.width[anew] > 0); ++k) anew = (anew + 1) % m;
    parent[0] = ms_gpr__source_parent(s, random);
    parent[1] = ms_gpr__source_parent(s, random);
    for (k = 0; k < m; ++k) {
        const int from = parent[crossed && ms_gpr__uniform(random) < 0.5];
        if (ms_gpr__uniform(random) < share || k == anew) continue;
        point[k] = (s->gp->view.x[(size_t)from * (size_t)m + (size_t)k] - s->box.low[k]) * s->box.per[k];
        point[k] = ms_gpr__clamp(point[k], 0, 1);
    }
}

/* Candidates x [count][m]: uniform ones, of which every `variants`-th (0: none) becomes a variant if anything is liked;
   `least` to least + range of its parameters are drawn anew. */
static void ms_gpr__source_fill(ms_gpr__source *s, int variants, double least, double range, ms_gpr__random *random,
                                int count, double *x)
{
    const size_t m = (size_t)s->gp->m;
    size_t k;
    int i;
    for (i = 0; i < count; ++i) {
        for (k = 0; k < m; ++k) s->point[k] = ms_gpr__uniform(random);
        if (variants > 0 && (i + 1) % variants == 0 && s->parents_sum > 0)
            ms_gpr__source_vary(s, least + range * ms_gpr__uniform(random), random, s->point);
        ms_gpr__box_material(&s->box, s->point, x + (size_t)i * m);
    }
}

/* --- recommendations --- */

enum {
    MS_GPR__PILOT = 4096,   /* uniform candidates that are looked at first */
    MS_GPR__WAVE = 64,      /* chains that run together, or variants of a round */
    MS_GPR__TASKS = 16,     /* that share the chains of a wave */
    MS_GPR__SEEDS = 1024,   /* places where chains start, at most */
    MS_GPR__SEEDS_FEW = 16, /* uniform ones, below which answered materials and the best one are starts as well */
    MS_GPR__CLIMB = 5,      /* steps along every axis of the climb to the largest mean */
    MS_GPR__BEST_OF = 10    /* variants of which the one with the largest mean is taken */
};
static const double MS_GPR__AVOID = 0.15; /* see ms_gpr_recommend_options */
static const double MS_GPR__REACH = 3.0;  /* length scales that a slice is long, at most */
static const int MS_GPR__REFUSED = 20000; /* candidates in a row that were known or to be avoided, at most */
/* Mean sigma of recommendations over (best - floor) from which on variants are recommended in their place. Below it,
   true scores of 57 persons were at least what was predicted; from here on they fell short, by half at 0.16. */
static const double MS_GPR__DOUBT = 0.1;

typedef struct ms_gpr__chain {
    double *point;    /* [m] in the unit box; with a snap, anywhere in it */
    double *material; /* [m] the allowed material there, of which the mean is taken */
    double *scaled;   /* [m] it in length scales, by column in use */
    double *d2;       /* [stride] its squared distances from the training points, less `shift`; with a snap scratch */
    double shift;
    double level; /* least mean of a place to move to */
    int climbs;   /* the level rises to the mean of every such place */
    ms_gpr__random random;
} ms_gpr__chain;

typedef struct ms_gpr__sampler {
    ms_gpr__source source;
    ms_gpr_recommend_options o; /* with the defaults filled in */
    int count, taken;           /* wanted; found, all different */
    double *x;                  /* [count][m] */
    int *place;                 /* [2 count + 1] a hash table of their rows, from 1; 0: nothing is there */
    double least;               /* of their means */
    int refused, avoided;   /* candidates in a row that were equal to one of x, or to be avoided; the latter alone */
    double threshold;       /* what recommendations reach */
    double *candidate;      /* [PILOT + n + 1][m] in units of x */
    double *mean;           /* [PILOT + n + 1] */
    ms_gpr__ranked *ranked; /* [WAVE BEST_OF] */
    double *seed;           /* [SEEDS][m] where chains start, in the unit box */
    int seeds;
    int *axis, *use, axes; /* [m] columns that slices go along; which of those in use each is */
    uint64_t first;        /* number of the wave's first chain */
    ms_gpr__chain chain[MS_GPR__TASKS];
    ms_gpr_recommend_report report;
} ms_gpr__sampler;

/* Whether x is nearer than MS_GPR__AVOID to one of `count` rows. */
static int ms_gpr__avoided(const ms_gpr__box *box, const double *rows, int count, const double *x)
{
    int i, k;
    for (i = 0; i < count; ++i, rows += box->m) {
        double sum = 0;
        for (k = 0; k < box->m; ++k) sum += (rows[k] - x[k]) * box->per[k] * (rows[k] - x[k]) * box->per[k];
        if (sum < MS_GPR__AVOID * MS_GPR__AVOID * box->m) return 1;
    }
    return 0;
}

/* The next candidate of the sequence, and its mean. */
static void ms_gpr__sampler_accept(ms_gpr__sampler *h, const double *x, double mean)
{
    const size_t m = (size_t)h->source.gp->m, places = 2 * (size_t)h->count + 1;
    const int avoid = ms_gpr__avoided(&h->source.box, h->o.avoid, h->o.avoid_count, x);
    uint64_t key = 0, bits;
    int known = avoid;
    size_t at, k;
    if (h->taken == h->count) return;
    for (k = 0; k < m; key = ms_gpr__mix(key + bits), ++k) memcpy(&bits, x + k, sizeof bits);
    for (at = (size_t)(key % places); h->place[at] && !known; at = (at + 1) % places)
        known = memcmp(h->x + (size_t)(h->place[at] - 1) * m, x, m * sizeof *x) == 0;
    h->refused = known ? h->refused + 1 : 0;
    h->avoided = known ? h->avoided + avoid : 0;
    if (known) return;
    memcpy(h->x + (size_t)h->taken * m, x, m * sizeof *x);
    h->place[at] = ++h->taken;
    h->least = fmin(h->least, mean);
}

/* --- chains: slice sampling (Neal 2003) --- */

static void ms_gpr__chain_start(const ms_gpr__sampler *h, ms_gpr__chain *c, uint64_t index)
{
    const ms_gpr *gp = h->source.gp;
    const double turns = (double)index * 0.61803398874989485; /* any run of these is spread evenly */
    const size_t m = (size_t)gp->m, seed = (size_t)((turns - floor(turns)) * h->seeds);
    size_t k;
    c->random = ms_gpr__random_make(h->o.seed, ((uint64_t)1 << 41) + index);
    c->level = h->threshold;
    c->climbs = 0;
    memcpy(c->point, h->seed + seed * m, m * sizeof *c->point);
    for (k = 0; k < m && h->source.box.snap == NULL; ++k) /* a snap may tie dropped columns to others */
        if (!(gp->view.theta[k] < MS_GPR__DROPPED)) c->point[k] = ms_gpr__uniform(&c->random);
    ms_gpr__box_material(&h->source.box, c->point, c->material);
    ms_gpr__scale(gp, c->material, c->scaled, 1);
    gp->kernels->distances(c->d2, gp->points, gp->stride, c->scaled, 1, gp->active, ms_gpr__padded(gp->n));
    c->shift = 0;
}

/* Moves to place `to` on an axis if the mean there reaches the level. Where a coordinate s, in length scales, moves by
   d, the squared distance from training point p grows by d (2 s + d) - 2 d p. */
static int ms_gpr__chain_try(const ms_gpr__sampler *h, ms_gpr__chain *c, int axis, double to)
{
    const ms_gpr *gp = h->source.gp;
    const ms_gpr__box *box = &h->source.box;
    const int n = ms_gpr__padded(gp->n), column = h->axis[axis], use = h->use[axis];
    const double from = c->point[column], *points = gp->points + (size_t)use * gp->stride;
    const double d = (to - from) * box->width[column] * gp->scale[column];
    const double ahead = c->shift + d * (2 * c->scaled[use] + d);
    double mean = gp->view.mean;
    c->point[column] = to;
    if (box->snap == NULL) {
        mean += ms_gpr__sf2(gp) * gp->kernels->line_mean(c->d2, points, -2 * d, ahead, gp->alpha, n);
    } else {
        ms_gpr__box_material(box, c->point, c->material);
        ms_gpr__covariances(gp, c->material, c->scaled, c->d2);
        mean += gp->kernels->dot(c->d2, gp->alpha, n);
    }
    if (!(mean >= c->level)) {
        c->point[column] = from;
        return 0;
    }
    if (c->climbs) c->level = mean;
    if (box->snap) return 1;
    c->scaled[use] += d;
    c->shift = ahead;
    gp->kernels->axpy(c->d2, -2 * d, points, n);
    return 1;
}

/* A uniform place of an interval around the chain along an axis, of a random position and at most REACH length scales
   long. While it lies outside the region, the interval shrinks towards the chain. */
static void ms_gpr__chain_slice(const ms_gpr__sampler *h, ms_gpr__chain *c, int axis)
{
    const int column = h->axis[axis];
    const double at = c->point[column];
    const double reach = MS_GPR__REACH * fmin(1 / (h->source.box.width[column] * h->source.gp->scale[column]), 0.3);
    double low = at - reach * ms_gpr__uniform(&c->random), high = low + reach;
    int tries;
    low = fmax(low, 0);
    high = fmin(high, 1);
    for (tries = 0; tries < 60; ++tries) {
        double to = low + ms_gpr__uniform(&c->random) * (high - low);
        if (ms_gpr__chain_try(h, c, axis, to)) return;
        if (to < at) low = to;
        else high = to;
    }
}

/* Task: candidates task, task + TASKS, ... of a wave: from a seed through a step along every axis, which forget where
   they started. */
static void ms_gpr__chain_run(void *context, int task)
{
    ms_gpr__sampler *h = (ms_gpr__sampler *)context;
    ms_gpr__chain *c = &h->chain[task];
    int i, j;
    for (i = task; i < MS_GPR__WAVE; i += MS_GPR__TASKS) {
        ms_gpr__chain_start(h, c, h->first + (uint64_t)i);
        for (j = 0; j < h->axes; ++j) ms_gpr__chain_slice(h, c, j);
        ms_gpr__box_material(&h->source.box, c->point, h->candidate + (size_t)i * (size_t)h->source.gp->m);
    }
}

/* Moves x [m] near a maximum of the mean: by a chain whose threshold is always the mean where it is. */
static void ms_gpr__chain_climb(ms_gpr__sampler *h, double *x)
{
    ms_gpr__chain *c = &h->chain[0];
    int j;
    ms_gpr__box_point(&h->source.box, x, h->seed);
    h->seeds = 1;
    ms_gpr__chain_start(h, c, 0);
    c->climbs = 1;
    c->level = -HUGE_VAL;
    for (j = 0; j < MS_GPR__CLIMB * h->axes; ++j) ms_gpr__chain_slice(h, c, j % h->axes);
    ms_gpr__box_material(&h->source.box, c->point, x);
    h->seeds = 0;
}

/* The first candidates, the threshold, and the seeds: there are some if anything is predicted above the floor. */
static ms_status ms_gpr__sampler_begin(ms_gpr__sampler *h, ms_error *error)
{
    ms_gpr__source *s = &h->source;
    const ms_gpr *gp = s->gp;
    ms_gpr__random random = ms_gpr__random_make(h->o.seed, 0);
    double best = -HUGE_VAL, top;
    size_t m = (size_t)gp->m;
    int count = MS_GPR__PILOT + gp->n, hits = 0, top_row = 0, i;
    ms_status status;

    /* uniform candidates, and the materials that were answered, moved into the box */
    ms_gpr__source_fill(s, 0, 0, 0, &random, MS_GPR__PILOT, h->candidate);
    for (i = 0; i < gp->n; ++i) {
        ms_gpr__box_point(&s->box, gp->view.x + (size_t)i * m, s->point);
        ms_gpr__box_material(&s->box, s->point, h->candidate + (size_t)(MS_GPR__PILOT + i) * m);
    }
    status = ms_gpr_predict(gp, h->candidate, count, h->mean, NULL, error);
    if (status != MS_OK) return status;

    /* the largest mean: a climb from the best of them, which is one more candidate */
    for (i = 0; i < count; ++i)
        if (h->mean[i] > best) best = h->mean[i], top_row = i;
    memcpy(h->candidate + (size_t)count * m, h->candidate + (size_t)top_row * m, m * sizeof *h->candidate);
    ms_gpr__chain_climb(h, h->candidate + (size_t)count * m);
    status = ms_gpr_predict(gp, h->candidate + (size_t)count * m, 1, h->mean + count, NULL, error);
    if (status != MS_OK) return status;
    best = fmax(best, h->mean[count++]);
    top = fmin(s->top, best);
    h->report.liked = s->liked;
    h->report.best = best;
    h->report.search = MS_GPR_SEARCH_THRESHOLD;
    if (!(top > s->floor)) return MS_OK;
    h->threshold = fmin(s->floor + h->o.tau * (top - s->floor), best - 1e-6 * (best - s->floor));
    h->report.threshold = h->threshold;

    /* chains start from those that reach it: uniform ones, and where these are few all others as well */
    for (i = 0; i < count; ++i) {
        if (h->mean[i] < h->threshold || (i >= MS_GPR__PILOT && hits >= MS_GPR__SEEDS_FEW)) continue;
        hits += i < MS_GPR__PILOT;
        if (h->seeds == MS_GPR__SEEDS) continue;
        ms_gpr__box_point(&s->box, h->candidate + (size_t)i * m, h->seed + (size_t)h->seeds++ * m);
    }
    h->report.acceptance = (double)hits / (int)MS_GPR__PILOT;
    return MS_OK;
}

/* Chains. The search ends with the first wave where that is too uncertain. */
static ms_status ms_gpr__sampler_chains(ms_gpr__sampler *h, ms_error *error)
{
    const size_t m = (size_t)h->source.gp->m;
    const double range = (h->threshold - h->source.floor) / h->o.tau;
    double doubt = 0, variance[MS_GPR__WAVE];
    ms_status status = MS_OK;
    int i;
    for (; status == MS_OK && h->taken < h->count; h->first += MS_GPR__WAVE) {
        if ((double)h->first / 40 > (double)h->count + (int)MS_GPR__WAVE) return MS_NOT_CONVERGED;
        ms__run(&h->source.gp->o.parallel, MS_GPR__TASKS, ms_gpr__chain_run, h);
        if (h->first == 0 && h->o.search == MS_GPR_SEARCH_AUTO) {
            status = ms_gpr_predict(h->source.gp, h->candidate, MS_GPR__WAVE, NULL, variance, error);
            for (i = 0; i < MS_GPR__WAVE && status == MS_OK; ++i)
                doubt += sqrt(variance[i]) / ((int)MS_GPR__WAVE * range);
            if (status != MS_OK || doubt > MS_GPR__DOUBT) return status;
        }
        status = ms_gpr_predict(h->source.gp, h->candidate, MS_GPR__WAVE, h->mean, NULL, error);
        for (i = 0; i < MS_GPR__WAVE && status == MS_OK; ++i) /* but for rounding along a chain */
            if (h->mean[i] >= h->threshold) ms_gpr__sampler_accept(h, h->candidate + (size_t)i * m, h->mean[i]);
        if (h->refused > MS_GPR__REFUSED && status == MS_OK) return MS_NOT_CONVERGED;
    }
    return status;
}

/* Variants of what was liked, or uniform candidates where nothing was: the best tenth of each round, and what follows
   it until one is new where all of them were refused. */
static ms_status ms_gpr__sampler_variants(ms_gpr__sampler *h, ms_error *error)
{
    const int size = MS_GPR__WAVE * MS_GPR__BEST_OF;
    const size_t m = (size_t)h->source.gp->m;
    ms_status status = MS_OK;
    uint64_t round;
    int i;
    h->report.search = MS_GPR_SEARCH_VARIANTS;
    ms_gpr__source_breed(&h->source);
    for (round = 0; status == MS_OK && h->taken < h->count; ++round) {
        ms_gpr__random random = ms_gpr__random_make(h->o.seed, ((uint64_t)1 << 42) + round);
        ms_gpr__source_fill(&h->source, 1, 0, 0.3, &random, size, h->candidate);
        status = ms_gpr_predict(h->source.gp, h->candidate, size, h->mean, NULL, error);
        if (status != MS_OK) return status;
        ms_gpr__rank(h->ranked, h->mean, size, 1);
        for (i = 0; i < MS_GPR__WAVE || (i < size && h->refused >= MS_GPR__WAVE); ++i)
            ms_gpr__sampler_accept(h, h->candidate + (size_t)h->ranked[i].index * m, h->ranked[i].value);
        if (h->refused > MS_GPR__REFUSED) return MS_NOT_CONVERGED;
    }
    return status;
}

/* The arrays, and what chains move along: columns with a width; those left out where a snap may tie them to others. */
static ms_status ms_gpr__sampler_make(ms_gpr__sampler *h, ms_gpr__memory *memory, ms_error *error)
{
    const ms_gpr *gp = h->source.gp;
    const size_t m = (size_t)gp->m, candidates = (size_t)MS_GPR__PILOT + (size_t)gp->n + 1;
    ms_status status;
    int use = 0, i, k;
    h->candidate = ms_gpr__take(memory, candidates, m);
    h->mean = ms_gpr__take(memory, candidates, 1);
    h->ranked = (ms_gpr__ranked *)ms_gpr__take_bytes(memory, MS_GPR__WAVE * MS_GPR__BEST_OF, sizeof *h->ranked);
    h->seed = ms_gpr__take(memory, MS_GPR__SEEDS, m);
    h->axis = (int *)ms_gpr__take_bytes(memory, 2 * m, sizeof(int));
    h->use = h->axis + m;
    h->place = (int *)ms_gpr__take_bytes(memory, 2 * (size_t)h->count + 1, sizeof(int));
    for (i = 0; i < MS_GPR__TASKS; ++i) {
        ms_gpr__chain *c = &h->chain[i];
        ms_gpr__take_each(memory, m, 3, &c->point, &c->material, &c->scaled);
        c->d2 = ms_gpr__take(memory, gp->stride, 1);
    }
    status = ms_gpr__taken(memory, "a search", error);
    for (k = 0; k < gp->m && status == MS_OK; ++k) {
        const int used = gp->view.theta[k] < MS_GPR__DROPPED;
        if (h->source.box.width[k] > 0 && (used || h->source.box.snap)) {
            h->use[h->axes] = use;
            h->axis[h->axes++] = k;
        }
        use += used;
    }
    return status;
}

static ms_status ms_gpr__sampler_run(ms_gpr__sampler *h, ms_error *error)
{
    const char *reason = "";
    ms_status status = ms_gpr__sampler_begin(h, error);
    if (status == MS_OK && h->seeds > 0 && h->o.search != MS_GPR_SEARCH_VARIANTS)
        status = ms_gpr__sampler_chains(h, error);
    if (status == MS_OK && h->taken < h->count) status = ms_gpr__sampler_variants(h, error);
    if (h->report.search == MS_GPR_SEARCH_VARIANTS && h->taken > 0) h->report.threshold = h->least;
    h->report.found = h->taken;
    if (status != MS_NOT_CONVERGED) return status;
    if (h->refused > 0) reason = ": there are no other materials";
    if (h->refused > 0 && h->report.search == MS_GPR_SEARCH_THRESHOLD)
        reason = ": there are no other materials that reach the threshold";
    if (h->avoided > 0) reason = ": the others are too near to one to avoid";
    return ms__fail(error, status, 0, "gave up after %d of %d recommendations%s", h->taken, h->count, reason);
}

MS_API ms_status ms_gpr_recommend(const ms_gpr *gp, const ms_gpr_recommend_options *options, int count, double *x,
                                  double *mean, double *sigma, ms_gpr_recommend_report *report, ms_error *error)
{
    ms_gpr__sampler sampler, *h = &sampler;
    ms_gpr_recommend_options *o;
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_status status, predicted;
    int i;
    if (gp == NULL || x == NULL) return ms_gpr__null(gp ? "x" : "gp", error);
    memset(h, 0, sizeof *h);
    if (options) h->o = *options;
    o = &h->o;
    status = ms_gpr__check_range("count", count, 1, 0x7fffffff / 16, error);
    if (status == MS_OK) status = ms_gpr__check_range("tau", o->tau, 0, 1, error);
    if (status == MS_OK) status = ms_gpr__check_range("avoid_count", o->avoid_count, 0, MS_GPR__INT_MAX, error);
    if (status == MS_OK) status = ms_gpr__check_range("search", (int)o->search, 0, (int)MS_GPR_SEARCH_VARIANTS, error);
    if (status == MS_OK && o->avoid_count > 0 && o->avoid == NULL) status = ms_gpr__null("avoid", error);
    if (status == MS_OK)
        status = ms_gpr__check_rows(o->avoid, o->avoid_count, gp->m, MS_GPR__LARGEST, "material to avoid", error);
    if (status != MS_OK) return status;
    if (!(o->tau > 0)) o->tau = 0.6;
    h->count = count;
    h->x = x;
    h->least = HUGE_VAL;
    memory.allocator = gp->o.allocator;
    status = ms_gpr__source_make(&h->source, gp, &h->o.space, &memory, error);
    if (status == MS_OK) status = ms_gpr__sampler_make(h, &memory, error);
    if (status == MS_OK) {
        status = ms_gpr__sampler_run(h, error);
        if (report && status != MS_OUT_OF_MEMORY) *report = h->report;
    }
    if (h->taken > 0 && (mean || sigma)) {
        predicted = ms_gpr_predict(gp, x, h->taken, mean, sigma, error);
        for (i = 0; i < h->taken && sigma && predicted == MS_OK; ++i) sigma[i] = sqrt(sigma[i]);
        if (predicted != MS_OK) status = predicted;
    }
    ms_gpr__release(&memory);
    return status;
}

/* --- galleries --- */

enum { MS_GPR__CANDIDATES = 1024 }; /* that a gallery is chosen from, at least; 10 for each choice. 4000 gain nothing */

/* A pool of candidates and what is known about them, given the scores and the choices so far. */
typedef struct ms_gpr__pool {
    ms_gpr__source source;
    double threshold; /* of recommendations */
    int size, count;  /* candidates, a multiple of CHUNK; choices */
    double *x;        /* [size][m] */
    double *points;   /* [active][size] in length scales, as gp->points */
    double *mean;     /* [size] */
    double *variance; /* [size] */
    double *columns;  /* [padded n + count][size] U'^-1 k(training, pool); then for each choice the posterior
                         covariance with it, less what earlier ones explain, over its deviation */
    char *taken;      /* [size] 1: chosen, or equal to one that was */
} ms_gpr__pool;

static void ms_gpr__pool_chunk(void *context, int chunk)
{
    ms_gpr__pool *p = (ms_gpr__pool *)context;
    const size_t first = (size_t)chunk * MS_GPR__CHUNK;
    ms_gpr__chunk(p->source.gp, p->points + first, p->columns + first, (size_t)p->size, p->mean + first,
                  p->variance + first);
}

/* Choice number q: of the candidates that are left the one of the largest 1.96 sigma - |mean - threshold| ("straddle");
   where the model has choices, of P(score > floor) sigma in turns with it. By the former alone, after five galleries of
   picks, the divergence of persons who like one class was larger. If all are taken, one of them. */
static int ms_gpr__pool_best(const ms_gpr__pool *p, int q)
{
    const int straddle = p->source.gp->view.choices.count == 0 || q % 2 == 0;
    double largest = -HUGE_VAL;
    int best = q % p->size, j;
    for (j = 0; j < p->size; ++j) {
        double sigma = sqrt(p->variance[j]), below = (p->source.floor - p->mean[j]) / fmax(sigma, 1e-300);
        double worth = 1.96 * sigma - fabs(p->mean[j] - p->threshold);
        if (!straddle) worth = 0.5 * erfc(below / sqrt(2.0)) * sigma;
        if (!p->taken[j] && worth > largest) largest = worth, best = j;
    }
    return best;
}

/* Choice number q, candidate j, counts as seen: b = cov(j, pool) / sqrt(var_j + sn^2), variance -= b^2. */
static void ms_gpr__pool_choose(ms_gpr__pool *p, int q, int j)
{
    const ms_gpr *gp = p->source.gp;
    const size_t size = (size_t)p->size;
    const int before = ms_gpr__padded(gp->n) + q;
    double *b = p->columns + (size_t)before * size, sf2 = ms_gpr__sf2(gp), scale;
    int i;
    gp->kernels->distances(b, p->points, size, p->points + j, size, gp->active, p->size);
    gp->kernels->exponentials(b, p->size, sf2);
    for (i = 0; i < before; ++i) {
        const double *v = p->columns + (size_t)i * size;
        gp->kernels->axpy(b, -v[j], v, p->size);
    }
    scale = 1 / sqrt(p->variance[j] + ms_gpr__sn2(gp) + 1e-12 * sf2);
    for (i = 0; i < p->size; ++i) {
        b[i] *= scale;
        p->variance[i] = fmax(p->variance[i] - b[i] * b[i], 0);
    }
}

/* All candidates that equal x [m] are taken. */
static void ms_gpr__pool_take(ms_gpr__pool *p, const double *x)
{
    size_t m = (size_t)p->source.gp->m;
    int j;
    for (j = 0; j < p->size; ++j)
        if (memcmp(p->x + (size_t)j * m, x, m * sizeof *x) == 0) p->taken[j] = 1;
}

/* The candidates, then one choice after the other. With a snap, what was asked before is not asked again while there is
   something else. */
static void ms_gpr__pool_run(ms_gpr__pool *p, uint64_t seed, double *x)
{
    const ms_gpr *gp = p->source.gp;
    const size_t m = (size_t)gp->m;
    ms_gpr__random random = ms_gpr__random_make(seed, (uint64_t)gp->n);
    int best, q;
    ms_gpr__source_breed(&p->source);
    ms_gpr__source_fill(&p->source, 2, 0.1, 0.5, &random, p->size, p->x);
    for (q = 0; q < p->size; ++q) ms_gpr__scale(gp, p->x + (size_t)q * m, p->points + q, (size_t)p->size);
    ms__run(&gp->o.parallel, p->size / MS_GPR__CHUNK, ms_gpr__pool_chunk, p);
    for (q = 0; q < gp->n && p->source.box.snap; ++q) ms_gpr__pool_take(p, gp->view.x + (size_t)q * m);
    for (q = 0; q < p->count; ++q) {
        best = ms_gpr__pool_best(p, q);
        memcpy(x + (size_t)q * m, p->x + (size_t)best * m, m * sizeof *x);
        ms_gpr__pool_take(p, x + (size_t)q * m);
        ms_gpr__pool_choose(p, q, best);
    }
}

MS_API ms_status ms_gpr_gallery(const ms_gpr *gp, const ms_gpr_gallery_options *options, int count, double *x,
                                ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr_gallery_options o;
    ms_gpr__pool pool, *p = &pool;
    ms_status status;
    size_t size;
    memset(p, 0, sizeof *p);
    memset(&o, 0, sizeof o);
    if (options != NULL) o = *options;
    if (gp == NULL || x == NULL) return ms_gpr__null(gp ? "x" : "gp", error);
    status = ms_gpr__check_range("count", count, 1, 1e6, error);
    if (status != MS_OK) return status;
    memory.allocator = gp->o.allocator;
    status = ms_gpr__source_make(&p->source, gp, &o.space, &memory, error);
    p->count = count;
    p->threshold = p->source.floor + 0.6 * (p->source.top - p->source.floor);
    p->size = 10 * count > MS_GPR__CANDIDATES ? 10 * count : (int)MS_GPR__CANDIDATES;
    p->size = (p->size + MS_GPR__CHUNK - 1) / MS_GPR__CHUNK * MS_GPR__CHUNK;
    size = (size_t)p->size;
    ms_gpr__take_each(&memory, ms__size_mul(size, (size_t)gp->m), 2, &p->x, &p->points);
    ms_gpr__take_each(&memory, size, 2, &p->mean, &p->variance);
    p->columns = ms_gpr__take(&memory, size, (size_t)ms_gpr__padded(gp->n) + (size_t)count);
    p->taken = (char *)ms_gpr__take_bytes(&memory, size, 1);
    if (status == MS_OK) status = ms_gpr__taken(&memory, "a gallery", error);
    if (status == MS_OK) ms_gpr__pool_run(p, o.seed, x);
    ms_gpr__release(&memory);
    return status;
}

/* ---- plane ----------------------------------------------------------------------------------------------------- */

enum {
    MS_GPR__LATENT_STARTS = 3,
    MS_GPR__LATENT_LIMIT = 2000, /* evaluations of the likelihood from the best start, at most */
    MS_GPR__LATENT_TRIAL = 100   /* evaluations of every start of a fit */
};

struct ms_gpr_latent {
    int z, m;
    ms_gpr *gp; /* of the latents, lengths 1: their kernel. Its scores mean nothing */
    size_t stride;
    ms_gpr__memory memory; /* the plane itself, and what follows */
    double *center;        /* [m] subtracted from the materials */
    double *x;             /* [m][stride] materials less center, by dimension, padded with zeros */
    double *weight;        /* [m][stride] K'^-1 x */
    int constrained;       /* materials satisfy the box */
    ms_gpr__box box;
};

/* A fit: what one evaluation of the likelihood needs. The variables are [log sf, log sn, points by dimension]. */
typedef struct ms_gpr__embedding {
    const ms_gpr_latent *plane;
    ms_gpr__problem problem;
    double *q; /* [starts][2 z + 2] */
    double *low, *high;
    double *work; /* of the minimizer */
    double prior;
    int evaluations;
} ms_gpr__embedding;

/* Minus log p(X | L, theta) = -1/2 tr(K'^-1 X X') - m/2 log |K'| - z m/2 log 2 pi (3.8) less the prior of the latents,
   by number of data, and its gradient. The materials are m independent columns, so dlogp/dK' = (A A' - m K'^-1) / 2,
   A = K'^-1 X, which is left in the plane's weights. 0 where K' is not positive definite. */
static int ms_gpr__latent_objective(void *context, const double *q, double *value, double *gradient)
{
    ms_gpr__embedding *e = (ms_gpr__embedding *)context;
    ms_gpr__problem *p = &e->problem;
    const ms_gpr__kernels *f = p->kernels;
    const int z = p->n, m = e->plane->m, padded = ms_gpr__padded(z);
    const double sf2 = exp(2 * q[0]), noise = exp(2 * q[1]), data = (double)z * m;
    double *weight = e->plane->weight, likelihood, penalty = 0;
    int i, j, k;
    ++e->evaluations;
    for (k = 0; k < 2; ++k) memcpy(p->points + (size_t)k * p->stride, q + 2 + k * z, (size_t)z * sizeof *q);
    ms_gpr__covariance(f, p->points, p->stride, z, 2, sf2, p->kernel);
    if (!ms_gpr__factor(f, p->kernel, p->stride, z, sf2, noise, p->upper)) return 0;
    likelihood = -0.5 * m * (ms_gpr__log_determinant(p->upper, p->stride, z) + z * MS_GPR__LOG_2_PI);
    memcpy(weight, e->plane->x, (size_t)m * p->stride * sizeof *weight);
    for (k = 0; k < m; ++k) {
        double *column = weight + (size_t)k * p->stride;
        ms_gpr__solve(f, p->upper, p->stride, padded, column);
        likelihood -= 0.5 * f->dot(column, e->plane->x + (size_t)k * p->stride, padded);
    }

    /* upper = m K'^-1 - A A'; dK/dlog sf = 2 K, dK_ij/dp_ik = -K_ij (p_ik - p_jk), each pair twice */
    ms_gpr__minus_inverse(p, p->upper, padded);
    for (i = 0; i < z; ++i)
        for (j = i; j < z; ++j) p->upper[(size_t)i * p->stride + (size_t)j] *= -m;
    f->reduce(p->upper, p->stride, weight, p->stride, weight, p->stride, padded, padded, m, MS_GPR__UPPER);
    memset(gradient, 0, (2 + 2 * (size_t)z) * sizeof *gradient);
    for (i = 0; i < z; ++i) {
        const double *w = p->upper + (size_t)i * p->stride, *kernel = p->kernel + (size_t)i * p->stride;
        gradient[0] += sf2 * w[i];
        gradient[1] += noise * w[i];
        for (j = i + 1; j < z; ++j) {
            gradient[0] += 2 * w[j] * kernel[j];
            for (k = 0; k < 2; ++k) {
                const double *point = p->points + (size_t)k * p->stride;
                double pull = w[j] * kernel[j] * (point[i] - point[j]);
                gradient[2 + k * z + i] -= pull;
                gradient[2 + k * z + j] += pull;
            }
        }
    }
    for (i = 0; i < 2 + 2 * z; ++i) {
        double pull = i < 2 ? 0 : e->prior * q[i];
        penalty += 0.5 * pull * q[i];
        gradient[i] = (gradient[i] + pull) / data;
    }
    *value = (penalty - likelihood) / data;
    return 1;
}

/* The first two principal components of the materials, each of variance 1, as points [2][z]: orthogonal iteration with
   X X'. A component without variance stays 0. column: [2][stride] scratch. */
static void ms_gpr__latent_components(const ms_gpr__kernels *f, const ms_gpr_latent *p, double total, double *points,
                                      double *column)
{
    ms_gpr__random random = ms_gpr__random_make(0, 0);
    const size_t stride = p->stride;
    int padded = ms_gpr__padded(p->z), pass, i, k, d;
    for (i = 0; i < 2 * p->z; ++i) points[i] = ms_gpr__uniform(&random) - 0.5;
    for (pass = 0; pass < 120; ++pass) {
        double *component = points + pass % 2 * p->z, norm2 = 0, overlap = 0, scale;
        memset(column, 0, 2 * stride * sizeof *column);
        memcpy(column + stride, component, (size_t)p->z * sizeof *column);
        for (d = 0; d < p->m; ++d) {
            const double *x = p->x + (size_t)d * stride;
            f->axpy(column, f->dot(column + stride, x, padded), x, padded);
        }
        for (i = 0; i < p->z && pass % 2 == 1; ++i) overlap += column[i] * points[i] / p->z;
        for (i = 0; i < p->z && pass % 2 == 1; ++i) column[i] -= overlap * points[i];
        for (k = 0; k < p->z; ++k) norm2 += column[k] * column[k] / p->z;
        scale = norm2 > 1e-20 * total * total ? 1 / sqrt(norm2) : 0;
        for (i = 0; i < p->z; ++i) component[i] = column[i] * scale;
    }
}

/* The variables in e->q. spread: root mean square of the materials. */
static ms_status ms_gpr__latent_search(ms_gpr__embedding *e, double spread, ms_error *error)
{
    static const double scale[MS_GPR__LATENT_STARTS] = {0.5, 0.3, 1}; /* of the principal components, in lengths */
    const int count = 2 + 2 * e->plane->z;
    ms_gpr__minimum found;
    ms_gpr__search search;
    int i, k;
    search.f = ms_gpr__latent_objective;
    search.context = e;
    search.count = count;
    search.low = e->low;
    search.high = e->high;
    search.step = 1;
    search.tolerance = 1e-9;
    search.evaluations = MS_GPR__LATENT_LIMIT;
    ms_gpr__latent_components(e->problem.kernels, e->plane, spread * spread * e->plane->z * e->plane->m, e->q + 2,
                              e->work);
    for (i = 0; i < count; ++i) {
        e->low[i] = i == 0 ? log(spread) - 5 : i == 1 ? log(1e-3 * spread) : -1e3;
        e->high[i] = 1e3;
    }
    for (k = MS_GPR__LATENT_STARTS - 1; k >= 0; --k) {
        double *q = e->q + k * count;
        for (i = 2; i < count; ++i) q[i] = scale[k] * e->q[i];
        q[0] = log(spread);
        q[1] = log(0.3 * spread);
    }
    found = ms_gpr__minimize_starts(&search, e->q, MS_GPR__LATENT_STARTS, MS_GPR__LATENT_TRIAL, e->work);
    if (found.value < HUGE_VAL) return MS_OK;
    return ms__fail(error, MS_NOT_CONVERGED, 0, "the likelihood is not defined at any start");
}

/* The plane of points [z][2] under these hyperparameters. */
static ms_status ms_gpr__latent_condition(ms_gpr_latent *p, ms_simd simd, const double *points, double log_sf,
                                          double log_sn, ms_error *error)
{
    const double theta[4] = {0, 0, log_sf, log_sn};
    const size_t size = (size_t)p->m * p->stride * sizeof(double);
    ms_gpr_options options;
    ms_gpr_view parts;
    ms_status status;
    int k;
    memset(&options, 0, sizeof options);
    memset(&parts, 0, sizeof parts);
    options.simd = simd;
    options.allocator = p->memory.allocator;
    parts.n = p->z;
    parts.m = 2;
    parts.x = points;
    parts.y = p->x; /* any numbers */
    parts.theta = theta;
    status = ms_gpr__make(&parts, &options, NULL, &p->gp, error);
    if (status != MS_OK) return status;
    memcpy(p->weight, p->x, size);
    for (k = 0; k < p->m; ++k)
        ms_gpr__solve(p->gp->kernels, p->gp->upper, p->stride, ms_gpr__padded(p->z), p->weight + (size_t)k * p->stride);
    return MS_OK;
}

static ms_status ms_gpr__embedding_make(ms_gpr__embedding *e, const ms_gpr_latent *plane, ms_simd simd,
                                        ms_gpr__memory *memory, ms_error *error)
{
    const size_t count = 2 * (size_t)plane->z + 2;
    ms_gpr_view data;
    memset(&data, 0, sizeof data);
    data.n = plane->z;
    data.y = plane->x; /* any numbers */
    e->plane = plane;
    ms_gpr__problem_make(&e->problem, ms_gpr__kernels_of(simd), &data, 2, memory);
    e->q = ms_gpr__take(memory, MS_GPR__LATENT_STARTS, count);
    ms_gpr__take_each(memory, count, 2, &e->low, &e->high);
    e->work = ms_gpr__take(memory, ms__size_add(ms_gpr__minimize_doubles((int)count), 2 * plane->stride), 1);
    return ms_gpr__taken(memory, "an embedding", error);
}

static ms_status ms_gpr__latent_make(const double *x, int z, int m, const ms_gpr_latent_options *o, ms_gpr_latent **out,
                                     ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr_latent *p;
    ms_status status;
    int i, k;
    if (x == NULL) return ms_gpr__null("x", error);
    status = ms_gpr__check_range("z", z, 2, MS_GPR__N_MAX, error);
    if (status == MS_OK) status = ms_gpr__check_range("m", m, 1, MS_GPR__INT_MAX, error);
    if (status == MS_OK) status = ms_gpr__check_rows(x, z, m, MS_GPR__LARGEST, "material", error);
    if (status != MS_OK) return status;
    memory.allocator = o->allocator;
    p = (ms_gpr_latent *)ms_gpr__take_bytes(&memory, 1, sizeof *p);
    if (p == NULL) return ms_gpr__taken(&memory, "a latent space", error);
    p->z = z;
    p->m = m;
    p->stride = ms_gpr__stride(z);
    p->memory = memory;
    p->center = ms_gpr__take(&p->memory, (size_t)m, 1);
    ms_gpr__take_each(&p->memory, ms__size_mul((size_t)m, p->stride), 2, &p->x, &p->weight);
    status = ms_gpr__taken(&p->memory, "a latent space", error);
    for (k = 0; k < m && status == MS_OK; ++k) {
        const double *column = x + k;
        for (i = 0; i < z; ++i) p->center[k] += column[(size_t)i * (size_t)m] / z;
        for (i = 0; i < z; ++i) p->x[(size_t)k * p->stride + (size_t)i] = column[(size_t)i * (size_t)m] - p->center[k];
    }
    if (status == MS_OK && (o->space.low || o->space.high || o->space.snap)) {
        status = ms_gpr__box_make(x, z, m, &o->space, &p->memory, &p->box, error);
        p->constrained = 1;
    }
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

MS_API void ms_gpr_latent_destroy(ms_gpr_latent *plane)
{
    ms_gpr__memory memory;
    if (plane == NULL) return;
    memory = plane->memory;
    ms_gpr_destroy(plane->gp);
    ms_gpr__release(&memory);
}

MS_API ms_gpr_latent_view ms_gpr_latent_view_of(const ms_gpr_latent *plane)
{
    ms_gpr_latent_view view = {0, 0, NULL, 0, 0};
    if (plane == NULL) return view;
    view.z = plane->z;
    view.m = plane->m;
    view.points = plane->gp->view.x;
    view.sf = exp(plane->gp->view.theta[2]);
    view.sn = exp(plane->gp->view.theta[3]);
    return view;
}

MS_API ms_status ms_gpr_latent_map(const ms_gpr_latent *plane, const double *latent, int count, double *x,
                                   double *variance, ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    const ms_gpr *gp;
    ms_status status;
    double *kernel, *point;
    size_t i, m;
    int k, padded;
    if (plane == NULL || latent == NULL) return ms_gpr__null(plane ? "latent" : "plane", error);
    status = ms_gpr__check_range("count", count, 0, MS_GPR__INT_MAX, error);
    if (status == MS_OK) status = ms_gpr__check_rows(latent, count, 2, MS_GPR__LARGEST, "latent", error);
    if (status != MS_OK) return status;
    gp = plane->gp;
    m = (size_t)plane->m;
    padded = ms_gpr__padded(gp->n);
    memory.allocator = plane->memory.allocator;
    kernel = ms_gpr__take(&memory, plane->stride, 1);
    point = ms_gpr__take(&memory, m + 2, 1);
    status = ms_gpr__taken(&memory, "a material", error);
    for (i = 0; i < (size_t)count && status == MS_OK; ++i) {
        double *to = x + i * m;
        ms_gpr__covariances(gp, latent + 2 * i, point, kernel);
        for (k = 0; k < plane->m && x; ++k)
            to[k] = plane->center[k] + gp->kernels->dot(kernel, plane->weight + (size_t)k * plane->stride, padded);
        if (plane->constrained && x) {
            ms_gpr__box_point(&plane->box, to, point);
            ms_gpr__box_material(&plane->box, point, to);
        }
        if (variance) { /* sf^2 - k' K'^-1 k */
            ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, kernel);
            variance[i] = fmax(ms_gpr__sf2(gp) - gp->kernels->dot(kernel, kernel, padded), 0);
        }
    }
    ms_gpr__release(&memory);
    return status;
}

MS_API ms_status ms_gpr_latent_fit(const double *x, int z, int m, const ms_gpr_latent_options *options,
                                   ms_gpr_latent **out, ms_gpr_latent_report *report, ms_error *error)
{
    ms_gpr__memory memory = {{NULL, NULL, NULL}, NULL, 0};
    ms_gpr_latent_options o;
    ms_gpr_latent *p = NULL;
    ms_gpr__embedding e;
    double spread, centers;
    size_t size;
    ms_status status;
    int i;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    memset(&o, 0, sizeof o);
    memset(&e, 0, sizeof e);
    if (options) o = *options;
    status = ms_gpr__check_range("prior", o.prior, 0, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__latent_make(x, z, m, &o, &p, error);
    if (status != MS_OK) return status;
    memory.allocator = o.allocator;
    e.prior = o.prior;
    size = (size_t)m * p->stride;
    spread = ms_gpr__product(p->x, p->x, size) / ((double)z * m);
    centers = ms_gpr__product(p->center, p->center, (size_t)m) / m;
    if (!(spread > 1e-300) || !(spread > 1e-26 * centers))
        status = ms__fail(error, MS_BAD_DATA, 0, "all %d materials are equal", z);
    if (status == MS_OK) status = ms_gpr__embedding_make(&e, p, o.simd, &memory, error);
    if (status == MS_OK) status = ms_gpr__latent_search(&e, sqrt(spread), error);
    if (status == MS_OK) {
        for (i = 0; i < 2 * z; ++i) e.work[i] = e.q[2 + i % 2 * z + i / 2];
        status = ms_gpr__latent_condition(p, o.simd, e.work, e.q[0], e.q[1], error);
    }
    if (status == MS_OK && report) {
        /* what the plane makes of its own latents, less the materials, is K'^-1 X times the noise */
        const double noise = ms_gpr__sn2(p->gp) + p->gp->view.jitter * ms_gpr__sf2(p->gp);
        const double determinant = ms_gpr__log_determinant(p->gp->upper, p->stride, z);
        report->error = noise * sqrt(ms_gpr__product(p->weight, p->weight, size) / ((double)z * m));
        report->likelihood = -0.5 * (ms_gpr__product(p->weight, p->x, size) + m * (determinant + z * MS_GPR__LOG_2_PI));
        report->evaluations = e.evaluations;
    }
    ms_gpr__release(&memory);
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

#endif /* the implementation */

/*
These headers, their tests and their examples are in two licences; take whichever you prefer.

--------------------------------------------------------------------------------
ALTERNATIVE A - MIT License

Copyright (c) 2026 the ms authors

Permission is hereby granted, free of charge, to any person obtaining a copy of
this software and associated documentation files (the "Software"), to deal in
the Software without restriction, including without limitation the rights to
use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies
of the Software, and to permit persons to whom the Software is furnished to do
so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

--------------------------------------------------------------------------------
ALTERNATIVE B - Public Domain (www.unlicense.org)

This is free and unencumbered software released into the public domain.

Anyone is free to copy, modify, publish, use, compile, sell, or distribute this
software, either in source code form or as a compiled binary, for any purpose,
commercial or non-commercial, and by any means.

In jurisdictions that recognize copyright laws, the author or authors of this
software dedicate any and all copyright interest in the software to the public
domain. We make this dedication for the benefit of the public at large and to
the detriment of our heirs and successors. We intend this dedication to be an
overt act of relinquishment in perpetuity of all present and future rights to
this software under copyright law.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN
ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION
WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
