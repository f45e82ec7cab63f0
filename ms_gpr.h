/* ms_gpr.h - v0.1.0 - learn a material preference - MIT or public domain, see the end

   HEAD COMMENT GOES HERE
*/
#ifndef MS_GPR_H
#define MS_GPR_H
#include <stddef.h>
#include <stdint.h>

#define MS_GPR_VERSION_MAJOR 0
#define MS_GPR_VERSION_MINOR 1
#define MS_GPR_VERSION_PATCH 0
#define MS_GPR_VERSION 100 /* major * 10000 + minor * 100 + patch */
#define MS_GPR_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
#ifndef MS_COMMON
#define MS_COMMON 1 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__)
#define MS_API MS_DEF __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS_API MS_DEF
#endif

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
#if MS_COMMON != 1 /* outside the guard: catches two vendored releases in one file */
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---------------------------------------------------------------------------------------------------- MODEL */

#ifndef MS_GPR_API
#define MS_GPR_API MS_API
#endif

/* A Gaussian process that has seen n inputs of m dimensions and their scores. With d^2(a, b) = sum over k of
   ((a_k - b_k) / l_k)^2, scores are mean + N(0, K'), K'_ij = sf^2 exp(-d^2(x_i, x_j) / 2) + sn^2 delta_ij. */
typedef struct ms_gpr ms_gpr;

/* All zero: the defaults. */
typedef struct ms_gpr_options {
    double mean;            /* prior mean, in units of the scores */
    ms_simd simd;           /* a cap */
    ms_allocator allocator;
    ms_parallel parallel;   /* batches of predictions, and nothing else, are shared out to threads */
} ms_gpr_options;

/* A model whose hyperparameters are given.
   x      [n][m] row-major, any units; copied
   y      [n] scores; copied
   n      >= 0; a model of n = 0 predicts the prior
   m      >= 1
   theta  [m + 2]: log l_k for every dimension, log sf, log sn; l_k in units of x, sf and sn in units of y
   MS_BAD_DATA: a value of x or y that is not finite (position: its row, from 1). MS_INVALID_ARGUMENT: theta not finite.
   MS_NOT_CONVERGED: K' is not positive definite even with the largest jitter (see ms_gpr_jitter). MS_OUT_OF_MEMORY.
   *out is NULL unless MS_OK. Cost n^3 / 6 multiply-adds; memory n^2 + n m doubles. */
MS_GPR_API ms_status ms_gpr_create(const double *x, const double *y, int n, int m, const double *theta,
                                   const ms_gpr_options *options, ms_gpr **out, ms_error *error);

/* NULL is allowed. */
MS_GPR_API void ms_gpr_destroy(ms_gpr *gp);

/* Other hyperparameters [m + 2] for the same data. The model is unchanged unless MS_OK. */
MS_GPR_API ms_status ms_gpr_set_theta(ms_gpr *gp, const double *theta, ms_error *error);

/* One more scored point, x [m], at the cost of n^2; the hyperparameters stay. Equal to a new model of n + 1 points but for
   rounding. The model is unchanged unless MS_OK. */
MS_GPR_API ms_status ms_gpr_append(ms_gpr *gp, const double *x, double y, ms_error *error);

/* Forgets point `index`, at the cost of n^2: later points move up by one. */
MS_GPR_API ms_status ms_gpr_drop(ms_gpr *gp, int index, ms_error *error);

/* Drops dimensions that matter little, least first, while the sum of their relevances is at most `tolerance` (such as 0.02):
   "model only what a scene needs". The model of the rest is exact, as if the dropped length scales were infinite; predictions
   still take all m columns and ignore the dropped ones. kept: how many dimensions are left; NULL is allowed. */
MS_GPR_API ms_status ms_gpr_simplify(ms_gpr *gp, double tolerance, int *kept, ms_error *error);

/* How much each dimension matters, [m] out: the mean of ((a_k - b_k) / l_k)^2 over pairs of training inputs. Of a pair that
   differs in dimension k alone, the scores correlate by about exp(-relevance / 2). 0 for a dropped dimension. */
MS_GPR_API void ms_gpr_relevance(const ms_gpr *gp, double *relevance);

MS_GPR_API int ms_gpr_count(const ms_gpr *gp);               /* n */
MS_GPR_API int ms_gpr_dimensions(const ms_gpr *gp);          /* m */
MS_GPR_API const double *ms_gpr_theta(const ms_gpr *gp);     /* [m + 2]; a dropped dimension has log l_k = 700 */
MS_GPR_API const double *ms_gpr_inputs(const ms_gpr *gp);    /* [n][m], valid until the model changes */
MS_GPR_API const double *ms_gpr_scores(const ms_gpr *gp);    /* [n], as they were given */
MS_GPR_API double ms_gpr_mean(const ms_gpr *gp);             /* the prior mean */
MS_GPR_API double ms_gpr_zero_score(const ms_gpr *gp);       /* what a score of 0 is taken as; see ms_gpr_fit_options */
MS_GPR_API ms_simd ms_gpr_level(const ms_gpr *gp);           /* instruction set in use */

/* What had to be added to sn^2, in units of sf^2, to make K' positive definite in double precision: 0 nearly always, else a
   power of ten from 1e-15 to 1e-6. Results are those of the model with that noise. */
MS_GPR_API double ms_gpr_jitter(const ms_gpr *gp);

/* log p(y | X, theta), and where not NULL its gradient [m + 2] with respect to theta. Exact; allocates 3 n^2 doubles and costs
   n^3 / 2 + n^2 m multiply-adds with the gradient. Rasmussen & Williams 2006, (5.8), (5.9); thesis (3.7) with errata. */
MS_GPR_API ms_status ms_gpr_likelihood(const ms_gpr *gp, double *likelihood, double *gradient, ms_error *error);

/* What the model of the other n - 1 points says about each score.
   mean      [n] out, or NULL
   variance  [n] out, or NULL: of the score, with its noise
   density   out, or NULL: sum of log N(y_i; mean_i, variance_i)
   Rasmussen & Williams 2006, (5.10) to (5.12). */
MS_GPR_API ms_status ms_gpr_leave_one_out(const ms_gpr *gp, double *mean, double *variance, double *density, ms_error *error);

/* ------------------------------------------------------------------------------------------------------ FIT */

typedef enum ms_gpr_method {
    MS_GPR_METHOD_MAP = 0,   /* L-BFGS to the largest posterior: log-normal priors, three starts, probing of every dimension */
    MS_GPR_METHOD_ML = 1,    /* L-BFGS to the largest likelihood, one start */
    MS_GPR_METHOD_RPROP = 2, /* resilient backpropagation, one start, 100 evaluations: the thesis */
    MS_GPR_METHOD_SCG = 3    /* scaled conjugate gradient (Moller 1993), one start */
} ms_gpr_method;

/* All zero: the defaults. "Width" is sqrt(12) standard deviations: 1 for a column that is uniform on [0, 1]. */
typedef struct ms_gpr_fit_options {
    double floor_offset;    /* If every score is >= 0 and some are 0, zeros are taken as -floor_offset standard deviations, so that
                               dislike has room below "barely liked". 0: 0.5 for MAP, none otherwise. Negative: none */
    const double *start;    /* [m + 2] theta where the search starts; NULL: l_k = 0.25, 0.5 and 3 sqrt(m) widths for MAP,
                               length_start widths otherwise, sf = 1 and sn = 0.1 standard deviations */
    double length_start;    /* of the methods with one start, in widths; 0: 1 */
    double length_min;      /* bounds of l_k in widths; 0: 0.01 */
    double length_max;      /* 0: 1000 */
    double noise_min;       /* least sn in standard deviations of the scores; 0: 0.001 */
    int evaluations;        /* of the likelihood at most, a start; 0: 200, RProp 100 */
    int random_starts;      /* of MAP besides the three */
    uint64_t seed;          /* of those */
    ms_simd simd;
    ms_allocator allocator;
    ms_parallel parallel;   /* kept by the model for batches of predictions; the fit runs on the calling thread */
    ms_progress progress;   /* asked before every evaluation: 1 ms at n = 250, 0.1 s at n = 2000 */
} ms_gpr_fit_options;

typedef struct ms_gpr_fit_report {
    double likelihood;      /* log p(y | X, theta) of the scores as they were modelled */
    double objective;       /* the same plus the log prior of MAP */
    double jitter;          /* ms_gpr_jitter of the model */
    int evaluations;        /* of the likelihood, all starts and probes */
    int start;              /* the start that won, from 0 */
    int probes;             /* dimensions that probing switched on or off */
} ms_gpr_fit_report;

/* Learns theta, and makes the model with it. The prior mean is the mean of the scores.
   x, y, n, m  as in ms_gpr_create; n = 0, constant scores and constant columns are fine
   Several rounds: concatenate materials and scores of all rounds, and fit again (start: the theta of the last round, if speed
   matters). MS_CANCELLED; the rest as ms_gpr_create. report: or NULL. Bit-equal at one SIMD level. Memory 4 n^2 doubles. */
MS_GPR_API ms_status ms_gpr_fit(const double *x, const double *y, int n, int m, const ms_gpr_fit_options *options, ms_gpr **out,
                                ms_gpr_fit_report *report, ms_error *error);

/* ----------------------------------------------------------------------------------------------- PREDICTION */

/* Posterior mean and variance at `count` points.
   x         [count][m] row-major, units as in the training set
   mean      [count] out, units of y; NULL: not computed
   variance  [count] out, units of y squared, of the latent function: add sn^2 for that of a score; >= 0.
             NULL: not computed (then O(n m) a point instead of O(n^2))
   gp is only read: calls may overlap. Bit-equal for any thread count and batch size at one SIMD level; levels differ by rounding.
   MS_BAD_DATA: an x that is not finite (position: its row, from 1). MS_OUT_OF_MEMORY. Outputs are untouched then.
   Rasmussen & Williams 2006, algorithm 2.1, lines 4 to 6; thesis (3.4), (3.5). */
MS_GPR_API ms_status ms_gpr_predict(const ms_gpr *gp, const double *x, int count, double *mean, double *variance, ms_error *error);

/* The mean alone, in single precision: twice as fast. Its error is about 1e-6 sf^2 sum |alpha_i| k_i at worst; see the table
   in the head comment. */
MS_GPR_API ms_status ms_gpr_predict_f(const ms_gpr *gp, const float *x, int count, float *mean, ms_error *error);

/* Mean and variance at one point x [m] with their gradients [m]; any output may be NULL. */
MS_GPR_API ms_status ms_gpr_gradient(const ms_gpr *gp, const double *x, double *mean, double *mean_gradient, double *variance,
                                     double *variance_gradient, ms_error *error);

/* ---------------------------------------------------------------------------------------------------- FILES */

/* A model as bytes: the same on every machine, whatever its byte order and locale. Layout, little-endian: "ms_gpr\r\n", u32
   version 1, u32 n, u32 m, u32 0, then as f64 mean, zero score, theta [m + 2], x [n][m], y [n]; u64 FNV-1a of all before. */
