/* Attacks: random valid calls of a header, and what must hold for each without a reference. A program has families;
   each draws cases from its own generator and checks them.

     attack_X [--seconds 10] [--seed N] [--case K] [--draws 1,2,3] [--host H] [--cases FILE] [--limit 30] [FAMILY]

   Each run takes a fresh seed (of time and process) and prints it. --seed N --case K runs one case again and tells what
   it drew; --draws runs a list of draws. On POSIX systems cases run in a child process, so that a crash, a report of a
   sanitizer or an endless loop (--limit, seconds of processor time a case) is a failure like any other. A failure is
   shrunk: draws are left out or made smaller as long as the same failure is seen. Each kind of failure is told once,
   with the processor time after which it was first seen. Lines "X FAMILY DRAWS" of FILE run before: failures of earlier
   runs. The last line is "N passed, N failed": families.

   Hosts differ: a quarter of the cases run where subnormals are flushed to zero and read as zero (1 of H), a quarter
   where the locale writes 1,5 for 1.5 (2), as far as this machine has that. FILE says "X+H FAMILY DRAWS" of these.

   A draw is 32 bits. All calls below make the simplest value of a draw of 0, and of the draws that a shortened list
   lacks. */
#ifndef MS_ATTACK_H
#define MS_ATTACK_H
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif
#if !defined(__wasi__) && !defined(_WIN32)
#define ATTACK_FORK 1
#include <locale.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#else
#define ATTACK_FORK 0
#endif

#if defined(__GNUC__)
#define ATTACK_UNUSED __attribute__((unused))
#define ATTACK_PRINTF(first) __attribute__((format(printf, first, first + 1), unused))
#else
#define ATTACK_UNUSED
#define ATTACK_PRINTF(first)
#endif

typedef struct attack_family {
    const char *name;
    void (*run)(void); /* draws one case and checks it */
} attack_family;

enum { ATTACK_DRAWS = 8192, ATTACK_FAMILIES = 32, ATTACK_KINDS = 24 };
enum { ATTACK_FLUSH = 1, ATTACK_COMMA = 2 };

/* Of the running case; the parent process reads it after a crash. */
typedef struct attack_board {
    int family;
    uint64_t number;                 /* of the case in its family */
    uint64_t count[ATTACK_FAMILIES]; /* cases that ran */
    double seconds[ATTACK_FAMILIES]; /* processor time of them */
    double slowest[ATTACK_FAMILIES]; /* of one case */
    uint64_t slowest_at[ATTACK_FAMILIES];
    double before; /* processor seconds of earlier children */
    double first;  /* when the case failed: seconds of the whole run */
    int running, draws, given, drew_more, host;
    uint64_t hosts[4]; /* cases by host */
    uint32_t draw[ATTACK_DRAWS];
    int failed;
    char message[500], story[8000];
    int kinds; /* of failures that were told already */
    char kind[ATTACK_KINDS][160];
    long seen[ATTACK_KINDS], bad[ATTACK_FAMILIES];
} attack_board;

static attack_board *attack;
static uint64_t attack_state; /* of the running case's generator */
static int attack_replays;    /* draws come from attack->draw */
static double attack_limit = 30;

/* ---- draws ------------------------------------------------------------------------------------------------------ */

