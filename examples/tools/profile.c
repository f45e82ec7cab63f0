/* The diffusion profile of a material as a table: r_mm,R,G,B in 1/mm^2, rings of equal width, r_mm their middle.

     cc -O2 -I. examples/tools/profile.c -o build/profile -lm
     build/profile skin1
     build/profile --mua 0.032,0.17,0.48 --mus 0.74,0.88,1.01 --eta 1.3 --photons 10000000 --csv skin1.csv
     build/profile --mci skin.mci                (layers: r_mm, R and T in 1/mm^2 of the file's first run)
     build/profile --color 0.8,0.52,0.39 --mfp 1.2,0.42,0.24 --eta 1.4    (linear; of the light let in; mean free path
                                                  in mm, or --dmfp: Unreal's diffuse one, --distance: HDRP's scattering
                                                  distance, Burley's d)
     build/profile --skin melanin=0.03,blood=0.02,oxygen=0.7,eumelanin=0.8,epidermis_mm=0.06,dermis_mm=2,scattering=2.2
     build/profile --list

   Without --photons the solvers: no noise; --mci and --skin take isotropic layers (g = 0; layered.h says which). With
   it, Monte Carlo. total_reflectance is of the light that arrives; divided by the part that enters it is a picked
   color.
   --csv saves the table to a file, whose folder is made if it is not there; then only the comment lines are printed.
   Exit: 0, 1 if something failed, 2 if the arguments are wrong. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "mci.h"
#include "photon_profile.h"
#include "skin.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage_text[] =
    "usage: profile MATERIAL | --mua R,G,B --mus R,G,B --eta N [--photons N] [--csv FILE]\n"
    "  profile --mci FILE.mci [--csv FILE]    layers, in the rings of the file's first run\n"
    "  profile --color R,G,B (--mfp|--dmfp|--distance) R,G,B [--eta N] [--csv FILE]    as artists pick them, 0 to 1 and mm\n"
    "  profile --skin [melanin=..,blood=..,...] [--csv FILE]    skin from what it is made of; --skin default\n"
    "  profile --list    the materials; coefficients are per mm\n";

static int usage(const char *problem, const char *value)
{
    fprintf(stderr, "profile: %s%s%s\n", problem, value ? ": " : "", value ? value : "");
    return file_usage(usage_text);
}

/* "1,2,3" into count numbers, or "1" into all of them: whether text is just that. */
static int parse_numbers(const char *text, double *out, int count)
{
    char *end;
    int i;
    for (i = 0; i < count; ++i) {
        out[i] = strtod(text, &end);
        if (end == text || (*end != ',' && *end != 0)) return 0;
        if (*end == 0) break;
        text = end + 1;
    }
    if (i == 0)
        while (++i < count) out[i] = out[0];
    return i >= count - 1 && *end == 0;
}

static void list_materials(void)
{
    int count, i;
    const ms_mcml_material *m = ms_mcml_materials(&count);
    for (i = 0; i < count; ++i, ++m)
        printf("%-9s  --mua %.4f,%.4f,%.4f  --mus %.2f,%.2f,%.2f  --eta %g\n", m->name, m->mu_a_per_mm[0],
               m->mu_a_per_mm[1], m->mu_a_per_mm[2], m->mu_s_per_mm[0], m->mu_s_per_mm[1], m->mu_s_per_mm[2], m->eta);
}

/* What a profile is of. */
typedef struct subject {
    const char *name;
    const ms_mcml_material *material; /* NULL: skin */
    skin_parameters skin;
    double photons;
} subject;

