/* MCML's text formats for ms_mcml.h: .mci input files, .mco output files (MCML 1.2.2), tallies as files, the layered
   solver's answer on the grid of a file, and CONV's finite beams. Include it after ms_mcml.h. C99 and C++11.

     mci_file file;
     ms_error error;
     if (mci_load("skin.mci", &file, &error) == MS_OK) {
         const mci_run *run = &file.runs[0];
         ms_mcml_options options = ms_mcml_defaults();
         ms_mcml_result result;
         options.photons = run->photons;
         if (ms_mcml_simulate(&run->tissue, &run->grid, &options, &result, &error) == MS_OK) {
             mco_save(run->output, run, &result, NULL, 0, &error);
             ms_mcml_result_destroy(&result);
         }
         mci_destroy(&file);
     }

   Wang, Jacques, Zheng 1995 (MCML) and 1997 (CONV). Numbers have '.' in every locale. */
#ifndef EXAMPLES_MCI_H
#define EXAMPLES_MCI_H
#include "files.h"
#include "layered.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One run of an MCML 1.2 input file. */
typedef struct mci_run {
    char output[256]; /* name of the .mco file */
    char format;      /* 'A' or 'B', as the file says; both are written as text, as MCML does */
    uint64_t photons;
    ms_mcml_grid grid;
    ms_mcml_tissue tissue;
    size_t line; /* of the name in the file, from 1 */
} mci_run;

typedef struct mci_file {
    int run_count;
    mci_run *runs;         /* [run_count] */
    ms_mcml_layer *layers; /* of all runs */
} mci_file;

/* A failure: its line or layer, and a sentence by printf's rules. */
static inline ms_status mci__fail(ms_error *error, ms_status status, size_t position, const char *format, ...)
{
    if (error) {
        va_list list;
        error->status = status;
        error->position = position;
        va_start(list, format);
        vsnprintf(error->message, sizeof error->message, format, list);
        va_end(list);
    }
    return status;
}

/* ---- reading --------------------------------------------------------------------------------------------------- */

/* The current data line without its comment, and the rest of the text. */
typedef struct mci__text {
    const char *p, *stop;   /* of the line */
    const char *next, *end; /* of the text */
    size_t line;
} mci__text;

static inline int mci__is_space(char c) { return (unsigned char)c <= 32; }

/* Goes to the next line with data; 0 at the end of the text. A line ends in LF, CR LF or CR. */
static inline int mci__next_line(mci__text *t)
{
    while (t->next < t->end) {
        t->p = t->stop = t->next;
        while (t->next < t->end && *t->next != '\n' && *t->next != '\r') ++t->next;
        while (t->stop < t->next && *t->stop != '#') ++t->stop;
        if (t->next < t->end && *t->next == '\r' && t->next + 1 < t->end && t->next[1] == '\n') ++t->next;
        if (t->next < t->end) ++t->next;
        ++t->line;
        while (t->p < t->stop && mci__is_space(*t->p)) ++t->p;
        if (t->p < t->stop) return 1;
    }
    return 0;
}

/* A decimal number that a blank or the end of the line follows; 0 if there is none. */
static inline int mci__number(mci__text *t, double *out)
{
    char word[100], *end;
    size_t n = 0;
    while (t->p < t->stop && mci__is_space(*t->p)) ++t->p;
    for (; t->p + n < t->stop && !mci__is_space(t->p[n]); ++n) {
        if (n == sizeof word - 1 || t->p[n] == 0 || strchr("+-.0123456789eE", t->p[n]) == NULL) return 0;
        word[n] = t->p[n];
    }
    word[n] = 0;
    *out = number_read(word, '.', &end);
    t->p += n;
    return n > 0 && end == word + n;
}

