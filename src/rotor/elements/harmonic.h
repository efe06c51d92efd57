/// Forces that are harmonic in a phase of their own, which turns at a constant rate (force.c).
#ifndef ROTOR_HARMONIC_H
#define ROTOR_HARMONIC_H

#include "element.h"

/// The force along x and y, newtons: X_C cos theta + X_S sin theta, Y_C cos theta + Y_S sin theta; theta' by tau. As
/// many numbers follow as there are ports.
enum {
    HARMONIC_XC,
    HARMONIC_XS,
    HARMONIC_YC,
    HARMONIC_YS,
    HARMONIC_RATE,
    HARMONIC_OWN,
    HARMONIC_NUMBERS = HARMONIC_OWN + 4
};

/// The largest rate, either way.
#define HARMONIC_FASTEST 1000.0

extern const element_kernels *const harmonic_kernels[VECTOR_ISAS];

/// Turns of the phase in a revolution.
double harmonic_rounds(const element *own);

/// Makes the element a force of `size` newtons on the ports out->port[0] and [1] that turns from `angle` on, `rate`
/// times as fast as the shaft.
void harmonic_turning(element *out, const assembly *to, double size, double angle, double rate);

#endif
