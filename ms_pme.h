/* ms_pme.h - v0.1.0 - from an edited picture to material parameters - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_PME_IMPLEMENTATION
      #include "ms_pme.h"

   You have a renderer phi(x) (a small neural one, ms_nn.h runs such), and a target picture that somebody painted. This
   header finds the parameters x, inside their bounds, whose picture is closest: it tries the guesses that you have
   (inversion networks, the previous frame, the source material), keeps the best, and refines it. It works from
   callbacks alone, and its optimisers can be used on any function of up to 256 parameters. Link with -lm. Here a
   "renderer" of two parameters and three pixels:

   Example:
      #define MS_PME_IMPLEMENTATION
      #include "ms_pme.h"
      #include <stdio.h>

      // a "renderer" of two parameters and three pixels
      static ms_status render(void *user, const double *x, float *image)
      {
          (void)user;
          image[0] = (float)(x[0] * x[0]);
          image[1] = (float)(x[0] * x[1]);
          image[2] = (float)(x[0] + 2 * x[1]);
          return MS_OK;
      }

      int main(void)
      {
          const float target[3] = {0.25f, 0.4f, 2.1f};
          ms_pme_renderer renderer = ms_pme_renderer_defaults();
          ms_pme_match_result result;
          double x[2];
          renderer.parameter_count = 2;
          renderer.image_size = 3;
          renderer.render = render;
          if (ms_pme_match(&renderer, target, NULL, NULL, x, NULL, &result, NULL) != MS_OK) return 1;
          printf("x = %.4f %.4f, rmse %.1e after %.0f renders\n", x[0], x[1], result.rmse, result.cost);
          return !(result.rmse < 1e-3);
      }
   End of example.

   Which optimiser
   ---------------
   The default is Levenberg-Marquardt whose every step is a least-squares problem inside the box, solved exactly by an
   active-set method whose QR factorisation follows each bound that is entered or left. On the 14 problems of
   tests/data/pme_problems.json (More, Garbow, Hillstrom, free and bounded) it ends within 1e-7 of a trust-region
   solver's minima on all (`tests/test_pme.c reference`; the methods of the thesis are in tests/bench/thesis_methods.h).
   With restarts as many first guesses set out as the budget has steps for, the best of them go on (successive halving),
   and what is left goes to the others and to random points. Give a Jacobian when you have one: it costs a network a few
   evaluations, differences cost n. On float32 pictures differences of 1.5e-8, the customary default, are noise.

   Budget
   ------
   Counted in evaluations; one with a Jacobian counts jacobian_cost. A call never spends more than max_cost (the
   candidates of ms_pme_match, its final render and its deviations come on top), and stops earlier at a target value,
   after max_seconds on the wall's clock, or when progress says so: before the next callback. `make bench FILTER=pme`
   has times and what more cost buys.

   Edits that no material explains
   -------------------------------
   Exposure, tint and an offset of the picture can be fitted along (options.nuisance). A logo, a stitch: weights by
   ms_pme_reweigh, and match again from the answer, some times (examples/tools/match.c --robust). Parameters: frozen by
   equal bounds, tied (options.tie), pulled towards a source (options.pull); bounds around the last frame's answer limit
   what a frame may change.

   Memory, threads, SIMD, determinism, errors
   ------------------------------------------
   One block a call (two for ms_pme_match) from options.allocator, sizes stated there; stack below 32 KB, 64 KB when
   compiled without optimisation.
   No state: calls may overlap. The callbacks run on the calling thread; a renderer may be parallel inside.
   The same bits at every call with the same seed, as far as the callbacks' answers are; no SIMD, so on one build.
   -ffast-math voids this and what is said of NaN and infinity.
   Statuses, and a sentence in ms_error. NaN or infinite values of a function are no errors: such points lose; a
   derivative that is not finite is MS_BAD_DATA. Residuals may have any size that doubles have.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_PME_NO_CLOCK   no <time.h>, <sys/time.h>; max_seconds then needs options.clock. The header never uses stdio.
   MS_DEF            linkage of the functions, e.g. static, __declspec(dllexport) (nothing)

   Limits
   ------
   256 parameters; dense Jacobians [m][n] in double. Local methods: the answer is the minimum nearest to the best
   candidate; restarts or basin hopping look further. A function must not be smoother than it says: noise larger than
   the tolerance wants difference_step or Nelder-Mead.

   Sources
   -------
   Zsolnai-Feher, Photorealistic Material Learning and Synthesis, chapter 4 (algorithm 4, equations 4.1 to 4.4); More
   1978; Nielsen 1999; Stark and Parker 1995; Nocedal and Wright 2006; Nelder and Mead 1965; Wales and Doye 1997;
   Hestenes 1958; Huber 1981; More, Garbow and Hillstrom 1981.
*/
#ifndef MS_PME_H
#define MS_PME_H
#include <stddef.h>
#include <stdint.h>

#define MS_PME_VERSION_MAJOR 0
#define MS_PME_VERSION_MINOR 1
#define MS_PME_VERSION_PATCH 0
#define MS_PME_VERSION 100 /* major * 10000 + minor * 100 + patch */
#define MS_PME_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON
#define MS_COMMON 3 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__) || defined(__clang__)
#define MS_API MS_DEF __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS_API MS_DEF
#endif

/* NULL, in every header: where an argument's comment does not say what NULL means, it may not be NULL. A call that
   returns a status then answers MS_INVALID_ARGUMENT and names the argument; any other does nothing and returns 0 or
   NULL. destroy and free do nothing with NULL. */

/* What went wrong; each code asks for another remedy. code, value, sentence */
#define MS_STATUS_LIST(X)                                                  \
    X(MS_OK, 0, "success")                                                 \
    X(MS_INVALID_ARGUMENT, 1, "an argument is outside its stated range")   \
    X(MS_OUT_OF_MEMORY, 2, "the allocator returned NULL")                  \
    X(MS_BAD_DATA, 3, "the file or the data set is malformed")             \
    X(MS_UNSUPPORTED, 4, "valid, but not handled by this build or call")   \
    X(MS_NOT_CONVERGED, 5, "the iteration stopped short of its tolerance") \
    X(MS_CANCELLED, 6, "the progress callback asked to stop")              \
    X(MS_IO, 7, "the operating system could not read or write")

typedef enum ms_status {
#define MS_STATUS_ENUM(code, value, sentence) code = value,
    MS_STATUS_LIST(MS_STATUS_ENUM)
#undef MS_STATUS_ENUM
        MS_STATUS_COUNT /* how many codes there are */
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

/* Threads. All zero: everything runs on the calling thread. run calls task(context, i) once for every
   i in [0, count), in any order, on any threads, and returns when all are done. The work is cut into
   tasks by the problem alone, so results do not depend on how many threads there are. */
typedef struct ms_parallel {
    void *user;
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context);
} ms_parallel;

/* Progress of a long call. All zero: none. report gets the fraction done, 0 to 1, from the thread that
   made the call; it returns non-zero to stop, and the call then returns MS_CANCELLED. */
typedef struct ms_progress {
    void *user;
    int (*report)(void *user, double fraction);
} ms_progress;

/* Instruction sets, in the order of their speed. Options take one as a cap: a level that the processor
   or the build lacks falls back to the next lower one. */
typedef enum ms_simd {
    MS_SIMD_AUTO = 0,   /* the best that the processor has */
    MS_SIMD_SCALAR = 1, /* plain C: the reference for all the others */
    MS_SIMD_BASE = 2,   /* SSE2 on x86-64, NEON on ARM64 */
    MS_SIMD_AVX2 = 3,   /* AVX2 and FMA */
    MS_SIMD_AVX512 = 4  /* AVX-512 F, BW, DQ, VL */
} ms_simd;

/* The sentence of MS_STATUS_LIST; "unknown status" outside it. */
static inline const char *ms_status_string(ms_status status)
{
    static const char *const sentence[] = {
#define MS_STATUS_TEXT(code, value, text) text,
        MS_STATUS_LIST(MS_STATUS_TEXT)
#undef MS_STATUS_TEXT
    };
    int i = (int)status;
    return i >= 0 && i < (int)MS_STATUS_COUNT ? sentence[i] : "unknown status";
}

/* "auto", "scalar", "base", "avx2", "avx512"; "unknown" outside the list. */
static inline const char *ms_simd_string(ms_simd level)
{
    static const char *const name[] = {"auto", "scalar", "base", "avx2", "avx512"};
    int i = (int)level;
    return i >= 0 && i <= (int)MS_SIMD_AVX512 ? name[i] : "unknown";
}
#endif /* MS_COMMON */

/* Outside the guard: catches two vendored releases in one file. */
#if MS_COMMON != 3
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---- 1. any function of a few parameters ----------------------------------------------------------------------- */

/* What is to be made small over the box lower <= x <= upper: f(x) = sum of r_i(x)^2 when `residuals` is given, else
   `value`. A callback returns MS_OK, or a status that ends the run and becomes its answer. Values that are NaN or
   infinite are no failure: such a point is taken as worse than every finite one. Callbacks are called from the
   thread that made the call, one at a time; x is always inside the box. */
typedef struct ms_pme_function {
    void *user;
    int parameter_count;   /* n, 1 to MS_PME_PARAMETERS_MAX */
    size_t residual_count; /* m >= 1 with `residuals` */
    /* r [m] out. jacobian [m][n] row-major out, d r_i / d x_j, or NULL: not asked for. */
    ms_status (*residuals)(void *user, const double *x, double *r, double *jacobian);
    int residuals_only;   /* non-zero: `residuals` cannot fill a Jacobian; differences take its place */
    double jacobian_cost; /* what one call with a Jacobian counts, in evaluations; 0: 1 + n / 4 */
    /* For functions that are no sum of squares: */
    ms_status (*value)(void *user, const double *x, double *f);
    /* Optional: f and its gradient [n]; counts jacobian_cost. NULL: from the Jacobian, or by differences. */
    ms_status (*gradient)(void *user, const double *x, double *f, double *gradient);
    const double *lower, *upper; /* [n]; NULL: no bound on that side; infinities allowed */
} ms_pme_function;
#define MS_PME_PARAMETERS_MAX 256

typedef enum ms_pme_method {
    MS_PME_LEVENBERG_MARQUARDT = 0, /* trust region by damping, each step a bounded least-squares problem solved
                                       exactly; needs residuals (else L-BFGS takes over) */
    MS_PME_NELDER_MEAD = 1,         /* simplex, points clipped to the box, first edges 0.1 of the range: for noise */
    MS_PME_LBFGS = 2,               /* limited-memory quasi-Newton, active set of bounds */
    MS_PME_BASIN_HOPPING = 3        /* random hops, each followed by Levenberg-Marquardt (or L-BFGS) */
} ms_pme_method;

typedef enum ms_pme_stop {
    MS_PME_STOP_CONVERGED = 0, /* the step, the decrease or the projected gradient fell below its tolerance */
    MS_PME_STOP_TARGET = 1,    /* target_value (or target_rmse) reached */
    MS_PME_STOP_COST = 2,      /* max_cost spent */
    MS_PME_STOP_SECONDS = 3    /* max_seconds spent */
} ms_pme_stop;

/* All zero gives the defaults; ms_pme_defaults() returns that. */
typedef struct ms_pme_options {
    int method;          /* ms_pme_method */
    double max_cost;     /* in evaluations of f (Jacobians at jacobian_cost); 0: 1000 */
    double max_seconds;  /* of `clock`; 0: no limit. No callback begins that would end more than 5% later at the pace so
                            far */
    double target_value; /* stop when f <= this; 0: only at 0 */
    double tolerance;    /* relative decrease and relative step taken as converged; 0: 1e-10 */
    double start_step;   /* Nelder-Mead: first edge as a fraction of the range (of max(|x|, 1) without bounds), 0: 0.1.
                            Basin hopping: hop, 0: 0.25 */
    double difference_step; /* > 0: forward differences of this absolute step; 0: central, near the best step for f64.
                               A float32 renderer wants about 1e-3: with 1.5e-8 its differences are rounding noise */
    int restarts;  /* Levenberg-Marquardt: further runs while cost is left, from random points, rough ones that are
                      finished where  they lead further. ms_pme_match has its best candidates race for the first part of
                      the budget */
    uint64_t seed; /* of restarts and hops */
    double (*clock)(void *user); /* seconds, from any origin; NULL: the wall's clock */
    void *clock_user;
    ms_progress progress;   /* asked before every callback */
    ms_allocator allocator; /* one block of about (m n + m + 6 n^2) doubles, released before the call returns */
} ms_pme_options;

typedef struct ms_pme_result {
    double value;       /* f at x; infinite or 0 where the sum of squares is out of double's range */
    double cost;        /* spent, in evaluations */
    size_t evaluations; /* calls without derivatives */
    size_t jacobians;   /* calls with them */
    size_t iterations;  /* steps of the method */
    ms_pme_stop stop;
    double
        projected_gradient; /* largest |component| at x of the gradient that bounds do not hold; where a run ends
                               on a value, one call with derivatives more, which does not count, gives it. -1: not known
                               (Nelder-Mead; no time left; ms_pme_match or differences alone that ended on a value) */
} ms_pme_result;

MS_API ms_pme_options ms_pme_defaults(void);

/* A name for tables and logs: "levenberg-marquardt", ...; "unknown" outside the enum. */
MS_API const char *ms_pme_method_string(int method);

/* Makes f small from a start.
   x        [n] in: start, anything finite (clipped to the box first); out: the best point that was evaluated
   options  NULL: defaults
   result   out, may be NULL
   error    may be NULL; position is the index of the offending parameter
   The answer is the same bits at every call with the same seed, as far as the callbacks are.
   MS_INVALID_ARGUMENT: n, m or a callback is missing or out of range, lower > upper or NaN (position tells which),
   x not finite, no finite value at the start. MS_BAD_DATA: a derivative is not finite at a point whose value is.
   MS_OUT_OF_MEMORY, MS_CANCELLED, or what a callback returned: x is then untouched. MS_NOT_CONVERGED is never returned:
   a budget that ended the run is said in result->stop. */
MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error);

/* ---- 2. which material made this picture? ---------------------------------------------------------------------- */

