/// Ensembles: many machines of one structure, carried over revolutions in vector lanes: by rk4 in common steps, by
/// dop853 and rodas5p each at its own time. An ensemble for any system and method carries its machines one after the
/// other.
///
/// Each lane is computed as if it were alone: its neighbours, its place, the number of lanes and the width of the
/// vectors change no bit of it, on processors with fused multiply-adds (and among those without).
#ifndef WHIRL_ENSEMBLE_H
#define WHIRL_ENSEMBLE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/system.h"
#include "whirl/engine/watched.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// An ensemble with its workspace; not to be shared between threads.
typedef struct whirl_ensemble whirl_ensemble;

/// Returns true if machines of this system can run in lanes with these options: rotors, by dop853 or rodas5p, or by rk4
/// unless it locates contacts that can slide along a sharp reversal of their friction.
bool whirl_ensemble_takes(const whirl_system *system, const whirl_integrate_options *options);

/// Creates an ensemble of at least `lanes` machines of the structure of `system`, which must outlive it (0: the fastest
/// number). The instruction set is the widest of the processor, or the environment variable WHIRL_ISA names one
/// (scalar, simd128, fma, avx2, avx512; WHIRL_BAD_INPUT if the processor lacks it). Other errors as
/// whirl_integrator_new. Freed by whirl_ensemble_free.
whirl_status whirl_ensemble_new(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                whirl_ensemble **ensemble);

/// Frees an ensemble; accepts NULL.
void whirl_ensemble_free(whirl_ensemble *ensemble);

/// Creates an ensemble of `lanes` (at least 1) machines, of any method and of any system with the same numbers of
/// coordinates, probes and contacts as this one, which must outlive it. Integrators carry the machines one after the
/// other, with `followed` perturbations of each (0 to the dimension). A machine must outlive its stay in a lane. Errors
/// as whirl_integrator_new; whirl_ensemble_load reports an unknown method and the errors of whirl_integrator_follow.
whirl_status whirl_ensemble_alone(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                  size_t followed, whirl_ensemble **ensemble);

/// Returns true if lanes can carry all perturbations of machines of this system with these options: rotors of up to 256
/// coordinates with continuous forces, by rk4 that does not locate contacts.
bool whirl_ensemble_follows(const whirl_system *system, const whirl_integrate_options *options);

/// Creates an ensemble as whirl_ensemble_new, with the fastest number of lanes, and all perturbations of each machine.
whirl_status whirl_ensemble_variational(const whirl_system *system, const whirl_integrate_options *options,
                                        whirl_ensemble **ensemble);

/// Returns true if lanes can carry machines, with perturbations, over parts of the period: rotors of up to 256
/// coordinates by dop853.
bool whirl_ensemble_flows(const whirl_system *system, const whirl_integrate_options *options);

/// Creates an ensemble as whirl_ensemble_new, of at least `lanes` (at least 1) machines, with `followed` perturbations
/// of each (0 to the dimension), by dop853, or by rodas5p without perturbations. Each machine is carried over its own
/// part of the period (whirl_ensemble_part).
whirl_status whirl_ensemble_flow(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                 size_t followed, whirl_ensemble **ensemble);

/// Sets the part of the period, from `from` on and of that length, that a lane of whirl_ensemble_flow goes over, and
/// clears the state of its motion. The default is the whole period.
void whirl_ensemble_part(whirl_ensemble *ensemble, size_t lane, double from, double length);

/// Carries perturbations with a lane in the next revolution, as whirl_integrator_carry does. The ensemble must be of
/// whirl_ensemble_alone, whirl_ensemble_variational (all perturbations, with growth in all lanes or in none) or
/// whirl_ensemble_flow (as many perturbations as were allocated, without growth). The perturbations belong to the
/// caller.
void whirl_ensemble_carry(whirl_ensemble *ensemble, size_t lane, whirl_perturbations *perturbations);

/// Returns the number of lanes: the number asked for, rounded up to whole vectors.
size_t whirl_ensemble_lanes(const whirl_ensemble *ensemble);

/// Returns the name of the instruction set in use. Static text.
const char *whirl_ensemble_isa(const whirl_ensemble *ensemble);

/// Returns true if two machines have the same structure, so that one ensemble takes both: the same stations and
/// elements with the same laws and, if masses are coupled (finite elements, fluid inertia), the same masses. For
/// systems without kernels: the same numbers of coordinates, probes and contacts.
bool whirl_ensemble_alike(const whirl_system *one, const whirl_system *other);

