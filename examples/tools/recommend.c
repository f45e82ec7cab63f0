/* Learns a taste from scored materials and recommends new ones.

     cc -O2 -I. examples/tools/recommend.c -o build/recommend -lm
     build/recommend SCORES.csv [--pairs PAIRS.csv] [--count 300] [--skip 0] [--tau 0.6] [--seed S]
                     [--out FILE] [--keep WISH]... [--list LIST.csv]... [--avoid MATERIALS.csv]

   SCORES.csv: a material a line, its parameters and its score, in the columns that the header line names: roughness,
   sheen, ..., score. Without a header they are x0, x1, ... and the score is the last (scores.h has the details).
   PAIRS.csv: comparisons, the number of the preferred material and that of the other one in a line, counted from 1 in
   the order of SCORES.csv; materials that were only compared have nothing behind their last comma. The recommendations
   go to FILE, or to standard output, with their parameters, mean and sigma: predicted score and standard deviation.
   Parameters stay in [0, 1], or in the range of the scored materials, rounded outwards, where those leave it; columns
   of one value keep it. Scores may be on any scale. --keep sheen=0.5 fixes a parameter, sheen=0.2:0.4 is a range,
   sheen=0:1:0.25 one in steps; red=green makes two equal. A list has the values that some parameters take together,
   such as metals; its first line names them, red,green,blue. What is avoided may be a file of recommendations. What the
   answers do not support is said in lines that begin with "warning:". */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "scores.h"
#include "space.h"
#include "keep.h"
#include "explain.h"
#include "warnings.h"

static const char usage[] =
    "usage: recommend SCORES.csv [--pairs PAIRS.csv] [--count 300] [--skip 0] [--tau 0.6] [--seed S] "
    "[--keep WISH]... [--list LIST.csv]... [--avoid MATERIALS.csv] [--out FILE]\n"
    "  PAIRS.csv: lines of two numbers of materials in SCORES.csv, from 1, the preferred one first;\n"
    "  count: 1 to 1000000; skip: so many of the same seed are left out; tau: above 0, at most 1;\n"
    "  WISH: x3=0.5, x3=0.2:0.4, x3=0:1:0.25 (in steps), x3=x4, with the names of the columns;\n"
    "  LIST.csv: rows to choose from below a line of their names\n";

static int misused(const char *option, const char *value, const char *expected)
{
    fprintf(stderr, "recommend: %s %s: expected %s\n", option, value, expected);
    return file_usage(usage);
}

/* The value behind an option; ends the program where it is no number from low to high, or is to be a whole one and is
   not. */
static double number(char **option, double low, double high, int whole, const char *expected)
{
    char *end;
    double v = number_read(option[1], '.', &end);
    if (end == option[1] || *end || !(v >= low && v <= high) || (whole && v > floor(v)))
        exit(misused(option[0], option[1], expected));
    return v;
}

/* A name in quotes where the table needs them. */
static void write_name(FILE *f, const char *name)
{
    const int quoted = strpbrk(name, ",;\t\"\n") != NULL;
    if (quoted) putc('"', f);
    for (; *name; ++name) {
        if (*name == '"') putc('"', f);
        putc(*name, f);
    }
    if (quoted) putc('"', f);
}

static void write_csv(FILE *f, const scores *s, const double *x, const double *mean, const double *sigma, int count)
{
    const int m = s->m;
    char text[48];
    int i, k;
    for (k = 0; k < m; ++k) write_name(f, s->name[k]), putc(',', f);
    fprintf(f, "mean,sigma\n");
    for (i = 0; i < count; ++i) {
        for (k = 0; k < m; ++k) fprintf(f, "%s,", number_text(text, "%.9g", x[(size_t)i * (size_t)m + (size_t)k]));
        fprintf(f, "%s,", number_text(text, "%.6g", mean[i]));
        fprintf(f, "%s\n", number_text(text, "%.6g", sigma[i]));
    }
}

