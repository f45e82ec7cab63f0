/* Trains a neural renderer on pictures of materials, for build/preview, build/match and build/workflow, and inversion
   networks for it.

     cc -O2 -I. examples/tools/train.c -o build/train -lpthread -lm     (-O3 -fno-math-errno -fno-trapping-math: faster)

     build/train PICTURES PARAMS.csv OUT.safetensors [options]
       --size S          side of the network's pictures, a divisor of the side of PICTURES
       --check A         a folder of pictures, with A.csv beside it, for the final measure; twice: two renderings of the
                         same materials, whose noise then cancels. Without it every 16th picture is held out
       --held-out N      so many pictures are held out
       --rank 96         principal components; --bytes N (4M, 200k) chooses the rank for a file of that size
       --width 384       of the hidden layers, and --depth 3, their number
       --epochs N        at most; --rate 0.004: the largest step
       --channels auto   or none: whether the color channels share one network
       --hidden auto     or none: whether parameters that a picture does not depend on are drawn again at each step
       --trunk R         no training: the layers of the renderer R but its last, and a new last layer
       --seed 1, --threads 2
     build/train --inversion RENDERER.safetensors OUT_PREFIX [--count 5] [--steps 6000] [--first 64] [--width 256]
                 [--sharp LIST] [--seed 1] [--threads 2]
     build/train --measure RENDERER.safetensors PARAMS.csv --check A [--check B]

   PICTURES is a folder of square PNG, PPM (display values) or PFM files (linear light), all of one size, or a folder
   of `make dataset`, which contains the parameters. PARAMS.csv: a line of names, then a row for each picture in the
   order of the pictures' names; `-` for a folder of `make dataset`. Parameters outside [0, 1] are mapped to it; the
   file's metadata has the names (ms_parameters) and ranges (ms_ranges).

   The network: hidden layers of SiLUs that predict the coordinates of a picture in the principal components of the
   training pictures, and a linear last layer made of these components. Where each color channel depends on one of
   three parameters and on others that all channels share, one network is evaluated for each channel, and a picture is
   three examples. Where a parameter has no effect because another is 0 or 1, it is drawn again at each step. Training
   stops early when the error of the held-out pictures has not fallen for a third of the epochs. The result does not
   depend on the number of threads.

   The last layer is regressed again on the pictures' full size in linear light for a folder of `make dataset`, and with
   --trunk: noise is then averaged without a bias, and what remains of it is removed by a Wiener filter. This gives
   larger pictures from data with more noise than the hidden layers could be trained on.

   --inversion trains --count small networks from a picture to its parameters through the renderer alone: its pictures,
   some with changed contrast, black level and mixed channels, are inverted, rendered again and compared. The network
   that is best for a picture has the largest weight in its loss, since a match starts from the best of all. --sharp
   7,16,17: parameters that are 0 or 1 in half of the materials (default: those in the renderer's metadata). */
#define MS_NN_IMPLEMENTATION
#include "ms_nn.h"
#include "image.h"
#include "train.h"
#include <dirent.h>
#include <errno.h>
#include <stdarg.h>
#include <sys/time.h>

static const char usage_text[] =
    "usage: train PICTURES PARAMS.csv OUT.safetensors [--size S] [--check A [--check B]] [--held-out N] [--rank 96 | --bytes N] "
    "[--width 384] [--depth 3] [--epochs N] [--rate 0.004] [--channels auto|none] [--hidden auto|none] [--trunk RENDERER.safetensors] [--seed 1] [--threads 2]\n"
    "       train --inversion RENDERER.safetensors OUT_PREFIX [--count 5] [--steps 6000] [--first 64] [--width 256] [--sharp LIST] [--seed 1] [--threads 2]\n"
    "       train --measure RENDERER.safetensors PARAMS.csv --check A [--check B]\n";

enum { MOST_PARAMETERS = 256, MOST_HIDDEN = 512, CHUNK = 64, BATCH = 2 * CHUNK };

static char trouble[700]; /* what went wrong, in words */

static int wrong(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(trouble, sizeof trouble, format, list);
    va_end(list);
    return 0;
}

static double now(void)
{
    struct timeval t;
    gettimeofday(&t, NULL);
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* Memory in lists that are freed whole; `whole` is the main thread's, tasks have their own. */
typedef struct block {
    struct block *before, *after;
} block;

static block whole = {&whole, &whole};

static void drop(void *p)
{
    block *b = (block *)p - 1;
    b->before->after = b->after;
    b->after->before = b->before;
}

static void drop_all(block *list)
{
    while (list->after != list) drop(list->after + 1);
}

static void *room_in(block *list, size_t count, size_t size)
{
    block *b = count < (size_t)-1 / 2 / (size + 1) ? (block *)malloc(sizeof *b + count * size) : NULL;
    if (b == NULL) {
        fprintf(stderr, "train: out of memory (%.0f MB more were needed)\n", (double)count * (double)size * 1e-6);
        exit(1);
    }
    b->before = list;
    b->after = list->after;
    list->after->before = b;
    list->after = b;
    return b + 1;
}

static void *zeros_in(block *list, size_t count, size_t size)
{
    return memset(room_in(list, count, size), 0, count * size);
}
static void *room(size_t count, size_t size) { return room_in(&whole, count, size); }
static void *zeros(size_t count, size_t size) { return zeros_in(&whole, count, size); }

/* The first `count` elements of p (may be NULL) in memory for `more`. */
static void *grow(void *p, size_t count, size_t more, size_t size)
{
    void *larger = room(more, size);
    if (p == NULL) return larger;
    memcpy(larger, p, count * size);
    drop(p);
    return larger;
}

/* --- what is read: materials and pictures ------------------------------------------------------------------------- */

typedef struct material_set {
    int count, parameters, size;
    float *x;           /* [count][parameters], mapped to [0, 1] */
    uint16_t *value;    /* [count][3][size][size]: display values as fractions of 65535 */
    uint16_t *linear;   /* the same in linear light, as halves; NULL: not kept */
    char *names;        /* separated by commas */
    double *low, *high; /* [parameters] */
} material_set;

static uint16_t display(float linear)
{
    float v = linear > 0 ? linear < 1 ? image_srgb_encode(linear) : 1 : 0;
    return (uint16_t)(v * 65535 + 0.5f);
}

/* A picture [side][side][3] (linear, or display values) to planes [3][size][size]: means of linear light over boxes. */
static void add_picture(const float *pixels, int side, int size, int linear, uint16_t *planes)
{
    int box = side / size, c, x, y, i, j;
    for (c = 0; c < 3; ++c)
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x) {
                float sum = 0;
                const float *from = pixels + 3 * ((size_t)(y * box) * (size_t)side + (size_t)(x * box)) + c;
                for (j = 0; j < box; ++j)
                    for (i = 0; i < box; ++i) {
                        float v = from[3 * (j * side + i)];
                        sum += linear || box == 1 ? v : image_srgb_decode(v);
                    }
                sum /= (float)(box * box);
                *planes++ = linear || box > 1 ? display(sum)
                                              : (uint16_t)((sum > 0 ? sum < 1 ? sum : 1 : 0) * 65535 + 0.5f);
            }
}

/* A line of names, then rows of numbers. */
typedef struct table {
    int count, columns;
    int *line; /* [count] */
    double *x; /* [count][columns] */
    char *names;
} table;

static char *word_of(char **text, char between)
{
    char *start = *text, *end = start + strcspn(start, between == ',' ? "," : between == ';' ? ";" : "\t"), *last;
    *text = *end ? end + 1 : end;
    *end = 0;
    start += strspn(start, " \t\"");
    for (last = start + strlen(start); last > start && strchr(" \t\"\r\n", last[-1]);) *--last = 0;
    return start;
}

static int table_read(const char *path, table *t)
{
    static char text[65536];
    const char *problem = NULL;
    FILE *f = file_open(path, &problem);
    csv_dialect d = {',', '.'};
    int line = 0, space = 0, seen = 0;
    memset(t, 0, sizeof *t);
    if (f == NULL) return wrong("%s: %s", path, problem);
    while (fgets(text, sizeof text, f)) {
        char *at = text, *word, *end;
        int column = 0;
        if (++line == 1) {
            const char *start = csv_begin(text, strlen(text), &problem);
            if (start == NULL) break;
            at = text + (start - text);
        }
        if (strlen(text) + 1 == sizeof text) {
            problem = "is too long";
            break;
        }
        if (at[strspn(at, " \t\r\n")] == 0 || *at == '#') continue;
        if (!seen++) {
            char *header = at;
            d = csv_dialect_of(at);
            if (d.decimal == ',' && strchr(at, ';') == NULL && strchr(at, '\t') == NULL) d.decimal = '.';
            t->names = (char *)zeros(strlen(at) + 2, 1);
            while (*header) {
                word = word_of(&header, d.between);
                (void)number_read(word, d.decimal, &end);
                if (*word == 0 || (end != word && *end == 0)) {
                    fclose(f);
                    return wrong(
                        "%s: line %d: column %d of the header is '%.40s', no name: the first line names the parameters",
                        path, line, column + 1, word);
                }
                if (column++) strcat(t->names, ",");
                strcat(t->names, word);
            }
            t->columns = column;
            if (column < 1 || column > MOST_PARAMETERS) {
                fclose(f);
                return wrong("%s: line %d: %d parameters; 1 to %d are possible", path, line, column,
                             (int)MOST_PARAMETERS);
            }
            continue;
        }
        if (t->count == space) {
            space = 2 * space + 256;
            t->x = (double *)grow(t->x, (size_t)t->count, (size_t)space, (size_t)t->columns * sizeof(double));
            t->line = (int *)grow(t->line, (size_t)t->count, (size_t)space, sizeof(int));
        }
        t->line[t->count] = line;
        while (*at) {
            double v;
            word = word_of(&at, d.between);
            v = number_read(word, d.decimal, &end);
            if (column < t->columns && (end == word || *end != 0 || !(v > -1e30 && v < 1e30))) {
                fclose(f);
                return wrong("%s: line %d: column %d is '%.40s', not a number", path, line, column + 1, word);
            }
            if (column < t->columns) t->x[t->count * t->columns + column] = v;
            ++column;
        }
        if (column != t->columns) {
            fclose(f);
            return wrong("%s: line %d: %d columns, expected %d", path, line, column, t->columns);
        }
        ++t->count;
    }
    fclose(f);
    if (problem) return wrong("%s: line %d: %s", path, line, problem);
    return seen ? 1 : wrong("%s: empty: a line of names, then a row for each picture", path);
}

