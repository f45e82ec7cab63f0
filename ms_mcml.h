/* ms_mcml.h - v0.3.0 - photon transport in layered media - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_MCML_IMPLEMENTATION
      #include "ms_mcml.h"

   Layers with refractive index, absorption, scattering and thickness become reflectance and transmittance over radius
   and angle, with standard errors, and absorption over depth. Link with -lm. Here 0.1 cm of skin on muscle
   (n, mu_a, mu_s, g, thickness of each layer, per cm and cm; then dr, dz, nr, nz, na of the grid):

   Example:
      #define MS_MCML_IMPLEMENTATION
      #include "ms_mcml.h"
      #include <stdio.h>
      int main(void)
      {
          const ms_mcml_layer layers[2] = {{1.4, 2.0, 180, 0.85, 0.1}, {1.4, 0.5, 90, 0.9, 1e8}};
          ms_mcml_tissue tissue = {1.0, 1.4, 2, layers};
          ms_mcml_grid grid = {0.01, 0.01, 100, 100, 30};
          ms_mcml_options options = ms_mcml_defaults();
          ms_mcml_result result;
          ms_error error;
          options.photons = 100000;
          if (ms_mcml_simulate(&tissue, &grid, &options, &result, &error) != MS_OK) {
              printf("%s\n", error.message);
              return 1;
          }
          printf("specular %.4f, diffuse %.4f +- %.4f\n", result.specular, result.rd, result.rd_error);
          printf("at 1 mm: %.4f +- %.4f per cm^2\n", result.rd_r[10], result.rd_r_error[10]);
          ms_mcml_result_destroy(&result);
          return 0;
      }
   End of example.

   Which call
   ----------
     a diffusion profile for rendering (half-space)          ms_mcml_profile_make: no noise, milliseconds a channel
     a picked color and a path length to a medium            ms_mcml_medium_from_color
     isotropic layers: totals, rings, depth without noise    examples/tools/layered.h
     skin of melanin and blood to profiles and colors        examples/tools/skin.h
     layers, g, glass, absorption, angles                    ms_mcml_simulate, or for jobs that are split:
                                                             ms_mcml_create, _run, _sums, _add, _results
     .mci and .mco files of MCML 1.2, finite beams           examples/tools/mci.h

   Monte Carlo
   -----------
   As MCML (Wang, Jacques, Zheng 1995) in packets of 4, 8 or 16 photons: absorption by weight, Henyey-Greenstein
   scattering, Fresnel boundaries, roulette. Time grows with the collisions of a photon; tests/bench/RESULTS.md of the
   repository has times beside MCML's. Roulette starts at 0.01 times the least albedo, MCML's at 1e-4. At its 4096th,
   16384th, 65536th ... event a photon ends with probability 1/2, else its weight doubles: so photons end in media
   without absorption, too. Clear layers on top are part of the surface: their reflection is specular.

   Diffusion profiles
   ------------------
   ms_mcml_profile_make turns media into R_d(r): averages over rings, and the energy within each edge. At g = 0 the
   half-space solver computes them by Galerkin's method in depth for each spatial frequency; the spectrum becomes a sum
   of terms with positive energies, whose rings have closed forms. At the default steps totals are good to 1e-9 and
   rings with 1e-5 of the energy to 8e-5. Media of other g become mu_s (1 - g) and g = 0, with errors to bound this.

   Memory, threads, SIMD, determinism, errors
   ------------------------------------------
   Monte Carlo: one block a tally, one a result; one while it runs, with sums apart where progress or parallel is given,
   so that a stop adds nothing. options.parallel cuts the photons into 16 tasks with a tally each. Half-space solver:
   0.3 MB a channel. Stack: below 32 KB, 64 KB when compiled without optimization. Calls without a common object may
   overlap. Results have the same bits for any thread count. Photon i draws from (seed, i) and sums are integers, so
   that any split of the photons gives the same bits at one level of instruction sets. -ffast-math voids what is said
   of bits, NaN and infinity. Calls return a status and, where asked for, a sentence. On failure results and numbers
   are untouched; a handle or profile that was to be made is NULL or zeroed: release an old one first.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_DEF            linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_MCML_FILENAME  this file's name, if it is not "ms_mcml.h"
   MS_NO_SIMD        scalar text only (as Microsoft's cl compiles it)

   Limits
   ------
   2^32 photons a tally; 32767 layers; n 0.01 to 100; mu up to 1e9 per cm; -1 < g <= 1; nr and nz up to 2^24, nr nz
   below 2^31. A pencil beam at normal incidence; flat layers; unpolarized light.

   Sources
   -------
   Wang, Jacques, Zheng 1995 (MCML) and 1997 (CONV); Blackman, Vigna 2018 (xoshiro128+, seeded by Philox); Duff et al.
   2017 (basis); Williams 2007 (the searchlight problem with internal reflection); Case, Zweifel 1967 (nu_0); Lawson,
   Hanson 1974 (least squares); Chandrasekhar 1960 (the test's reference); Jensen et al. 2001 (materials).
*/
#ifndef MS_MCML_H
#define MS_MCML_H
#include <stddef.h>
#include <stdint.h>

#define MS_MCML_VERSION_MAJOR 0
#define MS_MCML_VERSION_MINOR 3
#define MS_MCML_VERSION_PATCH 0
#define MS_MCML_VERSION 300 /* major * 10000 + minor * 100 + patch */
#define MS_MCML_VERSION_STRING "0.3.0"

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

/* ---- tissue and runs ------------------------------------------------------------------------------------------- */

/* One layer. A layer with mu_a = mu_s = 0 is clear (glass, water); g = 1 scatters straight ahead, which is the same as
   mu_s = 0. The last layer of a semi-infinite tissue is as thick as 1e8 cm. */
typedef struct ms_mcml_layer {
    double n;            /* refractive index, 0.01 to 100 */
    double mu_a_per_cm;  /* absorption, 0 to 1e9 */
    double mu_s_per_cm;  /* scattering, 0 to 1e9 */
    double g;            /* mean cosine of Henyey-Greenstein scattering, -1 < g <= 1; what a float rounds to 1 is 1 */
    double thickness_cm; /* > 0; above 1e18 it counts as 1e18 */
} ms_mcml_layer;

/* Layers from the top, where a pencil beam enters at r = z = 0 along +z, down. */
typedef struct ms_mcml_tissue {
    double n_above, n_below;     /* of the media outside */
    int layer_count;             /* 1 to 32767 */
    const ms_mcml_layer *layers; /* [layer_count] the caller's, copied by ms_mcml_create */
} ms_mcml_tissue;

/* Where photons are counted: rings i dr <= r < (i + 1) dr, slabs in z, exit angles in [0, pi/2]. As in MCML, the last
   ring and slab collect everything beyond. */
typedef struct ms_mcml_grid {
    double dr_cm, dz_cm; /* 1e-30 to 1e30 */
    int nr, nz, na;      /* >= 1; nr and nz at most 2^24, nr nz below 2^31 */
} ms_mcml_grid;

/* All zero: the defaults. */
typedef struct ms_mcml_options {
    uint64_t photons; /* that ms_mcml_simulate runs; 0: 1000000; at most 2^32 in one tally */
    uint64_t seed;
    double roulette_weight; /* photons of less weight play roulette, at most 1; 0: 0.01 times the least albedo of a
                               layer that scatters, but at least MCML's 1e-4. Less: deep absorption with less noise */
    int no_absorption;      /* not 0: neither A_rz nor A_z, which saves time and memory; A_l remains */
    size_t memory_limit;    /* bytes that tallies may take, where grids come from files; 0: 4 GiB, 32 bits: 2 */
    ms_simd simd;           /* a cap, to compare levels */
    ms_parallel parallel;   /* at most 16 tasks, each with its own tally */
    ms_progress progress;   /* called with 0, then every few ms (with parallel, 16 times that over the threads), and
                               with 1 */
    ms_allocator allocator;
} ms_mcml_options;

/* All zero, for C++ and for fields to come. */
MS_API ms_mcml_options ms_mcml_defaults(void);

/* ---- direct Monte Carlo ---------------------------------------------------------------------------------------- */

/* A tally: the sums of one tissue, whole numbers of 2^-30 photon. Any split of the photons over calls, threads,
   processes and machines gives the same bits at one level of instruction sets. */
typedef struct ms_mcml ms_mcml;

/* Checks tissue and grid and makes an empty tally. options may be NULL.
   MS_INVALID_ARGUMENT (position: layer, from 1), MS_OUT_OF_MEMORY, MS_UNSUPPORTED (above memory_limit): *out is NULL.
   Memory: 16 bytes for each of 2 nr na bins, 8 for each of nr nz bins; times 2 with
   options->progress, times 17 with options->parallel. */
MS_API ms_status ms_mcml_create(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_mcml_options *options,
                                ms_mcml **out, ms_error *error);

/* NULL is fine. */
MS_API void ms_mcml_destroy(ms_mcml *tally);

/* Adds the photons first to first + count - 1 of the seed. Never run a photon twice.
   MS_INVALID_ARGUMENT: more than 2^32 photons in the tally, first + count of 2^64 and more. MS_CANCELLED,
   MS_OUT_OF_MEMORY. Nothing was added then. */
MS_API ms_status ms_mcml_run(ms_mcml *tally, uint64_t first, uint64_t count, ms_error *error);

/* Photons in the tally. */
MS_API uint64_t ms_mcml_photons(const ms_mcml *tally);

/* The sums of a tally, which with its tissue, grid, seed and options are all of its state: [*count], none below 0. They
   belong to the tally. examples/tools/tally.h keeps them as bytes, for other processes and machines. */
MS_API const int64_t *ms_mcml_sums(const ms_mcml *tally, size_t *count);

/* Adds the sums of a tally of the same tissue, grid, seed and options and of other photons; the caller sees to that.
   MS_INVALID_ARGUMENT: another count; a sum (position: its index) or the photons out of range. Nothing was added then.
   sums may be those of the tally itself. */
MS_API ms_status ms_mcml_add(ms_mcml *tally, const int64_t *sums, size_t count, ms_error *error);

/* Means per photon that arrives at the tissue. Photons reflected at entry count as photons, but not in Rd. Each x_error
   is one standard error of each element of x. Rd, Tt: what leaves at the top and the bottom; r: radius; a: angle to the
   normal; A: absorbed. Row-major. The arrays belong to the result. */
typedef struct ms_mcml_result {
    uint64_t photons;
    ms_mcml_grid grid;
    int layer_count;
    double specular;                       /* reflected at entry by the surface and clear layers on top */
    double rd, rd_error, tt, tt_error;     /* total diffuse reflectance, transmittance */
    double a, a_error;                     /* absorbed; specular + rd + a + tt = 1 but for roulette */
    double rd_unscattered, tt_unscattered; /* parts of rd, tt that never scattered */
    double *rd_r, *rd_r_error;             /* [nr] 1/cm^2 */
    double *rd_a, *rd_a_error;             /* [na] 1/sr */
    double *rd_ra, *rd_ra_error;           /* [nr][na] 1/(cm^2 sr), per area perpendicular to the direction */
    double *tt_r, *tt_r_error, *tt_a, *tt_a_error, *tt_ra, *tt_ra_error;
    double *a_l, *a_l_error; /* [layer_count] part absorbed in each layer */
    double *a_z;             /* [nz] 1/cm; NULL with no_absorption */
    double *a_rz;            /* [nr][nz] 1/cm^3; NULL with no_absorption */
    void *memory;
    size_t memory_size;
    ms_allocator allocator;
} ms_mcml_result;

/* Results so far. Errors of Rd and Tt come from the squares of single photons, those of A from the spread of up to 64
   groups of 1024 photons (64 groups: good to 9%). The error of one photon or one group is unknown: infinite.
   MS_INVALID_ARGUMENT: an empty tally. MS_OUT_OF_MEMORY. *result is untouched then. */
MS_API ms_status ms_mcml_results(const ms_mcml *tally, ms_mcml_result *result, ms_error *error);

/* NULL and a zeroed result are fine. */
MS_API void ms_mcml_result_destroy(ms_mcml_result *result);

/* All of it in one call: photons 0 to options->photons - 1. *result is untouched unless MS_OK. */
MS_API ms_status ms_mcml_simulate(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid,
                                  const ms_mcml_options *options, ms_mcml_result *result, ms_error *error);

/* ---- materials ------------------------------------------------------------------------------------------------- */

/* A homogeneous half-space. Isotropic data sets give mu_s as the reduced coefficient with g = 0. */
typedef struct ms_mcml_medium {
    double mu_a_per_mm; /* absorption, >= 0 */
    double mu_s_per_mm; /* scattering, >= 0; mu_a + mu_s 1e-100 to 1e100 */
    double g;           /* mean cosine of scattering, in (-1, 1) */
    double eta;         /* refractive index over that of the outside, 0.1 to 10 */
} ms_mcml_medium;

typedef struct ms_mcml_material {
    const char *name;                      /* lower case, e.g. "skin1" */
    double mu_a_per_mm[3], mu_s_per_mm[3]; /* R, G, B; g = 0 */
    double eta;
} ms_mcml_material;

/* The 11 materials of the dissertation's sections 5.9.2 to 5.9.12 (measured by Jensen, Marschner, Levoy, Hanrahan
   2001); count (may be NULL) gets 11. */
MS_API const ms_mcml_material *ms_mcml_materials(int *count);

/* By name, upper and lower case alike; NULL if there is none of that name. */
MS_API const ms_mcml_material *ms_mcml_find_material(const char *name);

/* One channel (0 R, 1 G, 2 B) of a material; nothing at all (index 1) where there is none. */
MS_API ms_mcml_medium ms_mcml_material_medium(const ms_mcml_material *material, int channel);

/* ---- colors ---------------------------------------------------------------------------------------------------- */

/* What a length stands for. With A the color below, Christensen, Burley 2015 (Approximate reflectance profiles for
   efficient subsurface scattering, equations 6 and 8) give the last two. */
typedef enum ms_mcml_length {
    MS_MCML_MEAN_FREE_PATH = 0, /* 1 / (mu_a + mu_s) */
    /* reduced path / (1.85 - A + 7 |A - 0.8|^3): d of ms_sss_profile_from_burley, HDRP's distance */
    MS_MCML_BURLEY_D = 1,
    MS_MCML_DIFFUSE_PATH = 2 /* d (3.5 + 100 (A - 0.33)^4): Unreal's diffuse mean free path */
} ms_mcml_length;

/* The medium of isotropic scattering (g = 0) that has this color and this length. Its profile is that of the medium,
   not Burley's curve.
   color      0 to 1, linear: the part of the entering light that comes out again (a renderer's albedo beside a
              specular lobe); the medium gives it back to 1e-7
   length_mm  1e-30 to 1e30; kind: an ms_mcml_length; eta: 0.1 to 10
   MS_INVALID_ARGUMENT: out of these ranges, *medium is untouched. No memory. Example, a skin in Unreal's terms:

      for (c = 0; c < 3; ++c)
          ms_mcml_medium_from_color(color[c], path_mm[c], MS_MCML_DIFFUSE_PATH, 1.4, &medium[c], NULL);

      ms_mcml_profile_make(&profile, medium, 3, NULL, NULL); */
MS_API ms_status ms_mcml_medium_from_color(double color, double length_mm, int kind, double eta, ms_mcml_medium *medium,
                                           ms_error *error);

/* ---- diffusion profiles ---------------------------------------------------------------------------------------- */

typedef struct ms_mcml_profile_options {
    const double *edge_mm; /* [rings + 1] increasing, 0 or 1e-100 to 1e100; NULL: rings of equal width from 0 */
    int rings;             /* 0 (with edge_mm NULL): rings that suit the media, see ms_mcml_profile_make */
    double ring_mm;        /* their width, 1e-100 to 1e100 */
    double depth_step;     /* log spacing of the exponentials in depth, 0.28 to 1; 0: 0.3. With frequency_step it trades
                              time for error: tests/bench/RESULTS.md has the table */
    double frequency_step; /* log spacing of the spatial frequencies, 0.2 to 1; 0: 0.25 */
    ms_parallel parallel;  /* a task a channel */
    ms_allocator allocator;
} ms_mcml_profile_options;

/* Diffuse reflectance of `channels` half-spaces over common rings, as a part of the light that arrives, without what
   the surface reflects. Arrays belong to the profile. Row c of an array [channels][n] starts at element c * n. */
