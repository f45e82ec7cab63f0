/* ms_pme.h - v0.3.0 - from an edited picture to material parameters - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_PME_IMPLEMENTATION
      #include "ms_pme.h"

   You have a renderer phi(x) (a small neural one; ms_nn.h runs such networks) and a target picture that somebody
   painted. This header finds the parameters x inside their bounds whose picture is closest to the target. It evaluates
   your candidates (inversion networks, the previous frame, the source material), keeps the best ones and refines them
   by nonlinear least squares. Link with -lm.

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

   Method
   ------
   Levenberg-Marquardt; each step is a linear least-squares problem inside the box, solved exactly by active sets. It
   reaches the minima of all 14 problems of tests/data/pme_problems.json within 1e-7, and four digits of NIST's
   certified values from all 54 starts. With restarts it is a multistart by successive halving, then from random points.
   Units do not matter: a range may be 1e-200 or 1e200, and residuals any size. Equal bounds freeze a parameter. What
   was done to a picture after it was rendered (exposure, tint) is found by further parameters of a wrapped renderer:
   matcher_light of examples/tools/matcher.h.

   Memory, threads, determinism, errors
   ------------------------------------
   Each call makes one allocation. The stack stays below 32 KB, 64 KB without optimization. There is no global state:
   calls may overlap. Callbacks run on the calling thread, one at a time. The result has the same bits at every call
   with the same seed and the same answers of the callbacks. -ffast-math voids this and the statements about NaN and
   infinity. Failures return a status and a sentence in ms_error. A point whose residuals are NaN, infinite or beyond
   1e300 is worse than every other point, not an error; a derivative that is not finite is MS_BAD_DATA.

   Limits
   ------
   256 parameters; dense Jacobians. The answer is a minimum near one of the candidates; restarts look further. Times and
   errors: tests/bench/RESULTS.md.

   Sources
   -------
   Zsolnai-Feher, Photorealistic Material Learning and Synthesis, chapter 4 (algorithm 4, equations 4.1 to 4.4); More
   1978; Nielsen 1999; Stark and Parker 1995; More, Garbow and Hillstrom 1981.
*/
#ifndef MS_PME_H
#define MS_PME_H
#include <stddef.h>
#include <stdint.h>

#define MS_PME_VERSION_MAJOR 0
#define MS_PME_VERSION_MINOR 3
#define MS_PME_VERSION_PATCH 0
#define MS_PME_VERSION 300 /* major * 10000 + minor * 100 + patch */
#define MS_PME_VERSION_STRING "0.3.0"

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

/* ---- 1. nonlinear least squares -------------------------------------------------------------------------------- */

/* f(x) = sum of r_i(x)^2 over the box lower <= x <= upper. x is always inside the box. A callback returns MS_OK, or a
   status that ends the run and becomes its answer: MS_CANCELLED stops it. */
typedef struct ms_pme_function {
    void *user;
    int parameter_count;   /* n, 1 to MS_PME_PARAMETERS_MAX */
    size_t residual_count; /* m >= 1 */
    /* r [m] out. jacobian [m][n] row-major out, d r_i / d x_j; NULL: not asked for. */
    ms_status (*residuals)(void *user, const double *x, double *r, double *jacobian);
    int residuals_only;          /* non-zero: `residuals` fills no Jacobian; n forward differences take its place, of
                                    steps for double precision (a match: 1e-3 of the range, for pictures of floats) */
    double jacobian_cost;        /* cost of a call with a Jacobian, in evaluations, 1 at least; 0: 1 + n / 4 */
    const double *lower, *upper; /* [n]; NULL: no bound on that side; infinities allowed */
} ms_pme_function;
#define MS_PME_PARAMETERS_MAX 256

typedef enum ms_pme_stop {
    MS_PME_STOP_CONVERGED = 0, /* the step or the decrease fell below its tolerance, or f is 0 */
    MS_PME_STOP_COST = 1,      /* max_cost spent */
    MS_PME_STOP_INITIAL = 2    /* a match with initial_only: nothing was refined */
} ms_pme_stop;

/* All zero gives the defaults; ms_pme_defaults() returns that. */
typedef struct ms_pme_options {
    double max_cost;  /* in evaluations, never exceeded; 0: 1000, or 20 steps if these cost more (a match: 50, or 8) */
    double tolerance; /* relative decrease and relative step taken as converged; 0: 1e-10 */
    int restarts;     /* further starts while cost is left; one that does not improve ends at a loose tolerance */
    uint64_t seed;    /* of the random starts */
    ms_allocator allocator; /* one block of about (m n + 2 m + 2 n^2) doubles, released before the call returns */
} ms_pme_options;

typedef struct ms_pme_result {
    double value;       /* f at x */
    double cost;        /* spent, in evaluations */
    size_t evaluations; /* calls without derivatives */
    size_t jacobians;   /* calls with them */
    size_t steps;       /* accepted ones, of all starts; 0: too small a budget or a minimum (stop says which) */
    ms_pme_stop stop;
} ms_pme_result;

MS_API ms_pme_options ms_pme_defaults(void);

/* Minimizes f from a start.
   x        [n] in: start, finite (clipped to the box first); out: the best point that was evaluated
   options  NULL: defaults
   result   out, may be NULL
   error    may be NULL; position is the index of the offending parameter
   MS_INVALID_ARGUMENT: a count or callback is missing or out of range, lower > upper or NaN, x not finite, no finite
   value at the start, a budget below the first derivatives' cost. MS_BAD_DATA: a derivative is not finite at a point
   whose value is. MS_OUT_OF_MEMORY, or the status of a callback. Outputs are untouched on failure. A budget that ended
   the run is no failure (result->stop). */
MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error);

/* ---- 2. which material made this picture? ---------------------------------------------------------------------- */

/* The picture phi(x) is image_size floats in any order. Thesis, chapter 4. */
typedef struct ms_pme_renderer {
    void *user;
    int parameter_count;         /* n */
    size_t image_size;           /* p: pixels times channels */
    const double *lower, *upper; /* [n] of finite ranges; NULL: all 0, all 1 */
    /* phi(x) -> image [p] */
    ms_status (*render)(void *user, const double *x, float *image);
    /* Optional: image and d image_i / d x_j as [p][n]. Floats: for ranges of 1e-30 to 1e30. */
    ms_status (*jacobian)(void *user, const double *x, float *image, float *jacobian);
    double jacobian_cost; /* in renders, 1 at least; 0: 1 + n / 4 */
    /* Optional: inversion network i of prediction_count, target [p] -> x [n]; values outside the box are clipped. */
    int prediction_count;
    ms_status (*predict)(void *user, int i, const float *target, double *x);
    /* Optional: a smaller function of the same n parameters, made for this target and these weights (ms_nn.h's
       collapse), whose sum of squares is that of weight (phi - target)^2. It replaces `render` and `jacobian` except
       for one last call of `render`, which verifies the RMSE. Its bounds are not read. */
    const ms_pme_function *reduced;
} ms_pme_renderer;