/* Files of a folder by their ending, sorted; count, or -1: no folder. */
static int compare_names(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

static int has_ending(const char *name, const char *ending)
{
    size_t n = strlen(name), m = strlen(ending);
    return n > m && strcmp(name + n - m, ending) == 0;
}

static int list_folder(const char *folder, const char *const *endings, char ***names)
{
    DIR *d = opendir(folder);
    struct dirent *e;
    int count = 0, space = 0, k;
    *names = NULL;
    if (d == NULL) return -1;
    while ((e = readdir(d)) != NULL)
        for (k = 0; endings[k]; ++k)
            if (e->d_name[0] != '.' && has_ending(e->d_name, endings[k])) {
                if (count == space)
                    *names = (char **)grow(*names, (size_t)count, (size_t)(space = 2 * space + 256), sizeof(char *));
                (*names)[count] = (char *)room(strlen(e->d_name) + 1, 1);
                strcpy((*names)[count++], e->d_name);
            }
    closedir(d);
    if (count) qsort(*names, (size_t)count, sizeof **names, compare_names);
    return count;
}

/* The parts of a data set (tests/render/dataset.c). */
typedef struct parts {
    const char *folder;
    char **name;
    int *first; /* of each part in the set */
    int side;
    material_set *set;
    char problem[8][200];
} parts;

static unsigned u32(const unsigned char *p)
{
    return p[0] | (unsigned)p[1] << 8 | (unsigned)p[2] << 16 | (unsigned)p[3] << 24;
}

static void read_part(void *context, int index)
{
    block mine = {&mine, &mine};
    parts *p = (parts *)context;
    int n = p->first[index + 1] - p->first[index], i, m = p->set->parameters;
    size_t pixels = (size_t)p->side * (size_t)p->side * 3, k;
    unsigned char *bytes = (unsigned char *)room_in(&mine, pixels, 2);
    float *picture = (float *)room_in(&mine, pixels, sizeof(float));
    char path[1200];
    FILE *f;
    snprintf(path, sizeof path, "%.1000s/%.180s", p->folder, p->name[index]);
    f = fopen(path, "rb");
    if (f && fseek(f, 24, SEEK_SET) == 0)
        for (i = 0; i < n * m; ++i) {
            unsigned char b[4];
            unsigned u;
            if (fread(b, 1, 4, f) != 4) break;
            u = u32(b);
            memcpy(p->set->x + p->first[index] * m + i, &u, 4);
        }
    for (i = 0; i < n; ++i) {
        int bad = f == NULL || fread(bytes, 2, pixels, f) != pixels;
        for (k = 0; k < pixels && !bad; ++k) {
            picture[k] = image_from_half((uint16_t)(bytes[2 * k] | bytes[2 * k + 1] << 8));
            if (!(picture[k] >= 0 && picture[k] < 1e30f)) bad = 2;
        }
        if (bad) {
            snprintf(p->problem[index % 8], sizeof p->problem[0], "%.120s: picture %d %s", p->name[index], i,
                     bad == 2 ? "has a value that is no number" : "is cut off");
            break;
        }
        if (p->set->linear) { /* means over boxes */
            int size = p->set->size, box = p->side / size, c, x, y, j;
            uint16_t *to = p->set->linear + (size_t)(p->first[index] + i) * 3 * (size_t)size * (size_t)size;
            for (c = 0; c < 3; ++c)
                for (y = 0; y < size; ++y)
                    for (x = 0; x < size; ++x) {
                        float sum = 0;
                        for (j = 0; j < box * box; ++j)
                            sum += picture[3 * ((y * box + j / box) * p->side + x * box + j % box) + c];
                        *to++ = image_to_half(sum / (float)(box * box));
                    }
        }
        if (p->set->value)
            add_picture(picture, p->side, p->set->size, 1,
                        p->set->value +
                            (size_t)(p->first[index] + i) * 3 * (size_t)p->set->size * (size_t)p->set->size);
    }
    if (f) fclose(f);
    drop_all(&mine);
}

static int read_parts(train_pool *pool, const char *folder, char **name, int count, int size, int linear,
                      material_set *s)
{
    parts p;
    int i, total = 0;
    memset(&p, 0, sizeof p);
    p.folder = folder;
    p.name = name;
    p.set = s;
    p.first = (int *)zeros((size_t)count + 1, sizeof(int));
    for (i = 0; i < count; ++i) {
        unsigned char h[24];
        char path[1200];
        FILE *f;
        snprintf(path, sizeof path, "%.1000s/%.180s", folder, name[i]);
        f = fopen(path, "rb");
        if (f == NULL || fread(h, 1, 24, f) != 24 || memcmp(h, "msds", 4) != 0 || u32(h + 4) != 1 || u32(h + 8) < 1 ||
            u32(h + 8) > 8192 || (p.side && p.side != (int)u32(h + 8)) || u32(h + 20) > 65536) {
            if (f) fclose(f);
            return wrong("%s: not a part of a data set, or of pictures of another size", path);
        }
        fclose(f);
        p.side = (int)u32(h + 8);
        p.first[i] = total;
        total += (int)u32(h + 20);
    }
    p.first[count] = total;
    s->count = total;
    s->parameters = 19;
    s->size = size ? size : p.side;
    if (p.side % s->size)
        return wrong("%s: pictures of %d pixels cannot be brought to %d: not a divisor", folder, p.side, s->size);
    s->x = (float *)zeros((size_t)total * 19, sizeof(float));
    if (linear) s->linear = (uint16_t *)room((size_t)total * 3 * (size_t)s->size * (size_t)s->size, sizeof(uint16_t));
    else s->value = (uint16_t *)room((size_t)total * 3 * (size_t)s->size * (size_t)s->size, sizeof(uint16_t));
    train_run(pool, count, read_part, &p);
    for (i = 0; i < 8; ++i)
        if (p.problem[i][0]) return wrong("%s/%s", folder, p.problem[i]);
    for (i = 0; i < total * 19; ++i)
        if (!(s->x[i] >= 0 && s->x[i] <= 1))
            return wrong("%s: material %d: parameter %d is outside [0, 1]", folder, i / 19, i % 19);
    return 1;
}

/* An image as picture `at` of a set; 0: see trouble. */
static int take_picture(const image *im, const char *path, int at, material_set *s)
{
    block mine = {&mine, &mine};
    int side = im->width, c, step = im->channels < 3 ? 0 : 1, differ = 0;
    size_t i, pixels = (size_t)side * (size_t)side;
    float *picture = (float *)room_in(&mine, 3 * pixels, sizeof(float));
    for (i = 0; i < pixels; ++i)
        for (c = 0; c < 3; ++c) {
            float v = im->pixels[i * (size_t)im->channels + (size_t)(c * step)];
            if (!(v >= 0 && v < 1e30f)) {
                return wrong("%s: column %d, row %d has a value that is negative or not a number", path, (int)i % side,
                             (int)i / side);
            }
            picture[3 * i + (size_t)c] = v;
            differ |= v < picture[c] || v > picture[c];
        }
    if (differ)
        add_picture(picture, side, s->size, image__has_extension(path, ".pfm"),
                    s->value + (size_t)at * 3 * (size_t)s->size * (size_t)s->size);
    drop_all(&mine);
    return differ ? 1 : wrong("%s: of one color alone: a render that failed?", path);
}

static int read_images(const char *pictures, char **name, int count, const table *t, const char *csv, int size,
                       material_set *s)
{
    char path[1300];
    image im;
    int fine, k, side = 0;
    if (count != t->count)
        return count > t->count
            ? wrong("%s: %d pictures, but %s has %d rows: none for %s", pictures, count, csv, t->count, name[t->count])
            : wrong("%s: %d pictures, but %s has %d rows: no picture for line %d", pictures, count, csv, t->count,
                    t->line[count]);
    s->count = t->count;
    for (k = 0; k < t->count; ++k) {
        const char *problem;
        snprintf(path, sizeof path, "%.900s/%.300s", pictures, name[k]);
        problem = image_read(path, &im);
        if (problem) return wrong("%s: %s", path, problem);
        if (k == 0) {
            side = im.width;
            s->size = size ? size : side;
            if (side % s->size == 0)
                s->value = (uint16_t *)room((size_t)t->count * 3 * (size_t)s->size * (size_t)s->size, sizeof(uint16_t));
        }
        if (s->value == NULL)
            fine = wrong("%s: pictures of %d pixels cannot be brought to %d: not a divisor", path, side, s->size);
        else if (im.width != side || im.height != side)
            fine = wrong("%s: %d x %d pixels; %s", path, im.width, im.height,
                         k ? "the pictures before it have another size" : "it must be square");
        else fine = take_picture(&im, path, k, s);
        image_free(&im);
        if (!fine) return 0;
    }
    return 1;
}

static char *names_like(int n)
{
    char *names = (char *)zeros((size_t)n * 8 + 1, 1);
    int j;
    for (j = 0; j < n; ++j) sprintf(names + strlen(names), "%sx%d", j ? "," : "", j);
    return names;
}

static int is_data_set(const char *pictures)
{
    static const char *const part[] = {".bin", NULL};
    char **name;
    int count = list_folder(pictures, part, &name);
    return count > 0;
}

/* like: a set that decides on names, ranges and size, or NULL. */
static int set_read(train_pool *pool, const char *pictures, const char *csv, int size, const material_set *like,
                    material_set *s)
{
    static const char *const part[] = {".bin", NULL}, *const picture[] = {".png", ".ppm", ".pgm", ".pfm", NULL};
    char **name, beside[1024];
    table t;
    int count = list_folder(pictures, part, &name), fine = 1, i, j;
    memset(s, 0, sizeof *s);
    memset(&t, 0, sizeof t);
    if (count > 0) {
        fine = read_parts(pool, pictures, name, count, size, 0, s);
        if (fine && strcmp(csv, "-") != 0) fine = table_read(csv, &t);
        if (fine && t.names && t.columns != s->parameters)
            fine = wrong("%s: %d names, the data set has %d parameters", csv, t.columns, s->parameters);
        if (fine) s->names = t.names ? t.names : names_like(s->parameters);
        t.names = NULL;
    } else {
        count = list_folder(pictures, picture, &name);
        snprintf(beside, sizeof beside, "%.1000s.csv", pictures);
        if (like) csv = beside; /* a set to check with has its own */
        fine = table_read(csv, &t);
        if (fine && count == 0) fine = wrong("%s: a folder without pictures (PNG, PPM, PFM)", pictures);
        if (fine && t.count == 0) fine = wrong("%s: names, but no rows", csv);
        if (fine) fine = read_images(pictures, name, count, &t, csv, size, s);
        if (fine) {
            s->parameters = t.columns;
            s->names = t.names;
            t.names = NULL;
            s->x = (float *)room((size_t)t.count * (size_t)t.columns, sizeof(float));
        }
    }
    if (fine) {
        s->low = (double *)zeros((size_t)s->parameters, sizeof(double));
        s->high = (double *)zeros((size_t)s->parameters, sizeof(double));
        for (j = 0; j < s->parameters; ++j) {
            s->high[j] = 1;
            if (t.x) { /* [0, 1] where that holds them, else what there is */
                double low = 1e300, high = -1e300;
                for (i = 0; i < t.count; ++i) {
                    double v = t.x[i * t.columns + j];
                    low = v < low ? v : low;
                    high = v > high ? v : high;
                }
                if (low < 0 || high > 1) s->low[j] = low, s->high[j] = high > low ? high : low + 1;
            }
            if (like && like->parameters == s->parameters) s->low[j] = like->low[j], s->high[j] = like->high[j];
            for (i = 0; t.x && i < t.count; ++i)
                s->x[i * t.columns + j] = (float)((t.x[i * t.columns + j] - s->low[j]) / (s->high[j] - s->low[j]));
        }
        if (like && (like->parameters != s->parameters || like->size != s->size))
            fine = wrong("%s: other parameters or another size than the pictures before", pictures);
    }
    return fine;
}

/* --- what depends on what ----------------------------------------------------------------------------------------- */

/* Which inputs the network of a channel has, and which of these a picture does not depend on, where. */
typedef struct form {
    int lists, inputs; /* 3 lists where the channels share one network, 1: none */
    int list[3][MOST_PARAMETERS];
    int rules;
    struct {
        int column, gate, value;
    } rule[MOST_HIDDEN]; /* input `column` does not matter where input `gate` is 0 or 1 */
} form;

enum { PROBE = 384, OUTPUTS = 8 };
/* A triple's error over that with its place left empty. With noise of 0 to 0.6 on 300 to 1200 pictures it was 0.01 to
   0.56 for colors, 1.05 to 2.3 for other parameters. */
#define TRIPLE_GAIN 0.98

/* Mean squared error, on every fourth row, of a ridge regression of y [rows][OUTPUTS] on random tanh of x [rows][d]
   fitted to the others; inputs that `drop` marks are left out. A cheap stand-in for a network: does what it is told
   matter? */
static double probe(int rows, int d, const float *x, const float *y, const char *drop, uint64_t seed)
{
    block mine = {&mine, &mine};
    int features = rows / 6 < PROBE ? rows / 6 : (int)PROBE, m = features + d + 1, train = 0, test = 0, i, j, k, o;
    float *phi = (float *)room_in(&mine, (size_t)rows * (size_t)m, sizeof(float)),
          *w = (float *)room_in(&mine, (size_t)features * (size_t)(d + 1), sizeof(float));
    double *gram = (double *)zeros_in(&mine, (size_t)m * (size_t)m, sizeof(double)),
           *right = (double *)zeros_in(&mine, (size_t)m * OUTPUTS, sizeof(double)), error = 0;
    train_work *work = (train_work *)room_in(&mine, 1, sizeof *work);
    for (k = 0; k < features; ++k) {
        float bias = 0;
        for (j = 0; j < d; ++j) {
            float center = train_uniform(&seed);
            w[k * (d + 1) + j] = 1.2f * train_normal(&seed);
            if (drop[j]) w[k * (d + 1) + j] = 0;
            bias -= center * w[k * (d + 1) + j];
        }
        w[k * (d + 1) + d] = bias;
    }
    for (i = 0; i < rows; ++i) { /* rows to fit come first */
        int at = i % 4 == 3 ? rows - ++test : train++;
        float *row = phi + (size_t)at * (size_t)m;
        for (k = 0; k < features; ++k) {
            float s = w[k * (d + 1) + d];
            for (j = 0; j < d; ++j) s += w[k * (d + 1) + j] * x[i * d + j];
            row[k] = tanhf(s);
        }
        for (j = 0; j < d; ++j) row[features + j] = drop[j] ? 0 : x[i * d + j];
        row[m - 1] = 1;
        if (at < train && i % 4 != 3)
            for (k = 0; k < m; ++k)
                for (o = 0; o < OUTPUTS; ++o) right[k * OUTPUTS + o] += (double)row[k] * (double)y[i * OUTPUTS + o];
    }
    train__gram(phi, 0, (size_t)train, m, gram, work);
    for (k = 0; k < m; ++k) gram[k * m + k] += 1e-5 * (double)train;
    train_cholesky(m, gram, 1e-12);
    for (o = 0; o < OUTPUTS; ++o) {
        for (i = 0; i < m; ++i) {
            double s = right[i * OUTPUTS + o];
            for (j = 0; j < i; ++j) s -= gram[i * m + j] * right[j * OUTPUTS + o];
            right[i * OUTPUTS + o] = s / gram[i * m + i];
        }
        for (i = m - 1; i >= 0; --i) {
            double s = right[i * OUTPUTS + o];
            for (j = i + 1; j < m; ++j) s -= gram[j * m + i] * right[j * OUTPUTS + o];
            right[i * OUTPUTS + o] = s / gram[i * m + i];
        }
    }
    for (test = 0, i = 3; i < rows; i += 4) {
        const float *row = phi + (size_t)(rows - ++test) * (size_t)m;
        for (o = 0; o < OUTPUTS; ++o) {
            double s = -(double)y[i * OUTPUTS + o];
            for (k = 0; k < m; ++k) s += (double)row[k] * right[k * OUTPUTS + o];
            error += s * s;
        }
    }
    drop_all(&mine);
    return error / (test > 0 ? test : 1);
}

typedef struct probing {
    int rows, d;
    const float *x, *y;
    char (*drop)[MOST_PARAMETERS];
    double *error;
    uint64_t seed;
} probing;

static void probe_task(void *context, int i)
{
    probing *p = (probing *)context;
    p->error[i] = probe(p->rows, p->d, p->x, p->y, p->drop[i], p->seed);
}

/* error[j] without input j, error[d] with all of them. */
static void probe_each(train_pool *pool, int rows, int d, const float *x, const float *y, uint64_t seed, double *error)
{
    probing p;
    int j;
    p.rows = rows;
    p.d = d;
    p.x = x;
    p.y = y;
    p.seed = seed;
    p.error = error;
    p.drop = (char(*)[MOST_PARAMETERS])zeros((size_t)d + 1, MOST_PARAMETERS);
    for (j = 0; j < d; ++j) p.drop[j][j] = 1;
    train_run(pool, d + 1, probe_task, &p);
}

/* x [rows][inputs] of the form. */
static void inputs_of(const form *f, const material_set *s, float *x)
{
    int i, c, k;
    for (i = 0; i < s->count; ++i)
        for (c = 0; c < f->lists; ++c)
            for (k = 0; k < f->inputs; ++k) *x++ = s->x[i * s->parameters + f->list[c][k]];
}

static void no_sharing(form *f, int parameters)
{
    int j;
    f->lists = 1;
    f->inputs = parameters;
    for (j = 0; j < parameters; ++j) f->list[0][j] = j;
}

/* Whether a name ends as the other two of a color do: "diffuse red", "baseR", "tint.2". */
static int is_triple(const char *names, const int *t)
{
    static const char *const ends[] = {"red", "green", "blue", "r", "g", "b", "x", "y", "z",
                                       "R",   "G",     "B",    "0", "1", "2", "1", "2", "3"};
    const char *name[3];
    size_t length[3], e;
    int c, k, alike;
    for (c = 0; c < 3; ++c) {
        for (name[c] = names, k = 0; k < t[c]; ++k) name[c] = strchr(name[c], ',') + 1;
        length[c] = strcspn(name[c], ",");
    }
    for (e = 0; e < sizeof ends / sizeof ends[0]; e += 3) {
        for (alike = 1, c = 0; c < 3; ++c) {
            size_t n = strlen(ends[e + (size_t)c]);
            alike = alike && length[c] >= n && memcmp(name[c] + length[c] - n, ends[e + (size_t)c], n) == 0 &&
                length[c] - n == length[0] - strlen(ends[e]) && memcmp(name[c], name[0], length[c] - n) == 0;
        }
        if (alike) return 1;
    }
    return 0;
}

typedef struct sharing { /* probes of lists of triples */
    const material_set *s;
    const float *y;
    int rows, d, (*triple)[3], triples, chosen[MOST_PARAMETERS], count;
    char rejected[2 * MOST_PARAMETERS];
    double error[2 * MOST_PARAMETERS];
    uint64_t seed;
} sharing;

/* The form in which the chosen triples, and triple `more` (or -1), are each channel's own. */
static void form_of(const sharing *h, int more, form *f)
{
    int own[MOST_PARAMETERS] = {0}, c, i, j, total = h->count + (more >= 0);
    f->lists = 3;
    for (c = 0; c < 3; ++c) {
        int n = 0;
        for (i = 0; i < total; ++i) {
            const int *t = h->triple[i < h->count ? h->chosen[i] : more];
            f->list[c][n++] = t[c];
            own[t[c]] = 1;
        }
        f->inputs = n;
    }
    for (j = 0; j < h->d; ++j)
        if (!own[j]) {
            for (c = 0; c < 3; ++c) f->list[c][f->inputs] = j;
            ++f->inputs;
        }
}

/* The error of the probe in which the chosen triples and triple k are each channel's own; masked: without triple k in
   its inputs. */
static double share_error(const sharing *h, int k, int masked)
{
    block mine = {&mine, &mine};
    char drop[MOST_PARAMETERS] = {0};
    form *f = (form *)room_in(&mine, 1, sizeof *f);
    float *x = (float *)room_in(&mine, (size_t)h->rows * 3 * (size_t)h->d, sizeof(float));
    material_set part = *h->s;
    double error;
    form_of(h, k, f);
    part.count = h->rows;
    inputs_of(f, &part, x);
    drop[h->count] = (char)masked;
    error = probe(3 * h->rows, f->inputs, x, h->y, drop, h->seed);
    drop_all(&mine);
    return error;
}

static void share_task(void *context, int k)
{
    sharing *h = (sharing *)context;
    int i, j, taken = h->rejected[k];
    for (i = 0; i < h->count; ++i)
        for (j = 0; j < 9; ++j) taken |= h->triple[h->chosen[i]][j / 3] == h->triple[k][j % 3];
    h->error[k] = taken ? 1e300 : share_error(h, k, 0);
}

/* Do the channels share a network? y [count * 3][OUTPUTS]: coordinates, a row a channel. Three parameters, one a
   channel, are the channels' own where a regression for all three channels does better if each sees its own alone: the
   best three, then the best beside them, while that helps. Leaving parameters out helps too where pictures are noisy,
   so a triple must also do better than its place left empty. They stand beside each other, or their names say so. In
   the end one regression for all must do as well as three of all parameters. */
static void find_channels(train_pool *pool, const material_set *s, const float *y, uint64_t seed, form *f)
{
    const int d = s->parameters, rows = s->count < 1500 ? s->count : 1500;
    const char none[MOST_PARAMETERS] = {0};
    float *part = (float *)room((size_t)rows * OUTPUTS, sizeof(float));
    double apart = 0, best = 1e300;
    sharing h;
    int a, b, c, i, k, o;
    memset(&h, 0, sizeof h);
    h.s = s;
    h.y = y;
    h.rows = rows;
    h.d = d;
    h.seed = seed;
    h.triple = (int(*)[3])zeros(2 * MOST_PARAMETERS, sizeof *h.triple);
    for (a = 0; a < d; ++a)
        for (b = a + 1; b < d; ++b)
            for (c = b + 1; c < d; ++c) {
                int *t = h.triple[h.triples];
                t[0] = a, t[1] = b, t[2] = c;
                if (h.triples + 1 < 2 * MOST_PARAMETERS && ((b == a + 1 && c == b + 1) || is_triple(s->names, t)))
                    ++h.triples;
            }
    for (c = 0; c < 3; ++c) {
        for (i = 0; i < rows; ++i)
            for (o = 0; o < OUTPUTS; ++o) part[i * OUTPUTS + o] = y[(3 * i + c) * OUTPUTS + o];
        apart += probe(rows, d, s->x, part, none, seed) / 3;
    }
    while (h.triples > 0 && h.count < d / 3) {
        train_run(pool, h.triples, share_task, &h);
        for (k = 0, i = 1; i < h.triples; ++i)
            if (h.error[i] < h.error[k]) k = i;
        if (h.error[k] >= best) break;
        if (h.error[k] > TRIPLE_GAIN * share_error(&h, k, 1)) {
            h.rejected[k] = 1;
            continue;
        }
        best = h.error[k];
        h.chosen[h.count++] = k;
    }
    if (h.count > 0 && best <= 1.02 * apart) {
        for (i = 0; i < h.count; ++i) /* in the order of the parameters */
            for (k = i; k > 0 && h.chosen[k - 1] > h.chosen[k]; --k)
                o = h.chosen[k], h.chosen[k] = h.chosen[k - 1], h.chosen[k - 1] = o;
        form_of(&h, -1, f);
    } else no_sharing(f, d);
}

/* The rows in which inputs gate[0], ... are value[0], ... exactly. */
static int rows_where(int rows, int d, const float *x, const float *y, int gates, const int *gate, const int *value,
                      float *px, float *py)
{
    int i, k, n = 0;
    for (i = 0; i < rows; ++i) {
        for (k = 0; k < gates && !(fabsf(x[i * d + gate[k]] - (float)value[k]) > 0); ++k) {}
        if (k < gates) continue;
        memcpy(px + n * d, x + i * d, (size_t)d * sizeof(float));
        memcpy(py + n++ * OUTPUTS, y + i * OUTPUTS, OUTPUTS * sizeof(float));
    }
    return n;
}

typedef struct hiding {
    train_pool *pool;
    int rows, d, gate[3], value[3];
    const float *x, *y;
    float *px, *py;
    uint64_t seed;
    char matters[MOST_PARAMETERS];
} hiding;

/* Marks the inputs without which a part of the rows does worse: those of the first `gates` gates, then of one or two
   more. */
static void find_mattering(hiding *h, int gates)
{
    double error[MOST_PARAMETERS + 1];
    int n = rows_where(h->rows, h->d, h->x, h->y, gates, h->gate, h->value, h->px, h->py), j, g, v;
    if (n < (gates > 1 ? 400 : 1500) || (gates == 1 && (n * 20 < h->rows || n * 10 > 9 * h->rows))) {
        if (gates == 1) memset(h->matters, 1, sizeof h->matters);
        return;
    }
    probe_each(h->pool, n, h->d, h->px, h->py, h->seed, error);
    for (j = 0; j < h->d; ++j) {
        for (g = 0; g < gates && h->gate[g] != j; ++g) {} /* of the gates themselves it says nothing */
        if (g == gates ? error[j] > (gates > 1 ? 1.04 : 1) * error[h->d] : g == 0)
            h->matters[j] = 1; /* few rows: noise */
    }
    for (g = gates > 1 ? h->gate[gates - 1] + 1 : 0; g < h->d && gates < 3; ++g)
        for (v = 0; v < 2 && g != h->gate[0]; ++v) {
            h->gate[gates] = g;
            h->value[gates] = v;
            find_mattering(h, gates + 1);
        }
}

/* Rules: where input `gate` is exactly 0 or 1 in many rows, which others do better when they are left out there? A
   regression of all these rows may be too coarse to see what matters in few of them, so leaving it out must harm no
   part where other gates are shut or open. */
static void find_hidden(train_pool *pool, int rows, int d, const float *x, const float *y, uint64_t seed, form *f)
{
    hiding *h = (hiding *)zeros(1, sizeof *h);
    int j;
    h->pool = pool;
    h->rows = rows;
    h->d = d;
    h->x = x;
    h->y = y;
    h->seed = seed;
    h->px = (float *)room((size_t)rows * (size_t)d, sizeof(float));
    h->py = (float *)room((size_t)rows * OUTPUTS, sizeof(float));
    f->rules = 0;
    for (h->gate[0] = 0; h->gate[0] < d; ++h->gate[0])
        for (h->value[0] = 0; h->value[0] < 2; ++h->value[0]) {
            memset(h->matters, 0, sizeof h->matters);
            find_mattering(h, 1);
            for (j = 0; j < d; ++j)
                if (!h->matters[j] && f->rules < MOST_HIDDEN) {
                    f->rule[f->rules].column = j;
                    f->rule[f->rules].gate = h->gate[0];
                    f->rule[f->rules++].value = h->value[0];
                }
        }
}

/* --- learning ----------------------------------------------------------------------------------------------------- */

typedef struct trainer {
    train_pool *pool;
    form *f;
    train_net net;
    train_adam adam;
    float *grad[64], scale, floor;
    const float *x, *c; /* [rows][inputs], [rows][rank] */
    const int *order;   /* of this step's batch */
    int batch, rank;
    uint64_t seed, step;
    float rate, beta1;
    train_work *work[64];
    float *act[64][TRAIN_LAYERS], *in[64], *g[64], *spare[64];
    double sum[64];
} trainer;

static int widest(const train_net *net)
{
    int l, w = 1;
    for (l = 0; l <= net->layers; ++l) w = net->size[l] > w ? net->size[l] : w;
    return w;
}

/* Inputs that do not matter in this row, anew. */
static void redraw(const form *f, float *x, uint64_t seed)
{
    char idle[MOST_PARAMETERS] = {0};
    int r, j;
    for (r = 0; r < f->rules; ++r)
        if (fabsf(x[f->rule[r].gate] - (float)f->rule[r].value) < 1e-6f) idle[f->rule[r].column] = 1;
    for (j = 0; j < f->inputs; ++j)
        if (idle[j]) x[j] = train_uniform(&seed);
}

static void step_chunk(void *context, int k)
{
    trainer *t = (trainer *)context;
    int from = k * CHUNK, n = t->batch - from < CHUNK ? t->batch - from : (int)CHUNK, i, j, inputs = t->f->inputs;
    memset(t->grad[k], 0, t->net.count * sizeof(float));
    t->sum[k] = 0;
    for (i = 0; i < n; ++i) {
        memcpy(t->in[k] + i * inputs, t->x + (size_t)t->order[from + i] * (size_t)inputs,
               (size_t)inputs * sizeof(float));
        redraw(t->f, t->in[k] + i * inputs, t->seed ^ (t->step << 20) ^ (uint64_t)(from + i));
    }
    train_forward(&t->net, t->work[k], n, t->in[k], t->act[k]);
    for (i = 0; i < n; ++i) {
        const float *c = t->c + (size_t)t->order[from + i] * (size_t)t->rank,
                    *out = t->act[k][t->net.layers - 1] + (size_t)i * (size_t)t->rank;
        float *g = t->g[k] + (size_t)i * (size_t)t->rank, e = t->floor, by;
        for (j = 0; j < t->rank; ++j) {
            g[j] = out[j] * t->scale - c[j];
            e += g[j] * g[j];
        }
        t->sum[k] += (double)(e - t->floor);
        by = t->scale / (sqrtf(e * sqrtf(e)) * (float)t->batch); /* of the fourth root: between the mean of the squares
                                                                    and that of their logarithms, the PSNR */
        for (j = 0; j < t->rank; ++j) g[j] *= by;
    }
    train_backward(&t->net, t->work[k], n, t->in[k], t->act[k], t->g[k], t->spare[k], t->grad[k], NULL);
}

static void step_update(void *context, int part)
{
    trainer *t = (trainer *)context;
    size_t from = t->net.count * (size_t)part / 4, to = t->net.count * (size_t)(part + 1) / 4, i;
    int k, chunks = (t->batch + CHUNK - 1) / CHUNK;
    for (k = 1; k < chunks; ++k)
        for (i = from; i < to; ++i) t->grad[0][i] += t->grad[k][i];
    train_adam_step(&t->adam, t->rate, t->beta1, t->net.p, t->grad[0], from, to);
}

static void trainer_start(trainer *t, train_pool *pool, form *f, const int *sizes, int count, int batch, uint64_t seed)
{
    int k, l;
    memset(t, 0, sizeof *t);
    t->pool = pool;
    t->f = f;
    t->seed = seed;
    t->rank = sizes[count - 1];
    if (!train_net_make(&t->net, sizes, count, 0, &seed)) {
        fprintf(stderr, "train: out of memory\n");
        exit(1);
    }
    t->adam.m = (float *)zeros(t->net.count, sizeof(float));
    t->adam.v = (float *)zeros(t->net.count, sizeof(float));
    t->adam.power1 = t->adam.power2 = 1;
    for (k = 0; k < (batch + CHUNK - 1) / CHUNK; ++k) {
        t->grad[k] = (float *)room(t->net.count, sizeof(float));
        t->work[k] = (train_work *)room(1, sizeof(train_work));
        t->in[k] = (float *)room((size_t)CHUNK * (size_t)sizes[0], sizeof(float));
        t->g[k] = (float *)room((size_t)CHUNK * (size_t)widest(&t->net), sizeof(float));
        t->spare[k] = (float *)room((size_t)CHUNK * (size_t)widest(&t->net), sizeof(float));
        for (l = 0; l < t->net.layers; ++l)
            t->act[k][l] = (float *)room((size_t)CHUNK * (size_t)t->net.size[l + 1], 2 * sizeof(float));
    }
}

/* Coordinates [rows][rank] that the network gives. */
static void trainer_predict(trainer *t, int rows, const float *x, float *c)
{
    int i, j, n;
    for (i = 0; i < rows; i += n) {
        const float *out = t->act[0][t->net.layers - 1];
        n = rows - i < CHUNK ? rows - i : (int)CHUNK;
        train_forward(&t->net, t->work[0], n, x + (size_t)i * (size_t)t->f->inputs, t->act[0]);
        for (j = 0; j < n * t->rank; ++j) c[(size_t)i * (size_t)t->rank + (size_t)j] = out[j] * t->scale;
    }
}

/* --- files -------------------------------------------------------------------------------------------------------- */

typedef struct saved { /* tensors of a network to come */
    ms_nn_tensor tensor[64];
    size_t shape[64][2];
    char name[64][32];
    void *data[64];
    size_t count;
    char layers[8192];
} saved;

static void *saved_tensor(saved *s, const char *name, const char *what, ms_nn_dtype type, size_t rows, size_t columns)
{
    size_t k = s->count++, size = type == MS_NN_I8 ? 1 : type == MS_NN_F16 ? 2 : 4;
    snprintf(s->name[k], sizeof s->name[k], "%s.%s", name, what);
    s->shape[k][0] = rows;
    s->shape[k][1] = columns;
    s->data[k] = room(rows * (columns ? columns : 1), size);
    s->tensor[k].name = s->name[k];
    s->tensor[k].dtype = type;
    s->tensor[k].rank = columns ? 2 : 1;
    s->tensor[k].shape = s->shape[k];
    s->tensor[k].data = s->data[k];
    s->tensor[k].bytes = rows * (columns ? columns : 1) * size;
    return s->data[k];
}

static float row_step(const float *w, size_t n) /* of integers to 127 */
{
    float most = 1e-30f;
    size_t j;
    for (j = 0; j < n; ++j) most = fabsf(w[j]) > most ? fabsf(w[j]) : most;
    return most / 127;
}

static signed char to_i8(float v, float step) { return (signed char)lrintf(v / step); }

/* A dense layer of weight [rows][columns] and bias [rows]; little-endian machines. */
static void saved_dense(saved *s, const char *name, const char *activation, ms_nn_dtype type, size_t rows,
                        size_t columns, const float *weight, const float *bias)
{
    size_t i, j;
    char *at = s->layers + strlen(s->layers);
    void *to = saved_tensor(s, name, "weight", type, rows, columns);
    float *scale = type == MS_NN_I8 ? (float *)saved_tensor(s, name, "weight_scale", MS_NN_F32, rows, 0) : NULL;
    memcpy(saved_tensor(s, name, "bias", MS_NN_F32, rows, 0), bias, rows * sizeof(float));
    for (i = 0; i < rows; ++i) {
        const float *w = weight + i * columns;
        if (scale) scale[i] = row_step(w, columns);
        for (j = 0; j < columns; ++j)
            if (scale) ((signed char *)to)[i * columns + j] = to_i8(w[j], scale[i]);
            else if (type == MS_NN_F16) ((uint16_t *)to)[i * columns + j] = image_to_half(w[j]);
            else ((float *)to)[i * columns + j] = w[j];
    }
    snprintf(at, sizeof s->layers - strlen(s->layers),
             "%s{\"type\":\"dense\",\"name\":\"%s\",\"units\":%.0f,\"activation\":\"%s\"}", at > s->layers ? "," : "",
             name, (double)rows, activation);
}

/* The file in memory. extra: two more entries. */
static int saved_write(saved *s, const char *input, const ms_nn_entry *extra, size_t extras, image__bytes *out)
{
    char *list = (char *)room(strlen(s->layers) + 3, 1);
    ms_nn_entry entry[16];
    ms_error error;
    ms_status status;
    size_t k, size;
    sprintf(list, "[%s]", s->layers);
    entry[0].key = "format", entry[0].value = "pt";
    entry[1].key = "ms_nn_version", entry[1].value = "1";
    entry[2].key = "ms_nn_input", entry[2].value = input;
    entry[3].key = "ms_nn_layers", entry[3].value = list;
    for (k = 0; k < extras; ++k) entry[4 + k] = extra[k];
    memset(out, 0, sizeof *out);
    status = ms_nn_file_write(s->tensor, s->count, entry, 4 + extras, NULL, 0, &size, &error);
    if (status == MS_OK) {
        out->data = (unsigned char *)room(size, 1);
        out->size = out->room = size;
        status = ms_nn_file_write(s->tensor, s->count, entry, 4 + extras, out->data, size, &size, &error);
    }
    return status == MS_OK ? 1 : wrong("%s", error.message);
}

/* --- measures ----------------------------------------------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void report(const char *what, const double *dB, int n)
{
    double mean = 0, *sorted = (double *)room((size_t)n, sizeof(double));
    int i;
    if (n > 0) {
        for (i = 0; i < n; ++i) mean += (sorted[i] = dB[i]) / (double)n;
        qsort(sorted, (size_t)n, sizeof(double), ascending);
        printf("%s: mean %.2f dB, least %.2f, 5%% %.2f, median %.2f of %d pictures\n", what, mean, sorted[0],
               sorted[(int)(0.05 * (n - 1) + 0.5)], sorted[(n - 1) / 2], n);
        fflush(stdout);
    }
}

/* PSNR of a saved network on the pictures of a set, [count]: of all pixels, and of those that `changing` [3][pixels]
   marks. b: a second take of the same, whose noise is another, or NULL. */
static int measure(const ms_nn *nn, const material_set *a, const material_set *b, const char *changing, double *all,
                   double *some)
{
    size_t outputs = ms_nn_output_size(nn), p;
    float *picture = (float *)room(outputs, sizeof(float));
    int i;
    for (i = 0; i < a->count; ++i) {
        const uint16_t *ta = a->value + (size_t)i * outputs, *tb = (b ? b : a)->value + (size_t)i * outputs;
        double sum = 0, part = 0, many = 0;
        if (ms_nn_forward(nn, 1, a->x + i * a->parameters, picture, NULL) != MS_OK) return wrong("out of memory");
        for (p = 0; p < outputs; ++p) {
            float v = picture[p] > 0 ? picture[p] < 1 ? picture[p] : 1 : 0;
            double e = (double)(v - (float)ta[p] / 65535) * (double)(v - (float)tb[p] / 65535);
            sum += e;
            if (changing[p]) part += e, many += 1;
        }
        all[i] = -10 * log10(fmax(sum / (double)outputs, 1e-8));
        some[i] = -10 * log10(fmax(part / fmax(many, 1), 1e-8));
    }
    return 1;
}

/* Of all pictures, and of those whose parameters are not on the edge: uniform ones. */
static int report_all(const char *what, const ms_nn *nn, const material_set *a, const material_set *b,
                      const char *changing)
{
    double *all = (double *)room((size_t)a->count, sizeof(double)),
           *some = (double *)room((size_t)a->count, sizeof(double));
    char text[200];
    int i, j, n = 0, fine = measure(nn, a, b, changing, all, some);
    if (fine) {
        report(what, all, a->count);
        snprintf(text, sizeof text, "%s, pixels that change", what);
        report(text, some, a->count);
        for (i = 0; i < a->count; ++i) {
            int edge = 0;
            for (j = 0; j < a->parameters; ++j)
                edge |= a->x[i * a->parameters + j] <= 0 || a->x[i * a->parameters + j] >= 1;
            if (!edge) all[n] = all[i], some[n++] = some[i];
        }
        if (n < a->count && n > 0) {
            snprintf(text, sizeof text, "%s, inside of the parameters' ranges", what);
            report(text, all, n);
            snprintf(text, sizeof text, "%s, inside, pixels that change", what);
            report(text, some, n);
        }
    }
    return fine;
}

/* --- a renderer --------------------------------------------------------------------------------------------------- */

typedef struct options {
    const char *check[2], *channels, *hidden, *trunk, *sharp;
    int size, held_out, rank, width, depth, epochs, threads, count, first;
    double bytes, rate, seed;
} options;

static double tail(const train_components *c, int rank)
{
    double sum = c->total;
    int j;
    for (j = 0; j < rank; ++j) sum -= c->variance[j];
    return sum > 0 ? sum : 0;
}

/* The rank of a file of so many bytes; inputs, width: of the trunk. */
static int rank_of(double bytes, double trunk_weights, double width, double pixels)
{
    return (int)((bytes - 2 * trunk_weights - 8192 - 4 * pixels) / (2 * pixels + 2 * width));
}

/* Coordinates of the held-out pictures and what no network of this basis can draw of them: for the progress line. */
typedef struct watch {
    int rows, pictures;
    float *x, *c, *guess;
    double *outside; /* [rows] */
} watch;

static double watch_dB(watch *w, trainer *t, size_t outputs)
{
    int i, j, per = w->rows / w->pictures;
    double mean = 0, sum = 0;
    trainer_predict(t, w->rows, w->x, w->guess);
    for (i = 0; i < w->rows; ++i) {
        sum += w->outside[i];
        for (j = 0; j < t->rank; ++j) {
            double d = (double)(w->guess[i * t->rank + j] - w->c[i * t->rank + j]);
            sum += d * d;
        }
        if (i % per < per - 1) continue;
        mean += -10 * log10(fmax(sum / (double)outputs, 1e-9));
        sum = 0;
    }
    return mean / w->pictures;
}

static void watch_make(watch *w, const form *f, const material_set *held, const train_components *c, const float *mean,
                       int rank)
{
    size_t pixels = 3 * (size_t)held->size * (size_t)held->size / (size_t)f->lists, p;
    float *row = (float *)room(pixels, sizeof(float));
    train_work *work = (train_work *)room(1, sizeof *work);
    int i, j;
    w->pictures = held->count;
    w->rows = held->count * f->lists;
    w->x = (float *)room((size_t)w->rows * (size_t)f->inputs, sizeof(float));
    w->c = (float *)room((size_t)w->rows * (size_t)rank, sizeof(float));
    w->guess = (float *)room((size_t)w->rows * (size_t)rank, sizeof(float));
    w->outside = (double *)room((size_t)w->rows, sizeof(double));
    inputs_of(f, held, w->x);
    for (i = 0; i < w->rows; ++i) {
        const uint16_t *y = held->value + (size_t)i * pixels;
        double sum = 0;
        for (p = 0; p < pixels; ++p) {
            row[p] = (float)y[p] / 65535 - mean[p];
            sum += (double)(row[p] * row[p]);
        }
        train_product(work, 1, rank, (int)pixels, train_rows(row, pixels), train_rows(c->basis, (size_t)c->rank),
                      w->c + i * rank, (size_t)rank, 0);
        for (j = 0; j < rank; ++j) sum -= (double)(w->c[i * rank + j] * w->c[i * rank + j]);
        w->outside[i] = sum > 0 ? sum : 0;
    }
}

/* Rows for the network that is learnt: a channel, or a picture. */
static void rows_of(const form *f, const material_set *s, train_pictures *y)
{
    y->value = s->value;
    y->rows = (size_t)s->count * (size_t)f->lists;
    y->pixels = 3 * (size_t)s->size * (size_t)s->size / (size_t)f->lists;
}

/* Trains until o->epochs, or until the error of the held-out pictures has not fallen for a third of them: then the
   weights are those of its minimum. */
static void learn(trainer *t, const options *o, watch *w, size_t outputs, int rows)
{
    int *order = (int *)room((size_t)rows, sizeof(int)), epoch, steps = (rows + t->batch - 1) / t->batch, i,
        best_at = 0, batch = t->batch, epochs = o->epochs, patience = (epochs + 2) / 3;
    float *best = (float *)room(t->net.count, sizeof(float));
    double start = now(), said = start, most = -1e300;
    for (epoch = 1; epoch <= epochs; ++epoch) {
        uint64_t seed = (uint64_t)o->seed * 1000003u + (uint64_t)epoch - 1;
        double sum = 0, at, held;
        for (i = 0; i < rows; ++i) order[i] = i;
        for (i = rows - 1; i > 0; --i) {
            int k = (int)(train_bits(&seed) % (uint64_t)(i + 1)), v = order[i];
            order[i] = order[k];
            order[k] = v;
        }
        for (i = 0; i < rows; i += batch) {
            int k, chunks;
            t->order = order + i;
            t->batch = rows - i < batch ? rows - i : batch;
            chunks = (t->batch + CHUNK - 1) / CHUNK;
            t->rate = (float)o->rate * train_cycle((double)t->step / ((double)steps * epochs), &t->beta1);
            train_adam_count(&t->adam, t->beta1);
            train_run(t->pool, chunks, step_chunk, t);
            train_run(t->pool, 4, step_update, t);
            for (k = 0; k < chunks; ++k) sum += t->sum[k];
            ++t->step;
        }
        t->batch = batch;
        held = watch_dB(w, t, outputs);
        if (held > most + 0.01) {
            most = held;
            best_at = epoch;
            memcpy(best, t->net.p, t->net.count * sizeof(float));
        }
        at = now();
        if (at - said > 10 || epoch == epochs || (epoch - 1) % (epochs / 10 + 1) == 0) {
            printf("epoch %d of %d: error of training %.2f dB, of the held-out %.2f dB; %.0f s, %.0f s left\n", epoch,
                   epochs, -10 * log10(fmax(sum / rows * (t->f->lists) / (double)outputs, 1e-9)), held, at - start,
                   (at - start) / epoch * (epochs - epoch));
            said = at;
        }
        if (epoch - best_at >= patience && epoch < epochs) {
            memcpy(t->net.p, best, t->net.count * sizeof(float));
            printf("stopped after %d of %d epochs: the error of the held-out pictures has not fallen since epoch %d "
                   "(%.2f dB); more pictures will help, more steps will not\n",
                   epoch, epochs, best_at, most);
            break;
        }
        fflush(stdout);
    }
}

/* --- a larger picture from the coordinates of a smaller one ------------------------------------------------------- */

/* The pixels' layer for pictures of the full size, whose noise is too large for components of their own (and to go
   through the display's curve): each pixel is regressed on the coordinates that its averages gave, in the tangent of
   the curve at what the last pass drew, where noise of mean zero stays so. Then what looks like noise is taken from the
   layer's columns, which are pictures. */
typedef struct larger {
    const material_set *s; /* linear light */
    const train_components *c;
    int rank, lists, first;
    float kept[3 * 1024];
    float *basis, *mean;     /* [pixels][rank], [pixels]: of the last pass */
    float *next, *next_mean; /* of this one */
    float
        *variance; /* [pixels][rank]: of basis, from what is left of each row: rows that weigh much may be noisy ones */
    float *half, *decode, *slope; /* tables: of halves, of display values in 4095ths */
} larger;

enum { LARGER_TILE = 512, LARGER_ROWS = 96 };

static void larger_tile(void *context, int tile)
{
    block mine = {&mine, &mine};
    larger *l = (larger *)context;
    size_t pixels = 3 * (size_t)l->s->size * (size_t)l->s->size / (size_t)l->lists,
           rows = (size_t)l->s->count * (size_t)l->lists, from = (size_t)tile * LARGER_TILE, i, p;
    int wide = pixels - from < LARGER_TILE ? (int)(pixels - from) : (int)LARGER_TILE, n, j, r = l->rank;
    float *y = (float *)room_in(&mine, LARGER_ROWS * LARGER_TILE, sizeof(float)),
          *z = (float *)zeros_in(&mine, (size_t)wide * (size_t)r, sizeof(float));
    float *left = (float *)zeros_in(&mine, LARGER_ROWS * LARGER_TILE, sizeof(float)),
          *square = (float *)room_in(&mine, (size_t)LARGER_ROWS * (size_t)r, sizeof(float)),
          *z2 = (float *)zeros_in(&mine, (size_t)wide * (size_t)r, sizeof(float));
    double *sum = (double *)zeros_in(&mine, LARGER_TILE, sizeof(double));
    train_work *w = (train_work *)room_in(&mine, 1, sizeof *w);
    for (i = 0; i < rows; i += LARGER_ROWS) {
        n = rows - i < LARGER_ROWS ? (int)(rows - i) : (int)LARGER_ROWS;
        if (!l->first)
            train_product(w, n, wide, r, train_rows(l->c->coordinate + i * (size_t)r, (size_t)r),
                          train_transposed(l->basis + from * (size_t)r, (size_t)r), y, (size_t)wide, 0);
        for (j = 0; j < n; ++j) {
            const uint16_t *in = l->s->linear + (i + (size_t)j) * pixels + from;
            float *out = y + (size_t)j * (size_t)wide;
            for (p = 0; p < (size_t)wide; ++p) {
                float light = l->half[in[p]], v, target;
                int at;
                if (l->first) {
                    v = light < 1 ? image_srgb_encode(light) : 1;
                    out[p] = v - l->mean[from + p];
                    continue;
                }
                v = out[p] + l->mean[from + p];
                v = v > 0 ? v < 1 ? v : 1 : 0;
                at = (int)(v * 4095 + 0.5f);
                target = v + l->slope[at] * (light - l->decode[at]);
                target = target < -0.3f ? -0.3f : target > 1.3f ? 1.3f : target;
                left[j * wide + (int)p] = (target - v) * (target - v);
                out[p] = target - l->mean[from + p];
                sum[p] += (double)out[p];
            }
        }
        train_product(w, wide, r, n, train_transposed(y, (size_t)wide),
                      train_rows(l->c->coordinate + i * (size_t)r, (size_t)r), z, (size_t)r, 1);
        for (j = 0; j < n * r; ++j)
            square[j] = l->c->coordinate[i * (size_t)r + (size_t)j] * l->c->coordinate[i * (size_t)r + (size_t)j];
        if (!l->first)
            train_product(w, wide, r, n, train_transposed(left, (size_t)wide), train_rows(square, (size_t)r), z2,
                          (size_t)r, 1);
    }
    for (p = 0; p < (size_t)wide; ++p) {
        l->next_mean[from + p] = l->mean[from + p] + (float)(sum[p] / (double)rows);
        for (j = 0; j < r; ++j) {
            float by = 1 / (float)((double)rows * l->c->variance[j]);
            l->next[(from + p) * (size_t)r + (size_t)j] = z[p * (size_t)r + (size_t)j] * by;
            l->variance[(from + p) * (size_t)r + (size_t)j] = z2[p * (size_t)r + (size_t)j] * by * by;
        }
    }
    drop_all(&mine);
}

/* Wiener's filter on the levels of Haar's transform: of a plane [size][size] whose values have noise of these
   variances, what the pixels of a block of 2 x 2 differ from their mean by is shrunk by the share of noise in 5 x 5
   blocks; then the means, down to an odd size or 32. Returns how much of the finest level is kept. */
static double wiener(float *plane, const float *variance, int size)
{
    block mine = {&mine, &mine};
    int small = size / 2, x, y, u, v, q;
    size_t count = (size_t)small * (size_t)small;
    float *mean, *old, *noise, *energy;
    double kept = 0;
    if (size % 2 || size <= 32) return 1;
    mean = (float *)zeros_in(&mine, count, sizeof(float));
    old = (float *)room_in(&mine, count, sizeof(float));
    noise = (float *)zeros_in(&mine, count, sizeof(float));
    energy = (float *)zeros_in(&mine, count, sizeof(float));
    for (y = 0; y < size; ++y)
        for (x = 0; x < size; ++x) {
            mean[y / 2 * small + x / 2] += plane[y * size + x] / 4;
            noise[y / 2 * small + x / 2] += variance[y * size + x] / 16;
        }
    for (y = 0; y < size; ++y)
        for (x = 0; x < size; ++x) {
            float d = plane[y * size + x] - mean[y / 2 * small + x / 2];
            energy[y / 2 * small + x / 2] += d * d;
        }
    memcpy(old, mean, count * sizeof(float));
    (void)wiener(mean, noise, small);
    for (y = 0; y < small; ++y)
        for (x = 0; x < small; ++x) {
            float e = 0, s = 0, keep;
            for (v = y > 1 ? y - 2 : 0; v < small && v <= y + 2; ++v)
                for (u = x > 1 ? x - 2 : 0; u < small && u <= x + 2; ++u)
                    e += energy[v * small + u], s += 12 * noise[v * small + u]; /* 4 values less their mean */
            keep = e > 2 * s ? 1 - 2 * s / e : 0; /* twice: the noise of the few brightest paths is not known well */
            kept += (double)keep / (double)count;
            for (q = 0; q < 4; ++q) {
                float *d = plane + (2 * y + q / 2) * size + 2 * x + q % 2;
                *d = (*d - old[y * small + x]) * keep + mean[y * small + x];
            }
        }
    drop_all(&mine);
    return kept;
}

/* Every column of the layer, which is a picture. */
static void larger_shrink(void *context, int task)
{
    block mine = {&mine, &mine};
    larger *l = (larger *)context;
    int size = l->s->size, planes = 3 / l->lists, j = task / planes;
    size_t count = (size_t)size * (size_t)size, at = (size_t)(task % planes) * count, i, step = (size_t)l->rank;
    float *from = l->basis + at * step + j, *plane = (float *)zeros_in(&mine, count, sizeof(float)),
          *variance = (float *)zeros_in(&mine, count, sizeof(float));
    for (i = 0; i < count; ++i) {
        plane[i] = from[i * step];
        variance[i] = l->variance[(at + i) * step + (size_t)j];
    }
    l->kept[task] = (float)wiener(plane, variance, size);
    for (i = 0; i < count; ++i) from[i * step] = plane[i];
    drop_all(&mine);
}

/* c and mean become those of s's size. The components of c are orthogonal on s's rows, its coordinates of mean zero. */
static void larger_basis(train_pool *pool, const material_set *s, int lists, int rank, train_components *c,
                         float **mean)
{
    larger l;
    size_t pixels = 3 * (size_t)s->size * (size_t)s->size / (size_t)lists, rows = (size_t)s->count * (size_t)lists, i,
           p;
    int pass, k, tiles = (int)((pixels + LARGER_TILE - 1) / LARGER_TILE);
    memset(&l, 0, sizeof l);
    l.s = s;
    l.c = c;
    l.rank = rank;
    l.lists = lists;
    l.basis = (float *)zeros(pixels * (size_t)rank, sizeof(float));
    l.next = (float *)zeros(pixels * (size_t)rank, sizeof(float));
    l.mean = (float *)zeros(pixels, sizeof(float));
    l.next_mean = (float *)zeros(pixels, sizeof(float));
    l.variance = (float *)zeros(pixels * (size_t)rank, sizeof(float));
    l.half = (float *)room(65536, sizeof(float));
    l.decode = (float *)room(4096, sizeof(float));
    l.slope = (float *)room(4096, sizeof(float));
    for (k = 0; k < 65536; ++k) l.half[k] = image_from_half((uint16_t)k);
    for (k = 0; k < 4096; ++k) {
        float v = (float)k / 4095, e = 1e-3f;
        l.decode[k] = image_srgb_decode(v);
        l.slope[k] = 2 * e /
            (image_srgb_decode(v + e) - image_srgb_decode(v > e ? v - e : 0) + (v > e ? 0 : e / 12.92f));
    }
    for (i = 0; i < rows; i += rows / 200 + 1) /* a start for the mean */
        for (p = 0; p < pixels; ++p) {
            float light = l.half[s->linear[i * pixels + p]];
            l.mean[p] += light < 1 ? image_srgb_encode(light) : 1;
        }
    for (k = 0, i = 0; i < rows; i += rows / 200 + 1) ++k;
    for (p = 0; p < pixels; ++p) l.mean[p] /= (float)k;
    for (pass = 0; pass < 3; ++pass) {
        float *t;
        l.first = pass == 0;
        train_run(pool, tiles, larger_tile, &l);
        t = l.basis, l.basis = l.next, l.next = t;
        if (pass) t = l.mean, l.mean = l.next_mean, l.next_mean = t;
        if (pass) train_run(pool, rank * 3 / lists, larger_shrink, &l);
    }
    printf("detail of %d x %d: kept of the first features' %.2f %.2f %.2f, of the last %.2f; the rest is noise\n",
           s->size, s->size, (double)l.kept[0], (double)l.kept[3 / lists], (double)l.kept[2 * 3 / lists],
           (double)l.kept[(rank - 1) * 3 / lists]);
    c->basis = l.basis;
    c->rank = rank;
    *mean = l.mean;
}

static void say_form(const form *f, const material_set *s)
{
    int c, k;
    if (f->lists == 1) printf("channels: one network for all three\n");
    for (c = 0; c < 3 && f->lists == 3; ++c) {
        printf(c ? ";" : "channels: share a network, inputs ");
        for (k = 0; k < f->inputs; ++k) printf("%s%d", k ? "," : "", f->list[c][k]);
    }
    if (f->lists == 3) printf(" of %d parameters\n", s->parameters);
    if (f->rules) printf("hidden: ");
    for (k = 0; k < f->rules; ++k)
        printf("%s%d@%d=%d", k ? "," : "", f->rule[k].column, f->rule[k].gate, f->rule[k].value);
    if (f->rules) printf("\n");
    fflush(stdout);
}

/* The first 8 coordinates of rows, scaled, for the regressions. */
static float *leading(const train_components *c, size_t rows)
{
    float *y = (float *)zeros(rows * OUTPUTS, sizeof(float));
    size_t i;
    int j;
    for (i = 0; i < rows; ++i)
        for (j = 0; j < OUTPUTS && j < c->rank; ++j)
            y[i * OUTPUTS + (size_t)j] = c->coordinate[i * (size_t)c->rank + (size_t)j];
    return y;
}

/* The network as a file in memory. */
static int renderer_file(const trainer *t, const form *f, const train_components *c, const float *mean,
                         const material_set *s, image__bytes *out)
{
    saved file;
    ms_nn_entry extra[4];
    char name[16], input[32], *ranges = (char *)zeros((size_t)s->parameters * 64 + 1, 1), number[48], about[100],
                              *sharp = (char *)zeros((size_t)s->parameters * 5 + 1, 1);
    size_t pixels = 3 * (size_t)s->size * (size_t)s->size / (size_t)f->lists, i;
    int l, k, j, rank = t->rank, hidden = t->net.size[t->net.layers - 1], fine;
    float *w, *b;
    memset(&file, 0, sizeof file);
    if (f->lists == 3) {
        strcpy(file.layers, "{\"type\":\"shared_channels\",\"inputs\":[");
        for (l = 0; l < 3; ++l)
            for (k = 0; k < f->inputs; ++k)
                snprintf(file.layers + strlen(file.layers), sizeof file.layers - strlen(file.layers), "%s%d%s",
                         k       ? ","
                             : l ? ",["
                                 : "[",
                         f->list[l][k], k + 1 < f->inputs ? "" : "]");
        strcat(file.layers, "]}");
    }
    for (l = 0; l + 1 < t->net.layers; ++l) {
        snprintf(name, sizeof name, "hidden%d", l + 1);
        saved_dense(&file, name, t->net.silu ? "silu" : "elu", MS_NN_F16, (size_t)t->net.size[l + 1],
                    (size_t)t->net.size[l], train_weight(&t->net, l), train_bias(&t->net, l));
    }
    w = (float *)room((size_t)rank * (size_t)hidden, sizeof(float));
    b = (float *)room((size_t)rank, sizeof(float));
    for (j = 0; j < rank; ++j) {
        for (k = 0; k < hidden; ++k)
            w[j * hidden + k] = train_weight(&t->net, t->net.layers - 1)[j * hidden + k] * t->scale;
        b[j] = train_bias(&t->net, t->net.layers - 1)[j] * t->scale;
    }
    saved_dense(&file, "features", "linear", MS_NN_F16, (size_t)rank, (size_t)hidden, w, b);
    w = (float *)room(pixels * (size_t)rank, sizeof(float));
    for (i = 0; i < pixels; ++i)
        for (j = 0; j < rank; ++j) w[i * (size_t)rank + (size_t)j] = c->basis[i * (size_t)c->rank + (size_t)j];
    saved_dense(&file, "pixels", "linear", MS_NN_F16, pixels, (size_t)rank, w, mean);
    for (j = 0; j < s->parameters; ++j) {
        if (j) strcat(ranges, ",");
        strcat(ranges, number_text(number, "%.9g", s->low[j]));
        strcat(ranges, ":");
        strcat(ranges, number_text(number, "%.9g", s->high[j]));
    }
    snprintf(input, sizeof input, "[%d]", s->parameters);
    snprintf(about, sizeof about, "%d pictures of %d x %d", s->count, s->size, s->size);
    extra[0].key = "ms_parameters", extra[0].value = s->names;
    extra[1].key = "ms_ranges", extra[1].value = ranges;
    extra[2].key = "ms_trained_on", extra[2].value = about;
    for (j = 0; j < s->parameters; ++j) { /* what is at 0 or 1 in many materials */
        int edge = 0;
        for (k = 0; k < s->count; ++k) edge += s->x[k * s->parameters + j] <= 0 || s->x[k * s->parameters + j] >= 1;
        if (10 * edge > s->count) sprintf(sharp + strlen(sharp), "%s%d", *sharp ? "," : "", j);
    }
    extra[3].key = "ms_sharp", extra[3].value = sharp;
    fine = saved_write(&file, input, extra, *sharp ? 4 : 3, out);
    return fine;
}

/* Pixels [3][size][size] whose deviation over the pictures is above a hundredth of white; of two takes (b, or NULL)
   without their noise. */
static char *changing_pixels(const material_set *a, const material_set *b)
{
    size_t pixels = 3 * (size_t)a->size * (size_t)a->size, p;
    char *mark = (char *)zeros(pixels, 1);
    double *sum = (double *)zeros(3 * pixels, sizeof(double)), count = 0;
    int i;
    for (i = 0; i < a->count; ++i)
        for (p = 0; p < pixels; ++p) {
            double v = a->value[(size_t)i * pixels + p] / 65535.0,
                   w = b ? b->value[(size_t)i * pixels + p] / 65535.0 : v;
            sum[p] += v;
            sum[pixels + p] += w;
            sum[2 * pixels + p] += v * w;
        }
    for (p = 0; p < pixels; ++p) {
        mark[p] = sum[2 * pixels + p] / a->count - sum[p] / a->count * (sum[pixels + p] / a->count) > 1e-4;
        count += mark[p];
    }
    printf("pixels that change with the material, by a hundredth of white and more: %.0f%%\n",
           100 * count / (double)pixels);
    return mark;
}

/* Pictures of --check, as `like` (or NULL) says; sets that are two takes must be of the same materials. */
static int read_checks(train_pool *pool, const options *o, const char *csv, int size, const material_set *like,
                       material_set *check)
{
    int k;
    memset(check, 0, 2 * sizeof *check);
    for (k = 0; k < 2 && o->check[k]; ++k)
        if (!set_read(pool, o->check[k], csv, size, like || k == 0 ? like : &check[0], &check[k])) return 0;
    if (check[1].count &&
        (check[0].count != check[1].count ||
         memcmp(check[0].x, check[1].x, (size_t)check[0].count * (size_t)check[0].parameters * sizeof(float)) != 0))
        return wrong("%s: other materials than %s", o->check[1], o->check[0]);
    return 1;
}

/* What is saved is what is measured: on the sets of --check, and on held-out pictures unless that is NULL. */
static int measure_and_save(const char *path, const image__bytes *bytes, const material_set *check,
                            const material_set *held, const char *changing, double start)
{
    ms_nn *nn = NULL;
    ms_error error;
    const char *problem;
    int fine = 1;
    if (ms_nn_load(bytes->data, bytes->size, NULL, &nn, &error) != MS_OK) return wrong("%s", error.message);
    if (check[0].count) fine = report_all("check", nn, &check[0], check[1].count ? &check[1] : NULL, changing);
    if (fine && held) fine = report_all("held out", nn, held, NULL, changing);
    ms_nn_destroy(nn);
    if (!fine) return 0;
    problem = file_save(path, bytes->data, bytes->size);
    if (problem) return wrong("%s: %s", path, problem);
    printf("%s: %.2f MB; %.0f s\n", path, 1e-6 * (double)bytes->size, now() - start);
    return 1;
}

static int train_renderer(train_pool *pool, const char *pictures, const char *csv, const char *path, options *o)
{
    material_set s, held, check[2];
    train_pictures y;
    train_components c;
    form f;
    trainer t;
    watch w;
    image__bytes bytes;
    size_t pixels, i;
    int sizes[TRAIN_LAYERS + 1], k, fine, n, j;
    char *changing;
    double start = now();
    float *x;
    if (!set_read(pool, pictures, csv, o->size, NULL, &s) || !read_checks(pool, o, csv, s.size, &s, check)) return 0;
    n = o->held_out > 0 ? o->held_out : check[0].count ? 0 : s.count / 16 + 1;
    if (s.count - n < 16)
        return wrong("%s: %d pictures; at least %d are needed, some hundred are sensible", pictures, s.count, n + 16);
    pixels = 3 * (size_t)s.size * (size_t)s.size;
    printf("%d pictures of %d x %d, %d parameters; %d held out; %.0f s to read\n", s.count, s.size, s.size,
           s.parameters, n ? n : check[0].count, now() - start);
    fflush(stdout);

    /* those held out, spread evenly, go behind the others */
    held = s;
    if (n) {
        uint16_t *v = (uint16_t *)room((size_t)s.count * pixels, sizeof(uint16_t));
        int at = 0, last = s.count - n;
        x = (float *)room((size_t)s.count * (size_t)s.parameters, sizeof(float));
        for (k = 0; k < s.count; ++k) {
            int is_held = (int)((long)(k + 1) * n / s.count) > (int)((long)k * n / s.count),
                to = is_held ? last++ : at++;
            memcpy(v + (size_t)to * pixels, s.value + (size_t)k * pixels, pixels * sizeof(uint16_t));
            memcpy(x + to * s.parameters, s.x + k * s.parameters, (size_t)s.parameters * sizeof(float));
        }
        drop(s.value);
        drop(s.x);
        s.value = v;
        s.x = x;
        held.count = n;
        s.count -= n;
        held.value = s.value + (size_t)s.count * pixels;
        held.x = s.x + s.count * s.parameters;
    } else held = check[0];
    changing = check[1].count ? changing_pixels(&check[0], &check[1]) : changing_pixels(&s, NULL);

    /* the channels as rows, or whole pictures, and their components */
    memset(&f, 0, sizeof f);
    no_sharing(&f, s.parameters);
    f.lists = 3;
    y.mean = (float *)room(pixels, sizeof(float));
    rows_of(&f, &s, &y);
    k = o->bytes > 0 ? 192 : o->rank;
    if (!train_principal(pool, &y, k, 3, (uint64_t)o->seed, &c)) return wrong("out of memory");
    if (c.total < 1e-12 * (double)y.pixels) return wrong("%s: all pictures are alike", pictures);
    if (strcmp(o->channels, "auto") == 0) {
        float *lead = leading(&c, y.rows);
        find_channels(pool, &s, lead, (uint64_t)o->seed, &f);
    } else no_sharing(&f, s.parameters);
    if (f.lists == 1) {
        train_components_free(&c);
        rows_of(&f, &s, &y);
        if (!train_principal(pool, &y, k, 3, (uint64_t)o->seed, &c)) return wrong("out of memory");
    }
    x = (float *)room(y.rows * (size_t)f.inputs, sizeof(float));
    inputs_of(&f, &s, x);
    if (strcmp(o->hidden, "auto") == 0) {
        float *lead = leading(&c, y.rows);
        find_hidden(pool, (int)y.rows, f.inputs, x, lead, (uint64_t)o->seed, &f);
    }
    say_form(&f, &s);
    if (o->bytes > 0)
        o->rank = rank_of(o->bytes, ((double)f.inputs + (o->depth - 1.0) * o->width) * o->width, o->width,
                          (double)y.pixels);
    if (o->rank > c.rank) o->rank = c.rank;
    if (o->rank < 1) return wrong("--bytes %.0f is too few for pictures of %d x %d", o->bytes, s.size, s.size);
    printf("rank %d leaves %.2f dB; %.0f s so far\n", o->rank,
           -10 * log10(fmax(tail(&c, o->rank) / (double)y.pixels, 1e-10)), now() - start);

    /* the trunk learns the coordinates */
    sizes[0] = f.inputs;
    for (k = 1; k <= o->depth; ++k) sizes[k] = o->width;
    sizes[o->depth + 1] = o->rank;
    if (o->epochs == 0) {
        o->epochs = (int)(16000.0 / (double)((y.rows + BATCH - 1) / BATCH));
        if (o->epochs > 1500) o->epochs = 1500;
    }
    memset(&w, 0, sizeof w);
    watch_make(&w, &f, &held, &c, y.mean, o->rank);
    if (o->rank < c.rank) /* the first ones, close together */
        for (i = 0; i < y.rows; ++i)
            for (j = 0; j < o->rank; ++j)
                c.coordinate[i * (size_t)o->rank + (size_t)j] = c.coordinate[i * (size_t)c.rank + (size_t)j];
    trainer_start(&t, pool, &f, sizes, o->depth + 2, BATCH, (uint64_t)o->seed);
    t.net.silu = 1; /* smoother than ELUs: a decibel on materials that it never saw */
    for (i = 0; i < t.net.count; ++i) t.net.p[i] *= 1.6f; /* they halve what goes through */
    t.scale = (float)sqrt((c.total > 0 ? c.total : 1)) / 8;
    t.floor = 1e-6f * (float)y.pixels;
    t.batch = BATCH;
    t.x = x;
    t.c = c.coordinate;
    learn(&t, o, &w, pixels, (int)y.rows);

    fine = renderer_file(&t, &f, &c, y.mean, &s, &bytes) &&
        measure_and_save(path, &bytes, check, n ? &held : NULL, changing, start);
    free(t.net.p);
    train_components_free(&c);
    return fine;
}

/* --- inversion networks ------------------------------------------------------------------------------------------- */

enum { PART = 32 }; /* pictures of a task */

/* A renderer of train_renderer's form with its last layer turned to an orthonormal basis q: u = q' (picture - mean) of
   each list. */
typedef struct frozen {
    train_net net; /* inputs of a list -> u [rank] */
    form f;
    int parameters, size, rank, sharp[MOST_PARAMETERS], sharps;
    float *q, *mean, *ones_u, *mean_u; /* [pixels][rank], [pixels], q' 1 and q' mean [rank] */
    size_t pixels;
} frozen;

static float tensor_value(const ms_nn_tensor *t, size_t i)
{
    float f;
    uint16_t h;
    if (t->dtype == MS_NN_I8) return (float)((const signed char *)t->data)[i];
    if (t->dtype == MS_NN_F16) {
        memcpy(&h, (const char *)t->data + 2 * i, 2);
        return image_from_half(h);
    }
    memcpy(&f, (const char *)t->data + 4 * i, 4);
    return f;
}

/* weight [rows][columns] and bias [rows] of a dense layer as floats; 0: there is no such layer. */
static int tensor_dense(const ms_nn_file *file, const char *name, size_t *rows, size_t *columns, float **weight,
                        float **bias)
{
    char full[64];
    const ms_nn_tensor *w, *b, *scale;
    size_t i;
    snprintf(full, sizeof full, "%.40s.weight", name);
    w = ms_nn_file_find(file, full);
    snprintf(full, sizeof full, "%.40s.bias", name);
    b = ms_nn_file_find(file, full);
    snprintf(full, sizeof full, "%.40s.weight_scale", name);
    scale = ms_nn_file_find(file, full);
    if (w == NULL || b == NULL || w->rank != 2 ||
        (w->dtype != MS_NN_I8 && w->dtype != MS_NN_F16 && w->dtype != MS_NN_F32))
        return 0;
    *rows = w->shape[0];
    *columns = w->shape[1];
    *weight = (float *)room(*rows * *columns, sizeof(float));
    *bias = (float *)room(*rows, sizeof(float));
    for (i = 0; i < *rows * *columns; ++i)
        (*weight)[i] = tensor_value(w, i) * (scale ? tensor_value(scale, i / *columns) : 1);
    for (i = 0; i < *rows; ++i) (*bias)[i] = tensor_value(b, i);
    return 1;
}

static int frozen_load(const char *path, const char *sharp, frozen *r)
{
    ms_nn *nn;
    ms_error error;
    const char *layers, *at;
    char name[24], *end;
    size_t rows[TRAIN_LAYERS], columns[TRAIN_LAYERS], i, j, k, n;
    float *weight[TRAIN_LAYERS], *bias[TRAIN_LAYERS], *basis;
    double *gram;
    int sizes[TRAIN_LAYERS + 1], count = 0, silu = 0, c, l;
    uint64_t seed = 1;
    memset(r, 0, sizeof *r);
    if (ms_nn_load_file(path, NULL, &nn, &error) != MS_OK) return wrong("%s: %s", path, error.message);
    r->parameters = (int)ms_nn_input_size(nn);
    layers = ms_nn_file_metadata(ms_nn_tensors(nn), "ms_nn_layers");
    if (sharp == NULL) sharp = ms_nn_file_metadata(ms_nn_tensors(nn), "ms_sharp");
    while (count < TRAIN_LAYERS - 1) {
        snprintf(name, sizeof name, "hidden%d", count + 1);
        if (!tensor_dense(ms_nn_tensors(nn), name, &rows[count], &columns[count], &weight[count], &bias[count])) break;
        ++count;
    }
    if (count == 0 || r->parameters > MOST_PARAMETERS ||
        !tensor_dense(ms_nn_tensors(nn), "features", &rows[count], &columns[count], &weight[count], &bias[count]) ||
        !tensor_dense(ms_nn_tensors(nn), "pixels", &r->pixels, &n, &basis, &r->mean) || n != rows[count] || n > 900)
        return wrong("%s: no renderer as this program makes them: hidden1 ..., features and pixels are its layers",
                     path);
    no_sharing(&r->f, r->parameters);
    at = strstr(layers, "\"inputs\":[[");
    if (at == NULL) at = strstr(layers, "\"inputs\": [[");
    if (at) {
        r->f.lists = 3;
        at = strchr(at, '[') + 1;
        for (c = 0; c < 3; ++c)
            for (at = strchr(at, '[') + 1, l = 0;; ++l) {
                r->f.list[c][l] = (int)strtol(at, &end, 10);
                at = end + strspn(end, ", ");
                if (*at == ']' || l + 1 == MOST_PARAMETERS) {
                    r->f.inputs = l + 1;
                    break;
                }
            }
    }
    if (columns[0] != (size_t)r->f.inputs || ms_nn_output_size(nn) != (size_t)r->f.lists * r->pixels)
        return wrong("%s: its layers do not fit each other", path);
    for (l = 0; l < ms_nn_layer_count(nn); ++l)
        if (strcmp(ms_nn_layer_at(nn, l).name, "hidden1") == 0)
            silu = strcmp(ms_nn_layer_at(nn, l).activation, "silu") == 0;
    while (sharp && *sharp && r->sharps < MOST_PARAMETERS) {
        l = (int)strtol(sharp, &end, 10);
        if (end == sharp) break;
        if (l >= 0 && l < r->parameters) r->sharp[r->sharps++] = l;
        sharp = end + strspn(end, ",");
    }
    ms_nn_destroy(nn);
    r->rank = (int)n;
    while (3 * (size_t)r->size * (size_t)r->size < (size_t)r->f.lists * r->pixels) ++r->size;
    /* basis = q r; features go through r */
    gram = (double *)zeros(n * n, sizeof(double));
    for (i = 0; i < r->pixels; ++i)
        for (j = 0; j < n; ++j)
            for (k = 0; k <= j; ++k) gram[j * n + k] += (double)basis[i * n + j] * (double)basis[i * n + k];
    for (j = 0; j < n; ++j) gram[j * n + j] *= 1 + 1e-9;
    train_cholesky((int)n, gram, 1e-12); /* r = l' */
    r->q = basis;
    for (i = 0; i < r->pixels; ++i)
        for (j = 0; j < n; ++j) { /* q r = basis, column by column */
            double s = (double)basis[i * n + j];
            for (k = 0; k < j; ++k) s -= (double)basis[i * n + k] * gram[j * n + k];
            basis[i * n + j] = (float)(s / gram[j * n + j]);
        }
    sizes[0] = r->f.inputs;
    for (l = 0; l <= count; ++l) sizes[l + 1] = (int)rows[l];
    if (!train_net_make(&r->net, sizes, count + 2, 0, &seed)) return wrong("out of memory");
    r->net.silu = silu;
    for (l = 0; l < count; ++l) {
        memcpy(train_weight(&r->net, l), weight[l], rows[l] * columns[l] * sizeof(float));
        memcpy(train_bias(&r->net, l), bias[l], rows[l] * sizeof(float));
    }
    for (i = 0; i < n; ++i) { /* row i of r times the features */
        for (k = 0; k <= columns[count]; ++k) {
            double s = 0;
            for (j = i; j < n; ++j)
                s += gram[j * n + i] *
                    (double)(k < columns[count] ? weight[count][j * columns[count] + k] : bias[count][j]);
            if (k < columns[count]) train_weight(&r->net, count)[i * columns[count] + k] = (float)s;
            else train_bias(&r->net, count)[i] = (float)s;
        }
    }
    r->ones_u = (float *)zeros(n, sizeof(float));
    r->mean_u = (float *)zeros(n, sizeof(float));
    for (i = 0; i < r->pixels; ++i)
        for (j = 0; j < n; ++j) {
            r->ones_u[j] += r->q[i * n + j];
            r->mean_u[j] += r->q[i * n + j] * r->mean[i];
        }
    for (l = 0; l <= count; ++l) {}
    return 1;
}

typedef struct inverting {
    const frozen *r;
    int nets, batch, parts;
    train_net net[16];
    train_adam adam[16];
    float *grad[16][16]; /* [part][net] */
    float rate, share, scale;
    uint64_t seed;
    train_work *work[16];
    float *u[16], *x[16], *rows[16], *act[16][16][TRAIN_LAYERS], *ract[16][16][TRAIN_LAYERS], *g[16], *spare[16],
        *gx[16], *guess[16];
    double best[16], one[16];
    int only_measure;
} inverting;

/* Materials of a step as they are drawn: half uniform, half with the sharp parameters at 0 or 1. */
static void draw(const frozen *r, int n, float *x, uint64_t *seed)
{
    int i, j;
    for (i = 0; i < n; ++i, x += r->parameters) {
        for (j = 0; j < r->parameters; ++j) x[j] = train_uniform(seed);
        for (j = 0; j < r->sharps && i % 2; ++j) x[r->sharp[j]] = x[r->sharp[j]] < 0.5f ? 0.0f : 1.0f;
    }
}

/* u [n][lists][rank] of x [n][parameters]; act keeps what a gradient needs. */
static void frozen_run(const frozen *r, train_work *w, int n, const float *x, float *rows, float *const *act, float *u)
{
    int i, c, k;
    float *to = rows;
    for (i = 0; i < n; ++i)
        for (c = 0; c < r->f.lists; ++c)
            for (k = 0; k < r->f.inputs; ++k) *to++ = x[i * r->parameters + r->f.list[c][k]];
    train_forward(&r->net, w, n * r->f.lists, rows, act);
    if (u) memcpy(u, act[r->net.layers - 1], (size_t)n * (size_t)r->f.lists * (size_t)r->rank * sizeof(float));
}

/* What painters do, where it is linear in display values: a gain, an offset, and channels mixed by rows of sum 1. */
static void edit(const frozen *r, float *u, uint64_t *seed)
{
    float mix[3][3], g = 1 + 0.25f * (train_uniform(seed) - 0.5f), o = 0.08f * (train_uniform(seed) - 0.5f),
                     a = 0.35f * train_uniform(seed);
    int c, b, j, lists = r->f.lists, rank = r->rank;
    for (c = 0; c < 3; ++c) {
        float mean = 0;
        for (b = 0; b < 3; ++b) mean += (mix[c][b] = a * train_normal(seed)) / 3;
        for (b = 0; b < 3; ++b) mix[c][b] += (float)(b == c) - mean;
    }
    for (j = 0; j < rank; ++j) {
        float v[3] = {0, 0, 0};
        for (c = 0; c < lists; ++c)
            for (b = 0; b < lists; ++b) v[c] += (lists == 3 ? mix[c][b] : 1) * u[b * rank + j];
        for (c = 0; c < lists; ++c) u[c * rank + j] = g * v[c] + (g - 1) * r->mean_u[j] + o * r->ones_u[j];
    }
}

static void invert_part(void *context, int part)
{
    inverting *t = (inverting *)context;
    const frozen *r = t->r;
    int wide = r->f.lists * r->rank, i, j, k, last = r->net.layers - 1, d = r->parameters;
    float *u = t->u[part], *scaled = t->guess[part];
    double error[16][PART];
    uint64_t seed = t->seed * 64 + (uint64_t)part;
    t->best[part] = t->one[part] = 0;
    draw(r, PART, t->x[part], &seed);
    frozen_run(r, t->work[part], PART, t->x[part], t->rows[part], t->ract[part][0], u);
    for (i = 0; i < PART && !t->only_measure; ++i)
        if (train_uniform(&seed) < 0.3f) edit(r, u + i * wide, &seed);
    for (i = 0; i < PART * wide; ++i) scaled[i] = u[i] * t->scale;
    for (k = 0; k < t->nets; ++k) { /* errors first: who is best of a picture learns most of it */
        train_forward(&t->net[k], t->work[part], PART, scaled, t->act[part][k]);
        frozen_run(r, t->work[part], PART, t->act[part][k][t->net[k].layers - 1], t->rows[part], t->ract[part][k],
                   NULL);
        for (i = 0; i < PART; ++i) {
            const float *v = t->ract[part][k][last] + i * wide;
            double s = 0;
            for (j = 0; j < wide; ++j) s += (double)((v[j] - u[i * wide + j]) * (v[j] - u[i * wide + j]));
            error[k][i] = s / (3.0 * r->size * r->size);
        }
    }
    for (i = 0; i < PART; ++i) {
        double least = 1e300;
        for (k = 0; k < t->nets; ++k) {
            least = fmin(least, error[k][i]);
            t->one[part] += 255 * sqrt(error[k][i]) / t->nets;
        }
        t->best[part] += 255 * sqrt(least);
    }
    if (t->only_measure) return;
    for (k = 0; k < t->nets; ++k) {
        memset(t->grad[part][k], 0, t->net[k].count * sizeof(float));
        for (i = 0; i < PART; ++i) {
            const float *v = t->ract[part][k][last] + i * wide;
            float *g = t->g[part] + i * wide, by;
            int is_best = 1;
            for (j = 0; j < t->nets; ++j)
                is_best = is_best && (error[k][i] < error[j][i] || (error[k][i] <= error[j][i] && k <= j));
            by = (t->share + (is_best ? 1 : 0)) /
                ((float)sqrt(error[k][i] + 2e-5) * 3 * (float)(r->size * r->size) * (float)t->batch);
            for (j = 0; j < wide; ++j) g[j] = (v[j] - u[i * wide + j]) * by;
        }
        train_backward(&r->net, t->work[part], PART * r->f.lists, t->rows[part], t->ract[part][k], t->g[part],
                       t->spare[part], NULL, t->gx[part]);
        memset(t->g[part], 0, (size_t)(PART * d) * sizeof(float));
        for (i = 0; i < PART * r->f.lists; ++i)
            for (j = 0; j < r->f.inputs; ++j)
                t->g[part][i / r->f.lists * d + r->f.list[i % r->f.lists][j]] += t->gx[part][i * r->f.inputs + j];
        train_backward(&t->net[k], t->work[part], PART, scaled, t->act[part][k], t->g[part], t->spare[part],
                       t->grad[part][k], NULL);
    }
}

static void invert_update(void *context, int k)
{
    inverting *t = (inverting *)context;
    size_t i;
    int part;
    for (part = 1; part < t->parts; ++part)
        for (i = 0; i < t->net[k].count; ++i) t->grad[0][k][i] += t->grad[part][k][i];
    train_adam_count(&t->adam[k], 0.9f);
    train_adam_step(&t->adam[k], t->rate, 0.9f, t->net[k].p, t->grad[0][k], 0, t->net[k].count);
}

/* The network on planes [3][size][size]: its first layer takes the pixels through the basis. */
static const char *inversion_save(const char *path, const inverting *t, int k)
{
    const frozen *r = t->r;
    const train_net *net = &t->net[k];
    int first = net->size[1], wide = r->f.lists * r->rank, i, j, c;
    size_t outputs = 3 * (size_t)r->size * (size_t)r->size;
    float *w = (float *)room((size_t)first * outputs, sizeof(float)), *b = (float *)room((size_t)first, sizeof(float));
    train_work *work = (train_work *)room(1, sizeof *work);
    image__bytes bytes;
    saved file;
    char input[64], name[16];
    const char *problem = NULL;
    memset(&file, 0, sizeof file);
    strcpy(file.layers, "{\"type\":\"flatten\"}");
    for (i = 0; i < first; ++i) {
        float a[2048];
        b[i] = train_bias(net, 0)[i];
        for (c = 0; c < r->f.lists; ++c) {
            for (j = 0; j < r->rank; ++j) {
                a[j] = train_weight(net, 0)[i * wide + c * r->rank + j] * t->scale;
                b[i] -= a[j] * r->mean_u[j];
            }
            train_product(work, 1, (int)r->pixels, r->rank, train_rows(a, 0), train_transposed(r->q, (size_t)r->rank),
                          w + (size_t)i * outputs + (size_t)c * r->pixels, outputs, 0);
        }
    }
    saved_dense(&file, "picture", "elu", MS_NN_I8, (size_t)first, outputs, w, b);
    for (i = 1; i < net->layers; ++i) {
        snprintf(name, sizeof name, "hidden%d", i);
        saved_dense(&file, i + 1 < net->layers ? name : "parameters", i + 1 < net->layers ? "elu" : "sigmoid",
                    i + 1 < net->layers ? MS_NN_I8 : MS_NN_F16, (size_t)net->size[i + 1], (size_t)net->size[i],
                    train_weight(net, i), train_bias(net, i));
    }
    snprintf(input, sizeof input, "[3,%d,%d]", r->size, r->size);
    if (!saved_write(&file, input, NULL, 0, &bytes)) problem = trouble;
    else problem = file_save(path, bytes.data, bytes.size);
    return problem;
}

static int train_inversion(train_pool *pool, const char *path, const char *prefix, const options *o)
{
    frozen r;
    inverting t;
    int sizes[5], k, l, part, step, wide, most, steps = o->epochs ? o->epochs : 6000;
    uint64_t seed = (uint64_t)o->seed;
    double start = now(), said = start, sum = 0;
    if (!frozen_load(path, o->sharp, &r)) return 0;
    memset(&t, 0, sizeof t);
    wide = r.f.lists * r.rank;
    if (wide > 2048) return wrong("%s: %d features; 2048 are possible", path, wide);
    t.r = &r;
    t.nets = o->count;
    t.batch = 128;
    t.parts = t.batch / PART;
    t.share = 0.1f;
    sizes[0] = wide;
    sizes[1] = o->first;
    sizes[2] = sizes[3] = o->width;
    sizes[4] = r.parameters;
    for (k = 0; k < t.nets; ++k) {
        if (!train_net_make(&t.net[k], sizes, 5, 1, &seed)) return wrong("out of memory");
        t.adam[k].m = (float *)zeros(t.net[k].count, sizeof(float));
        t.adam[k].v = (float *)zeros(t.net[k].count, sizeof(float));
        t.adam[k].power1 = t.adam[k].power2 = 1;
    }
    most = widest(&r.net) * r.f.lists;
    most = widest(&t.net[0]) > most ? widest(&t.net[0]) : most;
    for (part = 0; part < t.parts; ++part) {
        size_t n = PART;
        t.work[part] = (train_work *)room(1, sizeof(train_work));
        t.u[part] = (float *)room(n * (size_t)wide, sizeof(float));
        t.guess[part] = (float *)room(n * (size_t)wide, sizeof(float));
        t.x[part] = (float *)room(n * (size_t)r.parameters, sizeof(float));
        t.rows[part] = (float *)room(n * (size_t)(r.f.lists * r.f.inputs), sizeof(float));
        t.gx[part] = (float *)room(n * (size_t)(r.f.lists * r.f.inputs), sizeof(float));
        t.g[part] = (float *)room(n * (size_t)most, sizeof(float));
        t.spare[part] = (float *)room(n * (size_t)most, sizeof(float));
        for (k = 0; k < t.nets; ++k) {
            for (l = 0; l < r.net.layers; ++l)
                t.ract[part][k][l] = (float *)room(n * (size_t)(r.f.lists * r.net.size[l + 1]), 2 * sizeof(float));
            for (l = 0; l < 4; ++l) t.act[part][k][l] = (float *)room(n * (size_t)sizes[l + 1], 2 * sizeof(float));
            t.grad[part][k] = (float *)room(t.net[k].count, sizeof(float));
        }
    }
    draw(&r, PART, t.x[0], &seed);
    frozen_run(&r, t.work[0], PART, t.x[0], t.rows[0], t.ract[0][0], t.u[0]);
    for (k = 0; k < PART * wide; ++k) sum += (double)(t.u[0][k] * t.u[0][k]);
    t.scale = (float)(1 / sqrt(sum / (PART * wide) + 1e-20));
    printf("%d networks for %s: %d parameters, pictures of %d x %d, %d features\n", t.nets, path, r.parameters, r.size,
           r.size, wide);
    for (step = 0; step < steps; ++step) {
        double at, left;
        t.seed = (uint64_t)o->seed * 1000003u + (uint64_t)step + 1;
        t.rate = (float)(o->rate * fmin(1, (step + 1) / 200.0) * (0.5 + 0.5 * cos(3.141592653589793 * step / steps)) +
                         1e-7);
        train_run(pool, t.parts, invert_part, &t);
        train_run(pool, t.nets, invert_update, &t);
        at = now();
        left = (at - start) / (step + 1) * (steps - step - 1);
        if (at - said < 10 && step + 1 < steps) continue;
        said = at;
        { /* other materials, as the renderer draws them */
            double best = 0, one = 0;
            int round, n = 0;
            t.only_measure = 1;
            for (round = 0; round < 4; ++round) {
                t.seed = 0x7000000u + (uint64_t)round;
                train_run(pool, t.parts, invert_part, &t);
                for (part = 0; part < t.parts; ++part, n += PART) best += t.best[part], one += t.one[part];
            }
            t.only_measure = 0;
            printf("step %d of %d: RMSE of 255: best of %d %.2f, one %.2f; %.0f s, %.0f s left\n", step + 1, steps,
                   t.nets, best / n, one / n, at - start, left);
            fflush(stdout);
        }
    }
    for (k = 0; k < t.nets; ++k) {
        char name[1000];
        const char *problem;
        snprintf(name, sizeof name, "%.970s%d.safetensors", prefix, k + 1);
        problem = inversion_save(name, &t, k);
        if (problem) return wrong("%s: %s", name, problem);
        printf("%s\n", name);
    }
    for (k = 0; k < t.nets; ++k) free(t.net[k].p);
    free(r.net.p);
    return 1;
}

/* --- a larger picture for a renderer that is there ---------------------------------------------------------------- */

/* The trunk of --trunk, its features turned to the axes on which the pictures of this set vary, and a pixels' layer of
   their full size. */
static int train_larger(train_pool *pool, const char *pictures, const char *csv, const char *path, options *o)
{
    static const char *const part[] = {".bin", NULL};
    material_set s, check[2];
    frozen r;
    trainer t;
    train_components c;
    image__bytes bytes;
    table names;
    char **name, *changing = NULL;
    int count, i, j, k, rows, full, rank, hidden, last;
    double start = now(), *covariance, *vector, *value, all = 0, left = 0;
    float *mean, *x, *u, *act[TRAIN_LAYERS], *to, *m;
    train_work *work = (train_work *)room(1, sizeof *work);
    memset(&s, 0, sizeof s);
    memset(&t, 0, sizeof t);
    memset(&c, 0, sizeof c);
    if (!frozen_load(o->trunk, NULL, &r)) return 0;
    count = list_folder(pictures, part, &name);
    if (count < 1) return wrong("%s: --trunk needs a folder of `make dataset`: linear light", pictures);
    if (!read_parts(pool, pictures, name, count, o->size, 1, &s)) return 0;
    if (s.parameters != r.parameters)
        return wrong("%s: %d parameters, %s has %d", pictures, s.parameters, o->trunk, r.parameters);
    memset(&names, 0, sizeof names);
    if (strcmp(csv, "-") != 0 && !table_read(csv, &names)) return 0;
    if (names.names == NULL) { /* the trunk's */
        ms_nn_file *file = NULL;
        const char *theirs = ms_nn_file_read(o->trunk, NULL, &file, NULL) == MS_OK
            ? ms_nn_file_metadata(file, "ms_parameters")
            : NULL;
        if (theirs) strcpy(names.names = (char *)room(strlen(theirs) + 1, 1), theirs);
        ms_nn_file_close(file);
    }
    s.names = names.names ? names.names : names_like(s.parameters);
    names.names = NULL;
    s.low = (double *)zeros((size_t)s.parameters, sizeof(double));
    s.high = (double *)zeros((size_t)s.parameters, sizeof(double));
    for (j = 0; j < s.parameters; ++j) s.high[j] = 1;
    rows = s.count * r.f.lists;
    full = r.rank;
    last = r.net.layers - 1;
    hidden = r.net.size[last];
    x = (float *)room((size_t)rows * (size_t)r.f.inputs, sizeof(float));
    u = (float *)room((size_t)rows * (size_t)full, sizeof(float));
    inputs_of(&r.f, &s, x);
    for (k = 0; k < r.net.layers; ++k)
        act[k] = (float *)room((size_t)CHUNK * (size_t)r.net.size[k + 1], 2 * sizeof(float));
    for (i = 0; i < rows; i += CHUNK) {
        int n = rows - i < CHUNK ? rows - i : (int)CHUNK;
        train_forward(&r.net, work, n, x + (size_t)i * (size_t)r.f.inputs, act);
        memcpy(u + (size_t)i * (size_t)full, act[last], (size_t)(n * full) * sizeof(float));
    }
    printf("%d pictures of %d x %d for the trunk of %s: %d features\n", s.count, s.size, s.size, o->trunk, full);

    /* features about their mean, on the axes of their covariance */
    m = (float *)zeros((size_t)full, sizeof(float));
    covariance = (double *)zeros((size_t)(full * full), sizeof(double));
    vector = (double *)zeros((size_t)(full * full), sizeof(double));
    value = (double *)zeros((size_t)full, sizeof(double));
    for (j = 0; j < full; ++j) {
        double sum = 0;
        for (i = 0; i < rows; ++i) sum += (double)u[i * full + j];
        m[j] = (float)(sum / rows);
    }
    for (i = 0; i < rows; ++i)
        for (j = 0; j < full; ++j) u[i * full + j] -= m[j];
    train__gram(u, 0, (size_t)rows, full, covariance, work);
    for (j = 0; j < full * full; ++j) covariance[j] /= rows;
    train_eigen(full, covariance, vector, value);
    rank = o->rank;
    if (o->bytes > 0) {
        double trunk = 0;
        for (k = 0; k < last; ++k) trunk += (r.net.size[k] + 2) * r.net.size[k + 1];
        rank = rank_of(o->bytes, trunk, hidden + 2, 3.0 * s.size * s.size / r.f.lists);
    }
    rank = rank < full ? rank : full;
    if (rank < 1) return wrong("--bytes %.0f is too few", o->bytes);
    c.rank = c.known = rank;
    c.variance = (double *)room((size_t)rank, sizeof(double));
    for (j = 0; j < full; ++j) all += value[j], left += j < rank ? 0 : value[j];
    for (j = 0; j < rank; ++j) c.variance[j] = value[j];
    c.coordinate = (float *)room((size_t)rows * (size_t)rank, sizeof(float));
    for (i = 0; i < rows; ++i)
        for (j = 0; j < rank; ++j) {
            double sum = 0;
            for (k = 0; k < full; ++k) sum += (double)u[i * full + k] * vector[k * full + j];
            c.coordinate[(size_t)i * (size_t)rank + (size_t)j] = (float)sum;
        }
    t.net = r.net; /* borrowed, but for the last layer */
    t.net.p = (float *)room(r.net.count, sizeof(float));
    memcpy(t.net.p, r.net.p, r.net.at[last] * sizeof(float));
    t.net.size[last + 1] = rank;
    t.rank = rank;
    t.scale = 1;
    to = train_weight(&t.net, last);
    for (j = 0; j < rank; ++j)
        for (i = 0; i <= hidden; ++i) {
            double sum = 0;
            for (k = 0; k < full; ++k)
                sum += vector[k * full + j] *
                    (double)(i < hidden ? train_weight(&r.net, last)[k * hidden + i]
                                        : train_bias(&r.net, last)[k] - m[k]);
            if (i < hidden) to[j * hidden + i] = (float)sum;
            else train_bias(&t.net, last)[j] = (float)sum;
        }
    printf("rank %d of %d, without %.4f%% of the features' variance; %.0f s so far\n", rank, full, 100 * left / all,
           now() - start);
    fflush(stdout);
    mean = NULL;
    larger_basis(pool, &s, r.f.lists, rank, &c, &mean);
    printf("pixels: %.0f s so far\n", now() - start);
    fflush(stdout);
    if (!renderer_file(&t, &r.f, &c, mean, &s, &bytes) || !read_checks(pool, o, csv, s.size, &s, check)) return 0;
    if (check[0].count) changing = changing_pixels(&check[0], check[1].count ? &check[1] : NULL);
    free(r.net.p);
    return measure_and_save(path, &bytes, check, NULL, changing, start);
}

/* A network that is there against pictures. */
static int measure_renderer(train_pool *pool, const char *path, const char *csv, const options *o)
{
    material_set check[2];
    ms_nn *nn;
    ms_error error;
    int size = 0, fine;
    if (ms_nn_load_file(path, NULL, &nn, &error) != MS_OK) return wrong("%s: %s", path, error.message);
    while (3 * (size_t)size * (size_t)size < ms_nn_output_size(nn)) ++size;
    fine = read_checks(pool, o, csv, size, NULL, check);
    if (fine &&
        (check[0].parameters != (int)ms_nn_input_size(nn) || 3 * (size_t)size * (size_t)size != ms_nn_output_size(nn)))
        fine = wrong("%s: other parameters or no square pictures", path);
    if (fine)
        fine = report_all(path, nn, &check[0], check[1].count ? &check[1] : NULL,
                          changing_pixels(&check[0], check[1].count ? &check[1] : NULL));
    ms_nn_destroy(nn);
    return fine;
}

/* --- the command line --------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    double low, high;   /* of a number */
    char type;          /* i: int, d: double, t: text */
    size_t at;          /* in options */
    const char *choice; /* of a text, or NULL */
} option_list[] = {{"--size", 1, 4096, 'i', offsetof(options, size), NULL},
                   {"--trunk", 0, 0, 't', offsetof(options, trunk), NULL},
                   {"--sharp", 0, 0, 't', offsetof(options, sharp), NULL},
                   {"--channels", 0, 0, 't', offsetof(options, channels), "auto none"},
                   {"--hidden", 0, 0, 't', offsetof(options, hidden), "auto none"},
                   {"--held-out", 1, 1e6, 'i', offsetof(options, held_out), NULL},
                   {"--bytes", 1e4, 1e10, 'd', offsetof(options, bytes), NULL},
                   {"--rank", 1, 900, 'i', offsetof(options, rank), NULL},
                   {"--width", 4, 4096, 'i', offsetof(options, width), NULL},
                   {"--depth", 1, TRAIN_LAYERS - 1, 'i', offsetof(options, depth), NULL},
                   {"--epochs", 1, 1e6, 'i', offsetof(options, epochs), NULL},
                   {"--steps", 1, 1e6, 'i', offsetof(options, epochs), NULL},
                   {"--rate", 1e-6, 1, 'd', offsetof(options, rate), NULL},
                   {"--seed", 0, 1e15, 'd', offsetof(options, seed), NULL},
                   {"--threads", 1, 64, 'i', offsetof(options, threads), NULL},
                   {"--count", 1, 16, 'i', offsetof(options, count), NULL},
                   {"--first", 2, 1024, 'i', offsetof(options, first), NULL}};

