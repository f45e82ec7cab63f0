/* Attacks on ms_nn.h: networks drawn over the whole layer list against a plain loop in double, files with damaged
   headers and layer lists, infinities, long names. */
#define MS_NN_IMPLEMENTATION
#define MS_NN_NO_STDIO
#include "ms_nn.h"
#include "attack.h"

/* ---- a network and its slow way ---------------------------------------------------------------------------------- */

enum { LAYERS = 8, SIDE = 24, VALUES = 3000 };

typedef enum kind {
    DENSE,
    CONV1D,
    CONV2D,
    UPSAMPLE1D,
    UPSAMPLE2D,
    MAXPOOL1D,
    MAXPOOL2D,
    AVGPOOL1D,
    AVGPOOL2D,
    GLOBALPOOL,
    FLATTEN,
    ACTIVATION,
    DROPOUT,
    ADD
} kind;
static const char *const kind_name[] = {"dense",     "conv1d",     "conv2d",    "upsample1d", "upsample2d",
                                        "maxpool1d", "maxpool2d",  "avgpool1d", "avgpool2d",  "globalpool",
                                        "flatten",   "activation", "dropout",   "add"};
static const char *const act_name[] = {"linear",  "relu",     "leaky_relu", "elu", "tanh",
                                       "sigmoid", "softplus", "silu",       "gelu"};

typedef struct shape {
    int rank, c, h, w;
} shape;

typedef struct layer {
    kind kind;
    char name[300];
    int units, k[2], s[2], zeros[2], same, act, bias, from; /* from: -1 the input */
    double alpha;                                           /* below 0: not said */
    ms_nn_dtype dtype;
    double *weight, *bias_value; /* as the network has them */
    void *data, *scale, *bias_data;
    size_t weights, weight_shape[4];
    shape out;
} layer;

typedef struct net {
    shape in;
    int layers, channels, channel_inputs, channel_input[6]; /* channels 0: no shared_channels */
    layer layer[LAYERS];
    char text[6000];
    unsigned char *file;
    size_t size;
    ms_nn_tensor tensor[3 * LAYERS];
    char tensor_name[3 * LAYERS][320];
    size_t bias_shape[LAYERS];
    int tensors;
} net;

static int count_of(shape s) { return s.c * s.h * s.w; }

static void net_free(net *n)
{
    int i;
    for (i = 0; i < n->layers; ++i) {
        free(n->layer[i].weight);
        free(n->layer[i].bias_value);
        free(n->layer[i].data);
        free(n->layer[i].scale);
        free(n->layer[i].bias_data);
    }
    free(n->file);
    memset(n, 0, sizeof *n);
}

static double activate(int act, double alpha, double v)
{
    switch (act) {
    case 1: return v > 0 ? v : v != v ? v : 0;
    case 2: return v > 0 ? v : (alpha < 0 ? 0.01 : (double)(float)alpha) * v;
    case 3: return v > 0 ? v : (alpha < 0 ? 1 : (double)(float)alpha) * expm1(v);
    case 4: return tanh(v);
    case 5: return 1 / (1 + exp(-v));
    case 6: return v > 40 ? v : log1p(exp(v));
    case 7: return v / (1 + exp(-v));
    case 8: return 0.5 * v * erfc(-v * 0.70710678118654752);
    default: return v;
    }
}

/* Error of an activation's value for an error e of its argument; in floats the value itself is off by some units. */
static double act_error(int act, double alpha, double e, double v)
{
    double slope = act == 2 || act == 3 ? (alpha > 1 ? alpha : 1) : 1.2;
    return slope * e + 1e-6 * fabs(v) + 1e-6 * (act >= 3 ? (alpha > 1 ? alpha : 1) : 0);
}

typedef struct value {
    double v[VALUES], e[VALUES];
} value;

/* One sample through the layers, beside it a bound of the error that floats make. */
static void forward(const net *n, const double *x, value *all) /* all[layers + 1], all[0] the input */
{
    int i, o, c, y, xx, j, a, b;
    const double eps = 1.2e-7;
    for (j = 0; j < count_of(n->in); ++j) {
        all[0].v[j] = x[j];
        all[0].e[j] = 0;
    }
    for (i = 0; i < n->layers; ++i) {
        const layer *l = &n->layer[i];
        const value *in = &all[i];
        value *out = &all[i + 1];
        const shape si = i ? n->layer[i - 1].out : n->in, so = l->out;
        const int two = l->kind == CONV2D;
        int count = count_of(so);
        switch (l->kind) {
        case DENSE:
            for (o = 0; o < l->units; ++o) {
                double sum = l->bias ? l->bias_value[o] : 0, error = 0, size = fabs(sum);
                for (j = 0; j < si.c; ++j) {
                    const double w = l->weight[o * si.c + j];
                    sum += w * in->v[j];
                    size += fabs(w * in->v[j]);
                    error += fabs(w) * in->e[j];
                }
                out->v[o] = sum;
                out->e[o] = error + eps * (4 + sqrt((double)si.c)) * size;
            }
            break;
        case CONV1D:
        case CONV2D: {
            int pad[2], kh = two ? l->k[0] : 1, kw = two ? l->k[1] : l->k[0], sh = two ? l->s[0] : 1,
                        sw = two ? l->s[1] : l->s[0];
            pad[0] = !two ? 0 : l->same ? (kh - 1) / 2 : l->zeros[0];
            pad[1] = l->same ? (kw - 1) / 2 : two ? l->zeros[1] : l->zeros[0];
            for (o = 0; o < so.c; ++o)
                for (y = 0; y < so.h; ++y)
                    for (xx = 0; xx < so.w; ++xx) {
                        double sum = l->bias ? l->bias_value[o] : 0, error = 0, size = fabs(sum);
                        for (c = 0; c < si.c; ++c)
                            for (a = 0; a < kh; ++a)
                                for (b = 0; b < kw; ++b) {
                                    const int yy = y * sh + a - pad[0], xi = xx * sw + b - pad[1];
                                    double w;
                                    if (yy < 0 || yy >= si.h || xi < 0 || xi >= si.w) continue;
                                    w = l->weight[((o * si.c + c) * kh + a) * kw + b];
                                    j = (c * si.h + yy) * si.w + xi;
                                    sum += w * in->v[j];
                                    size += fabs(w * in->v[j]);
                                    error += fabs(w) * in->e[j];
                                }
                        j = (o * so.h + y) * so.w + xx;
                        out->v[j] = sum;
                        out->e[j] = error + eps * (4 + sqrt((double)(si.c * kh * kw))) * size;
                    }
        } break;
        case UPSAMPLE1D:
        case UPSAMPLE2D:
            for (c = 0; c < so.c; ++c)
                for (y = 0; y < so.h; ++y)
                    for (xx = 0; xx < so.w; ++xx) {
                        const int fh = so.h / si.h, fw = so.w / si.w;
                        j = (c * si.h + y / fh) * si.w + xx / fw;
                        out->v[(c * so.h + y) * so.w + xx] = in->v[j];
                        out->e[(c * so.h + y) * so.w + xx] = in->e[j];
                    }
            break;
        case MAXPOOL1D:
        case MAXPOOL2D:
        case AVGPOOL1D:
        case AVGPOOL2D:
        case GLOBALPOOL: {
            const int flat = l->kind == MAXPOOL1D || l->kind == AVGPOOL1D, global = l->kind == GLOBALPOOL;
            const int kh = global ? si.h : flat ? 1 : l->k[0], kw = global ? si.w : flat ? l->k[0] : l->k[1];
            const int sh = flat ? 1 : l->s[0], sw = flat ? l->s[0] : l->s[1];
            const int most = l->kind == MAXPOOL1D || l->kind == MAXPOOL2D;
            for (c = 0; c < so.c; ++c)
                for (y = 0; y < so.h; ++y)
                    for (xx = 0; xx < so.w; ++xx) {
                        double sum = 0, error = 0, size = 0;
                        for (a = 0; a < kh; ++a)
                            for (b = 0; b < kw; ++b) {
                                const int at = (c * si.h + y * sh + a) * si.w + xx * sw + b;
                                sum = most ? ((a == 0 && b == 0) || in->v[at] > sum ? in->v[at] : sum)
                                           : sum + in->v[at];
                                size += fabs(in->v[at]);
                                error = most ? (in->e[at] > error ? in->e[at] : error) : error + in->e[at];
                            }
                        j = (c * so.h + y) * so.w + xx;
                        out->v[j] = most ? sum : sum / (kh * kw);
                        out->e[j] = most ? error : (error + eps * (4 + sqrt((double)(kh * kw))) * size) / (kh * kw);
                    }
        } break;
        case ADD: {
            const value *other = &all[l->from + 1];
            for (j = 0; j < count; ++j) {
                out->v[j] = in->v[j] + other->v[j];
                out->e[j] = in->e[j] + other->e[j] + eps * fabs(out->v[j]);
            }
        } break;
        default:
            memcpy(out->v, in->v, sizeof(double) * (size_t)count);
            memcpy(out->e, in->e, sizeof(double) * (size_t)count);
        }
        if (l->act > 0)
            for (j = 0; j < count; ++j) {
                out->v[j] = activate(l->act, l->alpha, out->v[j]);
                out->e[j] = act_error(l->act, l->alpha, out->e[j], out->v[j]);
            }
    }
}

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

