/* What recommendations keep, as text; ms_gpr.h, scores.h and space.h come first.

     keep k;
     const char *problem = keep_open(&k, 19, names);            NULL: fine; otherwise a sentence (static text)
     if (!problem) problem = keep_wish(&k, "x3=0.5");           fixed
     if (!problem) problem = keep_wish(&k, "x3=0.2:0.4");       a range
     if (!problem) problem = keep_wish(&k, "x3=0:1:0.25");      a range in steps
     if (!problem) problem = keep_wish(&k, "x3=x4");            equal
     if (!problem) problem = keep_list(&k, "metals.csv", &line); rows to choose from; the header line names the columns:
     x3,x4,x5
     if (!problem) problem = keep_space(&k, &options.space);    valid until the next wish
     keep_close(&k);

   Columns go by the names of the table of scores, where keep_open got them, and by x0, x1, ... else. */
#ifndef EXAMPLES_KEEP_H
#define EXAMPLES_KEEP_H

enum { KEEP_LISTS = 64 };

typedef struct keep {
    int m, equals, lists;
    double *low, *high, *steps; /* [m] each */
    int *equal;                 /* [equals][2] */
    int *columns;               /* [KEEP_LISTS][m] */
    space_list list[KEEP_LISTS];
    scores table[KEEP_LISTS];
    const char *const *names; /* [m] of the columns, or NULL */
    space_kept made;
} keep;

static inline void keep_close(keep *k)
{
    space_free(&k->made);
    while (k->lists > 0) scores_free(&k->table[--k->lists]);
    free(k->low), free(k->high), free(k->steps), free(k->equal), free(k->columns);
    memset(k, 0, sizeof *k);
}

static inline const char *keep_open(keep *k, int m, const char *const *names)
{
    size_t size = (size_t)m * sizeof(double);
    int i;
    memset(k, 0, sizeof *k);
    k->m = m;
    k->names = names;
    k->low = (double *)malloc(size);
    k->high = (double *)malloc(size);
    k->steps = (double *)calloc(1, size);
    k->columns = (int *)malloc(KEEP_LISTS * (size_t)m * sizeof(int));
    if (!k->low || !k->high || !k->steps || !k->columns) return "out of memory";
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

static inline const char *keep_wish(keep *k, const char *text)
{
    static const char *const wrong = "a wish is none of xK=V, xK=LOW:HIGH, xK=LOW:HIGH:STEP and xK=xL";
    int column = keep__column(k, &text), other, *more;
    char *end;
    text += strspn(text, " ");
    if (column < 0 || *text != '=') return wrong;
    text += 1 + strspn(text + 1, " ");
    if (*text == 'x') {
        if ((other = keep__column(k, &text)) < 0 || *text) return wrong;
        more = (int *)realloc(k->equal, 2 * ((size_t)k->equals + 1) * sizeof *more);
        if (more == NULL) return "out of memory";
        k->equal = more;
        k->equal[2 * k->equals] = column, k->equal[2 * k->equals++ + 1] = other;
        return NULL;
    }
    k->low[column] = k->high[column] = number_read(text, '.', &end);
    if (end == text) return wrong;
    if (*end == ':') k->high[column] = number_read(end + 1, '.', &end);
    if (*end == ':') k->steps[column] = number_read(end + 1, '.', &end);
    return *end ? wrong : NULL;
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

/* NULL, or what of the wishes contradicts what. */
static inline const char *keep_space(keep *k, ms_gpr_space *out)
{
    const char *problem;
    space_wish wish;
    memset(&wish, 0, sizeof wish);
    wish.low = k->low;
    wish.high = k->high;
    wish.steps = k->steps;
    wish.equal = k->equal;
    wish.equal_count = k->equals;
    wish.lists = k->list;
    wish.list_count = k->lists;
    space_free(&k->made);
    problem = space_make(&k->made, &wish, k->m);
    if (problem == NULL) *out = space_of(&k->made);
    return problem;
}
#endif
