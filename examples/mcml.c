/* Runs an MCML 1.2 input file: build/mcml [-n PHOTONS] [-s SEED] FILE.mci
   Every run of the file writes its .mco file, in the current folder unless its name says otherwise.
   Alone: cc -O2 -I. examples/mcml.c -o build/mcml -lm */
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
        fprintf(stderr, "\rrun %d of %d, %s: %3.0f%%, %.0f s left   ", s->run, s->runs, s->output, 100 * fraction, left);
        s->drawn = now;
    }
    return 0;
}

static int fail(const char *path, const ms_error *error)
{
    fprintf(stderr, "%s: %s\n", path, error->message);
    return 1;
}

static const char usage[] = "usage: mcml [-n PHOTONS] [-s SEED] FILE.mci\n";

int main(int argc, char **argv)
{
    const char *path = NULL;
    unsigned long long photons = 0, seed = 0;
    int terminal = isatty(2), i;
    ms_mcml_mci file;
    ms_error error;

    if (file_help(argc, argv, usage)) return file_end_stdout("mcml");
    for (i = 1; i < argc; ++i) {
        if ((strcmp(argv[i], "-n") == 0 || strcmp(argv[i], "-s") == 0) && i + 1 < argc) {
            char *end;
            unsigned long long value = strtoull(argv[i + 1], &end, 10);
            if (*end || argv[i + 1][0] < '0' || argv[i + 1][0] > '9' || (argv[i][1] == 'n' && value == 0)) return file_usage(usage);
            if (argv[i++][1] == 'n') photons = value;
            else seed = value;
        } else if (argv[i][0] != '-' && path == NULL) {
            path = argv[i];
        } else {
            return file_usage(usage);
        }
    }
    if (path == NULL) return file_usage(usage);
    if (ms_mcml_mci_load(path, NULL, &file, &error) != MS_OK) return fail(path, &error);

    for (i = 0; i < file.run_count; ++i) {
        const ms_mcml_run_spec *run = &file.runs[i];
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
        status = ms_mcml_simulate(&run->tissue, &run->grid, &options, &result, &error);
        if (terminal) fprintf(stderr, "\r%78s\r", "");
        if (status == MS_OK) {
            status = ms_mcml_mco_save(run->output, run, &result, (double)(clock() - begun) / CLOCKS_PER_SEC, &error);
            ms_mcml_result_destroy(&result);
        }
        if (status != MS_OK) {
            fail(path, &error);
            break;
        }
    }
    i = i < file.run_count;
    ms_mcml_mci_destroy(&file);
    return i;
}
