/* WGSL of the subsurface shaders, for WebGPU:

     cc -O2 -I. examples/tools/sss_wgsl.c -o build/sss_wgsl -lm
     build/sss_wgsl examples/engine/shader                              writes the four usual variants there
     build/sss_wgsl examples/engine/shader MS_SSS_STEP=7 MS_SSS_TAPS=11 prints one

   The engine's module adds the functions ms_sss_fetch_... that the variant calls. Constants are at binding 0 of group
   0, targets of earlier steps at the bindings that the shader files name. */
#include "files.h"
#include "wgsl.h"

static const char usage[] = "usage: sss_wgsl FOLDER [NAME=VALUE ...]\n"
                            "  writes x.wgsl, y.wgsl and their like from FOLDER/ms_sss.glsl; with names, such as\n"
                            "  MS_SSS_STEP=7, prints one variant\n";
static char text[1 << 17];

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "sss_wgsl: %s: %s\n", what, why);
    return 1;
}

static char *read_text(const char *folder, const char *name)
{
    static char path[1000];
    const char *problem = NULL;
    size_t size = 0, got;
    char *all = (char *)calloc(1, 1 << 17);
    FILE *f;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    f = file_open(path, &problem);
    if (!f || !all) {
        fail(path, problem ? problem : "out of memory");
        exit(1);
    }
    while (size < (1 << 17) - 1 && (got = fread(all + size, 1, (1 << 17) - 1 - size, f)) > 0) size += got;
    fclose(f);
    return all;
}

int main(int argc, char **argv)
{
    static char defines[4000];
    const char *problem;
    char *shader, *pyramid, *disc;
    int i, step = 0;
    size_t n = 0;
    if (file_help(argc, argv, usage)) return file_end_stdout("sss_wgsl");
    if (argc < 2 || argv[1][0] == '-') return file_usage(usage);
    shader = read_text(argv[1], "ms_sss.glsl");
    pyramid = read_text(argv[1], "ms_sss_pyramid.glsl");
    disc = read_text(argv[1], "ms_sss_disc.glsl");
    for (i = 2; i < argc; ++i) {
        const char *equal = strchr(argv[i], '=');
        if (!equal || n + strlen(argv[i]) + 16 > sizeof defines) return fail(argv[i], "NAME=VALUE expected");
        n += (size_t)snprintf(defines + n, sizeof defines - n, "#define %.*s %s\n", (int)(equal - argv[i]), argv[i],
                              equal + 1);
        if (strncmp(argv[i], "MS_SSS_STEP=", 12) == 0) step = atoi(equal + 1);
    }
    if (argc > 2) {
        problem = wgsl_make(defines, shader,
                            step == 9                  ? disc
                                : step > 3 && step < 8 ? pyramid
                                                       : NULL,
                            text, sizeof text);
        if (problem) return fail(argv[1], problem);
        fputs(text, stdout);
    }
    for (i = 0; argc == 2 && i < 4; ++i) {
        char path[1000];
        problem = wgsl_usual_text(&wgsl_usual[i], shader, text, sizeof text);
        if (problem) return fail(wgsl_usual[i].file, problem);
        snprintf(path, sizeof path, "%s/%s", argv[1], wgsl_usual[i].file);
        problem = file_save(path, text, strlen(text));
        if (problem) return fail(path, problem);
    }
    free(shader);
    free(pyramid);
    free(disc);
    return file_end_stdout("sss_wgsl");
}
