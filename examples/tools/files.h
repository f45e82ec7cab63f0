/* What the tools share: files that are replaced when the new one is whole, messages about files that cannot be read,
   numbers that are the same in every locale, --help and the end of standard output. No dependency; C99 and C++11.

     file_out out;
     FILE *f = file_create("a/b/out.csv", &out);            NULL: out.problem says why. Missing folders are made
     ... fprintf(f, ...) ...
     const char *problem = file_finish(&out, 1);             NULL: the file stands under its name; 0 in place of 1 drops
     it

   It is written beside the old file, which stays whatever fails; a folder or a device is refused and left alone.

     file_open("in.csv", &problem)             like fopen(path, "rb"), with a sentence where it returns NULL
     number_read(text, ',', &end)              strtod with '.' or the given character before the decimals, in every
                                               locale
     number_text(buffer, "%.5g", x)            x with '.', in every locale; returns buffer, at least 48 characters
     file_help(argc, argv, usage)              whether --help was asked for (then usage is on standard output)
     file_usage(usage)                         its first line on standard error; 2, the exit of a mistake
     csv_dialect / csv_begin                   commas, semicolons or tabs between the columns; '.' or ',' before the
                                               decimals
     file_end_stdout("tool")                   0, or 1 and a sentence: what was printed did not arrive (a full disk)

   Headers of the examples that read or write files include this one. */
#ifndef EXAMPLES_FILES_H
#define EXAMPLES_FILES_H
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#if defined(_WIN32)
#include <direct.h>
#define FILES__MKDIR(path) _mkdir(path)
#define FILES__FOLDER(mode) (((mode)&_S_IFMT) == _S_IFDIR)
#define FILES__REGULAR(mode) (((mode)&_S_IFMT) == _S_IFREG)
#else
#define FILES__MKDIR(path) mkdir(path, 0777)
#define FILES__FOLDER(mode) S_ISDIR(mode)
#define FILES__REGULAR(mode) S_ISREG(mode)
#endif

typedef struct file_out {
    FILE *f;
    const char *problem;
    char path[1024], beside[1032];
} file_out;

/* What stands in the way of reading it. */
static inline const char *file_trouble(const char *path)
{
    struct stat info;
    if (stat(path, &info) != 0) return "cannot open it: no such file";
    return FILES__FOLDER(info.st_mode) ? "cannot open it: a folder" : "cannot open it for reading";
}

static inline FILE *file_open(const char *path, const char **problem)
{
    struct stat info;
    FILE *f = stat(path, &info) == 0 && FILES__FOLDER(info.st_mode) ? NULL : fopen(path, "rb");
    if (f == NULL) *problem = file_trouble(path);
    return f;
}

static inline FILE *file_create(const char *path, file_out *out)
{
    struct stat info;
    size_t n = strlen(path), i;
    int number;
    out->f = NULL;
    out->problem = NULL;
    if (n == 0 || n >= sizeof out->path) out->problem = "the file's name is empty or too long";
    else if (stat(path, &info) == 0 && !FILES__REGULAR(info.st_mode))
        out->problem = FILES__FOLDER(info.st_mode) ? "a folder, not a regular file: left alone"
                                                   : "not a regular file: left alone";
    if (out->problem) return NULL;
    memcpy(out->path, path, n + 1);
    for (i = 1; i < n; ++i)
        if (path[i] == '/') {
            memcpy(out->beside, path, i);
            out->beside[i] = 0;
            (void)FILES__MKDIR(out->beside);
        }
    for (number = 0; number < 100 && out->f == NULL; ++number) {
        FILE *taken;
        snprintf(out->beside, sizeof out->beside, "%s.new%02d", path, number);
        if ((taken = fopen(out->beside, "rb")) != NULL) fclose(taken);
        else out->f = fopen(out->beside, "wb");
    }
    if (out->f == NULL) out->problem = "cannot open a file beside it: its folder cannot be made, is read-only or full";
    return out->f;
}