static ATTACK_UNUSED uint64_t attack_mix(uint64_t *state) /* splitmix64 */
{
    uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

static ATTACK_UNUSED uint32_t attack_draw(void)
{
    uint32_t value;
    if (attack->draws == ATTACK_DRAWS) {
        attack->drew_more = 1;
        return 0;
    }
    if (attack_replays) value = attack->draws < attack->given ? attack->draw[attack->draws] : 0;
    else value = (uint32_t)(attack_mix(&attack_state) >> 32);
    attack->draw[attack->draws++] = value;
    return value;
}

/* 0 to count - 1, evenly. */
static ATTACK_UNUSED int attack_index(int count) { return (int)(attack_draw() % (uint32_t)count); }

/* True once in so many cases. */
static ATTACK_UNUSED int attack_one_in(int count) { return attack_draw() % (uint32_t)count == (uint32_t)count - 1; }

/* 0 <= u < 1. */
static ATTACK_UNUSED double attack_unit(void) { return attack_draw() / 4294967296.0; }

/* low to high; an eighth of the draws are an end or the number beside it. */
static ATTACK_UNUSED double attack_linear(double low, double high)
{
    const uint32_t d = attack_draw();
    const double u = (d >> 3) / 536870911.0;
    if ((d & 7) != 7) return low + (high - low) * u;
    switch (d >> 3 & 3) {
    case 0: return low;
    case 1: return high;
    case 2: return nextafter(low, high);
    default: return nextafter(high, low);
    }
}

/* The same with an even logarithm; low above 0. */
static ATTACK_UNUSED double attack_log(double low, double high)
{
    const uint32_t d = attack_draw();
    const double u = (d >> 3) / 536870911.0, v = exp(log(low) + (log(high) - log(low)) * u);
    if ((d & 7) != 7) return u == 0 || v < low ? low : v > high ? high : v;
    switch (d >> 3 & 3) {
    case 0: return low;
    case 1: return high;
    case 2: return nextafter(low, high);
    default: return nextafter(high, low);
    }
}

/* low to high, small ones oftener (even logarithm of 1 + value - low); an eighth are ends, their neighbors, and powers
   of two and theirs. */
static ATTACK_UNUSED int64_t attack_int(int64_t low, int64_t high)
{
    const uint32_t d = attack_draw();
    const double u = (d >> 3) / 536870912.0;
    int64_t v = low + (int64_t)(exp(log((double)(high - low) + 2) * u) - 1);
    if ((d & 7) == 7) {
        const int64_t power = (int64_t)1 << (d >> 8) % 40, side = (int64_t)((d >> 3) % 3) - 1;
        v = (d >> 5 & 3) == 0 ? low + (side > 0) : (d >> 5 & 3) == 1 ? high - (side > 0) : power + side;
    }
    return v < low ? low : v > high ? high : v;
}

/* A float that code forgets: 0, -0, subnormal, the largest, infinite, NaN. */
static ATTACK_UNUSED float attack_odd_float(void)
{
    static const uint32_t bits[] = {0,           0x80000000u, 1,           0x7fffffu,   0x800000u,   0x7f7fffffu,
                                    0xff7fffffu, 0x7f800000u, 0xff800000u, 0x7fc00000u, 0xbf800000u, 0x3f800001u};
    float f;
    memcpy(&f, &bits[attack_index((int)(sizeof bits / sizeof *bits))], sizeof f);
    return f;
}

/* count floats of low to high from one draw; of a draw of 0 all are `low`. */
static ATTACK_UNUSED void attack_fill(float *out, size_t count, double low, double high)
{
    const uint32_t d = attack_draw();
    uint64_t state = d;
    size_t i;
    for (i = 0; i < count; ++i)
        out[i] = (float)(d == 0 ? low : low + (high - low) * (double)(attack_mix(&state) >> 11) / 9007199254740992.0);
}

/* ---- what a case says ------------------------------------------------------------------------------------------- */

/* The failure of a case; the words before the first colon are its kind. The first one counts. */
static ATTACK_PRINTF(1) void attack_fail(const char *format, ...)
{
    va_list list;
    if (attack->failed) return;
    attack->failed = 1;
    va_start(list, format);
    vsnprintf(attack->message, sizeof attack->message, format, list);
    va_end(list);
}

/* What the case is, told when it fails. */
static ATTACK_PRINTF(1) void attack_say(const char *format, ...)
{
    const size_t at = strlen(attack->story);
    va_list list;
    va_start(list, format);
    vsnprintf(attack->story + at, sizeof attack->story - at, format, list);
    va_end(list);
}

#define ATTACK_CHECK(condition, ...)                \
    do {                                            \
        if (!(condition)) attack_fail(__VA_ARGS__); \
    } while (0)

/* ---- memory, threads -------------------------------------------------------------------------------------------- */

/* Counts, refuses on request, and knows the 64 bytes behind each block. A case ends with all of it given back. */
typedef struct attack_memory {
    size_t bytes, peak, limit; /* limit: of one block */
    long blocks, calls, fail_at;
} attack_memory;
static attack_memory attack_heap;

static ATTACK_UNUSED void *attack_alloc(void *user, size_t size)
{
    attack_memory *m = (attack_memory *)user;
    unsigned char *p;
    int i;
    if (++m->calls == m->fail_at || size > m->limit) return NULL;
    p = (unsigned char *)malloc(size + 128);
    if (p == NULL) return NULL;
    memcpy(p, &size, sizeof size);
    for (i = 0; i < 64; ++i) p[64 + size + (size_t)i] = (unsigned char)(0x5a ^ i);
    memset(p + 64, 0xcd, size < 65536 ? size : 65536);
    m->bytes += size;
    m->blocks++;
    if (m->bytes > m->peak) m->peak = m->bytes;
    return p + 64;
}

static ATTACK_UNUSED void attack_release(void *user, void *pointer, size_t size)
{
    attack_memory *m = (attack_memory *)user;
    unsigned char *p = (unsigned char *)pointer - 64;
    size_t was;
    int i, bad = 0;
    memcpy(&was, p, sizeof was);
    if (was != size) attack_fail("released with another size: %zu for %zu", size, was);
    for (i = 0; i < 64; ++i) bad |= p[64 + was + (size_t)i] != (unsigned char)(0x5a ^ i);
    if (bad) attack_fail("written behind a block: of %zu bytes", was);
    m->bytes -= was;
    m->blocks--;
    free(p);
}

/* Tasks in a drawn order on the calling thread: what does not depend on the order has no race of this kind. */
static ATTACK_UNUSED void attack_run_tasks(void *user, int count, void (*task)(void *context, int index), void *context)
{
    const int turn = *(int *)user, start = turn % count;
    int i, step = 1 + turn / 7 % count, a, b;
    for (;; ++step) { /* one that has no divisor with count */
        for (a = step, b = count; b != 0;) {
            const int rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1) break;
    }
    for (i = 0; i < count; ++i) task(context, (int)((start + (int64_t)i * step) % count));
}

#ifdef MS_COMMON
static int attack_turn;
static ATTACK_UNUSED ms_parallel attack_parallel(void)
{
    ms_parallel parallel;
    attack_turn = attack_index(1000);
    parallel.user = &attack_turn;
    parallel.run = attack_run_tasks;
    return parallel;
}

static ATTACK_UNUSED ms_allocator attack_allocator(size_t limit)
{
    ms_allocator allocator;
    attack_heap.limit = limit;
    allocator.user = &attack_heap;
    allocator.alloc = attack_alloc;
    allocator.release = attack_release;
    return allocator;
}

/* A failure has a status, a sentence and no garbage behind it. */
static ATTACK_UNUSED void attack_check_error(ms_status status, const ms_error *error)
{
    size_t i, length = 0;
    while (length < sizeof error->message && error->message[length] != 0) ++length;
    ATTACK_CHECK(status > MS_OK && status <= MS_IO, "status out of its list: %d", (int)status);
    ATTACK_CHECK(error->status == status, "error has another status: %d for %d", (int)error->status, (int)status);
    ATTACK_CHECK(length > 8 && length < sizeof error->message, "error without a sentence: %d characters", (int)length);
    for (i = 0; i < length && i < sizeof error->message; ++i)
        if ((unsigned char)error->message[i] < 32) attack_fail("control characters in a sentence: %d", (int)i);
}

static ATTACK_UNUSED ms_error attack_no_error(void)
{
    ms_error error;
    memset(&error, 0x7e, sizeof error);
    return error;
}
#endif

/* ---- runs ------------------------------------------------------------------------------------------------------- */

static double attack_clock(void) { return (double)clock() / CLOCKS_PER_SEC; }

static uint64_t attack_hash(const char *text, uint64_t seed, uint64_t number)
{
    uint64_t state = seed ^ number * 0xD1342543DE82EF95u;
    while (*text) state = (state ^ (unsigned char)*text++) * 1099511628211u;
    attack_mix(&state);
    return state;
}

/* Turns this thread into a host of that kind; returns what of it this machine has. */
static int attack_become(int host)
{
    static int was;
    int has = 0;
#if defined(__SSE2__) || defined(_M_X64)
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (host & ATTACK_FLUSH ? 0x8040u : 0));
    has |= host & ATTACK_FLUSH;
#elif defined(__GNUC__) && defined(__aarch64__)
    {
        uint64_t control;
        __asm__ volatile("mrs %0, fpcr" : "=r"(control));
        control = host & ATTACK_FLUSH ? control | 1u << 24 : control & ~((uint64_t)1 << 24);
        __asm__ volatile("msr fpcr, %0" : : "r"(control));
        has |= host & ATTACK_FLUSH;
    }
#endif
#if ATTACK_FORK
    if (host & ATTACK_COMMA) {
        static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8", "de_DE"};
        size_t i;
        for (i = 0; i < sizeof names / sizeof *names && !(has & ATTACK_COMMA); ++i)
            if (setlocale(LC_NUMERIC, names[i]) != NULL && *localeconv()->decimal_point == ',') has |= ATTACK_COMMA;
    }
    if (was & ATTACK_COMMA && !(has & ATTACK_COMMA)) setlocale(LC_NUMERIC, "C");
#endif
    was = has;
    return has;
}

