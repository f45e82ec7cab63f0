/* ms_gpr.h - v0.2.0 - learn a material preference - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_GPR_IMPLEMENTATION
      #include "ms_gpr.h"

   A user scores a gallery of materials; a Gaussian process learns what the scores depend on; the header recommends
   thousands of new materials, says how sure it is, and lays variants out in a plane. Link with -lm. Here a user who
   likes one thing alone: the first of five parameters near 0.8.

   Example:
      #define MS_GPR_IMPLEMENTATION
      #include "ms_gpr.h"
      #include <stdio.h>
      int main(void)
      {
          enum { N = 60, M = 5, COUNT = 4 };
          double x[N * M], score[N], found[COUNT * M], mean[COUNT], sigma[COUNT];
          uint64_t state = 1;
          ms_gpr *gp;
          ms_gpr_fit_report report;
          ms_error error;
          int i;
          for (i = 0; i < N * M; ++i) {
              state = state * 6364136223846793005u + 1442695040888963407u;
              x[i] = (double)(state >> 11) / 9007199254740992.0;
          }
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
   1. ms_gpr_gallery: materials to be scored, in batches of 5 to 25; a model of n = 0 gives the first.
   2. ms_gpr_fit: learns from scores, from comparisons such as "the best 2 of 9", or from both. ms_gpr_append,
      ms_gpr_rescore, ms_gpr_drop and ms_gpr_compare change the data under the same hyperparameters.
   3. ms_gpr_predict, ms_gpr_relevance: what was learned. A model is stored as materials, scores, pairs and theta, which
      ms_gpr_create takes.
   4. ms_gpr_recommend: new materials, which satisfy a ms_gpr_space.
   5. ms_gpr_latent_fit, ms_gpr_latent_map: a plane of variants; ms_gpr_map_preference and its sisters color it;
      ms_gpr_variants finds the best.

   What it costs
   -------------
   A likelihood with its gradient takes n^3 / 2 + n^2 m multiply-adds; a fit evaluates it 20 times on all scores and 150
   times on a third of them. A mean takes n m, its variance n^2 / 2 more. 300 recommendations cost 30,000 to 150,000
   means. A model has n^2 + 3 n m doubles, a fit 4 n^2 more. Figures: tests/bench/RESULTS.md, made by `make bench`.

   Threads, SIMD, determinism, errors
   ----------------------------------
   No globals; 20 KB of stack. Const calls may overlap. ms_parallel shares out predictions, recommendations and
   galleries. Kernels are scalar, or with GCC and Clang SSE2, NEON or AVX2, chosen under the cap options.simd. One level
   of one build gives the same bits for any thread count. Levels and builds differ by rounding, which may lead a fit
   along another path to the same optimum. -ffast-math by the user voids all promises. Outputs are untouched on failure,
   but where the call says otherwise.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_DEF           linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_GPR_FILENAME  this file's name, if it is not "ms_gpr.h"
   MS_GPR_NO_PLANE  no latent space, maps and variants: a sixth of the object less
   MS_NO_SIMD       scalar text only
   MS_ASSERT        checks of the header's own invariants (nothing)

   Limits
   ------
   n up to 30000 by memory; time grows with n^3. The kernel is the squared exponential with one length a dimension:
   preferences that jump are smoothed. Values beyond 1e30, and columns and scores that span less than 1e-30, are
   refused by name.

   Sources
   -------
   K. Zsolnai-Feher, Photorealistic Material Learning and Synthesis, TU Wien 2019, chapter 3 (numbers in brackets are
   its equations, misprints corrected); Rasmussen & Williams 2006, Gaussian Processes for Machine Learning; Nocedal &
   Wright 2006, Numerical Optimization; Lawrence 2004; Neal 2003, Slice sampling; Au & Beck 2001, subset simulation.
*/
#ifndef MS_GPR_H
#define MS_GPR_H
#include <stddef.h>
#include <stdint.h>

#define MS_GPR_VERSION_MAJOR 0
#define MS_GPR_VERSION_MINOR 2
#define MS_GPR_VERSION_PATCH 0
#define MS_GPR_VERSION 200 /* major * 10000 + minor * 100 + patch */
#define MS_GPR_VERSION_STRING "0.2.0"

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

/* A Gaussian process that has seen n inputs of m dimensions and their scores. With d^2(a, b) = sum over k of
   ((a_k - b_k) / l_k)^2, scores are mean + N(0, K'), K'_ij = sf^2 exp(-d^2(x_i, x_j) / 2) + sn^2 delta_ij. */
typedef struct ms_gpr ms_gpr;

/* All zero: the defaults. */
typedef struct ms_gpr_options {
    double mean;  /* prior mean, in units of the scores */
    ms_simd simd; /* a cap */
    ms_allocator allocator;
    ms_parallel parallel; /* of predictions, recommendations and galleries; nothing else runs on threads */
} ms_gpr_options;

/* The score of a material that has none: it was only compared. */
#define MS_GPR_UNSCORED (-1e38)

/* A model whose hyperparameters are given.
   x, y   [n][m] inputs, row-major, any units; [n] scores or MS_GPR_UNSCORED; copied
   n, m   n >= 0 (0 predicts the prior), m >= 1
   theta  [m + 2]: log l_k for every dimension, 700 to leave it out, log sf, log sn; in units of x and y
   *out is NULL unless MS_OK. MS_BAD_DATA: a value that is not finite or beyond 1e30 (position: its row, from 1).
   MS_NOT_CONVERGED: K' is not positive definite even with the largest jitter (see ms_gpr_view). MS_INVALID_ARGUMENT,
   MS_OUT_OF_MEMORY. n^3 / 6 multiply-adds. */
MS_API ms_status ms_gpr_create(const double *x, const double *y, int n, int m, const double *theta,
                               const ms_gpr_options *options, ms_gpr **out, ms_error *error);

MS_API void ms_gpr_destroy(ms_gpr *gp);

/* One more scored point, x [m]; another score for point `index`; without point `index` and its comparisons, later
   points move up by one. Each conditions anew. The model is unchanged unless MS_OK. */
MS_API ms_status ms_gpr_append(ms_gpr *gp, const double *x, double y, ms_error *error);
MS_API ms_status ms_gpr_rescore(ms_gpr *gp, int index, double y, ms_error *error);
MS_API ms_status ms_gpr_drop(ms_gpr *gp, int index, ms_error *error);

/* More materials without a score, and comparisons in place of those the model has.
   x      [count][m] rows n to n + count - 1 of the model; NULL with count 0
   pairs  [pair_count][2] rows of the model, the preferred one first; copied. "The best 2 of 9" are 14 pairs
   A pair has P = Phi((f_better - f_worse) / (sqrt(2) sn)). Without scores the unit is sf. Such a model, and one of
   scores in steps, is conditioned by Laplace's approximation. MS_INVALID_ARGUMENT: a row outside the model or compared
   with itself (position: the pair, from 1). MS_BAD_DATA, MS_NOT_CONVERGED, MS_OUT_OF_MEMORY. The model is unchanged
   unless MS_OK. Chu & Ghahramani 2005, "Preference learning with Gaussian processes". */
MS_API ms_status ms_gpr_compare(ms_gpr *gp, const double *x, int count, const int *pairs, int pair_count,
                                ms_error *error);

/* How much each dimension matters, [m] out: the mean of ((a_k - b_k) / l_k)^2 over pairs of training inputs; 0 for one
   that is left out. */
MS_API void ms_gpr_relevance(const ms_gpr *gp, double *relevance);

/* What a model consists of; all zero for NULL. Pointers are valid until the model changes. */
typedef struct ms_gpr_view {
    int n, m, pair_count;
    const double *x;     /* [n][m] */
    const double *y;     /* [n] scores as they were given */
    const double *value; /* [n] the same, and predictions for rows without a score */
    const double *theta; /* [m + 2]; a dropped dimension has log l_k = 700 */
    const int *pairs;    /* [pair_count][2] */
    double mean;         /* prior mean */
    double floor;        /* the least score that can be given; see ms_gpr_fit_options */
    double floor_value;  /* what scores at the floor are modeled as */
    double jitter;       /* added to sn^2, in units of sf^2: 0 nearly always, to 1e-6 */
    ms_simd level;       /* instruction set in use */
} ms_gpr_view;

MS_API ms_gpr_view ms_gpr_view_of(const ms_gpr *gp);

/* ---- fit ------------------------------------------------------------------------------------------------------- */

typedef enum ms_gpr_method {
    MS_GPR_METHOD_MAP = 0, /* largest posterior by L-BFGS: log-normal priors, three starts, probing of all dimensions */
    MS_GPR_METHOD_ML = 1   /* largest likelihood by L-BFGS, three starts */
} ms_gpr_method;

/* All zero: the defaults. "Width" is sqrt(12) standard deviations: 1 for a column that is uniform on [0, 1]. */
typedef struct ms_gpr_fit_options {
    /* The least score that can be given, such as 1 of 5 stars. NULL: the least that was given, if two and an eighth of
       all share it; else there is none. MAP takes scores at the floor as 0.75 standard deviations below it: dislike
       has room below "barely liked". */
    const double *floor;
    ms_gpr_method method;
    const double *start; /* [m + 2] theta, the only start. NULL: sf = 1 and sn = 0.1 standard deviations, and */
    double length_start; /* l_k = so many widths, alone; 0: three starts, of 0.25, 0.5 and 3 sqrt(m) */
    int evaluations;     /* of the likelihood at most, a start; 0: 200 */
    ms_simd simd;
    ms_allocator allocator;
    ms_parallel parallel; /* kept by the model, see ms_gpr_options; the fit runs on the calling thread */
    ms_progress progress; /* asked before every evaluation */
    int probe_first;      /* MAP tries `probes` columns from this one on at another length after the search. */
    int probes;           /* 0: all. Negative: none. A tool that fits in short calls probes a few at a time */
    const int *pairs;     /* [pair_count][2] comparisons, as in ms_gpr_compare */
    int pair_count;
    /* Scores come in steps of this, such as 1 for stars: one above the floor stands for half a step to either side, at
       3 times the cost. 0: MAP finds 2 to 6 evenly spaced values among 20 to 200 scores. Negative: exact. */
    double step;
} ms_gpr_fit_options;

/* The answer that looks like a slip: a score that all others contradict, or a value far outside its column. */
typedef struct ms_gpr_outlier {
    int row;          /* of x and y; -1: none */
    int column;       /* of x; -1: the score */
    double value;     /* that was given */
    double expected;  /* prediction from the other scores; the nearest of the other values of the column */
    double deviation; /* value - expected, in standard deviations of that prediction; in ranges of the other values */
} ms_gpr_outlier;

typedef struct ms_gpr_fit_report {
    double likelihood;      /* log p(y | X, theta) of the scores as they were modeled */
    double objective;       /* the same plus the log prior of MAP */
    int evaluations;        /* of the likelihood, all starts and probes */
    int start;              /* the start that won, from 0 */
    int probes;             /* dimensions that probing switched on or off */
    int columns;            /* that differ from row to row; the others are left out */
    ms_gpr_outlier outlier; /* ask the user about it: one wrong score of 100 can spoil all recommendations */
} ms_gpr_fit_report;

/* Learns theta, and makes the model with it. The prior mean is the mean of the scores.
   x, y, n, m  as in ms_gpr_create. Columns that differ by rounding only (1e-10 of the largest) are left out. Equal
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

/* ---- search space ---------------------------------------------------------------------------------------------- */

/* Values that some parameters take together, such as a list of metals. */
typedef struct ms_gpr_list {
    const int *columns; /* [width] which parameters, from 0; none in two lists */
    int width;
    const double *rows; /* [count][width], all as likely; rows outside the box are left out */
    int count;
} ms_gpr_list;

/* Constraints that recommendations, galleries and planes satisfy. All zero: the box that the scores suggest.
   MS_INVALID_ARGUMENT where they contradict each other: an empty box, no row of a list in the box, a parameter in two
   lists or in a list and in steps, equal columns without a common range or in a list. */
typedef struct ms_gpr_space {
    /* [m] the box of allowed parameters, low = high for a fixed one. NULL, or -INFINITY and INFINITY in a column: 0 to
       1 where all scores lie there, else their range rounded outwards, the value of a locked column, a list's range. */
    const double *low, *high;
    const double *steps; /* [m] of parameters that come in steps from low on; 0: continuous. NULL: all are */
    const int *equal;    /* [equal_count][2] columns that always have equal values, on the same scale */
    int equal_count;
    const ms_gpr_list *lists;
    int list_count;
} ms_gpr_space;

/* ---- recommendation -------------------------------------------------------------------------------------------- */

typedef enum ms_gpr_search {
    MS_GPR_SEARCH_AUTO = 0,      /* whichever a first 8192 candidates show to be cheaper */
    MS_GPR_SEARCH_REJECTION = 1, /* uniform candidates that reach the threshold: independent, uniform over the region */
    MS_GPR_SEARCH_SUBSET = 2     /* subset simulation: a threshold that rises in steps, slice sampling above it */
} ms_gpr_search;

/* All zero: the defaults. */
typedef struct ms_gpr_recommend_options {
    double tau;       /* threshold = floor + tau (best - floor), 0 < tau <= 1; 0: 0.6. floor: as in ms_gpr_view */
    double best;      /* the score that tau = 1 means; 0: the largest given. At most the largest mean in the box */
    double diversity; /* 0: in proportion to the volume of what is liked. Up to 1: every recommendation is the farthest
                         from those before it of 1 + 15 diversity */
    ms_gpr_space space;
    const double *avoid; /* [avoid_count][m] "not like these": nothing nearer than avoid_distance to any of them */
    int avoid_count;
    double avoid_distance; /* root mean square over the dimensions, in widths of the box; uniform pairs are 0.4 apart.
                              0: 0.15 */
    int skip;              /* leaves out the first `skip` of the sequence that seed stands for */
    uint64_t seed;
    ms_gpr_search search;
    ms_progress progress; /* asked once every 16384 candidates, step of the threshold or 64 recommendations */
} ms_gpr_recommend_options;

typedef struct ms_gpr_recommend_report {
    ms_gpr_search search; /* what was used */
    int found;            /* rows of x that are valid */
    double threshold;     /* in units of the score */
    double best;          /* largest mean that was found over the box */
    double acceptance;    /* share of the box whose mean reaches the threshold (subset simulation: estimated) */
    double candidates;    /* means predicted at single points */
    double spread;        /* mean distance of the first 200 to the nearest of them, measured as avoid_distance */
} ms_gpr_recommend_report;

/* Materials whose predicted score reaches a threshold.
   count, x  how many, >= 1; [count][m] out
   mean      [count] out, or NULL: predicted scores
   sigma     [count] out, or NULL: their standard deviation
   report    out, or NULL
   Separate modes get shares by their volumes. By rejection these have the error of independent draws; by subset
   simulation a root mean square error of 0.05 where one material in 600 is liked, of 0.10 for one in 1e9.
   MS_NOT_CONVERGED: no score is predicted above the floor, or the search gave up; then, and with MS_CANCELLED, the
   first report->found rows are valid. MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY. Thesis 3.4.1; Au & Beck 2001, subset
   simulation; Neal 2003, slice sampling. */
MS_API ms_status ms_gpr_recommend(const ms_gpr *gp, const ms_gpr_recommend_options *options, int count, double *x,
                                  double *mean, double *sigma, ms_gpr_recommend_report *report, ms_error *error);

/* ---- active learning ------------------------------------------------------------------------------------------- */

typedef enum ms_gpr_gallery_kind {
    MS_GPR_GALLERY_ACTIVE = 0, /* spread evenly until something is liked; then, in turns, materials near the threshold
                                  of recommendations (largest 1.96 sigma - |mean - threshold of tau = 0.6|) and
                                  promising ones (largest P(score > floor) sigma) */
    MS_GPR_GALLERY_SPREAD = 1  /* uniform, each parameter evenly over its range (a Latin hypercube) */
} ms_gpr_gallery_kind;

/* All zero: the defaults. */
typedef struct ms_gpr_gallery_options {
    ms_gpr_space space;
    uint64_t seed; /* the number of scores is part of it: every round gives another gallery */
    ms_gpr_gallery_kind kind;
} ms_gpr_gallery_options;

/* Materials x [count][m], out, that the user is to score next. Half of the candidates are uniform, half variants of
   what was liked: a material drawn in proportion to its score, half of them crossed with a second one, some parameters
   drawn anew. Each choice takes those before it as scored. Where 60 answers confirm fewer than three likings, ask for
   comparisons ("the best 2 of 9") in place of scores. MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY. Thesis 3.7; Bryan and
   others 2005, "Active learning for identifying function threshold boundaries". */
MS_API ms_status ms_gpr_gallery(const ms_gpr *gp, const ms_gpr_gallery_options *options, int count, double *x,
                                ms_error *error);

#ifndef MS_GPR_NO_PLANE
/* ---- latent space ---------------------------------------------------------------------------------------------- */

/* A plane of variants: the Gaussian-process latent variable model of thesis 3.4.3 with two latent coordinates. */
typedef struct ms_gpr_latent ms_gpr_latent;

/* All zero: the defaults. */
typedef struct ms_gpr_latent_options {
    double prior;       /* precision of a normal prior on every latent coordinate; 0: none */
    ms_gpr_space space; /* materials of the plane are moved to the nearest that satisfy it. All zero: not even a box;
                           else as in recommendations, for the range of the embedded materials */
    ms_simd simd;
    ms_allocator allocator;
    ms_progress progress; /* asked every evaluation */
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
   MS_OUT_OF_MEMORY, MS_CANCELLED. Lawrence 2004, "Gaussian process latent variable models"; thesis (3.8), (3.9). */
MS_API ms_status ms_gpr_latent_fit(const double *x, int z, int m, const ms_gpr_latent_options *options,
                                   ms_gpr_latent **out, ms_gpr_latent_report *report, ms_error *error);

MS_API void ms_gpr_latent_destroy(ms_gpr_latent *plane);

/* z; views that live as long as the plane: [z][2] latents; [4] theta: two log lengths, log sf, log sn. */
MS_API int ms_gpr_latent_count(const ms_gpr_latent *plane);
MS_API const double *ms_gpr_latent_points(const ms_gpr_latent *plane);
MS_API const double *ms_gpr_latent_theta(const ms_gpr_latent *plane);

/* Materials x [count][m], out or NULL, at points latent [count][2] (3.11). variance: [count] out, or NULL: of every
   coordinate of x, without the noise; 0 <= variance <= sf^2. */
MS_API ms_status ms_gpr_latent_map(const ms_gpr_latent *plane, const double *latent, int count, double *x,
                                   double *variance, ms_error *error);

/* ---- maps ------------------------------------------------------------------------------------------------------ */

/* A grid of columns x rows points over a rectangle of the plane, its corners included. Maps are [rows][columns], from
   low to high coordinates. Calls that make one return MS_INVALID_ARGUMENT, MS_OUT_OF_MEMORY, or what render returned;
   memory is the plane's, threads are gp's. */
typedef struct ms_gpr_grid {
    double x0, y0, x1, y1;
    int columns, rows; /* 2 to 32768; x0 < x1, y0 < y1 */
} ms_gpr_grid;

/* resolution x resolution over a square, in length scales, that holds the training latents and one length scale (at
   most a quarter of their range) around. */
MS_API ms_gpr_grid ms_gpr_grid_around(const ms_gpr_latent *plane, int resolution);

/* The latent coordinates of a grid point, and bilinear interpolation of a map at a point (clamped to the rectangle). */
MS_API void ms_gpr_grid_point(const ms_gpr_grid *grid, int column, int row, double latent[2]);
MS_API double ms_gpr_grid_value(const ms_gpr_grid *grid, const double *map, double x, double y);

/* Predicted score of the material at every grid point, and its standard deviation where sigma is not NULL (n times the
   cost). gp and plane have the same m. */
MS_API ms_status ms_gpr_map_preference(const ms_gpr_latent *plane, const ms_gpr *gp, const ms_gpr_grid *grid,
                                       double *mean, double *sigma, ms_error *error);

/* How much the plane knows at every grid point: 1 - variance / sf^2, from 0 (nothing) to 1. */
MS_API ms_status ms_gpr_map_confidence(const ms_gpr_latent *plane, const ms_gpr_grid *grid, double *confidence,
                                       ms_error *error);

/* How similar two materials look: s = exp(-d^2 / (2 scale^2)), d the root mean square difference of their pictures. */
typedef struct ms_gpr_similarity {
    const double *x; /* [m] the material to be fine-tuned */
    double scale;    /* 0: 0.1, so that a PSNR of 20 dB (pictures of range 1) means s = 0.61, and 30 dB 0.95 */
    size_t pixels;   /* floats of a picture; 0: no pictures, d is between the parameters */
    ms_status (*render)(void *user, const double *x, float *picture); /* a failure ends the call with its status */
    void *user;
} ms_gpr_similarity;

/* Similarity of every grid point's material to similarity->x; render is called in order, from the calling thread. */
MS_API ms_status ms_gpr_map_similarity(const ms_gpr_latent *plane, const ms_gpr_similarity *similarity,
                                       const ms_gpr_grid *grid, double *map, ms_error *error);

/* One automatic variant. */
typedef struct ms_gpr_variant {
    double latent[2];
    double similarity; /* s */
    double score;      /* u, predicted */
    double value;      /* confidence (lambda s + (1 - lambda) (u - floor) / (best - floor)), floor: as in ms_gpr_view */
    double confidence; /* as in ms_gpr_map_confidence: where the plane knows nothing there are no variants */
} ms_gpr_variant;

/* The variants of largest value (ms_gpr_variant) over the plane, for several lambda (thesis 3.7).
   lambda   [count], each in [0, 1]: 1 asks for the most similar material, 0 for the best
   best     the score that counts as 1; the floor or less: the largest on the grid
   variant  [count] out
   x        [count][m] out, or NULL: their materials
   Pattern searches from the best points of the grid go to 1/64 of a cell. All lambdas share what was looked at: more
   lambda never means less similarity times confidence. */
MS_API ms_status ms_gpr_variants(const ms_gpr_latent *plane, const ms_gpr *gp, const ms_gpr_similarity *similarity,
                                 const ms_gpr_grid *grid, const double *lambda, int count, double best,
                                 ms_gpr_variant *variant, double *x, ms_error *error);
#endif /* MS_GPR_NO_PLANE */

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

/* ms-common-random begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_RANDOM
#define MS_COMMON_RANDOM

/* Philox 4x32-10 (Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3"): four words
   from a 128-bit counter and a 64-bit key, integers only, so the same on any thread, level and machine. */
static MS__UNUSED void ms__philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
    uint32_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3], k0 = key[0], k1 = key[1];
    int round;
    for (round = 0; round < 10; ++round) {
        uint64_t p0 = (uint64_t)0xD2511F53u * c0, p1 = (uint64_t)0xCD9E8D57u * c2;
        c0 = (uint32_t)(p1 >> 32) ^ c1 ^ k0;
        c1 = (uint32_t)p1;
        c2 = (uint32_t)(p0 >> 32) ^ c3 ^ k1;
        c3 = (uint32_t)p0;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
    out[0] = c0;
    out[1] = c1;
    out[2] = c2;
    out[3] = c3;
}

/* A stream of random numbers: f(seed, stream, how many were drawn). */
typedef struct ms__rng {
    uint32_t counter[4], key[2], word[4];
    int used; /* words of this block already given out */
} ms__rng;

static MS__UNUSED ms__rng ms__rng_make(uint64_t seed, uint64_t stream)
{
    ms__rng rng;
    memset(&rng, 0, sizeof rng);
    rng.key[0] = (uint32_t)seed;
    rng.key[1] = (uint32_t)(seed >> 32);
    rng.counter[2] = (uint32_t)stream;
    rng.counter[3] = (uint32_t)(stream >> 32);
    rng.used = 4;
    return rng;
}

static MS__UNUSED uint32_t ms__rng_u32(ms__rng *rng)
{
    if (rng->used == 4) {
        ms__philox(rng->counter, rng->key, rng->word);
        if (++rng->counter[0] == 0) ++rng->counter[1];
        rng->used = 0;
    }
    return rng->word[rng->used++];
}

