/* Ground truth for ms_sss.h: an object of examples/demo/scene.h as a random walk shows it, the irradiance and depth
   that a filter starts from, the profile of the same walk below a flat surface, and the errors of filtered pictures.
   Include ms_sss.h with its implementation first. */
#ifndef TESTS_RENDER_TRUTH_H
#define TESTS_RENDER_TRUTH_H
#include "trace.h"
#include "gather.h"

#define TRUTH_RINGS 96
#define TRUTH_SIGMA 0.12 /* of the depth weights, in radii of 99% of the energy: the default of ms_sss_filter */

/* Lit by one lamp alone. Light is irradiance over pi, so that times reflectance it is radiance. */
typedef struct truth_lamp {
    image irradiance, unfiltered; /* as it arrives; the same times the flat reflectance */
    image half[2];                /* the random walk's picture, two independent estimates */
    image back;                   /* as it arrives at the first surface behind */
    image entry;                  /* as it arrives where the light that points at the pixel first meets the object, */
    image thickness;              /* mm from there to the pixel; 0 where the pixel itself is first */
    scene_vec *entry_normal;
    double peak; /* of unfiltered */
} truth_lamp;

enum { TRUTH_FRONT, TRUTH_SIDE, TRUTH_BEHIND, TRUTH_LAMPS };

typedef struct truth {
    int width, height, pixels; /* pixels: that show the object */
    scene_camera camera;
    float mm_per_unit, mu_s[3], mu_a[3]; /* 1/mm */
    mesh m;
    tracer *t;
    trace_layers layers, behind; /* what is seen; the first surface behind that */
    truth_lamp lamp[TRUTH_LAMPS];
    const truth_lamp *lit;   /* the one in use */
    ms_sss_profile *profile; /* mm */
    double reflectance[3], radius_mm,
        radius_px; /* of the flat profile; of 99% of the widest channel, px at the object's center */
} truth;

static inline void truth_free(truth *t)
{
    int i, k;
    trace_destroy(t->t);
    mesh_free(&t->m);
    trace_layers_free(&t->layers);
    trace_layers_free(&t->behind);
    for (k = 0; k < TRUTH_LAMPS; ++k) {
        truth_lamp *l = &t->lamp[k];
        image_free(&l->irradiance);
        image_free(&l->unfiltered);
        image_free(&l->back);
        image_free(&l->entry);
        image_free(&l->thickness);
        free(l->entry_normal);
        for (i = 0; i < 2; ++i) image_free(&l->half[i]);
    }
    ms_sss_profile_destroy(t->profile);
    memset(t, 0, sizeof *t);
}

/* Coefficients in 1/mm: skin1 and marble of thesis 5.9.7 and 5.9.2; cream, ketchup and skin2 of Jensen, Marschner,
   Levoy, Hanrahan 2001, A practical model for subsurface light transport (reduced scattering). The objects shrink or
   grow so that the profile spans pixels. */
typedef enum truth_substance {
    TRUTH_SKIN,
    TRUTH_MARBLE,
    TRUTH_CREAM,
    TRUTH_KETCHUP,
    TRUTH_SKIN2,
    TRUTH_SUBSTANCES
} truth_substance;

static inline void truth_material(scene_object object, truth_substance substance, float mu_s[3], float mu_a[3],
                                  float *mm_per_unit)
{
    static const float s[TRUTH_SUBSTANCES][3] = {{0.74f, 0.88f, 1.01f},
                                                 {2.19f, 2.62f, 3.00f},
                                                 {7.38f, 5.47f, 3.15f},
                                                 {0.18f, 0.07f, 0.03f},
                                                 {1.09f, 1.59f, 1.79f}};
    static const float a[TRUTH_SUBSTANCES][3] = {{0.032f, 0.17f, 0.48f},
                                                 {0.0021f, 0.0041f, 0.0071f},
                                                 {0.0002f, 0.0028f, 0.0163f},
                                                 {0.061f, 0.97f, 1.45f},
                                                 {0.013f, 0.070f, 0.145f}};
    static const float scale[3][TRUTH_SUBSTANCES] = {
        {0.25f, 0.8f, 0.8f, 0.4f, 0.3f}, {0.25f, 0.6f, 0.6f, 0.4f, 0.3f}, {1, 1, 1, 1, 1}};
    int c;
    for (c = 0; c < 3; ++c) {
        mu_s[c] = s[substance][c];
        mu_a[c] = a[substance][c];
    }
    *mm_per_unit = scale[object][substance];
}

/* Lamps: the scene's key; one at right angle to the view, white; the scene's rim light. */
static inline void truth_lights(scene_object object, const scene_camera *camera, scene_light light[TRUTH_LAMPS])
{
    scene_light all[SCENE_LIGHTS];
    float reach = object == SCENE_BUST ? 650.0f : 270.0f;
    int c;
    scene_lights(object, all);
    light[TRUTH_FRONT] = all[0];
    light[TRUTH_SIDE].position = scene_add(scene_mul(camera->right, reach), scene_mul(camera->up, 0.2f * reach));
    light[TRUTH_SIDE].radius = 0.08f * reach;
    for (c = 0; c < 3; ++c) light[TRUTH_SIDE].power[c] = 3;
    light[TRUTH_BEHIND] = all[1];
}