/* The picture is image_size floats in any order, phi(x). Thesis, chapter 4. */
typedef struct ms_pme_renderer {
    void *user;
    int parameter_count;         /* n */
    size_t image_size;           /* p: pixels times channels */
    const double *lower, *upper; /* [n]; NULL: all 0, all 1 */
    /* phi(x) -> image [p] */
    ms_status (*render)(void *user, const double *x, float *image);
    /* Optional: image and d image_i / d x_j as [p][n]. */
    ms_status (*jacobian)(void *user, const double *x, float *image, float *jacobian);
    double jacobian_cost; /* in renders; 0: 1 + n / 4 */
    /* Optional: prediction i of prediction_count inversion networks, target [p] -> x [n]; outside the box is
       allowed. */
    int prediction_count;
    ms_status (*predict)(void *user, int i, const float *target, double *x);
    /* Optional: a smaller function with the same minimum, valid for this target and these weights (ms_nn.h's collapse):
       sum of squares + reduced_offset = sum of weight (phi - target)^2. Then candidates and refinement use it, and
       `render` is called once, for the reported RMSE; where that is another than this function says, it was made for
       another target or other weights, and the match fails. */
    const ms_pme_function *reduced;
    double reduced_offset;
} ms_pme_renderer;

/* All zero: fill in what you have. */
MS_API ms_pme_renderer ms_pme_renderer_defaults(void);

#define MS_PME_CHANNELS_MAX 4

/* What of the picture, not of the material, is fitted along: in the unit of the values, gain x phi(x) + offset. */
typedef enum ms_pme_nuisance {
    MS_PME_EXPOSURE = 1, /* one gain, 1/8 to 8 */
    MS_PME_TINT = 2,     /* a gain for each channel */
    MS_PME_OFFSET = 4    /* an offset for each channel, -1 to 1 */
} ms_pme_nuisance;

typedef struct ms_pme_match_options {
    ms_pme_options refine;    /* max_cost 0: 50, spent after the candidates; target_value is set from target_rmse */
    double target_rmse;       /* good enough: no refinement once a candidate has it ("best of both worlds"); 0: none */
    int initial_only;         /* non-zero: the best candidate as it is ("close to real time") */
    const double *candidates; /* [candidate_count][n]: the previous frame's answer, the source material; may be NULL */
    int candidate_count;
    int random_count; /* further candidates drawn uniformly. The middle of the box is tried where no other has a finite
                         picture */
    int nuisance;     /* flags of ms_pme_nuisance; `reduced` does not serve then */
    int channels;     /* planes that follow each other in a picture, up to MS_PME_CHANNELS_MAX; 0: 1 */
    const int *tie;   /* [n] x_j is x_tie[j]; a parameter tied to itself is free; NULL: all are */
    const double *source; /* [n] where pulls lead */
    const double *pull;   /* [n] >= 0: pull (x_j - source_j)^2 is added to RMSE^2; NULL: none */
    double *
        deviation; /* [n] out, or NULL: standard deviations of x if errors of the size of the RMSE in the values are
                      independent; 0 where bounds are equal, near 0.29 of its range where the picture leaves x_j open */
} ms_pme_match_options;

typedef struct ms_pme_match_result {
    double rmse;            /* weighted, in the image's unit, from one real render of x */
    double rmse_initial;    /* of the best candidate */
    int best_candidate;     /* predictions come first, then `candidates`, then random ones (or the middle) */
    int candidates_refused; /* predictions and candidates that were not finite */
    ms_pme_result refine;   /* cost does not hold that of the candidates */
    double cost;            /* all renders */
    double gain[MS_PME_CHANNELS_MAX],
        offset[MS_PME_CHANNELS_MAX]; /* of each channel; 1 and 0 where nothing was fitted */
} ms_pme_match_result;

MS_API ms_pme_match_options ms_pme_match_defaults(void);

/* Best of n, then refinement (thesis, algorithm 4, eq. 4.1 to 4.4).
   target   [p], finite where the weight is not 0
   weight   [p] >= 0, or NULL: all 1. RMSE^2 = sum w (phi - t)^2 / sum w
   x        [n] out: the material
   image    [p] out: phi(x), gain and offset applied, or NULL
   MS_INVALID_ARGUMENT: as ms_pme_minimize; a target that is not finite (error->position: its index), a negative or
   non-finite weight (likewise), weights that are all 0, no candidate with a finite picture, a reduced function of
   another target or other weights (RMSE beyond a thousandth and 1e-5 of the target's size apart).
   MS_OUT_OF_MEMORY, MS_CANCELLED, or the status of a callback: outputs untouched. */
MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image, ms_pme_match_result *result,
                              ms_error *error);

/* How an error of e costs, with s a typical one: Huber e^2 up to 1.345 s, then |e|; Tukey nothing more beyond 4.685
   s. */
typedef enum ms_pme_loss { MS_PME_HUBER = 1, MS_PME_TUKEY = 2 } ms_pme_loss;

/* Weights that make the next match's squares follow such a loss around this picture (Huber 1981): a pixel of `channels`
   values gets one factor, so that channels go on sharing what they share.
   scale       s; 0: 1.4826 times the median of the pixels' errors
   image, target, weight [count], weight NULL: all 1; reweighted [count] out, none of them
   used_scale  out, may be NULL */
MS_API ms_status ms_pme_reweigh(int loss, double scale, size_t count, int channels, const float *image,
                                const float *target, const float *weight, float *reweighted, double *used_scale,
                                ms_error *error);

/* What a picture tells about the parameters: the singular values of the Jacobian at x, largest first.
   singular_value [n] out: change of the residual vector per unit change of x along that direction
   direction      [n][n] out, may be NULL: row k the unit direction in parameter space of singular_value[k]
   deviation      [n] out, may be NULL: standard deviation of x_j if every residual carries independent noise of
                  standard deviation 1; infinite where the picture does not determine x_j (singular value below
                  1e-12 of the largest)
   Bounds are not considered. Needs residuals; those without a Jacobian are differenced as options say.
   Statuses as ms_pme_minimize; MS_BAD_DATA: a residual or derivative at x is not finite. */
MS_API ms_status ms_pme_sensitivity(const ms_pme_function *function, const ms_pme_options *options, const double *x,
                                    double *singular_value, double *direction, double *deviation, ms_error *error);

#ifdef __cplusplus
}
#endif
#endif /* MS_PME_H */

#if defined(MS_PME_IMPLEMENTATION) && !defined(MS_PME__PASS) && !defined(MS_PME_IMPLEMENTED)
#define MS_PME_IMPLEMENTED /* included again, it is declarations only */
/* ms-common-private begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON_PRIVATE
#define MS_COMMON_PRIVATE
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#ifndef MS_ASSERT /* checks of the library's own invariants, never of the caller's data */
#define MS_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__) || defined(__clang__)
#define MS__UNUSED __attribute__((unused))
#else
#define MS__UNUSED
#endif

/* Returns a * b or a + b; SIZE_MAX stands for overflow and stays so through further calls. */
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
    if (allocator != NULL && allocator->alloc != NULL) {
        if (allocator->release != NULL) allocator->release(allocator->user, pointer, size ? size : 1);
    } else {
        free(pointer);
    }
}

static MS__UNUSED void ms__run(const ms_parallel *parallel, int count, void (*task)(void *context, int index),
                               void *context)
{
    int i;
    if (parallel != NULL && parallel->run != NULL && count > 1) {
        parallel->run(parallel->user, count, task, context);
    } else {
        for (i = 0; i < count; ++i) task(context, i);
    }
}

/* By its bits: isfinite() is removed by -ffast-math. */
static MS__UNUSED int ms__finite(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

static MS__UNUSED int ms__finite_f(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7f800000u) != 0x7f800000u;
}

/* x as text with 6 significant digits and '.' in every locale; at least 24 bytes in out. Its length. */
static MS__UNUSED int ms__format_number(char *out, double x)
{
    char digit[8];
    int n = 0, exponent = 0, i, last;
    int64_t mantissa;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (!ms__finite(x)) {
        const char *name = (bits & 0xfffffffffffffu) ? "nan" : (bits >> 63) ? "-inf" : "inf";
        for (; name[n]; ++n) out[n] = name[n];
        out[n] = 0;
        return n;
    }
    if (bits >> 63) {
        out[n++] = '-';
        x = -x;
    }
    if (!(x > 0)) {
        out[n++] = '0';
        out[n] = 0;
        return n;
    }
    while (x >= 1e6) {
        x /= 10;
        ++exponent;
    }
    while (x < 1e5) {
        x *= 10;
        --exponent;
    }
    mantissa = (int64_t)(x + 0.5);
    if (mantissa >= 1000000) {
        mantissa /= 10;
        ++exponent;
    }
    exponent += 5;
    for (i = 5; i >= 0; --i) {
        digit[i] = (char)('0' + (int)(mantissa % 10));
        mantissa /= 10;
    }
    for (last = 5; last > 0 && digit[last] == '0';) --last;
    if (exponent >= -4 && exponent < 7) {
        if (exponent < 0) {
            out[n++] = '0';
            out[n++] = '.';
            for (i = -1; i > exponent; --i) out[n++] = '0';
            for (i = 0; i <= last; ++i) out[n++] = digit[i];
        } else {
            for (i = 0; i <= last || i <= exponent; ++i) {
                if (i == exponent + 1) out[n++] = '.';
                out[n++] = i < 6 ? digit[i] : '0';
            }
        }
    } else {
        out[n++] = digit[0];
        if (last > 0) out[n++] = '.';
        for (i = 1; i <= last; ++i) out[n++] = digit[i];
        out[n++] = 'e';
        out[n++] = exponent < 0 ? '-' : '+';
        if (exponent < 0) exponent = -exponent;
        if (exponent >= 100) out[n++] = (char)('0' + exponent / 100);
        out[n++] = (char)('0' + exponent / 10 % 10);
        out[n++] = (char)('0' + exponent % 10);
    }
    out[n] = 0;
    return n;
}

/* Fills error (may be NULL) and returns status. The format knows %s (char pointer), %d (int), %z (size_t),
   %g (double) and %%; a text that is too long is cut, a control character becomes '?'. */