/* Uniform in the open interval (0, 1), 53 bits: never 0, never 1. */
static MS__UNUSED double ms__rng_uniform(ms__rng *rng)
{
    uint64_t a = ms__rng_u32(rng), b = ms__rng_u32(rng);
    return ((double)(((a << 32) | b) >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}

#endif /* MS_COMMON_RANDOM */
/* ms-common-random end */

/* ms-common-splitmix begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_SPLITMIX
#define MS_COMMON_SPLITMIX

/* Random numbers by splitmix64 (Steele, Lea, Flood 2014): integers only, so each is the same on any thread, level and
   machine. Streams of a seed whose numbers differ by less than 2^20 have no state in common within 2^40 draws. */
typedef struct ms__random {
    uint64_t state;
} ms__random;

static MS__UNUSED uint64_t ms__random_u64(ms__random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static MS__UNUSED ms__random ms__random_start(uint64_t seed, uint64_t stream)
{
    ms__random random = {seed};
    random.state = ms__random_u64(&random) ^ stream;
    return random;
}

/* Uniform in the open interval (0, 1), 52 bits: never 0, never 1. */
static MS__UNUSED double ms__random_uniform(ms__random *random)
{
    return ((double)(ms__random_u64(random) >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}
#endif /* MS_COMMON_SPLITMIX */
/* ms-common-splitmix end */

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

/* ---- kernel table ---------------------------------------------------------------------------------------------- */

#include <math.h>

/* Columns of every matrix and rows of every triangular one come in blocks of 8: n is padded with points that are
   independent of everything. One vector of the widest level fits, and no kernel has a remainder. */
enum {
    MS_GPR__BLOCK = 8,
    MS_GPR__CHUNK = 64, /* candidates that are predicted together */
    MS_GPR__SLAB = 32   /* training points that meet them at a time: the tile of distances stays in the first cache */
};

/* Parts of a product that are known to be zero or not wanted. */
enum {
    MS_GPR__UPPER = 1, /* only c_ij with i <= j is wanted */
    MS_GPR__LOWER = 2  /* b_kj = 0 for k < j */
};

/* Means along lines: with d2_i the squared distance of a point from point i, that of point + t step is d2_i + t
   (slope_i + t c), c = |step|^2. One such table a level and precision; lists are of `size` bytes a number, n a multiple
   of 8. */
typedef struct ms_gpr__lines {
    size_t size;
    /* d2_i = sum over k of (points[k stride + i] - place_k)^2 */
    void (*distances)(void *d2, const void *points, size_t stride, const double *point, int m, int n);
    /* slope_i = 2 sum over k of step_k (place_k - points[k stride + i]) */
    void (*slopes)(void *slope, const void *points, size_t stride, const double *point, const double *step, int m,
                   int n);
    /* sum of weight_i exp(-(d2_i + t (slope_i + t c)) / 2) */
    double (*mean)(const void *d2, const void *slope, double t, double c, const void *weight, int n);
    void (*advance)(void *d2, const void *slope, double t, double c, int n); /* d2_i += t (slope_i + t c) */
} ms_gpr__lines;

/* The inner loops, one table a level. Matrices are row-major with a stride; a is [depth][rows], b is [depth][columns],
   c is [rows][columns]; rows is a multiple of 4, columns of 8 (distances_f: of 64); pointers need no alignment. */
typedef struct ms_gpr__kernels {
    /* c -= a' b; parts: the sum of flags above, or 0 */
    void (*reduce)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride,
                   int rows, int columns, int depth, int parts);
    /* c_ij = sum over k of (a_ki - b_kj)^2, by direct differences; parts: 0 or UPPER, which still fills the 8 x 8
       blocks on the diagonal */
    void (*distances)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride,
                      int rows, int columns, int depth, int parts);
    void (*distances_f)(float *c, size_t c_stride, const float *a, size_t a_stride, const float *b, size_t b_stride,
                        int rows, int columns, int depth, int parts);
    /* c_j = scale exp(-c_j / 2), j < columns */
    void (*exponentials)(double *c, int columns, double scale);
    /* mean_j += sum over i < rows of weight_i exp(-c_ij / 2) */
    void (*accumulate)(double *mean, const double *c, size_t c_stride, const double *weight, int rows, int columns);
    void (*accumulate_f)(float *mean, const float *c, size_t c_stride, const float *weight, int rows, int columns);
    /* 8 rows of b: b = u'^-1 b, u the upper triangle of an 8 x 8 block */
    void (*solve)(const double *u, size_t u_stride, double *b, size_t b_stride, int columns);
    /* w_j = (g_j + alpha_i alpha_j) k_j; returns their sum */
    double (*weights)(double *w, const double *g, const double *k, const double *alpha, double alpha_i, int columns);
    /* slope[8 k] to slope[8 k + 7] += partial sums over j of w_j (points[k stride + j] - point[k stride])^2, k < m */
    void (*slopes)(double *slope, const double *w, const double *points, size_t stride, const double *point, int m,
                   int columns);
    void (*axpy)(double *y, double a, const double *x, int columns); /* y += a x */
    double (*dot)(const double *x, const double *y, int columns);
    ms_gpr__lines lines, lines_f;
} ms_gpr__kernels;

static double ms_gpr__pow2_double(double whole)
{
    uint64_t bits = (uint64_t)((int)whole + 1023) << 52;
    memcpy(&whole, &bits, sizeof whole);
    return whole;
}

static float ms_gpr__pow2_float(float whole)
{
    uint32_t bits = (uint32_t)((int)whole + 127) << 23;
    memcpy(&whole, &bits, sizeof whole);
    return whole;
}

#ifndef MS_GPR_FILENAME
#define MS_GPR_FILENAME \
    "ms_gpr.h" /* the header includes its kernels, once a level and precision; define it if the file is renamed */
#endif

#define MS_GPR__PASS 1
#define MS_GPR__FLOAT 1
#include MS_GPR_FILENAME
#define MS_GPR__FLOAT 0
#include MS_GPR_FILENAME
#undef MS_GPR__PASS

#if (defined(MS__X64) || defined(MS__NEON)) && (defined(__GNUC__) || defined(__clang__))
#define MS_GPR__VECTORS 1 /* kernels use the compilers' vectors; cl compiles the scalar text */
#else
#define MS_GPR__VECTORS 0
#endif

#if MS_GPR__VECTORS
#define MS_GPR__PASS 2
#define MS_GPR__FLOAT 1
#include MS_GPR_FILENAME
#define MS_GPR__FLOAT 0
#include MS_GPR_FILENAME
#undef MS_GPR__PASS
#endif

#if MS_GPR__VECTORS && defined(MS__X64)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define MS_GPR__PASS 3
#define MS_GPR__FLOAT 1
#include MS_GPR_FILENAME
#define MS_GPR__FLOAT 0
#include MS_GPR_FILENAME
#undef MS_GPR__PASS
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#endif

/* AVX-512 brought 4 to 8% over AVX2 here, too little for its text: the best level is AVX2. */
static ms_simd ms_gpr__simd_pick(ms_simd cap)
{
    ms_simd level = ms__simd_pick(MS_GPR__VECTORS ? cap : MS_SIMD_SCALAR);
    return level > MS_SIMD_AVX2 ? MS_SIMD_AVX2 : level;
}

static const ms_gpr__kernels *ms_gpr__kernels_of(ms_simd level)
{
#if MS_GPR__VECTORS && defined(MS__X64)
    if (level == MS_SIMD_AVX2) return &ms_gpr__table_avx2;
#endif
#if MS_GPR__VECTORS
    if (level == MS_SIMD_BASE) return &ms_gpr__table_base;
#endif
    (void)level;
    return &ms_gpr__table_scalar;
}
#undef MS_GPR__VECTORS

/* ---- linear algebra -------------------------------------------------------------------------------------------- */

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
    int h = ms_gpr__half(n);
    if (n > MS_GPR__BLOCK) {
        double *below = b + (size_t)h * b_stride;
        ms_gpr__forward(f, u, u_stride, h, b, b_stride, columns);
        f->reduce(below, b_stride, u + h, u_stride, b, b_stride, n - h, columns, h, 0);
        ms_gpr__forward(f, u + (size_t)h * (u_stride + 1), u_stride, n - h, below, b_stride, columns);
    } else if (n > 0) {
        f->solve(u, u_stride, b, b_stride, columns);
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

/* y = u'^-1, the lower triangle of y; its upper triangle is set to 0 inside the blocks on the diagonal and must be 0
   elsewhere. */
static void ms_gpr__invert(const ms_gpr__kernels *f, const double *u, size_t stride, int n, double *y)
{
    int h = ms_gpr__half(n), i, j, k;
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
    for (i = 0; i < n; ++i) { /* u_ii y_ij = delta_ij - sum over k < i of u_ki y_kj */
        double *row = y + (size_t)i * stride, scale = 1 / u[(size_t)i * stride + (size_t)i];
        for (j = 0; j < n; ++j) {
            double sum = i == j ? 1 : 0;
            for (k = j; k < i; ++k) sum -= u[(size_t)k * stride + (size_t)i] * y[(size_t)k * stride + (size_t)j];
            row[j] = j <= i ? sum * scale : 0;
        }
    }
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

/* What stands in front of a block that starts on a cache line. */
typedef struct ms_gpr__front {
    void *start;
    size_t size;
} ms_gpr__front;

/* The block for what `arena` counted, in which the same calls of ms__take then place it. 0: no memory. */
static int ms_gpr__place(const ms_allocator *allocator, ms__arena *arena)
{
    const size_t front = sizeof(ms_gpr__front) + 63, size = ms__size_add(arena->used, front);
    char *start = (char *)ms__alloc(allocator, size);
    ms_gpr__front *f;
    if (start == NULL) return 0;
    arena->base = start + front - ((uintptr_t)(start + front) & 63);
    arena->used = 0;
    f = (ms_gpr__front *)(void *)arena->base - 1;
    f->start = start;
    f->size = size;
    return 1;
}

/* NULL is allowed. */
static void ms_gpr__release(const ms_allocator *allocator, void *base)
{
    const ms_gpr__front *f = (const ms_gpr__front *)base;
    if (f != NULL) ms__release(allocator, f[-1].start, f[-1].size);
}

static double *ms_gpr__take(ms__arena *arena, size_t a, size_t b)
{
    return (double *)ms__take(arena, ms__size_mul(a, b), sizeof(double));
}

/* Scratch, to be released; NULL: no memory. */
static double *ms_gpr__scratch(const ms_allocator *allocator, size_t doubles)
{
    ms__arena arena = {NULL, 0};
    ms_gpr__take(&arena, doubles, 1);
    return ms_gpr__place(allocator, &arena) ? (double *)(void *)arena.base : NULL;
}

/* ---- minimizer ------------------------------------------------------------------------------------------------- */

/* f(q) and its gradient. 1: defined; 0: not defined here, the search steps back; -1: stop. */
typedef int (*ms_gpr__objective)(void *context, const double *q, double *value, double *gradient);

enum { MS_GPR__MEMORY = 20 }; /* pairs that L-BFGS remembers; more gained nothing, 10 cost a fifth more evaluations */

typedef struct ms_gpr__minimum {
    double value; /* of the last q; HUGE_VAL: not even the start is defined */
    int evaluations;
    int stopped; /* f asked to stop */
} ms_gpr__minimum;

/* How a search runs; q stays in the box [low, high] (NULL: no bounds). */
typedef struct ms_gpr__search {
    ms_gpr__objective f;
    void *context;
    int count; /* of variables */
    const double *low, *high;
    double step;      /* no variable moves farther at a time; 0: 1e300 */
    double tolerance; /* ends when an iteration gains less, and no projected slope is above its root */
    int evaluations;  /* at most */
} ms_gpr__search;

static size_t ms_gpr__minimize_doubles(int count)
{
    return ms__size_add(ms__size_mul((size_t)count, 2 * MS_GPR__MEMORY + 4), 2 * MS_GPR__MEMORY);
}

static double ms_gpr__clip(const ms_gpr__search *s, int i, double x)
{
    if (s->low && x < s->low[i]) return s->low[i];
    return s->high && x > s->high[i] ? s->high[i] : x;
}

/* Whether variable i sits on a bound and the gradient holds it there. */
static int ms_gpr__at_bound(const ms_gpr__search *s, int i, double x, double slope)
{
    return (s->low && x <= s->low[i] && slope > 0) || (s->high && x >= s->high[i] && slope < 0);
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
    int stored = 0, newest = -1, i, k, defined;
    best.stopped = 0;
    best.evaluations = 1;
    best.value = HUGE_VAL;
    for (i = 0; i < s->count; ++i) q[i] = ms_gpr__clip(s, i, q[i]);
    defined = s->f(s->context, q, &best.value, gradient);
    if (defined != 1) {
        best.value = HUGE_VAL;
        best.stopped = defined < 0;
        return best;
    }
    while (best.evaluations < s->evaluations) {
        double slope = 0, largest = 0, step = 1, value = 0, decrease = 0, steepest = 0;
        for (i = 0; i < s->count; ++i) {
            direction[i] = ms_gpr__at_bound(s, i, q[i], gradient[i]) ? 0 : -gradient[i];
            if (fabs(direction[i]) > steepest) steepest = fabs(direction[i]);
        }
        if (!(steepest > 0)) break;
        for (k = 0; k < stored; ++k) { /* two-loop recursion, on the free variables */
            int at = (newest - k + MS_GPR__MEMORY) % MS_GPR__MEMORY;
            const double *move = moves + (size_t)at * n, *change = changes + (size_t)at * n;
            for (i = 0, a[at] = 0; i < s->count; ++i) a[at] += move[i] * direction[i];
            a[at] *= rho[at];
            for (i = 0; i < s->count; ++i) direction[i] -= a[at] * change[i];
        }
        if (stored) {
            const double *move = moves + (size_t)newest * n, *change = changes + (size_t)newest * n;
            double my = 0, yy = 0;
            for (i = 0; i < s->count; ++i) my += move[i] * change[i], yy += change[i] * change[i];
            for (i = 0; i < s->count; ++i) direction[i] *= my / yy;
        } else {
            for (i = 0; i < s->count; ++i) direction[i] *= 0.5 / (steepest > 0.5 ? steepest : 0.5);
        }
        for (k = stored - 1; k >= 0; --k) {
            int at = (newest - k + MS_GPR__MEMORY) % MS_GPR__MEMORY;
            const double *move = moves + (size_t)at * n, *change = changes + (size_t)at * n;
            double b = 0;
            for (i = 0; i < s->count; ++i) b += change[i] * direction[i];
            b = a[at] - b * rho[at];
            for (i = 0; i < s->count; ++i) direction[i] += b * move[i];
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
        if (s->step > 0 && largest > s->step) step = s->step / largest;
        for (;;) {
            decrease = 0;
            for (i = 0; i < s->count; ++i) {
                trial[i] = ms_gpr__clip(s, i, q[i] + step * direction[i]);
                decrease += gradient[i] * (trial[i] - q[i]);
            }
            defined = s->f(s->context, trial, &value, trial_gradient);
            ++best.evaluations;
            if (defined < 0) {
                best.stopped = 1;
                return best;
            }
            if (defined && ms__finite(value) && value <= best.value + 1e-4 * decrease) break;
            if (best.evaluations >= s->evaluations || step * largest < 1e-12) {
                defined = 0;
                break;
            }
            if (defined && ms__finite(value)) { /* the minimum of the parabola through both values and the slope */
                double shrink = -0.5 * decrease / (value - best.value - decrease);
                step *= shrink < 0.1 ? 0.1 : shrink > 0.5 ? 0.5 : shrink;
            } else {
                step *= 0.25;
            }
        }
        if (!defined) {
            if (stored == 0 || best.evaluations >= s->evaluations) break;
            stored = 0;
            continue;
        }
        {
            int at = (newest + 1) % MS_GPR__MEMORY;
            double *move = moves + (size_t)at * n, *change = changes + (size_t)at * n, curvature = 0, yy = 0,
                   gain = best.value - value;
            for (i = 0, steepest = 0; i < s->count; ++i) {
                move[i] = trial[i] - q[i];
                change[i] = trial_gradient[i] - gradient[i];
                curvature += move[i] * change[i];
                yy += change[i] * change[i];
                q[i] = trial[i];
                gradient[i] = trial_gradient[i];
                if (!ms_gpr__at_bound(s, i, q[i], gradient[i]) && fabs(gradient[i]) > steepest)
                    steepest = fabs(gradient[i]);
            }
            best.value = value;
            if (curvature > 1e-10 * yy) {
                rho[at] = 1 / curvature;
                newest = at;
                if (stored < MS_GPR__MEMORY) ++stored;
            }
            if (gain < s->tolerance && steepest * steepest < s->tolerance) break;
            if (gain < 1e-3 * s->tolerance) break;
        }
    }
    return best;
}

/* ---- likelihood ------------------------------------------------------------------------------------------------ */

/* What was said about a latent value g = f_row, or about a difference g = f_row - f_than: that g and its noise lie from
   low to high. A score is low = high, a comparison 0 to MS_GPR__OPEN of a difference, a score of coarse steps a
   range. */
typedef struct ms_gpr__observation {
    int row, than; /* than < 0: one row */
    double low, high;
} ms_gpr__observation;

static const double MS_GPR__OPEN = 1e40; /* a bound that is none */
static const double MS_GPR__RIDGE =
    1e-5; /* K / sf^2 that every row is held to the prior mean by, so that W can be inverted */

/* What one evaluation needs. Rows and columns behind n stand for points that are independent of everything. */
typedef struct ms_gpr__problem {
    const ms_gpr__kernels *kernels;
    int n, m;                /* m: dimensions in use */
    size_t stride;           /* of every matrix here */
    double *points;          /* [m][stride] inputs in length scales, by dimension */
    double *target;          /* [stride] scores less the prior mean */
    double *alpha;           /* [stride] K'^-1 target */
    double *kernel;          /* [n][stride] K, upper triangle */
    double *upper;           /* [n][stride] U, U'U = K'; later -K'^-1 */
    double *inverse;         /* [n][stride] U'^-1 */
    double *weight;          /* [stride] a row of dL/dK * K */
    double *slope;           /* [m][8] */
    int observations, pairs; /* where not every row has one exact score: what was said, comparisons last; else 0 */
    ms_gpr__observation *observation;
    double *solved;   /* [n][stride] U'^-1 K; before that, blocks of W */
    double *latent;   /* [stride] f, the most probable latent values; alpha = K^-1 f */
    double *list;     /* [6][stride] scratch, then [pairs] */
    int components;   /* of the graph of comparisons, single rows included; 0: not known yet */
    int *member;      /* [n] rows, component by component */
    int *position;    /* [n] where a row is in its component */
    int *first;       /* [n + 1] the first member of each component */
    int *head, *next; /* [n], [pairs] lists of the comparisons that a row won; -1 ends one */
} ms_gpr__problem;

/* K, upper triangle: sf^2 exp(-d^2 / 2), 0 for padding. */
static void ms_gpr__covariance(const ms_gpr__kernels *f, const double *points, size_t stride, int n, int m, double sf2,
                               double *kernel)
{
    int padded = ms_gpr__padded(n), i, j;
    f->distances(kernel, stride, points, stride, points, stride, padded, padded, m, MS_GPR__UPPER);
    for (i = 0; i < padded; ++i) {
        double *row = kernel + (size_t)i * stride;
        int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK;
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
        size_t at = (size_t)i * stride + (size_t)(i / MS_GPR__BLOCK * MS_GPR__BLOCK);
        if (upper != kernel)
            memcpy(upper + at, kernel + at, ((size_t)i * stride + (size_t)padded - at) * sizeof *upper);
        upper[(size_t)i * stride + (size_t)i] = sf2 + noise;
    }
    return ms_gpr__cholesky(f, upper, stride, padded, n * 2.220446049250313e-16 * (sf2 + noise));
}

/* The next part of sf^2 to add to the diagonal of a matrix that has no factor, up to 1e-6. */
static double ms_gpr__next_jitter(double jitter) { return jitter > 0 ? 10 * jitter : 1e-15; }

static double ms_gpr__log_determinant(const double *upper, size_t stride, int n)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) sum += log(upper[(size_t)i * (stride + 1)]);
    return 2 * sum;
}

/* --- comparisons and coarse scores --- */

/* log p(g in [low, high] after noise) of one observation, and its derivatives. */
typedef struct ms_gpr__term {
    double value, slope, curvature, third; /* l and its derivatives by g, the last two with their signs turned */
    double value_s, slope_s, curvature_s;  /* the first three by the logarithm of the noise's deviation */
} ms_gpr__term;

/* (1 - Phi(x)) / phi(x) for x >= 0: Mills' ratio, by its continued fraction where erfc has few digits left. */
static double ms_gpr__mills(double x)
{
    double tail = x;
    int i;
    if (x < 5) return 1.2533141373155003 * exp(0.5 * x * x) * erfc(0.7071067811865476 * x); /* root of pi / 2 */
    for (i = 40; i > 0; --i) tail = x + i / tail;
    return 1 / tail;
}

/* s: deviation of the noise of g. */
static ms_gpr__term ms_gpr__term_of(const ms_gpr__observation *observation, double g, double s)
{
    ms_gpr__term r;
    double a = (observation->low - g) / s, b = (observation->high - g) / s, sign = 1, ra, rb, q, e, d, q_s, e_s;
    if (!(observation->high > observation->low)) {               /* a density */
        r.value = -0.5 * a * a - log(s) - 0.9189385332046727418; /* log(2 pi) / 2 */
        r.slope = a / s;
        r.curvature = 1 / (s * s);
        r.third = 0;
        r.value_s = a * a - 1;
        r.slope_s = -2 * r.slope;
        r.curvature_s = -2 * r.curvature;
        return r;
    }
    if (a + b < 0) { /* the mirror image: a is the bound nearer to g */
        double swap = a;
        a = -b;
        b = -swap;
        sign = -1;
    }
    if (a < 0) {
        double p = 0.5 * (erfc(0.7071067811865476 * a) - (b < 40 ? erfc(0.7071067811865476 * b) : 0));
        r.value = log(p);
        ra = a > -40 ? 0.3989422804014327 * exp(-0.5 * a * a) / p : 0; /* phi(a) / p, phi(b) / p */
        rb = b < 40 ? 0.3989422804014327 * exp(-0.5 * b * b) / p : 0;
    } else {
        double fall = b - a < 80 ? exp(0.5 * (a - b) * (a + b)) : 0,
               p = ms_gpr__mills(a) - (fall > 0 ? fall * ms_gpr__mills(b) : 0);
        r.value = log(p) - 0.5 * a * a - 0.9189385332046727418;
        ra = 1 / p;
        rb = ra * fall;
    }
    if (!(rb > 0)) b = 0;
    if (!(ra > 0)) a = 0;
    q = ra - rb;
    e = b * rb - a * ra;
    d = q * q + e;
    if (!(d > 0)) d = 0;
    q_s = a * a * ra - b * b * rb + q * e;
    e_s = (b * b * b - b) * rb - (a * a * a - a) * ra + e * e;
    r.slope = sign * q / s;
    r.curvature = d / (s * s);
    r.third = sign * ((1 - a * a) * ra - (1 - b * b) * rb - 2 * q * d - e * q) / (s * s * s);
    r.value_s = -e;
    r.slope_s = sign * (q_s - q) / s;
    r.curvature_s = (2 * q * q_s + e_s - 2 * d) / (s * s);
    return r;
}

static ms_gpr__term ms_gpr__term_at(const ms_gpr__problem *p, int i, double noise)
{
    const ms_gpr__observation *l = &p->observation[i];
    return ms_gpr__term_of(l, p->latent[l->row] - (l->than < 0 ? 0 : p->latent[l->than]),
                           sqrt(l->than < 0 ? noise : 2 * noise));
}

/* out = a v, a symmetric, of which the upper triangle is there. */
static void ms_gpr__symmetric(const ms_gpr__kernels *f, const double *a, size_t stride, int padded, const double *v,
                              double *out)
{
    int i, j;
    memset(out, 0, (size_t)padded * sizeof *out);
    for (i = 0; i < padded; ++i) {
        const double *row = a + (size_t)i * stride;
        int end = (i / MS_GPR__BLOCK + 1) * MS_GPR__BLOCK;
        out[i] += row[i] * v[i];
        for (j = i + 1; j < end; ++j) {
            out[i] += row[j] * v[j];
            out[j] += row[j] * v[i];
        }
        out[i] += f->dot(row + end, v + end, padded - end);
        f->axpy(out + end, v[i], row + end, padded - end);
    }
}

/* sum of l - alpha' f / 2, which Newton's method climbs. */
static double ms_gpr__log_posterior(const ms_gpr__problem *p, double ridge, double noise)
{
    double sum = 0;
    int i;
    for (i = 0; i < p->n; ++i) sum -= 0.5 * p->latent[i] * (p->alpha[i] + ridge * p->latent[i]);
    for (i = 0; i < p->observations; ++i) sum += ms_gpr__term_at(p, i, noise).value;
    return sum;
}

/* The root of row i's tree; the path to it is halved. */
static int ms_gpr__root(int *parent, int i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* Connected components of the graph whose edges are the comparisons: W is block-diagonal over them. */
static void ms_gpr__components(ms_gpr__problem *p)
{
    int *parent = p->position, *size = p->first, n = p->n, i, j, root, at = 0;
    const ms_gpr__observation *pair = p->observation + p->observations - p->pairs;
    for (i = 0; i < n; ++i) parent[i] = i, size[i] = 0, p->head[i] = -1;
    for (i = 0; i < p->pairs; ++i) {
        int a = ms_gpr__root(parent, pair[i].row), b = ms_gpr__root(parent, pair[i].than);
        parent[a > b ? a : b] = a > b ? b : a; /* the root is the least row */
        p->next[i] = p->head[pair[i].row];
        p->head[pair[i].row] = i;
    }
    for (i = 0; i < n; ++i) ++size[ms_gpr__root(parent, i)];
    for (root = 0; root < n; ++root) { /* size becomes where the next member goes */
        j = size[root];
        size[root] = at;
        at += j;
    }
    for (i = 0; i < n; ++i) p->member[size[ms_gpr__root(parent, i)]++] = i;
    for (i = 0, p->components = 0; i < n; ++i) { /* a component ends where the next root stands */
        int row = p->member[i];
        if (ms_gpr__root(parent, row) == row) p->first[p->components++] = i;
    }
    p->first[p->components] = n;
    for (j = 0; j < p->components; ++j)
        for (i = p->first[j]; i < p->first[j + 1]; ++i) p->position[p->member[i]] = i - p->first[j];
}

/* Component c of W, whose diagonal is curvature [n] and whose other elements are -compared [pairs]: adds its inverse to
   upper, z = W^-1 z. v: [n] scratch. Returns log |W|, or 1e300 where W has no factor. */
static double ms_gpr__component(ms_gpr__problem *p, int c, const double *curvature, const double *compared, double *z,
                                double *v)
{
    const ms_gpr__kernels *f = p->kernels;
    const int *member = p->member + p->first[c];
    int rows = p->first[c + 1] - p->first[c], padded = ms_gpr__padded(rows), i, j;
    size_t stride = ms_gpr__stride(rows), size = (size_t)padded * stride * sizeof(double);
    double *w = p->solved, determinant;
    const ms_gpr__observation *pair = p->observation + p->observations - p->pairs;
    memset(w, 0, size);
    memset(v, 0, (size_t)padded * sizeof *v);
    for (i = 0; i < padded; ++i) w[(size_t)i * (stride + 1)] = i < rows ? curvature[member[i]] : 1;
    for (i = 0; i < rows; ++i) {
        int at;
        v[i] = z[member[i]];
        for (at = p->head[member[i]]; at >= 0; at = p->next[at]) {
            j = p->position[pair[at].than];
            w[(size_t)(i < j ? i : j) * stride + (size_t)(i < j ? j : i)] -= compared[at];
        }
    }
    if (!ms_gpr__cholesky(f, w, stride, padded, 0)) return 1e300;
    determinant = ms_gpr__log_determinant(w, stride, rows);
    ms_gpr__forward_vector(f, w, stride, padded, v);
    ms_gpr__backward_vector(f, w, stride, padded, v);
    for (i = 0; i < rows; ++i) z[member[i]] = v[i];
    memset(p->inverse, 0, size);
    ms_gpr__invert(f, w, stride, padded, p->inverse);
    memset(w, 0, size);
    f->reduce(w, stride, p->inverse, stride, p->inverse, stride, padded, padded, padded, MS_GPR__UPPER | MS_GPR__LOWER);
    for (i = 0; i < rows; ++i) /* members are in the order of rows */
        for (j = i; j < rows; ++j)
            p->upper[(size_t)member[i] * p->stride + (size_t)member[j]] -= w[(size_t)i * stride + (size_t)j];
    return determinant;
}

/* upper = the factor of K + W^-1, W = -l'' at the latent values; list[0] = f + W^-1 l', list[1] = l'. Returns log |W|,
   or 1e300 where a factor fails. */
static double ms_gpr__laplace_factor(ms_gpr__problem *p, double ridge, double noise)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), scores = p->observations - p->pairs, i, c;
    double *z = p->list, *l1 = z + p->stride, *curvature = z + 4 * p->stride, *v = curvature + p->stride,
           *compared = v + p->stride, determinant = 0;
    if (p->components == 0) ms_gpr__components(p);
    for (i = 0; i < padded; ++i) {
        curvature[i] = i < p->n ? ridge : 1;
        l1[i] = i < p->n ? -ridge * p->latent[i] : 0;
    }
    for (i = 0; i < p->observations; ++i) {
        const ms_gpr__observation *l = &p->observation[i];
        ms_gpr__term o = ms_gpr__term_at(p, i, noise);
        curvature[l->row] += o.curvature;
        l1[l->row] += o.slope;
        if (i < scores) continue;
        curvature[l->than] += o.curvature;
        compared[i - scores] = o.curvature;
        l1[l->than] -= o.slope;
    }
    memcpy(z, l1, (size_t)padded * sizeof *z);
    for (i = 0; i < padded; ++i) {
        size_t at = (size_t)i * (p->stride + 1);
        memcpy(p->upper + at, p->kernel + at, (size_t)(padded - i) * sizeof(double));
        if (i >= p->n) p->upper[at] += 1;
    }
    for (c = 0; c < p->components; ++c) {
        int row = p->member[p->first[c]];
        double part;
        if (p->first[c + 1] - p->first[c] == 1) {
            z[row] /= curvature[row];
            p->upper[(size_t)row * (p->stride + 1)] += 1 / curvature[row];
            part = log(curvature[row]);
        } else {
            part = ms_gpr__component(p, c, curvature, compared, z, v);
            if (part > 1e299) return part;
        }
        determinant += part;
    }
    for (i = 0; i < p->n; ++i) z[i] += p->latent[i];
    return ms_gpr__cholesky(f, p->upper, p->stride, padded, 0) ? determinant : 1e300;
}

/* Laplace's approximation, from the alpha that is there: Newton's method in f (Rasmussen & Williams 2006, 3.4, with W
   that need not be diagonal) to f and alpha, the factor of K + W^-1, and log p(y) = sum of l - alpha' f / 2 - log |I +
   K W| / 2. 0: no factor. */
static int ms_gpr__laplace(ms_gpr__problem *p, double sf2, double noise, double *likelihood)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), step, halving, i;
    size_t row = (size_t)padded * sizeof(double);
    double ridge = MS_GPR__RIDGE / sf2, determinant = 0, value, better;
    double *z = p->list, *l1 = z + p->stride, *turn = l1 + p->stride, *move = turn + p->stride;
    ms_gpr__symmetric(f, p->kernel, p->stride, padded, p->alpha, p->latent);
    value = ms_gpr__log_posterior(p, ridge, noise);
    memcpy(turn, p->alpha, row);
    memset(p->alpha, 0, row);
    memcpy(move, p->latent, row);
    memset(p->latent, 0, row);
    better = ms_gpr__log_posterior(p, ridge, noise);
    if (!ms__finite(value) || better > value) {
        value = better; /* nothing known is the better start */
    } else {
        memcpy(p->alpha, turn, row);
        memcpy(p->latent, move, row);
    }
    for (step = 0; step < 100; ++step) {
        double slope = 0;
        determinant = ms_gpr__laplace_factor(p, ridge, noise);
        if (determinant > 1e299 || !ms__finite(determinant)) return 0;
        memcpy(turn, z, row);
        ms_gpr__forward_vector(f, p->upper, p->stride, padded, turn);
        ms_gpr__backward_vector(f, p->upper, p->stride, padded, turn);
        ms_gpr__symmetric(f, p->kernel, p->stride, padded, turn, move);
        for (i = 0; i < padded; ++i) {
            turn[i] -= p->alpha[i];
            move[i] -= p->latent[i];
            slope += (l1[i] - p->alpha[i]) * move[i];
        }
        for (halving = 0; halving < 40; ++halving) {
            double length = halving ? -0.5 / (1 << (halving < 30 ? halving - 1 : 29))
                                    : 1; /* 1, then half of it back, ... */
            f->axpy(p->alpha, length, turn, padded);
            f->axpy(p->latent, length, move, padded);
            if (slope < 1e-12 * (1 + fabs(value))) break;
            if (halving == 1 && slope < 1e-8 * (1 + fabs(value))) break; /* rounding hides what is gained */
            better = ms_gpr__log_posterior(p, ridge, noise);
            if (ms__finite(better) && better > value) break;
        }
        if (slope < 1e-12 * (1 + fabs(value)) || halving == 40 || !(better > value)) break;
        value = better;
    }
    *likelihood = ms_gpr__log_posterior(p, ridge, noise) -
        0.5 * (determinant + ms_gpr__log_determinant(p->upper, p->stride, p->n));
    return 1;
}

/* What the gradient of Laplace's log p(y) has besides tr((alpha alpha' - (K + W^-1)^-1) dK) / 2 because f depends on
   theta (Rasmussen & Williams 2006, 5.5.1): u' dK alpha with u = (I - (K + W^-1)^-1 K) s, s = -1/2 d log |I + K W| /
   df, into u; and by log sf and log sn through the noise. upper is the factor of K + W^-1. */
static void ms_gpr__laplace_implicit(ms_gpr__problem *p, double sf2, double noise, double **implicit, double *by_sf,
                                     double *by_sn)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), first = p->observations - p->pairs, i, j;
    size_t row = (size_t)padded * sizeof(double);
    double ridge = MS_GPR__RIDGE / sf2;
    double *s = p->list, *u = s + p->stride, *h = u + p->stride, *l1_s = h + p->stride, *explained = l1_s + p->stride;
    for (i = 0; i < padded; ++i)
        for (j = i; j < padded; ++j)
            p->solved[(size_t)i * p->stride + (size_t)j] = p->solved[(size_t)j * p->stride + (size_t)i] =
                p->kernel[(size_t)i * p->stride + (size_t)j];
    ms_gpr__forward(f, p->upper, p->stride, padded, p->solved, p->stride, padded);
    memset(explained, 0, (p->stride + (size_t)p->pairs) * sizeof *explained);
    for (i = 0; i < p->n; ++i) {
        const double *v = p->solved + (size_t)i * p->stride;
        double *pair = explained + p->stride;
        for (j = 0; j < p->n; ++j) explained[j] += v[j] * v[j];
        for (j = first; j < p->observations; ++j) {
            double d = v[p->observation[j].row] - v[p->observation[j].than];
            *pair++ += d * d;
        }
    }
    memset(s, 0, 4 * p->stride * sizeof *s);
    *by_sf = *by_sn = 0;
    for (i = 0; i < p->observations; ++i) { /* variances of g: a' (K - K (K + W^-1)^-1 K) a */
        const ms_gpr__observation *l = &p->observation[i];
        ms_gpr__term o = ms_gpr__term_at(p, i, noise);
        double variance = sf2 - explained[l->row];
        if (l->than >= 0)
            variance = 2 *
                    (sf2 -
                     p->kernel[(size_t)(l->row < l->than ? l->row : l->than) * p->stride +
                               (size_t)(l->row < l->than ? l->than : l->row)]) -
                explained[p->stride + (size_t)(i - first)];
        s[l->row] -= 0.5 * o.third * variance;
        l1_s[l->row] += o.slope_s;
        if (l->than >= 0) s[l->than] += 0.5 * o.third * variance, l1_s[l->than] -= o.slope_s;
        *by_sn += o.value_s - 0.5 * o.curvature_s * variance;
    }
    ms_gpr__symmetric(f, p->kernel, p->stride, padded, s, h);
    memcpy(u, h, row);
    ms_gpr__forward_vector(f, p->upper, p->stride, padded, u);
    ms_gpr__backward_vector(f, p->upper, p->stride, padded, u);
    for (i = 0; i < padded; ++i) u[i] = s[i] - u[i];
    ms_gpr__symmetric(f, p->kernel, p->stride, padded, u, h);
    *by_sn += f->dot(l1_s, h, padded);
    for (i = 0; i < p->n; ++i)
        *by_sf += ridge * (p->latent[i] * p->latent[i] + sf2 - explained[i] + 2 * p->latent[i] * h[i]);
    *implicit = u;
}

/* log p(y | X, theta) = -1/2 y' alpha - 1/2 log |K'| - n/2 log 2 pi, or Laplace's approximation, and its gradient [m +
   2] with respect to log l_k, log sf, log sn (NULL: not wanted):  1/2 tr((alpha alpha' - K'^-1) dK'/dtheta). 0 where K'
   is not positive definite. */
static int ms_gpr__evaluate(ms_gpr__problem *p, double sf2, double noise, double *likelihood, double *gradient)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), i, k;
    size_t row = (size_t)padded * sizeof(double);
    double trace = 0, kernel_sum = 0, by_sf = 0, by_sn = 0, *implicit = NULL;
    ms_gpr__covariance(f, p->points, p->stride, p->n, p->m, sf2, p->kernel);
    if (p->observation) {
        for (i = 0; i < p->n; ++i) p->kernel[(size_t)i * (p->stride + 1)] = sf2;
        if (!ms_gpr__laplace(p, sf2, noise, likelihood)) return 0;
    } else {
        if (!ms_gpr__factor(f, p->kernel, p->stride, p->n, sf2, noise, p->upper)) return 0;
        memcpy(p->alpha, p->target, row);
        ms_gpr__forward_vector(f, p->upper, p->stride, padded, p->alpha);
        *likelihood = -0.5 *
            (f->dot(p->alpha, p->alpha, padded) + ms_gpr__log_determinant(p->upper, p->stride, p->n) +
             p->n * 1.8378770664093454836); /* log 2 pi */
    }
    if (gradient == NULL) return 1;
    if (p->observation) ms_gpr__laplace_implicit(p, sf2, noise, &implicit, &by_sf, &by_sn);
    else ms_gpr__backward_vector(f, p->upper, p->stride, padded, p->alpha);
    for (i = 0; i < padded; ++i) memset(p->inverse + (size_t)i * p->stride, 0, row);
    ms_gpr__invert(f, p->upper, p->stride, padded, p->inverse);
    for (i = 0; i < padded; ++i) memset(p->upper + (size_t)i * p->stride, 0, row);
    f->reduce(p->upper, p->stride, p->inverse, p->stride, p->inverse, p->stride, padded, padded, padded,
              MS_GPR__UPPER | MS_GPR__LOWER);
    memset(p->slope, 0, (size_t)p->m * MS_GPR__BLOCK * sizeof *p->slope);
    for (i = 0; i < p->n; ++i) {
        int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK, j;
        size_t at = (size_t)i * p->stride;
        double own;
        if (implicit) {
            f->axpy(p->upper + at + block, implicit[i], p->alpha + block, padded - block);
            f->axpy(p->upper + at + block, p->alpha[i], implicit + block, padded - block);
        }
        own = p->alpha[i] * p->alpha[i] + p->upper[at + (size_t)i];
        for (j = block; j <= i; ++j) p->kernel[at + (size_t)j] = 0; /* each pair once; the diagonal has d = 0 */
        kernel_sum += f->weights(p->weight + block, p->upper + at + block, p->kernel + at + block, p->alpha + block,
                                 p->alpha[i], padded - block);
        f->slopes(p->slope, p->weight + block, p->points + block, p->stride, p->points + i, p->m, padded - block);
        trace += own;
    }
    for (k = 0; k < p->m; ++k) { /* dK_ij/dlog l_k = K_ij d_ijk^2; pairs count twice */
        const double *s = p->slope + MS_GPR__BLOCK * k;
        gradient[k] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
    gradient[p->m] = sf2 * trace + 2 * kernel_sum + by_sf;       /* dK/dlog sf = 2 K */
    gradient[p->m + 1] = p->observation ? by_sn : noise * trace; /* dK'/dlog sn = 2 sn^2 I */
    return 1;
}

/* Places or counts what a problem of these sizes needs; observations: 0, or how many there are, with the pairs. Once it
   is placed, ms_gpr__problem_clear. */
static void ms_gpr__problem_layout(ms_gpr__problem *p, const ms_gpr__kernels *kernels, int n, int m, int observations,
                                   int pairs, ms__arena *arena)
{
    const size_t padded = (size_t)ms_gpr__padded(n), rows = (size_t)n, columns = (size_t)m;
    p->kernels = kernels;
    p->n = n;
    p->m = m;
    p->stride = ms_gpr__stride(n);
    p->kernel = ms_gpr__take(arena, padded, p->stride);
    p->upper = ms_gpr__take(arena, padded, p->stride);
    p->inverse = ms_gpr__take(arena, padded, p->stride);
    p->points = ms_gpr__take(arena, columns, p->stride);
    p->target = ms_gpr__take(arena, p->stride, 1);
    p->alpha = ms_gpr__take(arena, p->stride, 1);
    p->weight = ms_gpr__take(arena, p->stride, 1);
    p->slope = ms_gpr__take(arena, columns, MS_GPR__BLOCK);
    if (observations == 0) return;
    p->observations = observations;
    p->pairs = pairs;
    p->solved = ms_gpr__take(arena, padded, p->stride);
    p->latent = ms_gpr__take(arena, p->stride, 1);
    p->list = ms_gpr__take(arena, 6 * p->stride + (size_t)pairs, 1);
    p->member = (int *)ms__take(arena, rows, sizeof(int));
    p->position = (int *)ms__take(arena, rows, sizeof(int));
    p->head = (int *)ms__take(arena, rows, sizeof(int));
    p->first = (int *)ms__take(arena, rows + 1, sizeof(int));
    p->next = (int *)ms__take(arena, (size_t)pairs, sizeof(int));
    p->observation = (ms_gpr__observation *)ms__take(arena, (size_t)observations, sizeof *p->observation);
}

/* Points, target and alpha are 0 where nothing is written. */
static void ms_gpr__problem_clear(ms_gpr__problem *p)
{
    memset(p->points, 0, (size_t)p->m * p->stride * sizeof *p->points);
    memset(p->target, 0, p->stride * sizeof *p->target);
    memset(p->alpha, 0, p->stride * sizeof *p->alpha);
}

/* ---- model ----------------------------------------------------------------------------------------------------- */

static const double MS_GPR__DROPPED = 700.0; /* log l_k of a dimension that is dropped: no exp of it overflows */
enum { MS_GPR__N_MAX = 30000 };              /* the matrix has 7 GB then */
static const double MS_GPR__LARGEST = 1e30;  /* of a score or an input: squares of sums and single precision hold it */
static const double MS_GPR__MOST = 2147483647;
static const double MS_GPR__NO_FLOOR = -1e300;

struct ms_gpr {
    int n, m, active; /* active: dimensions in use */
    size_t stride;
    double mean, floor, floor_value; /* scores up to floor are taken as floor_value */
    double jitter, likelihood;       /* the latter of soft models */
    double step;                     /* of the scores; 0: exact */
    int pair_count, pair_room, soft; /* soft: conditioned by Laplace's approximation */
    int *pairs;                      /* [pair_room][2] */
    ms_simd level;
    const ms_gpr__kernels *kernels;
    ms_allocator allocator;
    ms_parallel parallel;
    void *memory;    /* what follows */
    double *x;       /* [capacity][m] */
    double *y;       /* [capacity] */
    double *value;   /* [capacity] y, or what is predicted for a row without */
    double *theta;   /* [m + 2] */
    double *center;  /* [m] subtracted from inputs, so that offsets cost no digits */
    double *scale;   /* [m] 1 / l_k */
    double *points;  /* [active][stride] (x - center) / l by dimension, padded with zeros */
    double *alpha;   /* [stride] */
    double *weight;  /* [stride] sf^2 alpha */
    double *upper;   /* [capacity][stride] U'U = K' */
    float *points_f; /* [active][stride] */
    float *weight_f; /* [stride] */
    int *dimension;  /* [active] which column of x */
};

/* The parts of a block for `capacity` points. */
static void ms_gpr__layout(ms_gpr *gp, int capacity, ms__arena *arena)
{
    size_t m = (size_t)gp->m, rows = (size_t)capacity;
    gp->stride = ms_gpr__stride(capacity);
    gp->upper = ms_gpr__take(arena, (size_t)ms_gpr__padded(capacity), gp->stride);
    gp->points = ms_gpr__take(arena, m, gp->stride);
    gp->alpha = ms_gpr__take(arena, gp->stride, 1);
    gp->weight = ms_gpr__take(arena, gp->stride, 1);
    gp->points_f = (float *)ms__take(arena, m * gp->stride, sizeof(float));
    gp->weight_f = (float *)ms__take(arena, gp->stride, sizeof(float));
    gp->x = ms_gpr__take(arena, rows, m);
    gp->y = ms_gpr__take(arena, rows, 1);
    gp->value = ms_gpr__take(arena, rows, 1);
    gp->theta = ms_gpr__take(arena, m + 2, 1);
    gp->center = ms_gpr__take(arena, m, 1);
    gp->scale = ms_gpr__take(arena, m, 1);
    gp->dimension = (int *)ms__take(arena, m, sizeof(int));
}

static double ms_gpr__sf2(const ms_gpr *gp) { return exp(2 * gp->theta[gp->m]); }
static double ms_gpr__sn2(const ms_gpr *gp) { return exp(2 * gp->theta[gp->m + 1]); }

/* What the model takes score i as, less the prior mean. */
static double ms_gpr__target(const ms_gpr *gp, int i)
{
    return gp->y[i] < 0.5 * MS_GPR_UNSCORED ? 0 : (gp->y[i] > gp->floor ? gp->y[i] : gp->floor_value) - gp->mean;
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

static int ms_gpr__scored(double y) { return y > 0.5 * MS_GPR_UNSCORED; }

/* What follows from alpha. */
static void ms_gpr__update_weights(ms_gpr *gp)
{
    int padded = ms_gpr__padded(gp->n), i;
    double sf2 = ms_gpr__sf2(gp);
    for (i = 0; i < padded; ++i) {
        gp->weight[i] = sf2 * gp->alpha[i];
        gp->weight_f[i] = (float)gp->weight[i];
    }
    memcpy(gp->value, gp->y, (size_t)gp->n * sizeof *gp->value);
}

/* alpha = K'^-1 (y - mean) from the factor. */
static void ms_gpr__solve_alpha(ms_gpr *gp)
{
    int padded = ms_gpr__padded(gp->n), i;
    for (i = 0; i < padded; ++i) gp->alpha[i] = i < gp->n ? ms_gpr__target(gp, i) : 0;
    ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, gp->alpha);
    ms_gpr__backward_vector(gp->kernels, gp->upper, gp->stride, padded, gp->alpha);
    ms_gpr__update_weights(gp);
}

