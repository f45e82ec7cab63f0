/* What build/train is made of (examples/tools/train.h) against plain loops in double and finite differences, and the
   command itself as people use it: pictures of an analytic shader in folders and sheets, its network against the
   shader, runs that end early, bad input by file and line. */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "test.h"
#include "image.h"
#include "train.h"
#include <stdarg.h>
#include <sys/wait.h>

#define FOLDER "build/test_train_tool/"

/* --- the parts ---------------------------------------------------------------------------------------------------- */

static void test_product(void)
{
    static const int sizes[][3] = {{1, 1, 1}, {6, 16, 256}, {7, 17, 257}, {97, 515, 3}, {100, 33, 600}, {5, 1, 40}};
    train_work *w = (train_work *)malloc(sizeof *w);
    uint64_t seed = test_seed;
    double worst = 0;
    size_t t;
    int turned, add, i, j, p;
    for (t = 0; t < sizeof sizes / sizeof sizes[0]; ++t)
        for (turned = 0; turned < 4; ++turned)
            for (add = 0; add < 2; ++add) {
                int m = sizes[t][0], n = sizes[t][1], k = sizes[t][2];
                float *a = (float *)malloc((size_t)(m * k) * sizeof(float)),
                      *b = (float *)malloc((size_t)(k * n) * sizeof(float)),
                      *c = (float *)malloc((size_t)(m * n) * sizeof(float));
                train_matrix am = turned & 1 ? train_transposed(a, (size_t)m) : train_rows(a, (size_t)k),
                             bm = turned & 2 ? train_transposed(b, (size_t)k) : train_rows(b, (size_t)n);
                for (i = 0; i < m * k; ++i) a[i] = train_normal(&seed);
                for (i = 0; i < k * n; ++i) b[i] = train_normal(&seed);
                for (i = 0; i < m * n; ++i) c[i] = 3;
                train_product(w, m, n, k, am, bm, c, (size_t)n, add);
                for (i = 0; i < m; ++i)
                    for (j = 0; j < n; ++j) {
                        double s = add ? 3 : 0, size = 3;
                        for (p = 0; p < k; ++p) {
                            double v = (double)am.p[(size_t)i * am.row + (size_t)p * am.column] *
                                (double)bm.p[(size_t)p * bm.row + (size_t)j * bm.column];
                            s += v;
                            size += fabs(v);
                        }
                        worst = fmax(worst, fabs(s - (double)c[i * n + j]) / size);
                    }
                free(a);
                free(b);
                free(c);
            }
    CHECK_LE(worst, 3e-6); /* 600 terms of 6e-8 each do not all err to one side */
    TEST_NOTE("worst %.1e", worst);
    free(w);
}

/* Loss sum w . y of a network, in the trainer's floats. */
static double loss_of(const train_net *net, train_work *w, int n, const float *x, float *const *act,
                      const float *weight)
{
    double s = 0;
    int i, outputs = net->size[net->layers];
    train_forward(net, w, n, x, act);
    for (i = 0; i < n * outputs; ++i) s += (double)weight[i] * (double)act[net->layers - 1][i];
    return s;
}

/* Gradients by weights and inputs against central differences, for ELUs and SiLUs, the linear and the sigmoid end. */
static void test_gradient(void)
{
    static const int sizes[] = {5, 9, 7, 4};
    enum { N = 11 };
    train_work *w = (train_work *)malloc(sizeof *w);
    float x[N * 5], weight[N * 4], act0[2 * N * 9], act1[2 * N * 7], act2[2 * N * 4], g[N * 9], spare[N * 9], gx[N * 5],
        *act[3], *grad;
    uint64_t seed = test_seed + 5;
    int sigmoid, i;
    act[0] = act0, act[1] = act1, act[2] = act2;
    for (sigmoid = 0; sigmoid < 4; ++sigmoid) {
        train_net net;
        double worst = 0, size = 0;
        size_t k;
        CHECK(train_net_make(&net, sizes, 4, sigmoid & 1, &seed));
        net.silu = sigmoid >> 1;
        grad = (float *)calloc(net.count, sizeof(float));
        for (k = 0; k < net.count; ++k) net.p[k] *= 2; /* bends */
        for (i = 0; i < N * 5; ++i) x[i] = train_normal(&seed);
        for (i = 0; i < N * 4; ++i) g[i] = weight[i] = train_normal(&seed);
        (void)loss_of(&net, w, N, x, act, weight);
        train_backward(&net, w, N, x, act, g, spare, grad, gx);
        for (k = 0; k < net.count + N * 5; ++k) {
            float *at = k < net.count ? net.p + k : x + (k - net.count), keep = *at;
            double up, down, mine = (double)(k < net.count ? grad[k] : gx[k - net.count]);
            *at = keep + 4e-3f;
            up = loss_of(&net, w, N, x, act, weight);
            *at = keep - 4e-3f;
            down = loss_of(&net, w, N, x, act, weight);
            *at = keep;
            worst = fmax(worst, fabs((up - down) / 8e-3 - mine));
            size = fmax(size, fabs(mine));
        }
        CHECK_LE(
            worst,
            5e-3 * size); /* floats: 1e-6 over 8e-3, and a step's square over the kink of an ELU's second derivative */
        TEST_NOTE("%s, %s: worst %.1e of %.1e", sigmoid >> 1 ? "SiLU" : "ELU", sigmoid & 1 ? "sigmoid" : "linear",
                  worst, size);
        free(grad);
        free(net.p);
    }
    free(w);
}