typedef struct ms_mcml_profile {
    int channels, rings;
    double *edge_mm;          /* [rings + 1] */
    double *rd_per_mm2;       /* [channels][rings] mean over each ring */
    double *rd_error_per_mm2; /* [channels][rings] 0 at g = 0 */
    double *within;           /* [channels][rings + 1] energy that leaves nearer than the edge */
    double *entering;    /* [channels] part of the arriving light that enters; total / entering is a picked color */
    double *total;       /* [channels] of all that leaves, of the light that arrives */
    double *total_error; /* [channels] 0 at g = 0 */
    void *memory;
    size_t memory_size;
    ms_allocator allocator;
} ms_mcml_profile;

/* The profile of media[0 .. channels - 1]; release it with ms_mcml_profile_destroy. options may be NULL. Rings that the
   options do not give are a twentieth of the shortest mean free path wide up to that path, then each 4% wider, out to
   where every channel has 1e-5 of its energy left.
   Media of g != 0 are replaced by isotropic ones of mu_s (1 - g) and the same mu_a (similarity). The errors bound what
   that does, which is much near the beam: for the profile of such a medium itself trace photons, as
   examples/tools/photon_profile.h does.
   MS_INVALID_ARGUMENT (position: the ring edge, if it is one), MS_OUT_OF_MEMORY: *profile is zeroed. */
MS_API ms_status ms_mcml_profile_make(ms_mcml_profile *profile, const ms_mcml_medium *media, int channels,
                                      const ms_mcml_profile_options *options, ms_error *error);

/* NULL and a zeroed profile are fine. */
MS_API void ms_mcml_profile_destroy(ms_mcml_profile *profile);

#ifdef __cplusplus
}
#endif
#endif /* MS_MCML_H */

#if defined(MS_MCML_IMPLEMENTATION) && !defined(MS_MCML__PASS) && !defined(MS_MCML_IMPLEMENTED)
#define MS_MCML_IMPLEMENTED /* included again, it is declarations only */
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

#include <math.h>

/* Contents:
     tissue and runs           defaults, checks of a tissue and a grid
     direct Monte Carlo        tally, events that go lane by lane, run, saved tallies, results
     materials                 the table
     half-space solver         Galerkin's method in depth, least squares, terms, rings
     similarity                what replacing g by 0 may do
     colors                    a color to a medium
     diffusion profiles        rings, arrays
     kernels, one set a level  how the text below is compiled for each instruction set
     kernels                   the photons' loop in vectors */

/* The kernels use vectors with the operators of GCC and Clang; cl compiles the scalar text. */
#if defined(MS__X64) && (defined(__GNUC__) || defined(__clang__))
#define MS_MCML__X64 1
#elif defined(MS__NEON) && (defined(__GNUC__) || defined(__clang__))
#define MS_MCML__NEON 1
#endif

/* ---- tissue and runs ------------------------------------------------------------------------------------------- */

MS_API ms_mcml_options ms_mcml_defaults(void)
{
    ms_mcml_options options;
    memset(&options, 0, sizeof options);
    return options;
}

static int ms_mcml__between(double x, double low, double high) { return ms__finite(x) && x >= low && x <= high; }

static ms_status ms_mcml__check_layer(const ms_mcml_layer *l, size_t position, ms_error *error)
{
    if (!ms_mcml__between(l->n, 0.01, 100))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "refractive index n is %g, expected 0.01 to 100", l->n);
    if (!ms_mcml__between(l->mu_a_per_cm, 0, 1e9) || !ms_mcml__between(l->mu_s_per_cm, 0, 1e9))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "mu_a is %g and mu_s is %g, expected 0 to 1e9 per cm",
                        l->mu_a_per_cm, l->mu_s_per_cm);
    if (ms__finite(l->g) && l->g > 1 && l->g < 1.001) /* %g would print it as 1 */
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "g is 1 + %g, expected above -1 and at most 1", l->g - 1);
    if (!ms_mcml__between(l->g, -1, 1) || (l->g <= -1 && l->mu_s_per_cm > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "g is %g, expected above -1 and at most 1", l->g);
    if (!ms__finite(l->thickness_cm) || !(l->thickness_cm > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "thickness is %g, expected above 0", l->thickness_cm);
    return MS_OK;
}

/* The kernel finds a bin in floats, whose whole numbers end at 2^24. */
enum { MS_MCML__BINS_MAX = 1 << 24 };

static ms_status ms_mcml__check_grid(const ms_mcml_grid *grid, ms_error *error)
{
    if (!ms_mcml__between(grid->dr_cm, 1e-30, 1e30) || !ms_mcml__between(grid->dz_cm, 1e-30, 1e30))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "dz and dr are %g and %g cm, expected 1e-30 to 1e30",
                        grid->dz_cm, grid->dr_cm);
    if (grid->nz < 1 || grid->nr < 1 || grid->na < 1 || grid->nz > MS_MCML__BINS_MAX || grid->nr > MS_MCML__BINS_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "nz, nr, na are %d, %d, %d, expected 1 or more, and at most 2^24 for nz and nr", grid->nz,
                        grid->nr, grid->na);
    return MS_OK;
}

/* Position of a failure: the layer, from 1. */
static ms_status ms_mcml__check_tissue(const ms_mcml_tissue *tissue, ms_error *error)
{
    int i;
    if (tissue->layer_count < 1 || tissue->layer_count > 32767 || tissue->layers == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%d layers, expected 1 to 32767", tissue->layer_count);
    if (!ms_mcml__between(tissue->n_above, 0.01, 100) || !ms_mcml__between(tissue->n_below, 0.01, 100))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "n above and below are %g and %g, expected 0.01 to 100",
                        tissue->n_above, tissue->n_below);
    for (i = 0; i < tissue->layer_count; ++i) {
        ms_status status = ms_mcml__check_layer(&tissue->layers[i], (size_t)i + 1, error);
        if (status) return status;
    }
    return MS_OK;
}

/* ---- direct Monte Carlo ---------------------------------------------------------------------------------------- */

static const float ms_mcml__units = 1073741824.0f; /* 2^30: a whole photon in the sums */
static const uint64_t ms_mcml__photons_max = (uint64_t)1 << 32;
static const float ms_mcml__chance = 0.1f; /* of surviving roulette */
enum {
    MS_MCML__HALVING_EVENTS = 4096, /* then every fourfold: half of the photons end and the others count double */
    MS_MCML__GROUPS = 64,           /* for errors by spread: photon i is in group i / BLOCK mod GROUPS */
    MS_MCML__BLOCK = 1024,
    MS_MCML__TURNS = 65536, /* of the kernel between two calls of the progress callback */
    MS_MCML__TASKS = 16,
    MS_MCML__LANES_MAX = 16
};

/* A layer as the kernel reads it. */
typedef struct ms_mcml__slab {
    float depth;                   /* thickness */
    float top;                     /* z of its upper side */
    float mfp;                     /* 1 / (mu_a + mu_s), at most 1e36 */
    float absorbed;                /* mu_a / (mu_a + mu_s) */
    float g, ratio_up, ratio_down; /* ratio: n over n of the neighbor */
} ms_mcml__slab;

/* Offsets into the sums of a tally; S: the sum of weights, Q: of their squares. */
typedef struct ms_mcml__layout {
    size_t leave;       /* [2: top, bottom][nr][na][2: S, Q] */
    size_t unscattered; /* [2] */
    size_t photons;     /* [GROUPS] */
    size_t layers;      /* [GROUPS][layer_count] */
    size_t a;           /* [nr][nz], unless no_absorption */
    size_t count;
} ms_mcml__layout;

struct ms_mcml {
    ms_mcml_options options;
    ms_mcml_tissue tissue; /* layers: a copy in this block */
    ms_mcml_grid grid;
    ms_mcml__layout at;
    ms_mcml__slab *slab;
    int64_t *sum;    /* [at.count] */
    int first_layer; /* where photons start; layer_count: all layers are clear */
    double specular;
    uint64_t photons;
    ms_simd simd;
    size_t size;
};

/* Up to 16 photons, a lane each; one bit a lane in alive. */
typedef struct ms_mcml__tracer {
    float x[MS_MCML__LANES_MAX], y[MS_MCML__LANES_MAX], z[MS_MCML__LANES_MAX]; /* cm; z from the top of the layer */
    float ux[MS_MCML__LANES_MAX], uy[MS_MCML__LANES_MAX], uz[MS_MCML__LANES_MAX];
    float w[MS_MCML__LANES_MAX];
    float kept[MS_MCML__LANES_MAX]; /* absorbed in this layer since the photon entered it */
    float depth[MS_MCML__LANES_MAX], top[MS_MCML__LANES_MAX], mfp[MS_MCML__LANES_MAX], absorbed[MS_MCML__LANES_MAX];
    float g[MS_MCML__LANES_MAX], ratio_up[MS_MCML__LANES_MAX], ratio_down[MS_MCML__LANES_MAX];
    float cos_t[MS_MCML__LANES_MAX], units[MS_MCML__LANES_MAX]; /* units: not yet in their cell */
    uint32_t s[4][MS_MCML__LANES_MAX], word[MS_MCML__LANES_MAX];
    uint32_t events[MS_MCML__LANES_MAX], limit[MS_MCML__LANES_MAX];
    uint32_t cell[MS_MCML__LANES_MAX];
    int layer[MS_MCML__LANES_MAX], group[MS_MCML__LANES_MAX];
    uint32_t bit[MS_MCML__LANES_MAX];      /* 1 << lane */
    uint32_t fresh[4][MS_MCML__LANES_MAX]; /* states of the next photons, from fresh_at on */
    int fresh_at;
    unsigned alive;
    float low_weight, inverse_dr, inverse_dz, last_r, last_z;
    uint32_t nz;
    int64_t *sum, *cells; /* cells: of absorption, or NULL */
    const ms_mcml *tally;
    uint64_t next, end;
} ms_mcml__tracer;

static void ms_mcml__enter(ms_mcml__tracer *t, int i, int layer, int from_above)
{
    const ms_mcml__slab *slab = &t->tally->slab[layer];
    t->layer[i] = layer;
    t->z[i] = from_above ? 0.0f : slab->depth;
    t->depth[i] = slab->depth;
    t->top[i] = slab->top;
    t->mfp[i] = slab->mfp;
    t->absorbed[i] = slab->absorbed;
    t->g[i] = slab->g;
    t->ratio_up[i] = slab->ratio_up;
    t->ratio_down[i] = slab->ratio_down;
    t->kept[i] = 0;
}

/* Index of the lowest set bit. */
static int ms_mcml__lowest(unsigned lanes)
{
#if defined(__GNUC__) || defined(__clang__)
    return __builtin_ctz(lanes);
#else
    int i = 0;
    while (!(lanes >> i & 1)) ++i;
    return i;
#endif
}

/* Lane i gets the next photon's random state; 0 if there is none. */
static inline int ms_mcml__assign(ms_mcml__tracer *t, int i)
{
    const int k = t->fresh_at;
    t->group[i] = (int)(t->next / MS_MCML__BLOCK % MS_MCML__GROUPS);
    t->layer[i] = t->tally->first_layer;
    if (t->next >= t->end) return 0;
    ++t->next;
    ++t->fresh_at;
    t->s[0][i] = t->fresh[0][k];
    t->s[1][i] = t->fresh[1][k];
    t->s[2][i] = t->fresh[2][k];
    t->s[3][i] = t->fresh[3][k];
    if ((t->s[0][i] | t->s[1][i] | t->s[2][i] | t->s[3][i]) == 0) t->s[3][i] = 1; /* all 0 is a fixed point */
    return 1;
}

/* Adds the absorption of lane i in its layer to the sums, rounded at random by bits that its other choices do not
   use. */
static inline void ms_mcml__add_absorbed(ms_mcml__tracer *t, int i)
{
    size_t at = t->tally->at.layers + (size_t)t->group[i] * (size_t)t->tally->tissue.layer_count + (size_t)t->layer[i];
    t->sum[at] += (int64_t)(t->kept[i] * ms_mcml__units + (float)(t->word[i] & 127) * (1.0f / 128));
}

/* Lane i leaves the tissue with its whole weight. Squares are rounded up, so that no error becomes 0. */
static void ms_mcml__leave(ms_mcml__tracer *t, int i, int down)
{
    const ms_mcml *m = t->tally;
    const double w = (double)t->w[i], r = sqrt((double)t->x[i] * (double)t->x[i] + (double)t->y[i] * (double)t->y[i]);
    const double cosine = (double)t->cos_t[i] < 1 ? (double)t->cos_t[i] : 1, ring = r / m->grid.dr_cm;
    const size_t ir = (size_t)(ring < m->grid.nr - 1 ? (int)ring : m->grid.nr - 1);
    const double angle = m->grid.na > 1 ? acos(cosine) * m->grid.na / 1.5707963267948966 : 0;
    const int64_t s = (int64_t)(w * (double)ms_mcml__units + 0.5), q = (int64_t)ceil(w * w * (double)ms_mcml__units);
    const size_t ia = (size_t)(angle < m->grid.na - 1 ? (int)angle : m->grid.na - 1);
    int64_t *bin = t->sum + m->at.leave + 2 * (((size_t)down * (size_t)m->grid.nr + ir) * (size_t)m->grid.na + ia);
    bin[0] += s;
    bin[1] += q;
    if (!(t->uy[i] < 0 || t->uy[i] > 0 || t->ux[i] < 0 || t->ux[i] > 0)) t->sum[m->at.unscattered + (size_t)down] += s;
}

/* Lane i crosses a boundary; returns 1 if it leaves the tissue. */
static int ms_mcml__cross(ms_mcml__tracer *t, int i)
{
    const int down = t->uz[i] > 0, layer = t->layer[i] + (down ? 1 : -1);
    const float ratio = down ? t->ratio_down[i] : t->ratio_up[i];
    ms_mcml__add_absorbed(t, i);
    if (layer < 0 || layer == t->tally->tissue.layer_count) {
        ms_mcml__leave(t, i, down);
        return 1;
    }
    t->ux[i] *= ratio; /* Snell */
    t->uy[i] *= ratio;
    t->uz[i] = down ? t->cos_t[i] : -t->cos_t[i];
    ms_mcml__enter(t, i, layer, down);
    return 0;
}

/* The function that is compiled for each level: at most `turns` events of every lane; called again, it goes on. */
typedef void ms_mcml__trace(ms_mcml__tracer *t, int turns);
static ms_mcml__trace *ms_mcml__trace_of(ms_simd level); /* after the kernels */

/* A tracer of the photons first to end - 1, whose sums go to `sum`. */
static void ms_mcml__tracer_make(ms_mcml__tracer *t, const ms_mcml *m, int64_t *sum, uint64_t first, uint64_t end)
{
    memset(t, 0, sizeof *t);
    t->tally = m;
    t->low_weight = (float)m->options.roulette_weight;
    t->inverse_dr = (float)(1 / m->grid.dr_cm);
    t->inverse_dz = (float)(1 / m->grid.dz_cm);
    t->last_r = (float)(m->grid.nr - 1);
    t->last_z = (float)(m->grid.nz - 1);
    t->nz = (uint32_t)m->grid.nz;
    t->sum = sum;
    t->cells = m->options.no_absorption ? NULL : sum + m->at.a;
    t->next = first;
    t->end = end;
}

/* Counts the photons first to end - 1 in their groups. In a clear tissue all that enters leaves at the bottom at r = 0,
   and is added here. */
static void ms_mcml__count(ms_mcml *m, uint64_t first, uint64_t end)
{
    uint64_t i, next;
    for (i = first; i < end; i = next) {
        next = (i / MS_MCML__BLOCK + 1) * MS_MCML__BLOCK;
        if (next > end) next = end;
        m->sum[m->at.photons + (size_t)(i / MS_MCML__BLOCK % MS_MCML__GROUPS)] += (int64_t)(next - i);
    }
    m->photons += end - first;
    if (m->first_layer == m->tissue.layer_count) {
        const int64_t all = (int64_t)((end - first) << 30);
        int64_t *bin = m->sum + m->at.leave + 2 * (size_t)m->grid.nr * (size_t)m->grid.na;
        bin[0] += all;
        bin[1] += all;
        m->sum[m->at.unscattered + 1] += all;
    }
}

/* Reflectance at normal incidence of the boundaries from above the tissue to the first layer that is not clear, with
   all reflections between them: R = (r + s - 2 r s) / (1 - r s), boundary by boundary. */