static void print_head(FILE *f, const subject *what, const ms_mcml_profile *p)
{
    const ms_mcml_material *m = what->material;
    const skin_parameters *k = &what->skin;
    const double photons = what->photons;
    if (m) {
        const double *a = m->mu_a_per_mm, *s = m->mu_s_per_mm;
        fprintf(f, "# %s: mu_a %.9g,%.9g,%.9g mu_s %.9g,%.9g,%.9g per mm, g 0, eta %g\n", what->name, a[0], a[1], a[2],
                s[0], s[1], s[2], m->eta);
    } else {
        fprintf(
            f,
            "# skin: melanin %g, eumelanin %g, blood %g, oxygen %g, epidermis_mm %g, dermis_mm %g, scattering %g, g %g\n",
            k->melanin, k->eumelanin, k->blood, k->oxygen, k->epidermis_mm, k->dermis_mm, k->scattering, k->g);
    }
    if (m == NULL) fprintf(f, "# layered solver, 13 wavelengths; R,G,B linear sRGB under D65\n");
    else if (!(photons > 0)) fprintf(f, "# half-space solver\n");
    else fprintf(f, "# Monte Carlo, %.0f photons\n", photons);
    fprintf(f, "# total_reflectance,%.9g,%.9g,%.9g\n# of the light that arrives; %.9g of it enters\n", p->total[0],
            p->total[1], p->total[2], p->entering[0]);
    if (photons > 0)
        fprintf(f, "# standard_error,%.3g,%.3g,%.3g\n", p->total_error[0], p->total_error[1], p->total_error[2]);
    fprintf(f, "# %d rings %.9g mm wide; R_d is the mean over each, r_mm its middle\n", p->rings, p->edge_mm[1]);
}

static void print_table(FILE *f, const ms_mcml_profile *p)
{
    const double *rd = p->rd_per_mm2;
    int i;
    fprintf(f, "r_mm,R,G,B\n");
    for (i = 0; i < p->rings; ++i)
        fprintf(f, "%.9g,%.9g,%.9g,%.9g\n", 0.5 * (p->edge_mm[i] + p->edge_mm[i + 1]), rd[i], rd[p->rings + i],
                rd[2 * p->rings + i]);
}

static void print_layers(FILE *f, const mci_run *run, const ms_mcml_layered *s)
{
    const double dr = run->grid.dr_cm;
    int i;
    fprintf(f, "# %s: %d layers, layered solver\n", run->output, run->tissue.layer_count);
    fprintf(f, "# specular,%.9g\n# total_reflectance,%.9g\n# total_transmittance,%.9g\n# absorbed,%.9g\n", s->specular,
            s->rd, s->tt, s->a);
    fprintf(f, "# error_of_totals,%.2g,%.2g\n", s->rd_error, s->tt_error);
    fprintf(f, "# %d rings %.9g mm wide; R and T are means over each, r_mm its middle\n", run->grid.nr, 10 * dr);
    fprintf(f, "r_mm,R_1/mm2,T_1/mm2\n");
    for (i = 0; i < run->grid.nr; ++i)
        fprintf(f, "%.9g,%.9g,%.9g\n", 10 * (i + 0.5) * dr,
                0.01 * ms_mcml_layered_ring(s, 0, i * dr, (i + 1) * dr, NULL),
                0.01 * ms_mcml_layered_ring(s, 1, i * dr, (i + 1) * dr, NULL));
}

/* The first run of an .mci file. */
static int layers(const char *path, const char *csv)
{
    mci_file file;
    ms_mcml_layered solution;
    ms_error error;
    ms_status status = mci_load(path, &file, &error);
    int failed = 0;
    if (status == MS_OK) {
        status = ms_mcml_layered_solve(&file.runs[0].tissue, NULL, &solution, &error);
        if (status) mci_destroy(&file);
    }
    if (status) {
        fprintf(stderr, "profile: %s: %s\n", path, error.message);
        return 1;
    }
    if (csv) {
        file_out out;
        FILE *f = file_create(csv, &out);
        const char *trouble = out.problem;
        if (f) {
            print_layers(f, &file.runs[0], &solution);
            trouble = file_finish(&out, 1);
        }
        if (trouble) fprintf(stderr, "profile: %s: %s\n", csv, trouble);
        failed = trouble != NULL;
    } else {
        print_layers(stdout, &file.runs[0], &solution);
    }
    mci_destroy(&file);
    return file_end_stdout("profile") || failed;
}

