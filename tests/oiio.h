/* OpenImageIO behind C calls, for tests: reads any picture to floats, writes, compares. */
#ifndef TESTS_OIIO_H
#define TESTS_OIIO_H
#ifdef __cplusplus
extern "C" {
#endif

/* Pixels [height][width][channels] of the file's first picture, top row first, integers as fractions of their largest
   value, colors not multiplied by alpha; from malloc. NULL: oiio_problem() says why. */
float *oiio_read(const char *path, int *width, int *height, int *channels);

/* bits 8 or 16: integers, the floats clamped to [0, 1]; 32: floats. The format follows the extension. 0: failed. */
int oiio_write(const char *path, const float *pixels, int width, int height, int channels, int bits);

typedef struct oiio_difference {
    double mean, rms, max; /* of |a - b| over all channels */
    double psnr;           /* dB for a peak of 1; infinite where nothing differs */
    int x, y, channel;     /* where the largest difference is */
} oiio_difference;

int oiio_compare(const float *a, const float *b, int width, int height, int channels, oiio_difference *out);

/* Of the last call that failed, and the library's version. */
const char *oiio_problem(void);
const char *oiio_version(void);

#ifdef __cplusplus
}
#endif
#endif