static double ms_mcml__specular(const ms_mcml_tissue *tissue, int first_layer)
{
    double reflectance = 0, n = tissue->n_above;
    int i;
    for (i = 0; i <= first_layer; ++i) {
        const double below = i < tissue->layer_count ? tissue->layers[i].n : tissue->n_below;
        const double s = (n - below) * (n - below) / ((n + below) * (n + below));
        reflectance = (reflectance + s - 2 * reflectance * s) / (1 - reflectance * s);
        n = below;
    }
    return reflectance;
}

/* Memory of the sums, or SIZE_MAX. */
static size_t ms_mcml__layout_make(ms_mcml__layout *at, const ms_mcml_grid *grid, int layer_count, int absorption)
{
    const size_t nr = (size_t)grid->nr;
    at->leave = 0;
    at->unscattered = ms__size_mul(4, ms__size_mul(nr, (size_t)grid->na));
    at->photons = ms__size_add(at->unscattered, 2);
    at->layers = ms__size_add(at->photons, MS_MCML__GROUPS);
    at->a = ms__size_add(at->layers, (size_t)layer_count * MS_MCML__GROUPS);
    at->count = ms__size_add(at->a, absorption ? ms__size_mul(nr, (size_t)grid->nz) : 0);
    return ms__size_mul(at->count, sizeof(int64_t));
}

/* Everything that follows from the tissue. */
static void ms_mcml__prepare(ms_mcml *m)
{
    const ms_mcml_layer *layer = m->tissue.layers;
    double top = 0, albedo = 1;
    int i;
    m->first_layer = m->tissue.layer_count;
    for (i = 0; i < m->tissue.layer_count; ++i) {
        const double mu_s = (float)layer[i].g < 1.0f ? layer[i].mu_s_per_cm : 0, mu_t = layer[i].mu_a_per_cm + mu_s;
        const double depth = fmin(layer[i].thickness_cm, 1e18); /* the shortest way across in the clear is 3e19 */
        const double above = i > 0 ? layer[i - 1].n : m->tissue.n_above;
        const double below = i + 1 < m->tissue.layer_count ? layer[i + 1].n : m->tissue.n_below;
        ms_mcml__slab *slab = &m->slab[i];
        slab->depth = (float)depth;
        slab->top = (float)top;
        slab->mfp = (float)(mu_t > 1e-36 ? 1 / mu_t : 1e36);
        slab->absorbed = mu_t > 0 ? (float)(layer[i].mu_a_per_cm / mu_t) : 0.0f;
        slab->g = mu_s > 0 ? (float)layer[i].g : 0.0f;
        slab->ratio_up = (float)(layer[i].n / above);
        slab->ratio_down = (float)(layer[i].n / below);
        if (mu_t > 0 && i < m->first_layer) m->first_layer = i;
        if (mu_s > 0 && mu_s < albedo * mu_t) albedo = mu_s / mu_t;
        top += depth;
    }
    m->specular = ms_mcml__specular(&m->tissue, m->first_layer);
    /* One collision in a dark layer must not make a photon that still matters play. */
    if (!(m->options.roulette_weight > 0)) m->options.roulette_weight = 0.01 * albedo > 1e-4 ? 0.01 * albedo : 1e-4;
}

/* One block: the tally, sums, layers, slabs. block NULL: only its size. */
static ms_mcml *ms_mcml__place(void *block, size_t sums, int layer_count, size_t *size)
{
    ms__arena arena = {NULL, 0};
    ms_mcml *m;
    ms_mcml_layer *layers;
    int64_t *sum;
    ms_mcml__slab *slab;
    arena.base = (char *)block;
    m = (ms_mcml *)ms__take(&arena, 1, sizeof *m);
    sum = (int64_t *)ms__take(&arena, sums, 1);
    layers = (ms_mcml_layer *)ms__take(&arena, (size_t)layer_count, sizeof *layers);
    slab = (ms_mcml__slab *)ms__take(&arena, (size_t)layer_count, sizeof *slab);
    *size = arena.used;
    if (m == NULL) return NULL;
    memset(m, 0, arena.used);
    m->sum = sum;
    m->tissue.layers = layers;
    m->slab = slab;
    return m;
}

MS_API ms_status ms_mcml_create(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_mcml_options *options,
                                ms_mcml **out, ms_error *error)
{
    const ms_mcml_options o = options ? *options : ms_mcml_defaults();
    const size_t limit = o.memory_limit ? o.memory_limit : sizeof(size_t) > 4 ? (size_t)1 << 16 << 16 : (size_t)1 << 31;
    size_t sums, size, all;
    ms_mcml__layout at;
    ms_mcml_layer *layers;
    ms_mcml *m;
    ms_status status;
    if (out == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "out is NULL");
    *out = NULL;
    if (tissue == NULL || grid == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tissue or grid is NULL");
    if ((status = ms_mcml__check_tissue(tissue, error)) != MS_OK) return status;
    if ((status = ms_mcml__check_grid(grid, error)) != MS_OK) return status;
    if (!ms_mcml__between(o.roulette_weight, 0, 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "roulette_weight is %g, expected 0 to 1", o.roulette_weight);
    if (o.photons > ms_mcml__photons_max) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "more than 2^32 photons");
    if (ms__size_mul((size_t)grid->nr, (size_t)grid->nz) > 0x7fffffffu)
        return ms__fail(error, MS_UNSUPPORTED, 0, "%d by %d cells, expected fewer than 2^31", grid->nr, grid->nz);

    sums = ms_mcml__layout_make(&at, grid, tissue->layer_count, !o.no_absorption);
    ms_mcml__place(NULL, sums, tissue->layer_count, &size);
    all = ms__size_mul(size, o.parallel.run ? MS_MCML__TASKS + 1 : o.progress.report ? 2 : 1);
    if (all > limit)
        return ms__fail(error, MS_UNSUPPORTED, 0, "the tallies take %z bytes, more than memory_limit, %z", all, limit);
    m = ms_mcml__place(ms__alloc(&o.allocator, size), sums, tissue->layer_count, &size);
    if (m == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the tally", size);
    layers = (ms_mcml_layer *)m->tissue.layers;
    memcpy(layers, tissue->layers, (size_t)tissue->layer_count * sizeof *layers);
    m->tissue = *tissue;
    m->tissue.layers = layers;
    m->options = o;
    m->grid = *grid;
    m->at = at;
    m->size = size;
    m->simd = ms__simd_pick(o.simd);
    ms_mcml__prepare(m);
    *out = m;
    return MS_OK;
}

MS_API void ms_mcml_destroy(ms_mcml *tally)
{
    if (tally) {
        const ms_allocator allocator = tally->options.allocator;
        ms__release(&allocator, tally, tally->size);
    }
}

MS_API uint64_t ms_mcml_photons(const ms_mcml *tally) { return tally ? tally->photons : 0; }

static void ms_mcml__add(int64_t *sum, const int64_t *other, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) sum[i] += other[i];
}

MS_API const int64_t *ms_mcml_sums(const ms_mcml *tally, size_t *count)
{
    if (count) *count = tally ? tally->at.count : 0;
    return tally ? tally->sum : NULL;
}

MS_API ms_status ms_mcml_add(ms_mcml *tally, const int64_t *sums, size_t count, ms_error *error)
{
    const int64_t sum_max = (int64_t)1 << 62;
    uint64_t photons = 0;
    size_t i;
    if (tally == NULL || sums == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tally or sums is NULL");
    if (count != tally->at.count)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%z sums, expected %z", count, tally->at.count);
    for (i = 0; i < count; ++i)
        if (sums[i] < 0 || sums[i] > sum_max - tally->sum[i])
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "sum %z is out of range", i);
    for (i = 0; i < MS_MCML__GROUPS && photons <= ms_mcml__photons_max; ++i)
        photons += (uint64_t)sums[tally->at.photons + i];
    if (photons > ms_mcml__photons_max - tally->photons)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "more than 2^32 photons in one tally");
    ms_mcml__add(tally->sum, sums, count);
    tally->photons += photons;
    return MS_OK;
}

static void ms_mcml__trace_task(void *context, int index)
{
    ms_mcml__tracer *t = (ms_mcml__tracer *)context + index;
    if (t->alive != 0 || t->next < t->end) ms_mcml__trace_of(t->tally->simd)(t, MS_MCML__TURNS);
}

/* All photons of the tracers, a slice of turns at a time. Between slices the callback hears what part of `count`
   photons is done; it may stop. */
static ms_status ms_mcml__trace_all(const ms_mcml *m, ms_mcml__tracer *t, int tasks, uint64_t count, ms_error *error)
{
    const ms_progress *progress = &m->options.progress;
    double fraction = 0;
    int busy = 1, i;
    for (;;) {
        uint64_t left = 0;
        if (progress->report && progress->report(progress->user, fraction))
            return ms__fail(error, MS_CANCELLED, 0, "stopped by the progress callback");
        if (!busy) return MS_OK;
        ms__run(&m->options.parallel, tasks, ms_mcml__trace_task, t);
        for (busy = 0, i = 0; i < tasks; ++i) {
            unsigned lanes = t[i].alive;
            for (left += t[i].end - t[i].next; lanes; lanes &= lanes - 1) ++left;
            busy |= t[i].alive != 0 || t[i].next < t[i].end;
        }
        fraction = (double)(count - left) / (double)count;
    }
}

MS_API ms_status ms_mcml_run(ms_mcml *m, uint64_t first, uint64_t count, ms_error *error)
{
    const int parallel = m && m->options.parallel.run != NULL;
    const int apart = parallel || (m && m->options.progress.report != NULL); /* sums apart: a stop adds nothing */
    const int tasks = parallel ? MS_MCML__TASKS : 1;
    const uint64_t end = first + count;
    uint64_t from, to = first;
    ms_mcml__tracer *tracer;
    int64_t *sums;
    ms_status status = MS_OK;
    size_t size;
    int i;
    if (m == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tally is NULL");
    if (count > ms_mcml__photons_max || m->photons > ms_mcml__photons_max - count)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "more than 2^32 photons in one tally");
    if (end < first) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "first + count is 2^64 or more");
    if (count == 0) return MS_OK;

    /* One block: the tracers, and behind them their sums. */
    size = ms__size_mul((size_t)tasks, sizeof *tracer + (apart ? m->at.count * sizeof *sums : 0));
    tracer = (ms_mcml__tracer *)ms__alloc(&m->options.allocator, size);
    if (tracer == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the tasks", size);
    sums = (int64_t *)(void *)(tracer + tasks);
    if (apart) memset(sums, 0, (size_t)tasks * m->at.count * sizeof *sums);

    /* Equal parts of the photons for the tasks; through a clear tissue nothing is traced. */
    for (i = 0; i < tasks; ++i) {
        from = to;
        to = first + count * ((uint64_t)i + 1) / (uint64_t)tasks;
        ms_mcml__tracer_make(&tracer[i], m, apart ? sums + (size_t)i * m->at.count : m->sum, from,
                             m->first_layer < m->tissue.layer_count ? to : from);
    }

    /* Whole or not at all: the tasks' sums join the tally after the last. */
    status = ms_mcml__trace_all(m, tracer, tasks, count, error);
    if (status == MS_OK) {
        for (i = 0; apart && i < tasks; ++i) ms_mcml__add(m->sum, sums + (size_t)i * m->at.count, m->at.count);
        ms_mcml__count(m, first, end);
    }
    ms__release(&m->options.allocator, tracer, size);
    return status;
}

/* Mean and standard error, times scale, of what left through `count` bins, every stride-th: over n photons from the
   sums S and Q of weights and of their squares, in units of 2^-30. */
static void ms_mcml__bins_mean(const int64_t *bin, size_t count, size_t stride, double n, double scale, double *mean,
                               double *error)
{
    const double unit = (double)ms_mcml__units;
    double s = 0, q = 0, variance;
    size_t i;
    for (i = 0; i < count; ++i, bin += 2 * stride) {
        s += (double)bin[0];
        q += (double)bin[1];
    }
    s /= unit * n;
    variance = q / (unit * n) - s * s;
    *mean = s * scale;
    *error = n > 1 ? sqrt(variance > 0 ? variance / (n - 1) : 0) * scale : HUGE_VAL;
}

/* The same from the sums of the groups, whose sizes differ: the spread of sum_g - mean n_g. */
static void ms_mcml__group_error(const ms_mcml *m, const double *sum, double *mean, double *error)
{
    const int64_t *size = m->sum + m->at.photons;
    const double n = (double)m->photons, unit = (double)ms_mcml__units, scale = 1 - m->specular;
    double total = 0, square = 0, used = 0;
    size_t g;
    for (g = 0; g < MS_MCML__GROUPS; ++g) total += sum[g];
    for (g = 0; g < MS_MCML__GROUPS; ++g) {
        const double d = sum[g] - total / n * (double)size[g];
        used += size[g] > 0;
        square += d * d;
    }
    *mean = total / unit / n * scale;
    *error = used > 1 ? sqrt(square * used / (used - 1)) / unit / n * scale : HUGE_VAL;
}

static double ms_mcml__ring_area(int ir, double dr) { return 6.283185307179586 * (ir + 0.5) * dr * dr; }

/* Rd or Tt: over r and a, over each of them, and the total. */
static void ms_mcml__leave_results(const ms_mcml *m, int down, ms_mcml_result *out)
{
    const size_t nr = (size_t)m->grid.nr, na = (size_t)m->grid.na;
    const int64_t *bin = m->sum + m->at.leave + 2 * (size_t)down * nr * na;
    const double n = (double)m->photons, entered = 1 - m->specular;
    double *ra = down ? out->tt_ra : out->rd_ra, *ra_error = down ? out->tt_ra_error : out->rd_ra_error;
    double *r = down ? out->tt_r : out->rd_r, *r_error = down ? out->tt_r_error : out->rd_r_error;
    double *a = down ? out->tt_a : out->rd_a, *a_error = down ? out->tt_a_error : out->rd_a_error;
    const double width = 1.5707963267948966 / (double)na; /* of a bin of angles */
    size_t ir, ia;
    for (ia = 0; ia < na; ++ia) { /* solid angle: 2 pi times the difference of the cosines at its edges */
        const double angle = ((double)ia + 0.5) * width, cosine = cos(angle);
        const double solid = 12.566370614359172 * sin(angle) * sin(width / 2);
        ms_mcml__bins_mean(bin + 2 * ia, nr, na, n, entered / solid, &a[ia], &a_error[ia]);
        for (ir = 0; ir < nr; ++ir) {
            const double area = ms_mcml__ring_area((int)ir, m->grid.dr_cm);
            const size_t i = ir * na + ia;
            ms_mcml__bins_mean(bin + 2 * i, 1, 1, n, entered / (area * solid * cosine), &ra[i], &ra_error[i]);
        }
    }
    for (ir = 0; ir < nr; ++ir)
        ms_mcml__bins_mean(bin + 2 * ir * na, na, 1, n, entered / ms_mcml__ring_area((int)ir, m->grid.dr_cm), &r[ir],
                           &r_error[ir]);
    ms_mcml__bins_mean(bin, nr * na, 1, n, entered, down ? &out->tt : &out->rd, down ? &out->tt_error : &out->rd_error);
}

/* Absorption over r and z, and over z. */
static void ms_mcml__depth_results(const ms_mcml *m, ms_mcml_result *out)
{
    const size_t nr = (size_t)m->grid.nr, nz = (size_t)m->grid.nz;
    const double dz = m->grid.dz_cm, unit = (double)ms_mcml__units, n = (double)m->photons, entered = 1 - m->specular;
    const int64_t *sum = m->sum + m->at.a;
    size_t z, r;
    for (z = 0; z < nz; ++z) {
        double all = 0;
        for (r = 0; r < nr; ++r) {
            const double cell = (double)sum[r * nz + z];
            out->a_rz[r * nz + z] = cell / unit / n * (entered / (ms_mcml__ring_area((int)r, m->grid.dr_cm) * dz));
            all += cell;
        }
        out->a_z[z] = all / unit / n * (entered / dz);
    }
}

static void ms_mcml__layer_results(const ms_mcml *m, ms_mcml_result *out)
{
    const size_t count = (size_t)m->tissue.layer_count;
    const int64_t *sum = m->sum + m->at.layers;
    double group[MS_MCML__GROUPS], all[MS_MCML__GROUPS] = {0};
    size_t g, i;
    for (i = 0; i < count; ++i) {
        for (g = 0; g < MS_MCML__GROUPS; ++g) {
            group[g] = (double)sum[g * count + i];
            all[g] += group[g];
        }
        ms_mcml__group_error(m, group, &out->a_l[i], &out->a_l_error[i]);
    }
    ms_mcml__group_error(m, all, &out->a, &out->a_error);
}

