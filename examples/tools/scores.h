/* Reads scored materials for the examples: a CSV with a material a line, its parameters and its score.

     scores s;
     const char *problem = scores_read("gallery.csv", &s);   NULL: fine; otherwise a sentence, valid until scores_free,
                                                             about line s.line
     ... s.x[i * s.m + k], s.y[i], s.name[k] ...
     scores_free(&s);

   A header line is optional. The score is the column that it calls score, rating, stars, label, preference or liking,
   else the last one. Row numbers in the first column and columns of text are left out, lines without a score (or with
   NaN or NA for it) are skipped; s.note says so. Commas, semicolons or tabs, or what a first line "sep=;" says; with
   semicolons and tabs decimal commas as well. Cells may be in quotes. Lines that begin with # are skipped.
   scores_read_some("gallery.csv", &s) keeps materials without a score, y = SCORES_NONE, which is MS_GPR_UNSCORED.
   scores_slip(&s, &column, &nearest) finds a cell that looks like a slip. scores_read_table("metals.csv", &s) reads
   parameters alone, s.x [n][m]. */
#ifndef EXAMPLES_SCORES_H
#define EXAMPLES_SCORES_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files.h"

#define SCORES_NONE (-1e38)

enum { SCORES_COLUMNS = 1001 }; /* at most */

typedef struct scores {
    int n, m;
    double *x;         /* [n][m] */
    double *y;         /* [n]; NULL in a table */
    int *lines;        /* [n] where each material stands in the file */
    const char **name; /* [m] of the parameters: x0, x1, ... where the file has no header */
    int named;         /* whether it has one */
    int missing;       /* lines that were skipped because they have no score */
    int line;          /* what the problem is about; 0: the whole file */
    char note[240];    /* what was left out, sentences; empty: nothing */
    char problem[240];
    char *text; /* the file, whose cells end with NUL */
    char *made; /* the room for names behind it */
} scores;

static inline void scores_free(scores *s)
{
    free(s->x), free(s->y), free(s->lines);
    free((void *)(size_t)s->name);
    free(s->text);
    memset(s, 0, sizeof *s);
}

/* ----------------------------------------------------------------------------------------------- from text to cells */

typedef struct scores__cells {
    char **cell; /* [rows][columns], the header first */
    int *line;   /* [rows] */
    int rows, columns, room;
    char between, decimal;
} scores__cells;

static inline const char *scores__fail(scores *s, int line, const char *problem)
{
    s->line = line;
    snprintf(s->problem, sizeof s->problem, "%s", problem);
    return s->problem;
}

/* The whole file with line ends \n, and `extra` bytes behind it. */
static inline const char *scores__load(scores *s, const char *path, size_t extra)
{
    size_t size = 0, room = 0, i, kept = 0;
    const char *problem = NULL, *start;
    FILE *f = file_open(path, &problem);
    int broken;
    if (f == NULL) return scores__fail(s, 0, problem);
    do {
        char *more = size < room ? s->text : (char *)realloc(s->text, (room = 2 * room + 65536) + extra + 1);
        if (more == NULL) break;
        s->text = more;
        size += fread(s->text + size, 1, room - size, f);
    } while (size == room);
    broken = ferror(f);
    fclose(f);
    if (broken) return scores__fail(s, 0, "cannot be read");
    if (s->text == NULL || size == room) return scores__fail(s, 0, "too large for memory");
    if ((start = csv_begin(s->text, size, &problem)) == NULL) return scores__fail(s, 1, problem);
    if (memchr(s->text, 0, size)) return scores__fail(s, 0, "the file is no text: it holds a byte of zero");
    for (i = (size_t)(start - s->text); i < size; ++i)
        if (s->text[i] != '\r') s->text[kept++] = s->text[i];
        else if (i + 1 == size || s->text[i + 1] != '\n') s->text[kept++] = '\n';
    s->text[kept] = 0;
    s->made = s->text + kept + 1;
    return NULL;
}

/* Cuts the cell at *at out of the text, without its quotes; *at then is behind it. What ended it: the separator, a line
   end, 0; '"' where a quote is not closed. */
