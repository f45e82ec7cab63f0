/* The kernel of ms_sss_disc.glsl: half of `samples` rings of two samples each and the pixel's own light. Rings hold
   equal parts of the energy of the channel that reaches farthest; a sample weighs half of what each channel has in its
   ring. */
#ifndef DISC_H
#define DISC_H

/* samples: even, below MS_SSS_TAPS_MAX. radius_px, options: as of ms_sss_kernel_make. */
static inline ms_status disc_kernel(ms_sss_kernel *kernel, const ms_sss_profile *profile, int samples, double radius_px,
                                    ms_error *error)
{
    const ms_status status = ms_sss_kernel_make(kernel, NULL, profile, radius_px, NULL, NULL, error);
    double radius[3], total[3], inner[3], outer[3];
    int widest = 0, i, c;
    if (status != MS_OK) return status;
    ms_sss_profile_radius(profile, 0.99, radius);
    for (c = 1; c < 3; ++c)
        if (radius[c] > radius[widest]) widest = c;
    kernel->tap_count = samples + 1;
    kernel->term_count = 1;
    ms_sss_profile_disc(profile, 1e9, total);
    for (c = 0; c < 3; ++c) { /* one pass has the profile's own K, not that of an axis */
        kernel->elevation_axis[c] = kernel->elevation[c];
        kernel->scale[0][c] = 1;
        kernel->delta[c] = 0;
        inner[c] = 0;
    }
    for (i = 0; i <= samples; i += i ? 2 : 1) { /* the pixel, then rings of samples i and i + 1 */
        const double part = i ? 2 : 1, end = i + part > samples ? 1 : (i + part) / (samples + 1);
        ms_sss_profile_radius(profile, 0.998 * end, radius);
        ms_sss_profile_disc(profile, end < 1 ? radius[widest] : 1e9, outer);
        ms_sss_profile_radius(profile, 0.998 * (i + part / 2) / (samples + 1), radius);
        for (c = 0; c < 3; ++c) {
            const float weight = (float)(total[c] > 0 ? (outer[c] - inner[c]) / total[c] / part : i == 0);
            kernel->weight[0][i][c] = weight;
            if (i) kernel->weight[0][i + 1][c] = weight;
            inner[c] = outer[c];
        }
        if (i) kernel->offset_mm[i] = (float)-radius[widest];
        if (i) kernel->offset_mm[i + 1] = (float)radius[widest];
    }
    kernel->offset_mm[0] = 0;
    return MS_OK;
}

#endif
