/* Runs an MCML 1.2 input file: build/mcml [-n PHOTONS] [-s SEED] FILE.mci
   Every run of the file writes its .mco file, in the current folder unless its name says otherwise.
     build/mcml --exact FILE.mci
   the same without photons and without noise, for up to four layers of isotropic scattering (layered.h says which):
   totals, A_l, A_z, Rd_r, Tt_r; nan stands for A_rz and for angles in more than one bin, which it does not compute. A
   run of other layers is named with the reason and writes nothing (a file of that name stays as it was), the others are
   written; the exit code is 1 then.
     build/mcml --run FILE.mci PART OF OUT.tally     the PART-th (from 1) of OF shares of the first run's photons
     build/mcml --merge FILE.mci TALLY...            adds the shares, in any order, and writes the run's .mco file
   One simulation over many processes or machines, with the same bits as one process:
     for i in 1 2 3 4; do build/mcml --run skin.mci $i 4 $i.tally & done; wait
     build/mcml --merge skin.mci *.tally
   Alone: cc -O2 -I. examples/tools/mcml.c -o build/mcml -lm */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "mci.h"
#include "tally.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#if defined(_WIN32)
#include <io.h>
#define isatty _isatty
#else
#include <unistd.h>
#endif

typedef struct state {
    const char *output;
    int run, runs;
    time_t start;
    clock_t drawn;
} state;

/* One line that is written over, on a terminal only: at most five times a second of processor time. */
static int show_progress(void *user, double fraction)
{
    state *s = (state *)user;
    clock_t now = clock();
    if (fraction > 0 && now - s->drawn > CLOCKS_PER_SEC / 5) {
        double left = difftime(time(NULL), s->start) * (1 - fraction) / fraction;
        fprintf(stderr, "\rrun %d of %d, %s: %3.0f%%, %.0f s left   ", s->run, s->runs, s->output, 100 * fraction,
                left);
        s->drawn = now;
    }
    return 0;
}

static int fail(const char *path, const char *message)
{
    fprintf(stderr, "%s: %s\n", path, message);
    return 1;
}

static tally_run tally_of(const mci_run *run)
{
    tally_run whole;
    whole.tissue = &run->tissue;
    whole.grid = &run->grid;
    whole.seed = 0;
    return whole;
}

static int run_share(const mci_run *run, unsigned long long part, unsigned long long of, const char *path)
{
    unsigned long long first = run->photons / of * (part - 1) + run->photons % of * (part - 1) / of;
    unsigned long long end = run->photons / of * part + run->photons % of * part / of;
    ms_mcml *tally;
    ms_error error;
    ms_status status = ms_mcml_create(&run->tissue, &run->grid, NULL, &tally, &error);
    if (status == MS_OK) status = ms_mcml_run(tally, first, end - first, &error);
    if (status == MS_OK) {
        size_t size;
        const tally_run whole = tally_of(run);
        unsigned char *bytes = tally_pack(tally, &whole, first, &size);
        const char *problem = bytes ? file_save(path, bytes, size) : "out of memory";
        free(bytes);
        ms_mcml_destroy(tally);
        return problem ? fail(path, problem) : 0;
    }
    ms_mcml_destroy(tally);
    return fail(run->output, error.message);
}

/* The photons of a share. */
typedef struct span {
    uint64_t first, end;
} span;

/* The share in a file joins the tally; 1, after a message, if it cannot. */
static int add_share(ms_mcml *tally, const mci_run *run, const char *path, span *photons)
{
    const uint64_t before = ms_mcml_photons(tally);
    const tally_run whole = tally_of(run);
    const char *problem = "cannot be read";
    FILE *file = file_open(path, &problem);
    char *bytes = NULL;
    long size = -1;
    ms_error error;
    if (file && fseek(file, 0, SEEK_END) == 0) size = ftell(file);
    if (size >= 0 && fseek(file, 0, SEEK_SET) == 0) bytes = (char *)malloc((size_t)size + 1);
    if (bytes && fread(bytes, 1, (size_t)size, file) == (size_t)size)
        problem = tally_add(tally, &whole, bytes, (size_t)size, &photons->first, &error) ? error.message : NULL;
    photons->end = photons->first + (ms_mcml_photons(tally) - before);
    if (problem) fail(path, problem);
    if (file) fclose(file);
    free(bytes);
    return problem != NULL;
}

