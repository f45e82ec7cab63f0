/* Writes a network with narrower weights, and what that costs: PSNR of its outputs against the file's own, over given
     or random inputs. cc -O2 -I. examples/tools/nn_quantize.c -o build/nn_quantize -lm
     build/nn_quantize IN OUT --type f16|i8|f32 [--rank N] [--inputs X.csv] [--samples 64]
   --type     of the weights of dense and convolution layers, rounded to nearest; i8: one scale a row. Biases stay as
              they are. A weight beyond 65504 is refused as f16.
   --rank     first replaces a linear last layer by two of that rank, at most the number of its features: over the
   inputs W (h - mean h) becomes its projection U U' W on the output directions that carry most of its variance
   --inputs   rows of numbers, one an input; else --samples of them are drawn, each number even in [0, 1] */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "files.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] = "usage: nn_quantize IN OUT --type f16|i8|f32 [--rank N] [--inputs X.csv] [--samples 64]\n";

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "nn_quantize: %s: %s\n", what, why);
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

/* To nearest, ties to even; at most 65504. */
static uint16_t half_of(float x)
{
    uint32_t u = bits_of(x), sign = u >> 16 & 0x8000u, a = u & 0x7fffffffu, q;
    if (a > 0x7f800000u) return 0x7e00;
    if (a == 0x7f800000u) return (uint16_t)(sign | 0x7c00u);
    if (a < 0x38800000u) q = (uint32_t)lrint(ldexp(fabs((double)x), 24)); /* below 2^-14 steps of 2^-24 */
    else q = (a - 0x38000000u + 0xfffu + (a >> 13 & 1u)) >> 13;
    return (uint16_t)(sign | q);
}

/* Element i of a tensor of weights. */
static double element(const ms_nn_tensor *t, size_t i)
{
    float x = 0;
    ms_nn_tensor_read(t, i, 1, &x);
    return (double)x;
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
        unit = (float)(most / 127);
        if (!(unit > 0)) unit = 1; /* all 0, or so little that a scale would be 0 */
        if (type == MS_NN_I8) put(scale + 4 * i, bits_of(unit), 4);
        for (k = 0; k < count; ++k, data += bytes) {
            double x = before * element(t, i * count + k);
            if (type == MS_NN_F16 && fabs(x) > 65504 && isfinite(x)) {
                fprintf(stderr, "nn_quantize: tensor '%s' has a weight of %g: f16 ends at 65504\n", t->name, x);
                exit(1);
            }
            if (type == MS_NN_I8) put(data, (uint32_t)(int32_t)lrint(fmax(-127, fmin(127, x / (double)unit))), 1);
            else put(data, type == MS_NN_F32 ? bits_of((float)x) : half_of((float)x), bytes);
        }
    }
    return out;
}

/* All numbers of a CSV file; *count of them. */
static float *numbers(const char *path, size_t *count)
{
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    char *text = NULL, part[4096], *p, *end;
    float *x;
    size_t got, size = 0, room = 0;
    if (f == NULL) exit(fail(path, problem));
    do {
        got = fread(part, 1, sizeof part - 1, f);
        if (size + got + 1 > room && (text = (char *)realloc(text, room = 2 * (size + sizeof part))) == NULL)
            exit(fail(path, "there is not enough memory"));
        memcpy(text + size, part, got);
        size += got;
    } while (got > 0);
    fclose(f);
    text[size] = 0;
    x = (float *)take(size + 1, sizeof(float));
    if ((p = (char *)(size_t)csv_begin(text, size, &problem)) == NULL) exit(fail(path, problem));
    for (*count = 0; *(p += strspn(p, " ,\t\r\n")) != 0; p = end) {
        x[(*count)++] = (float)number_read(p, '.', &end);
        if (end == p) exit(fail(path, "there is something that is no number"));
    }
    free(text);
    return x;
}

