/* Skin of melanin and blood to layers, diffusion profiles and colors. Include after ms_mcml.h, whose implementation may
   be in another file, and layered.h.

     skin_parameters skin = skin_defaults();
     skin.melanin = 0.1;
     status = skin_profile(&profile, &skin, NULL, &error); */
#ifndef SKIN_H
#define SKIN_H
#include <math.h>
#include <stdio.h>
#include <string.h>

/* What skin is made of. Start from skin_defaults(); a zero is a zero. Laws, per cm at w nm: melanosomes 6.6e11
   w^-3.33 of eumelanin (Jacques 1998, "Skin optics") and 2.9e15 w^-4.75 of pheomelanin (Donner, Jensen 2006, "A
   spectral BSSRDF for shading human skin"); bloodless, pale skin 0.244 + 85.3 exp(-(w - 154) / 66.2) (Jacques 1998);
   reduced scattering 46 (w / 500)^-1.421 (mean of skin in Jacques 2013, "Optical properties of biological tissues");
   blood of 150 g/l hemoglobin (Prahl's table of Gratzer's and Kollias's data, omlc.org); fat scatters 1050 w^-0.68
   (Bashkatov et al. 2005) and absorbs as dermis with a tenth of the blood. Index 1.4. Three numbers fitted to people in
   NIST's reference data (Cooksey, Allen, Tsai 2017) follow their spectra to 0.01 from 500 to 700 nm. */
typedef struct skin_parameters {
    double melanin;      /* melanosomes in the epidermis, by volume: 0.01 very pale to 0.4 very dark */
    double eumelanin;    /* part of the melanin that is black-brown; the rest is red-yellow pheomelanin */
    double blood;        /* in the dermis, by volume: 0.002 to 0.07 */
    double oxygen;       /* saturation of the blood, 0 to 1 */
    double epidermis_mm; /* 0.001 to 1 */
    double dermis_mm;    /* above fat; 0: without end, two layers */
    double scattering;   /* times the law's, 0.1 to 10 */
    double g;            /* mean cosine of the layers, 0 to 0.95; skin_profile takes 0, reduced scattering */
} skin_parameters;

enum { SKIN_BANDS = 13 };

/* Hemoglobin with and without oxygen, molar extinction per cm, every 10 nm from 400 (Prahl's table). */
static const double skin_hemoglobin[31][2] = {
    {266232, 223296}, {466840, 303956}, {480360, 407560}, {246072, 528600}, {102580, 413280}, {62816, 103292},
    {44480, 23388.8}, {33209, 16156},   {26629, 14550},   {23684, 16684},   {20933, 20862},   {20035, 25774},
    {24202, 31590},   {39957, 39036},   {53236, 46592},   {43016, 53412},   {32613, 53788},   {44496, 45072},
    {50104, 37020},   {14401, 28324},   {3200, 14677},    {1506, 9443.6},   {942, 6509.6},    {610, 5148.8},
    {442, 4345.2},    {368, 3750.1},    {319.6, 3226.6},  {294, 2795.1},    {277.6, 2407.9},  {276, 2052},
    {290, 1794.3}};

/* CIE standard illuminant D65, every 10 nm from 400. */
static const double skin_daylight[31] = {82.75,  91.49,  93.43,  86.68,  104.86, 117.01, 117.81, 114.86,
                                         115.92, 108.81, 109.35, 107.80, 104.79, 107.69, 104.41, 104.05,
                                         100,    96.33,  95.79,  88.69,  90.01,  89.60,  87.70,  83.29,
                                         83.70,  80.03,  80.21,  82.28,  78.28,  69.72,  71.61};

static const double skin_bands[SKIN_BANDS] = {400, 425, 445, 465, 500, 535, 560, 578, 590, 603, 625, 655, 700};

/* The median of NIST's 100 people, inside of the forearm: melanin 0.016, all of it eumelanin, blood 0.037, oxygen 0.75,
   epidermis 0.06 mm, dermis without end, scattering 2.2; g 0: layers of reduced scattering. */
