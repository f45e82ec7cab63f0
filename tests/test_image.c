/* examples/image.h: PFM, PPM and PGM are read as their formats say, and strictly; the PNG's parts are well-formed. */
#include "image.h"
#include "test.h"

/* --- files that are right --- */

static void test_pfm_bytes(void)
{
    static const unsigned char little[] =
        "Pf\n2 2\n-1.0\n\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40\0\0\x80\x40"; /* 1 2, below 3 4 */
    static const unsigned char big[] = "PF 1 1 0.5\n\x3f\x80\0\0\x40\0\0\0\x40\x40\0\0";
    static const float upright[] = {3, 4, 1, 2}; /* a PFM's first row is the lowest */
    image im;
    int i;
    CHECK(image_decode(little, sizeof little - 1, &im) == NULL);
    CHECK_INT(im.channels, 1);
    for (i = 0; i < 4 && im.pixels; ++i) CHECK_NEAR(im.pixels[i], upright[i], 0);
    image_free(&im);
    CHECK(image_decode(big, sizeof big - 1, &im) == NULL);
    CHECK_INT(im.channels, 3);
    for (i = 0; i < 3 && im.pixels; ++i) CHECK_NEAR(im.pixels[i], 0.5 * (i + 1), 0); /* times the header's scale */
    image_free(&im);
}

static void test_pnm_bytes(void)
{
    static const unsigned char ppm[] = "P6 # a comment\n1 # another\n1\n255\n\x00\x80\xff";
    static const unsigned char pgm[] = "P5\n2 1 1000\n\x00\x01\x03\xe8";
    image im;
    CHECK(image_decode(ppm, sizeof ppm - 1, &im) == NULL);
    CHECK_INT(im.width * 100 + im.height * 10 + im.channels, 113);
    if (im.pixels) {
        CHECK_NEAR(im.pixels[1], 128 / 255.0, 1e-7); /* float rounding */
        CHECK_NEAR(im.pixels[2], 1, 0);
    }
    image_free(&im);
    CHECK(image_decode(pgm, sizeof pgm - 1, &im) == NULL);
    CHECK_INT(im.width * 100 + im.height * 10 + im.channels, 211);
    if (im.pixels) {
        CHECK_NEAR(im.pixels[0], 0.001, 1e-9);
        CHECK_NEAR(im.pixels[1], 1, 0);
    }
    image_free(&im);
}

static void test_round_trip(void)
{
    static const char *const path[] = {"build/test_image.pfm", "build/test_image.ppm", "build/test_image.pgm"};
    int k;
    for (k = 0; k < 3; ++k) {
        image im = image_new(5, 7, k == 2 ? 1 : 3), back;
        size_t i, n = image_count(&im);
        for (i = 0; i < n; ++i) im.pixels[i] = (float)(i * 37 % 256) / 255;
        CHECK(image_write(path[k], &im) == NULL);
        CHECK(image_read(path[k], &back) == NULL);
        CHECK(back.pixels && image_count(&back) == n && memcmp(im.pixels, back.pixels, n * sizeof(float)) == 0);
        image_free(&im);
        image_free(&back);
        remove(path[k]);
    }
}

static void test_not_finite(void)
{
    image im = image_new(3, 1, 1), back;
    im.pixels[0] = (float)NAN;
    im.pixels[1] = (float)INFINITY;
    im.pixels[2] = -(float)INFINITY;
    CHECK(image_write("build/test_image.pfm", &im) == NULL);
    CHECK(image_read("build/test_image.pfm", &back) == NULL);
    CHECK(back.pixels && isnan(back.pixels[0]) && isinf(back.pixels[1]) && back.pixels[2] < 0);
    CHECK_INT(image_to_byte(im.pixels[0]), 0);
    CHECK_INT(image_to_byte(im.pixels[1]), 255);
    CHECK_INT(image_to_byte(im.pixels[2]), 0);
    image_free(&im);
    image_free(&back);
    remove("build/test_image.pfm");
}

