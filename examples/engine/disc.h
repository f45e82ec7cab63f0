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
    for (i = 0; i <= samples / 2; ++i) { /* the pixel, then rings of two samples */
        const double part = i ? 2 : 1, before = i ? 2 * i - 1 : 0,
                     end = i < samples / 2 ? (before + part) / (samples + 1) : 1;
        ms_sss_profile_radius(profile, 0.998 * end, radius);
        ms_sss_profile_disc(profile, end < 1 ? radius[widest] : 1e9, outer);
        ms_sss_profile_radius(profile, 0.998 * (before + part / 2) / (samples + 1), radius);
        for (c = 0; c < 3; ++c) {
            kernel->weight[0][i][c] = (float)(total[c] > 0 ? (outer[c] - inner[c]) / total[c] / part : i == 0);
            inner[c] = outer[c];
        }
        kernel->offset_mm[i] = i ? (float)radius[widest] : 0;
    }
    return MS_OK;
}

#endif