static skin_parameters skin_defaults(void)
{
    skin_parameters skin;
    skin.melanin = 0.016;
    skin.eumelanin = 1;
    skin.blood = 0.037;
    skin.oxygen = 0.75;
    skin.epidermis_mm = 0.06;
    skin.dermis_mm = 0;
    skin.scattering = 2.2;
    skin.g = 0;
    return skin;
}

/* Its layers for light of 400 to 700 nm: 2 or 3, *count. */
static ms_status skin_layers(const skin_parameters *skin, double w, ms_mcml_layer layers[3], int *count,
                             ms_error *error)
{
    static const char *const name[] = {"melanin",      "eumelanin", "blood",      "oxygen",
                                       "epidermis_mm", "dermis_mm", "scattering", "g"};
    static const double low[] = {0, 0, 0, 0, 1e-3, 0, 0.1, 0}, high[] = {1, 1, 1, 1, 1, 1e3, 10, 0.95};
    double value[8], base, melanin, blood, scatter;
    int i;
    memcpy(value, skin, sizeof value); /* the struct's eight numbers, in their order */
    for (i = 0; i < 8; ++i)
        if (!(value[i] >= low[i] && value[i] <= high[i])) {
            if (error == NULL) return MS_INVALID_ARGUMENT;
            error->status = MS_INVALID_ARGUMENT;
            error->position = 0;
            snprintf(error->message, sizeof error->message, "%s is %g, expected %g to %g", name[i], value[i], low[i],
                     high[i]);
            return MS_INVALID_ARGUMENT;
        }
    i = w < 700 ? (int)((w - 400) / 10) : 29;
    {
        const double *a = skin_hemoglobin[i], *b = skin_hemoglobin[i + 1], t = (w - 400) / 10 - i,
                     to_mu = 2.302585 * 150 / 64500;
        blood = to_mu * (skin->oxygen * (a[0] + t * (b[0] - a[0])) + (1 - skin->oxygen) * (a[1] + t * (b[1] - a[1])));
    }
    base = 0.244 + 85.3 * exp((154 - w) / 66.2);
    melanin = skin->eumelanin * 6.6e11 * pow(w, -3.33) + (1 - skin->eumelanin) * 2.9e15 * pow(w, -4.75);
    scatter = skin->scattering * 46 * pow(w / 500, -1.421) / (1 - skin->g);
    for (i = 0; i < 3; ++i) {
        layers[i].n = 1.4;
        layers[i].g = skin->g;
        layers[i].mu_s_per_cm = scatter;
    }
    layers[2].mu_s_per_cm = skin->scattering * 1050 * pow(w, -0.68) / (1 - skin->g);
    layers[0].mu_a_per_cm = skin->melanin * melanin + (1 - skin->melanin) * base;
    layers[1].mu_a_per_cm = skin->blood * blood + (1 - skin->blood) * base;
    layers[2].mu_a_per_cm = 0.1 * skin->blood * blood + (1 - 0.1 * skin->blood) * base;
    layers[0].thickness_cm = 0.1 * skin->epidermis_mm;
    layers[1].thickness_cm = skin->dermis_mm > 0 ? 0.1 * skin->dermis_mm : 1e8;
    layers[2].thickness_cm = 1e8;
    *count = skin->dermis_mm > 0 ? 3 : 2;
    return MS_OK;
}

/* exp(-((w - at) / width)^2 / 2), a width on either side */
static double skin_lobe(double w, double at, double below, double above)
{
    const double t = (w - at) / (w < at ? below : above);
    return exp(-0.5 * t * t);
}

/* What each band gives to linear sRGB under daylight: the bands' reflectances are joined by lines. A white sums to
   1. */
