/* ms_sss.h - v0.1.0 - separable subsurface scattering - MIT or public domain, see the end

   Sections (search for the line in full)
     PROFILES, KERNELS, ERRORS, TRANSLUCENCY, FILTER, PYRAMID, GPU TEXT           declarations
     SMALL MATHS, PROFILE TABLES, PRE-INTEGRATION, TAPS, KERNEL MODELS,
     KERNEL ERRORS, TRANSLUCENCY TABLES, FILTER CODE, PYRAMID CODE, GPU CODE      implementation
     FILTER KERNELS, PYRAMID KERNELS                                             SIMD pass
*/
#ifndef MS_SSS_H
#define MS_SSS_H
#include <stddef.h>
#include <stdint.h>

#define MS_SSS_VERSION_MAJOR 0
#define MS_SSS_VERSION_MINOR 1
#define MS_SSS_VERSION_PATCH 0
#define MS_SSS_VERSION 100 /* major * 10000 + minor * 100 + patch */
#define MS_SSS_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
#ifndef MS_COMMON
#define MS_COMMON 1 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__)
#define MS_API MS_DEF __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS_API MS_DEF
#endif

/* What went wrong; each code asks for another remedy. code, value, sentence */
#define MS_STATUS_LIST(X)                                                  \
    X(MS_OK, 0, "success")                                                 \
    X(MS_INVALID_ARGUMENT, 1, "an argument is outside its stated range")   \
    X(MS_OUT_OF_MEMORY, 2, "the allocator returned NULL")                  \
    X(MS_BAD_DATA, 3, "the file or the data set is malformed")             \
    X(MS_UNSUPPORTED, 4, "valid, but not handled by this build or call")   \
    X(MS_NOT_CONVERGED, 5, "the iteration stopped short of its tolerance") \
    X(MS_CANCELLED, 6, "the progress callback asked to stop")              \
    X(MS_IO, 7, "the operating system could not read or write")

