/* ms_nn.h - v0.1.0 - small networks from safetensors - MIT or public domain, see the end

   Use it
   ------
   In one C or C++ file; elsewhere only the second line:

      #define MS_NN_IMPLEMENTATION
      #include "ms_nn.h"

   Runs small trained networks - a neural renderer (parameters to picture), inversion networks (picture to parameters) -
   from safetensors files at the speed at which memory delivers the weights: forward, vector-Jacobian product,
   Jacobian-vector product, Jacobian; and as GLSL, HLSL or WGSL, where they are dense. Reads and writes safetensors
   strictly. Never trains. Link with -lm. Here a network of one layer, which the program writes first:

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
          float x[3] = {0.1f, -0.2f, 0.1f}, y[2], g_y[2] = {1, 0}, g_x[3];
          ms_nn *nn;
          ms_error error;
          if (ms_nn_file_save("example.safetensors", tensors, 2, metadata, 3, NULL, &error) != MS_OK ||
              ms_nn_load_file("example.safetensors", NULL, &nn, &error) != MS_OK) {
              printf("byte %lu: %s\n", (unsigned long)error.position, error.message);
              return 1;
          }
          if (ms_nn_forward(nn, 1, x, y, NULL) != MS_OK || ms_nn_vjp(nn, 1, x, g_y, NULL, g_x, NULL) != MS_OK) return 1;
          printf("outputs %g %g, slopes of the first %g %g %g\n", (double)y[0], (double)y[1], (double)g_x[0],
              (double)g_x[1], (double)g_x[2]);
          ms_nn_destroy(nn);
          return remove("example.safetensors");
      }
   End of example.

   The file
   --------
   safetensors: a length of 8 bytes, a JSON header, the data. A network is a file whose __metadata__ has

      "format"         "pt": weights as PyTorch lays them out (may be absent)
      "ms_nn_version"  "1"
      "ms_nn_input"    JSON list: [n], [channels, length] or [channels, height, width] of one sample
      "ms_nn_layers"   JSON list of layers, in a string; each runs on the output of the one before

   Data lies row-major, channels first. A layer is an object with "type" and, as the type allows, the fields below; any
   other field is refused. Sizes that are left out are read from the tensors. Sizes marked * are a number or a pair
   [height, width].

      dense            name, units, activation, alpha, bias        <name>.weight [units][inputs]; the input must be flat
      conv1d           name, filters, kernel, stride, padding,     <name>.weight [filters][channels / groups][kernel]
                       zeros (0: on both sides), dilation (1),
                       groups (1), activation, alpha, bias
      conv2d           the same, with * where there are numbers    <name>.weight [filters][channels /
                       groups][height][width]
      conv1d_transpose the same without padding, and extra (0)     <name>.weight [channels][filters / groups][kernel]
      conv2d_transpose the same, with *                            <name>.weight [channels][filters /
                                                                   groups][height][width]
      upsample1d       factor (2), mode (nearest or linear),       align_corners as PyTorch has it
                       align_corners (false)
      upsample2d       the same, factor*
      maxpool1d        size (2), stride (size)                     what does not fill a window is dropped
      maxpool2d        size* (2), stride* (size)
      avgpool1d, avgpool2d: as maxpool1d, maxpool2d                means
      globalpool                                                   the mean of each channel
      flatten          order: channels_first (default, PyTorch) or channels_last (Keras)
      activation       activation, alpha                           alone
      dropout          rate                                        does nothing
      add              from, activation, alpha                     adds the output of the layer with that name, or
                       "input"
      concat           from, order: after (default) or before      puts that output's channels behind, or before
      shared_channels  inputs: [[0,3,6],[1,4,6],[2,5,6]]           first layer only, see below

   <name>.bias [outputs] belongs to every dense and convolution layer unless "bias":false stands in the list. Weights
   are F64, F32, F16, BF16, or I8 with <name>.weight_scale (F32, [outputs]; of a transposed convolution [channels], its
   weights' first dimension): weight = scale x integer. Convolutions are correlations. "padding": "valid" (default) or
   "same": (kernel - 1) / 2 zeros in front, rounded down, and as many behind as make ceil(size / stride) outputs.
   "extra" is PyTorch's output_padding. "activation": linear (default), relu,
   leaky_relu (slope alpha, 0.01), elu (alpha, 1), tanh, sigmoid, softplus, silu, gelu (by erf). shared_channels
   evaluates the rest of the list once for each of its lists of input indices and puts the outputs one after the other:
   one small network for the red, green and blue of a scene without colours of its own. examples/tools/export_torch.py
   saves PyTorch and Keras networks in this form.

   What it costs
   -------------
   A dense layer costs what reading its weights costs: a picture of the full-size renderer (2.1 GB of F32) runs within
   some percent of the speed of memory, BF16 and F16 in about half the time, I8 in a third to two fifths, at about 68,
   86 and 65 dB against F32. Large pages under the weights (on Linux madvise(MADV_HUGEPAGE) on the memory that
   ms_nn_load is given) save a sixth to a third of it. README.md and tests/bench/RESULTS.md have the tables, with
   PyTorch, OpenBLAS and oneDNN beside; `make bench FILTER=nn` makes them.

   Memory, threads, SIMD, determinism, errors
   ------------------------------------------
   A file costs one small allocation; a network some dozens at load: packed copies of the convolutions' weights and of
   dense layers of up to two million weights and 16384 inputs, the first eight million of a network; float copies of F64
   and of folded dense weights. Larger layers are read where they lie. The products allocate nothing when they are given
   a workspace of ms_nn_workspace_size bytes, which stops growing at 48 samples or directions at most: more run in
   blocks. Stack: below 32 kB, 64 kB when compiled without optimisation.
   No globals. A network is only read once it is loaded: calls on it may overlap if their workspaces differ.
   options.parallel takes a thread pool; the work is cut by the problem alone.
   SSE2, AVX2, AVX-512 (with VNNI where there is) and NEON, chosen at load, capped by options.simd. MS_NO_SIMD: plain C.
   At one level the same bits for any number of threads, and for a sample alone or in a batch. Dense layers of I8
   that are not packed are summed in integers and equal at every level; all else agrees within the error below.
   Arithmetic is in floats: about 1e-6 of the largest output against double precision for the networks above, at most
   1e-5 in the tests. Those I8 layers take their input in 21-bit fixed point: 5e-7 of its largest element. The collapse
   is in double. Every call that can fail returns a status; loaders also fill an ms_error with a byte offset and a
   sentence. On failure outputs are untouched. Weights and inputs that are NaN or infinite run through
   (ms_nn_check_weights finds them). -ffast-math voids what is said of bits, NaN and infinity; the rest holds to
   rounding.

   Configuration (define before the implementation)
   ------------------------------------------------
   MS_NN_NO_STDIO    no <stdio.h>, no files by name
   MS_NN_NO_COLLAPSE no collapse and no low rank: what matching needs, a fifth of the code
   MS_NO_SIMD        plain C only
   MS_DEF            linkage of the functions, e.g. static, __declspec(dllexport) (nothing)
   MS_NN_FILENAME    "ms_nn.h"; set it if the file is renamed (it includes itself once a SIMD level)
   MS_ASSERT(x)      nothing; checks of the library's own invariants

   Limits
   ------
   Refused with MS_BAD_DATA: whatever the strict format forbids (duplicate names, holes, overlaps, trailing bytes unless
   options.allow_trailing, NUL in names, null metadata, header over 100,000,000 bytes, rank over 32) and layers that do
   not fit their tensors; 4096 layers at most. MS_UNSUPPORTED: other element types than the five as weights. Files of
   2^31 bytes and more need a 64-bit machine. A mapped file must not shrink while it is used: options.copy reads it
   instead. Networks are chains with skips that are added or concatenated: no recurrence, attention, or normalisation at
   run time (BatchNorm goes into the weights).

   Sources
   -------
   safetensors: its format description and reference implementation. Networks: Zsolnai-Feher, PhD thesis, sections 3.4.2
   and 4.3.1. Convolutions: Winograd's F(2, 3), Lavin & Gray 2016. Collapse: Golub & Van Loan, Matrix Computations,
   chapter 5; Schreiber & Van Loan 1989; Bjoerck 1987; Chambers 1971. Low rank: Hestenes 1958.
*/
#ifndef MS_NN_H
#define MS_NN_H
#include <stddef.h>
#include <stdint.h>

#define MS_NN_VERSION_MAJOR 0
#define MS_NN_VERSION_MINOR 1
#define MS_NN_VERSION_PATCH 0
#define MS_NN_VERSION 100 /* major * 10000 + minor * 100 + patch */
#define MS_NN_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ms-common begin (the same text in every ms_*.h: see tests/common.sh) */
#ifndef MS_COMMON
#define MS_COMMON 3 /* raised whenever the text between the marks changes after a release */

/* Linkage of every public function of every header: nothing, static, __declspec(dllexport), or
   __attribute__((visibility("default"))). Define it before the #include. */
#ifndef MS_DEF
#define MS_DEF
#endif
#if defined(__GNUC__) || defined(__clang__)
#define MS_API MS_DEF __attribute__((unused)) /* static copies that call only a part do not warn */
#else
#define MS_API MS_DEF
#endif

/* NULL, in every header: where an argument's comment does not say what NULL means, it may not be NULL. A call that
   returns a status then answers MS_INVALID_ARGUMENT and names the argument; any other does nothing and returns 0 or
   NULL. destroy and free do nothing with NULL. */

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

/* Outside the guard: catches two vendored releases in one file. */
#if MS_COMMON != 3
#error "ms_*.h headers of different releases in one translation unit"
#endif
/* ms-common end */

/* ---- safetensors: what is in a file ---------------------------------------------------------------------------- */

/* Every element type of the format: code, name in the file, bits. Networks use F64, F32, F16, BF16 and I8; the
   others are listed, checked and copied. */
#define MS_NN_DTYPE_LIST(X)                                                                              \
    X(MS_NN_F64, "F64", 64)                                                                              \
    X(MS_NN_F32, "F32", 32)                                                                              \
    X(MS_NN_F16, "F16", 16)                                                                              \
    X(MS_NN_BF16, "BF16", 16)                                                                            \
    X(MS_NN_I8, "I8", 8)                                                                                 \
    X(MS_NN_I16, "I16", 16) X(MS_NN_I32, "I32", 32) X(MS_NN_I64, "I64", 64) X(MS_NN_U8, "U8", 8)         \
        X(MS_NN_U16, "U16", 16) X(MS_NN_U32, "U32", 32) X(MS_NN_U64, "U64", 64) X(MS_NN_BOOL, "BOOL", 8) \
            X(MS_NN_C64, "C64", 64) X(MS_NN_F8_E5M2, "F8_E5M2", 8) X(MS_NN_F8_E4M3, "F8_E4M3", 8)        \
                X(MS_NN_F8_E8M0, "F8_E8M0", 8) X(MS_NN_F8_E4M3FNUZ, "F8_E4M3FNUZ", 8)                    \
                    X(MS_NN_F8_E5M2FNUZ, "F8_E5M2FNUZ", 8) X(MS_NN_F6_E2M3, "F6_E2M3", 6)                \
                        X(MS_NN_F6_E3M2, "F6_E3M2", 6) X(MS_NN_F4, "F4", 4)

typedef enum ms_nn_dtype {
#define MS_NN_DTYPE_ENUM(code, name, bits) code,
    MS_NN_DTYPE_LIST(MS_NN_DTYPE_ENUM)
#undef MS_NN_DTYPE_ENUM
        MS_NN_DTYPE_COUNT
} ms_nn_dtype;

#define MS_NN_MAX_HEADER 100000000 /* bytes of JSON that a file may have; the format's own limit */
#define MS_NN_MAX_RANK 32
#define MS_NN_MAX_LAYERS 4096

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
    int allow_trailing;      /* non-zero: bytes behind the last tensor are ignored; 0: refused */
    int no_folds;            /* non-zero: the layers run as they are written */
    ms_simd simd;            /* the fastest level to use; MS_SIMD_AUTO (0): what the processor has */
    size_t max_header_bytes; /* 0: MS_NN_MAX_HEADER; a longer header is refused */
    size_t max_memory_bytes; /* largest single allocation; 0: no cap. Over it: MS_OUT_OF_MEMORY */
    ms_parallel parallel;    /* runs the layers' tasks; zero: the calling thread */
    ms_allocator allocator;  /* zero: malloc and free */
    int copy; /* non-zero: files by name are read into memory, not mapped: they may then change while in use */
} ms_nn_options;

/* All defaults. */
MS_API ms_nn_options ms_nn_defaults(void);

/* "F32" and so on; "unknown" outside the list. */
MS_API const char *ms_nn_dtype_string(ms_nn_dtype dtype);

typedef struct ms_nn_file ms_nn_file;

/* Checks a whole safetensors file and lists it. Nothing is copied but the names.
   bytes     [size] the file, e.g. mapped; must outlive *file; any alignment
   options   NULL: defaults
   *file     out; ms_nn_file_close releases it; untouched on failure
   error     NULL or filled on failure: position is the byte in the file, message the reason
   One allocation, of at most 5 times the header that is really there. No recursion.
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

/* By name, in O(log count); NULL if there is none. */
MS_API const ms_nn_tensor *ms_nn_file_find(const ms_nn_file *file, const char *name);
MS_API const char *ms_nn_file_metadata(const ms_nn_file *file, const char *key);

/* Receives a file front to back; returns 0, or anything else to stop with MS_IO. */
typedef struct ms_nn_sink {
    void *user;
    int (*write)(void *user, const void *bytes, size_t size);
} ms_nn_sink;

/* Writes a safetensors file: the header padded with spaces so that the data starts at a multiple of 64, the largest
   tensor first, equal sizes in the order given. The reference implementation reads it.
   tensors   [count]; data of bytes = product of shape x element size, little-endian; names unique
   metadata  [entries]; keys unique; NULL with entries 0
   MS_INVALID_ARGUMENT: a name twice, "__metadata__" as a name, text that is not UTF-8, a wrong size. MS_IO: the sink
   stopped. MS_OUT_OF_MEMORY. position: index of the tensor or entry. Nothing is written unless all is valid. */
MS_API ms_status ms_nn_file_write(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                  size_t entries, const ms_allocator *allocator, ms_nn_sink sink, ms_error *error);

/* ---- networks -------------------------------------------------------------------------------------------------- */

typedef struct ms_nn ms_nn;

/* channels; channels, length; or channels, height, width: row-major, the last index runs fastest. */
typedef struct ms_nn_shape {
    int rank;       /* 1 to 3 */
    size_t size[3]; /* [rank] */
} ms_nn_shape;

/* A layer as the file lists it. Strings live as long as the network. */
typedef struct ms_nn_layer {
    const char *type, *name, *activation; /* "" where there is none */
    ms_nn_dtype dtype;                    /* of the weights; MS_NN_DTYPE_COUNT: the layer has none */
    ms_nn_shape output;                   /* of one sample */
    size_t parameters, bytes;             /* weights, biases and scales */
    size_t multiply_adds;                 /* of one sample as written, before folds */
    int folded;                           /* non-zero: an upsampling before it went into its weights */
} ms_nn_layer;

/* Makes a network of a safetensors file with a layer list (grammar in the head comment).
   bytes    [size] must outlive *nn, unchanged: F32, F16, BF16 and I8 weights of dense layers are used where they lie
            (on little-endian hosts), of smaller ones a packed copy too; F64 and all weights of convolutions are copied
            as floats
   *nn      out; ms_nn_destroy releases it; untouched on failure
   error    NULL or filled on failure; position: byte in the file, or 0
   Folds (options->no_folds): upsample1d before conv1d and upsample1d/2d before flatten + dense of F32 or F64.
   MS_BAD_DATA: file or layer list malformed, shapes that do not fit. MS_UNSUPPORTED: an element type or version that
   this release does not run. MS_OUT_OF_MEMORY. */
MS_API ms_status ms_nn_load(const void *bytes, size_t size, const ms_nn_options *options, ms_nn **nn, ms_error *error);
MS_API void ms_nn_destroy(ms_nn *nn); /* NULL is allowed */

#ifndef MS_NN_NO_STDIO
/* ms_nn_file_open and ms_nn_load for a file by name: mapped on POSIX systems, where a file that shrinks while it is
   used ends the program (options.copy), read into one allocation elsewhere. MS_IO: cannot be read. */
MS_API ms_status ms_nn_file_read(const char *path, const ms_nn_options *options, ms_nn_file **file, ms_error *error);
MS_API ms_status ms_nn_load_file(const char *path, const ms_nn_options *options, ms_nn **nn, ms_error *error);

/* ms_nn_file_write into a file by name, replaced if it is there. */
MS_API ms_status ms_nn_file_save(const char *path, const ms_nn_tensor *tensors, size_t count,
                                 const ms_nn_entry *metadata, size_t entries, const ms_allocator *allocator,
                                 ms_error *error);
#endif

MS_API ms_nn_shape ms_nn_input_shape(const ms_nn *nn);
MS_API ms_nn_shape ms_nn_output_shape(const ms_nn *nn);
MS_API size_t ms_nn_input_size(const ms_nn *nn); /* floats of one sample */
MS_API size_t ms_nn_output_size(const ms_nn *nn);
MS_API int ms_nn_layer_count(const ms_nn *nn);
MS_API ms_nn_layer ms_nn_layer_at(const ms_nn *nn, int i); /* i in [0, ms_nn_layer_count) */
MS_API const ms_nn_file *ms_nn_tensors(const ms_nn *nn);   /* the file behind it; belongs to nn */
MS_API ms_simd ms_nn_simd(const ms_nn *nn);                /* the level in use */

/* Reads every weight. MS_BAD_DATA and the name and index of the first NaN or infinity; MS_OK: there is none. */
MS_API ms_status ms_nn_check_weights(const ms_nn *nn, ms_error *error);

/* What a workspace is for, and how many samples (forward, VJP) or directions (JVP) run at once. */
typedef enum ms_nn_product { MS_NN_FORWARD, MS_NN_VJP, MS_NN_JVP, MS_NN_JACOBIAN } ms_nn_product;

/* Bytes of the workspace that a call needs; SIZE_MAX: count < 1 or more than memory can address. The Jacobian needs
   count 1. */
MS_API size_t ms_nn_workspace_size(const ms_nn *nn, ms_nn_product product, int count);

/* y = f(x) for count samples at once; the weights are read once for all of them.
   x          [count][input size]
   y          [count][output size] out; may not overlap x
   workspace  ms_nn_workspace_size(nn, MS_NN_FORWARD, count) bytes, any alignment; NULL: from the allocator
   nn is only read: calls may overlap if their workspaces differ. NaN and infinity pass through.
   Same bits for any thread count, and for a sample alone or in a batch, at one SIMD level.
   MS_INVALID_ARGUMENT: count < 1, a NULL pointer. MS_OUT_OF_MEMORY: only with workspace NULL. */
MS_API ms_status ms_nn_forward(const ms_nn *nn, int count, const float *x, float *y, void *workspace);

/* Vector-Jacobian product g_x = (df/dx)' g_y for count samples, each with its own output gradient.
   x          [count][input size]
   g_y        [count][output size]
   y          [count][output size] out: f(x), bit-equal to ms_nn_forward; NULL: not wanted
   g_x        [count][input size] out
   At a kink (relu at 0) the slope of the left side, at a tie in a pool the first maximum, as PyTorch does.
   Statuses, threads, bits and workspace (MS_NN_VJP) as for ms_nn_forward. */
MS_API ms_status ms_nn_vjp(const ms_nn *nn, int count, const float *x, const float *g_y, float *y, float *g_x,
                           void *workspace);

/* Jacobian-vector products dy = (df/dx) dx at one x for count directions.
   x          [input size]
   dx         [count][input size]
   y          [output size] out; NULL: not wanted
   dy         [count][output size] out
   Workspace MS_NN_JVP. */
MS_API ms_status ms_nn_jvp(const ms_nn *nn, int count, const float *x, const float *dx, float *y, float *dy,
                           void *workspace);

/* The whole Jacobian at one x: forwards (one direction an input) or backwards (one an output), whichever is fewer.
   y          [output size] out; NULL: not wanted
   jacobian   [output size][input size] out
   Workspace MS_NN_JACOBIAN, count 1. The weights are read once. */
MS_API ms_status ms_nn_jacobian(const ms_nn *nn, const float *x, float *y, float *jacobian, void *workspace);

/* ---- GPU text: a network as fragment shaders ------------------------------------------------------------------- */

#define MS_NN_SHADER_WIDTH 2048     /* texels of a row of the weights' texture */
#define MS_NN_SHADER_ROWS_MAX 16384 /* rows that it may have: 134 million weights */

/* Metal: translate the Vulkan text (glslangValidator -V, spirv-cross --msl). */
typedef enum ms_nn_language {
    MS_NN_GLSL_330 = 0,    /* desktop OpenGL 3.3; constants: uniform vec4 ms_nn */
    MS_NN_GLSL_ES_300 = 1, /* OpenGL ES 3.0, WebGL 2; the same. Targets of floats need EXT_color_buffer_float */
    MS_NN_GLSL_VULKAN = 2, /* GLSL 450 for SPIR-V; set 0; constants: uniform block, binding 0 */
    MS_NN_HLSL = 3,        /* shader model 4 and later; constants: cbuffer b0 */
    MS_NN_WGSL = 4         /* WebGPU; group 0; constants: uniform buffer, binding 0 */
} ms_nn_language;

/* One draw of a full-screen triangle. Networks are dense layers with activations and added skips, also once a channel
   (shared_channels). The dense layers are cut into steps: the last `steps` - 1 of them are steps of their own, those
   before are the first step, which keeps their values in registers. A gallery is two draws: features of all pictures,
   then all pixels. Wide layers run faster in a step each (they are then computed once, not once for every four outputs
   of the step). All zero but step: steps 2, GLSL 330, values out. */
typedef struct ms_nn_shader {
    int step;          /* 0 to steps - 1 */
    int steps;         /* 1 to the number of dense layers; 0: 2, or 1 where there is one layer only */
    int width, height; /* of a picture, if the last step draws pictures; 0: it writes values as the others do */
    ms_nn_language language;
} ms_nn_shader;

/* Sizes of the textures, all RGBA and read by texel (OpenGL: GL_NEAREST for both filters):
     ms_nn_weights  HLSL t0, Vulkan and WGSL binding 1: MS_NN_SHADER_WIDTH x weight_rows, 16 or 32 bits, the same for
                    each step
     ms_nn_values   HLSL t1, Vulkan and WGSL binding 2: input_width x rows a picture, 32-bit floats: of the first step
                    what ms_nn_shader_inputs makes, of the others the target of the step before
   The target is target_width x rows a picture for values (32-bit floats; 16 bits lose up to 1/2000 of each value): four
   values a texel, and row r x rows + c is channel c of picture r. With width and height it is a sheet of pictures in
   any format: the outputs are planes of width x height, one to four: grey, two channels, RGB, RGBA (alpha 1 without a
   fourth). Picture i stands in column i mod ms_nn.x, row i / ms_nn.x, pictures from ms_nn.y on are 0. The constants of
     this step alone: ms_nn  {pictures in a row of the sheet, pictures, flip, 0}; flip 0: row 0 of the sheet is row 0 of
            the target, which OpenGL shows at the bottom; the height of the target: it is the last row
   Values agree with ms_nn_forward within some 1e-6 of the largest with 32-bit weights; 16 bits round each by up to
   2^-12. */
typedef struct ms_nn_shader_sizes {
    int steps, rows, input_width, target_width, weight_rows;
} ms_nn_shader_sizes;

/* MS_UNSUPPORTED, naming the layer: convolutions, resizing, pooling, concatenation; an addition whose other value an
   earlier step made; a network without dense layers, or too large. MS_INVALID_ARGUMENT: step, steps, language; width x
   height does not divide the outputs into one to four planes. */
MS_API ms_status ms_nn_shader_layout(const ms_nn *nn, const ms_nn_shader *shader, ms_nn_shader_sizes *sizes,
                                     ms_error *error);

/* The text of a step, with entry point main.
   text    at least the returned length + 1 chars, or NULL with capacity 0 to ask; untouched where it does not fit
   Returns the length; 0 with error filled as by ms_nn_shader_layout. */
MS_API size_t ms_nn_shader_text(const ms_nn *nn, const ms_nn_shader *shader, char *text, size_t capacity,
                                ms_error *error);

/* The weights' texture: for each dense layer, blocks of 4 outputs x 4 inputs (a texel holds 4 inputs of an output, 4
   texels follow for the outputs; zeros beyond the ends), inputs fastest; then its biases, 4 a texel.
   dtype   MS_NN_F16 or MS_NN_F32, in the host's order of bytes; I8 weights are multiplied by their scales
   out     [weight_rows][MS_NN_SHADER_WIDTH][4] elements
   MS_UNSUPPORTED as above, and a weight over 65504 in F16. */
MS_API ms_status ms_nn_shader_weights(const ms_nn *nn, ms_nn_dtype dtype, void *out, ms_error *error);

/* The first step's values, all that changes with the materials.
   x       [count][input size]
   out     [count][rows][input_width][4] */
MS_API ms_status ms_nn_shader_inputs(const ms_nn *nn, int count, const float *x, float *out);

#ifndef MS_NN_NO_COLLAPSE
/* ---- collapse: a network with a linear last layer as an objective ---------------------------------------------- */

/* With y = W h(x) + b, target t and a weight for each output in the diagonal of M,
     |y - t|_M^2 = |R (h - h0) - e|^2 + rest,   R'R = W' M W,
   where R is square in the features h: an evaluation needs the layers up to h and one triangular product, not W.
   With shared_channels each channel has its features, and its outputs their part of M and t; channels with the same
   weights share one R. */
typedef struct ms_nn_collapse ms_nn_collapse;

/* Makes R by a QR of sqrt(M) W in double precision (blocked Householder; parts joined in a fixed order); with weights
   by the Cholesky factor of W' M W, some times as fast, unless a column of sqrt(M) W lies within 1e-4 of the others'
   span.
   nn      its last layer must be dense and linear (MS_UNSUPPORTED); must outlive *c
   weight  [output size] >= 0, diagonal of M; NULL: all 1. Then R is read from the file's tensor
           "ms_nn.collapse" (F64, [h (h + 1) / 2], h = inputs of the last layer) if it is there
   *c      out; ms_nn_collapse_destroy releases it
   About 2 h^2 multiply-adds for each output of a channel, once for each different set of weights; 8 h^2 bytes for each
   channel and, while it runs, for each of 8 parts.
   MS_INVALID_ARGUMENT: a negative or non-finite weight (position: its index). MS_OUT_OF_MEMORY. */
MS_API ms_status ms_nn_collapse_create(const ms_nn *nn, const float *weight, ms_nn_collapse **c, ms_error *error);
MS_API void ms_nn_collapse_destroy(ms_nn_collapse *c); /* NULL is allowed */

/* Inputs of the last layer, those of all channels together. */
MS_API size_t ms_nn_collapse_features(const ms_nn_collapse *c);

/* R of the first channel, rows of the upper triangle one after the other: store that of a collapse without weights as
   F64 tensor "ms_nn.collapse" (ms_nn_file_write) and the next ms_nn_collapse_create takes no time. */
MS_API const double *ms_nn_collapse_r(const ms_nn_collapse *c);

/* Changes the weights of some outputs: R is updated by their rows (Householder for more weight, mixed hyperbolic
   rotations for less), or made anew where that would lose accuracy or time. The target must be set again. A mask of
   pixels names each in every channel; then the channels go on sharing R.
   index   [count] outputs, each once
   weight  [count] >= 0
   MS_INVALID_ARGUMENT (position: index of the offender), MS_OUT_OF_MEMORY: c is unchanged. */
MS_API ms_status ms_nn_collapse_mask(ms_nn_collapse *c, size_t count, const size_t *index, const float *weight,
                                     ms_error *error);

/* Sets t. Two passes over W, of floats and of doubles: semi-normal equations with a correction (Bjoerck 1987), so that
   the residual of the best h is summed, not subtracted.
   target  [output size], finite */
MS_API ms_status ms_nn_collapse_target(ms_nn_collapse *c, const float *target, ms_error *error);

/* |f(x) - t|_M^2 in double. Its error is about 1e-16 |t|_M^2 + that of h(x) in float: a residual of 1e-6 |t| keeps
   four digits.
   workspace  ms_nn_collapse_workspace_size(c, 0) bytes, any alignment; NULL: from the allocator
   MS_INVALID_ARGUMENT: no target since the last mask. c is only read: calls may overlap if their workspaces differ. */
MS_API ms_status ms_nn_collapse_value(const ms_nn_collapse *c, const float *x, double *value, void *workspace);

/* The residual vector, whose square sum is the value, and its Jacobian, for least-squares solvers.
   residual  [features + 1] out, channel by channel; the last is sqrt(rest) and does not depend on x
   jacobian  [features + 1][input size] out; NULL: not wanted
   workspace ms_nn_collapse_workspace_size(c, jacobian != NULL) bytes; NULL: from the allocator */
MS_API ms_status ms_nn_collapse_residual(const ms_nn_collapse *c, const float *x, double *residual, double *jacobian,
                                         void *workspace);
MS_API size_t ms_nn_collapse_workspace_size(const ms_nn_collapse *c, int with_jacobian);

/* ---- low rank: a smaller last layer for the inputs that matter ------------------------------------------------- */

/* Over sample inputs, W (h - mean h) is replaced by its projection on the `rank` output directions that carry most of
   its variance: U U' W, the best of that rank for these features (a truncated SVD of W times a factor of the
   covariance of h; plain truncation of W needs a far higher rank). */
typedef struct ms_nn_low_rank ms_nn_low_rank;

/* c        made without weights or masks; must outlive *low_rank
   samples  how many; more than the features for a faithful covariance
   x        [samples][input size]
   peak     the largest output, for PSNR: 10 log10(peak^2 / mean square error); 0: 1
   About 10 features^3 multiply-adds. */
MS_API ms_status ms_nn_low_rank_create(const ms_nn_collapse *c, int samples, const float *x, double peak,
                                       ms_nn_low_rank **low_rank, ms_error *error);
MS_API void ms_nn_low_rank_destroy(ms_nn_low_rank *low_rank); /* NULL is allowed */

/* PSNR in dB of the rank, against the full network, over the samples; infinite where nothing is lost. */
MS_API double ms_nn_low_rank_psnr(const ms_nn_low_rank *low_rank, int rank);

/* The smallest rank of at least that PSNR; the number of features if there is none. */
MS_API int ms_nn_low_rank_for(const ms_nn_low_rank *low_rank, double psnr_db);

/* Writes the file of the smaller network: the last dense layer becomes two, "<name>.low" and "<name>".
   rank   1 to the number of features
   dtype  of their weights: F32, F16 or BF16 */
MS_API ms_status ms_nn_low_rank_write(const ms_nn_low_rank *low_rank, int rank, ms_nn_dtype dtype, ms_nn_sink sink,
                                      ms_error *error);
#endif /* MS_NN_NO_COLLAPSE */

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

#ifndef MS_ASSERT /* checks of the library's own invariants, never of the caller's data */
#define MS_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__) || defined(__clang__)
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
    while (x >= 1e6) {
        x /= 10;
        ++exponent;
    }
    while (x < 1e5) {
        x *= 10;
        --exponent;
    }
    mantissa = (int64_t)(x + 0.5);
    if (mantissa >= 1000000) {
        mantissa /= 10;
        ++exponent;
    }
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
#endif /* MS_COMMON_PRIVATE */
/* ms-common-private end */

/* ms-common-half begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_HALF
#define MS_COMMON_HALF

/* IEEE binary16 by integers alone: subnormals, infinities and NaN, whatever the host's rounding and flushing of
   subnormals. */
static MS__UNUSED float ms__half_to_float(uint16_t h)
{
    uint32_t bits = (uint32_t)(h & 0x8000u) << 16, exponent = (h >> 10) & 31u, mantissa = h & 1023u;
    float value;
    if (exponent == 31u) {
        bits |= 0x7f800000u | mantissa << 13;
    } else if (exponent != 0 || mantissa != 0) {
        if (exponent == 0) /* a subnormal half is a normal float */
            for (exponent = 1; !(mantissa & 1024u); mantissa <<= 1) --exponent;
        bits |= ((exponent + 112u) << 23) + ((mantissa & 1023u) << 13);
    }
    memcpy(&value, &bits, sizeof value);
    return value;
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
#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#else
#include <cpuid.h>
#endif
#if defined(_MSC_VER) && defined(__clang__) /* its immintrin.h leaves out what the command line's target lacks */
#include <pmmintrin.h>
#include <tmmintrin.h>
#include <smmintrin.h>
#include <popcntintrin.h>
#include <avxintrin.h>
#include <avx2intrin.h>
#include <f16cintrin.h>
#include <fmaintrin.h>
#include <avx512fintrin.h>
#include <avx512vlintrin.h>
#include <avx512bwintrin.h>
#include <avx512dqintrin.h>
#include <avx512vlbwintrin.h>
#include <avx512vldqintrin.h>
#include <avx512vnniintrin.h>
#include <avx512vlvnniintrin.h>
#endif
#elif !defined(MS_NO_SIMD) && (defined(__aarch64__) || defined(_M_ARM64))
#define MS__NEON 1
#include <arm_neon.h>
#endif

#if defined(MS__X64)
static MS__UNUSED void ms__cpuid(uint32_t leaf, uint32_t subleaf, uint32_t r[4])
{
#if defined(_MSC_VER) && !defined(__clang__)
    int v[4];
    __cpuidex(v, (int)leaf, (int)subleaf);
    r[0] = (uint32_t)v[0];
    r[1] = (uint32_t)v[1];
    r[2] = (uint32_t)v[2];
    r[3] = (uint32_t)v[3];
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
#if defined(_MSC_VER) && !defined(__clang__)
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
#endif /* MS_COMMON_SIMD */
/* ms-common-simd end */

#ifndef MS_NN_NO_STDIO
/* ms-common-files begin (the same text wherever it stands: see tests/common.sh) */
#ifndef MS_COMMON_FILES
#define MS_COMMON_FILES
/* A file that takes the old one's place only when it is whole: written beside it, flushed, checked, renamed. Whatever
   fails, the old file stays and nothing else does. Links are followed. Wants a regular file or none under that name. */
#include <stdio.h>
#if defined(_WIN32)
#include <io.h>
#include <sys/stat.h>
#include <sys/types.h>
#ifdef __cplusplus
extern "C"
#endif
    __declspec(dllimport) int __stdcall MoveFileExA(const char *from, const char *to,
                                                    unsigned long flags); /* as windows.h has it */
#elif defined(__unix__) || defined(__APPLE__)
#define MS__POSIX 1
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#if defined(__linux__) && defined(__STRICT_ANSI__) && !defined(__cplusplus) /* -std=c99 hides these, not what they do \
                                                                             */
int fileno(FILE *stream);
int fsync(int file);
ssize_t readlink(const char *path, char *to, size_t size);
#endif
#endif

#define MS__PATH_MAX 4096

typedef struct ms__file {
    FILE *stream;
    int failed;                    /* a write did not arrive */
    char path[MS__PATH_MAX];       /* behind all links */
    char beside[MS__PATH_MAX + 8]; /* path and a suffix that no other file has */
} ms__file;

static MS__UNUSED ms_status ms__file_open(ms__file *f, const char *path, ms_error *error)
{
    size_t n = path != NULL ? strlen(path) : 0;
    int i;
#if defined(MS__POSIX)
    struct stat info;
    ssize_t length;
#elif defined(_WIN32)
    struct _stat info;
#endif
    f->stream = NULL;
    f->failed = 0;
    if (n == 0) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "path is NULL or empty");
    if (n >= MS__PATH_MAX)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "path is longer than %d bytes", MS__PATH_MAX - 1);
    memcpy(f->path, path, n + 1);
#if defined(MS__POSIX)
    for (i = 0; i < 32 && (length = readlink(f->path, f->beside, MS__PATH_MAX - 1)) > 0; ++i) {
        char *name = strrchr(f->path, '/'); /* a relative link starts from its own folder */
        size_t folder = f->beside[0] == '/' || name == NULL ? 0 : (size_t)(name + 1 - f->path);
        if (folder + (size_t)length >= MS__PATH_MAX) break;
        memcpy(f->path + folder, f->beside, (size_t)length);
        n = folder + (size_t)length;
        f->path[n] = 0;
    }
    if (stat(f->path, &info) == 0) {
        if (S_ISDIR(info.st_mode)) return ms__fail(error, MS_IO, 0, "'%s' is a directory", path);
        if (!S_ISREG(info.st_mode)) return ms__fail(error, MS_IO, 0, "'%s' is not a regular file", path);
        if (access(f->path, W_OK) != 0) return ms__fail(error, MS_IO, 0, "'%s' may not be written", path);
    } else {
        info.st_mode = 0;
    }
#elif defined(_WIN32)
    if (_stat(f->path, &info) == 0) {
        if ((info.st_mode & _S_IFMT) == _S_IFDIR) return ms__fail(error, MS_IO, 0, "'%s' is a directory", path);
        if ((info.st_mode & _S_IFMT) != _S_IFREG) return ms__fail(error, MS_IO, 0, "'%s' is not a regular file", path);
        if (!(info.st_mode & _S_IWRITE)) return ms__fail(error, MS_IO, 0, "'%s' may not be written", path);
    }
#endif
    memcpy(f->beside, f->path, n);
    memcpy(f->beside + n, ".new00", 7);
    for (i = 0; i < 100 && f->stream == NULL; ++i) {
        FILE *taken;
        f->beside[n + 4] = (char)('0' + i / 10);
        f->beside[n + 5] = (char)('0' + i % 10);
        taken = fopen(f->beside, "rb");
        if (taken != NULL) fclose(taken);
#if defined(_WIN32) && !defined(_UCRT)
        else f->stream = fopen(f->beside, "wb");
#else
        else
            f->stream = fopen(f->beside,
                              "wbx"); /* x: only if there is none yet (C11, in POSIX libraries long before) */
#endif
    }
    if (f->stream == NULL)
        return ms__fail(error, MS_IO, 0, "no file can be made beside '%s': its folder is missing, read-only or full",
                        path);
#if defined(MS__POSIX)
    if (info.st_mode != 0)
        chmod(f->beside, info.st_mode & 0777); /* who could not read the old one cannot read the new one */
#endif
    return MS_OK;
}

/* 0, or 1 if it was not written; ms__file_close() knows it too. */
static MS__UNUSED int ms__file_write(void *file, const void *bytes, size_t size)
{
    ms__file *f = (ms__file *)file;
    if (size != 0 && fwrite(bytes, 1, size, f->stream) != size) f->failed = 1;
    return f->failed;
}

/* MS_OK if status is MS_OK and the file now stands under its name; otherwise it is gone. */
static MS__UNUSED ms_status ms__file_close(ms__file *f, ms_status status, ms_error *error)
{
    int failed = f->failed;
    if (status == MS_OK && !failed) {
        failed = fflush(f->stream) != 0;
#if defined(MS__POSIX)
        failed = failed || fsync(fileno(f->stream)) != 0;
#elif defined(_WIN32)
        failed = failed || _commit(_fileno(f->stream)) != 0;
#endif
    }
    failed = fclose(f->stream) != 0 || failed;
    if (f->failed || (status == MS_OK && failed))
        status = ms__fail(error, MS_IO, 0, "'%s' cannot be written to its end: the disk is full or failed", f->path);
    if (status == MS_OK && rename(f->beside, f->path) != 0) {
#if defined(_WIN32) /* where rename() refuses to replace; 1: replace, 8: return when it is done */
        if (!MoveFileExA(f->beside, f->path, 1 | 8))
#endif
            status = ms__fail(error, MS_IO, 0, "'%s' cannot be replaced", f->path);
    }
    if (status != MS_OK) remove(f->beside);
    return status;
}
#endif /* MS_COMMON_FILES */
/* ms-common-files end */
#endif

#if !defined(MS_NN_NO_STDIO)
#include <stdio.h>
#if defined(__unix__) || (defined(__APPLE__) && defined(__MACH__))
#define MS_NN__MMAP 1
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#endif
#include <limits.h>
#include <math.h>

#ifndef MS_NN_FILENAME /* how this file is named in an #include, for its second reading (SIMD kernels) */
#define MS_NN_FILENAME "ms_nn.h"
#endif

/* The implementation, in the order of the data:
   bytes, sorting, JSON, file, writer, layer list, plan, run, products, queries, GPU text, stdio, collapse, low rank,
   levels, kernels */

/* Reading, writing and planning are compiled for size. */
#if defined(__GNUC__) || defined(__clang__)
#define MS_NN__COLD __attribute__((cold))
#else
#define MS_NN__COLD
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

static int ms_nn__bits(ms_nn_dtype dtype)
{
    static const int bits[] = {
#define MS_NN__DTYPE_BITS(code, name, n) n,
        MS_NN_DTYPE_LIST(MS_NN__DTYPE_BITS)
#undef MS_NN__DTYPE_BITS
            0};
    return bits[(int)dtype];
}

static const char *ms_nn__dtype_name(int dtype)
{
    static const char *const name[] = {
#define MS_NN__DTYPE_NAME(code, text, bits) text,
        MS_NN_DTYPE_LIST(MS_NN__DTYPE_NAME)
#undef MS_NN__DTYPE_NAME
            "unknown"};
    return name[dtype >= 0 && dtype < (int)MS_NN_DTYPE_COUNT ? dtype : (int)MS_NN_DTYPE_COUNT];
}

/* Element i of a tensor of one of the five types that networks use. */
static double ms_nn__element(const void *data, ms_nn_dtype dtype, size_t i)
{
    const unsigned char *p = (const unsigned char *)data + i * (size_t)(ms_nn__bits(dtype) / 8);
    if (dtype == MS_NN_F64) {
        uint64_t bits = ms_nn__u64(p);
        double x;
        memcpy(&x, &bits, sizeof x);
        return x;
    }
    if (dtype == MS_NN_F32) return (double)ms_nn__float_of(ms_nn__u32(p));
    if (dtype == MS_NN_F16) return (double)ms__half_to_float((uint16_t)ms_nn__u16(p));
    if (dtype == MS_NN_BF16) return (double)ms_nn__float_of(ms_nn__u16(p) << 16);
    return *p < 128 ? (double)*p : (double)*p - 256.0; /* I8 */
}

/* x as a float, without an exception where it is too large for one (FLT_MAX and half an ulp: infinite) or a signalling
   NaN. */
static float ms_nn__narrow(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (ms__finite(x) && fabs(x) < 3.4028235677973366e38) return (float)x;
    return ms_nn__float_of((uint32_t)(bits >> 63) << 31 | (!ms__finite(x) && bits << 12 ? 0x7fc00000u : 0x7f800000u));
}

/* ---- sorting --------------------------------------------------------------------------------------------------- */

/* Heap sort of indices: no recursion, no allocation, O(n log n) for any input. */
static void ms_nn__sort(size_t *index, size_t n, int (*compare)(const void *context, size_t a, size_t b),
                        const void *context)
{
    size_t start = n / 2, end = n;
    while (end > 1) {
        size_t root, child, moving;
        if (start > 0) {
            moving = index[--start];
        } else {
            moving = index[--end];
            index[end] = index[0];
        }
        for (root = start; (child = 2 * root + 1) < end; root = child) {
            if (child + 1 < end && compare(context, index[child], index[child + 1]) < 0) ++child;
            if (compare(context, moving, index[child]) >= 0) break;
            index[root] = index[child];
        }
        index[root] = moving;
    }
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

static MS_NN__COLD ms_status ms_nn__bad(const ms_nn__json *j, const char *sentence)
{
    return ms__fail(j->error, MS_BAD_DATA, j->base + (size_t)(j->p - j->start), "%s", sentence);
}

/* The same at another place, with a word of the file in the sentence. */
static MS_NN__COLD ms_status ms_nn__bad_word(const ms_nn__json *j, const unsigned char *at, const char *format,
                                             const char *word)
{
    return ms__fail(j->error, MS_BAD_DATA, j->base + (size_t)(at - j->start), format, word);
}

/* Puts what an error speaks of in front of its sentence: `kind`, then a name in quotes. Returns status. */
static MS_NN__COLD ms_status ms_nn__about(ms_error *error, ms_status status, size_t position, const char *kind,
                                          const char *name)
{
    ms_error inner;
    if (error == NULL) return status;
    inner = *error;
    return ms__fail(error, status, position, *name ? "%s '%s': %s" : "%s%s: %s", kind, name, inner.message);
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
    if (!ms_nn__take(j, '"')) return ms_nn__bad(j, "expected a string in double quotes");
    s->text = *pool;
    for (;;) {
        unsigned char out[4];
        size_t n, i;
        if (j->p == j->end) return ms_nn__bad(j, "a string has no end");
        if (*j->p == '"') break;
        if (*j->p < 0x20) return ms_nn__bad(j, "a control character in a string must be escaped");
        if (*j->p != '\\') {
            n = ms_nn__utf8(j->p, j->end);
            if (n == 0) return ms_nn__bad(j, "a string is not valid UTF-8");
            memcpy(out, j->p, n);
            j->p += n;
        } else {
            static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
            const char *simple;
            unsigned char c = (unsigned char)(j->end - j->p > 1 ? j->p[1] : 0);
            uint32_t code = 0, low = 0;
            simple = c ? strchr(from, c) : NULL;
            if (simple != NULL) {
                code = (uint32_t)(unsigned char)to[simple - from];
                j->p += 2;
            } else {
                if (c != 'u' || !ms_nn__hex4(j->p + 2, j->end, &code))
                    return ms_nn__bad(j, "unknown escape in a string");
                if (code >= 0xD800 && code < 0xE000) {
                    if (code >= 0xDC00 || j->end - j->p < 12 || j->p[6] != '\\' || j->p[7] != 'u' ||
                        !ms_nn__hex4(j->p + 8, j->end, &low) || low < 0xDC00 || low >= 0xE000)
                        return ms_nn__bad(j, "a surrogate escape without its other half");
                    code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
                    j->p += 6;
                }
                if (code == 0) return ms_nn__bad(j, "a NUL character in a string");
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
        if (v > (SIZE_MAX - digit) / 10) return ms_nn__bad(j, "a number is too large for the address space");
        v = v * 10 + digit;
    }
    if (j->p == first || (*first == '0' && j->p - first > 1) ||
        (j->p < j->end && (*j->p == '.' || *j->p == 'e' || *j->p == 'E')))
        return ms_nn__bad(j, "expected a plain integer: digits without sign, point, exponent or leading zero");
    *value = v;
    return MS_OK;
}

/* After an item of a list: *more is 1 after a comma, 0 after the closing character. */
static MS_NN__COLD ms_status ms_nn__json_more(ms_nn__json *j, char close, int *more)
{
    *more = ms_nn__take(j, ',');
    if (*more || ms_nn__take(j, close)) return MS_OK;
    return ms_nn__bad(j, close == '}' ? "expected ',' or '}'" : "expected ',' or ']'");
}

/* ---- file ------------------------------------------------------------------------------------------------------ */

typedef struct ms_nn__record {
    ms_nn_tensor tensor;
    size_t begin, end, position; /* range in the data, place of the entry in the file */
} ms_nn__record;

struct ms_nn_file {
    ms_allocator allocator;
    size_t bytes;        /* of this allocation, which holds everything below */
    const void *content; /* the file, where ms_nn_file_read mapped it or read it into memory; else NULL */
    size_t content_bytes;
    int content_is_mapped;
    size_t tensors, entries;
    ms_nn__record *record; /* [tensors] in the order of the header */
    ms_nn_entry *entry;    /* [entries] */
    size_t *shape;         /* all dimensions */
    size_t *by_data, *by_name, *by_key;
    size_t *value_at; /* [entries] byte in the file behind the quote that opens a value */
    const unsigned char *start;
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
    size_t elements = 1, nonzero = 1, offset[2] = {0, 0}, bits;
    size_t *shape = h->file ? h->file->shape + h->dimensions : NULL;
    ms_nn__string s;
    char *none = NULL;
    ms_status status;
    if (!ms_nn__take(j, '{')) return ms_nn__bad(j, "a tensor must be an object with dtype, shape and data_offsets");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        int field;
        const unsigned char *at = j->p;
        if ((status = ms_nn__json_string(j, &none, &s)) != MS_OK) return status;
        field = ms_nn__is(&s, "dtype") ? 1 : ms_nn__is(&s, "shape") ? 2 : ms_nn__is(&s, "data_offsets") ? 4 : 0;
        if (field == 0)
            return ms_nn__bad_word(j, at, "unknown field '%s'; known are dtype, shape, data_offsets", s.head);
        if (seen & field) return ms_nn__bad_word(j, at, "the field '%s' stands twice", s.head);
        seen |= field;
        if (!ms_nn__take(j, ':')) return ms_nn__bad(j, "expected ':'");
        if (field == 1) {
            ms_nn__space(j);
            at = j->p;
            if ((status = ms_nn__json_string(j, &none, &s)) != MS_OK) return status;
            for (dtype = 0; dtype < (int)MS_NN_DTYPE_COUNT; ++dtype)
                if (ms_nn__is(&s, ms_nn__dtype_name(dtype))) break;
            if (dtype == (int)MS_NN_DTYPE_COUNT) return ms_nn__bad_word(j, at, "unknown dtype '%s'", s.head);
        } else {
            int list = !ms_nn__take(j, '['), count = 0;
            if (list) return ms_nn__bad(j, "expected a list of integers in brackets");
            for (list = !ms_nn__take(j, ']'); list; ++count) {
                size_t value;
                if ((status = ms_nn__json_size(j, &value)) != MS_OK) return status;
                if (count == (field == 2 ? MS_NN_MAX_RANK : 2))
                    return ms_nn__bad(j, field == 2 ? "more than 32 dimensions" : "data_offsets must have two numbers");
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
            else if (count != 2) return ms_nn__bad(j, "data_offsets must have two numbers");
        }
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    if (seen != 7) return ms_nn__bad(j, "a tensor lacks dtype, shape or data_offsets");
    bits = ms__size_mul(elements, (size_t)ms_nn__bits((ms_nn_dtype)dtype));
    if (ms__size_mul(nonzero, (size_t)ms_nn__bits((ms_nn_dtype)dtype)) == SIZE_MAX || bits == SIZE_MAX)
        return ms_nn__bad(j, "the product of the dimensions overflows");
    if (bits % 8) return ms_nn__bad(j, "a tensor must fill whole bytes");
    if (offset[0] > offset[1] || offset[1] > h->data_size)
        return ms_nn__bad(j, "data_offsets must rise and lie within the file");
    if (offset[1] - offset[0] != bits / 8) return ms_nn__bad(j, "data_offsets do not span what dtype and shape need");
    if (h->file) {
        ms_nn__record *r = &h->file->record[h->tensors];
        r->tensor.name = name->text;
        r->tensor.dtype = (ms_nn_dtype)dtype;
        r->tensor.rank = rank;
        r->tensor.shape = shape;
        r->tensor.data = h->data + offset[0];
        r->tensor.bytes = bits / 8;
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
    if (!ms_nn__take(j, '{')) return ms_nn__bad(j, "__metadata__ must be an object of strings");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string key, value;
        if ((status = ms_nn__json_string(j, &h->pool, &key)) != MS_OK) return status;
        if (!ms_nn__take(j, ':')) return ms_nn__bad(j, "expected ':'");
        ms_nn__space(j);
        if (h->file) h->file->value_at[h->entries] = j->base + (size_t)(j->p - j->start) + 1;
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
    if (j->p == j->end || *j->p != '{') return ms_nn__bad(j, "the header must begin with '{'");
    ++j->p;
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string name;
        size_t position;
        ms_nn__space(j);
        position = j->base + (size_t)(j->p - j->start);
        if ((status = ms_nn__json_string(j, &h->pool, &name)) != MS_OK) return status;
        h->text += name.length + 1;
        if (!ms_nn__take(j, ':')) return ms_nn__bad(j, "expected ':'");
        if (ms_nn__is(&name, "__metadata__")) {
            if (metadata++) return ms_nn__bad(j, "__metadata__ stands twice");
            status = ms_nn__header_metadata(j, h);
        } else {
            status = ms_nn__header_tensor(j, h, &name, position);
            if (status != MS_OK)
                return ms_nn__about(j->error, status, j->error ? j->error->position : 0, "tensor", name.head);
        }
        if (status != MS_OK) return status;
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    ms_nn__space(j);
    if (j->p != j->end) return ms_nn__bad(j, "only spaces may follow the header's object");
    return MS_OK;
}

static MS_NN__COLD int ms_nn__compare_data(const void *context, size_t a, size_t b)
{
    const ms_nn__record *r = (const ms_nn__record *)context;
    if (r[a].begin != r[b].begin) return r[a].begin < r[b].begin ? -1 : 1;
    if (r[a].end != r[b].end) return r[a].end < r[b].end ? -1 : 1;
    return a < b ? -1 : a > b; /* empty tensors at one place keep their order */
}

static MS_NN__COLD int ms_nn__compare_name(const void *context, size_t a, size_t b)
{
    const ms_nn__record *r = (const ms_nn__record *)context;
    return strcmp(r[a].tensor.name, r[b].tensor.name);
}

static MS_NN__COLD int ms_nn__compare_key(const void *context, size_t a, size_t b)
{
    const ms_nn_entry *e = (const ms_nn_entry *)context;
    return strcmp(e[a].key, e[b].key);
}

/* Names and keys once each; the data without holes or overlaps from 0 to its end. */
static MS_NN__COLD ms_status ms_nn__file_check(ms_nn_file *f, size_t data_start, size_t data_size, int allow_trailing,
                                               ms_error *error)
{
    size_t i, end = 0;
    for (i = 0; i < f->tensors; ++i) f->by_data[i] = f->by_name[i] = i;
    for (i = 0; i < f->entries; ++i) f->by_key[i] = i;
    ms_nn__sort(f->by_data, f->tensors, ms_nn__compare_data, f->record);
    ms_nn__sort(f->by_name, f->tensors, ms_nn__compare_name, f->record);
    ms_nn__sort(f->by_key, f->entries, ms_nn__compare_key, f->entry);
    for (i = 1; i < f->tensors; ++i)
        if (ms_nn__compare_name(f->record, f->by_name[i - 1], f->by_name[i]) == 0)
            return ms__fail(error, MS_BAD_DATA, f->record[f->by_name[i]].position, "the tensor name '%s' stands twice",
                            f->record[f->by_name[i]].tensor.name);
    for (i = 1; i < f->entries; ++i)
        if (ms_nn__compare_key(f->entry, f->by_key[i - 1], f->by_key[i]) == 0)
            return ms__fail(error, MS_BAD_DATA, 8, "the metadata key '%s' stands twice", f->entry[f->by_key[i]].key);
    for (i = 0; i < f->tensors; ++i) {
        const ms_nn__record *r = &f->record[f->by_data[i]];
        if (r->begin != end)
            return ms__fail(error, MS_BAD_DATA, r->position,
                            r->begin > end ? "a hole of %z bytes before tensor '%s'"
                                           : "%z bytes of tensor '%s' overlap another one",
                            r->begin > end ? r->begin - end : end - r->begin, r->tensor.name);
        end = r->end;
    }
    if (end != data_size && !allow_trailing)
        return ms__fail(error, MS_BAD_DATA, data_start + end, "%z bytes follow the last tensor", data_size - end);
    return MS_OK;
}

MS_API MS_NN__COLD ms_nn_options ms_nn_defaults(void)
{
    ms_nn_options options;
    memset(&options, 0, sizeof options);
    return options;
}

MS_API const char *ms_nn_dtype_string(ms_nn_dtype dtype) { return ms_nn__dtype_name((int)dtype); }

/* An allocation under the caller's cap. */
static MS_NN__COLD void *ms_nn__alloc(const ms_nn_options *options, size_t size)
{
    if (options->max_memory_bytes && size > options->max_memory_bytes) return NULL;
    return ms__alloc(&options->allocator, size);
}

MS_API MS_NN__COLD ms_status ms_nn_file_open(const void *bytes, size_t size, const ms_nn_options *options,
                                             ms_nn_file **file, ms_error *error)
{
    const unsigned char *b = (const unsigned char *)bytes;
    ms_nn_options o = options ? *options : ms_nn_defaults();
    uint64_t length,
        most = o.max_header_bytes && o.max_header_bytes < MS_NN_MAX_HEADER ? o.max_header_bytes : MS_NN_MAX_HEADER;
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
    if (length > most)
        return ms__fail(error, MS_BAD_DATA, 0, "the header length is over the limit of %z bytes", (size_t)most);
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

    total = ms__size_add(sizeof *f, ms__size_mul(h.tensors, sizeof(ms_nn__record) + 2 * sizeof(size_t)));
    total = ms__size_add(total, ms__size_mul(h.entries, sizeof(ms_nn_entry) + 2 * sizeof(size_t)));
    total = ms__size_add(total, ms__size_add(ms__size_mul(h.dimensions, sizeof(size_t)), h.text));
    f = (ms_nn_file *)ms_nn__alloc(&o, total);
    if (f == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a list of %z tensors", h.tensors);
    memset(f, 0, sizeof *f);
    f->allocator = o.allocator;
    f->bytes = total;
    f->tensors = h.tensors;
    f->entries = h.entries;
    f->record = (ms_nn__record *)(void *)(f + 1);
    f->entry = (ms_nn_entry *)(void *)(f->record + h.tensors);
    f->by_data = (size_t *)(void *)(f->entry + h.entries);
    f->by_name = f->by_data + h.tensors;
    f->by_key = f->by_name + h.tensors;
    f->value_at = f->by_key + h.entries;
    f->shape = f->value_at + h.entries;
    f->start = b;
    f->text = (char *)(f->shape + h.dimensions);

    h.tensors = h.entries = h.dimensions = h.text = 0;
    h.file = f;
    h.pool = f->text;
    j.p = j.start;
    status = ms_nn__header_object(&j, &h);
    if (status == MS_OK) status = ms_nn__file_check(f, h.data_start, h.data_size, o.allow_trailing, error);
    if (status != MS_OK) ms_nn_file_close(f);
    else *file = f;
    return status;
}

/* What ms_nn_file_read made. */
static MS_NN__COLD void ms_nn__release_content(const ms_allocator *allocator, const void *content, size_t bytes,
                                               int is_mapped)
{
    void *at = (void *)(uintptr_t)content;
#ifdef MS_NN__MMAP
    if (is_mapped) {
        munmap(at, bytes);
        return;
    }
#endif
    (void)is_mapped;
    ms__release(allocator, at, bytes);
}

MS_API MS_NN__COLD void ms_nn_file_close(ms_nn_file *file)
{
    ms_allocator allocator;
    if (file == NULL) return;
    allocator = file->allocator;
    ms_nn__release_content(&allocator, file->content, file->content_bytes, file->content_is_mapped);
    ms__release(&allocator, file, file->bytes);
}

MS_API size_t ms_nn_file_tensor_count(const ms_nn_file *file) { return file ? file->tensors : 0; }
MS_API size_t ms_nn_file_entry_count(const ms_nn_file *file) { return file ? file->entries : 0; }

MS_API const ms_nn_tensor *ms_nn_file_tensor(const ms_nn_file *file, size_t i)
{
    return file && i < file->tensors ? &file->record[file->by_data[i]].tensor : NULL;
}

MS_API const ms_nn_entry *ms_nn_file_entry(const ms_nn_file *file, size_t i)
{
    return file && i < file->entries ? &file->entry[i] : NULL;
}

MS_API const ms_nn_tensor *ms_nn_file_find(const ms_nn_file *file, const char *name)
{
    size_t low = 0, high = file && name ? file->tensors : 0;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const ms_nn_tensor *t = &file->record[file->by_name[middle]].tensor;
        int order = strcmp(name, t->name);
        if (order == 0) return t;
        if (order < 0) high = middle;
        else low = middle + 1;
    }
    return NULL;
}

MS_API const char *ms_nn_file_metadata(const ms_nn_file *file, const char *key)
{
    size_t low = 0, high = file && key ? file->entries : 0;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const ms_nn_entry *e = &file->entry[file->by_key[middle]];
        int order = strcmp(key, e->key);
        if (order == 0) return e->value;
        if (order < 0) high = middle;
        else low = middle + 1;
    }
    return NULL;
}

/* The byte of the file that holds character k of a metadata value: escapes are longer than what they stand for. */
static MS_NN__COLD size_t ms_nn__byte_of(const ms_nn_file *file, const char *key, size_t k)
{
    const unsigned char *p;
    size_t i = 0;
    uint32_t code;
    while (strcmp(file->entry[i].key, key) != 0) ++i;
    for (p = file->start + file->value_at[i]; k > 0; --k) {
        size_t n = 1;
        if (*p != '\\') {
            ++p;
        } else if (p[1] != 'u') {
            p += 2;
        } else {
            ms_nn__hex4(p + 2, p + 6, &code);
            n = code >= 0xD800 && code < 0xE000 ? 4 : code < 0x80 ? 1 : code < 0x800 ? 2 : 3;
            p += n == 4 ? 12 : 6;
        }
        k -= n - 1 < k - 1 ? n - 1 : k - 1;
    }
    return (size_t)(p - file->start);
}

/* ---- writer ---------------------------------------------------------------------------------------------------- */

/* The header's text goes through this: counted first, then written. */
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
    size_t n = sizeof digit;
    do {
        digit[--n] = (char)('0' + (int)(value % 10));
        value /= 10;
    } while (value);
    ms_nn__put(w, digit + n, sizeof digit - n);
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

static MS_NN__COLD int ms_nn__compare_given_name(const void *context, size_t a, size_t b)
{
    const ms_nn_tensor *t = (const ms_nn_tensor *)context;
    return strcmp(t[a].name, t[b].name);
}

static MS_NN__COLD int ms_nn__compare_given_size(const void *context, size_t a, size_t b)
{
    const ms_nn_tensor *t = (const ms_nn_tensor *)context;
    if (t[a].bytes != t[b].bytes) return t[a].bytes > t[b].bytes ? -1 : 1;
    return a < b ? -1 : a > b;
}

/* Every value of the caller, before a byte is written. order is scratch of max(count, entries). */
static MS_NN__COLD ms_status ms_nn__write_check(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                                size_t entries, size_t *order, ms_error *error)
{
    size_t i, total = 0;
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *t = &tensors[i];
        size_t bits = (int)t->dtype >= 0 && t->dtype < MS_NN_DTYPE_COUNT ? (size_t)ms_nn__bits(t->dtype) : SIZE_MAX;
        int d;
        if (!ms_nn__valid_text(t->name) || strcmp(t->name, "__metadata__") == 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "the name of tensor %z is not allowed or not UTF-8", i);
        if (t->rank < 0 || t->rank > MS_NN_MAX_RANK || (t->rank > 0 && t->shape == NULL))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "the rank of tensor '%s' must be 0 to 32", t->name);
        for (d = 0; d < t->rank; ++d) bits = ms__size_mul(bits, t->shape[d]);
        if (bits == SIZE_MAX || bits % 8 || bits / 8 != t->bytes || (t->data == NULL && t->bytes))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "tensor '%s': dtype and shape do not make %z bytes", t->name,
                            t->bytes);
        total = ms__size_add(total, t->bytes);
        order[i] = i;
    }
    if (total == SIZE_MAX) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the tensors' sizes overflow");
    ms_nn__sort(order, count, ms_nn__compare_given_name, tensors);
    for (i = 1; i < count; ++i)
        if (strcmp(tensors[order[i - 1]].name, tensors[order[i]].name) == 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, order[i], "the tensor name '%s' stands twice",
                            tensors[order[i]].name);
    for (i = 0; i < entries; ++i) {
        if (!ms_nn__valid_text(metadata[i].key) || !ms_nn__valid_text(metadata[i].value))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "metadata entry %z is not UTF-8", i);
        order[i] = i;
    }
    ms_nn__sort(order, entries, ms_nn__compare_key, metadata);
    for (i = 1; i < entries; ++i)
        if (strcmp(metadata[order[i - 1]].key, metadata[order[i]].key) == 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, order[i], "the metadata key '%s' stands twice",
                            metadata[order[i]].key);
    return MS_OK;
}

static MS_NN__COLD void ms_nn__write_header(ms_nn__writer *w, const ms_nn_tensor *tensors, size_t count,
                                            const ms_nn_entry *metadata, size_t entries, const size_t *order)
{
    size_t i, offset = 0;
    int d;
    w->length = 8;
    ms_nn__put_text(w, "{");
    if (entries) {
        ms_nn__put_text(w, "\"__metadata__\":{");
        for (i = 0; i < entries; ++i) {
            if (i) ms_nn__put_text(w, ",");
            ms_nn__put_string(w, metadata[i].key);
            ms_nn__put_text(w, ":");
            ms_nn__put_string(w, metadata[i].value);
        }
        ms_nn__put_text(w, count ? "}," : "}");
    }
    for (i = 0; i < count; ++i) {
        const ms_nn_tensor *t = &tensors[order[i]];
        if (i) ms_nn__put_text(w, ",");
        ms_nn__put_string(w, t->name);
        ms_nn__put_text(w, ":{\"dtype\":");
        ms_nn__put_string(w, ms_nn__dtype_name((int)t->dtype));
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
}

MS_API MS_NN__COLD ms_status ms_nn_file_write(const ms_nn_tensor *tensors, size_t count, const ms_nn_entry *metadata,
                                              size_t entries, const ms_allocator *allocator, ms_nn_sink sink,
                                              ms_error *error)
{
    size_t order_bytes = ms__size_mul(count > entries ? count : entries, sizeof(size_t)), i;
    size_t *order;
    ms_nn__writer w;
    ms_status status;
    if ((tensors == NULL && count != 0) || (metadata == NULL && entries != 0) || sink.write == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL",
                        sink.write == NULL                  ? "sink.write"
                            : tensors == NULL && count != 0 ? "tensors"
                                                            : "metadata");
    order = (size_t *)ms__alloc(allocator, order_bytes);
    if (order == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory to sort %z tensors", count);
    status = ms_nn__write_check(tensors, count, metadata, entries, order, error);
    if (status == MS_OK) {
        w.out = NULL;
        for (i = 0; i < count; ++i) order[i] = i;
        ms_nn__sort(order, count, ms_nn__compare_given_size, tensors);
        ms_nn__write_header(&w, tensors, count, metadata, entries, order);
        if (w.length - 8 > MS_NN_MAX_HEADER) {
            status = ms__fail(error, MS_INVALID_ARGUMENT, 0, "names and metadata make a header over %d bytes",
                              MS_NN_MAX_HEADER);
        } else if ((w.out = (char *)ms__alloc(allocator, w.length)) == NULL) {
            status = ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a header of %z bytes", w.length);
        } else {
            size_t length = w.length;
            for (i = 0; i < 8; ++i) w.out[i] = (char)(unsigned char)((uint64_t)(length - 8) >> (8 * i) & 0xFF);
            ms_nn__write_header(&w, tensors, count, metadata, entries, order);
            if (sink.write(sink.user, w.out, length) != 0) status = MS_IO;
            ms__release(allocator, w.out, length);
        }
        for (i = 0; status == MS_OK && i < count; ++i)
            if (tensors[order[i]].bytes && sink.write(sink.user, tensors[order[i]].data, tensors[order[i]].bytes) != 0)
                status = MS_IO;
        if (status == MS_IO) ms__fail(error, MS_IO, 0, "the sink did not take the file");
    }
    ms__release(allocator, order, order_bytes);
    return status;
}

/* ---- layer list ------------------------------------------------------------------------------------------------ */

/* What a layer does, after reading. */
typedef enum ms_nn__kind {
    MS_NN__DENSE,
    MS_NN__CONV1D,
    MS_NN__CONV2D,
    MS_NN__UPSAMPLE1D,
    MS_NN__UPSAMPLE2D,
    MS_NN__POOL1D,
    MS_NN__POOL2D,
    MS_NN__FLATTEN,
    MS_NN__ACTIVATE,
    MS_NN__DROPOUT,
    MS_NN__ADD,
    MS_NN__SHARED,
    MS_NN__TRANSPOSED1D,
    MS_NN__TRANSPOSED2D,
    MS_NN__AVERAGE1D,
    MS_NN__AVERAGE2D,
    MS_NN__GLOBAL,
    MS_NN__CONCAT,
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

/* The fields of a layer in the file; 0 or NULL where the file is silent. */
typedef struct ms_nn__spec {
    const char *type, *name, *activation, *padding, *order, *from, *mode;
    size_t units[2], filters[2], kernel[2], stride[2], size[2], factor[2], dilation[2], groups[2], zeros[2], extra[2];
    double alpha, rate;
    int bias, corners; /* 0: not said, 1: true, 2: false */
    size_t at;         /* where it begins in the list's text */
} ms_nn__spec;

typedef enum ms_nn__field_kind {
    MS_NN__TEXT,
    MS_NN__COUNTS,
    MS_NN__SIZES,
    MS_NN__REAL,
    MS_NN__FLAG
} ms_nn__field_kind; /* SIZES may be 0 */

typedef struct ms_nn__field {
    const char *key;
    ms_nn__field_kind kind;
    size_t offset;
    unsigned layers; /* bit k: kind k takes it */
} ms_nn__field;

#define MS_NN__BIT(kind) (1u << (int)(kind))
#define MS_NN__TRANSPOSED (MS_NN__BIT(MS_NN__TRANSPOSED1D) | MS_NN__BIT(MS_NN__TRANSPOSED2D))
#define MS_NN__CONVS (MS_NN__BIT(MS_NN__CONV1D) | MS_NN__BIT(MS_NN__CONV2D) | MS_NN__TRANSPOSED)
#define MS_NN__WEIGHTED (MS_NN__BIT(MS_NN__DENSE) | MS_NN__CONVS)
#define MS_NN__POOLS                                                                        \
    (MS_NN__BIT(MS_NN__POOL1D) | MS_NN__BIT(MS_NN__POOL2D) | MS_NN__BIT(MS_NN__AVERAGE1D) | \
     MS_NN__BIT(MS_NN__AVERAGE2D))
#define MS_NN__UPSAMPLES (MS_NN__BIT(MS_NN__UPSAMPLE1D) | MS_NN__BIT(MS_NN__UPSAMPLE2D))
#define MS_NN__ACTIVATED (MS_NN__WEIGHTED | MS_NN__BIT(MS_NN__ACTIVATE) | MS_NN__BIT(MS_NN__ADD))

static const char *const ms_nn__kind_name[] = {
    "dense",     "conv1d",     "conv2d",     "upsample1d", "upsample2d",      "maxpool1d",        "maxpool2d",
    "flatten",   "activation", "dropout",    "add",        "shared_channels", "conv1d_transpose", "conv2d_transpose",
    "avgpool1d", "avgpool2d",  "globalpool", "concat"};
static const char *const ms_nn__activation_name[] = {"linear",  "relu",     "leaky_relu", "elu", "tanh",
                                                     "sigmoid", "softplus", "silu",       "gelu"};

static const ms_nn__field ms_nn__field_list[] = {
    {"type", MS_NN__TEXT, offsetof(ms_nn__spec, type), ~0u},
    {"name", MS_NN__TEXT, offsetof(ms_nn__spec, name), ~0u},
    {"activation", MS_NN__TEXT, offsetof(ms_nn__spec, activation), MS_NN__ACTIVATED},
    {"alpha", MS_NN__REAL, offsetof(ms_nn__spec, alpha), MS_NN__ACTIVATED},
    {"bias", MS_NN__FLAG, offsetof(ms_nn__spec, bias), MS_NN__WEIGHTED},
    {"units", MS_NN__COUNTS, offsetof(ms_nn__spec, units), MS_NN__BIT(MS_NN__DENSE)},
    {"filters", MS_NN__COUNTS, offsetof(ms_nn__spec, filters), MS_NN__CONVS},
    {"kernel", MS_NN__COUNTS, offsetof(ms_nn__spec, kernel), MS_NN__CONVS},
    {"padding", MS_NN__TEXT, offsetof(ms_nn__spec, padding), MS_NN__BIT(MS_NN__CONV1D) | MS_NN__BIT(MS_NN__CONV2D)},
    {"zeros", MS_NN__SIZES, offsetof(ms_nn__spec, zeros), MS_NN__CONVS},
    {"extra", MS_NN__SIZES, offsetof(ms_nn__spec, extra), MS_NN__TRANSPOSED},
    {"dilation", MS_NN__COUNTS, offsetof(ms_nn__spec, dilation), MS_NN__CONVS},
    {"groups", MS_NN__COUNTS, offsetof(ms_nn__spec, groups), MS_NN__CONVS},
    {"mode", MS_NN__TEXT, offsetof(ms_nn__spec, mode), MS_NN__UPSAMPLES},
    {"align_corners", MS_NN__FLAG, offsetof(ms_nn__spec, corners), MS_NN__UPSAMPLES},
    {"stride", MS_NN__COUNTS, offsetof(ms_nn__spec, stride), MS_NN__CONVS | MS_NN__POOLS},
    {"size", MS_NN__COUNTS, offsetof(ms_nn__spec, size), MS_NN__POOLS},
    {"factor", MS_NN__COUNTS, offsetof(ms_nn__spec, factor), MS_NN__UPSAMPLES},
    {"order", MS_NN__TEXT, offsetof(ms_nn__spec, order), MS_NN__BIT(MS_NN__FLATTEN) | MS_NN__BIT(MS_NN__CONCAT)},
    {"rate", MS_NN__REAL, offsetof(ms_nn__spec, rate), MS_NN__BIT(MS_NN__DROPOUT)},
    {"from", MS_NN__TEXT, offsetof(ms_nn__spec, from), MS_NN__BIT(MS_NN__ADD) | MS_NN__BIT(MS_NN__CONCAT)}};

static MS_NN__COLD int ms_nn__index_of(const char *const *names, int count, const char *name)
{
    int i;
    for (i = 0; i < count; ++i)
        if (name != NULL && strcmp(names[i], name) == 0) return i;
    return -1;
}

/* A JSON number as a double, within some units of its last place: enough for slopes and rates. */
static MS_NN__COLD ms_status ms_nn__json_real(ms_nn__json *j, double *value)
{
    int negative = ms_nn__take(j, '-'), exponent = 0, shift = 0, minus;
    const unsigned char *first;
    double v = 0;
    if (!negative) ms_nn__space(j);
    first = j->p;
    for (; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p)
        if (v < 1e300) v = v * 10 + (*j->p - '0');
        else ++shift;
    if (j->p == first || (*first == '0' && j->p > first + 1))
        return ms_nn__bad(j, "expected a number without leading zeros");
    if (j->p < j->end && *j->p == '.') {
        first = ++j->p;
        for (; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p)
            if (v < 1e300) v = v * 10 + (*j->p - '0'), --shift;
        if (j->p == first) return ms_nn__bad(j, "expected digits behind the point");
    }
    if (j->p < j->end && (*j->p == 'e' || *j->p == 'E')) {
        ++j->p;
        minus = j->p < j->end && *j->p == '-';
        if (j->p < j->end && (*j->p == '-' || *j->p == '+')) ++j->p;
        first = j->p;
        for (; j->p < j->end && *j->p >= '0' && *j->p <= '9'; ++j->p)
            if (exponent < 1000) exponent = exponent * 10 + (*j->p - '0');
        if (j->p == first) return ms_nn__bad(j, "expected the digits of an exponent");
        if (minus) exponent = -exponent;
    }
    if (v > 0 && log10(v) + exponent + shift > 308.2547)
        v = (double)ms_nn__float_of(0x7f800000u); /* without an exception */
    else if (v > 0) v *= pow(10.0, (double)exponent + (double)shift);
    *value = negative ? -v : v;
    return MS_OK;
}

/* n or [n] or [n, m] into out[2]; one number stands for both. */
static MS_NN__COLD ms_status ms_nn__json_counts(ms_nn__json *j, size_t out[2])
{
    ms_status status;
    int list = ms_nn__take(j, '['), more = 0;
    if ((status = ms_nn__json_size(j, &out[0])) != MS_OK) return status;
    out[1] = out[0];
    if (!list) return MS_OK;
    if ((status = ms_nn__json_more(j, ']', &more)) != MS_OK || !more) return status;
    if ((status = ms_nn__json_size(j, &out[1])) != MS_OK) return status;
    return ms_nn__take(j, ']') ? MS_OK : ms_nn__bad(j, "expected at most two numbers");
}

/* What the whole layer list becomes. A first pass counts (text, layers, indices), a second one stores. */
typedef struct ms_nn__list {
    char *pool; /* of all strings; NULL while counting */
    size_t text;
    int layers;
    ms_nn__spec *spec;     /* [layers], NULL while counting */
    ms_nn__kind *kind;     /* [layers] */
    size_t channels;       /* of shared_channels; 1 without */
    size_t channel_inputs; /* indices a channel */
    size_t *channel_input; /* [channels][channel_inputs], NULL while counting */
} ms_nn__list;

/* "inputs":[[0,3],[1,3],[2,3]]: lists of equal length, one a channel. */
static MS_NN__COLD ms_status ms_nn__list_channels(ms_nn__json *j, ms_nn__list *l)
{
    size_t channel, total = 0;
    int more = 1, inner;
    ms_status status;
    if (!ms_nn__take(j, '[')) return ms_nn__bad(j, "inputs must be a list of lists of indices");
    for (channel = 0; more; ++channel) {
        size_t n = 0, index;
        if (!ms_nn__take(j, '[')) return ms_nn__bad(j, "inputs must be a list of lists of indices");
        for (inner = 1; inner; ++n, ++total) {
            if ((status = ms_nn__json_size(j, &index)) != MS_OK) return status;
            if (l->channel_input) l->channel_input[total] = index;
            if ((status = ms_nn__json_more(j, ']', &inner)) != MS_OK) return status;
        }
        if (channel > 0 && n != l->channel_inputs) return ms_nn__bad(j, "the channels must have equally many inputs");
        l->channel_inputs = n;
        if ((status = ms_nn__json_more(j, ']', &more)) != MS_OK) return status;
    }
    l->channels = channel;
    return MS_OK;
}

/* One layer: the type decides which fields are known, so that fields are kept until it is. */
static MS_NN__COLD ms_status ms_nn__list_layer(ms_nn__json *j, ms_nn__list *l)
{
    enum { FIELDS = (int)(sizeof ms_nn__field_list / sizeof ms_nn__field_list[0]) };
    unsigned seen = 0;
    int more = 1, f, kind = -1, inputs = 0;
    ms_nn__spec spec;
    ms_status status;
    memset(&spec, 0, sizeof spec);
    spec.alpha = -1; /* not said */
    ms_nn__space(j);
    spec.at = (size_t)(j->p - j->start);
    if (!ms_nn__take(j, '{')) return ms_nn__bad(j, "a layer must be an object");
    if (ms_nn__take(j, '}')) more = 0;
    while (more) {
        ms_nn__string key, text;
        char *none = NULL, *at;
        const unsigned char *key_at;
        ms_nn__space(j);
        key_at = j->p;
        if ((status = ms_nn__json_string(j, &none, &key)) != MS_OK) return status;
        if (!ms_nn__take(j, ':')) return ms_nn__bad(j, "expected ':'");
        for (f = 0; f < FIELDS; ++f)
            if (ms_nn__is(&key, ms_nn__field_list[f].key)) break;
        if (f == FIELDS && ms_nn__is(&key, "inputs") && !inputs) {
            inputs = 1;
            if (l->layers > 0) return ms_nn__bad(j, "shared_channels must be the first layer");
            status = ms_nn__list_channels(j, l);
        } else {
            if (f == FIELDS) return ms_nn__bad_word(j, key_at, "unknown field '%s'", key.head);
            if (seen & 1u << f) return ms_nn__bad_word(j, key_at, "the field '%s' stands twice", key.head);
            seen |= 1u << f;
            at = (char *)&spec + ms_nn__field_list[f].offset;
            switch (ms_nn__field_list[f].kind) {
            case MS_NN__TEXT:
                ms_nn__space(j);
                key_at = j->p;
                status = ms_nn__json_string(j, &l->pool, &text);
                l->text += text.length + 1;
                memcpy(at, &text.text, sizeof text.text);
                if (f == 0)
                    for (kind = 0; kind < (int)MS_NN__KINDS; ++kind)
                        if (ms_nn__is(&text, ms_nn__kind_name[kind])) break;
                if (status == MS_OK && kind == (int)MS_NN__KINDS)
                    return ms_nn__bad_word(j, key_at, "unknown type '%s'", text.head);
                break;
            case MS_NN__COUNTS:
            case MS_NN__SIZES: {
                size_t counts[2] = {0, 0};
                status = ms_nn__json_counts(j, counts);
                if (status == MS_OK && (counts[0] > INT_MAX || counts[1] > INT_MAX))
                    return ms_nn__bad_word(j, key_at, "the size '%s' is too large", key.head);
                if (status == MS_OK && ms_nn__field_list[f].kind == MS_NN__COUNTS && (counts[0] == 0 || counts[1] == 0))
                    return ms_nn__bad_word(j, key_at, "the size '%s' must not be 0", key.head);
                memcpy(at, counts, sizeof counts);
                break;
            }
            case MS_NN__REAL: {
                double real = 0;
                status = ms_nn__json_real(j, &real);
                if (status == MS_OK && !(real >= 0 && real <= 1e30))
                    return ms_nn__bad_word(j, key_at, "'%s' must not be negative or above 1e30", key.head);
                memcpy(at, &real, sizeof real);
                break;
            }
            default: {
                int yes, flag;
                ms_nn__space(j);
                yes = j->end - j->p >= 4 && memcmp(j->p, "true", 4) == 0;
                flag = yes ? 1 : 2;
                if (!yes && !(j->end - j->p >= 5 && memcmp(j->p, "false", 5) == 0))
                    return ms_nn__bad(j, "expected true or false");
                j->p += yes ? 4 : 5;
                memcpy(at, &flag, sizeof flag);
            }
            }
        }
        if (status != MS_OK) return status;
        if ((status = ms_nn__json_more(j, '}', &more)) != MS_OK) return status;
    }
    if (kind < 0) return ms_nn__bad(j, "the layer has no type");
    for (f = 0; f < FIELDS; ++f)
        if ((seen & 1u << f) && !(ms_nn__field_list[f].layers & 1u << kind))
            return ms__fail(j->error, MS_BAD_DATA, j->base + spec.at,
                            "the field '%s' does not belong to a layer of type %s", ms_nn__field_list[f].key,
                            ms_nn__kind_name[kind]);
    if (inputs != (kind == (int)MS_NN__SHARED)) return ms_nn__bad(j, "inputs and shared_channels belong together");
    if (l->layers == MS_NN_MAX_LAYERS) return ms_nn__bad(j, "more than 4096 layers");
    if (l->spec) {
        l->spec[l->layers] = spec;
        l->kind[l->layers] = (ms_nn__kind)kind;
    }
    l->layers++;
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__list_read(ms_nn__list *l, const char *text, ms_error *error)
{
    ms_nn__json j;
    ms_error layer;
    int more = 1;
    ms_status status;
    j.start = j.p = (const unsigned char *)text;
    j.end = j.p + strlen(text);
    j.base = 0;
    j.error = error;
    if (!ms_nn__take(&j, '[')) return ms_nn__bad(&j, "ms_nn_layers must be a list");
    if (ms_nn__take(&j, ']')) more = 0;
    while (more) {
        if ((status = ms_nn__list_layer(&j, l)) != MS_OK) {
            ms__fail(&layer, MS_OK, 0, "layer %d", l->layers);
            return ms_nn__about(error, status, error ? error->position : 0, layer.message, "");
        }
        if ((status = ms_nn__json_more(&j, ']', &more)) != MS_OK) return status;
    }
    ms_nn__space(&j);
    return j.p == j.end ? MS_OK : ms_nn__bad(&j, "text follows the layer list");
}

static MS_NN__COLD ms_status ms_nn__shape_read(ms_nn_shape *shape, const char *text, ms_error *error)
{
    ms_nn__json j;
    int more = 1;
    size_t total = 1;
    ms_status status;
    memset(shape, 0, sizeof *shape);
    j.start = j.p = (const unsigned char *)text;
    j.end = j.p + strlen(text);
    j.base = 0;
    j.error = error;
    if (!ms_nn__take(&j, '[')) return ms_nn__bad(&j, "ms_nn_input must be a list of sizes");
    while (more) {
        if (shape->rank == 3) return ms_nn__bad(&j, "ms_nn_input has more than three sizes");
        if ((status = ms_nn__json_size(&j, &shape->size[shape->rank])) != MS_OK) return status;
        total = ms__size_mul(total, shape->size[shape->rank]);
        if (shape->size[shape->rank++] == 0 || total > SIZE_MAX / 64)
            return ms_nn__bad(&j, "a size in ms_nn_input is 0 or too large");
        if ((status = ms_nn__json_more(&j, ']', &more)) != MS_OK) return status;
    }
    ms_nn__space(&j);
    return j.p == j.end ? MS_OK : ms_nn__bad(&j, "text follows ms_nn_input");
}

/* ---- plan ------------------------------------------------------------------------------------------------------ */

/* channels x height x width; a signal has height 1, a vector height and width 1. */
typedef struct ms_nn__dims {
    size_t c, h, w;
} ms_nn__dims;

static size_t ms_nn__count(ms_nn__dims d) { return d.c * d.h * d.w; }

/* A dense layer's matrix where it lies. Rows are cols elements long without padding. One that a cache may hold is there
   once more, as the level in use likes it: in panels of two vectors of rows, [panel][column][row of the panel], zeros
   behind the last row. */
typedef struct ms_nn__matrix {
    const unsigned char *w, *scale, *bias; /* scale, bias: [rows] native floats, any alignment, or NULL */
    ms_nn_dtype dtype;                     /* F32, F16, BF16, I8 */
    size_t rows, cols;
    const unsigned char *packed; /* 64-byte aligned; NULL: not packed */
    ms_nn_dtype packed_dtype;
} ms_nn__matrix;

/* A correlation with its weights packed for the level in use: [block of outputs][in channel][tap][output of the block].
   Three rows high over many channels, it makes two rows at a time by Winograd's F(2, 3) (Lavin and Gray 2016) along the
   columns: the input holds four combined rows for each pair of output rows, the weights are [block][combination][in
   channel][tap of a row][output], and 4 instead of 6 multiplications are left. */
typedef struct ms_nn__conv {
    ms_nn__dims in, out;
    size_t kernel[2], stride[2], dilate[2]; /* dilate: the input's elements stand so far apart, zeros between */
    size_t spread[2];                       /* the taps stand so far apart */
    ptrdiff_t pad[2]; /* zeros above and left of the input; negative: rows and columns that are skipped */
    const float *packed;
    const float *bias;    /* [out.c rounded up to blocks], zeros where there is none */
    int pairs;            /* Winograd */
    size_t taps;          /* that a tile sums over */
    const size_t *offset; /* [taps] from an output's first padded element to the element that tap sees */
    size_t strip;         /* output rows of a task, whose input is padded together */
    size_t rows;          /* padded input rows of a strip */
    size_t pitch, plane;  /* floats of a padded row and channel; with stride s, columns 0, s, 2s... come first */
} ms_nn__conv;

typedef enum ms_nn__step {
    MS_NN__DO_DENSE,
    MS_NN__DO_CONV,
    MS_NN__DO_UPSAMPLE,
    MS_NN__DO_LINEAR,
    MS_NN__DO_POOL,
    MS_NN__DO_AVERAGE,
    MS_NN__DO_TRANSPOSE,
    MS_NN__DO_ACTIVATE,
    MS_NN__DO_ADD,
    MS_NN__DO_CONCAT
} ms_nn__step;

/* One operation. Operation k reads value k and makes value k + 1; value 0 is the input. */
typedef struct ms_nn__op {
    ms_nn__step step;
    ms_nn__activation activation;
    float alpha;
    ms_nn__dims in, out;
    int layer;                 /* in the file's list */
    int skip;                  /* ADD, CONCAT: the other value */
    int flag;                  /* CONCAT: the other one's channels come first; LINEAR: corners are aligned */
    size_t size[2], stride[2]; /* POOL; UPSAMPLE: size is the factor */
    ms_nn__matrix matrix;
    int phases;            /* CONV: 1, or the factor of an upsampling in front of it */
    size_t groups;         /* CONV: each from its own channels to its own */
    ms_nn__conv *forward;  /* [groups][phases]: phase p makes the outputs p, p + phases, ... of each row */
    ms_nn__conv *backward; /* [groups][phases]: from output gradients to input gradients */
} ms_nn__op;

/* Memory that belongs to a network: a list, released with it. */
typedef struct ms_nn__block {
    struct ms_nn__block *next;
    size_t bytes;
} ms_nn__block;

struct ms_nn {
    ms_nn_options options;
    ms_nn_file *file;
    ms_nn__block *blocks;
    const struct ms_nn__kernels *kernels;
    ms_simd level;
    int row_tiles;             /* F32 matrices come from memory several rows at a time */
    size_t packed;             /* weights that are packed */
    ms_nn_shape input, output; /* as the caller sees them */
    size_t channels, channel_inputs;
    const size_t *channel_input; /* [channels][channel_inputs]; channels 1 and NULL without shared_channels */
    ms_nn__dims inner;           /* what value 0 is */
    int layers, ops;
    ms_nn_layer *layer; /* [layers] */
    ms_nn__op *op;      /* [ops] */
    size_t *slot;       /* [ops + 1] floats from the start of the values of one sample, when values share memory */
    size_t *tape;       /* [ops + 1] the same when all values are kept */
    size_t *before;     /* [ops + 1] on the tape, what a smooth activation was applied to; SIZE_MAX: not kept */
    size_t *skip;       /* [ops + 1] place of the gradient that arrives through ADD; SIZE_MAX: none */
    size_t slots, tapes, skips; /* floats of one sample */
};

/* Memory held until the network goes; 64-byte aligned for the kernels' sake; NULL: none left. */
static void *ms_nn__hold(ms_nn *nn, size_t count, size_t size)
{
    size_t bytes = ms__size_add(ms__size_mul(count, size), sizeof(ms_nn__block) + 64);
    ms_nn__block *b = (ms_nn__block *)ms_nn__alloc(&nn->options, bytes);
    uintptr_t at;
    if (b == NULL) return NULL;
    b->next = nn->blocks;
    b->bytes = bytes;
    nn->blocks = b;
    at = ((uintptr_t)(b + 1) + 63) & ~(uintptr_t)63;
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

/* Tensor <layer>.<part> with the expected shape (0: any size but 0); *tensor NULL if it is absent and may be. */
static MS_NN__COLD ms_status ms_nn__tensor(const ms_nn *nn, const char *layer, const char *part, int rank,
                                           const size_t *shape, int required, const ms_nn_tensor **tensor,
                                           ms_error *error)
{
    char name[256];
    size_t n = strlen(layer), m = strlen(part);
    int d;
    *tensor = NULL;
    if (n + m + 2 > sizeof name) return ms__fail(error, MS_BAD_DATA, 0, "the name of layer '%s' is too long", layer);
    memcpy(name, layer, n);
    name[n] = '.';
    memcpy(name + n + 1, part, m + 1);
    *tensor = ms_nn_file_find(nn->file, name);
    if (*tensor == NULL) return required ? ms__fail(error, MS_BAD_DATA, 0, "the tensor '%s' is missing", name) : MS_OK;
    if ((*tensor)->rank != rank)
        return ms__fail(error, MS_BAD_DATA, 0, "the tensor '%s' must have %d dimensions", name, rank);
    for (d = 0; d < rank; ++d)
        if ((*tensor)->shape[d] == 0 || (shape[d] != 0 && (*tensor)->shape[d] != shape[d]))
            return ms__fail(error, MS_BAD_DATA, 0, "dimension %d of '%s' is %z, the layer list makes it %z", d, name,
                            (*tensor)->shape[d], shape[d]);
    return MS_OK;
}

/* A tensor as native floats: where it lies if it is that already, else a copy. */
static const unsigned char *ms_nn__floats(ms_nn *nn, const ms_nn_tensor *t)
{
    size_t count = t->bytes / (size_t)(ms_nn__bits(t->dtype) / 8), i;
    float *copy;
    if (t->dtype == MS_NN_F32 && !MS_NN__BIG_ENDIAN) return (const unsigned char *)t->data;
    copy = (float *)ms_nn__hold(nn, count, sizeof(float));
    for (i = 0; copy && i < count; ++i) copy[i] = ms_nn__narrow(ms_nn__element(t->data, t->dtype, i));
    return (const unsigned char *)copy;
}

/* The weights of a layer; sizes that the layer list leaves open (0 in shape) are read from the tensor. turned: groups
   of a transposed convolution, whose outputs are the second dimension; 0: the first. */
typedef struct ms_nn__weights {
    const ms_nn_tensor *weight, *bias, *scale;
} ms_nn__weights;

static MS_NN__COLD ms_status ms_nn__weights_find(ms_nn *nn, const ms_nn__spec *spec, int rank, size_t *shape,
                                                 size_t turned, ms_nn_layer *info, ms_nn__weights *w, ms_error *error)
{
    const ms_nn_tensor *part[3];
    ms_status status;
    int i;
    size_t macs = 1, outs;
    if (spec->name == NULL) return ms__fail(error, MS_BAD_DATA, 0, "it has no name");
    if ((status = ms_nn__tensor(nn, spec->name, "weight", rank, shape, 1, &w->weight, error)) != MS_OK) return status;
    for (i = 0; i < rank; ++i) shape[i] = w->weight->shape[i];
    outs = turned ? ms__size_mul(shape[1], turned) : shape[0];
    if ((status = ms_nn__tensor(nn, spec->name, "bias", 1, &outs, spec->bias != 2, &w->bias, error)) != MS_OK)
        return status;
    if ((status = ms_nn__tensor(nn, spec->name, "weight_scale", 1, shape, w->weight->dtype == MS_NN_I8, &w->scale,
                                error)) != MS_OK)
        return status;
    if (spec->bias == 2 && w->bias)
        return ms__fail(error, MS_BAD_DATA, 0, "layer '%s' says bias false but has one", spec->name);
    if (w->scale && w->weight->dtype != MS_NN_I8)
        return ms__fail(error, MS_BAD_DATA, 0, "'%s.weight_scale' belongs to I8 weights only", spec->name);
    part[0] = w->weight;
    part[1] = w->bias;
    part[2] = w->scale;
    for (i = 0; i < 3; ++i) {
        if (part[i] == NULL) continue;
        if ((int)part[i]->dtype > (i == 0 ? (int)MS_NN_I8 : (int)MS_NN_BF16))
            return ms__fail(error, MS_UNSUPPORTED, 0, "the tensor '%s' has element type %s", part[i]->name,
                            ms_nn__dtype_name((int)part[i]->dtype));
        info->bytes += part[i]->bytes;
        if (i < 2) info->parameters += part[i]->bytes / (size_t)(ms_nn__bits(part[i]->dtype) / 8);
    }
    for (i = 0; i < rank; ++i) macs = ms__size_mul(macs, shape[i]);
    info->multiply_adds = macs;
    info->dtype = w->weight->dtype;
    return MS_OK;
}

/* Element (row-major index i, in output row) of a weight, its scale applied. */
static double ms_nn__weight_at(const ms_nn__weights *w, size_t row, size_t i)
{
    double x = ms_nn__element(w->weight->data, w->weight->dtype, i);
    return w->scale ? x * ms_nn__element(w->scale->data, w->scale->dtype, row) : x;
}

static int ms_nn__pack_dense(ms_nn *nn, ms_nn__matrix *m);

/* Dense weights where they lie, small ones packed too; F64 as a float copy; on big-endian hosts F32 as a copy in native
   order (the scalar kernels, which are all that those have, read the other types byte by byte). With fold > 1 the
   columns of the fold_h x fold_w positions that one low-resolution element was copied to are added up (in double,
   rounded once): W u(x) = (W U) x. low: the shape before the upsampling; last: channels run fastest. */
static MS_NN__COLD ms_status ms_nn__dense_make(ms_nn *nn, ms_nn__op *op, const ms_nn__weights *w, const size_t fold[2],
                                               ms_nn__dims low, int last, ms_error *error)
{
    ms_nn__matrix *m = &op->matrix;
    size_t rows = w->weight->shape[0], cols = w->weight->shape[1], folds = fold[0] * fold[1], r, c, y, x, i;
    m->rows = rows;
    m->cols = cols / folds;
    m->dtype = w->weight->dtype;
    m->w = (const unsigned char *)w->weight->data;
    m->scale = m->bias = NULL;
    if (folds > 1 || m->dtype == MS_NN_F64) {
        float *copy = (float *)ms_nn__hold(nn, ms__size_mul(rows, m->cols), sizeof(float));
        if (copy == NULL)
            return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the weights of '%s'", w->weight->name);
        m->w = (const unsigned char *)copy;
        m->dtype = MS_NN_F32;
        for (r = 0; r < rows; ++r) {
            const unsigned char *row = (const unsigned char *)w->weight->data +
                r * cols * (size_t)(ms_nn__bits(w->weight->dtype) / 8);
            for (i = 0; i < low.h * low.w; ++i) {
                size_t at = i / low.w * fold[0] * low.w * fold[1] + i % low.w * fold[1]; /* its first copy */
                for (c = 0; c < low.c; ++c) {
                    double sum = 0;
                    for (y = 0; y < fold[0]; ++y)
                        for (x = 0; x < fold[1]; ++x) {
                            size_t pixel = at + y * low.w * fold[1] + x;
                            size_t col = last ? pixel * low.c + c : c * low.h * low.w * folds + pixel;
                            sum += w->weight->dtype == MS_NN_F32 ? (double)ms_nn__float_of(ms_nn__u32(row + 4 * col))
                                                                 : ms_nn__element(row, MS_NN_F64, col);
                        }
                    copy[last ? i * low.c + c : c * low.h * low.w + i] = ms_nn__narrow(sum);
                }
            }
            copy += m->cols;
        }
    } else if (m->dtype == MS_NN_F32 && (m->w = ms_nn__floats(nn, w->weight)) == NULL) {
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the weights of '%s'", w->weight->name);
    }
    if (w->bias && (m->bias = ms_nn__floats(nn, w->bias)) == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a bias");
    if (w->scale && (m->scale = ms_nn__floats(nn, w->scale)) == NULL)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for scales");
    if (!ms_nn__pack_dense(nn, m))
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the weights of '%s'", w->weight->name);
    return MS_OK;
}

/* ceil(a / b) and floor(a / b) for b > 0. */
static ptrdiff_t ms_nn__floor_div(ptrdiff_t a, ptrdiff_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/* Packs weight(o, c, t) into blocks; block is the level's. at() gives the weight. */
typedef struct ms_nn__taps {
    const ms_nn__weights *w;
    size_t outs, ins, height, width; /* of the tensor */
    size_t factor, phase;            /* of the upsampling before it; 1, 0 without */
    ptrdiff_t pad;                   /* left, in upsampled columns */
    ptrdiff_t first;                 /* first input column, relative to the output column, that this phase sees */
    int backward;                    /* outputs and inputs exchanged, taps reversed */
    size_t taps_w;                   /* width of the folded kernel */
    size_t group;                    /* outs and ins are those of a group */
} ms_nn__taps;

/* Folded weight: output column f i + p of a correlation with kernel w over an f-fold upsampled row sees the input
   columns i + floor((p + k - pad) / f); taps that see the same column are added. */
static double ms_nn__tap(const ms_nn__taps *t, size_t o, size_t c, size_t y, size_t x)
{
    size_t oo = t->backward ? c : o, cc = t->backward ? o : c, yy = t->backward ? t->height - 1 - y : y;
    size_t xx = t->backward ? t->taps_w - 1 - x : x, k;
    double sum = 0;
    oo += t->group * t->outs;
    if (t->factor == 1) return ms_nn__weight_at(t->w, oo, ((oo * t->ins + cc) * t->height + yy) * t->width + xx);
    for (k = 0; k < t->width; ++k)
        if (ms_nn__floor_div((ptrdiff_t)t->phase + (ptrdiff_t)k - t->pad, (ptrdiff_t)t->factor) - t->first ==
            (ptrdiff_t)xx)
            sum += ms_nn__weight_at(t->w, oo, ((oo * t->ins + cc) * t->height + yy) * t->width + k);
    return sum;
}

#define MS_NN__STRIP_FLOATS 65536u /* of padded input, which a strip should not exceed, to stay in a cache */

/* Geometry of the padded input of a strip: as many rows and columns as its outputs see. */
static MS_NN__COLD int ms_nn__conv_geometry(ms_nn *nn, ms_nn__conv *v)
{
    size_t s = v->stride[1], w = (v->out.w - 1) * s + (v->kernel[1] - 1) * v->spread[1] + 1,
           rows = v->pairs ? 1 : v->kernel[0], fit, y, x;
    size_t high = (v->kernel[0] - 1) * v->spread[0] + 1;
    size_t *offset = (size_t *)ms_nn__hold(nn, ms__size_mul(rows, v->kernel[1]), sizeof(size_t));
    v->pitch = v->out.w == 0 ? 0 : (w + s - 1) / s * s; /* 0: a phase without outputs */
    fit = MS_NN__STRIP_FLOATS / (v->in.c * v->pitch + 1);
    v->strip = v->pairs ? fit / 4 * 2 : fit > high ? (fit - high) / v->stride[0] + 1 : 1;
    if (v->pairs && v->strip < 2) v->strip = 2;
    if (v->strip > v->out.h) v->strip = v->pairs ? (v->out.h + 1) / 2 * 2 : v->out.h;
    v->rows = v->pairs ? 2 * v->strip : (v->strip - 1) * v->stride[0] + high;
    v->plane = v->rows * v->pitch;
    v->taps = rows * v->kernel[1];
    v->offset = offset;
    for (y = 0; offset && y < rows; ++y)
        for (x = 0; x < v->kernel[1]; ++x)
            *offset++ = y * v->spread[0] * v->pitch + x * v->spread[1] % s * (v->pitch / s) + x * v->spread[1] / s;
    return offset != NULL;
}

static const float *ms_nn__pack(ms_nn *nn, const ms_nn__taps *t, size_t outs, size_t ins, size_t block)
{
    size_t blocks = (outs + block - 1) / block, taps = t->height * t->taps_w, b, c, k, o;
    float *packed = (float *)ms_nn__hold(nn, ms__size_mul(ms__size_mul(blocks, block), ms__size_mul(ins, taps)),
                                         sizeof(float));
    float *p = packed;
    if (packed == NULL) return NULL;
    for (b = 0; b < blocks; ++b)
        for (c = 0; c < ins; ++c)
            for (k = 0; k < taps; ++k)
                for (o = b * block; o < (b + 1) * block; ++o)
                    *p++ = o < outs ? (float)ms_nn__tap(t, o, c, k / t->taps_w, k % t->taps_w) : 0.0f;
    return packed;
}

/* Winograd's weights: g0, (g0 + g1 + g2) / 2, (g0 - g1 + g2) / 2, g2 of each column of three. */
static const float *ms_nn__pack_pairs(ms_nn *nn, const ms_nn__taps *t, size_t outs, size_t ins, size_t block)
{
    size_t blocks = (outs + block - 1) / block, part = ins * t->taps_w * block, b, c, x, o;
    float *packed = (float *)ms_nn__hold(nn, ms__size_mul(blocks * 4, part), sizeof(float));
    if (packed == NULL) return NULL;
    for (b = 0; b < blocks; ++b)
        for (c = 0; c < ins; ++c)
            for (x = 0; x < t->taps_w; ++x)
                for (o = 0; o < block; ++o) {
                    float *p = packed + b * 4 * part + (c * t->taps_w + x) * block + o;
                    int used = b * block + o < outs;
                    double g0 = used ? ms_nn__tap(t, b * block + o, c, 0, x) : 0,
                           g1 = used ? ms_nn__tap(t, b * block + o, c, 1, x) : 0;
                    double g2 = used ? ms_nn__tap(t, b * block + o, c, 2, x) : 0;
                    p[0] = (float)g0;
                    p[part] = (float)((g0 + g1 + g2) / 2);
                    p[2 * part] = (float)((g0 - g1 + g2) / 2);
                    p[3 * part] = (float)g2;
                }
    return packed;
}

/* Is Winograd's form worth it? */
static MS_NN__COLD int ms_nn__in_pairs(const ms_nn__conv *v)
{
    return v->kernel[0] == 3 && v->stride[0] == 1 && v->dilate[0] == 1 && v->spread[0] == 1 && v->in.c >= 8 &&
        v->out.h >= 2;
}

/* The convolutions of an operation, forward and backward, one pair a phase. op->in is the shape before the
   upsampling by factor that is folded in (1: none). */
static MS_NN__COLD ms_status ms_nn__conv_make(ms_nn *nn, ms_nn__op *op, const ms_nn__weights *w, const size_t kernel[2],
                                              const size_t stride[2], const size_t pad[2], const size_t spread[2],
                                              size_t factor, size_t block, ms_error *error)
{
    size_t p, g, outs = op->out.c / op->groups, ins = op->in.c / op->groups,
                 blocks = (outs + block - 1) / block * block, o, n;
    float *bias = (float *)ms_nn__hold(nn, ms__size_mul(op->groups, blocks), sizeof(float));
    float *zeros = (float *)ms_nn__hold(nn, ms__size_add(op->in.c, block), sizeof(float));
    op->phases = (int)factor;
    op->forward = (ms_nn__conv *)ms_nn__hold(nn, ms__size_mul(op->groups, factor), sizeof(ms_nn__conv));
    op->backward = (ms_nn__conv *)ms_nn__hold(nn, ms__size_mul(op->groups, factor), sizeof(ms_nn__conv));
    if (!bias || !zeros || !op->forward || !op->backward)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a convolution");
    for (g = 0; g < op->groups; ++g)
        for (o = 0; o < blocks; ++o)
            bias[g * blocks + o] = w->bias && o < outs
                ? ms_nn__narrow(ms_nn__element(w->bias->data, w->bias->dtype, g * outs + o))
                : 0.0f;
    for (o = 0; o < op->in.c + block; ++o) zeros[o] = 0;
    for (n = 0; n < op->groups * factor; ++n) {
        ms_nn__conv *f = &op->forward[n], *b = &op->backward[n];
        ms_nn__taps t;
        p = n % factor;
        t.w = w;
        t.outs = outs;
        t.ins = ins;
        t.group = n / factor;
        t.height = kernel[0];
        t.width = kernel[1];
        t.factor = factor;
        t.phase = p;
        t.pad = (ptrdiff_t)pad[1];
        t.first = ms_nn__floor_div((ptrdiff_t)p - t.pad, (ptrdiff_t)factor);
        t.taps_w = (size_t)(ms_nn__floor_div((ptrdiff_t)(p + kernel[1] - 1) - t.pad, (ptrdiff_t)factor) - t.first + 1);
        t.backward = 0;
        memset(f, 0, sizeof *f);
        f->in = op->in;
        f->in.c = ins;
        f->out = op->out;
        f->out.c = outs;
        f->spread[0] = spread[0];
        f->spread[1] = spread[1];
        f->out.w = (op->out.w + factor - 1 - p) / factor;
        f->kernel[0] = kernel[0];
        f->kernel[1] = t.taps_w;
        f->stride[0] = stride[0];
        f->stride[1] = stride[1];
        f->dilate[0] = f->dilate[1] = 1;
        f->pad[0] = (ptrdiff_t)pad[0];
        f->pad[1] = -t.first;
        f->bias = bias + n / factor * blocks;
        f->pairs = ms_nn__in_pairs(f);
        f->packed = (f->pairs ? ms_nn__pack_pairs : ms_nn__pack)(nn, &t, outs, ins, block);
        /* d/dx of a correlation: the full correlation of the gradient, zeros between its elements where the stride
           is over 1, with the mirrored kernel */
        memset(b, 0, sizeof *b);
        b->in = f->out;
        b->dilate[0] = stride[0];
        b->dilate[1] = stride[1];
        b->out = op->in;
        b->out.c = ins;
        b->spread[0] = spread[0];
        b->spread[1] = spread[1];
        b->kernel[0] = f->kernel[0];
        b->kernel[1] = f->kernel[1];
        b->stride[0] = b->stride[1] = 1;
        b->pad[0] = (ptrdiff_t)((f->kernel[0] - 1) * spread[0]) - f->pad[0];
        b->pad[1] = (ptrdiff_t)((f->kernel[1] - 1) * spread[1]) - f->pad[1];
        t.backward = 1;
        b->pairs = ms_nn__in_pairs(b);
        b->packed = (b->pairs ? ms_nn__pack_pairs : ms_nn__pack)(nn, &t, ins, outs, block);
        b->bias = zeros;
        if (!f->packed || !b->packed || !ms_nn__conv_geometry(nn, f) || !ms_nn__conv_geometry(nn, b))
            return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a convolution");
    }
    return MS_OK;
}

/* Where the builder stands in the layer list. */
typedef struct ms_nn__build {
    ms_nn *nn;
    const ms_nn__list *list;
    int *value;      /* [layers] value that holds a layer's output */
    ms_nn__dims now; /* of the current layer's output, */
    int rank;
    ms_nn__dims low; /* of the last value, which an upsampling that is being folded has not blown up */
    size_t fold[2];  /* its factors; 1, 1: nothing is being folded */
    int last;        /* after a flatten: channels run fastest */
    size_t block;    /* outputs of a convolution's block, by level */
} ms_nn__build;

static MS_NN__COLD ms_nn__op *ms_nn__op_add(ms_nn__build *b, ms_nn__step step, int layer, ms_nn__dims out)
{
    ms_nn__op *op = &b->nn->op[b->nn->ops++];
    memset(op, 0, sizeof *op);
    op->step = step;
    op->layer = layer;
    op->in = b->low;
    op->out = b->low = out;
    return op;
}

static MS_NN__COLD ms_status ms_nn__activation_read(const ms_nn__spec *spec, ms_nn__op *op, ms_nn_layer *info,
                                                    ms_error *error)
{
    int a = spec->activation == NULL ? 0
        : strcmp(spec->activation, "leaky") == 0
        ? (int)MS_NN__LEAKY
        : ms_nn__index_of(ms_nn__activation_name, MS_NN__ACTIVATIONS, spec->activation);
    if (a < 0) return ms__fail(error, MS_BAD_DATA, 0, "unknown activation '%s'", spec->activation);
    op->activation = (ms_nn__activation)a;
    op->alpha = (float)(spec->alpha >= 0 ? spec->alpha : a == (int)MS_NN__LEAKY ? 0.01 : 1.0);
    info->activation = ms_nn__activation_name[a];
    return MS_OK;
}

/* The next layer that does something, or the end. */
static MS_NN__COLD int ms_nn__next(const ms_nn__list *l, int i)
{
    for (++i; i < l->layers && l->kind[i] == MS_NN__DROPOUT;) ++i;
    return i;
}

/* Can the upsampling at layer i go into the weights behind it? */
static MS_NN__COLD int ms_nn__foldable(const ms_nn__build *b, int i)
{
    const ms_nn__list *l = b->list;
    const ms_nn__spec *s = l->spec;
    int next = ms_nn__next(l, i), k;
    if (s[i].mode && strcmp(s[i].mode, "nearest")) return 0;
    if (b->nn->options.no_folds || s[i].factor[0] * s[i].factor[1] > 16 || next == l->layers) return 0;
    for (k = i; k < l->layers; ++k)
        if ((l->kind[k] == MS_NN__ADD || l->kind[k] == MS_NN__CONCAT) && s[k].from && s[i].name &&
            strcmp(s[k].from, s[i].name) == 0)
            return 0;
    if (l->kind[next] == MS_NN__CONV1D)
        return s[next].stride[0] <= 1 && s[next].dilation[0] <= 1 && s[next].groups[0] <= 1 &&
            l->kind[i] == MS_NN__UPSAMPLE1D;
    if (l->kind[next] != MS_NN__FLATTEN) return 0;
    for (k = i + 1; k < next; ++k)
        if (s[k].name) return 0;
    k = ms_nn__next(l, next);
    if (s[next].name || k == l->layers || l->kind[k] != MS_NN__DENSE || s[k].name == NULL) return 0;
    {
        const ms_nn_tensor *t;
        ms_nn__tensor(b->nn, s[k].name, "weight", -1, NULL, 0, &t, NULL);
        return t == NULL || t->dtype <= MS_NN_F32;
    }
}

static MS_NN__COLD ms_status ms_nn__build_dense(ms_nn__build *b, int i, ms_nn_layer *info, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    ms_nn__weights w;
    ms_nn__dims low = b->low, out;
    ms_nn__op *op;
    size_t shape[2];
    ms_status status;
    if (b->rank != 1) return ms__fail(error, MS_BAD_DATA, 0, "it needs a vector: put a flatten before it");
    shape[0] = s->units[0];
    shape[1] = b->now.c;
    if ((status = ms_nn__weights_find(b->nn, s, 2, shape, 0, info, &w, error)) != MS_OK) return status;
    out.c = shape[0];
    out.h = out.w = 1;
    op = ms_nn__op_add(b, MS_NN__DO_DENSE, i, out);
    if ((status = ms_nn__activation_read(s, op, info, error)) != MS_OK) return status;
    status = ms_nn__dense_make(b->nn, op, &w, b->fold, low, b->last, error);
    info->folded = b->fold[0] * b->fold[1] > 1;
    b->fold[0] = b->fold[1] = 1;
    b->now = out;
    return status;
}

/* Convolutions, and their transposes: a transpose runs as the gradient of the convolution from its outputs to its
   inputs, to which its weights [inputs][outputs / groups][height][width] belong. */
static MS_NN__COLD ms_status ms_nn__build_conv(ms_nn__build *b, int i, ms_nn_layer *info, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    ms_nn__kind kind = b->list->kind[i];
    int two = kind == MS_NN__CONV2D || kind == MS_NN__TRANSPOSED2D,
        turned = kind == MS_NN__TRANSPOSED1D || kind == MS_NN__TRANSPOSED2D, same, d;
    size_t shape[4], kernel[2], stride[2], pad[2], spread[2], extent[2], reach,
        groups = s->groups[0] ? s->groups[0] : 1, n;
    ms_nn__weights w;
    ms_nn__dims out, in;
    ms_nn__op *op;
    ms_status status;
    if (b->rank != (two ? 3 : 2))
        return ms__fail(error, MS_BAD_DATA, 0, two ? "it needs channels, height, width" : "it needs channels, length");
    if (s->padding && strcmp(s->padding, "same") && strcmp(s->padding, "valid"))
        return ms__fail(error, MS_BAD_DATA, 0, "padding must be same or valid, not '%s'", s->padding);
    same = s->padding && s->padding[0] == 's';
    if (same && (s->zeros[0] || s->zeros[1]))
        return ms__fail(error, MS_BAD_DATA, 0, "padding same and zeros exclude each other");
    if (b->now.c % groups || s->filters[0] % groups)
        return ms__fail(error, MS_BAD_DATA, 0, "its channels do not divide into %z groups", groups);
    shape[0] = turned ? b->now.c : s->filters[0];
    shape[1] = turned ? s->filters[0] / groups : b->now.c / groups;
    shape[2] = s->kernel[0];
    shape[3] = s->kernel[1];
    if ((status = ms_nn__weights_find(b->nn, s, two ? 4 : 3, shape, turned ? groups : 0, info, &w, error)) != MS_OK)
        return status;
    out.c = turned ? ms__size_mul(shape[1], groups) : shape[0];
    if (out.c % groups) return ms__fail(error, MS_BAD_DATA, 0, "its channels do not divide into %z groups", groups);
    extent[0] = b->now.h;
    extent[1] = b->now.w;
    for (d = 0; d < 2; ++d) {
        int on = two || d == 1, at = two ? d : 0;
        kernel[d] = on ? shape[two ? 2 + d : 2] : 1;
        stride[d] = on && s->stride[at] ? s->stride[at] : 1;
        spread[d] = on && s->dilation[at] ? s->dilation[at] : 1;
        reach = ms__size_add(ms__size_mul(kernel[d] - 1, spread[d]), 1);
        pad[d] = !on ? 0 : same ? (reach - 1) / 2 : s->zeros[at];
        if (reach > INT_MAX || extent[d] > INT_MAX)
            return ms__fail(error, MS_BAD_DATA, 0, "its kernel or input is too large");
        if (turned) {
            n = ms__size_add(ms__size_mul(extent[d] - 1, stride[d]), reach);
            if (on && s->extra[at] >= stride[d] && s->extra[at] >= spread[d])
                return ms__fail(error, MS_BAD_DATA, 0, "extra must be smaller than the stride or the dilation");
            if (on) n = ms__size_add(n, s->extra[at]);
            if (n <= 2 * pad[d] || n > INT_MAX)
                return ms__fail(error, MS_BAD_DATA, 0, "its output is empty or too large");
            extent[d] = n - 2 * pad[d];
        } else {
            n = same ? extent[d] - 1 : extent[d] + 2 * pad[d];
            if (!same && n < reach)
                return ms__fail(error, MS_BAD_DATA, 0, "its kernel has %z, its input only %z", reach, n);
            extent[d] = (same ? n : n - reach) / stride[d] + 1;
        }
    }
    out.h = extent[0];
    out.w = extent[1];
    if (ms__size_mul(ms__size_mul(out.c, out.h), out.w) > SIZE_MAX / 64)
        return ms__fail(error, MS_BAD_DATA, 0, "its output is too large");
    in = b->low;
    op = ms_nn__op_add(b, MS_NN__DO_CONV, i, out);
    op->groups = groups;
    if ((status = ms_nn__activation_read(s, op, info, error)) != MS_OK) return status;
    if (turned) {
        ms_nn__weights plain = w;
        float *bias;
        size_t block = b->block, own = out.c / groups, g, o;
        ms_nn__conv *forward;
        op->in = out;
        op->out = in;
        plain.bias = NULL;
        status = ms_nn__conv_make(b->nn, op, &plain, kernel, stride, pad, spread, 1, block, error);
        op->in = in;
        op->out = out;
        forward = op->backward;
        op->backward = op->forward;
        op->forward = forward;
        block = (own + block - 1) / block * block;
        bias = (float *)ms_nn__hold(b->nn, ms__size_mul(groups, block), sizeof(float));
        if (status == MS_OK && bias == NULL)
            status = ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a convolution");
        for (g = 0; status == MS_OK && g < groups; ++g) {
            for (o = 0; o < block; ++o)
                bias[g * block + o] = w.bias && o < own
                    ? ms_nn__narrow(ms_nn__element(w.bias->data, w.bias->dtype, g * own + o))
                    : 0.0f;
            forward[g].bias = bias + g * block;
        }
        n = in.h * in.w;
    } else {
        status = ms_nn__conv_make(b->nn, op, &w, kernel, stride, pad, spread, b->fold[1], b->block, error);
        n = out.h * out.w;
    }
    info->multiply_adds = ms__size_mul(info->multiply_adds, n);
    info->folded = b->fold[1] > 1;
    b->fold[0] = b->fold[1] = 1;
    b->now = out;
    return status;
}

static MS_NN__COLD ms_status ms_nn__build_resize(ms_nn__build *b, int i, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    ms_nn__kind kind = b->list->kind[i];
    int two = kind == MS_NN__UPSAMPLE2D || kind == MS_NN__POOL2D || kind == MS_NN__AVERAGE2D, smooth = 0,
        up = kind == MS_NN__UPSAMPLE1D || kind == MS_NN__UPSAMPLE2D, d;
    const size_t *given = up ? s->factor : s->size;
    size_t size[2], stride[2], extent[2];
    ms_nn__dims out = b->now;
    ms_nn__op *op;
    if (b->rank != (two ? 3 : 2))
        return ms__fail(error, MS_BAD_DATA, 0, two ? "it needs channels, height, width" : "it needs channels, length");
    for (d = 0; d < 2; ++d) {
        int on = two || d == 1;
        size[d] = !on ? 1 : given[two ? d : 0] ? given[two ? d : 0] : 2;
        stride[d] = !on ? 1 : s->stride[two ? d : 0] ? s->stride[two ? d : 0] : size[d];
        extent[d] = d == 0 ? b->now.h : b->now.w;
        if (up) extent[d] = ms__size_mul(extent[d], size[d]);
        else if (extent[d] < size[d])
            return ms__fail(error, MS_BAD_DATA, 0, "it takes %z, its input has only %z", size[d], extent[d]);
        else extent[d] = (extent[d] - size[d]) / stride[d] + 1;
    }
    out.h = extent[0];
    out.w = extent[1];
    if (ms__size_mul(ms__size_mul(out.c, out.h), out.w) > SIZE_MAX / 64)
        return ms__fail(error, MS_BAD_DATA, 0, "its output is too large");
    b->now = out;
    if (up && s->mode && strcmp(s->mode, "nearest")) {
        if (strcmp(s->mode, "linear"))
            return ms__fail(error, MS_BAD_DATA, 0, "mode must be nearest or linear, not '%s'", s->mode);
        smooth = 1;
    } else if (up && s->corners == 1) {
        return ms__fail(error, MS_BAD_DATA, 0, "align_corners belongs to mode linear");
    }
    if (up && ms_nn__foldable(b, i)) {
        b->fold[0] = size[0];
        b->fold[1] = size[1];
        return MS_OK;
    }
    op = ms_nn__op_add(b,
                       smooth                                                     ? MS_NN__DO_LINEAR
                           : up                                                   ? MS_NN__DO_UPSAMPLE
                           : kind == MS_NN__AVERAGE1D || kind == MS_NN__AVERAGE2D ? MS_NN__DO_AVERAGE
                                                                                  : MS_NN__DO_POOL,
                       i, out);
    op->flag = s->corners == 1;
    op->size[0] = size[0];
    op->size[1] = size[1];
    op->stride[0] = stride[0];
    op->stride[1] = stride[1];
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_flatten(ms_nn__build *b, int i, ms_error *error)
{
    const char *order = b->list->spec[i].order;
    int last = order != NULL && strcmp(order, "channels_last") == 0;
    if (order != NULL && !last && strcmp(order, "channels_first"))
        return ms__fail(error, MS_BAD_DATA, 0, "flatten order must be channels_first or channels_last, not '%s'",
                        order);
    if (last && b->low.c > 1 && b->low.h * b->low.w > 1) ms_nn__op_add(b, MS_NN__DO_TRANSPOSE, i, b->low);
    b->last = last;
    b->now.c = ms_nn__count(b->now);
    b->now.h = b->now.w = 1;
    b->rank = 1;
    return MS_OK;
}

/* The mean of every channel. */
static MS_NN__COLD ms_status ms_nn__build_global(ms_nn__build *b, int i, ms_error *error)
{
    ms_nn__op *op;
    ms_nn__dims out = b->now;
    if (b->rank < 2) return ms__fail(error, MS_BAD_DATA, 0, "it needs channels");
    out.h = out.w = 1;
    op = ms_nn__op_add(b, MS_NN__DO_AVERAGE, i, out);
    op->size[0] = op->stride[0] = op->in.h;
    op->size[1] = op->stride[1] = op->in.w;
    b->now = out;
    return MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_join(ms_nn__build *b, int i, ms_nn_layer *info, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    const char *verb = b->list->kind[i] == MS_NN__ADD ? "adds" : "takes";
    int add = b->list->kind[i] == MS_NN__ADD, k, from = -1, before = s->order && strcmp(s->order, "before") == 0;
    ms_nn__op *op;
    ms_nn__dims out, other;
    if (s->from && strcmp(s->from, "input") == 0) from = 0;
    for (k = 0; k < i; ++k)
        if (s->from && b->list->spec[k].name && strcmp(s->from, b->list->spec[k].name) == 0) from = b->value[k];
    if (from < 0)
        return ms__fail(error, MS_BAD_DATA, 0, "it %s '%s', which no layer before it is named", verb,
                        s->from ? s->from : "");
    other = from == 0 ? b->nn->inner : b->nn->op[from - 1].out;
    out = b->now;
    if (add ? ms_nn__count(other) != ms_nn__count(out) || (b->rank > 1 && (other.c != out.c || other.h != out.h))
            : other.h * other.w != out.h * out.w || (b->rank > 1 && other.h != out.h))
        return ms__fail(error, MS_BAD_DATA, 0, "it %s '%s', which has another shape", verb, s->from);
    if (!add && s->order && !before && strcmp(s->order, "after"))
        return ms__fail(error, MS_BAD_DATA, 0, "order must be after or before, not '%s'", s->order);
    if (!add) out.c = ms__size_add(out.c, other.c);
    if (ms__size_mul(ms__size_mul(out.c, out.h), out.w) > SIZE_MAX / 64)
        return ms__fail(error, MS_BAD_DATA, 0, "its output is too large");
    op = ms_nn__op_add(b, add ? MS_NN__DO_ADD : MS_NN__DO_CONCAT, i, out);
    op->skip = from;
    op->flag = before;
    b->now = out;
    return add ? ms_nn__activation_read(s, op, info, error) : MS_OK;
}

static MS_NN__COLD ms_status ms_nn__build_layer(ms_nn__build *b, int i, ms_error *error)
{
    const ms_nn__spec *s = &b->list->spec[i];
    ms_nn_layer *info = &b->nn->layer[i];
    ms_status status = MS_OK;
    memset(info, 0, sizeof *info);
    info->type = ms_nn__kind_name[(int)b->list->kind[i]];
    info->name = s->name ? s->name : "";
    info->activation = "";
    info->dtype = MS_NN_DTYPE_COUNT;
    switch (b->list->kind[i]) {
    case MS_NN__DENSE: status = ms_nn__build_dense(b, i, info, error); break;
    case MS_NN__CONV1D:
    case MS_NN__CONV2D:
    case MS_NN__TRANSPOSED1D:
    case MS_NN__TRANSPOSED2D: status = ms_nn__build_conv(b, i, info, error); break;
    case MS_NN__UPSAMPLE1D:
    case MS_NN__UPSAMPLE2D:
        status = ms_nn__build_resize(b, i, error);
        info->folded = b->fold[0] * b->fold[1] > 1;
        break;
    case MS_NN__POOL1D:
    case MS_NN__POOL2D:
    case MS_NN__AVERAGE1D:
    case MS_NN__AVERAGE2D: status = ms_nn__build_resize(b, i, error); break;
    case MS_NN__FLATTEN: status = ms_nn__build_flatten(b, i, error); break;
    case MS_NN__ADD:
    case MS_NN__CONCAT: status = ms_nn__build_join(b, i, info, error); break;
    case MS_NN__GLOBAL: status = ms_nn__build_global(b, i, error); break;
    case MS_NN__ACTIVATE:
        status = ms_nn__activation_read(s, ms_nn__op_add(b, MS_NN__DO_ACTIVATE, i, b->low), info, error);
        break;
    case MS_NN__DROPOUT:
        if (s->rate >= 1) status = ms__fail(error, MS_BAD_DATA, 0, "its rate must be below 1");
        break;
    default: break; /* shared_channels: done before the first layer */
    }
    info->output = ms_nn__shape(b->now, b->rank);
    b->value[i] = b->nn->ops;
    return status;
}

static int ms_nn__joins(const ms_nn__op *op) { return op->step == MS_NN__DO_ADD || op->step == MS_NN__DO_CONCAT; }

/* Where values live. Shared memory: a value may take a slot whose last reader has run. The gradient of a value lives
   as long as the value, seen backwards, so that the same slots serve both. */
static MS_NN__COLD ms_status ms_nn__plan(ms_nn *nn, ms_error *error)
{
    size_t n = (size_t)nn->ops + 1, used = 0, v, s, at = 0;
    size_t *size = (size_t *)ms_nn__hold(nn, 3 * n, sizeof(size_t)), *owner, *last;
    nn->slot = (size_t *)ms_nn__hold(nn, 4 * n, sizeof(size_t));
    if (size == NULL || nn->slot == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the plan");
    owner = size + n;
    last = owner + n;
    nn->tape = nn->slot + n;
    nn->skip = nn->tape + n;
    nn->before = nn->skip + n;
    for (v = 0; v < n; ++v) {
        last[v] = v;
        nn->skip[v] = SIZE_MAX;
    }
    for (v = 0; v + 1 < n; ++v)
        if (ms_nn__joins(&nn->op[v])) {
            last[nn->op[v].skip] = v;
            nn->skip[nn->op[v].skip] = 0; /* it needs a place, also where it joins itself */
        }
    for (v = 0; v < n; ++v) {
        size_t floats = ms_nn__count(v ? nn->op[v - 1].out : nn->inner);
        nn->tape[v] = nn->tapes;
        nn->tapes = ms__size_add(nn->tapes, floats);
        nn->before[v] = SIZE_MAX;
        if (v > 0 && nn->op[v - 1].step != MS_NN__DO_ACTIVATE && nn->op[v - 1].activation > MS_NN__LEAKY) {
            nn->before[v] = nn->tapes;
            nn->tapes = ms__size_add(nn->tapes, floats);
        }
        if (nn->skip[v] != SIZE_MAX) {
            nn->skip[v] = nn->skips;
            nn->skips = ms__size_add(nn->skips, floats);
        }
        for (s = 0; s < used; ++s)
            if (last[owner[s]] + 1 < v) break; /* operation last[] has run before v - 1, which makes v */
        if (s == used) size[used++] = 0;
        if (floats > size[s]) size[s] = floats;
        owner[s] = v;
        nn->slot[v] = s;
    }
    for (s = 0; s < used; ++s) {
        owner[s] = at;
        at = ms__size_add(at, size[s]);
    }
    for (v = 0; v < n; ++v) nn->slot[v] = owner[nn->slot[v]];
    nn->slots = at;
    if (at == SIZE_MAX || nn->tapes == SIZE_MAX)
        return ms__fail(error, MS_UNSUPPORTED, 0, "the network's values exceed the address space");
    return MS_OK;
}

static const struct ms_nn__kernels *ms_nn__kernels_for(ms_simd level);
static int ms_nn__row_tiles(void);
static size_t ms_nn__block_of(const struct ms_nn__kernels *kernels);

/* The input of one evaluation: a channel's share with shared_channels, else the whole. */
static MS_NN__COLD ms_status ms_nn__build_input(ms_nn__build *b, ms_error *error)
{
    ms_nn *nn = b->nn;
    size_t i;
    b->rank = nn->input.rank;
    b->now.c = nn->input.size[0];
    b->now.h = b->rank == 3 ? nn->input.size[1] : 1;
    b->now.w = b->rank == 1 ? 1 : nn->input.size[b->rank - 1];
    nn->channels = 1;
    if (b->list->channels > 0) {
        nn->channels = b->list->channels;
        nn->channel_inputs = b->list->channel_inputs;
        nn->channel_input = b->list->channel_input;
        for (i = 0; i < nn->channels * nn->channel_inputs; ++i)
            if (nn->channel_input[i] >= ms_nn__count(b->now))
                return ms__fail(error, MS_BAD_DATA, 0, "shared_channels names input %z of %z", nn->channel_input[i],
                                ms_nn__count(b->now));
        b->rank = 1;
        b->now.c = nn->channel_inputs;
        b->now.h = b->now.w = 1;
    }
    b->low = nn->inner = b->now;
    b->fold[0] = b->fold[1] = 1;
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
    if ((status = ms_nn__list_read(&l, layers, error)) != MS_OK) {
        if (error) error->position = ms_nn__byte_of(nn->file, "ms_nn_layers", error->position);
        return status;
    }
    n = (size_t)l.layers;
    l.spec = (ms_nn__spec *)ms_nn__hold(nn, n, sizeof *l.spec);
    l.kind = (ms_nn__kind *)ms_nn__hold(nn, n, sizeof *l.kind);
    l.channel_input = (size_t *)ms_nn__hold(nn, ms__size_mul(l.channels, l.channel_inputs), sizeof(size_t));
    l.pool = (char *)ms_nn__hold(nn, l.text + 1, 1);
    b.value = (int *)ms_nn__hold(nn, n, sizeof(int));
    nn->layer = (ms_nn_layer *)ms_nn__hold(nn, n, sizeof *nn->layer);
    nn->op = (ms_nn__op *)ms_nn__hold(nn, n + 1, sizeof *nn->op);
    if (!l.spec || !l.kind || !l.channel_input || !l.pool || !b.value || !nn->layer || !nn->op)
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %z layers", n);
    l.layers = 0;
    l.channels = l.channel_inputs = 0;
    ms_nn__list_read(&l, layers, NULL);
    nn->layers = l.layers;
    b.nn = nn;
    b.list = &l;
    b.block = ms_nn__block_of(nn->kernels);
    if ((status = ms_nn__build_input(&b, error)) != MS_OK)
        return ms_nn__about(error, status, ms_nn__byte_of(nn->file, "ms_nn_layers", l.spec[0].at),
                            "layer 0, shared_channels", "");
    for (i = 0; i < l.layers; ++i)
        if ((status = ms_nn__build_layer(&b, i, error)) != MS_OK) {
            ms_error layer;
            ms__fail(&layer, MS_OK, 0, "layer %d, %s", i, nn->layer[i].type);
            return ms_nn__about(error, status, ms_nn__byte_of(nn->file, "ms_nn_layers", l.spec[i].at), layer.message,
                                nn->layer[i].name);
        }
    if (nn->ops == 0) ms_nn__op_add(&b, MS_NN__DO_ACTIVATE, 0, b.low); /* nothing to do is a copy */
    nn->output = ms_nn__shape(b.now, b.rank);
    if (nn->channels > 1 || nn->channel_input) {
        nn->output.rank = 2;
        nn->output.size[1] = ms_nn__count(b.now);
        nn->output.size[0] = nn->channels;
    }
    return ms_nn__plan(nn, error);
}

/* A network of an open file, which it owns from here on. */
static MS_NN__COLD ms_status ms_nn__make(ms_nn_file *file, const ms_nn_options *o, ms_nn **nn, ms_error *error)
{
    ms_nn *made = (ms_nn *)ms_nn__alloc(o, sizeof *made);
    const char *version, *input, *layers, *format;
    ms_status status;
    if (made == NULL) {
        ms_nn_file_close(file);
        return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a network");
    }
    memset(made, 0, sizeof *made);
    made->options = *o;
    made->file = file;
    made->level = ms__simd_pick(o->simd);
    made->kernels = ms_nn__kernels_for(made->level);
    made->row_tiles = ms_nn__row_tiles();
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
    else if (error) error->position = ms_nn__byte_of(file, "ms_nn_input", error->position);
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

/* Rows of y_b = W x_b + bias, one b a sample; or their transpose, g_x = W' g_y. */
typedef struct ms_nn__dense {
    const ms_nn__matrix *m;
    int batch;
    const float *x; /* [batch][cols]; backward: output gradients [batch][rows] */
    float *y;       /* [batch][rows]; backward: partial sums [parts][batch][cols] */
    int linear;     /* no bias, no activation: products with directions */
    ms_nn__activation activation;
    float alpha;
    size_t chunk_rows, chunk_cols, col_chunks; /* of a task */
    int singly;                                /* row by row, as memory likes it, not by tiles */
    const struct ms_nn__digits *digits;        /* [batch], large I8 only */
    const struct ms_nn__kernels *kernels;
} ms_nn__dense;

/* An input of a large I8 layer in fixed point: x = unit (16384 d0 + 128 d1 + d2), digits in [-64, 63]. The products of
   digits with 8-bit weights are summed as integers, so that every level and order gives the same sum. */
typedef struct ms_nn__digits {
    double unit;             /* NaN where x has a NaN or an infinity */
    const signed char *d[3]; /* [cols rounded up to 64], zeros behind the end */
    const int32_t *sum[3];   /* of the digits of each run of MS_NN__RUN columns */
} ms_nn__digits;

#define MS_NN__RUN 65536           /* columns that an int32 sum of 255 * 64 a column holds */
#define MS_NN__DIGIT_MAX 1040319.0 /* 63 * (16384 + 128 + 1) */

/* One convolution of one sample. */
typedef struct ms_nn__conv_job {
    const ms_nn__conv *conv;
    const float *x; /* [in.c] planes of x_plane floats, rows of x_row, elements x_step apart */
    size_t x_plane, x_row, x_step;
    float *padded;      /* [strips][in.c][plane], each strip with room for loads beyond its end */
    size_t padded_step; /* floats from one strip's to the next; 0 where strips follow each other and share one */
    float *y;           /* [out.c] planes */
    size_t y_plane, y_row, y_step;
    int accumulate; /* add to y */
    int linear;
    ms_nn__activation activation;
    float alpha;
    const struct ms_nn__kernels *kernels;
} ms_nn__conv_job;

#define MS_NN__OVERRUN 64 /* floats that a tile may load behind the end of the padded input */

/* The loops that differ by level; the kernel section at the end of this file makes one table a level. */
typedef struct ms_nn__kernels {
    size_t block; /* outputs that a convolution computes together */
    size_t panel; /* rows of a panel of packed weights */
    int widen;    /* packed weights are floats, whatever they were */
    void (*packed)(const ms_nn__dense *job, size_t row0, size_t row1);
    void (*packed_back)(const ms_nn__dense *job, size_t col0, size_t col1);
    void (*dense)(const ms_nn__dense *job, size_t row0, size_t row1);
    void (*dense_int8)(const ms_nn__dense *job, size_t row0, size_t row1);
    void (*dense_back)(const ms_nn__dense *job, size_t row0, size_t row1, size_t col0, size_t col1, float *out);
    void (*conv)(const ms_nn__conv_job *job, size_t strip, const float *padded);
    void (*combine)(float *rows, size_t n);
    void (*activate)(float *y, size_t n, ms_nn__activation activation, float alpha);
    void (*derive)(const float *y, float *g, size_t n, ms_nn__activation activation, float alpha);
    void (*pool2)(const float *x, size_t row, float *y, size_t n);
#ifndef MS_NN_NO_COLLAPSE
    void (*gram)(const double *a, size_t na, const double *b, size_t nb, size_t stride, size_t n, double *out);
    void (*add)(double *y, size_t ny, const double *a, size_t na, size_t stride, size_t n, const double *s);
    void (*rotate)(double *a, double *b, size_t n, double c, double s);
    void (*row)(const ms_nn__matrix *m, size_t row, double factor, double *out);
#endif
} ms_nn__kernels;

#define MS_NN__WIDE 64
#define MS_NN__COLS 512
static const float ms_nn__zeros[MS_NN__WIDE] = {0}; /* stands for rows behind the last, where rows are taken by fours */

static size_t ms_nn__bytes_of(ms_nn_dtype dtype) { return dtype == MS_NN_F32 ? 4 : dtype == MS_NN_I8 ? 1 : 2; }

static size_t ms_nn__block_of(const ms_nn__kernels *kernels) { return kernels->block; }

/* Packs a matrix, unless it comes from memory rather than from a cache: one of over two million weights, or behind the
   first eight million of a network; nor one of rows so long that their sums want more than two parts. Those are read
   where they lie, and I8 is summed in integers, faster than it is widened. Nothing here depends on the batch, so that
   bits do not. 0: no memory. */
static MS_NN__COLD int ms_nn__pack_dense(ms_nn *nn, ms_nn__matrix *m)
{
    const ms_nn_dtype dtype = nn->kernels->widen ? MS_NN_F32 : m->dtype == MS_NN_I8 ? MS_NN_F16 : m->dtype;
    const size_t panel = nn->kernels->panel, size = ms_nn__bytes_of(dtype), own = ms_nn__bytes_of(m->dtype);
    uint16_t half[256]; /* of every I8 */
    unsigned char *w;
    size_t row, k;
    m->packed = NULL;
    m->packed_dtype = dtype;
    if (m->cols > 16384 || m->rows > 2000000 / m->cols || nn->packed + m->rows * m->cols > 8000000) return 1;
    m->packed = w = (unsigned char *)ms_nn__hold(nn, (m->rows + panel - 1) / panel * panel * size, m->cols);
    if (w == NULL) return 0;
    nn->packed += m->rows * m->cols;
    for (k = 0; k < 256; ++k) half[k] = ms__half_from_float(k < 128 ? (float)k : (float)k - 256);
    for (row = 0; row < m->rows || row % panel; ++row) {
        const unsigned char *from = m->w + (row < m->rows ? row * m->cols * own : 0);
        unsigned char *to = w + (row / panel * panel * m->cols + row % panel) * size;
        for (k = 0; k < m->cols; ++k, from += own, to += panel * size)
            if (row >= m->rows) {
                memset(to, 0, size);
            } else if (dtype == m->dtype) {
                if (size == 4) memcpy(to, from, 4);
                else memcpy(to, from, 2);
            } else if (size == 2) {
                ms_nn__put_u16(to, half[*from]);
            } else {
                const float value = (float)ms_nn__element(from, m->dtype, 0);
                memcpy(to, &value, 4);
            }
    }
    return 1;
}

/* Samples of a batch that are taken together against each row of weights: 24 kB of them, a multiple of three. */
static size_t ms_nn__samples(size_t cols) { return cols > 512 ? 12 : 6144 / cols / 3 * 3; }

static size_t ms_nn__min(size_t a, size_t b) { return a < b ? a : b; }

/* How large a task is: enough to hide the cost of handing it out. The sizes depend on the problem alone. */
#define MS_NN__TASK_BYTES 262144u     /* of streamed weights */
#define MS_NN__TASK_PRODUCTS 2097152u /* of a batch: some 40 us */

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
    size_t row0 = (size_t)index * job->chunk_rows, row1 = ms_nn__min(row0 + job->chunk_rows, job->m->rows);
    int b;
    if (job->m->packed) job->kernels->packed(job, row0, row1);
    else if (job->digits) job->kernels->dense_int8(job, row0, row1);
    else job->kernels->dense(job, row0, row1);
    if (!job->linear && job->activation != MS_NN__LINEAR)
        for (b = 0; b < job->batch; ++b)
            job->kernels->activate(job->y + (size_t)b * job->m->rows + row0, row1 - row0, job->activation, job->alpha);
}

static size_t ms_nn__digit_cols(size_t cols) { return (cols + 63) / 64 * 64; }
static size_t ms_nn__digit_runs(size_t cols) { return (cols + MS_NN__RUN - 1) / MS_NN__RUN; }

/* Bytes of the digits of batch inputs. */
static size_t ms_nn__digits_size(size_t cols, size_t batch)
{
    size_t one = ms__size_add(ms__size_mul(3, ms_nn__digit_cols(cols)), 3 * ms_nn__digit_runs(cols) * sizeof(int32_t));
    return ms__size_mul(ms__size_add(one, sizeof(ms_nn__digits)), batch);
}

/* q = round(x / unit) with unit = max |x| / DIGIT_MAX, cut into three balanced digits. */
static void ms_nn__digits_make(ms_nn__digits *digits, signed char *d, int32_t *sum, const float *x, size_t cols)
{
    size_t wide = ms_nn__digit_cols(cols), runs = ms_nn__digit_runs(cols), run, i;
    double largest, factor;
    uint32_t most = 0, bits;
    float magnitude;
    int k;
    for (i = 0; i < cols; ++i) { /* the order of magnitudes is that of their bits */
        memcpy(&bits, &x[i], sizeof bits);
        bits &= 0x7fffffffu;
        if (bits > most) most = bits;
    }
    for (k = 0; k < 3; ++k) {
        digits->d[k] = d + (size_t)k * wide;
        digits->sum[k] = sum + (size_t)k * runs;
    }
    memset(d, 0, 3 * wide);
    memset(sum, 0, 3 * runs * sizeof *sum);
    magnitude = ms_nn__float_of(most < 0x7f800000u ? most : 0);
    largest = (double)magnitude;
    digits->unit = most < 0x7f800000u ? largest / MS_NN__DIGIT_MAX : (double)ms_nn__float_of(0x7fc00000u);
    if (!(largest > 0)) return;
    factor = MS_NN__DIGIT_MAX / largest;
    for (run = 0; run < runs; ++run) {
        size_t end = ms_nn__min(cols, (run + 1) * MS_NN__RUN);
        int32_t total[3] = {0, 0, 0};
        for (i = run * MS_NN__RUN; i < end; ++i) {
            int32_t q = (int32_t)((double)x[i] * factor + 1048576.5) - 1048576, low = ((q + 64) & 127) - 64,
                    middle; /* 2^20: never negative */
            q = (q - low) / 128;
            middle = ((q + 64) & 127) - 64;
            q = (q - middle) / 128;
            d[i] = (signed char)q;
            d[wide + i] = (signed char)middle;
            d[2 * wide + i] = (signed char)low;
            total[0] += q;
            total[1] += middle;
            total[2] += low;
        }
        for (k = 0; k < 3; ++k) sum[(size_t)k * runs + run] = total[k];
    }
}

static MS_NN__COLD void ms_nn__run_dense(const ms_nn *nn, const ms_nn__op *op, int batch, const float *x, float *y,
                                         int linear, void *scratch)
{
    const ms_nn__matrix *m = &op->matrix;
    ms_nn__dense job;
    memset(&job, 0, sizeof job);
    job.m = m;
    job.batch = batch;
    job.x = x;
    job.y = y;
    job.linear = linear;
    job.activation = op->activation;
    job.alpha = op->alpha;
    job.kernels = nn->kernels;
    job.singly = !(nn->row_tiles && m->dtype == MS_NN_F32);
    if (m->dtype == MS_NN_I8 && m->packed == NULL) {
        size_t n = (size_t)batch, wide = ms_nn__digit_cols(m->cols), runs = ms_nn__digit_runs(m->cols), b;
        signed char *d = (signed char *)scratch; /* 64-byte aligned, as each digit's row is */
        ms_nn__digits *digits = (ms_nn__digits *)(void *)(d + 3 * wide * n);
        int32_t *sum = (int32_t *)(void *)(digits + n);
        for (b = 0; b < n; ++b)
            ms_nn__digits_make(&digits[b], d + 3 * wide * b, sum + 3 * runs * b, x + b * m->cols, m->cols);
        job.digits = digits;
    }
    job.chunk_rows = MS_NN__TASK_BYTES / (m->cols * (size_t)(ms_nn__bits(m->dtype) / 8)) + 1;
    if (batch > 1 || m->packed) { /* whole tiles of rows, and of a large batch so few that several threads find some */
        size_t most = MS_NN__TASK_PRODUCTS / (m->cols * (size_t)batch) + 1,
               tile = m->packed ? 2 * nn->kernels->panel : 16;
        job.chunk_rows = (ms_nn__min(job.chunk_rows, most) + tile - 1) / tile * tile;
    }
    ms_nn__chunks(nn, m->rows, &job.chunk_rows, ms_nn__dense_task, &job);
}

static void ms_nn__dense_back_task(void *context, int index)
{
    const ms_nn__dense *job = (const ms_nn__dense *)context;
    size_t part = (size_t)index / job->col_chunks, col0 = (size_t)index % job->col_chunks * job->chunk_cols;
    size_t row0 = part * job->chunk_rows;
    job->kernels->dense_back(job, row0, ms_nn__min(row0 + job->chunk_rows, job->m->rows), col0,
                             ms_nn__min(col0 + job->chunk_cols, job->m->cols),
                             job->y + part * (size_t)job->batch * job->m->cols);
}

static void ms_nn__packed_back_task(void *context, int index)
{
    const ms_nn__dense *job = (const ms_nn__dense *)context;
    size_t col0 = (size_t)index * job->chunk_cols;
    job->kernels->packed_back(job, col0, ms_nn__min(col0 + job->chunk_cols, job->m->cols));
}

/* A wide matrix is cut into stripes of columns, a narrow one into parts of rows whose sums are added in order. */
#define MS_NN__STRIPE 4096u
static size_t ms_nn__back_parts(const ms_nn__matrix *m)
{
    size_t parts = m->cols >= MS_NN__STRIPE ? 1 : (m->rows + 4095) / 4096;
    return parts < 64 ? parts : 64;
}

/* Rows of a packed matrix with those behind the last. */
static size_t ms_nn__padded_rows(const ms_nn *nn, const ms_nn__matrix *m)
{
    return (m->rows + nn->kernels->panel - 1) / nn->kernels->panel * nn->kernels->panel;
}

/* Floats of scratch memory that going back takes. */
static size_t ms_nn__back_floats(const ms_nn *nn, const ms_nn__matrix *m, size_t count)
{
    size_t parts = ms_nn__back_parts(m);
    return m->packed ? ms__size_mul(ms_nn__padded_rows(nn, m), count)
        : parts > 1  ? ms__size_mul(ms__size_mul(parts, count), m->cols)
                     : 0;
}

/* The gradients of packed rows are multiplied by the rows' scales first, zeros behind the last. */
static MS_NN__COLD void ms_nn__run_dense_back(const ms_nn *nn, const ms_nn__op *op, int batch, const float *g_y,
                                              float *g_x, void *scratch)
{
    const ms_nn__matrix *m = &op->matrix;
    size_t parts = ms_nn__back_parts(m), n = (size_t)batch * m->cols, p, i;
    ms_nn__dense job;
    memset(&job, 0, sizeof job);
    job.m = m;
    job.batch = batch;
    if (m->packed) {
        size_t rows = ms_nn__padded_rows(nn, m), b;
        float *padded = (float *)scratch;
        job.kernels = nn->kernels;
        job.x = padded;
        job.y = g_x;
        for (b = 0; b < (size_t)batch; ++b, padded += rows) {
            for (i = 0; i < m->rows; ++i)
                padded[i] = g_y[b * m->rows + i] * (m->scale ? ms_nn__float_at(m->scale, i) : 1.0f);
            for (; i < rows; ++i) padded[i] = 0;
        }
        job.chunk_cols = ms_nn__min(MS_NN__TASK_BYTES / (rows * ms_nn__bytes_of(m->packed_dtype)),
                                    MS_NN__TASK_PRODUCTS / (rows * (size_t)batch));
        job.chunk_cols = (job.chunk_cols / 64 + 1) * 64;
        ms_nn__chunks(nn, m->cols, &job.chunk_cols, ms_nn__packed_back_task, &job);
        return;
    }
    job.x = g_y;
    job.y = parts == 1 ? g_x : (float *)scratch;
    job.kernels = nn->kernels;
    job.chunk_rows = (m->rows + parts - 1) / parts;
    job.chunk_cols = MS_NN__STRIPE;
    job.col_chunks = (m->cols + MS_NN__STRIPE - 1) / MS_NN__STRIPE;
    memset(job.y, 0, parts * n * sizeof(float));
    ms__run(&nn->options.parallel, (int)(parts * job.col_chunks), ms_nn__dense_back_task, &job);
    if (parts == 1) return;
    for (i = 0; i < n; ++i) {
        float sum = job.y[i];
        for (p = 1; p < parts; ++p) sum += job.y[p * n + i];
        g_x[i] = sum;
    }
}

/* Copies what a strip sees of the input: zeros around, zeros between dilated elements, columns sorted by their
   remainder modulo the stride. For Winograd's form four rows for each pair of output rows, combined. */
static void ms_nn__pad(const ms_nn__conv_job *job, size_t strip, float *padded)
{
    const ms_nn__conv *v = job->conv;
    size_t s = v->stride[1], wide = v->pitch / s, c, y, x;
    for (c = 0; c < v->in.c; ++c) {
        for (y = 0; y < v->rows; ++y) {
            float *to = padded + c * v->plane + y * v->pitch;
            ptrdiff_t from_y = (ptrdiff_t)(strip * v->strip * v->stride[0] + (v->pairs ? y / 4 * 2 + y % 4 : y)) -
                v->pad[0];
            const float *from;
            size_t left, count;
            if (from_y < 0 || (size_t)from_y % v->dilate[0] || (size_t)from_y / v->dilate[0] >= v->in.h) {
                memset(to, 0, v->pitch * sizeof(float));
                continue;
            }
            from = job->x + c * job->x_plane + (size_t)from_y / v->dilate[0] * job->x_row;
            if (s == 1 && v->dilate[1] == 1 && job->x_step == 1) {
                left = v->pad[1] > 0 ? ms_nn__min((size_t)v->pad[1], v->pitch) : 0;
                if (v->pad[1] < 0) from += -v->pad[1];
                count = v->in.w - (v->pad[1] < 0 ? ms_nn__min((size_t)-v->pad[1], v->in.w) : 0);
                count = ms_nn__min(count, v->pitch - left);
                for (x = 0; x < left; ++x) to[x] = 0;
                memcpy(to + left, from, count * sizeof(float));
                for (x = left + count; x < v->pitch; ++x) to[x] = 0;
                continue;
            }
            memset(to, 0, v->pitch * sizeof(float));
            for (x = 0; x < v->in.w; ++x) {
                ptrdiff_t at = (ptrdiff_t)(x * v->dilate[1]) + v->pad[1];
                if (at >= 0 && (size_t)at < v->pitch)
                    to[(size_t)at % s * wide + (size_t)at / s] = from[x * job->x_step];
            }
        }
        for (y = 0; v->pairs && y < v->rows; y += 4)
            job->kernels->combine(padded + c * v->plane + y * v->pitch, v->pitch);
    }
    memset(padded + v->in.c * v->plane, 0, MS_NN__OVERRUN * sizeof(float));
}

static void ms_nn__conv_task(void *context, int index)
{
    const ms_nn__conv_job *job = (const ms_nn__conv_job *)context;
    float *padded = job->padded + (size_t)index * job->padded_step;
    ms_nn__pad(job, (size_t)index, padded);
    job->kernels->conv(job, (size_t)index, padded);
}

static size_t ms_nn__conv_strips(const ms_nn__conv *v) { return (v->out.h + v->strip - 1) / v->strip; }

/* Floats of the padded input of a convolution: all strips where they may run at once. */
static size_t ms_nn__conv_scratch(const ms_nn *nn, const ms_nn__conv *v)
{
    size_t one = ms__size_add(ms__size_mul(v->in.c, v->plane), MS_NN__OVERRUN);
    return nn->options.parallel.run ? ms__size_mul(one, ms_nn__conv_strips(v)) : one;
}

static void ms_nn__run_conv(const ms_nn *nn, ms_nn__conv_job *job)
{
    job->kernels = nn->kernels;
    job->padded_step = nn->options.parallel.run ? job->conv->in.c * job->conv->plane + MS_NN__OVERRUN : 0;
    ms__run(&nn->options.parallel, (int)ms_nn__conv_strips(job->conv), ms_nn__conv_task, job);
}

/* All groups and phases of a sample; back: from the gradient of the outputs to that of the inputs. */
static MS_NN__COLD void ms_nn__conv_all(const ms_nn *nn, const ms_nn__op *op, const float *from, float *to, int linear,
                                        int back, void *scratch)
{
    size_t in = op->in.h * op->in.w, out = op->out.h * op->out.w, phases = (size_t)op->phases, n;
    for (n = 0; n < phases * op->groups; ++n) {
        size_t p = n % phases, at = n / phases * (op->in.c / op->groups) * in,
               end = n / phases * (op->out.c / op->groups) * out + p;
        ms_nn__conv_job job;
        if (op->forward[n].out.w == 0) continue;
        memset(&job, 0, sizeof job);
        job.conv = back ? &op->backward[n] : &op->forward[n];
        job.x = from + (back ? end : at);
        job.x_plane = back ? out : in;
        job.x_row = back ? op->out.w : op->in.w;
        job.x_step = back ? phases : 1;
        job.padded = (float *)scratch;
        job.y = to + (back ? at : end);
        job.y_plane = back ? in : out;
        job.y_row = back ? op->in.w : op->out.w;
        job.y_step = back ? 1 : phases;
        job.accumulate = back && p > 0;
        job.linear = linear;
        job.activation = phases == 1 ? op->activation : MS_NN__LINEAR;
        job.alpha = op->alpha;
        ms_nn__run_conv(nn, &job);
    }
    if (phases > 1 && !linear) nn->kernels->activate(to, ms_nn__count(op->out), op->activation, op->alpha);
}

/* The first maximum of a window, or its first NaN. */
static size_t ms_nn__pool_at(const ms_nn__op *op, const float *x, size_t c, size_t y, size_t z)
{
    size_t best = 0, i, j;
    for (i = 0; i < op->size[0]; ++i)
        for (j = 0; j < op->size[1]; ++j) {
            size_t at = (c * op->in.h + y * op->stride[0] + i) * op->in.w + z * op->stride[1] + j;
            if (i + j == 0) best = at;
            else if (x[at] > x[best] || (x[at] != x[at] && x[best] == x[best])) best = at;
        }
    return best;
}

/* point: the values that the maxima are taken of; x: what is picked, the same or a direction. */
typedef struct ms_nn__pool_job {
    const ms_nn__op *op;
    const float *point, *x;
    float *y;
    size_t chunk; /* channels of a task */
    const ms_nn__kernels *kernels;
} ms_nn__pool_job;

static void ms_nn__pool_task(void *context, int index)
{
    const ms_nn__pool_job *job = (const ms_nn__pool_job *)context;
    const ms_nn__op *op = job->op;
    size_t c = (size_t)index * job->chunk, c1 = ms_nn__min(c + job->chunk, op->out.c), i, j;
    int fast = job->point == job->x && op->size[0] == 2 && op->size[1] == 2 && op->stride[0] == 2 && op->stride[1] == 2;
    float *y = job->y + c * op->out.h * op->out.w;
    for (; c < c1; ++c)
        for (i = 0; i < op->out.h; ++i, y += op->out.w) {
            if (fast) job->kernels->pool2(job->x + (c * op->in.h + 2 * i) * op->in.w, op->in.w, y, op->out.w);
            else
                for (j = 0; j < op->out.w; ++j) y[j] = job->x[ms_nn__pool_at(op, job->point, c, i, j)];
        }
}

static void ms_nn__run_pool(const ms_nn *nn, const ms_nn__op *op, const float *point, const float *x, float *y)
{
    ms_nn__pool_job job;
    job.op = op;
    job.point = point;
    job.x = x;
    job.y = y;
    job.kernels = nn->kernels;
    job.chunk = 65536 / (op->in.h * op->in.w) + 1;
    ms_nn__chunks(nn, op->out.c, &job.chunk, ms_nn__pool_task, &job);
}

static void ms_nn__run_pool_back(const ms_nn__op *op, const float *point, const float *g_y, float *g_x)
{
    size_t c, i, j;
    memset(g_x, 0, ms_nn__count(op->in) * sizeof(float));
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j) g_x[ms_nn__pool_at(op, point, c, i, j)] += *g_y++;
}

static void ms_nn__run_upsample(const ms_nn__op *op, const float *x, float *y)
{
    size_t c, i, j;
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j) *y++ = x[(c * op->in.h + i / op->size[0]) * op->in.w + j / op->size[1]];
}

static void ms_nn__run_upsample_back(const ms_nn__op *op, const float *g_y, float *g_x)
{
    size_t c, i, j;
    memset(g_x, 0, ms_nn__count(op->in) * sizeof(float));
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j)
                g_x[(c * op->in.h + i / op->size[0]) * op->in.w + j / op->size[1]] += *g_y++;
}

/* Linear interpolation along one axis: output i stands between inputs at and at + 1 (the last repeats), at the share of
   the second. PyTorch's two rules: centers of elements, or corners, in line. */
static MS_NN__COLD float ms_nn__between(size_t i, size_t in, size_t out, int corners, size_t *at)
{
    double x = corners ? (out > 1 ? (double)i * (double)(in - 1) / (double)(out - 1) : 0.0)
                       : ((double)i + 0.5) * (double)in / (double)out - 0.5;
    if (x < 0) x = 0;
    *at = (size_t)x;
    if (*at + 1 >= in) {
        *at = in - 1;
        return 0;
    }
    return (float)(x - (double)*at);
}

/* Linear upsampling of x to y, or with back the gradient of y to that of x, which is cleared first. */
static MS_NN__COLD void ms_nn__run_linear(const ms_nn__op *op, float *x, float *y, int back)
{
    size_t c, i, j, top, left;
    for (i = 0; i < op->out.h; ++i) {
        float down = ms_nn__between(i, op->in.h, op->out.h, op->flag, &top);
        for (j = 0; j < op->out.w; ++j) {
            float right = ms_nn__between(j, op->in.w, op->out.w, op->flag, &left);
            size_t below = top + 1 < op->in.h ? op->in.w : 0, next = left + 1 < op->in.w ? 1 : 0;
            float a = (1 - down) * (1 - right), b = (1 - down) * right, d = down * (1 - right), e = down * right;
            for (c = 0; c < op->out.c; ++c) {
                float *from = x + (c * op->in.h + top) * op->in.w + left, *to = y + (c * op->out.h + i) * op->out.w + j;
                if (!back) {
                    *to = a * from[0] + b * from[next] + (d * from[below] + e * from[below + next]);
                    continue;
                }
                from[0] += a * *to;
                from[next] += b * *to;
                from[below] += d * *to;
                from[below + next] += e * *to;
            }
        }
    }
}

/* Means of windows, or with back their gradient to that of x, which is cleared first. */
static MS_NN__COLD void ms_nn__run_average(const ms_nn__op *op, float *x, float *y, int back)
{
    size_t c, i, j, p, q;
    double share = 1.0 / ((double)op->size[0] * (double)op->size[1]);
    for (c = 0; c < op->out.c; ++c)
        for (i = 0; i < op->out.h; ++i)
            for (j = 0; j < op->out.w; ++j, ++y) {
                float *from = x + (c * op->in.h + i * op->stride[0]) * op->in.w + j * op->stride[1],
                      part = (float)(share * (double)*y);
                double sum = 0;
                for (p = 0; p < op->size[0]; ++p)
                    for (q = 0; q < op->size[1]; ++q) {
                        if (back) from[p * op->in.w + q] += part;
                        else sum += (double)from[p * op->in.w + q];
                    }
                if (!back) *y = (float)(share * sum);
            }
}

/* [rows][cols] to [cols][rows]. */
static void ms_nn__transpose(const float *x, size_t rows, size_t cols, float *y)
{
    size_t i, j, i0, j0;
    for (i0 = 0; i0 < rows; i0 += 32)
        for (j0 = 0; j0 < cols; j0 += 32)
            for (j = j0; j < ms_nn__min(j0 + 32, cols); ++j)
                for (i = i0; i < ms_nn__min(i0 + 32, rows); ++i) y[j * rows + i] = x[i * cols + j];
}

/* ---- products -------------------------------------------------------------------------------------------------- */

/* One run: points x directions. Samples of the caller become channels each with shared_channels. */
typedef struct ms_nn__run {
    const ms_nn *nn;
    size_t points;
    const float *x; /* [points][inner] value 0 */
    float *y;       /* [points][output] the last value; NULL: in the shared slots or on the tape */
    float *values;  /* tape or slots, for all points */
    const size_t *place;
    void *scratch;
} ms_nn__run;

static size_t ms_nn__value_size(const ms_nn *nn, int v) { return ms_nn__count(v ? nn->op[v - 1].out : nn->inner); }

static float *ms_nn__value(const ms_nn__run *r, int v)
{
    if (v == r->nn->ops && r->y != NULL) return r->y;
    return r->values + r->place[v] * r->points;
}

/* What the slope of operation v's activation depends on: its argument where that is kept, else its value (relu,
   leaky_relu). */
static const float *ms_nn__argument(const ms_nn__run *r, int v)
{
    if (r->place == r->nn->slot) return NULL;
    if (r->nn->op[v - 1].step == MS_NN__DO_ACTIVATE) return v == 1 ? r->x : ms_nn__value(r, v - 1);
    return r->nn->before[v] == SIZE_MAX ? ms_nn__value(r, v) : r->values + r->nn->before[v] * r->points;
}

static const float *ms_nn__input_value(const ms_nn__run *r, int v) { return v == 0 ? r->x : ms_nn__value(r, v); }

/* Applies operation k to count vectors. With point NULL they are points themselves; else directions, of which each
   point has `each`, and point and argument hold the operation's input and what its activation is applied to there. */
static MS_NN__COLD void ms_nn__apply(const ms_nn *nn, int k, size_t count, const float *x, const float *skip, float *y,
                                     const float *point, const float *argument, size_t each, void *scratch)
{
    const ms_nn__op *op = &nn->op[k];
    size_t in = ms_nn__count(op->in), out = ms_nn__count(op->out), b, i;
    int linear = point != NULL;
    ms_nn__op plain;
    if (each == 0) { /* points whose activation is left to the caller */
        plain = *op;
        plain.activation = MS_NN__LINEAR;
        op = &plain;
    }
    if (op->step == MS_NN__DO_DENSE) ms_nn__run_dense(nn, op, (int)count, x, y, linear, scratch);
    for (b = 0; b < count; ++b) {
        const float *xb = x + b * in;
        float *yb = y + b * out;
        switch (op->step) {
        case MS_NN__DO_CONV: ms_nn__conv_all(nn, op, xb, yb, linear, 0, scratch); break;
        case MS_NN__DO_UPSAMPLE: ms_nn__run_upsample(op, xb, yb); break;
        case MS_NN__DO_LINEAR: ms_nn__run_linear(op, (float *)(uintptr_t)xb, yb, 0); break; /* reads xb alone */
        case MS_NN__DO_AVERAGE:
            memset(yb, 0, out * sizeof(float));
            ms_nn__run_average(op, (float *)(uintptr_t)xb, yb, 0);
            break;
        case MS_NN__DO_CONCAT:
            memcpy(yb + (op->flag ? out - in : 0), xb, in * sizeof(float));
            memcpy(yb + (op->flag ? 0 : in), skip + b * (out - in), (out - in) * sizeof(float));
            break;
        case MS_NN__DO_POOL: ms_nn__run_pool(nn, op, linear ? point + b / each * in : xb, xb, yb); break;
        case MS_NN__DO_TRANSPOSE: ms_nn__transpose(xb, op->in.c, op->in.h * op->in.w, yb); break;
        case MS_NN__DO_ADD:
            for (i = 0; i < out; ++i) yb[i] = xb[i] + skip[b * out + i];
            if (!linear) nn->kernels->activate(yb, out, op->activation, op->alpha);
            break;
        case MS_NN__DO_ACTIVATE:
            memcpy(yb, xb, out * sizeof(float));
            if (!linear) nn->kernels->activate(yb, out, op->activation, op->alpha);
            break;
        default: break;
        }
        if (linear) nn->kernels->derive(argument + b / each * out, yb, out, op->activation, op->alpha);
    }
}

/* g_x = J_k' g_y at the points; g_y is used up. */
static MS_NN__COLD void ms_nn__apply_back(const ms_nn *nn, int k, size_t count, float *g_y, float *g_x, float *g_skip,
                                          const float *point, const float *argument, size_t each, void *scratch)
{
    const ms_nn__op *op = &nn->op[k];
    size_t in = ms_nn__count(op->in), out = ms_nn__count(op->out), b, i;
    for (b = 0; b < count; ++b)
        nn->kernels->derive(argument + b / each * out, g_y + b * out, out, op->activation, op->alpha);
    if (op->step == MS_NN__DO_DENSE) ms_nn__run_dense_back(nn, op, (int)count, g_y, g_x, scratch);
    for (b = 0; b < count; ++b) {
        const float *gy = g_y + b * out;
        float *gx = g_x + b * in;
        switch (op->step) {
        case MS_NN__DO_CONV: ms_nn__conv_all(nn, op, gy, gx, 1, 1, scratch); break;
        case MS_NN__DO_UPSAMPLE: ms_nn__run_upsample_back(op, gy, gx); break;
        case MS_NN__DO_LINEAR:
        case MS_NN__DO_AVERAGE:
            memset(gx, 0, in * sizeof(float));
            (op->step == MS_NN__DO_LINEAR ? ms_nn__run_linear : ms_nn__run_average)(op, gx, g_y + b * out, 1);
            break;
        case MS_NN__DO_CONCAT:
            memcpy(gx, gy + (op->flag ? out - in : 0), in * sizeof(float));
            for (i = 0; i < out - in; ++i) g_skip[b * (out - in) + i] += gy[(op->flag ? 0 : in) + i];
            break;
        case MS_NN__DO_POOL: ms_nn__run_pool_back(op, point + b / each * in, gy, gx); break;
        case MS_NN__DO_TRANSPOSE: ms_nn__transpose(gy, op->in.h * op->in.w, op->in.c, gx); break;
        case MS_NN__DO_ADD:
            for (i = 0; i < out; ++i) g_skip[b * out + i] += gy[i];
            memcpy(gx, gy, out * sizeof(float));
            break;
        case MS_NN__DO_ACTIVATE: memcpy(gx, gy, out * sizeof(float)); break;
        default: break;
        }
    }
}

static MS_NN__COLD void ms_nn__run_forward(const ms_nn__run *r)
{
    int k;
    for (k = 0; k < r->nn->ops; ++k) {
        ms_nn__op *op = &r->nn->op[k];
        float *y = ms_nn__value(r, k + 1);
        size_t kept = r->place == r->nn->tape ? r->nn->before[k + 1] : SIZE_MAX;
        float *to = kept == SIZE_MAX ? y : r->values + kept * r->points;
        ms_nn__apply(r->nn, k, r->points, ms_nn__input_value(r, k), ms_nn__input_value(r, op->skip), to, NULL, NULL,
                     kept == SIZE_MAX, r->scratch);
        if (to == y) continue;
        memcpy(y, to, r->points * ms_nn__count(op->out) * sizeof(float));
        r->nn->kernels->activate(y, r->points * ms_nn__count(op->out), op->activation, op->alpha);
    }
}

/* Directions dx [points][each][inner] through the tape of r into dy [points][each][output]; slots is memory. */
static MS_NN__COLD void ms_nn__run_directions(const ms_nn__run *r, size_t each, const float *dx, float *dy,
                                              float *slots)
{
    const ms_nn *nn = r->nn;
    ms_nn__run d = *r;
    int k;
    d.points = r->points * each;
    d.x = dx;
    d.y = dy;
    d.values = slots;
    d.place = nn->slot;
    for (k = 0; k < nn->ops; ++k)
        ms_nn__apply(nn, k, d.points, ms_nn__input_value(&d, k), ms_nn__input_value(&d, nn->op[k].skip),
                     ms_nn__value(&d, k + 1), ms_nn__input_value(r, k), ms_nn__argument(r, k + 1), each, r->scratch);
}

/* Gradients back through the tape: g [points][each][output] lies in the last value's slot; g_x out. */
static void ms_nn__run_gradients(const ms_nn__run *r, size_t each, float *g_x, float *slots, float *skips)
{
    const ms_nn *nn = r->nn;
    ms_nn__run d = *r;
    int k;
    size_t i;
    d.points = r->points * each;
    d.y = NULL;
    d.values = slots;
    d.place = nn->slot;
    memset(skips, 0, nn->skips * d.points * sizeof(float));
    for (k = nn->ops - 1; k >= 0; --k) {
        float *to = k ? ms_nn__value(&d, k) : g_x;
        size_t other = ms_nn__joins(&nn->op[k]) ? nn->skip[nn->op[k].skip] : 0;
        ms_nn__apply_back(nn, k, d.points, ms_nn__value(&d, k + 1), to, skips + other * d.points,
                          ms_nn__input_value(r, k), ms_nn__argument(r, k + 1), each, r->scratch);
        if (nn->skip[k] != SIZE_MAX)
            for (i = 0; i < ms_nn__value_size(nn, k) * d.points; ++i) to[i] += skips[nn->skip[k] * d.points + i];
    }
}

/* Bytes that the operations need beside the values, for count vectors. */
static MS_NN__COLD size_t ms_nn__scratch_size(const ms_nn *nn, size_t count, int backward)
{
    size_t most = 0, need;
    int k, p;
    for (k = 0; k < nn->ops; ++k) {
        const ms_nn__op *op = &nn->op[k];
        if (op->step == MS_NN__DO_DENSE) {
            if (op->matrix.dtype == MS_NN_I8 && op->matrix.packed == NULL) {
                need = ms_nn__digits_size(op->matrix.cols, count);
                if (need > most) most = need;
            }
            need = backward ? ms__size_mul(ms_nn__back_floats(nn, &op->matrix, count), sizeof(float)) : 0;
            if (need > most) most = need;
        }
        for (p = 0; op->step == MS_NN__DO_CONV && p < op->phases * (int)op->groups; ++p) {
            need = ms__size_mul(ms_nn__conv_scratch(nn, &op->forward[p]), sizeof(float));
            if (need > most) most = need;
            need = backward ? ms__size_mul(ms_nn__conv_scratch(nn, &op->backward[p]), sizeof(float)) : 0;
            if (need > most) most = need;
        }
    }
    return most;
}

/* The pieces of a workspace, in order; each starts at a multiple of 64 bytes. */
typedef struct ms_nn__layout {
    size_t points, each; /* of the run; each is 0 for a forward run */
    int backward;
    size_t x, values, dx, dy, slots, skips, scratch, total; /* byte offsets */
} ms_nn__layout;

static size_t ms_nn__piece(size_t *total, size_t count, size_t floats)
{
    size_t at = *total;
    *total = ms__size_add(
        *total, ms__size_mul(ms__size_add(ms__size_mul(ms__size_mul(count, floats), sizeof(float)) / 64, 1), 64));
    if (ms__size_mul(ms__size_mul(count, floats), sizeof(float)) == SIZE_MAX) *total = SIZE_MAX;
    return at;
}

/* How many samples (JVP: directions) of a call run together: dense layers gain from many, values should stay in a
   cache. */
static MS_NN__COLD size_t ms_nn__together(const ms_nn *nn, ms_nn_product product)
{
    size_t floats = product == MS_NN_FORWARD ? nn->slots : nn->tapes, dense = 0, n;
    int k, convolutions = 0;
    floats = ms__size_mul(floats, nn->channels);
    for (k = 0; k < nn->ops; ++k) {
        if (nn->op[k].step == MS_NN__DO_DENSE) dense += nn->op[k].matrix.rows * nn->op[k].matrix.cols;
        else convolutions += nn->op[k].step == MS_NN__DO_CONV;
    }
    n = (convolutions ? 131072u : 4194304u) / (floats + 1) / 12 * 12;
    if (n > 48) n = 48;
    if (n > 12 && nn->channels > 1) n = 12;
    return n > 0 ? n : convolutions && dense < 2000000 ? 1 : 12; /* large weights are better read for several */
}

static MS_NN__COLD ms_nn__layout ms_nn__layout_of(const ms_nn *nn, ms_nn_product product, size_t count)
{
    ms_nn__layout l;
    size_t in = ms_nn__count(nn->inner), out = ms_nn__value_size(nn, nn->ops), vectors, scratch;
    int shared = nn->channel_input != NULL;
    memset(&l, 0, sizeof l);
    if (product != MS_NN_JACOBIAN) count = ms_nn__min(count, ms_nn__together(nn, product));
    l.points = product == MS_NN_FORWARD || product == MS_NN_VJP ? ms__size_mul(count, nn->channels) : nn->channels;
    l.each = product == MS_NN_FORWARD ? 0
        : product == MS_NN_VJP        ? 1
        : product == MS_NN_JVP        ? count
        : in <= out                   ? in
                                      : out;
    l.backward = product == MS_NN_VJP || (product == MS_NN_JACOBIAN && out < in);
    vectors = ms__size_mul(l.points, l.each);
    l.x = ms_nn__piece(&l.total, l.points, shared ? in : 0);
    l.values = ms_nn__piece(&l.total, l.points, product == MS_NN_FORWARD ? nn->slots : nn->tapes);
    if (product != MS_NN_FORWARD) {
        l.dx = ms_nn__piece(&l.total, vectors, product == MS_NN_JACOBIAN || shared ? in : 0);
        l.dy = ms_nn__piece(&l.total, vectors, product == MS_NN_JACOBIAN && !l.backward ? out : 0);
        l.slots = ms_nn__piece(&l.total, vectors, nn->slots);
        l.skips = ms_nn__piece(&l.total, vectors, l.backward ? nn->skips : 0);
    }
    scratch = ms_nn__scratch_size(nn, vectors > l.points ? vectors : l.points, l.backward);
    l.scratch = ms_nn__piece(&l.total, 1, scratch / sizeof(float) + 1);
    l.total = ms__size_add(l.total, 63); /* to align the first piece */
    if (vectors == SIZE_MAX || scratch == SIZE_MAX || l.points > INT_MAX || vectors > INT_MAX) l.total = SIZE_MAX;
    return l;
}

MS_API MS_NN__COLD size_t ms_nn_workspace_size(const ms_nn *nn, ms_nn_product product, int count)
{
    if (nn == NULL) return 0;
    if (count < 1) return SIZE_MAX;
    return ms_nn__layout_of(nn, product, (size_t)count).total;
}

/* Copies the inputs that each channel sees: x [count][input] to inner [count][channels][channel_inputs]. */
static void ms_nn__spread(const ms_nn *nn, size_t count, const float *x, float *inner)
{
    size_t n = nn->channels * nn->channel_inputs, input = ms_nn_input_size(nn), b, i;
    for (b = 0; b < count; ++b)
        for (i = 0; i < n; ++i) *inner++ = x[b * input + nn->channel_input[i]];
}

/* A started product: memory, layout and the forward run. */
typedef struct ms_nn__call {
    ms_nn__layout layout;
    ms_nn__run run;
    char *base;      /* 64-byte aligned */
    void *allocated; /* NULL: the caller's workspace */
} ms_nn__call;

static float *ms_nn__at(const ms_nn__call *call, size_t offset) { return (float *)(void *)(call->base + offset); }

static MS_NN__COLD ms_status ms_nn__begin(ms_nn__call *call, const ms_nn *nn, ms_nn_product product, int count,
                                          const float *x, float *y, void *workspace)
{
    size_t points;
    memset(call, 0, sizeof *call);
    if (nn == NULL || x == NULL || count < 1) return MS_INVALID_ARGUMENT;
    call->layout = ms_nn__layout_of(nn, product, (size_t)count);
    if (call->layout.total == SIZE_MAX) return MS_OUT_OF_MEMORY;
    if (workspace == NULL) workspace = call->allocated = ms_nn__alloc(&nn->options, call->layout.total);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    call->base = (char *)(((uintptr_t)workspace + 63) & ~(uintptr_t)63);
    points = call->layout.points;
    call->run.nn = nn;
    call->run.points = points;
    call->run.x = x;
    call->run.y = y;
    call->run.values = ms_nn__at(call, call->layout.values);
    call->run.place = product == MS_NN_FORWARD ? nn->slot : nn->tape;
    call->run.scratch = ms_nn__at(call, call->layout.scratch);
    if (nn->channel_input != NULL) {
        call->run.x = ms_nn__at(call, call->layout.x);
        ms_nn__spread(nn, points / nn->channels, x, ms_nn__at(call, call->layout.x));
    }
    ms_nn__run_forward(&call->run);
    return MS_OK;
}

static ms_status ms_nn__end(ms_nn__call *call)
{
    ms__release(&call->run.nn->options.allocator, call->allocated, call->layout.total);
    return MS_OK;
}

/* A workspace for a call that was given none, so that nothing fails once outputs are written. */
static MS_NN__COLD ms_status ms_nn__lend(const ms_nn *nn, ms_nn_product product, int count, void **workspace,
                                         void **allocated)
{
    *allocated = NULL;
    if (nn == NULL || count < 1) return MS_INVALID_ARGUMENT;
    if (*workspace == NULL)
        *workspace = *allocated = ms_nn__alloc(&nn->options, ms_nn_workspace_size(nn, product, count));
    return *workspace == NULL ? MS_OUT_OF_MEMORY : MS_OK;
}

static MS_NN__COLD void ms_nn__give_back(const ms_nn *nn, ms_nn_product product, int count, void *allocated)
{
    if (allocated != NULL) ms__release(&nn->options.allocator, allocated, ms_nn_workspace_size(nn, product, count));
}

MS_API MS_NN__COLD ms_status ms_nn_forward(const ms_nn *nn, int count, const float *x, float *y, void *workspace)
{
    ms_nn__call call;
    void *allocated;
    int at, n;
    ms_status status = x == NULL || y == NULL ? MS_INVALID_ARGUMENT
                                              : ms_nn__lend(nn, MS_NN_FORWARD, count, &workspace, &allocated);
    if (status != MS_OK) return status;
    for (at = 0; at < count && status == MS_OK; at += n) {
        n = (int)ms_nn__min((size_t)(count - at), ms_nn__together(nn, MS_NN_FORWARD));
        status = ms_nn__begin(&call, nn, MS_NN_FORWARD, n, x + (size_t)at * ms_nn_input_size(nn),
                              y + (size_t)at * ms_nn_output_size(nn), workspace);
    }
    ms_nn__give_back(nn, MS_NN_FORWARD, count, allocated);
    return status;
}

static MS_NN__COLD ms_status ms_nn__vjp(const ms_nn *nn, int count, const float *x, const float *g_y, float *y,
                                        float *g_x, void *workspace)
{
    ms_nn__call call;
    ms_status status = ms_nn__begin(&call, nn, MS_NN_VJP, count, x, y, workspace);
    float *inner, *slots;
    size_t input, n, b, i;
    if (status != MS_OK) return status;
    slots = ms_nn__at(&call, call.layout.slots);
    inner = nn->channel_input ? ms_nn__at(&call, call.layout.dx) : g_x;
    memcpy(slots + nn->slot[nn->ops] * call.run.points, g_y,
           call.run.points * ms_nn__value_size(nn, nn->ops) * sizeof(float));
    ms_nn__run_gradients(&call.run, 1, inner, slots, ms_nn__at(&call, call.layout.skips));
    if (nn->channel_input) {
        input = ms_nn_input_size(nn);
        n = nn->channels * nn->channel_inputs;
        memset(g_x, 0, (size_t)count * input * sizeof(float));
        for (b = 0; b < (size_t)count; ++b)
            for (i = 0; i < n; ++i) g_x[b * input + nn->channel_input[i]] += inner[b * n + i];
    }
    return ms_nn__end(&call);
}

MS_API MS_NN__COLD ms_status ms_nn_vjp(const ms_nn *nn, int count, const float *x, const float *g_y, float *y,
                                       float *g_x, void *workspace)
{
    void *allocated;
    int at, n;
    ms_status status = x == NULL || g_y == NULL || g_x == NULL
        ? MS_INVALID_ARGUMENT
        : ms_nn__lend(nn, MS_NN_VJP, count, &workspace, &allocated);
    if (status != MS_OK) return status;
    for (at = 0; at < count && status == MS_OK; at += n) {
        size_t in = (size_t)at * ms_nn_input_size(nn), out = (size_t)at * ms_nn_output_size(nn);
        n = (int)ms_nn__min((size_t)(count - at), ms_nn__together(nn, MS_NN_VJP));
        status = ms_nn__vjp(nn, n, x + in, g_y + out, y ? y + out : NULL, g_x + in, workspace);
    }
    ms_nn__give_back(nn, MS_NN_VJP, count, allocated);
    return status;
}

MS_API MS_NN__COLD ms_status ms_nn_jvp(const ms_nn *nn, int count, const float *x, const float *dx, float *y, float *dy,
                                       void *workspace)
{
    ms_nn__call call;
    ms_status status = dx == NULL || dy == NULL ? MS_INVALID_ARGUMENT
                                                : ms_nn__begin(&call, nn, MS_NN_JVP, count, x, y, workspace);
    size_t c, d, i, out, in, n, at, each;
    float *inner, *slots, *result;
    if (status != MS_OK) return status;
    in = ms_nn_input_size(nn);
    out = ms_nn__value_size(nn, nn->ops);
    slots = ms_nn__at(&call, call.layout.slots);
    n = nn->channel_inputs;
    for (at = 0; at < (size_t)count; at += each) {
        each = ms_nn__min((size_t)count - at, call.layout.each);
        if (nn->channel_input == NULL) {
            ms_nn__run_directions(&call.run, each, dx + at * in, dy + at * out, slots);
            continue;
        }
        /* [each][input] to [channels][each][channel inputs] and back from [channels][each][output] */
        inner = ms_nn__at(&call, call.layout.dx);
        for (c = 0; c < nn->channels; ++c)
            for (d = at; d < at + each; ++d)
                for (i = 0; i < n; ++i) *inner++ = dx[d * in + nn->channel_input[c * n + i]];
        result = slots + nn->slot[nn->ops] * nn->channels * each;
        ms_nn__run_directions(&call.run, each, ms_nn__at(&call, call.layout.dx), NULL, slots);
        for (c = 0; c < nn->channels; ++c)
            for (d = 0; d < each; ++d)
                memcpy(dy + ((at + d) * nn->channels + c) * out, result + (c * each + d) * out, out * sizeof(float));
    }
    return ms_nn__end(&call);
}

/* The Jacobians of the points: element (o, i) of point c at c out in + o *row + i *column. Unit vectors in; columns of
   the Jacobians (forwards) or rows (backwards) out. */
static MS_NN__COLD const float *ms_nn__slopes(const ms_nn__call *call, size_t *row, size_t *column)
{
    const ms_nn *nn = call->run.nn;
    size_t out = ms_nn__value_size(nn, nn->ops), each = call->layout.each, c, i;
    float *slots = ms_nn__at(call, call->layout.slots), *dx = ms_nn__at(call, call->layout.dx),
          *dy = ms_nn__at(call, call->layout.dy);
    float *units = call->layout.backward ? slots + nn->slot[nn->ops] * call->run.points * each : dx;
    memset(units, 0, call->run.points * each * each * sizeof(float));
    for (c = 0; c < call->run.points; ++c)
        for (i = 0; i < each; ++i) units[(c * each + i) * each + i] = 1;
    if (call->layout.backward) ms_nn__run_gradients(&call->run, each, dx, slots, ms_nn__at(call, call->layout.skips));
    else ms_nn__run_directions(&call->run, each, dx, dy, slots);
    *row = call->layout.backward ? ms_nn__count(nn->inner) : 1;
    *column = call->layout.backward ? 1 : out;
    return call->layout.backward ? dx : dy;
}

MS_API MS_NN__COLD ms_status ms_nn_jacobian(const ms_nn *nn, const float *x, float *y, float *jacobian, void *workspace)
{
    ms_nn__call call;
    ms_status status = jacobian == NULL ? MS_INVALID_ARGUMENT
                                        : ms_nn__begin(&call, nn, MS_NN_JACOBIAN, 1, x, y, workspace);
    const float *slopes;
    size_t in, out, input, row, column, c, i, o;
    if (status != MS_OK) return status;
    in = ms_nn__count(nn->inner);
    out = ms_nn__value_size(nn, nn->ops);
    input = ms_nn_input_size(nn);
    slopes = ms_nn__slopes(&call, &row, &column);
    if (nn->channel_input) {
        memset(jacobian, 0, nn->channels * out * input * sizeof(float));
        for (c = 0; c < nn->channels; ++c)
            for (o = 0; o < out; ++o)
                for (i = 0; i < in; ++i)
                    jacobian[(c * out + o) * input + nn->channel_input[c * in + i]] +=
                        slopes[c * out * in + o * row + i * column];
    } else if (call.layout.backward) {
        memcpy(jacobian, slopes, out * in * sizeof(float));
    } else {
        ms_nn__transpose(slopes, in, out, jacobian);
    }
    return ms_nn__end(&call);
}

/* ---- queries --------------------------------------------------------------------------------------------------- */

static ms_nn_shape ms_nn__no_shape(void)
{
    ms_nn_shape none;
    memset(&none, 0, sizeof none);
    return none;
}

MS_API ms_nn_shape ms_nn_input_shape(const ms_nn *nn) { return nn ? nn->input : ms_nn__no_shape(); }
MS_API ms_nn_shape ms_nn_output_shape(const ms_nn *nn) { return nn ? nn->output : ms_nn__no_shape(); }

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
    none.type = none.name = none.activation = "";
    none.dtype = MS_NN_DTYPE_COUNT;
    return none;
}

MS_API const ms_nn_file *ms_nn_tensors(const ms_nn *nn) { return nn ? nn->file : NULL; }
MS_API ms_simd ms_nn_simd(const ms_nn *nn) { return nn ? nn->level : MS_SIMD_AUTO; }

MS_API MS_NN__COLD ms_status ms_nn_check_weights(const ms_nn *nn, ms_error *error)
{
    size_t t, i;
    if (nn == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nn is NULL");
    for (t = 0; t < ms_nn_file_tensor_count(nn->file); ++t) {
        const ms_nn_tensor *tensor = ms_nn_file_tensor(nn->file, t);
        size_t width = (size_t)(ms_nn__bits(tensor->dtype) / 8);
        if (tensor->dtype > MS_NN_BF16) continue; /* integers are finite */
        for (i = 0; i * width < tensor->bytes; ++i)
            if (!ms__finite(ms_nn__element(tensor->data, tensor->dtype, i)))
                return ms__fail(error, MS_BAD_DATA, i, "element %z of '%s' is %g", i, tensor->name,
                                ms_nn__element(tensor->data, tensor->dtype, i));
    }
    return MS_OK;
}

MS_API MS_NN__COLD void ms_nn_destroy(ms_nn *nn)
{
    ms_nn__block *b, *next;
    ms_allocator allocator;
    if (nn == NULL) return;
    allocator = nn->options.allocator;
    for (b = nn->blocks; b; b = next) {
        next = b->next;
        ms__release(&allocator, b, b->bytes);
    }
    ms_nn_file_close(nn->file);
    ms__release(&allocator, nn, sizeof *nn);
}

/* ---- GPU text -------------------------------------------------------------------------------------------------- */

/* A text as it is written; out is NULL while only counting. */
typedef struct ms_nn__text {
    char *out;
    size_t length;
    ms_nn_language language;
} ms_nn__text;

/* Appends format: $v and $i begin a declaration of four floats or an integer, $4 makes four floats, $I an integer, $L
   is what HLSL wants before a loop, $d the next number of n. */
static MS_NN__COLD void ms_nn__say(ms_nn__text *t, const char *format, const size_t *n)
{
    static const char key[] = "vi4IL",
                      word[3][5][11] = {{"vec4 ", "int ", "vec4", "int", ""},
                                        {"float4 ", "int ", "float4", "int", "[loop] "},
                                        {"var ", "var ", "vec4<f32>", "i32", ""}};
    for (; *format; ++format) {
        char digits[24];
        const char *s = digits;
        size_t length = 0, value;
        if (*format != '$') {
            s = format;
            length = 1;
        } else if (*++format == 'd') {
            for (value = *n++; length == 0 || value; value /= 10)
                digits[sizeof digits - ++length] = (char)('0' + value % 10);
            s = digits + sizeof digits - length;
        } else {
            s = word[t->language < MS_NN_HLSL ? 0 : (int)t->language - 2][strchr(key, *format) - key];
            length = strlen(s);
        }
        if (t->out) memcpy(t->out + t->length, s, length);
        t->length += length;
    }
}

static MS_NN__COLD int ms_nn__plain(const ms_nn__op *op)
{
    return op->step == MS_NN__DO_ACTIVATE || op->step == MS_NN__DO_ADD;
}

/* Four values, and their rows: what a dense layer has of texels. */
static MS_NN__COLD size_t ms_nn__fours(size_t n) { return n / 4 + (n % 4 != 0); }
static MS_NN__COLD size_t ms_nn__texels(const ms_nn__matrix *m)
{
    return ms__size_mul(ms_nn__fours(m->rows), ms__size_add(4 * ms_nn__fours(m->cols), 1));
}

/* The operations [first, end) of a step, sizes, and where its weights begin; NULL as shader: of the whole network. */
typedef struct ms_nn__shader_step {
    ms_nn_shader_sizes sizes;
    int first, end, planes; /* planes: a picture's of one row; 0: values */
    size_t base;
} ms_nn__shader_step;

static MS_NN__COLD ms_status ms_nn__shader_plan(const ms_nn *nn, const ms_nn_shader *s, ms_nn__shader_step *p,
                                                ms_error *error)
{
    int i, k, dense = 0, seen = 0, last;
    size_t texels = 0, pixels, outputs;
    if (nn == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "nn is NULL");
    memset(p, 0, sizeof *p);
    for (i = 0; i < nn->ops; ++i) {
        const ms_nn__op *op = &nn->op[i];
        const ms_nn_layer *layer = &nn->layer[op->layer];
        if (op->step == MS_NN__DO_DENSE) {
            ++dense;
            texels = ms__size_add(texels, ms_nn__texels(&op->matrix));
        } else if (!ms_nn__plain(op) || dense == 0 || op->in.h * op->in.w > 1 || !(op->alpha < 1000.0f)) {
            return ms__fail(
                error, MS_UNSUPPORTED, 0,
                "layer %d, %s '%s', has no shader: only dense layers and, after them, activations and additions have",
                op->layer, layer->type, layer->name);
        }
    }
    p->sizes.weight_rows =
        (int)(ms_nn__min(texels, (size_t)MS_NN_SHADER_WIDTH * MS_NN_SHADER_ROWS_MAX + 1) / MS_NN_SHADER_WIDTH + 1);
    if (dense == 0 || p->sizes.weight_rows > MS_NN_SHADER_ROWS_MAX || nn->channels > MS_NN_SHADER_ROWS_MAX ||
        ms_nn__value_size(nn, 0) > INT_MAX / 4)
        return ms__fail(error, MS_UNSUPPORTED, 0,
                        dense ? "the network is too large for a texture" : "the network has no dense layer");
    p->sizes.rows = (int)nn->channels;
    p->sizes.input_width = (int)ms_nn__fours(ms_nn__value_size(nn, 0));
    p->sizes.steps = s && s->steps ? s->steps : dense > 1 ? 2 : 1;
    if (s == NULL) return MS_OK;
    if ((int)s->language < 0 || (int)s->language > (int)MS_NN_WGSL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "language %d is unknown", (int)s->language);
    if (p->sizes.steps < 1 || p->sizes.steps > dense || s->step < 0 || s->step >= p->sizes.steps)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "step %d of %d: the network has %d dense layers", s->step,
                        p->sizes.steps, dense);
    last = dense - p->sizes.steps + s->step; /* the dense layer that the step ends with */
    for (i = 0; i < nn->ops && seen <= last + 1; ++i) {
        seen += nn->op[i].step == MS_NN__DO_DENSE;
        if (s->step > 0 && seen <= last) p->first = i + 1;
        if (s->step > 0 && seen <= last && nn->op[i].step == MS_NN__DO_DENSE)
            p->base += ms_nn__texels(&nn->op[i].matrix);
        if (seen <= last + 1) p->end = i + 1;
    }
    for (k = p->first; k < p->end; ++k)
        if (nn->op[k].step == MS_NN__DO_ADD && nn->op[k].skip < p->first)
            return ms__fail(error, MS_UNSUPPORTED, 0,
                            "layer %d adds what a step before this one made: %d steps are too many", nn->op[k].layer,
                            p->sizes.steps);
    p->sizes.input_width = (int)ms_nn__fours(ms_nn__value_size(nn, p->first));
    outputs = ms_nn__value_size(nn, p->end);
    p->sizes.target_width = (int)ms_nn__fours(outputs);
    if (s->step < p->sizes.steps - 1 || (s->width == 0 && s->height == 0)) return MS_OK;
    pixels = s->width > 0 && s->height > 0 ? ms__size_mul((size_t)s->width, (size_t)s->height) : 0;
    if (pixels == 0 || outputs % pixels || outputs / pixels * nn->channels > 4)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%d x %d pixels: %z outputs are not one to four such planes",
                        s->width, s->height, outputs * nn->channels);
    if (p->sizes.steps == 1 && dense > 1)
        return ms__fail(error, MS_UNSUPPORTED, 0, "pictures of %d dense layers need two steps", dense);
    for (k = p->first; k < p->end; ++k)
        if (nn->op[k].step == MS_NN__DO_ADD)
            return ms__fail(error, MS_UNSUPPORTED, 0,
                            "layer %d, an addition, stands behind the last dense layer: pictures have none",
                            nn->op[k].layer);
    p->planes = (int)(outputs / pixels);
    p->sizes.target_width = s->width;
    return MS_OK;
}

/* What stands before main: a language's first lines and its names for what is read; then for GLSL, HLSL and WGSL
   how. */
static const char *const ms_nn__shader_names[5][2] = {
    {"#version 330\nuniform sampler2D ms_nn_weights, ms_nn_values;\n", "uniform vec4 ms_nn;\n"},
    {"#version 300 es\nprecision highp float;\nprecision highp int;\nuniform highp sampler2D ms_nn_weights, ms_nn_values;\n",
     "uniform vec4 ms_nn;\n"},
    {"#version 450\nlayout(set = 0, binding = 1) uniform sampler2D ms_nn_weights;\nlayout(set = 0, binding = 2) uniform sampler2D ms_nn_values;\n",
     "layout(set = 0, binding = 0) uniform ms_nn_block { vec4 ms_nn; };\n"},
    {"Texture2D<float4> ms_nn_weights : register(t0), ms_nn_values : register(t1);\n",
     "cbuffer ms_nn_block : register(b0) { float4 ms_nn; };\n"},
    {"@group(0) @binding(1) var ms_nn_weights: texture_2d<f32>;\n@group(0) @binding(2) var ms_nn_values: texture_2d<f32>;\n",
     "@group(0) @binding(0) var<uniform> ms_nn: vec4<f32>;\n"}};
static const char *const ms_nn__shader_main[3] = {
    "vec4 weight(int i) { return texelFetch(ms_nn_weights, ivec2(i & 2047, i >> 11), 0); }\n"
    "vec4 value(int i, int row) { return texelFetch(ms_nn_values, ivec2(i, row), 0); }\n"
    "layout(location = 0) out vec4 ms_nn_target;\nvec4 shade(vec4 position);\nvoid main() { ms_nn_target = shade(gl_FragCoord); }\nvec4 shade(vec4 position)\n{\n",
    "float4 weight(int i) { return ms_nn_weights.Load(int3(i & 2047, i >> 11, 0)); }\n"
    "float4 value(int i, int row) { return ms_nn_values.Load(int3(i, row, 0)); }\nfloat4 main(float4 position : SV_Position) : SV_Target\n{\n",
    "fn weight(i: i32) -> vec4<f32> { return textureLoad(ms_nn_weights, vec2<i32>(i & 2047, i >> 11u), 0); }\n"
    "fn value(i: i32, row: i32) -> vec4<f32> { return textureLoad(ms_nn_values, vec2<i32>(i, row), 0); }\n"
    "@fragment\nfn main(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32>\n{\n"};

/* x becomes its activation; z is |x|, so that (x + z) / 2 is its positive part in every language. $d.$d: alpha, in
   millionths. The normal distribution: Abramowitz and Stegun 7.1.26, within 1.5e-7. */
static const char *const ms_nn__shader_activation[] = {
    "",
    "0.5 * (x + z)",
    "0.5 * (x + z) + $d.$d$d$d$d$d$d * 0.5 * (x - z)",
    "0.5 * (x + z) + $d.$d$d$d$d$d$d * (exp(0.5 * (x - z)) - 1.0)",
    "sign(x) * (1.0 - exp(-2.0 * z)) / (1.0 + exp(-2.0 * z))",
    "0.5 + 0.5 * sign(x) * (1.0 - exp(-z)) / (1.0 + exp(-z))",
    "0.5 * (x + z) + log(1.0 + exp(-z))",
    "x * (0.5 + 0.5 * sign(x) * (1.0 - exp(-z)) / (1.0 + exp(-z)))",
    "0.5 * (x + z) - z * exp(-0.5 * z * z) * t * (0.127414796 + t * (-0.142248368 + t * (0.7107068705 + t * (-0.7265760135 + t * 0.5307027145))))"};

static MS_NN__COLD void ms_nn__say_activation(ms_nn__text *t, const ms_nn__op *op)
{
    size_t n[7], millionths = (size_t)((double)op->alpha * 1e6 + 0.5), i;
    for (i = 6; i > 0; --i, millionths /= 10) n[i] = millionths % 10;
    n[0] = millionths;
    ms_nn__say(t,
               op->activation == MS_NN__GELU ? "{ $v z = abs(x); $v t = 1.0 / (1.0 + 0.2316418882 * z); x = "
                                             : "{ $v z = abs(x); x = ",
               n);
    ms_nn__say(t, ms_nn__shader_activation[op->activation], n);
    ms_nn__say(t, "; }\n", n);
}

/* Operations [k, end): a dense layer and what follows it, of the four outputs u; from: the value that it reads, as [j],
   or the step's first. inner: the values that it makes are kept for all u. */
static MS_NN__COLD void ms_nn__say_dense(ms_nn__text *t, const ms_nn *nn, int first, int k, int end, size_t base,
                                         int inner)
{
    const ms_nn__matrix *m = &nn->op[k].matrix;
    size_t n[3], cols = ms_nn__fours(m->cols), rows = ms_nn__fours(m->rows);
    int start = k;
    n[0] = (size_t)k;
    n[1] = base + 4 * rows * cols;
    n[2] = cols;
    ms_nn__say(t, "$v x = weight(u + ", n);
    ms_nn__say(t, "$d);\n$Lfor ($i j = 0; j < $d; j++) {\n", n + 1);
    ms_nn__say(t, k == first ? "$v a = value(j, row);\n" : "$v a = v$d[j];\n", n);
    n[0] = cols;
    n[1] = base;
    ms_nn__say(
        t,
        "$i i = (u * $d + j) * 4 + $d;\nx = x + $4(dot(weight(i), a), dot(weight(i + 1), a), dot(weight(i + 2), a), dot(weight(i + 3), a));\n}\n",
        n);
    for (; k < end; ++k) {
        const ms_nn__op *op = &nn->op[k];
        n[0] = (size_t)op->skip;
        if (op->step == MS_NN__DO_ADD)
            ms_nn__say(t,
                       op->skip == first                ? "x = x + value(u, row);\n"
                           : inner || op->skip <= start ? "x = x + v$d[u];\n"
                                                        : "x = x + v$d;\n",
                       n);
        if (op->activation != MS_NN__LINEAR) ms_nn__say_activation(t, op);
        n[0] = (size_t)k + 1;
        ms_nn__say(t, inner ? "v$d[u] = x;\n" : "$v v$d = x;\n", n);
    }
}

/* The channels of a pixel. row: of the first; at: the pixel in its plane. */
static MS_NN__COLD void ms_nn__say_pixel(ms_nn__text *t, const ms_nn *nn, const ms_nn__shader_step *p,
                                         const ms_nn_shader *s)
{
    const ms_nn__matrix *m = &nn->op[p->first].matrix;
    size_t n[6], cols = ms_nn__fours(m->cols), q, c, planes = (size_t)p->planes, outs = planes * nn->channels;
    int k;
    n[0] = n[4] = n[5] = (size_t)s->width;
    n[1] = n[3] = (size_t)s->height;
    n[2] = nn->channels;
    ms_nn__say(
        t,
        "$i left = $I(position.x);\n$i top = $I(position.y);\nif (ms_nn.z > 0.0) { top = $I(ms_nn.z) - 1 - top; }\n"
        "$i column = left / $d;\n$i across = top / $d;\n$i picture = across * $I(ms_nn.x) + column;\n"
        "if (column >= $I(ms_nn.x) || picture >= $I(ms_nn.y)) { return $4(0.0, 0.0, 0.0, 0.0); }\n"
        "$i row = picture * $d;\n$i pixel = (top - across * $d) * $d + left - column * $d;\n$v x = $4(0.0, 0.0, 0.0, 0.0);\n",
        n);
    for (q = 0; q < planes; ++q) {
        n[0] = n[1] = n[3] = n[5] = q;
        n[2] = q * (size_t)s->width * (size_t)s->height;
        ms_nn__say(t, "$i u$d = pixel + ", n);
        ms_nn__say(t, "$d;\n", n + 2);
        n[2] = p->base + 4 * ms_nn__fours(m->rows) * cols;
        n[1] = q;
        ms_nn__say(t, "$v b$d = weight((u$d >> 2) + ", n);
        n[0] = n[2];
        ms_nn__say(t, "$d);\n", n);
        for (c = 0; c < nn->channels; ++c) {
            n[0] = c * planes + q;
            n[1] = n[2] = q;
            ms_nn__say(t, "x[$d] = b$d[u$d & 3];\n", n);
        }
    }
    n[0] = cols;
    ms_nn__say(t, "$Lfor ($i j = 0; j < $d; j++) {\n", n);
    for (c = 0; c < nn->channels; ++c) {
        n[0] = n[1] = c;
        ms_nn__say(t, "$v a$d = value(j, row + $d);\n", n);
    }
    for (q = 0; q < planes; ++q) {
        n[0] = n[1] = n[3] = q;
        n[2] = cols;
        n[4] = p->base;
        ms_nn__say(t, "$v w$d = weight(((u$d >> 2) * $d + j) * 4 + (u$d & 3) + $d);\n", n);
        for (c = 0; c < nn->channels; ++c) {
            n[0] = n[1] = c * planes + q;
            n[2] = q;
            n[3] = c;
            ms_nn__say(t, "x[$d] = x[$d] + dot(w$d, a$d);\n", n);
        }
    }
    ms_nn__say(t, "}\n", n);
    for (k = p->first; k < p->end; ++k)
        if (nn->op[k].activation != MS_NN__LINEAR) ms_nn__say_activation(t, &nn->op[k]);
    ms_nn__say(t, outs == 1 ? "x[1] = x[0];\nx[2] = x[0];\n" : outs == 2 ? "x[2] = 0.0;\n" : "", n);
    ms_nn__say(t, outs < 4 ? "x[3] = 1.0;\nreturn x;\n}\n" : "return x;\n}\n", n);
}

static MS_NN__COLD void ms_nn__say_shader(ms_nn__text *t, const ms_nn *nn, const ms_nn__shader_step *p,
                                          const ms_nn_shader *s)
{
    int k, end;
    size_t base = p->base, n[2];
    ms_nn__say(t, ms_nn__shader_names[s->language][0], NULL);
    if (p->planes) ms_nn__say(t, ms_nn__shader_names[s->language][1], NULL);
    ms_nn__say(t, ms_nn__shader_main[s->language < MS_NN_HLSL ? 0 : (int)s->language - 2], NULL);
    if (p->planes) {
        ms_nn__say_pixel(t, nn, p, s);
        return;
    }
    ms_nn__say(t, "$i row = $I(position.y);\n", NULL);
    for (k = p->first; k < p->end; k = end) {
        for (end = k + 1; end < p->end && nn->op[end].step != MS_NN__DO_DENSE;) ++end;
        if (end < p->end) {
            int v;
            for (v = k + 1; v <= end; ++v) {
                n[0] = (size_t)v;
                n[1] = ms_nn__fours(ms_nn__value_size(nn, v));
                if (t->language == MS_NN_WGSL) ms_nn__say(t, "var v$d: array<vec4<f32>, $d>;\n", n);
                else ms_nn__say(t, "$4 v$d[$d];\n", n);
            }
            n[0] = ms_nn__fours(nn->op[k].matrix.rows);
            ms_nn__say(t, "$Lfor ($i u = 0; u < $d; u++) {\n", n);
        } else {
            ms_nn__say(t, "$i u = $I(position.x);\n", NULL);
        }
        ms_nn__say_dense(t, nn, p->first, k, end, base, end < p->end);
        ms_nn__say(t, end < p->end ? "}\n" : "return x;\n}\n", NULL);
        base += ms_nn__texels(&nn->op[k].matrix);
    }
}

MS_API MS_NN__COLD ms_status ms_nn_shader_layout(const ms_nn *nn, const ms_nn_shader *shader, ms_nn_shader_sizes *sizes,
                                                 ms_error *error)
{
    ms_nn__shader_step p;
    ms_status status;
    if (shader == NULL || sizes == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "shader or sizes is NULL");
    if ((status = ms_nn__shader_plan(nn, shader, &p, error)) == MS_OK) *sizes = p.sizes;
    return status;
}

MS_API MS_NN__COLD size_t ms_nn_shader_text(const ms_nn *nn, const ms_nn_shader *shader, char *text, size_t capacity,
                                            ms_error *error)
{
    ms_nn__shader_step p;
    ms_nn__text t;
    if (shader == NULL) ms__fail(error, MS_INVALID_ARGUMENT, 0, "shader is NULL");
    if (shader == NULL || ms_nn__shader_plan(nn, shader, &p, error) != MS_OK) return 0;
    memset(&t, 0, sizeof t);
    t.language = shader->language;
    ms_nn__say_shader(&t, nn, &p, shader);
    if (text && capacity > t.length) {
        t.out = text;
        t.length = 0;
        ms_nn__say_shader(&t, nn, &p, shader);
        text[t.length] = 0;
    }
    return t.length;
}

MS_API MS_NN__COLD ms_status ms_nn_shader_weights(const ms_nn *nn, ms_nn_dtype dtype, void *out, ms_error *error)
{
    ms_nn__shader_step p;
    ms_status status = ms_nn__shader_plan(nn, NULL, &p, error);
    unsigned char *to = (unsigned char *)out;
    size_t size = dtype == MS_NN_F16 ? 2 : 4, r, c;
    int k, pass;
    if (status != MS_OK) return status;
    if (out == NULL || (dtype != MS_NN_F16 && dtype != MS_NN_F32))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "out is NULL, or dtype is neither F16 nor F32");
    for (pass = 0; pass < 2; ++pass) { /* checks, then writes */
        if (pass) memset(out, 0, (size_t)p.sizes.weight_rows * MS_NN_SHADER_WIDTH * 4 * size);
        for (k = 0; k < nn->ops; ++k) {
            const ms_nn__matrix *m = &nn->op[k].matrix;
            size_t cols = ms_nn__fours(m->cols), q;
            if (nn->op[k].step != MS_NN__DO_DENSE) continue;
            for (r = 0; r < m->rows; ++r)
                for (c = 0; c <= m->cols; ++c) { /* behind the last column the bias */
                    size_t at = r * m->cols + c;
                    float v = c == m->cols      ? m->bias ? ms_nn__float_at(m->bias, r) : 0.0f
                        : m->dtype == MS_NN_F32 ? ms_nn__float_at(m->w, at)
                                                : (float)ms_nn__element(m->w, m->dtype, at);
                    uint16_t half;
                    if (c < m->cols && m->scale) v *= ms_nn__float_at(m->scale, r);
                    if (size == 2 && fabsf(v) > 65504.0f)
                        return ms__fail(error, MS_UNSUPPORTED, 0, "a weight of '%s' is %g, more than F16 holds",
                                        nn->layer[nn->op[k].layer].name, (double)v);
                    if (!pass) continue;
                    q = c < m->cols ? (r / 4 * cols + c / 4) * 16 + r % 4 * 4 + c % 4
                                    : ms_nn__fours(m->rows) * cols * 16 + r;
                    half = ms__half_from_float(v);
                    if (size == 2) memcpy(to + 2 * q, &half, 2);
                    else memcpy(to + 4 * q, &v, 4);
                }
            if (pass) to += ms_nn__texels(m) * 4 * size;
        }
    }
    return MS_OK;
}

MS_API MS_NN__COLD ms_status ms_nn_shader_inputs(const ms_nn *nn, int count, const float *x, float *out)
{
    size_t inputs = ms_nn_input_size(nn), one, width, r, i;
    if (nn == NULL || count < 1 || x == NULL || out == NULL) return MS_INVALID_ARGUMENT;
    one = ms_nn__value_size(nn, 0);
    width = 4 * ms_nn__fours(one);
    for (r = 0; r < (size_t)count * nn->channels; ++r, out += width)
        for (i = 0; i < width; ++i)
            out[i] = i < one ? x[r / nn->channels * inputs +
                                 (nn->channel_input ? nn->channel_input[r % nn->channels * nn->channel_inputs + i] : i)]
                             : 0.0f;
    return MS_OK;
}

/* ---- stdio ----------------------------------------------------------------------------------------------------- */

#ifndef MS_NN_NO_STDIO
/* A regular file mapped read-only; *bytes NULL where that is not possible. */
static void ms_nn__map(const char *path, const void **bytes, size_t *size)
{
#ifdef MS_NN__MMAP
    struct stat info;
    int fd = open(path, O_RDONLY);
    if (fd < 0) return;
    if (fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0 && (uint64_t)info.st_size < SIZE_MAX) {
        void *at = mmap(NULL, (size_t)info.st_size, PROT_READ, MAP_PRIVATE, fd, 0);
        if (at != MAP_FAILED) {
            *bytes = at;
            *size = (size_t)info.st_size;
        }
    }
    close(fd);
#else
    (void)path;
    (void)bytes;
    (void)size;
#endif
}

/* A whole stream into one allocation of *size bytes, of which *used are the file. */
static ms_status ms_nn__slurp(const char *path, const ms_nn_options *o, void **bytes, size_t *size, size_t *used,
                              ms_error *error)
{
    FILE *f = fopen(path, "rb");
    char *at = NULL, *larger;
    ms_status status = MS_OK;
    if (f == NULL) return ms__fail(error, MS_IO, 0, "cannot open '%s'", path);
    *size = *used = 0;
    for (;;) {
        size_t got;
        if (*used == *size) {
            size_t room = *size ? ms__size_mul(*size, 2) : 65536;
            larger = (char *)ms_nn__alloc(o, room);
            if (larger && *used) memcpy(larger, at, *used);
            ms__release(&o->allocator, at, *size);
            at = larger;
            *size = room;
            if (at == NULL) {
                status = ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for '%s'", path);
                break;
            }
        }
        got = fread(at + *used, 1, *size - *used, f);
        *used += got;
        if (got == 0) break;
    }
    if (status == MS_OK && ferror(f)) status = ms__fail(error, MS_IO, *used, "cannot read '%s'", path);
    fclose(f);
    if (status != MS_OK) ms__release(&o->allocator, at, *size);
    *bytes = at;
    return status;
}

MS_API MS_NN__COLD ms_status ms_nn_file_read(const char *path, const ms_nn_options *options, ms_nn_file **file,
                                             ms_error *error)
{
    ms_nn_options o = options ? *options : ms_nn_defaults();
    const void *mapped = NULL;
    void *block = NULL;
    size_t size = 0, used;
    ms_status status;
    if (path == NULL || file == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", path == NULL ? "path" : "file");
    if (!o.copy) ms_nn__map(path, &mapped, &size);
    used = size;
    if (mapped == NULL && (status = ms_nn__slurp(path, &o, &block, &size, &used, error)) != MS_OK) return status;
    status = ms_nn_file_open(mapped ? mapped : block, used, &o, file, error);
    if (status != MS_OK) {
        ms_nn__release_content(&o.allocator, mapped ? mapped : block, size, mapped != NULL);
        return status;
    }
    (*file)->content = mapped ? mapped : block;
    (*file)->content_bytes = size;
    (*file)->content_is_mapped = mapped != NULL;
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

MS_API MS_NN__COLD ms_status ms_nn_file_save(const char *path, const ms_nn_tensor *tensors, size_t count,
                                             const ms_nn_entry *metadata, size_t entries, const ms_allocator *allocator,
                                             ms_error *error)
{
    ms_nn_sink sink;
    ms__file file;
    ms_status status = ms__file_open(&file, path, error);
    if (status != MS_OK) return status;
    sink.user = &file;
    sink.write = ms__file_write;
    status = ms_nn_file_write(tensors, count, metadata, entries, allocator, sink, error);
    return ms__file_close(&file, status, error);
}
#endif /* MS_NN_NO_STDIO */

#ifndef MS_NN_NO_COLLAPSE
/* ---- collapse -------------------------------------------------------------------------------------------------- */

struct ms_nn_collapse {
    ms_nn trunk; /* the network without its last layer: a view, it owns nothing */
    const ms_nn *nn;
    const ms_nn__matrix *m; /* W, b */
    size_t channels, h;     /* features of a channel */
    size_t bytes;
    float *weight;  /* [channels][rows] diagonal of M */
    size_t *owner;  /* [channels] the first channel with the same weights, which holds R for them */
    double *r;      /* [channels][h][h] upper triangles, full rows */
    double *packed; /* [h (h + 1) / 2] the first without its zeros */
    double *h0, *e; /* [channels][h] of the target */
    double rest;
    int has_target, weighted;
};

#define MS_NN__QR_ROWS 128 /* of a block that is folded into R */
#define MS_NN__QR_PANEL 16 /* columns that are reflected together */
#define MS_NN__QR_PARTS 8  /* of the rows; joined in order */

/* Folds the rows of B into R: Householder QR of [R; B] in panels, I - V T V' with V = [I; B] (compact WY: Schreiber and
   Van Loan 1989).
   r  [h][h], b  [h][rows], column by column, destroyed */
static MS_NN__COLD void ms_nn__qr_fold(const ms_nn__kernels *kernels, double *r, size_t h, double *b, size_t rows)
{
    double t[MS_NN__QR_PANEL][MS_NN__QR_PANEL], z[MS_NN__QR_PANEL * 2], y[MS_NN__QR_PANEL], tau, dot;
    size_t j0, j, i, k, n, q;
    for (j0 = 0; j0 < h; j0 += n) {
        n = ms_nn__min(MS_NN__QR_PANEL, h - j0);
        memset(t, 0, sizeof t);
        for (j = 0; j < n; ++j) {
            double *bj = b + (j0 + j) * rows, *rj = r + (j0 + j) * h, alpha = rj[j0 + j], norm, beta;
            kernels->gram(bj, 1, bj, 1, rows, rows, &norm);
            if (!(norm > 0)) continue; /* nothing to eliminate: tau = 0 */
            beta = sqrt(alpha * alpha + norm);
            if (alpha > 0) beta = -beta;
            tau = (beta - alpha) / beta;
            for (i = 0; i < rows; ++i) bj[i] /= alpha - beta;
            rj[j0 + j] = beta;
            for (k = j + 1; k < n; ++k) {
                double *bk = b + (j0 + k) * rows;
                kernels->gram(bj, 1, bk, 1, rows, rows, &dot);
                dot = -tau * (rj[j0 + k] + dot);
                rj[j0 + k] += dot;
                kernels->add(bk, 1, bj, 1, rows, rows, &dot);
            }
            /* T(0..j, j) = -tau T V' v_j, the identity parts of V being orthogonal */
            kernels->gram(b + j0 * rows, j, bj, 1, rows, rows, y);
            for (i = 0; i < j; ++i)
                for (k = i; k < j; ++k) t[i][j] -= tau * t[i][k] * y[k];
            t[j][j] = tau;
        }
        for (k = j0 + n; k < h; k += q) {
            q = ms_nn__min(2, h - k);
            kernels->gram(b + j0 * rows, n, b + k * rows, q, rows, rows, z);
            for (i = 0; i < n; ++i)
                for (j = 0; j < q; ++j) z[i * q + j] += r[(j0 + i) * h + k + j];
            for (j = 0; j < q; ++j) {
                for (i = n; i-- > 0;) { /* z = -T' z, in place from below */
                    size_t l;
                    double sum = 0;
                    for (l = 0; l <= i; ++l) sum += t[l][i] * z[l * q + j];
                    z[i * q + j] = -sum;
                    r[(j0 + i) * h + k + j] += z[i * q + j];
                }
            }
            kernels->add(b + k * rows, q, b + j0 * rows, n, rows, rows, z);
        }
    }
}

typedef struct ms_nn__qr_job {
    const ms_nn__matrix *m;
    const ms_nn__kernels *kernels;
    const float *weight; /* [rows] */
    double *r;           /* [parts][h][h] */
    double *b;           /* [parts][h][MS_NN__QR_ROWS] */
    double *row;         /* [parts][h] */
    size_t parts;
} ms_nn__qr_job;

/* sqrt(m_i) w_i as column k of a block of `rows` columns. */
static void ms_nn__qr_row(const ms_nn__matrix *m, const ms_nn__kernels *kernels, size_t i, double weight, double *row,
                          double *b, size_t rows)
{
    size_t k;
    kernels->row(m, i, sqrt(weight), row);
    for (k = 0; k < m->cols; ++k) b[k * rows] = row[k];
}

static void ms_nn__qr_task(void *context, int index)
{
    const ms_nn__qr_job *job = (const ms_nn__qr_job *)context;
    size_t part = (size_t)index, h = job->m->cols, i = job->m->rows * part / job->parts,
           end = job->m->rows * (part + 1) / job->parts, n, k;
    double *r = job->r + part * h * h, *b = job->b + part * h * MS_NN__QR_ROWS;
    memset(r, 0, h * h * sizeof(double));
    while (i < end) {
        n = ms_nn__min(MS_NN__QR_ROWS, end - i);
        for (k = 0; k < n; ++k)
            ms_nn__qr_row(job->m, job->kernels, i + k, (double)job->weight[i + k], job->row + part * h, b + k, n);
        ms_nn__qr_fold(job->kernels, r, h, b, n);
        i += n;
    }
}

#define MS_NN__GRAM_ROWS 248 /* of W together */
#define MS_NN__GRAM_STRIDE \
    264 /* doubles from column to column: no power of two, which one set of the cache would hold */

/* A part's W' M W: upper triangle, rows i of columns k >= i. */
static MS_NN__COLD void ms_nn__gram_task(void *context, int index)
{
    const ms_nn__qr_job *job = (const ms_nn__qr_job *)context;
    size_t part = (size_t)index, h = job->m->cols, i = job->m->rows * part / job->parts,
           end = job->m->rows * (part + 1) / job->parts, n = 0, j, k, l, q;
    double *r = job->r + part * h * h, *b = job->b + part * h * MS_NN__GRAM_STRIDE, *row = job->row + part * 3 * h,
           *dots = row + h; /* dots: [h][2] */
    memset(r, 0, h * h * sizeof(double));
    for (; i <= end; ++i) {
        if (n == MS_NN__GRAM_ROWS || (i == end && n > 0)) {
            for (k = 0; k < h; k += q) {
                q = ms_nn__min(2, h - k);
                job->kernels->gram(b, k + q, b + k * MS_NN__GRAM_STRIDE, q, MS_NN__GRAM_STRIDE, n, dots);
                for (j = 0; j < k + q; ++j)
                    for (l = 0; l < q; ++l) r[j * h + k + l] += dots[j * q + l];
            }
            n = 0;
        }
        if (i < end && job->weight[i] > 0)
            ms_nn__qr_row(job->m, job->kernels, i, (double)job->weight[i], row, b + n++, MS_NN__GRAM_STRIDE);
    }
}

/* R of sqrt(M) W by the Cholesky factor of W' M W: some times as fast as a QR, but good to 1e-16 over the square of how
   much of a column the others leave. 0 where that is under 1e-8: the columns then want a QR. */
static MS_NN__COLD int ms_nn__collapse_gram(const ms_nn_collapse *c, const float *weight, double *r)
{
    const ms_nn_options *o = &c->nn->options;
    size_t h = c->h, parts = ms_nn__min(MS_NN__QR_PARTS, c->m->rows / 1024 + 1), bytes, p, i, k;
    int good = 1;
    ms_nn__qr_job job;
    bytes = ms__size_mul(parts * sizeof(double), ms__size_mul(h, ms__size_add(h, MS_NN__GRAM_STRIDE + 3)));
    job.m = c->m;
    job.kernels = c->nn->kernels;
    job.weight = weight;
    job.parts = parts;
    job.r = (double *)ms_nn__alloc(o, bytes);
    if (job.r == NULL) return 0;
    job.b = job.r + parts * h * h;
    job.row = job.b + parts * h * MS_NN__GRAM_STRIDE;
    ms__run(&o->parallel, (int)parts, ms_nn__gram_task, &job);
    for (p = 1; p < parts; ++p)
        for (i = 0; i < h * h; ++i) job.r[i] += job.r[p * h * h + i];
    for (i = 0; i < h; ++i) job.row[i] = job.r[i * h + i];
    for (k = 0; k < h && good; ++k) {
        double *column = job.r + k * h, pivot = column[k], minus;
        good = pivot > 1e-8 * job.row[k];
        for (i = k; i < h && good; ++i) column[i] /= sqrt(pivot);
        for (i = k + 1; i < h && good; ++i) {
            minus = -column[i];
            c->nn->kernels->add(job.r + i * h + i, 1, column + i, 1, h, h - i, &minus);
        }
    }
    for (i = 0; i < h && good; ++i)
        for (k = 0; k < h; ++k) r[i * h + k] = k < i ? 0.0 : job.r[i * h + k];
    ms__release(&o->allocator, job.r, bytes);
    return good;
}

/* R of sqrt(M) W into r for the weights of a channel. */
static MS_NN__COLD ms_status ms_nn__collapse_factor(const ms_nn_collapse *c, const float *weight, double *r,
                                                    ms_error *error)
{
    const ms_nn_options *o = &c->nn->options;
    size_t h = c->h, parts = ms_nn__min(MS_NN__QR_PARTS, c->m->rows / (4 * h) + 1), r_bytes, b_bytes, p, i, k, n;
    ms_nn__qr_job job;
    if (c->weighted && ms_nn__collapse_gram(c, weight, r)) return MS_OK;
    r_bytes = ms__size_mul(parts * sizeof(double), ms__size_mul(h, h));
    b_bytes = ms__size_mul(parts, ms__size_mul(h, (MS_NN__QR_ROWS + 1) * sizeof(double)));
    job.m = c->m;
    job.kernels = c->nn->kernels;
    job.weight = weight;
    job.parts = parts;
    job.r = (double *)ms_nn__alloc(o, r_bytes);
    job.b = (double *)ms_nn__alloc(o, b_bytes);
    if (job.r && job.b) {
        job.row = job.b + parts * h * MS_NN__QR_ROWS;
        ms__run(&o->parallel, (int)parts, ms_nn__qr_task, &job);
        for (p = 1; p < parts; ++p) /* the rows of each further R, a block at a time */
            for (i = 0; i < h; i += n) {
                n = ms_nn__min(MS_NN__QR_ROWS, h - i);
                for (k = 0; k < h * n; ++k) job.b[k] = job.r[p * h * h + (i + k % n) * h + k / n];
                ms_nn__qr_fold(job.kernels, job.r, h, job.b, n);
            }
        memcpy(r, job.r, h * h * sizeof(double));
    }
    ms__release(&o->allocator, job.b, b_bytes);
    ms__release(&o->allocator, job.r, r_bytes);
    return job.r && job.b ? MS_OK : ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a QR of %z features", h);
}

/* The first channel whose weights are those of channel ch. */
static size_t ms_nn__collapse_owner(const float *weight, size_t rows, size_t ch)
{
    size_t first = 0;
    while (memcmp(weight + first * rows, weight + ch * rows, rows * sizeof(float)) != 0) ++first;
    return first;
}

static void ms_nn__collapse_pack(ms_nn_collapse *c)
{
    double *to = c->packed;
    size_t i, k;
    for (i = 0; i < c->h; ++i)
        for (k = i; k < c->h; ++k) *to++ = c->r[i * c->h + k];
    c->has_target = 0;
}

/* The network up to its last layer's input, as a view. */
static MS_NN__COLD ms_nn ms_nn__trunk(const ms_nn *nn)
{
    ms_nn t = *nn;
    int v;
    t.ops--;
    t.tapes = nn->tape[nn->ops];
    t.slots = 0;
    for (v = 0; v <= t.ops; ++v)
        if (nn->slot[v] + ms_nn__value_size(nn, v) > t.slots) t.slots = nn->slot[v] + ms_nn__value_size(nn, v);
    return t;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_create(const ms_nn *nn, const float *weight, ms_nn_collapse **c,
                                                   ms_error *error)
{
    const ms_nn__op *last;
    const ms_nn_tensor *stored;
    ms_nn_collapse *made;
    size_t i, k, h, rows, channels, bytes, square, triangle;
    ms_status status = MS_OK;
    if (nn == NULL || c == NULL) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", nn == NULL ? "nn" : "c");
    last = &nn->op[nn->ops - 1];
    if (last->step != MS_NN__DO_DENSE || last->activation != MS_NN__LINEAR)
        return ms__fail(error, MS_UNSUPPORTED, 0, "only a network whose last layer is dense and linear collapses");
    channels = nn->channels;
    h = last->matrix.cols;
    rows = last->matrix.rows;
    for (i = 0; weight && i < channels * rows; ++i)
        if (!ms__finite_f(weight[i]) || weight[i] < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "weight %z is %g; it must be finite and not negative", i,
                            (double)weight[i]);
    square = ms__size_mul(h, h);
    triangle = ms__size_mul(h, h + 1) / 2;
    bytes = ms__size_mul(channels, ms__size_mul(ms__size_add(square, 2 * h), sizeof(double)));
    bytes = ms__size_add(bytes, ms__size_add(sizeof *made, ms__size_mul(triangle, sizeof(double))));
    bytes = ms__size_add(bytes,
                         ms__size_mul(channels, ms__size_add(sizeof(size_t), ms__size_mul(rows, sizeof(float)))));
    made = (ms_nn_collapse *)ms_nn__alloc(&nn->options, bytes);
    if (made == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a collapse of %z features", h);
    memset(made, 0, sizeof *made);
    made->nn = nn;
    made->m = &last->matrix;
    made->channels = channels;
    made->h = h;
    made->bytes = bytes;
    made->trunk = ms_nn__trunk(nn);
    made->r = (double *)(void *)(made + 1);
    made->packed = made->r + channels * square;
    made->h0 = made->packed + triangle;
    made->e = made->h0 + channels * h;
    made->owner = (size_t *)(void *)(made->e + channels * h);
    made->weight = (float *)(void *)(made->owner + channels);
    made->weighted = weight != NULL;
    for (i = 0; i < channels * rows; ++i) made->weight[i] = weight ? weight[i] : 1.0f;
    stored = weight ? NULL : ms_nn_file_find(nn->file, "ms_nn.collapse");
    if (stored && (stored->dtype != MS_NN_F64 || stored->bytes / 8 != triangle)) stored = NULL;
    for (i = 0; status == MS_OK && i < channels; ++i) {
        made->owner[i] = ms_nn__collapse_owner(made->weight, rows, i);
        if (made->owner[i] == i && stored == NULL)
            status = ms_nn__collapse_factor(made, made->weight + i * rows, made->r + i * square, error);
    }
    if (stored) {
        size_t at = 0;
        memset(made->r, 0, square * sizeof(double));
        for (i = 0; i < h; ++i)
            for (k = i; k < h; ++k) made->r[i * h + k] = ms_nn__element(stored->data, MS_NN_F64, at++);
    }
    ms_nn__collapse_pack(made);
    if (status != MS_OK) ms_nn_collapse_destroy(made);
    else *c = made;
    return status;
}

MS_API void ms_nn_collapse_destroy(ms_nn_collapse *c)
{
    if (c != NULL) ms__release(&c->nn->options.allocator, c, c->bytes);
}

MS_API size_t ms_nn_collapse_features(const ms_nn_collapse *c) { return c ? c->channels * c->h : 0; }
MS_API const double *ms_nn_collapse_r(const ms_nn_collapse *c) { return c ? c->packed : NULL; }

/* R'R - v v' by mixed hyperbolic rotations (Chambers 1971): 0 where the difference is not positive definite. */
static int ms_nn__downdate(double *r, size_t h, double *v)
{
    size_t j, k;
    for (j = 0; j < h; ++j) {
        double *row = r + j * h, s, c;
        if (v[j] == 0.0) continue;
        s = v[j] / row[j];
        if (!(fabs(s) < 1 - 1e-8)) return 0;
        c = sqrt((1 - s) * (1 + s));
        row[j] *= c;
        for (k = j + 1; k < h; ++k) {
            row[k] = (row[k] - s * v[k]) / c;
            v[k] = c * v[k] - s * row[k];
        }
    }
    return 1;
}

/* R for the weights `old` becomes R for `now`: their difference row by row, or 0 where making it anew is better.
   b  [h][MS_NN__QR_ROWS], row  [h] */
static MS_NN__COLD int ms_nn__collapse_update(const ms_nn_collapse *c, const float *old, const float *now, double *r,
                                              double *b, double *row)
{
    const ms_nn__kernels *kernels = c->nn->kernels;
    size_t h = c->h, rows = c->m->rows, i, n = 0;
    for (i = 0; i < rows; ++i) n += old[i] < now[i] || old[i] > now[i];
    if (n >= rows / 8 + 2 * MS_NN__QR_ROWS) return 0;
    for (i = n = 0; i < rows; ++i) /* more weight first: R grows before it shrinks */
        if (now[i] > old[i]) {
            if (n == 0) memset(b, 0, h * MS_NN__QR_ROWS * sizeof(double));
            ms_nn__qr_row(c->m, kernels, i, (double)now[i] - (double)old[i], row, b + n, MS_NN__QR_ROWS);
            if (++n == MS_NN__QR_ROWS) {
                ms_nn__qr_fold(kernels, r, h, b, MS_NN__QR_ROWS);
                n = 0;
            }
        }
    if (n > 0) ms_nn__qr_fold(kernels, r, h, b, MS_NN__QR_ROWS);
    for (i = 0; i < rows; ++i)
        if (now[i] < old[i]) {
            kernels->row(c->m, i, sqrt((double)old[i] - (double)now[i]), row);
            if (!ms_nn__downdate(r, h, row)) return 0;
        }
    return 1;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_mask(ms_nn_collapse *c, size_t count, const size_t *index,
                                                 const float *weight, ms_error *error)
{
    const ms_nn_options *o;
    double *r, *b, *row;
    float *now;
    size_t bytes, h, rows, outputs, square, i;
    ms_status status = MS_OK;
    if (c == NULL || (count && (index == NULL || weight == NULL)))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL",
                        c == NULL           ? "c"
                            : index == NULL ? "index"
                                            : "weight");
    h = c->h;
    rows = c->m->rows;
    outputs = c->channels * rows;
    for (i = 0; i < count; ++i)
        if (index[i] >= outputs || !ms__finite_f(weight[i]) || weight[i] < 0)
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "entry %z: output %z with weight %g", i, index[i],
                            (double)weight[i]);
    if (count == 0) return MS_OK;
    o = &c->nn->options;
    square = h * h;
    bytes = ms__size_mul(ms__size_add(c->channels * square, ms__size_mul(h, MS_NN__QR_ROWS + 1)), sizeof(double));
    bytes = ms__size_add(bytes, outputs * sizeof(float));
    r = (double *)ms_nn__alloc(o, bytes);
    if (r == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory to update %z features", h);
    b = r + c->channels * square;
    row = b + h * MS_NN__QR_ROWS;
    now = (float *)(void *)(row + h);
    memcpy(now, c->weight, outputs * sizeof(float));
    for (i = 0; i < count; ++i) now[index[i]] = weight[i];
    for (i = 0; status == MS_OK && i < c->channels; ++i)
        if (ms_nn__collapse_owner(now, rows, i) == i) {
            memcpy(r + i * square, c->r + c->owner[i] * square, square * sizeof(double));
            if (!ms_nn__collapse_update(c, c->weight + i * rows, now + i * rows, r + i * square, b, row))
                status = ms_nn__collapse_factor(c, now + i * rows, r + i * square, error);
        }
    if (status == MS_OK) {
        for (i = 0; i < c->channels; ++i) {
            c->owner[i] = ms_nn__collapse_owner(now, rows, i);
            if (c->owner[i] == i) memcpy(c->r + i * square, r + i * square, square * sizeof(double));
        }
        memcpy(c->weight, now, outputs * sizeof(float));
        c->weighted = 1;
        ms_nn__collapse_pack(c);
    }
    ms__release(&o->allocator, r, bytes);
    return status;
}

#define MS_NN__PASS_ROWS 8 /* of W in double together */

/* One pass over W: residuals res of h0 and sum_i w_i m_i res_i, rows cut into parts that are added in order. */
typedef struct ms_nn__pass_job {
    const ms_nn_collapse *c;
    const float *target; /* [channels][rows] */
    double *sum;         /* [parts][channels h + 1]: the vectors, then sum_i m_i res_i^2 */
    double *wide;        /* [parts][PASS_ROWS][h] */
    double *residual;    /* [parts][PASS_ROWS][channels] */
    size_t parts;
} ms_nn__pass_job;

/* The part that `n` rows of W in `wide` have in the sums. */
static void ms_nn__pass_block(const ms_nn__pass_job *job, const size_t *row, size_t n, const double *wide,
                              double *residual, double *sum)
{
    const ms_nn_collapse *c = job->c;
    const ms_nn__kernels *kernels = c->nn->kernels;
    size_t h = c->h, channels = c->channels, i, ch;
    kernels->gram(wide, n, c->h0, channels, h, h, residual);
    for (i = 0; i < n; ++i)
        for (ch = 0; ch < channels; ++ch) {
            double bias = c->m->bias ? (double)ms_nn__float_at(c->m->bias, row[i]) : 0.0,
                   weight = (double)c->weight[ch * c->m->rows + row[i]];
            double res = (double)job->target[ch * c->m->rows + row[i]] - bias - residual[i * channels + ch];
            residual[i * channels + ch] = weight * res;
            sum[channels * h] += weight * res * res;
        }
    kernels->add(sum, channels, wide, n, h, h, residual);
}

static MS_NN__COLD void ms_nn__pass_task(void *context, int index)
{
    const ms_nn__pass_job *job = (const ms_nn__pass_job *)context;
    const ms_nn_collapse *c = job->c;
    size_t part = (size_t)index, h = c->h, rows = c->m->rows, i = rows * part / job->parts,
           end = rows * (part + 1) / job->parts, n = 0, ch;
    size_t row[MS_NN__PASS_ROWS];
    double *sum = job->sum + part * (c->channels * h + 1), *wide = job->wide + part * MS_NN__PASS_ROWS * h;
    double *residual = job->residual + part * MS_NN__PASS_ROWS * c->channels;
    memset(sum, 0, (c->channels * h + 1) * sizeof(double));
    for (; i < end; ++i) {
        for (ch = 0; ch < c->channels && !(c->weight[ch * rows + i] > 0);) ++ch;
        if (ch == c->channels) continue; /* weight 0 in all channels */
        c->nn->kernels->row(c->m, i, 1.0, wide + n * h);
        row[n++] = i;
        if (n == MS_NN__PASS_ROWS) {
            ms_nn__pass_block(job, row, n, wide, residual, sum);
            n = 0;
        }
    }
    if (n > 0) ms_nn__pass_block(job, row, n, wide, residual, sum);
}

static MS_NN__COLD void ms_nn__pass(const ms_nn__pass_job *job)
{
    size_t n = job->c->channels * job->c->h + 1, p, i;
    ms__run(&job->c->nn->options.parallel, (int)job->parts, ms_nn__pass_task, (void *)(uintptr_t)job);
    for (p = 1; p < job->parts; ++p)
        for (i = 0; i < n; ++i) job->sum[i] += job->sum[p * n + i];
}

/* The least pivot of R that is no rounding: below it lies a direction that no output sees. */
static double ms_nn__least_pivot(const double *r, size_t h)
{
    double largest = 0;
    size_t j;
    for (j = 0; j < h; ++j)
        if (fabs(r[j * h + j]) > largest) largest = fabs(r[j * h + j]);
    return 1e-13 * largest;
}

/* R' y = x, in place. */
static void ms_nn__solve_transposed(const ms_nn__kernels *kernels, const double *r, size_t h, double *x)
{
    double least = ms_nn__least_pivot(r, h), minus;
    size_t j;
    for (j = 0; j < h; ++j) {
        const double *row = r + j * h;
        x[j] = fabs(row[j]) > least ? x[j] / row[j] : 0.0;
        minus = -x[j];
        kernels->add(x + j + 1, 1, row + j + 1, 1, h, h - j - 1, &minus);
    }
}

/* R z = y, in place. */
static void ms_nn__solve(const ms_nn__kernels *kernels, const double *r, size_t h, double *x)
{
    double least = ms_nn__least_pivot(r, h), dot;
    size_t j;
    for (j = h; j-- > 0;) {
        const double *row = r + j * h;
        kernels->gram(row + j + 1, 1, x + j + 1, 1, h, h - j - 1, &dot);
        x[j] = fabs(row[j]) > least ? (x[j] - dot) / row[j] : 0.0;
    }
}

/* h0 = (R'R)^-1 W'M (t - b), the sum in floats: anywhere near the best h will do, as what it misses comes in again with
   e. g  [channels][rows], g_x  [channels][h], scratch as ms_nn__run_dense_back needs it */
static MS_NN__COLD void ms_nn__collapse_start(ms_nn_collapse *c, const float *target, float *g, float *g_x,
                                              void *scratch)
{
    const ms_nn__kernels *kernels = c->nn->kernels;
    size_t h = c->h, rows = c->m->rows, i, ch;
    double largest = 0;
    int pass;
    for (pass = 0; pass < 2; ++pass)
        for (ch = 0; ch < c->channels; ++ch)
            for (i = 0; i < rows; ++i) {
                double bias = c->m->bias ? (double)ms_nn__float_at(c->m->bias, i) : 0.0;
                double weighted = (double)c->weight[ch * rows + i] * ((double)target[ch * rows + i] - bias);
                if (pass == 1) g[ch * rows + i] = (float)(largest > 0 ? weighted / largest : 0.0);
                else if (fabs(weighted) > largest) largest = fabs(weighted);
            }
    ms_nn__run_dense_back(c->nn, &c->nn->op[c->nn->ops - 1], (int)c->channels, g, g_x, scratch);
    for (ch = 0; ch < c->channels; ++ch) {
        double *h0 = c->h0 + ch * h;
        for (i = 0; i < h; ++i) h0[i] = largest * (double)g_x[ch * h + i];
        ms_nn__solve_transposed(kernels, c->r + c->owner[ch] * h * h, h, h0);
        ms_nn__solve(kernels, c->r + c->owner[ch] * h * h, h, h0);
    }
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_target(ms_nn_collapse *c, const float *target, ms_error *error)
{
    ms_nn__pass_job job;
    float *g;
    size_t h, n, i, ch, outputs, bytes;
    double norm = 0;
    if (c == NULL || target == NULL)
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "%s is NULL", c == NULL ? "c" : "target");
    h = c->h;
    n = c->channels * h;
    outputs = c->channels * c->m->rows;
    for (i = 0; i < outputs; ++i)
        if (!ms__finite_f(target[i]))
            return ms__fail(error, MS_INVALID_ARGUMENT, i, "target value %z is not finite", i);
    memset(&job, 0, sizeof job);
    job.c = c;
    job.target = target;
    job.parts = ms_nn__min(16, c->m->rows / 1024 + 1);
    bytes = ms__size_mul(job.parts * sizeof(double),
                         ms__size_add(n + 1, ms__size_mul(MS_NN__PASS_ROWS, h + c->channels)));
    bytes = ms__size_add(
        bytes, ms__size_mul(ms__size_add(outputs + n, ms_nn__back_floats(c->nn, c->m, c->channels)), sizeof(float)));
    job.sum = (double *)ms_nn__alloc(&c->nn->options, bytes);
    if (job.sum == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for a target");
    job.wide = job.sum + job.parts * (n + 1);
    job.residual = job.wide + job.parts * MS_NN__PASS_ROWS * h;
    g = (float *)(void *)(job.residual + job.parts * MS_NN__PASS_ROWS * c->channels);
    ms_nn__collapse_start(c, target, g, g + outputs, g + outputs + n);
    ms_nn__pass(&job); /* W'M res and |res|_M^2 of h0 */
    memcpy(c->e, job.sum, n * sizeof(double));
    for (ch = 0; ch < c->channels; ++ch)
        ms_nn__solve_transposed(c->nn->kernels, c->r + c->owner[ch] * h * h, h, c->e + ch * h);
    for (i = 0; i < n; ++i) norm += c->e[i] * c->e[i];
    c->rest = job.sum[n] > norm ? job.sum[n] - norm : 0.0;
    c->has_target = 1;
    ms__release(&c->nn->options.allocator, job.sum, bytes);
    return MS_OK;
}

#define MS_NN__COLUMNS 32 /* of the Jacobian, multiplied by R together */

/* Doubles of an evaluation: the residual (for the value) and columns for R; then the floats of h(x); then the
   trunk's. */
static size_t ms_nn__collapse_doubles(const ms_nn_collapse *c)
{
    return c->channels * c->h + 1 + MS_NN__COLUMNS * c->h;
}

MS_API size_t ms_nn_collapse_workspace_size(const ms_nn_collapse *c, int with_jacobian)
{
    size_t trunk;
    if (c == NULL) return 0;
    trunk = c->trunk.ops == 0 ? 0
                              : ms_nn__layout_of(&c->trunk, with_jacobian ? MS_NN_JACOBIAN : MS_NN_FORWARD, 1).total;
    return ms__size_add(ms__size_add(trunk, c->channels * c->h * sizeof(float)),
                        ms_nn__collapse_doubles(c) * sizeof(double) + 64);
}

/* h(x) [channels][h] into features. */
static ms_status ms_nn__collapse_features(const ms_nn_collapse *c, const float *x, float *features, void *workspace)
{
    if (c->trunk.ops > 0) return ms_nn_forward(&c->trunk, 1, x, features, workspace);
    if (c->nn->channel_input) ms_nn__spread(c->nn, 1, x, features);
    else memcpy(features, x, c->h * sizeof(float));
    return MS_OK;
}

/* out_ik = sum_j R_ij column_k,j for n columns: rows in fours, each four from its diagonal on. add: out += ... */
static void ms_nn__collapse_product(const ms_nn_collapse *c, const double *r, const double *columns, size_t n,
                                    double *out, size_t row_step, const size_t *column_at)
{
    double tile[4 * MS_NN__COLUMNS];
    size_t h = c->h, i, j, k, m;
    for (i = 0; i < h; i += 4) {
        m = ms_nn__min(4, h - i);
        c->nn->kernels->gram(r + i * h + i, m, columns + i, n, h, h - i, tile);
        for (j = 0; j < m; ++j)
            for (k = 0; k < n; ++k) out[(i + j) * row_step + (column_at ? column_at[k] : k)] += tile[j * n + k];
    }
}

/* The residual [channels h + 1] and, unless NULL, its Jacobian [channels h + 1][inputs]. doubles:
   ms_nn__collapse_doubles, then the features and the trunk's workspace. */
static MS_NN__COLD ms_status ms_nn__collapse_evaluate(const ms_nn_collapse *c, const float *x, double *residual,
                                                      double *jacobian, double *doubles)
{
    const ms_nn *nn = c->nn;
    size_t h = c->h, total = c->channels * h, inputs = ms_nn_input_size(nn), in = ms_nn__count(nn->inner), ch, i, k, k0,
           n;
    double *columns = doubles + total + 1;
    float *features = (float *)(void *)(columns + MS_NN__COLUMNS * h);
    const float *slopes = NULL; /* of h(x), or the identity where there is no trunk */
    size_t slope_row = 0, slope_column = 0;
    ms_nn__call call;
    ms_status status;
    if (jacobian && c->trunk.ops > 0) {
        status = ms_nn__begin(&call, &c->trunk, MS_NN_JACOBIAN, 1, x, features, features + total);
        if (status == MS_OK) slopes = ms_nn__slopes(&call, &slope_row, &slope_column);
    } else {
        status = ms_nn__collapse_features(c, x, features, features + total);
    }
    if (status != MS_OK) return status;
    if (jacobian) memset(jacobian, 0, (total + 1) * inputs * sizeof(double));
    for (ch = 0; ch < c->channels; ++ch) {
        const double *r = c->r + c->owner[ch] * h * h;
        for (i = 0; i < h; ++i) {
            columns[i] = (double)features[ch * h + i] - c->h0[ch * h + i];
            residual[ch * h + i] = -c->e[ch * h + i];
        }
        ms_nn__collapse_product(c, r, columns, 1, residual + ch * h, 1, NULL);
        for (k0 = 0; jacobian && k0 < in; k0 += n) {
            double *out = jacobian + ch * h * inputs;
            n = ms_nn__min(MS_NN__COLUMNS, in - k0);
            for (k = 0; k < n; ++k)
                for (i = 0; i < h; ++i)
                    columns[k * h + i] = slopes ? (double)slopes[ch * h * in + i * slope_row + (k0 + k) * slope_column]
                        : i == k0 + k           ? 1.0
                                                : 0.0;
            if (nn->channel_input)
                ms_nn__collapse_product(c, r, columns, n, out, inputs, nn->channel_input + ch * in + k0);
            else ms_nn__collapse_product(c, r, columns, n, out + k0, inputs, NULL);
        }
    }
    residual[total] = sqrt(c->rest);
    return MS_OK;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_residual(const ms_nn_collapse *c, const float *x, double *residual,
                                                     double *jacobian, void *workspace)
{
    size_t bytes;
    void *allocated = NULL;
    ms_status status;
    if (c == NULL || x == NULL || residual == NULL || !c->has_target) return MS_INVALID_ARGUMENT;
    bytes = ms_nn_collapse_workspace_size(c, jacobian != NULL);
    if (workspace == NULL) workspace = allocated = ms_nn__alloc(&c->nn->options, bytes);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    status = ms_nn__collapse_evaluate(c, x, residual, jacobian,
                                      (double *)(((uintptr_t)workspace + 63) & ~(uintptr_t)63));
    ms__release(&c->nn->options.allocator, allocated, bytes);
    return status;
}

MS_API MS_NN__COLD ms_status ms_nn_collapse_value(const ms_nn_collapse *c, const float *x, double *value,
                                                  void *workspace)
{
    size_t bytes, i;
    void *allocated = NULL;
    double *residual, sum;
    ms_status status;
    if (c == NULL || x == NULL || value == NULL || !c->has_target) return MS_INVALID_ARGUMENT;
    bytes = ms_nn_collapse_workspace_size(c, 0);
    if (workspace == NULL) workspace = allocated = ms_nn__alloc(&c->nn->options, bytes);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    residual = (double *)(((uintptr_t)workspace + 63) & ~(uintptr_t)63);
    status = ms_nn__collapse_evaluate(c, x, residual, NULL, residual);
    sum = c->rest;
    for (i = 0; status == MS_OK && i < c->channels * c->h; ++i) sum += residual[i] * residual[i];
    if (status == MS_OK) *value = sum;
    ms__release(&c->nn->options.allocator, allocated, bytes);
    return status;
}

/* ---- low rank -------------------------------------------------------------------------------------------------- */

struct ms_nn_low_rank {
    const ms_nn_collapse *c;
    size_t bytes;
    double peak, total; /* variance of all outputs together, over the samples */
    double *variance;   /* [h] carried by each direction, falling */
    double *mean;       /* [h] of the features */
    double *left;       /* [h][h] column k: L V_k, so that U_k = W left_k / sqrt(variance_k) */
    size_t *order;      /* [h] columns by falling variance */
};

/* C = L L' in place (lower, column k from row k on); a pivot of rounding size makes a zero column. */
static void ms_nn__cholesky(double *a, size_t n)
{
    size_t i, j, k;
    double largest = 0;
    for (j = 0; j < n; ++j)
        if (a[j * n + j] > largest) largest = a[j * n + j];
    for (k = 0; k < n; ++k) { /* column-major: column k at a + k n */
        double pivot = a[k * n + k], root = pivot > 1e-14 * largest ? sqrt(pivot) : 0.0;
        for (i = 0; i < k; ++i) a[k * n + i] = 0;
        for (i = k; i < n; ++i) a[k * n + i] = root > 0 ? a[k * n + i] / root : 0.0;
        for (j = k + 1; j < n; ++j)
            for (i = j; i < n; ++i) a[j * n + i] -= a[k * n + i] * a[k * n + j];
    }
}

/* One-sided Jacobi (Hestenes 1958): rotates the columns of g, and of l along with them, until they are orthogonal. */
static MS_NN__COLD void ms_nn__jacobi(const ms_nn__kernels *kernels, double *g, double *l, size_t n)
{
    int sweep, rotated = 1;
    size_t p, q;
    for (sweep = 0; sweep < 40 && rotated; ++sweep) {
        rotated = 0;
        for (p = 0; p + 1 < n; ++p)
            for (q = p + 1; q < n; ++q) {
                double a, b, d, zeta, t, c;
                kernels->gram(g + p * n, 1, g + p * n, 1, n, n, &a);
                kernels->gram(g + q * n, 1, g + q * n, 1, n, n, &b);
                kernels->gram(g + p * n, 1, g + q * n, 1, n, n, &d);
                if (!(fabs(d) > 1e-14 * sqrt(a * b)) || !(fabs(d) > 1e-300)) continue;
                rotated = 1;
                zeta = (b - a) / (2 * d);
                t = (zeta < 0 ? -1 : 1) / (fabs(zeta) + sqrt(1 + zeta * zeta));
                c = 1 / sqrt(1 + t * t);
                kernels->rotate(g + p * n, g + q * n, n, c, c * t);
                kernels->rotate(l + p * n, l + q * n, n, c, c * t);
            }
    }
}

static int ms_nn__compare_variance(const void *context, size_t a, size_t b)
{
    const double *v = (const double *)context;
    return v[a] > v[b] ? -1 : v[a] < v[b] ? 1 : a < b ? -1 : a > b;
}

/* Mean and covariance of the features over the samples and their channels, one sample at a time. */
static ms_status ms_nn__feature_moments(const ms_nn_collapse *c, int samples, const float *x, double *mean,
                                        double *covariance)
{
    size_t h = c->h, total = c->channels * h, ch, i, j,
           bytes = ms__size_add(ms_nn_collapse_workspace_size(c, 0), total * sizeof(float));
    float *workspace = (float *)ms_nn__alloc(&c->nn->options, bytes);
    double share = 1 / ((double)samples * (double)c->channels);
    int s, pass;
    ms_status status = workspace ? MS_OK : MS_OUT_OF_MEMORY;
    memset(mean, 0, h * sizeof(double));
    memset(covariance, 0, h * h * sizeof(double));
    for (pass = 0; pass < 2; ++pass)
        for (s = 0; status == MS_OK && s < samples; ++s) {
            status = ms_nn__collapse_features(c, x + (size_t)s * ms_nn_input_size(c->nn), workspace, workspace + total);
            for (ch = 0; status == MS_OK && ch < c->channels; ++ch) {
                const float *f = workspace + ch * h;
                for (i = 0; pass == 0 && i < h; ++i) mean[i] += share * (double)f[i];
                for (i = 0; pass == 1 && i < h; ++i)
                    for (j = i; j < h; ++j)
                        covariance[i * h + j] += share * ((double)f[i] - mean[i]) * ((double)f[j] - mean[j]);
            }
        }
    ms__release(&c->nn->options.allocator, workspace, bytes);
    return status;
}

MS_API MS_NN__COLD ms_status ms_nn_low_rank_create(const ms_nn_collapse *c, int samples, const float *x, double peak,
                                                   ms_nn_low_rank **low_rank, ms_error *error)
{
    size_t h, i, k, bytes, g_bytes;
    ms_nn_low_rank *made;
    double *g;
    ms_status status;
    if (c == NULL || x == NULL || low_rank == NULL || samples < 1 || !(peak >= 0))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0, "at least one sample and a peak that is not negative");
    if (c->weighted) return ms__fail(error, MS_INVALID_ARGUMENT, 0, "the collapse has weights; make one without");
    h = c->h;
    g_bytes = ms__size_mul(ms__size_mul(h, h), sizeof(double));
    bytes = ms__size_add(ms__size_add(sizeof *made, g_bytes), ms__size_mul(h, 2 * sizeof(double) + sizeof(size_t)));
    made = (ms_nn_low_rank *)ms_nn__alloc(&c->nn->options, bytes);
    g = (double *)ms_nn__alloc(&c->nn->options, g_bytes);
    status = made && g ? MS_OK : MS_OUT_OF_MEMORY;
    if (status == MS_OK) {
        made->c = c;
        made->bytes = bytes;
        made->peak = peak > 0 ? peak : 1.0;
        made->variance = (double *)(void *)(made + 1);
        made->mean = made->variance + h;
        made->left = made->mean + h;
        made->order = (size_t *)(void *)(made->left + h * h);
        status = ms_nn__feature_moments(c, samples, x, made->mean, made->left);
    }
    if (status == MS_OK) {
        ms_nn__cholesky(made->left, h);
        memset(g, 0, g_bytes);
        for (k = 0; k < h; ++k) /* G = R L */
            for (i = 0; i < h; ++i) c->nn->kernels->gram(c->r + i * h, 1, made->left + k * h, 1, h, h, &g[k * h + i]);
        ms_nn__jacobi(c->nn->kernels, g, made->left, h);
        made->total = 0;
        for (k = 0; k < h; ++k) {
            c->nn->kernels->gram(g + k * h, 1, g + k * h, 1, h, h, &made->variance[k]);
            made->order[k] = k;
        }
        ms_nn__sort(made->order, h, ms_nn__compare_variance, made->variance);
        for (k = 0; k < h; ++k) made->total += made->variance[made->order[h - 1 - k]];
        *low_rank = made;
    } else if (made) {
        ms__release(&c->nn->options.allocator, made, bytes);
    }
    ms__release(&c->nn->options.allocator, g, g_bytes);
    return status == MS_OK ? MS_OK : ms__fail(error, status, 0, "no memory for the directions of %z features", h);
}

MS_API void ms_nn_low_rank_destroy(ms_nn_low_rank *low_rank)
{
    if (low_rank != NULL) ms__release(&low_rank->c->nn->options.allocator, low_rank, low_rank->bytes);
}

MS_API MS_NN__COLD double ms_nn_low_rank_psnr(const ms_nn_low_rank *low_rank, int rank)
{
    const ms_nn_low_rank *l = low_rank;
    double lost = 0;
    size_t k;
    if (l == NULL) return 0;
    for (k = l->c->h; k-- > (size_t)(rank > 0 ? rank : 0);) lost += l->variance[l->order[k]];
    if (!(lost > 1e-15 * l->total)) return (double)ms_nn__float_of(0x7f800000u);
    return 10 * log10(l->peak * l->peak * (double)l->c->m->rows / lost);
}

MS_API MS_NN__COLD int ms_nn_low_rank_for(const ms_nn_low_rank *low_rank, double psnr_db)
{
    int rank = 1;
    while (low_rank != NULL && (size_t)rank < low_rank->c->h && ms_nn_low_rank_psnr(low_rank, rank) < psnr_db) ++rank;
    return low_rank != NULL ? rank : 0;
}

/* x rounded to nearest even in one of the three types, little-endian. */
static void ms_nn__put_element(unsigned char *out, ms_nn_dtype dtype, size_t i, double x)
{
    float f = (float)x;
    uint32_t bits, k, n = dtype == MS_NN_F32 ? 4 : 2;
    memcpy(&bits, &f, sizeof bits);
    if (dtype == MS_NN_BF16) {
        bits = (bits + 0x7fffu + (bits >> 16 & 1)) >> 16;
    } else if (dtype == MS_NN_F16) {
        bits = fabs(x) >= 65520 ? (bits >> 16 & 0x8000u) | 0x7c00u
                                : ms__half_from_float(f); /* infinity, as others round it */
    }
    for (k = 0; k < n; ++k) out[i * n + k] = (unsigned char)(bits >> (8 * k) & 0xff);
}

/* "...,{last layer}]" becomes "...,{<name>.low},{<name>}]"; the text's length. out NULL: only that. */
static size_t ms_nn__low_rank_layers(const ms_nn *nn, const char *layers, size_t rank, char *out)
{
    const char *name = nn->layer[nn->layers - 1].name;
    size_t last = strlen(layers);
    ms_nn__writer w;
    int depth = 0;
    while (last > 0 && !(layers[--last] == '{' && --depth == 0)) depth += layers[last] == '}';
    w.out = out;
    w.length = 0;
    ms_nn__put(&w, layers, last);
    ms_nn__put_text(&w, "{\"type\":\"dense\",\"name\":");
    ms_nn__put_string(&w, name);
    w.length -= 1; /* the closing quote */
    ms_nn__put_text(&w, ".low\",\"units\":");
    ms_nn__put_size(&w, rank);
    ms_nn__put_text(&w, ",\"bias\":false},{\"type\":\"dense\",\"name\":");
    ms_nn__put_string(&w, name);
    ms_nn__put_text(&w, ",\"units\":");
    ms_nn__put_size(&w, nn->op[nn->ops - 1].matrix.rows);
    ms_nn__put_text(&w, "}]");
    return w.length;
}

MS_API MS_NN__COLD ms_status ms_nn_low_rank_write(const ms_nn_low_rank *low_rank, int rank, ms_nn_dtype dtype,
                                                  ms_nn_sink sink, ms_error *error)
{
    const ms_nn_low_rank *l = low_rank;
    const ms_nn_collapse *c = l ? l->c : NULL;
    const ms_nn *nn = c ? c->nn : NULL;
    size_t h, p, r = (size_t)rank, width = dtype == MS_NN_F32 ? 4 : 2, i, j, k, bytes, tensors, entries, n = 0;
    size_t low_shape[2], high_shape[2];
    const char *layers, *name;
    char *memory, *text, low_name[272], weight_name[272], bias_name[272];
    double *a, *u, *wide;
    unsigned char *low, *high, *bias;
    ms_nn_tensor *t;
    ms_nn_entry *e;
    ms_status status;
    if (nn == NULL || rank < 1 || r > c->h || (dtype != MS_NN_F32 && dtype != MS_NN_F16 && dtype != MS_NN_BF16))
        return ms__fail(error, MS_INVALID_ARGUMENT, 0,
                        "rank must be 1 to the number of features, dtype F32, F16 or BF16");
    if (strcmp(nn->layer[nn->layers - 1].type, "dense"))
        return ms__fail(error, MS_UNSUPPORTED, 0, "the last entry of the layer list must be the dense layer");
    h = c->h;
    p = c->m->rows;
    name = nn->layer[nn->layers - 1].name;
    layers = ms_nn_file_metadata(nn->file, "ms_nn_layers");
    tensors = ms_nn_file_tensor_count(nn->file) + 3;
    entries = ms_nn_file_entry_count(nn->file);
    /* A = D' R'R [r][h], U = W D [p][r], D = left / sqrt(variance) */
    bytes = ms__size_add(ms__size_mul(ms__size_mul(h, r), 2 * sizeof(double) + width),
                         ms__size_mul(p, ms__size_add(ms__size_mul(r, width), 4)));
    bytes = ms__size_add(bytes,
                         ms__size_mul(tensors, sizeof *t) + ms__size_mul(entries, sizeof *e) +
                             ms__size_mul(h, 2 * sizeof(double)) + ms_nn__low_rank_layers(nn, layers, r, NULL) + 1);
    memory = (char *)ms_nn__alloc(&nn->options, bytes);
    if (memory == NULL) return ms__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the factors");
    a = (double *)(void *)memory; /* [r][h] */
    u = a + r * h;                /* [r][h]: D' */
    wide = u + r * h;
    t = (ms_nn_tensor *)(void *)(wide + 2 * h);
    e = (ms_nn_entry *)(void *)(t + tensors);
    bias = (unsigned char *)(e + entries);
    low = bias + 4 * p;
    high = low + r * h * width;
    text = (char *)high + p * r * width;
    for (k = 0; k < r; ++k) {
        const double *left = l->left + l->order[k] * h;
        double variance = l->variance[l->order[k]], scale = variance > 1e-15 * l->total ? 1 / sqrt(variance) : 0.0;
        for (i = 0; i < h; ++i) u[k * h + i] = left[i] * scale;
        memset(wide, 0, h * sizeof(double));
        for (i = 0; i < h; ++i) /* R'(R d) */
            nn->kernels->gram(c->r + i * h, 1, u + k * h, 1, h, h, &wide[i]);
        memset(a + k * h, 0, h * sizeof(double));
        for (i = 0; i < h; ++i) nn->kernels->add(a + k * h, 1, c->r + i * h, 1, h, h, &wide[i]);
        for (i = 0; i < h; ++i) ms_nn__put_element(low, dtype, k * h + i, a[k * h + i]);
    }
    for (i = 0; i < p; ++i) {
        double b = c->m->bias ? (double)ms_nn__float_at(c->m->bias, i) : 0.0, full, x;
        nn->kernels->row(c->m, i, 1.0, wide);
        nn->kernels->gram(wide, 1, l->mean, 1, h, h, &full);
        b += full; /* b + W mean - U A mean */
        for (k = 0; k < r; ++k) {
            nn->kernels->gram(wide, 1, u + k * h, 1, h, h, &x);
            ms_nn__put_element(high, dtype, i * r + k, x);
            nn->kernels->gram(a + k * h, 1, l->mean, 1, h, h, &full);
            b -= x * full;
        }
        ms_nn__put_element(bias, MS_NN_F32, i, b);
    }
    text[ms_nn__low_rank_layers(nn, layers, r, text)] = 0;
    low_shape[0] = r;
    low_shape[1] = h;
    high_shape[0] = p;
    high_shape[1] = r;
    k = strlen(name);
    memcpy(low_name, name, k);
    memcpy(low_name + k, ".low.weight", 12);
    memcpy(weight_name, name, k);
    memcpy(weight_name + k, ".weight", 8);
    memcpy(bias_name, name, k);
    memcpy(bias_name + k, ".bias", 6);
    for (i = 0; i + 3 < tensors; ++i) {
        const ms_nn_tensor *old = ms_nn_file_tensor(nn->file, i);
        if (strncmp(old->name, name, k) == 0 && old->name[k] == '.') continue;
        if (strcmp(old->name, "ms_nn.collapse") != 0) t[n++] = *old;
    }
    for (j = 0; j < 3; ++j) {
        ms_nn_tensor *x = &t[n++];
        x->name = j == 0 ? low_name : j == 1 ? weight_name : bias_name;
        x->dtype = j == 2 ? MS_NN_F32 : dtype;
        x->rank = j == 2 ? 1 : 2;
        x->shape = j == 0 ? low_shape : high_shape;
        x->data = j == 0 ? low : j == 1 ? high : bias;
        x->bytes = j == 0 ? r * h * width : j == 1 ? p * r * width : 4 * p;
    }
    for (i = 0; i < entries; ++i) {
        e[i] = *ms_nn_file_entry(nn->file, i);
        if (strcmp(e[i].key, "ms_nn_layers") == 0) e[i].value = text;
    }
    status = ms_nn_file_write(t, n, e, entries, &nn->options.allocator, sink, error);
    ms__release(&nn->options.allocator, memory, bytes);
    return status;
}
#endif /* MS_NN_NO_COLLAPSE */

/* ---- levels ---------------------------------------------------------------------------------------------------- */

/* Full unrolling of the short loops over register tiles, also at -O2, and inlining of what has constant arguments.
   Under Clang's sanitizers that would take minutes to compile; without optimisation it would only add up the stack of
   all forms. */
#if defined(__GNUC__) && !defined(__OPTIMIZE__)
#define MS_NN__UNROLL
#define MS_NN__INLINE static inline
#elif defined(__clang__)
#if __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer) || __has_feature(thread_sanitizer)
#define MS_NN__UNROLL
#else
#define MS_NN__UNROLL _Pragma("clang loop unroll(full)")
#endif
#define MS_NN__INLINE static inline __attribute__((always_inline))
#elif defined(__GNUC__)
#define MS_NN__UNROLL _Pragma("GCC unroll 16")
#define MS_NN__INLINE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define MS_NN__UNROLL
#define MS_NN__INLINE static __forceinline
#else
#define MS_NN__UNROLL
#define MS_NN__INLINE static inline
#endif

#if defined(__GNUC__) || defined(__clang__)
#define MS_NN__APART __attribute__((noinline)) /* one copy of what several loops end in */
#elif defined(_MSC_VER)
#define MS_NN__APART __declspec(noinline)
#else
#define MS_NN__APART
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

/* The larger of two, or the NaN if there is one. */
static float ms_nn__max_nan(float a, float b) { return a > b || a != a ? a : b; }

#define MS_NN__JOIN2(a, b) a##b
#define MS_NN__JOIN(a, b) MS_NN__JOIN2(a, b)
#define MS_NN__FN(name) MS_NN__JOIN(MS_NN__JOIN(ms_nn__##name, _), MS_NN__LEVEL)

#define MS_NN__PASS 1
#define MS_NN__LEVEL scalar
#define MS_NN__ISA 1
#include MS_NN_FILENAME

#if defined(MS__X64) || defined(MS__NEON)
#define MS_NN__LEVEL base
#define MS_NN__ISA 2
#include MS_NN_FILENAME
#endif

#if defined(MS__X64)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma,f16c"))), apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c")
#endif
#define MS_NN__LEVEL avx2
#define MS_NN__ISA 3
#include MS_NN_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma,f16c,avx512f,avx512bw,avx512dq,avx512vl"))), \
                             apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c,avx512f,avx512bw,avx512dq,avx512vl")
#endif
#define MS_NN__LEVEL avx512
#define MS_NN__ISA 4
#include MS_NN_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif

/* The same with AVX-512 VNNI: I8 at twice the speed. */
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma,f16c,avx512f,avx512bw,avx512dq,avx512vl,avx512vnni"))), \
                             apply_to = function)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c,avx512f,avx512bw,avx512dq,avx512vl,avx512vnni")
#endif
#define MS_NN__LEVEL avx512vnni
#define MS_NN__ISA 5
#include MS_NN_FILENAME
#if defined(__clang__)
#pragma clang attribute pop
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#endif /* MS__X64 */
#undef MS_NN__PASS

static const ms_nn__kernels *ms_nn__kernels_for(ms_simd level)
{
#if defined(MS__X64)
    if (level == MS_SIMD_AVX512) {
        uint32_t r[4];
        ms__cpuid(7, 0, r);
        return r[2] & (1u << 11) ? &ms_nn__table_avx512vnni : &ms_nn__table_avx512; /* without VNNI: I8 by AVX2 */
    }
    if (level == MS_SIMD_AVX2) return &ms_nn__table_avx2;
#endif
#if defined(MS__X64) || defined(MS__NEON)
    if (level == MS_SIMD_BASE) return &ms_nn__table_base;
#endif
    (void)level;
    return &ms_nn__table_scalar;
}

/* Does this processor read a large F32 matrix faster several rows at a time than row by row? Intel's do (Sapphire
   Rapids: 1.22 times), where F16 and I8 do not; AMD's do not. The bits are the same. */
static int ms_nn__row_tiles(void)
{
#if defined(MS__X64)
    uint32_t r[4];
    ms__cpuid(0, 0, r);
    return r[1] == 0x756e6547u; /* "Genu", of GenuineIntel */
#else
    return 0;
#endif
}

#undef MS_NN__BIG_ENDIAN
#undef MS_NN__MMAP
#undef MS_NN__BIT
#undef MS_NN__WEIGHTED
#undef MS_NN__CONVS
#undef MS_NN__TRANSPOSED
#undef MS_NN__POOLS
#undef MS_NN__UPSAMPLES
#undef MS_NN__ACTIVATED
#undef MS_NN__RUN
#undef MS_NN__DIGIT_MAX
#undef MS_NN__OVERRUN
#undef MS_NN__TASK_BYTES
#undef MS_NN__TASK_PRODUCTS
#undef MS_NN__STRIP_FLOATS
#undef MS_NN__STRIPE
#undef MS_NN__QR_ROWS
#undef MS_NN__GRAM_ROWS
#undef MS_NN__GRAM_STRIDE
#undef MS_NN__QR_PANEL
#undef MS_NN__QR_PARTS
#undef MS_NN__PASS_ROWS
#undef MS_NN__COLUMNS
#undef MS_NN__UNROLL
#undef MS_NN__INLINE
#undef MS_NN__APART
#undef MS_NN__COLD
#undef MS_NN__WIDE
#undef MS_NN__COLS
#undef MS_NN__FN
#undef MS_NN__JOIN
#undef MS_NN__JOIN2
#endif /* MS_NN_IMPLEMENTATION */

#if defined(MS_NN_IMPLEMENTATION) && defined(MS_NN__PASS)
/* ---- kernels --------------------------------------------------------------------------------------------------- */

/* Plain C beside SIMD, and SSE2, are compiled for size: few run them. */
#if MS_NN__ISA <= 2 && defined(MS__X64) && defined(__GNUC__)
#define MS_NN__KERNEL static __attribute__((cold))
#else
#define MS_NN__KERNEL static
#endif

/* Read once a level. MS_NN__V_FLOATS is a vector of MS_NN__V_LANES floats; W_... load weights as floats.
   MS_NN__V_BLOCK outputs x MS_NN__V_TILE vectors of positions are a convolution's registers; MS_NN__W_ROWS rows x 3
   samples x MS_NN__W_CHAINS sums are a dense layer's. MAX(a, b) is a > b ? a : b, which is b, hence NaN if b is one:
   constants stand first. */
#if MS_NN__ISA == 1
#define MS_NN__V_LANES 1
#define MS_NN__V_BLOCK 4
#define MS_NN__V_TILE 2
#define MS_NN__W_ROWS 1
#define MS_NN__W_CHAINS 4
#define MS_NN__V_FLOATS float
#define MS_NN__V_LOAD(p) ms_nn__float_at((const unsigned char *)(p), 0)
#define MS_NN__V_STORE(p, v) (*(p) = (v))
#define MS_NN__V_SET(x) (x)
#define MS_NN__V_ADD(a, b) ((a) + (b))
#define MS_NN__V_SUB(a, b) ((a) - (b))
#define MS_NN__V_MUL(a, b) ((a) * (b))
#define MS_NN__V_DIV(a, b) ((a) / (b))
#define MS_NN__V_MADD(a, b, c) ((a) * (b) + (c))
#define MS_NN__V_MAX(a, b) ((a) > (b) ? (a) : (b))
#define MS_NN__V_MIN(a, b) ((a) < (b) ? (a) : (b))
#define MS_NN__V_IF_GREATER(a, b, x, y) ((a) > (b) ? (x) : (y))
#define MS_NN__V_INT int32_t
#define MS_NN__V_ROUND(a) ((a) < 0 ? (int32_t)((a)-0.5f) : (a) >= 0 ? (int32_t)((a) + 0.5f) : 0)
#define MS_NN__V_FROM_INT(i) ((float)(i))
#define MS_NN__V_POW2(i) ms_nn__float_of((uint32_t)((i) + 127) << 23)
#define MS_NN__W_HALF(p) ms__half_to_float((uint16_t)ms_nn__u16(p))
#define MS_NN__W_BRAIN(p) ms_nn__float_of(ms_nn__u16(p) << 16)
#define MS_NN__W_INT8(p) ((float)(*(p) < 128 ? *(p) : *(p)-256))
#elif MS_NN__ISA == 2 && defined(MS__X64)
#define MS_NN__V_LANES 4
#define MS_NN__V_BLOCK 4
#define MS_NN__V_TILE 2
#define MS_NN__W_ROWS 2
#define MS_NN__W_CHAINS 2
#define MS_NN__V_FLOATS __m128
#define MS_NN__V_LOAD(p) _mm_loadu_ps((const float *)(const void *)(p))
#define MS_NN__V_STORE(p, v) _mm_storeu_ps(p, v)
#define MS_NN__V_SET(x) _mm_set1_ps(x)
#define MS_NN__V_ADD(a, b) _mm_add_ps(a, b)
#define MS_NN__V_SUB(a, b) _mm_sub_ps(a, b)
#define MS_NN__V_MUL(a, b) _mm_mul_ps(a, b)
#define MS_NN__V_DIV(a, b) _mm_div_ps(a, b)
#define MS_NN__V_MADD(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)
#define MS_NN__V_MAX(a, b) _mm_max_ps(a, b)
#define MS_NN__V_MIN(a, b) _mm_min_ps(a, b)
#define MS_NN__V_IF_GREATER(a, b, x, y) MS_NN__FN(if_greater)(a, b, x, y)
#define MS_NN__V_MAX_NAN(a, b) MS_NN__FN(max_nan)(a, b)
#define MS_NN__V_PAIR_MAX(a, b) MS_NN__FN(max_nan)(_mm_shuffle_ps(a, b, 0x88), _mm_shuffle_ps(a, b, 0xDD))
#define MS_NN__V_INT __m128i
#define MS_NN__V_ROUND(a) _mm_cvtps_epi32(a)
#define MS_NN__V_FROM_INT(i) _mm_cvtepi32_ps(i)
#define MS_NN__V_POW2(i) _mm_castsi128_ps(_mm_slli_epi32(_mm_add_epi32(i, _mm_set1_epi32(127)), 23))
#define MS_NN__W_HALF(p) MS_NN__FN(half)(p)
#define MS_NN__W_BRAIN(p) \
    _mm_castsi128_ps(_mm_unpacklo_epi16(_mm_setzero_si128(), _mm_loadl_epi64((const __m128i *)(const void *)(p))))
#define MS_NN__W_INT8(p) MS_NN__FN(int8)(p)
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(if_greater)(MS_NN__V_FLOATS a, MS_NN__V_FLOATS b, MS_NN__V_FLOATS x,
                                                    MS_NN__V_FLOATS y)
{
    MS_NN__V_FLOATS m = _mm_cmpgt_ps(a, b);
    return _mm_or_ps(_mm_and_ps(m, x), _mm_andnot_ps(m, y));
}
#define MS_NN__V_FOLD(v) (v)
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(max_nan)(MS_NN__V_FLOATS a, MS_NN__V_FLOATS b)
{
    MS_NN__V_FLOATS nan = _mm_cmpunord_ps(a, a);
    return _mm_or_ps(_mm_and_ps(nan, a), _mm_andnot_ps(nan, _mm_max_ps(a, b)));
}
/* As ms__half_to_float, both cases at once. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(half)(const unsigned char *p)
{
    __m128i h = _mm_unpacklo_epi16(_mm_loadl_epi64((const __m128i *)(const void *)p), _mm_setzero_si128());
    __m128i magnitude = _mm_and_si128(h, _mm_set1_epi32(0x7fff)),
            sign = _mm_slli_epi32(_mm_xor_si128(h, magnitude), 16);
    __m128i special = _mm_and_si128(_mm_cmpgt_epi32(magnitude, _mm_set1_epi32(0x7bff)), _mm_set1_epi32(0x38000000));
    __m128i tiny = _mm_castps_si128(_mm_mul_ps(_mm_cvtepi32_ps(magnitude), _mm_set1_ps(5.9604644775390625e-8f)));
    __m128i is_tiny = _mm_cmpgt_epi32(_mm_set1_epi32(0x400), magnitude);
    __m128i bits = _mm_add_epi32(_mm_add_epi32(_mm_slli_epi32(magnitude, 13), _mm_set1_epi32(0x38000000)), special);
    bits = _mm_or_si128(_mm_and_si128(is_tiny, tiny), _mm_andnot_si128(is_tiny, bits));
    return _mm_castsi128_ps(_mm_or_si128(bits, sign));
}
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(int8)(const unsigned char *p)
{
    int32_t four;
    __m128i q;
    memcpy(&four, p, 4);
    q = _mm_cvtsi32_si128(four);
    q = _mm_unpacklo_epi8(q, q);
    return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(q, q), 24));
}
#elif MS_NN__ISA == 2
#define MS_NN__V_LANES 4
#define MS_NN__V_BLOCK 8
#define MS_NN__V_TILE 2
#define MS_NN__W_ROWS 4
#define MS_NN__W_CHAINS 2
#define MS_NN__V_FLOATS float32x4_t
#define MS_NN__V_LOAD(p) vreinterpretq_f32_u8(vld1q_u8((const unsigned char *)(p)))
#define MS_NN__V_STORE(p, v) vst1q_f32(p, v)
#define MS_NN__V_SET(x) vdupq_n_f32(x)
#define MS_NN__V_ADD(a, b) vaddq_f32(a, b)
#define MS_NN__V_SUB(a, b) vsubq_f32(a, b)
#define MS_NN__V_MUL(a, b) vmulq_f32(a, b)
#define MS_NN__V_DIV(a, b) vdivq_f32(a, b)
#define MS_NN__V_MADD(a, b, c) vfmaq_f32(c, a, b)
#define MS_NN__V_MAX(a, b) vmaxq_f32(a, b)
#define MS_NN__V_MIN(a, b) vminq_f32(a, b)
#define MS_NN__V_IF_GREATER(a, b, x, y) vbslq_f32(vcgtq_f32(a, b), x, y)
#define MS_NN__V_MAX_NAN(a, b) vmaxq_f32(a, b)
#define MS_NN__V_PAIR_MAX(a, b) vpmaxq_f32(a, b)
#define MS_NN__V_INT int32x4_t
#define MS_NN__V_ROUND(a) vcvtnq_s32_f32(a)
#define MS_NN__V_FROM_INT(i) vcvtq_f32_s32(i)
#define MS_NN__V_POW2(i) vreinterpretq_f32_s32(vshlq_n_s32(vaddq_s32(i, vdupq_n_s32(127)), 23))
#define MS_NN__W_HALF(p) vcvt_f32_f16(vreinterpret_f16_u8(vld1_u8(p)))
#define MS_NN__W_BRAIN(p) vreinterpretq_f32_u32(vshll_n_u16(vreinterpret_u16_u8(vld1_u8(p)), 16))
#define MS_NN__W_INT8(p) MS_NN__FN(int8)(p)
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(int8)(const unsigned char *p)
{
    uint32_t four;
    memcpy(&four, p, 4);
    return vcvtq_f32_s32(vmovl_s16(vget_low_s16(vmovl_s8(vcreate_s8(four)))));
}
#elif MS_NN__ISA == 3
#define MS_NN__V_LANES 8
#define MS_NN__V_BLOCK 4
#define MS_NN__V_TILE 3
#define MS_NN__W_ROWS 2
#define MS_NN__W_CHAINS 2
#define MS_NN__V_FLOATS __m256
#define MS_NN__V_LOAD(p) _mm256_loadu_ps((const float *)(const void *)(p))
#define MS_NN__V_STORE(p, v) _mm256_storeu_ps(p, v)
#define MS_NN__V_SET(x) _mm256_set1_ps(x)
#define MS_NN__V_ADD(a, b) _mm256_add_ps(a, b)
#define MS_NN__V_SUB(a, b) _mm256_sub_ps(a, b)
#define MS_NN__V_MUL(a, b) _mm256_mul_ps(a, b)
#define MS_NN__V_DIV(a, b) _mm256_div_ps(a, b)
#define MS_NN__V_MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define MS_NN__V_MAX(a, b) _mm256_max_ps(a, b)
#define MS_NN__V_MIN(a, b) _mm256_min_ps(a, b)
#define MS_NN__V_IF_GREATER(a, b, x, y) _mm256_blendv_ps(y, x, _mm256_cmp_ps(a, b, _CMP_GT_OQ))
#define MS_NN__V_MAX_NAN(a, b) _mm256_blendv_ps(_mm256_max_ps(a, b), a, _mm256_cmp_ps(a, a, _CMP_UNORD_Q))
#define MS_NN__V_PAIR_MAX(a, b) MS_NN__FN(pair_max)(a, b)
#define MS_NN__V_INT __m256i
#define MS_NN__V_ROUND(a) _mm256_cvtps_epi32(a)
#define MS_NN__V_FROM_INT(i) _mm256_cvtepi32_ps(i)
#define MS_NN__V_POW2(i) _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_add_epi32(i, _mm256_set1_epi32(127)), 23))
#define MS_NN__W_HALF(p) _mm256_cvtph_ps(_mm_loadu_si128((const __m128i *)(const void *)(p)))
#define MS_NN__W_BRAIN(p) \
    _mm256_castsi256_ps(  \
        _mm256_slli_epi32(_mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i *)(const void *)(p))), 16))
#define MS_NN__W_INT8(p) _mm256_cvtepi32_ps(_mm256_cvtepi8_epi32(_mm_loadl_epi64((const __m128i *)(const void *)(p))))
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(pair_max)(MS_NN__V_FLOATS a, MS_NN__V_FLOATS b)
{
    MS_NN__V_FLOATS even = _mm256_shuffle_ps(a, b, 0x88), odd = _mm256_shuffle_ps(a, b, 0xDD);
    return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(MS_NN__V_MAX_NAN(even, odd)), 0xD8));
}
#define MS_NN__V_FOLD(v) _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1))
#else /* maskz_ forms: the plain ones of GCC 12 warn in C++ */
#define MS_NN__V_LANES 16
#define MS_NN__V_BLOCK 8
#define MS_NN__V_TILE 3
#define MS_NN__W_ROWS 4
#define MS_NN__W_CHAINS 2
#define MS_NN__V_FLOATS __m512
#define MS_NN__V_LOAD(p) _mm512_loadu_ps(p)
#define MS_NN__V_STORE(p, v) _mm512_storeu_ps(p, v)
#define MS_NN__V_SET(x) _mm512_set1_ps(x)
#define MS_NN__V_ADD(a, b) _mm512_add_ps(a, b)
#define MS_NN__V_SUB(a, b) _mm512_sub_ps(a, b)
#define MS_NN__V_MUL(a, b) _mm512_mul_ps(a, b)
#define MS_NN__V_DIV(a, b) _mm512_div_ps(a, b)
#define MS_NN__V_MADD(a, b, c) _mm512_fmadd_ps(a, b, c)
#define MS_NN__V_MAX(a, b) _mm512_maskz_max_ps(0xFFFF, a, b)
#define MS_NN__V_MIN(a, b) _mm512_maskz_min_ps(0xFFFF, a, b)
#define MS_NN__V_IF_GREATER(a, b, x, y) _mm512_mask_blend_ps(_mm512_cmp_ps_mask(a, b, _CMP_GT_OQ), y, x)
#define MS_NN__V_INT __m512i
#define MS_NN__V_ROUND(a) _mm512_maskz_cvtps_epi32(0xFFFF, a)
#define MS_NN__V_FROM_INT(i) _mm512_maskz_cvtepi32_ps(0xFFFF, i)
#define MS_NN__V_POW2(i) \
    _mm512_castsi512_ps(_mm512_maskz_slli_epi32(0xFFFF, _mm512_add_epi32(i, _mm512_set1_epi32(127)), 23))
#define MS_NN__W_HALF(p) _mm512_maskz_cvtph_ps(0xFFFF, _mm256_loadu_si256((const __m256i *)(const void *)(p)))
#define MS_NN__W_BRAIN(p)                        \
    _mm512_castsi512_ps(_mm512_maskz_slli_epi32( \
        0xFFFF, _mm512_maskz_cvtepu16_epi32(0xFFFF, _mm256_loadu_si256((const __m256i *)(const void *)(p))), 16))
#define MS_NN__W_INT8(p)             \
    _mm512_maskz_cvtepi32_ps(0xFFFF, \
                             _mm512_maskz_cvtepi8_epi32(0xFFFF, _mm_loadu_si128((const __m128i *)(const void *)(p))))
#define MS_NN__V_FOLD(v) MS_NN__FN(fold)(v)
MS_NN__INLINE __m128 MS_NN__FN(fold)(MS_NN__V_FLOATS v)
{
    __m512d w = _mm512_castps_pd(v);
    __m256 b = _mm256_add_ps(_mm256_castpd_ps(_mm512_maskz_extractf64x4_pd(0xF, w, 0)),
                             _mm256_castpd_ps(_mm512_maskz_extractf64x4_pd(0xF, w, 1)));
    return _mm_add_ps(_mm256_castps256_ps128(b), _mm256_extractf128_ps(b, 1));
}
#endif

#if MS_NN__ISA != 4 /* AVX-512 without VNNI takes AVX2's */
/* Sums of products of 8-bit weights with 8-bit digits. On x86 unsigned times signed bytes: (w + 128) d, put right at
   the end by 128 sum d; |255 * 64 * 2| fits 16 bits. */
#if MS_NN__ISA == 5
#define MS_NN__B_INTS __m512i
#define MS_NN__B_BYTES 64
#define MS_NN__B_ZERO _mm512_setzero_si512()
#define MS_NN__B_LOAD(p) _mm512_loadu_si512(p)
#define MS_NN__B_PART(p, n) _mm512_maskz_loadu_epi8(((__mmask64)1 << (n)) - 1, p)
#define MS_NN__B_FLIP(u) _mm512_xor_si512(u, _mm512_set1_epi8((char)-128))
#define MS_NN__B_SUM(s) MS_NN__FN(int_sum)(s)
MS_NN__INLINE int32_t MS_NN__FN(int_sum)(MS_NN__B_INTS s)
{
    __m256i half = _mm256_add_epi32(_mm512_maskz_extracti64x4_epi64(0xF, s, 0),
                                    _mm512_maskz_extracti64x4_epi64(0xF, s, 1));
    __m128i t = _mm_add_epi32(_mm256_castsi256_si128(half), _mm256_extracti128_si256(half, 1));
    t = _mm_add_epi32(t, _mm_shuffle_epi32(t, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(t, _mm_shuffle_epi32(t, 0xB1)));
}
#define MS_NN__B_DOT(s, u, e) _mm512_dpbusd_epi32(s, u, e)
#elif MS_NN__ISA == 3
#define MS_NN__B_INTS __m256i
#define MS_NN__B_BYTES 32
#define MS_NN__B_ZERO _mm256_setzero_si256()
#define MS_NN__B_LOAD(p) _mm256_loadu_si256((const __m256i *)(const void *)(p))
#define MS_NN__B_FLIP(u) _mm256_xor_si256(u, _mm256_set1_epi8((char)-128))
#define MS_NN__B_SUM(s) MS_NN__FN(int_sum)(s)
#define MS_NN__B_DOT(s, u, e) _mm256_add_epi32(s, _mm256_madd_epi16(_mm256_maddubs_epi16(u, e), _mm256_set1_epi16(1)))
MS_NN__INLINE int32_t MS_NN__FN(int_sum)(__m256i s)
{
    __m128i t = _mm_add_epi32(_mm256_castsi256_si128(s), _mm256_extracti128_si256(s, 1));
    t = _mm_add_epi32(t, _mm_shuffle_epi32(t, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(t, _mm_shuffle_epi32(t, 0xB1)));
}
#elif MS_NN__ISA == 2 && defined(MS__X64)
#define MS_NN__B_INTS __m128i
#define MS_NN__B_BYTES 16
#define MS_NN__B_ZERO _mm_setzero_si128()
#define MS_NN__B_LOAD(p) _mm_loadu_si128((const __m128i *)(const void *)(p))
#define MS_NN__B_SUM(s) MS_NN__FN(int_sum)(s)
#define MS_NN__B_DOT(s, u, e) MS_NN__FN(int_dot)(s, u, e)
MS_NN__INLINE int32_t MS_NN__FN(int_sum)(__m128i s)
{
    s = _mm_add_epi32(s, _mm_shuffle_epi32(s, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(s, _mm_shuffle_epi32(s, 0xB1)));
}
MS_NN__INLINE MS_NN__B_INTS MS_NN__FN(int_dot)(MS_NN__B_INTS s, MS_NN__B_INTS u, MS_NN__B_INTS e)
{
    MS_NN__B_INTS zero = _mm_setzero_si128(); /* bytes to 16 bits with their sign */
    s = _mm_add_epi32(
        s,
        _mm_madd_epi16(_mm_srai_epi16(_mm_unpacklo_epi8(zero, u), 8), _mm_srai_epi16(_mm_unpacklo_epi8(zero, e), 8)));
    return _mm_add_epi32(
        s,
        _mm_madd_epi16(_mm_srai_epi16(_mm_unpackhi_epi8(zero, u), 8), _mm_srai_epi16(_mm_unpackhi_epi8(zero, e), 8)));
}
#elif MS_NN__ISA == 2
#define MS_NN__B_INTS int32x4_t
#define MS_NN__B_BYTES 16
#define MS_NN__B_ZERO vdupq_n_s32(0)
#define MS_NN__B_LOAD(p) vreinterpretq_s32_u8(vld1q_u8((const unsigned char *)(p)))
#define MS_NN__B_SUM(s) vaddvq_s32(s)
#define MS_NN__B_DOT(s, u, e) MS_NN__FN(int_dot)(s, vreinterpretq_s8_s32(u), vreinterpretq_s8_s32(e))
MS_NN__INLINE MS_NN__B_INTS MS_NN__FN(int_dot)(MS_NN__B_INTS s, int8x16_t u, int8x16_t e)
{
    return vpadalq_s16(s, vmlal_s8(vmull_s8(vget_low_s8(u), vget_low_s8(e)), vget_high_s8(u), vget_high_s8(e)));
}
#else
#define MS_NN__B_INTS int32_t
#define MS_NN__B_BYTES 1
#define MS_NN__B_ZERO 0
#define MS_NN__B_LOAD(p) ((int32_t)(signed char)*(p))
#define MS_NN__B_SUM(s) (s)
#define MS_NN__B_DOT(s, u, e) ((s) + (u) * (e))
#endif
#ifndef MS_NN__B_PART
#define MS_NN__B_PART(p, n) MS_NN__FN(int8_part)(p, n)
MS_NN__INLINE MS_NN__B_INTS MS_NN__FN(int8_part)(const unsigned char *p, size_t n)
{
    unsigned char copy[MS_NN__B_BYTES];
    memset(copy, 0, sizeof copy);
    memcpy(copy, p, ms_nn__min(n, MS_NN__B_BYTES));
    return MS_NN__B_LOAD(copy);
}
#endif
#ifndef MS_NN__B_FLIP
#define MS_NN__B_FLIP(u) (u)
#define MS_NN__B_OFFSET 0
#else
#define MS_NN__B_OFFSET 128
#endif

/* A row that is read alone comes from memory (ms_nn__pack_dense). It is asked for 8 kB ahead, over the ends of pages,
   where the processor's own prefetching stops: 1.35 times as fast on Zen 4 with small pages, 1.15 times with large
   ones. A request behind the end of the matrix does no harm. */
#if defined(MS__X64) && MS_NN__ISA > 1
#define MS_NN__B_ASK(p) _mm_prefetch((const char *)(p) + 8192, _MM_HINT_T1)
#else
#define MS_NN__B_ASK(p) ((void)0)
#endif

/* Adds the products of n <= MS_NN__B_BYTES columns of a row; the digits behind the end are zero. */
MS_NN__INLINE void MS_NN__FN(int8_step)(const unsigned char *w, const signed char *const *d, size_t at, size_t n,
                                        MS_NN__B_INTS s[3])
{
    MS_NN__B_INTS u = n == MS_NN__B_BYTES ? MS_NN__B_LOAD(w + at) : MS_NN__B_PART(w + at, n);
    int k;
    MS_NN__B_ASK(w + at);
    MS_NN__UNROLL
    for (k = 0; k < 3; ++k) s[k] = MS_NN__B_DOT(s[k], MS_NN__B_FLIP(u), MS_NN__B_LOAD(d[k] + at));
}

/* Rows times all samples, row by row: y = scale unit (16384 s0 + 128 s1 + s2) + bias of the sums of w_j d_k,j, which
   are integers over runs of columns, so exact in any order; together in double, where they are exact too; rounded
   once. */
MS_NN__KERNEL void MS_NN__FN(dense_int8)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    const ms_nn__matrix *m = job->m;
    size_t row, at, end;
    int b, k;
    for (row = row0; row < row1; ++row)
        for (b = 0; b < job->batch; ++b) {
            const unsigned char *w = m->w + row * m->cols;
            const ms_nn__digits *x = &job->digits[b];
            double total = 0;
            for (at = 0; at < m->cols; at = end) {
                size_t run = at / MS_NN__RUN;
                MS_NN__B_INTS s[3];
                end = ms_nn__min(m->cols, at + MS_NN__RUN);
                MS_NN__UNROLL
                for (k = 0; k < 3; ++k) s[k] = MS_NN__B_ZERO;
                for (; at + MS_NN__B_BYTES <= end; at += MS_NN__B_BYTES)
                    MS_NN__FN(int8_step)(w, x->d, at, MS_NN__B_BYTES, s);
                if (at < end) MS_NN__FN(int8_step)(w, x->d, at, end - at, s);
                MS_NN__UNROLL
                for (k = 0; k < 3; ++k)
                    total += (k == 0       ? 16384.0
                                  : k == 1 ? 128.0
                                           : 1.0) *
                        (double)(MS_NN__B_SUM(s[k]) - MS_NN__B_OFFSET * x->sum[k][run]);
            }
            job->y[(size_t)b * m->rows + row] = (float)(total * ((double)ms_nn__float_at(m->scale, row) * x->unit) +
                                                        (m->bias && !job->linear ? (double)ms_nn__float_at(m->bias, row)
                                                                                 : 0.0));
        }
}
#endif

#if MS_NN__ISA < 5 /* the VNNI pass is for I8 only; the rest is AVX-512's */
/* A vector that is used several times is loaded once: GCC would read it anew for each use, and 64-byte loads are what
   these loops wait for. */
#if MS_NN__ISA >= 3 && (defined(__GNUC__) || defined(__clang__))
#define MS_NN__V_KEEP(v) __asm__("" : "+v"(v))
#else
#define MS_NN__V_KEEP(v) ((void)0)
#endif

/* Where narrow weights are slow to widen, packed ones are at load. */
#if MS_NN__ISA == 1 || (MS_NN__ISA == 2 && defined(MS__X64))
#define MS_NN__B_WIDEN 1
#else
#define MS_NN__B_WIDEN 0
#endif

/* MS_NN__V_LANES weights of a type that is a constant where this is inlined. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(weight)(const unsigned char *p, ms_nn_dtype dtype)
{
    if (dtype == MS_NN_F32) return MS_NN__V_LOAD(p);
    if (dtype == MS_NN_F16) return MS_NN__W_HALF(p);
    if (dtype == MS_NN_BF16) return MS_NN__W_BRAIN(p);
    return MS_NN__W_INT8(p);
}

/* n <= MS_NN__V_LANES weights, zeros behind them; nothing behind them is read. */
#if MS_NN__ISA == 4
#define MS_NN__W_PART(out, p, dtype, n) ((out) = MS_NN__FN(weight_part)(p, dtype, n))
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(weight_part)(const unsigned char *p, ms_nn_dtype dtype, size_t n)
{
    __mmask16 m = (__mmask16)((1u << n) - 1);
    if (dtype == MS_NN_F32) return _mm512_maskz_loadu_ps(m, p);
    if (dtype == MS_NN_I8)
        return _mm512_maskz_cvtepi32_ps(0xFFFF, _mm512_maskz_cvtepi8_epi32(0xFFFF, _mm_maskz_loadu_epi8(m, p)));
    if (dtype == MS_NN_F16) return _mm512_maskz_cvtph_ps(0xFFFF, _mm256_maskz_loadu_epi16(m, p));
    return _mm512_castsi512_ps(
        _mm512_maskz_slli_epi32(0xFFFF, _mm512_maskz_cvtepu16_epi32(0xFFFF, _mm256_maskz_loadu_epi16(m, p)), 16));
}
#else
#if MS_NN__ISA == 3
#define MS_NN__W_PART(out, p, dtype, n)                                                                  \
    if ((dtype) == MS_NN_F32)                                                                            \
        (out) = _mm256_maskload_ps(                                                                      \
            (const float *)(const void *)(p),                                                            \
            _mm256_cmpgt_epi32(_mm256_set1_epi32((int)(n)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7))); \
    else MS_NN__FN(weight_part)(&(out), p, dtype, n)
#else
#define MS_NN__W_PART(out, p, dtype, n) MS_NN__FN(weight_part)(&(out), p, dtype, n)
#endif
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(weight_part)(MS_NN__V_FLOATS *out, const unsigned char *p, ms_nn_dtype dtype,
                                                       size_t n)
{
    unsigned char copy[4 * MS_NN__V_LANES];
    memset(copy, 0, sizeof copy);
    memcpy(copy, p, ms_nn__min(n, MS_NN__V_LANES) * ms_nn__bytes_of(dtype));
    *out = MS_NN__FN(weight)(copy, dtype);
}
#endif

/* Four sums of lanes, each as (l0 + l2) + (l1 + l3) of the sums of its quarters, times a scale, plus a bias. quad: four
   floats for as many rows, which repeat. */
#if defined(MS__X64) && MS_NN__ISA > 1
#define MS_NN__Q_FLOATS __m128
#define MS_NN__Q_SET(x) _mm_set1_ps(x)
MS_NN__INLINE __m128 MS_NN__FN(quad)(const unsigned char *p, int rows)
{
    __m128i two;
    if (rows == 4) return _mm_loadu_ps((const float *)(const void *)p);
    if (rows == 1) return _mm_set1_ps(ms_nn__float_at(p, 0));
    two = _mm_loadl_epi64((const __m128i *)(const void *)p);
    return _mm_castsi128_ps(_mm_unpacklo_epi64(two, two));
}
MS_NN__INLINE void MS_NN__FN(sum4)(const MS_NN__V_FLOATS *v, __m128 scale, __m128 bias, float *out)
{
    __m128 a = MS_NN__V_FOLD(v[0]), b = MS_NN__V_FOLD(v[1]), c = MS_NN__V_FOLD(v[2]), d = MS_NN__V_FOLD(v[3]);
    __m128 ab = _mm_add_ps(_mm_unpacklo_ps(a, b), _mm_unpackhi_ps(a, b)),
           cd = _mm_add_ps(_mm_unpacklo_ps(c, d), _mm_unpackhi_ps(c, d));
    _mm_storeu_ps(out, _mm_add_ps(_mm_mul_ps(_mm_add_ps(_mm_movelh_ps(ab, cd), _mm_movehl_ps(cd, ab)), scale), bias));
}
#elif MS_NN__ISA > 1
#define MS_NN__Q_FLOATS float32x4_t
#define MS_NN__Q_SET(x) vdupq_n_f32(x)
MS_NN__INLINE float32x4_t MS_NN__FN(quad)(const unsigned char *p, int rows)
{
    return rows == 4 ? MS_NN__V_LOAD(p) : vdupq_n_f32(ms_nn__float_at(p, 0)); /* MS_NN__W_ROWS is 4 */
}
MS_NN__INLINE void MS_NN__FN(sum4)(const MS_NN__V_FLOATS *v, float32x4_t scale, float32x4_t bias, float *out)
{
    float sum[4];
    int i;
    for (i = 0; i < 4; ++i) sum[i] = vaddvq_f32(v[i]);
    vst1q_f32(out, vaddq_f32(vmulq_f32(vld1q_f32(sum), scale), bias));
}
#endif

/* Dot products of rows x samples. Sum c runs over the columns MS_NN__V_LANES c + (0..MS_NN__V_LANES-1) modulo
   MS_NN__V_LANES MS_NN__W_CHAINS; the chains are added in pairs, then comes what is left of the columns, then the sum
   of the lanes. The order depends on nothing but cols, so that tiles of any shape agree. This is the end of all of
   them. */
#if MS_NN__V_LANES > 1
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(rest)(const ms_nn__dense *job, size_t row, size_t sample,
                                                MS_NN__V_FLOATS *total, int rows, int batch, size_t left)
{
    ms_nn_dtype dtype = job->m->dtype;
    MS_NN__V_FLOATS v[3], u;
    size_t cols = job->m->cols, size = ms_nn__bytes_of(dtype), at, n;
    const unsigned char *w = job->m->w + row * cols * size;
    const float *x = job->x + sample * cols;
    int r, b;
    for (at = cols - left; at < cols; at += n) {
        n = ms_nn__min(cols - at, MS_NN__V_LANES);
        for (b = 0; b < batch; ++b)
            MS_NN__W_PART(v[b], (const unsigned char *)(x + (size_t)b * cols + at), MS_NN_F32, n);
        for (r = 0; r < rows; ++r) {
            MS_NN__W_PART(u, w + ((size_t)r * cols + at) * size, dtype, n);
            for (b = 0; b < batch; ++b) total[b * rows + r] = MS_NN__V_MADD(u, v[b], total[b * rows + r]);
        }
    }
}

MS_NN__INLINE void MS_NN__FN(finish)(const ms_nn__dense *job, size_t row, size_t sample, int rows, int batch,
                                     size_t left, MS_NN__V_FLOATS *total)
{
    const ms_nn__matrix *m = job->m;
    int b, i;
    MS_NN__Q_FLOATS bias = m->bias && !job->linear ? MS_NN__FN(quad)(m->bias + 4 * row, rows) : MS_NN__Q_SET(0.0f);
    MS_NN__Q_FLOATS scale = m->scale ? MS_NN__FN(quad)(m->scale + 4 * row, rows) : MS_NN__Q_SET(1.0f);
    if (left) { /* a copy, so that the sums stay in registers without it */
        MS_NN__V_FLOATS sum[3 * MS_NN__W_ROWS];
        MS_NN__UNROLL
        for (i = 0; i < rows * batch; ++i) sum[i] = total[i];
        MS_NN__FN(rest)(job, row, sample, sum, rows, batch, left);
        MS_NN__UNROLL
        for (i = 0; i < rows * batch; ++i) total[i] = sum[i];
    }
    MS_NN__UNROLL
    for (i = 0; i < rows * batch; i += 4) { /* sums of 4 / rows samples */
        MS_NN__V_FLOATS four[4];
        float out[4];
        MS_NN__UNROLL
        for (b = 0; b < 4; ++b) four[b] = total[i + b < rows * batch ? i + b : i];
        MS_NN__FN(sum4)(four, scale, bias, out);
        MS_NN__UNROLL
        for (b = 0; b < 4; ++b)
            if (b < 4 / rows && i + b * rows < rows * batch)
                memcpy(job->y + (sample + (size_t)(i / rows + b)) * m->rows + row, out + b * rows,
                       (size_t)rows * sizeof(float));
    }
}

MS_NN__KERNEL MS_NN__APART void MS_NN__FN(finish_rows)(const ms_nn__dense *job, size_t row, size_t sample, int rows,
                                                       size_t left, MS_NN__V_FLOATS a, MS_NN__V_FLOATS b,
                                                       MS_NN__V_FLOATS c, MS_NN__V_FLOATS d)
{
    MS_NN__V_FLOATS total[4];
    total[0] = a;
    total[1] = b;
    total[2] = c;
    total[3] = d;
    if (rows == MS_NN__W_ROWS) MS_NN__FN(finish)(job, row, sample, MS_NN__W_ROWS, 1, left, total);
    else MS_NN__FN(finish)(job, row, sample, 1, 1, left, total);
}
#endif

/* `rows` rows of a type times `batch` samples, all three constants, but for what is left of the columns. */
MS_NN__INLINE void MS_NN__FN(sums)(const ms_nn__dense *job, size_t row, size_t sample, ms_nn_dtype dtype, int rows,
                                   int batch, MS_NN__V_FLOATS *total)
{
    size_t cols = job->m->cols, size = ms_nn__bytes_of(dtype), k = 0;
    const unsigned char *w[MS_NN__W_ROWS];
    const float *x[3];
    MS_NN__V_FLOATS s[MS_NN__W_ROWS][3][MS_NN__W_CHAINS];
    int r, b, c;
    MS_NN__UNROLL
    for (r = 0; r < rows; ++r) {
        w[r] = job->m->w + (row + (size_t)r) * cols * size;
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) {
            MS_NN__UNROLL
            for (c = 0; c < MS_NN__W_CHAINS; ++c) s[r][b][c] = MS_NN__V_SET(0.0f);
        }
    }
    MS_NN__UNROLL
    for (b = 0; b < batch; ++b) x[b] = job->x + (sample + (size_t)b) * cols;
#if MS_NN__ISA == 4
    if (rows == 1) {
        /* By halves of vectors: 32 bytes at a time come from memory up to 1.15 times as fast as 64 on Zen 4 with small
           pages. Lanes and order are the same. */
        __m256 half[2 * MS_NN__W_CHAINS], u;
        MS_NN__UNROLL
        for (c = 0; c < 2 * MS_NN__W_CHAINS; ++c) half[c] = _mm256_setzero_ps();
        for (; k + MS_NN__V_LANES * MS_NN__W_CHAINS <= cols; k += MS_NN__V_LANES * MS_NN__W_CHAINS) {
            MS_NN__UNROLL
            for (c = 0; c < 2 * MS_NN__W_CHAINS; ++c) {
                const unsigned char *p = w[0] + (k + 8 * (size_t)c) * size;
                if (dtype == MS_NN_F32) u = _mm256_loadu_ps((const float *)(const void *)p);
                else if (dtype == MS_NN_F16) u = _mm256_cvtph_ps(_mm_loadu_si128((const __m128i *)(const void *)p));
                else
                    u = _mm256_castsi256_ps(_mm256_slli_epi32(
                        _mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i *)(const void *)p)), 16));
                half[c] = _mm256_fmadd_ps(u, _mm256_loadu_ps(x[0] + k + 8 * (size_t)c), half[c]);
            }
        }
        MS_NN__UNROLL
        for (c = 0; c < MS_NN__W_CHAINS; ++c)
            s[0][0][c] = _mm512_castpd_ps(_mm512_maskz_insertf64x4(
                0xFF, _mm512_castps_pd(_mm512_castps256_ps512(half[2 * c])), _mm256_castps_pd(half[2 * c + 1]), 1));
    }
#endif
    for (; k + MS_NN__V_LANES * MS_NN__W_CHAINS <= cols; k += MS_NN__V_LANES * MS_NN__W_CHAINS) {
        MS_NN__UNROLL
        for (c = 0; c < MS_NN__W_CHAINS; ++c) {
            size_t at = k + (size_t)c * MS_NN__V_LANES;
            MS_NN__V_FLOATS v[3];
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) {
                v[b] = MS_NN__V_LOAD(x[b] + at);
                if (batch > 1 && MS_NN__ISA == 3) MS_NN__V_KEEP(v[b]);
            }
            MS_NN__UNROLL
            for (r = 0; r < rows; ++r) {
                MS_NN__V_FLOATS u = MS_NN__FN(weight)(w[r] + at * size, dtype);
                if (batch > 1) MS_NN__V_KEEP(u);
                MS_NN__UNROLL
                for (b = 0; b < batch; ++b) s[r][b][c] = MS_NN__V_MADD(u, v[b], s[r][b][c]);
            }
        }
    }
    MS_NN__UNROLL
    for (r = 0; r < rows; ++r) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) {
            MS_NN__V_FLOATS sum = MS_NN__V_ADD(s[r][b][0], s[r][b][1]);
#if MS_NN__W_CHAINS == 4
            sum = MS_NN__V_ADD(sum, MS_NN__V_ADD(s[r][b][2], s[r][b][3]));
#endif
            total[b * rows + r] = sum;
        }
    }
}

MS_NN__INLINE void MS_NN__FN(sums_typed)(const ms_nn__dense *job, size_t row, size_t sample, int rows, int batch,
                                         MS_NN__V_FLOATS *total)
{
    if (job->m->dtype == MS_NN_F32) MS_NN__FN(sums)(job, row, sample, MS_NN_F32, rows, batch, total);
    else if (job->m->dtype == MS_NN_F16) MS_NN__FN(sums)(job, row, sample, MS_NN_F16, rows, batch, total);
    else MS_NN__FN(sums)(job, row, sample, MS_NN_BF16, rows, batch, total);
}

#if !MS_NN__B_WIDEN
/* MS_NN__W_ROWS rows times three samples. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(tile)(const ms_nn__dense *job, size_t row, size_t sample)
{
    MS_NN__V_FLOATS total[3 * MS_NN__W_ROWS];
    MS_NN__FN(sums_typed)(job, row, sample, MS_NN__W_ROWS, 3, total);
    MS_NN__FN(finish)(job, row, sample, MS_NN__W_ROWS, 3, job->m->cols % (MS_NN__V_LANES * MS_NN__W_CHAINS), total);
}
#endif

/* `rows` rows times one sample. */
MS_NN__INLINE void MS_NN__FN(dots)(const ms_nn__dense *job, size_t row, size_t sample, int rows)
{
    MS_NN__V_FLOATS total[3 * MS_NN__W_ROWS];
    size_t left = job->m->cols % (MS_NN__V_LANES * MS_NN__W_CHAINS);
    if (rows > 1) MS_NN__FN(sums)(job, row, sample, MS_NN_F32, rows, 1, total);
    else MS_NN__FN(sums_typed)(job, row, sample, rows, 1, total);
#if MS_NN__V_LANES == 1
    {
        size_t k, cols = job->m->cols;
        ms_nn_dtype dtype = job->m->dtype;
        for (k = cols - left; k < cols; ++k)
            total[0] += MS_NN__FN(weight)(job->m->w + (row * cols + k) * ms_nn__bytes_of(dtype), dtype) *
                job->x[sample * cols + k];
        if (job->m->scale) total[0] *= ms_nn__float_at(job->m->scale, row);
        job->y[sample * job->m->rows + row] = total[0] +
            (job->m->bias && !job->linear ? ms_nn__float_at(job->m->bias, row) : 0.0f);
    }
#else
    MS_NN__FN(finish_rows)
    (job, row, sample, rows, left, total[0], total[rows > 1 ? 1 : 0], total[rows > 2 ? 2 : 0], total[rows > 3 ? 3 : 0]);
#endif
}

/* Rows times one sample: each alone, or F32 by MS_NN__W_ROWS. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(rows)(const ms_nn__dense *job, size_t row, size_t row1, size_t sample)
{
#if MS_NN__W_ROWS > 1
    if (!job->singly)
        for (; row + MS_NN__W_ROWS <= row1; row += MS_NN__W_ROWS) MS_NN__FN(dots)(job, row, sample, MS_NN__W_ROWS);
#endif
    for (; row < row1; ++row) MS_NN__FN(dots)(job, row, sample, 1);
}

/* Batches go by blocks of samples that stay in the first cache, three samples at a time; what is left over runs as if
   alone. */
MS_NN__KERNEL void MS_NN__FN(dense)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    size_t batch = (size_t)job->batch, step = ms_nn__samples(job->m->cols), row, next, b0, b1, b;
    for (b0 = 0; b0 < batch; b0 = b1) {
        b1 = ms_nn__min(b0 + step, batch);
        if (b1 - b0 < 3) {
            for (b = b0; b < b1; ++b) MS_NN__FN(rows)(job, row0, row1, b);
            continue;
        }
#if MS_NN__B_WIDEN
        for (row = row0; row < row1;
             row = next) { /* plain C: compilers make vectors of one sample's chains; SSE2: for the size */
            next = ms_nn__min(row + 8, row1);
            for (b = b0; b < b1; ++b) MS_NN__FN(rows)(job, row, next, b);
        }
#else
        for (row = row0; row < row1; row = next) {
            next = ms_nn__min(row + MS_NN__W_ROWS, row1);
            for (b = b0; next - row == MS_NN__W_ROWS && b + 3 <= b1; b += 3) MS_NN__FN(tile)(job, row, b);
            for (; b < b1; ++b) MS_NN__FN(rows)(job, row, next, b);
        }
#endif
    }
}

/* Packed weights. An output is the sum over the first half of the columns plus that over the second, each from the
   left, whatever the tile; a sample alone takes both at once, for more sums that do not wait for each other. */
#if MS_NN__V_LANES == 1
#define MS_NN__P_ROWS 4
MS_NN__KERNEL void MS_NN__FN(packed)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    const ms_nn__matrix *m = job->m;
    size_t row, b, half = (m->cols + 1) / 2, k, at;
    for (row = row0; row < row1; row += 4)
        for (b = 0; b < (size_t)job->batch; ++b) {
            const float *w = (const float *)(const void *)m->packed + row * m->cols, *x = job->x + b * m->cols;
            float total[4] = {0, 0, 0, 0};
            for (at = 0; at < m->cols; at = k) {
                float s0 = 0, s1 = 0, s2 = 0, s3 = 0;
                for (k = at; k < ms_nn__min(at + half, m->cols); ++k, w += 4) {
                    s0 += w[0] * x[k];
                    s1 += w[1] * x[k];
                    s2 += w[2] * x[k];
                    s3 += w[3] * x[k];
                }
                total[0] += s0;
                total[1] += s1;
                total[2] += s2;
                total[3] += s3;
            }
            for (k = 0; k < ms_nn__min(4, m->rows - row); ++k) {
                if (m->scale) total[k] *= ms_nn__float_at(m->scale, row + k);
                job->y[b * m->rows + row + k] = total[k] +
                    (m->bias && !job->linear ? ms_nn__float_at(m->bias, row + k) : 0.0f);
            }
        }
}

MS_NN__KERNEL void MS_NN__FN(packed_back)(const ms_nn__dense *job, size_t col0, size_t col1)
{
    size_t panels = (job->m->rows + 3) / 4, cols = job->m->cols, b, k, p;
    for (b = 0; b < (size_t)job->batch; ++b)
        for (k = col0; k < col1; ++k) {
            const float *w = (const float *)(const void *)job->m->packed + 4 * k, *g = job->x + 4 * b * panels;
            float s0 = 0, s1 = 0, s2 = 0, s3 = 0;
            for (p = 0; p < panels; ++p, w += 4 * cols, g += 4) {
                s0 += w[0] * g[0];
                s1 += w[1] * g[1];
                s2 += w[2] * g[2];
                s3 += w[3] * g[3];
            }
            job->y[b * cols + k] = (s0 + s2) + (s1 + s3);
        }
}
#else
#define MS_NN__P_ROWS (2 * MS_NN__V_LANES)
#if MS_NN__ISA == 4 || defined(MS__NEON)
#define MS_NN__P_SAMPLES 6 /* sums of 4 vectors times so many are the registers of a tile */
#else
#define MS_NN__P_SAMPLES 3
#endif

/* The sums of a tile, of the halves [vectors][batch] each, into its outputs. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(packed_end)(const ms_nn__dense *job, size_t row, size_t sample, int vectors,
                                                      int batch, const MS_NN__V_FLOATS *half0,
                                                      const MS_NN__V_FLOATS *half1)
{
    const ms_nn__matrix *m = job->m;
    size_t i;
    int v, b;
    for (v = 0; v < vectors && row < m->rows; ++v, row += MS_NN__V_LANES) {
        size_t n = m->rows - row;
        float part[MS_NN__V_LANES], *y = job->y + sample * m->rows + row;
        MS_NN__V_FLOATS scale = MS_NN__V_SET(1.0f), bias = MS_NN__V_SET(0.0f);
        if (n < MS_NN__V_LANES) { /* what is behind the last row stays as it is */
            for (i = 0; i < n; ++i) {
                float one = m->scale ? ms_nn__float_at(m->scale, row + i) : 1.0f,
                      plus = m->bias && !job->linear ? ms_nn__float_at(m->bias, row + i) : 0.0f;
                for (b = 0; b < batch; ++b) {
                    MS_NN__V_STORE(part,
                                   MS_NN__V_MADD(MS_NN__V_ADD(half0[v * batch + b], half1[v * batch + b]),
                                                 MS_NN__V_SET(one), MS_NN__V_SET(plus)));
                    y[(size_t)b * m->rows + i] = part[i];
                }
            }
            return;
        }
        if (m->scale) scale = MS_NN__V_LOAD(m->scale + 4 * row);
        if (m->bias && !job->linear) bias = MS_NN__V_LOAD(m->bias + 4 * row);
        for (b = 0; b < batch; ++b, y += m->rows)
            MS_NN__V_STORE(y, MS_NN__V_MADD(MS_NN__V_ADD(half0[v * batch + b], half1[v * batch + b]), scale, bias));
    }
}

/* Two panels, or one twice where there is no other. dtype and batch are constants. */
MS_NN__INLINE void MS_NN__FN(packed_of)(const ms_nn__dense *job, size_t row, size_t sample, ms_nn_dtype dtype,
                                        int vectors, int batch)
{
    size_t cols = job->m->cols, size = ms_nn__bytes_of(dtype), wide = 2 * MS_NN__V_LANES * size, half = (cols + 1) / 2,
           k, end, second = vectors == 4 ? cols * wide : 0;
    const unsigned char *w = job->m->packed + row * cols * size;
    const float *x = job->x + sample * cols;
    MS_NN__V_FLOATS total[2][4 * MS_NN__P_SAMPLES], s[4][MS_NN__P_SAMPLES], u, value[MS_NN__P_SAMPLES];
    int v, b, h;
    if (batch == 1) {
        MS_NN__V_FLOATS t[4];
        MS_NN__UNROLL
        for (v = 0; v < 4; ++v) s[v][0] = t[v] = MS_NN__V_SET(0.0f);
        for (k = 0; k < half; ++k) {
            const unsigned char *p = w + k * wide;
            value[0] = MS_NN__V_SET(x[k]);
            MS_NN__UNROLL
            for (v = 0; v < 4; ++v)
                s[v][0] = MS_NN__V_MADD(
                    MS_NN__FN(weight)(p + (size_t)(v / 2) * second + (size_t)(v % 2) * MS_NN__V_LANES * size, dtype),
                    value[0], s[v][0]);
            if (k + half == cols) break; /* the first half may have one more */
            value[0] = MS_NN__V_SET(x[k + half]);
            p += half * wide;
            MS_NN__UNROLL
            for (v = 0; v < 4; ++v)
                t[v] = MS_NN__V_MADD(
                    MS_NN__FN(weight)(p + (size_t)(v / 2) * second + (size_t)(v % 2) * MS_NN__V_LANES * size, dtype),
                    value[0], t[v]);
        }
        MS_NN__UNROLL
        for (v = 0; v < 4; ++v) {
            total[0][v] = s[v][0];
            total[1][v] = t[v];
        }
    }
    for (h = 0; batch > 1 && h < 2; ++h) {
        MS_NN__UNROLL
        for (v = 0; v < 4; ++v) {
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) s[v][b] = MS_NN__V_SET(0.0f);
        }
        end = h ? cols : half;
        for (k = h ? half : 0; k < end; ++k) {
            const unsigned char *p = w + k * wide;
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) value[b] = MS_NN__V_SET(x[(size_t)b * cols + k]);
            MS_NN__UNROLL
            for (v = 0; v < 4; ++v) {
                u = MS_NN__FN(weight)(p + (size_t)(v / 2) * second + (size_t)(v % 2) * MS_NN__V_LANES * size, dtype);
                MS_NN__V_KEEP(u);
                MS_NN__UNROLL
                for (b = 0; b < batch; ++b) s[v][b] = MS_NN__V_MADD(u, value[b], s[v][b]);
            }
        }
        MS_NN__UNROLL
        for (v = 0; v < 4; ++v) {
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) total[h][v * batch + b] = s[v][b];
        }
    }
    MS_NN__FN(packed_end)(job, row, sample, vectors, batch, total[0], total[1]);
}

MS_NN__INLINE void MS_NN__FN(packed_typed)(const ms_nn__dense *job, size_t row, size_t sample, ms_nn_dtype dtype,
                                           int vectors, int batch)
{
#if MS_NN__P_SAMPLES > 3
    if (batch > 3) MS_NN__FN(packed_of)(job, row, sample, dtype, vectors, MS_NN__P_SAMPLES);
    else
#endif
        if (batch == 3)
        MS_NN__FN(packed_of)(job, row, sample, dtype, vectors, 3);
    else MS_NN__FN(packed_of)(job, row, sample, dtype, vectors, 1);
}

MS_NN__KERNEL void MS_NN__FN(packed)(const ms_nn__dense *job, size_t row0, size_t row1)
{
    size_t row, b, batch = (size_t)job->batch;
    int vectors, together;
    for (row = row0; row < row1; row += 2 * MS_NN__P_ROWS) {
        vectors = row + MS_NN__P_ROWS < row1 ? 4 : 2;
        for (b = 0; b < batch; b += (size_t)together) {
            together = batch - b >= MS_NN__P_SAMPLES ? MS_NN__P_SAMPLES : batch - b >= 3 ? 3 : 1;
#if !MS_NN__B_WIDEN
            if (job->m->packed_dtype == MS_NN_F16) MS_NN__FN(packed_typed)(job, row, b, MS_NN_F16, vectors, together);
            else if (job->m->packed_dtype == MS_NN_BF16)
                MS_NN__FN(packed_typed)(job, row, b, MS_NN_BF16, vectors, together);
            else
#endif
                MS_NN__FN(packed_typed)(job, row, b, MS_NN_F32, vectors, together);
        }
    }
}
#endif

#if MS_NN__V_LANES > 1
/* Adds the products of panels, `step` bytes apart, to the sums of n columns, a vector each; dtype, batch and panels (1
   or 2) are constants. */
#define MS_NN__P_COLS 64
MS_NN__INLINE void MS_NN__FN(packed_columns)(const unsigned char *w, size_t step, ms_nn_dtype dtype, const float *g,
                                             size_t rows, size_t n, MS_NN__V_FLOATS sum[3][MS_NN__P_COLS], int batch,
                                             int panels)
{
    size_t size = ms_nn__bytes_of(dtype) * MS_NN__V_LANES, c;
    MS_NN__V_FLOATS part[4][3], u, s[3];
    int b, v;
    MS_NN__UNROLL
    for (v = 0; v < 2 * panels; ++v) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) part[v][b] = MS_NN__V_LOAD(g + (size_t)b * rows + (size_t)v * MS_NN__V_LANES);
    }
    for (c = 0; c < n; ++c, w += 2 * size) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) s[b] = sum[b][c];
        MS_NN__UNROLL
        for (v = 0; v < 2 * panels; ++v) {
            u = MS_NN__FN(weight)(w + (size_t)(v / 2) * step + (size_t)(v % 2) * size, dtype);
            if (batch > 1) MS_NN__V_KEEP(u);
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) s[b] = MS_NN__V_MADD(u, part[v][b], s[b]);
        }
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) sum[b][c] = s[b];
    }
}

/* Two panels, or one: then sample by sample. */
MS_NN__INLINE void MS_NN__FN(packed_columns_typed)(const unsigned char *w, size_t step, ms_nn_dtype dtype,
                                                   const float *g, size_t rows, size_t n,
                                                   MS_NN__V_FLOATS sum[3][MS_NN__P_COLS], int batch, int panels)
{
    int b;
    if (panels == 2 && batch == 3 && !MS_NN__B_WIDEN) MS_NN__FN(packed_columns)(w, step, dtype, g, rows, n, sum, 3, 2);
    else if (panels == 2) MS_NN__FN(packed_columns)(w, step, dtype, g, rows, n, sum, 1, 2);
    else
        for (b = 0; b < batch; ++b)
            MS_NN__FN(packed_columns)(w, step, dtype, g + (size_t)b * rows, rows, n, sum + b, 1, 1);
}

/* Output gradients times columns: the lanes of a column's sum go over the panels from the first, whatever the batch. */
MS_NN__KERNEL void MS_NN__FN(packed_back)(const ms_nn__dense *job, size_t col0, size_t col1)
{
    const ms_nn__matrix *m = job->m;
    size_t rows = (m->rows + MS_NN__P_ROWS - 1) / MS_NN__P_ROWS * MS_NN__P_ROWS,
           size = ms_nn__bytes_of(m->packed_dtype), batch = (size_t)job->batch, k, b, p, c, n;
    size_t step = MS_NN__P_ROWS * m->cols * size;
    int together, panels, i;
    for (k = col0; k < col1; k += n) {
        n = ms_nn__min(MS_NN__P_COLS, col1 - k);
        for (b = 0; b < batch; b += (size_t)together) {
            MS_NN__V_FLOATS sum[3][MS_NN__P_COLS];
            together = batch - b >= 3 && !MS_NN__B_WIDEN ? 3 : 1;
            for (i = 0; i < together; ++i)
                for (c = 0; c < MS_NN__P_COLS; ++c) sum[i][c] = MS_NN__V_SET(0.0f);
            for (p = 0; p < rows; p += (size_t)panels * MS_NN__P_ROWS) {
                const unsigned char *w = m->packed + (p * m->cols + k * MS_NN__P_ROWS) * size;
                const float *g = job->x + b * rows + p;
                panels = p + MS_NN__P_ROWS < rows ? 2 : 1;
#if !MS_NN__B_WIDEN
                if (m->packed_dtype == MS_NN_F16)
                    MS_NN__FN(packed_columns_typed)(w, step, MS_NN_F16, g, rows, n, sum, together, panels);
                else if (m->packed_dtype == MS_NN_BF16)
                    MS_NN__FN(packed_columns_typed)(w, step, MS_NN_BF16, g, rows, n, sum, together, panels);
                else
#endif
                    MS_NN__FN(packed_columns_typed)(w, step, MS_NN_F32, g, rows, n, sum, together, panels);
            }
            for (i = 0; i < together; ++i)
                for (c = 0; c < n; c += 4) {
                    float out[4];
                    MS_NN__FN(sum4)(sum[i] + c, MS_NN__Q_SET(1.0f), MS_NN__Q_SET(0.0f), out);
                    memcpy(job->y + (b + (size_t)i) * m->cols + k + c, out, ms_nn__min(4, n - c) * sizeof(float));
                }
        }
    }
}
#endif

/* out_b += g_b,0 w_0 + ... + g_b,3 w_3 over n columns, the rows in order, for `batch` samples, `stride` apart. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(axpy_rest)(const unsigned char *const *w, ms_nn_dtype dtype, const float *g,
                                                     float *out, size_t k, size_t n)
{
    float last[MS_NN__V_LANES];
    MS_NN__V_FLOATS sum, u;
    int r;
    memset(last, 0, sizeof last);
    memcpy(last, out + k, (n - k) * sizeof(float));
    sum = MS_NN__V_LOAD(last);
    for (r = 0; r < 4; ++r) {
        MS_NN__W_PART(u, w[r] + ms_nn__bytes_of(dtype) * k, dtype, n - k);
        sum = MS_NN__V_MADD(MS_NN__V_SET(g[r]), u, sum);
    }
    MS_NN__V_STORE(last, sum);
    memcpy(out + k, last, (n - k) * sizeof(float));
}

/* dtype and batch are constants. */
MS_NN__INLINE void MS_NN__FN(axpy_of)(const unsigned char *const *w, const float *g, size_t g_stride, float *out,
                                      size_t stride, size_t n, ms_nn_dtype dtype, int batch)
{
    const unsigned char *row[4];
    MS_NN__V_FLOATS factor[4][3], sum[3];
    size_t k, size = ms_nn__bytes_of(dtype);
    int r, b;
    MS_NN__UNROLL
    for (r = 0; r < 4; ++r) {
        row[r] = w[r];
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) factor[r][b] = MS_NN__V_SET(g[(size_t)b * g_stride + (size_t)r]);
    }
    for (k = 0; k + MS_NN__V_LANES <= n; k += MS_NN__V_LANES) {
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) sum[b] = MS_NN__V_LOAD(out + (size_t)b * stride + k);
        MS_NN__UNROLL
        for (r = 0; r < 4; ++r) {
            MS_NN__V_FLOATS u = MS_NN__FN(weight)(row[r] + size * k, dtype);
            if (batch > 1) MS_NN__V_KEEP(u);
            MS_NN__UNROLL
            for (b = 0; b < batch; ++b) sum[b] = MS_NN__V_MADD(factor[r][b], u, sum[b]);
        }
        MS_NN__UNROLL
        for (b = 0; b < batch; ++b) MS_NN__V_STORE(out + (size_t)b * stride + k, sum[b]);
    }
    for (b = 0; k < n && b < batch; ++b)
        MS_NN__FN(axpy_rest)(w, dtype, g + (size_t)b * g_stride, out + (size_t)b * stride, k, n);
}

MS_NN__INLINE void MS_NN__FN(axpy_typed)(const unsigned char *const *w, const float *g, size_t g_stride, float *out,
                                         size_t stride, size_t n, ms_nn_dtype dtype, int batch)
{
    if (batch == 3 && dtype == MS_NN_F32) MS_NN__FN(axpy_of)(w, g, g_stride, out, stride, n, dtype, 3);
    else MS_NN__FN(axpy_of)(w, g, g_stride, out, stride, n, dtype, 1);
}

MS_NN__KERNEL MS_NN__APART void MS_NN__FN(axpy)(const unsigned char *const *w, const float *g, size_t g_stride,
                                                float *out, size_t stride, size_t n, ms_nn_dtype dtype, int batch)
{
#if !MS_NN__B_WIDEN
    if (dtype == MS_NN_F16) MS_NN__FN(axpy_typed)(w, g, g_stride, out, stride, n, MS_NN_F16, batch);
    else if (dtype == MS_NN_BF16) MS_NN__FN(axpy_typed)(w, g, g_stride, out, stride, n, MS_NN_BF16, batch);
    else if (dtype == MS_NN_I8) MS_NN__FN(axpy_typed)(w, g, g_stride, out, stride, n, MS_NN_I8, batch);
    else
#endif
        MS_NN__FN(axpy_typed)(w, g, g_stride, out, stride, n, MS_NN_F32, batch);
    (void)dtype;
}

/* n weights as floats. */
MS_NN__INLINE void MS_NN__FN(widen_typed)(const unsigned char *p, size_t n, float *out, ms_nn_dtype dtype)
{
    size_t k = 0;
    for (; k + MS_NN__V_LANES <= n; k += MS_NN__V_LANES)
        MS_NN__V_STORE(out + k, MS_NN__FN(weight)(p + k * ms_nn__bytes_of(dtype), dtype));
    if (k < n) {
        MS_NN__V_FLOATS u;
        float last[MS_NN__V_LANES];
        MS_NN__W_PART(u, p + k * ms_nn__bytes_of(dtype), dtype, n - k);
        MS_NN__V_STORE(last, u);
        memcpy(out + k, last, (n - k) * sizeof(float));
    }
}

MS_NN__KERNEL MS_NN__APART void MS_NN__FN(widen)(const unsigned char *p, size_t n, float *out, ms_nn_dtype dtype)
{
    if (dtype == MS_NN_F16) MS_NN__FN(widen_typed)(p, n, out, MS_NN_F16);
    else if (dtype == MS_NN_BF16) MS_NN__FN(widen_typed)(p, n, out, MS_NN_BF16);
    else MS_NN__FN(widen_typed)(p, n, out, MS_NN_I8);
}

/* Four rows times the samples [b0, b1). Rows behind the last are zeros, whose n is at most MS_NN__WIDE. Of a batch n is
   at most MS_NN__COLS. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(back_rows)(const ms_nn__dense *job, size_t row, size_t last, size_t at,
                                                     size_t n, size_t b0, size_t b1, float *out)
{
    const ms_nn__matrix *m = job->m;
    size_t cols = m->cols, b;
    float g[3][4], scale[4];
    float wide[4][MS_NN__COLS]; /* narrow weights are widened once for all samples */
    const unsigned char *w[4];
    ms_nn_dtype dtype = MS_NN__B_WIDEN || b1 - b0 >= 3 ? MS_NN_F32 : m->dtype;
    int r, i, together;
    for (r = 0; r < 4; ++r) {
        int real = row + (size_t)r < last;
        w[r] = real ? m->w + ((row + (size_t)r) * cols + at) * ms_nn__bytes_of(m->dtype)
                    : (const unsigned char *)ms_nn__zeros;
        scale[r] = real && m->dtype == MS_NN_I8 ? ms_nn__float_at(m->scale, row + (size_t)r) : 1.0f;
        if (real && dtype != m->dtype) {
            MS_NN__FN(widen)(w[r], n, wide[r], m->dtype);
            w[r] = (const unsigned char *)wide[r];
        }
    }
    for (b = b0; b < b1; b += (size_t)together) {
        together = b1 - b >= 3 ? 3 : 1;
        if (row + 4 <= last && m->dtype != MS_NN_I8) { /* the gradients as they lie */
            MS_NN__FN(axpy)(w, job->x + b * m->rows + row, m->rows, out + b * cols + at, cols, n, dtype, together);
            continue;
        }
        for (i = 0; i < together; ++i)
            for (r = 0; r < 4; ++r)
                g[i][r] = row + (size_t)r < last ? job->x[(b + (size_t)i) * m->rows + row + (size_t)r] * scale[r]
                                                 : 0.0f;
        MS_NN__FN(axpy)(w, &g[0][0], 4, out + b * cols + at, cols, n, dtype, together);
    }
}

/* For a batch 64 rows of MS_NN__COLS columns stay in the second cache, 12 samples' sums over them in the first. */
MS_NN__KERNEL void MS_NN__FN(dense_back)(const ms_nn__dense *job, size_t row0, size_t row1, size_t col0, size_t col1,
                                         float *out)
{
    size_t batch = (size_t)job->batch, row, b0, b1, from, to, first, last, at, n;
    for (from = col0; from < col1; from = to) {
        to = batch > 1 || MS_NN__B_WIDEN ? ms_nn__min(from + MS_NN__COLS, col1) : col1;
        for (first = row0; first < row1; first = last) {
            last = batch > 1 ? ms_nn__min(first + 64, row1) : row1;
            for (b0 = 0; b0 < batch; b0 = b1) {
                b1 = ms_nn__min(b0 + 12, batch);
                for (row = first; row < last; row += 4)
                    for (at = from; at < to; at += n) {
                        n = row + 4 <= last ? to - at : ms_nn__min(to - at, MS_NN__WIDE);
                        MS_NN__FN(back_rows)(job, row, last, at, n, b0, b1, out);
                    }
            }
        }
    }
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
            for (j = 0; j < tile; ++j) x[j] = MS_NN__V_LOAD(p + j * MS_NN__V_LANES);
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
            for (j = 0; j < tile; ++j) MS_NN__V_STORE(out + (size_t)i * out_plane + j * MS_NN__V_LANES, sum[i][j]);
        }
    }
}

MS_NN__KERNEL MS_NN__APART void MS_NN__FN(conv_tile)(const ms_nn__conv *v, const float *in, const float *w,
                                                     const float *bias, float *out, size_t out_plane, size_t outs,
                                                     size_t tile)
{
    if (tile == MS_NN__V_TILE) MS_NN__FN(conv_tile_of)(v, in, w, bias, out, out_plane, outs, MS_NN__V_TILE);
    else MS_NN__FN(conv_tile_of)(v, in, w, bias, out, out_plane, outs, 1);
}

MS_NN__KERNEL void MS_NN__FN(activate)(float *y, size_t n, ms_nn__activation activation, float alpha);

/* Four rows of n floats in place: d0 - d2, d1 + d2, d2 - d1, d1 - d3. */
MS_NN__KERNEL void MS_NN__FN(combine)(float *rows, size_t n)
{
    float *d0 = rows, *d1 = rows + n, *d2 = d1 + n, *d3 = d2 + n;
    size_t i = 0;
    for (; i + MS_NN__V_LANES <= n; i += MS_NN__V_LANES) {
        MS_NN__V_FLOATS a = MS_NN__V_LOAD(d0 + i), b = MS_NN__V_LOAD(d1 + i), c = MS_NN__V_LOAD(d2 + i),
                        d = MS_NN__V_LOAD(d3 + i);
        MS_NN__V_STORE(d0 + i, MS_NN__V_SUB(a, c));
        MS_NN__V_STORE(d1 + i, MS_NN__V_ADD(b, c));
        MS_NN__V_STORE(d2 + i, MS_NN__V_SUB(c, b));
        MS_NN__V_STORE(d3 + i, MS_NN__V_SUB(b, d));
    }
    for (; i < n; ++i) {
        float a = d0[i], b = d1[i], c = d2[i], d = d3[i];
        d0[i] = a - c;
        d1[i] = b + c;
        d2[i] = c - b;
        d3[i] = b - d;
    }
}

/* Two rows of a block: m_j = sum over channels and columns of combination j; y0 = m0 + m1 + m2, y1 = m1 - m2 - m3. */
MS_NN__KERNEL void MS_NN__FN(conv_pair)(const ms_nn__conv_job *job, const float *in, size_t row, size_t block)
{
    const ms_nn__conv *v = job->conv;
    size_t o = block * MS_NN__V_BLOCK, outs = ms_nn__min(MS_NN__V_BLOCK, v->out.c - o),
           part = v->in.c * v->taps * MS_NN__V_BLOCK, x, i, j;
    size_t rows = ms_nn__min(2, v->out.h - row);
    const float *w = v->packed + block * 4 * part;
    float zero[MS_NN__V_BLOCK], m[4][MS_NN__V_BLOCK * MS_NN__V_TILE * MS_NN__V_LANES],
        *out = job->y + o * job->y_plane + row * job->y_row;
    for (i = 0; i < MS_NN__V_BLOCK; ++i) zero[i] = 0;
    for (x = 0; x < v->out.w;) {
        size_t left = v->out.w - x, tile = left > (MS_NN__V_TILE - 1) * MS_NN__V_LANES ? MS_NN__V_TILE : 1,
               width = ms_nn__min(left, tile * MS_NN__V_LANES);
        for (j = 0; j < 4; ++j) MS_NN__FN(conv_tile)
        (v, in + j * v->pitch + x, w + j * part, zero, m[j], MS_NN__V_TILE * MS_NN__V_LANES, MS_NN__V_BLOCK, tile);
        for (i = 0; i < outs; ++i) {
            float *m0 = m[0] + i * MS_NN__V_TILE * MS_NN__V_LANES, *m1 = m[1] + i * MS_NN__V_TILE * MS_NN__V_LANES,
                  *to = out + i * job->y_plane + x;
            MS_NN__V_FLOATS bias = MS_NN__V_SET(job->linear ? 0.0f : v->bias[o + i]);
            for (j = 0; j < tile; ++j) {
                MS_NN__V_FLOATS a = MS_NN__V_LOAD(m1 + j * MS_NN__V_LANES),
                                b = MS_NN__V_LOAD(m[2] + i * MS_NN__V_TILE * MS_NN__V_LANES + j * MS_NN__V_LANES);
                MS_NN__V_STORE(
                    m1 + j * MS_NN__V_LANES,
                    MS_NN__V_SUB(MS_NN__V_ADD(bias, MS_NN__V_SUB(a, b)),
                                 MS_NN__V_LOAD(m[3] + i * MS_NN__V_TILE * MS_NN__V_LANES + j * MS_NN__V_LANES)));
                MS_NN__V_STORE(
                    m0 + j * MS_NN__V_LANES,
                    MS_NN__V_ADD(MS_NN__V_ADD(bias, MS_NN__V_ADD(a, b)), MS_NN__V_LOAD(m0 + j * MS_NN__V_LANES)));
            }
            memcpy(to, m0, width * sizeof(float));
            if (rows == 2) memcpy(to + job->y_row, m1, width * sizeof(float));
        }
        x += width;
    }
    for (i = 0; job->activation != MS_NN__LINEAR && !job->linear && i < outs; ++i)
        for (j = 0; j < rows; ++j)
            MS_NN__FN(activate)(out + i * job->y_plane + j * job->y_row, v->out.w, job->activation, job->alpha);
}

/* One row of a block. Tiles that stand over the row's end, or whose outputs lie apart, go through a buffer. */
MS_NN__KERNEL void MS_NN__FN(conv_row)(const ms_nn__conv_job *job, const float *in, size_t row, size_t block)
{
    const ms_nn__conv *v = job->conv;
    size_t o = block * MS_NN__V_BLOCK, outs = ms_nn__min(MS_NN__V_BLOCK, v->out.c - o), x, i, j;
    const float *w = v->packed + block * v->in.c * v->taps * MS_NN__V_BLOCK;
    float bias[MS_NN__V_BLOCK], buffer[MS_NN__V_BLOCK * MS_NN__V_TILE * MS_NN__V_LANES],
        *out = job->y + o * job->y_plane + row * job->y_row;
    for (i = 0; i < MS_NN__V_BLOCK; ++i) bias[i] = job->linear ? 0.0f : v->bias[o + i];
    for (x = 0; x < v->out.w;) {
        size_t left = v->out.w - x, tile = left > (MS_NN__V_TILE - 1) * MS_NN__V_LANES ? MS_NN__V_TILE : 1,
               width = ms_nn__min(left, tile * MS_NN__V_LANES);
        int direct = width == tile * MS_NN__V_LANES && job->y_step == 1 && !job->accumulate;
        float *to = direct ? out + x : buffer;
        size_t plane = direct ? job->y_plane : MS_NN__V_TILE * MS_NN__V_LANES;
        MS_NN__FN(conv_tile)(v, in + x, w, bias, to, plane, outs, tile);
        for (i = 0; !direct && i < outs; ++i)
            for (j = 0; j < width; ++j) {
                float *y = out + i * job->y_plane + (x + j) * job->y_step;
                *y = job->accumulate ? *y + buffer[i * MS_NN__V_TILE * MS_NN__V_LANES + j]
                                     : buffer[i * MS_NN__V_TILE * MS_NN__V_LANES + j];
            }
        x += width;
    }
    for (i = 0; job->activation != MS_NN__LINEAR && !job->linear && i < outs; ++i)
        MS_NN__FN(activate)(out + i * job->y_plane, v->out.w, job->activation, job->alpha);
}

MS_NN__KERNEL void MS_NN__FN(conv)(const ms_nn__conv_job *job, size_t strip, const float *padded)
{
    const ms_nn__conv *v = job->conv;
    size_t blocks = (v->out.c + MS_NN__V_BLOCK - 1) / MS_NN__V_BLOCK, row0 = strip * v->strip,
           row1 = ms_nn__min(row0 + v->strip, v->out.h), row, block;
    for (row = row0; row < row1; row += v->pairs ? 2 : 1)
        for (block = 0; block < blocks; ++block) {
            if (v->pairs) MS_NN__FN(conv_pair)(job, padded + (row - row0) * 2 * v->pitch, row, block);
            else MS_NN__FN(conv_row)(job, padded + (row - row0) * v->stride[0] * v->pitch, row, block);
        }
}

/* e^x - c, c = 0 or 1, for x <= 88, subnormal results included: x = n ln 2 + r, 2^n (e^r - 1) + (2^n - c), 2^n in two
   factors; e^r - 1 = r + r^2 q(r) with the Taylor coefficients 1/2 to 1/5040, |r| <= 0.347: relative error below 2
   ulp. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(exp_minus)(MS_NN__V_FLOATS x, MS_NN__V_FLOATS c)
{
    MS_NN__V_FLOATS r, q, s, t, half;
    MS_NN__V_INT n;
    x = MS_NN__V_MAX(MS_NN__V_SET(-104.0f), MS_NN__V_MIN(MS_NN__V_SET(88.0f), x));
    n = MS_NN__V_ROUND(MS_NN__V_MUL(x, MS_NN__V_SET(1.44269504f)));
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
    q = MS_NN__V_MADD(MS_NN__V_MUL(r, r), q, r);
    n = MS_NN__V_ROUND(MS_NN__V_MUL(t, MS_NN__V_SET(0.5f)));
    s = MS_NN__V_POW2(n);
    n = MS_NN__V_ROUND(MS_NN__V_SUB(t, MS_NN__V_FROM_INT(n)));
    half = MS_NN__V_POW2(n);
    return MS_NN__V_MADD(MS_NN__V_MUL(s, q), half, MS_NN__V_SUB(MS_NN__V_MUL(s, half), c));
}

/* ln(1 + e) for e in [0, 1]: 2 artanh(z), z = e / (2 + e) <= 1/3; the series to z^15 leaves 1e-9. 2 z first: e may be
   subnormal. */
MS_NN__INLINE MS_NN__V_FLOATS MS_NN__FN(log1p)(MS_NN__V_FLOATS e)
{
    MS_NN__V_FLOATS two = MS_NN__V_DIV(MS_NN__V_ADD(e, e), MS_NN__V_ADD(e, MS_NN__V_SET(2.0f))),
                    s = MS_NN__V_MUL(two, MS_NN__V_MUL(MS_NN__V_SET(0.25f), two));
    MS_NN__V_FLOATS q = MS_NN__V_SET(1.0f / 15);
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 13));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 11));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 9));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 7));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(0.2f));
    q = MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f / 3));
    return MS_NN__V_MUL(two, MS_NN__V_MADD(q, s, MS_NN__V_SET(1.0f)));
}

/* y = f(x), or with slope y *= f'(x), for n floats, whole vectors. All but relu and leaky_relu share e = e^-|x|, or
   what stands for it; which of them it is, is the same for every vector and costs a branch that is foreseen. Slopes are
   functions of x: those of y
   lose their digits where f is flat. */
MS_NN__KERNEL MS_NN__APART void MS_NN__FN(curve)(const float *x, float *y, size_t n, ms_nn__activation activation,
                                                 float alpha, int slope)
{
    MS_NN__V_FLOATS zero = MS_NN__V_SET(0.0f), one = MS_NN__V_SET(1.0f), a = MS_NN__V_SET(alpha), v, e, f, up;
    MS_NN__V_FLOATS c = MS_NN__V_SET(!slope && (activation == MS_NN__ELU || activation == MS_NN__TANH) ? 1.0f : 0.0f);
    size_t i;
    for (i = 0; i < n; i += MS_NN__V_LANES) {
        v = MS_NN__V_LOAD(x + i);
        if (activation == MS_NN__RELU) {
            f = slope ? MS_NN__V_IF_GREATER(v, zero, one, zero) : MS_NN__V_MAX(zero, v);
        } else if (activation == MS_NN__LEAKY) {
            f = MS_NN__V_IF_GREATER(v, zero, slope ? one : v, slope ? a : MS_NN__V_MUL(MS_NN__V_MIN(zero, v), a));
        } else {
            e = MS_NN__V_MAX(MS_NN__V_SUB(zero, v), v); /* |x| */
            e = activation == MS_NN__ELU    ? MS_NN__V_MIN(zero, v)
                : activation == MS_NN__TANH ? MS_NN__V_MUL(MS_NN__V_SET(-2.0f), MS_NN__V_MIN(MS_NN__V_SET(64.0f), e))
                                            : MS_NN__V_SUB(zero, e);
            e = MS_NN__FN(exp_minus)(e, c);
            if (activation == MS_NN__ELU) {
                f = MS_NN__V_IF_GREATER(v, zero, slope ? one : v, MS_NN__V_MUL(a, e));
            } else if (activation == MS_NN__TANH && !slope) { /* e = e^-2|x| - 1: -e / (2 + e) */
                f = MS_NN__V_DIV(MS_NN__V_SUB(zero, e), MS_NN__V_ADD(e, MS_NN__V_SET(2.0f)));
                f = MS_NN__V_IF_GREATER(zero, v, MS_NN__V_SUB(zero, f), f);
            } else {
                f = MS_NN__V_DIV(one, MS_NN__V_ADD(one, e));
                up = MS_NN__V_MUL(f, MS_NN__V_IF_GREATER(zero, v, e, one)); /* sigmoid(x) */
                if (activation == MS_NN__SIGMOID) f = slope ? MS_NN__V_MUL(MS_NN__V_MUL(f, f), e) : up;
                else if (activation == MS_NN__TANH)
                    f = MS_NN__V_MUL(MS_NN__V_SET(4.0f), MS_NN__V_MUL(MS_NN__V_MUL(f, f), e));
                else if (activation == MS_NN__SOFTPLUS)
                    f = slope ? up : MS_NN__V_ADD(MS_NN__V_MAX(zero, v), MS_NN__FN(log1p)(e));
                else
                    f = slope
                        ? MS_NN__V_MADD(MS_NN__V_MUL(up, v), MS_NN__V_MUL(f, MS_NN__V_IF_GREATER(zero, v, one, e)), up)
                        : MS_NN__V_MUL(v, up); /* silu */
            }
        }
        MS_NN__V_STORE(y + i, slope ? MS_NN__V_MUL(MS_NN__V_LOAD(y + i), f) : f);
    }
}

/* y = f(y). */
MS_NN__KERNEL void MS_NN__FN(activate)(float *y, size_t n, ms_nn__activation activation, float alpha)
{
    size_t whole = n - n % MS_NN__V_LANES;
    float last[MS_NN__V_LANES];
    if (activation == MS_NN__LINEAR) return;
    if (activation == MS_NN__GELU) {
        ms_nn__gelu(y, y, n, 0);
        return;
    }
    MS_NN__FN(curve)(y, y, whole, activation, alpha, 0);
    if (whole == n) return;
    memset(last, 0, sizeof last);
    memcpy(last, y + whole, (n - whole) * sizeof(float));
    MS_NN__FN(curve)(last, last, MS_NN__V_LANES, activation, alpha, 0);
    memcpy(y + whole, last, (n - whole) * sizeof(float));
}

/* g *= f'(x); for relu and leaky_relu x may be f's value. */
MS_NN__KERNEL void MS_NN__FN(derive)(const float *x, float *g, size_t n, ms_nn__activation activation, float alpha)
{
    size_t whole = n - n % MS_NN__V_LANES;
    float last[2][MS_NN__V_LANES];
    if (activation == MS_NN__LINEAR) return;
    if (activation == MS_NN__GELU) {
        ms_nn__gelu(x, g, n, 1);
        return;
    }
    MS_NN__FN(curve)(x, g, whole, activation, alpha, 1);
    if (whole == n) return;
    memset(last, 0, sizeof last);
    memcpy(last[0], x + whole, (n - whole) * sizeof(float));
    memcpy(last[1], g + whole, (n - whole) * sizeof(float));
    MS_NN__FN(curve)(last[0], last[1], MS_NN__V_LANES, activation, alpha, 1);
    memcpy(g + whole, last[1], (n - whole) * sizeof(float));
}

#if MS_NN__ISA != 4 /* AVX-512 takes AVX2's */
/* Maxima of n windows of 2 x 2 in two rows; a NaN wins. */
MS_NN__KERNEL void MS_NN__FN(pool2)(const float *x, size_t row, float *y, size_t n)
{
    size_t j = 0;
#if MS_NN__V_LANES > 1
    for (; j + MS_NN__V_LANES <= n; j += MS_NN__V_LANES) {
        const float *p = x + 2 * j, *q = p + row;
        MS_NN__V_FLOATS a = MS_NN__V_MAX_NAN(MS_NN__V_LOAD(p), MS_NN__V_LOAD(q));
        MS_NN__V_FLOATS b = MS_NN__V_MAX_NAN(MS_NN__V_LOAD(p + MS_NN__V_LANES), MS_NN__V_LOAD(q + MS_NN__V_LANES));
        MS_NN__V_STORE(y + j, MS_NN__V_PAIR_MAX(a, b));
    }
#endif
    for (; j < n; ++j)
        y[j] = ms_nn__max_nan(ms_nn__max_nan(x[2 * j], x[2 * j + row]),
                              ms_nn__max_nan(x[2 * j + 1], x[2 * j + row + 1]));
}
#endif

/* For the size SSE2 takes plain C's, and AVX-512 AVX2's, which are as fast on Zen 4. */
#if !defined(MS_NN_NO_COLLAPSE) && MS_NN__ISA != 4 && !(MS_NN__ISA == 2 && defined(MS__X64))
/* --- double precision, for the collapse: vectors of MS_NN__D_LANES --- */

#if MS_NN__ISA == 1
#define MS_NN__D_LANES 1
#define MS_NN__D_DOUBLES double
#define MS_NN__D_LOAD(p) (*(p))
#define MS_NN__D_STORE(p, v) (*(p) = (v))
#define MS_NN__D_SET(x) (x)
#define MS_NN__D_WIDEN(p) ((double)*(p))
#define MS_NN__D_MUL(a, b) ((a) * (b))
#define MS_NN__D_MADD(a, b, c) ((a) * (b) + (c))
#elif MS_NN__ISA == 2
#define MS_NN__D_LANES 2
#define MS_NN__D_DOUBLES float64x2_t
#define MS_NN__D_LOAD(p) vld1q_f64(p)
#define MS_NN__D_STORE(p, v) vst1q_f64(p, v)
#define MS_NN__D_SET(x) vdupq_n_f64(x)
#define MS_NN__D_WIDEN(p) vcvt_f64_f32(vld1_f32(p))
#define MS_NN__D_MUL(a, b) vmulq_f64(a, b)
#define MS_NN__D_MADD(a, b, c) vfmaq_f64(c, a, b)
#elif MS_NN__ISA == 3
#define MS_NN__D_LANES 4
#define MS_NN__D_DOUBLES __m256d
#define MS_NN__D_LOAD(p) _mm256_loadu_pd(p)
#define MS_NN__D_STORE(p, v) _mm256_storeu_pd(p, v)
#define MS_NN__D_SET(x) _mm256_set1_pd(x)
#define MS_NN__D_WIDEN(p) _mm256_cvtps_pd(_mm_loadu_ps(p))
#define MS_NN__D_MUL(a, b) _mm256_mul_pd(a, b)
#define MS_NN__D_MADD(a, b, c) _mm256_fmadd_pd(a, b, c)
#endif

/* out[i][k] = a_i . b_k for na x nb columns (at most 4 x 2) of n elements, `stride` apart. */
MS_NN__INLINE void MS_NN__FN(gram_tile)(const double *a, const double *b, size_t stride, size_t n, double *out,
                                        size_t out_stride, int na, int nb)
{
    MS_NN__D_DOUBLES s[4][2];
    double lane[4][2][MS_NN__D_LANES];
    size_t j = 0, rest;
    int i, k, l;
    MS_NN__UNROLL
    for (i = 0; i < na; ++i) {
        MS_NN__UNROLL
        for (k = 0; k < nb; ++k) s[i][k] = MS_NN__D_SET(0.0);
    }
    for (; j + MS_NN__D_LANES <= n; j += MS_NN__D_LANES) {
        MS_NN__D_DOUBLES v[2];
        MS_NN__UNROLL
        for (k = 0; k < nb; ++k) v[k] = MS_NN__D_LOAD(b + (size_t)k * stride + j);
        MS_NN__UNROLL
        for (i = 0; i < na; ++i) {
            MS_NN__D_DOUBLES u = MS_NN__D_LOAD(a + (size_t)i * stride + j);
            MS_NN__UNROLL
            for (k = 0; k < nb; ++k) s[i][k] = MS_NN__D_MADD(u, v[k], s[i][k]);
        }
    }
    MS_NN__UNROLL
    for (i = 0; i < na; ++i) {
        MS_NN__UNROLL
        for (k = 0; k < nb; ++k) MS_NN__D_STORE(lane[i][k], s[i][k]);
    }
    for (i = 0; i < na; ++i)
        for (k = 0; k < nb; ++k) {
            double sum = 0;
            for (l = 0; l < MS_NN__D_LANES; ++l) sum += lane[i][k][l];
            for (rest = j; rest < n; ++rest) sum += a[(size_t)i * stride + rest] * b[(size_t)k * stride + rest];
            out[(size_t)i * out_stride + (size_t)k] = sum;
        }
}

MS_NN__KERNEL void MS_NN__FN(gram)(const double *a, size_t na, const double *b, size_t nb, size_t stride, size_t n,
                                   double *out)
{
    size_t i, k;
    for (k = 0; k < nb; k += 2)
        for (i = 0; i < na; i += 4) {
            const double *ai = a + i * stride, *bk = b + k * stride;
            size_t p, q;
            if (i + 4 <= na && k + 2 <= nb) MS_NN__FN(gram_tile)(ai, bk, stride, n, out + i * nb + k, nb, 4, 2);
            else if (i + 4 <= na) MS_NN__FN(gram_tile)(ai, bk, stride, n, out + i * nb + k, nb, 4, 1);
            else
                for (p = i; p < na; ++p)
                    for (q = k; q < ms_nn__min(k + 2, nb); ++q)
                        MS_NN__FN(gram_tile)(a + p * stride, b + q * stride, stride, n, out + p * nb + q, nb, 1, 1);
        }
}

/* y_k += sum_i s_ik a_i for ny x na vectors (at most 2 x 4) of n elements, `stride` apart. */
MS_NN__INLINE void MS_NN__FN(add_tile)(double *y, const double *a, size_t stride, size_t n, const double *s,
                                       size_t s_stride, int ny, int na)
{
    MS_NN__D_DOUBLES f[4][2];
    size_t j = 0;
    int i, k;
    MS_NN__UNROLL
    for (i = 0; i < na; ++i) {
        MS_NN__UNROLL
        for (k = 0; k < ny; ++k) f[i][k] = MS_NN__D_SET(s[(size_t)i * s_stride + (size_t)k]);
    }
    for (; j + MS_NN__D_LANES <= n; j += MS_NN__D_LANES) {
        MS_NN__D_DOUBLES sum[2];
        MS_NN__UNROLL
        for (k = 0; k < ny; ++k) sum[k] = MS_NN__D_LOAD(y + (size_t)k * stride + j);
        MS_NN__UNROLL
        for (i = 0; i < na; ++i) {
            MS_NN__D_DOUBLES v = MS_NN__D_LOAD(a + (size_t)i * stride + j);
            MS_NN__UNROLL
            for (k = 0; k < ny; ++k) sum[k] = MS_NN__D_MADD(f[i][k], v, sum[k]);
        }
        MS_NN__UNROLL
        for (k = 0; k < ny; ++k) MS_NN__D_STORE(y + (size_t)k * stride + j, sum[k]);
    }
    for (; j < n; ++j)
        for (k = 0; k < ny; ++k)
            for (i = 0; i < na; ++i)
                y[(size_t)k * stride + j] += s[(size_t)i * s_stride + (size_t)k] * a[(size_t)i * stride + j];
}

/* The same for any ny and na; s [na][ny]. */
MS_NN__KERNEL void MS_NN__FN(add)(double *y, size_t ny, const double *a, size_t na, size_t stride, size_t n,
                                  const double *s)
{
    size_t i, k;
    for (k = 0; k < ny; k += 2)
        for (i = 0; i < na; i += 4) {
            double *yk = y + k * stride;
            const double *ai = a + i * stride, *sik = s + i * ny + k;
            size_t p, q;
            if (i + 4 <= na && k + 2 <= ny) MS_NN__FN(add_tile)(yk, ai, stride, n, sik, ny, 2, 4);
            else if (i + 4 <= na) MS_NN__FN(add_tile)(yk, ai, stride, n, sik, ny, 1, 4);
            else
                for (p = i; p < na; ++p)
                    for (q = k; q < ms_nn__min(k + 2, ny); ++q)
                        MS_NN__FN(add_tile)(y + q * stride, a + p * stride, stride, n, s + p * ny + q, ny, 1, 1);
        }
}

/* (a, b) = (c a - s b, s a + c b). */
MS_NN__KERNEL void MS_NN__FN(rotate)(double *a, double *b, size_t n, double c, double s)
{
    MS_NN__D_DOUBLES vc = MS_NN__D_SET(c), vs = MS_NN__D_SET(s), minus = MS_NN__D_SET(-s);
    size_t j = 0;
    for (; j + MS_NN__D_LANES <= n; j += MS_NN__D_LANES) {
        MS_NN__D_DOUBLES u = MS_NN__D_LOAD(a + j), v = MS_NN__D_LOAD(b + j);
        MS_NN__D_STORE(a + j, MS_NN__D_MADD(vc, u, MS_NN__D_MADD(minus, v, MS_NN__D_SET(0.0))));
        MS_NN__D_STORE(b + j, MS_NN__D_MADD(vs, u, MS_NN__D_MADD(vc, v, MS_NN__D_SET(0.0))));
    }
    for (; j < n; ++j) {
        double u = a[j], v = b[j];
        a[j] = c * u - s * v;
        b[j] = s * u + c * v;
    }
}

/* One row of a matrix in double, times a factor and the scale of I8. */
MS_NN__KERNEL void MS_NN__FN(row)(const ms_nn__matrix *m, size_t row, double factor, double *out)
{
    size_t size = ms_nn__bytes_of(m->dtype), at, n, k;
    const unsigned char *w = m->w + row * m->cols * size;
    float part[256];
    if (m->dtype == MS_NN_I8) factor *= (double)ms_nn__float_at(m->scale, row);
    for (at = 0; at < m->cols; at += n, out += n) {
        n = ms_nn__min(256, m->cols - at);
        if (m->dtype == MS_NN_F32) memcpy(part, w + 4 * at, 4 * n);
        else MS_NN__FN(widen)(w + at * size, n, part, m->dtype);
        for (k = 0; k + MS_NN__D_LANES <= n; k += MS_NN__D_LANES)
            MS_NN__D_STORE(out + k, MS_NN__D_MUL(MS_NN__D_SET(factor), MS_NN__D_WIDEN(part + k)));
        for (; k < n; ++k) out[k] = factor * (double)part[k];
    }
}
#endif /* MS_NN_NO_COLLAPSE */
#endif

#ifndef MS_NN_NO_COLLAPSE
#define MS_NN__D_KERNELS(level)                                                                              \
    , MS_NN__JOIN(ms_nn__gram_, level), MS_NN__JOIN(ms_nn__add_, level), MS_NN__JOIN(ms_nn__rotate_, level), \
        MS_NN__JOIN(ms_nn__row_, level)
#else
#define MS_NN__D_KERNELS(level)
#endif
#if MS_NN__ISA == 5
static const ms_nn__kernels ms_nn__table_avx512vnni = {MS_NN__V_BLOCK,
                                                       32,
                                                       0,
                                                       ms_nn__packed_avx512,
                                                       ms_nn__packed_back_avx512,
                                                       ms_nn__dense_avx512,
                                                       ms_nn__dense_int8_avx512vnni,
                                                       ms_nn__dense_back_avx512,
                                                       ms_nn__conv_avx512,
                                                       ms_nn__combine_avx512,
                                                       ms_nn__activate_avx512,
                                                       ms_nn__derive_avx512,
                                                       ms_nn__pool2_avx2 MS_NN__D_KERNELS(avx2)};
#else
#if MS_NN__ISA == 4
#define MS_NN__INT8 ms_nn__dense_int8_avx2
#define MS_NN__POOL ms_nn__pool2_avx2
#else
#define MS_NN__INT8 MS_NN__FN(dense_int8)
#define MS_NN__POOL MS_NN__FN(pool2)
#endif
#if MS_NN__ISA == 2 && defined(MS__X64)
#define MS_NN__DOUBLES scalar
#elif MS_NN__ISA == 4
#define MS_NN__DOUBLES avx2
#else
#define MS_NN__DOUBLES MS_NN__LEVEL
#endif
static const ms_nn__kernels MS_NN__FN(table) = {MS_NN__V_BLOCK,
                                                MS_NN__P_ROWS,
                                                MS_NN__B_WIDEN,
                                                MS_NN__FN(packed),
                                                MS_NN__FN(packed_back),
                                                MS_NN__FN(dense),
                                                MS_NN__INT8,
                                                MS_NN__FN(dense_back),
                                                MS_NN__FN(conv),
                                                MS_NN__FN(combine),
                                                MS_NN__FN(activate),
                                                MS_NN__FN(derive),
                                                MS_NN__POOL MS_NN__D_KERNELS(MS_NN__DOUBLES)};
#endif

#undef MS_NN__D_KERNELS
#undef MS_NN__DOUBLES
#undef MS_NN__INT8
#undef MS_NN__POOL
#undef MS_NN__W_PART
#undef MS_NN__V_KEEP
#undef MS_NN__KERNEL
#undef MS_NN__LEVEL
#undef MS_NN__ISA
#undef MS_NN__V_LANES
#undef MS_NN__V_BLOCK
#undef MS_NN__V_TILE
#undef MS_NN__W_ROWS
#undef MS_NN__W_CHAINS
#undef MS_NN__B_INTS
#undef MS_NN__B_BYTES
#undef MS_NN__B_ZERO
#undef MS_NN__B_LOAD
#undef MS_NN__B_FLIP
#undef MS_NN__B_OFFSET
#undef MS_NN__B_SUM
#undef MS_NN__B_DOT
#undef MS_NN__B_PART
#undef MS_NN__B_WIDEN
#undef MS_NN__P_ROWS
#undef MS_NN__P_SAMPLES
#undef MS_NN__P_COLS
#undef MS_NN__B_ASK
#undef MS_NN__V_MAX_NAN
#undef MS_NN__V_PAIR_MAX
#undef MS_NN__V_FLOATS
#undef MS_NN__V_LOAD
#undef MS_NN__V_STORE
#undef MS_NN__V_SET
#undef MS_NN__V_ADD
#undef MS_NN__V_SUB
#undef MS_NN__V_MUL
#undef MS_NN__V_DIV
#undef MS_NN__V_MADD
#undef MS_NN__V_MAX
#undef MS_NN__V_MIN
#undef MS_NN__V_IF_GREATER
#undef MS_NN__Q_FLOATS
#undef MS_NN__Q_SET
#undef MS_NN__V_FOLD
#undef MS_NN__V_INT
#undef MS_NN__V_ROUND
#undef MS_NN__V_FROM_INT
#undef MS_NN__V_POW2
#undef MS_NN__W_HALF
#undef MS_NN__W_BRAIN
#undef MS_NN__W_INT8
#undef MS_NN__D_LANES
#undef MS_NN__D_DOUBLES
#undef MS_NN__D_LOAD
#undef MS_NN__D_STORE
#undef MS_NN__D_SET
#undef MS_NN__D_WIDEN
#undef MS_NN__D_MUL
#undef MS_NN__D_MADD
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
