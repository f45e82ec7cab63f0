/* Pictures of ms_sss.h and its peers against random walks through a bust, a knot and a thin bowl, of five materials,
   lit from three sides: tables in build/bench/sss_truth.md, everything in sss_truth.csv, time against error in
   sss_truth.svg, some pictures. The walks take a quarter of an hour on one core and are kept in build/truth.
   peer libraries: -lembree3 -lembree4 -lEGL */
#include "bench.h"
#if defined(HAVE_EMBREE3) || defined(HAVE_EMBREE4)
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "plot.h"
#include "render/truth.h"
#ifdef HAVE_EGL
#include "sss_passes.h"
#endif

enum { OBJECTS = 3, METHODS = 22, SHOWN = 10 };
static const char *const object_name[OBJECTS] = {"bust", "knot", "bowl"};
static const char *const substance_name[TRUTH_SUBSTANCES] = {"skin1", "marble", "cream", "ketchup", "skin2"};
static const char *const lamp_name[TRUTH_LAMPS] = {"front", "side", "behind"};
static const int walks[TRUTH_SUBSTANCES] = {256, 96, 32, 256,
                                            128}; /* noise under 1% of the error after halves are split */

typedef enum method_kind { UNFILTERED, SEPARABLE, PYRAMID, DISC, FOLLOWING, GATHER, MESH, HALVED } method_kind;

static const struct {
    const char *name;
    method_kind kind;
    ms_sss_model model;
    int taps, through, back; /* taps of a pyramid: exact */
    float flat;
    const char *texels; /* that the shader text reads a pixel, as make bench-gpu counts them; -: there is none */
} methods[METHODS] = {{"unfiltered", UNFILTERED, MS_SSS_SLICE, 0, 0, 0, 1, "1"},
                      {"model of the released shader, 17 taps", SEPARABLE, MS_SSS_SLICE, 17, 0, 0, 1, "68"},
                      {"the same, following the surface, tuned", FOLLOWING, MS_SSS_SLICE, 17, 0, 0, 1, "68"},
                      {"model of Unity HDRP, 20 samples, 8 frames", DISC, MS_SSS_SLICE, 20, 0, 0, 1, "42"},
                      {"separable, 7 taps, flat", SEPARABLE, MS_SSS_IMAGE_OPTIMAL, 7, 0, 0, 1, "27"},
                      {"**separable, 7 taps (default)**", SEPARABLE, MS_SSS_IMAGE_OPTIMAL, 7, 0, 0, 0, "35"},
                      {"the same and a shadow map", SEPARABLE, MS_SSS_IMAGE_OPTIMAL, 7, 1, 0, 0, "36"},
                      {"separable, 17 taps", SEPARABLE, MS_SSS_IMAGE_OPTIMAL, 17, 0, 0, 0, "75"},
                      {"separable, 33 taps", SEPARABLE, MS_SSS_IMAGE_OPTIMAL, 33, 0, 0, 0, "139"},
                      {"7 taps at half resolution", HALVED, MS_SSS_IMAGE_OPTIMAL, 7, 0, 0, 0, "23"},
                      {"17 taps at half resolution", HALVED, MS_SSS_IMAGE_OPTIMAL, 17, 0, 0, 0, "33"},
                      {"pyramid, flat", PYRAMID, MS_SSS_SLICE, 0, 0, 0, 1, "68"},
                      {"pyramid", PYRAMID, MS_SSS_SLICE, 0, 0, 0, 0, "68 or more"},
                      {"pyramid and a shadow map", PYRAMID, MS_SSS_SLICE, 0, 1, 0, 0, "69 or more"},
                      {"**pyramid, exact**", PYRAMID, MS_SSS_SLICE, 1, 0, 0, 0, "-"},
                      {"pyramid, exact, and a shadow map", PYRAMID, MS_SSS_SLICE, 1, 1, 0, 0, "-"},
                      {"2D in space, flat", GATHER, MS_SSS_SLICE, 0, 0, 0, 1, "-"},
                      {"2D in space", GATHER, MS_SSS_SLICE, 0, 0, 0, 0, "-"},
                      {"2D in space and a shadow map", GATHER, MS_SSS_SLICE, 0, 1, 0, 0, "-"},
                      {"2D in space, front and back", GATHER, MS_SSS_SLICE, 0, 0, 1, 0, "-"},
                      {"whole mesh, without elevation", MESH, MS_SSS_SLICE, 0, 0, 0, 1, "-"},
                      {"whole mesh", MESH, MS_SSS_SLICE, 0, 0, 0, 0, "-"}};

