/* What the tools share: files that are replaced only by complete ones, messages about files that cannot be read,
   numbers that are the same in every locale, --help and the end of standard output. No dependency; C99 and C++11.

     file_out out;
     FILE *f = file_create("a/b/out.csv", &out);            NULL: out.problem says why. Missing folders are made.
     ... fprintf(f, ...) ...
     const char *problem = file_finish(&out, 1);            NULL: the file stands under its name. 0 in place of 1
                                                            discards it.

   The bytes go to a temporary file in the same folder, PATH.new-PROCESS-NN, which replaces PATH in one step once it is
   complete and on the disk. Until then, and whatever fails, PATH keeps its old bytes. Links are followed, permissions
   are kept; a folder or a device is refused. A process that dies while it saves leaves its temporary file; the next
   save to the same PATH removes it. (The temporary file is locked while it is written, and the system ends the lock
   with the process. On a file system without locks nothing is removed.)

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
#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#if defined(_WIN32)
#include <direct.h>
#include <io.h>
#include <process.h>
#ifdef __cplusplus
extern "C"
#endif
    __declspec(dllimport) int __stdcall MoveFileExA(const char *from, const char *to,
                                                    unsigned long flags); /* as windows.h has it */
#define FILES__MKDIR(path) _mkdir(path)
#define FILES__FOLDER(mode) (((mode)&_S_IFMT) == _S_IFDIR)
#define FILES__REGULAR(mode) (((mode)&_S_IFMT) == _S_IFREG)
#define FILES__PROCESS ((long)_getpid())
#else
#define FILES__MKDIR(path) mkdir(path, 0777)
#define FILES__FOLDER(mode) S_ISDIR(mode)
#define FILES__REGULAR(mode) S_ISREG(mode)
#if defined(__unix__) || defined(__APPLE__)
#define FILES__POSIX 1
#define FILES__PROCESS ((long)getpid())
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#if defined(__linux__) && defined(__STRICT_ANSI__) && !defined(__cplusplus) /* -std=c99 hides the declarations only */
int fileno(FILE *stream);
int fsync(int file);
ssize_t readlink(const char *path, char *to, size_t size);
#endif
#else
#define FILES__PROCESS 0L /* WebAssembly: one process, no locks */
#endif
#endif

typedef struct file_out {
    FILE *f;
    const char *problem;
    char path[1024]; /* behind all links */
    char temporary[1024 + 48];
} file_out;

/* Why a file cannot be read. */
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

/* Removes the temporary files of path whose processes have died: those that nobody has locked. */
static inline void file__remove_stale(const char *path)
{
#if defined(FILES__POSIX) && defined(LOCK_EX)
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const size_t folder = (size_t)(name - path), length = strlen(name);
    char other[1024 + 48];
    struct dirent *entry;
    DIR *d;
    memcpy(other, path, folder);
    strcpy(other + folder, folder ? "" : ".");
    if ((d = opendir(other)) == NULL) return;
    while ((entry = readdir(d)) != NULL) {
        const char *rest = entry->d_name + length + 5; /* PROCESS-NN */
        size_t digits;
        struct stat opened, named;
        int file;
        if (strncmp(entry->d_name, name, length) != 0 || strncmp(entry->d_name + length, ".new-", 5) != 0) continue;
        digits = strspn(rest, "0123456789");
        if (digits == 0 || digits > 20 || rest[digits] != '-' || strspn(rest + digits + 1, "0123456789") != 2 ||
            rest[digits + 3] != 0)
            continue;
        strcpy(other + folder, entry->d_name);
        if ((file = open(other, O_RDWR)) < 0) continue;
        if (flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &opened) == 0 && stat(other, &named) == 0 &&
            opened.st_ino == named.st_ino && opened.st_dev == named.st_dev)
            remove(other);
        close(file);
    }
    closedir(d);
#elif defined(_WIN32) /* a file that a live process has open cannot be removed there */
    char other[1024 + 300];
    const char *a = strrchr(path, '/'), *b = strrchr(path, '\\');
    const size_t folder = a > b ? (size_t)(a + 1 - path) : b ? (size_t)(b + 1 - path) : 0;
    struct _finddata_t found;
    intptr_t list;
    snprintf(other, sizeof other, "%s.new-*-??", path);
    if ((list = _findfirst(other, &found)) == -1) return;
    do {
        snprintf(other, sizeof other, "%.*s%s", (int)folder, path, found.name);
        remove(other);
    } while (_findnext(list, &found) == 0);
    _findclose(list);
#else
    (void)path;
#endif
}

/* 0: the new file is this process's until it closes it. 1: another process, which looked for stale files between its
   creation and its lock, has removed it. */
