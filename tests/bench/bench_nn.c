/* ms_nn.h: the thesis's networks at full size, speed against error, beside the speed of memory, OpenBLAS, oneDNN and
   PyTorch. Writes build/bench/nn.csv, nn.md (the renderer) and a table for each other part. Needs 9 GB of memory,
   without PyTorch 5; `bench_nn small` 500 MB (pictures of 128 x 128). A word after it picks a part: shared,
   convolution, renderer, inversion, collapse. peer libraries: -lopenblas -ldnnl */
#ifndef _DEFAULT_SOURCE
#define _DEFAULT_SOURCE /* madvise */
#endif
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "bench.h"
#include "nets.h"
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>
#include "test.h"
#include "pool.h"
#if defined(HAVE_DNNL)
#include <dnnl.h>
#endif
#if defined(HAVE_OPENBLAS)
void openblas_set_num_threads(int n);
void cblas_sgemv(int order, int trans, int m, int n, float alpha, const float *a, int lda, const float *x, int incx,
                 float beta, float *y, int incy);
#endif
#if defined(__x86_64__)
#include <immintrin.h>
#endif

static FILE *csv, *md, *more;
static int side = 410;

/* The table of a part. */
static void begin_table(const char *name)
{
    more = bench_open(name);
    fprintf(more, "%s, one thread unless said, thread CPU time, medians; random weights; `make bench FILTER=nn`.\n",
            bench_processor());
}

static void record(const char *what, const char *how, double seconds, double spread)
{
    fprintf(csv, "%s,%s,%.6g,%.2g\n", what, how, seconds, spread);
    printf("%-34s %-22s %10.4f ms +- %.4f\n", what, how, 1e3 * seconds, 1e3 * spread);
    fflush(stdout);
}

/* --- a network ready to run --- */

typedef struct runner {
    nets_file *file;
    ms_nn *nn;
    float *x, *y;
    void *workspace;
    double load;
} runner;

static runner runner_make(nets_file *file, ms_simd level, ms_parallel parallel)
{
    runner r;
    ms_nn_options o = ms_nn_defaults();
    ms_error error;
    uint64_t state = 99;
    size_t i;
    double start = bench_cpu();
    memset(&r, 0, sizeof r);
    r.file = file;
    o.simd = level;
    o.parallel = parallel;
    if (ms_nn_load(file->bytes, file->size, &o, &r.nn, &error) != MS_OK) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    r.load = bench_cpu() - start;
    r.x = (float *)malloc(ms_nn_input_size(r.nn) * sizeof(float));
    r.y = (float *)malloc(ms_nn_output_size(r.nn) * sizeof(float));
    r.workspace = malloc(ms_nn_workspace_size(r.nn, MS_NN_FORWARD, 1));
    for (i = 0; i < ms_nn_input_size(r.nn); ++i) r.x[i] = 0.5f + 0.5f * nets_uniform(&state);
    return r;
}

static void runner_free(runner *r)
{
    ms_nn_destroy(r->nn);
    free(r->x);
    free(r->y);
    free(r->workspace);
}

static void run_forward(void *context)
{
    runner *r = (runner *)context;
    if (ms_nn_forward(r->nn, 1, r->x, r->y, r->workspace) != MS_OK) exit(1);
}

static ms_parallel no_threads(void)
{
    ms_parallel p;
    memset(&p, 0, sizeof p);
    return p;
}

/* Wall time with two threads, for one also by the wall. */
static double wall(void (*run)(void *), void *context, int n)
{
    double t[64];
    int i;
    run(context);
    for (i = 0; i < n; ++i) {
        double start = bench_wall();
        run(context);
        t[i] = bench_wall() - start;
    }
    return bench_median(t, n);
}

/* --- peers --- */

/* Reading alone, the floor of what a matrix from memory can take: loads of 16, 32 and 64 bytes, with and without a
   request ahead. */
typedef struct memory_job {
    const unsigned char *bytes;
    size_t size, ahead; /* ahead: 0: none asked for */
    int form;           /* log2 of the bytes of a load; 3: plain C */
    uint64_t sum;
} memory_job;

static void read_plain(memory_job *job)
{
    uint64_t s[4] = {0, 0, 0, 0}, v[4];
    size_t i;
    for (i = 0; i + 32 <= job->size; i += 32) {
        memcpy(v, job->bytes + i, 32);
        s[0] ^= v[0];
        s[1] ^= v[1];
        s[2] ^= v[2];
        s[3] ^= v[3];
    }
    job->sum += s[0] ^ s[1] ^ s[2] ^ s[3];
}