/* The flat profile of the walk, from rings. */
static inline ms_status truth_profile(const float mu_s[3], const float mu_a[3], int walks, ms_sss_profile **profile)
{
    double edge[TRUTH_RINGS + 1], energy[TRUTH_RINGS], *value[3];
    const double *rings[3];
    ms_status status;
    int c, i;
    edge[0] = 0;
    for (i = 1; i <= TRUTH_RINGS; ++i) edge[i] = 0.01 * pow(1e4, (i - 1) / (TRUTH_RINGS - 1.0)); /* 10 um to 100 mm */
    for (c = 0; c < 3; ++c) {
        rings[c] = value[c] = (double *)malloc(TRUTH_RINGS * sizeof(double));
        if (value[c] == NULL) abort();
        trace_flat_profile(mu_s[c], mu_a[c], edge + 1, TRUTH_RINGS, walks, 4, energy);
        for (i = 0; i < TRUTH_RINGS; ++i)
            value[c][i] = (energy[i] - (i ? energy[i - 1] : 0)) /
                (3.14159265358979 * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]));
    }
    status = ms_sss_profile_from_rings(profile, TRUTH_RINGS, edge, rings, 1, NULL, NULL);
    for (c = 0; c < 3; ++c) free(value[c]);
    return status;
}

/* Pictures of floats that took long to make, kept in a file: 1 where they were read. */
static inline int truth__cached(const char *path, int write, int width, int height, int walks,
                                truth_lamp lamp[TRUTH_LAMPS])
{
    FILE *f = path ? fopen(path, write ? "wb" : "rb") : NULL;
    int head[4] = {0, 0, 0, 0}, want[4], k, h, ok;
    size_t count = 3 * (size_t)width * (size_t)height;
    want[0] = 1;
    want[1] = width;
    want[2] = height;
    want[3] = walks;
    if (f == NULL) return 0;
    ok = write ? fwrite(want, sizeof want, 1, f) == 1
               : fread(head, sizeof head, 1, f) == 1 && memcmp(head, want, sizeof head) == 0;
    for (k = 0; k < TRUTH_LAMPS; ++k)
        for (h = 0; h < 2 && ok; ++h)
            ok = count ==
                (write ? fwrite(lamp[k].half[h].pixels, sizeof(float), count, f)
                       : fread(lamp[k].half[h].pixels, sizeof(float), count, f));
    return (fclose(f) == 0) & ok;
}

/* What lies behind each pixel along the view, and along each lamp's light. */
static inline int truth__hidden(truth *t)
{
    size_t n = (size_t)t->width * (size_t)t->height, i;
    int k, c;
    t->behind.width = t->width;
    t->behind.height = t->height;
    t->behind.position = (scene_vec *)calloc(n, sizeof(scene_vec));
    t->behind.normal = (scene_vec *)calloc(n, sizeof(scene_vec));
    t->behind.triangle = (int *)calloc(n, sizeof(int));
    t->behind.depth = image_new(t->width, t->height, 1);
    if (!t->behind.position || !t->behind.normal || !t->behind.triangle || !t->behind.depth.pixels) return 0;
    for (i = 0; i < n; ++i) {
        scene_vec ray = scene_normalize(scene_sub(t->layers.position[i], t->camera.eye));
        trace_hit hit;
        t->behind.triangle[i] = -1;
        if (t->layers.triangle[i] < 0) continue;
        hit = trace_nearest(t->t, scene_mad(ray, 10 * t->t->nudge, t->layers.position[i]), ray, 1e9f);
        if (hit.triangle < 0) continue;
        t->behind.triangle[i] = hit.triangle;
        t->behind.position[i] = scene_mad(ray, hit.t + 10 * t->t->nudge, t->layers.position[i]);
        t->behind.normal[i] = hit.normal;
        t->behind.depth.pixels[i] = -scene_dot(scene_sub(t->behind.position[i], t->camera.eye), t->camera.back);
    }
    for (k = 0; k < t->t->lights; ++k) {
        truth_lamp *l = &t->lamp[k];
        const scene_light *light = &t->t->light[k];
        l->entry = image_new(t->width, t->height, 3);
        l->thickness = image_new(t->width, t->height, 1);
        l->entry_normal = (scene_vec *)calloc(n, sizeof(scene_vec));
        if (!l->entry.pixels || !l->thickness.pixels || !l->entry_normal) return 0;
        for (i = 0; i < n; ++i) {
            scene_vec to = scene_sub(t->layers.position[i], light->position), ray = scene_normalize(to);
            trace_hit hit;
            if (t->layers.triangle[i] < 0) continue;
            hit = trace_nearest(t->t, light->position, ray, 1e9f);
            if (hit.triangle < 0) continue;
            l->thickness.pixels[i] = scene__max(0, scene_length(to) - hit.t - 0.01f) * t->mm_per_unit;
            l->entry_normal[i] = hit.normal;
            for (c = 0; c < 3; ++c)
                l->entry.pixels[3 * i + (size_t)c] = light->power[c] * scene__max(0, -scene_dot(ray, hit.normal)) *
                    scene_dot(light->position, light->position) / (hit.t * hit.t * 3.14159265f);
        }
        l->back = image_new(t->width, t->height, 3);
        if (!l->back.pixels) return 0;
        trace_irradiance(t->t, &t->behind, k, 16, 9, &l->back);
    }
    return 1;
}

