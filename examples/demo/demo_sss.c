/* From optical parameters to pictures: build/demo_sss FOLDER [--width 1920] [--method pyramid] writes
     skin1_before.png, _after, and skin1.png with half of each; the same for marble; demo.png with both
     bust.png, knot.png                    without, 7 taps, gathered in space, path-traced (random walks,
                                           examples/data/truth_*.bin), and the difference of the taps from that
     skins.png                             six heads made of melanin and blood
     profiles_red.svg, _green, _blue       diffusion profiles of four materials
     model_*.png, models.html              a dot, a disk and a step through every kernel model, and exactly
     sss.txt                               what made each picture: "name: panel | panel"
   Alone: cc -O2 -I. examples/demo/demo_sss.c -o build/demo_sss -lm */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "../tools/gather.h"
#include "../tools/profile_csv.h"
#include "../tools/layered.h"
#include "../tools/skin.h"
#include "plot.h"
#include "scene.h"
#include <time.h>

static const char usage[] = "usage: demo_sss FOLDER [--width 64..7680] [--method taps|pyramid]\n";
static const char *folder;
static file_out out_page, out_truth; /* models.html and sss.txt while they are written */
static const char *const methods[] = {"taps", "pyramid"};
static int by_pyramid; /* skin1 and marble: not by the default of 7 taps */

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