/* The functions of the hidden layers and their slopes, against double. */
static void test_exp(void)
{
    double worst = 0;
    int i, silu;
    for (silu = 0; silu < 2; ++silu)
        for (i = -80000; i <= 80000; ++i) {
            float y = (float)i / 1000, slope;
            double x = (double)y, s = 1 / (1 + exp(-x));
            train__bend(silu, &y, &slope, 1);
            worst = fmax(worst, fabs((double)y - (silu ? x * s : x < 0 ? exp(x) - 1 : x)) / fmax(1, fabs(x)));
            worst = fmax(worst, fabs((double)slope - (silu ? s + x * s * (1 - s) : x < 0 ? exp(x) : 1)));
        }
    CHECK_LE(worst, 2e-6); /* roundings of 6e-8, of 1 - s times x, which is 17 where s becomes 1 */
    TEST_NOTE("worst %.1e", worst);
}

/* Pictures of known components: the basis spans them, variances are theirs, more asked for than there are is no harm,
   threads change nothing. */
static void test_components(void)
{
    enum { ROWS = 120, PIXELS = 1300, TRUE = 9 };
    uint16_t *value = (uint16_t *)malloc(ROWS * PIXELS * sizeof(uint16_t));
    double *exact = (double *)malloc(ROWS * ROWS * sizeof(double)),
           *vector = (double *)malloc(ROWS * ROWS * sizeof(double)), *eigen = (double *)malloc(ROWS * sizeof(double));
    float a[ROWS * TRUE], b[PIXELS * TRUE], mean[PIXELS];
    uint64_t seed = test_seed + 9;
    train_components c[2];
    train_pictures y;
    train_pool pool;
    int i, j, k, t, asked;
    for (i = 0; i < ROWS * TRUE; ++i) a[i] = train_uniform(&seed);
    for (i = 0; i < PIXELS * TRUE; ++i) b[i] = train_uniform(&seed);
    for (i = 0; i < ROWS; ++i)
        for (j = 0; j < PIXELS; ++j) {
            float s = 0;
            for (k = 0; k < TRUE; ++k) s += a[i * TRUE + k] * b[j * TRUE + k] * powf(0.6f, (float)k);
            value[i * PIXELS + j] = (uint16_t)(s * 12000);
        }
    y.value = value;
    y.rows = ROWS;
    y.pixels = PIXELS;
    y.mean = mean;
    for (asked = 6; asked <= 60; asked += 54) {
        for (t = 0; t < 2; ++t) {
            train_pool_start(&pool, 1 + 2 * t);
            CHECK(train_principal(&pool, &y, asked, 3, 1, &c[t]));
            train_pool_stop(&pool);
        }
        CHECK_INT(c[0].rank, asked);
        CHECK(memcmp(c[0].basis, c[1].basis, (size_t)(PIXELS * asked) * sizeof(float)) == 0);
        CHECK(memcmp(c[0].coordinate, c[1].coordinate, (size_t)(ROWS * asked) * sizeof(float)) == 0);
        /* the eigenvalues of the rows' products, by rotations of the whole matrix in double */
        for (i = 0; i < ROWS; ++i)
            for (j = 0; j <= i; ++j) {
                double s = 0;
                for (k = 0; k < PIXELS; ++k)
                    s += ((double)value[i * PIXELS + k] / 65535 - (double)mean[k]) *
                        ((double)value[j * PIXELS + k] / 65535 - (double)mean[k]);
                exact[i * ROWS + j] = exact[j * ROWS + i] = s / (double)ROWS;
            }
        if (asked == 6) train_eigen(ROWS, exact, vector, eigen);
        for (j = 0; j < 6; ++j) CHECK_NEAR(c[0].variance[j] / eigen[j], 1, 2e-5); /* floats in the products */
        for (i = 0; i < PIXELS; i += 97) { /* orthonormal columns, coordinates of them */
            double s = 0;
            for (k = 0; k < asked; ++k)
                s += (double)c[0].basis[i * asked + k] * (double)c[0].coordinate[17 * asked + k];
            if (asked == 60)
                CHECK_NEAR(s + (double)mean[i], (double)value[17 * PIXELS + i] / 65535,
                           2e-5); /* the pictures' own 16 bits */
        }
        for (j = 0; j < 6; ++j)
            for (k = 0; k <= j; ++k) {
                double s = 0;
                for (i = 0; i < PIXELS; ++i) s += (double)c[0].basis[i * asked + j] * (double)c[0].basis[i * asked + k];
                CHECK_NEAR(s, j == k, 1e-5);
            }
        for (t = 0; t < 2; ++t) train_components_free(&c[t]);
    }
    free(value);
    free(exact);
    free(vector);
    free(eigen);
}

