/* safetensors: what is accepted, what is refused and why, and that writing and reading agree. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "json.h"
#include "test.h"

/* A file of a header text and data bytes (counting up). */
static unsigned char *make_file(const char *header, size_t data, size_t *size)
{
    size_t n = strlen(header), i;
    unsigned char *b = (unsigned char *)malloc(8 + n + data + 1);
    for (i = 0; i < 8; ++i) b[i] = (unsigned char)((uint64_t)n >> (8 * i) & 0xff);
    memcpy(b + 8, header, n);
    for (i = 0; i < data; ++i) b[8 + n + i] = (unsigned char)i;
    *size = 8 + n + data;
    return b;
}

static ms_status open_text(const char *header, size_t data, const ms_nn_options *options, ms_error *error)
{
    size_t size;
    unsigned char *b = make_file(header, data, &size);
    ms_nn_file *f = NULL;
    ms_status status = ms_nn_file_open(b, size, options, &f, error);
    if (status == MS_OK) ms_nn_file_close(f);
    else CHECK(f == NULL);
    free(b);
    return status;
}

/* The strict outcome of every case of the reference data, and a place and a sentence for each refusal. */
static void test_cases(void)
{
    json *list = json_load("tests/data/nn/st_cases.json");
    int i, accepted = 0;
    for (i = 0; i < list->count; ++i) {
        const char *name = json_get(&list->child[i], "name")->text;
        int expected = strcmp(json_get(&list->child[i], "strict")->text, "accept") == 0;
        char path[300];
        size_t size = 0;
        char *bytes;
        ms_nn_file *f = NULL;
        ms_error error;
        ms_status status;
        memset(&error, 0, sizeof error);
        snprintf(path, sizeof path, "tests/data/nn/st_cases/%s.safetensors", name);
        bytes = test_read_file(path, &size);
        CHECK(bytes != NULL);
        status = ms_nn_file_open(bytes, size, NULL, &f, &error);
        if (expected != (status == MS_OK)) TEST_FAIL("%s: status %d: %s", name, (int)status, error.message);
        if (status != MS_OK) {
            CHECK_INT(status, MS_BAD_DATA);
            CHECK(strlen(error.message) > 10 && error.position <= size);
        } else {
            ++accepted;
        }
        ms_nn_file_close(f);
        free(bytes);
    }
    TEST_NOTE("%d files, %d accepted", list->count, accepted);
    json_free(list);
}

/* What is said of sizes between 2^32 and 2^64: products overflow, or 32-bit hosts cannot take the numbers. */
#if SIZE_MAX > 0xffffffffu
#define SAYS_OVERFLOW "overflows"
#else
#define SAYS_OVERFLOW "too large"
#endif