static const char *file(const char *name)
{
    static char path[1000];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* Ends the program with a message unless problem is NULL. Files that are not complete are discarded. */
static void need(const char *problem, const char *where)
{
    if (problem == NULL) return;
    fprintf(stderr, "demo_sss: %s: %s\n", where, problem);
    if (out_page.f) file_finish(&out_page, 0);
    if (out_truth.f) file_finish(&out_truth, 0);
    exit(1);
}

static void need_ok(ms_status status, const char *where)
{
    need(status == MS_OK ? NULL : ms_status_string(status), where);
}

static void save(const image *im, const char *name)
{
    need(image_write(file(name), im), file(name));
    printf("%s\n", file(name));
}

/* --- profiles --- */

static ms_mcml_profile material_rings(const ms_mcml_material *material)
{
    ms_mcml_medium medium[3];
    ms_mcml_profile rings;
    int c;
    for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(material, c);
    need_ok(ms_mcml_profile_make(&rings, medium, 3, NULL, NULL), material->name);
    return rings;
}

static ms_sss_profile *material_profile(const char *name)
{
    ms_mcml_profile rings = material_rings(ms_mcml_find_material(name));
    ms_sss_profile *profile;
    const double *rd[3];
    int c;
    for (c = 0; c < 3; ++c) rd[c] = rings.rd_per_mm2 + c * rings.rings;
    need_ok(ms_sss_profile_from_rings(&profile, rings.rings, rings.edge_mm, rd, 1, NULL, NULL), name);
    ms_mcml_profile_destroy(&rings);
    return profile;
}

/* The scattering of four materials, channel by channel. */
static void plot_profiles(FILE *lines)
{
    enum { SHOWN = 4 };
    static const char *const channel_name[3] = {"red", "green", "blue"},
                             *const shown[SHOWN] = {"wholemilk", "marble", "skin1", "ketchup"};
    static plot p;
    ms_mcml_profile rings[SHOWN];
    double *r[SHOWN], time = seconds();
    int i, k, c;
    for (i = 0; i < SHOWN; ++i) rings[i] = material_rings(ms_mcml_find_material(shown[i]));
    fprintf(lines, "profiles: ms_mcml_profile_make, %.1f ms a material\n", 1e3 * (seconds() - time) / (double)SHOWN);
    for (i = 0; i < SHOWN; ++i) {
        r[i] = (double *)malloc((size_t)rings[i].rings * sizeof **r);
        if (r[i] == NULL) need("out of memory", "profiles");
        for (k = 0; k < rings[i].rings; ++k) r[i][k] = 0.5 * (rings[i].edge_mm[k] + rings[i].edge_mm[k + 1]);
    }
    for (c = 0; c < 3; ++c) {
        char title[64], name[64];
        snprintf(title, sizeof title, "Diffusion profiles, %s", channel_name[c]);
        snprintf(name, sizeof name, "profiles_%s.svg", channel_name[c]);
        plot_begin(&p, title, "distance from where light enters (mm)", "reflectance (1/mm\xc2\xb2)",
                   PLOT_LOG_X | PLOT_LOG_Y | PLOT_LEGEND_INSIDE);
        p.width = 400;
        p.height = 340;
        plot_range(&p, 0.02, 50, 1e-8, 10);
        for (i = 0; i < SHOWN; ++i)
            plot_series(&p, shown[i], r[i], rings[i].rd_per_mm2 + c * rings[i].rings, rings[i].rings, PLOT_LINE);
        need(plot_write(&p, file(name)) ? NULL : "cannot write", file(name));
        printf("%s\n", file(name));
    }
    for (i = 0; i < SHOWN; ++i) {
        free(r[i]);
        ms_mcml_profile_destroy(&rings[i]);
    }
}

/* --- the two objects --- */

static double radius_of(const ms_sss_profile *profile)
{
    double r[3];
    ms_sss_profile_radius(profile, 0.99, r);
    return r[0] > r[1] ? (r[0] > r[2] ? r[0] : r[2]) : r[1] > r[2] ? r[1] : r[2];
}

/* Two pictures of one size beside each other, with a white line of `line` pixels between. */
static image side_by_side(const image *a, const image *b, int line)
{
    image out = image_new(2 * a->width, a->height, 3);
    size_t row = 3 * (size_t)a->width, y, i;
    if (out.pixels == NULL) need("out of memory", "side by side");
    for (y = 0; y < (size_t)a->height; ++y) {
        memcpy(out.pixels + 2 * y * row, a->pixels + y * row, row * sizeof(float));
        memcpy(out.pixels + (2 * y + 1) * row, b->pixels + y * row, row * sizeof(float));
        for (i = 0; i < 3 * (size_t)line; ++i) out.pixels[(2 * y + 1) * row - 3 * (size_t)(line / 2) + i] = 1;
    }
    return out;
}

/* Writes the object's three pictures and the line that says what made them; returns the one with both halves. */
static image show_object(scene_object object, const char *material, int width, FILE *lines)
{
    ms_sss_profile *profile = material_profile(material);
    static ms_sss_kernel kernel;
    static ms_sss_pyramid pyramid;
    ms_sss_frame frame;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    scene s;
    image filtered, before, after, both;
    double reflectance[3], distance_mm, time = 0;
    float color[3];
    size_t size, i, pixels = 0; /* of the object */
    void *workspace;
    char name[64];
    int c, run, height = width * 9 / 16;

    width /= 2; /* as wide as half a picture */

    ms_sss_profile_reflectance(profile, reflectance);
    for (c = 0; c < 3; ++c) color[c] = (float)reflectance[c];
    need(scene_render(&s, object, width, height, color), "scene");

    distance_mm = (double)scene_length(s.camera.eye);
    need_ok(ms_sss_kernel_make(&kernel, NULL, profile,
                               radius_of(profile) * height / (2 * (double)s.camera.tan_half_fov * distance_mm), NULL,
                               NULL, NULL),
            "kernel"); /* 7 taps: the default */
    filtered = image_new(width, height, 3);
    memset(&frame, 0, sizeof frame);
    frame.width = width;
    frame.height = height;
    frame.input = ms_sss_interleaved(s.irradiance.pixels, 3);
    frame.output = ms_sss_interleaved(filtered.pixels, 3);
    frame.depth = ms_sss_map(s.depth.pixels, 1);
    frame.strength = ms_sss_map(s.mask.pixels, 1);
    options.fov_degrees = 2 * atanf(s.camera.tan_half_fov) * (180 / 3.14159265f);
    need_ok(ms_sss_pyramid_make(&pyramid, profile, NULL), "pyramid");
    size = by_pyramid ? ms_sss_pyramid_workspace(width, height)
                      : ms_sss_filter_workspace(width, height, &kernel, 1, &options);
    workspace = malloc(size);
    if (filtered.pixels == NULL || workspace == NULL) need("out of memory", "filter");
    for (run = 0; run < 3; ++run) { /* the first touches the memory, the last is timed */
        time = seconds();
        need_ok(by_pyramid ? ms_sss_pyramid_filter(&frame, &pyramid, 1, &options, workspace, size, NULL)
                           : ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL),
                "filter");
        time = seconds() - time;
    }
    for (i = 0; i < image_count(&s.mask); ++i) pixels += s.mask.pixels[i] > 0;

    need(scene_compose(&s, &s.irradiance, &before), "picture");
    need(scene_compose(&s, &filtered, &after), "picture");
    both = side_by_side(&before, &after, 2);
    snprintf(name, sizeof name, "%s_before.png", material);
    save(&before, name);
    snprintf(name, sizeof name, "%s_after.png", material);
    save(&after, name);
    snprintf(name, sizeof name, "%s.png", material);
    save(&both, name);
    fprintf(lines, "%s: without | %s: %.1f ms for %d x %d, %.0f ns a pixel of the object\n", name,
            by_pyramid ? "ms_sss_pyramid_filter" : "ms_sss_filter, 7 taps a pass", 1e3 * time, width, height,
            1e9 * time / (double)(pixels ? pixels : 1));

    free(workspace);
    image_free(&before);
    image_free(&after);
    image_free(&filtered);
    scene_free(&s);
    ms_sss_profile_destroy(profile);
    return both;
}

