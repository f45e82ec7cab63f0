/* Pictures against those in tests/data/golden, by OpenImageIO. Include test.h and oiio.h first. */
#ifndef TESTS_GOLDEN_H
#define TESTS_GOLDEN_H

/* The picture at build/NAME.png against tests/data/golden/NAME.png: at least least_psnr dB. On failure ten times the
   difference is left in build/NAME_difference.png. */
static inline void check_golden(const char *name, double least_psnr)
{
    char path[200], golden[200], difference[200];
    int w[2], h[2], c[2], i;
    float *a, *b;
    oiio_difference d;
    snprintf(path, sizeof path, "build/%s.png", name);
    snprintf(golden, sizeof golden, "tests/data/golden/%s.png", name);
    snprintf(difference, sizeof difference, "build/%s_difference.png", name);
    a = oiio_read(path, &w[0], &h[0], &c[0]);
    b = a ? oiio_read(golden, &w[1], &h[1], &c[1]) : NULL;
    if (b == NULL) {
        TEST_FAIL("%s or %s cannot be read: %s", path, golden, oiio_problem());
    } else if (w[0] != w[1] || h[0] != h[1] || c[0] != c[1] || !oiio_compare(a, b, w[0], h[0], c[0], &d)) {
        TEST_FAIL("%s and %s differ in size", path, golden);
    } else {
        TEST_NOTE("%s %.1f dB", name, d.psnr < 999 ? d.psnr : 999.0);
        if (!(d.psnr >= least_psnr)) {
            TEST_FAIL("%s: %.1f dB from %s, at least %.1f expected (largest difference %.3f at %d, %d; see %s)", path,
                      d.psnr, golden, least_psnr, d.max, d.x, d.y, difference);
            for (i = 0; i < w[0] * h[0] * c[0]; ++i) a[i] = 10 * fabsf(a[i] - b[i]);
            oiio_write(difference, a, w[0], h[0], c[0], 8);
        }
    }
    free(a);
    free(b);
}
#endif
