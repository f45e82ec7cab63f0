/* ms_nn.h: the thesis's networks at full size, speed against error, beside the speed of memory, OpenBLAS, oneDNN and PyTorch.
   Writes build/bench/nn.csv, nn.md. Needs 4.5 GB of memory; `bench_nn small` needs 300 MB (pictures of 128 x 128).
   peer libraries: -lopenblas -ldnnl */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "bench.h"
#include "nets.h"
#include <pthread.h>
#include <unistd.h>
#include "test.h"
#if defined(HAVE_DNNL)
#include <dnnl.h>
#endif
#if defined(HAVE_OPENBLAS)
void openblas_set_num_threads(int n);
void cblas_sgemv(int order, int trans, int m, int n, float alpha, const float *a, int lda, const float *x, int incx, float beta, float *y, int incy);
#endif
#if defined(__x86_64__)
#include <immintrin.h>
#endif

static FILE *csv, *md;
static int side = 410;
static double torch_time[3][3]; /* [renderer, inversion, convolution][threads]; 0: not measured */
static char torch_version[64] = "";

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

static runner runner_make(nets_file *file, ms_simd level, ms_parallel parallel, int no_folds)
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
    o.no_folds = no_folds;
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

typedef struct memory_job {
    const unsigned char *bytes;
    size_t size;
    uint64_t sum;
} memory_job;

