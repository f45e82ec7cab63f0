/* The networks of the thesis with random weights, as files in memory: for benchmarks and the long tests. Glorot-like
   uniform weights, so that signals neither vanish nor explode. Needs ms_nn.h before it, and
   <sys/mman.h> for large pages. */
#ifndef MS_BENCH_NETS_H
#define MS_BENCH_NETS_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NETS_MAX 64

typedef struct nets_file {
    char layers[8192], input[64];
    char names[NETS_MAX][40];
    size_t shapes[NETS_MAX][4];
    float limits[NETS_MAX]; /* uniform in [-limit, limit]; negative: scales of the weights two entries before */
    ms_nn_tensor tensors[NETS_MAX];
    int count;
    unsigned char *bytes; /* the file */
    size_t size, room;
} nets_file;

static inline float nets_uniform(uint64_t *state)
{
    uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z ^= z >> 27;
    return (float)(int32_t)(z >> 32) * (1.0f / 2147483648.0f);
}

static inline uint16_t nets_bf16(float x)
{
    uint32_t u;
    memcpy(&u, &x, 4);
    return (uint16_t)((u + 0x7fff + (u >> 16 & 1)) >> 16); /* to nearest even */
}

static inline uint16_t nets_f16(float x)
{
    uint32_t u, sign, m;
    float a = fabsf(x) * 1.925929944387236e-34f; /* 2^-112: the exponent moves to half's */
    memcpy(&u, &x, 4);
    sign = u >> 16 & 0x8000u;
    memcpy(&m, &a, 4);
    m += 0x0fff + (m >> 13 & 1);
    return (uint16_t)(sign | m >> 13);
}

static inline void nets_add(nets_file *f, const char *layer, const char *part, ms_nn_dtype dtype, float limit, int rank,
                            size_t a, size_t b, size_t c, size_t d)
{
    ms_nn_tensor *t = &f->tensors[f->count];
    int i;
    size_t elements = 1;
    snprintf(f->names[f->count], sizeof f->names[0], "%s.%s", layer, part);
    f->shapes[f->count][0] = a;
    f->shapes[f->count][1] = b;
    f->shapes[f->count][2] = c;
    f->shapes[f->count][3] = d;
    for (i = 0; i < rank; ++i) elements *= f->shapes[f->count][i];
    f->limits[f->count] = limit;
    t->name = f->names[f->count];
    t->dtype = dtype;
    t->rank = rank;
    t->shape = f->shapes[f->count];
    t->data = NULL; /* random: nets_end */
    t->bytes = elements * (dtype == MS_NN_F32 ? 4 : dtype == MS_NN_I8 ? 1 : 2);
    f->count++;
}

/* One line of the layer list and its tensors. */
static inline void nets_layer(nets_file *f, const char *json, const char *name, ms_nn_dtype dtype, int rank, size_t out,
                              size_t in, size_t kh, size_t kw)
{
    size_t n = strlen(f->layers);
    snprintf(f->layers + n, sizeof f->layers - n, "%s%s", n > 1 ? "," : "", json);
    if (name) {
        float limit = sqrtf(3.0f / (float)(in * (rank > 2 ? kh : 1) * (rank > 3 ? kw : 1)));
        nets_add(f, name, "weight", dtype, limit, rank, out, in, kh, kw);
        nets_add(f, name, "bias", MS_NN_F32, 0.1f, 1, out, 0, 0, 0);
        if (dtype == MS_NN_I8) nets_add(f, name, "weight_scale", MS_NN_F32, -limit, 1, out, 0, 0, 0);
    }
}

/* The numbers of a tensor: a stream of its own for each name, so that files of other element types hold the same
   network. I8: rows scaled so that the largest weight is 127; the scales are made of the same stream. */
