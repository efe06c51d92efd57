/// Turbulence of a film: factors by its local Reynolds number, rho U h/mu with the speed U of the journal's surface and
/// the thickness h. All are 1 if that is 0.
#ifndef ROTOR_TURBULENCE_H
#define ROTOR_TURBULENCE_H

#include "whirl/engine/bearing.h"

/// Divisors of the flow that a pressure gradient drives, around the bearing and along its axis: 12 G of the literature
/// inverted, (1 + .0136/12 Re^.90, 1 + .0043/12 Re^.96) of Ng and Pan 1965.
typedef struct turbulent_factors {
    double around, along;
} turbulent_factors;

turbulent_factors turbulent_resistance(whirl_turbulence law, double reynolds);

/// Shear of Couette flow over the laminar one, 1 + .0012 Re^.94 (Constantinescu, Galetuse 1965).
double turbulent_shear(whirl_turbulence law, double reynolds);

#endif
