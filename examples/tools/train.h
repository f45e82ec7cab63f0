/* What examples/tools/train.c is made of: matrix products, principal components, small dense networks with their
   gradients, Adam. No dependency but POSIX threads; C99 and C++11. Matrices are row-major floats, sums over many rows
   are in double.

     train_pool pool;
     train_pool_start(&pool, 2);                             the calling thread takes part
     train_net net;
     train_net_make(&net, sizes, 5, 0, &seed);               sizes [5]: inputs, three hidden layers, outputs
     train_forward(&net, &work, n, x, act);                  act[l] [n][sizes[l + 1]], and room for as much behind it
     train_backward(&net, &work, n, x, act, g, spare, grad, g_x);

   The work is cut by the problem alone: the number of threads changes no result. */
#ifndef EXAMPLES_TRAIN_H
#define EXAMPLES_TRAIN_H
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* --- random numbers (splitmix64) --- */

static inline uint64_t train_bits(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* In [0, 1). */
static inline float train_uniform(uint64_t *state) { return (float)(train_bits(state) >> 40) / 16777216.0f; }

static inline float train_normal(uint64_t *state)
{
    double u = ((double)(train_bits(state) >> 11) + 0.5) / 9007199254740992.0;
    return (float)(sqrt(-2 * log(u)) * cos(6.283185307179586 * (double)train_uniform(state)));
}

/* --- threads --- */

typedef struct train_pool {
    int threads, stop, busy, next, count;
    unsigned call;
    void (*task)(void *context, int index);
    void *context;
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    pthread_t thread[64];
} train_pool;

/* Takes tasks until none is left; the lock is held before and after. */
static inline void train__take(train_pool *p)
{
    while (p->next < p->count) {
        int i = p->next++;
        pthread_mutex_unlock(&p->lock);
        p->task(p->context, i);
        pthread_mutex_lock(&p->lock);
    }
}

static inline void *train__thread(void *argument)
{
    train_pool *p = (train_pool *)argument;
    unsigned seen = 0;
    pthread_mutex_lock(&p->lock);
    for (;;) {
        while (p->call == seen && !p->stop) pthread_cond_wait(&p->work, &p->lock);
        if (p->stop) break;
        seen = p->call;
        ++p->busy;
        train__take(p);
        if (--p->busy == 0) pthread_cond_signal(&p->done);
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

/* task(context, i) for every i in [0, count), in any order. Not from within a task. */
static inline void train_run(train_pool *p, int count, void (*task)(void *context, int index), void *context)
{
    pthread_mutex_lock(&p->lock);
    p->task = task;
    p->context = context;
    p->next = 0;
    p->count = count;
    ++p->call;
    if (p->threads > 1) pthread_cond_broadcast(&p->work);
    train__take(p);
    while (p->busy > 0) pthread_cond_wait(&p->done, &p->lock);
    pthread_mutex_unlock(&p->lock);
}

static inline void train_pool_start(train_pool *p, int threads)
{
    memset(p, 0, sizeof *p);
    pthread_mutex_init(&p->lock, NULL);
    pthread_cond_init(&p->work, NULL);
    pthread_cond_init(&p->done, NULL);
    p->threads = 1;
    while (p->threads < threads && p->threads < 64 &&
           pthread_create(&p->thread[p->threads], NULL, train__thread, p) == 0)
        ++p->threads;
}

static inline void train_pool_stop(train_pool *p)
{
    int i;
    pthread_mutex_lock(&p->lock);
    p->stop = 1;
    pthread_cond_broadcast(&p->work);
    pthread_mutex_unlock(&p->lock);
    for (i = 1; i < p->threads; ++i) pthread_join(p->thread[i], NULL);
    pthread_mutex_destroy(&p->lock);
    pthread_cond_destroy(&p->work);
    pthread_cond_destroy(&p->done);
}

/* --- matrix products: packed blocks, tiles of 6 x 16 that stay in registers (Goto & van de Geijn 2008) --- */

enum { TRAIN_MR = 6, TRAIN_NR = 16, TRAIN_KC = 256, TRAIN_MC = 96, TRAIN_NC = 512 };

/* A thread's scratch memory; each its own. */
typedef struct train_work {
    float a[TRAIN_MC * TRAIN_KC], b[TRAIN_KC * TRAIN_NC];
} train_work;

#if defined(__GNUC__)
#define TRAIN__INLINE static inline __attribute__((always_inline))
#else
#define TRAIN__INLINE static inline
#endif

/* c [6][16] = sum over p of a [p][6] b [p][16]. x87's products are long doubles, which have no vectors. */
#if defined(__GNUC__) && __FLT_EVAL_METHOD__ != 2
typedef float train__v16 __attribute__((vector_size(64), aligned(4), may_alias));
TRAIN__INLINE void train__tile_body(int k, const float *a, const float *b, float *c)
{
    train__v16 s0 = {0}, s1 = {0}, s2 = {0}, s3 = {0}, s4 = {0}, s5 = {0}, *out = (train__v16 *)(void *)c;
    for (; k > 0; --k, a += 6, b += 16) {
        const train__v16 v = *(const train__v16 *)(const void *)b;
        s0 += a[0] * v, s1 += a[1] * v, s2 += a[2] * v;
        s3 += a[3] * v, s4 += a[4] * v, s5 += a[5] * v;
    }
    out[0] = s0, out[1] = s1, out[2] = s2, out[3] = s3, out[4] = s4, out[5] = s5;
}
#else
static inline void train__tile_body(int k, const float *a, const float *b, float *c)
{
    int i, j;
    memset(c, 0, TRAIN_MR * TRAIN_NR * sizeof *c);
    for (; k > 0; --k, a += TRAIN_MR, b += TRAIN_NR)
        for (i = 0; i < TRAIN_MR; ++i)
            for (j = 0; j < TRAIN_NR; ++j) c[i * TRAIN_NR + j] += a[i] * b[j];
}
#endif

static void train__tile_plain(int k, const float *a, const float *b, float *c) { train__tile_body(k, a, b, c); }
#if defined(__GNUC__) && defined(__x86_64__)
__attribute__((target("avx2,fma"))) static void train__tile_avx2(int k, const float *a, const float *b, float *c)
{
    train__tile_body(k, a, b, c);
}
__attribute__((target("avx512f"))) static void train__tile_avx512(int k, const float *a, const float *b, float *c)
{
    train__tile_body(k, a, b, c);
}
#endif

typedef void (*train__tile)(int k, const float *a, const float *b, float *c);

static inline train__tile train__tile_best(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return train__tile_avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return train__tile_avx2;
#endif
    return train__tile_plain;
}

/* Elements (i, j) at p[i * row + j * column]: transposes are free. */
typedef struct train_matrix {
    const float *p;
    size_t row, column;
} train_matrix;

static inline train_matrix train_rows(const float *p, size_t row)
{
    train_matrix m;
    m.p = p;
    m.row = row;
    m.column = 1;
    return m;
}

static inline train_matrix train_transposed(const float *p, size_t row)
{
    train_matrix m;
    m.p = p;
    m.row = 1;
    m.column = row;
    return m;
}

static inline int train__least(int a, int b) { return a < b ? a : b; }

/* Panels of `width` rows (of a) or columns (of b), zeros behind the last. */
static inline void train__pack(train_matrix m, int count, int k, int width, float *to)
{
    int panel, i, p;
    for (panel = 0; panel < count; panel += width) {
        int some = train__least(width, count - panel);
        const float *from = m.p + (size_t)panel * m.row;
        for (p = 0; p < k; ++p, from += m.column, to += width) {
            for (i = 0; i < some; ++i) to[i] = from[(size_t)i * m.row];
            for (; i < width; ++i) to[i] = 0;
        }
    }
}

/* c [m][n], rows ldc apart, = (add: +=) a [m][k] b [k][n]. */
static inline void train_product(train_work *w, int m, int n, int k, train_matrix a, train_matrix b, float *c,
                                 size_t ldc, int add)
{
    const train__tile tile = train__tile_best();
    float s[TRAIN_MR * TRAIN_NR];
    int j0, p0, i0, i, j, r, q;
    for (j0 = 0; j0 < n; j0 += TRAIN_NC)
        for (p0 = 0; p0 < k; p0 += TRAIN_KC) {
            int columns = train__least(TRAIN_NC, n - j0), depth = train__least(TRAIN_KC, k - p0),
                fresh = !add && p0 == 0;
            train_matrix bt;
            bt.p = b.p + (size_t)p0 * b.row + (size_t)j0 * b.column;
            bt.row = b.column;
            bt.column = b.row;
            train__pack(bt, columns, depth, TRAIN_NR, w->b);
            for (i0 = 0; i0 < m; i0 += TRAIN_MC) {
                int rows = train__least(TRAIN_MC, m - i0);
                train_matrix at = a;
                at.p += (size_t)i0 * a.row + (size_t)p0 * a.column;
                train__pack(at, rows, depth, TRAIN_MR, w->a);
                for (j = 0; j < columns; j += TRAIN_NR)
                    for (i = 0; i < rows; i += TRAIN_MR) {
                        int high = train__least(TRAIN_MR, rows - i), wide = train__least(TRAIN_NR, columns - j);
                        float *to = c + (size_t)(i0 + i) * ldc + (size_t)(j0 + j);
                        tile(depth, w->a + i * depth, w->b + j * depth, s);
                        for (r = 0; r < high; ++r, to += ldc)
                            if (fresh)
                                for (q = 0; q < wide; ++q) to[q] = s[r * TRAIN_NR + q];
                            else
                                for (q = 0; q < wide; ++q) to[q] += s[r * TRAIN_NR + q];
                    }
            }
        }
}

/* --- dense networks --- */

enum { TRAIN_LAYERS = 8 };

typedef struct train_net {
    int layers, sigmoid, silu; /* the last layer is linear, or sigmoids; those before it ELUs, or x / (1 + exp(-x)) */
    int size[TRAIN_LAYERS + 1];
    size_t at[TRAIN_LAYERS]; /* of weight [size[l + 1]][size[l]], then bias [size[l + 1]], in p */
    size_t count;
    float *p; /* [count] */
} train_net;

static inline float *train_weight(const train_net *net, int l) { return net->p + net->at[l]; }
static inline float *train_bias(const train_net *net, int l)
{
    return net->p + net->at[l] + (size_t)net->size[l] * (size_t)net->size[l + 1];
}

/* Uniform weights of deviation 1 / sqrt(3 inputs); 0: out of memory. free(net->p) ends it. */
static inline int train_net_make(train_net *net, const int *sizes, int count, int sigmoid, uint64_t *seed)
{
    int l;
    size_t i;
    memset(net, 0, sizeof *net);
    net->layers = count - 1;
    net->sigmoid = sigmoid;
    for (l = 0; l < count; ++l) net->size[l] = sizes[l];
    for (l = 0; l < net->layers; ++l) {
        net->at[l] = net->count;
        net->count += ((size_t)sizes[l] + 1) * (size_t)sizes[l + 1];
    }
    net->p = (float *)malloc(net->count * sizeof(float));
    if (net->p == NULL) return 0;
    for (l = 0; l < net->layers; ++l)
        for (i = 0; i < ((size_t)sizes[l] + 1) * (size_t)sizes[l + 1]; ++i)
            net->p[net->at[l] + i] = (2 * train_uniform(seed) - 1) / sqrtf((float)sizes[l]);
    return 1;
}

/* exp(x) for x in [-87, 0], to 2e-7 of it; a loop of it becomes vectors. */
TRAIN__INLINE float train__exp(float x)
{
    float t = x * 1.44269504f, f, p;
    int32_t i = (int32_t)(t - 0.5f); /* nearest, since t <= 0 */
    uint32_t bits = (uint32_t)(i + 127) << 23;
    f = (x - (float)i * 0.693359375f) + (float)i * 2.12194440e-4f;
    p = 1.9875691500e-4f;
    p = p * f + 1.3981999507e-3f;
    p = p * f + 8.3334519073e-3f;
    p = p * f + 4.1665795894e-2f;
    p = p * f + 1.6666665459e-1f;
    p = p * f + 5.0000001201e-1f;
    p = p * f * f + f + 1;
    memcpy(&f, &bits, 4);
    return p * f;
}

/* y = f(y), and f's slope there. */
TRAIN__INLINE void train__bend_body(int silu, float *y, float *slope, size_t n)
{
    size_t i;
    if (silu)
        for (i = 0; i < n; ++i) {
            float v = y[i], low = v < 0 ? v : -v, e = train__exp(low > -80 ? low : -80), s = (v < 0 ? e : 1) / (1 + e);
            y[i] = v * s;
            slope[i] = s + v * s * (1 - s);
        }
    else
        for (i = 0; i < n; ++i) {
            float v = y[i], low = v < 0 ? v : 0, e = train__exp(low > -80 ? low : -80);
            y[i] = v > 0 ? v : e - 1;
            slope[i] = v > 0 ? 1 : e;
        }
}

static void train__bend_plain(int silu, float *y, float *slope, size_t n) { train__bend_body(silu, y, slope, n); }
#if defined(__GNUC__) && defined(__x86_64__)
__attribute__((target("avx2,fma"))) static void train__bend_avx2(int silu, float *y, float *slope, size_t n)
{
    train__bend_body(silu, y, slope, n);
}
#endif

static inline void train__bend(int silu, float *y, float *slope, size_t n)
{
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        train__bend_avx2(silu, y, slope, n);
        return;
    }
#endif
    train__bend_plain(silu, y, slope, n);
}

/* act[l] [n][size[l + 1]] of x [n][size[0]], behind it the slopes of the hidden layers' functions, as many. */
static inline void train_forward(const train_net *net, train_work *w, int n, const float *x, float *const *act)
{
    int l, i, j;
    for (l = 0; l < net->layers; ++l) {
        const float *bias = train_bias(net, l), *in = l ? act[l - 1] : x;
        int outputs = net->size[l + 1];
        for (i = 0; i < n; ++i) memcpy(act[l] + (size_t)i * (size_t)outputs, bias, (size_t)outputs * sizeof(float));
        train_product(w, n, outputs, net->size[l], train_rows(in, (size_t)net->size[l]),
                      train_transposed(train_weight(net, l), (size_t)net->size[l]), act[l], (size_t)outputs, 1);
        if (l + 1 < net->layers)
            train__bend(net->silu, act[l], act[l] + (size_t)n * (size_t)outputs, (size_t)n * (size_t)outputs);
        else if (net->sigmoid)
            for (j = 0; j < n * outputs; ++j) act[l][j] = 1 / (1 + expf(-act[l][j]));
    }
}

/* Gradients of what forward made. g [n][outputs] is that of the outputs; g and spare have room for n rows of the widest
   layer, and are used up. grad [net->count] is added to; NULL: not wanted. g_x [n][inputs]; NULL: not wanted. */
static inline void train_backward(const train_net *net, train_work *w, int n, const float *x, float *const *act,
                                  float *g, float *spare, float *grad, float *g_x)
{
    int l, i, j;
    for (l = net->layers - 1; l >= 0; --l) {
        int inputs = net->size[l], outputs = net->size[l + 1], last = l + 1 == net->layers;
        size_t k, many = (size_t)n * (size_t)outputs;
        float *to = l ? spare : g_x;
        const float *in = l ? act[l - 1] : x, *y = act[l];
        if (!last)
            for (k = 0; k < many; ++k) g[k] *= y[many + k];
        else if (net->sigmoid)
            for (k = 0; k < many; ++k) g[k] *= y[k] * (1 - y[k]);
        if (grad) {
            float *bias = grad + net->at[l] + (size_t)inputs * (size_t)outputs;
            train_product(w, outputs, inputs, n, train_transposed(g, (size_t)outputs), train_rows(in, (size_t)inputs),
                          grad + net->at[l], (size_t)inputs, 1);
            for (i = 0; i < n; ++i)
                for (j = 0; j < outputs; ++j) bias[j] += g[(size_t)i * (size_t)outputs + (size_t)j];
        }
        if (to)
            train_product(w, n, inputs, outputs, train_rows(g, (size_t)outputs),
                          train_rows(train_weight(net, l), (size_t)inputs), to, (size_t)inputs, 0);
        spare = g;
        g = to;
    }
}

/* --- Adam (Kingma & Ba 2015), bias-corrected --- */

typedef struct train_adam {
    float *m, *v;          /* [count], zero at first */
    double power1, power2; /* 1 at first: the betas to the number of steps */
} train_adam;

/* Parameters [from, to) of p by grad; call train_adam_count once a step before. */
static inline void train_adam_step(const train_adam *a, float rate, float beta1, float *p, const float *grad,
                                   size_t from, size_t to)
{
    const float beta2 = 0.999f, scale = rate / (float)(1 - a->power1), root = 1 / sqrtf((float)(1 - a->power2));
    float *m = a->m, *v = a->v;
    size_t i;
    for (i = from; i < to; ++i) {
        float g = grad[i];
        m[i] = beta1 * m[i] + (1 - beta1) * g;
        v[i] = beta2 * v[i] + (1 - beta2) * g * g;
        p[i] -= scale * m[i] / (sqrtf(v[i]) * root + 1e-8f);
    }
}

static inline void train_adam_count(train_adam *a, float beta1)
{
    a->power1 *= (double)beta1;
    a->power2 *= 0.999;
}

/* One cycle (Smith & Topin 2019) at t in [0, 1]: the rate's factor, and the momentum, which goes the other way. */
static inline float train_cycle(double t, float *beta1)
{
    double warm = 0.05, pi = 3.141592653589793,
           up = t < warm ? 0.5 - 0.5 * cos(pi * t / warm) : 0.5 + 0.5 * cos(pi * (t - warm) / (1 - warm));
    *beta1 = (float)(0.95 - 0.1 * up);
    return (float)(t < warm ? 0.04 + 0.96 * up : 4e-5 + (1 - 4e-5) * up);
}

/* --- principal components --- */

/* Eigenvalues, descending, and vectors (columns of v) of the symmetric a [n][n], which is used up: Jacobi's
   rotations. */
static inline void train_eigen(int n, double *a, double *v, double *value)
{
    int sweep, i, j, k, best;
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) v[i * n + j] = i == j;
    for (sweep = 0; sweep < 30; ++sweep) {
        double off = 0, on = 0;
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) *(i == j ? &on : &off) += a[i * n + j] * a[i * n + j];
        if (off <= 1e-26 * on) break;
        for (i = 0; i < n; ++i)
            for (j = i + 1; j < n; ++j) {
                double apq = a[i * n + j], theta, t, c, s;
                if (apq * apq <= 1e-30 * fabs(a[i * n + i] * a[j * n + j])) continue;
                theta = (a[j * n + j] - a[i * n + i]) / (2 * apq);
                t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
                c = 1 / sqrt(t * t + 1);
                s = t * c;
                for (k = 0; k < n; ++k) { /* rows; the matrix is symmetric, its columns follow */
                    double x = a[i * n + k], y = a[j * n + k];
                    a[i * n + k] = c * x - s * y;
                    a[j * n + k] = s * x + c * y;
                }
                for (k = 0; k < n; ++k) {
                    double x = a[k * n + i], y = a[k * n + j];
                    a[k * n + i] = c * x - s * y;
                    a[k * n + j] = s * x + c * y;
                    x = v[k * n + i], y = v[k * n + j];
                    v[k * n + i] = c * x - s * y;
                    v[k * n + j] = s * x + c * y;
                }
            }
    }
    for (i = 0; i < n; ++i) value[i] = a[i * n + i];
    for (i = 0; i < n; ++i) {
        for (best = i, j = i + 1; j < n; ++j)
            if (value[j] > value[best]) best = j;
        if (best == i) continue;
        {
            double t = value[i];
            value[i] = value[best];
            value[best] = t;
        }
        for (k = 0; k < n; ++k) {
            double t = v[k * n + i];
            v[k * n + i] = v[k * n + best];
            v[k * n + best] = t;
        }
    }
}

