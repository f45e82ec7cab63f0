/* One simulation over many processes or machines, with the same bits as one process:
     cc -O2 -I. examples/tools/mcml_split.c -o build/mcml_split -lm
     build/mcml_split run FILE.mci PART OF OUT.tally     the PART-th (from 1) of OF shares of the first run's photons
     build/mcml_split merge FILE.mci TALLY...            adds the shares, in any order, and writes the run's .mco file
   For example, with a shell as the batch system:
     for i in 1 2 3 4; do build/mcml_split run skin.mci $i 4 $i.tally & done; wait
     build/mcml_split merge skin.mci *.tally */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] = "usage: mcml_split run FILE.mci PART OF OUT.tally | mcml_split merge FILE.mci TALLY...\n";

static int fail(const char *path, const char *message)
{
    fprintf(stderr, "%s: %s\n", path, message);
    return 1;
}

static int run_share(const ms_mcml_run_spec *run, unsigned long long part, unsigned long long of, const char *path)
{
    unsigned long long first = run->photons / of * (part - 1) + run->photons % of * (part - 1) / of;
    unsigned long long end = run->photons / of * part + run->photons % of * part / of;
    ms_mcml *tally;
    ms_error error;
    ms_status status = ms_mcml_create(&run->tissue, &run->grid, NULL, &tally, &error);
    if (status == MS_OK) status = ms_mcml_run(tally, first, end - first, &error);
    if (status == MS_OK) {
        size_t size = ms_mcml_save_size(tally);
        void *bytes = malloc(size);
        const char *problem = "out of memory";
        if (bytes) {
            ms_mcml_save(tally, bytes);
            problem = file_save(path, bytes, size);
        }
        free(bytes);
        ms_mcml_destroy(tally);
        return problem ? fail(path, problem) : 0;
    }
    ms_mcml_destroy(tally);
    return fail(run->output, error.message);
}

static ms_mcml *load(const char *path)
{
    const char *problem = "cannot be read";
    FILE *file = file_open(path, &problem);
    char *bytes = NULL;
    long size = -1;
    ms_mcml *tally = NULL;
    ms_error error;
    memset(&error, 0, sizeof error);
    if (file && fseek(file, 0, SEEK_END) == 0) size = ftell(file);
    if (size >= 0 && fseek(file, 0, SEEK_SET) == 0) bytes = (char *)malloc((size_t)size + 1);
    if (bytes && fread(bytes, 1, (size_t)size, file) == (size_t)size)
        ms_mcml_load(bytes, (size_t)size, NULL, &tally, &error);
    if (tally == NULL) fail(path, error.message[0] ? error.message : problem);
    if (file) fclose(file);
    free(bytes);
    return tally;
}

static int merge_shares(const ms_mcml_run_spec *run, char **paths, int count)
{
    ms_mcml *sum;
    ms_mcml_result result;
    ms_error error;
    int i;
    if (ms_mcml_create(&run->tissue, &run->grid, NULL, &sum, &error) != MS_OK) return fail(run->output, error.message);
    for (i = 0; i < count; ++i) {
        ms_mcml *share = load(paths[i]);
        ms_status status = share ? ms_mcml_merge(sum, share, &error) : MS_OK;
        if (status != MS_OK) fail(paths[i], error.message);
        ms_mcml_destroy(share);
        if (share == NULL || status != MS_OK) break;
    }
    if (i == count && ms_mcml_photons(sum) != run->photons) {
        fail(run->output, "the shares do not add up to the photons of the run");
        i = -1;
    }
    if (i == count) {
        ms_status status = ms_mcml_results(sum, &result, &error);
        if (status == MS_OK) {
            status = ms_mcml_mco_save(run->output, run, &result, 0, &error);
            ms_mcml_result_destroy(&result);
        }
        if (status != MS_OK) i = -fail(run->output, error.message);
    }
    ms_mcml_destroy(sum);
    return i != count;
}

int main(int argc, char **argv)
{
    ms_mcml_mci file;
    ms_error error;
    int running = argc == 6 && strcmp(argv[1], "run") == 0, merging = argc > 3 && strcmp(argv[1], "merge") == 0, status;
    unsigned long long part = running ? strtoull(argv[3], NULL, 10) : 1, of = running ? strtoull(argv[4], NULL, 10) : 1;
    if (file_help(argc, argv, usage)) return file_end_stdout("mcml_split");
    if ((!running && !merging) || part < 1 || part > of || of > 1000000) return file_usage(usage);
    if (ms_mcml_mci_load(argv[2], NULL, &file, &error) != MS_OK) return fail(argv[2], error.message);
    status = running ? run_share(&file.runs[0], part, of, argv[5]) : merge_shares(&file.runs[0], argv + 3, argc - 3);
    ms_mcml_mci_destroy(&file);
    return status;
}