/* --- skin from what it is made of --- */

/* One head, lit once, in six skins: melanin, of which red, and blood from pale to dark. */
static void show_skins(int height, FILE *lines)
{
    static const double made[6][3] = {{0.004, 0.4, 0.03}, {0.02, 0.7, 0.04}, {0.05, 0.8, 0.035},
                                      {0.1, 0.9, 0.03},   {0.2, 1, 0.04},    {0.4, 1, 0.03}};
    static const float gray[3] = {0.5f, 0.5f, 0.5f};
    static ms_sss_kernel kernel;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_mcml_profile_options coarse;
    ms_sss_frame frame;
    scene s;
    image row, filtered, face, albedo;
    double time = 0, began;
    int width = height * 16 / 9, shown = height * 5 / 6, k, x, y, c;
    memset(&coarse, 0, sizeof coarse);
    coarse.depth_step = 0.4; /* half the time; the errors are far below a level of 255 */
    coarse.frequency_step = 0.3;
    need(scene_render(&s, SCENE_BUST, width, height, gray), "scene");
    row = image_new(6 * shown, height, 3);
    filtered = image_new(width, height, 3);
    albedo = image_new(width, height, 3);
    if (row.pixels == NULL || filtered.pixels == NULL || albedo.pixels == NULL) need("out of memory", "skins");
    memcpy(albedo.pixels, s.albedo.pixels, image_count(&albedo) * sizeof(float));
    for (k = 0; k < 6; ++k) {
        skin_parameters skin = skin_defaults();
        ms_mcml_profile made_rings;
        ms_sss_profile *profile;
        const double *rd[3];
        size_t size, i;
        void *workspace;
        double reflectance[3];
        skin.melanin = made[k][0];
        skin.eumelanin = made[k][1];
        skin.blood = made[k][2];
        began = seconds();
        need_ok(skin_profile(&made_rings, &skin, &coarse, NULL), "skin");
        time += seconds() - began;
        for (c = 0; c < 3; ++c) rd[c] = made_rings.rd_per_mm2 + c * made_rings.rings;
        need_ok(ms_sss_profile_from_rings(&profile, made_rings.rings, made_rings.edge_mm, rd, 1, NULL, NULL), "skin");
        for (c = 0; c < 3; ++c) reflectance[c] = made_rings.total[c];
        ms_mcml_profile_destroy(&made_rings);
        need_ok(ms_sss_kernel_make(&kernel, NULL, profile,
                                   radius_of(profile) * height /
                                       (2 * (double)s.camera.tan_half_fov * (double)scene_length(s.camera.eye)),
                                   NULL, NULL, NULL),
                "kernel");
        ms_sss_profile_destroy(profile);
        memset(&frame, 0, sizeof frame);
        frame.width = width;
        frame.height = height;
        frame.input = ms_sss_interleaved(s.irradiance.pixels, 3);
        frame.output = ms_sss_interleaved(filtered.pixels, 3);
        frame.depth = ms_sss_map(s.depth.pixels, 1);
        frame.strength = ms_sss_map(s.mask.pixels, 1);
        options.fov_degrees = 2 * atanf(s.camera.tan_half_fov) * (180 / 3.14159265f);
        size = ms_sss_filter_workspace(width, height, &kernel, 1, &options);
        workspace = malloc(size);
        if (workspace == NULL) need("out of memory", "skins");
        need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), "filter");
        free(workspace);
        for (i = 0; i < image_count(&albedo); ++i)
            s.albedo.pixels[i] = albedo.pixels[i] *
                (s.mask.pixels[i / 3] > 0 ? (float)reflectance[i % 3] / gray[0] : 1);
        need(scene_compose(&s, &filtered, &face), "picture");
        for (y = 0; y < height; ++y)
            for (x = 0; x < shown; ++x)
                for (c = 0; c < 3; ++c)
                    row.pixels[3 * ((size_t)y * (size_t)row.width + (size_t)(k * shown + x)) + (size_t)c] =
                        face.pixels[3 * ((size_t)y * (size_t)width + (size_t)(x + (width - shown) / 2)) + (size_t)c];
        image_free(&face);
    }
    save(&row, "skins.png");
    fprintf(lines, "skins: profiles by ms_mcml_profile_layers, %.0f ms a skin; ms_sss_filter, 7 taps\n",
            1e3 * time / 6);
    image_free(&row);
    image_free(&filtered);
    image_free(&albedo);
    scene_free(&s);
}