/* The file in memory; *size bytes. */
static void *written(const ms_nn_tensor *t, size_t n, const ms_nn_entry *entry, size_t entries, size_t *size)
{
    ms_error error;
    void *bytes;
    if (ms_nn_file_write(t, n, entry, entries, NULL, 0, size, &error) != MS_OK) exit(fail("file", error.message));
    bytes = take(*size, 1);
    if (ms_nn_file_write(t, n, entry, entries, bytes, *size, size, &error) != MS_OK) exit(fail("file", error.message));
    return bytes;
}

/* --- low rank ----------------------------------------------------------------------------------------------------- */

static double dot(const double *a, const double *b, size_t n)
{
    double s[4] = {0, 0, 0, 0};
    size_t i;
    for (i = 0; i + 4 <= n; i += 4) {
        s[0] += a[i] * b[i];
        s[1] += a[i + 1] * b[i + 1];
        s[2] += a[i + 2] * b[i + 2];
        s[3] += a[i + 3] * b[i + 3];
    }
    for (; i < n; ++i) s[0] += a[i] * b[i];
    return s[0] + s[1] + (s[2] + s[3]);
}

/* (a, b) = (c a - s b, s a + c b). */
static void rotate(double *a, double *b, size_t n, double c, double s)
{
    size_t i;
    for (i = 0; i < n; ++i) {
        double u = a[i], v = b[i];
        a[i] = c * u - s * v;
        b[i] = s * u + c * v;
    }
}

/* C = L L' in place (lower, column k from row k on, column-major); a pivot of rounding size makes a zero column. */
static void cholesky(double *a, size_t n)
{
    size_t i, j, k;
    double largest = 0;
    for (j = 0; j < n; ++j) largest = fmax(largest, a[j * n + j]);
    for (k = 0; k < n; ++k) {
        double pivot = a[k * n + k], root = pivot > 1e-14 * largest ? sqrt(pivot) : 0;
        for (i = 0; i < k; ++i) a[k * n + i] = 0;
        for (i = k; i < n; ++i) a[k * n + i] = root > 0 ? a[k * n + i] / root : 0;
        for (j = k + 1; j < n; ++j)
            for (i = j; i < n; ++i) a[j * n + i] -= a[k * n + i] * a[k * n + j];
    }
}

/* One-sided Jacobi (Hestenes 1958): rotates the columns of g, and of l with them, until they are orthogonal. */
static void jacobi(double *g, double *l, size_t n)
{
    int sweep, rotated = 1;
    size_t p, q;
    for (sweep = 0; sweep < 40 && rotated; ++sweep) {
        rotated = 0;
        for (p = 0; p + 1 < n; ++p)
            for (q = p + 1; q < n; ++q) {
                double a = dot(g + p * n, g + p * n, n), b = dot(g + q * n, g + q * n, n),
                       d = dot(g + p * n, g + q * n, n), zeta, t, c;
                if (!(fabs(d) > 1e-14 * sqrt(a * b)) || !(fabs(d) > 1e-300)) continue;
                rotated = 1;
                zeta = (b - a) / (2 * d);
                t = (zeta < 0 ? -1 : 1) / (fabs(zeta) + sqrt(1 + zeta * zeta));
                c = 1 / sqrt(1 + t * t);
                rotate(g + p * n, g + q * n, n, c, c * t);
                rotate(l + p * n, l + q * n, n, c, c * t);
            }
    }
}

/* The file of the network with its last layer as "<name>.low" and "<name>". Over the samples x. Principal directions of
   W (h - mean): with R'R = W'W and the covariance L L' of h, the columns of R L are made orthogonal, R L V = G; the
   k-th output direction is U_k = W L V_k / |G_k|, of variance |G_k|^2. */
