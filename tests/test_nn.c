/* Networks against naive double-precision loops, finite differences, the reference data, and themselves at every SIMD
   level, thread count and batch size. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "nn_inside.h"
#include "json.h"
#include "test.h"
#include "stack.h"
#if defined(__x86_64__) || defined(_M_X64) || defined(__i386__) && defined(__SSE2__)
#define TEST_X64
#include <emmintrin.h>
#endif

/* --- the reference: layers as plain loops in double --- */

enum { DENSE, CONV1D, CONV2D, UP1D, UP2D, POOL1D, POOL2D, FLATTEN, ACTIVATION, ADD, DROPOUT, MEAN1D, MEAN2D, GLOBAL };

typedef struct ref_layer {
    int kind, act, same, last; /* last: channels_last flatten */
    int out, kernel[2], stride[2], factor[2];
    double alpha;
    int from;     /* ADD: value index, 0 is the input */
    int zeros[2]; /* of convolutions */
    int dims[3], in[3];
    double *w, *b; /* as stored, after rounding to the file's type */
} ref_layer;

typedef struct ref_net {
    ref_layer layer[24];
    int layers, input[3], rank;
    ms_nn_dtype dtype;
    const char *shared; /* the lists of shared_channels, or NULL; input is then one channel's and */
    int outer;          /* the size of the file's input */
    unsigned char *file;
    size_t size;
} ref_net;

static int count_of(const int d[3]) { return d[0] * d[1] * d[2]; }

static double ref_act(int act, double alpha, double x)
{
    switch (act) {
    case 1: return x > 0 ? x : 0;
    case 2: return x > 0 ? x : alpha * x;
    case 3: return x > 0 ? x : alpha * expm1(x);
    case 4: return tanh(x);
    case 5: return 1 / (1 + exp(-x));
    case 6: return x > 0 ? x + log1p(exp(-x)) : log1p(exp(x));
    case 7: return x / (1 + exp(-x));
    case 8: return 0.5 * x * erfc(-x / sqrt(2.0));
    default: return x;
    }
}

static double ref_slope(int act, double alpha, double x)
{
    double s;
    switch (act) {
    case 1: return x > 0;
    case 2: return x > 0 ? 1 : alpha;
    case 3: return x > 0 ? 1 : alpha * exp(x);
    case 4: s = tanh(x); return 1 - s * s;
    case 5: s = 1 / (1 + exp(-x)); return s * (1 - s);
    case 6: return 1 / (1 + exp(-x));
    case 7: s = 1 / (1 + exp(-x)); return s + x * s * (1 - s);
    case 8: return 0.5 * erfc(-x / sqrt(2.0)) + x * exp(-0.5 * x * x) / sqrt(2 * acos(-1.0));
    default: return 1;
    }
}

/* Each layer as a list of terms y[o] += w x[i]: one routine serves forward and backward. For pools the term is the
   maximum's. */
typedef struct ref_run {
    double *value[25], *pre[25]; /* outputs; before the activation */
} ref_run;

static void ref_linear(const ref_layer *l, const double *x, double *y, const double *g_y, double *g_x)
{
    int c, i, j, k, u, v, n = l->in[0], h = l->in[1], w = l->in[2], oh = l->dims[1], ow = l->dims[2];
    if (l->kind == DENSE) {
        int cols = count_of(l->in);
        for (c = 0; c < l->out; ++c) {
            double sum = l->b[c];
            for (i = 0; i < cols; ++i) {
                if (y) sum += l->w[c * cols + i] * x[i];
                else g_x[i] += l->w[c * cols + i] * g_y[c];
            }
            if (y) y[c] = sum;
        }
        return;
    }
    for (c = 0; c < l->dims[0]; ++c)
        for (i = 0; i < oh; ++i)
            for (j = 0; j < ow; ++j) {
                int at = (c * oh + i) * ow + j, best = -1;
                double sum = 0;
                if (l->kind == CONV1D || l->kind == CONV2D) {
                    int py = l->same ? (l->kernel[0] - 1) / 2 : l->zeros[0],
                        px = l->same ? (l->kernel[1] - 1) / 2 : l->zeros[1];
                    sum = l->b[c];
                    for (k = 0; k < n; ++k)
                        for (u = 0; u < l->kernel[0]; ++u)
                            for (v = 0; v < l->kernel[1]; ++v) {
                                int yy = i * l->stride[0] + u - py, xx = j * l->stride[1] + v - px;
                                double f = l->w[((c * n + k) * l->kernel[0] + u) * l->kernel[1] + v];
                                if (yy < 0 || yy >= h || xx < 0 || xx >= w) continue;
                                if (y) sum += f * x[(k * h + yy) * w + xx];
                                else g_x[(k * h + yy) * w + xx] += f * g_y[at];
                            }
                    if (y) y[at] = sum;
                    continue;
                }
                if (l->kind == MEAN1D || l->kind == MEAN2D || l->kind == GLOBAL) {
                    double share = 1.0 / (l->kernel[0] * l->kernel[1]);
                    for (u = 0; u < l->kernel[0]; ++u)
                        for (v = 0; v < l->kernel[1]; ++v) {
                            int q = (c * h + i * l->stride[0] + u) * w + j * l->stride[1] + v;
                            if (y) sum += share * x[q];
                            else g_x[q] += share * g_y[at];
                        }
                    if (y) y[at] = sum;
                    continue;
                }
                if (l->kind == UP1D || l->kind == UP2D) best = (c * h + i / l->factor[0]) * w + j / l->factor[1];
                if (l->kind == POOL1D || l->kind == POOL2D)
                    for (u = 0; u < l->kernel[0]; ++u)
                        for (v = 0; v < l->kernel[1]; ++v) {
                            int q = (c * h + i * l->stride[0] + u) * w + j * l->stride[1] + v;
                            if (best < 0 || x[q] > x[best]) best = q;
                        }
                if (y) y[at] = x[best];
                else g_x[best] += g_y[at];
            }
}

static void ref_forward(const ref_net *net, const double *x, ref_run *r)
{
    int k, i, n = count_of(net->input);
    r->value[0] = (double *)malloc((size_t)n * sizeof(double));
    memcpy(r->value[0], x, (size_t)n * sizeof(double));
    for (k = 0; k < net->layers; ++k) {
        const ref_layer *l = &net->layer[k];
        double *in = r->value[k], *pre;
        n = count_of(l->dims);
        pre = r->pre[k + 1] = (double *)malloc((size_t)n * sizeof(double));
        r->value[k + 1] = (double *)malloc((size_t)n * sizeof(double));
        if (l->kind == FLATTEN) {
            int c, p, pixels = l->in[1] * l->in[2];
            for (c = 0; c < l->in[0]; ++c)
                for (p = 0; p < pixels; ++p) pre[l->last ? p * l->in[0] + c : c * pixels + p] = in[c * pixels + p];
        } else if (l->kind == ACTIVATION || l->kind == DROPOUT || l->kind == ADD) {
            for (i = 0; i < n; ++i) pre[i] = in[i] + (l->kind == ADD ? r->value[l->from][i] : 0);
        } else {
            ref_linear(l, in, pre, NULL, NULL);
        }
        for (i = 0; i < n; ++i) r->value[k + 1][i] = ref_act(l->act, l->alpha, pre[i]);
    }
}

static void ref_backward(const ref_net *net, const ref_run *r, const double *g_y, double *g_x)
{
    double *g[25];
    int k, i, n = count_of(net->input);
    for (k = 0; k <= net->layers; ++k)
        g[k] = (double *)calloc((size_t)count_of(k ? net->layer[k - 1].dims : net->input), sizeof(double));
    memcpy(g[net->layers], g_y, (size_t)count_of(net->layer[net->layers - 1].dims) * sizeof(double));
    for (k = net->layers - 1; k >= 0; --k) {
        const ref_layer *l = &net->layer[k];
        double *gy = g[k + 1];
        int m = count_of(l->dims);
        for (i = 0; i < m; ++i) gy[i] *= ref_slope(l->act, l->alpha, r->pre[k + 1][i]);
        if (l->kind == FLATTEN) {
            int c, p, pixels = l->in[1] * l->in[2];
            for (c = 0; c < l->in[0]; ++c)
                for (p = 0; p < pixels; ++p) g[k][c * pixels + p] += gy[l->last ? p * l->in[0] + c : c * pixels + p];
        } else if (l->kind == ACTIVATION || l->kind == DROPOUT || l->kind == ADD) {
            for (i = 0; i < m; ++i) g[k][i] += gy[i];
            for (i = 0; l->kind == ADD && i < m; ++i) g[l->from][i] += gy[i];
        } else {
            ref_linear(l, r->value[k], NULL, gy, g[k]);
        }
    }
    for (i = 0; i < n; ++i) g_x[i] = g[0][i];
    for (k = 0; k <= net->layers; ++k) free(g[k]);
}

static void ref_free_run(const ref_net *net, ref_run *r)
{
    int k;
    for (k = 0; k <= net->layers; ++k) {
        free(r->value[k]);
        if (k) free(r->pre[k]);
    }
}

/* --- random networks and their files --- */

/* The file into n->file. */
static void net_write(ref_net *n, const ms_nn_tensor *t, int tensors, const ms_nn_entry *e, int entries)
{
    ms_error error;
    if (ms_nn_file_write(t, (size_t)tensors, e, (size_t)entries, NULL, 0, &n->size, &error) != MS_OK) {
        TEST_FAIL("%s", error.message);
        return;
    }
    free(n->file);
    n->file = (unsigned char *)malloc(n->size);
    CHECK_INT(ms_nn_file_write(t, (size_t)tensors, e, (size_t)entries, n->file, n->size, &n->size, &error), MS_OK);
}

/* x as a number of the type; its bits at out. Rounding is the test's own: to nearest, ties to even. */
static double store(ms_nn_dtype dtype, double x, unsigned char *out, double scale)
{
    int i, bytes = dtype == MS_NN_F32 ? 4 : dtype == MS_NN_I8 ? 1 : 2;
    uint64_t bits = 0;
    if (dtype == MS_NN_I8) {
        int q = (int)rint(x / scale);
        bits = (uint64_t)(uint8_t)(q < -127 ? -127 : q > 127 ? 127 : q);
        x = (double)(int8_t)bits * scale;
    } else {
        float f = (float)x;
        uint32_t u;
        if (dtype == MS_NN_F16) { /* 11 significant bits, spacing at least 2^-24 */
            int e;
            double unit;
            frexp(x, &e);
            unit = ldexp(1, e - 11 < -24 ? -24 : e - 11);
            f = (float)(rint(x / unit) * unit);
        }
        memcpy(&u, &f, 4);
        bits = u;
        if (dtype == MS_NN_F16) {
            double a = fabs((double)f);
            int e;
            frexp(a, &e);
            bits = a == 0           ? 0
                : a < ldexp(1, -14) ? (uint64_t)ldexp(a, 24)
                                    : ((uint64_t)(e + 14) << 10) + (uint64_t)ldexp(a, 11 - e) - 1024;
            if (f < 0) bits |= 0x8000;
        }
        x = (double)f;
    }
    for (i = 0; i < bytes; ++i) out[i] = (unsigned char)(bits >> (8 * i) & 0xff);
    return x;
}

static ref_layer *net_layer(ref_net *n, int kind)
{
    ref_layer *l = &n->layer[n->layers];
    memset(l, 0, sizeof *l);
    memcpy(l->in, n->layers ? n->layer[n->layers - 1].dims : n->input, sizeof l->in);
    memcpy(l->dims, l->in, sizeof l->dims);
    l->kind = kind;
    l->alpha = 1;
    l->stride[0] = l->stride[1] = l->kernel[0] = l->kernel[1] = l->factor[0] = l->factor[1] = 1;
    n->layers++;
    return l;
}

static void net_begin(ref_net *n, ms_nn_dtype dtype, int rank, int c, int h, int w)
{
    memset(n, 0, sizeof *n);
    n->dtype = dtype;
    n->rank = rank;
    n->input[0] = c;
    n->input[1] = h;
    n->input[2] = w;
}

static void net_dense(ref_net *n, int units, int act)
{
    ref_layer *l = net_layer(n, DENSE);
    l->out = l->dims[0] = units;
    l->dims[1] = l->dims[2] = 1;
    l->act = act;
    if (act == 2) l->alpha = 0.25;
    if (act == 3) l->alpha = 0.75;
}

static void net_conv(ref_net *n, int kind, int filters, int kh, int kw, int sh, int sw, int same, int act)
{
    ref_layer *l = net_layer(n, kind);
    int d, k[2], s[2];
    k[0] = kh;
    k[1] = kw;
    s[0] = sh;
    s[1] = sw;
    l->out = l->dims[0] = filters;
    for (d = 0; d < 2; ++d) {
        l->kernel[d] = k[d];
        l->stride[d] = s[d];
        l->dims[d + 1] = ((same ? l->in[d + 1] - 1 : l->in[d + 1] - k[d]) / s[d]) + 1;
    }
    l->same = same;
    l->act = act;
    if (act == 2) l->alpha = 0.125;
}

/* With zeros around; of height 1 where kh is 0. */
static void net_zeros(ref_net *n, int filters, int kh, int kw, int stride, int zeros, int act)
{
    ref_layer *l = net_layer(n, kh ? CONV2D : CONV1D);
    int d;
    l->out = l->dims[0] = filters;
    l->act = act;
    for (d = kh ? 0 : 1; d < 2; ++d) {
        l->kernel[d] = d ? kw : kh;
        l->stride[d] = d ? stride : 1 + stride / 2;
        l->zeros[d] = d ? zeros : zeros / 2;
        l->dims[d + 1] = (l->in[d + 1] + 2 * l->zeros[d] - l->kernel[d]) / l->stride[d] + 1;
    }
}

static void net_mean(ref_net *n, int kind, int kh, int kw, int sh, int sw)
{
    ref_layer *l = net_layer(n, kind);
    l->kernel[0] = kind == GLOBAL ? l->in[1] : kh;
    l->kernel[1] = kind == GLOBAL ? l->in[2] : kw;
    l->stride[0] = sh;
    l->stride[1] = sw;
    l->dims[1] = kind == GLOBAL ? 1 : (l->in[1] - kh) / sh + 1;
    l->dims[2] = kind == GLOBAL ? 1 : (l->in[2] - kw) / sw + 1;
}

static void net_up(ref_net *n, int kind, int fh, int fw)
{
    ref_layer *l = net_layer(n, kind);
    l->factor[0] = fh;
    l->factor[1] = fw;
    l->dims[1] *= fh;
    l->dims[2] *= fw;
}

static void net_pool(ref_net *n, int kind, int kh, int kw, int sh, int sw)
{
    ref_layer *l = net_layer(n, kind);
    l->kernel[0] = kh;
    l->kernel[1] = kw;
    l->stride[0] = sh;
    l->stride[1] = sw;
    l->dims[1] = (l->in[1] - kh) / sh + 1;
    l->dims[2] = (l->in[2] - kw) / sw + 1;
}

static void net_flatten(ref_net *n, int last)
{
    ref_layer *l = net_layer(n, FLATTEN);
    l->last = last;
    l->dims[0] = count_of(l->in);
    l->dims[1] = l->dims[2] = 1;
}

