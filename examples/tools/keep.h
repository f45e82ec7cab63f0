/* What recommendations keep, as text; ms_gpr.h, scores.h and space.h come first.

     keep k;
     const char *problem = keep_open(&k, s.m, s.name);              NULL: fine; otherwise a sentence, valid until
                                                                    the next call
     if (!problem) problem = keep_wish(&k, "sheen=0.5");            fixed
     if (!problem) problem = keep_wish(&k, "sheen=0.2:0.4");        a range
     if (!problem) problem = keep_wish(&k, "sheen=0:1:0.25");       a range in steps
     if (!problem) problem = keep_wish(&k, "red=green");            equal
     if (!problem) problem = keep_list(&k, "metals.csv", &line);    rows to choose from; the file's header line names
                                                                    their columns, red,green,blue
     if (!problem) problem = keep_space(&k, &options.space);        valid until the next wish
     keep_close(&k);

   Columns go by the names of the table of scores: x0, x1, ... where it has no header line. */
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
    const char *const *names; /* [m] of the columns */
    space_kept made;
    char problem[240];
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

/* The column of the longest name that begins the text and is followed by `behind` (0: the end), *text behind that; -1:
   none. Spaces around a name do not count. */
static inline int keep__column(const keep *k, const char **text, char behind)
{
    const char *from = *text + strspn(*text, " ");
    size_t longest = 0;
    int i, column = -1;
    for (i = 0; i < k->m; ++i) {
        const size_t length = strlen(k->names[i]);
        const char *end = from + length;
        if (strncmp(from, k->names[i], length) != 0 || length < longest) continue;
        end += strspn(end, " ");
        if (*end != behind || (length == longest && column >= 0)) continue;
        column = i;
        longest = length;
        *text = end + (behind != 0);
    }
    return column;
}

static inline const char *keep__no_column(keep *k, const char *text, size_t length)
{
    snprintf(k->problem, sizeof k->problem, "no column is called '%.*s': they are %.40s to %.40s", (int)length, text,
             k->names[0], k->names[k->m - 1]);
    return k->problem;
}

static inline const char *keep_wish(keep *k, const char *text)
{
    static const char *const wrong = "a wish is none of NAME=V, NAME=LOW:HIGH, NAME=LOW:HIGH:STEP and NAME=NAME";
    const char *value = text;
    const int column = keep__column(k, &value, '=');
    int other, *more;
    char *end;
    if (column < 0 && strchr(text, '=') == NULL) return wrong;
    if (column < 0) return keep__no_column(k, text, strcspn(text, "="));
    if ((other = keep__column(k, &value, 0)) >= 0) {
        more = (int *)realloc(k->equal, 2 * ((size_t)k->equals + 1) * sizeof *more);
        if (more == NULL) return "out of memory";
        k->equal = more;
        k->equal[2 * k->equals] = column, k->equal[2 * k->equals++ + 1] = other;
        return NULL;
    }
    k->low[column] = k->high[column] = number_read(value, '.', &end);
    if (end == value) {
        snprintf(k->problem, sizeof k->problem, "'%.60s' is neither a number nor the name of a column", value);
        return k->problem;
    }
    if (*end == ':') k->high[column] = number_read(value = end + 1, '.', &end);
    if (*end == ':' && end > value) k->steps[column] = number_read(value = end + 1, '.', &end);
    if (*end || end == value || !(k->low[column] < HUGE_VAL && k->high[column] > -HUGE_VAL)) return wrong;
    return NULL;
}

/* line: of the file, where it has a problem */
static inline const char *keep_list(keep *k, const char *path, int *line)
{
    scores *table = &k->table[k->lists];
    int *columns = k->columns + (size_t)k->lists * (size_t)k->m, i;
    const char *problem;
    *line = 0;
    if (k->lists == KEEP_LISTS) return "there are too many lists";
    problem = scores_read_table(path, table);
    *line = table->line;
    ++k->lists;
    if (problem) return problem;
    *line = 1;
    if (!table->named) {
        snprintf(k->problem, sizeof k->problem, "the first line does not name the columns, such as %.40s", k->names[0]);
        return k->problem;
    }
    if (table->m > k->m) return "there are more columns than the scores have";
    for (i = 0; i < table->m; ++i) {
        const char *name = table->name[i];
        if ((columns[i] = keep__column(k, &name, 0)) < 0) return keep__no_column(k, name, strlen(name));
    }
    k->list[k->lists - 1].columns = columns;
    k->list[k->lists - 1].width = table->m;
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
    wish.names = k->names;
    space_free(&k->made);
    problem = space_make(&k->made, &wish, k->m);
    if (problem == NULL) *out = space_of(&k->made);
    return problem;
}
#endif