static void *low_rank(const ms_nn *nn, const char *path, size_t rank, const float *x, size_t samples, size_t *size)
{
    const ms_nn_file *file = ms_nn_tensors(nn);
    size_t count = ms_nn_file_tensor_count(file), entries = ms_nn_file_entry_count(file), n = 0, i, j, k, h, p, length;
    size_t channels = strcmp(ms_nn_layer_at(nn, 0).type, "shared_channels") == 0 ? ms_nn_output_shape(nn).size[0] : 1;
    ms_nn_layer last = ms_nn_layer_at(nn, ms_nn_layer_count(nn) - 1);
    ms_nn_tensor *t = (ms_nn_tensor *)take(count + 3, sizeof *t);
    ms_nn_entry *entry = (ms_nn_entry *)take(entries, sizeof *entry), *list = NULL;
    const ms_nn_tensor *weight, *bias, *scale;
    double *r, *g, *l, *mean, *a, *u, *row;
    float *features;
    unsigned char *low, *high, *shift;
    char *layers, *names;
    void *bytes;
    ms_nn *trunk;
    ms_error error;
    int depth = 0;
    if (strcmp(last.type, "dense") != 0 || strcmp(last.activation, "linear") != 0)
        exit(fail(path, "the last entry of its layer list is not a dense and linear layer"));
    length = strlen(last.name);
    if (length > 200 || strpbrk(last.name, "\"\\{}") != NULL)
        exit(fail(path, "the last layer's name is too long or odd"));
    names = (char *)take(4, 256);
    sprintf(names, "%s.low.weight", last.name);
    sprintf(names + 256, "%s.weight", last.name);
    sprintf(names + 512, "%s.bias", last.name);
    sprintf(names + 768, "%s.weight_scale", last.name);
    weight = ms_nn_file_find(file, names + 256);
    bias = ms_nn_file_find(file, names + 512);
    scale = ms_nn_file_find(file, names + 768);
    p = weight->shape[0];
    h = weight->shape[1];
    if (rank > h) exit(fail("--rank", "it is above the number of features of the last layer"));
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *old = ms_nn_file_tensor(file, i);
        if (old != weight && old != bias && old != scale) t[n++] = *old;
    }
    for (i = 0; i < entries; ++i) {
        entry[i] = *ms_nn_file_entry(file, i);
        if (strcmp(entry[i].key, "ms_nn_layers") == 0) list = &entry[i];
    }
    /* the network up to the features */
    layers = (char *)take(strlen(list->value) + 600, 1);
    strcpy(layers, list->value);
    for (i = strlen(layers); i > 0 && !(layers[--i] == '{' && --depth == 0);) depth += layers[i] == '}';
    for (; i > 0 && strchr(" ,\t\r\n", layers[i - 1]);) --i;
    strcpy(layers + i, layers[i - 1] == '[' ? "{\"type\":\"dropout\"}]" : "]"); /* the list must not be empty */
    list->value = layers;
    bytes = written(t, n, entry, entries, size);
    features = (float *)take(samples * channels, h * sizeof(float));
    if (ms_nn_load(bytes, *size, NULL, &trunk, &error) != MS_OK ||
        ms_nn_forward(trunk, (int)samples, x, features, NULL) != MS_OK)
        exit(fail(path, "it does not run without its last layer"));
    ms_nn_destroy(trunk);
    free(bytes);

    r = (double *)take(h, h * sizeof(double)), g = (double *)take(h, h * sizeof(double));
    l = (double *)take(h, h * sizeof(double)), mean = (double *)take(h, sizeof(double));
    a = (double *)take(rank, h * sizeof(double)), u = (double *)take(rank, h * sizeof(double));
    row = (double *)take(h, 2 * sizeof(double));
    for (i = 0; i < p; ++i) { /* the upper triangle of W'W, whose factor has R as its rows */
        const double factor = scale ? element(scale, i) : 1;
        for (k = 0; k < h; ++k) row[k] = factor * element(weight, i * h + k);
        for (j = 0; j < h; ++j)
            for (k = j; k < h; ++k) r[j * h + k] += row[j] * row[k];
    }
    cholesky(r, h);
    for (i = 0; i < samples * channels; ++i)
        for (k = 0; k < h; ++k) mean[k] += (double)features[i * h + k] / (double)(samples * channels);
    for (i = 0; i < samples * channels; ++i)
        for (j = 0; j < h; ++j)
            for (k = j; k < h; ++k)
                l[j * h + k] += ((double)features[i * h + j] - mean[j]) * ((double)features[i * h + k] - mean[k]) /
                    (double)(samples * channels);
    cholesky(l, h);
    for (k = 0; k < h; ++k)
        for (i = 0; i < h; ++i) g[k * h + i] = dot(r + i * h, l + k * h, h);
    jacobi(g, l, h);
    /* U = W D [p][rank] and A = D' R'R [rank][h], D the columns of L V / |G| with the most variance */
    for (k = 0; k < rank; ++k) {
        double most = -1, total = 0;
        for (j = i = 0; i < h; ++i) {
            double v = dot(g + i * h, g + i * h, h);
            total += v;
            if (v > most) most = v, j = i;
        }
        for (i = 0; i < h; ++i) u[k * h + i] = most > 1e-15 * total && most > 1e-300 ? l[j * h + i] / sqrt(most) : 0;
        memset(g + j * h, 0, h * sizeof(double));
        for (i = 0; i < h; ++i) row[i] = dot(r + i * h, u + k * h, h);
        for (i = 0; i < h; ++i)
            for (j = 0; j < h; ++j) a[k * h + j] += row[i] * r[i * h + j];
    }
    low = (unsigned char *)take(rank * h, 4), high = (unsigned char *)take(p * rank, 4);
    shift = (unsigned char *)take(p, 4);
    for (k = 0; k < rank * h; ++k) put(low + 4 * k, bits_of((float)a[k]), 4);
    for (k = 0; k < rank; ++k) row[h + k] = dot(a + k * h, mean, h);
    for (i = 0; i < p; ++i) { /* b + W mean - U A mean */
        double b = bias ? element(bias, i) : 0;
        for (k = 0; k < h; ++k) row[k] = element(weight, i * h + k) * (scale ? element(scale, i) : 1);
        b += dot(row, mean, h);
        for (k = 0; k < rank; ++k) {
            double v = dot(row, u + k * h, h);
            put(high + 4 * (i * rank + k), bits_of((float)v), 4);
            b -= v * row[h + k];
        }
        put(shift + 4 * i, bits_of((float)b), 4);
    }
    {
        size_t low_shape[2], high_shape[2];
        ms_nn_tensor made[3] = {{NULL, MS_NN_F32, 2, NULL, NULL, 0},
                                {NULL, MS_NN_F32, 2, NULL, NULL, 0},
                                {NULL, MS_NN_F32, 1, NULL, NULL, 0}};
        low_shape[0] = high_shape[1] = rank;
        low_shape[1] = h;
        high_shape[0] = p;
        made[0].name = names, made[0].shape = low_shape, made[0].data = low, made[0].bytes = 4 * rank * h;
        made[1].name = names + 256, made[1].shape = high_shape, made[1].data = high, made[1].bytes = 4 * p * rank;
        made[2].name = names + 512, made[2].shape = high_shape, made[2].data = shift, made[2].bytes = 4 * p;
        for (i = 0; i < 3; ++i) t[n++] = made[i];
        i = strlen(layers) - 1;
        sprintf(layers + i,
                "%s{\"type\":\"dense\",\"name\":\"%s.low\",\"bias\":false},{\"type\":\"dense\",\"name\":\"%s\"}]",
                layers[i - 1] == '[' ? "" : ",", last.name, last.name);
        bytes = written(t, n, entry, entries, size);
    }
    free(t), free(entry), free(names), free(layers), free(features), free(r), free(g), free(l), free(mean), free(a);
    free(u), free(row), free(low), free(high), free(shift);
    return bytes;
}