/* Writes the file with random weights of variance 1 / fan-in. */
static void net_end(ref_net *n, uint64_t *state)
{
    static const char *const kinds[] = {"dense",     "conv1d",    "conv2d",    "upsample1d", "upsample2d",
                                        "maxpool1d", "maxpool2d", "flatten",   "activation", "add",
                                        "dropout",   "avgpool1d", "avgpool2d", "globalpool"};
    static const char *const acts[] = {"linear",  "relu",     "leaky_relu", "elu", "tanh",
                                       "sigmoid", "softplus", "silu",       "gelu"};
    char layers[6000] = "[", input[60], names[72][32];
    ms_nn_tensor t[72];
    size_t shapes[72][4];
    void *hold[72];
    ms_nn_entry e[3];
    int k, tensors = 0, i;
    if (n->shared) snprintf(layers, sizeof layers, "[{\"type\":\"shared_channels\",\"inputs\":%s},", n->shared);
    for (k = 0; k < n->layers; ++k) {
        ref_layer *l = &n->layer[k];
        int conv = l->kind == CONV1D || l->kind == CONV2D, two = l->kind == CONV2D, rows = l->out;
        size_t at = strlen(layers),
               fan = (size_t)(l->kind == DENSE ? count_of(l->in) : l->in[0] * l->kernel[0] * l->kernel[1]), j;
        at += (size_t)snprintf(layers + at, sizeof layers - at, "%s{\"type\":\"%s\",\"name\":\"l%d\"", k ? "," : "",
                               kinds[l->kind], k);
        if (l->kind == DENSE) at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"units\":%d", l->out);
        if (conv && two)
            at += (size_t)snprintf(layers + at, sizeof layers - at,
                                   ",\"filters\":%d,\"kernel\":[%d,%d],\"stride\":[%d,%d]", l->out, l->kernel[0],
                                   l->kernel[1], l->stride[0], l->stride[1]);
        if (conv && !two)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"filters\":%d,\"kernel\":%d,\"stride\":%d",
                                   l->out, l->kernel[1], l->stride[1]);
        if (conv && l->zeros[1] && two)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"zeros\":[%d,%d]", l->zeros[0], l->zeros[1]);
        if (conv && l->zeros[1] && !two)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"zeros\":%d", l->zeros[1]);
        if (conv && (l->same || !l->zeros[1]))
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"padding\":\"%s\"", l->same ? "same" : "valid");
        if (l->kind == MEAN1D)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"size\":%d,\"stride\":%d", l->kernel[1],
                                   l->stride[1]);
        if (l->kind == MEAN2D)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"size\":[%d,%d],\"stride\":[%d,%d]",
                                   l->kernel[0], l->kernel[1], l->stride[0], l->stride[1]);
        if (l->kind == UP1D) at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"factor\":%d", l->factor[1]);
        if (l->kind == UP2D)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"factor\":[%d,%d]", l->factor[0], l->factor[1]);
        if (l->kind == POOL1D)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"size\":%d,\"stride\":%d", l->kernel[1],
                                   l->stride[1]);
        if (l->kind == POOL2D)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"size\":[%d,%d],\"stride\":[%d,%d]",
                                   l->kernel[0], l->kernel[1], l->stride[0], l->stride[1]);
        if (l->kind == FLATTEN)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"order\":\"%s\"",
                                   l->last ? "channels_last" : "channels_first");
        if (l->kind == DROPOUT) at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"rate\":0.5");
        if (l->kind == ADD && l->from)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"from\":\"l%d\"", l->from - 1);
        if (l->kind == ADD && !l->from) at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"from\":\"input\"");
        if (l->kind == DENSE || conv || l->kind == ACTIVATION || l->kind == ADD)
            at += (size_t)snprintf(layers + at, sizeof layers - at, ",\"activation\":\"%s\",\"alpha\":%.6f",
                                   acts[l->act], l->alpha);
        snprintf(layers + at, sizeof layers - at, "}");
        if (l->kind == DENSE || conv) {
            size_t count = (size_t)rows * fan;
            double limit = sqrt(3.0 / (double)fan);
            int width = n->dtype == MS_NN_F32 ? 4 : n->dtype == MS_NN_I8 ? 1 : 2;
            unsigned char *w = (unsigned char *)malloc(count * 4), *b = (unsigned char *)malloc((size_t)l->out * 4),
                          *s = (unsigned char *)malloc((size_t)rows * 4);
            l->w = (double *)malloc(count * sizeof(double));
            l->b = (double *)malloc((size_t)l->out * sizeof(double));
            for (i = 0; i < rows; ++i) {
                double scale = store(MS_NN_F32, limit / 127 * (0.5 + test_uniform(state)), s + 4 * i, 1);
                l->b[i] = store(MS_NN_F32, 0.2 * test_uniform(state) - 0.1, b + 4 * i, 1);
                for (j = 0; j < fan; ++j)
                    l->w[(size_t)i * fan + j] = store(n->dtype, limit * (2 * test_uniform(state) - 1),
                                                      w + (size_t)width * ((size_t)i * fan + j), scale);
            }
            for (i = 0; i < 3; ++i) {
                if (i == 2 && n->dtype != MS_NN_I8) {
                    free(s);
                    break;
                }
                snprintf(names[tensors], sizeof names[0], "l%d.%s", k,
                         i == 0       ? "weight"
                             : i == 1 ? "bias"
                                      : "weight_scale");
                shapes[tensors][0] = (size_t)rows;
                shapes[tensors][1] = (size_t)(l->kind == DENSE ? count_of(l->in) : l->in[0]);
                shapes[tensors][2] = (size_t)(two ? l->kernel[0] : l->kernel[1]);
                shapes[tensors][3] = (size_t)l->kernel[1];
                t[tensors].name = names[tensors];
                t[tensors].dtype = i == 0 ? n->dtype : MS_NN_F32;
                t[tensors].rank = i ? 1 : l->kind == DENSE ? 2 : two ? 4 : 3;
                t[tensors].shape = shapes[tensors];
                t[tensors].data = hold[tensors] = i == 0 ? w : i == 1 ? b : s;
                t[tensors].bytes = i == 0 ? count * (size_t)width : shapes[tensors][0] * 4;
                ++tensors;
            }
        }
    }
    strcat(layers, "]");
    if (n->rank == 1) snprintf(input, sizeof input, "[%d]", n->shared ? n->outer : n->input[0]);
    if (n->rank == 2) snprintf(input, sizeof input, "[%d,%d]", n->input[0], n->input[2]);
    if (n->rank == 3) snprintf(input, sizeof input, "[%d,%d,%d]", n->input[0], n->input[1], n->input[2]);
    e[0].key = "ms_nn_version";
    e[0].value = "1";
    e[1].key = "ms_nn_input";
    e[1].value = input;
    e[2].key = "ms_nn_layers";
    e[2].value = layers;
    net_write(n, t, tensors, e, 3);
    for (i = 0; i < tensors; ++i) free(hold[i]);
}

static void net_free(ref_net *n)
{
    int k;
    for (k = 0; k < n->layers; ++k) {
        free(n->layer[k].w);
        free(n->layer[k].b);
    }
    free(n->file);
}

static ms_nn *net_load(const ref_net *n, ms_simd simd)
{
    ms_nn_options o = ms_nn_defaults();
    ms_nn *nn = NULL;
    ms_error error;
    o.simd = simd;
    if (ms_nn_load(n->file, n->size, &o, &nn, &error) != MS_OK) TEST_FAIL("load: %s", error.message);
    return nn;
}

/* The networks of the tests, each with another trait. */
enum { NETS = 21 };
static const char *net_make(ref_net *n, int which, ms_nn_dtype dtype, uint64_t *state)
{
    const char *name = "";
    int i;
    switch (which) {
    case 0:
        name = "dense chain, all activations";
        net_begin(n, dtype, 1, 37, 1, 1);
        for (i = 0; i < 7; ++i) net_dense(n, i == 3 ? 131 : 20 + 13 * i, i);
        break;
    case 1:
        name = "one to one";
        net_begin(n, dtype, 1, 1, 1, 1);
        net_dense(n, 1, 4);
        break;
    case 2:
        name = "conv2d same 3x3";
        net_begin(n, dtype, 3, 3, 21, 53);
        net_conv(n, CONV2D, 11, 3, 3, 1, 1, 1, 1);
        break;
    case 3:
        name = "conv2d valid 5x2, stride 2x3";
        net_begin(n, dtype, 3, 2, 23, 31);
        net_conv(n, CONV2D, 9, 5, 2, 2, 3, 0, 3);
        break;
    case 4:
        name = "conv2d same, stride 2, even kernel";
        net_begin(n, dtype, 3, 4, 17, 40);
        net_conv(n, CONV2D, 5, 4, 4, 2, 2, 1, 6);
        break;
    case 5:
        name = "1x1 picture";
        net_begin(n, dtype, 3, 3, 1, 1);
        net_conv(n, CONV2D, 8, 3, 3, 1, 1, 1, 1);
        net_conv(n, CONV2D, 4, 1, 1, 1, 1, 0, 0);
        net_flatten(n, 1);
        net_dense(n, 3, 5);
        break;
    case 6:
        name = "odd pools";
        net_begin(n, dtype, 3, 5, 15, 37);
        net_pool(n, POOL2D, 2, 2, 2, 2);
        net_pool(n, POOL2D, 3, 2, 1, 2);
        net_flatten(n, 0);
        net_dense(n, 7, 0);
        break;
    case 7:
        name = "renderer, channels last";
        net_begin(n, dtype, 2, 1, 1, 19);
        for (i = 0; i < 4; ++i) {
            net_conv(n, CONV1D, 12, 1, 3, 1, 1, 1, 3);
            net_up(n, UP1D, 1, 2);
        }
        net_flatten(n, 1);
        net_dense(n, 40, 3);
        net_dense(n, 150, 0);
        break;
    case 8:
        name = "upsampling: factor 3, kernel 4, valid";
        net_begin(n, dtype, 2, 3, 1, 11);
        net_up(n, UP1D, 1, 3);
        net_conv(n, CONV1D, 6, 1, 4, 1, 1, 0, 4);
        net_up(n, UP1D, 1, 4);
        net_conv(n, CONV1D, 5, 1, 3, 1, 1, 1, 1);
        net_up(n, UP1D, 1, 2);
        net_flatten(n, 0);
        net_dense(n, 9, 0);
        break;
    case 9:
        name = "upsample2d before dense";
        net_begin(n, dtype, 3, 3, 4, 5);
        net_up(n, UP2D, 2, 3);
        net_flatten(n, 1);
        net_dense(n, 10, 2);
        break;
    case 10:
        name = "inversion";
        net_begin(n, dtype, 3, 3, 30, 30);
        for (i = 0; i < 2; ++i) {
            net_conv(n, CONV2D, 8, 3, 3, 1, 1, 1, 1);
            net_pool(n, POOL2D, 2, 2, 2, 2);
        }
        net_flatten(n, 1);
        net_dense(n, 50, 1);
        net_layer(n, DROPOUT);
        net_dense(n, 19, 0);
        break;
    case 11:
        name = "residual adds";
        net_begin(n, dtype, 3, 6, 9, 20);
        net_conv(n, CONV2D, 6, 3, 3, 1, 1, 1, 1);
        net_conv(n, CONV2D, 6, 3, 3, 1, 1, 1, 0);
        net_layer(n, ADD)->from = 0;
        net_layer(n, ADD)->from = 1;
        n->layer[3].act = 1;
        net_conv(n, CONV2D, 2, 1, 1, 1, 1, 0, 4);
        net_flatten(n, 0);
        net_dense(n, 33, 0);
        net_dense(n, 33, 3);
        net_layer(n, ADD)->from = 7;
        break;
    case 12:
        name = "conv1d stride, pool1d";
        net_begin(n, dtype, 2, 3, 1, 64);
        net_conv(n, CONV1D, 7, 1, 5, 1, 2, 1, 1);
        net_pool(n, POOL1D, 1, 3, 1, 2);
        net_layer(n, ACTIVATION)->act = 4;
        net_up(n, UP1D, 1, 3);
        net_conv(n, CONV1D, 4, 1, 3, 1, 2, 1, 0);
        break;
    case 13:
        name = "only an upsampling";
        net_begin(n, dtype, 3, 2, 3, 4);
        net_up(n, UP2D, 3, 2);
        break;
    case 14:
        name = "only a flatten";
        net_begin(n, dtype, 3, 3, 2, 5);
        net_flatten(n, 1);
        break;
    case 15:
        name = "conv2d of many channels";
        net_begin(n, dtype, 3, 16, 13, 53);
        net_conv(n, CONV2D, 20, 3, 3, 1, 1, 1, 3);
        net_conv(n, CONV2D, 9, 3, 5, 1, 2, 0, 4);
        net_conv(n, CONV2D, 8, 3, 1, 1, 1, 0, 0);
        net_conv(n, CONV2D, 3, 3, 3, 1, 1, 1, 1);
        break;
    case 17:
        name = "zeros around, strides";
        net_begin(n, dtype, 3, 6, 17, 23);
        net_zeros(n, 12, 3, 3, 1, 3, 7);
        net_zeros(n, 12, 3, 5, 3, 4, 8);
        net_zeros(n, 5, 1, 1, 1, 0, 0);
        break;
    case 18:
        name = "means and a skip";
        net_begin(n, dtype, 3, 3, 12, 17);
        net_conv(n, CONV2D, 9, 3, 3, 1, 1, 1, 8);
        net_mean(n, MEAN2D, 2, 3, 2, 2);
        net_conv(n, CONV2D, 9, 3, 3, 1, 1, 1, 7);
        net_up(n, UP2D, 2, 1);
        net_mean(n, MEAN2D, 1, 2, 1, 1);
        net_conv(n, CONV2D, 9, 3, 3, 1, 1, 1, 0);
        net_layer(n, ADD)->from = 5;
        net_mean(n, GLOBAL, 0, 0, 1, 1);
        net_flatten(n, 0);
        net_dense(n, 5, 0);
        net_dense(n, 4, 5);
        break;
    case 19:
        name = "signals";
        net_begin(n, dtype, 2, 4, 1, 21);
        net_zeros(n, 6, 0, 3, 2, 2, 8);
        net_mean(n, MEAN1D, 1, 2, 1, 2);
        net_up(n, UP1D, 1, 4);
        net_zeros(n, 3, 0, 1, 1, 0, 6);
        net_mean(n, GLOBAL, 0, 0, 1, 1);
        break;
    case 20:
        name = "smooth activations alone";
        net_begin(n, dtype, 1, 50, 1, 1);
        net_layer(n, ACTIVATION)->act = 8;
        net_dense(n, 40, 7);
        net_layer(n, ACTIVATION)->act = 7;
        net_dense(n, 30, 0);
        break;
    default:
        name = "wide dense";
        net_begin(n, dtype, 1, 9001, 1, 1);
        net_dense(n, 5, 0);
        net_dense(n, 6000, 0);
        break;
    }
    net_end(n, state);
    return name;
}

/* Largest |a - b| relative to the largest |b|. */
static double difference(const float *a, const double *b, int n)
{
    double most = 0, size = 1e-30;
    int i;
    for (i = 0; i < n; ++i) {
        if (!(fabs((double)a[i] - b[i]) <= most)) most = fabs((double)a[i] - b[i]);
        if (fabs(b[i]) > size) size = fabs(b[i]);
    }
    return most / size;
}

/* count directions at x at once, no more than the Jacobian takes together, by what it is made of. */
static void net_directions(const ms_nn *nn, size_t count, const float *x, const float *dx, float *dy)
{
    void *workspace = malloc(ms_nn_workspace_size(nn, MS_NN_JACOBIAN, 1));
    CHECK(inside_directions(nn, count, x, dx, dy, workspace));
    free(workspace);
}

/* J' g: what reverse mode would give. */
static void net_pull(const ms_nn *nn, const float *x, const float *g, float *g_x)
{
    size_t n = ms_nn_input_size(nn), m = ms_nn_output_size(nn), i, k;
    float *jacobian = (float *)malloc(n * m * sizeof(float));
    CHECK_INT(ms_nn_jacobian(nn, x, NULL, jacobian, NULL), MS_OK);
    for (i = 0; i < n; ++i) {
        double sum = 0;
        for (k = 0; k < m; ++k) sum += (double)g[k] * (double)jacobian[k * n + i];
        g_x[i] = (float)sum;
    }
    free(jacobian);
}

/* --- cases --- */

/* Smooth activations and their slopes far out, in long double: down to where floats end. */
static long double far_value(int act, long double x, int slope, long double *size)
{
    long double e = expl(-fabsl(x)), up = (x < 0 ? e : 1) / (1 + e), down = (x < 0 ? 1 : e) / (1 + e), v, density;
    *size = -1; /* of the terms; the value's own where nothing cancels */
    switch (act) {
    case 3: v = x > 0 ? (slope ? 1 : x) : 0.75L * (slope ? expl(x) : expm1l(x)); break;
    case 4:
        e = expl(-2 * fabsl(x));
        v = slope ? 4 * e / ((1 + e) * (1 + e)) : tanhl(x);
        break;
    case 5: v = slope ? up * down : up; break;
    case 6: v = slope ? up : (x > 0 ? x : 0) + log1pl(e); break;
    case 7:
        v = slope ? up + x * up * down : x * up;
        *size = up + fabsl(x) * up * down;
        break;
    default:
        density = expl(-x * x / 2) / sqrtl(2 * acosl(-1.0L));
        up = erfcl(-x / sqrtl(2.0L)) / 2;
        v = slope ? up + x * density : x * up;
        *size = up + fabsl(x) * density;
    }
    if (*size < 0 || !slope) *size = fabsl(v);
    return v;
}

/* A network of one activation of n values. Free file->file after the network. */
static ms_nn *net_activation(ref_net *file, const char *activation, double alpha, int n, ms_simd simd)
{
    char layers[200], input[16];
    ms_nn_entry e[3];
    memset(file, 0, sizeof *file);
    snprintf(layers, sizeof layers, "[{\"type\":\"activation\",\"activation\":\"%s\",\"alpha\":%g}]", activation,
             alpha);
    snprintf(input, sizeof input, "[%d]", n);
    e[0].key = "ms_nn_version";
    e[0].value = "1";
    e[1].key = "ms_nn_input";
    e[1].value = input;
    e[2].key = "ms_nn_layers";
    e[2].value = layers;
    net_write(file, NULL, 0, e, 3);
    return net_load(file, simd);
}

