/* Writes a network with narrower weights, and what that costs: PSNR of its outputs against the file's own, over given
     or random inputs. cc -O2 -I. examples/tools/nn_quantise.c -o build/nn_quantise -lm
     build/nn_quantise IN OUT --type f16|bf16|i8|f32 [--rank N] [--inputs X.csv] [--samples 64]
   --type     of the weights of dense and convolution layers, rounded to nearest; i8: one scale a row. Biases stay as
              they are.
   --rank     first replaces a linear last layer by two of that rank, the best over the inputs; below the number of its
              features
   --inputs   rows of numbers, one an input; else --samples of them are drawn, each number even in [0, 1] */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "files.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: nn_quantise IN OUT --type f16|bf16|i8|f32 [--rank N] [--inputs X.csv] [--samples 64]\n";

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "nn_quantise: %s: %s\n", what, why);
    return 1;
}

static void *take(size_t count, size_t size)
{
    void *p = size != 0 && count > (size_t)-1 / size ? NULL : calloc(count ? count : 1, size);
    if (p == NULL) exit(fail("memory", "there is not enough"));
    return p;
}

static uint32_t bits_of(float x)
{
    uint32_t u;
    memcpy(&u, &x, 4);
    return u;
}

/* To nearest, ties to even; what is too large for F16 becomes its largest. */
static uint16_t half_of(float x)
{
    uint32_t u = bits_of(x), sign = u >> 16 & 0x8000u, a = u & 0x7fffffffu, q;
    if (a > 0x7f800000u) return 0x7e00;
    if (a < 0x38800000u) q = (uint32_t)lrint(ldexp(fabs((double)x), 24)); /* below 2^-14 steps of 2^-24 */
    else q = a >= 0x477ff000u ? 0x7bffu : (a - 0x38000000u + 0xfffu + (a >> 13 & 1u)) >> 13;
    return (uint16_t)(sign | q);
}

static uint16_t brain_of(float x)
{
    uint32_t u = bits_of(x);
    return (uint16_t)((u & 0x7fffffffu) > 0x7f800000u ? 0x7fc0u : (u + 0x7fffu + (u >> 16 & 1u)) >> 16);
}

/* Element i of a tensor of weights, which lie with the least byte first. */
static double element(const ms_nn_tensor *t, size_t i)
{
    int bytes = t->dtype == MS_NN_F64 ? 8 : t->dtype == MS_NN_F32 ? 4 : t->dtype == MS_NN_I8 ? 1 : 2, k;
    const unsigned char *p = (const unsigned char *)t->data + i * (size_t)bytes;
    uint64_t u = 0;
    uint32_t low;
    double x;
    float f;
    for (k = 0; k < bytes; ++k) u |= (uint64_t)p[k] << (8 * k);
    if (t->dtype == MS_NN_I8) return u < 128 ? (double)u : (double)u - 256;
    if (t->dtype == MS_NN_F16) {
        int e = (int)(u >> 10 & 31), m = (int)(u & 1023);
        x = e == 31 ? (m ? (double)NAN : (double)INFINITY) : e ? ldexp(1024 + m, e - 25) : ldexp(m, -24);
        return u >> 15 ? -x : x;
    }
    if (t->dtype == MS_NN_F64) {
        memcpy(&x, &u, 8);
        return x;
    }
    low = (uint32_t)(t->dtype == MS_NN_BF16 ? u << 16 : u);
    memcpy(&f, &low, 4);
    return (double)f;
}

static void put(unsigned char *to, uint32_t bits, int bytes)
{
    int k;
    for (k = 0; k < bytes; ++k) to[k] = (unsigned char)(bits >> (8 * k));
}

/* The tensor in another type; scale (NULL: none before) gets the rows' new ones for I8. */
static ms_nn_tensor convert(const ms_nn_tensor *t, const ms_nn_tensor *old_scale, ms_nn_dtype type,
                            unsigned char *scale)
{
    size_t rows = t->shape[0], count = 1, i, k;
    int bytes = type == MS_NN_F32 ? 4 : type == MS_NN_I8 ? 1 : 2, d;
    unsigned char *data;
    ms_nn_tensor out = *t;
    for (d = 1; d < t->rank; ++d) count *= t->shape[d];
    out.dtype = type;
    out.bytes = rows * count * (size_t)bytes;
    out.data = data = (unsigned char *)take(out.bytes, 1);
    for (i = 0; i < rows; ++i) {
        double before = old_scale ? element(old_scale, i) : 1, most = 0;
        float unit;
        for (k = 0; k < count; ++k) most = fmax(most, fabs(before * element(t, i * count + k)));
        unit = (float)(most > 0 ? most / 127 : 1);
        if (type == MS_NN_I8) put(scale + 4 * i, bits_of(unit), 4);
        for (k = 0; k < count; ++k, data += bytes) {
            double x = before * element(t, i * count + k);
            if (type == MS_NN_I8) put(data, (uint32_t)(int32_t)lrint(fmax(-127, fmin(127, x / (double)unit))), 1);
            else
                put(data,
                    type == MS_NN_F32       ? bits_of((float)x)
                        : type == MS_NN_F16 ? half_of((float)x)
                                            : brain_of((float)x),
                    bytes);
        }
    }
    return out;
}