typedef enum ms_status {
#define MS_STATUS_ENUM(code, value, sentence) code = value,
    MS_STATUS_LIST(MS_STATUS_ENUM)
#undef MS_STATUS_ENUM
    MS_STATUS_COUNT /* how many codes there are */
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

/* Threads. All zero: everything runs on the calling thread. run calls task(context, i) once for every
   i in [0, count), in any order, on any threads, and returns when all are done. The work is cut into
   tasks by the problem alone, so results do not depend on how many threads there are. */
typedef struct ms_parallel {
    void *user;
    void (*run)(void *user, int count, void (*task)(void *context, int index), void *context);
} ms_parallel;

/* Progress of a long call. All zero: none. report gets the fraction done, 0 to 1, from the thread that
   made the call; it returns non-zero to stop, and the call then returns MS_CANCELLED. */
typedef struct ms_progress {
    void *user;
    int (*report)(void *user, double fraction);
} ms_progress;

/* Instruction sets, in the order of their speed. Options take one as a cap: a level that the processor
   or the build lacks falls back to the next lower one. */
typedef enum ms_simd {
    MS_SIMD_AUTO = 0,   /* the best that the processor has */
    MS_SIMD_SCALAR = 1, /* plain C: the reference for all the others */
    MS_SIMD_BASE = 2,   /* SSE2 on x86-64, NEON on ARM64 */
    MS_SIMD_AVX2 = 3,   /* AVX2 and FMA */
    MS_SIMD_AVX512 = 4  /* AVX-512 F, BW, DQ, VL */
} ms_simd;

/* The sentence of MS_STATUS_LIST; "unknown status" outside it. */
static inline const char *ms_status_string(ms_status status)
{
    static const char *const sentence[] = {
#define MS_STATUS_TEXT(code, value, text) text,
        MS_STATUS_LIST(MS_STATUS_TEXT)
#undef MS_STATUS_TEXT
    };
    int i = (int)status;
    return i >= 0 && i < (int)MS_STATUS_COUNT ? sentence[i] : "unknown status";
}

/* "auto", "scalar", "base", "avx2", "avx512"; "unknown" outside the list. */
static inline const char *ms_simd_string(ms_simd level)
{
    static const char *const name[] = {"auto", "scalar", "base", "avx2", "avx512"};
    int i = (int)level;
    return i >= 0 && i <= (int)MS_SIMD_AVX512 ? name[i] : "unknown";
}
#endif /* MS_COMMON */
#if MS_COMMON != 1 /* outside the guard: catches two vendored releases in one file */
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* Linkage of this header's functions: MS_API unless the user says otherwise. */
#ifndef MS_SSS_API
#define MS_SSS_API MS_API
#endif

/* -------------------------------------------------------------- PROFILES */

#define MS_SSS_GAUSSIANS_MAX 16 /* Gaussians of one profile */

/* A diffusion profile: the light that leaves a half-space at distance r from where it entered, R_d(r) in 1/mm^2, in
   red, green and blue. Radially symmetric, unchanging once made: any number of threads may read it. All lengths in mm. */
typedef struct ms_sss_profile ms_sss_profile;

/* From averages over rings, as Monte Carlo tallies and ms_mcml.h deliver them; nothing is assumed of their order, so
   that noise, bumps and channels that are all zero are in range.
   edge_mm  [count + 1] increasing, edge_mm[0] >= 0 (a hole inside it counts as dark), finite
   value    three arrays of count averages, stride elements apart (0: 1), >= 0, finite, 1/mm^2
   Within a ring R_d is taken to be linear in r^2 with the ring's energy kept exactly and the slope of its neighbours
   where they agree, flat where they do not. Copies what it is given.
   MS_INVALID_ARGUMENT: counts, edges, values (error->position: the ring). MS_OUT_OF_MEMORY. *profile NULL then. */
MS_SSS_API ms_status ms_sss_profile_from_rings(ms_sss_profile **profile, int count, const double *edge_mm,
                                               const double *const value[3], int stride, const ms_allocator *allocator,
                                               ms_error *error);

/* From point samples R_d(r_mm[i]) at any increasing distances >= 0, count >= 2; otherwise as above. Between samples
   R_d is linear in r^2; inside the first it is constant, beyond the last 0. A profile with a pole at r = 0 is better
   given as rings. */
MS_SSS_API ms_status ms_sss_profile_from_samples(ms_sss_profile **profile, int count, const double *r_mm,
                                                 const double *const value[3], int stride,
                                                 const ms_allocator *allocator, ms_error *error);

/* R_d(r) = sum_i weight_i exp(-r^2 / (2 sigma_i^2)) / (2 pi sigma_i^2): d'Eon's skin, fits, and the two-Gaussian artist
   model (5.6), whose separable kernel a_m is the pre-integrated kernel of this profile with count = 2.
   sigma_mm, weight  [count][3]; 1 <= count <= MS_SSS_GAUSSIANS_MAX, sigma > 0; weights >= 0 */
MS_SSS_API ms_status ms_sss_profile_from_gaussians(ms_sss_profile **profile, int count, const double (*sigma_mm)[3],
                                                   const double (*weight)[3], const ms_allocator *allocator,
                                                   ms_error *error);

/* Normalised diffusion, R_d(r) = reflectance (exp(-r/d) + exp(-r/(3 d))) / (8 pi d r).
   Burley 2015, Extending the Disney BRDF to a BSDF with integrated subsurface scattering. */
MS_SSS_API ms_status ms_sss_profile_from_burley(ms_sss_profile **profile, const double reflectance[3],
                                                const double d_mm[3], const ms_allocator *allocator, ms_error *error);

/* Burley's d for a diffuse surface albedo in [0, 1] and a mean free path: Christensen and Burley 2015, Approximate
   reflectance profiles for efficient subsurface scattering, equation 6 (searchlight configuration). */
MS_SSS_API double ms_sss_burley_d_mm(double albedo, double mean_free_path_mm);

/* From the text that examples/profile.c prints: lines "r_mm,R,G,B", comments that begin with '#', empty lines, and an
   optional heading that begins with a letter; numbers with '.' in every locale. Where each r is the middle of a ring
   (edges 0, 2 r_0, 2 r_1 - 2 r_0, ... increase), the values are ring averages, else point samples.
   text need not end with NUL. MS_BAD_DATA: error->position is the line. */
MS_SSS_API ms_status ms_sss_profile_from_csv(ms_sss_profile **profile, const char *text, size_t size,
                                             const ms_allocator *allocator, ms_error *error);

/* NULL is fine. */
MS_SSS_API void ms_sss_profile_destroy(ms_sss_profile *profile);

/* Total reflectance ||R_d||_1, 0 to 1 for a passive medium. */
MS_SSS_API void ms_sss_profile_reflectance(const ms_sss_profile *profile, double out[3]);

/* R_d(r), 1/mm^2; r >= 0. At a pole: infinity. */
MS_SSS_API void ms_sss_profile_value(const ms_sss_profile *profile, double r_mm, double out[3]);

/* Light that leaves within distance r, integral over the disc. */
MS_SSS_API void ms_sss_profile_disc(const ms_sss_profile *profile, double r_mm, double out[3]);

/* The pre-integrated kernel a_p(x) = integral of R_d(sqrt(x^2 + y^2)) over all y, 1/mm (5.4), in closed form: exact chords
   of the rings, Gaussians, K0 for Burley (infinite at x = 0). Not normalised: its integral is the reflectance. */
MS_SSS_API void ms_sss_profile_line(const ms_sss_profile *profile, double x_mm, double out[3]);

/* Integral of a_p from -x to x, in closed form. */
MS_SSS_API void ms_sss_profile_strip(const ms_sss_profile *profile, double x_mm, double out[3]);

/* Radius that holds this fraction (0 to 1) of each channel's light, to 1e-9 of itself; 0 for an empty channel. */
MS_SSS_API void ms_sss_profile_radius(const ms_sss_profile *profile, double fraction, double out[3]);

/* --------------------------------------------------------------- KERNELS */

#define MS_SSS_TAPS_MAX 257 /* taps of one 1D pass, centre included */
#define MS_SSS_TERMS_MAX 6  /* separable terms */
#define MS_SSS_DENSE (-1)   /* as tap_count: a tap every pixel of the design radius */

/* A separable kernel, ready to be applied: out = delta E + sum_t scale_t (E * w_t along x) * w_t along y.
   Normalised, but for MS_SSS_SVD: delta + sum_t scale_t (sum_i w_ti)^2 = 1 in every channel. */
typedef struct ms_sss_kernel {
    int tap_count;    /* odd; entry 0 is the centre (offset 0), then pairs -x, +x by growing |x| */
    int term_count;   /* 1 except for SVD, sums of Gaussians, residuals */
    float offset_mm[MS_SSS_TAPS_MAX];
    float weight[MS_SSS_TERMS_MAX][MS_SSS_TAPS_MAX][3]; /* of one 1D pass, applied along x, then along y */
    float scale[MS_SSS_TERMS_MAX][3]; /* factor of each term, applied once after both passes (sign of a singular value) */
    float delta[3];       /* weight of the unblurred input */
    float radius_mm;      /* the outermost |offset| plus half its cell */
    float reflectance[3]; /* the profile's total; the kernel itself is normalised */
    int frame_count;      /* 1: axes fixed; n: made for axes that stand at f * 90/n degrees in frame f and for the mean of n frames */
} ms_sss_kernel;

/* How the 2D profile becomes separable terms. Cost: 2 term_count passes. */
typedef enum ms_sss_model {
    MS_SSS_IMAGE_OPTIMAL = 0,  /* least error on pictures with a 1/f spectrum; `dial` turns it towards the next */
    MS_SSS_PREINTEGRATED = 1,  /* a_p (5.4): exact on signals that are a sum of E1(x) and E2(y) */
    MS_SSS_RESIDUAL = 2,       /* a_p plus term_count - 1 singular vectors of the rest, each exact on those signals */
    MS_SSS_SVD = 3,            /* term_count singular vectors (5.12); loses energy */
    MS_SSS_SVD_NORMALISED = 4, /* the same, scaled to keep the energy */
    MS_SSS_GAUSSIANS = 5,      /* best sum of term_count Gaussians (5.9) */
    MS_SSS_GUIDED = 6,         /* guided optimisation (5.14) with guide_k */
    MS_SSS_ARTIST = 7,         /* two Gaussians along the axes (5.6), as given or fitted to a_p */
    MS_SSS_SLICE = 8,          /* R_d sampled along the axis, as the shader that was released with the paper does */
    MS_SSS_ROTATED = 9         /* image-optimal for the mean of frame_count frames with turned axes */
} ms_sss_model;

/* Where the taps of a pass stand. */
typedef enum ms_sss_placement {
    MS_SSS_OPTIMISED = 0, /* positions and weights of least error on 1/f pictures, shared by the channels */
    MS_SSS_QUANTILE = 1,  /* importance-sampled: cells of equal energy of the widest channel */
    MS_SSS_QUADRATIC = 2  /* offsets grow with the square of their index, as in the thesis */
} ms_sss_placement;       /* in the last two each weight is the integral of the kernel over its cell */

/* The two-Gaussian model (5.6). All zero: fitted to a_p. */
typedef struct ms_sss_artist {
    double sigma_near_mm[3], sigma_far_mm[3]; /* standard deviations */
    double near_weight[3];                    /* w: share of the near Gaussian, 0 to 1 */
} ms_sss_artist;

/* Zero is the default of every field; ms_sss_kernel_defaults() returns that. */
typedef struct ms_sss_kernel_options {
    int tap_count;              /* of one pass: odd, 3 to 33 for MS_SSS_OPTIMISED, else to MS_SSS_TAPS_MAX; 0: 7; or MS_SSS_DENSE */
    int term_count;             /* 1 to MS_SSS_TERMS_MAX; 0: 1 (residual: 2) */
    ms_sss_model model;
    ms_sss_placement placement;
    int no_delta;               /* 1: no weight on the unblurred input */
    double dial;                /* image-optimal only: 0 texture ... 1 a_p, exact on axis-parallel signals */
    double guide_k;             /* guided only: 0 near scattering ... 4 far scattering; the thesis calls 2 neutral */
    int frame_count;            /* rotated only: 2 to 8; 0: 4 */
    ms_sss_artist artist;       /* artist only */
} ms_sss_kernel_options;

MS_SSS_API ms_sss_kernel_options ms_sss_kernel_defaults(void);

/* Table 5.2 (mm): the fit to d'Eon's skin, and the look that an artist chose. */
MS_SSS_API ms_sss_artist ms_sss_artist_close_fit(void);
MS_SSS_API ms_sss_artist ms_sss_artist_production(void);

/* What building kernels for one profile at one size on the screen needs to know: the profile's cells and spectrum, and
   the spectra of the standard signals. Make one, build and measure many kernels. */
typedef struct ms_sss_designer ms_sss_designer;

/* radius_px: pixels that the 99% energy radius of the widest channel covers where the kernel will be used, > 0; 0: 24.
   Kernels scale with depth when they are applied: design for the closest view that matters. Above 128 it is taken as
   128, from where on errors hardly change. The profile is read while this call runs and not kept.
   MS_INVALID_ARGUMENT: radius_px; a profile without any light. MS_OUT_OF_MEMORY: about 5 MB are needed. */
MS_SSS_API ms_status ms_sss_designer_create(ms_sss_designer **designer, const ms_sss_profile *profile, double radius_px,
                                            const ms_allocator *allocator, ms_error *error);
MS_SSS_API void ms_sss_designer_destroy(ms_sss_designer *designer);

/* One kernel. options NULL: 7 optimised taps. A channel without light gets the identity.
   Deterministic: the same bits in every call of one build. designer is only read: calls may overlap.
   MS_INVALID_ARGUMENT: an option outside its range (the message names it). MS_OUT_OF_MEMORY. kernel untouched then. */
MS_SSS_API ms_status ms_sss_kernel_build(ms_sss_kernel *kernel, const ms_sss_designer *designer,
                                         const ms_sss_kernel_options *options, ms_error *error);

/* The sum of count Gaussians that is closest to the profile in the sense of MS_SSS_GAUSSIANS: sigma_mm and weight
   [count][3], weights sum to 1; 1 <= count <= MS_SSS_TERMS_MAX. With ms_sss_transmittance's formula it is translucency in
   closed form. */
MS_SSS_API ms_status ms_sss_fit_gaussians(const ms_sss_designer *designer, int count, double (*sigma_mm)[3],
                                          double (*weight)[3], ms_error *error);

/* ---------------------------------------------------------------- ERRORS */

/* What a kernel gives up against the profile's 2D convolution: root mean square difference over the standard deviation
   of the right result, all channels together, on signals of 512 x 512 pixels that repeat. */
typedef struct ms_sss_errors {
    double vertical_step; /* an edge along an axis */
    double diagonal_step; /* an edge at 45 degrees */
    double small_disk;    /* radius 10 pixels */
    double large_disk;    /* radius 120 pixels */
    double dot;           /* one pixel */
    double texture;       /* noise with amplitude 1/f: stands for natural pictures */
} ms_sss_errors;

/* Taps between pixels are read with linear interpolation, as the filter and GPUs do. Kernels with frame_count > 1 are
   measured as the mean of their frames. */
MS_SSS_API void ms_sss_kernel_measure(ms_sss_errors *errors, const ms_sss_kernel *kernel,
                                      const ms_sss_designer *designer);

/* The cheapest kernel whose texture error is at most `tolerance`, at most tap_budget taps in all its terms together
   (each is read once in x and once in y): tries image-optimal kernels by growing tap counts, then residual ones.
   errors  out, optional
   MS_NOT_CONVERGED: none within the budget; kernel and errors then hold the most accurate one found.
   MS_INVALID_ARGUMENT: tolerance not above 0, tap_budget < 3. MS_OUT_OF_MEMORY. kernel untouched by these. */
MS_SSS_API ms_status ms_sss_kernel_choose(ms_sss_kernel *kernel, ms_sss_errors *errors, const ms_sss_designer *designer,
                                          double tolerance, int tap_budget, ms_error *error);

/* All of it in one call: designer for radius_px, kernel by options (NULL: 7 optimised taps), errors (optional). */
MS_SSS_API ms_status ms_sss_kernel_make(ms_sss_kernel *kernel, ms_sss_errors *errors, const ms_sss_profile *profile,
                                        double radius_px, const ms_sss_kernel_options *options,
                                        const ms_allocator *allocator, ms_error *error);

/* ---------------------------------------------------------- TRANSLUCENCY */

/* Colour that comes through a part of the given thickness, 1 at most: light that enters the far side, a plane at
   distance s, leaves here after integral of R_d(sqrt(r^2 + s^2)) 2 pi r dr = reflectance - disc(s). Closed form for every
   profile; for Gaussians sum_i w_i exp(-s^2 / (2 sigma_i^2)), Jimenez et al. 2010, Real-time realistic skin
   translucency. At thickness 0 it is the reflectance. */
MS_SSS_API void ms_sss_transmittance(const ms_sss_profile *profile, double thickness_mm, double out[3]);

/* The same as a table: out [count][3], entry i at thickness i * max_thickness_mm / (count - 1), count >= 2.
   Read between its entries linearly. MS_INVALID_ARGUMENT: count, a thickness not above 0; out untouched. */
MS_SSS_API ms_status ms_sss_transmittance_table(const ms_sss_profile *profile, double max_thickness_mm, int count,
                                                float (*out)[3]);

/* ---------------------------------------------------------------- FILTER */

/* Pixels in the caller's memory: three channels, or one value a pixel (depth, strength) in channel[0]. All zero: none.
   No alignment is asked beyond the element's own. The filter writes to its output alone. */
typedef struct ms_sss_image {
    void *channel[3];       /* red, green and blue of the first pixel: float, or uint16_t that hold IEEE binary16 */
    ptrdiff_t pixel_stride; /* elements from a pixel to the next: planar 1, RGB 3, RGBA and RGB + depth 4; 0: 1 */
    ptrdiff_t row_stride;   /* elements from a row to the next, negative for bottom-up; 0: width * pixel_stride */
    int half;               /* 0: float, 1: binary16 */
} ms_sss_image;

/* Views: pixels of `channels` interleaved elements of which the first three are colour (3: RGB, 4: RGBA or RGB and
   depth); three planes; one value a pixel, every stride elements (depth in RGB + depth: values = pixels + 3, stride 4).
   Rows are tightly packed; set row_stride where they are not. `half` is 0 or 1 as in ms_sss_image. */
MS_SSS_API ms_sss_image ms_sss_interleaved(const void *pixels, int channels, int half);
MS_SSS_API ms_sss_image ms_sss_planar(const void *red, const void *green, const void *blue, int half);
MS_SSS_API ms_sss_image ms_sss_map(const void *values, int stride, int half);

/* What is filtered. The input is light that entered the surface, linear, before the albedo unless the albedo is baked
   in; it must not hold specular reflection, which never went below the surface. */
typedef struct ms_sss_frame {
    int width, height;       /* 1 to 65536 each */
    ms_sss_image input;      /* linear RGB */
    ms_sss_image output;     /* every pixel is written; may be the input's own memory, but must not overlap it otherwise */
    ms_sss_image depth;      /* optional with pixels_per_mm: distance along the view axis (not along the ray), scene units */
    ms_sss_image strength;   /* optional, 0 to 1: a fraction of the effect; 0 and NaN: another material (see ms_sss_filter) */
    ms_sss_image albedo;     /* optional RGB >= 0: the output is then multiplied by it, as albedo_mode says */
    ms_sss_image specular;   /* optional RGB: added to the output, never filtered */
    const uint8_t *profile;  /* optional: index of each pixel's kernel; an index without a kernel: another material */
    ptrdiff_t profile_pixel_stride, profile_row_stride; /* in elements; 0: 1, and tightly packed */
} ms_sss_frame;

/* How a tap whose surface lies dz in front of or behind the pixel counts. */
typedef enum ms_sss_depth_mode {
    MS_SSS_DEPTH_AWARE = 0,  /* weight * exp(-dz^2 / (2 sigma^2)), 0 beyond the kernel's radius; the rest is renormalised */
    MS_SSS_DEPTH_FOLLOW = 1, /* older engines: the tap's colour fades to the pixel's own over follow_mm */
    MS_SSS_DEPTH_SCALE = 2   /* depth sets the kernel's size in pixels only; light leaks across silhouettes */
} ms_sss_depth_mode;

/* Where the surface's colour acts: light crosses it when it leaves, when it enters, or half and half. */
typedef enum ms_sss_albedo_mode {
    MS_SSS_ALBEDO_POST = 0, /* albedo * filter(input): keeps texture sharp */
    MS_SSS_ALBEDO_PRE = 1,  /* filter(albedo * input): blurs texture as well */
    MS_SSS_ALBEDO_BOTH = 2  /* sqrt(albedo) * filter(sqrt(albedo) * input) */
} ms_sss_albedo_mode;

/* Zero, as from ms_sss_filter_defaults(), is the default of every field but one of the three that give the size of a
   pixel: set exactly one of pixels_per_mm[0], fov_degrees and ortho_height. */
typedef struct ms_sss_filter_options {
    float pixels_per_mm[2];  /* texture space: pixels a millimetre along x and y; [1] 0: as [0] */
    float fov_degrees;       /* perspective: the picture's full angle along y, in (0, 180) */
    float ortho_height;      /* orthographic: scene units from the picture's top to its bottom */
    float mm_per_unit;       /* millimetres in a scene unit; 0: 1 (the scene is in mm) */
    int uv_steps;            /* 0: square pixels, kernel round; 1: older engines' steps in uv, wider by width / height along x */
    ms_sss_depth_mode depth_mode;
    float depth_sigma_mm;    /* sigma of MS_SSS_DEPTH_AWARE; 0: a third of the kernel's radius */
    float follow_mm;         /* of MS_SSS_DEPTH_FOLLOW: |dz| at which nothing of the tap is left; 0: the kernel's radius */
    ms_sss_albedo_mode albedo_mode;
    float fade;              /* 0: full effect, 1: none; the strength is 1 - fade times the strength map */
    float rotation;          /* radians from +x towards +y: the axes of both passes (a kernel designed for it, or 0) */
    float jitter;            /* 0 to 1: turns each pixel's axes by up to this part of 90 degrees (interleaved noise); the
                                error gets no lower: noise hides structure */
    ms_simd simd;            /* cap of the instruction set */
    ms_parallel parallel;
} ms_sss_filter_options;

MS_SSS_API ms_sss_filter_options ms_sss_filter_defaults(void);

/* Bytes that ms_sss_filter needs for frames of this size: about 20 a pixel, 32 with kernels of several terms, 48 with
   rotation or jitter. Depends on width, height, kernels and options only; SIZE_MAX: more than this machine can address. */
MS_SSS_API size_t ms_sss_filter_workspace(int width, int height, const ms_sss_kernel *kernels, int kernel_count,
                                          const ms_sss_filter_options *options);

/* Subsurface scattering of a picture or a texture: out = delta E + sum_t scale_t (E * w_t along x) * w_t along y, then
   (1 - strength) E + strength out, once after both passes. E is the input (times albedo, see albedo_mode).
   frame           see there; width x height
   kernels         [kernel_count], 1 to 256
   options         NULL: not possible, one of the three sizes is needed
   workspace       ms_sss_filter_workspace(...) bytes, any alignment and content
   - A tap reads the two pixels beside its position (four with rotation or jitter), each weighted by its own depth.
   - Pixels take no part, and are returned as they are (times albedo, plus specular), where a channel is not finite, the
     depth is not finite or not positive, the strength is 0 or NaN, or the profile has no kernel. Their colour never
     reaches another pixel. Nor does light cross between profiles.
   - What of a kernel falls outside the picture or on such pixels is made up for by the rest: a constant stays constant.
     A kernel whose terms have weights of both signs gives what is missing to the pixel's own colour instead.
   - Where the kernel's radius is under half a pixel, and where strength is 0, the input is returned bit for bit (without
     albedo and specular). A radius above the larger side of the picture is reduced to it.
   - Depth edges wider than the kernel's radius let nothing through.
   Bit-equal for any thread count at one level; across levels within 2e-6 of the largest input near the pixel.
   Work is in proportion to the pixels that take part. No allocation. Calls may overlap if workspace and output differ.
   MS_INVALID_ARGUMENT: a pointer, size, stride or option out of range (nothing written). Thesis 5.5, 5.8.2, 5.10;
   Jimenez et al. 2009, "Screen-space perceptual rendering of human skin". */
MS_SSS_API ms_status ms_sss_filter(const ms_sss_frame *frame, const ms_sss_kernel *kernels, int kernel_count,
                                   const ms_sss_filter_options *options, void *workspace, size_t workspace_size,
                                   ms_error *error);

/* --------------------------------------------------------------- PYRAMID */

/* -------------------------------------------------------------- GPU TEXT */

#ifdef __cplusplus
}
#endif
#endif /* MS_SSS_H */