static inline char scores__cut(char **at, char between, char **cell, int *line)
{
    char *read = *at + strspn(*at, between == '\t' ? " " : " \t"), *from = read, *to = read, end;
    int quoted = 0;
    for (; *read && (quoted || (*read != between && *read != '\n')); ++read) {
        *line += *read == '\n';
        if (*read == '"' && quoted && read[1] == '"') *to++ = *read++; /* "" stands for one */
        else if (*read == '"' && (quoted || to == from)) quoted = !quoted;
        else *to++ = *read;
    }
    while (to > from && (to[-1] == ' ' || to[-1] == '\t')) --to;
    end = quoted ? '"' : *read;
    *at = read + (*read != 0);
    *to = 0;
    *cell = from;
    return end;
}

/* 1: a finite number, 0: text or nothing, -1: infinity, NaN */
static inline int scores__number(const char *cell, char decimal, double *value)
{
    char *end;
    *value = number_read(cell, decimal, &end);
    return end == cell || *end ? 0 : *value - *value == 0 ? 1 : -1;
}

/* Whether a first line names the columns: it holds no numbers, or the numbers 0, 1, 2 ... of pandas. */
static inline int scores__is_header(char *const *cell, int columns, char decimal)
{
    int texts = 0, numbers = 0, k;
    double v;
    for (k = 0; k < columns; ++k)
        if (scores__number(cell[k], decimal, &v) == 0) texts += *cell[k] != 0;
        else if (!(v >= numbers && v <= numbers)) return 0;
        else ++numbers;
    return numbers ? numbers > 2 : texts > 0;
}

static inline const char *scores__split(scores *s, scores__cells *c)
{
    char *at = s->text, *row[SCORES_COLUMNS + 1];
    int line = 1, count, filled, i;
    c->between = 0;
    if ((memcmp(at, "sep=", 4) == 0 || memcmp(at, "Sep=", 4) == 0) && at[4] && at[4] != '\n') {
        c->between = at[4];
        at += strcspn(at, "\n");
        at += *at == '\n';
        ++line;
    }
    while (*at) {
        const int first = line;
        char end, *p;
        if (*at == '#' || *at == '\n') {
            at += strcspn(at, "\n");
            at += *at == '\n';
            ++line;
            continue;
        }
        if (c->between == 0) { /* as the first line has it, outside of quotes */
            int quoted = 0;
            c->between = ',';
            for (p = at; *p && (quoted || *p != '\n'); ++p) {
                quoted ^= *p == '"';
                if (!quoted && (*p == ';' || (*p == '\t' && c->between == ','))) c->between = *p;
            }
        }
        c->decimal = c->between == ',' ? '.' : ',';
        for (count = filled = 0, end = c->between; end == c->between; ++count) {
            char **cell = &row[count < SCORES_COLUMNS ? count : SCORES_COLUMNS];
            end = scores__cut(&at, c->between, cell, &line);
            if (**cell) filled = count + 1;
        }
        if (end == '"') return scores__fail(s, first, "a quote is not closed");
        line += end == '\n';
        if (filled > SCORES_COLUMNS) return scores__fail(s, first, "there are more than 1001 columns");
        if (filled == 0) continue;
        if (c->rows == 0) {
            s->named = scores__is_header(row, filled, c->decimal);
            c->columns = s->named ? filled : count; /* separators at the end of a header name nothing */
        }
        if (filled > c->columns || count < c->columns) {
            snprintf(s->problem, sizeof s->problem, "the line has %d columns, the first one has %d", count, c->columns);
            s->line = first;
            return s->problem;
        }
        if (c->rows == c->room) {
            const int room = c->room ? 2 * c->room : 256;
            char **cells = (char **)realloc(c->cell, (size_t)room * (size_t)c->columns * sizeof *cells);
            int *lines = (int *)realloc(c->line, (size_t)room * sizeof *lines);
            if (cells) c->cell = cells;
            if (lines) c->line = lines;
            if (!cells || !lines) return scores__fail(s, 0, "too large for memory");
            c->room = room;
        }
        for (i = 0; i < c->columns; ++i) c->cell[(size_t)c->rows * (size_t)c->columns + (size_t)i] = row[i];
        c->line[c->rows++] = first;
    }
    return c->rows > s->named ? NULL : scores__fail(s, 0, "holds no rows");
}

/* --------------------------------------------------------------------------------------------- what the columns are */

static inline int scores__is(const char *name, const char *const *known, int count)
{
    int i, k;
    for (k = 0; k < count; ++k) {
        for (i = 0; name[i] && (name[i] | 32) == known[k][i]; ++i) {}
        if (name[i] == 0 && known[k][i] == 0) return 1;
    }
    return 0;
}

