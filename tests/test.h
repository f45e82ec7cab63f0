/* The test harness: named cases, checks that print what they compared, a failing allocator that counts, a thread
   pool. One program a header: test_X [--full] [--build] [--no-simd] [--fused] [--seed N] [FILTER] runs the cases whose
   name holds FILTER, prints a line a case and ends with "N passed, N failed, N skipped". --full adds the long versions
   (`make test-long`); --build leaves out TEST_METHOD cases; --no-simd and --fused say how the headers are compiled. */
#ifndef MS_TEST_H
#define MS_TEST_H
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#if defined(__GNUC__)
#define TEST_UNUSED __attribute__((unused))
#else
#define TEST_UNUSED
#endif

typedef struct test_case {
    const char *name;
    void (*run)(void);
} test_case;

static int test_full;          /* non-zero: run the long version */
static int test_build;         /* non-zero: the same text in one more build; see TEST_METHOD */
static int test_no_simd;       /* non-zero: the headers are compiled without SIMD */
static int test_fused;         /* non-zero: they are compiled with products and sums in one instruction */
static int test_left_out;      /* the running case is not for this run */
static uint64_t test_seed = 1; /* for random inputs; a failure is repeated with the same --seed */
static int test_failures;      /* of the running case */
static char test_note[400];    /* what the running case compared, printed behind its name */
static char test_skip_reason[200];

/* Adds to the line of the running case: TEST_NOTE("max error %.2e", e). */
#define TEST_NOTE(...)                                                          \
    do {                                                                        \
        size_t test_at = strlen(test_note);                                     \
        if (test_at && test_at + 3 < sizeof test_note) {                        \
            memcpy(test_note + test_at, "; ", 3);                               \
            test_at += 2;                                                       \
        }                                                                       \
        snprintf(test_note + test_at, sizeof test_note - test_at, __VA_ARGS__); \
    } while (0)

#define TEST_FAIL(...)                                 \
    do {                                               \
        if (++test_failures <= 10) {                   \
            printf("    %s:%d: ", __FILE__, __LINE__); \
            printf(__VA_ARGS__);                       \
            printf("\n");                              \
        }                                              \
    } while (0)