/* The lamp in use; those that truth_make was not asked for are dark. */
static inline void truth_light(truth *t, int lamp) { t->lit = &t->lamp[lamp]; }

/* All three lamps, or with front_only the key alone. samples: walks a pixel and estimate. cache: a file that keeps the
   walks' pictures from call to call, NULL: none. 0: something failed (message in *problem). */
static inline int truth_make(truth *t, scene_object object, truth_substance substance, int width, int height,
                             int samples, int front_only, const char *cache, const char **problem)
{
    float scene_mu_s[3], scene_mu_a[3];
    scene_light light[TRUTH_LAMPS];
    int c, i, k, h;
    memset(t, 0, sizeof *t);
    t->width = width;
    t->height = height;
    t->camera = scene_camera_of(object);
    truth_light(t, TRUTH_FRONT);
    truth_material(object, substance, t->mu_s, t->mu_a, &t->mm_per_unit);
    truth_lights(object, &t->camera, light);
    *problem = "the mesh could not be made";
    if (!mesh_make(&t->m, object, object == SCENE_BUST ? 2.5f : object == SCENE_KNOT ? 1.0f : 0.7f)) return 0;
    *problem = "Embree could not build the scene";
    t->t = trace_create(&t->m, light, front_only ? 1 : TRUTH_LAMPS);
    if (t->t == NULL || !trace_primary(t->t, &t->camera, width, height, &t->layers)) return 0;
    for (k = 0; k < t->t->lights; ++k) {
        t->lamp[k].irradiance = image_new(width, height, 3);
        t->lamp[k].unfiltered = image_new(width, height, 3);
        for (h = 0; h < 2; ++h) t->lamp[k].half[h] = image_new(width, height, 3);
        trace_irradiance(t->t, &t->layers, k, 64, 1, &t->lamp[k].irradiance);
    }
    for (c = 0; c < 3; ++c) { /* the scene's unit is not 1 mm */
        scene_mu_s[c] = t->mu_s[c] * t->mm_per_unit;
        scene_mu_a[c] = t->mu_a[c] * t->mm_per_unit;
    }
    if (front_only || !truth__cached(cache, 0, width, height, samples, t->lamp)) {
        for (h = 0; h < 2; ++h) {
            image out[TRUTH_LAMPS];
            for (k = 0; k < t->t->lights; ++k) out[k] = t->lamp[k].half[h];
            trace_subsurface(t->t, &t->layers, scene_mu_s, scene_mu_a, samples, 2 + (uint32_t)h, out);
        }
        if (!front_only) truth__cached(cache, 1, width, height, samples, t->lamp);
    }
    *problem = "out of memory";
    if (!truth__hidden(t)) return 0;
    *problem = "the flat profile was refused";
    if (truth_profile(t->mu_s, t->mu_a, 1 << 18, &t->profile) != MS_OK) return 0;
    ms_sss_profile_reflectance(t->profile, t->reflectance);
    {
        double radius[3];
        ms_sss_profile_radius(t->profile, 0.99, radius);
        for (c = 0; c < 3; ++c) t->radius_mm = radius[c] > t->radius_mm ? radius[c] : t->radius_mm;
        t->radius_px = t->radius_mm / (double)t->mm_per_unit * height /
            (2 * (double)t->camera.tan_half_fov * (double)scene_length(t->camera.eye));
    }
    for (i = 0; i < width * height; ++i) t->pixels += t->layers.triangle[i] >= 0;
    for (k = 0; k < t->t->lights; ++k)
        for (i = 0; i < width * height; ++i)
            for (c = 0; c < 3; ++c) {
                truth_lamp *l = &t->lamp[k];
                l->unfiltered.pixels[3 * i + c] = l->irradiance.pixels[3 * i + c] * (float)t->reflectance[c];
                if ((double)l->unfiltered.pixels[3 * i + c] > l->peak)
                    l->peak = (double)l->unfiltered.pixels[3 * i + c];
            }
    return 1;
}

typedef struct truth_error {
    double relative, psnr; /* root mean square error over that of the truth; dB below the brightest unfiltered value */
} truth_error;

/* On the object's pixels. The truth's noise drops out: the mean of (F - A)(F - B) over two independent estimates A and
   B of T has the expectation (F - T)^2. */
static inline truth_error truth_compare(const truth *t, const image *picture)
{
    double error = 0, power = 0;
    truth_error e;
    int i, c;
    for (i = 0; i < t->width * t->height; ++i)
        for (c = 0; c < 3 && t->layers.triangle[i] >= 0; ++c) {
            double f = (double)picture->pixels[3 * i + c], a = (double)t->lit->half[0].pixels[3 * i + c],
                   b = (double)t->lit->half[1].pixels[3 * i + c];
            error += (f - a) * (f - b);
            power += a * b;
        }
    e.relative = error > 0 ? sqrt(error / power) : 0;
    e.psnr = -10 * log10(error / (3.0 * t->pixels * t->lit->peak * t->lit->peak));
    return e;
}

