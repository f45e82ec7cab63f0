/* Runs a fuzz target over the files of a folder (and over truncations of each) without libFuzzer, so that every
   compiler replays the corpus: fuzz_X FOLDER. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C"
#endif
    int
    LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int main(int argc, char **argv)
{
    DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
    struct dirent *entry;
    int files = 0, runs = 0;
    if (folder == NULL) {
        fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    while ((entry = readdir(folder)) != NULL) {
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
            /* a block of its own size, so that a sanitizer sees one byte too far */
            uint8_t *part = (uint8_t *)malloc(cut > 0 ? (size_t)cut : 1);
            long i;
            if (part == NULL) return 2;
            for (i = 0; i < cut; ++i) part[i] = data[i];
            LLVMFuzzerTestOneInput(part, (size_t)cut);
            free(part);
            ++runs;
        }
        LLVMFuzzerTestOneInput(data, (size_t)size);
        ++runs;
        free(data);
        ++files;
    }
    closedir(folder);
    printf("%d files, %d inputs\n%d passed, %d failed\n", files, runs, files > 0, files == 0);
    return files == 0;
}
