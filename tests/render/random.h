/* Random numbers of the renderers' materials and places: a stream is f(seed, number, how many were drawn), by integers
   only, so the same on any machine. Philox 4x32-10 (Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy
   as 1, 2, 3"): four words from a 128-bit counter and a 64-bit key. */
#ifndef TESTS_RENDER_RANDOM_H
#define TESTS_RENDER_RANDOM_H
#include <stdint.h>
#include <string.h>

typedef struct random_stream {
    uint32_t counter[4], key[2], word[4];
    int used; /* words of this block already given out */
} random_stream;

static inline void random__philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
    uint32_t c[4], k0 = key[0], k1 = key[1];
    int round;
    memcpy(c, counter, sizeof c);
    for (round = 0; round < 10; ++round) {
        const uint64_t p0 = (uint64_t)0xD2511F53u * c[0], p1 = (uint64_t)0xCD9E8D57u * c[2];
        c[0] = (uint32_t)(p1 >> 32) ^ c[1] ^ k0;
        c[1] = (uint32_t)p1;
        c[2] = (uint32_t)(p0 >> 32) ^ c[3] ^ k1;
        c[3] = (uint32_t)p0;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
    memcpy(out, c, sizeof c);
}

static inline random_stream random_start(uint64_t seed, uint64_t number)
{
    random_stream r;
    memset(&r, 0, sizeof r);
    r.key[0] = (uint32_t)seed;
    r.key[1] = (uint32_t)(seed >> 32);
    r.counter[2] = (uint32_t)number;
    r.counter[3] = (uint32_t)(number >> 32);
    r.used = 4;
    return r;
}

static inline uint32_t random_word(random_stream *r)
{
    if (r->used == 4) {
        random__philox(r->counter, r->key, r->word);
        if (++r->counter[0] == 0) ++r->counter[1];
        r->used = 0;
    }
    return r->word[r->used++];
}

/* Uniform in the open interval (0, 1), 53 bits. */
static inline double random_uniform(random_stream *r)
{
    const uint64_t a = random_word(r), b = random_word(r);
    return ((double)(((a << 32) | b) >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}
#endif
