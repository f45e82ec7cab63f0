/* Writes materials as a MaterialX file, which renderers and editors open (materialx.h says what becomes of the 19
   parameters).

     cc -O2 -I. examples/tools/materialx.c -o build/materialx -lm
     build/materialx MATERIALS.csv OUT.mtlx [--name material]

   MATERIALS.csv: 19 numbers from 0 to 1 a line; a header line is optional, and columns score, mean, sigma behind them,
   as `recommend` writes them. The materials are called material_001, material_002, ... */
#include "materials.h"
#include "materialx.h"

static const char usage[] = "usage: materialx MATERIALS.csv OUT.mtlx [--name material]\n"
                            "  name: letters, digits and _, no digit first; at most 60 of them\n";

static int fail(const char *what, const char *problem)
{
    fprintf(stderr, "materialx: %s: %s\n", what, problem);
    return 1;
}

/* What MaterialX allows as a name. */
static int is_name(const char *text)
{
    size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    return length > 0 && length <= 60 && text[length] == 0 && !(text[0] >= '0' && text[0] <= '9');
}

int main(int argc, char **argv)
{
    const char *in = NULL, *out = NULL, *stem = "material", *problem;
    materials list;
    file_out saved;
    FILE *f;
    int i, k;
    if (file_help(argc, argv, usage)) return file_end_stdout("materialx");
    for (i = 1; i < argc; ++i) {
        if (argv[i][0] != '-' && in == NULL) in = argv[i];
        else if (argv[i][0] != '-' && out == NULL) out = argv[i];
        else if (strcmp(argv[i], "--name") == 0 && i + 1 < argc && is_name(argv[i + 1])) stem = argv[++i];
        else return file_usage(usage);
    }
    if (out == NULL) return file_usage(usage);
    if ((problem = materials_read(in, 19, &list)) != NULL) return fail(in, problem);
    if ((f = file_create(out, &saved)) == NULL) return fail(out, saved.problem);
    materialx_begin(f);
    for (i = 0; i < list.count; ++i) {
        char name[80], doc[80];
        double x[19];
        for (k = 0; k < 19; ++k) x[k] = (double)list.x[19 * i + k];
        snprintf(name, sizeof name, "%s_%03d", stem, i + 1);
        snprintf(doc, sizeof doc, "material %d", i + 1);
        materialx_write(f, name, x, doc);
    }
    materialx_end(f);
    if ((problem = file_finish(&saved, 1)) != NULL) return fail(out, problem);
    printf("%d materials\n", list.count);
    materials_free(&list);
    return file_end_stdout("materialx");
}
