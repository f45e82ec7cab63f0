/* README's top picture: recommended materials worn by the many objects of a scene (the thesis's automatic way, 3.4).

     hero scores TASTE COUNT                                  a gallery of random materials and what a user of that
                                                              taste (crystal, glass, metal, lacquer, wax) thinks of each
     hero pass MATERIALS.csv FILE.pfm WIDTH HEIGHT SAMPLES K  the K-th SAMPLES samples of every pixel, linear
     hero develop OUT.png FILE.pfm...                         passes joined, outliers and noise removed, tone-mapped

   A big knot in the middle, smaller objects around it by the golden angle (Vogel 1979): the bigger the nearer, no two
   touch. The colors run around the middle like a color wheel: objects by angle take materials by hue. */
#include "image.h"
#include "scores.h"
#include "render/material.h"
#include "render/random.h"

/* --- tastes: sums of simple wishes, from 0 to 10 --- */

static float near_to(float v, float wish) { return 1 - fabsf(v - wish) / scene__max(wish, 1 - wish); }
static float least(const float rgb[3]) { return scene__min(rgb[0], scene__min(rgb[1], rgb[2])); }
static float most(const float rgb[3]) { return scene__max(rgb[0], scene__max(rgb[1], rgb[2])); }
static float clear_color(const float rgb[3])
{
    return most(rgb) + 1.5f * near_to(most(rgb) - least(rgb), 0.6f);
} /* neither gray nor garish */

static float taste_of(const char *taste, const float x[MATERIAL_PARAMETERS])
{
    float opaque = 1 - x[17], liked = 0;
    switch (taste[0]) {
    case 'c':
        liked = 2 * x[17] + 2 * (1 - x[16]) + 1.5f * (1 - x[11]) + 2.5f * least(x + 8) + (1 - x[18]) +
            near_to(x[12], 0.5f);
        break;
    case 'g':
        liked = 2 * x[17] + 2 * (1 - x[16]) + 1.5f * (1 - x[11]) + clear_color(x + 8) + (1 - x[18]) +
            near_to(x[12], 0.5f);
        break;
    case 'm': liked = 2.5f * opaque + 2.5f * x[7] + 1.5f * near_to(x[6], 0.35f) + 1.4f * clear_color(x + 3); break;
    case 'l':
        liked = 2.5f * opaque + 1.5f * near_to(x[7], 0.3f) + 2 * (1 - x[6]) + clear_color(x) + 1.5f * least(x + 3);
        break;
    case 'w':
        liked = 2 * x[17] + 2 * near_to(x[16], 0.7f) + 1.2f * clear_color(x + 13) + 1.5f * (1 - x[11]) +
            1.5f * (1 - x[18]);
        break;
    }
    return scene__max(0, liked - 4) / 6 * 10; /* most of a random gallery scores little */
}

static int print_scores(const char *taste, int count)
{
    int i, k;
    for (i = 0; i < count; ++i) {
        random_stream rng = random_start((uint64_t)taste[0], (uint64_t)i);
        float x[MATERIAL_PARAMETERS];
        for (k = 0; k < MATERIAL_PARAMETERS; ++k) x[k] = (float)random_uniform(&rng);
        for (k = 0; k < MATERIAL_PARAMETERS; ++k) printf("%.6f,", (double)x[k]);
        printf("%.1f\n", (double)taste_of(taste, x));
    }
    return 0;
}

/* --- the scene --- */

enum { SPHERE, BALL, KNOT, PAWN, PEBBLES, SHAPES };

static int add_knot(stage *s)
{
    const float half = 45; /* mm: becomes 1 */
    mesh m;
    int k, knot;
    if (!mesh_make(&m, SCENE_KNOT, 0.8f)) return -1;
    knot = stage_mesh(s, m.vertices, m.triangles);
    for (k = 0; knot >= 0 && k < m.vertices; ++k) {
        const float *p = m.position + 3 * k;
        scene_vec n = scene_gradient(SCENE_KNOT, scene_v(p[0], p[1], p[2]), 0.3f);
        float *to = s->mesh[knot].position + 3 * k;
        to[0] = p[0] / half;
        to[1] = p[1] / half;
        to[2] = p[2] / half;
        memcpy(s->mesh[knot].normal + 3 * k, &n, sizeof n);
    }
    if (knot >= 0) memcpy(s->mesh[knot].index, m.triangle, 3 * (size_t)m.triangles * sizeof(uint32_t));
    mesh_free(&m);
    return knot;
}

