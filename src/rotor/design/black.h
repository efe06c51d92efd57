/// A plain annular seal by its geometry, short and turbulent (Black 1969; Black, Jenssen 1970).
#ifndef ROTOR_BLACK_H
#define ROTOR_BLACK_H

/// Geometry of the seal, SI. `pressure` is the drop over the seal, `loss` that at its inlet over rho V^2/2 (without the
/// velocity head itself), `swirl` the circumferential speed of the entering fluid over that of the shaft's surface.
typedef struct black_seal {
    double radius, length, clearance, density, viscosity, pressure, loss, swirl;
} black_seal;

/// Coefficients in a frame that turns with the fluid, at `ratio` of the shaft's speed; mean axial velocity; Reynolds
/// number 2 rho c |velocity|/mu of that and half the surface's speed; torque of the walls' shear on the shaft.
typedef struct black_coefficients {
    double stiffness, damping, mass, ratio, velocity, reynolds, shear;
} black_coefficients;

/// Computes the coefficients at a speed of the shaft, rad/s, >= 0.
black_coefficients black_find(const black_seal *seal, double speed);

#endif
