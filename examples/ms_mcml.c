/* How light spreads in skin: the diffusion profile of a thin beam, in three color channels, without noise.
     cc -O2 -I. examples/ms_mcml.c -o build/ms_mcml -lm && build/ms_mcml */
#define MS_MCML_IMPLEMENTATION
#include "ms_mcml.h"
#include <stdio.h>

int main(void)
{
    ms_mcml_medium skin[3];
    ms_mcml_profile profile;
    ms_error error;
    int c, i;
    for (c = 0; c < 3; ++c) skin[c] = ms_mcml_material_medium(ms_mcml_find_material("skin1"), c);
    if (ms_mcml_profile_make(&profile, skin, 3, NULL, &error) != MS_OK) return puts(error.message), 1;
    printf("reflected: red %.4f, green %.4f, blue %.4f\n", profile.total[0], profile.total[1], profile.total[2]);
    printf("radius, mm   share of the light that leaves nearer than that\n");
    for (i = profile.rings / 8; i <= profile.rings; i += profile.rings / 8) {
        printf("%10.3f", profile.edge_mm[i]);
        for (c = 0; c < 3; ++c) printf("   %6.4f", profile.within[c * (profile.rings + 1) + i] / profile.total[c]);
        printf("\n");
    }
    ms_mcml_profile_destroy(&profile);
    return 0;
}