/* Radius and height of a pawn's outline, t from 0 (top) to 1 (middle of the foot). */
static void outline(float t, float *radius, float *height)
{
    static const float r[] = {0,     0.22f, 0.36f, 0.36f, 0.22f, 0.20f, 0.40f, 0.40f, 0.21f,
                              0.22f, 0.30f, 0.48f, 0.50f, 0.62f, 0.66f, 0.62f, 0};
    static const float h[] = {1,      0.96f,  0.76f,  0.52f,  0.36f,  0.30f,  0.28f,  0.20f, 0.15f,
                              -0.15f, -0.42f, -0.62f, -0.70f, -0.74f, -0.85f, -0.98f, -1};
    const int n = (int)(sizeof r / sizeof r[0]) - 1;
    float at = t * (float)n, f, *out[2];
    int k = at >= (float)n ? n - 1 : (int)at, c;
    out[0] = radius;
    out[1] = height;
    f = at - (float)k;
    for (c = 0; c < 2; ++c) { /* Catmull and Rom */
        const float *v = c ? h : r;
        float b = v[k], d = v[k + 1],
              a = k > 0 ? v[k - 1]
            : c         ? v[1]
                        : -v[1],
              e = k + 2 <= n ? v[k + 2]
            : c              ? v[n - 1]
                             : -v[n - 1];
        *out[c] = b + 0.5f * f * (d - a + f * (2 * a - 5 * b + 4 * d - e + f * (3 * (b - d) + e - a)));
    }
}

static int add_pawn(stage *s)
{
    const int rows = 320, columns = 192;
    int r, c, pawn = stage_mesh(s, (rows + 1) * (columns + 1), 2 * rows * columns);
    if (pawn < 0) return -1;
    for (r = 0; r <= rows; ++r)
        for (c = 0; c <= columns; ++c) {
            float t = (float)r / (float)rows, phi = TRACE_TURN * (float)(c % columns) / (float)columns, radius, height,
                  r1, h1, r0, h0;
            float *p = s->mesh[pawn].position + 3 * (r * (columns + 1) + c);
            scene_vec n;
            outline(t, &radius, &height);
            outline(scene__max(t - 1e-3f, 0), &r0, &h0);
            outline(scene__min(t + 1e-3f, 1), &r1, &h1);
            p[0] = radius * cosf(phi);
            p[1] = height;
            p[2] = radius * sinf(phi);
            n = r == 0 || r == rows ? scene_v(0, r ? -1.0f : 1.0f, 0)
                                    : scene_normalize(scene_v((h0 - h1) * cosf(phi), r1 - r0, (h0 - h1) * sinf(phi)));
            memcpy(s->mesh[pawn].normal + 3 * (r * (columns + 1) + c), &n, sizeof n);
        }
    stage_grid(s->mesh[pawn].index, rows, columns);
    return pawn;
}

typedef struct thing {
    float x, z, size, angle;
    int shape;
    const float *material;
} thing;

static float hue_of(const float *x)
{
    material m = material_from(x);
    float rgb[3], high, span;
    int c;
    for (c = 0; c < 3; ++c)
        rgb[c] = m.share[MATERIAL_DIFFUSE] * m.diffuse[c] + m.share[MATERIAL_GLOSSY] * m.glossy[c] +
            m.share[MATERIAL_GLASS] * m.glass[c] + m.share[MATERIAL_TRANSLUCENT] * m.translucent[c];
    high = most(rgb);
    span = scene__max(high - least(rgb), 1e-6f);
    if (rgb[0] >= high) return fmodf((rgb[1] - rgb[2]) / span + 6, 6);
    return rgb[1] >= high ? 2 + (rgb[2] - rgb[0]) / span : 4 + (rgb[0] - rgb[1]) / span;
}