static void skin_band_weights(double weight[SKIN_BANDS][3])
{
    static const double rgb[3][3] = {
        {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}};
    double sum[3] = {0, 0, 0};
    int i, c, w, band = 0;
    memset(weight, 0, SKIN_BANDS * sizeof weight[0]);
    for (w = 400; w <= 700; w += 5) {
        const double light = w % 10 ? 0.5 * (skin_daylight[(w - 400) / 10] + skin_daylight[(w - 390) / 10])
                                    : skin_daylight[(w - 400) / 10];
        const double x = 1.056 * skin_lobe(w, 599.8, 37.9, 31.0) + 0.362 * skin_lobe(w, 442.0, 16.0, 26.7) -
            0.065 * skin_lobe(w, 501.1, 20.4, 26.2);
        const double y = 0.821 * skin_lobe(w, 568.8, 46.9, 40.5) + 0.286 * skin_lobe(w, 530.9, 16.3, 31.1);
        const double z = 1.217 * skin_lobe(w, 437.0, 11.8, 36.0) + 0.681 * skin_lobe(w, 459.0, 26.0, 13.8);
        while (band + 2 < SKIN_BANDS && w > skin_bands[band + 1]) ++band;
        for (c = 0; c < 3; ++c) {
            const double t = (w - skin_bands[band]) / (skin_bands[band + 1] - skin_bands[band]);
            const double v = light * (rgb[c][0] * x + rgb[c][1] * y + rgb[c][2] * z);
            weight[band][c] += (1 - t) * v;
            weight[band + 1][c] += t * v;
            sum[c] += v;
        }
    }
    for (i = 0; i < SKIN_BANDS; ++i)
        for (c = 0; c < 3; ++c) weight[i][c] /= sum[c];
}

/* Rows of the bands become rows of R, G, B, in place. */
static void skin_rows(double *row, int n, double weight[SKIN_BANDS][3])
{
    int i, band, c;
    for (i = 0; i < n; ++i) {
        double sum[3] = {0, 0, 0};
        for (band = 0; band < SKIN_BANDS; ++band)
            for (c = 0; c < 3; ++c) sum[c] += weight[band][c] * row[(size_t)band * (size_t)n + (size_t)i];
        for (c = 0; c < 3; ++c) row[(size_t)c * (size_t)n + (size_t)i] = sum[c];
    }
}

/* Its diffusion profile for R, G and B from 13 wavelengths. total is its color under daylight (D65) in linear sRGB
   (observer: Wyman, Sloan, Shirley 2013, JCGT 2:2). Rings are means of the wavelengths' profiles, weighted by the
   positive part of what each gives to the channel. options and statuses as in ms_mcml_profile_layers: MS_UNSUPPORTED
   where g is not 0, or a layer thinner than the solver takes (an epidermis of 0.03 mm of the default scattering is
   not). Release with ms_mcml_profile_destroy. */
static ms_status skin_profile(ms_mcml_profile *profile, const skin_parameters *skin,
                              const ms_mcml_profile_options *options, ms_error *error)
{
    ms_mcml_layer layers[SKIN_BANDS][3];
    ms_mcml_tissue tissue[SKIN_BANDS];
    double weight[SKIN_BANDS][3];
    ms_status status = MS_OK;
    int i, c;
    memset(profile, 0, sizeof *profile);
    for (i = 0; i < SKIN_BANDS; ++i) {
        tissue[i].n_above = 1;
        tissue[i].n_below = 1.4;
        tissue[i].layers = layers[i];
        status = skin_layers(skin, skin_bands[i], layers[i], &tissue[i].layer_count, error);
        if (status) return status;
    }
    status = ms_mcml_profile_layers(profile, tissue, SKIN_BANDS, options, error);
    if (status) return status;
    skin_band_weights(weight);
    for (c = 0; c < 3; ++c) {
        double color = 0, positive = 0;
        for (i = 0; i < SKIN_BANDS; ++i) {
            color += weight[i][c] * profile->total[i];
            if (weight[i][c] < 0) weight[i][c] = 0;
            positive += weight[i][c] * profile->total[i];
        }
        color = color > 0 ? color : 0;
        for (i = 0; i < SKIN_BANDS; ++i) weight[i][c] *= color / positive;
    }
    for (c = 0; c < 3; ++c) profile->entering[c] = profile->entering[0]; /* the index is one for all */
    skin_rows(profile->total, 1, weight);
    skin_rows(profile->total_error, 1, weight);
    skin_rows(profile->rd_per_mm2, profile->rings, weight);
    skin_rows(profile->rd_error_per_mm2, profile->rings, weight); /* alike in neighboring wavelengths: they add */
    skin_rows(profile->within, profile->rings + 1, weight);
    profile->channels = 3;
    return status;
}

#endif /* SKIN_H */
