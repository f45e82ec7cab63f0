/* examples/tools/image.h: PFM, PPM, PGM and PNG are read as their formats say, and strictly; the written PNG's parts
   are well-formed; other sizes keep the light. */
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
               {"\x89PNG\r\n\x1a\n", 8, "last chunk"},
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
    CHECK(strstr(image_write("build", &im), "should end") != NULL);
    CHECK(strstr(image_save("build", "x", 1), "regular") != NULL);
    CHECK(strstr(image_save("/dev/null", "x", 1), "regular") != NULL);
    CHECK(image_save("build/test_image.txt", "old", 3) == NULL); /* a file is no folder, and stays */
    CHECK(strstr(image_write("build/test_image.txt/x.png", &im), "folder is not there") != NULL);
    CHECK(image_save("build/test_image.txt", "new", 3) == NULL);
    f = fopen("build/test_image.txt", "rb");
    CHECK(f != NULL && fgetc(f) == 'n' && fgetc(f) == 'e' && fgetc(f) == 'w' && fgetc(f) == EOF);
    if (f) fclose(f);
    remove("build/test_image.txt");
    CHECK(image_write("build/test_image_made/deep/x.png", &im) == NULL);
    remove("build/test_image_made/deep/x.png");
    remove("build/test_image_made/deep");
    remove("build/test_image_made");
    f = fopen("/dev/full", "rb");
    if (f) { /* the device of full disks is left alone as well */
        fclose(f);
        CHECK(strstr(image_save("/dev/full", "x", 1), "regular") != NULL);
    }
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

/* --- PNG as others write it (tests/data/png.py, packed by zlib) --- */

static void test_png_read(void)
{
    static const struct {
        int color, samples, channels, depths[6];
    } kinds[] = {{0, 1, 1, {1, 2, 4, 8, 16, 0}},
                 {2, 3, 3, {8, 16, 0}},
                 {3, 1, 3, {1, 2, 4, 8, 0}},
                 {4, 2, 4, {8, 16, 0}},
                 {6, 4, 4, {8, 16, 0}}};
    int k, d, interlaced, x, y, c, files = 0;
    for (k = 0; k < 5; ++k)
        for (d = 0; kinds[k].depths[d]; ++d)
            for (interlaced = 0; interlaced < 2; ++interlaced, ++files) {
                int bits = kinds[k].depths[d], most = (1 << bits) - 1,
                    channels = kinds[k].color == 3 && interlaced ? 4 : kinds[k].channels;
                char path[80];
                const char *problem;
                image im;
                snprintf(path, sizeof path, "tests/data/png/c%d_b%d_i%d.png", kinds[k].color, bits, interlaced);
                problem = image_read(path, &im);
                if (problem) TEST_FAIL("%s: %s", path, problem);
                CHECK_INT(im.channels, channels);
                CHECK(im.width == 13 && im.height == 7);
                for (y = 0; y < 7 && !problem; ++y)
                    for (x = 0; x < 13; ++x)
                        for (c = 0; c < channels; ++c) {
                            int v = (37 * x + 11 * y) & most;
                            double expected;
                            if (kinds[k].color == 3) expected = (c == 3 ? 255 - v : (7 - 2 * c) * v & 255) / 255.0;
                            else if (kinds[k].color == 4)
                                expected = ((37 * x + 11 * y + 50 * (c == 3)) & most) / (double)most;
                            else expected = ((37 * x + 11 * y + 50 * c) & most) / (double)most;
                            CHECK_NEAR(im.pixels[(y * 13 + x) * channels + c], expected,
                                       1e-7); /* rounding of a float */
                        }
                image_free(&im);
            }
    TEST_NOTE("%d files", files);
}

/* Cut anywhere or damaged in any byte, a PNG is refused: every byte is under a checksum or decides how it is read. */
static void test_png_damage(void)
{
    static const char *const files[] = {"tests/data/png/c2_b8_i0.png", "tests/data/png/c3_b4_i1.png",
                                        "tests/data/png/c0_b16_i1.png"};
    size_t size = 0, i, k;
    for (k = 0; k < 3; ++k) {
        unsigned char *data = (unsigned char *)test_read_file(files[k], &size), *copy;
        image im;
        if (data == NULL) {
            TEST_FAIL("%s cannot be read", files[k]);
            continue;
        }
        for (i = 0; i < size; ++i) {
            copy = (unsigned char *)malloc(i ? i : 1); /* its end is the end of the memory */
            memcpy(copy, data, i);
            CHECK(image_decode(copy, i, &im) != NULL && im.pixels == NULL);
            free(copy);
        }
        for (i = 0; i < 8 * size; ++i) {
            data[i / 8] = (unsigned char)(data[i / 8] ^ 1 << i % 8);
            CHECK(image_decode(data, size, &im) != NULL && im.pixels == NULL);
            data[i / 8] = (unsigned char)(data[i / 8] ^ 1 << i % 8);
        }
        free(data);
    }
}