/* Whether a first column only numbers the rows. named: what the header calls it, NULL without one. */
static inline int scores__is_row_number(const scores__cells *c, const char *named)
{
    static const char *const known[] = {"id", "index", "row", "number", "nr", "no"};
    const int first = named != NULL;
    double v, begin = 0, before = 0;
    int i;
    if (named && (*named == 0 || strcmp(named, "Unnamed: 0") == 0)) return 1;
    if (named ? !scores__is(named, known, 6) : c->rows < 3) return 0;
    for (i = first; i < c->rows; ++i, before = v) {
        if (scores__number(c->cell[(size_t)i * (size_t)c->columns], c->decimal, &v) != 1 || v > floor(v)) return 0;
        if (i == first) begin = v;
        else if (named ? v <= before : !(v - before >= 1 && v - before <= 1)) return 0;
    }
    return named != NULL || begin * (begin - 1) == 0;
}

static inline int scores__is_text(const scores__cells *c, int column, int first)
{
    double v;
    int i;
    for (i = first; i < c->rows; ++i)
        if (scores__number(c->cell[(size_t)i * (size_t)c->columns + (size_t)column], c->decimal, &v) != 0) return 0;
    return 1;
}

static inline void scores__note(scores *s, const char *what, const char *name)
{
    const size_t used = strlen(s->note);
    snprintf(s->note + used, sizeof s->note - used, "%sthe %s%s%.40s%s left out", used ? ", " : "", what,
             *name ? " '" : "", name, *name ? "' are" : " are");
}

/* The columns of parameters into column [m] and their names; the score's, or -1 in a table, is returned. */
static inline int scores__columns(scores *s, const scores__cells *c, int table, int *column)
{
    static const char *const known[] = {"score", "rating", "stars", "label", "preference", "liking"};
    char *made = s->made;
    int score = -1, which, k;
    for (which = 0; which < 6 && !table && s->named && score < 0; ++which)
        for (k = 0; k < c->columns && score < 0; ++k)
            if (scores__is(c->cell[k], known + which, 1)) score = k;
    if (score < 0 && !table) score = c->columns - 1;
    for (k = 0; k < c->columns; ++k) {
        const char *name = s->named ? c->cell[k] : "";
        double v;
        if (k == score) continue;
        if (scores__is_text(c, k, s->named)) {
            scores__note(s, "texts of a column", name);
            continue;
        }
        if (k == 0 && (s->named || (!table && c->columns > 2)) && scores__is_row_number(c, s->named ? name : NULL)) {
            scores__note(s, "row numbers in the first column", name);
            continue;
        }
        if (*name == 0 || scores__number(name, '.', &v) == 1) {
            const int number = *name && v >= 0 && v < (int)SCORES_COLUMNS ? (int)v : s->m; /* pandas' 3 is x3 */
            name = made;
            made += snprintf(made, 8, "x%d", number) + 1;
        }
        s->name[s->m] = name;
        column[s->m++] = k;
    }
    return score;
}

/* ---------------------------------------------------------------------------------------------------------- reading */

static inline const char *scores__bad(scores *s, const scores__cells *c, int row, int column, const char *name)
{
    const char *cell = c->cell[(size_t)row * (size_t)c->columns + (size_t)column];
    s->line = c->line[row];
    if (*cell == 0)
        snprintf(s->problem, sizeof s->problem, "column %d (%.40s) is empty, a number was expected", column + 1, name);
    else
        snprintf(s->problem, sizeof s->problem, "column %d (%.40s) is '%.40s', a finite number was expected",
                 column + 1, name, cell);
    return s->problem;
}