MS_API ms_pme_renderer ms_pme_renderer_defaults(void); /* all zero */

typedef struct ms_pme_match_options {
    ms_pme_options refine;    /* max_cost is spent after the candidates */
    int initial_only;         /* non-zero: the best candidate is the answer */
    const double *candidates; /* [candidate_count][n]: the previous frame's answer, the source material; may be NULL */
    int candidate_count;
    int random_count;     /* further ones, uniform in the box. The middle is tried if none has a finite picture */
    const double *source; /* [n] center of the pulls */
    const double *pull;   /* [n] >= 0: pull (x_j - source_j)^2 is added to RMSE^2; NULL: none */
    double *deviation;    /* [n] out, or NULL: standard deviations of x for independent errors of the size of the RMSE;
                             0 where bounds are equal, about 0.29 of the range (uniform) if the picture does not
                             determine x_j */
} ms_pme_match_options;

typedef struct ms_pme_match_result {
    double rmse;          /* weighted, in the image's unit, from one real render of x */
    double rmse_initial;  /* of the best candidate */
    int best_candidate;   /* predictions come first, then `candidates`, then random ones (or the middle) */
    ms_pme_result refine; /* without the candidates; value: RMSE^2 and the pulls; stop: of the whole match */
    double cost;          /* in renders: candidates, refinement, the last render; not predictions and deviations */
} ms_pme_match_result;

MS_API ms_pme_match_options ms_pme_match_defaults(void); /* all zero */

/* Best of n candidates, then refinement (thesis, algorithm 4, eq. 4.1 to 4.4).
   target   [p], finite where the weight is not 0
   weight   [p] >= 0, or NULL: all 1. RMSE^2 = sum w (phi - t)^2 / sum w
   x        [n] out: the material
   image    [p] out: phi(x), or NULL
   MS_INVALID_ARGUMENT: as ms_pme_minimize; a target that is not finite, a negative or non-finite weight (position: its
   index), weights that are all 0, no candidate with a finite picture, a reduced function of another target or other
   weights (RMSE off by a thousandth and 1e-5 of the target's root mean square).
   MS_OUT_OF_MEMORY, or the status of a callback. Outputs are untouched on failure: x, image, deviation, result. */
MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image, ms_pme_match_result *result,
                              ms_error *error);

#ifdef __cplusplus
}
#endif
#endif /* MS_PME_H */

#if defined(MS_PME_IMPLEMENTATION) && !defined(MS_PME_IMPLEMENTED)
#define MS_PME_IMPLEMENTED /* included again, it is declarations only */
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

/* Contents: small maths | the run | bounded least squares | Levenberg-Marquardt | multistart | minimize | match */

#include <float.h>
#include <limits.h>
#include <math.h>

/* ---- small maths ----------------------------------------------------------------------------------------------- */

#define MS_PME__INF ((double)HUGE_VAL)
enum {
    MS_PME__SOLVERS = 16, /* local solvers at a time, and candidates that a match keeps, at most */
    MS_PME__ROWS = 32,    /* rows of the Jacobian that one QR update takes: they stay in the cache */
    MS_PME__TOGETHER = 20 /* rounds of a bounded problem before it is taken one parameter at a time */
};

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