/* What the writer makes of smooth, noisy and flat pictures comes back to the bit, large enough for several blocks. */
static void test_png_round_trip(void)
{
    static const int sizes[4][3] = {{1, 1, 1}, {3, 5, 4}, {300, 200, 3}, {700, 130, 1}};
    int k, kind;
    uint64_t state = test_seed;
    for (k = 0; k < 4; ++k)
        for (kind = 0; kind < 3; ++kind) {
            image im = image_new(sizes[k][0], sizes[k][1], sizes[k][2]), back;
            size_t i, n = image_count(&im);
            for (i = 0; i < n; ++i)
                im.pixels[i] = (float)(kind == 0       ? 7
                                           : kind == 1 ? (int)(i / 40) % 256
                                                       : (int)(256 * test_uniform(&state))) /
                    255;
            CHECK(image_write("build/test_image.png", &im) == NULL);
            CHECK(image_read("build/test_image.png", &back) == NULL);
            CHECK(back.pixels && back.channels == im.channels && image_count(&back) == n &&
                  memcmp(im.pixels, back.pixels, n * sizeof(float)) == 0);
            image_free(&im);
            image_free(&back);
        }
    remove("build/test_image.png");
}

/* The mean of every channel stays whatever the sizes; whole factors are plain means; alpha weighs colors. */
static void test_resize(void)
{
    static const int sizes[][2] = {{1, 1}, {7, 3}, {64, 64}, {10, 31}, {5, 90}};
    image im = image_new(20, 31, 3), out, rgba;
    uint64_t state = test_seed + 1;
    size_t k;
    int i, c;
    double mean[3] = {0, 0, 0};
    for (i = 0; i < 20 * 31; ++i)
        for (c = 0; c < 3; ++c) mean[c] += (double)(im.pixels[3 * i + c] = (float)test_uniform(&state)) / 620.0;
    for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
        double sum[3] = {0, 0, 0};
        out = image_resize(&im, sizes[k][0], sizes[k][1]);
        CHECK(out.width == sizes[k][0] && out.height == sizes[k][1]);
        for (i = 0; i < out.width * out.height; ++i)
            for (c = 0; c < 3; ++c) sum[c] += (double)out.pixels[3 * i + c] / (double)(out.width * out.height);
        for (c = 0; c < 3; ++c) CHECK_NEAR(sum[c], mean[c], 1e-6); /* floats twice rounded */
        image_free(&out);
    }
    out = image_resize(&im, 10, 31);
    CHECK_NEAR(out.pixels[3 * (10 * 4 + 3) + 1],
               0.5 * ((double)im.pixels[3 * (20 * 4 + 6) + 1] + (double)im.pixels[3 * (20 * 4 + 7) + 1]), 1e-7);
    image_free(&out);
    rgba = image_new(2, 1, 4);
    rgba.pixels[0] = 1;
    rgba.pixels[3] = 0.25f;
    rgba.pixels[7] = 0.75f;
    out = image_resize(&rgba, 1, 1);
    CHECK_NEAR(out.pixels[0], 0.25, 1e-7);
    CHECK_NEAR(out.pixels[3], 0.5, 1e-7);
    image_free(&out);
    image_free(&rgba);
    image_free(&im);
}

/* Every finite half comes back; a value between two goes to the nearer one, in the middle to the even one. */
static void test_half(void)
{
    unsigned h;
    for (h = 0; h < 0x7bff; ++h) {
        float a = image_from_half((uint16_t)h), b = image_from_half((uint16_t)(h + 1)),
              middle = (a + b) / 2; /* exact: 12 bits */
        if (image_to_half(a) != h || (h && image_to_half(-a) != (h | 0x8000u)) || image_to_half(middle) != h + h % 2 ||
            image_to_half(nextafterf(middle, a)) != h || image_to_half(nextafterf(middle, b)) != h + 1 || !(a < b)) {
            TEST_FAIL("around half %04x", h);
            break;
        }
    }
    CHECK_INT(image_from_half(0x3c00) * 1000, 1000); /* one; the largest; the least */
    CHECK_INT(image_from_half(0x7bff), 65504);
    CHECK(image_from_half(1) * 16777216.0f >= 1 && image_from_half(1) * 16777216.0f <= 1);
    CHECK_INT(image_to_half(1e30f), 0x7bff);
    CHECK_INT(image_to_half(-1e30f), 0xfbff);
    CHECK_INT(image_to_half(1e-9f), 0);
}

static const test_case cases[] = {
    {"pfm_bytes", test_pfm_bytes},           {"pnm_bytes", test_pnm_bytes}, {"round_trip", test_round_trip},
    {"not_finite", test_not_finite},         {"refused", test_refused},     {"prefixes", test_prefixes},
    {"write_refused", test_write_refused},   {"srgb", test_srgb},           {"png_chunks", test_png_chunks},
    {"code_lengths", test_code_lengths},     {"png_read", test_png_read},   {"png_damage", test_png_damage},
    {"png_round_trip", test_png_round_trip}, {"resize", test_resize},       {"half", test_half}};
TEST_MAIN_WITH_FILES(cases)
