/* ms_mcml.h - v0.2.0 - photon transport in layered media - MIT or public domain, see the end

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
     a diffusion profile for rendering (half-space)          ms_mcml_profile_make: no noise, milliseconds at g = 0
     a picked color and a path length to a medium            ms_mcml_medium_from_color
     a diffusion profile of layers                           ms_mcml_profile_layers
     skin of melanin and blood to profiles and colors        examples/tools/skin.h
     layers, g: totals, rings, depth without noise           ms_mcml_layered_solve
     layers, g, glass, absorption, angles                    ms_mcml_simulate, or for jobs that are split:
                                                             ms_mcml_create, _run, _save, _load, _merge, _results
     .mci and .mco files of MCML 1.2, finite beams           examples/tools/mci.h

   Monte Carlo
   -----------
   As MCML (Wang, Jacques, Zheng 1995) in packets of 4, 8 or 16 photons: absorption by weight, Henyey-Greenstein
   scattering, Fresnel boundaries, roulette. Time grows with the collisions of a photon; RESULTS.md has times beside
   MCML's. Roulette starts at 0.01 times the least albedo, MCML's at 1e-4. From event 4096 on, and at every fourfold
   count, half of the photons end and the weight of the others doubles, so that media without absorption end, too.
   Clear layers on top are part of the surface: their reflection is specular.

   Layers without noise
   --------------------
   ms_mcml_layered_solve takes up to 16 layers and gives R and T over radius, totals and depth. For each spatial
   frequency it solves for source moments on panels in depth, by exact ray sweeps through all layers (Fresnel at each
   boundary) and GMRES. Single scattering of the top layer is computed in space with the whole phase function. Time
   grows with optical depth and with the order, which g determines: 3 moments at 0.3, 9 at 0.8, 19 at 0.9. Totals are
   the limit of three orders. Each ring has an error, estimated from half the order, twice the frequency step and
   another end of the spectrum. Where it exceeds 3%, beside clear layers and for g near 1, rings come from Monte Carlo
   with standard errors, and the solution says so. RESULTS.md compares 300 random media with Monte Carlo.

   Diffusion profiles
   ------------------
   ms_mcml_profile_make turns media into R_d(r): averages over rings, and the energy within each edge. At g = 0 the
   half-space solver computes them by Galerkin's method in depth for each spatial frequency; the spectrum becomes a sum
   of terms with positive energies, whose rings have closed forms. At the default steps totals are good to 5e-13 and
   rings with 1e-5 of the energy to 8e-5. Media with other g take the layered solver: 0.1 to 1 s a channel.

   Memory, threads, SIMD, determinism, errors
   ------------------------------------------
   Monte Carlo: one block a tally, one a result; options.parallel cuts every 65536 photons into 16 tasks with a tally
   each. Layered solver: 5 to 100 MB while it runs, on one thread; half-space solver: 0.3 MB a channel that runs. Stack:
   less than 40 KB. Calls without a common object may overlap.
   Results have the same bits for any thread count. Photon i draws from (seed, i) and sums are integers, so that any
   split of the photons gives the same bits at one level of instruction sets. -ffast-math voids what is said of bits,
   NaN and infinity. Calls return a status and, where asked for, a sentence. On failure outputs are untouched.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_DEF            linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_MCML_FILENAME  this file's name, if it is not "ms_mcml.h"
   MS_NO_SIMD        scalar text only (as Microsoft's cl compiles it)
   MS_ASSERT         checks of the header's own invariants (nothing)

   Limits
   ------
   2^32 photons a tally; 32767 layers; n 0.01 to 100; mu up to 1e9 per cm; -1 < g <= 1; fewer than 2^31 cells. A pencil
   beam at normal incidence; flat layers; unpolarized light. Layered solver: 16 layers; totals of g above 0.99 or below
   -0.9 to less than 5e-5.

   Sources
   -------
   Wang, Jacques, Zheng 1995 (MCML) and 1997 (CONV); Blackman, Vigna 2018 (xoshiro128+, seeded by Philox); Duff et al.
   2017 (basis); Williams, "The searchlight problem in radiative transfer with internal reflection" (2007) for the
   equation; Case & Zweifel, "Linear Transport Theory" (1967) for nu_0; Lawson & Hanson, "Solving Least Squares
   Problems" (1974); Chandrasekhar, "Radiative Transfer" (1960) for the test's reference; Jensen et al. 2001 for the
   materials.
*/
#ifndef MS_MCML_H
#define MS_MCML_H
#include <stddef.h>
#include <stdint.h>

#define MS_MCML_VERSION_MAJOR 0
#define MS_MCML_VERSION_MINOR 2
#define MS_MCML_VERSION_PATCH 0
#define MS_MCML_VERSION 200 /* major * 10000 + minor * 100 + patch */
#define MS_MCML_VERSION_STRING "0.2.0"

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
    double g;            /* mean cosine of Henyey-Greenstein scattering, -1 < g <= 1 */
    double thickness_cm; /* > 0 */
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
    double dr_cm, dz_cm; /* > 0 */
    int nr, nz, na;      /* >= 1 */
} ms_mcml_grid;

/* All zero: the defaults. */
typedef struct ms_mcml_options {
    uint64_t photons; /* that ms_mcml_simulate runs; 0: 1000000; at most 2^32 in one tally */
    uint64_t seed;
    double roulette_weight; /* photons of less weight play roulette, at most 1; 0: 0.01 times the least albedo of a
                               layer that scatters, but at least MCML's 1e-4 */
    int no_absorption;      /* not 0: neither A_rz nor A_z, which saves time and memory; A_l remains */
    size_t memory_limit;    /* bytes that tallies may take; 0: 4 GiB */
    ms_simd simd;           /* a cap */
    ms_parallel parallel;   /* at most 16 tasks, each with its own tally */
    ms_progress progress;   /* called after every 65536 photons */
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
   Memory: 16 bytes for each of 2 nr na bins, 8 for each of nr nz bins; times 17 with options->parallel. */
MS_API ms_status ms_mcml_create(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_mcml_options *options,
                                ms_mcml **out, ms_error *error);

/* NULL is fine. */
MS_API void ms_mcml_destroy(ms_mcml *tally);

/* Adds the photons first to first + count - 1 of the seed. Never run a photon twice.
   MS_INVALID_ARGUMENT: more than 2^32 photons in the tally. MS_CANCELLED: the photons up to some multiple of 65536
   after first are in it, see ms_mcml_photons. MS_OUT_OF_MEMORY: nothing was added. */
MS_API ms_status ms_mcml_run(ms_mcml *tally, uint64_t first, uint64_t count, ms_error *error);

/* Adds the photons of other, which has the same tissue, grid, seed and options. MS_INVALID_ARGUMENT if it differs. */
MS_API ms_status ms_mcml_merge(ms_mcml *tally, const ms_mcml *other, ms_error *error);

/* Photons in the tally. */
MS_API uint64_t ms_mcml_photons(const ms_mcml *tally);

/* A tally as bytes, for other processes and machines: tissue, grid, options and sums, little-endian.
   ms_mcml_save writes ms_mcml_save_size bytes. ms_mcml_load makes a tally that equals the one saved, with memory and
   threads of `options` (NULL: the defaults; only allocator, parallel, progress, simd and memory_limit are read).
   MS_BAD_DATA: not such bytes (position: offset). */
MS_API size_t ms_mcml_save_size(const ms_mcml *tally);
MS_API void ms_mcml_save(const ms_mcml *tally, void *bytes);
MS_API ms_status ms_mcml_load(const void *bytes, size_t size, const ms_mcml_options *options, ms_mcml **out,
                              ms_error *error);

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
    double mu_s_per_mm; /* scattering, >= 0; mu_a + mu_s > 0 */
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
    MS_MCML_BURLEY_D =
        1, /* reduced path / (1.85 - A + 7 |A - 0.8|^3): d of ms_sss_profile_from_burley, HDRP's distance */
    MS_MCML_DIFFUSE_PATH = 2 /* d (3.5 + 100 (A - 0.33)^4): Unreal's diffuse mean free path */
} ms_mcml_length;

/* The medium of isotropic scattering (g = 0) that has this color and this length. Its profile is that of the medium,
   not Burley's curve.
   color      0 to 1, linear: the part of the entering light that comes out again (a renderer's albedo beside a
              specular lobe); the medium gives it back to 1e-7
   length_mm  > 0; kind: an ms_mcml_length; eta: 0.1 to 10
   MS_INVALID_ARGUMENT: out of these ranges, *medium is untouched. No memory. Example, a skin in Unreal's terms:

      for (c = 0; c < 3; ++c) ms_mcml_medium_from_color(color[c], path_mm[c], MS_MCML_DIFFUSE_PATH, 1.4, &medium[c],
   NULL); ms_mcml_profile_make(&profile, medium, 3, NULL, NULL); */
MS_API ms_status ms_mcml_medium_from_color(double color, double length_mm, int kind, double eta, ms_mcml_medium *medium,
                                           ms_error *error);

/* ---- layered solver -------------------------------------------------------------------------------------------- */

#define MS_MCML_LAYERED_RATES 96
#define MS_MCML_LAYERED_SINGLES 40
#define MS_MCML_LAYERED_RADII 200

/* All zero: the defaults. */
typedef struct ms_mcml_layered_options {
    int totals_only; /* not 0: no rings, only what does not depend on r: one frequency instead of some 30 */
    double dz_cm;    /* > 0 with a_z */
    int nz;
    double *a_z;      /* [nz] out: absorbed between i dz and (i + 1) dz, 1/cm; or NULL */
    double *a_l;      /* [layer_count] out: part absorbed in each layer; or NULL */
    uint64_t photons; /* of Monte Carlo where the solver's rings are not good enough; 0: 1000000 */
    ms_progress progress;
    ms_allocator allocator;
    ms_simd simd; /* a cap; levels round differently, to 1e-12 of the totals */
} ms_mcml_layered_options;

/* Light that leaves one surface, over radius; read it with ms_mcml_layered_outside and _ring. */
typedef struct ms_mcml_layered_side {
    uint64_t photons; /* 0: by the solver; else by so many photons */
    double radius_cm, last_per_cm, multiple, remainder, tail_cm, tail, decay_per_cm;
    double energy[MS_MCML_LAYERED_RATES], outside[MS_MCML_LAYERED_RADII], error[MS_MCML_LAYERED_RADII];
} ms_mcml_layered_side;

/* Reflectance and transmittance of layers under a pencil beam at normal incidence. A plain value: copy it freely.
   Totals count as MCML counts: specular is what the surface (and clear layers on top) reflects at entry; rd and tt
   include unscattered light. rd_error, tt_error: of the limit of three orders, whose errors alternate. The fields from
   `order` on belong to the solver:

     energy beyond r    sum single max(0, exp(-single_rate r) - single_end) + sum energy (rate r) K1(rate r)
                        + side.outside[] at side.radius_cm exp(0.1 i) */
typedef struct ms_mcml_layered {
    double specular, rd, rd_error, tt, tt_error, a, rd_unscattered, tt_unscattered;
    ms_mcml_layered_side side[2]; /* top, bottom */
    int order, rates, singles;
    double residual, forward_fraction, mu_t_per_cm, rate_per_cm[MS_MCML_LAYERED_RATES];
    double single_rate_per_cm[MS_MCML_LAYERED_SINGLES], single_energy[MS_MCML_LAYERED_SINGLES],
        single_end[MS_MCML_LAYERED_SINGLES];
} ms_mcml_layered;

/* Solves the layers: 1 to 16 of them, any absorption and scattering. thickness_cm x effective attenuation above 23
   counts as infinite. options may be NULL. Rings of a side whose total is above 1e-3 come from Monte Carlo, scaled to
   the solver's total, beside a clear layer, for g above 0.96, or where the estimated error exceeds 3% in a ring with
   1e-3 of the side's energy; side[].photons says so, and the errors are standard errors then.
   MS_NOT_CONVERGED: *out is filled, but rd_error or tt_error is above 5e-5. MS_INVALID_ARGUMENT, MS_UNSUPPORTED (more
   than 16 layers), MS_OUT_OF_MEMORY, MS_CANCELLED: *out untouched. */
MS_API ms_status ms_mcml_layered_solve(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *options,
                                       ms_mcml_layered *out, ms_error *error);

/* outside: energy that leaves at the top (side 0) or the bottom (side 1) farther than r_cm >= 0 from the beam;
   unscattered light leaves at 0. ring: mean over r0_cm <= r < r1_cm in 1/cm^2, not negative; *ring_error (may be NULL)
   gets its estimated or standard error. NaN outside these ranges. */
MS_API double ms_mcml_layered_outside(const ms_mcml_layered *solution, int side, double r_cm);
MS_API double ms_mcml_layered_ring(const ms_mcml_layered *solution, int side, double r0_cm, double r1_cm,
                                   double *ring_error);

/* ---- diffusion profiles ---------------------------------------------------------------------------------------- */

typedef struct ms_mcml_profile_options {
    const double *edge_mm; /* [rings + 1] increasing, from >= 0; NULL: rings of equal width ring_mm from 0 */
    int rings;             /* 0 (with edge_mm NULL, ring_mm 0): rings that suit the media, see ms_mcml_profile */
    double ring_mm;
    double depth_step;     /* half-space solver: log spacing of the exponentials in depth, 0.28 to 1; 0: 0.3 */
    double frequency_step; /* log spacing of the spatial frequencies, 0.2 to 1; 0: 0.25; see RESULTS.md */
    ms_simd simd;
    ms_parallel parallel;
    ms_allocator allocator;
} ms_mcml_profile_options;

/* Diffuse reflectance of `channels` half-spaces over common rings, per incident energy, specular reflection excluded.
   Arrays belong to the profile. Row c of an array [channels][n] starts at element c * n. */
typedef struct ms_mcml_profile {
    int channels, rings;
    double *edge_mm;          /* [rings + 1] */
    double *rd_per_mm2;       /* [channels][rings] mean over each ring */
    double *rd_error_per_mm2; /* [channels][rings] standard error, or the layered solver's; zeros from the half-space
                                 solver */
    double *within;           /* [channels][rings + 1] energy that leaves nearer than the edge */
    double *total;            /* [channels] of all that leaves */
    double *total_error;      /* [channels] */
    void *memory;
    size_t memory_size;
    ms_allocator allocator;
} ms_mcml_profile;

/* The profile of media[0 .. channels - 1], or of the layers tissues[0 .. channels - 1]; release it with
   ms_mcml_profile_destroy. options may be NULL. Rings that the options do not give are a twentieth of the shortest mean
   free path wide up to that path, then each 4% wider, out to where every channel has 1e-5 of its energy left.
   MS_NOT_CONVERGED: the layered solver says so of a channel; the profile is there, with its errors.
   MS_INVALID_ARGUMENT, MS_UNSUPPORTED (more than 16 layers), MS_OUT_OF_MEMORY: *profile is zeroed. */
MS_API ms_status ms_mcml_profile_make(ms_mcml_profile *profile, const ms_mcml_medium *media, int channels,
                                      const ms_mcml_profile_options *options, ms_error *error);
MS_API ms_status ms_mcml_profile_layers(ms_mcml_profile *profile, const ms_mcml_tissue *tissues, int channels,
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

static double ms_mcml__nan(void)
{
    const uint64_t bits = 0x7ff8000000000000u;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static int ms_mcml__between(double x, double low, double high) { return ms__finite(x) && x >= low && x <= high; }

static ms_status ms_mcml__check_layer(const ms_mcml_layer *l, size_t position, ms_error *error)
{
    if (!ms_mcml__between(l->n, 0.01, 100))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "refractive index n is %g, expected 0.01 to 100", l->n);
    if (!ms_mcml__between(l->mu_a_per_cm, 0, 1e9))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "mu_a is %g, expected 0 to 1e9 per cm", l->mu_a_per_cm);
    if (!ms_mcml__between(l->mu_s_per_cm, 0, 1e9))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "mu_s is %g, expected 0 to 1e9 per cm", l->mu_s_per_cm);
    if (!ms_mcml__between(l->g, -1, 1) || (l->g <= -1 && l->mu_s_per_cm > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "g is %g, expected above -1 and at most 1", l->g);
    if (!ms__finite(l->thickness_cm) || !(l->thickness_cm > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, position, "thickness is %g, expected above 0", l->thickness_cm);
    return MS_OK;
}

static ms_status ms_mcml__check_grid(const ms_mcml_grid *grid, ms_error *error)
{
    if (!ms_mcml__between(grid->dr_cm, 1e-30, 1e30) || !ms_mcml__between(grid->dz_cm, 1e-30, 1e30))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "dz and dr are %g and %g cm, expected above 0", grid->dz_cm,
                        grid->dr_cm);
    if (grid->nz < 1 || grid->nr < 1 || grid->na < 1)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nz, nr, na are %d, %d, %d, expected 1 or more", grid->nz,
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
    MS_MCML__STRETCH = 65536, /* photons between two calls of the progress callback */
    MS_MCML__TASKS = 16,
    MS_MCML__LANES_MAX = 16,
    MS_MCML__TALLY_WORDS = 11, /* of the head of a saved tally */
    MS_MCML__TALLY_HEAD = 16 + 8 * MS_MCML__TALLY_WORDS,
    MS_MCML__LAYER_BYTES = 5 * 8
};

