/* The one writer of the tools, examples/tools/files.h: the complete new file or the old one, whatever fails and
   whenever the process dies; and saving never stops working. */
#include "io.h"
#include "files.h"
#undef fopen
#undef fwrite
#undef fread
#undef ferror
#undef fflush
#undef fsync
#undef fclose
#undef rename
#include "test.h"
#include <signal.h>
#include <sys/wait.h>
#include <time.h>

static char folder[64];

static const char *in_folder(const char *name)
{
    static char path[4][256];
    static int next;
    next = (next + 1) % 4;
    snprintf(path[next], sizeof path[next], "%s/%s", folder, name);
    return path[next];
}

static void enter(void)
{
    snprintf(folder, sizeof folder, "build/test_saving.%ld", (long)getpid());
    mkdir("build", 0777);
    mkdir(folder, 0777);
}

static void leave(void) { CHECK_INT(rmdir(folder), 0); }

/* The files in the folder whose names begin like that. */
static int files_like(const char *begin)
{
    DIR *d = opendir(folder);
    struct dirent *e;
    int count = 0;
    while (d && (e = readdir(d)) != NULL) count += strncmp(e->d_name, begin, strlen(begin)) == 0;
    if (d) closedir(d);
    return count;
}

static int holds(const char *path, const char *text)
{
    size_t size;
    char *read = test_read_file(path, &size);
    int same = read && size == strlen(text) && memcmp(read, text, size) == 0;
    free(read);
    return same;
}

static void put(const char *path, const char *text)
{
    FILE *f = fopen(path, "wb");
    if (f) fputs(text, f), fclose(f);
}

/* Each call into the C library fails in turn, as it does on a full disk. */
static void case_errors_in_turn(void)
{
    int with_old;
    long k;
    enter();
    for (with_old = 0; with_old < 2; ++with_old) {
        for (k = 1; k < 100; ++k) {
            const char *problem;
            remove(in_folder("turn"));
            if (with_old) put(in_folder("turn"), "old");
            io_calls = 0;
            io_fail_at = k;
            problem = file_save(in_folder("turn"), "new", 3);
            io_fail_at = 0;
            if (io_calls < k) {
                CHECK(problem == NULL && holds(in_folder("turn"), "new") && files_like("turn") == 1);
                break;
            }
            if (problem == NULL) TEST_FAIL("call %ld failed without a word", k);
            CHECK_INT(files_like("turn"), with_old);
            if (with_old) CHECK(holds(in_folder("turn"), "old"));
        }
        CHECK_INT(k, 7); /* open, write, flush, sync, close, rename */
    }
    remove(in_folder("turn"));
    leave();
}

static void case_left_alone(void)
{
    static const struct {
        const char *path, *says;
    } bad[] = {{"", "a folder"}, {"to_device", "not a regular file"}, {"file/x", "folder"}};
    char long_name[2000];
    int i;
    enter();
    put(in_folder("file"), "old");
    CHECK_INT(symlink("/dev/null", in_folder("to_device")), 0);
    for (i = 0; i < 3; ++i) {
        const char *problem = file_save(in_folder(bad[i].path), "new", 3);
        if (problem == NULL || strstr(problem, bad[i].says) == NULL) TEST_FAIL("%s: %s", bad[i].path, problem);
    }
    CHECK(strstr(file_save("/proc/x/y", "new", 3), "folder") != NULL);
    CHECK(strstr(file_save("", "new", 3), "empty") != NULL);
    memset(long_name, 'a', sizeof long_name);
    long_name[1023] = 0;
    CHECK(strstr(file_save(long_name, "new", 3), "too long") != NULL);
    long_name[1023] = 'a';
    long_name[1999] = 0;
    CHECK(strstr(file_save(long_name, "new", 3), "too long") != NULL);
    CHECK(holds(in_folder("file"), "old"));
    CHECK_INT(files_like(""), 4); /* two names, "." and ".." */
    chmod(in_folder("file"), 0400);
    if (access(in_folder("file"), W_OK) != 0) { /* not as root */
        CHECK(strstr(file_save(in_folder("file"), "new", 3), "read-only") != NULL);
        chmod(folder, 0500);
        CHECK(strstr(file_save(in_folder("other"), "new", 3), "read-only") != NULL);
        chmod(folder, 0700);
    }
    remove(in_folder("file")), remove(in_folder("to_device"));
    leave();
}

/* Links stay links, also through folders; permissions stay; missing folders are made; what only looks like a temporary
   file is not touched. */