/* The arrays of a result, one block; arena->base NULL: only counts. */
static void ms_mcml__result_place(ms__arena *arena, const ms_mcml *m, ms_mcml_result *out)
{
    const size_t nr = (size_t)m->grid.nr, na = (size_t)m->grid.na, nz = (size_t)m->grid.nz;
    double **const array[4][4] = {{&out->rd_r, &out->rd_r_error, &out->tt_r, &out->tt_r_error},
                                  {&out->rd_a, &out->rd_a_error, &out->tt_a, &out->tt_a_error},
                                  {&out->rd_ra, &out->rd_ra_error, &out->tt_ra, &out->tt_ra_error},
                                  {&out->a_l, &out->a_l_error, &out->a_z, &out->a_rz}};
    const size_t layers = (size_t)m->tissue.layer_count;
    const size_t size[4][4] = {
        {nr, nr, nr, nr}, {na, na, na, na}, {nr * na, nr * na, nr * na, nr * na}, {layers, layers, nz, nr * nz}};
    int i, last = m->options.no_absorption ? 14 : 16;
    for (i = 0; i < last; ++i) *array[i / 4][i % 4] = (double *)ms__take(arena, size[i / 4][i % 4], sizeof(double));
}

MS_API ms_status ms_mcml_results(const ms_mcml *tally, ms_mcml_result *result, ms_error *error)
{
    ms__arena arena = {NULL, 0};
    ms_mcml_result out;
    double scale;
    if (tally == NULL || result == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tally or result is NULL");
    if (tally->photons == 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the tally is empty: no photons were run");
    memset(&out, 0, sizeof out);
    out.photons = tally->photons;
    out.grid = tally->grid;
    out.layer_count = tally->tissue.layer_count;
    out.allocator = tally->options.allocator;
    ms_mcml__result_place(&arena, tally, &out);
    out.memory_size = arena.used;
    out.memory = ms__alloc(&out.allocator, out.memory_size);
    if (out.memory == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the results", out.memory_size);
    arena.base = (char *)out.memory;
    arena.used = 0;
    ms_mcml__result_place(&arena, tally, &out);
    scale = (1 - tally->specular) / (double)tally->photons;
    out.specular = tally->specular;
    out.rd_unscattered = (double)tally->sum[tally->at.unscattered] / (double)ms_mcml__units * scale;
    out.tt_unscattered = (double)tally->sum[tally->at.unscattered + 1] / (double)ms_mcml__units * scale;
    ms_mcml__leave_results(tally, 0, &out);
    ms_mcml__leave_results(tally, 1, &out);
    ms_mcml__layer_results(tally, &out);
    if (out.a_z) ms_mcml__depth_results(tally, &out);
    *result = out;
    return MS_OK;
}

MS_API void ms_mcml_result_destroy(ms_mcml_result *result)
{
    if (result == NULL) return;
    ms__release(&result->allocator, result->memory, result->memory_size);
    memset(result, 0, sizeof *result);
}

MS_API ms_status ms_mcml_simulate(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid,
                                  const ms_mcml_options *options, ms_mcml_result *result, ms_error *error)
{
    ms_mcml *m;
    ms_status status;
    if (result == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "result is NULL");
    status = ms_mcml_create(tissue, grid, options, &m, error);
    if (status) return status;
    status = ms_mcml_run(m, 0, m->options.photons ? m->options.photons : 1000000, error);
    if (status == MS_OK) status = ms_mcml_results(m, result, error);
    ms_mcml_destroy(m);
    return status;
}

/* ---- materials ------------------------------------------------------------------------------------------------- */

MS_API const ms_mcml_material *ms_mcml_materials(int *count)
{
    static const ms_mcml_material table[] = {
        {"apple", {0.0030, 0.0034, 0.0460}, {2.2900, 2.3900, 1.9700}, 1.3},
        {"chicken1", {0.0150, 0.0770, 0.1900}, {0.1500, 0.2100, 0.3800}, 1.3},
        {"chicken2", {0.0180, 0.0880, 0.2000}, {0.1900, 0.2500, 0.3200}, 1.3},
        {"cream", {0.0002, 0.0028, 0.0163}, {7.3800, 5.4700, 3.1500}, 1.3},
        {"ketchup", {0.0610, 0.9700, 1.4500}, {0.1800, 0.0700, 0.0300}, 1.3},
        {"marble", {0.0021, 0.0041, 0.0071}, {2.1900, 2.6200, 3.0000}, 1.5},
        {"potato", {0.0024, 0.0090, 0.1200}, {0.6800, 0.7000, 0.5500}, 1.3},
        {"skimmilk", {0.0014, 0.0025, 0.0142}, {0.7000, 1.2200, 1.9000}, 1.3},
        {"skin1", {0.0320, 0.1700, 0.4800}, {0.7400, 0.8800, 1.0100}, 1.3},
        {"skin2", {0.0130, 0.0700, 0.1450}, {1.0900, 1.5900, 1.7900}, 1.3},
        {"wholemilk", {0.0011, 0.0024, 0.0140}, {2.5500, 3.2100, 3.7700}, 1.3},
    };
    if (count) *count = (int)(sizeof table / sizeof table[0]);
    return table;
}

MS_API const ms_mcml_material *ms_mcml_find_material(const char *name)
{
    int count, i;
    const ms_mcml_material *table = ms_mcml_materials(&count);
    for (i = 0; name && i < count; ++i) {
        const char *a = name, *b = table[i].name;
        while (*a && (*a == *b || (*a >= 'A' && *a <= 'Z' && *a - 'A' + 'a' == *b))) ++a, ++b;
        if (*a == 0 && *b == 0) return &table[i];
    }
    return NULL;
}

MS_API ms_mcml_medium ms_mcml_material_medium(const ms_mcml_material *material, int channel)
{
    ms_mcml_medium medium = {0, 0, 0, 1};
    if (material == NULL || channel < 0 || channel > 2) return medium;
    medium.mu_a_per_mm = material->mu_a_per_mm[channel];
    medium.mu_s_per_mm = material->mu_s_per_mm[channel];
    medium.eta = material->eta;
    return medium;
}

/* ---- half-space solver ----------------------------------------------------------------------------------------- */

enum {
    MS_MCML__RATES_MAX = 112,
    MS_MCML__CONE_MAX = 64,
    MS_MCML__COLUMNS_MAX = 200, /* candidates for a sum of rates; as many as there are rows are taken at most */
    MS_MCML__FIT_DOUBLES = (MS_MCML__RATES_MAX * (MS_MCML__COLUMNS_MAX + MS_MCML__RATES_MAX + 4) +
                            2 * MS_MCML__COLUMNS_MAX)
};

/* Lengths in mean free paths 1 / mu_t. The lateral Fourier transform q(z; k) of the collision density under a pencil
   beam obeys  q(z) = exp(-z) + a integral_0^inf K(z, z') q(z') dz'  with  K(z, z') = L(|z - z'|) + M(z + z'),

     L(z) = 1/2 int_1^inf exp(-w z) / w ds,           w = sqrt(s^2 + k^2)              flight from z' to z
     M(z) = 1/2 int_0^1 R(mu) exp(-z / mu) J0(k z tan theta) dmu / mu                  flight by way of the surface

   and what leaves is  a int_0^inf E(z) q(z) dz,  E(z) = 1/2 int_0^1 T(mu) exp(-z / mu) J0(k z tan theta) dmu.
   R = 1 - T is Fresnel's reflection inside; with T = 0 M(z) is L(z), so M is that minus an integral over the cone of
   directions that leave. Laplace transforms of L, M, E have closed forms or one smooth integral over the cone:

     G(b) = 1/2 int_1^inf ds / (w (b + w))            of L
     F(b) = 1/2 int_cone T dmu / sqrt((b mu + 1)^2 + k^2 sin^2 theta)       of the cone's part of M
     E(b) = the same with mu T                        of E

   Galerkin's method with the functions exp(-b_i z), b_i on a logarithmic lattice that contains 1, turns q - exp(-z)
   into a symmetric positive definite system whose entries are G, and divided differences of G - F. Its spacing h sets
   the error, about exp(-pi^2 / h), and the condition number, about exp(pi^2 / h): 0.3 is where they meet.

   The spectrum R(k) of multiple scattering is a Stieltjes function of k^2 with a cut from -nu_0^2 downwards, nu_0
   being Case's eigenvalue  a atanh(nu) / nu = 1.  So it is a sum of  energy / (1 + k^2 / b^2)  with b >= nu_0 and
   positive energies. They are found by non-negative least squares from R at k^2 = t^2 - nu_0^2, t on a logarithmic
   lattice: frequencies on both sides of k = 0, and up to the branch point, where the far tail of the profile shows. */

/* The diffuse reflectance of a half-space under a pencil beam at normal incidence, per incident energy, without the
   specular reflection at entry. Single scattering is a sum of exponentials, multiple scattering a sum of Bessel
   functions, all with positive energies, so the profile is positive and falls with r:

     energy beyond radius r    sum single_energy exp(-single_rate r) + sum energy (rate r) K1(rate r)
     spectrum at k             sum single_energy / sqrt(1 + (k / single_rate)^2) + sum energy / (1 + (k / rate)^2) */
typedef struct ms_mcml__halfspace {
    double mu_t_per_mm; /* mu_a + (1 - g) mu_s: similarity to isotropic scattering */
    double albedo;      /* (1 - g) mu_s / mu_t */
    double specular;    /* reflected at entry: ((eta - 1) / (eta + 1))^2; not part of any number below */
    double total;       /* diffuse reflectance: single + multiple scattering */
    double total_single;
    int singles, rates;
    double single_rate_per_mm[MS_MCML__CONE_MAX], single_energy[MS_MCML__CONE_MAX]; /* [singles] ascending rates */
    double rate_per_mm[MS_MCML__RATES_MAX], energy[MS_MCML__RATES_MAX];             /* [rates] ascending */
} ms_mcml__halfspace;

/* The cone of directions that leave: nodes of a double exponential rule in mu on [mu_c, 1]. It clusters them at both
   ends, where T has its square root and where tan theta has its own. */
typedef struct ms_mcml__cone {
    int count;
    double mu[MS_MCML__CONE_MAX], sin2[MS_MCML__CONE_MAX];
    double weight[MS_MCML__CONE_MAX]; /* T dmu / 2 */
} ms_mcml__cone;

static void ms_mcml__cone_make(ms_mcml__cone *cone, double eta)
{
    const double nodes = MS_MCML__CONE_MAX, spacing = 6.6 / nodes; /* beyond x = 3.3 exp(-pi sinh x) is rounding */
    double mu_c = eta > 1 ? sqrt((eta - 1) * (eta + 1)) / eta : 0;
    int i;
    cone->count = MS_MCML__CONE_MAX;
    for (i = 0; i < cone->count; ++i) {
        double x = (i + 0.5 - 0.5 * nodes) * spacing;
        double e = exp(-3.14159265358979324 * sinh(x));
        double above = (1 - mu_c) / (1 + e), below = (1 - mu_c) * e / (1 + e); /* mu - mu_c, 1 - mu */
        double mu = mu_c + above;
        double mu_out = eta > 1 ? eta * sqrt(above * (mu + mu_c)) : sqrt((1 - eta) * (1 + eta) + eta * eta * mu * mu);
        double s = eta * mu + mu_out, p = eta * mu_out + mu;
        double transmitted = 2 * eta * mu * mu_out * (1 / (s * s) + 1 / (p * p)); /* Fresnel, unpolarized */
        cone->mu[i] = mu;
        cone->sin2[i] = below * (1 + mu);
        cone->weight[i] = 0.5 * transmitted * spacing * 3.14159265358979324 * cosh(x) * above * e / (1 + e);
    }
}

/* Case's eigenvalue in [0, 1]: with y = atanh(nu), tanh(y) = a y. absorption = 1 - a, given apart because it may be
   far below the rounding of a. */
static double ms_mcml__case_eigenvalue(double albedo, double absorption)
{
    double y = 1 / albedo, next, residual, slope, tanh_y;
    int i;
    if (!(absorption > 0)) return 0;
    for (i = 0; i < 100; ++i) {
        tanh_y = tanh(y);
        if (y < 0.1) { /* y - tanh(y) without cancellation */
            double y2 = y * y;
            residual = y *
                (y2 * (1 / 3.0 + y2 * (-2 / 15.0 + y2 * (17 / 315.0 + y2 * (-62 / 2835.0 + y2 * (1382 / 155925.0))))) -
                 absorption);
        } else {
            residual = albedo * y - tanh_y;
        }
        slope = tanh_y * tanh_y - absorption; /* convex from the right: Newton falls monotonically */
        if (!(slope > 0)) break;
        next = y - residual / slope;
        if (!(next > 0 && next < y)) break;
        y = next;
    }
    return tanh(y);
}

/* G(b) and its derivative. With T = 1 / (1 + sqrt(1 + k^2)) and y = T / (1 + b T),
   G = y S(x),  x = (b^2 - k^2) y^2,  S(x) = atanh(sqrt x) / sqrt x = 1 + x / 3 + x^2 / 5 + ... */
static double ms_mcml__flight_transform(double b, double k2, double *derivative)
{
    double t = 1 / (1 + sqrt(1 + k2)), y = t / (1 + b * t), d2 = b * b - k2, x = d2 * y * y, s, ds;
    if (fabs(x) < 0.3) {
        int m;
        for (s = 0, ds = 0, m = 30; m >= 1; --m) {
            ds = ds * x + m / (2 * m + 1.0);
            s = s * x + 1 / (2 * m + 1.0);
        }
        s = s * x + 1;
    } else {
        double root = sqrt(fabs(x));
        /* atanh through 1 - sqrt x = (1 - x) / (1 + sqrt x), and 1 - x = (1 + 2 b T + k^2 T^2) (y / T)^2 */
        double one_minus_x = (1 + 2 * b * t + k2 * t * t) * (y / t) * (y / t);
        s = x > 0 ? log((1 + root) * (1 + root) / one_minus_x) / (2 * root) : atan(root) / root;
        ds = (1 / one_minus_x - s) / (2 * x);
    }
    *derivative = -y * y * s + y * ds * (2 * b * y * y - 2 * d2 * y * y * y);
    return y * s;
}

/* A triangle of that many rows, one behind the other. */
enum { MS_MCML__DEPTH_MAX = 64, MS_MCML__TRIANGLE = MS_MCML__DEPTH_MAX * (MS_MCML__DEPTH_MAX + 1) / 2 };

static double *ms_mcml__triangle_row(double *matrix, int i) { return matrix + i * (i + 1) / 2; }

/* R(k) of multiple scattering without the factor 1 - R_sp. t = sqrt(k^2 + nu_0^2) is the slowest decay in depth.
   h: log spacing of the exponentials' rates b_i. matrix: MS_MCML__TRIANGLE doubles of workspace. */
static double ms_mcml__multiple(const ms_mcml__cone *cone, double albedo, double k2, double t, double h, double *matrix)
{
    double b[MS_MCML__DEPTH_MAX], scale[MS_MCML__DEPTH_MAX], g[MS_MCML__DEPTH_MAX], dg[MS_MCML__DEPTH_MAX];
    double m[MS_MCML__DEPTH_MAX], dm[MS_MCML__DEPTH_MAX], escape[MS_MCML__DEPTH_MAX], u[MS_MCML__DEPTH_MAX];
    /* The solution decays at the rate t and at every rate above sqrt(1 + k^2); at the surface down to a layer 1 / k.
       So: a lattice from three steps below to 60 times the fastest, and t apart where it lies below the lattice. */
    double edge = sqrt(1 + k2), low = exp(-3 * h) * (edge < 1 ? edge : 1);
    int apart = t < 0.6 * low, first, last = (int)ceil(log(60 * (t > 1 ? t : 1)) / h), n = 0, one, i, j, c;
    double sum;
    if (!apart && low > exp(-3 * h) * t) low = exp(-3 * h) * t;
    first = (int)floor(log(low) / h);
    if (apart) b[n++] = t;
    one = n - first; /* b_one = 1, the rate of the beam */
    for (i = first; i <= last && n < MS_MCML__DEPTH_MAX; ++i) b[n++] = exp(h * i);

    /* g = G(b_i), m = G - F, escape = E(b_i), and derivatives by b: sums over the cone's directions. */
    for (i = 0; i < n; ++i) {
        double f = 0, df = 0, e = 0;
        scale[i] = sqrt(2 * b[i]); /* 1 / norm of exp(-b z) */
        g[i] = ms_mcml__flight_transform(b[i], k2, &dg[i]);
        for (c = 0; c < cone->count; ++c) {
            double v = b[i] * cone->mu[c] + 1, square = v * v + k2 * cone->sin2[c];
            double term = cone->weight[c] / sqrt(square);
            f += term;
            e += term * cone->mu[c];
            df -= term * v * cone->mu[c] / square;
        }
        escape[i] = e;
        m[i] = g[i] - f;
        dm[i] = dg[i] - df;
    }

    /* Scaled <b_i, (1 - a K) b_j> = (1 - a (g_i + g_j)) / (b_i + b_j) - a (m_j - m_i) / (b_i - b_j); on the diagonal
       the last quotient is -m'. u: <b_i, K exp(-z)>, the same with b_one. */
    for (i = 0; i < n; ++i) {
        double *row = ms_mcml__triangle_row(matrix, i);
        for (j = 0; j <= i; ++j) {
            double image = i == j ? -dm[i] : (m[j] - m[i]) / (b[i] - b[j]);
            row[j] = scale[i] * scale[j] * ((1 - albedo * (g[i] + g[j])) / (b[i] + b[j]) - albedo * image);
        }
        sum = i == one ? -dm[i] : (m[i] - m[one]) / (b[one] - b[i]);
        u[i] = scale[i] * ((g[i] + g[one]) / (b[i] + b[one]) + sum);
    }

    /* Cholesky C C^T with the inverse of C's diagonal in its place; C v = u, then C^T u = v. */
    for (i = 0; i < n; ++i) {
        double *row = ms_mcml__triangle_row(matrix, i);
        for (j = 0; j <= i; ++j) {
            const double *other = ms_mcml__triangle_row(matrix, j);
            for (sum = row[j], c = 0; c < j; ++c) sum -= row[c] * other[c];
            if (j < i) row[j] = sum * other[j];
        }
        row[i] = sum > 1e-16 ? 1 / sqrt(sum) : 0; /* a function that depends on the others in double drops out */
        for (c = 0; c < i; ++c) u[i] -= row[c] * u[c];
        u[i] *= row[i];
    }
    for (i = n - 1; i >= 0; --i) {
        const double *row = ms_mcml__triangle_row(matrix, i);
        u[i] *= row[i];
        for (c = 0; c < i; ++c) u[c] -= row[c] * u[i];
    }

    /* What leaves: a int E(z) (q(z) - exp(-z)) dz = a^2 sum E(b_i) u_i. */
    for (sum = 0, i = 0; i < n; ++i) sum += scale[i] * escape[i] * u[i];
    return albedo * albedo * sum;
}

/* Non-negative least squares (Lawson & Hanson 1974, chapter 23): minimizes |A x - target| with x >= 0. Columns have
   unit length. QR by Householder reflections that are appended as columns enter and rebuilt from the place where one
   leaves. */
typedef struct ms_mcml__nnls {
    int rows, columns, active;
    const double *a, *target;                /* [columns][rows], [rows] */
    double *x;                               /* [columns] */
    double *qr;                              /* [rows] a column: reflection below, R above the diagonal */
    double *diagonal, *rhs, *residual;       /* [rows] */
    double *solution;                        /* [columns] */
    int list[MS_MCML__COLUMNS_MAX];          /* the active columns */
    signed char state[MS_MCML__COLUMNS_MAX]; /* 1 active, -1 refused until the next success */
} ms_mcml__nnls;

static double ms_mcml__dot(const double *a, const double *b, int n)
{
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    int i;
    for (i = 0; i + 4 <= n; i += 4) {
        s0 += a[i] * b[i];
        s1 += a[i + 1] * b[i + 1];
        s2 += a[i + 2] * b[i + 2];
        s3 += a[i + 3] * b[i + 3];
    }
    for (; i < n; ++i) s0 += a[i] * b[i];
    return (s0 + s1) + (s2 + s3);
}

static void ms_mcml__reflect(const double *v, int from, int rows, double *target) /* |v|^2 = 2 */
{
    double dot = ms_mcml__dot(v + from, target + from, rows - from);
    int i;
    for (i = from; i < rows; ++i) target[i] -= dot * v[i];
}

static void ms_mcml__nnls_factor(ms_mcml__nnls *p, int from)
{
    int c, k, i, rows = p->rows;
    for (c = from; c < p->active; ++c) {
        double *v = p->qr + c * rows, norm = 0;
        memcpy(v, p->a + p->list[c] * rows, (size_t)rows * sizeof *v);
        for (k = 0; k < c; ++k) ms_mcml__reflect(p->qr + k * rows, k, rows, v);
        for (i = c; i < rows; ++i) norm += v[i] * v[i];
        norm = sqrt(norm);
        p->diagonal[c] = v[c] > 0 ? -norm : norm;
        v[c] -= p->diagonal[c];
        if (norm > 0) {
            double factor = 1 / sqrt(norm * fabs(v[c])); /* |v|^2 = 2 norm |v_c| */
            for (i = c; i < rows; ++i) v[i] *= factor;
        }
    }
    memcpy(p->rhs, p->target, (size_t)rows * sizeof *p->rhs);
    for (c = 0; c < p->active; ++c) ms_mcml__reflect(p->qr + c * rows, c, rows, p->rhs);
    for (c = p->active - 1; c >= 0; --c) {
        double sum = p->rhs[c];
        for (k = c + 1; k < p->active; ++k) sum -= p->qr[k * rows + c] * p->solution[k];
        p->solution[c] = sum / p->diagonal[c];
    }
}

static void ms_mcml__nnls_solve(ms_mcml__nnls *p)
{
    int i, c, round, rows = p->rows;
    p->active = 0;
    for (c = 0; c < p->columns; ++c) {
        p->x[c] = 0;
        p->state[c] = 0;
    }
    memcpy(p->residual, p->target, (size_t)rows * sizeof *p->residual);
    for (round = 0; round < 4 * p->columns && p->active < rows; ++round) {
        /* The column of the steepest descent, A^T (target - A x), becomes active. */
        double best = 0;
        int enters = -1;
        for (c = 0; c < p->columns; ++c) {
            double dot;
            if (p->state[c]) continue;
            dot = ms_mcml__dot(p->a + c * rows, p->residual, rows);
            if (dot > best) {
                best = dot;
                enters = c;
            }
        }
        if (enters < 0) break;
        p->list[p->active++] = enters;
        p->state[enters] = 1;
        ms_mcml__nnls_factor(p, p->active - 1);
        if (!(p->solution[p->active - 1] > 0)) { /* rounding: it would enter with the wrong sign */
            p->state[enters] = -1;
            p->active--;
            continue;
        }

        /* From x towards the active columns' least-squares solution, x += part (solution - x), as far as no element
           becomes negative. Who arrives at 0 leaves, until the whole way is free. */
        for (;;) {
            double part = 1;
            int leaves = -1, kept = 0, first;
            for (c = 0; c < p->active; ++c) {
                double x = p->x[p->list[c]];
                if (p->solution[c] <= 0 && x / (x - p->solution[c]) < part) {
                    part = x / (x - p->solution[c]);
                    leaves = c;
                }
            }
            for (c = 0; c < p->active; ++c) p->x[p->list[c]] += part * (p->solution[c] - p->x[p->list[c]]);
            if (leaves < 0) break;
            for (first = p->active, c = 0; c < p->active; ++c) {
                int column = p->list[c];
                if (c == leaves || !(p->x[column] > 0)) {
                    p->x[column] = 0;
                    p->state[column] = 0;
                    if (c < first) first = c;
                } else {
                    p->list[kept++] = column;
                }
            }
            p->active = kept;
            ms_mcml__nnls_factor(p, first);
        }

        /* residual = target - A x */
        memcpy(p->residual, p->target, (size_t)rows * sizeof *p->residual);
        for (c = 0; c < p->active; ++c)
            for (i = 0; i < rows; ++i) p->residual[i] -= p->x[p->list[c]] * p->a[p->list[c] * rows + i];
        for (c = 0; c < p->columns; ++c)
            if (p->state[c] < 0) p->state[c] = 0;
    }
}

/* rate[j], energy[j] > 0 with  sum energy / (1 + k^2 / rate^2) = spectrum[i]  at k^2 = t[i]^2 - edge^2, rates on a
   lattice sqrt(edge^2 + tau^2) of log spacing `step` in tau. Returns how many. total is the spectrum at k = 0, which
   the energies are scaled to. Row i counts as 1 / (1 + t[i]), as the relative error of the spectrum grows with t. */
static int ms_mcml__stieltjes(const double *t, const double *spectrum, int rows, double edge, double step, double total,
                              double *rate, double *energy, double *work)
{
    double tau[MS_MCML__COLUMNS_MAX], norm[MS_MCML__COLUMNS_MAX], sum = 0, unit = 1;
    double *a = work, *target = a + MS_MCML__COLUMNS_MAX * MS_MCML__RATES_MAX;
    ms_mcml__nnls p;
    int i, c, count = 0;
    p.rows = rows;
    p.columns = 0;
    if (edge > 0) tau[p.columns++] = 0;
    for (i = (int)floor(-1.2 / step); p.columns < MS_MCML__COLUMNS_MAX && t[0] * exp(step * (i - 1)) < 20 * t[rows - 1];
         ++i)
        tau[p.columns++] = t[0] * exp(step * i);
    p.a = a;
    p.target = target;
    p.rhs = target + MS_MCML__RATES_MAX;
    p.residual = p.rhs + MS_MCML__RATES_MAX;
    p.diagonal = p.residual + MS_MCML__RATES_MAX;
    p.qr = p.diagonal + MS_MCML__RATES_MAX;
    p.x = p.qr + MS_MCML__RATES_MAX * MS_MCML__RATES_MAX;
    p.solution = p.x + MS_MCML__COLUMNS_MAX;
    for (i = 0; i < rows; ++i) target[i] = 1 / (1 + t[i]);           /* misfits are relative to the spectrum */
    if (spectrum[0] > 0 && spectrum[0] < 1e-100) unit = spectrum[0]; /* the squares below would overflow */
    for (c = 0; c < p.columns; ++c) {
        for (i = 0; i < rows; ++i)
            a[c * rows + i] = target[i] / ((t[i] * t[i] + tau[c] * tau[c]) * (spectrum[i] / unit));
        for (norm[c] = 0, i = 0; i < rows; ++i) norm[c] += a[c * rows + i] * a[c * rows + i];
        norm[c] = 1 / sqrt(norm[c]);
        for (i = 0; i < rows; ++i) a[c * rows + i] *= norm[c];
    }
    ms_mcml__nnls_solve(&p);
    for (c = 0; c < p.columns; ++c) {
        double square = edge * edge + tau[c] * tau[c];
        if (!(p.x[c] > 0)) continue;
        rate[count] = sqrt(square);
        energy[count] = p.x[c] * norm[c] / square;
        sum += energy[count++];
    }
    for (c = 0; c < count; ++c) energy[c] *= total / sum;
    return count;
}

static ms_status ms_mcml__check_medium(const ms_mcml_medium *medium, ms_error *error)
{
    const double mu_a = medium->mu_a_per_mm, mu_s = medium->mu_s_per_mm;
    if (!ms_mcml__between(mu_a, 0, HUGE_VAL) || !ms_mcml__between(mu_s, 0, HUGE_VAL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "mu_a_per_mm is %g and mu_s_per_mm is %g, expected numbers >= 0",
                        mu_a, mu_s);
    if (!ms_mcml__between(mu_a + mu_s, 1e-100, 1e100))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "mu_a_per_mm + mu_s_per_mm is %g, expected 1e-100 to 1e100",
                        mu_a + mu_s);
    if (!ms__finite(medium->g) || !(medium->g > -1 && medium->g < 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "g is %g, expected more than -1 and less than 1", medium->g);
    if (!ms_mcml__between(medium->eta, 0.1, 10))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "eta is %g, expected 0.1 to 10", medium->eta);
    return MS_OK;
}

enum { MS_MCML__SOLVE_DOUBLES = (int)MS_MCML__FIT_DOUBLES + (int)MS_MCML__TRIANGLE };

/* Part of the entering light that leaves after two collisions and more. single: the part that leaves after one. Between
   two meetings with the boundary, which may hold most of it back, a part in proportion to nu = sqrt(3 (1 - albedo)) is
   absorbed: for a slow decay lost / left is that of t times nu / t, since the albedo's rounding would be felt. Below
   t = 4e-6 that is 1.5 2^-54 / t^2 of `lost`, more than the law leaves out, at most 1.25 t. */
static double ms_mcml__multiple_total(const ms_mcml__cone *cone, double albedo, double nu, double depth_step,
                                      double entering, double single, double *work)
{
    const double t = fmax(nu, 4e-6);
    const double multiple = entering * ms_mcml__multiple(cone, nu < t ? 1 - t * t / 3 : albedo, 0, t, depth_step, work);
    const double left = single + multiple, lost = (entering - left) * (nu / t);
    return nu < t ? entering * left / (left + lost) - single : multiple;
}

/* A medium that was checked, by the two steps of ms_mcml_profile_options; work: MS_MCML__SOLVE_DOUBLES. */
static void ms_mcml__solve(const ms_mcml_medium *medium, double depth_step, double frequency_step,
                           ms_mcml__halfspace *s, double *work)
{
    const double slowest = 1e-7, fastest = 200; /* of the lattice of t, per mean free path */
    const double mu_s = medium->mu_s_per_mm * (1 - medium->g);
    double t[MS_MCML__RATES_MAX], spectrum[MS_MCML__RATES_MAX], absorption, entering, nu, multiple, low;
    ms_mcml__cone cone;
    int i, rows;
    memset(s, 0, sizeof *s);
    s->mu_t_per_mm = medium->mu_a_per_mm + mu_s;
    s->albedo = mu_s / s->mu_t_per_mm;
    s->specular = (medium->eta - 1) / (medium->eta + 1);
    s->specular *= s->specular;
    absorption = medium->mu_a_per_mm / s->mu_t_per_mm;
    entering = 1 - s->specular;
    if (!(s->albedo > 1e-100)) return; /* nothing comes back */
    ms_mcml__cone_make(&cone, medium->eta);

    /* Single scattering at angle theta to the normal:  energy beyond r is  exp(-r / u),  u = tan(theta / 2) */
    for (i = 0; i < cone.count; ++i) {
        const double mu = cone.mu[i];
        s->single_rate_per_mm[i] = (1 + mu) / sqrt(cone.sin2[i]);
        s->single_energy[i] = entering * s->albedo * cone.weight[i] * mu / (1 + mu);
        s->total_single += s->single_energy[i];
    }
    s->singles = cone.count;

    /* Multiple scattering at k = 0. */
    nu = ms_mcml__case_eigenvalue(s->albedo, absorption);
    multiple = ms_mcml__multiple_total(&cone, s->albedo, nu, depth_step, entering, s->total_single, work);
    s->total = s->total_single + multiple;

    /* Its spectrum at k^2 = t^2 - nu^2, and the sum of energy / (1 + k^2 / rate^2) that has this spectrum. Rates need a
       finer lattice than frequencies: 0.8 steps. */
    low = 0.01 * nu > slowest ? 0.01 * nu : slowest;
    for (rows = 0; rows < MS_MCML__RATES_MAX && low * exp(frequency_step * (rows - 1)) < fastest; ++rows) {
        t[rows] = low * exp(frequency_step * rows);
        spectrum[rows] = entering *
            ms_mcml__multiple(&cone, s->albedo, t[rows] * t[rows] - nu * nu, t[rows], depth_step, work);
    }
    s->rates = ms_mcml__stieltjes(t, spectrum, rows, nu, 0.8 * frequency_step, multiple, s->rate_per_mm, s->energy,
                                  work);

    /* From mean free paths to mm. */
    for (i = 0; i < s->singles; ++i) s->single_rate_per_mm[i] *= s->mu_t_per_mm;
    for (i = 0; i < s->rates; ++i) s->rate_per_mm[i] *= s->mu_t_per_mm;
}

static ms_status ms_mcml__check_steps(double *depth_step, double *frequency_step, ms_error *error)
{
    if (ms_mcml__between(*depth_step, 0, 0)) *depth_step = 0.3;
    if (ms_mcml__between(*frequency_step, 0, 0)) *frequency_step = 0.25;
    if (!ms_mcml__between(*depth_step, 0.28, 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "depth_step is %g, expected 0.28 to 1, or 0", *depth_step);
    if (!ms_mcml__between(*frequency_step, 0.2, 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "frequency_step is %g, expected 0.2 to 1, or 0",
                        *frequency_step);
    return MS_OK;
}

/* x K1(x), relative error below 1e-11: the power series up to 2, then sqrt(x) exp(x) K1(x) as a polynomial in 2 / x,
   which interpolates at the Chebyshev nodes of [0, 1]. */
static double ms_mcml__x_bessel_k1(double x)
{
    static const double p[] = {1.2533141373223884,     0.23499639828639249,    -0.036718040184640545,
                               0.016060675864789022,   -0.011250123789009064,  0.010517606692691388,
                               -0.01136402908770562,   0.012188203438317703,   -0.011308843515876503,
                               0.0081313856435097981,  -0.0040970924956295601, 0.0012653699962738531,
                               -0.00017867465249178075};
    double sum = 0, y;
    int i;
    if (!(x > 0)) return 1;
    if (x <= 2) { /* 1 + x^2 / 2 sum (x^2 / 4)^m / (m! (m+1)!) (ln(x / 2) - (psi(m+1) + psi(m+2)) / 2) */
        double term = 1, log_half = log(0.5 * x), psi = -0.57721566490153286 + 0.5;
        y = 0.25 * x * x;
        for (i = 0; i < 12; ++i) {
            sum += term * (log_half - psi);
            term *= y / ((i + 1) * (i + 2));
            psi += 0.5 / (i + 1) + 0.5 / (i + 2);
        }
        return 1 + 2 * y * sum;
    }
    y = 2 / x;
    for (i = (int)(sizeof p / sizeof p[0]) - 1; i >= 0; --i) sum = sum * y + p[i];
    return sum * sqrt(x) * exp(-x);
}

/* Energy that leaves farther than r from the beam; at 0 the total. */
static double ms_mcml__halfspace_outside(const ms_mcml__halfspace *s, double r)
{
    double sum = 0;
    int i;
    for (i = 0; i < s->singles && s->single_rate_per_mm[i] * r < 745; ++i)
        sum += s->single_energy[i] * exp(-s->single_rate_per_mm[i] * r);
    for (i = 0; i < s->rates && s->rate_per_mm[i] * r < 745; ++i)
        sum += s->energy[i] * ms_mcml__x_bessel_k1(s->rate_per_mm[i] * r);
    return sum;
}

/* Mean of R_d over the ring r0 <= r < r1 in 1/mm^2. */
static double ms_mcml__halfspace_ring(const ms_mcml__halfspace *s, double r0, double r1)
{
    double sum = 0;
    int i;
    if (r1 - r0 < 1e-4 * r1) { /* a narrower ring has the same mean, but would cancel */
        const double middle = 0.5 * (r0 + r1);
        r0 = (1 - 0.5e-4) * middle;
        r1 = (1 + 0.5e-4) * middle;
    }
    for (i = 0; i < s->singles && s->single_rate_per_mm[i] * r0 < 745; ++i)
        sum -= s->single_energy[i] * exp(-s->single_rate_per_mm[i] * r0) * expm1(-s->single_rate_per_mm[i] * (r1 - r0));
    for (i = 0; i < s->rates && s->rate_per_mm[i] * r0 < 745; ++i)
        sum += s->energy[i] *
            (ms_mcml__x_bessel_k1(s->rate_per_mm[i] * r0) - ms_mcml__x_bessel_k1(s->rate_per_mm[i] * r1));
    return sum / (3.14159265358979324 * (r1 - r0) * (r1 + r0));
}

/* ---- similarity ------------------------------------------------------------------------------------------------ */

/* A medium of g != 0 is replaced by one of mu_s (1 - g) and g = 0. These bound, as a part of the value, what that does
   to a ring at r reduced mean free paths and to the total; chosen to hold for discrete ordinates and photons at eta 1
   to 2 (tests/test_mcml_profile.c: similarity). Near the beam light is scattered once, and its error is the phase
   function's, at most 1 / (1 - |g|)^2 backwards. */
static double ms_mcml__similarity_scale(double g) { return g < 0 ? 1 / ((1 + g) * (1 + g)) : 1.3 * g / (0.5 + g); }

static double ms_mcml__similarity_error(const ms_mcml__halfspace *s, double g, double r)
{
    const double far_out = 0.25 + sqrt(1 - s->albedo), scale = ms_mcml__similarity_scale(g);
    if (g < 0) return scale * exp(-r) + 1;
    return scale * fmax(exp(-r), far_out);
}

static double ms_mcml__similarity_total_error(const ms_mcml__halfspace *s, double g)
{
    return fabs(g) > 0 ? ms_mcml__similarity_scale(g) * fmin(1, 3 * (1 - s->albedo) + 4e-4) : 0;
}

/* ---- colors ---------------------------------------------------------------------------------------------------- */

/* Part of the entering light that comes back, at g = 0. absorbed: 1 - albedo. */
static double ms_mcml__reflected(const ms_mcml__cone *cone, double absorbed)
{
    double work[MS_MCML__TRIANGLE], single = 0;
    const double albedo = 1 - absorbed, nu = ms_mcml__case_eigenvalue(albedo, absorbed);
    int i;
    for (i = 0; i < cone->count; ++i) single += albedo * cone->weight[i] * cone->mu[i] / (1 + cone->mu[i]);
    return single + ms_mcml__multiple_total(cone, albedo, nu, 0.3, 1, single, work);
}

/* The albedo of a color and, as it may round to 1, 1 - albedo. The reflectance falls almost linearly with
   s = sqrt(1 - albedo): secants inside a bracket. Where the albedo is next to nothing light is scattered once, and the
   reflectance is proportional to it. */
static double ms_mcml__albedo_of(double color, double eta, double *absorbed)
{
    double s = 1 - color, slope = -1, last = s, before = 0, low = 0, high = 1, single = 0;
    ms_mcml__cone cone;
    int i;
    ms_mcml__cone_make(&cone, eta);
    for (i = 0; i < cone.count; ++i) single += cone.weight[i] * cone.mu[i] / (1 + cone.mu[i]);
    if (color < 1e-5 * single) {
        *absorbed = 1 - color / single;
        return color / single;
    }
    for (i = 0; i < 60 && high - low > 1e-15; ++i) {
        const double error = ms_mcml__reflected(&cone, s * s) - color;
        if (fabs(s - last) > 1e-9 * s) slope = (error - before) / (s - last);
        if (error > 0) low = s;
        else high = s;
        if (fabs(error) < 1e-10 * color) break;
        before = error;
        last = s;
        s = slope < 0 ? s - error / slope : low;
        if (!(s > low && s < high)) s = 0.5 * (low + high);
    }
    *absorbed = s * s;
    return (1 - s) * (1 + s);
}

MS_API ms_status ms_mcml_medium_from_color(double color, double length_mm, int kind, double eta, ms_mcml_medium *medium,
                                           ms_error *error)
{
    const double x = fabs(color - 0.8), y = (color - 0.33) * (color - 0.33), d = 1.85 - color + 7 * x * x * x;
    double absorbed = color > 0 ? 0 : 1, albedo = 1 - absorbed, mu_t;
    if (medium == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "medium is NULL");
    if (!ms_mcml__between(eta, 0.1, 10))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "eta is %g, expected 0.1 to 10", eta);
    if (!ms_mcml__between(color, 0, 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "color is %g, expected 0 to 1", color);
    if (!ms_mcml__between(length_mm, 1e-30, 1e30))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "length_mm is %g, expected 1e-30 to 1e30", length_mm);
    if (kind < MS_MCML_MEAN_FREE_PATH || kind > MS_MCML_DIFFUSE_PATH)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "kind is %d, expected one of ms_mcml_length", kind);
    if (color > 0 && color < 1) albedo = ms_mcml__albedo_of(color, eta, &absorbed);
    mu_t = 1 / length_mm;
    if (kind == MS_MCML_BURLEY_D) mu_t /= d;
    if (kind == MS_MCML_DIFFUSE_PATH) mu_t *= (3.5 + 100 * y * y) / d;
    medium->mu_a_per_mm = absorbed * mu_t;
    medium->mu_s_per_mm = albedo * mu_t;
    medium->g = 0;
    medium->eta = eta;
    return MS_OK;
}

/* ---- diffusion profiles ---------------------------------------------------------------------------------------- */

static ms_status ms_mcml__check_rings(const ms_mcml_profile_options *o, ms_error *error)
{
    const double *edge = o->edge_mm;
    int i;
    if (o->rings == 0 && edge == NULL) return MS_OK;
    if (o->rings < 1 || o->rings > 1 << 24)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "rings is %d, expected 1 to %d", o->rings, 1 << 24);
    for (i = 0; edge && i <= o->rings; ++i)
        if (!ms_mcml__between(edge[i], i ? 1e-100 : 0, 1e100) || (i > 0 && !(edge[i] > edge[i - 1])))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                            "ring edge %d is %g, expected increasing numbers, 0 or 1e-100 to 1e100", i, edge[i]);
    if (edge == NULL && !ms_mcml__between(o->ring_mm, 1e-100, 1e100))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "ring_mm is %g, expected 1e-100 to 1e100", o->ring_mm);
    return MS_OK;
}

