/* Files that fail on request: before the text that is tested is included, this renames the C library's calls that it
   makes, counts those that can fail, and fails the one that is asked for. Stands before the header.
     io_fail_at = k;      the k-th from now on fails, and the later ones too with io_fail_on; 0: none
     io_calls             so many were made
   A failed fwrite writes half of its bytes; a failed fclose closes. */
#ifndef MS_TEST_IO_H
#define MS_TEST_IO_H
#include <stddef.h>
#include <stdio.h>
#include <unistd.h>

#if defined(__GNUC__)
#define IO_UNUSED __attribute__((unused)) /* not every test reads, writes and renames */
#else
#define IO_UNUSED
#endif

static long io_calls, io_fail_at;
static int io_fail_on, io_bad_read;
static FILE *io_written; /* the stream that was opened last for writing */

static int io_fails(void)
{
    ++io_calls;
    return io_fail_at && (io_calls == io_fail_at || (io_fail_on && io_calls > io_fail_at));
}

static FILE *io_fopen(const char *path, const char *mode)
{
    FILE *f = mode[0] == 'w' && io_fails() ? NULL : fopen(path, mode);
    if (mode[0] == 'w') io_written = f;
    return f;
}
static IO_UNUSED size_t io_fwrite(const void *data, size_t size, size_t count, FILE *f)
{
    return io_fails() ? fwrite(data, size, count / 2, f) : fwrite(data, size, count, f);
}
static IO_UNUSED size_t io_fread(void *data, size_t size, size_t count, FILE *f)
{
    io_bad_read = io_fails();
    return io_bad_read ? 0 : fread(data, size, count, f);
}
static int io_ferror(FILE *f) { return io_bad_read || ferror(f); }
static IO_UNUSED int io_fflush(FILE *f) { return io_fails() ? EOF : fflush(f); }
static IO_UNUSED int io_fsync(int file) { return io_fails() ? -1 : fsync(file); }
static int io_fclose(FILE *f)
{
    int written = f == io_written, bad = fclose(f);
    if (written) io_written = NULL;
    return written && io_fails() ? EOF : bad;
}
static IO_UNUSED int io_rename(const char *from, const char *to) { return io_fails() ? -1 : rename(from, to); }

#define fopen io_fopen
#define fwrite io_fwrite
#define fread io_fread
#undef ferror
#define ferror io_ferror
#define fflush io_fflush
#define fsync io_fsync
#define fclose io_fclose
#define rename io_rename
#endif