/* A half that holds n / 64 exactly, |n| <= 127. */
static uint16_t half_of_64ths(int n)
{
    unsigned m = (unsigned)(n < 0 ? -n : n);
    int e = 9; /* of 1/64: 2^-6, biased 15 */
    if (n == 0) return 0;
    m <<= 10;
    while (m >= 2048) {
        m >>= 1;
        ++e;
    }
    return (uint16_t)((n < 0 ? 0x8000u : 0u) | (unsigned)e << 10 | (m & 1023));
}

/* Weights in a drawn type and the same as doubles; positive: none is 0 or below. */
static void draw_weights(net *n, layer *l, int rank, int positive)
{
    static const ms_nn_dtype types[] = {MS_NN_F32, MS_NN_F32, MS_NN_F16, MS_NN_I8};
    uint64_t state = attack_draw();
    const size_t outputs = l->weight_shape[0];
    size_t i, per;
    const int any_half = attack_one_in(2), half_scale = attack_one_in(3), half_bias = attack_one_in(3);
    float scale = 1 / 64.0f, *f;
    ms_nn_tensor *t;
    l->weights = 1;
    for (i = 0; i < (size_t)rank; ++i) l->weights *= l->weight_shape[i];
    per = l->weights / outputs;
    l->dtype = types[attack_index(4)];
    l->weight = (double *)malloc(l->weights * sizeof(double));
    l->data = malloc(l->weights * 4);
    l->bias_value = (double *)malloc(outputs * sizeof(double));
    l->bias_data = malloc(outputs * 4);
    l->scale = l->dtype == MS_NN_I8 ? malloc(outputs * 4) : NULL;
    f = (float *)l->data;
    for (i = 0; i < l->weights; ++i) {
        int k = (int)(attack_mix(&state) % 255) - 127;
        if (positive) k = k < 0 ? -k : k == 0 ? 1 : k;
        if (l->dtype == MS_NN_I8) {
            scale = (float)(1 + i / per % 9) / 64.0f;
            if (half_scale) ((uint16_t *)l->scale)[i / per] = half_of_64ths((int)(1 + i / per % 9));
            else ((float *)l->scale)[i / per] = scale = (float)(0.001 * (1 + (double)(i / per % 9)));
            ((signed char *)l->data)[i] = (signed char)k;
        } else if (l->dtype == MS_NN_F16 && any_half) { /* -1 to 1, evenly over the exponents, subnormals and 0 too */
            const unsigned bits = (unsigned)(attack_mix(&state) >> 20) % 0x3c01u;
            const double magnitude = bits < 0x400u ? ldexp((double)bits, -24)
                                                   : ldexp((double)(0x400u + (bits & 0x3ffu)), (int)(bits >> 10) - 25);
            ((uint16_t *)l->data)[i] = (uint16_t)(bits | (k < 0 ? 0x8000u : 0u));
            l->weight[i] = k < 0 ? -magnitude : magnitude;
            continue;
        } else if (l->dtype == MS_NN_F16) {
            ((uint16_t *)l->data)[i] = half_of_64ths(k);
        } else {
            f[i] = (float)k * scale;
        }
        l->weight[i] = k * (double)scale;
    }
    for (i = 0; i < outputs; ++i) {
        const int k = (int)(attack_mix(&state) % 201) - 100;
        const float b = (float)k / (half_bias ? 64.0f : 50.0f);
        if (half_bias) ((uint16_t *)l->bias_data)[i] = half_of_64ths(k);
        else ((float *)l->bias_data)[i] = b;
        l->bias_value[i] = (double)b;
    }
    t = &n->tensor[n->tensors];
    snprintf(n->tensor_name[n->tensors], 320, "%s.weight", l->name);
    t->name = n->tensor_name[n->tensors++];
    t->dtype = l->dtype;
    t->rank = rank;
    t->shape = l->weight_shape;
    t->data = l->data;
    t->bytes = l->weights * (l->dtype == MS_NN_F32 ? 4 : l->dtype == MS_NN_F16 ? 2 : 1);
    n->bias_shape[l - n->layer] = outputs;
    if (l->dtype == MS_NN_I8) {
        t = &n->tensor[n->tensors];
        snprintf(n->tensor_name[n->tensors], 320, "%s.weight_scale", l->name);
        t->name = n->tensor_name[n->tensors++];
        t->dtype = half_scale ? MS_NN_F16 : MS_NN_F32;
        t->rank = 1;
        t->shape = &n->bias_shape[l - n->layer];
        t->data = l->scale;
        t->bytes = outputs * (half_scale ? 2 : 4);
    }
    if (l->bias) {
        t = &n->tensor[n->tensors];
        snprintf(n->tensor_name[n->tensors], 320, "%s.bias", l->name);
        t->name = n->tensor_name[n->tensors++];
        t->dtype = half_bias ? MS_NN_F16 : MS_NN_F32;
        t->rank = 1;
        t->shape = &n->bias_shape[l - n->layer];
        t->data = l->bias_data;
        t->bytes = outputs * (half_bias ? 2 : 4);
    }
}