/* A data line that starts with `count` numbers from low to high; `what` names them in messages. */
static inline ms_status mci__read_line(mci__text *t, double *out, int count, double low, double high, const char *what,
                                       ms_error *error)
{
    int i;
    if (!mci__next_line(t))
        return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: the file ends before %s", (unsigned long)t->line,
                         what);
    for (i = 0; i < count; ++i) {
        if (!mci__number(t, &out[i]))
            return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: %s: number %d of %d is missing or malformed",
                             (unsigned long)t->line, what, i + 1, count);
        if (!(out[i] >= low && out[i] <= high))
            return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: %s is %g, expected %g to %g",
                             (unsigned long)t->line, what, out[i], low, high);
    }
    return MS_OK;
}

/* The same for whole numbers. */
static inline ms_status mci__read_counts(mci__text *t, double *out, int count, double high, const char *what,
                                         ms_error *error)
{
    const ms_status status = mci__read_line(t, out, count, 1, high, what, error);
    int i;
    for (i = 0; i < count && status == MS_OK; ++i)
        if (floor(out[i]) < out[i])
            return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: %s is %g, expected a whole number",
                             (unsigned long)t->line, what, out[i]);
    return status;
}

static inline ms_status mci__read_layer(mci__text *t, ms_mcml_layer *layer, int index, ms_error *error)
{
    static const char *const name[5] = {"refractive index n", "mu_a per cm", "mu_s per cm", "mean cosine g",
                                        "thickness"};
    static const double low[5] = {0.01, 0, 0, -1, 1e-300}, high[5] = {100, 1e9, 1e9, 1, 1e300};
    double v[5];
    int i;
    const ms_status status = mci__read_line(t, v, 5, -1e300, 1e300, "n mu_a mu_s g d of a layer", error);
    if (status) return status;
    for (i = 0; i < 5; ++i)
        if (!(v[i] >= low[i] && v[i] <= high[i]) || (i == 3 && v[3] <= -1 && v[2] > 0))
            return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: layer %d: %s is %g, expected %s%g to %g",
                             (unsigned long)t->line, index + 1, name[i], v[i], i == 3 ? "above " : "", low[i], high[i]);
    layer->n = v[0];
    layer->mu_a_per_cm = v[1];
    layer->mu_s_per_cm = v[2];
    layer->g = v[3];
    layer->thickness_cm = v[4];
    return MS_OK;
}

/* One run; its layers go to `layers` unless that is NULL. */
static inline ms_status mci__read_run(mci__text *t, mci_run *run, ms_mcml_layer *layers, ms_error *error)
{
    ms_mcml_layer layer;
    ms_status status;
    double photons = 0, width[2] = {0, 0}, bins[3] = {0, 0, 0}, count = 0;
    size_t n = 0;
    int i;
    memset(run, 0, sizeof *run);
    if (!mci__next_line(t))
        return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: the file ends before the output name of a run",
                         (unsigned long)t->line);
    run->line = t->line;
    for (; t->p < t->stop && !mci__is_space(*t->p); ++t->p, ++n) {
        if (n + 1 == sizeof run->output)
            return mci__fail(error, MS_BAD_DATA, t->line, "line %lu: the output name is longer than 255 bytes",
                             (unsigned long)t->line);
        run->output[n] = *t->p;
    }
    while (t->p < t->stop && mci__is_space(*t->p)) ++t->p;
    run->format = t->p < t->stop && (*t->p == 'B' || *t->p == 'b') ? 'B' : 'A';
    status = mci__read_counts(t, &photons, 1, 4294967296.0, "the number of photons", error);
    if (status == MS_OK) status = mci__read_line(t, width, 2, 1e-30, 1e30, "dz, dr", error);
    if (status == MS_OK) status = mci__read_counts(t, bins, 3, 2147483646, "the number of dz, dr, da", error);
    if (status == MS_OK) status = mci__read_counts(t, &count, 1, 32767, "the number of layers", error);
    if (status) return status;
    run->photons = (uint64_t)photons;
    run->grid.dz_cm = width[0];
    run->grid.dr_cm = width[1];
    run->grid.nz = (int)bins[0];
    run->grid.nr = (int)bins[1];
    run->grid.na = (int)bins[2];
    run->tissue.layer_count = (int)count;
    run->tissue.layers = layers;
    status = mci__read_line(t, &run->tissue.n_above, 1, 0.01, 100, "n of the medium above", error);
    for (i = 0; i < run->tissue.layer_count && status == MS_OK; ++i)
        status = mci__read_layer(t, layers ? &layers[i] : &layer, i, error);
    if (status) return status;
    return mci__read_line(t, &run->tissue.n_below, 1, 0.01, 100, "n of the medium below", error);
}