/* The comparisons in a file, as pairs of rows below n; how many, or -1: *problem says why. */
static int read_pairs(const char *path, int n, int **pairs, const char **problem, int *line)
{
    static scores s; /* whose sentence is returned */
    int count = -1, i;
    *problem = scores_read_table(path, &s);
    *line = s.line;
    if (*problem == NULL && s.m != 2) *problem = "a line is not two numbers of materials", *line = s.lines[0];
    for (i = 0; i < s.n && *problem == NULL; ++i) {
        const double a = s.x[2 * i], b = s.x[2 * i + 1];
        if (a >= 1 && a <= n && b >= 1 && b <= n && floor(a) >= a && floor(b) >= b && (a < b || a > b)) continue;
        *problem = "a comparison is not of two materials of the scores, counted from 1";
        *line = s.lines[i];
    }
    if (*problem == NULL && (*pairs = (int *)malloc(2 * (size_t)s.n * sizeof **pairs)) == NULL)
        *problem = "too large for memory";
    if (*problem != NULL) return -1;
    for (i = 0, count = s.n; i < 2 * count; ++i) (*pairs)[i] = (int)s.x[i] - 1;
    scores_free(&s);
    return count;
}

/* The materials of a file, [*count][m]: the columns that it calls as `known` does, or else its first. */
static const char *read_materials(const char *path, const scores *known, double **x, int *count, int *line)
{
    static scores s; /* whose sentence is returned */
    const char *problem = scores_read_table(path, &s);
    const int m = known->m;
    int i, k, from, named;
    *line = s.line;
    if (problem) return problem;
    if (s.m < m) return "has fewer columns than the scores have parameters";
    if ((*x = (double *)malloc((size_t)s.n * (size_t)m * sizeof **x)) == NULL) return "too large for memory";
    for (k = 0; k < m; ++k) {
        for (from = k, named = 0; named < s.m && strcmp(s.name[named], known->name[k]) != 0; ++named) {}
        if (named < s.m) from = named;
        else if (s.named && known->named) return "lacks a column of the scores";
        for (i = 0; i < s.n; ++i) (*x)[(size_t)i * (size_t)m + (size_t)k] = s.x[(size_t)i * (size_t)s.m + (size_t)from];
    }
    *count = s.n;
    scores_free(&s);
    return NULL;
}

static int failed(const char *where, const char *problem, int line)
{
    if (line > 0) fprintf(stderr, "recommend: %s: %s (line %d)\n", where, problem, line);
    else fprintf(stderr, "recommend: %s: %s\n", where, problem);
    return 1;
}

static const char *plural(int count) { return count == 1 ? "" : "s"; }

/* What the answers do not support. */
static void warn(const scores *s, const ms_gpr *gp, const ms_gpr_recommend_report *report, int comparisons)
{
    const double floor_score = ms_gpr_view_of(gp).floor;
    char text[WARNINGS_TEXT];
    double nearest = 0, explained;
    const warnings_outlier outlier = warnings_judge(gp, &explained);
    int column = 0, row = scores_slip(s, &column, &nearest);
    if (row >= 0 && column < s->m)
        fprintf(stderr,
                "warning: is that a slip? %s of material %d is %.6g (line %d), the nearest of the others is %.6g.\n",
                s->name[column], row + 1, s->x[(size_t)row * (size_t)s->m + (size_t)column], s->lines[row], nearest);
    else if (row >= 0)
        fprintf(stderr, "warning: is that a slip? score %d is %.6g (line %d), the nearest of the others is %.6g.\n",
                row + 1, s->y[row], s->lines[row], nearest);
    else if (outlier.row >= 0)
        fprintf(stderr,
                "warning: is that a slip? score %d is %.6g (line %d), about %.2g was expected from the others.\n",
                outlier.row + 1, outlier.value, s->lines[outlier.row], outlier.expected);
    if (warning_of(gp, explained, text)) fprintf(stderr, "warning: %s\n", text);
    if (report->search != MS_GPR_SEARCH_VARIANTS) return;
    if (report->liked > 0)
        fprintf(stderr,
                "warning: too little is known for a threshold: these are variants of the %d material%s scored%s above "
                "%.3g.\n",
                report->liked, plural(report->liked), comparisons > 0 ? " or predicted" : "", floor_score);
    else fprintf(stderr, "warning: no score is above %.3g yet: these are random materials.\n", floor_score);
}