static double ms_pme__clip(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

static double ms_pme__max(double a, double b) { return a > b ? a : b; }

static void ms_pme__copy(double *to, const double *from, int n) { memcpy(to, from, (size_t)n * sizeof *to); }

/* Folds k rows into the upper triangle r [n + 1][n + 1] by Householder reflections of (r_jj, column j): the R of a QR
   factorization, block of rows by block of rows (TSQR). The rows are stored as columns [n + 1][ROWS], the right-hand
   side last, and are destroyed. */
static void ms_pme__qr_append(double *r, int n, double *columns, int k)
{
    int w = n + 1, i, j, l;
    for (j = 0; j <= n; ++j) {
        double *column = columns + j * MS_PME__ROWS, *top = r + j * w, largest = 0, norm, head, beta;
        for (i = 0; i < k; ++i) largest = ms_pme__max(largest, fabs(column[i]));
        if (!(largest > 1e-140)) continue; /* columns are of size 1: zeros, or rounding whose square underflows */
        largest = ms_pme__max(largest, fabs(top[j]));
        norm = (top[j] / largest) * (top[j] / largest);
        for (i = 0; i < k; ++i) norm += (column[i] / largest) * (column[i] / largest);
        norm = (top[j] > 0 ? -largest : largest) * sqrt(norm);
        head = top[j] - norm; /* v = (head, column), |v|^2 = -2 norm head */
        beta = 1 / (norm * head);
        for (i = j + 1; i <= n; ++i) {
            double *other = columns + i * MS_PME__ROWS;
            double t = beta * (head * top[i] + ms_pme__dot(column, other, k));
            top[i] += t * head;
            for (l = 0; l < k; ++l) other[l] += t * column[l];
        }
        top[j] = norm;
    }
}

/* Random numbers by splitmix64 (Steele, Lea, Flood 2014): integers only, so the same on any machine. */
static uint64_t ms_pme__random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Uniform in the open interval (0, 1), in steps of 2^-52: never 0, never 1. */
static double ms_pme__uniform(uint64_t *state) { return ((double)(ms_pme__random(state) >> 12) + 0.5) * DBL_EPSILON; }

/* |v|: infinite if an element is not finite or beyond 1e300. Neither overflows nor underflows on the way. */
static double ms_pme__norm(const double *v, size_t count)
{
    double largest = 0, unit, sum = 0;
    size_t i;
    for (i = 0; i < count; ++i) {
        if (!ms__finite(v[i])) return MS_PME__INF;
        largest = ms_pme__max(largest, fabs(v[i]));
    }
    if (!(largest > 0) || largest > 1e300) return largest > 0 ? MS_PME__INF : 0;
    unit = largest < 1e-140 || largest > 1e140 ? largest : 1;
    for (i = 0; i < count; ++i) sum += (v[i] / unit) * (v[i] / unit);
    return unit * sqrt(sum);
}

/* x^2 as far as doubles reach. */
static double ms_pme__square(double x)
{
    const double bounded = fmin(fabs(x), 1e154); /* a compiler may multiply before it asks: no trap then either */
    return bounded < 1e154 ? bounded * bounded : MS_PME__INF;
}

/* ---- the run --------------------------------------------------------------------------------------------------- */

/* A start, or a local solver between two steps. Derivatives belong to the run: a step begins with them. */
typedef struct ms_pme__solver {
    double *x;     /* [n] the last accepted point */
    double norm;   /* |r| there */
    double lambda; /* 0 before the first step */
    int done;      /* converged, or not finite */
    int index;     /* of a candidate */
} ms_pme__solver;

/* Points are compared by |r|, whose square f may underflow. Arrays without a size here are in the block. */
typedef struct ms_pme__run {
    const ms_pme_function *function;
    const ms_pme_options *options;
    int n;
    size_t m;
    int match; /* all parameters have a range, and differences are of pictures of floats */
    double max_cost, tolerance, derivatives_cost;
    double low[MS_PME_PARAMETERS_MAX], high[MS_PME_PARAMETERS_MAX];
    double best[MS_PME_PARAMETERS_MAX], best_norm; /* the best point, and |r| there */
    double typical[MS_PME_PARAMETERS_MAX];         /* the range of a parameter, else the size of its start */
    double moved[MS_PME_PARAMETERS_MAX];           /* x of a difference */
    double *residual;                              /* [m] at the point of the Jacobian */
    double *trial_residual;                        /* [m] at the last other point */
    const double *trial;                           /* the accepted point whose residuals these are, or NULL */
    double *jacobian;                              /* [m][n] */
    double unit[MS_PME_PARAMETERS_MAX];   /* largest magnitude in a column of the Jacobian; 1 for a zero column */
    double *triangle;                     /* [n + 1][n + 1] R of J / unit, and Q'(-r) / |r| */
    double column[MS_PME_PARAMETERS_MAX]; /* norms of its columns: between 1 and sqrt(m), or 0 */
    double scale[MS_PME_PARAMETERS_MAX];  /* of the trust region: a norm of a column of J */
    double weight[MS_PME_PARAMETERS_MAX]; /* that in y */
    double *work;                         /* workspace of one step */
    ms_pme__solver solvers[MS_PME__SOLVERS + 1]; /* the last one is workspace */
    ms_pme_result result;
    int stopped;   /* by the budget, a failure or f = 0: no callback follows */
    int uncharged; /* evaluations for the standard deviations: outside the budget, and never the best point */
    ms_status status;
    int bad;         /* 1 + the parameter by which a derivative is not finite, or 0 */
    uint64_t random; /* state of the generator */
    void *block;     /* the memory of the arrays, and its size */
    size_t block_size;
} ms_pme__run;

/* Ends the run if the status is a failure; non-zero then. */
static int ms_pme__fail(ms_pme__run *run, ms_status status)
{
    if (status == MS_OK) return 0;
    run->status = status;
    return run->stopped = 1;
}

/* |r(x)|, with the Jacobian at x or without: charges the budget, keeps the best point and stops at 0. Infinite if the
   run had stopped before. */
static double ms_pme__evaluate(ms_pme__run *run, const double *x, int derivatives)
{
    const double cost = run->uncharged ? 0 : derivatives ? run->derivatives_cost : 1;
    double *r = derivatives ? run->residual : run->trial_residual, norm;
    if (run->stopped) return MS_PME__INF;
    if (run->result.cost + cost > run->max_cost * (1 + 1e-12)) {
        run->result.stop = MS_PME_STOP_COST;
        run->stopped = 1;
        return MS_PME__INF;
    }
    run->result.cost += cost;
    if (derivatives) run->result.jacobians++;
    else run->result.evaluations++;
    run->trial = NULL;
    if (ms_pme__fail(run, run->function->residuals(run->function->user, x, r, derivatives ? run->jacobian : NULL)))
        return MS_PME__INF;
    norm = ms_pme__norm(r, run->m);
    if (run->uncharged) return norm;
    if (norm < run->best_norm) {
        run->best_norm = norm;
        ms_pme__copy(run->best, x, run->n);
    }
    run->stopped = !(norm > 0); /* converged */
    return norm;
}

/* Column j of the Jacobian at x by a forward difference inside the box; to the other side if that is not finite. */
static void ms_pme__difference(ms_pme__run *run, const double *x, int j)
{
    const double typical = run->typical[j], above = run->high[j] - x[j], below = x[j] - run->low[j];
    double h, value = MS_PME__INF, *column = run->jacobian + j;
    int side;
    size_t i;
    if (run->match) h = 1e-3 * typical;
    else h = 1.5e-8 * ms_pme__max(fabs(x[j]), 1e-2 * typical); /* sqrt(DBL_EPSILON) */
    if (!(h > 1e-15 * fabs(x[j]))) h = 1e-15 * fabs(x[j]) + DBL_MIN;
    if (h > above && below > above) h = -h;
    for (side = 0; side < 2 && !ms__finite(value); ++side) {
        ms_pme__copy(run->moved, x, run->n);
        run->moved[j] = ms_pme__clip(side == 0 ? x[j] + h : x[j] - h, run->low[j], run->high[j]);
        h = run->moved[j] - x[j];
        if (!(h < 0) && !(h > 0)) break;
        value = ms_pme__evaluate(run, run->moved, 0);
    }
    for (i = 0; i < run->m; ++i, column += run->n)
        *column = h < 0 || h > 0 ? (run->trial_residual[i] - run->residual[i]) / h : 0;
}

/* The linear model at x: the triangle and the norms of its columns, of size 1 whatever the units of x and r are.
   Returns |r|, infinite if there is no model. */
static double ms_pme__linearize(ms_pme__run *run, const double *x)
{
    const int n = run->n, w = n + 1;
    double norm, *rows = run->work; /* [n + 1][ROWS] of J and r, as columns */
    size_t row;
    int i, j;

    /* r and J */
    if (!run->function->residuals_only) {
        norm = ms_pme__evaluate(run, x, 1);
    } else {
        norm = run->trial == x ? ms_pme__norm(run->trial_residual, run->m) : ms_pme__evaluate(run, x, 0);
        memcpy(run->residual, run->trial_residual, run->m * sizeof(double));
        for (j = 0; j < n && ms__finite(norm) && !run->stopped; ++j) ms_pme__difference(run, x, j);
    }
    if (run->stopped || !ms__finite(norm)) return MS_PME__INF;

    /* the units of the columns */
    memset(run->unit, 0, sizeof run->unit);
    for (row = 0; row < run->m; ++row)
        for (j = 0; j < n; ++j) {
            const double slope = run->jacobian[row * (size_t)n + (size_t)j];
            if (ms__finite(slope)) run->unit[j] = ms_pme__max(run->unit[j], fabs(slope));
            else if (run->bad == 0) run->bad = j + 1;
        }
    if (run->bad != 0) {
        ms_pme__fail(run, MS_BAD_DATA);
        return MS_PME__INF;
    }
    for (j = 0; j < n; ++j)
        if (!(run->unit[j] > 0)) run->unit[j] = 1;

    /* R and Q'(-r), and what follows from them */
    memset(run->triangle, 0, (size_t)(w * w) * sizeof(double));
    for (row = 0; row < run->m;) {
        int k = run->m - row < MS_PME__ROWS ? (int)(run->m - row) : MS_PME__ROWS;
        for (i = 0; i < k; ++i, ++row) {
            const double *from = run->jacobian + row * (size_t)n;
            for (j = 0; j < n; ++j) rows[j * MS_PME__ROWS + i] = from[j] / run->unit[j];
            rows[n * MS_PME__ROWS + i] = norm > 0 ? -run->residual[row] / norm : 0;
        }
        ms_pme__qr_append(run->triangle, n, rows, k);
    }
    for (j = 0; j < n; ++j) {
        double square = 0;
        for (i = 0; i <= j; ++i) square += run->triangle[i * w + j] * run->triangle[i * w + j];
        run->column[j] = sqrt(square);
    }
    return norm;
}

/* ---- bounded least squares ------------------------------------------------------------------------------------- */

/* z_j of the free parameters, those of state 0, minimizes |R z - b|^2 + sum (weight_j z_j)^2 with the others at d.
   triangle [n][n + 1]: R, b. work: [n + 1][n + 1], then rows as columns [n + 1][ROWS]. */
static void ms_pme__solve_free(const double *triangle, int n, const double *weight, const int *state, const double *d,
                               double *z, double *work)
{
    int order[MS_PME_PARAMETERS_MAX], count = 0, filled = 0, w = n + 1, row, i, j;
    double *rows = work + w * w, t;
    for (j = 0; j < n; ++j)
        if (state[j] == 0) order[count++] = j;
    memset(work, 0, (size_t)((count + 1) * (count + 1)) * sizeof *work);
    for (row = 0; row < n + count; ++row) { /* those of R less what is at bounds, then those of the weights */
        const double *from = triangle + (row < n ? row : 0) * w;
        for (j = 0; j < count; ++j)
            rows[j * MS_PME__ROWS + filled] = row < n ? from[order[j]] : row - n == j ? weight[order[j]] : 0;
        t = row < n ? from[n] : 0;
        for (j = row; j < n; ++j) t -= state[j] != 0 ? from[j] * d[j] : 0;
        rows[count * MS_PME__ROWS + filled++] = t;
        if (filled < MS_PME__ROWS && row + 1 < n + count) continue;
        ms_pme__qr_append(work, count, rows, filled);
        filled = 0;
    }
    for (i = count; i-- > 0;) {
        const double *from = work + i * (count + 1);
        for (t = from[count], j = i + 1; j < count; ++j) t -= from[j] * z[order[j]];
        z[order[i]] = fabs(from[i]) > 0 ? t / from[i] : 0;
    }
}

/* d [n] minimizes |R d - b|^2 + sum (weight_j d_j)^2 over low <= d <= high, low <= 0 <= high: the active-set method of
   Stark and Parker (1995), finite and exact; each set is a QR factorization. To need few of them, it begins with
   rounds in which all parameters that should change sides do so together. state in: a guess of the active set (0 free,
   -1 at low, 1 at high); out: the active set. z [n]; the others as above. Returns |b|^2 - |R d - b|^2. */
static double ms_pme__bounded_least_squares(const double *triangle, int n, const double *weight, const double *low,
                                            const double *high, double *d, int *state, double *z, double *work)
{
    int w = n + 1, released = -1, round, i, j;
    double decrease = 0, *rest = z, *size = work; /* b - R d, and the size of its terms */
    for (j = 0; j < n; ++j) d[j] = state[j] < 0 ? low[j] : state[j] > 0 ? high[j] : 0;
    for (round = 0; round < 4 * n + 8 + MS_PME__TOGETHER; ++round) {
        const int together = round < MS_PME__TOGETHER;
        double alpha = 1, steepest = 0;
        int hit = -1, freed = -1;
        ms_pme__solve_free(triangle, n, weight, state, d, z, work);

        /* towards z: as far as the first bound, or across all of them */
        for (j = 0; j < n; ++j) {
            const double way = z[j] - d[j], t = way < 0 ? (low[j] - d[j]) / way : way > 0 ? (high[j] - d[j]) / way : 1;
            if (state[j] != 0 || (z[j] >= low[j] && z[j] <= high[j])) continue;
            if (hit < 0 || t < alpha) hit = j;
            if (!together && t < alpha) alpha = ms_pme__max(t, 0);
        }
        for (j = 0; j < n; ++j) {
            if (state[j] != 0) continue;
            d[j] = ms_pme__clip(d[j] + alpha * (z[j] - d[j]), low[j], high[j]);
            if (together || j == hit) state[j] = z[j] < low[j] ? -1 : z[j] > high[j] ? 1 : 0;
            if (state[j] != 0) d[j] = state[j] < 0 ? low[j] : high[j];
        }
        if (hit >= 0 && hit == released && !(alpha > 1e-12)) break; /* rounding frees it again and again */
        released = -1;
        if (hit >= 0) continue;

        /* the multipliers of the active bounds: the most negative one is freed, or all such */
        for (decrease = 0, i = 0; i < n; ++i) {
            const double *row = triangle + i * w, moved = ms_pme__dot(row + i, d + i, n - i);
            rest[i] = row[n] - moved;
            decrease += moved * (2 * row[n] - moved);
            for (size[i] = fabs(row[n]), j = i; j < n; ++j) size[i] += fabs(row[j] * d[j]);
        }
        for (j = 0; j < n; ++j) {
            double slope = -weight[j] * weight[j] * d[j], terms = fabs(slope), push;
            if (state[j] == 0 || !(low[j] < high[j])) continue;
            for (i = 0; i <= j; ++i) {
                slope += triangle[i * w + j] * rest[i];
                terms += fabs(triangle[i * w + j]) * size[i];
            }
            push = -state[j] * slope;
            if (!(push > 1e-14 * terms) || (!together && push <= steepest)) continue;
            steepest = push;
            freed = j;
            if (together) state[j] = 0;
        }
        if (freed < 0) break;
        released = freed;
        state[freed] = 0;
    }
    return decrease;
}

/* ---- Levenberg-Marquardt --------------------------------------------------------------------------------------- */

/* The linear model at the solver's point and the scale of its trust region: the present column norms, or what is left
   of larger ones, 0.7 a step: 1 is More 1978's, which columns that shrink by many orders defeat (MGH10 of NIST); small
   values forget scales that are still needed. In a match: the present column norm, at least 0.3 of the largest (both
   for a step across the range), so that parameters with little effect do not run off to their bounds. */
static void ms_pme__solver_linearize(ms_pme__run *run, ms_pme__solver *solver)
{
    double largest = 0;
    int j;
    if (!(solver->lambda > 0)) solver->lambda = 1e-3;
    solver->norm = ms_pme__linearize(run, solver->x);
    solver->done = !ms__finite(solver->norm);
    for (j = 0; j < run->n && run->match; ++j)
        largest = ms_pme__max(largest, (run->high[j] - run->low[j]) * run->unit[j] * run->column[j]);
    for (j = 0; j < run->n && !solver->done; ++j) {
        double range = run->high[j] - run->low[j], least = 0.7 * run->scale[j], weight;
        if (run->match) least = range > 0 ? 0.3 * largest / range : 0;
        run->scale[j] = ms_pme__max(run->unit[j] * run->column[j], least);
        weight = run->scale[j] > 0 ? run->scale[j] / run->unit[j] : 1;
        run->weight[j] = weight < 1e100 ? weight : 1e100; /* its square is a number */
    }
}

/* One step: derivatives, then trials until one is accepted, the solver is done or the run has stopped. A trial solves
   the damped problem in the box, in y = unit x / |r|; the damping follows the ratio of actual to predicted decrease
   (Nielsen 1999). After a trial that is not finite the next one takes a quarter of its step at most, so that it does
   not land on the same plateau (BoxBOD of NIST). */
static void ms_pme__solver_step(ms_pme__run *run, ms_pme__solver *solver)
{
    int n = run->n, j, state[MS_PME_PARAMETERS_MAX];
    double *trial = run->work, *d = trial + n, *low = d + n, *high = low + n, *z = high + n, *damping = z + n,
           *work = damping + n, *x = solver->x, longest = MS_PME__INF, growth = 2;
    ms_pme__solver_linearize(run, solver);
    while (!solver->done && !run->stopped) {
        double predicted, decrease, norm, t, step = 0, size = 0;
        int finite = 1;

        /* the damped problem: its solution d, and the bounds that it is at; first those of x */
        for (j = 0; j < n; ++j) {
            low[j] = (run->low[j] - x[j]) * run->unit[j] / solver->norm;
            high[j] = (run->high[j] - x[j]) * run->unit[j] / solver->norm;
            damping[j] = sqrt(solver->lambda) * run->weight[j];
            state[j] = low[j] >= 0 ? -1 : high[j] <= 0;
        }
        predicted = ms_pme__bounded_least_squares(run->triangle, n, damping, low, high, d, state, z, work);

        /* the trial, and the lengths of step and point in the metric of the trust region */
        for (j = 0; j < n; ++j) {
            if (state[j] != 0) trial[j] = state[j] < 0 ? run->low[j] : run->high[j];
            else trial[j] = ms_pme__clip(x[j] + d[j] * solver->norm / run->unit[j], run->low[j], run->high[j]);
            finite &= ms__finite(trial[j]);
            step += ms_pme__square(run->weight[j] * d[j]);
            size += ms_pme__square(run->weight[j] * (x[j] * run->unit[j] / solver->norm));
        }
        if (!(predicted > 1e-15) || step <= 1e-30 * size || !(solver->lambda < 1e60)) {
            solver->done = 1; /* rounding would swallow any further decrease */
            break;
        }

        /* accepted, if f decreases by a ten-thousandth of what the model promises */
        if (step <= longest && finite) {
            norm = ms_pme__evaluate(run, trial, 0);
            decrease = ms__finite(norm) ? (1 - norm / solver->norm) * (1 + norm / solver->norm) : -1;
            if (decrease > 1e-4 * predicted) {
                solver->done = (decrease <= run->tolerance && predicted <= run->tolerance) ||
                    step <= run->tolerance * run->tolerance * size;
                t = 2 * decrease / predicted - 1;
                solver->lambda = ms_pme__max(solver->lambda * ms_pme__max(0.1, 1 - t * t * t), 1e-16);
                ms_pme__copy(x, trial, n);
                solver->norm = norm;
                run->trial = x;
                run->result.steps++;
                break;
            }
            if (!ms__finite(norm)) longest = step / 16;
        }
        solver->lambda *= growth;
        growth *= 2;
    }
}

/* ---- multistart ------------------------------------------------------------------------------------------------ */

/* Moves the last solver up to its place by |r|. */
static void ms_pme__rank(ms_pme__solver *solvers, int last)
{
    for (; last > 0 && solvers[last].norm < solvers[last - 1].norm; --last) {
        ms_pme__solver better = solvers[last];
        solvers[last] = solvers[last - 1];
        solvers[last - 1] = better;
    }
}

static void ms_pme__solver_iterate(ms_pme__run *run, ms_pme__solver *solver, int steps)
{
    memset(run->scale, 0, sizeof run->scale);
    while (steps-- > 0 && !solver->done && !run->stopped) ms_pme__solver_step(run, solver);
}

/* Uniform in the box (a side without a bound ends max(|center|, typical) away from the center), or in one of that size
   around the center. */
static void ms_pme__random_point(ms_pme__run *run, const double *center, int around, double *x)
{
    int j;
    for (j = 0; j < run->n; ++j) {
        double reach = ms_pme__max(fabs(center[j]), run->typical[j]), u = ms_pme__uniform(&run->random);
        double low = ms__finite(run->low[j]) ? run->low[j] : center[j] - reach;
        double high = ms__finite(run->high[j]) ? run->high[j] : center[j] + reach;
        x[j] = around ? center[j] + (u - 0.5) * (high - low) : (1 - u) * low + u * high;
        x[j] = ms_pme__clip(x[j], run->low[j], run->high[j]);
    }
}

/* Levenberg-Marquardt from the first `count` solvers' points, the best first, with restarts + 1 starts at most.
   Successive halving: start (budget in steps) / 5 solvers, keep the best third every 3 steps, finish the winner. While
   cost is left: the other starts at a loose tolerance, finished if they improve; then random points, every second one
   around the best. */
static void ms_pme__multistart(ms_pme__run *run, int count)
{
    ms_pme__solver *solvers = run->solvers;
    const int64_t restarts = run->options->restarts;
    const int given = restarts < count ? (int)restarts + 1 : count;
    const double tolerance = run->tolerance, steps = (run->max_cost - run->result.cost) / (1 + run->derivatives_cost);
    int64_t start;
    int i, alive;
    for (alive = steps / 5 < given ? (int)(steps / 5) : given; alive > 1; alive = alive > 3 ? (alive + 2) / 3 : 1) {
        for (i = 0; i < alive; ++i) ms_pme__solver_iterate(run, &solvers[i], 3);
        for (i = 1; i < alive; ++i) ms_pme__rank(solvers, i);
    }
    for (start = 0; start <= restarts && !run->stopped; ++start) {
        const double best = run->best_norm;
        ms_pme__solver *next = &solvers[start < given ? (int)start : given - 1];
        if (start >= given) {
            ms_pme__random_point(run, run->best, start % 2 == 0 && run->match, next->x);
            next->lambda = 0;
            next->done = 0;
        }
        if (start > 0) run->tolerance = ms_pme__max(tolerance, 1e-3);
        ms_pme__solver_iterate(run, next, INT_MAX);
        run->tolerance = tolerance;
        if (start > 0 && run->best_norm < best && ms__finite(next->norm)) {
            next->done = 0;
            ms_pme__solver_iterate(run, next, INT_MAX);
        }
    }
    run->result.value = ms_pme__square(run->best_norm);
}

/* ---- minimize -------------------------------------------------------------------------------------------------- */

static ms_status ms_pme__null(const char *name, ms_error *error)
{
    return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", name);
}

/* Non-zero, and the sentence, if the value is not one from low to high. */
static int ms_pme__outside(const char *name, double value, double low, double high, ms_error *error)
{
    if (value >= low && value <= high) return 0;
    return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is %g, expected %g to %g", name, value, low, high) != MS_OK;
}

/* A match beside its run. f is RMSE^2, from the picture or the reduced function, and the pulls: one residual each. */
typedef struct ms_pme__objective {
    ms_pme_function function;
    const ms_pme_renderer *renderer;
    const ms_pme_match_options *options;
    const float *target, *weight;
    double weight_sum, size; /* size: root mean square of the target */
    size_t m, compared;      /* residuals without pulls; values with a weight */
    int n, given, total;     /* parameters; candidates: predicted and the caller's, with the random ones */
    float *image, *jacobian; /* [p], [p][n] */
} ms_pme__objective;

/* The one block of memory: arrays of a run, and of a match (o, or NULL). */
static ms_status ms_pme__allocate(ms_pme__run *run, ms_pme__objective *o, ms_error *error)
{
    const size_t n = (size_t)run->n, m = run->m, points = n * (MS_PME__SOLVERS + 1), square = (n + 1) * (n + 1),
                 step = 6 * n + (n + 1) * (n + 1 + MS_PME__ROWS), pixels = o ? o->renderer->image_size : 0,
                 slopes = o && !o->renderer->reduced ? n : 0;
    size_t i, doubles = ms__size_add(ms__size_mul(m, n + 2), points + square + step);
    run->block_size = ms__size_add(ms__size_mul(doubles, sizeof(double)),
                                   ms__size_mul(ms__size_mul(pixels, 1 + slopes), sizeof(float)));
    run->block = ms__alloc(&run->options->allocator, run->block_size);
    if (run->block == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z residuals times %d parameters", m, run->n);
    run->jacobian = (double *)run->block;
    run->residual = run->jacobian + m * n;
    run->trial_residual = run->residual + m;
    run->triangle = run->trial_residual + m;
    run->work = run->triangle + square;
    for (i = 0; i <= MS_PME__SOLVERS; ++i) run->solvers[i].x = run->work + step + i * n;
    if (o == NULL) return MS_OK;
    o->image = (float *)(run->work + step + points);
    o->jacobian = o->image + pixels;
    return MS_OK;
}

/* Checks and sets up a run; its block is to be released. x: the start, or NULL. o: the match, or NULL. */
static ms_status ms_pme__begin(ms_pme__run *run, const ms_pme_function *function, const ms_pme_options *options,
                               const double *x, ms_pme__objective *o, ms_error *error)
{
    const int n = function->parameter_count;
    double start;
    int j;
    if (function->residuals == NULL) return ms_pme__null("function->residuals", error);
    if (ms_pme__outside("parameter_count", n, 1, MS_PME_PARAMETERS_MAX, error) ||
        ms_pme__outside("residual_count", (double)function->residual_count, 1, (double)SIZE_MAX, error) ||
        ms_pme__outside("max_cost", options->max_cost, 0, 1e300, error) ||
        ms_pme__outside("tolerance", options->tolerance, 0, 1e300, error) ||
        ms_pme__outside("restarts", options->restarts, 0, INT_MAX, error) ||
        ms_pme__outside("jacobian_cost", function->jacobian_cost, 0, 1e300, error))
        return MS_INVALID_ARGUMENT;
    memset(run, 0, sizeof *run);
    run->function = function;
    run->options = options;
    run->n = n;
    run->m = function->residual_count;
    run->match = o != NULL;
    for (j = 0; j < n; ++j) {
        const double low = function->lower ? function->lower[j] : o ? 0 : -MS_PME__INF;
        const double high = function->upper ? function->upper[j] : o ? 1 : MS_PME__INF;
        if (!(low <= high) || !(low < MS_PME__INF) || !(high > -MS_PME__INF) || (o != NULL && !ms__finite(high - low)))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j,
                            "bounds of parameter %d are %g and %g: no %s between them", j, low, high,
                            o != NULL ? "finite range" : "number");
        if (x && !ms__finite(x[j]))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j,
                            "start of parameter %d is %g, expected a finite number", j, x[j]);
        start = x != NULL ? ms_pme__clip(x[j], low, high) : 0;
        run->typical[j] = ms__finite(high - low) ? high - low : fabs(start) > 0 ? fabs(start) : 1;
        run->low[j] = low;
        run->high[j] = high;
    }
    run->tolerance = options->tolerance > 0 ? options->tolerance : 1e-10;
    run->derivatives_cost = function->jacobian_cost > 0 ? ms_pme__max(function->jacobian_cost, 1) : 1 + 0.25 * n;
    if (function->residuals_only) run->derivatives_cost = n;
    run->max_cost = o != NULL ? ms_pme__max(50, 8 * (1 + run->derivatives_cost))
                              : ms_pme__max(1000, 20 * (1 + run->derivatives_cost));
    if (options->max_cost > 0) run->max_cost = options->max_cost;
    run->best_norm = MS_PME__INF;
    run->random = options->seed;
    run->random = ms_pme__random(&run->random); /* seeds that follow each other start apart */
    return ms_pme__allocate(run, o, error);
}

