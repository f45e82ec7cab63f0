/* Pictures for the examples: reads and writes PFM, PPM, PGM and PNG. No dependency; C99 and C++11.

     image im;
     const char *problem = image_read("in.pfm", &im);      NULL: fine; otherwise a sentence (static text)
     image_to_srgb(&im);
     if (!problem) problem = image_write("out.png", &im);  by extension: .pfm .ppm .pgm .png
     image_free(&im);

   PFM keeps the floats as they are, in linear light. The other formats hold 8 bits a channel (read with 16 as well):
   floats in [0, 1] that the caller encodes (image_to_srgb) before writing and decodes (image_to_linear) after reading.
   Every PNG is read: 1 to 16 bits, gray, RGB, palette, with alpha (4 channels then) and interlaced; its chunks about
   color spaces are skipped. image_resize brings a picture to another size. Files are read strictly: what is malformed,
   cut short or too long is refused. On failure no image is made and no file is left behind.

   Programs that link one object with the part that reads and writes files compile it with -DIMAGE_DEF= and themselves
   with -DIMAGE_IMPLEMENTED (as the Makefile does); otherwise it is static in each. */
#ifndef EXAMPLES_IMAGE_H
#define EXAMPLES_IMAGE_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files.h"

typedef struct image {
    int width, height, channels; /* 1 gray, 3 RGB, 4 RGBA */
    float *pixels;               /* [height][width][channels], top row first; from malloc */
} image;

/* All zero; pixels is NULL where the size is not positive, above 2^30 numbers, or more than memory holds. */
static inline image image_new(int width, int height, int channels)
{
    image im = {0, 0, 0, NULL};
    if (width < 1 || height < 1 || channels < 1 || channels > 4 || width > (1 << 30) / channels / height) return im;
    im.pixels = (float *)calloc((size_t)width * (size_t)height * (size_t)channels, sizeof(float));
    if (im.pixels == NULL) return im;
    im.width = width;
    im.height = height;
    im.channels = channels;
    return im;
}

static inline void image_free(image *im)
{
    free(im->pixels);
    memset(im, 0, sizeof *im);
}

static inline size_t image_count(const image *im)
{
    return (size_t)im->width * (size_t)im->height * (size_t)im->channels;
}

/* --- sRGB transfer functions (IEC 61966-2-1); alpha stays linear --- */

static inline float image_srgb_encode(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
}

static inline float image_srgb_decode(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : powf((encoded + 0.055f) / 1.055f, 2.4f);
}

static inline void image__map(image *im, float (*curve)(float))
{
    size_t i, n = image_count(im);
    for (i = 0; i < n; ++i)
        if (im->channels != 4 || i % 4 != 3) im->pixels[i] = curve(im->pixels[i]);
}

static inline void image_to_srgb(image *im) { image__map(im, image_srgb_encode); }
static inline void image_to_linear(image *im) { image__map(im, image_srgb_decode); }

/* --- other sizes --- */

/* The means of im over the pixels of a picture of width x height: exact areas, so that the light stays (values are
   linear, or treated as such; alpha weighs the other three). One axis at a time. */
static inline image image_resize(const image *im, int width, int height)
{
    image half = image_new(width, im->height, im->channels), out = image_new(width, height, im->channels);
    int axis, i, k, c;
    for (axis = 0; axis < 2 && half.pixels && out.pixels; ++axis) {
        const image *from = axis ? &half : im;
        image *to = axis ? &out : &half;
        int n = axis ? height : width, m = axis ? im->height : im->width, lines = axis ? width : im->height, line;
        size_t step = axis ? (size_t)width * (size_t)im->channels : (size_t)im->channels,
               skip = axis ? (size_t)im->channels : 0;
        for (line = 0; line < lines; ++line)
            for (i = 0; i < n; ++i) {
                double low = (double)i * m / n, high = (double)(i + 1) * m / n, sum[4] = {0, 0, 0, 0}, weight = 0;
                float *q = to->pixels + (size_t)i * step +
                    (axis ? (size_t)line * skip : (size_t)line * (size_t)width * (size_t)im->channels);
                for (k = (int)low; k < m && (double)k < high; ++k) {
                    double part = ((double)k + 1 < high ? (double)k + 1 : high) - ((double)k > low ? (double)k : low);
                    const float *p = from->pixels + (size_t)k * step +
                        (axis ? (size_t)line * skip : (size_t)line * (size_t)im->width * (size_t)im->channels);
                    double alpha = im->channels == 4 ? (double)p[3] : 1;
                    for (c = 0; c < im->channels; ++c) sum[c] += part * (c < 3 ? alpha : 1) * (double)p[c];
                    weight += part * alpha;
                }
                for (c = 0; c < im->channels; ++c)
                    q[c] = (float)(c == 3 ? sum[3] / (high - low) : weight > 0 ? sum[c] / weight : 0);
            }
    }
    if (half.pixels == NULL) image_free(&out);
    image_free(&half);
    return out;
}

/* --- files: here, or in an object that many programs link --- */

/* A growing array of bytes; after a failed allocation it takes no more and says so in `failed`. */
typedef struct image__bytes {
    unsigned char *data;
    size_t size, room;
    int failed;
    uint32_t bits; /* not yet written, lowest first */
    int bit_count;
} image__bytes;

/* Nearest of the 256 levels; NaN and negative values become 0, what is above 1 becomes 255. */
static inline unsigned char image_to_byte(float v) { return (unsigned char)(v > 0 ? v < 1 ? v * 255 + 0.5f : 255 : 0); }

/* Binary16, and back: nearest, ties to even; what is beyond 65504 becomes 65504. */
static inline uint16_t image_to_half(float v)
{
    float size = fabsf(v);
    int e;
    uint16_t sign = v < 0 ? 0x8000u : 0;
    if (!(size < 65504)) return (uint16_t)(sign | 0x7bffu);
    (void)frexpf(size, &e); /* size < 2^e: steps of 2^(e - 11), subnormal ones of 2^-24 */
    e = size > 0 && e > -13 ? e : -13;
    return (uint16_t)(sign | (((unsigned)(e + 13) << 10) + (unsigned)lrintf(ldexpf(size, 11 - e))));
}