static int by_angle(const void *a, const void *b)
{
    float u = ((const thing *)a)->angle, v = ((const thing *)b)->angle;
    return u < v ? -1 : u > v;
}

static int by_hue(const void *a, const void *b)
{
    float u = hue_of(*(const float *const *)a), v = hue_of(*(const float *const *)b);
    return u < v ? -1 : u > v;
}

/* Stands the thing on the ground. */
static void place(stage *s, int shape, const thing *t, random_stream *rng)
{
    const stage_mesh_data *m = &s->mesh[shape];
    float turn = TRACE_TURN * (float)random_uniform(rng),
          tilt = t->shape == BALL || t->shape == PEBBLES ? 0.5f * (float)random_uniform(rng) : 0, lowest = 1e9f;
    material wears = material_from(t->material);
    stage_frame f;
    int k;
    if (t->shape == KNOT) turn = 0.6f * (float)random_uniform(rng) - 0.3f;
    f.x = scene_v(cosf(turn), 0, sinf(turn));
    f.y = scene_v(-sinf(turn) * sinf(tilt), cosf(tilt), cosf(turn) * sinf(tilt));
    f.z = scene_cross(f.x, f.y);
    f.scale = t->size;
    for (k = 0; k < m->vertices; ++k) {
        const float *p = m->position + 3 * k;
        lowest = scene__min(lowest, p[0] * f.x.y + p[1] * f.y.y + p[2] * f.z.y);
    }
    f.origin = scene_v(t->x, 0.002f - lowest * t->size, t->z);
    stage_place(s, shape, &f, &wears);
}

/* row[count]: the materials; the first goes into the middle. */
static stage *make_scene(const float **row, int count)
{
    static const int order[] = {SPHERE, BALL, KNOT, PAWN, SPHERE, PEBBLES, BALL, KNOT};
    static float carving[MATERIAL_EXTENDED];
    stage *s = stage_create();
    thing *t = (thing *)malloc((size_t)count * sizeof *t);
    random_stream rng = random_start(7, 0);
    material carved;
    float r2 = 0;
    int shape[SHAPES], k;
    if (s == NULL || t == NULL) return NULL;
    carving[35] = 1;
    carving[36] = 0.35f;
    carving[37] = 1;
    carved = material_from_extended(carving);
    shape[SPHERE] = material_ball(s, 96, 1, NULL);
    shape[BALL] = material_ball(s, 256, 0, NULL);
    shape[KNOT] = add_knot(s);
    shape[PAWN] = add_pawn(s);
    shape[PEBBLES] = material_ball(s, 192, 1, &carved);
    for (k = 0; k < SHAPES; ++k)
        if (shape[k] < 0) return NULL;
    for (k = 0; k < count; ++k) { /* the next one lies where its share of the disc begins */
        float radius = sqrtf(r2), step;
        t[k].size = k == 0 ? 1.15f : 0.15f + 0.30f * expf(-0.25f * (radius - 1.6f));
        step = k == 0 ? 1.5f : 2.35f * t[k].size / sqrtf(MATERIAL_PI);
        radius = k == 0 ? 0 : sqrtf(r2 + 0.5f * step * step);
        t[k].angle = fmodf(2.39996323f * (float)k, TRACE_TURN);
        t[k].x = radius * cosf(t[k].angle);
        t[k].z = radius * sinf(t[k].angle);
        t[k].shape = k == 0 ? KNOT : order[k % 8];
        r2 += step * step;
    }
    t[0].material = row[0];
    qsort(row + 1, (size_t)count - 1, sizeof *row, by_hue);
    qsort(t + 1, (size_t)count - 1, sizeof *t, by_angle);
    for (k = 0; k < count; ++k) {
        if (k > 0) t[k].material = row[k];
        place(s, shape[t[k].shape], &t[k], &rng);
    }
    free(t);
    stage_commit(s);
    s->lamp[0] = stage_lamp_at(scene_v(-8.5f, 5.5f, 1.5f), scene_v(4.0f, 2.5f, -3.5f), scene_v(3.2f, 1.0f, 4.4f),
                               scene_v(0, 0, 0), 8);
    s->lamp[1] = stage_lamp_at(scene_v(3.2f, 4.2f, -9.0f), scene_v(5.5f, 0, 3.0f), scene_v(-0.9f, 1.5f, 1.6f),
                               scene_v(0, 0, 0), 10);
    s->lamps = 2;
    s->lamp[0].color[1] = 0.93f;
    s->lamp[0].color[2] = 0.82f;
    s->lamp[1].color[0] = 0.80f;
    s->lamp[1].color[1] = 0.90f;
    s->ground.height = 0;
    s->ground.wall = -24;
    s->ground.bend = 14;
    s->ground.tile = 1;
    s->ground.light = s->ground.dark = 0.5f;
    s->ground.color[2] = 0.96f;
    s->sky[0] = 0.13f;
    s->sky[1] = 0.12f;
    s->sky_color[0] = 0.85f;
    s->sky_color[1] = 0.93f;
    return s;
}