/* What a picture gives up, and where. */
enum { TRUTH_OUTLINE, TRUTH_BORDER, TRUTH_DARK, TRUTH_PLAIN, TRUTH_REGIONS };

typedef struct truth_report {
    double relative, scaled; /* as in truth_error; after the best factor for each channel */
    double lost[3];          /* of the light, by channel */
    double
        share[TRUTH_REGIONS]; /* of the squared error: near outlines, near a shadow's border, in the dark, elsewhere */
} truth_report;

static inline int truth__lit(const truth *t, int x, int y)
{
    const float *e = t->lit->irradiance.pixels + 3 * (y * t->width + x);
    return (double)(e[0] + e[1] + e[2]) > 0.02 * t->lit->peak;
}

/* Within `reach` pixels: 1: the outline, or a step in depth of more than a radius; 2: lit and unlit surface. */
static inline int truth__near(const truth *t, int x, int y, int reach, int what)
{
    int dx, dy, at = y * t->width + x;
    for (dy = -reach; dy <= reach; ++dy)
        for (dx = -reach; dx <= reach; ++dx) {
            int qx = x + dx, qy = y + dy, q = qy * t->width + qx, inside;
            if (dx * dx + dy * dy > reach * reach || qx < 0 || qy < 0 || qx >= t->width || qy >= t->height) continue;
            inside = t->layers.triangle[q] >= 0;
            if (what == 1 &&
                (!inside ||
                 fabs((double)(t->layers.depth.pixels[q] - t->layers.depth.pixels[at]) * (double)t->mm_per_unit) >
                     t->radius_mm))
                return 1;
            if (what == 2 && inside && truth__lit(t, qx, qy) != truth__lit(t, x, y)) return 1;
        }
    return 0;
}

/* [height][width], -1 beside the object; the caller frees it. */
static inline signed char *truth_regions(const truth *t)
{
    signed char *region = (signed char *)malloc((size_t)(t->width * t->height));
    int x, y, border = t->radius_px < 8 ? 2 : t->radius_px > 32 ? 8 : (int)(t->radius_px / 4);
    if (region == NULL) abort();
    for (y = 0; y < t->height; ++y)
        for (x = 0; x < t->width; ++x) {
            int at = y * t->width + x;
            region[at] = (signed char)(t->layers.triangle[at] < 0            ? -1
                                           : truth__near(t, x, y, 2, 1)      ? TRUTH_OUTLINE
                                           : truth__near(t, x, y, border, 2) ? TRUTH_BORDER
                                           : truth__lit(t, x, y)             ? TRUTH_PLAIN
                                                                             : TRUTH_DARK);
        }
    return region;
}

static inline truth_report truth_judge(const truth *t, const signed char *region, const image *picture)
{
    double ff[3] = {0, 0, 0}, fa[3] = {0, 0, 0}, power[3] = {0, 0, 0}, light[3] = {0, 0, 0}, got[3] = {0, 0, 0},
           error = 0, all = 0, rest = 0;
    truth_report r;
    int i, c;
    memset(&r, 0, sizeof r);
    for (i = 0; i < t->width * t->height; ++i)
        for (c = 0; c < 3 && region[i] >= 0; ++c) {
            double f = (double)picture->pixels[3 * i + c], a = (double)t->lit->half[0].pixels[3 * i + c],
                   b = (double)t->lit->half[1].pixels[3 * i + c], square = (f - a) * (f - b);
            ff[c] += f * f;
            fa[c] += 0.5 * f * (a + b);
            power[c] += a * b;
            light[c] += 0.5 * (a + b);
            got[c] += f;
            error += square;
            r.share[region[i]] += square;
        }
    for (c = 0; c < 3; ++c) {
        double g = ff[c] > 0 ? fa[c] / ff[c] : 1;
        all += power[c];
        rest += g * g * ff[c] - 2 * g * fa[c] + power[c];
        r.lost[c] = light[c] > 0 ? 1 - got[c] / light[c] : 0;
    }
    r.relative = error > 0 ? sqrt(error / all) : 0;
    r.scaled = rest > 0 ? sqrt(rest / all) : 0;
    for (i = 0; i < TRUTH_REGIONS; ++i) r.share[i] /= error;
    return r;
}

/* The frame and options that the filters get: irradiance in, out, depth (0 beside the object: takes no part). */
static inline ms_sss_filter_options truth_frame(const truth *t, ms_sss_frame *frame, image *out)
{
    ms_sss_filter_options options = ms_sss_filter_defaults();
    memset(frame, 0, sizeof *frame);
    frame->width = t->width;
    frame->height = t->height;
    frame->input = ms_sss_interleaved(t->lit->irradiance.pixels, 3);
    frame->output = ms_sss_interleaved(out->pixels, 3);
    frame->depth = ms_sss_map(t->layers.depth.pixels, 1);
    options.fov_degrees = 2 * atanf(t->camera.tan_half_fov) * (180 / 3.14159265f);
    options.mm_per_unit = t->mm_per_unit;
    return options;
}

static inline void truth_reflect(const truth *t, image *out)
{
    int i, c;
    for (i = 0; i < t->width * t->height; ++i)
        for (c = 0; c < 3; ++c) out->pixels[3 * i + c] *= (float)t->reflectance[c];
}