static void test_saturation(void)
{
    static const char *const acts[] = {"", "", "leaky_relu", "elu", "tanh", "sigmoid", "softplus", "silu", "gelu"};
    enum { N = 4401 };
    static float x[N], y[N], g[N];
    /* 3 ulp, 5 for the four roundings of a slope. Below 1.2e-38 e^-|x| has an error of one spacing, or there is nothing
       where the host flushes subnormals; the slope of tanh takes four of that, silu |x|. */
    double spacing = 1.4e-45, worst = 0;
    int act, simd, i;
    for (act = 2; act <= 8; ++act)
        for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
            ref_net file;
            ms_nn *nn = net_activation(&file, acts[act], 0.75, N, (ms_simd)simd);
            for (i = 0; i < N; ++i) {
                x[i] = (float)((i - 2200) * 0.05); /* -110 to 110 */
                g[i] = 1;
            }
            if (act == 2) x[0] = -1e-38f; /* times 0.75: is it flushed? */
            CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
            inside_activate(nn, x, g, N);
            if (act == 2 && !(y[0] < 0)) spacing = 1.2e-38;
            for (i = 0; act > 2 && i < N; ++i) {
                long double size, v = far_value(act, (long double)x[i], 0, &size), d;
                double floor = spacing * (5 + (act == 7 ? fabs((double)x[i]) : 0));
                d = fabsl((long double)y[i] - v);
                CHECK_LE((double)d, 4e-7 * (double)size + floor);
                if (size > 1e-37L && (double)(d / size) > worst) worst = (double)(d / size);
                v = far_value(act, (long double)x[i], 1, &size);
                d = fabsl((long double)g[i] - v);
                CHECK_LE((double)d, 6e-7 * (double)size + floor);
                if (size > 1e-37L && (double)(d / size) > worst) worst = (double)(d / size);
            }
            ms_nn_destroy(nn);
            free(file.file);
        }
    TEST_NOTE("largest relative error %.1e", worst);
}

/* Every reference network at every level, and its slopes. 1e-5 is what the data's notes ask of floats; these
   networks have fewer than 5000 terms a sum, whose rounding is about sqrt(5000) 6e-8 = 4e-6 at worst. */
static void test_reference(void)
{
    static const char *const names[] = {"act_elu",
                                        "act_sigmoid",
                                        "conv1d_k3_same",
                                        "conv2d_k3_same",
                                        "conv2d_k3_valid",
                                        "dense_wide",
                                        "flatten_dense_channels_first",
                                        "flatten_dense_channels_last",
                                        "inversion_small_valid_channels_first",
                                        "maxpool2d_odd",
                                        "renderer_f16",
                                        "renderer_i8",
                                        "renderer_small_channels_last",
                                        "upsample1d"};
    double worst = 0;
    int i, e, simd;
    for (i = 0; i < (int)(sizeof names / sizeof names[0]); ++i) {
        char path[200];
        json *j, *examples;
        snprintf(path, sizeof path, "tests/data/nn/%s.json", names[i]);
        j = json_load(path);
        examples = json_get(j, "examples");
        snprintf(path, sizeof path, "tests/data/nn/%s.safetensors", names[i]);
        for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
            ms_nn_options o = ms_nn_defaults();
            ms_nn *nn = NULL;
            ms_error error;
            o.simd = (ms_simd)simd;
            if (ms_nn_load_file(path, &o, &nn, &error) != MS_OK) {
                TEST_FAIL("%s: %s", names[i], error.message);
                continue;
            }
            for (e = 0; e < examples->count; ++e) {
                int n, m, k, q;
                double *x = json_numbers(json_get(&examples->child[e], "input"), &n),
                       *y = json_numbers(json_get(&examples->child[e], "output"), &m);
                double *g_y = json_numbers(json_get(&examples->child[e], "output_gradient"), &q),
                       *g_x = json_numbers(json_get(&examples->child[e], "input_gradient"), &q), d;
                float *f = (float *)malloc((size_t)(2 * n + 2 * m) * sizeof(float)), *fy = f + n, *fg = fy + m,
                      *fgx = fg + m;
                CHECK_INT(ms_nn_input_size(nn), n);
                CHECK_INT(ms_nn_output_size(nn), m);
                for (k = 0; k < n; ++k) f[k] = (float)x[k];
                for (k = 0; k < m; ++k) fg[k] = (float)g_y[k];
                CHECK_INT(ms_nn_forward(nn, 1, f, fy, NULL), MS_OK);
                d = difference(fy, y, m);
                if (!(d <= worst)) worst = d;
                CHECK_LE(d, 1e-5);
                net_pull(nn, f, fg, fgx);
                d = difference(fgx, g_x, n);
                if (!(d <= worst)) worst = d;
                CHECK_LE(d, 1e-5);
                free(f);
                free(x);
                free(y);
                free(g_y);
                free(g_x);
            }
            ms_nn_destroy(nn);
        }
        json_free(j);
    }
    TEST_NOTE("largest error %.1e", worst);
}

/* Random networks of every kind and element type, at every level, against the loops in double. */
static void test_random(void)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    uint64_t state = test_seed;
    double worst = 0;
    int which, type, simd, i;
    for (which = 0; which < NETS; ++which)
        for (type = 0; type < 3; ++type) {
            ref_net net;
            ref_run run;
            const char *name = net_make(&net, which, types[type], &state);
            int n = count_of(net.input), m = count_of(net.layer[net.layers - 1].dims);
            double *x = (double *)malloc((size_t)(2 * (n + m)) * sizeof(double)), *g_y = x + n, *g_x = g_y + m;
            float *f = (float *)malloc((size_t)(3 * (n + m)) * sizeof(float)), *fy = f + n, *fg = fy + m, *fgx = fg + m,
                  *dx = fgx + n, *dy = dx + n;
            for (i = 0; i < n; ++i) x[i] = (double)(f[i] = (float)test_normal(&state));
            for (i = 0; i < n; ++i) dx[i] = (float)test_normal(&state);
            for (i = 0; i < m; ++i) g_y[i] = (double)(fg[i] = (float)test_normal(&state));
            ref_forward(&net, x, &run);
            ref_backward(&net, &run, g_y, g_x);
            for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
                ms_nn *nn = net_load(&net, (ms_simd)simd);
                double a, b = 0, forth = 0, back = 0, scale = 0;
                if (nn == NULL) continue;
                CHECK_INT(ms_nn_forward(nn, 1, f, fy, NULL), MS_OK);
                a = difference(fy, run.value[net.layers], m);
                if (n * m < 10000) {
                    net_pull(nn, f, fg, fgx);
                    b = difference(fgx, g_x, n);
                }
                net_directions(nn, 1, f, dx, dy); /* <g, J d> = <J' g, d> */
                for (i = 0; i < m; ++i) {
                    forth += g_y[i] * (double)dy[i];
                    scale += fabs(g_y[i] * (double)dy[i]);
                }
                for (i = 0; i < n; ++i) back += g_x[i] * (double)dx[i];
                CHECK_NEAR(forth, back, 1e-5 * scale);
                /* rounding of at most 9001 terms a sum through at most 12 layers; 1e-5 as above */
                if (!(a <= 1e-5) || !(b <= 1e-5))
                    TEST_FAIL("%s, %s, %s: forward %.2e, slopes %.2e", name, ms_nn_dtype_string(types[type]),
                              ms_simd_string(ms_nn_simd(nn)), a, b);
                worst = fmax(worst, fmax(a, b));
                ms_nn_destroy(nn);
            }
            ref_free_run(&net, &run);
            free(x);
            free(f);
            net_free(&net);
        }
    TEST_NOTE("%d networks x 3 types x 4 levels; largest error %.1e", NETS, worst);
}

/* A sample alone and in batches of any size, with any number of threads: the same bits, and of the Jacobian. */
static void test_same_bits(void)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    uint64_t state = test_seed + 5;
    int which, batch, threads, i, simd;
    long compared = 0;
    for (which = 0; which < NETS; ++which)
        for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
            ref_net net;
            ms_nn *one;
            size_t n, m, slopes;
            float *x, *y1, *y2, *j1, *j2;
            net_make(&net, which, types[which % 3], &state);
            one = net_load(&net, (ms_simd)simd);
            n = ms_nn_input_size(one);
            m = ms_nn_output_size(one);
            slopes = n * m < 20000 ? n * m : 0;
            x = (float *)malloc((7 * (n + 2 * m) + 2 * slopes) * sizeof(float));
            y1 = x + 7 * n;
            y2 = y1 + 7 * m;
            j1 = y2 + 7 * m;
            j2 = j1 + slopes;
            for (i = 0; i < 7 * (int)n; ++i) x[i] = (float)test_normal(&state);
            for (i = 0; i < 7; ++i) ms_nn_forward(one, 1, x + (size_t)i * n, y1 + (size_t)i * m, NULL);
            if (slopes) CHECK_INT(ms_nn_jacobian(one, x, NULL, j1, NULL), MS_OK);
            ms_nn_destroy(one);
            for (threads = 1; threads <= 7; threads += 3)
                for (batch = 1; batch <= 7; batch += threads == 1 ? 1 : 3) {
                    test_pool pool;
                    ms_nn_options o = ms_nn_defaults();
                    ms_nn *nn = NULL;
                    o.simd = (ms_simd)simd;
                    if (threads > 1) o.parallel = test_parallel(&pool, threads);
                    CHECK_INT(ms_nn_load(net.file, net.size, &o, &nn, NULL), MS_OK);
                    CHECK_INT(ms_nn_forward(nn, batch, x, y2, NULL), MS_OK);
                    CHECK_INT(memcmp(y1, y2, (size_t)batch * m * sizeof(float)), 0);
                    compared += batch * (long)m;
                    if (slopes && batch == 1) {
                        CHECK_INT(ms_nn_jacobian(nn, x, y2, j2, NULL), MS_OK);
                        CHECK_INT(memcmp(y1, y2, m * sizeof(float)), 0);
                        CHECK_INT(memcmp(j1, j2, slopes * sizeof(float)), 0);
                        compared += (long)slopes;
                    }
                    ms_nn_destroy(nn);
                }
            free(x);
            net_free(&net);
        }
    TEST_NOTE("%ld floats equal", compared);
}

/* Calls use the whole workspace and nothing after it, and nothing of what was in it: the same bits over zeros and over
   NaN, at any alignment, for every element type and many counts. Dense layers too large to be packed are among them. */
static void test_workspaces(void)
{
    static const int counts[] = {1, 3, 64, 300}, nets[] = {0, 8, 10, 11, 17, 18, 19, 20, NETS, NETS + 1};
    uint64_t state = test_seed + 51;
    size_t k, c, i;
    int type, threads, fill;
    for (k = 0; k < sizeof nets / sizeof nets[0]; ++k)
        for (type = 0; type < 3; ++type)
            for (threads = 1; threads <= (type == 0 ? 3 : 1); threads += 2) {
                ref_net net;
                ms_nn *nn = NULL;
                ms_nn_options o = ms_nn_defaults();
                test_pool pool;
                size_t n, m, macs = 0;
                float *x, *y[2];
                if (nets[k] < NETS) {
                    net_make(&net, nets[k], (ms_nn_dtype)type, &state);
                } else { /* rows of columns beyond what is packed; then packed and not */
                    net_begin(&net, (ms_nn_dtype)type, 1, nets[k] == NETS ? 16387 : 23, 1, 1);
                    net_dense(&net, 7, 1);
                    if (nets[k] > NETS) net_dense(&net, 300000, 0);
                    net_end(&net, &state);
                }
                if (threads > 1) o.parallel = test_parallel(&pool, threads);
                CHECK_INT(ms_nn_load(net.file, net.size, &o, &nn, NULL), MS_OK);
                n = ms_nn_input_size(nn);
                m = ms_nn_output_size(nn);
                for (c = 0; c < (size_t)ms_nn_layer_count(nn); ++c) macs += ms_nn_layer_at(nn, (int)c).multiply_adds;
                x = (float *)malloc(300 * n * sizeof(float));
                y[0] = (float *)malloc(600 * m * sizeof(float));
                y[1] = y[0] + 300 * m;
                for (i = 0; i < 300 * n; ++i) x[i] = (float)test_normal(&state);
                for (c = 0; c < sizeof counts / sizeof counts[0] + 1; ++c) {
                    int count = c ? counts[c - 1] : 1, slopes = c == 0;
                    size_t size = ms_nn_workspace_size(nn, slopes ? MS_NN_JACOBIAN : MS_NN_FORWARD, count),
                           floats = slopes ? n * m : (size_t)count * m;
                    if (floats > 300 * m || macs * (slopes ? n : (size_t)count) > 30000000) continue; /* takes long */
                    for (fill = 0; fill < 2; ++fill) {
                        unsigned char *block = (unsigned char *)malloc(size + 65), *at = block + (fill ? 1 : 0);
                        memset(block, fill ? 0xff : 0, size + 65);
                        memset(at + size, 0x5a, 64 - (size_t)(at - block));
                        if (slopes) CHECK_INT(ms_nn_jacobian(nn, x, NULL, y[fill], at), MS_OK);
                        else CHECK_INT(ms_nn_forward(nn, count, x, y[fill], at), MS_OK);
                        for (i = 0; i < 64 - (size_t)(at - block); ++i) CHECK_INT(at[size + i], 0x5a);
                        free(block);
                    }
                    CHECK_INT(memcmp(y[0], y[1], floats * sizeof(float)), 0);
                }
                free(x);
                free(y[0]);
                ms_nn_destroy(nn);
                net_free(&net);
            }
}

/* Counts that end in the middle of a block: every sample has the bits of the sample alone, in every type, the workspace
   stops growing, and Jacobians of more inputs than run together agree with their directions alone. */
static void test_batches(void)
{
    enum { MOST = 101 };
    static const int counts[] = {2, 5, 13, 48, 49, MOST}, nets[] = {0, 2, 6, 8, 12, 14, 20};
    uint64_t state = test_seed + 21;
    size_t k, c, t;
    for (k = 0; k < sizeof nets / sizeof nets[0]; ++k)
        for (t = 0; t < 3; ++t) {
            ref_net net;
            ms_nn *nn;
            size_t n, m, i;
            float *x, *y1, *y2;
            net_make(&net, nets[k], (ms_nn_dtype)t, &state);
            nn = net_load(&net, MS_SIMD_AUTO);
            n = ms_nn_input_size(nn);
            m = ms_nn_output_size(nn);
            x = (float *)malloc(MOST * (n + 2 * m) * sizeof(float));
            y1 = x + MOST * n;
            y2 = y1 + MOST * m;
            for (i = 0; i < MOST * n; ++i) x[i] = (float)test_normal(&state);
            for (i = 0; i < MOST; ++i) ms_nn_forward(nn, 1, x + i * n, y1 + i * m, NULL);
            for (c = 0; c < sizeof counts / sizeof counts[0]; ++c) {
                CHECK_INT(ms_nn_forward(nn, counts[c], x, y2, NULL), MS_OK);
                CHECK_INT(memcmp(y1, y2, (size_t)counts[c] * m * sizeof(float)), 0);
            }
            CHECK_INT(ms_nn_workspace_size(nn, MS_NN_FORWARD, 1000000), ms_nn_workspace_size(nn, MS_NN_FORWARD, 48));
            if (n * m < 10000) {
                float *jacobian = (float *)malloc(n * m * sizeof(float)), *unit = (float *)calloc(n, sizeof(float));
                size_t j;
                CHECK_INT(ms_nn_jacobian(nn, x, NULL, jacobian, NULL), MS_OK);
                for (i = 0; i < n; ++i) {
                    unit[i] = 1;
                    net_directions(nn, 1, x, unit, y2);
                    unit[i] = 0;
                    for (j = 0; j < m; ++j) CHECK(memcmp(&jacobian[j * n + i], &y2[j], sizeof(float)) == 0);
                }
                free(jacobian);
                free(unit);
            }
            free(x);
            ms_nn_destroy(nn);
            net_free(&net);
        }
}

/* Dense layers around the shapes of the kernels' tiles, packed and where they lie, at every level: sums against
   double precision within the bound of any order of float sums, (n + 4) 2^-24 of the absolute products; the Jacobian is
   the matrix; a batch has the bits of each alone, and nothing but the outputs is written. */
