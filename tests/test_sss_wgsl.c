/* examples/tools/wgsl.h: the WGSL beside the shader files is what it writes of them, and what it does with a text. */
#include "test.h"
#include "wgsl.h"

static char text[1 << 17];

/* make wgsl writes them. */
static void case_checked_in(void)
{
    char *shader = test_read_file("examples/engine/shader/ms_sss.glsl", NULL);
    int i;
    for (i = 0; i < 4 && shader; ++i) {
        char path[100], *there;
        const char *problem = wgsl_usual_text(&wgsl_usual[i], shader, text, sizeof text);
        if (problem) TEST_FAIL("%s: %s", wgsl_usual[i].file, problem);
        snprintf(path, sizeof path, "examples/engine/shader/%s", wgsl_usual[i].file);
        there = test_read_file(path, NULL);
        CHECK(there && strcmp(there, text) == 0);
        free(there);
    }
    CHECK(shader != NULL);
    free(shader);
}

/* Every step of the files becomes WGSL without a word of GLSL or HLSL and without a directive. */
static void case_every_step(void)
{
    static const char *const strange[] = {"#",        "float3", "vec4(", "ivec2",  "zero3",
                                          "CONSTANT", "? ",     "pick(", "MS_SSS_"};
    char *shader = test_read_file("examples/engine/shader/ms_sss.glsl", NULL),
         *pyramid = test_read_file("examples/engine/shader/ms_sss_pyramid.glsl", NULL),
         *disc = test_read_file("examples/engine/shader/ms_sss_disc.glsl", NULL);
    int step, i, flags;
    for (step = 0; step <= 9 && shader && pyramid && disc; ++step)
        for (flags = 0; flags < 32; ++flags) {
            char defines[300], *line;
            const char *problem;
            snprintf(defines, sizeof defines,
                     "#define MS_SSS_STEP %d\n#define MS_SSS_PROFILES %d\n#define MS_SSS_SLOPES %d\n"
                     "#define MS_SSS_STRENGTH %d\n#define MS_SSS_HALF %d\n",
                     step, flags & 1 ? 16 : 0, (flags >> 1 & 1) + (flags >> 2 & 1), flags >> 3 & 1, flags >> 4 & 1);
            problem = wgsl_make(defines, shader,
                                step == 9                  ? disc
                                    : step > 3 && step < 8 ? pyramid
                                                           : NULL,
                                text, sizeof text);
            if (problem) TEST_FAIL("step %d, flags %d: %s", step, flags, problem);
            for (line = strtok(text, "\n"); line; line = strtok(NULL, "\n"))
                for (i = 0; i < (int)(sizeof strange / sizeof *strange) && !strstr(line, "//"); ++i)
                    if (strstr(line, strange[i])) TEST_FAIL("step %d, flags %d: %s", step, flags, line);
        }
    CHECK(shader && pyramid && disc);
    free(shader);
    free(pyramid);
    free(disc);
}

/* A text, and what it must become, without the lines that follow every text. */
static void becomes(const char *source, const char *expected)
{
    const char *problem = wgsl_make("#define MS_SSS_STEP 8\n", source, NULL, text, sizeof text);
    if (problem || strcmp(text, expected) != 0)
        TEST_FAIL("'%s' became '%s' (%s)", source, text, problem ? problem : "");
}

static void case_language(void)
{
    becomes("float3 f(float a, int2 b) {\n    bool c = a > 0.0;\n}\n",
            "fn f(a: f32, b: vec2<i32>) -> vec3<f32> {\n    var c: bool = a > 0.0;\n}\n");
    becomes("#define N 3 // so many\n#define M (N + 4 / 2)\nint n = M * N;\n", "n: i32 = 5 * 3;\n");
    becomes("#define A(x, y) (x + y)\nA(1, A(2, f(3, 4)))\n", "(1 + (2 + f(3, 4)))\n");
    becomes("#define A 2\n#if A > 1 && !(A == 3) && defined(A) && !defined(B)\nyes\n#elif A\nno\n#else\nno\n#endif\n",
            "yes\n");
    becomes("#define A 1\n#if A == 2\nno\n#elif A == 1\n#ifdef B\nno\n#else\nyes\n#endif\n#else\nno\n#endif\nend\n",
            "yes\nend\n");
    becomes("#if 2 * 3 - 1 == 5 || 0\nyes\n#endif\n", "yes\n");
    becomes("// gone\n#define A 1\n// stays\n#ifdef A\nx\n#endif\n\n\n// goes\n", "// stays\nx\n\n");
    becomes("float f = pick(a, b, c < 1.0); // float f\n", "f: f32 = select(a, b, c < 1.0); // float f\n");
}

static void case_refused(void)
{
    static const char *const bad[][2] = {{"#if A\n#endif\n", "integer"},
                                         {"#if (1\n#endif\n", "parenthesis"},
                                         {"#if 1\n", "#endif"},
                                         {"#define A B\n#define B A\nA\n", "without an end"}};
    char small[8];
    size_t i;
    for (i = 0; i < sizeof bad / sizeof *bad; ++i) {
        const char *problem = wgsl_make("#define MS_SSS_STEP 8\n", bad[i][0], NULL, text, sizeof text);
        if (!problem || !strstr(problem, bad[i][1])) TEST_FAIL("'%s': %s", bad[i][0], problem ? problem : "accepted");
    }
    CHECK(wgsl_make("#define MS_SSS_STEP 8\n", "a line that is longer\n", NULL, small, sizeof small) != NULL);
}

static const test_case cases[] = {
    {"the WGSL beside the shader files", case_checked_in},
    {"every step and switch", case_every_step},
    {"preprocessor and declarations", case_language},
    {"what is refused", case_refused},
};
TEST_MAIN(cases)