/* --- against the truth --- */

enum { PANELS = 5 };

typedef struct truth {
    int width, height;
    float fov, mm_per_unit;
    image depth, light, walk; /* in; what the walk shows */
    ms_sss_profile *profile;
    double reflectance[3];
} truth;

/* A file of tests/render/truth_data.c, which says how it is laid out, and a profile. 0: there is none. */
static int truth_read(truth *t, const char *path, const char *profile)
{
    image__bytes data, csv;
    size_t at = 0, pixel, count;
    int n = 0, c;
    memset(t, 0, sizeof *t);
    memset(&data, 0, sizeof data);
    memset(&csv, 0, sizeof csv);
    if (image__load(path, &data) != NULL || image__load(profile, &csv) != NULL) return 0;
    while (at < data.size && at < 200 && data.data[at] != '\n') ++at;
    if (at == data.size ||
        sscanf((const char *)data.data, "ms_truth %d %d %f %f%n", &t->width, &t->height, &t->fov, &t->mm_per_unit,
               &n) != 4 ||
        (size_t)n != at || t->width < 1 || t->height < 1 || t->width > 4096 || t->height > 4096)
        need("not a file of truth_data.sh", path);
    count = (size_t)t->width * (size_t)t->height;
    if (data.size != ++at + 16 * count) need("cut off", path);
    t->depth = image_new(t->width, t->height, 1);
    t->light = image_new(t->width, t->height, 3);
    t->walk = image_new(t->width, t->height, 3);
    if (!t->depth.pixels || !t->light.pixels || !t->walk.pixels) need("out of memory", path);
    memcpy(t->depth.pixels, data.data + at, 4 * count);
    for (pixel = 0; pixel < count; ++pixel)
        for (c = 0; c < 6; ++c) { /* binary16, never negative, infinite or NaN */
            const unsigned char *half = data.data + at + 4 * count + 12 * pixel + 2 * (size_t)c;
            int bits = half[0] | half[1] << 8, exponent = bits >> 10 & 31, fraction = bits & 1023;
            float value = ldexpf((float)(exponent ? fraction | 1024 : fraction), exponent ? exponent - 25 : -24);
            (c < 3 ? &t->light : &t->walk)->pixels[3 * pixel + (size_t)(c % 3)] = value;
        }
    need_ok(profile_from_csv(&t->profile, (const char *)csv.data, csv.size, NULL), profile);
    ms_sss_profile_reflectance(t->profile, t->reflectance);
    free(data.data);
    free(csv.data);
    return 1;
}

/* Root mean square of the difference from the walk over that of the walk; out holds filtered light, before
   reflectance. */
static double truth_error(const truth *t, const image *out)
{
    double error = 0, power = 0;
    size_t i;
    for (i = 0; i < image_count(out); ++i)
        if (t->depth.pixels[i / 3] > 0) {
            double walk = (double)t->walk.pixels[i], d = t->reflectance[i % 3] * (double)out->pixels[i] - walk;
            error += d * d;
            power += walk * walk;
        }
    return sqrt(error / power);
}