/* MS_OK, or the status of a run that failed, and its sentence. */
static ms_status ms_pme__verdict(const ms_pme__run *run, ms_error *error)
{
    double cost = run->result.cost;
    const int bad = run->bad - 1;
    if (bad >= 0) return ms__fail(error, MS_BAD_DATA, (size_t)bad, "a derivative by parameter %d is not finite", bad);
    if (run->status != MS_OK) return ms__fail(error, run->status, 0, "a callback failed after %g evaluations", cost);
    if (ms__finite(run->best_norm)) return MS_OK;
    if (run->match)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "no candidate has a finite picture (%g renders)", cost);
    if (!(cost > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "max_cost is %g: the first derivatives cost %g", run->max_cost,
                        run->derivatives_cost);
    return ms__fail(error, MS_INVALID_ARGUMENT, 0, "no finite value within %g evaluations of the start", cost);
}

MS_API ms_pme_options ms_pme_defaults(void)
{
    ms_pme_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error)
{
    ms_pme_options defaults = ms_pme_defaults();
    ms_pme__run run;
    int j;
    ms_status status;
    if (function == NULL) return ms_pme__null("function", error);
    if (x == NULL) return ms_pme__null("x", error);
    status = ms_pme__begin(&run, function, options != NULL ? options : &defaults, x, NULL, error);
    if (status != MS_OK) return status;
    for (j = 0; j < run.n; ++j) run.solvers[0].x[j] = ms_pme__clip(x[j], run.low[j], run.high[j]);
    ms_pme__multistart(&run, 1);
    status = ms_pme__verdict(&run, error);
    if (status == MS_OK) ms_pme__copy(x, run.best, run.n);
    if (status == MS_OK && result != NULL) *result = run.result;
    ms__release(&run.options->allocator, run.block, run.block_size);
    return status;
}

