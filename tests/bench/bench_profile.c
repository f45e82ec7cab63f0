/* Diffusion profiles: time against error for each way to one, on skin1, ketchup and cream, on the dissertation's rings
   (build/bench/profile.csv, .svg, .md), and the two knobs of the half-space solver over all 33 channels (halfspace.csv,
   .md). Errors are against the solver at its finest knobs, which the tests compare with tables. */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include "bench.h"
#include "photon_profile.h"
#include "plot.h"

#define PI 3.14159265358979324

/* --- Monte Carlo as MCML 1.2 does it: one photon at a time, weights, roulette below 1e-4, libm in the loop --- */

static uint64_t plain_state[4];

static double plain_random(void) /* xoshiro256+ (Blackman & Vigna) in place of ran3, which is biased */
{
    uint64_t *s = plain_state, result = s[0] + s[3], t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = (s[3] << 45) | (s[3] >> 19);
    return ((double)(result >> 12) + 0.5) / 4503599627370496.0;
}

static double plain_reflect(double eta, double cos_in)
{
    double square = 1 - eta * eta * (1 - cos_in * cos_in), out, s, p;
    if (square <= 0) return 1;
    out = sqrt(square);
    s = (eta * cos_in - out) / (eta * cos_in + out);
    p = (eta * out - cos_in) / (eta * out + cos_in);
    return 0.5 * (s * s + p * p);
}

static void plain_monte_carlo(const ms_mcml_medium *m, double photons, double ring_mm, int rings, double *rd)
{
    double mu_t = m->mu_a_per_mm + m->mu_s_per_mm, albedo = m->mu_s_per_mm / mu_t, n,
           entering = (m->eta - 1) / (m->eta + 1);
    int i;
    for (i = 0; i < 4; ++i) plain_state[i] = 0x9E3779B97F4A7C15u * (uint64_t)(i + 1);
    for (i = 0; i < rings; ++i) rd[i] = 0;
    for (n = 0; n < photons; ++n) {
        double x = 0, y = 0, z = 0, ux = 0, uy = 0, uz = 1, weight = 1 - entering * entering;
        while (weight > 0) {
            double s = -log(plain_random()) / mu_t;
            while (uz < 0 && s > -z / uz) {
                double t = -z / uz;
                x += t * ux;
                y += t * uy;
                z = 0;
                s -= t;
                if (plain_random() > plain_reflect(m->eta, -uz)) {
                    int ring = (int)(sqrt(x * x + y * y) / ring_mm);
                    if (ring < rings) rd[ring] += weight;
                    weight = 0;
                    break;
                }
                uz = -uz;
            }
            if (weight <= 0) break;
            x += s * ux;
            y += s * uy;
            z += s * uz;
            weight *= albedo;
            {
                double cosine = 2 * plain_random() - 1, sine = sqrt(1 - cosine * cosine), psi = 2 * PI * plain_random();
                ux = sine * cos(psi);
                uy = sine * sin(psi);
                uz = cosine;
            }
            if (weight < 1e-4) weight = plain_random() < 0.1 ? 10 * weight : 0;
        }
    }
    for (i = 0; i < rings; ++i) rd[i] /= photons * PI * ring_mm * ring_mm * (2 * i + 1);
}

/* --- one material on the dissertation's rings --- */

typedef struct scene {
    const char *name;
    ms_mcml_medium medium[3];
    ms_mcml_profile_options rings; /* ring_mm and rings of section 5.9 */
    ms_mcml_profile exact;
} scene;

static void finest(ms_mcml_profile_options *o)
{
    o->depth_step = 0.28;
    o->frequency_step = 0.2;
}

static void make(ms_mcml_profile *p, const ms_mcml_medium *media, int channels, const ms_mcml_profile_options *o)
{
    ms_error error;
    if (ms_mcml_profile_make(p, media, channels, o, &error)) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
}

static void scene_make(scene *s, const char *name)
{
    ms_mcml_profile_options o;
    double shortest = 1e300, longest = 0;
    int c;
    memset(s, 0, sizeof *s);
    s->name = name;
    for (c = 0; c < 3; ++c) {
        double path;
        s->medium[c] = ms_mcml_material_medium(ms_mcml_find_material(name), c);
        path = 1 / (s->medium[c].mu_a_per_mm + s->medium[c].mu_s_per_mm);
        if (path < shortest) shortest = path;
        if (path > longest) longest = path;
    }
    s->rings.ring_mm = shortest / 20;
    s->rings.rings = (int)ceil(32 * longest / s->rings.ring_mm);
    o = s->rings;
    finest(&o);
    make(&s->exact, s->medium, 3, &o);
}

