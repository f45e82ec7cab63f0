/* The command build/sss_filter (examples/tools/sss_filter.c): results, exit codes, sentences, and no file after a
 * failure. */
#include "image.h"
#include "test.h"
#include <sys/wait.h>
#include <unistd.h>

#define IRRADIANCE "build/test_sss_tool_e.pfm"
#define DEPTH "build/test_sss_tool_z.pfm"
#define OUT "build/test_sss_tool_out.pfm"
#define OUT_PNG "build/test_sss_tool_out.png"
#define BACK "build/test_sss_tool_back.pfm"
#define BACK_DEPTH "build/test_sss_tool_back_z.pfm"
#define LOG "build/test_sss_tool.log"

static int exists(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (f) fclose(f);
    return f != NULL;
}

/* Runs build/sss_filter; its exit code. What it said is in LOG. */
static int run(const char *arguments)
{
    char command[1000];
    int status;
    remove(OUT);
    remove(OUT_PNG);
    snprintf(command, sizeof command, "build/sss_filter %s >" LOG " 2>&1", arguments);
    status = system(command);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void need_tool(void)
{
    if (!exists("build/sss_filter")) SKIP("build/sss_filter is not there; make builds it");
}

/* A step in x of light 1 and 0.25, all at the same depth. */
static void write_inputs(int width, int height, float depth)
{
    image e = image_new(width, height, 3), z = image_new(width, height, 1);
    int i;
    for (i = 0; i < width * height; ++i) {
        z.pixels[i] = depth;
        e.pixels[3 * i] = e.pixels[3 * i + 1] = e.pixels[3 * i + 2] = i % width < width / 2 ? 1 : 0.25f;
    }
    CHECK(image_write(IRRADIANCE, &e) == NULL);
    CHECK(image_write(DEPTH, &z) == NULL);
    image_free(&e);
    image_free(&z);
}

static image read_out(const char *path)
{
    image im;
    const char *problem = image_read(path, &im);
    if (problem) {
        char *said = test_read_file(LOG, NULL);
        TEST_FAIL("%s: %s; the tool said '%s'", path, problem, said ? said : "");
        free(said);
    }
    return im;
}

/* --- results --- */

static void test_step(void)
{
    image a, b;
    int x;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(128, 32, 100);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 32 --taps 17"), 0); /* 1 mm a pixel */
    a = read_out(OUT);
    if (a.pixels == NULL) return;
    for (x = 1; x < 128; ++x) /* light crosses the edge, monotonously, the same in every row, red farthest */
        CHECK(a.pixels[3 * (5 * 128 + x)] <= a.pixels[3 * (5 * 128 + x - 1)] + 1e-6f);
    CHECK(a.pixels[3 * (5 * 128 + 66)] > 0.27f && a.pixels[3 * (5 * 128 + 61)] < 0.98f);
    CHECK(a.pixels[3 * (5 * 128 + 68)] > a.pixels[3 * (5 * 128 + 68) + 2]);
    CHECK_NEAR(a.pixels[3 * 64] + a.pixels[3 * 63], 1.25, 1e-5); /* the edge is symmetric */
    CHECK_NEAR(a.pixels[3 * 127], 0.25, 1e-3);                   /* far from the edge all stays */

    /* the same pixel size by perspective: 2 tan(fov / 2) * 100 = 32 */
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material SKIN1 --fov 18.180415 --taps 17"), 0);
    b = read_out(OUT);
    if (b.pixels == NULL) return;
    for (x = 0; x < 128; ++x) CHECK_NEAR(b.pixels[3 * x], a.pixels[3 * x], 1e-5); /* the angle has 8 digits */
    image_free(&b);

    /* and by scale: half the units, twice the millimeters */
    CHECK_INT(run("--taps 17 --ortho 16 --mm-per-unit 2 " IRRADIANCE " --material skin1 " DEPTH " " OUT), 0);
    b = read_out(OUT);
    if (b.pixels == NULL) return;
    for (x = 0; x < 128; ++x) CHECK_NEAR(b.pixels[3 * x], a.pixels[3 * x], 1e-6);
    image_free(&b);
    image_free(&a);
}

/* Every method and model shows the same edge, but for the two pixels on either side, where each spreads a pixel's own
   light in its way: within 0.05 of the step; a slice and one Gaussian, which are not the profile, within 0.12. It says
   what it took. */
static void test_methods(void)
{
    static const struct {
        const char *arguments, *says;
        double within;
    } way[] = {{"--model preintegrated --taps 129", "129 taps", 1e-6},
               {"", "gathered in space", 0.05},
               {"--method gather", "gathered in space", 0.05},
               {"--method taps", "two passes", 0.05},
               {"--method pyramid", "pyramid", 0.05},
               {"--model slice", "15 taps", 0.12}, /* of 17: a pair for each of 7 pixels */
               {"--model gaussians --taps 9", "9 taps", 0.12},
               {"--method auto --taps 7", "7 taps", 0.05}};
    image a, b;
    size_t i;
    int n;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(96, 48, 100);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 96 --model preintegrated --taps 129"), 0);
    a = read_out(OUT);
    for (n = 0; n < (int)(sizeof way / sizeof way[0]); ++n) {
        char line[300], *said;
        double most = 0;
        snprintf(line, sizeof line, IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 96 %s", way[n].arguments);
        CHECK_INT(run(line), 0);
        said = test_read_file(LOG, NULL);
        CHECK(said && strstr(said, way[n].says) != NULL);
        free(said);
        b = read_out(OUT);
        for (i = 3 * 24 * 96; a.pixels && b.pixels && i < 3 * 25 * 96; ++i) /* the middle row */
            if (i / 3 % 96 < 46 || i / 3 % 96 > 49) most = fmax(most, fabs((double)(a.pixels[i] - b.pixels[i])) / 0.75);
        CHECK_LE(most, way[n].within);
        image_free(&b);
    }
    image_free(&a);
}

static void test_strength(void)
{
    image e, full, half, none;
    size_t i;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(64, 8, 100);
    e = read_out(IRRADIANCE);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material marble --ortho 8"), 0);
    full = read_out(OUT);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material marble --ortho 8 --strength 0.5"), 0);
    half = read_out(OUT);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material marble --ortho 8 --strength 0"), 0);
    none = read_out(OUT);
    for (i = 0; e.pixels && full.pixels && half.pixels && none.pixels && i < image_count(&e); ++i) {
        CHECK_NEAR(half.pixels[i], 0.5 * ((double)full.pixels[i] + (double)e.pixels[i]), 1e-6); /* float rounding */
        CHECK(none.pixels[i] == e.pixels[i]);
    }
    image_free(&e);
    image_free(&full);
    image_free(&half);
    image_free(&none);
}

static void test_profile_file(void)
{
    image a, b;
    FILE *f;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(64, 8, 100);
    f = fopen("build/test_sss_tool.csv", "w"); /* no light beyond 0.2 mm: a pixel of 1 mm sees nothing of it */
    if (f == NULL) return;
    fputs("# narrow\n0.05,1,1,1\n0.15,0.5,0.5,0.5\n0.25,0,0,0\n", f);
    fclose(f);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --profile build/test_sss_tool.csv --ortho 8"), 0);
    a = read_out(OUT);
    b = read_out(IRRADIANCE);
    CHECK(a.pixels && b.pixels && memcmp(a.pixels, b.pixels, image_count(&a) * sizeof(float)) == 0);
    image_free(&a);
    image_free(&b);
    f = fopen("build/test_sss_tool.csv", "w");
    if (f == NULL) return;
    fputs("# broken\n0.05,1,1,1\n0.15,x,0.5,0.5\n", f);
    fclose(f);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --profile build/test_sss_tool.csv --ortho 8"), 1);
    {
        char *said = test_read_file(LOG, NULL);
        CHECK(said && strstr(said, "build/test_sss_tool.csv:3:") != NULL);
        free(said);
    }
    CHECK(!exists(OUT));
    remove("build/test_sss_tool.csv");
}

static void test_png(void)
{
    char *bytes;
    size_t size = 0;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(64, 8, 100);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT_PNG " --material skin1"), 0);
    bytes = test_read_file(OUT_PNG, &size);
    CHECK(bytes && size > 60 && memcmp(bytes + 1, "PNG", 3) == 0);
    free(bytes);
}

