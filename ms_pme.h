/* ms_pme.h - v0.1.0 - from an edited picture to material parameters - MIT or public domain, see the end

   You have a renderer phi(x) (a small neural one, ms_nn.h runs such), and a target picture that somebody painted. This
   header finds the parameters x, inside their bounds, whose picture is closest: it tries the guesses that you have
   (inversion networks, the previous frame, the source material), keeps the best, and refines it. It works from
   callbacks alone, and its optimisers can be used on any function of up to 256 parameters.

   Use it: in one C or C++ file, before the #include, #define MS_PME_IMPLEMENTATION.

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
      The default is Levenberg-Marquardt whose every step is a least-squares problem inside the box, solved exactly by an
      active-set method on a QR factorisation. On the 14 problems of tests/data/pme_problems.json (More, Garbow,
      Hillstrom, free and bounded) it ends within 1e-7 of a trust-region solver's minima on all; L-BFGS, conjugate
      gradient and SQP on 12, clipped Nelder-Mead on 8, the thesis's Nelder-Mead with a barrier on 4, basin hopping (3000
      evaluations) on 14: `tests/test_pme.c reference` prints this. Give a Jacobian when you have one: it costs a network
      a few evaluations, differences cost n. On float32 pictures differences of 1.5e-8, the customary default, are noise;
      this is why gradient methods stand still in the thesis's Table 4.3 (`tests/test_pme.c table` shows it).
   Budget
      Counted in evaluations; one with a Jacobian counts jacobian_cost. A call never spends more than max_cost (the
      candidates of ms_pme_match and its final render come on top), and stops earlier at a target value, after
      max_seconds, or when progress says so: before the next callback. With the networks of examples/data the default of 50
      pictures takes 6 ms at 64 x 64; 1000 with restarts look into the other minima as well (`make bench FILTER=pme`).
   Memory
      One block a call (two for ms_pme_match) from options.allocator, sizes stated there; stack below 10 KB.
   Threads
      No state: calls may overlap. The callbacks run on the calling thread; a renderer may be parallel inside.
   Determinism
      The same bits at every call with the same seed, as far as the callbacks' answers are; no SIMD, so on one build. -ffast-math
      voids this and what is said of NaN and infinity.
   Errors
      Statuses, and a sentence in ms_error. NaN or infinite values of a function are no errors: such points lose.
   Configuration
      MS_PME_NO_CLOCK   no <time.h>; max_seconds then needs options.clock. The header never uses stdio.
      MS_DEF            linkage of the functions, e.g. static, __declspec(dllexport)
   Limits
      256 parameters; dense Jacobians [m][n] in double. Local methods: the answer is the minimum nearest to the best
      candidate; restarts or basin hopping look further. A function must not be smoother than it says: noise larger
      than the tolerance wants difference_step or Nelder-Mead.
   Sources
      Zsolnai-Feher, Photorealistic Material Learning and Synthesis, chapter 4 (algorithm 4, equations 4.1 to 4.4);
      More 1978; Nielsen 1999; Stark and Parker 1995; Nocedal and Wright 2006; Nelder and Mead 1965; Powell 1978; Wales
      and Doye 1997; Hestenes 1958; More, Garbow and Hillstrom 1981.
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

/* ms-common begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
#ifndef MS_COMMON
#define MS_COMMON 2 /* raised whenever the text between the marks changes after a release */

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

/* NULL, in every header: where an argument's comment does not say what NULL means, it may not be NULL. A call that returns a
   status then answers MS_INVALID_ARGUMENT and names the argument; any other does nothing and returns 0 or NULL.
   destroy and free do nothing with NULL. */

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
#if MS_COMMON != 2 /* outside the guard: catches two vendored releases in one file */
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---- 1. any function of a few parameters ------------------------------------------------------------------------ */

/* What is to be made small over the box lower <= x <= upper: f(x) = sum of r_i(x)^2 when `residuals` is given, else
   `value`. A callback returns MS_OK, or a status that ends the run and becomes its answer. Values that are NaN or
   infinite are no failure: such a point is taken as worse than every finite one. Callbacks are called from the
   thread that made the call, one at a time; x is always inside the box but in MS_PME_NELDER_MEAD_BARRIER and with
   options.barrier, where points outside it are never passed on. */
typedef struct ms_pme_function {
    void *user;
    int parameter_count;   /* n, 1 to MS_PME_PARAMETERS_MAX */
    size_t residual_count; /* m >= 1 with `residuals` */
    /* r [m] out. jacobian [m][n] row-major out, d r_i / d x_j, or NULL: not asked for. */
    ms_status (*residuals)(void *user, const double *x, double *r, double *jacobian);
    int residuals_only;    /* non-zero: `residuals` cannot fill a Jacobian; differences take its place */
    double jacobian_cost;  /* what one call with a Jacobian counts, in evaluations; 0: 1 + n / 4 */
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
    MS_PME_NELDER_MEAD = 1,         /* simplex, points clipped to the box, first edges 0.1 of the range */
    MS_PME_NELDER_MEAD_BARRIER = 2, /* as in the thesis: infinite outside the box, first edges 5% of x (0.00025 at 0) */
    MS_PME_LBFGS = 3,               /* limited-memory quasi-Newton, active set of bounds */
    MS_PME_CONJUGATE_GRADIENT = 4,  /* Polak-Ribiere+, active set of bounds */
    MS_PME_SQP = 5,                 /* what SLSQP is when bounds are the only constraints: damped BFGS model,
                                       quadratic program in the box, line search */
    MS_PME_BASIN_HOPPING = 6        /* random hops, each followed by Levenberg-Marquardt (or L-BFGS) */
} ms_pme_method;

typedef enum ms_pme_stop {
    MS_PME_STOP_CONVERGED = 0, /* the step, the decrease or the projected gradient fell below its tolerance */
    MS_PME_STOP_TARGET = 1,    /* target_value (or target_rmse) reached */
    MS_PME_STOP_COST = 2,      /* max_cost spent */
    MS_PME_STOP_SECONDS = 3    /* max_seconds spent */
} ms_pme_stop;

/* All zero gives the defaults; ms_pme_defaults() returns that. */
typedef struct ms_pme_options {
    int method;             /* ms_pme_method */
    double max_cost;        /* in evaluations of f (Jacobians at jacobian_cost); 0: 1000 */
    double max_seconds;     /* of `clock`; 0: no limit. Looked at before every callback */
    double target_value;    /* stop when f <= this; 0: only at 0 */
    double tolerance;       /* relative decrease and relative step taken as converged; 0: 1e-10 */
    double start_step;      /* Nelder-Mead: first edge as a fraction of the range (of max(|x|, 1) without bounds), 0: 0.1.
                               Basin hopping: hop, 0: 0.25 */
    double difference_step; /* > 0: forward differences of this absolute step; 0: central, near the best step for f64.
                               A float32 renderer wants about 1e-3: with 1.5e-8 its differences are rounding noise */
    int barrier;            /* non-zero: no projection, f is infinite outside the box (to reproduce Table 4.3) */
    int restarts;           /* Levenberg-Marquardt: further runs while cost is left, from random points; ms_pme_match
                               takes its next best candidates first. Rough runs, finished where they lead further */
    uint64_t seed;          /* of restarts and hops */
    double (*clock)(void *user); /* seconds, from any origin; NULL: the C library's clock() */
    void *clock_user;
    ms_progress progress;   /* asked before every callback */
    ms_allocator allocator; /* one block of about (m n + m + 6 n^2) doubles, released before the call returns */
} ms_pme_options;

typedef struct ms_pme_result {
    double value;          /* f at x */
    double cost;           /* spent, in evaluations */
    size_t evaluations;    /* calls without derivatives */
    size_t jacobians;      /* calls with them */
    size_t iterations;     /* steps of the method */
    ms_pme_stop stop;
    double projected_gradient; /* largest |component| at x of the gradient that bounds do not hold; -1: not known */
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
   x not finite, no finite value at the start. MS_OUT_OF_MEMORY, MS_CANCELLED, or what a callback returned: x is then
   untouched. MS_NOT_CONVERGED is never returned: a budget that ended the run is said in result->stop. */
MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error);

/* ---- 2. which material made this picture? ------------------------------------------------------------------------ */

/* The picture is image_size floats in any order, phi(x). Thesis, chapter 4. */
typedef struct ms_pme_renderer {
    void *user;
    int parameter_count; /* n */
    size_t image_size;   /* p: pixels times channels */
    const double *lower, *upper; /* [n]; NULL: all 0, all 1 */
    /* phi(x) -> image [p] */
    ms_status (*render)(void *user, const double *x, float *image);
    /* Optional: image and d image_i / d x_j as [p][n]. */
    ms_status (*jacobian)(void *user, const double *x, float *image, float *jacobian);
    double jacobian_cost; /* in renders; 0: 1 + n / 4 */
    /* Optional: prediction i of prediction_count inversion networks, target [p] -> x [n]; outside the box is allowed. */
    int prediction_count;
    ms_status (*predict)(void *user, int i, const float *target, double *x);
    /* Optional: a smaller function with the same minimum, valid for this target and these weights (ms_nn.h's collapse):
       sum of squares + reduced_offset = sum of weight (phi - target)^2. Then candidates and refinement use it, and
       `render` is called once, for the reported RMSE. */
    const ms_pme_function *reduced;
    double reduced_offset;
} ms_pme_renderer;