MS_GPR_API size_t ms_gpr_save_size(const ms_gpr *gp);

/* Writes ms_gpr_save_size(gp) bytes. */
MS_GPR_API void ms_gpr_save(const ms_gpr *gp, void *bytes);

/* The model again. Strict: any other size, version, checksum or a value that is not finite is MS_BAD_DATA (position: the byte)
   or MS_UNSUPPORTED (a later version). Memory stays below 16 MB + 4 size^2 bytes of a valid file, checked before allocation. */
MS_GPR_API ms_status ms_gpr_load(const void *bytes, size_t size, const ms_gpr_options *options, ms_gpr **out, ms_error *error);

#ifndef MS_GPR_NO_STDIO
/* The same with a file; MS_IO where it can't be opened, read or written whole. */
MS_GPR_API ms_status ms_gpr_save_file(const ms_gpr *gp, const char *path, ms_error *error);
MS_GPR_API ms_status ms_gpr_load_file(const char *path, const ms_gpr_options *options, ms_gpr **out, ms_error *error);
#endif

/* ---------------------------------------------------------------------------------------- RECOMMENDATION */

/* --------------------------------------------------------------------------------------- ACTIVE LEARNING */

/* ------------------------------------------------------------------------------------------ LATENT SPACE */

/* -------------------------------------------------------------------------------------------------- MAPS */


#ifdef __cplusplus
}
#endif
#endif /* MS_GPR_H */

#if defined(MS_GPR_IMPLEMENTATION) && !defined(MS_GPR__PASS)
/* ms-common-private begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
#ifndef MS_COMMON_PRIVATE
#define MS_COMMON_PRIVATE
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* MS_NO_SIMD leaves the scalar text of every header. 32-bit x86 has no baseline that can be relied on. */
#if !defined(MS_NO_SIMD) && (defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC)))
#define MS__X64 1
#include <immintrin.h>
#if defined(_MSC_VER)
#include <intrin.h>
#else
#include <cpuid.h>
#endif
#elif !defined(MS_NO_SIMD) && (defined(__aarch64__) || defined(_M_ARM64))
#define MS__NEON 1
#include <arm_neon.h>
#endif

#ifndef MS_ASSERT /* checks of the library's own invariants, never of the caller's data */
#define MS_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__)
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

#if defined(MS__X64)
static MS__UNUSED void ms__cpuid(uint32_t leaf, uint32_t subleaf, uint32_t r[4])
{
#if defined(_MSC_VER)
    int v[4];
    __cpuidex(v, (int)leaf, (int)subleaf);
    r[0] = (uint32_t)v[0]; r[1] = (uint32_t)v[1]; r[2] = (uint32_t)v[2]; r[3] = (uint32_t)v[3];
#else
    __cpuid_count(leaf, subleaf, r[0], r[1], r[2], r[3]);
#endif
}

/* What both the processor and the operating system (OSXSAVE, XCR0) support. */
static MS__UNUSED int ms__simd_detect(void)
{
    uint32_t r[4], xcr0, leaf1;
    ms__cpuid(0, 0, r);
    if (r[0] < 7) return MS_SIMD_BASE;
    ms__cpuid(1, 0, r);
    leaf1 = r[2];
    if (!(leaf1 & (1u << 27))) return MS_SIMD_BASE; /* OSXSAVE */
#if defined(_MSC_VER)
    xcr0 = (uint32_t)_xgetbv(0);
#else
    {
        uint32_t high;
        __asm__ volatile("xgetbv" : "=a"(xcr0), "=d"(high) : "c"(0));
        (void)high;
    }
#endif
    ms__cpuid(7, 0, r);
    if ((xcr0 & 0x6u) != 0x6u || !(leaf1 & (1u << 12)) || !(leaf1 & (1u << 29)) || !(r[1] & (1u << 5)))
        return MS_SIMD_BASE; /* YMM state, FMA, F16C, AVX2 */
    if ((xcr0 & 0xe6u) != 0xe6u || (r[1] & 0xC0030000u) != 0xC0030000u)
        return MS_SIMD_AVX2; /* ZMM state, AVX-512 F, DQ, BW, VL */
    return MS_SIMD_AVX512;
}
#endif

/* The level to use under a cap. cpuid takes microseconds under a hypervisor: ask once when an object is made
   or at the start of a long call, never in a loop. Nothing is kept in a global. */
static MS__UNUSED ms_simd ms__simd_pick(ms_simd cap)
{
    int best = MS_SIMD_SCALAR;
    if (cap == MS_SIMD_SCALAR) return cap;
#if defined(MS__X64)
    best = cap == MS_SIMD_BASE ? MS_SIMD_BASE : ms__simd_detect();
#elif defined(MS__NEON)
    best = MS_SIMD_BASE;
#endif
    return (ms_simd)(cap != MS_SIMD_AUTO && (int)cap < best ? (int)cap : best);
}
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* -------------------------------------------------------------------------------------------- KERNEL TABLE */

#include <math.h>
#ifndef MS_GPR_NO_STDIO
#include <stdio.h>
#endif

/* Columns of every matrix and rows of every triangular one come in blocks of 8: n is padded with points that are
   independent of everything. One vector of the widest level fits, and no kernel has a remainder. */
#define MS_GPR__BLOCK 8
#define MS_GPR__CHUNK 64 /* candidates that are predicted together */
#define MS_GPR__SLAB 32  /* training points that meet them at a time: the tile of distances stays in the first cache */

/* Parts of a product that are known to be zero or not wanted. */
#define MS_GPR__UPPER 1 /* only c_ij with i <= j is wanted */
#define MS_GPR__LOWER 2 /* b_kj = 0 for k < j */

/* The inner loops, one table a level. Matrices are row-major with a stride; a is [depth][rows], b is [depth][columns], c is
   [rows][columns]; rows is a multiple of 4, columns of 8; pointers need no alignment. */
typedef struct ms_gpr__kernels {
    /* c -= a' b; parts: the sum of flags above, or 0 */
    void (*reduce)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride, int rows,
                   int columns, int depth, int parts);
    /* c_ij = sum over k of (a_ki - b_kj)^2, by direct differences; parts: 0 or UPPER */
    void (*distances)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride, int rows,
                      int columns, int depth, int parts);
    void (*distances_f)(float *c, size_t c_stride, const float *a, size_t a_stride, const float *b, size_t b_stride, int rows,
                        int columns, int depth, int parts);
    /* c_j = scale exp(-c_j / 2), j < columns */
    void (*exponentials)(double *c, int columns, double scale);
    /* mean_j += sum over i < rows of weight_i exp(-c_ij / 2) */
    void (*accumulate)(double *mean, const double *c, size_t c_stride, const double *weight, int rows, int columns);
    void (*accumulate_f)(float *mean, const float *c, size_t c_stride, const float *weight, int rows, int columns);
    /* 8 rows of b: b = u'^-1 b, u the upper triangle of an 8 x 8 block */
    void (*solve)(const double *u, size_t u_stride, double *b, size_t b_stride, int columns);
    /* w_j = (g_j + alpha_i alpha_j) k_j; returns their sum */
    double (*weights)(double *w, const double *g, const double *k, const double *alpha, double alpha_i, int columns);
    /* slope[8 k] to slope[8 k + 7] += partial sums over j of w_j (points[k stride + j] - place[k stride])^2, k < m */
    void (*slopes)(double *slope, const double *w, const double *points, size_t stride, const double *place, int m, int columns);
    void (*axpy)(double *y, double a, const double *x, int columns); /* y += a x */
    double (*dot)(const double *x, const double *y, int columns);
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
#define MS_GPR_FILENAME "ms_gpr.h" /* the header includes its kernels, once a level and precision; define it if the file is renamed */
#endif

#define MS_GPR__PASS 1
#define MS_GPR__FLOAT 1
#include MS_GPR_FILENAME
#define MS_GPR__FLOAT 0
#include MS_GPR_FILENAME
#undef MS_GPR__PASS

#if defined(MS__X64) || defined(MS__NEON)
#define MS_GPR__PASS 2
#define MS_GPR__FLOAT 1
#include MS_GPR_FILENAME
#define MS_GPR__FLOAT 0
#include MS_GPR_FILENAME
#undef MS_GPR__PASS
#endif

#if defined(MS__X64)
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
    ms_simd level = ms__simd_pick(cap);
    return level > MS_SIMD_AVX2 ? MS_SIMD_AVX2 : level;
}

static const ms_gpr__kernels *ms_gpr__kernels_of(ms_simd level)
{
#if defined(MS__X64)
    if (level == MS_SIMD_AVX2) return &ms_gpr__table_avx2;
#endif
#if defined(MS__X64) || defined(MS__NEON)
    if (level == MS_SIMD_BASE) return &ms_gpr__table_base;
#endif
    (void)level;
    return &ms_gpr__table_scalar;
}

/* ------------------------------------------------------------------------------------------ LINEAR ALGEBRA */

static int ms_gpr__padded(int n)
{
    return (n + MS_GPR__BLOCK - 1) / MS_GPR__BLOCK * MS_GPR__BLOCK;
}

/* Doubles from one row of an n x n matrix to the next: not a multiple of 512 bytes, or columns would share cache sets. */
static size_t ms_gpr__stride(int n)
{
    size_t stride = (size_t)ms_gpr__padded(n);
    return stride % 64 == 0 ? stride + MS_GPR__BLOCK : stride;
}

/* The first half of a triangular matrix that is split in two, in whole blocks. */
static int ms_gpr__half(int n)
{
    return ms_gpr__padded(n / 2);
}

/* b [n][columns] = u'^-1 b. Recursion halves n, so that its depth is log2(n / 8) and all work but the leaves is `reduce`. */
static void ms_gpr__forward(const ms_gpr__kernels *f, const double *u, size_t u_stride, int n, double *b, size_t b_stride, int columns)
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

/* y = u'^-1, the lower triangle of y; its upper triangle is set to 0 inside the blocks on the diagonal and must be 0 elsewhere. */
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

/* Memory for doubles that starts on a cache line; `block` is what to release. */
static double *ms_gpr__doubles(const ms_allocator *allocator, size_t count, void **block)
{
    size_t size = ms__size_mul(ms__size_add(count, MS_GPR__BLOCK), sizeof(double));
    *block = ms__alloc(allocator, size);
    return *block ? (double *)(((uintptr_t)*block + 63) & ~(uintptr_t)63) : NULL;
}

static void ms_gpr__release_doubles(const ms_allocator *allocator, void *block, size_t count)
{
    ms__release(allocator, block, (count + MS_GPR__BLOCK) * sizeof(double));
}

/* ------------------------------------------------------------------------------------------------ MINIMISER */

/* f(q) and its gradient. 1: defined; 0: not defined here, the search steps back; -1: stop. */
typedef int (*ms_gpr__objective)(void *context, const double *q, double *value, double *gradient);

