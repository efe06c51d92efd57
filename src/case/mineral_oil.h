/// Kinematic viscosity of mineral oils over temperature.
#ifndef CASE_MINERAL_OIL_H
#define CASE_MINERAL_OIL_H

/// m2/s at a temperature (K), of an oil whose viscosity at 40 and at 100 degC is known: log10 log10(nu + 0.7), nu in
/// mm2/s, falls linearly with log10 T (Walther 1931; ASTM D341).
double mineral_oil_viscosity(double at_40, double at_100, double temperature);

/// m2/s at 100 degC of an oil of viscosity index 100, by that at 40 degC, 6.5 to 1500 mm2/s (ASTM D2270, some rows of
/// whose table are joined by straight lines between logarithms).
double mineral_oil_at_100(double at_40);

#endif