static inline float image_from_half(uint16_t h)
{
    float v = (float)(h & 1023);
    int e = h >> 10 & 31;
    v = e == 31 ? (v > 0 ? NAN : INFINITY) : e ? ldexpf(v + 1024, e - 25) : ldexpf(v, -24);
    return h & 0x8000 ? -v : v;
}

static inline int image__has_extension(const char *path, const char *extension)
{
    size_t n = strlen(path), m = strlen(extension), i;
    if (n < m) return 0;
    for (i = 0; i < m; ++i) {
        int c = path[n - m + i];
        if ((c >= 'A' && c <= 'Z' ? c + 32 : c) != extension[i]) return 0;
    }
    return 1;
}

static inline void image__put(image__bytes *b, const void *data, size_t size)
{
    if (b->failed) return;
    if (b->room - b->size < size) {
        size_t room = b->room + b->room / 2 + size + 4096;
        unsigned char *more = room > size ? (unsigned char *)realloc(b->data, room) : NULL;
        if (more == NULL) {
            b->failed = 1;
            return;
        }
        b->data = more;
        b->room = room;
    }
    memcpy(b->data + b->size, data, size);
    b->size += size;
}

/* Bytes into a file as file_save does: for pictures and for anything else. */
static inline const char *image_save(const char *path, const void *data, size_t size)
{
    return file_save(path, data, size);
}

#ifndef IMAGE_DEF
#define IMAGE_DEF static inline
#endif
#ifdef IMAGE_IMPLEMENTED
const char *image__load(const char *path, image__bytes *b);
const char *image_write_png8(const char *path, const unsigned char *pixels, int width, int height, int channels);
const char *image_decode(const unsigned char *data, size_t size, image *out);
const char *image_read(const char *path, image *out);
const char *image_write(const char *path, const image *im);
#else
static inline void image__put_u32(image__bytes *b, uint32_t v) /* big-endian */
{
    unsigned char text[4];
    text[0] = (unsigned char)(v >> 24);
    text[1] = (unsigned char)(v >> 16);
    text[2] = (unsigned char)(v >> 8);
    text[3] = (unsigned char)v;
    image__put(b, text, 4);
}

static inline void image__put_bits(image__bytes *b, uint32_t value, int count) /* count <= 16 */
{
    b->bits |= value << b->bit_count;
    b->bit_count += count;
    while (b->bit_count >= 8) {
        unsigned char low = (unsigned char)(b->bits & 255);
        image__put(b, &low, 1);
        b->bits >>= 8;
        b->bit_count -= 8;
    }
}

static inline const char *image__save(const char *path, const image__bytes *b)
{
    return b->failed ? "out of memory" : image_save(path, b->data, b->size);
}

IMAGE_DEF const char *image__load(const char *path, image__bytes *b)
{
    unsigned char block[8192];
    size_t got;
    int bad;
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    if (f == NULL) return problem;
    while ((got = fread(block, 1, sizeof block, f)) > 0) image__put(b, block, got);
    bad = ferror(f);
    fclose(f);
    return bad ? "cannot read the file" : b->failed ? "out of memory" : NULL;
}

/* --- DEFLATE (RFC 1951): LZ77 with hash chains and lazy matching, blocks with their own Huffman codes --- */

enum { image__literals = 286, image__distances = 30, image__tokens = 32768, image__window = 32768, image__chain = 16 };

typedef struct image__deflate {
    uint32_t token[image__tokens]; /* a literal, or length << 16 | distance */
    int count;
    uint32_t head[32768], previous[image__window]; /* positions + 1 of equal hashes, newest first */
} image__deflate;

/* Lengths of an optimal prefix code for n <= 286 symbols, none above `limit` bits. At least two symbols get one, so
   that the code is complete. */
static inline void image__code_lengths(uint32_t *frequency, int n, int limit, unsigned char *length)
{
    int symbol[image__literals], parent[2 * image__literals], depth[2 * image__literals], in_use[64] = {0};
    uint32_t weight[2 * image__literals], total;
    int used = 0, i, k, leaf, node, next;
    for (i = 0; i < n; ++i) used += frequency[i] != 0;
    for (i = 0; used < 2; ++i)
        if (frequency[i] == 0) {
            frequency[i] = 1;
            ++used;
        }
    memset(length, 0, (size_t)n);
    for (i = 0, k = 0; i < n; ++i) { /* insertion sort, rarest first */
        int j;
        if (frequency[i] == 0) continue;
        for (j = k++; j > 0 && frequency[symbol[j - 1]] > frequency[i]; --j) symbol[j] = symbol[j - 1];
        symbol[j] = i;
    }
    for (i = 0; i < used; ++i) weight[i] = frequency[symbol[i]];
    leaf = 0;
    node = used; /* nodes come out in order of weight, so two queues suffice */
    for (next = used; next < 2 * used - 1; ++next) {
        int pair[2];
        for (k = 0; k < 2; ++k)
            pair[k] = node >= next || (leaf < used && weight[leaf] <= weight[node]) ? leaf++ : node++;
        weight[next] = weight[pair[0]] + weight[pair[1]];
        parent[pair[0]] = parent[pair[1]] = next;
    }
    depth[2 * used - 2] = 0;
    for (i = 2 * used - 3; i >= 0; --i) depth[i] = depth[parent[i]] + 1;
    for (i = 0; i < used; ++i) in_use[depth[i] < limit ? depth[i] : limit]++;
    for (total = 0, k = 1; k <= limit; ++k) total += (uint32_t)in_use[k] << (limit - k);
    while (total-- > 1u << limit) { /* Kraft's sum is too large: lengthen a shorter code */
        for (k = limit - 1; in_use[k] == 0; --k) {}
        in_use[k]--;
        in_use[k + 1] += 2;
        in_use[limit]--;
    }
    for (i = 0, k = limit; k >= 1; --k)
        for (leaf = in_use[k]; leaf > 0; --leaf) length[symbol[i++]] = (unsigned char)k;
}