static void test_dense_shapes(void)
{
    enum { COUNT = 13 };
    static const int shapes[][2] = {{1, 1},     {1, 96},    {3, 2},     {4, 3},     {7, 5},    {8, 97},
                                    {9, 64},    {16, 1},    {17, 33},   {31, 96},   {33, 7},   {63, 95},
                                    {64, 40},   {65, 96},   {96, 384},  {127, 2},   {129, 31}, {200, 11},
                                    {19, 9728}, {5, 16385}, {3, 20000}, {207, 9731}};
    static const int counts[] = {1, 2, 3, 4, 6, 7, COUNT};
    uint64_t state = test_seed + 22;
    size_t k, c;
    int t, level, in_place;
    for (k = 0; k < sizeof shapes / sizeof shapes[0]; ++k)
        for (t = 0; t < 3; ++t) {
            size_t rows = (size_t)shapes[k][0], cols = (size_t)shapes[k][1], i, j, b;
            float *x = (float *)malloc(COUNT * cols * sizeof(float));
            ref_net net;
            net_begin(&net, (ms_nn_dtype)t, 1, (int)cols, 1, 1);
            net_dense(&net, (int)rows, 0);
            net_end(&net, &state);
            for (i = 0; i < COUNT * cols; ++i) x[i] = (float)test_normal(&state);
            for (in_place = 0; in_place < 2; ++in_place)
                for (level = MS_SIMD_SCALAR; level <= test_simd_best(); ++level) {
                    ms_nn *nn = net_load(&net, (ms_simd)level);
                    float *alone = (float *)malloc(COUNT * rows * sizeof(float));
                    if (in_place) inside_in_place(nn);
                    if (ms_nn_simd(nn) == (ms_simd)level)
                        for (b = 0; b < COUNT; ++b) {
                            CHECK_INT(ms_nn_forward(nn, 1, x + b * cols, alone + b * rows, NULL), MS_OK);
                            for (i = 0; i<rows; i += rows * cols> 1000000 ? 13 : 1) {
                                double sum = net.layer[0].b[i], size = fabs(sum);
                                for (j = 0; j < cols; ++j) {
                                    double product = net.layer[0].w[i * cols + j] * (double)x[b * cols + j];
                                    sum += product;
                                    size += fabs(product);
                                }
                                CHECK_NEAR(alone[b * rows + i], sum, (double)(cols + 4) * 5.97e-8 * size);
                            }
                        }
                    if (ms_nn_simd(nn) == (ms_simd)level && rows * cols < 20000) {
                        float *jacobian = (float *)malloc(rows * cols * sizeof(float));
                        CHECK_INT(ms_nn_jacobian(nn, x, NULL, jacobian, NULL), MS_OK);
                        for (i = 0; i < rows * cols; ++i) /* scales round once */
                            CHECK_NEAR(jacobian[i], net.layer[0].w[i], 1.2e-7 * fabs(net.layer[0].w[i]));
                        free(jacobian);
                    }
                    for (c = 0; ms_nn_simd(nn) == (ms_simd)level && c < sizeof counts / sizeof counts[0]; ++c) {
                        size_t n = (size_t)counts[c];
                        float *y = (float *)malloc((n * rows + 1) * sizeof(float)),
                              *xc = (float *)malloc(n * cols * sizeof(float)); /* to their ends, for sanitizers */
                        memcpy(xc, x, n * cols * sizeof(float));
                        y[n * rows] = 7;
                        CHECK_INT(ms_nn_forward(nn, counts[c], xc, y, NULL), MS_OK);
                        CHECK_INT(memcmp(y, alone, n * rows * sizeof(float)), 0);
                        CHECK(y[n * rows] == 7);
                        free(y);
                        free(xc);
                    }
                    free(alone);
                    ms_nn_destroy(nn);
                }
            free(x);
            net_free(&net);
        }
}

/* Half floats are the same where the host flushes subnormal floats to zero, at every level, reading and writing. */
static void test_flush_to_zero(void)
{
#if defined(TEST_X64)
    unsigned h, state = _mm_getcsr();
    int simd;
    uint64_t seed = test_seed + 30;
    ref_net net;
    float x[100], y[2][7];
    int i, flush;
    for (h = 0; h < 65536; ++h) {
        double exact = (h & 0x7c00) ? ldexp((double)(1024 + (h & 1023)), (int)(h >> 10 & 31) - 25)
                                    : ldexp((double)(h & 1023), -24);
        uint16_t back;
        float value;
        _mm_setcsr(state | 0x8040);
        value = inside_half_to_float((uint16_t)h);
        back = inside_half_from_float(value);
        _mm_setcsr(state);
        if ((h & 0x7c00) == 0x7c00) {
            CHECK((h & 1023) ? value != value : value > 1e38f || value < -1e38f);
        } else {
            CHECK((double)value == (h & 0x8000 ? -exact : exact));
            CHECK_INT(back, h);
        }
    }
    { /* halfway cases go to even, also into and out of the subnormals; a finite value stays finite */
        static const struct {
            double units;
            int bits;
        } cases[] = {{0.5, 0},
                     {0.75, 1},
                     {1.5, 2},
                     {2.5, 2},
                     {1022.5, 0x3fe},
                     {1023.5, 0x400},
                     {1023.75, 0x400},
                     {16777216 * 1.00048828125, 0x3c00},
                     {16777216 * 1.00146484375, 0x3c02},
                     {16777216 * 65519.0, 0x7bff},
                     {16777216 * 65520.0, 0x7bff},
                     {1e20, 0x7bff},
                     {1e-20, 0}};
        for (i = 0; i < (int)(sizeof cases / sizeof cases[0]); ++i)
            CHECK_INT(inside_half_from_float(-(float)ldexp(cases[i].units, -24)), cases[i].bits | 0x8000);
    }
    net_begin(&net, MS_NN_F16, 1, 100, 1, 1); /* weights of 0.1 / 100 and less: many are subnormal */
    net_dense(&net, 7, 3);
    net_end(&net, &seed);
    for (i = 0; i + 1 < 1400; i += 2) net.file[net.size - 28 - 1400 + (size_t)i + 1] &= 0x83; /* exponents 0 */
    for (i = 0; i < 100; ++i) x[i] = 1000 * (float)test_normal(&seed);
    for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
        ms_nn *nn = net_load(&net, (ms_simd)simd);
        for (flush = 0; flush < 2 && nn; ++flush) {
            if (flush) _mm_setcsr(state | 0x8040);
            ms_nn_forward(nn, 1, x, y[flush], NULL);
            _mm_setcsr(state);
        }
        CHECK(memcmp(y[0], y[1], sizeof y[0]) == 0);
        ms_nn_destroy(nn);
    }
    net_free(&net);
#else
    SKIP("no control of subnormals on this machine");
#endif
}

typedef struct stack_job {
    const ref_net *net;
    ms_simd simd;
    float *values;
} stack_job;

static void every_product(void *context)
{
    const stack_job *job = (const stack_job *)context;
    ms_nn_options o = ms_nn_defaults();
    ms_nn *nn = NULL;
    ms_nn_collapse *c = NULL;
    float *x = job->values, *y = x + 200000, *out = y + 100000;
    o.simd = job->simd;
    if (ms_nn_load(job->net->file, job->net->size, &o, &nn, NULL) != MS_OK) return;
    ms_nn_forward(nn, 5, x, y, NULL);
    if (ms_nn_input_size(nn) * ms_nn_output_size(nn) < 100000) ms_nn_jacobian(nn, x, NULL, out, NULL);
    ms_nn_check_weights(nn, NULL);
    if (ms_nn_collapse_create(nn, NULL, &c, NULL) == MS_OK) {
        double *residual = (double *)malloc((ms_nn_collapse_features(c) + 1) * (ms_nn_input_size(nn) + 1) *
                                            sizeof(double));
        ms_nn_collapse_target(c, y, NULL);
        ms_nn_collapse_residual(c, x, residual, residual + ms_nn_collapse_features(c) + 1, NULL);
        ms_nn_collapse_destroy(c);
        free(residual);
    }
    ms_nn_destroy(nn);
}

/* The head comment's bound on the stack, for every call, level, type and build. */
static void test_stack_use(void)
{
    stack_job job;
    uint64_t state = test_seed + 31;
    size_t most = 0, used;
    int which, type, simd;
    TEST_METHOD;
    if (TEST_STACK_LIMIT == 0) SKIP("a sanitizer pads the stack");
    job.values = (float *)malloc(400000 * sizeof(float));
    for (which = 0; which < 400000; ++which) job.values[which] = 0.5f;
    for (which = 0; which < NETS; ++which)
        for (type = MS_NN_F32; type <= MS_NN_I8; type += test_full ? 1 : MS_NN_I8 - MS_NN_F32) {
            ref_net net;
            net_make(&net, which, (ms_nn_dtype)type, &state);
            job.net = &net;
            for (simd = test_full ? MS_SIMD_SCALAR : test_simd_best(); simd <= test_simd_best(); ++simd) {
                job.simd = (ms_simd)simd;
                used = test_stack(every_product, &job);
                if (used > most) most = used;
            }
            net_free(&net);
        }
    CHECK_LE((double)most, TEST_STACK_LIMIT);
    TEST_NOTE("%d bytes at most, of %d", (int)most, TEST_STACK_LIMIT);
    free(job.values);
}

