/* The reader of PFM, PPM and PGM in examples/tools/image.h. */
#include "image.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    image im;
    if (image_decode(data, size, &im) == NULL) image_free(&im);
    return 0;
}