/* --- the command -------------------------------------------------------------------------------------------------- */

enum { SIDE = 16, PARAMETERS = 6, OUTPUTS_ALL = 3 * SIDE * SIDE };

/* A shader of a few lines, linear light: a ball with a diffuse color (x0, x1, x2), a highlight of width x3, shared by
   x4 (0 or 1 in half of the materials: no highlight, or nothing else), on a floor whose brightness is x5. */
static void shade(const float *x, float *rgb)
{
    int u, v, c;
    for (v = 0; v < SIDE; ++v)
        for (u = 0; u < SIDE; ++u)
            for (c = 0; c < 3; ++c) {
                float px = ((float)u + 0.5f) / (float)SIDE * 2 - 1, py = ((float)v + 0.5f) / (float)SIDE * 2 - 1,
                      r = px * px + py * py, out = 0.1f + 0.5f * x[5] * (0.5f + 0.5f * py);
                if (r < 0.7f) {
                    float z = sqrtf(1 - r), light = fmaxf(0, 0.6f * z - 0.4f * px - 0.5f * py),
                          width = 0.05f + 0.4f * x[3];
                    float h = expf(-((px + 0.3f) * (px + 0.3f) + (py + 0.3f) * (py + 0.3f)) / width);
                    out = (1 - x[4]) * x[c] * light + x[4] * h * 0.8f;
                }
                rgb[3 * (v * SIDE + u) + c] = out;
            }
}

static void materials(float *x, int n, uint64_t seed)
{
    int i, j;
    for (i = 0; i < n; ++i)
        for (j = 0; j < PARAMETERS; ++j)
            x[i * PARAMETERS + j] = j == 4 && i % 2 ? (train_uniform(&seed) < 0.5f ? 0.0f : 1.0f)
                                                    : train_uniform(&seed);
}

/* Pictures and their table; x5 runs from -2 to 2 there. */
static void data_set(const char *folder, const char *ending, const float *x, int n)
{
    char path[200];
    FILE *f;
    int i, j;
    snprintf(path, sizeof path, "rm -rf %s", folder);
    CHECK(system(path) == 0);
    snprintf(path, sizeof path, "%s.csv", folder);
    CHECK(image_save(path, "", 0) == NULL); /* makes the folders */
    f = fopen(path, "wb");
    CHECK(f != NULL);
    fprintf(f, "base red,base green,base blue,width,share,floor\n");
    for (i = 0; i < n; ++i) {
        image im = image_new(SIDE, SIDE, 3);
        shade(x + i * PARAMETERS, im.pixels);
        if (strcmp(ending, "pfm") != 0) image_to_srgb(&im);
        snprintf(path, sizeof path, "%s/%05d.%s", folder, i, ending);
        CHECK(image_write(path, &im) == NULL);
        image_free(&im);
        for (j = 0; j < PARAMETERS; ++j)
            fprintf(f, "%.7g%s", (double)(j == 5 ? 4 * x[i * PARAMETERS + j] - 2 : x[i * PARAMETERS + j]),
                    j + 1 < PARAMETERS ? "," : "\n");
    }
    fclose(f);
}

