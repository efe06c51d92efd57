/// Linear analyses of a system about its equilibrium: equilibrium, modes, synchronous response.
///
/// An equilibrium is a zero of the right-hand side with the amplitude of the forcing at zero (without unbalance; with
/// gravity and films). Small motions about it follow its Jacobian. If coefficients turn with the shaft (unequal
/// stiffness, cracks), the monodromy matrix of a periodic motion with the forcing takes its place, by Floquet's theory.
/// Turning coordinates (whirl_system.turns) are averaged: forces are their mean over a turn.
#ifndef WHIRL_LINEAR_H
#define WHIRL_LINEAR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Carries x [dimension] from a start to the equilibrium, by damped Newton steps with the system's Jacobian and, if
/// these fail, by raising the load in steps. A start that is an equilibrium stays unchanged, except for coordinates
/// that the system itself moves to their equilibrium (whirl_system.settle), such as tilts of pads.
/// WHIRL_NUMERICAL_FAILURE with a sentence if none is found; WHIRL_BAD_INPUT if the system has no Jacobian;
/// WHIRL_NO_MEMORY.
whirl_status whirl_equilibrium(const whirl_system *system, double *x);

/// Returns the share of the static load up to which whirl_equilibrium can follow the equilibrium from a start
/// [dimension]: 1 if it finds one; 0 also if memory is exhausted.
double whirl_equilibrium_share(const whirl_system *system, const double *start);

/// Computes the function whose zero is the equilibrium, slope [dimension], and its derivative by x, jacobian
/// [dimension][dimension]. The function is the right-hand side at x [dimension] with the amplitude of the forcing at
/// zero, averaged over turning coordinates. Rows and columns of turning coordinates are 0. Errors as whirl_equilibrium.
whirl_status whirl_rest_slope(const whirl_system *system, const double *x, double *slope, double *jacobian);

/// Computes the normal forces of all contacts at x, force [contact_count], averaged in the same way; 0 for open
/// contacts. Errors as whirl_equilibrium.
whirl_status whirl_rest_contacts(const whirl_system *system, const double *x, double *force);

/// A mode exp(lambda t); of lambda and its conjugate, the one with the positive imaginary part.
typedef struct whirl_mode {
    double real, imaginary; ///< parts of lambda, in the system's unit of time (rad of a rotor's clock)
    /// Direction of whirl: twice the signed area of the orbits of all probes over their squared sizes. 1: circular,
    /// with the rotation, from x to y; -1: circular, against it; 0: straight, or equal shares of both.
    double direction;
    double torsion; ///< share of twists in its kinetic energy, from 0 to 1 (whirl_system.twist); 0 without any
    double axial;   ///< likewise, of axial displacements (whirl_system.axial)
} whirl_mode;

/// Kinds of modes, by the motion with the largest share of the kinetic energy.
typedef enum whirl_mode_kind { WHIRL_LATERAL_MODE, WHIRL_TORSIONAL_MODE, WHIRL_AXIAL_MODE } whirl_mode_kind;

/// Returns the kind of a mode by its shares of kinetic energy.
whirl_mode_kind whirl_mode_kind_of(double torsion, double axial);

/// Largest damping ratio at which a mode gets a name. Above it a mode is overdamped: it shows no visible oscillation.
#define WHIRL_OVERDAMPED_RATIO 0.9

/// Returns true for an overdamped mode: a damping ratio above WHIRL_OVERDAMPED_RATIO.
bool whirl_mode_is_overdamped(const whirl_mode *mode);

/// Modes about an equilibrium, or of a periodic motion.
typedef struct whirl_modes {
    /// 0, or the period of coefficients that turn with the shaft. lambda is then a Floquet exponent; its imaginary part
    /// is known modulo 2 pi over the period, and given between 0 and half of that. Shapes are then those at t = 0.
    double period;
    size_t dimension, count, real_count; ///< numbers of coordinates, of modes, of real eigenvalues
    double *rest;                        ///< [dimension] the equilibrium, or the state of the periodic motion at t = 0
    whirl_mode *modes;                   ///< [count] by rising imaginary part, overdamped ones last
    double *vectors; ///< [count][dimension][2] shapes, real and imaginary parts; 0 for turning coordinates
    double *reals;   ///< [real_count] eigenvalues of motions that do not oscillate, largest first
    /// The largest real part of all eigenvalues, without the zeros of rigid-body modes: stable below 0, undamped at 0.
    /// A real part within rounding is 0.
    double growth;
    size_t free; ///< number of rigid-body modes: independent displacements without restoring force, with eigenvalues 0
} whirl_modes;

/// Computes the modes of a system; the search for its equilibrium begins at start [dimension]. WHIRL_BAD_INPUT if none
/// is found, or if coefficients turn with angles that do not return after a whole number of revolutions
/// (whirl_system.repeats is 0). Freed by whirl_modes_free.
whirl_status whirl_modes_new(const whirl_system *system, const double *start, whirl_modes **modes);

/// Makes the machine at any frequency of whirl (rad/s), which the caller releases.
typedef struct whirl_whirling {
    whirl_status (*at)(const void *context, double frequency, whirl_machine *machine); ///< makes the machine
    const void *context;                                                               ///< passed to `at`; borrowed
} whirl_whirling;