static MS__UNUSED ms_status ms__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    char number[32];
    size_t n = 0, room, i;
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = position;
    room = sizeof error->message - 1;
    va_start(list, format);
    for (; *format; ++format) {
        const char *piece = number;
        number[0] = *format;
        number[1] = 0;
        if (*format == '%' && format[1]) {
            ++format;
            if (*format == 's') {
                piece = va_arg(list, const char *);
            } else if (*format == 'g') {
                ms__format_number(number, va_arg(list, double));
            } else if (*format == 'd' || *format == 'z') {
                char reversed[24];
                size_t k = 0, m = 0, value;
                if (*format == 'd') {
                    int64_t v = va_arg(list, int);
                    if (v < 0) number[m++] = '-';
                    value = (size_t)(v < 0 ? -v : v);
                } else {
                    value = va_arg(list, size_t);
                }
                do {
                    reversed[k++] = (char)('0' + (int)(value % 10));
                    value /= 10;
                } while (value);
                while (k) number[m++] = reversed[--k];
                number[m] = 0;
            }
        }
        for (i = 0; piece[i] && n < room; ++i)
            error->message[n++] = (unsigned char)piece[i] < 32 || piece[i] == 127 ? '?' : piece[i];
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

/* Sections: small maths | the run: budgets and evaluations | bounded least squares | Levenberg-Marquardt | restarts |
   L-BFGS | Nelder-Mead | basin hopping | public: minimize | match: objectives | match: stages | public: match | public:
   sensitivity */

#include <float.h>
#include <limits.h>
#include <math.h>
#ifndef MS_PME_NO_CLOCK
#if defined(__unix__) || defined(__APPLE__)
#include <sys/time.h>
#endif
#include <time.h>
#endif

/* ---- small maths ----------------------------------------------------------------------------------------------- */

#define MS_PME__INF ((double)HUGE_VAL)
#define MS_PME__MEMORY 8 /* pairs that L-BFGS keeps */
#define MS_PME__VARIABLES (MS_PME_PARAMETERS_MAX + 2 * MS_PME_CHANNELS_MAX)
#define MS_PME__FIELD 16 /* first guesses that are kept at most */
#define MS_PME__ROWS 32  /* rows of the Jacobian that one QR update takes: they stay in the cache */

static double ms_pme__dot(const double *a, const double *b, int n)
{
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    int i = 0;
    for (; i + 4 <= n; i += 4) {
        s0 += a[i] * b[i];
        s1 += a[i + 1] * b[i + 1];
        s2 += a[i + 2] * b[i + 2];
        s3 += a[i + 3] * b[i + 3];
    }
    for (; i < n; ++i) s0 += a[i] * b[i];
    return (s0 + s1) + (s2 + s3);
}

/* y += t x */
static void ms_pme__add(double *y, double t, const double *x, int n)
{
    int i = 0;
    for (; i + 4 <= n; i += 4) {
        y[i] += t * x[i];
        y[i + 1] += t * x[i + 1];
        y[i + 2] += t * x[i + 2];
        y[i + 3] += t * x[i + 3];
    }
    for (; i < n; ++i) y[i] += t * x[i];
}

/* (a, b) = (c a + s b, c b - s a) for n elements of two rows. */
static void ms_pme__rotate(double *a, double *b, double c, double s, int n)
{
    int i;
    for (i = 0; i < n; ++i) {
        double u = a[i], v = b[i];
        a[i] = c * u + s * v;
        b[i] = c * v - s * u;
    }
}

static double ms_pme__clip(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

static double ms_pme__max(double a, double b) { return a > b ? a : b; }

static void ms_pme__copy(double *to, const double *from, int n) { memcpy(to, from, (size_t)n * sizeof *to); }

/* x 2^e, infinite or 0 where that is out of range, without an exception on the way. */
static double ms_pme__shifted(double x, int e)
{
    int own;
    if (e == 0 || !(x > 0)) return x;
    frexp(x, &own);
    return own + e > 1023 ? MS_PME__INF : own + e < -1020 ? 0 : ldexp(x, e);
}

/* The same to every element, of either sign. */
static void ms_pme__shift_all(double *x, size_t count, int e)
{
    size_t i;
    for (i = 0; i < count && e != 0; ++i) x[i] = x[i] < 0 ? -ms_pme__shifted(-x[i], e) : ms_pme__shifted(x[i], e);
}

/* The rotation that turns (a, b) into (r, 0). */
static double ms_pme__rotation(double a, double b, double *c, double *s)
{
    double size = ms_pme__max(fabs(a), fabs(b)), r;
    if (!(size > 0)) {
        *c = 1;
        *s = 0;
        return 0;
    }
    r = size * sqrt(a / size * (a / size) + b / size * (b / size));
    *c = a / r;
    *s = b / r;
    return r;
}

/* k rows, kept as columns [n + 1][ROWS] (the last is the right-hand side), are folded into the upper triangle r [n +
   1][n + 1] by Householder reflections of (r_jj, column j): the R of a QR factorisation, built row block by row block
   (TSQR with a chain for a tree). The columns are destroyed. */
static void ms_pme__qr_append(double *r, int n, double *columns, int k)
{
    int w = n + 1, i, j;
    for (j = 0; j <= n; ++j) {
        double *column = columns + j * MS_PME__ROWS, *top = r + j * w, largest = fabs(top[j]), norm, head, beta;
        for (i = 0; i < k; ++i) largest = ms_pme__max(largest, fabs(column[i]));
        if (!(largest > 0)) continue;
        norm = (top[j] / largest) * (top[j] / largest);
        for (i = 0; i < k; ++i) norm += (column[i] / largest) * (column[i] / largest);
        norm = largest * sqrt(norm);
        if (top[j] > 0) norm = -norm;
        head = top[j] - norm; /* v = (head, column), |v|^2 = -2 norm head */
        beta = 1 / (norm * head);
        for (i = j + 1; i <= n; ++i) {
            double t = beta * (head * top[i] + ms_pme__dot(column, columns + i * MS_PME__ROWS, k));
            top[i] += t * head;
            ms_pme__add(columns + i * MS_PME__ROWS, t, column, k);
        }
        top[j] = norm;
    }
}

/* ---- the run: budgets and evaluations -------------------------------------------------------------------------- */

typedef struct ms_pme__run {
    const ms_pme_function *function;
    const ms_pme_options *options;
    int n, ranged; /* ranged: every parameter has a range that means something */
    size_t m;
    double max_cost, tolerance, jacobian_cost, start_time;
    double paid, reserve;  /* cost since the start, what is to come when the run is over: for max_seconds */
    int shift, shifted;    /* residuals are worked on times 2^shift, chosen once one was seen */
    double *lower, *upper; /* [n] */
    double *best;          /* [n] the best point evaluated, its value, and its projected gradient (-1: not known) */
    double best_value, best_gradient;
    double *residual, *residual_step; /* [m] of the last evaluation; of a difference */
    double *jacobian;                 /* [m][n] of the last one with derivatives */
    double *rows;                     /* [n + 1][ROWS] some of its rows, column by column */
    double *scratch;                  /* what the methods share out among themselves */
    ms_pme_result result;
    int stopped;   /* a budget, the target, a failure: nothing more may be evaluated */
    int finishing; /* the run is over: what is evaluated now is about its answer, and free */
    ms_status status;
    size_t bad; /* the derivative that was not finite: residual, parameter */
    int bad_parameter;
    ms__rng rng;
} ms_pme__run;

static int ms_pme__stop(ms_pme__run *run, ms_pme_stop why)
{
    if (!run->stopped) run->result.stop = why;
    return run->stopped = 1;
}

/* Ends the run where the status is a failure; non-zero then. */
static int ms_pme__fail(ms_pme__run *run, ms_status status)
{
    if (status == MS_OK) return 0;
    run->status = status;
    return run->stopped = 1;
}

/* Seconds on the wall. */
static double ms_pme__seconds(const ms_pme_options *options)
{
    if (options->clock != NULL) return options->clock(options->clock_user);
#if defined(MS_PME_NO_CLOCK)
    return 0;
#elif defined(__unix__) || defined(__APPLE__)
    {
        struct timeval t;
        gettimeofday(&t, NULL);
        return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
    }
#elif defined(_WIN32)
    return (double)clock() / (double)CLOCKS_PER_SEC; /* there it is the wall's */
#else
    return (double)time(NULL);
#endif
}

/* Asked before every callback: is there budget for one of this cost? Non-zero: no, the run is over. */
static int ms_pme__spend(ms_pme__run *run, double cost)
{
    const ms_pme_options *options = run->options;
    if (run->stopped) return 1;
    if (run->finishing) return 0;
    if (run->result.cost + cost > run->max_cost * (1 + 1e-12)) return ms_pme__stop(run, MS_PME_STOP_COST);
    if (options->max_seconds > 0) { /* nothing that, at the pace so far, would end too late */
        double spent = ms_pme__seconds(options) - run->start_time,
               next = run->paid > 0 ? spent / run->paid * (cost + run->reserve) : 0;
        if (spent >= options->max_seconds || spent + next > 1.05 * options->max_seconds)
            return ms_pme__stop(run, MS_PME_STOP_SECONDS);
    }
    if (options->progress.report != NULL &&
        options->progress.report(options->progress.user,
                                 ms__finite(run->max_cost) ? run->result.cost / run->max_cost : 0) != 0)
        return ms_pme__fail(run, MS_CANCELLED);
    run->result.cost += cost;
    run->paid += cost;
    return 0;
}

/* Every value goes through here: NaN becomes infinity, the best point is kept, the target is looked for. */
static double ms_pme__seen(ms_pme__run *run, const double *x, double f)
{
    if (!ms__finite(f)) return MS_PME__INF;
    if (f < run->best_value) {
        run->best_value = f;
        run->best_gradient = -1;
        ms_pme__copy(run->best, x, run->n);
    }
    if (!run->finishing && f <= ms_pme__shifted(run->options->target_value, 2 * run->shift))
        ms_pme__stop(run, MS_PME_STOP_TARGET);
    return f;
}

/* The sum of squares of r [m] times 2^(2 shift), r becoming that; infinite where an element is not finite or the sum is
   no number. The first residuals that are seen choose the shift: 0 unless their squares would leave the range of
   double. */
static double ms_pme__sum_of_squares(ms_pme__run *run, double *r)
{
    double largest = 0, sum = 0;
    size_t i;
    int exponent;
    for (i = 0; i < run->m; ++i) {
        if (!ms__finite(r[i])) return MS_PME__INF;
        if (fabs(r[i]) > largest) largest = fabs(r[i]);
    }
    if (!run->shifted && largest > 0) {
        run->shifted = 1;
        frexp(largest, &exponent);
        run->shift = exponent > 330 || exponent < -330 ? -exponent : 0;
    }
    ms_pme__shift_all(r, run->m, run->shift);
    largest = ms_pme__shifted(largest, run->shift);
    if (largest > 1e140) return MS_PME__INF;
    for (i = 0; i < run->m; ++i) sum += r[i] * r[i];
    return sum;
}

/* f(x); infinity for NaN, and once the run has stopped. With residuals they go to r [m]. */
static double ms_pme__value_to(ms_pme__run *run, const double *x, double *r)
{
    const ms_pme_function *function = run->function;
    double f = 0;
    if (ms_pme__spend(run, 1)) return MS_PME__INF;
    run->result.evaluations++;
    if (ms_pme__fail(run,
                     function->residuals != NULL ? function->residuals(function->user, x, r, NULL)
                                                 : function->value(function->user, x, &f)))
        return MS_PME__INF;
    return ms_pme__seen(run, x, function->residuals != NULL ? ms_pme__sum_of_squares(run, r) : f);
}

static double ms_pme__value(ms_pme__run *run, const double *x) { return ms_pme__value_to(run, x, run->residual_step); }

/* The step of a difference in x_j, inside the box, and whether it may be central. */
static double ms_pme__difference_step(const ms_pme__run *run, double x, int j, int central, double *back)
{
    double range = run->upper[j] - run->lower[j], scale = ms__finite(range) ? range : 1;
    double h = run->options->difference_step;
    if (!(h > 0)) h = (central ? 6.1e-6 : 1.5e-8) * ms_pme__max(fabs(x), 1e-2 * scale); /* eps^(1/3), eps^(1/2) */
    if (!(h > 1e-15 * fabs(x))) h = 1e-15 * fabs(x) + DBL_MIN;
    *back = central && !(run->options->difference_step > 0) ? h : 0;
    if (x + h > run->upper[j]) {
        if (x - h < run->lower[j]) h = run->upper[j] - x > x - run->lower[j] ? run->upper[j] - x : run->lower[j] - x;
        else h = -h;
        *back = 0;
    } else if (x - *back < run->lower[j]) {
        *back = 0;
    }
    return h;
}

/* A derivative is not finite: the run fails, as no step can be made of it. */
static double ms_pme__bad_derivative(ms_pme__run *run, size_t i, int j)
{
    run->bad = i;
    run->bad_parameter = j;
    ms_pme__fail(run, MS_BAD_DATA);
    return MS_PME__INF;
}

/* Residuals and Jacobian at x into run->residual and run->jacobian; returns f. known: residual_step holds the
   residuals. */
static double ms_pme__linearize(ms_pme__run *run, const double *x, double known)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j, k;
    size_t i, size = run->m * (size_t)n;
    double f = known;
    if (!function->residuals_only) {
        if (ms_pme__spend(run, run->jacobian_cost)) return MS_PME__INF;
        run->result.jacobians++;
        if (ms_pme__fail(run, function->residuals(function->user, x, run->residual, run->jacobian))) return MS_PME__INF;
        f = ms_pme__sum_of_squares(run, run->residual);
        if (!ms__finite(f)) return MS_PME__INF;
        for (i = 0; i < size; ++i)
            if (!ms__finite(run->jacobian[i])) return ms_pme__bad_derivative(run, i / (size_t)n, (int)(i % (size_t)n));
        ms_pme__shift_all(run->jacobian, size, run->shift);
        return ms_pme__seen(run, x, f);
    }
    if (!ms__finite(f)) f = ms_pme__value_to(run, x, run->residual);
    else memcpy(run->residual, run->residual_step, run->m * sizeof(double));
    if (!ms__finite(f)) return f;
    for (j = 0; j < n; ++j) {
        double back, h = ms_pme__difference_step(run, x[j], j, 0, &back), *moved = run->scratch;
        for (k = 0; k < 2; ++k, h = -h) { /* where it is not finite on one side, the other */
            double value;
            ms_pme__copy(moved, x, n);
            moved[j] = ms_pme__clip(x[j] + h, run->lower[j], run->upper[j]);
            h = moved[j] - x[j];
            if (!(h < 0) && !(h > 0)) break;
            value = ms_pme__value_to(run, moved, run->residual_step);
            if (run->stopped) return MS_PME__INF;
            if (ms__finite(value)) break;
        }
        if (k == 2) return ms_pme__bad_derivative(run, 0, j);
        for (i = 0; i < run->m; ++i)
            run->jacobian[i * (size_t)n + (size_t)j] = h < 0 || h > 0 ? (run->residual_step[i] - run->residual[i]) / h
                                                                      : 0;
    }
    return f;
}

/* Is x_j held by its bound against a descent along -g? */
static int ms_pme__held(const ms_pme__run *run, const double *x, const double *g, int j)
{
    return (x[j] <= run->lower[j] && g[j] >= 0) || (x[j] >= run->upper[j] && g[j] <= 0);
}

/* The projected gradient at x; kept if x is the best point. */
static double ms_pme__projected_gradient(ms_pme__run *run, const double *x, const double *g)
{
    double largest = 0;
    int j;
    for (j = 0; j < run->n; ++j)
        if (!ms_pme__held(run, x, g, j)) largest = ms_pme__max(largest, fabs(g[j]));
    if (memcmp(x, run->best, (size_t)run->n * sizeof *x) == 0) run->best_gradient = largest;
    return largest;
}

/* f and gradient at x by the best way that there is; infinity if the run has stopped. */
static double ms_pme__gradient(ms_pme__run *run, const double *x, double *g)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j;
    double f = 0;
    if (function->gradient != NULL && !(run->options->difference_step > 0)) {
        if (ms_pme__spend(run, run->jacobian_cost)) return MS_PME__INF;
        run->result.jacobians++;
        if (ms_pme__fail(run, function->gradient(function->user, x, &f, g))) return MS_PME__INF;
        f = ms_pme__seen(run, x, f);
        for (j = 0; j < n && ms__finite(f); ++j)
            if (!ms__finite(g[j])) return ms_pme__bad_derivative(run, 0, j);
    } else if (function->residuals != NULL && !function->residuals_only && !(run->options->difference_step > 0)) {
        size_t i;
        f = ms_pme__linearize(run, x, MS_PME__INF);
        for (j = 0; j < n; ++j) g[j] = 0;
        if (!ms__finite(f)) return f;
        for (i = 0; i < run->m; ++i) ms_pme__add(g, 2 * run->residual[i], run->jacobian + i * (size_t)n, n);
    } else {
        f = ms_pme__value(run, x);
        for (j = 0; j < n && !run->stopped; ++j) {
            double back, h = ms_pme__difference_step(run, x[j], j, 1, &back), *moved = run->scratch, high, low = f;
            ms_pme__copy(moved, x, n);
            moved[j] = x[j] + h;
            h = moved[j] - x[j];
            high = ms_pme__value(run, moved);
            if (back > 0) {
                moved[j] = x[j] - back;
                h += x[j] - moved[j];
                low = ms_pme__value(run, moved);
            }
            if (!ms__finite(high) || !ms__finite(low)) return MS_PME__INF; /* an edge: such a point leads nowhere */
            g[j] = h < 0 || h > 0 ? (high - low) / h : 0;
        }
        if (j < n) return MS_PME__INF;
    }
    if (run->status != MS_OK) return MS_PME__INF;
    if (ms__finite(f)) ms_pme__projected_gradient(run, x, g);
    return f;
}

/* ---- bounded least squares ------------------------------------------------------------------------------------- */

/* The columns `order`[0 .. free) of a matrix [n][n + 1] are an upper triangle; the others are full, the last is the
   right-hand side. Rotations of neighbouring rows keep that when a column enters or leaves, at the cost of some rows
   each. */
typedef struct ms_pme__active {
    double *a; /* [n][n + 1] */
    int *order, n, free;
} ms_pme__active;