static inline void mci_destroy(mci_file *file)
{
    if (file == NULL) return;
    free(file->runs);
    free(file->layers);
    memset(file, 0, sizeof *file);
}

/* Reads every run of an .mci file in memory (no NUL needed at its end). '#' starts a comment, blank lines are skipped,
   text after the numbers of a line is ignored as MCML does. Release with mci_destroy.
   MS_BAD_DATA (position: line, from 1): anything missing, not a number or out of range, an output name given twice.
   MS_UNSUPPORTED: UTF-16, MCML 2. MS_OUT_OF_MEMORY. *file is untouched then. */
static inline ms_status mci_read(const char *text, size_t size, mci_file *file, ms_error *error)
{
    mci__text start, t;
    mci_run run;
    mci_file out;
    ms_mcml_layer *layers;
    ms_status status;
    double count = 0, version = 0;
    size_t layer_count = 0;
    int i, k;
    memset(&t, 0, sizeof t);
    t.next = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? text + 3 : text; /* byte order mark */
    t.end = text + size;
    if (size >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0))
        return mci__fail(error, MS_UNSUPPORTED, 1, "line 1: the file is in UTF-16, expected ASCII or UTF-8");
    if (!mci__next_line(&t)) {
        t.line += t.line == 0;
        return mci__fail(error, MS_BAD_DATA, t.line, "line %lu: the file is empty", (unsigned long)t.line);
    }
    if (t.stop - t.p >= 4 && memcmp(t.p, "mcml", 4) == 0)
        return mci__fail(error, MS_UNSUPPORTED, t.line, "line %lu: an input file of MCML 2, expected MCML 1",
                         (unsigned long)t.line);
    if (!mci__number(&t, &version))
        return mci__fail(error, MS_BAD_DATA, t.line, "line %lu: expected the file's version, 1.0",
                         (unsigned long)t.line);
    if (!(version >= 1 && version < 2))
        return mci__fail(error, MS_UNSUPPORTED, t.line, "line %lu: the file's version is %g, expected 1.0",
                         (unsigned long)t.line, version);
    status = mci__read_counts(&t, &count, 1, 32767, "the number of runs", error);
    if (status) return status;
    start = t; /* once to check and to count, once to fill */
    for (i = 0; i < (int)count; ++i) {
        status = mci__read_run(&t, &run, NULL, error);
        if (status) return status;
        layer_count += (size_t)run.tissue.layer_count;
    }
    out.run_count = (int)count;
    out.runs = (mci_run *)malloc((size_t)out.run_count * sizeof *out.runs);
    out.layers = layers = (ms_mcml_layer *)malloc(layer_count * sizeof *layers);
    if (out.runs == NULL || out.layers == NULL) {
        mci_destroy(&out);
        return mci__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for %d runs", (int)count);
    }
    t = start;
    for (i = 0; i < out.run_count && status == MS_OK; ++i) {
        status = mci__read_run(&t, &out.runs[i], layers, error);
        layers += out.runs[i].tissue.layer_count;
        for (k = 0; k < i && status == MS_OK; ++k)
            if (strcmp(out.runs[k].output, out.runs[i].output) == 0)
                status = mci__fail(error, MS_BAD_DATA, out.runs[i].line,
                                   "line %lu: the output name %.100s was given in line %lu before",
                                   (unsigned long)out.runs[i].line, out.runs[i].output,
                                   (unsigned long)out.runs[k].line);
    }
    if (status) mci_destroy(&out);
    else *file = out;
    return status;
}