/* A side beyond the filters' range is named; it was called a lack of memory. */
static void test_too_wide(void)
{
    char *said;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(65537, 1, 100);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 8 --method taps"), 1);
    said = test_read_file(LOG, NULL);
    CHECK(said && strstr(said, "65537") != NULL);
    free(said);
    CHECK(!exists(OUT));
}

/* Background and broken depth take no part and come back as they were. */
static void test_odd_depth(void)
{
    static const float odd[] = {0.0f, -5.0f, (float)NAN, (float)INFINITY};
    image z, e, a;
    int i;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(64, 16, 100);
    z = read_out(DEPTH);
    e = read_out(IRRADIANCE);
    if (!z.pixels || !e.pixels) return;
    for (i = 0; i < 4; ++i) z.pixels[8 * 64 + 10 + 12 * i] = odd[i];
    CHECK(image_write(DEPTH, &z) == NULL);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 16"), 0);
    a = read_out(OUT);
    for (i = 0; a.pixels && i < 64 * 16 * 3; ++i)
        CHECK(a.pixels[i] >= 0.25f - 4e-6f && a.pixels[i] <= 1 + 4e-6f); /* rounding of 2 x 17 weights */
    for (i = 0; a.pixels && i < 4; ++i)
        CHECK(a.pixels[3 * (8 * 64 + 10 + 12 * i)] == e.pixels[3 * (8 * 64 + 10 + 12 * i)]);
    image_free(&z);
    image_free(&e);
    image_free(&a);
}