#if defined(MS_SSS_IMPLEMENTATION) && !defined(MS_SSS__PASS)
/* ms-common-private begin (the same text in every ms_*.h; `make common` copies it from ms_mcml.h) */
#ifndef MS_COMMON_PRIVATE
#define MS_COMMON_PRIVATE
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* MS_NO_SIMD leaves the scalar text of every header. 32-bit x86 has no baseline that can be relied on. */
#if !defined(MS_NO_SIMD) && (defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC)))
#define MS__X64 1
#include <immintrin.h>
#if defined(_MSC_VER)
#include <intrin.h>
#else
#include <cpuid.h>
#endif
#elif !defined(MS_NO_SIMD) && (defined(__aarch64__) || defined(_M_ARM64))
#define MS__NEON 1
#include <arm_neon.h>
#endif

#ifndef MS_ASSERT /* checks of the library's own invariants, never of the caller's data */
#define MS_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__)
#define MS__UNUSED __attribute__((unused))
#else
#define MS__UNUSED
#endif

/* Returns a * b or a + b; SIZE_MAX stands for overflow and stays so through further calls. */
static MS__UNUSED size_t ms__size_mul(size_t a, size_t b)
{
    if (a == SIZE_MAX || b == SIZE_MAX) return SIZE_MAX;
    return a != 0 && b > SIZE_MAX / a ? SIZE_MAX : a * b;
}