/* Cholesky factor (lower) of the symmetric a [n][n] in place. A pivot below `least` times its diagonal element is
   rounding's: it becomes so large that its row of the factor's inverse vanishes. */
static inline void train_cholesky(int n, double *a, double least)
{
    int i, j, k;
    for (i = 0; i < n; ++i) {
        double floor = fabs(a[i * n + i]) * least;
        for (j = 0; j <= i; ++j) {
            double s = a[i * n + j];
            for (k = 0; k < j; ++k) s -= a[i * n + k] * a[j * n + k];
            a[i * n + j] = j < i ? s / a[j * n + j] : s > floor ? sqrt(s) : 1e150;
        }
    }
}

enum { TRAIN_CHUNKS = 4, TRAIN_BLOCK = 192, TRAIN_TILE = 1024 };

/* Rows of pictures: values as 16-bit fractions of 1. */
typedef struct train_pictures {
    const uint16_t *value; /* [rows][pixels] */
    size_t rows, pixels;
    float *mean; /* [pixels] */
} train_pictures;

typedef struct train_components {
    int rank;          /* components that are kept */
    float *basis;      /* [pixels][rank], orthonormal columns */
    float *coordinate; /* [rows][rank]: (picture - mean) basis */
    double *variance;  /* [rank + more]: mean squares of the coordinates, descending */
    int known;         /* how many of variance there are */
    double total;      /* of all pixels about their mean */
} train_components;