static void ms_pme__turn(ms_pme__active *s, int row, int column)
{
    int w = s->n + 1;
    double c, sine, *upper = s->a + row * w, *lower = upper + w,
                    r = ms_pme__rotation(upper[column], lower[column], &c, &sine);
    if (c < 1) ms_pme__rotate(upper, lower, c, sine, w); /* also where it only turns signs: c = -1 */
    upper[column] = r;
    lower[column] = 0;
}

static void ms_pme__leave(ms_pme__active *s, int place)
{
    int column = s->order[place], i;
    for (i = place; i + 1 < s->free; ++i) s->order[i] = s->order[i + 1];
    s->order[--s->free] = column;
    for (i = place; i < s->free; ++i) ms_pme__turn(s, i, s->order[i]);
}

static void ms_pme__enter(ms_pme__active *s, int column)
{
    int place = s->free, i;
    while (s->order[place] != column) ++place;
    s->order[place] = s->order[s->free];
    s->order[s->free] = column;
    for (i = s->n - 2; i >= s->free; --i) ms_pme__turn(s, i, column);
    s->free++;
}

/* d [n] minimises |A d - b| over low <= d <= high, low <= 0 <= high: the active-set method of Stark and Parker (1995),
   exact after finitely many changes of the set. a [n][n + 1]: A upper triangular of full rank, then b; destroyed.
   state: the first guess of the set (0 free, -1 at low, 1 at high), out: the set. order [n], z [2 n] scratch. */
static void ms_pme__bounded_least_squares(double *a, int n, const double *low, const double *high, double *d,
                                          int *state, int *order, double *z)
{
    int w = n + 1, change, i, j, released = -1;
    double *rest = z + n;
    ms_pme__active s;
    s.a = a;
    s.order = order;
    s.n = s.free = n;
    for (j = 0; j < n; ++j) order[j] = j;
    for (j = n; j-- > 0;) {
        d[j] = state[j] < 0 ? low[j] : state[j] > 0 ? high[j] : 0;
        if (state[j] != 0) ms_pme__leave(&s, j);
    }
    for (change = 0; change < 4 * n + 8; ++change) {
        int worst = -1, hit = -1;
        double alpha = 1, steepest = 0;
        for (i = 0; i < n; ++i) { /* what the held columns leave of b */
            rest[i] = a[i * w + n];
            for (j = s.free; j < n; ++j) rest[i] -= a[i * w + order[j]] * d[order[j]];
        }
        for (i = s.free - 1; i >= 0; --i) {
            double t = rest[i], pivot = a[i * w + order[i]];
            for (j = i + 1; j < s.free; ++j) t -= a[i * w + order[j]] * z[j];
            z[i] = fabs(pivot) > 0 ? t / pivot : 0;
        }
        for (i = 0; i < s.free; ++i) { /* as far towards z as the box allows */
            double limit, t;
            j = order[i];
            if (z[i] >= low[j] && z[i] <= high[j]) continue;
            limit = z[i] < low[j] ? low[j] : high[j];
            t = z[i] < d[j] || z[i] > d[j] ? (limit - d[j]) / (z[i] - d[j]) : 0;
            if (t < alpha || hit < 0) {
                alpha = ms_pme__clip(t, 0, 1);
                hit = i;
            }
        }
        for (i = 0; i < s.free; ++i) {
            j = order[i];
            d[j] = ms_pme__clip(d[j] + alpha * (z[i] - d[j]), low[j], high[j]);
        }
        if (hit >= 0) {
            j = order[hit];
            state[j] = z[hit] < low[j] ? -1 : 1;
            d[j] = state[j] < 0 ? low[j] : high[j];
            ms_pme__leave(&s, hit);
            if (j == released && !(alpha > 1e-12)) break; /* rounding frees it again and again */
            released = -1;
            continue;
        }
        for (j = s.free; j < n; ++j) { /* on the face: which bound holds against the descent? */
            double t = 0, size = 0, push;
            int column = order[j];
            if (!(low[column] < high[column])) continue;
            for (i = s.free; i < n; ++i) {
                t += a[i * w + column] * rest[i];
                size += fabs(a[i * w + column] * rest[i]);
            }
            push = state[column] < 0 ? t : -t;
            if (push > 1e-14 * size && push > steepest) {
                steepest = push;
                worst = column;
            }
        }
        if (worst < 0) break;
        released = worst;
        state[worst] = 0;
        ms_pme__enter(&s, worst);
    }
}

/* ---- Levenberg-Marquardt --------------------------------------------------------------------------------------- */

/* One descent, which may rest and go on. Derivatives are taken when it takes its next step: several walks share
   them. */
typedef struct ms_pme__walk {
    double f, lambda, grow;
    double known;      /* f, where run->residual_step still holds the residuals at x; else infinite */
    int done;          /* nothing left to gain, or nothing finite */
    double *x, *scale; /* [n] the last accepted point; the trust region's */
    double *g;         /* [n] gradient */
    double *triangle;  /* [n + 1][n + 1] R and Q'(-r) */
} ms_pme__walk;

static int ms_pme__walk_size(int n) { return 3 * n + (n + 1) * (n + 1); }

/* points: x and scale, 2 n doubles; null: where derivatives are not in the same block. */
static void ms_pme__walk_place(ms_pme__walk *walk, double *memory, double *points, int n)
{
    memset(walk, 0, sizeof *walk);
    walk->triangle = memory;
    walk->g = memory + (n + 1) * (n + 1);
    walk->x = points != NULL ? points : walk->g + n;
    walk->scale = walk->x + n;
}

static double ms_pme__column_norm(const ms_pme__walk *walk, int n, int j)
{
    double sum = 0;
    int i;
    for (i = 0; i <= j; ++i) sum += walk->triangle[i * (n + 1) + j] * walk->triangle[i * (n + 1) + j];
    return sqrt(sum);
}

/* R and Q'(-r) of run->jacobian, g = 2 J'r. */
static void ms_pme__factor(ms_pme__run *run, ms_pme__walk *walk)
{
    int n = run->n, w = n + 1, i, j;
    double *triangle = walk->triangle;
    size_t row = 0;
    memset(triangle, 0, (size_t)(w * w) * sizeof(double));
    while (row < run->m) {
        int k = run->m - row < MS_PME__ROWS ? (int)(run->m - row) : MS_PME__ROWS;
        for (i = 0; i < k; ++i, ++row) {
            for (j = 0; j < n; ++j) run->rows[j * MS_PME__ROWS + i] = run->jacobian[row * (size_t)n + (size_t)j];
            run->rows[n * MS_PME__ROWS + i] = -run->residual[row];
        }
        ms_pme__qr_append(triangle, n, run->rows, k);
    }
    for (j = 0; j < n; ++j) {
        double t = 0;
        for (i = 0; i <= j; ++i) t -= triangle[i * w + j] * triangle[i * w + n];
        walk->g[j] = 2 * t;
    }
}

/* Takes the derivatives at walk->x: factor, and the trust region's scale. That is the largest column norms so far (More
   1978); for pictures, whose parameters all have a range, the norms of now, none below 0.3 of the largest (both for a
   step across the box): what hardly changes the picture does not run off to its bounds. */
static void ms_pme__arrive(ms_pme__run *run, ms_pme__walk *walk)
{
    int n = run->n, j;
    double largest = 0, angle = 0; /* angle: largest cosine between the residual and a column that may move */
    walk->f = ms_pme__linearize(run, walk->x, walk->known);
    walk->known = MS_PME__INF;
    if (!ms__finite(walk->f)) {
        walk->done = 1;
        return;
    }
    ms_pme__factor(run, walk);
    ms_pme__projected_gradient(run, walk->x, walk->g);
    for (j = 0; j < n && run->ranged; ++j)
        largest = ms_pme__max(largest, (run->upper[j] - run->lower[j]) * ms_pme__column_norm(walk, n, j));
    for (j = 0; j < n; ++j) {
        double range = run->upper[j] - run->lower[j], norm = ms_pme__column_norm(walk, n, j);
        walk->scale[j] = ms_pme__max(norm, !run->ranged ? walk->scale[j] : range > 0 ? 0.3 * largest / range : 0);
        if (!ms_pme__held(run, walk->x, walk->g, j) && norm > 0 && walk->f > 0)
            angle = ms_pme__max(angle, 0.5 * fabs(walk->g[j]) / (norm * sqrt(walk->f)));
    }
    if (!(walk->f > 0) || angle <= 1e-14) walk->done = 1;
}

static void ms_pme__set_out(ms_pme__walk *walk, const double *x, int n)
{
    int j;
    ms_pme__copy(walk->x, x, n);
    for (j = 0; j < n; ++j) walk->scale[j] = 0;
    walk->lambda = 1e-3;
    walk->grow = 2;
    walk->done = 0;
    walk->f = walk->known = MS_PME__INF;
}

/* [R; sqrt(lambda) D] as a triangle with its right-hand side, by rotations of each row of D into R. */
static void ms_pme__damp(const ms_pme__walk *walk, int n, double *a, double *row)
{
    int w = n + 1, i, j;
    ms_pme__copy(a, walk->triangle, n * w);
    for (i = n; i-- > 0;) { /* from below: a row meets only those under it */
        memset(row + i, 0, (size_t)(w - i) * sizeof *row);
        row[i] = sqrt(walk->lambda) * (walk->scale[i] > 0 ? walk->scale[i] : 1);
        for (j = i; j < n; ++j) {
            double c, s, r = ms_pme__rotation(a[j * w + j], row[j], &c, &s);
            ms_pme__rotate(a + j * w + j, row + j, c, s, w - j);
            a[j * w + j] = r;
        }
    }
}

/* What the linear model promises: |r|^2 - |r + J d|^2. */
static double ms_pme__predicted_decrease(const ms_pme__walk *walk, int n, const double *d)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) {
        const double *row = walk->triangle + i * (n + 1);
        double t = ms_pme__dot(row + i, d + i, n - i);
        sum += t * (2 * row[n] - t);
    }
    return sum;
}

/* Derivatives, then trials until one is accepted, the walk is done or the run has stopped: the damped problem in the
   box, solved exactly; damping by the ratio of actual to predicted decrease (Nielsen 1999). */
static void ms_pme__step(ms_pme__run *run, ms_pme__walk *walk, double *memory)
{
    int n = run->n, j, state[MS_PME__VARIABLES], order[MS_PME__VARIABLES];
    double *trial = memory, *d = trial + n, *low = d + n, *high = low + n, *z = high + n, *row = z + 2 * n,
           *a = row + n + 1;
    double *x = walk->x;
    ms_pme__arrive(run, walk);
    while (!walk->done && !run->stopped) {
        double predicted, f, t, step = 0, size = 0;
        ms_pme__damp(walk, n, a, row);
        for (j = 0; j < n; ++j) {
            low[j] = run->lower[j] - x[j];
            high[j] = run->upper[j] - x[j];
            state[j] = !ms_pme__held(run, x, walk->g, j) ? 0 : low[j] >= 0 ? -1 : 1;
        }
        ms_pme__bounded_least_squares(a, n, low, high, d, state, order, z);
        for (j = 0; j < n; ++j) {
            trial[j] = state[j] < 0 ? run->lower[j]
                : state[j] > 0      ? run->upper[j]
                                    : ms_pme__clip(x[j] + d[j], run->lower[j], run->upper[j]);
            step += walk->scale[j] * walk->scale[j] * d[j] * d[j];
            size += walk->scale[j] * walk->scale[j] * x[j] * x[j];
        }
        predicted = ms_pme__predicted_decrease(walk, n, d);
        if (!(predicted > 1e-15 * walk->f) || step <= 1e-30 * size || !(walk->lambda < 1e60)) {
            walk->done = 1; /* nothing left to gain that rounding would not swallow */
            break;
        }
        f = ms_pme__value_to(run, trial, run->residual_step);
        if (ms__finite(f) && walk->f - f > 1e-4 * predicted) {
            walk->done = (walk->f - f <= run->tolerance * walk->f && predicted <= run->tolerance * walk->f) ||
                step <= run->tolerance * run->tolerance * size;
            t = 2 * (walk->f - f) / predicted - 1;
            walk->lambda = ms_pme__max(walk->lambda * ms_pme__max(0.1, 1 - t * t * t), 1e-16);
            walk->grow = 2;
            ms_pme__copy(x, trial, n);
            run->result.iterations++;
            walk->f = walk->known = f;
            break;
        }
        walk->lambda *= walk->grow;
        walk->grow *= 2;
    }
}

/* ---- restarts -------------------------------------------------------------------------------------------------- */

/* Uniform in the box; a side without a bound reaches max(|x|, 1) beyond x. */
static void ms_pme__random_point(ms_pme__run *run, const double *near_x, double *x)
{
    int j;
    for (j = 0; j < run->n; ++j) {
        double reach = ms_pme__max(fabs(near_x[j]), 1), u = ms__rng_uniform(&run->rng);
        double low = ms__finite(run->lower[j]) ? run->lower[j] : near_x[j] - reach;
        double high = ms__finite(run->upper[j]) ? run->upper[j] : near_x[j] + reach;
        x[j] = ms_pme__clip(low + u * (high - low), run->lower[j], run->upper[j]);
    }
}

/* Up to `steps` steps of a walk. */
static void ms_pme__advance(ms_pme__run *run, ms_pme__walk *walk, int steps, double *memory)
{
    while (steps-- > 0 && !walk->done && !run->stopped) ms_pme__step(run, walk, memory);
    walk->known = MS_PME__INF; /* another one may come between */
}

/* Levenberg-Marquardt from starts [count][n], the best first, of which `restarts` + 1 may be used. Which minimum is the
   least shows after some steps, hardly before: as many set out as a fifth of the steps that the budget has, the better
   third of them goes on, and the best of those to its end (successive halving). While cost is left: the others roughly,
   and to the end where they lead further; random points, every second one from around the best. */