static int parse_option(const char *name, const char *text, options *o)
{
    char *end, *at;
    double v;
    size_t k = 0, count = sizeof option_list / sizeof option_list[0];
    while (k < count && strcmp(option_list[k].name, name) != 0) ++k;
    if (k == count || text == NULL) return wrong("'%s' is no option, or lacks its value", name);
    at = (char *)o + option_list[k].at;
    if (option_list[k].type == 't') {
        const char *choice = option_list[k].choice, *found = choice ? strstr(choice, text) : text;
        if (found == NULL || (choice && strlen(text) != 4)) return wrong("'%s' is no option, or lacks its value", name);
        memcpy(at, &text, sizeof text);
        return 1;
    }
    v = strtod(text, &end);
    if (end != text && (*end == 'M' || *end == 'k') && strcmp(name, "--bytes") == 0) v *= *end++ == 'M' ? 1e6 : 1e3;
    if (end == text || *end != 0 || !(v >= option_list[k].low && v <= option_list[k].high))
        return wrong("%s: '%s' is no number from %g to %g", name, text, option_list[k].low, option_list[k].high);
    if (option_list[k].type == 'd') memcpy(at, &v, sizeof v);
    else *(int *)(void *)at = (int)v;
    return 1;
}

static int parse(int argc, char **argv, options *o, const char **plain, int *inversion)
{
    int i, plains = 0, checks = 0;
    for (i = 1; i < argc; ++i) {
        const char *a = argv[i], *next = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(a, "--inversion") == 0) *inversion = 1;
        else if (strcmp(a, "--measure") == 0) *inversion = 2;
        else if (strcmp(a, "--check") == 0 && checks < 2 && next) o->check[checks++] = argv[++i];
        else if (a[0] == '-' && a[1] == '-') {
            if (!parse_option(a, next, o)) return 0;
            ++i;
        } else {
            if (plains == 3) return wrong("'%s': one argument too many", a);
            plain[plains++] = a;
        }
    }
    if (plains != (*inversion ? 2 : 3))
        return wrong("%s expected",
                     *inversion == 2  ? "RENDERER.safetensors, PARAMS.csv or -, --check A"
                         : *inversion ? "RENDERER.safetensors OUT_PREFIX"
                                      : "PICTURES PARAMS.csv OUT.safetensors");
    if (*inversion == 2 && checks == 0) return wrong("--measure needs --check");
    return 1;
}