/* One case in this process; `given` draws come from the board, or all from the seed where it is below 0. */
static void attack_case(const attack_family *family, uint64_t seed, uint64_t number, int given)
{
    attack->number = number;
    attack->draws = attack->drew_more = attack->failed = 0;
    attack->given = given;
    attack->message[0] = attack->story[0] = 0;
    attack_replays = given >= 0;
    attack_state = attack_hash(family->name, seed, number);
    if (given < 0) {
        uint64_t apart = attack_state;
        attack->host = (int)(attack_mix(&apart) >> 62) % 3; /* 0 twice as often */
    }
    attack->host = attack_become(attack->host);
    ++attack->hosts[attack->host];
    memset(&attack_heap, 0, sizeof attack_heap);
    attack_heap.limit = (size_t)1 << 30;
    attack->running = 1;
#if ATTACK_FORK
    {
        struct itimerval timer;
        memset(&timer, 0, sizeof timer);
        timer.it_value.tv_sec = (time_t)attack_limit + 1;
        setitimer(ITIMER_VIRTUAL, &timer, NULL); /* its signal ends the process */
    }
#endif
    family->run();
    attack->running = 0;
    attack_become(0);
    if (attack_heap.blocks != 0)
        attack_fail("memory not given back: %ld blocks, %zu bytes", attack_heap.blocks, attack_heap.bytes);
}