/* Headers that the reference data does not have; each with what the message must speak of, NULL: accepted. */
static void test_headers(void)
{
    static const struct {
        const char *header;
        size_t data;
        const char *says;
    } list[] = {
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[],\"data_offsets\":[0,4]}}", 4, NULL},
        {"{\"t\":{\"shape\":[2,0],\"data_offsets\":[0,0],\"dtype\":\"F64\"}}", 0, NULL},
        {"{\"a\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[1,1]},\"b\":{\"dtype\":\"I8\",\"shape\":[1],\"data_offsets\":[0,1]}}",
         1, NULL},
        {"{\"\\u00e9\\u20ac\\n\":{\"dtype\":\"BOOL\",\"shape\":[1],\"data_offsets\":[0,1]}}", 1, NULL},
        {"{\"t\":{\"dtype\":\"F4\",\"shape\":[4],\"data_offsets\":[0,2]}}  \n\t\r", 2, NULL},
        {"{\"t\":{\"dtype\":\"F6_E2M3\",\"shape\":[4],\"data_offsets\":[0,3]}}", 3, NULL},
        {"{\"__metadata__\":{}}", 0, NULL},
        {"{\"__metadata__\":{},\"__metadata__\":{}}", 0, "twice"},
        {"{\"\\u005f_metadata__\":{\"a\":\"b\"},\"__metadata__\":{}}", 0, "twice"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[18446744073709551616,0],\"data_offsets\":[0,0]}}", 0, "too large"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[9223372036854775808,2],\"data_offsets\":[0,0]}}", 0, SAYS_OVERFLOW},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[0,9223372036854775807,9],\"data_offsets\":[0,0]}}", 0, SAYS_OVERFLOW},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4],\"extra\":1}}", 4, "unknown field"},
        {"{\"t\":{\"dtype\":\"F32\",\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4]}}", 4, "twice"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0]}}", 4, "two numbers"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[+1],\"data_offsets\":[0,4]}}", 4, "plain integer"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1e0],\"data_offsets\":[0,4]}}", 4, "plain integer"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1,],\"data_offsets\":[0,4]}}", 4, "plain integer"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4]},}", 4, "string"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1 1],\"data_offsets\":[0,4]}}", 4, "expected ','"},
        {"{\"t\":null}", 0, "object"},
        {"{\"t\":{}}", 0, "lacks"},
        {"{\"a\":{\"dtype\":\"I8\",\"shape\":[2],\"data_offsets\":[0,2]},\"b\":{\"dtype\":\"I8\",\"shape\":[2],\"data_offsets\":[0,2]}}",
         2, "overlap"},
        {"{\"a\tb\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[0,0]}}", 0, "control"},
        {"{\"\\uD800\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[0,0]}}", 0, "surrogate"},
        {"{\"\\uD800\\u0041\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[0,0]}}", 0, "surrogate"},
        {"{\"\xC0\x80\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[0,0]}}", 0, "UTF-8"},
        {"{\"\xF4\x90\x80\x80\":{\"dtype\":\"I8\",\"shape\":[0],\"data_offsets\":[0,0]}}", 0, "UTF-8"},
        {"{\"t\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4]}", 4, "expected ','"},
        {"{", 0, "string"},
        {"[]", 0, "begin with"},
        {"{}x", 0, "follow"}};
    size_t i;
    for (i = 0; i < sizeof list / sizeof list[0]; ++i) {
        ms_error error;
        ms_status status;
        memset(&error, 0, sizeof error);
        status = open_text(list[i].header, list[i].data, NULL, &error);
        if (list[i].says == NULL ? status != MS_OK
                                 : (status != MS_BAD_DATA || strstr(error.message, list[i].says) == NULL))
            TEST_FAIL("%s: status %d: %s", list[i].header, (int)status, error.message);
    }
    TEST_NOTE("%d headers", (int)i);
}

static void test_limits(void)
{
    char text[600];
    ms_error error;
    ms_nn_file *f = NULL;
    unsigned char *b;
    size_t size, n, i;
    int rank;
    for (rank = 32; rank <= 33; ++rank) { /* MS_NN_MAX_RANK */
        strcpy(text, "{\"t\":{\"dtype\":\"I8\",\"shape\":[1");
        for (i = 1; i < (size_t)rank; ++i) strcat(text, ",1");
        strcat(text, "],\"data_offsets\":[0,1]}}");
        CHECK_INT(open_text(text, 1, NULL, &error), rank == 32 ? MS_OK : MS_BAD_DATA);
    }
    CHECK(strstr(error.message, "dimensions") != NULL);
    CHECK_INT(open_text("{}", 3, NULL, &error), MS_BAD_DATA);
    CHECK(strstr(error.message, "3 bytes follow") != NULL);
    CHECK_INT(error.position, 10);
    /* the largest header: 100,000,000 bytes of mostly padding; one more is refused by its length alone */
    n = MS_NN_MAX_HEADER;
    b = (unsigned char *)malloc(8 + n + 1);
    if (b == NULL) SKIP("no 100 MB of memory");
    memset(b + 8, ' ', n + 1);
    b[8] = '{';
    b[9] = '}';
    for (i = 0; i < 8; ++i) b[i] = (unsigned char)((uint64_t)n >> (8 * i) & 0xff);
    CHECK_INT(ms_nn_file_open(b, 8 + n, NULL, &f, &error), MS_OK);
    ms_nn_file_close(f);
    b[0]++;
    CHECK_INT(ms_nn_file_open(b, 8 + n + 1, NULL, &f, &error), MS_BAD_DATA);
    CHECK(strstr(error.message, "limit") != NULL);
    free(b);
    /* every size from 0 on that cuts a valid file is refused */
    b = make_file("{\"t\":{\"dtype\":\"F32\",\"shape\":[2],\"data_offsets\":[0,8]}}", 8, &size);
    for (i = 0; i < size; ++i) CHECK_INT(ms_nn_file_open(b, i, NULL, &f, NULL), MS_BAD_DATA);
    CHECK_INT(ms_nn_file_open(NULL, 8, NULL, &f, &error), MS_INVALID_ARGUMENT);
    free(b);
}

