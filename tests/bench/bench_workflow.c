/* The stages of examples/tools/workflow.c beside the thesis's Table 3.3: runs build/workflow nine times and keeps the
   table of the run with the median sum. Writes build/bench/workflow.md and workflow.csv. */
#include "bench.h"

enum { RUNS = 9, TEXT = 8192 };

typedef struct run {
    double sum, longest; /* ms, all stages, longest interactive call */
    char table[TEXT];
} run;

static int compare(const void *a, const void *b)
{
    double x = ((const run *)a)->sum, y = ((const run *)b)->sum;
    return (x > y) - (x < y);
}

/* Runs it once; 0 where it failed. */
static int workflow(run *r)
{
    const char *sum;
    char *call;
    size_t got;
    FILE *f;
    if (system("mkdir -p build/bench/workflow && build/workflow build/bench/workflow >build/bench/workflow/log") != 0)
        return 0;
    f = fopen("build/bench/workflow/times.md", "r");
    if (f == NULL) return 0;
    got = fread(r->table, 1, TEXT - 1, f);
    fclose(f);
    r->table[got] = 0;
    sum = strstr(r->table, "| **sum** | | **");
    r->sum = sum ? atof(sum + 16) : 0;
    r->longest = 0;
    for (call = strstr(r->table, "|---|---:|---:|---:|"); call && (call = strchr(call, '\n')) != NULL; ++call) {
        double mean, most;
        if (sscanf(call, " | %*[^|]| %*d | %lf | %lf", &mean, &most) == 2 && most > r->longest) r->longest = most;
    }
    return sum != NULL;
}

int main(void)
{
    static run runs[RUNS];
    double longest = 0;
    FILE *md, *csv;
    int i;
    for (i = 0; i < RUNS; ++i) {
        if (!workflow(&runs[i])) {
            fprintf(stderr, "build/workflow failed: are the networks in examples/data?\n");
            return 1;
        }
        if (runs[i].longest > longest) longest = runs[i].longest;
    }
    csv = bench_open("workflow.csv");
    fprintf(csv, "sum_ms,longest_call_ms\n");
    for (i = 0; i < RUNS; ++i) fprintf(csv, "%.0f,%.2f\n", runs[i].sum, runs[i].longest);
    qsort(runs, RUNS, sizeof *runs, compare);
    md = bench_open("workflow.md");
    fprintf(
        md,
        "One core of %s, gcc -O2, processor time, the run with the median sum of %d (%.0f to %.0f ms), `make bench FILTER=workflow`.\n"
        "The thesis: Intel Core i5-6600, pictures on an NVIDIA GeForce GTX TITAN X.\n\n%s\nThe longest of all calls in %d runs took %.1f ms.\n",
        bench_processor(), RUNS, runs[0].sum, runs[RUNS - 1].sum, runs[RUNS / 2].table, RUNS, longest);
    printf("%s\nsum %.0f to %.0f ms, longest interactive call %.2f ms\n", runs[RUNS / 2].table, runs[0].sum,
           runs[RUNS - 1].sum, longest);
    return fclose(md) != 0 || fclose(csv) != 0;
}