/* Columns of the first table; the whole mesh is tried on these alone. */
static const int shown[SHOWN][3] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 2},
                                    {2, 0, 0}, {2, 1, 2}, {0, 3, 0}, {0, 4, 0}, {1, 4, 0}};

static truth_report report[OBJECTS][TRUTH_SUBSTANCES][TRUTH_LAMPS][METHODS];
static double nanoseconds[METHODS]; /* a pixel of the object, bust of skin */

static int is_shown(int object, int substance, int lamp)
{
    int i;
    for (i = 0; i < SHOWN; ++i)
        if (shown[i][0] == object && shown[i][1] == substance && shown[i][2] == lamp) return 1;
    return 0;
}

/* By the shader, for the CPU has no half resolution; times reflectance. */
static ms_status at_half(const truth *t, const ms_sss_kernel *kernel, image *out)
{
#ifdef HAVE_EGL
    const int count = t->width * t->height;
    ms_sss_frame frame;
    ms_sss_filter_options options = truth_frame(t, &frame, out);
    float *light = (float *)calloc((size_t)count, 8 * sizeof *light);
    int i, c, good = light != NULL;
    for (i = 0; i < count && good; ++i)
        for (c = 0; c < 3; ++c) light[4 * i + c] = t->lit->irradiance.pixels[3 * i + c];
    good = good &&
        sss_passes(light, t->layers.depth.pixels, t->width, t->height, kernel, &options, 1, light + 4 * count);
    for (i = 0; i < count && good; ++i)
        for (c = 0; c < 3; ++c) out->pixels[3 * i + c] = light[4 * count + 4 * i + c];
    free(light);
    truth_reflect(t, out);
    return good ? MS_OK : MS_UNSUPPORTED;
#else
    (void)t, (void)kernel, (void)out;
    return MS_UNSUPPORTED;
#endif
}

static int has_half; /* OpenGL 3.3 */

static ms_status picture_of(const truth *t, int m, const ms_sss_kernel *kernel, const ms_sss_pyramid *pyramid,
                            image *out)
{
    ms_status status = MS_OK;
    switch (methods[m].kind) {
    case UNFILTERED: memcpy(out->pixels, t->lit->unfiltered.pixels, image_count(out) * sizeof(float)); break;
    case SEPARABLE:
        status = truth_filter(t, kernel, methods[m].flat > 0 ? TRUTH_SIGMA : 0, methods[m].flat, out);
        break;
    case PYRAMID: status = truth_pyramid(t, pyramid, methods[m].flat, methods[m].taps, out); break;
    case DISC: truth_disc(t, methods[m].taps, 8, out); break;
    case FOLLOWING: truth_following(t, kernel, 1.5, 1.5, out); break; /* the best of 5 x 6 on bust and marble */
    case GATHER: status = truth_gather(t, methods[m].back, methods[m].flat, out); break;
    case HALVED: status = at_half(t, kernel, out); break;
    case MESH: truth_mesh(t, !(methods[m].flat > 0), out); break;
    }
    if (methods[m].through) truth_through(t, kernel, out);
    return status;
}