/* A layer as the kernel reads it. */
typedef struct ms_mcml__slab {
    float depth;                   /* thickness */
    float top;                     /* z of its upper side */
    float mfp;                     /* 1 / (mu_a + mu_s); clear: beyond every boundary */
    float absorbed;                /* mu_a / (mu_a + mu_s) */
    float g, ratio_up, ratio_down; /* ratio: n over n of the neighbor */
    int clear;
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

/* The functions that are compiled for each level. */
struct ms_mcml__sweeps;
typedef struct ms_mcml__kernels {
    void (*trace)(ms_mcml__tracer *t);
    /* One sweep of all rays: out = the moments of the light that the sources d (NULL: none) and, if beam, the first
       scattering of the beam send out; leave: the parts that leave at the top and the bottom. */
    void (*sweep)(const struct ms_mcml__sweeps *s, const double *d, int beam, double *out, double leave[2]);
    void (*panel_weights)(double mu_t, const double *h, const double *wave, const double *polynomial,
                          const double *series, double *out);
    double (*inner)(const double *a, const double *b, size_t n); /* n: a multiple of 8 */
    void (*add)(double *to, double x, const double *a, size_t n);
} ms_mcml__kernels;
static const ms_mcml__kernels *ms_mcml__kernels_of(ms_simd level); /* after the kernels */

/* The photons first to end - 1 into sum. */
static void ms_mcml__trace(const ms_mcml *m, int64_t *sum, uint64_t first, uint64_t end)
{
    ms_mcml__tracer t;
    uint64_t i, next;
    for (i = first; i < end; i = next) { /* photons of each group */
        next = (i / MS_MCML__BLOCK + 1) * MS_MCML__BLOCK;
        if (next > end) next = end;
        sum[m->at.photons + (size_t)(i / MS_MCML__BLOCK % MS_MCML__GROUPS)] += (int64_t)(next - i);
    }
    if (m->first_layer == m->tissue.layer_count) { /* clear: all that enters leaves at the bottom, at r = 0 */
        const int64_t all = (int64_t)((end - first) << 30);
        int64_t *bin = sum + m->at.leave + 2 * (size_t)m->grid.nr * (size_t)m->grid.na;
        bin[0] += all;
        bin[1] += all;
        sum[m->at.unscattered + 1] += all;
        return;
    }
    memset(&t, 0, sizeof t);
    t.tally = m;
    t.low_weight = (float)m->options.roulette_weight;
    t.inverse_dr = (float)(1 / m->grid.dr_cm);
    t.inverse_dz = (float)(1 / m->grid.dz_cm);
    t.last_r = (float)(m->grid.nr - 1);
    t.last_z = (float)(m->grid.nz - 1);
    t.nz = (uint32_t)m->grid.nz;
    t.sum = sum;
    t.cells = m->options.no_absorption ? NULL : sum + m->at.a;
    t.next = first;
    t.end = end;
    ms_mcml__kernels_of(m->simd)->trace(&t);
}

/* Fresnel reflectance from n1 to n2 for nu = n sin(theta); 1 for total reflection. */
static double ms_mcml__fresnel_nu(double n1, double n2, double nu)
{
    double a, b, s, p;
    if (!(nu < n1) || !(nu < n2)) return 1;
    a = sqrt((n1 - nu) * (n1 + nu)) / n1;
    b = sqrt((n2 - nu) * (n2 + nu)) / n2;
    s = (n1 * a - n2 * b) / (n1 * a + n2 * b);
    p = (n1 * b - n2 * a) / (n1 * b + n2 * a);
    return 0.5 * (s * s + p * p);
}

/* Reflectance at normal incidence of the boundaries from above the tissue to the first layer that is not clear, with
   all reflections between them: R = (r + s - 2 r s) / (1 - r s), boundary by boundary. */
static double ms_mcml__specular(const ms_mcml_tissue *tissue, int first_layer)
{
    double reflectance = 0, n = tissue->n_above;
    int i;
    for (i = 0; i <= first_layer; ++i) {
        const double below = i < tissue->layer_count ? tissue->layers[i].n : tissue->n_below;
        const double s = ms_mcml__fresnel_nu(n, below, 0);
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
        const double mu_s = layer[i].g < 1 ? layer[i].mu_s_per_cm : 0, mu_t = layer[i].mu_a_per_cm + mu_s;
        const double above = i > 0 ? layer[i - 1].n : m->tissue.n_above;
        const double below = i + 1 < m->tissue.layer_count ? layer[i + 1].n : m->tissue.n_below;
        ms_mcml__slab *slab = &m->slab[i];
        slab->clear = !(mu_t > 0);
        slab->depth = (float)(layer[i].thickness_cm < 1e12 ? layer[i].thickness_cm : 1e12);
        slab->top = (float)top;
        slab->mfp = slab->clear ? 1e30f : (float)(mu_t > 1e-12 ? 1 / mu_t : 1e12);
        slab->absorbed = slab->clear ? 0.0f : (float)(layer[i].mu_a_per_cm / mu_t);
        slab->g = mu_s > 0 ? (float)layer[i].g : 0.0f;
        slab->ratio_up = (float)(layer[i].n / above);
        slab->ratio_down = (float)(layer[i].n / below);
        if (!slab->clear && i < m->first_layer) m->first_layer = i;
        if (mu_s > 0 && mu_s < albedo * mu_t) albedo = mu_s / mu_t;
        top += layer[i].thickness_cm;
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
    all = o.parallel.run ? ms__size_mul(size, MS_MCML__TASKS + 1) : size;
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

/* Sums are added as unsigned numbers: exact, in any order, and defined for any bytes that ms_mcml_load was given. */
static void ms_mcml__add(int64_t *sum, const int64_t *other, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) sum[i] = (int64_t)((uint64_t)sum[i] + (uint64_t)other[i]);
}

typedef struct ms_mcml__trace_job {
    const ms_mcml *tally;
    int64_t *sums; /* [TASKS][count] */
    uint64_t first, count;
} ms_mcml__trace_job;

static void ms_mcml__trace_task(void *context, int index)
{
    const ms_mcml__trace_job *wave = (const ms_mcml__trace_job *)context;
    const uint64_t i = (uint64_t)index;
    ms_mcml__trace(wave->tally, wave->sums + (size_t)index * wave->tally->at.count,
                   wave->first + wave->count * i / MS_MCML__TASKS,
                   wave->first + wave->count * (i + 1) / MS_MCML__TASKS);
}

MS_API ms_status ms_mcml_run(ms_mcml *m, uint64_t first, uint64_t count, ms_error *error)
{
    const int parallel = m && m->options.parallel.run != NULL;
    const size_t size = parallel ? ms__size_mul(m->at.count, MS_MCML__TASKS * sizeof(int64_t)) : 0;
    const uint64_t end = first + count;
    const ms_progress *progress;
    ms_status status = MS_OK;
    ms_mcml__trace_job wave;
    int i;
    if (m == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tally is NULL");
    if (count > ms_mcml__photons_max || m->photons > ms_mcml__photons_max - count)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "more than 2^32 photons in one tally");
    if (end < first) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the last photon's index is above 2^64");
    progress = &m->options.progress;
    wave.tally = m;
    wave.sums = NULL;
    if (parallel) {
        wave.sums = (int64_t *)ms__alloc(&m->options.allocator, size);
        if (wave.sums == NULL)
            return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the tallies of the tasks", size);
        memset(wave.sums, 0, size);
    }
    for (wave.first = first; wave.first < end; wave.first += wave.count) {
        wave.count = MS_MCML__STRETCH - wave.first % MS_MCML__STRETCH;
        if (wave.count > end - wave.first) wave.count = end - wave.first;
        if (progress->report && progress->report(progress->user, (double)(wave.first - first) / (double)count)) {
            status = ms__fail(error, MS_CANCELLED, 0, "stopped by the progress callback");
            break;
        }
        if (parallel) ms__run(&m->options.parallel, MS_MCML__TASKS, ms_mcml__trace_task, &wave);
        else ms_mcml__trace(m, m->sum, wave.first, wave.first + wave.count);
        m->photons += wave.count;
    }
    for (i = 0; parallel && i < MS_MCML__TASKS; ++i)
        ms_mcml__add(m->sum, wave.sums + (size_t)i * m->at.count, m->at.count);
    ms__release(&m->options.allocator, wave.sums, size);
    return status;
}

static uint64_t ms_mcml__real_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static double ms_mcml__bits_real(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint8_t *ms_mcml__put(uint8_t *p, uint64_t value)
{
    int i;
    for (i = 0; i < 8; ++i) *p++ = (uint8_t)(value >> (8 * i));
    return p;
}

static uint64_t ms_mcml__get(const uint8_t *p)
{
    uint64_t value = 0;
    int i;
    for (i = 7; i >= 0; --i) value = value << 8 | p[i];
    return value;
}

/* A saved tally: 16 characters, these words, five reals a layer, the sums. Tallies merge if all words but the first and
   the layers are equal. */
static const char ms_mcml__magic[17] = "ms_mcml tally 3\n";

static void ms_mcml__tally_words(const ms_mcml *m, uint64_t word[MS_MCML__TALLY_WORDS])
{
    word[0] = m->photons;
    word[1] = m->options.seed;
    word[2] = ms_mcml__real_bits(m->options.roulette_weight);
    word[3] = m->options.no_absorption != 0;
    word[4] = ms_mcml__real_bits(m->grid.dr_cm);
    word[5] = ms_mcml__real_bits(m->grid.dz_cm);
    word[6] = (uint64_t)m->grid.nr | (uint64_t)m->grid.nz << 32;
    word[7] = (uint64_t)m->grid.na;
    word[8] = ms_mcml__real_bits(m->tissue.n_above);
    word[9] = ms_mcml__real_bits(m->tissue.n_below);
    word[10] = (uint64_t)m->tissue.layer_count;
}

MS_API ms_status ms_mcml_merge(ms_mcml *tally, const ms_mcml *other, ms_error *error)
{
    uint64_t a[MS_MCML__TALLY_WORDS], b[MS_MCML__TALLY_WORDS];
    if (tally == NULL || other == NULL || tally == other)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "two different tallies are expected");
    if (other->photons > ms_mcml__photons_max - tally->photons)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "more than 2^32 photons in one tally");
    ms_mcml__tally_words(tally, a);
    ms_mcml__tally_words(other, b);
    if (memcmp(a + 1, b + 1, sizeof a - sizeof a[0]) != 0 ||
        memcmp(tally->tissue.layers, other->tissue.layers, (size_t)tally->tissue.layer_count * sizeof(ms_mcml_layer)))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the tallies have different seeds, tissues, grids or options");
    ms_mcml__add(tally->sum, other->sum, tally->at.count);
    tally->photons += other->photons;
    return MS_OK;
}

MS_API size_t ms_mcml_save_size(const ms_mcml *tally)
{
    if (tally == NULL) return 0;
    return MS_MCML__TALLY_HEAD + (size_t)tally->tissue.layer_count * MS_MCML__LAYER_BYTES + tally->at.count * 8;
}

MS_API void ms_mcml_save(const ms_mcml *tally, void *bytes)
{
    uint64_t word[MS_MCML__TALLY_WORDS];
    uint8_t *p = (uint8_t *)bytes;
    size_t i;
    int layer;
    if (tally == NULL || bytes == NULL) return;
    ms_mcml__tally_words(tally, word);
    memcpy(p, ms_mcml__magic, 16);
    for (p += 16, i = 0; i < MS_MCML__TALLY_WORDS; ++i) p = ms_mcml__put(p, word[i]);
    for (layer = 0; layer < tally->tissue.layer_count; ++layer) {
        const ms_mcml_layer *l = &tally->tissue.layers[layer];
        p = ms_mcml__put(p, ms_mcml__real_bits(l->n));
        p = ms_mcml__put(p, ms_mcml__real_bits(l->mu_a_per_cm));
        p = ms_mcml__put(p, ms_mcml__real_bits(l->mu_s_per_cm));
        p = ms_mcml__put(p, ms_mcml__real_bits(l->g));
        p = ms_mcml__put(p, ms_mcml__real_bits(l->thickness_cm));
    }
    for (i = 0; i < tally->at.count; ++i) p = ms_mcml__put(p, (uint64_t)tally->sum[i]);
}

/* Layers and sums of a saved tally whose head, at least, is whole. */
static ms_status ms_mcml__load_rest(const uint8_t *p, const ms_mcml_tissue *head, const ms_mcml_grid *grid,
                                    const ms_mcml_options *o, uint64_t photons, ms_mcml **out, ms_error *error)
{
    const size_t bytes = (size_t)head->layer_count * sizeof(ms_mcml_layer);
    ms_mcml_layer *layers = (ms_mcml_layer *)ms__alloc(&o->allocator, bytes);
    ms_mcml_tissue tissue = *head;
    ms_mcml *m = NULL;
    ms_status status;
    size_t i;
    if (layers == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d layers", tissue.layer_count);
    tissue.layers = layers;
    for (i = 0; i < (size_t)tissue.layer_count; ++i, p += MS_MCML__LAYER_BYTES) {
        layers[i].n = ms_mcml__bits_real(ms_mcml__get(p));
        layers[i].mu_a_per_cm = ms_mcml__bits_real(ms_mcml__get(p + 8));
        layers[i].mu_s_per_cm = ms_mcml__bits_real(ms_mcml__get(p + 16));
        layers[i].g = ms_mcml__bits_real(ms_mcml__get(p + 24));
        layers[i].thickness_cm = ms_mcml__bits_real(ms_mcml__get(p + 32));
    }
    status = ms_mcml_create(&tissue, grid, o, &m, error);
    ms__release(&o->allocator, layers, bytes);
    if (status == MS_INVALID_ARGUMENT) {
        if (error) error->status = MS_BAD_DATA;
        return MS_BAD_DATA;
    }
    if (status) return status;
    for (i = 0; i < m->at.count; ++i, p += 8) {
        if (ms_mcml__get(p) > (uint64_t)1 << 62) {
            ms_mcml_destroy(m);
            return ms__fail(error, MS_BAD_DATA, i, "sum %z of the saved tally is out of range", i);
        }
        m->sum[i] = (int64_t)ms_mcml__get(p);
    }
    m->photons = photons;
    *out = m;
    return MS_OK;
}

MS_API ms_status ms_mcml_load(const void *bytes, size_t size, const ms_mcml_options *options, ms_mcml **out,
                              ms_error *error)
{
    const uint8_t *p = (const uint8_t *)bytes;
    ms_mcml_options o = options ? *options : ms_mcml_defaults();
    ms_mcml_tissue tissue;
    ms_mcml_grid grid;
    ms_mcml__layout at;
    uint64_t word[MS_MCML__TALLY_WORDS];
    size_t expected, i;
    if (out == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "out is NULL");
    *out = NULL;
    if (p == NULL || size < MS_MCML__TALLY_HEAD || memcmp(p, ms_mcml__magic, 16) != 0)
        return ms__fail(error, MS_BAD_DATA, 0, "these bytes are not a saved tally");
    for (i = 0; i < MS_MCML__TALLY_WORDS; ++i) word[i] = ms_mcml__get(p + 16 + 8 * i);
    if (word[0] > ms_mcml__photons_max || word[3] > 1 || (word[6] & 0x8000000080000000u) || word[7] > 0x7fffffffu ||
        word[10] < 1 || word[10] > 32767)
        return ms__fail(error, MS_BAD_DATA, 16, "the head of the saved tally is damaged");
    o.photons = 0;
    o.seed = word[1];
    o.roulette_weight = ms_mcml__bits_real(word[2]);
    o.no_absorption = (int)word[3];
    grid.dr_cm = ms_mcml__bits_real(word[4]);
    grid.dz_cm = ms_mcml__bits_real(word[5]);
    grid.nr = (int)(word[6] & 0x7fffffffu);
    grid.nz = (int)(word[6] >> 32);
    grid.na = (int)word[7];
    tissue.n_above = ms_mcml__bits_real(word[8]);
    tissue.n_below = ms_mcml__bits_real(word[9]);
    tissue.layer_count = (int)word[10];
    tissue.layers = NULL;

    /* the size is checked before anything of it is allocated */
    expected = ms_mcml__layout_make(&at, &grid, tissue.layer_count, !o.no_absorption);
    expected = ms__size_add(expected, MS_MCML__TALLY_HEAD + (size_t)tissue.layer_count * MS_MCML__LAYER_BYTES);
    if (expected != size)
        return ms__fail(error, MS_BAD_DATA, size, "the saved tally is cut short or longer than its head says");
    return ms_mcml__load_rest(p + MS_MCML__TALLY_HEAD, &tissue, &grid, &o, word[0], out, error);
}

/* Mean and standard error from a sum and a sum of squares over n photons, both in units of 2^-30, times scale. */
static void ms_mcml__moments(double s, double q, double n, double scale, double *mean, double *error)
{
    const double unit = (double)ms_mcml__units, m = s / unit / n, v = q / unit / n - m * m;
    *mean = m * scale;
    *error = n > 1 ? (v > 0 ? sqrt(v / (n - 1)) * scale : 0) : HUGE_VAL;
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

/* Solid angle of bin ia of na, 2 pi (cos a_ia - cos a_ia+1), and its mean cosine. */
static double ms_mcml__solid_angle(int ia, int na, double *cosine)
{
    const double da = 1.5707963267948966 / na, a = (ia + 0.5) * da;
    *cosine = cos(a);
    return 12.566370614359172 * sin(a) * sin(da / 2);
}

static double ms_mcml__ring_area(int ir, double dr) { return 6.283185307179586 * (ir + 0.5) * dr * dr; }

/* Rd or Tt: the total, and over r, a, and both. */
static void ms_mcml__leave_results(const ms_mcml *m, int down, ms_mcml_result *out)
{
    const int nr = m->grid.nr, na = m->grid.na;
    const int64_t *bin = m->sum + m->at.leave + 2 * (size_t)down * (size_t)nr * (size_t)na;
    const double n = (double)m->photons, entered = 1 - m->specular;
    double *ra = down ? out->tt_ra : out->rd_ra, *ra_error = down ? out->tt_ra_error : out->rd_ra_error;
    double *r = down ? out->tt_r : out->rd_r, *r_error = down ? out->tt_r_error : out->rd_r_error;
    double *a = down ? out->tt_a : out->rd_a, *a_error = down ? out->tt_a_error : out->rd_a_error;
    double s = 0, q = 0, cosine, solid;
    int ir, ia;
    for (ir = 0; ir < nr; ++ir) {
        const double area = ms_mcml__ring_area(ir, m->grid.dr_cm);
        double ring_s = 0, ring_q = 0;
        for (ia = 0; ia < na; ++ia) {
            const size_t i = (size_t)ir * (size_t)na + (size_t)ia;
            const double bin_s = (double)bin[2 * i], bin_q = (double)bin[2 * i + 1];
            solid = ms_mcml__solid_angle(ia, na, &cosine);
            ms_mcml__moments(bin_s, bin_q, n, entered / (area * solid * cosine), &ra[i], &ra_error[i]);
            ring_s += bin_s;
            ring_q += bin_q;
        }
        ms_mcml__moments(ring_s, ring_q, n, entered / area, &r[ir], &r_error[ir]);
        s += ring_s;
        q += ring_q;
    }
    ms_mcml__moments(s, q, n, entered, down ? &out->tt : &out->rd, down ? &out->tt_error : &out->rd_error);
    for (ia = 0; ia < na; ++ia) {
        solid = ms_mcml__solid_angle(ia, na, &cosine);
        for (s = q = 0, ir = 0; ir < nr; ++ir) {
            const size_t i = (size_t)ir * (size_t)na + (size_t)ia;
            s += (double)bin[2 * i];
            q += (double)bin[2 * i + 1];
        }
        ms_mcml__moments(s, q, n, entered / solid, &a[ia], &a_error[ia]);
    }
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
    const size_t size = sizeof(double), nr = (size_t)m->grid.nr, na = (size_t)m->grid.na, nz = (size_t)m->grid.nz;
    const size_t layers = (size_t)m->tissue.layer_count;
    out->rd_r = (double *)ms__take(arena, nr, size);
    out->rd_r_error = (double *)ms__take(arena, nr, size);
    out->rd_a = (double *)ms__take(arena, na, size);
    out->rd_a_error = (double *)ms__take(arena, na, size);
    out->rd_ra = (double *)ms__take(arena, nr * na, size);
    out->rd_ra_error = (double *)ms__take(arena, nr * na, size);
    out->tt_r = (double *)ms__take(arena, nr, size);
    out->tt_r_error = (double *)ms__take(arena, nr, size);
    out->tt_a = (double *)ms__take(arena, na, size);
    out->tt_a_error = (double *)ms__take(arena, na, size);
    out->tt_ra = (double *)ms__take(arena, nr * na, size);
    out->tt_ra_error = (double *)ms__take(arena, nr * na, size);
    out->a_l = (double *)ms__take(arena, layers, size);
    out->a_l_error = (double *)ms__take(arena, layers, size);
    if (m->options.no_absorption) return;
    out->a_z = (double *)ms__take(arena, nz, size);
    out->a_rz = (double *)ms__take(arena, nr * nz, size);
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
    double mu_t_per_mm; /* mu_a + (1 - g) mu_s: similarity to isotropic scattering where g is not 0 */
    double albedo;      /* (1 - g) mu_s / mu_t */
    double specular;    /* reflected at entry: ((eta - 1) / (eta + 1))^2; not part of any number below */
    double total;       /* diffuse reflectance: single + multiple scattering */
    double total_single;
    double decay_per_mm; /* of the far tail: the Case eigenvalue nu_0 mu_t */
    double fit_error;    /* largest relative misfit of the multiple-scattering spectrum at the solved frequencies */
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
    const double nodes = MS_MCML__CONE_MAX, step = 6.6 / nodes;
    double mu_c = eta > 1 ? sqrt((eta - 1) * (eta + 1)) / eta : 0;
    int i;
    cone->count = MS_MCML__CONE_MAX;
    for (i = 0; i < cone->count; ++i) {
        double x = (i + 0.5 - 0.5 * nodes) * step;
        double e = exp(-3.14159265358979324 * sinh(x));
        double above = (1 - mu_c) / (1 + e), below = (1 - mu_c) * e / (1 + e); /* mu - mu_c, 1 - mu */
        double mu = mu_c + above;
        double mu_out = eta > 1 ? eta * sqrt(above * (mu + mu_c)) : sqrt((1 - eta) * (1 + eta) + eta * eta * mu * mu);
        double s = eta * mu + mu_out, p = eta * mu_out + mu;
        double transmitted = 2 * eta * mu * mu_out * (1 / (s * s) + 1 / (p * p)); /* Fresnel, unpolarized */
        cone->mu[i] = mu;
        cone->sin2[i] = below * (1 + mu);
        cone->weight[i] = 0.5 * transmitted * step * 3.14159265358979324 * cosh(x) * above * e / (1 + e);
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
   matrix: MS_MCML__TRIANGLE doubles of workspace. */
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
    one = n - first;
    for (i = first; i <= last && n < MS_MCML__DEPTH_MAX; ++i) b[n++] = exp(h * i);
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
    for (i = 0; i < n; ++i) { /* scaled <b_i, (1 - a K) b_j> */
        double *row = ms_mcml__triangle_row(matrix, i);
        for (j = 0; j <= i; ++j) {
            double image = i == j ? -dm[i] : (m[j] - m[i]) / (b[i] - b[j]);
            row[j] = scale[i] * scale[j] * ((1 - albedo * (g[i] + g[j])) / (b[i] + b[j]) - albedo * image);
        }
        sum = i == one ? -dm[i] : (m[i] - m[one]) / (b[one] - b[i]);
        u[i] = scale[i] * ((g[i] + g[one]) / (b[i] + b[one]) + sum); /* <b_i, K exp(-z)> */
    }
    for (i = 0; i < n; ++i) { /* Cholesky, and the forward solution */
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
    for (sum = 0, i = 0; i < n; ++i) sum += scale[i] * escape[i] * u[i];
    return albedo * albedo * sum;
}

/* Non-negative least squares (Lawson & Hanson 1974, chapter 23): minimizes |A x - target| with x >= 0. Columns have
   unit length. QR by Householder reflections that are appended as columns enter and rebuilt from the place where one
   leaves. */
typedef struct ms_mcml__nnls {
    int rows, columns, active;
    double tolerance;                        /* of the gradients where it ends */
    const double *a, *target;                /* [columns][rows], [rows] */
    double *x;                               /* [columns] */
    double *qr;                              /* [rows] a column: reflection below, R above the diagonal */
    double *diagonal, *rhs, *residual;       /* [rows] */
    double *solution;                        /* [columns] */
    int list[MS_MCML__COLUMNS_MAX];          /* the active columns */
    signed char state[MS_MCML__COLUMNS_MAX]; /* 1 active, -1 refused until the next success */
} ms_mcml__nnls;

/* Its arrays in work, of at most `rows` by `columns`; *target: [rows]. */
static void ms_mcml__nnls_place(ms_mcml__nnls *p, double *work, int rows, int columns, double **target)
{
    p->a = work;
    p->qr = work + columns * rows;
    p->diagonal = p->qr + rows * rows;
    p->rhs = p->diagonal + rows;
    p->residual = p->rhs + rows;
    p->target = *target = p->residual + rows;
    p->x = *target + rows;
    p->solution = p->x + columns;
}

/* Scales a column to unit length; returns the factor. */
static double ms_mcml__nnls_unit(double *column, int rows)
{
    double norm = 0;
    int i;
    for (i = 0; i < rows; ++i) norm += column[i] * column[i];
    norm = 1 / sqrt(norm);
    for (i = 0; i < rows; ++i) column[i] *= norm;
    return norm;
}

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
        double best = p->tolerance;
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
        for (;;) {
            double step = 1;
            int leaves = -1, kept = 0, first;
            for (c = 0; c < p->active; ++c) {
                double x = p->x[p->list[c]];
                if (p->solution[c] <= 0 && x / (x - p->solution[c]) < step) {
                    step = x / (x - p->solution[c]);
                    leaves = c;
                }
            }
            for (c = 0; c < p->active; ++c) p->x[p->list[c]] += step * (p->solution[c] - p->x[p->list[c]]);
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
        memcpy(p->residual, p->target, (size_t)rows * sizeof *p->residual);
        for (c = 0; c < p->active; ++c)
            for (i = 0; i < rows; ++i) p->residual[i] -= p->x[p->list[c]] * p->a[p->list[c] * rows + i];
        for (c = 0; c < p->columns; ++c)
            if (p->state[c] < 0) p->state[c] = 0;
    }
}

/* rate[j], energy[j] > 0 with  sum energy / (1 + k^2 / rate^2) = spectrum[i]  at k^2 = t[i]^2 - edge^2, rates on a
   lattice sqrt(edge^2 + tau^2) of log spacing `step` in tau. Returns how many; *misfit is relative. total is the
   spectrum at k = 0, which the energies are scaled to. Row i counts as 1 / (1 + noise t[i]): noise = 1 says that the
   relative error of the spectrum grows with t. tolerance: 0 fits to rounding. */
static int ms_mcml__stieltjes(const double *t, const double *spectrum, int rows, double noise, double tolerance,
                              double edge, double step, double total, double *rate, double *energy, double *misfit,
                              double *work)
{
    double tau[MS_MCML__COLUMNS_MAX], norm[MS_MCML__COLUMNS_MAX], sum = 0, unit = 1, *target;
    ms_mcml__nnls p;
    int i, c, count = 0;
    double *a = work;
    p.rows = rows;
    p.tolerance = tolerance;
    p.columns = 0;
    if (edge > 0) tau[p.columns++] = 0;
    for (i = (int)floor(-1.2 / step); p.columns < MS_MCML__COLUMNS_MAX && t[0] * exp(step * (i - 1)) < 20 * t[rows - 1];
         ++i)
        tau[p.columns++] = t[0] * exp(step * i);
    ms_mcml__nnls_place(&p, a, MS_MCML__RATES_MAX, MS_MCML__COLUMNS_MAX, &target);
    for (i = 0; i < rows; ++i) target[i] = 1 / (1 + noise * t[i]);   /* misfits are relative to the spectrum */
    if (spectrum[0] > 0 && spectrum[0] < 1e-100) unit = spectrum[0]; /* the squares below would overflow */
    for (c = 0; c < p.columns; ++c) {
        for (i = 0; i < rows; ++i)
            a[c * rows + i] = target[i] / ((t[i] * t[i] + tau[c] * tau[c]) * (spectrum[i] / unit));
        norm[c] = ms_mcml__nnls_unit(a + c * rows, rows);
    }
    ms_mcml__nnls_solve(&p);
    for (*misfit = 0, i = 0; i < rows; ++i)
        if (fabs(p.residual[i]) > *misfit * target[i]) *misfit = fabs(p.residual[i]) / target[i];
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
    if (!ms_mcml__between(mu_a, 0, HUGE_VAL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "mu_a_per_mm is %g, expected a number >= 0", mu_a);
    if (!ms_mcml__between(mu_s, 0, HUGE_VAL))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "mu_s_per_mm is %g, expected a number >= 0", mu_s);
    if (!ms_mcml__between(mu_a + mu_s, 1e-100, 1e100))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "mu_a_per_mm + mu_s_per_mm is %g, expected 1e-100 to 1e100",
                        mu_a + mu_s);
    if (!ms__finite(medium->g) || !(medium->g > -1 && medium->g < 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "g is %g, expected more than -1 and less than 1", medium->g);
    if (!ms_mcml__between(medium->eta, 0.1, 10))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "eta is %g, expected 0.1 to 10", medium->eta);
    return MS_OK;
}

enum { MS_MCML__SOLVE_BYTES = ((int)MS_MCML__FIT_DOUBLES + (int)MS_MCML__TRIANGLE) * (int)sizeof(double) };

static const double ms_mcml__slowest = 1e-7; /* decay, per mean free path, that the lattice of frequencies resolves */

/* Part of the entering light that leaves after two collisions and more. single: the part that leaves after one. What is
   absorbed falls with nu = sqrt(3 (1 - albedo)), to nothing. */
static double ms_mcml__multiple_total(const ms_mcml__cone *cone, double albedo, double nu, double h, double entering,
                                      double single, double *work)
{
    const double t = nu > ms_mcml__slowest ? nu : ms_mcml__slowest;
    const double multiple = entering * ms_mcml__multiple(cone, nu < t ? 1 - t * t / 3 : albedo, 0, t, h, work);
    return nu < t ? entering - single - (entering - single - multiple) * (nu / t) : multiple;
}

/* A medium that was checked; h and step are the two knobs, work has MS_MCML__SOLVE_BYTES. */
static void ms_mcml__solve(const ms_mcml_medium *medium, double h, double step, ms_mcml__halfspace *out, double *work)
{
    const double fastest = 200; /* of the lattice of t, per mean free path */
    ms_mcml__halfspace s;
    ms_mcml__cone cone;
    double t[MS_MCML__RATES_MAX], spectrum[MS_MCML__RATES_MAX];
    double absorption, entering, nu, multiple, low;
    int i, rows;

    memset(&s, 0, sizeof s);
    s.mu_t_per_mm = medium->mu_a_per_mm + medium->mu_s_per_mm * (1 - medium->g);
    s.albedo = medium->mu_s_per_mm * (1 - medium->g) / s.mu_t_per_mm;
    s.specular = (medium->eta - 1) / (medium->eta + 1);
    s.specular *= s.specular;
    absorption = medium->mu_a_per_mm / s.mu_t_per_mm;
    entering = 1 - s.specular;
    if (!(s.albedo > 1e-100)) { /* nothing comes back */
        s.decay_per_mm = s.mu_t_per_mm;
        *out = s;
        return;
    }
    ms_mcml__cone_make(&cone, medium->eta);

    /* Single scattering at angle theta to the normal:  energy beyond r is  exp(-r / u),  u = tan(theta / 2) */
    for (i = 0; i < cone.count; ++i) {
        double mu = cone.mu[i];
        s.single_rate_per_mm[i] = (1 + mu) / sqrt(cone.sin2[i]);
        s.single_energy[i] = entering * s.albedo * cone.weight[i] * mu / (1 + mu);
        s.total_single += s.single_energy[i];
    }
    s.singles = cone.count;
    nu = ms_mcml__case_eigenvalue(s.albedo, absorption);
    multiple = ms_mcml__multiple_total(&cone, s.albedo, nu, h, entering, s.total_single, work);
    s.total = s.total_single + multiple;
    low = 0.01 * nu > ms_mcml__slowest ? 0.01 * nu : ms_mcml__slowest;
    rows = 0;
    for (i = 0; rows < MS_MCML__RATES_MAX && low * exp(step * (i - 1)) < fastest; ++i) {
        t[rows] = low * exp(step * i);
        spectrum[rows] = entering * ms_mcml__multiple(&cone, s.albedo, t[rows] * t[rows] - nu * nu, t[rows], h, work);
        ++rows;
    }
    s.rates = ms_mcml__stieltjes(t, spectrum, rows, 1, 0, nu, 0.8 * step, multiple, s.rate_per_mm, s.energy,
                                 &s.fit_error, work);

    for (i = 0; i < s.singles; ++i) s.single_rate_per_mm[i] *= s.mu_t_per_mm;
    for (i = 0; i < s.rates; ++i) s.rate_per_mm[i] *= s.mu_t_per_mm;
    s.decay_per_mm = nu * s.mu_t_per_mm;
    *out = s;
}

static ms_status ms_mcml__check_steps(double *depth_step, double *frequency_step, ms_error *error)
{
    if (!ms_mcml__between(*depth_step, 0.28, 1) && !ms_mcml__between(*depth_step, 0, 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "depth_step is %g, expected 0.28 to 1, or 0", *depth_step);
    if (!ms_mcml__between(*frequency_step, 0.2, 1) && !ms_mcml__between(*frequency_step, 0, 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "frequency_step is %g, expected 0.2 to 1, or 0",
                        *frequency_step);
    if (!(*depth_step > 0)) *depth_step = 0.3;
    if (!(*frequency_step > 0)) *frequency_step = 0.25;
    return MS_OK;
}

/* x K1(x), relative error 6e-12: the power series up to 2, then sqrt(x) exp(x) K1(x) as a polynomial in 2 / x, which
   interpolates at the Chebyshev nodes of [0, 1]. */
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
    if (r1 - r0 < 1e-4 * r1) { /* a narrower ring has the same mean to 1e-9 (rate r)^2, but would cancel */
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

/* ---- layered solver -------------------------------------------------------------------------------------------- */

enum {
    MS_MCML__ORDER_MAX = 31,
    MS_MCML__LAYERS_MAX = 16,
    MS_MCML__RAYS = 8,         /* side by side: a part of a panel of nu = n sin(theta) */
    MS_MCML__AZIMUTHS = 17,    /* at most, in a quarter of the circle: order 31 needs them */
    MS_MCML__SHAPES = 64,      /* different panel lengths of a layer */
    MS_MCML__PANELS_MAX = 160, /* of a layer */
    MS_MCML__GMRES_STEPS = 48, /* steps of GMRES */
    MS_MCML__EVEN_MAX = 9,     /* even moments of the preconditioner */
    MS_MCML__ODD_MAX = 12,
    MS_MCML__WAVES = 440,
    MS_MCML__SERIES = 17 /* terms of exp(-y), |y| < 1, and of its last moment: 1e-16 */
};

/* A layer as the sweeps see it; mu_s, mu_t and sigma without the forward peak. */
typedef struct ms_mcml__solver_layer {
    double n, d, mu_a, mu_s, mu_t, kappa; /* d: as far as nodes go; kappa: effective attenuation */
    double mu_s_full, g, sigma[MS_MCML__ORDER_MAX + 1];
    double down, up;                      /* the beam at the top going down, at the bottom going up */
    int clear, semi, panel, panels, used; /* used: panels within reach at this frequency */
    int deep, node, end; /* first node of all; first and last of those within reach, each layer's a multiple of 8 */
    double shape[MS_MCML__SHAPES];
    int shapes, table; /* table: of its first shape */
} ms_mcml__solver_layer;

/* Low-order preconditioner: u even, v odd moments. */
typedef struct ms_mcml__preconditioner {
    int even, odd, nodes, pairs;
    int even_l[MS_MCML__EVEN_MAX], even_m[MS_MCML__EVEN_MAX], even_term[MS_MCML__EVEN_MAX];
    int odd_l[MS_MCML__ODD_MAX], odd_m[MS_MCML__ODD_MAX], odd_term[MS_MCML__ODD_MAX];
    int pair_even[48], pair_odd[48];
    double pair_a[48], pair_x[48]; /* streaming along z and x between them */
    double *block;                 /* [nodes][2][even][even]: inverse of the pivot, coupling to the next */
    double *right;                 /* [nodes][even] */
} ms_mcml__preconditioner;

typedef struct ms_mcml__sweeps {
    const ms_mcml__kernels *kernels;
    int layers, order, nodes, panels, shapes, parts;
    double n_above, n_below, specular, unscattered; /* reflected and transmitted without scattering */
    ms_mcml__solver_layer layer[MS_MCML__LAYERS_MAX];
    double breaks[MS_MCML__LAYERS_MAX + 2];
    int break_count, clear; /* clear: a layer is */
    int full_depth;         /* what leaves at the bottom matters, which the beam takes farther than slant light */
    double z[MS_MCML__LAYERS_MAX * (4 * MS_MCML__PANELS_MAX + 1)]; /* [nodes] from the top of the layer */
    int panel_shape[MS_MCML__LAYERS_MAX * MS_MCML__PANELS_MAX];
    /* at one frequency */
    double k, mu_least;
    int most, blocks, azimuths, azimuths_most, terms,
        active;                      /* m up to most; terms: of l and m; active: nodes that light reaches */
    double *nu, *nu_weight;          /* [blocks][RAYS] */
    double *cosine, *azimuth_weight; /* [blocks][azimuths][RAYS] cos(phi), weight */
    double *azimuthal;               /* [blocks][azimuths][most + 1][RAYS] (-1)^(m/2) cos(m phi) / norm */
    double *mu;                      /* [blocks][layers][RAYS], or 0 */
    double *theta;                   /* [blocks][layers][terms][RAYS] */
    double *table;                   /* [blocks][azimuths][shapes][4][6][2][RAYS] */
    double *transfer; /* [blocks][azimuths][layers][5][2][RAYS] of each ray through a layer: what passes; back over down
                      at its   bottom and at its top; what v of the next layer counts here; 1 / (1 - r times back at its
                      top) */
    double *edge;     /* [blocks][layers][5][RAYS] at its top: reflectance, what comes in from above; at its bottom:
                         reflectance; what leaves upwards and downwards */
    double *depth, *beam; /* [active], [2][active]: down and up */
    double *q, *source;   /* of a sweep: [terms][active] source moments, [2][m][active][RAYS] of the rays down and up */
    double *line, *down, *up, *both; /* [active][4][RAYS], [active][2][RAYS] twice, [azimuths][active][4][RAYS] */
    double *moments, *x, *vectors;   /* moments: [terms][nodes] three times; x: [terms][active] */
    void *memory;
    size_t size;
    ms_mcml__preconditioner preconditioner;
} ms_mcml__sweeps;

static int ms_mcml__first_term(int order, int m)
{
    return m * (order + 1) - m * (m - 1) / 2;
} /* terms m, l = m .. order */

static void ms_mcml__legendre_nodes(int n, double *x, double *w) /* Gauss on [0, 1] */
{
    int i, k, iteration;
    for (i = 0; i < n; ++i) {
        double t = cos(3.14159265358979324 * (i + 0.75) / (n + 0.5)), p = 1, slope = 1;
        for (iteration = 0; iteration < 20; ++iteration) {
            double p1 = 1, p2 = 0;
            for (k = 1; k <= n; ++k) {
                double p3 = p2;
                p2 = p1;
                p1 = ((2 * k - 1) * t * p2 - (k - 1) * p3) / k;
            }
            p = p1;
            slope = n * (t * p1 - p2) / (t * t - 1);
            t -= p / slope;
            if (fabs(p / slope) < 1e-16) break;
        }
        x[i] = 0.5 * (1 - t);
        w[i] = 1 / ((1 - t * t) * slope * slope);
    }
}

/* Theta_lm(mu) with integral of squares over (-1, 1) equal 1, no sign; out[terms][stride] */
static void ms_mcml__theta(int order, int most, double mu, double *out, int stride)
{
    double diagonal = sqrt(0.5), sine = sqrt((1 - mu) * (1 + mu));
    int l, m;
    for (m = 0; m <= most; ++m) {
        double *p = out + (size_t)ms_mcml__first_term(order, m) * (size_t)stride, a = 0, b = diagonal, ka = 0;
        if (m > 0) diagonal *= sine * sqrt((2 * m + 1.0) / (2 * m)), b = diagonal;
        p[0] = b;
        for (l = m + 1; l <= order; ++l) {
            double k = sqrt((4.0 * l * l - 1) / ((double)l * l - (double)m * m)),
                   next = k * (mu * b - (ka > 0 ? a / ka : 0));
            a = b;
            b = next;
            ka = k;
            p[(size_t)(l - m) * (size_t)stride] = b;
        }
    }
}

/* The beam in every layer, to and fro, all orders: 2 x 2 per boundary from below. */
static void ms_mcml__beams(ms_mcml__sweeps *s)
{
    double ratio[MS_MCML__LAYERS_MAX], pass[MS_MCML__LAYERS_MAX], through[MS_MCML__LAYERS_MAX], rho = 0, top, down;
    int i;
    for (i = s->layers - 1; i >= 0; --i) { /* rho: up over down at the bottom of layer i */
        const ms_mcml__solver_layer *l = &s->layer[i];
        double below = i + 1 < s->layers ? s->layer[i + 1].n : s->n_below, r = (l->n - below) / (l->n + below);
        through[i] = l->mu_t * l->d < 700 && !l->semi ? exp(-l->mu_t * l->d) : 0;
        r *= r;
        ratio[i] = l->semi ? 0 : r + (1 - r) * (1 - r) * rho / (1 - r * rho);
        pass[i] = l->semi ? 0 : (1 - r) / (1 - r * rho);
        rho = ratio[i] * through[i] * through[i]; /* up at the top over down at the top */
    }
    top = (s->n_above - s->layer[0].n) / (s->n_above + s->layer[0].n);
    top *= top;
    down = (1 - top) / (1 - top * rho);
    s->specular = top + (1 - top) * (1 - top) * rho / (1 - top * rho);
    for (i = 0; i < s->layers; ++i) {
        s->layer[i].down = down;
        s->layer[i].up = down * through[i] * ratio[i];
        down *= through[i] * pass[i];
    }
    s->unscattered = down;
}

/* Panels of a layer of optical thickness tau below a depth of others, in mean free paths; their number. Fine at both
   ends, where the source bends, a unit of mean free paths long where the beam scatters first, longer below, up to
   `longest`. */
static int ms_mcml__mesh(double tau, int semi, double depth, double longest, double unit, double *h)
{
    enum { MOST = MS_MCML__PANELS_MAX / 2 - 4 };
    double back[MOST], done = 0, size = unit > 1 ? 0.1 : 0.04, step, left;
    int n = 0, i, pieces;
    for (;; size *= unit > 1 ? 4 : 2.5) {
        const double most = unit + fmax(0, 0.4 * (depth + done - 12));
        step = size < most ? size : most;
        if (step > longest) step = longest;
        left = tau - (semi ? 1 : 2) * done;
        if (left <= (semi ? 1 : 2.6) * step || n == MOST) break;
        back[n] = h[n] = step;
        ++n;
        done += step;
    }
    pieces = semi ? 1 : (int)ceil(left / (1.3 * step));
    if (pieces > 4) pieces = 4;
    for (i = 0; i < pieces; ++i) h[n + i] = left / pieces;
    i = n;
    n += pieces;
    while (!semi && i > 0) h[n++] = back[--i];
    return n;
}

static const double ms_mcml__lobatto[5] = {0, 0.17267316464601143, 0.5, 0.82732683535398857, 1};

/* polynomial[step][j][n]: Lagrange polynomial of point j at t = end - length u, as powers of u, times the length */
static void ms_mcml__panel_polynomials(double polynomial[4][5][5])
{
    const double *t = ms_mcml__lobatto;
    int step, j, i, n;
    for (step = 0; step < 4; ++step)
        for (j = 0; j < 5; ++j) {
            const double end = t[step + 1], length = t[step + 1] - t[step];
            double p[5] = {1, 0, 0, 0, 0};
            for (i = 0; i < 5; ++i) { /* times (end - t_i - length u) / (t_j - t_i) */
                if (i == j) continue;
                for (n = 4; n >= 0; --n) p[n] = (p[n] * (end - t[i]) - (n ? p[n - 1] * length : 0)) / (t[j] - t[i]);
            }
            for (n = 0; n < 5; ++n) polynomial[step][j][n] = p[n] * length;
        }
}

/* The rays' nu = n sin(theta). The first panel is in two: sinh from the normal, then towards grazing; each of the
   others clusters at its upper end. */
static void ms_mcml__ray_angles(ms_mcml__sweeps *s)
{
    const double *breaks = s->breaks, mu_least = s->mu_least, k = s->k;
    const double eps = mu_least / (k > 1e-9 * mu_least ? k : 1e-9 * mu_least) * breaks[0], cut = 0.6 * breaks[0];
    const double top = log(cut / eps + sqrt(1 + cut / eps * (cut / eps)));
    const int count = MS_MCML__RAYS * s->parts;
    double x[64], w[64];
    int b, j;
    ms_mcml__legendre_nodes(count, x, w);
    for (j = 0; j < count; ++j) {
        const double e = exp(top * x[j]);
        s->nu[j] = top > 1e-5 ? eps * 0.5 * (e - 1 / e) : cut * x[j];
        s->nu_weight[j] = top > 1e-5 ? w[j] * top * eps * 0.5 * (e + 1 / e) : cut * w[j];
    }
    for (b = 1; b <= s->break_count; ++b) {
        const double low = b == 1 ? cut : breaks[b - 2], high = breaks[b - 1];
        for (j = 0; j < count; ++j) {
            s->nu[b * count + j] = high - (high - low) * x[j] * x[j];
            s->nu_weight[b * count + j] = (high - low) * 2 * x[j] * w[j];
        }
    }
    s->blocks = (s->break_count + 1) * s->parts;
}

/* Azimuths of each block of rays, in a quarter of the circle: equal steps if they suffice, else clustered where the
   wave's phase does not change along the ray. */
static void ms_mcml__ray_azimuths(ms_mcml__sweeps *s)
{
    enum { R = MS_MCML__RAYS };
    const double right = 1.5707963267948966, ratio = s->k / s->mu_least, t = ratio / (1 + sqrt(1 + ratio * ratio));
    const double digits = log((t < 0.25 ? 1e-7 : 1e-5) * (s->order > 3 ? 1 : 1e-3));
    double x[64], w[64];
    int count = t > 1e-9 ? (int)ceil(digits / (4 * log(t))) : 1, even, b, a, j, m;
    if (count * 4 < 2 * s->most + 2) count = (2 * s->most + 5) / 4;
    even = count <= s->azimuths_most;
    if (!even) count = s->azimuths_most;
    s->azimuths = count;
    ms_mcml__legendre_nodes(count, x, w);
    for (b = 0; b < s->blocks; ++b)
        for (a = 0; a < count; ++a)
            for (j = 0; j < R; ++j) {
                const size_t at = (size_t)(b * count + a) * R + (size_t)j;
                double psi = right * (a + 0.5) / count, weight = right / count;
                if (!even) {
                    const double eps = s->mu_least * s->breaks[0] / (s->k * s->nu[b * R + j]), q = right / eps;
                    const double top = log(q + sqrt(1 + q * q)), e = exp(top * x[a]);
                    psi = eps * 0.5 * (e - 1 / e);
                    weight = w[a] * top * eps * 0.5 * (e + 1 / e);
                }
                s->cosine[at] = sin(psi);
                s->azimuth_weight[at] = weight;
                for (m = 0; m <= s->most; ++m)
                    s->azimuthal[((size_t)(b * count + a) * (size_t)(s->most + 1) + (size_t)m) * R + (size_t)j] =
                        (m & 2 ? -1 : 1) * cos(m * (right - psi)) * (m ? 0.56418958354775629 : 0.3989422804014327);
            }
}

/* Cosines, angular functions and panel weights of a block of rays in one layer. */
static void ms_mcml__ray_layer(ms_mcml__sweeps *s, int b, int layer, double polynomial[4][5][5],
                               double series[2][MS_MCML__SERIES + 1])
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *l = &s->layer[layer];
    double *mus = s->mu + (b * s->layers + layer) * R;
    int a, i, j;
    for (j = 0; j < R; ++j) {
        const double nu = s->nu[b * R + j], sine = nu / l->n, mu = nu < l->n ? sqrt((1 - sine) * (1 + sine)) : 0;
        mus[j] = mu;
        if (mu > 0 && !l->clear)
            ms_mcml__theta(s->order, s->most, mu, s->theta + (size_t)(b * s->layers + layer) * (size_t)s->terms * R + j,
                           R);
    }
    for (a = 0; a < s->azimuths && !l->clear; ++a)
        for (i = 0; i < l->shapes; ++i) {
            const size_t at = (size_t)(b * s->azimuths + a) * (size_t)s->shapes + (size_t)(l->table + i);
            double h[R], wave[R]; /* length along each ray, radians a length */
            for (j = 0; j < R; ++j) {
                h[j] = mus[j] > 0 ? l->shape[i] / mus[j] : 0;
                wave[j] = s->k * s->nu[b * R + j] / l->n * s->cosine[(b * s->azimuths + a) * R + j];
            }
            s->kernels->panel_weights(l->mu_t, h, wave, &polynomial[0][0][0], &series[0][0], s->table + at * 48 * R);
        }
}

/* Rays, angular functions and weights of all sweeps at frequency k. */
static void ms_mcml__rays(ms_mcml__sweeps *s, double k, int most)
{
    double polynomial[4][5][5], series[2][MS_MCML__SERIES + 1];
    int b, i, layer;
    s->k = k;
    s->most = most;
    s->terms = ms_mcml__first_term(s->order, most + 1);
    ms_mcml__panel_polynomials(polynomial);
    series[1][0] = 1;
    for (i = 0; i <= MS_MCML__SERIES; ++i) {
        if (i) series[1][i] = series[1][i - 1] / i;
        series[0][i] = series[1][i] / (i + 5);
    }
    ms_mcml__ray_angles(s);
    ms_mcml__ray_azimuths(s);
    for (b = 0; b < s->blocks; ++b)
        for (layer = 0; layer < s->layers; ++layer) ms_mcml__ray_layer(s, b, layer, polynomial, series);
}

/* Reflection and transmission of a block of rays at both sides of a layer. */
static void ms_mcml__edges(ms_mcml__sweeps *s, int b, int layer)
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *y = &s->layer[layer];
    const double *nu = s->nu + b * R;
    const int last = layer + 1 == s->layers, open = !y->semi && (y->clear || y->used == y->panels);
    const double above = layer ? y[-1].n : s->n_above, below = last ? s->n_below : y[1].n;
    double *edge = s->edge + (size_t)(b * s->layers + layer) * 5 * R;
    int j;
    for (j = 0; j < R; ++j) {
        const double out = 4 * s->nu_weight[b * R + j] * nu[j] / (y->n * y->n);
        edge[j] = ms_mcml__fresnel_nu(y->n, above, nu[j]);
        edge[R + j] = layer && nu[0] < above ? (1 - edge[j]) * (y->n / above) * (y->n / above) : 0;
        edge[2 * R + j] = open ? ms_mcml__fresnel_nu(y->n, below, nu[j]) : 0;
        edge[3 * R + j] = layer ? 0 : out * (1 - edge[j]);
        edge[4 * R + j] = last && open ? out * (1 - edge[2 * R + j]) : 0;
    }
}

/* Transfer of a block of rays at one azimuth through a layer, from that of the next layer. */
static void ms_mcml__transfer(ms_mcml__sweeps *s, int b, int a, int layer)
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *y = &s->layer[layer];
    const double *nu = s->nu + b * R, *cosine = s->cosine + (b * s->azimuths + a) * R,
                 *mu = s->mu + (b * s->layers + layer) * R, *edge = s->edge + (size_t)(b * s->layers + layer) * 5 * R;
    double *c = s->transfer + (size_t)((b * s->azimuths + a) * s->layers + layer) * 10 * R;
    const double *next = c + 10 * R;
    const int open = layer + 1 < s->layers && nu[0] < y[1].n && (y[1].clear || y[1].used) &&
        (y->clear || y->used == y->panels);
    int j;
    memset(c, 0, 10 * R * sizeof(double));
    if (!(nu[0] < y->n) || (!y->clear && y->used == 0)) return;
    for (j = 0; j < R; ++j) {
        const double x = y->mu_t * y->d / mu[j], angle = s->k * nu[j] / y->n * cosine[j] * y->d / mu[j];
        const double e = x < 700 && !y->semi ? exp(-x) : 0, er = e * cos(e > 0 ? angle : 0),
                     ei = -e * sin(e > 0 ? angle : 0), r = edge[2 * R + j];
        double br = r, bi = 0, tr, ti, nr, ni, size;
        if (open) { /* r + (1 - r)^2 rho / (1 - rho r), rho at the top of the next layer */
            const double across = (1 - r) * (1 - r), factor = (1 - r) * (y->n / y[1].n) * (y->n / y[1].n);
            const double pr = next[4 * R + j], pi = next[5 * R + j], qr = next[8 * R + j], qi = next[9 * R + j];
            br += across * (pr * qr - pi * qi);
            bi += across * (pr * qi + pi * qr);
            c[6 * R + j] = factor * qr;
            c[7 * R + j] = factor * qi;
        }
        tr = br * er - bi * ei;
        ti = br * ei + bi * er;
        c[j] = er;
        c[R + j] = ei;
        c[2 * R + j] = br;
        c[3 * R + j] = bi;
        c[4 * R + j] = tr * er - ti * ei;
        c[5 * R + j] = tr * ei + ti * er;
        nr = 1 - edge[j] * c[4 * R + j];
        ni = -edge[j] * c[5 * R + j];
        size = nr * nr + ni * ni;
        c[8 * R + j] = size > 0 ? nr / size : 0;
        c[9 * R + j] = size > 0 ? -ni / size : 0;
    }
}

/* Boundaries of all rays, which all sweeps at a frequency share: from the bottom up. */
static void ms_mcml__boundaries(ms_mcml__sweeps *s)
{
    int b, a, layer;
    for (b = 0; b < s->blocks; ++b) {
        for (layer = 0; layer < s->layers; ++layer) ms_mcml__edges(s, b, layer);
        for (a = 0; a < s->azimuths; ++a)
            for (layer = s->layers - 1; layer >= 0; --layer) ms_mcml__transfer(s, b, a, layer);
    }
}

/* Inverse of a symmetric positive matrix in place, by Gauss-Jordan. */
static void ms_mcml__invert(double *a, int n)
{
    int i, j, k;
    for (k = 0; k < n; ++k) {
        const double p = 1 / a[k * n + k];
        a[k * n + k] = 1;
        for (j = 0; j < n; ++j) a[k * n + j] *= p;
        for (i = 0; i < n; ++i) {
            const double q = a[i * n + k];
            if (i == k) continue;
            a[i * n + k] = 0;
            for (j = 0; j < n; ++j) a[i * n + j] -= q * a[k * n + j];
        }
    }
}

/* Preconditioner: P_N equations up to most_l; even moments by linear finite elements in depth (u / n^2 continuous), odd
   moments eliminated. With A and X the streaming along z and x (moments times i^m),
     A v' + k X v + S_e u = q_e,   A^T u' - k X^T u + S_o v = q_o,   S_l = mu_t - sigma_l. */

/* Streaming along x between (le, me) and (lo, mo), whose m differ by one. */
static double ms_mcml__streaming_x(int le, int me, int lo, int mo)
{
    const int m = me < mo ? me : mo;
    const double lm = me < mo ? le : lo, lh = me < mo ? lo : le, c = me + mo > 1 ? 0.5 : 0.70710678118654752;
    const double x = lh > lm ? c * sqrt((lm + m + 1) * (lm + m + 2) / ((2 * lm + 1) * (2 * lm + 3)))
                             : -c * sqrt((lm - m) * (lm - m - 1) / ((2 * lm - 1) * (2 * lm + 1)));
    return mo > me ? -x : x;
}

/* The moments, and A and X between them. */
static void ms_mcml__streaming(const ms_mcml__sweeps *s, int most_l, ms_mcml__preconditioner *f,
                               double a[][MS_MCML__ODD_MAX], double x[][MS_MCML__ODD_MAX])
{
    int i, o, l, m;
    f->even = f->odd = f->nodes = f->pairs = 0;
    for (m = 0; m <= s->most && m <= most_l; ++m)
        for (l = m; l <= most_l; ++l) {
            const int term = ms_mcml__first_term(s->order, m) + l - m;
            if (l & 1) f->odd_l[f->odd] = l, f->odd_m[f->odd] = m, f->odd_term[f->odd++] = term;
            else f->even_l[f->even] = l, f->even_m[f->even] = m, f->even_term[f->even++] = term;
        }
    for (i = 0; i < f->even; ++i)
        for (o = 0; o < f->odd; ++o) {
            const int le = f->even_l[i], lo = f->odd_l[o], me = f->even_m[i], mo = f->odd_m[o], low = le < lo ? le : lo;
            a[i][o] = x[i][o] = 0;
            if (le - lo != 1 && lo - le != 1) continue;
            if (me == mo)
                a[i][o] = sqrt(((low + 1.0) * (low + 1.0) - (double)me * me) / ((2.0 * low + 1) * (2.0 * low + 3)));
            if (me - mo == 1 || mo - me == 1) x[i][o] = ms_mcml__streaming_x(le, me, lo, mo);
            if (fabs(a[i][o]) + fabs(x[i][o]) > 1e-9) {
                f->pair_even[f->pairs] = i;
                f->pair_odd[f->pairs] = o;
                f->pair_a[f->pairs] = a[i][o];
                f->pair_x[f->pairs++] = x[i][o];
            }
        }
}

/* The matrices of the elements of a layer, from `node` on: w' P u' - k w' Q u - k w Q^T u' + w R u on [0, h]. */
static void ms_mcml__elements(const ms_mcml__sweeps *s, const ms_mcml__solver_layer *y, int node,
                              double a[][MS_MCML__ODD_MAX], double x[][MS_MCML__ODD_MAX])
{
    const ms_mcml__preconditioner *f = &s->preconditioner;
    const double n4 = y->n * y->n * y->n * y->n, k = s->k;
    const int ne = f->even;
    int at, i, j, o;
    for (at = y->node; at < y->end; ++at, ++node) {
        const double h = s->depth[at + 1] - s->depth[at];
        double *here = f->block + (size_t)node * 2 * (size_t)(ne * ne), *next = here + 2 * ne * ne;
        double *coupling = here + ne * ne; /* row: this node, column: next */
        for (i = 0; i < ne; ++i)
            for (j = 0; j < ne; ++j) {
                double p = 0, q = 0, qt = 0, r = 0;
                for (o = 0; o < f->odd; ++o) {
                    const double v = 1 / (y->mu_t - y->sigma[f->odd_l[o]]);
                    p += a[i][o] * a[j][o] * v;
                    q += a[i][o] * x[j][o] * v;
                    qt += x[i][o] * a[j][o] * v;
                    r += x[i][o] * x[j][o] * v;
                }
                r = k * k * r + (i == j ? y->mu_t - y->sigma[f->even_l[i]] : 0);
                here[i * ne + j] += n4 * (p / h + k * 0.5 * q + k * 0.5 * qt + r * h / 3);
                next[i * ne + j] += n4 * (p / h - k * 0.5 * q - k * 0.5 * qt + r * h / 3);
                coupling[i * ne + j] += n4 * (-p / h + k * 0.5 * q - k * 0.5 * qt + r * h / 6);
            }
    }
}

/* Light that leaves at a surface of index `outside`: integral of |mu| (1 - r) / (1 + r) Y Y'. */
static void ms_mcml__surface(const ms_mcml__sweeps *s, double n, double outside, int most_l, double *block)
{
    const ms_mcml__preconditioner *f = &s->preconditioner;
    const double n4 = n * n * n * n;
    const int ne = f->even;
    double theta[21]; /* terms up to l = 5 */
    int t, i, j;
    for (t = 0; t < 48; ++t) {
        const double mu = (t + 0.5) / 48, r = ms_mcml__fresnel_nu(n, outside, n * sqrt(1 - mu * mu));
        ms_mcml__theta(most_l, s->most < most_l ? s->most : most_l, mu, theta, 1);
        for (i = 0; i < ne; ++i)
            for (j = 0; j < ne; ++j)
                if (f->even_m[i] == f->even_m[j])
                    block[i * ne + j] += n4 * 2 * mu / 48 * (1 - r) / (1 + r) *
                        theta[ms_mcml__first_term(most_l, f->even_m[i]) + f->even_l[i] - f->even_m[i]] *
                        theta[ms_mcml__first_term(most_l, f->even_m[j]) + f->even_l[j] - f->even_m[j]];
    }
}

/* Block elimination: each pivot becomes the inverse of D_i - C^T D^-1 C. */
static void ms_mcml__factor(ms_mcml__preconditioner *f)
{
    const int ne = f->even;
    int node, i, j, o;
    for (node = 0; node < f->nodes; ++node) {
        double *pivot = f->block + (size_t)node * 2 * (size_t)(ne * ne), *next = pivot + 2 * ne * ne;
        const double *c = pivot + ne * ne;
        double dc[MS_MCML__EVEN_MAX * MS_MCML__EVEN_MAX];
        ms_mcml__invert(pivot, ne);
        if (node + 1 == f->nodes) break;
        for (i = 0; i < ne; ++i)
            for (j = 0; j < ne; ++j) {
                double sum = 0;
                for (o = 0; o < ne; ++o) sum += pivot[i * ne + o] * c[o * ne + j];
                dc[i * ne + j] = sum;
            }
        for (i = 0; i < ne; ++i)
            for (j = 0; j < ne; ++j) {
                double sum = 0;
                for (o = 0; o < ne; ++o) sum += c[o * ne + i] * dc[o * ne + j];
                next[i * ne + j] -= sum;
            }
    }
}

static void ms_mcml__preconditioner_make(ms_mcml__sweeps *s, int most_l)
{
    ms_mcml__preconditioner *f = &s->preconditioner;
    double a[MS_MCML__EVEN_MAX][MS_MCML__ODD_MAX], x[MS_MCML__EVEN_MAX][MS_MCML__ODD_MAX];
    const ms_mcml__solver_layer *first = NULL, *last = NULL;
    int layer, node = 0;
    size_t block;
    ms_mcml__streaming(s, most_l, f, a, x);
    for (layer = 0; layer < s->layers; ++layer) {
        const ms_mcml__solver_layer *y = &s->layer[layer];
        if (y->clear || !y->used) continue;
        f->nodes += 4 * y->used + (f->nodes ? 0 : 1);
        last = y;
        if (first == NULL) first = y;
    }
    if (first == NULL) return;
    block = (size_t)(f->even * f->even);
    memset(f->block, 0, (size_t)f->nodes * 2 * block * sizeof(double));
    for (layer = 0; layer < s->layers; ++layer) {
        const ms_mcml__solver_layer *y = &s->layer[layer];
        if (y->clear || !y->used) continue;
        ms_mcml__elements(s, y, node, a, x);
        node += y->end - y->node;
    }
    ms_mcml__surface(s, first->n, s->n_above, most_l, f->block);
    ms_mcml__surface(s, last->n, last->semi || last->used < last->panels ? last->n : s->n_below, most_l,
                     f->block + (size_t)(f->nodes - 1) * 2 * block);
    ms_mcml__factor(f);
}

/* The right side of the elements: the residual r, odd moments eliminated. */
static void ms_mcml__element_sources(const ms_mcml__sweeps *s, const double *r)
{
    const ms_mcml__preconditioner *f = &s->preconditioner;
    const size_t nz = (size_t)s->active;
    const double k = s->k;
    const int ne = f->even;
    int layer, node = 0, at, i, j, o;
    memset(f->right, 0, (size_t)(f->nodes * ne) * sizeof(double));
    for (layer = 0; layer < s->layers; ++layer) {
        const ms_mcml__solver_layer *y = &s->layer[layer];
        const double n2 = y->n * y->n;
        if (y->clear || !y->used) continue;
        for (at = y->node; at < y->end; ++at, ++node) {
            const double h = s->depth[at + 1] - s->depth[at];
            double *b0 = f->right + node * ne, *b1 = b0 + ne, v0[MS_MCML__ODD_MAX], v1[MS_MCML__ODD_MAX];
            for (o = 0; o < f->odd; ++o) {
                const double q = y->sigma[f->odd_l[o]] / (y->mu_t - y->sigma[f->odd_l[o]]),
                             *x = r + (size_t)f->odd_term[o] * nz + at;
                v0[o] = q * x[0];
                v1[o] = q * x[1];
            }
            for (i = 0; i < ne; ++i) {
                const double q = y->sigma[f->even_l[i]], *x = r + (size_t)f->even_term[i] * nz + at;
                b0[i] += n2 * h * q * (x[0] / 3 + x[1] / 6);
                b1[i] += n2 * h * q * (x[0] / 6 + x[1] / 3);
            }
            for (j = 0; j < f->pairs; ++j) { /* (A^T w' - k X^T w) v */
                const double *w0 = &v0[f->pair_odd[j]], *w1 = &v1[f->pair_odd[j]];
                const double mean = 0.5 * (*w0 + *w1) * f->pair_a[j], c = k * h * f->pair_x[j];
                b0[f->pair_even[j]] += n2 * (-mean - c * (*w0 / 3 + *w1 / 6));
                b1[f->pair_even[j]] += n2 * (mean - c * (*w0 / 6 + *w1 / 3));
            }
        }
    }
}

/* Forward and back substitution with the blocks of ms_mcml__factor. */
static void ms_mcml__substitute(const ms_mcml__preconditioner *f)
{
    const int ne = f->even;
    int node, i, j;
    for (node = 0; node < f->nodes; ++node) {
        const double *p = f->block + (size_t)node * 2 * (size_t)(ne * ne), *c = p + ne * ne;
        double *b = f->right + node * ne, y[MS_MCML__EVEN_MAX];
        for (i = 0; i < ne; ++i) {
            double x = 0;
            for (j = 0; j < ne; ++j) x += p[i * ne + j] * b[j];
            y[i] = x;
        }
        for (i = 0; i < ne; ++i) b[i] = y[i];
        if (node + 1 < f->nodes)
            for (i = 0; i < ne; ++i)
                for (j = 0; j < ne; ++j) b[ne + j] -= c[i * ne + j] * y[i];
    }
    for (node = f->nodes - 2; node >= 0; --node) {
        const double *p = f->block + (size_t)node * 2 * (size_t)(ne * ne), *c = p + ne * ne;
        double *b = f->right + node * ne, y[MS_MCML__EVEN_MAX];
        for (i = 0; i < ne; ++i) {
            double x = 0;
            for (j = 0; j < ne; ++j) x += c[i * ne + j] * b[ne + j];
            y[i] = x;
        }
        for (i = 0; i < ne; ++i)
            for (j = 0; j < ne; ++j) b[i] -= p[i * ne + j] * y[j];
    }
}

/* r += the preconditioner's solution: even moments from the nodes, odd ones from their equations. */
static void ms_mcml__precondition(const ms_mcml__sweeps *s, double *r)
{
    const ms_mcml__preconditioner *f = &s->preconditioner;
    const size_t nz = (size_t)s->active;
    const double k = s->k;
    const int ne = f->even;
    int layer, node, at, i, j, o;
    if (f->nodes == 0) return;
    ms_mcml__element_sources(s, r);
    ms_mcml__substitute(f);
    for (layer = 0, node = 0; layer < s->layers; ++layer) {
        const ms_mcml__solver_layer *y = &s->layer[layer];
        const double n2 = y->n * y->n;
        if (y->clear || !y->used) continue;
        for (at = y->node; at <= y->end; ++at, ++node) {
            const double *u = f->right + node * ne;
            const int low = at > y->node ? 1 : 0, high = at < y->end ? 1 : 0;
            const double scale = n2 / (s->depth[at + high] - s->depth[at - low]);
            double v[MS_MCML__ODD_MAX];
            for (o = 0; o < f->odd; ++o) v[o] = 0;
            for (j = 0; j < f->pairs; ++j) {
                i = f->pair_even[j];
                v[f->pair_odd[j]] += k * f->pair_x[j] * n2 * u[i] -
                    f->pair_a[j] * scale * (u[high * ne + i] - u[i - low * ne]);
            }
            for (o = 0; o < f->odd; ++o) {
                double q = v[o], *x = r + (size_t)f->odd_term[o] * nz + at;
                *x += (y->sigma[f->odd_l[o]] * *x + q) / (y->mu_t - y->sigma[f->odd_l[o]]);
            }
            for (i = 0; i < ne; ++i) r[(size_t)f->even_term[i] * nz + (size_t)at] += n2 * u[i];
        }
        --node;
    }
}

/* d - K d = b by GMRES, preconditioned from the left, from d on. leave: what leaves the top and the bottom. The
   residual, relative to b. */
static double ms_mcml__gmres(ms_mcml__sweeps *s, double *d, double tolerance, double leave[2])
{
    enum { SPAN = MS_MCML__GMRES_STEPS };
    const size_t n = (size_t)s->terms * (size_t)s->active;
    const ms_mcml__kernels *f = s->kernels;
    double *basis = s->vectors, *h = basis + (SPAN + 1) * n, *out = h + (SPAN + 1) * SPAN; /* h[j][i] */
    double cs[SPAN], sn[SPAN], g[SPAN + 1], size, x, residual = 0;
    int restart, step, i, j;
    size_t e;
    for (restart = 0; restart < 4; ++restart) {
        f->sweep(s, d, 1, basis, leave);
        size = sqrt(f->inner(basis, basis, n));
        for (e = 0; e < n; ++e) basis[e] -= d[e];
        ms_mcml__precondition(s, basis);
        g[0] = sqrt(f->inner(basis, basis, n));
        residual = size > 0 ? g[0] / size : 0;
        if (!(residual > tolerance)) return residual;
        for (e = 0; e < n; ++e) basis[e] *= 1 / g[0];
        for (step = 0; step < SPAN && residual > tolerance; ++step) {
            double *v = basis + (size_t)step * n, *w = v + n, *column = h + step * (SPAN + 1);
            f->sweep(s, v, 0, w, out + 2 * step);
            for (e = 0; e < n; ++e) w[e] = v[e] - w[e];
            ms_mcml__precondition(s, w);
            for (i = 0; i <= step; ++i) {
                const double *b = basis + (size_t)i * n;
                column[i] = x = f->inner(w, b, n);
                f->add(w, -x, b, n);
            }
            column[step + 1] = x = sqrt(f->inner(w, w, n));
            for (e = 0; e < n && x > 0; ++e) w[e] *= 1 / x;
            for (i = 0; i < step; ++i) {
                const double a = column[i], b = column[i + 1];
                column[i] = cs[i] * a + sn[i] * b;
                column[i + 1] = cs[i] * b - sn[i] * a;
            }
            x = sqrt(column[step] * column[step] + column[step + 1] * column[step + 1]);
            if (!(x > 0)) break;
            cs[step] = column[step] / x;
            sn[step] = column[step + 1] / x;
            column[step] = x;
            g[step + 1] = -sn[step] * g[step];
            g[step] *= cs[step];
            residual = fabs(g[step + 1]) / size;
        }
        for (i = step - 1; i >= 0; --i) {
            for (j = i + 1; j < step; ++j) g[i] -= h[j * (SPAN + 1) + i] * g[j];
            g[i] /= h[i * (SPAN + 1) + i];
        }
        for (i = 0; i < step; ++i) {
            f->add(d, g[i], basis + (size_t)i * n, n);
            leave[0] += g[i] * out[2 * i];
            leave[1] += g[i] * out[2 * i + 1];
        }
        if (!(residual > tolerance)) break;
    }
    return residual;
}

static double ms_mcml__moment(const ms_mcml__solver_layer *y, int l)
{
    return l == 0 ? 1 : fabs(y->g) > 0 ? pow(y->g, l) : 0;
}

/* Attenuation far from everything: the least root of h_0 - k^2 / (3 h_1 - (2 k)^2 / (5 h_2 - ...)), h_l = mu_t -
   sigma_l, of the equations of spherical harmonics (Case & Zweifel 1967); it cannot exceed mu_t. */
static double ms_mcml__attenuation(const ms_mcml__solver_layer *y, int order)
{
    double low = 0, high = sqrt(3 * y->mu_a * (y->mu_t - y->sigma[1]));
    int i, l;
    if (high > y->mu_t) high = y->mu_t;
    for (i = 0; i < 60; ++i) {
        const double k = 0.5 * (low + high);
        double d = (2 * 40 + 1) * y->mu_t;
        for (l = 39; l >= 0 && d > 0; --l)
            d = (2 * l + 1) * (l == 0 ? y->mu_a : y->mu_t - (l <= order ? y->sigma[l] : 0)) -
                (l + 1.0) * (l + 1.0) * k * k / d;
        if (d > 0) low = k;
        else high = k;
    }
    return low;
}

/* The arrays of s, one block; arena->base NULL: only counts. */
static void ms_mcml__sweeps_place(ms__arena *arena, ms_mcml__sweeps *s, int most)
{
    const size_t ray = MS_MCML__RAYS * sizeof(double), size = sizeof(double), layers = (size_t)s->layers;
    const size_t azimuths = most > 0 ? (size_t)s->azimuths_most : 1, sheets = (size_t)most + 1;
    const size_t blocks = (size_t)((s->break_count + 1) * s->parts), even = MS_MCML__EVEN_MAX;
    const size_t terms = (size_t)ms_mcml__first_term(s->order, most + 1), nz = (size_t)(s->nodes + 7 * s->layers);
    s->nu = (double *)ms__take(arena, blocks, ray);
    s->nu_weight = (double *)ms__take(arena, blocks, ray);
    s->cosine = (double *)ms__take(arena, blocks * azimuths, ray);
    s->azimuth_weight = (double *)ms__take(arena, blocks * azimuths, ray);
    s->azimuthal = (double *)ms__take(arena, blocks * azimuths * sheets, ray);
    s->mu = (double *)ms__take(arena, blocks * layers, ray);
    s->theta = (double *)ms__take(arena, blocks * layers * terms, ray);
    s->table = (double *)ms__take(arena, blocks * azimuths * (size_t)s->shapes * 48, ray);
    s->transfer = (double *)ms__take(arena, blocks * layers * azimuths * 10, ray);
    s->edge = (double *)ms__take(arena, blocks * layers * 5, ray);
    s->depth = (double *)ms__take(arena, nz, size);
    s->beam = (double *)ms__take(arena, 2 * nz, size);
    s->q = (double *)ms__take(arena, terms * nz, size);
    s->source = (double *)ms__take(arena, 2 * sheets * nz, ray);
    s->line = (double *)ms__take(arena, 4 * nz, ray);
    s->down = (double *)ms__take(arena, 2 * nz, ray);
    s->up = (double *)ms__take(arena, 2 * nz, ray);
    s->both = (double *)ms__take(arena, azimuths * 4 * nz, ray);
    s->moments = (double *)ms__take(arena, 3 * terms * (size_t)s->nodes, size);
    s->x = (double *)ms__take(arena, terms * nz, size);
    s->preconditioner.block = (double *)ms__take(arena, nz * 2 * even * even, size);
    s->preconditioner.right = (double *)ms__take(arena, (nz + 1) * even, size);
    s->vectors = (double *)ms__take(
        arena, (MS_MCML__GMRES_STEPS + 1) * (terms * nz + MS_MCML__GMRES_STEPS) + 2 * MS_MCML__GMRES_STEPS, size);
}

/* Adds a layer without its forward peak, and its panels. depth: optical thickness of the layers above. */
static void ms_mcml__add_layer(ms_mcml__sweeps *s, const ms_mcml_layer *layer, int most, double depth)
{
    ms_mcml__solver_layer *y = &s->layer[s->layers++];
    double h[MS_MCML__PANELS_MAX + 8], f, scale, z = 0;
    int j, p;
    y->n = layer->n;
    y->d = layer->thickness_cm;
    y->g = layer->g;
    y->mu_s_full = layer->g < 1 ? layer->mu_s_per_cm : 0;
    f = y->mu_s_full > 0 ? ms_mcml__moment(y, s->order + 1) : 0;
    if (!(f > 0) || ms_mcml__moment(y, 1) < 0) f = 0; /* a peak that is not forward has to be resolved */
    y->mu_s = y->mu_s_full * (1 - f);
    y->mu_a = layer->mu_a_per_cm > 1e-12 * y->mu_s ? layer->mu_a_per_cm : 1e-12 * y->mu_s; /* so that depth ends */
    y->mu_t = y->mu_a + y->mu_s;
    y->clear = !(y->mu_t > 0);
    if (y->clear) {
        s->clear = 1;
        s->mu_least = fmin(s->mu_least, 1 / y->d);
        return;
    }
    for (j = 0; j <= s->order; ++j) y->sigma[j] = y->mu_s_full * (ms_mcml__moment(y, j) - f);
    y->kappa = ms_mcml__attenuation(y, s->order);
    if (y->kappa * y->d > 23) {
        y->semi = 1;
        y->d = 23 / y->kappa;
    }
    scale = y->mu_t * y->d > 1 ? y->mu_t : 1 / y->d;
    s->mu_least = fmin(s->mu_least, scale);
    y->panels = y->used = ms_mcml__mesh(y->mu_t * y->d, y->semi, depth,
                                        y->kappa < 0.7 * y->mu_t ? 0.7 * y->mu_t / y->kappa : 1,
                                        most > 0 && s->order > 3 ? 2 : 1, h);
    y->panel = s->panels;
    y->deep = s->nodes;
    y->table = s->shapes;
    for (p = 0; p < y->panels; ++p) {
        const double length = h[p] / y->mu_t;
        for (j = 0; j < y->shapes && fabs(y->shape[j] - length) > 1e-9 * length; ++j) {}
        if (j == MS_MCML__SHAPES) --j; /* cannot be: lengths repeat or grow */
        else if (j == y->shapes) y->shape[y->shapes++] = length;
        s->panel_shape[s->panels++] = j;
        for (j = 0; j < 4; ++j) s->z[s->nodes++] = z + length * ms_mcml__lobatto[j];
        z += length;
    }
    s->z[s->nodes++] = y->d = z;
    s->shapes += y->shapes;
}

/* Where a panel of nu ends: at every index that light can come from or go to, in ascending order. */
static void ms_mcml__find_breaks(ms_mcml__sweeps *s)
{
    double all[MS_MCML__LAYERS_MAX + 2], highest = 0;
    int i, j, n = 0;
    all[n++] = s->n_above;
    if (!s->layer[s->layers - 1].semi) all[n++] = s->n_below;
    for (i = 0; i < s->layers; ++i) {
        all[n++] = s->layer[i].n;
        if (!s->layer[i].clear) highest = fmax(highest, s->layer[i].n);
    }
    for (i = 0; i < n; ++i) {
        double x;
        for (j = i + 1; j < n; ++j)
            if (all[j] < all[i]) {
                x = all[i];
                all[i] = all[j];
                all[j] = x;
            }
        x = fmin(all[i], highest);
        if (s->break_count == 0 || x > s->breaks[s->break_count - 1] * (1 + 1e-9)) s->breaks[s->break_count++] = x;
    }
}

/* Layers, panels, and room for frequencies with m up to most. order 1: isotropic scattering only. */
static ms_status ms_mcml__sweeps_make(ms_mcml__sweeps **out, const ms_mcml_tissue *tissue,
                                      const ms_mcml_layered_options *o, int order, int parts, int most, ms_error *error)
{
    ms__arena arena = {NULL, 0};
    size_t terms;
    ms_mcml__sweeps *s = (ms_mcml__sweeps *)ms__alloc(&o->allocator, sizeof *s);
    double depth = 0, thickest = 0;
    int i;
    if (s == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the layers", sizeof *s);
    memset(s, 0, sizeof *s);
    s->kernels = ms_mcml__kernels_of(ms__simd_pick(o->simd));
    s->order = order;
    s->parts = parts;
    s->azimuths_most = (2 * most + 5) / 4 > 14 ? (2 * most + 5) / 4 : 14;
    s->n_above = tissue->n_above;
    s->n_below = tissue->n_below;
    s->mu_least = 1e300;
    for (i = 0; i < tissue->layer_count && !(i > 0 && s->layer[i - 1].semi); ++i) {
        ms_mcml__add_layer(s, &tissue->layers[i], most, depth);
        thickest = fmax(thickest, tissue->layers[i].thickness_cm);
        depth += s->layer[i].mu_t * s->layer[i].d;
    }
    if (s->mu_least > 1e200) s->mu_least = 1 / thickest;
    ms_mcml__find_breaks(s);
    ms_mcml__sweeps_place(&arena, s, most);
    s->size = arena.used;
    arena.base = (char *)ms__alloc(&o->allocator, s->size);
    if (arena.base == NULL) {
        const size_t size = s->size;
        ms__release(&o->allocator, s, sizeof *s);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the layered solver", size);
    }
    arena.used = 0;
    ms_mcml__sweeps_place(&arena, s, most);
    s->memory = arena.base;
    terms = (size_t)ms_mcml__first_term(order, most + 1);
    memset(s->moments, 0, 3 * terms * (size_t)s->nodes * sizeof(double));
    memset(s->x, 0, terms * (size_t)(s->nodes + 7 * s->layers) * sizeof(double));
    ms_mcml__beams(s);
    *out = s;
    return MS_OK;
}

static void ms_mcml__sweeps_destroy(ms_mcml__sweeps *s, const ms_allocator *allocator)
{
    if (s == NULL) return;
    ms__release(allocator, s->memory, s->size);
    ms__release(allocator, s, sizeof *s);
}

/* All that depends on frequency k; how many panels light reaches there and back (to 1e-9). */
static void ms_mcml__set_frequency(ms_mcml__sweeps *s, double k)
{
    const double ratio = k / s->mu_least, t = ratio / (1 + sqrt(1 + ratio * ratio));
    int most = t > 0 ? (int)ceil(log(1e-5) / log(t)) : 0, layer, p,
        node; /* what m > 0 gives back to m = 0 falls twice as fast */
    double depth = 0;
    if (most > s->order) most = s->order;
    for (layer = 0; layer < s->layers; ++layer) {
        ms_mcml__solver_layer *y = &s->layer[layer];
        const double slant = sqrt(y->kappa * y->kappa + k * k),
                     kappa = s->full_depth && slant > y->mu_t ? y->mu_t : slant;
        for (p = 0; p < y->panels && depth < 20; ++p) depth += kappa * y->shape[s->panel_shape[y->panel + p]];
        y->used = y->clear ? 0 : p;
    }
    s->active = 0;
    for (layer = 0; layer < s->layers; ++layer) {
        ms_mcml__solver_layer *y = &s->layer[layer];
        if (y->used == 0) continue;
        y->node = s->active;
        y->end = y->node + 4 * y->used;
        s->active = (y->end + 8) / 8 * 8;
        for (node = y->node; node < s->active; ++node) {
            const double z = node <= y->end ? s->z[y->deep + node - y->node] : 0, down = y->mu_t * z,
                         up = y->mu_t * (y->d - z);
            s->depth[node] = z;
            s->beam[node] = node <= y->end && down < 700 ? y->down * exp(-down) : 0;
            s->beam[s->nodes + 7 * s->layers + node] = node <= y->end && up < 700 && !y->semi ? y->up * exp(-up) : 0;
        }
    }
    ms_mcml__rays(s, k, most);
    ms_mcml__boundaries(s);
    memset(s->both, 0, (size_t)s->azimuths * (size_t)s->active * 4 * MS_MCML__RAYS * sizeof(double));
    ms_mcml__preconditioner_make(s, s->order < 3 ? s->order : s->order > 15 ? 5 : 3);
}

/* What the beam scatters once in the top layer and what then leaves at once, at the frequency at hand, in the moments'
   phase function. */
static double ms_mcml__single_spectrum(const ms_mcml__sweeps *s)
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *y = &s->layer[0];
    double sum = 0;
    int b, a, j, l;
    if (y->clear) return 0;
    for (b = 0; b < s->blocks; ++b)
        for (j = 0; j < R; ++j) {
            const double nu = s->nu[b * R + j], r = ms_mcml__fresnel_nu(y->n, s->n_above, nu),
                         mu = s->mu[b * s->layers * R + j];
            double p0 = 1, p1 = -mu, phase = y->sigma[0];
            if (!(r < 1)) continue;
            for (l = 1; l <= s->order; ++l) {
                const double next = ((2 * l + 1) * -mu * p1 - l * p0) / (l + 1);
                phase += (2 * l + 1) * y->sigma[l] * p1;
                p0 = p1;
                p1 = next;
            }
            for (a = 0; a < s->azimuths; ++a) {
                const double re = y->mu_t * (1 + 1 / mu),
                             im = s->k * nu / (y->n * mu) * s->cosine[(b * s->azimuths + a) * R + j];
                const double e = re * y->d < 700 ? exp(-re * y->d) : 0, top = 1 - e * cos(e > 0 ? im * y->d : 0);
                const double side = e * sin(e > 0 ? im * y->d : 0);
                sum += 4 * s->nu_weight[b * R + j] * s->azimuth_weight[(b * s->azimuths + a) * R + j] * nu /
                    (y->n * y->n) * (1 - r) * y->down * phase * 0.079577471545947668 / mu * (top * re + side * im) /
                    (re * re + im * im);
            }
        }
    return sum;
}

/* The same in space, with the whole phase function: energy of each ray beyond r. */
static void ms_mcml__singles(const ms_mcml__sweeps *s, ms_mcml_layered *out)
{
    const ms_mcml__solver_layer *y = &s->layer[0];
    const double least = y->n > s->n_above ? sqrt(1 - s->n_above * s->n_above / (y->n * y->n)) : 0;
    double x[MS_MCML_LAYERED_SINGLES], w[MS_MCML_LAYERED_SINGLES];
    int j;
    if (y->clear || !(y->mu_s_full > 0)) return;
    ms_mcml__legendre_nodes(MS_MCML_LAYERED_SINGLES, x, w);
    for (j = 0; j < MS_MCML_LAYERED_SINGLES; ++j) {
        const double mu = least + (1 - least) * x[j] * x[j], sine = sqrt((1 - mu) * (1 + mu)),
                     rate = y->mu_t * (1 + 1 / mu);
        const double phase = (1 - y->g * y->g) / pow(1 + y->g * y->g + 2 * y->g * mu, 1.5);
        out->single_rate_per_cm[j] = rate * mu / sine;
        out->single_end[j] = y->semi ? 0 : exp(-rate * y->d);
        out->single_energy[j] = (1 - least) * x[j] * w[j] * (1 - ms_mcml__fresnel_nu(y->n, s->n_above, y->n * sine)) *
            y->down * y->mu_s_full * phase / rate;
    }
    out->singles = MS_MCML_LAYERED_SINGLES;
}

/* J1(x), x >= 0, to 1e-9: the power series, beyond 12 Hankel's asymptotic one. */
static double ms_mcml__bessel_j1(double x)
{
    double sum = 0, term = 0.5 * x, p, q, y;
    int i;
    if (x < 12) {
        for (i = 1; i < 40 && fabs(term) > 1e-17; ++i) {
            sum += term;
            term *= -0.25 * x * x / ((double)i * (i + 1));
        }
        return sum;
    }
    y = 1 / (x * x);
    p = 1 + y * (0.1171875 + y * (-0.144195556640625 + y * (0.6765925884246826 + y * (-6.883914268109947))));
    q = (0.375 + y * (-0.1025390625 + y * (0.277576446533203 + y * (-1.993531733751297 + y * 27.24882731126854)))) / x;
    return sqrt(0.63661977236758134 / x) * (p * cos(x - 2.3561944901923449) - q * sin(x - 2.3561944901923449));
}

/* A spectrum at arsinh(k / low) = u, from its values at whole multiples of a step of u: even and analytic out to 1.57
   off the axis, where k = i low, so that Lagrange's polynomial through twelve of them is good to 1e-6 and better;
   beyond them a power that fades; steeper is added to it. */
static double ms_mcml__between_samples(const double *y, int logarithms, int count, double step, double u,
                                       double steeper)
{
    const double t = u / step, last = count - 1;
    double sum = 0, weights = 0, binomial = 1;
    int i = (int)t, half, j;
    if (t >= last) {
        const double a = u - last * step, y0 = y[count - 2], y1 = y[count - 1];
        const double decay = logarithms ? (y0 - y1) / step : y0 * y1 > 0 ? log(y0 / y1) / step : 8;
        if (!(a < 2.5)) return 0;
        return (logarithms ? exp(y1) : y1) * exp(-a * (steeper + fmin(fmax(decay, 1), 8))) * (1 - a * a / 6.25);
    }
    half = count - 1 - i < 6 ? count - 1 - i : 6;
    for (j = 0; j < 2 * half; ++j) {
        const int node = i + 1 - half + j;
        const double d = t - node, w = binomial / (fabs(d) > 1e-12 ? d : 1e-12);
        binomial = binomial * (j + 1 - 2 * half) / (j + 1); /* exact: (-1)^j of 2 half - 1 over j */
        sum += w * y[node < 0 ? -node : node];
        weights += w;
    }
    return logarithms ? exp(sum / weights) : sum / weights;
}

/* J1 at Gauss nodes x = k r of panels that grow by a quarter and are at most 1.2 long: the same for every radius. */
typedef struct ms_mcml__waves {
    int panels;
    double edge[MS_MCML__WAVES + 1], x[MS_MCML__WAVES][4], logarithm[MS_MCML__WAVES][4];
    double j1[MS_MCML__WAVES][4], faded[MS_MCML__WAVES][4]; /* times weight and length; ended smoothly at 400 */
} ms_mcml__waves;

static const double ms_mcml__gauss[4] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                         0.93056815579702629};
static const double ms_mcml__gauss_weight[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                                0.17392742256872693};

/* From x = first to 400. */
static void ms_mcml__waves_make(ms_mcml__waves *w, double first)
{
    int p, q;
    w->edge[0] = first;
    for (p = 0; p < MS_MCML__WAVES && w->edge[p] < 400; ++p) {
        const double from = w->edge[p], size = fmin(fmin(0.25 * from, 1.2), 400 - from);
        for (q = 0; q < 4; ++q) {
            const double x = from + size * ms_mcml__gauss[q], fade = x / 160;
            w->x[p][q] = x;
            w->logarithm[p][q] = log(2 * x);
            w->j1[p][q] = size * ms_mcml__gauss_weight[q] * ms_mcml__bessel_j1(x);
            w->faded[p][q] = w->j1[p][q] * exp(-fade * fade * fade * fade);
        }
        w->edge[p + 1] = 400 - from > size ? from + size : 400;
    }
    w->panels = p;
}

/* A table of f at whole numbers from -1 on, at t >= 0: a cubic through four values. */
static double ms_mcml__cubic(const double *f, int most, double t)
{
    const double *y = f + ((int)t < most - 4 ? (int)t : most - 4);
    t -= (double)(y - f);
    return t * (t - 1) / 6 * ((t + 1) * y[3] - (t - 2) * y[0]) + (t + 1) * (t - 2) / 2 * ((t - 1) * y[1] - t * y[2]);
}

/* outside[i]: energy farther out than r_first exp(0.1 i), the Hankel transform of a spectrum: f(0) - r integral f(k)
   J1(k r) dk, out to 40 / low; where waves are many a window ends them smoothly, which changes nothing as far out. What
   has little fall between its first and last frequency is smoothest in logarithms, what falls like a bell is not. */
static void ms_mcml__hankel(const double *value, int side, int count, double low, double step, double r_first,
                            double steeper, const ms_mcml__waves *w, double *f, double *outside)
{
    const double last = low * sinh(step * (count - 1) + 2.5);
    const int logarithms = side && count > 0 && value[count - 1] > 1e-3 * value[0];
    double y[MS_MCML_LAYERED_RATES]; /* f: room for the same eight times as fine, from -1 on */
    const int most = (int)((count - 1 + 2.5 / step) * 8) + 3;
    int i, q, p, first = 0;
    memset(outside, 0, MS_MCML_LAYERED_RADII * sizeof *outside);
    if (count < 4) return;
    for (i = 0; i < count; ++i) y[i] = logarithms ? log(value[i]) : value[i];
    for (i = 0; i < most; ++i)
        f[i] = ms_mcml__between_samples(y, logarithms, count, step, fabs(0.125 * step * (i - 1)), steeper);
    for (i = 0; i < MS_MCML_LAYERED_RADII; ++i) {
        const double r = r_first * exp(0.1 * i), unit = r * low, shift = log(unit), end = fmin(last * r, 400);
        double sum = 0, ends[2][2];
        if (unit > 40) break;
        while (first < w->panels && w->edge[first + 1] <= fmin(0.25 * unit, end)) ++first;
        for (p = first; p < w->panels && w->edge[p + 1] <= end; ++p) {
            const double *j1 = last * r < 400 ? w->j1[p] : w->faded[p];
            for (q = 0; q < 4; ++q) {
                const double x = w->x[p][q] / unit;
                const double u = x > 20 ? w->logarithm[p][q] - shift + (0.25 - 0.09375 / (x * x)) / (x * x)
                                        : log(x + sqrt(1 + x * x));
                sum += j1[q] * ms_mcml__cubic(f, most, 8 / step * u);
            }
        }
        ends[0][0] = 0; /* before the first panel and after the last whole one */
        ends[0][1] = fmin(w->edge[first], end);
        ends[1][0] = w->edge[p];
        ends[1][1] = end;
        for (p = 0; p < 2; ++p)
            for (q = 0; q < 4 && ends[p][1] > ends[p][0]; ++q) {
                const double size = ends[p][1] - ends[p][0], x = (ends[p][0] + size * ms_mcml__gauss[q]) / unit;
                sum += size * ms_mcml__gauss_weight[q] * ms_mcml__bessel_j1(x * unit) *
                    ms_mcml__cubic(f, most, 8 / step * log(x + sqrt(1 + x * x)));
            }
        outside[i] = value[0] - sum;
    }
}

/* Energies >= 0 of rates that give a spectrum whose values are known to noise x scale; the largest misfit over its
   noise. Half- spaces of isotropic scattering have such a spectrum, and many others. */
static double ms_mcml__positive_fit(const double *k, const double *value, const double *scale, const double *noise,
                                    int count, const double *rate, int rates, double *energy, double *a)
{
    enum { MOST = MS_MCML_LAYERED_RATES };
    ms_mcml__nnls p;
    double norm[MOST], misfit = 0, *target;
    int i, j;
    p.rows = count;
    p.columns = rates;
    p.tolerance = 1e-6;
    ms_mcml__nnls_place(&p, a, MOST, MOST, &target);
    for (i = 0; i < count; ++i) target[i] = value[i] / (noise[i] * scale[i]);
    for (j = 0; j < rates; ++j) {
        for (i = 0; i < count; ++i)
            a[j * count + i] = 1 / (noise[i] * scale[i] * (1 + k[i] / rate[j] * (k[i] / rate[j])));
        norm[j] = ms_mcml__nnls_unit(a + j * count, count);
    }
    ms_mcml__nnls_solve(&p);
    for (i = 0; i < count; ++i)
        if (fabs(p.residual[i]) > misfit) misfit = fabs(p.residual[i]);
    for (j = 0; j < rates; ++j) energy[j] = p.x[j] * norm[j];
    return misfit;
}

/* The spatial frequencies k = low sinh(step i) of a solution, and the spectra there: what leaves the top after two
   collisions and more, and all scattered light that leaves the bottom. */
typedef struct ms_mcml__spectra {
    int count, positive; /* positive: the top's spectrum is a sum of positive terms (isotropic half-space) */
    double low, step, most, mu_t, k[MS_MCML_LAYERED_RATES], noise[MS_MCML_LAYERED_RATES];
    double value[2][MS_MCML_LAYERED_RATES], scale[2][MS_MCML_LAYERED_RATES];
} ms_mcml__spectra;

/* Accuracy of the iteration at k, relative to the tolerance. Low frequencies make the far tail and cost little. */
static double ms_mcml__residual_scale(const ms_mcml__spectra *p, double k)
{
    const double x = k / p->mu_t, care = x / 0.3;
    return x > 3 ? fmin(x / 3, 10) : x > 0.3 ? 1 : care > 0.03 ? care * care : 1e-3;
}

/* From the slowest attenuation or the thickness, the longer of the two lengths, to 40 mu_t. */
static void ms_mcml__frequencies(const ms_mcml__sweeps *s, double tolerance, ms_mcml__spectra *p, ms_mcml_layered *out)
{
    const int semi = s->layer[s->layers - 1].semi;
    double finest = 0, coarsest = 1e300, deepest = 0, more;
    int i;
    memset(p, 0, sizeof *p);
    p->low = 1e300;
    for (i = 0; i < s->layers; ++i) {
        const ms_mcml__solver_layer *y = &s->layer[i];
        deepest += y->d;
        p->mu_t = fmax(p->mu_t, y->mu_t);
        p->low = fmin(p->low, y->kappa);
        finest = fmax(finest, y->mu_t - y->sigma[1]);
        coarsest = fmin(coarsest, y->mu_t - y->sigma[1]); /* light that is guided in a weak layer goes far */
    }
    if (!semi) p->low = fmax(p->low, 1 / (deepest + 4 / coarsest));
    p->low = fmax(p->low, 1e-4 * finest);
    p->most = fmax(40 / deepest, 20 * p->mu_t); /* beyond, rays are too few for what leaves at the bottom */
    p->step = fmax(semi ? 0.25 : 0.2, log(150 * p->mu_t / p->low) / (MS_MCML_LAYERED_RATES - 6));
    for (i = 0; i < MS_MCML_LAYERED_RATES; ++i) {
        const double k = p->low * sinh(p->step * i);
        if (k > 40 * p->mu_t) break;
        p->k[i] = k;
        p->noise[i] = tolerance * (0.1 * fmax(ms_mcml__residual_scale(p, k), 0.03) + k / p->mu_t * (0.5 + k / p->mu_t));
        p->count = i + 1;
    }
    out->rate_per_cm[0] = p->low;
    for (i = 1; i < MS_MCML_LAYERED_RATES && p->low * exp(0.8 * p->step * (i - 4)) < 150 * p->mu_t; ++i) {
        more = exp(0.8 * p->step * (i - 4));
        out->rate_per_cm[i] = p->low * sqrt(1 + more * more);
    }
    out->rates = i;
}

/* The next frequency starts from the moments of the last three, extrapolated. */
static void ms_mcml__extrapolate(ms_mcml__sweeps *s, int i)
{
    const size_t n3 = (size_t)s->nodes, all = (size_t)ms_mcml__first_term(s->order, s->order + 1) * n3;
    double *d = s->moments, *before = d + all, *earlier = before + all;
    int layer, j, node;
    memset(s->x, 0, (size_t)s->terms * (size_t)s->active * sizeof(double));
    for (layer = 0; layer < s->layers; ++layer) {
        const ms_mcml__solver_layer *y = &s->layer[layer];
        for (j = 0; j < s->terms && y->used; ++j)
            for (node = y->node; node <= y->end; ++node) {
                const size_t full = (size_t)j * n3 + (size_t)(y->deep + node - y->node);
                const double here = d[full], last = before[full];
                s->x[(size_t)j * (size_t)s->active + (size_t)node] = i > 2 ? 3 * (here - last) + earlier[full]
                    : i < 2                                                ? here
                    : j <= s->order                                        ? 4 * here - 3 * last
                                                                           : here;
                before[full] = here;
                earlier[full] = last;
            }
    }
}

/* Solves at every stride-th frequency. */
static ms_status ms_mcml__spectra_solve(ms_mcml__sweeps *s, const ms_mcml_layered_options *o, double tolerance,
                                        int stride, ms_mcml__spectra *p, ms_mcml_layered *out, ms_error *error)
{
    const size_t n3 = (size_t)s->nodes;
    int i, j, layer;
    for (i = 0; i < p->count; i += stride) {
        double leave[2], residual, care = ms_mcml__residual_scale(p, p->k[i]);
        if (o->progress.report &&
            o->progress.report(o->progress.user, (stride > 1 ? 0.85 : 0.1) + (stride > 1 ? 0.15 : 0.75) * i / p->count))
            return ms__fail(error, MS_CANCELLED, 0, "stopped by the progress callback");
        s->full_depth = !s->layer[s->layers - 1].semi && p->k[i] < p->most &&
            (i < 3 * stride || p->value[1][i - stride] > 1e-7 * p->value[1][0]);
        ms_mcml__set_frequency(s, p->k[i]);
        ms_mcml__extrapolate(s, i / stride);
        residual = ms_mcml__gmres(s, s->x, care * tolerance, leave);
        for (layer = 0; layer < s->layers; ++layer) {
            const ms_mcml__solver_layer *y = &s->layer[layer];
            for (j = 0; j < s->terms && y->used; ++j)
                memcpy(s->moments + (size_t)j * n3 + y->deep, s->x + (size_t)j * (size_t)s->active + y->node,
                       (size_t)(4 * y->used + 1) * sizeof(double));
        }
        out->residual = fmax(out->residual, residual / care);
        p->value[0][i] = leave[0] - ms_mcml__single_spectrum(s);
        p->value[1][i] = leave[1];
        p->scale[0][i] = leave[0];
        p->scale[1][i] = fabs(leave[1]) + 1e-6 * fabs(p->value[1][0]);
    }
    return MS_OK;
}

/* A spectrum that is known at every third frequency, at the others by its ratio to a finer one. */
static void ms_mcml__interpolate_spectrum(ms_mcml__spectra *p, const ms_mcml__spectra *fine)
{
    double ratio[MS_MCML_LAYERED_RATES / 3 + 1] = {1};
    int side, i;
    for (side = 0; side < 2; ++side) {
        const double *f = fine->value[side];
        for (i = 0; i < p->count; i += 3)
            ratio[i / 3] = fabs(f[i]) > 1e-6 * fabs(f[0]) ? p->value[side][i] / f[i] : ratio[i > 0 ? i / 3 - 1 : 0];
        for (i = 0; i < p->count; ++i)
            if (i % 3) {
                p->value[side][i] = f[i] *
                    ms_mcml__between_samples(ratio, 0, (p->count + 2) / 3, 3 * p->step,
                                             p->step * fmin(i, (p->count - 1) / 3 * 3), 0);
                p->scale[side][i] = p->scale[side][i - 1];
            }
    }
}

/* Inverts the spectra to `out`, [2]: positive terms as far as they fit, and a table of the rest. stride: of the
   frequencies; steeper: the power by which spectra fall faster beyond the last frequency. a: workspace. */
static void ms_mcml__spectra_invert(const ms_mcml__spectra *p, int stride, double steeper, const ms_mcml_layered *s,
                                    int semi, const ms_mcml__waves *waves, double *a, ms_mcml_layered_side out[2])
{
    enum { MOST = MS_MCML_LAYERED_RATES };
    double k[MOST], scale[MOST], noise[MOST], v[MOST];
    int side, i, j, count = (p->count + stride - 1) / stride, fits = 0;
    for (i = 0; i < count; ++i) {
        k[i] = p->k[i * stride];
        scale[i] = p->scale[0][i * stride];
        noise[i] = p->noise[i * stride];
    }
    memset(out, 0, 2 * sizeof *out);
    for (side = 0; side < 2; ++side) {
        ms_mcml_layered_side *y = &out[side];
        y->radius_cm = 0.02 / p->mu_t;
        if (!(p->scale[side][0] > 0) || (side && semi)) continue;
        for (i = 0; i < count; ++i) v[i] = p->value[side][i * stride];
        if (side == 0) /* transmission falls faster than any sum of such terms */
            fits = ms_mcml__positive_fit(k, v, scale, noise, count, s->rate_per_cm, s->rates, y->energy, a) < 5 ||
                p->positive;
        y->multiple = v[0];
        for (i = 0; i < count; ++i)
            for (j = 0; j < s->rates; ++j)
                v[i] -= y->energy[j] / (1 + k[i] / s->rate_per_cm[j] * (k[i] / s->rate_per_cm[j]));
        for (i = 0; i < count && side == 0 && fits; ++i)
            v[i] /= 1 + pow(k[i] / (2 * p->mu_t), 4); /* there the fit is better than rays */
        for (i = side ? 2 : count; i < count && k[i] < p->most && v[i] > 1e-7 * v[0]; ++i) {
        } /* as far as it is known */
        y->last_per_cm = i > 0 ? k[i - 1] : 0;
        ms_mcml__hankel(v, side, i, p->low, p->step * stride, y->radius_cm, steeper, waves, a, y->outside);
        y->remainder = v[0];
    }
}

/* Absorbed above z of a layer, of the solution at k = 0. */
static double ms_mcml__absorbed(const ms_mcml__sweeps *s, const ms_mcml__solver_layer *y, double z)
{
    static const double gauss[3] = {0.11270166537925831, 0.5, 0.88729833462074169},
                        weight[3] = {5 / 18.0, 8 / 18.0, 5 / 18.0};
    const double *d = s->x, *t = ms_mcml__lobatto;
    double sum = 0, start = 0;
    int p, q, i, j;
    if (y->clear) return 0;
    for (p = 0; p < y->used && start < z; ++p) {
        const double h = y->shape[s->panel_shape[y->panel + p]], part = z < start + h ? (z - start) / h : 1;
        for (q = 0; q < 3; ++q) {
            const double u = part * gauss[q];
            double x = 0;
            for (i = 0; i < 5; ++i) {
                double c = 1;
                for (j = 0; j < 5; ++j) c *= j == i ? 1 : (u - t[j]) / (t[i] - t[j]);
                x += c * d[y->node + 4 * p + i];
            }
            sum += weight[q] * part * h * x * 3.5449077018110318 * y->mu_a; /* sqrt(4 pi) */
        }
        start += h;
    }
    if (z > start) z = start;
    sum += y->down * y->mu_a / y->mu_t * (1 - exp(-y->mu_t * z < -700 ? -700 : -y->mu_t * z));
    if (!y->semi) sum += y->up * y->mu_a / y->mu_t * (exp(-y->mu_t * (y->d - z)) - exp(-y->mu_t * y->d));
    return sum;
}

/* Limit of three totals of growing order by Shanks; their errors alternate in sign. *error grows to its estimated
 * error. */
static double ms_mcml__limit(const double *v, double *error)
{
    const double d = v[1] - v[0], e = v[2] - v[1],
                 remainder = e * d < 0 && fabs(e) < 1.2 * fabs(d) ? e * e / (e - d) : 0;
    if (!(fabs(e) > 1e-9)) return v[2];
    *error = fmax(*error,
                  1e-7 + (fabs(remainder) > 0 ? (fabs(e) < 0.8 * fabs(d) ? 0.05 : 0.2) * fabs(remainder) : fabs(e)));
    return v[2] - remainder;
}

/* Totals by one order, one frequency. */
static ms_status ms_mcml__totals(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *o, int order, int last,
                                 ms_mcml_layered *out, ms_error *error)
{
    ms_mcml__sweeps *s;
    double leave[2], residual;
    int i, layer, first;
    ms_status status = ms_mcml__sweeps_make(&s, tissue, o, order, order > 15 ? 3 : 2, 0, error);
    if (status) return status;
    for (first = 0; first < tissue->layer_count && s->layer[first < s->layers ? first : s->layers - 1].clear; ++first) {
    }
    out->specular = ms_mcml__specular(tissue, first);
    ms_mcml__set_frequency(s, 0);
    residual = ms_mcml__gmres(s, s->x, 1e-8, leave);
    if (residual > out->residual && residual > 1e-6) out->residual = residual;
    out->rd = leave[0] + s->specular - out->specular;
    out->tt = leave[1] + s->unscattered;
    for (out->a = 0, layer = 0; layer < s->layers; ++layer)
        out->a += ms_mcml__absorbed(s, &s->layer[layer], s->layer[layer].d);
    if (last) {
        double top = 0;
        for (i = 0; o->a_z && i < o->nz; ++i) o->a_z[i] = 0;
        for (layer = 0; layer < tissue->layer_count; ++layer) {
            const ms_mcml__solver_layer *y = &s->layer[layer];
            const double all = layer < s->layers ? ms_mcml__absorbed(s, y, y->d) : 0,
                         end = tissue->layers[layer].thickness_cm;
            double before = 0;
            if (o->a_l) o->a_l[layer] = all;
            for (i = 0; o->a_z && i < o->nz && all > 0; ++i) {
                const double from = i * o->dz_cm, to = from + o->dz_cm;
                double here;
                if (to <= top || from >= top + end) continue;
                here = i + 1 == o->nz ? all : ms_mcml__absorbed(s, y, to - top < y->d ? to - top : y->d);
                o->a_z[i] += (here - before) / o->dz_cm;
                before = here;
            }
            top += end;
        }
        for (i = 0; i < s->layers; ++i) /* unscattered as MCML means it: the forward peak counts as scattered */
            s->layer[i].mu_t = s->layer[i].mu_a + s->layer[i].mu_s_full;
        ms_mcml__beams(s);
        out->rd_unscattered = s->specular - out->specular;
        out->tt_unscattered = s->unscattered;
    }
    ms_mcml__sweeps_destroy(s, &o->allocator);
    return MS_OK;
}

/* Multiple scattering that leaves beyond r: terms, and a cubic through the nearest four of the table, of logarithms for
   transmission; a paraboloid before its start. */
static double ms_mcml__layered_multiple(const ms_mcml_layered *s, const ms_mcml_layered_side *y, int logarithms,
                                        double r)
{
    const double u = 10 * log(r / y->radius_cm);
    double sum = 0, t, d0, d1, at[4];
    int i, j;
    if (r > y->tail_cm) {
        t = y->decay_per_cm * (r - y->tail_cm);
        return t < 700 ? y->tail * exp(-t) : 0;
    }
    for (i = 0; i < s->rates && s->rate_per_cm[i] * r < 700; ++i)
        if (y->energy[i] > 0) sum += y->energy[i] * ms_mcml__x_bessel_k1(s->rate_per_cm[i] * r);
    if (u <= 0) return sum + y->remainder - (y->remainder - y->outside[0]) * (r / y->radius_cm) * (r / y->radius_cm);
    if (u >= MS_MCML_LAYERED_RADII - 3) return sum;
    i = (int)u;
    t = u - i;
    for (j = 0; j < 4; ++j) at[j] = y->outside[i > 0 || j > 0 ? i + j - 1 : 0];
    for (j = 0; j < 4 && logarithms; ++j) at[j] = log(at[j] > 1e-300 ? at[j] : 1e-300);
    d0 = i > 0 ? 0.5 * (at[2] - at[0]) : at[2] - at[1];
    d1 = 0.5 * (at[3] - at[1]);
    t = at[1] + t * (d0 + t * (3 * (at[2] - at[1]) - 2 * d0 - d1 + t * (2 * (at[1] - at[2]) + d0 + d1)));
    return sum + (logarithms ? exp(t) : t);
}

/* Scales a side to its total, and ends its table where 3e-7 of the energy is left, or where rounding makes it rise:
   from there the energy falls exponentially. Near the axis a small rise is the noise of the spectrum, not the tail. */
static void ms_mcml__layered_finish(const ms_mcml_layered *s, ms_mcml_layered_side *y, int side, double scattered)
{
    double sum = y->remainder, here, before, low;
    int i;
    for (i = 0; i < s->rates; ++i) sum += y->energy[i];
    if (scattered > 0 && sum > 0.5 * scattered && sum < 2 * scattered) {
        for (i = 0; i < s->rates; ++i) y->energy[i] *= scattered / sum;
        for (i = 0; i < MS_MCML_LAYERED_RADII; ++i) y->outside[i] *= scattered / sum;
        y->remainder *= scattered / sum;
        y->multiple = scattered;
    }
    here = before = y->multiple;
    low = 3e-7 * here;
    y->tail_cm = 1e300;
    for (i = 0; i < MS_MCML_LAYERED_RADII && here > 0; ++i) {
        const double radius = y->radius_cm * exp(0.1 * i), next = ms_mcml__layered_multiple(s, y, side, radius);
        if (i > 2 && !(next > low && (next < here || here > 3e-3 * y->multiple))) {
            const double last = y->radius_cm * exp(0.1 * (i - 1));
            y->tail_cm = last;
            y->tail = here;
            y->decay_per_cm = fmax(log(fmax(before / here, 1)) / (last * (1 - exp(-0.1))), s->rate_per_cm[0]);
            if (side && i + 1 < MS_MCML_LAYERED_RADII) { /* its slope there */
                y->outside[i] = fmax(next, here * here / before);
                y->outside[i + 1] = fmax(y->outside[i + 1], y->outside[i] * here / before);
            }
            break;
        }
        before = here;
        here = next;
    }
}

/* Energy of multiple scattering in cell i of the table: inside the first radius, or between radii i - 1 and i. */
static double ms_mcml__layered_cell(const ms_mcml_layered *s, const ms_mcml_layered_side *y, int side, int i)
{
    const double radius = y->radius_cm * exp(0.1 * i);
    return (i ? ms_mcml__layered_multiple(s, y, side, radius * exp(-0.1)) : y->multiple) -
        ms_mcml__layered_multiple(s, y, side, radius);
}

/* Errors of the cells from three other inversions: half the order, twice the frequency step, and a spectrum that is
   steeper past the last frequency. Differences change sign, so each is the largest of the cells nearby. The factors
   bound the true errors of the 300 media of RESULTS.md. Transmission near the axis needs frequencies past the last one.
   forward: energy of the forward peak, which the solver leaves on the axis. thin: thickness of a first layer of less
   than a mean free path, in cm, or 0; near the axis its reflectance is off by 3%. */
static void ms_mcml__layered_errors(const ms_mcml_layered *s, ms_mcml_layered_side (*y)[2], int side, double forward,
                                    double thin, double (*cell)[MS_MCML_LAYERED_RADII])
{
    enum { CELLS = MS_MCML_LAYERED_RADII };
    double *error = y[0][side].error;
    int v, i, j;
    for (v = 0; v < 4; ++v)
        for (i = 0; i < CELLS; ++i) cell[v][i] = ms_mcml__layered_cell(s, &y[v][side], side, i);
    for (i = 0; i < CELLS; ++i) {
        const double wave = y[0][side].radius_cm * exp(0.1 * i) * y[0][side].last_per_cm;
        double own = 0, most[4] = {0, 0, 0, 0};
        for (j = i > 2 ? i - 2 : 0; j <= i + 2 && j < CELLS; ++j) {
            own = fmax(own, fabs(cell[0][j]));
            for (v = 1; v < 4; ++v) most[v] = fmax(most[v], fabs(cell[v][j] - cell[0][j]));
        }
        error[i] = 5e-7 * y[0][side].multiple + 5e-4 * own + 0.2 * most[1] + 0.25 * most[3];
        error[i] += most[2] * fmin(0.06 + 2 * most[2] / (own > 0 ? own : 1e-300), 0.6);
        if (side) error[i] += 0.25 * exp(-0.5 * wave) * own;
        else if (thin > 0) error[i] += 0.035 * exp(-y[0][side].radius_cm * exp(0.1 * i) / (3 * thin)) * own;
        if (i == 0) error[i] += forward; /* some of it may leave farther out */
    }
}

/* Whether a ring from r to 1.5 r that has 1e-3 of the energy is not known to 3% and 1e-4 of the energy. */
static int ms_mcml__layered_uncertain(const ms_mcml_layered *s, int side)
{
    const double total = side ? s->tt : s->rd;
    int i, j;
    for (i = 0; i + 4 < MS_MCML_LAYERED_RADII; ++i) {
        const double radius = s->side[side].radius_cm * exp(0.1 * (i - 1)), r = i ? radius : 0,
                     next = radius * exp(0.4);
        const double energy = ms_mcml_layered_outside(s, side, r) - ms_mcml_layered_outside(s, side, next);
        double error = 0;
        for (j = i; j < i + 4; ++j) error += s->side[side].error[j];
        if (!(error <= 0.03 * fabs(energy) + 1e-4 * total) && (energy > 1e-3 * total || error > 1e-3 * total)) return 1;
    }
    return 0;
}

/* Rings of a side by photons, scaled to the exact total: the table of energies beyond radii, and variances of its
   cells. */
static void ms_mcml__layered_tabulate(const ms_mcml_result *p, int side, const ms_mcml_layered *s,
                                      ms_mcml_layered_side *y)
{
    const double *ring = side ? p->tt_r : p->rd_r, *ring_error = side ? p->tt_r_error : p->rd_r_error;
    const double traced = side ? p->tt : p->rd, total = side ? s->tt : s->rd, dr = p->grid.dr_cm;
    const double scattered = total - (side ? s->tt_unscattered : s->rd_unscattered), n = (double)p->photons;
    const double unscattered = side ? p->tt_unscattered : p->rd_unscattered;
    const double scale = traced > unscattered ? scattered / (traced - unscattered) : 0;
    double left = scattered, energy = 0, square = 0, start = 0;
    int k, i = 0;
    memset(y, 0, sizeof *y);
    y->remainder = y->multiple = scattered;
    y->photons = p->photons;
    y->radius_cm = dr;
    for (k = 0; k + 1 < p->grid.nr && i < MS_MCML_LAYERED_RADII;) {
        const double edge = y->radius_cm * exp(0.1 * i), next = fmin(edge, (k + 1) * dr),
                     area = ms_mcml__ring_area(k, dr);
        const double part = 3.14159265358979324 * (next - start) * (next + start) / area;
        double e = scale * (area * ring[k] - (k ? 0 : unscattered)), sigma = scale * area * ring_error[k];
        e = e > 0 ? part * e : 0;
        left -= e;
        energy += e;
        square += part * (sigma > 1e300 ? 0 : sigma * sigma);
        start = next;
        if (next < edge) {
            ++k;
            continue;
        }
        y->outside[i] = left > 0 ? left : 0;
        /* four photons of mean weight more than were counted, so that 4 errors cover what so few may miss (Wilson's
           interval); in an empty cell a part of one */
        y->error[i] = energy > 0 ? sqrt(square + 4 * (square / energy) * (square / energy)) : sqrt(0.1) * scale / n;
        if (!(traced > 0)) y->error[i] = total;
        energy = square = 0;
        ++i;
    }
    y->tail_cm = i > 3 ? y->radius_cm * exp(0.1 * (i - 1)) : 1e300;
    y->tail = i > 3 ? y->outside[i - 1] : 0;
    y->decay_per_cm = i > 3 ? 3 / y->tail_cm : 0;
    for (; i < MS_MCML_LAYERED_RADII; ++i) y->error[i] = y->tail + scale / n;
}

/* The sides of a mask by Monte Carlo. A few photons first find how far the rings must go. */
static ms_status ms_mcml__layered_photons(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *o, int mask,
                                          ms_mcml_layered *s, ms_error *error)
{
    ms_mcml_options with = ms_mcml_defaults();
    ms_mcml_grid grid;
    ms_mcml_result p;
    ms_status status;
    double finest = 0, thinnest = 1e300;
    int i, done = 0;
    for (i = 0; i < tissue->layer_count; ++i) {
        finest = fmax(finest, tissue->layers[i].mu_a_per_cm + tissue->layers[i].mu_s_per_cm);
        thinnest = fmin(thinnest, tissue->layers[i].thickness_cm);
    }
    memset(&grid, 0, sizeof grid);
    grid.dr_cm = finest > 0 ? 0.005 / finest : 0.005 * thinnest;
    grid.dz_cm = grid.nz = grid.na = 1;
    grid.nr = 1 << 18;
    if (!(s->mu_t_per_cm > 0)) s->mu_t_per_cm = 0.005 / grid.dr_cm;
    with.no_absorption = 1;
    with.simd = o->simd;
    with.allocator = o->allocator;
    with.seed = 1;
    for (;;) {
        double far_out = 0;
        with.photons = done ? (o->photons ? o->photons : 1000000) : 4096;
        if (done) with.progress = o->progress;
        if ((status = ms_mcml_simulate(tissue, &grid, &with, &p, error)) != MS_OK) return status;
        if (done) break;
        for (i = 0; i < 2; ++i) {
            const double *ring = i ? p.tt_r : p.rd_r, total = i ? p.tt : p.rd;
            if (mask >> i & 1 && total > 0)
                far_out = fmax(far_out, ring[grid.nr - 1] * ms_mcml__ring_area(grid.nr - 1, grid.dr_cm) / total);
        }
        done = far_out < 1e-3 || grid.dr_cm > 1e9 * thinnest;
        if (!done) grid.dr_cm *= 4;
        ms_mcml_result_destroy(&p);
    }
    for (i = 0; i < 2; ++i)
        if (mask >> i & 1) ms_mcml__layered_tabulate(&p, i, s, &s->side[i]);
    if (mask & 1) s->singles = 0;
    ms_mcml_result_destroy(&p);
    return MS_OK;
}

/* What the layers ask of the solver. */
typedef struct ms_mcml__orders {
    int isotropic, order, high;  /* order of rings, highest order of totals */
    double transport, tolerance; /* reduced optical thickness; of the iteration */
} ms_mcml__orders;

static ms_mcml__orders ms_mcml__orders_of(const ms_mcml_tissue *tissue)
{
    ms_mcml__orders d = {1, 0, 0, 0, 0};
    double forward = 0, backward = 0, sharp;
    int i, l;
    for (i = 0; i < tissue->layer_count; ++i) {
        const ms_mcml_layer *y = &tissue->layers[i];
        d.transport += (y->mu_a_per_cm + y->mu_s_per_cm * (1 - y->g)) * y->thickness_cm;
        if (!(y->mu_s_per_cm > 0) || !(y->g < 1)) continue;
        if (fabs(y->g) > 0) d.isotropic = 0;
        forward = fmax(forward, y->g);
        backward = fmax(backward, -y->g);
    }
    for (l = 1; d.order == 0; l += 2)
        if (d.isotropic ||
            (l > 1 && pow(forward, l + 1) < (d.transport < 2.5 ? 0.015 : 0.13) && pow(backward, l + 1) < 0.003) ||
            l == MS_MCML__ORDER_MAX)
            d.order = l;
    sharp = fmax(forward, backward > 0 ? 0.15 + backward : 0);
    d.high = sharp > 0.81 ? MS_MCML__ORDER_MAX : sharp > 0.6 ? 23 : 15;
    d.tolerance = d.order < 4 || d.transport < 2.5 ? 1e-6 : 1e-4; /* few moments or nodes: cheap */
    return d;
}

/* Totals: the limit of three orders. */
static ms_status ms_mcml__layered_totals(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *o,
                                         const ms_mcml__orders *d, ms_mcml_layered *out, ms_error *error)
{
    double total[3][3], absorbed_error = 0, scale;
    int l, i;
    for (l = d->isotropic ? 2 : 0; l < 3; ++l) {
        const ms_status status = ms_mcml__totals(tissue, o, d->isotropic ? d->order : d->high - 8 + 4 * l, l == 2, out,
                                                 error);
        if (status) return status;
        total[0][l] = out->rd;
        total[1][l] = out->tt;
        total[2][l] = out->a;
    }
    out->rd_error = out->tt_error = 1e-7;
    if (d->isotropic) return MS_OK;
    out->rd = ms_mcml__limit(total[0], &out->rd_error);
    out->tt = ms_mcml__limit(total[1], &out->tt_error);
    out->a = ms_mcml__limit(total[2], &absorbed_error);
    scale = total[2][2] > 0 ? out->a / total[2][2] : 1;
    for (i = 0; o->a_z && i < o->nz; ++i) o->a_z[i] *= scale;
    for (i = 0; o->a_l && i < tissue->layer_count; ++i) o->a_l[i] *= scale;
    return MS_OK;
}

typedef struct ms_mcml__rings_work {
    ms_mcml__spectra spectra[2];
    ms_mcml__waves waves;
    ms_mcml_layered_side side[4][2];
    double a[2 * MS_MCML_LAYERED_RATES * (MS_MCML_LAYERED_RATES + 4)], cell[4][MS_MCML_LAYERED_RADII];
} ms_mcml__rings_work;

/* Rings by the solver: the spectra of the order asked for, of half the order at every third frequency, and four
   inversions that give the errors. */
static ms_status ms_mcml__layered_rings(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *o,
                                        const ms_mcml__orders *d, ms_mcml_layered *out, ms_error *error)
{
    ms_mcml__rings_work *w = (ms_mcml__rings_work *)ms__alloc(&o->allocator, sizeof *w);
    double scattered[2] = {0, 0}, forward[2] = {0, 0}, thin = 0;
    int l, i, v, semi = 0, orders = d->isotropic ? 1 : 2;
    ms_status status = MS_OK;
    if (w == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the spectra", sizeof *w);
    for (l = 0; l < orders && status == MS_OK; ++l) {
        const int order = l ? (d->order - 1) / 2 > 1 ? (d->order - 1) / 2 : 1 : d->order;
        ms_mcml__sweeps *s;
        status = ms_mcml__sweeps_make(&s, tissue, o, order, order > 15 || d->transport < 2.5 ? 2 : 1, order, error);
        if (status) break;
        if (l == 0) {
            semi = s->layer[s->layers - 1].semi;
            ms_mcml__frequencies(s, d->tolerance, &w->spectra[0], out);
            if (s->layers > 1 && s->layer[0].mu_t * s->layer[0].d < 1) thin = s->layer[0].d;
            w->spectra[0].positive = d->isotropic && tissue->layer_count == 1 && semi;
            out->mu_t_per_cm = w->spectra[0].mu_t;
            ms_mcml__singles(s, out);
            scattered[0] = out->rd - (s->specular - out->specular); /* unscattered but for the forward peak */
            scattered[1] = out->tt - s->unscattered;
            forward[0] = out->rd - out->rd_unscattered - scattered[0];
            forward[1] = out->tt - out->tt_unscattered - scattered[1];
        } else {
            w->spectra[1] = w->spectra[0];
        }
        status = ms_mcml__spectra_solve(s, o, d->tolerance, l ? 3 : 1, &w->spectra[l], out, error);
        ms_mcml__sweeps_destroy(s, &o->allocator);
    }
    if (status == MS_OK) {
        if (orders == 2) ms_mcml__interpolate_spectrum(&w->spectra[1], &w->spectra[0]);
        ms_mcml__waves_make(&w->waves, 0.25 * 0.02 / w->spectra[0].mu_t * w->spectra[0].low);
        for (v = 0; v < 4; ++v)
            ms_mcml__spectra_invert(&w->spectra[v == 1 && orders == 2], v == 2 ? 2 : 1, v == 3 ? 2 : 0, out, semi,
                                    &w->waves, w->a, w->side[v]);
        for (i = 0; i < out->singles; ++i) scattered[0] -= out->single_energy[i] * (1 - out->single_end[i]);
        for (v = 0; v < 8; ++v) ms_mcml__layered_finish(out, &w->side[v / 2][v % 2], v % 2, scattered[v % 2]);
        for (i = 0; i < 2; ++i) {
            ms_mcml__layered_errors(out, w->side, i, forward[i], thin, w->cell);
            out->side[i] = w->side[0][i];
        }
    }
    ms__release(&o->allocator, w, sizeof *w);
    return status;
}

MS_API ms_status ms_mcml_layered_solve(const ms_mcml_tissue *tissue, const ms_mcml_layered_options *options,
                                       ms_mcml_layered *out, ms_error *error)
{
    ms_mcml_layered_options o;
    ms_mcml_layered r;
    ms_mcml__orders d;
    ms_status status;
    int i, clear = 0, mask = 0;
    memset(&o, 0, sizeof o);
    memset(&r, 0, sizeof r);
    if (options) o = *options;
    if (tissue == NULL || out == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "tissue or out is NULL");
    if ((status = ms_mcml__check_tissue(tissue, error)) != MS_OK) return status;
    if (tissue->layer_count > MS_MCML__LAYERS_MAX)
        return ms__fail(error, MS_UNSUPPORTED, 0, "%d layers, the layered solver takes %d", tissue->layer_count,
                        MS_MCML__LAYERS_MAX);
    if (o.a_z && (o.nz < 1 || !ms_mcml__between(o.dz_cm, 1e-30, 1e30)))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nz is %d and dz_cm %g, expected at least 1 and above 0", o.nz,
                        o.dz_cm);
    d = ms_mcml__orders_of(tissue);
    r.order = d.order;
    for (i = 0; i < tissue->layer_count; ++i) {
        const ms_mcml_layer *layer = &tissue->layers[i];
        if (tissue->layer_count > 1 && !(layer->mu_a_per_cm + layer->mu_s_per_cm > 0)) clear = 1;
        if (layer->mu_s_per_cm > 0 && layer->g < 1)
            r.forward_fraction = fmax(r.forward_fraction, pow(fabs(layer->g), d.order + 1));
    }
    if ((status = ms_mcml__layered_totals(tissue, &o, &d, &r, error)) != MS_OK) return status;
    if (!o.totals_only) {
        if (clear || r.forward_fraction > 0.3) mask = 3; /* rings that the solver does not hold */
        else if ((status = ms_mcml__layered_rings(tissue, &o, &d, &r, error)) != MS_OK) return status;
        for (i = 0; i < 2; ++i)
            if ((i ? r.tt : r.rd) > 1e-3 && mask != 3 &&
                (r.residual > 10 * d.tolerance || ms_mcml__layered_uncertain(&r, i)))
                mask |= 1 << i;
        if (mask && (status = ms_mcml__layered_photons(tissue, &o, mask, &r, error)) != MS_OK) return status;
    }
    *out = r;
    if (r.rd_error > 5e-5 || r.tt_error > 5e-5)
        return ms__fail(error, MS_NOT_CONVERGED, 0, "the totals are known to %g only",
                        r.rd_error > r.tt_error ? r.rd_error : r.tt_error);
    return MS_OK;
}

static double ms_mcml__layered_outside(const ms_mcml_layered *s, int side, double r)
{
    double sum = ms_mcml__layered_multiple(s, &s->side[side], side && !s->side[side].photons, r);
    int i;
    for (i = 0; side == 0 && i < s->singles; ++i) {
        const double x = s->single_rate_per_cm[i] * r, e = x < 700 ? exp(-x) : 0;
        if (e > s->single_end[i]) sum += s->single_energy[i] * (e - s->single_end[i]);
    }
    return sum;
}

MS_API double ms_mcml_layered_outside(const ms_mcml_layered *s, int side, double r_cm)
{
    double sum;
    if (s == NULL || side < 0 || side > 1 || !ms_mcml__between(r_cm, 0, 1e300)) return ms_mcml__nan();
    if (!(r_cm > 0)) return side ? s->tt : s->rd;
    sum = ms_mcml__layered_outside(s, side, r_cm);
    return sum > 0 ? sum : 0;
}

/* Where r is among the cells: 0 to 1 within the first radius, one more for every 10%. */
static double ms_mcml__layered_position(const ms_mcml_layered_side *y, double r)
{
    const double x = r / y->radius_cm;
    return x < 1 ? x * x : fmin(1 + 10 * log(x), MS_MCML_LAYERED_RADII);
}

/* Share of the first cell's energy that is uncertain inside radius sqrt(x) of it: its density may be even or 1 / r. */
static double ms_mcml__layered_inside(double x) { return x < 1 ? sqrt(x) - x : 0; }

/* Errors of cells add; those of photons in squares. */
static double ms_mcml__layered_ring_error(const ms_mcml_layered *s, int side, double r0, double r1)
{
    const ms_mcml_layered_side *y = &s->side[side];
    const double from = ms_mcml__layered_position(y, r0), to = ms_mcml__layered_position(y, r1);
    double sum = 0;
    int i;
    for (i = (int)from; i < MS_MCML_LAYERED_RADII && i < to; ++i) {
        const double e = y->error[i] * (fmin(to, i + 1) - fmax(from, i));
        sum += y->photons ? e * e : e;
    }
    if (!y->photons) return sum;
    return sqrt(sum) + (y->multiple - y->outside[0]) * (ms_mcml__layered_inside(from) + ms_mcml__layered_inside(to));
}

MS_API double ms_mcml_layered_ring(const ms_mcml_layered *s, int side, double r0_cm, double r1_cm, double *ring_error)
{
    double r0 = r0_cm, r1 = r1_cm, total, energy, q;
    if (s == NULL || side < 0 || side > 1 || !ms_mcml__between(r0, 0, 1e150) || !ms_mcml__between(r1, 0, 1e150) ||
        !(r0 < r1))
        return ms_mcml__nan();
    if (r1 - r0 < 1e-4 * r1) { /* the mean of a narrower ring is the same to 1e-8, but would cancel */
        r0 = (1 - 0.5e-4) * 0.5 * (r0_cm + r1_cm);
        r1 = (1 + 0.5e-4) * 0.5 * (r0_cm + r1_cm);
    }
    q = 1 / (3.14159265358979324 * (r1 - r0) * (r1 + r0));
    total = side ? s->tt : s->rd;
    energy = (r0 > 0 ? ms_mcml__layered_outside(s, side, r0) : total) - ms_mcml__layered_outside(s, side, r1);
    energy = energy > 0 ? energy : 0;
    if (ring_error) {
        *ring_error = q * ms_mcml__layered_ring_error(s, side, r0, r1);
        if (!s->side[side].photons) /* what the fit of the highest frequencies leaves open, against half-spaces */
            *ring_error += q * energy * (5e-4 + 7e-3 * exp(-r0 * s->mu_t_per_cm / 0.2));
        if (total > 0) *ring_error += q * energy / total * (side ? s->tt_error : s->rd_error);
    }
    return energy * q;
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

/* 1 - albedo of a color. The reflectance falls almost linearly with s = sqrt(1 - albedo): secants inside a bracket. */
static double ms_mcml__absorbed_of(double color, double eta)
{
    double s = 1 - color, slope = -1, last = s, before = 0, low = 0, high = 1;
    ms_mcml__cone cone;
    int i;
    ms_mcml__cone_make(&cone, eta);
    for (i = 0; i < 40; ++i) {
        const double error = ms_mcml__reflected(&cone, s * s) - color;
        if (i && fabs(s - last) > 1e-9 * s) slope = (error - before) / (s - last);
        if (error > 0) low = s;
        else high = s;
        if (fabs(error) < 1e-10 * color) break;
        before = error;
        last = s;
        s -= error / slope;
        if (!(s > low && s < high)) s = 0.5 * (low + high);
    }
    return s * s;
}

MS_API ms_status ms_mcml_medium_from_color(double color, double length_mm, int kind, double eta, ms_mcml_medium *medium,
                                           ms_error *error)
{
    const double x = fabs(color - 0.8), y = (color - 0.33) * (color - 0.33), d = 1.85 - color + 7 * x * x * x;
    double absorbed, mu_t;
    if (medium == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "medium is NULL");
    if (!ms_mcml__between(eta, 0.1, 10))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "eta is %g, expected 0.1 to 10", eta);
    if (!ms_mcml__between(color, 0, 1))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "color is %g, expected 0 to 1", color);
    if (!ms_mcml__between(length_mm, 1e-30, 1e30))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "length_mm is %g, expected above 0", length_mm);
    if (kind < MS_MCML_MEAN_FREE_PATH || kind > MS_MCML_DIFFUSE_PATH)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "kind is %d, expected one of ms_mcml_length", kind);
    absorbed = !(color > 0) ? 1 : color < 1 ? ms_mcml__absorbed_of(color, eta) : 0;
    mu_t = 1 / length_mm;
    if (kind == MS_MCML_BURLEY_D) mu_t /= d;
    if (kind == MS_MCML_DIFFUSE_PATH) mu_t *= (3.5 + 100 * y * y) / d;
    medium->mu_a_per_mm = absorbed * mu_t;
    medium->mu_s_per_mm = (1 - absorbed) * mu_t;
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
        if (!ms_mcml__between(edge[i], 0, 1e100) || (i > 0 && !(edge[i] > edge[i - 1])))
            return ms__fail(error, MS_INVALID_ARGUMENT, (size_t)i,
                            "ring edge %d is %g, expected increasing numbers from 0 to 1e100", i, edge[i]);
    if (edge == NULL && !(o->ring_mm > 0 && ms_mcml__between(o->ring_mm, 0, 1e100)))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "ring_mm is %g, expected a positive number", o->ring_mm);
    return MS_OK;
}