/* Many tensors in reverse order of their data: the sort is n log n, the names are found. */
static void test_many(void)
{
    int n = test_full ? 300000 : 30000, i;
    size_t room = (size_t)n * 80 + 100, length = 0, size;
    char *text = (char *)malloc(room), name[32];
    unsigned char *b;
    ms_nn_file *f = NULL;
    length += (size_t)snprintf(text, room, "{");
    for (i = 0; i < n; ++i)
        length += (size_t)snprintf(text + length, room - length,
                                   "%s\"t%d\":{\"dtype\":\"I8\",\"shape\":[1],\"data_offsets\":[%d,%d]}", i ? "," : "",
                                   i, n - 1 - i, n - i);
    snprintf(text + length, room - length, "}");
    b = make_file(text, (size_t)n, &size);
    CHECK_INT(ms_nn_file_open(b, size, NULL, &f, NULL), MS_OK);
    CHECK_INT(ms_nn_file_tensor_count(f), n);
    for (i = 0; i < n; i += 997) {
        const ms_nn_tensor *t;
        snprintf(name, sizeof name, "t%d", i);
        t = ms_nn_file_find(f, name);
        CHECK(t != NULL && t == ms_nn_file_tensor(f, (size_t)(n - 1 - i)));
    }
    CHECK(ms_nn_file_find(f, "t") == NULL && ms_nn_file_find(f, "") == NULL);
    CHECK(ms_nn_file_tensor(f, (size_t)n) == NULL);
    TEST_NOTE("%d tensors", n);
    ms_nn_file_close(f);
    free(b);
    free(text);
}

