/* README's head of skin, whose lamps stand to the left and behind the ear: without scattering, by ms_sss.h, and by a
   random walk through the body. All three share one light, traced to round lamps, and the layers of
   examples/demo/scene.h. portrait without|taps OUT.png WIDTH HEIGHT [TURN]                    TURN: of the lamps around
   the head, in degrees portrait walk OUT.png WIDTH HEIGHT LEFT TOP RIGHT BOTTOM WALKS       a part of the picture,
   path-traced Run by portrait.sh; needs Embree. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/truth.h"

static void need(const char *problem, const char *where)
{
    if (problem == NULL) return;
    fprintf(stderr, "portrait: %s: %s\n", where, problem);
    exit(1);
}

static void need_ok(ms_status status, const char *where) { need(status ? ms_status_string(status) : NULL, where); }

/* --- the set --- */

static scene_camera camera_of_portrait(void)
{
    scene_camera c = scene_camera_of(SCENE_BUST);
    float yaw = 0.52f, pitch = 0.02f;
    c.tan_half_fov = 0.176f; /* 20 degrees */
    c.back = scene_v(sinf(yaw) * cosf(pitch), sinf(pitch), cosf(yaw) * cosf(pitch));
    c.right = scene_normalize(scene_cross(scene_v(0, 1, 0), c.back));
    c.up = scene_cross(c.back, c.right);
    c.eye = scene_mad(c.back, 720, scene_v(6, -8, 10));
    return c;
}

/* Key: warm, to the left, so that its shadow's border crosses nose and cheek. Behind: through the ear. Fill: weak. */
static void lights_of_portrait(scene_light light[SCENE_LIGHTS], double turn_degrees)
{
    static const float lamp[SCENE_LIGHTS][7] = {{-520, 300, 300, 45, 3.3f, 2.95f, 2.5f},
                                                {210, 20, -260, 25, 4.0f, 3.9f, 3.8f},
                                                {560, 40, 420, 220, 0.05f, 0.065f, 0.09f}};
    float turn = (float)(turn_degrees * (3.14159265358979 / 180)), sine = sinf(turn), cosine = cosf(turn);
    int i, c;
    for (i = 0; i < SCENE_LIGHTS; ++i) {
        const float *l = lamp[i];
        light[i].position = scene_v(l[0], l[1], l[2]);
        if (i == 0) light[i].position = scene_v(cosine * l[0] - sine * l[2], l[1], sine * l[0] + cosine * l[2]);
        light[i].radius = l[3];
        for (c = 0; c < 3; ++c) light[i].power[c] = l[4 + c];
    }
}

typedef struct set {
    scene s;
    mesh m;
    tracer *t;
    scene_light light[SCENE_LIGHTS];
    scene_grid grid;
    ms_sss_profile *profile;
    double reflectance[3];
    float mu_s[3], mu_a[3]; /* 1/mm */
} set;

/* Light of the surroundings over pi at p, as in scene.h. */
static void ambient(const set *k, scene_vec p, scene_vec n, scene_vec smooth, float out[3])
{
    static const float sky[3] = {0.045f, 0.054f, 0.068f}, ground[3] = {0.026f, 0.022f, 0.020f};
    float open = scene__openness(&k->grid, p, smooth);
    int c;
    for (c = 0; c < 3; ++c) out[c] += open * scene__mix(ground[c], sky[c], 0.5f + 0.5f * n.y);
}

/* What arrives at p by one point of each lamp. */
static void arrives(const set *k, trace_sampler *sampler, scene_vec p, scene_vec smooth, float out[3])
{
    scene_vec n = scene__roughen(smooth, p);
    int i, c;
    out[0] = out[1] = out[2] = 0;
    ambient(k, p, n, smooth, out);
    for (i = 0; i < SCENE_LIGHTS; ++i) {
        const scene_light *l = &k->light[i];
        scene_vec from = scene_mad(smooth, 0.4f, p), to = scene_sub(l->position, from), direction;
        float d2 = scene_dot(to, to), d = sqrtf(d2), u, v, least, cosine;
        trace_sample(sampler, &u, &v);
        least = sqrtf(scene__max(0, 1 - l->radius * l->radius / d2));
        direction = trace__around(scene_mul(to, 1 / d), 1 - u * (1 - least), TRACE_TURN * v);
        cosine = scene_dot(n, direction);
        if (cosine <= 0 || scene_dot(smooth, direction) <= 0 || trace_blocked(k->t, from, direction, d - l->radius))
            continue;
        for (c = 0; c < 3; ++c)
            out[c] += l->power[c] * cosine * scene_dot(l->position, l->position) / (d2 * 3.14159265f);
    }
}

static trace_sampler sampler_of(size_t pixel, int index, uint32_t seed)
{
    trace_sampler s;
    s.seed = trace__hash(trace__hash((uint32_t)pixel) ^ seed);
    s.index = (uint32_t)index;
    s.pair = 0;
    return s;
}