/* The kind of a failure: the place of a sanitizer's report, else the words before the colon. */
static void attack_kind_of(const char *message, const char *family, char kind[160])
{
    const char *colon = strchr(message, ':'), *line = strstr(message, "ms_"), *dot = line ? strstr(line, ".h:") : NULL;
    size_t length;
    if (dot != NULL && (strstr(message, "runtime error") || strstr(message, "Sanitizer"))) {
        snprintf(kind, 160, "%.30s %.*s%d", family, (int)(dot + 3 - line), line, atoi(dot + 3));
        return;
    }
    length = colon ? (size_t)(colon - message) : strlen(message);
    snprintf(kind, 160, "%.30s %.*s", family, (int)(length < 120 ? length : 120), message);
}

/* Whether the failure on the board is of a kind that was told; counts it. */
static int attack_known(const attack_family *families)
{
    char kind[160];
    int k;
    attack_kind_of(attack->message, families[attack->family].name, kind);
    attack->bad[attack->family]++;
    for (k = 0; k < attack->kinds && strcmp(attack->kind[k], kind) != 0;) ++k;
    if (k == ATTACK_KINDS) return 1;
    attack->seen[k]++;
    if (k < attack->kinds) return 1;
    memcpy(attack->kind[attack->kinds++], kind, sizeof kind);
    return 0;
}

/* Cases of the families that had the least time, until the time is over or a case failed in a new way: 1. */
static int attack_some(const attack_family *families, int count, const char *filter, uint64_t seed, double seconds)
{
    const double start = attack_clock();
    for (;;) {
        double now = attack_clock(), spent;
        int i, least = -1;
        if (attack->before + now - start >= seconds) return 0;
        for (i = 0; i < count; ++i)
            if ((filter == NULL || strstr(families[i].name, filter) != NULL) &&
                (least < 0 || attack->seconds[i] < attack->seconds[least]))
                least = i;
        if (least < 0) return 0;
        attack->family = least;
        attack->first = attack->before + now - start;
        attack_case(&families[least], seed, attack->count[least]++, -1);
        spent = attack_clock() - now;
        attack->seconds[least] += spent + 1e-5;
        attack->first += spent;
        if (spent > attack->slowest[least]) {
            attack->slowest[least] = spent;
            attack->slowest_at[least] = attack->number;
        }
        if (attack->failed && !attack_known(families)) return 1;
        attack->failed = 0;
    }
}

