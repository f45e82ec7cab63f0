/* Pictures for the examples: reads PFM, PPM and PGM, writes those and PNG. No dependency; C99 and C++11.

     image im;
     const char *problem = image_read("in.pfm", &im);      NULL: fine; otherwise a sentence (static text)
     image_to_srgb(&im);
     if (!problem) problem = image_write("out.png", &im);  by extension: .pfm .ppm .pgm .png
     image_free(&im);

   PFM keeps the floats as they are, in linear light. The other formats hold 8 bits a channel (PPM and PGM are read
   with 16 as well): floats in [0, 1] that the caller encodes (image_to_srgb) before writing and decodes
   (image_to_linear) after reading. Files are read strictly: what is malformed, cut short or too long is refused.
   On failure no image is made and no file is left behind. */
#ifndef EXAMPLES_IMAGE_H
#define EXAMPLES_IMAGE_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* --- a growing array of bytes; after a failed allocation it takes no more and says so in `failed` --- */

typedef struct image__bytes {
    unsigned char *data;
    size_t size, room;
    int failed;
    uint32_t bits; /* not yet written, lowest first */
    int bit_count;
} image__bytes;

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
    FILE *f;
    int ok;
    if (b->failed) return "out of memory";
    f = fopen(path, "wb");
    if (f == NULL) return "cannot open the file for writing";
    ok = fwrite(b->data, 1, b->size, f) == b->size;
    ok &= fclose(f) == 0;
    if (ok) return NULL;
    remove(path);
    return "cannot write the whole file";
}

static inline const char *image__load(const char *path, image__bytes *b)
{
    unsigned char block[8192];
    size_t got;
    int bad;
    FILE *f = fopen(path, "rb");
    if (f == NULL) return "cannot open the file";
    while ((got = fread(block, 1, sizeof block, f)) > 0) image__put(b, block, got);
    bad = ferror(f);
    fclose(f);
    return bad ? "cannot read the file" : b->failed ? "out of memory" : NULL;
}

/* --- DEFLATE (RFC 1951): LZ77 with hash chains and lazy matching, blocks with their own Huffman codes --- */

enum { image__literals = 286, image__distances = 30, image__tokens = 32768, image__window = 32768, image__chain = 48 };

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

/* Longest earlier match of the bytes at `at`, of at most 258, or 0; *distance in [1, 32768]. */
static inline int image__match(const image__deflate *d, const unsigned char *data, size_t size, size_t at,
                               uint32_t hash, int *distance)
{
    int most = size - at < 258 ? (int)(size - at) : 258, best = 2, tries = image__chain;
    uint32_t from = d->head[hash];
    while (from != 0 && at - (from - 1) <= image__window && tries-- > 0) {
        const unsigned char *a = data + at, *b = data + from - 1;
        int n = 0;
        if (b[best] == a[best]) {
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
    return best > 2 ? best : 0;
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
            if (held < 64) match = image__match(d, data, size, at, hash, &distance);
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
    for (at = 0; at < size; ++at) { /* Adler-32 */
        a = (a + data[at]) % 65521;
        b = (b + a) % 65521;
    }
    image__put_u32(out, b << 16 | a);
    free(d);
}

/* --- PNG --- */

static inline void image__chunk(image__bytes *out, const char *name, const unsigned char *data, size_t size)
{
    uint32_t crc = 0xffffffffu;
    size_t i, start;
    int k;
    image__put_u32(out, (uint32_t)size);
    start = out->size;
    image__put(out, name, 4);
    if (size) image__put(out, data, size);
    if (out->failed) return;
    for (i = start; i < out->size; ++i) {
        crc ^= out->data[i];
        for (k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    image__put_u32(out, ~crc);
}

/* One row through filter 0 to 4 (PNG specification, section 9) into to[n]; `above` is NULL for the first row.
   Returns the sum of absolute differences, which the writer keeps low. */
static inline long image__filter_row(int filter, const unsigned char *row, const unsigned char *above, int n, int step,
                                     unsigned char *to)
{
    long sum = 0;
    int i;
    for (i = 0; i < n; ++i) {
        int left = i >= step ? row[i - step] : 0, up = above ? above[i] : 0,
            corner = above && i >= step ? above[i - step] : 0;
        int pa = abs(up - corner), pb = abs(left - corner), pc = abs(left + up - 2 * corner), guess = 0;
        if (filter == 1) guess = left;
        if (filter == 2) guess = up;
        if (filter == 3) guess = (left + up) / 2;
        if (filter == 4) guess = pa <= pb && pa <= pc ? left : pb <= pc ? up : corner;
        to[i] = (unsigned char)(row[i] - guess);
        sum += to[i] < 128 ? to[i] : 256 - to[i];
    }
    return sum;
}

/* pixels [height][width][channels], top row first; 1 gray, 3 RGB or 4 RGBA. */
static inline const char *image_write_png8(const char *path, const unsigned char *pixels, int width, int height,
                                           int channels)
{
    static const unsigned char color_type[5] = {0, 0, 0, 2, 6};
    image__bytes out, packed;
    unsigned char *rows, header[13];
    const char *problem;
    int n, y, filter;
    size_t stride;
    if (width < 1 || height < 1 || (channels != 1 && channels != 3 && channels != 4))
        return "a PNG has 1, 3 or 4 channels";
    if (width > (1 << 30) / channels / height) return "the picture is too large";
    n = width * channels;
    stride = (size_t)n + 1;
    rows = (unsigned char *)malloc(stride * ((size_t)height + 1));
    if (rows == NULL) return "out of memory";
    for (y = 0; y < height; ++y) {
        const unsigned char *row = pixels + (size_t)y * (size_t)n, *above = y ? row - n : NULL;
        unsigned char *to = rows + (size_t)y * stride, *trial = rows + (size_t)height * stride;
        long best = -1;
        for (filter = 0; filter < 5; ++filter) {
            long sum = image__filter_row(filter, row, above, n, channels, trial);
            if (best >= 0 && sum >= best) continue;
            best = sum;
            to[0] = (unsigned char)filter;
            memcpy(to + 1, trial, (size_t)n);
        }
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
        else
            ++*at;
    }
    while (*at < size && !image__space(data[*at]) && n < 31) word[n++] = (char)data[(*at)++];
    if (*at >= size || !image__space(data[*at]))
        n = 0;
    else
        ++*at;
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

/* A PFM, PPM or PGM file in memory. PFM values are multiplied by the header's scale. */
static inline const char *image_decode(const unsigned char *data, size_t size, image *out)
{
    char word[32];
    size_t at = 2, i, n, bytes;
    int pfm, channels, width, height, maximum = 0;
    double scale = 0;
    image im;
    memset(out, 0, sizeof *out);
    if (size < 3 || data[0] != 'P' || !image__space(data[2])) return "not a PFM, PPM or PGM file";
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

static inline const char *image_read(const char *path, image *out)
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

/* Nearest of the 256 levels; NaN and negative values become 0, what is above 1 becomes 255. */
static inline unsigned char image_to_byte(float v) { return (unsigned char)(v > 0 ? v < 1 ? v * 255 + 0.5f : 255 : 0); }

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

static inline const char *image_write(const char *path, const image *im)
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
#endif
