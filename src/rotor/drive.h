/// The drive of a shaft whose speed is a state of the machine: a motor's torque over the speed, and a load.
#ifndef ROTOR_DRIVE_H
#define ROTOR_DRIVE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"

/// SI. Torques and speeds count in the sense of the rotation.
typedef struct shaft_drive {
    bool given;
    double inertia; ///< kg m2, inertia of all turning parts about axes through their centres of mass
    double torque;  ///< N m of the motor at standstill
    double no_load; ///< rad/s at which the torque has fallen linearly to 0; 0: the torque is constant
    size_t count;   ///< rows of the table that replaces torque and no_load; 0: no table
    double speeds[WHIRL_MAX_LIST], torques[WHIRL_MAX_LIST];
    double load, linear, quadratic; ///< N m, N m s, N m s2: the load is load + linear w + quadratic w |w|
} shaft_drive;

/// Returns the torque of the motor, N m, at a speed in rad/s; beyond its table the value at the table's end.
double drive_torque(const shaft_drive *drive, double speed);

/// Returns the torque of the load against the rotation, N m. Dry friction (`load`) counts as for a turning shaft at
/// standstill too.
double drive_load(const shaft_drive *drive, double speed);

/// Returns the highest speed for which the motor is described, rad/s: its no-load speed, or the end of its table; 0:
/// unlimited.
double drive_highest(const shaft_drive *drive);

#endif