int main(int argc, char **argv)
{
    options o;
    const char *plain[3] = {NULL, NULL, NULL};
    int inversion = 0, fine;
    train_pool pool;
    memset(&o, 0, sizeof o);
    o.rank = 96;
    o.width = 0;
    o.depth = 3;
    o.threads = 2;
    o.count = 5;
    o.first = 64;
    o.rate = 0;
    o.seed = 1;
    o.channels = o.hidden = "auto";
    if (file_help(argc, argv, usage_text)) return file_end_stdout("train");
    if (!parse(argc, argv, &o, plain, &inversion)) {
        fprintf(stderr, "train: %s\n", trouble);
        return file_usage(usage_text);
    }
    if (o.width == 0) o.width = inversion ? 256 : 384;
    if (o.rate <= 0) o.rate = inversion ? 1e-3 : 4e-3;
    train_pool_start(&pool, o.threads);
    if (inversion)
        fine = inversion == 2 ? measure_renderer(&pool, plain[0], plain[1], &o)
                              : train_inversion(&pool, plain[0], plain[1], &o);
    else {
        fine = o.trunk || train_renderer(&pool, plain[0], plain[1], plain[2], &o);
        if (fine && (o.trunk || is_data_set(plain[0]))) {
            drop_all(&whole);
            if (o.trunk == NULL) o.trunk = plain[2], o.bytes = 0; /* rank and type are chosen */
            fine = train_larger(&pool, plain[0], plain[1], plain[2], &o);
        }
    }
    train_pool_stop(&pool);
    if (!fine) fprintf(stderr, "train: %s\n", trouble);
    return fine ? file_end_stdout("train") : 1;
}
