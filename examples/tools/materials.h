/* Lists of materials for the examples: a CSV with one material a line, every parameter in [0, 1]
   (examples/data/README.md names the 19 of the shader).

     materials list;
     const char *problem = materials_read("materials.csv", 19, &list);   NULL: fine; otherwise a sentence in
     list.problem ... list.x[i * 19 + k], i < list.count ...
     materials_free(&list);

   Commas, or semicolons or tabs and then decimal commas as well; empty lines and lines that begin with # are skipped. A
   header line is optional; with one, further columns named score, mean or sigma (what `recommend` and the gallery files
   have) are allowed and ignored. */
#ifndef EXAMPLES_MATERIALS_H
#define EXAMPLES_MATERIALS_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files.h"

typedef struct materials {
    int count, columns;
    float *x; /* [count][columns] */
    char problem[200];
} materials;

static inline void materials_free(materials *m)
{
    free(m->x);
    memset(m, 0, sizeof *m);
}

static inline size_t materials__cell(const char *text, char between)
{
    const char *end = strchr(text, between);
    return end ? (size_t)(end - text) : strlen(text);
}

static inline int materials__columns(const char *line, char between)
{
    int count = 1;
    while (*(line += materials__cell(line, between))) ++count, ++line;
    return count;
}

/* The header's columns behind the parameters are ones that may be ignored. */
static inline int materials__header(const char *line, char between, int parameters)
{
    static const char *const known[] = {"score", "mean", "sigma"};
    int column, k;
    for (column = 0; *line; ++column) {
        size_t length = materials__cell(line, between), from = strspn(line, " \t\""), to = length;
        while (to > from && strchr(" \t\"", line[to - 1])) --to;
        for (k = 0; column >= parameters && k < 3; ++k)
            if (to - from == strlen(known[k]) && memcmp(line + from, known[k], to - from) == 0) break;
        if (k == 3) return 0;
        line += length;
        if (*line) ++line;
    }
    return column >= parameters;
}

/* One line's parameters into x; 0 and a sentence where they are none. */
static inline int materials__line(const char *text, csv_dialect d, int parameters, int columns, int line, float *x,
                                  char *problem, size_t size)
{
    int found = materials__columns(text, d.between), k;
    if (found != columns) {
        snprintf(problem, size, "line %d: %d columns, expected %d", line, found, columns);
        return 0;
    }
    for (k = 0; k < parameters; ++k) {
        char *end;
        double v = number_read(text, d.decimal, &end);
        size_t length = materials__cell(text, d.between);
        if (end == text || end + strspn(end, " ") != text + length) {
            snprintf(problem, size, "line %d: column %d is '%.*s', not a number", line, k + 1,
                     length < 24 ? (int)length : 24, text);
            return 0;
        }
        if (!(v >= 0 && v <= 1)) {
            char number[48];
            snprintf(problem, size, "line %d: column %d is %s, outside [0, 1]", line, k + 1,
                     number_text(number, "%g", v));
            return 0;
        }
        x[k] = (float)v;
        text += length + (text[length] != 0);
    }
    return 1;
}

static inline const char *materials_read(const char *path, int parameters, materials *m)
{
    enum { TEXT = 32768 };
    int line = 0, room = 0, columns = parameters, seen = 0;
    csv_dialect dialect = {',', '.'};
    char *text = (char *)malloc(TEXT);
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    memset(m, 0, sizeof *m);
    m->columns = parameters;
    if (f == NULL) snprintf(m->problem, sizeof m->problem, "%s", problem);
    else if (text == NULL) snprintf(m->problem, sizeof m->problem, "out of memory");
    while (m->problem[0] == 0 && fgets(text, TEXT, f)) {
        size_t length = strlen(text);
        const char *start = text;
        char *end;
        if (++line == 1 && (start = csv_begin(text, length, &problem)) == NULL) {
            snprintf(m->problem, sizeof m->problem, "%s", problem);
            break;
        }
        if (length == TEXT - 1) {
            snprintf(m->problem, sizeof m->problem, "line %d is too long", line);
            break;
        }
        while (length > 0 && strchr(" \t\r\n", text[length - 1])) text[--length] = 0;
        if (start[strspn(start, " \t")] == 0 || *start == '#') continue;
        dialect = csv_dialect_of(start);
        (void)number_read(start, dialect.decimal, &end);
        if (!seen++ && end == start) {
            columns = materials__columns(start, dialect.between);
            if (!materials__header(start, dialect.between, parameters))
                snprintf(m->problem, sizeof m->problem,
                         "line %d: a header of %d columns, expected %d (then score, mean or sigma)", line, columns,
                         parameters);
            continue;
        }
        if (m->count == room) {
            float *more;
            room = room < (1 << 28) / parameters ? 2 * room + 64 : 0;
            more = room ? (float *)realloc(m->x, (size_t)room * (size_t)parameters * sizeof *more) : NULL;
            if (more == NULL) {
                snprintf(m->problem, sizeof m->problem, "out of memory at line %d", line);
                break;
            }
            m->x = more;
        }
        m->count += materials__line(start, dialect, parameters, columns, line,
                                    m->x + (size_t)m->count * (size_t)parameters, m->problem, sizeof m->problem);
    }
    if (m->problem[0] == 0 && ferror(f)) snprintf(m->problem, sizeof m->problem, "the file cannot be read");
    else if (m->problem[0] == 0 && m->count == 0)
        snprintf(m->problem, sizeof m->problem, "the file holds no materials");
    if (f) fclose(f);
    free(text);
    if (m->problem[0] == 0) return NULL;
    free(m->x);
    m->x = NULL;
    m->count = 0;
    return m->problem;
}
#endif