typedef struct train__pass {
    const train_pictures *y;
    train_pool *pool;
    int k;
    float *q, *t, *z[TRAIN_CHUNKS]; /* [pixels][k], [rows][k], [pixels][k] */
    double *gram[TRAIN_CHUNKS], *small;
    train_work *work[TRAIN_CHUNKS];
    float *block[TRAIN_CHUNKS];
    double sum[TRAIN_CHUNKS];
} train__pass;

/* Rows [first, first + n), columns [from, from + wide) about the mean into block [n][wide]; also its sum of squares. */
static inline double train__tile_of(const train_pictures *y, size_t first, int n, size_t from, int wide, float *block)
{
    int i, j;
    double sum = 0;
    for (i = 0; i < n; ++i) {
        const uint16_t *in = y->value + (first + (size_t)i) * y->pixels + from;
        float *out = block + (size_t)i * (size_t)wide, s = 0;
        for (j = 0; j < wide; ++j) out[j] = (float)in[j] * (1 / 65535.0f) - y->mean[from + (size_t)j];
        for (j = 0; j < wide; ++j) s += out[j] * out[j];
        sum += (double)s;
    }
    return sum;
}

/* t = y q of a chunk of the rows, and z += y' t where z is wanted. */
static inline void train__project(void *context, int c)
{
    train__pass *p = (train__pass *)context;
    size_t first = p->y->rows * (size_t)c / TRAIN_CHUNKS, last = p->y->rows * ((size_t)c + 1) / TRAIN_CHUNKS, from,
           k = (size_t)p->k;
    p->sum[c] = 0;
    for (; first < last; first += TRAIN_BLOCK) {
        int n = last - first < TRAIN_BLOCK ? (int)(last - first) : (int)TRAIN_BLOCK;
        for (from = 0; from < p->y->pixels; from += TRAIN_TILE) {
            int wide = p->y->pixels - from < TRAIN_TILE ? (int)(p->y->pixels - from) : (int)TRAIN_TILE;
            p->sum[c] += train__tile_of(p->y, first, n, from, wide, p->block[c]);
            train_product(p->work[c], n, p->k, wide, train_rows(p->block[c], (size_t)wide),
                          train_rows(p->q + from * k, k), p->t + first * k, k, from > 0);
        }
        if (p->z[c] == NULL) continue;
        for (from = 0; from < p->y->pixels; from += TRAIN_TILE) {
            int wide = p->y->pixels - from < TRAIN_TILE ? (int)(p->y->pixels - from) : (int)TRAIN_TILE;
            (void)train__tile_of(p->y, first, n, from, wide, p->block[c]);
            train_product(p->work[c], wide, p->k, n, train_transposed(p->block[c], (size_t)wide),
                          train_rows(p->t + first * k, k), p->z[c] + from * k, k, 1);
        }
    }
}