/* Canonical codes of RFC 1951 section 3.2.2, bits reversed for image__put_bits. */
static inline void image__codes(const unsigned char *length, int n, uint16_t *code)
{
    int count[17] = {0}, next[17], i, k;
    for (i = 0; i < n; ++i) count[length[i]]++;
    count[0] = next[0] = 0;
    for (k = 1; k <= 16; ++k) next[k] = (next[k - 1] + count[k - 1]) << 1;
    for (i = 0; i < n; ++i) {
        int v = next[length[i]]++, reversed = 0;
        for (k = 0; k < length[i]; ++k) reversed |= ((v >> k) & 1) << (length[i] - 1 - k);
        code[i] = (uint16_t)reversed;
    }
}

/* Symbol, number of extra bits and their value for a match length (3 to 258) or a distance (1 to 32768). */
static inline int image__length_symbol(int length, int *extra, int *value)
{
    int v = length - 3, e = 0;
    while (length < 258 && v >> e >= 8) ++e;
    *extra = e;
    *value = v & ((1 << e) - 1);
    return length == 258 ? 285 : 257 + 4 * e + (v >> e);
}

static inline int image__distance_symbol(int distance, int *extra, int *value)
{
    int v = distance - 1, e = 0;
    while (v >> e >= 4) ++e;
    *extra = e;
    *value = v & ((1 << e) - 1);
    return 2 * e + (v >> e);
}

static inline void image__flush_block(image__deflate *d, image__bytes *out, int last)
{
    static const unsigned char order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    uint32_t frequency[image__literals] = {0}, distance_frequency[image__distances] = {0}, meta_frequency[19] = {0};
    unsigned char length[image__literals + image__distances], meta_length[19], meta[320], meta_extra[320];
    uint16_t code[image__literals], distance_code[image__distances], meta_code[19];
    int i, k, extra = 0, value = 0, run, n_meta = 0, n_order = 19, all = image__literals + image__distances;
    for (i = 0; i < d->count; ++i) {
        int match = (int)(d->token[i] >> 16);
        if (match) {
            frequency[image__length_symbol(match, &extra, &value)]++;
            distance_frequency[image__distance_symbol((int)(d->token[i] & 0xffff) + 1, &extra, &value)]++;
        } else {
            frequency[d->token[i]]++;
        }
    }
    frequency[256] = 1;
    image__code_lengths(frequency, image__literals, 15, length);
    image__code_lengths(distance_frequency, image__distances, 15, length + image__literals);
    image__codes(length, image__literals, code);
    image__codes(length + image__literals, image__distances, distance_code);

    for (i = 0; i < all; i += run) { /* the lengths themselves, runs shortened by the symbols 16, 17 and 18 */
        int most = length[i] ? 7 : 138, symbol;
        for (run = 1; i + run < all && length[i + run] == length[i] && run < most; ++run) {}
        symbol = length[i] ? 16 : run > 10 ? 18 : 17;
        if (run >= 3 + (length[i] != 0)) {
            if (length[i]) meta_extra[n_meta] = 0, meta[n_meta++] = length[i];
            meta_extra[n_meta] = (unsigned char)(run - (symbol == 16 ? 4 : symbol == 17 ? 3 : 11));
            meta[n_meta++] = (unsigned char)symbol;
        } else {
            run = 1;
            meta_extra[n_meta] = 0;
            meta[n_meta++] = length[i];
        }
    }
    for (i = 0; i < n_meta; ++i) meta_frequency[meta[i]]++;
    image__code_lengths(meta_frequency, 19, 7, meta_length);
    image__codes(meta_length, 19, meta_code);
    while (n_order > 4 && meta_length[order[n_order - 1]] == 0) --n_order;

    image__put_bits(out, (uint32_t)(last | 2 << 1), 3);
    image__put_bits(out, image__literals - 257, 5);
    image__put_bits(out, image__distances - 1, 5);
    image__put_bits(out, (uint32_t)(n_order - 4), 4);
    for (i = 0; i < n_order; ++i) image__put_bits(out, meta_length[order[i]], 3);
    for (i = 0; i < n_meta; ++i) {
        image__put_bits(out, meta_code[meta[i]], meta_length[meta[i]]);
        if (meta[i] >= 16) image__put_bits(out, meta_extra[i], meta[i] == 16 ? 2 : meta[i] == 17 ? 3 : 7);
    }
    for (i = 0; i < d->count; ++i) {
        int match = (int)(d->token[i] >> 16);
        k = match ? image__length_symbol(match, &extra, &value) : (int)d->token[i];
        image__put_bits(out, code[k], length[k]);
        if (match == 0) continue;
        image__put_bits(out, (uint32_t)value, extra);
        k = image__distance_symbol((int)(d->token[i] & 0xffff) + 1, &extra, &value);
        image__put_bits(out, distance_code[k], length[image__literals + k]);
        image__put_bits(out, (uint32_t)value, extra);
    }
    image__put_bits(out, code[256], length[256]);
    d->count = 0;
}

/* Longest earlier match of the bytes at `at`, of more than `best` and at most 258, or 0; *distance in [1, 32768]. */
static inline int image__match(const image__deflate *d, const unsigned char *data, size_t size, size_t at,
                               uint32_t hash, int best, int *distance)
{
    int most = size - at < 258 ? (int)(size - at) : 258, tries = best < 8 ? image__chain : image__chain / 4,
        held = best;
    uint32_t from = d->head[hash];
    while (from != 0 && at - (from - 1) <= image__window && tries-- > 0) {
        const unsigned char *a = data + at, *b = data + from - 1;
        int n = 0;
        if (best < most && b[best] == a[best] && b[best - 1] == a[best - 1]) {
            while (n < most && a[n] == b[n]) ++n;
            if (n > best) {
                best = n;
                *distance = (int)(at - (from - 1));
                if (n == most) break;
            }
        }
        if (d->previous[(from - 1) % image__window] >= from) break; /* that slot is newer: the chain ends here */
        from = d->previous[(from - 1) % image__window];
    }
    return best > held ? best : 0;
}