static void text_add(net *n, const char *format, ...)
{
    const size_t at = strlen(n->text);
    va_list list;
    va_start(list, format);
    attack_become(attack->host & ~ATTACK_COMMA); /* JSON has points */
    vsnprintf(n->text + at, sizeof n->text - at, format, list);
    attack_become(attack->host);
    va_end(list);
}

static void text_pair(net *n, const char *key, const int v[2], int two)
{
    if (two && v[0] != v[1]) text_add(n, ",\"%s\":[%d,%d]", key, v[0], v[1]);
    else text_add(n, ",\"%s\":%d", key, v[0]);
}

static void draw_activation(net *n, layer *l)
{
    l->act = attack_one_in(2) ? attack_index(9) : 0;
    l->alpha = -1;
    if (l->act || attack_one_in(4)) text_add(n, ",\"activation\":\"%s\"", act_name[l->act]);
    if ((l->act == 2 || l->act == 3) && attack_one_in(2)) {
        l->alpha = attack_one_in(8) ? 0 : attack_log(1e-4, 100);
        text_add(n, ",\"alpha\":%.9g", l->alpha);
    }
}

/* A layer that fits `in`; 0: none of this kind does. */
static int draw_layer(net *n, int i, shape in, int positive)
{
    static const kind flat[] = {DENSE, DENSE, ACTIVATION, DROPOUT, ADD, DENSE};
    static const kind line[] = {CONV1D,     FLATTEN, UPSAMPLE1D, MAXPOOL1D,  AVGPOOL1D,
                                ACTIVATION, DROPOUT, ADD,        GLOBALPOOL, CONV1D};
    static const kind plane[] = {CONV2D,     FLATTEN, UPSAMPLE2D, MAXPOOL2D,  AVGPOOL2D,
                                 ACTIVATION, DROPOUT, ADD,        GLOBALPOOL, CONV2D};
    layer *l = &n->layer[i];
    shape out = in;
    char text[6000];
    int k, two, d, size[2], named;
    l->kind = in.rank == 1 ? flat[attack_index(6)] : in.rank == 2 ? line[attack_index(10)] : plane[attack_index(10)];
    if (i > 1 && attack_one_in(4)) l->kind = ADD; /* where something fits */
    l->act = 0;
    l->from = -2;
    two = in.rank == 3;
    memcpy(text, n->text, sizeof text);
    named = l->kind <= CONV2D || attack_one_in(3);
    snprintf(l->name, sizeof l->name, "%c%d", named ? 'a' + i : 'x', i);
    text_add(n, "%s{\"type\":\"%s\"", n->text[0] == '[' && n->text[1] == 0 ? "" : ",", kind_name[l->kind]);
    if (named) text_add(n, ",\"name\":\"%s\"", l->name);
    else l->name[0] = 0;
    size[0] = in.h;
    size[1] = in.w;
    if (!two) size[0] = size[1];
    switch (l->kind) {
    case DENSE:
        l->units = attack_one_in(3) && in.c <= 200 ? in.c : (int)attack_int(1, 200);
        if (attack_one_in(2)) text_add(n, ",\"units\":%d", l->units);
        l->bias = !attack_one_in(4);
        if (!l->bias) text_add(n, ",\"bias\":false");
        draw_activation(n, l);
        l->weight_shape[0] = (size_t)l->units;
        l->weight_shape[1] = (size_t)in.c;
        out.c = l->units;
        break;
    case CONV1D:
    case CONV2D:
        l->units = attack_one_in(3) ? in.c : (int)attack_int(1, 40); /* as many as before: may be added */
        l->same = attack_one_in(3);
        for (d = 0; d < 2; ++d) {
            l->zeros[d] = l->same || !attack_one_in(3) ? 0 : (int)attack_int(1, 6);
            l->k[d] = (int)attack_int(1, size[d] + 2 * l->zeros[d] < 7 ? size[d] + 2 * l->zeros[d] : 7);
            if (attack_one_in(3) && (l->same || size[d] + 2 * l->zeros[d] >= 3)) l->k[d] = 3; /* the usual one */
            l->s[d] = attack_one_in(3) ? (int)attack_int(1, 4) : 1;
            if (!two || attack_one_in(2)) {
                l->zeros[1] = l->zeros[0];
                l->k[1] = l->k[0];
                l->s[1] = l->s[0];
                if (l->k[1] <= size[1] + 2 * l->zeros[1]) break;
                l->k[1] = l->k[0] = 1;
                break;
            }
        }
        if (attack_one_in(2)) text_add(n, ",\"filters\":%d", l->units);
        if (attack_one_in(2)) text_pair(n, "kernel", l->k, two);
        if (l->s[0] != 1 || l->s[1] != 1) text_pair(n, "stride", l->s, two);
        if (l->same) text_add(n, ",\"padding\":\"same\"");
        else if (l->zeros[0] || l->zeros[1]) text_pair(n, "zeros", l->zeros, two);
        l->bias = !attack_one_in(4);
        if (!l->bias) text_add(n, ",\"bias\":false");
        draw_activation(n, l);
        l->weight_shape[0] = (size_t)l->units;
        l->weight_shape[1] = (size_t)in.c;
        l->weight_shape[2] = (size_t)l->k[0];
        l->weight_shape[3] = (size_t)l->k[1];
        out.c = l->units;
        for (d = 0; d < 2; ++d) {
            const int span = size[d] + 2 * l->zeros[d] - l->k[d];
            size[d] = l->same ? (size[d] + l->s[d] - 1) / l->s[d] : span < 0 ? 0 : span / l->s[d] + 1;
        }
        out.h = two ? size[0] : 1;
        out.w = two ? size[1] : size[0];
        if (out.h < 1 || out.w < 1) break;
        break;
    case UPSAMPLE1D:
    case UPSAMPLE2D:
        l->k[0] = l->k[1] = attack_one_in(2) ? (int)attack_int(1, 5) : 2;
        if (two && attack_one_in(2)) l->k[1] = (int)attack_int(1, 3);
        if (l->k[0] != 2 || l->k[1] != 2) text_pair(n, "factor", l->k, two);
        out.h = two ? in.h * l->k[0] : 1;
        out.w = in.w * (two ? l->k[1] : l->k[0]);
        break;
    case MAXPOOL1D:
    case MAXPOOL2D:
    case AVGPOOL1D:
    case AVGPOOL2D:
        for (d = 0; d < 2; ++d) {
            l->k[d] = attack_one_in(2) ? (int)attack_int(1, 4) : 2;
            l->s[d] = l->k[d];
        }
        if (!two) l->k[1] = l->k[0];
        if (attack_one_in(2)) {
            l->s[0] = l->s[1] = (int)attack_int(1, 4);
            text_pair(n, "stride", l->s, two);
        } else {
            l->s[0] = l->k[0];
            l->s[1] = l->k[1];
        }
        if (l->k[0] != 2 || l->k[1] != 2) text_pair(n, "size", l->k, two);
        for (d = 0; d < 2; ++d) size[d] = size[d] < l->k[d] ? 0 : (size[d] - l->k[d]) / l->s[d] + 1;
        out.h = two ? size[0] : 1;
        out.w = two ? size[1] : size[0];
        break;
    case GLOBALPOOL:
        l->s[0] = l->s[1] = 1;
        out.h = out.w = 1;
        break;
    case FLATTEN:
        out.c = count_of(in);
        out.h = out.w = 1;
        out.rank = 1;
        break;
    case ACTIVATION: draw_activation(n, l); break;
    case DROPOUT:
        if (attack_one_in(2)) text_add(n, ",\"rate\":0.5");
        break;
    case ADD:
        for (k = i - 1; k >= -1; --k) {
            const shape s = k < 0 ? n->in : n->layer[k].out;
            if (k >= 0 && !n->layer[k].name[0]) continue;
            if (s.rank == in.rank && s.c == in.c && s.h == in.h && s.w == in.w) {
                l->from = k;
                if (attack_one_in(2)) break;
            }
        }
        if (l->from == -2 || (l->from == -1 && n->channels)) {
            memcpy(n->text, text, sizeof text);
            return 0;
        }
        text_add(n, ",\"from\":\"%s\"", l->from < 0 ? "input" : n->layer[l->from].name);
        draw_activation(n, l);
        break;
    }
    if (out.c < 1 || out.h < 1 || out.w < 1 || count_of(out) > VALUES || out.h > 60 || out.w > 400) {
        memcpy(n->text, text, sizeof text);
        return 0;
    }
    text_add(n, "}");
    l->out = out;
    if (l->kind <= CONV2D) draw_weights(n, l, l->kind == DENSE ? 2 : l->kind == CONV1D ? 3 : 4, positive);
    return 1;
}