/* Without, 7 taps, gathered in space, path-traced, and the difference of the taps from that; the line that says so. */
static void show_truth(const char *object, const char *substance, FILE *lines)
{
    char path[100], csv[100], name[32];
    ms_sss_filter_options options = ms_sss_filter_defaults();
    static ms_sss_kernel kernel;
    ms_sss_frame frame;
    truth t;
    image taps, after, out;
    double radius, before, error[2], time[2] = {0, 0}, distance = 1e9; /* of the nearest pixel */
    float peak = 0;
    size_t size, i, pixels = 0;
    void *workspace;
    int x, y, c, k, left, right = 0, width; /* columns that show the object, and some beside it */
    snprintf(path, sizeof path, "examples/data/truth_%s.bin", object);
    snprintf(csv, sizeof csv, "examples/data/truth_%s.csv", substance);
    if (!truth_read(&t, path, csv)) {
        fprintf(stderr, "demo_sss: %s: not found (run in the repository's folder); no picture against the truth\n",
                path);
        return;
    }
    for (left = t.width, i = 0; i < image_count(&t.depth); ++i)
        if (t.depth.pixels[i] > 0) {
            x = (int)(i % (size_t)t.width);
            left = x < left ? x : left;
            right = x > right ? x : right;
        }
    left = left > 8 ? left - 8 : 0;
    width = (right + 9 < t.width ? right + 9 : t.width) - left;
    if (width < 1) need("shows nothing", path);
    options.fov_degrees = t.fov;
    options.mm_per_unit = t.mm_per_unit;
    taps = image_new(t.width, t.height, 3);
    after = image_new(t.width, t.height, 3);
    out = image_new(PANELS * width, t.height, 3);
    for (i = 0; i < image_count(&t.depth); ++i)
        if (t.depth.pixels[i] > 0) {
            ++pixels;
            distance = (double)t.depth.pixels[i] < distance ? (double)t.depth.pixels[i] : distance;
        }
    radius = radius_of(t.profile) / (double)t.mm_per_unit * t.height /
        (2 * tan((double)t.fov * 3.14159265358979 / 360) * distance);
    need_ok(ms_sss_kernel_make(&kernel, NULL, t.profile, radius, NULL, NULL, NULL), "kernel");
    size = ms_sss_filter_workspace(t.width, t.height, &kernel, 1, &options);
    workspace = malloc(size);
    if (!taps.pixels || !after.pixels || !out.pixels || !workspace) need("out of memory", object);
    memset(&frame, 0, sizeof frame);
    frame.width = t.width;
    frame.height = t.height;
    frame.input = ms_sss_interleaved(t.light.pixels, 3);
    frame.depth = ms_sss_map(t.depth.pixels, 1);
    frame.output = ms_sss_interleaved(taps.pixels, 3);
    for (k = 0; k < 8; ++k) { /* the first touches the memory, seven are timed */
        if (k == 1) time[0] = seconds();
        need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), "filter");
    }
    time[0] = (seconds() - time[0]) / 7;
    frame.output = ms_sss_interleaved(after.pixels, 3);
    time[1] = seconds();
    need_ok(gather_filter(&frame, NULL, t.profile, &options, NULL), "gather");
    time[1] = seconds() - time[1];
    before = truth_error(&t, &t.light);
    error[0] = truth_error(&t, &taps);
    error[1] = truth_error(&t, &after);
    for (i = 0; i < image_count(&t.light); ++i) {
        float v = t.light.pixels[i] * (float)t.reflectance[i % 3];
        if (v > peak) peak = v;
    }
    for (y = 0; y < t.height; ++y)
        for (x = 0; x < width; ++x)
            for (c = 0; c < 3; ++c) {
                size_t at = 3 * ((size_t)y * (size_t)t.width + (size_t)(x + left)) + (size_t)c;
                float shown[4], R = (float)t.reflectance[c];
                shown[0] = R * t.light.pixels[at];
                shown[1] = R * taps.pixels[at];
                shown[2] = R * after.pixels[at];
                shown[3] = t.walk.pixels[at];
                for (k = 0; k < PANELS; ++k) {
                    float *to = out.pixels + 3 * ((size_t)y * (size_t)out.width + (size_t)(k * width + x)) + c;
                    if (k < 4) to[0] = shown[k] = image_srgb_encode(scene_tone(shown[k] * 1.2f / peak));
                    else
                        to[0] = t.depth.pixels[at / 3] > 0 ? scene__clamp(0.5f + 4 * (shown[1] - shown[3]), 0, 1)
                                                           : 0.5f;
                }
            }
    snprintf(name, sizeof name, "%s.png", object);
    save(&out, name);
    fprintf(lines,
            "%s: without: %.1f%% | ms_sss_filter, 7 taps: %.1f%%, %.0f ns a pixel | gather.h: %.1f%%, %.0f ns | "
            "path-traced | "
            "4 \xc3\x97 (7 taps - path-traced)\n",
            name, 100 * before, 100 * error[0], 1e9 * time[0] / (double)pixels, 100 * error[1],
            1e9 * time[1] / (double)pixels);
    free(workspace);
    image_free(&taps);
    image_free(&after);
    image_free(&out);
    image_free(&t.depth);
    image_free(&t.light);
    image_free(&t.walk);
    ms_sss_profile_destroy(t.profile);
}