#define MS_GPR__MEMORY 10 /* pairs that L-BFGS remembers */

typedef struct ms_gpr__minimum {
    double value;     /* of the last q; HUGE_VAL: not even the start is defined */
    int evaluations;
    int stopped;      /* f asked to stop */
} ms_gpr__minimum;

/* How a search runs; q stays in the box [low, high] (NULL: no bounds). */
typedef struct ms_gpr__search {
    ms_gpr__objective f;
    void *context;
    int count;             /* of variables */
    const double *low, *high;
    double step;           /* no variable moves farther at a time; 0: 1e300 */
    double tolerance;      /* ends when an iteration gains less, and no projected slope is above its root */
    int evaluations;       /* at most */
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
static int ms_gpr__held(const ms_gpr__search *s, int i, double x, double slope)
{
    return (s->low && x <= s->low[i] && slope > 0) || (s->high && x >= s->high[i] && slope < 0);
}

/* Projected L-BFGS (Nocedal & Wright 2006, algorithm 7.4) with a backtracking line search along the projected path.
   q: start in, best out. work: ms_gpr__minimize_doubles(count). Never leaves q worse than it was. */
static ms_gpr__minimum ms_gpr__minimize(const ms_gpr__search *s, double *q, double *work)
{
    size_t n = (size_t)s->count;
    double *moves = work, *changes = moves + MS_GPR__MEMORY * n, *gradient = changes + MS_GPR__MEMORY * n, *direction = gradient + n,
           *trial = direction + n, *trial_gradient = trial + n, *rho = trial_gradient + n, *a = rho + MS_GPR__MEMORY;
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
            direction[i] = ms_gpr__held(s, i, q[i], gradient[i]) ? 0 : -gradient[i];
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
            if (ms_gpr__held(s, i, q[i], gradient[i])) direction[i] = 0;
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
            double *move = moves + (size_t)at * n, *change = changes + (size_t)at * n, curvature = 0, yy = 0, gain = best.value - value;
            for (i = 0, steepest = 0; i < s->count; ++i) {
                move[i] = trial[i] - q[i];
                change[i] = trial_gradient[i] - gradient[i];
                curvature += move[i] * change[i];
                yy += change[i] * change[i];
                q[i] = trial[i];
                gradient[i] = trial_gradient[i];
                if (!ms_gpr__held(s, i, q[i], gradient[i]) && fabs(gradient[i]) > steepest) steepest = fabs(gradient[i]);
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

/* ----------------------------------------------------------------------------------------------- LIKELIHOOD */

/* What one evaluation needs. Rows and columns behind n stand for points that are independent of everything. */
typedef struct ms_gpr__problem {
    const ms_gpr__kernels *kernels;
    int n, m;         /* m: dimensions in use */
    size_t stride;    /* of every matrix here */
    double *points;   /* [m][stride] inputs in length scales, by dimension */
    double *target;   /* [stride] scores less the prior mean */
    double *alpha;    /* [stride] K'^-1 target */
    double *kernel;   /* [n][stride] K, upper triangle */
    double *upper;    /* [n][stride] U, U'U = K'; later -K'^-1 */
    double *inverse;  /* [n][stride] U'^-1 */
    double *weight;   /* [stride] a row of dL/dK * K */
    double *slope;    /* [m][8] */
} ms_gpr__problem;

/* K, upper triangle: sf^2 exp(-d^2 / 2), 0 for padding. */
static void ms_gpr__covariance(const ms_gpr__kernels *f, const double *points, size_t stride, int n, int m, double sf2, double *kernel)
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
static int ms_gpr__factor(const ms_gpr__kernels *f, const double *kernel, size_t stride, int n, double sf2, double noise, double *upper)
{
    int padded = ms_gpr__padded(n), i;
    for (i = 0; i < padded; ++i) {
        size_t at = (size_t)i * stride + (size_t)(i / MS_GPR__BLOCK * MS_GPR__BLOCK);
        if (upper != kernel) memcpy(upper + at, kernel + at, ((size_t)i * stride + (size_t)padded - at) * sizeof *upper);
        upper[(size_t)i * stride + (size_t)i] = sf2 + noise;
    }
    return ms_gpr__cholesky(f, upper, stride, padded, n * 2.220446049250313e-16 * (sf2 + noise));
}

static double ms_gpr__log_determinant(const double *upper, size_t stride, int n)
{
    double sum = 0;
    int i;
    for (i = 0; i < n; ++i) sum += log(upper[(size_t)i * (stride + 1)]);
    return 2 * sum;
}

/* log p(y | X, theta) = -1/2 y' alpha - 1/2 log |K'| - n/2 log 2 pi, and its gradient [m + 2] with respect to log l_k, log sf,
   log sn (NULL: not wanted):  1/2 tr((alpha alpha' - K'^-1) dK'/dtheta). 0 where K' is not positive definite. */
static int ms_gpr__evaluate(const ms_gpr__problem *p, double sf2, double noise, double *likelihood, double *gradient)
{
    const ms_gpr__kernels *f = p->kernels;
    int padded = ms_gpr__padded(p->n), i, k;
    size_t row = (size_t)padded * sizeof(double);
    double trace = 0, kernel_sum = 0;
    ms_gpr__covariance(f, p->points, p->stride, p->n, p->m, sf2, p->kernel);
    if (!ms_gpr__factor(f, p->kernel, p->stride, p->n, sf2, noise, p->upper)) return 0;
    memcpy(p->alpha, p->target, row);
    ms_gpr__forward_vector(f, p->upper, p->stride, padded, p->alpha);
    *likelihood = -0.5 * (f->dot(p->alpha, p->alpha, padded) + ms_gpr__log_determinant(p->upper, p->stride, p->n) +
                          p->n * 1.8378770664093454836); /* log 2 pi */
    if (gradient == NULL) return 1;
    ms_gpr__backward_vector(f, p->upper, p->stride, padded, p->alpha);
    for (i = 0; i < padded; ++i) memset(p->inverse + (size_t)i * p->stride, 0, row);
    ms_gpr__invert(f, p->upper, p->stride, padded, p->inverse);
    for (i = 0; i < padded; ++i) memset(p->upper + (size_t)i * p->stride, 0, row);
    f->reduce(p->upper, p->stride, p->inverse, p->stride, p->inverse, p->stride, padded, padded, padded, MS_GPR__UPPER | MS_GPR__LOWER);
    memset(p->slope, 0, (size_t)p->m * MS_GPR__BLOCK * sizeof *p->slope);
    for (i = 0; i < p->n; ++i) {
        int block = i / MS_GPR__BLOCK * MS_GPR__BLOCK, j;
        size_t at = (size_t)i * p->stride;
        double own = p->alpha[i] * p->alpha[i] + p->upper[at + (size_t)i];
        for (j = block; j <= i; ++j) p->kernel[at + (size_t)j] = 0; /* each pair once; the diagonal has d = 0 */
        kernel_sum += f->weights(p->weight + block, p->upper + at + block, p->kernel + at + block, p->alpha + block, p->alpha[i],
                                 padded - block);
        f->slopes(p->slope, p->weight + block, p->points + block, p->stride, p->points + i, p->m, padded - block);
        trace += own;
    }
    for (k = 0; k < p->m; ++k) { /* dK_ij/dlog l_k = K_ij d_ijk^2; pairs count twice */
        const double *s = p->slope + MS_GPR__BLOCK * k;
        gradient[k] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
    gradient[p->m] = sf2 * trace + 2 * kernel_sum; /* dK/dlog sf = 2 K */
    gradient[p->m + 1] = noise * trace;            /* dK'/dlog sn = 2 sn^2 I */
    return 1;
}

static size_t ms_gpr__problem_doubles(int n, int m)
{
    size_t stride = ms_gpr__stride(n), padded = (size_t)ms_gpr__padded(n);
    size_t matrices = ms__size_mul(ms__size_mul(3, padded), stride);
    return ms__size_add(matrices, ms__size_add(ms__size_mul((size_t)m + 3, stride), ms__size_mul((size_t)m, MS_GPR__BLOCK)));
}

/* Lays a problem out in ms_gpr__problem_doubles(n, m) doubles; points and target are zero. */
static ms_gpr__problem ms_gpr__problem_make(const ms_gpr__kernels *kernels, int n, int m, double *memory)
{
    ms_gpr__problem p;
    size_t matrix;
    p.kernels = kernels;
    p.n = n;
    p.m = m;
    p.stride = ms_gpr__stride(n);
    matrix = (size_t)ms_gpr__padded(n) * p.stride;
    p.kernel = memory;
    p.upper = p.kernel + matrix;
    p.inverse = p.upper + matrix;
    p.points = p.inverse + matrix;
    p.target = p.points + (size_t)m * p.stride;
    p.alpha = p.target + p.stride;
    p.weight = p.alpha + p.stride;
    p.slope = p.weight + p.stride;
    memset(p.points, 0, (size_t)(m + 1) * p.stride * sizeof *p.points);
    return p;
}

/* ---------------------------------------------------------------------------------------------------- MODEL */

#define MS_GPR__DROPPED 700.0 /* log l_k of a dimension that is dropped: no exp of it overflows */
#define MS_GPR__N_MAX 30000   /* the matrix has 7 GB then */

struct ms_gpr {
    int n, m, active;        /* active: dimensions in use */
    int capacity;            /* points that there is room for */
    size_t stride;
    double mean, zero_score; /* what a score of 0 is taken as */
    double jitter;
    ms_simd level;
    const ms_gpr__kernels *kernels;
    ms_allocator allocator;
    ms_parallel parallel;
    void *block;
    size_t doubles;
    double *x;               /* [capacity][m] */
    double *y;               /* [capacity] */
    double *theta;           /* [m + 2] */
    double *center;          /* [m] subtracted from inputs, so that offsets cost no digits */
    double *scale;           /* [m] 1 / l_k */
    double *points;          /* [active][stride] (x - center) / l by dimension, padded with zeros */
    double *alpha;           /* [stride] */
    double *weight;          /* [stride] sf^2 alpha */
    double *upper;           /* [capacity][stride] U'U = K' */
    float *points_f;         /* [active][stride] */
    float *weight_f;         /* [stride] */
    int *dimension;          /* [active] which column of x */
};

static size_t ms_gpr__model_doubles(int capacity, int m)
{
    size_t stride = ms_gpr__stride(capacity), columns = (size_t)m;
    size_t rows = ms__size_add(ms__size_mul((size_t)capacity, columns + 1), ms__size_mul(columns, 5));
    size_t lists = ms__size_mul(stride, ms__size_add(ms__size_mul(2, columns), 4));
    return ms__size_add(ms__size_add(rows, lists), ms__size_add(ms__size_mul(stride, (size_t)ms_gpr__padded(capacity)), 4));
}

/* Points gp at its parts of a block for `capacity` points. */
static void ms_gpr__lay_out(ms_gpr *gp, int capacity, double *memory)
{
    size_t m = (size_t)gp->m;
    gp->capacity = capacity;
    gp->stride = ms_gpr__stride(capacity);
    gp->upper = memory;
    gp->points = gp->upper + (size_t)ms_gpr__padded(capacity) * gp->stride;
    gp->alpha = gp->points + m * gp->stride;
    gp->weight = gp->alpha + gp->stride;
    gp->points_f = (float *)(void *)(gp->weight + gp->stride);
    gp->weight_f = gp->points_f + m * gp->stride;
    gp->x = gp->weight + gp->stride + (m + 1) * gp->stride;
    gp->y = gp->x + (size_t)capacity * m;
    gp->theta = gp->y + capacity;
    gp->center = gp->theta + m + 2;
    gp->scale = gp->center + m;
    gp->dimension = (int *)(void *)(gp->scale + m);
}

static double ms_gpr__sf2(const ms_gpr *gp) { return exp(2 * gp->theta[gp->m]); }
static double ms_gpr__sn2(const ms_gpr *gp) { return exp(2 * gp->theta[gp->m + 1]); }

/* What the model takes score i as, less the prior mean. */
static double ms_gpr__target(const ms_gpr *gp, int i)
{
    return (gp->y[i] < 0 || gp->y[i] > 0 ? gp->y[i] : gp->zero_score) - gp->mean;
}

/* The input x [m] in length scales from the center, `spacing` apart. */
static void ms_gpr__place(const ms_gpr *gp, const double *x, double *place, size_t spacing)
{
    int k;
    for (k = 0; k < gp->active; ++k) {
        int d = gp->dimension[k];
        place[(size_t)k * spacing] = (x[d] - gp->center[d]) * gp->scale[d];
    }
}

static void ms_gpr__place_training(ms_gpr *gp, int i)
{
    int k;
    ms_gpr__place(gp, gp->x + (size_t)i * (size_t)gp->m, gp->points + i, gp->stride);
    for (k = 0; k < gp->active; ++k) {
        size_t at = (size_t)k * gp->stride + (size_t)i;
        gp->points_f[at] = (float)gp->points[at];
    }
}

/* alpha = K'^-1 (y - mean) from the factor. */
static void ms_gpr__solve_alpha(ms_gpr *gp)
{
    int padded = ms_gpr__padded(gp->n), i;
    double sf2 = ms_gpr__sf2(gp);
    for (i = 0; i < padded; ++i) gp->alpha[i] = i < gp->n ? ms_gpr__target(gp, i) : 0;
    ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, gp->alpha);
    ms_gpr__backward_vector(gp->kernels, gp->upper, gp->stride, padded, gp->alpha);
    for (i = 0; i < padded; ++i) {
        gp->weight[i] = sf2 * gp->alpha[i];
        gp->weight_f[i] = (float)gp->weight[i];
    }
}

/* Everything that follows from x, y and theta. The jitter, in units of sf^2, is the least power of ten that does. */
static ms_status ms_gpr__condition(ms_gpr *gp, ms_error *error)
{
    size_t lists = (size_t)gp->m * gp->stride;
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
    for (i = 0; i < gp->n; ++i) ms_gpr__place_training(gp, i);
    for (gp->jitter = 0; gp->jitter < 2e-6; gp->jitter = gp->jitter > 0 ? 10 * gp->jitter : 1e-15) {
        ms_gpr__covariance(gp->kernels, gp->points, gp->stride, gp->n, gp->active, sf2, gp->upper);
        if (ms_gpr__factor(gp->kernels, gp->upper, gp->stride, gp->n, sf2, sn2 + gp->jitter * sf2, gp->upper)) {
            ms_gpr__solve_alpha(gp);
            return MS_OK;
        }
    }
    return ms__fail(error, MS_NOT_CONVERGED, 0, "the covariance matrix of %d points is not positive definite even with 1e-6 sf^2 added to sn^2",
                    gp->n);
}

/* Position: the row, from 1. */
static ms_status ms_gpr__check_rows(const double *x, int rows, int columns, const char *what, ms_error *error)
{
    int i, k;
    for (i = 0; i < rows; ++i)
        for (k = 0; k < columns; ++k)
            if (!ms__finite(x[(size_t)i * (size_t)columns + (size_t)k]))
                return ms__fail(error, MS_BAD_DATA, (size_t)i + 1, "%s %d, column %d is %g: expected a finite number", what, i + 1, k + 1,
                                x[(size_t)i * (size_t)columns + (size_t)k]);
    return MS_OK;
}

static ms_status ms_gpr__check_data(const double *x, const double *y, int n, int m, ms_error *error)
{
    ms_status status;
    if (n < 0 || n > MS_GPR__N_MAX) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "n is %d: expected 0 to %d", n, MS_GPR__N_MAX);
    if (m < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "m is %d: expected at least 1", m);
    if (n > 0 && (x == NULL || y == NULL)) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "x or y is NULL");
    status = ms_gpr__check_rows(x, n, m, "input", error);
    return status == MS_OK ? ms_gpr__check_rows(y, n, 1, "score", error) : status;
}

static ms_status ms_gpr__check_theta(const double *theta, int m, ms_error *error)
{
    int k;
    if (theta == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "theta is NULL");
    for (k = 0; k < m + 2; ++k) {
        double limit = k < m ? MS_GPR__DROPPED : 300;
        if (!(theta[k] >= -limit && theta[k] <= limit))
            return ms__fail(error, MS_INVALID_ARGUMENT, 0, "theta[%d] is %g: expected a logarithm from %g to %g", k, theta[k], -limit, limit);
    }
    return MS_OK;
}

static ms_status ms_gpr__make(const double *x, const double *y, int n, int m, const double *theta, double zero_score,
                              const ms_gpr_options *options, ms_gpr **out, ms_error *error)
{
    ms_gpr *gp = (ms_gpr *)ms__alloc(&options->allocator, sizeof *gp);
    double *memory;
    ms_status status;
    if (gp == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model");
    memset(gp, 0, sizeof *gp);
    gp->n = n;
    gp->m = m;
    gp->mean = options->mean;
    gp->zero_score = zero_score;
    gp->level = ms_gpr__simd_pick(options->simd);
    gp->kernels = ms_gpr__kernels_of(gp->level);
    gp->allocator = options->allocator;
    gp->parallel = options->parallel;
    gp->doubles = ms_gpr__model_doubles(n, m);
    memory = ms_gpr__doubles(&gp->allocator, gp->doubles, &gp->block);
    if (memory == NULL) {
        ms__release(&options->allocator, gp, sizeof *gp);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model of %d points and %d dimensions", n, m);
    }
    ms_gpr__lay_out(gp, n, memory);
    if (n > 0) memcpy(gp->x, x, (size_t)n * (size_t)m * sizeof *x);
    if (n > 0) memcpy(gp->y, y, (size_t)n * sizeof *y);
    memcpy(gp->theta, theta, ((size_t)m + 2) * sizeof *theta);
    status = ms_gpr__condition(gp, error);
    if (status != MS_OK) ms_gpr_destroy(gp);
    else *out = gp;
    return status;
}

MS_GPR_API ms_status ms_gpr_create(const double *x, const double *y, int n, int m, const double *theta, const ms_gpr_options *options,
                                   ms_gpr **out, ms_error *error)
{
    ms_gpr_options defaults;
    ms_status status;
    if (out == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "out is NULL");
    *out = NULL;
    memset(&defaults, 0, sizeof defaults);
    if (options == NULL) options = &defaults;
    status = ms_gpr__check_data(x, y, n, m, error);
    if (status == MS_OK) status = ms_gpr__check_theta(theta, m, error);
    if (status == MS_OK && !ms__finite(options->mean)) status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "the prior mean is not finite");
    return status == MS_OK ? ms_gpr__make(x, y, n, m, theta, 0, options, out, error) : status;
}

MS_GPR_API void ms_gpr_destroy(ms_gpr *gp)
{
    ms_allocator allocator;
    if (gp == NULL) return;
    allocator = gp->allocator;
    ms_gpr__release_doubles(&allocator, gp->block, gp->doubles);
    ms__release(&allocator, gp, sizeof *gp);
}

/* Conditions on `theta`, or goes back to what was: that did condition before. swap [m + 2]: scratch. */
static ms_status ms_gpr__try_theta(ms_gpr *gp, const double *theta, double *swap, ms_error *error)
{
    size_t size = ((size_t)gp->m + 2) * sizeof *theta;
    ms_status status;
    memcpy(swap, gp->theta, size);
    memcpy(gp->theta, theta, size);
    status = ms_gpr__condition(gp, error);
    if (status != MS_OK) {
        memcpy(gp->theta, swap, size);
        ms_gpr__condition(gp, NULL);
    }
    return status;
}

MS_GPR_API ms_status ms_gpr_set_theta(ms_gpr *gp, const double *theta, ms_error *error)
{
    size_t size = ((size_t)gp->m + 2) * sizeof *theta;
    ms_status status = ms_gpr__check_theta(theta, gp->m, error);
    double *swap;
    if (status != MS_OK) return status;
    swap = (double *)ms__alloc(&gp->allocator, size);
    if (swap == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a copy of theta");
    status = ms_gpr__try_theta(gp, theta, swap, error);
    ms__release(&gp->allocator, swap, size);
    return status;
}

MS_GPR_API void ms_gpr_relevance(const ms_gpr *gp, double *relevance)
{
    int i, k;
    for (k = 0; k < gp->m; ++k) {
        double sum = 0;
        for (i = 0; i < gp->n; ++i) {
            double d = (gp->x[(size_t)i * (size_t)gp->m + (size_t)k] - gp->center[k]) * gp->scale[k];
            sum += d * d;
        }
        relevance[k] = gp->n > 1 && gp->theta[k] < MS_GPR__DROPPED ? 2 * sum / (gp->n - 1) : 0;
    }
}

MS_GPR_API ms_status ms_gpr_simplify(ms_gpr *gp, double tolerance, int *kept, ms_error *error)
{
    size_t columns = (size_t)gp->m, size = (3 * columns + 4) * sizeof(double);
    double *relevance, *theta, dropped = 0;
    ms_status status;
    int k;
    if (!(tolerance >= 0)) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tolerance is %g: expected at least 0", tolerance);
    relevance = (double *)ms__alloc(&gp->allocator, size);
    if (relevance == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d relevances", gp->m);
    theta = relevance + columns;
    memcpy(theta, gp->theta, (columns + 2) * sizeof *theta);
    ms_gpr_relevance(gp, relevance);
    for (;;) {
        int least = -1;
        for (k = 0; k < gp->m; ++k)
            if (theta[k] < MS_GPR__DROPPED && (least < 0 || relevance[k] < relevance[least])) least = k;
        if (least < 0 || dropped + relevance[least] > tolerance) break;
        dropped += relevance[least];
        theta[least] = MS_GPR__DROPPED;
    }
    status = ms_gpr__try_theta(gp, theta, theta + columns + 2, error);
    if (kept && status == MS_OK) *kept = gp->active;
    ms__release(&gp->allocator, relevance, size);
    return status;
}

MS_GPR_API int ms_gpr_count(const ms_gpr *gp) { return gp->n; }
MS_GPR_API int ms_gpr_dimensions(const ms_gpr *gp) { return gp->m; }
MS_GPR_API const double *ms_gpr_theta(const ms_gpr *gp) { return gp->theta; }
MS_GPR_API const double *ms_gpr_inputs(const ms_gpr *gp) { return gp->x; }
MS_GPR_API const double *ms_gpr_scores(const ms_gpr *gp) { return gp->y; }
MS_GPR_API double ms_gpr_mean(const ms_gpr *gp) { return gp->mean; }
MS_GPR_API double ms_gpr_zero_score(const ms_gpr *gp) { return gp->zero_score; }
MS_GPR_API ms_simd ms_gpr_level(const ms_gpr *gp) { return gp->level; }
MS_GPR_API double ms_gpr_jitter(const ms_gpr *gp) { return gp->jitter; }

/* The problem of this model's data and theta; memory from the model's allocator, to be released as `block`. */
static ms_status ms_gpr__problem_of(const ms_gpr *gp, ms_gpr__problem *p, void **block, size_t *doubles, ms_error *error)
{
    double *memory;
    int i, k;
    memset(p, 0, sizeof *p);
    *doubles = ms_gpr__problem_doubles(gp->n, gp->m);
    memory = ms_gpr__doubles(&gp->allocator, *doubles, block);
    if (memory == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the likelihood of %d points", gp->n);
    *p = ms_gpr__problem_make(gp->kernels, gp->n, gp->active, memory);
    for (k = 0; k < gp->active; ++k)
        memcpy(p->points + (size_t)k * p->stride, gp->points + (size_t)k * gp->stride, (size_t)gp->n * sizeof(double));
    for (i = 0; i < gp->n; ++i) p->target[i] = ms_gpr__target(gp, i);
    return MS_OK;
}

MS_GPR_API ms_status ms_gpr_likelihood(const ms_gpr *gp, double *likelihood, double *gradient, ms_error *error)
{
    ms_gpr__problem p;
    void *block;
    size_t doubles;
    double sf2 = ms_gpr__sf2(gp), sn2 = ms_gpr__sn2(gp), value;
    ms_status status = ms_gpr__problem_of(gp, &p, &block, &doubles, error);
    int k;
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
    ms_gpr__release_doubles(&gp->allocator, block, doubles);
    return status;
}

MS_GPR_API ms_status ms_gpr_leave_one_out(const ms_gpr *gp, double *mean, double *variance, double *density, ms_error *error)
{
    size_t stride = gp->stride, doubles = ms__size_mul((size_t)ms_gpr__padded(gp->n), stride);
    int padded = ms_gpr__padded(gp->n), i, j;
    double *inverse, sum = 0;
    void *block;
    inverse = ms_gpr__doubles(&gp->allocator, ms__size_add(doubles, stride), &block);
    if (inverse == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for an inverse of %d points", gp->n);
    {
        double *diagonal = inverse + doubles; /* of K'^-1 = Y'Y */
        memset(inverse, 0, (doubles + stride) * sizeof *inverse);
        ms_gpr__invert(gp->kernels, gp->upper, stride, padded, inverse);
        for (i = 0; i < padded; ++i)
            for (j = 0; j <= i; ++j) diagonal[j] += inverse[(size_t)i * stride + (size_t)j] * inverse[(size_t)i * stride + (size_t)j];
        for (i = 0; i < gp->n; ++i) {
            double residual = gp->alpha[i] / diagonal[i]; /* y_i - mean_i */
            if (mean) mean[i] = ms_gpr__target(gp, i) + gp->mean - residual;
            if (variance) variance[i] = 1 / diagonal[i];
            sum += -0.5 * (residual * residual * diagonal[i] - log(diagonal[i]) + 1.8378770664093454836);
        }
    }
    if (density) *density = sum;
    ms_gpr__release_doubles(&gp->allocator, block, ms__size_add(doubles, stride));
    return MS_OK;
}

/* --- one point more or less --- */

/* Room for one more point: a new block of half as many points again, everything copied. */
static ms_status ms_gpr__grow(ms_gpr *gp, ms_error *error)
{
    ms_gpr old = *gp;
    int capacity = gp->n + gp->n / 2 + MS_GPR__BLOCK, i, k;
    size_t doubles, n = (size_t)gp->n, m = (size_t)gp->m;
    double *memory;
    void *block;
    if (gp->n < gp->capacity) return MS_OK;
    if (gp->n >= MS_GPR__N_MAX) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the model already has %d points", gp->n);
    doubles = ms_gpr__model_doubles(capacity, gp->m);
    memory = ms_gpr__doubles(&gp->allocator, doubles, &block);
    if (memory == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a model of %d points", capacity);
    gp->block = block;
    gp->doubles = doubles;
    ms_gpr__lay_out(gp, capacity, memory);
    memcpy(gp->x, old.x, n * m * sizeof *gp->x);
    memcpy(gp->y, old.y, n * sizeof *gp->y);
    memcpy(gp->theta, old.theta, (m + 2) * sizeof *gp->theta);
    memcpy(gp->center, old.center, m * sizeof *gp->center);
    memcpy(gp->scale, old.scale, m * sizeof *gp->scale);
    memcpy(gp->dimension, old.dimension, m * sizeof *gp->dimension);
    memcpy(gp->alpha, old.alpha, n * sizeof *gp->alpha);
    memset(gp->points, 0, m * gp->stride * sizeof *gp->points);
    memset(gp->points_f, 0, m * gp->stride * sizeof *gp->points_f);
    for (i = 0; i < gp->n; ++i) ms_gpr__place_training(gp, i);
    for (k = 0; k < ms_gpr__padded(gp->n); ++k)
        memcpy(gp->upper + (size_t)k * gp->stride, old.upper + (size_t)k * old.stride, (size_t)ms_gpr__padded(gp->n) * sizeof(double));
    ms_gpr__release_doubles(&gp->allocator, old.block, old.doubles);
    return MS_OK;
}

/* Row and column `at` of the factor as those of a point that is independent of all others. */
static void ms_gpr__pad(ms_gpr *gp, int at)
{
    int padded = ms_gpr__padded(at + 1), i;
    for (i = 0; i < padded; ++i) gp->upper[(size_t)i * gp->stride + (size_t)at] = gp->upper[(size_t)at * gp->stride + (size_t)i] = 0;
    gp->upper[(size_t)at * (gp->stride + 1)] = 1;
}

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

MS_GPR_API ms_status ms_gpr_append(ms_gpr *gp, const double *x, double y, ms_error *error)
{
    double sf2 = ms_gpr__sf2(gp), sn2 = ms_gpr__sn2(gp), pivot = sf2 + sn2 + gp->jitter * sf2, least;
    int n = gp->n, padded = ms_gpr__padded(gp->n), i;
    ms_status status = ms_gpr__check_data(x, &y, 1, gp->m, error);
    if (status == MS_OK) status = ms_gpr__grow(gp, error);
    if (status != MS_OK) return status;
    memcpy(gp->x + (size_t)n * (size_t)gp->m, x, (size_t)gp->m * sizeof *x);
    gp->y[n] = y;
    gp->n = n + 1;
    ms_gpr__place_training(gp, n);
    least = gp->n * 2.220446049250313e-16 * pivot;
    /* The new column of U is v = U'^-1 k, and the new pivot sqrt(k(x, x) + sn^2 - v'v). */
    for (i = padded; i < ms_gpr__padded(gp->n); ++i) ms_gpr__pad(gp, i);
    for (i = 0; i < padded; ++i)
        gp->alpha[i] = i < n ? sf2 * exp(-0.5 * ms_gpr__distance2(gp->points + i, gp->stride, gp->points + n, gp->stride, gp->active)) : 0;
    ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, gp->alpha);
    pivot -= gp->kernels->dot(gp->alpha, gp->alpha, padded);
    if (pivot > least) {
        for (i = 0; i < n; ++i) gp->upper[(size_t)i * gp->stride + (size_t)n] = gp->alpha[i];
        gp->upper[(size_t)n * (gp->stride + 1)] = sqrt(pivot);
        ms_gpr__solve_alpha(gp);
        return MS_OK;
    }
    status = ms_gpr__condition(gp, error);
    if (status != MS_OK) {
        gp->n = n;
        ms_gpr__condition(gp, NULL);
    }
    return status;
}

MS_GPR_API ms_status ms_gpr_drop(ms_gpr *gp, int index, ms_error *error)
{
    size_t m = (size_t)gp->m, stride = gp->stride;
    int last = gp->n - 1, i, j, k;
    if (index < 0 || index > last) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "index is %d: expected 0 to %d", index, last);
    memmove(gp->x + (size_t)index * m, gp->x + ((size_t)index + 1) * m, (size_t)(last - index) * m * sizeof *gp->x);
    memmove(gp->y + index, gp->y + index + 1, (size_t)(last - index) * sizeof *gp->y);
    for (k = 0; k < gp->active; ++k) {
        double *p = gp->points + (size_t)k * stride;
        float *q = gp->points_f + (size_t)k * stride;
        memmove(p + index, p + index + 1, (size_t)(last - index) * sizeof *p);
        memmove(q + index, q + index + 1, (size_t)(last - index) * sizeof *q);
        p[last] = 0;
        q[last] = 0;
    }
    for (i = 0; i <= last; ++i) {
        double *row = gp->upper + (size_t)i * stride;
        int first = i < index ? index : i - 1; /* row i > index keeps the element that was on its diagonal */
        if (first < index) first = index;
        memmove(row + first, row + first + 1, (size_t)(last - first) * sizeof *row);
    }
    for (i = index; i < last; ++i) { /* Givens rotations of rows i and i + 1 remove the element below the diagonal */
        double *a = gp->upper + (size_t)i * stride, *b = a + stride, r = sqrt(a[i] * a[i] + b[i] * b[i]), c = a[i] / r, s = b[i] / r;
        for (j = i; j < last; ++j) {
            double t = c * a[j] + s * b[j];
            b[j] = c * b[j] - s * a[j];
            a[j] = t;
        }
        a[i] = r;
    }
    gp->n = last;
    ms_gpr__pad(gp, last);
    ms_gpr__solve_alpha(gp);
    return MS_OK;
}

/* ----------------------------------------------------------------------------------------------- PREDICTION */

/* One task: chunks of candidates task, task + tasks, ... */
typedef struct ms_gpr__batch {
    const ms_gpr *gp;
    const double *x;      /* one of x and x_f */
    const float *x_f;
    int count, tasks;
    double *mean, *variance;
    float *mean_f;
    double *scratch;      /* [tasks][task_doubles] */
    size_t task_doubles;
} ms_gpr__batch;

/* 64 candidates by dimension, in length scales; missing ones stand at the center. */
static int ms_gpr__chunk_place(const ms_gpr__batch *b, int start, double *place)
{
    int filled = b->count - start < MS_GPR__CHUNK ? b->count - start : MS_GPR__CHUNK, j;
    memset(place, 0, (size_t)b->gp->active * MS_GPR__CHUNK * sizeof *place);
    for (j = 0; j < filled; ++j)
        ms_gpr__place(b->gp, b->x + (size_t)(start + j) * (size_t)b->gp->m, place + j, MS_GPR__CHUNK);
    return filled;
}

static void ms_gpr__chunk_mean(const ms_gpr *gp, const double *place, double *tile, double *mean)
{
    int n = ms_gpr__padded(gp->n), i, j;
    for (j = 0; j < MS_GPR__CHUNK; ++j) mean[j] = 0;
    for (i = 0; i < n; i += MS_GPR__SLAB) {
        int rows = n - i < MS_GPR__SLAB ? n - i : MS_GPR__SLAB;
        gp->kernels->distances(tile, MS_GPR__CHUNK, gp->points + i, gp->stride, place, MS_GPR__CHUNK, rows, MS_GPR__CHUNK, gp->active, 0);
        gp->kernels->accumulate(mean, tile, MS_GPR__CHUNK, gp->weight + i, rows, MS_GPR__CHUNK);
    }
}

/* sf^2 - |v|^2, v = U'^-1 k* */
static void ms_gpr__chunk_variance(const ms_gpr *gp, const double *place, double *columns, double *variance)
{
    double sf2 = ms_gpr__sf2(gp);
    int n = ms_gpr__padded(gp->n), i, j;
    gp->kernels->distances(columns, MS_GPR__CHUNK, gp->points, gp->stride, place, MS_GPR__CHUNK, n, MS_GPR__CHUNK, gp->active, 0);
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
    double *place = b->scratch + (size_t)task * b->task_doubles, *tile = place + (size_t)b->gp->active * MS_GPR__CHUNK;
    double result[MS_GPR__CHUNK];
    int start, j;
    for (start = task * MS_GPR__CHUNK; start < b->count; start += b->tasks * MS_GPR__CHUNK) {
        int filled = ms_gpr__chunk_place(b, start, place);
        if (b->mean) {
            ms_gpr__chunk_mean(b->gp, place, tile, result);
            for (j = 0; j < filled; ++j) b->mean[start + j] = b->gp->mean + result[j];
        }
        if (b->variance) {
            ms_gpr__chunk_variance(b->gp, place, tile, result);
            for (j = 0; j < filled; ++j) b->variance[start + j] = result[j] > 0 ? result[j] : 0;
        }
    }
}

static void ms_gpr__predict_task_f(void *context, int task)
{
    const ms_gpr__batch *b = (const ms_gpr__batch *)context;
    const ms_gpr *gp = b->gp;
    float *place = (float *)(void *)(b->scratch + (size_t)task * b->task_doubles), *tile = place + (size_t)gp->active * MS_GPR__CHUNK;
    float mean[MS_GPR__CHUNK];
    int n = ms_gpr__padded(gp->n), start, i, j, k;
    for (start = task * MS_GPR__CHUNK; start < b->count; start += b->tasks * MS_GPR__CHUNK) {
        int filled = b->count - start < MS_GPR__CHUNK ? b->count - start : MS_GPR__CHUNK;
        memset(place, 0, (size_t)gp->active * MS_GPR__CHUNK * sizeof *place);
        for (j = 0; j < filled; ++j) {
            const float *x = b->x_f + (size_t)(start + j) * (size_t)gp->m;
            for (k = 0; k < gp->active; ++k) {
                int d = gp->dimension[k];
                place[k * MS_GPR__CHUNK + j] = (float)(((double)x[d] - gp->center[d]) * gp->scale[d]);
            }
        }
        for (j = 0; j < MS_GPR__CHUNK; ++j) mean[j] = 0;
        for (i = 0; i < n; i += MS_GPR__SLAB) {
            int rows = n - i < MS_GPR__SLAB ? n - i : MS_GPR__SLAB;
            gp->kernels->distances_f(tile, MS_GPR__CHUNK, gp->points_f + i, gp->stride, place, MS_GPR__CHUNK, rows, MS_GPR__CHUNK,
                                     gp->active, 0);
            gp->kernels->accumulate_f(mean, tile, MS_GPR__CHUNK, gp->weight_f + i, rows, MS_GPR__CHUNK);
        }
        for (j = 0; j < filled; ++j) b->mean_f[start + j] = (float)(gp->mean + (double)mean[j]);
    }
}

/* Shares the chunks out to at most 16 tasks, each with its own scratch. */
static ms_status ms_gpr__predict_run(ms_gpr__batch *b, void (*task)(void *context, int index), ms_error *error)
{
    const ms_gpr *gp = b->gp;
    size_t rows = b->variance ? (size_t)ms_gpr__padded(gp->n) : 0, doubles;
    int chunks = (b->count - 1) / MS_GPR__CHUNK + 1;
    void *block;
    if (b->count == 0) return MS_OK;
    b->tasks = gp->parallel.run == NULL ? 1 : chunks < 16 ? chunks : 16;
    b->task_doubles = ms__size_mul(MS_GPR__CHUNK, (size_t)gp->active + (rows > MS_GPR__SLAB ? rows : MS_GPR__SLAB));
    doubles = ms__size_mul((size_t)b->tasks, b->task_doubles);
    b->scratch = ms_gpr__doubles(&gp->allocator, doubles, &block);
    if (b->scratch == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for predictions");
    ms__run(&gp->parallel, b->tasks, task, b);
    ms_gpr__release_doubles(&gp->allocator, block, doubles);
    return MS_OK;
}

MS_GPR_API ms_status ms_gpr_predict(const ms_gpr *gp, const double *x, int count, double *mean, double *variance, ms_error *error)
{
    ms_gpr__batch b;
    ms_status status;
    if (count < 0 || (count > 0 && x == NULL)) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d, or x is NULL", count);
    status = ms_gpr__check_rows(x, count, gp->m, "candidate", error);
    if (status != MS_OK) return status;
    memset(&b, 0, sizeof b);
    b.gp = gp;
    b.x = x;
    b.count = count;
    b.mean = mean;
    b.variance = variance;
    return ms_gpr__predict_run(&b, ms_gpr__predict_task, error);
}

MS_GPR_API ms_status ms_gpr_predict_f(const ms_gpr *gp, const float *x, int count, float *mean, ms_error *error)
{
    ms_gpr__batch b;
    size_t i, values;
    if (count < 0 || (count > 0 && (x == NULL || mean == NULL)))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "count is %d, or x or mean is NULL", count);
    values = (size_t)count * (size_t)gp->m;
    for (i = 0; i < values; ++i)
        if (!ms__finite_f(x[i]))
            return ms__fail(error, MS_BAD_DATA, i / (size_t)gp->m + 1, "candidate %z has a value that is not finite", i / (size_t)gp->m + 1);
    memset(&b, 0, sizeof b);
    b.gp = gp;
    b.x_f = x;
    b.count = count;
    b.mean_f = mean;
    return ms_gpr__predict_run(&b, ms_gpr__predict_task_f, error);
}

MS_GPR_API ms_status ms_gpr_gradient(const ms_gpr *gp, const double *x, double *mean, double *mean_gradient, double *variance,
                                     double *variance_gradient, ms_error *error)
{
    int padded = ms_gpr__padded(gp->n), i, k;
    double sf2 = ms_gpr__sf2(gp), sum = gp->mean, *place, *covariance, *beta, explained;
    size_t doubles = (size_t)gp->active + 2 * (size_t)padded;
    ms_status status = ms_gpr__check_rows(x, 1, gp->m, "candidate", error);
    void *block;
    if (status != MS_OK) return status;
    place = ms_gpr__doubles(&gp->allocator, doubles, &block);
    if (place == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a gradient");
    covariance = place + gp->active; /* k*, then beta = K'^-1 k* beside it */
    beta = covariance + padded;
    ms_gpr__place(gp, x, place, 1);
    for (i = 0; i < padded; ++i) {
        covariance[i] = i < gp->n ? sf2 * exp(-0.5 * ms_gpr__distance2(gp->points + i, gp->stride, place, 1, gp->active)) : 0;
        beta[i] = covariance[i];
        if (i < gp->n) sum += gp->alpha[i] * covariance[i];
    }
    if (mean) *mean = sum;
    if (variance || variance_gradient) {
        ms_gpr__forward_vector(gp->kernels, gp->upper, gp->stride, padded, beta);
        explained = gp->kernels->dot(beta, beta, padded);
        if (variance) *variance = sf2 > explained ? sf2 - explained : 0;
        ms_gpr__backward_vector(gp->kernels, gp->upper, gp->stride, padded, beta);
    }
    if (mean_gradient) memset(mean_gradient, 0, (size_t)gp->m * sizeof *mean_gradient);
    if (variance_gradient) memset(variance_gradient, 0, (size_t)gp->m * sizeof *variance_gradient);
    for (k = 0; k < gp->active; ++k) { /* dk_i/dx_k = k_i (x_ik - x_k) / l_k^2 */
        const double *p = gp->points + (size_t)k * gp->stride;
        double slope = 0, variance_slope = 0, scale = gp->scale[gp->dimension[k]];
        for (i = 0; i < gp->n; ++i) {
            double d = covariance[i] * (p[i] - place[k]);
            slope += gp->alpha[i] * d;
            variance_slope -= 2 * beta[i] * d;
        }
        if (mean_gradient) mean_gradient[gp->dimension[k]] = slope * scale;
        if (variance_gradient) variance_gradient[gp->dimension[k]] = variance_slope * scale;
    }
    ms_gpr__release_doubles(&gp->allocator, block, doubles);
    return MS_OK;
}

/* ---------------------------------------------------------------------------------------- RECOMMENDATION */

/* --------------------------------------------------------------------------------------- ACTIVE LEARNING */

/* ------------------------------------------------------------------------------------------ LATENT SPACE */

/* -------------------------------------------------------------------------------------------------- MAPS */

#endif /* MS_GPR_IMPLEMENTATION */

#ifdef MS_GPR__PASS
/* -------------------------------------------------------------------------------------------------- KERNELS */

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
#else
#define MS_GPR__KERNEL(name) MS_GPR__JOIN(ms_gpr__##name##_, MS_GPR__LEVEL)
#define MS_GPR__REAL double
#endif

/* Vectors: V, LANES, LOAD, STORE, SET (all lanes), ADD, SUB, MUL, MADD a b + c, NMADD c - a b, ROUND to the nearest whole number,
   POW2 of a whole number in the normal range, KEEP v where x > limit and 0 elsewhere. */
#if MS_GPR__PASS == 3 && MS_GPR__FLOAT
#define MS_GPR__V __m256
#define MS_GPR__LANES 8
#define MS_GPR__LOAD(p) _mm256_loadu_ps(p)
#define MS_GPR__STORE(p, v) _mm256_storeu_ps(p, v)
#define MS_GPR__SET(x) _mm256_set1_ps(x)
#define MS_GPR__ADD(a, b) _mm256_add_ps(a, b)
#define MS_GPR__SUB(a, b) _mm256_sub_ps(a, b)
#define MS_GPR__MUL(a, b) _mm256_mul_ps(a, b)
#define MS_GPR__MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define MS_GPR__NMADD(a, b, c) _mm256_fnmadd_ps(a, b, c)
#define MS_GPR__ROUND(a) _mm256_round_ps(a, 8)
#define MS_GPR__POW2(a) \
    _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_castps_si256(_mm256_add_ps(a, _mm256_set1_ps(12582912.0f + 127))), 23))
#define MS_GPR__KEEP(x, limit, v) _mm256_and_ps(_mm256_cmp_ps(x, limit, _CMP_GT_OQ), v)
#elif MS_GPR__PASS == 3
#define MS_GPR__V __m256d
#define MS_GPR__LANES 4
#define MS_GPR__LOAD(p) _mm256_loadu_pd(p)
#define MS_GPR__STORE(p, v) _mm256_storeu_pd(p, v)
#define MS_GPR__SET(x) _mm256_set1_pd(x)
#define MS_GPR__ADD(a, b) _mm256_add_pd(a, b)
#define MS_GPR__SUB(a, b) _mm256_sub_pd(a, b)
#define MS_GPR__MUL(a, b) _mm256_mul_pd(a, b)
#define MS_GPR__MADD(a, b, c) _mm256_fmadd_pd(a, b, c)
#define MS_GPR__NMADD(a, b, c) _mm256_fnmadd_pd(a, b, c)
#define MS_GPR__ROUND(a) _mm256_round_pd(a, 8)
#define MS_GPR__POW2(a) \
    _mm256_castsi256_pd(_mm256_slli_epi64(_mm256_castpd_si256(_mm256_add_pd(a, _mm256_set1_pd(6755399441055744.0 + 1023))), 52))
#define MS_GPR__KEEP(x, limit, v) _mm256_and_pd(_mm256_cmp_pd(x, limit, _CMP_GT_OQ), v)
#elif MS_GPR__PASS == 2 && defined(MS__X64) && MS_GPR__FLOAT
#define MS_GPR__V __m128
#define MS_GPR__LANES 4
#define MS_GPR__LOAD(p) _mm_loadu_ps(p)
#define MS_GPR__STORE(p, v) _mm_storeu_ps(p, v)
#define MS_GPR__SET(x) _mm_set1_ps(x)
#define MS_GPR__ADD(a, b) _mm_add_ps(a, b)
#define MS_GPR__SUB(a, b) _mm_sub_ps(a, b)
#define MS_GPR__MUL(a, b) _mm_mul_ps(a, b)
#define MS_GPR__MADD(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)
#define MS_GPR__NMADD(a, b, c) _mm_sub_ps(c, _mm_mul_ps(a, b))
#define MS_GPR__ROUND(a) _mm_cvtepi32_ps(_mm_cvtps_epi32(a))
#define MS_GPR__POW2(a) \
    _mm_castsi128_ps(_mm_slli_epi32(_mm_castps_si128(_mm_add_ps(a, _mm_set1_ps(12582912.0f + 127))), 23))
#define MS_GPR__KEEP(x, limit, v) _mm_and_ps(_mm_cmpgt_ps(x, limit), v)
#elif MS_GPR__PASS == 2 && defined(MS__X64)
#define MS_GPR__V __m128d
#define MS_GPR__LANES 2
#define MS_GPR__LOAD(p) _mm_loadu_pd(p)
#define MS_GPR__STORE(p, v) _mm_storeu_pd(p, v)
#define MS_GPR__SET(x) _mm_set1_pd(x)
#define MS_GPR__ADD(a, b) _mm_add_pd(a, b)
#define MS_GPR__SUB(a, b) _mm_sub_pd(a, b)
#define MS_GPR__MUL(a, b) _mm_mul_pd(a, b)
#define MS_GPR__MADD(a, b, c) _mm_add_pd(_mm_mul_pd(a, b), c)
#define MS_GPR__NMADD(a, b, c) _mm_sub_pd(c, _mm_mul_pd(a, b))
#define MS_GPR__ROUND(a) _mm_cvtepi32_pd(_mm_cvtpd_epi32(a))
#define MS_GPR__POW2(a) \
    _mm_castsi128_pd(_mm_slli_epi64(_mm_castpd_si128(_mm_add_pd(a, _mm_set1_pd(6755399441055744.0 + 1023))), 52))
#define MS_GPR__KEEP(x, limit, v) _mm_and_pd(_mm_cmpgt_pd(x, limit), v)
#elif MS_GPR__PASS == 2 && MS_GPR__FLOAT
#define MS_GPR__V float32x4_t
#define MS_GPR__LANES 4
#define MS_GPR__LOAD(p) vld1q_f32(p)
#define MS_GPR__STORE(p, v) vst1q_f32(p, v)
#define MS_GPR__SET(x) vdupq_n_f32(x)
#define MS_GPR__ADD(a, b) vaddq_f32(a, b)
#define MS_GPR__SUB(a, b) vsubq_f32(a, b)
#define MS_GPR__MUL(a, b) vmulq_f32(a, b)
#define MS_GPR__MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_GPR__NMADD(a, b, c) vfmsq_f32(c, a, b)
#define MS_GPR__ROUND(a) vrndnq_f32(a)
#define MS_GPR__POW2(a) \
    vreinterpretq_f32_s32(vshlq_n_s32(vreinterpretq_s32_f32(vaddq_f32(a, vdupq_n_f32(12582912.0f + 127))), 23))
#define MS_GPR__KEEP(x, limit, v) vreinterpretq_f32_u32(vandq_u32(vcgtq_f32(x, limit), vreinterpretq_u32_f32(v)))
#elif MS_GPR__PASS == 2
#define MS_GPR__V float64x2_t
#define MS_GPR__LANES 2
#define MS_GPR__LOAD(p) vld1q_f64(p)
#define MS_GPR__STORE(p, v) vst1q_f64(p, v)
#define MS_GPR__SET(x) vdupq_n_f64(x)
#define MS_GPR__ADD(a, b) vaddq_f64(a, b)
#define MS_GPR__SUB(a, b) vsubq_f64(a, b)
#define MS_GPR__MUL(a, b) vmulq_f64(a, b)
#define MS_GPR__MADD(a, b, c) vfmaq_f64(c, a, b)
#define MS_GPR__NMADD(a, b, c) vfmsq_f64(c, a, b)
#define MS_GPR__ROUND(a) vrndnq_f64(a)
#define MS_GPR__POW2(a) \
    vreinterpretq_f64_s64(vshlq_n_s64(vreinterpretq_s64_f64(vaddq_f64(a, vdupq_n_f64(6755399441055744.0 + 1023))), 52))
#define MS_GPR__KEEP(x, limit, v) vreinterpretq_f64_u64(vandq_u64(vcgtq_f64(x, limit), vreinterpretq_u64_f64(v)))
#else
#define MS_GPR__V MS_GPR__REAL
#define MS_GPR__LANES 1
#define MS_GPR__LOAD(p) (*(p))
#define MS_GPR__STORE(p, v) (*(p) = (v))
#define MS_GPR__SET(x) (x)
#define MS_GPR__ADD(a, b) ((a) + (b))
#define MS_GPR__SUB(a, b) ((a) - (b))
#define MS_GPR__MUL(a, b) ((a) * (b))
#define MS_GPR__MADD(a, b, c) ((a) * (b) + (c))
#define MS_GPR__NMADD(a, b, c) ((c) - (a) * (b))
#define MS_GPR__ROUND(a) ((MS_GPR__REAL)(int)((a) - (MS_GPR__REAL)0.5)) /* of a <= 0 */
#define MS_GPR__POW2(a) MS_GPR__JOIN(ms_gpr__pow2_, MS_GPR__REAL)(a)
#define MS_GPR__KEEP(x, limit, v) ((x) > (limit) ? (v) : 0)
#endif

/* exp(-d2 / 2) = 2^t, t = -d2 / (2 log 2) <= 0, as 2^round(t) times a polynomial in the rest f that interpolates (2^f - 1) / f at
   the Chebyshev points of [-1/2, 1/2]: error 2e-17 (double) and 5e-9 (float) before rounding. Below 2^-500 (2^-110) it is 0: products
   of two such terms would be subnormal and slow. */
static inline MS_GPR__V MS_GPR__KERNEL(exponential)(MS_GPR__V d2)
{
    MS_GPR__V t = MS_GPR__MUL(d2, MS_GPR__SET((MS_GPR__REAL)-0.72134752044448170368));
#if MS_GPR__FLOAT
    MS_GPR__V limit = MS_GPR__SET(-110.0f), p = MS_GPR__SET(0.00015453162945120691f), f, whole;
#else
    MS_GPR__V limit = MS_GPR__SET(-500.0), p = MS_GPR__SET(4.4549605981865186e-10), f, whole;
#endif
    MS_GPR__V inside = MS_GPR__KEEP(t, limit, t);
    whole = MS_GPR__ROUND(inside);
    f = MS_GPR__SUB(inside, whole);
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
    p = MS_GPR__MUL(p, MS_GPR__POW2(whole));
    return MS_GPR__KEEP(t, limit, p);
}

/* A tile of 4 rows and 2 vectors, then of 1: eight sums and a few operands fit 16 registers. */
static void MS_GPR__KERNEL(distances)(MS_GPR__REAL *c, size_t c_stride, const MS_GPR__REAL *a, size_t a_stride,
                                      const MS_GPR__REAL *b, size_t b_stride, int rows, int columns, int depth, int parts)
{
    int i, j, k;
    for (j = 0; j + 2 * MS_GPR__LANES <= columns; j += 2 * MS_GPR__LANES) {
        int wanted = (parts & MS_GPR__UPPER) && j + 2 * MS_GPR__LANES < rows ? j + 2 * MS_GPR__LANES : rows;
        for (i = 0; i < wanted; i += 4) {
            const MS_GPR__REAL *ak = a + i, *bk = b + j;
            MS_GPR__REAL *at = c + (size_t)i * c_stride + j;
            MS_GPR__V c00 = MS_GPR__SET(0), c01 = c00, c10 = c00, c11 = c00, c20 = c00, c21 = c00, c30 = c00, c31 = c00;
            for (k = 0; k < depth; ++k, ak += a_stride, bk += b_stride) {
                MS_GPR__V b0 = MS_GPR__LOAD(bk), b1 = MS_GPR__LOAD(bk + MS_GPR__LANES), x, d;
#define MS_GPR__STEP(r)                                        \
    x = MS_GPR__SET(ak[r]);                                    \
    d = MS_GPR__SUB(x, b0), c##r##0 = MS_GPR__MADD(d, d, c##r##0); \
    d = MS_GPR__SUB(x, b1), c##r##1 = MS_GPR__MADD(d, d, c##r##1);
                MS_GPR__STEP(0) MS_GPR__STEP(1) MS_GPR__STEP(2) MS_GPR__STEP(3)
#undef MS_GPR__STEP
            }
            MS_GPR__STORE(at, c00), MS_GPR__STORE(at + MS_GPR__LANES, c01), at += c_stride;
            MS_GPR__STORE(at, c10), MS_GPR__STORE(at + MS_GPR__LANES, c11), at += c_stride;
            MS_GPR__STORE(at, c20), MS_GPR__STORE(at + MS_GPR__LANES, c21), at += c_stride;
            MS_GPR__STORE(at, c30), MS_GPR__STORE(at + MS_GPR__LANES, c31);
        }
    }
    for (; j < columns; j += MS_GPR__LANES) {
        for (i = 0; i < rows; ++i) {
            MS_GPR__V sum = MS_GPR__SET(0);
            for (k = 0; k < depth; ++k) {
                MS_GPR__V d = MS_GPR__SUB(MS_GPR__SET(a[(size_t)k * a_stride + (size_t)i]), MS_GPR__LOAD(b + (size_t)k * b_stride + j));
                sum = MS_GPR__MADD(d, d, sum);
            }
            MS_GPR__STORE(c + (size_t)i * c_stride + j, sum);
        }
    }
}

static void MS_GPR__KERNEL(accumulate)(MS_GPR__REAL *mean, const MS_GPR__REAL *c, size_t c_stride, const MS_GPR__REAL *weight,
                                       int rows, int columns)
{
    int i, j;
    for (j = 0; j < columns; j += MS_GPR__LANES) {
        MS_GPR__V sum = MS_GPR__LOAD(mean + j);
        for (i = 0; i < rows; ++i)
            sum = MS_GPR__MADD(MS_GPR__SET(weight[i]), MS_GPR__KERNEL(exponential)(MS_GPR__LOAD(c + (size_t)i * c_stride + j)), sum);
        MS_GPR__STORE(mean + j, sum);
    }
}

#if !MS_GPR__FLOAT
/* A tile of 4 rows and 3 vectors, then of 1: twelve sums, three vectors of b and one of a fill 16 registers. Depth goes in slices
   of 256, so that a slice of b stays in the first cache. */
static void MS_GPR__KERNEL(reduce)(double *c, size_t c_stride, const double *a, size_t a_stride, const double *b, size_t b_stride,
                                   int rows, int columns, int depth, int parts)
{
    int i, j, k, from, to;
    for (from = 0; from < depth; from = to) {
        to = depth - from > 256 ? from + 256 : depth;
        for (j = 0; j + 3 * MS_GPR__LANES <= columns; j += 3 * MS_GPR__LANES) {
            int wanted = (parts & MS_GPR__UPPER) && j + 3 * MS_GPR__LANES < rows ? (j + 3 * MS_GPR__LANES + 3) & ~3 : rows;
            int first = (parts & MS_GPR__LOWER) && j > from ? j : from;
            if (first >= to) break;
            for (i = 0; i < wanted; i += 4) {
                const double *ak = a + (size_t)first * a_stride + i, *bk = b + (size_t)first * b_stride + j;
                double *c0 = c + (size_t)i * c_stride + j, *c1 = c0 + c_stride, *c2 = c1 + c_stride, *c3 = c2 + c_stride;
                MS_GPR__V c00 = MS_GPR__LOAD(c0), c01 = MS_GPR__LOAD(c0 + MS_GPR__LANES), c02 = MS_GPR__LOAD(c0 + 2 * MS_GPR__LANES);
                MS_GPR__V c10 = MS_GPR__LOAD(c1), c11 = MS_GPR__LOAD(c1 + MS_GPR__LANES), c12 = MS_GPR__LOAD(c1 + 2 * MS_GPR__LANES);
                MS_GPR__V c20 = MS_GPR__LOAD(c2), c21 = MS_GPR__LOAD(c2 + MS_GPR__LANES), c22 = MS_GPR__LOAD(c2 + 2 * MS_GPR__LANES);
                MS_GPR__V c30 = MS_GPR__LOAD(c3), c31 = MS_GPR__LOAD(c3 + MS_GPR__LANES), c32 = MS_GPR__LOAD(c3 + 2 * MS_GPR__LANES);
                for (k = first; k < to; ++k, ak += a_stride, bk += b_stride) {
                    MS_GPR__V b0 = MS_GPR__LOAD(bk), b1 = MS_GPR__LOAD(bk + MS_GPR__LANES), b2 = MS_GPR__LOAD(bk + 2 * MS_GPR__LANES), x;
#define MS_GPR__STEP(r)                         \
    x = MS_GPR__SET(ak[r]);                     \
    c##r##0 = MS_GPR__NMADD(x, b0, c##r##0);    \
    c##r##1 = MS_GPR__NMADD(x, b1, c##r##1);    \
    c##r##2 = MS_GPR__NMADD(x, b2, c##r##2);
                    MS_GPR__STEP(0) MS_GPR__STEP(1) MS_GPR__STEP(2) MS_GPR__STEP(3)
#undef MS_GPR__STEP
                }
                MS_GPR__STORE(c0, c00), MS_GPR__STORE(c0 + MS_GPR__LANES, c01), MS_GPR__STORE(c0 + 2 * MS_GPR__LANES, c02);
                MS_GPR__STORE(c1, c10), MS_GPR__STORE(c1 + MS_GPR__LANES, c11), MS_GPR__STORE(c1 + 2 * MS_GPR__LANES, c12);
                MS_GPR__STORE(c2, c20), MS_GPR__STORE(c2 + MS_GPR__LANES, c21), MS_GPR__STORE(c2 + 2 * MS_GPR__LANES, c22);
                MS_GPR__STORE(c3, c30), MS_GPR__STORE(c3 + MS_GPR__LANES, c31), MS_GPR__STORE(c3 + 2 * MS_GPR__LANES, c32);
            }
        }
        for (; j < columns; j += MS_GPR__LANES) {
            int wanted = (parts & MS_GPR__UPPER) && j + MS_GPR__LANES < rows ? (j + MS_GPR__LANES + 3) & ~3 : rows;
            int first = (parts & MS_GPR__LOWER) && j > from ? j : from;
            for (i = 0; i < wanted; i += 4) {
                const double *ak = a + (size_t)first * a_stride + i, *bk = b + (size_t)first * b_stride + j;
                double *c0 = c + (size_t)i * c_stride + j, *c1 = c0 + c_stride, *c2 = c1 + c_stride, *c3 = c2 + c_stride;
                MS_GPR__V c00 = MS_GPR__LOAD(c0), c10 = MS_GPR__LOAD(c1), c20 = MS_GPR__LOAD(c2), c30 = MS_GPR__LOAD(c3);
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
                v = MS_GPR__NMADD(MS_GPR__SET(u[(size_t)k * u_stride + (size_t)i]), MS_GPR__LOAD(b + (size_t)k * b_stride + j), v);
            MS_GPR__STORE(at, MS_GPR__MUL(v, MS_GPR__SET(inverse[i])));
        }
    }
}

static void MS_GPR__KERNEL(exponentials)(double *c, int columns, double scale)
{
    int j;
    for (j = 0; j < columns; j += MS_GPR__LANES)
        MS_GPR__STORE(c + j, MS_GPR__MUL(MS_GPR__SET(scale), MS_GPR__KERNEL(exponential)(MS_GPR__LOAD(c + j))));
}

/* The sum of 8 partial sums, in a fixed order: lane l of every vector belongs to partial sum l modulo 8. */
static inline double MS_GPR__KERNEL(sum8)(const double *s)
{
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

static double MS_GPR__KERNEL(weights)(double *w, const double *g, const double *k, const double *alpha, double alpha_i, int columns)
{
    double partial[MS_GPR__BLOCK] = {0, 0, 0, 0, 0, 0, 0, 0};
    int j, l;
    for (j = 0; j < columns; j += MS_GPR__BLOCK) {
        for (l = 0; l < MS_GPR__BLOCK; l += MS_GPR__LANES) {
            MS_GPR__V v = MS_GPR__MADD(MS_GPR__SET(alpha_i), MS_GPR__LOAD(alpha + j + l), MS_GPR__LOAD(g + j + l));
            v = MS_GPR__MUL(v, MS_GPR__LOAD(k + j + l));
            MS_GPR__STORE(w + j + l, v);
            MS_GPR__STORE(partial + l, MS_GPR__ADD(MS_GPR__LOAD(partial + l), v));
        }
    }
    return MS_GPR__KERNEL(sum8)(partial);
}

static void MS_GPR__KERNEL(slopes)(double *slope, const double *w, const double *points, size_t stride, const double *place, int m,
                                   int columns)
{
    int j, k, l;
    for (j = 0; j < columns; j += MS_GPR__BLOCK) {
        const double *p = points + j, *q = place;
        double *s = slope;
        for (k = 0; k < m; ++k, p += stride, q += stride, s += MS_GPR__BLOCK) {
            for (l = 0; l < MS_GPR__BLOCK; l += MS_GPR__LANES) {
                MS_GPR__V d = MS_GPR__SUB(MS_GPR__LOAD(p + l), MS_GPR__SET(*q));
                MS_GPR__STORE(s + l, MS_GPR__MADD(MS_GPR__MUL(MS_GPR__LOAD(w + j + l), d), d, MS_GPR__LOAD(s + l)));
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
            MS_GPR__STORE(partial + l, MS_GPR__MADD(MS_GPR__LOAD(x + j + l), MS_GPR__LOAD(y + j + l), MS_GPR__LOAD(partial + l)));
    return MS_GPR__KERNEL(sum8)(partial);
}

static const ms_gpr__kernels MS_GPR__KERNEL(table) = {
    MS_GPR__KERNEL(reduce),  MS_GPR__KERNEL(distances), MS_GPR__JOIN(ms_gpr__distances_f_, MS_GPR__LEVEL),
    MS_GPR__KERNEL(exponentials), MS_GPR__KERNEL(accumulate), MS_GPR__JOIN(ms_gpr__accumulate_f_, MS_GPR__LEVEL),
    MS_GPR__KERNEL(solve), MS_GPR__KERNEL(weights), MS_GPR__KERNEL(slopes), MS_GPR__KERNEL(axpy), MS_GPR__KERNEL(dot)};
#endif /* !MS_GPR__FLOAT */

#undef MS_GPR__JOIN_
#undef MS_GPR__JOIN
#undef MS_GPR__LEVEL
#undef MS_GPR__KERNEL
#undef MS_GPR__REAL
#undef MS_GPR__V
#undef MS_GPR__LANES
#undef MS_GPR__LOAD
#undef MS_GPR__STORE
#undef MS_GPR__SET
#undef MS_GPR__ADD
#undef MS_GPR__SUB
#undef MS_GPR__MUL
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