static ms_status net_write(net *n, const char *input, const char *layers)
{
    ms_nn_entry metadata[3];
    ms_error error;
    ms_status status;
    metadata[0].key = "ms_nn_version";
    metadata[0].value = "1";
    metadata[1].key = "ms_nn_input";
    metadata[1].value = input;
    metadata[2].key = "ms_nn_layers";
    metadata[2].value = layers;
    free(n->file);
    n->file = NULL;
    status = ms_nn_file_write(n->tensor, (size_t)n->tensors, metadata, 3, NULL, 0, &n->size, &error);
    if (status != MS_OK) return status;
    n->file = (unsigned char *)malloc(n->size);
    return ms_nn_file_write(n->tensor, (size_t)n->tensors, metadata, 3, n->file, n->size, &n->size, &error);
}

static void input_text(const net *n, char text[80])
{
    if (n->in.rank == 1) snprintf(text, 80, "[%d]", n->in.c);
    else if (n->in.rank == 2) snprintf(text, 80, "[%d,%d]", n->in.c, n->in.w);
    else snprintf(text, 80, "[%d,%d,%d]", n->in.c, n->in.h, n->in.w);
}

static void draw_net(net *n, int positive)
{
    int wanted = (int)attack_int(0, LAYERS), tries = 0;
    shape now;
    char input[80];
    memset(n, 0, sizeof *n);
    n->in.rank = 1 + attack_index(3);
    n->in.c = (int)attack_int(1, n->in.rank == 1 ? 300 : 12);
    n->in.h = n->in.rank == 3 ? (int)attack_int(1, SIDE) : 1;
    n->in.w = n->in.rank >= 2 ? (int)attack_int(1, n->in.rank == 2 ? 100 : SIDE) : 1;
    if (count_of(n->in) > VALUES) n->in.c = 1;
    strcpy(n->text, "[");
    for (now = n->in; n->layers < wanted && tries < 20; ++tries)
        if (draw_layer(n, n->layers, now, positive)) now = n->layer[n->layers++].out;
    text_add(n, "]");
    input_text(n, input);
    if (n->layers < LAYERS) memset(&n->layer[n->layers], 0, sizeof n->layer[0]); /* the last that did not fit */
    attack_say("input %s, layers %s", input, n->text);
    if (net_write(n, input, n->text) != MS_OK) attack_fail("a file cannot be written");
}

/* ---- families ---------------------------------------------------------------------------------------------------- */

static int finite_float(float f) { return f - f == 0; }