static void ms_pme__descend(ms_pme__run *run, const double *starts, int count, int restarts, double *memory)
{
    ms_pme__walk walks[MS_PME__FIELD], walk;
    int n = run->n, i, j, field, alive;
    double *scratch = memory + ms_pme__walk_size(n) - 2 * n + 2 * n * MS_PME__FIELD, tolerance = run->tolerance;
    double steps = (run->max_cost - run->result.cost) / (1 + (run->function->residuals_only ? n : run->jacobian_cost));
    field = restarts < count ? restarts + 1 : count;
    for (i = 0; i < field; ++i) {
        ms_pme__walk_place(&walks[i], memory, memory + ms_pme__walk_size(n) - 2 * n + 2 * n * i, n);
        ms_pme__set_out(&walks[i], starts + (size_t)i * (size_t)n, n);
    }
    for (alive = steps / 5 < field ? (int)(steps / 5) : field; alive > 1; alive = alive > 3 ? (alive + 2) / 3 : 1) {
        for (i = 0; i < alive; ++i) ms_pme__advance(run, &walks[i], 3, scratch);
        for (i = 1; i < alive; ++i)
            for (j = i; j > 0 && walks[j].f < walks[j - 1].f; --j) {
                walk = walks[j];
                walks[j] = walks[j - 1];
                walks[j - 1] = walk;
            }
    }
    for (i = 0; i <= restarts && !run->stopped; ++i) {
        double best = run->best_value;
        ms_pme__walk *next = &walks[i < field ? i : field - 1];
        if (i > 0) run->tolerance = ms_pme__max(tolerance, 1e-3);
        if (i >= field) {
            if (i % 2 != 0 || !run->ranged) ms_pme__random_point(run, run->best, scratch);
            for (j = 0; j < n && i % 2 == 0 && run->ranged; ++j)
                scratch[j] = ms_pme__clip(run->best[j] +
                                              (ms__rng_uniform(&run->rng) - 0.5) * (run->upper[j] - run->lower[j]),
                                          run->lower[j], run->upper[j]);
            ms_pme__set_out(next, scratch, n);
        }
        ms_pme__advance(run, next, INT_MAX, scratch);
        run->tolerance = tolerance;
        if (i > 0 && run->best_value < best && ms__finite(next->f)) {
            next->done = 0;
            ms_pme__advance(run, next, INT_MAX, scratch);
        }
    }
}

/* ---- l-bfgs ---------------------------------------------------------------------------------------------------- */

/* Where a line search stands: a point, its value and gradient. */
typedef struct ms_pme__point {
    double f;
    double *x, *g; /* [n] each */
} ms_pme__point;

/* Strong Wolfe conditions along d by bracketing and cubic interpolation (Nocedal and Wright 2006, algorithms 3.5 and
   3.6), the step at most longest; at longest decrease alone is enough. From p to q; the step, or 0 if none was
   found. */
static double ms_pme__line_search(ms_pme__run *run, const ms_pme__point *p, const double *d, double first,
                                  double longest, ms_pme__point *q)
{
    int n = run->n, j, tries;
    double slope = ms_pme__dot(p->g, d, n), t = first < longest ? first : longest;
    double low = 0, f_low = p->f, slope_low = slope, high = 0, f_high = 0, slope_high = 0, s;
    int bracketed = 0;
    if (!(slope < 0) || !(longest > 0)) return 0;
    for (tries = 0; tries < 40 && !run->stopped; ++tries) {
        for (j = 0; j < n; ++j) q->x[j] = ms_pme__clip(p->x[j] + t * d[j], run->lower[j], run->upper[j]);
        q->f = ms_pme__gradient(run, q->x, q->g);
        s = ms__finite(q->f) ? ms_pme__dot(q->g, d, n) : 0;
        if (!ms__finite(q->f) || !(q->f <= p->f + 1e-4 * t * slope) || (bracketed && q->f >= f_low)) {
            high = t;
            f_high = q->f;
            slope_high = s;
            bracketed = 1;
        } else {
            if (fabs(s) <= -0.9 * slope || (t >= longest && s < 0)) return t;
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
            double width = high - low, theta, radical, next = low + (ms__finite(f_high) ? 0.5 : 0.1) * width;
            if (fabs(width) <= 1e-15 * (fabs(low) + fabs(high))) break;
            t = next;
            if (ms__finite(f_high)) {
                theta = 3 * (f_low - f_high) / width + slope_low + slope_high;
                radical = theta * theta - slope_low * slope_high;
                if (radical >= 0) {
                    double root = sqrt(radical) * (width > 0 ? 1 : -1), below = slope_high - slope_low + 2 * root;
                    if (fabs(below) > 0) next = high - width * (slope_high + root - theta) / below;
                }
                if ((next - low) / width > 0.05 && (next - low) / width < 0.95) t = next;
            }
        }
    }
    /* rounding or noise: the best bracketed point will do if it is lower at all */
    if (low > 0 && f_low < p->f && !run->stopped) {
        for (j = 0; j < n; ++j) q->x[j] = ms_pme__clip(p->x[j] + low * d[j], run->lower[j], run->upper[j]);
        q->f = ms_pme__gradient(run, q->x, q->g);
        if (ms__finite(q->f) && q->f < p->f) return low;
    }
    return 0;
}

/* d = -H g on the variables that no bound holds, H from the last pairs by the two-loop recursion (Nocedal 1980). */
static void ms_pme__lbfgs_direction(const ms_pme__run *run, const ms_pme__point *p, const double *s, const double *y,
                                    int newest, int count, double *d)
{
    int n = run->n, j, k, pass;
    double alpha[MS_PME__MEMORY], rho[MS_PME__MEMORY];
    for (j = 0; j < n; ++j) d[j] = ms_pme__held(run, p->x, p->g, j) ? 0 : -p->g[j];
    for (pass = 0; pass < 2; ++pass) {
        for (k = pass ? count - 1 : 0; pass ? k >= 0 : k < count; k += pass ? -1 : 1) {
            const double *sk = s + (newest - k + MS_PME__MEMORY) % MS_PME__MEMORY * n, *yk = y + (sk - s);
            double sy = 0, along = 0;
            for (j = 0; j < n; ++j) {
                if (ms_pme__held(run, p->x, p->g, j)) continue;
                sy += sk[j] * yk[j];
                along += (pass ? yk[j] : sk[j]) * d[j];
            }
            rho[k] = sy;
            if (!(sy > 0)) continue;
            if (pass == 0) alpha[k] = along / sy;
            for (j = 0; j < n; ++j)
                if (!ms_pme__held(run, p->x, p->g, j))
                    d[j] += pass ? (alpha[k] - along / sy) * sk[j] : -alpha[k] * yk[j];
        }
        if (pass == 0 && count > 0 && rho[0] > 0) { /* the first H: s'y / y'y of the newest pair */
            double yy = 0;
            for (j = 0; j < n; ++j)
                if (!ms_pme__held(run, p->x, p->g, j)) yy += y[newest * n + j] * y[newest * n + j];
            for (j = 0; j < n && yy > 0; ++j) d[j] *= rho[0] / yy;
        }
    }
}

/* Limited-memory quasi-Newton with an active set of bounds. */
static void ms_pme__lbfgs(ms_pme__run *run, const double *x, double *memory)
{
    int n = run->n, j, count = 0, newest = 0, fresh = 1;
    double *d = memory, *s = d + n, *y = s + MS_PME__MEMORY * n;
    ms_pme__point p, q;
    p.x = y + MS_PME__MEMORY * n;
    p.g = p.x + n;
    q.x = p.g + n;
    q.g = q.x + n;
    ms_pme__copy(p.x, x, n);
    p.f = ms_pme__gradient(run, p.x, p.g);
    while (!run->stopped && ms__finite(p.f)) {
        double step, longest = 1e10, slope, steep = 0, first = 1, sy = 0, yy, size = 0, moved = 0, gain;
        int was_fresh = fresh;
        if (!(ms_pme__projected_gradient(run, p.x, p.g) > 0)) break;
        if (fresh) count = 0; /* the model starts as the gradient */
        ms_pme__lbfgs_direction(run, &p, s, y, newest, count, d);
        for (j = 0; j < n; ++j) /* no pushing against a bound */
            if ((p.x[j] <= run->lower[j] && d[j] < 0) || (p.x[j] >= run->upper[j] && d[j] > 0)) d[j] = 0;
        for (j = 0; j < n; ++j) {
            double room = d[j] > 0 ? run->upper[j] - p.x[j] : run->lower[j] - p.x[j];
            if (!(fabs(d[j]) > 0)) continue;
            steep += p.g[j] * p.g[j];
            if (room / d[j] < longest) longest = room / d[j];
        }
        slope = ms_pme__dot(p.g, d, n);
        if (!(slope < -1e-12 * sqrt(steep * ms_pme__dot(d, d, n)))) {
            if (fresh) break;
            fresh = 1;
            continue;
        }
        if (fresh) { /* no idea of the scale yet: a step of 1% of the box */
            double reach = 0;
            for (j = 0; j < n; ++j) {
                double range = run->upper[j] - run->lower[j];
                reach = ms_pme__max(
                    reach, fabs(d[j]) / (ms__finite(range) && range > 0 ? range : ms_pme__max(fabs(p.x[j]), 1)));
            }
            first = reach > 0 ? 0.01 / reach : 1;
        }
        step = ms_pme__line_search(run, &p, d, first, longest, &q);
        if (!(step > 0)) {
            if (fresh || run->stopped) break;
            fresh = 1; /* once more along the gradient */
            continue;
        }
        gain = p.f - q.f;
        newest = (newest + 1) % MS_PME__MEMORY;
        for (j = 0; j < n; ++j) {
            s[newest * n + j] = q.x[j] - p.x[j];
            y[newest * n + j] = q.g[j] - p.g[j];
            if (step >= longest && fabs(d[j]) > 0) { /* all that reach their bound together land on it */
                double bound = d[j] > 0 ? run->upper[j] : run->lower[j];
                if ((bound - p.x[j]) / d[j] <= longest * (1 + 1e-9)) q.x[j] = bound;
            }
            sy += s[newest * n + j] * y[newest * n + j];
            moved = ms_pme__max(moved, fabs(s[newest * n + j]));
            size = ms_pme__max(size, fabs(q.x[j]));
        }
        yy = ms_pme__dot(y + newest * n, y + newest * n, n);
        if (sy > 1e-14 * yy) count = count < MS_PME__MEMORY ? count + 1 : count;
        else newest = (newest + MS_PME__MEMORY - 1) % MS_PME__MEMORY;
        run->result.iterations++;
        fresh = 0;
        ms_pme__copy(p.x, q.x, n);
        ms_pme__copy(p.g, q.g, n);
        p.f = q.f;
        if (gain <= run->tolerance * (fabs(p.f) + DBL_MIN) && moved <= run->tolerance * size) break;
        if (gain <= 1e-16 * fabs(p.f)) {
            if (was_fresh) break;
            fresh = 1;
        }
    }
}

/* ---- Nelder-Mead ----------------------------------------------------------------------------------------------- */

/* to = from + t (towards - from), inside the box; may be either. */
static void ms_pme__between(const ms_pme__run *run, const double *from, const double *towards, double t, double *to)
{
    int j;
    for (j = 0; j < run->n; ++j)
        to[j] = ms_pme__clip(from[j] + t * (towards[j] - from[j]), run->lower[j], run->upper[j]);
}

/* Nelder and Mead 1965 with the customary coefficients 1, 2, 1/2, 1/2, points clipped to the box; a simplex that
   collapsed is built anew around the best point until that gains nothing. */
static void ms_pme__nelder_mead(ms_pme__run *run, const double *x, double *memory)
{
    int n = run->n, i, j;
    double *vertex = memory, *value = vertex + (n + 1) * n, *middle = value + n + 1, *trial = middle + n,
           *farther = trial + n;
    double best_before = MS_PME__INF, edge = run->options->start_step > 0 ? run->options->start_step : 0.1;
    ms_pme__copy(run->best, x, n);
    while (!run->stopped) {
        for (i = 0; i <= n; ++i) {
            double *v = vertex + i * n;
            ms_pme__copy(v, run->best, n);
            if (i > 0) {
                double range = run->upper[i - 1] - run->lower[i - 1], *c = &v[i - 1];
                double h = edge * (ms__finite(range) ? range : ms_pme__max(fabs(*c), 1));
                *c = *c + h <= run->upper[i - 1] ? *c + h : ms_pme__max(*c - h, run->lower[i - 1]);
            }
        }
        for (i = 0; i <= n; ++i) value[i] = ms_pme__value(run, vertex + i * n);
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
                    spread = ms_pme__max(spread, fabs(vertex[i * n + j] - vertex[low * n + j]));
                    size = ms_pme__max(size, fabs(vertex[low * n + j]));
                }
            if ((ms__finite(value[high]) && value[high] - value[low] <= run->tolerance * fabs(value[low]) &&
                 spread <= 1e-4 * ms_pme__max(size, 1e-30)) ||
                spread <= 1e-14 * ms_pme__max(size, 1e-290))
                break;
            run->result.iterations++;
            for (j = 0; j < n; ++j) {
                middle[j] = 0;
                for (i = 0; i <= n; ++i)
                    if (i != high) middle[j] += vertex[i * n + j];
                middle[j] /= n;
            }
            ms_pme__between(run, middle, vertex + high * n, -1, trial);
            f_trial = ms_pme__value(run, trial);
            if (f_trial < value[low]) { /* expand */
                ms_pme__between(run, middle, vertex + high * n, -2, farther);
                f_far = ms_pme__value(run, farther);
                c = f_far < f_trial;
                ms_pme__copy(vertex + high * n, c ? farther : trial, n);
                value[high] = c ? f_far : f_trial;
                continue;
            }
            if (f_trial < value[next]) {
                ms_pme__copy(vertex + high * n, trial, n);
                value[high] = f_trial;
                continue;
            }
            inside = !(f_trial < value[high]); /* contract towards the better of the two */
            ms_pme__between(run, middle, inside ? vertex + high * n : trial, 0.5, farther);
            f_far = ms_pme__value(run, farther);
            if (f_far < (inside ? value[high] : f_trial)) {
                ms_pme__copy(vertex + high * n, farther, n);
                value[high] = f_far;
                continue;
            }
            for (i = 0; i <= n && !run->stopped; ++i) { /* shrink */
                if (i == low) continue;
                ms_pme__between(run, vertex + low * n, vertex + i * n, 0.5, vertex + i * n);
                value[i] = ms_pme__value(run, vertex + i * n);
            }
        }
        if (!ms__finite(run->best_value) ||
            (ms__finite(best_before) && run->best_value >= best_before - run->tolerance * fabs(best_before)))
            break;
        best_before = run->best_value;
    }
}