/* A chunk of a' a [k][k] for a [rows][k]. */
static inline void train__gram(const float *a, size_t first, size_t last, int k, double *gram, train_work *w)
{
    size_t i;
    int j;
    float *part = (float *)malloc((size_t)k * (size_t)k * sizeof(float));
    memset(gram, 0, (size_t)k * (size_t)k * sizeof(double));
    if (part == NULL) return;
    for (i = first; i < last; i += 2048) { /* floats over few rows, doubles over many */
        int n = last - i < 2048 ? (int)(last - i) : 2048;
        train_product(w, k, k, n, train_transposed(a + i * (size_t)k, (size_t)k),
                      train_rows(a + i * (size_t)k, (size_t)k), part, (size_t)k, 0);
        for (j = 0; j < k * k; ++j) gram[j] += (double)part[j];
    }
    free(part);
}

static inline void train__gram_q(void *context, int c)
{
    train__pass *p = (train__pass *)context;
    train__gram(p->q, p->y->pixels * (size_t)c / TRAIN_CHUNKS, p->y->pixels * ((size_t)c + 1) / TRAIN_CHUNKS, p->k,
                p->gram[c], p->work[c]);
}

static inline void train__gram_t(void *context, int c)
{
    train__pass *p = (train__pass *)context;
    train__gram(p->t, p->y->rows * (size_t)c / TRAIN_CHUNKS, p->y->rows * ((size_t)c + 1) / TRAIN_CHUNKS, p->k,
                p->gram[c], p->work[c]);
}

