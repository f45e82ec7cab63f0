/* What the headers leave on the disk: whole files or the old ones, whatever fails; and the shared conversion of half
   floats. */
#include "io.h"
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#undef fopen
#undef fwrite
#undef fread
#undef ferror
#undef fflush
#undef fsync
#undef fclose
#undef rename
#include "test.h"
#include <dirent.h>
#include <sys/stat.h>
#if defined(MS__X64)
#include <xmmintrin.h>
#endif

#define FOLDER "build/test_files"

/* --- one save of each kind; the same bytes whenever `which` is the same --- */

static ms_gpr *model;
static float weights[2][5000];

static void prepare(void)
{
    static const double x[4] = {0.1, 0.9, 0.5, 0.2}, y[2] = {1, 2}, theta[4] = {0, 0, 0, -2};
    ms_error error;
    int i;
    mkdir("build", 0777);
    mkdir(FOLDER, 0777);
    if (model) return;
    for (i = 0; i < 5000; ++i) weights[0][i] = (float)i, weights[1][i] = (float)-i;
    CHECK_INT(ms_gpr_create(x, y, 2, 2, theta, NULL, &model, &error), MS_OK);
}

enum { MODEL, KINDS, NETWORK = KINDS }; /* a network is only read */
static const char *const kind_name[] = {"ms_gpr_save_file", "ms_nn_file_read"};

static ms_status save(int kind, const char *path, int which, ms_error *error)
{
    (void)kind, (void)which;
    return ms_gpr_save_file(model, path, error);
}

static void put_network(const char *path, int which)
{
    static const size_t shape[1] = {5000};
    static unsigned char bytes[30000];
    ms_nn_tensor tensor = {"w", MS_NN_F32, 1, shape, NULL, sizeof weights[0]};
    size_t size = 0;
    FILE *f = fopen(path, "wb");
    tensor.data = weights[which];
    CHECK_INT(ms_nn_file_write(&tensor, 1, NULL, 0, bytes, sizeof bytes, &size, NULL), MS_OK);
    CHECK(f != NULL && fwrite(bytes, 1, size, f) == size && fclose(f) == 0);
}

