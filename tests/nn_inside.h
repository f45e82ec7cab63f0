/* Inner calls of ms_nn.h that tests look at: numbers of 16 bits, activations, matrices read in place, widened weights,
   several directions at once, the features and the factor of a collapse. Static behind the implementation; in an object
   of their own where the build compiles the header once (tests/run.sh). */
#ifndef TEST_NN_INSIDE_H
#define TEST_NN_INSIDE_H
#include "ms_nn.h"
#include "test.h"
#ifdef TEST_INSIDE /* an object of the header and these functions */
#define TEST_INSIDE_BODY
#elif MS_NN_IMPLEMENTED + 0 /* 1 by the build, which links such an object; the header defines it as nothing */
#define TEST_INSIDE
#else
#define TEST_INSIDE static TEST_UNUSED
#define TEST_INSIDE_BODY
#endif

#ifdef __cplusplus
extern "C" {
#endif

TEST_INSIDE float inside_half_to_float(uint16_t half);
TEST_INSIDE uint16_t inside_half_from_float(float value);
TEST_INSIDE void inside_activate(const ms_nn *nn, const float *x, float *tangent, size_t count);
TEST_INSIDE void inside_in_place(ms_nn *nn);
TEST_INSIDE void inside_widen(const ms_nn *nn, size_t first, size_t count, double factor, double *out);
TEST_INSIDE int inside_directions(const ms_nn *nn, size_t count, const float *x, const float *dx, float *dy,
                                  void *workspace);
TEST_INSIDE ms_status inside_features(const ms_nn *nn, const float *x, float *features);
TEST_INSIDE int inside_collapse_owner(const ms_nn_collapse *c, int channel);
TEST_INSIDE double inside_collapse_factor(const ms_nn_collapse *c, int row, int column);

#ifdef TEST_INSIDE_BODY
TEST_INSIDE float inside_half_to_float(uint16_t half) { return ms__half_to_float(half); }
TEST_INSIDE uint16_t inside_half_from_float(float value) { return ms__half_from_float(value); }

/* tangent times the slope of the first operation's activation at x. */
TEST_INSIDE void inside_activate(const ms_nn *nn, const float *x, float *tangent, size_t count)
{
    nn->kernels->activate(x, tangent, count, nn->op[0].activation, nn->op[0].alpha, 1);
}

/* The first operation's matrix is read where it lies, as are those beyond what is packed. */
TEST_INSIDE void inside_in_place(ms_nn *nn) { nn->op[0].matrix.packed = NULL; }

/* Weights [first, first + count) of the first operation, of I8, times a factor. */
TEST_INSIDE void inside_widen(const ms_nn *nn, size_t first, size_t count, double factor, double *out)
{
    nn->kernels->widen(nn->op[0].matrix.w + first, count, factor, out, MS_NN_I8);
}

/* count directions at x at once; 0: more than the Jacobian takes together, or shared channels. */
TEST_INSIDE int inside_directions(const ms_nn *nn, size_t count, const float *x, const float *dx, float *dy,
                                  void *workspace)
{
    ms_nn__call call;
    ms_nn__begin(&call, nn, MS_NN_JACOBIAN, 1, x, NULL, workspace);
    if (count > call.layout.each || nn->channel_input != NULL) return 0;
    memcpy(dy, ms_nn__run_directions(&call.run, count, dx, call.layout.dvalues),
           count * ms_nn_output_size(nn) * sizeof(float));
    return 1;
}

/* The inputs of the last layer, of all channels. */
TEST_INSIDE ms_status inside_features(const ms_nn *nn, const float *x, float *features)
{
    ms_nn trunk = *nn;
    trunk.ops--;
    return ms_nn_forward(&trunk, 1, x, features, NULL);
}

/* The channel whose R this one uses. */
TEST_INSIDE int inside_collapse_owner(const ms_nn_collapse *c, int channel) { return (int)c->owner[channel]; }

/* R of the first channel. */
TEST_INSIDE double inside_collapse_factor(const ms_nn_collapse *c, int row, int column)
{
    return c->r[(size_t)row * c->wide + (size_t)column];
}
#endif
#ifdef __cplusplus
}
#endif
#endif