/* The same from a file. MS_IO: it cannot be opened or read. MS_BAD_DATA, too: a run's output has this file's name. No
   message names the file: the caller does. */
static inline ms_status mci_load(const char *path, mci_file *file, ms_error *error)
{
    const char *problem = "cannot be read";
    FILE *f = file_open(path, &problem);
    char *text = NULL;
    size_t size = 0, room = 0;
    ms_status status = MS_OK;
    mci_file out;
    int i;
    if (f == NULL) return mci__fail(error, MS_IO, 0, "%s", problem);
    while (status == MS_OK && !feof(f)) {
        if (size == room) { /* grows, since not everything that can be read has a length */
            const size_t more = room ? 4 * room : 16384;
            char *grown = more > (size_t)1 << 28 ? NULL : (char *)realloc(text, more);
            if (grown == NULL) status = mci__fail(error, MS_OUT_OF_MEMORY, 0, "too large");
            if (grown == NULL) break;
            text = grown;
            room = more;
        }
        size += fread(text + size, 1, room - size, f);
        if (ferror(f)) status = mci__fail(error, MS_IO, 0, "%s", problem);
    }
    fclose(f);
    if (status == MS_OK) status = mci_read(text, size, &out, error);
    free(text);
    if (status) return status;
    for (i = 0; i < out.run_count && strcmp(out.runs[i].output, path) != 0; ++i) {}
    if (i < out.run_count) {
        status = mci__fail(error, MS_BAD_DATA, out.runs[i].line, "line %lu: the output would replace this input file",
                           (unsigned long)out.runs[i].line);
        mci_destroy(&out);
        return status;
    }
    *file = out;
    return MS_OK;
}

/* ---- writing --------------------------------------------------------------------------------------------------- */

/* A number by a format of printf, right-aligned to `width` characters (left-aligned: negative); NaN is "nan". */
static inline void mco__number(FILE *f, const char *format, int width, double x, const char *after)
{
    char text[48];
    fprintf(f, "%*s%s", width, x - x < 0 || x - x > 0 || x != x ? "nan" : number_text(text, format, x), after);
}

static inline void mco__column(FILE *f, const char *head, const double *x, int n, double scale)
{
    int i;
    fputs(head, f);
    for (i = 0; i < n; ++i) mco__number(f, "%.4E", 12, x ? x[i] * scale : (double)NAN, "\n");
    fputs("\n", f);
}

/* Five numbers a line. */
static inline void mco__table(FILE *f, const char *head, const double *x, size_t n)
{
    size_t i;
    fputs(head, f);
    for (i = 0; i < n; ++i) mco__number(f, "%.4E", 12, x ? x[i] : (double)NAN, i % 5 == 4 ? " \n" : " ");
    fputs("\n", f);
}