/* All methods and lamps of one object and material. */
static int measure(int object, int substance, FILE *csv)
{
    static ms_sss_kernel kernel[METHODS];
    static ms_sss_pyramid pyramid;
    char path[200];
    const char *problem;
    ms_sss_designer *designer;
    image picture;
    truth t;
    int m, lamp;
    snprintf(path, sizeof path, "build/truth/%s_%s_%d.bin", object_name[object], substance_name[substance],
             walks[substance]);
    if (!truth_make(&t, (scene_object)object, (truth_substance)substance, 240, 135, walks[substance], 0, path,
                    &problem)) {
        fprintf(stderr, "%s\n", problem);
        return 0;
    }
    picture = image_new(t.width, t.height, 3);
    if (picture.pixels == NULL || ms_sss_designer_create(&designer, t.profile, t.radius_px, NULL, NULL) != MS_OK ||
        ms_sss_pyramid_make(&pyramid, t.profile, NULL) != MS_OK)
        return 0;
    for (m = 0; m < METHODS; ++m) {
        const int sampled = methods[m].kind == SEPARABLE || methods[m].kind == FOLLOWING || methods[m].kind == HALVED;
        ms_sss_kernel_options o = ms_sss_kernel_defaults();
        o.model = sampled ? methods[m].model : MS_SSS_IMAGE_OPTIMAL;
        o.tap_count = sampled ? methods[m].taps : 7;
        if (o.model == MS_SSS_SLICE) o.placement = MS_SSS_QUADRATIC;
        if (ms_sss_kernel_build(&kernel[m], designer, &o, NULL) != MS_OK) return 0;
    }
    for (lamp = 0; lamp < TRUTH_LAMPS; ++lamp) {
        signed char *region;
        truth_light(&t, lamp);
        region = truth_regions(&t);
        for (m = 0; m < METHODS; ++m) {
            truth_report *r = &report[object][substance][lamp][m];
            double start;
            int round;
            if (methods[m].kind == MESH && !is_shown(object, substance, lamp)) continue;
            if (methods[m].kind == HALVED && !has_half) continue;
            for (round = 0; round <
                 (methods[m].kind < DISC && object == SCENE_BUST && substance == TRUTH_SKIN && lamp == 0 ? 9 : 1);
                 ++round) {
                double taken;
                start = bench_cpu();
                if (picture_of(&t, m, &kernel[m], &pyramid, &picture) != MS_OK) return 0;
                taken = 1e9 * (bench_cpu() - start) / t.pixels;
                if (object == SCENE_BUST && substance == TRUTH_SKIN && lamp == 0 &&
                    (round == 0 || taken < nanoseconds[m]))
                    nanoseconds[m] = taken;
            }
            *r = truth_judge(&t, region, &picture);
            fprintf(csv, "%s,%s,%s,\"%s\",%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", object_name[object],
                    substance_name[substance], lamp_name[lamp], methods[m].name, r->relative, r->scaled, r->lost[0],
                    r->lost[1], r->lost[2], r->share[0], r->share[1], r->share[2], r->share[3]);
            if (is_shown(object, substance, lamp)) {
                snprintf(path, sizeof path, "build/bench/sss_truth_%s_%s_%s_%d.png", object_name[object],
                         substance_name[substance], lamp_name[lamp], m);
                truth_save(&t, &picture, path);
            }
        }
        free(region);
    }
    printf("%s of %s: R %.2f %.2f %.2f, 99%% radius %.0f px\n", object_name[object], substance_name[substance],
           t.reflectance[0], t.reflectance[1], t.reflectance[2], t.radius_px);
    fflush(stdout);
    ms_sss_designer_destroy(designer);
    image_free(&picture);
    truth_free(&t);
    return 1;
}

/* Time against error on the bust of skin, lit from the front: a point for each method, lines through more taps. */
static int draw(void)
{
    static const struct {
        const char *name;
        int first, count, style;
    } series[] = {{"unfiltered", 0, 1, PLOT_DOTS},
                  {"model of the released", 1, 1, PLOT_DOTS},
                  {"7 taps, flat", 4, 1, PLOT_DOTS},
                  {"7, 17, 33 taps", 4, 0, PLOT_LINE | PLOT_DOTS},
                  {"pyramid: flat, default", 11, 2, PLOT_LINE | PLOT_DOTS},
                  {"pyramid, exact", 14, 1, PLOT_DOTS},
                  {"2D in space: flat, not", 16, 2, PLOT_LINE | PLOT_DOTS},
                  {"front and back", 19, 1, PLOT_DOTS},
                  {"whole mesh", 21, 1, PLOT_DOTS}};
    static const int taps[3] = {5, 7, 8};
    static double x[METHODS], y[METHODS], along[2][3];
    plot p;
    int i, m;
    for (m = 0; m < METHODS; ++m) {
        x[m] = nanoseconds[m];
        y[m] = 100 * report[0][0][0][m].relative;
    }
    plot_begin(&p, "Bust of skin, lit from the front: the nearer to the corner, the better", "ns a pixel",
               "% from the random walk", PLOT_LOG_X);
    for (i = 0; i < 3; ++i) {
        along[0][i] = x[taps[i]];
        along[1][i] = y[taps[i]];
    }
    for (i = 0; i < (int)(sizeof series / sizeof series[0]); ++i) {
        if (series[i].count)
            plot_series(&p, series[i].name, x + series[i].first, y + series[i].first, series[i].count, series[i].style);
        else plot_series(&p, series[i].name, along[0], along[1], 3, series[i].style);
    }
    return plot_write(&p, "build/bench/sss_truth.svg");
}

