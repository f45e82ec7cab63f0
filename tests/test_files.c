/* Files that ms_nn.h maps and reads, whatever fails; and the conversion of half floats. */
#include "io.h"
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

static float weights[2][5000];

static void prepare(void)
{
    int i;
    mkdir("build", 0777);
    mkdir(FOLDER, 0777);
    for (i = 0; i < 5000; ++i) weights[0][i] = (float)i, weights[1][i] = (float)-i;
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

/* Saving over the network that is open: what was read keeps the old weights, the file has the new ones. */
static void case_saved_over(void)
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
    ms_error error;
    long k;
    int rounds = 0, kind;
    prepare();
    put_network(FOLDER "/in.net", 0);
    for (k = 1; k < 1000; ++k, ++rounds) {
        ms_nn_file *file = NULL;
        ms_status status;
        io_calls = 0;
        io_fail_at = k;
        status = ms_nn_file_read(FOLDER "/in.net", NULL, &file, &error);
        ms_nn_file_close(file);
        io_fail_at = 0;
        io_bad_read = 0;
        if (status != (io_calls < k ? MS_OK : MS_IO)) TEST_FAIL("read %ld: %d", k, (int)status);
        if (io_calls < k) break;
    }
    TEST_NOTE("%d reads failed", rounds);
    for (kind = 0; kind < 2; ++kind) { /* a folder; nothing */
        const char *path = kind ? FOLDER "/nothing" : FOLDER;
        ms_nn_file *file = NULL;
        CHECK_INT(ms_nn_file_read(path, NULL, &file, &error), MS_IO);
        CHECK(strstr(error.message, path) != NULL);
    }
    remove(FOLDER "/in.net");
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

static const test_case cases[] = {{"saved over", case_saved_over}, {"reading", case_reading}, {"half", case_half}};
TEST_MAIN_WITH_FILES(cases)