static scene_vec position_of(const set *k, size_t pixel)
{
    scene_vec ray = scene_ray(&k->s.camera, k->s.width, k->s.height, (float)(pixel % (size_t)k->s.width) + 0.5f,
                              (float)(pixel / (size_t)k->s.width) + 0.5f);
    return scene_mad(ray, -k->s.depth.pixels[pixel] / scene_dot(ray, k->s.camera.back), k->s.camera.eye);
}

/* Skin with the color and the mean free path of skin1 (thesis 5.9.7), and the index of air, which the walk expects:
   its coefficients in 1/mm and its flat profile by the same walk. */
static void skin_of(set *k)
{
    const ms_mcml_material *skin1 = ms_mcml_find_material("skin1");
    ms_mcml_medium medium[3], matched;
    ms_mcml_profile rings;
    int c;
    for (c = 0; c < 3; ++c) medium[c] = ms_mcml_material_medium(skin1, c);
    need_ok(ms_mcml_profile_make(&rings, medium, 3, NULL, NULL), "profile");
    for (c = 0; c < 3; ++c) {
        double path_mm = 1 / (medium[c].mu_a_per_mm + medium[c].mu_s_per_mm);
        need_ok(ms_mcml_medium_from_color(rings.total[c], path_mm, MS_MCML_MEAN_FREE_PATH, 1, &matched, NULL),
                "medium");
        k->mu_s[c] = (float)matched.mu_s_per_mm;
        k->mu_a[c] = (float)matched.mu_a_per_mm;
    }
    ms_mcml_profile_destroy(&rings);
    need_ok(truth_profile(k->mu_s, k->mu_a, 1 << 18, &k->profile), "profile");
    ms_sss_profile_reflectance(k->profile, k->reflectance);
}

static void set_make(set *k, int width, int height, double turn_degrees, float cell)
{
    scene_camera camera = camera_of_portrait();
    float color[3];
    size_t pixel, count = (size_t)width * (size_t)height;
    int c, i;
    skin_of(k);
    for (c = 0; c < 3; ++c) color[c] = (float)k->reflectance[c];
    lights_of_portrait(k->light, turn_degrees);
    need(scene_render_lit(&k->s, SCENE_BUST, &camera, k->light, width, height, color), "scene");
    if (!mesh_make(&k->m, SCENE_BUST, cell) || !scene__grid_make(&k->grid, SCENE_BUST, 2.5f))
        need("out of memory", "mesh");
    k->t = trace_create(&k->m, k->light, SCENE_LIGHTS);
    if (k->t == NULL) need("failed", "Embree");
    for (pixel = 0; pixel < count; ++pixel) { /* the same light as the walk's */
        scene_vec p, smooth;
        float *out = k->s.irradiance.pixels + 3 * pixel, e[3];
        if (!(k->s.mask.pixels[pixel] > 0)) continue;
        p = position_of(k, pixel);
        smooth = scene_gradient(SCENE_BUST, p, 0.02f);
        out[0] = out[1] = out[2] = 0;
        for (i = 0; i < 32; ++i) {
            trace_sampler s = sampler_of(pixel, i, 1);
            arrives(k, &s, p, smooth, e);
            for (c = 0; c < 3; ++c) out[c] += e[c] / 32;
        }
    }
}

/* --- ms_sss.h --- */

/* Light of the lamp behind that passes through thin parts: what a shadow map of that lamp would hold. */
static void through_ear(const set *k, const ms_sss_kernel *kernel, size_t pixel, float *light)
{
    const scene_light *l = &k->light[1];
    scene_vec p = position_of(k, pixel), away = scene_sub(p, l->position), direction = scene_normalize(away), n, entry;
    trace_hit hit = trace_nearest(k->t, l->position, direction, 1e9f);
    float normal[3], entry_normal[3], to_light[3], in[3], out[3];
    int c;
    if (hit.triangle < 0 || hit.t > scene_length(away) - 0.05f) return;
    n = scene_gradient(SCENE_BUST, p, 0.02f);
    entry = scene_mad(direction, hit.t, l->position);
    entry = scene_gradient(SCENE_BUST, entry, 0.02f);
    normal[0] = n.x, normal[1] = n.y, normal[2] = n.z;
    entry_normal[0] = entry.x, entry_normal[1] = entry.y, entry_normal[2] = entry.z;
    to_light[0] = -direction.x, to_light[1] = -direction.y, to_light[2] = -direction.z;
    for (c = 0; c < 3; ++c) in[c] = l->power[c] * scene_dot(l->position, l->position) / (hit.t * hit.t * 3.14159265f);
    ms_sss_transmission(kernel, scene_length(away) - hit.t, normal, entry_normal, to_light, in, out);
    for (c = 0; c < 3; ++c) light[c] = scene__max(light[c], out[c]);
}