static MS__UNUSED size_t ms__size_add(size_t a, size_t b)
{
    return b > SIZE_MAX - a ? SIZE_MAX : a + b;
}

/* NULL for size SIZE_MAX (overflow). Size 0 gives a pointer that must be released as well. */
static MS__UNUSED void *ms__alloc(const ms_allocator *allocator, size_t size)
{
    if (size == SIZE_MAX) return NULL;
    if (allocator != NULL && allocator->alloc != NULL)
        return allocator->alloc(allocator->user, size ? size : 1);
    return malloc(size ? size : 1);
}

static MS__UNUSED void ms__release(const ms_allocator *allocator, void *pointer, size_t size)
{
    if (pointer == NULL) return;
    if (allocator != NULL && allocator->alloc != NULL) {
        if (allocator->release != NULL) allocator->release(allocator->user, pointer, size ? size : 1);
    } else {
        free(pointer);
    }
}

static MS__UNUSED void ms__run(const ms_parallel *parallel, int count, void (*task)(void *context, int index),
                               void *context)
{
    int i;
    if (parallel != NULL && parallel->run != NULL && count > 1) {
        parallel->run(parallel->user, count, task, context);
    } else {
        for (i = 0; i < count; ++i) task(context, i);
    }
}

/* By its bits: isfinite() is removed by -ffast-math. */
static MS__UNUSED int ms__finite(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

static MS__UNUSED int ms__finite_f(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7f800000u) != 0x7f800000u;
}

/* x as text with 6 significant digits and '.' in every locale; at least 24 bytes in out. Its length. */
static MS__UNUSED int ms__format_number(char *out, double x)
{
    char digit[8];
    int n = 0, exponent = 0, i, last;
    int64_t mantissa;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (!ms__finite(x)) {
        const char *name = (bits & 0xfffffffffffffu) ? "nan" : (bits >> 63) ? "-inf" : "inf";
        for (; name[n]; ++n) out[n] = name[n];
        out[n] = 0;
        return n;
    }
    if (bits >> 63) {
        out[n++] = '-';
        x = -x;
    }
    if (!(x > 0)) {
        out[n++] = '0';
        out[n] = 0;
        return n;
    }
    while (x >= 1e6) { x /= 10; ++exponent; }
    while (x < 1e5) { x *= 10; --exponent; }
    mantissa = (int64_t)(x + 0.5);
    if (mantissa >= 1000000) { mantissa /= 10; ++exponent; }
    exponent += 5;
    for (i = 5; i >= 0; --i) {
        digit[i] = (char)('0' + (int)(mantissa % 10));
        mantissa /= 10;
    }
    for (last = 5; last > 0 && digit[last] == '0';) --last;
    if (exponent >= -4 && exponent < 7) {
        if (exponent < 0) {
            out[n++] = '0';
            out[n++] = '.';
            for (i = -1; i > exponent; --i) out[n++] = '0';
            for (i = 0; i <= last; ++i) out[n++] = digit[i];
        } else {
            for (i = 0; i <= last || i <= exponent; ++i) {
                if (i == exponent + 1) out[n++] = '.';
                out[n++] = i < 6 ? digit[i] : '0';
            }
        }
    } else {
        out[n++] = digit[0];
        if (last > 0) out[n++] = '.';
        for (i = 1; i <= last; ++i) out[n++] = digit[i];
        out[n++] = 'e';
        out[n++] = exponent < 0 ? '-' : '+';
        if (exponent < 0) exponent = -exponent;
        if (exponent >= 100) out[n++] = (char)('0' + exponent / 100);
        out[n++] = (char)('0' + exponent / 10 % 10);
        out[n++] = (char)('0' + exponent % 10);
    }
    out[n] = 0;
    return n;
}