static inline int file__lock(FILE *f)
{
#if defined(FILES__POSIX) && defined(LOCK_EX)
    struct stat info;
    if (flock(fileno(f), LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK;
    return fstat(fileno(f), &info) == 0 && info.st_nlink == 0;
#else
    (void)f;
    return 0;
#endif
}

/* fopen for a file that must not exist yet. */
static inline FILE *file__open_new(const char *path)
{
#if defined(_WIN32) && !defined(_UCRT)
    FILE *taken = fopen(path, "rb");
    if (taken == NULL) return fopen(path, "wb");
    fclose(taken);
    errno = EEXIST;
    return NULL;
#else
    return fopen(path, "wbx"); /* x: C11, in POSIX libraries long before */
#endif
}

static inline FILE *file_create(const char *path, file_out *out)
{
    struct stat info;
    size_t n = strlen(path), i;
    int number;
    out->f = NULL;
    out->problem = NULL;
    if (n == 0 || n >= sizeof out->path) return out->problem = "the file's name is empty or too long", (FILE *)NULL;
    memcpy(out->path, path, n + 1);
#if defined(FILES__POSIX)
    for (number = 0; number < 32; ++number) {
        const ssize_t length = readlink(out->path, out->temporary, sizeof out->path - 1);
        char *name = strrchr(out->path, '/'); /* a relative link starts from its own folder */
        const size_t folder = out->temporary[0] == '/' || name == NULL ? 0 : (size_t)(name + 1 - out->path);
        if (length <= 0) break;
        if (folder + (size_t)length >= sizeof out->path)
            return out->problem = "the file's name is empty or too long", (FILE *)NULL;
        memcpy(out->path + folder, out->temporary, (size_t)length);
        n = folder + (size_t)length;
        out->path[n] = 0;
    }
#endif
    if (stat(out->path, &info) != 0) info.st_mode = 0;
    else if (FILES__FOLDER(info.st_mode)) out->problem = "a folder, not a regular file: left alone";
    else if (!FILES__REGULAR(info.st_mode)) out->problem = "not a regular file: left alone";
#if defined(_WIN32)
    else if (!(info.st_mode & _S_IWRITE)) out->problem = "cannot be written: it is read-only";
#elif defined(FILES__POSIX)
    else if (access(out->path, W_OK) != 0) out->problem = "cannot be written: it is read-only";
#endif
    if (out->problem) return NULL;
    for (i = 1; i < n; ++i)
        if (out->path[i] == '/') {
            memcpy(out->temporary, out->path, i);
            out->temporary[i] = 0;
            (void)FILES__MKDIR(out->temporary);
        }
    file__remove_stale(out->path);
    for (number = 0, errno = 0; number < 100 && out->f == NULL; ++number) {
        snprintf(out->temporary, sizeof out->temporary, "%s.new-%ld-%02d", out->path, FILES__PROCESS, number);
        out->f = file__open_new(out->temporary);
        if (out->f == NULL && errno != EEXIST) break;
        if (out->f != NULL && file__lock(out->f)) {
            fclose(out->f);
            out->f = NULL;
            errno = EEXIST;
        }
    }
    if (out->f == NULL) {
        out->problem = errno == EACCES || errno == EPERM || errno == EROFS ? "its folder is read-only"
            : errno == ENOENT || errno == ENOTDIR ? "its folder is not there and cannot be made"
            : errno == ENAMETOOLONG               ? "the file's name is too long"
            : errno == ENOSPC                     ? "the disk is full"
            : errno == EEXIST ? "100 temporary files of this process stand beside it (NAME.new-PROCESS-NN): remove them"
                              : "no file can be created in its folder";
        return NULL;
    }
#if defined(FILES__POSIX)
    if (info.st_mode != 0) (void)chmod(out->temporary, info.st_mode & 0777); /* who could not read it still cannot */
#endif
    return out->f;
}

static inline const char *file_finish(file_out *out, int whole)
{
#if defined(FILES__POSIX)
    const int lock = dup(fileno(out->f)); /* keeps the lock until the file has its name */
#endif
    int written = !ferror(out->f);
    written &= fflush(out->f) == 0;
#if defined(FILES__POSIX)
    if (whole) written &= fsync(fileno(out->f)) == 0;
#elif defined(_WIN32)
    if (whole) written &= _commit(_fileno(out->f)) == 0;
#endif
    written &= fclose(out->f) == 0;
    out->f = NULL;
    if (whole && !written) out->problem = "cannot be written to its end: the disk is full or failed";
    else if (whole && rename(out->temporary, out->path) != 0) out->problem = "cannot be replaced";
#if defined(_WIN32) /* where rename() does not replace; 1: replace, 8: return when it is done */
    if (whole && written && out->problem && MoveFileExA(out->temporary, out->path, 1 | 8)) out->problem = NULL;
#endif
    if (!whole || out->problem) remove(out->temporary);
#if defined(FILES__POSIX)
    if (lock >= 0) close(lock);
#endif
    return out->problem;
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
