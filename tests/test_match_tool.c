/* The command build/match (examples/tools/match.c) as people use it: one picture in every format and size, masks,
   alpha, names, exit codes, and old results that stay after a failure. */
#include "edits.h"
#include "test.h"
#include <sys/wait.h>

#define NET "tests/data/nn/renderer_f16.safetensors" /* 19 parameters to 8 x 8 pixels */
#define FOLDER "build/test_match_tool/"
#define CSV FOLDER "made/here/x.csv"
#define LOG FOLDER "log"
enum { S = 8, N = 19 };

/* Runs build/match NET with arguments; its exit code, and what it said in `said`. */
static char said[20000];
static const char *net = NET;
static int run(const char *arguments)
{
    char command[2000], *text;
    int status;
    snprintf(command, sizeof command, "build/match %s %s >" LOG " 2>&1", net, arguments);
    status = system(command);
    text = test_read_file(LOG, NULL);
    snprintf(said, sizeof said, "%s", text ? text : "");
    free(text);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int have_tool(void)
{
    FILE *f = fopen("build/match", "rb");
    if (f) fclose(f);
    image_save(FOLDER "log", "", 0); /* makes the folder */
    return f != NULL;
}

/* The row of parameters that was written, and the RMSE that was printed. */
static double answer(const char *arguments, double *x)
{
    char command[1500], *text, *at;
    double rmse = -1;
    int i;
    remove(CSV);
    snprintf(command, sizeof command, "%s --out-params " CSV, arguments);
    i = run(command);
    if (i != 0 && i != 3) TEST_FAIL("match %s: %s", arguments, said); /* 3: nothing like it can be drawn */
    at = strstr(said, "match: RMSE ");
    if (at) rmse = strtod(at + 12, NULL);
    text = test_read_file(CSV, NULL);
    if (text == NULL) return -1;
    at = strrchr(text, '\n');
    if (at) *at = 0;
    at = strrchr(text, '\n') ? strrchr(text, '\n') + 1 : text;
    for (i = 0; i < N; ++i) {
        x[i] = strtod(at, &at);
        if (*at == ',') ++at;
    }
    free(text);
    return rmse;
}

/* A picture in 256 levels, blown up by `factor`; channels 1, 3 or 4 (alpha 1). */
static image picture(int channels, int factor)
{
    image im = image_new(S * factor, S * factor, channels);
    int x, y, c;
    for (y = 0; y < S * factor; ++y)
        for (x = 0; x < S * factor; ++x)
            for (c = 0; c < channels; ++c)
                im.pixels[(y * S * factor + x) * channels + c] = c == 3
                    ? 1
                    : (float)(60 + 17 * (x / factor) + 3 * (y / factor) * (y / factor) + (channels > 2 ? 13 * c : 0)) /
                        400 * 256 / 255;
    for (x = 0; x < (int)image_count(&im); ++x) im.pixels[x] = (float)image_to_byte(im.pixels[x]) / 255;
    return im;
}

static void test_formats(void)
{
    static const struct {
        const char *name;
        int channels, factor, linear;
        double tolerance;
    } list[] = {{"a.ppm", 3, 1, 0, 0},        {"a.png", 3, 1, 0, 0},         {"alpha.png", 4, 1, 0, 1e-3},
                {"large.png", 3, 5, 0, 1e-2}, {"linear.pfm", 3, 1, 1, 1e-2}, {"large.pfm", 3, 3, 1, 1e-2}};
    double x[N], first[N];
    size_t k;
    int i;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    for (k = 0; k < sizeof list / sizeof list[0]; ++k) {
        image im = picture(list[k].channels, list[k].factor);
        char path[100];
        double rmse;
        if (list[k].linear) image_to_linear(&im);
        snprintf(path, sizeof path, FOLDER "%s", list[k].name);
        CHECK(image_write(path, &im) == NULL);
        rmse = answer(path, k ? x : first);
        CHECK(rmse > 0 && rmse < 1);
        CHECK((strstr(said, "brought to the renderer's 8 x 8") != NULL) == (list[k].factor > 1));
        /* a sRGB curve there and back costs a float's rounding, which 50 renders blow up; weights of 1 another
           objective's rounding */
        for (i = 0; i < N && k; ++i)
            if (!(fabs(x[i] - first[i]) <= list[k].tolerance))
                TEST_FAIL("%s: x%d = %g, %g from the PPM", list[k].name, i, x[i], first[i]);
        image_free(&im);
    }
    { /* gray is the same in three channels, from either format */
        image gray = picture(1, 1), three = image_new(S, S, 3);
        for (i = 0; i < 3 * S * S; ++i) three.pixels[i] = gray.pixels[i / 3];
        image_write(FOLDER "gray.pgm", &gray);
        image_write(FOLDER "gray.png", &gray);
        image_write(FOLDER "three.ppm", &three);
        answer(FOLDER "three.ppm", first);
        answer(FOLDER "gray.pgm", x);
        CHECK(memcmp(x, first, sizeof x) == 0);
        answer(FOLDER "gray.png", x);
        CHECK(memcmp(x, first, sizeof x) == 0);
        image_free(&gray);
        image_free(&three);
    }
}

/* What a mask hides does not matter, whether the mask is gray, in color, or the picture's own alpha; a mask of a few
   pixels says what it leaves open. */
static void test_masks(void)
{
    image im = picture(3, 1), rgba = picture(4, 1), gray = image_new(S, S, 1), color = image_new(S, S, 3),
          few = image_new(2 * S, 2 * S, 1);
    double x[N], first[N];
    int i, c;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    for (i = 0; i < S * S; ++i) {
        int hidden = i % S >= 5;
        gray.pixels[i] = (float)!hidden;
        for (c = 0; c < 3; ++c) {
            color.pixels[3 * i + c] = (float)!hidden;
            if (hidden) im.pixels[3 * i + c] = rgba.pixels[4 * i + c] = c == 1;
        }
        rgba.pixels[4 * i + 3] = (float)!hidden;
    }
    for (i = 0; i < 4; ++i) few.pixels[2 * S * (6 + i / 2) + 8 + i % 2] = 1;
    image_write(FOLDER "seen.ppm", &im);
    image_write(FOLDER "seen.png", &rgba);
    image_write(FOLDER "mask.pgm", &gray);
    image_write(FOLDER "mask.png", &color);
    image_write(FOLDER "few.png", &few);
    answer(FOLDER "seen.ppm --weights " FOLDER "mask.pgm", first);
    answer(FOLDER "seen.ppm --weights " FOLDER "mask.png", x);
    CHECK(memcmp(x, first, sizeof x) == 0);
    answer(FOLDER "seen.png", x);
    CHECK(memcmp(x, first, sizeof x) == 0);
    for (i = 0; i < S * S; ++i)
        if (i % S >= 5) im.pixels[3 * i] = 0.3f; /* something else where nothing counts */
    image_write(FOLDER "seen.ppm", &im);
    answer(FOLDER "seen.ppm --weights " FOLDER "mask.pgm", x);
    CHECK(memcmp(x, first, sizeof x) == 0);
    answer(FOLDER "seen.ppm --weights " FOLDER "few.png", x); /* three values for 19 parameters */
    CHECK(strstr(said, "hardly determines: 0, 1, 2") != NULL);
    image_free(&im);
    image_free(&rgba);
    image_free(&gray);
    image_free(&color);
    image_free(&few);
}

/* Names of a header line come back, in what is printed and in what is written. */
static void test_names(void)
{
    char header[400] = "", row[400] = "", text[900], *written;
    double x[N];
    int i;
    image im = picture(3, 1);
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    for (i = 0; i < N; ++i) {
        snprintf(header + strlen(header), sizeof header - strlen(header), "%sp%d", i ? "," : "", 3 * i);
        snprintf(row + strlen(row), sizeof row - strlen(row), "%s0.5", i ? "," : "");
    }
    snprintf(text, sizeof text, "%s\n%s\n", header, row);
    image_save(FOLDER "start.csv", text, strlen(text));
    image_write(FOLDER "a.ppm", &im);
    answer(FOLDER "a.ppm --start " FOLDER "start.csv", x);
    CHECK(strstr(said, "x: p0 ") != NULL && strstr(said, ", p54 ") != NULL);
    written = test_read_file(CSV, NULL);
    CHECK(written != NULL && strncmp(written, header, strlen(header)) == 0 && written[strlen(header)] == '\n');
    free(written);
    CHECK(rename(CSV, FOLDER "written.csv") == 0);
    answer(FOLDER "a.ppm --start " FOLDER "written.csv --cost 5", x); /* what it wrote, it reads */
    image_free(&im);
}

/* Frames of a sequence change by no more than asked; two views of one material count both; a picture that slipped is
   put back. */
static void test_sequences_and_views(void)
{
    image im = picture(3, 1), large;
    double x[N], start[N], alone[N];
    char row[900] = "", *at;
    int i, k;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    for (i = 0; i < N; ++i) {
        start[i] = i == 0 ? 0.02 : i == 1 ? 0.97 : 0.5;
        snprintf(row + strlen(row), sizeof row - strlen(row), "%s%g", i ? "," : "", start[i]);
    }
    snprintf(row + strlen(row), sizeof row - strlen(row), "\n");
    image_save(FOLDER "last.csv", row, strlen(row));
    image_write(FOLDER "a.ppm", &im);
    CHECK(answer(FOLDER "a.ppm --start " FOLDER "last.csv --change 0.05", x) > 0);
    for (i = k = 0; i < N; ++i) {
        CHECK(x[i] >= 0 && x[i] <= 1 && fabs(x[i] - start[i]) <= 0.05 + 1e-6);
        k += fabs(x[i] - start[i]) > 0.0499;
    }
    CHECK(k > 5); /* another picture: it goes as far as it may */
    CHECK(strstr(said, "standard deviations: ") != NULL);
    CHECK(answer(FOLDER "a.ppm --start " FOLDER "last.csv --change 0", x) > 0);
    for (i = 0; i < N; ++i) CHECK_NEAR(x[i], start[i], 1e-6);
    CHECK_INT(run(FOLDER "a.ppm --change 0.1"), 2);
    CHECK_INT(run(FOLDER "a.ppm --start " FOLDER "last.csv --change -1"), 2);
    /* the picture twice is the picture once; with another one beside it is neither */
    answer(FOLDER "a.ppm --cost 400", alone);
    CHECK(answer(FOLDER "a.ppm --cost 400 --view " NET " " FOLDER "a.ppm", x) > 0);
    CHECK(fabs(strtod(strstr(said, "match: RMSE ") + 12, NULL)) > 0);
    for (i = 0; i < N; ++i) CHECK_NEAR(x[i], alone[i], 1e-3);
    for (i = 0; i < 3 * S * S; ++i) im.pixels[i] *= 0.2f; /* a dark one */
    image_write(FOLDER "other.ppm", &im);
    answer(FOLDER "a.ppm --cost 400 --view " NET " " FOLDER "other.ppm", x);
    for (i = k = 0; i < N; ++i) k += fabs(x[i] - alone[i]) > 0.01;
    CHECK(k > 2);
    CHECK_INT(run(FOLDER "a.ppm --robust --view " NET " " FOLDER "other.ppm"), 2);
    CHECK_INT(run(FOLDER "a.ppm --view " NET), 2);
    CHECK(run(FOLDER "a.ppm --view tests/data/nn/act_elu.safetensors " FOLDER "other.ppm") == 1);
    image_free(&im);
    /* held-out material 0 of the sheet, two pixels off, by the shipped network */
    if (image_read("examples/data/materials.png", &large) == NULL && edit_tile(&large, 0, 64, &im) == NULL) {
        double straight, slipped, aligned;
        net = "examples/data/renderer_64.safetensors";
        image_write(FOLDER "straight.ppm", &im);
        edit__frame(&im, 1, 2, -1);
        image_write(FOLDER "slipped.ppm", &im);
        straight = answer(FOLDER "straight.ppm --inversion examples/data", x);
        slipped = answer(FOLDER "slipped.ppm --inversion examples/data", x);
        aligned = answer(FOLDER "slipped.ppm --inversion examples/data --align", x);
        net = NET;
        at = strstr(said, "the target lies ");
        CHECK(at != NULL && fabs(strtod(at + 16, &at) + 2) < 0.1 && fabs(strtod(at + 14, NULL) - 1) < 0.1);
        CHECK(slipped > 2 * straight);
        CHECK_LE(aligned, 1.2 * straight); /* less its border: another mean of the same errors */
        image_free(&im);
        image_free(&large);
    }
}

/* A brighter picture with a colored cast: --tint finds both and leaves a closer picture; frozen parameters stay,
   pulled ones hardly move. */
static void test_edits(void)
{
    image im = picture(3, 1), lit = picture(3, 1);
    char *text;
    double x[N], first[N], plain, tinted;
    int i, c;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    image_write(FOLDER "a.ppm", &im);
    plain = answer(FOLDER "a.ppm --out-png " FOLDER "drawn.png --cost 200",
                   first); /* a picture that the renderer can make, to 8 bits */
    CHECK(plain > 0);
    image_free(&im);
    CHECK(image_read(FOLDER "drawn.png", &im) == NULL);
    for (i = 0; i < S * S; ++i)
        for (c = 0; c < 3; ++c) {
            lit.pixels[3 * i + c] = im.pixels[3 * i + c] * (c == 0 ? 0.9f : c == 1 ? 0.7f : 0.5f) + 0.05f;
        }
    image_write(FOLDER "lit.png", &lit);
    plain = answer(FOLDER "lit.png --cost 300", x);
    tinted = answer(FOLDER "lit.png --cost 300 --tint", x);
    CHECK(strstr(said, "gain ") != NULL);
    CHECK(tinted < plain);
    answer(FOLDER "lit.png --cost 50 --exposure --robust", x);
    TEST_NOTE("RMSE %.4f, with --tint %.4f", plain, tinted);
    text = test_read_file(CSV, NULL); /* the last answer as a start of which three stay */
    if (text) image_save(FOLDER "last.csv", text, strlen(text));
    memcpy(first, x, sizeof first);
    answer(FOLDER "lit.png --start " FOLDER "last.csv --freeze 0,3,18", x);
    CHECK_NEAR(x[0], first[0], 1e-6);
    CHECK_NEAR(x[3], first[3], 1e-6);
    CHECK_NEAR(x[18], first[18], 1e-6);
    CHECK_INT(run(FOLDER "lit.png --start " FOLDER "last.csv --freeze 0,color"), 2);
    CHECK(strstr(said, "names or numbers") != NULL);
    CHECK_INT(run(FOLDER "lit.png --freeze 0"), 2);
    answer(FOLDER "lit.png --start " FOLDER "last.csv --pull 1e6", x);
    for (i = 0; i < N; ++i) CHECK_NEAR(x[i], first[i], 1e-3);
    free(text);
    image_free(&im);
    image_free(&lit);
}

/* A logo on the shipped renderer's picture: --robust ends near the picture without it. */
static void test_logo(void)
{
    image sheet, clean, painted, drawn;
    double x[N], off[2] = {0, 0};
    int k;
    size_t i;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    if (image_read("examples/data/materials.png", &sheet)) SKIP("examples/data/materials.png is not there");
    CHECK(edit_tile(&sheet, 20, 64, &clean) == NULL);
    CHECK(edit_apply(&edits_further[0], &clean, &clean, &painted));
    image_write(FOLDER "painted.png", &painted);
    net = "examples/data/renderer_64.safetensors";
    for (k = 0; k < 2; ++k) {
        answer(k ? FOLDER "painted.png --inversion examples/data --cost 100 --robust --out-png " FOLDER "again.png"
                 : FOLDER "painted.png --inversion examples/data --cost 100 --out-png " FOLDER "again.png",
               x);
        CHECK(image_read(FOLDER "again.png", &drawn) == NULL);
        for (i = 0; i < image_count(&drawn); ++i)
            off[k] += fabs((double)drawn.pixels[i] - (double)clean.pixels[i]) / (double)image_count(&drawn);
        image_free(&drawn);
    }
    net = NET;
    CHECK_LE(off[1], 0.5 * off[0]); /* a third in practice */
    TEST_NOTE("mean distance from the unpainted picture %.4f, with --robust %.4f", off[0], off[1]);
    image_free(&sheet);
    image_free(&clean);
    image_free(&painted);
}

/* What a match is worth: a held-out material, an edit of it, noise without a material; what others' formats are told;
   light without surroundings. */
static void test_verdict(void)
{
    static const struct {
        const char *start, *name;
        int length;
    } foreign[] = {{"\xff\xd8\xff\xe0", "JPEG", 4},
                   {"RIFF1234WEBP", "WebP", 12},
                   {"II*\0", "TIFF", 4},
                   {"MM\0*", "TIFF", 4},
                   {"BM12", "BMP", 4},
                   {"GIF89a", "GIF", 6},
                   {"\x76\x2f\x31\x01", "OpenEXR", 4}};
    image sheet, clean, mask, other;
    uint64_t state = 5;
    size_t k;
    int i, code;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    for (k = 0; k < sizeof foreign / sizeof foreign[0]; ++k) {
        CHECK(image_save(FOLDER "foreign.png", foreign[k].start, (size_t)foreign[k].length) == NULL);
        CHECK_INT(run(FOLDER "foreign.png"), 1);
        if (strstr(said, foreign[k].name) == NULL || strstr(said, "convert it to") == NULL) TEST_FAIL("%s", said);
    }
    if (image_read("examples/data/materials.png", &sheet)) SKIP("examples/data/materials.png is not there");
    CHECK(edit_tile(&sheet, 20, 64, &clean) == NULL);
    mask = image_new(64, 64, 1);
    for (i = 0; i < 64 * 64; ++i) mask.pixels[i] = (i % 64 - 32) * (i % 64 - 32) + (i / 64 - 32) * (i / 64 - 32) < 400;
    image_write(FOLDER "mask.png", &mask);
    image_write(FOLDER "clean.png", &clean);
    net = "examples/data/renderer_64.safetensors";
    CHECK_INT(run(FOLDER "clean.png --inversion examples/data --tint --weights " FOLDER "mask.png"), 0);
    CHECK(strstr(said, "verdict: as close as") != NULL && strstr(said, "hide the surroundings") != NULL);
    CHECK_INT(run(FOLDER "clean.png --inversion examples/data --tint"), 0);
    CHECK(strstr(said, "hide the surroundings") == NULL && strstr(said, "applied to the PNG") != NULL);
    for (i = 0; i < 3 * 32 * 64; ++i) clean.pixels[i] = 1 - clean.pixels[i];
    image_write(FOLDER "half.png", &clean);
    code = run(FOLDER "half.png --inversion examples/data");
    TEST_NOTE("half a negative: exit %d", code);
    for (k = 0; k <= 10; ++k) { /* one color: whatever is drawn, the color alone is nearer */
        for (i = 0; i < 3 * 64 * 64; ++i) clean.pixels[i] = 0.1f * (float)k;
        image_write(FOLDER "flat.png", &clean);
        CHECK_INT(run(FOLDER "flat.png --inversion examples/data"), 3);
        CHECK(strstr(said, "one color is as near") != NULL || strstr(said, "nothing like this picture") != NULL);
    }
    CHECK(edit_tile(&sheet, 20, 64, &other) == NULL); /* a budget without a step */
    image_write(FOLDER "clean.png", &other);
    image_free(&other);
    CHECK_INT(run(FOLDER "clean.png --inversion examples/data --cost 1"), 0);
    CHECK(strstr(said, "this is the first guess: cost spent before the first step") != NULL);
    CHECK_INT(run(FOLDER "clean.png --inversion examples/data --cost 20"), 0);
    CHECK(strstr(said, "this is the first guess") == NULL && strstr(said, "% of what varies") != NULL);
    for (i = 0; i < 3 * 64 * 64; ++i) clean.pixels[i] = (float)(test_uniform(&state) < 0.5);
    image_write(FOLDER "noise.png", &clean);
    CHECK_INT(run(FOLDER "noise.png --inversion examples/data --out-params " CSV), 3);
    CHECK(strstr(said, "nothing like this picture") != NULL);
    net = NET;
    image_free(&sheet);
    image_free(&clean);
    image_free(&mask);
}

static void test_mistakes(void)
{
    static const char *const list[][2] = {{"", "usage"},
                                          {FOLDER "a.ppm --quickly", "usage"},
                                          {FOLDER "a.ppm --cost", "usage"},
                                          {FOLDER "a.ppm b c", "usage"},
                                          {FOLDER "a.ppm --cost 1e9999", "--cost"},
                                          {FOLDER "a.ppm --cost nan", "--cost"},
                                          {FOLDER "a.ppm --cost 0", "--cost"},
                                          {FOLDER "a.ppm --cost 50x", "--cost"}};
    static const char *const files[][2] = {
        {FOLDER "missing.png", "missing.png"},
        {FOLDER "nan.pfm", "column 2, row 1 has a value that is negative or not finite"},
        {FOLDER "negative.pfm", "column 0, row 0"},
        {FOLDER "a.ppm --out-params build", "regular"},
        {FOLDER "a.ppm --out-png " FOLDER "a.ppm/x.png", "cannot"},
        {FOLDER "a.ppm --out-png " FOLDER "x.jpg", "should end"},
        {FOLDER "a.ppm --weights " FOLDER "negative.pfm", "weight 0 is -1"}};
    image im = picture(3, 1), bad = picture(3, 1);
    char *text;
    size_t k;
    if (!have_tool()) SKIP("build/match is not there; make builds it");
    image_write(FOLDER "a.ppm", &im);
    bad.pixels[3 * (S + 2) + 1] = (float)NAN;
    image_write(FOLDER "nan.pfm", &bad);
    bad.pixels[0] = -1;
    image_write(FOLDER "negative.pfm", &bad);
    for (k = 0; k < sizeof list / sizeof list[0]; ++k) {
        CHECK_INT(run(list[k][0]), 2);
        if (strstr(said, list[k][1]) == NULL || strchr(said, '\n') != strrchr(said, '\n'))
            TEST_FAIL("match %s: %s", list[k][0], said);
    }
    for (k = 0; k < sizeof files / sizeof files[0]; ++k) {
        CHECK_INT(run(files[k][0]), 1);
        if (strstr(said, files[k][1]) == NULL) TEST_FAIL("match %s: %s", files[k][0], said);
    }
    CHECK_INT(run("--help"), 0);
    CHECK(strncmp(said, "usage: match", 12) == 0);
    /* a full disk: the old result stays, and the exit code says so (files of at most 0 blocks) */
    image_save(FOLDER "old.csv", "old\n", 4);
    CHECK(system("ulimit -f 0; trap '' XFSZ; build/match " NET " " FOLDER "a.ppm --out-params " FOLDER
                 "old.csv >/dev/null 2>&1") != 0);
    text = test_read_file(FOLDER "old.csv", NULL);
    CHECK(text != NULL && strcmp(text, "old\n") == 0);
    free(text);
    CHECK(system("[ ! -e /dev/full ] || build/match " NET " " FOLDER "a.ppm >/dev/full 2>/dev/null") !=
          0); /* what is printed is a result too */
    image_free(&im);
    image_free(&bad);
}

static const test_case cases[] = {{"formats and sizes", test_formats},
                                  {"masks", test_masks},
                                  {"names", test_names},
                                  {"edits", test_edits},
                                  {"sequences and views", test_sequences_and_views},
                                  {"logo", test_logo},
                                  {"verdict", test_verdict},
                                  {"mistakes", test_mistakes}};
TEST_MAIN_WITH_FILES(cases)