/* A channel: its layers in cm, and the solution that was asked for. */
typedef struct ms_mcml__channel {
    ms_mcml_tissue tissue;
    ms_mcml_layer layer;          /* of a medium */
    const ms_mcml_medium *medium; /* NULL: layers */
    int layered;                  /* by the layered solver; else by the half-space solver */
    ms_mcml__halfspace half;
    ms_mcml_layered solution;
    ms_error failure;
} ms_mcml__channel;

typedef struct ms_mcml__profile_job {
    ms_mcml__channel *channel;
    ms_mcml_profile *profile;
    const ms_mcml_profile_options *options;
} ms_mcml__profile_job;

static double ms_mcml__channel_mu_t(const ms_mcml__channel *c)
{
    return c->layered ? 0.1 * c->solution.mu_t_per_cm : c->half.mu_t_per_mm;
}

static double ms_mcml__channel_total(const ms_mcml__channel *c) { return c->layered ? c->solution.rd : c->half.total; }

static double ms_mcml__channel_outside(const ms_mcml__channel *c, double r_mm)
{
    return c->layered ? ms_mcml_layered_outside(&c->solution, 0, 0.1 * r_mm)
                      : ms_mcml__halfspace_outside(&c->half, r_mm);
}

static void ms_mcml__profile_solve(void *context, int index)
{
    const ms_mcml__profile_job *job = (const ms_mcml__profile_job *)context;
    const ms_mcml_profile_options *o = job->options;
    ms_mcml__channel *c = &job->channel[index];
    double *work;
    c->failure.status = MS_OK;
    if (c->layered) {
        ms_mcml_layered_options options;
        memset(&options, 0, sizeof options);
        options.allocator = o->allocator;
        options.simd = o->simd;
        ms_mcml_layered_solve(&c->tissue, &options, &c->solution, &c->failure);
        return;
    }
    work = (double *)ms__alloc(&o->allocator, MS_MCML__SOLVE_BYTES);
    if (work == NULL) ms__fail(&c->failure, MS_OUT_OF_MEMORY, 0, "no memory for the half-space solver");
    else ms_mcml__solve(c->medium, o->depth_step, o->frequency_step, &c->half, work);
    ms__release(&o->allocator, work, MS_MCML__SOLVE_BYTES);
}