/* All zero: fill in what you have. */
MS_API ms_pme_renderer ms_pme_renderer_defaults(void);

typedef struct ms_pme_match_options {
    ms_pme_options refine;   /* max_cost 0: 50, spent after the candidates; target_value is set from target_rmse */
    double target_rmse;      /* good enough: no refinement once a candidate has it ("best of both worlds"); 0: none */
    int initial_only;        /* non-zero: the best candidate as it is ("close to real time") */
    const double *candidates;/* [candidate_count][n]: the previous frame's answer, the source material; may be NULL */
    int candidate_count;
    int random_count;        /* further candidates drawn uniformly. The middle of the box is tried where no other has a finite picture */
} ms_pme_match_options;

typedef struct ms_pme_match_result {
    double rmse;            /* weighted, in the image's unit, from one real render of x */
    double rmse_initial;    /* of the best candidate */
    int best_candidate;     /* predictions come first, then `candidates`, then random ones (or the middle) */
    int candidates_refused; /* predictions and candidates that were not finite */
    ms_pme_result refine;   /* cost does not hold that of the candidates */
    double cost;            /* all renders */
} ms_pme_match_result;

MS_API ms_pme_match_options ms_pme_match_defaults(void);

/* Best of n, then refinement (thesis, algorithm 4, eq. 4.1 to 4.4).
   target   [p], finite where the weight is not 0
   weight   [p] >= 0, or NULL: all 1. RMSE^2 = sum w (phi - t)^2 / sum w
   x        [n] out: the material
   image    [p] out: phi(x), or NULL
   MS_INVALID_ARGUMENT: as ms_pme_minimize; a target that is not finite (error->position: its index), a negative or
   non-finite weight (likewise), weights that are all 0, no candidate with a finite picture.
   MS_OUT_OF_MEMORY, MS_CANCELLED, or the status of a callback: outputs untouched. */
MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image,
                              ms_pme_match_result *result, ms_error *error);

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
/* ms-common-private begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
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

static MS__UNUSED size_t ms__size_add(size_t a, size_t b)
{
    return b > SIZE_MAX - a ? SIZE_MAX : a + b;
}

/* NULL for size SIZE_MAX (overflow). Size 0 gives a pointer that must be released as well. */
static MS__UNUSED void *ms__alloc(const ms_allocator *allocator, size_t size)
{
    if (size == SIZE_MAX) return NULL;
    if (allocator != NULL && allocator->alloc != NULL)
        return allocator->alloc(allocator->user, size ? size : 1);
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
    while (x >= 1e6) { x /= 10; ++exponent; }
    while (x < 1e5) { x *= 10; --exponent; }
    mantissa = (int64_t)(x + 0.5);
    if (mantissa >= 1000000) { mantissa /= 10; ++exponent; }
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

/* IEEE binary16 by integers alone: subnormals, infinities and NaN, whatever the host's rounding and flushing of subnormals. */
static MS__UNUSED float ms__half_to_float(uint16_t h)
{
    uint32_t bits = (uint32_t)(h & 0x8000u) << 16, exponent = (h >> 10) & 31u, mantissa = h & 1023u;
    float value;
    if (exponent == 31u) {
        bits |= 0x7f800000u | mantissa << 13;
    } else if (exponent != 0 || mantissa != 0) {
        if (exponent == 0) /* a subnormal half is a normal float */
            for (exponent = 1; !(mantissa & 1024u); mantissa <<= 1) --exponent;
        bits |= ((exponent + 112u) << 23) + ((mantissa & 1023u) << 13);
    }
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Rounded to nearest even; a finite value stays finite: at most 65504. */
static MS__UNUSED uint16_t ms__half_from_float(float value)
{
    uint32_t bits, sign, a, shift = 13;
    memcpy(&bits, &value, sizeof bits);
    sign = (bits >> 16) & 0x8000u;
    a = bits & 0x7fffffffu;
    if (a >= 0x7f800000u) return (uint16_t)(sign | 0x7c00u | (a > 0x7f800000u ? 0x200u : 0u));
    if (a >= 0x477fe000u) return (uint16_t)(sign | 0x7bffu);
    if (a < 0x33000000u) return (uint16_t)sign; /* under 2^-25 */
    if (a < 0x38800000u) {                      /* under 2^-14: whole steps of 2^-24 */
        shift = 126u - (a >> 23);
        a = (a & 0x7fffffu) | 0x800000u;
    } else {
        a -= 0x38000000u;
    }
    a += (1u << (shift - 1u)) - 1u + ((a >> shift) & 1u);
    return (uint16_t)(sign | (a >> shift));
}
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* Sections: small maths | the run: budgets and evaluations | bounded least squares | Levenberg-Marquardt | line search |
   quasi-Newton, conjugate gradient, SQP | Nelder-Mead | basin hopping | public: minimize | public: match |
   public: sensitivity */

#include <float.h>
#include <math.h>
#ifndef MS_PME_NO_CLOCK
#include <time.h>
#endif

/* ---- small maths ------------------------------------------------------------------------------------------------- */

#define MS_PME__INF ((double)HUGE_VAL)
#define MS_PME__MEMORY 8 /* pairs that L-BFGS keeps */
#define MS_PME__ROWS 32  /* rows of the Jacobian that one QR update takes: they stay in the cache */

static double ms_pme__dot(const double *a, const double *b, int n)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

static double ms_pme__clip(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static double ms_pme__max(double a, double b)
{
    return a > b ? a : b;
}

static void ms_pme__copy(double *to, const double *from, int n)
{
    memcpy(to, from, (size_t)n * sizeof *to);
}

/* Rows [k][n + 1] (the last column is the right-hand side) are folded into the upper triangle r [n + 1][n + 1] by
   Householder reflections of (r_jj, column j of the rows): the R of a QR factorisation, built row block by row block
   (TSQR with a chain for a tree). The rows are destroyed. */
static void ms_pme__qr_append(double *r, int n, double *rows, int k)
{
    int w = n + 1, i, j, c;
    for (j = 0; j <= n; ++j) {
        double largest = fabs(r[j * w + j]), norm, head, beta;
        for (i = 0; i < k; ++i) largest = ms_pme__max(largest, fabs(rows[i * w + j]));
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

/* ---- the run: budgets and evaluations ----------------------------------------------------------------------------- */

typedef struct ms_pme__run {
    const ms_pme_function *function;
    const ms_pme_options *options;
    int n, barrier, ranged;           /* ranged: every parameter has one that means something */
    size_t m;
    double max_cost, tolerance, jacobian_cost, start_time;
    double *lower, *upper;            /* [n] */
    double *best;                     /* [n] the best point evaluated, and its value */
    double best_value;
    double *residual, *residual_step; /* [m] of the last evaluation; of a difference */
    double *jacobian;                 /* [m][n] of the last one with derivatives */
    double *triangle;                 /* [n + 1][n + 1] */
    double *rows;                     /* [ROWS][n + 1] */
    double *scratch;                  /* what the methods share out among themselves */
    ms_pme_result result;
    int stopped;                      /* a budget, the target, a failure: nothing more may be evaluated */
    ms_status status;
    ms__rng rng;
} ms_pme__run;

static int ms_pme__stop(ms_pme__run *run, ms_pme_stop why)
{
    if (!run->stopped) run->result.stop = why;
    return run->stopped = 1;
}

static int ms_pme__fail(ms_pme__run *run, ms_status status)
{
    run->status = status;
    return run->stopped = 1;
}

static double ms_pme__seconds(const ms_pme_options *options)
{
    if (options->clock != NULL) return options->clock(options->clock_user);
#ifndef MS_PME_NO_CLOCK
    return (double)clock() / (double)CLOCKS_PER_SEC;
#else
    return 0;
#endif
}

/* Asked before every callback: is there budget for one of this cost? Non-zero: no, the run is over. */
static int ms_pme__spend(ms_pme__run *run, double cost)
{
    const ms_pme_options *options = run->options;
    if (run->stopped) return 1;
    if (run->result.cost + cost > run->max_cost * (1 + 1e-12)) return ms_pme__stop(run, MS_PME_STOP_COST);
    if (options->max_seconds > 0 && ms_pme__seconds(options) - run->start_time >= options->max_seconds)
        return ms_pme__stop(run, MS_PME_STOP_SECONDS);
    if (options->progress.report != NULL &&
        options->progress.report(options->progress.user, run->result.cost / run->max_cost) != 0)
        return ms_pme__fail(run, MS_CANCELLED);
    run->result.cost += cost;
    return 0;
}

/* Every value goes through here: NaN becomes infinity, the best point is kept, the target is looked for. */
static double ms_pme__seen(ms_pme__run *run, const double *x, double f)
{
    if (!ms__finite(f)) return MS_PME__INF;
    if (f < run->best_value) {
        run->best_value = f;
        ms_pme__copy(run->best, x, run->n);
    }
    if (f <= run->options->target_value) ms_pme__stop(run, MS_PME_STOP_TARGET);
    return f;
}

static int ms_pme__outside(const ms_pme__run *run, const double *x)
{
    int j;
    for (j = 0; j < run->n; ++j)
        if (!(x[j] >= run->lower[j] && x[j] <= run->upper[j])) return 1;
    return 0;
}

static double ms_pme__sum_of_squares(const double *r, size_t m)
{
    double sum = 0;
    size_t i;
    for (i = 0; i < m; ++i) sum += r[i] * r[i];
    return sum;
}

/* f(x); infinity outside the box, for NaN, and once the run has stopped. With residuals they go to r [m]. */
static double ms_pme__value_to(ms_pme__run *run, const double *x, double *r)
{
    const ms_pme_function *function = run->function;
    double f = 0;
    ms_status status;
    if (ms_pme__spend(run, 1)) return MS_PME__INF;
    run->result.evaluations++;
    if (ms_pme__outside(run, x)) return MS_PME__INF;
    if (function->residuals != NULL) {
        status = function->residuals(function->user, x, r, NULL);
        if (status == MS_OK) f = ms_pme__sum_of_squares(r, run->m);
    } else {
        status = function->value(function->user, x, &f);
    }
    if (status != MS_OK) {
        ms_pme__fail(run, status);
        return MS_PME__INF;
    }
    return ms_pme__seen(run, x, f);
}

static double ms_pme__value(ms_pme__run *run, const double *x)
{
    return ms_pme__value_to(run, x, run->residual_step);
}

/* The step of a difference in x_j and whether it may be central; inside the box unless there is a barrier. */
static double ms_pme__difference_step(const ms_pme__run *run, double x, int j, int central, double *back)
{
    double range = run->upper[j] - run->lower[j], scale = ms__finite(range) ? range : 1;
    double h = run->options->difference_step;
    if (!(h > 0)) h = (central ? 6.1e-6 : 1.5e-8) * ms_pme__max(fabs(x), 1e-2 * scale); /* eps^(1/3), eps^(1/2) */
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
static double ms_pme__linearize(ms_pme__run *run, const double *x)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j;
    size_t i;
    double f;
    if (!function->residuals_only) {
        ms_status status;
        if (ms_pme__spend(run, run->jacobian_cost)) return MS_PME__INF;
        run->result.jacobians++;
        status = function->residuals(function->user, x, run->residual, run->jacobian);
        if (status != MS_OK) {
            ms_pme__fail(run, status);
            return MS_PME__INF;
        }
        return ms_pme__seen(run, x, ms_pme__sum_of_squares(run->residual, run->m));
    }
    f = ms_pme__value_to(run, x, run->residual);
    if (!ms__finite(f)) return f;
    for (j = 0; j < n; ++j) {
        double back, h = ms_pme__difference_step(run, x[j], j, 0, &back), *moved = run->scratch;
        ms_pme__copy(moved, x, n);
        moved[j] = x[j] + h;
        h = moved[j] - x[j];
        ms_pme__value_to(run, moved, run->residual_step);
        if (run->stopped) return MS_PME__INF;
        for (i = 0; i < run->m; ++i)
            run->jacobian[i * (size_t)n + (size_t)j] = h != 0 ? (run->residual_step[i] - run->residual[i]) / h : 0;
    }
    return f;
}

/* f and gradient at x by the best way that there is; infinity if the run has stopped. */
static double ms_pme__gradient(ms_pme__run *run, const double *x, double *g)
{
    const ms_pme_function *function = run->function;
    int n = run->n, j;
    double f = 0;
    if (run->barrier && ms_pme__outside(run, x)) {
        for (j = 0; j < n; ++j) g[j] = 0;
        return ms_pme__value(run, x);
    }
    if (function->gradient != NULL && !(run->options->difference_step > 0)) {
        ms_status status;
        if (ms_pme__spend(run, run->jacobian_cost)) return MS_PME__INF;
        run->result.jacobians++;
        status = function->gradient(function->user, x, &f, g);
        if (status != MS_OK) {
            ms_pme__fail(run, status);
            return MS_PME__INF;
        }
        f = ms_pme__seen(run, x, f);
    } else if (function->residuals != NULL && !function->residuals_only && !(run->options->difference_step > 0)) {
        size_t i;
        f = ms_pme__linearize(run, x);
        for (j = 0; j < n; ++j) g[j] = 0;
        if (!ms__finite(f)) return f;
        for (i = 0; i < run->m; ++i)
            for (j = 0; j < n; ++j) g[j] += 2 * run->residual[i] * run->jacobian[i * (size_t)n + (size_t)j];
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
            g[j] = h != 0 ? (high - low) / h : 0;
        }
    }
    for (j = 0; j < n; ++j)
        if (!ms__finite(g[j])) {
            if (!run->barrier) return MS_PME__INF;
            g[j] = 0; /* a difference over the barrier: the direction is lost, as it was for the thesis */
        }
    return run->stopped && run->status != MS_OK ? MS_PME__INF : f;
}

/* Is x_j held by its bound against a descent along -g? */
static int ms_pme__held(const ms_pme__run *run, const double *x, const double *g, int j)
{
    if (run->barrier) return 0;
    return (x[j] <= run->lower[j] && g[j] >= 0) || (x[j] >= run->upper[j] && g[j] <= 0);
}

static double ms_pme__projected_gradient(const ms_pme__run *run, const double *x, const double *g)
{
    double largest = 0;
    int j;
    for (j = 0; j < run->n; ++j)
        if (!ms_pme__held(run, x, g, j)) largest = ms_pme__max(largest, fabs(g[j]));
    return largest;
}

/* ---- bounded least squares ------------------------------------------------------------------------------------------ */

/* d [n] minimises |A d - b| over low <= d <= high, low <= 0 <= high: the active-set method of Stark and Parker (1995),
   exact after finitely many changes of the set. A [rows][n] has full rank; work holds (n + 1)^2 + rows (n + 1) + n
   doubles, state n ints, which come in as the first guess of the set (0 free, -1 at low, 1 at high). */
static void ms_pme__bounded_least_squares(const double *a, const double *b, int rows, int n, const double *low,
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
        for (i = 0; i < rows; i += MS_PME__ROWS)
            ms_pme__qr_append(triangle, count, part + i * (count + 1), rows - i < MS_PME__ROWS ? rows - i : MS_PME__ROWS);
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
                if (t < alpha || hit < 0) { alpha = ms_pme__clip(t, 0, 1); hit = j; }
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
                d[j] = ms_pme__clip(d[j], low[j], high[j]);
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
            if (push > 1e-14 * size && push > steepest) { steepest = push; worst = j; }
        }
        if (worst < 0) break;
        released = worst;
        state[worst] = 0;
    }
}

/* ---- Levenberg-Marquardt --------------------------------------------------------------------------------------------- */

/* R and Q'(-r) of the Jacobian into run->triangle, g = 2 J'r; 0 if something is not finite. */
static int ms_pme__factor(ms_pme__run *run, double *g)
{
    int n = run->n, w = n + 1, i, j;
    size_t row = 0;
    memset(run->triangle, 0, (size_t)(w * w) * sizeof(double));
    while (row < run->m) {
        int k = run->m - row < MS_PME__ROWS ? (int)(run->m - row) : MS_PME__ROWS;
        for (i = 0; i < k; ++i, ++row) {
            ms_pme__copy(run->rows + i * w, run->jacobian + row * (size_t)n, n);
            run->rows[i * w + n] = -run->residual[row];
        }
        ms_pme__qr_append(run->triangle, n, run->rows, k);
    }
    for (j = 0; j < n; ++j) {
        double t = 0;
        for (i = 0; i <= j; ++i) t -= run->triangle[i * w + j] * run->triangle[i * w + n];
        g[j] = 2 * t;
        if (!ms__finite(t)) return 0;
    }
    return 1;
}

static double ms_pme__column_norm(const ms_pme__run *run, int j)
{
    double sum = 0;
    int i;
    for (i = 0; i <= j; ++i) sum += run->triangle[i * (run->n + 1) + j] * run->triangle[i * (run->n + 1) + j];
    return sqrt(sum);
}

/* What the linear model promises: |r|^2 - |r + J d|^2. */
static double ms_pme__predicted_decrease(const ms_pme__run *run, const double *d)
{
    int n = run->n, w = n + 1, i, j;
    double sum = 0;
    for (i = 0; i < n; ++i) {
        double t = 0;
        for (j = i; j < n; ++j) t += run->triangle[i * w + j] * d[j];
        sum += t * (2 * run->triangle[i * w + n] - t);
    }
    return sum;
}

/* The trust region's scaling: the largest column norms so far (More 1978). For pictures, whose parameters all have a range,
   the norms of now, none below 0.3 of the largest (both for a step across the box): what hardly changes the picture does
   not run off to its bounds. */
static void ms_pme__rescale(const ms_pme__run *run, double *scale)
{
    double largest = 0;
    int n = run->n, j;
    for (j = 0; j < n && run->ranged; ++j)
        largest = ms_pme__max(largest, (run->upper[j] - run->lower[j]) * ms_pme__column_norm(run, j));
    for (j = 0; j < n; ++j) {
        double range = run->upper[j] - run->lower[j], norm = ms_pme__column_norm(run, j);
        scale[j] = ms_pme__max(norm, !run->ranged ? scale[j] : range > 0 ? 0.3 * largest / range : 0);
    }
}

/* One run from x, which ends as the last accepted point; returns its value. Damping by the ratio of actual to predicted
   decrease (Nielsen 1999). */
static double ms_pme__levenberg_marquardt(ms_pme__run *run, double *x, double *memory)
{
    int n = run->n, w = n + 1, i, j, done = 0;
    double *trial = memory, *d = trial + n, *scale = d + n, *low = scale + n, *high = low + n, *g = high + n;
    double *a = g + n, *b = a + 2 * n * n, *work = b + 2 * n;
    int *state = (int *)(void *)(work + w * w + 2 * n * w + n);
    double lambda = 1e-3, grow = 2, f = ms_pme__linearize(run, x);
    for (j = 0; j < n; ++j) scale[j] = 0;
    while (!done && !run->stopped && ms__finite(f) && ms_pme__factor(run, g)) {
        double angle = 0; /* largest cosine between the residual and a column that may move */
        int accepted = 0;
        ms_pme__rescale(run, scale);
        for (j = 0; j < n; ++j) {
            double norm = ms_pme__column_norm(run, j);
            if (!ms_pme__held(run, x, g, j) && norm > 0) angle = ms_pme__max(angle, 0.5 * fabs(g[j]) / (norm * sqrt(f)));
        }
        run->result.projected_gradient = ms_pme__projected_gradient(run, x, g);
        if (f <= 0 || angle <= 1e-14) break;
        while (!accepted && !done && !run->stopped) {
            double predicted, f_trial, step = 0, size = 0;
            for (i = 0; i < n; ++i) { /* A = [R; sqrt(lambda) D], b = [Q'(-r); 0] */
                for (j = 0; j < n; ++j) {
                    a[i * n + j] = j >= i ? run->triangle[i * w + j] : 0;
                    a[(n + i) * n + j] = i == j ? sqrt(lambda) * (scale[j] > 0 ? scale[j] : 1) : 0;
                }
                b[i] = run->triangle[i * w + n];
                b[n + i] = 0;
            }
            for (j = 0; j < n; ++j) {
                low[j] = run->lower[j] - x[j];
                high[j] = run->upper[j] - x[j];
                state[j] = !ms_pme__held(run, x, g, j) ? 0 : low[j] >= 0 ? -1 : 1;
            }
            ms_pme__bounded_least_squares(a, b, 2 * n, n, low, high, d, state, work);
            for (j = 0; j < n; ++j) {
                trial[j] = state[j] < 0   ? run->lower[j]
                           : state[j] > 0 ? run->upper[j]
                                          : ms_pme__clip(x[j] + d[j], run->lower[j], run->upper[j]);
                step += scale[j] * scale[j] * d[j] * d[j];
                size += scale[j] * scale[j] * x[j] * x[j];
            }
            predicted = ms_pme__predicted_decrease(run, d);
            if (!(predicted > 1e-15 * f) || step <= 1e-30 * size || !(lambda < 1e60)) {
                done = 1; /* nothing left to gain that rounding would not swallow */
                break;
            }
            f_trial = ms_pme__value_to(run, trial, run->residual_step);
            if (f - f_trial > 1e-4 * predicted) {
                double t = 2 * (f - f_trial) / predicted - 1;
                lambda = ms_pme__max(lambda * ms_pme__max(0.1, 1 - t * t * t), 1e-16);
                grow = 2;
                accepted = 1;
                done = (f - f_trial <= run->tolerance * f && predicted <= run->tolerance * f) ||
                       step <= run->tolerance * run->tolerance * size;
                f = f_trial;
                ms_pme__copy(x, trial, n);
                run->result.iterations++;
            } else {
                lambda *= grow;
                grow *= 2;
            }
        }
        if (accepted && !done) f = ms_pme__linearize(run, x);
    }
    return f;
}

/* ---- line search ------------------------------------------------------------------------------------------------------ */

/* Where the gradient methods stand: a point, its value and gradient, and a trial. */
typedef struct ms_pme__point {
    double f;
    double *x, *g; /* [n] each */
} ms_pme__point;

/* Strong Wolfe conditions along d by bracketing and cubic interpolation (Nocedal and Wright 2006, algorithms 3.5 and
   3.6), the step at most longest; at longest decrease alone is enough. From p to q; the step, or 0 if none was found. */
static double ms_pme__line_search(ms_pme__run *run, const ms_pme__point *p, const double *d, double first, double longest,
                                  double curvature, ms_pme__point *q)
{
    int n = run->n, j, tries;
    double slope = ms_pme__dot(p->g, d, n), t = first < longest ? first : longest;
    double low = 0, f_low = p->f, slope_low = slope, high = 0, f_high = 0, slope_high = 0, s;
    int bracketed = 0;
    if (!(slope < 0) || !(longest > 0)) return 0;
    for (tries = 0; tries < 40 && !run->stopped; ++tries) {
        for (j = 0; j < n; ++j) {
            q->x[j] = p->x[j] + t * d[j];
            if (!run->barrier) q->x[j] = ms_pme__clip(q->x[j], run->lower[j], run->upper[j]);
        }
        q->f = ms_pme__gradient(run, q->x, q->g);
        s = ms_pme__dot(q->g, d, n);
        if (!(q->f <= p->f + 1e-4 * t * slope) || (bracketed && q->f >= f_low) || !ms__finite(q->f)) {
            high = t; f_high = q->f; slope_high = s;
            bracketed = 1;
        } else {
            if (fabs(s) <= -curvature * slope || (t >= longest && s < 0)) return t;
            if (s * (bracketed ? high - low : 1) >= 0) { high = low; f_high = f_low; slope_high = slope_low; bracketed = 1; }
            low = t; f_low = q->f; slope_low = s;
        }
        if (!bracketed) {
            t = 4 * t < longest ? 4 * t : longest;
        } else { /* minimum of the cubic through both ends, well inside; the middle where that fails */
            double width = high - low, theta, radical, next = low + 0.5 * width;
            if (ms__finite(f_high) && width != 0) {
                theta = 3 * (f_low - f_high) / width + slope_low + slope_high;
                radical = theta * theta - slope_low * slope_high;
                if (radical >= 0) {
                    double root = sqrt(radical) * (width > 0 ? 1 : -1), below = slope_high - slope_low + 2 * root;
                    if (below != 0) next = high - width * (slope_high + root - theta) / below;
                }
            } else if (width != 0) {
                next = low + 0.1 * width;
            }
            t = (next - low) / width > 0.05 && (next - low) / width < 0.95 ? next : low + (ms__finite(f_high) ? 0.5 : 0.1) * width;
            if (fabs(width) <= 1e-15 * (fabs(low) + fabs(high))) break;
        }
    }
    /* rounding or noise: the best bracketed point will do if it is lower at all */
    if (low > 0 && f_low < p->f && !run->stopped) {
        for (j = 0; j < n; ++j) {
            q->x[j] = p->x[j] + low * d[j];
            if (!run->barrier) q->x[j] = ms_pme__clip(q->x[j], run->lower[j], run->upper[j]);
        }
        q->f = ms_pme__gradient(run, q->x, q->g);
        if (q->f < p->f) return low;
    }
    return 0;
}

/* The longest step along d inside the box. */
static double ms_pme__longest_step(const ms_pme__run *run, const double *x, const double *d)
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

/* ---- quasi-Newton, conjugate gradient, SQP ---------------------------------------------------------------------------- */

/* d = -H g on the variables that no bound holds, H from the last pairs by the two-loop recursion (Nocedal 1980). */
static void ms_pme__lbfgs_direction(const ms_pme__run *run, const ms_pme__point *p, const double *s, const double *y,
                                    int newest, int count, double *d)
{
    int n = run->n, j, k;
    double alpha[MS_PME__MEMORY], rho[MS_PME__MEMORY];
    for (j = 0; j < n; ++j) d[j] = ms_pme__held(run, p->x, p->g, j) ? 0 : -p->g[j];
    for (k = 0; k < count; ++k) {
        int at = (newest - k + MS_PME__MEMORY) % MS_PME__MEMORY;
        double sy = 0, sd = 0;
        for (j = 0; j < n; ++j)
            if (!ms_pme__held(run, p->x, p->g, j)) {
                sy += s[at * n + j] * y[at * n + j];
                sd += s[at * n + j] * d[j];
            }
        rho[k] = sy;
        alpha[k] = sy > 0 ? sd / sy : 0;
        for (j = 0; j < n; ++j)
            if (!ms_pme__held(run, p->x, p->g, j)) d[j] -= alpha[k] * y[at * n + j];
    }
    if (count > 0) {
        double yy = 0;
        for (j = 0; j < n; ++j)
            if (!ms_pme__held(run, p->x, p->g, j)) yy += y[newest * n + j] * y[newest * n + j];
        if (rho[0] > 0 && yy > 0)
            for (j = 0; j < n; ++j) d[j] *= rho[0] / yy;
    }
    for (k = count - 1; k >= 0; --k) {
        int at = (newest - k + MS_PME__MEMORY) % MS_PME__MEMORY;
        double yd = 0;
        if (!(rho[k] > 0)) continue;
        for (j = 0; j < n; ++j)
            if (!ms_pme__held(run, p->x, p->g, j)) yd += y[at * n + j] * d[j];
        for (j = 0; j < n; ++j)
            if (!ms_pme__held(run, p->x, p->g, j)) d[j] += (alpha[k] - yd / rho[k]) * s[at * n + j];
    }
}

/* Damped BFGS update of the dense model B (Powell 1978). */
static void ms_pme__bfgs_update(double *model, int n, const double *s, const double *y, double *bs)
{
    double sy = ms_pme__dot(s, y, n), sbs = 0, theta = 1, sr;
    int i, j;
    for (i = 0; i < n; ++i) {
        bs[i] = ms_pme__dot(model + i * n, s, n);
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
static int ms_pme__sqp_direction(const ms_pme__run *run, const ms_pme__point *p, const double *model, double *d, double *work)
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
        low[i] = run->barrier ? -MS_PME__INF : run->lower[i] - p->x[i];
        high[i] = run->barrier ? MS_PME__INF : run->upper[i] - p->x[i];
        state[i] = !ms_pme__held(run, p->x, p->g, i) ? 0 : low[i] >= 0 ? -1 : 1;
    }
    ms_pme__bounded_least_squares(a, b, n, n, low, high, d, state, rest);
    return 1;
}

/* L-BFGS, conjugate gradient and SQP differ in their direction alone. */
static double ms_pme__gradient_method(ms_pme__run *run, double *x, int method, double *memory)
{
    int n = run->n, i, j, count = 0, newest = 0, fresh = 1;
    double *d = memory, *s = d + n, *y = s + MS_PME__MEMORY * n, *model = y + MS_PME__MEMORY * n, *work = model + n * n;
    double previous = 0, gain = 0;
    ms_pme__point p, q;
    p.x = work;
    p.g = p.x + n;
    q.x = p.g + n;
    q.g = q.x + n;
    work = q.g + n;
    ms_pme__copy(p.x, x, n);
    p.f = ms_pme__gradient(run, p.x, p.g);
    while (!run->stopped && ms__finite(p.f)) {
        double step, longest, slope, steep = 0, first = 1, sy = 0, size = 0, moved = 0;
        run->result.projected_gradient = ms_pme__projected_gradient(run, p.x, p.g);
        if (!(run->result.projected_gradient > 0)) break;
        if (fresh) { /* the model starts as the gradient, or the identity */
            for (i = 0; i < n * n; ++i) model[i] = i % (n + 1) == 0;
            count = 0;
        }
        if (method == MS_PME_SQP) {
            if (!ms_pme__sqp_direction(run, &p, model, d, work)) {
                if (fresh) break;
                fresh = 1;
                continue;
            }
        } else if (method == MS_PME_CONJUGATE_GRADIENT) {
            double now = 0, along = 0; /* Polak-Ribiere+ over the variables that may move */
            for (j = 0; j < n; ++j)
                if (!ms_pme__held(run, p.x, p.g, j)) {
                    now += p.g[j] * p.g[j];
                    along += p.g[j] * (p.g[j] - y[j]);
                }
            for (j = 0; j < n; ++j) {
                double beta = !fresh && previous > 0 ? ms_pme__max(along / previous, 0) : 0;
                d[j] = ms_pme__held(run, p.x, p.g, j) ? 0 : -p.g[j] + beta * d[j];
                y[j] = p.g[j];
            }
            previous = now;
        } else {
            ms_pme__lbfgs_direction(run, &p, s, y, newest, count, d);
        }
        for (j = 0; j < n && !run->barrier; ++j) /* no pushing against a bound */
            if ((p.x[j] <= run->lower[j] && d[j] < 0) || (p.x[j] >= run->upper[j] && d[j] > 0)) d[j] = 0;
        for (j = 0; j < n; ++j)
            if (d[j] != 0) steep += p.g[j] * p.g[j];
        slope = ms_pme__dot(p.g, d, n);
        if (!(slope < -1e-12 * sqrt(steep * ms_pme__dot(d, d, n)))) { /* (a NaN too) */
            if (fresh) break;
            fresh = 1;
            continue;
        }
        longest = ms_pme__longest_step(run, p.x, d);
        if (fresh) { /* no idea of the scale yet: a step of 1% of the box, or what the last gain suggests */
            double reach = 0;
            for (j = 0; j < n; ++j) {
                double range = run->upper[j] - run->lower[j];
                reach = ms_pme__max(reach, fabs(d[j]) / (ms__finite(range) && range > 0 ? range : ms_pme__max(fabs(p.x[j]), 1)));
            }
            first = reach > 0 ? 0.01 / reach : 1;
        } else if (method == MS_PME_CONJUGATE_GRADIENT) {
            first = gain > 0 ? 1.01 * 2 * gain / -slope : 1;
        }
        step = ms_pme__line_search(run, &p, d, first, longest, method == MS_PME_CONJUGATE_GRADIENT ? 0.1 : 0.9, &q);
        if (step == 0) {
            if (fresh || run->stopped) break;
            fresh = 1; /* once more along the gradient */
            continue;
        }
        gain = p.f - q.f;
        newest = (newest + 1) % MS_PME__MEMORY;
        for (j = 0; j < n; ++j) {
            double sj = q.x[j] - p.x[j], yj = q.g[j] - p.g[j];
            if (step >= longest && d[j] != 0 && !run->barrier) { /* all that reach their bound together land on it */
                double bound = d[j] > 0 ? run->upper[j] : run->lower[j];
                if ((bound - p.x[j]) / d[j] <= longest * (1 + 1e-9)) q.x[j] = bound;
            }
            if (method != MS_PME_CONJUGATE_GRADIENT) {
                s[newest * n + j] = sj;
                y[newest * n + j] = yj;
            }
            sy += sj * yj;
            moved = ms_pme__max(moved, fabs(sj));
            size = ms_pme__max(size, fabs(q.x[j]));
        }
        if (method == MS_PME_SQP) {
            if (fresh && sy > 0) /* size of the first model (Shanno and Phua 1978) */
                for (i = 0; i < n; ++i)
                    model[i * (n + 1)] = ms_pme__dot(y + newest * n, y + newest * n, n) / sy;
            ms_pme__bfgs_update(model, n, s + newest * n, y + newest * n, work);
        } else if (method == MS_PME_LBFGS) {
            double yy = ms_pme__dot(y + newest * n, y + newest * n, n);
            if (sy > 1e-14 * yy) count = count < MS_PME__MEMORY ? count + 1 : count;
            else newest = (newest + MS_PME__MEMORY - 1) % MS_PME__MEMORY;
        }
        run->result.iterations++;
        i = fresh;
        fresh = 0;
        ms_pme__copy(p.x, q.x, n);
        ms_pme__copy(p.g, q.g, n);
        p.f = q.f;
        if (gain <= run->tolerance * (fabs(p.f) + DBL_MIN) && moved <= run->tolerance * size) break;
        if (gain <= 1e-16 * fabs(p.f)) {
            if (i) break;
            fresh = 1;
        }
    }
    ms_pme__copy(x, p.x, n);
    return p.f;
}

/* ---- Nelder-Mead -------------------------------------------------------------------------------------------------------- */

/* Nelder and Mead 1965 with the customary coefficients 1, 2, 1/2, 1/2; a simplex that collapsed is built anew around
   the best point until that gains nothing. */
static double ms_pme__nelder_mead(ms_pme__run *run, double *x, int barrier, double *memory)
{
    int n = run->n, i, j, rounds;
    double *vertex = memory, *value = vertex + (n + 1) * n, *middle = value + n + 1, *trial = middle + n, *farther = trial + n;
    double best_before = MS_PME__INF;
    for (rounds = 0; !run->stopped; ++rounds) {
        double edge = run->options->start_step > 0 ? run->options->start_step : 0.1;
        for (i = 0; i <= n; ++i) {
            double *v = vertex + i * n;
            ms_pme__copy(v, x, n);
            if (i > 0) {
                double range = run->upper[i - 1] - run->lower[i - 1], *c = &v[i - 1];
                if (barrier) {
                    *c = *c != 0 ? 1.05 * *c : 0.00025;
                } else {
                    double h = edge * (ms__finite(range) ? range : ms_pme__max(fabs(*c), 1));
                    *c = *c + h <= run->upper[i - 1] ? *c + h : ms_pme__max(*c - h, run->lower[i - 1]);
                }
            }
            value[i] = ms_pme__value(run, v);
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
                    spread = ms_pme__max(spread, fabs(vertex[i * n + j] - vertex[low * n + j]));
                    size = ms_pme__max(size, fabs(vertex[low * n + j]));
                }
            if ((value[high] - value[low] <= run->tolerance * fabs(value[low]) && spread <= 1e-4 * ms_pme__max(size, 1e-30)) ||
                spread <= 1e-14 * ms_pme__max(size, 1e-290))
                break;
            run->result.iterations++;
            for (j = 0; j < n; ++j) {
                middle[j] = 0;
                for (i = 0; i <= n; ++i)
                    if (i != high) middle[j] += vertex[i * n + j];
                middle[j] /= n;
                trial[j] = middle[j] + (middle[j] - vertex[high * n + j]);
                if (!barrier) trial[j] = ms_pme__clip(trial[j], run->lower[j], run->upper[j]);
            }
            f_trial = ms_pme__value(run, trial);
            if (f_trial < value[low]) { /* expand */
                for (j = 0; j < n; ++j) {
                    farther[j] = middle[j] + 2 * (middle[j] - vertex[high * n + j]);
                    if (!barrier) farther[j] = ms_pme__clip(farther[j], run->lower[j], run->upper[j]);
                }
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
            for (j = 0; j < n; ++j)
                farther[j] = middle[j] + 0.5 * ((inside ? vertex[high * n + j] : trial[j]) - middle[j]);
            f_far = ms_pme__value(run, farther);
            if (f_far < (inside ? value[high] : f_trial)) {
                ms_pme__copy(vertex + high * n, farther, n);
                value[high] = f_far;
                continue;
            }
            for (i = 0; i <= n && !run->stopped; ++i) { /* shrink */
                if (i == low) continue;
                for (j = 0; j < n; ++j)
                    vertex[i * n + j] = vertex[low * n + j] + 0.5 * (vertex[i * n + j] - vertex[low * n + j]);
                value[i] = ms_pme__value(run, vertex + i * n);
            }
        }
        ms_pme__copy(x, run->best, n);
        if (barrier || run->best_value >= best_before - run->tolerance * fabs(best_before)) break;
        best_before = run->best_value;
    }
    return run->best_value;
}

/* ---- basin hopping ------------------------------------------------------------------------------------------------------- */

static double ms_pme__local(ms_pme__run *run, double *x, double *memory)
{
    return run->function->residuals != NULL ? ms_pme__levenberg_marquardt(run, x, memory)
                                            : ms_pme__gradient_method(run, x, MS_PME_LBFGS, memory);
}

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

/* Wales and Doye 1997. The temperature follows the scatter of the minima seen; the hop is tuned to accept half. */
static double ms_pme__basin_hopping(ms_pme__run *run, double *x, double *memory)
{
    int n = run->n, j, hops, accepted = 0;
    double *here = memory, *trial = here + n, hop = run->options->start_step > 0 ? run->options->start_step : 0.25;
    double f_here, temperature = 0;
    memory = trial + n;
    ms_pme__copy(here, x, n);
    f_here = ms_pme__local(run, here, memory);
    for (hops = 1; !run->stopped; ++hops) {
        double f_trial, rise;
        for (j = 0; j < n; ++j) {
            double range = run->upper[j] - run->lower[j], u = 2 * ms__rng_uniform(&run->rng) - 1;
            trial[j] = here[j] + hop * u * (ms__finite(range) ? range : ms_pme__max(fabs(here[j]), 1));
            trial[j] = ms_pme__clip(trial[j], run->lower[j], run->upper[j]);
        }
        f_trial = ms_pme__local(run, trial, memory);
        if (!ms__finite(f_trial)) continue;
        rise = f_trial - f_here;
        temperature += (0.5 * fabs(rise) - temperature) / hops;
        if (rise <= 0 || ms__rng_uniform(&run->rng) < exp(-rise / (temperature > 0 ? temperature : 1))) {
            ms_pme__copy(here, trial, n);
            f_here = f_trial;
            ++accepted;
        }
        if (hops % 10 == 0) hop = ms_pme__clip(2 * accepted > hops ? hop / 0.9 : hop * 0.9, 0.01, 1);
    }
    ms_pme__copy(x, run->best, n);
    return run->best_value;
}

/* The chosen method from x. Restarts are Levenberg-Marquardt's, from starts [count][n] first, then from random points. */
static void ms_pme__method(ms_pme__run *run, double *x, const double *starts, int count, double *memory)
{
    int restart;
    switch (run->options->method) {
    case MS_PME_NELDER_MEAD: ms_pme__nelder_mead(run, x, 0, memory); break;
    case MS_PME_NELDER_MEAD_BARRIER: ms_pme__nelder_mead(run, x, 1, memory); break;
    case MS_PME_LBFGS:
    case MS_PME_CONJUGATE_GRADIENT:
    case MS_PME_SQP: ms_pme__gradient_method(run, x, run->options->method, memory); break;
    case MS_PME_BASIN_HOPPING: ms_pme__basin_hopping(run, x, memory); break;
    default:
        ms_pme__local(run, x, memory);
        for (restart = 0; restart < run->options->restarts && !run->stopped; ++restart) {
            double best = run->best_value, tolerance = run->tolerance;
            if (restart < count) ms_pme__copy(x, starts + (size_t)restart * (size_t)run->n, run->n);
            else ms_pme__random_point(run, run->best, x);
            run->tolerance = ms_pme__max(tolerance, 1e-3); /* roughly at first, to the end where it leads further */
            ms_pme__local(run, x, memory);
            run->tolerance = tolerance;
            if (run->best_value < best) {
                ms_pme__copy(x, run->best, run->n);
                ms_pme__local(run, x, memory);
            }
        }
    }
}

/* ---- public: minimize ----------------------------------------------------------------------------------------------------- */

MS_API ms_pme_options ms_pme_defaults(void)
{
    ms_pme_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_API const char *ms_pme_method_string(int method)
{
    static const char *const name[] = {"levenberg-marquardt", "nelder-mead", "nelder-mead-barrier", "l-bfgs",
                                       "conjugate-gradient", "sqp", "basin-hopping"};
    return method >= 0 && method <= MS_PME_BASIN_HOPPING ? name[method] : "unknown";
}

static ms_status ms_pme__check(const ms_pme_function *function, const ms_pme_options *options, const double *x, ms_error *error)
{
    int j;
    if (function == NULL || x == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "function or x is NULL");
    if (function->residuals == NULL && function->value == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "neither residuals nor value is given");
    if (function->parameter_count < 1 || function->parameter_count > MS_PME_PARAMETERS_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter_count is %d, expected 1 to %d", function->parameter_count,
                        MS_PME_PARAMETERS_MAX);
    if (function->residuals != NULL && function->residual_count < 1)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "residual_count is 0");
    if (options->method < 0 || options->method > MS_PME_BASIN_HOPPING)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "method %d is not one of ms_pme_method", options->method);
    if (!(options->max_cost >= 0) || !(options->max_seconds >= 0) || !(options->tolerance >= 0) ||
        !(options->start_step >= 0) || !(options->difference_step >= 0) || !(options->target_value >= 0) ||
        !(function->jacobian_cost >= 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "an option is negative or NaN");
    for (j = 0; j < function->parameter_count; ++j) {
        double low = function->lower ? function->lower[j] : -MS_PME__INF, high = function->upper ? function->upper[j] : MS_PME__INF;
        if (!(low <= high) || low == MS_PME__INF || high == -MS_PME__INF)
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j, "bounds of parameter %d are %g and %g: no number between them",
                            j, low, high);
        if (!ms__finite(x[j]))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)j, "start of parameter %d is %g, expected a finite number", j, x[j]);
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
    run->barrier = options->barrier;
    run->max_cost = options->max_cost > 0 ? options->max_cost : 1000;
    run->tolerance = options->tolerance > 0 ? options->tolerance : 1e-10;
    run->jacobian_cost = function->jacobian_cost > 0 ? function->jacobian_cost : 1 + 0.25 * n;
    run->best_value = MS_PME__INF;
    run->result.projected_gradient = -1;
    run->rng = ms__rng_make(options->seed, 0x706d65);
    run->start_time = options->max_seconds > 0 ? ms_pme__seconds(options) : 0;
    count = ms__size_add(ms__size_mul(m, un), 2 * m); /* jacobian, residual twice */
    count = ms__size_add(count, 3 * un + (un + 1) * (un + 1) + MS_PME__ROWS * (un + 1)); /* bounds, best, triangle, rows */
    count = ms__size_add(count, 7 * un * un + (2 * MS_PME__MEMORY + 40) * un + 64);       /* scratch of the methods */
    *size = ms__size_mul(count, sizeof(double));
    *block = ms__alloc(&options->allocator, *size);
    if (*block == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z residuals times %d parameters", m, n);
    p = (double *)*block;
    run->jacobian = p; p += m * un;
    run->residual = p; p += m;
    run->residual_step = p; p += m;
    run->lower = p; p += n;
    run->upper = p; p += n;
    run->best = p; p += n;
    run->triangle = p; p += (n + 1) * (n + 1);
    run->rows = p; p += MS_PME__ROWS * (n + 1);
    run->scratch = p;
    for (j = 0; j < n; ++j) {
        run->lower[j] = function->lower ? function->lower[j] : -MS_PME__INF;
        run->upper[j] = function->upper ? function->upper[j] : MS_PME__INF;
    }
    return MS_OK;
}

MS_API ms_status ms_pme_minimize(const ms_pme_function *function, const ms_pme_options *options, double *x,
                                 ms_pme_result *result, ms_error *error)
{
    ms_pme_options defaults = ms_pme_defaults();
    ms_pme__run run;
    void *block;
    size_t size;
    double *start, *memory;
    int n, j;
    ms_status status;
    if (options == NULL) options = &defaults;
    status = ms_pme__check(function, options, x, error);
    if (status == MS_OK) status = ms_pme__begin(&run, function, options, &block, &size, error);
    if (status != MS_OK) return status;
    n = run.n;
    start = run.scratch + n; /* scratch itself starts with the moved point of a difference */
    memory = start + n;
    for (j = 0; j < n; ++j) start[j] = ms_pme__clip(x[j], run.lower[j], run.upper[j]);
    ms_pme__method(&run, start, NULL, 0, memory);
    if (run.status != MS_OK) {
        status = ms__fail(error, run.status, 0, run.status == MS_CANCELLED ? "cancelled after %g evaluations"
                                                                          : "the function failed after %g evaluations",
                          run.result.cost);
    } else if (!ms__finite(run.best_value)) {
        status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "no finite value within %g evaluations of the start", run.result.cost);
    } else {
        run.result.value = run.best_value;
        ms_pme__copy(x, run.best, n);
        if (result != NULL) *result = run.result;
    }
    ms__release(&options->allocator, block, size);
    return status;
}

