/* A host whose locale writes 1,5 for 1.5: what the headers and the examples' headers read and write stays as it is. The
   locale is made by localedef where none is installed. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "test.h"
#include <limits.h>
#include "files.h"
#include "mci.h"
#include "materials.h"
#include "materialx.h"
#include "plot.h"
#include "profile_csv.h"
#include "scores.h"

#define FOLDER "build/test_locale/"

static int comma_locale(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE", "nl_NL.UTF-8"};
    size_t i;
    for (i = 0; i < sizeof names / sizeof names[0]; ++i)
        if (setlocale(LC_ALL, names[i]) != NULL && strcmp(localeconv()->decimal_point, ",") == 0) return 1;
    return 0;
}

static int enter(void)
{
    if (comma_locale()) return 1;
    if (system("mkdir -p " FOLDER " && localedef -i de_DE -f UTF-8 " FOLDER "de_DE.UTF-8 >/dev/null 2>&1") != 0)
        return 0;
    setenv("LOCPATH", FOLDER, 1);
    return comma_locale();
}

static char *text_of(const char *path)
{
    char *text = test_read_file(path, NULL);
    if (text == NULL) TEST_FAIL("%s is not there", path);
    return text ? text : (char *)calloc(1, 1);
}

/* What is written, with and without. */
static void write_all(const char *to)
{
    static const double x[5] = {0.5, 1.5, 2.25, 3, 4.125}, y[5] = {1e-3, 0.25, 12.5, 100, 7};
    static const char mci[] = "1.0\n1\nx.mco A\n200\n0.01 0.01\n4 4 3\n1\n1\n1.4 1 90 0.5 0.1\n1.5\n";
    double parameters[19];
    char path[200];
    file_out out;
    mci_file file;
    ms_mcml_result result;
    ms_mcml_options options = ms_mcml_defaults();
    ms_error error;
    plot p;
    int i;
    snprintf(path, sizeof path, FOLDER "%s.mtlx", to);
    CHECK(file_create(path, &out) != NULL);
    materialx_begin(out.f);
    for (i = 0; i < 19; ++i) parameters[i] = 0.05 * i + 0.0123;
    materialx_write(out.f, "one", parameters, "predicted");
    CHECK(materialx_end(out.f));
    CHECK(file_finish(&out, 1) == NULL);
    plot_begin(&p, "a title with 1,5 and 2.5", "x", "y", PLOT_LOG_Y);
    plot_series(&p, "series", x, y, 5, PLOT_LINE | PLOT_DOTS);
    snprintf(path, sizeof path, FOLDER "%s.svg", to);
    CHECK(plot_write(&p, path));
    options.photons = 200;
    memset(&file, 0, sizeof file);
    CHECK_INT(mci_read(mci, sizeof mci - 1, &file, &error), MS_OK);
    CHECK_NEAR(file.runs[0].tissue.layers[0].n, 1.4, 0);
    CHECK_INT(ms_mcml_simulate(&file.runs[0].tissue, &file.runs[0].grid, &options, &result, &error), MS_OK);
    snprintf(path, sizeof path, FOLDER "%s.mco", to);
    CHECK_INT(mco_save(path, file.runs, &result, NULL, 1.5, &error), MS_OK);
    ms_mcml_result_destroy(&result);
    options.roulette_weight = 1.625;
    CHECK_INT(ms_mcml_simulate(&file.runs[0].tissue, &file.runs[0].grid, &options, &result, &error),
              MS_INVALID_ARGUMENT);
    CHECK(strncmp(error.message, "roulette_weight is 1.625, ", 26) == 0);
    mci_destroy(&file);
}

static void case_written(void)
{
    static const char *const kind[] = {"mtlx", "svg", "mco"};
    int i;
    CHECK(system("mkdir -p " FOLDER) == 0);
    setlocale(LC_ALL, "C");
    write_all("point");
    if (!enter()) SKIP("no locale with a decimal comma on this machine, and no localedef");
    write_all("comma");
    for (i = 0; i < 3; ++i) {
        char path[200], *a, *b;
        snprintf(path, sizeof path, FOLDER "point.%s", kind[i]);
        a = text_of(path);
        snprintf(path, sizeof path, FOLDER "comma.%s", kind[i]);
        b = text_of(path);
        CHECK(strlen(a) > 300 && strcmp(a, b) == 0);
        free(a);
        free(b);
    }
    setlocale(LC_ALL, "C");
}