/* The rows of a channel; where the difference of two edges would cancel, from the ring itself. */
static void ms_mcml__profile_fill(void *context, int channel)
{
    const ms_mcml__profile_job *job = (const ms_mcml__profile_job *)context;
    const ms_mcml_profile *p = job->profile;
    const ms_mcml__channel *c = &job->channel[channel];
    const size_t row = (size_t)channel * (size_t)p->rings;
    const double total = ms_mcml__channel_total(c);
    double *within = p->within + row + channel, *rd = p->rd_per_mm2 + row, *rd_error = p->rd_error_per_mm2 + row;
    double outside = ms_mcml__channel_outside(c, p->edge_mm[0]);
    int i;
    within[0] = total - outside;
    for (i = 0; i < p->rings; ++i) {
        const double r0 = p->edge_mm[i], r1 = p->edge_mm[i + 1], next = ms_mcml__channel_outside(c, r1);
        within[i + 1] = total - next;
        rd_error[i] = 0;
        if (c->layered) {
            rd[i] = 0.01 * ms_mcml_layered_ring(&c->solution, 0, 0.1 * r0, 0.1 * r1, &rd_error[i]);
            rd_error[i] *= 0.01;
        } else if (outside - next > 1e-6 * outside) {
            rd[i] = (outside - next) / (3.14159265358979324 * (r1 - r0) * (r1 + r0));
        } else {
            rd[i] = ms_mcml__halfspace_ring(&c->half, r0, r1);
        }
        outside = next;
    }
    p->total[channel] = total;
    p->total_error[channel] = c->layered ? c->solution.rd_error : 0;
}