/* NULL: a status, or nothing and 0. */
static void test_null(void)
{
    ms_error error;
    float x = 0;
    double value;
    size_t size;
    CHECK(ms_nn_file_tensor_count(NULL) == 0 && ms_nn_file_tensor(NULL, 0) == NULL &&
          ms_nn_file_entry_count(NULL) == 0 && ms_nn_file_entry(NULL, 0) == NULL);
    CHECK(ms_nn_file_find(NULL, "x") == NULL && ms_nn_file_metadata(NULL, "x") == NULL);
    CHECK(ms_nn_input_size(NULL) == 0 && ms_nn_output_size(NULL) == 0 && ms_nn_input_shape(NULL).rank == 0 &&
          ms_nn_output_shape(NULL).rank == 0);
    CHECK(ms_nn_layer_count(NULL) == 0 && ms_nn_layer_at(NULL, 0).type[0] == 0 && ms_nn_tensors(NULL) == NULL &&
          ms_nn_workspace_size(NULL, MS_NN_JACOBIAN, 1) == 0);
    CHECK(ms_nn_simd(NULL) == MS_SIMD_AUTO && ms_nn_collapse_features(NULL) == 0 &&
          ms_nn_collapse_workspace_size(NULL, 1) == 0);
    CHECK_INT(ms_nn_check_weights(NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strcmp(error.message, "nn is NULL") == 0);
    CHECK_INT(ms_nn_load(NULL, 9, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strcmp(error.message, "nn is NULL") == 0);
    CHECK_INT(ms_nn_forward(NULL, 1, &x, &x, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_jacobian(NULL, &x, NULL, &x, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_collapse_create(NULL, NULL, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_collapse_target(NULL, &x, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_collapse_residual(NULL, &x, &value, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_file_write(NULL, 1, NULL, 0, NULL, 0, &size, &error), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_file_write(NULL, 0, NULL, 0, NULL, 0, NULL, &error), MS_INVALID_ARGUMENT);
    CHECK(strcmp(error.message, "size is NULL") == 0);
    ms_nn_destroy(NULL);
    ms_nn_file_close(NULL);
    ms_nn_collapse_destroy(NULL);
}

/* The sum of squares of the residual. */
static double collapse_value(const ms_nn_collapse *c, const float *x)
{
    size_t n = ms_nn_collapse_features(c) + 1, i;
    double *residual = (double *)malloc(n * sizeof(double)), sum = 0;
    CHECK_INT(ms_nn_collapse_residual(c, x, residual, NULL, NULL), MS_OK);
    for (i = 0; i < n; ++i) sum += residual[i] * residual[i];
    free(residual);
    return sum;
}

/* Weights of a mask, also where the columns are nearly dependent: R'R = W'MW, to what is promised of each. */
static void test_collapse_weighted(void)
{
    uint64_t state = test_seed + 40;
    int dependent, k, i, j, a, rows = 3000, h = 37;
    for (dependent = 0; dependent < 2; ++dependent) {
        ref_net net;
        ms_nn *nn;
        ms_nn_collapse *c = NULL;
        float weight[3000], y[3000], x[37], other[37];
        double r2 = 0, value;
        net_begin(&net, MS_NN_F32, 1, h, 1, 1);
        net_dense(&net, rows, 0);
        net_end(&net, &state);
        if (dependent) { /* the last column becomes the sum of two others but for 1e-6 */
            for (i = 0; i < rows; ++i) {
                float v[3];
                memcpy(v, net.file + net.size - 4 * (size_t)rows - 4 * (size_t)(rows - i) * (size_t)h, 8);
                v[2] = v[0] + v[1] * (1 + 1e-6f * (float)(i % 7));
                memcpy(net.file + net.size - 4 * (size_t)rows - 4 * (size_t)(rows - i) * (size_t)h +
                           4 * (size_t)(h - 1),
                       &v[2], 4);
            }
        }
        nn = net_load(&net, MS_SIMD_AUTO);
        for (i = 0; i < rows; ++i) weight[i] = i % 4 == 1 ? 0 : 0.25f + (float)(i % 5);
        CHECK_INT(ms_nn_collapse_create(nn, weight, &c, NULL), MS_OK);
        for (k = 0; k < 5; ++k) {
            for (j = 0; j < h; ++j) x[j] = (float)test_normal(&state);
            for (j = 0; j < h; ++j) other[j] = x[j] + (k == 4 ? 1e-3f : 1) * (float)test_normal(&state);
            ms_nn_forward(nn, 1, x, y, NULL); /* a target that x hits */
            CHECK_INT(ms_nn_collapse_target(c, y, NULL), MS_OK);
            value = collapse_value(c, other);
            r2 = 0;
            for (i = 0; i < rows; ++i) {
                double sum = -(double)y[i], w;
                const unsigned char *at = net.file + net.size - 4 * (size_t)rows - 4 * (size_t)(rows - i) * (size_t)h;
                float f;
                for (a = 0; a < h; ++a) {
                    memcpy(&f, at + 4 * a, 4);
                    sum += (double)f * (double)other[a];
                }
                memcpy(&f, net.file + net.size - 4 * (size_t)(rows - i), 4);
                w = sum + (double)f;
                r2 += (double)weight[i] * w * w;
            }
            /* the target's own rounding to floats stands in both; 1e-8 is what the pivots' bound leaves */
            if (k < 4) CHECK_NEAR(value, r2, 1e-8 * r2);
            else
                CHECK_NEAR(
                    value, r2,
                    dependent
                        ? 1e-6 * r2
                        : 1e-8 * r2); /* a residual of 1e-3 of the target's: what the nearly dependent column cancels */
        }
        ms_nn_collapse_destroy(c);
        ms_nn_destroy(nn);
        net_free(&net);
    }
}

/* A network by name goes on when its file is cut to nothing under it. */
static void test_copy(void)
{
    static const char *const path = "build/test_nn_copy.safetensors";
    uint64_t state = test_seed + 32;
    ref_net net;
    ms_nn *nn = NULL;
    float x[50] = {0}, y[2][3000];
    FILE *f;
    net_begin(&net, MS_NN_F32, 1, 50, 1, 1);
    net_dense(&net, 3000, 1);
    net_end(&net, &state);
    f = fopen(path, "wb");
    if (f == NULL) SKIP("cannot write %s", path);
    fwrite(net.file, 1, net.size, f);
    fclose(f);
    x[7] = 1;
    CHECK_INT(ms_nn_load_file(path, NULL, &nn, NULL), MS_OK);
    ms_nn_forward(nn, 1, x, y[0], NULL);
    f = fopen(path, "wb"); /* as an editor's save begins */
    fclose(f);
    ms_nn_forward(nn, 1, x, y[1], NULL);
    CHECK(memcmp(y[0], y[1], sizeof y[0]) == 0);
    ms_nn_destroy(nn);
    remove(path);
    net_free(&net);
}

/* Directions against finite differences of the double reference, and the Jacobian against them. */
static void test_products(void)
{
    uint64_t state = test_seed + 11;
    double worst = 0;
    int which, i, k;
    for (which = 0; which < NETS; ++which) {
        ref_net net;
        ref_run low, high;
        ms_nn *nn;
        int n, m;
        float *x, *dx, *y, *dy, *jacobian = NULL;
        double *t, step = 1e-6, a = 0, b = 0, size = 0;
        net_make(&net, which, MS_NN_F32, &state);
        nn = net_load(&net, MS_SIMD_AUTO);
        n = (int)ms_nn_input_size(nn);
        m = (int)ms_nn_output_size(nn);
        x = (float *)malloc((size_t)(2 * n + 2 * m) * sizeof(float));
        dx = x + n;
        y = dx + n;
        dy = y + m;
        t = (double *)malloc((size_t)n * sizeof(double));
        for (i = 0; i < n; ++i) x[i] = (float)test_normal(&state);
        for (i = 0; i < n; ++i) dx[i] = (float)test_normal(&state);
        net_directions(nn, 1, x, dx, dy);
        /* central differences: error about step^2 + 1e-16 / step = 1e-10, kinks aside, which 1e-6 hardly meets */
        for (i = 0; i < n; ++i) t[i] = (double)x[i] - step * (double)dx[i];
        ref_forward(&net, t, &low);
        for (i = 0; i < n; ++i) t[i] = (double)x[i] + step * (double)dx[i];
        ref_forward(&net, t, &high);
        for (i = 0; i < m; ++i) {
            double slope = (high.value[net.layers][i] - low.value[net.layers][i]) / (2 * step),
                   e = fabs(slope - (double)dy[i]);
            if (e > a) a = e;
            if (fabs(slope) > size) size = fabs(slope);
        }
        CHECK_LE(a / size, 1e-5);
        if (a / size > worst) worst = a / size;
        ref_free_run(&net, &low);
        ref_free_run(&net, &high);
        if ((double)n * m < 2e6) {
            jacobian = (float *)malloc((size_t)n * (size_t)m * sizeof(float));
            CHECK_INT(ms_nn_jacobian(nn, x, y, jacobian, NULL), MS_OK);
            for (i = 0; i < m; ++i) {
                double sum = 0, e;
                for (k = 0; k < n; ++k) sum += (double)jacobian[i * n + k] * (double)dx[k];
                e = fabs(sum - (double)dy[i]);
                if (e > b) b = e;
            }
            CHECK_LE(b / size, 1e-5);
            free(jacobian);
        }
        free(t);
        free(x);
        ms_nn_destroy(nn);
        net_free(&net);
    }
    TEST_NOTE("largest distance from differences %.1e", worst);
}

/* Relative errors of the activations over their range, and what they do at the ends. */
static void test_activations(void)
{
    static const char *const acts[] = {"linear", "relu", "leaky_relu", "elu", "tanh", "sigmoid", "softplus"};
    int act, simd, i;
    double worst = 0;
    for (act = 0; act < 7; ++act)
        for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
            enum { N = 4003 };
            static float x[N], y[N], g[N];
            ref_net file;
            ms_nn *nn = net_activation(&file, acts[act], 1.5, N, (ms_simd)simd);
            for (i = 0; i < N; ++i) x[i] = (float)((i - 2000) * 0.02);
            x[4000] = -1e30f;
            x[4001] = 1e30f;
            x[4002] = -1e-20f;
            for (i = 0; i < 50; ++i) x[i] = (float)ldexp(-1, -i); /* small values keep their relative precision */
            CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
            for (i = 0; i < N; ++i) g[i] = 1;
            inside_activate(nn, x, g, N);
            for (i = 0; i < N; ++i) {
                double v = ref_act(act, 1.5, (double)x[i]), s = ref_slope(act, 1.5, (double)x[i]);
                double d = fabs((double)y[i] - v) / (fabs(v) + 1e-30); /* exponents end at -87 */
                if (d > worst) worst = d;
                CHECK_LE(d, 4e-7);                         /* about 3 ulp */
                CHECK_NEAR(g[i], s, 4e-7 * (1 + fabs(s))); /* the reference has no more */
            }
            x[0] = 0;
            x[1] = 3.4e38f; /* finite, the largest: no activation overflows on the way */
            x[2] = act == 2 ? -2e38f : -3.4e38f;
            CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
            CHECK(act == 4 || act == 5 ? y[1] == 1 : y[1] >= x[1]);
            if (test_unmasked()) {
                ms_nn_destroy(nn);
                free(file.file);
                continue;
            }
            x[0] = (float)NAN;
            x[1] = (float)INFINITY;
            x[2] = -(float)INFINITY;
            CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
            CHECK(y[0] != y[0]);
            CHECK(act == 4 || act == 5 ? y[1] == 1 : y[1] > 3e38f);
            CHECK((double)y[2] ==
                      (act == 1 || act == 5 || act == 6 ? (double)y[2]
                           : act == 3                   ? -1.5
                           : act == 4                   ? -1.0
                                                        : (double)-(float)INFINITY) &&
                  y[2] <= 1e-30f);
            ms_nn_destroy(nn);
            free(file.file);
        }
    TEST_NOTE("largest relative error %.1e", worst);
}

/* Swapping the inputs of red and green swaps the output channels, bit for bit; products as without sharing. */
static void test_shared(void)
{
    uint64_t state = test_seed + 2, again = state;
    ref_net net, plain;
    ms_nn *nn, *single;
    size_t i, k;
    float x[7], swapped[7], y[3 * 40], z[3 * 40], slopes[40 * 3], jacobian[3 * 40 * 7], ws_x[3];
    net_begin(&plain, MS_NN_F16, 1, 3, 1, 1);
    net_dense(&plain, 25, 3);
    net_dense(&plain, 40, 5);
    net = plain;
    net.shared = "[[0,3,6],[1,4,6],[2,5,6]]";
    net.outer = 7;
    net_end(&plain, &again);
    net_end(&net, &state);
    single = net_load(&plain, MS_SIMD_AUTO);
    nn = net_load(&net, MS_SIMD_AUTO);
    CHECK_INT(ms_nn_input_size(nn), 7);
    CHECK_INT(ms_nn_output_size(nn), 120);
    CHECK_INT(ms_nn_output_shape(nn).rank, 2);
    CHECK_INT(ms_nn_output_shape(nn).size[0], 3);
    CHECK_INT(ms_nn_output_shape(nn).size[1], 40);
    for (i = 0; i < 7; ++i) x[i] = swapped[i] = (float)test_uniform(&state);
    swapped[0] = x[1];
    swapped[1] = x[0];
    swapped[3] = x[4];
    swapped[4] = x[3];
    CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
    CHECK_INT(ms_nn_forward(nn, 1, swapped, z, NULL), MS_OK);
    CHECK(memcmp(y, z + 40, 40 * sizeof(float)) == 0 && memcmp(y + 40, z, 40 * sizeof(float)) == 0 &&
          memcmp(y + 80, z + 80, 40 * sizeof(float)) == 0);
    CHECK_INT(ms_nn_jacobian(nn, x, NULL, jacobian, NULL), MS_OK);
    for (k = 0; k < 3; ++k) {
        ws_x[0] = x[k];
        ws_x[1] = x[3 + k];
        ws_x[2] = x[6];
        CHECK_INT(ms_nn_forward(single, 1, ws_x, z, NULL), MS_OK);
        CHECK_INT(memcmp(z, y + 40 * k, 40 * sizeof(float)), 0);
        CHECK_INT(ms_nn_jacobian(single, ws_x, NULL, slopes, NULL), MS_OK);
        for (i = 0; i < 40 * 7; ++i) { /* of the three inputs that the channel sees, 0 of the others */
            size_t input = i % 7, own = input == k ? 0 : input == 3 + k ? 1 : input == 6 ? 2 : 3;
            CHECK((double)jacobian[40 * 7 * k + i] == (own < 3 ? (double)slopes[i / 7 * 3 + own] : 0.0));
        }
    }
    CHECK(fabs((double)jacobian[1]) <= 0.0 && fabs((double)jacobian[0]) > 0); /* red does not see green */
    ms_nn_destroy(nn);
    ms_nn_destroy(single);
    net_free(&net);
    net_free(&plain);
}

/* Files whose data lies at any offset of memory, and weights behind an odd number of bytes. */
static void test_unaligned(void)
{
    uint64_t state = test_seed;
    int type, offset, simd;
    for (type = (int)MS_NN_F32; type <= (int)MS_NN_I8; ++type)
        for (offset = 1; offset < 8; offset += 2)
            for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
                ref_net net;
                unsigned char *b;
                ms_nn *nn, *moved = NULL;
                ms_nn_options o = ms_nn_defaults();
                float x[37], y[98], z[98], *g = (float *)malloc(2 * 98 * 37 * sizeof(float)), *h = g + 98 * 37;
                int i;
                net_make(&net, 0, (ms_nn_dtype)type, &state);
                b = (unsigned char *)malloc(net.size + 8);
                memcpy(b + offset, net.file, net.size);
                for (i = 0; i < 37; ++i) x[i] = (float)test_normal(&state);
                nn = net_load(&net, (ms_simd)simd);
                o.simd = (ms_simd)simd;
                CHECK_INT(ms_nn_load(b + offset, net.size, &o, &moved, NULL), MS_OK);
                CHECK_INT(ms_nn_output_size(nn), 98);
                ms_nn_forward(nn, 1, x, y, NULL);
                ms_nn_forward(moved, 1, x, z, NULL);
                CHECK_INT(memcmp(y, z, sizeof y), 0);
                ms_nn_jacobian(nn, x, NULL, g, NULL);
                ms_nn_jacobian(moved, x, NULL, h, NULL);
                CHECK_INT(memcmp(g, h, 98 * 37 * sizeof(float)), 0);
                free(g);
                ms_nn_destroy(nn);
                ms_nn_destroy(moved);
                free(b);
                net_free(&net);
            }
}

/* Non-finite weights: reported on request, run otherwise, and kept to their own output. */
static void test_not_finite(void)
{
    static const ms_nn_dtype types[2] = {MS_NN_F32, MS_NN_F16};
    uint64_t state = test_seed;
    int type, simd;
    for (type = 0; type < 2; ++type)
        for (simd = MS_SIMD_SCALAR; simd <= test_simd_best(); ++simd) {
            ref_net net;
            ms_nn *nn;
            ms_error error;
            float x[37], y[40];
            const ms_nn_tensor *w;
            unsigned char *p;
            int i;
            net_begin(&net, types[type], 1, 37, 1, 1);
            net_dense(&net, 40, 0);
            net_end(&net, &state);
            nn = net_load(&net, (ms_simd)simd);
            CHECK_INT(ms_nn_check_weights(nn, &error), MS_OK);
            w = ms_nn_file_find(ms_nn_tensors(nn), "l0.weight");
            p = (unsigned char *)(uintptr_t)w->data;
            if (type == 0) memcpy(p + 4 * (5 * 37 + 2), "\0\0\xc0\x7f", 4); /* NaN in row 5 */
            else memcpy(p + 2 * (5 * 37 + 2), "\0\x7e", 2);
            ms_nn_destroy(nn); /* big-endian hosts copy weights when they load */
            nn = net_load(&net, (ms_simd)simd);
            CHECK_INT(ms_nn_check_weights(nn, &error), MS_BAD_DATA);
            CHECK_INT(error.position, 5 * 37 + 2);
            CHECK(strstr(error.message, "l0.weight") != NULL);
            for (i = 0; i < 37; ++i) x[i] = 1;
            if (!test_unmasked()) {
                CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
                for (i = 0; i < 40; ++i) CHECK((y[i] != y[i]) == (i == 5));
            }
            ms_nn_destroy(nn);
            net_free(&net);
        }
    /* an input that is not finite, before I8 weights and in pools */
    for (simd = MS_SIMD_SCALAR; simd <= test_simd_best() && !test_unmasked(); ++simd) {
        ref_net net;
        ms_nn *nn;
        float x[5 * 15 * 37], y[7];
        int i;
        net_make(&net, 6, MS_NN_I8, &state);
        nn = net_load(&net, (ms_simd)simd);
        for (i = 0; i < 5 * 15 * 37; ++i) x[i] = (float)i;
        x[77] = (float)NAN;
        CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
        for (i = 0; i < 7; ++i) CHECK(y[i] != y[i]);
        ms_nn_destroy(nn);
        net_free(&net);
    }
}

/* Layer lists that must be refused, with what the message speaks of. */
static void test_refused(void)
{
    static const char *const list[][3] = {
        {"[5]", "[{\"type\":\"dense\",\"name\":\"x\",\"units\":3}]", "there is no tensor"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"units\":8}]", "dimension 0"},
        {"[4]", "[{\"type\":\"dense\",\"name\":\"f\",\"units\":7}]", "dimension 1"},
        {"[5]", "[{\"type\":\"dense\",\"units\":7}]", "no name"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"activation\":\"swish\"}]", "unknown activation"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"activation\":\"elu\",\"alpha\":-1}]", "from 0 on"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"bias\":false}]", "bias"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"units\":7,\"units\":7}]", "twice"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"stride\":1}]", "does not belong"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"units\":0}]", "not be 0"},
        {"[5]", "[{\"type\":\"gru\"}]", "type"},
        {"[5]", "[{\"name\":\"f\"}]", "type"},
        {"[5]", "[{\"type\":\"dropout\",\"rate\":1}]", "below 1"},
        {"[5]", "[{\"type\":\"conv1d\",\"name\":\"f\"}]", "channels, length"},
        {"[5]", "[{}]", "the layer has no type"},
        {"[1,5]", "[{\"type\":\"dense\",\"name\":\"f\"}]", "flatten"},
        {"[1,1]", "[{\"type\":\"maxpool1d\",\"size\":2}]", "takes 2"},
        {"[3,1,9]", "[{\"type\":\"maxpool2d\",\"size\":2}]", "takes 2"},
        {"[3,5]", "[{\"type\":\"flatten\",\"order\":\"rows\"}]", "channels_first"},
        {"[5]", "[{\"type\":\"add\",\"from\":\"nobody\"}]", "nobody"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\"},{\"type\":\"add\",\"from\":\"input\"}]", "another shape"},
        {"[5]", "[{\"type\":\"shared_channels\",\"inputs\":[[0],[5]]}]", "it names input"},
        {"[5]", "[{\"type\":\"shared_channels\",\"inputs\":[[0],[1,2]]}]", "equally many"},
        {"[5]", "[{\"type\":\"dropout\"},{\"type\":\"shared_channels\",\"inputs\":[[0]]}]", "first layer"},
        {"[5]", "[{\"type\":\"shared_channels\"}]", "no inputs"},
        {"[5]", "[{\"type\":\"upsample1d\",\"factor\":2},]", "object"},
        {"[5]", "{}", "list"},
        {"[5]", "[{\"type\":\"dropout\"}] []", "follows"},
        {"[5]", "[]", "empty"},
        {"[0]", "[]", "is 0"},
        {"[4294967295,4294967295,9]", "[]", "too large"},
        {"[1,2,3,4]", "[]", "three"},
        {"[1", "[]", "expected"},
        {"5", "[]", "list"},
        {"[2,3]", "[{\"type\":\"upsample1d\",\"factor\":9223372036854775807}]", "too large"},
        {"[5]", "[{\"type\":\"dropout\",\"rate\":1e99999}]", "above 1e30"},
        {"[5]", "[{\"type\":\"globalpool\"}]", "channels"},
        {"[2,5]", "[{\"type\":\"conv1d\",\"name\":\"f\",\"padding\":\"same\",\"zeros\":1}]", "exclude"},
        {"[2,5]", "[{\"type\":\"conv1d\",\"name\":\"f\",\"zeros\":3000000000}]", "too large"},
        {"[2,5]", "[{\"type\":\"conv1d\",\"name\":\"d\",\"groups\":2}]", "unknown field"},
        {"[2,5]", "[{\"type\":\"conv1d_transpose\",\"name\":\"d\"}]", "unknown type"},
        {"[2,5]", "[{\"type\":\"maxpool1d\",\"size\":[2,3]}]", "one number"},
        {"[2,5]", "[{\"stride\":[2,3],\"type\":\"maxpool1d\"}]", "one number"},
        {"[2,5]", "[{\"type\":\"upsample1d\",\"factor\":[2,2]}]", "one number"},
        {"[2,5]", "[{\"type\":\"conv1d\",\"name\":\"f\",\"kernel\":[3,1]}]", "one number"},
        {"[2,5]", "[{\"type\":\"conv1d\",\"name\":\"f\",\"zeros\":[0,1]}]", "one number"},
        {"[2,5,5]", "[{\"type\":\"conv2d\",\"name\":\"f\",\"filters\":[2,2]}]", "one number"},
        {"[5]", "[{\"type\":\"dense\",\"name\":\"f\",\"units\":[7,7]}]", "one number"},
        {"[2,2,2]", "[{\"type\":\"flatten\",\"order\":\"channels_last\"},{\"type\":\"add\",\"from\":\"input\"}]",
         "another shape"},
        {"[1,4]",
         "[{\"type\":\"upsample1d\"},{\"type\":\"dropout\",\"name\":\"d\"},{\"type\":\"maxpool1d\"},{\"type\":\"add\",\"from\":\"d\"}]",
         "another shape"},
        {"[5]", "[{\"type\":\"shared_channels\",\"inputs\":[[0]],\"inputs\":[[0]]}]", "twice"},
        {"[5]", "[{\"type\":\"dropout\",\"rate\":\"x\"}]", "number"}};
    static const float taps[14] = {0};
    static const size_t taps_shape[3] = {7, 1, 2}, one[1] = {1}, seven[1] = {7};
    ms_nn_file *f = NULL;
    ms_nn_tensor t[6] = {{NULL, MS_NN_F32, 0, NULL, NULL, 0},
                         {NULL, MS_NN_F32, 0, NULL, NULL, 0},
                         {"c.weight", MS_NN_F32, 3, taps_shape, taps, sizeof taps},
                         {"c.bias", MS_NN_F32, 1, one, taps, 4},
                         {"d.weight", MS_NN_F32, 3, taps_shape, taps, sizeof taps},
                         {"d.bias", MS_NN_F32, 1, seven, taps, 28}};
    size_t i;
    CHECK_INT(ms_nn_file_read("tests/data/nn/act_elu.safetensors", NULL, &f, NULL), MS_OK);
    t[0] = *ms_nn_file_tensor(f, 0);
    t[1] = *ms_nn_file_tensor(f, 1);
    for (i = 0; i < sizeof list / sizeof list[0]; ++i) {
        ref_net net;
        ms_nn_entry e[4];
        ms_nn *nn = NULL;
        ms_error error;
        ms_status status;
        memset(&net, 0, sizeof net);
        memset(&error, 0, sizeof error);
        e[0].key = "ms_nn_version";
        e[0].value = "1";
        e[1].key = "ms_nn_input";
        e[1].value = list[i][0];
        e[2].key = "ms_nn_layers";
        e[2].value = list[i][1];
        net_write(&net, t, 6, e, 3);
        status = ms_nn_load(net.file, net.size, NULL, &nn, &error);
        if (status != MS_BAD_DATA || nn != NULL || strstr(error.message, list[i][2]) == NULL)
            TEST_FAIL("%s %s: status %d: %s", list[i][0], list[i][1], (int)status, error.message);
        if (list[i][0][0] == '[' && list[i][0][1] == '5' && list[i][1][0] == '[' && list[i][1][1] == '{' &&
            strstr(error.message, "(layer ") == NULL && strstr(list[i][2], "empty") == NULL &&
            strstr(list[i][2], "follows") == NULL)
            TEST_FAIL("no layer is named: %s", error.message);
        ms_nn_destroy(nn);
        if (i < 2) { /* versions and formats of others */
            e[0].value = i ? "1" : "2";
            e[3].key = "format";
            e[3].value = i ? "tf" : "pt";
            net_write(&net, t, 6, e, 4);
            CHECK_INT(ms_nn_load(net.file, net.size, NULL, &nn, &error), MS_UNSUPPORTED);
        }
        free(net.file);
    }
    ms_nn_file_close(f);
    TEST_NOTE("%d layer lists", (int)i);
}

/* At most 16 MB a block: a file may ask for any size. */
static void *at_most_16_mb(void *user, size_t size)
{
    (void)user;
    return size <= (size_t)1 << 24 ? malloc(size) : NULL;
}

static void give_back(void *user, void *pointer, size_t size)
{
    (void)user;
    (void)size;
    free(pointer);
}

/* A size of the whole range that the grammar allows, more often a small one, one beside a power of two, or one whose
   multiple by 3 to 7 is beside 2^32. */
static uint32_t any_size(uint64_t *state)
{
    const uint32_t power = (uint32_t)1 << (int)(31 * test_uniform(state));
    if (test_uniform(state) < 0.5) return 1 + (uint32_t)(4 * test_uniform(state));
    if (test_uniform(state) < 0.3)
        return 0xffffffffu / (3 + (uint32_t)(5 * test_uniform(state))) + (uint32_t)(3 * test_uniform(state));
    return test_uniform(state) < 0.7 ? (power > 1 ? power - 1 : 1) + (uint32_t)(3 * test_uniform(state))
                                     : 1 + (uint32_t)(2147483646 * test_uniform(state));
}

/* Layers of any sizes are refused, or run inside of their workspace: nothing behind it and behind the outputs is
   written. On 32 bits the products of these sizes wrap. */
static void test_any_sizes(void)
{
    static const float weight[16] = {1, 2, 3, 4}, bias[2] = {0};
    static const size_t square[4] = {1, 1, 3, 2}, line[3] = {1, 1, 3}, one[1] = {1}, matrix[2] = {2, 4}, two[1] = {2};
    const ms_nn_tensor tensors[6] = {
        {"c.weight", MS_NN_F32, 4, square, weight, 24}, {"c.bias", MS_NN_F32, 1, one, bias, 4},
        {"s.weight", MS_NN_F32, 3, line, weight, 12},   {"s.bias", MS_NN_F32, 1, one, bias, 4},
        {"d.weight", MS_NN_F32, 2, matrix, weight, 32}, {"d.bias", MS_NN_F32, 1, two, bias, 8}};
    ms_nn_options o = ms_nn_defaults();
    ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", NULL}, {"ms_nn_layers", NULL}};
    uint64_t state = test_seed + 60;
    int k, ran = 0, loaded = 0, total = test_full ? 200000 : test_build ? 8000 : 20000;
    o.allocator.alloc = at_most_16_mb;
    o.allocator.release = give_back;
    o.simd = MS_SIMD_SCALAR;
    for (k = 0; k < total; ++k) {
        char input[80], layers[1000] = "[";
        int rank = 1 + (int)(3 * test_uniform(&state)), count = 1 + (int)(3 * test_uniform(&state)), i;
        unsigned char file[2048], *workspace;
        size_t size, need, in, out, at = 1;
        ms_nn *nn = NULL;
        ms_error error;
        float *x;
        if (rank == 1) snprintf(input, sizeof input, "[%lu]", (unsigned long)any_size(&state));
        if (rank == 2) snprintf(input, sizeof input, "[1,%lu]", (unsigned long)any_size(&state));
        if (rank == 3)
            snprintf(input, sizeof input, "[1,%lu,%lu]", (unsigned long)any_size(&state),
                     (unsigned long)any_size(&state));
        if (rank == 1 && test_uniform(&state) < 0.3) /* as many channels as the list names */
            at += (size_t)snprintf(layers + at, sizeof layers - at,
                                   "{\"type\":\"shared_channels\",\"inputs\":[[0,0,0,0],[0,0,0,0]]},");
        for (i = 0; i < count; ++i) {
            const unsigned long a = any_size(&state), b = any_size(&state), c = any_size(&state), d = any_size(&state);
            const int which = (int)(6 * test_uniform(&state));
            at += (size_t)snprintf(layers + at, sizeof layers - at, i ? "," : "");
            if (which == 0)
                at += (size_t)snprintf(layers + at, sizeof layers - at,
                                       "{\"type\":\"dense\",\"name\":\"d\",\"activation\":\"silu\"}");
            else if (which == 1 && rank == 2)
                at += (size_t)snprintf(layers + at, sizeof layers - at,
                                       "{\"type\":\"conv1d\",\"name\":\"s\",\"stride\":%lu,\"zeros\":%lu}", a, b - 1);
            else if (which == 1)
                at += (size_t)snprintf(layers + at, sizeof layers - at,
                                       "{\"type\":\"conv2d\",\"name\":\"c\",\"stride\":[%lu,%lu],\"zeros\":[%lu,%lu]}",
                                       a, b, c - 1, d - 1);
            else if (which == 2)
                at += (size_t)snprintf(layers + at, sizeof layers - at,
                                       rank == 2 ? "{\"type\":\"upsample1d\",\"factor\":%lu}"
                                                 : "{\"type\":\"upsample2d\",\"factor\":[%lu,%lu]}",
                                       a, b);
            else if (which == 3)
                at += (size_t)snprintf(layers + at, sizeof layers - at,
                                       rank == 2 ? "{\"type\":\"maxpool1d\",\"size\":%lu,\"stride\":%lu}"
                                                 : "{\"type\":\"avgpool2d\",\"size\":[%lu,%lu],\"stride\":[%lu,%lu]}",
                                       a, b, c, d);
            else if (which == 4) at += (size_t)snprintf(layers + at, sizeof layers - at, "{\"type\":\"flatten\"}");
            else at += (size_t)snprintf(layers + at, sizeof layers - at, "{\"type\":\"dropout\"}");
        }
        snprintf(layers + at, sizeof layers - at, "]");
        e[1].value = input;
        e[2].value = layers;
        CHECK_INT(ms_nn_file_write(tensors, 6, e, 3, file, sizeof file, &size, &error), MS_OK);
        if (ms_nn_load(file, size, &o, &nn, &error) != MS_OK) continue;
        ++loaded;
        in = ms_nn_input_size(nn);
        out = ms_nn_output_size(nn);
        need = ms_nn_workspace_size(nn, MS_NN_FORWARD, 1);
        if (need <= (size_t)1 << 22 && in <= (size_t)1 << 20 && out <= (size_t)1 << 20) {
            workspace = (unsigned char *)malloc(need + 64);
            x = (float *)calloc(in + out + 64, sizeof(float));
            for (i = 0; i < 64; ++i) x[in + out + (size_t)i] = 7;
            memset(workspace + need, 0x5a, 64);
            CHECK_INT(ms_nn_forward(nn, 1, x, x + in, workspace), MS_OK);
            for (i = 0; i < 64; ++i) CHECK(workspace[need + (size_t)i] == 0x5a && (int)x[in + out + (size_t)i] == 7);
            free(workspace);
            free(x);
            ++ran;
        }
        ms_nn_destroy(nn);
    }
    CHECK(ran > total / 50);
    TEST_NOTE("%d layer lists: %d loaded, %d run", total, loaded, ran);
}

/* A network of one dense layer of that name whose bias has a wrong shape; the error of its load. */
static ms_error error_of_name(const char *name, ms_status expected)
{
    static const float weight[6] = {1, 2, 3, 4, 5, 6};
    static const size_t shape[2] = {2, 3}, wrong[1] = {3};
    static char layers[900], names[2][600];
    static unsigned char file[4096];
    ms_nn_tensor t[2] = {{names[0], MS_NN_F32, 2, shape, weight, 24}, {names[1], MS_NN_F32, 1, wrong, weight, 12}};
    ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[3]"}, {"ms_nn_layers", layers}};
    ms_nn *nn = NULL;
    size_t size;
    ms_error error;
    snprintf(names[0], sizeof names[0], "%s.weight", name);
    snprintf(names[1], sizeof names[1], "%s.bias", name);
    snprintf(layers, sizeof layers, "[{\"type\":\"dense\",\"name\":\"%s\"}]", name);
    memset(&error, 0, sizeof error);
    CHECK_INT(ms_nn_file_write(t, 2, e, 3, file, sizeof file, &size, &error), MS_OK);
    CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error), expected);
    return error;
}

/* Whatever the length of a name, an error begins with its reason. */
static void test_long_names(void)
{
    char name[400];
    int n;
    for (n = 1; n < 400; n += n < 20 ? 1 : 7) {
        ms_error error;
        memset(name, 'a', sizeof name);
        name[n] = 0;
        error = error_of_name(name, MS_BAD_DATA);
        if (strncmp(error.message,
                    n <= MS_NN_MAX_NAME ? "dimension 0 is 3, the layer list makes it 2" : "its name has over 240", 20))
            TEST_FAIL("a name of %d bytes: %s", n, error.message);
    }
}

/* A stride beyond the input takes no step, and no memory for one; a dimension of 0 is named. */
static void test_stride_without_step(void)
{
    static const float weight[3] = {1, 2, 4}, x[5] = {1, 10, 100, 1000, 10000};
    static const char layers[] = "[{\"type\":\"conv1d\",\"name\":\"c\",\"stride\":2147483647,\"bias\":false}]";
    size_t shape[3] = {1, 1, 3}, size;
    ms_nn_tensor t = {"c.weight", MS_NN_F32, 3, NULL, NULL, sizeof weight};
    const ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[1,5]"}, {"ms_nn_layers", layers}};
    unsigned char file[1024];
    float y = 0;
    ms_nn *nn = NULL;
    ms_error error;
    t.shape = shape;
    t.data = weight;
    CHECK_INT(ms_nn_file_write(&t, 1, e, 3, file, sizeof file, &size, &error), MS_OK);
    CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error), MS_OK);
    CHECK_LE((double)ms_nn_workspace_size(nn, MS_NN_FORWARD, 1), 10000.0);
    CHECK_INT(ms_nn_output_size(nn), 1);
    if (!test_failures) CHECK_INT(ms_nn_forward(nn, 1, x, &y, NULL), MS_OK);
    if (!test_failures) CHECK_NEAR((double)y, 421, 0);
    ms_nn_destroy(nn);
    shape[2] = t.bytes = 0;
    CHECK_INT(ms_nn_file_write(&t, 1, e, 3, file, sizeof file, &size, &error), MS_OK);
    CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error), MS_BAD_DATA);
    CHECK(strncmp(error.message, "dimension 2 is 0:", 17) == 0);
}