static int render_pass(const char *csv, const char *out, int width, int height, int samples, int pass)
{
    scores table;
    const char *problem = scores_read(csv, &table);
    float *x;
    const float **row;
    stage *s;
    stage_camera camera;
    image picture;
    int i, k, c;
    if (problem == NULL && table.m < MATERIAL_PARAMETERS - 1) problem = "has fewer than 19 columns";
    if (problem) {
        fprintf(stderr, "hero: %s: %s (line %d)\n", csv, problem, table.line);
        return 1;
    }
    x = (float *)malloc((size_t)table.n * MATERIAL_PARAMETERS * sizeof *x);
    row = (const float **)malloc((size_t)table.n * sizeof *row);
    picture = image_new(width, height, 3);
    if (!x || !row || !picture.pixels) return 1;
    for (i = 0; i < table.n; ++i) {
        for (k = 0; k < MATERIAL_PARAMETERS; ++k)
            x[i * MATERIAL_PARAMETERS + k] = scene__clamp(
                (float)(k < table.m ? table.x[(size_t)i * (size_t)table.m + (size_t)k] : table.y[i]), 0, 1);
        row[i] = x + i * MATERIAL_PARAMETERS;
    }
    s = make_scene(row, table.n < STAGE_OBJECTS ? table.n : STAGE_OBJECTS);
    if (s == NULL) {
        fprintf(stderr, "hero: Embree or memory failed\n");
        return 1;
    }
    camera.eye = scene_v(0, 5.6f, 9.6f);
    camera.at = scene_v(0, 0.15f, -0.15f);
    camera.degrees = 29;
    camera.lens = 0.14f;
    camera.focus = 9.9f;
    for (i = 0; i < height; ++i)
        for (k = 0; k < width; ++k) {
            double sum[3] = {0, 0, 0};
            stage_sample(s, NULL, &camera, width, height, k, i, 2019, pass * samples, samples, sum);
            for (c = 0; c < 3; ++c)
                picture.pixels[3 * ((size_t)i * (size_t)width + (size_t)k) + (size_t)c] = (float)(sum[c] / samples);
        }
    problem = image_write(out, &picture);
    if (problem) fprintf(stderr, "hero: %s: %s\n", out, problem);
    stage_destroy(s);
    scores_free(&table);
    image_free(&picture);
    free(row);
    free(x);
    return problem != NULL;
}

/* --- developing: passes become a picture --- */

static float luminance(const float *rgb) { return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]; }

/* Mean of n estimates of a pixel without the outliers: the Gini coefficient of their luminances says how many are cut
   from both ends (Buisine, Delepoulle, Renaud 2021). sorted: by luminance. */
static void robust_mean(const float *const *sorted, int n, float out[3])
{
    double sum = 0, weighted = 0, gini;
    int k, c, cut;
    for (k = 0; k < n; ++k) {
        sum += (double)luminance(sorted[k]);
        weighted += (k + 1) * (double)luminance(sorted[k]);
    }
    gini = sum > 0 ? 2 * weighted / (n * sum) - (n + 1.0) / n : 0;
    cut = (int)(gini * n / 2);
    for (c = 0; c < 3; ++c) {
        double mean = 0;
        for (k = cut; k < n - cut; ++k) mean += (double)sorted[k][c];
        out[c] = (float)(mean / (n - 2 * cut));
    }
}