#if defined(__x86_64__)
#define READER(name, isa, vector, zero, xor_, load)                                                                   \
    static __attribute__((target(isa))) void name(memory_job *job)                                                    \
    {                                                                                                                 \
        vector s[4] = {zero(), zero(), zero(), zero()};                                                               \
        uint64_t out[8];                                                                                              \
        size_t i, k, step = 4 * sizeof(vector);                                                                       \
        for (i = 0; i + step <= job->size; i += step) {                                                               \
            const unsigned char *p = job->bytes + i;                                                                  \
            for (k = 0; job->ahead && k < step; k += 64) _mm_prefetch((const char *)p + job->ahead + k, _MM_HINT_T1); \
            s[0] = xor_(s[0], load((const vector *)(const void *)p));                                                 \
            s[1] = xor_(s[1], load((const vector *)(const void *)(p + sizeof(vector))));                              \
            s[2] = xor_(s[2], load((const vector *)(const void *)(p + 2 * sizeof(vector))));                          \
            s[3] = xor_(s[3], load((const vector *)(const void *)(p + 3 * sizeof(vector))));                          \
        }                                                                                                             \
        s[0] = xor_(xor_(s[0], s[1]), xor_(s[2], s[3]));                                                              \
        memcpy(out, &s[0], sizeof s[0]);                                                                              \
        job->sum += out[0] ^ out[1];                                                                                  \
    }
READER(read_16, "sse2", __m128i, _mm_setzero_si128, _mm_xor_si128, _mm_loadu_si128)
READER(read_32, "avx2", __m256i, _mm256_setzero_si256, _mm256_xor_si256, _mm256_loadu_si256)
READER(read_64, "avx512f", __m512i, _mm512_setzero_si512, _mm512_xor_si512, _mm512_loadu_si512)
#endif

static void run_read(void *context)
{
    memory_job *job = (memory_job *)context;
#if defined(__x86_64__)
    if (job->form == 4) read_16(job);
    else if (job->form == 5) read_32(job);
    else if (job->form == 6) read_64(job);
    else
#endif
        read_plain(job);
}

/* The fastest way to read a file of this level: the best of three each. */
static memory_job memory_floor(const nets_file *f, ms_simd level)
{
    memory_job job, best;
    double least = 1e30;
    memset(&job, 0, sizeof job);
    job.bytes = f->bytes;
    job.size = f->size;
    job.form = 3;
    best = job;
#if defined(__x86_64__)
    for (job.form = 4; job.form <= (level >= MS_SIMD_AVX512 ? 6 : level == MS_SIMD_AVX2 ? 5 : 4); ++job.form)
        for (job.ahead = 0; job.ahead <= 8192; job.ahead = job.ahead ? 2 * job.ahead : 2048) {
            int i;
            for (i = 0; i < 3; ++i) {
                double start = bench_cpu();
                run_read(&job);
                start = bench_cpu() - start;
                if (start < least) best = job;
                least = fmin(least, start);
            }
        }
#else
    (void)level;
#endif
    return best;
}

#if defined(HAVE_OPENBLAS)
typedef struct blas_job {
    const float *w, *x;
    float *y;
    int rows, cols;
} blas_job;

static void run_sgemv(void *context)
{
    blas_job *j = (blas_job *)context;
    cblas_sgemv(101, 111, j->rows, j->cols, 1, j->w, j->cols, j->x, 1, 0, j->y, 1);
}
#endif

#if defined(HAVE_DNNL)
typedef struct dnnl_job {
    dnnl_primitive_t primitive;
    dnnl_stream_t stream;
    dnnl_exec_arg_t argument[4];
} dnnl_job;

static void run_dnnl(void *context)
{
    dnnl_job *j = (dnnl_job *)context;
    dnnl_primitive_execute(j->primitive, j->stream, 4, j->argument);
    dnnl_stream_wait(j->stream);
}

