/* What recommendations keep, as text; ms_gpr.h and scores.h come first.

     keep k;
     const char *problem = keep_open(&k, 19);                   NULL: fine; otherwise a sentence (static text)
     if (!problem) problem = keep_wish(&k, "x3=0.5");           fixed
     if (!problem) problem = keep_wish(&k, "x3=0.2:0.4");       a range
     if (!problem) problem = keep_wish(&k, "x3=0:1:0.25");      a range in steps
     if (!problem) problem = keep_wish(&k, "x3=x4");            ties: sums of parameters with factors, and a number
     if (!problem) problem = keep_wish(&k, "2x3 - 0.5x4 + x5 = 1");
     if (!problem) problem = keep_list(&k, "metals.csv", &line); rows to choose from; the header line names the columns:
     x3,x4,x5
     options.space = keep_space(&k);                            valid until the next wish
     keep_close(&k);

   Whether wishes contradict each other is ms_gpr.h's to say. */
#ifndef EXAMPLES_KEEP_H
#define EXAMPLES_KEEP_H

enum { KEEP_LISTS = 64 };

typedef struct keep {
    int m, ties, lists;
    double *low, *high, *steps, *sum, *tie; /* [m] each, sum [m + 1]; [ties][m + 1] */
    int *columns;                           /* [KEEP_LISTS][m] */
    ms_gpr_list list[KEEP_LISTS];
    scores table[KEEP_LISTS];
} keep;

static inline void keep_close(keep *k)
{
    while (k->lists > 0) scores_free(&k->table[--k->lists]);
    free(k->low), free(k->high), free(k->steps), free(k->sum), free(k->tie), free(k->columns);
    memset(k, 0, sizeof *k);
}

static inline const char *keep_open(keep *k, int m)
{
    size_t size = (size_t)m * sizeof(double);
    int i;
    memset(k, 0, sizeof *k);
    k->m = m;
    k->low = (double *)malloc(size);
    k->high = (double *)malloc(size);
    k->steps = (double *)calloc(1, size);
    k->sum = (double *)malloc(size + sizeof(double));
    k->columns = (int *)malloc(KEEP_LISTS * (size_t)m * sizeof(int));
    if (!k->low || !k->high || !k->steps || !k->sum || !k->columns) return "out of memory";
    for (i = 0; i < m; ++i) k->low[i] = -HUGE_VAL, k->high[i] = HUGE_VAL;
    return NULL;
}

/* The column that a text names, x0 to x{m-1}, from *text on; -1: none. */
static inline int keep__column(const keep *k, const char **text)
{
    char *end;
    long column;
    if ((*text)[0] != 'x' || (*text)[1] < '0' || (*text)[1] > '9') return -1;
    column = strtol(*text + 1, &end, 10);
    if (column >= k->m) return -1;
    *text = end;
    return (int)column;
}

/* Adds a sum of terms, each a number, a column or a product of both, to k->sum; where it ends, or NULL. */
static inline const char *keep__terms(keep *k, const char *text, double sign)
{
    int first = 1;
    for (;;) {
        double factor = sign;
        char *end;
        int column, number;
        text += strspn(text, " ");
        if (*text == '-') factor = -factor;
        if (*text == '-' || *text == '+') text += 1 + strspn(text + 1, " ");
        else if (!first) return text;
        number = (*text >= '0' && *text <= '9') || *text == '.';
        if (number) {
            size_t digits = strspn(text, "0123456789.");
            double v = number_read(text, '.', &end);
            if (end > text + digits && (text[digits] == 'x' || text[digits] == 'X')) return NULL; /* hexadecimal */
            factor *= v;
            text = end + strspn(end, " ");
            if (*text == '*') text += 1 + strspn(text + 1, " ");
        }
        column = keep__column(k, &text);
        if (column < 0 && (!number || *text == 'x')) return NULL;
        k->sum[column < 0 ? k->m : column] += factor;
        first = 0;
    }
}

static inline const char *keep_wish(keep *k, const char *text)
{
    static const char *const wrong =
        "a wish is none of xK=V, xK=LOW:HIGH, xK=LOW:HIGH:STEP and a sum of parameters = another";
    const char *right = strchr(text, '='), *end;
    double *more;
    int i, used = 0, column = -1;
    if (right == NULL) return wrong;
    for (i = 0; i <= k->m; ++i) k->sum[i] = 0;
    end = keep__terms(k, text, 1);
    if (end != right) return "a parameter is not one of the table's, or something else stands there";
    for (i = 0; i < k->m; ++i)
        if (k->sum[i] > 0 || k->sum[i] < 0) ++used, column = i;
    if (strchr(right, ':')) {
        char *at;
        if (used != 1 || !(fabs(k->sum[column] - 1) <= 0) || k->sum[k->m] > 0 || k->sum[k->m] < 0)
            return "a range is of one parameter";
        k->low[column] = number_read(right + 1, '.', &at);
        if (*at != ':') return wrong;
        k->high[column] = number_read(at + 1, '.', &at);
        if (*at == ':') k->steps[column] = number_read(at + 1, '.', &at);
        return *at ? wrong : NULL;
    }
    end = keep__terms(k, right + 1, -1);
    if (end == NULL || *end) return wrong;
    for (i = 0, used = 0; i < k->m; ++i)
        if (k->sum[i] > 0 || k->sum[i] < 0) ++used, column = i;
    k->sum[k->m] = -k->sum[k->m];
    if (used == 1) {
        k->low[column] = k->high[column] = k->sum[k->m] / k->sum[column];
        return NULL;
    }
    more = (double *)realloc(k->tie, ((size_t)k->ties + 1) * ((size_t)k->m + 1) * sizeof *more);
    if (more == NULL) return "out of memory";
    k->tie = more;
    memcpy(k->tie + (size_t)k->ties++ * ((size_t)k->m + 1), k->sum, ((size_t)k->m + 1) * sizeof *more);
    return NULL;
}

/* line: of the file, where it has a problem */
static inline const char *keep_list(keep *k, const char *path, int *line)
{
    scores *table = &k->table[k->lists];
    int *columns = k->columns + (size_t)k->lists * (size_t)k->m, width = 0;
    const char *problem, *text;
    *line = 0;
    if (k->lists == KEEP_LISTS) return "there are too many lists";
    problem = scores_read_table(path, table);
    *line = table->line;
    ++k->lists;
    if (problem) return problem;
    *line = 1;
    if (table->header == NULL) return "the first line does not name the columns, such as x3,x4,x5";
    for (text = table->header; width < k->m;) {
        text += strspn(text, " \t\"");
        if ((columns[width++] = keep__column(k, &text)) < 0) return "a column is not one of the table of scores";
        text += strspn(text, " \t\"\r\n");
        if (*text == 0) break;
        if (*text != ',' && *text != ';') return "the first line is not a list of columns, such as x3,x4,x5";
        ++text;
    }
    if (*text || width != table->m) return "there is another number of columns than the first line names";
    k->list[k->lists - 1].columns = columns;
    k->list[k->lists - 1].width = width;
    k->list[k->lists - 1].rows = table->x;
    k->list[k->lists - 1].count = table->n;
    return NULL;
}

static inline ms_gpr_space keep_space(const keep *k)
{
    ms_gpr_space s;
    memset(&s, 0, sizeof s);
    s.low = k->low;
    s.high = k->high;
    s.steps = k->steps;
    s.ties = k->tie;
    s.tie_count = k->ties;
    s.lists = k->list;
    s.list_count = k->lists;
    return s;
}
#endif