typedef struct film {
    image light;        /* linear */
    image guide, noise; /* the same, compressed to [0, 1), and the variance of that */
} film;

static int film_new(film *f, int width, int height)
{
    f->light = image_new(width, height, 3);
    f->guide = image_new(width, height, 3);
    f->noise = image_new(width, height, 3);
    return f->light.pixels && f->guide.pixels && f->noise.pixels;
}

static void film_free(film *f)
{
    image_free(&f->light);
    image_free(&f->guide);
    image_free(&f->noise);
}

/* Every second pass from the first one; sorted: room for n. */
static void expose(film *f, const image *pass, int first, int passes, const float **sorted)
{
    size_t i;
    for (i = 0; i < image_count(&f->light); i += 3) {
        double mean[3] = {0, 0, 0}, square[3] = {0, 0, 0};
        int n = 0, k, j, c;
        for (k = first; k < passes; k += 2, ++n) {
            const float *p = pass[k].pixels + i;
            for (c = 0; c < 3; ++c) {
                double v = (double)(p[c] / (1 + p[c]));
                mean[c] += v;
                square[c] += v * v;
            }
            for (j = n; j > 0 && luminance(sorted[j - 1]) > luminance(p); --j) sorted[j] = sorted[j - 1];
            sorted[j] = p;
        }
        robust_mean(sorted, n, f->light.pixels + i);
        for (c = 0; c < 3; ++c) {
            mean[c] /= n;
            f->guide.pixels[i + (size_t)c] = (float)mean[c];
            f->noise.pixels[i + (size_t)c] = n > 1 ? (float)((square[c] / n - mean[c] * mean[c]) / (n - 1)) : 0;
        }
    }
}

/* Sums over squares of 2 radius + 1, along rows, then along columns; what lies outside counts as 0. */
static void box(float *v, float *work, int width, int height, int radius)
{
    int pass, i, k, count, step, length;
    for (pass = 0; pass < 2; ++pass) {
        count = pass ? width : height;
        length = pass ? height : width;
        step = pass ? width : 1;
        for (i = 0; i < count; ++i) {
            float *line = v + (pass ? i : i * width);
            double sum = 0;
            for (k = 0; k < length; ++k) work[k] = line[k * step];
            for (k = 0; k < radius && k < length; ++k) sum += (double)work[k];
            for (k = 0; k < length; ++k) {
                if (k + radius < length) sum += (double)work[k + radius];
                if (k > radius) sum -= (double)work[k - radius - 1];
                line[k * step] = (float)sum;
            }
        }
    }
}

/* Adds to sum what noise leaves of f's light when pixels whose surroundings look alike in the other film are averaged:
   non-local means whose distance knows the noise (Rousselle, Knaus, Zwicker 2012). 0: no memory. */
