/* ms_nn.h - v0.3.0 - small networks from safetensors - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_NN_IMPLEMENTATION
      #include "ms_nn.h"

   Runs small trained networks from safetensors files: a neural renderer (parameters to picture), inversion networks
   (picture to parameters). It computes values, Jacobians and least-squares objectives. It reads safetensors strictly,
   writes it into memory, and never trains. Link with -lm. This program writes a network of one layer and runs it:

   Example:
      #define MS_NN_IMPLEMENTATION
      #include "ms_nn.h"
      #include <stdio.h>
      int main(void)
      {
          static const float weight[6] = {1, 2, 3, 4, 5, 6}, bias[2] = {0.5f, -0.5f};
          static const size_t shape[2] = {2, 3};
          ms_nn_tensor tensors[2] = {{"f.weight", MS_NN_F32, 2, shape, weight, sizeof weight}, {"f.bias", MS_NN_F32, 1,
              shape, bias, sizeof bias}};
          ms_nn_entry metadata[3] = {{"ms_nn_version", "1"}, {"ms_nn_input", "[3]"},
                                     {"ms_nn_layers", "[{\"type\":\"dense\",\"name\":\"f\",\"activation\":\"tanh\"}]"}};
          static unsigned char file[1024];
          float x[3] = {0.1f, -0.2f, 0.1f}, y[2], slopes[6];
          size_t size;
          ms_nn *nn;
          ms_error error;
          if (ms_nn_file_write(tensors, 2, metadata, 3, file, sizeof file, &size, &error) != MS_OK ||
              ms_nn_load(file, size, NULL, &nn, &error) != MS_OK) {
              printf("byte %lu: %s\n", (unsigned long)error.position, error.message);
              return 1;
          }
          if (ms_nn_forward(nn, 1, x, y, NULL) != MS_OK || ms_nn_jacobian(nn, x, NULL, slopes, NULL) != MS_OK) return 1;
          printf("outputs %g %g, slopes of the first %g %g %g\n", (double)y[0], (double)y[1], (double)slopes[0],
              (double)slopes[1], (double)slopes[2]);
          ms_nn_destroy(nn);
          return 0;
      }
   End of example.

   The file
   --------
   safetensors: a length of 8 bytes, a JSON header, the data. The __metadata__ of a network has

      "format"         "pt": weights as PyTorch lays them out (may be absent)
      "ms_nn_version"  "1"
      "ms_nn_input"    JSON list: [n], [channels, length] or [channels, height, width] of one sample
      "ms_nn_layers"   JSON list of layers, in a string; each runs on the output of the one before

   Data lies row-major, channels first. A layer is an object with "type" and, as the type allows, the fields below; any
   other field is refused. Sizes that are left out are read from the tensors. * is a number or a pair [height, width].

      dense            name, units, activation, alpha, bias        <name>.weight [units][inputs]; the input must be flat
      conv1d           name, filters, kernel, stride (1), padding, <name>.weight [filters][channels][kernel]
                       zeros (0: on both sides), activation,
                       alpha, bias
      conv2d           as conv1d; kernel*, stride*, zeros*         <name>.weight [filters][channels][height][width]
      upsample1d       factor (2)                                  repeats each element
      upsample2d       factor* (2)
      maxpool1d        size (2), stride (size)                     what does not fill a window is dropped
      maxpool2d        size* (2), stride* (size)
      avgpool1d, avgpool2d: as maxpool1d, maxpool2d                means
      globalpool                                                   the mean of each channel
      flatten          order: channels_first (default, PyTorch) or channels_last (Keras)
      activation       activation, alpha                           alone
      dropout          rate                                        does nothing
      add              from, activation, alpha                     adds the output of layer `from`, or "input", of
                                                                   the same shape
      shared_channels  inputs: [[0,3,6],[1,4,6],[2,5,6]]           first layer only, see below

   <name>.bias [outputs] belongs to every dense and convolution layer without "bias":false. Weights are F32, F16, or I8
   with <name>.weight_scale (F32, [outputs]): weight = scale x integer; biases and scales are F32 or F16. Convolutions
   are correlations. "padding": "valid" (default) or "same": (kernel - 1) / 2 zeros before, rounded down, and as many
   after as make ceil(size / stride) outputs. "activation": linear (default), relu, leaky_relu (slope alpha, 0.01), elu
   (alpha, 1), tanh, sigmoid, softplus, silu, gelu (by erf). shared_channels evaluates the rest of the list once for
   each of its lists of input indices and concatenates the outputs: one small network for red, green and blue.
   examples/tools/export_torch.py saves PyTorch and Keras networks in this form.

   Costs, memory
   -------------
   A large dense layer costs what reading its weights costs, and so less as F16 or I8 (tables: tests/bench/RESULTS.md).
   A file costs one allocation, a network a dozen and at most five for each layer with weights. Convolutions are packed,
   and dense layers as long as they are together at most 64 MB; the others are read in place. With a workspace of
   ms_nn_workspace_size bytes the calls allocate nothing; it stops growing at 48 samples, since more run in groups.
   Stack: below 32 kB, 64 kB when compiled without optimization.

   Threads, SIMD, determinism, errors
   ----------------------------------
   No globals. A loaded network is only read: calls on it may overlap if their workspaces differ. options.parallel takes
   a thread pool; the work is cut by the problem alone. AVX2 and NEON are chosen at load, capped by
   options.simd; other processors and MS_NO_SIMD run plain C. At one level the bits are the same for any number of
   threads, and for a sample alone or in a batch. Arithmetic is in floats: within 1e-5 of the largest output against
   double precision in the tests; the collapse is in double. Every call that can fail returns a status;
   loaders also fill an ms_error with a byte offset and a sentence. On failure outputs are untouched. NaN and infinity
   pass through (ms_nn_check_weights finds them in weights). -ffast-math voids the promises about bits, NaN and
   infinity.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_NN_NO_STDIO    no <stdio.h>, no files by name
   MS_NO_SIMD        plain C only
   MS_NN_FILENAME    "ms_nn.h"; set it if the file is renamed (it includes itself once a SIMD level)

   Limits
   ------
   MS_BAD_DATA: whatever the strict format forbids (duplicate names, holes, overlaps, trailing bytes, NUL in names, null
   metadata, a header over 100,000,000 bytes, rank over 32), layers that do not fit their tensors, over 4096 layers,
   layer names over 240 bytes, padded sizes of 2^31 and more. MS_UNSUPPORTED: weights of other element types. Files of
   2^31 bytes and more need a 64-bit machine. Networks are chains with added skips: no recurrence, attention, or
   normalization at run time (BatchNorm goes into the weights), no groups, dilation or transposed convolutions.

   Sources
   -------
   safetensors: its format description and reference implementation. Networks: Zsolnai-Feher, PhD thesis, sections 3.4.2
   and 4.3.1. Collapse: Bjoerck 1987, corrected semi-normal equations; Golub & Van Loan, Matrix Computations, chapters 4
   and 5.
*/
#ifndef MS_NN_H
#define MS_NN_H
#include <stddef.h>
#include <stdint.h>

#define MS_NN_VERSION_MAJOR 0
#define MS_NN_VERSION_MINOR 3
#define MS_NN_VERSION_PATCH 0
#define MS_NN_VERSION 300 /* major * 10000 + minor * 100 + patch */
#define MS_NN_VERSION_STRING "0.3.0"

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

/* ---- safetensors: what is in a file ---------------------------------------------------------------------------- */

/* Every element type of the format. Networks use the first three. */
typedef enum ms_nn_dtype {
    MS_NN_F32,
    MS_NN_F16,
    MS_NN_I8,
    MS_NN_F64,
    MS_NN_BF16,
    MS_NN_I16,
    MS_NN_I32,
    MS_NN_I64,
    MS_NN_U8,
    MS_NN_U16,
    MS_NN_U32,
    MS_NN_U64,
    MS_NN_BOOL,
    MS_NN_C64,
    MS_NN_F8_E5M2,
    MS_NN_F8_E4M3,
    MS_NN_F8_E8M0,
    MS_NN_F8_E4M3FNUZ,
    MS_NN_F8_E5M2FNUZ,
    MS_NN_F6_E2M3,
    MS_NN_F6_E3M2,
    MS_NN_F4,
    MS_NN_DTYPE_COUNT
} ms_nn_dtype;

#define MS_NN_MAX_HEADER 100000000 /* bytes of JSON that a file may have; the format's own limit */
#define MS_NN_MAX_RANK 32
#define MS_NN_MAX_LAYERS 4096
#define MS_NN_MAX_NAME 240 /* bytes of a layer's name */

/* One tensor. name and shape belong to the file object, data to the memory that the file was opened on:
   little-endian, row-major, any alignment (copy elements out, do not cast). Rank 0 is one element. */
typedef struct ms_nn_tensor {
    const char *name;
    ms_nn_dtype dtype;
    int rank;
    const size_t *shape; /* [rank] */
    const void *data;
    size_t bytes;
} ms_nn_tensor;

/* One entry of __metadata__; UTF-8, no NUL inside. */
typedef struct ms_nn_entry {
    const char *key, *value;
} ms_nn_entry;

/* Zero for every default; ms_nn_defaults() returns that. */
typedef struct ms_nn_options {
    ms_simd simd;           /* the fastest level to use; MS_SIMD_AUTO (0): what the processor has */
    ms_parallel parallel;   /* runs the layers' tasks; zero: the calling thread */
    ms_allocator allocator; /* zero: malloc and free */
} ms_nn_options;

MS_API ms_nn_options ms_nn_defaults(void);

/* "F32" and so on; "unknown" outside the list. */
MS_API const char *ms_nn_dtype_string(ms_nn_dtype dtype);

typedef struct ms_nn_file ms_nn_file;

/* Checks a whole safetensors file and lists it. Nothing is copied but the names, in one allocation.
   bytes     [size] the file, read or mapped; must outlive *file; any alignment
   options   NULL: defaults
   *file     out; ms_nn_file_close releases it; untouched on failure
   error     NULL or filled on failure; position: byte in the file
   MS_BAD_DATA: not a strict safetensors file. MS_UNSUPPORTED: 2^31 bytes or more on a 32-bit machine.
   MS_OUT_OF_MEMORY. */
MS_API ms_status ms_nn_file_open(const void *bytes, size_t size, const ms_nn_options *options, ms_nn_file **file,
                                 ms_error *error);
MS_API void ms_nn_file_close(ms_nn_file *file); /* NULL is allowed */

/* Tensors in the order of their data, i in [0, count); metadata in the order of the file. */
MS_API size_t ms_nn_file_tensor_count(const ms_nn_file *file);
MS_API const ms_nn_tensor *ms_nn_file_tensor(const ms_nn_file *file, size_t i);
MS_API size_t ms_nn_file_entry_count(const ms_nn_file *file);
MS_API const ms_nn_entry *ms_nn_file_entry(const ms_nn_file *file, size_t i);

/* By name; NULL if there is none. */
MS_API const ms_nn_tensor *ms_nn_file_find(const ms_nn_file *file, const char *name);
MS_API const char *ms_nn_file_metadata(const ms_nn_file *file, const char *key);

/* Elements [first, first + count) of a tensor of F32, F16 or I8 as floats; the scales of I8 weights are not applied.
   MS_UNSUPPORTED: another type. MS_INVALID_ARGUMENT: beyond the tensor's end. */
MS_API ms_status ms_nn_tensor_read(const ms_nn_tensor *tensor, size_t first, size_t count, float *out);

/* Writes a safetensors file into memory: a header padded with spaces to a multiple of 64 bytes, then the tensors in the
   order given.
   tensors   [count], names unique; data little-endian, or NULL: the caller fills its place (ms_nn_file_open finds it)
   metadata  [entries], keys unique; NULL with entries 0
   file      [capacity] out, any alignment; NULL: only *size is wanted
   size      out: bytes of the file
   MS_INVALID_ARGUMENT: a name twice, "__metadata__" as a name, text that is not UTF-8, a wrong size, capacity below
   *size; nothing is written then. position: index of the tensor or entry. */
MS_API ms_status ms_nn_file_write(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                  size_t entries, void *file, size_t capacity, size_t *size, ms_error *error);

/* ---- networks -------------------------------------------------------------------------------------------------- */

typedef struct ms_nn ms_nn;

/* channels; channels, length; or channels, height, width, row-major. */
typedef struct ms_nn_shape {
    int rank;       /* 1 to 3 */
    size_t size[3]; /* [rank] */
} ms_nn_shape;

/* A layer as the file lists it. Strings live as long as the network. */
typedef struct ms_nn_layer {
    const char *type, *name, *activation; /* "" where there is none */
    const char *from;                     /* of add: the other layer's name, or "input"; else "" */
    float alpha;                          /* of the activation */
    ms_nn_dtype dtype;                    /* of the weights; MS_NN_DTYPE_COUNT: the layer has none */
    ms_nn_shape output;                   /* of one channel with shared_channels, else of one sample */
    size_t parameters;                    /* weights and biases */
    size_t bytes;                         /* of weights, biases and scales in the file */
    size_t multiply_adds;                 /* for one output as above */
} ms_nn_layer;

/* Makes a network of a safetensors file with a layer list (grammar in the head comment).
   bytes    [size] must outlive *nn, unchanged: large dense layers are used where they lie
   *nn      out; ms_nn_destroy releases it; untouched on failure
   error    NULL or filled on failure; position: byte in the file, or in the text of ms_nn_layers or ms_nn_input; or 0
   MS_BAD_DATA: file or layer list malformed, shapes that do not fit. MS_UNSUPPORTED: an element type or version that
   this release does not run. MS_OUT_OF_MEMORY. */
MS_API ms_status ms_nn_load(const void *bytes, size_t size, const ms_nn_options *options, ms_nn **nn, ms_error *error);
MS_API void ms_nn_destroy(ms_nn *nn); /* NULL is allowed */

#ifndef MS_NN_NO_STDIO
/* ms_nn_file_open and ms_nn_load for a file by name, which is read into one allocation. MS_IO: cannot be read. */
MS_API ms_status ms_nn_file_read(const char *path, const ms_nn_options *options, ms_nn_file **file, ms_error *error);
MS_API ms_status ms_nn_load_file(const char *path, const ms_nn_options *options, ms_nn **nn, ms_error *error);
#endif

MS_API ms_nn_shape ms_nn_input_shape(const ms_nn *nn);
MS_API ms_nn_shape ms_nn_output_shape(const ms_nn *nn);
MS_API size_t ms_nn_input_size(const ms_nn *nn); /* floats of one sample */
MS_API size_t ms_nn_output_size(const ms_nn *nn);
MS_API int ms_nn_layer_count(const ms_nn *nn);
MS_API ms_nn_layer ms_nn_layer_at(const ms_nn *nn, int i); /* i in [0, ms_nn_layer_count) */
MS_API const ms_nn_file *ms_nn_tensors(const ms_nn *nn);   /* its file; belongs to nn */
MS_API ms_simd ms_nn_simd(const ms_nn *nn);                /* the level in use */

/* The inputs that each channel of shared_channels sees: indices [*channels][*count]. Without shared_channels NULL, 1
   and the input size. */
MS_API const size_t *ms_nn_channel_inputs(const ms_nn *nn, size_t *channels, size_t *count);

/* Reads every weight, bias and scale of the layers; other tensors of the file are not looked at. MS_BAD_DATA with the
   tensor's name and the element's index (position): the first NaN or infinity. MS_OK: there is none. */
MS_API ms_status ms_nn_check_weights(const ms_nn *nn, ms_error *error);

/* What a workspace is for. */
typedef enum ms_nn_product { MS_NN_FORWARD, MS_NN_JACOBIAN } ms_nn_product;

/* Bytes of the workspace that a call needs for count samples (the Jacobian: 1). SIZE_MAX: count < 1, or this or the
   Jacobian is more than memory can address. */
MS_API size_t ms_nn_workspace_size(const ms_nn *nn, ms_nn_product product, int count);

/* y = f(x) for count samples at once; the weights are read once for all of them.
   x          [count][input size]
   y          [count][output size] out; may not overlap x
   workspace  ms_nn_workspace_size(nn, MS_NN_FORWARD, count) bytes, any alignment; NULL: from the allocator
   nn is only read: calls may overlap if their workspaces differ. NaN and infinity pass through.
   Same bits for any thread count, and for a sample alone or in a batch, at one SIMD level.
   MS_INVALID_ARGUMENT: count < 1, a NULL pointer. MS_OUT_OF_MEMORY: only with workspace NULL. */
MS_API ms_status ms_nn_forward(const ms_nn *nn, int count, const float *x, float *y, void *workspace);

/* The Jacobian at one x by directional derivatives, which read the weights once for many inputs.
   x          [input size]
   y          [output size] out: f(x), bit-equal to ms_nn_forward; NULL: not wanted
   jacobian   [output size][input size] out
   At a kink (relu at 0) the slope of the left side, at a tie in a pool that of the first maximum, as in PyTorch.
   Statuses, threads, bits and workspace (MS_NN_JACOBIAN, count 1) as for ms_nn_forward. */
MS_API ms_status ms_nn_jacobian(const ms_nn *nn, const float *x, float *y, float *jacobian, void *workspace);

/* ---- collapse: a network with a linear last layer as an objective ---------------------------------------------- */

/* With y = W h(x) + b, target t and a weight for each output in the diagonal of M,
     |y - t|_M^2 = |R (h - h0) - e|^2 + rest,   R'R = W' M W,
   where R is square in the features h: an evaluation needs the layers up to h and one triangular product, not W. With
   shared_channels each channel has its features and its part of M and t; channels with equal weights share one R. */
typedef struct ms_nn_collapse ms_nn_collapse;

/* Makes R in double precision: the Cholesky factor of W' M W. A direction of features that changes the outputs by less
   than 1e-7 of what its column does is left out.
   nn      its last layer must be dense and linear (MS_UNSUPPORTED); must outlive *c
   weight  [output size] >= 0, diagonal of M; NULL: all 1
   *c      out; ms_nn_collapse_destroy releases it
   Costs the outer product of a row of W for each output with a weight above 0, once for each different set of weights.
   MS_INVALID_ARGUMENT: a negative or non-finite weight (position: its index). MS_OUT_OF_MEMORY. */
MS_API ms_status ms_nn_collapse_create(const ms_nn *nn, const float *weight, ms_nn_collapse **c, ms_error *error);
MS_API void ms_nn_collapse_destroy(ms_nn_collapse *c); /* NULL is allowed */

/* Inputs of the last layer, those of all channels together. */
MS_API size_t ms_nn_collapse_features(const ms_nn_collapse *c);

/* Sets t. Two passes over W in double: semi-normal equations with a correction (Bjoerck 1987).
   target  [output size], finite */
MS_API ms_status ms_nn_collapse_target(ms_nn_collapse *c, const float *target, ms_error *error);

/* The residual vector, whose sum of squares is |f(x) - t|_M^2, and its Jacobian, for least-squares solvers. The sum's
   error is about 1e-16 |t|_M^2 and that of h(x) in float: a residual of 1e-6 |t| keeps four digits.
   residual  [features + 1] out, channel by channel; the last is sqrt(rest) and does not depend on x
   jacobian  [features + 1][input size] out; NULL: not wanted
   workspace ms_nn_collapse_workspace_size(c, jacobian != NULL) bytes, any alignment; NULL: from the allocator
   MS_INVALID_ARGUMENT: no target. c is only read: calls may overlap if their workspaces differ. */
MS_API ms_status ms_nn_collapse_residual(const ms_nn_collapse *c, const float *x, double *residual, double *jacobian,
                                         void *workspace);
MS_API size_t ms_nn_collapse_workspace_size(const ms_nn_collapse *c, int with_jacobian);

#ifdef __cplusplus
}
#endif
#endif /* MS_NN_H */

#if defined(MS_NN_IMPLEMENTATION) && !defined(MS_NN__PASS) && !defined(MS_NN_IMPLEMENTED)
#define MS_NN_IMPLEMENTED /* included again, it is declarations only */
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

/* ms-common-half begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_HALF
#define MS_COMMON_HALF
/* IEEE binary16 with subnormals, infinities and NaN, whatever the host's rounding and flushing of subnormals. */
static MS__UNUSED float ms__half_to_float(uint16_t h)
{
    const uint32_t exponent = (h >> 10) & 31u, mantissa = h & 1023u;
    const uint32_t bits = (exponent == 31u ? 255u : exponent + 112u) << 23 | mantissa << 13;
    float value = (float)mantissa / 16777216.0f; /* a subnormal half is a normal float */
    if (exponent != 0) memcpy(&value, &bits, sizeof value);
    return h & 0x8000u ? -value : value;
}

/* Rounded to nearest even; a finite value stays finite: at most 65504. */
static MS__UNUSED uint16_t ms__half_from_float(float value)
{
    uint32_t bits, sign, a, shift = 13;
    memcpy(&bits, &value, sizeof bits);
    sign = (bits >> 16) & 0x8000u;
    a = bits & 0x7fffffffu;
    if (a >= 0x7f800000u) return (uint16_t)(sign | 0x7c00u | (a > 0x7f800000u ? 0x200u : 0u));
    if (a >= 0x477fe000u) return (uint16_t)(sign | 0x7bffu);
    if (a < 0x33000000u) return (uint16_t)sign; /* under 2^-25 */
    if (a < 0x38800000u) {                      /* under 2^-14: whole steps of 2^-24 */
        shift = 126u - (a >> 23);
        a = (a & 0x7fffffu) | 0x800000u;
    } else {
        a -= 0x38000000u;
    }
    a += (1u << (shift - 1u)) - 1u + ((a >> shift) & 1u);
    return (uint16_t)(sign | (a >> shift));
}
#endif /* MS_COMMON_HALF */
/* ms-common-half end */

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

#if !defined(MS_NN_NO_STDIO)
#include <stdio.h>
#endif
#include <limits.h>
#include <math.h>

#ifndef MS_NN_FILENAME /* how this file is named in an #include, for its second reading (SIMD kernels) */
#define MS_NN_FILENAME "ms_nn.h"
#endif

/* Contents, in the order of the data:
   bytes        numbers of a file, on any host
   json         a cursor over text: strings, sizes, lists
   file         the header of safetensors, read twice: counted, then filled
   writer       the same in the other direction
   layer list   the layers of a network as the file names them
   plan         operations: shapes, packed weights, where values live
   run          one operation on vectors
   products     all operations: values, Jacobians, their workspaces
   queries      what a caller asks a network
   stdio        files by name
   collapse     the last layer as an objective: R of W'MW, residuals
   levels       the kernels of each instruction set
   kernels      read once a level */

/* Reading, writing and planning are compiled for size. */
#if defined(__GNUC__) || defined(__clang__)
#define MS_NN__COLD __attribute__((cold))
#define MS_NN__NOINLINE __attribute__((noinline))
#else
#define MS_NN__COLD
#define MS_NN__NOINLINE
#endif