/* The irradiance filtered by a separable kernel, times reflectance, into out (of the same size); sigma: of the depth
   weights, in radii of 99% of the energy, the same for every kernel, however far its last tap is; 0: the filter's
   own. */
static inline ms_status truth_filter(const truth *t, const ms_sss_kernel *kernel, double sigma, float flat, image *out)
{
    ms_sss_frame frame;
    ms_sss_filter_options options = truth_frame(t, &frame, out);
    size_t size;
    void *workspace;
    ms_status status;
    options.flat = flat;
    options.depth_sigma_mm = (float)(t->radius_mm * sigma);
    size = ms_sss_filter_workspace(t->width, t->height, kernel, 1, &options);
    workspace = malloc(size);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    status = ms_sss_filter(&frame, kernel, 1, &options, workspace, size, NULL);
    free(workspace);
    truth_reflect(t, out);
    return status;
}

static inline ms_status truth_pyramid(const truth *t, const ms_sss_pyramid *pyramid, float flat, int exact, image *out)
{
    ms_sss_frame frame;
    ms_sss_filter_options options = truth_frame(t, &frame, out);
    size_t size = ms_sss_pyramid_workspace(t->width, t->height);
    void *workspace = malloc(size);
    ms_status status;
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    options.flat = flat;
    options.exact = exact;
    status = ms_sss_pyramid_filter(&frame, pyramid, 1, &options, workspace, size, NULL);
    free(workspace);
    truth_reflect(t, out);
    return status;
}

static inline ms_status truth_gather(const truth *t, int with_back, float flat, image *out)
{
    ms_sss_frame frame;
    gather_back back;
    ms_sss_filter_options options = truth_frame(t, &frame, out);
    ms_status status;
    memset(&back, 0, sizeof back);
    back.input = ms_sss_interleaved(t->lit->back.pixels, 3);
    back.depth = ms_sss_map(t->behind.depth.pixels, 1);
    options.flat = flat;
    status = gather_filter(&frame, with_back ? &back : NULL, t->profile, &options, NULL);
    truth_reflect(t, out);
    return status;
}

/* A filtered picture and what ms_sss_transmission sends through, by max. */
static inline void truth_through(const truth *t, const ms_sss_kernel *kernel, image *out)
{
    const scene_light *light = &t->t->light[t->lit - t->lamp];
    int i, c;
    for (i = 0; i < t->width * t->height; ++i) {
        float normal[3], entry_normal[3], to_light[3], in[3], through[3], cosine;
        scene_vec d = scene_normalize(scene_sub(light->position, t->layers.position[i]));
        if (t->layers.triangle[i] < 0) continue;
        normal[0] = t->layers.normal[i].x, normal[1] = t->layers.normal[i].y, normal[2] = t->layers.normal[i].z;
        entry_normal[0] = t->lit->entry_normal[i].x, entry_normal[1] = t->lit->entry_normal[i].y,
        entry_normal[2] = t->lit->entry_normal[i].z;
        to_light[0] = d.x, to_light[1] = d.y, to_light[2] = d.z;
        cosine = scene_dot(t->lit->entry_normal[i], d);
        for (c = 0; c < 3; ++c) in[c] = cosine > 0 ? t->lit->entry.pixels[3 * i + c] / cosine : 0; /* at right angle */
        ms_sss_transmission(kernel, t->lit->thickness.pixels[i], normal, entry_normal, to_light, in, through);
        for (c = 0; c < 3; ++c) {
            float v = through[c] * (float)t->reflectance[c];
            if (v > out->pixels[3 * i + c]) out->pixels[3 * i + c] = v;
        }
    }
}

/* A model of Unity HDRP's filter (Golubev 2018): samples of a disc on the screen, importance-sampled by the widest
   channel, turned by a random angle at each pixel in each of the frames, whose mean this is. A weight is at most 1: the
   profile at the distance r in space times r, over that at the distance p on the screen. No curvature, no normals. */