/// Checks that a machine has as many coordinates, probes and contacts as the first one of its study, as all points of a
/// study must. WHIRL_BAD_INPUT with both sets of numbers if not.
whirl_status whirl_ensemble_check(const whirl_system *first, const whirl_system *other);

/// Loads a machine into a lane, in the state x [dimension]. WHIRL_BAD_INPUT if it has another structure than the
/// ensemble. The system must live until the next load, unload or move: its contacts are evaluated.
whirl_status whirl_ensemble_load(whirl_ensemble *ensemble, size_t lane, const whirl_system *system, const double *x);

/// Empties a lane. The numbers of an empty lane are meaningless.
void whirl_ensemble_unload(whirl_ensemble *ensemble, size_t lane);

/// Sets the state x [dimension] of a lane.
void whirl_ensemble_place(whirl_ensemble *ensemble, size_t lane, const double *x);

/// Reads the state x [dimension] of a lane.
void whirl_ensemble_state(const whirl_ensemble *ensemble, size_t lane, double *x);

/// Moves a machine with its state and everything observed of it to another lane, whose machine is lost; the lane that
/// it leaves is empty.
void whirl_ensemble_move(whirl_ensemble *ensemble, size_t from, size_t to);

/// Returns the count of numbers of a lane between revolutions, observed ones included.
size_t whirl_ensemble_numbers(const whirl_ensemble *ensemble);

/// Saves the numbers of a lane: numbers [whirl_ensemble_numbers].
void whirl_ensemble_save(const whirl_ensemble *ensemble, size_t lane, double *numbers);

/// Restores the numbers into a lane with the same machine, of an ensemble with the same options.
void whirl_ensemble_restore(whirl_ensemble *ensemble, size_t lane, const double *numbers);

/// Returns the outcome of a lane: bounded, diverged by the options' limit, or stuck if an adaptive method could not
/// continue.
whirl_motion whirl_ensemble_motion(const whirl_ensemble *ensemble, size_t lane);

/// Observations of revolutions, in addition to the states at their ends.
typedef struct whirl_ensemble_observe {
    bool extremes; ///< observe the extremes of whirl_ensemble_seen in all lanes
    /// Steps between calls of `sample`, for samples of waveforms; 0: no calls.
    size_t stride;
    void (*sample)(void *context); ///< called at each sample; it may read the ensemble
    void *context;                 ///< passed to sample; borrowed
    /// [count] the observed lanes; NULL: all. Other lanes have no or meaningless observations, which cost nothing with
    /// adaptive methods.
    const bool *lanes;
} whirl_ensemble_observe;

/// Carries the lanes 0 to count - 1 over one period; empty lanes are skipped. `observe` may be NULL.
void whirl_ensemble_revolve(whirl_ensemble *ensemble, size_t count, const whirl_ensemble_observe *observe);

/// Returns one coordinate of all lanes [lanes], for samples. The ensemble owns the array and keeps it current.
const double *whirl_ensemble_coordinate(const whirl_ensemble *ensemble, size_t index);

/// Clears the observations of a lane; contacts that are closed now do not count as begun.
void whirl_ensemble_forget(whirl_ensemble *ensemble, size_t lane);

/// Observations of a lane since they were last cleared, before whirl_seen_end: means are still sums over the instants,
/// and squares have no root yet. The arrays belong to the caller; NULL: not wanted.
typedef struct whirl_ensemble_seen {
    double *low, *high; ///< [dimension] bounds of every coordinate; rk4: of velocities at every fourth step
    WHIRL_WATCHED_ARRAYS
} whirl_ensemble_seen;

/// Writes the observations of a lane into the arrays of `seen`.
void whirl_ensemble_read(const whirl_ensemble *ensemble, size_t lane, const whirl_ensemble_seen *seen);

/// Starts observations of a motion that the caller computes: none yet, and contacts that are closed at x [dimension] do
/// not count as begun. All arrays are required. `touching` [contact_count] is the caller's, and holds which contacts
/// are closed.
void whirl_seen_begin(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen, double *touching);

/// Adds an instant to the observations.
void whirl_seen_instant(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen, double *touching);

/// Finishes observations over this number of instants: divides sums to means, and takes roots of squares. No array is
/// NULL.
void whirl_seen_end(const whirl_system *system, size_t instants, const whirl_ensemble_seen *seen);

#ifdef __cplusplus
}
#endif
#endif
