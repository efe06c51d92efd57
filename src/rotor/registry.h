/// The elements, one line each, in the order in which they act. The order fixes the last bits of a sum.
#ifndef ROTOR_REGISTRY_H
#define ROTOR_REGISTRY_H

#include "element.h"

#define ELEMENTS(X)                                                                                                    \
    X(unbalance)                                                                                                       \
    X(force)                                                                                                           \
    X(gravity)                                                                                                         \
    X(disc)                                                                                                            \
    X(beam)                                                                                                            \
    X(segment)                                                                                                         \
    X(coupling)                                                                                                        \
    X(bearing)                                                                                                         \
    X(shaft)                                                                                                           \
    X(film)                                                                                                            \
    X(rub)                                                                                                             \
    X(spring)                                                                                                          \
    X(crack)                                                                                                           \
    X(seal)                                                                                                            \
    X(looseness)                                                                                                       \
    X(mount)                                                                                                           \
    X(ball_bearing)                                                                                                    \
    X(squeeze)                                                                                                         \
    X(stage)                                                                                                           \
    X(pad_bearing)                                                                                                     \
    X(tilting_pad)                                                                                                     \
    X(roller_bearing)                                                                                                  \
    X(contact)                                                                                                         \
    X(magnetic)                                                                                                        \
    X(blade_rub)                                                                                                       \
    X(floating_ring)                                                                                                   \
    X(joint)                                                                                                           \
    X(coupling_load)                                                                                                   \
    X(cubic_spring)                                                                                                    \
    X(friction)                                                                                                        \
    X(unbalance_grade)                                                                                                 \
    X(runout)                                                                                                          \
    X(drive)                                                                                                           \
    X(gear)                                                                                                            \
    X(induction_motor)                                                                                                 \
    X(synchronous_start)                                                                                               \
    X(fatigue)                                                                                                         \
    X(pulsation)                                                                                                       \
    X(short_circuit)                                                                                                   \
    X(timed_torque)

#define DECLARE(name) extern const element_type name##_element;
ELEMENTS(DECLARE)
#undef DECLARE

/// Builds the element `unbalance` for an unbalance of a station on a shaft of another speed, with which it turns.
whirl_status unbalance_follow(const aside_unbalance *own, assembly *to, element *out);

#endif
