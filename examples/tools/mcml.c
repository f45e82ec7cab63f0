/* Runs an MCML 1.2 input file: build/mcml [-n PHOTONS] [-s SEED] FILE.mci
   Every run of the file writes its .mco file, in the current folder unless its name says otherwise.
     build/mcml --exact FILE.mci
   the same without photons and without noise, by the layered solver: totals, A_l, A_z, Rd_r, Tt_r; nan stands for A_rz
   and for angles in more than one bin, which it does not compute. Rings that the solver does not hold (beside a clear
   layer, g above 0.97 or so) have the shape that the file's number of photons gives; the program says so. A run that it
   cannot answer for is named with the reason and writes nothing (a file of that name stays as it was), the others are
   written; the exit code is 1 then. Alone: cc -O2 -I. examples/tools/mcml.c -o build/mcml -lm */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "files.h"

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

static const char usage[] =
    "usage: mcml [-n PHOTONS] [-s SEED] FILE.mci\n"
    "  mcml --exact FILE.mci    layers without noise; nan stands for what is not computed (A_rz, angles)\n";

int main(int argc, char **argv)
{
    const char *path = NULL;
    unsigned long long photons = 0, seed = 0;
    int terminal = isatty(2), exact = 0, failed = 0, i;
    ms_mcml_mci file;
    ms_error error;

    if (file_help(argc, argv, usage)) return file_end_stdout("mcml");
    for (i = 1; i < argc; ++i) {
        if ((strcmp(argv[i], "-n") == 0 || strcmp(argv[i], "-s") == 0) && i + 1 < argc) {
            char *end;
            unsigned long long value = strtoull(argv[i + 1], &end, 10);
            if (*end || argv[i + 1][0] < '0' || argv[i + 1][0] > '9' || (argv[i][1] == 'n' && value == 0))
                return file_usage(usage);
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
    if (ms_mcml_mci_load(path, NULL, &file, &error) != MS_OK) {
        fprintf(stderr, "%s: %s\n", path, error.message);
        return 1;
    }

    for (i = 0; i < file.run_count; ++i) {
        const ms_mcml_run_spec *run = &file.runs[i];
        ms_mcml_options options = ms_mcml_defaults();
        ms_mcml_layered_options layered;
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
        memset(&layered, 0, sizeof layered);
        memset(&result, 0, sizeof result);
        layered.progress = options.progress;
        layered.photons = options.photons;
        if (exact) status = ms_mcml_layered_result(&run->tissue, &run->grid, &layered, &result, &error);
        else status = ms_mcml_simulate(&run->tissue, &run->grid, &options, &result, &error);
        if (terminal) fprintf(stderr, "\r%78s\r", "");
        if (status == MS_OK)
            status = ms_mcml_mco_save(run->output, run, &result, (double)(clock() - begun) / CLOCKS_PER_SEC, &error);
        if (status == MS_OK && exact && result.photons)
            fprintf(stderr, "%s: run %d, %s: the solver gave the totals, %.0f photons the shape of the rings\n", path,
                    i + 1, run->output, (double)result.photons);
        ms_mcml_result_destroy(&result);
        if (status != MS_OK) {
            fprintf(stderr, "%s: run %d, %s: %s\n", path, i + 1, run->output, error.message);
            failed = 1;
            if (!exact) break;
        }
    }
    ms_mcml_mci_destroy(&file);
    return failed;
}