static inline void mco__head(FILE *f, const mci_run *run, const ms_mcml_result *result, const char *note,
                             double seconds)
{
    int i;
    fprintf(f,
            "%s \t# Version number of the file format.\n\n####\n# Data categories include: \n# InParm, RAT, \n"
            "# A_l, A_z, Rd_r, Rd_a, Tt_r, Tt_a, \n# A_rz, Rd_ra, Tt_ra \n####\n\n# User time: ",
            run->format == 'B' ? "B1" : "A1");
    mco__number(f, "%.0f", 8, seconds, " sec = ");
    mco__number(f, "%.2f", 8, seconds / 3600, " hr.   Simulation time of this run.\n");
    if (note) fprintf(f, "# %s\n", note);
    fprintf(f, "\nInParm \t\t\t# Input parameters. cm is used.\n%s \tA\t\t# output file name, ASCII.\n", run->output);
    fprintf(f, "%.0f \t\t\t# No. of photons\n", (double)result->photons);
    mco__number(f, "%G", 0, run->grid.dz_cm, "\t");
    mco__number(f, "%G", 0, run->grid.dr_cm, "\t\t# dz, dr [cm]\n");
    fprintf(f, "%d\t%d\t%d\t# No. of dz, dr, da.\n\n%d\t\t\t\t\t# Number of layers\n", run->grid.nz, run->grid.nr,
            run->grid.na, run->tissue.layer_count);
    fputs("#n\tmua\tmus\tg\td\t# One line for each layer\n", f);
    mco__number(f, "%G", 0, run->tissue.n_above, "\t\t\t\t\t# n for medium above\n");
    for (i = 0; i < run->tissue.layer_count; ++i) {
        const ms_mcml_layer *l = &run->tissue.layers[i];
        mco__number(f, "%G", 0, l->n, "\t");
        mco__number(f, "%G", 0, l->mu_a_per_cm, "\t");
        mco__number(f, "%G", 0, l->mu_s_per_cm, "\t");
        mco__number(f, "%G", 0, l->g, "\t");
        mco__number(f, "%G", 0, l->thickness_cm, "\t# layer ");
        fprintf(f, "%d\n", i + 1);
    }
    mco__number(f, "%G", 0, run->tissue.n_below, "\t\t\t\t\t# n for medium below\n\n");
    fputs("RAT #Reflectance, absorption, transmission. \n", f);
    mco__number(f, "%.6G", -14, result->specular, " \t#Specular reflectance [-]\n");
    mco__number(f, "%.6G", -14, result->rd, " \t#Diffuse reflectance [-]\n");
    mco__number(f, "%.6G", -14, result->a, " \t#Absorbed fraction [-]\n");
    mco__number(f, "%.6G", -14, result->tt, " \t#Transmittance [-]\n\n");
}

/* Prints an .mco file as MCML 1.2.2 does; ferror(f) tells whether that failed.
   note      one line that is written as a comment, or NULL
   seconds   user time for the comment line
   An array that is NULL is written as nan, so that every number keeps its place. */
static inline void mco_print(FILE *f, const mci_run *run, const ms_mcml_result *result, const char *note,
                             double seconds)
{
    const int nr = run->grid.nr, nz = run->grid.nz, na = run->grid.na;
    const double da = 1.5707963267948966 / na;
    const double angle = 2 * sin(da / 2) / da; /* MCML takes the solid angle of Rd_a, Tt_a as 2 pi sin(a) da */
    int i;
    mco__head(f, run, result, note, seconds > 0 ? seconds : 0);
    fputs("A_l #Absorption as a function of layer. [-]\n", f);
    for (i = 0; i < result->layer_count; ++i) mco__number(f, "%.4G", 12, result->a_l[i], "\n");
    fputs("\n", f);
    mco__column(f, "A_z #A[0], [1],..A[nz-1]. [1/cm]\n", result->a_z, nz, 1);
    mco__column(f, "Rd_r #Rd[0], [1],..Rd[nr-1]. [1/cm2]\n", result->rd_r, nr, 1);
    mco__column(f, "Rd_a #Rd[0], [1],..Rd[na-1]. [sr-1]\n", result->rd_a, na, angle);
    mco__column(f, "Tt_r #Tt[0], [1],..Tt[nr-1]. [1/cm2]\n", result->tt_r, nr, 1);
    mco__column(f, "Tt_a #Tt[0], [1],..Tt[na-1]. [sr-1]\n", result->tt_a, na, angle);
    mco__table(f,
               "# A[r][z]. [1/cm3]\n# A[0][0], [0][1],..[0][nz-1]\n# A[1][0], [1][1],..[1][nz-1]\n# ...\n"
               "# A[nr-1][0], [nr-1][1],..[nr-1][nz-1]\nA_rz\n",
               result->a_rz, (size_t)nr * (size_t)nz);
    mco__table(f,
               "# Rd[r][angle]. [1/(cm2sr)].\n# Rd[0][0], [0][1],..[0][na-1]\n# Rd[1][0], [1][1],..[1][na-1]\n# ...\n"
               "# Rd[nr-1][0], [nr-1][1],..[nr-1][na-1]\nRd_ra\n",
               result->rd_ra, (size_t)nr * (size_t)na);
    mco__table(f,
               "# Tt[r][angle]. [1/(cm2sr)].\n# Tt[0][0], [0][1],..[0][na-1]\n# Tt[1][0], [1][1],..[1][na-1]\n# ...\n"
               "# Tt[nr-1][0], [nr-1][1],..[nr-1][na-1]\nTt_ra\n",
               result->tt_ra, (size_t)nr * (size_t)na);
}