static void read_all(void)
{
    static const char with_points[] = "\xEF\xBB\xBFx0,x1,score\n0.25,0.5,7.5\n1,1e-1,3\n",
                      with_commas[] = "x0;x1;score\n0,25;0,5;7,5\n# no\n1;1e-1;3";
    static const char tabs[] = "0,25\t0.5\t7,5\n1\t1e-1\t3\n",
                      rings[] = "r_mm,R,G,B\n0.25,4e-1,.3,0.2\n0.75,0.2,0.15,0.1\n1.25,0,0,0\n";
    static const char *const text[] = {with_points, with_commas, tabs};
    ms_sss_profile *profile;
    ms_error error;
    double total[3];
    int i;
    for (i = 0; i < 3; ++i) {
        scores s;
        materials m;
        const char *problem = file_save(FOLDER "in.csv", text[i], strlen(text[i]));
        CHECK(problem == NULL);
        problem = scores_read(FOLDER "in.csv", &s);
        if (problem) TEST_FAIL("%d: %s, line %d", i, problem, s.line);
        else
            CHECK(s.n == 2 && s.m == 2 && s.x[0] == 0.25 && s.x[1] == 0.5 && s.y[0] == 7.5 && s.x[3] == 0.1 &&
                  s.y[1] == 3);
        scores_free(&s);
        problem = materials_read(FOLDER "in.csv", i == 2 ? 3 : 2, &m);
        if (i == 2)
            CHECK(problem != NULL && strstr(problem, "7,5") == NULL &&
                  strstr(problem, "outside") != NULL); /* 7.5 is no parameter */
        else if (problem) TEST_FAIL("%d: %s", i, problem);
        else CHECK(m.count == 2 && m.x[0] == 0.25f && m.x[1] == 0.5f && m.x[3] == 0.1f);
        materials_free(&m);
    }
    CHECK_INT(profile_from_csv(&profile, rings, sizeof rings - 1, &error), MS_OK);
    ms_sss_profile_reflectance(profile, total);
    CHECK_NEAR(total[1], 3.14159265358979 * (0.3 * 0.25 + 0.15 * 0.75), 1e-12); /* two rings; rounding */
    ms_sss_profile_destroy(profile);
}

static void case_read(void)
{
    setlocale(LC_ALL, "C");
    read_all();
    if (!enter()) SKIP("no locale with a decimal comma on this machine, and no localedef");
    read_all();
    setlocale(LC_ALL, "C");
}

/* number_read against strtod of the C locale, for what both know; what is no number is none. */
static void case_numbers(void)
{
    static const char *const text[] = {"0",     "-1.5", "+2.5e3", "1e-300", "  7.25;", "12345678901234567890.5",
                                       ".5",    "5.",   "1e5,3",  "nan",    "inf",     "-infinity",
                                       "1.5.5", "1e",   "--1",    "",       "abc",     "e5",
                                       ".",     "1,5",  "1 2"};
    int round;
    size_t i;
    for (round = 0; round < 2; ++round)
        for (i = 0; i < sizeof text / sizeof text[0]; ++i) {
            char *end, *expected_end;
            double v, expected;
            setlocale(LC_ALL, "C");
            expected = strtod(text[i], &expected_end);
            if (round && !enter()) SKIP("no locale with a decimal comma on this machine, and no localedef");
            v = number_read(text[i], '.', &end);
            if (end != expected_end || (end != text[i] && !(v == expected || (v != v && expected != expected))))
                TEST_FAIL("'%s' is %g up to '%s', expected up to '%s'", text[i], v, end, expected_end);
            v = number_read("1,5;2", ',', &end);
            CHECK(v == 1.5 && strcmp(end, ";2") == 0);
            v = number_read("1.5;2", ',', &end);
            CHECK(v == 1.5 && strcmp(end, ";2") == 0);
        }
    setlocale(LC_ALL, "C");
}