/// Computes the modes of a machine. If its coefficients depend on the frequency of whirl (whirl_system.frequencies),
/// each mode is computed with the coefficients at its own damped frequency (to a relative 1e-12), within the range of
/// the frequencies. Real eigenvalues belong to frequency 0, and are left out if the coefficients are not known there.
/// growth is NaN if there are neither modes nor real eigenvalues. `others` makes the machines at other frequencies.
/// Errors as whirl_modes_new and those of machines.
whirl_status whirl_modes_of(const whirl_machine *machine, const whirl_whirling *others, whirl_modes **modes);

/// The largest modulus of the sensitivity functions of a system's control loops (ISO 14839-3) about an equilibrium,
/// rest [dimension]. S of a loop is the signal of its sensor over a signal added to it, with all loops closed.
typedef struct whirl_sensitivity_peak {
    double peak;      ///< NaN if there are no loops
    double frequency; ///< in the system's unit of time
    size_t loop;      ///< index of the loop
} whirl_sensitivity_peak;

/// Finds the largest sensitivity; searches near the frequencies of the modes. WHIRL_NO_MEMORY.
whirl_status whirl_loops_peak(const whirl_system *system, const whirl_modes *modes, whirl_sensitivity_peak *out);

/// Frees modes; accepts NULL.
void whirl_modes_free(whirl_modes *modes);

/// Matches each mode of `from` with a mode of `to`, partner [from->count], SIZE_MAX if none is left, by similarity of
/// shapes (modal assurance criterion, Allemang, Brown 1982) and by distance of eigenvalues. Eigenvalues of `from` are
/// first multiplied by `scale`, for systems with different units of time. unlike [from->count], or NULL: dissimilarity
/// of the partners, 0 for equal modes, 1 and more for unrelated ones. WHIRL_NO_MEMORY.
whirl_status whirl_modes_match(const whirl_modes *from, const whirl_modes *to, double scale, size_t *partner,
                               double *unlike);

/// Computes the synchronous response x = rest + Re(X exp(i 2 pi t / period)) to small forcing once a revolution: rest
/// [dimension], response [dimension][2] X. If coefficients turn with the shaft: mean and first harmonic of the periodic
/// motion. Errors as whirl_modes_new, and for an unbounded response.
whirl_status whirl_forced_response(const whirl_system *system, const double *start, double *rest, double *response);

/// Returns WHIRL_BAD_INPUT with a sentence if coefficients depend on the frequency of whirl and are not known at the
/// frequency of the shaft's speed (rad/s, of either sign).
whirl_status whirl_synchronous_check(const whirl_system *system, double speed);

/// Computes stiffness and damping of the bearings of a machine of bearings only (WHIRL_BEARINGS_ALONE) on stations of 1
/// kg, about the state x [dimension]: kxx, kxy, kyx, kyy in N/m and cxx, cxy, cyx, cyy in N s/m of all bearings at each
/// station, [probe_count][8]: forces are -k displacement - c velocity. WHIRL_BAD_INPUT for a system without a Jacobian;
/// WHIRL_NO_MEMORY.
whirl_status whirl_bearing_coefficients(const whirl_machine *alone, const double *x, double *coefficients);

/// Undamped critical speeds of a machine: speeds of the shaft at which a mode whirls once a revolution.
typedef struct whirl_critical_speeds {
    size_t dimension, count; ///< numbers of coordinates and of speeds
    double *speeds;          ///< [count] rad/s, rising; of equal ones forward whirl comes first
    double *directions;      ///< [count] direction of whirl as in whirl_mode
    double *vectors;         ///< [count][dimension][2] shapes, real and imaginary parts: displacements, then velocities
    size_t free;             ///< number of rigid-body modes, which have speed 0 and are left out
} whirl_critical_speeds;

/// Computes all critical speeds directly, of lateral modes. In M q'' - i w G q' + K q = 0 motions that turn with the
/// shaft are the roots of K q = w^2 (M - i G) q (Friswell, Penny, Garvey, Lees 2010). Damping is left out. G is the
/// change of velocity terms with the speed, taken from `faster`, the same machine at another speed. Modes with w^2 not
/// above 0 never meet the speed (thin discs). WHIRL_BAD_INPUT if the machine has no equilibrium, its stiffness depends
/// on the speed or is not symmetric, its coefficients turn with the shaft, it has other states than displacements and
/// velocities, or both speeds are equal. Freed by whirl_critical_speeds_free.
whirl_status whirl_critical_speeds_new(const whirl_machine *machine, const whirl_machine *faster,
                                       whirl_critical_speeds **speeds);

/// Finds unbalances that excite a mode (after API 617; check the edition that applies): on the shaft that moves most,
/// one in each stretch between two nodes of the shape, on the side given by the sign of the shape. It is at the station
/// of the stretch where it excites the mode most: the antinode, if the masses for the rule are equal. The moment of
/// each in kg m is `factor`, in m, times a mass in kg. Outside the outer bearings it is the overhanging mass; if the
/// shape has no node between the two bearings, the mass that both carry; else the mass that the nearest bearing
/// carries. Parts between nodes with less than a tenth of the largest displacement are skipped. shape [dimension][2];
/// statics [probe_count]; out [probe_count]. Returns their number.
size_t whirl_antinodes(const whirl_system *system, const double *shape, const whirl_station_statics *statics,
                       double factor, whirl_placed *out);

/// Frees critical speeds; accepts NULL.
void whirl_critical_speeds_free(whirl_critical_speeds *speeds);

#ifdef __cplusplus
}
#endif
#endif