/* ---- basin hopping --------------------------------------------------------------------------------------------- */

/* The method that other methods stand on, from x. */
static void ms_pme__local(ms_pme__run *run, const double *x, double *memory)
{
    if (run->function->residuals != NULL) ms_pme__descend(run, x, 1, 0, memory);
    else ms_pme__lbfgs(run, x, memory);
}

/* Wales and Doye 1997. The temperature follows the scatter of the minima seen; the hop is tuned to accept half. */
static void ms_pme__basin_hopping(ms_pme__run *run, const double *x, double *memory)
{
    int n = run->n, j, hops, accepted = 0;
    double *here = memory, *trial = here + n, *best = trial + n,
           hop = run->options->start_step > 0 ? run->options->start_step : 0.25;
    double f_here = MS_PME__INF, temperature = 0, best_value = MS_PME__INF, best_gradient = -1;
    memory = best + n;
    ms_pme__copy(trial, x, n);
    for (hops = 0; !run->stopped; ++hops) {
        double f_trial, rise;
        for (j = 0; j < n && hops > 0; ++j) {
            double range = run->upper[j] - run->lower[j], u = 2 * ms__rng_uniform(&run->rng) - 1;
            trial[j] = here[j] + hop * u * (ms__finite(range) ? range : ms_pme__max(fabs(here[j]), 1));
            trial[j] = ms_pme__clip(trial[j], run->lower[j], run->upper[j]);
        }
        run->best_value = MS_PME__INF; /* so that run->best is where this descent ends */
        ms_pme__local(run, trial, memory);
        f_trial = run->best_value;
        if (ms__finite(f_trial)) ms_pme__copy(trial, run->best, n);
        if (f_trial < best_value) {
            best_value = f_trial;
            best_gradient = run->best_gradient;
            ms_pme__copy(best, trial, n);
        }
        if (hops == 0) {
            ms_pme__copy(here, trial, n);
            f_here = f_trial;
            continue;
        }
        if (!ms__finite(f_trial)) continue;
        rise = ms__finite(f_here) ? f_trial - f_here : -1;
        temperature += (0.5 * fabs(rise) - temperature) / hops;
        if (rise <= 0 || ms__rng_uniform(&run->rng) < exp(-rise / (temperature > 0 ? temperature : 1))) {
            ms_pme__copy(here, trial, n);
            f_here = f_trial;
            ++accepted;
        }
        if (hops % 10 == 0) hop = ms_pme__clip(2 * accepted > hops ? hop / 0.9 : hop * 0.9, 0.01, 1);
    }
    run->best_value = best_value;
    run->best_gradient = best_gradient;
    ms_pme__copy(run->best, best, n);
}

/* The chosen method from starts [count][n], the best first. */
static void ms_pme__method(ms_pme__run *run, const double *starts, int count, double *memory)
{
    switch (run->options->method) {
    case MS_PME_NELDER_MEAD: ms_pme__nelder_mead(run, starts, memory); break;
    case MS_PME_LBFGS: ms_pme__lbfgs(run, starts, memory); break;
    case MS_PME_BASIN_HOPPING: ms_pme__basin_hopping(run, starts, memory); break;
    default:
        if (run->function->residuals == NULL) ms_pme__lbfgs(run, starts, memory);
        else ms_pme__descend(run, starts, count, run->options->restarts, memory);
    }
    run->result.projected_gradient = run->best_gradient < 0 ? -1 : ms_pme__shifted(run->best_gradient, -2 * run->shift);
    run->result.value = run->best_value < 0 ? run->best_value : ms_pme__shifted(run->best_value, -2 * run->shift);
}

/* The run ended on a value: the gradient there, by one call more with derivatives, where there are any. */
static void ms_pme__last_gradient(ms_pme__run *run, double *g)
{
    const ms_pme_function *function = run->function;
    double cost = run->result.cost, *x = g + run->n;
    size_t jacobians = run->result.jacobians;
    if (!ms__finite(run->best_value) ||
        (function->gradient == NULL && (function->residuals == NULL || function->residuals_only)))
        return;
    run->stopped = 0;
    run->max_cost = MS_PME__INF;
    ms_pme__copy(x, run->best, run->n);
    run->finishing = 1;
    ms_pme__gradient(run, x, g);
    run->result.cost = cost;
    run->result.jacobians = jacobians;
    if (run->best_gradient >= 0) run->result.projected_gradient = ms_pme__shifted(run->best_gradient, -2 * run->shift);
}

/* Doubles that they need beside the run's own; with room for three squares. */
static size_t ms_pme__method_scratch(int n)
{
    size_t un = (size_t)n;
    return 3 * un * (un + 1) + (2 * MS_PME__MEMORY + 2 * MS_PME__FIELD + 32) * un + 32;
}

/* ---- public: minimize ------------------------------------------------------------------------------------------ */

MS_API ms_pme_options ms_pme_defaults(void)
{
    ms_pme_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_API const char *ms_pme_method_string(int method)
{
    static const char *const name[] = {"levenberg-marquardt", "nelder-mead", "l-bfgs", "basin-hopping"};
    return method >= 0 && method <= MS_PME_BASIN_HOPPING ? name[method] : "unknown";
}

static ms_status ms_pme__check(const ms_pme_function *function, const ms_pme_options *options, const double *x,
                               ms_error *error)
{
    static const char *const name[7] = {"max_cost",        "max_seconds",  "tolerance",    "start_step",
                                        "difference_step", "target_value", "jacobian_cost"};
    double value[7] = {options->max_cost,
                       options->max_seconds,
                       options->tolerance,
                       options->start_step,
                       options->difference_step,
                       options->target_value,
                       0};
    int j;
    if (function == NULL || x == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, function ? "x is NULL" : "function is NULL");
    if (function->residuals == NULL && function->value == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "residuals and value are NULL: one is needed");
    if (function->parameter_count < 1 || function->parameter_count > MS_PME_PARAMETERS_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter_count is %d, expected 1 to %d",
                        function->parameter_count, MS_PME_PARAMETERS_MAX);
    if (function->residuals != NULL && function->residual_count < 1)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "residual_count is 0, expected 1 or more");
    if (options->method < 0 || options->method > MS_PME_BASIN_HOPPING)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "method is %d, expected 0 to %d (ms_pme_method)",
                        options->method, (int)MS_PME_BASIN_HOPPING);
    if (options->restarts < 0)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "restarts is %d, expected 0 or more", options->restarts);
    value[6] = function->jacobian_cost;
    for (j = 0; j < 7; ++j)
        if (!ms__finite(value[j]) || value[j] < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is %g, expected 0 (the default) or a number above it",
                            name[j], value[j]);
    for (j = 0; j < function->parameter_count; ++j) {
        double low = function->lower ? function->lower[j] : -MS_PME__INF,
               high = function->upper ? function->upper[j] : MS_PME__INF;
        if (!(low <= high) || !(low < MS_PME__INF) || !(high > -MS_PME__INF))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j,
                            "bounds of parameter %d are %g and %g: no number between them", j, low, high);
        if (!ms__finite(x[j]))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j,
                            "start of parameter %d is %g, expected a finite number", j, x[j]);
    }
    return MS_OK;
}

/* Sets up a run; its one block of memory is *block of *size bytes. */
static ms_status ms_pme__begin(ms_pme__run *run, const ms_pme_function *function, const ms_pme_options *options,
                               void **block, size_t *size, ms_error *error)
{
    int n = function->parameter_count, j;
    size_t m = function->residuals != NULL ? function->residual_count : 0, un = (size_t)n, count;
    double *p;
    memset(run, 0, sizeof *run);
    run->function = function;
    run->options = options;
    run->n = n;
    run->m = m;
    run->max_cost = options->max_cost > 0 ? options->max_cost : 1000;
    run->tolerance = options->tolerance > 0 ? options->tolerance : 1e-10;
    run->bad_parameter = -1;
    run->jacobian_cost = function->jacobian_cost > 0 ? function->jacobian_cost : 1 + 0.25 * n;
    run->best_value = MS_PME__INF;
    run->best_gradient = run->result.projected_gradient = -1;
    run->rng = ms__rng_make(options->seed, 0x706d65);
    run->start_time = options->max_seconds > 0 ? ms_pme__seconds(options) : 0;
    count = ms__size_add(ms__size_mul(m, un), 2 * m);                   /* jacobian, residual twice */
    count = ms__size_add(count, 3 * un + MS_PME__ROWS * (un + 1));      /* bounds, best, rows */
    count = ms__size_add(count, (size_t)n + ms_pme__method_scratch(n)); /* scratch begins with a moved point */
    *size = ms__size_mul(count, sizeof(double));
    *block = ms__alloc(&options->allocator, *size);
    if (*block == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z residuals times %d parameters", m, n);
    p = (double *)*block;
    run->jacobian = p;
    p += m * un;
    run->residual = p;
    p += m;
    run->residual_step = p;
    p += m;
    run->lower = p;
    p += n;
    run->upper = p;
    p += n;
    run->best = p;
    p += n;
    run->rows = p;
    p += MS_PME__ROWS * (n + 1);
    run->scratch = p;
    for (j = 0; j < n; ++j) {
        run->lower[j] = function->lower ? function->lower[j] : -MS_PME__INF;
        run->upper[j] = function->upper ? function->upper[j] : MS_PME__INF;
    }
    return MS_OK;
}

/* The sentence of a run that failed; its status. */
static ms_status ms_pme__why(const ms_pme__run *run, ms_error *error)
{
    double cost = run->result.cost;
    if (run->status == MS_OK)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "no finite value within %g evaluations of the start", cost);
    if (run->status == MS_BAD_DATA && run->bad_parameter >= 0)
        return ms__fail(error, MS_BAD_DATA, (size_t)run->bad_parameter,
                        "the derivative of residual %z by parameter %d is not finite", run->bad, run->bad_parameter);
    return ms__fail(error, run->status, 0,
                    run->status == MS_CANCELLED ? "cancelled after %g evaluations"
                                                : "a callback failed after %g evaluations",
                    cost);
}

MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error)
{
    ms_pme_options defaults = ms_pme_defaults();
    ms_pme__run run;
    void *block;
    size_t size;
    double *start;
    int n, j;
    ms_status status;
    if (options == NULL) options = &defaults;
    status = ms_pme__check(function, options, x, error);
    if (status == MS_OK) status = ms_pme__begin(&run, function, options, &block, &size, error);
    if (status != MS_OK) return status;
    n = run.n;
    start = run.scratch + n;
    for (j = 0; j < n; ++j) start[j] = ms_pme__clip(x[j], run.lower[j], run.upper[j]);
    ms_pme__method(&run, start, 1, start + n);
    if (run.status == MS_OK && run.best_gradient < 0 && options->method != MS_PME_NELDER_MEAD &&
        run.result.stop != MS_PME_STOP_SECONDS)
        ms_pme__last_gradient(&run, start + n);
    if (run.status != MS_OK || !ms__finite(run.best_value)) {
        status = ms_pme__why(&run, error);
    } else {
        ms_pme__copy(x, run.best, n);
        if (result != NULL) *result = run.result;
    }
    ms__release(&options->allocator, block, size);
    return status;
}

/* ---- match: objectives ----------------------------------------------------------------------------------------- */

/* What a match makes small, in variables z: the parameters that lead (others are tied to them), then the nuisance. The
   picture is a sum of squares, r_i = sqrt(w_i / sum w) (gain phi_i + offset - t_i), so that f is the squared weighted
   RMSE, or the caller's reduced function in that unit; behind it the pulls. */
typedef struct ms_pme__objective {
    const ms_pme_renderer *renderer;
    const ms_pme_match_options *options;
    const float *target, *weight;
    double weight_sum, offset;                   /* offset: what the reduced function leaves out, in the unit of f */
    double size;                                 /* root mean square of the target */
    int n, leads, pulled, gains, offsets, plain; /* plain: z is x */
    size_t m, compared;                          /* residuals of the picture; values with a weight */
    int place[MS_PME_PARAMETERS_MAX];            /* x_j = z[place_j] */
    int channel_of_gain[MS_PME_CHANNELS_MAX];
    double x[MS_PME_PARAMETERS_MAX], low[MS_PME__VARIABLES], high[MS_PME__VARIABLES];
    float *image, *jacobian; /* [p], [p][n] */
    double *slopes;          /* [m][n] of a reduced function whose parameters are tied */
} ms_pme__objective;

static const double *ms_pme__material(ms_pme__objective *o, const double *z)
{
    int j;
    for (j = 0; j < o->n; ++j) o->x[j] = z[o->place[j]];
    return o->x;
}

static void ms_pme__nuisance(const ms_pme__objective *o, const double *z, double *gain, double *offset)
{
    int c;
    for (c = 0; c < MS_PME_CHANNELS_MAX; ++c) {
        gain[c] = o->gains ? exp(z[o->leads + (o->gains > 1 && c < o->gains ? c : 0)]) : 1;
        offset[c] = c < o->offsets ? z[o->leads + o->gains + c] : 0;
    }
}

/* A row of derivatives by x into one by z. */
static void ms_pme__lead(const ms_pme__objective *o, const double *by_x, double *by_z, int variables)
{
    int j;
    for (j = 0; j < variables; ++j) by_z[j] = 0;
    for (j = 0; j < o->n; ++j) by_z[o->place[j]] += by_x[j];
}