/* A 3x3 convolution of n channels in the layouts that oneDNN prefers: its best case, nothing is reordered. */
static void dnnl_make(dnnl_job *j, int n, int size)
{
    dnnl_engine_t engine;
    dnnl_memory_desc_t any[4];
    dnnl_convolution_desc_t desc;
    dnnl_primitive_desc_t pd;
    dnnl_dims_t x, w, b, one = {1, 1}, pad = {1, 1};
    static const dnnl_query_t query[4] = {dnnl_query_src_md, dnnl_query_weights_md, dnnl_query_weights_md,
                                          dnnl_query_dst_md};
    static const int argument[4] = {DNNL_ARG_SRC, DNNL_ARG_WEIGHTS, DNNL_ARG_BIAS, DNNL_ARG_DST};
    int i;
    x[0] = 1;
    x[1] = n;
    x[2] = x[3] = size;
    w[0] = w[1] = n;
    w[2] = w[3] = 3;
    b[0] = n;
    dnnl_engine_create(&engine, dnnl_cpu, 0);
    dnnl_stream_create(&j->stream, engine, dnnl_stream_default_flags);
    dnnl_memory_desc_init_by_tag(&any[0], 4, x, dnnl_f32, dnnl_format_tag_any);
    dnnl_memory_desc_init_by_tag(&any[1], 4, w, dnnl_f32, dnnl_format_tag_any);
    dnnl_memory_desc_init_by_tag(&any[2], 1, b, dnnl_f32, dnnl_a);
    any[3] = any[0];
    dnnl_convolution_forward_desc_init(&desc, dnnl_forward_inference, dnnl_convolution_auto, &any[0], &any[1], &any[2],
                                       &any[3], one, pad, pad);
    if (dnnl_primitive_desc_create(&pd, &desc, NULL, engine, NULL) != dnnl_success) exit(1);
    for (i = 0; i < 4; ++i) {
        const dnnl_memory_desc_t *d = dnnl_primitive_desc_query_md(pd, query[i], i == 2 ? 1 : 0);
        size_t bytes = dnnl_memory_desc_get_size(d), k;
        float *data = (float *)(((uintptr_t)malloc(bytes + 64) + 63) & ~(uintptr_t)63);
        uint64_t state = 5;
        for (k = 0; k < bytes / 4; ++k) data[k] = nets_uniform(&state);
        j->argument[i].arg = argument[i];
        dnnl_memory_create(&j->argument[i].memory, d, engine, data);
    }
    dnnl_primitive_create(&j->primitive, pd);
}
#endif

/* tests/bench/bench_nn_torch.py as a process that runs a network when it is told to, so that its runs and ours take
   turns. */
typedef struct torch_peer {
    FILE *to, *from;
    char version[64];
} torch_peer;

static torch_peer torch_start(int huge_pages)
{
    static const char *const pythons[2] = {"python3", "/usr/bin/python3"};
    torch_peer t;
    int i;
    memset(&t, 0, sizeof t);
    signal(SIGPIPE, SIG_IGN);
    for (i = 0; i < 2; ++i) {
        int in[2], out[2];
        pid_t child;
        if (pipe(in) != 0 || pipe(out) != 0) exit(1);
        child = fork();
        if (child == 0) {
            dup2(in[0], 0);
            dup2(out[1], 1);
            close(in[1]);
            close(out[0]);
            if (huge_pages) setenv("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1", 1);
            if (freopen("/dev/null", "w", stderr) == NULL) exit(1);
            execlp(pythons[i], pythons[i], "tests/bench/bench_nn_torch.py", (char *)NULL);
            exit(1);
        }
        close(in[0]);
        close(out[1]);
        t.to = fdopen(in[1], "w");
        t.from = fdopen(out[0], "r");
        if (fscanf(t.from, "version %63s", t.version) == 1) return t;
        fclose(t.to);
        fclose(t.from);
    }
    t.version[0] = 0;
    printf("PyTorch: not found, skipped\n");
    return t;
}

static void torch_stop(torch_peer *t)
{
    if (t->version[0] == 0) return;
    fclose(t->to); /* the end of its input ends it */
    fclose(t->from);
}

/* Seconds of one run: thread CPU time for one thread, else by the wall. */
static double torch_run(torch_peer *t, const char *network, int threads)
{
    double seconds;
    fprintf(t->to, "%s %d %d\n", network, side, threads);
    fflush(t->to);
    if (fscanf(t->from, "%lf", &seconds) != 1) exit(1);
    return seconds;
}

/* Ours and PyTorch's in turn. */
static bench_pair torch_compare(torch_peer *t, const char *network, void (*run)(void *), void *context, int n)
{
    double a[64], b[64], ratio[64];
    bench_pair p;
    int i;
    run(context);
    torch_run(t, network, 1);
    for (i = 0; i < n; ++i) {
        double start = bench_cpu();
        run(context);
        a[i] = bench_cpu() - start;
        b[i] = torch_run(t, network, 1);
        ratio[i] = b[i] / a[i];
    }
    p.a = bench_summary(a, n);
    p.b = bench_summary(b, n);
    p.ratio = bench_summary(ratio, n);
    return p;
}