/* The same to a file, which replaces an old one when it is whole. MS_INVALID_ARGUMENT: the result of another run.
   MS_IO: it cannot be written; the old file stays. */
static inline ms_status mco_save(const char *path, const mci_run *run, const ms_mcml_result *result, const char *note,
                                 double seconds, ms_error *error)
{
    file_out out;
    const char *problem;
    FILE *f;
    if (run->grid.nr != result->grid.nr || run->grid.nz != result->grid.nz || run->grid.na != result->grid.na ||
        run->tissue.layer_count != result->layer_count)
        return mci__fail(error, MS_INVALID_ARGUMENT, 0, "the result belongs to another run");
    f = file_create(path, &out);
    if (f) mco_print(f, run, result, note, seconds);
    problem = f ? file_finish(&out, 1) : out.problem;
    return problem ? mci__fail(error, MS_IO, 0, "%.150s: %s", path, problem) : MS_OK;
}

/* ---- layers without noise -------------------------------------------------------------------------------------- */

/* The layered solver's answer over a grid, as from ms_mcml_simulate: totals, rings and what layers absorb with their
   errors; A_z without (it adds up to a). result->photons is 0. Angles only in a grid of one, A_rz not at all: those
   arrays are NULL. The last ring holds all that lies beyond, as in a tally. Release with ms_mcml_result_destroy.
   Failures, which are those of ms_mcml_layered_solve, leave it untouched. */
static inline ms_status mci_layered(const ms_mcml_tissue *tissue, const ms_mcml_grid *grid, const ms_progress *progress,
                                    ms_mcml_result *result, ms_error *error)
{
    const double solid = 6.283185307179586, cosine = sqrt(0.5), dr = grid->dr_cm;
    const size_t nr = (size_t)grid->nr, nz = (size_t)grid->nz, layers = (size_t)tissue->layer_count,
                 one = grid->na == 1 ? 1 : 0, size = ((4 + 4 * one) * (nr + one) + nz + 2 * layers) * sizeof(double);
    ms_mcml_layered_options o;
    ms_mcml_layered *s = (ms_mcml_layered *)malloc(sizeof *s);
    double *block = (double *)malloc(size);
    ms_mcml_result out;
    ms_status status;
    int i, side;
    memset(&o, 0, sizeof o);
    memset(&out, 0, sizeof out);
    if (s == NULL || block == NULL) {
        free(s);
        free(block);
        return mci__fail(error, MS_OUT_OF_MEMORY, 0, "no memory for the results");
    }
    out.memory = block;
    out.memory_size = size;
    out.grid = *grid;
    out.layer_count = tissue->layer_count;
    out.a_l = o.a_l = block;
    out.a_l_error = block + layers;
    out.a_z = o.a_z = block + 2 * layers;
    block += 2 * layers + nz;
    o.dz_cm = grid->dz_cm;
    o.nz = grid->nz;
    if (progress) o.progress = *progress;
    status = ms_mcml_layered_solve(tissue, &o, s, error);
    if (status != MS_OK) {
        free(out.memory);
        free(s);
        return status;
    }
    out.specular = s->specular;
    out.rd = s->rd;
    out.rd_error = s->rd_error;
    out.tt = s->tt;
    out.tt_error = s->tt_error;
    out.a = s->a;
    out.a_error = s->rd_error + s->tt_error;
    out.rd_unscattered = s->rd_unscattered;
    out.tt_unscattered = s->tt_unscattered;
    for (i = 0; i < tissue->layer_count; ++i) out.a_l_error[i] = out.a_error;
    for (side = 0; side < 2; ++side) {
        double *r = block, *r_error = r + nr, *ra = one ? r + 2 * nr : NULL, *ra_error = one ? r + 3 * nr : NULL,
               *a = one ? r + 4 * nr : NULL, *a_error = one ? a + 1 : NULL;
        block += (2 + 2 * one) * nr + 2 * one;
        for (i = 0; i < grid->nr; ++i) {
            const double r0 = i * dr;
            r[i] = ms_mcml_layered_ring(s, side, r0, r0 + dr, &r_error[i]);
            if (i + 1 == grid->nr) { /* the energy beyond r0, as if it were all in this ring */
                const double scale = 1e100 / dr / (2 * i + 1) * (1e100 / dr);
                r[i] = scale * ms_mcml_layered_ring(s, side, r0, 1e100, &r_error[i]);
                r_error[i] *= scale;
            }
            if (one) ra[i] = r[i] / (solid * cosine), ra_error[i] = r_error[i] / (solid * cosine);
        }
        if (one) a[0] = (side ? s->tt : s->rd) / solid, a_error[0] = (side ? s->tt_error : s->rd_error) / solid;
        *(side ? &out.tt_r : &out.rd_r) = r;
        *(side ? &out.tt_r_error : &out.rd_r_error) = r_error;
        *(side ? &out.tt_a : &out.rd_a) = a;
        *(side ? &out.tt_a_error : &out.rd_a_error) = a_error;
        *(side ? &out.tt_ra : &out.rd_ra) = ra;
        *(side ? &out.tt_ra_error : &out.rd_ra_error) = ra_error;
    }
    free(s);
    *result = out;
    return status;
}

