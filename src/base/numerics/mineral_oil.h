/// Kinematic viscosity of mineral oils over temperature: log10 log10(nu + 0.7), nu in mm2/s, falls linearly with log10
/// T (Walther 1931; ASTM D341).
#ifndef BASE_MINERAL_OIL_H
#define BASE_MINERAL_OIL_H

#include <stddef.h>

/// Temperatures at which viscosities are usually given, K.
#define OIL_40_DEGREES 313.15
#define OIL_100_DEGREES 373.15

/// Returns the kinematic viscosity in m2/s at a temperature in K. It uses the two rows of `count` >= 2 around the
/// temperature, or the two nearest ones; temperatures rise, viscosities (m2/s) fall.
double mineral_oil_viscosity(const double *temperatures, const double *viscosities, size_t count, double temperature);

/// Returns the kinematic viscosity in m2/s at 100 degC of an oil of viscosity index 100, from that at 40 degC, which is
/// 6.5 to 1500 mm2/s (ASTM D2270; straight lines between logarithms of some rows of its table).
double mineral_oil_at_100(double at_40);

#endif