static inline void truth_disc(const truth *t, int samples, int frames, image *out)
{
    double radius[3], (*value)[3] = (double(*)[3])malloc(4097 * sizeof *value), reach;
    double(*sample)[2] = (double(*)[2])malloc((size_t)samples * sizeof *sample); /* distance, profile there times it */
    uint32_t random = 1;
    int x, y, i, c, frame, widest = 0;
    if (value == NULL || sample == NULL) abort();
    memset(out->pixels, 0, image_count(out) * sizeof(float));
    ms_sss_profile_radius(t->profile, 0.99, radius);
    for (c = 1; c < 3; ++c)
        if (radius[c] > radius[widest]) widest = c;
    reach = 2 * radius[widest];
    for (i = 0; i <= 4096; ++i) ms_sss_profile_value(t->profile, reach * (i > 0 ? i : 0.25) / 4096, value[i]);
    for (i = 0; i < samples; ++i) {
        double r[3], at[3];
        ms_sss_profile_radius(t->profile, (i + 0.5) / samples * 0.995, r);
        ms_sss_profile_value(t->profile, r[widest], at);
        sample[i][0] = r[widest];
        sample[i][1] = r[widest] * at[widest];
    }
    for (frame = 0; frame < frames; ++frame)
        for (y = 0; y < t->height; ++y)
            for (x = 0; x < t->width; ++x) {
                const int at = y * t->width + x;
                const float z = t->layers.depth.pixels[at];
                double sum[3] = {0, 0, 0}, weights[3] = {0, 0, 0}, scale, turn;
                random = random * 1664525u + 1013904223u;
                if (t->layers.triangle[at] < 0) continue;
                turn = 6.28318530718 * random / 4294967296.0;
                scale = t->height / (2 * (double)t->camera.tan_half_fov * (double)z * (double)t->mm_per_unit);
                for (i = 0; i < samples; ++i) {
                    const double angle = 2.39996323 * i + turn, p = sample[i][0] * scale;
                    const int qx = x + (int)floor(p * cos(angle) + 0.5), qy = y + (int)floor(p * sin(angle) + 0.5),
                              q = qy * t->width + qx;
                    double dz, r;
                    int cell;
                    if (qx < 0 || qy < 0 || qx >= t->width || qy >= t->height || t->layers.triangle[q] < 0) continue;
                    dz = (double)((t->layers.depth.pixels[q] - z) * t->mm_per_unit);
                    r = sqrt(sample[i][0] * sample[i][0] + dz * dz);
                    cell = (int)(r / reach * 4096 + 0.5);
                    if (cell > 4096) continue;
                    for (c = 0; c < 3; ++c) {
                        const double w = fmin(1, value[cell][c] * r / sample[i][1]);
                        weights[c] += w;
                        sum[c] += w * (double)t->lit->irradiance.pixels[3 * q + c];
                    }
                }
                for (c = 0; c < 3; ++c)
                    out->pixels[3 * at + c] += (float)(weights[c] > 0 ? t->reflectance[c] * sum[c] / weights[c] / frames
                                                                      : 0);
            }
    free(value);
    free(sample);
}

/* One pass of truth_following along dx, dy. */
static inline void truth__following_pass(const truth *t, const ms_sss_kernel *kernel, double follow, double width,
                                         int dx, int dy, const float *from, float *to)
{
    int x, y, i, c, h;
    for (y = 0; y < t->height; ++y)
        for (x = 0; x < t->width; ++x) {
            const int at = y * t->width + x;
            const double z = (double)t->layers.depth.pixels[at];
            double sum[3] = {0, 0, 0}, weights[3] = {0, 0, 0}, scale;
            if (t->layers.triangle[at] < 0) continue;
            scale = t->height / (2 * (double)t->camera.tan_half_fov * z * (double)t->mm_per_unit);
            for (i = 0; i < kernel->tap_count; ++i) {
                const double place = (i % 2 ? -1 : 1) * (double)kernel->offset_mm[(i + 1) / 2] * width * scale;
                const int first = (int)floor(place);
                for (h = 0; h < 2; ++h) {
                    const int qx = x + dx * (first + h), qy = y + dy * (first + h), q = qy * t->width + qx;
                    const double part = h ? place - first : 1 - (place - first);
                    double back = 1; /* how much of the tap's color the pixel's own replaces */
                    if (qx >= 0 && qy >= 0 && qx < t->width && qy < t->height && t->layers.triangle[q] >= 0)
                        back = fmin(1,
                                    follow * fabs((double)t->layers.depth.pixels[q] - z) * (double)t->mm_per_unit /
                                        t->radius_mm);
                    for (c = 0; c < 3; ++c) {
                        const double w = part * (double)kernel->weight[0][(i + 1) / 2][c],
                                     own = (double)from[3 * at + c];
                        weights[c] += w;
                        sum[c] += w * (back < 1 ? own * back + (1 - back) * (double)from[3 * q + c] : own);
                    }
                }
            }
            for (c = 0; c < 3; ++c) to[3 * at + c] = (float)(weights[c] > 0 ? sum[c] / weights[c] : 0);
        }
}

/* A model of the released separable shader (Jimenez et al. 2015) with its option to follow the surface: a tap's color
   turns into the pixel's own in proportion to their distance in depth, `follow` a radius of the profile; offsets are `width` times the kernel's. */
static inline void truth_following(const truth *t, const ms_sss_kernel *kernel, double follow, double width, image *out)
{
    float *between = (float *)calloc((size_t)t->width * (size_t)t->height, 3 * sizeof *between);
    if (between == NULL) abort();
    truth__following_pass(t, kernel, follow, width, 1, 0, t->lit->irradiance.pixels, between);
    truth__following_pass(t, kernel, follow, width, 0, 1, between, out->pixels);
    truth_reflect(t, out);
    free(between);
}

/* What the profile makes of the whole surface, seen or not: every triangle gives its share of the ring as wide as
   itself, at its true distance, with the elevation or without. */
