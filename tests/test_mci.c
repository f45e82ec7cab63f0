/* examples/tools/mci.h: .mci files good and malformed, the text of .mco files byte by byte, finite beams. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"

#include "mci.h"

#include "test.h"
#include <locale.h>

static const char *const two_runs =
    "\xEF\xBB\xBF# a comment\r\n\r\n1.0   # version\r\n  2 # runs\r\n\t# indented comment\r\n"
    "a.mco\tA # name\r\n1e3 # photons\r\n20E-4 .1 text behind is ignored\r\n10 20 30\r\n2\r\n# n mua mus g d\r\n1.0\r\n"
    "1.3 20 200 0.70 0.01\r\n1.4 +10 200 -.9 1.0E+8\r\n1.5\r\n"
    "b.mco B\n20\n0.01 0.01\n80 80 1\n1\n1\n1.4 0 0 1 1e7\n1.33\n";

static void mci_good(void)
{
    mci_file f;
    ms_error e;
    char old_mac[2000];
    size_t i, n = strlen(two_runs);
    int round;
    memcpy(old_mac, two_runs, n);
    for (i = 0; i < n; ++i)
        if (old_mac[i] == '\n') old_mac[i] = i && old_mac[i - 1] == '\r' ? ' ' : '\r'; /* CR alone ends lines */
    for (round = 0; round < 2; ++round) {
        CHECK_INT(mci_read(round ? old_mac : two_runs, n, &f, &e), MS_OK);
        CHECK_INT(f.run_count, 2);
        CHECK(strcmp(f.runs[0].output, "a.mco") == 0 && f.runs[0].format == 'A' && f.runs[1].format == 'B');
        CHECK_INT(f.runs[0].photons, 1000);
        CHECK_INT(f.runs[0].line, 6);
        CHECK_NEAR(f.runs[0].grid.dz_cm, 20e-4, 0);
        CHECK_NEAR(f.runs[0].grid.dr_cm, 0.1, 0);
        CHECK_INT(f.runs[0].grid.nz, 10);
        CHECK_INT(f.runs[0].grid.nr, 20);
        CHECK_INT(f.runs[0].grid.na, 30);
        CHECK_INT(f.runs[0].tissue.layer_count, 2);
        CHECK_NEAR(f.runs[0].tissue.n_below, 1.5, 0);
        CHECK_NEAR(f.runs[0].tissue.layers[1].g, -0.9, 0);
        CHECK_NEAR(f.runs[0].tissue.layers[1].thickness_cm, 1e8, 0);
        CHECK_NEAR(f.runs[1].tissue.layers[0].n, 1.4, 0);
        mci_destroy(&f);
    }
    CHECK(f.runs == NULL);
    mci_destroy(NULL);
}