static void test_write(void)
{
    static const char *const name[4] = {"small", "big", "empty", "q\"\\\n\xF0\x9F\x98\x80"};
    static const size_t shape[4][2] = {{3, 1}, {40, 2}, {0, 5}, {1, 1}};
    unsigned char data[80 * 4];
    ms_nn_tensor t[4];
    ms_nn_entry e[2];
    unsigned char bytes[2048];
    size_t size = 0;
    ms_nn_file *f = NULL;
    ms_error error;
    size_t i;
    for (i = 0; i < sizeof data; ++i) data[i] = (unsigned char)(7 * i);
    for (i = 0; i < 4; ++i) {
        t[i].name = name[i];
        t[i].dtype = i == 0 ? MS_NN_I8 : MS_NN_F32;
        t[i].rank = i == 3 ? 0 : 2;
        t[i].shape = shape[i];
        t[i].data = data;
        t[i].bytes = shape[i][0] * shape[i][1] * (i == 0 ? 1 : 4);
    }
    e[0].key = "format";
    e[0].value = "pt";
    e[1].key = "k\x01";
    e[1].value = "[{\"a\":1}]";
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_OK);
    CHECK_LE((double)size, sizeof bytes - 1);
    memset(bytes, 0x5a, sizeof bytes);
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, bytes, size - 1, &i, &error), MS_INVALID_ARGUMENT);
    CHECK(strstr(error.message, "capacity") != NULL && bytes[0] == 0x5a);
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, bytes, size, &i, &error), MS_OK);
    CHECK(i == size && bytes[size] == 0x5a);
    CHECK_INT(ms_nn_file_open(bytes, size, NULL, &f, &error), MS_OK);
    CHECK_INT(ms_nn_file_tensor_count(f), 4);
    CHECK_INT(ms_nn_file_entry_count(f), 2);
    CHECK(strcmp(ms_nn_file_metadata(f, "k\x01"), e[1].value) == 0);
    CHECK(strcmp(ms_nn_file_entry(f, 0)->key, "format") == 0);
    CHECK_INT(((const unsigned char *)ms_nn_file_tensor(f, 0)->data - bytes) % 64, 0);
    for (i = 0; i < 4; ++i) {
        const ms_nn_tensor *r = ms_nn_file_find(f, name[i]);
        CHECK(strcmp(ms_nn_file_tensor(f, i)->name, name[i]) == 0); /* in the order given */
        CHECK(r != NULL && r->bytes == t[i].bytes && r->dtype == t[i].dtype && r->rank == t[i].rank);
        if (r) CHECK(memcmp(r->data, t[i].data, r->bytes) == 0);
    }
    ms_nn_file_close(f);
    /* without data the place stays as it is */
    t[0].data = NULL;
    memset(bytes, 0x5a, sizeof bytes);
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, bytes, sizeof bytes, &size, &error), MS_OK);
    CHECK_INT(ms_nn_file_open(bytes, size, NULL, &f, &error), MS_OK);
    CHECK(memcmp(ms_nn_file_find(f, "small")->data, "ZZZ", 3) == 0);
    ms_nn_file_close(f);
    /* what must not be written */
    t[1].name = "small";
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
    t[1].name = "__metadata__";
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
    t[1].name = "\xff";
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(error.position, 1);
    t[1].name = "big";
    t[1].bytes++;
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
    t[1].bytes--;
    e[1].key = "format";
    CHECK_INT(ms_nn_file_write(t, 4, e, 2, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
}

/* Random damage: every byte of small files replaced, cut and doubled; outcomes are free, crashes are not, and what is
   accepted must be readable. */
static void test_damage(void)
{
    static const char *const files[] = {"tests/data/nn/st_cases/ok_order.safetensors",
                                        "tests/data/nn/st_cases/ok_zero.safetensors",
                                        "tests/data/nn/act_elu.safetensors", "tests/data/nn/maxpool2d_odd.safetensors"};
    uint64_t state = test_seed;
    int rounds = test_full ? 200000 : 20000, i, accepted = 0;
    for (i = 0; i < rounds; ++i) {
        size_t size = 0, k, changes = 1 + test_random_u64(&state) % 3;
        char *b = test_read_file(files[i % 4], &size), *tight;
        ms_nn_file *f = NULL;
        ms_nn *nn = NULL;
        if (b == NULL) {
            TEST_FAIL("cannot read %s", files[i % 4]);
            return;
        }
        for (k = 0; k < changes; ++k) b[test_random_u64(&state) % size] = (char)test_random_u64(&state);
        if (i % 3 == 0) size = test_random_u64(&state) % (size + 1);
        tight = (char *)malloc(size ? size : 1); /* so that a sanitizer sees each byte beyond the end */
        memcpy(tight, b, size);
        if (ms_nn_file_open(tight, size, NULL, &f, NULL) == MS_OK) ++accepted;
        ms_nn_file_close(f);
        if (ms_nn_load(tight, size, NULL, &nn, NULL) == MS_OK) {
            float x[256], y[256];
            memset(x, 0, sizeof x);
            if (!test_unmasked() && ms_nn_input_size(nn) <= 256 &&
                ms_nn_output_size(nn) <= 256) /* its weights may be NaN */
                CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
        }
        ms_nn_destroy(nn);
        free(tight);
        free(b);
    }
    TEST_NOTE("%d damaged files, %d accepted", rounds, accepted);
}

static void test_by_name(void)
{
    ms_nn_file *f = NULL;
    ms_nn *nn = NULL;
    ms_error error;
    CHECK_INT(ms_nn_file_read("tests/data/nn/act_elu.safetensors", NULL, &f, &error), MS_OK);
    CHECK_INT(ms_nn_file_tensor_count(f), 2);
    ms_nn_file_close(f);
    CHECK_INT(ms_nn_load_file("tests/data/nn/no_such_file", NULL, &nn, &error), MS_IO);
    CHECK(strstr(error.message, "no_such_file") != NULL);
    CHECK_INT(ms_nn_load_file("tests/data", NULL, &nn, &error), MS_IO); /* a folder */
    CHECK_INT(ms_nn_load_file("tests/data/nn/st_cases/bad_empty_file.safetensors", NULL, &nn, &error), MS_BAD_DATA);
    CHECK_INT(ms_nn_load_file("tests/data/nn/st_cases/ok_basic.safetensors", NULL, &nn, &error), MS_BAD_DATA);
    CHECK(strstr(error.message, "ms_nn_layers") != NULL && nn == NULL);
    /* a file that outgrows its first block of memory: any of its allocations may fail, and the later ones hold it all */
    TEST_ALLOCATION_SWEEP(10, {
        ms_nn_options o = ms_nn_defaults();
        o.allocator = allocator;
        status = ms_nn_file_read("tests/data/nn/renderer_f16.safetensors", &o, &f, NULL);
        if (status == MS_OK) ms_nn_file_close(f);
    });
}

static const test_case cases[] = {{"reference cases", test_cases}, {"headers", test_headers}, {"limits", test_limits},
                                  {"many tensors", test_many},     {"write", test_write},     {"damage", test_damage},
                                  {"files by name", test_by_name}};
TEST_MAIN_WITH_FILES(cases)