static inline void truth_mesh(const truth *t, int elevation, image *out)
{
    const int steps = 4096;
    double(*disc)[3] = (double(*)[3])malloc((size_t)(steps + 1) * sizeof *disc), reach = t->radius_mm * 1.5, K[3];
    float *point = (float *)malloc(10 * (size_t)t->m.triangles * sizeof *point), from, to;
    int i, k, c, x, lamp = (int)(t->lit - t->lamp);
    if (disc == NULL || point == NULL) abort();
    for (i = 0; i <= steps; ++i) ms_sss_profile_disc(t->profile, reach * i / steps, disc[i]);
    for (c = 0; c < 3; ++c) K[c] = elevation ? ms_sss_elevation(t->reflectance[c], 1) : 0;
    for (i = 0; i < t->m.triangles; ++i) { /* middle and size in mm, normal, irradiance by four rays */
        scene_vec v[3], middle, n;
        float *p = point + 10 * i, length;
        for (k = 0; k < 3; ++k) {
            const float *a = t->m.position + 3 * t->m.triangle[3 * i + k];
            v[k] = scene_v(a[0], a[1], a[2]);
        }
        middle = scene_mul(scene_add(v[0], scene_add(v[1], v[2])), 1 / 3.0f);
        n = scene_cross(scene_sub(v[1], v[0]), scene_sub(v[2], v[0]));
        length = scene_length(n);
        memset(p, 0, 10 * sizeof *p);
        if (!(length > 0)) continue;
        n = scene_mul(n, 1 / length);
        p[0] = middle.x * t->mm_per_unit, p[1] = middle.y * t->mm_per_unit, p[2] = middle.z * t->mm_per_unit;
        p[3] = n.x, p[4] = n.y, p[5] = n.z;
        p[6] = sqrtf(0.5f * length) * t->mm_per_unit;
        for (k = 0; k < 4; ++k) {
            trace_sampler s;
            s.seed = trace__hash((uint32_t)i + 77);
            s.index = (uint32_t)k;
            s.pair = 0;
            trace__lamp(t->t, lamp, &s, middle, n, p + 7);
        }
        for (c = 0; c < 3; ++c) p[7 + c] *= 0.25f;
    }
    from = (float)(reach * reach);
    for (x = 0; x < t->width * t->height; ++x) {
        double sum[3] = {0, 0, 0}, weights[3] = {0, 0, 0}, factors[3] = {0, 0, 0};
        scene_vec at = scene_mul(t->layers.position[x], t->mm_per_unit), n = t->layers.normal[x];
        if (t->layers.triangle[x] < 0) continue;
        for (i = 0; i < t->m.triangles; ++i) {
            const float *p = point + 10 * i;
            float dx = at.x - p[0], dy = at.y - p[1], dz = at.z - p[2];
            double r, low, high, area, sine;
            int inner, outer;
            to = dx * dx + dy * dy + dz * dz;
            if (to > from || !(p[6] > 0)) continue;
            r = sqrt((double)to);
            low = r > 0.5 * (double)p[6] ? r - 0.5 * (double)p[6] : 0;
            high = r + 0.5 * (double)p[6];
            if (high > reach) continue;
            inner = (int)(low / reach * steps + 0.5);
            outer = (int)(high / reach * steps + 0.5);
            if (outer <= inner) outer = inner + 1;
            area = (double)(p[6] * p[6]) / (high * high - low * low);
            sine = r > 0 ? 0.5 * (double)((n.x - p[3]) * dx + (n.y - p[4]) * dy + (n.z - p[5]) * dz) / r : 0;
            for (c = 0; c < 3; ++c) {
                double w = area * (disc[outer][c] - disc[inner][c]), f = 1 + 0.25 * K[c] * sine;
                f = f > 0 ? f * f * f * f * w : 0;
                weights[c] += w;
                factors[c] += f;
                sum[c] += f * (double)p[7 + c];
            }
        }
        for (c = 0; c < 3; ++c) {
            double most = t->reflectance[c] * factors[c] / weights[c];
            out->pixels[3 * x + c] = (float)(weights[c] > 0
                                                 ? t->reflectance[c] * sum[c] / weights[c] / (most > 1 ? most : 1)
                                                 : 0);
        }
    }
    free(disc);
    free(point);
}

/* The same by the profile itself, pixel by pixel: each pixel gives its share of the ring as wide as itself,
   renormalized. in_space 1: distances between the points on the surface, pixels as large as the surface they show.
   in_space 0: what a screen-space filter approximates, distances on the screen and its treatment of depth. */