/* A dark sheet before a lit one: the nearer, the more shines through, red before blue; a dark back adds nothing. */
static void test_back(void)
{
    static const float distance[3] = {2, 4, 8};
    image e, z, a;
    float through[3][2] = {{0}};
    int i, k;
    need_tool();
    if (test_skip_reason[0]) return;
    write_inputs(48, 48, 100);
    e = image_new(48, 48, 3); /* dark */
    CHECK(image_write(IRRADIANCE, &e) == NULL);
    for (k = 0; k < 3; ++k) {
        z = image_new(48, 48, 1);
        for (i = 0; i < 48 * 48; ++i) {
            z.pixels[i] = 100 + distance[k];
            e.pixels[3 * i] = e.pixels[3 * i + 1] = e.pixels[3 * i + 2] = 1;
        }
        CHECK(image_write(BACK, &e) == NULL);
        CHECK(image_write(BACK_DEPTH, &z) == NULL);
        CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 24 --mm-per-unit 1 --back " BACK
                                 " --back-depth " BACK_DEPTH),
                  0);
        a = read_out(OUT);
        for (i = 0; a.pixels && i < 2; ++i) through[k][i] = a.pixels[3 * (24 * 48 + 24) + 2 * i];
        CHECK(through[k][0] > through[k][1]);
        CHECK(k == 0 || (through[k][0] < through[k - 1][0] && through[k][1] <= through[k - 1][1]));
        image_free(&a);
        image_free(&z);
    }
    CHECK(through[0][0] > 0.1f);
    memset(e.pixels, 0, 3 * 48 * 48 * sizeof(float));
    CHECK(image_write(BACK, &e) == NULL);
    CHECK_INT(run(IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 24 --mm-per-unit 1 --back " BACK
                             " --back-depth " BACK_DEPTH),
              0);
    a = read_out(OUT);
    for (i = 0; a.pixels && i < 3 * 48 * 48; ++i) CHECK(a.pixels[i] >= 0 && a.pixels[i] <= 0);
    TEST_NOTE("red through 2, 4, 8 mm: %.3f %.3f %.3f", (double)through[0][0], (double)through[1][0],
              (double)through[2][0]);
    image_free(&a);
    image_free(&e);
}

