// What bench_sss_filter.c is compared with where OpenCV is installed (run.sh compiles it then). One thread, planes of
// float.
#include <opencv2/imgproc.hpp>

extern "C" void opencv_offsets(float *const in[3], float *const out[3], int width, int height, int reach,
                               const float *const taps[3]);
extern "C" void opencv_gaussian(const float *in, float *out, int width, int height, int size, double sigma);

// Two passes of a channel's own row of 2 reach + 1 coefficients, most of which are 0.
void opencv_offsets(float *const in[3], float *const out[3], int width, int height, int reach,
                    const float *const taps[3])
{
    cv::setNumThreads(1);
    for (int c = 0; c < 3; ++c) {
        const cv::Mat from(height, width, CV_32F, in[c]), row(1, 2 * reach + 1, CV_32F, const_cast<float *>(taps[c]));
        cv::Mat to(height, width, CV_32F, out[c]);
        cv::sepFilter2D(from, to, CV_32F, row, row, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
    }
}

// Its separable Gaussian of size x size coefficients over packed RGB, one width for all channels.
void opencv_gaussian(const float *in, float *out, int width, int height, int size, double sigma)
{
    cv::setNumThreads(1);
    const cv::Mat from(height, width, CV_32FC3, const_cast<float *>(in));
    cv::Mat to(height, width, CV_32FC3, out);
    cv::GaussianBlur(from, to, cv::Size(size, size), sigma, sigma, cv::BORDER_REPLICATE);
}