/* log p(y | X, theta) from the factor. */
static double ms_gpr__likelihood_of(const ms_gpr *gp)
{
    double fit = 0;
    int i;
    for (i = 0; i < gp->n; ++i) fit += ms_gpr__target(gp, i) * gp->alpha[i];
    return -0.5 * (fit + ms_gpr__log_determinant(gp->upper, gp->stride, gp->n) + gp->n * 1.8378770664093454836);
}

/* How many of n values are scores, the least of them and the most (OPEN and -OPEN where none is). */
static int ms_gpr__score_range(const double *y, int n, double *least, double *most)
{
    int scored = 0, i;
    *least = MS_GPR__OPEN, *most = -MS_GPR__OPEN;
    for (i = 0; i < n; ++i) {
        if (!ms_gpr__scored(y[i])) continue;
        *least = fmin(*least, y[i]);
        *most = fmax(*most, y[i]);
        ++scored;
    }
    return scored;
}

/* The least score that counts, where `known` is no floor: the least that was given; 0 where all are equal and above, or
   none is. */
static double ms_gpr__floor(const double *y, int n, double known)
{
    double least, most;
    if (known > MS_GPR__NO_FLOOR) return known;
    ms_gpr__score_range(y, n, &least, &most);
    return most > least || least < 0 ? least : 0;
}

/* What a score says about its row, less `mean` and over `unit`; `taken`: what a score at the floor is taken as. */
static void ms_gpr__observe_score(ms_gpr__observation *l, int row, double y, double floor, double taken, double step,
                                  double mean, double unit)
{
    l->row = row;
    l->than = -1;
    l->low = l->high = ((y > floor ? y : taken) - mean) / unit;
    if (!(step > 0 && y > floor)) return;
    l->low -= 0.5 * step / unit;
    l->high += 0.5 * step / unit;
}

/* Links of n scores and of the comparisons; returns how many. observation NULL: only counts; 0 where all rows have one
   exact score. */
static int ms_gpr__observe_all(ms_gpr__observation *observation, const double *y, int n, double floor, double taken,
                               double step, double mean, double unit, const int *pairs, int pair_count)
{
    int count = 0, i;
    for (i = 0; i < n; ++i)
        if (ms_gpr__scored(y[i])) {
            if (observation) ms_gpr__observe_score(&observation[count], i, y[i], floor, taken, step, mean, unit);
            ++count;
        }
    if (pair_count == 0 && count == n && !(step > 0)) return 0;
    for (i = 0; i < pair_count && observation; ++i) {
        ms_gpr__observation *l = &observation[count + i];
        l->row = pairs[2 * i];
        l->than = pairs[2 * i + 1];
        l->low = 0;
        l->high = MS_GPR__OPEN;
    }
    return count + pair_count;
}

static int ms_gpr__observe(const ms_gpr *gp, ms_gpr__observation *observation)
{
    return ms_gpr__observe_all(observation, gp->y, gp->n, gp->floor, gp->floor_value, gp->step, gp->mean, 1, gp->pairs,
                               gp->pair_count);
}

/* The problem of this model's data and theta; *memory is from the model's allocator, to be released. */
static ms_status ms_gpr__problem_of(const ms_gpr *gp, ms_gpr__problem *p, void **memory, ms_error *error)
{
    ms__arena arena = {NULL, 0};
    int room = gp->soft ? ms_gpr__observe(gp, NULL) + 1 : 0, pass, i, k;
    memset(p, 0, sizeof *p);
    for (pass = 0; pass < 2; ++pass) {
        ms_gpr__problem_layout(p, gp->kernels, gp->n, gp->active, room, gp->pair_count, &arena);
        if (pass == 0 && !ms_gpr__place(&gp->allocator, &arena))
            return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the likelihood of %d points", gp->n);
    }
    *memory = arena.base;
    ms_gpr__problem_clear(p);
    for (k = 0; k < gp->active; ++k)
        memcpy(p->points + (size_t)k * p->stride, gp->points + (size_t)k * gp->stride, (size_t)gp->n * sizeof(double));
    for (i = 0; i < gp->n; ++i) p->target[i] = ms_gpr__target(gp, i);
    if (gp->soft) p->observations = ms_gpr__observe(gp, p->observation);
    return MS_OK;
}

/* Laplace's approximation for K + jitter sf^2 I: alpha and the factor. */
static ms_status ms_gpr__condition_soft(ms_gpr *gp, ms_error *error)
{
    ms_gpr__problem p;
    void *memory = NULL;
    int padded = ms_gpr__padded(gp->n), i, found = 0;
    double sf2 = ms_gpr__sf2(gp);
    ms_status status = ms_gpr__problem_of(gp, &p, &memory, error);
    if (status != MS_OK) return status;
    for (gp->jitter = 0; gp->jitter < 2e-6; gp->jitter = ms_gpr__next_jitter(gp->jitter)) {
        memcpy(p.alpha, gp->alpha, (size_t)padded * sizeof *p.alpha);
        found = ms_gpr__evaluate(&p, sf2, ms_gpr__sn2(gp) + gp->jitter * sf2, &gp->likelihood, NULL);
        if (found) break;
    }
    if (found) {
        for (i = 0; i < padded; ++i)
            memcpy(gp->upper + (size_t)i * gp->stride, p.upper + (size_t)i * p.stride, (size_t)padded * sizeof(double));
        memcpy(gp->alpha, p.alpha, (size_t)padded * sizeof *p.alpha);
        ms_gpr__update_weights(gp);
        for (i = 0; i < gp->n; ++i)
            if (!ms_gpr__scored(gp->y[i])) gp->value[i] = gp->mean + p.latent[i];
    }
    ms_gpr__release(&gp->allocator, memory);
    return found
        ? MS_OK
        : ms__fail(error, MS_NOT_CONVERGED, 0,
                   "the covariance matrix of %d points and what was said about them is not positive definite", gp->n);
}

/* Everything that follows from x, y, comparisons and theta. The jitter, in units of sf^2, is the least power of ten
   that does. */
static ms_status ms_gpr__condition(ms_gpr *gp, ms_error *error)
{
    size_t lists = (size_t)gp->m * gp->stride, at;
    double sf2 = ms_gpr__sf2(gp), sn2 = ms_gpr__sn2(gp);
    int i, k;
    gp->active = 0;
    for (k = 0; k < gp->m; ++k) {
        double sum = 0;
        gp->scale[k] = exp(-gp->theta[k]);
        if (gp->theta[k] < MS_GPR__DROPPED) gp->dimension[gp->active++] = k;
        for (i = 0; i < gp->n; ++i) sum += gp->x[(size_t)i * (size_t)gp->m + (size_t)k] / gp->n;
        gp->center[k] = sum;
    }
    memset(gp->points, 0, lists * sizeof *gp->points);
    memset(gp->points_f, 0, lists * sizeof *gp->points_f);
    for (i = 0; i < gp->n; ++i) ms_gpr__scale(gp, gp->x + (size_t)i * (size_t)gp->m, gp->points + i, gp->stride);
    for (at = 0; at < (size_t)gp->active * gp->stride; ++at) gp->points_f[at] = (float)gp->points[at];
    gp->soft = gp->step > 0 || gp->pair_count > 0;
    for (i = 0; i < gp->n; ++i) gp->soft |= !ms_gpr__scored(gp->y[i]);
    if (gp->soft) return ms_gpr__condition_soft(gp, error);
    for (gp->jitter = 0; gp->jitter < 2e-6; gp->jitter = ms_gpr__next_jitter(gp->jitter)) {
        ms_gpr__covariance(gp->kernels, gp->points, gp->stride, gp->n, gp->active, sf2, gp->upper);
        if (ms_gpr__factor(gp->kernels, gp->upper, gp->stride, gp->n, sf2, sn2 + gp->jitter * sf2, gp->upper)) {
            ms_gpr__solve_alpha(gp);
            return MS_OK;
        }
    }
    return ms__fail(error, MS_NOT_CONVERGED, 0,
                    "the covariance matrix of %d points is not positive definite even with 1e-6 sf^2 added to sn^2",
                    gp->n);
}

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
            double v = x[(size_t)i * (size_t)columns + (size_t)k];
            if (!ms__finite(v) || !(fabs(v) <= limit))
                return ms__fail(error, MS_BAD_DATA, (size_t)i + 1,
                                "%s %d, column %d is %g: expected a number from %g to %g", what, i + 1, k + 1, v,
                                -limit, limit);
        }
    return MS_OK;
}

static ms_status ms_gpr__check_scores(const double *y, int n, ms_error *error)
{
    double unscored = MS_GPR_UNSCORED;
    int i;
    for (i = 0; i < n; ++i)
        if (memcmp(&y[i], &unscored, sizeof unscored) != 0 && (!ms__finite(y[i]) || !(fabs(y[i]) <= MS_GPR__LARGEST)))
            return ms__fail(error, MS_BAD_DATA, (size_t)i + 1, "score %d is %g: expected a number from %g to %g", i + 1,
                            y[i], -MS_GPR__LARGEST, MS_GPR__LARGEST);
    return MS_OK;
}

static ms_status ms_gpr__check_data(const double *x, const double *y, int n, int m, ms_error *error)
{
    ms_status status;
    if (n < 0 || n > MS_GPR__N_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "n is %d: expected 0 to %d", n, MS_GPR__N_MAX);
    if (m < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "m is %d: expected at least 1", m);
    if (n > 0 && (x == NULL || y == NULL)) return ms_gpr__null(x ? "y" : "x", error);
    status = ms_gpr__check_rows(x, n, m, MS_GPR__LARGEST, "input", error);
    return status == MS_OK ? ms_gpr__check_scores(y, n, error) : status;
}

static ms_status ms_gpr__check_pairs(const int *pairs, int count, int n, ms_error *error)
{
    int i;
    if (count < 0 || count > 10000000)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "there are %d pairs: expected 0 to 10000000", count);
    if (count > 0 && pairs == NULL) return ms_gpr__null("pairs", error);
    for (i = 0; i < count; ++i)
        if (pairs[2 * i] < 0 || pairs[2 * i] >= n || pairs[2 * i + 1] < 0 || pairs[2 * i + 1] >= n ||
            pairs[2 * i] == pairs[2 * i + 1])
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i + 1,
                            "pair %d is %d, %d: expected two rows from 0 to %d", i + 1, pairs[2 * i], pairs[2 * i + 1],
                            n - 1);
    return MS_OK;
}

static ms_status ms_gpr__check_theta(const double *theta, int m, ms_error *error)
{
    int k;
    if (theta == NULL) return ms_gpr__null("theta", error);
    for (k = 0; k < m + 2; ++k) {
        double limit = k < m ? MS_GPR__DROPPED : 300;
        if (!ms__finite(theta[k]) || !(fabs(theta[k]) <= limit))
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "theta[%d] is %g: expected a logarithm from %g to %g", k,
                            theta[k], -limit, limit);
    }
    return MS_OK;
}

/* A model with room for `capacity` points: copies of what `like` says and points at. Nothing is conditioned. Newton's
   method starts from its alpha, or where that is NULL from 0. */
static ms_status ms_gpr__copy(const ms_gpr *like, int capacity, ms_gpr **out, ms_error *error)
{
    ms__arena arena = {NULL, 0};
    ms_gpr *gp = (ms_gpr *)ms__alloc(&like->allocator, sizeof *gp);
    size_t n = (size_t)like->n, m = (size_t)like->m, size = 2 * (size_t)like->pair_count * sizeof *like->pairs;
    *out = NULL;
    if (gp == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model");
    *gp = *like;
    gp->pair_room = like->pair_count;
    gp->kernels = ms_gpr__kernels_of(gp->level);
    gp->pairs = size > 0 ? (int *)ms__alloc(&gp->allocator, size) : NULL;
    ms_gpr__layout(gp, capacity, &arena);
    if ((size > 0 && gp->pairs == NULL) || !ms_gpr__place(&gp->allocator, &arena)) {
        ms__release(&like->allocator, gp->pairs, size);
        ms__release(&like->allocator, gp, sizeof *gp);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model of %d points and %d dimensions", like->n,
                        like->m);
    }
    gp->memory = arena.base;
    ms_gpr__layout(gp, capacity, &arena);
    if (n > 0) memcpy(gp->x, like->x, n * m * sizeof *gp->x);
    if (n > 0) memcpy(gp->y, like->y, n * sizeof *gp->y);
    if (size > 0) memcpy(gp->pairs, like->pairs, size);
    memcpy(gp->theta, like->theta, (m + 2) * sizeof *gp->theta);
    memset(gp->alpha, 0, gp->stride * sizeof *gp->alpha);
    if (like->alpha && n > 0) memcpy(gp->alpha, like->alpha, n * sizeof *gp->alpha);
    *out = gp;
    return MS_OK;
}

/* What ms_gpr__copy makes a model of: no comparisons, floor or steps; mean 0, one thread. */
static ms_gpr ms_gpr__like(const double *x, const double *y, int n, int m, const double *theta, ms_simd simd,
                           const ms_allocator *allocator)
{
    ms_gpr like;
    memset(&like, 0, sizeof like);
    like.x = (double *)(uintptr_t)x;
    like.y = (double *)(uintptr_t)y;
    like.theta = (double *)(uintptr_t)theta;
    like.n = n;
    like.m = m;
    like.floor = MS_GPR__NO_FLOOR;
    like.level = ms_gpr__simd_pick(simd);
    like.allocator = *allocator;
    return like;
}

static ms_status ms_gpr__make(const ms_gpr *like, ms_gpr **out, ms_error *error)
{
    ms_status status = ms_gpr__copy(like, like->n, out, error);
    if (status != MS_OK) return status;
    status = ms_gpr__condition(*out, error);
    if (status == MS_OK) return MS_OK;
    ms_gpr_destroy(*out);
    *out = NULL;
    return status;
}

/* A copy of the model to be changed, with room for `more` points, and with these pairs. */
static ms_status ms_gpr__edit(const ms_gpr *gp, int more, const int *pairs, int pair_count, ms_gpr **out,
                              ms_error *error)
{
    ms_gpr like = *gp;
    like.pairs = (int *)(uintptr_t)pairs;
    like.pair_count = pair_count;
    return ms_gpr__copy(&like, gp->n + more, out, error);
}

/* Conditions the changed copy and puts it in the place of gp, which keeps its address; or drops it. */
static ms_status ms_gpr__commit(ms_gpr *gp, ms_gpr *edited, ms_error *error)
{
    ms_status status = ms_gpr__condition(edited, error);
    if (status == MS_OK) {
        ms_gpr old = *gp;
        *gp = *edited;
        *edited = old;
    }
    ms_gpr_destroy(edited);
    return status;
}

MS_API ms_status ms_gpr_create(const double *x, const double *y, int n, int m, const double *theta,
                               const ms_gpr_options *options, ms_gpr **out, ms_error *error)
{
    ms_gpr_options o;
    ms_gpr like;
    ms_status status;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    memset(&o, 0, sizeof o);
    if (options) o = *options;
    status = ms_gpr__check_data(x, y, n, m, error);
    if (status == MS_OK) status = ms_gpr__check_theta(theta, m, error);
    if (status == MS_OK && !ms__finite(o.mean))
        status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "the prior mean is not finite");
    if (status != MS_OK) return status;
    like = ms_gpr__like(x, y, n, m, theta, o.simd, &o.allocator);
    like.mean = o.mean;
    like.parallel = o.parallel;
    return ms_gpr__make(&like, out, error);
}

MS_API void ms_gpr_destroy(ms_gpr *gp)
{
    ms_allocator allocator;
    if (gp == NULL) return;
    allocator = gp->allocator;
    ms_gpr__release(&allocator, gp->memory);
    ms__release(&allocator, gp->pairs, 2 * (size_t)gp->pair_room * sizeof *gp->pairs);
    ms__release(&allocator, gp, sizeof *gp);
}

MS_API void ms_gpr_relevance(const ms_gpr *gp, double *relevance)
{
    int i, k;
    for (k = 0; gp && relevance && k < gp->m; ++k) {
        double sum = 0;
        for (i = 0; i < gp->n; ++i) {
            double d = (gp->x[(size_t)i * (size_t)gp->m + (size_t)k] - gp->center[k]) * gp->scale[k];
            sum += d * d;
        }
        relevance[k] = gp->n > 1 && gp->theta[k] < MS_GPR__DROPPED ? 2 * sum / (gp->n - 1) : 0;
    }
}

static double ms_gpr__floor_of(const ms_gpr *gp) { return ms_gpr__floor(gp->y, gp->n, gp->floor); }

MS_API ms_gpr_view ms_gpr_view_of(const ms_gpr *gp)
{
    ms_gpr_view view;
    memset(&view, 0, sizeof view);
    if (gp == NULL) return view;
    view.n = gp->n;
    view.m = gp->m;
    view.pair_count = gp->pair_count;
    view.x = gp->x;
    view.y = gp->y;
    view.value = gp->value;
    view.theta = gp->theta;
    view.pairs = gp->pairs;
    view.mean = gp->mean;
    view.floor = ms_gpr__floor_of(gp);
    view.floor_value = gp->floor > MS_GPR__NO_FLOOR ? gp->floor_value : view.floor;
    view.jitter = gp->jitter;
    view.level = gp->level;
    return view;
}

/* What the other n - 1 points say about each score: residual [n] = score - mean, variance [n] with noise. inverse:
   [padded n][stride] scratch. Rasmussen & Williams 2006, (5.10) to (5.12). Under Laplace's approximation scores stand
   for its pseudo-targets. */
static void ms_gpr__leave_one_out(const ms_gpr *gp, double *inverse, double *residual, double *variance)
{
    int padded = ms_gpr__padded(gp->n), i, j;
    memset(inverse, 0, (size_t)padded * gp->stride * sizeof *inverse);
    for (j = 0; j < gp->n; ++j) variance[j] = 0;
    ms_gpr__invert(gp->kernels, gp->upper, gp->stride, padded, inverse);
    for (i = 0; i < gp->n; ++i) { /* the diagonal of K'^-1 = Y'Y */
        const double *row = inverse + (size_t)i * gp->stride;
        for (j = 0; j <= i; ++j) variance[j] += row[j] * row[j];
    }
    for (i = 0; i < gp->n; ++i) {
        variance[i] = 1 / variance[i];
        residual[i] = gp->alpha[i] * variance[i];
    }
}

/* --- edits --- */

static double ms_gpr__distance2(const double *a, size_t a_spacing, const double *b, size_t b_spacing, int m)
{
    double sum = 0;
    int k;
    for (k = 0; k < m; ++k) {
        double d = a[(size_t)k * a_spacing] - b[(size_t)k * b_spacing];
        sum += d * d;
    }
    return sum;
}

MS_API ms_status ms_gpr_append(ms_gpr *gp, const double *x, double y, ms_error *error)
{
    ms_gpr *edited;
    ms_status status;
    if (gp == NULL) return ms_gpr__null("gp", error);
    status = ms_gpr__check_data(x, &y, 1, gp->m, error);
    if (status == MS_OK && gp->n >= MS_GPR__N_MAX)
        status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "the model already has %d points", gp->n);
    if (status == MS_OK) status = ms_gpr__edit(gp, 1, gp->pairs, gp->pair_count, &edited, error);
    if (status != MS_OK) return status;
    memcpy(edited->x + (size_t)gp->n * (size_t)gp->m, x, (size_t)gp->m * sizeof *x);
    edited->y[edited->n++] = y;
    return ms_gpr__commit(gp, edited, error);
}

static ms_status ms_gpr__check_index(const ms_gpr *gp, int index, ms_error *error)
{
    if (gp == NULL) return ms_gpr__null("gp", error);
    return index >= 0 && index < gp->n
        ? MS_OK
        : ms__fail(error, MS_INVALID_ARGUMENT, 0, "index is %d: expected 0 to %d", index, gp->n - 1);
}

MS_API ms_status ms_gpr_rescore(ms_gpr *gp, int index, double y, ms_error *error)
{
    ms_gpr *edited;
    ms_status status = ms_gpr__check_index(gp, index, error);
    if (status == MS_OK) status = ms_gpr__check_scores(&y, 1, error);
    if (status == MS_OK) status = ms_gpr__edit(gp, 0, gp->pairs, gp->pair_count, &edited, error);
    if (status != MS_OK) return status;
    edited->y[index] = y;
    return ms_gpr__commit(gp, edited, error);
}

MS_API ms_status ms_gpr_drop(ms_gpr *gp, int index, ms_error *error)
{
    ms_gpr *edited;
    ms_status status = ms_gpr__check_index(gp, index, error);
    size_t m, after;
    int i, j;
    if (status == MS_OK) status = ms_gpr__edit(gp, 0, gp->pairs, gp->pair_count, &edited, error);
    if (status != MS_OK) return status;
    m = (size_t)gp->m;
    after = (size_t)(gp->n - 1 - index);
    memmove(edited->x + (size_t)index * m, edited->x + ((size_t)index + 1) * m, after * m * sizeof *gp->x);
    memmove(edited->y + index, edited->y + index + 1, after * sizeof *gp->y);
    memmove(edited->alpha + index, edited->alpha + index + 1, after * sizeof *gp->alpha);
    edited->alpha[--edited->n] = 0;
    for (i = 0, j = 0; i < gp->pair_count; ++i) {
        int better = gp->pairs[2 * i], worse = gp->pairs[2 * i + 1];
        if (better == index || worse == index) continue;
        edited->pairs[2 * j] = better - (better > index);
        edited->pairs[2 * j++ + 1] = worse - (worse > index);
    }
    edited->pair_count = j;
    return ms_gpr__commit(gp, edited, error);
}

MS_API ms_status ms_gpr_compare(ms_gpr *gp, const double *x, int count, const int *pairs, int pair_count,
                                ms_error *error)
{
    ms_gpr *edited;
    ms_status status;
    size_t m;
    if (gp == NULL || (count > 0 && x == NULL)) return ms_gpr__null(gp ? "x" : "gp", error);
    m = (size_t)gp->m;
    if (count < 0 || count > MS_GPR__N_MAX - gp->n)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d: expected 0 to %d", count, MS_GPR__N_MAX - gp->n);
    status = ms_gpr__check_rows(x, count, gp->m, MS_GPR__LARGEST, "input", error);
    if (status == MS_OK) status = ms_gpr__check_pairs(pairs, pair_count, gp->n + count, error);
    if (status == MS_OK) status = ms_gpr__edit(gp, count, pairs, pair_count, &edited, error);
    if (status != MS_OK) return status;
    if (count > 0) memcpy(edited->x + (size_t)gp->n * m, x, (size_t)count * m * sizeof *x);
    while (edited->n < gp->n + count) edited->y[edited->n++] = MS_GPR_UNSCORED;
    return ms_gpr__commit(gp, edited, error);
}

/* ---- prediction ------------------------------------------------------------------------------------------------ */

/* One task: chunks of candidates task, task + tasks, ... */
typedef struct ms_gpr__batch {
    const ms_gpr *gp;
    const double *x; /* one of x and x_f */
    const float *x_f;
    int count, tasks;
    double *mean, *variance;
    float *mean_f;
    double *scratch; /* [tasks][task_doubles] */
    size_t task_doubles;
} ms_gpr__batch;

/* 64 candidates by dimension, in length scales; missing ones stand at the center. */
static int ms_gpr__chunk_scale(const ms_gpr__batch *b, int start, double *scaled)
{
    int filled = b->count - start < MS_GPR__CHUNK ? b->count - start : MS_GPR__CHUNK, j;
    memset(scaled, 0, (size_t)b->gp->active * MS_GPR__CHUNK * sizeof *scaled);
    for (j = 0; j < filled; ++j)
        ms_gpr__scale(b->gp, b->x + (size_t)(start + j) * (size_t)b->gp->m, scaled + j, MS_GPR__CHUNK);
    return filled;
}

static void ms_gpr__chunk_mean(const ms_gpr *gp, const double *scaled, double *tile, double *mean)
{
    int n = ms_gpr__padded(gp->n), i, j;
    for (j = 0; j < MS_GPR__CHUNK; ++j) mean[j] = 0;
    for (i = 0; i < n; i += MS_GPR__SLAB) {
        int rows = n - i < MS_GPR__SLAB ? n - i : MS_GPR__SLAB;
        gp->kernels->distances(tile, MS_GPR__CHUNK, gp->points + i, gp->stride, scaled, MS_GPR__CHUNK, rows,
                               MS_GPR__CHUNK, gp->active, 0);
        gp->kernels->accumulate(mean, tile, MS_GPR__CHUNK, gp->weight + i, rows, MS_GPR__CHUNK);
    }
}

/* sf^2 - |v|^2, v = U'^-1 k* */
static void ms_gpr__chunk_variance(const ms_gpr *gp, const double *scaled, double *columns, double *variance)
{
    double sf2 = ms_gpr__sf2(gp);
    int n = ms_gpr__padded(gp->n), i, j;
    gp->kernels->distances(columns, MS_GPR__CHUNK, gp->points, gp->stride, scaled, MS_GPR__CHUNK, n, MS_GPR__CHUNK,
                           gp->active, 0);
    gp->kernels->exponentials(columns, gp->n * MS_GPR__CHUNK, sf2);
    memset(columns + (size_t)gp->n * MS_GPR__CHUNK, 0, (size_t)(n - gp->n) * MS_GPR__CHUNK * sizeof *columns);
    ms_gpr__forward(gp->kernels, gp->upper, gp->stride, n, columns, MS_GPR__CHUNK, MS_GPR__CHUNK);
    for (j = 0; j < MS_GPR__CHUNK; ++j) variance[j] = sf2;
    for (i = 0; i < gp->n; ++i) {
        const double *v = columns + (size_t)i * MS_GPR__CHUNK;
        for (j = 0; j < MS_GPR__CHUNK; ++j) variance[j] -= v[j] * v[j];
    }
}

static void ms_gpr__predict_task(void *context, int task)
{
    const ms_gpr__batch *b = (const ms_gpr__batch *)context;
    double *scaled = b->scratch + (size_t)task * b->task_doubles,
           *tile = scaled + (size_t)b->gp->active * MS_GPR__CHUNK;
    double result[MS_GPR__CHUNK];
    int start, j;
    for (start = task * MS_GPR__CHUNK; start < b->count; start += b->tasks * MS_GPR__CHUNK) {
        int filled = ms_gpr__chunk_scale(b, start, scaled);
        if (b->mean) {
            ms_gpr__chunk_mean(b->gp, scaled, tile, result);
            for (j = 0; j < filled; ++j) b->mean[start + j] = b->gp->mean + result[j];
        }
        if (b->variance) {
            ms_gpr__chunk_variance(b->gp, scaled, tile, result);
            for (j = 0; j < filled; ++j) b->variance[start + j] = result[j] > 0 ? result[j] : 0;
        }
    }
}

static void ms_gpr__predict_task_f(void *context, int task)
{
    const ms_gpr__batch *b = (const ms_gpr__batch *)context;
    const ms_gpr *gp = b->gp;
    float *scaled = (float *)(void *)(b->scratch + (size_t)task * b->task_doubles),
          *tile = scaled + (size_t)gp->active * MS_GPR__CHUNK;
    float mean[MS_GPR__CHUNK];
    int n = ms_gpr__padded(gp->n), start, i, j, k;
    for (start = task * MS_GPR__CHUNK; start < b->count; start += b->tasks * MS_GPR__CHUNK) {
        int filled = b->count - start < MS_GPR__CHUNK ? b->count - start : MS_GPR__CHUNK;
        memset(scaled, 0, (size_t)gp->active * MS_GPR__CHUNK * sizeof *scaled);
        for (j = 0; j < filled; ++j) {
            const float *x = b->x_f + (size_t)(start + j) * (size_t)gp->m;
            for (k = 0; k < gp->active; ++k) {
                int d = gp->dimension[k];
                scaled[k * MS_GPR__CHUNK + j] = (float)(((double)x[d] - gp->center[d]) * gp->scale[d]);
            }
        }
        for (j = 0; j < MS_GPR__CHUNK; ++j) mean[j] = 0;
        for (i = 0; i < n; i += MS_GPR__SLAB) {
            int rows = n - i < MS_GPR__SLAB ? n - i : MS_GPR__SLAB;
            gp->kernels->distances_f(tile, MS_GPR__CHUNK, gp->points_f + i, gp->stride, scaled, MS_GPR__CHUNK, rows,
                                     MS_GPR__CHUNK, gp->active, 0);
            gp->kernels->accumulate_f(mean, tile, MS_GPR__CHUNK, gp->weight_f + i, rows, MS_GPR__CHUNK);
        }
        for (j = 0; j < filled; ++j) b->mean_f[start + j] = (float)(gp->mean + (double)mean[j]);
    }
}