/* Relative L2 error over the plane, root mean square of the channels. */
static double scene_error(const scene *s, const double *rd)
{
    double mean = 0;
    int c, i, n = s->exact.rings;
    for (c = 0; c < 3; ++c) {
        double error = 0, norm = 0;
        for (i = 0; i < n; ++i) {
            double e = s->exact.rd_per_mm2[c * n + i], d = rd[c * n + i] - e, area = 2 * i + 1;
            error += area * d * d;
            norm += area * e * e;
        }
        mean += error / norm / 3;
    }
    return sqrt(mean);
}

enum { PLAIN, DIRECT, SOLVER, WAYS };
static const char *const way_name[] = {"original-style Monte Carlo", "direct Monte Carlo, SIMD", "half-space solver"};

typedef struct run {
    const scene *s;
    int way;
    double photons;
    ms_mcml_profile_options o;
    double *rd;
} run;

static void run_once(void *context)
{
    run *r = (run *)context;
    int n = r->s->exact.rings, c;
    if (r->way == PLAIN) {
        for (c = 0; c < 3; ++c) plain_monte_carlo(&r->s->medium[c], r->photons, r->o.ring_mm, n, r->rd + c * n);
    } else {
        ms_mcml_profile p;
        if (r->way == SOLVER) {
            make(&p, r->s->medium, 3, &r->o);
        } else {
            ms_mcml_options direct = ms_mcml_defaults();
            direct.photons = (uint64_t)r->photons;
            if (photon_profile(&p, r->s->medium, 3, r->o.rings, r->o.ring_mm, &direct, NULL)) exit(1);
        }
        memcpy(r->rd, p.rd_per_mm2, (size_t)(3 * n) * sizeof *r->rd);
        ms_mcml_profile_destroy(&p);
    }
}

/* --- the knobs over all channels --- */

static void bench_knobs(void)
{
    static const double knob[][2] = {{0.8, 0.8}, {0.6, 0.6}, {0.5, 0.4}, {0.4, 0.3}, {0.3, 0.25}, {0.28, 0.2}};
    ms_mcml_medium media[33];
    ms_mcml_profile exact;
    ms_mcml_profile_options o;
    FILE *csv = bench_open("halfspace.csv"), *md = bench_open("halfspace.md");
    double edge[400];
    int i, c, k, count;
    const ms_mcml_material *m = ms_mcml_materials(&count);
    for (i = 0; i < 33; ++i) media[i] = ms_mcml_material_medium(&m[i / 3], i % 3);
    memset(&o, 0, sizeof o);
    finest(&o);
    make(&exact, media, 33, &o);
    memcpy(edge, exact.edge_mm, (size_t)(exact.rings + 1) * sizeof *edge);
    fprintf(csv, "depth_step,frequency_step,seconds,total_error,ring_error\n");
    fprintf(
        md,
        "33 channels in one call, %d rings each, one core of %s, `make bench FILTER=profile`; errors against the finest knobs.\n\n"
        "| depth_step | frequency_step | time | largest error of a total | of a ring with 1e-5 of the energy |\n"
        "|---:|---:|---:|---:|---:|\n",
        exact.rings, bench_processor());
    for (k = 0; k < 6; ++k) {
        double t[9], total = 0, worst = 0, start;
        bench_time time;
        ms_mcml_profile p;
        o.depth_step = knob[k][0];
        o.frequency_step = knob[k][1];
        o.edge_mm = edge;
        o.rings = exact.rings;
        for (i = 0; i < 9; ++i) {
            start = bench_cpu();
            make(&p, media, 33, &o);
            t[i] = bench_cpu() - start;
            if (i < 8) ms_mcml_profile_destroy(&p);
        }
        time = bench_summary(t, 9);
        for (c = 0; c < 33; ++c) {
            if (fabs(p.total[c] - exact.total[c]) > total) total = fabs(p.total[c] - exact.total[c]);
            for (i = 0; i < p.rings; ++i) {
                double e = exact.rd_per_mm2[c * p.rings + i],
                       energy = e * PI * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]);
                if (energy > 1e-5 && fabs(p.rd_per_mm2[c * p.rings + i] / e - 1) > worst)
                    worst = fabs(p.rd_per_mm2[c * p.rings + i] / e - 1);
            }
        }
        fprintf(csv, "%g,%g,%.6f,%.3e,%.3e\n", knob[k][0], knob[k][1], time.median, total, worst);
        if (k < 5)
            fprintf(md,
                    k == 4 ? "| **%g** | **%g** | %.0f ms | %.0e | %.0e |\n" : "| %g | %g | %.0f ms | %.0e | %.0e |\n",
                    knob[k][0], knob[k][1], 1e3 * time.median, total, worst);
        else fprintf(md, "| %g | %g | %.0f ms | | |\n", knob[k][0], knob[k][1], 1e3 * time.median);
        printf("knobs %g %g: %.1f ms, total %.1e, rings %.1e\n", knob[k][0], knob[k][1], 1e3 * time.median, total,
               worst);
        ms_mcml_profile_destroy(&p);
    }
    ms_mcml_profile_destroy(&exact);
    fclose(csv);
    fclose(md);
}

