/* README's pictures of a head of skin. Both sides share one light, traced to round lamps, and the layers of
   examples/demo/scene.h; the walk is a random one through the body.
     portrait heads FOLDER WIDTH HEIGHT WALKS NAME:LEFT:TOP:WIDTH:HEIGHT...
        without.png, taps.png, NAME.png: parts, path-traced; costs: their time, a shell variable
     portrait loop FOLDER WIDTH HEIGHT FRAMES
        frame_00.png...: one lamp goes round; without on the left, 7 taps on the right
   Run by portrait.sh; needs Embree. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/truth.h"
#include "text.h"
#include <time.h>

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
static void lights_of_portrait(scene_light light[SCENE_LIGHTS])
{
    static const float lamp[SCENE_LIGHTS][7] = {{-520, 300, 300, 45, 3.3f, 2.95f, 2.5f},
                                                {210, 20, -260, 25, 4.0f, 3.9f, 3.8f},
                                                {560, 40, 420, 220, 0.05f, 0.065f, 0.09f}};
    int i, c;
    for (i = 0; i < SCENE_LIGHTS; ++i) {
        const float *l = lamp[i];
        light[i].position = scene_v(l[0], l[1], l[2]);
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

/* The scene's layers under k->light, the mesh for the rays, the distances for the surroundings' light. */
static void set_make(set *k, int width, int height, float cell)
{
    scene_camera camera = camera_of_portrait();
    float color[3];
    int c;
    skin_of(k);
    for (c = 0; c < 3; ++c) color[c] = (float)k->reflectance[c];
    need(scene_render_lit(&k->s, SCENE_BUST, &camera, k->light, width, height, color), "scene");
    if (!mesh_make(&k->m, SCENE_BUST, cell) || !scene__grid_make(&k->grid, SCENE_BUST, 2.5f))
        need("out of memory", "mesh");
    k->t = trace_create(&k->m, k->light, SCENE_LIGHTS);
    if (k->t == NULL) need("failed", "Embree");
}

/* The light that arrives on the skin, by 32 rays a lamp: the same as the walk's. */
static void trace_light(set *k)
{
    size_t pixel, count = image_count(&k->s.mask);
    int i, c;
    for (pixel = 0; pixel < count; ++pixel) {
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

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* --- ms_sss.h --- */

/* Light of a lamp that passes through thin parts: the ray has the thickness, which a shadow map of that lamp would
   hold. */
static void through_ear(const set *k, const scene_light *l, const ms_sss_kernel *kernel, size_t pixel, float *light)
{
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

/* Two passes of 7 taps, the default, then light of `lamp` through thin parts; the seconds of the passes. */
static double filter(set *k, const scene_light *lamp, image *light)
{
    static ms_sss_kernel kernel;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_frame frame;
    double radius[3], widest, began;
    size_t size, pixel;
    void *workspace;
    ms_sss_profile_radius(k->profile, 0.99, radius);
    widest = radius[0] > radius[1] ? radius[0] : radius[1];
    if (radius[2] > widest) widest = radius[2];
    if (kernel.tap_count == 0)
        need_ok(ms_sss_kernel_make(&kernel, NULL, k->profile,
                                   widest * k->s.height / (2 * (double)k->s.camera.tan_half_fov * 660), NULL, NULL,
                                   NULL),
                "kernel");
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
    workspace = calloc(size, 1);
    if (light->pixels == NULL || workspace == NULL) need("out of memory", "filter");
    need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), "filter"); /* once to touch the pages */
    began = seconds();
    need_ok(ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, NULL), "filter");
    began = seconds() - began;
    free(workspace);
    for (pixel = 0; pixel < image_count(&k->s.mask); ++pixel)
        if (k->s.mask.pixels[pixel] > 0) through_ear(k, lamp, &kernel, pixel, light->pixels + 3 * pixel);
    return began;
}

/* --- the walk --- */

typedef struct box {
    int left, top, width, height;
} box;

/* Light that leaves at a pixel of the box over the reflectance of a flat surface, in place of filtered light; the
   pixels of skin. */