/* Radius beyond which a channel has 1e-5 of its energy left. */
static double ms_mcml__profile_radius(const ms_mcml__channel *c)
{
    double low = c->layered ? 2e-4 / c->solution.mu_t_per_cm : 1e-3 / c->half.mu_t_per_mm, high;
    int i;
    high = 1e11 * low;
    for (i = 0; i < 40; ++i) {
        const double middle = sqrt(low * high);
        if (ms_mcml__channel_outside(c, middle) > 1e-5 * ms_mcml__channel_total(c)) low = middle;
        else high = middle;
    }
    return high;
}

/* The rings that suit the channels. edge NULL: only counts them. */
static int ms_mcml__profile_rings(const ms_mcml__channel *channel, int channels, double *edge)
{
    double radius = 0, mu_t = 0, r = 0;
    int c, n;
    for (c = 0; c < channels; ++c) {
        const double here = ms_mcml__channel_mu_t(&channel[c]);
        radius = fmax(radius,
                      ms_mcml__channel_total(&channel[c]) > 0 ? ms_mcml__profile_radius(&channel[c]) : 1 / here);
        mu_t = fmax(mu_t, here);
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
    p->total = (double *)ms__take(arena, c, size);
    p->total_error = (double *)ms__take(arena, c, size);
}

/* The profile of channels whose tissue, medium and layered are set. */
static ms_status ms_mcml__profile_of(ms_mcml_profile *profile, ms_mcml__channel *channel, int channels,
                                     ms_mcml_profile_options o, ms_error *error)
{
    ms_mcml_profile p;
    ms_mcml__profile_job job;
    ms__arena arena = {NULL, 0};
    ms_status status = ms_mcml__check_steps(&o.depth_step, &o.frequency_step, error);
    int i;
    if (status == MS_OK) status = ms_mcml__check_rings(&o, error);
    if (status) return status;
    memset(&p, 0, sizeof p);
    job.channel = channel;
    job.options = &o;
    job.profile = &p;
    ms__run(&o.parallel, channels, ms_mcml__profile_solve, &job);
    for (i = 0; i < channels; ++i) {
        const ms_status here = channel[i].failure.status;
        if (here == MS_NOT_CONVERGED) status = here;
        if (here != MS_OK && error) *error = channel[i].failure;
        if (here != MS_OK && here != MS_NOT_CONVERGED) return here;
    }
    p.channels = channels;
    p.rings = o.rings ? o.rings : ms_mcml__profile_rings(channel, channels, NULL);
    p.allocator = o.allocator;
    ms_mcml__profile_place(&arena, &p);
    p.memory_size = arena.used;
    p.memory = ms__alloc(&o.allocator, p.memory_size);
    if (p.memory == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d channels of %d rings", channels, p.rings);
    arena.base = (char *)p.memory;
    arena.used = 0;
    ms_mcml__profile_place(&arena, &p);
    for (i = 0; i <= p.rings && o.rings; ++i) p.edge_mm[i] = o.edge_mm ? o.edge_mm[i] : i * o.ring_mm;
    if (o.rings == 0) ms_mcml__profile_rings(channel, channels, p.edge_mm);
    ms__run(&o.parallel, channels, ms_mcml__profile_fill, &job);
    *profile = p;
    return status;
}

/* Of media, or of layers where media is NULL. */
static ms_status ms_mcml__profile_start(ms_mcml_profile *profile, const ms_mcml_medium *media,
                                        const ms_mcml_tissue *tissues, int channels,
                                        const ms_mcml_profile_options *options, ms_error *error)
{
    ms_mcml_profile_options o;
    ms_mcml__channel *channel;
    ms_status status = MS_OK;
    size_t size;
    int i;
    if (profile) memset(profile, 0, sizeof *profile);
    if (profile == NULL || (media == NULL && tissues == NULL) || channels < 1 || channels > 65536)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "%d channels, expected 1 to 65536; profile and what it is of not NULL", channels);
    memset(&o, 0, sizeof o);
    if (options) o = *options;
    for (i = 0; media && i < channels; ++i)
        if ((status = ms_mcml__check_medium(&media[i], error)) != MS_OK) return status;
    size = ms__size_mul((size_t)channels, sizeof *channel);
    channel = (ms_mcml__channel *)ms__alloc(&o.allocator, size);
    if (channel == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no %z bytes for the channels", size);
    for (i = 0; i < channels; ++i) {
        ms_mcml__channel *c = &channel[i];
        const ms_mcml_medium *m = c->medium = media ? &media[i] : NULL;
        c->layered = m == NULL || m->g < 0 || m->g > 0;
        if (m == NULL) {
            c->tissue = tissues[i];
            continue;
        }
        c->layer.n = m->eta;
        c->layer.mu_a_per_cm = 10 * m->mu_a_per_mm;
        c->layer.mu_s_per_cm = 10 * m->mu_s_per_mm;
        c->layer.g = m->g;
        c->layer.thickness_cm = 1e8;
        c->tissue.n_above = c->tissue.n_below = 1;
        c->tissue.layer_count = 1;
        c->tissue.layers = &c->layer;
    }
    status = ms_mcml__profile_of(profile, channel, channels, o, error);
    ms__release(&o.allocator, channel, size);
    return status;
}

MS_API ms_status ms_mcml_profile_make(ms_mcml_profile *profile, const ms_mcml_medium *media, int channels,
                                      const ms_mcml_profile_options *options, ms_error *error)
{
    return ms_mcml__profile_start(profile, media, NULL, channels, options, error);
}

MS_API ms_status ms_mcml_profile_layers(ms_mcml_profile *profile, const ms_mcml_tissue *tissues, int channels,
                                        const ms_mcml_profile_options *options, ms_error *error)
{
    return ms_mcml__profile_start(profile, NULL, tissues, channels, options, error);
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
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c")
#endif
#define MS_MCML__LEVEL avx2
#define MS_MCML__ISA 3
#include MS_MCML_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx2,fma,f16c"))), \
                             apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl,avx2,fma,f16c")
#endif
#define MS_MCML__LEVEL avx512
#define MS_MCML__ISA 4
#include MS_MCML_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#endif /* MS_MCML__X64 */
#undef MS_MCML__PASS

static const ms_mcml__kernels *ms_mcml__kernels_of(ms_simd level)
{
#if defined(MS_MCML__X64)
    if (level == MS_SIMD_AVX512) return &ms_mcml__kernels_avx512;
    if (level == MS_SIMD_AVX2) return &ms_mcml__kernels_avx2;
#endif
#if defined(MS_MCML__X64) || defined(MS_MCML__NEON)
    if (level == MS_SIMD_BASE) return &ms_mcml__kernels_base;
#endif
    (void)level;
    return &ms_mcml__kernels_scalar;
}

#undef MS_MCML__FN
#undef MS_MCML__JOIN
#undef MS_MCML__JOIN2
#undef MS_MCML__X64
#undef MS_MCML__NEON
#endif /* MS_MCML_IMPLEMENTATION */

#if defined(MS_MCML_IMPLEMENTATION) && defined(MS_MCML__PASS)
/* --- kernels --------------------------------------------------------------------------------------------------

   Read once a level. Vectors of L floats (V), words (U) and comparisons' results (M), and as long ones of doubles (E)
   and of 64-bit words (W). Their operators are the compiler's. */

#define MS_MCML__V MS_MCML__FN(v)
#define MS_MCML__U MS_MCML__FN(u)
#define MS_MCML__E MS_MCML__FN(e)
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
MS_MCML__VECTOR(double, e)
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
#define MS_MCML__D_ALL(op) op(a, 0) op(b, 1) op(c, 2) op(d, 3) op(e, 4) op(f, 5) op(g, 6) op(h, 7)
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
#define MS_MCML__D_ALL(op) op(a, 0) op(b, 2) op(c, 4) op(d, 6)
#elif MS_MCML__ISA == 2
#define MS_MCML__MM(name, mask, ...) _mm_##name(__VA_ARGS__)
#define MS_MCML__MM_INT __m128i
#define MS_MCML__V_SELECT(m, a, b) ((MS_MCML__V)(((m) & (MS_MCML__M)(a)) | (~(m) & (MS_MCML__M)(b))))
#define MS_MCML__M_BITS(m) ((unsigned)_mm_movemask_ps((__m128)(m)))
#define MS_MCML__D_ALL(op) op(a, 0) op(b, 2) op(c, 4) op(d, 6)
#elif MS_MCML__ISA == 3
#define MS_MCML__MM(name, mask, ...) _mm256_##name(__VA_ARGS__)
#define MS_MCML__MM_INT __m256i
#define MS_MCML__V_SELECT(m, a, b) _mm256_blendv_ps(b, a, (__m256)(m))
#define MS_MCML__M_BITS(m) ((unsigned)_mm256_movemask_ps((__m256)(m)))
#define MS_MCML__D_ALL(op) op(a, 0) op(b, 4)
#else /* without maskz GCC's header warns */
#define MS_MCML__MM(name, mask, ...) _mm512_maskz_##name(mask, __VA_ARGS__)
#define MS_MCML__MM_INT __m512i
#define MS_MCML__V_SELECT(m, a, b) _mm512_mask_blend_ps(m, b, a)
#define MS_MCML__M_BITS(m) ((unsigned)(m))
#define MS_MCML__D_ALL(op) op(a, 0)
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
#if MS_MCML__ISA == 4
#define MS_MCML__FMA(a, b, c, sign, ps) _mm512_f##sign##madd_##ps(a, b, c)
#elif MS_MCML__ISA == 3
#define MS_MCML__FMA(a, b, c, sign, ps) _mm256_f##sign##madd_##ps(a, b, c)
#endif
#if MS_MCML__ISA >= 3
#define MS_MCML__V_MADD(a, b, c) MS_MCML__FMA(a, b, c, , ps)
#define MS_MCML__V_NMADD(a, b, c) MS_MCML__FMA(a, b, c, n, ps)
#define MS_MCML__E_MADD(a, b, c) MS_MCML__FMA(a, b, c, , pd)
#define MS_MCML__E_NMADD(a, b, c) MS_MCML__FMA(a, b, c, n, pd)
#elif MS_MCML__ISA == 2 && defined(MS_MCML__NEON)
#define MS_MCML__V_MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_MCML__V_NMADD(a, b, c) vfmsq_f32(c, a, b)
#define MS_MCML__E_MADD(a, b, c) vfmaq_f64(c, a, b)
#define MS_MCML__E_NMADD(a, b, c) vfmsq_f64(c, a, b)
#else
#define MS_MCML__V_MADD(a, b, c) ((a) * (b) + (c))
#define MS_MCML__V_NMADD(a, b, c) ((c) - (a) * (b))
#define MS_MCML__E_MADD(a, b, c) ((a) * (b) + (c))
#define MS_MCML__E_NMADD(a, b, c) ((c) - (a) * (b))
#endif

/* -log(u), u = (word / 2 + 1/2) 2^-31 > 0. With u = (1 + t) 2^e and 1 + t in [sqrt(1/2), sqrt(2)):
   log(1 + t) = t - t^2 / 2 + t^3 P(t), error 1e-8. */
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

/* States of the next L photons, by Philox as ms__philox has it. */
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
   (Duff et al. 2017), and one Newton step to length 1. */
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
   are long known: 25% faster than to wait for them. */
static void MS_MCML__FN(trace)(ms_mcml__tracer *t)
{
    const MS_MCML__V zero = MS_MCML__V_SET(0.0f);
    const unsigned all = (2u << (MS_MCML__L - 1)) - 1;
    MS_MCML__U s0, s1, s2, s3;
    int i;

    for (i = 0; i < MS_MCML__L; ++i) t->bit[i] = 1u << i;
    t->alive = all;
    t->fresh_at = MS_MCML__L;
    MS_MCML__FN(launch)(t, all);
    s0 = MS_MCML__U_LOAD(t->s[0]);
    s1 = MS_MCML__U_LOAD(t->s[1]);
    s2 = MS_MCML__U_LOAD(t->s[2]);
    s3 = MS_MCML__U_LOAD(t->s[3]);
    while (t->alive) {
        MS_MCML__U word_flight, word_cosine, word_azimuth, word_chance, events;
        MS_MCML__V x = MS_MCML__V_LOAD(t->x), y = MS_MCML__V_LOAD(t->y), z = MS_MCML__V_LOAD(t->z);
        MS_MCML__V ux = MS_MCML__V_LOAD(t->ux), uy = MS_MCML__V_LOAD(t->uy), uz = MS_MCML__V_LOAD(t->uz);
        MS_MCML__V w = MS_MCML__V_LOAD(t->w), u, flight, steep, gap, step;
        const MS_MCML__V depth = MS_MCML__V_LOAD(t->depth), mfp = MS_MCML__V_LOAD(t->mfp);
        unsigned boundary, crossing = 0, ended, halving, finished = 0;
        MS_MCML__M hit, up;

        for (i = 0; t->cells && i < MS_MCML__L; ++i) t->cells[t->cell[i]] += (int64_t)t->units[i];
        MS_MCML__DRAW(word_flight);
        MS_MCML__DRAW(word_cosine);
        MS_MCML__DRAW(word_azimuth);
        MS_MCML__DRAW(word_chance);
        u = MS_MCML__FN(uniform)(word_chance);

        /* to the collision, or to the boundary if that is nearer; at least half the smallest -log u that is not 0 */
        flight = MS_MCML__V_MAX(MS_MCML__FN(exponential)(word_flight), MS_MCML__V_SET(3e-8f)) * mfp;
        up = MS_MCML__V_LESS(uz, zero);
        gap = MS_MCML__V_MAX(MS_MCML__V_SELECT(up, z, depth - z), zero);
        steep = MS_MCML__V_MAX(MS_MCML__V_BITS(MS_MCML__U_BITS(uz) & 0x7fffffffu), MS_MCML__V_SET(1e-9f));
        hit = MS_MCML__V_LESS(gap, flight * steep);
        boundary = MS_MCML__M_BITS(hit) & t->alive;
        step = MS_MCML__V_SELECT(hit, gap / steep, flight);
        x = MS_MCML__V_MADD(step, ux, x);
        y = MS_MCML__V_MADD(step, uy, y);
        z = MS_MCML__V_SELECT(hit, MS_MCML__V_SELECT(up, zero, depth), MS_MCML__V_MADD(step, uz, z));

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
        halving = t->alive & MS_MCML__M_BITS(MS_MCML__U_IS_ZERO(events ^ MS_MCML__U_LOAD(t->limit)));
        if (!(crossing | ended | halving)) continue;
        MS_MCML__U_STORE(t->word, word_chance);
        for (; crossing; crossing &= crossing - 1) {
            i = ms_mcml__lowest(crossing);
            if (ms_mcml__cross(t, i)) finished |= 1u << i;
        }
        for (halving &= ~finished; halving; halving &= halving - 1) {
            i = ms_mcml__lowest(halving);
            t->limit[i] *= 4;
            t->w[i] *= (t->word[i] & 128) ? 2.0f : 0.0f;
            if (!(t->w[i] > 0)) ended |= 1u << i;
        }
        for (ended &= ~finished, finished |= ended; ended; ended &= ended - 1)
            ms_mcml__add_absorbed(t, ms_mcml__lowest(ended));
        if (!finished) continue;
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
    for (i = 0; t->cells && i < MS_MCML__L; ++i) t->cells[t->cell[i]] += (int64_t)t->units[i];
#if MS_MCML__ISA >= 3
    _mm256_zeroupper(); /* GCC leaves it out here, and code of other levels then takes twice its time */
#endif
}

/* Eight doubles, the rays of a sweep: 1, 2, 4 or 8 registers of MS_MCML__E. */
#define MS_MCML__D MS_MCML__FN(eight)
#define MS_MCML__D_FIELD(x, n) MS_MCML__E x;
#define MS_MCML__D_SET(x, n) r.x = MS_MCML__FN(e_set)(k);
#define MS_MCML__D_LOAD(x, n) r.x = *(const MS_MCML__FN(e_at) *)(p + n);
#define MS_MCML__D_STORE(x, n) *(MS_MCML__FN(e_at) *)(p + n) = k.x;
#define MS_MCML__D_ADD(x, n) r.x = k.x + l.x;
#define MS_MCML__D_SUB(x, n) r.x = k.x - l.x;
#define MS_MCML__D_MUL(x, n) r.x = k.x * l.x;
#define MS_MCML__D_MADD(x, n) r.x = MS_MCML__E_MADD(k.x, l.x, m.x);
#define MS_MCML__D_NMADD(x, n) r.x = MS_MCML__E_NMADD(k.x, l.x, m.x);
#define MS_MCML__D_FUNCTION(name, arguments, op)         \
    static inline MS_MCML__D MS_MCML__FN(name) arguments \
    {                                                    \
        MS_MCML__D r;                                    \
        MS_MCML__D_ALL(op)                               \
        return r;                                        \
    }
typedef struct MS_MCML__D {
    MS_MCML__D_ALL(MS_MCML__D_FIELD)
} MS_MCML__D;
MS_MCML__D_FUNCTION(d_set, (double k), MS_MCML__D_SET)
MS_MCML__D_FUNCTION(d_load, (const double *p), MS_MCML__D_LOAD)
MS_MCML__D_FUNCTION(d_add, (MS_MCML__D k, MS_MCML__D l), MS_MCML__D_ADD)
MS_MCML__D_FUNCTION(d_sub, (MS_MCML__D k, MS_MCML__D l), MS_MCML__D_SUB)
MS_MCML__D_FUNCTION(d_mul, (MS_MCML__D k, MS_MCML__D l), MS_MCML__D_MUL)
MS_MCML__D_FUNCTION(d_madd, (MS_MCML__D k, MS_MCML__D l, MS_MCML__D m), MS_MCML__D_MADD)
MS_MCML__D_FUNCTION(d_nmadd, (MS_MCML__D k, MS_MCML__D l, MS_MCML__D m), MS_MCML__D_NMADD)
static inline void MS_MCML__FN(d_store)(double *p, MS_MCML__D k) { MS_MCML__D_ALL(MS_MCML__D_STORE) }

static inline double MS_MCML__FN(d_sum)(MS_MCML__D a)
{
    double v[8];
    MS_MCML__FN(d_store)(v, a);
    return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

static inline void MS_MCML__FN(d_transpose)(double from[8][8], double to[8][8]) /* rows to columns */
{
    int i, j;
#if MS_MCML__ISA >= 3
    for (i = 0; i < 8; i += 4)
        for (j = 0; j < 8; j += 4) {
            const __m256d a = _mm256_loadu_pd(&from[i][j]), b = _mm256_loadu_pd(&from[i + 1][j]);
            const __m256d c = _mm256_loadu_pd(&from[i + 2][j]), d = _mm256_loadu_pd(&from[i + 3][j]);
            const __m256d e = _mm256_unpacklo_pd(a, b), f = _mm256_unpackhi_pd(a, b), g = _mm256_unpacklo_pd(c, d),
                          h = _mm256_unpackhi_pd(c, d);
            _mm256_storeu_pd(&to[j][i], _mm256_permute2f128_pd(e, g, 0x20));
            _mm256_storeu_pd(&to[j + 1][i], _mm256_permute2f128_pd(f, h, 0x20));
            _mm256_storeu_pd(&to[j + 2][i], _mm256_permute2f128_pd(e, g, 0x31));
            _mm256_storeu_pd(&to[j + 3][i], _mm256_permute2f128_pd(f, h, 0x31));
        }
#else
    for (i = 0; i < 8; ++i)
        for (j = 0; j < 8; ++j) to[j][i] = from[i][j];
#endif
}

/* (*re, *im) += (tr, ti) (qr, qi) */
static inline void MS_MCML__FN(mul_add)(MS_MCML__D tr, MS_MCML__D ti, MS_MCML__D qr, MS_MCML__D qi, MS_MCML__D *re,
                                        MS_MCML__D *im)
{
    *re = MS_MCML__FN(d_nmadd)(ti, qi, MS_MCML__FN(d_madd)(tr, qr, *re));
    *im = MS_MCML__FN(d_madd)(ti, qr, MS_MCML__FN(d_madd)(tr, qi, *im));
}

/* The same of memory: (*re, *im) += t q */
static inline void MS_MCML__FN(mul_load)(const double *t, MS_MCML__D qr, MS_MCML__D qi, MS_MCML__D *re, MS_MCML__D *im)
{
    MS_MCML__FN(mul_add)(MS_MCML__FN(d_load)(t), MS_MCML__FN(d_load)(t + MS_MCML__RAYS), qr, qi, re, im);
}

/* Four steps of a panel from x on: x[step] = t[0] x[step - 1] + the sum of t[1 .. 5] times the five points of q,
   complex. */
static inline void MS_MCML__FN(steps)(const double *t, const double *q, int q_stride, double *x, int x_stride)
{
    enum { R = MS_MCML__RAYS };
    const MS_MCML__D r0 = MS_MCML__FN(d_load)(q), i0 = MS_MCML__FN(d_load)(q + R);
    const MS_MCML__D r1 = MS_MCML__FN(d_load)(q + q_stride), i1 = MS_MCML__FN(d_load)(q + q_stride + R);
    const MS_MCML__D r2 = MS_MCML__FN(d_load)(q + 2 * q_stride), i2 = MS_MCML__FN(d_load)(q + 2 * q_stride + R);
    const MS_MCML__D r3 = MS_MCML__FN(d_load)(q + 3 * q_stride), i3 = MS_MCML__FN(d_load)(q + 3 * q_stride + R);
    const MS_MCML__D r4 = MS_MCML__FN(d_load)(q + 4 * q_stride), i4 = MS_MCML__FN(d_load)(q + 4 * q_stride + R);
    MS_MCML__D xr = MS_MCML__FN(d_load)(x), xi = MS_MCML__FN(d_load)(x + R);
    int step;
    for (step = 0; step < 4; ++step, t += 12 * R) {
        MS_MCML__D re = MS_MCML__FN(d_set)(0), im = re;
        MS_MCML__FN(mul_load)(t + 2 * R, r0, i0, &re, &im);
        MS_MCML__FN(mul_load)(t + 4 * R, r1, i1, &re, &im);
        MS_MCML__FN(mul_load)(t + 6 * R, r2, i2, &re, &im);
        MS_MCML__FN(mul_load)(t + 8 * R, r3, i3, &re, &im);
        MS_MCML__FN(mul_load)(t + 10 * R, r4, i4, &re, &im);
        MS_MCML__FN(mul_load)(t, xr, xi, &re, &im);
        x += x_stride;
        MS_MCML__FN(d_store)(x, xr = re);
        MS_MCML__FN(d_store)(x + R, xi = im);
    }
}

/* Integrals of u^n exp(-y u), u from 0 to 1, n = 0 .. 4, and exp(-y): q[6][2]. y = yr + i yi, yr >= 0, is halved until
   it is below 1, where series converge; two halves of a path then make a whole. */
static inline void MS_MCML__FN(moments)(MS_MCML__D yr, MS_MCML__D yi, int halvings, const double *series,
                                        MS_MCML__D q[6][2])
{
    const double *c4 = series, *c0 = series + MS_MCML__SERIES + 1;
    MS_MCML__D re, im, er, ei, x;
    int n, k;
    re = MS_MCML__FN(d_set)(c4[MS_MCML__SERIES]);
    er = MS_MCML__FN(d_set)(c0[MS_MCML__SERIES]);
    im = ei = MS_MCML__FN(d_set)(0);
    for (n = MS_MCML__SERIES - 1; n >= 0; --n) {
        x = MS_MCML__FN(d_nmadd)(yr, re, MS_MCML__FN(d_madd)(yi, im, MS_MCML__FN(d_set)(c4[n])));
        im = MS_MCML__FN(d_nmadd)(yr, im, MS_MCML__FN(d_nmadd)(yi, re, MS_MCML__FN(d_set)(0)));
        re = x;
        x = MS_MCML__FN(d_nmadd)(yr, er, MS_MCML__FN(d_madd)(yi, ei, MS_MCML__FN(d_set)(c0[n])));
        ei = MS_MCML__FN(d_nmadd)(yr, ei, MS_MCML__FN(d_nmadd)(yi, er, MS_MCML__FN(d_set)(0)));
        er = x;
    }
    q[4][0] = re;
    q[4][1] = im;
    for (n = 4; n > 0; --n) { /* n q[n - 1] = y q[n] + exp(-y) */
        x = MS_MCML__FN(d_set)(1.0 / n);
        q[n - 1][0] = MS_MCML__FN(d_mul)(x, MS_MCML__FN(d_nmadd)(yi, q[n][1], MS_MCML__FN(d_madd)(yr, q[n][0], er)));
        q[n - 1][1] = MS_MCML__FN(d_mul)(x, MS_MCML__FN(d_madd)(yi, q[n][0], MS_MCML__FN(d_madd)(yr, q[n][1], ei)));
    }
    for (; halvings > 0; --halvings) {
        for (n = 4; n >= 0; --n) { /* (q[n] + exp(-y) sum of choose(n, k) q[k]) / 2^(n + 1) */
            static const double choose[5][5] = {
                {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
            MS_MCML__D sr = q[0][0], si = q[0][1];
            for (k = 1; k <= n; ++k) {
                x = MS_MCML__FN(d_set)(choose[n][k]);
                sr = MS_MCML__FN(d_madd)(x, q[k][0], sr);
                si = MS_MCML__FN(d_madd)(x, q[k][1], si);
            }
            x = MS_MCML__FN(d_set)(1.0 / (2 << n));
            q[n][0] = MS_MCML__FN(d_mul)(x, MS_MCML__FN(d_nmadd)(ei, si, MS_MCML__FN(d_madd)(er, sr, q[n][0])));
            q[n][1] = MS_MCML__FN(d_mul)(x, MS_MCML__FN(d_madd)(ei, sr, MS_MCML__FN(d_madd)(er, si, q[n][1])));
        }
        x = MS_MCML__FN(d_nmadd)(ei, ei, MS_MCML__FN(d_mul)(er, er));
        ei = MS_MCML__FN(d_mul)(MS_MCML__FN(d_add)(er, er), ei);
        er = x;
    }
    q[5][0] = er;
    q[5][1] = ei;
}

/* The weights of five points for the four steps of a panel; h: its length along each ray, wave: radians a length;
   out[4][6][2][R]: what passes a step, then the points. The last two steps are the first two mirrored. */
static void MS_MCML__FN(panel_weights)(double mu_t, const double *h, const double *wave, const double *polynomial,
                                       const double *series, double *out)
{
    enum { R = MS_MCML__RAYS };
    const MS_MCML__D length = MS_MCML__FN(d_load)(h), radians = MS_MCML__FN(d_mul)(length, MS_MCML__FN(d_load)(wave));
    const MS_MCML__D depth = MS_MCML__FN(d_mul)(length, MS_MCML__FN(d_set)(mu_t));
    MS_MCML__D q[2][6][2];
    double most = 0;
    int step, point, n, j, halvings = 0;
    for (j = 0; j < R; ++j) most = h[j] * (mu_t + wave[j]) > most ? h[j] * (mu_t + wave[j]) : most;
    for (most *= 0.33; most > 1; most *= 0.5) ++halvings; /* no step is longer */
    for (step = 0; step < 2; ++step) {
        const MS_MCML__D part = MS_MCML__FN(d_set)((ms_mcml__lobatto[step + 1] - ms_mcml__lobatto[step]) *
                                                   ldexp(1, -halvings));
        MS_MCML__FN(moments)
        (MS_MCML__FN(d_mul)(depth, part), MS_MCML__FN(d_mul)(radians, part), halvings, series, q[step]);
    }
    for (step = 0; step < 4; ++step) {
        MS_MCML__D(*s)[2] = q[step < 2 ? step : 3 - step];
        MS_MCML__FN(d_store)(out, s[5][0]);
        MS_MCML__FN(d_store)(out + R, s[5][1]);
        out += 2 * R;
        for (point = 0; point < 5; ++point, out += 2 * R, polynomial += 5) {
            MS_MCML__D re = MS_MCML__FN(d_set)(0), im = re;
            for (n = 0; n < 5; ++n) {
                const MS_MCML__D p = MS_MCML__FN(d_set)(polynomial[n]);
                re = MS_MCML__FN(d_madd)(p, s[n][0], re);
                im = MS_MCML__FN(d_madd)(p, s[n][1], im);
            }
            MS_MCML__FN(d_store)(out, MS_MCML__FN(d_mul)(re, length));
            MS_MCML__FN(d_store)(out + R, MS_MCML__FN(d_mul)(im, length));
        }
    }
}

static double MS_MCML__FN(inner)(const double *a, const double *b, size_t n)
{
    MS_MCML__D sum = MS_MCML__FN(d_set)(0), other = sum;
    size_t i;
    for (i = 0; i + 16 <= n; i += 16) {
        sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_load)(a + i), MS_MCML__FN(d_load)(b + i), sum);
        other = MS_MCML__FN(d_madd)(MS_MCML__FN(d_load)(a + i + 8), MS_MCML__FN(d_load)(b + i + 8), other);
    }
    if (i < n) sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_load)(a + i), MS_MCML__FN(d_load)(b + i), sum);
    return MS_MCML__FN(d_sum)(MS_MCML__FN(d_add)(sum, other));
}

static void MS_MCML__FN(add)(double *to, double x, const double *a, size_t n)
{
    const MS_MCML__D factor = MS_MCML__FN(d_set)(x);
    size_t i;
    for (i = 0; i < n; i += 8) MS_MCML__FN(d_store)
    (to + i, MS_MCML__FN(d_madd)(factor, MS_MCML__FN(d_load)(a + i), MS_MCML__FN(d_load)(to + i)));
}

/* Of a block of rays in one layer: what scatters into them at each node, [m][node] down and up; moments of l - m even
   are the same for both directions, odd ones opposite. */
static void MS_MCML__FN(source)(const ms_mcml__sweeps *s, int b, int layer)
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *y = &s->layer[layer];
    const size_t nz = (size_t)s->active, sheets = (size_t)s->most + 1;
    const double *theta = s->theta + (size_t)(b * s->layers + layer) * (size_t)s->terms * R;
    int m, l, node;
    for (m = 0; m <= s->most; ++m)
        for (node = y->node; node <= y->end; node += 4) {
            const size_t first = (size_t)ms_mcml__first_term(s->order, m), at = (size_t)m * nz + (size_t)node;
            const double *q = s->q + first * nz + node, *t = theta + first * R;
            double *down = s->source + at * R, *up = down + sheets * nz * R;
            MS_MCML__D e0 = MS_MCML__FN(d_set)(0), e1 = e0, e2 = e0, e3 = e0, o0 = e0, o1 = e0, o2 = e0, o3 = e0, x;
            for (l = m; l <= s->order; l += 2, q += nz, t += R) {
                x = MS_MCML__FN(d_load)(t);
                e0 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[0]), x, e0);
                e1 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[1]), x, e1);
                e2 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[2]), x, e2);
                e3 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[3]), x, e3);
                if (l == s->order) break;
                q += nz;
                t += R;
                x = MS_MCML__FN(d_load)(t);
                o0 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[0]), x, o0);
                o1 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[1]), x, o1);
                o2 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[2]), x, o2);
                o3 = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(q[3]), x, o3);
            }
            MS_MCML__FN(d_store)(down, MS_MCML__FN(d_add)(e0, o0));
            MS_MCML__FN(d_store)(down + R, MS_MCML__FN(d_add)(e1, o1));
            MS_MCML__FN(d_store)(down + 2 * R, MS_MCML__FN(d_add)(e2, o2));
            MS_MCML__FN(d_store)(down + 3 * R, MS_MCML__FN(d_add)(e3, o3));
            MS_MCML__FN(d_store)(up, MS_MCML__FN(d_sub)(e0, o0));
            MS_MCML__FN(d_store)(up + R, MS_MCML__FN(d_sub)(e1, o1));
            MS_MCML__FN(d_store)(up + 2 * R, MS_MCML__FN(d_sub)(e2, o2));
            MS_MCML__FN(d_store)(up + 3 * R, MS_MCML__FN(d_sub)(e3, o3));
        }
}