/* ---- match ----------------------------------------------------------------------------------------------------- */

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

static double ms_pme__weight(const ms_pme__objective *o, size_t i) { return o->weight ? (double)o->weight[i] : 1; }

static double ms_pme__pull(const ms_pme__objective *o, int j) { return o->options->pull ? o->options->pull[j] : 0; }

/* r_i = sqrt(w_i / sum w) (phi_i - t_i), or those of the reduced function; then sqrt(pull_j) (x_j - source_j). */
static ms_status ms_pme__objective_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const ms_pme__objective *o = (const ms_pme__objective *)user;
    const ms_pme_renderer *renderer = o->renderer;
    const ms_pme_function *reduced = renderer->reduced;
    size_t i, j, n = (size_t)o->n, row = o->m;
    ms_status status;
    if (reduced != NULL) status = reduced->residuals(reduced->user, x, r, jacobian);
    else if (jacobian != NULL) status = renderer->jacobian(renderer->user, x, o->image, o->jacobian);
    else status = renderer->render(renderer->user, x, o->image);
    if (status != MS_OK) return status;
    for (i = 0; i < o->m; ++i) {
        const double w = reduced ? 1 : ms_pme__weight(o, i),
                     s = reduced ? 1 / sqrt(o->weight_sum) : sqrt(w / o->weight_sum);
        if (reduced == NULL) r[i] = w > 0 ? (double)o->image[i] - (double)o->target[i] : 0;
        r[i] *= s;
        for (j = i * n; j < (i + 1) * n && jacobian != NULL; ++j) {
            if (reduced == NULL) jacobian[j] = w > 0 ? (double)o->jacobian[j] : 0;
            jacobian[j] *= s;
        }
    }
    for (i = 0; i < n; ++i) {
        const double root = sqrt(ms_pme__pull(o, (int)i));
        if (!(root > 0)) continue;
        r[row] = root * (x[i] - o->options->source[i]);
        for (j = 0; j < n && jacobian != NULL; ++j) jacobian[row * n + j] = j == i ? root : 0;
        ++row;
    }
    return MS_OK;
}

