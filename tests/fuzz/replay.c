/* Runs a fuzz target over the files of a folder (and over truncations of each) without libFuzzer, so that every
   compiler replays the corpus: fuzz_X FOLDER [COUNT [SEED]]. COUNT: then so many mutations of the files. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C"
#endif
    int
    LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { FILES_MAX = 1000, GROWTH = 64 };

static uint8_t *file_data[FILES_MAX];
static size_t file_size[FILES_MAX];
static uint64_t state;

/* An integer below n: xorshift64* (Vigna 2016). */
static size_t below(size_t n)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return (size_t)((state * 2685821657736338717u >> 33) % (n ? n : 1));
}

/* Runs the target on a block of its own size, so that a sanitizer sees one byte too far. */
static void run(const uint8_t *data, size_t size)
{
    uint8_t *part = (uint8_t *)malloc(size > 0 ? size : 1);
    if (part == NULL) exit(2);
    if (size > 0) memcpy(part, data, size);
    LLVMFuzzerTestOneInput(part, size);
    free(part);
}

/* Where a run of digits begins at or after a random place; size: nowhere. */
static size_t number_at(const uint8_t *data, size_t size)
{
    size_t at = below(size);
    while (at < size && !(data[at] >= '0' && data[at] <= '9')) ++at;
    return at;
}

/* Changes the length of the text that a file may begin with (8 bytes, the least first) as the text changes at `at`. */
static void length_adjust(uint8_t *data, size_t size, size_t at, long change)
{
    uint64_t length = 0;
    int i;
    for (i = 8; i-- > 0 && size >= 8;) length = length << 8 | data[i];
    if (size < 8 || at < 8 || at > 8 + length || length > size || below(8) == 0) return;
    length += (uint64_t)(int64_t)change;
    for (i = 0; i < 8; ++i) data[i] = (uint8_t)(length >> (8 * i));
}

/* Replaces `old` bytes at `at` by `count` new ones; returns the new size. */
static size_t splice(uint8_t *data, size_t size, size_t at, size_t old, const uint8_t *with, size_t count)
{
    if (at + old > size) old = size - at;
    memmove(data + at + count, data + at + old, size - at - old);
    if (count > 0) memcpy(data + at, with, count);
    length_adjust(data, size - old + count, at, (long)count - (long)old);
    return size - old + count;
}

/* One mutation of a file whose memory has room for GROWTH bytes more. */
static size_t mutate(uint8_t *data, size_t size)
{
    static const char *const sizes[] = {"0",          "1",          "2",     "3",          "255",
                                        "65535",      "65536",      "32767", "2147483647", "4294967295",
                                        "4294967296", "1431655766", "17",    "1e30",       "-1"};
    static const char marks[] = "[]{},:\"\\ 0123456789eE.-";
    const char *text;
    uint8_t byte;
    size_t at, other, count;
    if (size == 0) return 0;
    switch (below(9)) {
    case 0: data[below(size)] ^= (uint8_t)(1u << below(8)); return size;
    case 1: data[below(size)] = (uint8_t)marks[below(sizeof marks - 1)]; return size;
    case 2: /* bytes of another file */
        for (other = below(FILES_MAX); file_data[other] == NULL; other = below(FILES_MAX)) {}
        count = 1 + below(GROWTH / 4);
        if (file_size[other] < count) return size;
        return splice(data, size, below(size), below(2) ? count : 0,
                      file_data[other] + below(file_size[other] - count + 1), count);
    case 3: byte = (uint8_t)marks[below(sizeof marks - 1)]; return splice(data, size, below(size), 0, &byte, 1);
    case 4: return splice(data, size, below(size), 1 + below(8), NULL, 0);
    default: /* another number */
        at = number_at(data, size);
        for (count = 0; at + count < size && data[at + count] >= '0' && data[at + count] <= '9' && count < 20;) ++count;
        text = sizes[below(sizeof sizes / sizeof sizes[0])];
        return at < size ? splice(data, size, at, count, (const uint8_t *)text, strlen(text)) : size;
    }
}

int main(int argc, char **argv)
{
    DIR *folder = argc >= 2 && argc <= 4 ? opendir(argv[1]) : NULL;
    const long count = argc > 2 ? atol(argv[2]) : 0;
    struct dirent *entry;
    int files = 0, runs = 0;
    long k;
    if (folder == NULL) {
        fprintf(stderr, "usage: %s FOLDER [COUNT [SEED]]\n", argv[0]);
        return 2;
    }
    while ((entry = readdir(folder)) != NULL && files < FILES_MAX) {
        char path[1024];
        FILE *f;
        uint8_t *data;
        long size, cut;
        if (entry->d_name[0] == '.') continue;
        snprintf(path, sizeof path, "%s/%s", argv[1], entry->d_name);
        f = fopen(path, "rb");
        if (f == NULL || fseek(f, 0, SEEK_END) != 0 || (size = ftell(f)) < 0 || fseek(f, 0, SEEK_SET) != 0) return 2;
        data = (uint8_t *)malloc(size > 0 ? (size_t)size : 1);
        if (data == NULL || fread(data, 1, (size_t)size, f) != (size_t)size) return 2;
        fclose(f);
        for (cut = 0; cut <= size; cut += 1 + size / 61) {
            run(data, (size_t)cut);
            ++runs;
        }
        LLVMFuzzerTestOneInput(data, (size_t)size);
        ++runs;
        file_data[files] = data;
        file_size[files++] = (size_t)size;
    }
    closedir(folder);
    state = 88172645463325252u + (argc > 3 ? (uint64_t)atol(argv[3]) * 0x9E3779B97F4A7C15u : 0);
    for (k = 0; k < count && files > 0; ++k) {
        const size_t one = below((size_t)files), two = below((size_t)files); /* the larger file holds more to change */
        const size_t which = file_size[one] > file_size[two] ? one : two;
        size_t size = file_size[which], changes = below(2) ? 1 : 1 + below(4);
        uint8_t *data = (uint8_t *)malloc(size + 4 * GROWTH);
        if (data == NULL) return 2;
        if (size > 0) memcpy(data, file_data[which], size);
        while (changes-- > 0) size = mutate(data, size);
        run(data, size);
        free(data);
    }
    while (files > 0) free(file_data[--files]), ++runs;
    printf("%d inputs, %ld mutations\n%d passed, %d failed\n", runs, count, runs > 0, runs == 0);
    return runs == 0;
}