/* zlib stream (RFC 1950) of fewer than 2^32 bytes. */
static inline void image__zlib(image__bytes *out, const unsigned char *data, size_t size)
{
    image__deflate *d = (image__deflate *)calloc(1, sizeof *d);
    uint32_t a = 1, b = 0;
    size_t at, i, pending = 0;
    int held = 0, held_distance = 0; /* the match that began at the byte before, not yet emitted */
    if (d == NULL) {
        out->failed = 1;
        return;
    }
    image__put(out, "\x78\x9c", 2);
    for (at = 0; at < size || pending; ++at) {
        int match = 0, distance = 0;
        if (at + 2 < size) {
            uint32_t hash = ((data[at] | (uint32_t)data[at + 1] << 8 | (uint32_t)data[at + 2] << 16) * 2654435761u) >>
                17;
            if (held < 64) match = image__match(d, data, size, at, hash, held > 2 ? held : 2, &distance);
            d->previous[at % image__window] = d->head[hash];
            d->head[hash] = (uint32_t)at + 1;
        }
        if (pending && held >= match && held) { /* the older match is at least as long: take it */
            d->token[d->count++] = (uint32_t)held << 16 | (uint32_t)(held_distance - 1);
            for (i = 1; i < (size_t)held - 1; ++i) { /* its other bytes enter the hash table only */
                size_t p = at + i;
                if (p + 2 < size) {
                    uint32_t hash = ((data[p] | (uint32_t)data[p + 1] << 8 | (uint32_t)data[p + 2] << 16) *
                                     2654435761u) >>
                        17;
                    d->previous[p % image__window] = d->head[hash];
                    d->head[hash] = (uint32_t)p + 1;
                }
            }
            at += (size_t)held - 2;
            pending = 0;
            held = 0;
        } else {
            if (pending) d->token[d->count++] = data[at - 1];
            pending = at < size;
            held = match;
            held_distance = distance;
        }
        if (d->count == image__tokens) image__flush_block(d, out, 0);
    }
    image__flush_block(d, out, 1);
    if (out->bit_count) image__put_bits(out, 0, 8 - out->bit_count);
    for (at = 0; at < size;) { /* Adler-32; sums of 5552 bytes fit */
        const size_t end = size - at < 5552 ? size : at + 5552;
        for (; at < end; ++at) b += a += data[at];
        a %= 65521;
        b %= 65521;
    }
    image__put_u32(out, b << 16 | a);
    free(d);
}

/* --- PNG --- */

/* CRC-32 of a chunk's name and data (PNG specification, annex D), four bits at a time. */
static inline uint32_t image__crc(const unsigned char *data, size_t size)
{
    uint32_t table[16], crc = 0xffffffffu;
    size_t i;
    int k;
    for (i = 0; i < 16; ++i)
        for (table[i] = (uint32_t)i, k = 0; k < 4; ++k) table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xedb88320u : 0);
    for (i = 0; i < size; ++i) {
        crc ^= data[i];
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return ~crc;
}

static inline void image__chunk(image__bytes *out, const char *name, const unsigned char *data, size_t size)
{
    size_t start;
    image__put_u32(out, (uint32_t)size);
    start = out->size;
    image__put(out, name, 4);
    if (size) image__put(out, data, size);
    if (!out->failed) image__put_u32(out, image__crc(out->data + start, out->size - start));
}

/* One row through filters 0 to 4 (PNG specification, section 9) into to[5][n]; `above` is NULL for the first row.
   Returns the one with the least sum of absolute differences. */
static inline int image__filter_row(const unsigned char *row, const unsigned char *above, int n, int step,
                                    unsigned char *to)
{
    unsigned char *sub = to + n, *over = sub + n, *mean = over + n, *paeth = mean + n;
    long sum[5] = {0};
    int i, best = 0;
    for (i = 0; i < n; ++i) {
        const int left = i >= step ? row[i - step] : 0, up = above ? above[i] : 0,
                  corner = above && i >= step ? above[i - step] : 0;
        const int pa = abs(up - corner), pb = abs(left - corner), pc = abs(left + up - 2 * corner), own = row[i];
        sum[0] += abs((signed char)(to[i] = (unsigned char)own));
        sum[1] += abs((signed char)(sub[i] = (unsigned char)(own - left)));
        sum[2] += abs((signed char)(over[i] = (unsigned char)(own - up)));
        sum[3] += abs((signed char)(mean[i] = (unsigned char)(own - (left + up) / 2)));
        sum[4] += abs((signed char)(paeth[i] = (unsigned char)(own -
                                                               (pa <= pb && pa <= pc ? left
                                                                    : pb <= pc       ? up
                                                                                     : corner))));
    }
    for (i = 1; i < 5; ++i)
        if (sum[i] < sum[best]) best = i;
    return best;
}

/* pixels [height][width][channels], top row first; 1 gray, 3 RGB or 4 RGBA. */
IMAGE_DEF const char *image_write_png8(const char *path, const unsigned char *pixels, int width, int height,
                                       int channels)
{
    static const unsigned char color_type[5] = {0, 0, 0, 2, 6};
    image__bytes out, packed;
    unsigned char *rows, header[13];
    const char *problem;
    int n, y;
    size_t stride;
    if (width < 1 || height < 1 || (channels != 1 && channels != 3 && channels != 4))
        return "a PNG has 1, 3 or 4 channels";
    if (width > (1 << 30) / channels / height) return "the picture is too large";
    n = width * channels;
    stride = (size_t)n + 1;
    rows = (unsigned char *)malloc(stride * ((size_t)height + 5));
    if (rows == NULL) return "out of memory";
    for (y = 0; y < height; ++y) {
        const unsigned char *row = pixels + (size_t)y * (size_t)n, *above = y ? row - n : NULL;
        unsigned char *to = rows + (size_t)y * stride, *trial = rows + (size_t)height * stride;
        to[0] = (unsigned char)image__filter_row(row, above, n, channels, trial);
        memcpy(to + 1, trial + (size_t)to[0] * (size_t)n, (size_t)n);
    }
    memset(&out, 0, sizeof out);
    memset(&packed, 0, sizeof packed);
    image__zlib(&packed, rows, stride * (size_t)height);
    free(rows);
    image__put(&out, "\x89PNG\r\n\x1a\n", 8);
    memset(header, 0, sizeof header);
    for (n = 0; n < 4; ++n) {
        header[n] = (unsigned char)(width >> (24 - 8 * n));
        header[4 + n] = (unsigned char)(height >> (24 - 8 * n));
    }
    header[8] = 8;
    header[9] = color_type[channels];
    image__chunk(&out, "IHDR", header, sizeof header);
    image__chunk(&out, "IDAT", packed.data, packed.size);
    image__chunk(&out, "IEND", NULL, 0);
    out.failed |= packed.failed;
    problem = image__save(path, &out);
    free(packed.data);
    free(out.data);
    return problem;
}