/* Prints the profile, to a file where csv names one; the exit code. */
static int finish(const subject *what, ms_mcml_profile *p, const char *csv)
{
    int failed = 0;
    print_head(stdout, what, p);
    if (csv) {
        file_out out;
        const char *trouble;
        FILE *f = file_create(csv, &out);
        if (f) {
            print_head(f, what, p);
            print_table(f, p);
        }
        trouble = f ? file_finish(&out, 1) : out.problem;
        if (trouble) fprintf(stderr, "profile: %s: %s\n", csv, trouble);
        failed = trouble != NULL;
    } else {
        print_table(stdout, p);
    }
    ms_mcml_profile_destroy(p);
    return file_end_stdout("profile") || failed;
}

/* "melanin=0.03,blood=0.02": what is not named stays as it is. NULL, or what is wrong. */
static const char *parse_skin(const char *text, skin_parameters *skin)
{
    static const char *const name[] = {"melanin",      "eumelanin", "blood",      "oxygen",
                                       "epidermis_mm", "dermis_mm", "scattering", "g"};
    double *value[8];
    int i;
    value[0] = &skin->melanin;
    value[1] = &skin->eumelanin;
    value[2] = &skin->blood;
    value[3] = &skin->oxygen;
    value[4] = &skin->epidermis_mm;
    value[5] = &skin->dermis_mm;
    value[6] = &skin->scattering;
    value[7] = &skin->g;
    if (strcmp(text, "default") == 0) return NULL;
    for (;;) {
        size_t n = strcspn(text, "=,");
        char *end;
        for (i = 0; i < 8 && (strlen(name[i]) != n || strncmp(text, name[i], n) != 0); ++i) {}
        if (i == 8 || text[n] != '=') return text;
        *value[i] = strtod(text + n + 1, &end);
        if (end == text + n + 1 || (*end != ',' && *end != 0)) return text;
        if (*end == 0) return NULL;
        text = end + 1;
    }
}

