/* examples/tools/image.h against OpenImageIO: what one writes the other reads. examples/demo/scene.h against its
   pictures of old. */
#include "image.h"
#include "oiio.h"
#include "scene.h"
#include "test.h"
#include "golden.h"

static image picture(int width, int height, int channels, int kind)
{
    image im = image_new(width, height, channels);
    uint64_t state = test_seed + (uint64_t)kind;
    size_t i, n = image_count(&im);
    for (i = 0; i < n; ++i) {
        int x = (int)(i / (size_t)channels) % width, y = (int)(i / (size_t)channels) / width,
            c = (int)(i % (size_t)channels);
        double v = 0.25;                                       /* flat */
        if (kind == 1) v = test_uniform(&state);               /* nothing to compress */
        if (kind == 2) v = (x + 2 * y + 30 * c) % 256 / 255.0; /* ramps that wrap */
        if (kind == 3) v = (x / 7 + y / 5) % 2 ? 1 : 0;        /* long matches */
        if (kind == 4) v = 0.5 + 0.4 * sin(0.05 * x) * cos(0.04 * y) + 0.01 * test_normal(&state);
        if (kind == 5) v = floor(pow(test_uniform(&state), 40) * 255) / 255; /* very uneven code lengths */
        im.pixels[i] = (float)v;
    }
    return im;
}

static const char *const path_of[] = {"build/pkg_image.png", "build/pkg_image.pfm", "build/pkg_image.ppm",
                                      "build/pkg_image.pgm"};

/* Writes im, reads it back by OpenImageIO, and asks for equal bits of `bits` a channel (32: floats). */
static void check_read_back(const image *im, const char *path, int bits)
{
    int width = 0, height = 0, channels = 0;
    size_t i, n = image_count(im);
    const char *problem = image_write(path, im);
    float *back;
    if (problem) {
        TEST_FAIL("%s: %s", path, problem);
        return;
    }
    back = oiio_read(path, &width, &height, &channels);
    if (back == NULL) {
        TEST_FAIL("%s, %dx%dx%d: %s", path, im->width, im->height, im->channels, oiio_problem());
        return;
    }
    CHECK_INT(width, im->width);
    CHECK_INT(height, im->height);
    CHECK_INT(channels, im->channels);
    for (i = 0; i < n && channels == im->channels; ++i) {
        int equal = bits == 32 ? memcmp(&back[i], &im->pixels[i], 4) == 0
                               : (int)floorf(back[i] * 255 + 0.5f) == image_to_byte(im->pixels[i]);
        if (equal) continue;
        TEST_FAIL("%s, %dx%dx%d: value %lu is %.9g, written %.9g", path, width, height, channels, (unsigned long)i,
                  (double)back[i], (double)im->pixels[i]);
        break;
    }
    free(back);
}

static void test_png(void)
{
    static const int size[][2] = {{1, 1}, {1, 9}, {9, 1}, {3, 2}, {257, 63}, {700, 501}};
    int s, kind, count = 0;
    for (s = 0; s < (int)(sizeof size / sizeof size[0]); ++s)
        for (kind = 0; kind < 6; ++kind) {
            int channels;
            for (channels = 1; channels <= 4; channels += channels == 1 ? 2 : 1) {
                image im = picture(size[s][0], size[s][1], channels, kind);
                check_read_back(&im, path_of[0], 8);
                image_free(&im);
                ++count;
            }
        }
    TEST_NOTE("%d pictures, OpenImageIO %s", count, oiio_version());
}

static void test_png_1080p(void)
{
    image im = picture(1920, 1080, 3, 4);
    FILE *f;
    long size = 0;
    check_read_back(&im, path_of[0], 8);
    f = fopen(path_of[0], "rb");
    if (f && fseek(f, 0, SEEK_END) == 0) size = ftell(f);
    if (f) fclose(f);
    CHECK_LE(size,
             0.62 * 1920 * 1080 * 3); /* noise of 2.5 levels alone has 3.4 of 8 bits; without packing it were 1.0 */
    TEST_NOTE("%ld bytes", size);
    image_free(&im);
}

static void test_pfm_written(void)
{
    static const float special[] = {0.0f, -0.0f, 1e30f, -1e-30f, 1e-40f, 3.14159f};
    int channels, i;
    for (channels = 1; channels <= 3; channels += 2) {
        image im = picture(37, 11, channels, 4);
        for (i = 0; i < 6; ++i) im.pixels[i] = special[i];
        check_read_back(&im, path_of[1], 32);
        image_free(&im);
    }
}

static void test_pnm_written(void)
{
    image rgb = picture(37, 11, 3, 2), gray = picture(37, 11, 1, 1);
    check_read_back(&rgb, path_of[2], 8);
    check_read_back(&gray, path_of[3], 8);
    image_free(&rgb);
    image_free(&gray);
}

/* OpenImageIO writes PPM and PGM, image_read reads. (It writes no PFM: tests/test_image.c has the bytes of one.) */
static void test_read(void)
{
    int channels;
    for (channels = 1; channels <= 3; channels += 2) {
        const char *path = channels == 3 ? path_of[2] : path_of[3], *problem;
        image im = picture(37, 11, channels, 1), back;
        size_t i;
        if (!oiio_write(path, im.pixels, 37, 11, channels, 8)) {
            TEST_FAIL("%s", oiio_problem());
        } else if ((problem = image_read(path, &back)) != NULL) {
            TEST_FAIL("%s: %s", path, problem);
        } else {
            CHECK_INT(back.channels, channels);
            for (i = 0; i < image_count(&im) && back.channels == channels; ++i) /* half a level and float rounding */
                CHECK_NEAR(back.pixels[i], im.pixels[i], 0.5001 / 255);
            image_free(&back);
        }
        image_free(&im);
    }
}

/* The demo's objects, small. */
static void test_scene(void)
{
    static const float color[2][3] = {{0.44f, 0.22f, 0.13f}, {0.83f, 0.79f, 0.75f}};
    static const char *const name[2] = {"scene_bust", "scene_knot"};
    int object;
    for (object = 0; object < 2; ++object) {
        char path[100];
        scene s;
        image im;
        snprintf(path, sizeof path, "build/%s.png", name[object]);
        CHECK(scene_render(&s, (scene_object)object, 192, 108, color[object]) == NULL);
        CHECK(scene_compose(&s, &s.irradiance, &im) == NULL);
        CHECK(image_write(path, &im) == NULL);
        check_golden(name[object], 40); /* other compilers round rays along outlines otherwise */
        image_free(&im);
        scene_free(&s);
    }
}

static const test_case cases[] = {{"png", test_png},
                                  {"png_1080p", test_png_1080p},
                                  {"pfm_written", test_pfm_written},
                                  {"pnm_written", test_pnm_written},
                                  {"read", test_read},
                                  {"scene", test_scene}};
TEST_MAIN(cases)
