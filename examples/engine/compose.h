/* What a renderer does around ms_sss_filter: depth from its depth buffer before, composition after. Plain loops; in an
   engine they are lines of its shaders. */
#ifndef COMPOSE_H
#define COMPOSE_H
#include <math.h>
#include <stddef.h>

/* The color of a pixel by its filtered light: the larger of it and the light transmitted through thin parts
   (ms_sss_transmission summed over the lamps; a sum would count the light near a shadow's border twice), times the
   albedo, which keeps texture sharp, plus specular reflection, which never went below the surface. fade: 0: full effect;
   1: the unfiltered light. NULL: none. To blur the texture as well, filter albedo * light in place of light, or
   sqrt(albedo) * light and multiply by the other root here. */
static inline void compose_pixel(const float unfiltered[3], const float filtered[3], float fade, const float *through,
                                 const float *albedo, const float *specular, float out[3])
{
    int c;
    for (c = 0; c < 3; ++c) {
        float light = (1 - fade) * filtered[c] + fade * unfiltered[c];
        if (through && through[c] > light) light = through[c];
        if (albedo) light *= albedo[c];
        out[c] = specular ? light + specular[c] : light;
    }
}

/* Distances along the view axis, out[count], from a depth buffer's values: D3D's, Vulkan's and Metal's, and OpenGL's
   depth textures. far_plane 0: infinitely far. reversed 0: 0 near to 1 far; 1: 1 near to 0 far. orthographic: depth goes
   linearly. Where nothing was drawn (at the far plane or beyond), and for NaN, the distance is infinite: ms_sss_filter
   leaves those pixels alone. out may be the buffer. */
static inline void compose_linear_depth(const float *buffer, size_t count, float near_plane, float far_plane,
                                        int reversed, int orthographic, float *out)
{
    const double n = (double)near_plane, f = (double)far_plane;
    size_t i;
    for (i = 0; i < count; ++i) {
        const double d = (double)buffer[i], away = reversed ? d : 1 - d; /* 1 at the near plane, 0 at the far one */
        double z = (double)INFINITY;
        if (away > 0 && away <= 1)
            z = orthographic ? f - away * (f - n) : f > 0 ? n * f / (n + away * (f - n)) : n / away;
        out[i] = (float)z;
    }
}

/* The angle along y, as ms_sss_filter_options.fov_degrees wants it, of a camera with this angle along x. */
static inline float compose_fov_along_y(float fov_degrees_along_x, int width, int height)
{
    const double degree = 3.14159265358979323846 / 180;
    return (float)(2 * atan(tan((double)fov_degrees_along_x * degree / 2) * height / width) / degree);
}
#endif