/* ---- finite beams ---------------------------------------------------------------------------------------------- */

typedef enum mci_beam {
    MCI_BEAM_FLAT = 1,    /* equal over a disc */
    MCI_BEAM_GAUSSIAN = 2 /* exp(-2 r^2 / radius^2): falls to 1/e^2 at the radius */
} mci_beam;

/* exp(-x) I0(x), x >= 0: the power series, or from 20 on the asymptotic one. */
static inline double mci__bessel_i0_scaled(double x)
{
    double term = 1, sum = 1;
    int k;
    for (k = 1; k < 80 && term > 1e-17 * sum; ++k) {
        term *= x < 20 ? x * x / (4.0 * k * k) : (2 * k - 1) * (2 * k - 1) / (8 * x * k);
        sum += term;
    }
    return x < 20 ? sum * exp(-x) : sum / sqrt(6.283185307179586 * x);
}

/* Area that discs of radii a and b have in common, their centers d apart. */
static inline double mci__lens(double a, double b, double d)
{
    const double smaller = a < b ? a : b, square = (a + b - d) * (d + a - b) * (d - a + b) * (d + a + b);
    double root;
    if (d >= a + b) return 0;
    if (d <= fabs(a - b)) return 3.141592653589793 * smaller * smaller;
    root = sqrt(square > 0 ? square : 0); /* 2 d a sin(alpha) = 2 d b sin(beta) */
    return a * a * atan2(root, d * d + a * a - b * b) + b * b * atan2(root, d * d + b * b - a * a) - 0.5 * root;
}

/* Energy of a Gaussian beam of total 1 in the ring from a to b around a point at distance r from its axis:
   integral of 4 rho / R^2 exp(-2 (r - rho)^2 / R^2) exp(-x) I0(x) over rho, x = 4 r rho / R^2; Gauss-Legendre. */