/* The network's layers and every call against the plain loop. */
static void family_graphs(void)
{
    static net n;
    static value all[LAYERS + 1];
    ms_nn_options options = ms_nn_defaults();
    ms_error error = attack_no_error();
    ms_nn *nn = NULL;
    ms_status status;
    size_t in, out, i, k, bytes;
    float *x, *y, *again, *slopes;
    int count, smooth = 1;
    draw_net(&n, 0);
    options.simd = (ms_simd)attack_index(5);
    options.allocator = attack_allocator((size_t)1 << 28);
    if (attack_one_in(2)) options.parallel = attack_parallel();
    status = ms_nn_load(n.file, n.size, &options, &nn, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        ATTACK_CHECK(nn == NULL, "output touched on failure: nn");
        if (status != MS_UNSUPPORTED && n.layers > 0) attack_fail("a valid network is refused: %s", error.message);
        net_free(&n);
        return;
    }
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    ATTACK_CHECK(in == (size_t)count_of(n.in), "input size: %zu", in);
    ATTACK_CHECK(out == (size_t)count_of(n.layers ? n.layer[n.layers - 1].out : n.in), "output size: %zu", out);
    ATTACK_CHECK(ms_nn_layer_count(nn) == n.layers, "layer count: %d", ms_nn_layer_count(nn));
    count = (int)attack_int(1, in * out < 20000 ? 60 : 3);
    x = (float *)malloc((in + 2 * out) * (size_t)count * sizeof(float) + 1);
    y = x + in * (size_t)count;
    again = y + out * (size_t)count;
    attack_fill(x, in * (size_t)count, -1, 1);
    memset(y, 0x7f, 2 * out * (size_t)count * sizeof(float));
    bytes = ms_nn_workspace_size(nn, MS_NN_FORWARD, count);
    {
        unsigned char *work = (unsigned char *)malloc(bytes + 1); /* not aligned; of this size to the byte */
        status = ms_nn_forward(nn, count, x, y, attack_one_in(2) ? NULL : work + 1);
        free(work);
    }
    ATTACK_CHECK(status == MS_OK, "forward: status %d", (int)status);
    for (k = 0; k < (size_t)count && !attack->failed; ++k) {
        static double sample[VALUES];
        for (i = 0; i < in; ++i) sample[i] = (double)x[k * in + i];
        forward(&n, sample, all);
        for (i = 0; i < out && !attack->failed; ++i) {
            const value *want = &all[n.layers];
            const double d = fabs((double)y[k * out + i] - want->v[i]);
            if (!finite_float(y[k * out + i])) attack_fail("not finite of finite: output %zu", i);
            else if (!(d <= want->e[i] * 2 + 1e-30))
                attack_fail("wrong output: %zu is %.9g, the plain loop has %.9g +- %.1e", i, (double)y[k * out + i],
                            want->v[i], want->e[i]);
        }
        if (k < 4) {
            ms_nn_forward(nn, 1, x + k * in, again, NULL);
            ATTACK_CHECK(memcmp(again, y + k * out, out * sizeof(float)) == 0, "another value alone than in a batch");
        }
    }
    for (i = 0; i < (size_t)n.layers; ++i)
        smooth &= n.layer[i].act != 1 && n.layer[i].act != 2 && n.layer[i].act != 3 && n.layer[i].kind != MAXPOOL1D &&
            n.layer[i].kind != MAXPOOL2D;
    if (in * out <= 40000 && !attack->failed) {
        slopes = (float *)malloc(in * out * sizeof(float) + 1);
        status = ms_nn_jacobian(nn, x, again, slopes, NULL);
        ATTACK_CHECK(status == MS_OK, "jacobian: status %d", (int)status);
        ATTACK_CHECK(memcmp(again, y, out * sizeof(float)) == 0, "the jacobian's value has other bits");
        if (smooth) { /* along one direction, by central differences in double */
            static double at[VALUES], along[VALUES], up[VALUES];
            const double h = 1e-5;
            uint64_t state = attack_draw();
            double most = 0, worst = 0;
            for (i = 0; i < in; ++i) along[i] = (double)(attack_mix(&state) >> 11) / 9007199254740992.0 - 0.5;
            for (i = 0; i < in; ++i) at[i] = (double)x[i] + h * along[i];
            forward(&n, at, all);
            memcpy(up, all[n.layers].v, sizeof up);
            for (i = 0; i < in; ++i) at[i] = (double)x[i] - h * along[i];
            forward(&n, at, all);
            for (i = 0; i < out; ++i) {
                double sum = 0, size = 0, want = (up[i] - all[n.layers].v[i]) / (2 * h);
                for (k = 0; k < in; ++k) {
                    sum += (double)slopes[i * in + k] * along[k];
                    size += fabs((double)slopes[i * in + k] * along[k]);
                }
                if (size > most) most = size;
                if (!(fabs(sum - want) <= worst)) worst = fabs(sum - want);
            }
            /* rounding of the differences 1e-11 of the value; their curvature and floats take the rest */
            ATTACK_CHECK(worst <= 2e-3 * most + 1e-3, "wrong slopes: off by %.3g of %.3g", worst, most);
        }
        free(slopes);
    }
    free(x);
    ms_nn_destroy(nn);
    net_free(&n);
}

/* A collapsed network against the plain loop: the length of the residual, and its gradient against that by the Jacobian
   of the outputs. */
static void family_collapse(void)
{
    static net n;
    static value all[LAYERS + 1];
    static double sample[VALUES];
    ms_nn_options options = ms_nn_defaults();
    ms_error error = attack_no_error();
    ms_nn *nn = NULL;
    ms_nn_collapse *c = NULL;
    size_t in, out, i, k, m;
    double length = 0, wanted = 0, size = 0, doubt = 0, steepest = 0, *residual, *jacobian;
    float *x, *y, *t, *weight, *slopes;
    draw_net(&n, 0);
    options.simd = (ms_simd)attack_index(5);
    options.allocator = attack_allocator((size_t)1 << 28);
    if (ms_nn_load(n.file, n.size, &options, &nn, &error) != MS_OK) {
        net_free(&n);
        return;
    }
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    x = (float *)calloc(in + 3 * out + in * out + 1, sizeof(float));
    y = x + in, t = y + out, weight = t + out, slopes = weight + out;
    attack_fill(x, in, -1, 1);
    attack_fill(t, out, -3, 3);
    for (i = 0; i < out; ++i) weight[i] = attack_one_in(3) ? 0 : (float)attack_log(1e-4, 1e4);
    if (attack_one_in(3))
        for (i = 0; i < out; ++i) weight[i] = 1;
    if (in * out <= 40000 && ms_nn_collapse_create(nn, weight, &c, &error) == MS_OK) {
        m = ms_nn_collapse_features(c) + 1;
        residual = (double *)malloc((1 + in) * m * sizeof(double));
        jacobian = residual + m;
        ATTACK_CHECK(ms_nn_collapse_residual(c, x, residual, NULL, NULL) == MS_INVALID_ARGUMENT,
                     "no target, and it runs");
        ATTACK_CHECK(ms_nn_collapse_target(c, t, &error) == MS_OK, "no target: %s", error.message);
        ATTACK_CHECK(ms_nn_collapse_residual(c, x, residual, jacobian, NULL) == MS_OK, "no residual");
        for (i = 0; i < m; ++i) length += residual[i] * residual[i];
        for (i = 0; i < in; ++i) sample[i] = (double)x[i];
        forward(&n, sample, all);
        for (i = 0; i < out; ++i) {
            const double v = all[n.layers].v[i], d = v - (double)t[i], e = all[n.layers].e[i];
            wanted += (double)weight[i] * d * d;
            size += (double)weight[i] * (v * v + (double)t[i] * (double)t[i]);
            doubt += (double)weight[i] * e * e;
        }
        doubt = 8 * sqrt(doubt) + 1e-6 * sqrt(size);
        ATTACK_CHECK(fabs(sqrt(length) - sqrt(wanted)) <= doubt,
                     "a residual of length %.9g, the plain loop has %.9g +- %.1e", sqrt(length), sqrt(wanted), doubt);
        ms_nn_jacobian(nn, x, y, slopes, NULL);
        for (i = 0; i < in * out; ++i) /* slopes that cancel leave a float's rounding of others */
            steepest = fmax(steepest, (double)weight[i / in] * (double)slopes[i] * (double)slopes[i]);
        for (k = 0; k < in && !attack->failed; ++k) {
            double ours = 0, theirs = 0, steep = 1e-10 * steepest, kept = 0;
            for (i = 0; i < m; ++i)
                ours += residual[i] * jacobian[i * in + k], kept += jacobian[i * in + k] * jacobian[i * in + k];
            for (i = 0; i < out; ++i) {
                const double s = (double)slopes[i * in + k];
                theirs += (double)weight[i] * ((double)y[i] - (double)t[i]) * s;
                steep += (double)weight[i] * s * s;
            }
            if (!(fabs(ours - theirs) <= 1e-4 * sqrt(fmax(steep, kept)) * (sqrt(wanted) + sqrt(size)) +
                      (sqrt(steep) + sqrt(wanted)) * doubt)) /* a slope is as uncertain as an output of inputs to 1 */
                attack_fail("a gradient of %.9g, that of the outputs is %.9g", ours, theirs);
        }
        free(residual);
    }
    ms_nn_collapse_destroy(c);
    free(x);
    ms_nn_destroy(nn);
    net_free(&n);
}