/* --- files that are wrong: each is refused with a sentence that names the reason --- */

static void test_refused(void)
{
    static const struct {
        const char *text;
        size_t size;
        const char *gist;
    } bad[] = {{"", 0, "not a PFM"},
               {"P", 1, "not a PFM"},
               {"P3\n1 1\n255\n1 2 3\n", 18, "binary"},
               {"\x89PNG\r\n\x1a\n", 8, "not a PFM"},
               {"PF", 2, "not a PFM"},
               {"PF\n1 1\n", 7, "scale"},
               {"PF\n1", 4, "width"},
               {"PF\n1 1\n-1.0", 11, "scale"}, /* no white space behind the header */
               {"PF\n0 1\n-1.0\n", 12, "width"},
               {"PF\n-1 1\n-1.0\n", 13, "width"},
               {"PF\n1 1x\n-1.0\n1234", 17, "width"},
               {"PF\n99999999999999999999 1\n-1.0\n", 31, "width"},
               {"PF\n16777216 16777216\n-1.0\n", 27, "too large"},
               {"Pf\n1 1\n0\n1234", 13, "scale"},
               {"Pf\n1 1\nnan\n1234", 15, "scale"},
               {"Pf\n1 1\n1e999\n1234", 17, "scale"},
               {"Pf\n1 1\n-1.0\n123", 15, "ends before"},
               {"Pf\n1 1\n-1.0\n12345", 17, "goes on"},
               {"P5\n1 1\n0\n1", 10, "largest value"},
               {"P5\n1 1\n65536\n12", 15, "largest value"},
               {"P5\n1 1\n100\n\x65", 12, "above"},
               {"P5\n1 1\n256\n1", 12, "ends before"}, /* two bytes a value from 256 on */
               {"P5\n1 # 1\n255\n1", 14, "largest value"}};
    int i, count = (int)(sizeof bad / sizeof bad[0]);
    for (i = 0; i < count; ++i) {
        image im;
        const char *problem = image_decode((const unsigned char *)bad[i].text, bad[i].size, &im);
        if (problem == NULL || strstr(problem, bad[i].gist) == NULL)
            TEST_FAIL("file %d: '%s' lacks '%s'", i, problem ? problem : "no problem", bad[i].gist);
        CHECK(im.pixels == NULL);
    }
    TEST_NOTE("%d files", count);
}

/* Every prefix of a good file is refused, whatever byte it ends at. */
static void test_prefixes(void)
{
    static const unsigned char good[] = "PF\n2 1\n-1.0\n123456789012345678901234";
    size_t size;
    image im;
    for (size = 0; size < sizeof good - 1; ++size) {
        CHECK(image_decode(good, size, &im) != NULL);
        CHECK(im.pixels == NULL);
    }
    CHECK(image_decode(good, sizeof good - 1, &im) == NULL);
    image_free(&im);
}

static void test_write_refused(void)
{
    image im = image_new(2, 2, 1), none = image_new(0, 1, 3), huge = image_new(1 << 20, 1 << 20, 3);
    FILE *f;
    CHECK(none.pixels == NULL && huge.pixels == NULL);
    CHECK(strstr(image_write("build/test_image.ppm", &im), "3 channels") != NULL);
    CHECK(strstr(image_write("build/test_image.jpg", &im), "should end") != NULL);
    CHECK(strstr(image_write("build/test_image.png", &none), "empty") != NULL);
    CHECK(strstr(image_write("build/no/such/folder.png", &im), "cannot open") != NULL);
    CHECK(strstr(image_read("build/no/such/file.pfm", &none), "cannot open") != NULL);
    f = fopen("build/test_image.ppm", "rb");
    CHECK(f == NULL); /* nothing was left behind */
    if (f) fclose(f);
    image_free(&im);
}

/* --- colors --- */