/* Shares the chunks out to at most 16 tasks, each with its own scratch. */
static ms_status ms_gpr__predict_run(ms_gpr__batch *b, void (*task)(void *context, int index), ms_error *error)
{
    const ms_gpr *gp = b->gp;
    size_t rows = b->variance ? (size_t)ms_gpr__padded(gp->n) : 0;
    int chunks = (b->count - 1) / MS_GPR__CHUNK + 1;
    if (b->count == 0) return MS_OK;
    b->tasks = gp->parallel.run == NULL ? 1 : chunks < 16 ? chunks : 16;
    b->task_doubles = ms__size_mul(MS_GPR__CHUNK,
                                   (size_t)gp->active + (rows > MS_GPR__SLAB ? rows : (size_t)MS_GPR__SLAB));
    b->scratch = ms_gpr__scratch(&gp->allocator, ms__size_mul((size_t)b->tasks, b->task_doubles));
    if (b->scratch == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for predictions");
    ms__run(&gp->parallel, b->tasks, task, b);
    ms_gpr__release(&gp->allocator, b->scratch);
    return MS_OK;
}

MS_API ms_status ms_gpr_predict(const ms_gpr *gp, const double *x, int count, double *mean, double *variance,
                                ms_error *error)
{
    ms_gpr__batch b;
    ms_status status;
    if (gp == NULL || (count > 0 && x == NULL)) return ms_gpr__null(gp ? "x" : "gp", error);
    if (count < 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d: expected at least 0", count);
    status = ms_gpr__check_rows(x, count, gp->m, 1.7e308, "candidate", error);
    if (status != MS_OK) return status;
    memset(&b, 0, sizeof b);
    b.gp = gp;
    b.x = x;
    b.count = count;
    b.mean = mean;
    b.variance = variance;
    return ms_gpr__predict_run(&b, ms_gpr__predict_task, error);
}

/* ---- fit ------------------------------------------------------------------------------------------------------- */

typedef struct ms_gpr__ranked {
    double value;
    int index;
} ms_gpr__ranked;

static int ms_gpr__ranked_before(const ms_gpr__ranked *a, const ms_gpr__ranked *b)
{
    return a->value > b->value || (!(a->value < b->value) && a->index < b->index);
}

/* Largest value first, then smallest index, by insertion. */
static void ms_gpr__ranked_sort(ms_gpr__ranked *list, int count)
{
    int i, j;
    for (i = 1; i < count; ++i) {
        ms_gpr__ranked moved = list[i];
        for (j = i; j > 0 && ms_gpr__ranked_before(&moved, &list[j - 1]); --j) list[j] = list[j - 1];
        list[j] = moved;
    }
}

/* The values as a list whose front has the `first` largest, in no order (Hoare's selection, from the middle). */
static void ms_gpr__ranked_select(ms_gpr__ranked *list, const double *values, int count, int first)
{
    int low = 0, high = count - 1, at;
    for (at = 0; at < count; ++at) list[at].value = values[at], list[at].index = at;
    while (low < high) {
        ms_gpr__ranked pivot = list[low + (high - low) / 2], swap;
        int i = low, j = high;
        while (i <= j) {
            while (ms_gpr__ranked_before(&list[i], &pivot)) ++i;
            while (ms_gpr__ranked_before(&pivot, &list[j])) --j;
            if (i > j) break;
            swap = list[i];
            list[i++] = list[j];
            list[j--] = swap;
        }
        if (first <= j) high = j;
        else if (first >= i) low = i;
        else return;
    }
}

/* Log-normal priors of MAP: of l_k in widths, of sf and of sn in standard deviations of the scores. The prior of the
   noise is tight: a wide one lets a fit of few scores call all of them noise or none. More than MS_GPR__PRIOR_TAIL
   spreads above its mean the penalty is linear: scores that contradict each other are believed. */
static const double MS_GPR__PRIOR_LENGTH = 2.1; /* times sqrt(m) */
static const double MS_GPR__PRIOR_LENGTH_SPREAD = 1.5;
static const double MS_GPR__PRIOR_SF_SPREAD = 1.0;
static const double MS_GPR__PRIOR_SN = 0.5;
/* Comparisons alone tell only the ratio of sf and sn, few of them not even that: 0.7 over 0.5 is a person who orders
   four random pairs of five as they like them (1/2 + atan(ratio) / pi), one standard deviation 71% to 88%. */
static const double MS_GPR__PRIOR_SF_PAIRS = 0.7;
static const double MS_GPR__PRIOR_SF_PAIRS_SPREAD = 0.5;
static const double MS_GPR__PRIOR_SN_STEP = 1.5; /* of scores that come in steps */
static const double MS_GPR__PRIOR_SN_SPREAD = 0.25;
static const double MS_GPR__PRIOR_TAIL = 1.0;
static const double MS_GPR__FLOOR_OFFSET = 0.75; /* standard deviations that scores at the floor are taken below it */
enum { MS_GPR__OUTLIER_ROWS = 8 };               /* scores at least before one of them is an outlier */
static const double MS_GPR__OUTLIER_RANGES = 3.0;
static const double MS_GPR__OUTLIER_DEVIATIONS = 5.0;
enum {
    MS_GPR__PART =
        100 /* scores at least that the starts of a fit are tried on, and 4 m; a third of all, but at most 400 */
};

/* Scores that a search visited at: all of them, or a part. Targets have mean 0 and standard deviation 1. */
typedef struct ms_gpr__sample {
    ms_gpr__problem problem; /* with the observations of its scores and comparisons, where there are any */
    double *columns;         /* [m][stride] inputs in widths from their centers, by dimension */
} ms_gpr__sample;

/* The search over q = log l_k / width_k, log sf / s, log sn / s, s the standard deviation of the scores. */
typedef struct ms_gpr__fit {
    ms_gpr_fit_options o;                /* with the defaults filled in */
    int m, starts;                       /* columns that are not constant */
    ms_gpr__sample whole, part, *sample; /* sample: the one in use */
    int *column;                         /* [m] which column of x */
    double *width, *center;              /* [m] */
    double *low, *high;                  /* [m + 2] bounds of q */
    double *prior, *spread;              /* [m + 2] of MAP */
    double *q;                           /* [starts][m + 2]; the winner ends in the first row */
    double *theta;                       /* [columns of x + 2] what the model gets */
    ms_gpr__ranked *order;               /* [n + starts] */
    double *work;
    double mean, unit, floor, floor_value;
    int observations, scored; /* of all rows; 0 observations: every row has one exact score */
    int expected;             /* evaluations, about */
    ms_gpr_fit_report report;
} ms_gpr__fit;

/* Minus the log posterior (of ML: likelihood) and its gradient (NULL: not wanted). */
static int ms_gpr__fit_objective(void *context, const double *q, double *value, double *gradient)
{
    ms_gpr__fit *fit = (ms_gpr__fit *)context;
    ms_gpr__problem *p = &fit->sample->problem;
    const ms_progress *progress = &fit->o.progress;
    double likelihood;
    int i, k;
    if (progress->report &&
        progress->report(progress->user,
                         fit->report.evaluations < fit->expected ? (double)fit->report.evaluations / fit->expected
                                                                 : 1.0))
        return -1;
    ++fit->report.evaluations;
    for (k = 0; k < p->m; ++k) {
        const double *column = fit->sample->columns + (size_t)k * p->stride;
        double *row = p->points + (size_t)k * p->stride, scale = exp(-q[k]);
        for (i = 0; i < p->n; ++i) row[i] = column[i] * scale;
    }
    if (!ms_gpr__evaluate(p, exp(2 * q[p->m]), exp(2 * q[p->m + 1]), &likelihood, gradient)) return 0;
    *value = -likelihood;
    for (k = 0; k < p->m + 2; ++k) {
        if (gradient) gradient[k] = -gradient[k];
        if (fit->o.method == MS_GPR_METHOD_MAP) {
            double z = (q[k] - fit->prior[k]) / fit->spread[k], tail = k == p->m + 1 ? MS_GPR__PRIOR_TAIL : 1e9;
            double slope = z > tail ? tail : z;
            *value += slope * (z - 0.5 * slope);
            if (gradient) gradient[k] += slope / fit->spread[k];
        }
    }
    return 1;
}

/* The floor, what scores there are taken as, and what makes mean 0 and standard deviation 1 of them. 0: all scores are
   equal, and nothing was compared. */
static int ms_gpr__fit_scores(ms_gpr__fit *fit, const double *y, int n)
{
    double least, most, floor_score = -MS_GPR__OPEN, sum = 0, sum2 = 0;
    int i, pass, share = 0, scored = ms_gpr__score_range(y, n, &least, &most);
    if (scored == 0) least = most = 0;
    fit->scored = scored;
    fit->unit = fabs(most) > 0 ? fabs(most) : 1;
    fit->mean = 0.5 * (least + most);
    fit->floor = MS_GPR__NO_FLOOR;
    for (i = 0; i < n; ++i) { /* of scores in steps, what is within 1e-3 of a step is the same */
        if (!ms_gpr__scored(y[i]) || y[i] > least + (fit->o.step > 0 ? 1e-3 * fit->o.step : 0)) continue;
        ++share;
        if (y[i] > floor_score) floor_score = y[i];
    }
    if (fit->o.floor) fit->floor = *fit->o.floor;
    else if (share >= 2 && 8.0 * share >= scored && share < scored) fit->floor = floor_score;
    fit->floor_value = fit->floor;
    if (!(most - least > 1e-12 * (fabs(most) + fabs(least)))) return fit->o.pair_count > 0;
    for (pass = 0; pass < 2; ++pass) { /* of the scores, then of what they are taken as */
        for (i = 0, sum = sum2 = 0; i < n; ++i)
            if (ms_gpr__scored(y[i])) sum += (y[i] > fit->floor ? y[i] : fit->floor_value) / scored;
        for (i = 0; i < n; ++i) {
            double d = (y[i] > fit->floor ? y[i] : fit->floor_value) - sum;
            if (ms_gpr__scored(y[i])) sum2 += d * d / scored;
        }
        if (pass == 0 && fit->floor > MS_GPR__NO_FLOOR && fit->o.method == MS_GPR_METHOD_MAP)
            fit->floor_value -= MS_GPR__FLOOR_OFFSET * sqrt(sum2);
    }
    fit->mean = sum;
    fit->unit = sqrt(sum2);
    return 1;
}

/* The step of coarse scores: the difference of 2 to 6 values, evenly spaced to 1e-3 of it, of which those above the
   least were given 3 times or more on average; else 0. From 200 scores on, exact scores are as good and 3 times
   faster. */
static double ms_gpr__fit_step(const double *y, int n)
{
    double least, most;
    int scored = ms_gpr__score_range(y, n, &least, &most), count, i;
    if (scored < 20 || scored > 200 || !(most > least)) return 0;
    for (count = 2; count <= 6; ++count) {
        double step = (most - least) / (count - 1);
        int used = 0, above = 0; /* used: a bit a value */
        for (i = 0; i < n; ++i) {
            double steps = (y[i] - least) / step, whole = floor(steps + 0.5);
            if (!ms_gpr__scored(y[i])) continue;
            if (fabs(steps - whole) > 1e-3) break;
            used |= 1 << (int)whole;
            above += whole > 0;
        }
        if (i == n && used == (1 << count) - 1) return above < 3 * (count - 1) ? 0 : step;
    }
    return 0;
}

/* A value is an outlier of its column where it lies more ranges of the others away from them than any before. */
static void ms_gpr__fit_outlier_value(ms_gpr__fit *fit, int row, int column, double value, double nearest, double range)
{
    ms_gpr_outlier *o = &fit->report.outlier;
    double deviation = range > 0 ? (value - nearest) / range : 0;
    if (!(fabs(deviation) > MS_GPR__OUTLIER_RANGES) || (o->row >= 0 && !(fabs(deviation) > fabs(o->deviation)))) return;
    o->row = row;
    o->column = column;
    o->value = value;
    o->expected = nearest;
    o->deviation = deviation;
}

/* The score that the others contradict most, by leaving out one at a time. It is an outlier where no other one is
   half as far off, or where it is far outside the range of the others. */
static void ms_gpr__fit_outlier_score(ms_gpr__fit *fit, const ms_gpr *gp)
{
    double *residual = fit->whole.problem.target, *variance = fit->whole.problem.weight, first = 0, second = 0;
    double least = MS_GPR__OPEN, most = -MS_GPR__OPEN;
    int row = -1, above = 0, outside, i;
    if (fit->report.outlier.row >= 0 || fit->scored < MS_GPR__OUTLIER_ROWS) return;
    ms_gpr__leave_one_out(gp, fit->whole.problem.inverse, residual, variance);
    for (i = 0; i < gp->n; ++i) {
        double z = fabs(residual[i]) / sqrt(variance[i]);
        if (!ms_gpr__scored(gp->y[i])) continue;
        if (z > first) second = first, first = z, row = i;
        else if (z > second) second = z;
    }
    for (i = 0; i < gp->n; ++i) {
        if (i == row || !ms_gpr__scored(gp->y[i])) continue;
        if (gp->y[i] < least) least = gp->y[i], above = 0;
        if (gp->y[i] > most) most = gp->y[i];
    }
    for (i = 0; i < gp->n; ++i) above += i != row && gp->y[i] > least;
    if (row < 0 || above < 2) return; /* too few are liked to contradict one */
    outside = fmax(gp->y[row] - most, least - gp->y[row]) > MS_GPR__OUTLIER_RANGES * (most - least);
    if (!outside && !(first > MS_GPR__OUTLIER_DEVIATIONS && first > 2 * second && above > 3)) return;
    fit->report.outlier.row = row;
    fit->report.outlier.value = gp->y[row];
    fit->report.outlier.expected = fmin(fmax(gp->y[row] - residual[row], least), most);
    fit->report.outlier.deviation = residual[row] / sqrt(variance[row]);
}

/* Centers and widths of the columns that are not constant, but for rounding. */
static ms_status ms_gpr__fit_columns(ms_gpr__fit *fit, const double *x, int n, int m, ms_error *error)
{
    int i, k;
    for (k = 0, fit->m = 0; k < m; ++k) {
        const double *v = x + (n ? k : 0);
        double least = n ? *v : 0, most = least, sum = 0, sum2 = 0, largest, second[2] = {MS_GPR__OPEN, -MS_GPR__OPEN};
        int row[2] = {0, 0};
        for (i = 0; i < n; ++i, v += m) {
            if (i > 0 && *v < least) second[0] = least, least = *v, row[0] = i;
            else if (i > 0 && *v < second[0]) second[0] = *v;
            if (i > 0 && *v > most) second[1] = most, most = *v, row[1] = i;
            else if (i > 0 && *v > second[1]) second[1] = *v;
            sum += *v / n;
        }
        if (n >= MS_GPR__OUTLIER_ROWS) {
            ms_gpr__fit_outlier_value(fit, row[0], k, least, second[0], most - second[0]);
            ms_gpr__fit_outlier_value(fit, row[1], k, most, second[1], second[1] - least);
        }
        largest = fabs(least) > fabs(most) ? fabs(least) : fabs(most);
        if (!(most - least > 1e-10 * largest)) continue;
        if (most - least < 1 / MS_GPR__LARGEST)
            return ms__fail(error, MS_BAD_DATA, (size_t)k + 1, "column %d spans %g: expected more than %g; scale it",
                            k + 1, most - least, 1 / MS_GPR__LARGEST);
        for (i = 0, v = x + k; i < n; ++i, v += m) sum2 += (*v - sum) * (*v - sum) / n;
        fit->center[fit->m] = sum;
        fit->width[fit->m] = 3.4641016151377544 * sqrt(sum2); /* sqrt 12 */
        fit->column[fit->m++] = k;
    }
    return MS_OK;
}

/* Row `row` of the scores as row `to` of a sample. */
static void ms_gpr__fit_put_row(ms_gpr__fit *fit, ms_gpr__sample *sample, int to, const double *x, const double *y,
                                int row, int m)
{
    int k;
    for (k = 0; k < fit->m; ++k)
        sample->columns[(size_t)k * sample->problem.stride + (size_t)to] =
            (x[(size_t)row * (size_t)m + (size_t)fit->column[k]] - fit->center[k]) / fit->width[k];
    if (!sample->problem.observation)
        sample->problem.target[to] = ((y[row] > fit->floor ? y[row] : fit->floor_value) - fit->mean) / fit->unit;
    else if (sample == &fit->part) /* of steps alone: every row has a score */
        ms_gpr__observe_score(&sample->problem.observation[to], to, y[row], fit->floor, fit->floor_value, fit->o.step,
                              fit->mean, fit->unit);
}

/* Priors, bounds, and where the searches start; columns: of x. */
static void ms_gpr__fit_starts(ms_gpr__fit *fit, int columns)
{
    static const double lengths[] = {0.25, 0.5, 3}; /* widths, times sqrt(m) */
    const ms_gpr_fit_options *o = &fit->o;
    double root = sqrt((double)(fit->m > 0 ? fit->m : 1));
    int m = fit->m, i, k;
    for (k = 0; k < m; ++k) {
        fit->low[k] = log(0.01);
        fit->high[k] = log(1000.0);
        fit->prior[k] = log(MS_GPR__PRIOR_LENGTH * root);
        fit->spread[k] = MS_GPR__PRIOR_LENGTH_SPREAD;
    }
    fit->low[m] = fit->low[m + 1] = log(1e-3);
    fit->high[m] = log(1e3), fit->high[m + 1] = log(10.0);
    fit->prior[m] = fit->scored ? 0 : log(MS_GPR__PRIOR_SF_PAIRS);
    fit->spread[m] = fit->scored ? MS_GPR__PRIOR_SF_SPREAD : MS_GPR__PRIOR_SF_PAIRS_SPREAD;
    fit->prior[m + 1] = log(o->step > 0 ? MS_GPR__PRIOR_SN_STEP : MS_GPR__PRIOR_SN);
    fit->spread[m + 1] = MS_GPR__PRIOR_SN_SPREAD;
    for (i = 0; i < fit->starts; ++i) {
        double *q = fit->q + i * (m + 2);
        q[m] = o->start ? o->start[columns] - log(fit->unit) : 0;
        q[m + 1] = o->start ? o->start[columns + 1] - log(fit->unit) : -2.302585092994046; /* log 0.1 */
        for (k = 0; k < m; ++k) {
            if (o->start) q[k] = o->start[fit->column[k]] - log(fit->width[k]);
            else q[k] = log(o->length_start > 0 ? o->length_start : lengths[i] * root);
        }
    }
}

/* Tries every dimension alone at another length: one that matters is switched off, one that a start overlooked is
   switched on (length 1 width). What raises the posterior is kept. How many were switched; -1: cancelled. */
static int ms_gpr__fit_probe(ms_gpr__fit *fit, double *q, double value)
{
    int switched = 0,
        end = fit->o.probes > 0 && fit->o.probes < fit->m - fit->o.probe_first ? fit->o.probe_first + fit->o.probes
                                                                               : fit->m,
        k;
    for (k = fit->o.probe_first; k < end && fit->o.probes >= 0; ++k) {
        double before = q[k], trial;
        int defined;
        q[k] = before < 0.5 * fit->prior[k] ? fit->prior[k] : 0;
        defined = ms_gpr__fit_objective(fit, q, &trial, NULL);
        if (defined < 0) return -1;
        if (defined == 1 && trial < value) {
            value = trial;
            ++switched;
        } else {
            q[k] = before;
        }
    }
    fit->report.probes += switched;
    return switched;
}

/* The best of all starts, in q's first row. MAP: all run a little, the better half goes on, until one is left. ML: to
   the end. */
static ms_gpr__minimum ms_gpr__fit_race(ms_gpr__fit *fit, ms_gpr__search *s)
{
    size_t row = (size_t)s->count;
    int alive = fit->starts, budget = s->evaluations, halve = fit->o.method == MS_GPR_METHOD_MAP, i, j;
    ms_gpr__minimum found;
    found.stopped = 0;
    found.value = HUGE_VAL;
    for (i = 0; i < alive; ++i) fit->order[i].index = i;
    while (alive > 1) {
        s->evaluations = halve && budget > 24 ? 24 : budget;
        for (i = 0; i < alive; ++i) {
            ms_gpr__ranked done = fit->order[i];
            found = ms_gpr__minimize(s, fit->q + (size_t)done.index * row, fit->work);
            if (found.stopped) return found;
            done.value = found.value;
            for (j = i; j > 0 && fit->order[j - 1].value > done.value; --j) fit->order[j] = fit->order[j - 1];
            fit->order[j] = done;
        }
        alive = halve ? (alive + 1) / 2 : 1;
    }
    s->evaluations = budget;
    fit->report.start = fit->order[0].index;
    memmove(fit->q, fit->q + (size_t)fit->report.start * row, row * sizeof *fit->q);
    return found;
}

/* From q's first row to the end; MAP: probed, and again to the end if that found something. */
static ms_gpr__minimum ms_gpr__fit_polish(ms_gpr__fit *fit, const ms_gpr__search *s)
{
    ms_gpr__minimum found = ms_gpr__minimize(s, fit->q, fit->work);
    int switched = found.stopped || fit->o.method != MS_GPR_METHOD_MAP ? 0
                                                                       : ms_gpr__fit_probe(fit, fit->q, found.value);
    if (switched < 0) found.stopped = 1;
    return switched > 0 ? ms_gpr__minimize(s, fit->q, fit->work) : found;
}

/* The optimum, in q's first row. MAP: the race of the starts on a part of the scores and its winner's polish there,
   then a polish on all scores; dimensions are probed once, on all scores where those are few. */
static ms_gpr__minimum ms_gpr__fit_search(ms_gpr__fit *fit)
{
    ms_gpr__minimum found;
    ms_gpr__search s;
    double n = fit->whole.problem.n;
    int few = n * n * n * fit->m <
        4e8; /* probing all scores costs little then, and is misled less by a few wrong ones */
    memset(&s, 0, sizeof s);
    s.f = ms_gpr__fit_objective;
    s.context = fit;
    s.count = fit->m + 2;
    s.low = fit->low;
    s.high = fit->high;
    s.step = 4;
    s.tolerance = 1e-4;
    s.evaluations = fit->o.evaluations;
    fit->sample = fit->part.columns ? &fit->part : &fit->whole;
    found = ms_gpr__fit_race(fit, &s);
    if (found.stopped) return found;
    if (fit->sample == &fit->whole) return ms_gpr__fit_polish(fit, &s);
    found = few ? ms_gpr__minimize(&s, fit->q, fit->work) : ms_gpr__fit_polish(fit, &s);
    if (found.stopped) return found;
    s.tolerance = 0.1;
    if (s.evaluations > 1 + 9000 / (int)n) s.evaluations = n < 3000 ? 1 + 9000 / (int)n : 4; /* each takes n^3 */
    fit->sample = &fit->whole;
    return few ? ms_gpr__fit_polish(fit, &s) : ms_gpr__minimize(&s, fit->q, fit->work);
}

static ms_status ms_gpr__fit_options(const ms_gpr_fit_options *options, int m, ms_gpr_fit_options *o, ms_error *error)
{
    ms_status status;
    memset(o, 0, sizeof *o);
    if (options) *o = *options;
    status = ms_gpr__check_range("length_start", o->length_start, 0, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("step", o->step, -MS_GPR__LARGEST, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("method", (int)o->method, 0, (int)MS_GPR_METHOD_ML, error);
    if (status == MS_OK && o->floor)
        status = ms_gpr__check_range("floor", *o->floor, -MS_GPR__LARGEST, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("probe_first", o->probe_first, 0, MS_GPR__MOST, error);
    if (status == MS_OK) status = ms_gpr__check_range("evaluations", o->evaluations, 0, MS_GPR__MOST, error);
    if (status != MS_OK) return status;
    if (o->evaluations == 0) o->evaluations = 200;
    return o->start ? ms_gpr__check_theta(o->start, m, error) : MS_OK;
}

/* How many scores the starts race on; n: there is no race, or little to spare. */
static int ms_gpr__fit_part(const ms_gpr__fit *fit, int n, int m)
{
    int least = 4 * m > MS_GPR__PART ? 4 * m : MS_GPR__PART;
    if (fit->o.method == MS_GPR_METHOD_ML || fit->starts == 1 || fit->o.pair_count > 0 ||
        (fit->observations && fit->observations != n))
        return n;
    if (n / 2 < least) return n;
    if (n / 3 < least) return least;
    return n / 3 < 400 ? n / 3 : 400;
}

static void ms_gpr__fit_layout(ms_gpr__fit *fit, int n, int m, int part, ms__arena *arena)
{
    const ms_gpr__kernels *f = ms_gpr__kernels_of(ms_gpr__simd_pick(fit->o.simd));
    size_t row = (size_t)m + 2;
    ms_gpr__problem_layout(&fit->whole.problem, f, n, m, fit->observations, fit->o.pair_count, arena);
    fit->whole.columns = ms_gpr__take(arena, (size_t)m, ms_gpr__stride(n));
    fit->part.columns = NULL;
    if (part < n) {
        ms_gpr__problem_layout(&fit->part.problem, f, part, m, fit->observations ? part : 0, 0, arena);
        fit->part.columns = ms_gpr__take(arena, (size_t)m, ms_gpr__stride(part));
    }
    fit->work = ms_gpr__take(arena, ms_gpr__minimize_doubles(m + 2), 1);
    fit->q = ms_gpr__take(arena, row, (size_t)fit->starts);
    fit->low = ms_gpr__take(arena, row, 1);
    fit->high = ms_gpr__take(arena, row, 1);
    fit->prior = ms_gpr__take(arena, row, 1);
    fit->spread = ms_gpr__take(arena, row, 1);
    fit->width = ms_gpr__take(arena, row, 1);
    fit->center = ms_gpr__take(arena, row, 1);
    fit->theta = ms_gpr__take(arena, row, 1);
    fit->column = (int *)ms__take(arena, row, sizeof(int));
    fit->order = (ms_gpr__ranked *)ms__take(arena, (size_t)n + (size_t)fit->starts, sizeof *fit->order);
}

/* Samples, starts, search; then theta from what was found. */
static ms_status ms_gpr__fit_run(ms_gpr__fit *fit, const double *x, const double *y, int n, int m, int part,
                                 ms_error *error)
{
    ms_gpr__minimum found;
    ms_status status = ms_gpr__fit_columns(fit, x, n, m, error);
    int differ = ms_gpr__fit_scores(fit, y, n), i, k;
    ms_gpr__problem_clear(&fit->whole.problem);
    if (part < n) ms_gpr__problem_clear(&fit->part.problem);
    if (status == MS_OK && differ && fit->unit < 1 / MS_GPR__LARGEST)
        status = ms__fail(error, MS_BAD_DATA, 0, "the scores span about %g: expected more than %g; scale them",
                          fit->unit, 1 / MS_GPR__LARGEST);
    if (status != MS_OK) return status;
    fit->whole.problem.m = fit->part.problem.m = fit->report.columns = fit->m;
    for (i = 0; i < n; ++i) {
        fit->order[i].index = i;
        fit->order[i].value = y[i];
        ms_gpr__fit_put_row(fit, &fit->whole, i, x, y, i, m);
    }
    if (fit->observations)
        ms_gpr__observe_all(fit->whole.problem.observation, y, n, fit->floor, fit->floor_value, fit->o.step, fit->mean,
                            fit->unit, fit->o.pairs, fit->o.pair_count);
    if (part < n) { /* the better half of the part is the best of all; the rest evenly from what is left */
        int best = part / 2, left = part - best;
        ms_gpr__ranked_sort(fit->order, n);
        for (i = 0; i < part; ++i) {
            int rank = i < best ? i
                                : best + (int)((size_t)(2 * (i - best) + 1) * (size_t)(n - best) / (size_t)(2 * left));
            ms_gpr__fit_put_row(fit, &fit->part, i, x, y, fit->order[rank].index, m);
        }
    }
    ms_gpr__fit_starts(fit, m);
    memset(&found, 0, sizeof found);
    if (differ && fit->m > 0) found = ms_gpr__fit_search(fit);
    else if (fit->starts > 2) memcpy(fit->q, fit->q + 2 * (fit->m + 2), ((size_t)fit->m + 2) * sizeof *fit->q);
    if (found.stopped)
        return ms__fail(error, MS_CANCELLED, 0, "the fit was cancelled after %d evaluations", fit->report.evaluations);
    fit->report.objective = -found.value -
        (fit->o.step > 0 ? 0 : fit->scored) * log(fit->unit); /* of steps it is a probability */
    for (k = 0; k < m; ++k) fit->theta[k] = MS_GPR__DROPPED;
    for (k = 0; k < fit->m; ++k) fit->theta[fit->column[k]] = fit->q[k] + log(fit->width[k]);
    for (k = 0; k < 2; ++k) fit->theta[m + k] = fit->q[fit->m + k] + log(fit->unit);
    return MS_OK;
}

MS_API ms_status ms_gpr_fit(const double *x, const double *y, int n, int m, const ms_gpr_fit_options *options,
                            ms_gpr **out, ms_gpr_fit_report *report, ms_error *error)
{
    ms_gpr__fit fit;
    ms__arena arena = {NULL, 0};
    ms_status status;
    int part;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    memset(&fit, 0, sizeof fit);
    fit.report.outlier.row = fit.report.outlier.column = -1;
    status = ms_gpr__check_data(x, y, n, m, error);
    if (status == MS_OK) status = ms_gpr__fit_options(options, m, &fit.o, error);
    if (status == MS_OK) status = ms_gpr__check_pairs(fit.o.pairs, fit.o.pair_count, n, error);
    if (status != MS_OK) return status;
    if (fit.o.step < 0) fit.o.step = 0;
    else if (!(fit.o.step > 0) && fit.o.method == MS_GPR_METHOD_MAP) fit.o.step = ms_gpr__fit_step(y, n);
    fit.observations = ms_gpr__observe_all(NULL, y, n, 0, 0, fit.o.step, 0, 1, NULL, fit.o.pair_count);
    fit.starts = fit.o.start || fit.o.length_start > 0 ? 1 : 3;
    fit.expected = 30 * fit.starts + fit.o.evaluations / 2;
    part = ms_gpr__fit_part(&fit, n, m);
    ms_gpr__fit_layout(&fit, n, m, part, &arena);
    if (!ms_gpr__place(&fit.o.allocator, &arena))
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory to fit %d points of %d dimensions", n, m);
    ms_gpr__fit_layout(&fit, n, m, part, &arena);
    status = ms_gpr__fit_run(&fit, x, y, n, m, part, error);
    if (status == MS_OK) {
        ms_gpr like = ms_gpr__like(x, y, n, m, fit.theta, fit.o.simd, &fit.o.allocator);
        like.mean = fit.mean;
        like.parallel = fit.o.parallel;
        like.pairs = (int *)(uintptr_t)fit.o.pairs;
        like.pair_count = fit.o.pair_count;
        like.floor = fit.floor;
        like.floor_value = fit.floor_value;
        like.step = fit.o.step;
        for (part = 0; fit.observations && part < n; ++part) fit.whole.problem.alpha[part] /= fit.unit;
        if (fit.observations) like.alpha = fit.whole.problem.alpha;
        status = ms_gpr__make(&like, out, error);
    }
    if (status == MS_OK && report) {
        ms_gpr__fit_outlier_score(&fit, *out);
        *report = fit.report;
        report->likelihood = (*out)->soft ? (*out)->likelihood : ms_gpr__likelihood_of(*out);
    }
    ms_gpr__release(&fit.o.allocator, arena.base);
    return status;
}

/* ---- search space ----------------------------------------------------------------------------------- */

/* A round range that holds column k of the rows of x: [0, 1] or another unit's, or steps of 1, 2 or 5 times a power of
   ten. A locked column, equal in 8 rows or more, keeps its value. */
static void ms_gpr__natural_range(const double *x, int n, int m, int k, double *low, double *high)
{
    static const double unit[][2] = {{0, 1}, {-1, 1}, {0, 100}, {0, 255}, {0, 360}, {-180, 180}};
    double least = 0, most = 1, step;
    int i;
    for (i = 0; i < n; ++i) {
        double v = x[(size_t)i * (size_t)m + (size_t)k];
        if (i == 0 || v < least) least = v;
        if (i == 0 || v > most) most = v;
    }
    *low = least;
    *high = most;
    if (n >= 8 && !(most > least)) return;
    for (i = 0; i < 6; ++i) /* [0, 1] holds any such values; another unit's those that fill most of it */
        if (least >= unit[i][0] && most <= unit[i][1] && (i == 0 || most - least > 0.8 * (unit[i][1] - unit[i][0]))) {
            *low = unit[i][0];
            *high = unit[i][1];
            return;
        }
    if (!(most > least)) return;
    step = pow(10, floor(log10((most - least) / 8)));
    step *= 5 * step <= (most - least) / 8 ? 5 : 2 * step <= (most - least) / 8 ? 2 : 1;
    *low = step * floor(least / step);
    *high = step * ceil(most / step);
}

/* Uniform in (0, 1), 32 bits. */
static double ms_gpr__uniform(ms__rng *rng) { return (ms__rng_u32(rng) + 0.5) * (1.0 / 4294967296.0); }

static double ms_gpr__clamp(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

/* A list without its rows outside the box. */
typedef struct ms_gpr__group {
    int width, count, idle; /* idle: the model does not depend on its columns */
    int *column;            /* [width] */
    double *rows;           /* [count][width] */
} ms_gpr__group;

/* A ms_gpr_space made ready: a material in the box has a point in the unit box. */
typedef struct ms_gpr__space {
    int m, groups, tied;       /* tied: some columns are equal */
    double *low, *width, *per; /* [m] the box, in units of x, and 1 / width or 0 */
    double *step, *cells;      /* [m] a step and how many values there are; 0: continuous */
    int *lead;                 /* [m] the first of the columns that are equal to this one; itself: it is free */
    int *owner;                /* [m] which list the column is from, counted from 1, or 0 */
    ms_gpr__group *group;
    ms_allocator allocator;
    void *memory;
} ms_gpr__space;

static void ms_gpr__space_layout(ms_gpr__space *s, const ms_gpr_space *wish, ms__arena *arena)
{
    size_t m = (size_t)s->m;
    int g;
    s->low = ms_gpr__take(arena, m, 1);
    s->width = ms_gpr__take(arena, m, 1);
    s->per = ms_gpr__take(arena, m, 1);
    s->step = ms_gpr__take(arena, m, 1);
    s->cells = ms_gpr__take(arena, m, 1);
    s->lead = (int *)ms__take(arena, m, sizeof(int));
    s->owner = (int *)ms__take(arena, m, sizeof(int));
    s->group = (ms_gpr__group *)ms__take(arena, (size_t)wish->list_count, sizeof *s->group);
    for (g = 0; g < wish->list_count; ++g) {
        size_t width = (size_t)wish->lists[g].width;
        int *column = (int *)ms__take(arena, width, sizeof(int));
        double *rows = ms_gpr__take(arena, ms__size_mul(width, (size_t)wish->lists[g].count), 1);
        if (arena->base == NULL) continue;
        s->group[g].column = column;
        s->group[g].rows = rows;
    }
}

static int ms_gpr__space_continuous(const ms_gpr__space *s, int k)
{
    return s->width[k] > 0 && !(s->cells[k] > 0) && s->owner[k] == 0;
}

/* Equal columns take the values of their lead: of a point, or of a direction. */
static void ms_gpr__space_follow(const ms_gpr__space *s, double *v)
{
    int k;
    for (k = 0; k < s->m && s->tied; ++k) v[k] = v[s->lead[k]];
}

/* Whether other columns are equal to column k, the first of them. */
static int ms_gpr__space_leads(const ms_gpr__space *s, int k)
{
    int i, followers = 0;
    for (i = k + 1; i < s->m && s->tied; ++i) followers += s->lead[i] == k;
    return s->lead[k] == k ? followers : 0;
}

/* A uniform value of parameter k, in the unit box. */
static double ms_gpr__space_uniform_column(const ms_gpr__space *s, int k, ms__rng *rng)
{
    double u = ms_gpr__uniform(rng);
    return s->cells[k] > 0 ? floor(u * s->cells[k]) * s->step[k] / s->width[k] : u;
}

/* Row `row` of a list takes its point. */
static void ms_gpr__group_put(const ms_gpr__space *s, const ms_gpr__group *g, int row, double *point)
{
    int i;
    for (i = 0; i < g->width; ++i) {
        int k = g->column[i];
        point[k] = (g->rows[(size_t)row * (size_t)g->width + (size_t)i] - s->low[k]) * s->per[k];
    }
}

/* The row of a list that is nearest to a point. */
static int ms_gpr__group_nearest(const ms_gpr__space *s, const ms_gpr__group *g, const double *point)
{
    double least = 0;
    int best = -1, row, i;
    for (row = 0; row < g->count; ++row) {
        double sum = 0;
        for (i = 0; i < g->width; ++i) {
            int k = g->column[i];
            double d = (g->rows[(size_t)row * (size_t)g->width + (size_t)i] - s->low[k]) * s->per[k] - point[k];
            sum += d * d;
        }
        if (best >= 0 && !(sum < least)) continue;
        best = row;
        least = sum;
    }
    return best;
}

/* The material at a point that keeps everything; values of a list are its own to the bit. */
static void ms_gpr__space_material(const ms_gpr__space *s, const double *point, double *x)
{
    int k, i, g;
    for (k = 0; k < s->m; ++k) {
        double offset = s->width[k] * point[k];
        x[k] = s->low[k] + (s->cells[k] > 0 ? s->step[k] * floor(offset / s->step[k] + 0.5) : offset);
    }
    for (g = 0; g < s->groups; ++g) {
        const ms_gpr__group *list = &s->group[g];
        const double *row = list->rows + (size_t)ms_gpr__group_nearest(s, list, point) * (size_t)list->width;
        for (i = 0; i < list->width; ++i) x[list->column[i]] = row[i];
    }
}

/* The direction from one row of a list to another. */
static void ms_gpr__group_direction(const ms_gpr__space *s, const ms_gpr__group *g, int from, int to, double *direction)
{
    int i;
    memset(direction, 0, (size_t)s->m * sizeof *direction);
    for (i = 0; i < g->width; ++i)
        direction[g->column[i]] = (g->rows[(size_t)to * (size_t)g->width + (size_t)i] -
                                   g->rows[(size_t)from * (size_t)g->width + (size_t)i]) *
            s->per[g->column[i]];
}

/* The part t0 <= 0 <= t1 of a line that lies in the box. */
static void ms_gpr__space_chord(const ms_gpr__space *s, const double *point, const double *direction, double *t0,
                                double *t1)
{
    int k;
    *t0 = -1e300;
    *t1 = 1e300;
    for (k = 0; k < s->m; ++k) {
        double d = direction[k], back, ahead, per;
        if (!(d < 0 || d > 0)) continue;
        per = 1 / d;
        back = (d > 0 ? -point[k] : 1 - point[k]) * per;
        ahead = (d > 0 ? 1 - point[k] : -point[k]) * per;
        if (back > *t0) *t0 = back;
        if (ahead < *t1) *t1 = ahead;
    }
}

/* How many steps t0 to t1 there are to other values of column k, which comes in steps, where the chord allows t0 to
   t1. */
static void ms_gpr__space_steps(const ms_gpr__space *s, int k, const double *point, double *t0, double *t1)
{
    double step = s->step[k] / s->width[k], own = floor(point[k] / step + 0.5);
    *t0 = fmax(-own, ceil(*t0 / step - 1e-9));
    *t1 = fmin(s->cells[k] - 1 - own, floor(*t1 / step + 1e-9));
}

/* A uniform point of the unit box that satisfies everything. */
static void ms_gpr__space_uniform(const ms_gpr__space *s, double *point, ms__rng *rng)
{
    int k, g;
    for (k = 0; k < s->m; ++k)
        if (s->owner[k] == 0) point[k] = ms_gpr__space_uniform_column(s, k, rng);
    for (g = 0; g < s->groups; ++g)
        ms_gpr__group_put(s, &s->group[g], (int)(ms_gpr__uniform(rng) * s->group[g].count), point);
    ms_gpr__space_follow(s, point);
}

/* Moves a point, of the unit box or not, to a near one that keeps everything. */
static void ms_gpr__space_project(const ms_gpr__space *s, double *point)
{
    int k, i, g;
    for (k = 0; k < s->m; ++k) { /* equal columns meet in their mean */
        double sum = point[k];
        int followers = ms_gpr__space_leads(s, k);
        for (i = k + 1; i < s->m && followers; ++i) sum += s->lead[i] == k ? point[i] : 0;
        if (followers) point[k] = sum / (followers + 1);
    }
    ms_gpr__space_follow(s, point);
    for (k = 0; k < s->m; ++k) {
        point[k] = s->width[k] > 0 ? ms_gpr__clamp(point[k], 0, 1) : 0;
        if (s->cells[k] > 0)
            point[k] = fmin(floor(point[k] * s->width[k] / s->step[k] + 0.5), s->cells[k] - 1) * s->step[k] /
                s->width[k];
    }
    for (g = 0; g < s->groups; ++g)
        ms_gpr__group_put(s, &s->group[g], ms_gpr__group_nearest(s, &s->group[g], point), point);
}

/* wish[k], where it is given and not infinite. */
static double ms_gpr__given(const double *wish, int k, double sign, double otherwise)
{
    return wish == NULL || (!ms__finite(wish[k]) && sign * wish[k] > 0) ? otherwise : wish[k];
}

/* The rows of the lists that lie in the box, and the box of those. */
static ms_status ms_gpr__space_lists(ms_gpr__space *s, const ms_gpr_space *wish, ms_error *error)
{
    int g, i, row, k;
    s->groups = wish->list_count;
    for (g = 0; g < s->groups; ++g) {
        const ms_gpr_list *list = &wish->lists[g];
        ms_gpr__group *to = &s->group[g];
        size_t width = (size_t)list->width;
        to->width = list->width;
        to->count = 0;
        for (row = 0; row < list->count; ++row) {
            const double *from = list->rows + (size_t)row * width;
            int fits = 1;
            for (i = 0; i < list->width; ++i) {
                double low, high, slack;
                k = list->columns[i];
                low = ms_gpr__given(wish->low, k, -1, -MS_GPR__LARGEST);
                high = ms_gpr__given(wish->high, k, 1, MS_GPR__LARGEST);
                slack = 1e-12 * fabs(from[i]);
                fits &= from[i] >= low - slack && from[i] <= high + slack;
            }
            if (fits) memcpy(to->rows + (size_t)to->count++ * width, from, width * sizeof *from);
        }
        if (to->count == 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                            "list %d contradicts the box: none of its %d rows lies there", g + 1, list->count);
        for (i = 0; i < list->width; ++i) {
            double low = to->rows[i], high = to->rows[i];
            k = to->column[i] = list->columns[i];
            if (s->owner[k] > 0)
                return ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter %d is in list %d and in list %d", k,
                                s->owner[k], g + 1);
            if (s->step[k] > 0)
                return ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter %d is in list %d and comes in steps", k,
                                g + 1);
            for (row = 1; row < to->count; ++row) {
                low = fmin(low, to->rows[(size_t)row * width + (size_t)i]);
                high = fmax(high, to->rows[(size_t)row * width + (size_t)i]);
            }
            s->owner[k] = g + 1;
            s->low[k] = low;
            s->width[k] = high - low;
        }
    }
    return MS_OK;
}

/* Which columns are equal; they share the range that all of them allow. */
static ms_status ms_gpr__space_equal(ms_gpr__space *s, const ms_gpr_space *wish, ms_error *error)
{
    int i, k;
    for (i = 0; i < wish->equal_count; ++i) {
        int a = wish->equal[2 * i], b = wish->equal[2 * i + 1], first, second;
        double low, high;
        if (a < 0 || a >= s->m || b < 0 || b >= s->m)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "columns %d and %d are to be equal: expected 0 to %d", a, b,
                            s->m - 1);
        first = s->lead[a] < s->lead[b] ? s->lead[a] : s->lead[b];
        second = s->lead[a] < s->lead[b] ? s->lead[b] : s->lead[a];
        if (first == second) continue;
        if (s->owner[first] || s->owner[second] ||
            (s->step[first] > 0 && s->step[second] > 0 && fabs(s->step[first] - s->step[second]) > 0))
            return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                            "columns %d and %d are to be equal, but are in a list or come in different steps", a, b);
        low = fmax(s->low[first], s->low[second]);
        high = fmin(s->low[first] + s->width[first], s->low[second] + s->width[second]);
        if (high < low)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                            "columns %d and %d are to be equal, but no value is in both ranges", a, b);
        s->low[first] = low;
        s->width[first] = high - low;
        s->step[first] = fmax(s->step[first], s->step[second]);
        s->tied = 1;
        for (k = 0; k < s->m; ++k)
            if (s->lead[k] == second) s->lead[k] = first;
    }
    for (k = 0; k < s->m; ++k)
        s->low[k] = s->low[s->lead[k]], s->width[k] = s->width[s->lead[k]], s->step[k] = s->step[s->lead[k]];
    return MS_OK;
}

static void ms_gpr__space_free(ms_gpr__space *s) { ms_gpr__release(&s->allocator, s->memory); }

/* x [n][m]: what the box is made of where wish has none. On success to be freed. */
static ms_status ms_gpr__space_make(const double *x, int n, int m, const ms_gpr_space *wish,
                                    const ms_allocator *allocator, ms_gpr__space *s, ms_error *error)
{
    ms__arena arena = {NULL, 0};
    ms_status status = MS_OK;
    int k, g, i;
    if (wish->list_count < 0 || wish->list_count > 10000 || wish->equal_count < 0 || wish->equal_count > 10000)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "list_count is %d and equal_count %d: expected 0 to 10000",
                        wish->list_count, wish->equal_count);
    if (wish->equal_count > 0 && wish->equal == NULL) return ms_gpr__null("equal", error);
    if (wish->list_count > 0 && wish->lists == NULL) return ms_gpr__null("lists", error);
    for (g = 0; g < wish->list_count && status == MS_OK; ++g) {
        const ms_gpr_list *list = &wish->lists[g];
        if (list->columns == NULL || list->rows == NULL)
            return ms_gpr__null(list->columns ? "rows of a list" : "columns of a list", error);
        if (list->width < 1 || list->width > m || list->count < 1 || list->count > 10000000)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                            "list %d has %d columns and %d rows: expected 1 to %d, and 1 to 10000000", g + 1,
                            list->width, list->count, m);
        for (i = 0; i < list->width; ++i)
            if (list->columns[i] < 0 || list->columns[i] >= m)
                return ms__fail(error, MS_INVALID_ARGUMENT, 0, "list %d has column %d: expected 0 to %d", g + 1,
                                list->columns[i], m - 1);
        status = ms_gpr__check_rows(list->rows, list->count, list->width, MS_GPR__LARGEST, "row of a list", error);
    }
    for (k = 0; wish->steps && k < m && status == MS_OK; ++k)
        if (!ms__finite(wish->steps[k]) || !(wish->steps[k] >= 0 && wish->steps[k] <= MS_GPR__LARGEST))
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "steps[%d] is %g: expected a number of at least 0", k,
                            wish->steps[k]);
    if (status != MS_OK) return status;
    memset(s, 0, sizeof *s);
    s->m = m;
    s->allocator = *allocator;
    ms_gpr__space_layout(s, wish, &arena);
    if (!ms_gpr__place(&s->allocator, &arena))
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the constraints of %d parameters", m);
    s->memory = arena.base;
    ms_gpr__space_layout(s, wish, &arena);
    memset(s->owner, 0, (size_t)m * sizeof *s->owner);
    for (k = 0; k < m && status == MS_OK; ++k) {
        double a, b;
        s->lead[k] = k;
        ms_gpr__natural_range(x, n, m, k, &a, &b);
        a = ms_gpr__given(wish->low, k, -1, a);
        b = ms_gpr__given(wish->high, k, 1, b);
        if (!ms__finite(a) || !ms__finite(b) || !(fabs(a) <= MS_GPR__LARGEST) || !(fabs(b) <= MS_GPR__LARGEST) || b < a)
            status = ms__fail(error, MS_INVALID_ARGUMENT, 0,
                              "the box of dimension %d is [%g, %g]: expected low <= high", k, a, b);
        s->low[k] = a;
        s->width[k] = b - a;
        s->step[k] = wish->steps && b > a ? wish->steps[k] : 0;
    }
    if (status == MS_OK) status = ms_gpr__space_lists(s, wish, error);
    if (status == MS_OK) status = ms_gpr__space_equal(s, wish, error);
    for (k = 0; k < m; ++k) {
        s->cells[k] = s->step[k] > 0 ? floor(s->width[k] / s->step[k] + 1e-9) + 1 : 0;
        if (s->cells[k] > 0 && s->cells[k] < 2) s->cells[k] = s->width[k] = 0;
        s->per[k] = s->width[k] > 0 ? 1 / s->width[k] : 0;
    }
    if (status != MS_OK) ms_gpr__space_free(s);
    return status;
}