/* RMSE at x, whose |r| is norm: f without the pulls. */
static double ms_pme__rmse(const ms_pme__objective *o, const double *x, double norm)
{
    double square = ms_pme__square(norm);
    int j;
    for (j = 0; j < o->n; ++j)
        if (ms_pme__pull(o, j) > 0) square -= ms_pme__pull(o, j) * ms_pme__square(x[j] - o->options->source[j]);
    return sqrt(ms_pme__max(square, 0));
}

/* Checks the arguments and fills the objective. */
static ms_status ms_pme__objective_init(ms_pme__objective *o, ms_error *error)
{
    const ms_pme_renderer *renderer = o->renderer;
    const ms_pme_match_options *options = o->options;
    const ms_pme_function *reduced;
    ms_pme_function *function = &o->function;
    size_t i;
    if (renderer == NULL) return ms_pme__null("renderer", error);
    if (o->target == NULL) return ms_pme__null("target", error);
    if (renderer->render == NULL) return ms_pme__null("renderer->render", error);
    if (renderer->prediction_count > 0 && renderer->predict == NULL) return ms_pme__null("renderer->predict", error);
    reduced = renderer->reduced;
    if (reduced != NULL && reduced->residuals == NULL) return ms_pme__null("renderer->reduced->residuals", error);
    if (options->candidate_count > 0 && options->candidates == NULL) return ms_pme__null("options->candidates", error);
    if (options->pull != NULL && options->source == NULL) return ms_pme__null("options->source", error);
    if (ms_pme__outside("parameter_count", renderer->parameter_count, 1, MS_PME_PARAMETERS_MAX, error) ||
        ms_pme__outside("image_size", (double)renderer->image_size, 1, (double)SIZE_MAX, error) ||
        ms_pme__outside("prediction_count", renderer->prediction_count, 0, INT_MAX, error) ||
        ms_pme__outside("candidate_count", options->candidate_count, 0, INT_MAX - renderer->prediction_count, error) ||
        ms_pme__outside("random_count", options->random_count, 0, INT_MAX, error))
        return MS_INVALID_ARGUMENT;
    if (reduced != NULL && reduced->parameter_count != renderer->parameter_count)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "reduced->parameter_count is %d, expected %d",
                        reduced->parameter_count, renderer->parameter_count);

    /* the function to minimize, and the counts of candidates */
    o->n = renderer->parameter_count;
    o->m = reduced ? reduced->residual_count : renderer->image_size;
    o->given = renderer->prediction_count + options->candidate_count;
    o->total = options->random_count < INT_MAX - o->given ? o->given + options->random_count : INT_MAX;
    function->user = o;
    function->parameter_count = o->n;
    function->residual_count = o->m;
    function->residuals = ms_pme__objective_residuals;
    function->residuals_only = reduced ? reduced->residuals_only : renderer->jacobian == NULL;
    function->jacobian_cost = reduced ? reduced->jacobian_cost : renderer->jacobian_cost;
    function->lower = renderer->lower;
    function->upper = renderer->upper;

    /* pulls, weights and target */
    for (i = 0; i < (size_t)o->n; ++i) {
        if (options->pull && (!ms__finite(options->pull[i]) || options->pull[i] < 0 || !ms__finite(options->source[i])))
            return ms__fail(error, MS_INVALID_ARGUMENT, i,
                            "pull %z is %g towards %g, expected finite numbers, the first 0 or more", i,
                            options->pull[i], options->source[i]);
        function->residual_count += ms_pme__pull(o, (int)i) > 0;
    }
    for (i = 0; i < renderer->image_size; ++i) {
        double w = ms_pme__weight(o, i), t = (double)o->target[i];
        if (!ms__finite(w) || w < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "weight %z is %g, expected a finite number >= 0", i, w);
        if (w > 0 && !ms__finite(t))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "target %z is %g, expected a finite number", i, t);
        o->compared += w > 0;
        o->weight_sum += w;
        if (w > 0) o->size += w * t * t;
    }
    if (o->compared == 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "every weight is 0: nothing to match");
    o->size = sqrt(o->size / o->weight_sum);
    return MS_OK;
}