static inline void train__gram_sum(train__pass *p, void (*task)(void *context, int c))
{
    int c, j;
    train_run(p->pool, TRAIN_CHUNKS, task, p);
    memcpy(p->small, p->gram[0], (size_t)p->k * (size_t)p->k * sizeof(double));
    for (c = 1; c < TRAIN_CHUNKS; ++c)
        for (j = 0; j < p->k * p->k; ++j) p->small[j] += p->gram[c][j];
}

/* q = q small, a chunk of the pixels. */
static inline void train__turn(void *context, int c)
{
    train__pass *p = (train__pass *)context;
    size_t i, last = p->y->pixels * ((size_t)c + 1) / TRAIN_CHUNKS;
    int j, l, k = p->k;
    for (i = p->y->pixels * (size_t)c / TRAIN_CHUNKS; i < last; ++i) {
        double row[1024];
        float *q = p->q + i * (size_t)k;
        for (j = 0; j < k; ++j) row[j] = 0;
        for (l = 0; l < k; ++l)
            for (j = 0; j < k; ++j) row[j] += (double)q[l] * p->small[l * k + j];
        for (j = 0; j < k; ++j) q[j] = (float)row[j];
    }
}

/* Orthonormal columns of q by the Cholesky factor of their Gram matrix, twice (Yamamoto et al. 2015), unit columns
   first. */
