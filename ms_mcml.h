/* ms_mcml.h - v0.1.0 - photon transport in layered media - MIT or public domain, see the end

   HEAD COMMENT GOES HERE
*/
#ifndef MS_MCML_H
#define MS_MCML_H
#include <stddef.h>
#include <stdint.h>

#define MS_MCML_VERSION_MAJOR 0
#define MS_MCML_VERSION_MINOR 1
#define MS_MCML_VERSION_PATCH 0
#define MS_MCML_VERSION 100 /* major * 10000 + minor * 100 + patch */
#define MS_MCML_VERSION_STRING "0.1.0"

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

/* --- tissue and runs --------------------------------------------------------------------------------------- */

/* --- direct Monte Carlo ------------------------------------------------------------------------------------ */

/* --- finite beams ------------------------------------------------------------------------------------------ */

/* --- mci and mco files ------------------------------------------------------------------------------------- */

/* --- materials --------------------------------------------------------------------------------------------- */

/* --- half-space solver ------------------------------------------------------------------------------------- */

/* --- white Monte Carlo ------------------------------------------------------------------------------------- */

/* --- diffusion profiles ------------------------------------------------------------------------------------ */

#ifdef __cplusplus
}
#endif
#endif /* MS_MCML_H */

#if defined(MS_MCML_IMPLEMENTATION) && !defined(MS_MCML__PASS)
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

/* --- tissue and runs --------------------------------------------------------------------------------------- */

/* --- direct Monte Carlo ------------------------------------------------------------------------------------ */

/* --- finite beams ------------------------------------------------------------------------------------------ */

/* --- mci and mco files ------------------------------------------------------------------------------------- */

/* --- materials --------------------------------------------------------------------------------------------- */

/* --- half-space solver ------------------------------------------------------------------------------------- */

/* --- white Monte Carlo ------------------------------------------------------------------------------------- */

/* --- diffusion profiles ------------------------------------------------------------------------------------ */

#endif /* MS_MCML_IMPLEMENTATION */

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