/* Bytes in memory, for a file in between. */
typedef struct memory {
    unsigned char *bytes;
    size_t size, room;
} memory;

static int memory_write(void *user, const void *bytes, size_t size)
{
    memory *m = (memory *)user;
    if (m->size + size > m->room) {
        unsigned char *larger = (unsigned char *)realloc(m->bytes, 2 * (m->size + size));
        if (larger == NULL) return 1;
        m->bytes = larger;
        m->room = 2 * (m->size + size);
    }
    if (size > 0) memcpy(m->bytes + m->size, bytes, size);
    m->size += size;
    return 0;
}

/* All numbers of a CSV file; *count of them. */
static float *numbers(const char *path, size_t *count)
{
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    memory text = {NULL, 0, 0};
    char part[4096], *p, *end;
    float *x;
    size_t got;
    if (f == NULL) exit(fail(path, problem));
    while ((got = fread(part, 1, sizeof part, f)) > 0)
        if (memory_write(&text, part, got)) exit(fail(path, "there is not enough memory"));
    fclose(f);
    if (memory_write(&text, "", 1)) exit(fail(path, "there is not enough memory"));
    x = (float *)take(text.size, sizeof(float));
    for (*count = 0, p = (char *)text.bytes; *(p += strspn(p, " ,\t\r\n")) != 0; p = end) {
        x[(*count)++] = (float)number_read(p, '.', &end);
        if (end == p) exit(fail(path, "there is something that is no number"));
    }
    free(text.bytes);
    return x;
}

/* All weights of the network's layers in another type, into a file by name. */
static int save(const ms_nn *nn, ms_nn_dtype type, const char *path)
{
    const ms_nn_file *file = ms_nn_tensors(nn);
    size_t count = ms_nn_file_tensor_count(file), entries = ms_nn_file_entry_count(file), n = 0, i;
    ms_nn_tensor *t = (ms_nn_tensor *)take(2 * count, sizeof *t);
    ms_nn_entry *entry = (ms_nn_entry *)take(entries, sizeof *entry);
    ms_error error;
    int l;
    for (i = 0; i < entries; ++i) entry[i] = *ms_nn_file_entry(file, i);
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *from = ms_nn_file_tensor(file, i), *scale;
        size_t length = strlen(from->name);
        char *name = (char *)take(length + 32, 1);
        if (strcmp(from->name, "ms_nn.collapse") == 0) continue; /* of the old weights */
        for (l = 0; l < ms_nn_layer_count(nn); ++l) {
            ms_nn_layer layer = ms_nn_layer_at(nn, l);
            size_t own = strlen(layer.name);
            if (layer.dtype == MS_NN_DTYPE_COUNT || own > length || strncmp(from->name, layer.name, own)) continue;
            if (strcmp(from->name + own, ".weight") == 0 || strcmp(from->name + own, ".weight_scale") == 0) break;
        }
        if (l == ms_nn_layer_count(nn)) {
            t[n++] = *from;
            continue;
        }
        if (from->name[length - 1] == 'e') continue; /* the old scales */
        sprintf(name, "%s_scale", from->name);
        scale = ms_nn_file_find(file, name);
        if (type == MS_NN_I8) {
            ms_nn_tensor s = {name, MS_NN_F32, 1, from->shape, take(from->shape[0], 4), 4 * from->shape[0]};
            t[n++] = convert(from, scale, type, (unsigned char *)(uintptr_t)s.data);
            t[n++] = s;
        } else {
            t[n++] = convert(from, scale, type, NULL);
        }
    }
    if (ms_nn_file_save(path, t, n, entry, entries, NULL, &error) != MS_OK) return fail(path, error.message);
    return 0;
}