/* One infinite or huge input and positive weights: infinite where the plain loop is, finite where it is. */
static void family_infinities(void)
{
    static net n;
    static value all[LAYERS + 1];
    static double sample[VALUES];
    ms_nn_options options = ms_nn_defaults();
    ms_error error;
    ms_nn *nn;
    size_t in, out, i;
    float *x, *y;
    draw_net(&n, 1);
    options.simd = (ms_simd)attack_index(5);
    if (ms_nn_load(n.file, n.size, &options, &nn, &error) != MS_OK) {
        net_free(&n);
        return;
    }
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    x = (float *)malloc((in + out) * sizeof(float) + 1);
    y = x + in;
    attack_fill(x, in, 0, 1);
    i = (size_t)attack_index((int)in);
    x[i] = attack_odd_float();
    attack_say("; input %zu is %g", i, (double)x[i]);
    for (i = 0; i < in; ++i) sample[i] = (double)x[i];
    forward(&n, sample, all);
    ms_nn_forward(nn, 1, x, y, NULL);
    for (i = 0; i < out && !attack->failed; ++i) {
        const double want = all[n.layers].v[i];
        const int layers_finite = fabs(want) < 1e30;
        int k, far = 0, j;
        for (k = 0; k <= n.layers; ++k) /* near overflow in floats, and what comes of NaN, is not compared */
            for (j = 0; j < count_of(k ? n.layer[k - 1].out : n.in); ++j) {
                const double v = fabs(all[k].v[j]);
                far |= !(v < 1e30) && !(v > 1e300);
            }
        if (far || want != want) continue;
        if (layers_finite)
            ATTACK_CHECK(finite_float(y[i]), "not finite: output %zu is %g for %g", i, (double)y[i], want);
        else ATTACK_CHECK((double)y[i] == want, "infinity lost: output %zu is %g for %g", i, (double)y[i], want);
    }
    free(x);
    ms_nn_destroy(nn);
    net_free(&n);
}

/* Everything that a file may be used for, with a real ms_error and little memory. */
static void use(const unsigned char *bytes, size_t size, int must_fail)
{
    ms_nn_options options = ms_nn_defaults();
    ms_error error = attack_no_error();
    ms_nn *nn = NULL;
    ms_nn_file *file = NULL;
    ms_status status;
    size_t in, out, i;
    options.simd = (ms_simd)attack_index(5);
    options.allocator = attack_allocator((size_t)1 << 24);
    status = ms_nn_file_open(bytes, size, &options, &file, &error);
    if (status == MS_OK) {
        unsigned sum = 0;
        for (i = 0; i < ms_nn_file_tensor_count(file); ++i) {
            const ms_nn_tensor *t = ms_nn_file_tensor(file, i);
            if (t->bytes) sum += ((const unsigned char *)t->data)[t->bytes - 1] + *(const unsigned char *)t->data;
            ATTACK_CHECK(ms_nn_file_find(file, t->name) == t, "a tensor is not found by its name");
        }
        ATTACK_CHECK(sum != 1u || i, "no tensor has a sum");
        ms_nn_file_close(file);
    } else {
        attack_check_error(status, &error);
        ATTACK_CHECK(file == NULL, "output touched on failure: file");
    }
    error = attack_no_error();
    status = ms_nn_load(bytes, size, &options, &nn, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        ATTACK_CHECK(nn == NULL, "output touched on failure: nn");
        return;
    }
    if (must_fail) attack_fail("an invalid network loads");
    in = ms_nn_input_size(nn);
    out = ms_nn_output_size(nn);
    error = attack_no_error();
    if ((status = ms_nn_check_weights(nn, &error)) != MS_OK) attack_check_error(status, &error);
    if (in <= 100000 && out <= 100000) {
        const size_t bytes_needed = ms_nn_workspace_size(nn, MS_NN_FORWARD, 1);
        float *x = (float *)malloc((in + out + 1) * sizeof(float)), *y = x + in;
        for (i = 0; i < in; ++i) x[i] = (float)i;
        if (bytes_needed <= 1 << 24) {
            unsigned char *work = (unsigned char *)attack_alloc(&attack_heap, bytes_needed);
            double cost = 0;
            int k;
            for (k = 0; k < ms_nn_layer_count(nn); ++k) cost += (double)ms_nn_layer_at(nn, k).multiply_adds;
            if (work != NULL) {
                if (cost < 1e8) ms_nn_forward(nn, 1, x, y, work);
                attack_release(&attack_heap, work, bytes_needed);
            }
            if (cost * (double)in < 1e8 && in * out < 100000) {
                float *slopes = (float *)malloc((in * out + 1) * sizeof(float));
                status = ms_nn_jacobian(nn, x, y, slopes, NULL);
                ATTACK_CHECK(status == MS_OK || status == MS_OUT_OF_MEMORY, "jacobian: status %d", (int)status);
                free(slopes);
            }
        }
        if (in < 256 && out < 256) {
            ms_nn_collapse *c = NULL;
            error = attack_no_error();
            status = ms_nn_collapse_create(nn, NULL, &c, &error);
            if (status == MS_OK) {
                const size_t m = ms_nn_collapse_features(c) + 1;
                double *r = (double *)malloc(m * (in + 1) * sizeof(double));
                for (i = 0; i < out; ++i) y[i] = 1;
                if (ms_nn_collapse_target(c, y, &error) == MS_OK) ms_nn_collapse_residual(c, x, r, r + m, NULL);
                free(r);
                ms_nn_collapse_destroy(c);
            } else attack_check_error(status, &error);
        }
        free(x);
    }
    ms_nn_destroy(nn);
}

static const char *const words[] = {"dense",
                                    "conv1d",
                                    "conv2d",
                                    "conv1d_transpose",
                                    "conv2d_transpose",
                                    "upsample1d",
                                    "upsample2d",
                                    "maxpool1d",
                                    "maxpool2d",
                                    "avgpool1d",
                                    "avgpool2d",
                                    "globalpool",
                                    "flatten",
                                    "activation",
                                    "dropout",
                                    "add",
                                    "concat",
                                    "shared_channels",
                                    "name",
                                    "units",
                                    "bias",
                                    "filters",
                                    "kernel",
                                    "stride",
                                    "padding",
                                    "zeros",
                                    "dilation",
                                    "groups",
                                    "extra",
                                    "factor",
                                    "mode",
                                    "align_corners",
                                    "size",
                                    "order",
                                    "rate",
                                    "from",
                                    "inputs",
                                    "alpha",
                                    "same",
                                    "valid",
                                    "linear",
                                    "nearest",
                                    "relu",
                                    "leaky_relu",
                                    "elu",
                                    "tanh",
                                    "sigmoid",
                                    "softplus",
                                    "silu",
                                    "gelu",
                                    "input",
                                    "true",
                                    "false",
                                    "null",
                                    "channels_first",
                                    "channels_last",
                                    "before",
                                    "after",
                                    "a0",
                                    "b1",
                                    "c2",
                                    "F32",
                                    "F16",
                                    "I8",
                                    "F64",
                                    "BF16",
                                    "F8_E5M2",
                                    "F4",
                                    "BOOL",
                                    "shape",
                                    "data_offsets",
                                    "dtype",
                                    "__metadata__",
                                    "a0.weight",
                                    "b1.bias"};