/* A network of layers that have no weights, `layer` being one of them, on an input of [1][16]; the status of its load. */
static ms_status load_many(const char *layer, int count, ms_error *error)
{
    const size_t length = strlen(layer) + 1, room = (size_t)count * length + 1000;
    char *layers = (char *)malloc(room);
    unsigned char *file = (unsigned char *)malloc(2 * room); /* quotes are escaped */
    ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[1,16]"}, {"ms_nn_layers", layers}};
    ms_nn *nn = NULL;
    ms_status status;
    size_t size, at = 0;
    int i;
    for (i = 0; i < count; ++i) at += (size_t)snprintf(layers + at, room - at, "%c%s", i ? ',' : '[', layer);
    snprintf(layers + at, room - at, "]");
    CHECK_INT(ms_nn_file_write(NULL, 0, e, 3, file, 2 * room, &size, error), MS_OK);
    status = ms_nn_load(file, size, NULL, &nn, error);
    ms_nn_destroy(nn);
    free(layers);
    free(file);
    return status;
}

/* What the head comment says of counts: allocations of a file and of a network, layers of a list, padded sizes. */
static void test_counts(void)
{
    uint64_t state = test_seed + 61;
    ms_error error;
    int which, i;
    long most = 0;
    for (which = 0; which < NETS; ++which) {
        ms_nn_options o = ms_nn_defaults();
        ms_nn_file *file = NULL;
        ms_nn *nn = NULL;
        test_memory memory;
        ref_net net;
        long weighted = 0;
        net_make(&net, which, MS_NN_F16, &state);
        memset(&memory, 0, sizeof memory);
        o.allocator.user = &memory;
        o.allocator.alloc = test_memory_alloc;
        o.allocator.release = test_memory_release;
        CHECK_INT(ms_nn_file_open(net.file, net.size, &o, &file, NULL), MS_OK);
        CHECK_INT(memory.calls, 1);
        ms_nn_file_close(file);
        memory.calls = 0;
        CHECK_INT(ms_nn_load(net.file, net.size, &o, &nn, NULL), MS_OK);
        for (i = 0; i < ms_nn_layer_count(nn); ++i) weighted += ms_nn_layer_at(nn, i).dtype != MS_NN_DTYPE_COUNT;
        if (memory.calls > 12 + 5 * weighted)
            TEST_FAIL("network %d: %ld allocations for %ld layers with weights", which, memory.calls, weighted);
        most = memory.calls - 5 * weighted > most ? memory.calls - 5 * weighted : most;
        ms_nn_destroy(nn);
        CHECK_INT(memory.blocks, 0);
        net_free(&net);
    }
    TEST_NOTE("at most %ld allocations beside five for each layer with weights", most);
    CHECK_INT(load_many("{\"type\":\"dropout\"}", 4096, &error), MS_OK);
    CHECK_INT(load_many("{\"type\":\"dropout\"}", 4097, &error), MS_BAD_DATA);
    CHECK(strstr(error.message, "4096") != NULL);
    {
        static const float weight[1] = {1};
        static const size_t shape[3] = {1, 1, 1};
        static const char *const zeros[2] = {"1073741816", "1073741815"}; /* 16 + 2 zeros: 2^31 and two less */
        const ms_nn_tensor tensor = {"c.weight", MS_NN_F32, 3, shape, weight, 4};
        char layers[200];
        ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[1,16]"}, {"ms_nn_layers", layers}};
        unsigned char file[1024];
        size_t size;
        ms_nn *nn = NULL;
        for (i = 0; i < 2; ++i) {
            snprintf(layers, sizeof layers,
                     "[{\"type\":\"conv1d\",\"name\":\"c\",\"bias\":false,\"stride\":1000000,\"zeros\":%s}]", zeros[i]);
            CHECK_INT(ms_nn_file_write(&tensor, 1, e, 3, file, sizeof file, &size, &error), MS_OK);
            error.message[0] = 0;
            CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error) == MS_BAD_DATA, i == 0);
            CHECK((strstr(error.message, "its padded input is too large") != NULL) == (i == 0));
            ms_nn_destroy(nn);
            nn = NULL;
        }
    }
}

/* ms_nn_check_weights sees every value of the layers that can be infinite, and says nothing of other tensors. */
static void test_check_weights(void)
{
    static const char *const part[3] = {"weight", "bias", "weight_scale"};
    static const size_t shape[2] = {2, 3}, two[1] = {2};
    static const float infinite[2] = {1, (float)INFINITY}, fine[6] = {1, 2, 3, 4, 5, 6};
    static const unsigned char nan8[4] = {0xff, 0x7f, 0x7f, 0xff}, integer[6] = {1, 2, 3, 4, 5, 6};
    int bad;
    for (bad = 0; bad < 4; ++bad) { /* which tensor is infinite; 3: one that no layer has */
        const ms_nn_tensor t[4] = {{"f.weight", MS_NN_I8, 2, shape, integer, 6},
                                   {"f.bias", MS_NN_F32, 1, two, bad == 1 ? infinite : fine, 8},
                                   {"f.weight_scale", MS_NN_F32, 1, two, bad == 2 ? infinite : fine, 8},
                                   {"other", MS_NN_F8_E5M2, 2, shape + 1, nan8, 0}};
        ms_nn_entry e[3] = {
            {"ms_nn_version", "1"}, {"ms_nn_input", "[3]"}, {"ms_nn_layers", "[{\"type\":\"dense\",\"name\":\"f\"}]"}};
        unsigned char file[1024];
        ms_nn *nn = NULL;
        size_t size;
        ms_error error;
        ms_nn_tensor all[4];
        static const size_t four[1] = {4};
        memcpy(all, t, sizeof all);
        all[3].rank = 1;
        all[3].shape = four;
        all[3].bytes = 4;
        if (bad == 0) { /* weights of F32 */
            static const float wrong[6] = {1, 2, 3, 4, (float)NAN, 6};
            all[0].dtype = MS_NN_F32;
            all[0].data = wrong;
            all[0].bytes = 24;
            all[2] = all[3];
        }
        CHECK_INT(ms_nn_file_write(all, bad == 0 ? 3 : 4, e, 3, file, sizeof file, &size, &error), MS_OK);
        CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error), MS_OK);
        CHECK_INT(ms_nn_check_weights(nn, &error), bad == 3 ? MS_OK : MS_BAD_DATA);
        if (bad < 3) {
            CHECK_INT(error.position, bad == 0 ? 4 : 1);
            CHECK(strstr(error.message, part[bad]) != NULL);
        }
        ms_nn_destroy(nn);
    }
}

