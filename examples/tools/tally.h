/* A share of the photons of a run as bytes, for other processes and machines. Include after ms_mcml.h.

     bytes = tally_pack(tally, &run, first, &size);              release it with free; NULL: out of memory
     status = tally_add(tally, &run, bytes, size, &first, &error);
                                                                adds a share to a tally of the same run

   A share is the 16 characters of tally_magic, words of 64 bits, little-endian, that name the run (seed, grid, tissue),
   its first photon (and all its bits turned), and the sums of ms_mcml_sums. The reader is told which run it expects: it
   compares the words, and takes no size from the bytes. It tells which photon was the first, so that its caller can see
   to it that none is counted twice: the others, as many as the tally grew by, follow that one. */
#ifndef TALLY_H
#define TALLY_H
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What a share belongs to, beside the defaults of ms_mcml_options. */
typedef struct tally_run {
    const ms_mcml_tissue *tissue;
    const ms_mcml_grid *grid;
    uint64_t seed;
} tally_run;

static const char tally_magic[17] = "ms_mcml tally 5\n";

static inline unsigned char *tally_put(unsigned char *at, uint64_t word)
{
    int i;
    for (i = 0; i < 8; ++i) *at++ = (unsigned char)(word >> (8 * i));
    return at;
}

static inline uint64_t tally_get(const unsigned char *at)
{
    uint64_t word = 0;
    int i;
    for (i = 7; i >= 0; --i) word = word << 8 | at[i];
    return word;
}

static inline unsigned char *tally_put_real(unsigned char *at, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return tally_put(at, bits);
}

/* Bytes before the sums. */
static inline size_t tally_head_size(const tally_run *run)
{
    return 16 + 8 * (9 + 5 * (size_t)run->tissue->layer_count);
}

static inline void tally_head(const tally_run *run, unsigned char *at)
{
    const ms_mcml_tissue *t = run->tissue;
    int i;
    memcpy(at, tally_magic, 16);
    at = tally_put(at + 16, run->seed);
    at = tally_put_real(at, run->grid->dr_cm);
    at = tally_put_real(at, run->grid->dz_cm);
    at = tally_put(at, (uint64_t)run->grid->nr);
    at = tally_put(at, (uint64_t)run->grid->nz);
    at = tally_put(at, (uint64_t)run->grid->na);
    at = tally_put_real(at, t->n_above);
    at = tally_put_real(at, t->n_below);
    at = tally_put(at, (uint64_t)t->layer_count);
    for (i = 0; i < t->layer_count; ++i) {
        at = tally_put_real(at, t->layers[i].n);
        at = tally_put_real(at, t->layers[i].mu_a_per_cm);
        at = tally_put_real(at, t->layers[i].mu_s_per_cm);
        at = tally_put_real(at, t->layers[i].g);
        at = tally_put_real(at, t->layers[i].thickness_cm);
    }
}

static inline unsigned char *tally_pack(const ms_mcml *tally, const tally_run *run, uint64_t first, size_t *size)
{
    const size_t head = tally_head_size(run) + 16;
    size_t count, i;
    const int64_t *sum = ms_mcml_sums(tally, &count);
    unsigned char *bytes, *at;
    *size = 0;
    if (count > (SIZE_MAX - head) / 8) return NULL;
    *size = head + 8 * count;
    bytes = (unsigned char *)malloc(*size);
    if (bytes == NULL) return NULL;
    tally_head(run, bytes);
    tally_put(tally_put(bytes + head - 16, first), ~first);
    for (at = bytes + head, i = 0; i < count; ++i) at = tally_put(at, (uint64_t)sum[i]);
    return bytes;
}

static inline ms_status tally_fail(ms_error *error, ms_status status, const char *message)
{
    if (error == NULL) return status;
    error->status = status;
    error->position = 0;
    strcpy(error->message, message);
    return status;
}

/* *first (may be NULL) gets the share's first photon. MS_BAD_DATA: bytes that are no share, a share of another run, or
   not of this size; or sums that no run has. The tally and *first are untouched then. */
static inline ms_status tally_add(ms_mcml *tally, const tally_run *run, const void *share, size_t size, uint64_t *first,
                                  ms_error *error)
{
    const unsigned char *bytes = (const unsigned char *)share;
    const size_t names = tally_head_size(run), head = names + 16;
    size_t count, i;
    unsigned char *expected;
    int64_t *sum;
    ms_status status;
    ms_mcml_sums(tally, &count);
    if (size < 16 || memcmp(bytes, tally_magic, 16) != 0)
        return tally_fail(error, MS_BAD_DATA, "these bytes are not a saved tally");
    expected = (unsigned char *)malloc(names);
    sum = (int64_t *)malloc(count * sizeof *sum);
    if (expected) tally_head(run, expected);
    if (expected == NULL || sum == NULL) status = tally_fail(error, MS_OUT_OF_MEMORY, "no memory for the share");
    else if (size < names || memcmp(bytes, expected, names) != 0)
        status = tally_fail(error, MS_BAD_DATA, "the share is of another tissue, grid or seed");
    else if (size < head || (size - head) % 8 != 0 || (size - head) / 8 != count)
        status = tally_fail(error, MS_BAD_DATA, "the share is cut short or longer than its run");
    else if (tally_get(bytes + names) != ~tally_get(bytes + names + 8))
        status = tally_fail(error, MS_BAD_DATA, "the share's first photon is damaged");
    else {
        for (i = 0; i < count; ++i) {
            const uint64_t word = tally_get(bytes + head + 8 * i);
            sum[i] = word >> 63 ? -1 : (int64_t)word; /* ms_mcml_add refuses what is negative */
        }
        status = ms_mcml_add(tally, sum, count, error);
        if (status == MS_INVALID_ARGUMENT) status = MS_BAD_DATA;
        if (status == MS_OK && first) *first = tally_get(bytes + names);
        if (error) error->status = status;
    }
    free(expected);
    free(sum);
    return status;
}
#endif /* TALLY_H */
