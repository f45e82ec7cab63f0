/* Timing for the benchmarks: repeated runs, medians, ratios of runs taken in turn. Machines are shared, so compare
   only numbers of one run of one program. */
#ifndef MS_BENCH_H
#define MS_BENCH_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#if defined(__GNUC__)
#define BENCH_UNUSED __attribute__((unused))
#else
#define BENCH_UNUSED
#endif

static BENCH_UNUSED double bench__clock(clockid_t id)
{
    struct timespec t;
    clock_gettime(id, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds that this thread ran: other programs on the machine disturb it less than wall time. */
static BENCH_UNUSED double bench_cpu(void) { return bench__clock(CLOCK_THREAD_CPUTIME_ID); }

/* Seconds on the wall, for runs on several threads. */
static BENCH_UNUSED double bench_wall(void) { return bench__clock(CLOCK_MONOTONIC); }

static BENCH_UNUSED int bench__compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorts t. */
static BENCH_UNUSED double bench_median(double *t, int n)
{
    qsort(t, (size_t)n, sizeof *t, bench__compare);
    return n % 2 ? t[n / 2] : 0.5 * (t[n / 2 - 1] + t[n / 2]);
}

/* Median and half the distance of the quartiles of n timed runs (thread CPU seconds) of run(context). */
typedef struct bench_time {
    double median, spread;
} bench_time;

static BENCH_UNUSED bench_time bench_summary(double *t, int n)
{
    bench_time r;
    r.median = bench_median(t, n);
    r.spread = 0.5 * (t[(3 * (n - 1)) / 4] - t[(n - 1) / 4]);
    return r;
}

static BENCH_UNUSED bench_time bench_run(void (*run)(void *context), void *context, int n)
{
    double t[64];
    int i;
    if (n > 64) n = 64;
    run(context); /* warm up */
    for (i = 0; i < n; ++i) {
        double start = bench_cpu();
        run(context);
        t[i] = bench_cpu() - start;
    }
    return bench_summary(t, n);
}

/* Two functions in turn, A B A B ...: the medians of both and of the ratio b / a pair by pair. */
typedef struct bench_pair {
    bench_time a, b, ratio;
} bench_pair;

static BENCH_UNUSED bench_pair bench_compare(void (*run_a)(void *), void *a, void (*run_b)(void *), void *b, int n)
{
    double ta[64], tb[64], tr[64];
    bench_pair r;
    int i;
    if (n > 64) n = 64;
    run_a(a);
    run_b(b);
    for (i = 0; i < n; ++i) {
        double t0 = bench_cpu(), t1, t2;
        run_a(a);
        t1 = bench_cpu();
        run_b(b);
        t2 = bench_cpu();
        ta[i] = t1 - t0;
        tb[i] = t2 - t1;
        tr[i] = tb[i] / ta[i];
    }
    r.a = bench_summary(ta, n);
    r.b = bench_summary(tb, n);
    r.ratio = bench_summary(tr, n);
    return r;
}

/* Opens build/bench/NAME for writing (makes the folder); ends the program if it can't. */
static BENCH_UNUSED FILE *bench_open(const char *name)
{
    char path[300];
    FILE *f;
    mkdir("build", 0777);
    mkdir("build/bench", 0777);
    snprintf(path, sizeof path, "build/bench/%s", name);
    f = fopen(path, "w");
    if (f == NULL) {
        fprintf(stderr, "cannot write %s\n", path);
        exit(1);
    }
    return f;
}

/* The processor's name for the line above a table ("unknown processor" where /proc/cpuinfo lacks it). */
static BENCH_UNUSED const char *bench_processor(void)
{
    static char name[128] = "unknown processor";
    char line[256];
    FILE *f = fopen("/proc/cpuinfo", "r");
    if (f) {
        while (fgets(line, sizeof line, f)) {
            char *colon = strchr(line, ':');
            if (strncmp(line, "model name", 10) == 0 && colon) {
                snprintf(name, sizeof name, "%.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
                break;
            }
        }
        fclose(f);
    }
    return name;
}
#endif