static inline double mci__gaussian_ring(double radius, double r, double a, double b)
{
    static const double node[4] = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623};
    static const double weight[4] = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                     0.10122853629037626};
    const double square = radius * radius, reach = 5 * radius; /* exp(-2 5^2) = 2e-22 */
    double sum = 0, width;
    int panels, p, k;
    if (a < r - reach) a = r - reach;
    if (b > r + reach) b = r + reach;
    if (a >= b) return 0;
    panels = (int)ceil((b - a) / (0.5 * radius));
    width = (b - a) / panels;
    for (p = 0; p < panels; ++p) {
        for (k = 0; k < 8; ++k) {
            const double rho = a + (p + 0.5 + (k & 1 ? 0.5 : -0.5) * node[k / 2]) * width, d = r - rho;
            sum += weight[k / 2] * 0.5 * width * (4 * rho / square) * exp(-2 * d * d / square) *
                mci__bessel_i0_scaled(4 * r * rho / square);
        }
    }
    return sum;
}

/* Responses to a pencil beam, averages over rings of width dr_cm, turned into responses at given radii to a finite beam
   of total energy 1 around r = 0 (its disc or Gaussian integrated over each ring, to about 1e-9).
   radius_cm  > 0, the beam's
   rows       >= 1 quantities side by side: value[ring * rows + row], as in rd_r (1 row), rd_ra (na) or a_rz (nz)
   error      NULL, or standard errors like value; rings are taken as independent
   r_cm       [count] >= 0
   out        [count][rows]; out_error likewise, or NULL
   The last ring of a tally holds what lies beyond and is left out: value has nr rings, nr - 1 are used.
   MS_INVALID_ARGUMENT. MCML's companion CONV does the same: Wang, Jacques, Zheng 1997. */
static inline ms_status mci_convolve(int beam, double radius_cm, double dr_cm, int nr, int rows, const double *value,
                                     const double *error, const double *r_cm, int count, double *out, double *out_error,
                                     ms_error *failure)
{
    const double disc = 3.141592653589793 * radius_cm * radius_cm;
    int i, k;
    size_t j, n;
    if (beam != MCI_BEAM_FLAT && beam != MCI_BEAM_GAUSSIAN)
        return mci__fail(failure, MS_INVALID_ARGUMENT, 0, "beam is %d, expected one of mci_beam", beam);
    if (!(radius_cm >= 1e-30 && radius_cm <= 1e30) || !(dr_cm >= 1e-30 && dr_cm <= 1e30))
        return mci__fail(failure, MS_INVALID_ARGUMENT, 0, "radius and dr are %g and %g cm, expected above 0", radius_cm,
                         dr_cm);
    if (nr < 1 || rows < 1 || count < 0 || value == NULL || (count > 0 && (r_cm == NULL || out == NULL)) ||
        (out_error != NULL && error == NULL))
        return mci__fail(failure, MS_INVALID_ARGUMENT, 0, "nr %d, rows %d, count %d, or an array that is NULL", nr,
                         rows, count);
    for (k = 0; k < count; ++k)
        if (!(r_cm[k] >= 0 && r_cm[k] <= 1e30))
            return mci__fail(failure, MS_INVALID_ARGUMENT, (size_t)k, "radius %d is %g cm, expected 0 or more", k,
                             r_cm[k]);

    n = (size_t)rows;
    for (k = 0; k < count; ++k, out += n) {
        double inside = 0;
        for (j = 0; j < n; ++j) out[j] = 0;
        for (j = 0; out_error && j < n; ++j) out_error[j] = 0;
        for (i = 0; i + 1 < nr; ++i) {
            const size_t ring = (size_t)i * n;
            double energy;
            if (beam == MCI_BEAM_FLAT) {
                const double next = mci__lens(radius_cm, (i + 1) * dr_cm, r_cm[k]) / disc;
                energy = next - inside;
                inside = next;
            } else {
                energy = mci__gaussian_ring(radius_cm, r_cm[k], i * dr_cm, (i + 1) * dr_cm);
            }
            for (j = 0; j < n; ++j) out[j] += energy * value[ring + j];
            for (j = 0; out_error && j < n; ++j) out_error[j] += energy * energy * error[ring + j] * error[ring + j];
        }
        for (j = 0; out_error && j < n; ++j) out_error[j] = sqrt(out_error[j]);
        if (out_error) out_error += n;
    }
    return MS_OK;
}
#endif