/* ---- recommendation -------------------------------------------------------------------------------------------- */

/* Candidates come in batches and chains in groups, each batch and each chain with a random stream of its own: the
   number of threads changes nothing. */
enum {
    MS_GPR__BATCH = 1024,      /* uniform candidates a task */
    MS_GPR__BATCHES = 16,      /* tasks a wave */
    MS_GPR__PILOT = 8,         /* batches that are looked at first */
    MS_GPR__TASKS = 16,        /* of a level of subset simulation, and of a wave of recommendations */
    MS_GPR__WAVE = 64,         /* recommendations that are looked for together */
    MS_GPR__POPULATION = 1024, /* points a level where there is one mode, */
    MS_GPR__CROWD = 4096,      /* and where there are several: their shares drift from level to level */
    MS_GPR__LEVEL_SHARE = 4,   /* one in so many lies above the next level */
    MS_GPR__LEVELS = 500,
    MS_GPR__MODES = 16 /* ascents that look for the largest mean */
};
static const double MS_GPR__INFORMATIVE =
    0.3; /* length scales in the box's width from which on the mean depends on a column */
static const double MS_GPR__GIVE_UP = 1e7; /* predictions by rejection, at most */
enum { MS_GPR__RARE = 50 }; /* candidates that cost about as much as one recommendation of subset simulation */

/* A point in the unit box, what the mean there needs, and a step to go. */
typedef struct ms_gpr__chain {
    double *point;      /* [m] in the unit box */
    double *direction;  /* [m] in widths of the box, of dimensions in use */
    double *scaled;     /* [active] the point in length scales */
    double *step;       /* [active] the direction in length scales */
    double *low, *high; /* [m] of a hyperrectangle */
    void *d2, *slope;   /* [stride] as in ms_gpr__lines */
    double *kernel;     /* [stride] */
    double curvature;
    int axis;     /* of those in use, along which it faces; -1: along the direction */
    double value; /* the mean there */
} ms_gpr__chain;

/* The sampler: what all tasks of one call share. */
typedef struct ms_gpr__sampler {
    const ms_gpr *gp;
    ms_gpr_recommend_options o; /* with the defaults filled in */
    const ms_gpr__lines *lines; /* of single precision, where that is good enough for this model */
    const void *points, *weight;
    int count, taken, wave; /* wanted, with those to be skipped; found; of the wave that runs */
    double *result;         /* [count][m] what was found */
    double *rivals;         /* [16][m] candidates for the next one, */
    int rival_count;        /* and how many there are */
    ms_gpr__space s;
    double *unit;     /* [active] length scales in the box's width */
    int *flat, flats; /* [m] columns that the mean hardly depends on, continuous */
    int *coordinate,
        coordinates;   /* what slices go along: a dimension in use; active + a column that others are equal to; active
                + m + a list */
    double goal;       /* the threshold, and a margin for the rounding of means that chains sum up */
    double level;      /* what chains must not fall below */
    double *candidate; /* [BATCHES * BATCH][m] of a wave, in units of x */
    float *candidate_f;
    double *mean; /* [BATCHES * BATCH + n] */
    float *mean_f;
    double *scratch; /* [BATCHES] of the prediction */
    size_t scratch_size;
    ms_gpr__ranked *ranked; /* [BATCHES * BATCH + n] */
    ms_gpr__chain chain[MS_GPR__TASKS];
    double *mode; /* [MODES][m] */
    double mode_value[MS_GPR__MODES];
    double *point, *next; /* [PILOT * BATCH][m] population in the unit box, and the one of the next level */
    double *value;        /* [PILOT * BATCH] of the population, */
    double *next_value;
    int level_size;        /* points of a level */
    int population, *seed; /* [CROWD] points where the chains of a level start */
    int seeds, turn;
    double *scale;   /* [m] how far to go across; 0: only along the axis */
    uint64_t stream; /* of the wave's first batch or chain */
    ms_gpr_recommend_report report;
} ms_gpr__sampler;

/* --- a chain --- */

/* Computes the squared distances from the point to all training points. */
static void ms_gpr__chain_distances(const ms_gpr__sampler *h, const ms_gpr__lines *lines, const void *points,
                                    ms_gpr__chain *w)
{
    const ms_gpr *gp = h->gp;
    int k, d;
    for (k = 0; k < gp->active; ++k) {
        d = gp->dimension[k];
        w->scaled[k] = (h->s.low[d] + h->s.width[d] * w->point[d] - gp->center[d]) * gp->scale[d];
    }
    lines->distances(w->d2, points, gp->stride, w->scaled, gp->active, ms_gpr__padded(gp->n));
}

/* Prepares means along the direction: they are functions of t alone then. */
static void ms_gpr__chain_slopes(const ms_gpr__sampler *h, const ms_gpr__lines *lines, const void *points,
                                 ms_gpr__chain *w)
{
    const ms_gpr *gp = h->gp;
    int k;
    w->axis = -1;
    w->curvature = 0;
    for (k = 0; k < gp->active; ++k) {
        w->step[k] = h->unit[k] * w->direction[gp->dimension[k]];
        w->curvature += w->step[k] * w->step[k];
    }
    lines->slopes(w->slope, points, gp->stride, w->scaled, w->step, gp->active, ms_gpr__padded(gp->n));
}

static void ms_gpr__chain_step(const ms_gpr__sampler *h, const ms_gpr__lines *lines, ms_gpr__chain *w, double t)
{
    const ms_gpr *gp = h->gp;
    int k, first = w->axis < 0 ? 0 : w->axis, end = w->axis < 0 ? gp->active : first + 1;
    for (k = first; k < end; ++k) {
        int d = gp->dimension[k];
        double p = w->point[d] + t * (w->axis < 0 ? w->direction[d] : 1);
        w->point[d] = p < 1e-12 ? 0 : p > 1 - 1e-12 ? 1 : p;
        w->scaled[k] += t * w->step[k];
    }
    lines->advance(w->d2, w->slope, t, w->curvature, ms_gpr__padded(gp->n));
}

/* Uphill to a maximum of the mean, for at most `steps` steps: along the gradient in length scales, which points like a
   mean shift to sum_i weight_i k_i (x_i - x), less the components that would leave the box. Lists stay
   as they are. */
static void ms_gpr__chain_ascend(const ms_gpr__sampler *h, ms_gpr__chain *w, int steps)
{
    const ms_gpr *gp = h->gp;
    const ms_gpr__lines *lines = &gp->kernels->lines;
    double reach = 0.5;
    int n = ms_gpr__padded(gp->n), i, k;
    for (; steps >= 0; --steps) {
        double total, norm2 = 0, t0, t1, t, ahead, farther;
        int halvings = 0;
        ms_gpr__chain_distances(h, lines, gp->points, w);
        memcpy(w->kernel, w->d2, (size_t)n * sizeof *w->kernel);
        gp->kernels->exponentials(w->kernel, n, 1);
        for (i = 0, total = 0; i < n; ++i) total += w->kernel[i] *= gp->weight[i];
        w->value = gp->mean + total;
        if (steps == 0) return;
        memset(w->direction, 0, (size_t)gp->m * sizeof *w->direction);
        memset(w->low, 0, (size_t)gp->m * sizeof *w->low);
        memset(w->high, 0, (size_t)gp->m * sizeof *w->high);
        for (k = 0; k < gp->active; ++k) {
            int d = gp->dimension[k];
            double p = w->point[d], g;
            if (h->s.owner[d] > 0 || !(h->unit[k] > 0)) continue;
            g = gp->kernels->dot(w->kernel, gp->points + (size_t)k * gp->stride, n) - total * w->scaled[k];
            if (!(g < 0 && p <= 0) && !(g > 0 && p >= 1)) w->direction[d] = g / h->unit[k];
            w->low[h->s.lead[d]] += g * h->unit[k]; /* the slope of equal columns together, and of what metric */
            w->high[h->s.lead[d]] += h->unit[k] * h->unit[k];
        }
        for (k = 0; k < gp->m; ++k) {
            if (!ms_gpr__space_leads(&h->s, k)) continue;
            w->direction[k] = w->high[k] > 0 ? w->low[k] / w->high[k] : 0;
            if ((w->low[k] < 0 && w->point[k] <= 0) || (w->low[k] > 0 && w->point[k] >= 1)) w->direction[k] = 0;
        }
        ms_gpr__space_follow(&h->s, w->direction);
        for (k = 0; k < gp->active; ++k)
            norm2 += h->unit[k] * w->direction[gp->dimension[k]] * (h->unit[k] * w->direction[gp->dimension[k]]);
        if (!(norm2 > 0)) return;
        for (k = 0; k < gp->m; ++k) w->direction[k] /= sqrt(norm2);
        ms_gpr__chain_slopes(h, lines, gp->points, w);
        ms_gpr__space_chord(&h->s, w->point, w->direction, &t0, &t1);
        t = reach < t1 ? reach : t1;
        ahead = gp->mean + lines->mean(w->d2, w->slope, t, w->curvature, gp->weight, n);
        while (!(ahead > w->value) && halvings++ < 20)
            ahead = gp->mean + lines->mean(w->d2, w->slope, t *= 0.5, w->curvature, gp->weight, n);
        if (!(ahead > w->value)) return;
        while (halvings == 0 && 2 * t < t1 &&
               (farther = gp->mean + lines->mean(w->d2, w->slope, 2 * t, w->curvature, gp->weight, n)) > ahead) {
            t *= 2;
            ahead = farther;
        }
        if (ahead - w->value < 1e-7 * (fabs(ahead) + fabs(w->value))) steps = 1;
        ms_gpr__chain_step(h, lines, w, t);
        reach = 2 * t;
    }
}

/* Moves by t along the line if the mean there is above the level. */
static int ms_gpr__chain_try(const ms_gpr__sampler *h, ms_gpr__chain *w, double t)
{
    double mean = h->gp->mean + h->lines->mean(w->d2, w->slope, t, w->curvature, h->weight, ms_gpr__padded(h->gp->n));
    if (!(mean >= h->level)) return 0;
    ms_gpr__chain_step(h, h->lines, w, t);
    w->value = mean;
    return 1;
}

/* Neal's slice step along the line that the chain faces: a uniform point of the chord; while it lies outside the
   region, the chord shrinks towards the chain. The uniform distribution over the region is left as it is. A column k
   that comes in steps is a row of cells, and the chain somewhere in its own. k < 0: across several. */
static void ms_gpr__chain_slice(const ms_gpr__sampler *h, ms_gpr__chain *w, int k, ms__rng *rng)
{
    double cells = k < 0 ? 0 : h->s.cells[k], step = cells > 0 ? h->s.step[k] / h->s.width[k] : 0, t0, t1, offset = 0;
    int tries;
    if (w->axis < 0) {
        ms_gpr__space_chord(&h->s, w->point, w->direction, &t0, &t1);
    } else {
        t0 = -w->point[k];
        t1 = 1 - w->point[k];
    }
    if (cells > 0) { /* at = t + offset; its own cell is [0, 1) */
        offset = ms_gpr__uniform(rng);
        ms_gpr__space_steps(&h->s, k, w->point, &t0, &t1);
        t1 += 1;
    }
    for (tries = 0; tries < 60; ++tries) {
        double at = t0 + ms_gpr__uniform(rng) * (t1 - t0);
        if (ms_gpr__chain_try(h, w, cells > 0 ? floor(at) * step : at)) return;
        if (at < offset) t0 = at;
        else t1 = at;
    }
}

/* A slice over the rows of a list: as over the cells of a column in steps. */
static void ms_gpr__chain_slice_list(const ms_gpr__sampler *h, ms_gpr__chain *w, const ms_gpr__group *g, ms__rng *rng)
{
    int own = ms_gpr__group_nearest(&h->s, g, w->point), row;
    double offset = own + ms_gpr__uniform(rng), t0 = 0, t1 = g->count;
    for (;;) {
        double at = t0 + ms_gpr__uniform(rng) * (t1 - t0);
        row = (int)at < g->count ? (int)at : g->count - 1;
        if (row == own) return;
        ms_gpr__group_direction(&h->s, g, own, row, w->direction);
        ms_gpr__chain_slopes(h, h->lines, h->points, w);
        if (ms_gpr__chain_try(h, w, 1)) return;
        if (at < offset) t0 = at;
        else t1 = at;
    }
}

/* Takes the best row of every list, the rest fixed. 0: they were taken already. */
static int ms_gpr__chain_best_rows(const ms_gpr__sampler *h, ms_gpr__chain *w)
{
    const ms_gpr__lines *lines = &h->gp->kernels->lines;
    int changed = 0, i, row, n = ms_gpr__padded(h->gp->n);
    for (i = 0; i < h->s.groups; ++i) {
        const ms_gpr__group *g = &h->s.group[i];
        int own = ms_gpr__group_nearest(&h->s, g, w->point), best = own;
        double largest = w->value;
        for (row = 0; row < g->count; ++row) { /* its own has the value that it has */
            double mean = w->value;
            ms_gpr__group_direction(&h->s, g, own, row, w->direction);
            ms_gpr__chain_slopes(h, lines, h->gp->points, w);
            if (row != own) mean = h->gp->mean + lines->mean(w->d2, w->slope, 1, w->curvature, h->gp->weight, n);
            if (mean > largest) largest = mean, best = row;
        }
        if (best == own) continue;
        ms_gpr__group_direction(&h->s, g, own, best, w->direction);
        ms_gpr__chain_slopes(h, lines, h->gp->points, w);
        ms_gpr__chain_step(h, lines, w, 1);
        w->value = largest;
        changed = 1;
    }
    return changed;
}

/* A slice step along one coordinate. */
static void ms_gpr__chain_coordinate(const ms_gpr__sampler *h, ms_gpr__chain *w, int coordinate, ms__rng *rng)
{
    const ms_gpr *gp = h->gp;
    int k = h->coordinate[coordinate];
    if (k >= gp->active + gp->m) {
        ms_gpr__chain_slice_list(h, w, &h->s.group[k - gp->active - gp->m], rng);
    } else if (k >= gp->active) {
        memset(w->direction, 0, (size_t)gp->m * sizeof *w->direction);
        w->direction[k - gp->active] = 1;
        ms_gpr__space_follow(&h->s, w->direction);
        ms_gpr__chain_slopes(h, h->lines, h->points, w);
        ms_gpr__chain_slice(h, w, k - gp->active, rng);
    } else {
        w->axis = k;
        w->step[k] = h->unit[k];
        w->curvature = h->unit[k] * h->unit[k];
        h->lines->slopes(w->slope, (const char *)h->points + (size_t)k * gp->stride * h->lines->size, gp->stride,
                         w->scaled + k, w->step + k, 1, ms_gpr__padded(gp->n));
        ms_gpr__chain_slice(h, w, gp->dimension[k], rng);
    }
}

/* A slice along a random direction of the dimensions that matter, if any does. Any law of directions will do that is
   symmetric. */
static void ms_gpr__chain_direction(const ms_gpr__sampler *h, ms_gpr__chain *w, ms__rng *rng)
{
    int k, any = 0;
    for (k = 0; k < h->gp->m; ++k) w->direction[k] = h->scale[k] > 0 ? h->scale[k] * (2 * ms_gpr__uniform(rng) - 1) : 0;
    ms_gpr__space_follow(&h->s, w->direction);
    for (k = 0; k < h->gp->m; ++k) any |= w->direction[k] < 0 || w->direction[k] > 0;
    if (!any) return; /* the chord would have no end */
    ms_gpr__chain_slopes(h, h->lines, h->points, w);
    ms_gpr__chain_slice(h, w, -1, rng);
}

/* What the mean hardly depends on, all at once: a uniform point of a hyperrectangle, at first the box, which shrinks
   towards the chain. */
static void ms_gpr__chain_rectangle(const ms_gpr__sampler *h, ms_gpr__chain *w, ms__rng *rng)
{
    int tries, i, k;
    if (h->flats == 0) return;
    for (i = 0; i < h->flats; ++i) w->low[i] = 0, w->high[i] = 1;
    memset(w->direction, 0, (size_t)h->gp->m * sizeof *w->direction);
    for (tries = 0; tries < 60; ++tries) {
        for (i = 0; i < h->flats; ++i) {
            k = h->flat[i];
            w->direction[k] = w->low[i] + ms_gpr__uniform(rng) * (w->high[i] - w->low[i]) - w->point[k];
        }
        ms_gpr__chain_slopes(h, h->lines, h->points, w);
        if (ms_gpr__chain_try(h, w, 1)) return;
        for (i = 0; i < h->flats; ++i) {
            k = h->flat[i];
            if (w->direction[k] < 0) w->low[i] = w->point[k] + w->direction[k];
            else w->high[i] = w->point[k] + w->direction[k];
        }
    }
}

/* --- tasks --- */

/* The mean of `count` candidates from `first` on, in the precision of the lines, with the scratch of
   that batch. */
static void ms_gpr__sampler_predict(const ms_gpr__sampler *h, int batch, size_t first, int count)
{
    ms_gpr__batch b;
    size_t m = (size_t)h->gp->m, i;
    memset(&b, 0, sizeof b);
    b.gp = h->gp;
    b.count = count;
    b.tasks = 1;
    b.scratch = h->scratch + (size_t)batch * h->scratch_size;
    if (h->lines->size == sizeof(float)) {
        float *x = h->candidate_f + first * m;
        for (i = 0; i < (size_t)count * m; ++i) x[i] = (float)h->candidate[first * m + i];
        b.x_f = x;
        b.mean_f = h->mean_f + first;
        ms_gpr__predict_task_f(&b, 0);
        for (i = 0; i < (size_t)count; ++i) h->mean[first + i] = (double)b.mean_f[i];
        return;
    }
    b.x = h->candidate + first * m;
    b.mean = h->mean + first;
    ms_gpr__predict_task(&b, 0);
}

/* One batch of uniform candidates and their means. */
static void ms_gpr__sampler_batch(void *context, int batch)
{
    ms_gpr__sampler *h = (ms_gpr__sampler *)context;
    ms__rng rng = ms__rng_make(h->o.seed, h->stream + (uint64_t)batch);
    size_t first = (size_t)batch * MS_GPR__BATCH, m = (size_t)h->gp->m, i;
    ms_gpr__chain *w = &h->chain[batch];
    for (i = 0; i < MS_GPR__BATCH; ++i) {
        ms_gpr__space_uniform(&h->s, w->point, &rng);
        ms_gpr__space_material(&h->s, w->point, h->candidate + (first + i) * m);
    }
    ms_gpr__sampler_predict(h, batch, first, MS_GPR__BATCH);
}

/* One transition of a chain: by turns along a coordinate, along a random direction, and in the hyperrectangle of flat
   dimensions. */
static void ms_gpr__chain_transition(const ms_gpr__sampler *h, ms_gpr__chain *w, int turn, ms__rng *rng)
{
    if (h->flats > 0 && turn % 4 == 3) ms_gpr__chain_rectangle(h, w, rng);
    else if (h->coordinates > 0 && turn % 2)
        ms_gpr__chain_coordinate(h, w, (int)(ms_gpr__uniform(rng) * h->coordinates), rng);
    else ms_gpr__chain_direction(h, w, rng);
}

/* Chains task, task + TASKS, ... of a level: each from its seed through its share of the next population. */
static void ms_gpr__sampler_level(void *context, int task)
{
    ms_gpr__sampler *h = (ms_gpr__sampler *)context;
    ms_gpr__chain *w = &h->chain[task];
    size_t m = (size_t)h->gp->m;
    int chain, at;
    for (chain = task; chain < h->seeds; chain += MS_GPR__TASKS) {
        int from = (int)((size_t)chain * (size_t)h->level_size / (size_t)h->seeds);
        int to = (int)(((size_t)chain + 1) * (size_t)h->level_size / (size_t)h->seeds);
        ms__rng rng = ms__rng_make(h->o.seed, h->stream + (uint64_t)chain);
        memcpy(w->point, h->point + (size_t)h->seed[chain] * m, m * sizeof *w->point);
        w->value = h->value[h->seed[chain]];
        ms_gpr__chain_distances(h, h->lines, h->points, w);
        for (at = from; at < to; ++at) {
            ms_gpr__chain_transition(h, w, at + h->turn, &rng);
            memcpy(h->next + (size_t)at * m, w->point, m * sizeof *w->point);
            h->next_value[at] = w->value;
        }
    }
}

/* Recommendations task, task + TASKS, ... of a wave: from a point of the population through `rounds` rounds of a slice
   along every axis and as many across, which forget where they started. */
static void ms_gpr__sampler_draw(void *context, int task)
{
    ms_gpr__sampler *h = (ms_gpr__sampler *)context;
    const ms_gpr *gp = h->gp;
    ms_gpr__chain *w = &h->chain[task];
    size_t m = (size_t)gp->m, d;
    int i, k, directions = 0;
    for (d = 0; d < m; ++d) directions += h->scale[d] > 0;
    for (i = task; i < h->wave; i += MS_GPR__TASKS) {
        double at = (double)(h->stream + (uint64_t)i) * 0.61803398874989485; /* any run of these is spread evenly */
        int from;
        ms__rng rng = ms__rng_make(h->o.seed, ((uint64_t)1 << 41) + h->stream + (uint64_t)i);
        at -= floor(at);
        from = (int)(at * h->population);
        memcpy(w->point, h->point + (size_t)from * m, m * sizeof *w->point);
        for (d = 0, k = 0; d < m; ++d) { /* dropped dimensions are uniform anyway */
            if (k < gp->active && (size_t)gp->dimension[k] == d) ++k;
            else if (h->s.owner[d] == 0 && h->s.lead[d] == (int)d && !ms_gpr__space_leads(&h->s, (int)d))
                w->point[d] = ms_gpr__space_uniform_column(&h->s, (int)d, &rng);
        }
        for (k = 0; k < h->s.groups; ++k)
            if (h->s.group[k].idle)
                ms_gpr__group_put(&h->s, &h->s.group[k], (int)(ms_gpr__uniform(&rng) * h->s.group[k].count), w->point);
        ms_gpr__chain_distances(h, h->lines, h->points, w);
        for (k = 0; k < h->coordinates || k < directions; ++k) {
            if (k < h->coordinates) ms_gpr__chain_coordinate(h, w, k, &rng);
            if (k < directions) ms_gpr__chain_direction(h, w, &rng);
            if (k % 4 == 0) ms_gpr__chain_rectangle(h, w, &rng);
        }
        ms_gpr__chain_rectangle(h, w, &rng);
        ms_gpr__space_material(&h->s, w->point, h->candidate + (size_t)i * m);
    }
}

/* --- one call --- */

/* A material as a point in the unit box; one from outside is moved to its surface. */
static void ms_gpr__sampler_point(const ms_gpr__sampler *h, const double *x, double *point)
{
    int k;
    for (k = 0; k < h->gp->m; ++k)
        point[k] = h->s.width[k] > 0 ? ms_gpr__clamp((x[k] - h->s.low[k]) / h->s.width[k], 0, 1) : 0;
}

/* The mean at the chain's point, in double precision. */
static double ms_gpr__chain_mean(const ms_gpr__sampler *h, ms_gpr__chain *w)
{
    const ms_gpr *gp = h->gp;
    ms_gpr__chain_distances(h, &gp->kernels->lines, gp->points, w);
    memset(w->slope, 0, gp->stride * sizeof(double));
    return gp->mean + gp->kernels->lines.mean(w->d2, w->slope, 0, 0, gp->weight, ms_gpr__padded(gp->n));
}

/* Whether single precision suffices: means of the scored materials agree to 1e-4 of the span of scores. Recommendations
   are checked again in double precision. */
static int ms_gpr__sampler_single(ms_gpr__sampler *h, double span)
{
    const ms_gpr *gp = h->gp;
    ms_gpr__chain *w = &h->chain[0];
    int i, n = gp->n < 256 ? gp->n : 256;
    for (i = 0; i < n; ++i) {
        ms_gpr__sampler_point(h, gp->x + (size_t)(i * (gp->n / n)) * (size_t)gp->m, w->point);
        w->value = ms_gpr__chain_mean(h, w) - gp->mean;
        ms_gpr__chain_distances(h, &gp->kernels->lines_f, gp->points_f, w);
        w->value -= gp->kernels->lines_f.mean(w->d2, w->slope, 0, 0, gp->weight_f, ms_gpr__padded(gp->n));
        if (!(fabs(w->value) <= 1e-4 * span)) return 0;
    }
    return 1;
}

/* The precision of means along lines. */
static void ms_gpr__sampler_precision(ms_gpr__sampler *h, int single)
{
    h->lines = single ? &h->gp->kernels->lines_f : &h->gp->kernels->lines;
    h->points = single ? (const void *)h->gp->points_f : (const void *)h->gp->points;
    h->weight = single ? (const void *)h->gp->weight_f : (const void *)h->gp->weight;
}

/* The first candidates, the largest mean, and the threshold. */
static ms_status ms_gpr__sampler_begin(ms_gpr__sampler *h, ms_error *error)
{
    const ms_gpr *gp = h->gp;
    ms_gpr__chain *w = &h->chain[0];
    double least = ms_gpr__floor_of(gp), best = -1e300, top = least;
    int pilot = MS_GPR__PILOT * MS_GPR__BATCH, i, k;
    for (k = 0; k < gp->active; ++k) h->unit[k] = h->s.width[gp->dimension[k]] * gp->scale[gp->dimension[k]];
    for (i = 0; i < gp->n; ++i)
        if (gp->value[i] > top) top = gp->value[i];
    ms_gpr__sampler_precision(h, gp->n > 0 && ms_gpr__sampler_single(h, top - least));
    ms__run(&gp->parallel, MS_GPR__PILOT, ms_gpr__sampler_batch, h);
    for (i = 0; i < gp->n; ++i) {
        ms_gpr__sampler_point(h, gp->x + (size_t)i * (size_t)gp->m, w->point);
        h->mean[pilot + i] = ms_gpr__chain_mean(h, w);
    }
    ms_gpr__ranked_select(h->ranked, h->mean, pilot + gp->n, MS_GPR__MODES);
    ms_gpr__ranked_sort(h->ranked, MS_GPR__MODES);
    for (i = 0; i < MS_GPR__MODES; ++i) {
        int index = h->ranked[i].index;
        ms_gpr__sampler_point(h,
                              index < pilot ? h->candidate + (size_t)index * (size_t)gp->m
                                            : gp->x + (size_t)(index - pilot) * (size_t)gp->m,
                              w->point);
        if (h->s.groups > 0 || h->s.tied) ms_gpr__space_project(&h->s, w->point);
        for (k = 0; k < 4; ++k) {
            ms_gpr__chain_ascend(h, w, 100);
            if (!ms_gpr__chain_best_rows(h, w)) break;
        }
        ms_gpr__space_project(&h->s, w->point);
        memcpy(h->mode + i * gp->m, w->point, (size_t)gp->m * sizeof *w->point);
        w->value = ms_gpr__chain_mean(h, w);
        h->mode_value[i] = w->value;
        if (w->value > best) best = w->value;
    }
    h->report.best = best;
    h->report.candidates = pilot + gp->n;
    if (h->o.best < 0 || h->o.best > 0) top = h->o.best;
    if (top > best) top = best;
    if (!(best > least) || !(top > least))
        return ms__fail(error, MS_NOT_CONVERGED, 0, "no material is predicted to score above %g, the lowest score",
                        least);
    h->report.threshold = least + h->o.tau * (top - least);
    if (h->report.threshold > best - 1e-6 * (best - least)) h->report.threshold = best - 1e-6 * (best - least);
    if (h->report.threshold > best - 1e-3 * (best - least)) ms_gpr__sampler_precision(h, 0); /* the last digits count */
    h->goal = h->report.threshold + 5e-7 * (best - least);
    return MS_OK;
}

/* Squared root-mean-square distance, in widths of the box, of x to the nearest of `count` rows. */
static double ms_gpr__sampler_nearest2(const ms_gpr__sampler *h, const double *rows, int count, const double *x)
{
    double nearest = 1e300;
    int m = h->gp->m, i, k;
    for (i = 0; i < count; ++i, rows += m) {
        double sum = 0;
        for (k = 0; k < m && sum < nearest; ++k) {
            double d = (rows[k] - x[k]) * h->s.per[k];
            sum += d * d;
        }
        if (sum < nearest) nearest = sum;
    }
    return nearest / m;
}

/* The next candidate of the sequence. It is looked at again in double precision; of every 1 + 15 diversity that pass,
   the one that is farthest from those before is taken. */