#define CHECK(condition)                                         \
    do {                                                         \
        if (!(condition)) TEST_FAIL("not true: %s", #condition); \
    } while (0)

/* |value - expected| <= tolerance; a NaN fails. The reason for the tolerance stands beside the call. */
#define CHECK_NEAR(value, expected, tolerance)                                                      \
    do {                                                                                            \
        double test_v = (double)(value), test_e = (double)(expected), test_t = (double)(tolerance); \
        if (!(fabs(test_v - test_e) <= test_t))                                                     \
            TEST_FAIL("%s = %.12g, expected %.12g +- %.3g", #value, test_v, test_e, test_t);        \
    } while (0)

#define CHECK_LE(value, bound)                                                                 \
    do {                                                                                       \
        double test_v = (double)(value), test_b = (double)(bound);                             \
        if (!(test_v <= test_b)) TEST_FAIL("%s = %.12g, above %.12g", #value, test_v, test_b); \
    } while (0)

#define CHECK_INT(value, expected)                                                           \
    do {                                                                                     \
        long long test_v = (long long)(value), test_e = (long long)(expected);               \
        if (test_v != test_e) TEST_FAIL("%s = %lld, expected %lld", #value, test_v, test_e); \
    } while (0)

/* Ends the case as skipped unless something already failed: if (!have_x) SKIP("no x on this machine"). */
#define SKIP(...)                                                         \
    do {                                                                  \
        snprintf(test_skip_reason, sizeof test_skip_reason, __VA_ARGS__); \
        return;                                                           \
    } while (0)

/* First line of a case that judges a method, by statistics or at length, not how a compiler took the text: `make test`
   runs it in one build only, `make check` not at all. */
#define TEST_METHOD            \
    do {                       \
        if (test_build) {      \
            test_left_out = 1; \
            return;            \
        }                      \
    } while (0)

/* First line of a case that --full runs alone. */
#define TEST_LONG              \
    do {                       \
        if (!test_full) {      \
            test_left_out = 1; \
            return;            \
        }                      \
    } while (0)

/* Whether floating-point exceptions are unmasked in the calls (tests/calls.sh traps): cases that hand over NaN or
   infinity as data, which the processor itself traps on, leave that part out then. */
static TEST_UNUSED int test_unmasked(void)
{
    const char *calls = getenv("CALLS");
    return calls != NULL && strcmp(calls, "traps") == 0;
}

/* --- numbers that do not depend on the code under test --- */

static TEST_UNUSED uint64_t test_random_u64(uint64_t *state)
{
    uint64_t z = (*state += 0x9E3779B97F4A7C15u); /* splitmix64 */
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

static TEST_UNUSED double test_uniform(uint64_t *state)
{
    return ((double)(test_random_u64(state) >> 11) + 0.5) / 9007199254740992.0;
}

static TEST_UNUSED double test_normal(uint64_t *state)
{
    double u = test_uniform(state), v = test_uniform(state);
    return sqrt(-2 * log(u)) * cos(6.283185307179586 * v);
}

/* Upper tail of chi-square with n degrees of freedom (Wilson-Hilferty: within 0.003 for n >= 3). */
static TEST_UNUSED double test_chi2_p(double chi2, int n)
{
    double k = 2.0 / (9.0 * n), z = (pow(chi2 / n, 1.0 / 3.0) - (1 - k)) / sqrt(k);
    return 0.5 * erfc(z / sqrt(2.0));
}

/* --- IEEE binary16 --- */

static TEST_UNUSED float test_half_value(uint16_t h)
{
    const int exponent = h >> 10 & 31, mantissa = h & 1023;
    const double value = exponent == 31 ? (mantissa ? (double)NAN : (double)INFINITY)
        : exponent                      ? ldexp(1024 + mantissa, exponent - 25)
                                        : ldexp(mantissa, -24);
    return (float)(h & 0x8000 ? -value : value);
}

/* The nearest, ties to even; what is finite stays finite. */
static TEST_UNUSED uint16_t test_half_of(float v)
{
    const unsigned sign = signbit(v) ? 0x8000 : 0;
    const double a = fabs((double)v);
    int e;
    if (!(a <= 65504)) return (uint16_t)(sign | (a > 3.5e38 ? 0x7c00u : a > 0 ? 0x7bffu : 0x7e00u));
    if (a < 6.103515625e-5) return (uint16_t)(sign | (unsigned)rint(ldexp(a, 24)));
    frexp(a, &e); /* a = 0.5 to 1 times 2^e */
    return (uint16_t)(sign | ((unsigned)(e + 14) * 1024 + (unsigned)rint(ldexp(a, 11 - e)) - 1024));
}

/* --- an allocator that counts and fails on request --- */

typedef struct test_memory {
    long calls;   /* alloc calls so far */
    long fail_at; /* the call number, from 1, that returns NULL (and every later one if fail_on is set); 0: none */
    int fail_on;
    size_t bytes; /* outstanding */
    size_t peak;
    long blocks; /* outstanding */
    long errors; /* releases with another size than allocated */
} test_memory;

static TEST_UNUSED void *test_memory_alloc(void *user, size_t size)
{
    test_memory *m = (test_memory *)user;
    size_t *p;
    ++m->calls;
    if (m->fail_at && (m->calls == m->fail_at || (m->fail_on && m->calls > m->fail_at))) return NULL;
    if (size > (size_t)-1 - 16) return NULL;
    p = (size_t *)malloc(size + 16);
    if (p == NULL) return NULL;
    p[0] = size;
    m->bytes += size;
    m->blocks++;
    if (m->bytes > m->peak) m->peak = m->bytes;
    memset((char *)p + 16, 0xCD, size); /* nobody may count on zeroed memory */
    return (char *)p + 16;
}

static TEST_UNUSED void test_memory_release(void *user, void *pointer, size_t size)
{
    test_memory *m = (test_memory *)user;
    size_t *p = (size_t *)(void *)((char *)pointer - 16);
    if (p[0] != size) m->errors++;
    m->bytes -= p[0];
    m->blocks--;
    free(p);
}

/* Fails each allocation of CALL in turn until it succeeds. CALL is a statement that uses `allocator` (an
   ms_allocator) and sets `status`; on MS_OK it releases what it made. At most LIMIT rounds. */
#define TEST_ALLOCATION_SWEEP(LIMIT, CALL)                           \
    do {                                                             \
        long test_round;                                             \
        for (test_round = 1; test_round <= (LIMIT); ++test_round) {  \
            test_memory test_m;                                      \
            ms_allocator allocator;                                  \
            ms_status status = MS_OK;                                \
            memset(&test_m, 0, sizeof test_m);                       \
            test_m.fail_at = test_round;                             \
            allocator.user = &test_m;                                \
            allocator.alloc = test_memory_alloc;                     \
            allocator.release = test_memory_release;                 \
            CALL;                                                    \
            CHECK_INT(test_m.blocks, 0);                             \
            CHECK_INT(test_m.errors, 0);                             \
            if (test_m.calls < test_round) {                         \
                CHECK_INT(status, MS_OK);                            \
                break;                                               \
            }                                                        \
            CHECK_INT(status, MS_OUT_OF_MEMORY);                     \
        }                                                            \
        CHECK(test_round <= (LIMIT));                                \
        TEST_NOTE("%ld allocations failed in turn", test_round - 1); \
    } while (0)

/* --- memory of a stated size --- */

#if defined(__has_feature)
#define TEST_HAS_FEATURE(x) __has_feature(x)
#else
#define TEST_HAS_FEATURE(x) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || TEST_HAS_FEATURE(address_sanitizer)
enum { TEST_GUARD = 0 }; /* the sanitizer sees the first byte behind a block, and reads of it, too */
#else
enum { TEST_GUARD = 64 };
#endif

/* size bytes at `offset` (0 to 63) from an aligned address, filled with `fill`; the bytes behind them are known. */
static TEST_UNUSED unsigned char *test_guarded(size_t size, size_t offset, int fill)
{
    unsigned char *block = (unsigned char *)malloc(offset + size + TEST_GUARD);
    size_t i;
    if (block == NULL) abort();
    memset(block, fill, offset + size);
    for (i = 0; i != TEST_GUARD; ++i) block[offset + size + i] = (unsigned char)(0x5A ^ i);
    return block + offset;
}

/* Frees them. Whether nothing was written behind them. */
static TEST_UNUSED int test_unguard(unsigned char *memory, size_t size, size_t offset)
{
    size_t i;
    int intact = 1;
    for (i = 0; i != TEST_GUARD; ++i) intact &= memory[size + i] == (unsigned char)(0x5A ^ i);
    free(memory - offset);
    return intact;
}

/* Of bytes (FNV-1a): equal for equal bits. */
static TEST_UNUSED uint64_t test_print(uint64_t print, const void *bytes, size_t size)
{
    const unsigned char *p = (const unsigned char *)bytes;
    while (size--) print = (print ^ *p++) * 1099511628211u;
    return print;
}

/* --- threads: ms_parallel over n POSIX threads that take the tasks in a scrambled order --- */

typedef struct test_pool {
    int threads, count, next;
    void (*task)(void *context, int index);
    void *context;
    pthread_mutex_t lock;
} test_pool;

static TEST_UNUSED void *test_pool_thread(void *argument)
{
    test_pool *p = (test_pool *)argument;
    for (;;) {
        int i;
        pthread_mutex_lock(&p->lock);
        i = p->next++;
        pthread_mutex_unlock(&p->lock);
        if (i >= p->count) return NULL;
        p->task(p->context, i & 1 ? i : (p->count - 1) - ((p->count - 1) & 1) - i); /* even indices backwards */
    }
}

static TEST_UNUSED void test_pool_run(void *user, int count, void (*task)(void *context, int index), void *context)
{
    test_pool *p = (test_pool *)user;
    pthread_t thread[64];
    int i, n = p->threads < 64 ? p->threads : 64;
    p->count = count;
    p->next = 0;
    p->task = task;
    p->context = context;
    pthread_mutex_init(&p->lock, NULL);
    for (i = 0; i < n; ++i) pthread_create(&thread[i], NULL, test_pool_thread, p);
    for (i = 0; i < n; ++i) pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&p->lock);
}

/* test_pool pool; ms_parallel parallel = test_parallel(&pool, 7); needs a header of ms_*.h before this one. */
#ifdef MS_COMMON
static TEST_UNUSED ms_parallel test_parallel(test_pool *pool, int threads)
{
    ms_parallel parallel;
    memset(pool, 0, sizeof *pool);
    pool->threads = threads;
    parallel.user = pool;
    parallel.run = test_pool_run;
    return parallel;
}
#endif

/* The best level of instructions (ms_simd) that the headers take on this machine; at least that. */
static TEST_UNUSED int test_simd_best(void)
{
    if (test_no_simd) return 1;
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return 4;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return 3;
#endif
    return 2;
}

/* Bytes of a file with a NUL behind them (caller frees), or NULL. */
static TEST_UNUSED char *test_read_file(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;
    long n;
    if (f == NULL) return NULL;
    if (fseek(f, 0, SEEK_END) == 0 && (n = ftell(f)) >= 0 && fseek(f, 0, SEEK_SET) == 0 &&
        (text = (char *)malloc((size_t)n + 1)) != NULL) {
        size_t got = fread(text, 1, (size_t)n, f);
        text[got] = 0;
        if (size) *size = got;
    }
    fclose(f);
    return text;
}

/* --- files --- */

static char test_place[64];  /* the folder of the running program, from the repository's root; empty: none */
static char test_root[1024]; /* the repository's root */

static TEST_UNUSED void test_leave_folder(void)
{
    char command[80];
    if (test_place[0] == 0 || chdir(test_root) != 0) return;
    snprintf(command, sizeof command, "rm -rf %s", test_place);
    if (system(command) != 0) printf("%s was not removed\n", test_place);
}

/* Moves the program to build/test.PROCESS, a folder with links to the repository's files and to the tools in build/,
   which is removed at exit. What the program writes to build/ is its own there, so that copies of it can run side by
   side. */
static TEST_UNUSED int test_enter_folder(void)
{
    char command[600];
    if (getcwd(test_root, sizeof test_root) == NULL) return 0;
    snprintf(test_place, sizeof test_place, "build/test.%ld", (long)getpid());
    snprintf(command, sizeof command,
             "for d in build/test.*; do kill -0 ${d##*.} 2>/dev/null || rm -rf $d; done; "
             "rm -rf %s; mkdir -p %s/build && cd %s && "
             "for f in ../../*; do [ $f = ../../build ] || ln -s $f . || exit 1; done && "
             "for f in ../*; do [ -d $f ] || ! [ -x $f ] || ln -s ../$f build/ || exit 1; done",
             test_place, test_place, test_place);
    if (atexit(test_leave_folder) != 0 || system(command) != 0) return 0;
    return chdir(test_place) == 0;
}

static TEST_UNUSED int test_main(int argc, char **argv, const test_case *cases, int count)
{
    const char *filter = NULL;
    int i, passed = 0, failed = 0, skipped = 0;
    double seconds; /* of processor time, told where it is more than one */
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--full") == 0) test_full = 1;
        else if (strcmp(argv[i], "--build") == 0) test_build = 1;
        else if (strcmp(argv[i], "--no-simd") == 0) test_no_simd = 1;
        else if (strcmp(argv[i], "--fused") == 0) test_fused = 1;
        else if (strcmp(argv[i], "--seed") == 0 && i + 1 < argc) test_seed = strtoull(argv[++i], NULL, 10);
        else filter = argv[i];
    }
    for (i = 0; i < count; ++i) {
        if (filter && strstr(cases[i].name, filter) == NULL) continue;
        test_failures = 0;
        test_note[0] = 0;
        test_skip_reason[0] = 0;
        test_left_out = 0;
        seconds = (double)clock() / CLOCKS_PER_SEC;
        cases[i].run();
        seconds = (double)clock() / CLOCKS_PER_SEC - seconds;
        if (test_left_out) continue;
        if (test_failures) ++failed;
        else if (test_skip_reason[0]) ++skipped;
        else ++passed;
        printf("%s %s%s%s\n",
               test_failures             ? "FAIL"
                   : test_skip_reason[0] ? "skip"
                                         : "ok  ",
               cases[i].name, test_note[0] || test_skip_reason[0] ? ": " : "",
               test_skip_reason[0] ? test_skip_reason : test_note);
        if (seconds >= 1) printf("     (%s: %.1f s)\n", cases[i].name, seconds);
        fflush(stdout);
    }
    printf("%d passed, %d failed, %d skipped\n", passed, failed, skipped);
    return failed != 0;
}

/* static const test_case cases[] = {{"name", function}, ...}; TEST_MAIN(cases) */
#define TEST_MAIN(cases) \
    int main(int argc, char **argv) { return test_main(argc, argv, cases, (int)(sizeof(cases) / sizeof((cases)[0]))); }

/* The same for a program that writes files, in a folder of its own. */
#define TEST_MAIN_WITH_FILES(cases)                                                     \
    int main(int argc, char **argv)                                                     \
    {                                                                                   \
        if (!test_enter_folder()) return printf("%s cannot be made\n", test_place), 1;  \
        return test_main(argc, argv, cases, (int)(sizeof(cases) / sizeof((cases)[0]))); \
    }
#endif