/* The numbers of the cells. some: 1: as scores_read_some, -1: a table */
static inline const char *scores__numbers(scores *s, const scores__cells *c, int some)
{
    static const char *const none[] = {"nan", "na"};
    const size_t rows = (size_t)c->rows, columns = (size_t)c->columns;
    int *column = (int *)malloc(columns * sizeof *column);
    const char *problem = NULL;
    int score, i, k;
    s->x = (double *)malloc(rows * columns * sizeof *s->x);
    s->y = some < 0 ? NULL : (double *)malloc(rows * sizeof *s->y);
    s->lines = (int *)malloc(rows * sizeof *s->lines);
    s->name = (const char **)malloc(columns * sizeof *s->name);
    if (!column || !s->x || (!s->y && some >= 0) || !s->lines || !s->name) {
        free(column);
        return scores__fail(s, 0, "too large for memory");
    }
    score = scores__columns(s, c, some < 0, column);
    if (s->m == 0) problem = scores__fail(s, c->line[s->named], "a line is not a list of parameters and a score");
    if (s->m == 0 && some < 0) problem = scores__fail(s, c->line[s->named], "a line is not a list of numbers");
    for (i = s->named; i < c->rows && problem == NULL; ++i) {
        char *const *cell = c->cell + (size_t)i * columns;
        double *x = s->x + (size_t)s->n * (size_t)s->m;
        for (k = 0; k < s->m && problem == NULL; ++k)
            if (scores__number(cell[column[k]], c->decimal, &x[k]) != 1)
                problem = scores__bad(s, c, i, column[k], s->name[k]);
        if (score >= 0 && (cell[score][0] == 0 || scores__is(cell[score], none, 2))) {
            if (some == 0) {
                ++s->missing;
                continue;
            }
            s->y[s->n] = SCORES_NONE;
        } else if (score >= 0 && problem == NULL && scores__number(cell[score], c->decimal, &s->y[s->n]) != 1)
            problem = scores__bad(s, c, i, score, s->named ? c->cell[score] : "the score");
        s->lines[s->n++] = c->line[i];
    }
    free(column);
    if (problem == NULL && s->n == 0)
        problem = scores__fail(s, c->line[s->named], "no line has a score: the last column is empty in all");
    if (problem == NULL && s->missing > 0) {
        const size_t used = strlen(s->note);
        snprintf(s->note + used, sizeof s->note - used, "%s%d line%s without a score skipped", used ? ", " : "",
                 s->missing, s->missing > 1 ? "s" : "");
    }
    return problem;
}

static inline const char *scores__read(const char *path, scores *s, int some)
{
    const char *problem;
    scores__cells c;
    memset(s, 0, sizeof *s);
    memset(&c, 0, sizeof c);
    problem = scores__load(s, path, 8 * SCORES_COLUMNS);
    if (problem == NULL) problem = scores__split(s, &c);
    if (problem == NULL) problem = scores__numbers(s, &c, some);
    free(c.cell);
    free(c.line);
    return problem;
}

static inline const char *scores_read(const char *path, scores *s) { return scores__read(path, s, 0); }
static inline const char *scores_read_some(const char *path, scores *s) { return scores__read(path, s, 1); }
static inline const char *scores_read_table(const char *path, scores *s) { return scores__read(path, s, -1); }

/* ------------------------------------------------------------------------------------------------------------ slips */

static inline int scores__ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* A cell that lies more than three ranges of the others outside of them, or one of up to three such cells of a column:
   its row, and its column in *column (m: the score); -1: none. value: of the nearest of the others. */
static inline int scores_slip(const scores *s, int *column, double *value)
{
    enum { FEWEST = 8, GROUP = 3 };
    double *sorted = (double *)malloc((size_t)s->n * sizeof *sorted);
    int i, k, group, count, found = -1;
    for (k = 0; k <= s->m && sorted && found < 0; ++k) {
        for (i = 0, count = 0; i < s->n; ++i) {
            const double v = k < s->m ? s->x[(size_t)i * (size_t)s->m + (size_t)k] : s->y[i];
            if (k < s->m || v > SCORES_NONE) sorted[count++] = v;
        }
        qsort(sorted, (size_t)count, sizeof *sorted, scores__ascending);
        for (group = 1; group <= GROUP && count >= FEWEST && found < 0; ++group) {
            const double high = sorted[count - 1 - group], low = sorted[group];
            const int above = sorted[count - group] - high > 3 * (high - sorted[0]) && high > sorted[0];
            const int below = low - sorted[group - 1] > 3 * (sorted[count - 1] - low) && sorted[count - 1] > low;
            if (!above && !below) continue;
            *column = k;
            *value = above ? high : low;
            for (i = 0; i < s->n && found < 0; ++i) {
                const double v = k < s->m ? s->x[(size_t)i * (size_t)s->m + (size_t)k] : s->y[i];
                if (v > SCORES_NONE && (above ? v > high : v < low)) found = i;
            }
        }
    }
    free(sorted);
    return found;
}
#endif
