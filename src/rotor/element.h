/// What an element is made of: its keys, and the numbers that follow from them for its kernel.
///
/// All is scaled: time by 1/omega, lengths by the rotor's length scale, forces on a station by its mass, so that an
/// element adds to accelerations. The physics itself is in <element>_kernel.h, written once over the vector type.
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
} scales;

/// kg rad^2/s^2 by which a stiffness on a station is scaled.
static inline double stiffness_scale(const scales *scale, size_t station) {
    return scale->mass[station] * scale->speed * scale->speed;
}

/// What acts on one station alone and does not depend on where it is; the numbers of station_kernel.h.
enum { STATION_DAMPING, STATION_UNBALANCE_COS, STATION_UNBALANCE_SIN, STATION_PULL_X, STATION_PULL_Y, STATION_NUMBERS };

enum { MAX_ELEMENT_NUMBERS = 8 };

/// An element as its kernel sees it. The structure (station, law) is shared by all machines of a block, the numbers are
/// not.
typedef struct element {
    const struct element_type *type;
    size_t station[2];
    int law;
    double number[MAX_ELEMENT_NUMBERS];
} element;

/// The kernels, in the order in which they act; KERNEL_NONE for elements that join the station pass.
typedef enum kernel { KERNEL_NONE = -1, KERNEL_SHAFT, KERNEL_FILM, KERNEL_RUB, KERNEL_COUNT } kernel;

/// The values that depend on time alone, as the kernels index them.
enum { COS_TAU, SIN_TAU, COS_2TAU, SIN_2TAU, FORCING_COUNT };

typedef struct element_type {
    whirl_group group;
    kernel kernel;
    size_t number_count;

    /// Stations, law and numbers from values. WHIRL_BAD_INPUT where keys contradict each other.
    whirl_status (*build)(const key_value *values, const scales *scale, element *out);

    /// Without a kernel: adds to the numbers of the stations [station_count][STATION_NUMBERS].
    void (*lump)(const element *own, size_t station_count, double (*stations)[STATION_NUMBERS]);

    /// Optional: writes the switching functions at positions q and velocities v, `switch_count(own)` of them.
    size_t (*switch_count)(const element *own);
    void (*switches)(const element *own, const double *q, const double *v, double *values);

    /// With switches: derivatives of switch `index` by the place and velocity of station[0], and its second derivative
    /// applied to the disturbance (uq, uv) of that station. All of them [2].
    void (*switch_gradient)(const element *own, const double *q, const double *v, size_t index, double *by_q,
                            double *by_v);
    void (*switch_curvature)(const element *own, const double *q, const double *v, size_t index, const double *uq,
                             const double *uv, double *by_q, double *by_v);

    /// With switches: whether motions can slide along one (friction that jumps where the slip reverses).
    bool (*slides)(const element *own);

    /// For unilateral contacts: the gap in length scales around station[0], and the normal force in newtons.
    double (*contact_gap)(const element *own);
    double (*contact_force)(const element *own, const double *q, const double *v);
    bool (*contact_damped)(const element *own); ///< whether the force depends on the velocity

    /// For bearings: the clearance in length scales around station[0].
    double (*bearing_clearance)(const element *own);
} element_type;

/// All elements in the order in which they act (the order fixes the last bits of a sum); ended by NULL.
extern const element_type *const element_types[];

extern const element_type shaft_element, film_element, rub_element, unbalance_element, gravity_element;

/// The station's own keys, and what they add to the station pass.
extern const whirl_group station_group;
double station_mass(const key_value *values);
void station_lump(const key_value *values, const scales *scale, size_t station, double numbers[STATION_NUMBERS]);

/// Adds an unbalance of `moment` (kg m) at `angle` (rad, from the x axis at tau = 0).
void add_unbalance(const scales *scale, size_t station, double moment, double angle, double numbers[STATION_NUMBERS]);

#endif