int main(int argc, char **argv)
{
    const char *name = NULL, *csv = NULL, *mci = NULL;
    ms_mcml_material custom;
    const ms_mcml_material *material = NULL;
    ms_mcml_medium medium[3];
    ms_mcml_profile_options options;
    ms_mcml_profile profile;
    ms_error error;
    ms_status status;
    double photons = 0, shortest = 0, longest = 0, rings, color[3], length[3];
    int i, given = 0, kind = 0, colored = 0, skinned = 0;
    subject what;
    memset(&custom, 0, sizeof custom);
    memset(&options, 0, sizeof options);
    memset(&what, 0, sizeof what);
    what.skin = skin_defaults();
    if (file_help(argc, argv, usage_text)) return file_end_stdout("profile");
    for (i = 1; i < argc; ++i) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--list") == 0) {
            list_materials();
            return file_end_stdout("profile");
        }
        if (strncmp(argv[i], "--", 2) != 0) {
            if (name) return usage("more than one material", argv[i]);
            name = argv[i];
            continue;
        }
        if (strcmp(argv[i], "--mua") == 0) {
            if (!parse_numbers(value, custom.mu_a_per_mm, 3))
                return usage("--mua needs one number or three, R,G,B, not", value);
            given |= 1;
        } else if (strcmp(argv[i], "--mus") == 0) {
            if (!parse_numbers(value, custom.mu_s_per_mm, 3))
                return usage("--mus needs one number or three, R,G,B, not", value);
            given |= 2;
        } else if (strcmp(argv[i], "--eta") == 0) {
            if (!parse_numbers(value, &custom.eta, 1)) return usage("--eta needs a number, not", value);
            given |= 4;
        } else if (strcmp(argv[i], "--color") == 0) {
            if (!parse_numbers(value, color, 3)) return usage("--color needs one number or three, R,G,B, not", value);
            colored |= 1;
        } else if (strcmp(argv[i], "--mfp") == 0 || strcmp(argv[i], "--dmfp") == 0 ||
                   strcmp(argv[i], "--distance") == 0) {
            kind = argv[i][2] == 'm' ? MS_MCML_MEAN_FREE_PATH
                : argv[i][3] == 'm'  ? MS_MCML_DIFFUSE_PATH
                                     : MS_MCML_BURLEY_D;
            if (!parse_numbers(value, length, 3) || colored & 2)
                return usage("one length, of one number or three, R,G,B, not", value);
            colored |= 2;
        } else if (strcmp(argv[i], "--skin") == 0) {
            const char *wrong = value[0] ? parse_skin(value, &what.skin) : "";
            if (wrong) return usage("--skin needs default or name=number,...; not", wrong);
            skinned = 1;
        } else if (strcmp(argv[i], "--photons") == 0) {
            if (!parse_numbers(value, &photons, 1) || !(photons >= 1 && photons < 4294967296.0))
                return usage("--photons needs a number from 1 to 4294967295, not", value);
        } else if (strcmp(argv[i], "--mci") == 0) {
            if (value[0] == 0) return usage("--mci needs a file name", NULL);
            mci = value;
        } else if (strcmp(argv[i], "--csv") == 0) {
            if (value[0] == 0) return usage("--csv needs a file name", NULL);
            csv = value;
        } else {
            return usage("unknown option", argv[i]);
        }
        ++i;
    }
    if (mci && (name || given || photons > 0 || colored || skinned)) return usage("--mci goes with --csv only", NULL);
    if (skinned && (name || given || photons > 0 || colored)) return usage("--skin goes with --csv only", NULL);
    if (mci) return layers(mci, csv);
    if (colored) {
        if (name || given & 3) return usage("--color takes the place of a material", NULL);
        if (colored != 3) return usage("--color and --mfp, --dmfp or --distance go together", NULL);
        if (!(given & 4)) custom.eta = 1.4;
        for (i = 0; i < 3; ++i) {
            if (ms_mcml_medium_from_color(color[i], length[i], kind, custom.eta, &medium[i], &error)) {
                fprintf(stderr, "profile: %s\n", error.message);
                return 2;
            }
            custom.mu_a_per_mm[i] = medium[i].mu_a_per_mm;
            custom.mu_s_per_mm[i] = medium[i].mu_s_per_mm;
        }
        given = 7;
    }
    what.photons = photons;
    if (skinned) {
        options.rings = 800;
        options.ring_mm = 0.05;
        status = skin_profile(&profile, &what.skin, &options, &error);
        if (status) fprintf(stderr, "profile: %s\n", error.message);
        if (status) return status == MS_INVALID_ARGUMENT ? 2 : 1;
        return finish(&what, &profile, csv);
    }
    if (name && given) return usage("a material's name or coefficients, not both", NULL);
    if (!name && given != 7) return usage(given ? "--mua, --mus and --eta go together" : "no material", NULL);
    material = name ? ms_mcml_find_material(name) : &custom;
    if (material == NULL) return usage("no such material (see --list)", name);

    /* Section 5.9: rings of a twentieth of the shortest mean free path, out to 32 of the longest. */
    for (i = 0; i < 3; ++i) {
        double path;
        medium[i] = ms_mcml_material_medium(material, i);
        path = 1 / (medium[i].mu_a_per_mm + medium[i].mu_s_per_mm);
        if (i == 0 || path < shortest) shortest = path;
        if (i == 0 || path > longest) longest = path;
    }
    rings = ceil(32 * longest / (shortest / 20));
    options.rings = rings >= 1 && rings <= 20000 ? (int)rings : 20000;
    options.ring_mm = rings <= 20000 ? shortest / 20 : 32 * longest / 20000;
    if (photons > 0) {
        ms_mcml_options direct = ms_mcml_defaults();
        direct.photons = (uint64_t)photons;
        status = photon_profile(&profile, medium, 3, options.rings, options.ring_mm, &direct, &error);
    } else {
        status = ms_mcml_profile_make(&profile, medium, 3, &options, &error);
    }
    if (status) {
        fprintf(stderr, "profile: %s\n", error.message);
        return 1;
    }
    what.name = name ? material->name : "medium";
    what.material = material;
    return finish(&what, &profile, csv);
}