/* Kernels need vectors that have operators: compilers other than GCC and Clang get plain C. */
#if defined(MS__X64) && (defined(__GNUC__) || defined(__clang__))
#define MS_NN__X86 1
#elif defined(MS__NEON) && (defined(__GNUC__) || defined(__clang__))
#define MS_NN__ARM 1
#endif

/* ---- bytes ----------------------------------------------------------------------------------------------------- */

/* Files are little-endian; these read any alignment on any host. */
static uint32_t ms_nn__u16(const unsigned char *p) { return (uint32_t)p[0] | (uint32_t)p[1] << 8; }
static uint32_t ms_nn__u32(const unsigned char *p) { return ms_nn__u16(p) | ms_nn__u16(p + 2) << 16; }
static void ms_nn__put_u16(unsigned char *p, uint32_t value)
{
    p[0] = (unsigned char)value;
    p[1] = (unsigned char)(value >> 8);
}
static uint64_t ms_nn__u64(const unsigned char *p)
{
    return (uint64_t)ms_nn__u32(p) | (uint64_t)ms_nn__u32(p + 4) << 32;
}

#ifndef MS_NN__BIG_ENDIAN /* the tests define it as 1 to run the copying path on any host */
#define MS_NN__BIG_ENDIAN ms_nn__big_endian()
static int ms_nn__big_endian(void)
{
    const uint16_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first == 0;
}
#endif