/* ---- public: match ---------------------------------------------------------------------------------------------------------- */

/* The image as a sum of squares: r_i = sqrt(w_i / sum w) (phi_i - t_i), so that f is the squared weighted RMSE. */
typedef struct ms_pme__picture {
    const ms_pme_renderer *renderer;
    const float *target, *weight;
    double weight_sum;
    float *image;    /* [p] */
    float *jacobian; /* [p][n], only with renderer->jacobian */
} ms_pme__picture;

static ms_status ms_pme__picture_residuals(void *user, const double *x, double *r, double *jacobian)
{
    ms_pme__picture *picture = (ms_pme__picture *)user;
    const ms_pme_renderer *renderer = picture->renderer;
    size_t i, n = (size_t)renderer->parameter_count, j;
    ms_status status = jacobian == NULL ? renderer->render(renderer->user, x, picture->image)
                                        : renderer->jacobian(renderer->user, x, picture->image, picture->jacobian);
    if (status != MS_OK) return status;
    for (i = 0; i < renderer->image_size; ++i) {
        double w = picture->weight ? (double)picture->weight[i] : 1, s = sqrt(w / picture->weight_sum);
        r[i] = w > 0 ? s * ((double)picture->image[i] - (double)picture->target[i]) : 0;
        if (jacobian != NULL)
            for (j = 0; j < n; ++j) jacobian[i * n + j] = w > 0 ? s * (double)picture->jacobian[i * n + j] : 0;
    }
    return MS_OK;
}