/* --- refusals --- */

static void test_refused(void)
{
    static const struct {
        const char *arguments;
        int code;
        const char *gist;
    } bad[] = {{"", 2, "three file names"},
               {IRRADIANCE " " DEPTH " --material skin1", 2, "three file names"},
               {IRRADIANCE " " DEPTH " " OUT " more.pfm --material skin1", 2, "fourth"},
               {IRRADIANCE " " DEPTH " " OUT, 2, "--material"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --profile x.csv", 2, "one of --material and --profile"},
               {IRRADIANCE " " DEPTH " " OUT " --material", 2, "value is expected"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --color red", 2, "unknown option"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --taps 8", 2, "--taps"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --taps 1", 2, "--taps"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --taps 7x", 2, "--taps"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --fov 180", 2, "--fov"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --fov nan", 2, "--fov"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 0", 2, "--ortho"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --ortho 1 --fov 30", 2, "exclude"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --mm-per-unit -1", 2, "--mm-per-unit"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --strength 1.5", 2, "--strength"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --back " IRRADIANCE, 2, "together"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --method taps --back " IRRADIANCE
                           " --back-depth " DEPTH,
                2, "gather"},
               {IRRADIANCE " " DEPTH " " OUT " --material skin1 --back " IRRADIANCE
                           " --back-depth build/test_sss_tool_small.pfm",
                1, "size differs"},
               {IRRADIANCE " " DEPTH " build/test_sss_tool_out.exr --material skin1", 2, ".pfm or .png"},
               {IRRADIANCE " " DEPTH " " OUT " --material granite", 1, "no such material"},
               {IRRADIANCE " " DEPTH " " OUT " --profile build/no_such.csv", 1, "build/no_such.csv"},
               {"build/no_such.pfm " DEPTH " " OUT " --material skin1", 1, "build/no_such.pfm: cannot open"},
               {IRRADIANCE " Makefile " OUT " --material skin1", 1, "Makefile: not a PFM"},
               {DEPTH " " DEPTH " " OUT " --material skin1", 1, "three channels"},
               {IRRADIANCE " " IRRADIANCE " " OUT " --material skin1", 1, "one channel"},
               {IRRADIANCE " build/test_sss_tool_small.pfm " OUT " --material skin1", 1, "size differs"},
               {IRRADIANCE " " DEPTH " tests/test.h/no.pfm --material skin1", 1, "cannot be made"}};
    int i, count = (int)(sizeof bad / sizeof bad[0]);
    image small;
    need_tool();
    if (test_skip_reason[0]) return;
    small = image_new(3, 3, 1);
    write_inputs(16, 8, 100);
    CHECK(image_write("build/test_sss_tool_small.pfm", &small) == NULL);
    for (i = 0; i < count; ++i) {
        int code = run(bad[i].arguments);
        char *said = test_read_file(LOG, NULL);
        if (code != bad[i].code) TEST_FAIL("'%s' ends with %d, expected %d", bad[i].arguments, code, bad[i].code);
        if (said == NULL || strstr(said, bad[i].gist) == NULL)
            TEST_FAIL("'%s' says '%s', which lacks '%s'", bad[i].arguments, said ? said : "", bad[i].gist);
        CHECK(!exists(OUT) && !exists(OUT_PNG));
        free(said);
    }
    TEST_NOTE("%d command lines", count);
    image_free(&small);
    remove("build/test_sss_tool_small.pfm");
}

static const test_case cases[] = {{"step", test_step},         {"methods", test_methods},
                                  {"strength", test_strength}, {"profile_file", test_profile_file},
                                  {"png", test_png},           {"odd_depth", test_odd_depth},
                                  {"too wide", test_too_wide}, {"back", test_back},
                                  {"refused", test_refused}};
TEST_MAIN_WITH_FILES(cases)