/* Numbers in messages: as the C library's %.6g writes them, but with up to seven places before the point. */
static void case_messages(void)
{
    static const double special[] = {1.5,     999999.4, 999999.6,    9999994,   9999996,    1e5,     1.2e6,
                                     1e7,     -1,       -0.00012345, -9.9e-5,   -2.3e-308,  1.7e308, -1e100,
                                     1000000, 123457.5, HUGE_VAL,    -HUGE_VAL, (double)NAN};
    const int specials = (int)(sizeof special / sizeof special[0]);
    ms_sss_frame frame;
    ms_sss_filter_options filter = ms_sss_filter_defaults();
    ms_sss_kernel kernel;
    ms_mcml_options options = ms_mcml_defaults();
    const ms_mcml_layer layer = {1.4, 2, 180, 0.85, 0.1};
    const ms_mcml_tissue tissue = {1, 1, 1, &layer};
    const ms_mcml_grid grid = {0.01, 0.01, 10, 10, 3};
    ms_mcml_result result;
    ms_error error;
    float pixel[3] = {0, 0, 0};
    uint64_t state = test_seed;
    char expected[200];
    const int comma = enter();
    int i;
    for (i = 0; i < 2000 + specials; ++i) {
        const double x = i < specials ? special[i] : (i % 2 ? -1 : 1) * pow(10, 30 * test_uniform(&state) - 15);
        if (x >= 0 && x <= 1) continue; /* in range */
        options.roulette_weight = x;
        setlocale(LC_ALL, "C");
        snprintf(expected, sizeof expected, "roulette_weight is %.6g, expected 0 to 1", x);
        if (fabs(x) >= 999999.5 && fabs(x) < 9999995)
            snprintf(expected, sizeof expected, "roulette_weight is %.0f0, expected 0 to 1", x / 10);
        if (x != x) snprintf(expected, sizeof expected, "roulette_weight is nan, expected 0 to 1");
        if (comma) comma_locale();
        CHECK_INT(ms_mcml_simulate(&tissue, &grid, &options, &result, &error), MS_INVALID_ARGUMENT);
        if (strcmp(error.message, expected) != 0) TEST_FAIL("'%s', expected '%s'", error.message, expected);
    }
    setlocale(LC_ALL, "C");
    memset(&frame, 0, sizeof frame);
    memset(&kernel, 0, sizeof kernel);
    frame.width = frame.height = 1;
    frame.input = frame.output = ms_sss_planar(pixel, pixel + 1, pixel + 2);
    filter.ortho_height = filter.mm_per_unit = 1;
    kernel.tap_count = kernel.term_count = 1;
    kernel.radius_mm = 1;
    for (i = -3; i < 4; ++i) {
        const int count = i == -3 ? INT_MIN : i == 3 ? INT_MAX : i;
        if (i == 1 || i == 2) continue;
        snprintf(expected, sizeof expected, "kernel_count %d is not within 1 to 256", count);
        CHECK_INT(ms_sss_filter(&frame, &kernel, count, &filter, NULL, 0, &error), MS_INVALID_ARGUMENT);
        if (strcmp(error.message, expected) != 0) TEST_FAIL("'%s', expected '%s'", error.message, expected);
    }
    snprintf(expected, sizeof expected, "a workspace of %zu bytes: expected %zu", (size_t)10,
             ms_sss_filter_workspace(1, 1, &kernel, 1, &filter));
    CHECK_INT(ms_sss_filter(&frame, &kernel, 1, &filter, expected, 10, &error), MS_INVALID_ARGUMENT);
    if (strcmp(error.message, expected) != 0) TEST_FAIL("'%s', expected '%s'", error.message, expected);
}

static const test_case cases[] = {
    {"messages", case_messages}, {"written", case_written}, {"read", case_read}, {"numbers", case_numbers}};
TEST_MAIN_WITH_FILES(cases)