/* The caller's reduced function in the same unit: f = (sum of squares + offset) / sum w. */
typedef struct ms_pme__reduced {
    const ms_pme_function *function;
    double scale;
} ms_pme__reduced;

static ms_status ms_pme__reduced_residuals(void *user, const double *x, double *r, double *jacobian)
{
    const ms_pme__reduced *reduced = (const ms_pme__reduced *)user;
    const ms_pme_function *function = reduced->function;
    size_t i, m = function->residual_count, n = (size_t)function->parameter_count;
    ms_status status = function->residuals(function->user, x, r, jacobian);
    if (status != MS_OK) return status;
    for (i = 0; i < m; ++i) r[i] *= reduced->scale;
    if (jacobian != NULL)
        for (i = 0; i < m * n; ++i) jacobian[i] *= reduced->scale;
    return MS_OK;
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

static ms_status ms_pme__check_picture(const ms_pme_renderer *renderer, const float *target, const float *weight,
                                       const ms_pme_match_options *options, double *weight_sum, ms_error *error)
{
    size_t i;
    int positive = 0;
    if (renderer == NULL || target == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "renderer or target is NULL");
    if (renderer->render == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "renderer->render is NULL");
    if (renderer->image_size < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "image_size is 0");
    if (renderer->prediction_count < 0 || (renderer->prediction_count > 0 && renderer->predict == NULL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "prediction_count is %d without a callback", renderer->prediction_count);
    if (options->candidate_count < 0 || options->random_count < 0 || (options->candidate_count > 0 && options->candidates == NULL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "candidate_count or random_count is negative, or candidates is NULL");
    if (!(options->target_rmse >= 0)) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "target_rmse is negative or NaN");
    if (renderer->reduced != NULL && (renderer->reduced->residuals == NULL || !ms__finite(renderer->reduced_offset) ||
                                      renderer->reduced->parameter_count != renderer->parameter_count))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the reduced function lacks residuals or has other parameters");
    *weight_sum = 0;
    for (i = 0; i < renderer->image_size; ++i) {
        double w = weight ? (double)weight[i] : 1;
        if (!ms__finite(w) || w < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "weight %z is %g, expected a finite number >= 0", i, w);
        if (w > 0 && !ms__finite_f(target[i]))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "target %z is %g, expected a finite number", i, (double)target[i]);
        positive |= w > 0;
        *weight_sum += w;
    }
    if (!positive) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "every weight is 0: nothing to match");
    return MS_OK;
}

