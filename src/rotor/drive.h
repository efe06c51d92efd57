/// Torques on a shaft whose speed is a state of the machine: motors, loads and others.
#ifndef ROTOR_DRIVE_H
#define ROTOR_DRIVE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"

/// The drive: a motor's torque over the speed, and a load, in SI. Torques and speeds are positive in the sense of the
/// rotation.
typedef struct shaft_drive {
    bool given;
    size_t at, load_at; ///< stations of the motor and of its load; NO_STATION: the shaft as a whole
    double inertia;     ///< inertia of all turning parts about axes through their centres of mass, kg m2; 0: that
                        ///< of the twisting stations
    double torque;      ///< torque of the motor at standstill, N m
    double no_load;     ///< speed at which the torque has fallen linearly to 0, rad/s; 0: the torque is constant
    size_t count;       ///< rows of the table that replaces torque and no_load; 0: no table
    double speeds[WHIRL_MAX_LIST], torques[WHIRL_MAX_LIST];
    double load, linear, quadratic; ///< N m, N m s, N m s2: the load is load + linear w + quadratic w |w|
} shaft_drive;

/// Returns the torque of the motor at a speed in rad/s, N m. Beyond an end of its table the torque is that at the end.
double drive_torque(const shaft_drive *drive, double speed);

/// Returns the torque of the load against the rotation, N m. Dry friction (`load`) acts fully at speeds from `slip`,
/// rad/s, on. Below, it is proportional to the speed; with slip 0 it acts fully even at standstill.
double drive_load(const shaft_drive *drive, double speed, double slip);

/// Returns the highest speed for which the motor is described, rad/s: its no-load speed, or the end of its table; 0 if
/// it is unlimited.
double drive_highest(const shaft_drive *drive);

/// Maximum number of torques of a rotor; of states of a torque; of numbers of its law.
enum { MAX_TORQUES = 16, TORQUE_STATES = 4, TORQUE_NUMBERS = 8 };

/// Time, speed and angle at which a torque acts, SI; the latter are positive in the sense of its station's rotation.
typedef struct torque_place {
    double time;         ///< s
    double speed, angle; ///< rad/s and rad, of its station
    const double *state; ///< states of the torque
} torque_place;

/// A torque on a station of a shaft whose speed changes. It depends on time, speed and angle.
typedef struct shaft_torque {
    const struct torque_law *law;
    size_t station;                ///< NO_STATION: the shaft as a whole
    double number[TORQUE_NUMBERS]; ///< numbers of the law
    size_t count;                  ///< columns of its table
    double table[3][WHIRL_MAX_LIST];
} shaft_torque;

/// A law of torques.
typedef struct torque_law {
    const char *name; ///< name of its element
    size_t states;    ///< first-order states, which begin at 0
    bool motor;       ///< it is a motor: its torque ends when the motor trips
    /// Returns the torque, N m, and writes the slopes of its states by time unless NULL.
    double (*torque)(const shaft_torque *own, const torque_place *at, double *slopes);
    /// Optional: returns the speed of its station without load, rad/s.
    double (*highest)(const shaft_torque *own);
    /// Optional: returns the instant, s, at which the torque begins; there it may jump.
    double (*begins)(const shaft_torque *own);
} torque_law;

#endif