/* Fills error (may be NULL) and returns status. The format knows %s (char pointer), %d (int), %z (size_t),
   %g (double) and %%; a text that is too long is cut, a control character becomes '?'. */
static MS__UNUSED ms_status ms__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    char number[32];
    size_t n = 0, room, i;
    va_list list;
    if (error == NULL) return status;
    error->status = status;
    error->position = position;
    room = sizeof error->message - 1;
    va_start(list, format);
    for (; *format; ++format) {
        const char *piece = number;
        number[0] = *format;
        number[1] = 0;
        if (*format == '%' && format[1]) {
            ++format;
            if (*format == 's') {
                piece = va_arg(list, const char *);
            } else if (*format == 'g') {
                ms__format_number(number, va_arg(list, double));
            } else if (*format == 'd' || *format == 'z') {
                char reversed[24];
                size_t k = 0, m = 0, value;
                if (*format == 'd') {
                    int64_t v = va_arg(list, int);
                    if (v < 0) number[m++] = '-';
                    value = (size_t)(v < 0 ? -v : v);
                } else {
                    value = va_arg(list, size_t);
                }
                do {
                    reversed[k++] = (char)('0' + (int)(value % 10));
                    value /= 10;
                } while (value);
                while (k) number[m++] = reversed[--k];
                number[m] = 0;
            }
        }
        for (i = 0; piece[i] && n < room; ++i)
            error->message[n++] = (unsigned char)piece[i] < 32 || piece[i] == 127 ? '?' : piece[i];
    }
    va_end(list);
    error->message[n] = 0;
    return status;
}

/* Philox 4x32-10 (Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3"): four words
   from a 128-bit counter and a 64-bit key, integers only, so the same on any thread, level and machine. */
static MS__UNUSED void ms__philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
    uint32_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3], k0 = key[0], k1 = key[1];
    int round;
    for (round = 0; round < 10; ++round) {
        uint64_t p0 = (uint64_t)0xD2511F53u * c0, p1 = (uint64_t)0xCD9E8D57u * c2;
        c0 = (uint32_t)(p1 >> 32) ^ c1 ^ k0;
        c1 = (uint32_t)p1;
        c2 = (uint32_t)(p0 >> 32) ^ c3 ^ k1;
        c3 = (uint32_t)p0;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
    out[0] = c0;
    out[1] = c1;
    out[2] = c2;
    out[3] = c3;
}

/* A stream of random numbers: f(seed, stream, how many were drawn). */
typedef struct ms__rng {
    uint32_t counter[4], key[2], word[4];
    int used; /* words of this block already given out */
} ms__rng;

static MS__UNUSED ms__rng ms__rng_make(uint64_t seed, uint64_t stream)
{
    ms__rng rng;
    memset(&rng, 0, sizeof rng);
    rng.key[0] = (uint32_t)seed;
    rng.key[1] = (uint32_t)(seed >> 32);
    rng.counter[2] = (uint32_t)stream;
    rng.counter[3] = (uint32_t)(stream >> 32);
    rng.used = 4;
    return rng;
}

static MS__UNUSED uint32_t ms__rng_u32(ms__rng *rng)
{
    if (rng->used == 4) {
        ms__philox(rng->counter, rng->key, rng->word);
        if (++rng->counter[0] == 0) ++rng->counter[1];
        rng->used = 0;
    }
    return rng->word[rng->used++];
}