MS_API ms_status ms_pme_match(const ms_pme_renderer *renderer, const float *target, const float *weight,
                              const ms_pme_match_options *options, double *x, float *image, ms_pme_match_result *result,
                              ms_error *error)
{
    ms_pme_match_options defaults = ms_pme_match_defaults();
    ms_pme_options refine;
    ms_pme_match_result answer;
    ms_pme_function function;
    ms_pme__picture picture;
    ms_pme__reduced reduced;
    ms_pme__run run;
    void *block = NULL, *pictures = NULL;
    size_t size = 0, pictures_size = 0, p;
    double *candidate, *memory, *pool, *pool_value, offset = 0, weight_sum = 0, middle[MS_PME_PARAMETERS_MAX], low[MS_PME_PARAMETERS_MAX],
        high[MS_PME_PARAMETERS_MAX];
    int n, i, j, total, pool_size, kept = 0;
    ms_status status;

    if (options == NULL) options = &defaults;
    status = ms_pme__check_picture(renderer, target, weight, options, &weight_sum, error);
    if (status != MS_OK) return status;
    if (x == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "x is NULL");
    n = renderer->parameter_count;
    p = renderer->image_size;

    /* the function, its bounds and its budget */
    memset(&function, 0, sizeof function);
    memset(&answer, 0, sizeof answer);
    picture.renderer = renderer;
    picture.target = target;
    picture.weight = weight;
    picture.weight_sum = weight_sum;
    function.user = &picture;
    function.parameter_count = n;
    function.residual_count = p;
    function.residuals = ms_pme__picture_residuals;
    function.residuals_only = renderer->jacobian == NULL;
    function.jacobian_cost = renderer->jacobian_cost;
    if (renderer->reduced != NULL) {
        reduced.function = renderer->reduced;
        reduced.scale = 1 / sqrt(weight_sum);
        offset = renderer->reduced_offset / weight_sum;
        function.user = &reduced;
        function.residual_count = renderer->reduced->residual_count;
        function.residuals = ms_pme__reduced_residuals;
        function.residuals_only = renderer->reduced->residuals_only;
        function.jacobian_cost = renderer->reduced->jacobian_cost;
    }
    refine = options->refine;
    if (!(refine.max_cost > 0) && !(refine.max_cost < 0)) refine.max_cost = 50;
    if (function.residuals_only && !(refine.difference_step > 0)) refine.difference_step = 1e-3; /* a float32 picture */
    refine.target_value = options->target_rmse * options->target_rmse - offset;
    if (!(refine.target_value > 0)) refine.target_value = 0;
    for (j = 0; j < n && n <= MS_PME_PARAMETERS_MAX; ++j) {
        low[j] = renderer->lower ? renderer->lower[j] : 0;
        high[j] = renderer->upper ? renderer->upper[j] : 1;
        middle[j] = ms__finite(low[j]) && ms__finite(high[j]) ? 0.5 * (low[j] + high[j]) : ms_pme__clip(0, low[j], high[j]);
    }
    function.lower = low;
    function.upper = high;
    if (n >= 1 && n <= MS_PME_PARAMETERS_MAX) status = ms_pme__check(&function, &refine, middle, error);
    else status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "parameter_count is %d, expected 1 to %d", n, MS_PME_PARAMETERS_MAX);
    if (status != MS_OK) return status;

    /* memory: the run; the candidates to restart from, one picture and, where there is one, its Jacobian */
    total = renderer->prediction_count + options->candidate_count + options->random_count;
    pool_size = refine.restarts > 0 && refine.restarts < total ? refine.restarts + 1 : refine.restarts > 0 && total > 0 ? total : 1;
    pictures_size = ms__size_mul(ms__size_mul(p, renderer->jacobian != NULL && renderer->reduced == NULL ? (size_t)n + 1 : 1),
                                 sizeof(float));
    pictures_size = ms__size_add(pictures_size, ms__size_mul((size_t)pool_size * ((size_t)n + 1), sizeof(double)));
    pictures = ms__alloc(&refine.allocator, pictures_size);
    if (pictures == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a picture of %z values", p);
    status = ms_pme__begin(&run, &function, &refine, &block, &size, error);
    if (status != MS_OK) {
        ms__release(&refine.allocator, pictures, pictures_size);
        return status;
    }
    pool = (double *)pictures; /* [pool_size][n], the best first */
    pool_value = pool + (size_t)pool_size * (size_t)n;
    picture.image = (float *)(void *)(pool_value + pool_size);
    picture.jacobian = picture.image + p;
    candidate = run.scratch + n;
    memory = candidate + n;
    for (j = 0, run.ranged = 1; j < n; ++j) run.ranged &= ms__finite(high[j] - low[j]);

    /* best of n: eq. (4.3), with the caller's candidates as further members of the pool, eq. (4.4) */
    run.max_cost = MS_PME__INF;
    answer.best_candidate = -1;
    for (i = 0; (i < total || (i == total && !ms__finite(run.best_value))) && run.status == MS_OK; ++i) {
        double before = run.best_value, value;
        int finite = 1;
        ms_pme__copy(candidate, middle, n);
        if (i < renderer->prediction_count) {
            ms_status answer_of_predict = renderer->predict(renderer->user, i, target, candidate);
            if (answer_of_predict != MS_OK) ms_pme__fail(&run, answer_of_predict);
        } else if (i < renderer->prediction_count + options->candidate_count) {
            ms_pme__copy(candidate, options->candidates + (size_t)(i - renderer->prediction_count) * (size_t)n, n);
        } else if (i < total) {
            ms_pme__random_point(&run, middle, candidate);
        }
        for (j = 0; j < n; ++j) {
            finite &= ms__finite(candidate[j]);
            candidate[j] = ms_pme__clip(candidate[j], low[j], high[j]);
        }
        if (finite) {
            value = ms_pme__value(&run, candidate);
            if (run.best_value < before) answer.best_candidate = i;
            for (j = kept < pool_size ? kept++ : pool_size; j > 0 && value < pool_value[j - 1]; --j)
                if (j < pool_size) {
                    pool_value[j] = pool_value[j - 1];
                    ms_pme__copy(pool + j * n, pool + (j - 1) * n, n);
                }
            if (j < pool_size) {
                pool_value[j] = value;
                ms_pme__copy(pool + j * n, candidate, n);
            }
            if (run.stopped && run.status == MS_OK && run.result.stop == MS_PME_STOP_TARGET) break;
        } else {
            answer.candidates_refused++;
        }
    }
    answer.cost = run.result.cost;
    if (run.status == MS_OK && !ms__finite(run.best_value))
        ms_pme__fail(&run, MS_INVALID_ARGUMENT);
    if (run.status == MS_OK) answer.rmse_initial = sqrt(ms_pme__max(run.best_value + offset, 0));

    /* refinement with a budget of its own, from the best; restarts take the next ones, then random points */
    if (run.status == MS_OK && !options->initial_only && !run.stopped) {
        memset(&run.result, 0, sizeof run.result);
        run.result.projected_gradient = -1;
        run.max_cost = refine.max_cost;
        ms_pme__copy(candidate, run.best, n);
        ms_pme__method(&run, candidate, pool + n, kept - 1, memory);
        answer.cost += run.result.cost;
    }

    /* what the picture really looks like at the answer */
    if (run.status == MS_OK) {
        ms_status rendered = renderer->render(renderer->user, run.best, picture.image);
        answer.cost += 1;
        if (rendered != MS_OK) {
            ms_pme__fail(&run, rendered);
        } else {
            double sum = 0;
            size_t k;
            for (k = 0; k < p; ++k) {
                double w = weight ? (double)weight[k] : 1, e = (double)picture.image[k] - (double)target[k];
                if (w > 0) sum += w * e * e;
            }
            answer.rmse = sqrt(sum / weight_sum);
            run.result.value = run.best_value + offset;
            answer.refine = run.result;
            ms_pme__copy(x, run.best, n);
            if (image != NULL) memcpy(image, picture.image, p * sizeof *image);
            if (result != NULL) *result = answer;
        }
    }
    if (run.status != MS_OK)
        status = ms__fail(error, run.status, 0,
                          run.status == MS_CANCELLED          ? "cancelled after %g renders"
                          : run.status == MS_INVALID_ARGUMENT ? "no candidate has a finite picture (%g renders)"
                                                              : "a callback failed after %g renders",
                          answer.cost);
    ms__release(&refine.allocator, block, size);
    ms__release(&refine.allocator, pictures, pictures_size);
    return status;
}

