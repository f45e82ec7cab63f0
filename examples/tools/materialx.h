/* Materials of the 19-parameter shader (thesis 3.5.3) as a MaterialX file, so that renderers and editors open them.

     FILE *f = fopen("materials.mtlx", "w");
     materialx_begin(f);
     materialx_write(f, "jade", x, "predicted score 8.1");    once for each material, x [19]; names: letters, digits, _
     materialx_end(f);                                        0: writing failed

   Each is one Autodesk standard_surface, whose closure is

     metalness M (metal) + (1 - M) (specular over (1 - T) ((1 - S) diffuse + S subsurface) + T transmission)

   so the shares of the four lobes, diffuse d, glossy g, glass t and translucent l, come out exactly with M = g,
   T = t / (1 - g), S = l / (d + l). The rest is a compromise, because one node has one of each:
     base_color         of diffuse and metal: mean weighted by their shares; exact where one of them is 0
     specular           the reflection of glass alone: weight T, its color, its index of refraction
     specular_roughness of metal and glass: mean weighted by their shares; transmission_extra_roughness restores the
                        glass's own behind the surface. Roughness is sqrt(alpha) here and there, but GGX, not Beckmann
     metal              has a Fresnel edge, the shader's glossy lobe has none; without glass (specular 0, so a black
                        edge color) it stays flat up to grazing angles
     transmission_color what a path through the middle of a ball of radius 1 leaves: the glass color twice (in and out)
                        and Beer's law, at transmission_depth 2; the color thus moves from the surface into the volume.
                        Scale the depth with your object
     subsurface         stands for the translucent lobe (Lambert behind the surface) with a radius of 1: what a ball
                        lets through, its color twice and Beer's law, averaged over the chords that Lambert's law takes
   Colors are linear with Rec. 709 primaries. */
#ifndef EXAMPLES_MATERIALX_H
#define EXAMPLES_MATERIALX_H
#include <math.h>
#include <stdio.h>
#include "files.h"

/* The inputs of a standard_surface that the shader sets. */
typedef struct materialx_surface {
    double base_color[3], metalness;
    double specular, specular_color[3], specular_roughness, specular_ior;
    double transmission, transmission_color[3], transmission_extra_roughness;
    double subsurface, subsurface_color[3];
} materialx_surface;

static inline double materialx__mean(double a, double b, double weight_a, double weight_b)
{
    return weight_a + weight_b > 0 ? (weight_a * a + weight_b * b) / (weight_a + weight_b) : 0.5 * (a + b);
}

static inline materialx_surface materialx_from(const double x[19])
{
    double d = (1 - x[17]) * (1 - x[7]), g = (1 - x[17]) * x[7], t = x[17] * (1 - x[16]), l = x[17] * x[16];
    double absorption = 4 * x[18]; /* per ball radius */
    /* mean of exp(-2 absorption cosine) over the cosines of Lambert's law */
    double chord = absorption > 1e-2 ? (1 - (1 + 2 * absorption) * exp(-2 * absorption)) / (2 * absorption * absorption)
                                     : 1 - absorption * (4.0 / 3 - absorption);
    materialx_surface s;
    int c;
    s.metalness = g;
    s.transmission = g < 1 ? t / (1 - g) : 0;
    s.subsurface = d + l > 0 ? l / (d + l) : 0;
    s.specular = s.transmission;
    s.specular_roughness = materialx__mean(x[6], x[11], g, t);
    s.transmission_extra_roughness = x[11] - s.specular_roughness;
    s.specular_ior = 1 + (x[12] > 0.01 ? x[12] : 0.01);
    for (c = 0; c < 3; ++c) {
        s.base_color[c] = materialx__mean(x[c], x[3 + c], d, g);
        s.specular_color[c] = x[8 + c];
        s.transmission_color[c] = fmax(x[8 + c] * x[8 + c] * exp(-2 * absorption), 1e-4); /* its logarithm is taken */
        s.subsurface_color[c] = x[13 + c] * x[13 + c] * chord;
    }
    return s;
}

static inline void materialx__float(FILE *f, const char *name, double v)
{
    char text[48];
    fprintf(f, "    <input name=\"%s\" type=\"float\" value=\"%s\" />\n", name, number_text(text, "%.5g", v));
}

static inline void materialx__color(FILE *f, const char *name, const double v[3])
{
    char r[48], g[48], b[48];
    fprintf(f, "    <input name=\"%s\" type=\"color3\" value=\"%s, %s, %s\" />\n", name, number_text(r, "%.5g", v[0]),
            number_text(g, "%.5g", v[1]), number_text(b, "%.5g", v[2]));
}

static inline void materialx_begin(FILE *f)
{
    fprintf(f, "<?xml version=\"1.0\"?>\n<materialx version=\"1.38\" colorspace=\"lin_rec709\">\n");
}

static inline void materialx_write(FILE *f, const char *name, const double x[19], const char *doc)
{
    materialx_surface s = materialx_from(x);
    fprintf(f, "  <standard_surface name=\"%s_shader\" type=\"surfaceshader\">\n", name);
    materialx__float(f, "base", 1);
    materialx__color(f, "base_color", s.base_color);
    materialx__float(f, "metalness", s.metalness);
    materialx__float(f, "specular", s.specular);
    materialx__color(f, "specular_color", s.specular_color);
    materialx__float(f, "specular_roughness", s.specular_roughness);
    materialx__float(f, "specular_IOR", s.specular_ior);
    materialx__float(f, "transmission", s.transmission);
    materialx__color(f, "transmission_color", s.transmission_color);
    materialx__float(f, "transmission_depth", 2);
    materialx__float(f, "transmission_extra_roughness", s.transmission_extra_roughness);
    materialx__float(f, "subsurface", s.subsurface);
    materialx__color(f, "subsurface_color", s.subsurface_color);
    fprintf(f, "  </standard_surface>\n  <surfacematerial name=\"%s\" type=\"material\" doc=\"%s\">\n", name, doc);
    fprintf(
        f, "    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"%s_shader\" />\n  </surfacematerial>\n",
        name);
}

static inline int materialx_end(FILE *f)
{
    fprintf(f, "</materialx>\n");
    return !ferror(f);
}
#endif
