/// Torsion of a machine: harmonic torques that excite it, and parts that carry torque from station to station.
#ifndef WHIRL_TORSION_H
#define WHIRL_TORSION_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

struct whirl_system;

/// Kinds of parts with a torque. Result files store these numbers.
typedef enum whirl_torque_kind {
    WHIRL_TORQUE_BETWEEN,           ///< a shaft, coupling or spring between two twists
    WHIRL_TORQUE_INDUCTION_MOTOR,   ///< a motor at a station; this kind and the next three occur in run-ups only
    WHIRL_TORQUE_SYNCHRONOUS_START, ///< a synchronous motor that starts, at a station
    WHIRL_TORQUE_SHORT_CIRCUIT,     ///< a short circuit, at a station
    WHIRL_TORQUE_TIMED,             ///< a torque that is a given function of time, at a station
    WHIRL_TORQUE_MESH,              ///< a mesh with stiffness: the torque on its first gear
    WHIRL_TORQUE_RIGID_GEAR,        ///< a rigid pair of gears: the torque on its first gear
    WHIRL_TORQUE_WITH_PLAY,         ///< a spring with play between two twists
    WHIRL_TORQUE_KINDS
} whirl_torque_kind;

/// All harmonic torques of one frequency.
typedef struct whirl_excitation {
    bool fixed;       ///< the frequency does not depend on the speed
    double order;     ///< frequency over the speed of the rotor
    double frequency; ///< rad/s
} whirl_excitation;

/// A path of torque between two stations (a shaft, a gear, a spring). Torques are positive where the first station
/// drives the second along the rotation; those of gears act on the first one, from the second.
typedef struct whirl_torque_path {
    whirl_torque_kind kind; ///< kind of the part that carries it
    size_t station[2];      ///< probes; the number of probes: a node between stations, or the ground
    double modulus; ///< m3, of a shaft's weakest section against torsion: shear stress is torque over it; 0: unknown
} whirl_torque_path;

/// An S-N curve of the torque in a path, as whirl_signals_damage takes it: ranges peak to peak, N m.
typedef struct whirl_torque_curve {
    size_t count;                  ///< points of the curve
    double ranges[WHIRL_MAX_LIST]; ///< [count] N m
    double lives[WHIRL_MAX_LIST];  ///< [count] cycles to failure
    double slope;                  ///< slope of a curve of one point: N = lives[0] (ranges[0]/range)^slope
    double endurance;              ///< N m; ranges below it do no damage; 0: no such limit
} whirl_torque_curve;

/// Functions of a machine whose stations twist. `rest`: the state [dimension] about which it moves.
typedef struct whirl_torsion {
    size_t excitation_count; ///< number of excitations
    size_t path_count;       ///< number of paths

    /// Describes excitation `index`, the torques of one frequency at any stations.
    void (*excitation)(const void *model, size_t index, whirl_excitation *out);

    /// Checks that the torques are known at this speed. WHIRL_BAD_INPUT names the element's station and its table.
    whirl_status (*check)(const void *model);

    /// Writes the slopes [dimension][2] that the torques of an excitation add to the equations at rest, Re(slope exp(i
    /// w t)) with the system's t. index = excitation_count: the steady torques (imaginary parts 0).
    void (*drive)(const void *model, size_t index, double *slope);

    /// Returns the sum of all steady torques, N m referred to the rotor's speed; 0 if a motor takes up the sum. Writes
    /// the sum of their absolute values to `size`.
    double (*unbalanced)(const void *model, double *size);

    /// Writes the rigid rotation of all stations that twist [dimension], of any size; 0 for other coordinates.
    void (*turn)(const void *model, double *turn);

    /// Describes path `index`.
    void (*path)(const void *model, size_t index, whirl_torque_path *out);

    /// Writes the S-N curve of a path's torque, converted from the S-N curve of its shear stress by the section.
    /// Returns false if there is none.
    bool (*curve)(const void *model, size_t path, whirl_torque_curve *out);

    /// Finds the amplitude of the torque in a path, N m, in the motion rest + Re(v exp(i w t)), v [dimension][2], that
    /// an excitation drives: torque [2] real and imaginary part, NaN where it is not known; power: W, the mean power
    /// that the path's damping dissipates. index = excitation_count: v is the displacement by steady torques, and the
    /// torque includes the steady torque at `rest`.
    void (*carry)(const void *model, size_t path, size_t index, const double *rest, const double *v, double torque[2],
                  double *power);

    /// Returns the name of the station of a mesh or spring that rests within its play and so carries no torque; NULL if
    /// there is none.
    const char *(*open)(const void *model, const double *rest);

    /// Returns true if a station twists.
    bool (*twists)(const void *model, size_t station);

    /// Returns the speed of a station in the rigid rotation, rad/s; for a station that does not twist, the speed of the
    /// rotor.
    double (*speed)(const void *model, size_t station);
} whirl_torsion;

/// Computes the response Re(response exp(i w t)), w = `frequency` in the system's unit of time, to the slopes drive
/// [dimension][2] about rest [dimension]. WHIRL_BAD_INPUT for an unbounded response, coefficients that turn with the
/// shaft, or a system without a Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_harmonic_response(const struct whirl_system *system, const double *rest, double frequency,
                                     const double *drive, double *response);

/// Computes the displacement by constant slopes drive [dimension] about rest [dimension]; if nothing resists the rigid
/// rotation turn [dimension], the displacement that has no part along this rotation. Errors as whirl_harmonic_response.
whirl_status whirl_static_response(const struct whirl_system *system, const double *rest, const double *turn,
                                   const double *drive, double *response);

#ifdef __cplusplus
}
#endif
#endif