static void attack_tell(const attack_family *family, uint64_t seed, const char *program, const char *title)
{
    int i;
    printf("%s %s: %s\n", title, family->name, attack->message);
    if (attack->story[0])
        printf("     %s%s", attack->story, attack->story[strlen(attack->story) - 1] == '\n' ? "" : "\n");
    printf("     again: %s --seed %llu --case %llu %s\n", program, (unsigned long long)seed,
           (unsigned long long)attack->number, family->name);
    if (attack->host) printf("     host:  %s\n", attack->host & ATTACK_FLUSH ? "flushes subnormals" : "writes 1,5");
    if (attack->draws > 0 && attack->draws <= 200) {
        printf("     or:    %s --host %d --draws ", program, attack->host);
        for (i = 0; i < attack->draws; ++i) printf("%s%lu", i ? "," : "", (unsigned long)attack->draw[i]);
        printf(" %s\n", family->name);
    }
    fflush(stdout);
}

#if ATTACK_FORK
/* The sentence of a dead child: of the sanitizer, or the signal. */
static void attack_post_mortem(const char *log, int status)
{
    FILE *f = fopen(log, "r");
    char line[400], what[200] = "", place[200] = "";
    while (f != NULL && fgets(line, sizeof line, f) != NULL) {
        char *at = strstr(line, "runtime error");
        line[strcspn(line, "\n")] = 0;
        if (at != NULL && !what[0]) {
            char *name = strstr(line, "ms_");
            snprintf(what, sizeof what, "%.190s", name && name < at ? name : line);
        }
        at = strstr(line, "ERROR: ");
        if (at != NULL && !what[0]) snprintf(what, sizeof what, "%.150s", at + 7);
        at = strstr(line, "ms_");
        if (at != NULL && what[0] && !place[0] && strstr(line, " #") && strstr(line, ".h:")) {
            while (strchr(at, ' ') && strstr(strchr(at, ' '), "ms_")) at = strstr(strchr(at, ' '), "ms_");
            snprintf(place, sizeof place, "%.190s", at);
        }
    }
    if (f != NULL) fclose(f);
    attack->failed = 1;
    if (what[0]) snprintf(attack->message, sizeof attack->message, "%s%s%s", what, place[0] ? " at " : "", place);
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM)
        snprintf(attack->message, sizeof attack->message, "time: a case ran for over %g s", attack_limit);
    else if (WIFSIGNALED(status))
        snprintf(attack->message, sizeof attack->message, "signal %d: the process ended", WTERMSIG(status));
    else snprintf(attack->message, sizeof attack->message, "exit %d: the process ended", WEXITSTATUS(status));
}

/* Processor seconds of all children so far. */
static double attack_children(void)
{
    struct rusage u;
    getrusage(RUSAGE_CHILDREN, &u);
    return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) + 1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

/* Runs `some` (case < 0) or the draws of the board in a child. 1: a case failed. */
static int attack_child(const attack_family *families, int count, const char *filter, uint64_t seed, double seconds,
                        int given, const char *log)
{
    int status = 0;
    pid_t child;
    fflush(stdout);
    child = fork();
    if (child < 0) return 0;
    if (child == 0) {
        if (freopen(log, "w", stderr) == NULL) _exit(3);
        if (given < 0) attack_some(families, count, filter, seed, seconds);
        else attack_case(&families[attack->family], seed, attack->number, given);
        fflush(NULL);
        _exit(0);
    }
    while (waitpid(child, &status, 0) < 0) {}
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) attack_post_mortem(log, status);
    return attack->failed;
}