/* Candidate i into x: predictions, the caller's, random ones, then the middle of the box. Non-zero if it is finite. */
static int ms_pme__candidate(ms_pme__run *run, const ms_pme__objective *o, int64_t i, double *x)
{
    const ms_pme_renderer *renderer = o->renderer;
    int n = run->n, finite = 1, j;
    for (j = 0; j < n; ++j) x[j] = 0.5 * run->low[j] + 0.5 * run->high[j];
    if (i < renderer->prediction_count) ms_pme__fail(run, renderer->predict(renderer->user, (int)i, o->target, x));
    else if (i < o->given)
        ms_pme__copy(x, o->options->candidates + (size_t)(i - renderer->prediction_count) * (size_t)n, n);
    else if (i < o->total) ms_pme__random_point(run, x, 0, x);
    for (j = 0; j < n; ++j) {
        finite &= ms__finite(x[j]);
        x[j] = ms_pme__clip(x[j], run->low[j], run->high[j]);
    }
    return finite;
}

/* Best of n: eq. (4.3), with the caller's candidates among them, eq. (4.4), without a limit of cost. The best become
   the starts, in their order; returns the number of these. */
static int ms_pme__candidates(ms_pme__run *run, const ms_pme__objective *o)
{
    const double max_cost = run->max_cost;
    int kept = 0;
    int64_t i;
    run->max_cost = MS_PME__INF;
    for (i = 0; (i < o->total || (i == o->total && !ms__finite(run->best_norm))) && !run->stopped; ++i) {
        ms_pme__solver *solver = &run->solvers[kept];
        if (!ms_pme__candidate(run, o, i, solver->x)) continue;
        solver->norm = ms_pme__evaluate(run, solver->x, 0);
        solver->index = (int)i;
        ms_pme__rank(run->solvers, kept);
        kept += kept < MS_PME__SOLVERS;
    }
    run->max_cost = max_cost;
    return kept;
}