typedef struct ms_mcml__channel {
    ms_mcml__halfspace solution;
    double work[MS_MCML__SOLVE_DOUBLES];
} ms_mcml__channel;

typedef struct ms_mcml__profile_job {
    const ms_mcml_medium *media;
    const ms_mcml_profile_options *options;
    ms_mcml_profile *profile;
    ms_mcml__channel *channel; /* [channels] */
} ms_mcml__profile_job;

static void ms_mcml__profile_solve(void *context, int channel)
{
    const ms_mcml__profile_job *job = (const ms_mcml__profile_job *)context;
    ms_mcml__channel *c = &job->channel[channel];
    ms_mcml__solve(&job->media[channel], job->options->depth_step, job->options->frequency_step, &c->solution, c->work);
}

/* The rows of a channel; where the difference of two edges would cancel, from the ring itself. */
static void ms_mcml__profile_fill(void *context, int channel)
{
    const ms_mcml__profile_job *job = (const ms_mcml__profile_job *)context;
    const ms_mcml_profile *p = job->profile;
    const ms_mcml__halfspace *s = &job->channel[channel].solution;
    const size_t row = (size_t)channel * (size_t)p->rings;
    const double g = job->media[channel].g;
    double *within = p->within + row + channel, *rd = p->rd_per_mm2 + row, *rd_error = p->rd_error_per_mm2 + row;
    double outside = ms_mcml__halfspace_outside(s, p->edge_mm[0]);
    int i;
    within[0] = s->total - outside;
    for (i = 0; i < p->rings; ++i) {
        const double r0 = p->edge_mm[i], r1 = p->edge_mm[i + 1], next = ms_mcml__halfspace_outside(s, r1);
        within[i + 1] = s->total - next;
        rd[i] = outside - next > 1e-6 * outside ? (outside - next) / (3.14159265358979324 * (r1 - r0) * (r1 + r0))
                                                : ms_mcml__halfspace_ring(s, r0, r1);
        rd_error[i] = rd[i] * ms_mcml__similarity_error(s, g, r0 * s->mu_t_per_mm);
        outside = next;
    }
    p->entering[channel] = 1 - s->specular;
    p->total[channel] = s->total;
    p->total_error[channel] = s->total * ms_mcml__similarity_total_error(s, g);
}