/* Shorter and smaller lists of draws that fail in the same way. The board holds the failing case. */
static void attack_shrink(const attack_family *families, int count, uint64_t seed, const char *log)
{
    static attack_board best;
    const char *family = families[attack->family].name;
    char kind[160], now[160];
    int chunk, i, tries = 0, halve = 0;
    const time_t end = time(NULL) + 10;
    attack_kind_of(attack->message, family, kind);
    best = *attack;
    if (strstr(kind, " time") != NULL) return;
    for (chunk = best.draws; chunk >= 0 && tries < 300 && time(NULL) < end; chunk = chunk > 1 ? chunk / 2 : chunk - 1) {
        for (i = 0; i < best.draws && tries < 300 && time(NULL) < end;) {
            int k, given = best.draws, changed = 0;
            memcpy(attack->draw, best.draw, sizeof best.draw);
            if (chunk == 0) { /* each by itself: 0, else half */
                changed = best.draw[i] != 0;
                attack->draw[i] = halve ? best.draw[i] / 2 : 0;
            } else if (i + chunk <= given) {
                for (k = i; k + chunk < given; ++k) attack->draw[k] = best.draw[k + chunk];
                given -= chunk;
                changed = 1;
            }
            if (changed) {
                ++tries;
                attack->family = best.family;
                attack->number = best.number;
                attack->host = best.host;
                if (attack_child(families, count, NULL, seed, 0, given, log)) {
                    attack_kind_of(attack->message, family, now);
                    if (strcmp(kind, now) == 0 && attack->draws <= best.draws) {
                        const double first = best.first;
                        best = *attack;
                        best.first = first;
                        if (chunk || halve) continue; /* the same place again */
                    }
                }
            }
            if (chunk == 0 && !halve) halve = 1;
            else {
                halve = 0;
                i += chunk ? chunk : 1;
            }
        }
    }
    memcpy(best.hosts, attack->hosts, sizeof best.hosts);
    best.kinds = attack->kinds;
    memcpy(best.kind, attack->kind, sizeof best.kind);
    memcpy(best.seen, attack->seen, sizeof best.seen);
    for (i = 0; i < ATTACK_FAMILIES; ++i) { /* what the run counts */
        best.bad[i] = attack->bad[i];
        best.count[i] = attack->count[i];
        best.seconds[i] = attack->seconds[i];
        best.slowest[i] = attack->slowest[i];
        best.slowest_at[i] = attack->slowest_at[i];
    }
    *attack = best;
}
#endif

#if ATTACK_FORK
/* The lines of a file of earlier failures that are this program's. */
static void attack_earlier(const attack_family *families, int count, const char *path, const char *program,
                           const char *log)
{
    static char line[60000];
    const char *name = strstr(program, "attack_");
    FILE *f = fopen(path, "r");
    while (name != NULL && strstr(name + 1, "attack_") != NULL) name = strstr(name + 1, "attack_");
    while (f != NULL && name != NULL && fgets(line, sizeof line, f) != NULL) {
        char header[40], family[40];
        int at = 0, i, given = 0;
        char *draws = line;
        if (sscanf(line, "%39s %39s %n", header, family, &at) < 2 || line[0] == '#' || at == 0) continue;
        attack->host = strchr(header, '+') ? atoi(strchr(header, '+') + 1) : 0;
        if (strncmp(name + 7, header, strcspn(header, "+")) != 0) continue;
        for (i = 0; i < count && strcmp(families[i].name, family) != 0;) ++i;
        if (i == count) continue;
        for (draws += at; *draws >= '0' && *draws <= '9' && given < ATTACK_DRAWS; draws += *draws == ',')
            attack->draw[given++] = (uint32_t)strtoul(draws, (char **)(void *)&draws, 10);
        attack->family = i;
        attack->number = attack->count[i]++;
        attack->failed = 0;
        if (attack_child(families, count, NULL, 0, 0, given, log) && !attack_known(families))
            attack_tell(&families[i], 0, program, "FAIL (of an earlier run)");
    }
    if (f != NULL) fclose(f);
}
#endif