/* ---- public: sensitivity ---------------------------------------------------------------------------------------------------- */

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
    if (options == NULL) options = &defaults;
    unlimited = *options;
    unlimited.max_cost = 1e300;
    status = ms_pme__check(function, &unlimited, x, error);
    if (status != MS_OK) return status;
    if (function->residuals == NULL || singular_value == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "residuals or singular_value is NULL");
    status = ms_pme__begin(&run, function, &unlimited, &block, &size, error);
    if (status != MS_OK) return status;
    n = run.n;
    g = run.scratch + n;
    u = g + n; /* columns of R, stored as rows, and the accumulated rotations */
    v = u + n * n;
    ms_pme__linearize(&run, x);
    if (run.status == MS_OK && !ms_pme__factor(&run, g)) run.status = MS_BAD_DATA;
    if (run.status == MS_OK) {
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) {
                u[i * n + j] = j <= i ? run.triangle[j * (n + 1) + i] : 0;
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
                    for (k = 0; k < n; ++k) {
                        double p = u[i * n + k], q = u[j * n + k];
                        u[i * n + k] = cosine * p - sine * q;
                        u[j * n + k] = sine * p + cosine * q;
                        p = v[i * n + k];
                        q = v[j * n + k];
                        v[i * n + k] = cosine * p - sine * q;
                        v[j * n + k] = sine * p + cosine * q;
                    }
                }
        }
        for (i = 0; i < n; ++i) { /* largest first */
            int top = i;
            for (j = i, g[i] = -1; j < n; ++j) {
                double s = sqrt(ms_pme__dot(u + j * n, u + j * n, n));
                if (s > g[i]) { g[i] = s; top = j; }
            }
            for (k = 0; k < n && top != i; ++k) {
                double t = u[i * n + k];
                u[i * n + k] = u[top * n + k];
                u[top * n + k] = t;
                t = v[i * n + k];
                v[i * n + k] = v[top * n + k];
                v[top * n + k] = t;
            }
        }
        for (j = 0; j < n; ++j) {
            double variance = 0;
            for (k = 0; k < n; ++k) {
                double c = v[k * n + j];
                if (g[k] > 1e-12 * g[0]) variance += c * c / (g[k] * g[k]);
                else if (c * c > 1e-12) variance = MS_PME__INF;
            }
            if (deviation != NULL) deviation[j] = sqrt(variance);
            singular_value[j] = g[j];
        }
        if (direction != NULL) ms_pme__copy(direction, v, n * n);
    } else {
        status = ms__fail(error, run.status, 0, run.status == MS_BAD_DATA ? "a residual or a derivative is not finite"
                                                                         : "the function failed");
    }
    ms__release(&options->allocator, block, size);
    return status;
}

#undef MS_PME__INF
#undef MS_PME__MEMORY
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