static inline void truth_filter_2d(const truth *t, int in_space, image *out)
{
    const int steps = 4096;
    double(*disc)[3] = (double(*)[3])malloc((size_t)(steps + 1) * sizeof *disc);
    double *size = (double *)malloc((size_t)t->width * (size_t)t->height * sizeof *size);
    double reach = t->radius_mm * 1.5, sigma = t->radius_mm * TRUTH_SIGMA;
    int x, y, i, c;
    if (disc == NULL || size == NULL) abort();
    for (i = 0; i <= steps; ++i) ms_sss_profile_disc(t->profile, reach * i / steps, disc[i]);
    for (i = 0; i < t->width * t->height;
         ++i) { /* mm along the side of a pixel, or of the square of surface that it shows */
        scene_vec to_eye = scene_sub(t->camera.eye, t->layers.position[i]);
        double facing = (double)(scene_dot(to_eye, t->layers.normal[i]) / scene_length(to_eye));
        size[i] = 2 * (double)t->camera.tan_half_fov * (double)t->layers.depth.pixels[i] * (double)t->mm_per_unit /
            t->height;
        if (in_space) size[i] /= sqrt(facing > 0.1 ? facing : 0.1);
    }
    for (y = 0; y < t->height; ++y)
        for (x = 0; x < t->width; ++x) {
            int at = y * t->width + x, n, dx, dy;
            double sum[3] = {0, 0, 0}, weights[3] = {0, 0, 0};
            if (t->layers.triangle[at] < 0) continue;
            n = (int)(reach /
                      (2 * (double)t->camera.tan_half_fov * (double)t->layers.depth.pixels[at] *
                       (double)t->mm_per_unit / t->height));
            for (dy = -n; dy <= n; ++dy)
                for (dx = -n; dx <= n; ++dx) {
                    int qx = x + dx, qy = y + dy, q = qy * t->width + qx, inner, outer;
                    double r, low, high, weight;
                    if (qx < 0 || qy < 0 || qx >= t->width || qy >= t->height || t->layers.triangle[q] < 0) continue;
                    r = in_space ? (double)(scene_length(scene_sub(t->layers.position[q], t->layers.position[at])) *
                                            t->mm_per_unit)
                                 : sqrt((double)(dx * dx + dy * dy)) * size[at];
                    low = r > 0.5 * size[q] ? r - 0.5 * size[q] : 0;
                    high = r > 0 ? r + 0.5 * size[q] : size[q] / sqrt(3.14159265358979);
                    if (high > reach) continue;
                    inner = (int)(low / reach * steps + 0.5);
                    outer = (int)(high / reach * steps + 0.5);
                    if (outer <= inner) outer = inner + 1;
                    weight = size[q] * size[q] / (high * high - low * low);
                    if (!in_space) {
                        double dz = (double)(t->layers.depth.pixels[q] - t->layers.depth.pixels[at]) *
                            (double)t->mm_per_unit;
                        weight *= exp(-dz * dz / (2 * sigma * sigma));
                    }
                    for (c = 0; c < 3; ++c) {
                        double w = weight * (disc[outer][c] - disc[inner][c]);
                        weights[c] += w;
                        sum[c] += w * (double)t->lit->irradiance.pixels[3 * q + c];
                    }
                }
            for (c = 0; c < 3; ++c) out->pixels[3 * at + c] = (float)(t->reflectance[c] * sum[c] / weights[c]);
        }
    free(disc);
    free(size);
}

/* The rows of the table: models, mostly with dense taps, and how sharply depth separates. */
typedef struct truth_model {
    const char *name;
    ms_sss_model model;
    int terms, taps;
    double guide_k, sigma;
} truth_model;

static const truth_model truth_models[] = {
    {"R_d sampled along the axis", MS_SSS_SLICE, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"one Gaussian", MS_SSS_GAUSSIANS, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"SVD rank 1, normalized", MS_SSS_SVD_NORMALIZED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"artist, fitted", MS_SSS_ARTIST, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"guided, k = 0", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"guided, k = 2", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 2, TRUTH_SIGMA},
    {"guided, k = 2, depth sigma 1/3 radius", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 2, 0.333},
    {"pre-integrated", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"pre-integrated, depth sigma 1/3 radius", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0, 0.333},
    {"image-optimal, 33 taps", MS_SSS_IMAGE_OPTIMAL, 1, 33, 0, TRUTH_SIGMA},
    {"image-optimal, 7 taps (default)", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0, TRUTH_SIGMA},
    {"image-optimal, 7 taps, depth sigma 1/3 radius", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0, 0.333},
    {"image-optimal, 17 taps", MS_SSS_IMAGE_OPTIMAL, 1, 17, 0, TRUTH_SIGMA},
    {"SVD rank 3, normalized", MS_SSS_SVD_NORMALIZED, 3, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"SVD rank 3, normalized, depth sigma 1/3 radius", MS_SSS_SVD_NORMALIZED, 3, MS_SSS_DENSE, 0, 0.333},
    {"pre-integrated + 1 residual", MS_SSS_RESIDUAL, 2, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"six Gaussians", MS_SSS_GAUSSIANS, 6, MS_SSS_DENSE, 0, TRUTH_SIGMA}};

enum { TRUTH_MODELS = sizeof truth_models / sizeof truth_models[0] };

static inline ms_status truth_kernel(const ms_sss_designer *designer, const truth_model *model, ms_sss_kernel *kernel)
{
    ms_sss_kernel_options options = ms_sss_kernel_defaults();
    options.model = model->model;
    options.term_count = model->terms;
    options.tap_count = model->taps;
    options.guide_k = model->guide_k;
    return ms_sss_kernel_build(kernel, designer, &options, NULL);
}

/* A linear picture for people: the peak just below white, sRGB. */
static inline const char *truth_save(const truth *t, const image *picture, const char *path)
{
    image shown = image_new(picture->width, picture->height, 3);
    const char *problem;
    size_t i;
    for (i = 0; i < image_count(&shown); ++i)
        shown.pixels[i] = scene_tone(picture->pixels[i] * 1.2f / (float)t->lit->peak);
    image_to_srgb(&shown);
    problem = image_write(path, &shown);
    image_free(&shown);
    return problem;
}
#endif