/* What was learned and found. */
static void summarize(const scores *s, const ms_gpr_recommend_report *report, int scored, int comparisons)
{
    double most = SCORES_NONE;
    int i;
    for (i = 0; i < s->n; ++i) most = fmax(most, s->y[i]);
    if (*s->note) fprintf(stderr, "Of the file, %s.\n", s->note);
    fprintf(stderr, "%d score%s of %d parameter%s", scored, plural(scored), s->m, plural(s->m));
    if (comparisons > 0) fprintf(stderr, " and %d comparison%s", comparisons, plural(comparisons));
    fprintf(stderr, "; the best predicted score is %.3g", report->best);
    if (scored > 0 && report->best > most) fprintf(stderr, ", above the best that was given, %.3g", most);
    fprintf(stderr, ".\n%d recommendation%s", report->found, plural(report->found));
    if (report->search != MS_GPR_SEARCH_VARIANTS)
        fprintf(stderr, " of at least %.3g by a threshold", report->threshold);
    else if (report->liked > 0) fprintf(stderr, " by variants");
    fprintf(stderr, ".\n");
    if (report->search == MS_GPR_SEARCH_VARIANTS) return;
    if (report->acceptance > 0) fprintf(stderr, "One uniform material in %.0f would do.\n", 1 / report->acceptance);
    else fprintf(stderr, "None of 4096 uniform materials would do.\n");
}