static inline void train__orthonormal(train__pass *p, double *spare)
{
    int round, i, j, l, k = p->k;
    for (round = 0; round < 3; ++round) {
        train__gram_sum(p, train__gram_q);
        memset(spare, 0, (size_t)k * (size_t)k * sizeof(double));
        if (round == 0)
            for (i = 0; i < k; ++i) spare[i * k + i] = p->small[i * k + i] > 0 ? 1 / sqrt(p->small[i * k + i]) : 0;
        else {
            train_cholesky(k, p->small,
                           1e-5);     /* floats: what is left of a column that depends on the others is rounding */
            for (i = 0; i < k; ++i) { /* spare = (l^-1)' */
                spare[i * k + i] = 1 / p->small[i * k + i];
                for (j = i + 1; j < k; ++j) {
                    double s = 0;
                    for (l = i; l < j; ++l) s -= p->small[j * k + l] * spare[i * k + l];
                    spare[i * k + j] = s / p->small[j * k + j];
                }
            }
        }
        memcpy(p->small, spare, (size_t)k * (size_t)k * sizeof(double));
        train_run(p->pool, TRAIN_CHUNKS, train__turn, p);
    }
}

static inline void train_components_free(train_components *c)
{
    free(c->basis);
    free(c->coordinate);
    free(c->variance);
    memset(c, 0, sizeof *c);
}