static char said[20000];
static int run(const char *format, ...)
{
    char command[1500], whole[1700], *text;
    int status;
    va_list list;
    va_start(list, format);
    vsnprintf(command, sizeof command, format, list);
    va_end(list);
    snprintf(whole, sizeof whole, "%s >" FOLDER "log 2>&1", command);
    status = system(whole);
    text = test_read_file(FOLDER "log", NULL);
    snprintf(said, sizeof said, "%s", text ? text : "");
    free(text);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int exists(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (f) fclose(f);
    return f != NULL;
}

static int have_tool(void)
{
    image_save(FOLDER "log", "", 0); /* makes the folder */
    return exists("build/train");
}

/* Mean and least PSNR of a network against the shader on materials that it never saw. */
static void against_shader(const char *path, double *mean, double *least)
{
    enum { N = 50 };
    float x[N * PARAMETERS], *y = (float *)malloc(N * OUTPUTS_ALL * sizeof(float)), rgb[OUTPUTS_ALL];
    ms_nn *nn;
    ms_error error;
    int i, p;
    *mean = 0, *least = 1e9;
    if (ms_nn_load_file(path, NULL, &nn, &error) != MS_OK) {
        TEST_FAIL("%s: %s", path, error.message);
        free(y);
        return;
    }
    materials(x, N, 99);
    CHECK_INT(ms_nn_input_size(nn), PARAMETERS);
    CHECK_INT(ms_nn_output_size(nn), OUTPUTS_ALL);
    if (ms_nn_output_size(nn) == OUTPUTS_ALL) CHECK(ms_nn_forward(nn, N, x, y, NULL) == MS_OK);
    for (i = 0; i < N; ++i) {
        double s = 0;
        shade(x + i * PARAMETERS, rgb);
        for (p = 0; p < OUTPUTS_ALL; ++p) {
            double d = (double)y[i * OUTPUTS_ALL + p] -
                (double)image_srgb_encode(rgb[3 * (p % (SIDE * SIDE)) + p / (SIDE * SIDE)]);
            s += d * d;
        }
        s = -10 * log10(s / (double)OUTPUTS_ALL);
        *mean += s / (double)N;
        *least = fmin(*least, s);
    }
    ms_nn_destroy(nn);
    free(y);
}

static int same_files(const char *a, const char *b)
{
    size_t n = 0, m = 0;
    char *p = test_read_file(a, &n), *q = test_read_file(b, &m);
    int same = p && q && n == m && memcmp(p, q, n) == 0;
    free(p);
    free(q);
    return same;
}

#define TOY "build/train " FOLDER "%s " FOLDER "%s.csv " FOLDER "%s --rank 24 --width 48 --epochs %d %s"

static void test_pictures(void)
{
    enum { N = 500, EPOCHS = 80 };
    float *x = (float *)malloc(N * PARAMETERS * sizeof(float));
    double mean, least;
    ms_nn_file *file;
    ms_error error;
    if (!have_tool()) {
        free(x);
        SKIP("build/train is not there; make builds it");
    }
    materials(x, N, 1);
    data_set(FOLDER "pfm", "pfm", x, N);
    CHECK_INT(run(TOY, "pfm", "pfm", "a.safetensors", EPOCHS, ""), 0);
    CHECK(strstr(said, "share a network, inputs 0,3,4,5;1,3,4,5;2,3,4,5 of 6 parameters") != NULL);
    CHECK(strstr(said, "32 held out") != NULL && strstr(said, "s left") != NULL &&
          strstr(said, "held out: mean ") != NULL);
    against_shader(FOLDER "a.safetensors", &mean, &least);
    CHECK_LE(36, mean);  /* a picture of the mean material: 14 dB; the best of another seed's networks differ by 1 dB */
    CHECK_LE(20, least); /* the narrowest highlights, a pixel wide */
    TEST_NOTE("mean %.1f dB, least %.1f", mean, least);
    if (ms_nn_file_read(FOLDER "a.safetensors", NULL, &file, &error) == MS_OK) {
        CHECK(strcmp(ms_nn_file_metadata(file, "ms_parameters"), "base red,base green,base blue,width,share,floor") ==
              0);
        CHECK(strncmp(ms_nn_file_metadata(file, "ms_ranges"), "0:1,0:1,0:1,0:1,0:1,-1.99", 25) == 0);
        CHECK(strcmp(ms_nn_file_metadata(file, "ms_sharp"), "4") == 0);
        ms_nn_file_close(file);
    } else TEST_FAIL("%s", error.message);
    /* the same bits with three threads */
    CHECK_INT(run(TOY, "pfm", "pfm", "b.safetensors", EPOCHS, "--threads 3"), 0);
    CHECK(same_files(FOLDER "a.safetensors", FOLDER "b.safetensors"));
    /* an inversion network: what it answers draws a picture like the one it was given */
    CHECK_INT(run("build/train --inversion " FOLDER "a.safetensors " FOLDER
                  "inv --count 2 --first 24 --width 32 --steps 500"),
              0);
    {
        enum { M = 100 };
        float *y = (float *)malloc(M * OUTPUTS_ALL * sizeof(float)),
              *again = (float *)malloc(M * OUTPUTS_ALL * sizeof(float)), guess[M * PARAMETERS];
        ms_nn *renderer, *inverse;
        double s = 0, plain = 0;
        int i;
        CHECK(ms_nn_load_file(FOLDER "a.safetensors", NULL, &renderer, &error) == MS_OK);
        CHECK(ms_nn_load_file(FOLDER "inv2.safetensors", NULL, &inverse, &error) == MS_OK);
        materials(x, M, 7);
        CHECK(ms_nn_forward(renderer, M, x, y, NULL) == MS_OK && ms_nn_forward(inverse, M, y, guess, NULL) == MS_OK &&
              ms_nn_forward(renderer, M, guess, again, NULL) == MS_OK);
        for (i = 0; i < M * OUTPUTS_ALL; ++i) {
            double d = (double)(again[i] - y[i]), e = (double)(y[i] - y[(i + OUTPUTS_ALL) % (M * OUTPUTS_ALL)]);
            s += d * d;
            plain += e * e;
        }
        CHECK_LE(s, 0.05 * plain); /* against another material's picture: without learning it is about 1 */
        TEST_NOTE("inverted: RMSE %.1f of 255, another material %.1f", 255 * sqrt(s / (M * OUTPUTS_ALL)),
                  255 * sqrt(plain / (M * OUTPUTS_ALL)));
        ms_nn_destroy(renderer);
        ms_nn_destroy(inverse);
        free(y);
        free(again);
    }
    free(x);
}

/* Other forms of the same data: PNG, PPM, no sharing, a number of bytes, smaller pictures. */
static void test_forms(void)
{
    enum { N = 200 };
    float *x = (float *)malloc(N * PARAMETERS * sizeof(float));
    double mean, least;
    size_t size = 0;
    if (!have_tool()) {
        free(x);
        SKIP("build/train is not there; make builds it");
    }
    materials(x, N, 2);
    data_set(FOLDER "png", "png", x, N);
    CHECK_INT(run(TOY, "png", "png", "d.safetensors", 100, ""), 0);
    against_shader(FOLDER "d.safetensors", &mean, &least);
    CHECK_LE(28, mean); /* 200 pictures */
    TEST_NOTE("200 pictures: mean %.1f dB, least %.1f", mean, least);
    data_set(FOLDER "ppm", "ppm", x, N);
    CHECK_INT(run(TOY, "ppm", "ppm", "g.safetensors", 200, "--channels none"), 0);
    against_shader(FOLDER "g.safetensors", &mean, &least);
    CHECK_LE(24, mean); /* a third of the examples, and more to learn */
    CHECK_INT(run(TOY, "ppm", "ppm", "h.safetensors", 2, "--bytes 26k"), 0);
    free(test_read_file(FOLDER "h.safetensors", &size));
    CHECK(size <= 26000 && size > 18000);
    CHECK_INT(run(TOY, "ppm", "ppm", "j.safetensors", 2, "--size 8"), 0);
    free(x);
}

/* Pictures in which three scalars that stand beside each other hardly matter, with noise: they are not taken for a
   color's channels (they were, since leaving them out helps a regression), and the base color still is. */
static void test_channels(void)
{
    enum { N = 300, COLUMNS = 7 };
    static const float noise[3] = {0, 0.15f, 0.6f};
    uint64_t seed = test_seed + 21;
    int round, i, j, u, v, c;
    if (!have_tool()) SKIP("build/train is not there; make builds it");
    for (round = 0; round < 3; ++round) {
        FILE *f;
        CHECK(system("rm -rf " FOLDER "noise") == 0);
        CHECK(image_save(FOLDER "noise.csv", "", 0) == NULL);
        f = fopen(FOLDER "noise.csv", "wb");
        CHECK(f != NULL);
        fprintf(f, "base red,base green,base blue,clearcoat,sheen,specular,floor\n");
        for (i = 0; i < N; ++i) {
            image im = image_new(SIDE, SIDE, 3);
            char path[200];
            float x[COLUMNS];
            for (j = 0; j < COLUMNS; ++j) {
                x[j] = train_uniform(&seed);
                fprintf(f, "%.7g%s", (double)x[j], j + 1 < COLUMNS ? "," : "\n");
            }
            for (v = 0; v < SIDE; ++v)
                for (u = 0; u < SIDE; ++u)
                    for (c = 0; c < 3; ++c) {
                        float px = ((float)u + 0.5f) / (float)SIDE * 2 - 1,
                              py = ((float)v + 0.5f) / (float)SIDE * 2 - 1, z = sqrtf(fmaxf(0, 1 - px * px - py * py)),
                              light, *out = &im.pixels[3 * (v * SIDE + u) + c];
                        light = z > 0 ? x[c] * z + 0.04f * x[3] * expf(-50 * (px * px + py * py)) +
                                0.015f * x[4] * (1 - z) + 0.005f * x[5] * z
                                      : 0.1f + 0.5f * x[6];
                        *out = fmaxf(0, light + noise[round] * sqrtf(fmaxf(light, 0.01f)) * train_normal(&seed));
                    }
            snprintf(path, sizeof path, FOLDER "noise/%05d.pfm", i);
            CHECK(image_write(path, &im) == NULL);
            image_free(&im);
        }
        fclose(f);
        CHECK_INT(run("build/train " FOLDER "noise " FOLDER "noise.csv " FOLDER
                      "noise.safetensors --epochs 1 --width 16 --rank 12"),
                  0);
        if (strstr(said, "inputs 0,3,4,5,6;1,3,4,5,6;2,3,4,5,6 of") == NULL)
            TEST_FAIL("noise %.2f: %s", (double)noise[round], said);
    }
}

/* Few pictures with much noise: training stops before the end, says so, and saves the network of the least error. With
   clean ones it goes on. */
static void test_stops(void)
{
    enum { N = 150 };
    static const float noise[2] = {0, 0.3f};
    float *x = (float *)malloc(N * PARAMETERS * sizeof(float));
    uint64_t seed = test_seed + 31;
    int round, i, p, stopped, of, since;
    if (!have_tool()) {
        free(x);
        SKIP("build/train is not there; make builds it");
    }
    materials(x, N, 11);
    for (round = 0; round < 2; ++round) {
        const char *at;
        double least = -1;
        data_set(FOLDER "stop", "pfm", x, N);
        for (i = 0; i < N; ++i) {
            image im;
            char path[100];
            snprintf(path, sizeof path, FOLDER "stop/%05d.pfm", i);
            CHECK(image_read(path, &im) == NULL);
            for (p = 0; p < 3 * SIDE * SIDE; ++p)
                im.pixels[p] = fmaxf(0, im.pixels[p] + noise[round] * train_normal(&seed));
            CHECK(image_write(path, &im) == NULL);
            image_free(&im);
        }
        CHECK_INT(run("build/train " FOLDER "stop " FOLDER "stop.csv " FOLDER
                      "stop.safetensors --rank 24 --width 96 --epochs 200 --held-out 60 --channels none"),
                  0);
        at = strstr(said, "stopped after ");
        if (round == 0) {
            CHECK(at == NULL && strstr(said, "epoch 200 of 200") != NULL);
            continue;
        }
        if (at == NULL ||
            sscanf(at,
                   "stopped after %d of %d epochs: the error of the held-out pictures has not fallen "
                   "since epoch %d (%lf dB); more pictures",
                   &stopped, &of, &since, &least) != 4) {
            TEST_FAIL("it does not say that it stops: %s", said);
            continue;
        }
        CHECK(of == 200 && since >= 1 && stopped == since + 67); /* a third, rounded up */
        at = strstr(said, "held out: mean ");
        CHECK(at != NULL);
        if (at) CHECK_NEAR(strtod(at + 15, NULL), least, 0.05); /* the saved weights have 11 bits */
        TEST_NOTE("noise: stopped after %d epochs at %.2f dB", stopped, least);
    }
    free(x);
}

static void refused(const char *text, int code)
{
    if (code != 1 && code != 2) TEST_FAIL("exit %d, expected a refusal with '%s': %s", code, text, said);
    if (strstr(said, text) == NULL) TEST_FAIL("'%s' is not in: %s", text, said);
}

/* --- data sets of `make dataset` ---------------------------------------------------------------------------------- */

enum { WIDE = 64, PART = 32 };

/* Blobs whose edge is finer than a pixel of 32 x 32, their heights a channel's albedo (x0, x1, x2), on a gradient of
   x6; linear light with noise of this deviation. */
static void parts(const char *folder, int first, int count, float noise, uint64_t seed)
{
    char path[200];
    FILE *f;
    int part, i, j, u, v, c;
    for (part = 0; part < count; ++part) {
        uint64_t materials_seed = (uint64_t)(first + part) * 77 + 5;
        unsigned char head[24] = {'m', 's', 'd', 's', 1, 0, 0, 0, WIDE, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, PART, 0, 0, 0};
        float x[PART][19];
        snprintf(path, sizeof path, "%s/part_%06d.bin", folder, first + part);
        CHECK(image_save(path, "", 0) == NULL);
        f = fopen(path, "wb");
        CHECK(f != NULL);
        fwrite(head, 1, 24, f);
        for (i = 0; i < PART; ++i)
            for (j = 0; j < 19; ++j) x[i][j] = train_uniform(&materials_seed);
        fwrite(x, sizeof x, 1, f); /* little-endian machines */
        for (i = 0; i < PART; ++i)
            for (v = 0; v < WIDE; ++v)
                for (u = 0; u < WIDE; ++u)
                    for (c = 0; c < 3; ++c) {
                        float px = ((float)u - 31.7f) / 20, py = ((float)v - 32.2f) / 20, r = sqrtf(px * px + py * py),
                              light;
                        unsigned half;
                        light = 0.1f + 0.3f * x[i][6] * (float)v / 64 + 0.5f * x[i][c] / (1 + expf(40 * (r - 1)));
                        light = fmaxf(0.01f, light + noise * train_normal(&seed));
                        memcpy(&half, &light, 4); /* a normal half, rounded down */
                        half = (half >> 13) - (112u << 10);
                        fputc((int)(half & 255), f);
                        fputc((int)(half >> 8 & 255), f);
                    }
        fclose(f);
    }
}

/* The first number behind `text` in what the tool said. */
static double told(const char *text)
{
    const char *at = strstr(said, text);
    return at ? strtod(at + strlen(text), NULL) : -1;
}

/* A trunk that learnt on averages, a pixels' layer of the full size regressed on it: edges are sharp again, and noise
   does not come through. */
static void test_larger(void)
{
    double coarse, large;
    if (!have_tool()) SKIP("build/train is not there; make builds it");
    parts(FOLDER "noisy", 0, 10, 0.08f, 1);
    parts(FOLDER "clean", 500, 1, 0, 1);
    CHECK_INT(run("build/train " FOLDER "noisy - " FOLDER
                  "small.safetensors --size 32 --rank 12 --width 32 --epochs 60 --check " FOLDER "clean"),
              0);
    coarse = told("check: mean ");
    CHECK_INT(run("build/train " FOLDER "noisy - " FOLDER "large.safetensors --trunk " FOLDER
                  "small.safetensors --rank 6 --check " FOLDER "clean"),
              0);
    large = told("check: mean ");
    CHECK_LE(30, coarse);
    CHECK_LE(coarse - 3,
             large); /* four times as many pixels from the same light: noise alone, taken as it is, leaves 28 dB */
    CHECK_INT(
        run("build/train --measure " FOLDER "large.safetensors - --check " FOLDER "clean --check " FOLDER "clean"), 0);
    CHECK_NEAR(told("large.safetensors: mean "), large, 0.011); /* the same pictures; printed to 0.01 */
    TEST_NOTE("32 x 32: %.1f dB, 64 x 64: %.1f dB", coarse, large);
    refused("--trunk needs a folder",
            run("build/train " FOLDER "pfm " FOLDER "pfm.csv " FOLDER "x --trunk " FOLDER "small.safetensors"));
    refused("--measure needs --check", run("build/train --measure " FOLDER "large.safetensors -"));
}

static void test_bad_input(void)
{
    enum { N = 40 };
    float x[N * PARAMETERS];
    image im = image_new(SIDE, SIDE, 3), large = image_new(2 * SIDE, 2 * SIDE, 3);
    char *table, *at;
    size_t size;
    if (!have_tool()) {
        image_free(&im);
        image_free(&large);
        SKIP("build/train is not there; make builds it");
    }
    materials(x, N, 3);
    data_set(FOLDER "bad", "pfm", x, N);
    table = test_read_file(FOLDER "bad.csv", &size);
    CHECK(table != NULL);
    /* the table */
    at = strrchr(table, '\n');
    *at = 0;
    at = strrchr(table, '\n');
    CHECK(image_save(FOLDER "short.csv", table, (size_t)(at + 1 - table)) == NULL);
    refused("none for 00039.pfm", run(TOY, "bad", "short", "x", 1, ""));
    refused("no such file", run(TOY, "bad", "nothing", "x", 1, ""));
    CHECK(image_save(FOLDER "nan.csv", "a,b\n1,2\n1,nan\n", 14) == NULL);
    refused("nan.csv: line 3: column 2 is 'nan', not a number", run(TOY, "bad", "nan", "x", 1, ""));
    CHECK(image_save(FOLDER "few.csv", "a,b\n1,2\n1\n", 10) == NULL);
    refused("few.csv: line 3: 1 columns, expected 2", run(TOY, "bad", "few", "x", 1, ""));
    CHECK(image_save(FOLDER "headless.csv", "1,2\n1,2\n", 8) == NULL);
    refused("the first line names the parameters", run(TOY, "bad", "headless", "x", 1, ""));
    /* the pictures */
    im.pixels[5] = NAN;
    CHECK(image_write(FOLDER "bad/00011.pfm", &im) == NULL);
    refused("00011.pfm: column 1, row 0 has a value", run(TOY, "bad", "bad", "x", 1, ""));
    im.pixels[5] = 0;
    CHECK(image_write(FOLDER "bad/00011.pfm", &im) == NULL);
    refused("00011.pfm: of one color alone", run(TOY, "bad", "bad", "x", 1, ""));
    CHECK(image_save(FOLDER "bad/00011.pfm", "PF\n16 16\n-1\n1234", 16) == NULL);
    refused("00011.pfm", run(TOY, "bad", "bad", "x", 1, ""));
    CHECK(image_write(FOLDER "bad/00011.pfm", &large) == NULL);
    refused("00011.pfm: 32 x 32 pixels", run(TOY, "bad", "bad", "x", 1, ""));
    remove(FOLDER "bad/00011.pfm");
    refused("39 pictures, but", run(TOY, "bad", "bad", "x", 1, ""));
    refused("not a divisor", run(TOY, "bad", "short", "x", 1, "--size 5"));
    CHECK(image_save(FOLDER "empty/part_000000.bin", "msds", 4) == NULL);
    refused("part_000000.bin: not a part", run(TOY, "empty", "bad", "x", 1, ""));
    /* the options */
    refused("--channels' is no option",
            (data_set(FOLDER "bad", "pfm", x, N), run(TOY, "bad", "bad", "x", 1, "--channels 0,9")));
    refused("is too few", run(TOY, "bad", "bad", "x", 1, "--bytes 10000"));
    refused("is no number", run(TOY, "bad", "bad", "x", 1, "--rank many"));
    refused("no renderer", run("build/train --inversion tests/data/nn/renderer_f16.safetensors " FOLDER "inv"));
    refused("cannot open", run("build/train --inversion " FOLDER "nothing.safetensors " FOLDER "inv"));
    CHECK(!exists(FOLDER "x"));
    free(table);
    image_free(&im);
    image_free(&large);
}

static const test_case cases[] = {{"products", test_product},
                                  {"gradients", test_gradient},
                                  {"exponentials", test_exp},
                                  {"principal components", test_components},
                                  {"a folder of pictures", test_pictures},
                                  {"other forms of pictures", test_forms},
                                  {"channels in noisy pictures", test_channels},
                                  {"an end before the last epoch", test_stops},
                                  {"larger pictures", test_larger},
                                  {"bad input", test_bad_input}};
TEST_MAIN_WITH_FILES(cases)