/* A number as a file may hold it: small, large, around the powers of two, far too large. */
static void number_text(char text[40])
{
    if (attack_one_in(10)) {
        static const char *const odd[] = {"-1",
                                          "0",
                                          "1e3",
                                          "0.5",
                                          "18446744073709551615",
                                          "18446744073709551616",
                                          "4294967296",
                                          "01",
                                          "1e400",
                                          "1e20",
                                          "1e-20",
                                          "999.9999999",
                                          "",
                                          "[1,2]",
                                          "[]",
                                          "\"1\"",
                                          "-0"};
        strcpy(text, odd[attack_index((int)(sizeof odd / sizeof *odd))]);
    } else snprintf(text, 40, "%lld", (long long)attack_int(0, attack_one_in(2) ? 8 : (int64_t)1 << 34));
}

/* Changes a JSON text in one place; its size stays below `capacity`. */
static void damage(char *text, size_t capacity)
{
    const size_t length = strlen(text);
    char piece[200];
    size_t at, end, k;
    if (length == 0) return;
    at = (size_t)attack_index((int)length);
    piece[0] = 0;
    end = at;
    switch (attack_index(8)) {
    case 0:
    case 1: /* a number by another */
        for (k = 0; k < length && !(text[at] >= '0' && text[at] <= '9'); ++k) at = (at + 1) % length;
        while (at > 0 && text[at - 1] >= '0' && text[at - 1] <= '9') --at;
        for (end = at; text[end] >= '0' && text[end] <= '9';) ++end;
        number_text(piece);
        break;
    case 2:
    case 3: /* a word by another */
        for (k = 0; k < length && text[at] != '"'; ++k) at = (at + 1) % length;
        if (text[at] != '"') return;
        ++at;
        for (end = at; text[end] && text[end] != '"';) ++end;
        strcpy(piece, words[attack_index((int)(sizeof words / sizeof *words))]);
        break;
    case 4: /* a field more */
        for (k = 0; k < length && text[at] != '}'; ++k) at = (at + 1) % length;
        if (text[at] != '}') return;
        end = at;
        {
            char number[40];
            number_text(number);
            snprintf(piece, sizeof piece, ",\"%s\":%s", words[attack_index((int)(sizeof words / sizeof *words))],
                     number);
        }
        break;
    case 5: /* without some of it */
        end = at + (size_t)attack_int(1, 40);
        if (end > length) end = length;
        break;
    case 6: /* some of it twice */
        end = at + (size_t)attack_int(1, 60);
        if (end > length) end = length;
        snprintf(piece, sizeof piece, "%.*s", (int)(end - at), text + at);
        end = at;
        break;
    default: /* one byte */
        piece[0] = (char)(1 + attack_index(255));
        piece[1] = 0;
        end = at + (size_t)attack_one_in(2);
    }
    k = strlen(piece);
    if (length + k >= capacity) return;
    memmove(text + at + k, text + end, length - end + 1);
    memcpy(text + at, piece, k);
}

/* A valid network whose layer list, input or whole header is damaged. */
static void family_files(void)
{
    static net n;
    static char text[8000];
    char input[200];
    int i, times = 1 + attack_index(3), where = attack_index(5);
    draw_net(&n, 0);
    input_text(&n, input);
    if (where == 0 && n.file != NULL) { /* the header itself */
        uint64_t header = 0;
        unsigned char *file;
        for (i = 7; i >= 0; --i) header = header << 8 | n.file[i];
        if (header < 7000 && header + 8 <= n.size) {
            size_t length;
            memcpy(text, n.file + 8, (size_t)header);
            text[header] = 0;
            for (i = 0; i < times; ++i) damage(text, sizeof text);
            length = strlen(text);
            file = (unsigned char *)malloc(8 + length + n.size);
            memcpy(file + 8, text, length);
            memcpy(file + 8 + length, n.file + 8 + header, n.size - 8 - (size_t)header);
            for (i = 0; i < 8; ++i) file[i] = (unsigned char)((uint64_t)length >> 8 * i);
            attack_say("; header %s", text);
            use(file, 8 + length + n.size - 8 - (size_t)header, 0);
            free(file);
        }
    } else if (where == 1 && n.file != NULL) { /* bytes, or an end too early */
        size_t size = attack_one_in(2) ? (size_t)attack_index((int)n.size + 1) : n.size;
        unsigned char *file = (unsigned char *)malloc(size + 1);
        memcpy(file, n.file, size);
        for (i = 0; i < times && size; ++i)
            file[attack_index((int)(size < 4096 ? size : 4096))] = (unsigned char)attack_draw();
        use(file, size, 0);
        free(file);
    } else {
        strcpy(text, n.text);
        for (i = 0; i < times; ++i)
            if (where == 2 && attack_one_in(2)) damage(input, sizeof input);
            else damage(text, sizeof text);
        if (net_write(&n, input, text) == MS_OK) {
            attack_say("\n     input %s, layers %s", input, text);
            use(n.file, n.size, 0);
        }
    }
    net_free(&n);
}

/* Valid networks of sizes up to what numbers hold: refused, or run in the memory that they say. */
static void family_sizes(void)
{
    static net n;
    layer *l = &n.layer[0];
    char input[80];
    const int two = attack_one_in(2), what = attack_index(4);
    int d;
    memset(&n, 0, sizeof n);
    n.in.rank = two ? 3 : 2;
    n.in.c = (int)attack_int(1, 4);
    n.in.h = two ? (int)attack_int(1, 20) : 1;
    n.in.w = (int)attack_int(1, 40);
    n.layers = 1;
    strcpy(l->name, "a0");
    l->units = (int)attack_int(1, 4);
    l->bias = 1;
    for (d = 0; d < 2; ++d) l->k[d] = (int)attack_int(1, 4);
    strcpy(n.text, "[");
    if (what < 2) {
        const int64_t high = attack_one_in(2) ? 70000 : (int64_t)1 << 33;
        int64_t v[4];
        for (d = 0; d < 4; ++d)
            v[d] = attack_one_in(2) ? ((int64_t)1 << attack_index(34)) + attack_index(5) - 2 : attack_int(1, high);
        if (v[0] < 0) v[0] = 0;
        text_add(&n, "{\"type\":\"%s\",\"name\":\"a0\"", two ? "conv2d" : "conv1d");
        if (!attack_one_in(3)) text_add(&n, ",\"zeros\":%lld", (long long)v[0]);
        if (!attack_one_in(3)) text_add(&n, ",\"dilation\":%lld", (long long)(attack_one_in(2) ? 2 * v[0] + 1 : v[1]));
        if (attack_one_in(3)) text_add(&n, ",\"stride\":%lld", (long long)v[2]);
        text_add(&n, "}");
        l->kind = two ? CONV2D : CONV1D;
        l->weight_shape[0] = (size_t)l->units;
        l->weight_shape[1] = (size_t)n.in.c;
        l->weight_shape[2] = (size_t)l->k[0];
        l->weight_shape[3] = (size_t)l->k[1];
        draw_weights(&n, l, two ? 4 : 3, 0);
    } else {
        int k, layers = 1 + attack_index(4);
        for (k = 0; k < layers; ++k) {
            text_add(&n, "%s{\"type\":\"%s\",\"%s\":%lld", k ? "," : "",
                     what == 2 ? (two ? "upsample2d" : "upsample1d")
                         : two ? "maxpool2d"
                               : "avgpool1d",
                     what == 2 ? "factor" : "size", (long long)attack_int(1, (int64_t)1 << (1 + attack_index(33))));
            text_add(&n, "}");
        }
    }
    text_add(&n, "]");
    input_text(&n, input);
    attack_say("input %s, layers %s, weights [%zu][%zu][%zu][%zu]", input, n.text, l->weight_shape[0],
               l->weight_shape[1], l->weight_shape[2], l->weight_shape[3]);
    if (net_write(&n, input, n.text) == MS_OK) use(n.file, n.size, 0);
    net_free(&n);
}