/* --- kernel models: a dot, a disk and a step (thesis, figures 5.7 and 5.13) --- */

#define SIGNALS 3
#define FIELD 288 /* pixels of the filtered signals; the middle SHOWN of them are shown */
#define SHOWN 192
#define RADII 144
#define RADIUS_PX 48 /* of 99% of the energy */
#define DOT_PX 3
#define DISK_PX 48

static const struct {
    const char *name;
    ms_sss_model model;
    int terms, taps;
    double guide_k;
} models[] = {{"R_d along the axis, as in the released shader", MS_SSS_SLICE, 1, MS_SSS_DENSE, 0},
              {"one Gaussian", MS_SSS_GAUSSIANS, 1, MS_SSS_DENSE, 0},
              {"three Gaussians", MS_SSS_GAUSSIANS, 3, MS_SSS_DENSE, 0},
              {"six Gaussians", MS_SSS_GAUSSIANS, 6, MS_SSS_DENSE, 0},
              {"SVD, rank 1, normalized", MS_SSS_SVD_NORMALIZED, 1, MS_SSS_DENSE, 0},
              {"SVD, rank 2, normalized", MS_SSS_SVD_NORMALIZED, 2, MS_SSS_DENSE, 0},
              {"SVD, rank 3, normalized", MS_SSS_SVD_NORMALIZED, 3, MS_SSS_DENSE, 0},
              {"SVD, rank 3, not normalized", MS_SSS_SVD, 3, MS_SSS_DENSE, 0},
              {"guided, k = 0", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 0},
              {"guided, k = 2", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 2},
              {"guided, k = 4", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 4},
              {"artist, fitted", MS_SSS_ARTIST, 1, MS_SSS_DENSE, 0},
              {"pre-integrated", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0},
              {"pre-integrated, 7 taps", MS_SSS_PREINTEGRATED, 1, 7, 0},
              {"pre-integrated + 1 residual", MS_SSS_RESIDUAL, 2, MS_SSS_DENSE, 0},
              {"image-optimal, 33 taps", MS_SSS_IMAGE_OPTIMAL, 1, 33, 0},
              {"image-optimal, 7 taps", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0}};

enum { MODELS = sizeof models / sizeof models[0] };

/* White light on black: inside a circle of radius_px, or left of the middle where that is 0. */
static float signal_at(int radius_px, double x, double y)
{
    double edge = radius_px ? radius_px - sqrt(x * x + y * y) : -x;
    return (float)(edge > 0.5 ? 1 : edge < -0.5 ? 0 : edge + 0.5);
}

static int signal_radius(int signal) { return signal == 0 ? DOT_PX : signal == 1 ? DISK_PX : 0; }

/* The three signals beside each other; the dot is raised by `gain`. */
static void save_row(const image *rows, const double gain[SIGNALS], const char *name)
{
    image out = image_new(SIGNALS * (SHOWN + 4) - 4, SHOWN, 3);
    int k, x, y, c, margin = (FIELD - SHOWN) / 2;
    if (out.pixels == NULL) need("out of memory", name);
    for (k = 0; k < SIGNALS; ++k)
        for (y = 0; y < SHOWN; ++y)
            for (x = 0; x < SHOWN; ++x)
                for (c = 0; c < 3; ++c)
                    out.pixels[3 * (y * out.width + k * (SHOWN + 4) + x) + c] = (float)gain[k] *
                        rows[k].pixels[3 * ((y + margin) * FIELD + x + margin) + c];
    image_to_srgb(&out);
    save(&out, name);
    image_free(&out);
}