static double torch_wall(torch_peer *t, const char *network, int threads, int n)
{
    double seconds[64];
    int i;
    torch_run(t, network, threads);
    for (i = 0; i < n; ++i) seconds[i] = torch_run(t, network, threads);
    return bench_median(seconds, n);
}

/* --- tables --- */

static double psnr(const float *y, const float *reference, size_t n)
{
    double low = 1e30, high = -1e30, sum = 0;
    size_t i;
    for (i = 0; i < n; ++i) {
        double d = (double)y[i] - (double)reference[i];
        sum += d * d;
        if ((double)reference[i] < low) low = (double)reference[i];
        if ((double)reference[i] > high) high = (double)reference[i];
    }
    return 10 * log10((high - low) * (high - low) * (double)n / sum);
}

/* The last layer alone, a view of the network's, beside the general matrix-vector product of a BLAS. */
static void bench_last_layer(const runner *r, const char *pages)
{
#if defined(HAVE_OPENBLAS)
    const ms_nn_tensor *w = ms_nn_file_find(ms_nn_tensors(r->nn), "fc2.weight");
    ms_nn view = *r->nn;
    runner layer = *r;
    blas_job blas;
    bench_pair p;
    uint64_t state = 3;
    int i;
    blas.rows = (int)w->shape[0];
    blas.cols = (int)w->shape[1];
    layer.x = (float *)malloc((size_t)blas.cols * sizeof(float));
    for (i = 0; i < blas.cols; ++i) layer.x[i] = nets_uniform(&state);
    view.op += view.ops - 1;
    view.ops = 1;
    view.inner.c = (size_t)blas.cols;
    view.inner.h = view.inner.w = 1;
    view.input.rank = 1;
    view.input.size[0] = (size_t)blas.cols;
    layer.nn = &view;
    openblas_set_num_threads(1);
    blas.w = (const float *)w->data;
    blas.x = layer.x;
    blas.y = (float *)malloc((size_t)blas.rows * sizeof(float));
    p = bench_compare(run_forward, &layer, run_sgemv, &blas, 9);
    record("last layer", "ms_nn f32", p.a.median, p.a.spread);
    record("last layer", "OpenBLAS sgemv", p.b.median, p.b.spread);
    fprintf(csv, "sgemv over ms_nn,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
    fprintf(
        md,
        "| last layer, %s: OpenBLAS sgemv | %.1f | | | | %.1f | | |\n| last layer, %s: ms_nn, %.2f +- %.2f x sgemv | %.1f | | | | %.1f | | |\n",
        pages, 1e3 * p.b.median, (double)w->bytes / p.b.median * 1e-9, pages, p.ratio.median, p.ratio.spread,
        1e3 * p.a.median, (double)w->bytes / p.a.median * 1e-9);
    free(layer.x);
    free(blas.y);
#else
    (void)r;
    (void)pages;
    printf("OpenBLAS: not found, skipped\n");
#endif
}

/* Beside the network in floats: the scalar code, PyTorch. */
static void renderer_peers(runner *r, torch_peer *torch)
{
    runner scalar;
    bench_pair p;
    bench_time t;
    scalar = runner_make(r->file, MS_SIMD_SCALAR, no_threads());
    t = bench_run(run_forward, &scalar, 3);
    record("renderer, scalar code", "F32", t.median, t.spread);
    fprintf(md, "| ms_nn F32, scalar code | %.1f | | | | %.1f | | |\n", 1e3 * t.median,
            (double)r->file->size / t.median * 1e-9);
    runner_free(&scalar);
    if (torch->version[0] && side == 410) {
        double both;
        p = torch_compare(torch, "renderer", run_forward, r, 9);
        both = torch_wall(torch, "renderer", 2, 5);
        record("renderer", "PyTorch", p.b.median, p.b.spread);
        fprintf(csv, "PyTorch over ms_nn,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
        fprintf(md, "| PyTorch %s F32: %.2f +- %.2f x ms_nn F32 | %.1f +- %.1f | | | | | | %.1f |\n", torch->version,
                p.ratio.median, p.ratio.spread, 1e3 * p.b.median, 1e3 * p.b.spread, 1e3 * both);
    }
}

static void bench_renderer(void)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    size_t outputs = (size_t)(3 * side * side);
    float *reference = (float *)malloc(outputs * sizeof(float));
    torch_peer torch = torch_start(0);
    double f32[2] = {0, 0};
    int k, huge;
    md = bench_open("nn.md");
    fprintf(md,
            "%s, one thread unless said, thread CPU time, medians of 9 runs; random weights; `make bench FILTER=nn`.\n",
            bench_processor());
    fprintf(
        md,
        "\n| renderer %d x %d, one picture | ms | x F32 | PSNR against F32, dB | file, MB | GB/s | of reading alone | one and two threads by the wall, ms |\n|---|---:|---:|---:|---:|---:|---:|---:|\n",
        side, side);
    for (k = 0; k < 3; ++k) {
        nets_file *f = (nets_file *)malloc(sizeof *f);
        if (nets_renderer(f, side, 64, 1000, types[k])) exit(1);
        for (huge = 0; huge < 2; ++huge) {
            runner r, two;
            bench_time t;
            bench_pair p;
            memory_job memory;
            char label[64], form[64];
            double alone, both;
            pool threads;
            if (huge && nets_huge_pages(f)) break;
            snprintf(label, sizeof label, "%s%s", ms_nn_dtype_string(types[k]), huge ? ", huge pages" : "");
            r = runner_make(f, MS_SIMD_AUTO, no_threads());
            record("renderer load", label, r.load, 0);
            if (k == 0 && !huge) renderer_peers(&r, &torch);
            if (k == 0) bench_last_layer(&r, label);
            memory = memory_floor(f, ms_nn_simd(r.nn));
            p = bench_compare(run_read, &memory, run_forward, &r, 9);
            snprintf(form, sizeof form, "%d-byte loads, %d ahead", 1 << memory.form, (int)memory.ahead);
            record("reading the file", form, p.a.median, p.a.spread);
            t = p.b;
            alone = wall(run_forward, &r, 5);
            pool_start(&threads, 2);
            two = runner_make(f, MS_SIMD_AUTO, pool_parallel(&threads));
            both = wall(run_forward, &two, 5);
            runner_free(&two);
            pool_stop(&threads);
            if (k == 0) f32[huge] = t.median;
            if (k == 0 && !huge) memcpy(reference, r.y, outputs * sizeof(float));
            record("renderer", label, t.median, t.spread);
            record("renderer, two threads (wall)", label, both, 0);
            fprintf(md, "| ms_nn %s | %.1f +- %.1f | %.2f | ", label, 1e3 * t.median, 1e3 * t.spread,
                    f32[huge] / t.median);
            if (k) {
                fprintf(csv, "renderer psnr,%s,%.4g,0\n", label, psnr(r.y, reference, outputs));
                fprintf(md, "%.0f", psnr(r.y, reference, outputs));
            }
            fprintf(md, " | %.0f | %.1f | %.0f%% (%.1f ms, %s) | %.1f, %.1f |\n", (double)f->size * 1e-6,
                    (double)f->size / t.median * 1e-9, 100 / p.ratio.median, 1e3 * p.a.median, form, 1e3 * alone,
                    1e3 * both);
            record("renderer, one thread (wall)", label, alone, 0);
            runner_free(&r);
        }
        free(f->bytes);
        free(f);
    }
    torch_stop(&torch);
    if (side == 410 && torch.version[0]) {
        torch = torch_start(1);
        fprintf(md, "| PyTorch %s F32, huge pages | %.1f | | | | | | |\n", torch.version,
                1e3 * torch_wall(&torch, "renderer", 1, 9));
        torch_stop(&torch);
    }
    free(reference);
    fclose(md);
}

static void bench_convolution(void)
{
    torch_peer torch = torch_start(0);
    nets_file *f = (nets_file *)malloc(sizeof *f);
    double macs = 205.0 * 205 * 32 * 32 * 9;
    int level;
    pool threads;
    runner r;
    nets_begin(f, "[32,205,205]");
    nets_layer(f, "{\"type\":\"conv2d\",\"name\":\"c\",\"filters\":32,\"kernel\":3,\"padding\":\"same\"}", "c",
               MS_NN_F32, 4, 32, 32, 3, 3);
    nets_end(f);
    begin_table("nn_convolution.md");
    fprintf(more, "\n| Conv2D 32 -> 32, 3 x 3, 205 x 205 | ms | G multiply-adds/s |\n|---|---:|---:|\n");
    for (level = MS_SIMD_AVX2; level >= MS_SIMD_SCALAR; --level) {
        bench_time t;
        r = runner_make(f, (ms_simd)level, no_threads());
        if ((int)ms_nn_simd(r.nn) == level) {
            t = bench_run(run_forward, &r, level == MS_SIMD_SCALAR ? 3 : 9);
            record("convolution", ms_simd_string((ms_simd)level), t.median, t.spread);
            fprintf(more, "| ms_nn %s | %.2f +- %.2f | %.1f |\n", ms_simd_string((ms_simd)level), 1e3 * t.median,
                    1e3 * t.spread, macs / t.median * 1e-9);
        }
        runner_free(&r);
    }
    r = runner_make(f, MS_SIMD_AUTO, no_threads());
#if defined(HAVE_DNNL)
    {
        dnnl_job d;
        bench_pair p;
        dnnl_make(&d, 32, 205);
        p = bench_compare(run_forward, &r, run_dnnl, &d, 15);
        record("convolution", "oneDNN", p.b.median, p.b.spread);
        fprintf(csv, "oneDNN over ms_nn,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
        printf("oneDNN / ms_nn: %.3f +- %.3f\n", p.ratio.median, p.ratio.spread);
        fprintf(more, "| oneDNN %d.%d, blocked layouts, no reorders | %.2f +- %.2f | %.1f |\n", dnnl_version()->major,
                dnnl_version()->minor, 1e3 * p.b.median, 1e3 * p.b.spread, macs / p.b.median * 1e-9);
    }
#else
    printf("oneDNN: not found, skipped\n");
#endif
    {
        double one = wall(run_forward, &r, 9), two;
        runner t;
        pool_start(&threads, 2);
        t = runner_make(f, MS_SIMD_AUTO, pool_parallel(&threads));
        two = wall(run_forward, &t, 9);
        printf("convolution on two threads: %.2f x one\n", one / two);
        record("convolution, two threads (wall)", "auto", two, 0);
        record("convolution, one thread (wall)", "auto", one, 0);
        fprintf(more, "| ms_nn, two threads (wall; one: %.2f) | %.2f | %.1f |\n", 1e3 * one, 1e3 * two,
                macs / two * 1e-9);
        runner_free(&t);
        pool_stop(&threads);
    }
    if (torch.version[0]) {
        bench_pair p = torch_compare(&torch, "convolution", run_forward, &r, 15);
        record("convolution", "PyTorch", p.b.median, p.b.spread);
        fprintf(more, "| PyTorch %s, %.2f +- %.2f x ms_nn | %.2f +- %.2f | %.1f |\n", torch.version, p.ratio.median,
                p.ratio.spread, 1e3 * p.b.median, 1e3 * p.b.spread, macs / p.b.median * 1e-9);
    }
    torch_stop(&torch);
    runner_free(&r);
    free(f->bytes);
    free(f);
    fclose(more);
}

/* 1 (by assumption), 2, 3, 6, 7 and 9 are one architecture: they differ by dropout and training; 4 and 5 are another, 8
   a third. */
static void bench_inversion(void)
{
    static const int numbers[9] = {1, 2, 3, 6, 7, 9, 4, 5, 8};
    static const ms_nn_dtype types[2] = {MS_NN_F32, MS_NN_I8};
    bench_time t[2][10];
    size_t size[2][10], workspace[10];
    double parameters[10], macs[10], total[2] = {0, 0}, megabytes[2] = {0, 0};
    bench_pair two;
    torch_peer torch = torch_start(0);
    int k, i, j, number;
    memset(&two, 0, sizeof two);
    for (k = 0; k < 2; ++k) {
        nets_file *f = NULL;
        for (i = 0; i < 9; ++i) {
            char label[64];
            runner r;
            number = numbers[i];
            if (i == 0 || number == 4 || number == 8) { /* another architecture */
                if (f) free(f->bytes);
                free(f);
                f = (nets_file *)malloc(sizeof *f);
                if (nets_inversion(f, number, side, 19, types[k])) exit(1);
            }
            r = runner_make(f, MS_SIMD_AUTO, no_threads());
            size[k][number] = f->size;
            workspace[number] = ms_nn_workspace_size(r.nn, MS_NN_FORWARD, 1);
            parameters[number] = macs[number] = 0;
            for (j = 0; j < ms_nn_layer_count(r.nn); ++j) {
                parameters[number] += (double)ms_nn_layer_at(r.nn, j).parameters;
                macs[number] += (double)ms_nn_layer_at(r.nn, j).multiply_adds;
            }
            t[k][number] = bench_run(run_forward, &r, 5);
            if (number == 2 && k == 0 && torch.version[0] && side == 410)
                two = torch_compare(&torch, "inversion", run_forward, &r, 9);
            snprintf(label, sizeof label, "%d %s", number, ms_nn_dtype_string(types[k]));
            record("inversion", label, t[k][number].median, t[k][number].spread);
            total[k] += t[k][number].median;
            megabytes[k] += (double)f->size * 1e-6;
            runner_free(&r);
        }
        free(f->bytes);
        free(f);
    }
    torch_stop(&torch);
    begin_table("nn_inversion.md");
    fprintf(
        more,
        "\n| inversion networks of 4.3.1, %d x %d | parameters, M | multiply-adds, M | workspace, MB | F32 file, MB | F32, ms | I8 file, MB | I8, ms |\n",
        side, side);
    fprintf(more, "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (number = 1; number <= 9; ++number)
        fprintf(more, "| %d%s | %.1f | %.0f | %.1f | %.0f | %.1f +- %.1f | %.0f | %.1f +- %.1f |\n", number,
                number == 1 ? " (missing in the text; taken as 2)" : "", parameters[number] * 1e-6, macs[number] * 1e-6,
                (double)workspace[number] * 1e-6, (double)size[0][number] * 1e-6, 1e3 * t[0][number].median,
                1e3 * t[0][number].spread, (double)size[1][number] * 1e-6, 1e3 * t[1][number].median,
                1e3 * t[1][number].spread);
    fprintf(more, "| best of nine | | | | %.0f | %.1f | %.0f | %.1f |\n", megabytes[0], 1e3 * total[0], megabytes[1],
            1e3 * total[1]);
    if (two.b.median > 0) {
        record("inversion 2", "PyTorch", two.b.median, two.b.spread);
        fprintf(csv, "PyTorch over ms_nn inversion 2,ratio,%.4g,%.2g\n", two.ratio.median, two.ratio.spread);
        fprintf(more, "| 2, PyTorch %s, %.2f +- %.2f x ms_nn | | | | | %.1f +- %.1f | | |\n", torch.version,
                two.ratio.median, two.ratio.spread, 1e3 * two.b.median, 1e3 * two.b.spread);
    }
    fclose(more);
}

static void bench_shared(void)
{
    static const ms_nn_dtype types[3] = {MS_NN_F32, MS_NN_F16, MS_NN_I8};
    int k, level;
    begin_table("nn_shared.md");
    fprintf(
        more,
        "\n| shared-channel renderer, 64 x 64, three channels | file, MB | scalar, ms | base | avx2 |\n|---|---:|---:|---:|---:|\n");
    for (k = 0; k < 3; ++k) {
        nets_file *f = (nets_file *)malloc(sizeof *f);
        if (nets_shared(f, 64, 160, types[k])) exit(1);
        fprintf(more, "| %s | %.1f |", ms_nn_dtype_string(types[k]), (double)f->size * 1e-6);
        for (level = MS_SIMD_SCALAR; level <= MS_SIMD_AVX2; ++level) {
            runner r = runner_make(f, (ms_simd)level, no_threads());
            bench_time t = bench_run(run_forward, &r, 31);
            char label[64];
            snprintf(label, sizeof label, "%s %s", ms_nn_dtype_string(types[k]), ms_simd_string((ms_simd)level));
            if ((int)ms_nn_simd(r.nn) == level) {
                record("shared channels", label, t.median, t.spread);
                fprintf(more, " %.3f |", 1e3 * t.median);
            } else {
                fprintf(more, " - |");
            }
            runner_free(&r);
        }
        fprintf(more, "\n");
        free(f->bytes);
        free(f);
    }
    fclose(more);
}

typedef struct collapse_job {
    const ms_nn_collapse *c;
    const float *x;
    void *workspace;
    double *residual, *jacobian;
} collapse_job;

static void run_residual(void *context)
{
    collapse_job *j = (collapse_job *)context;
    if (ms_nn_collapse_residual(j->c, j->x, j->residual, j->jacobian, j->workspace) != MS_OK) exit(1);
}

/* The objective without the last layer: R once a network, q once a target, then value, residual and Jacobian. */
static void bench_collapse(const char *label, nets_file *f)
{
    collapse_job job;
    ms_nn_collapse *c = NULL;
    bench_time picture, value, slopes;
    runner r, two;
    pool threads;
    double start, made, target[5], *slope_room;
    size_t features, i;
    pool_start(&threads, 2);
    two = runner_make(f, MS_SIMD_AUTO, pool_parallel(&threads));
    start = bench_wall();
    if (ms_nn_collapse_create(two.nn, NULL, &c, NULL) != MS_OK) exit(1);
    made = bench_wall() - start;
    r = runner_make(f, MS_SIMD_AUTO, no_threads());
    picture = bench_run(run_forward, &r, 9);
    features = ms_nn_collapse_features(c);
    {
        ms_nn_collapse one = *c; /* the same R, run on this thread: a look inside (ms_nn__ types) */
        one.nn = r.nn;
        one.m = &r.nn->op[r.nn->ops - 1].matrix;
        one.body.options = r.nn->options;
        for (i = 0; i < 5; ++i) {
            start = bench_cpu();
            if (ms_nn_collapse_target(&one, r.y, NULL) != MS_OK) exit(1);
            target[i] = bench_cpu() - start;
        }
        job.c = &one;
        job.x = r.x;
        job.workspace = malloc(ms_nn_collapse_workspace_size(&one, 1));
        job.residual = (double *)malloc((features + 1) * sizeof(double));
        job.jacobian = (double *)malloc((features + 1) * ms_nn_input_size(r.nn) * sizeof(double));
        slope_room = job.jacobian;
        job.jacobian = NULL;
        value = bench_run(run_residual, &job, 15);
        job.jacobian = slope_room;
        slopes = bench_run(run_residual, &job, 9);
    }
    record("collapse: R (wall)", label, made, 0);
    record("collapse: target", label, bench_median(target, 5), 0);
    record("collapse: residual", label, value.median, value.spread);
    record("collapse: residual and Jacobian", label, slopes.median, slopes.spread);
    record("picture for comparison", label, picture.median, picture.spread);
    fprintf(more, "| %s | %.0f | %.1f | %.2f +- %.2f | %.2f +- %.2f | %.2f |\n", label, 1e3 * made,
            1e3 * bench_median(target, 5), 1e3 * value.median, 1e3 * value.spread, 1e3 * slopes.median,
            1e3 * slopes.spread, 1e3 * picture.median);
    ms_nn_collapse_destroy(c);
    free(job.workspace);
    free(job.residual);
    pool_stop(&threads);
    free(job.jacobian);
    runner_free(&two);
    runner_free(&r);
    free(f->bytes);
}

static void bench_collapses(void)
{
    nets_file *f = (nets_file *)malloc(sizeof *f);
    begin_table("nn_collapse.md");
    fprintf(
        more,
        "\n| collapse | R, once a network, ms | target, ms | residual, ms | residual and Jacobian, ms | the picture, ms |\n|---|---:|---:|---:|---:|---:|\n");
    if (nets_shared(f, 128, 256, MS_NN_F16)) exit(1);
    bench_collapse("shared channels, 3 x 256 features, 128 x 128, F16", f);
    if (nets_renderer(f, 128, 64, 1000, MS_NN_F16)) exit(1); /* what R takes grows with the pixels */
    bench_collapse("renderer, 1000 features, 128 x 128, F16", f);
    free(f);
    fclose(more);
}

int main(int argc, char **argv)
{
    const char *only, *threads = getenv("OMP_NUM_THREADS");
    if (threads == NULL || strcmp(threads, "1")) { /* oneDNN's threads are set when its library starts */
        setenv("OMP_NUM_THREADS", "1", 1);
        execv(argv[0], argv);
    }
    if (argc > 1 && strcmp(argv[1], "small") == 0) side = 128;
    only = argc > 1 && (side == 410 || argc > 2) ? argv[argc - 1] : "";
    csv = bench_open("nn.csv");
    fprintf(csv, "what,how,seconds,spread\n");
    if (!*only || strcmp(only, "shared") == 0) bench_shared();
    if (!*only || strcmp(only, "convolution") == 0) bench_convolution();
    if (!*only || strcmp(only, "renderer") == 0) bench_renderer();
    if (!*only || strcmp(only, "inversion") == 0) bench_inversion();
    if (!*only || strcmp(only, "collapse") == 0) bench_collapses();
    fclose(csv);
    return 0;
}