/* The weights of panel p of a layer, of block and azimuth ba. */
static inline const double *MS_MCML__FN(panel)(const ms_mcml__sweeps *s, const ms_mcml__solver_layer *y, int ba, int p)
{
    return s->table +
        ((size_t)(ba * s->shapes) + (size_t)(y->table + s->panel_shape[y->panel + p])) * 48 * MS_MCML__RAYS;
}

/* Flights within a layer that nothing enters, at one azimuth: down, up. */
static void MS_MCML__FN(within)(const ms_mcml__sweeps *s, const ms_mcml__solver_layer *y, int ba)
{
    enum { R = MS_MCML__RAYS };
    const size_t plane = (size_t)s->active * R, sheets = (size_t)s->most + 1;
    const double *azimuthal = s->azimuthal + (size_t)ba * sheets * R;
    const MS_MCML__D zero = MS_MCML__FN(d_set)(0);
    int node, m, p;
    for (node = y->node; node <= y->end; ++node) { /* the sources at this azimuth: even m real, odd m imaginary */
        const double *down = s->source + (size_t)node * R, *up = down + sheets * plane, *c = azimuthal;
        double *q = s->line + (size_t)node * 4 * R;
        MS_MCML__D dr = zero, di = zero, ur = zero, ui = zero, x;
        for (m = 0; m <= s->most; m += 2, c += R, down += plane, up += plane) {
            x = MS_MCML__FN(d_load)(c);
            dr = MS_MCML__FN(d_madd)(x, MS_MCML__FN(d_load)(down), dr);
            ur = MS_MCML__FN(d_madd)(x, MS_MCML__FN(d_load)(up), ur);
            if (m == s->most) break;
            x = MS_MCML__FN(d_load)(c += R);
            di = MS_MCML__FN(d_madd)(x, MS_MCML__FN(d_load)(down += plane), di);
            ui = MS_MCML__FN(d_madd)(x, MS_MCML__FN(d_load)(up += plane), ui);
        }
        MS_MCML__FN(d_store)(q, dr);
        MS_MCML__FN(d_store)(q + R, di);
        MS_MCML__FN(d_store)(q + 2 * R, ur);
        MS_MCML__FN(d_store)(q + 3 * R, ui);
    }
    MS_MCML__FN(d_store)(s->down + y->node * 2 * R, zero);
    MS_MCML__FN(d_store)(s->down + y->node * 2 * R + R, zero);
    MS_MCML__FN(d_store)(s->up + y->end * 2 * R, zero);
    MS_MCML__FN(d_store)(s->up + y->end * 2 * R + R, zero);
    for (p = 0; p < y->used; ++p) {
        const int first = y->node + 4 * p;
        MS_MCML__FN(steps)
        (MS_MCML__FN(panel)(s, y, ba, p), s->line + first * 4 * R, 4 * R, s->down + first * 2 * R, 2 * R);
    }
    for (p = y->used - 1; p >= 0; --p) { /* the same weights, mirrored */
        const int first = y->node + 4 * p + 4;
        MS_MCML__FN(steps)
        (MS_MCML__FN(panel)(s, y, ba, p), s->line + first * 4 * R + 2 * R, -4 * R, s->up + first * 2 * R, -2 * R);
    }
}