static void ms_gpr__sampler_accept(ms_gpr__sampler *h, const double *x)
{
    ms_gpr__chain *w = &h->chain[0];
    size_t m = (size_t)h->gp->m;
    double farthest = -1, value;
    int size = 1 + (int)(15 * h->o.diversity + 0.5), i, best = 0;
    ms_gpr__sampler_point(h, x, w->point);
    value = ms_gpr__chain_mean(h, w);
    if (value < 0.5 * (h->report.threshold + h->goal)) return;
    if (h->o.avoid_count > 0 &&
        ms_gpr__sampler_nearest2(h, h->o.avoid, h->o.avoid_count, x) < h->o.avoid_distance * h->o.avoid_distance)
        return;
    memcpy(h->rivals + (size_t)h->rival_count++ * m, x, m * sizeof *x);
    if (h->rival_count < size) return;
    for (i = 0; i < h->rival_count; ++i) {
        double near2 = size > 1 ? ms_gpr__sampler_nearest2(h, h->result, h->taken, h->rivals + (size_t)i * m) : 0;
        if (near2 > farthest) best = i, farthest = near2;
    }
    h->rival_count = 0;
    memcpy(h->result + (size_t)h->taken++ * m, h->rivals + (size_t)best * m, m * sizeof *x);
}

static int ms_gpr__sampler_stopped(const ms_gpr__sampler *h)
{
    return h->o.progress.report != NULL && h->o.progress.report(h->o.progress.user, (double)h->taken / h->count);
}

/* Uniform candidates against the threshold, wave by wave; the first candidates are the first wave. */
static ms_status ms_gpr__sampler_reject(ms_gpr__sampler *h)
{
    double accepted = 0, seen = 0;
    int batches = MS_GPR__PILOT, i;
    for (;;) {
        for (i = 0; i < batches * MS_GPR__BATCH && h->taken < h->count; ++i) {
            seen += 1;
            if (h->mean[i] < h->goal) continue;
            accepted += 1;
            ms_gpr__sampler_accept(h, h->candidate + (size_t)i * (size_t)h->gp->m);
        }
        h->report.acceptance = accepted / seen;
        if (h->taken == h->count) return MS_OK;
        if (h->report.candidates >= MS_GPR__GIVE_UP) return MS_NOT_CONVERGED;
        if (ms_gpr__sampler_stopped(h)) return MS_CANCELLED;
        h->stream += (uint64_t)batches;
        batches = MS_GPR__BATCHES;
        ms__run(&h->gp->parallel, batches, ms_gpr__sampler_batch, h);
        h->report.candidates += batches * MS_GPR__BATCH;
    }
}

/* How far to go in every dimension that matters, for directions across: the population's spread, or a length scale. */
static void ms_gpr__sampler_scales(ms_gpr__sampler *h)
{
    size_t m = (size_t)h->gp->m, k;
    int i;
    memset(h->scale, 0, m * sizeof *h->scale);
    for (i = 0; i < h->gp->active; ++i) {
        double sum = 0, sum2 = 0, spread;
        int j;
        k = (size_t)h->gp->dimension[i];
        for (j = 0; j < h->population; ++j) sum += h->point[(size_t)j * m + k] / h->population;
        for (j = 0; j < h->population; ++j)
            sum2 += (h->point[(size_t)j * m + k] - sum) * (h->point[(size_t)j * m + k] - sum) / h->population;
        spread = sqrt(sum2);
        if (h->unit[i] > MS_GPR__INFORMATIVE && ms_gpr__space_continuous(&h->s, (int)k))
            h->scale[k] = spread * h->unit[i] > 1 ? 1 / h->unit[i] : spread;
    }
}

/* The next population, of chains from the seeds. */
static void ms_gpr__sampler_next_level(ms_gpr__sampler *h, int step)
{
    double *point = h->point, *value = h->value;
    h->turn = step;
    h->stream = ((uint64_t)1 << 40) + (uint64_t)step * (uint64_t)h->level_size;
    ms__run(&h->gp->parallel, MS_GPR__TASKS, ms_gpr__sampler_level, h);
    h->point = h->next, h->value = h->next_value;
    h->next = point, h->next_value = value;
    h->population = h->seeds = h->level_size;
}

/* Whether two of the modes are separate: the mean falls below the threshold on the segment between them. */
static int ms_gpr__sampler_separate(ms_gpr__sampler *h)
{
    ms_gpr__chain *w = &h->chain[0];
    const double *a = h->mode, *b;
    int i, j, k;
    for (i = 1; i < MS_GPR__MODES; ++i) {
        if (h->mode_value[i] < h->goal || h->mode_value[0] < h->goal) continue;
        b = h->mode + i * h->gp->m;
        for (j = 1; j < 8; ++j) {
            for (k = 0; k < h->gp->m; ++k) w->point[k] = a[k] + (b[k] - a[k]) * j / 8;
            if (ms_gpr__chain_mean(h, w) < h->goal) return 1;
        }
    }
    return 0;
}

/* The population of the region: that of the box, whose level rises step by step. Each time one in MS_GPR__LEVEL_SHARE
   is above the next level, and chains from those make the new population; so each mode keeps its share. Where a level
   has no room to rise (the region is narrower than any population sees), the modes of the ascents take its place. */
static ms_status ms_gpr__sampler_levels(ms_gpr__sampler *h)
{
    size_t m = (size_t)h->gp->m, row = m * sizeof(double);
    int i, k, step;
    h->population = MS_GPR__PILOT * MS_GPR__BATCH;
    h->report.acceptance = 1;
    h->level_size = ms_gpr__sampler_separate(h) ? MS_GPR__CROWD : MS_GPR__POPULATION;
    for (i = 0; i < h->population; ++i)
        ms_gpr__sampler_point(h, h->candidate + (size_t)i * m, h->point + (size_t)i * m);
    memcpy(h->value, h->mean, (size_t)h->population * sizeof *h->value);
    h->level = -1e300;
    for (step = 0; step < MS_GPR__LEVELS; ++step) {
        double before = h->level;
        ms_gpr__ranked_select(h->ranked, h->value, h->population, h->level_size / MS_GPR__LEVEL_SHARE);
        for (i = 0, h->level = h->goal; i < h->level_size / MS_GPR__LEVEL_SHARE; ++i)
            if (h->ranked[i].value < h->level) h->level = h->ranked[i].value;
        for (i = 0, k = 0; i < h->population; ++i) { /* survivors, in their order */
            if (h->value[i] < h->level) continue;
            if (k < i) memcpy(h->point + (size_t)k * m, h->point + (size_t)i * m, row);
            h->value[k++] = h->value[i];
        }
        h->report.acceptance *= (double)k / h->population;
        h->population = k;
        if (!(h->level > before)) break;
        ms_gpr__sampler_scales(h);
        h->seeds = k < h->level_size ? k : h->level_size;
        for (i = 0; i < h->seeds; ++i) h->seed[i] = (int)((size_t)i * (size_t)k / (size_t)h->seeds);
        ms_gpr__sampler_next_level(h, step);
        if (h->level >= h->goal) break;
        if (ms_gpr__sampler_stopped(h)) return MS_CANCELLED;
    }
    if (h->level < h->goal) {
        h->level = h->goal;
        for (i = 0, h->population = 0; i < MS_GPR__MODES; ++i)
            if (h->mode_value[i] >= h->goal)
                memcpy(h->point + (size_t)h->population++ * m, h->mode + (size_t)i * m, row);
        h->report.acceptance = 0;
        ms_gpr__sampler_scales(h);
    }
    return MS_OK;
}

/* The population, and chains through the region from it; 40 times as many as are wanted at most. */
static ms_status ms_gpr__sampler_subset(ms_gpr__sampler *h)
{
    ms_status status = ms_gpr__sampler_levels(h);
    int size = 1 + (int)(15 * h->o.diversity + 0.5), i;
    if (status != MS_OK) return status;
    for (h->stream = 0; h->taken < h->count; h->stream += (uint64_t)h->wave) {
        int left = (h->count - h->taken) * size - h->rival_count;
        if (h->stream / 40 > (uint64_t)h->count * (uint64_t)size) return MS_NOT_CONVERGED;
        h->wave = left < MS_GPR__WAVE ? left : MS_GPR__WAVE;
        ms__run(&h->gp->parallel, MS_GPR__TASKS, ms_gpr__sampler_draw, h);
        for (i = 0; i < h->wave && h->taken < h->count; ++i)
            ms_gpr__sampler_accept(h, h->candidate + (size_t)i * (size_t)h->gp->m);
        if (h->taken < h->count && ms_gpr__sampler_stopped(h)) return MS_CANCELLED;
    }
    return MS_OK;
}

/* Mean distance of the first 200 to the nearest other one of them. */
static double ms_gpr__sampler_spread(const ms_gpr__sampler *h, const double *x)
{
    int count = h->report.found < 200 ? h->report.found : 200, i;
    size_t m = (size_t)h->gp->m;
    double sum = 0;
    for (i = 0; i < count; ++i) {
        double before = ms_gpr__sampler_nearest2(h, x, i, x + (size_t)i * m);
        double after = ms_gpr__sampler_nearest2(h, x + (size_t)(i + 1) * m, count - i - 1, x + (size_t)i * m);
        sum += sqrt(before < after ? before : after);
    }
    return count > 1 ? sum / count : 0;
}

static void ms_gpr__sampler_layout(ms_gpr__sampler *h, ms__arena *arena)
{
    size_t m = (size_t)h->gp->m, stride = h->gp->stride, candidates = MS_GPR__BATCHES * MS_GPR__BATCH;
    size_t population = MS_GPR__PILOT * MS_GPR__BATCH;
    int i;
    h->unit = ms_gpr__take(arena, m, 1);
    h->coordinate = (int *)ms__take(arena, 2 * m + (size_t)h->s.groups, sizeof(int));
    h->flat = (int *)ms__take(arena, m, sizeof(int));
    h->scale = ms_gpr__take(arena, m, 1);
    h->rivals = ms_gpr__take(arena, m, 16);
    h->candidate = ms_gpr__take(arena, candidates, m);
    h->candidate_f = (float *)ms__take(arena, ms__size_mul(candidates, m), sizeof(float));
    h->mean = ms_gpr__take(arena, candidates + (size_t)h->gp->n, 1);
    h->mean_f = (float *)ms__take(arena, candidates, sizeof(float));
    h->scratch = ms_gpr__take(arena, MS_GPR__BATCHES, h->scratch_size);
    h->ranked = (ms_gpr__ranked *)ms__take(arena, candidates + (size_t)h->gp->n, sizeof *h->ranked);
    h->mode = ms_gpr__take(arena, MS_GPR__MODES, m);
    h->point = ms_gpr__take(arena, population, m);
    h->next = ms_gpr__take(arena, population, m);
    h->value = ms_gpr__take(arena, population, 1);
    h->next_value = ms_gpr__take(arena, population, 1);
    h->seed = (int *)ms__take(arena, MS_GPR__CROWD, sizeof(int));
    if (h->o.skip > 0) h->result = ms_gpr__take(arena, (size_t)h->count, m);
    for (i = 0; i < MS_GPR__TASKS; ++i) {
        ms_gpr__chain *w = &h->chain[i];
        w->point = ms_gpr__take(arena, m, 1);
        w->direction = ms_gpr__take(arena, m, 1);
        w->scaled = ms_gpr__take(arena, m, 1);
        w->step = ms_gpr__take(arena, m, 1);
        w->low = ms_gpr__take(arena, m, 1);
        w->high = ms_gpr__take(arena, m, 1);
        w->d2 = ms_gpr__take(arena, stride, 1);
        w->slope = ms_gpr__take(arena, stride, 1);
        w->kernel = ms_gpr__take(arena, stride, 1);
    }
}

