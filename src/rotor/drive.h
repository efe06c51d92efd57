/// What turns a shaft whose speed is a state of the machine: a motor's torque over the speed, and a load.
#ifndef ROTOR_DRIVE_H
#define ROTOR_DRIVE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"

/// SI. Torques and speeds count in the sense of the rotation.
typedef struct shaft_drive {
    bool given;
    double inertia; ///< kg m2, of all that turns, about axes through its centres of mass
    double torque;  ///< N m of the motor at standstill
    double no_load; ///< rad/s at which that has fallen to 0 along a line; 0: it stays
    size_t count;   ///< of the table, in place of torque and no_load; 0: there is none
    double speeds[WHIRL_MAX_LIST], torques[WHIRL_MAX_LIST];
    double load, linear, quadratic; ///< N m, N m s, N m s2: the load is load + linear w + quadratic w |w|
} shaft_drive;

/// Torque of the motor, N m, at a speed in rad/s. Beyond its table it stays as it is at the end of it.
double drive_torque(const shaft_drive *drive, double speed);

/// Torque of the load against the rotation. Dry friction (`load`) is that of a shaft that turns.
double drive_load(const shaft_drive *drive, double speed);

/// The highest speed that the motor is described for, rad/s: without load, or the end of its table; 0: unlimited.
double drive_highest(const shaft_drive *drive);

#endif