/* A valid network with one fault whose refusal the grammar asks for. */
static void family_faults(void)
{
    static net n;
    static char text[8000], copy[8000];
    char input[80], *at;
    int fault = attack_index(5), i;
    draw_net(&n, 0);
    input_text(&n, input);
    strcpy(text, n.text);
    copy[0] = 0;
    switch (fault) {
    case 0: /* two numbers where the list has one */
        for (i = 0; i < 6; ++i) {
            static const char *const keys[] = {
                "\"units\":", "\"filters\":", "\"stride\":", "\"kernel\":", "\"size\":", "\"factor\":"};
            char *type;
            at = strstr(text, keys[i]);
            if (at == NULL) continue;
            for (type = at; *type != '{';) --type; /* of one dimension, or a count */
            if (i > 1 && strstr(type, "1d\"") != type + strcspn(type, "1")) continue;
            if (i > 1 && strcspn(type, "}") < (size_t)(strstr(type, "1d\"") - type)) continue;
            at += strlen(keys[i]);
            if (*at == '[') continue;
            snprintf(copy, sizeof copy, "%.*s[%.*s,%d]%s", (int)(at - text), text, (int)strspn(at, "0123456789"), at,
                     1 + attack_index(99), at + strspn(at, "0123456789"));
            break;
        }
        break;
    case 1: /* an addition of another shape */
        if (n.layers > 0) {
            const shape last = n.layer[n.layers - 1].out;
            for (i = -1; i < n.layers - 1; ++i) {
                const shape s = i < 0 ? n.in : n.layer[i].out;
                if (i >= 0 && !n.layer[i].name[0]) continue;
                if (s.c == last.c && s.h == last.h && s.w == last.w) continue;
                if (count_of(s) == count_of(last) && s.rank == last.rank) continue;
                if (s.rank != last.rank && count_of(s) == count_of(last)) continue; /* flat: see the grammar */
                snprintf(copy, sizeof copy, "%.*s,{\"type\":\"add\",\"from\":\"%s\"}]", (int)strlen(text) - 1, text,
                         i < 0 ? "input" : n.layer[i].name);
                if (attack_one_in(2)) break;
            }
        }
        break;
    case 2: /* a field that no layer has */
        at = strchr(text, '}');
        if (at != NULL) snprintf(copy, sizeof copy, "%.*s,\"colour\":1%s", (int)(at - text), text, at);
        break;
    case 3: /* a tensor that is not there */
        snprintf(copy, sizeof copy, "%.*s%s{\"type\":\"flatten\"},{\"type\":\"dense\",\"name\":\"nobody\"}]",
                 (int)strlen(text) - 1, text, n.layers ? "," : "");
        break;
    default: /* the same text twice behind it */ snprintf(copy, sizeof copy, "%.3900s %.3900s", text, text);
    }
    if (copy[0] && net_write(&n, input, copy) == MS_OK) {
        attack_say("; with a fault (%d): %s", fault, copy);
        use(n.file, n.size, 1);
    }
    net_free(&n);
}

/* The reason of a refusal stands in its sentence, however long the names are. */
static void family_names(void)
{
    static net n;
    char input[80], layers[1200], name[400], sentence[2][240];
    const int fault = attack_index(4), line = attack_index(2);
    int k, length = (int)attack_int(20, 240), i; /* the grammar's limit */
    ms_nn_options options = ms_nn_defaults();
    for (k = 0; k < 2; ++k) {
        ms_error error = attack_no_error();
        ms_nn *nn = NULL;
        layer *l = &n.layer[0];
        memset(&n, 0, sizeof n);
        n.in.rank = line ? 2 : 1;
        n.in.c = 2;
        n.in.h = 1;
        n.in.w = line ? 5 : 1;
        n.layers = 1;
        for (i = 0; i < (k ? length : 1); ++i) name[i] = 'q';
        name[i] = 0;
        strcpy(l->name, name);
        l->bias = 1;
        l->weight_shape[0] = 3;
        l->weight_shape[1] = fault == 0 ? 3 : 2;
        l->weight_shape[2] = 1;
        draw_weights(&n, l, line ? 3 : 2, 0);
        n.tensor[0].dtype = MS_NN_F32;
        if (l->dtype != MS_NN_F32) {
            net_free(&n);
            return;
        }
        snprintf(layers, sizeof layers, "[{\"type\":\"%s\",\"name\":\"%s\"%s}]", line ? "conv1d" : "dense", name,
                 fault == 1       ? ",\"activation\":\"square\""
                     : fault == 2 ? (line ? ",\"filters\":7" : ",\"units\":7")
                     : fault == 3 ? "},{\"type\":\"add\",\"from\":\"nobody\""
                                  : "");
        input_text(&n, input);
        if (net_write(&n, input, layers) != MS_OK || ms_nn_load(n.file, n.size, &options, &nn, &error) == MS_OK) {
            attack_fail("an invalid network loads: %s", layers);
            ms_nn_destroy(nn);
        }
        memcpy(sentence[k], error.message, sizeof sentence[k]);
        net_free(&n);
    }
    /* the last 12 characters of the short sentence, without the name */
    for (i = 0; i < 240 && sentence[0][i];) ++i;
    if (i > 12 && strchr(sentence[0] + i - 12, 'q') == NULL && strstr(sentence[1], sentence[0] + i - 12) == NULL &&
        strncmp(sentence[0], sentence[1], 40) != 0)
        attack_fail("the reason is lost: with a name of %d characters '%.239s', with one '%.239s'", length, sentence[1],
                    sentence[0]);
}

int main(int argc, char **argv)
{
    static const attack_family families[] = {{"graphs", family_graphs},    {"files", family_files},
                                             {"sizes", family_sizes},      {"faults", family_faults},
                                             {"names", family_names},      {"infinities", family_infinities},
                                             {"collapse", family_collapse}};
    return attack_main(argc, argv, families, (int)(sizeof families / sizeof *families));
}