/* What is no safetensors file is told so: texts, pictures, archives. */
static void test_other_files(void)
{
    static const char first[][24] = {"hello, this is a text\n", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR",
                                     "PK\x03\x04\x14\0\0\0\x08\0\xff\xff", "{\"json\": [1, 2, 3]}",
                                     "\x93NUMPY\x01\0v\0{'descr"};
    size_t i;
    for (i = 0; i < sizeof first / sizeof first[0]; ++i) {
        char file[64] = {0};
        ms_nn_file *f = NULL;
        ms_error error;
        memcpy(file, first[i], 20);
        CHECK_INT(ms_nn_file_open(file, sizeof file, NULL, &f, &error), MS_BAD_DATA);
        if (strncmp(error.message, "not a safetensors file", 22)) TEST_FAIL("%d: %s", (int)i, error.message);
    }
}

/* JSON's white space (RFC 8259: space, tab, line feed, carriage return) may stand around each word of both entries. */
static void test_white_space(void)
{
    static const char *const list[3][2] = {
        {"[5]", "[{\"type\":\"activation\",\"activation\":\"tanh\"}]"},
        {" \t\r\n[ \t\r\n5 \t\r\n] \t\r\n",
         "\n[\r{\t\"type\" : \"activation\"\n,\r\"activation\"\t: \"tanh\"\n}\r]\t "},
        {"[5]\n", "[{\"type\":\"activation\",\"activation\":\"tanh\"}]\n"}};
    static const float x[5] = {-2, -0.5f, 0, 0.25f, 3};
    int i, k;
    for (i = 0; i < 3; ++i) {
        ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", NULL}, {"ms_nn_layers", NULL}};
        unsigned char file[1000];
        float y[5];
        size_t size;
        ms_nn *nn = NULL;
        ms_error error;
        e[1].value = list[i][0];
        e[2].value = list[i][1];
        CHECK_INT(ms_nn_file_write(NULL, 0, e, 3, file, sizeof file, &size, &error), MS_OK);
        if (ms_nn_load(file, size, NULL, &nn, &error) != MS_OK) TEST_FAIL("%d: %s", i, error.message);
        CHECK_INT(ms_nn_input_size(nn), 5);
        CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
        for (k = 0; k < 5; ++k) CHECK_NEAR(y[k], tanh((double)x[k]), 1e-6); /* a float32 tanh */
        ms_nn_destroy(nn);
    }
}

/* The byte of an error in the layer list is one of its text, where the word that is not known stands. */
static void test_positions(void)
{
    static const char *const list[][3] = {
        {"[{\"type\":\"flatten\",\"name\":\"\303\251\"},{\"type\":\"gru\"}]", "unknown type 'gru' (layer 1)", "\"gru"},
        {"[{\"type\":\"flatten\",\"color\":1}]", "unknown field 'color' (layer 0)", "\"color"},
        {"[ {\"type\":\"dense\",\"name\":\"f\"}]", "there is no tensor 'f.weight' (layer 0, dense 'f')", "{\"type"},
        {"[{\"type\":\"activation\",\"activation\":\"swish\"}]", "unknown activation 'swish' (layer 0, activation)",
         "{\"type"}};
    size_t k, size;
    for (k = 0; k < sizeof list / sizeof list[0]; ++k) {
        ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[5]"}, {"ms_nn_layers", NULL}};
        unsigned char file[600];
        ms_nn *nn = NULL;
        ms_error error;
        const char *text = e[2].value = list[k][0];
        CHECK_INT(ms_nn_file_write(NULL, 0, e, 3, file, sizeof file, &size, &error), MS_OK);
        CHECK_INT(ms_nn_load(file, size, NULL, &nn, &error), MS_BAD_DATA);
        if (strcmp(error.message, list[k][1]) != 0) TEST_FAIL("%s, expected %s", error.message, list[k][1]);
        if (error.position > strlen(text) || strncmp(text + error.position, list[k][2], strlen(list[k][2])) != 0)
            TEST_FAIL("byte %d of '%s', expected %s", (int)error.position, text, list[k][2]);
    }
}

/* A tensor's dtype and fields are named with the tensor. */
static void test_header_words(void)
{
    static const char *const list[][2] = {
        {"{\"hidden1.weight\":{\"dtype\":\"F12\",\"shape\":[0],\"data_offsets\":[0,0]}}",
         "unknown dtype 'F12' (tensor 'hidden1.weight')"},
        {"{\"a\":{\"dtype\":\"F32\",\"size\":[0],\"data_offsets\":[0,0]}}",
         "unknown field 'size'; known are dtype, shape, data_offsets (tensor 'a')"}};
    size_t k;
    for (k = 0; k < 2; ++k) {
        char file[300];
        ms_nn_file *f = NULL;
        ms_error error;
        size_t n = strlen(list[k][0]);
        memset(file, 0, 8);
        file[0] = (char)n;
        memcpy(file + 8, list[k][0], n);
        CHECK_INT(ms_nn_file_open(file, n + 8, NULL, &f, &error), MS_BAD_DATA);
        if (strcmp(error.message, list[k][1]) != 0) TEST_FAIL("%s, expected %s", error.message, list[k][1]);
        CHECK(file[error.position] == '"');
    }
}

/* Slopes as other writers print them; what is no JSON number is refused. */
static void test_numbers(void)
{
    static const char *const good[] = {"0.30000000000000004",  "0.009999999776482582", "1E-2", "12.5e+1", "0", "0.0",
                                       "100000000000000000000"};
    static const char *const bad[] = {"01", "1.", ".5", "-0.5", "1e", "1e+", "0x1", "nan", "- 1", "1e31", "\"1\""};
    size_t i, goods = sizeof good / sizeof good[0];
    for (i = 0; i < goods + sizeof bad / sizeof bad[0]; ++i) {
        static const size_t shape[2] = {1, 1};
        static const unsigned char one[4] = {0, 0, 0x80, 0x3f};
        const char *text = i < goods ? good[i] : bad[i - goods];
        char layers[200];
        ref_net file;
        ms_nn_tensor t;
        ms_nn_entry e[3];
        ms_nn *nn = NULL;
        memset(&file, 0, sizeof file);
        memset(&t, 0, sizeof t);
        snprintf(layers, sizeof layers,
                 "[{\"type\":\"dense\",\"name\":\"f\",\"bias\":false,\"activation\":\"leaky_relu\",\"alpha\":%s}]",
                 text);
        t.name = "f.weight";
        t.dtype = MS_NN_F32;
        t.rank = 2;
        t.shape = shape;
        t.data = one;
        t.bytes = sizeof one;
        e[0].key = "ms_nn_version";
        e[0].value = "1";
        e[1].key = "ms_nn_input";
        e[1].value = "[1]";
        e[2].key = "ms_nn_layers";
        e[2].value = layers;
        net_write(&file, &t, 1, e, 3);
        if (ms_nn_load(file.file, file.size, NULL, &nn, NULL) == MS_OK) {
            float x = -1, y = 0;
            if (i >= goods) TEST_FAIL("alpha %s was taken", text);
            CHECK_INT(ms_nn_forward(nn, 1, &x, &y, NULL), MS_OK);
            CHECK_NEAR(-(double)y, strtod(text, NULL), 1e-7 * strtod(text, NULL)); /* a float's rounding */
        } else if (i < goods) {
            TEST_FAIL("alpha %s was refused", text);
        }
        ms_nn_destroy(nn);
        free(file.file);
    }
}

/* A matrix of more than 2^31 bytes, of which only the last row is touched; in the long version all of it runs. */
static void test_large(void)
{
    ms_nn *nn = NULL;
    ms_error error;
    if (sizeof(size_t) < 8) {
        unsigned char *few = (unsigned char *)calloc(64, 1);
        ms_nn_file *file = NULL;
        CHECK_INT(ms_nn_file_open(few, SIZE_MAX / 2 + 1, NULL, &file, &error),
                  MS_UNSUPPORTED); /* before a byte is read */
        free(few);
    } else {
        static const char layers[] = "[{\"type\":\"dense\",\"name\":\"f\",\"bias\":false}]";
        const size_t shape[2] = {2100000, 1100}, count = shape[0] * shape[1], last = count - shape[1];
        float *scale = (float *)malloc(shape[0] * sizeof(float));
        unsigned char *f;
        ms_nn_tensor t[2];
        ms_nn_entry e[3];
        size_t i, size = 0;
        double row[1100];
        memset(t, 0, sizeof t);
        f = (unsigned char *)calloc(count + 4 * shape[0] + 4096,
                                    1); /* zero pages are not there before they are touched */
        if (f == NULL || scale == NULL) {
            free(scale);
            SKIP("no 2.3 GB of address space");
        }
        for (i = 0; i < shape[0]; ++i) store(MS_NN_F32, 0.5, (unsigned char *)(scale + i), 1);
        t[0].name = "f.weight";
        t[0].dtype = MS_NN_I8;
        t[0].rank = 2;
        t[0].shape = shape;
        t[0].data = NULL; /* left as it is */
        t[0].bytes = count;
        t[1].name = "f.weight_scale";
        t[1].dtype = MS_NN_F32;
        t[1].rank = 1;
        t[1].shape = shape;
        t[1].data = scale;
        t[1].bytes = 4 * shape[0];
        e[0].key = "ms_nn_version";
        e[0].value = "1";
        e[1].key = "ms_nn_input";
        e[1].value = "[1100]";
        e[2].key = "ms_nn_layers";
        e[2].value = layers;
        CHECK_INT(ms_nn_file_write(t, 2, e, 3, f, count + 4 * shape[0] + 4096, &size, &error), MS_OK);
        for (i = 0; i < shape[1]; ++i) (f + size - t[1].bytes - count)[last + i] = (unsigned char)(i % 100);
        if (ms_nn_load(f, size, NULL, &nn, &error) != MS_OK) TEST_FAIL("%s", error.message);
        CHECK(ms_nn_layer_at(nn, 0).parameters == count);
        CHECK(ms_nn_layer_at(nn, 0).multiply_adds == count);
        inside_widen(nn, last, shape[1], 0.5, row);
        for (i = 0; i < shape[1]; ++i) CHECK_NEAR(row[i], 0.5 * (double)(i % 100), 0);
        if (test_full) {
            float *x = (float *)malloc(shape[1] * sizeof(float)), *y = (float *)malloc(shape[0] * sizeof(float));
            double sum = 0;
            for (i = 0; i < shape[1]; ++i) {
                x[i] = (float)(i % 7);
                sum += 0.5 * (double)(i % 100) * (double)x[i];
            }
            CHECK_INT(ms_nn_forward(nn, 1, x, y, NULL), MS_OK);
            CHECK_NEAR(y[shape[0] - 1], sum, 1e-6 * sum); /* integers of 18 bits: exact but for the scale */
            CHECK_NEAR(y[shape[0] - 2], 0, 0);
            free(x);
            free(y);
        }
        ms_nn_destroy(nn);
        free(f);
        free(scale);
    }
}