int main(void)
{
    static const char *const material[] = {"skin1", "ketchup", "cream"};
    static const double plain_photons[] = {1e3, 1e4, 5e4}, photons[] = {3e4, 3e5, 3e6};
    static const double knob[][2] = {{0.8, 0.8}, {0.5, 0.4}, {0.3, 0.25}};
    static const char *const way_short[] = {"original-style", "direct", "solver"};
    static const char *const color[][3] = {
        {"#5f6b75", "#8b959d", "#b3bbc1"}, {"#1b6ca8", "#5a97c4", "#9cc2dd"}, {"#2e933c", "#6db377", "#a9d2af"}};
    static scene s[3];
    static double x[3 * WAYS][3], y[3 * WAYS][3];
    static char label[3 * WAYS][64];
    static plot p;
    FILE *csv = bench_open("profile.csv"), *md = bench_open("profile.md");
    int m, way, k;
    fprintf(csv, "material,way,setting,seconds,relative_l2_error\n");
    fprintf(
        md,
        "Three channels on the dissertation's rings (section 5.9), one core of %s, gcc -O2, `make bench FILTER=profile`; relative L2 "
        "error over the plane, root mean square of the channels.\n\n| material | way | setting | time | error |\n|---|---|---|---:|---:|\n",
        bench_processor());
    plot_begin(&p, "Diffusion profiles: time against error, three channels, one core", "seconds", "relative L2 error",
               PLOT_LOG_X | PLOT_LOG_Y);
    p.width = 1000;
    p.height = 560;
    for (m = 0; m < 3; ++m) {
        scene_make(&s[m], material[m]);
        for (way = 0; way < WAYS; ++way) {
            int row = way * 3 + m;
            snprintf(label[row], sizeof label[row], "%s: %s", way_short[way], material[m]);
            for (k = 0; k < 3; ++k) {
                char setting[64];
                run r;
                bench_time t;
                memset(&r, 0, sizeof r);
                r.s = &s[m];
                r.way = way;
                r.photons = way == PLAIN ? plain_photons[k] : photons[k];
                r.o = s[m].rings;
                if (way == SOLVER) {
                    r.o.depth_step = knob[k][0];
                    r.o.frequency_step = knob[k][1];
                    snprintf(setting, sizeof setting, k == 2 ? "default" : "steps %g, %g", knob[k][0], knob[k][1]);
                } else {
                    snprintf(setting, sizeof setting, "%.0e photons a channel", r.photons);
                }
                r.rd = (double *)malloc((size_t)(3 * s[m].exact.rings) * sizeof(double));
                if (r.rd == NULL) return 1;
                if (way == SOLVER) {
                    t = bench_run(run_once, &r, 9);
                } else {
                    double start = bench_cpu();
                    run_once(&r);
                    t.median = bench_cpu() - start;
                }
                x[row][k] = t.median;
                y[row][k] = scene_error(&s[m], r.rd);
                free(r.rd);
                fprintf(csv, "%s,%s,%s,%.6f,%.3e\n", material[m], way_name[way], setting, x[row][k], y[row][k]);
                fprintf(md, "| %s | %s | %s | %.3g s | %.1e |\n", material[m], way_name[way], setting, x[row][k],
                        y[row][k]);
                printf("%s, %s, %s: %.4g s, error %.2e\n", material[m], way_name[way], setting, x[row][k], y[row][k]);
                fflush(stdout);
            }
        }
        ms_mcml_profile_destroy(&s[m].exact);
    }
    for (k = 0; k < 3 * WAYS; ++k)
        plot_series_color(&p, label[k], x[k], y[k], 3, PLOT_LINE | PLOT_DOTS, color[k / 3][k % 3]);
    fclose(csv);
    fclose(md);
    if (!plot_write(&p, "build/bench/profile.svg")) return 1;
    bench_knobs();
    return 0;
}
