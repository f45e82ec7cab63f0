/* Subsurface scattering as a post-process of an engine: what happens once, at a new window size, and every frame.

     cc -O2 -I. examples/engine/postprocess.c -o build/postprocess -lm
     build/postprocess [OUT.png] [--method taps|pyramid]

   The "engine" shades a ball in front of a wall into one buffer of four floats a pixel, diffuse light and depth. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "../tools/image.h"

static const char usage[] = "usage: postprocess [OUT.png] [--method taps|pyramid]\n"
                            "  taps (7 a pass) suit radii up to some 10 pixels; the pyramid any, at more cost\n";

enum { WIDTH = 640, HEIGHT = 360 };

/* The engine's part: light that arrives through a blind, and the distance along the view axis in cm. */
static void render(float *rgbz)
{
    const float focal = (float)HEIGHT / (2 * 0.3153f); /* tan of half the 35 degrees below */
    int x, y, c;
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x, rgbz += 4) {
            const float u = ((float)(x - WIDTH / 2)) / focal, v = ((float)(HEIGHT / 2 - y)) / focal;
            const float a = u * u + v * v + 1, in_ball = 1600 - a * (1600 - 81); /* the ball: 9 cm, 40 cm away */
            const float z = in_ball > 0 ? (40 - sqrtf(in_ball)) / a : 55;
            const float slat = sinf(1.3f * (v * z + 0.3f * z)), facing = in_ball > 0 ? (40 - z) / 9 : 0.6f;
            for (c = 0; c < 3; ++c) rgbz[c] = slat > 0 && facing > 0 ? facing : 0.02f;
            rgbz[3] = z;
        }
    }
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"taps", "pyramid"};
    const char *path = "build/postprocess.png", *problem;
    const double reflectance[3] = {0.44, 0.22, 0.13}, d_mm[3] = {1.2, 0.55, 0.35};
    static ms_sss_kernel kernel;
    static ms_sss_pyramid pyramid;
    ms_sss_filter_options options = ms_sss_filter_defaults();
    ms_sss_profile *profile;
    ms_sss_frame frame;
    ms_error error;
    float *rgbz = (float *)malloc(sizeof(float) * WIDTH * HEIGHT * 4);
    image picture = image_new(WIDTH, HEIGHT, 3);
    size_t size;
    void *workspace;
    int i, number, ok, method = 1;

    if (file_help(argc, argv, usage)) return file_end_stdout("postprocess");
    for (i = 1; i < argc; ++i) {
        if (argv[i][0] != '-' && i == 1) {
            path = argv[i];
            continue;
        }
        for (method = 0; i + 1 < argc && method < 2 && strcmp(argv[i + 1], names[method]) != 0;) ++method;
        if (strcmp(argv[i], "--method") != 0 || i + 1 >= argc || method == 2) return file_usage(usage);
        ++i;
    }
    /* Once: the material's kernel, 7 taps, and its pyramid. An asset tool would store them. */
    ok = rgbz && picture.pixels && ms_sss_profile_from_burley(&profile, reflectance, d_mm, NULL, &error) == MS_OK;
    if (!ok) return 1;
    ok = ms_sss_kernel_make(&kernel, NULL, profile, 24, NULL, NULL, &error) == MS_OK &&
        ms_sss_pyramid_make(&pyramid, profile, &error) == MS_OK;
    ms_sss_profile_destroy(profile);

    /* At a new window size: camera, views of the engine's buffers, workspace. options.parallel takes the thread
       pool. */
    options.fov_degrees = 35;
    options.mm_per_unit = 10; /* the scene is in cm */
    memset(&frame, 0, sizeof frame);
    frame.width = WIDTH;
    frame.height = HEIGHT;
    frame.input = frame.output = ms_sss_interleaved(rgbz, 4); /* in place */
    frame.depth = ms_sss_map(rgbz + 3, 4);
    size = method ? ms_sss_pyramid_workspace(WIDTH, HEIGHT)
                  : ms_sss_filter_workspace(WIDTH, HEIGHT, &kernel, 1, &options);
    workspace = malloc(size);

    /* Every frame: no allocation. */
    for (number = 0; ok && number < 3; ++number) {
        render(rgbz);
        if (!workspace) ok = 0;
        else if (method) ok = ms_sss_pyramid_filter(&frame, &pyramid, 1, &options, workspace, size, &error) == MS_OK;
        else ok = ms_sss_filter(&frame, &kernel, 1, &options, workspace, size, &error) == MS_OK;
    }
    if (!ok) {
        fprintf(stderr, "postprocess: %s\n", workspace ? error.message : "out of memory");
        return 1;
    }
    for (i = 0; i < WIDTH * HEIGHT * 3; ++i) picture.pixels[i] = rgbz[i / 3 * 4 + i % 3];
    image_to_srgb(&picture);
    problem = image_write(path, &picture);
    if (problem) fprintf(stderr, "postprocess: %s: %s\n", path, problem);
    else puts(names[method]);
    image_free(&picture);
    free(workspace);
    free(rgbz);
    return problem != NULL;
}