/* Uniform in the open interval (0, 1), 53 bits: never 0, never 1. */
static MS__UNUSED double ms__rng_uniform(ms__rng *rng)
{
    uint64_t a = ms__rng_u32(rng), b = ms__rng_u32(rng);
    return ((double)(((a << 32) | b) >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}

#if defined(MS__X64)
static MS__UNUSED void ms__cpuid(uint32_t leaf, uint32_t subleaf, uint32_t r[4])
{
#if defined(_MSC_VER)
    int v[4];
    __cpuidex(v, (int)leaf, (int)subleaf);
    r[0] = (uint32_t)v[0]; r[1] = (uint32_t)v[1]; r[2] = (uint32_t)v[2]; r[3] = (uint32_t)v[3];
#else
    __cpuid_count(leaf, subleaf, r[0], r[1], r[2], r[3]);
#endif
}

/* What both the processor and the operating system (OSXSAVE, XCR0) support. */
static MS__UNUSED int ms__simd_detect(void)
{
    uint32_t r[4], xcr0, leaf1;
    ms__cpuid(0, 0, r);
    if (r[0] < 7) return MS_SIMD_BASE;
    ms__cpuid(1, 0, r);
    leaf1 = r[2];
    if (!(leaf1 & (1u << 27))) return MS_SIMD_BASE; /* OSXSAVE */
#if defined(_MSC_VER)
    xcr0 = (uint32_t)_xgetbv(0);
#else
    {
        uint32_t high;
        __asm__ volatile("xgetbv" : "=a"(xcr0), "=d"(high) : "c"(0));
        (void)high;
    }
#endif
    ms__cpuid(7, 0, r);
    if ((xcr0 & 0x6u) != 0x6u || !(leaf1 & (1u << 12)) || !(leaf1 & (1u << 29)) || !(r[1] & (1u << 5)))
        return MS_SIMD_BASE; /* YMM state, FMA, F16C, AVX2 */
    if ((xcr0 & 0xe6u) != 0xe6u || (r[1] & 0xC0030000u) != 0xC0030000u)
        return MS_SIMD_AVX2; /* ZMM state, AVX-512 F, DQ, BW, VL */
    return MS_SIMD_AVX512;
}
#endif

/* The level to use under a cap. cpuid takes microseconds under a hypervisor: ask once when an object is made
   or at the start of a long call, never in a loop. Nothing is kept in a global. */
static MS__UNUSED ms_simd ms__simd_pick(ms_simd cap)
{
    int best = MS_SIMD_SCALAR;
    if (cap == MS_SIMD_SCALAR) return cap;
#if defined(MS__X64)
    best = cap == MS_SIMD_BASE ? MS_SIMD_BASE : ms__simd_detect();
#elif defined(MS__NEON)
    best = MS_SIMD_BASE;
#endif
    return (ms_simd)(cap != MS_SIMD_AUTO && (int)cap < best ? (int)cap : best);
}
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* ----------------------------------------------------------- SMALL MATHS */
#include <float.h>
#include <math.h>

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

/* One step of Levenberg and Marquardt: solves (H + lambda diag H) step = g. work [n][n]. */
static int ms_sss__marquardt(const double *H, const double *g, double lambda, int n, double *work, double *step)
{
    int i;
    memcpy(work, H, sizeof *work * (size_t)n * (size_t)n);
    memcpy(step, g, sizeof *step * (size_t)n);
    for (i = 0; i < n; ++i) work[(size_t)i * (size_t)n + (size_t)i] += lambda * H[(size_t)i * (size_t)n + (size_t)i] + DBL_MIN;
    return ms_sss__cholesky_solve(work, step, n);
}

/* K_0(x) and the Bickley function Ki_1(x), the integral of K_0 from x to infinity: the trapezoidal rule on
   exp(-x cosh u) and exp(-x cosh u) / cosh u, whose error exp(-pi^2 / step) is below rounding. */
static double ms_sss__bessel_k0(double x)
{
    double sum = 0.5 * exp(-x), term;
    int i;
    if (!(x > 0)) return HUGE_VAL;
    for (i = 1; (term = exp(-x * cosh(0.25 * i))) > 0 && i < 4000; ++i) sum += term;
    return 0.25 * sum;
}

static double ms_sss__bickley_1(double x)
{
    double sum = 0.5 * exp(-x), term = 1;
    int i;
    for (i = 1; term > 1e-18 * sum && i < 4000; ++i) {
        double c = cosh(0.25 * i);
        sum += term = exp(-x * c) / c;
    }
    return 0.25 * sum;
}

/* Area that the disc of radius r has in common with [0, x] x [0, y]; odd in x and y. */
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

/* -------------------------------------------------------- PROFILE TABLES */

typedef enum ms_sss__profile_kind { MS_SSS__RINGS, MS_SSS__GAUSSIANS, MS_SSS__BURLEY } ms_sss__profile_kind;

struct ms_sss_profile {
    ms_sss__profile_kind kind;
    int count;                    /* rings or Gaussians */
    double *edge;                 /* [count + 1] radii */
    double *mean[3], *slope[3];   /* [count] R_d = mean + slope (r^2 - middle), middle of the ring's r^2 */
    double *inside[3];            /* [count + 1] energy within edge[i] */
    double sigma[MS_SSS_GAUSSIANS_MAX][3], weight[MS_SSS_GAUSSIANS_MAX][3]; /* Burley: d and reflectance in [0] */
    size_t bytes;
    ms_allocator allocator;
};

static ms_status ms_sss__profile_alloc(ms_sss_profile **out, ms_sss__profile_kind kind, int count,
                                       const ms_allocator *allocator, ms_error *error)
{
    size_t header = (sizeof(ms_sss_profile) + 63) / 64 * 64, rings = kind == MS_SSS__RINGS ? (size_t)count : 0;
    size_t bytes = ms__size_add(header, ms__size_mul(ms__size_add(ms__size_mul(rings, 10), 4), sizeof(double)));
    ms_sss_profile *profile = (ms_sss_profile *)ms__alloc(allocator, bytes);
    double *at;
    int c;
    if (profile == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a profile of %z bytes", bytes);
    memset(profile, 0, sizeof *profile);
    profile->kind = kind;
    profile->count = count;
    profile->bytes = bytes;
    if (allocator != NULL) profile->allocator = *allocator;
    at = (double *)(void *)((unsigned char *)profile + header);
    profile->edge = at;
    at += rings + 1;
    for (c = 0; c < 3; ++c, at += 3 * rings + 1) {
        profile->mean[c] = at;
        profile->slope[c] = at + rings;
        profile->inside[c] = at + 2 * rings;
    }
    *out = profile;
    return MS_OK;
}

/* Energy of the part of a ring with r^2 in [ring's first, s]: pi times the integral of R_d over r^2. */
static double ms_sss__ring_energy(const ms_sss_profile *p, int c, int i, double s)
{
    double s0 = p->edge[i] * p->edge[i], s1 = p->edge[i + 1] * p->edge[i + 1];
    return MS_SSS__PI * (s - s0) * (p->mean[c][i] + p->slope[c][i] * 0.5 * (s - s1));
}

static void ms_sss__profile_accumulate(ms_sss_profile *p)
{
    int c, i;
    for (c = 0; c < 3; ++c) {
        p->inside[c][0] = 0;
        for (i = 0; i < p->count; ++i)
            p->inside[c][i + 1] = p->inside[c][i] + ms_sss__ring_energy(p, c, i, p->edge[i + 1] * p->edge[i + 1]);
    }
}

static ms_status ms_sss__check_table(int count, int least, const double *radius, int radii,
                                     const double *const value[3], int stride, ms_error *error)
{
    int i, c;
    if (count < least || radius == NULL || value == NULL || value[0] == NULL || value[1] == NULL || value[2] == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%d rows of a profile; at least %d and no NULL expected", count, least);
    if (stride < 1) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "stride is %d; 0 or more expected", stride);
    for (i = 0; i < radii; ++i)
        if (!ms__finite(radius[i]) || radius[i] < 0 || radius[i] > 1e9 || (i > 0 && radius[i] <= radius[i - 1]))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                            "radius %d is %g mm; increasing, finite, 0 to 1e9 expected", i, radius[i]);
    for (i = 0; i < count; ++i)
        for (c = 0; c < 3; ++c) {
            double v = value[c][(size_t)i * (size_t)stride];
            if (!ms__finite(v) || v < 0 || v > 1e30)
                return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                                "R_d of row %d, channel %d is %g; finite, 0 to 1e30 expected", i, c, v);
        }
    return MS_OK;
}

MS_SSS_API ms_status ms_sss_profile_from_rings(ms_sss_profile **profile, int count, const double *edge_mm,
                                               const double *const value[3], int stride, const ms_allocator *allocator,
                                               ms_error *error)
{
    ms_sss_profile *p;
    ms_status status;
    int i, c;
    if (profile == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "profile is NULL");
    *profile = NULL;
    if (stride == 0) stride = 1;
    status = ms_sss__check_table(count, 1, edge_mm, count + 1, value, stride, error);
    if (status == MS_OK) status = ms_sss__profile_alloc(&p, MS_SSS__RINGS, count, allocator, error);
    if (status != MS_OK) return status;
    memcpy(p->edge, edge_mm, sizeof *edge_mm * ((size_t)count + 1));
    for (c = 0; c < 3; ++c) {
        double *mean = p->mean[c];
        for (i = 0; i < count; ++i) mean[i] = value[c][(size_t)i * (size_t)stride];
        for (i = 0; i < count; ++i) { /* van Leer's limited slope over r^2: zero at extrema, never below R_d = 0 */
            double s0 = p->edge[i] * p->edge[i], s1 = p->edge[i + 1] * p->edge[i + 1], left, right, slope, most;
            p->slope[c][i] = 0;
            if (i + 1 == count) break;
            right = (mean[i + 1] - mean[i]) / (0.5 * (p->edge[i + 2] * p->edge[i + 2] - s0));
            left = i == 0 ? right : (mean[i] - mean[i - 1]) / (0.5 * (s1 - p->edge[i - 1] * p->edge[i - 1]));
            if (left * right <= 0) continue;
            slope = 2 * left * right / (left + right);
            most = 2 * mean[i] / (s1 - s0);
            p->slope[c][i] = slope > most ? most : slope < -most ? -most : slope;
        }
    }
    ms_sss__profile_accumulate(p);
    *profile = p;
    return MS_OK;
}

MS_SSS_API ms_status ms_sss_profile_from_samples(ms_sss_profile **profile, int count, const double *r_mm,
                                                 const double *const value[3], int stride,
                                                 const ms_allocator *allocator, ms_error *error)
{
    ms_sss_profile *p;
    ms_status status;
    int i, c, inner;
    if (profile == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "profile is NULL");
    *profile = NULL;
    if (stride == 0) stride = 1;
    status = ms_sss__check_table(count, 2, r_mm, count, value, stride, error);
    if (status != MS_OK) return status;
    inner = r_mm[0] > 0; /* one ring more, inside the first sample */
    status = ms_sss__profile_alloc(&p, MS_SSS__RINGS, count - 1 + inner, allocator, error);
    if (status != MS_OK) return status;
    p->edge[0] = 0;
    memcpy(p->edge + inner, r_mm, sizeof *r_mm * (size_t)count);
    for (c = 0; c < 3; ++c) {
        p->mean[c][0] = value[c][0];
        p->slope[c][0] = 0;
        for (i = 0; i + 1 < count; ++i) {
            double v0 = value[c][(size_t)i * (size_t)stride], v1 = value[c][((size_t)i + 1) * (size_t)stride];
            p->mean[c][i + inner] = 0.5 * (v0 + v1);
            p->slope[c][i + inner] = (v1 - v0) / ((r_mm[i + 1] - r_mm[i]) * (r_mm[i + 1] + r_mm[i]));
        }
    }
    ms_sss__profile_accumulate(p);
    *profile = p;
    return MS_OK;
}

MS_SSS_API ms_status ms_sss_profile_from_gaussians(ms_sss_profile **profile, int count, const double (*sigma_mm)[3],
                                                   const double (*weight)[3], const ms_allocator *allocator,
                                                   ms_error *error)
{
    ms_status status;
    int i, c;
    if (profile == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "profile is NULL");
    *profile = NULL;
    if (count < 1 || count > MS_SSS_GAUSSIANS_MAX || sigma_mm == NULL || weight == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%d Gaussians; 1 to %d expected", count, MS_SSS_GAUSSIANS_MAX);
    for (i = 0; i < count; ++i)
        for (c = 0; c < 3; ++c)
            if (!(sigma_mm[i][c] >= 1e-9 && sigma_mm[i][c] <= 1e9 && weight[i][c] >= 0 && weight[i][c] <= 1e9))
                return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                                "Gaussian %d, channel %d: sigma %g mm, weight %g; 1e-9 to 1e9 and 0 to 1e9 expected", i, c,
                                sigma_mm[i][c], weight[i][c]);
    status = ms_sss__profile_alloc(profile, MS_SSS__GAUSSIANS, count, allocator, error);
    if (status != MS_OK) return status;
    memcpy((*profile)->sigma, sigma_mm, sizeof *sigma_mm * (size_t)count);
    memcpy((*profile)->weight, weight, sizeof *weight * (size_t)count);
    return MS_OK;
}

MS_SSS_API ms_status ms_sss_profile_from_burley(ms_sss_profile **profile, const double reflectance[3],
                                                const double d_mm[3], const ms_allocator *allocator, ms_error *error)
{
    ms_status status;
    int c;
    if (profile == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "profile is NULL");
    *profile = NULL;
    for (c = 0; c < 3; ++c)
        if (!(reflectance[c] >= 0 && reflectance[c] <= 1e9 && d_mm[c] >= 1e-9 && d_mm[c] <= 1e9))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)c,
                            "channel %d: reflectance %g, d %g mm; 0 to 1e9 and 1e-9 to 1e9 expected", c, reflectance[c], d_mm[c]);
    status = ms_sss__profile_alloc(profile, MS_SSS__BURLEY, 1, allocator, error);
    if (status != MS_OK) return status;
    memcpy((*profile)->sigma[0], d_mm, sizeof(double) * 3);
    memcpy((*profile)->weight[0], reflectance, sizeof(double) * 3);
    return MS_OK;
}