static void mci_malformed(void)
{
    /* line of a good file, what stands there instead, the line that is named, what the message says */
    static const struct {
        int line;
        const char *text;
        size_t named;
        const char *gist;
    } bad[] = {
        {2, "", 3, "number of runs"},
        {2, "0", 2, "number of runs"},
        {2, "x", 2, "number of runs"},
        {2, "1.5", 2, "whole"},
        {2, "2", 11, "output name"},
        {4, "-5", 4, "photons"},
        {4, "0", 4, "photons"},
        {4, "nan", 4, "photons"},
        {4, "5000000000", 4, "photons"},
        {5, "0.01", 5, "number 2 of 2"},
        {5, "0 0.01", 5, "dz"},
        {5, "0.01 -1", 5, "dz, dr"},
        {5, "0.01 1x", 5, "malformed"},
        {5, "0,01 0,01", 5, "malformed"},
        {6, "10 20", 6, "number 3 of 3"},
        {6, "0 20 30", 6, "dz, dr, da"},
        {6, "10 20.5 30", 6, "whole"},
        {6, "1e99 20 30", 6, "dz, dr, da"},
        {7, "0", 7, "layers"},
        {7, "99999", 7, "layers"},
        {7, "3", 11, "of a layer"},
        {8, "0", 8, "above"},
        {9, "1.4 -1 100 0.9 0.1", 9, "mu_a"},
        {9, "1.4 1 -100 0.9 0.1", 9, "mu_s"},
        {9, "1.4 1 100 1.5 0.1", 9, "g is"},
        {9, "1.4 1 100 -1 0.1", 9, "g is"},
        {9, "1.4 1 100 0.9 0", 9, "thickness"},
        {9, "0 1 100 0.9 0.1", 9, "refractive"},
        {9, "1.4 1 100 0.9", 9, "number 5 of 5"},
        {9, "1.4 1e 100 0.9 1", 9, "malformed"},
        {9, "1.4 1e999 100 0.9 1", 9, "expected"},
        {10, "abc", 10, "below"},
        {10, "", 11, "below"},
    };
    static const char *const good[] = {"1.0", "1", "a.mco A",           "100", "0.01 0.01", "10 20 30",
                                       "1",   "1", "1.4 1 100 0.9 0.1", "1"};
    char text[1000], name[600];
    mci_file f, before;
    ms_error e;
    size_t i;
    int k;
    memset(&f, 0x5a, sizeof f);
    before = f;
    for (i = 0; i < sizeof bad / sizeof *bad; ++i) {
        text[0] = 0;
        for (k = 1; k <= 10; ++k) {
            strcat(text, k == bad[i].line ? bad[i].text : good[k - 1]);
            strcat(text, "\n");
        }
        if (bad[i].line == 10 && bad[i].text[0] == 0) strcat(text, " # the end\n");
        CHECK_INT(mci_read(text, strlen(text), &f, &e), MS_BAD_DATA);
        CHECK(memcmp(&f, &before, sizeof f) == 0);
        if (e.position != bad[i].named && !(bad[i].named > 10 && e.position >= 10))
            TEST_FAIL("'%s': line %d is named, expected %d", bad[i].text, (int)e.position, (int)bad[i].named);
        snprintf(name, sizeof name, "line %d", (int)e.position);
        if (strstr(e.message, name) == NULL || strstr(e.message, bad[i].gist) == NULL)
            TEST_FAIL("'%s' does not say '%s' and '%s'", e.message, name, bad[i].gist);
    }
    TEST_NOTE("%d malformed files", (int)i);
    CHECK_INT(mci_read("", 0, &f, &e), MS_BAD_DATA);
    CHECK_INT((int)e.position, 1);
    CHECK_INT(mci_read("# nothing\n\n", 11, &f, &e), MS_BAD_DATA);
    CHECK_INT((int)e.position, 2);
    CHECK_INT(mci_read("2.0\n1\n", 6, &f, &e), MS_UNSUPPORTED);
    CHECK(strstr(e.message, "version is 2") != NULL);
    CHECK_INT(mci_read("one\n1\n", 6, &f, &e), MS_BAD_DATA);
    CHECK_INT(mci_read("\xFF\xFE"
                       "1",
                       3, &f, &e),
              MS_UNSUPPORTED);
    CHECK(strstr(e.message, "UTF-16") != NULL);
    CHECK_INT(mci_read("mcmli2.0\n", 9, &f, &e), MS_UNSUPPORTED);
    {
        static const char twice[] =
            "1\n2\na.mco A\n1\n1 1\n1 1 1\n1\n1\n1 1 1 0 1\n1\na.mco A\n1\n1 1\n1 1 1\n1\n1\n1 1 1 0 1\n1\n";
        CHECK_INT(mci_read(twice, sizeof twice - 1, &f, &e), MS_BAD_DATA);
        CHECK_INT(e.position, 11);
        CHECK(strstr(e.message, "a.mco") != NULL);
    }
    memset(name, 'x', 300);
    name[300] = 0;
    snprintf(text, sizeof text, "1\n1\n%s A\n1\n", name);
    CHECK_INT(mci_read(text, strlen(text), &f, &e), MS_BAD_DATA);
    CHECK(strstr(e.message, "255") != NULL);
    CHECK_INT(mci_load("tests/data/no such file.mci", &f, &e), MS_IO);
    CHECK(strstr(e.message, "no such file") != NULL);
}

static void numbers(void)
{
    uint64_t state = test_seed;
    long i;
    for (i = 0; i < 20000; ++i) { /* correctly rounded, as strtod is */
        const uint64_t bits = test_random_u64(&state);
        mci__text t;
        char text[64];
        double x, y = 0;
        if (i % 2) x = (test_uniform(&state) - 0.5) * pow(10, (double)(bits % 40) - 20);
        else memcpy(&x, &bits, sizeof x);
        if (!isfinite(x)) continue;
        snprintf(text, sizeof text, i % 3 ? "%.17g" : "%.4E", x);
        memset(&t, 0, sizeof t);
        t.p = text;
        t.stop = text + strlen(text);
        CHECK(mci__number(&t, &y) && t.p == t.stop);
        CHECK_NEAR(y, strtod(text, NULL), 0);
    }
}

static ms_mcml_result run(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_mcml_options *options)
{
    ms_mcml_result r;
    ms_error error;
    memset(&r, 0, sizeof r);
    if (ms_mcml_simulate(tissue, grid, options, &r, &error) != MS_OK) TEST_FAIL("%s", error.message);
    return r;
}