/* The signals convolved with the profile itself: the step in closed form, circles by rings around points at growing
   distance from their center. */
static void exact_signals(const ms_sss_profile *profile, double mm_per_px, image *rows)
{
    static double along[SIGNALS][RADII][3]; /* at pixel distance i from the center, or from the edge */
    double reflectance[3], value[3], inner[3], outer[3];
    int k, i, x, y, c;
    ms_sss_profile_reflectance(profile, reflectance);
    for (i = 0; i < RADII; ++i) {
        ms_sss_profile_strip(profile, i * mm_per_px, value);
        for (c = 0; c < 3; ++c) along[2][i][c] = 0.5 - 0.5 * value[c] / reflectance[c];
        for (k = 0; k < 2; ++k) { /* of the ring of radius r around the point, the arc inside the circle */
            double radius = signal_radius(k), width = 0.125, r;
            for (c = 0; c < 3; ++c) along[k][i][c] = 0;
            for (r = 0.5 * width; r < i + radius; r += width) {
                double cosine = i > 0 ? (i * i + r * r - radius * radius) / (2 * i * r) : r < radius ? -1 : 1;
                double arc = cosine <= -1 ? 1 : cosine >= 1 ? 0 : acos(cosine) / 3.14159265358979;
                if (arc <= 0) continue;
                ms_sss_profile_disc(profile, (r - 0.5 * width) * mm_per_px, inner);
                ms_sss_profile_disc(profile, (r + 0.5 * width) * mm_per_px, outer);
                for (c = 0; c < 3; ++c) along[k][i][c] += arc * (outer[c] - inner[c]) / reflectance[c];
            }
        }
    }
    for (k = 0; k < SIGNALS; ++k)
        for (y = 0; y < FIELD; ++y)
            for (x = 0; x < FIELD; ++x) {
                double dx = x + 0.5 - FIELD / 2, dy = y + 0.5 - FIELD / 2,
                       d = k < 2 ? sqrt(dx * dx + dy * dy) : fabs(dx);
                for (c = 0; c < 3; ++c) {
                    double v = 0;
                    if (d < RADII - 1)
                        v = along[k][(int)d][c] + (d - floor(d)) * (along[k][(int)d + 1][c] - along[k][(int)d][c]);
                    rows[k].pixels[3 * (y * FIELD + x) + c] = (float)(k == 2 && dx < 0 ? 1 - v : v);
                }
            }
}