static float ms_nn__float_of(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Native floats at any alignment. */
static float ms_nn__float_at(const unsigned char *v, size_t i)
{
    float x;
    memcpy(&x, v + 4 * i, sizeof x);
    return x;
}

/* In the order of ms_nn_dtype. */
static const unsigned char ms_nn__bits[] = {32, 16, 8,  64, 16, 16, 32, 64, 8, 16, 32,
                                            64, 8,  64, 8,  8,  8,  8,  8,  6, 6,  4};
static const char *const ms_nn__dtype_name[] = {
    "F32",     "F16",         "I8",          "F64",     "BF16",    "I16", "I32",     "I64",
    "U8",      "U16",         "U32",         "U64",     "BOOL",    "C64", "F8_E5M2", "F8_E4M3",
    "F8_E8M0", "F8_E4M3FNUZ", "F8_E5M2FNUZ", "F6_E2M3", "F6_E3M2", "F4",  "unknown"};

/* Bytes of elements of a type; SIZE_MAX: overflow, or the last byte is not filled. */
static size_t ms_nn__bytes_for(size_t elements, ms_nn_dtype dtype)
{
    const size_t bits = ms_nn__bits[dtype], rest = elements % 8 * bits;
    return elements == SIZE_MAX || rest % 8 ? SIZE_MAX : ms__size_add(ms__size_mul(elements / 8, bits), rest / 8);
}

/* Bytes of an element of a network's types. */
static size_t ms_nn__bytes_of(ms_nn_dtype dtype) { return dtype == MS_NN_F32 ? 4 : dtype == MS_NN_F16 ? 2 : 1; }

/* Element i of a tensor of one of these. */
static float ms_nn__element(const void *data, ms_nn_dtype dtype, size_t i)
{
    const unsigned char *p = (const unsigned char *)data + i * ms_nn__bytes_of(dtype);
    if (dtype == MS_NN_F32) return ms_nn__float_of(ms_nn__u32(p));
    if (dtype == MS_NN_F16) return ms__half_to_float((uint16_t)ms_nn__u16(p));
    return (float)(*p < 128 ? (int)*p : (int)*p - 256);
}

/* ---- json ------------------------------------------------------------------------------------------------------ */

/* A cursor over JSON text. The grammars here have a fixed depth, so each level is a loop and nothing recurses. */
typedef struct ms_nn__json {
    const unsigned char *start, *p, *end;
    size_t base; /* position of start in what the error speaks of */
    ms_error *error;
} ms_nn__json;

/* A string after its escapes: text is NULL while only counting; head has the first bytes in any case. */
typedef struct ms_nn__string {
    char *text;
    size_t length;
    char head[20];
} ms_nn__string;

static MS_NN__COLD ms_status ms_nn__refuse(const ms_nn__json *j, const char *sentence)
{
    return ms__fail(j->error, MS_BAD_DATA, j->base + (size_t)(j->p - j->start), "%s", sentence);
}

/* The same at another place, with a word of the file in the sentence. */
static MS_NN__COLD ms_status ms_nn__refuse_word(const ms_nn__json *j, const unsigned char *at, const char *format,
                                                const char *word)
{
    return ms__fail(j->error, MS_BAD_DATA, j->base + (size_t)(at - j->start), format, word);
}

/* Appends to an error what it speaks of: the reason comes first, since a name may be longer than the message. layer -1:
   a tensor. type and name may be NULL. Returns status. */
static MS_NN__COLD ms_status ms_nn__name_place(ms_error *error, ms_status status, size_t position, int layer,
                                               const char *type, const char *name)
{
    ms_error inner;
    if (error == NULL) return status;
    inner = *error;
    if (layer < 0) return ms__fail(error, status, position, "%s (tensor '%s')", inner.message, name);
    return ms__fail(error, status, position,
                    name       ? "%s (layer %d, %s '%s')"
                        : type ? "%s (layer %d, %s)"
                               : "%s (layer %d)",
                    inner.message, layer, type, name);
}

static MS_NN__COLD void ms_nn__space(ms_nn__json *j)
{
    while (j->p < j->end && (*j->p == ' ' || *j->p == '\n' || *j->p == '\r' || *j->p == '\t')) ++j->p;
}

/* Skips white space and takes c if it is next. */
static MS_NN__COLD int ms_nn__take(ms_nn__json *j, char c)
{
    ms_nn__space(j);
    if (j->p == j->end || *j->p != (unsigned char)c) return 0;
    ++j->p;
    return 1;
}

static MS_NN__COLD int ms_nn__is(const ms_nn__string *s, const char *word)
{
    size_t n = strlen(word);
    return s->length == n && n < sizeof s->head && memcmp(s->head, word, n) == 0;
}

/* Length of the UTF-8 sequence at p, 0 if it is not one (RFC 3629: no overlong forms, no surrogates, at most
   U+10FFFF). */
static MS_NN__COLD size_t ms_nn__utf8(const unsigned char *p, const unsigned char *end)
{
    size_t n = *p < 0x80          ? 1
        : *p >= 0xC2 && *p < 0xE0 ? 2
        : *p >= 0xE0 && *p < 0xF0 ? 3
        : *p >= 0xF0 && *p < 0xF5 ? 4
                                  : 0;
    size_t i;
    if (n == 0 || (size_t)(end - p) < n) return 0;
    for (i = 1; i < n; ++i)
        if ((p[i] & 0xC0) != 0x80) return 0;
    if ((*p == 0xE0 && p[1] < 0xA0) || (*p == 0xED && p[1] > 0x9F) || (*p == 0xF0 && p[1] < 0x90) ||
        (*p == 0xF4 && p[1] > 0x8F))
        return 0;
    return n;
}

static MS_NN__COLD int ms_nn__hex4(const unsigned char *p, const unsigned char *end, uint32_t *value)
{
    int i;
    *value = 0;
    if (end - p < 4) return 0;
    for (i = 0; i < 4; ++i) {
        unsigned char c = p[i];
        int digit = c >= '0' && c <= '9' ? c - '0'
            : c >= 'a' && c <= 'f'       ? c - 'a' + 10
            : c >= 'A' && c <= 'F'       ? c - 'A' + 10
                                         : -1;
        if (digit < 0) return 0;
        *value = *value * 16 + (uint32_t)digit;
    }
    return 1;
}

/* A string into *s; its bytes and a NUL go to *pool (which moves on) unless that is NULL. */
static MS_NN__COLD ms_status ms_nn__json_string(ms_nn__json *j, char **pool, ms_nn__string *s)
{
    memset(s, 0, sizeof *s);
    if (!ms_nn__take(j, '"')) return ms_nn__refuse(j, "expected a string in double quotes");
    s->text = *pool;
    for (;;) {
        unsigned char out[4];
        size_t n, i;
        if (j->p == j->end) return ms_nn__refuse(j, "a string has no end");
        if (*j->p == '"') break;
        if (*j->p < 0x20) return ms_nn__refuse(j, "a control character in a string must be escaped");
        if (*j->p != '\\') {
            n = ms_nn__utf8(j->p, j->end);
            if (n == 0) return ms_nn__refuse(j, "a string is not valid UTF-8");
            memcpy(out, j->p, n);
            j->p += n;
        } else {
            static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
            const char *simple;
            unsigned char c = (unsigned char)(j->end - j->p > 1 ? j->p[1] : 0);
            uint32_t code = 0, other = 0;
            simple = c ? strchr(from, c) : NULL;
            if (simple != NULL) {
                code = (uint32_t)(unsigned char)to[simple - from];
                j->p += 2;
            } else {
                if (c != 'u' || !ms_nn__hex4(j->p + 2, j->end, &code))
                    return ms_nn__refuse(j, "unknown escape in a string");
                if (code >= 0xD800 && code < 0xE000) {
                    if (code >= 0xDC00 || j->end - j->p < 12 || j->p[6] != '\\' || j->p[7] != 'u' ||
                        !ms_nn__hex4(j->p + 8, j->end, &other) || other < 0xDC00 || other >= 0xE000)
                        return ms_nn__refuse(j, "a surrogate escape without its other half");
                    code = 0x10000 + ((code - 0xD800) << 10) + (other - 0xDC00);
                    j->p += 6;
                }
                if (code == 0) return ms_nn__refuse(j, "a NUL character in a string");
                j->p += 6;
            }
            n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
            for (i = n; i-- > 1; code >>= 6) out[i] = (unsigned char)(0x80 | (code & 0x3F));
            out[0] = (unsigned char)(n == 1 ? code : code | (0xF00u >> n & 0xFF));
        }
        for (i = 0; i < n; ++i, ++s->length) {
            if (s->length < sizeof s->head - 1) s->head[s->length] = (char)out[i];
            if (*pool != NULL) *(*pool)++ = (char)out[i];
        }
    }
    ++j->p;
    if (*pool != NULL) *(*pool)++ = 0;
    return MS_OK;
}

/* A plain non-negative integer that fits size_t: no sign, point, exponent or leading zero. */
static MS_NN__COLD ms_status ms_nn__json_size(ms_nn__json *j, size_t *value)
{
    const unsigned char *first;
    size_t v = 0;
    ms_nn__space(j);
    first = j->p;
    for (; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p) {
        size_t digit = (size_t)(*j->p - '0');
        if (v > (SIZE_MAX - digit) / 10) return ms_nn__refuse(j, "a number is too large for the address space");
        v = v * 10 + digit;
    }
    if (j->p == first || (*first == '0' && j->p - first > 1) ||
        (j->p < j->end && (*j->p == '.' || *j->p == 'e' || *j->p == 'E')))
        return ms_nn__refuse(j, "expected a plain integer: digits without sign, point, exponent or leading zero");
    *value = v;
    return MS_OK;
}

/* After an item of a list: *more is 1 after a comma, 0 after the closing character. */
static MS_NN__COLD ms_status ms_nn__json_more(ms_nn__json *j, char close, int *more)
{
    *more = ms_nn__take(j, ',');
    if (*more || ms_nn__take(j, close)) return MS_OK;
    return ms_nn__refuse(j, close == '}' ? "expected ',' or '}'" : "expected ',' or ']'");
}

/* ---- file ------------------------------------------------------------------------------------------------------ */

typedef struct ms_nn__record {
    ms_nn_tensor tensor;
    size_t begin, end, position; /* range in the data, place of the entry in the file */
} ms_nn__record;

struct ms_nn_file {
    ms_allocator allocator;
    size_t bytes;  /* of this allocation, which holds everything below */
    void *content; /* what ms_nn_file_read read; else NULL */
    size_t content_bytes;
    size_t tensors, entries;
    ms_nn__record *record; /* [tensors] in the order of the data */
    ms_nn_entry *entry;    /* [entries] in the order of the header */
    const ms_nn__record **by_name;
    const ms_nn_entry **by_key;
    size_t *shape; /* all dimensions */
    char *text;
};

/* What the header holds: counted by a first pass, filled by a second one. */
typedef struct ms_nn__header {
    size_t tensors, entries, dimensions, text;
    size_t data_size, data_start;
    const unsigned char *data;
    ms_nn_file *file; /* NULL while counting */
    char *pool;
} ms_nn__header;

/* {"dtype":"F32","shape":[2,3],"data_offsets":[0,24]} in any order, each field once, nothing else. */
static MS_NN__COLD ms_status ms_nn__header_tensor(ms_nn__json *j, ms_nn__header *h, const ms_nn__string *name,
                                                  size_t position)
{
    int seen = 0, more = 1, rank = 0, dtype = 0;
    size_t elements = 1, nonzero = 1, offset[2] = {0, 0}, bytes;
    size_t *shape = h->file ? h->file->shape + h->dimensions : NULL;
    ms_nn__string s;
    char *none = NULL;
    ms_status status;
    if (!ms_nn__take(j, '{')) return ms_nn__refuse(j, "a tensor must be an object with dtype, shape and data_offsets");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        int field;
        const unsigned char *at = j->p;
        if ((status = ms_nn__json_string(j, &none, &s)) != MS_OK) return status;
        field = ms_nn__is(&s, "dtype") ? 1 : ms_nn__is(&s, "shape") ? 2 : ms_nn__is(&s, "data_offsets") ? 4 : 0;
        if (field == 0)
            return ms_nn__refuse_word(j, at, "unknown field '%s'; known are dtype, shape, data_offsets", s.head);
        if (seen & field) return ms_nn__refuse_word(j, at, "the field '%s' appears twice", s.head);
        seen |= field;
        if (!ms_nn__take(j, ':')) return ms_nn__refuse(j, "expected ':'");
        if (field == 1) {
            ms_nn__space(j);
            at = j->p;
            if ((status = ms_nn__json_string(j, &none, &s)) != MS_OK) return status;
            for (dtype = 0; dtype < (int)MS_NN_DTYPE_COUNT; ++dtype)
                if (ms_nn__is(&s, ms_nn__dtype_name[dtype])) break;
            if (dtype == (int)MS_NN_DTYPE_COUNT) return ms_nn__refuse_word(j, at, "unknown dtype '%s'", s.head);
        } else {
            int list = !ms_nn__take(j, '['), count = 0;
            if (list) return ms_nn__refuse(j, "expected a list of integers in brackets");
            for (list = !ms_nn__take(j, ']'); list; ++count) {
                size_t value;
                if ((status = ms_nn__json_size(j, &value)) != MS_OK) return status;
                if (count == (field == 2 ? MS_NN_MAX_RANK : 2))
                    return ms_nn__refuse(j,
                                         field == 2 ? "more than 32 dimensions" : "data_offsets must have two numbers");
                if (field == 4) {
                    offset[count] = value;
                } else {
                    if (shape) shape[count] = value;
                    elements = ms__size_mul(elements, value);
                    nonzero = ms__size_mul(nonzero, value ? value : 1);
                }
                if ((status = ms_nn__json_more(j, ']', &list)) != MS_OK) return status;
            }
            if (field == 2) rank = count;
            else if (count != 2) return ms_nn__refuse(j, "data_offsets must have two numbers");
        }
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    if (seen != 7) return ms_nn__refuse(j, "a tensor lacks dtype, shape or data_offsets");
    if (ms__size_mul(nonzero / 8, ms_nn__bits[dtype]) == SIZE_MAX || nonzero == SIZE_MAX)
        return ms_nn__refuse(j, "the product of the dimensions overflows");
    bytes = ms_nn__bytes_for(elements, (ms_nn_dtype)dtype);
    if (bytes == SIZE_MAX) return ms_nn__refuse(j, "a tensor must fill whole bytes");
    if (offset[0] > offset[1] || offset[1] > h->data_size)
        return ms_nn__refuse(j, "data_offsets must rise and lie within the file");
    if (offset[1] - offset[0] != bytes) return ms_nn__refuse(j, "data_offsets do not span what dtype and shape need");
    if (h->file) {
        ms_nn__record *r = &h->file->record[h->tensors];
        r->tensor.name = name->text;
        r->tensor.dtype = (ms_nn_dtype)dtype;
        r->tensor.rank = rank;
        r->tensor.shape = shape;
        r->tensor.data = h->data + offset[0];
        r->tensor.bytes = bytes;
        r->begin = offset[0];
        r->end = offset[1];
        r->position = position;
    }
    h->dimensions += (size_t)rank;
    h->tensors++;
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__header_metadata(ms_nn__json *j, ms_nn__header *h)
{
    int more = 1;
    ms_status status;
    if (!ms_nn__take(j, '{')) return ms_nn__refuse(j, "__metadata__ must be an object of strings");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string key, value;
        if ((status = ms_nn__json_string(j, &h->pool, &key)) != MS_OK) return status;
        if (!ms_nn__take(j, ':')) return ms_nn__refuse(j, "expected ':'");
        if ((status = ms_nn__json_string(j, &h->pool, &value)) != MS_OK) return status;
        if (h->file) {
            h->file->entry[h->entries].key = key.text;
            h->file->entry[h->entries].value = value.text;
        }
        h->entries++;
        h->text += key.length + value.length + 2;
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__header_object(ms_nn__json *j, ms_nn__header *h)
{
    int more = 1, metadata = 0;
    ms_status status;
    if (j->p == j->end || *j->p != '{') return ms_nn__refuse(j, "the header must begin with '{'");
    ++j->p;
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string name;
        size_t position;
        ms_nn__space(j);
        position = j->base + (size_t)(j->p - j->start);
        if ((status = ms_nn__json_string(j, &h->pool, &name)) != MS_OK) return status;
        h->text += name.length + 1;
        if (!ms_nn__take(j, ':')) return ms_nn__refuse(j, "expected ':'");
        if (ms_nn__is(&name, "__metadata__")) {
            if (metadata++) return ms_nn__refuse(j, "__metadata__ appears twice");
            status = ms_nn__header_metadata(j, h);
        } else {
            status = ms_nn__header_tensor(j, h, &name, position);
            if (status != MS_OK)
                return ms_nn__name_place(j->error, status, j->error ? j->error->position : 0, -1, NULL, name.head);
        }
        if (status != MS_OK) return status;
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    ms_nn__space(j);
    if (j->p != j->end) return ms_nn__refuse(j, "only spaces may follow the header's object");
    return MS_OK;
}

static MS_NN__COLD int ms_nn__compare_data(const void *first, const void *second)
{
    const ms_nn__record *a = (const ms_nn__record *)first, *b = (const ms_nn__record *)second;
    if (a->begin != b->begin) return a->begin < b->begin ? -1 : 1;
    if (a->end != b->end) return a->end < b->end ? -1 : 1;
    return a->position < b->position ? -1 : 1; /* empty tensors at one place keep their order */
}

static MS_NN__COLD int ms_nn__compare_name(const void *first, const void *second)
{
    return strcmp((*(const ms_nn__record *const *)first)->tensor.name,
                  (*(const ms_nn__record *const *)second)->tensor.name);
}

static MS_NN__COLD int ms_nn__compare_key(const void *first, const void *second)
{
    return strcmp((*(const ms_nn_entry *const *)first)->key, (*(const ms_nn_entry *const *)second)->key);
}

static MS_NN__COLD void ms_nn__swap(unsigned char *a, unsigned char *b, size_t size)
{
    while (size-- > 0) {
        const unsigned char kept = *a;
        *a++ = *b;
        *b++ = kept;
    }
}

/* Heap sort, for qsort may allocate: no recursion, O(n log n) for any input. */
static MS_NN__COLD void ms_nn__sort(void *items, size_t count, size_t size, int (*compare)(const void *, const void *))
{
    unsigned char *at = (unsigned char *)items;
    size_t start = count / 2, end = count;
    while (end > 1) {
        size_t root, child;
        if (start > 0) --start;
        else ms_nn__swap(at, at + --end * size, size);
        for (root = start; (child = 2 * root + 1) < end; root = child) {
            if (child + 1 < end && compare(at + child * size, at + (child + 1) * size) < 0) ++child;
            if (compare(at + root * size, at + child * size) >= 0) break;
            ms_nn__swap(at + root * size, at + child * size, size);
        }
    }
}

/* Names and keys once each; the data without holes or overlaps from 0 to its end. */
static MS_NN__COLD ms_status ms_nn__file_check(ms_nn_file *f, size_t data_start, size_t data_size, ms_error *error)
{
    size_t i, end = 0;
    ms_nn__sort(f->record, f->tensors, sizeof f->record[0], ms_nn__compare_data);
    for (i = 0; i < f->tensors; ++i) f->by_name[i] = &f->record[i];
    for (i = 0; i < f->entries; ++i) f->by_key[i] = &f->entry[i];
    ms_nn__sort(f->by_name, f->tensors, sizeof f->by_name[0], ms_nn__compare_name);
    ms_nn__sort(f->by_key, f->entries, sizeof f->by_key[0], ms_nn__compare_key);
    for (i = 1; i < f->tensors; ++i)
        if (ms_nn__compare_name(&f->by_name[i - 1], &f->by_name[i]) == 0)
            return ms__fail(error, MS_BAD_DATA, f->by_name[i]->position, "two tensors have the name '%s'",
                            f->by_name[i]->tensor.name);
    for (i = 1; i < f->entries; ++i)
        if (ms_nn__compare_key(&f->by_key[i - 1], &f->by_key[i]) == 0)
            return ms__fail(error, MS_BAD_DATA, 8, "two metadata entries have the key '%s'", f->by_key[i]->key);
    for (i = 0; i < f->tensors; ++i) {
        const ms_nn__record *r = &f->record[i];
        if (r->begin != end)
            return ms__fail(error, MS_BAD_DATA, r->position,
                            r->begin > end ? "a hole of %z bytes before the tensor '%s'"
                                           : "an overlap of %z bytes with the tensor '%s'",
                            r->begin > end ? r->begin - end : end - r->begin, r->tensor.name);
        end = r->end;
    }
    if (end != data_size)
        return ms__fail(error, MS_BAD_DATA, data_start + end, "%z bytes follow the last tensor", data_size - end);
    return MS_OK;
}

MS_API MS_NN__COLD ms_nn_options ms_nn_defaults(void)
{
    ms_nn_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_API const char *ms_nn_dtype_string(ms_nn_dtype dtype)
{
    return ms_nn__dtype_name[(int)dtype >= 0 && dtype < MS_NN_DTYPE_COUNT ? dtype : MS_NN_DTYPE_COUNT];
}

MS_API MS_NN__COLD ms_status ms_nn_file_open(const void *bytes, size_t size, const ms_nn_options *options,
                                             ms_nn_file **file, ms_error *error)
{
    const unsigned char *b = (const unsigned char *)bytes;
    ms_nn_options o = options ? *options : ms_nn_defaults();
    uint64_t length;
    ms_nn__json j;
    ms_nn__header h;
    ms_nn_file *f;
    ms_status status;
    size_t total;
    if (file == NULL || (bytes == NULL && size > 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", file == NULL ? "file" : "bytes");
    if (size < 8) return ms__fail(error, MS_BAD_DATA, size, "the file has %z bytes, a header needs at least 8", size);
    if (size > SIZE_MAX / 2)
        return ms__fail(error, MS_UNSUPPORTED, 0, "a file of %z bytes needs a 64-bit machine", size);
    length = ms_nn__u64(b);
    if (size < 9 || (b[8] != '{' && length > size - 8))
        return ms__fail(error, MS_BAD_DATA, 8, "not a safetensors file: no '{' after the length of its header");
    if (length > MS_NN_MAX_HEADER)
        return ms__fail(error, MS_BAD_DATA, 0, "the header length is over the limit of %d bytes", MS_NN_MAX_HEADER);
    if (length > size - 8)
        return ms__fail(error, MS_BAD_DATA, 0, "the header length %z does not fit into a file of %z bytes",
                        (size_t)length, size);
    memset(&h, 0, sizeof h);
    j.start = j.p = b + 8;
    j.end = j.start + length;
    j.base = 8;
    j.error = error;
    h.data = j.end;
    h.data_start = 8 + (size_t)length;
    h.data_size = size - h.data_start;
    if ((status = ms_nn__header_object(&j, &h)) != MS_OK) return status;

    total = ms__size_add(sizeof *f, ms__size_mul(h.tensors, sizeof(ms_nn__record) + sizeof f->by_name[0]));
    total = ms__size_add(total, ms__size_mul(h.entries, sizeof(ms_nn_entry) + sizeof f->by_key[0]));
    total = ms__size_add(total, ms__size_add(ms__size_mul(h.dimensions, sizeof(size_t)), h.text));
    f = (ms_nn_file *)ms__alloc(&o.allocator, total);
    if (f == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a list of %z tensors", h.tensors);
    memset(f, 0, sizeof *f);
    f->allocator = o.allocator;
    f->bytes = total;
    f->tensors = h.tensors;
    f->entries = h.entries;
    f->record = (ms_nn__record *)(void *)(f + 1);
    f->entry = (ms_nn_entry *)(void *)(f->record + h.tensors);
    f->by_name = (const ms_nn__record **)(void *)(f->entry + h.entries);
    f->by_key = (const ms_nn_entry **)(void *)(f->by_name + h.tensors);
    f->shape = (size_t *)(void *)(f->by_key + h.entries);
    f->text = (char *)(f->shape + h.dimensions);

    h.tensors = h.entries = h.dimensions = h.text = 0;
    h.file = f;
    h.pool = f->text;
    j.p = j.start;
    status = ms_nn__header_object(&j, &h);
    if (status == MS_OK) status = ms_nn__file_check(f, h.data_start, h.data_size, error);
    if (status != MS_OK) ms_nn_file_close(f);
    else *file = f;
    return status;
}

MS_API MS_NN__COLD void ms_nn_file_close(ms_nn_file *file)
{
    ms_allocator allocator;
    if (file == NULL) return;
    allocator = file->allocator;
    ms__release(&allocator, file->content, file->content_bytes);
    ms__release(&allocator, file, file->bytes);
}

MS_API size_t ms_nn_file_tensor_count(const ms_nn_file *file) { return file ? file->tensors : 0; }
MS_API size_t ms_nn_file_entry_count(const ms_nn_file *file) { return file ? file->entries : 0; }

MS_API const ms_nn_tensor *ms_nn_file_tensor(const ms_nn_file *file, size_t i)
{
    return file && i < file->tensors ? &file->record[i].tensor : NULL;
}

MS_API const ms_nn_entry *ms_nn_file_entry(const ms_nn_file *file, size_t i)
{
    return file && i < file->entries ? &file->entry[i] : NULL;
}

MS_API ms_status ms_nn_tensor_read(const ms_nn_tensor *tensor, size_t first, size_t count, float *out)
{
    size_t elements, i;
    if (tensor == NULL || (out == NULL && count > 0)) return MS_INVALID_ARGUMENT;
    if (tensor->dtype > MS_NN_I8) return MS_UNSUPPORTED;
    elements = tensor->bytes / ms_nn__bytes_of(tensor->dtype);
    if (first > elements || count > elements - first) return MS_INVALID_ARGUMENT;
    for (i = 0; i < count; ++i) out[i] = ms_nn__element(tensor->data, tensor->dtype, first + i);
    return MS_OK;
}

MS_API const ms_nn_tensor *ms_nn_file_find(const ms_nn_file *file, const char *name)
{
    ms_nn__record wanted;
    const ms_nn__record *key = &wanted, **found;
    if (file == NULL || name == NULL) return NULL;
    wanted.tensor.name = name;
    found = (const ms_nn__record **)bsearch(&key, file->by_name, file->tensors, sizeof key, ms_nn__compare_name);
    return found ? &(*found)->tensor : NULL;
}

MS_API const char *ms_nn_file_metadata(const ms_nn_file *file, const char *key)
{
    size_t i;
    for (i = 0; file && key && i < file->entries; ++i)
        if (strcmp(file->entry[i].key, key) == 0) return file->entry[i].value;
    return NULL;
}

/* ---- writer ---------------------------------------------------------------------------------------------------- */

/* Text is counted first, then written. */
typedef struct ms_nn__writer {
    char *out; /* NULL while counting */
    size_t length;
} ms_nn__writer;

static MS_NN__COLD void ms_nn__put(ms_nn__writer *w, const char *text, size_t n)
{
    if (w->out) memcpy(w->out + w->length, text, n);
    w->length += n;
}

static MS_NN__COLD void ms_nn__put_text(ms_nn__writer *w, const char *text) { ms_nn__put(w, text, strlen(text)); }

static MS_NN__COLD void ms_nn__put_size(ms_nn__writer *w, size_t value)
{
    char digit[24];
    ms_nn__put_text(w, ms__format_integer(digit + sizeof digit - 1, value));
}

static MS_NN__COLD void ms_nn__put_string(ms_nn__writer *w, const char *text)
{
    static const char hex[] = "0123456789abcdef";
    ms_nn__put_text(w, "\"");
    for (; *text; ++text) {
        unsigned char c = (unsigned char)*text;
        char escape[6] = {'\\', 'u', '0', '0', 0, 0};
        if (c == '"' || c == '\\') {
            escape[1] = (char)c;
            ms_nn__put(w, escape, 2);
        } else if (c < 0x20) {
            escape[4] = hex[c >> 4];
            escape[5] = hex[c & 15];
            ms_nn__put(w, escape, 6);
        } else {
            ms_nn__put(w, text, 1);
        }
    }
    ms_nn__put_text(w, "\"");
}

static MS_NN__COLD int ms_nn__valid_text(const char *text)
{
    const unsigned char *p = (const unsigned char *)text, *end;
    size_t n;
    if (text == NULL) return 0;
    for (end = p + strlen(text); p < end; p += n)
        if ((n = ms_nn__utf8(p, end)) == 0) return 0;
    return 1;
}

/* Every value of the caller, before a byte is written. *data: bytes of all tensors. */
static MS_NN__COLD ms_status ms_nn__write_check(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                                size_t entries, size_t *data, ms_error *error)
{
    size_t i, k;
    *data = 0;
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *t = &tensors[i];
        size_t elements = (int)t->dtype >= 0 && t->dtype < MS_NN_DTYPE_COUNT ? 1 : SIZE_MAX;
        int d;
        if (!ms_nn__valid_text(t->name) || strcmp(t->name, "__metadata__") == 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "the name of tensor %z is not allowed or not UTF-8", i);
        if (t->rank < 0 || t->rank > MS_NN_MAX_RANK || (t->rank > 0 && t->shape == NULL))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "the rank must be 0 to 32: the tensor '%s'", t->name);
        for (d = 0; d < t->rank; ++d) elements = ms__size_mul(elements, t->shape[d]);
        if (t->bytes == SIZE_MAX || elements == SIZE_MAX || ms_nn__bytes_for(elements, t->dtype) != t->bytes)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "dtype and shape do not make %z bytes: the tensor '%s'",
                            t->bytes, t->name);
        for (k = 0; k < i; ++k)
            if (strcmp(tensors[k].name, t->name) == 0)
                return ms__fail(error, MS_INVALID_ARGUMENT, i, "two tensors have the name '%s'", t->name);
        *data = ms__size_add(*data, t->bytes);
    }
    if (*data == SIZE_MAX) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the tensors' sizes overflow");
    for (i = 0; i < entries; ++i) {
        if (!ms_nn__valid_text(metadata[i].key) || !ms_nn__valid_text(metadata[i].value))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "metadata entry %z is not UTF-8", i);
        for (k = 0; k < i; ++k)
            if (strcmp(metadata[k].key, metadata[i].key) == 0)
                return ms__fail(error, MS_INVALID_ARGUMENT, i, "two metadata entries have the key '%s'",
                                metadata[i].key);
    }
    return MS_OK;
}

/* The header, and with w->out the data after it. */
static MS_NN__COLD void ms_nn__write(ms_nn__writer *w, const ms_nn_tensor *tensors, size_t count,
                                     const ms_nn_entry *metadata, size_t entries)
{
    size_t i, offset = 0;
    int d;
    w->length = 8;
    ms_nn__put_text(w, "{");
    for (i = 0; i < entries; ++i) {
        ms_nn__put_text(w, i ? "," : "\"__metadata__\":{");
        ms_nn__put_string(w, metadata[i].key);
        ms_nn__put_text(w, ":");
        ms_nn__put_string(w, metadata[i].value);
    }
    if (entries) ms_nn__put_text(w, count ? "}," : "}");
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *t = &tensors[i];
        if (i) ms_nn__put_text(w, ",");
        ms_nn__put_string(w, t->name);
        ms_nn__put_text(w, ":{\"dtype\":");
        ms_nn__put_string(w, ms_nn__dtype_name[t->dtype]);
        ms_nn__put_text(w, ",\"shape\":[");
        for (d = 0; d < t->rank; ++d) {
            if (d) ms_nn__put_text(w, ",");
            ms_nn__put_size(w, t->shape[d]);
        }
        ms_nn__put_text(w, "],\"data_offsets\":[");
        ms_nn__put_size(w, offset);
        ms_nn__put_text(w, ",");
        offset += t->bytes;
        ms_nn__put_size(w, offset);
        ms_nn__put_text(w, "]}");
    }
    ms_nn__put_text(w, "}");
    while (w->length % 64) ms_nn__put_text(w, " ");
    if (w->out == NULL) return;
    for (i = 0; i < 8; ++i) w->out[i] = (char)(unsigned char)((uint64_t)(w->length - 8) >> (8 * i) & 0xFF);
    for (i = 0; i < count; w->length += tensors[i++].bytes)
        if (tensors[i].data != NULL && tensors[i].bytes) memcpy(w->out + w->length, tensors[i].data, tensors[i].bytes);
}

MS_API MS_NN__COLD ms_status ms_nn_file_write(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                              size_t entries, void *file, size_t capacity, size_t *size,
                                              ms_error *error)
{
    size_t data, total;
    ms_nn__writer w;
    ms_status status;
    if ((tensors == NULL && count != 0) || (metadata == NULL && entries != 0) || size == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL",
                        size == NULL                        ? "size"
                            : tensors == NULL && count != 0 ? "tensors"
                                                            : "metadata");
    if ((status = ms_nn__write_check(tensors, count, metadata, entries, &data, error)) != MS_OK) return status;
    w.out = NULL;
    ms_nn__write(&w, tensors, count, metadata, entries);
    if (w.length - 8 > MS_NN_MAX_HEADER)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "names and metadata make a header over %d bytes",
                        MS_NN_MAX_HEADER);
    total = ms__size_add(w.length, data);
    if (file != NULL && capacity < total)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the file has %z bytes, capacity is %z", total, capacity);
    *size = total;
    w.out = (char *)file;
    if (file != NULL) ms_nn__write(&w, tensors, count, metadata, entries);
    return MS_OK;
}

/* ---- layer list ------------------------------------------------------------------------------------------------ */

typedef enum ms_nn__kind {
    MS_NN__DENSE,
    MS_NN__CONV1D,
    MS_NN__CONV2D,
    MS_NN__UPSAMPLE1D,
    MS_NN__UPSAMPLE2D,
    MS_NN__MAXPOOL1D,
    MS_NN__MAXPOOL2D,
    MS_NN__AVGPOOL1D,
    MS_NN__AVGPOOL2D,
    MS_NN__GLOBALPOOL,
    MS_NN__FLATTEN,
    MS_NN__ACTIVATE,
    MS_NN__DROPOUT,
    MS_NN__ADD,
    MS_NN__SHARED,
    MS_NN__KINDS
} ms_nn__kind;

typedef enum ms_nn__activation {
    MS_NN__LINEAR,
    MS_NN__RELU,
    MS_NN__LEAKY,
    MS_NN__ELU,
    MS_NN__TANH,
    MS_NN__SIGMOID,
    MS_NN__SOFTPLUS,
    MS_NN__SILU,
    MS_NN__GELU,
    MS_NN__ACTIVATIONS
} ms_nn__activation;

static const char *const ms_nn__kind_name[] = {"dense",     "conv1d",     "conv2d",    "upsample1d", "upsample2d",
                                               "maxpool1d", "maxpool2d",  "avgpool1d", "avgpool2d",  "globalpool",
                                               "flatten",   "activation", "dropout",   "add",        "shared_channels"};
static const char *const ms_nn__activation_name[] = {"linear",  "relu",     "leaky_relu", "elu", "tanh",
                                                     "sigmoid", "softplus", "silu",       "gelu"};

/* The fields of a layer in the file; 0 or NULL where the file is silent. */
typedef struct ms_nn__spec {
    ms_nn__kind kind;
    const char *type, *name, *activation, *padding, *order, *from;
    size_t units, filters;
    size_t kernel[2], stride[2], zeros[2], size[2], factor[2]; /* height, width; of 1-D layers the first one */
    double alpha, rate;
    int bias;       /* 0: not given, 1: true, 2: false */
    unsigned given; /* bit f: the f-th field of ms_nn__fields is given */
    unsigned pairs; /* bit f: as two numbers */
    size_t at;      /* the layer's first character in the list */
} ms_nn__spec;

typedef enum ms_nn__field_kind {
    MS_NN__TEXT,
    MS_NN__COUNT,   /* a number from 1 on */
    MS_NN__EXTENTS, /* the same, of 2-D layers one number or two */
    MS_NN__WIDTHS,  /* the same from 0 on */
    MS_NN__REAL,    /* 0 to 1e30 */
    MS_NN__FLAG,
    MS_NN__INDICES /* of shared_channels */
} ms_nn__field_kind;

typedef struct ms_nn__field {
    const char *key;
    ms_nn__field_kind kind;
    size_t offset; /* in ms_nn__spec */
    int layers;    /* the set of kinds that have it */
} ms_nn__field;

/* Sets of kinds: bit k is kind k. */
enum {
    MS_NN__UPSAMPLES = 1 << MS_NN__UPSAMPLE1D | 1 << MS_NN__UPSAMPLE2D,
    MS_NN__MAXPOOLS = 1 << MS_NN__MAXPOOL1D | 1 << MS_NN__MAXPOOL2D,
    MS_NN__POOLS = MS_NN__MAXPOOLS | 1 << MS_NN__AVGPOOL1D | 1 << MS_NN__AVGPOOL2D,
    MS_NN__CONVS = 1 << MS_NN__CONV1D | 1 << MS_NN__CONV2D,
    MS_NN__WEIGHTED = 1 << MS_NN__DENSE | MS_NN__CONVS,
    MS_NN__ACTIVATED = MS_NN__WEIGHTED | 1 << MS_NN__ACTIVATE | 1 << MS_NN__ADD,
    MS_NN__TWO_D = 1 << MS_NN__CONV2D | 1 << MS_NN__UPSAMPLE2D | 1 << MS_NN__MAXPOOL2D | 1 << MS_NN__AVGPOOL2D
};

static const ms_nn__field ms_nn__fields[] = {
    {"type", MS_NN__TEXT, offsetof(ms_nn__spec, type), ~0},
    {"name", MS_NN__TEXT, offsetof(ms_nn__spec, name), ~0},
    {"activation", MS_NN__TEXT, offsetof(ms_nn__spec, activation), MS_NN__ACTIVATED},
    {"alpha", MS_NN__REAL, offsetof(ms_nn__spec, alpha), MS_NN__ACTIVATED},
    {"bias", MS_NN__FLAG, offsetof(ms_nn__spec, bias), MS_NN__WEIGHTED},
    {"units", MS_NN__COUNT, offsetof(ms_nn__spec, units), 1 << MS_NN__DENSE},
    {"filters", MS_NN__COUNT, offsetof(ms_nn__spec, filters), MS_NN__CONVS},
    {"kernel", MS_NN__EXTENTS, offsetof(ms_nn__spec, kernel), MS_NN__CONVS},
    {"padding", MS_NN__TEXT, offsetof(ms_nn__spec, padding), MS_NN__CONVS},
    {"zeros", MS_NN__WIDTHS, offsetof(ms_nn__spec, zeros), MS_NN__CONVS},
    {"stride", MS_NN__EXTENTS, offsetof(ms_nn__spec, stride), MS_NN__CONVS | MS_NN__POOLS},
    {"size", MS_NN__EXTENTS, offsetof(ms_nn__spec, size), MS_NN__POOLS},
    {"factor", MS_NN__EXTENTS, offsetof(ms_nn__spec, factor), MS_NN__UPSAMPLES},
    {"order", MS_NN__TEXT, offsetof(ms_nn__spec, order), 1 << MS_NN__FLATTEN},
    {"rate", MS_NN__REAL, offsetof(ms_nn__spec, rate), 1 << MS_NN__DROPOUT},
    {"from", MS_NN__TEXT, offsetof(ms_nn__spec, from), 1 << MS_NN__ADD},
    {"inputs", MS_NN__INDICES, 0, 1 << MS_NN__SHARED}};
enum { MS_NN__FIELDS = (int)(sizeof ms_nn__fields / sizeof ms_nn__fields[0]) };

/* What the whole layer list becomes. A first pass counts (text, layers, indices), a second one stores. */
typedef struct ms_nn__list {
    char *pool; /* of all strings; NULL while counting */
    size_t text;
    int layers;
    ms_nn__spec *spec;     /* [layers], NULL while counting */
    size_t channels;       /* of shared_channels; 0 without */
    size_t channel_inputs; /* indices a channel */
    size_t *channel_input; /* [channels][channel_inputs], NULL while counting */
} ms_nn__list;

/* A JSON number from 0 on as a double, within some units of its last place: enough for slopes and rates. */
static MS_NN__COLD ms_status ms_nn__json_real(ms_nn__json *j, double *value)
{
    const unsigned char *first;
    double v = 0;
    int shift = 0, exponent = 0, point, minus;
    ms_nn__space(j);
    for (point = 0; point < 2; ++point) { /* the digits before it, then those after it */
        for (first = j->p; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p)
            if (v < 1e18) v = v * 10 + (*j->p - '0'), shift -= point;
            else shift += !point;
        if (j->p == first || (!point && *first == '0' && j->p > first + 1))
            return ms_nn__refuse(j, "expected a number from 0 on, without leading zeros");
        if (j->p == j->end || *j->p != '.' || point) break;
        ++j->p;
    }
    if (j->p < j->end && (*j->p == 'e' || *j->p == 'E')) {
        ++j->p;
        minus = j->p < j->end && *j->p == '-';
        if (j->p < j->end && (*j->p == '-' || *j->p == '+')) ++j->p;
        for (first = j->p; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p)
            if (exponent < 1000000) exponent = exponent * 10 + (*j->p - '0');
        if (j->p == first) return ms_nn__refuse(j, "expected the digits of an exponent");
        shift += minus ? -exponent : exponent;
    }
    *value = v > 0 ? v * pow(10.0, shift < 40 ? shift : 40) : 0; /* 1e40 is too large anyway */
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__json_flag(ms_nn__json *j, int *flag)
{
    ms_nn__space(j);
    *flag = j->end - j->p >= 4 && memcmp(j->p, "true", 4) == 0 ? 1
        : j->end - j->p >= 5 && memcmp(j->p, "false", 5) == 0  ? 2
                                                               : 0;
    if (*flag == 0) return ms_nn__refuse(j, "expected true or false");
    j->p += 3 + *flag;
    return MS_OK;
}

/* n or [n] or [n, m] into out[2]; one number stands for both. *pair: there were two. */
static MS_NN__COLD ms_status ms_nn__json_extents(ms_nn__json *j, size_t out[2], int *pair)
{
    ms_status status;
    int list = ms_nn__take(j, '[');
    *pair = 0;
    if ((status = ms_nn__json_size(j, &out[0])) != MS_OK) return status;
    out[1] = out[0];
    if (!list) return MS_OK;
    if ((status = ms_nn__json_more(j, ']', pair)) != MS_OK || !*pair) return status;
    if ((status = ms_nn__json_size(j, &out[1])) != MS_OK) return status;
    return ms_nn__take(j, ']') ? MS_OK : ms_nn__refuse(j, "expected at most two numbers");
}

/* [[0,3],[1,3],[2,3]]: lists of equal length, one a channel. */
static MS_NN__COLD ms_status ms_nn__json_indices(ms_nn__json *j, ms_nn__list *l)
{
    size_t channel, total = 0;
    int more = 1, inner;
    ms_status status;
    if (!ms_nn__take(j, '[')) return ms_nn__refuse(j, "inputs must be a list of lists of indices");
    for (channel = 0; more; ++channel) {
        size_t n = 0, index;
        if (!ms_nn__take(j, '[')) return ms_nn__refuse(j, "inputs must be a list of lists of indices");
        for (inner = 1; inner; ++n, ++total) {
            if ((status = ms_nn__json_size(j, &index)) != MS_OK) return status;
            if (l->channel_input) l->channel_input[total] = index;
            if ((status = ms_nn__json_more(j, ']', &inner)) != MS_OK) return status;
        }
        if (channel > 0 && n != l->channel_inputs)
            return ms_nn__refuse(j, "the channels must have equally many inputs");
        l->channel_inputs = n;
        if ((status = ms_nn__json_more(j, ']', &more)) != MS_OK) return status;
    }
    l->channels = channel;
    return MS_OK;
}

/* The value of field f into *spec; key: where the field's name stands. */
static MS_NN__COLD ms_status ms_nn__list_field(ms_nn__json *j, ms_nn__list *l, ms_nn__spec *spec, int f,
                                               const unsigned char *key)
{
    const ms_nn__field *field = &ms_nn__fields[f];
    char *out = (char *)spec + field->offset;
    ms_status status;
    if (field->kind == MS_NN__TEXT) {
        ms_nn__string text;
        status = ms_nn__json_string(j, &l->pool, &text);
        l->text += text.length + 1;
        memcpy(out, &text.text, sizeof text.text);
        if (status != MS_OK || f != 0) return status;
        for (spec->kind = MS_NN__DENSE; spec->kind < MS_NN__KINDS; spec->kind = (ms_nn__kind)(spec->kind + 1))
            if (ms_nn__is(&text, ms_nn__kind_name[spec->kind])) return MS_OK;
        return ms_nn__refuse_word(j, key, "unknown type '%s'", text.head);
    }
    if (field->kind == MS_NN__REAL) {
        double real = 0;
        if ((status = ms_nn__json_real(j, &real)) != MS_OK) return status;
        if (!(real >= 0 && real <= 1e30)) return ms_nn__refuse_word(j, key, "'%s' must not be above 1e30", field->key);
        memcpy(out, &real, sizeof real);
    } else if (field->kind == MS_NN__FLAG) {
        return ms_nn__json_flag(j, &spec->bias);
    } else if (field->kind == MS_NN__INDICES) {
        if (l->layers > 0) return ms_nn__refuse(j, "shared_channels must be the first layer");
        return ms_nn__json_indices(j, l);
    } else {
        size_t extents[2];
        int pair;
        if ((status = ms_nn__json_extents(j, extents, &pair)) != MS_OK) return status;
        if (extents[0] > INT_MAX || extents[1] > INT_MAX)
            return ms_nn__refuse_word(j, key, "the size '%s' is too large", field->key);
        if (field->kind != MS_NN__WIDTHS && (extents[0] == 0 || extents[1] == 0))
            return ms_nn__refuse_word(j, key, "the size '%s' must not be 0", field->key);
        memcpy(out, extents, (field->kind == MS_NN__COUNT ? 1 : 2) * sizeof extents[0]);
        if (pair) spec->pairs |= 1u << f;
    }
    return MS_OK;
}

/* One layer. Its type may come last, so what it may have is checked at its end. */
static MS_NN__COLD ms_status ms_nn__list_layer(ms_nn__json *j, ms_nn__list *l)
{
    int more = 1, f;
    ms_nn__spec spec;
    ms_status status;
    memset(&spec, 0, sizeof spec);
    spec.alpha = -1; /* not given */
    ms_nn__space(j);
    spec.at = (size_t)(j->p - j->start);
    if (!ms_nn__take(j, '{')) return ms_nn__refuse(j, "a layer must be an object");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string key;
        char *none = NULL;
        const unsigned char *key_at;
        ms_nn__space(j);
        key_at = j->p;
        if ((status = ms_nn__json_string(j, &none, &key)) != MS_OK) return status;
        if (!ms_nn__take(j, ':')) return ms_nn__refuse(j, "expected ':'");
        for (f = 0; f < MS_NN__FIELDS && !ms_nn__is(&key, ms_nn__fields[f].key);) ++f;
        if (f == MS_NN__FIELDS) return ms_nn__refuse_word(j, key_at, "unknown field '%s'", key.head);
        if (spec.given & 1u << f) return ms_nn__refuse_word(j, key_at, "the field '%s' appears twice", key.head);
        spec.given |= 1u << f;
        ms_nn__space(j);
        if (f == 0) key_at = j->p; /* an error speaks of the type itself */
        if ((status = ms_nn__list_field(j, l, &spec, f, key_at)) != MS_OK) return status;
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    if (!(spec.given & 1u)) return ms_nn__refuse(j, "the layer has no type");
    for (f = 0; f < MS_NN__FIELDS; ++f) {
        const ms_nn__field *field = &ms_nn__fields[f];
        if ((spec.given & 1u << f) && !(field->layers & 1 << spec.kind))
            return ms__fail(j->error, MS_BAD_DATA, j->base + spec.at, "the field '%s' does not belong to the type %s",
                            field->key, ms_nn__kind_name[spec.kind]);
        if ((spec.pairs & 1u << f) && (field->kind == MS_NN__COUNT || !(MS_NN__TWO_D & 1 << spec.kind)))
            return ms__fail(j->error, MS_BAD_DATA, j->base + spec.at, "the field '%s' of the type %s is one number",
                            field->key, ms_nn__kind_name[spec.kind]);
    }
    if (spec.kind == MS_NN__SHARED && l->channels == 0) return ms_nn__refuse(j, "shared_channels has no inputs");
    if (l->layers == MS_NN_MAX_LAYERS) return ms_nn__refuse(j, "more than 4096 layers");
    if (l->spec) l->spec[l->layers] = spec;
    l->layers++;
    return MS_OK;
}

static MS_NN__COLD ms_nn__json ms_nn__json_of(const char *text, ms_error *error)
{
    ms_nn__json j;
    j.start = j.p = (const unsigned char *)text;
    j.end = j.p + strlen(text);
    j.base = 0;
    j.error = error;
    return j;
}

static MS_NN__COLD ms_status ms_nn__list_read(ms_nn__list *l, const char *text, ms_error *error)
{
    ms_nn__json j = ms_nn__json_of(text, error);
    int more = 1;
    ms_status status;
    if (!ms_nn__take(&j, '[')) return ms_nn__refuse(&j, "ms_nn_layers must be a list");
    if (ms_nn__take(&j, ']')) return ms_nn__refuse(&j, "the layer list is empty");
    while (more) {
        if ((status = ms_nn__list_layer(&j, l)) != MS_OK)
            return ms_nn__name_place(error, status, error ? error->position : 0, l->layers, NULL, NULL);
        if ((status = ms_nn__json_more(&j, ']', &more)) != MS_OK) return status;
    }
    ms_nn__space(&j);
    return j.p == j.end ? MS_OK : ms_nn__refuse(&j, "text follows the layer list");
}

static MS_NN__COLD ms_status ms_nn__shape_read(ms_nn_shape *shape, const char *text, ms_error *error)
{
    ms_nn__json j = ms_nn__json_of(text, error);
    int more = 1;
    size_t total = 1;
    ms_status status;
    memset(shape, 0, sizeof *shape);
    if (!ms_nn__take(&j, '[')) return ms_nn__refuse(&j, "ms_nn_input must be a list of sizes");
    while (more) {
        if (shape->rank == 3) return ms_nn__refuse(&j, "ms_nn_input has more than three sizes");
        if ((status = ms_nn__json_size(&j, &shape->size[shape->rank])) != MS_OK) return status;
        total = ms__size_mul(total, shape->size[shape->rank]);
        if (shape->size[shape->rank++] == 0 || total > SIZE_MAX / 64)
            return ms_nn__refuse(&j, "a size in ms_nn_input is 0 or too large");
        if ((status = ms_nn__json_more(&j, ']', &more)) != MS_OK) return status;
    }
    ms_nn__space(&j);
    return j.p == j.end ? MS_OK : ms_nn__refuse(&j, "text follows ms_nn_input");
}

/* ---- plan ------------------------------------------------------------------------------------------------------ */

/* channels x height x width; a signal has height 1, a vector height and width 1. */
typedef struct ms_nn__dims {
    size_t c, h, w;
} ms_nn__dims;

static size_t ms_nn__count(ms_nn__dims d) { return d.c * d.h * d.w; }

/* More values than leave room for 64 bytes each: no size of a value can wrap. */
static int ms_nn__too_large(ms_nn__dims d) { return ms__size_mul(ms__size_mul(d.c, d.h), d.w) > SIZE_MAX / 64; }

static size_t ms_nn__min(size_t a, size_t b) { return a < b ? a : b; }
static size_t ms_nn__round_up(size_t n, size_t unit) { return (n + unit - 1) / unit * unit; }

/* A dense layer's matrix where it lies, rows of cols elements without padding; most have a packed copy, too, in panels
   of kernels->panel rows, [panel][column][row of the panel], zeros after the last row. */
typedef struct ms_nn__matrix {
    const unsigned char *w, *scale, *bias; /* scale, bias: [rows] native floats, any alignment, or NULL */
    ms_nn_dtype dtype;                     /* F32, F16, I8 */
    size_t rows, cols;
    const unsigned char *packed;             /* 64-byte aligned; NULL: not packed */
    const float *packed_scale, *packed_bias; /* of every row of the panels: 1 and 0 where there is none */
    ms_nn_dtype packed_dtype;                /* F32, F16 */
} ms_nn__matrix;

/* A correlation. Its input is copied with its zeros around it, "padded". */
typedef struct ms_nn__conv {
    ms_nn__dims in, out;
    size_t kernel[2], stride[2];
    size_t pad[2];        /* zeros above and left of the input */
    const float *packed;  /* [block][in channel][tap][output of the block], blocks of kernels->block outputs */
    const float *bias;    /* [out.c rounded up to blocks], zeros where there is none */
    size_t taps;          /* of a channel */
    const size_t *offset; /* [taps] from an output's first padded element to the element that the tap sees */
    size_t rows;          /* padded input rows */
    size_t pitch, plane;  /* floats of a padded row and channel; with stride s, columns 0, s, 2s... come first */
} ms_nn__conv;

/* Rows of y_b = W x_b + bias, one b a sample; of directions without the bias. */
typedef struct ms_nn__dense {
    const ms_nn__matrix *m;
    int batch;
    const float *x; /* [batch][cols] */
    float *y;       /* [batch][rows] */
    int linear;     /* no bias */
    size_t chunk;   /* rows of a task */
    const struct ms_nn__kernels *kernels;
} ms_nn__dense;

/* One convolution of one sample. */
typedef struct ms_nn__conv_job {
    const ms_nn__conv *conv;
    float *y;            /* [out.c][out.h][out.w] */
    const float *padded; /* [in.c][plane] */
    int linear;          /* no bias */
    size_t chunk;        /* output rows of a task */
    const struct ms_nn__kernels *kernels;
} ms_nn__conv_job;

enum { MS_NN__OVERRUN = 64 }; /* floats that a tile may load beyond the end of the padded input */

/* out_ik += sum_r a_ir b_rk in double for r < count, i < rows, a multiple of 4, and k < cols, one of MS_NN__DOUBLES. */
typedef struct ms_nn__product_job {
    const double *a; /* a_ir at a[i * a_row + r * a_column] */
    size_t a_row, a_column;
    const double *b; /* b_rk at b[r * b_row + k] */
    size_t b_row;
    double *out; /* out_ik at out[i * out_row + k] */
    size_t out_row;
    size_t count, rows, cols;
} ms_nn__product_job;

enum { MS_NN__DOUBLES = 8 }; /* two vectors of four */

/* The loops that differ by level; the kernel section at the end of this file makes one table a level. */
typedef struct ms_nn__kernels {
    size_t block;  /* outputs that a convolution computes together */
    size_t panel;  /* rows of a panel of packed weights */
    ms_simd level; /* SCALAR: packed weights are floats, since narrow ones are slow to widen there */
    void (*packed)(const ms_nn__dense *job, size_t row0, size_t row1);
    void (*dense)(const ms_nn__dense *job, size_t row0, size_t row1);
    void (*conv)(const ms_nn__conv_job *job, size_t row0, size_t row1);
    void (*activate)(const float *x, float *y, size_t n, ms_nn__activation activation, float alpha, int slope);
    void (*widen)(const unsigned char *p, size_t n, double factor, double *out, ms_nn_dtype dtype);
    void (*product)(const ms_nn__product_job *job);
} ms_nn__kernels;

/* One operation. Operation k reads value k and makes value k + 1; value 0 is the input. */
typedef struct ms_nn__op {
    ms_nn__kind kind; /* of 1-D layers the 2-D one; FLATTEN: a transposition */
    ms_nn__activation activation;
    float alpha;
    ms_nn__dims in, out;
    int skip;                  /* ADD: the other value */
    size_t size[2], stride[2]; /* of pools; UPSAMPLE: size is the factor */
    ms_nn__matrix matrix;
    ms_nn__conv conv;
} ms_nn__op;

/* Memory that belongs to a network: a list, released with it. */
typedef struct ms_nn__memory {
    struct ms_nn__memory *next;
    size_t bytes;
} ms_nn__memory;

struct ms_nn {
    ms_nn_options options;
    ms_nn_file *file;
    ms_nn__memory *memory;
    const ms_nn__kernels *kernels;
    size_t packed;             /* bytes of packed dense weights */
    ms_nn_shape input, output; /* as the caller sees them */
    size_t channels, channel_inputs;
    const size_t *channel_input; /* [channels][channel_inputs]; channels 1 and NULL without shared_channels */
    ms_nn__dims inner;           /* of value 0 */
    int layers, ops;
    ms_nn_layer *layer;  /* [layers] */
    ms_nn__op *op;       /* [ops] */
    size_t *place;       /* [ops + 1] of a value: floats from the start of those of one sample */
    size_t *before;      /* [ops + 1] the same of what its activation was applied to; SIZE_MAX: it has none */
    size_t values, tape; /* floats of one sample without and with those */
    size_t scratch;      /* floats of the largest padded input */
};

/* Memory held until the network goes; 64-byte aligned for the kernels' sake; NULL: none left. */
static void *ms_nn__allocate(ms_nn *nn, size_t count, size_t size)
{
    size_t bytes = ms__size_add(ms__size_mul(count, size), sizeof(ms_nn__memory) + 64);
    ms_nn__memory *m = (ms_nn__memory *)ms__alloc(&nn->options.allocator, bytes);
    uintptr_t at;
    if (m == NULL) return NULL;
    m->next = nn->memory;
    m->bytes = bytes;
    nn->memory = m;
    at = ((uintptr_t)(m + 1) + 63) & ~(uintptr_t)63;
    return (void *)at;
}

static MS_NN__COLD ms_nn_shape ms_nn__shape(ms_nn__dims d, int rank)
{
    ms_nn_shape s;
    s.rank = rank;
    s.size[0] = d.c;
    s.size[1] = rank == 3 ? d.h : rank == 2 ? d.w : 0;
    s.size[2] = rank == 3 ? d.w : 0;
    return s;
}

enum { MS_NN__NAME_SIZE = 256 }; /* of a tensor that a layer names, with its NUL */

/* Tensor <layer>.<part>; NULL: there is none. name: its name, room for MS_NN__NAME_SIZE. */
static MS_NN__COLD const ms_nn_tensor *ms_nn__part(const ms_nn *nn, const char *layer, const char *part, char *name)
{
    const size_t n = strlen(layer);
    memcpy(name, layer, n);
    name[n] = '.';
    memcpy(name + n + 1, part, strlen(part) + 1);
    return ms_nn_file_find(nn->file, name);
}

/* The same, with the expected shape (0: any size but 0); *tensor NULL if it is absent and may be. */
static MS_NN__COLD ms_status ms_nn__tensor(const ms_nn *nn, const char *layer, const char *part, int rank,
                                           const size_t *shape, int required, const ms_nn_tensor **tensor,
                                           ms_error *error)
{
    char name[MS_NN__NAME_SIZE];
    const ms_nn_tensor *t = *tensor = ms_nn__part(nn, layer, part, name);
    int d;
    if (t == NULL) return required ? ms__fail(error, MS_BAD_DATA, 0, "there is no tensor '%s'", name) : MS_OK;
    if (t->rank != rank) return ms__fail(error, MS_BAD_DATA, 0, "not of %d dimensions: the tensor '%s'", rank, name);
    for (d = 0; d < rank; ++d) {
        if (shape[d] != 0 && t->shape[d] != shape[d])
            return ms__fail(error, MS_BAD_DATA, 0, "dimension %d is %z, the layer list makes it %z: the tensor '%s'", d,
                            t->shape[d], shape[d], name);
        if (t->shape[d] == 0) return ms__fail(error, MS_BAD_DATA, 0, "dimension %d is 0: the tensor '%s'", d, name);
    }
    return MS_OK;
}

/* A tensor of F32 or F16 as native floats: where it lies if it is that already, else a copy. */
static const unsigned char *ms_nn__floats(ms_nn *nn, const ms_nn_tensor *t)
{
    size_t count = t->bytes / ms_nn__bytes_of(t->dtype), i;
    float *copy;
    if (t->dtype == MS_NN_F32 && !MS_NN__BIG_ENDIAN) return (const unsigned char *)t->data;
    copy = (float *)ms_nn__allocate(nn, count, sizeof(float));
    for (i = 0; copy && i < count; ++i) copy[i] = ms_nn__element(t->data, t->dtype, i);
    return (const unsigned char *)copy;
}

/* The tensors of a layer. */
typedef struct ms_nn__weights {
    const ms_nn_tensor *weight, *bias, *scale;
} ms_nn__weights;

static const char *const ms_nn__part_name[] = {"weight", "bias", "weight_scale"};

/* Finds them; sizes that the layer list leaves open (0 in shape) are read from the weights. */
static MS_NN__COLD ms_status ms_nn__weights_find(ms_nn *nn, const ms_nn__spec *spec, int rank, size_t *shape,
                                                 ms_nn_layer *info, ms_nn__weights *w, ms_error *error)
{
    const ms_nn_tensor **const part[3] = {&w->weight, &w->bias, &w->scale}, *t;
    ms_status status;
    int i, d;
    if (spec->name == NULL) return ms__fail(error, MS_BAD_DATA, 0, "it has no name");
    for (i = 0; i < 3; ++i) {
        const int required = i == 0 || (i == 1 ? spec->bias != 2 : w->weight->dtype == MS_NN_I8);
        status = ms_nn__tensor(nn, spec->name, ms_nn__part_name[i], i == 0 ? rank : 1, shape, required, &t, error);
        if (status != MS_OK) return status;
        *part[i] = t;
        for (d = 0; d < rank && i == 0; ++d) shape[d] = t->shape[d];
    }
    if (spec->bias == 2 && w->bias) return ms__fail(error, MS_BAD_DATA, 0, "it says bias false but has a bias");
    if (w->scale && w->weight->dtype != MS_NN_I8)
        return ms__fail(error, MS_BAD_DATA, 0, "it has a weight_scale, which belongs to I8 weights only");
    for (i = 0; i < 3; ++i) {
        if ((t = *part[i]) == NULL) continue;
        if ((int)t->dtype > (i == 0 ? (int)MS_NN_I8 : (int)MS_NN_F16))
            return ms__fail(error, MS_UNSUPPORTED, 0, "a %s of a network is not of type %s: the tensor '%s'",
                            ms_nn__part_name[i], ms_nn__dtype_name[t->dtype], t->name);
        info->bytes += t->bytes;
        if (i < 2) info->parameters += t->bytes / ms_nn__bytes_of(t->dtype);
    }
    info->multiply_adds = w->weight->bytes / ms_nn__bytes_of(w->weight->dtype);
    info->dtype = w->weight->dtype;
    return MS_OK;
}

enum { MS_NN__PACK_BYTES = 64 << 20 }; /* of a network */

/* Packs a matrix. Nothing here depends on the batch, so that bits do not. 0: no memory. */
static MS_NN__COLD int ms_nn__pack_dense(ms_nn *nn, ms_nn__matrix *m)
{
    const int floats = nn->kernels->level == MS_SIMD_SCALAR || m->dtype == MS_NN_F32;
    const ms_nn_dtype dtype = floats ? MS_NN_F32 : MS_NN_F16;
    const size_t panel = nn->kernels->panel, size = ms_nn__bytes_of(dtype), own = ms_nn__bytes_of(m->dtype),
                 rows = ms_nn__round_up(m->rows, panel), bytes = ms__size_mul(ms__size_mul(rows, size), m->cols);
    unsigned char *w;
    float *scale;
    size_t row, k;
    m->packed = NULL;
    m->packed_dtype = dtype;
    if (ms__size_add(bytes, nn->packed) > MS_NN__PACK_BYTES) return 1;
    m->packed = w = (unsigned char *)ms_nn__allocate(nn, bytes, 1);
    m->packed_scale = scale = (float *)ms_nn__allocate(nn, rows, 2 * sizeof(float));
    m->packed_bias = scale + rows;
    if (w == NULL || scale == NULL) return 0;
    nn->packed += bytes;
    for (row = 0; row < rows; ++row) {
        const unsigned char *from = m->w + (row < m->rows ? row * m->cols * own : 0);
        unsigned char *to = w + (row / panel * panel * m->cols + row % panel) * size;
        scale[row] = row < m->rows && m->scale ? ms_nn__float_at(m->scale, row) : 1;
        scale[rows + row] = row < m->rows && m->bias ? ms_nn__float_at(m->bias, row) : 0;
        for (k = 0; k < m->cols; ++k, from += own, to += panel * size) {
            const float value = row >= m->rows ? 0
                : m->dtype == MS_NN_F32        ? ms_nn__float_at(from, 0)
                                               : ms_nn__element(from, m->dtype, 0);
            if (dtype == MS_NN_F32) memcpy(to, &value, 4);
            else if (m->dtype == MS_NN_F16 && row < m->rows) memcpy(to, from, 2);
            else ms_nn__put_u16(to, ms__half_from_float(value));
        }
    }
    return 1;
}

/* Dense weights where they lie, and packed; on big-endian hosts F32 as a copy in native order (the scalar kernels,
   which are all that those have, read the other types byte by byte). */
static MS_NN__COLD ms_status ms_nn__dense_make(ms_nn *nn, ms_nn__matrix *m, const ms_nn__weights *w)
{
    m->rows = w->weight->shape[0];
    m->cols = w->weight->shape[1];
    m->dtype = w->weight->dtype;
    m->w = m->dtype == MS_NN_F32 ? ms_nn__floats(nn, w->weight) : (const unsigned char *)w->weight->data;
    m->bias = w->bias ? ms_nn__floats(nn, w->bias) : NULL;
    m->scale = w->scale ? ms_nn__floats(nn, w->scale) : NULL;
    if (m->w == NULL || (w->bias && m->bias == NULL) || (w->scale && m->scale == NULL)) return MS_OUT_OF_MEMORY;
    return ms_nn__pack_dense(nn, m) ? MS_OK : MS_OUT_OF_MEMORY;
}

/* Geometry of the padded input: as many rows and columns as the outputs see. 0: no memory. */
static MS_NN__COLD int ms_nn__conv_geometry(ms_nn *nn, ms_nn__conv *v)
{
    const size_t s = v->stride[1], wide = (v->out.w - 1) * s + v->kernel[1], taps = v->kernel[0] * v->kernel[1];
    size_t *offset = (size_t *)ms_nn__allocate(nn, taps, sizeof(size_t)), padded, y, x;
    v->pitch = ms_nn__round_up(wide, s);
    v->rows = (v->out.h - 1) * v->stride[0] + v->kernel[0];
    v->plane = ms__size_mul(v->rows, v->pitch);
    v->taps = taps;
    v->offset = offset;
    padded = ms__size_add(ms__size_mul(v->in.c, v->plane), MS_NN__OVERRUN);
    if (offset == NULL || padded > SIZE_MAX / sizeof(float)) return 0;
    if (padded > nn->scratch) nn->scratch = padded;
    for (y = 0; y < v->kernel[0]; ++y)
        for (x = 0; x < v->kernel[1]; ++x) *offset++ = y * v->pitch + x % s * (v->pitch / s) + x / s;
    return 1;
}

/* Weights and biases by blocks of outputs. */
static MS_NN__COLD ms_status ms_nn__conv_make(ms_nn *nn, ms_nn__conv *v, const ms_nn__weights *w)
{
    const size_t block = nn->kernels->block, outs = v->out.c, padded_outs = ms_nn__round_up(outs, block),
                 terms = v->in.c * v->kernel[0] * v->kernel[1]; /* of an output */
    float *packed = (float *)ms_nn__allocate(nn, ms__size_mul(padded_outs, terms), sizeof(float));
    float *bias = (float *)ms_nn__allocate(nn, padded_outs, sizeof(float));
    size_t o, i;
    if (!packed || !bias || !ms_nn__conv_geometry(nn, v)) return MS_OUT_OF_MEMORY;
    v->packed = packed;
    v->bias = bias;
    for (o = 0; o < padded_outs; ++o) {
        const float scale = w->scale && o < outs ? ms_nn__element(w->scale->data, w->scale->dtype, o) : 1.0f;
        float *to = packed + o / block * block * terms + o % block;
        bias[o] = w->bias && o < outs ? ms_nn__element(w->bias->data, w->bias->dtype, o) : 0.0f;
        for (i = 0; i < terms; ++i)
            to[i * block] = o < outs ? scale * ms_nn__element(w->weight->data, w->weight->dtype, o * terms + i) : 0.0f;
    }
    return MS_OK;
}

/* Where the builder stands in the layer list. */
typedef struct ms_nn__build {
    ms_nn *nn;
    const ms_nn__list *list;
    int *value;          /* [layers] value that holds a layer's output */
    ms_nn__dims current; /* of the current layer's output */
    int rank;
} ms_nn__build;

static MS_NN__COLD ms_nn__op *ms_nn__op_add(ms_nn__build *b, ms_nn__kind kind, ms_nn__dims out)
{
    ms_nn__op *op = &b->nn->op[b->nn->ops++];
    memset(op, 0, sizeof *op);
    op->kind = kind;
    op->in = b->current;
    op->out = b->current = out;
    return op;
}

static MS_NN__COLD ms_status ms_nn__activation_read(const ms_nn__spec *spec, ms_nn__op *op, ms_nn_layer *info,
                                                    ms_error *error)
{
    int a = 0;
    while (spec->activation && a < (int)MS_NN__ACTIVATIONS && strcmp(ms_nn__activation_name[a], spec->activation)) ++a;
    if (a == (int)MS_NN__ACTIVATIONS)
        return ms__fail(error, MS_BAD_DATA, 0, "unknown activation '%s'", spec->activation);
    op->activation = (ms_nn__activation)a;
    op->alpha = info->alpha = (float)(spec->alpha >= 0 ? spec->alpha : a == (int)MS_NN__LEAKY ? 0.01 : 1.0);
    info->activation = ms_nn__activation_name[a];
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_dense(ms_nn__build *b, const ms_nn__spec *s, ms_nn_layer *info,
                                                ms_error *error)
{
    ms_nn__weights w;
    ms_nn__dims out = {0, 1, 1};
    ms_nn__op *op;
    size_t shape[2];
    ms_status status;
    if (b->rank != 1) return ms__fail(error, MS_BAD_DATA, 0, "it needs a vector: put a flatten before it");
    shape[0] = s->units;
    shape[1] = b->current.c;
    if ((status = ms_nn__weights_find(b->nn, s, 2, shape, info, &w, error)) != MS_OK) return status;
    out.c = shape[0];
    op = ms_nn__op_add(b, MS_NN__DENSE, out);
    if ((status = ms_nn__activation_read(s, op, info, error)) != MS_OK) return status;
    return ms_nn__dense_make(b->nn, &op->matrix, &w);
}

static MS_NN__COLD ms_status ms_nn__build_conv(ms_nn__build *b, const ms_nn__spec *s, ms_nn_layer *info,
                                               ms_error *error)
{
    const int two = s->kind == MS_NN__CONV2D, same = s->padding && strcmp(s->padding, "same") == 0;
    const size_t extent[2] = {b->current.h, b->current.w};
    size_t shape[4], out[2];
    ms_nn__conv v;
    ms_nn__weights w;
    ms_nn__dims dims;
    ms_nn__op *op;
    ms_status status;
    int d;
    if (b->rank != (two ? 3 : 2))
        return ms__fail(error, MS_BAD_DATA, 0, two ? "it needs channels, height, width" : "it needs channels, length");
    if (s->padding && !same && strcmp(s->padding, "valid"))
        return ms__fail(error, MS_BAD_DATA, 0, "padding must be same or valid, not '%s'", s->padding);
    if (same && (s->zeros[0] || s->zeros[1]))
        return ms__fail(error, MS_BAD_DATA, 0, "padding same and zeros exclude each other");
    shape[0] = s->filters;
    shape[1] = b->current.c;
    shape[2] = s->kernel[0];
    shape[3] = s->kernel[1];
    if ((status = ms_nn__weights_find(b->nn, s, two ? 4 : 3, shape, info, &w, error)) != MS_OK) return status;
    memset(&v, 0, sizeof v);
    for (d = 0; d < 2; ++d) { /* height, then width; a signal's height is 1 */
        const int given = two || d == 1, at = two ? d : 0;
        const size_t kernel = given ? shape[two ? 2 + d : 2] : 1, zeros = given ? s->zeros[at] : 0;
        size_t padded = ms__size_add(extent[d], ms__size_mul(2, zeros));
        v.kernel[d] = kernel;
        v.stride[d] = given && s->stride[at] ? s->stride[at] : 1;
        v.pad[d] = same ? (kernel - 1) / 2 : zeros;
        if (same) padded = ms__size_add(extent[d], kernel - 1);
        if (padded > INT_MAX) return ms__fail(error, MS_BAD_DATA, 0, "its padded input is too large");
        if (padded < kernel)
            return ms__fail(error, MS_BAD_DATA, 0, "its kernel has %z, its input only %z", kernel, padded);
        out[d] = (padded - kernel) / v.stride[d] + 1;
        if (out[d] == 1) v.stride[d] = 1; /* no step is taken, and room for one is not needed */
    }
    dims.c = shape[0];
    dims.h = out[0];
    dims.w = out[1];
    if (ms_nn__too_large(dims)) return ms__fail(error, MS_BAD_DATA, 0, "its output is too large");
    v.in = b->current;
    v.out = dims;
    info->multiply_adds = ms__size_mul(info->multiply_adds, dims.h * dims.w);
    op = ms_nn__op_add(b, MS_NN__CONV2D, dims);
    if ((status = ms_nn__activation_read(s, op, info, error)) != MS_OK) return status;
    op->conv = v;
    return ms_nn__conv_make(b->nn, &op->conv, &w);
}

/* Upsampling and pools. */
static MS_NN__COLD ms_status ms_nn__build_resize(ms_nn__build *b, const ms_nn__spec *s, ms_error *error)
{
    const int two = (MS_NN__TWO_D & 1 << s->kind) != 0, global = s->kind == MS_NN__GLOBALPOOL;
    const int up = (MS_NN__UPSAMPLES & 1 << s->kind) != 0;
    const int max = (MS_NN__MAXPOOLS & 1 << s->kind) != 0;
    const size_t *given = up ? s->factor : s->size;
    size_t size[2], stride[2], extent[2];
    ms_nn__dims out = b->current;
    ms_nn__op *op;
    int d;
    if (global ? b->rank < 2 : b->rank != (two ? 3 : 2))
        return ms__fail(error, MS_BAD_DATA, 0,
                        global    ? "it needs channels"
                            : two ? "it needs channels, height, width"
                                  : "it needs channels, length");
    extent[0] = out.h;
    extent[1] = out.w;
    for (d = 0; d < 2; ++d) {
        const int own = two || d == 1, at = two ? d : 0;
        size[d] = global ? extent[d] : !own ? 1 : given[at] ? given[at] : 2;
        stride[d] = own && s->stride[at] ? s->stride[at] : size[d];
        if (up) extent[d] = ms__size_mul(extent[d], size[d]);
        else if (extent[d] < size[d])
            return ms__fail(error, MS_BAD_DATA, 0, "it takes %z, its input has only %z", size[d], extent[d]);
        else extent[d] = (extent[d] - size[d]) / stride[d] + 1;
    }
    out.h = extent[0];
    out.w = extent[1];
    if (ms_nn__too_large(out)) return ms__fail(error, MS_BAD_DATA, 0, "its output is too large");
    op = ms_nn__op_add(b, up ? MS_NN__UPSAMPLE2D : max ? MS_NN__MAXPOOL2D : MS_NN__AVGPOOL2D, out);
    memcpy(op->size, size, sizeof size);
    memcpy(op->stride, stride, sizeof stride);
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_flatten(ms_nn__build *b, const ms_nn__spec *s, ms_error *error)
{
    const int last = s->order != NULL && strcmp(s->order, "channels_last") == 0;
    if (s->order != NULL && !last && strcmp(s->order, "channels_first"))
        return ms__fail(error, MS_BAD_DATA, 0, "flatten order must be channels_first or channels_last, not '%s'",
                        s->order);
    if (last && b->current.c > 1 && b->current.h * b->current.w > 1) ms_nn__op_add(b, MS_NN__FLATTEN, b->current);
    b->current.c = ms_nn__count(b->current);
    b->current.h = b->current.w = 1;
    b->rank = 1;
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_add(ms_nn__build *b, const ms_nn__spec *s, int i, ms_nn_layer *info,
                                              ms_error *error)
{
    ms_nn_shape shape = ms_nn__shape(b->current, b->rank), other = shape;
    ms_nn__op *op;
    int k, from = -1;
    if (s->from && strcmp(s->from, "input") == 0) {
        from = 0;
        other = ms_nn__shape(b->nn->inner, b->nn->channel_input ? 1 : b->nn->input.rank);
    }
    for (k = 0; k < i; ++k)
        if (s->from && strcmp(s->from, b->nn->layer[k].name) == 0) {
            from = b->value[k];
            other = b->nn->layer[k].output;
        }
    if (from < 0)
        return ms__fail(error, MS_BAD_DATA, 0, "no layer before it has the name '%s'", s->from ? s->from : "");
    if (shape.rank != other.rank || memcmp(shape.size, other.size, sizeof shape.size) != 0)
        return ms__fail(error, MS_BAD_DATA, 0, "it adds what has another shape: '%s'", s->from);
    info->from = s->from;
    op = ms_nn__op_add(b, MS_NN__ADD, b->current);
    op->skip = from;
    return ms_nn__activation_read(s, op, info, error);
}

static MS_NN__COLD ms_status ms_nn__build_layer(ms_nn__build *b, int i, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    ms_nn_layer *info = &b->nn->layer[i];
    ms_status status = MS_OK;
    memset(info, 0, sizeof *info);
    info->type = ms_nn__kind_name[(int)s->kind];
    info->name = s->name ? s->name : "";
    info->activation = info->from = "";
    info->dtype = MS_NN_DTYPE_COUNT;
    if (strlen(info->name) > MS_NN_MAX_NAME)
        return ms__fail(error, MS_BAD_DATA, 0, "its name has over %d bytes", MS_NN_MAX_NAME);
    switch (s->kind) {
    case MS_NN__DENSE: status = ms_nn__build_dense(b, s, info, error); break;
    case MS_NN__CONV1D:
    case MS_NN__CONV2D: status = ms_nn__build_conv(b, s, info, error); break;
    case MS_NN__FLATTEN: status = ms_nn__build_flatten(b, s, error); break;
    case MS_NN__ADD: status = ms_nn__build_add(b, s, i, info, error); break;
    case MS_NN__ACTIVATE:
        status = ms_nn__activation_read(s, ms_nn__op_add(b, MS_NN__ACTIVATE, b->current), info, error);
        break;
    case MS_NN__DROPOUT:
        if (s->rate >= 1) status = ms__fail(error, MS_BAD_DATA, 0, "its rate must be below 1");
        break;
    case MS_NN__SHARED: break; /* done before the first layer */
    default: status = ms_nn__build_resize(b, s, error); break;
    }
    if (status == MS_OUT_OF_MEMORY) ms__fail(error, status, 0, "no memory for its weights");
    info->output = ms_nn__shape(b->current, b->rank);
    b->value[i] = b->nn->ops;
    return status;
}

/* Where values live: one after the other, then what activations were applied to. */
static MS_NN__COLD ms_status ms_nn__plan(ms_nn *nn, ms_error *error)
{
    const size_t n = (size_t)nn->ops + 1;
    size_t v;
    nn->place = (size_t *)ms_nn__allocate(nn, 2 * n, sizeof(size_t));
    if (nn->place == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the plan");
    nn->before = nn->place + n;
    for (v = 0; v < n; ++v) {
        nn->place[v] = nn->values;
        nn->values = ms__size_add(nn->values, ms_nn__count(v ? nn->op[v - 1].out : nn->inner));
    }
    nn->tape = nn->values;
    for (v = 0; v < n; ++v) {
        nn->before[v] = SIZE_MAX;
        if (v == 0 || nn->op[v - 1].activation == MS_NN__LINEAR) continue;
        nn->before[v] = nn->tape;
        nn->tape = ms__size_add(nn->tape, ms_nn__count(nn->op[v - 1].out));
    }
    if (nn->tape == SIZE_MAX)
        return ms__fail(error, MS_UNSUPPORTED, 0, "the network's values exceed the address space");
    return MS_OK;
}

static const ms_nn__kernels *ms_nn__kernels_for(ms_simd level);

/* The input of one evaluation: a channel's share with shared_channels, else the whole. */
static MS_NN__COLD ms_status ms_nn__build_input(ms_nn__build *b, ms_error *error)
{
    ms_nn *nn = b->nn;
    size_t i;
    b->rank = nn->input.rank;
    b->current.c = nn->input.size[0];
    b->current.h = b->rank == 3 ? nn->input.size[1] : 1;
    b->current.w = b->rank == 1 ? 1 : nn->input.size[b->rank - 1];
    nn->channels = 1;
    if (b->list->channels > 0) {
        nn->channels = b->list->channels;
        nn->channel_inputs = b->list->channel_inputs;
        nn->channel_input = b->list->channel_input;
        for (i = 0; i < nn->channels * nn->channel_inputs; ++i)
            if (nn->channel_input[i] >= ms_nn__count(b->current))
                return ms__fail(error, MS_BAD_DATA, 0, "it names input %z of %z", nn->channel_input[i],
                                ms_nn__count(b->current));
        b->rank = 1;
        b->current.c = nn->channel_inputs;
        b->current.h = b->current.w = 1;
    }
    nn->inner = b->current;
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_all(ms_nn *nn, const char *layers, ms_error *error)
{
    ms_nn__list l;
    ms_nn__build b;
    ms_status status;
    size_t n;
    int i;
    memset(&l, 0, sizeof l);
    memset(&b, 0, sizeof b);
    if ((status = ms_nn__list_read(&l, layers, error)) != MS_OK) return status;
    n = (size_t)l.layers;
    l.spec = (ms_nn__spec *)ms_nn__allocate(nn, n, sizeof *l.spec);
    l.channel_input = (size_t *)ms_nn__allocate(nn, ms__size_mul(l.channels, l.channel_inputs), sizeof(size_t));
    l.pool = (char *)ms_nn__allocate(nn, l.text + 1, 1);
    b.value = (int *)ms_nn__allocate(nn, n, sizeof(int));
    nn->layer = (ms_nn_layer *)ms_nn__allocate(nn, n, sizeof *nn->layer);
    nn->op = (ms_nn__op *)ms_nn__allocate(nn, n + 1, sizeof *nn->op);
    if (!l.spec || !l.channel_input || !l.pool || !b.value || !nn->layer || !nn->op)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z layers", n);
    l.layers = 0;
    l.channels = l.channel_inputs = 0;
    ms_nn__list_read(&l, layers, NULL);
    nn->layers = l.layers;
    b.nn = nn;
    b.list = &l;
    status = ms_nn__build_input(&b, error);
    for (i = 0; i < l.layers; ++i) {
        if (status == MS_OK) status = ms_nn__build_layer(&b, i, error);
        if (status != MS_OK)
            return ms_nn__name_place(error, status, l.spec[i].at, i, ms_nn__kind_name[l.spec[i].kind], l.spec[i].name);
    }
    if (nn->ops == 0) ms_nn__op_add(&b, MS_NN__ACTIVATE, b.current); /* nothing to do is a copy */
    if (ms__size_mul(nn->channels, ms_nn__count(b.current)) > SIZE_MAX / 64)
        return ms__fail(error, MS_BAD_DATA, 0, "the outputs of all channels are too large");
    nn->output = ms_nn__shape(b.current, b.rank);
    if (nn->channel_input) {
        nn->output.rank = 2;
        nn->output.size[1] = ms_nn__count(b.current);
        nn->output.size[0] = nn->channels;
    }
    return ms_nn__plan(nn, error);
}

/* A network of an open file, which it owns from here on. */
static MS_NN__COLD ms_status ms_nn__make(ms_nn_file *file, const ms_nn_options *o, ms_nn **nn, ms_error *error)
{
    ms_nn *made = (ms_nn *)ms__alloc(&o->allocator, sizeof *made);
    const char *version, *input, *layers, *format;
    ms_status status;
    if (made == NULL) {
        ms_nn_file_close(file);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a network");
    }
    memset(made, 0, sizeof *made);
    made->options = *o;
    made->file = file;
    made->kernels = ms_nn__kernels_for(ms__simd_pick(o->simd));
    format = ms_nn_file_metadata(file, "format");
    version = ms_nn_file_metadata(file, "ms_nn_version");
    input = ms_nn_file_metadata(file, "ms_nn_input");
    layers = ms_nn_file_metadata(file, "ms_nn_layers");
    if (version == NULL || input == NULL || layers == NULL)
        status = ms__fail(error, MS_BAD_DATA, 8,
                          "the metadata lack %s; a network has ms_nn_version, ms_nn_input and ms_nn_layers",
                          version == NULL     ? "ms_nn_version"
                              : input == NULL ? "ms_nn_input"
                                              : "ms_nn_layers");
    else if (strcmp(version, "1"))
        status = ms__fail(error, MS_UNSUPPORTED, 8, "ms_nn_version is '%s'; this release reads 1", version);
    else if (format && strcmp(format, "pt"))
        status = ms__fail(error, MS_UNSUPPORTED, 8, "format is '%s'; weights must have PyTorch's layout, pt", format);
    else if ((status = ms_nn__shape_read(&made->input, input, error)) == MS_OK)
        status = ms_nn__build_all(made, layers, error);
    if (status != MS_OK) ms_nn_destroy(made);
    else *nn = made;
    return status;
}

MS_API MS_NN__COLD ms_status ms_nn_load(const void *bytes, size_t size, const ms_nn_options *options, ms_nn **nn,
                                        ms_error *error)
{
    ms_nn_options o = options ? *options : ms_nn_defaults();
    ms_nn_file *file = NULL;
    ms_status status;
    if (nn == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nn is NULL");
    status = ms_nn_file_open(bytes, size, &o, &file, error);
    return status == MS_OK ? ms_nn__make(file, &o, nn, error) : status;
}

/* ---- run ------------------------------------------------------------------------------------------------------- */

/* Of a task: enough to hide the cost of handing it out. */
enum { MS_NN__TASK_PRODUCTS = 262144 };

/* Runs task over count items in chunks; the context holds the chunk's size. */
static void ms_nn__chunks(const ms_nn *nn, size_t count, size_t *chunk, void (*task)(void *, int), void *context)
{
    if (*chunk < 1) *chunk = 1;
    while ((count + *chunk - 1) / *chunk > 1000000) *chunk *= 2; /* task numbers are int */
    ms__run(&nn->options.parallel, (int)((count + *chunk - 1) / *chunk), task, context);
}

static void ms_nn__dense_task(void *context, int index)
{
    const ms_nn__dense *job = (const ms_nn__dense *)context;
    const size_t row0 = (size_t)index * job->chunk, row1 = ms_nn__min(row0 + job->chunk, job->m->rows);
    if (job->m->packed) job->kernels->packed(job, row0, row1);
    else job->kernels->dense(job, row0, row1);
}

static MS_NN__COLD void ms_nn__run_dense(const ms_nn *nn, const ms_nn__op *op, int batch, const float *x, float *y,
                                         int linear)
{
    const ms_nn__matrix *m = &op->matrix;
    ms_nn__dense job;
    job.m = m;
    job.batch = batch;
    job.x = x;
    job.y = y;
    job.linear = linear;
    job.kernels = nn->kernels;
    job.chunk = ms_nn__round_up(MS_NN__TASK_PRODUCTS / m->cols / (size_t)batch + 1, 2 * nn->kernels->panel);
    ms_nn__chunks(nn, m->rows, &job.chunk, ms_nn__dense_task, &job);
}

/* Copies the input: zeros around, columns sorted by their remainder modulo the stride. */
static void ms_nn__pad(const ms_nn__conv *v, const float *input, float *padded)
{
    const size_t s = v->stride[1], wide = v->pitch / s, left = v->pad[1];
    const size_t seen = left < v->pitch ? ms_nn__min(v->in.w, v->pitch - left) : 0; /* columns of the input */
    size_t c, y, x;
    for (c = 0; c < v->in.c; ++c)
        for (y = 0; y < v->rows; ++y) {
            float *to = padded + c * v->plane + y * v->pitch;
            const float *from;
            memset(to, 0, v->pitch * sizeof(float));
            if (y < v->pad[0] || y - v->pad[0] >= v->in.h) continue;
            from = input + (c * v->in.h + y - v->pad[0]) * v->in.w;
            if (s == 1) memcpy(to + ms_nn__min(left, v->pitch), from, seen * sizeof(float));
            else
                for (x = left; x < left + seen; ++x) to[x % s * wide + x / s] = from[x - left];
        }
    memset(padded + v->in.c * v->plane, 0, MS_NN__OVERRUN * sizeof(float));
}

static void ms_nn__conv_task(void *context, int index)
{
    const ms_nn__conv_job *job = (const ms_nn__conv_job *)context;
    const size_t row = (size_t)index * job->chunk;
    job->kernels->conv(job, row, ms_nn__min(row + job->chunk, job->conv->out.h));
}

static MS_NN__COLD void ms_nn__run_conv(const ms_nn *nn, const ms_nn__op *op, const float *x, float *y, int linear,
                                        void *scratch)
{
    const ms_nn__conv *v = &op->conv;
    ms_nn__conv_job job;
    ms_nn__pad(v, x, (float *)scratch);
    job.conv = v;
    job.y = y;
    job.padded = (const float *)scratch;
    job.linear = linear;
    job.kernels = nn->kernels;
    job.chunk = MS_NN__TASK_PRODUCTS / ms__size_mul(v->out.w * v->out.c, v->in.c * v->taps) + 1;
    ms_nn__chunks(nn, v->out.h, &job.chunk, ms_nn__conv_task, &job);
}

/* The first maximum of a window that begins at x[at], or its first NaN. */
static size_t ms_nn__window_max(const ms_nn__op *op, const float *x, size_t at)
{
    size_t best = at, i, j, k;
    int better;
    for (i = 0; i < op->size[0]; ++i)
        for (j = 0; j < op->size[1]; ++j) {
            k = at + i * op->in.w + j;
            better = (x[k] > x[best]) | ((x[k] != x[k]) & (x[best] == x[best]));
            best += (k - best) * (size_t)better; /* a branch would be mispredicted */
        }
    return best;
}

static float ms_nn__window_mean(const ms_nn__op *op, const float *x, size_t at)
{
    double sum = 0, share = 1.0 / ((double)op->size[0] * (double)op->size[1]);
    size_t i, j;
    for (i = 0; i < op->size[0]; ++i)
        for (j = 0; j < op->size[1]; ++j) sum += (double)x[at + i * op->in.w + j];
    return (float)(share * sum);
}

/* point: the values that the maxima are taken of; x: what is picked, the same or a direction. */
static MS_NN__NOINLINE void ms_nn__run_pool(const ms_nn__op *op, const float *point, const float *x, float *y)
{
    size_t c, i, j;
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j) {
                const size_t at = (c * op->in.h + i * op->stride[0]) * op->in.w + j * op->stride[1];
                *y++ = op->kind == MS_NN__AVGPOOL2D ? ms_nn__window_mean(op, x, at)
                                                    : x[ms_nn__window_max(op, point, at)];
            }
}

static void ms_nn__run_upsample(const ms_nn__op *op, const float *x, float *y)
{
    size_t c, i, j;
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j) *y++ = x[(c * op->in.h + i / op->size[0]) * op->in.w + j / op->size[1]];
}

/* [rows][cols] to [cols][rows], whose rows are `pitch` apart. */
static void ms_nn__transpose(const float *x, size_t rows, size_t cols, float *y, size_t pitch)
{
    size_t i, j, i0, j0;
    for (i0 = 0; i0 < rows; i0 += 32)
        for (j0 = 0; j0 < cols; j0 += 32)
            for (j = j0; j < ms_nn__min(j0 + 32, cols); ++j)
                for (i = i0; i < ms_nn__min(i0 + 32, rows); ++i) y[j * pitch + i] = x[i * cols + j];
}

/* ---- products -------------------------------------------------------------------------------------------------- */

/* One run: points x directions. Samples of the caller become channels each with shared_channels. */
typedef struct ms_nn__run {
    const ms_nn *nn;
    size_t points;
    const float *x; /* [points][inner] value 0 */
    float *y;       /* [points][output] the last value; NULL: among the others */
    float *values;  /* of all points */
    int keeps;      /* what activations are applied to */
    void *scratch;
} ms_nn__run;

static size_t ms_nn__value_size(const ms_nn *nn, int v) { return ms_nn__count(v ? nn->op[v - 1].out : nn->inner); }

/* Value v > 0 of all points. */
static float *ms_nn__value(const ms_nn__run *r, int v)
{
    if (v == r->nn->ops && r->y != NULL) return r->y;
    return r->values + r->nn->place[v] * r->points;
}

static const float *ms_nn__input_value(const ms_nn__run *r, int v) { return v == 0 ? r->x : ms_nn__value(r, v); }

/* What the activation that makes value v is applied to; without one it is the value. */
static float *ms_nn__argument(const ms_nn__run *r, int v)
{
    const size_t before = r->keeps ? r->nn->before[v] : SIZE_MAX;
    return before == SIZE_MAX ? ms_nn__value(r, v) : r->values + before * r->points;
}

/* Applies operation k without its activation to `count` vectors: samples if point is NULL, else tangent vectors, `each`
   per sample, at the inputs in point. */
static MS_NN__COLD void ms_nn__apply(const ms_nn *nn, int k, size_t count, const float *x, const float *skip, float *y,
                                     const float *point, size_t each, void *scratch)
{
    const int linear = point != NULL;
    const ms_nn__op *op = &nn->op[k];
    size_t in = ms_nn__count(op->in), out = ms_nn__count(op->out), b, i;
    if (op->kind == MS_NN__DENSE) ms_nn__run_dense(nn, op, (int)count, x, y, linear);
    for (b = 0; b < count; ++b) {
        const float *xb = x + b * in;
        float *yb = y + b * out;
        switch (op->kind) {
        case MS_NN__CONV2D: ms_nn__run_conv(nn, op, xb, yb, linear, scratch); break;
        case MS_NN__UPSAMPLE2D: ms_nn__run_upsample(op, xb, yb); break;
        case MS_NN__MAXPOOL2D:
        case MS_NN__AVGPOOL2D: ms_nn__run_pool(op, linear ? point + b / each * in : xb, xb, yb); break;
        case MS_NN__FLATTEN: ms_nn__transpose(xb, op->in.c, op->in.h * op->in.w, yb, op->in.c); break;
        case MS_NN__ADD:
            for (i = 0; i < out; ++i) yb[i] = xb[i] + skip[b * out + i];
            break;
        case MS_NN__ACTIVATE: memcpy(yb, xb, out * sizeof(float)); break;
        default: break;
        }
    }
}

static MS_NN__COLD void ms_nn__run_forward(const ms_nn__run *r)
{
    int k;
    for (k = 0; k < r->nn->ops; ++k) {
        const ms_nn__op *op = &r->nn->op[k];
        float *argument = ms_nn__argument(r, k + 1);
        ms_nn__apply(r->nn, k, r->points, ms_nn__input_value(r, k), ms_nn__input_value(r, op->skip), argument, NULL, 1,
                     r->scratch);
        r->nn->kernels->activate(argument, ms_nn__value(r, k + 1), r->points * ms_nn__count(op->out), op->activation,
                                 op->alpha, 0);
    }
}

/* Directions dx [points][each][inner] at the values that r keeps; values: theirs. Returns them [points][each][output].
 */
static MS_NN__COLD const float *ms_nn__run_directions(const ms_nn__run *r, size_t each, const float *dx, float *values)
{
    const ms_nn *nn = r->nn;
    ms_nn__run d = *r;
    size_t b, out;
    int k;
    d.points = r->points * each;
    d.x = dx;
    d.y = NULL;
    d.values = values;
    for (k = 0; k < nn->ops; ++k) {
        const ms_nn__op *op = &nn->op[k];
        const float *argument = ms_nn__argument(r, k + 1);
        float *dy = ms_nn__value(&d, k + 1);
        ms_nn__apply(nn, k, d.points, ms_nn__input_value(&d, k), ms_nn__input_value(&d, op->skip), dy,
                     ms_nn__input_value(r, k), each, r->scratch);
        out = ms_nn__count(op->out);
        for (b = 0; b < d.points; ++b)
            nn->kernels->activate(argument + b / each * out, dy + b * out, out, op->activation, op->alpha, 1);
    }
    return ms_nn__value(&d, nn->ops);
}

enum { MS_NN__BATCH = 48 }; /* samples or directions that run together at most */

/* How many samples of a call run together: dense layers gain from many, values should stay in a cache. */
static MS_NN__COLD size_t ms_nn__batch_size(const ms_nn *nn)
{
    size_t dense = 0, n;
    int k, convolutions = 0;
    for (k = 0; k < nn->ops; ++k) {
        if (nn->op[k].kind == MS_NN__DENSE) dense += nn->op[k].matrix.rows * nn->op[k].matrix.cols;
        else convolutions += nn->op[k].kind == MS_NN__CONV2D;
    }
    n = (convolutions ? 131072u : 4194304u) / ms__size_mul(nn->values, nn->channels) / 12 * 12;
    if (nn->channel_input) return nn->channels < 12 ? 12 / nn->channels : 1; /* large pictures: more are slower */
    n = ms_nn__min(n, MS_NN__BATCH);
    return n > 0 ? n : convolutions && dense < 2000000 ? 1 : 12; /* large weights are better read for several */
}

/* A workspace: its pieces, or with base NULL their size. */
typedef struct ms_nn__layout {
    size_t points, each; /* samples times channels; directions a point that run together, 0 for a forward run */
    float *x, *values, *dx, *dvalues;
    void *scratch;
    size_t total; /* bytes */
} ms_nn__layout;

static MS_NN__COLD ms_nn__layout ms_nn__layout_of(const ms_nn *nn, ms_nn_product product, size_t count, void *base)
{
    const int forward = product == MS_NN_FORWARD;
    const size_t in = ms_nn__count(nn->inner);
    ms_nn__layout l;
    ms__arena a;
    size_t vectors;
    a.base = base != NULL ? (char *)(((uintptr_t)base + 63) & ~(uintptr_t)63) : NULL;
    a.used = 0;
    l.points = ms__size_mul(forward ? ms_nn__min(count, ms_nn__batch_size(nn)) : 1, nn->channels);
    l.each = forward ? 0 : ms_nn__min(in, MS_NN__BATCH);
    vectors = ms__size_mul(l.points, l.each);
    l.x = (float *)ms__take(&a, l.points, (nn->channel_input ? in : 0) * sizeof(float));
    l.values = (float *)ms__take(&a, l.points, ms__size_mul(forward ? nn->values : nn->tape, sizeof(float)));
    l.dx = (float *)ms__take(&a, vectors, in * sizeof(float));
    l.dvalues = (float *)ms__take(&a, vectors, ms__size_mul(nn->values, sizeof(float)));
    l.scratch = ms__take(&a, nn->scratch, sizeof(float));
    if (!forward && ms__size_mul(ms__size_mul(ms_nn_output_size(nn), ms_nn_input_size(nn)), sizeof(double)) == SIZE_MAX)
        a.used = SIZE_MAX;
    l.total = l.points > INT_MAX || vectors > INT_MAX ? SIZE_MAX : ms__size_add(a.used, 63); /* to align the first */
    return l;
}

MS_API MS_NN__COLD size_t ms_nn_workspace_size(const ms_nn *nn, ms_nn_product product, int count)
{
    if (nn == NULL) return 0;
    return count < 1 ? SIZE_MAX : ms_nn__layout_of(nn, product, (size_t)count, NULL).total;
}

/* Copies the inputs that each channel sees: x [count][input] to inner [count][channels][channel_inputs]. */
static void ms_nn__gather_inputs(const ms_nn *nn, size_t count, const float *x, float *inner)
{
    size_t n = nn->channels * nn->channel_inputs, input = ms_nn_input_size(nn), b, i;
    for (b = 0; b < count; ++b)
        for (i = 0; i < n; ++i) *inner++ = x[b * input + nn->channel_input[i]];
}

/* A product after its forward run. */
typedef struct ms_nn__call {
    ms_nn__layout layout;
    ms_nn__run run;
} ms_nn__call;

/* The forward run of at most ms_nn__batch_size samples. */
static MS_NN__COLD void ms_nn__begin(ms_nn__call *call, const ms_nn *nn, ms_nn_product product, size_t count,
                                     const float *x, float *y, void *workspace)
{
    call->layout = ms_nn__layout_of(nn, product, count, workspace);
    call->run.nn = nn;
    call->run.points = call->layout.points;
    call->run.x = x;
    call->run.y = y;
    call->run.values = call->layout.values;
    call->run.keeps = product == MS_NN_JACOBIAN;
    call->run.scratch = call->layout.scratch;
    if (nn->channel_input != NULL) {
        call->run.x = call->layout.x;
        ms_nn__gather_inputs(nn, count, x, call->layout.x);
    }
    ms_nn__run_forward(&call->run);
}

/* The caller's workspace or, where that is NULL, one of the allocator, which is to be released; NULL: no memory. */
static MS_NN__COLD void *ms_nn__borrow(const ms_nn *nn, size_t size, void *workspace, void **allocated)
{
    *allocated = NULL;
    if (workspace == NULL && size != SIZE_MAX) workspace = *allocated = ms__alloc(&nn->options.allocator, size);
    return size != SIZE_MAX ? workspace : NULL;
}

MS_API MS_NN__COLD ms_status ms_nn_forward(const ms_nn *nn, int count, const float *x, float *y, void *workspace)
{
    ms_nn__call call;
    void *allocated;
    size_t at, n, size;
    if (nn == NULL || count < 1 || x == NULL || y == NULL) return MS_INVALID_ARGUMENT;
    size = ms_nn_workspace_size(nn, MS_NN_FORWARD, count);
    workspace = ms_nn__borrow(nn, size, workspace, &allocated);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    for (at = 0; at < (size_t)count; at += n) {
        n = ms_nn__min((size_t)count - at, ms_nn__batch_size(nn));
        ms_nn__begin(&call, nn, MS_NN_FORWARD, n, x + at * ms_nn_input_size(nn), y + at * ms_nn_output_size(nn),
                     workspace);
    }
    ms__release(&nn->options.allocator, allocated, size);
    return MS_OK;
}

/* Columns [first, first + n) of the Jacobians of the points, one after the other: [points][n][output]; n is at most
   call->layout.each. */
static MS_NN__COLD const float *ms_nn__columns(const ms_nn__call *call, size_t first, size_t n)
{
    const ms_nn *nn = call->run.nn;
    const size_t in = ms_nn__count(nn->inner), points = call->run.points;
    size_t c, i;
    memset(call->layout.dx, 0, points * n * in * sizeof(float));
    for (c = 0; c < points; ++c)
        for (i = 0; i < n; ++i) call->layout.dx[(c * n + i) * in + first + i] = 1;
    return ms_nn__run_directions(&call->run, n, call->layout.dx, call->layout.dvalues);
}

MS_API MS_NN__COLD ms_status ms_nn_jacobian(const ms_nn *nn, const float *x, float *y, float *jacobian, void *workspace)
{
    ms_nn__call call;
    void *allocated;
    size_t size, in, out, input, first, n, c, i, o;
    if (nn == NULL || x == NULL || jacobian == NULL) return MS_INVALID_ARGUMENT;
    size = ms_nn_workspace_size(nn, MS_NN_JACOBIAN, 1);
    workspace = ms_nn__borrow(nn, size, workspace, &allocated);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    ms_nn__begin(&call, nn, MS_NN_JACOBIAN, 1, x, y, workspace);
    in = ms_nn__count(nn->inner);
    out = ms_nn__value_size(nn, nn->ops);
    input = ms_nn_input_size(nn);
    if (nn->channel_input) memset(jacobian, 0, nn->channels * out * input * sizeof(float));
    for (first = 0; first < in; first += n) {
        const float *columns;
        n = ms_nn__min(in - first, call.layout.each);
        columns = ms_nn__columns(&call, first, n);
        for (c = 0; c < nn->channels; ++c, columns += n * out)
            if (nn->channel_input)
                for (o = 0; o < out; ++o)
                    for (i = 0; i < n; ++i)
                        jacobian[(c * out + o) * input + nn->channel_input[c * in + first + i]] += columns[i * out + o];
            else ms_nn__transpose(columns, n, out, jacobian + first, input);
    }
    ms__release(&nn->options.allocator, allocated, size);
    return MS_OK;
}

/* ---- queries --------------------------------------------------------------------------------------------------- */

static const ms_nn_shape ms_nn__no_shape = {0, {0, 0, 0}};

MS_API ms_nn_shape ms_nn_input_shape(const ms_nn *nn) { return nn ? nn->input : ms_nn__no_shape; }
MS_API ms_nn_shape ms_nn_output_shape(const ms_nn *nn) { return nn ? nn->output : ms_nn__no_shape; }

MS_API size_t ms_nn_input_size(const ms_nn *nn)
{
    if (nn == NULL) return 0;
    return nn->input.size[0] * (nn->input.rank > 1 ? nn->input.size[1] : 1) *
        (nn->input.rank > 2 ? nn->input.size[2] : 1);
}

MS_API size_t ms_nn_output_size(const ms_nn *nn) { return nn ? nn->channels * ms_nn__value_size(nn, nn->ops) : 0; }
MS_API int ms_nn_layer_count(const ms_nn *nn) { return nn ? nn->layers : 0; }
MS_API MS_NN__COLD ms_nn_layer ms_nn_layer_at(const ms_nn *nn, int i)
{
    ms_nn_layer none;
    if (nn != NULL && i >= 0 && i < nn->layers) return nn->layer[i];
    memset(&none, 0, sizeof none);
    none.type = none.name = none.activation = none.from = "";
    none.dtype = MS_NN_DTYPE_COUNT;
    return none;
}

MS_API const ms_nn_file *ms_nn_tensors(const ms_nn *nn) { return nn ? nn->file : NULL; }
MS_API ms_simd ms_nn_simd(const ms_nn *nn) { return nn ? nn->kernels->level : MS_SIMD_AUTO; }

MS_API const size_t *ms_nn_channel_inputs(const ms_nn *nn, size_t *channels, size_t *count)
{
    if (nn == NULL || channels == NULL || count == NULL) return NULL;
    *channels = nn->channels;
    *count = ms_nn__count(nn->inner);
    return nn->channel_input;
}

MS_API MS_NN__COLD ms_status ms_nn_check_weights(const ms_nn *nn, ms_error *error)
{
    char name[MS_NN__NAME_SIZE];
    int l, p;
    size_t i;
    if (nn == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nn is NULL");
    for (l = 0; l < nn->layers; ++l)
        for (p = 0; p < 3 && nn->layer[l].dtype != MS_NN_DTYPE_COUNT; ++p) {
            const ms_nn_tensor *t = ms_nn__part(nn, nn->layer[l].name, ms_nn__part_name[p], name);
            for (i = 0; t && i < t->bytes / ms_nn__bytes_of(t->dtype); ++i) {
                const float value = ms_nn__element(t->data, t->dtype, i);
                if (!ms__finite_f(value))
                    return ms__fail(error, MS_BAD_DATA, i, "element %z is %g: the tensor '%s'", i, (double)value, name);
            }
        }
    return MS_OK;
}

MS_API MS_NN__COLD void ms_nn_destroy(ms_nn *nn)
{
    ms_nn__memory *m, *next;
    ms_allocator allocator;
    if (nn == NULL) return;
    allocator = nn->options.allocator;
    for (m = nn->memory; m; m = next) {
        next = m->next;
        ms__release(&allocator, m, m->bytes);
    }
    ms_nn_file_close(nn->file);
    ms__release(&allocator, nn, sizeof *nn);
}

/* ---- stdio ----------------------------------------------------------------------------------------------------- */

#ifndef MS_NN_NO_STDIO
/* A whole stream into one allocation of *size bytes, of which *used are the file; NULL: no memory. */
static MS_NN__COLD void *ms_nn__read_whole(FILE *f, const ms_allocator *allocator, size_t *size, size_t *used)
{
    char *at = NULL;
    *size = *used = 0;
    while (*used == *size) {
        const size_t room = *size ? ms__size_mul(*size, 2) : 65536;
        char *larger = (char *)ms__alloc(allocator, room);
        if (larger && *used) memcpy(larger, at, *used);
        ms__release(allocator, at, *size);
        if (larger == NULL) return NULL;
        at = larger;
        *size = room;
        *used += fread(at + *used, 1, *size - *used, f);
    }
    return at;
}

MS_API MS_NN__COLD ms_status ms_nn_file_read(const char *path, const ms_nn_options *options, ms_nn_file **file,
                                             ms_error *error)
{
    ms_nn_options o = options ? *options : ms_nn_defaults();
    size_t size, used;
    ms_status status;
    void *content;
    FILE *f;
    if (path == NULL || file == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", path == NULL ? "path" : "file");
    f = fopen(path, "rb");
    if (f == NULL) return ms__fail(error, MS_IO, 0, "cannot open '%s'", path);
    content = ms_nn__read_whole(f, &o.allocator, &size, &used);
    if (content == NULL) status = ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for '%s'", path);
    else if (ferror(f)) status = ms__fail(error, MS_IO, used, "cannot read '%s'", path);
    else status = ms_nn_file_open(content, used, &o, file, error);
    fclose(f);
    if (status != MS_OK) {
        ms__release(&o.allocator, content, size);
        return status;
    }
    (*file)->content = content;
    (*file)->content_bytes = size;
    return MS_OK;
}

MS_API MS_NN__COLD ms_status ms_nn_load_file(const char *path, const ms_nn_options *options, ms_nn **nn,
                                             ms_error *error)
{
    ms_nn_options o = options ? *options : ms_nn_defaults();
    ms_nn_file *file = NULL;
    ms_status status;
    if (nn == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nn is NULL");
    status = ms_nn_file_read(path, &o, &file, error);
    return status == MS_OK ? ms_nn__make(file, &o, nn, error) : status;
}

#endif /* MS_NN_NO_STDIO */

/* ---- collapse -------------------------------------------------------------------------------------------------- */

struct ms_nn_collapse {
    ms_nn body; /* the network without its last layer: a view, it owns nothing */
    const ms_nn *nn;
    const ms_nn__matrix *m; /* W, b */
    size_t channels, h;     /* features of a channel */
    size_t wide;            /* h rounded up to MS_NN__DOUBLES: the pitch of all rows of features, zeros at their ends */
    size_t bytes;
    float *weight; /* [channels][rows] diagonal of M */
    size_t *owner; /* [channels] the first channel with the same weights, which holds R for them */
    double *r;     /* [channels][wide][wide] upper triangles */
    double *h0;    /* [channels][wide] of the target */
    double *e;     /* [channels][wide] */
    double rest;
    int has_target;
    size_t across; /* channels rounded up to MS_NN__DOUBLES; what follows is workspace of a pass, zeros at its ends */
    double *w;     /* [MS_NN__COLLAPSE_ROWS][wide] rows of W */
    double *residual; /* [MS_NN__COLLAPSE_ROWS][across] */
    double *turned;   /* [wide][across] h0 transposed */
    double *sum;      /* [channels rounded up to 4][wide], then one number */
};

enum { MS_NN__COLLAPSE_ROWS = 32 }; /* of W in double together: they stay in a cache */

/* A pass over W in double. Gram: sum of m_i w_i w_i'. Else with the residuals res of h0: sum of w_i m_i res_i of each
   channel, then of m_i res_i^2. */
typedef struct ms_nn__pass {
    const ms_nn_collapse *c;
    const float *weight; /* Gram: [rows] */
    const float *target; /* [channels][rows]; NULL: Gram */
    double *sum;         /* [length] */
    size_t length;
    int has_h0;
} ms_nn__pass;

/* Rows row[0..n) of W as doubles. */
static void ms_nn__collapse_rows(const ms_nn_collapse *c, const size_t *row, size_t n, double *w)
{
    const ms_nn__matrix *m = c->m;
    size_t i;
    for (i = 0; i < n; ++i, w += c->wide) {
        const double scale = m->scale ? (double)ms_nn__float_at(m->scale, row[i]) : 1.0;
        c->nn->kernels->widen(m->w + row[i] * m->cols * ms_nn__bytes_of(m->dtype), c->h, scale, w, m->dtype);
    }
}

/* Adds n rows of W to W'MW: the upper triangle, from each tile's first column on. */
static void ms_nn__gram_rows(const ms_nn__pass *p, const size_t *row, size_t n)
{
    const ms_nn_collapse *c = p->c;
    ms_nn__product_job job;
    size_t i, k;
    for (i = 0; i < n; ++i) {
        const double root = sqrt((double)p->weight[row[i]]);
        for (k = 0; k < c->h; ++k) c->w[i * c->wide + k] *= root;
    }
    job.a_row = 1;
    job.a_column = job.b_row = job.out_row = c->wide;
    job.count = n;
    for (i = 0; i < c->h; i += MS_NN__DOUBLES) {
        job.a = job.b = c->w + i;
        job.out = p->sum + i * c->wide + i;
        job.rows = MS_NN__DOUBLES;
        job.cols = c->wide - i;
        c->nn->kernels->product(&job);
    }
}

/* Adds what n rows have in the sums of the target. */
static void ms_nn__target_rows(const ms_nn__pass *p, const size_t *row, size_t n)
{
    const ms_nn_collapse *c = p->c;
    ms_nn__product_job job;
    size_t i, ch;
    memset(c->residual, 0, MS_NN__COLLAPSE_ROWS * c->across * sizeof(double));
    job.a = c->w; /* W h0, if h0 is not 0 */
    job.a_row = c->wide;
    job.a_column = 1;
    job.b = c->turned;
    job.b_row = job.out_row = job.cols = c->across;
    job.out = c->residual;
    job.count = c->h;
    job.rows = ms_nn__round_up(n, 4);
    if (p->has_h0) c->nn->kernels->product(&job);
    for (i = 0; i < n; ++i)
        for (ch = 0; ch < c->channels; ++ch) {
            const size_t output = ch * c->m->rows + row[i];
            const double bias = c->m->bias ? (double)ms_nn__float_at(c->m->bias, row[i]) : 0.0;
            const double res = (double)p->target[output] - bias - c->residual[i * c->across + ch];
            c->residual[i * c->across + ch] = (double)c->weight[output] * res;
            p->sum[p->length - 1] += (double)c->weight[output] * res * res;
        }
    job.a = c->residual; /* W' (M res) */
    job.a_row = 1;
    job.a_column = c->across;
    job.b = c->w;
    job.b_row = job.out_row = job.cols = c->wide;
    job.out = p->sum;
    job.count = n;
    job.rows = ms_nn__round_up(c->channels, 4);
    c->nn->kernels->product(&job);
}

/* Has row i of W a weight in the sum? */
static int ms_nn__pass_sees(const ms_nn__pass *p, size_t i)
{
    size_t ch;
    if (p->target == NULL) return p->weight[i] > 0;
    for (ch = 0; ch < p->c->channels; ++ch)
        if (p->c->weight[ch * p->c->m->rows + i] > 0) return 1;
    return 0;
}

static void ms_nn__pass_run(const ms_nn__pass *p)
{
    size_t row[MS_NN__COLLAPSE_ROWS], i, n = 0;
    memset(p->sum, 0, p->length * sizeof(double));
    for (i = 0; i < p->c->m->rows; ++i) {
        if (ms_nn__pass_sees(p, i)) row[n++] = i;
        if (n < MS_NN__COLLAPSE_ROWS && i + 1 < p->c->m->rows) continue;
        ms_nn__collapse_rows(p->c, row, n, p->c->w);
        if (p->target == NULL) ms_nn__gram_rows(p, row, n);
        else ms_nn__target_rows(p, row, n);
        n = 0;
    }
}

/* R of W'MW = R'R in place, upper triangles with rows `wide` apart. A pivot below 1e-14 of its column's square is
   rounding: a direction that no output sees, whose row of R is 0. */
static void ms_nn__cholesky(double *g, size_t h, size_t wide, double *diagonal)
{
    size_t i, j, k;
    for (i = 0; i < h; ++i) diagonal[i] = g[i * wide + i];
    for (k = 0; k < h; ++k) {
        double *row = g + k * wide;
        const double pivot = row[k];
        const int seen = pivot > 1e-14 * diagonal[k];
        for (j = 0; j < k; ++j) row[j] = 0.0;
        for (j = k; j < h; ++j) row[j] = seen ? row[j] / sqrt(pivot) : 0.0;
        for (i = k + 1; i < h && seen; ++i)
            for (j = i; j < h; ++j) g[i * wide + j] -= row[i] * row[j];
    }
}

/* The arrays; called to count with arena->base NULL, then to place. Returns where the collapse itself stands. */
static MS_NN__COLD void *ms_nn__collapse_place(ms_nn_collapse *c, ms__arena *arena)
{
    const size_t row = ms__size_mul(c->wide, sizeof(double)), across = ms__size_mul(c->across, sizeof(double));
    void *place = ms__take(arena, 1, sizeof *c);
    c->r = (double *)ms__take(arena, ms__size_mul(c->channels, c->wide), row);
    c->h0 = (double *)ms__take(arena, c->channels, row);
    c->e = (double *)ms__take(arena, c->channels, row);
    c->owner = (size_t *)ms__take(arena, c->channels, sizeof(size_t));
    c->weight = (float *)ms__take(arena, c->channels, ms__size_mul(c->m->rows, sizeof(float)));
    c->w = (double *)ms__take(arena, MS_NN__COLLAPSE_ROWS, row);
    c->residual = (double *)ms__take(arena, MS_NN__COLLAPSE_ROWS, across);
    c->turned = (double *)ms__take(arena, c->wide, across);
    c->sum = (double *)ms__take(arena, c->channels + 4, row);
    return place;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_create(const ms_nn *nn, const float *weight, ms_nn_collapse **c,
                                                   ms_error *error)
{
    const ms_nn__op *last;
    ms_nn_collapse made;
    ms_nn__pass pass;
    size_t i, k, rows;
    ms__arena a = {NULL, 0};
    if (nn == NULL || c == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", nn == NULL ? "nn" : "c");
    last = &nn->op[nn->ops - 1];
    if (last->kind != MS_NN__DENSE || last->activation != MS_NN__LINEAR)
        return ms__fail(error, MS_UNSUPPORTED, 0, "only a network whose last layer is dense and linear collapses");
    memset(&made, 0, sizeof made);
    memset(&pass, 0, sizeof pass);
    made.nn = nn;
    made.body = *nn;
    made.body.ops--;
    made.body.values = nn->place[nn->ops];
    made.m = &last->matrix;
    made.channels = nn->channels;
    made.h = last->matrix.cols;
    made.wide = ms_nn__round_up(made.h, MS_NN__DOUBLES);
    made.across = ms_nn__round_up(made.channels, MS_NN__DOUBLES);
    rows = last->matrix.rows;
    for (i = 0; weight && i < made.channels * rows; ++i)
        if (!ms__finite_f(weight[i]) || weight[i] < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "weight %z is %g; it must be finite and not negative", i,
                            (double)weight[i]);
    ms_nn__collapse_place(&made, &a);
    made.bytes = a.used;
    a.base = (char *)ms__alloc(&nn->options.allocator, a.used);
    if (a.base == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a collapse of %z features", made.h);
    memset(a.base, 0, made.bytes);
    a.used = 0;
    *c = (ms_nn_collapse *)ms_nn__collapse_place(&made, &a);
    **c = made;
    for (i = 0; i < made.channels * rows; ++i) made.weight[i] = weight ? weight[i] : 1.0f;
    pass.c = *c;
    pass.length = made.wide * made.wide;
    for (i = 0; i < made.channels; ++i) {
        for (k = 0; memcmp(made.weight + k * rows, made.weight + i * rows, rows * sizeof(float)) != 0;) ++k;
        made.owner[i] = k;
        if (k < i) continue;
        pass.weight = made.weight + i * rows;
        pass.sum = made.r + i * pass.length;
        ms_nn__pass_run(&pass);
        ms_nn__cholesky(pass.sum, made.h, made.wide, made.w);
    }
    return MS_OK;
}

MS_API void ms_nn_collapse_destroy(ms_nn_collapse *c)
{
    if (c != NULL) ms__release(&c->nn->options.allocator, c, c->bytes);
}

MS_API size_t ms_nn_collapse_features(const ms_nn_collapse *c) { return c ? c->channels * c->h : 0; }

/* R' y = x, in place; 0 where R has no pivot. */
static void ms_nn__solve_transposed(const double *r, size_t h, size_t wide, double *x)
{
    size_t i, j;
    for (j = 0; j < h; ++j, r += wide) {
        x[j] = r[j] > 0 ? x[j] / r[j] : 0.0;
        for (i = j + 1; i < h; ++i) x[i] -= r[i] * x[j];
    }
}

/* R z = y, in place; 0 where R has no pivot. */
static void ms_nn__solve(const double *r, size_t h, size_t wide, double *x)
{
    size_t i, j;
    for (j = h; j-- > 0;) {
        const double *row = r + j * wide;
        for (i = j + 1; i < h; ++i) x[j] -= row[i] * x[i];
        x[j] = row[j] > 0 ? x[j] / row[j] : 0.0;
    }
}

/* R of a channel. */
static const double *ms_nn__collapse_r(const ms_nn_collapse *c, size_t channel)
{
    return c->r + c->owner[channel] * c->wide * c->wide;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_target(ms_nn_collapse *c, const float *target, ms_error *error)
{
    ms_nn__pass p;
    size_t features, i, ch;
    double norm = 0;
    if (c == NULL || target == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", c == NULL ? "c" : "target");
    features = c->channels * c->wide;
    for (i = 0; i < c->channels * c->m->rows; ++i)
        if (!ms__finite_f(target[i]))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "target value %z is not finite", i);
    memset(&p, 0, sizeof p);
    p.c = c;
    p.sum = c->sum;
    p.length = ms_nn__round_up(c->channels, 4) * c->wide + 1;
    p.target = target;
    ms_nn__pass_run(&p); /* W'M (t - b) = R'R h0 */
    memcpy(c->h0, p.sum, features * sizeof(double));
    for (ch = 0; ch < c->channels; ++ch) {
        double *h0 = c->h0 + ch * c->wide;
        ms_nn__solve_transposed(ms_nn__collapse_r(c, ch), c->h, c->wide, h0);
        ms_nn__solve(ms_nn__collapse_r(c, ch), c->h, c->wide, h0);
        for (i = 0; i < c->h; ++i) c->turned[i * c->across + ch] = h0[i];
    }
    p.has_h0 = 1;
    ms_nn__pass_run(&p); /* W'M res = R'e and |res|_M^2 of h0 */
    memcpy(c->e, p.sum, features * sizeof(double));
    for (ch = 0; ch < c->channels; ++ch)
        ms_nn__solve_transposed(ms_nn__collapse_r(c, ch), c->h, c->wide, c->e + ch * c->wide);
    for (i = 0; i < features; ++i) norm += c->e[i] * c->e[i];
    c->rest = p.sum[p.length - 1] > norm ? p.sum[p.length - 1] - norm : 0.0;
    c->has_target = 1;
    return MS_OK;
}

/* The workspace of an evaluation, or with base NULL its size. */
typedef struct ms_nn__collapse_layout {
    size_t across;    /* the value and the inputs of a channel, rounded up to MS_NN__DOUBLES */
    double *columns;  /* [channels][h][across] h - h0, then the Jacobian of h */
    double *products; /* [h rounded up][across] R times those of a channel */
    float *features;  /* [channels][h] */
    void *body;
    size_t total; /* bytes */
} ms_nn__collapse_layout;

static MS_NN__COLD ms_nn__collapse_layout ms_nn__collapse_layout_of(const ms_nn_collapse *c, int with_jacobian,
                                                                    void *base)
{
    const ms_nn_product product = with_jacobian ? MS_NN_JACOBIAN : MS_NN_FORWARD;
    const size_t body = c->body.ops == 0 ? 0 : ms_nn_workspace_size(&c->body, product, 1);
    ms_nn__collapse_layout l;
    ms__arena a;
    a.base = base != NULL ? (char *)(((uintptr_t)base + 63) & ~(uintptr_t)63) : NULL;
    a.used = 0;
    l.across = ms_nn__round_up(1 + (with_jacobian ? ms_nn__count(c->nn->inner) : 0), MS_NN__DOUBLES);
    l.columns = (double *)ms__take(&a, c->channels, ms__size_mul(c->h, ms__size_mul(l.across, sizeof(double))));
    l.products = (double *)ms__take(&a, c->wide, ms__size_mul(l.across, sizeof(double)));
    l.features = (float *)ms__take(&a, c->channels, ms__size_mul(c->h, sizeof(float)));
    l.body = ms__take(&a, body, 1);
    l.total = ms__size_add(a.used, 63);
    return l;
}

MS_API size_t ms_nn_collapse_workspace_size(const ms_nn_collapse *c, int with_jacobian)
{
    return c != NULL ? ms_nn__collapse_layout_of(c, with_jacobian, NULL).total : 0;
}

/* products = R columns, eight rows at a time, each from its diagonal on. */
static void ms_nn__collapse_multiply(const ms_nn_collapse *c, size_t channel, const ms_nn__collapse_layout *l)
{
    ms_nn__product_job job;
    size_t i;
    memset(l->products, 0, c->wide * l->across * sizeof(double));
    job.a_row = c->wide;
    job.a_column = 1;
    job.b_row = job.out_row = job.cols = l->across;
    for (i = 0; i < c->h; i += MS_NN__DOUBLES) {
        job.a = ms_nn__collapse_r(c, channel) + i * c->wide + i;
        job.b = l->columns + (channel * c->h + i) * l->across;
        job.out = l->products + i * l->across;
        job.count = c->h - i;
        job.rows = MS_NN__DOUBLES;
        c->nn->kernels->product(&job);
    }
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_residual(const ms_nn_collapse *c, const float *x, double *residual,
                                                     double *jacobian, void *workspace)
{
    const ms_nn *nn;
    ms_nn__collapse_layout l;
    ms_nn__call call;
    void *allocated;
    size_t size, h, in, inputs, ch, i, k, first, n;
    if (c == NULL || x == NULL || residual == NULL || !c->has_target) return MS_INVALID_ARGUMENT;
    nn = c->nn;
    h = c->h;
    in = ms_nn__count(nn->inner);
    inputs = ms_nn_input_size(nn);
    size = ms_nn_collapse_workspace_size(c, jacobian != NULL);
    workspace = ms_nn__borrow(nn, size, workspace, &allocated);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    l = ms_nn__collapse_layout_of(c, jacobian != NULL, workspace);
    if (c->body.ops > 0)
        ms_nn__begin(&call, &c->body, jacobian ? MS_NN_JACOBIAN : MS_NN_FORWARD, 1, x, l.features, l.body);
    else if (nn->channel_input) ms_nn__gather_inputs(nn, 1, x, l.features);
    else memcpy(l.features, x, h * sizeof(float));
    memset(l.columns, 0, c->channels * h * l.across * sizeof(double));
    for (i = 0; i < c->channels * h; ++i)
        l.columns[i * l.across] = (double)l.features[i] - c->h0[i / h * c->wide + i % h];
    for (first = 0; jacobian && first < in; first += n) {
        const float *slopes = NULL; /* of h(x): [channels][n][h] */
        n = c->body.ops > 0 ? ms_nn__min(in - first, call.layout.each) : in;
        if (c->body.ops > 0) slopes = ms_nn__columns(&call, first, n);
        for (ch = 0; ch < c->channels; ++ch)
            for (k = 0; k < n; ++k)
                for (i = 0; i < h; ++i)
                    l.columns[(ch * h + i) * l.across + 1 + first + k] = slopes ? (double)*slopes++
                        : i == k                                                ? 1.0
                                                                                : 0.0;
    }
    if (jacobian) memset(jacobian, 0, (c->channels * h + 1) * inputs * sizeof(double));
    for (ch = 0; ch < c->channels; ++ch) {
        ms_nn__collapse_multiply(c, ch, &l);
        for (i = 0; i < h; ++i) {
            const double *product = l.products + i * l.across;
            residual[ch * h + i] = product[0] - c->e[ch * c->wide + i];
            for (k = 0; jacobian && k < in; ++k)
                jacobian[(ch * h + i) * inputs + (nn->channel_input ? nn->channel_input[ch * in + k] : k)] +=
                    product[1 + k];
        }
    }
    residual[c->channels * h] = sqrt(c->rest);
    ms__release(&nn->options.allocator, allocated, size);
    return MS_OK;
}

/* ---- levels ---------------------------------------------------------------------------------------------------- */

/* Full unrolling of the short loops over register tiles, also at -O2, and inlining of what has constant arguments. Not
   with clang's sanitizers, where it takes minutes to compile, and not at -O0, where every form's stack would count. */
#if !defined(__OPTIMIZE__)
#define MS_NN__UNROLL
#elif !defined(__clang__)
#define MS_NN__UNROLL _Pragma("GCC unroll 16")
#elif __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer) || __has_feature(thread_sanitizer)
#define MS_NN__UNROLL
#else
#define MS_NN__UNROLL _Pragma("clang loop unroll(full)")
#endif
#if defined(__OPTIMIZE__)
#define MS_NN__INLINE static inline MS_NN__TARGET __attribute__((always_inline))
#else
#define MS_NN__INLINE static inline MS_NN__TARGET
#endif

/* y = x Phi(x), or with slope y *= Phi(x) + x phi(x), of the normal distribution: plain double, so that both ends keep
   their digits. */
static void ms_nn__gelu(const float *x, float *y, size_t n, int slope)
{
    size_t i;
    for (i = 0; i < n; ++i) {
        double v = (double)x[i], half = 0.5 * erfc(-0.70710678118654752 * v);
        if (slope)
            y[i] = (float)((double)y[i] * (half + (fabs(v) < 40 ? 0.39894228040143268 * v * exp(-0.5 * v * v) : 0.0)));
        else y[i] = (float)(v * half);
    }
}

#define MS_NN__JOIN2(a, b) a##b
#define MS_NN__JOIN(a, b) MS_NN__JOIN2(a, b)
#define MS_NN__FN(name) MS_NN__JOIN(MS_NN__JOIN(ms_nn__##name, _), MS_NN__LEVEL)

#define MS_NN__PASS 1
#define MS_NN__LEVEL scalar
#define MS_NN__ISA 1
#include MS_NN_FILENAME

#ifdef MS_NN__ARM
#define MS_NN__LEVEL base
#define MS_NN__ISA 2
#include MS_NN_FILENAME
#endif

#ifdef MS_NN__X86
#define MS_NN__LEVEL avx2
#define MS_NN__ISA 3
#include MS_NN_FILENAME
#endif
#undef MS_NN__PASS

/* There are none for SSE2 alone; AVX-512 was no faster than AVX2 on Zen 4 (tests/bench). */
static const ms_nn__kernels *ms_nn__kernels_for(ms_simd level)
{
#ifdef MS_NN__X86
    if (level >= MS_SIMD_AVX2) return &ms_nn__table_avx2;
#endif
#ifdef MS_NN__ARM
    if (level == MS_SIMD_BASE) return &ms_nn__table_base;
#endif
    (void)level;
    return &ms_nn__table_scalar;
}

#undef MS_NN__BIG_ENDIAN
#undef MS_NN__X86
#undef MS_NN__ARM
#undef MS_NN__UNROLL
#undef MS_NN__INLINE
#undef MS_NN__NOINLINE
#undef MS_NN__COLD
#undef MS_NN__FN
#undef MS_NN__JOIN
#undef MS_NN__JOIN2
#endif /* MS_NN_IMPLEMENTATION */

#if defined(MS_NN_IMPLEMENTATION) && defined(MS_NN__PASS)
/* ---- kernels --------------------------------------------------------------------------------------------------- */

/* The instruction set of every function of a level; plain C beside SIMD is compiled for size: few run it. */
#ifndef MS_NN__X86
#define MS_NN__TARGET
#elif MS_NN__ISA == 1
#define MS_NN__TARGET __attribute__((cold))
#else
#define MS_NN__TARGET __attribute__((target("avx2,fma,f16c")))
#endif
#define MS_NN__KERNEL static MS_NN__TARGET

/* Read once a level. MS_NN__V_FLOATS is a vector of MS_NN__V_LANES floats; V_HALF and V_INT8 load weights as floats.
   MS_NN__V_BLOCK outputs x MS_NN__V_TILE vectors of positions are a convolution's registers. */
#if MS_NN__ISA == 1
#define MS_NN__V_LANES 1
#define MS_NN__V_BLOCK 4
#define MS_NN__V_TILE 2
#define MS_NN__V_FLOATS float
#define MS_NN__V_SET(x) (x)
#define MS_NN__V_MADD(a, b, c) ((a) * (b) + (c))
#define MS_NN__V_IF_GREATER(a, b, x, y) ((a) > (b) ? (x) : (y))
#define MS_NN__V_INT int32_t
#define MS_NN__V_ROUND(a) ((a) < 0 ? (int32_t)((a)-0.5f) : (a) >= 0 ? (int32_t)((a) + 0.5f) : 0)
#define MS_NN__V_FROM_INT(i) ((float)(i))
#define MS_NN__V_POW2(i) ms_nn__float_of((uint32_t)((i) + 127) << 23)
#define MS_NN__V_HALF(p) ms__half_to_float((uint16_t)ms_nn__u16(p))
#define MS_NN__V_INT8(p) ((float)(*(p) < 128 ? *(p) : *(p)-256))
#elif MS_NN__ISA == 2
#define MS_NN__V_LANES 4
#define MS_NN__V_BLOCK 8
#define MS_NN__V_TILE 2
#define MS_NN__V_FLOATS float32x4_t
#define MS_NN__V_SET(x) vdupq_n_f32(x)
#define MS_NN__V_MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_NN__V_IF_GREATER(a, b, x, y) vbslq_f32(vcgtq_f32(a, b), x, y)
#define MS_NN__V_INT int32x4_t
#define MS_NN__V_ROUND(a) vcvtnq_s32_f32(a)
#define MS_NN__V_FROM_INT(i) vcvtq_f32_s32(i)
#define MS_NN__V_POW2(i) vreinterpretq_f32_s32(vshlq_n_s32(vaddq_s32(i, vdupq_n_s32(127)), 23))
#define MS_NN__V_HALF(p) vcvt_f32_f16(vreinterpret_f16_u8(vld1_u8(p)))
#define MS_NN__V_INT8(p) vcvtq_f32_s32(vmovl_s16(vget_low_s16(vmovl_s8(vcreate_s8(ms_nn__u32(p))))))
#else
#define MS_NN__V_LANES 8
#define MS_NN__V_BLOCK 4
#define MS_NN__V_TILE 3
#define MS_NN__V_FLOATS __m256
#define MS_NN__V_SET(x) _mm256_set1_ps(x)
#define MS_NN__V_MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define MS_NN__V_IF_GREATER(a, b, x, y) _mm256_blendv_ps(y, x, _mm256_cmp_ps(a, b, _CMP_GT_OQ))
#define MS_NN__V_INT __m256i
#define MS_NN__V_ROUND(a) _mm256_cvtps_epi32(a)
#define MS_NN__V_FROM_INT(i) _mm256_cvtepi32_ps(i)
#define MS_NN__V_POW2(i) _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_add_epi32(i, _mm256_set1_epi32(127)), 23))
#define MS_NN__V_HALF(p) _mm256_cvtph_ps(_mm_loadu_si128((const __m128i *)(const void *)(p)))
#define MS_NN__V_INT8(p) _mm256_cvtepi32_ps(_mm256_cvtepi8_epi32(_mm_loadl_epi64((const __m128i *)(const void *)(p))))
#endif

/* b if one of them is NaN: constants stand first. */
#define MS_NN__V_MAX(a, b) MS_NN__V_IF_GREATER(a, b, a, b)
#define MS_NN__V_MIN(a, b) MS_NN__V_IF_GREATER(b, a, a, b)

MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(load)(const void *p)
{
    MS_NN__V_FLOATS v;
    memcpy(&v, p, sizeof v);
    return v;
}

MS_NN__INLINE void MS_NN__FN(store)(float *p, MS_NN__V_FLOATS v) { memcpy(p, &v, sizeof v); }

/* MS_NN__V_LANES weights. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(weight)(const unsigned char *p, ms_nn_dtype dtype)
{
    if (dtype == MS_NN_F32) return MS_NN__FN(load)(p);
    if (dtype == MS_NN_F16) return MS_NN__V_HALF(p);
    return MS_NN__V_INT8(p);
}

/* n <= MS_NN__V_LANES weights, zeros after them; nothing after them is read. */
MS_NN__KERNEL MS_NN__NOINLINE MS_NN__V_FLOATS MS_NN__FN(weight_part)(const unsigned char *p, ms_nn_dtype dtype,
                                                                     size_t n)
{
    unsigned char copy[4 * MS_NN__V_LANES];
    memset(copy, 0, sizeof copy);
    memcpy(copy, p, n * ms_nn__bytes_of(dtype));
    return MS_NN__FN(weight)(copy, dtype);
}

/* Dot products of rows with all samples, one after the other: a row that was read stays in the first cache. Two sums
   take turns by vectors. */
MS_NN__KERNEL void MS_NN__FN(dense)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    const ms_nn__matrix *m = job->m;
    const ms_nn_dtype dtype = m->dtype;
    const size_t cols = m->cols, size = ms_nn__bytes_of(dtype), pair = 2 * MS_NN__V_LANES;
    size_t row, b, k, n;
    int i;
    for (row = row0; row < row1; ++row)
        for (b = 0; b < (size_t)job->batch; ++b) {
            const unsigned char *w = m->w + row * cols * size;
            const float *x = job->x + b * cols;
            MS_NN__V_FLOATS sum[2];
            float lane[MS_NN__V_LANES], y = 0;
            sum[0] = sum[1] = MS_NN__V_SET(0.0f);
            for (k = 0; k + pair <= cols; k += pair, w += pair * size, x += pair) {
                sum[0] = MS_NN__V_MADD(MS_NN__FN(weight)(w, dtype), MS_NN__FN(load)(x), sum[0]);
                sum[1] = MS_NN__V_MADD(MS_NN__FN(weight)(w + MS_NN__V_LANES * size, dtype),
                                       MS_NN__FN(load)(x + MS_NN__V_LANES), sum[1]);
            }
            for (; k < cols; k += n, w += n * size, x += n) {
                n = ms_nn__min(cols - k, MS_NN__V_LANES);
                sum[0] = MS_NN__V_MADD(MS_NN__FN(weight_part)(w, dtype, n),
                                       MS_NN__FN(weight_part)((const unsigned char *)x, MS_NN_F32, n), sum[0]);
            }
            MS_NN__FN(store)(lane, sum[0] + sum[1]);
            for (i = 0; i < MS_NN__V_LANES; ++i) y += lane[i];
            y *= m->scale ? ms_nn__float_at(m->scale, row) : 1.0f;
            job->y[b * m->rows + row] = y + (m->bias && !job->linear ? ms_nn__float_at(m->bias, row) : 0.0f);
        }
}

/* n weights times a factor, in double. */
MS_NN__KERNEL void MS_NN__FN(widen)(const unsigned char *p, size_t n, double factor, double *out, ms_nn_dtype dtype)
{
    const size_t size = ms_nn__bytes_of(dtype);
    float lane[MS_NN__V_LANES];
    size_t k, count, i;
    for (k = 0; k < n; k += count) {
        count = ms_nn__min(n - k, MS_NN__V_LANES);
        if (count == MS_NN__V_LANES) MS_NN__FN(store)(lane, MS_NN__FN(weight)(p + k * size, dtype));
        else MS_NN__FN(store)(lane, MS_NN__FN(weight_part)(p + k * size, dtype, count));
        for (i = 0; i < count; ++i) out[k + i] = factor * (double)lane[i];
    }
}

/* Packed weights: a panel has 4 vectors of rows. An output is the sum over the columns from the left, whatever the
   batch. */
#define MS_NN__P_ROWS (4 * MS_NN__V_LANES)

/* Outputs of one sample from their sums. */
MS_NN__KERNEL MS_NN__NOINLINE void MS_NN__FN(packed_end)(const ms_nn__dense *job, size_t row, size_t sample,
                                                         const MS_NN__V_FLOATS *sum, int vectors)
{
    const ms_nn__matrix *m = job->m;
    float *y = job->y + sample * m->rows, part[MS_NN__V_LANES];
    for (; vectors > 0 && row < m->rows; --vectors, row += MS_NN__V_LANES) {
        const MS_NN__V_FLOATS bias = job->linear ? MS_NN__V_SET(0.0f) : MS_NN__FN(load)(m->packed_bias + row);
        const MS_NN__V_FLOATS out = MS_NN__V_MADD(*sum++, MS_NN__FN(load)(m->packed_scale + row), bias);
        if (row + MS_NN__V_LANES <= m->rows) {
            MS_NN__FN(store)(y + row, out);
        } else {
            MS_NN__FN(store)(part, out);
            memcpy(y + row, part, (m->rows - row) * sizeof(float));
        }
    }
}

/* Panels times samples: one times 1 to 3, or two times 1, for more sums that do not wait for each other. dtype, panels
   and batch are constants. */
MS_NN__INLINE void MS_NN__FN(packed_tile)(const ms_nn__dense *job, size_t row, size_t sample, ms_nn_dtype dtype,
                                          int panels, int batch)
{
    const size_t cols = job->m->cols, size = ms_nn__bytes_of(dtype), vector = MS_NN__V_LANES * size;
    const unsigned char *w = job->m->packed + row * cols * size;
    const float *x = job->x + sample * cols;
    MS_NN__V_FLOATS sum[8][3], total[8], value[3], u;
    size_t k;
    int v, b;
    MS_NN__UNROLL
    for (v = 0; v < 4 * panels; ++v) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) sum[v][b] = MS_NN__V_SET(0.0f);
    }
    for (k = 0; k < cols; ++k, w += 4 * vector) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) value[b] = MS_NN__V_SET(x[(size_t)b * cols + k]);
        MS_NN__UNROLL
        for (v = 0; v < 4 * panels; ++v) {
            const unsigned char *p = w + (size_t)(v % 4) * vector + (size_t)(v / 4) * cols * 4 * vector;
            u = MS_NN__FN(weight)(p, dtype);
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) sum[v][b] = MS_NN__V_MADD(u, value[b], sum[v][b]);
        }
    }
    MS_NN__UNROLL
    for (b = 0; b < batch; ++b) {
        MS_NN__UNROLL
        for (v = 0; v < 4 * panels; ++v) total[v] = sum[v][b];
        MS_NN__FN(packed_end)(job, row, sample + (size_t)b, total, 4 * panels);
    }
}

/* All samples for the panels from row0 on. dtype is a constant. */
MS_NN__INLINE void MS_NN__FN(packed_of)(const ms_nn__dense *job, size_t row0, size_t row1, ms_nn_dtype dtype)
{
    const size_t batch = (size_t)job->batch;
    size_t row, b;
    for (row = row0; row < row1; row += MS_NN__P_ROWS) {
        if (batch == 1 && row + MS_NN__P_ROWS < row1) {
            MS_NN__FN(packed_tile)(job, row, 0, dtype, 2, 1);
            row += MS_NN__P_ROWS;
            continue;
        }
        for (b = 0; b + 3 <= batch; b += 3) MS_NN__FN(packed_tile)(job, row, b, dtype, 1, 3);
        if (b + 2 == batch) MS_NN__FN(packed_tile)(job, row, b, dtype, 1, 2);
        else if (b + 1 == batch) MS_NN__FN(packed_tile)(job, row, b, dtype, 1, 1);
    }
}

MS_NN__KERNEL void MS_NN__FN(packed)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    if (job->m->packed_dtype == MS_NN_F32) MS_NN__FN(packed_of)(job, row0, row1, MS_NN_F32);
    else MS_NN__FN(packed_of)(job, row0, row1, MS_NN_F16);
}

/* MS_NN__V_BLOCK outputs x tile vectors of positions of one row: y(o, x) = bias(o) + sum_c sum_t w(o, c, t) in(c, x +
   t). */
MS_NN__INLINE void MS_NN__FN(conv_tile_of)(const ms_nn__conv *v, const float *in, const float *w, const float *bias,
                                           float *out, size_t out_plane, size_t outs, int tile)
{
    size_t c, t;
    MS_NN__V_FLOATS sum[MS_NN__V_BLOCK][MS_NN__V_TILE];
    int i, j;
    MS_NN__UNROLL
    for (i = 0; i < MS_NN__V_BLOCK; ++i) {
        MS_NN__UNROLL
        for (j = 0; j < tile; ++j) sum[i][j] = MS_NN__V_SET(bias[i]);
    }
    for (c = 0; c < v->in.c; ++c, in += v->plane) {
        for (t = 0; t < v->taps; ++t, w += MS_NN__V_BLOCK) {
            const float *p = in + v->offset[t];
            MS_NN__V_FLOATS x[MS_NN__V_TILE];
            MS_NN__UNROLL
            for (j = 0; j < tile; ++j) x[j] = MS_NN__FN(load)(p + j * MS_NN__V_LANES);
            MS_NN__UNROLL
            for (i = 0; i < MS_NN__V_BLOCK; ++i) {
                MS_NN__V_FLOATS u = MS_NN__V_SET(w[i]);
                MS_NN__UNROLL
                for (j = 0; j < tile; ++j) sum[i][j] = MS_NN__V_MADD(u, x[j], sum[i][j]);
            }
        }
    }
    MS_NN__UNROLL
    for (i = 0; i < MS_NN__V_BLOCK; ++i) {
        if ((size_t)i < outs) {
            MS_NN__UNROLL
            for (j = 0; j < tile; ++j) MS_NN__FN(store)(out + (size_t)i * out_plane + j * MS_NN__V_LANES, sum[i][j]);
        }
    }
}

MS_NN__KERNEL MS_NN__NOINLINE void MS_NN__FN(conv_tile)(const ms_nn__conv *v, const float *in, const float *w,
                                                        const float *bias, float *out, size_t out_plane, size_t outs,
                                                        size_t tile)
{
    if (tile == MS_NN__V_TILE) MS_NN__FN(conv_tile_of)(v, in, w, bias, out, out_plane, outs, MS_NN__V_TILE);
    else MS_NN__FN(conv_tile_of)(v, in, w, bias, out, out_plane, outs, 1);
}

/* One row of a block. A tile that stands over the row's end goes through a buffer. */
MS_NN__KERNEL void MS_NN__FN(conv_row)(const ms_nn__conv_job *job, const float *in, size_t row, size_t block)
{
    enum { WIDE = MS_NN__V_TILE * MS_NN__V_LANES };
    const ms_nn__conv *v = job->conv;
    const size_t o = block * MS_NN__V_BLOCK, outs = ms_nn__min(MS_NN__V_BLOCK, v->out.c - o),
                 plane = v->out.h * v->out.w;
    const float *w = v->packed + o * v->in.c * v->taps;
    float bias[MS_NN__V_BLOCK], buffer[MS_NN__V_BLOCK * WIDE], *out = job->y + o * plane + row * v->out.w;
    size_t x, width, i;
    for (i = 0; i < MS_NN__V_BLOCK; ++i) bias[i] = job->linear ? 0.0f : v->bias[o + i];
    for (x = 0; x < v->out.w; x += width) {
        const size_t left = v->out.w - x, tile = left > (MS_NN__V_TILE - 1) * MS_NN__V_LANES ? MS_NN__V_TILE : 1;
        width = ms_nn__min(left, tile * MS_NN__V_LANES);
        if (width == tile * MS_NN__V_LANES) {
            MS_NN__FN(conv_tile)(v, in + x, w, bias, out + x, plane, outs, tile);
            continue;
        }
        MS_NN__FN(conv_tile)(v, in + x, w, bias, buffer, WIDE, outs, tile);
        for (i = 0; i < outs; ++i) memcpy(out + i * plane + x, buffer + i * WIDE, width * sizeof(float));
    }
}

MS_NN__KERNEL void MS_NN__FN(conv)(const ms_nn__conv_job *job, size_t row0, size_t row1)
{
    const ms_nn__conv *v = job->conv;
    size_t row, block;
    for (row = row0; row < row1; ++row)
        for (block = 0; block * MS_NN__V_BLOCK < v->out.c; ++block)
            MS_NN__FN(conv_row)(job, job->padded + row * v->stride[0] * v->pitch, row, block);
}

/* e^x - c, c = 0 or 1, for x <= 88, subnormal results included: x = n ln 2 + r, 2^n (e^r - 1) + (2^n - c), 2^n in two
   factors; e^r - 1 = r + r^2 q(r) with the Taylor coefficients 1/2 to 1/5040, |r| <= 0.347: relative error below 2
   ulp. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(exp_minus)(MS_NN__V_FLOATS x, MS_NN__V_FLOATS c)
{
    MS_NN__V_FLOATS r, q, s, t, half;
    MS_NN__V_INT n;
    x = MS_NN__V_MAX(MS_NN__V_SET(-104.0f), MS_NN__V_MIN(MS_NN__V_SET(88.0f), x));
    n = MS_NN__V_ROUND(x * MS_NN__V_SET(1.44269504f));
    t = MS_NN__V_FROM_INT(n);
    r = MS_NN__V_MADD(t, MS_NN__V_SET(-0.693145752f),
                      x); /* ln 2 in two pieces: the first has 15 bits, t times it is exact */
    r = MS_NN__V_MADD(t, MS_NN__V_SET(-1.42860677e-6f), r);
    q = MS_NN__V_SET(1.0f / 5040);
    q = MS_NN__V_MADD(q, r, MS_NN__V_SET(1.0f / 720));
    q = MS_NN__V_MADD(q, r, MS_NN__V_SET(1.0f / 120));
    q = MS_NN__V_MADD(q, r, MS_NN__V_SET(1.0f / 24));
    q = MS_NN__V_MADD(q, r, MS_NN__V_SET(1.0f / 6));
    q = MS_NN__V_MADD(q, r, MS_NN__V_SET(0.5f));
    q = MS_NN__V_MADD(r * r, q, r);
    n = MS_NN__V_ROUND(t * MS_NN__V_SET(0.5f));
    s = MS_NN__V_POW2(n);
    n = MS_NN__V_ROUND(t - MS_NN__V_FROM_INT(n));
    half = MS_NN__V_POW2(n);
    return MS_NN__V_MADD(s * q, half, s * half - c);
}

/* ln(1 + e) for e in [0, 1]: 2 artanh(z), z = e / (2 + e) <= 1/3; the series to z^15 leaves 1e-9. 2 z first: e may be
   subnormal. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(log1p)(MS_NN__V_FLOATS e)
{
    MS_NN__V_FLOATS two = (e + e) / (e + MS_NN__V_SET(2.0f)), s = two * (MS_NN__V_SET(0.25f) * two);
    MS_NN__V_FLOATS q = MS_NN__V_SET(1.0f / 15);
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 13));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 11));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 9));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 7));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(0.2f));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 3));
    return two * MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f));
}

/* y = f(x), or with slope y *= f'(x), for n floats, whole vectors. All but relu and leaky_relu share e = e^-|x|, or
   what stands for it. The activation is loop-invariant, so its branch is predicted. Slopes are functions of x: those of
   y lose their digits where f is flat. */
MS_NN__KERNEL MS_NN__NOINLINE void MS_NN__FN(curve)(const float *x, float *y, size_t n, ms_nn__activation activation,
                                                    float alpha, int slope)
{
    MS_NN__V_FLOATS zero = MS_NN__V_SET(0.0f), one = MS_NN__V_SET(1.0f), a = MS_NN__V_SET(alpha), v, e, f, up;
    MS_NN__V_FLOATS c = MS_NN__V_SET(!slope && (activation == MS_NN__ELU || activation == MS_NN__TANH) ? 1.0f : 0.0f);
    size_t i;
    for (i = 0; i < n; i += MS_NN__V_LANES) {
        v = MS_NN__FN(load)(x + i);
        if (activation == MS_NN__RELU) {
            f = slope ? MS_NN__V_IF_GREATER(v, zero, one, zero) : MS_NN__V_MAX(zero, v);
        } else if (activation == MS_NN__LEAKY) {
            up = MS_NN__V_MIN(zero, v) * a;
            f = MS_NN__V_IF_GREATER(v, zero, slope ? one : v, slope ? a : up);
        } else {
            e = MS_NN__V_MAX(zero - v, v); /* |x| */
            if (activation == MS_NN__ELU) e = MS_NN__V_MIN(zero, v);
            else if (activation == MS_NN__TANH) e = MS_NN__V_SET(-2.0f) * MS_NN__V_MIN(MS_NN__V_SET(64.0f), e);
            else e = zero - e;
            e = MS_NN__FN(exp_minus)(e, c);
            if (activation == MS_NN__ELU) {
                up = a * e;
                f = MS_NN__V_IF_GREATER(v, zero, slope ? one : v, up);
            } else if (activation == MS_NN__TANH && !slope) { /* e = e^-2|x| - 1: -e / (2 + e) */
                f = (zero - e) / (e + MS_NN__V_SET(2.0f));
                up = zero - f;
                f = MS_NN__V_IF_GREATER(zero, v, up, f);
            } else {
                f = one / (one + e);
                up = f * MS_NN__V_IF_GREATER(zero, v, e, one); /* sigmoid(x) */
                if (activation == MS_NN__SILU && slope)
                    f = MS_NN__V_MADD(up * v, f * MS_NN__V_IF_GREATER(zero, v, one, e), up);
                else if (activation == MS_NN__SILU) f = v * up;
                else if (activation == MS_NN__TANH) f = MS_NN__V_SET(4.0f) * (f * f * e);
                else if (activation == MS_NN__SIGMOID && slope) f = f * f * e;
                else if (activation == MS_NN__SOFTPLUS && !slope) f = MS_NN__V_MAX(zero, v) + MS_NN__FN(log1p)(e);
                else f = up;
            }
        }
        if (slope) f = f * MS_NN__FN(load)(y + i);
        MS_NN__FN(store)(y + i, f);
    }
}

/* The same for any n; relu's and leaky_relu's slopes may take f(x) for x. */
MS_NN__KERNEL void MS_NN__FN(activate)(const float *x, float *y, size_t n, ms_nn__activation activation, float alpha,
                                       int slope)
{
    const size_t whole = n - n % MS_NN__V_LANES;
    float last[2][MS_NN__V_LANES];
    if (activation == MS_NN__LINEAR) return;
    if (activation == MS_NN__GELU) {
        ms_nn__gelu(x, y, n, slope);
        return;
    }
    MS_NN__FN(curve)(x, y, whole, activation, alpha, slope);
    if (whole == n) return;
    memset(last, 0, sizeof last);
    memcpy(last[0], x + whole, (n - whole) * sizeof(float));
    memcpy(last[1], y + whole, (n - whole) * sizeof(float));
    MS_NN__FN(curve)(last[0], last[1], MS_NN__V_LANES, activation, alpha, slope);
    memcpy(y + whole, last[1], (n - whole) * sizeof(float));
}

/* At most four: as fast as eight on Zen 4, and columns are filled up to two vectors. */
#if MS_NN__ISA == 1
#define MS_NN__D_LANES 1
typedef double MS_NN__FN(doubles);
#else
#define MS_NN__D_LANES (MS_NN__ISA == 2 ? 2 : 4)
typedef double MS_NN__FN(doubles) __attribute__((vector_size(8 * MS_NN__D_LANES)));
#endif

MS_NN__INLINE MS_NN__FN(doubles) MS_NN__FN(load_doubles)(const double *p)
{
    MS_NN__FN(doubles) v;
    memcpy(&v, p, sizeof v);
    return v;
}

/* Four rows times two vectors of columns at a time. */
MS_NN__KERNEL void MS_NN__FN(product)(const ms_nn__product_job *job)
{
    MS_NN__FN(doubles) sum[4][2], v[2];
    size_t row, col, r;
    int i, k;
    for (row = 0; row < job->rows; row += 4)
        for (col = 0; col < job->cols; col += 2 * MS_NN__D_LANES) {
            const double *a = job->a + row * job->a_row, *b = job->b + col;
            double *out = job->out + row * job->out_row + col;
            MS_NN__UNROLL
            for (i = 0; i < 4; ++i) {
                MS_NN__UNROLL
                for (k = 0; k < 2; ++k)
                    sum[i][k] = MS_NN__FN(load_doubles)(out + (size_t)i * job->out_row + k * MS_NN__D_LANES);
            }
            for (r = 0; r < job->count; ++r, a += job->a_column, b += job->b_row) {
                MS_NN__UNROLL
                for (k = 0; k < 2; ++k) v[k] = MS_NN__FN(load_doubles)(b + k * MS_NN__D_LANES);
                MS_NN__UNROLL
                for (i = 0; i < 4; ++i) {
                    MS_NN__UNROLL
                    for (k = 0; k < 2; ++k) sum[i][k] += v[k] * a[(size_t)i * job->a_row];
                }
            }
            MS_NN__UNROLL
            for (i = 0; i < 4; ++i) {
                MS_NN__UNROLL
                for (k = 0; k < 2; ++k)
                    memcpy(out + (size_t)i * job->out_row + k * MS_NN__D_LANES, &sum[i][k], sizeof sum[i][k]);
            }
        }
}

static const ms_nn__kernels MS_NN__FN(table) = {MS_NN__V_BLOCK,      MS_NN__P_ROWS,    (ms_simd)MS_NN__ISA,
                                                MS_NN__FN(packed),   MS_NN__FN(dense), MS_NN__FN(conv),
                                                MS_NN__FN(activate), MS_NN__FN(widen), MS_NN__FN(product)};

#undef MS_NN__TARGET
#undef MS_NN__KERNEL
#undef MS_NN__LEVEL
#undef MS_NN__ISA
#undef MS_NN__V_LANES
#undef MS_NN__V_BLOCK
#undef MS_NN__V_TILE
#undef MS_NN__P_ROWS
#undef MS_NN__V_FLOATS
#undef MS_NN__V_SET
#undef MS_NN__V_MADD
#undef MS_NN__V_MAX
#undef MS_NN__V_MIN
#undef MS_NN__V_IF_GREATER
#undef MS_NN__V_INT
#undef MS_NN__V_ROUND
#undef MS_NN__V_FROM_INT
#undef MS_NN__V_POW2
#undef MS_NN__V_HALF
#undef MS_NN__V_INT8
#undef MS_NN__D_LANES
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