MS_SSS_API double ms_sss_burley_d_mm(double albedo, double mean_free_path_mm)
{
    double t = (albedo - 0.33) * (albedo - 0.33);
    return mean_free_path_mm / (3.5 + 100 * t * t);
}

/* Reads a decimal number at *at, before end, without locale: up to 19 digits exact, the rest by their magnitude.
   0: there is none. */
static int ms_sss__read_number(const char **at, const char *end, double *value)
{
    const char *p = *at;
    uint64_t mantissa = 0;
    int negative = 0, exponent = 0, digits = 0, point = 0, kept = 0;
    double x;
    if (p < end && (*p == '-' || *p == '+')) negative = *p++ == '-';
    for (; p < end && ((*p >= '0' && *p <= '9') || (*p == '.' && !point)); ++p) {
        if (*p == '.') { point = 1; continue; }
        ++digits;
        if (kept < 19) {
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
            kept += mantissa > 0;
            exponent -= point;
        } else {
            exponent += !point;
        }
    }
    if (digits == 0) return 0;
    if (p < end && (*p == 'e' || *p == 'E')) {
        int power = 0, down = 0;
        ++p;
        if (p < end && (*p == '-' || *p == '+')) down = *p++ == '-';
        if (p >= end || *p < '0' || *p > '9') return 0;
        for (; p < end && *p >= '0' && *p <= '9'; ++p)
            if (power < 10000) power = power * 10 + (*p - '0');
        exponent += down ? -power : power;
    }
    x = (double)mantissa;
    if (mantissa != 0) x = exponent < -330 ? 0 : exponent > 330 ? HUGE_VAL
                         : exponent < -290 ? x * pow(10, exponent + 40) * 1e-40
                         : exponent < 0 && exponent >= -22 ? x / pow(10, -exponent) : x * pow(10, exponent);
    *value = negative ? -x : x;
    *at = p;
    return 1;
}

/* One line of the file: 1: four numbers in row, 0: nothing to read, -1: malformed. */
static int ms_sss__csv_row(const char *line, const char *end, int heading_allowed, double row[4])
{
    int column;
    while (end > line && (end[-1] == '\r' || end[-1] == ' ' || end[-1] == '\t')) --end;
    while (line < end && (*line == ' ' || *line == '\t')) ++line;
    if (line == end || *line == '#') return 0;
    if (heading_allowed && ((*line >= 'a' && *line <= 'z') || (*line >= 'A' && *line <= 'Z'))) return 0;
    for (column = 0; column < 4; ++column) {
        while (line < end && (*line == ' ' || *line == '\t')) ++line;
        if (!ms_sss__read_number(&line, end, &row[column])) return -1;
        while (line < end && (*line == ' ' || *line == '\t')) ++line;
        if (column < 3 && (line >= end || *line++ != ',')) return -1;
    }
    return line == end ? 1 : -1;
}

MS_SSS_API ms_status ms_sss_profile_from_csv(ms_sss_profile **profile, const char *text, size_t size,
                                             const ms_allocator *allocator, ms_error *error)
{
    const char *line = text, *end = text + size;
    const double *value[3];
    double row[4], *r, *edge;
    size_t line_number = 0, rows = 0, capacity = 1, bytes, i;
    ms_status status = MS_OK;
    int kind, rings = 1;
    if (profile == NULL || text == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "profile or text is NULL");
    *profile = NULL;
    for (i = 0; i < size; ++i) capacity += text[i] == '\n';
    if (capacity > 1u << 24) return ms__fail(error, MS_UNSUPPORTED, 0, "%z lines; at most 16777216 expected", capacity);
    bytes = ms__size_mul(capacity * 5 + 1, sizeof *r);
    r = (double *)ms__alloc(allocator, bytes);
    if (r == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z lines", capacity);
    edge = r + capacity * 4;
    while (line < end && status == MS_OK) {
        const char *stop = (const char *)memchr(line, '\n', (size_t)(end - line));
        if (stop == NULL) stop = end;
        ++line_number;
        kind = ms_sss__csv_row(line, stop, rows == 0, row);
        if (kind < 0)
            status = ms__fail(error, MS_BAD_DATA, line_number, "line %z is not r_mm,R,G,B", line_number);
        else if (kind > 0 && (!(row[0] >= 0 && row[0] <= 1e9) || (rows > 0 && row[0] <= r[rows - 1])))
            status = ms__fail(error, MS_BAD_DATA, line_number, "line %z: r_mm is %g; increasing, 0 to 1e9 expected",
                              line_number, row[0]);
        else if (kind > 0 && !(row[1] >= 0 && row[1] <= 1e30 && row[2] >= 0 && row[2] <= 1e30 && row[3] >= 0 && row[3] <= 1e30))
            status = ms__fail(error, MS_BAD_DATA, line_number, "line %z: a value outside 0 to 1e30", line_number);
        else if (kind > 0) {
            for (i = 0; i < 4; ++i) r[i * capacity + rows] = row[i];
            ++rows;
        }
        line = stop + (stop < end);
    }
    if (status == MS_OK && rows < 2)
        status = ms__fail(error, MS_BAD_DATA, line_number, "%z rows r_mm,R,G,B; at least 2 expected", rows);
    if (status == MS_OK) {
        for (i = 0; i < 3; ++i) value[i] = r + (i + 1) * capacity;
        edge[0] = 0;
        for (i = 0; i < rows && rings; ++i) { /* r_i = (edge_i + edge_{i+1}) / 2 */
            edge[i + 1] = 2 * r[i] - edge[i];
            rings = edge[i + 1] > r[i] && (i + 1 == rows || edge[i + 1] < r[i + 1]);
        }
        status = rings ? ms_sss_profile_from_rings(profile, (int)rows, edge, value, 1, allocator, error)
                       : ms_sss_profile_from_samples(profile, (int)rows, r, value, 1, allocator, error);
    }
    ms__release(allocator, r, bytes);
    return status;
}

MS_SSS_API void ms_sss_profile_destroy(ms_sss_profile *profile)
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
    if (r >= p->edge[p->count]) return p->count;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (p->edge[middle] <= r) low = middle; else high = middle;
    }
    return low;
}