static inline int nets_fill(const nets_file *f, int t, unsigned char *to)
{
    const ms_nn_tensor *tensor = &f->tensors[t];
    int scales = f->limits[t] < 0, quantized = tensor->dtype == MS_NN_I8, source = scales ? t - 2 : t;
    size_t rows = tensor->shape[0], cols = 1, r, c;
    float limit = fabsf(f->limits[t]), *row;
    uint64_t state = 7;
    const char *p;
    int d;
    for (p = f->names[source]; *p; ++p) state = (state ^ (unsigned char)*p) * 0x100000001B3u;
    for (d = 1; d < f->tensors[source].rank; ++d) cols *= f->tensors[source].shape[d];
    row = (float *)malloc(cols * sizeof(float));
    if (row == NULL) return 1;
    for (r = 0; r < rows; ++r) {
        float largest = 1e-30f, scale;
        for (c = 0; c < cols; ++c) {
            row[c] = limit * nets_uniform(&state);
            if (fabsf(row[c]) > largest) largest = fabsf(row[c]);
        }
        scale = largest / 127;
        if (scales) memcpy(to + 4 * r, &scale, 4);
        else if (tensor->dtype == MS_NN_F32) memcpy(to + 4 * r * cols, row, 4 * cols);
        else
            for (c = 0; c < cols; ++c) {
                uint16_t h = tensor->dtype == MS_NN_F16 ? nets_f16(row[c]) : nets_bf16(row[c]);
                if (quantized) to[r * cols + c] = (unsigned char)(signed char)lrintf(row[c] / scale);
                else memcpy(to + 2 * (r * cols + c), &h, 2);
            }
    }
    free(row);
    return 0;
}

/* Moves the file to memory of large pages, where the system has them: 0, else 1 and nothing changes. */
static inline int nets_huge_pages(nets_file *f)
{
#if defined(MADV_HUGEPAGE)
    const size_t page = (size_t)2 << 20;
    size_t room = (f->size + page - 1) / page * page;
    void *at;
    if (posix_memalign(&at, page, room) != 0) return 1;
    if (madvise(at, room, MADV_HUGEPAGE) != 0) {
        free(at);
        return 1;
    }
    memcpy(at, f->bytes, f->size);
    free(f->bytes);
    f->bytes = (unsigned char *)at;
    f->room = room;
    return 0;
#else
    (void)f;
    return 1;
#endif
}

static inline void nets_begin(nets_file *f, const char *input)
{
    memset(f, 0, sizeof *f);
    snprintf(f->input, sizeof f->input, "%s", input);
    strcpy(f->layers, "[");
}

/* Makes the file; 0 on success. Release with free(f->bytes). */
static inline int nets_end(nets_file *f)
{
    ms_nn_entry metadata[4];
    ms_nn_file *file = NULL;
    ms_error error;
    void *at;
    size_t n = strlen(f->layers);
    int t;
    snprintf(f->layers + n, sizeof f->layers - n, "]");
    metadata[0].key = "format";
    metadata[0].value = "pt";
    metadata[1].key = "ms_nn_version";
    metadata[1].value = "1";
    metadata[2].key = "ms_nn_input";
    metadata[2].value = f->input;
    metadata[3].key = "ms_nn_layers";
    metadata[3].value = f->layers;
    if (ms_nn_file_write(f->tensors, (size_t)f->count, metadata, 4, NULL, 0, &f->size, &error) != MS_OK) {
        fprintf(stderr, "nets: %s\n", error.message);
        return 1;
    }
    f->room = f->size + 64;
    if (posix_memalign(&at, 4096, f->room) != 0) return 1; /* as a mapped file lies */
    f->bytes = (unsigned char *)at;
    if (ms_nn_file_write(f->tensors, (size_t)f->count, metadata, 4, at, f->room, &f->size, &error) != MS_OK ||
        ms_nn_file_open(at, f->size, NULL, &file, &error) != MS_OK)
        return 1;
    for (t = 0; t < f->count; ++t) {
        const ms_nn_tensor *place = ms_nn_file_find(file, f->names[t]);
        if (nets_fill(f, t, f->bytes + ((const unsigned char *)place->data - f->bytes))) return 1;
    }
    ms_nn_file_close(file);
    return 0;
}