/* All weights of the network's layers in another type, into a file by name. */
static int save(const ms_nn *nn, ms_nn_dtype type, const char *path)
{
    const ms_nn_file *file = ms_nn_tensors(nn);
    size_t count = ms_nn_file_tensor_count(file), entries = ms_nn_file_entry_count(file), n = 0, i;
    ms_nn_tensor *t = (ms_nn_tensor *)take(2 * count, sizeof *t);
    ms_nn_entry *entry = (ms_nn_entry *)take(entries, sizeof *entry);
    const char *problem;
    void *bytes;
    int l;
    for (i = 0; i < entries; ++i) entry[i] = *ms_nn_file_entry(file, i);
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *from = ms_nn_file_tensor(file, i), *scale;
        size_t length = strlen(from->name);
        char *name = (char *)take(length + 32, 1);
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
    bytes = written(t, n, entry, entries, &n);
    problem = file_save(path, bytes, n);
    free(bytes);
    return problem ? fail(path, problem) : 0;
}

int main(int argc, char **argv)
{
    static const char *const type_name[] = {"f32", "f16", "i8"};
    static const ms_nn_dtype types[] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    const char *inputs = NULL, *type = NULL;
    long rank = 0, samples = 64;
    int i, k;
    size_t in, out, j;
    ms_nn *nn, *small = NULL, *made;
    ms_error error;
    void *between = NULL;
    float *x, *y, *z;
    double low = HUGE_VAL, high = -HUGE_VAL, sum = 0, worst = 0;
    if (file_help(argc, argv, usage)) return file_end_stdout("nn_quantize");
    for (i = 3; i + 1 < argc; i += 2) {
        char *end = NULL;
        if (strcmp(argv[i], "--type") == 0) type = argv[i + 1];
        else if (strcmp(argv[i], "--inputs") == 0) inputs = argv[i + 1];
        else if (strcmp(argv[i], "--rank") == 0) rank = strtol(argv[i + 1], &end, 10);
        else if (strcmp(argv[i], "--samples") == 0) samples = strtol(argv[i + 1], &end, 10);
        else return file_usage(usage);
        if (end && (*end || rank < 0 || samples < 1 || samples > 1000000)) return file_usage(usage);
    }
    for (k = 0; k < 3 && (type == NULL || strcmp(type, type_name[k])); ++k) {}
    if (argc < 3 || i != argc || k == 3) return file_usage(usage);
    if (ms_nn_load_file(argv[1], NULL, &nn, &error) != MS_OK) return fail(argv[1], error.message);
    if (types[k] == MS_NN_I8 && ms_nn_check_weights(nn, &error) != MS_OK) return fail(argv[1], error.message);
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    if (inputs) {
        size_t count;
        x = numbers(inputs, &count);
        if (count == 0 || count % in) return fail(inputs, "its numbers do not make whole inputs");
        samples = (long)(count / in);
    } else {
        uint32_t state = 1;
        x = (float *)take((size_t)samples, in * sizeof(float));
        for (j = 0; j < (size_t)samples * in; ++j) {
            state = state * 1664525u + 1013904223u;
            x[j] = (float)(state >> 8) / 16777216.0f;
        }
    }
    if (rank > 0) {
        size_t size;
        between = low_rank(nn, argv[1], (size_t)rank, x, (size_t)samples, &size);
        if (ms_nn_load(between, size, NULL, &small, &error) != MS_OK) return fail(argv[1], error.message);
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
        else if (sum <= 0)
            printf("PSNR over %ld %s inputs: the outputs are equal\n", samples, inputs ? "given" : "random");
        else printf("no PSNR: some outputs are NaN or infinite\n");
    }
    free(x);
    free(y);
    ms_nn_destroy(made);
    ms_nn_destroy(small);
    ms_nn_destroy(nn);
    free(between);
    return file_end_stdout("nn_quantize");
}
