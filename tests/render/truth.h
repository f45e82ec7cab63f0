/* Ground truth for ms_sss.h: an object of examples/scene.h as a random walk shows it, the irradiance and depth that a
   filter starts from, the profile of the same walk below a flat surface, and the errors of filtered pictures. Include
   ms_sss.h with its implementation first. */
#ifndef TESTS_RENDER_TRUTH_H
#define TESTS_RENDER_TRUTH_H
#include "trace.h"

#define TRUTH_RINGS 96
#define TRUTH_SIGMA 0.12 /* of the depth weights, in radii of 99% of the energy: the default of ms_sss_filter */

typedef struct truth {
    int width, height, pixels; /* pixels: that show the object */
    scene_camera camera;
    float mm_per_unit, peak;
    mesh m;
    tracer *t;
    trace_layers layers;
    image irradiance;        /* over pi */
    image half[2];           /* the random walk's picture, two independent estimates */
    image unfiltered;        /* irradiance times reflectance */
    ms_sss_profile *profile; /* mm */
    double reflectance[3], radius_mm,
        radius_px; /* of the flat profile; of 99% of the widest channel, px at the object's centre */
} truth;

static inline void truth_free(truth *t)
{
    int i;
    trace_destroy(t->t);
    mesh_free(&t->m);
    trace_layers_free(&t->layers);
    image_free(&t->irradiance);
    image_free(&t->unfiltered);
    for (i = 0; i < 2; ++i) image_free(&t->half[i]);
    ms_sss_profile_destroy(t->profile);
    memset(t, 0, sizeof *t);
}

/* Coefficients of thesis 5.9.2 (marble) and 5.9.7 (skin1), 1/mm. The objects shrink to figurines so that the profile
   spans pixels: busts of 70 mm (skin) and 220 mm, knots of 20 mm (skin) and 50 mm. */
typedef enum truth_substance { TRUTH_SKIN, TRUTH_MARBLE } truth_substance;

static inline void truth_material(scene_object object, truth_substance substance, float mu_s[3], float mu_a[3],
                                  float *mm_per_unit)
{
    static const float skin_s[3] = {0.74f, 0.88f, 1.01f}, skin_a[3] = {0.032f, 0.17f, 0.48f};
    static const float marble_s[3] = {2.19f, 2.62f, 3.00f}, marble_a[3] = {0.0021f, 0.0041f, 0.0071f};
    int skin = substance == TRUTH_SKIN, c;
    for (c = 0; c < 3; ++c) {
        mu_s[c] = skin ? skin_s[c] : marble_s[c];
        mu_a[c] = skin ? skin_a[c] : marble_a[c];
    }
    *mm_per_unit = skin ? 0.25f : object == SCENE_BUST ? 0.8f : 0.6f;
}

/* One lamp, the key; samples: walks a pixel and estimate. 0: something failed (message in *problem). */
static inline int truth_make(truth *t, scene_object object, truth_substance substance, int width, int height, int samples,
                             const char **problem)
{
    float mu_s[3], mu_a[3], scene_mu_s[3], scene_mu_a[3];
    double edge[TRUTH_RINGS + 1], energy[TRUTH_RINGS], *value[3];
    scene_light light[SCENE_LIGHTS];
    const double *rings[3];
    ms_status status;
    int c, i, k;
    memset(t, 0, sizeof *t);
    t->width = width;
    t->height = height;
    t->camera = scene_camera_of(object);
    truth_material(object, substance, mu_s, mu_a, &t->mm_per_unit);
    scene_lights(object, light);
    *problem = "the mesh could not be made";
    if (!mesh_make(&t->m, object, object == SCENE_BUST ? 2.5f : 1.0f)) return 0;
    *problem = "Embree could not build the scene";
    t->t = trace_create(&t->m, light, 1);
    if (t->t == NULL || !trace_primary(t->t, &t->camera, width, height, &t->layers)) return 0;
    t->irradiance = image_new(width, height, 3);
    t->unfiltered = image_new(width, height, 3);
    trace_irradiance(t->t, &t->layers, 64, 1, &t->irradiance);
    for (c = 0; c < 3; ++c) { /* the scene's unit is not 1 mm */
        scene_mu_s[c] = mu_s[c] * t->mm_per_unit;
        scene_mu_a[c] = mu_a[c] * t->mm_per_unit;
    }
    for (k = 0; k < 2; ++k) {
        t->half[k] = image_new(width, height, 3);
        trace_subsurface(t->t, &t->layers, scene_mu_s, scene_mu_a, samples, 2 + (uint32_t)k, &t->half[k]);
    }

    edge[0] = 0;
    for (i = 1; i <= TRUTH_RINGS; ++i) edge[i] = 0.01 * pow(1e4, (i - 1) / (TRUTH_RINGS - 1.0)); /* 10 um to 100 mm */
    for (c = 0; c < 3; ++c) {
        rings[c] = value[c] = (double *)malloc(TRUTH_RINGS * sizeof(double));
        if (value[c] == NULL) abort();
        trace_flat_profile(mu_s[c], mu_a[c], edge + 1, TRUTH_RINGS, 1 << 18, 4, energy);
        for (i = 0; i < TRUTH_RINGS; ++i)
            value[c][i] = (energy[i] - (i ? energy[i - 1] : 0)) /
                          (3.14159265358979 * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]));
    }
    *problem = "the flat profile was refused";
    status = ms_sss_profile_from_rings(&t->profile, TRUTH_RINGS, edge, rings, 1, NULL, NULL);
    for (c = 0; c < 3; ++c) free(value[c]);
    if (status != MS_OK) return 0;
    ms_sss_profile_reflectance(t->profile, t->reflectance);
    {
        double radius[3];
        ms_sss_profile_radius(t->profile, 0.99, radius);
        for (c = 0; c < 3; ++c) t->radius_mm = radius[c] > t->radius_mm ? radius[c] : t->radius_mm;
        t->radius_px = t->radius_mm / (double)t->mm_per_unit * height /
                       (2 * (double)t->camera.tan_half_fov * (double)scene_length(t->camera.eye));
    }
    for (i = 0; i < width * height; ++i) {
        t->pixels += t->layers.triangle[i] >= 0;
        for (c = 0; c < 3; ++c) {
            t->unfiltered.pixels[3 * i + c] = t->irradiance.pixels[3 * i + c] * (float)t->reflectance[c];
            t->peak = scene__max(t->peak, t->unfiltered.pixels[3 * i + c]);
        }
    }
    return 1;
}

