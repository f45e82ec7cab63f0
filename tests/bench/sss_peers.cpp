/* Peers of ms_sss_filter, as a good programmer writes them without intrinsics: color and depth packed in four floats, the
   two pixels beside a tap mixed, one weight of depth a tap, pixels without depth skipped, two passes. Built with -O3
   -march=native -ffast-math. One takes expf, one the polynomial (1 - q / 8)^8 in its place. */
#include <cmath>

namespace {
typedef float vec4 __attribute__((vector_size(16), aligned(4)));

struct by_exp {
    static float weight(float q) { return expf(-q); }
};
struct by_polynomial {
    static float weight(float q)
    {
        float a = 1 - q * 0.125f;
        a = a > 0 ? a : 0;
        a *= a;
        a *= a;
        return a * a;
    }
};

template <class Law, int DY>
void pass(int taps, const float *offset, const float (*weight)[4], const float *in, float *out, int width, int height,
          float size, float k)
{
    const int step = DY ? width : 1;
    const float limit = static_cast<float>(DY ? height : width) - 1.001f;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float *own = in + 4 * (y * width + x), *line = DY ? in + 4 * x : in + 4 * y * width;
            const vec4 center = *reinterpret_cast<const vec4 *>(own);
            const float z = own[3], pixels = size / z;
            vec4 norm = *reinterpret_cast<const vec4 *>(weight[0]), sum = norm * center;
            if (!(z > 0)) {
                *reinterpret_cast<vec4 *>(out + 4 * (y * width + x)) = center;
                continue;
            }
            for (int i = 1; i < taps; ++i) {
                float t = static_cast<float>(DY ? y : x) + offset[i] * pixels;
                t = t < 0 ? 0 : t;
                t = t > limit ? limit : t;
                const int p = static_cast<int>(t);
                const float *u = line + 4 * p * step;
                const vec4 a = *reinterpret_cast<const vec4 *>(u), b = *reinterpret_cast<const vec4 *>(u + 4 * step);
                vec4 v = a + (t - static_cast<float>(p)) * (b - a);
                if (!(a[3] > 0)) v = b;
                else if (!(b[3] > 0)) v = a;
                if (!(v[3] > 0)) continue;
                const float dz = v[3] - z;
                const vec4 w = *reinterpret_cast<const vec4 *>(weight[i]) * Law::weight(dz * dz * k);
                sum += w * v;
                norm += w;
            }
            vec4 result = sum / norm;
            result[3] = z;
            *reinterpret_cast<vec4 *>(out + 4 * (y * width + x)) = result;
        }
}
} // namespace

/* Both passes; the middle tap first. size: pixels of a millimeter at depth 1; k: 1 / (2 sigma^2), in units of depth. */
extern "C" void sss_peer(int polynomial, int taps, const float *offset, const float (*weight)[4], const float *in,
                         float *between, float *out, int width, int height, float size, float k)
{
    if (polynomial) {
        pass<by_polynomial, 0>(taps, offset, weight, in, between, width, height, size, k);
        pass<by_polynomial, 1>(taps, offset, weight, between, out, width, height, size, k);
    } else {
        pass<by_exp, 0>(taps, offset, weight, in, between, width, height, size, k);
        pass<by_exp, 1>(taps, offset, weight, between, out, width, height, size, k);
    }
}
