/// Linear analyses of a system about where it rests: equilibrium, modes, synchronous response.
///
/// A rotor rests where its right-hand side vanishes with the forcing held at zero amplitude (unbalance off; gravity and
/// films on). About it small motions follow its Jacobian; of one whose coefficients turn with the shaft (unequal
/// stiffness, cracks) the monodromy matrix of a periodic motion takes its place, by Floquet's theory, with the forcing
/// on. Coordinates that turn on and on (whirl_system.turns) are no part of it: forces are their mean over a turn.
#ifndef WHIRL_LINEAR_H
#define WHIRL_LINEAR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Carries x [dimension] from a start to the equilibrium, by damped Newton steps with the system's own Jacobian and,
/// where these do not get there at once, by bringing the load on in shares. A start that is one already stays as it is,
/// but for coordinates with a balance of their own (whirl_system.settle). WHIRL_NUMERICAL_FAILURE with a sentence where
/// none is found; WHIRL_BAD_INPUT where the system gives no Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_equilibrium(const whirl_system *system, double *x);

/// The share of the static load up to which whirl_equilibrium can follow the place of rest from a start [dimension]: 1
/// where it finds one, 0 also without memory.
double whirl_equilibrium_share(const whirl_system *system, const double *start);

/// What whirl_equilibrium brings to zero: the right-hand side at x [dimension] with the forcing at zero amplitude and
/// the mean over a turn of what turns on and on, slope [dimension], and its derivative by x, jacobian
/// [dimension][dimension]. 0 in the rows and columns of what turns. Errors as whirl_equilibrium.
whirl_status whirl_rest_slope(const whirl_system *system, const double *x, double *slope, double *jacobian);

/// The normal forces of all contacts there, force [contact_count], likewise their means; 0 of those that are open.
/// Errors as whirl_equilibrium.
whirl_status whirl_rest_contacts(const whirl_system *system, const double *x, double *force);

/// A mode: what goes like exp(lambda t), of the pair lambda and its conjugate the one with the positive imaginary part.
typedef struct whirl_mode {
    double real, imaginary; ///< of lambda, by the system's unit of time (rad of a rotor's clock)
    /// The whirl: twice the signed area of the orbits of all probes over their squared sizes. 1: circles with the
    /// rotation, from x to y; -1: against it; 0: to and fro, or one as much as the other.
    double direction;
} whirl_mode;

/// Modes with a larger damping ratio are overdamped: nobody sees them swing, and they have no name.
#define WHIRL_OVERDAMPED_RATIO 0.9

/// Returns true for a mode that dies out within less than a turn: a damping ratio above WHIRL_OVERDAMPED_RATIO.
bool whirl_mode_is_overdamped(const whirl_mode *mode);

/// Modes about an equilibrium, or of a periodic motion.
typedef struct whirl_modes {
    /// 0, or the period of coefficients that turn with the shaft: then lambda is a Floquet exponent, whose imaginary
    /// part is known modulo 2 pi over it and is given between 0 and half of that, and shapes are those at t = 0.
    double period;
    size_t dimension, count, real_count; ///< of the state, of the modes, of the real eigenvalues
    double *rest;                        ///< [dimension] the equilibrium, or where the periodic motion is at t = 0
    whirl_mode *modes;                   ///< [count] by rising imaginary part, overdamped ones behind the others
    double *vectors; ///< [count][dimension][2] their shapes, real and imaginary parts; 0 of what turns on and on
    double *reals;   ///< [real_count] eigenvalues without frequency, of overdamped motions, largest first
    /// The largest real part of all eigenvalues but zeros of what nothing holds: stable below 0, undamped at 0. A real
    /// part that is no more than rounding is 0.
    double growth;
    size_t free; ///< rigid-body modes: independent displacements that nothing holds, whose eigenvalues are 0
} whirl_modes;

/// The modes of a system, whose search for an equilibrium begins at start [dimension]. WHIRL_BAD_INPUT where none is
/// found, or coefficients turn with a phase that never fits revolutions. Freed by whirl_modes_free.
whirl_status whirl_modes_new(const whirl_system *system, const double *start, whirl_modes **modes);

/// A machine at any frequency of whirl (rad/s), to be released.
typedef struct whirl_whirling {
    whirl_status (*at)(const void *context, double frequency, whirl_machine *machine); ///< makes it
    const void *context;                                                               ///< handed to it; borrowed
} whirl_whirling;

/// The modes of a machine; of one whose coefficients depend on the frequency of whirl (whirl_system.frequencies) those
/// whose damped frequency is the frequency at which its coefficients are looked up, to 1e-12 of it, from the first to
/// the last of these; eigenvalues without frequency where that is 0, and none where it is not known there. growth is
/// NaN where there are neither. The machine is then looked at through `others`. Errors as whirl_modes_new and those of
/// machines.
whirl_status whirl_modes_of(const whirl_machine *machine, const whirl_whirling *others, whirl_modes **modes);

