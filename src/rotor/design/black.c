// Equations: docs/theory.md, "Annular seal".
#include "black.h"

#include <math.h>

/// Returns the friction factor of a smooth annulus whose inner wall turns (Yamada 1962).
static double black_friction(double axial, double around) {
    const double turned = 7.0 * around / (8.0 * axial);
    return 0.079 * pow(axial, -0.25) * pow(1.0 + turned * turned, 0.375);
}

black_coefficients black_find(const black_seal *seal, double speed) {
    const double c = seal->clearance, surface = seal->radius * speed, inlet = 1.0 + seal->loss;
    const double thin = seal->density * c / seal->viscosity, around = thin * surface;
    double velocity = sqrt(2.0 * seal->pressure / seal->density / inlet), lambda = 0.0;
    // Each pass at least halves the error, since friction falls more slowly than 1/V.
    for (int i = 0; i < 100; i++) {
        lambda = black_friction(2.0 * thin * velocity, around);
        velocity = sqrt(2.0 * seal->pressure / seal->density / (inlet + 2.0 * lambda * seal->length / c));
    }
    const double s = lambda * seal->length / c, a = inlet + 2.0 * s, passing = seal->length / velocity;
    const double spring = inlet * s * s / (a * a);
    const double damper = 2.0 * s / a * (0.5 * inlet * ((1.0 + s) / a - s / (a * a)) + s / 6.0);
    const double mass = 2.0 * s / a * (0.5 * inlet * (0.5 / a - (1.0 + s) / (a * a) + s / (a * a * a)) + 1.0 / 12.0);
    const double scale = 3.14159265358979323846 * seal->radius * seal->pressure / lambda;
    // The shear along the axis is lambda rho V^2/2. The ratio of the shear around the shaft to it is that of the slip
    // to V.
    const double ratio = 0.5 - (seal->swirl - 0.5) * expm1(-s) / s, slip = surface * (1.0 - ratio);
    const double area = 6.28318530717958647692 * seal->radius * seal->length;
    return (black_coefficients){.stiffness = scale * spring,
                                .damping = scale * damper * passing,
                                .mass = scale * mass * passing * passing,
                                .ratio = ratio,
                                .velocity = velocity,
                                .reynolds = 2.0 * thin * hypot(velocity, 0.5 * surface),
                                .shear = seal->radius * area * 0.5 * lambda * seal->density * velocity * slip};
}