static inline const char *file_finish(file_out *out, int whole)
{
    int written = !ferror(out->f);
    written &= fflush(out->f) == 0;
    written &= fclose(out->f) == 0;
    if (whole && !written) out->problem = "cannot be written to its end: the disk is full or failed";
    if (whole && written) {
#if defined(_WIN32)
        remove(out->path); /* rename() does not replace there */
#endif
        if (rename(out->beside, out->path) == 0) return NULL;
        out->problem = "cannot be replaced";
    }
    remove(out->beside);
    return whole ? out->problem : NULL;
}

/* Bytes into a file, in the same way. */
static inline const char *file_save(const char *path, const void *data, size_t size)
{
    file_out out;
    if (file_create(path, &out) == NULL) return out.problem;
    return fwrite(data, 1, size, out.f) == size
        ? file_finish(&out, 1)
        : (file_finish(&out, 0), "cannot be written to its end: the disk is full or failed");
}

/* strtod where '.' is the point whatever the locale says, and `decimal` as well ('.': that alone). */
static inline double number_read(const char *text, char decimal, char **end)
{
    const char *point = localeconv()->decimal_point, *p = text + strspn(text, " \t");
    char copy[128];
    size_t n = 0, at = 0, length = strlen(point);
    double value;
    char *stop;
    for (; n < 100 && p[n] != 0 && strchr("+-.0123456789eEinfatyINFATYxX", p[n]) != NULL; ++n) copy[n] = p[n];
    if (n > 0 && n < 100 && decimal != '.' && p[n] == decimal && memchr(p, '.', n) == NULL) { /* 1,5 */
        copy[n++] = decimal;
        for (; n < 100 && p[n] != 0 && strchr("+-0123456789eE", p[n]) != NULL; ++n) copy[n] = p[n];
    }
    copy[n] = 0;
    for (at = 0; at < n && copy[at] != '.' && (copy[at] != decimal || decimal == '.'); ++at) {}
    if (at < n && length > 0 && length < 8) { /* the locale's point in its place */
        memmove(copy + at + length, copy + at + 1, n - at);
        memcpy(copy + at, point, length);
    } else {
        length = 1;
        at = n;
    }
    value = strtod(copy, &stop);
    if (end) {
        size_t used = (size_t)(stop - copy);
        if (used > at) used -= length - 1;
        *end = (char *)(size_t)(used ? p + used : text);
    }
    return value;
}

static inline const char *number_text(char *out, const char *format, double x)
{
    const char *point = localeconv()->decimal_point;
    char *at;
    snprintf(out, 48, format, x);
    at = strcmp(point, ".") != 0 ? strstr(out, point) : NULL;
    if (at) {
        *at = '.';
        memmove(at + 1, at + strlen(point), strlen(at + strlen(point)) + 1);
    }
    return out;
}

static inline int file_help(int argc, char **argv, const char *usage)
{
    int i;
    for (i = 1; i < argc; ++i)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            fputs(usage, stdout);
            return 1;
        }
    return 0;
}

static inline int file_usage(const char *usage)
{
    fprintf(stderr, "%.*s\n", (int)strcspn(usage, "\n"), usage);
    return 2;
}

/* What stands between the columns of a table, and before the decimals: "0,5;0,25" as spreadsheets of many countries
   write it, and "0.5,0.25". */
typedef struct csv_dialect {
    char between, decimal;
} csv_dialect;

static inline csv_dialect csv_dialect_of(const char *line)
{
    csv_dialect d;
    d.between = strchr(line, ';') ? ';' : strchr(line, '\t') ? '\t' : ',';
    d.decimal = d.between == ',' ? '.' : ',';
    return d;
}

/* The first line of a file behind a byte order mark; NULL where it is UTF-16 or no text: then a sentence. */
static inline const char *csv_begin(const char *line, size_t length, const char **problem)
{
    if (length >= 2 && (memcmp(line, "\xFF\xFE", 2) == 0 || memcmp(line, "\xFE\xFF", 2) == 0))
        return *problem = "the file is UTF-16: save it as UTF-8", (const char *)NULL;
    return length >= 3 && memcmp(line, "\xEF\xBB\xBF", 3) == 0 ? line + 3 : line;
}

static inline int file_end_stdout(const char *tool)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
    fprintf(stderr, "%s: standard output cannot be written to its end\n", tool);
    return 1;
}
#endif
