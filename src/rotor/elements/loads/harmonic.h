/// Forces that are harmonic in their own phase, which turns at a constant rate (force.c).
#ifndef ROTOR_HARMONIC_H
#define ROTOR_HARMONIC_H

#include "element.h"

/// Numbers: the force along x and y in newtons, X_C cos theta + X_S sin theta and Y_C cos theta + Y_S sin theta; theta'
/// by tau. As many numbers as there are ports follow.
enum {
    HARMONIC_XC,
    HARMONIC_XS,
    HARMONIC_YC,
    HARMONIC_YS,
    HARMONIC_RATE,
    HARMONIC_OWN,
    HARMONIC_NUMBERS = HARMONIC_OWN + 4
};

/// Largest accepted speed of a phase over that of the shaft, in either direction. For motions also the maximum number
/// of turns of a phase in a revolution, since their steps and samples are counted in turns.
#define HARMONIC_FASTEST 1000.0

extern const element_kernels *const harmonic_kernels[VECTOR_ISAS];

/// The key of the phase that defines sections.
// clang-format off
#define HARMONIC_KEYPHASOR                                                                                             \
    CHOICE_KEY("keyphasor", DEFAULT("no"), "no|yes", \
     "yes: the turns of this phase, in place of the shaft's, define sections, revolutions and orders")
// clang-format on

/// Returns the number of turns of the phase in a revolution.
double harmonic_rounds(const element *own, size_t state);

/// Rejects a phase that turns too often in a revolution if the machine is built to move (assembly.in_time). Studies at
/// rest do not depend on phases. WHIRL_BAD_INPUT with a sentence.
whirl_status harmonic_check_rate(const assembly *to, double rate);

/// Returns the order of element_type.named_order, without name: the phase's rate if it turns faster than the shaft.
bool harmonic_order(const element *own, size_t index, double *order);

/// Makes the element a force of `size` newtons on the ports out->port[0] and [1]. Its phase starts at `phase` and turns
/// by `rate` per radian of tau. It acts along the direction `angle` (side 0), or turns from there with the shaft (side
/// 1) or against it (side -1).
void harmonic_force(element *out, const assembly *to, double size, double side, double angle, double phase,
                    double rate);

/// The keys `at`, `moment` and `angle` of an unbalance, with which its enum begins.
// clang-format off
#define UNBALANCE_KEYS                                                                                                 \
    STATION_KEY("at", REQUIRED, "station that carries it"),                       \
    CITED_NUMBER_KEY("moment", "U", "kg m", REQUIRED, WHIRL_NOT_NEGATIVE, \
     "unbalance: mass times distance from the shaft's centre", "ISO 21940-1"),                                         \
    ANGLE_KEY("angle", "beta", NULL, "position at t = 0, from the x axis towards y")
// clang-format on

#endif