/* Principal components of pictures about their mean, which it also fills, by subspace iteration from random ones
   (Halko, Martinsson & Tropp 2011). 0: out of memory, or stop() asked for it. */
static inline int train_principal(train_pool *pool, train_pictures *y, int rank, int passes, uint64_t seed,
                                  train_components *out)
{
    train__pass p;
    size_t i, k, most = y->rows < y->pixels ? y->rows : y->pixels;
    int c, j, l, pass, fine = 1;
    double *vector = NULL, *spare = NULL;
    memset(&p, 0, sizeof p);
    memset(out, 0, sizeof *out);
    if (rank > 900) rank = 900;
    if ((size_t)rank > most) rank = (int)most;
    p.y = y;
    p.pool = pool;
    p.k = rank + 32 < 928 && (size_t)rank + 32 < most ? rank + 32 : (int)(most < 928 ? most : 928);
    k = (size_t)p.k;
    out->rank = rank;
    out->known = p.k;
    out->basis = (float *)malloc(y->pixels * (size_t)rank * sizeof(float));
    out->coordinate = (float *)malloc(y->rows * (size_t)rank * sizeof(float));
    out->variance = (double *)malloc(k * sizeof(double));
    p.q = (float *)malloc(y->pixels * k * sizeof(float));
    p.t = (float *)malloc(y->rows * k * sizeof(float));
    p.small = (double *)malloc(k * k * sizeof(double));
    vector = (double *)malloc(k * k * sizeof(double));
    spare = (double *)malloc(k * k * sizeof(double));
    fine = out->basis && out->coordinate && out->variance && p.q && p.t && p.small && vector && spare;
    for (c = 0; c < TRAIN_CHUNKS; ++c) {
        p.z[c] = (float *)malloc(y->pixels * k * sizeof(float));
        p.gram[c] = (double *)malloc(k * k * sizeof(double));
        p.work[c] = (train_work *)malloc(sizeof(train_work));
        p.block[c] = (float *)malloc(TRAIN_BLOCK * TRAIN_TILE * sizeof(float));
        fine = fine && p.z[c] && p.gram[c] && p.work[c] && p.block[c];
    }
    if (fine) {
        double *sum = (double *)calloc(y->pixels, sizeof(double));
        fine = sum != NULL;
        for (i = 0; i < y->rows && fine; ++i) {
            const uint16_t *row = y->value + i * y->pixels;
            size_t at;
            for (at = 0; at < y->pixels; ++at) sum[at] += (double)row[at];
        }
        for (i = 0; i < y->pixels && fine; ++i) y->mean[i] = (float)(sum[i] / 65535 / (double)y->rows);
        free(sum);
    }
    for (i = 0; i < y->pixels * k && fine; ++i) p.q[i] = train_normal(&seed);
    for (pass = 0; pass < passes && fine; ++pass) {
        train__orthonormal(&p, spare);
        for (c = 0; c < TRAIN_CHUNKS; ++c) memset(p.z[c], 0, y->pixels * k * sizeof(float));
        train_run(pool, TRAIN_CHUNKS, train__project, &p);
        for (c = 1; c < TRAIN_CHUNKS; ++c)
            for (i = 0; i < y->pixels * k; ++i) p.z[0][i] += p.z[c][i];
        train__gram_sum(&p, train__gram_t);
        train_eigen(p.k, p.small, vector, out->variance);
        memcpy(p.small, vector, k * k * sizeof(double));
        memcpy(p.q, p.z[0], y->pixels * k * sizeof(float));
        train_run(pool, TRAIN_CHUNKS, train__turn,
                  &p); /* Ritz vectors: nearly orthogonal, so that floats hold the small ones too */
    }
    for (c = 0; c < TRAIN_CHUNKS; ++c) {
        free(p.z[c]);
        p.z[c] = NULL;
    }
    if (fine) {
        train__orthonormal(&p, spare);
        train_run(pool, TRAIN_CHUNKS, train__project, &p);
        for (out->total = 0, c = 0; c < TRAIN_CHUNKS; ++c) out->total += p.sum[c] / (double)y->rows;
        train__gram_sum(&p, train__gram_t);
        for (i = 0; i < k * k; ++i) p.small[i] /= (double)y->rows;
        train_eigen(p.k, p.small, vector, out->variance);
        for (pass = 0; pass < 2; ++pass) { /* turned to the axes: basis = q v, coordinates = t v */
            size_t rows = pass ? y->rows : y->pixels;
            const float *from = pass ? p.t : p.q;
            float *to = pass ? out->coordinate : out->basis;
            for (i = 0; i < rows; ++i) {
                double row[1024];
                for (j = 0; j < rank; ++j) row[j] = 0;
                for (l = 0; l < p.k; ++l)
                    for (j = 0; j < rank; ++j) row[j] += (double)from[i * k + (size_t)l] * vector[l * p.k + j];
                for (j = 0; j < rank; ++j) to[i * (size_t)rank + (size_t)j] = (float)row[j];
            }
        }
    }
    for (c = 0; c < TRAIN_CHUNKS; ++c) {
        free(p.gram[c]);
        free(p.work[c]);
        free(p.block[c]);
    }
    free(p.q);
    free(p.t);
    free(p.small);
    free(vector);
    free(spare);
    if (!fine) train_components_free(out);
    return fine;
}
#endif