static int smooth(const film *f, const film *other, float *sum)
{
    enum { SEARCH = 7, PATCH = 2 };
    const float strength = 0.6f;
    const int width = f->light.width, height = f->light.height, size = width * height;
    float *distance = (float *)malloc((size_t)size * sizeof *distance),
          *total = (float *)calloc(4 * (size_t)size, sizeof *total);
    float *work = (float *)malloc((size_t)(width > height ? width : height) * sizeof *work);
    const float *g = other->guide.pixels, *noise = other->noise.pixels;
    int dx, dy, x, y, c, ok = distance && total && work;
    for (dy = -SEARCH; dy <= SEARCH && ok; ++dy)
        for (dx = -SEARCH; dx <= SEARCH; ++dx) {
            for (y = 0; y < height; ++y)
                for (x = 0; x < width; ++x) {
                    int p = y * width + x, q = p + dy * width + dx;
                    float d = 0;
                    if (x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < height)
                        for (c = 0; c < 3; ++c) {
                            float a = noise[3 * p + c], b = noise[3 * q + c], gap = g[3 * p + c] - g[3 * q + c];
                            d += (gap * gap - a - scene__min(a, b)) / (1e-7f + strength * strength * (a + b));
                        }
                    distance[p] = d;
                }
            box(distance, work, width, height, PATCH);
            for (y = dy < 0 ? -dy : 0; y < height && y + dy < height; ++y)
                for (x = dx < 0 ? -dx : 0; x < width && x + dx < width; ++x) {
                    int p = y * width + x, q = p + dy * width + dx;
                    float w = expf(-scene__max(0, distance[p] / (3 * (2 * PATCH + 1) * (2 * PATCH + 1))));
                    for (c = 0; c < 3; ++c) total[4 * p + c] += w * f->light.pixels[3 * q + c];
                    total[4 * p + 3] += w;
                }
        }
    for (x = 0; x < size && ok; ++x)
        for (c = 0; c < 3; ++c) sum[3 * x + c] += total[4 * x + c] / total[4 * x + 3];
    free(distance);
    free(total);
    free(work);
    return ok;
}

/* The passes in two halves, each smoothed by what the other shows; exposed, highlights rolled off. */
static const char *develop(image *pass, int passes, image *out)
{
    const float exposure = 1.15f;
    const float **sorted = (const float **)malloc((size_t)passes * sizeof *sorted);
    film half[2];
    size_t i;
    int k, ok = sorted != NULL;
    memset(half, 0, sizeof half);
    *out = image_new(pass[0].width, pass[0].height, 3);
    for (k = 0; k < 2; ++k) ok = ok && film_new(&half[k], out->width, out->height);
    if (ok && out->pixels) {
        for (k = 0; k < 2; ++k) expose(&half[k], pass, k % passes, passes, sorted);
        for (k = 0; k < 2; ++k) ok = ok && smooth(&half[k], &half[!k], out->pixels);
        for (i = 0; i < image_count(out); ++i)
            out->pixels[i] = image_srgb_encode(scene_tone(0.5f * exposure * out->pixels[i]));
    }
    for (k = 0; k < 2; ++k) film_free(&half[k]);
    free(sorted);
    return ok && out->pixels ? NULL : "no memory";
}

static int develop_files(const char *path, char **file, int passes)
{
    image *pass = (image *)calloc((size_t)passes, sizeof *pass), out;
    const char *problem = pass ? NULL : "no memory";
    int k;
    memset(&out, 0, sizeof out);
    for (k = 0; k < passes && problem == NULL; ++k) {
        problem = image_read(file[k], &pass[k]);
        if (problem == NULL &&
            (pass[k].channels != 3 || pass[k].width != pass[0].width || pass[k].height != pass[0].height))
            problem = "another size";
        if (problem) path = file[k];
    }
    if (problem == NULL) problem = develop(pass, passes, &out);
    if (problem == NULL) problem = image_write(path, &out);
    if (problem) fprintf(stderr, "hero: %s: %s\n", path, problem);
    for (k = 0; pass && k < passes; ++k) image_free(&pass[k]);
    free(pass);
    image_free(&out);
    return problem != NULL;
}

int main(int argc, char **argv)
{
    if (argc == 4 && strcmp(argv[1], "scores") == 0) return print_scores(argv[2], atoi(argv[3]));
    if (argc == 8 && strcmp(argv[1], "pass") == 0 && atoi(argv[4]) > 0 && atoi(argv[5]) > 0 && atoi(argv[6]) > 0)
        return render_pass(argv[2], argv[3], atoi(argv[4]), atoi(argv[5]), atoi(argv[6]), atoi(argv[7]));
    if (argc >= 4 && strcmp(argv[1], "develop") == 0) return develop_files(argv[2], argv + 3, argc - 3);
    fprintf(stderr,
            "usage: hero scores crystal|glass|metal|lacquer|wax COUNT\n"
            "       hero pass MATERIALS.csv FILE.pfm WIDTH HEIGHT SAMPLES K\n"
            "       hero develop OUT.png FILE.pfm...\n");
    return 2;
}