/* --- reading PNG: INFLATE (RFC 1951), filters and passes (PNG specification, sections 8 and 9) --- */

typedef struct image__inflate {
    const unsigned char *data;
    size_t size, at;
    uint32_t bits;
    int bit_count, bad;
} image__inflate;

static inline uint32_t image__get_bits(image__inflate *z, int count) /* count <= 16 */
{
    uint32_t value;
    while (z->bit_count < count) {
        if (z->at == z->size) {
            z->bad = 1;
            return 0;
        }
        z->bits |= (uint32_t)z->data[z->at++] << z->bit_count;
        z->bit_count += 8;
    }
    value = z->bits & ((1u << count) - 1);
    z->bits >>= count;
    z->bit_count -= count;
    return value;
}

/* Symbols in the order of their codes, and how many codes each length has. */
typedef struct image__huffman {
    uint16_t count[16], symbol[288];
} image__huffman;

static inline int image__huffman_make(image__huffman *h, const unsigned char *length, int n)
{
    int next[16], i, left = 1;
    memset(h->count, 0, sizeof h->count);
    for (i = 0; i < n; ++i) h->count[length[i]]++;
    h->count[0] = 0;
    for (next[1] = 0, i = 1; i < 16; ++i) {
        left = 2 * left - h->count[i];
        if (left < 0) return 0; /* more codes than there are */
        if (i < 15) next[i + 1] = next[i] + h->count[i];
    }
    for (i = 0; i < n; ++i)
        if (length[i]) h->symbol[next[length[i]]++] = (uint16_t)i;
    return 1;
}

static inline int image__huffman_read(image__inflate *z, const image__huffman *h)
{
    int code = 0, first = 0, index = 0, i;
    for (i = 1; i < 16 && !z->bad; ++i) {
        code |= (int)image__get_bits(z, 1);
        if (code - first < h->count[i]) return h->symbol[index + code - first];
        index += h->count[i];
        first = (first + h->count[i]) << 1;
        code <<= 1;
    }
    z->bad = 1;
    return 0;
}

static inline void image__inflate_tables(image__inflate *z, image__huffman *literals, image__huffman *distances)
{
    static const unsigned char order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    unsigned char length[320];
    int n_literals = (int)image__get_bits(z, 5) + 257, n_distances = (int)image__get_bits(z, 5) + 1;
    int n_order = (int)image__get_bits(z, 4) + 4, i, n, symbol, repeat;
    memset(length, 0, sizeof length);
    for (i = 0; i < n_order; ++i) length[order[i]] = (unsigned char)image__get_bits(z, 3);
    if (!image__huffman_make(literals, length, 19)) z->bad = 1;
    for (n = 0; n < n_literals + n_distances && !z->bad;) {
        symbol = image__huffman_read(z, literals);
        repeat = symbol < 16 ? 1
            : symbol == 16   ? 3 + (int)image__get_bits(z, 2)
            : symbol == 17   ? 3 + (int)image__get_bits(z, 3)
                             : 11 + (int)image__get_bits(z, 7);
        if ((symbol == 16 && n == 0) || n + repeat > n_literals + n_distances) z->bad = 1;
        for (i = symbol == 16 && n ? length[n - 1] : symbol < 16 ? symbol : 0; repeat > 0 && !z->bad; --repeat)
            length[n++] = (unsigned char)i;
    }
    if (z->bad || length[256] == 0 || !image__huffman_make(literals, length, n_literals) ||
        !image__huffman_make(distances, length + n_literals, n_distances))
        z->bad = 1;
}

/* A zlib stream into exactly `size` bytes at `to`; 0 where it is anything else. */
static inline int image__unzip(const unsigned char *data, size_t data_size, unsigned char *to, size_t size)
{
    image__inflate z;
    image__huffman literals, distances;
    uint32_t a = 1, b = 0, sum = 0;
    size_t n = 0, i;
    int last = 0, k;
    memset(&z, 0, sizeof z);
    z.data = data;
    z.size = data_size;
    if (data_size < 6 || (data[0] & 15) != 8 || (data[0] * 256 + data[1]) % 31 != 0 || (data[1] & 32)) return 0;
    z.at = 2;
    while (!last && !z.bad) {
        int kind;
        last = (int)image__get_bits(&z, 1);
        kind = (int)image__get_bits(&z, 2);
        if (kind == 0) {
            size_t length, inverse;
            z.bit_count = 0;
            z.bits = 0;
            length = image__get_bits(&z, 16);
            inverse = image__get_bits(&z, 16);
            if (z.bad || (length ^ inverse) != 0xffff || length > z.size - z.at || length > size - n) return 0;
            memcpy(to + n, z.data + z.at, length);
            z.at += length;
            n += length;
            continue;
        }
        if (kind == 1) {
            unsigned char length[288 + 30];
            memset(length, 8, 144);
            memset(length + 144, 9, 112);
            memset(length + 256, 7, 24);
            memset(length + 280, 8, 8);
            memset(length + 288, 5, 30);
            image__huffman_make(&literals, length, 288);
            image__huffman_make(&distances, length + 288, 30);
        } else if (kind == 2) {
            image__inflate_tables(&z, &literals, &distances);
        } else {
            return 0;
        }
        while (!z.bad) {
            int symbol = image__huffman_read(&z, &literals), length, distance, extra;
            if (z.bad || symbol == 256) break;
            if (symbol < 256) {
                if (n == size) return 0;
                to[n++] = (unsigned char)symbol;
                continue;
            }
            symbol -= 257; /* the inverse of image__length_symbol and image__distance_symbol */
            if (symbol > 28) return 0;
            extra = symbol < 8 || symbol == 28 ? 0 : symbol / 4 - 1;
            length = symbol == 28 ? 258
                : symbol < 8      ? 3 + symbol
                                  : 3 + ((4 + symbol % 4) << extra) + (int)image__get_bits(&z, extra);
            symbol = image__huffman_read(&z, &distances);
            if (symbol > 29) return 0;
            extra = symbol < 4 ? 0 : symbol / 2 - 1;
            distance = symbol < 4 ? 1 + symbol : 1 + ((2 + symbol % 2) << extra) + (int)image__get_bits(&z, extra);
            if (z.bad || (size_t)distance > n || (size_t)length > size - n) return 0;
            for (; length > 0; --length, ++n) to[n] = to[n - (size_t)distance];
        }
    }
    if (z.bad || n != size) return 0;
    z.at -= (size_t)(z.bit_count / 8);
    if (z.size - z.at < 4) return 0;
    for (k = 0; k < 4; ++k) sum = sum << 8 | z.data[z.at + (size_t)k];
    for (i = 0; i < size; ++i) {
        a = (a + to[i]) % 65521;
        b = (b + a) % 65521;
    }
    return sum == (b << 16 | a);
}