static void filter(set *k, image *light)
{
    static ms_sss_kernel kernel;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_frame frame;
    double radius[3], widest;
    size_t size, pixel;
    void *workspace;
    ms_sss_profile_radius(k->profile, 0.99, radius);
    widest = radius[0] > radius[1] ? radius[0] : radius[1];
    if (radius[2] > widest) widest = radius[2];
    need_ok(ms_sss_kernel_make(&kernel, NULL, k->profile,
                               widest * k->s.height / (2 * (double)k->s.camera.tan_half_fov * 660), NULL, NULL, NULL),
            "kernel"); /* 7 taps: the default */
    *light = image_new(k->s.width, k->s.height, 3);
    memset(&frame, 0, sizeof frame);
    frame.width = k->s.width;
    frame.height = k->s.height;
    frame.input = ms_sss_interleaved(k->s.irradiance.pixels, 3);
    frame.output = ms_sss_interleaved(light->pixels, 3);
    frame.depth = ms_sss_map(k->s.depth.pixels, 1);
    frame.strength = ms_sss_map(k->s.mask.pixels, 1);
    options.fov_degrees = 2 * atanf(k->s.camera.tan_half_fov) * (180 / 3.14159265f);
    size = ms_sss_filter_workspace(k->s.width, k->s.height, &kernel, 1, &options);
    workspace = malloc(size);
    if (light->pixels == NULL || workspace == NULL) need("out of memory", "filter");
    need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), "filter");
    free(workspace);
    for (pixel = 0; pixel < image_count(&k->s.mask); ++pixel)
        if (k->s.mask.pixels[pixel] > 0) through_ear(k, &kernel, pixel, light->pixels + 3 * pixel);
}

/* --- the walk --- */

/* Light that leaves at the pixel over the reflectance of a flat surface, in place of filtered light. */
static void walk(set *k, image *light, const int box[4], int walks)
{
    int x, y, i, c;
    *light = image_new(k->s.width, k->s.height, 3);
    if (light->pixels == NULL) need("out of memory", "walk");
    memcpy(light->pixels, k->s.irradiance.pixels, 3 * image_count(&k->s.mask) * sizeof(float));
    for (y = box[1]; y < box[3]; ++y)
        for (x = box[0]; x < box[2]; ++x) {
            size_t pixel = (size_t)y * (size_t)k->s.width + (size_t)x;
            scene_vec ray = scene_ray(&k->s.camera, k->s.width, k->s.height, (float)x + 0.5f, (float)y + 0.5f), start;
            trace_hit seen = trace_nearest(k->t, k->s.camera.eye, ray, 1e9f);
            if (!(k->s.mask.pixels[pixel] > 0) || seen.triangle < 0) continue;
            start = scene_mad(ray, seen.t, k->s.camera.eye);
            for (c = 0; c < 3; ++c) {
                double sum = 0;
                for (i = 0; i < walks; ++i) {
                    trace_sampler s = sampler_of(pixel, i, 7 + (uint32_t)c);
                    scene_vec p = start, out = seen.normal, smooth;
                    float e[3], weight = trace__walk(k->t, &s, k->mu_s[c], k->mu_a[c], &p, &out);
                    if (weight <= 0) continue;
                    s.pair = TRACE_LAMP_PAIR;
                    smooth = scene_gradient(SCENE_BUST, p, 0.02f);
                    if (scene_dot(smooth, out) < 0.2f) smooth = out;
                    arrives(k, &s, p, smooth, e);
                    sum += (double)(weight * e[c]);
                }
                light->pixels[3 * pixel + (size_t)c] = (float)(sum / walks / k->reflectance[c]);
            }
        }
}

int main(int argc, char **argv)
{
    static set k;
    image light, picture, part;
    int width, height, box[4], x, y, i;
    const char *what = argc > 1 ? argv[1] : "";
    int walks = strcmp(what, "walk") == 0;
    if (!(walks ? argc == 10
                : (argc == 5 || argc == 6) && (strcmp(what, "taps") == 0 || strcmp(what, "without") == 0))) {
        fprintf(stderr,
                "usage: portrait without|taps OUT.png WIDTH HEIGHT [TURN]\n"
                "       portrait walk OUT.png WIDTH HEIGHT LEFT TOP RIGHT BOTTOM WALKS\n");
        return 2;
    }
    width = atoi(argv[3]);
    height = atoi(argv[4]);
    if (width < 16 || height < 16 || width > 8192 || height > 8192) need("16 to 8192 expected", "size");
    set_make(&k, width, height, argc == 6 ? atof(argv[5]) : 0, 0.8f);
    box[0] = box[1] = 0;
    box[2] = width;
    box[3] = height;
    if (walks) {
        for (i = 0; i < 4; ++i) box[i] = atoi(argv[5 + i]);
        if (box[0] < 0 || box[1] < 0 || box[2] > width || box[3] > height || box[0] >= box[2] || box[1] >= box[3])
            need("outside the picture", "part");
        walk(&k, &light, box, atoi(argv[9]));
    } else if (strcmp(what, "taps") == 0) filter(&k, &light);
    else light = k.s.irradiance;
    need(scene_compose(&k.s, &light, &picture), "picture");
    part = image_new(box[2] - box[0], box[3] - box[1], 3);
    if (part.pixels == NULL) need("out of memory", "picture");
    for (y = 0; y < part.height; ++y)
        for (x = 0; x < 3 * part.width; ++x)
            part.pixels[3 * y * part.width + x] = picture.pixels[3 * ((y + box[1]) * width + box[0]) + x];
    need(image_write(argv[2], &part), argv[2]);
    return 0;
}