int main(int argc, char **argv)
{
    static keep kept;
    const char *in = NULL, *out = NULL, *compared = NULL, *avoided = NULL, *problem;
    enum { EXPLAINED = 300 };
    double count = 300, *x, *mean, *sigma, *avoid = NULL, *of_many = NULL;
    char why[400];
    ms_gpr_fit_options learn;
    ms_gpr_recommend_options options;
    ms_gpr_recommend_report report;
    ms_status status;
    ms_error error;
    ms_gpr *gp;
    scores s;
    FILE *f = stdout;
    int i, n, line, scored = 0, skip = 0, *pairs = NULL;
    file_out saved;
    memset(&report, 0, sizeof report);
    memset(&options, 0, sizeof options);
    memset(&learn, 0, sizeof learn);
    if (file_help(argc, argv, usage)) return file_end_stdout("recommend");
    for (i = 1; i < argc; ++i) {
        if (argv[i][0] != '-' && in == NULL) in = argv[i];
        else if (argv[i][0] != '-') return misused(argv[i], "", "one file of scores, and options that begin with --");
        else if (i + 1 == argc) return misused(argv[i], "", "a value behind it");
        else if (strcmp(argv[i], "--pairs") == 0) compared = argv[++i];
        else if (strcmp(argv[i], "--count") == 0)
            count = number(argv + i++, 1, 1e6, 1, "a whole number from 1 to 1000000");
        else if (strcmp(argv[i], "--skip") == 0)
            skip = (int)number(argv + i++, 0, 1e6, 1, "a whole number from 0 to 1000000");
        else if (strcmp(argv[i], "--tau") == 0)
            options.tau = number(argv + i++, 1e-300, 1, 0, "a number above 0, at most 1");
        else if (strcmp(argv[i], "--seed") == 0)
            options.seed = (uint64_t)number(argv + i++, 0, 9007199254740992.0, 1, "a whole number from 0 to 2^53");
        else if (strcmp(argv[i], "--out") == 0) out = argv[++i];
        else if (strcmp(argv[i], "--avoid") == 0) avoided = argv[++i];
        else if (strcmp(argv[i], "--keep") == 0 || strcmp(argv[i], "--list") == 0) ++i; /* once there are parameters */
        else return misused(argv[i], "", "one of the options below");
    }
    if (in == NULL) return file_usage(usage);
    problem = compared ? scores_read_some(in, &s) : scores_read(in, &s);
    if (problem) return failed(in, problem, s.line);
    if (compared && (learn.choices.count = read_pairs(compared, s.n, &pairs, &problem, &line)) < 0)
        return failed(compared, problem, line);
    if ((problem = keep_open(&kept, s.m, s.name)) != NULL) return failed(in, problem, 0);
    for (i = 1; i + 1 < argc; ++i) {
        if (argv[i][0] != '-') continue;
        line = 0;
        if (strcmp(argv[i], "--keep") == 0) problem = keep_wish(&kept, argv[i + 1]);
        else if (strcmp(argv[i], "--list") == 0) problem = keep_list(&kept, argv[i + 1], &line);
        if (problem) return failed(argv[i + 1], problem, line);
        ++i;
    }
    if ((problem = keep_space(&kept, &options.space)) != NULL) return failed("--keep", problem, 0);
    space_round(&kept.made, s.x, s.n);
    if (avoided && (problem = read_materials(avoided, &s, &avoid, &options.avoid_count, &line)) != NULL)
        return failed(avoided, problem, line);
    options.avoid = avoid;
    learn.choices.rows = pairs;
    for (i = 0; i < s.n; ++i) scored += s.y[i] > SCORES_NONE;
    n = (int)count + skip; /* the first of them are left out */
    x = (double *)malloc((size_t)n * (size_t)s.m * sizeof *x);
    mean = (double *)malloc((size_t)n * sizeof *mean);
    sigma = (double *)malloc((size_t)n * sizeof *sigma);
    if (!x || !mean || !sigma) return failed(in, "out of memory", 0);
    status = ms_gpr_fit(s.x, s.y, s.n, s.m, &learn, &gp, NULL, &error);
    if (status == MS_OK) status = ms_gpr_recommend(gp, &options, n, x, mean, sigma, &report, &error);
    if (status == MS_NOT_CONVERGED && gp && report.found > skip) { /* there are not so many materials */
        fprintf(stderr, "warning: %s\n", error.message);
        status = MS_OK;
    }
    report.found = report.found > skip ? report.found - skip : 0;
    if (status != MS_OK) {
        fprintf(stderr, "recommend: %s\n", error.message);
        return 1;
    }
    if (out && (f = file_create(out, &saved)) == NULL) {
        fprintf(stderr, "recommend: %s: %s\n", out, saved.problem);
        return 1;
    }
    write_csv(f, &s, x + (size_t)skip * (size_t)s.m, mean + skip, sigma + skip, report.found);
    if (out && (problem = file_finish(&saved, 1)) != NULL) {
        fprintf(stderr, "recommend: %s: %s\n", out, problem);
        return 1;
    }
    if (!out && file_end_stdout("recommend")) return 1;
    warn(&s, gp, &report, learn.choices.count);
    summarize(&s, &report, scored, learn.choices.count);
    if (report.search == MS_GPR_SEARCH_THRESHOLD &&
        (of_many = (double *)malloc(EXPLAINED * (size_t)s.m * sizeof *x)) != NULL) {
        /* of a number of its own: ranges of few are narrow by chance */
        if (ms_gpr_recommend(gp, &options, EXPLAINED, of_many, NULL, NULL, &report, NULL) == MS_OK &&
            explain(gp, of_many, EXPLAINED, &options.space, s.name, 4, why, sizeof why))
            fprintf(stderr, "%s.\n", why);
    }
    ms_gpr_destroy(gp);
    scores_free(&s);
    keep_close(&kept);
    free(x), free(mean), free(sigma), free(pairs), free(avoid), free(of_many);
    return 0;
}