static inline uint32_t image__u32(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* Undoes the filters of `rows` rows of n bytes behind their filter byte, in place. */
static inline int image__unfilter(unsigned char *rows, int n, int count, int step)
{
    int y, i;
    for (y = 0; y < count; ++y) {
        unsigned char *row = rows + (size_t)y * ((size_t)n + 1), *above = y ? row - n : NULL;
        int filter = *row++;
        if (filter > 4) return 0;
        for (i = 0; i < n; ++i) {
            int left = i >= step ? row[i - step] : 0, up = above ? above[i] : 0,
                corner = above && i >= step ? above[i - step] : 0;
            int pa = abs(up - corner), pb = abs(left - corner), pc = abs(left + up - 2 * corner), guess = 0;
            if (filter == 1) guess = left;
            if (filter == 2) guess = up;
            if (filter == 3) guess = (left + up) / 2;
            if (filter == 4) guess = pa <= pb && pa <= pc ? left : pb <= pc ? up : corner;
            row[i] = (unsigned char)(row[i] + guess);
        }
    }
    return 1;
}

/* What a PNG's chunks say. */
typedef struct image__png {
    int width, height, bits, color, interlaced, samples; /* samples of a pixel in the file */
    int colors;                                          /* of the palette */
    unsigned char palette[256][4];
    int has_alpha;
} image__png;

/* Pixel x of a row into out: 1, 3 or 4 floats, as im has channels. */
static inline int image__png_pixel(const image__png *p, const unsigned char *row, int x, int channels, float *out)
{
    float value[4] = {0, 0, 0, 1}, most = (float)((1 << p->bits) - 1);
    int k;
    for (k = 0; k < p->samples; ++k) {
        int at = x * p->samples + k, v;
        if (p->bits == 16) v = row[2 * at] << 8 | row[2 * at + 1];
        else if (p->bits == 8) v = row[at];
        else v = row[at * p->bits / 8] >> (8 - p->bits - at * p->bits % 8) & ((1 << p->bits) - 1);
        if (p->color == 3) {
            int c;
            if (v >= p->colors) return 0;
            for (c = 0; c < 4; ++c) value[c] = (float)p->palette[v][c] / 255;
        } else {
            value[p->samples == 2 && k ? 3 : k] = (float)v / most;
        }
    }
    if (p->samples <= 2 && p->color != 3) value[1] = value[2] = value[0];
    for (k = 0; k < channels; ++k) out[k] = value[k];
    return 1;
}

static inline const char *image__png_pixels(const image__png *p, const image__bytes *packed, image *im)
{
    static const int x0[8] = {0, 4, 0, 2, 0, 1, 0, 0}, y0[8] = {0, 0, 4, 0, 2, 0, 1, 0},
                     dx[8] = {8, 8, 4, 4, 2, 2, 1, 1}, dy[8] = {8, 8, 8, 4, 4, 2, 2, 1};
    int first = p->interlaced ? 0 : 7, end = p->interlaced ? 7 : 8, pass, x, y, depth = p->bits * p->samples;
    size_t total = 0, at = 0;
    unsigned char *rows;
    const char *problem = NULL;
    for (pass = first; pass < end; ++pass) {
        size_t w = (size_t)((p->width - x0[pass] + dx[pass] - 1) / dx[pass]),
               h = (size_t)((p->height - y0[pass] + dy[pass] - 1) / dy[pass]);
        if (w && h) total += h * ((w * (size_t)depth + 7) / 8 + 1);
    }
    rows = (unsigned char *)malloc(total);
    if (rows == NULL) return "out of memory";
    if (!image__unzip(packed->data, packed->size, rows, total)) problem = "the PNG's pixels are damaged";
    for (pass = first; pass < end && !problem; ++pass) {
        int w = (p->width - x0[pass] + dx[pass] - 1) / dx[pass], h = (p->height - y0[pass] + dy[pass] - 1) / dy[pass],
            n = (w * depth + 7) / 8;
        if (w < 1 || h < 1) continue;
        if (!image__unfilter(rows + at, n, h, depth < 8 ? 1 : depth / 8)) problem = "the PNG has an unknown filter";
        for (y = 0; y < h && !problem; ++y, at += (size_t)n + 1)
            for (x = 0; x < w; ++x) {
                size_t pixel = (size_t)(y0[pass] + y * dy[pass]) * (size_t)p->width + (size_t)(x0[pass] + x * dx[pass]);
                if (!image__png_pixel(p, rows + at + 1, x, im->channels, im->pixels + pixel * (size_t)im->channels))
                    problem = "a pixel is outside the PNG's palette";
            }
    }
    free(rows);
    return problem;
}

static inline const char *image__decode_png(const unsigned char *data, size_t size, image *out)
{
    static const int samples[7] = {1, 0, 3, 1, 2, 0, 4};
    image__png p;
    image__bytes packed;
    const char *problem = NULL;
    size_t at = 8, i;
    int ended = 0, k;
    memset(&p, 0, sizeof p);
    memset(&packed, 0, sizeof packed);
    while (!problem && !ended) {
        size_t length = size - at >= 12 ? image__u32(data + at) : size;
        const unsigned char *body = data + at + 8;
        if (size - at < 12 || length > size - at - 12) {
            problem = "the PNG ends before its last chunk";
            break;
        }
        if (image__crc(body - 4, length + 4) != image__u32(body + length)) problem = "a chunk of the PNG is damaged";
        else if ((p.width == 0) != (memcmp(body - 4, "IHDR", 4) == 0)) problem = "a PNG begins with one header";
        else if (p.width == 0) {
            if (length != 13 || image__u32(body) - 1 >= 1u << 24 || image__u32(body + 4) - 1 >= 1u << 24)
                problem = "the PNG's width and height must be from 1 to 2^24";
            else {
                p.width = (int)image__u32(body);
                p.height = (int)image__u32(body + 4);
                p.bits = body[8];
                p.color = body[9];
                p.interlaced = body[12];
                p.samples = p.color < 7 ? samples[p.color] : 0;
                k = p.bits == 8 || (p.bits == 16 && p.color != 3) ||
                    ((p.bits == 1 || p.bits == 2 || p.bits == 4) && (p.color == 0 || p.color == 3));
                if (!k || p.samples == 0 || body[10] || body[11] || p.interlaced > 1)
                    problem = "the PNG's header has values that the format does not know";
                else if (p.width > (1 << 27) / p.height) problem = "the picture is too large";
            }
        } else if (memcmp(body - 4, "PLTE", 4) == 0) {
            if (length % 3 || length > 768) problem = "the PNG's palette is malformed";
            for (i = 0; !problem && i < length; ++i) p.palette[i / 3][i % 3] = body[i];
            p.colors = (int)(length / 3);
            for (k = 0; k < p.colors; ++k) p.palette[k][3] = 255;
        } else if (memcmp(body - 4, "tRNS", 4) == 0 && p.color == 3) {
            for (i = 0; i < length && i < 256; ++i) p.palette[i][3] = body[i];
            p.has_alpha = 1;
        } else if (memcmp(body - 4, "IDAT", 4) == 0) {
            image__put(&packed, body, length);
        } else if (memcmp(body - 4, "IEND", 4) == 0) {
            ended = 1;
        } else if (!(body[-4] & 32)) {
            problem = "the PNG has a critical chunk that is not known";
        }
        at += length + 12;
    }
    if (!problem && at != size) problem = "the file goes on behind the PNG's end";
    if (!problem && packed.failed) problem = "out of memory";
    if (!problem) {
        image im = image_new(p.width, p.height, p.color == 4 || p.color == 6 || p.has_alpha ? 4 : p.color == 0 ? 1 : 3);
        problem = im.pixels == NULL ? "out of memory" : image__png_pixels(&p, &packed, &im);
        if (problem) image_free(&im);
        else *out = im;
    }
    free(packed.data);
    return problem;
}

/* --- PFM, PPM, PGM --- */

static inline int image__space(int c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/* The next word of a header into word[32] (empty where there is none or it is too long); comments count as space
   where the format has them. The one white-space character behind the word is consumed. */
static inline void image__word(const unsigned char *data, size_t size, size_t *at, int comments, char *word)
{
    size_t n = 0;
    while (*at < size && (image__space(data[*at]) || (comments && data[*at] == '#'))) {
        if (data[*at] == '#')
            while (*at < size && data[*at] != '\n') ++*at;
        else ++*at;
    }
    while (*at < size && !image__space(data[*at]) && n < 31) word[n++] = (char)data[(*at)++];
    if (*at >= size || !image__space(data[*at])) n = 0;
    else ++*at;
    word[n] = 0;
}

/* A decimal integer in [1, limit], or 0. */
static inline int image__integer(const char *word, int limit)
{
    int v = 0;
    if (*word == 0) return 0;
    for (; *word; ++word) {
        if (*word < '0' || *word > '9' || v > (limit - (*word - '0')) / 10) return 0;
        v = 10 * v + (*word - '0');
    }
    return v;
}

/* A decimal number like -1.0 or 1e-3, whatever the locale; 0 where it is malformed. */
static inline double image__number(const char *word)
{
    double v = 0, scale = 1;
    int sign = 1, digits = 0, exponent = 0, e_sign = 1;
    if (*word == '-' || *word == '+') sign = *word++ == '-' ? -1 : 1;
    for (; *word >= '0' && *word <= '9'; ++word, ++digits) v = 10 * v + (*word - '0');
    if (*word == '.')
        for (++word; *word >= '0' && *word <= '9'; ++word, ++digits) v += (scale /= 10) * (*word - '0');
    if (digits && (*word == 'e' || *word == 'E')) {
        ++word;
        if (*word == '-' || *word == '+') e_sign = *word++ == '-' ? -1 : 1;
        for (digits = 0; *word >= '0' && *word <= '9' && exponent < 100; ++word, ++digits)
            exponent = 10 * exponent + (*word - '0');
    }
    return digits && *word == 0 ? sign * v * pow(10.0, e_sign * exponent) : 0;
}

/* The sentence for a format that is known and not read; NULL. */
static inline const char *image__foreign(const unsigned char *data, size_t size)
{
    static const struct {
        const char *start;
        size_t length;
        const char *sentence;
    } known[] = {{"\xff\xd8\xff", 3, "a JPEG file: convert it to PNG first"},
                 {"RIFF", 4, "a WebP file: convert it to PNG first"},
                 {"II*\0", 4, "a TIFF file: convert it to PNG first (to PFM if it holds linear floats)"},
                 {"MM\0*", 4, "a TIFF file: convert it to PNG first (to PFM if it holds linear floats)"},
                 {"BM", 2, "a BMP file: convert it to PNG first"},
                 {"GIF8", 4, "a GIF file: convert it to PNG first"},
                 {"\x76\x2f\x31\x01", 4, "an OpenEXR file: convert it to PFM first, which also holds linear floats"}};
    size_t i;
    for (i = 0; i < sizeof known / sizeof known[0]; ++i)
        if (size >= known[i].length && memcmp(data, known[i].start, known[i].length) == 0) return known[i].sentence;
    return NULL;
}

/* A PFM, PPM, PGM or PNG file in memory. PFM values are multiplied by the header's scale. */
IMAGE_DEF const char *image_decode(const unsigned char *data, size_t size, image *out)
{
    char word[32];
    size_t at = 2, i, n, bytes;
    int pfm, channels, width, height, maximum = 0;
    double scale = 0;
    image im;
    memset(out, 0, sizeof *out);
    if (size >= 8 && memcmp(data, "\x89PNG\r\n\x1a\n", 8) == 0) return image__decode_png(data, size, out);
    if (image__foreign(data, size)) return image__foreign(data, size);
    if (size < 3 || data[0] != 'P' || !image__space(data[2])) return "not a PFM, PPM, PGM or PNG file";
    pfm = data[1] == 'F' || data[1] == 'f';
    if (!pfm && data[1] != '5' && data[1] != '6') return "not a PFM, binary PPM (P6) or binary PGM (P5) file";
    channels = data[1] == 'F' || data[1] == '6' ? 3 : 1;
    image__word(data, size, &at, !pfm, word);
    width = image__integer(word, 1 << 24);
    image__word(data, size, &at, !pfm, word);
    height = image__integer(word, 1 << 24);
    if (width == 0 || height == 0) return "malformed header: expected a width and a height from 1 to 2^24";
    image__word(data, size, &at, !pfm, word);
    if (pfm) {
        scale = image__number(word);
        if (!(scale != 0) || !(fabs(scale) < 1e30)) return "malformed header: expected a scale that is not 0";
    } else {
        maximum = image__integer(word, 65535);
        if (maximum == 0) return "malformed header: expected a largest value from 1 to 65535";
    }
    if (width > (1 << 30) / channels / height) return "the picture is too large";
    bytes = pfm ? 4 : maximum > 255 ? 2 : 1;
    n = (size_t)width * (size_t)height * (size_t)channels;
    if (size - at < n * bytes) return "the file ends before the last pixel";
    if (size - at > n * bytes) return "the file goes on behind the last pixel";
    im = image_new(width, height, channels);
    if (im.pixels == NULL) return "out of memory";
    data += at;
    for (i = 0; i < n; ++i) {
        if (pfm) {
            size_t row = (size_t)width * (size_t)channels, y = i / row; /* PFM stores the bottom row first */
            const unsigned char *p = data + 4 * i;
            uint32_t bits = scale < 0 ? p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24
                                      : p[3] | (uint32_t)p[2] << 8 | (uint32_t)p[1] << 16 | (uint32_t)p[0] << 24;
            float v;
            memcpy(&v, &bits, 4);
            im.pixels[((size_t)height - 1 - y) * row + i % row] = fabs(scale) == 1 ? v : v * (float)fabs(scale);
        } else {
            int v = bytes == 2 ? data[2 * i] << 8 | data[2 * i + 1] : data[i];
            if (v > maximum) {
                image_free(&im);
                return "a pixel is above the header's largest value";
            }
            im.pixels[i] = (float)v / (float)maximum;
        }
    }
    *out = im;
    return NULL;
}

IMAGE_DEF const char *image_read(const char *path, image *out)
{
    image__bytes b;
    const char *problem;
    memset(&b, 0, sizeof b);
    memset(out, 0, sizeof *out);
    problem = image__load(path, &b);
    if (problem == NULL) problem = image_decode(b.data, b.size, out);
    free(b.data);
    return problem;
}

/* Little-endian, scale -1. */
static inline const char *image__write_pfm(const char *path, const image *im)
{
    image__bytes b;
    char header[64];
    const char *problem;
    size_t row = (size_t)im->width * (size_t)im->channels, i;
    int y;
    if (im->channels != 1 && im->channels != 3) return "a PFM file has 1 or 3 channels";
    memset(&b, 0, sizeof b);
    snprintf(header, sizeof header, "P%c\n%d %d\n-1.0\n", im->channels == 3 ? 'F' : 'f', im->width, im->height);
    image__put(&b, header, strlen(header));
    for (y = im->height - 1; y >= 0; --y)
        for (i = 0; i < row; ++i) {
            uint32_t bits;
            unsigned char text[4];
            memcpy(&bits, &im->pixels[(size_t)y * row + i], 4);
            text[0] = (unsigned char)bits;
            text[1] = (unsigned char)(bits >> 8);
            text[2] = (unsigned char)(bits >> 16);
            text[3] = (unsigned char)(bits >> 24);
            image__put(&b, text, 4);
        }
    problem = image__save(path, &b);
    free(b.data);
    return problem;
}

IMAGE_DEF const char *image_write(const char *path, const image *im)
{
    unsigned char *bytes;
    const char *problem;
    size_t i, n = image_count(im);
    int png = image__has_extension(path, ".png"), ppm = image__has_extension(path, ".ppm");
    if (im->pixels == NULL || n == 0) return "the picture is empty";
    if (image__has_extension(path, ".pfm")) return image__write_pfm(path, im);
    if (!png && !ppm && !image__has_extension(path, ".pgm")) return "the name should end in .png, .pfm, .ppm or .pgm";
    if (!png && im->channels != (ppm ? 3 : 1)) return ppm ? "a PPM file has 3 channels" : "a PGM file has 1 channel";
    bytes = (unsigned char *)malloc(n);
    if (bytes == NULL) return "out of memory";
    for (i = 0; i < n; ++i) bytes[i] = image_to_byte(im->pixels[i]);
    if (png) {
        problem = image_write_png8(path, bytes, im->width, im->height, im->channels);
    } else {
        image__bytes b;
        char header[64];
        memset(&b, 0, sizeof b);
        snprintf(header, sizeof header, "P%c\n%d %d\n255\n", ppm ? '6' : '5', im->width, im->height);
        image__put(&b, header, strlen(header));
        image__put(&b, bytes, n);
        problem = image__save(path, &b);
        free(b.data);
    }
    free(bytes);
    return problem;
}
#endif /* IMAGE_IMPLEMENTED */

#endif