/* 3.4.2: 4 x {Conv1D(64,3,1)-ELU-Upsample(2)} - FC(1000)-ELU - FC(3 side^2), Keras's flatten order. */
static inline int nets_renderer(nets_file *f, int side, size_t filters, size_t features, ms_nn_dtype dtype)
{
    char json[200], name[16];
    int i;
    nets_begin(f, "[1,19]");
    for (i = 1; i <= 4; ++i) {
        snprintf(name, sizeof name, "conv%d", i);
        snprintf(
            json, sizeof json,
            "{\"type\":\"conv1d\",\"name\":\"%s\",\"filters\":%d,\"kernel\":3,\"activation\":\"elu\",\"padding\":\"same\"}",
            name, (int)filters);
        nets_layer(f, json, name, dtype == MS_NN_I8 ? MS_NN_F32 : dtype, 3, filters, i == 1 ? 1 : filters, 3, 0);
        nets_layer(f, "{\"type\":\"upsample1d\",\"factor\":2}", NULL, dtype, 0, 0, 0, 0, 0);
    }
    nets_layer(f, "{\"type\":\"flatten\",\"order\":\"channels_last\"}", NULL, dtype, 0, 0, 0, 0, 0);
    snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"fc1\",\"units\":%d,\"activation\":\"elu\"}",
             (int)features);
    nets_layer(f, json, "fc1", dtype, 2, features, filters * 304, 0, 0);
    snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"fc2\",\"units\":%d,\"activation\":\"linear\"}",
             3 * side * side);
    nets_layer(f, json, "fc2", dtype, 2, (size_t)(3 * side * side), features, 0, 0);
    return nets_end(f);
}

/* 4.3.1, number 1 to 9, on side x side pictures with m outputs. The list has no entry 1: taken as number 2. Padding and
   activations are not stated: same padding, ReLU, a linear output. Dropout does nothing when a network runs. */
static inline int nets_inversion(nets_file *f, int number, int side, size_t m, ms_nn_dtype dtype)
{
    static const size_t filters[5] = {32, 32, 64, 128, 128};
    int deep = number == 4 || number == 5, blocks = deep ? 5 : 2, i;
    size_t features = deep ? 3000 : number == 8 ? 100 : 1000, in = 3, n = (size_t)side;
    char json[200], name[16], input[64];
    snprintf(input, sizeof input, "[3,%d,%d]", side, side);
    nets_begin(f, input);
    for (i = 0; i < blocks; ++i) {
        snprintf(name, sizeof name, "conv%d", i + 1);
        snprintf(
            json, sizeof json,
            "{\"type\":\"conv2d\",\"name\":\"%s\",\"filters\":%d,\"kernel\":3,\"activation\":\"relu\",\"padding\":\"same\"}",
            name, (int)filters[i]);
        nets_layer(f, json, name, dtype == MS_NN_I8 ? MS_NN_F32 : dtype, 4, filters[i], in, 3, 3);
        nets_layer(f, "{\"type\":\"maxpool2d\",\"size\":2}", NULL, dtype, 0, 0, 0, 0, 0);
        in = filters[i];
        n /= 2;
    }
    nets_layer(f, "{\"type\":\"flatten\",\"order\":\"channels_last\"}", NULL, dtype, 0, 0, 0, 0, 0);
    in *= n * n;
    for (i = 1; i <= 2; ++i) {
        snprintf(name, sizeof name, "fc%d", i);
        snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"%s\",\"units\":%d,\"activation\":\"relu\"}", name,
                 (int)features);
        nets_layer(f, json, name, dtype, 2, features, in, 0, 0);
        in = features;
    }
    snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"out\",\"units\":%d,\"activation\":\"linear\"}", (int)m);
    nets_layer(f, json, "out", dtype, 2, m, features, 0, 0);
    return nets_end(f);
}

/* One network for all three color channels: 11 of the 19 parameters -> 384 -> 384 -> 384 -> features -> side^2. */
static inline int nets_shared(nets_file *f, int side, size_t features, ms_nn_dtype dtype)
{
    const size_t width[5] = {11, 384, 384, 384, features};
    char json[200], name[16];
    int i;
    nets_begin(f, "[19]");
    nets_layer(f,
               "{\"type\":\"shared_channels\",\"inputs\":[[0,3,6,7,8,11,12,13,16,17,18],[1,4,6,7,9,11,12,14,16,17,18],"
               "[2,5,6,7,10,11,12,15,16,17,18]]}",
               NULL, dtype, 0, 0, 0, 0, 0);
    for (i = 1; i <= 5; ++i) {
        size_t out = i < 5 ? width[i] : (size_t)(side * side);
        snprintf(name, sizeof name, "fc%d", i);
        snprintf(json, sizeof json, "{\"type\":\"dense\",\"name\":\"%s\",\"units\":%d,\"activation\":\"%s\"}", name,
                 (int)out, i < 5 ? "elu" : "linear");
        nets_layer(f, json, name, dtype, 2, out, width[i - 1], 0, 0);
    }
    return nets_end(f);
}
#endif