static void case_kept(void)
{
    static const char *const others[] = {"real.new00",    "real.new-12-1", "real.new-12-123", "real.new--00",
                                         "real.new-x-00", "real.new-12",   "rea.new-12-00",   "realreal.new-12-00"};
    struct stat info;
    int i;
    enter();
    CHECK(file_save(in_folder("a/b/real"), "old", 3) == NULL);
    chmod(in_folder("a/b/real"), 0600);
    for (i = 0; i < 8; ++i) {
        char name[64];
        snprintf(name, sizeof name, "a/b/%s", others[i]);
        put(in_folder(name), "a user's");
    }
    CHECK_INT(symlink("b/real", in_folder("a/link")), 0);
    CHECK_INT(symlink("a/link", in_folder("link")), 0);
    CHECK(file_save(in_folder("link"), "new", 3) == NULL);
    CHECK(lstat(in_folder("link"), &info) == 0 && S_ISLNK(info.st_mode));
    CHECK(lstat(in_folder("a/link"), &info) == 0 && S_ISLNK(info.st_mode));
    CHECK(lstat(in_folder("a/b/real"), &info) == 0 && S_ISREG(info.st_mode) && (info.st_mode & 0777) == 0600);
    CHECK(holds(in_folder("a/b/real"), "new"));
    for (i = 0; i < 8; ++i) {
        char name[64];
        snprintf(name, sizeof name, "a/b/%s", others[i]);
        CHECK(holds(in_folder(name), "a user's"));
        remove(in_folder(name));
    }
    remove(in_folder("link")), remove(in_folder("a/link")), remove(in_folder("a/b/real"));
    rmdir(in_folder("a/b")), rmdir(in_folder("a"));
    leave();
}

/* What a dead process left is removed; what a live one writes is not, this process's own included. */
static void case_stale(void)
{
    char name[64];
    file_out first, second;
    int i, status;
    pid_t child;
    enter();
    for (i = 0; i < 300; ++i) { /* more than there are numbers; also in this process's own name, as in containers */
        snprintf(name, sizeof name, "x.new-%ld-%02d", (long)getpid() + i / 100, i % 100);
        put(in_folder(name), "half");
    }
    CHECK(file_save(in_folder("x"), "new", 3) == NULL);
    CHECK(holds(in_folder("x"), "new") && files_like("x") == 1);
    CHECK(file_create(in_folder("x"), &first) != NULL);
    CHECK(file_create(in_folder("x"), &second) != NULL);
    fputs("second", second.f);
    fputs("first", first.f);
    if ((child = fork()) == 0) _exit(file_save(in_folder("x"), "child", 5) != NULL);
    CHECK(waitpid(child, &status, 0) == child && status == 0);
    CHECK(holds(in_folder("x"), "child") && files_like("x") == 3);
    CHECK(file_finish(&second, 1) == NULL && holds(in_folder("x"), "second"));
    CHECK(file_finish(&first, 0) == NULL && holds(in_folder("x"), "second") && files_like("x") == 1);
    remove(in_folder("x"));
    leave();
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static char block[2][300000];

static pid_t saver(int which)
{
    pid_t child = fork();
    const double begun = now();
    if (child == 0) {
        while (now() - begun < 60)
            if (file_save(in_folder("x"), block[which], sizeof block[which]) != NULL) _exit(1);
        _exit(0);
    }
    return child;
}

/* Processes that are killed in the middle of their saves, two at a time: whoever lives saves on. */
static void case_killed(void)
{
    const double begun = now();
    int kills = 0, refused = 0, torn = 0, most = 0;
    uint64_t seed = 1;
    pid_t child[2];
    enter();
    memset(block[0], 'a', sizeof block[0]), memset(block[1], 'b', sizeof block[1]);
    CHECK(file_save(in_folder("x"), block[0], sizeof block[0]) == NULL);
    child[0] = saver(0);
    child[1] = saver(1);
    while (now() - begun < (test_full ? 10 : 2)) {
        const int which = kills & 1;
        struct timespec pause = {0, 0};
        size_t size;
        char *read;
        int status;
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        pause.tv_nsec = (long)(seed >> 33) % 4000000;
        nanosleep(&pause, NULL);
        kill(child[which], SIGKILL);
        CHECK(waitpid(child[which], &status, 0) == child[which]);
        refused += WIFEXITED(status);
        ++kills;
        read = test_read_file(in_folder("x"), &size);
        torn += read == NULL || size != sizeof block[0] || (read[0] != 'a' && read[0] != 'b') ||
            memcmp(read, block[read[0] == 'b'], size) != 0;
        free(read);
        if (files_like("x") > most) most = files_like("x");
        child[which] = saver(which);
    }
    kill(child[0], SIGKILL), kill(child[1], SIGKILL);
    waitpid(child[0], NULL, 0), waitpid(child[1], NULL, 0);
    CHECK_INT(refused, 0);
    CHECK_INT(torn, 0);
    CHECK(most <= 12); /* one for each dead process since the last save began; the two live ones; the file itself */
    CHECK(file_save(in_folder("x"), "last", 4) == NULL);
    CHECK(holds(in_folder("x"), "last") && files_like("x") == 1);
    TEST_NOTE("%d kills, at most %d files at a time", kills, most);
    remove(in_folder("x"));
    leave();
}

static const test_case cases[] = {{"errors in turn", case_errors_in_turn},
                                  {"left alone", case_left_alone},
                                  {"kept", case_kept},
                                  {"stale", case_stale},
                                  {"killed", case_killed}};
TEST_MAIN(cases)
