#include "turbulence.h"

#include <math.h>

turbulent_factors turbulent_resistance(whirl_turbulence law, double reynolds) {
    static const struct {
        double around[2], along[2]; // 12 + a Re^b
    } laws[] = {
        [WHIRL_LAMINAR] = {{0.0, 1.0}, {0.0, 1.0}},
        [WHIRL_NG_PAN] = {{0.0136, 0.90}, {0.0043, 0.96}},
        [WHIRL_CONSTANTINESCU] = {{0.0260, 0.8265}, {0.0198, 0.741}},
    };
    const double *around = laws[law].around, *along = laws[law].along;
    return (turbulent_factors){1.0 + around[0] * pow(reynolds, around[1]) / 12.0,
                               1.0 + along[0] * pow(reynolds, along[1]) / 12.0};
}

double turbulent_shear(whirl_turbulence law, double reynolds) {
    return law == WHIRL_LAMINAR ? 1.0 : 1.0 + 0.0012 * pow(reynolds, 0.94);
}
