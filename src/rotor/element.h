/// What an element is made of: its keys, how its coefficients follow from them, and the forces it adds.
///
/// All is scaled: time by 1/omega, lengths by the rotor's length scale, forces on a station by its mass, so that an
/// element adds to accelerations. Coefficients are computed once; the force functions are pure.
#ifndef ROTOR_ELEMENT_H
#define ROTOR_ELEMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/descriptor.h"
#include "whirl/status.h"

/// Station index of the ground.
#define GROUND ((size_t)-1)

/// The value of one key, in the order of the group's table; in SI.
typedef struct key_value {
    bool given;
    double number;
    int choice;
    size_t station[2];
} key_value;

/// What the scaling needs.
typedef struct scales {
    double speed;       ///< omega, rad/s
    double length;      ///< length scale, m
    const double *mass; ///< of every station, kg
    size_t station_count;
} scales;

/// kg rad^2/s^2 by which a stiffness on a station is scaled.
static inline double stiffness_scale(const scales *scale, size_t station) {
    return scale->mass[station] * scale->speed * scale->speed;
}

/// What acts on one station alone and does not depend on where it is.
typedef struct station_terms {
    double damping; ///< c/(m omega)
    double unbalance_cos,
        unbalance_sin;     ///< acceleration (cos tau - sin tau, ...) of the unbalance in phase and 90 degrees ahead
    double pull_x, pull_y; ///< constant acceleration (gravity)
} station_terms;

/// The values that depend on time alone, as the elements index them.
enum { COS_TAU, SIN_TAU, COS_2TAU, SIN_2TAU, FORCING_COUNT };

/// Exactly one of `lump` (joins the station pass) and `force` is set.
typedef struct element_type {
    whirl_group group;
    size_t size; ///< bytes of the coefficients

    /// Coefficients from values. WHIRL_BAD_INPUT where keys contradict each other.
    whirl_status (*build)(const key_value *values, const scales *scale, void *coefficients);

    /// Adds constant and rotating terms to the stations [station_count].
    void (*lump)(const void *coefficients, size_t station_count, station_terms *terms);

    /// Adds accelerations a at positions q and velocities v (x, y of station 0, of station 1, ...).
    void (*force)(const void *coefficients, const double *forcing, const double *q, const double *v, double *a);

    /// Writes the switching functions, `switch_count(coefficients)` of them.
    size_t (*switch_count)(const void *coefficients);
    void (*switches)(const void *coefficients, const double *q, const double *v, double *values);

    /// For unilateral contacts: the station, and the normal force in newtons (0 while open).
    size_t (*contact_station)(const void *coefficients);
    double (*contact_force)(const void *coefficients, const double *q);

    /// For bearings: the station and the clearance in length scales.
    size_t (*bearing_station)(const void *coefficients, double *clearance);
} element_type;

/// All elements in the order in which they act (the order fixes the last bits of a sum); ended by NULL.
extern const element_type *const element_types[];

extern const element_type shaft_element, film_element, rub_element, unbalance_element, gravity_element;

/// The station's own keys, and what they add to the station pass.
extern const whirl_group station_group;
double station_mass(const key_value *values);
void station_lump(const key_value *values, const scales *scale, size_t station, station_terms *terms);

/// Adds an unbalance of `moment` (kg m) at `angle` (rad, from the x axis at tau = 0).
void add_unbalance(const scales *scale, size_t station, double moment, double angle, station_terms *terms);

/// Film force on a journal at (x, y) with velocity (vx, vy), per unit of F0, in clearances and radians (see film.c).
void film_force(double x, double y, double vx, double vy, double force[2]);

#endif