static int merge_shares(const mci_run *run, char **paths, int count)
{
    ms_mcml *sum;
    ms_mcml_result result;
    ms_error error;
    span *photons = (span *)calloc((size_t)count, sizeof *photons);
    int i, k;
    if (photons == NULL) return fail(run->output, "out of memory");
    if (ms_mcml_create(&run->tissue, &run->grid, NULL, &sum, &error) != MS_OK) {
        free(photons);
        return fail(run->output, error.message);
    }
    for (i = 0; i < count; ++i) {
        if (add_share(sum, run, paths[i], &photons[i])) break;
        for (k = 0; k < i; ++k)
            if (photons[i].first < photons[k].end && photons[k].first < photons[i].end) break;
        if (k < i) fprintf(stderr, "%s: has photons that %s has, too\n", paths[i], paths[k]);
        if (k < i) break;
    }
    free(photons);
    if (i == count && ms_mcml_photons(sum) != run->photons) {
        fail(run->output, "the shares do not add up to the photons of the run");
        i = -1;
    }
    if (i == count) {
        ms_status status = ms_mcml_results(sum, &result, &error);
        if (status == MS_OK) {
            status = mco_save(run->output, run, &result, NULL, 0, &error);
            ms_mcml_result_destroy(&result);
        }
        if (status != MS_OK) i = -fail(run->output, error.message);
    }
    ms_mcml_destroy(sum);
    return i != count;
}

static const char usage[] =
    "usage: mcml [-n PHOTONS] [-s SEED] FILE.mci\n"
    "  mcml --exact FILE.mci    isotropic layers without noise; nan stands for what is not computed (A_rz, angles)\n"
    "  mcml --run FILE.mci PART OF OUT.tally    one share of the first run's photons\n"
    "  mcml --merge FILE.mci TALLY...    adds the shares and writes the .mco file\n";

/* Whether text is digits and nothing else, of a number below 2^64. */
static int whole_number(const char *text, unsigned long long *value)
{
    errno = 0;
    *value = strtoull(text, NULL, 10);
    return text[0] != 0 && text[strspn(text, "0123456789")] == 0 && errno == 0;
}

/* --run FILE.mci PART OF OUT.tally, --merge FILE.mci TALLY... */
static int split(int argc, char **argv)
{
    const int running = strcmp(argv[1], "--run") == 0;
    unsigned long long part = 1, of = 1;
    mci_file file;
    ms_error error;
    int failed;
    if (running ? argc != 6 : argc < 4) return file_usage(usage);
    if (running && (!whole_number(argv[3], &part) || !whole_number(argv[4], &of))) return file_usage(usage);
    if (part < 1 || part > of || of > 1000000) return file_usage(usage);
    if (mci_load(argv[2], &file, &error) != MS_OK) return fail(argv[2], error.message);
    failed = running ? run_share(&file.runs[0], part, of, argv[5]) : merge_shares(&file.runs[0], argv + 3, argc - 3);
    mci_destroy(&file);
    return failed;
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    unsigned long long photons = 0, seed = 0;
    int terminal = isatty(2), exact = 0, failed = 0, i;
    mci_file file;
    ms_error error;

    if (file_help(argc, argv, usage)) return file_end_stdout("mcml");
    if (argc > 1 && (strcmp(argv[1], "--run") == 0 || strcmp(argv[1], "--merge") == 0)) return split(argc, argv);
    for (i = 1; i < argc; ++i) {
        if ((strcmp(argv[i], "-n") == 0 || strcmp(argv[i], "-s") == 0) && i + 1 < argc) {
            unsigned long long value;
            if (!whole_number(argv[i + 1], &value) || (argv[i][1] == 'n' && value == 0)) return file_usage(usage);
            if (argv[i++][1] == 'n') photons = value;
            else seed = value;
        } else if (strcmp(argv[i], "--exact") == 0) {
            exact = 1;
        } else if (argv[i][0] != '-' && path == NULL) {
            path = argv[i];
        } else {
            return file_usage(usage);
        }
    }
    if (path == NULL || (exact && (photons || seed))) return file_usage(usage);
    if (mci_load(path, &file, &error) != MS_OK) {
        fprintf(stderr, "%s: %s\n", path, error.message);
        return 1;
    }

    for (i = 0; i < file.run_count; ++i) {
        const mci_run *run = &file.runs[i];
        ms_mcml_options options = ms_mcml_defaults();
        ms_mcml_result result;
        ms_status status;
        clock_t begun = clock();
        state s;
        s.output = run->output;
        s.run = i + 1;
        s.runs = file.run_count;
        s.start = time(NULL);
        s.drawn = begun;
        options.photons = photons ? photons : run->photons;
        options.seed = seed;
        options.progress.user = &s;
        options.progress.report = terminal ? show_progress : NULL;
        memset(&result, 0, sizeof result);
        if (exact) status = mci_layered(&run->tissue, &run->grid, &options.progress, &result, &error);
        else status = ms_mcml_simulate(&run->tissue, &run->grid, &options, &result, &error);
        if (terminal) fprintf(stderr, "\r%78s\r", "");
        if (status == MS_OK) {
            const char *note = exact ? "Layered solver, no photons: nan is what it does not compute (A_rz, angles)."
                                     : NULL;
            status = mco_save(run->output, run, &result, note, (double)(clock() - begun) / CLOCKS_PER_SEC, &error);
        }
        ms_mcml_result_destroy(&result);
        if (status != MS_OK) {
            fprintf(stderr, "%s: run %d, %s: %s\n", path, i + 1, run->output, error.message);
            failed = 1;
            if (!exact) break;
        }
    }
    mci_destroy(&file);
    return failed;
}