int main(void)
{
    FILE *md = bench_open("sss_truth.md"), *csv = bench_open("sss_truth.csv");
    int object, substance, lamp, m, i;
    mkdir("build/truth", 0777);
#ifdef HAVE_EGL
    has_half = gl_open(GL_API_33);
#endif
    fprintf(
        csv,
        "object,material,lamp,method,error,error_after_scale,lost_red,lost_green,lost_blue,at_outlines,at_shadow_borders,in_the_dark,elsewhere\n");
    for (substance = 0; substance < TRUTH_SUBSTANCES; ++substance)
        for (object = 0; object < OBJECTS; ++object)
            if (!measure(object, substance, csv)) return 1;
    fprintf(
        md,
        "Random walks through index-matched bodies, 240 x 135 pixels, 2 x %d to 2 x %d walks a pixel and channel. Error: root mean\n"
        "square over that of the truth, on the object's pixels, %%, the truth's noise taken out by its two halves. Normals from depth. A\n"
        "shadow map: ms_sss_transmission by max. Texels: that the shaders read a pixel, all passes (make bench-gpu). Time: ns a pixel of the object,\n"
        "one core of %s, bust of skin, with what a call costs beside pixels.\n\n| method |",
        walks[TRUTH_CREAM], walks[TRUTH_SKIN], bench_processor());
    for (i = 0; i < SHOWN; ++i)
        fprintf(md, " %s, %s, %s |", object_name[shown[i][0]], substance_name[shown[i][1]], lamp_name[shown[i][2]]);
    fprintf(md, " texels | ns |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 0; m < METHODS; ++m) {
        if (methods[m].kind == HALVED && !has_half) continue;
        fprintf(md, "| %s |", methods[m].name);
        for (i = 0; i < SHOWN; ++i)
            fprintf(md, " %.1f |", 100 * report[shown[i][0]][shown[i][1]][shown[i][2]][m].relative);
        fprintf(md, " %s |", methods[m].texels);
        if (methods[m].kind == DISC || methods[m].kind == FOLLOWING || methods[m].kind == HALVED)
            fprintf(md, " - |\n"); /* plain loops, OpenGL */
        else fprintf(md, " %.0f |\n", nanoseconds[m]);
    }
    fprintf(
        md,
        "\nBust of skin, lit from the front: error after the best factor a channel, light lost (red, green, blue), and where the squared\nerror is: "
        "within 2 pixels of outlines, near a shadow's border, in the dark, elsewhere; %%.\n\n"
        "| method | error | after scale | lost | outlines | borders | dark | elsewhere |\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 0; m < METHODS; ++m) {
        const truth_report *r = &report[0][0][0][m];
        if (methods[m].kind == HALVED && !has_half) continue;
        fprintf(md, "| %s | %.1f | %.1f | %.0f, %.0f, %.0f | %.0f | %.0f | %.0f | %.0f |\n", methods[m].name,
                100 * r->relative, 100 * r->scaled, 100 * r->lost[0], 100 * r->lost[1], 100 * r->lost[2],
                100 * r->share[0], 100 * r->share[1], 100 * r->share[2], 100 * r->share[3]);
    }
    fprintf(
        md,
        "\nRoot mean square over the objects and lamps of a material, over the objects and materials of a lamp, over all 45:\n\n| method |");
    for (substance = 0; substance < TRUTH_SUBSTANCES; ++substance) fprintf(md, " %s |", substance_name[substance]);
    for (lamp = 0; lamp < TRUTH_LAMPS; ++lamp) fprintf(md, " %s |", lamp_name[lamp]);
    fprintf(md, " all |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 0; m < METHODS; ++m) {
        double by_substance[TRUTH_SUBSTANCES] = {0, 0, 0, 0, 0}, by_lamp[TRUTH_LAMPS] = {0, 0, 0}, all = 0;
        if (methods[m].kind == MESH || (methods[m].kind == HALVED && !has_half)) continue;
        for (object = 0; object < OBJECTS; ++object)
            for (substance = 0; substance < TRUTH_SUBSTANCES; ++substance)
                for (lamp = 0; lamp < TRUTH_LAMPS; ++lamp) {
                    double e = report[object][substance][lamp][m].relative;
                    by_substance[substance] += e * e / (OBJECTS * TRUTH_LAMPS);
                    by_lamp[lamp] += e * e / (OBJECTS * TRUTH_SUBSTANCES);
                    all += e * e / (OBJECTS * TRUTH_SUBSTANCES * TRUTH_LAMPS);
                }
        fprintf(md, "| %s |", methods[m].name);
        for (substance = 0; substance < TRUTH_SUBSTANCES; ++substance)
            fprintf(md, " %.1f |", 100 * sqrt(by_substance[substance]));
        for (lamp = 0; lamp < TRUTH_LAMPS; ++lamp) fprintf(md, " %.1f |", 100 * sqrt(by_lamp[lamp]));
        fprintf(md, " %.1f |\n", 100 * sqrt(all));
    }
    return ((fclose(md) | fclose(csv)) != 0) | !draw();
}
#else
int main(void)
{
    puts("bench_sss_truth: Embree is not installed (make deps); skipped");
    return 0;
}
#endif
