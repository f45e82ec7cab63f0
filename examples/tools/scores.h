/* Reads scored materials for the examples: a CSV of m + 1 numbers a line, the score last; a header line is optional.

     scores s;
     const char *problem = scores_read("gallery.csv", &s);   NULL: fine; otherwise a sentence (static text)
     ... s.x[i * s.m + k], s.y[i] ...
     scores_free(&s);

   Commas, or semicolons or tabs and then decimal commas as well; lines that begin with # are skipped.
   scores_read_some("gallery.csv", &s) also takes lines with nothing behind the last separator: materials without a
   score, y = SCORES_NONE, which is MS_GPR_UNSCORED. scores_slip(&s, &column, &nearest) finds a cell that looks like a
   slip. scores_read_table("metals.csv", &s) reads numbers alone, s.x [n][m], and keeps the header line. */
#ifndef EXAMPLES_SCORES_H
#define EXAMPLES_SCORES_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files.h"

#define SCORES_NONE (-1e38)

typedef struct scores {
    int n, m, line; /* line: where reading stopped */
    double *x;      /* [n][m] */
    double *y;      /* [n]; NULL in a table */
    char *header;   /* of a table; NULL: it has none */
} scores;

static inline void scores_free(scores *s)
{
    free(s->x);
    free(s->y);
    free(s->header);
    memset(s, 0, sizeof *s);
}

/* Numbers of a line into value[limit]; how many, or -1 where something else stands there. A last one may be missing
   where `some`. */
static int scores__line(const char *text, csv_dialect d, double *value, int limit, int some)
{
    int count = 0;
    for (;;) {
        char *end;
        double v = number_read(text, d.decimal, &end);
        if (some && count > 0 && count < limit && text[strspn(text, " \t\r\n")] == 0) {
            value[count++] = SCORES_NONE;
            return count;
        }
        if (end == text || !(v - v == 0) || count == limit) return -1;
        value[count++] = v;
        end += strspn(end, d.between == '\t' ? " \r\n" : " \t\r\n");
        if (*end == 0) return count;
        if (*end != d.between) return -1;
        text = end + 1;
    }
}

/* some: 1: as scores_read_some, -1: a table */
static inline const char *scores__read(const char *path, scores *s, int some)
{
    enum { LIMIT = 1001, TEXT = 32768 };
    static char text[TEXT];
    static double value[LIMIT];
    csv_dialect dialect = {',', '.'};
    const char *problem = NULL;
    int room = 0, count, seen = 0;
    FILE *f = file_open(path, &problem);
    memset(s, 0, sizeof *s);
    if (f == NULL) return problem;
    while (problem == NULL && fgets(text, TEXT, f)) {
        if (++s->line == 1) {
            const char *start = csv_begin(text, strlen(text), &problem);
            if (start == NULL) break;
            memmove(text, start, strlen(start) + 1);
        }
        if (*text == '#' || text[strspn(text, " \t\r\n")] == 0) continue;
        ++seen;
        dialect = csv_dialect_of(text);
        if (strlen(text) == TEXT - 1) problem = "a line is too long";
        else if ((count = scores__line(text, dialect, value, LIMIT, some > 0)) < (some < 0 ? 1 : 2)) {
            char *end;
            (void)number_read(text, dialect.decimal, &end);
            if (seen > 1 || end != text)
                problem = some < 0 ? "a line is not a list of finite numbers"
                                   : "a line is not a list of at least two finite numbers";
            else if (some < 0 && (s->header = (char *)malloc(strlen(text) + 1)) != NULL) strcpy(s->header, text);
        } else if (s->n > 0 && count != s->m + (some >= 0)) {
            problem = "a line has another number of columns than the first";
        } else {
            s->m = count - (some >= 0);
            if (s->n == room) {
                double *x, *y;
                room = room ? 2 * room : 256;
                x = (double *)realloc(s->x, (size_t)room * (size_t)s->m * sizeof *x);
                if (x) s->x = x;
                y = some < 0 ? NULL : (double *)realloc(s->y, (size_t)room * sizeof *y);
                if (y) s->y = y;
                if (x == NULL || (y == NULL && some >= 0)) {
                    problem = "too large for memory";
                    continue;
                }
            }
            memcpy(s->x + (size_t)s->n * (size_t)s->m, value, (size_t)s->m * sizeof *value);
            if (some >= 0) s->y[s->n] = value[s->m];
            ++s->n;
        }
    }
    if (problem == NULL && ferror(f)) problem = "cannot be read";
    if (problem == NULL && s->n == 0) problem = "holds no rows";
    fclose(f);
    return problem;
}

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

static inline const char *scores_read(const char *path, scores *s) { return scores__read(path, s, 0); }
static inline const char *scores_read_some(const char *path, scores *s) { return scores__read(path, s, 1); }
static inline const char *scores_read_table(const char *path, scores *s) { return scores__read(path, s, -1); }
#endif