static ms_status ms_pme__picture_residuals(ms_pme__objective *o, const double *z, double *r, double *jacobian,
                                           int variables)
{
    const ms_pme_renderer *renderer = o->renderer;
    double gain[MS_PME_CHANNELS_MAX], offset[MS_PME_CHANNELS_MAX], by_x[MS_PME_PARAMETERS_MAX];
    size_t i,
        plane = o->options->channels > 1 ? renderer->image_size / (size_t)o->options->channels : renderer->image_size;
    int j, n = o->n;
    const double *x = ms_pme__material(o, z);
    ms_status status = jacobian == NULL ? renderer->render(renderer->user, x, o->image)
                                        : renderer->jacobian(renderer->user, x, o->image, o->jacobian);
    if (status != MS_OK) return status;
    ms_pme__nuisance(o, z, gain, offset);
    for (i = 0; i < renderer->image_size; ++i) {
        int c = (int)(i / plane);
        double w = o->weight ? (double)o->weight[i] : 1, s = w > 0 ? sqrt(w / o->weight_sum) : 0,
               lit = gain[c] * (double)o->image[i];
        double *row = jacobian ? jacobian + i * (size_t)variables : NULL;
        r[i] = w > 0 ? s * (lit + offset[c] - (double)o->target[i]) : 0;
        if (row == NULL) continue;
        for (j = 0; j < n; ++j) by_x[j] = w > 0 ? s * gain[c] * (double)o->jacobian[i * (size_t)n + (size_t)j] : 0;
        ms_pme__lead(o, by_x, row, variables);
        if (o->gains) row[o->leads + (o->gains > 1 ? c : 0)] = w > 0 ? s * lit : 0;
        if (o->offsets) row[o->leads + o->gains + c] = s;
    }
    return MS_OK;
}

static ms_status ms_pme__objective_residuals(void *user, const double *z, double *r, double *jacobian)
{
    ms_pme__objective *o = (ms_pme__objective *)user;
    const ms_pme_function *reduced = o->renderer->reduced;
    int variables = o->leads + o->gains + o->offsets, j;
    size_t i, row = o->m;
    ms_status status;
    if (reduced == NULL || o->gains + o->offsets > 0) {
        status = ms_pme__picture_residuals(o, z, r, jacobian, variables);
    } else {
        double scale = 1 / sqrt(o->weight_sum), *slopes = jacobian && !o->plain ? o->slopes : jacobian;
        status = reduced->residuals(reduced->user, ms_pme__material(o, z), r, slopes);
        for (i = 0; i < o->m && status == MS_OK; ++i) r[i] *= scale;
        for (i = 0; i < o->m * (size_t)o->n && jacobian && status == MS_OK; ++i) slopes[i] *= scale;
        for (i = 0; i < o->m && jacobian && !o->plain && status == MS_OK; ++i)
            ms_pme__lead(o, slopes + i * (size_t)o->n, jacobian + i * (size_t)variables, variables);
    }
    for (j = 0; j < o->n && o->pulled && status == MS_OK; ++j) {
        double pull = sqrt(o->options->pull[j]);
        if (!(pull > 0)) continue;
        r[row] = pull * (z[o->place[j]] - o->options->source[j]);
        if (jacobian) {
            memset(jacobian + row * (size_t)variables, 0, (size_t)variables * sizeof *jacobian);
            jacobian[row * (size_t)variables + (size_t)o->place[j]] = pull;
        }
        ++row;
    }
    return status;
}

MS_API ms_pme_renderer ms_pme_renderer_defaults(void)
{
    ms_pme_renderer renderer;
    memset(&renderer, 0, sizeof renderer);
    return renderer;
}

MS_API ms_pme_match_options ms_pme_match_defaults(void)
{
    ms_pme_match_options options;
    memset(&options, 0, sizeof options);
    return options;
}

static ms_status ms_pme__check_picture(ms_pme__objective *o, ms_error *error)
{
    const ms_pme_renderer *renderer = o->renderer;
    const ms_pme_match_options *options = o->options;
    size_t i;
    if (renderer == NULL || o->target == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, renderer ? "target is NULL" : "renderer is NULL");
    if (renderer->render == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "renderer->render is NULL");
    if (renderer->parameter_count < 1 || renderer->parameter_count > MS_PME_PARAMETERS_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter_count is %d, expected 1 to %d",
                        renderer->parameter_count, MS_PME_PARAMETERS_MAX);
    if (renderer->image_size < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "image_size is 0, expected 1 or more");
    if (renderer->prediction_count < 0 || (renderer->prediction_count > 0 && renderer->predict == NULL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "prediction_count is %d and predict is NULL",
                        renderer->prediction_count);
    if (options->candidate_count < 0 || options->random_count < 0 ||
        (options->candidate_count > 0 && options->candidates == NULL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "candidate_count is %d, random_count %d: negative, or candidates is NULL",
                        options->candidate_count, options->random_count);
    if (!ms__finite(options->target_rmse) || options->target_rmse < 0)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "target_rmse is %g, expected 0 or more", options->target_rmse);
    if (renderer->reduced != NULL &&
        (renderer->reduced->residuals == NULL || !ms__finite(renderer->reduced_offset) ||
         renderer->reduced->parameter_count != renderer->parameter_count))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the reduced function lacks residuals or has other parameters");
    if (options->nuisance < 0 || options->nuisance > 7)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nuisance is %d, expected flags of ms_pme_nuisance",
                        options->nuisance);
    if (options->channels < 0 || options->channels > MS_PME_CHANNELS_MAX ||
        (options->channels > 1 && renderer->image_size % (size_t)options->channels != 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "channels is %d, expected 0 to %d and a divisor of image_size",
                        options->channels, MS_PME_CHANNELS_MAX);
    if (options->pull != NULL && options->source == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "pull is given and source is NULL");
    for (i = 0; i < (size_t)renderer->parameter_count; ++i) {
        int t = options->tie ? options->tie[i] : (int)i;
        if (t < 0 || t >= renderer->parameter_count || (options->tie && options->tie[t] != t))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "tie %z is %d, expected a parameter that is tied to itself",
                            i, t);
        if (options->pull && (!ms__finite(options->pull[i]) || options->pull[i] < 0 || !ms__finite(options->source[i])))
            return ms__fail(error, MS_INVALID_ARGUMENT, i,
                            "pull %z is %g towards %g, expected finite numbers, the first 0 or more", i,
                            options->pull[i], options->source[i]);
    }
    for (i = 0; i < renderer->image_size; ++i) {
        double w = o->weight ? (double)o->weight[i] : 1;
        if (!ms__finite(w) || w < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "weight %z is %g, expected a finite number >= 0", i, w);
        if (w > 0 && !ms__finite_f(o->target[i]))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "target %z is %g, expected a finite number", i,
                            (double)o->target[i]);
        o->compared += w > 0;
        o->weight_sum += w;
        if (w > 0) o->size += w * (double)o->target[i] * (double)o->target[i];
    }
    o->size = sqrt(o->size / (o->weight_sum > 0 ? o->weight_sum : 1));
    if (o->compared == 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "every weight is 0: nothing to match");
    return MS_OK;
}

/* Which variable each parameter is, their bounds, how many residuals there are. */
static void ms_pme__objective_make(ms_pme__objective *o, ms_pme_function *function)
{
    const ms_pme_renderer *renderer = o->renderer;
    const ms_pme_match_options *options = o->options;
    int n = renderer->parameter_count, j, k, channels = options->channels > 1 ? options->channels : 1;
    const ms_pme_function *reduced = renderer->reduced;
    o->n = n;
    for (j = 0; j < n; ++j) {
        double low = renderer->lower ? renderer->lower[j] : 0, high = renderer->upper ? renderer->upper[j] : 1;
        k = options->tie ? options->tie[j] : j;
        o->place[j] = k == j ? o->leads++ : 0;
        if (k == j) {
            o->low[o->place[j]] = low;
            o->high[o->place[j]] = high;
        }
        o->pulled += options->pull != NULL && options->pull[j] > 0;
    }
    for (j = 0; j < n && options->tie; ++j)
        if (options->tie[j] != j) { /* the box of a group is what all its members share */
            double low = renderer->lower ? renderer->lower[j] : 0, high = renderer->upper ? renderer->upper[j] : 1;
            k = o->place[j] = o->place[options->tie[j]];
            if (low > o->low[k]) o->low[k] = low;
            if (high < o->high[k]) o->high[k] = high;
        }
    o->gains = options->nuisance & MS_PME_TINT ? channels : options->nuisance & MS_PME_EXPOSURE ? 1 : 0;
    o->offsets = options->nuisance & MS_PME_OFFSET ? channels : 0;
    for (j = 0; j < o->gains + o->offsets; ++j) {
        o->high[o->leads + j] = j < o->gains ? log(8.0) : 1;
        o->low[o->leads + j] = -o->high[o->leads + j];
    }
    memset(function, 0, sizeof *function);
    function->user = o;
    function->parameter_count = o->leads + o->gains + o->offsets;
    function->residuals = ms_pme__objective_residuals;
    if (o->gains + o->offsets > 0) reduced = NULL;
    o->m = reduced ? reduced->residual_count : renderer->image_size;
    o->offset = reduced ? renderer->reduced_offset / o->weight_sum : 0;
    function->residual_count = o->m + (size_t)o->pulled;
    function->residuals_only = reduced ? reduced->residuals_only : renderer->jacobian == NULL;
    function->jacobian_cost = reduced ? reduced->jacobian_cost
        : renderer->jacobian_cost > 0 ? renderer->jacobian_cost
                                      : 1 + 0.25 * n;
    function->lower = o->low;
    function->upper = o->high;
    o->plain = o->leads == n && function->parameter_count == n;
}

/* ---- match: stages --------------------------------------------------------------------------------------------- */

/* Best of n: eq. (4.3), with the caller's candidates as further members of the pool, eq. (4.4). The best `pool_size` go
   to pool, sorted; how many there are. */
static int ms_pme__first_guesses(ms_pme__run *run, ms_pme__objective *o, double *pool, double *pool_value,
                                 int pool_size, ms_pme_match_result *answer)
{
    const ms_pme_renderer *renderer = o->renderer;
    const ms_pme_match_options *options = o->options;
    int n = o->n, variables = run->n,
        total = renderer->prediction_count + options->candidate_count + options->random_count, i, j, kept = 0;
    double *z = pool + pool_size * variables, x[MS_PME_PARAMETERS_MAX];
    answer->best_candidate = -1;
    for (i = 0; (i < total || (i == total && !ms__finite(run->best_value))) && run->status == MS_OK; ++i) {
        double before = run->best_value, value;
        int finite = 1;
        for (j = 0; j < variables;
             ++j) /* the middle of the box; what has no box starts at 0; the nuisance does nothing */
            z[j] = j < o->leads && ms__finite(run->lower[j]) && ms__finite(run->upper[j])
                ? 0.5 * (run->lower[j] + run->upper[j])
                : ms_pme__clip(0, run->lower[j], run->upper[j]);
        for (j = 0; j < n; ++j) x[j] = z[o->place[j]];
        if (i < renderer->prediction_count) {
            ms_pme__fail(run, renderer->predict(renderer->user, i, o->target, x));
        } else if (i < renderer->prediction_count + options->candidate_count) {
            ms_pme__copy(x, options->candidates + (size_t)(i - renderer->prediction_count) * (size_t)n, n);
        } else if (i < total) {
            ms_pme__random_point(run, z, z);
            for (j = 0; j < n; ++j) x[j] = z[o->place[j]];
            for (j = o->leads; j < variables; ++j) z[j] = 0;
        }
        for (j = 0; j < n; ++j) {
            finite &= ms__finite(x[j]);
            if (finite && (options->tie == NULL || options->tie[j] == j))
                z[o->place[j]] = ms_pme__clip(x[j], run->lower[o->place[j]], run->upper[o->place[j]]);
        }
        if (!finite) {
            answer->candidates_refused++;
            continue;
        }
        value = ms_pme__value(run, z);
        if (run->best_value < before) answer->best_candidate = i;
        for (j = kept < pool_size ? kept++ : pool_size; j > 0 && value < pool_value[j - 1]; --j)
            if (j < pool_size) {
                pool_value[j] = pool_value[j - 1];
                ms_pme__copy(pool + j * variables, pool + (j - 1) * variables, variables);
            }
        if (j < pool_size) {
            pool_value[j] = value;
            ms_pme__copy(pool + j * variables, z, variables);
        }
        if (run->stopped && run->status == MS_OK) break;
    }
    answer->cost = run->result.cost;
    return kept;
}

/* Standard deviations of x: noise of the size of the RMSE in every compared value, and each parameter somewhere in its
   box (a variance of range^2 / 12) before the picture was seen. */
static void ms_pme__deviations(ms_pme__run *run, const ms_pme__objective *o, double rmse, double *memory)
{
    ms_pme__walk walk;
    int n = run->n, w = n + 1, j, k, i;
    double sigma = ms_pme__max(rmse, 1e-7 * o->size) / sqrt((double)o->compared), *variance,
           *y; /* no finer than floats are */
    size_t row;
    ms_pme__walk_place(&walk, memory, NULL, n);
    variance = memory + ms_pme__walk_size(n);
    y = variance + n;
    run->stopped = 0;
    run->finishing = 1;
    for (j = 0; j < n; ++j) variance[j] = 0;
    if (ms__finite(ms_pme__linearize(run, run->best, MS_PME__INF))) {
        for (j = 0; j < n; ++j)
            for (row = 0; row < run->m && !(run->lower[j] < run->upper[j]); ++row)
                run->jacobian[row * (size_t)n + (size_t)j] = 0;
        ms_pme__factor(run, &walk);
        for (j = 0; j < n; ++j) {
            double range = run->upper[j] - run->lower[j];
            for (k = 0; k < w; ++k) run->rows[k * MS_PME__ROWS] = 0;
            run->rows[j * MS_PME__ROWS] = !(range > 0) ? 1 : ms__finite(range) ? sqrt(12.0) / range * sigma : 0;
            ms_pme__qr_append(walk.triangle, n, run->rows, 1);
        }
        for (k = 0; k < n; ++k) /* column k of the inverse */
            for (i = k; i >= 0; --i) {
                double t = i == k, pivot = walk.triangle[i * w + i];
                for (j = i + 1; j <= k; ++j) t -= walk.triangle[i * w + j] * y[j];
                y[i] = fabs(pivot) > 0 ? t / pivot : 0;
                variance[i] += y[i] * y[i];
            }
    }
    for (j = 0; j < o->n; ++j) {
        k = o->place[j];
        o->options->deviation[j] = run->lower[k] < run->upper[k] ? sigma * sqrt(variance[k]) : 0;
    }
}

