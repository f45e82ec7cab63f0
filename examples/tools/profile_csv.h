#ifndef PROFILE_CSV_H
#define PROFILE_CSV_H
/* A diffusion profile from the text that examples/tools/profile.c prints. */
#include "ms_sss.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static ms_status profile_csv__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = position;
    va_start(list, format);
    vsnprintf(error->message, sizeof error->message, format, list);
    va_end(list);
    return status;
}

/* Reads a number at *at, before end, without locale, '.' or `comma` before its decimals: up to 19 digits exact, the
   rest by their magnitude. 0: there is none. */
static int profile_csv__number(const char **at, const char *end, char comma, double *value)
{
    const char *p = *at;
    uint64_t mantissa = 0;
    int negative = 0, exponent = 0, digits = 0, point = 0, kept = 0;
    double x;
    if (p < end && (*p == '-' || *p == '+')) negative = *p++ == '-';
    for (; p < end && ((*p >= '0' && *p <= '9') || ((*p == '.' || *p == comma) && !point)); ++p) {
        if (*p == '.' || *p == comma) {
            point = 1;
            continue;
        }
        ++digits;
        if (kept < 19) {
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
            kept += mantissa > 0;
            exponent -= point;
        } else {
            exponent += !point;
        }
    }
    if (digits == 0) return 0;
    if (p < end && (*p == 'e' || *p == 'E')) {
        int power = 0, down = 0;
        ++p;
        if (p < end && (*p == '-' || *p == '+')) down = *p++ == '-';
        if (p >= end || *p < '0' || *p > '9') return 0;
        for (; p < end && *p >= '0' && *p <= '9'; ++p)
            if (power < 10000) power = power * 10 + (*p - '0');
        exponent += down ? -power : power;
    }
    x = (double)mantissa;
    if (mantissa != 0)
        x = exponent < -330                   ? 0
            : exponent > 330                  ? HUGE_VAL
            : exponent < -290                 ? x * pow(10, exponent + 40) * 1e-40
            : exponent < 0 && exponent >= -22 ? x / pow(10, -exponent)
                                              : x * pow(10, exponent);
    *value = negative ? -x : x;
    *at = p;
    return 1;
}

/* One line of the file: 1: four numbers in row, 0: nothing to read, -1: malformed. */
static int profile_csv__row(const char *line, const char *end, int heading_allowed, double row[4])
{
    char between = line < end && memchr(line, ';', (size_t)(end - line)) ? ';' : ',';
    int column;
    while (end > line && (end[-1] == '\r' || end[-1] == ' ' || end[-1] == '\t')) --end;
    while (line < end && (*line == ' ' || *line == '\t')) ++line;
    if (line == end || *line == '#') return 0;
    if (heading_allowed && ((*line >= 'a' && *line <= 'z') || (*line >= 'A' && *line <= 'Z'))) return 0;
    for (column = 0; column < 4; ++column) {
        while (line < end && (*line == ' ' || *line == '\t')) ++line;
        if (!profile_csv__number(&line, end, between == ';' ? ',' : '.', &row[column])) return -1;
        while (line < end && (*line == ' ' || *line == '\t')) ++line;
        if (column < 3 && (line >= end || *line++ != between)) return -1;
    }
    return line == end ? 1 : -1;
}

/* Lines "r_mm,R,G,B", comments that begin with '#', empty lines, and an optional heading that begins with a letter;
   numbers with '.' in every locale, or semicolons and decimal commas; a byte order mark is skipped, UTF-16 is
   MS_UNSUPPORTED. Where each r is the middle of a ring (edges 0, 2 r_0, 2 r_1 - 2 r_0, ... increase), the values are
   ring averages, else point samples. text need not end with NUL. MS_BAD_DATA: error->position is the line. *profile is
   NULL on failure. */
static ms_status profile_from_csv(ms_sss_profile **profile, const char *text, size_t size, ms_error *error)
{
    const char *line = text, *end = text + size;
    const double *value[3];
    double row[4], *r, *edge;
    size_t line_number = 0, rows = 0, capacity = 1, bytes, i;
    ms_status status = MS_OK;
    int kind, rings = 1;
    *profile = NULL;
    if (size >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0))
        return profile_csv__fail(error, MS_UNSUPPORTED, 1, "%s", "the text is UTF-16; UTF-8 expected");
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) line += 3; /* a byte order mark */
    for (i = 0; i < size; ++i) capacity += text[i] == '\n';
    if (capacity > 1u << 24)
        return profile_csv__fail(error, MS_UNSUPPORTED, 0, "%zu lines; at most 16777216 expected", capacity);
    bytes = (capacity * 5 + 1) * sizeof *r;
    r = (double *)malloc(bytes);
    if (r == NULL) return profile_csv__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %zu lines", capacity);
    edge = r + capacity * 4;
    while (line < end && status == MS_OK) {
        const char *stop = (const char *)memchr(line, '\n', (size_t)(end - line));
        if (stop == NULL) stop = end;
        ++line_number;
        kind = profile_csv__row(line, stop, rows == 0, row);
        if (kind < 0)
            status = profile_csv__fail(error, MS_BAD_DATA, line_number, "line %zu is not r_mm,R,G,B", line_number);
        else if (kind > 0 && (!(row[0] >= 0 && row[0] <= 1e9) || (rows > 0 && row[0] <= r[rows - 1])))
            status = profile_csv__fail(error, MS_BAD_DATA, line_number,
                                       "line %zu: r_mm is %g; increasing, 0 to 1e9 expected", line_number, row[0]);
        else if (kind > 0 &&
                 !(row[1] >= 0 && row[1] <= 1e30 && row[2] >= 0 && row[2] <= 1e30 && row[3] >= 0 && row[3] <= 1e30))
            status = profile_csv__fail(error, MS_BAD_DATA, line_number, "line %zu: a value outside 0 to 1e30",
                                       line_number);
        else if (kind > 0) {
            for (i = 0; i < 4; ++i) r[i * capacity + rows] = row[i];
            ++rows;
        }
        line = stop + (stop < end);
    }
    if (status == MS_OK && rows < 2)
        status = profile_csv__fail(error, MS_BAD_DATA, line_number, "%zu rows r_mm,R,G,B; at least 2 expected", rows);
    if (status == MS_OK) {
        for (i = 0; i < 3; ++i) value[i] = r + (i + 1) * capacity;
        edge[0] = 0;
        for (i = 0; i < rows && rings; ++i) { /* r_i = (edge_i + edge_{i+1}) / 2 */
            edge[i + 1] = 2 * r[i] - edge[i];
            rings = edge[i + 1] > r[i] && (i + 1 == rows || edge[i + 1] < r[i + 1]);
        }
        status = rings ? ms_sss_profile_from_rings(profile, (int)rows, edge, value, 1, NULL, error)
                       : ms_sss_profile_from_samples(profile, (int)rows, r, value, 1, NULL, error);
    }
    free(r);
    return status;
}
#endif
