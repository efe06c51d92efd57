/// Turbulence of a film: factors by its local Reynolds number rho U h/mu, with the speed U of the journal's surface and
/// the thickness h. All factors are 1 if it is 0.
#ifndef ROTOR_TURBULENCE_H
#define ROTOR_TURBULENCE_H

#include "whirl/internal/bearing.h"

/// Divisors of the flow that a pressure gradient drives, around the bearing and along its axis. They are the inverse of
/// 12 G in the literature: 1 + .0136/12 Re^.90 and 1 + .0043/12 Re^.96 (Ng and Pan 1965).
typedef struct turbulent_factors {
    double around, along;
} turbulent_factors;

/// Returns the divisors by a law at a Reynolds number.
turbulent_factors turbulent_resistance(whirl_turbulence law, double reynolds);

/// Returns the ratio of the shear of Couette flow to that of laminar flow, 1 + .0012 Re^.94 (Constantinescu, Galetuse
/// 1965).
double turbulent_shear(whirl_turbulence law, double reynolds);

#endif