static void show_models(FILE *page)
{
    ms_sss_profile *profile = material_profile("skin1");
    double radius_mm = radius_of(profile), gain[SIGNALS] = {1, 1, 1};
    ms_sss_designer *designer;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    image input, rows[SIGNALS];
    void *workspace = NULL;
    char name[64];
    int m, k, x, y, c;
    input = image_new(FIELD, FIELD, 3);
    for (k = 0; k < SIGNALS; ++k) rows[k] = image_new(FIELD, FIELD, 3);
    if (input.pixels == NULL || rows[SIGNALS - 1].pixels == NULL) need("out of memory", "models");
    need_ok(ms_sss_designer_create(&designer, profile, RADIUS_PX, NULL, NULL), "models");
    exact_signals(profile, radius_mm / RADIUS_PX, rows);
    gain[0] = 1 / (double)rows[0].pixels[3 * (FIELD / 2 * FIELD + FIELD / 2)];
    save_row(rows, gain, "model_exact.png");
    fprintf(page, "<tr><td>the profile itself<td><img src=\"model_exact.png\"><td><td><td><td>\n");
    options.pixels_per_mm[0] = (float)(RADIUS_PX / radius_mm);
    for (m = 0; m < MODELS; ++m) {
        static ms_sss_kernel kernel;
        ms_sss_kernel_options design = ms_sss_kernel_defaults();
        ms_sss_errors e;
        size_t size;
        design.model = models[m].model;
        design.term_count = models[m].terms;
        design.tap_count = models[m].taps;
        design.guide_k = models[m].guide_k;
        need_ok(ms_sss_kernel_build(&kernel, designer, &design, NULL), models[m].name);
        need_ok(ms_sss_kernel_measure(&e, &kernel, designer), models[m].name);
        size = ms_sss_filter_workspace(FIELD, FIELD, &kernel, 1, &options);
        workspace = realloc(workspace, size);
        if (workspace == NULL) need("out of memory", models[m].name);
        for (k = 0; k < SIGNALS; ++k) {
            ms_sss_frame frame;
            for (y = 0; y < FIELD; ++y)
                for (x = 0; x < FIELD; ++x)
                    for (c = 0; c < 3; ++c)
                        input.pixels[3 * (y * FIELD + x) + c] = signal_at(signal_radius(k), x + 0.5 - FIELD / 2,
                                                                          y + 0.5 - FIELD / 2);
            memset(&frame, 0, sizeof frame);
            frame.width = frame.height = FIELD;
            frame.input = ms_sss_interleaved(input.pixels, 3);
            frame.output = ms_sss_interleaved(rows[k].pixels, 3);
            need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), models[m].name);
        }
        snprintf(name, sizeof name, "model_%02d.png", m);
        save_row(rows, gain, name);
        fprintf(page, "<tr><td>%s<td><img src=\"%s\"><td>%d<td>%.1f<td>%.1f<td>%.1f\n", models[m].name, name,
                2 * models[m].terms, 100 * e.vertical_step, 100 * e.diagonal_step, 100 * e.texture);
    }
    free(workspace);
    for (k = 0; k < SIGNALS; ++k) image_free(&rows[k]);
    image_free(&input);
    ms_sss_designer_destroy(designer);
    ms_sss_profile_destroy(profile);
}

int main(int argc, char **argv)
{
    FILE *page, *lines;
    image bust, knot, both;
    int width = 1920, i, known = argc > 1;
    if (file_help(argc, argv, usage)) return file_end_stdout("demo_sss");
    for (i = 2; i < argc && known; i += 2) {
        int way = 0;
        while (i + 1 < argc && way < 2 && strcmp(argv[i + 1], methods[way]) != 0) ++way;
        if (strcmp(argv[i], "--width") == 0 && i + 1 < argc) width = atoi(argv[i + 1]);
        else if (strcmp(argv[i], "--method") == 0 && i + 1 < argc && way < 2) by_pyramid = way;
        else known = 0;
    }
    if (!known || width < 64 || width > 7680) return file_usage(usage);
    folder = argv[1];
    page = file_create(file("models.html"), &out_page);
    if (page == NULL) need(out_page.problem, file("models.html"));
    fputs("<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>Kernel models</title>\n"
          "<style>body{font:16px system-ui,sans-serif;max-width:1200px;margin:2em auto;padding:0 1em;color:#222} "
          "img{max-width:100%} "
          "td,th{padding:4px 12px;text-align:right} td:first-child{text-align:left}</style>\n"
          "<h1>Kernel models, skin1</h1>\n"
          "<p>A dot (brightened), a disk and a step by ms_sss_filter. Errors in % of the right "
          "result's standard deviation, at a radius of 48 pixels.\n<table>\n"
          "<tr><th>model<th>dot, disk, step<th>1D passes<th>step<th>45 degree step<th>1/f "
          "texture\n",
          page);
    lines = file_create(file("sss.txt"), &out_truth);
    if (lines == NULL) need(out_truth.problem, file("sss.txt"));
    bust = show_object(SCENE_BUST, "skin1", width, lines);
    show_truth("bust", "skin1", lines);
    knot = show_object(SCENE_KNOT, "marble", width, lines);
    show_truth("knot", "marble", lines);
    both = side_by_side(&bust, &knot, 0);
    save(&both, "demo.png");
    image_free(&both);
    show_skins(180, lines);
    plot_profiles(lines);
    need(file_finish(&out_truth, 1), file("sss.txt"));
    show_models(page);
    image_free(&bust);
    image_free(&knot);
    fputs("</table>\n", page);
    need(file_finish(&out_page, 1), file("models.html"));
    printf("%s\n", file("models.html"));
    return file_end_stdout("demo_sss");
}