static ms_status ms_gpr__recommend_options(const ms_gpr_recommend_options *options, int m, ms_gpr_recommend_options *o,
                                           ms_error *error)
{
    ms_status status;
    if (options != NULL) *o = *options;
    else memset(o, 0, sizeof *o);
    status = ms_gpr__check_range("tau", o->tau, 0, 1, error);
    if (status == MS_OK) status = ms_gpr__check_range("diversity", o->diversity, 0, 1, error);
    if (status == MS_OK) status = ms_gpr__check_range("avoid_distance", o->avoid_distance, 0, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("best", o->best, -MS_GPR__LARGEST, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__check_range("skip", o->skip, 0, MS_GPR__MOST, error);
    if (status == MS_OK) status = ms_gpr__check_range("avoid_count", o->avoid_count, 0, MS_GPR__MOST, error);
    if (status == MS_OK) status = ms_gpr__check_range("search", (int)o->search, 0, (int)MS_GPR_SEARCH_SUBSET, error);
    if (status == MS_OK && o->avoid_count > 0 && o->avoid == NULL) status = ms_gpr__null("avoid", error);
    if (status != MS_OK) return status;
    if (!(o->tau > 0)) o->tau = 0.6;
    if (!(o->avoid_distance > 0)) o->avoid_distance = 0.15;
    return o->avoid_count > 0
        ? ms_gpr__check_rows(o->avoid, o->avoid_count, m, MS_GPR__LARGEST, "material to avoid", error)
        : MS_OK;
}

/* The search that was asked for, or the cheaper one. */
static ms_status ms_gpr__sampler_run(ms_gpr__sampler *h, ms_error *error)
{
    int pilot = MS_GPR__PILOT * MS_GPR__BATCH, hits = 0, i;
    ms_status status = ms_gpr__sampler_begin(h, error);
    if (status != MS_OK) return status;
    for (i = 0; i < pilot; ++i) hits += h->mean[i] >= h->goal;
    h->report.acceptance = (double)hits / pilot;
    h->report.search = h->o.search;
    if (h->o.search == MS_GPR_SEARCH_AUTO)
        h->report.search = hits * MS_GPR__RARE >= pilot ? MS_GPR_SEARCH_REJECTION : MS_GPR_SEARCH_SUBSET;
    status = h->report.search == MS_GPR_SEARCH_REJECTION ? ms_gpr__sampler_reject(h) : ms_gpr__sampler_subset(h);
    if (status == MS_OK) return MS_OK;
    return ms__fail(error, status, 0, "%s after %d of %d recommendations",
                    status == MS_CANCELLED ? "cancelled" : "gave up", h->taken, h->count);
}

MS_API ms_status ms_gpr_recommend(const ms_gpr *gp, const ms_gpr_recommend_options *options, int count, double *x,
                                  double *mean, double *sigma, ms_gpr_recommend_report *report, ms_error *error)
{
    ms_gpr__sampler sampler, *h = &sampler;
    ms__arena arena = {NULL, 0};
    ms_status status;
    size_t m;
    int k, i;
    memset(h, 0, sizeof *h);
    if (report) *report = h->report;
    if (gp == NULL || x == NULL) return ms_gpr__null(gp ? "x" : "gp", error);
    if (count < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d: expected at least 1", count);
    status = ms_gpr__recommend_options(options, gp->m, &h->o, error);
    if (status != MS_OK) return status;
    if (h->o.skip > 0x7fffffff / 16 - count || count > 0x7fffffff / 16)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d and skip %d: expected at most %d together", count,
                        h->o.skip, 0x7fffffff / 16);
    m = (size_t)gp->m;
    h->gp = gp;
    h->count = count + h->o.skip;
    h->result = x;
    h->scratch_size = MS_GPR__CHUNK * (m + MS_GPR__SLAB);
    status = ms_gpr__space_make(gp->x, gp->n, gp->m, &h->o.space, &gp->allocator, &h->s, error);
    if (status != MS_OK) return status;
    ms_gpr__sampler_layout(h, &arena);
    if (!ms_gpr__place(&gp->allocator, &arena)) {
        ms_gpr__space_free(&h->s);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a search over %d scores", gp->n);
    }
    ms_gpr__sampler_layout(h, &arena);
    for (k = 0; k < gp->active; ++k)
        if (h->s.owner[gp->dimension[k]] == 0) {
            int d = gp->dimension[k];
            if (h->s.lead[d] != d || ms_gpr__space_leads(&h->s, d)) continue;
            if (h->s.width[d] * gp->scale[d] > MS_GPR__INFORMATIVE || !ms_gpr__space_continuous(&h->s, d))
                h->coordinate[h->coordinates++] = k;
            else h->flat[h->flats++] = d;
        }
    for (k = 0; k < gp->m; ++k)
        if (ms_gpr__space_leads(&h->s, k) && h->s.width[k] > 0) h->coordinate[h->coordinates++] = gp->active + k;
    for (k = 0; k < h->s.groups; ++k) {
        int used = 0;
        for (i = 0; i < gp->active; ++i) used |= h->s.owner[gp->dimension[i]] == k + 1;
        h->s.group[k].idle = !used;
        if (used) h->coordinate[h->coordinates++] = gp->active + gp->m + k;
    }
    status = ms_gpr__sampler_run(h, error);
    h->report.found = h->taken > h->o.skip ? h->taken - h->o.skip : 0;
    if (h->result != x) memcpy(x, h->result + (size_t)h->o.skip * m, (size_t)h->report.found * m * sizeof *x);
    if (h->report.found > 0) h->report.spread = ms_gpr__sampler_spread(h, x);
    ms_gpr__release(&gp->allocator, arena.base);
    ms_gpr__space_free(&h->s);
    if (h->report.found > 0 && (mean || sigma)) {
        ms_status predicted = ms_gpr_predict(gp, x, h->report.found, mean, sigma, error);
        if (predicted != MS_OK) return predicted;
        for (i = 0; sigma && i < h->report.found; ++i) sigma[i] = sqrt(sigma[i]);
    }
    if (report) *report = h->report;
    return status;
}

/* ---- active learning ------------------------------------------------------------------------------------------- */

enum {
    MS_GPR__CANDIDATES = 4000, /* that a gallery is chosen from, at least; 10 for each choice */
    MS_GPR__SCREENED = 128     /* scores from which on variances are computed of one candidate in four to eight */
};

/* A pool of uniform candidates and what is known about them, given the scores and the choices so far. */
typedef struct ms_gpr__pool {
    const ms_gpr *gp;
    double floor, threshold; /* scores above are liked, and recommended */
    int drawn, size, count;  /* candidates, those whose variance is computed (a multiple of CHUNK), choices */
    double *x;               /* [drawn][m] */
    double *points;          /* [active][size] in length scales, as gp->points */
    double *mean;            /* [drawn] */
    ms_gpr__ranked *ranked;  /* [drawn] */
    double *variance;        /* [size] */
    double *columns;         /* [padded n][size] U'^-1 k(training, pool) */
    double *basis;   /* [count][size] posterior covariance with each choice, less what earlier ones explain, over its
                        deviation */
    double *shuffle; /* [drawn] scratch */
    double *taken;   /* [drawn] 1: chosen */
    ms_gpr__space s;
    double *point;   /* [m] */
    double *scratch; /* [m][4] a choice, four times: a tile of the distance kernel; [4][size] its distances; before, [n]
                        parents */
} ms_gpr__pool;

/* Task: a chunk of candidates against the training set. */
static void ms_gpr__pool_chunk(void *context, int chunk)
{
    ms_gpr__pool *p = (ms_gpr__pool *)context;
    const ms_gpr *gp = p->gp;
    size_t size = (size_t)p->size, first = (size_t)chunk * MS_GPR__CHUNK;
    double *columns = p->columns + first, sf2 = ms_gpr__sf2(gp);
    int n = ms_gpr__padded(gp->n), i, j;
    gp->kernels->distances(columns, size, gp->points, gp->stride, p->points + first, size, n, MS_GPR__CHUNK, gp->active,
                           0);
    for (i = 0; i < n; ++i) {
        double *row = columns + (size_t)i * size;
        if (i < gp->n) gp->kernels->exponentials(row, MS_GPR__CHUNK, sf2);
        else memset(row, 0, MS_GPR__CHUNK * sizeof *row);
    }
    for (j = 0; j < MS_GPR__CHUNK; ++j) p->mean[first + (size_t)j] = gp->mean;
    for (i = 0; i < gp->n; ++i)
        gp->kernels->axpy(p->mean + first, gp->alpha[i], columns + (size_t)i * size, MS_GPR__CHUNK);
    ms_gpr__forward(gp->kernels, gp->upper, gp->stride, n, columns, size, MS_GPR__CHUNK);
    for (j = 0; j < MS_GPR__CHUNK; ++j) p->variance[first + (size_t)j] = sf2;
    for (i = 0; i < gp->n; ++i)
        for (j = 0; j < MS_GPR__CHUNK; ++j) {
            double v = columns[(size_t)i * size + (size_t)j];
            p->variance[first + (size_t)j] -= v * v;
        }
}

/* The acquisition function: how much candidate j is value seeing as choice number q. */
static double ms_gpr__pool_acquisition(const ms_gpr__pool *p, int q, int j)
{
    double sigma = p->variance[j] > 0 ? sqrt(p->variance[j]) : 0, above = p->mean[j] - p->floor;
    if (q % 2 == 0) return 1.96 * sigma - fabs(p->mean[j] - p->threshold);
    if (!(sigma > 0)) return sigma;
    return sigma * 0.5 * erfc(-above / (1.4142135623730951 * sigma)); /* P(u > floor) sigma */
}

static int ms_gpr__pool_best(const ms_gpr__pool *p, int q)
{
    double largest = 0;
    int best = -1, j;
    for (j = 0; j < p->size; ++j) {
        double value = p->taken[j] > 0 ? 0 : ms_gpr__pool_acquisition(p, q, j);
        if (p->taken[j] > 0 || (best >= 0 && !(value > largest))) continue;
        largest = value;
        best = j;
    }
    return best;
}

/* Choice number q, candidate j, counts as seen: b = cov(j, pool) / sqrt(var_j + sn^2), variance -= b^2. */
static void ms_gpr__pool_choose(ms_gpr__pool *p, int q, int j)
{
    const ms_gpr *gp = p->gp;
    size_t size = (size_t)p->size;
    double *point = p->scratch, *row = point + 4 * (size_t)gp->m, *basis = p->basis + (size_t)q * size;
    double sf2 = ms_gpr__sf2(gp), scale;
    int i, k;
    for (k = 0; k < gp->active; ++k)
        for (i = 0; i < 4; ++i) point[4 * k + i] = p->points[(size_t)k * size + (size_t)j];
    gp->kernels->distances(row, size, point, 4, p->points, size, 4, p->size, gp->active, 0);
    gp->kernels->exponentials(row, p->size, sf2);
    for (i = 0; i < gp->n; ++i) {
        const double *v = p->columns + (size_t)i * size;
        gp->kernels->axpy(row, -v[j], v, p->size);
    }
    for (i = 0; i < q; ++i) {
        const double *b = p->basis + (size_t)i * size;
        gp->kernels->axpy(row, -b[j], b, p->size);
    }
    scale = 1 / sqrt((p->variance[j] > 0 ? p->variance[j] : 0) + ms_gpr__sn2(gp) + 1e-12 * sf2);
    for (i = 0; i < p->size; ++i) {
        basis[i] = scale * row[i];
        p->variance[i] -= basis[i] * basis[i];
    }
}

static void ms_gpr__pool_layout(ms_gpr__pool *p, ms__arena *arena)
{
    size_t m = (size_t)p->gp->m, size = (size_t)p->size, drawn = (size_t)p->drawn;
    p->x = ms_gpr__take(arena, drawn, m);
    p->points = ms_gpr__take(arena, size, m);
    p->mean = ms_gpr__take(arena, drawn, 1);
    p->ranked = (ms_gpr__ranked *)ms__take(arena, drawn, sizeof *p->ranked);
    p->variance = ms_gpr__take(arena, size, 1);
    p->shuffle = ms_gpr__take(arena, drawn, 1);
    p->taken = ms_gpr__take(arena, drawn, 1);
    p->columns = ms_gpr__take(arena, size, (size_t)ms_gpr__padded(p->gp->n));
    p->basis = ms_gpr__take(arena, size, (size_t)p->count);
    p->point = ms_gpr__take(arena, m, 1);
    p->scratch = ms_gpr__take(arena, 4, ms__size_add(size, ms__size_add(m, (size_t)p->gp->n)));
}

/* How likely each scored material is to be a parent, [n]: its score above the floor, shared with those liked ones that
   the model takes for near, so that small classes have children too. Returns the sum. */
static double ms_gpr__pool_parents(const ms_gpr__pool *p, double *parent)
{
    const ms_gpr *gp = p->gp;
    double sum = 0;
    int i, j;
    for (i = 0; i < gp->n; ++i) {
        double crowd = 0;
        for (j = 0; j < gp->n && gp->value[i] > p->floor; ++j)
            if (gp->value[j] > p->floor)
                crowd += exp(-0.5 *
                             ms_gpr__distance2(gp->points + i, gp->stride, gp->points + j, gp->stride, gp->active));
        parent[i] = gp->value[i] > p->floor ? (gp->value[i] - p->floor) / crowd : 0;
        sum += parent[i];
    }
    return sum;
}

/* The uniform point as a variant of scored materials: whatever parameters are not drawn anew come from a parent, or
   from two; those of a list together. */
static void ms_gpr__pool_mutate(ms_gpr__pool *p, const double *parents, double sum, ms__rng *rng)
{
    const ms_gpr *gp = p->gp;
    double share = 0.1 + 0.5 * ms_gpr__uniform(rng);
    int parent[2], crossed = ms_gpr__uniform(rng) < 0.5, anew = (int)(ms_gpr__uniform(rng) * gp->m), i, k;
    for (k = 0; k < gp->m && !(p->s.width[anew] > 0); ++k) anew = (anew + 1) % gp->m; /* one at least */
    for (i = 0; i < 2; ++i) {
        double left = sum * ms_gpr__uniform(rng);
        for (k = 0; k < gp->n; ++k) {
            if (!(parents[k] > 0)) continue;
            parent[i] = k;
            if ((left -= parents[k]) < 0) break;
        }
    }
    for (k = 0; k < gp->m; ++k) {
        const double *from = gp->x + (size_t)parent[crossed && ms_gpr__uniform(rng) < 0.5] * (size_t)gp->m;
        int kept = ms_gpr__uniform(rng) >= share && k != anew;
        if (kept && p->s.owner[k] == 0) p->point[k] = (from[k] - p->s.low[k]) * p->s.per[k];
        if (!kept || p->s.owner[k] == 0 || p->s.group[p->s.owner[k] - 1].column[0] != k) continue;
        for (i = 0; i < p->s.group[p->s.owner[k] - 1].width; ++i) {
            int column = p->s.group[p->s.owner[k] - 1].column[i];
            p->point[column] = (from[column] - p->s.low[column]) * p->s.per[column];
        }
    }
    ms_gpr__space_project(&p->s, p->point);
}

/* The candidates; nothing is taken or seen. Every parameter of the first `spread` of them, and every list, falls once
   into each of as many parts of its range. vary: half of the pool are variants. */
static void ms_gpr__pool_fill(ms_gpr__pool *p, uint64_t seed, int spread, int vary)
{
    ms__rng rng = ms__rng_make(seed, (uint64_t)p->gp->n);
    const ms_gpr__space *s = &p->s;
    size_t m = (size_t)p->gp->m, k;
    double parents = vary ? ms_gpr__pool_parents(p, p->scratch) : 0;
    int i, j;
    for (k = 0; k < m + (size_t)s->groups && spread > 0; ++k) { /* which part, in shuffle: a shuffle */
        for (j = 0; j < spread; ++j) {
            i = (int)(ms_gpr__uniform(&rng) * (j + 1));
            p->shuffle[j] = p->shuffle[i];
            p->shuffle[i] = j;
        }
        for (j = 0; j < spread; ++j) { /* places for now */
            double u = (p->shuffle[j] + ms_gpr__uniform(&rng)) / spread;
            if (k >= m) ms_gpr__group_put(s, &s->group[k - m], (int)(u * s->group[k - m].count), p->x + (size_t)j * m);
            else p->x[(size_t)j * m + k] = s->cells[k] > 0 ? floor(u * s->cells[k]) * s->step[k] / s->width[k] : u;
        }
    }
    for (j = 0; j < p->drawn; ++j) {
        double *x = p->x + (size_t)j * m;
        if (j >= spread) ms_gpr__space_uniform(s, p->point, &rng);
        else memcpy(p->point, x, m * sizeof *x);
        ms_gpr__space_follow(s, p->point);
        if (parents > 0 && j % 2) ms_gpr__pool_mutate(p, p->scratch, parents, &rng);
        ms_gpr__space_material(s, p->point, x);
        ms_gpr__uniform(&rng);
        p->taken[j] = 0;
    }
}

/* Keeps `size` of the candidates, in their order: half of them those whose mean is nearest to the threshold, half those
   of the largest means among the rest. */
static ms_status ms_gpr__pool_screen(ms_gpr__pool *p, ms_error *error)
{
    const size_t m = (size_t)p->gp->m;
    int half = p->size / 2, kept = 0, i, j;
    ms_status status = ms_gpr_predict(p->gp, p->x, p->drawn, p->mean, NULL, error);
    if (status != MS_OK) return status;
    for (j = 0; j < p->drawn; ++j) p->shuffle[j] = -fabs(p->mean[j] - p->threshold);
    ms_gpr__ranked_select(p->ranked, p->shuffle, p->drawn, half);
    for (i = 0; i < half; ++i) p->taken[p->ranked[i].index] = 1, p->mean[p->ranked[i].index] = -HUGE_VAL;
    ms_gpr__ranked_select(p->ranked, p->mean, p->drawn, p->size - half);
    for (i = 0; i < p->size - half; ++i) p->taken[p->ranked[i].index] = 1;
    for (j = 0; j < p->drawn; ++j) {
        if (p->taken[j] > 0) memmove(p->x + (size_t)kept++ * m, p->x + (size_t)j * m, m * sizeof *p->x);
        p->taken[j] = 0;
    }
    return MS_OK;
}

MS_API ms_status ms_gpr_gallery(const ms_gpr *gp, const ms_gpr_gallery_options *options, int count, double *x,
                                ms_error *error)
{
    ms_gpr_gallery_options o;
    ms_gpr__pool pool, *p = &pool;
    ms__arena arena = {NULL, 0};
    ms_status status;
    double top;
    int q, drawn;
    memset(p, 0, sizeof *p);
    if (options != NULL) o = *options;
    else memset(&o, 0, sizeof o);
    if (gp == NULL || x == NULL) return ms_gpr__null(gp ? "x" : "gp", error);
    status = ms_gpr__check_range("count", count, 1, 1e6, error);
    if (status == MS_OK) status = ms_gpr__check_range("kind", (int)o.kind, 0, (int)MS_GPR_GALLERY_SPREAD, error);
    if (status != MS_OK) return status;
    p->gp = gp;
    p->count = count;
    p->floor = ms_gpr__floor_of(gp);
    for (q = 0, top = p->floor; q < gp->n; ++q)
        if (gp->value[q] > top) top = gp->value[q];
    p->threshold = p->floor + 0.6 * (top - p->floor);
    if (o.kind == MS_GPR_GALLERY_ACTIVE && !(top > p->floor)) o.kind = MS_GPR_GALLERY_SPREAD; /* nothing is liked yet */
    drawn = o.kind == MS_GPR_GALLERY_SPREAD;
    p->drawn = drawn ? count : 10 * count > MS_GPR__CANDIDATES ? 10 * count : MS_GPR__CANDIDATES;
    p->drawn = (p->drawn + MS_GPR__CHUNK - 1) / MS_GPR__CHUNK * MS_GPR__CHUNK;
    p->size = p->drawn;
    if (!drawn && gp->n >= MS_GPR__SCREENED) {
        const int part = gp->n < 300 ? 4 : gp->n < 480 ? gp->n / 60 : 8;
        p->size = (p->drawn / part + MS_GPR__CHUNK - 1) / MS_GPR__CHUNK * MS_GPR__CHUNK;
    }
    status = ms_gpr__space_make(gp->x, gp->n, gp->m, &o.space, &gp->allocator, &p->s, error);
    if (status != MS_OK) return status;
    ms_gpr__pool_layout(p, &arena);
    if (!ms_gpr__place(&gp->allocator, &arena)) {
        ms_gpr__space_free(&p->s);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a pool of %d candidates", p->drawn);
    }
    ms_gpr__pool_layout(p, &arena);
    ms_gpr__pool_fill(p, o.seed, drawn ? count : 0, !drawn);
    if (p->size < p->drawn) status = ms_gpr__pool_screen(p, error);
    for (q = 0; q < p->size; ++q) ms_gpr__scale(gp, p->x + (size_t)q * (size_t)gp->m, p->points + q, (size_t)p->size);
    if (!drawn && status == MS_OK) ms__run(&gp->parallel, p->size / MS_GPR__CHUNK, ms_gpr__pool_chunk, p);
    for (q = 0; q < count && status == MS_OK; ++q) {
        int best = drawn ? q : ms_gpr__pool_best(p, q);
        memcpy(x + (size_t)q * (size_t)gp->m, p->x + (size_t)best * (size_t)gp->m, (size_t)gp->m * sizeof *x);
        p->taken[best] = 1;
        if (!drawn) ms_gpr__pool_choose(p, q, best);
    }
    ms_gpr__release(&gp->allocator, arena.base);
    ms_gpr__space_free(&p->s);
    return status;
}

#ifndef MS_GPR_NO_PLANE
/* ---- latent space ---------------------------------------------------------------------------------------------- */

enum {
    MS_GPR__PLANE = 2,           /* dimensions of the latent space */
    MS_GPR__LATENT_LIMIT = 2000, /* evaluations of the likelihood of a fit, at most */
    MS_GPR__LATENT_TRIAL = 100   /* evaluations of every start of a fit */
};

struct ms_gpr_latent {
    int z, m;
    size_t stride, columns; /* of matrices over points; of rows of materials: m in whole blocks */
    ms_simd level;
    const ms_gpr__kernels *kernels;
    ms_allocator allocator;
    void *memory;
    double jitter;
    int constrained; /* materials keep what is in s */
    ms_gpr__space s;
    double *latent; /* [z][l] */
    double *theta;  /* [l + 2] */
    double *center; /* [m] subtracted from the materials */
    double *x;      /* [padded z][columns] materials less center, padded with zeros */
    double *points; /* [l][stride] latents in lengths, less their mean, by dimension */
    double *origin; /* [l] that mean, in lengths */
    double *upper;  /* [padded z][stride] U'U = K' */
    double *weight; /* [padded z][columns] K'^-1 X */
};

/* What one evaluation of the likelihood needs. */
typedef struct ms_gpr__embedding {
    const ms_gpr__kernels *kernels;
    int z, m;
    size_t stride, columns;
    const double *x;  /* [padded z][columns] */
    double *kernel;   /* [padded z][stride] K without noise, upper triangle */
    double *upper;    /* U, then G = A A' - m K'^-1, upper triangle */
    double *inverse;  /* U'^-1 */
    double *whitened; /* [padded z][columns] Y = U'^-1 X */
    double *weight;   /* [2][columns][stride] -A' and A', A = K'^-1 X */
} ms_gpr__embedding;

/* log p(X | L, theta) = -1/2 tr(K'^-1 X X') - m/2 log |K'| - z m/2 log 2 pi (3.8), and its gradient where `gradient` is
   not NULL: [l + 2] with respect to log lengths, log sf and sn^2, and [l][stride] with respect to the points. The
   materials are m independent columns, so dlogp/dK' = 1/2 (A A' - m K'^-1). 0 where K' is not positive definite. */
static int ms_gpr__embedding_evaluate(const ms_gpr__embedding *e, const double *points, double sf2, double noise,
                                      double *likelihood, double *gradient, double *gradient_points)
{
    const ms_gpr__kernels *f = e->kernels;
    int padded = ms_gpr__padded(e->z), columns = (int)e->columns, i, j, k;
    size_t matrix = (size_t)padded * e->stride, materials = (size_t)padded * e->columns, list = e->columns * e->stride,
           at;
    double fit, determinant, *minus = e->weight, *plus = e->weight + list;
    ms_gpr__covariance(f, points, e->stride, e->z, MS_GPR__PLANE, sf2, e->kernel);
    if (!ms_gpr__factor(f, e->kernel, e->stride, e->z, sf2, noise, e->upper)) return 0;
    memcpy(e->whitened, e->x, materials * sizeof(double));
    ms_gpr__forward(f, e->upper, e->stride, padded, e->whitened, e->columns, columns);
    fit = f->dot(e->whitened, e->whitened, (int)materials);
    determinant = ms_gpr__log_determinant(e->upper, e->stride, e->z);
    *likelihood = -0.5 * (fit + e->m * (determinant + e->z * 1.8378770664093454836)); /* log 2 pi */
    if (gradient == NULL) return 1;
    memset(e->inverse, 0, matrix * sizeof(double));
    ms_gpr__invert(f, e->upper, e->stride, padded, e->inverse);
    memset(minus, 0, list * sizeof(double));
    f->reduce(minus, e->stride, e->whitened, e->columns, e->inverse, e->stride, columns, padded, padded, MS_GPR__LOWER);
    for (at = 0; at < list; ++at) plus[at] = -minus[at];
    memset(e->upper, 0, matrix * sizeof(double));
    f->reduce(e->upper, e->stride, e->inverse, e->stride, e->inverse, e->stride, padded, padded, padded,
              MS_GPR__UPPER | MS_GPR__LOWER);
    for (i = 0; i < e->z; ++i)
        for (j = i; j < e->z; ++j) e->upper[(size_t)i * e->stride + (size_t)j] *= e->m;
    f->reduce(e->upper, e->stride, minus, e->stride, plus, e->stride, padded, padded, columns, MS_GPR__UPPER);
    memset(gradient, 0, ((size_t)MS_GPR__PLANE + 2) * sizeof(double));
    memset(gradient_points, 0, (size_t)MS_GPR__PLANE * e->stride * sizeof(double));
    for (i = 0; i < e->z; ++i) {
        const double *kernel = e->kernel + (size_t)i * e->stride;
        double *w = e->upper + (size_t)i * e->stride;
        gradient[MS_GPR__PLANE] += sf2 * w[i]; /* dK/dlog sf = 2 K */
        gradient[MS_GPR__PLANE + 1] += 0.5 * w[i];
        for (j = i + 1; j < e->z; ++j) gradient[MS_GPR__PLANE] += 2 * (w[j] *= kernel[j]);
        for (k = 0; k < MS_GPR__PLANE; ++k) { /* dK_ij/dp_ik = -K_ij (p_ik - p_jk); each pair stands twice in K */
            const double *p = points + (size_t)k * e->stride;
            double *slope = gradient_points + (size_t)k * e->stride, own = 0, stretch = 0;
            for (j = i + 1; j < e->z; ++j) {
                double d = p[i] - p[j], pull = w[j] * d;
                slope[j] += pull;
                own += pull;
                stretch += pull * d;
            }
            slope[i] -= own;
            gradient[k] += stretch;
        }
    }
    return 1;
}

static void ms_gpr__embedding_layout(ms_gpr__embedding *e, const ms_gpr_latent *plane, ms__arena *arena)
{
    size_t padded = (size_t)ms_gpr__padded(plane->z);
    e->kernels = plane->kernels;
    e->z = plane->z;
    e->m = plane->m;
    e->stride = plane->stride;
    e->columns = plane->columns;
    e->x = plane->x;
    e->kernel = ms_gpr__take(arena, padded, e->stride);
    e->upper = ms_gpr__take(arena, padded, e->stride);
    e->inverse = ms_gpr__take(arena, padded, e->stride);
    e->whitened = ms_gpr__take(arena, padded, e->columns);
    e->weight = ms_gpr__take(arena, ms__size_mul(2, e->columns), e->stride);
}

/* --- a space from its latents --- */

static void ms_gpr__latent_layout(ms_gpr_latent *p, ms__arena *arena)
{
    size_t z = (size_t)p->z, l = (size_t)MS_GPR__PLANE, padded = (size_t)ms_gpr__padded(p->z);
    p->latent = ms_gpr__take(arena, z, l);
    p->theta = ms_gpr__take(arena, l + 2, 1);
    p->center = ms_gpr__take(arena, p->columns, 1);
    p->origin = ms_gpr__take(arena, l, 1);
    p->x = ms_gpr__take(arena, padded, p->columns);
    p->points = ms_gpr__take(arena, l, p->stride);
    p->upper = ms_gpr__take(arena, padded, p->stride);
    p->weight = ms_gpr__take(arena, padded, p->columns);
}

/* A latent space with its centered materials; no latents yet. */
static ms_status ms_gpr__latent_make(const double *x, int z, int m, const ms_gpr_latent_options *o, ms_gpr_latent **out,
                                     ms_error *error)
{
    ms__arena arena = {NULL, 0};
    ms_gpr_latent *p;
    size_t size;
    int i, k;
    ms_status status;
    *out = NULL;
    if (x == NULL) return ms_gpr__null("x", error);
    if (z < 2 || z > MS_GPR__N_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "z is %d: expected 2 to %d", z, MS_GPR__N_MAX);
    if (m < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "m is %d: expected at least 1", m);
    status = ms_gpr__check_rows(x, z, m, MS_GPR__LARGEST, "material", error);
    if (status != MS_OK) return status;
    p = (ms_gpr_latent *)ms__alloc(&o->allocator, sizeof *p);
    if (p == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a latent space");
    memset(p, 0, sizeof *p);
    p->z = z;
    p->m = m;
    p->stride = ms_gpr__stride(z);
    p->columns = (size_t)ms_gpr__padded(m);
    p->level = ms_gpr__simd_pick(o->simd);
    p->kernels = ms_gpr__kernels_of(p->level);
    p->allocator = o->allocator;
    ms_gpr__latent_layout(p, &arena);
    size = arena.used;
    if (!ms_gpr__place(&p->allocator, &arena)) {
        ms__release(&o->allocator, p, sizeof *p);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a latent space of %d materials", z);
    }
    p->memory = arena.base;
    ms_gpr__latent_layout(p, &arena);
    memset(arena.base, 0, size);
    for (k = 0; k < m; ++k) {
        double sum = 0;
        for (i = 0; i < z; ++i) sum += x[(size_t)i * (size_t)m + (size_t)k] / z;
        p->center[k] = sum;
        for (i = 0; i < z; ++i)
            p->x[(size_t)i * p->columns + (size_t)k] = x[(size_t)i * (size_t)m + (size_t)k] - p->center[k];
    }
    p->constrained = o->space.low || o->space.high || o->space.steps || o->space.equal_count || o->space.list_count;
    status = p->constrained ? ms_gpr__space_make(x, z, m, &o->space, &p->allocator, &p->s, error) : MS_OK;
    p->constrained = p->constrained && status == MS_OK;
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

/* Everything that follows from latents and theta; jitter as in ms_gpr__condition. */
static ms_status ms_gpr__latent_condition(ms_gpr_latent *p, ms_error *error)
{
    double sf2 = exp(2 * p->theta[MS_GPR__PLANE]), sn2 = exp(2 * p->theta[MS_GPR__PLANE + 1]);
    int padded = ms_gpr__padded(p->z), columns = (int)p->columns, i, j, k;
    for (k = 0; k < MS_GPR__PLANE; ++k) {
        double scale = exp(-p->theta[k]), sum = 0;
        for (i = 0; i < p->z; ++i) sum += p->latent[i * MS_GPR__PLANE + k] / p->z;
        p->origin[k] = sum;
        for (i = 0; i < p->z; ++i)
            p->points[(size_t)k * p->stride + (size_t)i] = (p->latent[i * MS_GPR__PLANE + k] - sum) * scale;
    }
    for (p->jitter = 0; p->jitter < 2e-6; p->jitter = ms_gpr__next_jitter(p->jitter)) {
        ms_gpr__covariance(p->kernels, p->points, p->stride, p->z, MS_GPR__PLANE, sf2, p->upper);
        if (!ms_gpr__factor(p->kernels, p->upper, p->stride, p->z, sf2, sn2 + p->jitter * sf2, p->upper)) continue;
        memcpy(p->weight, p->x, (size_t)padded * p->columns * sizeof(double));
        ms_gpr__forward(p->kernels, p->upper, p->stride, padded, p->weight, p->columns, columns);
        for (i = p->z - 1; i >= 0; --i) { /* and U^-1 of that: u_ii a_i = b_i - sum over j > i of u_ij a_j */
            const double *u = p->upper + (size_t)i * p->stride;
            double *row = p->weight + (size_t)i * p->columns;
            for (j = i + 1; j < p->z; ++j) p->kernels->axpy(row, -u[j], p->weight + (size_t)j * p->columns, columns);
            for (k = 0; k < columns; ++k) row[k] /= u[i];
        }
        return MS_OK;
    }
    return ms__fail(error, MS_NOT_CONVERGED, 0,
                    "the covariance of %d latents is not positive definite even with 1e-6 sf^2 added to sn^2", p->z);
}

MS_API void ms_gpr_latent_destroy(ms_gpr_latent *plane)
{
    ms_allocator allocator;
    if (plane == NULL) return;
    allocator = plane->allocator;
    if (plane->constrained) ms_gpr__space_free(&plane->s);
    ms_gpr__release(&allocator, plane->memory);
    ms__release(&allocator, plane, sizeof *plane);
}

MS_API int ms_gpr_latent_count(const ms_gpr_latent *plane) { return plane ? plane->z : 0; }
MS_API const double *ms_gpr_latent_points(const ms_gpr_latent *plane) { return plane ? plane->latent : NULL; }
MS_API const double *ms_gpr_latent_theta(const ms_gpr_latent *plane) { return plane ? plane->theta : NULL; }

/* --- maps both ways --- */

/* Kernel between a latent point and the training ones, [padded z]; padding is 0. */
static void ms_gpr__latent_kernel(const ms_gpr_latent *p, const double *latent, double *kernel)
{
    double sf2 = exp(2 * p->theta[MS_GPR__PLANE]), scaled[3];
    int padded = ms_gpr__padded(p->z), i, k;
    for (k = 0; k < MS_GPR__PLANE; ++k) scaled[k] = (latent[k] - p->origin[k]) * exp(-p->theta[k]);
    for (i = 0; i < padded; ++i) kernel[i] = 0;
    for (k = 0; k < MS_GPR__PLANE; ++k) {
        const double *q = p->points + (size_t)k * p->stride;
        for (i = 0; i < p->z; ++i) kernel[i] += (scaled[k] - q[i]) * (scaled[k] - q[i]);
    }
    p->kernels->exponentials(kernel, padded, sf2);
    for (i = p->z; i < padded; ++i) kernel[i] = 0;
}

/* center + X' K'^-1 k (3.11); x [columns], padding 0. */
static void ms_gpr__latent_material(const ms_gpr_latent *p, const double *kernel, double *x)
{
    int i;
    memcpy(x, p->center, p->columns * sizeof *x);
    for (i = 0; i < p->z; ++i) p->kernels->axpy(x, kernel[i], p->weight + (size_t)i * p->columns, (int)p->columns);
}

/* Moved to where it keeps what the plane keeps: x [m]; scaled: [m] */
static void ms_gpr__latent_project(const ms_gpr_latent *p, double *x, double *scaled)
{
    int k;
    if (!p->constrained) return;
    for (k = 0; k < p->s.m; ++k) scaled[k] = (x[k] - p->s.low[k]) * p->s.per[k];
    ms_gpr__space_project(&p->s, scaled);
    ms_gpr__space_material(&p->s, scaled, x);
}

/* sf^2 - k' K'^-1 k; the kernel is used up. */
static double ms_gpr__latent_variance(const ms_gpr_latent *p, double *kernel)
{
    double variance;
    int padded = ms_gpr__padded(p->z);
    ms_gpr__forward_vector(p->kernels, p->upper, p->stride, padded, kernel);
    variance = exp(2 * p->theta[MS_GPR__PLANE]) - p->kernels->dot(kernel, kernel, padded);
    return variance > 0 ? variance : 0;
}

MS_API ms_status ms_gpr_latent_map(const ms_gpr_latent *plane, const double *latent, int count, double *x,
                                   double *variance, ms_error *error)
{
    size_t m;
    double *kernel, *material;
    ms_status status;
    int i;
    if (plane == NULL || latent == NULL) return ms_gpr__null(plane ? "latent" : "plane", error);
    if (count < 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d: expected at least 0", count);
    status = ms_gpr__check_rows(latent, count, MS_GPR__PLANE, MS_GPR__LARGEST, "latent", error);
    if (status != MS_OK) return status;
    m = (size_t)plane->m;
    kernel = ms_gpr__scratch(&plane->allocator, plane->stride + plane->columns);
    if (kernel == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a material");
    material = kernel + plane->stride;
    for (i = 0; i < count; ++i) {
        ms_gpr__latent_kernel(plane, latent + (size_t)i * (size_t)MS_GPR__PLANE, kernel);
        if (x) {
            ms_gpr__latent_material(plane, kernel, material);
            memcpy(x + (size_t)i * m, material, m * sizeof *x);
            ms_gpr__latent_project(plane, x + (size_t)i * m, material);
        }
        if (variance) variance[i] = ms_gpr__latent_variance(plane, kernel);
    }
    ms_gpr__release(&plane->allocator, kernel);
    return MS_OK;
}

/* The training latent whose material is nearest to x [m]. */
static const double *ms_gpr__latent_nearest(const ms_gpr_latent *p, const double *x)
{
    double least = HUGE_VAL;
    int best = 0, i, k;
    for (i = 0; i < p->z; ++i) {
        double sum = 0;
        for (k = 0; k < p->m; ++k) {
            double d = p->center[k] + p->x[(size_t)i * p->columns + (size_t)k] - x[k];
            sum += d * d;
        }
        if (sum < least) least = sum, best = i;
    }
    return p->latent + best * MS_GPR__PLANE;
}

/* --- fit --- */

/* What the minimizer sees: q = [log sf, log sn, points by dimension]; lengths are 1. */
typedef struct ms_gpr__latent_problem {
    ms_gpr__embedding e;
    double prior;
    double *points, *slopes; /* [l][stride] */
    const ms_progress *progress;
    int evaluations, limit;
} ms_gpr__latent_problem;

/* Minus the log posterior a datum. */
static int ms_gpr__latent_objective(void *context, const double *q, double *value, double *gradient)
{
    ms_gpr__latent_problem *p = (ms_gpr__latent_problem *)context;
    double noise = exp(2 * q[1]), scale = -1 / ((double)p->e.z * p->e.m), likelihood, theta[5];
    int i, k;
    if (p->progress->report && p->progress->report(p->progress->user, (double)p->evaluations / p->limit)) return -1;
    if (p->evaluations < p->limit) ++p->evaluations;
    for (k = 0; k < MS_GPR__PLANE; ++k)
        memcpy(p->points + (size_t)k * p->e.stride, q + 2 + k * p->e.z, (size_t)p->e.z * sizeof *q);
    if (!ms_gpr__embedding_evaluate(&p->e, p->points, exp(2 * q[0]), noise, &likelihood, theta, p->slopes)) return 0;
    gradient[0] = scale * theta[MS_GPR__PLANE];
    gradient[1] = scale * 2 * noise * theta[MS_GPR__PLANE + 1];
    for (k = 0; k < MS_GPR__PLANE; ++k)
        for (i = 0; i < p->e.z; ++i) {
            int at = 2 + k * p->e.z + i;
            likelihood -= 0.5 * p->prior * q[at] * q[at];
            gradient[at] = scale * (p->slopes[(size_t)k * p->e.stride + (size_t)i] - p->prior * q[at]);
        }
    *value = scale * likelihood;
    return 1;
}

/* The first l principal components of the materials, each of variance 1, as points [l][z]: orthogonal iteration with X
   X'. A component without variance stays 0. axis: [columns] scratch. */
static void ms_gpr__latent_components(const ms_gpr_latent *p, double *points, double *axis)
{
    ms__rng rng = ms__rng_make(0, 0);
    int columns = (int)p->columns, pass, i, j, k;
    double total = p->kernels->dot(p->x, p->x, p->z * columns);
    for (i = 0; i < MS_GPR__PLANE * p->z; ++i) points[i] = ms__rng_uniform(&rng) - 0.5;
    for (pass = 0; pass < 60; ++pass) {
        for (k = 0; k < MS_GPR__PLANE; ++k) {
            double *component = points + k * p->z, norm2 = 0, scale;
            memset(axis, 0, p->columns * sizeof *axis);
            for (i = 0; i < p->z; ++i) p->kernels->axpy(axis, component[i], p->x + (size_t)i * p->columns, columns);
            for (i = 0; i < p->z; ++i) component[i] = p->kernels->dot(axis, p->x + (size_t)i * p->columns, columns);
            for (j = 0; j < k; ++j) {
                const double *before = points + j * p->z;
                double overlap = 0;
                for (i = 0; i < p->z; ++i) overlap += component[i] * before[i] / p->z;
                for (i = 0; i < p->z; ++i) component[i] -= overlap * before[i];
            }
            for (i = 0; i < p->z; ++i) norm2 += component[i] * component[i] / p->z;
            scale = norm2 > 1e-20 * total * total ? 1 / sqrt(norm2) : 0;
            for (i = 0; i < p->z; ++i) component[i] *= scale;
        }
    }
}

/* Root mean square of what the space makes of its own latents less its materials. */
static double ms_gpr__latent_error(const ms_gpr_latent *p, double *kernel, double *material)
{
    double sum = 0;
    int i, k;
    for (i = 0; i < p->z; ++i) {
        ms_gpr__latent_kernel(p, p->latent + i * MS_GPR__PLANE, kernel);
        ms_gpr__latent_material(p, kernel, material);
        for (k = 0; k < p->m; ++k) {
            double d = material[k] - p->center[k] - p->x[(size_t)i * p->columns + (size_t)k];
            sum += d * d;
        }
    }
    return sqrt(sum / ((double)p->z * p->m));
}

/* Scratch of a fit. */
typedef struct ms_gpr__latent_scratch {
    double *q, *best, *low, *start, *work;
} ms_gpr__latent_scratch;

static void ms_gpr__latent_scratch_layout(const ms_gpr_latent *p, ms_gpr__latent_problem *problem,
                                          ms_gpr__latent_scratch *s, ms__arena *arena)
{
    size_t count = (size_t)MS_GPR__PLANE * (size_t)p->z + 2;
    s->q = ms_gpr__take(arena, count, 1);
    s->best = ms_gpr__take(arena, count, 1);
    s->low = ms_gpr__take(arena, count, 1);
    s->start = ms_gpr__take(arena, count, 1);
    s->work = ms_gpr__take(arena,
                           ms__size_add(ms_gpr__minimize_doubles((int)count), ms__size_add(p->stride, p->columns)), 1);
    ms_gpr__embedding_layout(&problem->e, p, arena);
    problem->points = ms_gpr__take(arena, p->stride, (size_t)MS_GPR__PLANE);
    problem->slopes = ms_gpr__take(arena, p->stride, (size_t)MS_GPR__PLANE);
}

/* Latents and theta: every start for a while, then the best of them to the end. spread: root mean square of the
   materials. */
static ms_status ms_gpr__latent_search(ms_gpr_latent *plane, double spread, ms_gpr__latent_problem *problem,
                                       const ms_gpr__latent_scratch *s, ms_error *error)
{
    static const double scale[] = {0.5, 0.3, 1}; /* of the principal components, in lengths */
    int count = MS_GPR__PLANE * plane->z, starts = 3, i, k;
    double best = HUGE_VAL;
    ms_gpr__search search;
    memset(&search, 0, sizeof search);
    search.f = ms_gpr__latent_objective;
    search.context = problem;
    search.count = count + 2;
    search.low = s->low;
    search.step = 1;
    search.tolerance = 1e-9;
    s->low[0] = log(spread) - 5;
    s->low[1] = log(1e-3 * spread);
    for (i = 0; i < count; ++i) s->low[2 + i] = -1e3;
    ms_gpr__latent_components(plane, s->start, s->work);
    for (k = 0; k <= starts; ++k) {
        ms_gpr__minimum found;
        if (k < starts) {
            s->q[0] = log(spread);
            s->q[1] = log(0.3 * spread);
            for (i = 0; i < count; ++i) s->q[2 + i] = scale[k] * s->start[i];
            search.evaluations = MS_GPR__LATENT_TRIAL;
        } else {
            memcpy(s->q, s->best, ((size_t)count + 2) * sizeof(double));
            search.evaluations = problem->limit - problem->evaluations;
        }
        found = ms_gpr__minimize(&search, s->q, s->work);
        if (found.stopped)
            return ms__fail(error, MS_CANCELLED, 0, "cancelled after %d evaluations", problem->evaluations);
        if (!(found.value < best)) continue;
        best = found.value;
        memcpy(s->best, s->q, ((size_t)count + 2) * sizeof(double));
    }
    if (!(best < HUGE_VAL)) return ms__fail(error, MS_NOT_CONVERGED, 0, "the likelihood is not defined at any start");
    for (k = 0; k < MS_GPR__PLANE; ++k)
        for (i = 0; i < plane->z; ++i) plane->latent[i * MS_GPR__PLANE + k] = s->best[2 + k * plane->z + i];
    plane->theta[MS_GPR__PLANE] = s->best[0];
    plane->theta[MS_GPR__PLANE + 1] = s->best[1];
    return ms_gpr__latent_condition(plane, error);
}

MS_API ms_status ms_gpr_latent_fit(const double *x, int z, int m, const ms_gpr_latent_options *options,
                                   ms_gpr_latent **out, ms_gpr_latent_report *report, ms_error *error)
{
    ms_gpr_latent_options o;
    ms_gpr_latent *p;
    ms_gpr__latent_problem problem;
    ms_gpr__latent_scratch scratch;
    ms__arena arena = {NULL, 0};
    double spread;
    ms_status status;
    if (out == NULL) return ms_gpr__null("out", error);
    *out = NULL;
    if (options) o = *options;
    else memset(&o, 0, sizeof o);
    status = ms_gpr__check_range("prior", o.prior, 0, MS_GPR__LARGEST, error);
    if (status == MS_OK) status = ms_gpr__latent_make(x, z, m, &o, &p, error);
    if (status != MS_OK) return status;
    spread = sqrt(p->kernels->dot(p->x, p->x, z * (int)p->columns) / ((double)z * m));
    if (!(spread > 1e-150) || !(spread * spread > 1e-26 * p->kernels->dot(p->center, p->center, (int)p->columns) / m)) {
        ms_gpr_latent_destroy(p);
        return ms__fail(error, MS_BAD_DATA, 0, "all %d materials are equal", z);
    }
    memset(&problem, 0, sizeof problem);
    ms_gpr__latent_scratch_layout(p, &problem, &scratch, &arena);
    if (!ms_gpr__place(&o.allocator, &arena)) {
        ms_gpr_latent_destroy(p);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the embedding of %d materials", z);
    }
    ms_gpr__latent_scratch_layout(p, &problem, &scratch, &arena);
    memset(problem.points, 0, (size_t)MS_GPR__PLANE * p->stride * sizeof(double));
    problem.prior = o.prior;
    problem.progress = &o.progress;
    problem.limit = MS_GPR__LATENT_LIMIT;
    status = ms_gpr__latent_search(p, spread, &problem, &scratch, error);
    if (status == MS_OK && report) {
        double sf2 = exp(2 * p->theta[MS_GPR__PLANE]), noise = exp(2 * p->theta[MS_GPR__PLANE + 1]) + p->jitter * sf2;
        ms_gpr__embedding_evaluate(&problem.e, p->points, sf2, noise, &report->likelihood, NULL, NULL);
        report->error = ms_gpr__latent_error(p, scratch.work, scratch.work + p->stride);
        report->evaluations = problem.evaluations;
    }
    ms_gpr__release(&o.allocator, arena.base);
    if (status != MS_OK) ms_gpr_latent_destroy(p);
    else *out = p;
    return status;
}

/* ---- maps ------------------------------------------------------------------------------------------------------ */

MS_API ms_gpr_grid ms_gpr_grid_around(const ms_gpr_latent *plane, int resolution)
{
    ms_gpr_grid grid;
    double low[2], high[2], side = 0;
    int i, k;
    memset(&grid, 0, sizeof grid);
    if (plane == NULL) return grid;
    for (k = 0; k < 2; ++k) {
        double length = exp(plane->theta[k]), margin;
        low[k] = high[k] = plane->latent[k];
        for (i = 1; i < plane->z; ++i) {
            double v = plane->latent[i * MS_GPR__PLANE + k];
            if (v < low[k]) low[k] = v;
            if (v > high[k]) high[k] = v;
        }
        margin = 0.25 * (high[k] - low[k]);
        if (!(margin < length && margin > 0)) margin = length;
        low[k] -= margin;
        high[k] += margin;
        if ((high[k] - low[k]) / length > side) side = (high[k] - low[k]) / length;
    }
    for (k = 0; k < 2; ++k) {
        double more = 0.5 * (side * exp(plane->theta[k]) - (high[k] - low[k]));
        low[k] -= more;
        high[k] += more;
    }
    grid.x0 = low[0];
    grid.y0 = low[1];
    grid.x1 = high[0];
    grid.y1 = high[1];
    grid.columns = grid.rows = resolution;
    return grid;
}

MS_API void ms_gpr_grid_point(const ms_gpr_grid *grid, int column, int row, double latent[2])
{
    if (grid == NULL || latent == NULL) return;
    latent[0] = grid->x0 + (grid->x1 - grid->x0) * column / (grid->columns - 1);
    latent[1] = grid->y0 + (grid->y1 - grid->y0) * row / (grid->rows - 1);
}

MS_API double ms_gpr_grid_value(const ms_gpr_grid *grid, const double *map, double x, double y)
{
    double u = 0, v = 0;
    const double *p;
    int i, j;
    if (grid == NULL || map == NULL) return 0;
    if (x == x && x > grid->x0)
        u = (x < grid->x1 ? (x - grid->x0) / (grid->x1 - grid->x0) : 1) * (grid->columns - 1); /* NaN: 0 */
    if (y == y && y > grid->y0) v = (y < grid->y1 ? (y - grid->y0) / (grid->y1 - grid->y0) : 1) * (grid->rows - 1);
    i = u < grid->columns - 2 ? (int)u : grid->columns - 2;
    j = v < grid->rows - 2 ? (int)v : grid->rows - 2;
    u -= i;
    v -= j;
    p = map + (size_t)j * (size_t)grid->columns + (size_t)i;
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[grid->columns] + u * p[grid->columns + 1]);
}

static ms_status ms_gpr__grid_check(const ms_gpr_latent *plane, const ms_gpr_grid *grid, ms_error *error)
{
    if (plane == NULL || grid == NULL) return ms_gpr__null(plane ? "grid" : "plane", error);
    if (grid->columns < 2 || grid->rows < 2 || grid->columns > 32768 || grid->rows > 32768 || !ms__finite(grid->x0) ||
        !ms__finite(grid->y0) || !ms__finite(grid->x1) || !ms__finite(grid->y1) || !(grid->x0 < grid->x1) ||
        !(grid->y0 < grid->y1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "a grid of %d x %d points from (%g, %g) to (%g, %g)",
                        grid->columns, grid->rows, grid->x0, grid->y0, grid->x1, grid->y1);
    return MS_OK;
}

/* The materials of a grid, [rows][columns][m], to be released; variance [rows][columns], or NULL. */
static ms_status ms_gpr__grid_make(const ms_gpr_latent *plane, const ms_gpr_grid *grid, double **x, double *variance,
                                   ms_error *error)
{
    ms_status status = ms_gpr__grid_check(plane, grid, error);
    size_t count, materials, i;
    if (status != MS_OK) return status;
    count = (size_t)grid->columns * (size_t)grid->rows;
    materials = ms__size_mul(count, (size_t)plane->m);
    *x = ms_gpr__scratch(&plane->allocator, ms__size_add(materials, 2 * count));
    if (*x == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the materials of %d x %d points", grid->columns,
                        grid->rows);
    for (i = 0; i < count; ++i)
        ms_gpr_grid_point(grid, (int)(i % (size_t)grid->columns), (int)(i / (size_t)grid->columns),
                          *x + materials + 2 * i);
    status = ms_gpr_latent_map(plane, *x + materials, (int)count, *x, variance, error);
    if (status != MS_OK) ms_gpr__release(&plane->allocator, *x);
    return status;
}

MS_API ms_status ms_gpr_map_preference(const ms_gpr_latent *plane, const ms_gpr *gp, const ms_gpr_grid *grid,
                                       double *mean, double *sigma, ms_error *error)
{
    double *x;
    ms_status status;
    int count, i;
    if (gp == NULL || plane == NULL) return ms_gpr__null(gp ? "plane" : "gp", error);
    if (gp->m != plane->m)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "gp has %d parameters and plane %d: expected the same", gp->m,
                        plane->m);
    status = ms_gpr__grid_make(plane, grid, &x, NULL, error);
    if (status != MS_OK) return status;
    count = grid->columns * grid->rows;
    status = ms_gpr_predict(gp, x, count, mean, sigma, error);
    for (i = 0; status == MS_OK && sigma && i < count; ++i) sigma[i] = sqrt(sigma[i]);
    ms_gpr__release(&plane->allocator, x);
    return status;
}

MS_API ms_status ms_gpr_map_confidence(const ms_gpr_latent *plane, const ms_gpr_grid *grid, double *confidence,
                                       ms_error *error)
{
    double *x;
    int i;
    ms_status status = ms_gpr__grid_check(plane, grid, error);
    if (status == MS_OK && confidence == NULL) status = ms_gpr__null("confidence", error);
    if (status == MS_OK) status = ms_gpr__grid_make(plane, grid, &x, confidence, error);
    if (status != MS_OK) return status;
    for (i = 0; i < grid->columns * grid->rows; ++i) confidence[i] = 1 - confidence[i] / exp(2 * plane->theta[2]);
    ms_gpr__release(&plane->allocator, x);
    return MS_OK;
}

/* --- similarity --- */

static ms_status ms_gpr__similarity_check(const ms_gpr_latent *plane, const ms_gpr_similarity *s, ms_error *error)
{
    ms_status status;
    if (plane == NULL || s == NULL) return ms_gpr__null(plane ? "similarity" : "plane", error);
    if (s->x == NULL || (s->pixels > 0 && s->render == NULL))
        return ms_gpr__null(s->x ? "similarity->render" : "similarity->x", error);
    status = ms_gpr__check_range("similarity->scale", s->scale, 0, MS_GPR__LARGEST, error);
    return status == MS_OK ? ms_gpr__check_rows(s->x, 1, plane->m, MS_GPR__LARGEST, "reference", error) : status;
}

/* Two pictures, the first of them the reference's. */
static ms_status ms_gpr__pictures(const ms_gpr_latent *plane, const ms_gpr_similarity *s, float **pictures,
                                  ms_error *error)
{
    ms_status status = MS_OK;
    size_t size = ms__size_mul(2 * sizeof(float), s->pixels);
    *pictures = (float *)ms__alloc(&plane->allocator, size);
    if (*pictures == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for two pictures of %z values", s->pixels);
    if (s->pixels > 0) status = s->render(s->user, s->x, *pictures);
    if (status == MS_OK) return MS_OK;
    ms__release(&plane->allocator, *pictures, size);
    return ms__fail(error, status, 0, "render failed for the reference");
}

static void ms_gpr__release_pictures(const ms_gpr_latent *plane, const ms_gpr_similarity *s, float *pictures)
{
    ms__release(&plane->allocator, pictures, 2 * sizeof(float) * s->pixels);
}

/* s(x*, x); 0 where a picture has a value that is not finite. */
static ms_status ms_gpr__similarity(const ms_gpr_similarity *s, int m, const double *x, float *pictures, double *value,
                                    ms_error *error)
{
    double sum = 0, scale = s->scale > 0 ? s->scale : 0.1;
    float *picture = pictures + s->pixels;
    size_t i, count = s->pixels > 0 ? s->pixels : (size_t)m;
    if (s->pixels > 0) {
        ms_status status = s->render(s->user, x, picture);
        if (status != MS_OK) return ms__fail(error, status, 0, "render failed");
    }
    for (i = 0; i < count; ++i) {
        double d = s->pixels > 0 ? (double)picture[i] - (double)pictures[i] : x[i] - s->x[i];
        sum += d * d;
    }
    *value = ms__finite(sum) ? exp(-0.5 * sum / ((double)count * scale * scale)) : 0;
    return MS_OK;
}

MS_API ms_status ms_gpr_map_similarity(const ms_gpr_latent *plane, const ms_gpr_similarity *similarity,
                                       const ms_gpr_grid *grid, double *map, ms_error *error)
{
    double *x;
    float *pictures;
    int count, i;
    ms_status status = ms_gpr__similarity_check(plane, similarity, error);
    if (status == MS_OK && map == NULL) status = ms_gpr__null("map", error);
    if (status == MS_OK) status = ms_gpr__grid_make(plane, grid, &x, NULL, error);
    if (status != MS_OK) return status;
    status = ms_gpr__pictures(plane, similarity, &pictures, error);
    if (status == MS_OK) {
        count = grid->columns * grid->rows;
        for (i = 0; status == MS_OK && i < count; ++i)
            status = ms_gpr__similarity(similarity, plane->m, x + (size_t)i * (size_t)plane->m, pictures, &map[i],
                                        error);
        ms_gpr__release_pictures(plane, similarity, pictures);
    }
    ms_gpr__release(&plane->allocator, x);
    return status;
}

/* --- automatic variants --- */

enum {
    MS_GPR__MOVES = 40,  /* of a pattern search, at most */
    MS_GPR__HALVINGS = 6 /* of its step: from a cell to a 64th */
};

/* Every point of the plane that was looked at, with its similarity and score. */
typedef struct ms_gpr__visited {
    const ms_gpr_latent *plane;
    const ms_gpr *gp;
    const ms_gpr_similarity *similarity;
    float *pictures; /* [2][pixels] */
    double *x;       /* [m] of the point in hand */
    ms_gpr_variant *seen;
    int count;
    double best, floor; /* the scores that count as 1 and 0 */
} ms_gpr__visited;

static ms_status ms_gpr__visit(ms_gpr__visited *visited, double a, double b, ms_error *error)
{
    ms_gpr_variant *v = &visited->seen[visited->count];
    ms_status status;
    v->latent[0] = a;
    v->latent[1] = b;
    status = ms_gpr_latent_map(visited->plane, v->latent, 1, visited->x, &v->confidence, error);
    v->confidence = 1 - v->confidence / exp(2 * visited->plane->theta[2]);
    if (status == MS_OK) status = ms_gpr_predict(visited->gp, visited->x, 1, &v->score, NULL, error);
    if (status == MS_OK)
        status = ms_gpr__similarity(visited->similarity, visited->plane->m, visited->x, visited->pictures,
                                    &v->similarity, error);
    if (status == MS_OK) ++visited->count;
    return status;
}

static double ms_gpr__visited_value(const ms_gpr__visited *visited, const ms_gpr_variant *v, double lambda)
{
    return v->confidence *
        (lambda * v->similarity + (1 - lambda) * (v->score - visited->floor) / (visited->best - visited->floor));
}

/* The best so far; of those that are two steps away from a point, where one is given. */
static ms_gpr_variant ms_gpr__visited_best(const ms_gpr__visited *visited, double lambda, const double *away,
                                           const double *step)
{
    ms_gpr_variant chosen = visited->seen[0];
    int i;
    chosen.value = -HUGE_VAL;
    for (i = 0; i < visited->count; ++i) {
        const ms_gpr_variant *v = &visited->seen[i];
        double value = ms_gpr__visited_value(visited, v, lambda);
        if (!(value > chosen.value)) continue;
        if (away && fabs(v->latent[0] - away[0]) < 2 * step[0] && fabs(v->latent[1] - away[1]) < 2 * step[1]) continue;
        chosen = *v;
        chosen.value = value;
    }
    return chosen;
}

/* Pattern searches from the best so far and from the best elsewhere, inside the grid: the four neighbors at a step,
   which is halved where none is better. */
static ms_status ms_gpr__visited_refine(ms_gpr__visited *visited, const ms_gpr_grid *grid, double lambda,
                                        ms_error *error)
{
    double cell[2], top[2];
    int start, halvings, moves, side;
    cell[0] = (grid->x1 - grid->x0) / (grid->columns - 1), cell[1] = (grid->y1 - grid->y0) / (grid->rows - 1);
    for (start = 0; start < 2; ++start) {
        ms_gpr_variant at = ms_gpr__visited_best(visited, lambda, start ? top : NULL, cell);
        double step = 1;
        if (start == 0) memcpy(top, at.latent, sizeof top);
        for (halvings = 0, moves = 0; halvings < MS_GPR__HALVINGS && moves < MS_GPR__MOVES / 2; ++moves) {
            ms_gpr_variant center = at;
            for (side = 0; side < 4; ++side) {
                double sign = side % 2 ? -step : step, value;
                double a = ms_gpr__clamp(center.latent[0] + (side < 2 ? sign * cell[0] : 0), grid->x0, grid->x1);
                double b = ms_gpr__clamp(center.latent[1] + (side < 2 ? 0 : sign * cell[1]), grid->y0, grid->y1);
                ms_status status = ms_gpr__visit(visited, a, b, error);
                if (status != MS_OK) return status;
                value = ms_gpr__visited_value(visited, &visited->seen[visited->count - 1], lambda);
                if (!(value > at.value)) continue;
                at = visited->seen[visited->count - 1];
                at.value = value;
            }
            if (at.value > center.value) continue;
            step *= 0.5;
            ++halvings;
        }
    }
    return MS_OK;
}

MS_API ms_status ms_gpr_variants(const ms_gpr_latent *plane, const ms_gpr *gp, const ms_gpr_similarity *similarity,
                                 const ms_gpr_grid *grid, const double *lambda, int count, double best,
                                 ms_gpr_variant *variant, double *x, ms_error *error)
{
    ms_gpr__visited visited;
    double at[2];
    size_t points, x_size, seen_size;
    ms_status status = ms_gpr__grid_check(plane, grid, error);
    int row, column, i;
    if (status == MS_OK) status = ms_gpr__similarity_check(plane, similarity, error);
    if (status != MS_OK) return status;
    if (gp == NULL || lambda == NULL || variant == NULL)
        return ms_gpr__null(gp == NULL ? "gp" : lambda ? "variant" : "lambda", error);
    if (gp->m != plane->m)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "gp has %d parameters and plane %d: expected the same", gp->m,
                        plane->m);
    if (count < 1 || !ms__finite(best) || best < 0)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d and best %g: expected at least 1, and at least 0",
                        count, best);
    for (i = 0; i < count; ++i)
        if (!ms__finite(lambda[i]) || lambda[i] < 0 || lambda[i] > 1)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "lambda[%d] is %g: expected 0 to 1", i, lambda[i]);
    points = (size_t)grid->columns * (size_t)grid->rows + 1 + ms__size_mul((size_t)count, 4 * MS_GPR__MOVES);
    seen_size = ms__size_mul(points, sizeof *visited.seen);
    x_size = (size_t)plane->m * sizeof *visited.x;
    visited.plane = plane;
    visited.gp = gp;
    visited.similarity = similarity;
    visited.count = 0;
    visited.x = (double *)ms__alloc(&plane->allocator, x_size);
    visited.seen = (ms_gpr_variant *)ms__alloc(&plane->allocator, seen_size);
    status = visited.x && visited.seen ? ms_gpr__pictures(plane, similarity, &visited.pictures, error)
                                       : ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z points", points);
    if (status == MS_OK) {
        const double *nearest = ms_gpr__latent_nearest(plane, similarity->x);
        status = ms_gpr__visit(&visited, nearest[0], nearest[1], error);
        for (row = 0; row < grid->rows; ++row)
            for (column = 0; column < grid->columns && status == MS_OK; ++column) {
                ms_gpr_grid_point(grid, column, row, at);
                status = ms_gpr__visit(&visited, at[0], at[1], error);
            }
        visited.floor = ms_gpr__floor_of(gp);
        visited.best = best > visited.floor ? best : -HUGE_VAL;
        for (i = 0; !(best > visited.floor) && i < visited.count; ++i)
            if (visited.seen[i].score > visited.best) visited.best = visited.seen[i].score;
        if (!(visited.best > visited.floor)) visited.best = visited.floor + 1;
        for (i = 0; i < count && status == MS_OK; ++i)
            status = ms_gpr__visited_refine(&visited, grid, lambda[i], error);
        for (i = 0; i < count && status == MS_OK; ++i) {
            variant[i] = ms_gpr__visited_best(&visited, lambda[i], NULL, NULL);
            if (x)
                status = ms_gpr_latent_map(plane, variant[i].latent, 1, x + (size_t)i * (size_t)plane->m, NULL, error);
        }
        ms_gpr__release_pictures(plane, similarity, visited.pictures);
    }
    ms__release(&plane->allocator, visited.seen, seen_size);
    ms__release(&plane->allocator, visited.x, x_size);
    return status;
}
#endif /* MS_GPR_NO_PLANE */

#endif /* MS_GPR_IMPLEMENTATION */

#ifdef MS_GPR__PASS
/* ---- kernels --------------------------------------------------------------------------------------------------- */

/* One level and precision an inclusion: MS_GPR__PASS is the level (ms_simd), MS_GPR__FLOAT the precision. */
#define MS_GPR__JOIN_(a, b) a##b
#define MS_GPR__JOIN(a, b) MS_GPR__JOIN_(a, b)
#if MS_GPR__PASS == 3
#define MS_GPR__LEVEL avx2
#elif MS_GPR__PASS == 2
#define MS_GPR__LEVEL base
#else
#define MS_GPR__LEVEL scalar
#endif
#if MS_GPR__FLOAT
#define MS_GPR__KERNEL(name) MS_GPR__JOIN(ms_gpr__##name##_f_, MS_GPR__LEVEL)
#define MS_GPR__REAL float
#define MS_GPR__INT int32_t
#else
#define MS_GPR__KERNEL(name) MS_GPR__JOIN(ms_gpr__##name##_, MS_GPR__LEVEL)
#define MS_GPR__REAL double
#define MS_GPR__INT int64_t
#endif
#define MS_GPR__V MS_GPR__KERNEL(v)

/* Vectors are the compiler's own (GCC, Clang), with the language's operators. MADD a b + c and NMADD c - a b are fused
   where the level fuses. ROUND goes to the nearest whole number. POW2 is of a whole number in the normal range. KEEP is
   v where x > limit, else 0. */
#if MS_GPR__PASS == 1
typedef MS_GPR__REAL MS_GPR__V;
#define MS_GPR__LANES 1
#define MS_GPR__LOAD(p) (*(p))
#define MS_GPR__STORE(p, v) (*(p) = (v))
#define MS_GPR__SET(x) (x)
#define MS_GPR__ROUND(a) ((MS_GPR__REAL)(int)((a) - (MS_GPR__REAL)0.5)) /* of a <= 0 */
#define MS_GPR__POW2(a) MS_GPR__JOIN(ms_gpr__pow2_, MS_GPR__REAL)(a)
#define MS_GPR__KEEP(x, limit, v) ((x) > (limit) ? (v) : 0)
#else
#define MS_GPR__BYTES (MS_GPR__PASS == 3 ? 32 : 16)
#define MS_GPR__LANES (MS_GPR__BYTES / (MS_GPR__FLOAT ? 4 : 8))
typedef MS_GPR__REAL MS_GPR__V __attribute__((vector_size(MS_GPR__BYTES)));
typedef MS_GPR__REAL MS_GPR__KERNEL(loose)
    __attribute__((vector_size(MS_GPR__BYTES), aligned(sizeof(MS_GPR__REAL)), may_alias));
typedef MS_GPR__INT MS_GPR__KERNEL(bits) __attribute__((vector_size(MS_GPR__BYTES)));
#define MS_GPR__LOAD(p) ((MS_GPR__V) * (const MS_GPR__KERNEL(loose) *)(p))
#define MS_GPR__STORE(p, v) (*(MS_GPR__KERNEL(loose) *)(p) = (v))
#define MS_GPR__SET(x) MS_GPR__KERNEL(set)(x)
#define MS_GPR__POW2(a)                                                                                               \
    ((MS_GPR__V)((MS_GPR__KERNEL(bits))(                                                                              \
                     (a) + MS_GPR__SET((MS_GPR__REAL)(MS_GPR__FLOAT ? 12582912.0 + 127 : 6755399441055744.0 + 1023))) \
                 << (MS_GPR__FLOAT ? 23 : 52)))
#define MS_GPR__KEEP(x, limit, v) ((MS_GPR__V)(((x) > (limit)) & (MS_GPR__KERNEL(bits))(v)))
static inline MS_GPR__V MS_GPR__KERNEL(set)(MS_GPR__REAL x)
{
    const MS_GPR__V zero = {0};
    return x - zero; /* -0 stays -0 */
}
#endif
#if MS_GPR__PASS == 3 && MS_GPR__FLOAT
#define MS_GPR__MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define MS_GPR__NMADD(a, b, c) _mm256_fnmadd_ps(a, b, c)
#define MS_GPR__ROUND(a) _mm256_round_ps(a, 8)
#elif MS_GPR__PASS == 3
#define MS_GPR__MADD(a, b, c) _mm256_fmadd_pd(a, b, c)
#define MS_GPR__NMADD(a, b, c) _mm256_fnmadd_pd(a, b, c)
#define MS_GPR__ROUND(a) _mm256_round_pd(a, 8)
#elif MS_GPR__PASS == 2 && defined(MS__NEON) && MS_GPR__FLOAT
#define MS_GPR__MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_GPR__NMADD(a, b, c) vfmsq_f32(c, a, b)
#define MS_GPR__ROUND(a) vrndnq_f32(a)
#elif MS_GPR__PASS == 2 && defined(MS__NEON)
#define MS_GPR__MADD(a, b, c) vfmaq_f64(c, a, b)
#define MS_GPR__NMADD(a, b, c) vfmsq_f64(c, a, b)
#define MS_GPR__ROUND(a) vrndnq_f64(a)
#else
#define MS_GPR__MADD(a, b, c) ((a) * (b) + (c))
#define MS_GPR__NMADD(a, b, c) ((c) - (a) * (b))
#if MS_GPR__PASS == 2
#define MS_GPR__ROUND(a)                                                      \
    (MS_GPR__FLOAT ? (MS_GPR__V)_mm_cvtepi32_ps(_mm_cvtps_epi32((__m128)(a))) \
                   : (MS_GPR__V)_mm_cvtepi32_pd(_mm_cvtpd_epi32((__m128d)(a))))
#endif
#endif

/* exp(-d2 / 2) = 2^t, t = -d2 / (2 log 2) <= 0, as 2^round(t) times a polynomial in the rest f that interpolates (2^f -
   1) / f at the Chebyshev points of [-1/2, 1/2]: error 2e-17 (double) and 5e-9 (float) before rounding. Below 2^-500
   (2^-110) it is 0: products of two such terms would be subnormal and slow. */
static inline MS_GPR__V MS_GPR__KERNEL(exponential)(MS_GPR__V d2)
{
    MS_GPR__V t = d2 * MS_GPR__SET((MS_GPR__REAL)-0.72134752044448170368);
#if MS_GPR__FLOAT
    MS_GPR__V limit = MS_GPR__SET(-110.0f), p = MS_GPR__SET(0.00015453162945120691f), f, whole;
#else
    MS_GPR__V limit = MS_GPR__SET(-500.0), p = MS_GPR__SET(4.4549605981865186e-10), f, whole;
#endif
    MS_GPR__V inside = MS_GPR__KEEP(t, limit, t);
    whole = MS_GPR__ROUND(inside);
    f = inside - whole;
#if MS_GPR__FLOAT
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.0013390863364671234f));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.0096180825572778524f));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.055503571142190782f));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.24022650760568126f));
    p = MS_GPR__MADD(p, f, MS_GPR__SET(0.69314718802622877f));