/* Radius beyond which a channel has 1e-5 of its energy left. */
static double ms_mcml__profile_radius(const ms_mcml__halfspace *s)
{
    double low = 1e-3 / s->mu_t_per_mm, high = 1e11 * low;
    int i;
    if (!(s->total > 0)) return 1 / s->mu_t_per_mm;
    for (i = 0; i < 40; ++i) {
        const double middle = sqrt(low * high);
        if (ms_mcml__halfspace_outside(s, middle) > 1e-5 * s->total) low = middle;
        else high = middle;
    }
    return high;
}

/* The rings that suit the channels; how many. edge NULL: only counts them. */
static int ms_mcml__profile_rings(const ms_mcml__channel *channel, int channels, double *edge)
{
    double radius = 0, mu_t = 0, r = 0;
    int c, n;
    for (c = 0; c < channels; ++c) {
        radius = fmax(radius, ms_mcml__profile_radius(&channel[c].solution));
        mu_t = fmax(mu_t, channel[c].solution.mu_t_per_mm);
    }
    if (edge) edge[0] = 0;
    for (n = 0; r < radius || n < 20; ++n) {
        r = n < 20 ? (n + 1) * 0.05 / mu_t : r * 1.04;
        if (edge) edge[n + 1] = r;
    }
    return n;
}

/* The arrays of a profile, one block; arena->base NULL: only counts. */
static void ms_mcml__profile_place(ms__arena *arena, ms_mcml_profile *p)
{
    const size_t n = (size_t)p->rings, c = (size_t)p->channels, size = sizeof(double);
    p->edge_mm = (double *)ms__take(arena, n + 1, size);
    p->within = (double *)ms__take(arena, c * (n + 1), size);
    p->rd_per_mm2 = (double *)ms__take(arena, c * n, size);
    p->rd_error_per_mm2 = (double *)ms__take(arena, c * n, size);
    p->entering = (double *)ms__take(arena, c, size);
    p->total = (double *)ms__take(arena, c, size);
    p->total_error = (double *)ms__take(arena, c, size);
}

MS_API ms_status ms_mcml_profile_make(ms_mcml_profile *profile, const ms_mcml_medium *media, int channels,
                                      const ms_mcml_profile_options *options, ms_error *error)
{
    ms_mcml_profile_options o;
    ms_mcml_profile p;
    ms_mcml__profile_job job;
    ms__arena arena = {NULL, 0};
    ms_status status;
    size_t size;
    int i;
    if (profile) memset(profile, 0, sizeof *profile);
    if (profile == NULL || media == NULL || channels < 1 || channels > 65536)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "%d channels, expected 1 to 65536, and profile and media not NULL", channels);
    memset(&o, 0, sizeof o);
    if (options) o = *options;
    for (i = 0; i < channels; ++i)
        if ((status = ms_mcml__check_medium(&media[i], error)) != MS_OK) return status;
    status = ms_mcml__check_steps(&o.depth_step, &o.frequency_step, error);
    if (status == MS_OK) status = ms_mcml__check_rings(&o, error);
    if (status) return status;

    size = ms__size_mul((size_t)channels, sizeof *job.channel);
    job.media = media;
    job.options = &o;
    job.channel = (ms_mcml__channel *)ms__alloc(&o.allocator, size);
    if (job.channel == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the half-space solver", size);
    ms__run(&o.parallel, channels, ms_mcml__profile_solve, &job);

    /* The profile's block, and its rings. */
    memset(&p, 0, sizeof p);
    p.channels = channels;
    p.rings = o.rings ? o.rings : ms_mcml__profile_rings(job.channel, channels, NULL);
    p.allocator = o.allocator;
    ms_mcml__profile_place(&arena, &p);
    p.memory_size = arena.used;
    p.memory = ms__alloc(&o.allocator, p.memory_size);
    if (p.memory == NULL) {
        ms__release(&o.allocator, job.channel, size);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d channels of %d rings", channels, p.rings);
    }
    arena.base = (char *)p.memory;
    arena.used = 0;
    ms_mcml__profile_place(&arena, &p);
    for (i = 0; i <= p.rings && o.rings; ++i) p.edge_mm[i] = o.edge_mm ? o.edge_mm[i] : i * o.ring_mm;
    if (o.rings == 0) ms_mcml__profile_rings(job.channel, channels, p.edge_mm);
    job.profile = &p;
    ms__run(&o.parallel, channels, ms_mcml__profile_fill, &job);
    ms__release(&o.allocator, job.channel, size);
    *profile = p;
    return MS_OK;
}

MS_API void ms_mcml_profile_destroy(ms_mcml_profile *profile)
{
    ms_allocator allocator;
    if (profile == NULL) return;
    allocator = profile->allocator;
    ms__release(&allocator, profile->memory, profile->memory_size);
    memset(profile, 0, sizeof *profile);
}

/* ---- kernels, one set a level ---------------------------------------------------------------------------------- */

#ifndef MS_MCML_FILENAME
#define MS_MCML_FILENAME "ms_mcml.h"
#endif

