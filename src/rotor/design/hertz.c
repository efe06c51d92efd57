// Contacts are those on the inner race, which has the highest pressure.
#include "hertz.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/// E/(1 - nu^2) of steel, Pa.
static const double modulus = 2.06e11 / (1.0 - 0.09);

double hertz_ball_load(double diameter, double race, double groove) {
    // Compute the radii of curvature along the rolling and across it; the ellipse is by the fit of Brewe, Hamrock 1977.
    const double along = 1.0 / (2.0 / diameter + 1.0 / race);
    const double across = 1.0 / (2.0 / diameter - 1.0 / (groove * diameter));
    const double radius = 1.0 / (1.0 / along + 1.0 / across), shape = 1.0339 * pow(across / along, 0.636);
    const double integral = 1.0003 + 0.5968 * along / across;
    // Half axes a = (6 k^2 E Q R/(pi E'))^(1/3) and a/k; the pressure is 3 Q/(2 pi a a/k).
    const double by_load = 6.0 * shape * shape * integral * radius / (pi * modulus);
    const double root = HERTZ_MAX_BALL * 2.0 * pi / (3.0 * shape);
    return root * root * root * by_load * by_load;
}

double hertz_roller_load(double diameter, double race, double stiffness) {
    // The approach of one contact is 3.84e-5 Q^0.9/l^0.8 mm with lengths in mm (Palmgren). Two contacts in series give
    // the stiffness.
    const double of_one = pow(2.0 * 3.84e-5, -10.0 / 9.0) * pow(1e3, 10.0 / 9.0);
    const double length = 1e-3 * pow(stiffness / of_one, 9.0 / 8.0);
    const double radius = 1.0 / (2.0 / diameter + 1.0 / race);
    return 2.0 * pi * radius * length * HERTZ_MAX_ROLLER * HERTZ_MAX_ROLLER / modulus;
}