/* Files in the folder whose names begin like that. */
static int files_like(const char *begin)
{
    DIR *d = opendir(FOLDER);
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

static void case_errors_in_turn(void)
{
    int kind, with_old;
    prepare();
    for (kind = 0; kind < KINDS; ++kind)
        for (with_old = 0; with_old < 2; ++with_old) {
            long k;
            for (k = 1; k < 10000; ++k) {
                ms_error error;
                ms_status status;
                memset(&error, 0, sizeof error);
                remove(FOLDER "/turn");
                if (with_old) put(FOLDER "/turn", "old");
                io_calls = 0;
                io_fail_at = k;
                status = save(kind, FOLDER "/turn", 0, &error);
                io_fail_at = 0;
                if (io_calls < k) {
                    CHECK_INT(status, MS_OK);
                    CHECK_INT(files_like("turn"), 1);
                    CHECK(!holds(FOLDER "/turn", "old"));
                    break;
                }
                if (k == 1) { /* the name beside was taken away: another one does */
                    CHECK_INT(status, MS_OK);
                    continue;
                }
                CHECK_INT(status, MS_IO);
                CHECK_INT(error.status, MS_IO);
                CHECK(strstr(error.message, "turn") != NULL);
                CHECK_INT(files_like("turn"), with_old);
                if (with_old) CHECK(holds(FOLDER "/turn", "old"));
            }
            CHECK(k >= 6); /* open, at least one write, flush, sync, close, rename */
            if (with_old) TEST_NOTE("%s: %ld calls", kind_name[kind], k - 1);
        }
    io_fail_at = 1; /* no file at all can be made */
    io_fail_on = 1;
    for (kind = 0; kind < KINDS; ++kind) {
        ms_error error;
        io_calls = 0;
        put(FOLDER "/turn", "old");
        CHECK_INT(save(kind, FOLDER "/turn", 0, &error), MS_IO);
        CHECK(holds(FOLDER "/turn", "old") && files_like("turn") == 1);
    }
    io_fail_at = io_fail_on = 0;
    remove(FOLDER "/turn");
}

/* What may not be replaced is named and stays what it was. */
static void case_left_alone(void)
{
    static const struct {
        const char *path, *says;
        ms_status status;
    } bad[] = {{FOLDER, "directory", MS_IO},
               {"/dev/null", "not a regular file", MS_IO},
               {FOLDER "/no such folder/x", "folder", MS_IO},
               {"/proc/x", "folder", MS_IO},
               {FOLDER "/to_device", "not a regular file", MS_IO},
               {"", "path", MS_INVALID_ARGUMENT},
               {NULL, "path", MS_INVALID_ARGUMENT}};
    struct stat before, after;
    int kind, i;
    prepare();
    remove(FOLDER "/to_device");
    CHECK_INT(symlink("/dev/null", FOLDER "/to_device"), 0);
    for (kind = 0; kind < KINDS; ++kind)
        for (i = 0; i < (int)(sizeof bad / sizeof bad[0]); ++i) {
            ms_error error;
            int there = bad[i].path && stat(bad[i].path, &before) == 0;
            memset(&error, 0, sizeof error);
            CHECK_INT(save(kind, bad[i].path, 0, &error), bad[i].status);
            if (strstr(error.message, bad[i].says) == NULL)
                TEST_FAIL("%s, %s: '%s'", kind_name[kind], bad[i].path ? bad[i].path : "NULL", error.message);
            CHECK_INT(bad[i].path && stat(bad[i].path, &after) == 0, there);
            if (there) CHECK(before.st_mode == after.st_mode && before.st_ino == after.st_ino);
        }
    { /* longer than any path */
        char *path = (char *)malloc(10001);
        ms_error error;
        memset(path, 'a', 10000);
        path[10000] = 0;
        for (kind = 0; kind < KINDS; ++kind) CHECK_INT(save(kind, path, 0, &error), MS_INVALID_ARGUMENT);
        free(path);
    }
    remove(FOLDER "/to_device");
}

/* Links stay links, also through folders; permissions stay; what stands beside under the first names is not touched. */
static void case_kept(void)
{
    struct stat info;
    ms_error error;
    int kind;
    prepare();
    mkdir(FOLDER "/there", 0777);
    for (kind = 0; kind < KINDS; ++kind) {
        put(FOLDER "/there/real", "old");
        chmod(FOLDER "/there/real", 0600);
        put(FOLDER "/there/real.new00", "someone's");
        remove(FOLDER "/link");
        remove(FOLDER "/link2");
        CHECK_INT(symlink("there/real", FOLDER "/link"), 0);
        CHECK_INT(symlink("link", FOLDER "/link2"), 0);
        CHECK_INT(save(kind, FOLDER "/link2", 0, &error), MS_OK);
        CHECK(lstat(FOLDER "/link2", &info) == 0 && S_ISLNK(info.st_mode));
        CHECK(lstat(FOLDER "/link", &info) == 0 && S_ISLNK(info.st_mode));
        CHECK(lstat(FOLDER "/there/real", &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 100);
        CHECK_INT(info.st_mode & 0777, 0600);
        CHECK(holds(FOLDER "/there/real.new00", "someone's"));
    }
    remove(FOLDER "/there/real"), remove(FOLDER "/there/real.new00");
    remove(FOLDER "/link"), remove(FOLDER "/link2");
}

/* Saving over the network that is mapped: the mapping keeps the old weights, the file has the new ones. */
static void case_mapped(void)
{
    ms_nn_file *old = NULL, *fresh = NULL;
    ms_error error;
    prepare();
    put_network(FOLDER "/net", 0);
    CHECK_INT(ms_nn_file_read(FOLDER "/net", NULL, &old, &error), MS_OK);
    put_network(FOLDER "/net2", 1);
    CHECK_INT(rename(FOLDER "/net2", FOLDER "/net"), 0);
    CHECK_INT(ms_nn_file_read(FOLDER "/net", NULL, &fresh, &error), MS_OK);
    if (old && fresh) {
        CHECK(memcmp(ms_nn_file_tensor(old, 0)->data, weights[0], sizeof weights[0]) == 0);
        CHECK(memcmp(ms_nn_file_tensor(fresh, 0)->data, weights[1], sizeof weights[1]) == 0);
    }
    ms_nn_file_close(old);
    ms_nn_file_close(fresh);
    CHECK_INT(files_like("net"), 1);
    remove(FOLDER "/net");
}

/* Reading: each read in turn fails, and a folder is no file. */
static void case_reading(void)
{
    ms_nn_options copied = ms_nn_defaults();
    ms_error error;
    long k;
    int kind, rounds = 0;
    prepare();
    copied.copy = 1;
    put_network(FOLDER "/in.net", 0);
    CHECK_INT(save(MODEL, FOLDER "/in.gp", 0, &error), MS_OK);
    for (kind = 0; kind <= NETWORK; ++kind)
        for (k = 1; k < 1000; ++k, ++rounds) {
            ms_status status;
            io_calls = 0;
            io_fail_at = k;
            if (kind == NETWORK) {
                ms_nn_file *file = NULL;
                status = ms_nn_file_read(FOLDER "/in.net", &copied, &file, &error);
                ms_nn_file_close(file);
            } else {
                ms_gpr *gp = NULL;
                status = ms_gpr_load_file(FOLDER "/in.gp", NULL, &gp, &error);
                ms_gpr_destroy(gp);
            }
            io_fail_at = 0;
            io_bad_read = 0;
            if (status != (io_calls < k ? MS_OK : MS_IO))
                TEST_FAIL("%s, read %ld: %d", kind_name[kind], k, (int)status);
            if (io_calls < k) break;
        }
    TEST_NOTE("%d reads failed", rounds);
    for (kind = 0; kind < 2; ++kind) { /* a folder; nothing */
        const char *path = kind ? FOLDER "/nothing" : FOLDER;
        ms_nn_file *file = NULL;
        ms_gpr *gp = NULL;
        CHECK_INT(ms_nn_file_read(path, NULL, &file, &error), MS_IO);
        CHECK(strstr(error.message, path) != NULL);
        CHECK_INT(ms_gpr_load_file(path, NULL, &gp, &error), MS_IO);
        CHECK(strstr(error.message, path) != NULL);
    }
    remove(FOLDER "/in.net"), remove(FOLDER "/in.gp");
}

/* Every half against its value; floats around every half and every midpoint against the nearest one, found by search.
   Once as the host is, once with subnormals flushed to zero. */
static void case_half(void)
{
    int flush;
    for (flush = 0; flush < 2; ++flush) {
        long wrong = 0;
        unsigned h;
#if defined(MS__X64)
        const unsigned state = _mm_getcsr();
        if (flush) _mm_setcsr(state | 0x8040);
#else
        if (flush) break;
#endif
        for (h = 0; h < 0x7c00; ++h) {
            const double exact = ldexp((h >> 10 ? 1024.0 : 0.0) + (h & 1023), (int)(h >> 10 ? h >> 10 : 1) - 25);
            const unsigned up = h + 1;
            const double next = h == 0x7bff
                ? 65536
                : ldexp((up >> 10 ? 1024.0 : 0.0) + (up & 1023), (int)(up >> 10 ? up >> 10 : 1) - 25);
            const float value = ms__half_to_float((uint16_t)h),
                        middle = (float)(0.5 * (exact + next)); /* exact: 12 bits */
            uint32_t bits;
            float below, above;
            memcpy(&bits, &middle, 4);
            bits -= 1;
            memcpy(&below, &bits, 4);
            bits += 2;
            memcpy(&above, &bits, 4);
            wrong += (double)value != exact || (double)ms__half_to_float((uint16_t)(h | 0x8000)) != -exact;
            wrong += ms__half_from_float(value) != h || ms__half_from_float(-value) != (h | 0x8000);
            wrong += ms__half_from_float(below) != h || ms__half_from_float(middle) != (h == 0x7bff ? h : h + (h & 1));
            wrong += ms__half_from_float(above) != (h == 0x7bff ? h : h + 1); /* finite stays finite */
        }
        for (h = 0x7c00; h < 0x8000; ++h) {
            const float value = ms__half_to_float((uint16_t)h);
            uint32_t bits;
            memcpy(&bits, &value, 4);
            wrong += h == 0x7c00 ? bits != 0x7f800000u : !(bits > 0x7f800000u && bits < 0x80000000u);
            wrong += h == 0x7c00 ? ms__half_from_float(value) != h : (ms__half_from_float(value) & 0x7e00) != 0x7e00;
        }
#if defined(MS__X64)
        _mm_setcsr(state);
#endif
        CHECK_INT(wrong, 0);
        CHECK_INT(ms__half_from_float(1e30f), 0x7bff);
        CHECK_INT(ms__half_from_float(-1e-30f), 0x8000);
    }
}

static const test_case cases[] = {{"errors in turn", case_errors_in_turn},
                                  {"left alone", case_left_alone},
                                  {"kept", case_kept},
                                  {"mapped", case_mapped},
                                  {"reading", case_reading},
                                  {"half", case_half}};
TEST_MAIN_WITH_FILES(cases)
