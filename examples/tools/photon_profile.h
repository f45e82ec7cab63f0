/* A diffusion profile by Monte Carlo, with standard errors. Include after ms_mcml.h, whose implementation may be in
   another file. */
#ifndef PHOTON_PROFILE_H
#define PHOTON_PROFILE_H
#include <stdlib.h>
#include <string.h>

/* Half-spaces of `channels` media under air, in rings of equal width from 0; release *profile with
   ms_mcml_profile_destroy. Fails as ms_mcml_simulate does; *profile is zeroed then. */
static ms_status photon_profile(ms_mcml_profile *profile, const ms_mcml_medium *media, int channels, int rings,
                                double ring_mm, const ms_mcml_options *options, ms_error *error)
{
    const size_t n = (size_t)rings, count = (size_t)channels;
    ms_mcml_profile p;
    ms_mcml_options o = *options;
    ms_mcml_grid grid;
    double *next;
    int c, i;
    memset(profile, 0, sizeof *profile);
    memset(&p, 0, sizeof p);
    p.channels = channels;
    p.rings = rings;
    p.memory_size = (n + 1 + count * (3 * n + 4)) * sizeof(double);
    next = (double *)malloc(p.memory_size);
    if (next == NULL) {
        if (error) {
            const ms_error none = {MS_OUT_OF_MEMORY, 0, "no memory for the rings"};
            *error = none;
        }
        return MS_OUT_OF_MEMORY;
    }
    p.memory = next;
    p.edge_mm = next, next += n + 1;
    p.within = next, next += count * (n + 1);
    p.rd_per_mm2 = next, next += count * n;
    p.rd_error_per_mm2 = next, next += count * n;
    p.entering = next, next += count;
    p.total = next, next += count;
    p.total_error = next;
    for (i = 0; i <= rings; ++i) p.edge_mm[i] = i * ring_mm;
    o.no_absorption = 1;
    grid.dr_cm = 0.1 * ring_mm;
    grid.dz_cm = grid.nz = grid.na = 1;
    grid.nr = rings + 1; /* the last collects what lies beyond */
    for (c = 0; c < channels; ++c) {
        const ms_mcml_layer layer = {media[c].eta, 10 * media[c].mu_a_per_mm, 10 * media[c].mu_s_per_mm, media[c].g,
                                     1e8};
        const ms_mcml_tissue tissue = {1, 1, 1, &layer};
        const size_t row = (size_t)c * n;
        double *within = p.within + row + c;
        ms_mcml_result result;
        const ms_status status = ms_mcml_simulate(&tissue, &grid, &o, &result, error);
        if (status) {
            ms_mcml_profile_destroy(&p);
            return status;
        }
        within[0] = 0;
        for (i = 0; i < rings; ++i) {
            const double area = 6.283185307179586 * (i + 0.5) * grid.dr_cm * grid.dr_cm;
            p.rd_per_mm2[row + (size_t)i] = 0.01 * result.rd_r[i];
            p.rd_error_per_mm2[row + (size_t)i] = 0.01 * result.rd_r_error[i];
            within[i + 1] = within[i] + result.rd_r[i] * area;
        }
        p.entering[c] = 1 - result.specular;
        p.total[c] = result.rd;
        p.total_error[c] = result.rd_error;
        ms_mcml_result_destroy(&result);
    }
    *profile = p;
    return MS_OK;
}

#endif /* PHOTON_PROFILE_H */