/* Adds the light that enters a layer from above (in) and from below (back) to both directions; both = their weighted
   sum and difference. */
static void MS_MCML__FN(entering)(const ms_mcml__sweeps *s, const ms_mcml__solver_layer *y, int ba, double *both,
                                  const MS_MCML__D in[2], const MS_MCML__D back[2])
{
    enum { R = MS_MCML__RAYS };
    const MS_MCML__D weight = MS_MCML__FN(d_load)(s->azimuth_weight + ba * R);
    MS_MCML__D xr = in[0], xi = in[1];
    double *x = s->down + y->node * 2 * R;
    const double *u = s->up + y->end * 2 * R;
    int p, i;
    for (p = 0; p < y->used; ++p) {
        const double *t = MS_MCML__FN(panel)(s, y, ba, p);
        for (i = 0; i < 4; ++i, t += 12 * R, x += 2 * R) {
            MS_MCML__D re = MS_MCML__FN(d_set)(0), im = re;
            MS_MCML__FN(d_store)(x, MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(x), xr));
            MS_MCML__FN(d_store)(x + R, MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(x + R), xi));
            MS_MCML__FN(mul_load)(t, xr, xi, &re, &im);
            xr = re;
            xi = im;
        }
    }
    MS_MCML__FN(d_store)(x, MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(x), xr));
    MS_MCML__FN(d_store)(x + R, MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(x + R), xi));
    xr = back[0];
    xi = back[1];
    both += y->end * 4 * R;
    for (p = 4 * y->used; p >= 0; --p, both -= 4 * R, x -= 2 * R, u -= 2 * R) {
        const MS_MCML__D ur = MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(u), xr),
                         ui = MS_MCML__FN(d_add)(MS_MCML__FN(d_load)(u + R), xi);
        const MS_MCML__D dr = MS_MCML__FN(d_load)(x), di = MS_MCML__FN(d_load)(x + R);
        MS_MCML__FN(d_store)(both, MS_MCML__FN(d_mul)(weight, MS_MCML__FN(d_add)(dr, ur)));
        MS_MCML__FN(d_store)(both + R, MS_MCML__FN(d_mul)(weight, MS_MCML__FN(d_add)(di, ui)));
        MS_MCML__FN(d_store)(both + 2 * R, MS_MCML__FN(d_mul)(weight, MS_MCML__FN(d_sub)(dr, ur)));
        MS_MCML__FN(d_store)(both + 3 * R, MS_MCML__FN(d_mul)(weight, MS_MCML__FN(d_sub)(di, ui)));
        if (p) {
            MS_MCML__D re = MS_MCML__FN(d_set)(0), im = re;
            MS_MCML__FN(mul_load)
            (MS_MCML__FN(panel)(s, y, ba, (p - 1) / 4) + (3 - (p - 1) % 4) * 12 * R, xr, xi, &re, &im);
            xr = re;
            xi = im;
        }
    }
}