/// The largest modulus of the sensitivity functions of a system's loops of control (ISO 14839-3) about an equilibrium,
/// rest [dimension]: S of a loop is its sensor's signal over a signal that is added to it, all loops closed, in place
/// of their own 1. With the modes about it, near whose frequencies it is looked for.
typedef struct whirl_sensitivity_peak {
    double peak;      ///< NaN without loops
    double frequency; ///< by the system's unit of time
    size_t loop;      ///< which of them
} whirl_sensitivity_peak;

/// Finds it. WHIRL_NO_MEMORY.
whirl_status whirl_loops_peak(const whirl_system *system, const whirl_modes *modes, whirl_sensitivity_peak *out);

/// Frees modes; NULL is none.
void whirl_modes_free(whirl_modes *modes);

/// Which mode of `to` each of `from` has become, partner [from->count], SIZE_MAX where there is none left: by
/// likeness of shapes (modal assurance criterion, Allemang, Brown 1982) and nearness of eigenvalues, with those of
/// `from` times `scale` (where the units of time differ). unlike [from->count], or NULL: how unlike each is to its
/// partner, 0 where they are one, 1 and more where they have nothing in common. WHIRL_NO_MEMORY.
whirl_status whirl_modes_match(const whirl_modes *from, const whirl_modes *to, double scale, size_t *partner,
                               double *unlike);

/// The motion x = rest + Re(X exp(i 2 pi t / period)) in which small forcing once a revolution ends: rest [dimension],
/// response [dimension][2] X. Of a system whose coefficients turn with the shaft: the periodic motion itself, its mean
/// and its first harmonic. Errors as whirl_modes_new, and where the response is beyond all bounds.
whirl_status whirl_forced_response(const whirl_system *system, const double *start, double *rest, double *response);

/// WHIRL_BAD_INPUT with a sentence where coefficients of a machine depend on the frequency of whirl and are not known
/// at that of its shaft, which turns at a speed (rad/s, either way).
whirl_status whirl_synchronous_check(const whirl_system *system, double speed);

/// Stiffness and damping of the bearings of a machine that has nothing else (WHIRL_BEARINGS_ALONE) on stations of 1 kg,
/// about the state x [dimension]: kxx, kxy, kyx, kyy in N/m and cxx, cxy, cyx, cyy in N s/m of all bearings at each
/// station, [probe_count][8]: forces are -k displacement - c velocity. WHIRL_BAD_INPUT for a system without a Jacobian;
/// WHIRL_NO_MEMORY.
whirl_status whirl_bearing_coefficients(const whirl_machine *alone, const double *x, double *coefficients);

/// The critical speeds of a machine without damping: speeds of the shaft at which a mode goes round once a revolution.
typedef struct whirl_critical_speeds {
    size_t dimension, count; ///< of the state; of the speeds
    double *speeds;          ///< [count] rad/s, rising; of equal ones forward whirl comes first
    double *directions;      ///< [count] of the whirl, as whirl_mode has it
    double *vectors; ///< [count][dimension][2] shapes, real and imaginary parts, of places and, over them, rates
    size_t free;     ///< rigid-body modes, whose speed is 0 and which are left out
} whirl_critical_speeds;

/// Finds all critical speeds at once, without a search: of M q'' - i w G q' + K q = 0 with motions that turn with the
/// shaft they are the roots of K q = w^2 (M - i G) q (Friswell, Penny, Garvey, Lees 2010), where damping is left
/// out and G is what rates gain by the speed, so that `faster` is the same machine at another speed. Modes whose w^2 is
/// not above 0 never meet the speed (discs that are thin). WHIRL_BAD_INPUT where the machine rests nowhere, its
/// stiffness changes with the speed or is not symmetric, its coefficients turn with the shaft, it has states other than
/// places and rates, or both speeds are the same. Freed by whirl_critical_speeds_free.
whirl_status whirl_critical_speeds_new(const whirl_machine *machine, const whirl_machine *faster,
                                       whirl_critical_speeds **speeds);

/// Unbalances that excite a mode (after API 617; which edition counts is for the user to check): on the shaft that
/// moves most, one between any two nodes of the shape, to one side or to the other by its sign, at the station where it
/// excites the mode most: at the antinode, as far as the masses that follow are the same. Each is `factor` kg m times a
/// mass in kg: beyond the outer bearings what hangs over there; where the shape has no node between two bearings what
/// both carry; else what the nearest one carries. Parts between nodes where it moves less than a tenth of the most
/// count for none. shape [dimension][2]; statics [probe_count]; out [probe_count]; how many.
size_t whirl_antinodes(const whirl_system *system, const double *shape, const whirl_station_statics *statics,
                       double factor, whirl_placed *out);

/// Frees them; NULL is none.
void whirl_critical_speeds_free(whirl_critical_speeds *speeds);

#ifdef __cplusplus
}
#endif
#endif