#else
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
#endif
    p = MS_GPR__MADD(p, f, MS_GPR__SET((MS_GPR__REAL)1));
    p = p * MS_GPR__POW2(whole);
    return MS_GPR__KEEP(t, limit, p);
}

/* A tile of 4 rows and 2 vectors: eight sums and a few operands fit 16 registers. */
static void MS_GPR__KERNEL(distances)(MS_GPR__REAL *c, size_t c_stride, const MS_GPR__REAL *a, size_t a_stride,
                                      const MS_GPR__REAL *b, size_t b_stride, int rows, int columns, int depth,
                                      int parts)
{
    int i, j, k;
    for (j = 0; j + 2 * MS_GPR__LANES <= columns; j += 2 * MS_GPR__LANES) {
        int block = (j + 2 * MS_GPR__LANES + MS_GPR__BLOCK - 1) / MS_GPR__BLOCK *
            MS_GPR__BLOCK; /* whole blocks on the diagonal */
        int wanted = (parts & MS_GPR__UPPER) && block < rows ? block : rows;
        for (i = 0; i < wanted; i += 4) {
            const MS_GPR__REAL *ak = a + i, *bk = b + j;
            MS_GPR__REAL *at = c + (size_t)i * c_stride + j;
            MS_GPR__V c00 = MS_GPR__SET(0), c01 = c00, c10 = c00, c11 = c00, c20 = c00, c21 = c00, c30 = c00, c31 = c00;
            for (k = 0; k < depth; ++k, ak += a_stride, bk += b_stride) {
                MS_GPR__V b0 = MS_GPR__LOAD(bk), b1 = MS_GPR__LOAD(bk + MS_GPR__LANES), x, d;
#define MS_GPR__STEP(r)                                \
    x = MS_GPR__SET(ak[r]);                            \
    d = x - b0, c##r##0 = MS_GPR__MADD(d, d, c##r##0); \
    d = x - b1, c##r##1 = MS_GPR__MADD(d, d, c##r##1);
                MS_GPR__STEP(0) MS_GPR__STEP(1) MS_GPR__STEP(2) MS_GPR__STEP(3)
#undef MS_GPR__STEP
            }
            MS_GPR__STORE(at, c00), MS_GPR__STORE(at + MS_GPR__LANES, c01), at += c_stride;
            MS_GPR__STORE(at, c10), MS_GPR__STORE(at + MS_GPR__LANES, c11), at += c_stride;
            MS_GPR__STORE(at, c20), MS_GPR__STORE(at + MS_GPR__LANES, c21), at += c_stride;
            MS_GPR__STORE(at, c30), MS_GPR__STORE(at + MS_GPR__LANES, c31);
        }
    }
}

static void MS_GPR__KERNEL(accumulate)(MS_GPR__REAL *mean, const MS_GPR__REAL *c, size_t c_stride,
                                       const MS_GPR__REAL *weight, int rows, int columns)
{
    int i, j;
    for (j = 0; j < columns; j += MS_GPR__LANES) {
        MS_GPR__V sum = MS_GPR__LOAD(mean + j);
        for (i = 0; i < rows; ++i)
            sum = MS_GPR__MADD(MS_GPR__SET(weight[i]),
                               MS_GPR__KERNEL(exponential)(MS_GPR__LOAD(c + (size_t)i * c_stride + j)), sum);
        MS_GPR__STORE(mean + j, sum);
    }
}

static void MS_GPR__KERNEL(line_distances)(void *d2, const void *points, size_t stride, const double *point, int m,
                                           int n)
{
    MS_GPR__REAL *out = (MS_GPR__REAL *)d2;
    const MS_GPR__REAL *p;
    int i = 0, k;
    for (; i + 4 * MS_GPR__LANES <= n; i += 4 * MS_GPR__LANES) { /* four sums at a time hide the latency of one */
        MS_GPR__V s0 = MS_GPR__SET(0), s1 = s0, s2 = s0, s3 = s0, at, d;
        for (k = 0, p = (const MS_GPR__REAL *)points + i; k < m; ++k, p += stride) {
            at = MS_GPR__SET((MS_GPR__REAL)point[k]);
            d = at - MS_GPR__LOAD(p), s0 = MS_GPR__MADD(d, d, s0);
            d = at - MS_GPR__LOAD(p + MS_GPR__LANES), s1 = MS_GPR__MADD(d, d, s1);
            d = at - MS_GPR__LOAD(p + 2 * MS_GPR__LANES), s2 = MS_GPR__MADD(d, d, s2);
            d = at - MS_GPR__LOAD(p + 3 * MS_GPR__LANES), s3 = MS_GPR__MADD(d, d, s3);
        }
        MS_GPR__STORE(out + i, s0), MS_GPR__STORE(out + i + MS_GPR__LANES, s1);
        MS_GPR__STORE(out + i + 2 * MS_GPR__LANES, s2), MS_GPR__STORE(out + i + 3 * MS_GPR__LANES, s3);
    }
    for (; i < n; i += MS_GPR__LANES) {
        MS_GPR__V sum = MS_GPR__SET(0);
        for (k = 0, p = (const MS_GPR__REAL *)points + i; k < m; ++k, p += stride) {
            MS_GPR__V d = MS_GPR__SET((MS_GPR__REAL)point[k]) - MS_GPR__LOAD(p);
            sum = MS_GPR__MADD(d, d, sum);
        }
        MS_GPR__STORE(out + i, sum);
    }
}

static void MS_GPR__KERNEL(line_slopes)(void *slope, const void *points, size_t stride, const double *point,
                                        const double *step, int m, int n)
{
    MS_GPR__REAL *out = (MS_GPR__REAL *)slope;
    const MS_GPR__REAL *p;
    double own = 0;
    int i = 0, k;
    for (k = 0; k < m; ++k) own += 2 * step[k] * point[k];
    for (; i + 4 * MS_GPR__LANES <= n; i += 4 * MS_GPR__LANES) {
        MS_GPR__V s0 = MS_GPR__SET((MS_GPR__REAL)own), s1 = s0, s2 = s0, s3 = s0, by;
        for (k = 0, p = (const MS_GPR__REAL *)points + i; k < m; ++k, p += stride) {
            by = MS_GPR__SET((MS_GPR__REAL)(2 * step[k]));
            s0 = MS_GPR__NMADD(by, MS_GPR__LOAD(p), s0);
            s1 = MS_GPR__NMADD(by, MS_GPR__LOAD(p + MS_GPR__LANES), s1);
            s2 = MS_GPR__NMADD(by, MS_GPR__LOAD(p + 2 * MS_GPR__LANES), s2);
            s3 = MS_GPR__NMADD(by, MS_GPR__LOAD(p + 3 * MS_GPR__LANES), s3);
        }
        MS_GPR__STORE(out + i, s0), MS_GPR__STORE(out + i + MS_GPR__LANES, s1);
        MS_GPR__STORE(out + i + 2 * MS_GPR__LANES, s2), MS_GPR__STORE(out + i + 3 * MS_GPR__LANES, s3);
    }
    for (; i < n; i += MS_GPR__LANES) {
        MS_GPR__V sum = MS_GPR__SET((MS_GPR__REAL)own);
        for (k = 0, p = (const MS_GPR__REAL *)points + i; k < m; ++k, p += stride)
            sum = MS_GPR__NMADD(MS_GPR__SET((MS_GPR__REAL)(2 * step[k])), MS_GPR__LOAD(p), sum);
        MS_GPR__STORE(out + i, sum);
    }
}

static double MS_GPR__KERNEL(line_mean)(const void *d2, const void *slope, double t, double c, const void *weight,
                                        int n)
{
    const MS_GPR__REAL *d = (const MS_GPR__REAL *)d2, *s = (const MS_GPR__REAL *)slope,
                       *w = (const MS_GPR__REAL *)weight;
    MS_GPR__REAL partial[MS_GPR__BLOCK];
    MS_GPR__V ahead = MS_GPR__SET((MS_GPR__REAL)t), own = MS_GPR__SET((MS_GPR__REAL)(t * c)),
              sum[MS_GPR__BLOCK / MS_GPR__LANES];
    double total = 0;
    int i, l;
    for (l = 0; l < MS_GPR__BLOCK / MS_GPR__LANES; ++l) sum[l] = MS_GPR__SET(0);
    for (i = 0; i < n; i += MS_GPR__BLOCK)
        for (l = 0; l < MS_GPR__BLOCK / MS_GPR__LANES; ++l) {
            int at = i + l * MS_GPR__LANES;
            MS_GPR__V d2t = MS_GPR__MADD(ahead, MS_GPR__LOAD(s + at) + own, MS_GPR__LOAD(d + at));
            sum[l] = MS_GPR__MADD(MS_GPR__LOAD(w + at), MS_GPR__KERNEL(exponential)(d2t), sum[l]);
        }
    for (l = 0; l < MS_GPR__BLOCK / MS_GPR__LANES; ++l) MS_GPR__STORE(partial + l * MS_GPR__LANES, sum[l]);
    for (l = 0; l < MS_GPR__BLOCK; ++l) total += (double)partial[l];
    return total;
}

static void MS_GPR__KERNEL(line_advance)(void *d2, const void *slope, double t, double c, int n)
{
    MS_GPR__REAL *d = (MS_GPR__REAL *)d2;
    const MS_GPR__REAL *s = (const MS_GPR__REAL *)slope;
    MS_GPR__V ahead = MS_GPR__SET((MS_GPR__REAL)t), own = MS_GPR__SET((MS_GPR__REAL)(t * c));
    int i;
    for (i = 0; i < n; i += MS_GPR__LANES)
        MS_GPR__STORE(d + i, MS_GPR__MADD(ahead, MS_GPR__LOAD(s + i) + own, MS_GPR__LOAD(d + i)));
}

#if !MS_GPR__FLOAT
/* A tile of 4 rows and 3 vectors, then of 1: twelve sums, three vectors of b and one of a fill 16 registers. Depth goes
   in slices, and three vectors of a slice of b are copied together, so that they stay in the first cache and on few
   pages; a block of c and the slices of a and b that meet there stay in the second. */
#define MS_GPR__SLICE 96
#define MS_GPR__ROWS 128
#define MS_GPR__COLUMNS 240 /* a multiple of three vectors */
static void MS_GPR__KERNEL(reduce)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b,
                                   size_t b_stride, int rows, int columns, int depth, int parts)
{
    double strip[MS_GPR__SLICE * 3 * MS_GPR__LANES];
    int slices = (depth + MS_GPR__SLICE - 1) / MS_GPR__SLICE, high = (rows + MS_GPR__ROWS - 1) / MS_GPR__ROWS;
    int wide = (columns + MS_GPR__COLUMNS - 1) / MS_GPR__COLUMNS, part, i, j, k;
    for (part = 0; part < slices * high * wide; ++part) {
        int top = part / slices % high * MS_GPR__ROWS, bottom = rows - top > MS_GPR__ROWS ? top + MS_GPR__ROWS : rows;
        int left = part / slices / high * MS_GPR__COLUMNS,
            right = columns - left > MS_GPR__COLUMNS ? left + MS_GPR__COLUMNS : columns;
        int from = part % slices * MS_GPR__SLICE, to = depth - from > MS_GPR__SLICE ? from + MS_GPR__SLICE : depth;
        for (j = left; j + 3 * MS_GPR__LANES <= right; j += 3 * MS_GPR__LANES) {
            int wanted = (parts & MS_GPR__UPPER) && j + 3 * MS_GPR__LANES < bottom ? (j + 3 * MS_GPR__LANES + 3) & ~3
                                                                                   : bottom;
            int first = (parts & MS_GPR__LOWER) && j > from ? j : from;
            if (first >= to) break;
            if (wanted <= top) continue;
            for (k = first; k < to; ++k)
                memcpy(strip + (k - first) * 3 * MS_GPR__LANES, b + (size_t)k * b_stride + j,
                       3 * MS_GPR__LANES * sizeof *strip);
            for (i = top; i < wanted; i += 4) {
                const double *ak = a + (size_t)first * a_stride + i, *bk = strip;
                double *c0 = c + (size_t)i * c_stride + j, *c1 = c0 + c_stride, *c2 = c1 + c_stride,
                       *c3 = c2 + c_stride;
                MS_GPR__V c00 = MS_GPR__LOAD(c0), c01 = MS_GPR__LOAD(c0 + MS_GPR__LANES),
                          c02 = MS_GPR__LOAD(c0 + 2 * MS_GPR__LANES);
                MS_GPR__V c10 = MS_GPR__LOAD(c1), c11 = MS_GPR__LOAD(c1 + MS_GPR__LANES),
                          c12 = MS_GPR__LOAD(c1 + 2 * MS_GPR__LANES);
                MS_GPR__V c20 = MS_GPR__LOAD(c2), c21 = MS_GPR__LOAD(c2 + MS_GPR__LANES),
                          c22 = MS_GPR__LOAD(c2 + 2 * MS_GPR__LANES);
                MS_GPR__V c30 = MS_GPR__LOAD(c3), c31 = MS_GPR__LOAD(c3 + MS_GPR__LANES),
                          c32 = MS_GPR__LOAD(c3 + 2 * MS_GPR__LANES);
                for (k = first; k < to; ++k, ak += a_stride, bk += 3 * MS_GPR__LANES) {
                    MS_GPR__V b0 = MS_GPR__LOAD(bk), b1 = MS_GPR__LOAD(bk + MS_GPR__LANES),
                              b2 = MS_GPR__LOAD(bk + 2 * MS_GPR__LANES), x;
#define MS_GPR__STEP(r)                      \
    x = MS_GPR__SET(ak[r]);                  \
    c##r##0 = MS_GPR__NMADD(x, b0, c##r##0); \
    c##r##1 = MS_GPR__NMADD(x, b1, c##r##1); \
    c##r##2 = MS_GPR__NMADD(x, b2, c##r##2);
                    MS_GPR__STEP(0) MS_GPR__STEP(1) MS_GPR__STEP(2) MS_GPR__STEP(3)
#undef MS_GPR__STEP
                }
                MS_GPR__STORE(c0, c00), MS_GPR__STORE(c0 + MS_GPR__LANES, c01),
                    MS_GPR__STORE(c0 + 2 * MS_GPR__LANES, c02);
                MS_GPR__STORE(c1, c10), MS_GPR__STORE(c1 + MS_GPR__LANES, c11),
                    MS_GPR__STORE(c1 + 2 * MS_GPR__LANES, c12);
                MS_GPR__STORE(c2, c20), MS_GPR__STORE(c2 + MS_GPR__LANES, c21),
                    MS_GPR__STORE(c2 + 2 * MS_GPR__LANES, c22);
                MS_GPR__STORE(c3, c30), MS_GPR__STORE(c3 + MS_GPR__LANES, c31),
                    MS_GPR__STORE(c3 + 2 * MS_GPR__LANES, c32);
            }
        }
        for (; j < right; j += MS_GPR__LANES) {
            int wanted = (parts & MS_GPR__UPPER) && j + MS_GPR__LANES < bottom ? (j + MS_GPR__LANES + 3) & ~3 : bottom;
            int first = (parts & MS_GPR__LOWER) && j > from ? j : from;
            for (i = top; i < wanted; i += 4) {
                const double *ak = a + (size_t)first * a_stride + i, *bk = b + (size_t)first * b_stride + j;
                double *c0 = c + (size_t)i * c_stride + j, *c1 = c0 + c_stride, *c2 = c1 + c_stride,
                       *c3 = c2 + c_stride;
                MS_GPR__V c00 = MS_GPR__LOAD(c0), c10 = MS_GPR__LOAD(c1), c20 = MS_GPR__LOAD(c2),
                          c30 = MS_GPR__LOAD(c3);
                for (k = first; k < to; ++k, ak += a_stride, bk += b_stride) {
                    MS_GPR__V b0 = MS_GPR__LOAD(bk);
                    c00 = MS_GPR__NMADD(MS_GPR__SET(ak[0]), b0, c00);
                    c10 = MS_GPR__NMADD(MS_GPR__SET(ak[1]), b0, c10);
                    c20 = MS_GPR__NMADD(MS_GPR__SET(ak[2]), b0, c20);
                    c30 = MS_GPR__NMADD(MS_GPR__SET(ak[3]), b0, c30);
                }
                MS_GPR__STORE(c0, c00), MS_GPR__STORE(c1, c10), MS_GPR__STORE(c2, c20), MS_GPR__STORE(c3, c30);
            }
        }
    }
}

static void MS_GPR__KERNEL(solve)(const double *u, size_t u_stride, double *b, size_t b_stride, int columns)
{
    double inverse[MS_GPR__BLOCK];
    int i, j, k;
    for (i = 0; i < MS_GPR__BLOCK; ++i) inverse[i] = 1 / u[(size_t)i * u_stride + (size_t)i];
    for (j = 0; j < columns; j += MS_GPR__LANES) {
        for (i = 0; i < MS_GPR__BLOCK; ++i) { /* u_ii v_i = b_i - sum over k < i of u_ki v_k */
            double *at = b + (size_t)i * b_stride + j;
            MS_GPR__V v = MS_GPR__LOAD(at);
            for (k = 0; k < i; ++k)
                v = MS_GPR__NMADD(MS_GPR__SET(u[(size_t)k * u_stride + (size_t)i]),
                                  MS_GPR__LOAD(b + (size_t)k * b_stride + j), v);
            MS_GPR__STORE(at, v * MS_GPR__SET(inverse[i]));
        }
    }
}

static void MS_GPR__KERNEL(exponentials)(double *c, int columns, double scale)
{
    int j;
    for (j = 0; j < columns; j += MS_GPR__LANES)
        MS_GPR__STORE(c + j, MS_GPR__SET(scale) * MS_GPR__KERNEL(exponential)(MS_GPR__LOAD(c + j)));
}

/* The sum of 8 partial sums, in a fixed order: lane l of every vector belongs to partial sum l modulo 8. */
static inline double MS_GPR__KERNEL(sum8)(const double *s)
{
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static double MS_GPR__KERNEL(weights)(double *w, const double *g, const double *k, const double *alpha, double alpha_i,
                                      int columns)
{
    double partial[MS_GPR__BLOCK] = {0, 0, 0, 0, 0, 0, 0, 0};
    int j, l;
    for (j = 0; j < columns; j += MS_GPR__BLOCK) {
        for (l = 0; l < MS_GPR__BLOCK; l += MS_GPR__LANES) {
            MS_GPR__V v = MS_GPR__MADD(MS_GPR__SET(alpha_i), MS_GPR__LOAD(alpha + j + l), MS_GPR__LOAD(g + j + l));
            v = v * MS_GPR__LOAD(k + j + l);
            MS_GPR__STORE(w + j + l, v);
            MS_GPR__STORE(partial + l, MS_GPR__LOAD(partial + l) + v);
        }
    }
    return MS_GPR__KERNEL(sum8)(partial);
}

static void MS_GPR__KERNEL(slopes)(double *slope, const double *w, const double *points, size_t stride,
                                   const double *point, int m, int columns)
{
    int j, k, l;
    for (j = 0; j < columns; j += MS_GPR__BLOCK) {
        const double *p = points + j, *q = point;
        double *s = slope;
        for (k = 0; k < m; ++k, p += stride, q += stride, s += MS_GPR__BLOCK) {
            for (l = 0; l < MS_GPR__BLOCK; l += MS_GPR__LANES) {
                MS_GPR__V d = MS_GPR__LOAD(p + l) - MS_GPR__SET(*q);
                MS_GPR__STORE(s + l, MS_GPR__MADD(MS_GPR__LOAD(w + j + l) * d, d, MS_GPR__LOAD(s + l)));
            }
        }
    }
}

static void MS_GPR__KERNEL(axpy)(double *y, double a, const double *x, int columns)
{
    int j;
    for (j = 0; j < columns; j += MS_GPR__LANES)
        MS_GPR__STORE(y + j, MS_GPR__MADD(MS_GPR__SET(a), MS_GPR__LOAD(x + j), MS_GPR__LOAD(y + j)));
}

static double MS_GPR__KERNEL(dot)(const double *x, const double *y, int columns)
{
    double partial[MS_GPR__BLOCK] = {0, 0, 0, 0, 0, 0, 0, 0};
    int j, l;
    for (j = 0; j < columns; j += MS_GPR__BLOCK)
        for (l = 0; l < MS_GPR__BLOCK; l += MS_GPR__LANES)
            MS_GPR__STORE(partial + l,
                          MS_GPR__MADD(MS_GPR__LOAD(x + j + l), MS_GPR__LOAD(y + j + l), MS_GPR__LOAD(partial + l)));
    return MS_GPR__KERNEL(sum8)(partial);
}

static const ms_gpr__kernels MS_GPR__KERNEL(table) = {
    MS_GPR__KERNEL(reduce),
    MS_GPR__KERNEL(distances),
    MS_GPR__JOIN(ms_gpr__distances_f_, MS_GPR__LEVEL),
    MS_GPR__KERNEL(exponentials),
    MS_GPR__KERNEL(accumulate),
    MS_GPR__JOIN(ms_gpr__accumulate_f_, MS_GPR__LEVEL),
    MS_GPR__KERNEL(solve),
    MS_GPR__KERNEL(weights),
    MS_GPR__KERNEL(slopes),
    MS_GPR__KERNEL(axpy),
    MS_GPR__KERNEL(dot),
    {sizeof(double), MS_GPR__KERNEL(line_distances), MS_GPR__KERNEL(line_slopes), MS_GPR__KERNEL(line_mean),
     MS_GPR__KERNEL(line_advance)},
    {sizeof(float), MS_GPR__JOIN(ms_gpr__line_distances_f_, MS_GPR__LEVEL),
     MS_GPR__JOIN(ms_gpr__line_slopes_f_, MS_GPR__LEVEL), MS_GPR__JOIN(ms_gpr__line_mean_f_, MS_GPR__LEVEL),
     MS_GPR__JOIN(ms_gpr__line_advance_f_, MS_GPR__LEVEL)}};
#endif /* !MS_GPR__FLOAT */

#undef MS_GPR__ROWS
#undef MS_GPR__COLUMNS
#undef MS_GPR__SLICE
#undef MS_GPR__JOIN_
#undef MS_GPR__JOIN
#undef MS_GPR__LEVEL
#undef MS_GPR__KERNEL
#undef MS_GPR__REAL
#undef MS_GPR__V
#undef MS_GPR__BYTES
#undef MS_GPR__INT
#undef MS_GPR__LANES
#undef MS_GPR__LOAD
#undef MS_GPR__STORE
#undef MS_GPR__SET
#undef MS_GPR__MADD
#undef MS_GPR__NMADD
#undef MS_GPR__ROUND
#undef MS_GPR__POW2
#undef MS_GPR__KEEP
#undef MS_GPR__FLOAT
#endif /* MS_GPR__PASS */

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