/* Standard deviations of x from the linear model at the answer, with noise of the size of the RMSE in each compared
   value and a prior variance of range^2 / 12 for each parameter. The noise is no finer than floats: 1e-7 of the target
   or of what the strongest parameter does to the picture. */
static void ms_pme__deviations(ms_pme__run *run, const ms_pme__objective *o, double rmse, double *deviation)
{
    const int n = run->n, w = n + 1;
    double noise = ms_pme__max(1e-7 * o->size, rmse), sigma, *y = run->work, *row = run->work;
    int j, k, i;
    for (j = 0; j < n; ++j) {
        double range = run->high[j] - run->low[j], change = range * run->unit[j] * run->column[j];
        noise = ms_pme__max(noise, 1e-7 * ms_pme__clip(change, 0, 1e39)); /* floats end before */
        deviation[j] = 0;
    }
    sigma = (noise > 0 ? noise : 1) / sqrt((double)o->compared);
    for (j = 0; j < n; ++j) { /* one residual sqrt(12) sigma x_j / range for each parameter; squares are numbers */
        double range = run->high[j] - run->low[j], change = range * run->unit[j], prior = sqrt(12.0) * sigma;
        if (!(run->column[j] > 0)) prior = 1; /* no effect on the picture */
        else prior = change > prior * 1e-100 ? ms_pme__max(prior / change, 1e-100) : 1e100;
        for (k = 0; k < w; ++k) row[k * MS_PME__ROWS] = k == j ? prior : 0;
        ms_pme__qr_append(run->triangle, n, row, 1);
    }
    for (k = 0; k < n; ++k) /* column k of the inverse; sums of squares: variances */
        for (i = k; i >= 0; --i) {
            double t = i == k, pivot = run->triangle[i * w + i];
            for (j = i + 1; j <= k; ++j) t -= run->triangle[i * w + j] * y[j];
            y[i] = fabs(pivot) > 0 ? t / pivot : 0;
            deviation[i] += y[i] * y[i];
        }
    for (j = 0; j < n; ++j) { /* data never widen the prior */
        const double widest = (run->high[j] - run->low[j]) / sqrt(12.0);
        deviation[j] = ms_pme__clip(sigma * sqrt(deviation[j]) / run->unit[j], 0, widest);
        if (!(run->column[j] > 0)) deviation[j] = widest;
    }
}

/* The picture of the answer and its RMSE, which a reduced function must agree with. */
static ms_status ms_pme__last_render(ms_pme__run *run, ms_pme__objective *o, double *rmse, ms_error *error)
{
    const ms_pme_renderer *renderer = o->renderer;
    double sum = 0, reduced = ms_pme__rmse(o, run->best, run->best_norm);
    size_t i;
    if (ms_pme__fail(run, renderer->render(renderer->user, run->best, o->image))) return ms_pme__verdict(run, error);
    for (i = 0; i < renderer->image_size; ++i) {
        double w = ms_pme__weight(o, i), e = (double)o->image[i] - (double)o->target[i];
        if (w > 0) sum += w * e * e;
    }
    *rmse = sqrt(sum / o->weight_sum);
    if (renderer->reduced == NULL || fabs(reduced - *rmse) <= 1e-3 * *rmse + 1e-5 * o->size) return MS_OK;
    return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                    "the reduced function's RMSE is %g, the picture's %g: another target or other weights", reduced,
                    *rmse);
}

MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image, ms_pme_match_result *result,
                              ms_error *error)
{
    ms_pme_match_options defaults = ms_pme_match_defaults();
    ms_pme_match_result answer;
    ms_pme__objective o;
    ms_pme__run run;
    int kept;
    ms_status status;

    /* the function, its bounds, its budget and its memory */
    memset(&o, 0, sizeof o);
    o.renderer = renderer;
    o.options = options = options != NULL ? options : &defaults;
    o.target = target;
    o.weight = weight;
    status = ms_pme__objective_init(&o, error);
    if (status != MS_OK) return status;
    if (x == NULL) return ms_pme__null("x", error);
    status = ms_pme__begin(&run, &o.function, &options->refine, NULL, &o, error);
    if (status != MS_OK) return status;

    /* candidates; refinement with a budget of its own; derivatives for the deviations */
    kept = ms_pme__candidates(&run, &o);
    status = ms_pme__verdict(&run, error);
    if (status == MS_OK) {
        answer.cost = run.result.cost;
        answer.best_candidate = run.solvers[0].index;
        answer.rmse_initial = ms_pme__rmse(&o, run.best, run.best_norm);
        memset(&run.result, 0, sizeof run.result);
        run.result.value = ms_pme__square(run.best_norm);
        if (options->initial_only && !run.stopped) run.result.stop = MS_PME_STOP_INITIAL;
        else if (!run.stopped) ms_pme__multistart(&run, kept);
        answer.cost += run.result.cost + 1; /* the last render */
        answer.refine = run.result;
        run.uncharged = 1;
        run.stopped = run.status != MS_OK;
        if (options->deviation != NULL) ms_pme__linearize(&run, run.best);
        status = ms_pme__verdict(&run, error);
    }

    /* one real render, then the outputs */
    if (status == MS_OK) status = ms_pme__last_render(&run, &o, &answer.rmse, error);
    if (status == MS_OK) {
        ms_pme__copy(x, run.best, o.n);
        if (image != NULL) memcpy(image, o.image, renderer->image_size * sizeof *image);
        if (options->deviation != NULL) ms_pme__deviations(&run, &o, answer.rmse, options->deviation);
        if (result != NULL) *result = answer;
    }
    ms__release(&run.options->allocator, run.block, run.block_size);
    return status;
}

#undef MS_PME__INF
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