/* The text of an .mco file; free it. */
static char *printed(const mci_run *spec, const ms_mcml_result *r, double seconds)
{
    char *text = (char *)calloc(1, 200000);
    FILE *f = tmpfile();
    CHECK(f != NULL && text != NULL);
    mco_print(f, spec, r, NULL, seconds);
    rewind(f);
    CHECK(fread(text, 1, 199999, f) > 1000);
    fclose(f);
    return text;
}

/* The text that MCML 1.2.2 writes, line by line, with its own formats. */
static void mco_text(void)
{
    static char expected[200000];
    char *text;
    mci_file f;
    ms_mcml_options o = ms_mcml_defaults();
    ms_mcml_result r;
    ms_error e;
    const mci_run *run_spec;
    const char *german;
    char *p = expected;
    size_t i;
    CHECK_INT(mci_read(two_runs, strlen(two_runs), &f, &e), MS_OK);
    run_spec = &f.runs[0];
    o.photons = run_spec->photons;
    r = run(&run_spec->tissue, &run_spec->grid, &o);
    german = setlocale(LC_NUMERIC, "de_DE.UTF-8");
    text = printed(run_spec, &r, 3661.2);
    if (german) setlocale(LC_NUMERIC, "C");
    TEST_NOTE("comma locale %s", german ? "set" : "not installed");
#define P(...) p += sprintf(p, __VA_ARGS__)
    P("A1 \t# Version number of the file format.\n\n####\n# Data categories include: \n# InParm, RAT, \n"
      "# A_l, A_z, Rd_r, Rd_a, Tt_r, Tt_a, \n# A_rz, Rd_ra, Tt_ra \n####\n\n");
    P("# User time: %8.0f sec = %8.2f hr.   Simulation time of this run.\n\n", 3661.2, 3661.2 / 3600);
    P("InParm \t\t\t# Input parameters. cm is used.\na.mco \tA\t\t# output file name, ASCII.\n1000 \t\t\t# No. of photons\n");
    P("0.002\t0.1\t\t# dz, dr [cm]\n10\t20\t30\t# No. of dz, dr, da.\n\n2\t\t\t\t\t# Number of layers\n");
    P("#n\tmua\tmus\tg\td\t# One line for each layer\n1\t\t\t\t\t# n for medium above\n");
    P("1.3\t20\t200\t0.7\t0.01\t# layer 1\n1.4\t10\t200\t-0.9\t1E+08\t# layer 2\n1.5\t\t\t\t\t# n for medium below\n\n");
    P("RAT #Reflectance, absorption, transmission. \n%-14.6G \t#Specular reflectance [-]\n", r.specular);
    P("%-14.6G \t#Diffuse reflectance [-]\n%-14.6G \t#Absorbed fraction [-]\n%-14.6G \t#Transmittance [-]\n\n", r.rd,
      r.a, r.tt);
    P("A_l #Absorption as a function of layer. [-]\n%12.4G\n%12.4G\n\n", r.a_l[0], r.a_l[1]);
    P("A_z #A[0], [1],..A[nz-1]. [1/cm]\n");
    for (i = 0; i < 10; ++i) P("%12.4E\n", r.a_z[i]);
    P("\nRd_r #Rd[0], [1],..Rd[nr-1]. [1/cm2]\n");
    for (i = 0; i < 20; ++i) P("%12.4E\n", r.rd_r[i]);
    P("\nRd_a #Rd[0], [1],..Rd[na-1]. [sr-1]\n");
    CHECK((size_t)(p - expected) < strlen(text));
    if (memcmp(text, expected, (size_t)(p - expected)) != 0) {
        for (i = 0; text[i] == expected[i]; ++i) continue;
        TEST_FAIL("byte %d: ...%.40s... instead of ...%.40s...", (int)i, text + i, expected + i);
    }
    p = expected;
    P("\nA_rz\n"); /* five a line */
    for (i = 0; i < 200; ++i) P("%12.4E %s", r.a_rz[i], i % 5 == 4 ? "\n" : "");
    P("\n# Rd[r][angle]. [1/(cm2sr)].\n# Rd[0][0], [0][1],..[0][na-1]\n# Rd[1][0], [1][1],..[1][na-1]\n# ...\n"
      "# Rd[nr-1][0], [nr-1][1],..[nr-1][na-1]\nRd_ra\n");
    for (i = 0; i < 600; ++i) P("%12.4E %s", r.rd_ra[i], i % 5 == 4 ? "\n" : "");
    P("\n# Tt[r][angle]. [1/(cm2sr)].\n");
    CHECK(strstr(text, expected) != NULL);
    CHECK(strstr(text, "\nTt_ra\n") != NULL);
#undef P
    free(text);
    CHECK_INT(mco_save("build/test_mci.mco", &f.runs[1], &r, NULL, 0, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(mco_save("/dev/null/a.mco", run_spec, &r, NULL, 0, &e), MS_IO);
    CHECK(e.status == MS_IO && strstr(e.message, "a.mco") != NULL);
    ms_mcml_result_destroy(&r);
    o.no_absorption = 1;
    r = run(&run_spec->tissue, &run_spec->grid, &o);
    CHECK(r.a_rz == NULL && r.a_z == NULL);
    text = printed(run_spec, &r, 0); /* numbers that are not there are nan, each in its place */
    CHECK(strstr(text, "\nA_rz\n         nan          nan          nan          nan          nan \n") != NULL);
    free(text);
    ms_mcml_result_destroy(&r);
    mci_destroy(&f);
}

static double ring_area(int i, double dr) { return 3.141592653589793 * (2 * i + 1) * dr * dr; }

static void beams(void)
{
    enum { N = 400 };
    static double value[N], error[N];
    const double dr = 0.01, s = 0.3, radius[3] = {0.05, 0.4, 0.004};
    double r[40], out[40], out_error[40], energy;
    int i, k;
    ms_error e;
    for (i = 0; i < N; ++i) { /* a Gaussian response of unit energy, averaged over rings */
        const double a = i * dr, b = a + dr;
        value[i] = (exp(-2 * a * a / s / s) - exp(-2 * b * b / s / s)) / ring_area(i, dr);
        error[i] = 0.01 * value[i];
    }
    for (i = 0; i < 40; ++i) r[i] = 0.02 * i;
    for (k = 0; k < 3; ++k) { /* Gaussian with Gaussian: the radii add in squares; rings of 0.01 blur by (dr / s)^2 */
        const double both = s * s + radius[k] * radius[k];
        CHECK_INT(mci_convolve(MCI_BEAM_GAUSSIAN, radius[k], dr, N, 1, value, error, r, 40, out, out_error, &e), MS_OK);
        for (i = 0; i < 40; ++i)
            CHECK_NEAR(out[i], 2 / (3.141592653589793 * both) * exp(-2 * r[i] * r[i] / both),
                       3e-3 * out[0] * (k == 2 ? 10 : 1));
        CHECK(out_error[3] > 0 && out_error[3] <= 0.01 * out[3]);
    }
    for (k = 0; k < 3; ++k) { /* energy is kept: a sum over fine radii */
        for (i = 0, energy = 0; i < 6000; ++i) {
            double at = (i + 0.5) * 5e-4, v = 0;
            CHECK_INT(mci_convolve(MCI_BEAM_FLAT, radius[k], dr, N, 1, value, NULL, &at, 1, &v, NULL, &e), MS_OK);
            energy += v * ring_area(i, 5e-4);
        }
        CHECK_NEAR(energy, 1, 1e-4); /* the midpoint rule across the steps of rings */
    }
    for (i = 0; i < N; ++i) value[i] = 1; /* a level response stays level: both kernels integrate to 1 */
    for (k = 1; k <= 2; ++k) {
        CHECK_INT(mci_convolve(k, 0.3, dr, N, 1, value, NULL, r, 40, out, NULL, &e), MS_OK);
        for (i = 0; i < 40; ++i) CHECK_NEAR(out[i], 1, 1e-9);
    }
    for (i = 0; i < N; ++i) value[i] = i == 7; /* one ring, at the center of a flat beam: its area over the disc's */
    r[0] = 0;
    CHECK_INT(mci_convolve(MCI_BEAM_FLAT, 0.3, dr, N, 1, value, NULL, r, 1, out, NULL, &e), MS_OK);
    CHECK_NEAR(out[0], ring_area(7, dr) / (3.141592653589793 * 0.09), 1e-14);
    CHECK_INT(mci_convolve(3, 0.3, dr, N, 1, value, NULL, r, 1, out, NULL, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(mci_convolve(1, -1, dr, N, 1, value, NULL, r, 1, out, NULL, &e), MS_INVALID_ARGUMENT);
    CHECK_INT(mci_convolve(1, 1, dr, 0, 1, value, NULL, r, 1, out, NULL, &e), MS_INVALID_ARGUMENT);
    r[0] = -1;
    CHECK_INT(mci_convolve(1, 1, dr, N, 1, value, NULL, r, 1, out, NULL, &e), MS_INVALID_ARGUMENT);
}

static const test_case cases[] = {
    {"mci_good", mci_good}, {"mci_malformed", mci_malformed}, {"numbers", numbers}, {"mco_text", mco_text},
    {"beams", beams},
};

TEST_MAIN(cases)
