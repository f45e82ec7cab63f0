#include "oiio.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <string>

namespace {

std::string problem;

OIIO::ImageBuf wrap(const float *pixels, int width, int height, int channels)
{
    return OIIO::ImageBuf(OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::FLOAT), const_cast<float *>(pixels));
}

} // namespace

extern "C" float *oiio_read(const char *path, int *width, int *height, int *channels)
{
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    auto in = OIIO::ImageInput::open(path, &as_stored);
    if (!in) {
        problem = OIIO::geterror();
        return nullptr;
    }
    const OIIO::ImageSpec &spec = in->spec();
    size_t count = static_cast<size_t>(spec.image_pixels()) * static_cast<size_t>(spec.nchannels);
    float *pixels = static_cast<float *>(std::malloc(count * sizeof(float)));
    if (pixels == nullptr || !in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels)) {
        problem = pixels ? in->geterror() : "out of memory";
        std::free(pixels);
        return nullptr;
    }
    *width = spec.width;
    *height = spec.height;
    *channels = spec.nchannels;
    return pixels;
}

extern "C" int oiio_write(const char *path, const float *pixels, int width, int height, int channels, int bits)
{
    auto out = OIIO::ImageOutput::create(path);
    OIIO::TypeDesc type = bits == 8 ? OIIO::TypeDesc::UINT8
        : bits == 16                ? OIIO::TypeDesc::UINT16
                                    : OIIO::TypeDesc::FLOAT;
    if (!out || !out->open(path, OIIO::ImageSpec(width, height, channels, type)) ||
        !out->write_image(OIIO::TypeDesc::FLOAT, pixels) || !out->close()) {
        problem = out ? out->geterror() : OIIO::geterror();
        return 0;
    }
    return 1;
}

extern "C" int oiio_compare(const float *a, const float *b, int width, int height, int channels, oiio_difference *out)
{
    auto result = OIIO::ImageBufAlgo::compare(wrap(a, width, height, channels), wrap(b, width, height, channels), 1e30f,
                                              1e30f);
    if (result.error) {
        problem = OIIO::geterror();
        return 0;
    }
    out->mean = result.meanerror;
    out->rms = result.rms_error;
    out->max = result.maxerror;
    out->psnr = result.PSNR;
    out->x = result.maxx;
    out->y = result.maxy;
    out->channel = result.maxc;
    return 1;
}

extern "C" const char *oiio_problem(void) { return problem.c_str(); }

extern "C" const char *oiio_version(void) { return OIIO_VERSION_STRING; }