typedef struct truth_error {
    double relative, psnr; /* root mean square error over that of the truth; dB below the brightest unfiltered value */
} truth_error;

/* On the object's pixels. The truth's noise drops out: the mean of (F - A)(F - B) over two independent estimates A and B
   of T has the expectation (F - T)^2. */
static inline truth_error truth_compare(const truth *t, const image *picture)
{
    double error = 0, power = 0;
    truth_error e;
    int i, c;
    for (i = 0; i < t->width * t->height; ++i)
        for (c = 0; c < 3 && t->layers.triangle[i] >= 0; ++c) {
            double f = (double)picture->pixels[3 * i + c], a = (double)t->half[0].pixels[3 * i + c],
                   b = (double)t->half[1].pixels[3 * i + c];
            error += (f - a) * (f - b);
            power += a * b;
        }
    e.relative = error > 0 ? sqrt(error / power) : 0;
    e.psnr = -10 * log10(error / (3.0 * t->pixels * (double)t->peak * (double)t->peak));
    return e;
}

/* The irradiance filtered by a separable kernel, times reflectance, into out (of the same size); sigma: of the depth
   weights, in radii of 99% of the energy. */
static inline ms_status truth_filter(const truth *t, const ms_sss_kernel *kernel, double sigma, image *out)
{
    ms_sss_frame frame;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    size_t size;
    void *workspace;
    ms_status status;
    int i, c;
    memset(&frame, 0, sizeof frame);
    frame.width = t->width;
    frame.height = t->height;
    frame.input = ms_sss_interleaved(t->irradiance.pixels, 3, 0);
    frame.output = ms_sss_interleaved(out->pixels, 3, 0);
    frame.depth = ms_sss_map(t->layers.depth.pixels, 1, 0); /* 0 beside the object: takes no part */
    options.fov_degrees = 2 * atanf(t->camera.tan_half_fov) * (180 / 3.14159265f);
    options.mm_per_unit = t->mm_per_unit;
    options.depth_sigma_mm = (float)(t->radius_mm * sigma); /* the same for every kernel, however far its last tap is */
    size = ms_sss_filter_workspace(t->width, t->height, kernel, 1, &options);
    workspace = malloc(size);
    if (workspace == NULL) return MS_OUT_OF_MEMORY;
    status = ms_sss_filter(&frame, kernel, 1, &options, workspace, size, NULL);
    free(workspace);
    for (i = 0; i < t->width * t->height; ++i)
        for (c = 0; c < 3; ++c) out->pixels[3 * i + c] *= (float)t->reflectance[c];
    return status;
}

/* The same by the profile itself, pixel by pixel: each pixel gives its share of the ring as wide as itself,
   renormalised. in_space 1: distances between the points on the surface, pixels as large as the surface they show.
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
            n = (int)(reach / (2 * (double)t->camera.tan_half_fov * (double)t->layers.depth.pixels[at] *
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
                        sum[c] += w * (double)t->irradiance.pixels[3 * q + c];
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
    {"SVD rank 1, normalised", MS_SSS_SVD_NORMALISED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"artist, fitted", MS_SSS_ARTIST, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"guided, k = 0", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"guided, k = 2", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 2, TRUTH_SIGMA},
    {"guided, k = 2, depth sigma 1/3 radius", MS_SSS_GUIDED, 1, MS_SSS_DENSE, 2, 0.333},
    {"pre-integrated", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"pre-integrated, depth sigma 1/3 radius", MS_SSS_PREINTEGRATED, 1, MS_SSS_DENSE, 0, 0.333},
    {"image-optimal", MS_SSS_IMAGE_OPTIMAL, 1, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"image-optimal, 7 taps (default)", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0, TRUTH_SIGMA},
    {"image-optimal, 7 taps, depth sigma 1/3 radius", MS_SSS_IMAGE_OPTIMAL, 1, 7, 0, 0.333},
    {"image-optimal, 17 taps", MS_SSS_IMAGE_OPTIMAL, 1, 17, 0, TRUTH_SIGMA},
    {"SVD rank 3, normalised", MS_SSS_SVD_NORMALISED, 3, MS_SSS_DENSE, 0, TRUTH_SIGMA},
    {"SVD rank 3, normalised, depth sigma 1/3 radius", MS_SSS_SVD_NORMALISED, 3, MS_SSS_DENSE, 0, 0.333},
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
    for (i = 0; i < image_count(&shown); ++i) shown.pixels[i] = scene_tone(picture->pixels[i] * 1.2f / t->peak);
    image_to_srgb(&shown);
    problem = image_write(path, &shown);
    image_free(&shown);
    return problem;
}
#endif