static int walk(const set *k, image *light, box b, int walks)
{
    int x, y, i, c, pixels = 0;
    for (y = b.top; y < b.top + b.height; ++y)
        for (x = b.left; x < b.left + b.width; ++x) {
            size_t pixel = (size_t)y * (size_t)k->s.width + (size_t)x;
            scene_vec ray = scene_ray(&k->s.camera, k->s.width, k->s.height, (float)x + 0.5f, (float)y + 0.5f), start;
            trace_hit seen = trace_nearest(k->t, k->s.camera.eye, ray, 1e9f);
            if (!(k->s.mask.pixels[pixel] > 0) || seen.triangle < 0) continue;
            start = scene_mad(ray, seen.t, k->s.camera.eye);
            ++pixels;
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
    return pixels;
}

/* --- the pictures --- */

static void save(const image *picture, box b, const char *folder, const char *name)
{
    char path[600];
    image part = image_new(b.width, b.height, picture->channels);
    size_t row = (size_t)b.width * (size_t)picture->channels, y;
    if (part.pixels == NULL) need("out of memory", name);
    for (y = 0; y < (size_t)b.height; ++y)
        memcpy(part.pixels + y * row,
               picture->pixels + ((y + (size_t)b.top) * (size_t)picture->width + (size_t)b.left) * 3,
               row * sizeof(float));
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    need(image_write(path, &part), path);
    image_free(&part);
}

static void heads(const char *folder, int width, int height, int walks, char **parts, int count)
{
    static set k;
    box whole = {0, 0, 0, 0}, b[8];
    image light, picture;
    char path[600], name[8][32];
    double filtered, walked;
    size_t pixel, skin = 0;
    int i, walked_pixels = 0;
    FILE *costs;
    whole.width = width;
    whole.height = height;
    if (count > 8) need("8 at most", "parts");
    for (i = 0; i < count; ++i)
        if (sscanf(parts[i], "%31[a-z]:%d:%d:%d:%d", name[i], &b[i].left, &b[i].top, &b[i].width, &b[i].height) != 5 ||
            b[i].left < 0 || b[i].top < 0 || b[i].width < 1 || b[i].height < 1 || b[i].left + b[i].width > width ||
            b[i].top + b[i].height > height)
            need("not NAME:LEFT:TOP:WIDTH:HEIGHT within the picture", parts[i]);
    lights_of_portrait(k.light);
    set_make(&k, width, height, 0.8f);
    trace_light(&k);
    for (pixel = 0; pixel < image_count(&k.s.mask); ++pixel) skin += k.s.mask.pixels[pixel] > 0;
    need(scene_compose(&k.s, &k.s.irradiance, &picture), "picture");
    save(&picture, whole, folder, "without");
    image_free(&picture);
    filtered = filter(&k, &k.light[1], &light);
    need(scene_compose(&k.s, &light, &picture), "picture");
    save(&picture, whole, folder, "taps");
    image_free(&picture);
    walked = seconds();
    for (i = 0; i < count; ++i) walked_pixels += walk(&k, &light, b[i], walks);
    walked = seconds() - walked;
    need(scene_compose(&k.s, &light, &picture), "picture");
    for (i = 0; i < count; ++i) save(&picture, b[i], folder, name[i]);
    snprintf(path, sizeof path, "%s/costs", folder);
    if ((costs = fopen(path, "w")) == NULL) need("cannot write", path);
    walked *= 1e-3 * (double)skin / (filtered * (walked_pixels + !walked_pixels)); /* thousands, one digit */
    for (i = 0; walked >= 10; ++i) walked /= 10;
    fprintf(costs, "walk_times=\"%.0f", walked);
    while (i-- > 0) fputc('0', costs);
    fputs(",000\"\n", costs);
    need(fclose(costs) ? "cannot write" : NULL, path);
}

/* What a pixel of the head is, whatever the lamp. */
typedef struct spot {
    size_t pixel;
    scene_vec p, smooth, n, to_eye;
    scene_surface surface;
} spot;

/* The lamp's light on each spot by 12 rays, and its reflection, added to the layers that hold the others'. */
static void add_lamp(set *k, const scene_light *lamp, const spot *spots, size_t count)
{
    enum { RAYS = 12 };
    size_t at;
    int i, c;
    for (at = 0; at < count; ++at) {
        const spot *s = &spots[at];
        scene_vec from = scene_mad(s->smooth, 0.4f, s->p), to = scene_sub(lamp->position, from);
        float d2 = scene_dot(to, to), d = sqrtf(d2), seen = 0, cosine, gloss, u, v;
        float least = sqrtf(scene__max(0, 1 - lamp->radius * lamp->radius / d2));
        to = scene_mul(to, 1 / d);
        cosine = scene_dot(s->n, to);
        if (cosine <= 0 || scene_dot(s->smooth, to) <= -lamp->radius / d) continue;
        for (i = 0; i < RAYS; ++i) {
            trace_sampler sampler = sampler_of(s->pixel, i, 1);
            scene_vec direction;
            trace_sample(&sampler, &u, &v);
            direction = trace__around(to, 1 - u * (1 - least), TRACE_TURN * v);
            if (scene_dot(s->smooth, direction) > 0 && !trace_blocked(k->t, from, direction, d - lamp->radius))
                seen += 1.0f / (float)RAYS;
        }
        if (seen <= 0) continue;
        seen *= scene_dot(lamp->position, lamp->position) / d2;
        gloss = scene__gloss(&s->surface, s->n, to, s->to_eye, scene__max(scene_dot(s->n, s->to_eye), 0.03f));
        for (c = 0; c < 3; ++c) {
            k->s.irradiance.pixels[3 * s->pixel + (size_t)c] += seen * cosine * lamp->power[c] / 3.14159265f;
            k->s.specular.pixels[3 * s->pixel + (size_t)c] += seen * gloss * lamp->power[c];
        }
    }
}

static void loop(const char *folder, int width, int height, int frames)
{
    static set k;
    static const float power[3] = {2.3f, 2.1f, 1.85f}, ink[3] = {0.9f, 0.9f, 0.88f};
    static const char *const words[2] = {"without", "ms_sss.h, 7 taps"};
    const int left = width * 9 / 100, shown = width * 84 / 100; /* the columns with the head */
    scene_light lamp;
    image irradiance, specular, both;
    box whole = {0, 0, 0, 0};
    char name[32];
    spot *spots;
    size_t pixel, total = (size_t)width * (size_t)height, count = 0, y;
    int frame, i;
    float color[3];
    whole.width = 2 * shown;
    whole.height = height;
    lights_of_portrait(k.light);
    for (i = 0; i < 3; ++i) k.light[0].power[i] = k.light[1].power[i] = 0; /* the fill stays */
    set_make(&k, width, height, 0.8f);
    for (i = 0; i < 3; ++i) color[i] = (float)k.reflectance[i];
    irradiance = image_new(width, height, 3);
    specular = image_new(width, height, 3);
    both = image_new(2 * shown, height, 3);
    spots = (spot *)malloc(total * sizeof *spots);
    if (!irradiance.pixels || !specular.pixels || !both.pixels || !spots) need("out of memory", "loop");
    memcpy(irradiance.pixels, k.s.irradiance.pixels, 3 * total * sizeof(float));
    memcpy(specular.pixels, k.s.specular.pixels, 3 * total * sizeof(float));
    for (pixel = 0; pixel < total; ++pixel) {
        spot *s = &spots[count];
        scene_vec ray = scene_ray(&k.s.camera, width, height, (float)(pixel % (size_t)width) + 0.5f,
                                  (float)(pixel / (size_t)width) + 0.5f);
        scene_hit hit = scene__trace(&k.grid, k.s.camera.eye, ray);
        if (hit.what == SCENE_BACKDROP) continue;
        s->pixel = pixel;
        s->p = scene_mad(ray, hit.t, k.s.camera.eye);
        s->n = s->smooth = scene_gradient(SCENE_BUST, s->p, 0.02f);
        s->to_eye = scene_mul(ray, -1);
        if (hit.what == SCENE_OBJECT) s->n = scene__roughen(s->smooth, s->p);
        s->surface = hit.what == SCENE_OBJECT ? scene__skin(s->p, color) : scene__eye(s->p);
        ++count;
    }
    lamp.radius = 45;
    for (i = 0; i < 3; ++i) lamp.power[i] = power[i];
    for (frame = 0; frame < frames; ++frame) {
        double turn = 2 * 3.14159265358979 * (frame + frames / 8) / frames; /* from the left, before the face */
        image light, side[2];
        lamp.position = scene_v(-560 * (float)cos(turn), 70, 560 * (float)sin(turn));
        memcpy(k.s.irradiance.pixels, irradiance.pixels, 3 * total * sizeof(float));
        memcpy(k.s.specular.pixels, specular.pixels, 3 * total * sizeof(float));
        add_lamp(&k, &lamp, spots, count);
        filter(&k, &lamp, &light);
        need(scene_compose(&k.s, &k.s.irradiance, &side[0]), "frame");
        need(scene_compose(&k.s, &light, &side[1]), "frame");
        for (i = 0; i < 2; ++i) {
            for (y = 0; y < (size_t)height; ++y)
                memcpy(both.pixels + 3 * (size_t)shown * (2 * y + (size_t)i),
                       side[i].pixels + 3 * ((size_t)width * y + (size_t)left), 3 * (size_t)shown * sizeof(float));
            image_text(&both, i * shown + 8, 8, words[i], height / 18, ink);
        }
        snprintf(name, sizeof name, "frame_%02d", frame);
        save(&both, whole, folder, name);
        image_free(&light);
        image_free(&side[0]);
        image_free(&side[1]);
    }
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    int width = argc > 4 ? atoi(argv[3]) : 0, height = argc > 4 ? atoi(argv[4]) : 0, n = argc > 5 ? atoi(argv[5]) : 0;
    int looped = strcmp(what, "loop") == 0;
    if (argc < 6 || (looped ? argc != 6 : strcmp(what, "heads") != 0)) {
        fprintf(stderr,
                "usage: portrait heads FOLDER WIDTH HEIGHT WALKS NAME:LEFT:TOP:WIDTH:HEIGHT...\n"
                "       portrait loop FOLDER WIDTH HEIGHT FRAMES\n");
        return 2;
    }
    if (width < 16 || height < 16 || width > 8192 || height > 8192) need("16 to 8192 expected", "size");
    if (n < 1 || n > 100000) need("1 to 100000 expected", looped ? "frames" : "walks");
    if (looped) loop(argv[2], width, height, n);
    else heads(argv[2], width, height, n, argv + 6, argc - 6);
    return 0;
}
