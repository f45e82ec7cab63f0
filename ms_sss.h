/* ms_sss.h - v0.3.0 - subsurface scattering by separable kernels - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_SSS_IMPLEMENTATION
      #include "ms_sss.h"

   A diffusion profile becomes a kernel of a few taps; the kernel blurs the light on a surface. Link with -lm. Here the
   edge of a shadow on a material that red light enters deepest, in a texture with one pixel a millimeter:

   Example:
      #define MS_SSS_IMPLEMENTATION
      #include "ms_sss.h"
      #include <stdio.h>
      #include <string.h>
      int main(void)
      {
          static float light[64 * 64 * 3], glow[64 * 64 * 3];
          static ms_sss_kernel kernel;
          const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.5, 0.3};
          ms_sss_profile *profile;
          ms_sss_errors errors;
          ms_sss_frame frame;
          ms_sss_filter_options options = ms_sss_filter_defaults();
          int i;
          for (i = 0; i < 64 * 64 * 3; ++i) light[i] = i / 3 % 64 < 32;
          if (ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, NULL) != MS_OK) return 1;
          if (ms_sss_kernel_make(&kernel, &errors, profile, 24, NULL, NULL, NULL) != MS_OK) return 1;
          ms_sss_profile_destroy(profile);
          printf("%d taps, error on textures %.1f%%\n", kernel.tap_count, 100 * errors.texture);
          memset(&frame, 0, sizeof frame);
          frame.width = frame.height = 64;
          frame.input = ms_sss_interleaved(light, 3);
          frame.output = ms_sss_interleaved(glow, 3);
          options.pixels_per_mm[0] = 1;
          if (ms_sss_filter(&frame, &kernel, 1, &options, NULL, 0, NULL) != MS_OK) return 1;
          printf("behind the edge: red %.3f, blue %.3f\n", (double)glow[3 * 2083], (double)glow[3 * 2083 + 2]);
          return 0;
      }
   End of example.

   In the caller's order
   ---------------------
   1. A profile: ms_sss_profile_from_rings (what ms_mcml.h computes from optical coefficients), _samples, _gaussians,
      _burley.
   2. A kernel, when assets are built: ms_sss_kernel_make with a radius in pixels; or a designer, which builds and
      measures many; or a pyramid, ms_sss_pyramid_make.
   3. Every frame: ms_sss_filter (taps) or ms_sss_pyramid_filter on the CPU, or the shader files of
      examples/engine/shader on the GPU.
   4. Thin parts (ears, leaves): ms_sss_transmission in the light loop, from a shadow map.

   What it costs
   -------------
   Relative RMSE in % against the 2D convolution with d'Eon's skin profile, 99% of whose light leaves within 96 pixels;
   `make bench FILTER=sss_kernel` makes these tables, for the 11 materials of the thesis as well.

     one tap a pixel                  1D passes   vertical step   45 degree step   1/f texture
     R_d sampled along the axis           2            7.80            8.23           22.80
     SVD rank 1, normalized               2            6.48            6.29           16.62
     pre-integrated                       2            0.00            3.03            7.33
     image-optimal, 33 taps               2            1.72            1.18            3.61
     pre-integrated + 1 residual          4            0.00            0.88            1.22

     texture error by taps of a pass      24 pixels: 7     11     17     96 pixels: 7     11     17
     pre-integrated, quadratic spacing            4.48   4.45   5.80           11.59   8.58   7.71
     image-optimal, optimized taps (default)      2.50   1.61   1.37            9.25   5.62   4.14
     two terms, optimized taps                    1.89   0.67   0.28            8.12   3.74   1.89

   For edges along the screen's axes turn `dial` towards 1; for single bright dots use more taps; the default serves
   detail and shadows. Making a kernel takes longer with more taps and terms. The filter takes longer with more pixels,
   taps and terms, hardly with the radius (`make bench FILTER=sss_filter`).

   Depth
   -----
   A tap interpolates the two pixels beside its position, each weighted by its own depth.
   Slope: taps are spaced on the surface's tangent plane, so a plane is filtered alike at any tilt up to 83 degrees;
   diagonal tilts shear the kernel. Slopes come from normals, or from depth, one-sided at edges.
   Distance: a pixel dz off the tangent plane, for a tap x mm away, has the weight (1 - dz^2 / D^2) / (1 + dz^2 / x^2),
   where D is the depth of depth_sigma_mm; with flat 1 (1 - dz^2 / D^2)^4. No light crosses steps wider than D.
   Area: where the surface bends away between two taps by an angle of tangent m, the outer tap represents 1 + m^2 / 2
   times the area, at most 3 times; not for terms with weights of both signs.
   Elevation: sin(theta) is the tap's depth under the pixel's tangent plane over its distance x; within about 0.17 radii
   R, where it shows a mesh's flat triangles, that of the next tap outwards in proportion to x: the share of its own is
   x^4 / (x^4 + (0.17 R)^4). No pass multiplies the mean by more than reflectance^(-1/2) (above 1: by more than 1), so
   where the reflectance is at most 1, reflectance times output never exceeds the brightest input.
   Weights that fall outside the picture or on masked pixels are renormalized away: a constant stays constant within
   1e-6 on planes, and everywhere with flat 1. If a kernel's terms have weights of both signs, the missing weight goes
   to the pixel's own color instead. Half-precision depth is too coarse for slopes: set flat to 1.

   Memory, threads, SIMD, determinism, errors
   ------------------------------------------
   Profiles and designers are one block each from the caller's allocator (a designer: 2 MB). Building a kernel
   takes up to 2.1 MB more (33 taps of six terms; 0.5 MB of one term), measuring one 60 KB, and gives it back. Filters
   allocate nothing if the caller gives a workspace. No globals. At most 32 KB of stack a call, 64 KB at -O0.
   Profiles, designers and kernels are only read once made: calls may overlap. Filters cut the picture into rows for
   ms_parallel; kernels are made on one thread.
   Filters run SSE2 or NEON, AVX2 or AVX-512 code, else plain C, chosen once a call, capped by options.simd. On x86-64
   they mask floating-point exceptions and raise no flags. They give the same bits for any thread count at one level,
   kernels the same bits in every call of one build. With -ffast-math nothing holds of bits, NaN and infinity.
   Calls return ms_status and fill an optional ms_error; outputs are then untouched unless the call says otherwise.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_DEF           linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_SSS_FILENAME  this file's name, if it is not "ms_sss.h"
   MS_NO_SIMD       plain C only
   MS_SSS_WITH_SCALAR   plain C beside the SIMD levels, as their reference; otherwise MS_SIMD_SCALAR is MS_SIMD_BASE
   MS_SSS_NO_DESIGN run time alone, for programs that carry kernels and pyramids as data: the filter,
                    ms_sss_transmission and constants of shaders; nothing that takes a profile

   Limits
   ------
   A separable kernel only approximates a profile: the step errors above do not fall with more taps, only with
   more terms. Against random walks through three objects (`make bench FILTER=sss_truth`) the remaining error lies at
   shadow borders (the pyramid and examples/tools/gather.h do better there), and on parts that let light through
   (ms_sss_transmission, or the gather with a back layer): there, lit from behind, the filter alone is hardly better
   than none. Bodies thinner than a mean free path stay too dark.
   Guided kernels send more light far away than the profile does; where it then crosses to other parts of an object
   (depth sigma a third of the radius, a knot of marble) their picture is worse than an unfiltered one.
   Designs go up to a radius of 128 pixels; larger ones scale from there. Light that a profile sends beyond the 99%
   radius of its widest channel is moved inside, so that energy is kept. Errors are of linear interpolation between two
   pixels.

   Sources
   -------
   K. Zsolnai-Feher, Photorealistic Material Learning and Synthesis, TU Wien 2019, chapter 5 (numbers in brackets are
   its equations); Jimenez, Zsolnai, Jarabo, Freude, Auzinger, Wu, von der Pahlen, Wimmer, Gutierrez 2015, Separable
   subsurface scattering; d'Eon, Luebke, Enderton 2007, Efficient rendering of human skin; Burley 2015; Christensen and
   Burley 2015.

   Sections (search for "---- name")
   ---------------------------------
   Declarations: profiles, elevation, kernels, errors, translucency, filter, pyramid, GPU. The contents of the
   implementation stand at its head.
*/
#ifndef MS_SSS_H
#define MS_SSS_H
#include <stddef.h>
#include <stdint.h>

#define MS_SSS_VERSION_MAJOR 0
#define MS_SSS_VERSION_MINOR 3
#define MS_SSS_VERSION_PATCH 0
#define MS_SSS_VERSION 300 /* major * 10000 + minor * 100 + patch */
#define MS_SSS_VERSION_STRING "0.3.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON
#define MS_COMMON 4 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__) || defined(__clang__)
#define MS__UNUSED __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS__UNUSED
#endif
#define MS_API MS_DEF MS__UNUSED

/* NULL, in every header: where an argument's comment does not say what NULL means, it may not be NULL. A call that
   returns a status then answers MS_INVALID_ARGUMENT and names the argument; any other does nothing and returns 0 or
   NULL. destroy and free do nothing with NULL. */

/* What went wrong; each code asks for another remedy. ms_status_string has a sentence for each. */
typedef enum ms_status {
    MS_OK = 0,
    MS_INVALID_ARGUMENT = 1,
    MS_OUT_OF_MEMORY = 2,
    MS_BAD_DATA = 3,
    MS_UNSUPPORTED = 4,
    MS_NOT_CONVERGED = 5,
    MS_CANCELLED = 6,
    MS_IO = 7
} ms_status;

/* Details of a failure. Every call that takes one accepts NULL; it is written on failure only. */
typedef struct ms_error {
    ms_status status;
    size_t position;   /* line (from 1), byte offset or row, as the call says; 0 where there is none */
    char message[240]; /* a sentence: which value was wrong and what was expected; ends with NUL */
} ms_error;

/* Memory. All zero: malloc and free. alloc returns memory aligned as malloc's, or NULL.
   release gets the size that alloc was asked for, and is never called with NULL. */
typedef struct ms_allocator {
    void *user;
    void *(*alloc)(void *user, size_t size);
    void (*release)(void *user, void *pointer, size_t size);
} ms_allocator;

/* Threads. All zero: everything runs on the calling thread. run calls task(context, i) once for every i in [0, count),
   in any order, on any threads, and returns when all are done. The work is cut into tasks by the problem alone, so
   results do not depend on how many threads there are. */
typedef struct ms_parallel {
    void *user;
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context);
} ms_parallel;

/* Progress of a long call. All zero: none. report gets the fraction done, 0 to 1, from the thread that made the call;
   it returns non-zero to stop, and the call then returns MS_CANCELLED. */
typedef struct ms_progress {
    void *user;
    int (*report)(void *user, double fraction);
} ms_progress;

/* Instruction sets, in the order of their speed. Options take one as a cap: a level that the processor or the build
   lacks falls back to the next lower one. */
typedef enum ms_simd {
    MS_SIMD_AUTO = 0,   /* the best that the processor has */
    MS_SIMD_SCALAR = 1, /* plain C: the reference for all the others */
    MS_SIMD_BASE = 2,   /* SSE2 on x86-64, NEON on ARM64 */
    MS_SIMD_AVX2 = 3,   /* AVX2 and FMA */
    MS_SIMD_AVX512 = 4  /* AVX-512 F, BW, DQ, VL */
} ms_simd;

/* "unknown status" outside the codes. */
static inline const char *ms_status_string(ms_status status)
{
    static const char *const sentence[] = {"success",
                                           "an argument is outside its stated range",
                                           "the allocator returned NULL",
                                           "the file or the data set is malformed",
                                           "valid, but not handled by this build or call",
                                           "the iteration stopped short of its tolerance",
                                           "the progress callback asked to stop",
                                           "the operating system could not read or write"};
    return (int)status >= 0 && status <= MS_IO ? sentence[status] : "unknown status";
}

/* "auto", "scalar", "base", "avx2", "avx512"; "unknown" outside the list. */
static inline const char *ms_simd_string(ms_simd level)
{
    static const char *const name[] = {"auto", "scalar", "base", "avx2", "avx512"};
    return (int)level >= 0 && level <= MS_SIMD_AVX512 ? name[level] : "unknown";
}
#endif /* MS_COMMON */

#if MS_COMMON != 4 /* outside the guard: an earlier #include may have defined another */
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---- profiles -------------------------------------------------------------------------------------------------- */

#define MS_SSS_GAUSSIANS_MAX 16 /* Gaussians of one profile */

/* A diffusion profile: the light that leaves a half-space at distance r from where it entered, R_d(r) in 1/mm^2, in
   red, green and blue. Radially symmetric, unchanging once made: any number of threads may read it. All lengths in
   mm. */
typedef struct ms_sss_profile ms_sss_profile;

/* From averages over rings, as Monte Carlo tallies and ms_mcml.h deliver them. The values are copied.
   edge_mm  [count + 1] 0 to 1e9, each at least 1e-9 above the one before; a hole inside edge_mm[0] counts as dark
   value    three arrays of count averages in 1/mm^2, 0 to 1e30, stride elements apart (0: 1)
   Within a ring R_d is linear in r^2, with the ring's energy and the slope of its neighbors where they agree, else 0.
   MS_INVALID_ARGUMENT: counts, edges, values (error->position: the ring). MS_OUT_OF_MEMORY. *profile is then NULL. */
MS_API ms_status ms_sss_profile_from_rings(ms_sss_profile **profile, int count, const double *edge_mm,
                                           const double *const value[3], int stride, const ms_allocator *allocator,
                                           ms_error *error);

/* From point samples R_d(r_mm[i]), count >= 2; distances and values have the ranges of edges and values above. Between
   samples R_d is linear in r^2; inside the first it is constant, beyond the last 0. A profile with a pole at r = 0 is
   better given as rings. */
MS_API ms_status ms_sss_profile_from_samples(ms_sss_profile **profile, int count, const double *r_mm,
                                             const double *const value[3], int stride, const ms_allocator *allocator,
                                             ms_error *error);

/* R_d(r) = sum_i weight_i exp(-r^2 / (2 sigma_i^2)) / (2 pi sigma_i^2): d'Eon's skin, fits, and the two-Gaussian artist
   model (5.6), whose separable kernel a_m is the pre-integrated kernel of this profile with count = 2.
   sigma_mm, weight  [count][3], 1e-9 to 1e9 and 0 to 1e9; 1 <= count <= MS_SSS_GAUSSIANS_MAX */
MS_API ms_status ms_sss_profile_from_gaussians(ms_sss_profile **profile, int count, const double (*sigma_mm)[3],
                                               const double (*weight)[3], const ms_allocator *allocator,
                                               ms_error *error);

/* Normalized diffusion, R_d(r) = reflectance (exp(-r/d) + exp(-r/(3 d))) / (8 pi d r).
   reflectance 0 to 1e9, d_mm 1e-9 to 1e9. Burley 2015, Extending the Disney BRDF to a BSDF with integrated subsurface
   scattering. */
MS_API ms_status ms_sss_profile_from_burley(ms_sss_profile **profile, const double reflectance[3], const double d_mm[3],
                                            const ms_allocator *allocator, ms_error *error);

/* Burley's d for a diffuse surface albedo A in [0, 1] and a mean free path, 1 / (mu_s (1 - g) + mu_a), the length that
   ms_mcml.h and `build/profile --mfp` take: d = path / (1.85 - A + 7 |A - 0.8|^3 - 1.25 max(0, A - 0.65)).
   The terms before the last are equation 5 (searchlight configuration) of Christensen and Burley 2015, Approximate
   reflectance profiles for efficient subsurface scattering. The last one is not the paper's: it was fitted here to
   half-spaces by ms_mcml.h, from whose mean distance between entry and exit the formula differs by at most 9% from A =
   0.1 to 0.95 (without the term by 11% at 0.75, 35% at 0.91). An engine that stores a *diffuse* mean free path
   (Unreal) takes the paper's other form: d = path / (3.5 + 100 (A - 0.33)^4). */
MS_API double ms_sss_burley_d_mm(double albedo, double mean_free_path_mm);

/* NULL is fine. */
MS_API void ms_sss_profile_destroy(ms_sss_profile *profile);

/* Total reflectance ||R_d||_1, 0 to 1 for a passive medium. */
MS_API void ms_sss_profile_reflectance(const ms_sss_profile *profile, double out[3]);

/* R_d(r), 1/mm^2; r >= 0. At a pole: infinity. */
MS_API void ms_sss_profile_value(const ms_sss_profile *profile, double r_mm, double out[3]);

/* Light that leaves within distance r, integral over the disc. */
MS_API void ms_sss_profile_disc(const ms_sss_profile *profile, double r_mm, double out[3]);

/* Light that leaves within x of a line through the entry: the integral from -x to x of the pre-integrated kernel
   a_p(x) = integral of R_d(sqrt(x^2 + y^2)) over all y (5.4), in closed form. */
MS_API void ms_sss_profile_strip(const ms_sss_profile *profile, double x_mm, double out[3]);

/* Radius that holds this fraction (0 to 1) of each channel's light, to 1e-9 of itself; 0 for an empty channel. */
MS_API void ms_sss_profile_radius(const ms_sss_profile *profile, double fraction, double out[3]);

/* ---- elevation ------------------------------------------------------------------------------------------------- */

/* A curved surface returns more light than the plane that the profile was made for, a hollow less: the profile between
   q and p with outward normals n_q and n_p is multiplied by f = max(0, 1 + K sin(theta) / 4)^4, where sin(theta) = (n_p
   - n_q).(p - q) / (2 |p - q|). The factor multiplies the color and not the normalization: out = reflectance sum(w f E)
   / sum(w), where reflectance sum(w f) / sum(w) is kept at or below 1. Returns K for a channel; index: of refraction, 1
   to 2; 0 without light. It is fitted to random walks in spheres and hollows (`make bench FILTER=sss_elevation`): where
   the reflectance is above 0.1, balls and cylinders of 8 mean free paths are met within 4%, of 4 within 8%. Hollows of
   4 in bright media come out too bright by up to 40%. */
MS_API double ms_sss_elevation(double reflectance, double index);

/* ---- kernels --------------------------------------------------------------------------------------------------- */

#define MS_SSS_TAPS_MAX 257 /* taps of one 1D pass, center included */
#define MS_SSS_TERMS_MAX 6  /* separable terms */
#define MS_SSS_DENSE (-1)   /* as tap_count: a tap every pixel of the design radius; not image-optimal */

/* A separable kernel, ready to be applied: out = delta E + sum_t scale_t (E * w_t along x) * w_t along y.
   Entry 0 of a pass is the tap at the center, entry i a pair of taps at -offset_mm[i] and +offset_mm[i] that have the
   same weight. Normalized: delta + sum_t scale_t (w_t0 + 2 sum_i w_ti)^2 = 1 in every channel, at most 1 for
   MS_SSS_SVD. */
typedef struct ms_sss_kernel {
    int tap_count;                            /* of a pass, odd: the center and tap_count / 2 pairs */
    int term_count;                           /* 1 except for SVD, sums of Gaussians, residuals */
    float offset_mm[MS_SSS_TAPS_MAX / 2 + 1]; /* 0, then growing */
    float weight[MS_SSS_TERMS_MAX][MS_SSS_TAPS_MAX / 2 + 1][3];
    float scale[MS_SSS_TERMS_MAX][3]; /* factor of each term after both passes (sign of a singular value) */
    float delta[3];                   /* weight of the unblurred input */
    float radius_mm;                  /* the outermost offset plus half its cell */
    float reflectance[3];             /* the profile's total; the kernel itself is normalized */
    float profile_radius_mm;          /* radius of 99% of the light of the widest channel; 0: radius_mm */
    float elevation[3];               /* K of ms_sss_elevation; 0: no elevation */
    float decay[3];                   /* 1/mm, decay of light with depth, see ms_sss_transmission */
    float elevation_axis[3];          /* K of one 1D pass: both passes have the mean of the round kernel */
} ms_sss_kernel;

/* How the 2D profile becomes separable terms. Cost: 2 term_count passes. */
typedef enum ms_sss_model {
    MS_SSS_IMAGE_OPTIMAL = 0,  /* least error on pictures with a 1/f spectrum; `dial` turns it towards the next */
    MS_SSS_PREINTEGRATED = 1,  /* a_p (5.4): exact on signals that are a sum of E1(x) and E2(y) */
    MS_SSS_RESIDUAL = 2,       /* a_p plus term_count - 1 singular vectors of the rest, each exact on those signals */
    MS_SSS_SVD = 3,            /* term_count singular vectors (5.12); loses energy, never gains any */
    MS_SSS_SVD_NORMALIZED = 4, /* the same, scaled to keep the energy */
    MS_SSS_GAUSSIANS = 5,      /* best sum of term_count Gaussians (5.9) */
    MS_SSS_GUIDED = 6,         /* guided optimization (5.14) with guide_k */
    MS_SSS_ARTIST = 7,         /* two Gaussians along the axes (5.6), fitted to a_p */
    MS_SSS_SLICE = 8           /* R_d sampled along the axis: a model of the released shader, the figures' peer */
} ms_sss_model;

/* Where the taps of a pass stand. */
typedef enum ms_sss_placement {
    MS_SSS_OPTIMIZED = 0, /* positions and weights of least error on 1/f pictures, shared by the channels */
    MS_SSS_QUANTILE = 1,  /* importance-sampled: cells of equal energy of the widest channel */
    MS_SSS_QUADRATIC = 2  /* offsets grow with the square of their index, as in the thesis */
} ms_sss_placement;       /* in the last two each weight is the integral of the kernel over its cell */

/* Zero is the default of every field; ms_sss_kernel_defaults() returns that. */
typedef struct ms_sss_kernel_options {
    int tap_count; /* of a pass: odd, 3 to 33 for MS_SSS_OPTIMIZED, which makes at most a pair a pixel of the designer's
                      radius, else to MS_SSS_TAPS_MAX; 0: 7; or MS_SSS_DENSE */
    int term_count; /* 1 to MS_SSS_TERMS_MAX; 0: 1 (residual: 2) */
    ms_sss_model model;
    ms_sss_placement placement;
    int no_delta;   /* 1: no weight on the unblurred input */
    double dial;    /* image-optimal only: 0 texture ... 1 a_p, exact on axis-parallel signals */
    double guide_k; /* guided only: 0 near scattering ... 4 far scattering; the thesis calls 2 neutral */
    double index;   /* of refraction, 1 to 2, for the kernel's elevation; 0: 1 */
} ms_sss_kernel_options;

MS_API ms_sss_kernel_options ms_sss_kernel_defaults(void);

/* A designer builds and measures many kernels for one profile at one size on the screen. It holds the profile's cells
   and spectrum, and the spectra of the standard signals. */
typedef struct ms_sss_designer ms_sss_designer;

/* radius_px: pixels that the 99% energy radius of the widest channel covers where the kernel will be used, up to 1e9;
   0: 24; above 128: 128, from where on errors hardly change. Kernels scale with depth when they are applied: design for
   the closest view that matters. The profile is not kept.
   MS_INVALID_ARGUMENT: radius_px; a profile without any light. MS_OUT_OF_MEMORY: 2 MB are needed. */
MS_API ms_status ms_sss_designer_create(ms_sss_designer **designer, const ms_sss_profile *profile, double radius_px,
                                        const ms_allocator *allocator, ms_error *error);
MS_API void ms_sss_designer_destroy(ms_sss_designer *designer);

/* One kernel. options NULL: 7 optimized taps. A channel without light gets the identity. designer is only read.
   MS_INVALID_ARGUMENT: an option outside its range (the message names it). MS_OUT_OF_MEMORY. kernel untouched then. */
MS_API ms_status ms_sss_kernel_build(ms_sss_kernel *kernel, const ms_sss_designer *designer,
                                     const ms_sss_kernel_options *options, ms_error *error);

/* ---- errors ---------------------------------------------------------------------------------------------------- */

/* The error of a kernel against the profile's 2D convolution: the root mean square difference over the standard
   deviation of the right result, over all channels, on signals of 512 x 512 pixels that repeat. */
typedef struct ms_sss_errors {
    double vertical_step; /* an edge along an axis */
    double diagonal_step; /* an edge at 45 degrees */
    double dot;           /* one pixel */
    double texture;       /* noise with amplitude 1/f: stands for natural pictures */
    double bands; /* stairs along a shadow's edge: of an edge from black to white along an axis, as sRGB with 255 for
                     white, the largest second difference from pixel to pixel, against the right result's; absolute */
} ms_sss_errors;

#define MS_SSS_BANDS_SEEN 24 /* bands above which stairs are seen */

/* Taps between pixels are read with linear interpolation, as the filter and GPUs do. Takes 60 KB from the designer's
   allocator and gives them back. MS_INVALID_ARGUMENT: a NULL, a kernel that ms_sss_filter refuses, an offset beyond 1e6
   cells of the designer. MS_OUT_OF_MEMORY. errors untouched then. */
MS_API ms_status ms_sss_kernel_measure(ms_sss_errors *errors, const ms_sss_kernel *kernel,
                                       const ms_sss_designer *designer);

/* A designer for radius_px, a kernel by options (NULL: 7 optimized taps) and its errors (optional) in one call. Where
   memory lacks for the errors alone, the kernel is made nevertheless. */
MS_API ms_status ms_sss_kernel_make(ms_sss_kernel *kernel, ms_sss_errors *errors, const ms_sss_profile *profile,
                                    double radius_px, const ms_sss_kernel_options *options,
                                    const ms_allocator *allocator, ms_error *error);

/* ---- translucency ---------------------------------------------------------------------------------------------- */

/* For an engine's light loop: the light of one lamp that reaches a point which faces away from it, through the object.
     thickness_mm   from the point to where the lamp's light enters the object, along the light: by the shadow map;
                    below 0: 0
     normal, entry_normal, to_light
                    outward normals at the point and at that entry, direction to the lamp; unit length, common axes
     light          the lamp's irradiance at the entry, on a plane at a right angle to the light
     out            T(thickness) (1 + (1 / R - 1) max(0, -normal.entry_normal)) max(0, entry_normal.to_light) light,
                    in the filter's units: reflectance or albedo times out leaves the surface
   T(s) = (1 - R^2) x / (1 - R^2 x^2) (1 - 0.85 (1 - R)^5 (1 - x^0.8)) is the fraction that a slab transmits of light
   that enters its far side evenly from all directions, with x = exp(-decay s) and R the channel's reflectance: the
   two-stream solution (Kubelka and Munk 1931) with a loss near the surface of dark media. It is within 7% of random
   walks where R is 0.15 to 0.95 and T above 1e-3; with an index of 1.4 inside up to a fifth less passes, a third where
   R is below 0.4. The profile needs its true reflectance, not one normalized to 1.
   out is 0 where the point faces the lamp, where the entry does not, where R is 0, and where the thickness is NaN.
   Combine it with the filtered light by max: a sum would count the light near the shadow's border twice. */
MS_API void ms_sss_transmission(const ms_sss_kernel *kernel, float thickness_mm, const float normal[3],
                                const float entry_normal[3], const float to_light[3], const float light[3],
                                float out[3]);

/* ---- filter ---------------------------------------------------------------------------------------------------- */

/* Pixels in the caller's memory: three channels, or one value a pixel (depth, strength) in channel[0]. All zero: no
   picture. The filter writes to its output alone. */
typedef struct ms_sss_image {
    float *channel[3];      /* red, green and blue of the first pixel */
    ptrdiff_t pixel_stride; /* floats from a pixel to the next: planar 1, RGB 3, RGBA and RGB + depth 4; 0: 1 */
    ptrdiff_t row_stride;   /* floats from a row to the next, negative for bottom-up; 0: width * pixel_stride */
} ms_sss_image;

/* Views: pixels of `channels` interleaved floats of which the first three are color (3: RGB, 4: RGBA or RGB and depth);
   three planes; one value a pixel, every stride floats (depth in RGB + depth: values = pixels + 3, stride 4). Rows are
   tightly packed; set row_stride where they are not. */
MS_API ms_sss_image ms_sss_interleaved(const float *pixels, int channels);
MS_API ms_sss_image ms_sss_planar(const float *red, const float *green, const float *blue);
MS_API ms_sss_image ms_sss_map(const float *values, int stride);

/* The pictures of a call. The input is linear light that entered the surface, before the albedo unless the albedo is
   baked in. It must not hold specular reflection, which never went below the surface. Composition is the caller's:
   albedo times the larger of the output and the transmitted light, plus specular light (examples/engine/compose.h). All
   pictures begin at the same side, top or bottom. */
typedef struct ms_sss_frame {
    int width, height;      /* 1 to 65536 each */
    ms_sss_image input;     /* linear RGB */
    ms_sss_image output;    /* every pixel is written; may be the input, but must not overlap it otherwise */
    ms_sss_image depth;     /* optional with pixels_per_mm: distance along the view axis (not the ray), scene units */
    ms_sss_image strength;  /* optional, 0 to 1: fraction of the effect; 0 and NaN: masked */
    const uint8_t *profile; /* optional [height][width]: kernel of each pixel; from kernel_count on: masked */
    ms_sss_image normal;    /* optional: normals of the surface, without bump maps, of any length, in view space: x to
                               the right, y to later rows, z towards the camera; none: slopes from depth, see `flat` */
} ms_sss_frame;

/* The weight of a tap whose depth differs from the pixel's by dz. */
typedef enum ms_sss_depth_mode {
    MS_SSS_DEPTH_AWARE = 0, /* weighted by dz from the tangent plane, renormalized; see the head comment */
    MS_SSS_DEPTH_SCALE = 1  /* depth sets the kernel's size in pixels only; light leaks across silhouettes */
} ms_sss_depth_mode;

/* Zero, as from ms_sss_filter_defaults(), is the default of every field but one of the three that give the size of a
   pixel: set exactly one of pixels_per_mm[0], fov_degrees and ortho_height. */
typedef struct ms_sss_filter_options {
    float pixels_per_mm[2]; /* texture space: pixels a millimeter along x and y; [1] 0: as [0] */
    float fov_degrees;      /* perspective: the picture's full angle along y, in (0, 180) */
    float ortho_height;     /* orthographic: scene units from the picture's top to its bottom */
    float center[2];   /* perspective: where the view axis meets the picture, in pixels from its middle, x to the right,
                          y as rows grow; 0 but for off-center projections: -P02 width / 2, of OpenGL's matrix */
    float mm_per_unit; /* millimeters in a scene unit, 1000 for meters; 0: 1, refused where kernels then cover half of
                          the picture */
    ms_sss_depth_mode depth_mode;
    float depth_sigma_mm; /* of MS_SSS_DEPTH_AWARE: weights are 0 from |dz| = 3.0746 sigma on, with flat 1 from
                             radius_mm on if that is less; 0: from 1.5 times the profile's 99% radius on (flat 1: 0.37
                             times, linear between) */
    float flat; /* 0: the surface's slope and curvature count in full if there is depth (MS_SSS_DEPTH_AWARE); 1: not at
                   all; between: slopes are scaled by 1 - flat */
    int exact;  /* pyramid: 1 gathers from more pixels, for less error and more time */
    ms_simd simd;         /* cap of the instruction set */
    ms_parallel parallel; /* the program's threads: up to 16 tasks a call; zero: the calling thread alone */
} ms_sss_filter_options;

MS_API ms_sss_filter_options ms_sss_filter_defaults(void);

/* Bytes that ms_sss_filter needs for frames of this size: about 30 a pixel of a large picture (flat 1: 18), 12 more
   with kernels of several terms. SIZE_MAX: an argument out of range, or more than this machine can address. */
MS_API size_t ms_sss_filter_workspace(int width, int height, const ms_sss_kernel *kernels, int kernel_count,
                                      const ms_sss_filter_options *options);

/* Subsurface scattering of a picture or a texture by two passes a term: blur = delta E + sum_t scale_t (E * w_t along
   x) * w_t along y, then (1 - strength) E + strength blur. E is the input. Depth's part is in the head comment.
   kernels    [kernel_count], 1 to 256; a radius above the picture's larger side is reduced to it along x
   workspace  ms_sss_filter_workspace(...) bytes, any alignment and content; NULL and size 0: from malloc
   Masked pixels keep their bits: a channel is NaN or not within 1e30, the depth is not finite or not positive, the
   strength is 0 or NaN, or the profile has no kernel. No light passes between masked and other pixels, or between
   profiles. The effect fades from kernels with a radius of a pixel to those of half a pixel, from where on pixels keep
   their bits. Results are bit-equal for any thread count at one SIMD level, across levels within 4e-6 of the largest
   pixel of input and output, typically 1e-6; more where the rounding of depths or normals of no surface decide.
   MS_INVALID_ARGUMENT: a pointer, size, stride, option or kernel out of range. MS_OUT_OF_MEMORY: only without a
   workspace. Nothing is written then. Thesis 5.5, 5.10. */
MS_API ms_status ms_sss_filter(const ms_sss_frame *frame, const ms_sss_kernel *kernels, int kernel_count,
                               const ms_sss_filter_options *options, void *workspace, size_t workspace_size,
                               ms_error *error);

/* ---- pyramid --------------------------------------------------------------------------------------------------- */

#define MS_SSS_PYRAMID_LEVELS 12 /* of a pyramid; level l is 2^l times smaller */
#define MS_SSS_PYRAMID_SIZES 49  /* kernel radii of 1, 1.25, 1.5, 1.75, 2, 2.5 ... 4096 pixels */

/* The round 2D kernel of a profile as a sum over the levels of a pyramid, for radii from about 16 pixels on: the cost
   does not depend on the radius. [0][0] is the weight of a pixel's own light, [0][1] of its neighbors', [l][1] of the
   gather from level l; all are >= 0 and add up to 1. */
typedef struct ms_sss_pyramid {
    float radius_mm;                                                    /* of 99% of the light of the widest channel */
    float weight[2][MS_SSS_PYRAMID_SIZES][MS_SSS_PYRAMID_LEVELS][2][3]; /* [exact][size][level][blurred][channel] */
    float elevation[3];                                                 /* K of ms_sss_elevation at index 1 */
    float reflectance[3]; /* the profile's total; the weights add up to 1 */
} ms_sss_pyramid;

/* Fits the weights: least squares of the transfer function for pictures with a 1/f spectrum, for every size.
   MS_INVALID_ARGUMENT: a NULL, a profile without light. *pyramid is untouched then. */
MS_API ms_status ms_sss_pyramid_make(ms_sss_pyramid *pyramid, const ms_sss_profile *profile, ms_error *error);

/* Bytes that ms_sss_pyramid_filter needs: about 40 a pixel of a large picture. SIZE_MAX: sides out of range. */
MS_API size_t ms_sss_pyramid_workspace(int width, int height);

/* ms_sss_filter with round kernels instead of separable ones: less error above a radius of some 10 pixels, at a cost
   that does not depend on the radius. With depth and MS_SSS_DEPTH_AWARE every pixel gathers from 8 or 15 pixels of the
   next coarser level, more (up to 33) where the surface is tilted (options.exact 1: 15 to 64), weighted by distance and
   by the area of surface that they show. Light reaches only pixels of the same surface: none crosses a depth edge wider
   than the radius. A constant stays constant on planes. Planes steeper than 48 degrees are blurred too little along the
   level line and too much down the slope (by 0.04 of a wave's height at 60 degrees, 0.15 at 75). Masks, fading and
   determinism are as in ms_sss_filter.
   pyramids   [pyramid_count], 1 to 256: of each of frame->profile
   workspace  ms_sss_pyramid_workspace bytes; NULL and size 0: from malloc
   MS_INVALID_ARGUMENT: as ms_sss_filter; a pyramid that was never made. MS_UNSUPPORTED: pixels_per_mm that differ.
   MS_OUT_OF_MEMORY: only without a workspace. Nothing is written then. */
MS_API ms_status ms_sss_pyramid_filter(const ms_sss_frame *frame, const ms_sss_pyramid *pyramids, int pyramid_count,
                                       const ms_sss_filter_options *options, void *workspace, size_t workspace_size,
                                       ms_error *error);

/* ---- GPU ------------------------------------------------------------------------------------------------------- */

#define MS_SSS_SHADER_PROFILES_MAX 16 /* kernels of one pass */

/* The shaders are the files ms_sss.glsl and ms_sss_pyramid.glsl of examples/engine/shader, in GLSL, HLSL and WGSL.
   Their first comments list the #defines and what a step reads and writes. This header makes their constants.
     full resolution   X, Y of each term
     half resolution   DOWN, X, Y of each term, UP; all with the constants of the full picture
     pyramid           of each profile: BASE; SHRINK of levels 0 to n - 2; GATHER of levels n - 2 to 1; RESOLVE
     texture space     the same over a light map, with options.pixels_per_mm
   n is ms_sss_shader_levels. Texels that a pixel reads with 7 taps in X and Y: 26 of color, and 13 of depth, profile
   and strength each; for slopes 12 more of depth, or 2 of normals; rotated axes: twice as many. Half resolution: 2, 11
   and for slopes 8 or a normal, and a quarter of X and Y. A pyramid: 73 in all, more on slopes.
   Half resolution is for radii from 16 pixels on: as near to random walks, and taps show less beside thin strips of
   light. */
typedef enum ms_sss_step {
    MS_SSS_STEP_X = 0,
    MS_SSS_STEP_Y = 1,
    MS_SSS_STEP_DOWN = 2,
    MS_SSS_STEP_UP = 3,
    MS_SSS_STEP_BASE = 4,
    MS_SSS_STEP_SHRINK = 5,
    MS_SSS_STEP_GATHER = 6,
    MS_SSS_STEP_RESOLVE = 7
} ms_sss_step;

typedef struct ms_sss_shader {
    int tap_count;          /* MS_SSS_TAPS: the most of any of the kernels; a pyramid: any */
    int profile_count;      /* MS_SSS_PROFILES: 0 to MS_SSS_SHADER_PROFILES_MAX kernels; 0: one, no profiles are read */
    int term_count;         /* MS_SSS_TERMS of UP: the most of any of the kernels; 0: 1 */
    int half_resolution;    /* MS_SSS_HALF */
    ms_sss_step step;       /* MS_SSS_STEP */
    int level;              /* of a pyramid; SHRINK: that it reads */
    int origin[2];          /* the viewport's corner in the engine's textures and in targets of the picture's size */
    float fade;             /* 0: full effect, 1: none; the strength is 1 - fade times the strength texture */
    float rotation, jitter; /* MS_SSS_ROTATED: the axes turn by rotation radians and, a pixel, 0 to jitter quarters */
    float nearest;          /* > 0: the scene's least depth; a kernel too wide there for its taps is refused */
    const ms_sss_pyramid *pyramids; /* of a pyramid: [profile_count, at least 1], borrowed */
} ms_sss_shader;

/* All zero but 7 taps: X at full resolution. */
MS_API ms_sss_shader ms_sss_shader_defaults(void);

/* Float4 constants that a step reads. OpenGL ES 3.0 promises 224. 0: a field is out of range. */
MS_API int ms_sss_shader_constant_count(const ms_sss_shader *shader);

/* Levels of a pyramid of a picture. */
MS_API int ms_sss_shader_levels(int width, int height);

/* The values of the constants; made again when picture, camera, kernels, options or `origin` change, not every frame.
   kernels         [profile_count, at least 1]; one with fewer terms than another adds nothing; a pyramid: NULL
   index           of the term, the same for X and Y; UP: 0, all are read; a pyramid: of the profile
   options         camera, units and depth, as of ms_sss_filter; without depth flat must be 1
   width, height   of the viewport; options->center is that of its projection
   out             [ms_sss_shader_constant_count()][4]; untouched where the call fails
   MS_INVALID_ARGUMENT: as ms_sss_filter. MS_UNSUPPORTED: a pyramid with rotation or unequal pixels_per_mm; with
   `nearest` a kernel that shows stairs there, from 8 pixels on with 7 taps, 16 with 11, 47 with 17, 150 with 25. */
MS_API ms_status ms_sss_shader_constants(const ms_sss_kernel *kernels, int index, const ms_sss_filter_options *options,
                                         int width, int height, const ms_sss_shader *shader, float (*out)[4],
                                         ms_error *error);

#ifdef __cplusplus
}
#endif
#endif /* MS_SSS_H */

#if defined(MS_SSS_IMPLEMENTATION) && !defined(MS_SSS__PASS) && !defined(MS_SSS_IMPLEMENTED)
#define MS_SSS_IMPLEMENTED /* included again, it is declarations only */
#define MS_SSS__BODY 1     /* the implementation goes on behind the kernels */
/* ms-common-private begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON_PRIVATE
#define MS_COMMON_PRIVATE
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* a * b and a + b; SIZE_MAX stands for overflow and stays so through further calls. */
static MS__UNUSED size_t ms__size_mul(size_t a, size_t b)
{
    if (a == SIZE_MAX || b == SIZE_MAX) return SIZE_MAX;
    return a != 0 && b > SIZE_MAX / a ? SIZE_MAX : a * b;
}

static MS__UNUSED size_t ms__size_add(size_t a, size_t b) { return b > SIZE_MAX - a ? SIZE_MAX : a + b; }

/* Pieces of one block, each on a multiple of 64 bytes. base NULL: take only counts; then the same calls with a block of
   `used` bytes place what was counted. used SIZE_MAX: overflow. */
typedef struct ms__arena {
    char *base; /* NULL, or aligned to 64 bytes */
    size_t used;
} ms__arena;

static MS__UNUSED void *ms__take(ms__arena *arena, size_t count, size_t size)
{
    const size_t at = arena->used, end = ms__size_add(at, ms__size_mul(count, size));
    arena->used = end > SIZE_MAX - 63 ? SIZE_MAX : (end + 63) / 64 * 64;
    return arena->base != NULL ? arena->base + at : NULL;
}

/* NULL for size SIZE_MAX (overflow). Size 0 gives a pointer that must be released as well. */
static MS__UNUSED void *ms__alloc(const ms_allocator *allocator, size_t size)
{
    if (size == SIZE_MAX) return NULL;
    if (allocator != NULL && allocator->alloc != NULL) return allocator->alloc(allocator->user, size ? size : 1);
    return malloc(size ? size : 1);
}

static MS__UNUSED void ms__release(const ms_allocator *allocator, void *pointer, size_t size)
{
    if (pointer == NULL) return;
    if (allocator == NULL || allocator->alloc == NULL) free(pointer);
    else if (allocator->release != NULL) allocator->release(allocator->user, pointer, size ? size : 1);
}

static MS__UNUSED void ms__run(const ms_parallel *parallel, int count, void (*task)(void *context, int index),
                               void *context)
{
    int i;
    if (parallel != NULL && parallel->run != NULL && count > 1) parallel->run(parallel->user, count, task, context);
    else
        for (i = 0; i < count; ++i) task(context, i);
}

/* By its bits: isfinite() is removed by -ffast-math. */
static MS__UNUSED int ms__finite(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

static MS__UNUSED int ms__finite_f(float x) { return ms__finite((double)x); }

/* The decimal digits of value before `end`, where a NUL is written. Returns the first. */
static MS__UNUSED char *ms__format_integer(char *end, size_t value)
{
    for (*end = 0; value || !*end; value /= 10) *--end = (char)('0' + (int)(value % 10));
    return end;
}

/* x with 6 significant digits and '.' in every locale, into 24 bytes. */
static MS__UNUSED void ms__format_number(char *out, double x)
{
    char text[8], *digit;
    int n = 0, exponent = 5, count = 6, point, i;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (!ms__finite(x)) {
        memcpy(out, bits << 12 ? "nan\0" : bits >> 63 ? "-inf" : "inf\0", 5);
        return;
    }
    if (bits >> 63) out[n++] = '-';
    x = x < 0 ? -x : x;
    if (!(x > 0)) exponent = 0, count = 1;
    for (; x >= 999999.5; ++exponent) x /= 10; /* to six digits before the point */
    for (; x > 0 && x < 99999.95; --exponent) x *= 10;
    digit = ms__format_integer(text + 7, (size_t)(x + 0.5));
    while (count > 1 && digit[count - 1] == '0') --count;
    point = exponent >= -4 && exponent < 7 ? exponent : 0; /* the digit that it follows */
    for (i = point < 0 ? point : 0; i < count || i <= point; ++i) {
        out[n++] = i < 0 || i >= count ? '0' : digit[i];
        if (i == point && i + 1 < count) out[n++] = '.';
    }
    if (point != exponent) {
        out[n++] = 'e';
        out[n++] = exponent < 0 ? '-' : '+';
        exponent = exponent < 0 ? -exponent : exponent;
        if (exponent < 10) out[n++] = '0';
        for (digit = ms__format_integer(text + 7, (size_t)exponent); *digit;) out[n++] = *digit++;
    }
    out[n] = 0;
}

/* Fills error (may be NULL) and returns status. The format knows %s (char pointer), %d (int), %z (size_t), %g (double)
   and %%; a text that is too long is cut, a control character becomes '?'. */
static MS__UNUSED ms_status ms__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    char number[32], *end = number + sizeof number - 1;
    size_t n = 0;
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = position;
    va_start(list, format);
    for (; *format; ++format) {
        const char *piece = number;
        const char kind = *format == '%' ? *++format : 0;
        const int value = kind == 'd' ? va_arg(list, int) : 0;
        number[0] = *format;
        number[1] = 0;
        if (kind == 's') piece = va_arg(list, const char *);
        if (kind == 'g') ms__format_number(number, va_arg(list, double));
        if (kind == 'z') piece = ms__format_integer(end, va_arg(list, size_t));
        if (kind == 'd') piece = ms__format_integer(end, value < 0 ? 0 - (size_t)value : (size_t)value);
        if (value < 0 && n < sizeof error->message - 1) error->message[n++] = '-';
        for (; *piece && n < sizeof error->message - 1; ++piece)
            error->message[n++] = (unsigned char)*piece < 32 || *piece == 127 ? '?' : *piece;
    }
    va_end(list);
    error->message[n] = 0;
    return status;
}
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* ms-common-simd begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_SIMD
#define MS_COMMON_SIMD
/* MS_NO_SIMD leaves the scalar text of every header. 32-bit x86 has no baseline that can be relied on. */
#if !defined(MS_NO_SIMD) && (defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC)))
#define MS__X64 1
#include <immintrin.h>
#if !defined(_MSC_VER)
#include <cpuid.h>
#elif !defined(__clang__)
#include <intrin.h>
#else
#include <cpuid.h>
#include <smmintrin.h> /* here immintrin.h leaves out what the command line's target lacks */
#include <avxintrin.h>
#include <avx2intrin.h>
#include <f16cintrin.h>
#include <fmaintrin.h>
#include <avx512fintrin.h>
#include <avx512bwintrin.h>
#include <avx512dqintrin.h>
#endif
#elif !defined(MS_NO_SIMD) && (defined(__aarch64__) || defined(_M_ARM64))
#define MS__NEON 1
#include <arm_neon.h>
#endif

#if defined(MS__X64)
static MS__UNUSED void ms__cpuid(uint32_t leaf, uint32_t subleaf, uint32_t r[4])
{
#if defined(_MSC_VER) && !defined(__clang__)
    __cpuidex((int *)r, (int)leaf, (int)subleaf);
#else
    __cpuid_count(leaf, subleaf, r[0], r[1], r[2], r[3]);
#endif
}

/* What both the processor and the operating system (XCR0) support. */
static MS__UNUSED ms_simd ms__simd_detect(void)
{
    uint32_t r[4], xcr0;
    ms__cpuid(0, 0, r);
    if (r[0] < 7) return MS_SIMD_BASE;
    ms__cpuid(1, 0, r);
    if ((r[2] & 0x28001000u) != 0x28001000u) return MS_SIMD_BASE; /* OSXSAVE (XCR0 can be read), F16C, FMA */
#if defined(_MSC_VER) && !defined(__clang__)
    xcr0 = (uint32_t)_xgetbv(0);
#else
    __asm__ volatile("xgetbv" : "=a"(xcr0), "=d"(r[3]) : "c"(0));
#endif
    ms__cpuid(7, 0, r);
    if ((xcr0 & 0x6u) != 0x6u || !(r[1] & 0x20u)) return MS_SIMD_BASE;                       /* YMM state, AVX2 */
    if ((xcr0 & 0xe6u) != 0xe6u || (r[1] & 0xC0030000u) != 0xC0030000u) return MS_SIMD_AVX2; /* ZMM; F, DQ, BW, VL */
    return MS_SIMD_AVX512;
}
#endif

/* The level to use under a cap. cpuid takes microseconds under a hypervisor: ask once when an object is made or at the
   start of a long call, never in a loop. Nothing is kept in a global. */
static MS__UNUSED ms_simd ms__simd_pick(ms_simd cap)
{
    ms_simd best = MS_SIMD_SCALAR;
#if defined(MS__X64)
    best = cap == MS_SIMD_SCALAR || cap == MS_SIMD_BASE ? cap : ms__simd_detect();
#elif defined(MS__NEON)
    best = MS_SIMD_BASE;
#endif
    return cap != MS_SIMD_AUTO && cap < best ? cap : best;
}
#endif /* MS_COMMON_SIMD */
/* ms-common-simd end */

/* Contents (search for "---- name")
     checks                  ranges, kernels
     translucency code       ms_sss_transmission
     filter structures       views, passes, parameters; the inclusions of this file, one for each level of instructions
     filter kernels          compiled once a level: vector words, rows, the surface, taps
     pyramid kernels         compiled once a level: down, up, the picture's own level
     filter code             kernels in a view; memory, threads, the caller's pixels, rows; the two passes
     pyramid code            levels, runs over them, parameters
     filter calls            checks of a call, ms_sss_filter, ms_sss_pyramid_filter
     GPU code                constants of the shader files
   Design, which MS_SSS_NO_DESIGN leaves out:
     small maths, profile tables, pre-integration, cells and spectra, kernel errors, taps, kernel models,
     pyramid weights */

/* ---- checks ---------------------------------------------------------------------------------------------------- */
#include <float.h>
#include <math.h>

#if defined(__GNUC__) || defined(__clang__)
#define MS_SSS__NOINLINE __attribute__((noinline))
#define MS_SSS__COLD __attribute__((cold, noinline)) /* runs at most once a call: optimized for size */
#else
#define MS_SSS__NOINLINE
#define MS_SSS__COLD
#endif

#define MS_SSS__REFUSE_AT(error, index, ...) ms__fail(error, MS_INVALID_ARGUMENT, (size_t)(index), __VA_ARGS__)
#define MS_SSS__REFUSE(error, ...) MS_SSS__REFUSE_AT(error, 0, __VA_ARGS__)

/* A number of the caller and its range; NaN is outside of any. */
typedef struct ms_sss__range {
    const char *name;
    double value, low, high;
} ms_sss__range;

static MS_SSS__COLD ms_status ms_sss__check_ranges(const ms_sss__range *range, size_t count, ms_error *error)
{
    for (; count > 0; --count, ++range)
        if (!(range->value >= range->low && range->value <= range->high))
            return MS_SSS__REFUSE(error, "%s %g: %g to %g expected", range->name, range->value, range->low,
                                  range->high);
    return MS_OK;
}

/* NaN differs from everything. == raises no floating-point flag for a quiet NaN. */
static int ms_sss__differ(float a, float b) { return !(a == b); }

static int ms_sss__positive(float x) { return ms__finite_f(x) && x > 0; }

static MS_SSS__COLD ms_status ms_sss__check_kernel(const ms_sss_kernel *k, int index, ms_error *error)
{
    int i, c, t;
    if (k->tap_count < 1 || k->tap_count > MS_SSS_TAPS_MAX || k->tap_count % 2 == 0)
        return MS_SSS__REFUSE_AT(error, index, "kernel %d: tap_count %d is not an odd number from 1 to %d", index,
                                 k->tap_count, MS_SSS_TAPS_MAX);
    if (k->term_count < 1 || k->term_count > MS_SSS_TERMS_MAX)
        return MS_SSS__REFUSE_AT(error, index, "kernel %d: term_count %d is not within 1 to %d", index, k->term_count,
                                 MS_SSS_TERMS_MAX);
    if (!ms_sss__positive(k->radius_mm))
        return MS_SSS__REFUSE_AT(error, index, "kernel %d: radius_mm %g is not positive", index, (double)k->radius_mm);
    for (i = 0; i <= k->tap_count / 2; ++i) {
        if (!ms__finite_f(k->offset_mm[i]) || k->offset_mm[i] < 0 || (i == 0 && k->offset_mm[0] > 0))
            return MS_SSS__REFUSE_AT(error, index,
                                     "kernel %d: offset_mm[%d] is %g; entry 0 must be 0, all finite and none below 0",
                                     index, i, (double)k->offset_mm[i]);
        for (t = 0; t < k->term_count; ++t)
            for (c = 0; c < 3; ++c)
                if (!ms__finite_f(k->weight[t][i][c]) || !ms__finite_f(k->scale[t][c]) || !ms__finite_f(k->delta[c]))
                    return MS_SSS__REFUSE_AT(error, index, "kernel %d: term %d, entry %d, channel %d is not finite",
                                             index, t, i, c);
    }
    for (c = 0; c < 3; ++c)
        if (!(fabsf(k->elevation[c]) <= 1e6f && fabsf(k->elevation_axis[c]) <= 1e6f))
            return MS_SSS__REFUSE_AT(error, index, "kernel %d: elevation[%d] or elevation_axis[%d] is beyond 1e6",
                                     index, c, c);
    return MS_OK;
}

/* ---- translucency code ------------------------------------------------------------------------------------------ */

static double ms_sss__slab(double R, double decay, double s)
{
    double x = exp(-decay * (s > 0 ? s : 0)), dark = 1 - R;
    if (!(R > 0) || s != s) return 0; /* an unknown thickness is dark */
    return (1 - R * R) * x / (1 - R * R * x * x) * (1 - 0.85 * dark * dark * dark * dark * dark * (1 - pow(x, 0.8)));
}

MS_API void ms_sss_transmission(const ms_sss_kernel *kernel, float thickness_mm, const float normal[3],
                                const float entry_normal[3], const float to_light[3], const float light[3],
                                float out[3])
{
    float facing = 0, entry = 0, parallel = 0;
    int c;
    if (kernel == NULL || normal == NULL || entry_normal == NULL || to_light == NULL || light == NULL || out == NULL)
        return;
    for (c = 0; c < 3; ++c) {
        facing += normal[c] * to_light[c];
        entry += entry_normal[c] * to_light[c];
        parallel -= normal[c] * entry_normal[c];
    }
    for (c = 0; c < 3; ++c) {
        double R = (double)kernel->reflectance[c];
        out[c] = 0;
        if (!(facing < 0 && entry > 0 && R > 0)) continue;
        R = R < 0.9999 ? R : 0.9999;
        out[c] = (float)(ms_sss__slab(R, (double)kernel->decay[c], (double)thickness_mm) *
                         (1 + (1 / R - 1) * (parallel > 0 ? (double)parallel : 0))) *
            entry * light[c];
    }
}

/* ---- filter structures ----------------------------------------------------------------------------------------- */

#ifndef MS_SSS_FILENAME
#define MS_SSS_FILENAME "ms_sss.h" /* this file's name, for the inclusions below */
#endif
#if defined(__GNUC__) && !defined(__OPTIMIZE__)
#define MS_SSS__INLINE inline /* without optimization, inlined vectors would each take stack */
#elif defined(__GNUC__)
#define MS_SSS__INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define MS_SSS__INLINE __forceinline
#else
#define MS_SSS__INLINE inline
#endif

enum {
    MS_SSS__LEFT = 16,   /* floats before a row's first pixel: one vector of any level */
    MS_SSS__RIGHT = 32,  /* floats behind a row's last block: a vector, and the pixels beside it */
    MS_SSS__BLOCK = 32,  /* columns that are skipped together where all pixels are masked */
    MS_SSS__TASKS = 16,  /* of a call to options.parallel at most */
    MS_SSS__STRIP = 256, /* columns that the second pass takes down the rows: those of a kernel stay in the L2 cache */
    MS_SSS__SIDE_MAX = 65536,
    MS_SSS__FAR = 4 * MS_SSS__SIDE_MAX /* pixels: taps from here on lie outside of any picture */
};

#define MS_SSS__MASKED_DEPTH 1e15f /* scaled depth of masked pixels: finite, and too far away to count */
#define MS_SSS__FALLOFF_END 3.0746 /* (1 - (dz / (3.0746 sigma))^2)^4 is within 0.034 of exp(-dz^2 / (2 sigma^2)) */
#define MS_SSS__SPARSE 1e-3f       /* weight below which a tap's height counts as 0 */
#define MS_SSS__LIGHT_MAX 1e30f    /* pixels from here on are masked: their sums would be infinite */
#define MS_SSS__AREA_MAX 3.0f      /* bound on the area that one tap represents */
/* Radii within which a tap's elevation follows that of the next tap outwards: with 0.15 and 7 taps a mesh of 3 pixels a
   triangle still shows. */
#define MS_SSS__NEAR 0.17

/* The camera, or the scale of a texture. Rays are parallel unless `perspective`. */
typedef struct ms_sss__view {
    int width, height; /* pixels */
    int perspective;
    double mm_per_unit;   /* mm of a scene unit */
    double pixels_per_mm; /* along x; in perspective at a depth of 1 scene unit */
    float aspect[2];      /* pixels per mm along x and y, over pixels_per_mm */
    float middle[2];      /* where the view axis meets the picture, pixels from its corner */
} ms_sss__view;

/* Two taps at -x and +x. */
typedef struct ms_sss__pair {
    float offset[2];  /* x in mm, times the view's aspect of each axis */
    float per_mm;     /* 1 / x */
    float dz_falloff; /* see ms_sss__dz_falloff */
    float area_scale; /* see ms_sss__pair_area_scale */
    float follow;     /* share of the sine of elevation that follows the next pair outwards */
    float to_outer;   /* x over that pair's */
    float weight[3];  /* of each of the two taps */
} ms_sss__pair;

/* One term of a kernel in a view. "Scaled depth" is in units of the step at which weights vanish: mm / mm_per_depth. */
typedef struct ms_sss__pass {
    int pair_count;
    ms_sss__pair pair[MS_SSS_TAPS_MAX / 2];
    float center[3];          /* weight of the center tap */
    float total[3];           /* sum of the term's weights */
    int mixed[3];             /* 1: weights of both signs; missing weight then goes to the pixel's own light */
    float scale[3], delta[3]; /* result = delta E + sum over terms of scale term(E) */

    int perspective;
    float pixels_per_mm;      /* in perspective at scaled depth 1 */
    float pixels_per_mm_most; /* bound in perspective: the kernel's radius covers the picture */
    float pixels_per_mm_half; /* the kernel's radius is half a pixel: the identity; the full effect is at twice that */
    float depth_scale;        /* scaled depth of a scene unit */
    float mm_per_depth;       /* mm of scaled depth 1 */
    float average_dz;         /* scaled depth within which the shader's half resolution averages four pixels */
    float middle[2];          /* pixels, as in the view */
    float tangent; /* of the angle between the view axis and the ray a pixel away from it; 0: parallel rays */

    /* slopes */
    float focal[2];       /* slope = focal times the change of depth a pixel; in perspective relative to the depth */
    float edge_dz2;       /* square of a scaled depth: a larger step between two neighbors is an edge */
    float slope_scale;    /* 1 - flat */
    float rounding;       /* twice the relative error of a depth: a fitted plane is off by at most rounding (2 + i)
                             depth at a distance of i pixels */
    float elevation_4[3]; /* K / 4 of one pass */
    float root_r[3];      /* square root of the reflectance, bounded */
    float least_sine;     /* bound on sin(theta): 1 + K sin(theta) / 4 is 0 there, or -1 */
    float dz_falloff;     /* square of mm_per_depth, times slope_scale */
    float area_scale;     /* square root of slope_scale / 2; 0: weights of both signs */
    int reach_px[2];      /* parallel rays: pixels that taps reach along x and y */
} ms_sss__pass;

/* One row of a pass. Masked pixels have color 0 and MASKED_DEPTH. */
typedef struct ms_sss__line {
    const float *from[4];  /* red, green, blue, scaled depth of column 0 */
    ptrdiff_t stride;      /* floats from a row to the next: taps lie along y; 0: along x */
    int at, count;         /* along x: count columns; along y: row `at` of count rows */
    const float *plane[3]; /* with slopes, of the tangent plane: pixels per mm, gain of depth a pixel (relative in
                              perspective), cosine of the normal to the ray times mm_per_depth */
    int first, last;       /* columns to filter */
    float *to[3];
} ms_sss__line;

/* Which taps of a line are weighted by what. */
typedef enum ms_sss__weights {
    MS_SSS__BY_INTERPOLATION, /* no tap is masked or outside of the picture, and depth does not count */
    MS_SSS__BY_DEPTH,         /* by the difference of depth alone, which masks too */
    MS_SSS__BY_SURFACE        /* by distance from the tangent plane, area and elevation */
} ms_sss__weights;

/* Square of the radius of a level's gather, in pixels of the next level. Wider gathers measure the shape from nearer
   by, narrower ones cost less: 1.75 and 2.2 of six pixels, wide 2.24 and 3.74 of eight. A wider level 0 is
   nearer to random walks, but not on textures. */
#define MS_SSS__GATHER(wide, level) ((wide) ? ((level) > 0 ? 14.0f : 5.0f) : (level) > 0 ? 4.84f : 3.0625f)

/* A pixel of the next coarser level that a gather reads. */
typedef struct ms_sss__gather_tap {
    ptrdiff_t at;       /* floats from the middle of its four nearest */
    float x, y, square; /* position in pixels of that level, squared distance */
} ms_sss__gather_tap;

/* Parameters of the pyramid's row kernels. Depth enters as d, which is linear on planes: -1 / depth in perspective,
   else depth; 0 for masked pixels. Rows of a level: color, d, coverage (area of surface, in pixels of the level), the
   change of d a pixel along x and y. */
typedef struct ms_sss__pyramid_params {
    const float (*table)[MS_SSS_PYRAMID_LEVELS][2][3]; /* weight[size][level][blurred][channel] */
    int perspective, depth_aware;
    int wide;                            /* options.exact */
    int level;                           /* of the rows that gather writes */
    float radius_px, radius_px_most;     /* the kernel's radius: min(radius_px d, radius_px_most) */
    float step;                          /* change of d a pixel at slope 1; in perspective times d */
    float slope_scale;                   /* 1 - flat; 0: depth sets the size alone */
    float reach, merge_reach;            /* distance from a tangent plane at which weights reach 0, in radii: of sums on
                                            the way up, of pixels that are averaged on the way down */
    float middle[2], tangent;            /* as in ms_sss__pass */
    float elevation_4[3], max_factor[3]; /* K / 4; 1 / reflectance */
    const ms_sss__gather_tap (*tap)[2][64]; /* [odd row][odd column], the nearest first: four surround the pixel */
    int taps;                               /* of each of the four lists */
    int sums;                               /* whether the coarser level has sums */
    ptrdiff_t plane;                        /* floats from a plane of the coarser level to the next */
    float norm, mean, spread;               /* of the gather's taps: 1 / sum, E r / E r^2, E r^2 / E r^4 */
    float bend;                             /* half of E r^2 / E x^2, x along a row */
    float blur;                             /* variance of a position within a pixel of the next level */
    float rounding;                         /* twice the relative error of d */
    float plane_rounding;                   /* on planes the gather's taps are less than this off the tangent plane, in
                                               pixels of their level (orthographic: times d) */
} ms_sss__pyramid_params;

/* The kernels of one level of instructions; they stand below. */
typedef struct ms_sss__simd {
    int (*unpack)(const float *from, int count, float *const to[3]);
    void (*mask_by)(const float *value, float scale, int count, float *depth, int span[2]);
    int (*load_masked)(const float *const in[3], int begin, int end, int count, float *depth, float *const color[3]);
    void (*slopes)(const ms_sss__pass *p, const float *const depth[5], const float *const normal[3], int y, int begin,
                   int end, float *const slope[2]);
    void (*tangents)(const ms_sss__pass *p, const float *depth, const float *const slope[2], int y, int begin, int end,
                     float *const out[6]);
    void (*taps)(const ms_sss__pass *p, ms_sss__weights by, const ms_sss__line *line);
    void (*combine)(float a, const float *x, float b, const float *y, int count, float *out);
    void (*finish)(const ms_sss__pass *p, const float *strength, const float *depth, const float *const light[3],
                   const float *const *sum, int count, float *const blur[3]);
    void (*depth_to_d)(const ms_sss__pyramid_params *s, const float *depth, int count, float *d);
    void (*slopes_of_d)(const ms_sss__pyramid_params *s, const float *const d[5], const float *const normal[3], int y,
                        int first, int count, float *const out[3]);
    void (*downsample)(const ms_sss__pyramid_params *s, const float *row[4][7], int first, int count,
                       float *const out[7]);
    void (*gather)(const ms_sss__pyramid_params *s, const float *const own[3], const float *coarse, int first,
                   int count, int y, float *const out[6]);
    void (*resolve)(const ms_sss__pyramid_params *s, const float *const row[4], ptrdiff_t stride,
                    const float *const slope[3], const float *const sum[6], int first, int count, float *const out[4]);
} ms_sss__simd;

static MS_SSS__INLINE int ms_sss__clamp(int x, int low, int high) { return x < low ? low : x > high ? high : x; }

static MS_SSS__INLINE int ms_sss__lowest(unsigned bits)
{
#if defined(__GNUC__)
    return __builtin_ctz(bits);
#else
    int i = 0;
    while (!(bits >> i & 1u)) ++i;
    return i;
#endif
}

static MS_SSS__INLINE int ms_sss__highest(unsigned bits)
{
#if defined(__GNUC__)
    return 31 - __builtin_clz(bits);
#else
    int i = 0;
    while (bits >>= 1) ++i;
    return i;
#endif
}

/* A mask of the first n lanes. */
static MS_SSS__INLINE unsigned ms_sss__lanes(int n, int lanes)
{
    return n <= 0 ? 0u : (1u << (n < lanes ? n : lanes)) - 1u;
}

/* Sizes of a pyramid's table are 2^e (1 + m / 4), so their index is the float's top bits. */
static MS_SSS__INLINE int ms_sss__size_index(float size)
{
    int32_t bits;
    memcpy(&bits, &size, sizeof bits);
    return ms_sss__clamp((bits - 0x3f800000) >> 21, 0, MS_SSS_PYRAMID_SIZES - 2);
}

static MS_SSS__INLINE float ms_sss__index_size(int index)
{
    int32_t bits = 0x3f800000 + index * (1 << 21);
    float size;
    memcpy(&size, &bits, sizeof size);
    return size;
}

static const float ms_sss__iota[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

#if defined(MS__NEON)
static MS_SSS__INLINE unsigned ms_sss__bits_neon(uint32x4_t m)
{
    static const uint32_t bit[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(m, vld1q_u32(bit)));
}
#endif

#define MS_SSS__PASS 1 /* from here on an inclusion means: the kernels below, for one level */
#if defined(MS_SSS_WITH_SCALAR) || !(defined(MS__X64) || defined(MS__NEON))
#define MS_SSS__SCALAR 1
#define MS_SSS__LEVEL scalar
#define MS__N 1
#include MS_SSS_FILENAME
#endif
#if defined(MS__X64) || defined(MS__NEON)
#define MS_SSS__LEVEL base
#define MS__N 4
#include MS_SSS_FILENAME
#endif
#if defined(MS__X64)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define MS_SSS__LEVEL avx2
#define MS__N 8
#include MS_SSS_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx2,fma"))), \
                             apply_to = function)
#elif defined(__GNUC__)
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl,avx2,fma")
#endif
#define MS_SSS__LEVEL avx512
#define MS__N 16
#include MS_SSS_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#endif
#undef MS_SSS__PASS
#endif /* MS_SSS_IMPLEMENTATION */

#ifdef MS_SSS__PASS /* included once a level by the section above */
/* ---- filter kernels -------------------------------------------------------------------------------------------- */

/* Row kernels. Counts are multiples of 16. Rows may be read and written up to that; they are padded by MS_SSS__LEFT
   floats before and MS_SSS__RIGHT behind. A masked pixel has depth MS_SSS__MASKED_DEPTH and color 0. */

/* --- the vector words --- */

#define MS_SSS__JOIN_(name, level) ms_sss__##name##_##level
#define MS_SSS__JOIN(name, level) MS_SSS__JOIN_(name, level)
#define MS__F(name) MS_SSS__JOIN(name, MS_SSS__LEVEL)
#if defined(__GNUC__) && !defined(__clang__)
#define MS__UNROLL _Pragma("GCC unroll 8")
#else
#define MS__UNROLL
#endif

#if MS__N == 16
#define MS__V __m512
#define MS__X(name) _mm512_##name
#define MS__Z(name, ...) _mm512_maskz_##name(0xffff, __VA_ARGS__) /* GCC 12 warns about the plain ones in C++ */
#define MS__MASK __mmask16
#define MS__MADD(a, b, c) _mm512_fmadd_ps(a, b, c)
#define MS__NMADD(a, b, c) _mm512_fnmadd_ps(a, b, c) /* c - a b */
#define MS__RSQRT(a) _mm512_maskz_rsqrt14_ps(0xffff, a)
#define MS__ABS(a) _mm512_abs_ps(a)
#define MS__RCP(a) _mm512_maskz_rcp14_ps(0xffff, a)
#define MS__LESS(a, b) _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ)
#define MS__SAME(a, b) _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ)
#define MS__BOTH(m, n) ((__mmask16)((m) & (n)))
#define MS__SELECT(m, a, b) _mm512_mask_blend_ps(m, b, a)
#define MS__BITS(m) ((unsigned)(m))
#define MS__ZIP_LOW(a, b) \
    _mm512_permutex2var_ps(a, _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23), b)
#define MS__ZIP_HIGH(a, b) \
    _mm512_permutex2var_ps(a, _mm512_setr_epi32(8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31), b)
#define MS__ORDER(a) \
    _mm512_castpd_ps(_mm512_maskz_permutexvar_pd(0xff, _mm512_setr_epi64(0, 2, 4, 6, 1, 3, 5, 7), _mm512_castps_pd(a)))
#elif MS__N == 8
#define MS__V __m256
#define MS__X(name) _mm256_##name
#define MS__Z(name, ...) _mm256_##name(__VA_ARGS__)
#define MS__MASK __m256
#define MS__MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define MS__NMADD(a, b, c) _mm256_fnmadd_ps(a, b, c)
#define MS__RSQRT(a) _mm256_rsqrt_ps(a)
#define MS__RCP(a) _mm256_rcp_ps(a)
#define MS__ABS(a) _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a)
#define MS__LESS(a, b) _mm256_cmp_ps(a, b, _CMP_LT_OQ)
#define MS__SAME(a, b) _mm256_cmp_ps(a, b, _CMP_EQ_OQ)
#define MS__BOTH(m, n) _mm256_and_ps(m, n)
#define MS__SELECT(m, a, b) _mm256_blendv_ps(b, a, m)
#define MS__BITS(m) ((unsigned)_mm256_movemask_ps(m))
#define MS__ZIP_LOW(a, b) _mm256_permute2f128_ps(_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b), 0x20)
#define MS__ZIP_HIGH(a, b) _mm256_permute2f128_ps(_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b), 0x31)
#define MS__ORDER(a) _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(a), 0xd8))
#elif MS__N == 4 && defined(MS__X64)
#define MS__V __m128
#define MS__X(name) _mm_##name
#define MS__Z(name, ...) _mm_##name(__VA_ARGS__)
#define MS__MASK __m128
#define MS__MADD(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)
#define MS__NMADD(a, b, c) _mm_sub_ps(c, _mm_mul_ps(a, b))
#define MS__RSQRT(a) _mm_rsqrt_ps(a)
#define MS__RCP(a) _mm_rcp_ps(a)
#define MS__ABS(a) _mm_andnot_ps(_mm_set1_ps(-0.0f), a)
#define MS__LESS(a, b) _mm_cmplt_ps(a, b)
#define MS__SAME(a, b) _mm_cmpeq_ps(a, b)
#define MS__BOTH(m, n) _mm_and_ps(m, n)
#define MS__SELECT(m, a, b) _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b))
#define MS__BITS(m) ((unsigned)_mm_movemask_ps(m))
#define MS__ZIP_LOW(a, b) _mm_unpacklo_ps(a, b)
#define MS__ZIP_HIGH(a, b) _mm_unpackhi_ps(a, b)
#define MS__ORDER(a) (a)
#elif MS__N == 4
#define MS__V float32x4_t
#define MS__MASK uint32x4_t
#define MS__LOAD(p) vld1q_f32(p)
#define MS__STORE(p, a) vst1q_f32(p, a)
#define MS__SET(s) vdupq_n_f32(s)
#define MS__ADD(a, b) vaddq_f32(a, b)
#define MS__SUB(a, b) vsubq_f32(a, b)
#define MS__MUL(a, b) vmulq_f32(a, b)
#define MS__DIV(a, b) vdivq_f32(a, b)
#define MS__MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS__NMADD(a, b, c) vfmsq_f32(c, a, b)
#define MS__MIN(a, b) vminq_f32(a, b)
#define MS__MAX(a, b) vmaxq_f32(a, b)
#define MS__SQRT(a) vsqrtq_f32(a)
#define MS__ABS(a) vabsq_f32(a)
#define MS__LESS(a, b) vcltq_f32(a, b)
#define MS__SAME(a, b) vceqq_f32(a, b)
#define MS__BOTH(m, n) vandq_u32(m, n)
#define MS__SELECT(m, a, b) vbslq_f32(m, a, b)
#define MS__BITS(m) ms_sss__bits_neon(m)
#define MS__ZIP_LOW(a, b) vzip1q_f32(a, b)
#define MS__ZIP_HIGH(a, b) vzip2q_f32(a, b)
#define MS__EVENS(a, b) vuzp1q_f32(a, b)
#define MS__ODDS(a, b) vuzp2q_f32(a, b)
#define MS__ORDER(a) (a)
#else
#define MS__V float
#define MS__MASK int
#define MS__LOAD(p) (*(p))
#define MS__STORE(p, a) (*(p) = (a))
#define MS__SET(s) (s)
#define MS__ADD(a, b) ((a) + (b))
#define MS__SUB(a, b) ((a) - (b))
#define MS__MUL(a, b) ((a) * (b))
#define MS__DIV(a, b) ((a) / (b))
#define MS__MADD(a, b, c) ((a) * (b) + (c))
#define MS__NMADD(a, b, c) ((c) - (a) * (b))
#define MS__MIN(a, b) ((a) < (b) ? (a) : (b))
#define MS__MAX(a, b) ((a) > (b) ? (a) : (b))
#define MS__SQRT(a) sqrtf(a)
#define MS__ABS(a) fabsf(a)
#define MS__LESS(a, b) ((a) < (b))
#define MS__SAME(a, b) ((a) >= (b) && (a) <= (b))
#define MS__BOTH(m, n) ((m) & (n))
#define MS__SELECT(m, a, b) ((m) ? (a) : (b))
#define MS__BITS(m) ((unsigned)(m))
#define MS__ZIP_LOW(a, b) (a)
#define MS__ZIP_HIGH(a, b) (b)
#define MS__EVENS(a, b) (a)
#define MS__ODDS(a, b) (b)
#define MS__ORDER(a) (a)
#endif
#ifdef MS__X
#define MS__LOAD(p) MS__X(loadu_ps)(p)
#define MS__STORE(p, a) MS__X(storeu_ps)(p, a)
#define MS__SET(s) MS__X(set1_ps)(s)
#define MS__ADD(a, b) MS__X(add_ps)(a, b)
#define MS__SUB(a, b) MS__X(sub_ps)(a, b)
#define MS__MUL(a, b) MS__X(mul_ps)(a, b)
#define MS__DIV(a, b) MS__X(div_ps)(a, b)
#define MS__MIN(a, b) MS__Z(min_ps, a, b)
#define MS__MAX(a, b) MS__Z(max_ps, a, b)
#define MS__SQRT(a) MS__Z(sqrt_ps, a)
#define MS__EVENS(a, b) MS__Z(shuffle_ps, a, b, 0x88) /* columns 0, 2 ... of a and b; ORDER sorts them */
#define MS__ODDS(a, b) MS__Z(shuffle_ps, a, b, 0xdd)
#endif
#define MS__EVEN(a, b) MS__ORDER(MS__EVENS(a, b))
#define MS__ODD(a, b) MS__ORDER(MS__ODDS(a, b))

/* 1 / a to a few roundings; not where it is subnormal */
static MS_SSS__INLINE MS__V MS__F(inverse)(MS__V a)
{
#ifdef MS__RCP
    const MS__V r = MS__RCP(a);
    return MS__MUL(r, MS__NMADD(a, r, MS__SET(2.0f)));
#else
    return MS__DIV(MS__SET(1.0f), a);
#endif
}

/* 1 / sqrt(a) to a few roundings. */
static MS_SSS__INLINE MS__V MS__F(inverse_root)(MS__V a)
{
#ifdef MS__RSQRT
    const MS__V y = MS__RSQRT(a);
    return MS__MUL(y, MS__NMADD(MS__MUL(MS__MUL(a, MS__SET(0.5f)), y), y, MS__SET(1.5f)));
#else
    return MS__DIV(MS__SET(1.0f), MS__SQRT(a));
#endif
}

/* a b, rounded before anything is added: where depths are chosen by comparison, all levels must have the same bits. */
static MS_SSS__INLINE MS__V MS__F(product)(MS__V a, MS__V b)
{
    MS__V ab = MS__MUL(a, b);
#if defined(__GNUC__) && defined(MS__X64)
    __asm__("" : "+v"(ab)); /* else compilers fuse it with the addition */
#elif defined(__GNUC__) && defined(MS__NEON)
    __asm__("" : "+w"(ab));
#endif
    return ab;
}

static MS_SSS__INLINE MS__V MS__F(bound)(MS__V a, MS__V low, MS__V high) { return MS__MIN(MS__MAX(a, low), high); }

static MS_SSS__INLINE MS__MASK MS__F(unmasked)(MS__V depth)
{
    return MS__LESS(depth, MS__SET(MS_SSS__MASKED_DEPTH / 2));
}

/* The least and the largest of all lanes. */
static MS_SSS__INLINE void MS__F(extremes)(MS__V a, float *least, float *most)
{
#if MS__N == 1
    *least = *most = a;
#elif defined(MS__X64)
#if MS__N == 16
    const __m256 low = _mm512_maskz_extractf32x8_ps(0xff, a, 0), high = _mm512_maskz_extractf32x8_ps(0xff, a, 1);
    const __m256 l = _mm256_min_ps(low, high), m = _mm256_max_ps(low, high);
    __m128 u = _mm_min_ps(_mm256_castps256_ps128(l), _mm256_extractf128_ps(l, 1)),
           v = _mm_max_ps(_mm256_castps256_ps128(m), _mm256_extractf128_ps(m, 1));
#elif MS__N == 8
    const __m128 low = _mm256_castps256_ps128(a), high = _mm256_extractf128_ps(a, 1);
    __m128 u = _mm_min_ps(low, high), v = _mm_max_ps(low, high);
#else
    __m128 u = a, v = a;
#endif
    u = _mm_min_ps(u, _mm_movehl_ps(u, u));
    v = _mm_max_ps(v, _mm_movehl_ps(v, v));
    *least = _mm_cvtss_f32(_mm_min_ss(u, _mm_shuffle_ps(u, u, 1)));
    *most = _mm_cvtss_f32(_mm_max_ss(v, _mm_shuffle_ps(v, v, 1)));
#else
    *least = vminvq_f32(a);
    *most = vmaxvq_f32(a);
#endif
}

/* --- rows: masks, sums, the result --- */

/* Unpacks the color of RGBA pixels, without reading behind the last color; returns how many. */
static int MS__F(unpack)(const float *from, int count, float *const to[3])
{
    int i = 0;
#if MS__N > 1
    for (; i + MS__N < count; i += MS__N, from += 4 * MS__N) {
        const MS__V a = MS__LOAD(from), b = MS__LOAD(from + MS__N), c = MS__LOAD(from + 2 * MS__N),
                    d = MS__LOAD(from + 3 * MS__N);
        const MS__V red_blue[2] = {MS__EVEN(a, b), MS__EVEN(c, d)}, green[2] = {MS__ODD(a, b), MS__ODD(c, d)};
        MS__STORE(to[0] + i, MS__EVEN(red_blue[0], red_blue[1]));
        MS__STORE(to[1] + i, MS__EVEN(green[0], green[1]));
        MS__STORE(to[2] + i, MS__ODD(red_blue[0], red_blue[1]));
    }
#else
    (void)from, (void)count, (void)to;
#endif
    return i;
}

/* depth[i] = scale value[i] where depth[i] is unmasked so far, value[i] > 0 and the product is finite; else masked.
   span: from the first unmasked column to behind the last. */
static void MS__F(mask_by)(const float *value, float scale, int count, float *depth, int span[2])
{
    const MS__V zero = MS__SET(0.0f), masked = MS__SET(MS_SSS__MASKED_DEPTH), s = MS__SET(scale);
    int x, begin = -1, end = 0;
    for (x = 0; x < count; x += MS__N) {
        const MS__V v = MS__LOAD(value + x), z = MS__MUL(v, s);
        const MS__MASK sound = MS__BOTH(MS__LESS(zero, v), MS__F(unmasked)(z)); /* false for NaN */
        const MS__MASK valid = MS__BOTH(sound, MS__F(unmasked)(MS__LOAD(depth + x)));
        const unsigned bits = MS__BITS(valid);
        MS__STORE(depth + x, MS__SELECT(valid, z, masked));
        if (!bits) continue;
        if (begin < 0) begin = x + ms_sss__lowest(bits);
        end = x + ms_sss__highest(bits) + 1;
    }
    span[0] = begin < 0 ? 0 : begin;
    span[1] = end;
}

/* Loads color = in where depth is unmasked and the color is within LIGHT_MAX; else 0, and masks. Returns whether no
   pixel of [begin, end) is masked. */
static int MS__F(load_masked)(const float *const in[3], int begin, int end, int count, float *depth,
                              float *const color[3])
{
    const MS__V zero = MS__SET(0.0f), masked = MS__SET(MS_SSS__MASKED_DEPTH), most = MS__SET(MS_SSS__LIGHT_MAX);
    const unsigned full = ms_sss__lanes(MS__N, MS__N);
    int x, c, all = 1;
    for (x = 0; x < count; x += MS__N) {
        const MS__V z = MS__LOAD(depth + x);
        MS__V e[3];
        MS__MASK valid = MS__F(unmasked)(z);
        unsigned inside;
        MS__UNROLL
        for (c = 0; c < 3; ++c) {
            e[c] = MS__LOAD(in[c] + x);
            valid = MS__BOTH(valid, MS__LESS(MS__ABS(e[c]), most));
        }
        MS__UNROLL
        for (c = 0; c < 3; ++c) MS__STORE(color[c] + x, MS__SELECT(valid, e[c], zero));
        if (MS__BITS(valid) == full) continue;
        MS__STORE(depth + x, MS__SELECT(valid, z, masked));
        inside = ms_sss__lanes(end - x, MS__N) & ~ms_sss__lanes(begin - x, MS__N);
        if ((MS__BITS(valid) & inside) != inside) all = 0;
    }
    return all;
}

/* out = a x + b y */
static void MS__F(combine)(float a, const float *x, float b, const float *y, int count, float *out)
{
    int i;
    for (i = 0; i < count; i += MS__N)
        MS__STORE(out + i, MS__MADD(MS__SET(a), MS__LOAD(x + i), MS__MUL(MS__SET(b), MS__LOAD(y + i))));
}

/* The result: s (scale blur + delta light + sum) + (1 - s) light with s = min(strength, 1) fade, where fade goes from 0
   for kernels of half a pixel to 1 for those of a pixel. strength NULL: 1. sum NULL: one term. */
static void MS__F(finish)(const ms_sss__pass *p, const float *strength, const float *depth, const float *const light[3],
                          const float *const *sum, int count, float *const blur[3])
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), per_half = MS__SET(1 / p->pixels_per_mm_half);
    int x, c;
    for (x = 0; x < count; x += MS__N) {
        MS__V size = MS__SET(p->pixels_per_mm), s;
        if (p->perspective) size = MS__DIV(size, MS__LOAD(depth + x));
        s = MS__F(bound)(MS__SUB(MS__MUL(size, per_half), one), zero, one);
        if (strength) s = MS__MUL(s, MS__MIN(MS__LOAD(strength + x), one));
        MS__UNROLL
        for (c = 0; c < 3; ++c) {
            const MS__V e = MS__LOAD(light[c] + x);
            MS__V f = MS__MADD(MS__SET(p->scale[c]), MS__LOAD(blur[c] + x), MS__MUL(MS__SET(p->delta[c]), e));
            if (sum) f = MS__ADD(f, MS__LOAD(sum[c] + x));
            f = MS__MADD(s, f, MS__MUL(MS__SUB(one, s), e));
            MS__STORE(blur[c] + x, MS__SELECT(MS__LESS(zero, s), f, e));
        }
    }
}

/* --- the surface: slopes, tangent planes --- */

/* Pixels per mm at depth z on a surface that faces the camera. */
static MS_SSS__INLINE MS__V MS__F(pixels_per_mm)(const ms_sss__pass *p, MS__V z)
{
    return p->perspective ? MS__MIN(MS__DIV(MS__SET(p->pixels_per_mm), z), MS__SET(p->pixels_per_mm_most))
                          : MS__SET(p->pixels_per_mm);
}

/* Tangents along x of the rays through the pixels from column x on. */
static MS_SSS__INLINE MS__V MS__F(ray)(const ms_sss__pass *p, int x)
{
    return MS__MUL(MS__ADD(MS__LOAD(ms_sss__iota), MS__SET((float)x + 0.5f - p->middle[0])), MS__SET(p->tangent));
}

/* Pixels per mm of the tangent plane along an axis with this slope and ray; cross: the ray along the other axis. */
static MS_SSS__INLINE MS__V MS__F(foreshorten)(MS__V size, MS__V along, MS__V ray, MS__V cross)
{
    const MS__V x = MS__ADD(MS__F(product)(along, ray), MS__SET(1.0f)), y = MS__MUL(along, cross);
    const MS__V xy = MS__ADD(MS__F(product)(x, x), MS__F(product)(y, y));
    return MS__DIV(size, MS__SQRT(MS__ADD(xy, MS__F(product)(along, along))));
}

/* The area of the surface over that of its picture: the length of (slope, 1 + slope . ray). */
static MS_SSS__INLINE MS__V MS__F(area)(MS__V sx, MS__V sy, MS__V rx, MS__V ry)
{
    const MS__V n = MS__ADD(MS__F(product)(sx, rx), MS__ADD(MS__F(product)(sy, ry), MS__SET(1.0f)));
    return MS__SQRT(MS__ADD(MS__F(product)(sx, sx), MS__ADD(MS__F(product)(sy, sy), MS__F(product)(n, n))));
}

/* Cosine of the normal to the ray, for slopes sx and sy, times mm_per_depth. */
static MS_SSS__INLINE MS__V MS__F(facing)(const ms_sss__pass *p, MS__V sx, MS__V sy, MS__V rx, MS__V ry)
{
    return MS__DIV(MS__SET(p->mm_per_depth), MS__F(area)(sx, sy, rx, ry));
}

/* The slope along an axis from those on both sides, a and b, which count where on_a and on_b (their steps in depth are
   within the kernel's radius). Where the surface bends little it is the mean of both, else the smaller one, so that no
   slope is taken across an edge or a crease. Near a silhouette depth falls like sqrt(distance), so that a one-sided
   difference underestimates the slope: it is extrapolated by the ratio of the last two steps (at most 1.85 times) where
   their difference is more than rounding. Planes are unchanged.
   at: depths of the pixel and of two neighbors on each side. inverse: their reciprocals are linear on planes. */
static MS_SSS__INLINE MS__V MS__F(slope)(MS__V a, MS__V b, MS__MASK on_a, MS__MASK on_b, const MS__V at[5],
                                         const int inverse, float rounding)
{
    const MS__V zero = MS__SET(0.0f), half = MS__SET(0.5f), one = MS__SET(1.0f), limit = MS__SET(8.0f);
    MS__V s;
    MS__MASK even;
    a = MS__SELECT(on_a, a, MS__SELECT(on_b, b, zero));
    b = MS__SELECT(on_b, b, a);
    s = MS__MUL(half, MS__ADD(a, b));
    even = MS__LESS(MS__ABS(MS__SUB(a, b)), MS__MUL(half, MS__ADD(MS__F(product)(a, b), one)));
    even = MS__BOTH(even, MS__BOTH(on_a, on_b));
    if (MS__BITS(even) != ms_sss__lanes(MS__N, MS__N)) {
        const MS__MASK first_a = MS__LESS(MS__ABS(a), MS__ABS(b)), first_b = MS__LESS(MS__ABS(b), MS__ABS(a));
        const MS__V is_a = MS__SELECT(on_b, MS__SELECT(first_a, one, zero), one),
                    less = MS__SELECT(first_a, a, MS__SELECT(first_b, b, s));
        const MS__MASK before = MS__LESS(half, is_a);
        const MS__V own = at[2], next = MS__SELECT(before, at[1], at[3]), after_next = MS__SELECT(before, at[0], at[4]);
        MS__V step = MS__SUB(own, next), inner = MS__SUB(next, after_next),
              least = MS__F(product)(MS__ABS(own), MS__SET(2 * rounding)), more, excess;
        if (inverse) { /* differences of the inverses, times all three */
            step = MS__F(product)(step, after_next);
            inner = MS__F(product)(inner, own);
            least = MS__F(product)(least, own);
        }
        excess = MS__SUB(MS__MIN(MS__ABS(inner), MS__SUB(MS__ABS(step), MS__ABS(inner))), least); /* NaN stays */
        more = MS__MIN(MS__DIV(excess, MS__ABS(inner)), MS__SET(0.85f));
        more = MS__SELECT(MS__BOTH(MS__LESS(zero, excess), MS__LESS(MS__ABS(MS__SUB(step, inner)), MS__ABS(step))),
                          more, zero); /* the same direction */
        excess = MS__ADD(MS__F(product)(MS__MUL(more, more), MS__SET(0.7f)), half);
        more = MS__MUL(more, MS__ADD(MS__F(product)(more, excess), half));
        s = MS__SELECT(even, s, MS__ADD(MS__F(product)(less, more), less));
    }
    return MS__MIN(MS__MAX(s, MS__SUB(zero, limit)), limit);
}

/* Slopes from the normals at column x, of at most 8, those that face away too; 0 where they are not finite or 0. */
static MS_SSS__INLINE void MS__F(slopes_of_normals)(const float *const normal[3], int x, MS__V rx, MS__V ry, MS__V *sx,
                                                    MS__V *sy)
{
    const MS__V zero = MS__SET(0.0f), a = MS__LOAD(normal[0] + x), b = MS__LOAD(normal[1] + x),
                c = MS__LOAD(normal[2] + x), eighth = MS__MUL(MS__MAX(MS__ABS(a), MS__ABS(b)), MS__SET(0.125f));
    const MS__V facing = MS__MAX(MS__SUB(c, MS__ADD(MS__F(product)(rx, a), MS__F(product)(ry, b))), eighth);
    const MS__MASK sound = MS__BOTH(MS__LESS(zero, facing),
                                    MS__LESS(MS__ABS(MS__ADD(a, MS__ADD(b, c))), MS__SET(INFINITY)));
    *sx = MS__SELECT(sound, MS__DIV(a, facing), zero);
    *sy = MS__SELECT(sound, MS__DIV(b, facing), zero);
}

/* Slopes of row y, columns [begin, end), from the depths of rows y - 2 to y + 2, or from normals. Vectors of
   masked pixels alone are left out, as by tangents. */
static void MS__F(slopes)(const ms_sss__pass *p, const float *const depth[5], const float *const normal[3], int y,
                          int begin, int end, float *const slope[2])
{
    const MS__V zero = MS__SET(0.0f), edge = MS__SET(p->edge_dz2), scale = MS__SET(p->slope_scale),
                ry = MS__SET(((float)y + 0.5f - p->middle[1]) * p->tangent);
    int x, i, axis;
    for (x = begin; x < end; x += MS__N) {
        const MS__V z = MS__LOAD(depth[2] + x);
        const MS__MASK valid = MS__F(unmasked)(z);
        MS__V s[2];
        if (!MS__BITS(valid)) continue;
        if (normal) MS__F(slopes_of_normals)(normal, x, MS__F(ray)(p, x), ry, &s[0], &s[1]);
        for (axis = 0; axis < 2 && !normal; ++axis) {
            const MS__V f = MS__SET(p->focal[axis]);
            MS__V at[5], a, b;
            MS__MASK on_a, on_b;
            for (i = 0; i < 5; ++i) at[i] = MS__LOAD(axis ? depth[i] + x : depth[2] + x + i - 2);
            a = MS__SUB(z, at[1]);
            b = MS__SUB(at[3], z);
            on_a = MS__LESS(MS__MUL(a, a), edge);
            on_b = MS__LESS(MS__MUL(b, b), edge);
            a = MS__MUL(f, p->perspective ? MS__DIV(a, at[1]) : a);
            b = MS__MUL(f, p->perspective ? MS__DIV(b, at[3]) : b);
            s[axis] = MS__F(slope)(a, b, on_a, on_b, at, p->perspective, p->rounding);
        }
        for (axis = 0; axis < 2; ++axis)
            MS__STORE(slope[axis] + x,
                      MS__SELECT(MS__BOTH(valid, MS__LESS(MS__ABS(s[axis]), MS__SET(INFINITY))),
                                 MS__MUL(s[axis], scale), zero));
    }
}

/* The tangent planes of row y, see ms_sss__line.plane: out[0 to 2] along x, out[3 to 5] along y. */
static void MS__F(tangents)(const ms_sss__pass *p, const float *depth, const float *const slope[2], int y, int begin,
                            int end, float *const out[6])
{
    const MS__V ry = MS__SET(((float)y + 0.5f - p->middle[1]) * p->tangent);
    int x;
    for (x = begin; x < end; x += MS__N) {
        const MS__V z = MS__LOAD(depth + x), size = MS__F(pixels_per_mm)(p, z), sx = MS__LOAD(slope[0] + x),
                    sy = MS__LOAD(slope[1] + x);
        const MS__V rx = MS__F(ray)(p, x), facing = MS__F(facing)(p, sx, sy, rx, ry);
        if (!MS__BITS(MS__F(unmasked)(z))) continue;
        MS__STORE(out[0] + x, MS__F(foreshorten)(size, sx, rx, ry));
        MS__STORE(out[1] + x, MS__MUL(sx, MS__SET(1 / p->focal[0])));
        MS__STORE(out[2] + x, facing);
        MS__STORE(out[3] + x, MS__F(foreshorten)(size, sy, ry, rx));
        MS__STORE(out[4] + x, MS__MUL(sy, MS__SET(1 / p->focal[1])));
        MS__STORE(out[5] + x, facing);
    }
}

/* --- taps --- */

/* Renormalizes a tap sum s whose weights add up to n: to the sum `total`, or, if mixed, by adding light for the missing
   weight. */
static MS_SSS__INLINE MS__V MS__F(renormalize)(MS__V s, MS__V n, MS__V light, float total, int mixed)
{
    if (mixed) return MS__MADD(light, MS__SUB(MS__SET(total), n), s);
    return MS__MUL(MS__SELECT(MS__LESS(MS__SET(1e-30f), n), MS__DIV(s, n), light), MS__SET(total));
}

/* (1 - dz^2)^4 for |dz| < 1, else 0 */
static MS_SSS__INLINE MS__V MS__F(falloff)(MS__V dz)
{
    MS__V f = MS__MAX(MS__NMADD(dz, dz, MS__SET(1.0f)), MS__SET(0.0f));
    f = MS__MUL(f, f);
    return MS__MUL(f, f);
}

/* share (1 - dz^2) / (1 + dz_falloff dz^2) for a pixel dz off the tangent plane, else 0 */
static MS_SSS__INLINE MS__V MS__F(plane_falloff)(MS__V share, MS__V dz, MS__V dz_falloff)
{
    const MS__V one = MS__SET(1.0f), q = MS__MIN(MS__MUL(dz, dz), one); /* of masked pixels dz^2 may be infinite */
    return MS__MUL(MS__NMADD(share, q, share), MS__F(inverse)(MS__MADD(dz_falloff, q, one)));
}

/* depth less the bound on its rounding, towards 0. */
static MS_SSS__INLINE MS__V MS__F(residual)(MS__V depth, MS__V rounding)
{
    return MS__SUB(depth, MS__F(bound)(depth, MS__SUB(MS__SET(0.0f), rounding), rounding));
}

/* (1 + K sin(theta) / 4)^4 */
static MS_SSS__INLINE MS__V MS__F(elevate)(float elevation_4, MS__V sine)
{
    MS__V u = MS__MADD(MS__SET(elevation_4), sine, MS__SET(1.0f));
    u = MS__MUL(u, u);
    return MS__MUL(u, u);
}

/* A tap by surface, to be added once the next one inwards is known. */
typedef struct MS__F(tap) {
    MS__V weight, light[3];
    MS__V sine;   /* weight times sin(theta) */
    MS__V height; /* mm under the tangent plane */
} MS__F(tap);

/* A group of lanes of a pass, with sums over its taps of light, weights, and weights times elevation. */
typedef struct MS__F(group) {
    MS__V light[3], weight[3], elevated[3];
    MS__F(tap) outer[2]; /* by surface: of the pair before, which is further out */
    float least, most;   /* pixels per mm of the active lanes */
} MS__F(group);

/* What a pair of taps finds: weights, weights times depth under the tangent plane, light; of both sides or, by depth
   alone, of both together in [0]. */
typedef struct MS__F(found) {
    MS__V weight[2], below[2], light[2][3];
} MS__F(found);

static MS_SSS__INLINE MS__MASK MS__F(active)(const ms_sss__pass *p, MS__V z)
{
    const MS__V half = MS__SET(p->pixels_per_mm_half);
    return MS__BOTH(MS__F(unmasked)(z), MS__LESS(p->perspective ? MS__MUL(half, z) : half, MS__SET(p->pixels_per_mm)));
}

/* Pixels per mm along the line's axis. */
static MS_SSS__INLINE MS__V MS__F(size)(const ms_sss__pass *p, const ms_sss__weights by, const ms_sss__line *l, int x)
{
    return by == MS_SSS__BY_SURFACE ? MS__LOAD(l->plane[0] + x) : MS__F(pixels_per_mm)(p, MS__LOAD(l->from[3] + x));
}

/* 0: no lane is unmasked and has a kernel of more than half a pixel. */
static MS_SSS__INLINE int MS__F(begin_group)(const ms_sss__pass *p, const ms_sss__weights by, const ms_sss__line *l,
                                             int x, MS__F(group) * g)
{
    const MS__V zero = MS__SET(0.0f), size = MS__F(size)(p, by, l, x);
    const MS__MASK active = MS__F(active)(p, MS__LOAD(l->from[3] + x));
    float unused;
    int c;
    if (!MS__BITS(active)) return 0;
    g->least = g->most = p->pixels_per_mm;
    if (p->perspective || by == MS_SSS__BY_SURFACE) {
        MS__F(extremes)(MS__SELECT(active, size, MS__SET(INFINITY)), &g->least, &unused);
        MS__F(extremes)(MS__SELECT(active, size, zero), &unused, &g->most);
    }
    MS__UNROLL
    for (c = 0; c < 3; ++c) {
        g->weight[c] = g->elevated[c] = g->light[c] = zero;
        g->outer[0].light[c] = g->outer[1].light[c] = zero;
    }
    MS__UNROLL
    for (c = 0; c < 2; ++c) g->outer[c].weight = g->outer[c].sine = g->outer[c].height = zero;
    return 1;
}

/* Interpolates a pair of taps for all lanes at once: of a tap t pixels away, a pixel j steps away has the share
   max(0, 1 - |t - j|), for j from the least to the largest t of the lanes. */
static MS_SSS__INLINE void MS__F(read_pair)(const ms_sss__pass *p, const ms_sss__weights by, const ms_sss__line *l,
                                            const ms_sss__pair *pair, const MS__F(group) * g, int x,
                                            MS__F(found) * found)
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), z = MS__LOAD(l->from[3] + x);
    const float offset = pair->offset[l->stride != 0], least = g->least * offset, most = g->most * offset;
    const int low = least < (float)MS_SSS__FAR ? (int)least : (int)MS_SSS__FAR,
              high = most < (float)MS_SSS__FAR ? (int)most + 1 : (int)MS_SSS__FAR;
    const MS__V t = MS__F(product)(MS__F(size)(p, by, l, x), MS__SET(offset));
    /* the rows and columns just beyond the picture are empty: floats to them */
    const ptrdiff_t step = l->stride ? l->stride : 1, before = (l->stride ? l->at + 1 : x + MS__N) * step,
                    behind = (l->stride ? l->count - l->at : l->count - x) * step;
    const MS__V gain = by == MS_SSS__BY_SURFACE ? MS__LOAD(l->plane[1] + x) : zero;
    ptrdiff_t away = low * step;
    int j, side, c;
    MS__UNROLL
    for (side = 0; side < 2; ++side) {
        found->weight[side] = found->below[side] = zero;
        for (c = 0; c < 3; ++c) found->light[side][c] = zero;
    }
    for (j = low; j <= high; ++j, away += step) {
        const MS__V steps = MS__SET((float)j), share = MS__MAX(MS__SUB(one, MS__ABS(MS__SUB(t, steps))), zero);
        if (high > low + 2 && !MS__BITS(MS__LESS(zero, share))) continue; /* between the lanes' positions */
        MS__UNROLL
        for (side = 0; side < 2; ++side) {
            const int to = by == MS_SSS__BY_SURFACE ? side : 0;
            const ptrdiff_t at = side ? x + (away < behind ? away : behind) : x - (away < before ? away : before);
            MS__V f = share;
            if (by == MS_SSS__BY_DEPTH) f = MS__MUL(f, MS__F(falloff)(MS__SUB(MS__LOAD(l->from[3] + at), z)));
            if (by == MS_SSS__BY_SURFACE) { /* dz from the tangent plane, which rises on one side */
                const MS__V there = MS__LOAD(l->from[3] + at), up = MS__MUL(gain, steps),
                            scale = p->perspective ? there : one;
                MS__V dz = MS__SUB(there, z);
                dz = side ? MS__NMADD(up, scale, dz) : MS__MADD(up, scale, dz);
                f = MS__F(plane_falloff)(f, dz, MS__SET(pair->dz_falloff));
                found->below[side] = MS__MADD(f, dz, found->below[side]);
            }
            found->weight[to] = MS__ADD(found->weight[to], f);
            MS__UNROLL
            for (c = 0; c < 3; ++c) found->light[to][c] = MS__MADD(f, MS__LOAD(l->from[c] + at), found->light[to][c]);
        }
    }
}

/* Adds a tap by surface. It represents the area 1 + (area_scale times the change of height from the next tap in)^2,
   where the surface bends away from the tangent plane; light is multiplied by its elevation. */
static MS_SSS__INLINE void MS__F(add_tap)(const ms_sss__pass *p, const ms_sss__pair *pair, const MS__F(tap) * tap,
                                          MS__V inner_height, MS__F(group) * g)
{
    const MS__V one = MS__SET(1.0f), sine = MS__F(bound)(tap->sine, MS__SET(p->least_sine), one);
    const MS__V bend = MS__MUL(MS__SUB(tap->height, inner_height), MS__SET(pair->area_scale));
    const MS__V area = MS__MIN(MS__MADD(bend, bend, one), MS__SET(MS_SSS__AREA_MAX));
    int c;
    MS__UNROLL
    for (c = 0; c < 3; ++c) {
        const MS__V weight = MS__MUL(MS__SET(pair->weight[c]), area),
                    lifted = MS__MUL(weight, MS__F(elevate)(p->elevation_4[c], sine));
        g->weight[c] = MS__MADD(weight, tap->weight, g->weight[c]);
        g->elevated[c] = MS__MADD(lifted, tap->weight, g->elevated[c]);
        g->light[c] = MS__MADD(lifted, tap->light[c], g->light[c]);
    }
}

/* Takes a pair by surface, from the outside inwards, and adds the one before; after the innermost that as well. Near
   taps follow the elevation of the next ones outwards, as far as those were found: see MS_SSS__NEAR. */
static MS_SSS__INLINE void MS__F(add_on_surface)(const ms_sss__pass *p, const ms_sss__line *l, const ms_sss__pair *pair,
                                                 const MS__F(found) * found, int x, MS__F(group) * g)
{
    const MS__V t = MS__MUL(MS__LOAD(l->plane[0] + x), MS__SET(pair->offset[l->stride != 0])),
                facing = MS__LOAD(l->plane[2] + x),
                rounding = MS__MUL(MS__MUL(MS__LOAD(l->from[3] + x), MS__SET(p->rounding)), MS__ADD(t, MS__SET(2.0f)));
    int side, c;
    MS__UNROLL
    for (side = 0; side < 2; ++side) {
        const MS__V weight = found->weight[side],
                    below = MS__MUL(facing, MS__F(residual)(found->below[side], rounding)), /* mm */
            height = MS__MUL(below, MS__F(inverse)(MS__ADD(weight, MS__SET(MS_SSS__SPARSE))));
        MS__F(tap) *tap = &g->outer[side];
        const MS__V own = MS__MUL(below, MS__SET(pair->per_mm)),
                    outer = MS__MUL(MS__MUL(tap->sine, weight), MS__SET(pair->to_outer)),
                    whole2 = MS__MUL(tap->weight, tap->weight),
                    share = MS__MUL(MS__MUL(whole2, whole2), MS__SET(pair->follow));
        if (pair != &p->pair[p->pair_count - 1]) MS__F(add_tap)(p, pair + 1, tap, height, g);
        tap->sine = MS__MADD(share, MS__SUB(outer, own), own);
        tap->height = height;
        tap->weight = weight;
        MS__UNROLL
        for (c = 0; c < 3; ++c) tap->light[c] = found->light[side][c];
        if (pair == p->pair) MS__F(add_tap)(p, pair, tap, MS__SET(0.0f), g);
    }
}

static MS_SSS__INLINE void MS__F(add_pair)(const ms_sss__pair *pair, const MS__F(found) * found, MS__F(group) * g)
{
    int c;
    MS__UNROLL
    for (c = 0; c < 3; ++c) {
        const MS__V w = MS__SET(pair->weight[c]);
        g->weight[c] = MS__MADD(w, found->weight[0], g->weight[c]);
        g->light[c] = MS__MADD(w, found->light[0][c], g->light[c]);
    }
}

static MS_SSS__INLINE void MS__F(end_group)(const ms_sss__pass *p, const ms_sss__weights by, const ms_sss__line *l,
                                            int x, const MS__F(group) * g)
{
    const MS__MASK active = MS__F(active)(p, MS__LOAD(l->from[3] + x));
    int c;
    MS__UNROLL
    for (c = 0; c < 3; ++c) {
        const MS__V light = MS__LOAD(l->from[c] + x);
        const MS__V center = MS__SET(p->center[c]), sum = MS__MADD(light, center, g->light[c]);
        MS__V norm = MS__ADD(g->weight[c], center), result;
        if (by == MS_SSS__BY_SURFACE && !p->mixed[c]) /* a pass multiplies the mean by reflectance^(-1/2) at most */
            norm = MS__MAX(norm, MS__MUL(MS__ADD(g->elevated[c], center), MS__SET(p->root_r[c])));
        result = MS__F(renormalize)(sum, norm, light, p->total[c], p->mixed[c]);
        MS__STORE(l->to[c] + x, MS__SELECT(active, result, MS__MUL(light, MS__SET(p->total[c]))));
    }
}

/* One pass of a row. */
static MS_SSS__INLINE void MS__F(taps_row)(const ms_sss__pass *p, const ms_sss__weights by, const ms_sss__line *l)
{
    int x, k;
    for (x = l->first; x < l->last; x += MS__N) {
        MS__F(group) group;
        if (!MS__F(begin_group)(p, by, l, x, &group)) {
            for (k = 0; k < 3; ++k) MS__STORE(l->to[k] + x, MS__MUL(MS__LOAD(l->from[k] + x), MS__SET(p->total[k])));
            continue;
        }
        for (k = p->pair_count; k-- > 0;) { /* the smallest weights come first */
            const ms_sss__pair *pair = &p->pair[k];
            MS__F(found) found;
            MS__F(read_pair)(p, by, l, pair, &group, x, &found);
            if (by == MS_SSS__BY_SURFACE) MS__F(add_on_surface)(p, l, pair, &found, x, &group);
            else MS__F(add_pair)(pair, &found, &group);
        }
        MS__F(end_group)(p, by, l, x, &group);
    }
}

static void MS__F(taps)(const ms_sss__pass *p, ms_sss__weights by, const ms_sss__line *l)
{
    if (by == MS_SSS__BY_SURFACE) MS__F(taps_row)(p, MS_SSS__BY_SURFACE, l);
    else if (by == MS_SSS__BY_DEPTH) MS__F(taps_row)(p, MS_SSS__BY_DEPTH, l);
    else MS__F(taps_row)(p, MS_SSS__BY_INTERPOLATION, l);
}

/* ---- pyramid kernels ------------------------------------------------------------------------------------------- */

/* d from depth; 0 for masked pixels alone: a depth that underflows counts as FLT_MIN. */
static void MS__F(depth_to_d)(const ms_sss__pyramid_params *s, const float *depth, int count, float *d)
{
    const MS__V zero = MS__SET(0.0f);
    int i;
    for (i = 0; i < count; i += MS__N) {
        const MS__V z = MS__MAX(MS__LOAD(depth + i), MS__SET(FLT_MIN));
        const MS__V value = s->perspective ? MS__DIV(MS__SET(-1.0f), z) : s->depth_aware ? z : MS__SET(1.0f);
        MS__STORE(d + i, MS__SELECT(MS__F(unmasked)(z), value, zero));
    }
}

/* Depth in pixels of a step of d. */
static MS_SSS__INLINE MS__V MS__F(pixels_per_d)(const ms_sss__pyramid_params *s, MS__V d)
{
    const MS__V scale = MS__SET((s->perspective ? -1.0f : 1.0f) / s->step);
    if (!s->depth_aware) return MS__SET(0.0f);
    return s->perspective ? MS__DIV(scale, d) : scale;
}

/* Radius of the kernel in pixels on a surface that faces the camera. */
static MS_SSS__INLINE MS__V MS__F(radius)(const ms_sss__pyramid_params *s, MS__V d)
{
    return MS__MIN(s->perspective ? MS__MUL(MS__SET(-s->radius_px), d) : MS__SET(s->radius_px),
                   MS__SET(s->radius_px_most));
}

/* Coverage and changes of d of row y of the picture; d: rows y - 2 to y + 2; normal: the caller's or NULL. */
static void MS__F(slopes_of_d)(const ms_sss__pyramid_params *s, const float *const d[5], const float *const normal[3],
                               int y, int first, int count, float *const out[3])
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), scale = MS__SET(s->slope_scale);
    const MS__V ry = MS__SET(((float)y + 0.5f - s->middle[1]) * s->tangent);
    int i, k, axis;
    for (i = first; i < count; i += MS__N) {
        const MS__V own = MS__LOAD(d[2] + i);
        const MS__MASK valid = MS__LESS(zero, MS__ABS(own));
        const MS__V safe = MS__SELECT(valid, own, MS__SET(-1.0f));
        const MS__V pixels_per_d = MS__F(pixels_per_d)(s, safe), radius = MS__F(radius)(s, safe);
        const MS__V rx = MS__MUL(MS__ADD(MS__LOAD(ms_sss__iota), MS__SET((float)i + 0.5f - s->middle[0])),
                                 MS__SET(s->tangent));
        MS__V slope[2], step;
        if (!(s->slope_scale > 0) || !MS__BITS(valid)) {
            MS__STORE(out[0] + i, MS__SELECT(valid, one, zero));
            MS__STORE(out[1] + i, zero);
            MS__STORE(out[2] + i, zero);
            continue;
        }
        if (normal) MS__F(slopes_of_normals)(normal, i, rx, ry, &slope[0], &slope[1]);
        for (axis = 0; axis < 2 && !normal; ++axis) {
            MS__V at[5], a, b;
            for (k = 0; k < 5; ++k) at[k] = MS__LOAD(axis ? d[k] + i : d[2] + i + k - 2);
            a = MS__MUL(MS__SUB(own, at[1]), pixels_per_d);
            b = MS__MUL(MS__SUB(at[3], own), pixels_per_d);
            slope[axis] = MS__F(slope)(a, b, MS__BOTH(MS__LESS(MS__ABS(a), radius), MS__LESS(zero, MS__ABS(at[1]))),
                                       MS__BOTH(MS__LESS(MS__ABS(b), radius), MS__LESS(zero, MS__ABS(at[3]))), at, 0,
                                       s->rounding);
        }
        for (axis = 0; axis < 2; ++axis) slope[axis] = MS__MUL(slope[axis], scale);
        step = s->perspective ? MS__MUL(safe, MS__SET(-s->step)) : MS__SET(s->step);
        MS__STORE(out[0] + i,
                  MS__SELECT(valid, MS__MIN(MS__F(area)(slope[0], slope[1], rx, ry), MS__SET(10.0f)), zero));
        MS__STORE(out[1] + i, MS__SELECT(valid, MS__MUL(slope[0], step), zero));
        MS__STORE(out[2] + i, MS__SELECT(valid, MS__MUL(slope[1], step), zero));
    }
}

/* --- down: four pixels to one --- */

/* Where a pixel of the coarser level lies on its surface: that of the nearest of its middle four pixels. */
typedef struct MS__F(anchor) {
    MS__V d, change[2]; /* d at the middle of the four, its changes a pixel */
    MS__V nearest;      /* d of the nearest pixel */
    MS__V per_radius;   /* 1 / the kernel's radius, in d */
    MS__MASK some;      /* lanes that have a pixel at all */
} MS__F(anchor);

/* The nearest of the middle four that has a quarter of the largest coverage. row: as in downsample_row. */
static MS_SSS__INLINE MS__F(anchor) MS__F(find_anchor)(const ms_sss__pyramid_params *s, const float *row[4][7], int i)
{
    const MS__V zero = MS__SET(0.0f);
    MS__V most = zero, bx = zero, by = zero, middle[2][2], coverage[2][2];
    MS__F(anchor) a;
    int x, y, c;
    MS__UNROLL
    for (y = 0; y < 2; ++y) {
        const float *z = row[y + 1][3] + 2 * i, *w = row[y + 1][4] + 2 * i;
        const MS__V z0 = MS__LOAD(z), z1 = MS__LOAD(z + MS__N), w0 = MS__LOAD(w), w1 = MS__LOAD(w + MS__N);
        middle[y][0] = MS__EVENS(z0, z1);
        middle[y][1] = MS__ODDS(z0, z1);
        coverage[y][0] = MS__EVENS(w0, w1);
        coverage[y][1] = MS__ODDS(w0, w1);
        most = MS__MAX(most, MS__MAX(coverage[y][0], coverage[y][1]));
    }
    a.some = MS__LESS(zero, most);
    a.d = MS__SET(INFINITY);
    a.change[0] = a.change[1] = zero;
    most = MS__MUL(most, MS__SET(0.25f));
    for (y = 0; y < 2; ++y)
        for (x = 0; x < 2; ++x) {
            const MS__MASK better = MS__BOTH(MS__LESS(most, coverage[y][x]), MS__LESS(middle[y][x], a.d));
            a.d = MS__SELECT(better, middle[y][x], a.d);
            for (c = 0; c < 2; ++c) {
                const float *change = row[y + 1][5 + c] + 2 * i;
                const MS__V u = MS__LOAD(change), v = MS__LOAD(change + MS__N);
                a.change[c] = MS__SELECT(better, x ? MS__ODDS(u, v) : MS__EVENS(u, v), a.change[c]);
            }
            bx = MS__SELECT(better, MS__SET((float)x - 0.5f), bx);
            by = MS__SELECT(better, MS__SET((float)y - 0.5f), by);
        }
    a.d = a.nearest = MS__SELECT(a.some, a.d, MS__SET(-1.0f));
    a.per_radius = MS__DIV(MS__F(pixels_per_d)(s, a.d), MS__F(radius)(s, a.d));
    a.d = MS__SUB(a.d, MS__ADD(MS__F(product)(bx, a.change[0]), MS__F(product)(by, a.change[1])));
    return a;
}

/* Sums of a pixel of the coarser level over the pixels that belong to it. */
typedef struct MS__F(merged) {
    MS__V color[3], d, n;  /* weighted sums, sum of the weights */
    MS__V dx, dy, seen;    /* sums by picture area, its sum */
    MS__V least, greatest; /* d of the pixels */
} MS__F(merged);

/* Adds columns 2i - 1 + 2 half and the next of row y (0 to 3). Weights are (1, 3, 3, 1) / 8 both ways for pixels near
   the tangent plane of the anchor: fourth powers of root[] (1 - (off / merge_reach radii)^2), by the number of near
   sides. */
static MS_SSS__INLINE void MS__F(merge_columns)(const MS__F(anchor) * a, const MS__V narrow[3], const float *row[7],
                                                int y, int half, int i, MS__F(merged) * sum)
{
    static const float root[3] = {0.353553391f, 0.465302426f, 0.612372436f}; /* fourth roots of 1, 3, 9 over 64 */
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), down = MS__SET((float)y - 1.5f);
    const ptrdiff_t at = 2 * i - 1 + 2 * half;
    MS__V v[7][2], f[2], g[2];
    int x, c;
    MS__UNROLL
    for (c = 0; c < 7; ++c) {
        const MS__V first = MS__LOAD(row[c] + at), second = MS__LOAD(row[c] + at + MS__N);
        v[c][0] = MS__EVENS(first, second);
        v[c][1] = MS__ODDS(first, second);
    }
    MS__UNROLL
    for (x = 0; x < 2; ++x) {
        const int near_sides = (half != x) + (y == 1 || y == 2);
        const MS__V there = v[3][x], away = MS__SUB(there, a->nearest), along = MS__SET((float)(2 * half + x) - 1.5f);
        /* d moved to the middle along the plane */
        const MS__V level = MS__SUB(there,
                                    MS__ADD(MS__F(product)(along, a->change[0]), MS__F(product)(down, a->change[1])));
        const MS__V off = MS__MUL(MS__SUB(level, a->d), narrow[near_sides]);
        MS__MASK counts;
        f[x] = MS__MAX(MS__SUB(MS__SET(root[near_sides]), MS__F(product)(off, off)), zero);
        f[x] = MS__MUL(f[x], f[x]);
        f[x] = MS__F(product)(MS__MUL(f[x], f[x]), v[4][x]);
        f[x] = MS__SELECT(MS__LESS(MS__ABS(MS__MUL(away, a->per_radius)), one), f[x], zero);
        counts = MS__LESS(zero, f[x]);
        sum->n = MS__ADD(sum->n, f[x]);
        sum->d = MS__ADD(MS__F(product)(f[x], level), sum->d);
        sum->least = MS__MIN(sum->least, MS__SELECT(counts, there, a->nearest));
        sum->greatest = MS__MAX(sum->greatest, MS__SELECT(counts, there, a->nearest));
        g[x] = MS__DIV(f[x], MS__MAX(v[4][x], one));
        sum->seen = MS__ADD(sum->seen, g[x]);
    }
    MS__UNROLL
    for (c = 0; c < 3; ++c) sum->color[c] = MS__MADD(f[1], v[c][1], MS__MADD(f[0], v[c][0], sum->color[c]));
    for (x = 0; x < 2; ++x) {
        sum->dx = MS__ADD(MS__F(product)(g[x], v[5][x]), sum->dx);
        sum->dy = MS__ADD(MS__F(product)(g[x], v[6][x]), sum->dy);
    }
}

/* Downsamples one row of a level from rows 2j - 1 to 2j + 2 of the finer one, each color, d, coverage, changes of d. */
static void MS__F(downsample)(const ms_sss__pyramid_params *s, const float *row[4][7], int first, int count,
                              float *const out[7])
{
    static const float half_root[3] = {0.594603558f, 0.682130799f, 0.782542290f}; /* square roots of root[] above */
    const MS__V zero = MS__SET(0.0f);
    int i, y, c;
    for (i = first; i < count; i += MS__N) {
        MS__F(anchor) a = MS__F(find_anchor)(s, row, i);
        MS__V narrow[3], result[7], per_n;
        MS__F(merged) sum;
        memset(&sum, 0, sizeof sum);
        sum.least = sum.greatest = a.nearest;
        for (c = 0; c < 3; ++c) narrow[c] = MS__MUL(a.per_radius, MS__SET(half_root[c] / s->merge_reach));
        for (y = 0; y < 4 && MS__BITS(a.some); ++y) {
            MS__F(merge_columns)(&a, narrow, row[y], y, 0, i, &sum);
            MS__F(merge_columns)(&a, narrow, row[y], y, 1, i, &sum);
        }
        a.some = MS__BOTH(MS__LESS(MS__SET(1e-20f), sum.n), a.some);
        per_n = MS__F(inverse)(sum.n);
        for (c = 0; c < 3; ++c) result[c] = MS__MUL(sum.color[c], per_n);
        /* planes are extrapolated within bounds */
        result[3] = MS__F(bound)(MS__DIV(sum.d, sum.n), sum.least, sum.greatest);
        result[4] = sum.n;
        result[5] = MS__DIV(MS__ADD(sum.dx, sum.dx), sum.seen);
        result[6] = MS__DIV(MS__ADD(sum.dy, sum.dy), sum.seen);
        for (c = 0; c < 7; ++c) MS__STORE(out[c] + i, MS__ORDER(MS__SELECT(a.some, result[c], zero)));
    }
}

/* --- up: gather from the coarser level --- */

/* Weights of a level for kernels of these radii in pixels, linear between sizes of the table: the blurred ones, or
   (both) own and blurred. index: the size below the last group's lanes, to begin with. */
static MS_SSS__INLINE void MS__F(level_weights)(const ms_sss__pyramid_params *s, int level, const int both, MS__V size,
                                                MS__MASK valid, int *index, MS__V out[])
{
    const MS__V at = MS__MIN(MS__MAX(size, MS__SET(1.0f)), MS__SET(ms_sss__index_size(MS_SSS_PYRAMID_SIZES - 1)));
    int i = *index, first = i, c;
    if (MS__BITS(valid) &
        (MS__BITS(MS__LESS(at, MS__SET(ms_sss__index_size(i)))) |
         MS__BITS(MS__LESS(MS__SET(ms_sss__index_size(i + 1)), at)))) {
        float lane[MS__N], least, most;
        MS__STORE(lane, at);
        MS__F(extremes)(MS__SELECT(valid, at, MS__SET(lane[ms_sss__lowest(MS__BITS(valid))])), &least, &most);
        i = first = ms_sss__size_index(least);
        *index = ms_sss__size_index(most);
    }
    do {
        const float low = ms_sss__index_size(i), high = ms_sss__index_size(i + 1);
        const float *from = s->table[i][level][!both], *to = s->table[i + 1][level][!both];
        const MS__V t = MS__MUL(MS__SUB(at, MS__SET(low)), MS__SET(1 / (high - low)));
        const MS__MASK above = MS__LESS(MS__SET(low), at);
        if (i > first && MS__BITS(above) == MS__BITS(MS__LESS(MS__SET(high), at))) continue; /* no lane between */
        for (c = 0; c < (both ? 6 : 3); ++c) {
            const MS__V weight = MS__MADD(t, MS__SET(to[c] - from[c]), MS__SET(from[c]));
            out[c] = i > first ? MS__SELECT(above, weight, out[c]) : weight;
        }
    } while (++i <= *index);
}

/* light times the mean of (1 + K sin(theta) / 4)^4, from the mean (moment / light) and mean square v of sin(theta),
   with this bound on rounding. */
static MS_SSS__INLINE MS__V MS__F(elevate_mean)(const ms_sss__pyramid_params *s, int channel, MS__V light, MS__V moment,
                                                MS__V v, MS__V rounding)
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), quarter = MS__SET(s->elevation_4[channel]);
    MS__V m = MS__DIV(moment, MS__SELECT(MS__SAME(light, zero), one, light)), u;
    m = MS__F(bound)(MS__F(residual)(m, rounding), MS__SET(-1.0f), one);
    u = MS__MAX(MS__MADD(quarter, m, one), zero);
    u = MS__MUL(u, u);
    m = MS__MAX(MS__SUB(v, MS__MADD(rounding, rounding, MS__MUL(m, m))), zero);
    m = MS__MADD(MS__MUL(m, MS__MUL(quarter, quarter)), MS__SET(6.0f), u);
    return MS__MUL(light, MS__MIN(MS__MUL(u, m), MS__SET(s->max_factor[channel])));
}

/* w max(0, 1 + K sin(theta) / 4)^4 */
static MS_SSS__INLINE MS__V MS__F(elevate_weight)(const ms_sss__pyramid_params *s, int channel, MS__V sine, MS__V w)
{
    MS__V u = MS__MAX(MS__MADD(MS__SET(s->elevation_4[channel]), sine, MS__SET(1.0f)), MS__SET(0.0f));
    u = MS__MUL(u, u);
    return MS__MUL(w, MS__MUL(u, u));
}

/* The scale that bounds the mean factor, elevated / n, by `most`. */
static MS_SSS__INLINE MS__V MS__F(bounded)(MS__V n, MS__V elevated, float most)
{
    const MS__V limit = MS__MUL(n, MS__SET(most));
    return MS__SELECT(MS__LESS(limit, elevated), MS__DIV(limit, MS__MAX(elevated, MS__SET(1e-30f))), MS__SET(1.0f));
}

/* Distance from the tangent plane, in pixels, that says nothing of the shape next to a pixel: what triangles of a mesh
   bulge (0.01 shows those of 4 pixels at radii of 7), and planes off slopes that options.flat reduced. */
static MS_SSS__INLINE MS__V MS__F(facet)(const ms_sss__pyramid_params *s, MS__V area, MS__V sx, MS__V sy)
{
    const float flattened = s->slope_scale > 0 ? 1 / s->slope_scale - 1 : 0;
    return MS__MADD(MS__ADD(MS__ABS(sx), MS__ABS(sy)), MS__SET(2 * flattened), MS__MUL(area, MS__SET(0.02f)));
}

/* The surface at the pixels that gather. Lengths are in pixels of the coarser level. */
typedef struct MS__F(site) {
    MS__V d, pixels_per_d;
    MS__V limit, limit2; /* the kernel's radius, its square: pixels deeper by more do not count */
    MS__V sx, sy;        /* slopes of the tangent plane in depth */
    MS__V cosine;        /* of the normal to the ray, 0 where there is no tangent plane on this level */
    MS__V shrink;        /* 1 / the surface's area over that of its picture, at least 1 / 1.5 */
    MS__V rounding;      /* bound on the distance of planes from their tangent plane by rounding */
    MS__V facet, most;   /* see facet; the most that a change of slope counts */
} MS__F(site);

/* Sums of a gather: weights; light; moments of sin(theta), or with `wide` weights times the factor of elevation. */
typedef struct MS__F(gathered) {
    MS__V n, light[3], moment[3], square;
} MS__F(gathered);

/* The sums of the coarser level, bilinear (9, 3, 3, 1) / 16, of pixels near the tangent plane: fourth powers of
   nearness (1 - (off / reach radii)^2). */
static MS_SSS__INLINE void MS__F(gather_sums)(const ms_sss__pyramid_params *s, const MS__F(site) * site,
                                              const float *coarse, const ms_sss__gather_tap *tap, MS__V sum[6])
{
    static const float nearness[4] = {0.86602540f, 0.65803701f, 0.65803701f, 0.5f}; /* fourth roots */
    static const float half_nearness[3] = {0.93060486f, 0.81119480f, 0.70710678f};  /* their square roots */
    const MS__V zero = MS__SET(0.0f), per_reach = MS__MUL(MS__SET(1 / s->reach), MS__F(inverse)(site->limit));
    MS__V close[3];
    int k, c;
    for (k = 0; k < 3; ++k) close[k] = MS__MUL(per_reach, MS__SET(half_nearness[k]));
    for (k = 0; k < 4; ++k) {
        const float *p = coarse + tap[k].at;
        const MS__V depth = MS__MUL(MS__SUB(MS__LOAD(p + 3 * s->plane), site->d), site->pixels_per_d);
        MS__V off = MS__NMADD(MS__SET(tap[k].x), site->sx, MS__NMADD(MS__SET(tap[k].y), site->sy, depth)), t;
        off = MS__MUL(off, close[(k + 1) / 2]);
        t = MS__MAX(MS__NMADD(off, off, MS__SET(nearness[k])), zero);
        t = MS__MUL(t, t);
        t = MS__MUL(t, t);
        t = MS__SELECT(MS__LESS(MS__ABS(depth), site->limit), t, zero);
        MS__UNROLL
        for (c = 0; c < 6; ++c) sum[c] = MS__MADD(t, MS__LOAD(p + (7 + c) * s->plane), sum[c]);
    }
}

/* Light of the coarser level by (1 - r^2 / radius^2)^2 (wide: ^3) of the distance on the surface and by the area that
   each pixel shows. Elevation: wide, of every pixel; else of the mean and mean square of sin(theta). Near a pixel
   of the picture the depth below its plane shows a mesh's triangles; there it is taken from half the change of slope
   along the way, unless a pixel lies deeper by more than a triangle bulges. */
static MS_SSS__INLINE void MS__F(gather_light)(const ms_sss__pyramid_params *s, const int wide,
                                               const MS__F(site) * site, MS__V fall, const float *coarse,
                                               const ms_sss__gather_tap *tap, int count, MS__F(gathered) * sum)
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f);
    int k, c;
    for (k = 0; k < count; ++k) {
        const float *p = coarse + tap[k].at;
        const MS__V dz = MS__MUL(MS__SUB(MS__LOAD(p + 3 * s->plane), site->d), site->pixels_per_d), q = MS__MUL(dz, dz),
                    away = MS__ADD(q, MS__SET(tap[k].square)); /* squared distance */
        const MS__V x = MS__SET(tap[k].x), y = MS__SET(tap[k].y), t = MS__MAX(MS__MADD(away, fall, one), zero);
        MS__V off = MS__NMADD(x, site->sx, MS__NMADD(y, site->sy, dz)), w = MS__MUL(t, t), sine;
        if (s->level == 0 && s->slope_scale > 0) {
            const MS__V rise = MS__MADD(x, MS__LOAD(p + 5 * s->plane), MS__MUL(y, MS__LOAD(p + 6 * s->plane))),
                        turn = MS__MADD(rise, site->pixels_per_d, MS__SUB(off, dz));
            off = MS__MAX(MS__SUB(off, site->facet), MS__MIN(MS__MUL(turn, MS__SET(s->bend)), site->most));
        }
        sine = off;
        if (wide) w = MS__MUL(w, t);
        w = MS__SELECT(MS__LESS(q, site->limit2), MS__MUL(w, MS__LOAD(p + 4 * s->plane)), zero);
        sum->n = MS__ADD(sum->n, w);
        if (wide)
            sine = MS__MUL(MS__MUL(MS__F(residual)(off, site->rounding), site->cosine),
                           MS__F(inverse_root)(MS__ADD(away, MS__SET(s->blur))));
        else sum->square = MS__MADD(MS__MUL(w, off), off, sum->square);
        MS__UNROLL
        for (c = 0; c < 3; ++c) {
            const MS__V e = MS__LOAD(p + c * s->plane);
            if (wide) {
                const MS__V f = MS__F(elevate_weight)(s, c, sine, w);
                sum->moment[c] = MS__ADD(sum->moment[c], f);
                sum->light[c] = MS__MADD(f, e, sum->light[c]);
            } else {
                sum->light[c] = MS__MADD(w, e, sum->light[c]);
                sum->moment[c] = MS__MADD(MS__MUL(w, off), e, sum->moment[c]);
            }
        }
    }
}

/* Multiplies gathered light by its elevation. */
static MS_SSS__INLINE void MS__F(elevate_gathered)(const ms_sss__pyramid_params *s, const int wide,
                                                   const MS__F(site) * site, MS__F(gathered) * sum)
{
    const MS__V zero = MS__SET(0.0f), facing = MS__MUL(site->shrink, site->cosine),
                turn = MS__MUL(facing, MS__SET(s->mean)), rounding = MS__MUL(turn, site->rounding);
    const MS__V per_n = MS__DIV(MS__SET(1.0f), MS__SELECT(MS__LESS(zero, sum->n), sum->n, MS__SET(1.0f)));
    const MS__V v = MS__MUL(MS__MUL(sum->square, per_n), MS__MUL(MS__MUL(facing, facing), MS__SET(s->spread)));
    int c;
    for (c = 0; c < 3; ++c) {
        if (wide) /* bounded: constant light is not amplified above 1 / reflectance */
            sum->light[c] = MS__MUL(sum->light[c], MS__F(bounded)(sum->n, sum->moment[c], s->max_factor[c]));
        else sum->light[c] = MS__F(elevate_mean)(s, c, sum->light[c], MS__MUL(sum->moment[c], turn), v, rounding);
    }
}

/* gather for the even or the odd columns of MS__N pairs with these d and changes of d. result: three sums of light,
   three of weights. */
static MS_SSS__INLINE void MS__F(gather_side)(const ms_sss__pyramid_params *s, const int wide, MS__V d, MS__V dx,
                                              MS__V dy, const float *coarse, const ms_sss__gather_tap *tap, MS__V rx,
                                              MS__V ry, int *index, MS__V result[6])
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f);
    const float cells = (float)(1 << (s->level + 1)); /* pixels of the picture along one of the coarser level */
    const float square = MS_SSS__GATHER(wide, s->level);
    const MS__MASK valid = MS__LESS(zero, MS__ABS(d));
    const MS__V safe = MS__SELECT(valid, d, MS__SET(-1.0f)), radius = MS__F(radius)(s, safe);
    MS__V area, cap, reach, norm, sum[6], weight[3];
    MS__MASK sound; /* planes so steep that four pixels span a radius in depth have no tangent plane here */
    MS__F(gathered) light;
    MS__F(site) site;
    int k, c, count = 4;
    memset(&light, 0, sizeof light);
    for (k = 0; k < 6; ++k) sum[k] = result[k] = zero;
    if (!MS__BITS(valid)) return;
    site.d = d;
    site.pixels_per_d = MS__MUL(MS__F(pixels_per_d)(s, safe), MS__SET(1 / cells));
    site.limit = MS__MUL(radius, MS__SET(1 / cells));
    site.limit2 = MS__MUL(site.limit, site.limit);
    site.sx = MS__MUL(MS__MUL(dx, site.pixels_per_d), MS__SET(2.0f));
    site.sy = MS__MUL(MS__MUL(dy, site.pixels_per_d), MS__SET(2.0f));
    sound = MS__LESS(MS__MUL(MS__ADD(MS__ABS(site.sx), MS__ABS(site.sy)), MS__SET(0.5f * cells)), radius);
    area = MS__SELECT(valid, MS__F(area)(site.sx, site.sy, rx, ry), one);
    cap = MS__MIN(area, MS__SET(1.5f));
    site.shrink = MS__DIV(one, cap);
    site.cosine = MS__SELECT(sound, MS__DIV(one, area), zero);
    site.facet = MS__F(facet)(s, area, site.sx, site.sy);
    site.most = MS__MUL(area, MS__SET(0.5f)); /* sines up to about a half: steep slopes are not sure */
    site.rounding = MS__SET(s->plane_rounding);
    if (!s->perspective) site.rounding = MS__MUL(d, site.rounding);
    norm = MS__MUL(MS__MUL(site.shrink, site.shrink), MS__SET(s->norm));
    reach = MS__MUL(MS__MUL(cap, cap), MS__SET(square)); /* tilted surfaces take a wider circle */
    while (count < s->taps && MS__BITS(MS__LESS(MS__SET(tap[count].square), reach))) ++count;
    if (s->sums) MS__F(gather_sums)(s, &site, coarse, tap, sum);
    MS__F(gather_light)
    (s, wide, &site, MS__MUL(MS__MUL(site.shrink, site.shrink), MS__SET(-1 / square)), coarse, tap, count, &light);
    MS__F(elevate_gathered)(s, wide, &site, &light);
    MS__F(level_weights)(s, s->level + 1, 0, MS__MUL(radius, site.shrink), valid, index, weight);
    for (c = 0; c < 3; ++c) {
        result[c] = MS__SELECT(valid, MS__MADD(MS__MUL(weight[c], norm), light.light[c], sum[c]), zero);
        result[c + 3] = MS__SELECT(valid, MS__MADD(weight[c], MS__MUL(light.n, norm), sum[c + 3]), zero);
    }
}

/* Gathers row y of a level: sums of the next coarser level's light, weighted by distance in space and elevation, plus
   that level's own sums, bilinear. own: d and its changes; coarse: row y / 2, followed by planes of green, blue, d,
   coverage, changes of d, three sums of light, three of weights; first, count: columns / 2; out: the six sums. */
static MS_SSS__INLINE void MS__F(gather_row)(const ms_sss__pyramid_params *s, const int wide, const float *const own[3],
                                             const float *coarse, int first, int count, int y, float *const out[6])
{
    const float cells = (float)(1 << (s->level + 1));
    const MS__V ry = MS__SET((((float)y + 0.5f) * 0.5f * cells - s->middle[1]) * s->tangent);
    int i, c, odd, index = 0;
    for (i = first; i < count; i += MS__N) {
        MS__V result[2][6], at[3][2];
        for (c = 0; c < 3; ++c) {
            const MS__V near_by = MS__LOAD(own[c] + 2 * i), beyond = MS__LOAD(own[c] + 2 * i + MS__N);
            at[c][0] = MS__EVEN(near_by, beyond);
            at[c][1] = MS__ODD(near_by, beyond);
        }
        for (odd = 0; odd < 2; ++odd) {
            const MS__V rx = MS__MADD(
                MS__LOAD(ms_sss__iota), MS__SET(cells * s->tangent),
                MS__SET((((float)(2 * i + odd) + 0.5f) * 0.5f * cells - s->middle[0]) * s->tangent));
            MS__F(gather_side)
            (s, wide, at[0][odd], at[1][odd], at[2][odd], coarse + i, s->tap[y & 1][odd], rx, ry, &index, result[odd]);
        }
        for (c = 0; c < 6; ++c) {
            MS__STORE(out[c] + 2 * i, MS__ZIP_LOW(result[0][c], result[1][c]));
            MS__STORE(out[c] + 2 * i + MS__N, MS__ZIP_HIGH(result[0][c], result[1][c]));
        }
    }
}

static void MS__F(gather)(const ms_sss__pyramid_params *s, const float *const own[3], const float *coarse, int first,
                          int count, int y, float *const out[6])
{
    if (s->wide) MS__F(gather_row)(s, 1, own, coarse, first, count, y, out);
    else MS__F(gather_row)(s, 0, own, coarse, first, count, y, out);
}

/* --- the picture's own level --- */

/* A pixel's neighbors: light and weights by (1, 2, 1) / 4 both ways, of those near its tangent plane, elevated by what
   they lie below it. radius: of the kernel in pixels. Elevation counts in full up to 10 pixels and not from 20 on: with
   larger kernels it adds to the error against random walks. */
static MS_SSS__INLINE void MS__F(gather_neighbors)(const ms_sss__pyramid_params *s, const float *const row[4],
                                                   ptrdiff_t stride, int i, MS__V d, MS__V dx, MS__V dy, MS__V coverage,
                                                   MS__V radius, MS__F(gathered) * sum)
{
    /* Fourth roots of the weights 1, 2 over 16 are the tops of root - (off root' )^2, which is 0 from 2 pixels on. */
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), quarter = MS__SET(0.25f);
    const MS__V pixels_per_d = MS__F(pixels_per_d)(s, MS__SELECT(MS__LESS(zero, MS__ABS(d)), d, MS__SET(-1.0f)));
    const MS__V corner = MS__MUL(pixels_per_d, quarter), edge = MS__MUL(pixels_per_d, MS__SET(0.29730178f));
    const MS__V fade = MS__F(bound)(MS__NMADD(radius, MS__SET(0.1f), MS__SET(2.0f)), zero, one),
                area = MS__MAX(coverage, one), cosine = MS__MUL(fade, MS__F(inverse)(area)),
                rounding = MS__MUL(s->perspective ? one : d, MS__SET(2 * s->plane_rounding)),
                facet = MS__ADD(rounding, MS__F(facet)(s, area, MS__MUL(dx, pixels_per_d), MS__MUL(dy, pixels_per_d)));
    int j, k, c;
    sum->n = quarter;
    MS__UNROLL
    for (c = 0; c < 3; ++c) {
        sum->light[c] = MS__MUL(quarter, MS__LOAD(row[c] + i));
        sum->moment[c] = quarter;
    }
    for (j = -1; j < 2; ++j)
        for (k = -1; k < 2; ++k) {
            const int diagonal = j && k;
            const ptrdiff_t at = i + k + j * stride;
            const MS__V there = MS__LOAD(row[3] + at);
            MS__V off = MS__SUB(there, d), f, sine;
            if (!j && !k) continue;
            off = MS__NMADD(MS__SET((float)k), dx, MS__NMADD(MS__SET((float)j), dy, off));
            f = MS__MUL(off, diagonal ? corner : edge);
            f = MS__MAX(MS__NMADD(f, f, diagonal ? quarter : MS__SET(0.35355339f)), zero);
            f = MS__MUL(f, f);
            f = MS__SELECT(MS__LESS(zero, MS__ABS(there)), f, zero);
            sum->n = MS__ADD(sum->n, f);
            /* sin(theta) over the distance of 1 or sqrt(2) pixels */
            sine = MS__MUL(MS__MAX(MS__SUB(MS__MUL(off, pixels_per_d), facet), zero), cosine);
            sine = MS__MIN(MS__MUL(sine, MS__SET(diagonal ? 0.70710678f : 1.0f)), one);
            MS__UNROLL
            for (c = 0; c < 3; ++c) {
                const MS__V w = MS__F(elevate_weight)(s, c, sine, f);
                sum->moment[c] = MS__ADD(sum->moment[c], w);
                sum->light[c] = MS__MADD(w, MS__LOAD(row[c] + at), sum->light[c]);
            }
        }
    for (c = 0; c < 3; ++c)
        sum->light[c] = MS__MUL(sum->light[c], MS__F(bounded)(sum->n, sum->moment[c], s->max_factor[c]));
}

/* Resolves the picture: a pixel's own light, that of its neighbors, and the sums. row: color and d, of rows stride
   floats apart; slope: coverage, then the changes of d; out: color, and depth (parallel rays: 0) or MASKED_DEPTH. */
static void MS__F(resolve)(const ms_sss__pyramid_params *s, const float *const row[4], ptrdiff_t stride,
                           const float *const slope[3], const float *const sum[6], int first, int count,
                           float *const out[4])
{
    const MS__V zero = MS__SET(0.0f), one = MS__SET(1.0f), masked = MS__SET(MS_SSS__MASKED_DEPTH);
    int i, c, index = 0;
    for (i = first; i < count; i += MS__N) {
        const MS__V d = MS__LOAD(row[3] + i);
        const MS__MASK valid = MS__LESS(zero, MS__ABS(d));
        const MS__V safe = MS__SELECT(valid, d, MS__SET(-1.0f)), radius = MS__F(radius)(s, safe);
        const MS__V coverage = MS__LOAD(slope[0] + i),
                    size = MS__DIV(radius, MS__F(bound)(coverage, one, MS__SET(1.5f)));
        MS__V share[6];
        MS__F(gathered) near_by;
        MS__STORE(out[3] + i, MS__SELECT(valid, s->perspective ? MS__DIV(MS__SET(-1.0f), safe) : zero, masked));
        if (!MS__BITS(valid)) continue;
        MS__F(level_weights)(s, 0, 1, size, valid, &index, share);
        near_by.n = near_by.light[0] = near_by.light[1] = near_by.light[2] = zero;
        if (MS__BITS(MS__LESS(zero, MS__MAX(share[3], MS__MAX(share[4], share[5])))) & MS__BITS(valid))
            MS__F(gather_neighbors)
        (s, row, stride, i, d, MS__LOAD(slope[1] + i), MS__LOAD(slope[2] + i), coverage, radius, &near_by);
        for (c = 0; c < 3; ++c) {
            const MS__V e = MS__LOAD(row[c] + i);
            const MS__V own = MS__MADD(share[c], e, MS__MUL(share[c + 3], near_by.light[c]));
            const MS__V light = MS__ADD(own, MS__LOAD(sum[c] + i)),
                        all = MS__ADD(MS__MADD(share[c + 3], near_by.n, share[c]), MS__LOAD(sum[c + 3] + i));
            const MS__MASK sound = MS__LESS(MS__SET(1e-30f), all);
            MS__STORE(out[c] + i, MS__SELECT(sound, MS__MUL(light, MS__F(inverse)(all)), e));
        }
    }
}

static const ms_sss__simd MS__F(simd) = {MS__F(unpack),     MS__F(mask_by),     MS__F(load_masked), MS__F(slopes),
                                         MS__F(tangents),   MS__F(taps),        MS__F(combine),     MS__F(finish),
                                         MS__F(depth_to_d), MS__F(slopes_of_d), MS__F(downsample),  MS__F(gather),
                                         MS__F(resolve)};

#undef MS_SSS__JOIN_
#undef MS_SSS__JOIN
#undef MS__F
#undef MS__UNROLL
#undef MS__V
#undef MS__X
#undef MS__Z
#undef MS__MASK
#undef MS__LOAD
#undef MS__STORE
#undef MS__SET
#undef MS__ADD
#undef MS__SUB
#undef MS__MUL
#undef MS__DIV
#undef MS__MADD
#undef MS__NMADD
#undef MS__MIN
#undef MS__MAX
#undef MS__SQRT
#undef MS__RSQRT
#undef MS__RCP
#undef MS__ABS
#undef MS__LESS
#undef MS__SAME
#undef MS__BOTH
#undef MS__SELECT
#undef MS__BITS
#undef MS__ZIP_LOW
#undef MS__ZIP_HIGH
#undef MS__EVEN
#undef MS__ODD
#undef MS__EVENS
#undef MS__ODDS
#undef MS__ORDER
#undef MS_SSS__LEVEL
#undef MS__N
#endif /* MS_SSS__PASS */

#if defined(MS_SSS__BODY) && !defined(MS_SSS__PASS) /* what calls the kernels */
static const ms_sss__simd *ms_sss__pick(ms_simd cap)
{
    switch (ms__simd_pick(cap)) {
#if defined(MS__X64)
    case MS_SIMD_AVX512: return &ms_sss__simd_avx512;
    case MS_SIMD_AVX2: return &ms_sss__simd_avx2;
#endif
#if defined(MS_SSS__SCALAR) && (defined(MS__X64) || defined(MS__NEON))
    case MS_SIMD_BASE: return &ms_sss__simd_base;
#endif
#if defined(MS_SSS__SCALAR)
    default: return &ms_sss__simd_scalar;
#else
    default: return &ms_sss__simd_base;
#endif
    }
}

/* ---- filter code ----------------------------------------------------------------------------------------------- */

/* --- views and kernels in them --- */

static ms_sss__view ms_sss__make_view(const ms_sss_filter_options *o, int width, int height)
{
    const double degree = 3.14159265358979323846 / 180;
    ms_sss__view v;
    v.width = width;
    v.height = height;
    v.perspective = o->fov_degrees > 0;
    v.mm_per_unit = o->mm_per_unit > 0 ? (double)o->mm_per_unit : 1;
    v.aspect[0] = v.aspect[1] = 1;
    if (v.perspective) {
        v.pixels_per_mm = height / (2 * tan((double)o->fov_degrees * degree / 2) * v.mm_per_unit);
    } else if (o->ortho_height > 0) {
        v.pixels_per_mm = height / ((double)o->ortho_height * v.mm_per_unit);
    } else {
        v.pixels_per_mm = (double)o->pixels_per_mm[0];
        if (o->pixels_per_mm[1] > 0) v.aspect[1] = o->pixels_per_mm[1] / o->pixels_per_mm[0];
    }
    v.middle[0] = 0.5f * (float)width + o->center[0];
    v.middle[1] = 0.5f * (float)height + o->center[1];
    return v;
}

static int ms_sss__longer_side(const ms_sss__view *v) { return v->width > v->height ? v->width : v->height; }

/* Which of the surface's properties weigh light: none, depth alone, or depth and slopes. */
static int ms_sss__uses_depth(const ms_sss_filter_options *o, int with_depth)
{
    return with_depth && o->depth_mode == MS_SSS_DEPTH_AWARE;
}

static int ms_sss__uses_slopes(const ms_sss_filter_options *o, int with_depth)
{
    return ms_sss__uses_depth(o, with_depth) && o->flat < 1;
}

/* The scale of depth. Weights reach 0 at a step of `end` mm: 3.0746 sigma; with slopes and no sigma given 1.5 radii,
   from where on surfaces do not exchange light. */
static void ms_sss__set_depth(ms_sss__pass *p, const ms_sss__view *v, const ms_sss_kernel *k,
                              const ms_sss_filter_options *o, int with_depth)
{
    const int slopes = ms_sss__uses_slopes(o, with_depth);
    const double radius = (double)k->radius_mm,
                 extent = k->profile_radius_mm > 0 ? (double)k->profile_radius_mm : radius,
                 slope_scale = slopes ? 1 - (double)o->flat : 0,
                 sigma = o->depth_sigma_mm > 0 ? (double)o->depth_sigma_mm : (0.12 + 0.13 * slope_scale) * extent;
    double end = MS_SSS__FALLOFF_END * sigma;
    int c;
    if (!slopes && radius < end) end = radius;
    if (slopes && !(o->depth_sigma_mm > 0)) end = (0.37 + 1.13 * slope_scale) * extent;
    p->average_dz = 1;
    if (slopes && !(o->depth_sigma_mm > 0)) p->average_dz = (float)(MS_SSS__FALLOFF_END * sigma / end);
    p->mm_per_depth = (float)end;
    p->depth_scale = (float)(v->mm_per_unit / end);
    if (!ms_sss__uses_depth(o, with_depth)) /* depth sets the size alone: its differences become negligible, or 0 */
        p->depth_scale = v->perspective ? 1e-9f : 0;
    p->slope_scale = (float)slope_scale;
    p->edge_dz2 = (float)(radius / end * (radius / end));
    p->dz_falloff = (float)(slope_scale * end * end);
    p->rounding = 2.3841858e-7f; /* depths are rounded to 2^-24 when given and when scaled */
    p->least_sine = -1;
    for (c = 0; c < 3; ++c) {
        p->elevation_4[c] = k->elevation_axis[c] / 4 * p->slope_scale;
        p->root_r[c] = k->reflectance[c] > 0 ? sqrtf(fminf(k->reflectance[c], 1)) : 0;
        if (p->elevation_4[c] * p->least_sine < -1) p->least_sine = -1 / p->elevation_4[c];
    }
}

/* Everything of a kernel in a view but the taps of its terms. */
static void ms_sss__set_kernel(ms_sss__pass *p, const ms_sss__view *v, const ms_sss_kernel *k,
                               const ms_sss_filter_options *o, int with_depth)
{
    const double radius = (double)k->radius_mm,
                 finer = (double)(v->aspect[0] > v->aspect[1] ? v->aspect[0] : v->aspect[1]),
                 half = 0.5 / (radius * finer), most = ms_sss__longer_side(v) / radius;
    double pixels_per_mm = v->pixels_per_mm, focal;
    int c;
    memset(p, 0, sizeof *p);
    ms_sss__set_depth(p, v, k, o, with_depth);
    p->perspective = v->perspective;
    focal = pixels_per_mm * v->mm_per_unit;
    p->tangent = v->perspective ? (float)(1 / focal) : 0;
    for (c = 0; c < 2; ++c) {
        p->middle[c] = v->middle[c];
        p->focal[c] = (float)focal * v->aspect[c];
        if (!v->perspective && p->depth_scale > 0) p->focal[c] /= p->depth_scale;
    }
    if (v->perspective) pixels_per_mm *= (double)p->depth_scale;
    else if (pixels_per_mm > most) pixels_per_mm = most;
    p->pixels_per_mm = (float)pixels_per_mm;
    p->pixels_per_mm_most = (float)most;
    p->pixels_per_mm_half = (float)(half > 1e-30 ? half : 1e-30);
}

/* The light of a tap falls about as 1 / x^2 with its distance x = mm, so a pixel dz off the tangent plane has the
   weight 1 / (1 + dz_falloff dz^2) of one on it. The bound keeps products of three finite. */
static float ms_sss__dz_falloff(const ms_sss__pass *p, float mm)
{
    const float most = 1e6f, square = mm * mm;
    return p->dz_falloff < most * square ? p->dz_falloff / square : p->dz_falloff > 0 ? most : 0;
}

/* How far the elevation of a pair follows that of the next one outwards; near taps would see a mesh's triangles. */
static void ms_sss__follow_outer(ms_sss__pair *pair, float mm, float outer_mm, float radius_mm)
{
    const double near_by = (double)mm / (MS_SSS__NEAR * (double)radius_mm), square = near_by * near_by;
    pair->follow = mm < outer_mm ? (float)(1 / (1 + square * square)) : 0;
    pair->to_outer = mm < outer_mm ? mm / outer_mm : 0;
}

/* A tap represents more surface where it bends away between the tap before, at inner mm, and this one: 1 + (area_scale
   times the change of height in mm)^2, which is sec^2 of that angle to second order for both axes. */
static float ms_sss__pair_area_scale(const ms_sss__pass *p, float mm, float *inner)
{
    const float gap = mm - *inner;
    *inner = mm;
    return gap > 1e-20f ? p->area_scale / gap : 0;
}

/* Sums of a term's weights. A sum within rounding of 1 becomes 1 if delta is 0, so that pixels without neighbors keep
   their bits. */
static void ms_sss__totals(const ms_sss_kernel *k, int term, float total[3], int mixed[3])
{
    int c, i;
    for (c = 0; c < 3; ++c) {
        double sum = 0;
        mixed[c] = 0;
        for (i = 0; i <= k->tap_count / 2; ++i) {
            sum += (i ? 2 : 1) * (double)k->weight[term][i][c];
            if (k->weight[term][i][c] < 0) mixed[c] = 1;
        }
        total[c] = fabs(sum - 1) < 1e-5 && !ms_sss__differ(k->delta[c], 0) ? 1.0f : (float)sum;
    }
}

/* The taps of a term. set_kernel comes before. */
static void ms_sss__set_term(ms_sss__pass *p, const ms_sss__view *v, const ms_sss_kernel *k, int term)
{
    float inner = 0;
    int i, c;
    ms_sss__totals(k, term, p->total, p->mixed);
    p->area_scale = p->mixed[0] || p->mixed[1] || p->mixed[2] ? 0 : sqrtf(0.5f * p->slope_scale);
    p->pair_count = k->tap_count / 2;
    p->reach_px[0] = p->reach_px[1] = 0;
    for (c = 0; c < 3; ++c) {
        p->center[c] = k->weight[term][0][c];
        p->scale[c] = k->scale[term][c];
        p->delta[c] = term + 1 == k->term_count ? k->delta[c] : 0;
    }
    for (i = 1; i <= p->pair_count; ++i) {
        const float mm = k->offset_mm[i];
        ms_sss__pair *pair = &p->pair[i - 1];
        pair->per_mm = mm > 1e-20f ? 1 / mm : 0;
        pair->dz_falloff = ms_sss__dz_falloff(p, mm);
        pair->area_scale = ms_sss__pair_area_scale(p, mm, &inner);
        ms_sss__follow_outer(pair, mm, i < p->pair_count ? k->offset_mm[i + 1] : 0, k->radius_mm);
        for (c = 0; c < 3; ++c) pair->weight[c] = k->weight[term][i][c];
        for (c = 0; c < 2; ++c) {
            const float reach = p->pixels_per_mm * (pair->offset[c] = mm * v->aspect[c]);
            const int pixels = reach < (float)MS_SSS__FAR ? (int)reach + 2 : (int)MS_SSS__FAR;
            if (pixels > p->reach_px[c]) p->reach_px[c] = pixels;
        }
    }
}

/* --- a call: pictures, memory, runs over rows --- */

/* Row buffers of a task. */
enum {
    MS_SSS__ROW_LIGHT = 0,    /* three: the caller's pixels or normals */
    MS_SSS__ROW_MAP = 3,      /* strength or depth of the caller */
    MS_SSS__ROW_DEPTH = 4,    /* scaled depth */
    MS_SSS__ROW_SLOPE = 5,    /* two */
    MS_SSS__ROW_COPY = 7,     /* three: a row that the first pass overwrites */
    MS_SSS__ROW_TANGENT = 10, /* three: its tangent planes along x */
    MS_SSS__ROW_OUT = 13,     /* three: a pass's result */
    MS_SSS__ROWS = 16
};

/* The unmasked columns of a row. */
typedef struct ms_sss__row {
    int first, last;             /* whole blocks; every pixel outside is masked */
    int valid_first, valid_last; /* a run without masked pixels; up to `padded` if it reaches the width */
} ms_sss__row;

/* The workspace of a call. Planes have an empty row above and below, and MS_SSS__LEFT floats before each row. */
typedef struct ms_sss__memory {
    int block, padded; /* columns; padded: the width in whole blocks */
    ptrdiff_t stride;  /* floats from a row to the next */
    float *color[3];   /* light, then the first pass's result */
    float *depth;      /* scaled depth; NULL: a pyramid, which has d */
    float *plane[3];   /* tangent planes along y; NULL: no slopes */
    float *sum[3];     /* sums over terms; NULL: all kernels have one */
    float *rows;       /* [TASKS][ROWS] row buffers */
    ms_sss__row *row;  /* [height] */
} ms_sss__memory;

typedef struct ms_sss__job {
    /* the call */
    ms_sss_frame frame; /* strides filled in */
    ms_sss_filter_options options;
    const ms_sss__simd *simd;
    ms_sss__view view;
    ms_sss__memory memory;
    int in_place; /* the output is the input */
    /* the kernel at hand */
    int profile; /* its number */
    int term, terms;
    int identity; /* the kernel is under half a pixel everywhere */
    ms_sss__weights by;
    ms_sss__pass pass;
    /* the run over rows at hand */
    int begin, end, band; /* rows; rows of a task */
} ms_sss__job;

static int ms_sss__round_up(int x, int step) { return (x + step - 1) / step * step; }

static int ms_sss__padded(int width) { return ms_sss__round_up(width, width < MS_SSS__BLOCK ? 16 : MS_SSS__BLOCK); }

/* Floats of a row: an odd number of cache lines, so that neighboring rows fall on different cache sets. */
static ptrdiff_t ms_sss__stride(int width)
{
    const int floats = MS_SSS__LEFT + ms_sss__padded(width) + MS_SSS__RIGHT;
    return floats / 16 % 2 ? floats : floats + 16;
}

/* Takes a plane of floats; returns its first row's first pixel. */
static float *ms_sss__take_plane(ms__arena *arena, ptrdiff_t stride, int height)
{
    float *p = (float *)ms__take(arena, ms__size_mul((size_t)stride, (size_t)height + 2), sizeof(float));
    return p ? p + stride + MS_SSS__LEFT : NULL;
}

/* Takes what a call needs, or counts it. planes: of tangent planes and sums. */
static void ms_sss__take_memory(ms_sss__memory *m, int width, int height, int with_depth_plane, int with_slopes,
                                int with_sums, ms__arena *arena)
{
    int c;
    memset(m, 0, sizeof *m);
    m->padded = ms_sss__padded(width);
    m->block = m->padded < MS_SSS__BLOCK ? m->padded : MS_SSS__BLOCK;
    m->stride = ms_sss__stride(width);
    for (c = 0; c < 3; ++c) {
        m->color[c] = ms_sss__take_plane(arena, m->stride, height);
        if (with_slopes) m->plane[c] = ms_sss__take_plane(arena, m->stride, height);
        if (with_sums) m->sum[c] = ms_sss__take_plane(arena, m->stride, height);
    }
    if (with_depth_plane) m->depth = ms_sss__take_plane(arena, m->stride, height);
    m->rows = (float *)ms__take(arena, (size_t)m->stride * MS_SSS__TASKS * MS_SSS__ROWS, sizeof(float));
    m->row = (ms_sss__row *)ms__take(arena, (size_t)height, sizeof(ms_sss__row));
}

static ms__arena ms_sss__place_in(void *workspace)
{
    ms__arena arena = {NULL, 0};
    if (workspace) arena.base = (char *)workspace + (-(uintptr_t)workspace & 63);
    return arena;
}

static float *ms_sss__buffer(const ms_sss__job *job, int task, int row)
{
    return job->memory.rows + ((ptrdiff_t)task * MS_SSS__ROWS + row) * job->memory.stride + MS_SSS__LEFT;
}

static void ms_sss__fill(float *row, int begin, int end, float value)
{
    int x;
    for (x = begin; x < end; ++x) row[x] = value;
}

#if defined(MS__X64)
typedef struct ms_sss__task {
    void (*run)(void *context, int index);
    void *context;
} ms_sss__task;

static void ms_sss__mask_exceptions(void *context, int index)
{
    const ms_sss__task *task = (const ms_sss__task *)context;
    const unsigned host = _mm_getcsr();
    _mm_setcsr((host & ~0x3fu) | 0x1f80u);
    task->run(task->context, index);
    _mm_setcsr(host);
}
#endif

/* ms__run with floating-point exceptions masked and their flags restored: masked lanes compute with infinity and 0. */
static void ms_sss__run_parallel(const ms_parallel *parallel, int count, void (*run)(void *context, int index),
                                 void *context)
{
#if defined(MS__X64)
    ms_sss__task task;
    task.run = run;
    task.context = context;
    ms__run(parallel, count, ms_sss__mask_exceptions, &task);
#else
    ms__run(parallel, count, run, context);
#endif
}

/* Runs a pass over rows [0, height), cut into bands that depend on the height alone. */
static void ms_sss__run_rows(ms_sss__job *job, int height, void (*pass)(void *context, int task))
{
    const int rows = (height + MS_SSS__TASKS - 1) / MS_SSS__TASKS;
    job->begin = 0;
    job->end = height;
    job->band = rows < 12 ? 12 : rows;
    ms_sss__run_parallel(&job->options.parallel, (height + job->band - 1) / job->band, pass, job);
}

/* The rows of a task. */
static int ms_sss__band_begin(const ms_sss__job *job, int task) { return job->begin + task * job->band; }

static int ms_sss__band_end(const ms_sss__job *job, int task)
{
    const int end = job->begin + (task + 1) * job->band;
    return end < job->end ? end : job->end;
}

/* --- the caller's pixels --- */

static float *ms_sss__pixel(const ms_sss_image *image, int c, int x, int y)
{
    return image->channel[c] + y * image->row_stride + x * image->pixel_stride;
}

/* Sets out[c] to the values of pixels [x, x + count) of row y: in the image if they are contiguous, else copied to
   buffer[c], with 0 from column `width` on. */
static void ms_sss__load(const ms_sss__simd *simd, const ms_sss_image *image, int channels, int width, int y, int x,
                         int count, float *const *buffer, const float **out)
{
    const ptrdiff_t step = image->pixel_stride;
    const int n = width - x < count ? width - x : count;
    int c, i, done = 0;
    if (channels == 3 && step == 4 && image->channel[1] == image->channel[0] + 1 &&
        image->channel[2] == image->channel[0] + 2)
        done = simd->unpack(ms_sss__pixel(image, 0, x, y), n, buffer);
    for (c = 0; c < channels; ++c) {
        const float *from = ms_sss__pixel(image, c, x, y);
        float *to = buffer[c];
        out[c] = from;
        if (step == 1 && n == count) continue;
        out[c] = to;
        for (i = done; i < n; ++i) to[i] = from[i * step];
        for (i = n; i < count; ++i) to[i] = 0;
    }
}

/* Copies those of `count` pixels from (x, y) on that are masked, or those that are not, bit for bit; from: steps of
   from_step floats. */
static void ms_sss__copy(const ms_sss_image *image, int width, int y, int x, int count, const float *const from[3],
                         ptrdiff_t from_step, const float *depth, int masked)
{
    const ptrdiff_t step = image->pixel_stride;
    float *red = ms_sss__pixel(image, 0, x, y), *green = ms_sss__pixel(image, 1, x, y),
          *blue = ms_sss__pixel(image, 2, x, y);
    int i;
    if (count > width - x) count = width - x;
    for (i = 0; i < count; ++i) {
        if ((depth[i] < MS_SSS__MASKED_DEPTH) == masked) continue;
        memcpy(red + i * step, from[0] + i * from_step, sizeof(float));
        memcpy(green + i * step, from[1] + i * from_step, sizeof(float));
        memcpy(blue + i * step, from[2] + i * from_step, sizeof(float));
    }
}

/* --- rows --- */

static int ms_sss__all_valid(const ms_sss__job *job, int y, int begin, int end)
{
    return job->memory.row[y].valid_first <= begin && end <= job->memory.row[y].valid_last;
}

/* The longest run of unmasked pixels of a row. */
static void ms_sss__find_valid_run(const ms_sss__job *job, ms_sss__row *row, const float *depth)
{
    int x, run = row->first;
    row->valid_first = row->valid_last = 0;
    for (x = row->first; x <= row->last; ++x) {
        if (x < row->last && depth[x] < MS_SSS__MASKED_DEPTH) continue;
        if (x - run > row->valid_last - row->valid_first) {
            row->valid_first = run;
            row->valid_last = x;
        }
        run = x + 1;
    }
    if (row->valid_last == job->frame.width) row->valid_last = job->memory.padded;
}

/* Narrows the blocks [*first, *last) to those of the unmasked columns `span`. */
static void ms_sss__narrow(const ms_sss__job *job, const int span[2], int *first, int *last)
{
    *first = span[0] - span[0] % job->memory.block;
    *last = ms_sss__round_up(span[1], job->memory.block);
}

/* The scaled depth of row y, by profile, strength and depth; span: its unmasked columns. */
static void ms_sss__load_depth(const ms_sss__job *job, int y, int task, float *depth, int span[2])
{
    const ms_sss_frame *f = &job->frame;
    const int width = f->width, padded = job->memory.padded;
    float *buffer = ms_sss__buffer(job, task, MS_SSS__ROW_MAP);
    const float *map;
    int x, part[2], first = 0, last = padded;
    ms_sss__fill(depth, -MS_SSS__LEFT, 0, MS_SSS__MASKED_DEPTH);
    ms_sss__fill(depth, f->profile || job->identity ? 0 : width, (int)job->memory.stride - MS_SSS__LEFT,
                 MS_SSS__MASKED_DEPTH);
    span[0] = 0;
    span[1] = job->identity ? 0 : width;
    if (job->identity) return;
    if (f->profile) {
        const uint8_t *profile = f->profile + (size_t)y * (size_t)width;
        for (x = 0; x < width; ++x)
            if (profile[x] == job->profile) depth[x] = 0;
    } else {
        ms_sss__fill(depth, 0, width, 0);
    }
    if (f->strength.channel[0]) {
        ms_sss__load(job->simd, &f->strength, 1, width, y, 0, padded, &buffer, &map);
        job->simd->mask_by(map, 0, padded, depth, span);
        ms_sss__narrow(job, span, &first, &last);
    }
    if (f->depth.channel[0] && first < last) {
        ms_sss__load(job->simd, &f->depth, 1, width, y, first, last - first, &buffer, &map);
        job->simd->mask_by(map, job->pass.depth_scale, last - first, depth + first, part);
        span[0] = first + part[0];
        span[1] = first + part[1];
    }
}

/* Loads row y: color, and depth where it is unmasked. clear: color is 0 in all other columns; else in those of the
   row's blocks. Masked pixels are copied to the output. */
static void ms_sss__load_row(const ms_sss__job *job, int y, int task, int clear, float *const color[3], float *depth)
{
    ms_sss__row *row = &job->memory.row[y];
    const int width = job->frame.width, right = (int)job->memory.stride - MS_SSS__LEFT;
    float *buffer[3], *to[3];
    const float *in[3];
    int c, span[2];
    ms_sss__load_depth(job, y, task, depth, span);
    ms_sss__narrow(job, span, &row->first, &row->last);
    row->valid_first = row->valid_last = 0;
    for (c = 0; c < 3; ++c) {
        buffer[c] = ms_sss__buffer(job, task, MS_SSS__ROW_LIGHT + c);
        to[c] = color[c] + row->first;
        if (!clear) continue;
        ms_sss__fill(color[c], -MS_SSS__LEFT, row->first, 0);
        ms_sss__fill(color[c], row->last, right, 0);
    }
    if (row->first < row->last) {
        const int first = row->first, count = row->last - row->first;
        ms_sss__load(job->simd, &job->frame.input, 3, width, y, first, count, buffer, in);
        if (job->simd->load_masked(in, span[0] - first, span[1] - first, count, depth + first, to)) {
            row->valid_first = span[0];
            row->valid_last = span[1] < width ? span[1] : job->memory.padded;
        } else {
            ms_sss__find_valid_run(job, row, depth);
        }
    }
    /* the first kernel copies what it masks: later ones write over what is theirs */
    if (!job->in_place && job->profile == 0 && job->term == 0 && !ms_sss__all_valid(job, y, 0, width)) {
        for (c = 0; c < 3; ++c) in[c] = ms_sss__pixel(&job->frame.input, c, 0, y);
        ms_sss__copy(&job->frame.output, width, y, 0, width, in, job->frame.input.pixel_stride, depth, 1);
    }
}

/* Adds up the terms of columns [x, x + count) of row y, of which blur is the term's second pass; after the last term
   writes the result. */
static void ms_sss__add_term(const ms_sss__job *job, int task, int y, int x, int count, float *const blur[3],
                             const float *depth)
{
    const ms_sss_frame *f = &job->frame;
    const float *light[3], *sum[3], *result[3], *strength = NULL;
    float *buffer[3], *map = ms_sss__buffer(job, task, MS_SSS__ROW_MAP);
    int c;
    for (c = 0; c < 3; ++c) {
        result[c] = blur[c];
        buffer[c] = ms_sss__buffer(job, task, MS_SSS__ROW_LIGHT + c);
        if (job->terms == 1) continue;
        {
            float *to = job->memory.sum[c] + y * job->memory.stride + x;
            sum[c] = to;
            if (job->term + 1 < job->terms)
                job->simd->combine(job->pass.scale[c], blur[c], job->term ? 1.0f : 0.0f, job->term ? to : blur[c],
                                   count, to);
        }
    }
    if (job->term + 1 < job->terms) return;
    ms_sss__load(job->simd, &f->input, 3, f->width, y, x, count, buffer, light);
    if (f->strength.channel[0]) ms_sss__load(job->simd, &f->strength, 1, f->width, y, x, count, &map, &strength);
    job->simd->finish(&job->pass, strength, depth, light, job->terms > 1 ? sum : NULL, count, blur);
    ms_sss__copy(&f->output, f->width, y, x, count, result, 1, depth, 0);
}

/* --- taps: two passes over the rows --- */

/* Slopes and tangent planes of row y: along x to `along`, along y to the planes of the second pass. */
static void ms_sss__tangent_row(const ms_sss__job *job, int task, int y, float *const along[3])
{
    const ms_sss__memory *m = &job->memory;
    const ms_sss_image *normals = &job->frame.normal;
    const int first = m->row[y].first, last = m->row[y].last;
    const float *depth[5], *normal[3];
    float *buffer[3], *slope[2], *out[6];
    int c;
    for (c = 0; c < 5; ++c) depth[c] = m->depth + ms_sss__clamp(y + c - 2, -1, job->frame.height) * m->stride;
    for (c = 0; c < 3; ++c) {
        buffer[c] = ms_sss__buffer(job, task, MS_SSS__ROW_LIGHT + c);
        out[c] = along[c];
        out[3 + c] = m->plane[c] + y * m->stride;
    }
    for (c = 0; c < 2; ++c) slope[c] = ms_sss__buffer(job, task, MS_SSS__ROW_SLOPE + c);
    if (normals->channel[0]) {
        ms_sss__load(job->simd, normals, 3, job->frame.width, y, first, last - first, buffer, normal);
        for (c = 0; c < 3; ++c) normal[c] -= first;
    }
    job->simd->slopes(&job->pass, depth, normals->channel[0] ? normal : NULL, y, first, last, slope);
    job->simd->tangents(&job->pass, depth[2], (const float *const *)slope, y, first, last, out);
}

/* Whether taps of columns [first, last) of row y, `reach` rows up and down, need no weights but their own: parallel
   rays, depth does not count, nothing is masked or outside. */
static int ms_sss__plain(const ms_sss__job *job, int y, int reach, int first, int last)
{
    int i;
    if (job->by != MS_SSS__BY_INTERPOLATION || y < reach || y + reach >= job->frame.height) return 0;
    for (i = y - reach; i <= y + reach; ++i)
        if (!ms_sss__all_valid(job, i, first, last)) return 0;
    return 1;
}

static void ms_sss__filter_columns(const ms_sss__job *job, ms_sss__line *l, int first, int last, int plain)
{
    l->first = first;
    l->last = last;
    if (first < last)
        job->simd->taps(&job->pass, !plain && job->by == MS_SSS__BY_INTERPOLATION ? MS_SSS__BY_DEPTH : job->by, l);
}

/* Filters row y along x, in place: taps read a copy. */
static void ms_sss__first_row(const ms_sss__job *job, int task, int y)
{
    const ms_sss__memory *m = &job->memory;
    const int reach = job->pass.reach_px[0], width = job->frame.width;
    ms_sss__row *row = &m->row[y];
    float *along[3];
    ms_sss__line l;
    int c, a, b; /* [a, b): no tap is masked or outside */
    if (row->first == row->last) return;
    memset(&l, 0, sizeof l);
    l.count = m->padded;
    l.from[3] = m->depth + y * m->stride;
    for (c = 0; c < 3; ++c) {
        float *copy = ms_sss__buffer(job, task, MS_SSS__ROW_COPY + c);
        l.to[c] = m->color[c] + y * m->stride;
        ms_sss__fill(copy, -MS_SSS__LEFT, row->first, 0);
        memcpy(copy + row->first, l.to[c] + row->first, (size_t)(row->last - row->first) * sizeof(float));
        ms_sss__fill(copy, row->last, (int)m->stride - MS_SSS__LEFT, 0);
        l.from[c] = copy;
        l.plane[c] = along[c] = ms_sss__buffer(job, task, MS_SSS__ROW_TANGENT + c);
    }
    if (job->by == MS_SSS__BY_SURFACE) ms_sss__tangent_row(job, task, y, along);
    a = ms_sss__round_up(row->valid_first + reach, 16);
    b = ((row->valid_last < width ? row->valid_last : width) - reach) / 16 * 16;
    if (a >= b || !ms_sss__plain(job, y, 0, a, b)) a = b = row->last;
    ms_sss__filter_columns(job, &l, row->first, a, 0);
    ms_sss__filter_columns(job, &l, a, b, 1);
    ms_sss__filter_columns(job, &l, b, row->last, 0);
}

/* Loads a band of rows. Slopes need the rows around: without them the first pass follows at once. */
static void ms_sss__load_band(void *context, int task)
{
    const ms_sss__job *job = (const ms_sss__job *)context;
    const ms_sss__memory *m = &job->memory;
    int y, c;
    for (y = ms_sss__band_begin(job, task); y < ms_sss__band_end(job, task); ++y) {
        float *color[3];
        for (c = 0; c < 3; ++c) color[c] = m->color[c] + y * m->stride;
        ms_sss__load_row(job, y, task, 1, color, m->depth + y * m->stride);
        if (job->by != MS_SSS__BY_SURFACE) ms_sss__first_row(job, task, y);
    }
}

static void ms_sss__first_pass(void *context, int task)
{
    const ms_sss__job *job = (const ms_sss__job *)context;
    int y;
    for (y = ms_sss__band_begin(job, task); y < ms_sss__band_end(job, task); ++y) ms_sss__first_row(job, task, y);
}

/* Filters a band of rows along y, strip by strip, and writes the result. */
static void ms_sss__second_pass(void *context, int task)
{
    const ms_sss__job *job = (const ms_sss__job *)context;
    const ms_sss__memory *m = &job->memory;
    int x, y, c;
    for (x = 0; x < m->padded; x += MS_SSS__STRIP)
        for (y = ms_sss__band_begin(job, task); y < ms_sss__band_end(job, task); ++y) {
            const int first = m->row[y].first > x ? m->row[y].first : x,
                      last = m->row[y].last < x + MS_SSS__STRIP ? m->row[y].last : x + MS_SSS__STRIP;
            float *blur[3];
            ms_sss__line l;
            if (first >= last) continue;
            l.stride = m->stride;
            l.at = y;
            l.count = job->frame.height;
            l.from[3] = m->depth + y * m->stride;
            for (c = 0; c < 3; ++c) {
                l.from[c] = m->color[c] + y * m->stride;
                l.plane[c] = job->by == MS_SSS__BY_SURFACE ? m->plane[c] + y * m->stride : NULL;
                l.to[c] = ms_sss__buffer(job, task, MS_SSS__ROW_OUT + c);
                blur[c] = l.to[c] + first;
            }
            ms_sss__filter_columns(job, &l, first, last, ms_sss__plain(job, y, job->pass.reach_px[1], first, last));
            ms_sss__add_term(job, task, y, first, last - first, blur, l.from[3] + first);
        }
}

/* Filters the pixels of a profile by all terms of its kernel. */
static void ms_sss__apply(ms_sss__job *job, const ms_sss_kernel *kernel, int profile)
{
    const int with_depth = job->frame.depth.channel[0] != NULL;
    ms_sss__set_kernel(&job->pass, &job->view, kernel, &job->options, with_depth);
    job->profile = profile;
    job->terms = kernel->term_count;
    job->identity = !job->view.perspective && job->pass.pixels_per_mm <= job->pass.pixels_per_mm_half;
    job->by = ms_sss__uses_slopes(&job->options, with_depth)                     ? MS_SSS__BY_SURFACE
        : job->view.perspective || ms_sss__uses_depth(&job->options, with_depth) ? MS_SSS__BY_DEPTH
                                                                                 : MS_SSS__BY_INTERPOLATION;
    for (job->term = 0; job->term < job->terms; ++job->term) {
        ms_sss__set_term(&job->pass, &job->view, kernel, job->term);
        ms_sss__run_rows(job, job->frame.height, ms_sss__load_band);
        if (job->identity) return;
        if (job->by == MS_SSS__BY_SURFACE) ms_sss__run_rows(job, job->frame.height, ms_sss__first_pass);
        ms_sss__run_rows(job, job->frame.height, ms_sss__second_pass);
    }
}

/* ---- pyramid code ---------------------------------------------------------------------------------------------- */

/* Planes of a level: color, d, coverage, changes of d along x and y, sums of light, sums of weights. */
enum { MS_SSS__D = 3, MS_SSS__CHANGES = 5, MS_SSS__SUMS = 7, MS_SSS__PYRAMID_PLANES = 13 };

enum {
    MS_SSS__PYRAMID_ROWS = 12, /* of a task: coverage and changes of d of four rows; or sums and those of one row */
    MS_SSS__PYRAMID_MARGIN = 4 /* rows above and below a level that a gather may read */
};

typedef struct ms_sss__level {
    int width, height;
    ptrdiff_t stride;
    float *plane[MS_SSS__PYRAMID_PLANES]; /* level 0: color and d alone */
    ms_sss__row *row;                     /* first and last are multiples of 16 */
} ms_sss__level;

typedef struct ms_sss__pyramid_state {
    ms_sss__job job;      /* first: tasks get its address */
    ms_sss_kernel kernel; /* see ms_sss__pyramid_kernel */
    ms_sss__level level[MS_SSS_PYRAMID_LEVELS];
    int levels, at; /* at: level of the run at hand */
    ms_sss__pyramid_params params;
    ms_sss__gather_tap tap[2][2][64];
    float *rows; /* [TASKS][PYRAMID_ROWS] row buffers */
} ms_sss__pyramid_state;

static float *ms_sss__pyramid_row(const ms_sss__pyramid_state *state, int task, int row)
{
    return state->rows + ((ptrdiff_t)task * MS_SSS__PYRAMID_ROWS + row) * state->level[0].stride + MS_SSS__LEFT;
}

/* Places the levels and row buffers behind the job's memory, or counts them (arena->base NULL). */
static void ms_sss__pyramid_levels(ms_sss__pyramid_state *state, int width, int height, ms__arena *arena)
{
    const size_t rows = (size_t)ms_sss__stride(width) * MS_SSS__TASKS * MS_SSS__PYRAMID_ROWS;
    float *buffers = (float *)ms__take(arena, rows, sizeof(float));
    int l, i;
    if (arena->base) state->rows = buffers;
    for (l = 0; l < MS_SSS_PYRAMID_LEVELS; ++l) {
        const ptrdiff_t stride = ms_sss__stride(width), margin = stride * MS_SSS__PYRAMID_MARGIN;
        const size_t plane = ms__size_mul((size_t)stride, (size_t)height + 2 * (size_t)MS_SSS__PYRAMID_MARGIN);
        const int first = l ? 0 : (int)MS_SSS__D, count = l ? (int)MS_SSS__PYRAMID_PLANES : 1;
        float *p = (float *)ms__take(arena, ms__size_mul(plane, (size_t)count), sizeof(float));
        ms_sss__row *row = (ms_sss__row *)ms__take(arena, l ? (size_t)height : 0, sizeof(ms_sss__row));
        if (arena->base) {
            ms_sss__level *v = &state->level[l];
            for (i = first; i < first + count; ++i, p += plane) {
                memset(p, 0, (size_t)margin * sizeof(float));
                memset(p + margin + stride * height, 0, (size_t)margin * sizeof(float));
                v->plane[i] = p + margin + MS_SSS__LEFT;
            }
            v->width = width;
            v->height = height;
            v->stride = stride;
            v->row = l ? row : state->job.memory.row;
            state->levels = l + 1;
        }
        if (width <= 2 && height <= 2) break;
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
}

/* Coverage and changes of d of row y of the picture, columns [first, last). */
static void ms_sss__pyramid_slopes(const ms_sss__pyramid_state *state, int task, int y, int first, int last,
                                   float *const out[3])
{
    const ms_sss__job *job = &state->job;
    const ms_sss__level *v = &state->level[0];
    const int given = job->frame.normal.channel[0] && state->params.slope_scale > 0;
    const float *d[5], *normal[3];
    float *buffer[3];
    int i;
    for (i = 0; i < 5; ++i) d[i] = v->plane[MS_SSS__D] + ms_sss__clamp(y + i - 2, -1, v->height) * v->stride;
    for (i = 0; i < 3; ++i) buffer[i] = ms_sss__buffer(job, task, MS_SSS__ROW_LIGHT + i);
    if (given) ms_sss__load(job->simd, &job->frame.normal, 3, v->width, y, first, last - first, buffer, normal);
    for (i = 0; i < 3 && given; ++i) normal[i] -= first;
    job->simd->slopes_of_d(&state->params, d, given ? normal : NULL, y, first, last, out);
}

/* Loads a band of the picture into level 0. */
static void ms_sss__pyramid_load(void *context, int task)
{
    const ms_sss__pyramid_state *state = (const ms_sss__pyramid_state *)context;
    const ms_sss__job *job = &state->job;
    const ms_sss__level *v = &state->level[0];
    float *depth = ms_sss__buffer(job, task, MS_SSS__ROW_DEPTH), *color[3];
    int y, c;
    for (y = ms_sss__band_begin(job, task); y < ms_sss__band_end(job, task); ++y) {
        const ms_sss__row *row = &v->row[y];
        for (c = 0; c < 3; ++c) color[c] = v->plane[c] + y * v->stride;
        ms_sss__load_row(job, y, task, 0, color, depth);
        job->simd->depth_to_d(&state->params, depth + row->first, row->last - row->first,
                              v->plane[MS_SSS__D] + y * v->stride + row->first);
    }
}

/* Clears the margins of a band of level `at`: beside the filled columns of each row, as far as rows up to
   PYRAMID_MARGIN away reach. */
static void ms_sss__pyramid_clear(void *context, int task)
{
    const ms_sss__pyramid_state *state = (const ms_sss__pyramid_state *)context;
    const ms_sss__level *v = &state->level[state->at];
    const int right = (int)v->stride - MS_SSS__LEFT, margin = MS_SSS__PYRAMID_MARGIN;
    const int planes = state->at == 0 ? (int)MS_SSS__D + 1 : (int)MS_SSS__PYRAMID_PLANES;
    int y, i, c;
    for (y = ms_sss__band_begin(&state->job, task); y < ms_sss__band_end(&state->job, task); ++y) {
        int low = right, high = -MS_SSS__LEFT, first = v->row[y].first, last = v->row[y].last;
        for (i = y > margin ? y - margin : 0; i <= y + margin && i < v->height; ++i) {
            if (v->row[i].first >= v->row[i].last) continue;
            if (v->row[i].first - 48 < low) low = v->row[i].first - 48;
            if (v->row[i].last + 48 > high) high = v->row[i].last + 48;
        }
        low = ms_sss__clamp(low, -MS_SSS__LEFT, right);
        high = ms_sss__clamp(high, low, right);
        if (first >= last) first = last = low; /* nothing is filled */
        for (c = 0; c < planes; ++c) {
            float *row = v->plane[c] + y * v->stride;
            memset(row + low, 0, (size_t)(first - low) * sizeof(float));
            memset(row + last, 0, (size_t)(high - last) * sizeof(float));
        }
    }
}

/* The rows of level `at` that row y of the next level reads, each color, d, coverage, changes of d. Those of the
   picture are made here, in a ring of four rows; fresh: all, else the lower two. */
static void ms_sss__pyramid_four_rows(const ms_sss__pyramid_state *state, int task, int y, int fresh,
                                      const float *row[4][7])
{
    const ms_sss__level *fine = &state->level[state->at];
    int i, c;
    for (i = 0; i < 4; ++i) {
        const int at = ms_sss__clamp(2 * y - 1 + i, -1, fine->height);
        float *slope[3];
        for (c = 0; c < (state->at > 0 ? 7 : 4); ++c) row[i][c] = fine->plane[c] + at * fine->stride;
        if (state->at > 0) continue;
        for (c = 0; c < 3; ++c) row[i][4 + c] = slope[c] = ms_sss__pyramid_row(state, task, 3 * (at & 3) + c);
        if (!fresh && i < 2) continue;
        for (c = 0; c < 3; ++c) memset(slope[c] - MS_SSS__LEFT, 0, (size_t)fine->stride * sizeof(float));
        if (at >= 0 && at < fine->height && fine->row[at].first < fine->row[at].last)
            ms_sss__pyramid_slopes(state, task, at, fine->row[at].first, fine->row[at].last, slope);
    }
}

/* Downsamples level `at` to a band of the next. */
static void ms_sss__pyramid_down(void *context, int task)
{
    const ms_sss__pyramid_state *state = (const ms_sss__pyramid_state *)context;
    const ms_sss__level *fine = &state->level[state->at], *v = fine + 1;
    const int begin = ms_sss__band_begin(&state->job, task), end = ms_sss__band_end(&state->job, task);
    ms_sss__pyramid_params params = state->params;
    int y, i, c;
    params.step *= (float)(1 << state->at);
    params.radius_px /= (float)(1 << state->at);
    params.radius_px_most /= (float)(1 << state->at);
    for (y = begin; y < end; ++y) {
        int first = v->width, last = 0;
        const float *row[4][7];
        float *out[7];
        for (i = 2 * y; i < 2 * y + 2 && i < fine->height; ++i) {
            if (fine->row[i].first >= fine->row[i].last) continue;
            if (fine->row[i].first / 2 < first) first = fine->row[i].first / 2;
            if ((fine->row[i].last + 1) / 2 > last) last = (fine->row[i].last + 1) / 2;
        }
        first = first < last ? first / 16 * 16 : 0;
        last = ms_sss__round_up(last, 16);
        v->row[y].first = first;
        v->row[y].last = last;
        ms_sss__pyramid_four_rows(state, task, y, y == begin, row);
        if (first >= last) continue;
        for (i = 0; i < 7; ++i) out[i] = v->plane[i] + y * v->stride;
        state->job.simd->downsample(&params, row, first, last, out);
        for (i = 0; i < 7; ++i)
            for (c = v->width; c < last; ++c) out[i][c] = 0;
    }
}

/* Resolves row y of the picture from its sums and writes it. */
static void ms_sss__pyramid_resolve(const ms_sss__pyramid_state *state, int task, int y, float *const slope[3],
                                    float *const sum[6])
{
    const ms_sss__job *job = &state->job;
    const ms_sss__level *v = &state->level[0];
    const int first = v->row[y].first, last = v->row[y].last;
    const float *row[4];
    float *blur[4];
    int c;
    for (c = 0; c < 4; ++c) {
        row[c] = v->plane[c] + y * v->stride;
        blur[c] = ms_sss__buffer(job, task, c < 3 ? MS_SSS__ROW_OUT + c : (int)MS_SSS__ROW_DEPTH);
    }
    job->simd->resolve(&state->params, row, v->stride, (const float *const *)slope, (const float *const *)sum, first,
                       last, blur);
    for (c = 0; c < 4; ++c) blur[c] += first;
    ms_sss__add_term(job, task, y, first, last - first, blur, blur[3]);
}

/* Gathers the sums of a band of level `at` from the next level; level 0 is resolved. */
static void ms_sss__pyramid_up(void *context, int task)
{
    const ms_sss__pyramid_state *state = (const ms_sss__pyramid_state *)context;
    const ms_sss__job *job = &state->job;
    const ms_sss__level *v = &state->level[state->at], *coarse = v + 1;
    int y, i;
    for (y = ms_sss__band_begin(job, task); y < ms_sss__band_end(job, task); ++y) {
        const int low = v->row[y].first, high = v->row[y].last;
        const int first = low / 32 * 32, last = ms_sss__round_up(high, 32); /* the gather steps by 2 vectors */
        const float *own[3];
        float *sum[6], *slope[3];
        if (low >= high) continue;
        for (i = 0; i < 6; ++i)
            sum[i] = state->at > 0 ? v->plane[MS_SSS__SUMS + i] + y * v->stride : ms_sss__pyramid_row(state, task, i);
        own[0] = v->plane[MS_SSS__D] + y * v->stride;
        for (i = 0; i < 3; ++i) slope[i] = ms_sss__pyramid_row(state, task, 6 + i);
        for (i = 1; i < 3; ++i) own[i] = state->at > 0 ? v->plane[MS_SSS__CHANGES + i - 1] + y * v->stride : slope[i];
        if (state->at == 0) {
            ms_sss__pyramid_slopes(state, task, y, low, high, slope);
            for (i = 0; i < 3; ++i) {
                ms_sss__fill(slope[i], first, low, 0);
                ms_sss__fill(slope[i], high, last, 0);
            }
        }
        if (state->at + 1 == state->levels)
            for (i = 0; i < 6; ++i) ms_sss__fill(sum[i], first, last, 0);
        else
            job->simd->gather(&state->params, own, coarse->plane[0] + y / 2 * coarse->stride, first / 2, last / 2, y,
                              sum);
        if (state->at == 0) ms_sss__pyramid_resolve(state, task, y, slope, sum);
    }
}

/* A pass over the rows of level l. */
static void ms_sss__pyramid_run(ms_sss__pyramid_state *state, int l, void (*pass)(void *context, int task))
{
    ms_sss__run_rows(&state->job, state->level[l].height, pass);
}

/* The taps by odd and even rows and columns, nearest first; stride: of the next level. */
static void ms_sss__pyramid_sort_taps(ms_sss__pyramid_params *params, ms_sss__gather_tap tap[2][2][64],
                                      ptrdiff_t stride)
{
    int y, x, i, j, n = 0;
    for (y = 0; y < 2; ++y)
        for (x = 0; x < 2; ++x)
            for (n = 0, i = 0; i < 64; ++i) {
                ms_sss__gather_tap t;
                t.at = (i / 8 - 4 + y) * stride + i % 8 - 4 + x;
                t.x = (x ? -3.25f : -3.75f) + (float)(i % 8);
                t.y = (y ? -3.25f : -3.75f) + (float)(i / 8);
                t.square = t.x * t.x + t.y * t.y;
                if (!params->wide && (t.x < -3 || t.x > 3 || t.y < -3 || t.y > 3)) continue;
                for (j = n++; j > 0 && tap[y][x][j - 1].square > t.square; --j) tap[y][x][j] = tap[y][x][j - 1];
                tap[y][x][j] = t;
            }
    params->tap = (const ms_sss__gather_tap(*)[2][64])tap;
    params->taps = n;
}

/* The sum of the gather's weights, and the means of powers of the distance between entry and exit of light. Both have a
   random position in their pixels: the variance of (1, 3, 3, 1) / 8 down to the level. */
static void ms_sss__pyramid_tap_sums(ms_sss__pyramid_params *params, int level)
{
    const double coarse = 0.5 * (1 - pow(4, -level - 1)), fine = 0.125 * (1 - pow(4, -level));
    double n = 0, r1 = 0, r2 = 0, r4 = 0;
    int i;
    for (i = 0; i < 64; ++i) {
        const double x = i % 8 - 3.75, y = i / 8 - 3.75, r = x * x + y * y + coarse - fine,
                     t = fmax(1 - (x * x + y * y) / (double)MS_SSS__GATHER(params->wide, level), 0),
                     w = t * t * (params->wide ? t : 1);
        n += w;
        r1 += w * sqrt(x * x + y * y + coarse);
        r2 += w * r;
        r4 += w * r * r;
    }
    params->level = level;
    params->norm = (float)(1 / n);
    params->mean = (float)(r1 / r2);
    params->spread = (float)(r2 / r4);
    params->bend = (float)(0.5 * r2 / (r2 - n * (coarse - fine)));
    params->blur = (float)coarse;
    /* Rounding of two depths; the slopes' error averages over the level, but counts for each of their 3.5 pixels there
       and back; each level's sums add a few roundings. */
    params->plane_rounding = 10 * (0.5f * params->rounding + 2.4e-7f * (float)(level + 1)) /
        (params->step * (float)(1 << (level + 1)));
}

/* A kernel of one tap that has the pyramid's radius: it gives the job its sizes. */
static void ms_sss__pyramid_kernel(const ms_sss_pyramid *pyramid, ms_sss_kernel *k)
{
    int c;
    memset(k, 0, sizeof *k);
    k->tap_count = k->term_count = 1;
    k->radius_mm = pyramid->radius_mm;
    for (c = 0; c < 3; ++c) k->weight[0][0][c] = k->scale[0][c] = 1;
}

/* Sets the parameters that all levels share. pass: of the pyramid's kernel, without slopes. */
static void ms_sss__pyramid_set_params(ms_sss__pyramid_params *params, const ms_sss__pass *pass,
                                       const ms_sss_pyramid *pyramid, const ms_sss_filter_options *o, int with_depth)
{
    const double radius = (double)pyramid->radius_mm;
    double sigma;
    int c;
    memset(params, 0, sizeof *params);
    params->table = pyramid->weight[o->exact];
    params->wide = o->exact;
    params->perspective = pass->perspective;
    params->depth_aware = ms_sss__uses_depth(o, with_depth);
    params->slope_scale = params->depth_aware ? 1 - o->flat : 0;
    params->radius_px = pass->pixels_per_mm * pyramid->radius_mm;
    params->radius_px_most = pass->pixels_per_mm_most * pyramid->radius_mm;
    params->step = 1 / pass->focal[0];
    params->rounding = pass->rounding + (params->perspective ? 1.2e-7f : 0); /* the division rounds again */
    for (c = 0; c < 2; ++c) params->middle[c] = pass->middle[c];
    params->tangent = params->perspective ? params->step : 0;
    sigma = o->depth_sigma_mm > 0 ? (double)o->depth_sigma_mm : (0.12 + 0.13 * (1 - (double)o->flat)) * radius;
    params->reach = (float)(MS_SSS__FALLOFF_END * sigma / radius); /* there (1 - q)^4 has the Gaussian's width */
    params->merge_reach = o->depth_sigma_mm > 0
        ? params->reach
        : params->reach + (1.5f - 0.7686f) * (1 - o->flat); /* the reach of a gather */
    for (c = 0; c < 3; ++c) {
        params->elevation_4[c] = pyramid->elevation[c] * (params->slope_scale / 4);
        params->max_factor[c] = pyramid->reflectance[c] > 0 && pyramid->reflectance[c] < 1 ? 1 / pyramid->reflectance[c]
                                                                                           : 1;
    }
}

/* Filters the pixels of a profile by its pyramid: load, down, up. */
static void ms_sss__pyramid_apply(ms_sss__pyramid_state *state, const ms_sss_pyramid *pyramid, int profile)
{
    ms_sss__job *job = &state->job;
    const int with_depth = job->frame.depth.channel[0] != NULL;
    ms_sss_filter_options flat = job->options; /* the pyramid has slopes of its own */
    ms_sss_kernel *kernel = &state->kernel;
    int l;
    flat.flat = 1;
    ms_sss__pyramid_kernel(pyramid, kernel);
    ms_sss__set_kernel(&job->pass, &job->view, kernel, &flat, with_depth);
    ms_sss__set_term(&job->pass, &job->view, kernel, 0);
    job->profile = profile;
    job->terms = 1;
    job->term = 0;
    job->identity = !job->view.perspective && job->pass.pixels_per_mm <= job->pass.pixels_per_mm_half;
    ms_sss__pyramid_set_params(&state->params, &job->pass, pyramid, &job->options, with_depth);
    state->at = 0;
    ms_sss__pyramid_run(state, 0, ms_sss__pyramid_load);
    if (job->identity) return;
    ms_sss__pyramid_run(state, 0, ms_sss__pyramid_clear);
    for (l = 1; l < state->levels; ++l) {
        state->at = l - 1;
        ms_sss__pyramid_run(state, l, ms_sss__pyramid_down);
        state->at = l;
        ms_sss__pyramid_run(state, l, ms_sss__pyramid_clear);
    }
    for (l = state->levels - 1; l >= 0; --l) {
        state->at = l;
        ms_sss__pyramid_tap_sums(&state->params, l);
        state->params.sums = l + 2 < state->levels;
        if (l + 1 < state->levels) {
            state->params.plane = state->level[l + 1].plane[1] - state->level[l + 1].plane[0];
            ms_sss__pyramid_sort_taps(&state->params, state->tap, state->level[l + 1].stride);
        }
        ms_sss__pyramid_run(state, l, ms_sss__pyramid_up);
    }
}

/* ---- filter calls ---------------------------------------------------------------------------------------------- */

/* Fills in the strides. */
static MS_SSS__COLD ms_status ms_sss__check_image(ms_sss_image *image, const char *name, int channels, int needed,
                                                  int width, int height, ms_error *error)
{
    const ptrdiff_t limit = PTRDIFF_MAX / 8;
    int c;
    if (!image->channel[0]) {
        if (!needed) return MS_OK;
        return MS_SSS__REFUSE(error, "%s: no pixels were given", name);
    }
    for (c = 1; c < channels; ++c)
        if (!image->channel[c]) return MS_SSS__REFUSE(error, "%s: channel %d has no pixels", name, c);
    if (image->pixel_stride == 0) image->pixel_stride = 1;
    if (image->pixel_stride > limit / width || image->pixel_stride < -(limit / width))
        return MS_SSS__REFUSE(error, "%s: pixel_stride is too large", name);
    if (image->row_stride == 0) image->row_stride = image->pixel_stride * width;
    if (image->row_stride > limit / height || image->row_stride < -(limit / height))
        return MS_SSS__REFUSE(error, "%s: row_stride is too large", name);
    return MS_OK;
}

static MS_SSS__COLD ms_status ms_sss__check_sides(int width, int height, ms_error *error)
{
    if (width >= 1 && height >= 1 && width <= MS_SSS__SIDE_MAX && height <= MS_SSS__SIDE_MAX) return MS_OK;
    return MS_SSS__REFUSE(error, "width, height %d, %d: expected 1 to %d each", width, height, (int)MS_SSS__SIDE_MAX);
}

/* Fills in the strides. */
static MS_SSS__COLD ms_status ms_sss__check_frame(ms_sss_frame *f, int needs_depth, ms_error *error)
{
    const struct {
        ms_sss_image *image;
        const char *name;
        int channels, needed;
    } pictures[] = {{&f->input, "input", 3, 1},
                    {&f->output, "output", 3, 1},
                    {&f->depth, "depth", 1, needs_depth},
                    {&f->strength, "strength", 1, 0},
                    {&f->normal, "normal", 3, 0}};
    ms_status status = MS_OK;
    size_t i;
    for (i = 0; i < sizeof pictures / sizeof pictures[0] && status == MS_OK; ++i)
        status = ms_sss__check_image(pictures[i].image, pictures[i].name, pictures[i].channels, pictures[i].needed,
                                     f->width, f->height, error);
    return status;
}

static MS_SSS__COLD ms_status ms_sss__check_options(const ms_sss_filter_options *o, ms_error *error)
{
    static const char *const name[] = {"ortho_height", "mm_per_unit", "depth_sigma_mm"};
    const float length[] = {o->ortho_height, o->mm_per_unit, o->depth_sigma_mm}, *a = o->pixels_per_mm;
    const int sizes = ms_sss__differ(a[0], 0) + ms_sss__differ(o->fov_degrees, 0) + ms_sss__differ(o->ortho_height, 0);
    const ms_sss__range ranges[] = {{"flat", (double)o->flat, 0, 1},
                                    {"center[0]", (double)o->center[0], -1e6, 1e6},
                                    {"center[1]", (double)o->center[1], -1e6, 1e6},
                                    {"exact", (double)o->exact, 0, 1},
                                    {"depth_mode", (double)o->depth_mode, 0, (double)MS_SSS_DEPTH_SCALE}};
    int i;
    if (sizes != 1)
        return MS_SSS__REFUSE(error, "%d of pixels_per_mm, fov_degrees and ortho_height are set; exactly one is needed",
                              sizes);
    if (ms_sss__differ(a[0], 0) && !(ms_sss__positive(a[0]) && a[1] >= 0 && ms__finite_f(a[1])))
        return MS_SSS__REFUSE(error, "pixels_per_mm %g, %g: expected positive numbers", (double)a[0], (double)a[1]);
    if (ms_sss__differ(o->fov_degrees, 0) && !(o->fov_degrees > 0 && o->fov_degrees < 180))
        return MS_SSS__REFUSE(error, "fov_degrees %g is not within (0, 180)", (double)o->fov_degrees);
    for (i = 0; i < 3; ++i)
        if (ms_sss__differ(length[i], 0) && !ms_sss__positive(length[i]))
            return MS_SSS__REFUSE(error, "%s %g is not positive", name[i], (double)length[i]);
    return ms_sss__check_ranges(ranges, sizeof ranges / sizeof ranges[0], error);
}

static MS_SSS__COLD ms_status ms_sss__check_pyramid(const ms_sss_pyramid *p, int index, ms_error *error)
{
    const float *weight = &p->weight[0][0][0][0][0];
    size_t i;
    if (!ms_sss__positive(p->radius_mm))
        return MS_SSS__REFUSE_AT(error, index,
                                 "pyramid %d: radius_mm %g is not positive; ms_sss_pyramid_make fills a pyramid", index,
                                 (double)p->radius_mm);
    for (i = 0; i < sizeof p->weight / sizeof(float); ++i)
        if (!(weight[i] >= 0 && weight[i] <= 1))
            return MS_SSS__REFUSE_AT(error, index, "pyramid %d: weight %d is %g; 0 to 1 expected", index, (int)i,
                                     (double)weight[i]);
    for (i = 0; i < 3; ++i)
        if (!(fabsf(p->elevation[i]) <= 1e6f))
            return MS_SSS__REFUSE_AT(error, index, "pyramid %d: elevation[%d] is beyond 1e6", index, (int)i);
    return MS_OK;
}

/* Refuses a scene whose units are likely not millimeters: mm_per_unit was not given, and the smallest kernel covers
   half of the picture, in the mean over up to 64 x 64 pixels. */
static MS_SSS__COLD ms_status ms_sss__check_scale(const ms_sss_frame *f, const ms_sss_filter_options *o,
                                                  double radius_mm, ms_error *error)
{
    const ms_sss__view v = ms_sss__make_view(o, f->width, f->height);
    const int side = ms_sss__longer_side(&v), step_x = (f->width + 63) / 64, step_y = (f->height + 63) / 64;
    const double size = radius_mm * v.pixels_per_mm;
    double sum = v.perspective ? 0 : size;
    int x, y, n = !v.perspective;
    if (o->mm_per_unit > 0 || o->pixels_per_mm[0] > 0) return MS_OK;
    for (y = step_y / 2; y < f->height && v.perspective; y += step_y)
        for (x = step_x / 2; x < f->width; x += step_x) {
            const float z = *ms_sss__pixel(&f->depth, 0, x, y);
            if (!ms_sss__positive(z)) continue;
            sum += size / (double)z < side ? size / (double)z : side;
            ++n;
        }
    if (!(sum > 0.5 * side * n)) return MS_OK;
    return MS_SSS__REFUSE(error,
                          "a radius of %g mm covers half of the picture: mm_per_unit is needed, "
                          "1000 for a scene in meters, 1 if it is in mm",
                          radius_mm);
}

/* Checks what both filters share, whose kernels or pyramids are `of`, and begins the job; its memory is taken
   afterwards. */
static MS_SSS__COLD ms_status ms_sss__begin(ms_sss__job *job, const ms_sss_frame *frame, const char *name,
                                            const void *of, int count, const ms_sss_filter_options *options,
                                            ms_error *error)
{
    const ms_sss_image *from = &job->frame.input, *to = &job->frame.output;
    ms_status status;
    if (!frame) return MS_SSS__REFUSE(error, "frame is NULL");
    if (!of) return MS_SSS__REFUSE(error, "%ss is NULL", name);
    if (!options) return MS_SSS__REFUSE(error, "options is NULL");
    if (count < 1 || count > 256) return MS_SSS__REFUSE(error, "%s_count %d is not within 1 to 256", name, count);
    memset(job, 0, sizeof *job);
    job->frame = *frame;
    job->options = *options;
    if ((status = ms_sss__check_sides(frame->width, frame->height, error)) != MS_OK ||
        (status = ms_sss__check_options(options, error)) != MS_OK ||
        (status = ms_sss__check_frame(&job->frame, options->fov_degrees > 0, error)) != MS_OK)
        return status;
    job->view = ms_sss__make_view(options, frame->width, frame->height);
    job->simd = ms_sss__pick(options->simd);
    job->in_place = from->pixel_stride == to->pixel_stride && from->row_stride == to->row_stride &&
        from->channel[0] == to->channel[0] && from->channel[1] == to->channel[1] && from->channel[2] == to->channel[2];
    return MS_OK;
}

/* The memory of a call: the caller's, or *owned, which the caller of this frees. */
static MS_SSS__COLD ms_status ms_sss__get_workspace(void *workspace, size_t size, size_t needed, ms__arena *arena,
                                                    void **owned, ms_error *error)
{
    *owned = NULL;
    if (!workspace && !size) {
        workspace = *owned = needed < SIZE_MAX ? malloc(needed) : NULL;
        if (!workspace) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a workspace of %z bytes", needed);
    } else if (!workspace || size < needed) {
        return MS_SSS__REFUSE(error, "a workspace of %z bytes: expected %z", workspace ? size : 0, needed);
    }
    *arena = ms_sss__place_in(workspace);
    return MS_OK;
}

MS_API ms_sss_filter_options ms_sss_filter_defaults(void)
{
    ms_sss_filter_options o;
    memset(&o, 0, sizeof o);
    return o;
}

static ms_sss_image ms_sss__make_image(const float *red, const float *green, const float *blue, int pixel_stride)
{
    ms_sss_image image;
    image.channel[0] = (float *)(uintptr_t)red;
    image.channel[1] = (float *)(uintptr_t)green;
    image.channel[2] = (float *)(uintptr_t)blue;
    image.pixel_stride = pixel_stride;
    image.row_stride = 0;
    return image;
}

MS_API ms_sss_image ms_sss_interleaved(const float *pixels, int channels)
{
    return ms_sss__make_image(pixels, pixels ? pixels + 1 : NULL, pixels ? pixels + 2 : NULL, channels);
}

MS_API ms_sss_image ms_sss_planar(const float *red, const float *green, const float *blue)
{
    return ms_sss__make_image(red, green, blue, 0);
}

MS_API ms_sss_image ms_sss_map(const float *values, int stride)
{
    return ms_sss__make_image(values, NULL, NULL, stride);
}

static void ms_sss__filter_memory(ms_sss__memory *m, int width, int height, const ms_sss_kernel *kernels,
                                  int kernel_count, const ms_sss_filter_options *options, ms__arena *arena)
{
    int i, terms = 1;
    for (i = 0; i < kernel_count; ++i)
        if (kernels[i].term_count > terms) terms = kernels[i].term_count;
    ms_sss__take_memory(m, width, height, 1, ms_sss__uses_slopes(options, 1), terms > 1, arena);
}

MS_API size_t ms_sss_filter_workspace(int width, int height, const ms_sss_kernel *kernels, int kernel_count,
                                      const ms_sss_filter_options *options)
{
    ms__arena arena = {NULL, 0};
    ms_sss__memory memory;
    if (ms_sss__check_sides(width, height, NULL) != MS_OK || !kernels || !options || kernel_count < 1 ||
        kernel_count > 256)
        return SIZE_MAX;
    ms_sss__filter_memory(&memory, width, height, kernels, kernel_count, options, &arena);
    return ms__size_add(arena.used, 63);
}

/* Clears the empty rows above and below the planes of light and depth. */
static void ms_sss__clear_borders(const ms_sss__memory *m, int height)
{
    const int right = (int)m->stride - MS_SSS__LEFT;
    int c, side;
    for (side = 0; side < 2; ++side) {
        const ptrdiff_t at = (side ? height : -1) * m->stride;
        for (c = 0; c < 3; ++c) ms_sss__fill(m->color[c] + at, -MS_SSS__LEFT, right, 0);
        if (m->depth) ms_sss__fill(m->depth + at, -MS_SSS__LEFT, right, MS_SSS__MASKED_DEPTH);
    }
}

MS_API ms_status ms_sss_filter(const ms_sss_frame *frame, const ms_sss_kernel *kernels, int kernel_count,
                               const ms_sss_filter_options *options, void *workspace, size_t workspace_size,
                               ms_error *error)
{
    ms_sss__job job;
    ms__arena arena;
    ms_status status;
    void *owned;
    int i, least = 0;
    status = ms_sss__begin(&job, frame, "kernel", kernels, kernel_count, options, error);
    for (i = 0; i < kernel_count && status == MS_OK; ++i) {
        status = ms_sss__check_kernel(&kernels[i], i, error);
        if (kernels[i].radius_mm < kernels[least].radius_mm) least = i;
    }
    if (status == MS_OK) status = ms_sss__check_scale(&job.frame, options, (double)kernels[least].radius_mm, error);
    if (status == MS_OK)
        status = ms_sss__get_workspace(
            workspace, workspace_size,
            ms_sss_filter_workspace(frame->width, frame->height, kernels, kernel_count, options), &arena, &owned,
            error);
    if (status != MS_OK) return status;
    ms_sss__filter_memory(&job.memory, frame->width, frame->height, kernels, kernel_count, options, &arena);
    ms_sss__clear_borders(&job.memory, frame->height);
    for (i = 0; i < kernel_count && (i == 0 || frame->profile); ++i) ms_sss__apply(&job, &kernels[i], i);
    free(owned);
    return MS_OK;
}

/* The state is in the workspace, too: it does not fit the stack. */
static ms_sss__pyramid_state *ms_sss__pyramid_memory(const ms_sss__job *job, int width, int height, ms__arena *arena)
{
    ms_sss__pyramid_state *state = (ms_sss__pyramid_state *)ms__take(arena, 1, sizeof *state);
    ms_sss__memory memory;
    int c;
    ms_sss__take_memory(&memory, width, height, 0, 0, 0, arena);
    if (state) {
        memset(state, 0, sizeof *state);
        state->job = *job;
        state->job.memory = memory;
        for (c = 0; c < 3; ++c) state->level[0].plane[c] = memory.color[c];
    }
    ms_sss__pyramid_levels(state, width, height, arena);
    return state;
}

MS_API size_t ms_sss_pyramid_workspace(int width, int height)
{
    ms__arena arena = {NULL, 0};
    if (ms_sss__check_sides(width, height, NULL) != MS_OK) return SIZE_MAX;
    ms_sss__pyramid_memory(NULL, width, height, &arena);
    return ms__size_add(arena.used, 63);
}

MS_API ms_status ms_sss_pyramid_filter(const ms_sss_frame *frame, const ms_sss_pyramid *pyramids, int pyramid_count,
                                       const ms_sss_filter_options *options, void *workspace, size_t workspace_size,
                                       ms_error *error)
{
    ms_sss__pyramid_state *state;
    ms_sss__job job;
    ms__arena arena;
    ms_status status;
    void *owned;
    int i, least = 0;
    status = ms_sss__begin(&job, frame, "pyramid", pyramids, pyramid_count, options, error);
    for (i = 0; i < pyramid_count && status == MS_OK; ++i) {
        status = ms_sss__check_pyramid(&pyramids[i], i, error);
        if (pyramids[i].radius_mm < pyramids[least].radius_mm) least = i;
    }
    if (status == MS_OK) status = ms_sss__check_scale(&job.frame, options, (double)pyramids[least].radius_mm, error);
    if (status != MS_OK) return status;
    if (job.view.aspect[1] < 1 || job.view.aspect[1] > 1)
        return ms__fail(error, MS_UNSUPPORTED, 0, "a pyramid is round: pixels_per_mm %g and %g differ",
                        (double)options->pixels_per_mm[0], (double)options->pixels_per_mm[1]);
    status = ms_sss__get_workspace(workspace, workspace_size, ms_sss_pyramid_workspace(frame->width, frame->height),
                                   &arena, &owned, error);
    if (status != MS_OK) return status;
    state = ms_sss__pyramid_memory(&job, frame->width, frame->height, &arena);
    ms_sss__clear_borders(&state->job.memory, frame->height);
    for (i = 0; i < pyramid_count && (i == 0 || frame->profile); ++i) ms_sss__pyramid_apply(state, &pyramids[i], i);
    free(owned);
    return MS_OK;
}

/* ---- GPU code -------------------------------------------------------------------------------------------------- */

/* float4: that all steps begin with; of a profile before its taps; of a pyramid before its tables */
enum { MS_SSS__SHADER_HEAD = 4, MS_SSS__PROFILE_HEAD = 5, MS_SSS__PYRAMID_HEAD = 3 };

static int ms_sss__is_pyramid_step(const ms_sss_shader *s) { return s->step >= MS_SSS_STEP_BASE; }

static int ms_sss__shader_profiles(const ms_sss_shader *s) { return s->profile_count > 0 ? s->profile_count : 1; }

static int ms_sss__shader_stride(const ms_sss_shader *s) { return MS_SSS__PROFILE_HEAD + s->tap_count / 2 + 1; }

/* The number of terms whose constants a step reads. */
static int ms_sss__shader_terms(const ms_sss_shader *s)
{
    return s->step == MS_SSS_STEP_UP && s->term_count > 1 ? s->term_count : 1;
}

static MS_SSS__COLD ms_status ms_sss__check_shader(const ms_sss_shader *s, ms_error *error)
{
    const int pyramid = s && ms_sss__is_pyramid_step(s);
    if (!s) return MS_SSS__REFUSE(error, "shader is NULL");
    {
        const ms_sss__range ranges[] = {{"step", (double)s->step, 0, (double)MS_SSS_STEP_RESOLVE},
                                        {"nearest", (double)s->nearest, 0, 3e38},
                                        {"fade", (double)s->fade, 0, 1},
                                        {"rotation", (double)s->rotation, -1e30, 1e30},
                                        {"jitter", (double)s->jitter, 0, 1},
                                        {"origin[0]", (double)s->origin[0], 0, 65536},
                                        {"origin[1]", (double)s->origin[1], 0, 65536},
                                        {"profile_count", (double)s->profile_count, 0, MS_SSS_SHADER_PROFILES_MAX},
                                        {"term_count", (double)s->term_count, 0, MS_SSS_TERMS_MAX},
                                        {"tap_count", (double)s->tap_count, pyramid ? -1e9 : 1, MS_SSS_TAPS_MAX}};
        const ms_status status = ms_sss__check_ranges(ranges, sizeof ranges / sizeof ranges[0], error);
        if (status != MS_OK) return status;
    }
    if (!pyramid && s->tap_count % 2 == 0)
        return MS_SSS__REFUSE(error, "tap_count %d: an odd number expected", s->tap_count);
    return MS_OK;
}

MS_API ms_sss_shader ms_sss_shader_defaults(void)
{
    ms_sss_shader s;
    memset(&s, 0, sizeof s);
    s.tap_count = 7;
    return s;
}

MS_API int ms_sss_shader_constant_count(const ms_sss_shader *shader)
{
    if (ms_sss__check_shader(shader, NULL) != MS_OK) return 0;
    if (ms_sss__is_pyramid_step(shader)) return MS_SSS__SHADER_HEAD + MS_SSS__PYRAMID_HEAD + 3 * MS_SSS_PYRAMID_SIZES;
    return MS_SSS__SHADER_HEAD +
        ms_sss__shader_terms(shader) * ms_sss__shader_profiles(shader) * ms_sss__shader_stride(shader);
}

MS_API int ms_sss_shader_levels(int width, int height)
{
    int levels = 1;
    while (levels < MS_SSS_PYRAMID_LEVELS && (width > 2 || height > 2)) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        ++levels;
    }
    return levels;
}

/* Refuses a kernel that shows stairs at shader->nearest: so many pairs of taps keep bands within MS_SSS_BANDS_SEEN up
   to a radius of so many pixels, the least of seven profiles, of skin1, marble, ketchup and four of Burley's, at radii
   from 6 to 188 pixels. */
static MS_SSS__COLD ms_status ms_sss__check_stairs(const ms_sss_kernel *k, const ms_sss__view *view,
                                                   const ms_sss_shader *s, ms_error *error)
{
    static const unsigned char most[13] = {0, 1, 4, 8, 12, 16, 23, 29, 47, 65, 90, 115, 150};
    double pixels = (double)k->radius_mm * view->pixels_per_mm;
    int pairs = k->tap_count / 2;
    if (!(s->nearest > 0)) return MS_OK;
    if (view->perspective) pixels /= (double)s->nearest;
    if (pixels > ms_sss__longer_side(view)) pixels = ms_sss__longer_side(view);
    if (s->half_resolution) pixels /= 2;
    while (pixels > (pairs <= 12 ? most[pairs] : pairs * pairs)) ++pairs;
    if (pairs == k->tap_count / 2) return MS_OK;
    return ms__fail(error, MS_UNSUPPORTED, 0,
                    "%d pixels with %d taps show bands: half resolution, %d taps or the pyramid", (int)pixels,
                    k->tap_count, 2 * pairs + 1);
}

/* What the constants of a pyramid's step have in place of the last of the head, and behind it. */
static void ms_sss__level_constants(const ms_sss_pyramid *pyramid, int profile, const ms_sss_filter_options *options,
                                    const ms_sss__view *view, const ms_sss_shader *shader, float (*out)[4])
{
    const int level = shader->level, coarser = ms_sss_shader_levels(view->width, view->height) - level - 1;
    const int next = level + 1 < MS_SSS_PYRAMID_LEVELS ? level + 1 : level;
    ms_sss_filter_options fast = *options;
    ms_sss_kernel kernel;
    ms_sss__pass pass;
    ms_sss__pyramid_params g;
    int i, table;
    fast.exact = 0;
    ms_sss__pyramid_kernel(pyramid, &kernel);
    ms_sss__set_kernel(&pass, view, &kernel, &fast, 1);
    ms_sss__pyramid_set_params(&g, &pass, pyramid, &fast, 1);
    ms_sss__pyramid_tap_sums(&g, level);
    if (!g.perspective) g.plane_rounding *= pass.depth_scale; /* depth as it is given */
    {
        const float own[1 + MS_SSS__PYRAMID_HEAD][4] = {
            {(float)(2 << level), (float)profile, pyramid->radius_mm,
             shader->step == MS_SSS_STEP_SHRINK ? g.merge_reach : g.reach},
            {g.elevation_4[0], g.elevation_4[1], g.elevation_4[2], (float)(coarser < 2 ? coarser : 2)},
            {g.max_factor[0], g.max_factor[1], g.max_factor[2], MS_SSS__GATHER(0, level)},
            {g.norm, g.mean, g.spread, g.plane_rounding}};
        memcpy(out + MS_SSS__SHADER_HEAD - 1, own, sizeof own);
    }
    out += MS_SSS__SHADER_HEAD + MS_SSS__PYRAMID_HEAD;
    for (table = 0; table < 3; ++table) /* of the next level; of the pixel's own light and its neighbors' */
        for (i = 0; i < MS_SSS_PYRAMID_SIZES; ++i, ++out)
            memcpy(out, table ? pyramid->weight[0][i][0][table - 1] : pyramid->weight[0][i][next][1],
                   3 * sizeof(float));
}

/* The constants of a kernel's term. A kernel without that term adds nothing. */
static MS_SSS__COLD void ms_sss__kernel_constants(const ms_sss_kernel *k, int wanted, ms_sss__pass *p, float (*at)[4])
{
    const int has = wanted < k->term_count, term = has ? wanted : 0;
    int i, c;
    ms_sss__totals(k, term, p->total, p->mixed);
    at[0][3] = k->radius_mm;
    at[1][3] = p->depth_scale;
    at[2][3] = p->average_dz * p->average_dz;
    at[3][3] = (float)(p->mixed[0] + 2 * p->mixed[1] + 4 * p->mixed[2]);
    for (c = 0; c < 3; ++c) {
        at[0][c] = p->total[c];
        at[1][c] = has ? k->scale[term][c] : 0;
        at[2][c] = has ? k->delta[c] : 0;
        at[3][c] = p->elevation_4[c];
        at[4][c] = p->root_r[c];
    }
    at[4][3] = p->least_sine;
    at += MS_SSS__PROFILE_HEAD;
    for (i = 0; i <= k->tap_count / 2; ++i) {
        for (c = 0; c < 3; ++c) at[i][c] = k->weight[term][i][c];
        at[i][3] = k->offset_mm[i];
    }
}

MS_SSS__COLD MS_API ms_status ms_sss_shader_constants(const ms_sss_kernel *kernels, int index,
                                                      const ms_sss_filter_options *options, int width, int height,
                                                      const ms_sss_shader *shader, float (*out)[4], ms_error *error)
{
    ms_sss__view view;
    ms_sss__pass pass;
    ms_status status;
    int pyramid, depth, count, terms = 0, i;
    if ((status = ms_sss__check_shader(shader, error)) != MS_OK) return status;
    if (!options) return MS_SSS__REFUSE(error, "options is NULL");
    if ((status = ms_sss__check_options(options, error)) != MS_OK) return status;
    if ((status = ms_sss__check_sides(width, height, error)) != MS_OK) return status;
    if (!out) return MS_SSS__REFUSE(error, "out is NULL");
    view = ms_sss__make_view(options, width, height);
    pyramid = ms_sss__is_pyramid_step(shader);
    count = ms_sss__shader_profiles(shader);
    if (pyramid) {
        const ms_sss__range ranges[] = {
            {"profile", (double)index, 0, (double)(count - 1)},
            {"level", (double)shader->level, 0, (double)(ms_sss_shader_levels(width, height) - 1)}};
        if (ms_sss__differ(shader->rotation, 0) || shader->jitter > 0 || ms_sss__differ(view.aspect[1], 1))
            return ms__fail(error, MS_UNSUPPORTED, 0, "a pyramid is round, without rotation or jitter");
        if (!shader->pyramids) return MS_SSS__REFUSE(error, "shader->pyramids is NULL");
        if ((status = ms_sss__check_ranges(ranges, 2, error)) != MS_OK) return status;
    } else if (!kernels) {
        return MS_SSS__REFUSE(error, "kernels is NULL");
    }
    for (i = 0; i < count && !pyramid; ++i) {
        const ms_sss_kernel *k = &kernels[i];
        if ((status = ms_sss__check_kernel(k, i, error)) != MS_OK) return status;
        if (k->tap_count > shader->tap_count)
            return MS_SSS__REFUSE_AT(error, i, "kernel %d has %d taps, more than the shader's tap_count %d", i,
                                     k->tap_count, shader->tap_count);
        if ((status = ms_sss__check_stairs(k, &view, shader, error)) != MS_OK) return status;
        if (k->term_count > terms) terms = k->term_count;
    }
    if (!pyramid && (index < 0 || index >= terms))
        return MS_SSS__REFUSE(error, "term %d is not within the kernels' %d", index, terms);

    /* all is checked before anything is written */
    memset(out, 0, (size_t)ms_sss_shader_constant_count(shader) * sizeof out[0]);
    depth = ms_sss__uses_depth(options, 1);
    {
        const float pixels = (float)view.pixels_per_mm, first = index == 0;
        const float mm_per_unit = pyramid && !depth ? 1e-20f : (float)view.mm_per_unit; /* nothing is deep */
        const float head[MS_SSS__SHADER_HEAD][4] = {
            {(float)width, (float)height, view.middle[0], view.middle[1]},
            {(float)shader->origin[0], (float)shader->origin[1], pixels, pixels * view.aspect[1]},
            {mm_per_unit, (float)view.perspective, depth ? 1 - options->flat : 0, 1 - shader->fade},
            {shader->rotation, shader->jitter, first, 0},
        };
        memcpy(out, head, sizeof head);
    }
    if (pyramid) ms_sss__level_constants(&shader->pyramids[index], index, options, &view, shader, out);
    for (i = 0; i < count * ms_sss__shader_terms(shader) && !pyramid; ++i) {
        const ms_sss_kernel *k = &kernels[i % count];
        const int term = shader->step == MS_SSS_STEP_UP ? i / count : index;
        ms_sss__set_kernel(&pass, &view, k, options, 1);
        ms_sss__kernel_constants(k, term, &pass, out + MS_SSS__SHADER_HEAD + i * ms_sss__shader_stride(shader));
    }
    return MS_OK;
}

#ifndef MS_SSS_NO_DESIGN
/* ---- small maths ------------------------------------------------------------------------------------------------- */

#define MS_SSS__PI 3.14159265358979323846

/* Solves A x = b for symmetric positive definite A [n][n] (lower triangle used, overwritten); x over b. 0: not
   positive definite. */
static int ms_sss__cholesky_solve(double *A, double *b, int n)
{
    int i, j, k;
    for (i = 0; i < n; ++i) {
        double *row = A + (size_t)i * (size_t)n;
        for (j = 0; j <= i; ++j) {
            const double *other = A + (size_t)j * (size_t)n;
            double sum = row[j];
            for (k = 0; k < j; ++k) sum -= row[k] * other[k];
            if (j < i) {
                row[j] = sum / other[j];
            } else {
                if (!(sum > 0)) return 0;
                row[i] = sqrt(sum);
            }
        }
        for (k = 0; k < i; ++k) b[i] -= row[k] * b[k];
        b[i] /= row[i];
    }
    for (i = n - 1; i >= 0; --i) {
        for (k = i + 1; k < n; ++k) b[i] -= A[(size_t)k * (size_t)n + (size_t)i] * b[k];
        b[i] /= A[(size_t)i * (size_t)n + (size_t)i];
    }
    return 1;
}

/* A sum of squares of n unknowns. evaluate returns its value at x, which it may move within bounds. With H it adds up
   the normal equations H step = g instead (lower triangle, from zeros), at the x of the call before. */
typedef struct ms_sss__squares {
    double (*evaluate)(const struct ms_sss__squares *problem, double *x, double *H, double *g);
    const struct ms_sss_designer *d;
    int n, channel;
    const double *curve; /* values by cell that the problem fits */
    double guide;
    struct ms_sss__fit *fit;
} ms_sss__squares;

/* Doubles of scratch for n unknowns. */
#define MS_SSS__DESCEND_SCRATCH(n) ((n) * (2 * (n) + 3))

/* Levenberg and Marquardt from x, which is improved in place; returns the value. */
static double ms_sss__descend(const ms_sss__squares *p, double *x, int rounds, double tolerance, double *scratch)
{
    const int n = p->n;
    double *H = scratch, *work = H + n * n, *g = work + n * n, *step = g + n, *trial = step + n;
    double lambda = 1e-2, least = p->evaluate(p, x, NULL, NULL), value = 0;
    double flat; /* of H: in directions that change nothing, the fit stays where it is */
    int round, tries, i;
    for (round = 0; round < rounds; ++round) {
        memset(H, 0, sizeof *H * (size_t)(n * n));
        memset(g, 0, sizeof *g * (size_t)n);
        p->evaluate(p, x, H, g);
        for (flat = DBL_MIN, i = 0; i < n; ++i) flat = fmax(flat, 1e-12 * H[i * n + i]);
        for (tries = 0; tries < 8; ++tries) { /* (H + lambda diag H) step = g */
            memcpy(work, H, sizeof *H * (size_t)(n * n));
            memcpy(step, g, sizeof *g * (size_t)n);
            for (i = 0; i < n; ++i) work[i * n + i] += lambda * fmax(H[i * n + i], flat);
            value = HUGE_VAL;
            if (ms_sss__cholesky_solve(work, step, n)) {
                for (i = 0; i < n; ++i) trial[i] = x[i] + step[i];
                value = p->evaluate(p, trial, NULL, NULL);
            }
            lambda *= value < least ? 0.2 : 6;
            if (value < least) break;
        }
        if (!(value < least)) break;
        memcpy(x, trial, sizeof *x * (size_t)n);
        i = least - value < tolerance * least;
        least = value;
        if (i) break;
    }
    return least;
}

/* The Bickley function Ki_1(x), the integral of K_0 from x to infinity: the trapezoidal rule on exp(-x cosh u) /
   cosh u. Its poles limit the error to exp(-pi^2 / step), its width 1/sqrt(x) to exp(-2 pi^2 / (x step^2)): below
   rounding for this step. */
static double ms_sss__bickley_1(double x)
{
    double sum = 0.5 * exp(-x), step = x > 7 ? 0.66 / sqrt(x) : 0.25, term = 1;
    int i;
    for (i = 1; term > 1e-18 * sum && i < 4000; ++i) {
        double c = cosh(step * i);
        sum += term = exp(-x * c) / c;
    }
    return step * sum;
}

/* Area of the intersection of the disc of radius r with [0, x] x [0, y]; odd in x and y. */
static double ms_sss__disc_corner(double x, double y, double r)
{
    double sign = (x < 0) != (y < 0) ? -1 : 1, t;
    x = fabs(x);
    y = fabs(y);
    if (x * x + y * y <= r * r) return sign * x * y;
    x = x < r ? x : r;
    y = y < r ? y : r;
    t = sqrt((r - y) * (r + y)); /* the arc meets height y here */
    if (x <= t) return sign * x * y;
    return sign * 0.5 * (y * t + x * sqrt((r - x) * (r + x)) + r * r * (asin(x / r) - asin(t / r)));
}

/* ---- profile tables -------------------------------------------------------------------------------------------- */

typedef enum ms_sss__profile_kind { MS_SSS__RINGS, MS_SSS__GAUSSIANS, MS_SSS__BURLEY } ms_sss__profile_kind;

/* R_d = mean + slope (r^2 - middle), where middle is that of the ring's r^2. */
typedef struct ms_sss__ring {
    double edge;      /* inner radius */
    double inside[3]; /* energy within it */
    double mean[3], slope[3];
} ms_sss__ring;

struct ms_sss_profile {
    ms_sss__profile_kind kind;
    int count;                              /* of rings or Gaussians */
    ms_sss__ring *ring;                     /* [count + 1] behind the profile; of the last one the edge and inside */
    double length[MS_SSS_GAUSSIANS_MAX][3]; /* sigma; Burley: d, count 1 */
    double weight[MS_SSS_GAUSSIANS_MAX][3]; /* Burley: reflectance */
    size_t bytes;
    ms_allocator allocator;
};

static ms_status ms_sss__profile_alloc(ms_sss_profile **out, ms_sss__profile_kind kind, int count,
                                       const ms_allocator *allocator, ms_error *error)
{
    const size_t rings = kind == MS_SSS__RINGS ? (size_t)count + 1 : 0;
    const size_t bytes = ms__size_add(sizeof(ms_sss_profile), ms__size_mul(rings, sizeof(ms_sss__ring)));
    ms_sss_profile *p = (ms_sss_profile *)ms__alloc(allocator, bytes);
    if (!p) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a profile of %z bytes", bytes);
    memset(p, 0, bytes);
    p->kind = kind;
    p->count = count;
    p->ring = (ms_sss__ring *)(void *)(p + 1);
    p->bytes = bytes;
    if (allocator != NULL) p->allocator = *allocator;
    *out = p;
    return MS_OK;
}

/* r^2 at the outer edge of ring i; half the sum of both edges'. */
static double ms_sss__outer2(const ms_sss_profile *p, int i) { return p->ring[i + 1].edge * p->ring[i + 1].edge; }
static double ms_sss__middle2(const ms_sss_profile *p, int i)
{
    return 0.5 * (p->ring[i].edge * p->ring[i].edge + ms_sss__outer2(p, i));
}

/* Energy of the part of a ring with r^2 in [ring's first, s]: pi times the integral of R_d over r^2. */
static double ms_sss__ring_energy(const ms_sss_profile *p, int c, int i, double s)
{
    const ms_sss__ring *ring = &p->ring[i];
    return MS_SSS__PI * (s - ring->edge * ring->edge) *
        (ring->mean[c] + ring->slope[c] * 0.5 * (s - ms_sss__outer2(p, i)));
}

static void ms_sss__profile_accumulate(ms_sss_profile *p)
{
    int c, i;
    for (i = 0; i < p->count; ++i)
        for (c = 0; c < 3; ++c)
            p->ring[i + 1].inside[c] = p->ring[i].inside[c] + ms_sss__ring_energy(p, c, i, ms_sss__outer2(p, i));
}

static MS_SSS__COLD ms_status ms_sss__check_table(int count, int least, const double *radius, int radii,
                                                  const double *const value[3], int stride, ms_error *error)
{
    int i, c;
    if (radius == NULL) return MS_SSS__REFUSE(error, "%s is NULL", least == 1 ? "edge_mm" : "r_mm");
    if (value == NULL) return MS_SSS__REFUSE(error, "value is NULL");
    for (c = 0; c < 3; ++c)
        if (value[c] == NULL) return MS_SSS__REFUSE(error, "value[%d] is NULL", c);
    if (count < least) return MS_SSS__REFUSE(error, "count is %d; at least %d expected", count, least);
    if (stride < 1) return MS_SSS__REFUSE(error, "stride is %d; 0 or more expected", stride);
    for (i = 0; i < radii; ++i)
        if (!ms__finite(radius[i]) || radius[i] < 0 || radius[i] > 1e9 || (i > 0 && radius[i] - radius[i - 1] < 1e-9))
            return MS_SSS__REFUSE_AT(error, i,
                                     "radius %d is %g mm; finite, 0 to 1e9, and increasing by 1e-9 at least expected",
                                     i, radius[i]);
    for (i = 0; i < count; ++i)
        for (c = 0; c < 3; ++c) {
            double v = value[c][(size_t)i * (size_t)stride];
            if (!ms__finite(v) || v < 0 || v > 1e30)
                return MS_SSS__REFUSE_AT(error, i, "R_d of row %d, channel %d is %g; finite, 0 to 1e30 expected", i, c,
                                         v);
        }
    return MS_OK;
}

MS_SSS__COLD MS_API ms_status ms_sss_profile_from_rings(ms_sss_profile **profile, int count, const double *edge_mm,
                                                        const double *const value[3], int stride,
                                                        const ms_allocator *allocator, ms_error *error)
{
    ms_sss_profile *p;
    ms_status status;
    int i, c;
    if (profile == NULL) return MS_SSS__REFUSE(error, "profile is NULL");
    *profile = NULL;
    if (stride == 0) stride = 1;
    status = ms_sss__check_table(count, 1, edge_mm, count + 1, value, stride, error);
    if (status == MS_OK) status = ms_sss__profile_alloc(&p, MS_SSS__RINGS, count, allocator, error);
    if (status != MS_OK) return status;
    for (i = 0; i <= count; ++i) p->ring[i].edge = edge_mm[i];
    for (c = 0; c < 3; ++c) {
        for (i = 0; i < count; ++i) p->ring[i].mean[c] = value[c][(size_t)i * (size_t)stride];
        for (i = 0; i + 1 < count; ++i) { /* van Leer's limited slope over r^2: zero at extrema, never below R_d = 0 */
            const double middle = ms_sss__middle2(p, i), mean = p->ring[i].mean[c];
            const double right = (p->ring[i + 1].mean[c] - mean) / (ms_sss__middle2(p, i + 1) - middle);
            const double left = i == 0 ? right : (mean - p->ring[i - 1].mean[c]) / (middle - ms_sss__middle2(p, i - 1));
            const double most = mean / (ms_sss__outer2(p, i) - middle);
            if (left * right > 0) p->ring[i].slope[c] = fmax(-most, fmin(2 * left * right / (left + right), most));
        }
    }
    ms_sss__profile_accumulate(p);
    *profile = p;
    return MS_OK;
}

MS_SSS__COLD MS_API ms_status ms_sss_profile_from_samples(ms_sss_profile **profile, int count, const double *r_mm,
                                                          const double *const value[3], int stride,
                                                          const ms_allocator *allocator, ms_error *error)
{
    ms_sss_profile *p;
    ms_status status;
    int i, c, inner;
    if (profile == NULL) return MS_SSS__REFUSE(error, "profile is NULL");
    *profile = NULL;
    if (stride == 0) stride = 1;
    status = ms_sss__check_table(count, 2, r_mm, count, value, stride, error);
    if (status != MS_OK) return status;
    inner = r_mm[0] > 0; /* one more ring, inside the first sample */
    status = ms_sss__profile_alloc(&p, MS_SSS__RINGS, count - 1 + inner, allocator, error);
    if (status != MS_OK) return status;
    for (c = 0; c < 3; ++c) p->ring[0].mean[c] = value[c][0];
    for (i = 0; i < count; ++i) {
        ms_sss__ring *ring = &p->ring[i + inner];
        ring->edge = r_mm[i];
        for (c = 0; c < 3 && i + 1 < count; ++c) {
            double v0 = value[c][(size_t)i * (size_t)stride], v1 = value[c][((size_t)i + 1) * (size_t)stride];
            ring->mean[c] = 0.5 * (v0 + v1);
            ring->slope[c] = (v1 - v0) / ((r_mm[i + 1] - r_mm[i]) * (r_mm[i + 1] + r_mm[i]));
        }
    }
    ms_sss__profile_accumulate(p);
    *profile = p;
    return MS_OK;
}

static MS_SSS__COLD ms_status ms_sss__from_lengths(ms_sss_profile **profile, ms_sss__profile_kind kind, int count,
                                                   const double (*length)[3], const double (*weight)[3],
                                                   const ms_allocator *allocator, ms_error *error)
{
    const int burley = kind == MS_SSS__BURLEY;
    const char *const length_name = burley ? "d_mm" : "sigma_mm",
                      *const weight_name = burley ? "reflectance" : "weight";
    ms_status status;
    int i, c;
    if (profile == NULL) return MS_SSS__REFUSE(error, "profile is NULL");
    *profile = NULL;
    if (length == NULL) return MS_SSS__REFUSE(error, "%s is NULL", length_name);
    if (weight == NULL) return MS_SSS__REFUSE(error, "%s is NULL", weight_name);
    if (count < 1 || count > MS_SSS_GAUSSIANS_MAX)
        return MS_SSS__REFUSE(error, "count is %d; 1 to %d expected", count, MS_SSS_GAUSSIANS_MAX);
    for (i = 0; i < count; ++i)
        for (c = 0; c < 3; ++c)
            if (!(length[i][c] >= 1e-9 && length[i][c] <= 1e9 && weight[i][c] >= 0 && weight[i][c] <= 1e9))
                return MS_SSS__REFUSE_AT(error, burley ? c : i,
                                         "entry %d, channel %d: %s %g, %s %g; 1e-9 to 1e9 and 0 to 1e9 expected", i, c,
                                         length_name, length[i][c], weight_name, weight[i][c]);
    status = ms_sss__profile_alloc(profile, kind, count, allocator, error);
    if (status != MS_OK) return status;
    memcpy((*profile)->length, length, sizeof *length * (size_t)count);
    memcpy((*profile)->weight, weight, sizeof *weight * (size_t)count);
    return MS_OK;
}

MS_API ms_status ms_sss_profile_from_gaussians(ms_sss_profile **profile, int count, const double (*sigma_mm)[3],
                                               const double (*weight)[3], const ms_allocator *allocator,
                                               ms_error *error)
{
    return ms_sss__from_lengths(profile, MS_SSS__GAUSSIANS, count, sigma_mm, weight, allocator, error);
}

MS_API ms_status ms_sss_profile_from_burley(ms_sss_profile **profile, const double reflectance[3], const double d_mm[3],
                                            const ms_allocator *allocator, ms_error *error)
{
    typedef const double(*rows)[3];
    return ms_sss__from_lengths(profile, MS_SSS__BURLEY, 1, (rows)d_mm, (rows)reflectance, allocator, error);
}

MS_API double ms_sss_burley_d_mm(double albedo, double mean_free_path_mm)
{
    const double off = fabs(albedo - 0.8), bright = albedo > 0.65 ? albedo - 0.65 : 0;
    return mean_free_path_mm / (1.85 - albedo + 7 * off * off * off - 1.25 * bright);
}

MS_API void ms_sss_profile_destroy(ms_sss_profile *profile)
{
    ms_allocator allocator;
    if (profile == NULL) return;
    allocator = profile->allocator;
    ms__release(&allocator, profile, profile->bytes);
}

/* The ring that holds r; count when r is beyond the last edge, -1 before the first. */
static int ms_sss__ring_of(const ms_sss_profile *p, double r)
{
    int low = -1, high = p->count;
    if (r >= p->ring[p->count].edge) return p->count;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (p->ring[middle].edge <= r) low = middle;
        else high = middle;
    }
    return low;
}

MS_SSS__COLD MS_API void ms_sss_profile_value(const ms_sss_profile *p, double r, double out[3])
{
    int c, i;
    if (p == NULL || out == NULL) return;
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) {
            i = ms_sss__ring_of(p, r);
            if (i < 0 || i >= p->count) continue;
            out[c] = p->ring[i].mean[c] + p->ring[i].slope[c] * (r * r - ms_sss__middle2(p, i));
            if (out[c] < 0) out[c] = 0; /* rounding */
            continue;
        }
        for (i = 0; i < p->count; ++i) {
            double s = p->length[i][c], w = p->weight[i][c];
            if (p->kind == MS_SSS__GAUSSIANS) out[c] += w * exp(-r * r / (2 * s * s)) / (2 * MS_SSS__PI * (s * s));
            else if (w > 0) out[c] = w * (exp(-r / s) + exp(-r / (3 * s))) / (8 * MS_SSS__PI * s * r);
        }
    }
}

MS_API void ms_sss_profile_disc(const ms_sss_profile *p, double r, double out[3])
{
    int c, i;
    if (p == NULL || out == NULL) return;
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) {
            i = ms_sss__ring_of(p, r);
            if (i >= 0) out[c] = p->ring[i].inside[c];
            if (i >= 0 && i < p->count) out[c] += ms_sss__ring_energy(p, c, i, r * r);
            if (out[c] < 0) out[c] = 0; /* rounding */
            continue;
        }
        for (i = 0; i < p->count; ++i) {
            double s = p->length[i][c], t = r / s;
            out[c] -= p->weight[i][c] *
                (p->kind == MS_SSS__GAUSSIANS ? expm1(-r * r / (2 * s * s)) : 0.25 * expm1(-t) + 0.75 * expm1(-t / 3));
        }
    }
}

MS_API void ms_sss_profile_reflectance(const ms_sss_profile *p, double out[3])
{
    if (p == NULL || out == NULL) return;
    ms_sss_profile_disc(p, p->kind == MS_SSS__RINGS ? p->ring[p->count].edge : 1e30, out);
}

MS_SSS__COLD MS_API void ms_sss_profile_radius(const ms_sss_profile *p, double fraction, double out[3])
{
    double total[3], inside[3];
    int c, i;
    if (p == NULL || out == NULL) return;
    ms_sss_profile_reflectance(p, total);
    for (c = 0; c < 3; ++c) {
        double low = 0, high = 1e-9;
        out[c] = 0;
        if (!(total[c] > 0)) continue;
        for (i = 0; i < 70; ++i) { /* the last radius that all doubles of 1e-9 mm to 1e12 mm need */
            ms_sss_profile_disc(p, high, inside);
            if (inside[c] >= fraction * total[c]) break;
            low = high;
            high *= 2;
        }
        while (high - low > 1e-10 * high && high > 1e-300) { /* below, halves are no longer smaller */
            double middle = 0.5 * (low + high);
            ms_sss_profile_disc(p, middle, inside);
            if (inside[c] >= fraction * total[c]) high = middle;
            else low = middle;
        }
        out[c] = high;
    }
}

/* The total and the 99% radius of each channel; the largest radius. */
static double ms_sss__extent(const ms_sss_profile *p, double total[3], double radius[3])
{
    double widest = 0;
    int c;
    ms_sss_profile_reflectance(p, total);
    ms_sss_profile_radius(p, 0.99, radius);
    for (c = 0; c < 3; ++c) widest = radius[c] > widest ? radius[c] : widest;
    return widest;
}

/* ---- pre-integration ------------------------------------------------------------------------------------------- */

MS_SSS__COLD MS_API void ms_sss_profile_strip(const ms_sss_profile *p, double x, double out[3])
{
    int c, i;
    if (p == NULL || out == NULL) return;
    x = fabs(x);
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) { /* a circle of radius r has the fraction 2/pi asin(x/r) of itself inside */
            double angle0 = 0.5 * MS_SSS__PI, u0 = 0, s0 = x * x;
            i = ms_sss__ring_of(p, x);
            if (i < 0) {
                const double r = p->ring[0].edge;
                i = 0;
                s0 = r * r;
                u0 = sqrt((r - x) * (r + x));
                angle0 = r > 0 ? asin(x / r) : angle0;
            } else {
                out[c] = p->ring[i].inside[c];
                if (i < p->count) out[c] += ms_sss__ring_energy(p, c, i, s0);
            }
            for (; i < p->count; ++i) {
                double r = p->ring[i + 1].edge, s1 = r * r, u1 = sqrt((r - x) * (r + x)), angle1 = asin(x / r);
                /* integrals over s = r^2 of asin(x/r) and of s asin(x/r) */
                double g0 = s1 * angle1 - s0 * angle0 + x * (u1 - u0);
                double g1 = 0.5 *
                    (s1 * s1 * angle1 - s0 * s0 * angle0 + x * (u1 * u1 * u1 - u0 * u0 * u0) / 3 +
                     x * x * x * (u1 - u0));
                out[c] += 2 * (p->ring[i].mean[c] * g0 + p->ring[i].slope[c] * (g1 - ms_sss__middle2(p, i) * g0));
                s0 = s1;
                u0 = u1;
                angle0 = angle1;
            }
            continue;
        }
        for (i = 0; i < p->count; ++i) {
            double s = p->length[i][c], t = x / s;
            out[c] += p->weight[i][c] *
                (p->kind == MS_SSS__GAUSSIANS
                     ? erf(x / (s * sqrt(2.0)))
                     : 1 - (ms_sss__bickley_1(t) + 3 * ms_sss__bickley_1(t / 3)) / (2 * MS_SSS__PI));
        }
    }
}

/* ---- cells and spectra ----------------------------------------------------------------------------------------- */

/* Everything below counts lengths in cells, which are the pixels of the design size, and frequencies in cycles per 512
   pixels. A kernel is even in x and y and symmetric under their exchange: cells are kept for i, j >= 0, its real
   spectrum for 0 <= k2 <= k1 <= 256. */
enum {
    MS_SSS__SIZE = 512,
    MS_SSS__HALF = 256,
    MS_SSS__OCTANT = (MS_SSS__HALF + 1) * (MS_SSS__HALF + 2) / 2,
    MS_SSS__CELLS_MAX = 128,
    MS_SSS__ROW_MAX = MS_SSS__CELLS_MAX + 1,
    MS_SSS__RINGS_MAX = 512,
    MS_SSS__SIGNALS = 4,    /* of ms_sss_errors */
    MS_SSS__TEXTURE = 3,    /* the last of them */
    MS_SSS__FIT_PAIRS = 16, /* of the 33 taps that are fitted */
    MS_SSS__NODES_MAX = 96,
    MS_SSS__BINS_MAX = MS_SSS__NODES_MAX * (MS_SSS__NODES_MAX + 1) / 2
};

struct ms_sss_designer {
    int cells; /* from the center to the edge of the square that holds the kernel */
    double cell_mm;
    double reflectance[3], width[3];                   /* 99% radius of each channel, cells */
    double mean_mm[3];                                 /* distance between entry and exit */
    int widest;                                        /* channel */
    double cosine[MS_SSS__SIZE];                       /* cos(2 pi i / 512) */
    double variance[MS_SSS__SIGNALS];                  /* of the signals after the true convolution, channels summed */
    double cell[3][MS_SSS__ROW_MAX * MS_SSS__ROW_MAX]; /* [cells + 1][cells + 1], the sum over all quadrants is 1 */
    double slice[3][MS_SSS__ROW_MAX];                  /* [cells + 1] R_d along the axis, any scale */
    double spectrum[3][MS_SSS__OCTANT];                /* of cell */
    float power[MS_SSS__SIGNALS][MS_SSS__OCTANT];      /* |signal|^2, summed over the 8 bins that share a value */
    double columns[(MS_SSS__HALF + 1) * MS_SSS__ROW_MAX]; /* [257][cells + 1], scratch of the spectra */
    ms_allocator allocator;
};

static int ms_sss__octant(int k1, int k2) { return k1 * (k1 + 1) / 2 + k2; }

/* The number of bins of the full spectrum that the octant's (k1, k2) represents. */
static int ms_sss__orbit(int k1, int k2)
{
    int n1 = k1 == 0 || k1 == MS_SSS__HALF ? 1 : 2, n2 = k2 == 0 || k2 == MS_SSS__HALF ? 1 : 2;
    return n1 * n2 * (k1 == k2 ? 1 : 2);
}

/* Radii of rings that are thin compared with a cell, near the center and near a pole at 0; returns their number. */
static int ms_sss__thin_rings(double outer, double *edge)
{
    int n = 0;
    double r;
    edge[n++] = 0;
    for (r = 1e-6; r < 0.125; r *= 1.6) edge[n++] = r;
    for (; r < outer + 0.5; r += r < 4 ? 0.125 : r < 12 ? 0.25 : 0.5) edge[n++] = r;
    return n - 1;
}

/* Integrals of R_d over the square cells, scaled to a total of 1. */
static void ms_sss__fill_cells(ms_sss_designer *d, const ms_sss_profile *p)
{
    const int cells = d->cells;
    const double h = d->cell_mm;
    double edge[MS_SSS__RINGS_MAX], density[MS_SSS__RINGS_MAX][3], inside[3] = {0, 0, 0}, disc[3], total;
    int rings = ms_sss__thin_rings(1.4143 * (cells + 0.5), edge), row = cells + 1, i, j, k, c;
    for (k = 0; k < rings; ++k) { /* energy between two radii over the ring's area */
        ms_sss_profile_disc(p, h * edge[k + 1], disc);
        for (c = 0; c < 3; ++c) {
            density[k][c] = (disc[c] - inside[c]) / (MS_SSS__PI * (edge[k + 1] - edge[k]) * (edge[k + 1] + edge[k]));
            inside[c] = disc[c];
        }
    }
    for (i = 0; i <= cells; ++i)
        for (j = 0; j <= i; ++j) {
            double x0 = i - 0.5, x1 = i + 0.5, y0 = j - 0.5, y1 = j + 0.5, sum[3] = {0, 0, 0}, before = 0;
            double nearest = hypot(i > 0 ? x0 : 0, j > 0 ? y0 : 0), farthest = hypot(x1, y1);
            for (k = 0; edge[k + 1] <= nearest;) ++k;
            for (; k < rings && edge[k] < farthest; ++k) { /* area of the intersection of ring and cell */
                double r = edge[k + 1];
                double area = ms_sss__disc_corner(x1, y1, r) - ms_sss__disc_corner(x0, y1, r) -
                    ms_sss__disc_corner(x1, y0, r) + ms_sss__disc_corner(x0, y0, r);
                for (c = 0; c < 3; ++c) sum[c] += density[k][c] * (area - before);
                before = area;
            }
            for (c = 0; c < 3; ++c) d->cell[c][i * row + j] = d->cell[c][j * row + i] = sum[c];
        }
    for (c = 0; c < 3; ++c) {
        if (p->kind == MS_SSS__GAUSSIANS) { /* separable: exact without rings */
            double g[MS_SSS__ROW_MAX];
            memset(d->cell[c], 0, sizeof(double) * (size_t)(row * row));
            for (k = 0; k < p->count; ++k) {
                double s = h / (p->length[k][c] * sqrt(2.0));
                for (i = 0; i <= cells; ++i) g[i] = 0.5 * (erf((i + 0.5) * s) - erf((i - 0.5) * s));
                for (i = 0; i <= cells; ++i)
                    for (j = 0; j <= cells; ++j) d->cell[c][i * row + j] += p->weight[k][c] * g[i] * g[j];
            }
        }
        total = 0;
        for (i = 0; i <= cells; ++i)
            for (j = 0; j <= cells; ++j) total += d->cell[c][i * row + j] * (i ? 2 : 1) * (j ? 2 : 1);
        if (!(total > 0)) { /* a channel without light: the identity */
            memset(d->cell[c], 0, sizeof(double) * (size_t)(row * row));
            total = d->cell[c][0] = 1;
        }
        for (i = 0; i < row * row; ++i) d->cell[c][i] /= total;
    }
}

/* The spectrum of a channel's cells. */
static void ms_sss__spectrum(ms_sss_designer *d, int c)
{
    const double *cell = d->cell[c];
    double *columns = d->columns, *out = d->spectrum[c];
    int row = d->cells + 1, i, j, k1, k2;
    for (k1 = 0; k1 <= MS_SSS__HALF / 2; ++k1) { /* along x; the even and the odd cells serve k1 and 256 - k1 */
        double *column = columns + k1 * row, *mirror = columns + (MS_SSS__HALF - k1) * row;
        double odd[MS_SSS__ROW_MAX];
        for (j = 0; j < row; ++j) column[j] = odd[j] = 0;
        for (i = 0; i < row; ++i) {
            double wave = (i ? 2 : 1) * d->cosine[k1 * i % MS_SSS__SIZE], *to = i % 2 ? odd : column;
            for (j = 0; j < row; ++j) to[j] += wave * cell[i * row + j];
        }
        for (j = 0; j < row; ++j) mirror[j] = column[j] - odd[j];
        for (j = 0; j < row; ++j) column[j] += odd[j];
    }
    for (k2 = 0; k2 <= MS_SSS__HALF; ++k2) {
        double wave[MS_SSS__ROW_MAX];
        for (j = 0; j < row; ++j) wave[j] = (j ? 2 : 1) * d->cosine[k2 * j % MS_SSS__SIZE];
        for (k1 = k2; k1 <= MS_SSS__HALF; ++k1) {
            const double *column = columns + k1 * row;
            double s0 = 0, s1 = 0;
            for (j = 0; j + 1 < row; j += 2) {
                s0 += wave[j] * column[j];
                s1 += wave[j + 1] * column[j + 1];
            }
            if (j < row) s0 += wave[j] * column[j];
            out[ms_sss__octant(k1, k2)] = s0 + s1;
        }
    }
}

/* The texture is one picture of the Gaussian process with power 1/f^2, band-limited as by a lens: its low frequencies
   are drawn (|S|^2 over its mean is exponentially distributed for each pair of conjugate bins), the others stand at
   their mean. Seed and band limit are fixed so that the published errors can be reproduced. The mean is 4.5 standard
   deviations, as of a photograph. */
static double ms_sss__texture_power(int k1, int k2)
{
    const double limit = 110, f2 = (double)k1 * k1 + (double)k2 * k2;
    return exp(-0.5 * f2 / (limit * limit)) / f2;
}

/* Number `index` of a bin's own sequence, uniform in (0, 1): Philox 4x32-10 (Salmon, Moraes, Dror, Shaw 2011, "Parallel
   random numbers: as easy as 1, 2, 3"). */
static double ms_sss__uniform(int bin, int index)
{
    uint32_t x[4] = {(uint32_t)(index / 2), 0, (uint32_t)bin, 0}, key[2] = {5935, 0};
    int round, half = index % 2 * 2;
    for (round = 0; round < 10; ++round, key[0] += 0x9E3779B9u, key[1] += 0xBB67AE85u) {
        const uint64_t p = (uint64_t)0xD2511F53u * x[0], q = (uint64_t)0xCD9E8D57u * x[2];
        x[0] = (uint32_t)(q >> 32) ^ x[1] ^ key[0];
        x[1] = (uint32_t)q;
        x[2] = (uint32_t)(p >> 32) ^ x[3] ^ key[1];
        x[3] = (uint32_t)p;
    }
    return ((double)(((uint64_t)x[half] << 32 | x[half + 1]) >> 12) + 0.5) / 4503599627370496.0;
}

static void ms_sss__signal_power(ms_sss_designer *d)
{
    enum { DRAWN = 24 };
    int k1, k2, n;
    double total = 0;
    for (k1 = 0; k1 <= MS_SSS__HALF; ++k1)
        for (k2 = 0; k2 <= k1; ++k2) {
            int o = ms_sss__octant(k1, k2), orbit = ms_sss__orbit(k1, k2);
            double edge = sin(MS_SSS__PI * k1 / (int)MS_SSS__SIZE), texture = 0;
            edge = k1 == 0 ? (double)(MS_SSS__HALF * MS_SSS__HALF) : k1 % 2 ? 1 / (edge * edge) : 0; /* 256 of 512 */
            d->power[0][o] = k2 == 0 ? (float)(edge * (k1 ? 2 : 1)) : 0;
            d->power[1][o] = k1 == k2 ? (float)(edge * (k1 ? 2 : 1)) : 0;
            d->power[2][o] = (float)orbit;
            if (k1 > 0) {
                texture = orbit;
                if (k1 < DRAWN)
                    for (texture = 0, n = 0; n < orbit; n += 2) texture -= 2 * log(ms_sss__uniform(o, n / 2));
                texture *= ms_sss__texture_power(k1, k2);
                total += texture;
            }
            d->power[MS_SSS__TEXTURE][o] = (float)texture;
        }
    d->power[MS_SSS__TEXTURE][0] = (float)(4.5 * 4.5 * total);
}

/* Mean of r over each channel's light, in mm; widest: any length of the profile's size. */
static MS_SSS__COLD void ms_sss__mean_distance(const ms_sss_profile *profile, const double total[3], double widest,
                                               double mean[3])
{
    const int steps = 1500;
    double inside[3] = {0, 0, 0}, disc[3], r = 0;
    int i, c;
    mean[0] = mean[1] = mean[2] = 0;
    for (i = 0; i < steps; ++i) { /* rings whose edges grow by 1% from 1e-5 to 30 widths */
        double outer = widest * exp(15.0 * i / (steps - 1) - 11.6);
        ms_sss_profile_disc(profile, outer, disc);
        for (c = 0; c < 3; ++c) mean[c] += total[c] > 0 ? (disc[c] - inside[c]) * 0.5 * (r + outer) / total[c] : 0;
        memcpy(inside, disc, sizeof inside);
        r = outer;
    }
}

/* The decay of a kernel by the channel's reflectance and mean distance. */
static double ms_sss__decay_of(double R, double mean)
{
    R = R < 0.9999 ? R : 0.9999;
    return R > 0 && mean > 0 ? (1 - R) * (0.52 - 0.6 * log(1 - R) + 0.625 * sqrt(R)) / mean : 0;
}

MS_API double ms_sss_elevation(double reflectance, double index)
{
    double q = 1 - (reflectance < 1 ? reflectance : 1), t = (index - 1) / 0.4;
    return reflectance > 0 ? 0.57 - 0.07 * t + (2.45 - 0.25 * t) * q + (1.8 + 0.7 * t) * pow(q, 6 + 6 * t) : 0;
}

MS_API ms_status ms_sss_designer_create(ms_sss_designer **designer, const ms_sss_profile *profile, double radius_px,
                                        const ms_allocator *allocator, ms_error *error)
{
    double radius[3], total[3], widest;
    ms_sss_designer *d;
    int c, s, o;
    if (designer == NULL || profile == NULL) return MS_SSS__REFUSE(error, "designer or profile is NULL");
    *designer = NULL;
    if (radius_px == 0) radius_px = 24;
    if (!(radius_px > 0 && radius_px <= 1e9))
        return MS_SSS__REFUSE(error, "radius_px is %g; above 0, at most 1e9 expected", radius_px);
    widest = ms_sss__extent(profile, total, radius);
    if (!(widest > 0)) return MS_SSS__REFUSE(error, "the profile holds no light in any channel");
    if (radius_px > (int)MS_SSS__CELLS_MAX) radius_px = (int)MS_SSS__CELLS_MAX;
    d = (ms_sss_designer *)ms__alloc(allocator, sizeof *d);
    if (!d) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a designer of %z bytes", sizeof *d);
    memset(d, 0, sizeof *d);
    d->cells = radius_px > 1 ? (int)(radius_px + 0.5) : 1;
    d->cell_mm = widest / (radius_px + 0.5);
    if (allocator != NULL) d->allocator = *allocator;
    for (c = 0; c < 3; ++c) {
        d->reflectance[c] = total[c];
        d->width[c] = radius[c] / d->cell_mm;
        if (radius[c] > radius[d->widest]) d->widest = c;
    }
    ms_sss__mean_distance(profile, total, widest, d->mean_mm);
    for (o = 0; o < MS_SSS__SIZE; ++o) d->cosine[o] = cos(2 * MS_SSS__PI * o / (int)MS_SSS__SIZE);
    ms_sss__signal_power(d);
    ms_sss__fill_cells(d, profile);
    for (o = 0; o <= d->cells; ++o) { /* a pole at 0 is read at an eighth of a cell */
        const int pole = o == 0 && profile->kind != MS_SSS__GAUSSIANS;
        double at[3];
        ms_sss_profile_value(profile, pole ? 0.125 * d->cell_mm : o * d->cell_mm, at);
        for (c = 0; c < 3; ++c) d->slice[c][o] = at[c];
    }
    for (c = 0; c < 3; ++c) {
        ms_sss__spectrum(d, c);
        for (s = 0; s < MS_SSS__SIGNALS; ++s)
            for (o = 1; o < MS_SSS__OCTANT; ++o)
                d->variance[s] += (double)d->power[s][o] * d->spectrum[c][o] * d->spectrum[c][o];
    }
    *designer = d;
    return MS_OK;
}

MS_API void ms_sss_designer_destroy(ms_sss_designer *designer)
{
    ms_allocator allocator;
    if (designer == NULL) return;
    allocator = designer->allocator;
    ms__release(&allocator, designer, sizeof *designer);
}

/* ---- kernel errors --------------------------------------------------------------------------------------------- */

/* Response of the taps at +-x to a wave of frequency k: the real part of a linear interpolation. slope: its derivative
   by x, or NULL. */
static double ms_sss__pair_transfer(const ms_sss_designer *d, int k, double x, double *slope)
{
    /* (1 - f) cos(w p) + f cos(w (p + 1)) at p = floor(x), f = x - p */
    const double p = floor(x), f = x - p;
    const int a = (int)p * k;
    const double first = d->cosine[a & (MS_SSS__SIZE - 1)], rise = d->cosine[(a + k) & (MS_SSS__SIZE - 1)] - first;
    if (slope != NULL) *slope = rise;
    return first + f * rise;
}

/* A kernel in cells and doubles, for design and measurement. Term t of channel c: sign w w^T. */
typedef struct ms_sss__curve {
    int pairs, terms;
    double offset[MS_SSS__ROW_MAX];                      /* [0] is the center */
    double weight[3][MS_SSS_TERMS_MAX][MS_SSS__ROW_MAX]; /* of the center, then of each tap of a pair */
    double sign[3][MS_SSS_TERMS_MAX];
    double delta[3], energy[3]; /* energy of delta and all terms: 1, but for SVD */
} ms_sss__curve;

/* One pass as a function of its frequency. */
typedef struct ms_sss__waves {
    float line[3][MS_SSS_TERMS_MAX][MS_SSS__HALF + 1]; /* float: relative errors below 1e-6 do not matter */
} ms_sss__waves;

/* Scratch memory of a measurement; too large for the stack. */
typedef struct ms_sss__measurement {
    ms_sss__curve curve;
    ms_sss__waves waves;
    double line[2][3][MS_SSS__HALF + 1]; /* right result, curve; by distance */
} ms_sss__measurement;

/* Response of one pass to a wave of each frequency: the taps of each term. */
static void ms_sss__curve_waves(const ms_sss_designer *d, const ms_sss__curve *v, ms_sss__waves *waves)
{
    double line[3][MS_SSS_TERMS_MAX];
    int k, t, c, i;
    for (k = 0; k <= MS_SSS__HALF; ++k) {
        for (c = 0; c < 3; ++c)
            for (t = 0; t < v->terms; ++t) line[c][t] = v->weight[c][t][0];
        for (i = 1; i <= v->pairs; ++i) {
            const double wave = 2 * ms_sss__pair_transfer(d, k, v->offset[i], NULL);
            for (c = 0; c < 3; ++c)
                for (t = 0; t < v->terms; ++t) line[c][t] += v->weight[c][t][i] * wave;
        }
        for (c = 0; c < 3; ++c)
            for (t = 0; t < v->terms; ++t) waves->line[c][t][k] = (float)line[c][t];
    }
}

/* Spectrum of one bin: delta + sum over the terms. waves as made above. */
static void ms_sss__curve_transfer(const ms_sss__curve *v, const ms_sss__waves *waves, int k1, int k2, double out[3])
{
    int t, c;
    for (c = 0; c < 3; ++c) {
        out[c] = v->delta[c];
        for (t = 0; t < v->terms; ++t)
            out[c] += v->sign[c][t] * (double)waves->line[c][t][k1] * (double)waves->line[c][t][k2];
    }
}

static void ms_sss__kernel_curve(const ms_sss_designer *d, const ms_sss_kernel *kernel, ms_sss__curve *v)
{
    int i, t, c;
    v->pairs = kernel->tap_count / 2;
    v->terms = kernel->term_count;
    for (i = 0; i <= v->pairs; ++i) {
        v->offset[i] = (double)kernel->offset_mm[i] / d->cell_mm;
        if (fabs(v->offset[i] - floor(v->offset[i] + 0.5)) < 1e-4) v->offset[i] = floor(v->offset[i] + 0.5); /* float */
        for (t = 0; t < v->terms; ++t)
            for (c = 0; c < 3; ++c) v->weight[c][t][i] = (double)kernel->weight[t][i][c];
    }
    for (c = 0; c < 3; ++c) {
        for (t = 0; t < v->terms; ++t) v->sign[c][t] = (double)kernel->scale[t][c];
        v->delta[c] = (double)kernel->delta[c];
        v->energy[c] = 1;
    }
}

/* Relative errors of a curve for every signal. */
static void ms_sss__curve_errors(const ms_sss_designer *d, const ms_sss__curve *v, ms_sss__waves *waves, double *error)
{
    double found[3];
    int k1, k2, c, s, o = 0;
    ms_sss__curve_waves(d, v, waves);
    for (s = 0; s < MS_SSS__SIGNALS; ++s) error[s] = 0;
    for (k1 = 0; k1 <= MS_SSS__HALF; ++k1)
        for (k2 = 0; k2 <= k1; ++k2, ++o) {
            double square = 0;
            ms_sss__curve_transfer(v, waves, k1, k2, found);
            for (c = 0; c < 3; ++c) square += (found[c] - d->spectrum[c][o]) * (found[c] - d->spectrum[c][o]);
            for (s = 0; s < MS_SSS__SIGNALS; ++s) error[s] += (double)d->power[s][o] * square;
        }
    for (s = 0; s < MS_SSS__SIGNALS; ++s) error[s] = sqrt(error[s] / d->variance[s]);
}

static double ms_sss__srgb(double v) /* linear 0 to 1 as 0 to 255 */
{
    v = v < 0 ? 0 : v > 1 ? 1 : v;
    return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055);
}

/* ms_sss_errors.bands: the spectrum's axis is that of the sums over the kernel's columns, whose running sum is the
   response to an edge. */
static double ms_sss__curve_bands(const ms_sss_designer *d, ms_sss__measurement *m)
{
    const ms_sss__curve *v = &m->curve;
    double found[3], most = 0;
    int k, c, x, n;
    memset(m->line, 0, sizeof m->line);
    ms_sss__curve_waves(d, v, &m->waves);
    for (k = 0; k <= MS_SSS__HALF; ++k) {
        double share = (k == 0 || k == MS_SSS__HALF ? 1.0 : 2.0) / (int)MS_SSS__SIZE;
        ms_sss__curve_transfer(v, &m->waves, k, 0, found);
        for (c = 0; c < 3; ++c)
            for (x = 0; x <= MS_SSS__HALF; ++x) {
                double wave = share * d->cosine[k * x & (MS_SSS__SIZE - 1)];
                m->line[0][c][x] += wave * d->spectrum[c][ms_sss__octant(k, 0)];
                m->line[1][c][x] += wave * found[c];
            }
    }
    for (c = 0; c < 3; ++c) {
        double sum[2] = {0, 0}, before[2] = {0, 0}, now[2] = {0, 0}, next[2];
        for (x = 1 - MS_SSS__HALF; x <= MS_SSS__HALF; ++x) {
            double bend;
            for (n = 0; n < 2; ++n) {
                sum[n] += m->line[n][c][x < 0 ? -x : x];
                next[n] = ms_sss__srgb(sum[n]);
            }
            bend = fabs(next[1] - 2 * now[1] + before[1] - (next[0] - 2 * now[0] + before[0]));
            if (bend > most) most = bend;
            memcpy(before, now, sizeof before);
            memcpy(now, next, sizeof now);
        }
    }
    return most;
}

MS_SSS__COLD MS_API ms_status ms_sss_kernel_measure(ms_sss_errors *errors, const ms_sss_kernel *kernel,
                                                    const ms_sss_designer *designer)
{
    double error[MS_SSS__SIGNALS];
    ms_sss__measurement *m;
    ms_status status;
    int i;
    if (errors == NULL || kernel == NULL || designer == NULL) return MS_INVALID_ARGUMENT;
    if ((status = ms_sss__check_kernel(kernel, 0, NULL)) != MS_OK) return status;
    for (i = 0; i <= kernel->tap_count / 2; ++i)
        if ((double)kernel->offset_mm[i] > 1e6 * designer->cell_mm) return MS_INVALID_ARGUMENT;
    m = (ms_sss__measurement *)ms__alloc(&designer->allocator, sizeof *m);
    if (m == NULL) return MS_OUT_OF_MEMORY;
    ms_sss__kernel_curve(designer, kernel, &m->curve);
    ms_sss__curve_errors(designer, &m->curve, &m->waves, error);
    memcpy(errors, error, sizeof error); /* in their order */
    errors->bands = ms_sss__curve_bands(designer, m);
    ms__release(&designer->allocator, m, sizeof *m);
    return MS_OK;
}

/* ---- taps ------------------------------------------------------------------------------------------------------ */

/* The frequencies over which taps are fitted: every one up to 12 + a third of the cells, as far as spectra of such
   kernels have detail that matters, then with gaps that grow in proportion. With `coarse` about a quarter of them, for
   searches. share: the number of the 512 frequencies that each node represents. Returns their count. */
static int ms_sss__nodes(int cells, int coarse, int *node, double *share)
{
    int count = 0, all = (12 + cells / 3) >> coarse, growth = coarse ? 3 : 6, k, n;
    for (k = 0; k < MS_SSS__HALF; k += k <= all ? 1 : 1 + (k - all / 2) / growth) node[count++] = k;
    node[count++] = MS_SSS__HALF;
    for (n = 0; n < count; ++n) { /* trapezoidal rule over both signs */
        double left = n > 0 ? node[n] - node[n - 1] : 0, right = n + 1 < count ? node[n + 1] - node[n] : 0;
        share[n] = left + right;
    }
    return count;
}

/* Sum of a term along one axis. */
static double ms_sss__term_sum(const ms_sss__curve *v, int c, int t)
{
    double sum = 0;
    int i;
    for (i = 0; i <= v->pairs; ++i) sum += (i ? 2 : 1) * v->weight[c][t][i];
    return sum;
}

/* Scales the terms so that with delta they hold the curve's energy. */
static void ms_sss__curve_normalize(ms_sss__curve *v)
{
    int c, t, i;
    for (c = 0; c < 3; ++c) {
        double terms = 0, scale;
        for (t = 0; t < v->terms; ++t) terms += v->sign[c][t] * ms_sss__term_sum(v, c, t) * ms_sss__term_sum(v, c, t);
        scale = terms > 0 ? sqrt((v->energy[c] - v->delta[c]) / terms) : 1;
        if (terms == 0 && v->energy[c] > v->delta[c]) /* taps that missed all light: the pixel's own */
            v->weight[c][0][0] = sqrt(v->energy[c] - v->delta[c]);
        for (t = 0; t < v->terms; ++t)
            for (i = 0; i <= v->pairs; ++i) v->weight[c][t][i] *= scale;
    }
}

/* A least-squares fit of taps to a target spectrum under a picture prior:
     minimize sum over bins of weight (target - delta - sum_t sign_t wave_t(node 1) wave_t(node 2))^2
   where wave(node) = w_0 + sum_i w_i basis_i(node) is one pass. Unknown are the offsets, which the channels share, and
   of each channel w_i = q_i^2 >= 0 of the first term, any w_i of the others, and delta = q^2; then all terms are scaled
   to keep the energy. A bin is a pair of nodes, in the order of the octant. */
typedef struct ms_sss__fit {
    const ms_sss_designer *d;
    int nodes, pairs, terms, use_delta;
    int unknowns, local; /* of all; that one channel's bins depend on */
    int node[MS_SSS__NODES_MAX];
    double weight[MS_SSS__BINS_MAX], target[MS_SSS__BINS_MAX][3];
    double basis[MS_SSS__NODES_MAX][MS_SSS__FIT_PAIRS]; /* of both taps of a pair */
    double slope[MS_SSS__NODES_MAX][MS_SSS__FIT_PAIRS]; /* d basis / d offset */
    double wave[3][MS_SSS_TERMS_MAX][MS_SSS__NODES_MAX];
    double jacobian[MS_SSS__FIT_PAIRS + MS_SSS_TERMS_MAX * (MS_SSS__FIT_PAIRS + 1) + 1]; /* [local] */
    double *x, *scratch; /* [unknowns]; of ms_sss__descend */
    ms_sss__curve trial, hop;
    ms_sss__waves waves;
    size_t bytes;
} ms_sss__fit;

/* The target is the spectrum of model, or of the profile if that is NULL. The prior is 1/f^2 over all bins, and as far
   as the dial is turned up 1/f^2 on the axes, which axis-parallel edges excite. Each part is divided by what the target
   itself has, so that they weigh relative errors. */
static void ms_sss__fit_bins(ms_sss__fit *fit, const ms_sss__curve *model, double dial, int coarse)
{
    double share[MS_SSS__NODES_MAX], all = 0, on_axis = 0;
    const int *node = fit->node;
    int a, b, c, n = 0;
    fit->nodes = ms_sss__nodes(fit->d->cells, coarse, fit->node, share);
    if (model != NULL) ms_sss__curve_waves(fit->d, model, &fit->waves);
    for (a = 0; a < fit->nodes; ++a)
        for (b = 0; b <= a; ++b, ++n) {
            double squares = 0;
            for (c = 0; c < 3; ++c) fit->target[n][c] = fit->d->spectrum[c][ms_sss__octant(node[a], node[b])];
            if (model != NULL) ms_sss__curve_transfer(model, &fit->waves, node[a], node[b], fit->target[n]);
            for (c = 0; c < 3; ++c) squares += fit->target[n][c] * fit->target[n][c];
            if (n > 0)
                fit->weight[n] = share[a] * share[b] * (a == b ? 1 : 2) * ms_sss__texture_power(node[a], node[b]);
            all += fit->weight[n] * squares;
            if (b == 0 && a > 0) on_axis += share[a] / ((double)node[a] * node[a]) * squares;
        }
    while (--n > 0) fit->weight[n] *= (1 - dial) / all;
    for (a = 1; a < fit->nodes; ++a)
        fit->weight[ms_sss__octant(a, 0)] += dial * share[a] / ((double)node[a] * node[a]) / on_axis;
}

static void ms_sss__fit_basis(ms_sss__fit *fit, const ms_sss__curve *v)
{
    int node, i;
    for (node = 0; node < fit->nodes; ++node)
        for (i = 0; i < fit->pairs; ++i) {
            fit->basis[node][i] = 2 *
                ms_sss__pair_transfer(fit->d, fit->node[node], v->offset[i + 1], &fit->slope[node][i]);
            fit->slope[node][i] *= 2;
        }
}

static double ms_sss__fit_objective(ms_sss__fit *fit, const ms_sss__curve *v)
{
    double sum = 0;
    int a, b, c, t, i, n;
    for (c = 0; c < 3; ++c)
        for (t = 0; t < fit->terms; ++t)
            for (a = 0; a < fit->nodes; ++a) {
                double wave = v->weight[c][t][0];
                for (i = 0; i < fit->pairs; ++i) wave += v->weight[c][t][i + 1] * fit->basis[a][i];
                fit->wave[c][t][a] = wave;
            }
    for (a = n = 0; a < fit->nodes; ++a)
        for (b = 0; b <= a; ++b, ++n)
            for (c = 0; c < 3; ++c) {
                double rest = fit->target[n][c] - v->delta[c];
                for (t = 0; t < fit->terms; ++t) rest -= v->sign[c][t] * fit->wave[c][t][a] * fit->wave[c][t][b];
                sum += fit->weight[n] * rest * rest;
            }
    return sum;
}

/* The derivatives of a bin's response by the offsets, the weights of channel c and the root of delta; returns the
   response of the terms. */
static double ms_sss__fit_bin(ms_sss__fit *fit, const ms_sss__curve *v, int c, int a, int b, const double *sum)
{
    const double *basis_a = fit->basis[a], *basis_b = fit->basis[b];
    double *J = fit->jacobian, found = 0;
    const double spread = v->energy[c] - v->delta[c];
    int t, i;
    memset(J, 0, sizeof *J * (size_t)fit->local);
    for (t = 0; t < fit->terms; ++t) {
        const double wave_a = fit->wave[c][t][a] * v->sign[c][t], wave_b = fit->wave[c][t][b] * v->sign[c][t];
        double *Jw = J + fit->pairs + t * (fit->pairs + 1);
        found += wave_a * fit->wave[c][t][b];
        Jw[0] += wave_a + wave_b;
        for (i = 0; i < fit->pairs; ++i) {
            Jw[i + 1] += basis_a[i] * wave_b + wave_a * basis_b[i];
            J[i] += v->weight[c][t][i + 1] * (fit->slope[a][i] * wave_b + wave_a * fit->slope[b][i]);
        }
    }
    for (t = 0; t < fit->terms; ++t) { /* all terms are scaled to keep sum_t sign_t sum_t^2 = energy - delta */
        double *Jw = J + fit->pairs + t * (fit->pairs + 1), pull = 2 * v->sign[c][t] * sum[t] * found / spread;
        for (i = 0; i <= fit->pairs; ++i) {
            Jw[i] -= (i ? 2 : 1) * pull;
            if (t == 0) Jw[i] *= 2 * sqrt(v->weight[c][0][i]); /* d w / d q */
        }
    }
    if (fit->use_delta) J[fit->local - 1] = 2 * sqrt(v->delta[c]) * (1 - found / spread);
    return found;
}

/* Normal equations of the curve whose waves the last objective left. */
static void ms_sss__fit_system(ms_sss__fit *fit, const ms_sss__curve *v, double *H, double *g)
{
    const double *J = fit->jacobian;
    int a, b, c, t, i, j, n;
    for (c = 0; c < 3; ++c) {
        const int own = c * (fit->local - fit->pairs); /* from a weight's place in J to its unknown */
        double sum[MS_SSS_TERMS_MAX];
        for (t = 0; t < fit->terms; ++t) sum[t] = ms_sss__term_sum(v, c, t);
        for (a = n = 0; a < fit->nodes; ++a)
            for (b = 0; b <= a; ++b, ++n) {
                const double found = ms_sss__fit_bin(fit, v, c, a, b, sum);
                const double rest = fit->target[n][c] - v->delta[c] - found;
                for (i = 0; i < fit->local; ++i) {
                    const int row = i < fit->pairs ? i : own + i;
                    const double Ji = fit->weight[n] * J[i];
                    double *Hi = H + row * fit->unknowns;
                    g[row] += Ji * rest;
                    for (j = 0; j < fit->pairs && j <= i; ++j) Hi[j] += Ji * J[j];
                    for (; j <= i; ++j) Hi[own + j] += Ji * J[j];
                }
            }
    }
}

/* The unknowns of a curve: offsets, then of each channel the weights (of the first term their roots q) and the root of
   delta. */
static void ms_sss__fit_pack(const ms_sss__fit *fit, const ms_sss__curve *v, double *x)
{
    int c, t, i;
    for (i = 1; i <= fit->pairs; ++i) *x++ = v->offset[i];
    for (c = 0; c < 3; ++c) {
        for (t = 0; t < fit->terms; ++t)
            for (i = 0; i <= fit->pairs; ++i) *x++ = t == 0 ? sqrt(v->weight[c][0][i]) : v->weight[c][t][i];
        if (fit->use_delta) *x++ = sqrt(v->delta[c]);
    }
}

/* The normalized curve of unknowns within their bounds. */
static void ms_sss__fit_unpack(const ms_sss__fit *fit, const double *x, ms_sss__curve *v)
{
    int c, t, i;
    for (i = 1; i <= fit->pairs; ++i) v->offset[i] = fmax(0.05, fmin(*x++, 2 * fit->d->cells + 2));
    for (c = 0; c < 3; ++c) {
        for (t = 0; t < fit->terms; ++t)
            for (i = 0; i <= fit->pairs; ++i, ++x) v->weight[c][t][i] = t == 0 ? *x * *x : *x;
        if (fit->use_delta) v->delta[c] = fmin(*x * *x, 0.99 * v->energy[c]), ++x;
    }
    ms_sss__curve_normalize(v);
}

static double ms_sss__fit_squares(const ms_sss__squares *p, double *x, double *H, double *g)
{
    ms_sss__fit *fit = p->fit;
    if (H != NULL) {
        ms_sss__fit_system(fit, &fit->trial, H, g);
        return 0;
    }
    ms_sss__fit_unpack(fit, x, &fit->trial);
    ms_sss__fit_pack(fit, &fit->trial, x);
    ms_sss__fit_basis(fit, &fit->trial);
    return ms_sss__fit_objective(fit, &fit->trial);
}

/* Improves v in place; returns the objective. */
static double ms_sss__fit_run(ms_sss__fit *fit, ms_sss__curve *v, int rounds)
{
    const ms_sss__squares problem = {ms_sss__fit_squares, fit->d, fit->unknowns, 0, NULL, 0, fit};
    double value;
    int c, i;
    for (c = 0; c < 3; ++c) /* q = 0 would never move */
        for (i = 0; i <= v->pairs; ++i) v->weight[c][0][i] = fmax(v->weight[c][0][i], 1e-6);
    fit->trial = *v;
    ms_sss__fit_pack(fit, v, fit->x);
    value = ms_sss__descend(&problem, fit->x, rounds, 1e-6, fit->scratch);
    ms_sss__fit_unpack(fit, fit->x, v);
    return value;
}

static void ms_sss__fit_destroy(ms_sss__fit *fit) { ms__release(&fit->d->allocator, fit, fit->bytes); }

/* For curves of v's pairs and terms. NULL: no memory. */
static ms_sss__fit *ms_sss__fit_create(const ms_sss_designer *d, const ms_sss__curve *model, double dial,
                                       const ms_sss__curve *v, int use_delta, int coarse)
{
    const int own = v->terms * (v->pairs + 1) + use_delta, unknowns = v->pairs + 3 * own;
    const size_t doubles = (size_t)(unknowns + MS_SSS__DESCEND_SCRATCH(unknowns));
    const size_t bytes = sizeof(ms_sss__fit) + doubles * sizeof(double);
    ms_sss__fit *fit = (ms_sss__fit *)ms__alloc(&d->allocator, bytes);
    if (fit == NULL) return NULL;
    memset(fit, 0, bytes);
    fit->d = d;
    fit->bytes = bytes;
    fit->pairs = v->pairs;
    fit->terms = v->terms;
    fit->use_delta = use_delta;
    fit->unknowns = unknowns;
    fit->local = v->pairs + own;
    fit->x = (double *)(void *)(fit + 1);
    fit->scratch = fit->x + unknowns;
    ms_sss__fit_bins(fit, model, dial, coarse);
    return fit;
}

/* Moves the weights of a dense curve onto few taps: offsets from the placement, each weight the integral over the cell
   that reaches halfway to the neighbors, the last to infinity. range: outermost offset of the quadratic spacing; 0: one
   cell apart. */
static void ms_sss__place(const ms_sss_designer *d, const ms_sss__curve *dense, ms_sss_placement placement,
                          double range, int pairs, ms_sss__curve *v)
{
    double mass[MS_SSS__CELLS_MAX + 2], total = 0; /* of the widest channel within i + 1/2 cells, one side */
    int c, t, i, n, cell;
    for (i = 0; i <= dense->pairs; ++i) {
        total += fabs(dense->weight[d->widest][0][i]) * (i ? 1 : 0.5);
        mass[i] = total;
    }
    memset(v, 0, sizeof *v);
    v->pairs = pairs;
    v->terms = dense->terms;
    memcpy(v->sign, dense->sign, sizeof v->sign);
    memcpy(v->delta, dense->delta, sizeof v->delta);
    memcpy(v->energy, dense->energy, sizeof v->energy);
    for (n = 1; n <= pairs; ++n) {
        if (placement == MS_SSS_QUADRATIC) {
            v->offset[n] = range > 0 ? range * n * n / ((double)pairs * pairs) : n;
        } else { /* the middle, by energy, of the cell that holds (2n-1)/T to (2n+1)/T */
            double want = total * 2 * n / (2 * pairs + 1), below;
            for (i = 0; i < dense->pairs && mass[i] < want; ++i) {}
            below = i ? mass[i - 1] : 0;
            v->offset[n] = i + (i ? -0.5 : 0) +
                (i ? 1 : 0.5) * (want - below) / (mass[i] > below ? mass[i] - below : 1);
        }
        if (v->offset[n] < v->offset[n - 1] + 0.05) v->offset[n] = v->offset[n - 1] + 0.05;
    }
    for (c = 0; c < 3; ++c)
        for (t = 0; t < dense->terms; ++t)
            for (cell = 0; cell <= dense->pairs; ++cell) { /* its weight spreads evenly over [cell - 1/2, cell + 1/2] */
                double low = cell ? cell - 0.5 : 0, high = cell + 0.5, w = dense->weight[c][t][cell] * (cell ? 1 : 0.5);
                for (n = 0; n <= pairs; ++n) {
                    double first = n ? 0.5 * (v->offset[n - 1] + v->offset[n]) : 0;
                    double last = n < pairs ? 0.5 * (v->offset[n] + v->offset[n + 1]) : HUGE_VAL;
                    double part = (last < high ? last : high) - (first > low ? first : low);
                    if (part > 0) v->weight[c][t][n] += (n ? 1 : 2) * w * part / (high - low);
                }
            }
}

/* ---- kernel models --------------------------------------------------------------------------------------------- */

static void ms_sss__rotate(double *x, double *y, int stride, int n, double c, double s)
{
    int i;
    for (i = 0; i < n * stride; i += stride) {
        const double before = x[i];
        x[i] = c * before - s * y[i];
        y[i] = s * before + c * y[i];
    }
}

/* Eigenvalues of a symmetric A [n][n], left on its diagonal, and unit eigenvectors, the rows of V: cyclic Jacobi
   rotations (Golub and Van Loan 2013, Matrix Computations, section 8.5). */
static void ms_sss__eigen(double *A, double *V, int n)
{
    double least = DBL_MIN;
    int sweep, rotated = 1, a, b;
    for (a = 0; a < n * n; ++a) {
        least = fmax(least, 1e-14 * fabs(A[a]));
        V[a] = a % (n + 1) == 0;
    }
    for (sweep = 0; sweep < 30 && rotated; ++sweep)
        for (rotated = 0, a = 0; a < n; ++a)
            for (b = a + 1; b < n; ++b) {
                double theta, t, c;
                if (!(fabs(A[a * n + b]) > least)) continue;
                theta = (A[b * n + b] - A[a * n + a]) / (2 * A[a * n + b]);
                t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(1 + theta * theta));
                c = 1 / sqrt(1 + t * t);
                ms_sss__rotate(A + a, A + b, n, n, c, t * c);
                ms_sss__rotate(A + a * n, A + b * n, 1, n, c, t * c);
                ms_sss__rotate(V + a * n, V + b * n, 1, n, c, t * c);
                rotated = 1;
            }
}

/* a_p in cells: the row sums of the kernel. */
static void ms_sss__row_sums(const ms_sss_designer *d, int c, double *out)
{
    int i, j, row = d->cells + 1;
    for (i = 0; i < row; ++i) {
        out[i] = d->cell[c][i * row];
        for (j = 1; j < row; ++j) out[i] += 2 * d->cell[c][i * row + j];
    }
}

/* Terms first, first + 1, ... of a dense curve from the singular vectors of what `minus` (NULL: nothing) leaves of the
   kernel. Even vectors only: the others belong to eigenvalue 0. They are found in the half of the cells by scaling each
   with the square root of its multiplicity. Sums of vectors of the rest of a_p vanish, as (1, ..., 1) is its null
   vector. */
static ms_status ms_sss__singular_terms(const ms_sss_designer *d, int c, const double *minus, int first, int count,
                                        ms_sss__curve *v)
{
    int n = d->cells + 1, i, j, t;
    size_t bytes = 2 * (size_t)(n * n) * sizeof(double);
    double *A = (double *)ms__alloc(&d->allocator, bytes), *V;
    if (A == NULL) return MS_OUT_OF_MEMORY;
    V = A + n * n;
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) {
            double rest = d->cell[c][i * n + j] - (minus != NULL ? minus[i] * minus[j] : 0);
            A[i * n + j] = rest * sqrt((i ? 2.0 : 1.0) * (j ? 2.0 : 1.0));
        }
    ms_sss__eigen(A, V, n);
    for (t = first; t < first + count; ++t) {
        double sum = 0, scale, *value, *vector;
        for (i = 0, j = 0; i < n; ++i) /* the largest that is left */
            if (fabs(A[i * n + i]) > fabs(A[j * n + j])) j = i;
        value = A + j * n + j;
        vector = V + j * n;
        for (i = 0; i < n; ++i) sum += vector[i] * (i ? sqrt(2.0) : 1);
        scale = sqrt(fabs(*value)) * (sum < 0 ? -1 : 1);
        for (i = 0; i < n; ++i) v->weight[c][t][i] = scale * vector[i] / (i ? sqrt(2.0) : 1);
        v->sign[c][t] = *value < 0 ? -1 : 1;
        *value = 0;
    }
    ms__release(&d->allocator, A, bytes);
    return MS_OK;
}

/* Gaussians are fitted from a fiftieth of a cell to a thousand. */
static double ms_sss__log_sigma(double x) { return x < -4 ? -4 : x > 7 ? 7 : x; }

/* A 1D Gaussian integrated over cells and scaled so that the square holds all of it, and its derivative by log
   sigma. */
static void ms_sss__gaussian_cells(double sigma, int cells, double *g, double *slope)
{
    double sum = 0, growth = 0;
    int i;
    for (i = 0; i <= cells; ++i) {
        double a = (i - 0.5) / sigma, b = (i + 0.5) / sigma;
        g[i] = 0.5 * (erf(b * sqrt(0.5)) - erf(a * sqrt(0.5)));
        slope[i] = (a * exp(-0.5 * a * a) - b * exp(-0.5 * b * b)) / sqrt(2 * MS_SSS__PI);
        sum += (i ? 2 : 1) * g[i];
        growth += (i ? 2 : 1) * slope[i];
    }
    for (i = 0; i <= cells; ++i) {
        slope[i] = (slope[i] - g[i] * growth / sum) / sum;
        g[i] /= sum;
    }
}

/* Gaussians whose sum approximates a channel, each of weight q^2 over the sum of those: x is q of all, then log sigma,
   cells. One in the Frobenius norm, as it is usually done; more by texture error, as that norm sees little but the
   center. */
static double ms_sss__mixture_squares(const ms_sss__squares *p, double *x, double *H, double *g)
{
    double wave[MS_SSS_TERMS_MAX][MS_SSS__NODES_MAX], slope[MS_SSS_TERMS_MAX][MS_SSS__NODES_MAX],
        share[MS_SSS__NODES_MAX];
    double cell[MS_SSS__ROW_MAX], growth[MS_SSS__ROW_MAX], J[2 * MS_SSS_TERMS_MAX], sum = 0, value = 0;
    int node[MS_SSS__NODES_MAX], nodes = ms_sss__nodes(p->d->cells, 0, node, share), N = p->n / 2, n, a, b, i, j;
    for (n = 0; n < N; ++n) sum += x[n] * x[n];
    for (n = 0; n < N; ++n) { /* spectra and their derivatives by log sigma */
        x[n] /= sqrt(sum);
        x[N + n] = ms_sss__log_sigma(x[N + n]);
        ms_sss__gaussian_cells(exp(x[N + n]), p->d->cells, cell, growth);
        for (a = 0; a < nodes; ++a) {
            wave[n][a] = cell[0];
            slope[n][a] = growth[0];
            for (i = 1; i <= p->d->cells; ++i) {
                double c = 2 * p->d->cosine[node[a] * i & (MS_SSS__SIZE - 1)];
                wave[n][a] += cell[i] * c;
                slope[n][a] += growth[i] * c;
            }
        }
    }
    for (a = 0; a < nodes; ++a)
        for (b = 0; b <= a; ++b) {
            double found = 0, rest, weight = share[a] * share[b] * (a == b ? 1 : 2);
            if (N > 1) weight *= a > 0 ? ms_sss__texture_power(node[a], node[b]) : 0;
            for (n = 0; n < N; ++n) {
                J[n] = wave[n][a] * wave[n][b];
                J[N + n] = x[n] * x[n] * (slope[n][a] * wave[n][b] + wave[n][a] * slope[n][b]);
                found += x[n] * x[n] * J[n];
            }
            for (n = 0; n < N; ++n) J[n] = 2 * x[n] * (J[n] - found); /* q^2 over their sum */
            rest = p->d->spectrum[p->channel][ms_sss__octant(node[a], node[b])] - found;
            value += weight * rest * rest;
            for (i = 0; i < 2 * N && H != NULL; ++i) {
                g[i] += weight * J[i] * rest;
                for (j = 0; j <= i; ++j) H[i * 2 * N + j] += weight * J[i] * J[j];
            }
        }
    return value;
}

/* The best of fits that start from Gaussians spread evenly in log sigma, the narrowest one narrower or wider: weight
   and sigma, cells, of each. */
static void ms_sss__fit_mixture(const ms_sss_designer *d, int c, int count, double *weight, double *sigma)
{
    static const double spread[] = {20, 90};
    double x[2 * MS_SSS_TERMS_MAX], scratch[MS_SSS__DESCEND_SCRATCH(2 * MS_SSS_TERMS_MAX)], least = HUGE_VAL, value;
    const ms_sss__squares problem = {ms_sss__mixture_squares, d, 2 * count, c, NULL, 0, NULL};
    int k, n;
    for (k = 0; k < 2; ++k) {
        const double narrowest = d->width[c] / spread[k] + 0.1, widest = d->width[c] / 2 + 0.2;
        for (n = 0; n < count; ++n) {
            x[n] = 1;
            x[count + n] = log(narrowest) + log(widest / narrowest) * (n + 0.5) / count;
        }
        value = ms_sss__descend(&problem, x, 150, 1e-8, scratch);
        if (k > 0 && !(value < least)) break;
        least = value;
        for (n = 0; n < count; ++n) {
            weight[n] = x[n];
            sigma[n] = exp(x[count + n]);
        }
    }
}

/* The two-Gaussian model against a_p (5.6): x is log sigma of both, cells, and the share of the first. */
static double ms_sss__artist_squares(const ms_sss__squares *p, double *x, double *H, double *g)
{
    double cell[2][MS_SSS__ROW_MAX], growth[2][MS_SSS__ROW_MAX], J[3], value = 0;
    int i, a, b;
    for (a = 0; a < 2; ++a) {
        x[a] = ms_sss__log_sigma(x[a]);
        ms_sss__gaussian_cells(exp(x[a]), p->d->cells, cell[a], growth[a]);
    }
    x[2] = x[2] < 0 ? 0 : x[2] > 1 ? 1 : x[2];
    for (i = 0; i <= p->d->cells; ++i) {
        double rest = p->curve[i] - x[2] * cell[0][i] - (1 - x[2]) * cell[1][i], times = i ? 2 : 1;
        J[0] = x[2] * growth[0][i];
        J[1] = (1 - x[2]) * growth[1][i];
        J[2] = cell[0][i] - cell[1][i];
        value += times * rest * rest;
        for (a = 0; a < 3 && H != NULL; ++a) {
            g[a] += times * J[a] * rest;
            for (b = 0; b <= a; ++b) H[3 * a + b] += times * J[a] * J[b];
        }
    }
    return value;
}

/* Replaces a_p by the two Gaussians of least squares to it. */
static void ms_sss__fit_artist(const ms_sss_designer *d, int c, double *ap)
{
    double x[3] = {0, 0, 0.5}, near_cells[MS_SSS__ROW_MAX], far_cells[MS_SSS__ROW_MAX], slope[MS_SSS__ROW_MAX];
    double scratch[MS_SSS__DESCEND_SCRATCH(3)];
    const ms_sss__squares problem = {ms_sss__artist_squares, d, 3, 0, ap, 0, NULL};
    int i;
    x[0] = log(d->width[c] / 20 + 0.2);
    x[1] = log(d->width[c] / 3 + 0.4);
    ms_sss__descend(&problem, x, 100, 1e-12, scratch);
    ms_sss__gaussian_cells(exp(x[0]), d->cells, near_cells, slope);
    ms_sss__gaussian_cells(exp(x[1]), d->cells, far_cells, slope);
    for (i = 0; i <= d->cells; ++i) ap[i] = x[2] * near_cells[i] + (1 - x[2]) * far_cells[i];
}

/* Guided optimization (5.14): least sum over i, j >= 1 of Gamma_ij (K_ij - a_i a_j)^2, x being a_1 and on. Gamma
   vanishes on the axes, so a_0 enters no term and is what the energy constraint leaves: in the limit of small cells
   a(x) tends to a smooth curve with a point mass at 0. That is the dependence on the grid: the curve converges, the
   center's share of the mass within half a cell shrinks towards the point mass. */
static double ms_sss__guided_squares(const ms_sss__squares *p, double *a, double *H, double *g)
{
    const int n = p->n;
    double value = 0;
    int i, j;
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) {
            double x = (i + 1.0) / n, y = (j + 1.0) / n;
            double rest = p->curve[(i + 1) * (n + 1) + j + 1] - a[i] * a[j];
            double guide = pow(x * x + y * y, 0.5 * p->guide) * expm1(-50 * x * x) *
                expm1(-50 * y * y); /* (5.16), b = 50 */
            value += guide * rest * rest;
            if (H == NULL) continue;
            H[i * n + i] += guide * a[j] * a[j];
            H[i * n + j] += guide * a[i] * a[j];
            g[i] += guide * rest * a[j];
        }
    return value;
}

static ms_status ms_sss__guided(const ms_sss_designer *d, int c, double guide, double *a)
{
    const int M = d->cells;
    const size_t bytes = (size_t)MS_SSS__DESCEND_SCRATCH(M) * sizeof(double);
    const ms_sss__squares problem = {ms_sss__guided_squares, d, M, 0, d->cell[c], guide, NULL};
    double *scratch = (double *)ms__alloc(&d->allocator, bytes), sum = 0;
    int i;
    if (scratch == NULL) return MS_OUT_OF_MEMORY;
    ms_sss__row_sums(d, c, a);
    ms_sss__descend(&problem, a + 1, 60, 1e-10, scratch);
    ms__release(&d->allocator, scratch, bytes);
    for (i = 1; i <= M; ++i) sum += 2 * a[i];
    a[0] = 1 - sum;
    if (a[0] < 0) {
        for (i = 1; i <= M; ++i) a[i] /= sum;
        a[0] = 0;
    }
    return MS_OK;
}

/* All models but the fits of taps, as weights of all cells. */
static ms_status ms_sss__model_curve(const ms_sss_designer *d, const ms_sss_kernel_options *o, ms_sss__curve *v)
{
    double slope[MS_SSS__ROW_MAX], sum;
    ms_status status = MS_OK;
    int c, t, i, M = d->cells;
    memset(v, 0, sizeof *v);
    v->pairs = M;
    v->terms = 1;
    for (i = 0; i <= M; ++i) v->offset[i] = i;
    if (o->model == MS_SSS_SVD || o->model == MS_SSS_SVD_NORMALIZED || o->model == MS_SSS_GAUSSIANS ||
        o->model == MS_SSS_RESIDUAL)
        v->terms = o->term_count;
    for (c = 0; c < 3 && status == MS_OK; ++c) {
        double *w = v->weight[c][0];
        for (t = 0; t < v->terms; ++t) v->sign[c][t] = 1;
        v->energy[c] = 1;
        if (!(d->reflectance[c] > 0)) { /* a channel without light */
            w[0] = 1;
            continue;
        }
        ms_sss__row_sums(d, c, w);
        if (o->model == MS_SSS_RESIDUAL && v->terms > 1) {
            status = ms_sss__singular_terms(d, c, w, 1, v->terms - 1, v);
        } else if (o->model == MS_SSS_SVD || o->model == MS_SSS_SVD_NORMALIZED) {
            status = ms_sss__singular_terms(d, c, NULL, 0, v->terms, v);
            for (t = 0, sum = 0; t < v->terms; ++t)
                sum += v->sign[c][t] * ms_sss__term_sum(v, c, t) * ms_sss__term_sum(v, c, t);
            /* a sum above 1, where terms with a negative sign are left out, would brighten a constant */
            if (o->model == MS_SSS_SVD && sum > 0 && sum < 1) v->energy[c] = sum;
        } else if (o->model == MS_SSS_GAUSSIANS) {
            double q[MS_SSS_TERMS_MAX], sigma[MS_SSS_TERMS_MAX];
            ms_sss__fit_mixture(d, c, v->terms, q, sigma);
            for (t = 0; t < v->terms; ++t) {
                ms_sss__gaussian_cells(sigma[t], M, v->weight[c][t], slope);
                for (i = 0; i <= M; ++i) v->weight[c][t][i] *= q[t]; /* q^2 g g^T = (q g)(q g)^T */
            }
        } else if (o->model == MS_SSS_GUIDED) {
            status = ms_sss__guided(d, c, o->guide_k, w);
        } else if (o->model == MS_SSS_ARTIST) {
            ms_sss__fit_artist(d, c, w);
        } else if (o->model == MS_SSS_SLICE) {
            memcpy(w, d->slice[c], sizeof *w * (size_t)(M + 1));
        }
    }
    if (status == MS_OK) ms_sss__curve_normalize(v);
    return status;
}

/* Moves offsets of best over the kinks that linear interpolation has at whole pixels, where descent gets stuck, as long
   as that helps; then descends to the end. */
static void ms_sss__fit_past_kinks(ms_sss__fit *fit, int sweeps, ms_sss__curve *best)
{
    ms_sss__curve *v = &fit->hop;
    double least = ms_sss__fit_run(fit, best, 10), objective;
    int n, sweep, moved = 1;
    for (sweep = 0; sweep < sweeps && moved; ++sweep) {
        moved = 0;
        for (n = 2; n < 2 * best->pairs + 2; ++n) {
            double *o = &v->offset[n / 2];
            *v = *best;
            *o += (n % 2 ? 1 : -1) * (0.6 + 0.1 * *o);
            if (*o < 0.1) continue;
            objective = ms_sss__fit_run(fit, v, 3);
            if (objective < 1.02 * least) objective = ms_sss__fit_run(fit, v, 5);
            if (objective < 0.995 * least) {
                least = objective;
                *best = *v;
                moved = 1;
            }
        }
    }
    ms_sss__fit_run(fit, best, 30);
}

/* Fits taps over few bins from several starts, which differ in how far out they reach, then the best over all bins.
   Pairs beyond one a pixel would be idle, and fits get stuck along idle unknowns. */
static ms_status ms_sss__fit_best(const ms_sss_designer *d, const ms_sss__curve *dense, const ms_sss__curve *model,
                                  double dial, int pairs, int no_delta, ms_sss__curve *best)
{
    static const double reach[] = {0, 0.25, 0.4, 0.6, 0.85}; /* 0: a tap a pixel */
    ms_sss__curve *v;
    ms_sss__fit *fit;
    double least = HUGE_VAL, objective;
    int n, c;
    pairs = pairs < d->cells ? pairs : d->cells;
    ms_sss__place(d, dense, MS_SSS_QUANTILE, 0, pairs, best);
    fit = ms_sss__fit_create(d, model, dial, best, !no_delta, 1);
    if (fit == NULL) return MS_OUT_OF_MEMORY;
    v = &fit->hop;
    for (n = 2 * pairs < d->cells ? 1 : 0; n < 6; ++n) { /* a tap a pixel where that reaches half of the radius */
        ms_sss__place(d, dense, n < 5 ? MS_SSS_QUADRATIC : MS_SSS_QUANTILE, n < 5 ? reach[n] * d->cells : 0, pairs, v);
        for (c = 0; c < 3 && !no_delta; ++c) v->delta[c] = 0.03;
        ms_sss__curve_normalize(v);
        objective = ms_sss__fit_run(fit, v, 8);
        if (objective < least) {
            least = objective;
            *best = *v;
        }
    }
    ms_sss__fit_past_kinks(fit, 2, best);
    ms_sss__fit_destroy(fit);
    fit = ms_sss__fit_create(d, model, dial, best, !no_delta, 0);
    if (fit == NULL) return MS_OUT_OF_MEMORY;
    /* worth its time where a tap or an error counts */
    ms_sss__fit_past_kinks(fit, dense->terms > 1 || pairs <= 8, best);
    ms_sss__fit_destroy(fit);
    return MS_OK;
}

/* The quadratic spacing with the reach of least texture error. */
static void ms_sss__place_quadratic(const ms_sss_designer *d, const ms_sss__curve *dense, int pairs, ms_sss__curve *v,
                                    ms_sss__waves *waves, ms_sss__curve *best)
{
    double least = HUGE_VAL, error[MS_SSS__SIGNALS];
    int n;
    for (n = 4; n <= 20; n += 2) {
        ms_sss__place(d, dense, MS_SSS_QUADRATIC, 0.05 * n * d->cells, pairs, v);
        ms_sss__curve_errors(d, v, waves, error);
        if (error[MS_SSS__TEXTURE] < least) {
            least = error[MS_SSS__TEXTURE];
            *best = *v;
        }
    }
}

static MS_SSS__COLD void ms_sss__store_kernel(const ms_sss_designer *d, const ms_sss__curve *v, double index,
                                              ms_sss_kernel *kernel)
{
    int order[MS_SSS__ROW_MAX], n, i, t, c;
    memset(kernel, 0, sizeof *kernel);
    for (n = 0; n <= v->pairs; ++n) { /* by growing offset */
        for (i = n; i > 1 && v->offset[order[i - 1]] > v->offset[n]; --i) order[i] = order[i - 1];
        order[i] = n;
    }
    kernel->tap_count = 2 * v->pairs + 1;
    kernel->term_count = v->terms;
    for (n = 0; n <= v->pairs; ++n) {
        kernel->offset_mm[n] = (float)(v->offset[order[n]] * d->cell_mm);
        for (t = 0; t < v->terms; ++t)
            for (c = 0; c < 3; ++c) kernel->weight[t][n][c] = (float)v->weight[c][t][order[n]];
    }
    for (c = 0; c < 3; ++c) {
        double both = 0; /* mean of |x| + |y| */
        for (t = 0; t < v->terms; ++t) {
            double one = 0;
            for (i = 1; i <= v->pairs; ++i) one += 2 * v->weight[c][t][i] * v->offset[i] * d->cell_mm;
            both += 2 * v->sign[c][t] * ms_sss__term_sum(v, c, t) * one / v->energy[c];
            kernel->scale[t][c] = (float)v->sign[c][t];
        }
        kernel->delta[c] = (float)v->delta[c];
        kernel->reflectance[c] = (float)d->reflectance[c];
        kernel->decay[c] = (float)ms_sss__decay_of(d->reflectance[c], d->mean_mm[c]);
        kernel->elevation[c] = (float)ms_sss_elevation(d->reflectance[c], index);
        if (!(both > 0.2 * d->mean_mm[c])) /* terms of both signs leave no mean: pi/4, what an exact separable kernel
                                              would have */
            both = d->mean_mm[c] > 0 ? d->mean_mm[c] / 0.785398 : 1; /* never 0 */
        kernel->elevation_axis[c] = kernel->elevation[c] * (float)(d->mean_mm[c] / both);
    }
    kernel->profile_radius_mm = (float)(d->width[d->widest] * d->cell_mm);
    n = v->pairs;
    if (n > 0) kernel->radius_mm = (float)(d->cell_mm * (1.5 * v->offset[order[n]] - 0.5 * v->offset[order[n - 1]]));
    else kernel->radius_mm = (float)(d->cell_mm * 0.5);
}

static MS_SSS__COLD ms_status ms_sss__check_kernel_options(const ms_sss_kernel_options *o, ms_error *error)
{
    const int dense = o->tap_count == MS_SSS_DENSE, most = o->placement == MS_SSS_OPTIMIZED ? 33 : MS_SSS_TAPS_MAX;
    const ms_sss__range ranges[] = {{"model", (double)o->model, 0, (double)MS_SSS_SLICE},
                                    {"placement", (double)o->placement, 0, (double)MS_SSS_QUADRATIC},
                                    {"term_count", (double)o->term_count, 1, MS_SSS_TERMS_MAX},
                                    {"dial", o->dial, 0, 1},
                                    {"guide_k", o->guide_k, 0, 4},
                                    {"index", o->index, 1, 2}};
    const ms_status status = ms_sss__check_ranges(ranges, sizeof ranges / sizeof ranges[0], error);
    if (status != MS_OK) return status;
    if (dense && o->model == MS_SSS_IMAGE_OPTIMAL)
        return MS_SSS__REFUSE(error, "tap_count is MS_SSS_DENSE; 3 to 33 expected for an image-optimal kernel");
    if (!dense && (o->tap_count < 3 || o->tap_count > most || o->tap_count % 2 == 0))
        return MS_SSS__REFUSE(error, "tap_count is %d; odd, 3 to %d, or MS_SSS_DENSE expected", o->tap_count, most);
    return MS_OK;
}

MS_API ms_sss_kernel_options ms_sss_kernel_defaults(void)
{
    ms_sss_kernel_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_SSS__COLD MS_API ms_status ms_sss_kernel_build(ms_sss_kernel *kernel, const ms_sss_designer *d,
                                                  const ms_sss_kernel_options *options, ms_error *error)
{
    ms_sss_kernel_options o = options != NULL ? *options : ms_sss_kernel_defaults();
    const size_t bytes = 3 * sizeof(ms_sss__curve) + sizeof(ms_sss__waves);
    ms_sss__curve *dense, *taps, *scratch;
    ms_status status;
    int pairs, c, of_profile;
    if (kernel == NULL || d == NULL) return MS_SSS__REFUSE(error, "kernel or designer is NULL");
    if (o.tap_count == 0) o.tap_count = 7;
    if (o.term_count == 0) o.term_count = o.model == MS_SSS_RESIDUAL ? 2 : 1;
    if (o.index == 0) o.index = 1;
    status = ms_sss__check_kernel_options(&o, error);
    if (status != MS_OK) return status;
    dense = (ms_sss__curve *)ms__alloc(&d->allocator, bytes);
    if (dense == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory to fit a kernel");
    taps = dense + 1;
    scratch = dense + 2;
    status = ms_sss__model_curve(d, &o, dense);
    pairs = o.tap_count / 2;
    if (status == MS_OK && o.tap_count == MS_SSS_DENSE) {
        *taps = *dense;
    } else if (status == MS_OK && o.placement == MS_SSS_OPTIMIZED) {
        /* the target: the profile for models that approximate it best, else the model's own dense kernel */
        of_profile = o.model == MS_SSS_IMAGE_OPTIMAL || o.model == MS_SSS_RESIDUAL;
        status = ms_sss__fit_best(d, dense, of_profile ? NULL : dense, o.dial, pairs, o.no_delta, taps);
    } else if (status == MS_OK && o.placement == MS_SSS_QUADRATIC) {
        ms_sss__place_quadratic(d, dense, pairs, scratch, (ms_sss__waves *)(void *)(dense + 3), taps);
    } else if (status == MS_OK) {
        ms_sss__place(d, dense, MS_SSS_QUANTILE, 0, pairs, taps);
    }
    for (c = 0; c < 3 && status == MS_OK; ++c)
        if (!(d->reflectance[c] > 0)) { /* the identity, exactly */
            memset(taps->weight[c], 0, sizeof taps->weight[c]);
            taps->weight[c][0][0] = 1;
            taps->delta[c] = 0;
            taps->energy[c] = 1;
        }
    if (status == MS_OK) {
        ms_sss__curve_normalize(taps);
        ms_sss__store_kernel(d, taps, o.index, kernel);
    }
    ms__release(&d->allocator, dense, bytes);
    return status == MS_OK ? MS_OK : ms__fail(error, status, 0, "no memory to fit a kernel");
}

MS_SSS__COLD MS_API ms_status ms_sss_kernel_make(ms_sss_kernel *kernel, ms_sss_errors *errors,
                                                 const ms_sss_profile *profile, double radius_px,
                                                 const ms_sss_kernel_options *options, const ms_allocator *allocator,
                                                 ms_error *error)
{
    ms_sss_designer *designer;
    ms_status status = ms_sss_designer_create(&designer, profile, radius_px, allocator, error);
    if (status != MS_OK) return status;
    status = ms_sss_kernel_build(kernel, designer, options, error);
    if (status == MS_OK && errors && (status = ms_sss_kernel_measure(errors, kernel, designer)) != MS_OK)
        ms__fail(error, status, 0, "no memory to measure the kernel");
    ms_sss_designer_destroy(designer);
    return status;
}

/* ---- pyramid weights --------------------------------------------------------------------------------------------- */

/* Minimizes x'A x / 2 - b'x for x >= 0, n <= 24, rows of A stride apart: solves for the variables in use, of which
   those at or below 0 leave; once all are positive, the one that the residual pulls most enters. */
static void ms_sss__fit_positive(const double *A, int stride, const double *b, int n, double *x)
{
    double part[24 * 24], step[24];
    int in[24], used[24], i, j, m, round, enter = 0;
    for (i = 0; i < n; ++i) x[i] = used[i] = 0;
    for (round = 0; round < 8 * n && enter >= 0; ++round) {
        double most = 1e-9;
        int positive = 1;
        for (m = 0, i = 0; i < n; ++i)
            if (used[i]) in[m++] = i;
        for (i = 0; i < m; ++i) {
            for (j = 0; j < m; ++j) part[i * m + j] = A[in[i] * stride + in[j]] * (i == j ? 1 + 1e-12 : 1);
            step[i] = b[in[i]];
        }
        if (!ms_sss__cholesky_solve(part, step, m)) return;
        for (i = 0; i < m; ++i)
            if (!(step[i] > 0)) positive = used[in[i]] = 0;
        if (!positive) continue;
        for (i = 0, j = 0; i < n; ++i) x[i] = used[i] ? step[j++] : 0;
        for (enter = -1, i = 0; i < n; ++i) {
            double pull = b[i];
            for (j = 0; j < n; ++j) pull -= A[i * stride + j] * x[j];
            if (used[i] || pull <= most) continue;
            most = pull;
            enter = i;
        }
        if (enter >= 0) used[enter] = 1;
    }
}

/* Transfer of (1, 3, 3, 1) / 8, down or up by one level, along one axis. */
static double ms_sss__step_wave(double k)
{
    const double c = cos(k / 2);
    return c * c * c;
}

/* Transfer of a level's gather from the next, whose pixels' middle is a quarter pixel off. */
static double ms_sss__gather_wave(double kx, double ky, int wide, int level)
{
    double sum = 0, n = 0;
    int i;
    for (i = 0; i < 64; ++i) {
        const double x = i % 8 - 3.75, y = i / 8 - 3.75,
                     t = fmax(1 - (x * x + y * y) / (double)MS_SSS__GATHER(wide, level), 0), w = t * t * (wide ? t : 1);
        sum += w * cos(kx * x) * cos(ky * y); /* the odd parts cancel between neighbors */
        n += w;
    }
    return sum / n;
}

enum { MS_SSS__WAVE_TERMS = 2 * MS_SSS_PYRAMID_LEVELS };

/* What each term of a pyramid keeps of a wave of k radians a pixel: halfway between an axis and a diagonal, as the
   levels are nearly round. */
static void ms_sss__pyramid_wave(int wide, double k, double wave[MS_SSS__WAVE_TERMS])
{
    const double kx = k * 0.923879532511287, ky = k * 0.38268343236509;
    double both = 1; /* down to the level, and up from the finer one that gathers from it */
    int l;
    for (l = 0; l < MS_SSS_PYRAMID_LEVELS; ++l) {
        const double u = kx * (1 << l), v = ky * (1 << l), one = ms_sss__step_wave(u) * ms_sss__step_wave(v);
        wave[2 * l] = l == 0;
        wave[2 * l + 1] = l ? both * ms_sss__gather_wave(u, v, wide, l - 1)
                            : (0.5 + 0.5 * cos(u)) * (0.5 + 0.5 * cos(v));
        both *= l ? one * ms_sss__step_wave(u / 2) * ms_sss__step_wave(v / 2) : one;
    }
}

MS_SSS__COLD MS_API ms_status ms_sss_pyramid_make(ms_sss_pyramid *pyramid, const ms_sss_profile *profile,
                                                  ms_error *error)
{
    /* A wave of k radians a mm keeps T(k) = integral of a_p(x) cos(k x) dx of its height. T is tabled on a grid whose
       steps are those of the pixel frequencies below, so that a change of size is a shift. */
    enum {
        STEPS = 16,
        LOW = 14,
        HIGH = 14,
        TABLE = STEPS * (LOW + HIGH) + 1,
        CELLS = 4000,
        TERMS = MS_SSS__WAVE_TERMS
    };
    double T[TABLE], A[TERMS * TERMS], b[MS_SSS_PYRAMID_SIZES][TERMS], wave[TERMS], x[TERMS], total[3], radius[3],
        widest, previous;
    int size, c, i, j, l, m, wide;
    if (!pyramid || !profile) return MS_SSS__REFUSE(error, "pyramid or profile is NULL");
    widest = ms_sss__extent(profile, total, radius);
    if (!(widest > 0)) return MS_SSS__REFUSE(error, "the profile holds no light");
    memset(pyramid, 0, sizeof *pyramid);
    pyramid->radius_mm = (float)widest;
    for (c = 0; c < 3; ++c) {
        pyramid->elevation[c] = (float)ms_sss_elevation(total[c], 1);
        pyramid->reflectance[c] = (float)total[c];
        for (i = 0; i < TABLE; ++i) T[i] = 0;
        previous = 0;
        for (j = 0; j < CELLS && total[c] > 0;
             ++j) { /* the light of strips |x| < x_j, x_j growing from 1e-5 to 20 radii */
            const double x0 = j ? widest * 1e-5 * pow(2e6, (double)(j - 1) / (double)(CELLS - 2)) : 0;
            const double x1 = widest * 1e-5 * pow(2e6, (double)j / (double)(CELLS - 2));
            double strip[3], light;
            ms_sss_profile_strip(profile, x1, strip);
            light = (strip[c] - previous) / total[c];
            previous = strip[c];
            if (!(light > 0)) continue;
            for (i = 0; i < TABLE; ++i)
                T[i] += light * cos(pow(2.0, (double)i / (double)STEPS - (double)LOW) * 0.5 * (x0 + x1) / widest);
        }
        for (wide = 0; wide < 2; ++wide) {
            memset(A, 0, sizeof A);
            memset(b, 0, sizeof b);
            for (i = 0; i <= 10 * STEPS + 1; ++i) { /* frequencies up to pi: a 1/f spectrum has equal power an octave */
                const double k = i ? MS_SSS__PI * pow(2.0, (double)(i - 1) / (double)STEPS - 10) : 0,
                             weight = i ? 1 : 1e3; /* the energy has priority */
                ms_sss__pyramid_wave(wide, k, wave);
                for (l = 0; l < TERMS; ++l)
                    for (m = 0; m < TERMS; ++m) A[l * TERMS + m] += weight * wave[l] * wave[m];
                for (size = 0; size < MS_SSS_PYRAMID_SIZES; ++size) {
                    const double octave = i ? log2(k * (double)ms_sss__index_size(size)) + (double)LOW : 0;
                    const double at = fmin(fmax(octave * (double)STEPS, 0), (double)TABLE - 1.000001);
                    const double *below = T + (int)at, target = below[0] + (at - (int)at) * (below[1] - below[0]);
                    for (l = 0; l < TERMS; ++l) b[size][l] += weight * wave[l] * target;
                }
            }
            for (size = 0; size < MS_SSS_PYRAMID_SIZES; ++size) {
                int levels = 1;
                double sum = 0;
                while (levels < MS_SSS_PYRAMID_LEVELS && (double)(1 << levels) < 4 * (double)ms_sss__index_size(size))
                    ++levels;
                if (total[c] > 0) ms_sss__fit_positive(A, TERMS, b[size], 2 * levels, x);
                else
                    for (l = 0; l < 2 * levels; ++l) x[l] = l == 0; /* a channel without light: the identity */
                for (l = 0; l < 2 * levels; ++l) sum += x[l];
                for (l = 0; l < 2 * levels; ++l) pyramid->weight[wide][size][l / 2][l % 2][c] = (float)(x[l] / sum);
            }
        }
    }
    return MS_OK;
}

#undef MS_SSS__PI
#undef MS_SSS__DESCEND_SCRATCH
#endif /* MS_SSS_NO_DESIGN */

#undef MS_SSS__BODY
#undef MS_SSS__SCALAR
#undef MS_SSS__REFUSE
#undef MS_SSS__REFUSE_AT
#undef MS_SSS__INLINE
#undef MS_SSS__NOINLINE
#undef MS_SSS__COLD
#undef MS_SSS__MASKED_DEPTH
#undef MS_SSS__SPARSE
#undef MS_SSS__AREA_MAX
#undef MS_SSS__LIGHT_MAX
#undef MS_SSS__FALLOFF_END
#undef MS_SSS__GATHER
#undef MS_SSS__NEAR
#endif /* MS_SSS__BODY */

/*
These headers, their tests and their examples are in two licences; take whichever you prefer.

--------------------------------------------------------------------------------
ALTERNATIVE A - MIT License

Copyright (c) 2026 the ms authors

Permission is hereby granted, free of charge, to any person obtaining a copy of
this software and associated documentation files (the "Software"), to deal in
the Software without restriction, including without limitation the rights to
use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies
of the Software, and to permit persons to whom the Software is furnished to do
so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

--------------------------------------------------------------------------------
ALTERNATIVE B - Public Domain (www.unlicense.org)

This is free and unencumbered software released into the public domain.

Anyone is free to copy, modify, publish, use, compile, sell, or distribute this
software, either in source code form or as a compiled binary, for any purpose,
commercial or non-commercial, and by any means.

In jurisdictions that recognize copyright laws, the author or authors of this
software dedicate any and all copyright interest in the software to the public
domain. We make this dedication for the benefit of the public at large and to
the detriment of our heirs and successors. We intend this dedication to be an
overt act of relinquishment in perpetuity of all present and future rights to
this software under copyright law.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN
ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION
WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