static void run_read(void *context)
{
    memory_job *job = (memory_job *)context;
    size_t i;
#if defined(__x86_64__)
    __m128i s[4];
    int k;
    for (k = 0; k < 4; ++k) s[k] = _mm_setzero_si128();
    for (i = 0; i + 64 <= job->size; i += 64) {
        s[0] = _mm_xor_si128(s[0], _mm_loadu_si128((const __m128i *)(const void *)(job->bytes + i)));
        s[1] = _mm_xor_si128(s[1], _mm_loadu_si128((const __m128i *)(const void *)(job->bytes + i + 16)));
        s[2] = _mm_xor_si128(s[2], _mm_loadu_si128((const __m128i *)(const void *)(job->bytes + i + 32)));
        s[3] = _mm_xor_si128(s[3], _mm_loadu_si128((const __m128i *)(const void *)(job->bytes + i + 48)));
    }
    job->sum += (uint64_t)_mm_cvtsi128_si64(_mm_xor_si128(_mm_xor_si128(s[0], s[1]), _mm_xor_si128(s[2], s[3])));
#else
    uint64_t s[4] = {0, 0, 0, 0}, v[4];
    for (i = 0; i + 32 <= job->size; i += 32) {
        memcpy(v, job->bytes + i, 32);
        s[0] ^= v[0]; s[1] ^= v[1]; s[2] ^= v[2]; s[3] ^= v[3];
    }
    job->sum += s[0] ^ s[1] ^ s[2] ^ s[3];
#endif
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
    static const dnnl_query_t query[4] = {dnnl_query_src_md, dnnl_query_weights_md, dnnl_query_weights_md, dnnl_query_dst_md};
    static const int argument[4] = {DNNL_ARG_SRC, DNNL_ARG_WEIGHTS, DNNL_ARG_BIAS, DNNL_ARG_DST};
    int i;
    x[0] = 1; x[1] = n; x[2] = x[3] = size;
    w[0] = w[1] = n; w[2] = w[3] = 3;
    b[0] = n;
    dnnl_engine_create(&engine, dnnl_cpu, 0);
    dnnl_stream_create(&j->stream, engine, dnnl_stream_default_flags);
    dnnl_memory_desc_init_by_tag(&any[0], 4, x, dnnl_f32, dnnl_format_tag_any);
    dnnl_memory_desc_init_by_tag(&any[1], 4, w, dnnl_f32, dnnl_format_tag_any);
    dnnl_memory_desc_init_by_tag(&any[2], 1, b, dnnl_f32, dnnl_a);
    any[3] = any[0];
    dnnl_convolution_forward_desc_init(&desc, dnnl_forward_inference, dnnl_convolution_auto, &any[0], &any[1], &any[2], &any[3], one, pad, pad);
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

static void run_torch(void)
{
    static const char *const names[3] = {"renderer", "inversion", "convolution"};
    static const char *const pythons[2] = {"python3", "/usr/bin/python3"};
    char line[200], command[200], name[64], version[64];
    int i, p;
    for (p = 0; p < 2 && torch_version[0] == 0; ++p) {
        FILE *f;
        snprintf(command, sizeof command, "%s tests/bench/bench_nn_torch.py 2>/dev/null", pythons[p]);
        f = popen(command, "r");
        while (f && fgets(line, sizeof line, f)) {
            int threads;
            double seconds;
            if (sscanf(line, "%63s %d %lf %63s", name, &threads, &seconds, version) < 3) continue;
            if (strcmp(name, "version") == 0) strcpy(torch_version, version);
            for (i = 0; i < 3; ++i)
                if (strcmp(name, names[i]) == 0) torch_time[i][threads] = seconds;
        }
        if (f) pclose(f);
    }
    if (torch_version[0] == 0) printf("PyTorch: not found, skipped\n");
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

static void bench_renderer(void)
{
    static const ms_nn_dtype types[4] = {MS_NN_F32, MS_NN_BF16, MS_NN_F16, MS_NN_I8};
    size_t outputs = (size_t)(3 * side * side);
    float *reference = (float *)malloc(outputs * sizeof(float));
    double f32 = 0, wall1 = 0;
    int k;
    fprintf(md, "\n| renderer %d x %d, one picture | ms | x f32 | PSNR against f32, dB | file, MB | GB/s | two threads, ms |\n|---|---:|---:|---:|---:|---:|---:|\n", side, side);
    for (k = 0; k < 4; ++k) {
        nets_file *f = (nets_file *)malloc(sizeof *f);
        runner r, two;
        bench_time t;
        char label[64];
        double quality, both;
        test_pool pool;
        if (nets_renderer(f, side, 64, 1000, types[k])) exit(1);
        r = runner_make(f, MS_SIMD_AUTO, no_threads(), 1);
        record("renderer load, no folds", ms_nn_dtype_string(types[k]), r.load, 0);
        runner_free(&r);
        r = runner_make(f, MS_SIMD_AUTO, no_threads(), 0);
        record("renderer load", ms_nn_dtype_string(types[k]), r.load, 0);
        if (types[k] == MS_NN_F32) {
            memory_job memory;
            bench_pair p;
            memory.bytes = f->bytes;
            memory.size = f->size;
            memory.sum = 0;
            p = bench_compare(run_read, &memory, run_forward, &r, 9);
            record("memory read", "one thread", p.a.median, p.a.spread);
            fprintf(csv, "renderer over read,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
            printf("renderer / read of the file: %.3f +- %.3f (read %.1f GB/s)\n", p.ratio.median, p.ratio.spread, (double)f->size / p.a.median * 1e-9);
            fprintf(md, "| reading the f32 file, nothing else | %.1f | | | %.0f | %.1f | |\n", 1e3 * p.a.median, (double)f->size * 1e-6, (double)f->size / p.a.median * 1e-9);
#if defined(HAVE_OPENBLAS)
            {
                blas_job blas;
                const ms_nn_tensor *w = ms_nn_file_find(ms_nn_tensors(r.nn), "fc2.weight");
                runner l;
                uint64_t state = 3;
                int i;
                float *h = (float *)malloc(1000 * sizeof(float)), *y = (float *)malloc(outputs * sizeof(float));
                openblas_set_num_threads(1);
                blas.w = (const float *)w->data;
                blas.x = h;
                blas.y = y;
                blas.rows = (int)outputs;
                blas.cols = 1000;
                for (i = 0; i < 1000; ++i) h[i] = nets_uniform(&state);
                l = r; /* the same matrix: a view of the network's last layer */
                {
                    ms_nn view = *r.nn;
                    view.op += view.ops - 1;
                    view.ops = 1;
                    view.inner.c = 1000;
                    view.inner.h = view.inner.w = 1;
                    view.input.rank = 1;
                    view.input.size[0] = 1000;
                    l.nn = &view;
                    l.x = h;
                    p = bench_compare(run_forward, &l, run_sgemv, &blas, 9);
                }
                record("last layer", "ms_nn f32", p.a.median, p.a.spread);
                record("last layer", "OpenBLAS sgemv", p.b.median, p.b.spread);
                fprintf(csv, "sgemv over ms_nn,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
                printf("OpenBLAS / ms_nn on the last layer: %.2f +- %.2f\n", p.ratio.median, p.ratio.spread);
                fprintf(md, "| last layer: OpenBLAS sgemv | %.1f | | | | %.1f | |\n| last layer: ms_nn f32 | %.1f | | | | %.1f | |\n", 1e3 * p.b.median,
                        (double)w->bytes / p.b.median * 1e-9, 1e3 * p.a.median, (double)w->bytes / p.a.median * 1e-9);
                free(h);
                free(y);
            }
#else
            printf("OpenBLAS: not found, skipped\n");
#endif
        }
        t = bench_run(run_forward, &r, 9);
        wall1 = wall(run_forward, &r, 5);
        two = runner_make(f, MS_SIMD_AUTO, test_parallel(&pool, 2), 0);
        both = wall(run_forward, &two, 5);
        runner_free(&two);
        if (k == 0) {
            f32 = t.median;
            memcpy(reference, r.y, outputs * sizeof(float));
        }
        quality = k ? psnr(r.y, reference, outputs) : 0;
        snprintf(label, sizeof label, "%s", ms_nn_dtype_string(types[k]));
        record("renderer", label, t.median, t.spread);
        record("renderer, two threads (wall)", label, both, 0);
        record("renderer, one thread (wall)", label, wall1, 0);
        fprintf(csv, "renderer psnr,%s,%.4g,0\n", label, quality);
        printf("  %.2f x f32, PSNR %.1f dB\n", f32 / t.median, quality);
        fprintf(md, "| ms_nn %s | %.1f +- %.1f | %.2f | ", label, 1e3 * t.median, 1e3 * t.spread, f32 / t.median);
        if (k) fprintf(md, "%.0f", quality);
        fprintf(md, " | %.0f | %.1f | %.1f |\n", (double)f->size * 1e-6, (double)f->size / t.median * 1e-9, 1e3 * both);
        runner_free(&r);
        free(f->bytes);
        free(f);
    }
    if (torch_time[0][1] > 0) {
        record("renderer", "PyTorch f32", torch_time[0][1], 0);
        printf("PyTorch / ms_nn: %.2f\n", torch_time[0][1] / f32);
        fprintf(md, "| PyTorch %s f32 | %.1f | %.2f | | | | %.1f |\n", torch_version, 1e3 * torch_time[0][1], f32 / torch_time[0][1], 1e3 * torch_time[0][2]);
    }
    free(reference);
}

static void bench_convolution(void)
{
    nets_file *f = (nets_file *)malloc(sizeof *f);
    double macs = 205.0 * 205 * 32 * 32 * 9;
    int level;
    test_pool pool;
    runner r;
    nets_begin(f, "[32,205,205]");
    nets_layer(f, "{\"type\":\"conv2d\",\"name\":\"c\",\"filters\":32,\"kernel\":3,\"padding\":\"same\"}", "c", MS_NN_F32, 4, 32, 32, 3, 3);
    nets_end(f);
    fprintf(md, "\n| Conv2D 32 -> 32, 3 x 3, 205 x 205 | ms | G multiply-adds/s |\n|---|---:|---:|\n");
    for (level = MS_SIMD_AVX512; level >= MS_SIMD_SCALAR; --level) {
        bench_time t;
        r = runner_make(f, (ms_simd)level, no_threads(), 0);
        if ((int)ms_nn_simd(r.nn) == level) {
            t = bench_run(run_forward, &r, level == MS_SIMD_SCALAR ? 3 : 9);
            record("convolution", ms_simd_string((ms_simd)level), t.median, t.spread);
            fprintf(md, "| ms_nn %s | %.2f +- %.2f | %.1f |\n", ms_simd_string((ms_simd)level), 1e3 * t.median, 1e3 * t.spread, macs / t.median * 1e-9);
        }
        runner_free(&r);
    }
    r = runner_make(f, MS_SIMD_AUTO, no_threads(), 0);
#if defined(HAVE_DNNL)
    {
        dnnl_job d;
        bench_pair p;
        dnnl_make(&d, 32, 205);
        p = bench_compare(run_forward, &r, run_dnnl, &d, 15);
        record("convolution", "oneDNN", p.b.median, p.b.spread);
        fprintf(csv, "oneDNN over ms_nn,ratio,%.4g,%.2g\n", p.ratio.median, p.ratio.spread);
        printf("oneDNN / ms_nn: %.3f +- %.3f\n", p.ratio.median, p.ratio.spread);
        fprintf(md, "| oneDNN %d.%d, blocked layouts, no reorders | %.2f +- %.2f | %.1f |\n", dnnl_version()->major, dnnl_version()->minor, 1e3 * p.b.median,
                1e3 * p.b.spread, macs / p.b.median * 1e-9);
    }
#else
    printf("oneDNN: not found, skipped\n");
#endif
    {
        double one = wall(run_forward, &r, 9), two;
        runner t = runner_make(f, MS_SIMD_AUTO, test_parallel(&pool, 2), 0);
        two = wall(run_forward, &t, 9);
        printf("convolution on two threads: %.2f x one\n", one / two);
        record("convolution, two threads (wall)", "auto", two, 0);
        record("convolution, one thread (wall)", "auto", one, 0);
        fprintf(md, "| ms_nn, two threads (wall; one: %.2f) | %.2f | %.1f |\n", 1e3 * one, 1e3 * two, macs / two * 1e-9);
        runner_free(&t);
    }
    if (torch_time[2][1] > 0) fprintf(md, "| PyTorch %s | %.2f | %.1f |\n", torch_version, 1e3 * torch_time[2][1], macs / torch_time[2][1] * 1e-9);
    runner_free(&r);
    free(f->bytes);
    free(f);
}

static void bench_inversion(void)
{
    static const ms_nn_dtype types[2] = {MS_NN_F32, MS_NN_I8};
    int k, number;
    fprintf(md, "\n| inversion networks of 4.3.1, %d x %d | parameters, M | multiply-adds, M | file, MB | workspace, MB | ms |\n|---|---:|---:|---:|---:|---:|\n", side, side);
    for (number = 2; number <= 8; number += number == 2 ? 2 : 4)
        for (k = 0; k < 2; ++k) {
            nets_file *f = (nets_file *)malloc(sizeof *f);
            runner r;
            bench_time t;
            double parameters = 0, macs = 0;
            char label[64];
            int i;
            if (nets_inversion(f, number, side, 19, types[k])) exit(1);
            r = runner_make(f, MS_SIMD_AUTO, no_threads(), 0);
            for (i = 0; i < ms_nn_layer_count(r.nn); ++i) {
                parameters += (double)ms_nn_layer_at(r.nn, i).parameters;
                macs += (double)ms_nn_layer_at(r.nn, i).multiply_adds;
            }
            t = bench_run(run_forward, &r, 9);
            snprintf(label, sizeof label, "%d %s", number, ms_nn_dtype_string(types[k]));
            record("inversion", label, t.median, t.spread);
            fprintf(md, "| %s | %.1f | %.0f | %.0f | %.1f | %.1f +- %.1f |\n", label, parameters * 1e-6, macs * 1e-6, (double)f->size * 1e-6,
                    (double)ms_nn_workspace_size(r.nn, MS_NN_FORWARD, 1) * 1e-6, 1e3 * t.median, 1e3 * t.spread);
            if (number == 2 && k == 0 && torch_time[1][1] > 0) {
                printf("PyTorch / ms_nn on inversion network 2: %.2f\n", torch_time[1][1] / t.median);
                fprintf(md, "| 2, PyTorch %s f32 | | | | | %.1f |\n", torch_version, 1e3 * torch_time[1][1]);
            }
            runner_free(&r);
            free(f->bytes);
            free(f);
        }
}

static void bench_shared(void)
{
    static const ms_nn_dtype types[4] = {MS_NN_F32, MS_NN_BF16, MS_NN_F16, MS_NN_I8};
    int k, level;
    fprintf(md, "\n| shared-channel renderer, 64 x 64, three channels | file, MB | scalar, ms | base | avx2 | avx512 |\n|---|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < 4; ++k) {
        nets_file *f = (nets_file *)malloc(sizeof *f);
        if (nets_shared(f, 64, types[k])) exit(1);
        fprintf(md, "| %s | %.1f |", ms_nn_dtype_string(types[k]), (double)f->size * 1e-6);
        for (level = MS_SIMD_SCALAR; level <= MS_SIMD_AVX512; ++level) {
            runner r = runner_make(f, (ms_simd)level, no_threads(), 0);
            bench_time t = bench_run(run_forward, &r, 31);
            char label[64];
            snprintf(label, sizeof label, "%s %s", ms_nn_dtype_string(types[k]), ms_simd_string((ms_simd)level));
            if ((int)ms_nn_simd(r.nn) == level) {
                record("shared channels", label, t.median, t.spread);
                fprintf(md, " %.3f |", 1e3 * t.median);
            } else {
                fprintf(md, " - |");
            }
            runner_free(&r);
        }
        fprintf(md, "\n");
        free(f->bytes);
        free(f);
    }
}

typedef struct collapse_job {
    const ms_nn_collapse *c;
    const float *x;
    void *workspace;
    double value, *residual, *jacobian;
} collapse_job;

static void run_value(void *context)
{
    collapse_job *j = (collapse_job *)context;
    if (ms_nn_collapse_value(j->c, j->x, &j->value, j->workspace) != MS_OK) exit(1);
}

static void run_residual(void *context)
{
    collapse_job *j = (collapse_job *)context;
    if (ms_nn_collapse_residual(j->c, j->x, j->residual, j->jacobian, j->workspace) != MS_OK) exit(1);
}

static void bench_collapse(void)
{
    nets_file *f = (nets_file *)malloc(sizeof *f);
    int pixels = side < 128 ? side : 128;
    collapse_job job;
    ms_nn_collapse *c = NULL;
    bench_time t, full;
    runner r;
    double start, made, target;
    if (nets_renderer(f, pixels, 64, 1000, MS_NN_F32)) exit(1);
    r = runner_make(f, MS_SIMD_AUTO, no_threads(), 0);
    full = bench_run(run_forward, &r, 9);
    start = bench_cpu();
    if (ms_nn_collapse_create(r.nn, NULL, &c, NULL) != MS_OK) exit(1);
    made = bench_cpu() - start;
    start = bench_cpu();
    if (ms_nn_collapse_target(c, r.y, NULL) != MS_OK) exit(1);
    target = bench_cpu() - start;
    job.c = c;
    job.x = r.x;
    job.workspace = malloc(ms_nn_collapse_workspace_size(c, 1));
    job.residual = (double *)malloc(1001 * sizeof(double));
    job.jacobian = (double *)malloc(1001 * 19 * sizeof(double));
    t = bench_run(run_value, &job, 15);
    record("collapse: QR", "1000 features", made, 0);
    record("collapse: target", "1000 features", target, 0);
    record("collapse: value", "1000 features", t.median, t.spread);
    fprintf(md, "\n| collapse, 1000 features, %d x %d | ms |\n|---|---:|\n| R (once a network) | %.0f |\n| target (once a target) | %.0f |\n| value | %.2f +- %.2f |\n", pixels,
            pixels, 1e3 * made, 1e3 * target, 1e3 * t.median, 1e3 * t.spread);
    t = bench_run(run_residual, &job, 9);
    record("collapse: residual and Jacobian", "1000 features", t.median, t.spread);
    record("picture for comparison", "f32", full.median, full.spread);
    fprintf(md, "| residual and Jacobian | %.2f +- %.2f |\n| the picture itself, for comparison | %.2f |\n", 1e3 * t.median, 1e3 * t.spread, 1e3 * full.median);
    ms_nn_collapse_destroy(c);
    free(job.workspace);
    free(job.residual);
    free(job.jacobian);
    runner_free(&r);
    free(f->bytes);
    free(f);
}

int main(int argc, char **argv)
{
    const char *only, *threads = getenv("OMP_NUM_THREADS");
    if (threads == NULL || strcmp(threads, "1")) { /* oneDNN's threads are set when its library starts */
        setenv("OMP_NUM_THREADS", "1", 1);
        execv(argv[0], argv);
    }
    only = argc > 1 && strcmp(argv[1], "small") ? argv[1] : "";
    if (argc > 1 && strcmp(argv[1], "small") == 0) side = 128;
    csv = bench_open("nn.csv");
    md = bench_open("nn.md");
    fprintf(csv, "what,how,seconds,spread\n");
    if (side == 410 && (!*only || strstr("torch renderer inversion", only))) run_torch();
    fprintf(md, "%s, one thread unless said, thread CPU time, medians of 9 runs; random weights; `make bench FILTER=nn`.\n", bench_processor());
    if (!*only || strcmp(only, "shared") == 0) bench_shared();
    if (!*only || strcmp(only, "convolution") == 0) bench_convolution();
    if (!*only || strcmp(only, "renderer") == 0) bench_renderer();
    if (!*only || strcmp(only, "inversion") == 0) bench_inversion();
    if (!*only || strcmp(only, "collapse") == 0) bench_collapse();
    fclose(csv);
    fclose(md);
    return 0;
}