int main(int argc, char **argv)
{
    static const char *const type_name[] = {"f32", "f16", "bf16", "i8"};
    static const ms_nn_dtype types[] = {MS_NN_F32, MS_NN_F16, MS_NN_BF16, MS_NN_I8};
    const char *inputs = NULL, *type = NULL;
    long rank = 0, samples = 64;
    int i, k;
    size_t in, out, j;
    ms_nn *nn, *small = NULL, *made;
    ms_error error;
    memory between = {NULL, 0, 0};
    float *x, *y, *z;
    double low = HUGE_VAL, high = -HUGE_VAL, sum = 0, worst = 0;
    if (file_help(argc, argv, usage)) return file_end_stdout("nn_quantise");
    for (i = 3; i + 1 < argc; i += 2) {
        char *end = NULL;
        if (strcmp(argv[i], "--type") == 0) type = argv[i + 1];
        else if (strcmp(argv[i], "--inputs") == 0) inputs = argv[i + 1];
        else if (strcmp(argv[i], "--rank") == 0) rank = strtol(argv[i + 1], &end, 10);
        else if (strcmp(argv[i], "--samples") == 0) samples = strtol(argv[i + 1], &end, 10);
        else return file_usage(usage);
        if (end && (*end || rank < 0 || samples < 1 || samples > 1000000)) return file_usage(usage);
    }
    for (k = 0; k < 4 && (type == NULL || strcmp(type, type_name[k])); ++k) {}
    if (argc < 3 || i != argc || k == 4) return file_usage(usage);
    if (ms_nn_load_file(argv[1], NULL, &nn, &error) != MS_OK) return fail(argv[1], error.message);
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    if (inputs) {
        size_t count;
        x = numbers(inputs, &count);
        if (count == 0 || count % in) return fail(inputs, "its numbers do not make whole inputs");
        samples = (long)(count / in);
    } else {
        uint32_t state = 1;
        x = (float *)take((size_t)samples * in, sizeof(float));
        for (j = 0; j < (size_t)samples * in; ++j) {
            state = state * 1664525u + 1013904223u;
            x[j] = (float)(state >> 8) / 16777216.0f;
        }
    }
    if (rank > 0) {
        ms_nn_collapse *c;
        ms_nn_low_rank *l;
        ms_nn_sink sink;
        if (ms_nn_collapse_create(nn, NULL, &c, &error) != MS_OK ||
            ms_nn_low_rank_create(c, (int)samples, x, 0, &l, &error) != MS_OK)
            return fail(argv[1], error.message);
        sink.user = &between;
        sink.write = memory_write;
        if (rank > (long)ms_nn_collapse_features(c))
            return fail("--rank", "it is above the number of features of the last layer");
        if (ms_nn_low_rank_write(l, (int)rank, MS_NN_F32, sink, &error) != MS_OK ||
            ms_nn_load(between.bytes, between.size, NULL, &small, &error) != MS_OK)
            return fail(argv[1], error.message);
        ms_nn_low_rank_destroy(l);
        ms_nn_collapse_destroy(c);
    }
    if (save(small ? small : nn, types[k], argv[2])) return 1;
    if (ms_nn_load_file(argv[2], NULL, &made, &error) != MS_OK) return fail(argv[2], error.message);
    y = (float *)take(2 * out, sizeof(float));
    z = y + out;
    for (i = 0; i < (int)samples; ++i) {
        double own = 0;
        if (ms_nn_forward(nn, 1, x + (size_t)i * in, y, NULL) != MS_OK ||
            ms_nn_forward(made, 1, x + (size_t)i * in, z, NULL) != MS_OK)
            return fail(argv[2], "it does not run");
        for (j = 0; j < out; ++j) {
            double d = (double)z[j] - (double)y[j];
            own += d * d;
            low = fmin(low, (double)y[j]);
            high = fmax(high, (double)y[j]);
        }
        sum += own;
        worst = fmax(worst, own);
    }
    {
        double range = (high - low) * (high - low) * (double)out;
        size_t before = 0, after = 0;
        for (j = 0; j < ms_nn_file_tensor_count(ms_nn_tensors(nn)); ++j)
            before += ms_nn_file_tensor(ms_nn_tensors(nn), j)->bytes;
        for (j = 0; j < ms_nn_file_tensor_count(ms_nn_tensors(made)); ++j)
            after += ms_nn_file_tensor(ms_nn_tensors(made), j)->bytes;
        printf("%s: %lu bytes of weights, %lu before\n", argv[2], (unsigned long)after, (unsigned long)before);
        if (sum > 0)
            printf("PSNR over %ld %s inputs: %.2f dB, least %.2f dB (against a range of outputs of %g)\n", samples,
                   inputs ? "given" : "random", 10 * log10(range * (double)samples / sum), 10 * log10(range / worst),
                   high - low);
        else printf("PSNR over %ld %s inputs: the outputs are equal\n", samples, inputs ? "given" : "random");
    }
    free(x);
    free(y);
    ms_nn_destroy(made);
    ms_nn_destroy(small);
    ms_nn_destroy(nn);
    free(between.bytes);
    return file_end_stdout("nn_quantise");
}