static MS__UNUSED float ms_mcml__bits_float(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static MS__UNUSED uint32_t ms_mcml__float_bits(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

#if defined(MS_MCML__NEON)
static MS__UNUSED unsigned ms_mcml__neon_bits(uint32x4_t mask)
{
    const uint32_t place[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(mask, vld1q_u32(place)));
}
#endif

#define MS_MCML__JOIN2(a, b) a##b
#define MS_MCML__JOIN(a, b) MS_MCML__JOIN2(a, b)
#define MS_MCML__FN(name) MS_MCML__JOIN(MS_MCML__JOIN(ms_mcml__##name, _), MS_MCML__LEVEL)

#define MS_MCML__PASS 1
#define MS_MCML__LEVEL scalar
#define MS_MCML__ISA 1
#include MS_MCML_FILENAME

#if defined(MS_MCML__X64) || defined(MS_MCML__NEON)
#define MS_MCML__LEVEL base
#define MS_MCML__ISA 2
#include MS_MCML_FILENAME
#endif

#if defined(MS_MCML__X64)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma,f16c"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c")
#endif
#define MS_MCML__LEVEL avx2
#define MS_MCML__ISA 3
#include MS_MCML_FILENAME

#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx2,fma,f16c"))), \
                             apply_to = function)
#else
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl")
#endif
#define MS_MCML__LEVEL avx512
#define MS_MCML__ISA 4
#include MS_MCML_FILENAME

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif /* MS_MCML__X64 */
#undef MS_MCML__PASS

static ms_mcml__trace *ms_mcml__trace_of(ms_simd level)
{
#if defined(MS_MCML__X64)
    if (level == MS_SIMD_AVX512) return ms_mcml__trace_avx512;
    if (level == MS_SIMD_AVX2) return ms_mcml__trace_avx2;
#endif
#if defined(MS_MCML__X64) || defined(MS_MCML__NEON)
    if (level == MS_SIMD_BASE) return ms_mcml__trace_base;
#endif
    (void)level;
    return ms_mcml__trace_scalar;
}

#undef MS_MCML__FN
#undef MS_MCML__JOIN
#undef MS_MCML__JOIN2
#undef MS_MCML__X64
#undef MS_MCML__NEON
#endif /* MS_MCML_IMPLEMENTATION */

#if defined(MS_MCML_IMPLEMENTATION) && defined(MS_MCML__PASS)
/* ---- kernels -------------------------------------------------------------------------------------------------

   Read once a level. Vectors of L floats (V), words (U) and comparisons' results (M), and as long ones of 64-bit
   words (W). Their operators are the compiler's. */

#define MS_MCML__V MS_MCML__FN(v)
#define MS_MCML__U MS_MCML__FN(u)
#define MS_MCML__W MS_MCML__FN(w)
#if MS_MCML__ISA == 1
#define MS_MCML__L 1
#define MS_MCML__VECTOR(type, x)                      \
    typedef type MS_MCML__FN(x), MS_MCML__FN(x##_at); \
    static inline type MS_MCML__FN(x##_set)(type a) { return a; }
#else
#define MS_MCML__L (1 << MS_MCML__ISA)
#define MS_MCML__VECTOR(type, x)                                                                                     \
    typedef type MS_MCML__FN(x) __attribute__((vector_size(4 * MS_MCML__L)));                                        \
    typedef type MS_MCML__FN(x##_at) __attribute__((vector_size(4 * MS_MCML__L), aligned(sizeof(type)), may_alias)); \
    static inline MS_MCML__FN(x) MS_MCML__FN(x##_set)(type a)                                                        \
    {                                                                                                                \
        const MS_MCML__FN(x) zero = {0};                                                                             \
        return a - zero; /* -0 stays -0 */                                                                           \
    }
#endif
MS_MCML__VECTOR(float, v)
MS_MCML__VECTOR(uint32_t, u)
MS_MCML__VECTOR(uint64_t, w)
#define MS_MCML__V_SET(a) MS_MCML__FN(v_set)(a)
#define MS_MCML__V_LOAD(p) ((MS_MCML__V) * (const MS_MCML__FN(v_at) *)(p))
#define MS_MCML__V_STORE(p, a) (*(MS_MCML__FN(v_at) *)(p) = (a))
#define MS_MCML__U_LOAD(p) ((MS_MCML__U) * (const MS_MCML__FN(u_at) *)(p))
#define MS_MCML__U_STORE(p, a) (*(MS_MCML__FN(u_at) *)(p) = (a))

#if MS_MCML__ISA == 4
#define MS_MCML__M __mmask16
#define MS_MCML__V_LESS(a, b) _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ)
#define MS_MCML__U_IS_ZERO(a) _mm512_testn_epi32_mask((__m512i)(a), (__m512i)(a))
#else
MS_MCML__VECTOR(int32_t, m)
#define MS_MCML__M MS_MCML__FN(m)
#define MS_MCML__V_LESS(a, b) ((MS_MCML__M)((a) < (b)))
#define MS_MCML__U_IS_ZERO(a) ((MS_MCML__M)((a) == 0))
#endif
#if MS_MCML__ISA == 1
#define MS_MCML__V_BITS(a) ms_mcml__bits_float(a)
#define MS_MCML__U_BITS(a) ms_mcml__float_bits(a)
#else
#define MS_MCML__V_BITS(a) ((MS_MCML__V)(a))
#define MS_MCML__U_BITS(a) ((MS_MCML__U)(a))
#endif

/* What operators do not say. HIGH: the upper half of a b, where all lanes of b are equal. */
#if MS_MCML__ISA == 1
#define MS_MCML__V_SQRT(a) sqrtf(a)
#define MS_MCML__V_MAX(a, b) ((a) > (b) ? (a) : (b))
#define MS_MCML__V_MIN(a, b) ((a) < (b) ? (a) : (b))
#define MS_MCML__V_SELECT(m, a, b) ((m) ? (a) : (b))
#define MS_MCML__V_FROM_INT(a) ((float)(int32_t)(a))
#define MS_MCML__V_TO_INT(a) ((uint32_t)(int32_t)(a))
#define MS_MCML__M_BITS(m) ((unsigned)(m))
#define MS_MCML__U_HIGH(a, b) ((uint32_t)((uint64_t)(a) * (b) >> 32))
#elif MS_MCML__ISA == 2 && defined(MS_MCML__NEON)
#define MS_MCML__V_SQRT(a) vsqrtq_f32(a)
#define MS_MCML__V_MAX(a, b) vmaxq_f32(a, b)
#define MS_MCML__V_MIN(a, b) vminq_f32(a, b)
#define MS_MCML__V_SELECT(m, a, b) vbslq_f32((MS_MCML__U)(m), a, b)
#define MS_MCML__V_FROM_INT(a) vcvtq_f32_s32((MS_MCML__M)(a))
#define MS_MCML__V_TO_INT(a) ((MS_MCML__U)vcvtq_s32_f32(a))
#define MS_MCML__M_BITS(m) ms_mcml__neon_bits((MS_MCML__U)(m))
#define MS_MCML__U_HIGH(a, b)                                                      \
    vuzp2q_u32(vreinterpretq_u32_u64(vmull_u32(vget_low_u32(a), vget_low_u32(b))), \
               vreinterpretq_u32_u64(vmull_high_u32(a, b)))
#elif MS_MCML__ISA == 2
#define MS_MCML__MM(name, mask, ...) _mm_##name(__VA_ARGS__)
#define MS_MCML__MM_INT __m128i
#define MS_MCML__V_SELECT(m, a, b) ((MS_MCML__V)(((m) & (MS_MCML__M)(a)) | (~(m) & (MS_MCML__M)(b))))
#define MS_MCML__M_BITS(m) ((unsigned)_mm_movemask_ps((__m128)(m)))
#elif MS_MCML__ISA == 3
#define MS_MCML__MM(name, mask, ...) _mm256_##name(__VA_ARGS__)
#define MS_MCML__MM_INT __m256i
#define MS_MCML__V_SELECT(m, a, b) _mm256_blendv_ps(b, a, (__m256)(m))
#define MS_MCML__M_BITS(m) ((unsigned)_mm256_movemask_ps((__m256)(m)))
#else /* without maskz GCC's header warns */
#define MS_MCML__MM(name, mask, ...) _mm512_maskz_##name(mask, __VA_ARGS__)
#define MS_MCML__MM_INT __m512i
#define MS_MCML__V_SELECT(m, a, b) _mm512_mask_blend_ps(m, b, a)
#define MS_MCML__M_BITS(m) ((unsigned)(m))
#endif
#if defined(MS_MCML__MM_INT)
#define MS_MCML__V_SQRT(a) MS_MCML__MM(sqrt_ps, 0xffff, a)
#define MS_MCML__V_MAX(a, b) MS_MCML__MM(max_ps, 0xffff, a, b)
#define MS_MCML__V_MIN(a, b) MS_MCML__MM(min_ps, 0xffff, a, b)
#define MS_MCML__V_FROM_INT(a) MS_MCML__MM(cvtepi32_ps, 0xffff, (MS_MCML__MM_INT)(a))
#define MS_MCML__V_TO_INT(a) ((MS_MCML__U)MS_MCML__MM(cvttps_epi32, 0xffff, a))
#define MS_MCML__EVEN(a, b) ((MS_MCML__W)MS_MCML__MM(mul_epu32, 0xff, (MS_MCML__MM_INT)(a), (MS_MCML__MM_INT)(b)))
#define MS_MCML__U_HIGH(a, b)                 \
    ((MS_MCML__U)(MS_MCML__EVEN(a, b) >> 32 | \
                  (MS_MCML__EVEN((MS_MCML__W)(a) >> 32, b) & ((uint64_t)0xffffffffu << 32))))
#endif
#if MS_MCML__ISA >= 3
#define MS_MCML__V_MADD(a, b, c) MS_MCML__MM(fmadd_ps, 0xffff, a, b, c)
#define MS_MCML__V_NMADD(a, b, c) MS_MCML__MM(fnmadd_ps, 0xffff, a, b, c)
#elif MS_MCML__ISA == 2 && defined(MS_MCML__NEON)
#define MS_MCML__V_MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_MCML__V_NMADD(a, b, c) vfmsq_f32(c, a, b)
#else
#define MS_MCML__V_MADD(a, b, c) ((a) * (b) + (c))
#define MS_MCML__V_NMADD(a, b, c) ((c) - (a) * (b))
#endif

/* -log(u), u = (word / 2 + 1/2) 2^-31 > 0. With u = (1 + t) 2^e and 1 + t in [sqrt(1/2), sqrt(2)):
   log(1 + t) = t - t^2 / 2 + t^3 P(t), to a float's rounding. */
static inline MS_MCML__V MS_MCML__FN(exponential)(MS_MCML__U word)
{
    const MS_MCML__V u = MS_MCML__V_MADD(MS_MCML__V_FROM_INT(word >> 1), MS_MCML__V_SET(1.0f / 2147483648.0f),
                                         MS_MCML__V_SET(1.0f / 4294967296.0f));
    const MS_MCML__U bits = MS_MCML__U_BITS(u) - 0x3f3504f3u + (64u << 23);
    const MS_MCML__V t = MS_MCML__V_BITS((bits & 0x7fffffu) + 0x3f3504f3u) - 1.0f;
    MS_MCML__V p = MS_MCML__V_MADD(t, MS_MCML__V_SET(-0.0810155815f), MS_MCML__V_SET(0.127123076f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(-0.12972239f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(0.142021738f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(-0.166422476f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(0.200014686f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(-0.250002965f));
    p = MS_MCML__V_MADD(p, t, MS_MCML__V_SET(0.333333286f));
    p = MS_MCML__V_MADD(MS_MCML__V_MADD(p, t, MS_MCML__V_SET(-0.5f)), t * t, t);
    return (64.0f - MS_MCML__V_FROM_INT(bits >> 23)) * 0.693147181f - p;
}

/* A word as a number in [0, 1) of 24 bits. */
static inline MS_MCML__V MS_MCML__FN(uniform)(MS_MCML__U word)
{
    return MS_MCML__V_FROM_INT(word >> 8) * (1.0f / 16777216.0f);
}

/* xoshiro128+ (Blackman, Vigna 2018), a lane a photon. */
#define MS_MCML__DRAW(word)                 \
    do {                                    \
        const MS_MCML__U shifted = s1 << 9; \
        word = s0 + s3;                     \
        s2 = s2 ^ s0;                       \
        s3 = s3 ^ s1;                       \
        s1 = s1 ^ s2;                       \
        s0 = s0 ^ s3;                       \
        s2 = s2 ^ shifted;                  \
        s3 = (s3 << 11) | (s3 >> 21);       \
    } while (0)

/* States of the next L photons, by Philox 4x32-10 of the seed and the photon's index. */
static void MS_MCML__FN(seed)(ms_mcml__tracer *t)
{
    const uint64_t seed = t->tally->options.seed;
    const MS_MCML__U m0 = MS_MCML__FN(u_set)(0xD2511F53u), m1 = MS_MCML__FN(u_set)(0xCD9E8D57u);
    MS_MCML__U c0, c1, c2 = MS_MCML__FN(u_set)(0x4D434D4Cu), c3 = m0 - m0; /* c2: apart from other uses of the seed */
    uint32_t low[MS_MCML__L], high[MS_MCML__L];
    MS_MCML__U k0 = MS_MCML__FN(u_set)((uint32_t)seed), k1 = MS_MCML__FN(u_set)((uint32_t)(seed >> 32));
    int i;
    for (i = 0; i < MS_MCML__L; ++i)
        low[i] = (uint32_t)(t->next + (uint64_t)i), high[i] = (uint32_t)((t->next + (uint64_t)i) >> 32);
    c0 = MS_MCML__U_LOAD(low);
    c1 = MS_MCML__U_LOAD(high);
    for (i = 0; i < 10; ++i, k0 += 0x9E3779B9u, k1 += 0xBB67AE85u) {
        const MS_MCML__U low0 = c0 * m0, high0 = MS_MCML__U_HIGH(c0, m0), high1 = MS_MCML__U_HIGH(c2, m1);
        c0 = high1 ^ c1 ^ k0;
        c1 = c2 * m1;
        c2 = high0 ^ c3 ^ k1;
        c3 = low0;
    }
    MS_MCML__U_STORE(t->fresh[0], c0);
    MS_MCML__U_STORE(t->fresh[1], c1);
    MS_MCML__U_STORE(t->fresh[2], c2);
    MS_MCML__U_STORE(t->fresh[3], c3);
    t->fresh_at = 0;
}

/* The next photons into the lanes whose bits are set, or none. */
static void MS_MCML__FN(launch)(ms_mcml__tracer *t, unsigned lanes)
{
    const ms_mcml__slab *slab = &t->tally->slab[t->tally->first_layer];
    const MS_MCML__M stays = MS_MCML__U_IS_ZERO(MS_MCML__U_LOAD(t->bit) & lanes);
    const MS_MCML__V zero = MS_MCML__V_SET(0.0f);
    int i;
#define MS_MCML__START(field, value) \
    MS_MCML__V_STORE(t->field, MS_MCML__V_SELECT(stays, MS_MCML__V_LOAD(t->field), value))
    MS_MCML__START(x, zero);
    MS_MCML__START(y, zero);
    MS_MCML__START(z, zero);
    MS_MCML__START(ux, zero);
    MS_MCML__START(uy, zero);
    MS_MCML__START(uz, MS_MCML__V_SET(1.0f));
    MS_MCML__START(w, MS_MCML__V_SET(1.0f));
    MS_MCML__START(kept, zero);
    MS_MCML__START(depth, MS_MCML__V_SET(slab->depth));
    MS_MCML__START(top, MS_MCML__V_SET(slab->top));
    MS_MCML__START(mfp, MS_MCML__V_SET(slab->mfp));
    MS_MCML__START(absorbed, MS_MCML__V_SET(slab->absorbed));
    MS_MCML__START(g, MS_MCML__V_SET(slab->g));
    MS_MCML__START(ratio_up, MS_MCML__V_SET(slab->ratio_up));
    MS_MCML__START(ratio_down, MS_MCML__V_SET(slab->ratio_down));
#undef MS_MCML__START
    for (; lanes; lanes &= lanes - 1) {
        i = ms_mcml__lowest(lanes);
        t->events[i] = 0;
        t->limit[i] = MS_MCML__HALVING_EVENTS;
        if (t->fresh_at >= MS_MCML__L) MS_MCML__FN(seed)(t);
        if (ms_mcml__assign(t, i)) continue;
        t->w[i] = 0;
        t->alive &= ~(1u << i);
    }
}

/* Absorption at a collision, in units of 2^-30, rounded up with a chance equal to the remainder: into cells and units,
   for the bins; the weight that is left after it and after roulette. */
static inline MS_MCML__V MS_MCML__FN(absorb)(ms_mcml__tracer *t, MS_MCML__M hit, MS_MCML__V x, MS_MCML__V y,
                                             MS_MCML__V z, MS_MCML__V w, MS_MCML__V u)
{
    const MS_MCML__V zero = MS_MCML__V_SET(0.0f), one = MS_MCML__V_SET(1.0f);
    const MS_MCML__V lost = MS_MCML__V_SELECT(hit, zero, w * MS_MCML__V_LOAD(t->absorbed));
    if (t->cells) {
        const MS_MCML__V r = MS_MCML__V_SQRT(MS_MCML__V_MADD(x, x, y * y)), slab = z + MS_MCML__V_LOAD(t->top);
        const MS_MCML__V ring = MS_MCML__V_MIN(r * t->inverse_dr, MS_MCML__V_SET(t->last_r));
        const MS_MCML__V column = MS_MCML__V_MIN(slab * t->inverse_dz, MS_MCML__V_SET(t->last_z));
        const MS_MCML__U row = MS_MCML__V_TO_INT(MS_MCML__V_MAX(ring, zero)) * t->nz;
        MS_MCML__U_STORE(t->cell, row + MS_MCML__V_TO_INT(MS_MCML__V_MAX(column, zero)));
        MS_MCML__V_STORE(t->units, MS_MCML__V_MADD(lost, MS_MCML__V_SET(ms_mcml__units), u));
    }
    w = w - lost;
    MS_MCML__V_STORE(t->kept, lost + MS_MCML__V_LOAD(t->kept));
    return MS_MCML__V_SELECT(
        MS_MCML__V_LESS(MS_MCML__V_SELECT(hit, one, w), MS_MCML__V_SET(t->low_weight)),
        MS_MCML__V_SELECT(MS_MCML__V_LESS(u, MS_MCML__V_SET(ms_mcml__chance)), w * (1 / ms_mcml__chance), zero), w);
}

/* A new direction where nothing was hit: Henyey-Greenstein, v = 2 xi - 1,
   1 - cos = (1 - g)^2 (1 - v) (2 + g + g v) / (2 (1 + g v)^2), 1 + cos the same with -g and -v;
   azimuth 2 pi tau, tau in [-1/2, 1/2), from sin and cos of pi tau; an orthonormal basis around u without a branch
   (Duff et al. 2017), and one Newton iteration to length 1. */
static inline void MS_MCML__FN(deflect)(MS_MCML__M hit, MS_MCML__V g, MS_MCML__U word_cosine, MS_MCML__U word_azimuth,
                                        MS_MCML__V *x, MS_MCML__V *y, MS_MCML__V *z)
{
    const MS_MCML__V one = MS_MCML__V_SET(1.0f), ux = *x, uy = *y, uz = *z, xi = MS_MCML__FN(uniform)(word_cosine);
    const MS_MCML__V gv = g * MS_MCML__V_MADD(MS_MCML__V_SET(2.0f), xi, MS_MCML__V_SET(-1.0f));
    const MS_MCML__V q = 1.0f / (1.0f + gv), middle = 2.0f + gv;
    const MS_MCML__V less = (1.0f - g) * q, more = (1.0f + g) * q;
    const MS_MCML__V below = less * less * (1.0f - xi) * (middle + g);
    const MS_MCML__V above = more * more * xi * (middle - g);
    const MS_MCML__V cosine = 1.0f - below, sine = MS_MCML__V_SQRT(below * above);
    const MS_MCML__V tau = MS_MCML__FN(uniform)(word_azimuth) - 0.5f, square = tau * tau;
    MS_MCML__V sh = MS_MCML__V_SET(0.0776594074f), ch = MS_MCML__V_SET(0.219696795f), sc, ss, sign, a, b, vx, vy, vz,
               scale;
    sh = MS_MCML__V_MADD(sh, square, MS_MCML__V_SET(-0.598292159f));
    sh = MS_MCML__V_MADD(sh, square, MS_MCML__V_SET(2.55007766f));
    sh = MS_MCML__V_MADD(sh, square, MS_MCML__V_SET(-5.16771009f));
    sh = MS_MCML__V_MADD(sh, square, MS_MCML__V_SET(3.14159264f)) * tau;
    ch = MS_MCML__V_MADD(ch, square, MS_MCML__V_SET(-1.33188016f));
    ch = MS_MCML__V_MADD(ch, square, MS_MCML__V_SET(4.05841191f));
    ch = MS_MCML__V_MADD(ch, square, MS_MCML__V_SET(-4.93479286f));
    ch = MS_MCML__V_MADD(ch, square, MS_MCML__V_SET(0.999999953f));
    sc = sine * MS_MCML__V_NMADD(sh + sh, sh, one);
    ss = sine * ((sh + sh) * ch);
    sign = MS_MCML__V_BITS((MS_MCML__U_BITS(uz) & 0x80000000u) | 0x3f800000u); /* 1 or -1 */
    a = -1.0f / (sign + uz);
    b = ux * uy * a;
    vx = MS_MCML__V_MADD(sc, MS_MCML__V_MADD(sign * ux, ux * a, one), MS_MCML__V_MADD(ss, b, cosine * ux));
    vy = MS_MCML__V_MADD(sc, sign * b, MS_MCML__V_MADD(ss, MS_MCML__V_MADD(uy * uy, a, sign), cosine * uy));
    vz = MS_MCML__V_NMADD(sc * sign, ux, MS_MCML__V_NMADD(ss, uy, cosine * uz));
    scale = MS_MCML__V_MADD(vx, vx, MS_MCML__V_MADD(vy, vy, vz * vz));
    scale = MS_MCML__V_NMADD(MS_MCML__V_SET(0.5f), scale, MS_MCML__V_SET(1.5f));
    *x = MS_MCML__V_SELECT(hit, ux, vx * scale);
    *y = MS_MCML__V_SELECT(hit, uy, vy * scale);
    *z = MS_MCML__V_SELECT(hit, uz, vz * scale);
}

/* Lanes that a boundary reflects, Fresnel, ratio = n / n beyond; total internal reflection has cos_t = 0 and so R = 1.
   u < R without division, R = (rs^2 + rp^2) / 2. */
static inline MS_MCML__M MS_MCML__FN(fresnel)(ms_mcml__tracer *t, MS_MCML__M up, MS_MCML__V steep, MS_MCML__V u)
{
    const MS_MCML__V zero = MS_MCML__V_SET(0.0f), one = MS_MCML__V_SET(1.0f);
    const MS_MCML__V ratio = MS_MCML__V_SELECT(up, MS_MCML__V_LOAD(t->ratio_up), MS_MCML__V_LOAD(t->ratio_down));
    const MS_MCML__V sin2_i = MS_MCML__V_MAX(MS_MCML__V_NMADD(steep, steep, one), zero);
    const MS_MCML__V cos_t = MS_MCML__V_SQRT(MS_MCML__V_MAX(MS_MCML__V_NMADD(ratio * ratio, sin2_i, one), zero));
    const MS_MCML__V si = ratio * steep, pt = ratio * cos_t;
    const MS_MCML__V s_sum = si + cos_t, p_sum = pt + steep, both = s_sum * p_sum;
    const MS_MCML__V rs = (si - cos_t) * p_sum, rp = (pt - steep) * s_sum;
    MS_MCML__V_STORE(t->cos_t, cos_t);
    return MS_MCML__V_LESS(u * (both * both), 0.5f * (rs * rs + rp * rp));
}

/* Traces the photons of t. A turn of the loop is one event of every lane: a flight that ends in a collision or at a
   boundary. Four words are drawn for each event, so that a photon's path does not depend on its neighbors. Crossing a
   boundary and ending go lane by lane. Absorption is added to its bins one turn late, when the units and the cell
   are long known: nothing waits for them. */
static void MS_MCML__FN(trace)(ms_mcml__tracer *t, int turns)
{
    const MS_MCML__V zero = MS_MCML__V_SET(0.0f);
    const unsigned all = (2u << (MS_MCML__L - 1)) - 1;
    MS_MCML__U s0, s1, s2, s3;
    int i;

    if (!t->alive) { /* the first call */
        for (i = 0; i < MS_MCML__L; ++i) t->bit[i] = 1u << i;
        t->alive = all;
        t->fresh_at = MS_MCML__L;
        MS_MCML__FN(launch)(t, all);
    }
    s0 = MS_MCML__U_LOAD(t->s[0]);
    s1 = MS_MCML__U_LOAD(t->s[1]);
    s2 = MS_MCML__U_LOAD(t->s[2]);
    s3 = MS_MCML__U_LOAD(t->s[3]);
    for (; t->alive && turns > 0; --turns) {
        MS_MCML__U word_flight, word_cosine, word_azimuth, word_chance, events;
        MS_MCML__V x = MS_MCML__V_LOAD(t->x), y = MS_MCML__V_LOAD(t->y), z = MS_MCML__V_LOAD(t->z);
        MS_MCML__V ux = MS_MCML__V_LOAD(t->ux), uy = MS_MCML__V_LOAD(t->uy), uz = MS_MCML__V_LOAD(t->uz);
        MS_MCML__V w = MS_MCML__V_LOAD(t->w), u, flight, steep, gap, path;
        const MS_MCML__V depth = MS_MCML__V_LOAD(t->depth), mfp = MS_MCML__V_LOAD(t->mfp);
        unsigned boundary, crossing = 0, ended, pausing, finished = 0;
        MS_MCML__M hit, up;

        /* The absorption of the turn before, and this turn's random words. */
        for (i = 0; t->cells && i < MS_MCML__L; ++i) t->cells[t->cell[i]] += (int64_t)t->units[i];
        MS_MCML__DRAW(word_flight);
        MS_MCML__DRAW(word_cosine);
        MS_MCML__DRAW(word_azimuth);
        MS_MCML__DRAW(word_chance);
        u = MS_MCML__FN(uniform)(word_chance);

        /* -log(u) mean free paths to the collision, or gap / |uz| to the boundary if that is nearer. A flight has at
           least half the smallest -log u that is not 0. */
        flight = MS_MCML__V_MAX(MS_MCML__FN(exponential)(word_flight), MS_MCML__V_SET(3e-8f)) * mfp;
        up = MS_MCML__V_LESS(uz, zero);
        gap = MS_MCML__V_MAX(MS_MCML__V_SELECT(up, z, depth - z), zero);
        steep = MS_MCML__V_MAX(MS_MCML__V_BITS(MS_MCML__U_BITS(uz) & 0x7fffffffu), MS_MCML__V_SET(1e-9f));
        hit = MS_MCML__V_LESS(gap, flight * steep);
        boundary = MS_MCML__M_BITS(hit) & t->alive;
        path = MS_MCML__V_SELECT(hit, gap / steep, flight);
        x = MS_MCML__V_MADD(path, ux, x);
        y = MS_MCML__V_MADD(path, uy, y);
        z = MS_MCML__V_SELECT(hit, MS_MCML__V_SELECT(up, zero, depth), MS_MCML__V_MADD(path, uz, z));

        /* A collision absorbs and deflects; a boundary reflects with R, turning uz, or lets pass. */
        if (MS_MCML__M_BITS(hit) == all) {
            MS_MCML__V_STORE(t->units, zero);
        } else {
            w = MS_MCML__FN(absorb)(t, hit, x, y, z, w, u);
            MS_MCML__FN(deflect)(hit, MS_MCML__V_LOAD(t->g), word_cosine, word_azimuth, &ux, &uy, &uz);
        }
        if (boundary) {
            const MS_MCML__M back = MS_MCML__FN(fresnel)(t, up, steep, u);
            uz = MS_MCML__V_SELECT(hit, MS_MCML__V_SELECT(back, zero - uz, uz), uz);
            crossing = boundary & ~MS_MCML__M_BITS(back);
        }

        /* Whose turn is not over: crossing lanes, those whose weight is 0, those at a multiple of 4096 events. */
        MS_MCML__V_STORE(t->x, x);
        MS_MCML__V_STORE(t->y, y);
        MS_MCML__V_STORE(t->z, z);
        MS_MCML__V_STORE(t->ux, ux);
        MS_MCML__V_STORE(t->uy, uy);
        MS_MCML__V_STORE(t->uz, uz);
        MS_MCML__V_STORE(t->w, w);
        events = MS_MCML__U_LOAD(t->events) + 1u;
        MS_MCML__U_STORE(t->events, events);
        ended = t->alive & ~(t->alive & MS_MCML__M_BITS(MS_MCML__V_LESS(zero, w)));
        pausing = t->alive & MS_MCML__M_BITS(MS_MCML__U_IS_ZERO(events & (MS_MCML__HALVING_EVENTS - 1u)));
        if (!(crossing | ended | pausing)) continue;

        /* Lane by lane: into the neighboring layer or out; weight doubled or 0; the rest of `kept` into the sums. */
        MS_MCML__U_STORE(t->word, word_chance);
        for (; crossing; crossing &= crossing - 1) {
            i = ms_mcml__lowest(crossing);
            if (ms_mcml__cross(t, i)) finished |= 1u << i;
        }
        for (pausing &= ~(finished | ended); pausing; pausing &= pausing - 1) {
            i = ms_mcml__lowest(pausing);
            ms_mcml__add_absorbed(t, i); /* before a float loses what a collision adds to it */
            t->kept[i] = 0;
            if (t->events[i] != t->limit[i]) continue;
            t->limit[i] *= 4;
            t->w[i] *= (t->word[i] & 128) ? 2.0f : 0.0f;
            if (!(t->w[i] > 0)) ended |= 1u << i;
        }
        for (ended &= ~finished, finished |= ended; ended; ended &= ended - 1)
            ms_mcml__add_absorbed(t, ms_mcml__lowest(ended));
        if (!finished) continue;

        /* New photons, whose random states pass through memory, where the others' are. */
        MS_MCML__U_STORE(t->s[0], s0);
        MS_MCML__U_STORE(t->s[1], s1);
        MS_MCML__U_STORE(t->s[2], s2);
        MS_MCML__U_STORE(t->s[3], s3);
        MS_MCML__FN(launch)(t, finished);
        s0 = MS_MCML__U_LOAD(t->s[0]);
        s1 = MS_MCML__U_LOAD(t->s[1]);
        s2 = MS_MCML__U_LOAD(t->s[2]);
        s3 = MS_MCML__U_LOAD(t->s[3]);
    }
    MS_MCML__U_STORE(t->s[0], s0);
    MS_MCML__U_STORE(t->s[1], s1);
    MS_MCML__U_STORE(t->s[2], s2);
    MS_MCML__U_STORE(t->s[3], s3);
    for (i = 0; t->cells && !t->alive && i < MS_MCML__L; ++i) t->cells[t->cell[i]] += (int64_t)t->units[i];
#if MS_MCML__ISA >= 3
    _mm256_zeroupper(); /* GCC leaves it out here, which slows down what follows */
#endif
}

#undef MS_MCML__DRAW
#undef MS_MCML__EVEN
#undef MS_MCML__ISA
#undef MS_MCML__L
#undef MS_MCML__LEVEL
#undef MS_MCML__M
#undef MS_MCML__MM
#undef MS_MCML__MM_INT
#undef MS_MCML__M_BITS
#undef MS_MCML__U
#undef MS_MCML__U_BITS
#undef MS_MCML__U_HIGH
#undef MS_MCML__U_IS_ZERO
#undef MS_MCML__U_LOAD
#undef MS_MCML__U_STORE
#undef MS_MCML__V
#undef MS_MCML__VECTOR
#undef MS_MCML__V_BITS
#undef MS_MCML__V_FROM_INT
#undef MS_MCML__V_LESS
#undef MS_MCML__V_LOAD
#undef MS_MCML__V_MADD
#undef MS_MCML__V_MAX
#undef MS_MCML__V_MIN
#undef MS_MCML__V_NMADD
#undef MS_MCML__V_SELECT
#undef MS_MCML__V_SET
#undef MS_MCML__V_SQRT
#undef MS_MCML__V_STORE
#undef MS_MCML__V_TO_INT
#undef MS_MCML__W
#endif /* kernels */

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
