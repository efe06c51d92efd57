/// Coefficients of a plain annular seal from its geometry; the seal is short and turbulent (Black 1969; Black, Jenssen
/// 1970).
#ifndef ROTOR_BLACK_H
#define ROTOR_BLACK_H

/// Geometry of the seal, SI. pressure: drop over the seal; loss: drop at its inlet divided by rho V^2/2, without the
/// velocity head itself; swirl: circumferential speed of the entering fluid divided by that of the shaft's surface.
typedef struct black_seal {
    double radius, length, clearance, density, viscosity, pressure, loss, swirl;
} black_seal;

/// Coefficients in a frame that turns with the fluid, at `ratio` times the shaft's speed. velocity: mean axial
/// velocity, m/s; reynolds: 2 rho c |velocity|/mu, of that velocity and half the surface's; shear: torque of the walls'
/// shear on the shaft, N m.
typedef struct black_coefficients {
    double stiffness, damping, mass, ratio, velocity, reynolds, shear;
} black_coefficients;

/// Computes the coefficients at a speed of the shaft, rad/s, >= 0.
black_coefficients black_find(const black_seal *seal, double speed);

#endif