/* A block of rays at one azimuth, through all layers. */
static void MS_MCML__FN(sweep_rays)(const ms_mcml__sweeps *s, int b, int a, double leave[2])
{
    enum { R = MS_MCML__RAYS };
    const int ba = b * s->azimuths + a;
    const double *nu = s->nu + b * R, *transfer = s->transfer + (size_t)(ba * s->layers) * 10 * R,
                 *edge = s->edge + (size_t)(b * s->layers) * 5 * R, *c;
    const MS_MCML__D zero = MS_MCML__FN(d_set)(0), weight = MS_MCML__FN(d_load)(s->azimuth_weight + ba * R);
    MS_MCML__D v[MS_MCML__LAYERS_MAX][2], from_below[MS_MCML__LAYERS_MAX][2], d[2], w[2], in[2], back[2], sum[2], x;
    int layer;
    in[0] = in[1] = v[0][0] = v[0][1] = sum[0] = sum[1] = zero;
    for (layer = s->layers - 1; layer >= 0; --layer) { /* what comes back from below, boundary by boundary */
        const ms_mcml__solver_layer *y = &s->layer[layer];
        v[layer][0] = v[layer][1] = from_below[layer][0] = from_below[layer][1] = zero;
        if (!(nu[0] < y->n) || (!y->clear && y->used == 0)) continue;
        c = transfer + layer * 10 * R;
        d[0] = d[1] = zero;
        if (!y->clear) {
            MS_MCML__FN(within)(s, y, ba);
            d[0] = MS_MCML__FN(d_load)(s->down + y->end * 2 * R);
            d[1] = MS_MCML__FN(d_load)(s->down + y->end * 2 * R + R);
            v[layer][0] = MS_MCML__FN(d_load)(s->up + y->node * 2 * R);
            v[layer][1] = MS_MCML__FN(d_load)(s->up + y->node * 2 * R + R);
        }
        if (layer + 1 < s->layers) MS_MCML__FN(mul_load)
        (c + 6 * R, v[layer + 1][0], v[layer + 1][1], &from_below[layer][0], &from_below[layer][1]);
        back[0] = from_below[layer][0];
        back[1] = from_below[layer][1];
        MS_MCML__FN(mul_load)(c + 2 * R, d[0], d[1], &back[0], &back[1]);
        MS_MCML__FN(mul_load)(c, back[0], back[1], &v[layer][0], &v[layer][1]);
    }
    for (layer = 0; layer < s->layers; ++layer) { /* and down again; in: what came out of the layer above */
        const ms_mcml__solver_layer *y = &s->layer[layer];
        const double *e = edge + layer * 5 * R;
        if (!(nu[0] < y->n)) continue;
        if (!y->clear && y->used == 0) break;
        c = transfer + layer * 10 * R;
        d[0] = MS_MCML__FN(d_madd)(MS_MCML__FN(d_load)(e), v[layer][0],
                                   MS_MCML__FN(d_mul)(MS_MCML__FN(d_load)(e + R), in[0]));
        d[1] = MS_MCML__FN(d_madd)(MS_MCML__FN(d_load)(e), v[layer][1],
                                   MS_MCML__FN(d_mul)(MS_MCML__FN(d_load)(e + R), in[1]));
        w[0] = w[1] = zero;
        MS_MCML__FN(mul_load)(c + 8 * R, d[0], d[1], &w[0], &w[1]);
        if (layer == 0) {
            x = v[0][0];
            MS_MCML__FN(mul_load)(c + 4 * R, w[0], w[1], &x, &v[0][1]);
            sum[0] = MS_MCML__FN(d_mul)(MS_MCML__FN(d_load)(e + 3 * R), x);
        }
        in[0] = in[1] = zero;
        if (!y->clear) {
            in[0] = MS_MCML__FN(d_load)(s->down + y->end * 2 * R);
            in[1] = MS_MCML__FN(d_load)(s->down + y->end * 2 * R + R);
        }
        MS_MCML__FN(mul_load)(c, w[0], w[1], &in[0], &in[1]);
        if (layer + 1 == s->layers) sum[1] = MS_MCML__FN(d_mul)(MS_MCML__FN(d_load)(e + 4 * R), in[0]);
        if (!y->clear) {
            MS_MCML__FN(mul_load)(c + 2 * R, in[0], in[1], &from_below[layer][0], &from_below[layer][1]);
            MS_MCML__FN(entering)(s, y, ba, s->both + (size_t)a * (size_t)s->active * 4 * R, w, from_below[layer]);
        }
    }
    leave[0] += MS_MCML__FN(d_sum)(MS_MCML__FN(d_mul)(weight, sum[0]));
    leave[1] += MS_MCML__FN(d_sum)(MS_MCML__FN(d_mul)(weight, sum[1]));
}

/* out += eight nodes' moments of one m: to[8 nodes] += the sum over rays of theta[ray] x[node][ray], each second l from
   the first. */
static inline void MS_MCML__FN(project)(double x[8][8], const double *theta, double *to, size_t stride, int count)
{
    enum { R = MS_MCML__RAYS };
    double turned[8][8];
    MS_MCML__D t0, t1, t2, t3, t4, t5, t6, t7;
    MS_MCML__FN(d_transpose)(x, turned);
    t0 = MS_MCML__FN(d_load)(turned[0]);
    t1 = MS_MCML__FN(d_load)(turned[1]);
    t2 = MS_MCML__FN(d_load)(turned[2]);
    t3 = MS_MCML__FN(d_load)(turned[3]);
    t4 = MS_MCML__FN(d_load)(turned[4]);
    t5 = MS_MCML__FN(d_load)(turned[5]);
    t6 = MS_MCML__FN(d_load)(turned[6]);
    t7 = MS_MCML__FN(d_load)(turned[7]);
    for (; count > 0; --count, theta += 2 * R, to += 2 * stride) {
        MS_MCML__D sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[0]), t0, MS_MCML__FN(d_load)(to)),
                   other = MS_MCML__FN(d_mul)(MS_MCML__FN(d_set)(theta[1]), t1);
        sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[2]), t2, sum);
        other = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[3]), t3, other);
        sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[4]), t4, sum);
        other = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[5]), t5, other);
        sum = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[6]), t6, sum);
        other = MS_MCML__FN(d_madd)(MS_MCML__FN(d_set)(theta[7]), t7, other);
        MS_MCML__FN(d_store)(to, MS_MCML__FN(d_add)(sum, other));
    }
}

/* From both, over all azimuths, to moments: out += those of a block of rays in one layer. */
static void MS_MCML__FN(project_moments)(const ms_mcml__sweeps *s, int b, int layer, double *out)
{
    enum { R = MS_MCML__RAYS };
    const ms_mcml__solver_layer *y = &s->layer[layer];
    const size_t nz = (size_t)s->active, sheets = (size_t)s->most + 1;
    const double *theta = s->theta + (size_t)(b * s->layers + layer) * (size_t)s->terms * R,
                 *mu = s->mu + (b * s->layers + layer) * R;
    double weights[R], even[8][8], odd[8][8];
    MS_MCML__D weight;
    int m, node, i, j, a;
    for (j = 0; j < R; ++j) weights[j] = 4 * s->nu_weight[b * R + j] * s->nu[b * R + j] / (y->n * y->n * mu[j]);
    weight = MS_MCML__FN(d_load)(weights);
    for (node = y->node; node <= y->end; node += 8)
        for (m = 0; m <= s->most; ++m) {
            const size_t term = (size_t)ms_mcml__first_term(s->order, m);
            for (i = 0; i < 8; i += 4) {
                const double *x = s->both + (size_t)(node + i) * 4 * R + (m & 1) * R,
                             *c = s->azimuthal + ((size_t)(b * s->azimuths) * sheets + (size_t)m) * R;
                MS_MCML__D e0 = MS_MCML__FN(d_set)(0), e1 = e0, e2 = e0, e3 = e0, o0 = e0, o1 = e0, o2 = e0, o3 = e0;
                for (a = 0; a < s->azimuths; ++a, x += nz * 4 * R, c += sheets * R) {
                    const MS_MCML__D t = MS_MCML__FN(d_load)(c);
                    e0 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x), e0);
                    o0 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 2 * R), o0);
                    e1 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 4 * R), e1);
                    o1 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 6 * R), o1);
                    e2 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 8 * R), e2);
                    o2 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 10 * R), o2);
                    e3 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 12 * R), e3);
                    o3 = MS_MCML__FN(d_madd)(t, MS_MCML__FN(d_load)(x + 14 * R), o3);
                }
                MS_MCML__FN(d_store)(even[i], MS_MCML__FN(d_mul)(weight, e0));
                MS_MCML__FN(d_store)(odd[i], MS_MCML__FN(d_mul)(weight, o0));
                MS_MCML__FN(d_store)(even[i + 1], MS_MCML__FN(d_mul)(weight, e1));
                MS_MCML__FN(d_store)(odd[i + 1], MS_MCML__FN(d_mul)(weight, o1));
                MS_MCML__FN(d_store)(even[i + 2], MS_MCML__FN(d_mul)(weight, e2));
                MS_MCML__FN(d_store)(odd[i + 2], MS_MCML__FN(d_mul)(weight, o2));
                MS_MCML__FN(d_store)(even[i + 3], MS_MCML__FN(d_mul)(weight, e3));
                MS_MCML__FN(d_store)(odd[i + 3], MS_MCML__FN(d_mul)(weight, o3));
            }
            MS_MCML__FN(project)(even, theta + term * R, out + term * nz + node, nz, (s->order - m) / 2 + 1);
            MS_MCML__FN(project)(odd, theta + (term + 1) * R, out + (term + 1) * nz + node, nz, (s->order - m + 1) / 2);
        }
}

static void MS_MCML__FN(sweep)(const ms_mcml__sweeps *s, const double *d, int beam, double *out, double leave[2])
{
    const size_t nz = (size_t)s->active;
    const double *down = s->beam, *up = down + s->nodes + 7 * s->layers;
    double *q = s->q;
    int b, a, layer, m, l, node;
    leave[0] = leave[1] = 0;
    memset(out, 0, (size_t)s->terms * nz * sizeof(double));
    memset(q, 0, (size_t)s->terms * nz * sizeof(double));
    for (m = 0; m <= s->most; ++m)
        for (l = m; l <= s->order; ++l, q += nz)
            for (layer = 0; layer < s->layers; ++layer) {
                const ms_mcml__solver_layer *y = &s->layer[layer];
                const double sigma = y->used ? y->sigma[l] : 0,
                             pole = sqrt((2 * l + 1) * 0.5) * 0.3989422804014327 * sigma, back = l & 1 ? -pole : pole;
                if (d && y->used) MS_MCML__FN(add)
                (q + y->node, sigma, d + (q - s->q) + y->node, (size_t)(y->end - y->node + 8) / 8 * 8);
                for (node = y->node; beam && m == 0 && y->used && node <= y->end; ++node)
                    q[node] += pole * down[node] + back * up[node];
            }
    for (b = 0; b < s->blocks; ++b) {
        for (layer = 0; layer < s->layers; ++layer)
            if (s->layer[layer].used && s->nu[b * MS_MCML__RAYS] < s->layer[layer].n) MS_MCML__FN(source)(s, b, layer);
        for (a = 0; a < s->azimuths; ++a) MS_MCML__FN(sweep_rays)(s, b, a, leave);
        for (layer = 0; layer < s->layers; ++layer)
            if (s->layer[layer].used && s->nu[b * MS_MCML__RAYS] < s->layer[layer].n)
                MS_MCML__FN(project_moments)(s, b, layer, out);
    }
}

static const ms_mcml__kernels MS_MCML__FN(kernels) = {MS_MCML__FN(trace), MS_MCML__FN(sweep),
                                                      MS_MCML__FN(panel_weights), MS_MCML__FN(inner), MS_MCML__FN(add)};

#undef MS_MCML__D
#undef MS_MCML__DRAW
#undef MS_MCML__D_ADD
#undef MS_MCML__D_ALL
#undef MS_MCML__D_FIELD
#undef MS_MCML__D_FUNCTION
#undef MS_MCML__D_LOAD
#undef MS_MCML__D_MADD
#undef MS_MCML__D_MUL
#undef MS_MCML__D_NMADD
#undef MS_MCML__D_SET
#undef MS_MCML__D_STORE
#undef MS_MCML__D_SUB
#undef MS_MCML__E
#undef MS_MCML__EVEN
#undef MS_MCML__E_MADD
#undef MS_MCML__E_NMADD
#undef MS_MCML__FMA
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