MS_SSS_API void ms_sss_profile_value(const ms_sss_profile *p, double r, double out[3])
{
    int c, i;
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) {
            i = ms_sss__ring_of(p, r);
            if (i < 0 || i >= p->count) continue;
            out[c] = p->mean[c][i] + p->slope[c][i] * (r * r - 0.5 * (p->edge[i] * p->edge[i] + p->edge[i + 1] * p->edge[i + 1]));
        } else if (p->kind == MS_SSS__BURLEY) {
            double d = p->sigma[0][c];
            if (p->weight[0][c] > 0) out[c] = p->weight[0][c] * (exp(-r / d) + exp(-r / (3 * d))) / (8 * MS_SSS__PI * d * r);
        } else {
            for (i = 0; i < p->count; ++i) {
                double v = p->sigma[i][c] * p->sigma[i][c];
                out[c] += p->weight[i][c] * exp(-r * r / (2 * v)) / (2 * MS_SSS__PI * v);
            }
        }
    }
}

MS_SSS_API void ms_sss_profile_disc(const ms_sss_profile *p, double r, double out[3])
{
    int c, i;
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) {
            i = ms_sss__ring_of(p, r);
            if (i >= 0) out[c] = p->inside[c][i];
            if (i >= 0 && i < p->count) out[c] += ms_sss__ring_energy(p, c, i, r * r);
        } else if (p->kind == MS_SSS__BURLEY) {
            double t = r / p->sigma[0][c];
            out[c] = -p->weight[0][c] * (0.25 * expm1(-t) + 0.75 * expm1(-t / 3));
        } else {
            for (i = 0; i < p->count; ++i)
                out[c] -= p->weight[i][c] * expm1(-r * r / (2 * p->sigma[i][c] * p->sigma[i][c]));
        }
    }
}

MS_SSS_API void ms_sss_profile_reflectance(const ms_sss_profile *p, double out[3])
{
    ms_sss_profile_disc(p, p->kind == MS_SSS__RINGS ? p->edge[p->count] : 1e30, out);
}

MS_SSS_API void ms_sss_profile_radius(const ms_sss_profile *p, double fraction, double out[3])
{
    double total[3], inside[3];
    int c, i;
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
        while (high - low > 1e-10 * high) {
            double middle = 0.5 * (low + high);
            ms_sss_profile_disc(p, middle, inside);
            if (inside[c] >= fraction * total[c]) high = middle; else low = middle;
        }
        out[c] = high;
    }
}

/* ------------------------------------------------------- PRE-INTEGRATION */

/* The chord at distance x through R_d = mean + slope (x^2 + u^2 - middle): 2 times the integral over u from 0. */
static double ms_sss__chord(double mean, double slope, double u)
{
    return 2 * u * (mean + slope * u * u / 3);
}

MS_SSS_API void ms_sss_profile_line(const ms_sss_profile *p, double x, double out[3])
{
    int c, i;
    x = fabs(x);
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) {
            double u0 = 0;
            i = ms_sss__ring_of(p, x);
            if (i < 0) {
                i = 0;
                u0 = sqrt((p->edge[0] - x) * (p->edge[0] + x));
            }
            for (; i < p->count; ++i) { /* r = sqrt(x^2 + u^2) runs over the ring as u runs from u0 to u1 */
                double u1 = sqrt((p->edge[i + 1] - x) * (p->edge[i + 1] + x));
                double middle = 0.5 * (p->edge[i] * p->edge[i] + p->edge[i + 1] * p->edge[i + 1]);
                double mean = p->mean[c][i] + p->slope[c][i] * (x * x - middle);
                out[c] += ms_sss__chord(mean, p->slope[c][i], u1) - ms_sss__chord(mean, p->slope[c][i], u0);
                u0 = u1;
            }
        } else if (p->kind == MS_SSS__BURLEY) { /* the integral of exp(-r/d)/r along a line is 2 K_0(x/d) */
            double d = p->sigma[0][c];
            if (p->weight[0][c] > 0)
                out[c] = p->weight[0][c] * (ms_sss__bessel_k0(x / d) + ms_sss__bessel_k0(x / (3 * d))) / (4 * MS_SSS__PI * d);
        } else {
            for (i = 0; i < p->count; ++i) {
                double s = p->sigma[i][c];
                out[c] += p->weight[i][c] * exp(-x * x / (2 * s * s)) / (s * sqrt(2 * MS_SSS__PI));
            }
        }
    }
}

MS_SSS_API void ms_sss_profile_strip(const ms_sss_profile *p, double x, double out[3])
{
    int c, i;
    x = fabs(x);
    for (c = 0; c < 3; ++c) {
        out[c] = 0;
        if (p->kind == MS_SSS__RINGS) { /* a circle of radius r has the fraction 2/pi asin(x/r) of itself inside */
            double angle0 = 0.5 * MS_SSS__PI, u0 = 0, s0 = x * x;
            i = ms_sss__ring_of(p, x);
            if (i < 0) {
                i = 0;
                s0 = p->edge[0] * p->edge[0];
                u0 = sqrt((p->edge[0] - x) * (p->edge[0] + x));
                angle0 = p->edge[0] > 0 ? asin(x / p->edge[0]) : angle0;
            } else {
                out[c] = p->inside[c][i];
                if (i < p->count) out[c] += ms_sss__ring_energy(p, c, i, s0);
            }
            for (; i < p->count; ++i) {
                double r = p->edge[i + 1], s1 = r * r, u1 = sqrt((r - x) * (r + x)), angle1 = asin(x / r);
                double middle = 0.5 * (p->edge[i] * p->edge[i] + s1);
                /* integrals over s = r^2 of asin(x/r) and of s asin(x/r) */
                double g0 = s1 * angle1 - s0 * angle0 + x * (u1 - u0);
                double g1 = 0.5 * (s1 * s1 * angle1 - s0 * s0 * angle0 +
                                   x * (u1 * u1 * u1 - u0 * u0 * u0) / 3 + x * x * x * (u1 - u0));
                out[c] += 2 * (p->mean[c][i] * g0 + p->slope[c][i] * (g1 - middle * g0));
                s0 = s1;
                u0 = u1;
                angle0 = angle1;
            }
        } else if (p->kind == MS_SSS__BURLEY) {
            double t = x / p->sigma[0][c];
            out[c] = p->weight[0][c] * (1 - (ms_sss__bickley_1(t) + 3 * ms_sss__bickley_1(t / 3)) / (2 * MS_SSS__PI));
        } else {
            for (i = 0; i < p->count; ++i) out[c] += p->weight[i][c] * erf(x / (p->sigma[i][c] * sqrt(2.0)));
        }
    }
}

/* ------------------------------------------------------------------ TAPS */

/* --------------------------------------------------------- KERNEL MODELS */

/* --------------------------------------------------------- KERNEL ERRORS */

/* --------------------------------------------------- TRANSLUCENCY TABLES */

MS_SSS_API void ms_sss_transmittance(const ms_sss_profile *profile, double thickness_mm, double out[3])
{
    double total[3];
    int c;
    ms_sss_profile_reflectance(profile, total);
    ms_sss_profile_disc(profile, thickness_mm > 0 ? thickness_mm : 0, out);
    for (c = 0; c < 3; ++c) out[c] = total[c] - out[c];
}

MS_SSS_API ms_status ms_sss_transmittance_table(const ms_sss_profile *profile, double max_thickness_mm, int count,
                                                float (*out)[3])
{
    int i, c;
    if (profile == NULL || out == NULL || count < 2 || !(max_thickness_mm > 0 && max_thickness_mm <= 1e9))
        return MS_INVALID_ARGUMENT;
    for (i = 0; i < count; ++i) {
        double t[3];
        ms_sss_transmittance(profile, max_thickness_mm * i / (count - 1), t);
        for (c = 0; c < 3; ++c) out[i][c] = (float)t[c];
    }
    return MS_OK;
}

/* ----------------------------------------------------------- FILTER CODE */

/* ---------------------------------------------------------- PYRAMID CODE */

/* -------------------------------------------------------------- GPU CODE */

#endif /* MS_SSS_IMPLEMENTATION */

#ifdef MS_SSS__PASS /* one inclusion a level, from FILTER CODE above */
/* -------------------------------------------------------- FILTER KERNELS */

/* ------------------------------------------------------- PYRAMID KERNELS */

#endif /* MS_SSS__PASS */

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