static void test_srgb(void)
{
    int i;
    CHECK_NEAR(image_srgb_encode(0.5f), 0.735356983, 1e-6); /* IEC 61966-2-1, evaluated in double precision */
    CHECK_NEAR(image_srgb_encode(0.002f), 0.02584, 1e-7);
    for (i = 0; i <= 255; ++i) /* 8 bits survive both ways */
        CHECK_INT(image_to_byte(image_srgb_encode(image_srgb_decode((float)i / 255))), i);
    {
        image im = image_new(1, 1, 4);
        for (i = 0; i < 4; ++i) im.pixels[i] = 0.5f;
        image_to_srgb(&im);
        CHECK_NEAR(im.pixels[2], 0.735356983, 1e-6);
        CHECK_NEAR(im.pixels[3], 0.5, 0);
        image_to_linear(&im);
        CHECK_NEAR(im.pixels[0], 0.5, 1e-6);
        image_free(&im);
    }
}

/* --- PNG: chunks, checksums, and the prefix codes' sums (tests/pkg_image.c has it decoded by OpenImageIO) --- */

static uint32_t big_endian(const char *p)
{
    const unsigned char *b = (const unsigned char *)p;
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

static void test_png_chunks(void)
{
    static const char *const names[] = {"IHDR", "IDAT", "IEND"};
    image im = image_new(31, 17, 3);
    size_t size = 0, at = 8;
    char *text;
    int k;
    CHECK(image_write("build/test_image.png", &im) == NULL);
    text = test_read_file("build/test_image.png", &size);
    CHECK(text != NULL && size > 57 && memcmp(text, "\x89PNG\r\n\x1a\n", 8) == 0);
    for (k = 0; text && k < 3 && at + 12 <= size; ++k) {
        uint32_t n = big_endian(text + at);
        CHECK(memcmp(text + at + 4, names[k], 4) == 0);
        if (n > size - at - 12) break;
        if (k == 0) CHECK(big_endian(text + 16) == 31 && big_endian(text + 20) == 17 && text[24] == 8 && text[25] == 2);
        if (k == 2) CHECK(big_endian(text + at + 8) == 0xAE426082u); /* CRC of "IEND", as in every PNG file */
        at += n + 12;
    }
    CHECK_INT(at, size);
    CHECK_LE(size, 130); /* 1.6 KB of black */
    free(text);
    image_free(&im);
    remove("build/test_image.png");
}

static void test_code_lengths(void)
{
    int round;
    uint64_t state = test_seed;
    for (round = 0; round < 200; ++round) {
        uint32_t frequency[image__literals], a = 1, b = 1;
        unsigned char length[image__literals];
        int n = 2 + (int)(test_uniform(&state) * 284), limit = round % 2 ? 15 : 9, i;
        double kraft = 0;
        for (i = 0; i < n; ++i) {
            frequency[i] = (uint32_t)(exp(12 * test_uniform(&state)) - 1);
            if (round % 3 == 0 && i < 40) { /* Fibonacci's numbers make the deepest tree */
                uint32_t next = a + b;
                frequency[i] = a;
                a = b;
                b = next;
            }
        }
        image__code_lengths(frequency, n, limit, length);
        for (i = 0; i < n; ++i) {
            CHECK(length[i] <= limit && (length[i] > 0) == (frequency[i] > 0));
            if (length[i]) kraft += ldexp(1, -length[i]);
        }
        CHECK_NEAR(kraft, 1, 0);
    }
}

static const test_case cases[] = {
    {"pfm_bytes", test_pfm_bytes},         {"pnm_bytes", test_pnm_bytes}, {"round_trip", test_round_trip},
    {"not_finite", test_not_finite},       {"refused", test_refused},     {"prefixes", test_prefixes},
    {"write_refused", test_write_refused}, {"srgb", test_srgb},           {"png_chunks", test_png_chunks},
    {"code_lengths", test_code_lengths}};
TEST_MAIN(cases)
