/// A plain annular seal by its geometry, short and turbulent (Black 1969; Black, Jenssen 1970).
#ifndef ROTOR_BLACK_H
#define ROTOR_BLACK_H

/// SI. `pressure` is what drops over the seal, `loss` that at its inlet over rho V^2/2 (without the velocity head
/// itself), `swirl` the speed around the shaft with which fluid enters over that of the shaft's surface.
typedef struct black_seal {
    double radius, length, clearance, density, viscosity, pressure, loss, swirl;
} black_seal;

/// What seen from the fluid, which turns at `ratio` of the shaft's speed, is a spring, a damper and a mass; the mean
/// axial velocity, and the Reynolds number 2 rho c |velocity|/mu of that and half the surface's speed.
typedef struct black_coefficients {
    double stiffness, damping, mass, ratio, velocity, reynolds;
} black_coefficients;

/// At a speed of the shaft, rad/s, >= 0.
black_coefficients black_find(const black_seal *seal, double speed);

#endif
