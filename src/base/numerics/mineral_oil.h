/// Kinematic viscosity of mineral oils over temperature: log10 log10(nu + 0.7), nu in mm2/s, falls linearly with log10
/// T (Walther 1931; ASTM D341).
#ifndef BASE_MINERAL_OIL_H
#define BASE_MINERAL_OIL_H

#include <stddef.h>

/// Where they are known by heart, K.
#define OIL_40_DEGREES 313.15
#define OIL_100_DEGREES 373.15

/// m2/s at a temperature (K), by the two of `count` >= 2 rows between which it lies, or else the nearest two;
/// temperatures rise, viscosities fall.
double mineral_oil_viscosity(const double *temperatures, const double *viscosities, size_t count, double temperature);

/// m2/s at 100 degC of an oil of viscosity index 100, by that at 40 degC, 6.5 to 1500 mm2/s (ASTM D2270, some rows of
/// whose table are joined by straight lines between logarithms).
double mineral_oil_at_100(double at_40);

#endif