static int attack_main(int argc, char **argv, const attack_family *families, int count)
{
    const char *filter = NULL, *draws = NULL, *cases = NULL;
    double seconds = 10;
    uint64_t seed = (uint64_t)time(NULL) * 1000003u, number = 0;
    int i, one = 0, passed = 0, failed = 0;
#if ATTACK_FORK
    seed ^= (uint64_t)getpid() << 20;
    {
        FILE *shared = tmpfile();
        if (shared == NULL || ftruncate(fileno(shared), (off_t)sizeof *attack) != 0) return 2;
        attack = (attack_board *)mmap(NULL, sizeof *attack, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(shared), 0);
        if ((void *)attack == MAP_FAILED) return 2;
    }
#else
    attack = (attack_board *)calloc(1, sizeof *attack);
    if (attack == NULL) return 2;
#endif
    seed %= 1000000007u;
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--seconds") == 0 && i + 1 < argc) seconds = atof(argv[++i]);
        else if (strcmp(argv[i], "--seed") == 0 && i + 1 < argc) seed = strtoull(argv[++i], NULL, 10);
        else if (strcmp(argv[i], "--case") == 0 && i + 1 < argc) number = strtoull(argv[++i], NULL, 10), one = 1;
        else if (strcmp(argv[i], "--draws") == 0 && i + 1 < argc) draws = argv[++i], one = 1;
        else if (strcmp(argv[i], "--host") == 0 && i + 1 < argc) attack->host = atoi(argv[++i]);
        else if (strcmp(argv[i], "--cases") == 0 && i + 1 < argc) cases = argv[++i];
        else if (strcmp(argv[i], "--limit") == 0 && i + 1 < argc) attack_limit = atof(argv[++i]);
        else filter = argv[i];
    }
    if (one) { /* in this process, so that a debugger sees it */
        int given = -1;
        for (i = 0; i < count && (filter == NULL || strcmp(families[i].name, filter) != 0);) ++i;
        if (i == count) return printf("name the family\n"), 2;
        if (draws != NULL)
            for (given = 0; *draws && given < ATTACK_DRAWS; draws += *draws == ',')
                attack->draw[given++] = (uint32_t)strtoul(draws, (char **)(void *)&draws, 10);
        attack->family = i;
        attack_limit = 1e6;
        attack_case(&families[i], seed, number, given);
        if (!attack->failed) snprintf(attack->message, sizeof attack->message, "nothing was found");
        attack_tell(&families[i], seed, argv[0], attack->failed ? "FAIL" : "ok  ");
        return attack->failed;
    }
    printf("seed %llu, %g s\n", (unsigned long long)seed, seconds);
    (void)cases;
#if ATTACK_FORK
    { /* a locale of its own, where none of these names is installed */
        static char folder[600];
        snprintf(folder, sizeof folder,
                 "mkdir -p '%s.locale' && localedef -i de_DE -f UTF-8 '%s.locale/de_DE.UTF-8' >/dev/null 2>&1", argv[0],
                 argv[0]);
        if (attack_become(ATTACK_COMMA) == 0 && system(folder) == 0) {
            snprintf(folder, sizeof folder, "%s.locale", argv[0]);
            setenv("LOCPATH", folder, 1);
        }
        attack_become(0);
    }
#endif
#if ATTACK_FORK
    {
        double shrinking = 0;
        char log[512]; /* of a child, beside the program */
        snprintf(log, sizeof log, "%s.%ld.log", argv[0], (long)getpid());
        if (cases != NULL) attack_earlier(families, count, cases, argv[0], log);
        for (;;) {
            const double start = attack_children();
            double first;
            uint64_t at;
            attack->before = start - shrinking;
            if (attack->before >= seconds) break;
            attack->failed = 0;
            if (!attack_child(families, count, filter, seed, seconds, -1, log)) break;
            i = attack->family;
            if (attack->running && attack_known(families)) continue; /* it died, as another before it */
            at = attack->number;
            first = attack->first;
            shrinking -= attack_children();
            attack_shrink(families, count, seed, log);
            shrinking += attack_children();
            attack->number = at;
            attack_tell(&families[i], seed, argv[0], "FAIL");
            printf("     after %.2f s and %llu cases\n", first, (unsigned long long)attack->count[i]);
            fflush(stdout);
        }
        for (i = 0; i < attack->kinds; ++i) printf("%ld times: %s\n", attack->seen[i], attack->kind[i]);
        remove(log);
    }
#else
    while (attack_some(families, count, filter, seed, seconds)) {
        attack_tell(&families[attack->family], seed, argv[0], "FAIL");
        attack->before = 0;
        for (i = 0; i < count; ++i) attack->before += attack->seconds[i];
    }
#endif
    for (i = 0; i < count; ++i) {
        if (attack->count[i] == 0) continue;
        printf("%s %s: %llu cases, %ld failed, %.1f s, slowest %.2f s (case %llu)\n", attack->bad[i] ? "FAIL" : "ok  ",
               families[i].name, (unsigned long long)attack->count[i], attack->bad[i], attack->seconds[i],
               attack->slowest[i], (unsigned long long)attack->slowest_at[i]);
        if (attack->bad[i]) ++failed;
        else ++passed;
    }
    printf("%llu cases on plain hosts, %llu where subnormals are flushed, %llu where 1.5 is 1,5\n",
           (unsigned long long)attack->hosts[0], (unsigned long long)attack->hosts[ATTACK_FLUSH],
           (unsigned long long)attack->hosts[ATTACK_COMMA]);
    printf("%d passed, %d failed\n", passed, failed);
    return failed != 0;
}
#endif
