/* Writes examples/data/truth_bust.bin and truth_knot.bin: what a filter starts from and what a random walk shows, for
   examples/demo/demo_sss.c. Each: a line "ms_truth width height fov_degrees mm_per_unit", then width x height floats of
   depth (0 beside the object), three binary16 of irradiance over pi a pixel, three of the walk's radiance;
   little-endian; and the walk's flat profiles, truth_skin1.csv and truth_marble.csv, as ring averages at ring middles.
   Run by truth_data.sh. */
#define MS_SSS_IMPLEMENTATION
#include "ms_sss.h"
#include "render/truth.h"

static int save(scene_object object, truth_substance substance, int walks, const char *path)
{
    const int width = 320, height = 180;
    const char *problem;
    uint16_t half[6];
    truth t;
    FILE *f;
    int i, c, ok = 1;
    if (!truth_make(&t, object, substance, width, height, walks, 1, NULL, &problem)) {
        fprintf(stderr, "%s\n", problem);
        return 0;
    }
    f = fopen(path, "wb");
    if (f == NULL) return 0;
    fprintf(f, "ms_truth %d %d %.6f %.6f\n", width, height,
            2 * atan((double)t.camera.tan_half_fov) * (180 / 3.14159265358979), (double)t.mm_per_unit);
    ok = fwrite(t.layers.depth.pixels, sizeof(float), (size_t)(width * height), f) == (size_t)(width * height);
    for (i = 0; i < width * height && ok; ++i) {
        for (c = 0; c < 3; ++c) {
            half[c] = ms__half_from_float(t.lit->irradiance.pixels[3 * i + c]);
            half[3 + c] = ms__half_from_float(0.5f *
                                              (t.lit->half[0].pixels[3 * i + c] + t.lit->half[1].pixels[3 * i + c]));
        }
        ok = fwrite(half, sizeof half, 1, f) == 1;
    }
    truth_free(&t);
    return (fclose(f) == 0) & ok;
}

/* Middles of the rings of truth_profile, from which ms_sss_profile_from_csv finds their edges. */
static int save_profile(truth_substance substance, const char *path)
{
    float mu_s[3], mu_a[3], unit;
    ms_sss_profile *profile;
    double inner[3], outer[3], from = 0, to;
    FILE *f = fopen(path, "w");
    int i, c;
    truth_material(SCENE_BUST, substance, mu_s, mu_a, &unit);
    if (f == NULL || truth_profile(mu_s, mu_a, 1 << 20, &profile) != MS_OK) return 0;
    fprintf(
        f,
        "# %s, index-matched, light that enters with a cosine distribution: 2^20 random walks a channel\nr_mm,R,G,B\n",
        substance == TRUTH_SKIN ? "skin1" : "marble");
    for (i = 1; i <= TRUTH_RINGS; ++i, from = to) {
        to = 0.01 * pow(1e4, (i - 1) / (TRUTH_RINGS - 1.0));
        ms_sss_profile_disc(profile, from, inner);
        ms_sss_profile_disc(profile, to, outer);
        fprintf(f, "%.12g", 0.5 * (from + to));
        for (c = 0; c < 3; ++c)
            fprintf(f, ",%.6g", (outer[c] - inner[c]) / (3.14159265358979 * (to * to - from * from)));
        fprintf(f, "\n");
    }
    ms_sss_profile_destroy(profile);
    return fclose(f) == 0;
}

int main(void)
{
    if (!save_profile(TRUTH_SKIN, "examples/data/truth_skin1.csv") ||
        !save_profile(TRUTH_MARBLE, "examples/data/truth_marble.csv"))
        return 1;
    return !(save(SCENE_BUST, TRUTH_SKIN, 640, "examples/data/truth_bust.bin") &
             save(SCENE_KNOT, TRUTH_MARBLE, 224, "examples/data/truth_knot.bin"));
}