static void test_arguments(void)
{
    uint64_t state = 1;
    ref_net net;
    ms_nn *nn;
    static float jacobian[98 * 37];
    float x[37], y[98];
    net_make(&net, 0, MS_NN_F32, &state);
    memset(x, 0, sizeof x);
    nn = net_load(&net, MS_SIMD_AUTO);
    CHECK_INT(ms_nn_forward(nn, 0, x, y, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_forward(nn, 1, NULL, y, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_forward(nn, 1, x, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK_INT(ms_nn_jacobian(nn, x, NULL, NULL, NULL), MS_INVALID_ARGUMENT);
    CHECK(ms_nn_workspace_size(nn, MS_NN_FORWARD, 0) == SIZE_MAX);
    CHECK(ms_nn_workspace_size(nn, MS_NN_FORWARD, -3) == SIZE_MAX);
    ms_nn_destroy(nn);
    ms_nn_destroy(NULL);
    TEST_ALLOCATION_SWEEP(80, {
        ms_nn_options o = ms_nn_defaults();
        ms_nn *made = NULL;
        o.allocator = allocator;
        status = ms_nn_load(net.file, net.size, &o, &made, NULL);
        if (status == MS_OK) status = ms_nn_forward(made, 1, x, y, NULL);
        if (status == MS_OK) status = ms_nn_jacobian(made, x, y, jacobian, NULL);
        ms_nn_destroy(made);
    });
    net_free(&net);
    net_make(&net, 8, MS_NN_F16, &state);
    TEST_ALLOCATION_SWEEP(80, {
        ms_nn_options o = ms_nn_defaults();
        ms_nn *made = NULL;
        o.allocator = allocator;
        status = ms_nn_load(net.file, net.size, &o, &made, NULL);
        ms_nn_destroy(made);
    });
    net_free(&net);
}

/* --- collapse --- */

static double direct_value(const ref_net *net, const ms_nn *nn, const float *x, const float *target,
                           const float *weight)
{
    const ref_layer *l = &net->layer[net->layers - 1];
    int n = count_of(l->in), outputs = (int)ms_nn_output_size(nn), i, k;
    size_t channels = 0, inputs = 0;
    float *h;
    double sum = 0;
    ms_nn_channel_inputs(nn, &channels, &inputs);
    h = (float *)malloc((size_t)n * channels * sizeof(float));
    CHECK_INT(inside_features(nn, x, h), MS_OK); /* those that the collapse sees: only its own error is measured */
    for (i = 0; i < outputs; ++i) {
        double r = l->b[i % l->out] - (double)target[i];
        for (k = 0; k < n; ++k) r += l->w[i % l->out * n + k] * (double)h[i / l->out * n + k];
        sum += r * r * (weight ? (double)weight[i] : 1);
    }
    free(h);
    return sum;
}

/* The residual's Jacobian against differences of float features: steps of 1e-2 leave 1e-4 of curvature and
   |R| 6e-8 / 1e-2 = 2e-4 of rounding; ten times both. */
static void check_slopes(const ms_nn_collapse *c, const float *x, const double *jacobian, int rows, int inputs)
{
    double *plus = (double *)malloc((size_t)rows * sizeof(double)),
           *minus = (double *)malloc((size_t)rows * sizeof(double));
    float *moved = (float *)malloc((size_t)inputs * sizeof(float));
    int i, k;
    for (k = 0; k < inputs; ++k) {
        double size = 0, e = 0;
        memcpy(moved, x, (size_t)inputs * sizeof(float));
        moved[k] = x[k] + 0.005f;
        CHECK_INT(ms_nn_collapse_residual(c, moved, plus, NULL, NULL), MS_OK);
        moved[k] = x[k] - 0.005f;
        CHECK_INT(ms_nn_collapse_residual(c, moved, minus, NULL, NULL), MS_OK);
        for (i = 0; i < rows; ++i) {
            double d = (plus[i] - minus[i]) / 0.01;
            if (fabs(d) > size) size = fabs(d);
            if (fabs(d - jacobian[i * inputs + k]) > e) e = fabs(d - jacobian[i * inputs + k]);
        }
        CHECK_LE(e, 1e-3 * size + 2e-3);
    }
    free(plus);
    free(minus);
    free(moved);
}

/* Value, residual and Jacobian for one network and one way of weighting its outputs. */
enum { ALL_ONE, WEIGHTED, MASKED, FEW_OUTPUTS, SHARED, SHARED_WEIGHTED, SHARED_PIXELS, SHARED_CHANNEL, COLLAPSES };

static double collapse_case(ms_nn_dtype dtype, int way, uint64_t *state)
{
    enum { IN = 12, FEATURES = 40 };
    int shared = way >= SHARED, channels = shared ? 3 : 1, rows = way == FEW_OUTPUTS ? 20 : 900, m = channels * rows,
        features = channels * FEATURES, i, k;
    float x[IN], best[IN], *weight = (float *)malloc((size_t)m * sizeof(float)),
                           *t = (float *)malloc((size_t)m * sizeof(float));
    float *target = (float *)malloc((size_t)m * sizeof(float));
    double *residual = (double *)malloc((size_t)(features + 1) * sizeof(double)),
           *jacobian = (double *)malloc((size_t)(features + 1) * IN * sizeof(double));
    double value, worst = 0;
    ref_net net;
    ms_nn *nn;
    ms_nn_collapse *c = NULL;
    ms_error error;
    net_begin(&net, dtype, 1, shared ? 5 : (int)IN, 1, 1);
    if (shared) { /* 7 is not seen, 5 twice by the same channel */
        net.shared = "[[0,3,6,8,9],[1,4,6,8,10],[2,5,5,8,11]]";
        net.outer = IN;
    }
    net_dense(&net, 30, 4);
    net_dense(&net, FEATURES, 4);
    net_dense(&net, rows, 0);
    net_end(&net, state);
    nn = net_load(&net, MS_SIMD_AUTO);
    CHECK_INT(ms_nn_output_size(nn), m);
    for (i = 0; i < IN; ++i) best[i] = (float)test_uniform(state);
    for (i = 0; i < m; ++i)
        weight[i] = way == WEIGHTED || (way == SHARED_WEIGHTED && i < rows) ? (float)test_uniform(state) : 1;
    for (i = rows; way == SHARED_WEIGHTED && i < m; ++i) weight[i] = weight[i % rows];
    for (k = 0; k < 2 && (way == MASKED || way >= SHARED_PIXELS); ++k)
        for (i = 0; i < (way == SHARED_PIXELS ? 3 * 300 : 300); ++i)
            weight[i / 300 * rows + (way == SHARED_CHANNEL ? rows : 0) + i % 300 * 3 + k] = i % 3 == 0 ? 0.0f
                : i % 3 == 1                                                                           ? 0.25f
                                                                                                       : 3.0f;
    CHECK_INT(
        ms_nn_collapse_create(nn, way == ALL_ONE || way == FEW_OUTPUTS || way == SHARED ? NULL : weight, &c, &error),
        MS_OK);
    CHECK_INT(ms_nn_collapse_features(c), features);
    CHECK_INT(ms_nn_collapse_residual(c, best, residual, NULL, NULL), MS_INVALID_ARGUMENT); /* no target yet */
    for (i = 0; i < channels; ++i)
        CHECK_INT(inside_collapse_owner(c, i), way == SHARED_CHANNEL && i == 1 ? 1 : 0); /* who shares R */
    ms_nn_forward(nn, 1, best, target, NULL);
    for (k = 0; k <= 6; k += 2) { /* targets at 1 to 1e-6 of their norm from what the network reaches */
        double direct, relative = pow(10, -k), spread = 0, sum = 0;
        for (i = 0; i < m; ++i) t[i] = target[i] + (float)(relative * test_normal(state));
        CHECK_INT(ms_nn_collapse_target(c, t, &error), MS_OK);
        for (i = 0; i < IN; ++i) x[i] = best[i] + (float)(relative * 0.1 * test_normal(state));
        value = collapse_value(c, x);
        direct = direct_value(&net, nn, x, t, weight);
        for (i = 0; i < m; ++i) spread += (double)t[i] * (double)t[i];
        /* float residuals of 1e-6 have 1e-7 / 1e-6 of noise in both alike; the collapse adds 1e-16 |t|^2 by theory,
           with a factor of 1e3 for 900 x 40 sums and their condition */
        /* where features outnumber outputs, W'MW's own rounding meets distances of 1 that no output sees: 1e-16 of
           |t|^2 for each of 10 units of squared distance */
        CHECK_NEAR(value, direct,
                   1e-9 * direct + 1e-13 * spread * relative + (way == FEW_OUTPUTS ? 1e-15 * spread : 0));
        if (fabs(value - direct) / direct > worst) worst = fabs(value - direct) / direct;
        CHECK_INT(ms_nn_collapse_residual(c, x, residual, jacobian, NULL), MS_OK);
        for (i = 0; i <= features; ++i) sum += residual[i] * residual[i];
        CHECK_NEAR(sum, value, 1e-12 * value);
    }
    check_slopes(c, x, jacobian, features + 1, IN);
    ms_nn_collapse_destroy(c);
    ms_nn_destroy(nn);
    net_free(&net);
    free(weight);
    free(t);
    free(target);
    free(residual);
    free(jacobian);
    return worst;
}

static void test_collapse(void)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    uint64_t state = test_seed + 3;
    double worst = 0;
    int type, way;
    for (type = 0; type < 3; ++type)
        for (way = 0; way < COLLAPSES; ++way) {
            double e = collapse_case(types[type], way, &state);
            if (e > worst) worst = e;
        }
    TEST_NOTE("largest relative error of the value %.1e", worst);
}

/* A network of one layer: its features are the channels' inputs, the Jacobian of the residual is R. */
static void test_collapse_alone(void)
{
    enum { IN = 4, ROWS = 50 };
    uint64_t state = test_seed + 9;
    ref_net net;
    ms_nn *nn;
    ms_nn_collapse *c = NULL;
    float x[IN], t[2 * ROWS];
    double value, direct = 0, residual[7], jacobian[7 * IN];
    int i, k, j;
    net_begin(&net, MS_NN_F16, 1, 3, 1, 1);
    net.shared = "[[0,1,3],[3,2,1]]";
    net.outer = IN;
    net_dense(&net, ROWS, 0);
    net_end(&net, &state);
    nn = net_load(&net, MS_SIMD_AUTO);
    for (i = 0; i < IN; ++i) x[i] = (float)test_normal(&state);
    for (i = 0; i < 2 * ROWS; ++i) t[i] = (float)test_normal(&state);
    CHECK_INT(ms_nn_collapse_create(nn, NULL, &c, NULL), MS_OK);
    CHECK_INT(ms_nn_collapse_target(c, t, NULL), MS_OK);
    value = collapse_value(c, x);
    CHECK_INT(ms_nn_collapse_residual(c, x, residual, jacobian, NULL), MS_OK);
    for (i = 0; i < 2 * ROWS; ++i) {
        static const int sees[2][3] = {{0, 1, 3}, {3, 2, 1}};
        double y = net.layer[0].b[i % ROWS] - (double)t[i];
        for (k = 0; k < 3; ++k) y += net.layer[0].w[i % ROWS * 3 + k] * (double)x[sees[i / ROWS][k]];
        direct += y * y;
    }
    CHECK_NEAR(value, direct, 1e-13 * direct); /* sums of 100 doubles */
    for (i = 0; i < 3; ++i)
        for (j = i; j < 3; ++j) {
            const double r = inside_collapse_factor(c, i, j);
            static const int first[3] = {0, 1, 3}, second[3] = {3, 2, 1};
            CHECK_NEAR(jacobian[i * IN + first[j]], r, 1e-15);
            CHECK_NEAR(jacobian[(3 + i) * IN + second[j]], r, 1e-15);
        }
    ms_nn_collapse_destroy(c);
    ms_nn_destroy(nn);
    net_free(&net);
}

/* What is asked of an allocator. */
static size_t asked_bytes;
static void *asking_alloc(void *user, size_t size)
{
    (void)user;
    asked_bytes += size;
    return malloc(size);
}
static void asking_release(void *user, void *pointer, size_t size)
{
    (void)user, (void)size;
    free(pointer);
}

/* A network of one dense layer of floats, zeros but for the first `given`; asked_bytes has what its load asked for. */
static ms_nn *one_matrix(size_t rows, size_t cols, const float *first, size_t given, unsigned char **file)
{
    const size_t shape[2] = {rows, cols};
    char input[24];
    ms_nn_tensor t = {"f.weight", MS_NN_F32, 2, NULL, NULL, 0};
    ms_nn_entry e[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", NULL}, {"ms_nn_layers", NULL}};
    ms_nn_options o = ms_nn_defaults();
    ms_nn *nn = NULL;
    size_t size = 0, i;
    snprintf(input, sizeof input, "[%d]", (int)cols);
    t.shape = shape;
    t.bytes = rows * cols * sizeof(float);
    e[1].value = input;
    e[2].value = "[{\"type\":\"dense\",\"name\":\"f\",\"bias\":false}]";
    *file = (unsigned char *)calloc(t.bytes + 4096, 1);
    CHECK_INT(ms_nn_file_write(&t, 1, e, 3, *file, t.bytes + 4096, &size, NULL), MS_OK);
    for (i = 0; i < given; ++i) store(MS_NN_F32, (double)first[i], *file + size - t.bytes + 4 * i, 1);
    o.allocator.alloc = asking_alloc;
    o.allocator.release = asking_release;
    asked_bytes = 0;
    CHECK_INT(ms_nn_load(*file, size, &o, &nn, NULL), MS_OK);
    return nn;
}

/* Dense layers are packed up to 64 MB, and no further: a matrix of a column more asks for that much less memory
   (whatever a host of another byte order copies). */
static void test_packed_bytes(void)
{
    const size_t limit = (size_t)64 << 20;
    size_t asked[2], k;
    for (k = 0; k < 2; ++k) {
        unsigned char *file;
        ms_nn *nn = one_matrix(8192, 2048 + k, NULL, 0, &file);
        asked[k] = asked_bytes;
        ms_nn_destroy(nn);
        free(file);
    }
    CHECK_NEAR((double)asked[0] - (double)asked[1], (double)limit, 2e5); /* scales, biases; the column's own copy */
}

/* A direction that changes the outputs by less than 1e-7 of what its column does is left out of R. */
static void test_collapse_pivot(void)
{
    static const float d[] = {0.5e-7f, 0.9e-7f, 1.1e-7f, 2e-7f};
    int k;
    for (k = 0; k < 4; ++k) {
        float w[4] = {1, 1, 0, 0};
        unsigned char *file;
        ms_nn_collapse *c = NULL;
        ms_nn *nn;
        w[3] = d[k];
        nn = one_matrix(2, 2, w, 4, &file);
        CHECK_INT(ms_nn_collapse_create(nn, NULL, &c, NULL), MS_OK);
        /* the pivot d^2 is a difference of numbers near 1: 2e-16 of 1e-14 */
        CHECK_NEAR(inside_collapse_factor(c, 1, 1), k < 2 ? 0 : (double)d[k], 0.02 * (double)d[k]);
        CHECK_NEAR(inside_collapse_factor(c, 0, 1), 1, 1e-15);
        ms_nn_collapse_destroy(c);
        ms_nn_destroy(nn);
        free(file);
    }
}

/* R'R = W'W, the same bits for any number of threads. */
static void test_collapse_factor(void)
{
    uint64_t state = test_seed + 8;
    ref_net net;
    ms_nn *nn;
    ms_nn_collapse *c = NULL, *d = NULL;
    int m = 1500, h = 50, i, j, k;
    double worst = 0, size = 0, full[50][50];
    net_begin(&net, MS_NN_F32, 1, h, 1, 1);
    net_dense(&net, m, 0);
    net_end(&net, &state);
    nn = net_load(&net, MS_SIMD_AUTO);
    CHECK_INT(ms_nn_collapse_create(nn, NULL, &c, NULL), MS_OK);
    memset(full, 0, sizeof full);
    for (i = 0; i < h; ++i)
        for (k = i; k < h; ++k) full[i][k] = inside_collapse_factor(c, i, k);
    for (i = 0; i < h; ++i)
        for (j = 0; j < h; ++j) {
            double a = 0, b = 0;
            for (k = 0; k < h; ++k) a += full[k][i] * full[k][j];
            for (k = 0; k < m; ++k) b += net.layer[0].w[k * h + i] * net.layer[0].w[k * h + j];
            if (fabs(a - b) > worst) worst = fabs(a - b);
            if (fabs(b) > size) size = fabs(b);
        }
    CHECK_LE(worst / size, 1e-13); /* sums of 1500 doubles */
    {
        ms_nn_options o = ms_nn_defaults();
        ms_nn *two = NULL;
        test_pool pool;
        o.parallel = test_parallel(&pool, 3);
        CHECK_INT(ms_nn_load(net.file, net.size, &o, &two, NULL), MS_OK);
        CHECK_INT(ms_nn_collapse_create(two, NULL, &d, NULL), MS_OK);
        for (i = 0; i < h; ++i)
            for (k = i; k < h; ++k) {
                const double a = inside_collapse_factor(c, i, k), b = inside_collapse_factor(d, i, k);
                CHECK_INT(memcmp(&a, &b, sizeof a), 0);
            }
        ms_nn_collapse_destroy(d);
        ms_nn_destroy(two);
    }
    {
        float weight[1500], target[1500];
        ms_error error;
        for (i = 0; i < m; ++i) weight[i] = target[i] = 1;
        weight[7] = -1;
        CHECK_INT(ms_nn_collapse_create(nn, weight, &d, &error), MS_INVALID_ARGUMENT);
        CHECK_INT(error.position, 7);
        target[9] = (float)NAN;
        CHECK_INT(ms_nn_collapse_target(c, target, &error), MS_INVALID_ARGUMENT);
    }
    ms_nn_collapse_destroy(c);
    ms_nn_collapse_destroy(NULL);
    TEST_ALLOCATION_SWEEP(20, {
        ms_nn_options o = ms_nn_defaults();
        ms_nn *made = NULL;
        float t[1500];
        double residual[51];
        memset(t, 0, sizeof t);
        d = NULL;
        o.allocator = allocator;
        status = ms_nn_load(net.file, net.size, &o, &made, NULL);
        if (status == MS_OK) status = ms_nn_collapse_create(made, NULL, &d, NULL);
        if (status == MS_OK) status = ms_nn_collapse_target(d, t, NULL);
        if (status == MS_OK) status = ms_nn_collapse_residual(d, t, residual, NULL, NULL);
        ms_nn_collapse_destroy(d);
        ms_nn_destroy(made);
    });
    ms_nn_destroy(nn);
    net_free(&net);
    net_make(&net, 10, MS_NN_F32, &state);
    net_free(&net);
}

/* What nn_info prints. */
static void test_queries(void)
{
    ms_nn *nn = NULL;
    ms_nn_layer l;
    CHECK_INT(ms_nn_load_file("tests/data/nn/flatten_dense_channels_last.safetensors", NULL, &nn, NULL), MS_OK);
    CHECK_INT(ms_nn_layer_count(nn), 4);
    l = ms_nn_layer_at(nn, 0);
    CHECK(strcmp(l.type, "conv2d") == 0 && strcmp(l.name, "c") == 0 && strcmp(l.activation, "relu") == 0 &&
          l.dtype == MS_NN_F32);
    CHECK_INT(l.parameters, 4 * 27 + 4);
    CHECK_INT(l.bytes, 4 * (4 * 27 + 4));
    CHECK_INT(l.multiply_adds, 4 * 27 * 8 * 10);
    CHECK_INT(l.output.rank, 3);
    CHECK(l.output.size[0] == 4 && l.output.size[1] == 8 && l.output.size[2] == 10);
    l = ms_nn_layer_at(nn, 3);
    CHECK_INT(l.multiply_adds, 8 * 80);
    CHECK_INT(ms_nn_input_shape(nn).rank, 3);
    CHECK_INT(ms_nn_output_shape(nn).rank, 1);
    CHECK(strcmp(ms_nn_dtype_string(MS_NN_BF16), "BF16") == 0 &&
          strcmp(ms_nn_dtype_string(MS_NN_DTYPE_COUNT), "unknown") == 0);
    ms_nn_destroy(nn);
}

static const test_case cases[] = {{"reference networks", test_reference},
                                  {"random networks", test_random},
                                  {"same bits", test_same_bits},
                                  {"workspaces", test_workspaces},
                                  {"batches", test_batches},
                                  {"dense shapes", test_dense_shapes},
                                  {"flush to zero", test_flush_to_zero},
                                  {"stack", test_stack_use},
                                  {"file cut under it", test_copy},
                                  {"NULL", test_null},
                                  {"collapse with weights", test_collapse_weighted},
                                  {"products", test_products},
                                  {"activations", test_activations},
                                  {"saturation", test_saturation},
                                  {"shared channels", test_shared},
                                  {"unaligned", test_unaligned},
                                  {"not finite", test_not_finite},
                                  {"refused", test_refused},
                                  {"any sizes", test_any_sizes},
                                  {"long names", test_long_names},
                                  {"stride without step", test_stride_without_step},
                                  {"counts", test_counts},
                                  {"weights checked", test_check_weights},
                                  {"other files", test_other_files},
                                  {"white space", test_white_space},
                                  {"positions of errors", test_positions},
                                  {"words of a header", test_header_words},
                                  {"numbers", test_numbers},
                                  {"large", test_large},
                                  {"arguments", test_arguments},
                                  {"collapse", test_collapse},
                                  {"collapse of one layer", test_collapse_alone},
                                  {"collapse factor", test_collapse_factor},
                                  {"packed bytes", test_packed_bytes},
                                  {"a pivot that is rounding", test_collapse_pivot},
                                  {"queries", test_queries}};
TEST_MAIN_WITH_FILES(cases)