/* What the picture really looks like at the answer: image and RMSE, which a reduced function must agree with. */
static ms_status ms_pme__last_render(ms_pme__run *run, ms_pme__objective *o, ms_pme_match_result *answer,
                                     ms_error *error)
{
    const ms_pme_renderer *renderer = o->renderer;
    size_t i,
        plane = o->options->channels > 1 ? renderer->image_size / (size_t)o->options->channels : renderer->image_size;
    double sum = 0, reduced = ms_pme__shifted(run->best_value, -2 * run->shift) + o->offset;
    int j;
    answer->cost += 1;
    if (ms_pme__fail(run, renderer->render(renderer->user, ms_pme__material(o, run->best), o->image)))
        return ms_pme__why(run, error);
    ms_pme__nuisance(o, run->best, answer->gain, answer->offset);
    for (i = 0; i < renderer->image_size; ++i) {
        double w = o->weight ? (double)o->weight[i] : 1, e;
        if (o->gains + o->offsets > 0)
            o->image[i] = (float)(answer->gain[i / plane] * (double)o->image[i] + answer->offset[i / plane]);
        e = (double)o->image[i] - (double)o->target[i];
        if (w > 0) sum += w * e * e;
    }
    answer->rmse = sqrt(sum / o->weight_sum);
    for (j = 0; j < o->n && o->pulled; ++j) {
        double away = o->x[j] - o->options->source[j];
        reduced -= o->options->pull[j] * away * away;
    }
    reduced = sqrt(ms_pme__max(reduced, 0));
    if (renderer->reduced != NULL && o->gains + o->offsets == 0 &&
        fabs(reduced - answer->rmse) > 1e-3 * answer->rmse + 1e-5 * o->size)
        return ms__fail(
            error, MS_INVALID_ARGUMENT, 0,
            "the reduced function has an RMSE of %g where the picture has %g: it was made for another target or other weights",
            reduced, answer->rmse);
    return MS_OK;
}

/* ---- public: match --------------------------------------------------------------------------------------------- */

MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image, ms_pme_match_result *result,
                              ms_error *error)
{
    ms_pme_match_options defaults = ms_pme_match_defaults();
    ms_pme_options refine;
    ms_pme_match_result answer;
    ms_pme_function function;
    ms_pme__objective o;
    ms_pme__run run;
    void *block = NULL, *pictures = NULL;
    size_t size = 0, bytes, p, jacobian, slopes;
    double *pool, *pool_value, *memory, start[MS_PME__VARIABLES];
    int variables, total, pool_size, kept, j;
    ms_status status;

    /* the function, its bounds and its budget */
    memset(&o, 0, sizeof o);
    memset(&answer, 0, sizeof answer);
    o.renderer = renderer;
    o.options = options != NULL ? options : &defaults;
    o.target = target;
    o.weight = weight;
    status = ms_pme__check_picture(&o, error);
    if (status != MS_OK) return status;
    if (x == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "x is NULL");
    options = o.options;
    p = renderer->image_size;
    ms_pme__objective_make(&o, &function);
    variables = function.parameter_count;
    refine = options->refine;
    if (!(refine.max_cost > 0) && !(refine.max_cost < 0)) refine.max_cost = 50;
    if (function.residuals_only && !(refine.difference_step > 0)) refine.difference_step = 1e-3; /* a float32 picture */
    refine.target_value = ms_pme__max(options->target_rmse * options->target_rmse - o.offset, 0);
    for (j = 0; j < variables; ++j) start[j] = 0;
    status = ms_pme__check(&function, &refine, start, error);
    if (status != MS_OK) return status;

    /* memory: the run; the best first guesses, one picture and, where they are needed, its Jacobian or that of all
       parameters */
    total = renderer->prediction_count + options->candidate_count + options->random_count;
    pool_size = total < 1 ? 1 : total < MS_PME__FIELD ? total : MS_PME__FIELD;
    jacobian = renderer->reduced == NULL || o.gains + o.offsets > 0 ? ms__size_mul(p, (size_t)renderer->parameter_count)
                                                                    : 0;
    slopes = renderer->reduced != NULL && !o.plain ? ms__size_mul(o.m, (size_t)renderer->parameter_count) : 0;
    bytes = ms__size_add(ms__size_mul((size_t)(pool_size + 1) * (size_t)(variables + 1), sizeof(double)),
                         ms__size_mul(slopes, sizeof(double)));
    bytes = ms__size_add(bytes, ms__size_mul(ms__size_add(p, jacobian), sizeof(float)));
    pictures = ms__alloc(&refine.allocator, bytes);
    if (pictures == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a picture of %z values", p);
    status = ms_pme__begin(&run, &function, &refine, &block, &size, error);
    if (status != MS_OK) {
        ms__release(&refine.allocator, pictures, bytes);
        return status;
    }
    pool = (double *)pictures; /* [pool_size + 1][variables], the best first, the last scratch */
    pool_value = pool + (pool_size + 1) * variables;
    o.slopes = pool_value + pool_size + 1;
    o.image = (float *)(void *)(o.slopes + slopes);
    o.jacobian = o.image + p;
    memory = run.scratch + variables;
    run.reserve = 1; /* the last render */
    for (j = 0, run.ranged = 1; j < variables; ++j) run.ranged &= ms__finite(run.upper[j] - run.lower[j]);

    /* first guesses; refinement with a budget of its own; one real render */
    run.max_cost = MS_PME__INF;
    kept = ms_pme__first_guesses(&run, &o, pool, pool_value, pool_size, &answer);
    if (run.status == MS_OK && ms__finite(run.best_value)) {
        answer.rmse_initial = sqrt(ms_pme__max(ms_pme__shifted(run.best_value, -2 * run.shift) + o.offset, 0));
        memset(&run.result, 0, sizeof run.result);
        run.max_cost = refine.max_cost;
        run.result.projected_gradient = -1;
        run.result.value = ms_pme__shifted(run.best_value, -2 * run.shift);
        if (run.stopped) run.result.stop = MS_PME_STOP_TARGET;
        else if (!options->initial_only) ms_pme__method(&run, pool, kept, memory);
        answer.cost += run.result.cost;
        answer.refine = run.result;
        answer.refine.value += o.offset;
    }
    if (run.status != MS_OK) status = ms_pme__why(&run, error);
    else if (!ms__finite(run.best_value))
        status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "no candidate has a finite picture (%g renders)", answer.cost);
    else status = ms_pme__last_render(&run, &o, &answer, error);
    if (status == MS_OK && options->deviation != NULL) ms_pme__deviations(&run, &o, answer.rmse, memory);
    if (status == MS_OK && run.status != MS_OK) status = ms_pme__why(&run, error);
    if (status == MS_OK) {
        ms_pme__copy(x, ms_pme__material(&o, run.best), o.n);
        if (image != NULL) memcpy(image, o.image, p * sizeof *image);
        if (result != NULL) *result = answer;
    }
    ms__release(&refine.allocator, block, size);
    ms__release(&refine.allocator, pictures, bytes);
    return status;
}

MS_API ms_status ms_pme_reweigh(int loss, double scale, size_t count, int channels, const float *image,
                                const float *target, const float *weight, float *reweighted, double *used_scale,
                                ms_error *error)
{
    size_t plane, i, below, compared = 0;
    uint32_t low = 0, high = 0x7f800000u, bits;
    float e;
    int c;
    if (image == NULL || target == NULL || reweighted == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL",
                        image == NULL        ? "image"
                            : target == NULL ? "target"
                                             : "reweighted");
    if (reweighted == weight || reweighted == image || reweighted == target)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "reweighted is weight, image or target, expected memory of its own");
    if (channels < 1 || count < 1 || count % (size_t)channels != 0)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "channels is %d, expected a divisor of count %z", channels,
                        count);
    if (loss != MS_PME_HUBER && loss != MS_PME_TUKEY)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "loss is %d, expected one of ms_pme_loss", loss);
    if (!ms__finite(scale) || scale < 0)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "scale is %g, expected 0 or more", scale);
    plane = count / (size_t)channels;
    for (i = 0; i < plane;
         ++i) { /* the pixel's error, root mean square over what counts of its channels; infinite: nothing does */
        double sum = 0, total = 0;
        for (c = 0; c < channels; ++c) {
            size_t at = i + (size_t)c * plane;
            double w = weight ? (double)weight[at] : 1, d = (double)image[at] - (double)target[at];
            if (!ms__finite(w) || w < 0)
                return ms__fail(error, MS_INVALID_ARGUMENT, at, "weight %z is %g, expected a finite number >= 0", at,
                                w);
            if (w > 0 && !ms__finite(d))
                return ms__fail(error, MS_INVALID_ARGUMENT, at, "image or target %z is not finite", at);
            if (w > 0) sum += w * d * d;
            total += w;
        }
        reweighted[i] = total > 0 ? (float)sqrt(sum / total) : (float)HUGE_VAL;
        compared += total > 0;
    }
    if (scale <= 0 &&
        compared > 0) { /* 1.4826 times the median, found by the bits of positive floats, which sort as they do */
        while (high - low > 1) {
            uint32_t middle = low + (high - low) / 2;
            for (i = below = 0; i < plane; ++i) {
                memcpy(&bits, &reweighted[i], sizeof bits);
                below += bits < middle;
            }
            if (2 * below > compared) high = middle;
            else low = middle;
        }
        memcpy(&e, &low, sizeof e);
        scale = 1.4826 * (double)e;
    }
    if (used_scale != NULL) *used_scale = scale;
    for (i = plane; i-- > 0;) {
        double t = (double)reweighted[i] / (scale > 0 ? scale * (loss == MS_PME_HUBER ? 1.345 : 4.685) : 1), factor = 1;
        if (scale > 0 && ms__finite(t))
            factor = loss == MS_PME_HUBER ? (t > 1 ? 1 / t : 1) : t < 1 ? (1 - t * t) * (1 - t * t) : 0;
        for (c = channels - 1; c >= 0; --c) {
            size_t at = i + (size_t)c * plane;
            reweighted[at] = (float)(factor * (weight ? (double)weight[at] : 1));
        }
    }
    return MS_OK;
}

/* ---- public: sensitivity --------------------------------------------------------------------------------------- */

MS_API ms_status ms_pme_sensitivity(const ms_pme_function *function, const ms_pme_options *options, const double *x,
                                    double *singular_value, double *direction, double *deviation, ms_error *error)
{
    ms_pme_options defaults = ms_pme_defaults(), unlimited;
    ms_pme__run run;
    void *block;
    size_t size;
    double *u, *v, *g;
    int n, i, j, k, sweep, changed = 1;
    ms_status status;
    ms_pme__walk walk;
    if (options == NULL) options = &defaults;
    unlimited = *options;
    unlimited.max_cost = 1e300;
    unlimited.max_seconds = unlimited.target_value = 0;
    status = ms_pme__check(function, &unlimited, x, error);
    if (status != MS_OK) return status;
    if (function->residuals == NULL || singular_value == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL",
                        singular_value == NULL ? "singular_value" : "residuals");
    status = ms_pme__begin(&run, function, &unlimited, &block, &size, error);
    if (status != MS_OK) return status;
    n = run.n;
    ms_pme__walk_place(&walk, run.scratch + n, NULL, n);
    g = walk.g;
    u = walk.scale + n; /* columns of R, stored as rows, and the accumulated rotations */
    v = u + n * n;
    if (!ms__finite(ms_pme__linearize(&run, x, MS_PME__INF)) && run.status == MS_OK &&
        !(run.stopped && run.best_value <= 0))
        run.status = MS_BAD_DATA;
    if (run.status == MS_OK) ms_pme__factor(&run, &walk);
    if (run.status == MS_OK) {
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) {
                u[i * n + j] = j <= i ? walk.triangle[j * (n + 1) + i] : 0;
                v[i * n + j] = i == j;
            }
        /* one-sided Jacobi (Hestenes 1958): small singular values keep their relative accuracy */
        for (sweep = 0; changed && sweep < 60; ++sweep) {
            changed = 0;
            for (i = 0; i < n; ++i)
                for (j = i + 1; j < n; ++j) {
                    double a = ms_pme__dot(u + i * n, u + i * n, n), b = ms_pme__dot(u + j * n, u + j * n, n);
                    double c = ms_pme__dot(u + i * n, u + j * n, n), zeta, t, cosine, sine;
                    if (!(fabs(c) > 1e-15 * sqrt(a * b)) || !(c != 0)) continue;
                    changed = 1;
                    zeta = (b - a) / (2 * c);
                    t = (zeta >= 0 ? 1 : -1) / (fabs(zeta) + sqrt(1 + zeta * zeta));
                    cosine = 1 / sqrt(1 + t * t);
                    sine = cosine * t;
                    ms_pme__rotate(u + i * n, u + j * n, cosine, -sine, n);
                    ms_pme__rotate(v + i * n, v + j * n, cosine, -sine, n);
                }
        }
        for (i = 0; i < n; ++i) { /* largest first; a quarter turn changes places, and a direction's sign */
            int top = i;
            for (j = i, g[i] = -1; j < n; ++j) {
                double s = sqrt(ms_pme__dot(u + j * n, u + j * n, n));
                if (s > g[i]) {
                    g[i] = s;
                    top = j;
                }
            }
            if (top == i) continue;
            ms_pme__rotate(u + i * n, u + top * n, 0, 1, n);
            ms_pme__rotate(v + i * n, v + top * n, 0, 1, n);
        }
        for (j = 0; j < n; ++j) {
            double variance = 0;
            for (k = 0; k < n; ++k) {
                double c = v[k * n + j];
                if (g[k] > 1e-12 * g[0]) variance += c * c / (g[k] * g[k]);
                else if (c * c > 1e-12) variance = MS_PME__INF;
            }
            if (deviation != NULL)
                deviation[j] = variance < MS_PME__INF ? ms_pme__shifted(sqrt(variance), run.shift) : variance;
            singular_value[j] = ms_pme__shifted(g[j], -run.shift);
        }
        if (direction != NULL) ms_pme__copy(direction, v, n * n);
    } else {
        status = run.status == MS_BAD_DATA && run.bad_parameter < 0
            ? ms__fail(error, MS_BAD_DATA, 0, "a residual is not finite")
            : ms_pme__why(&run, error);
    }
    ms__release(&options->allocator, block, size);
    return status;
}

#undef MS_PME__INF
#undef MS_PME__MEMORY
#undef MS_PME__VARIABLES
#undef MS_PME__FIELD
#undef MS_PME__ROWS
#endif /* MS_PME_IMPLEMENTATION */

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
