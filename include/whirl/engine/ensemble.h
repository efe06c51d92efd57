/// Ensembles: many machines of one structure, carried over revolutions side by side in vector lanes: by rk4 step by
/// step together, by dop853 and rodas5p each at its own time; or of any system and method, one after the other.
///
/// Every lane is computed as if it were alone: its neighbours, its place, the number of lanes and the width of the
/// vectors change no bit of it, on processors that fuse multiply-adds (and on those that do not, among themselves).
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

/// Whether machines of this system can run in lanes with these options: rotors, with method dop853 or rodas5p, or rk4
/// unless contacts are located that can slide along a sharp reversal of their friction.
bool whirl_ensemble_takes(const whirl_system *system, const whirl_integrate_options *options);

/// Room for at least `lanes` machines of the structure of `system`, which must outlive the ensemble (0: as many as are
/// fast). The instruction set is the widest that the processor has, or the one that the environment variable WHIRL_ISA
/// names (scalar, simd128, fma, avx2, avx512; WHIRL_BAD_INPUT where it is not there). Other errors as
/// whirl_integrator_new. Freed by whirl_ensemble_free.
whirl_status whirl_ensemble_new(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                whirl_ensemble **ensemble);

/// Frees an ensemble; NULL is none.
void whirl_ensemble_free(whirl_ensemble *ensemble);

/// Room for `lanes` (at least 1) machines of any method and of any system with as many coordinates, probes and contacts
/// as this one, which must outlive the ensemble: integrators carry them one after the other, and `followed`
/// perturbations of each (0 to the dimension) along with it. A machine has to outlive its stay in a lane. Errors as
/// whirl_integrator_new; that of an unknown method and those of whirl_integrator_follow are told by
/// whirl_ensemble_load.
whirl_status whirl_ensemble_alone(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                  size_t followed, whirl_ensemble **ensemble);

/// Whether all perturbations of machines of this system can go along in lanes with these options: rotors of up to 256
/// coordinates whose forces do not jump, by rk4 that does not locate contacts. All others go alone.
bool whirl_ensemble_follows(const whirl_system *system, const whirl_integrate_options *options);

/// As whirl_ensemble_new, with room for as many machines as are fast, and for all perturbations of each.
whirl_status whirl_ensemble_variational(const whirl_system *system, const whirl_integrate_options *options,
                                        whirl_ensemble **ensemble);

/// Whether parts of the period go in lanes, with perturbations: rotors of up to 256 coordinates by dop853.
bool whirl_ensemble_flows(const whirl_system *system, const whirl_integrate_options *options);

/// As whirl_ensemble_new, for at least `lanes` (at least 1) machines that each go over a part of the period of their
/// own, with room for `followed` perturbations of each (0 to the dimension).
whirl_status whirl_ensemble_flow(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                 size_t followed, whirl_ensemble **ensemble);

/// Lets the revolutions of a lane of the last one begin at `from` and be that long, whatever became of its motion
/// before; at first they are whole periods.
void whirl_ensemble_part(whirl_ensemble *ensemble, size_t lane, double from, double length);

/// Lets perturbations go along with a lane of one of the last three in the next revolution, as whirl_integrator_carry
/// has them; of whirl_ensemble_variational, all of them, those of all lanes with growth or all without; of
/// whirl_ensemble_flow, as many as there is room for, without. They belong to the caller.
void whirl_ensemble_carry(whirl_ensemble *ensemble, size_t lane, whirl_perturbations *perturbations);

/// Lanes that there are: those asked for, rounded up to whole vectors.
size_t whirl_ensemble_lanes(const whirl_ensemble *ensemble);

/// Name of the instruction set in use. Static text.
const char *whirl_ensemble_isa(const whirl_ensemble *ensemble);

/// Returns whether two machines have the same structure, so that one ensemble takes both: the same stations and
/// elements with the same laws and, where masses are coupled (finite elements, fluid inertia), the same masses. Of
/// systems without kernels: the same numbers of coordinates, probes and contacts.
bool whirl_ensemble_alike(const whirl_system *one, const whirl_system *other);

/// Checks that a machine has as many coordinates, probes and contacts as the first one of its study, which is what
/// points of one study must share. WHIRL_BAD_INPUT where it has others, with both sets of numbers.
whirl_status whirl_ensemble_check(const whirl_system *first, const whirl_system *other);

/// Puts a machine into a lane, in the state x [dimension]. WHIRL_BAD_INPUT when it is not of the ensemble's structure.
/// The system must outlive its stay, to the next load, unload or move: contacts are asked of it.
whirl_status whirl_ensemble_load(whirl_ensemble *ensemble, size_t lane, const whirl_system *system, const double *x);

/// Empties a lane. What a lane without a machine holds means nothing until one is loaded.
void whirl_ensemble_unload(whirl_ensemble *ensemble, size_t lane);

/// Sets the state x [dimension] of a lane.
void whirl_ensemble_place(whirl_ensemble *ensemble, size_t lane, const double *x);

/// Gives the state x [dimension] of a lane.
void whirl_ensemble_state(const whirl_ensemble *ensemble, size_t lane, double *x);

/// Moves a machine with its state and all that was observed of it to another lane, whose own is lost; the lane that it
/// leaves is empty.
void whirl_ensemble_move(whirl_ensemble *ensemble, size_t from, size_t to);

/// How many numbers a lane has between revolutions, observed ones included.
size_t whirl_ensemble_numbers(const whirl_ensemble *ensemble);

/// Saves them: numbers [whirl_ensemble_numbers].
void whirl_ensemble_save(const whirl_ensemble *ensemble, size_t lane, double *numbers);

/// Restores them into a lane that the same machine was loaded into, of an ensemble with the same options.
void whirl_ensemble_restore(whirl_ensemble *ensemble, size_t lane, const double *numbers);

/// Bounded, diverged by the options' limit, or stuck where an adaptive method could not go on.
whirl_motion whirl_ensemble_motion(const whirl_ensemble *ensemble, size_t lane);

/// What revolutions shall gather besides the states at their ends.
typedef struct whirl_ensemble_observe {
    bool extremes; ///< gather what whirl_ensemble_seen gives, for all lanes
    /// Called after every `stride` steps (0: never), for samples of waveforms.
    size_t stride;
    void (*sample)(void *context); ///< sees the ensemble as it is then
    void *context;                 ///< handed to sample; borrowed
    /// [count] the lanes that are observed: of the others nothing is gathered, or what means nothing, and by adaptive
    /// methods it then costs nothing. NULL: all.
    const bool *lanes;
} whirl_ensemble_observe;

/// Carries the lanes 0 to count - 1 over one period. Empty lanes among them are left alone. `observe` may be NULL.
void whirl_ensemble_revolve(whirl_ensemble *ensemble, size_t count, const whirl_ensemble_observe *observe);

/// One coordinate of all lanes [lanes], for samples. It belongs to the ensemble and always shows the present.
const double *whirl_ensemble_coordinate(const whirl_ensemble *ensemble, size_t index);

/// Forgets what was observed of a lane; contacts that are closed now do not count as begun.
void whirl_ensemble_forget(whirl_ensemble *ensemble, size_t lane);

/// What was observed of a lane since it was last forgotten, as it is folded: means are sums over the instants, and what
/// instants give as squares is squares still, until whirl_seen_end. The arrays belong to the caller; NULL: not wanted.
typedef struct whirl_ensemble_seen {
    double *low, *high; ///< [dimension] bounds of every coordinate; rk4: of velocities at every fourth step
    WHIRL_WATCHED_ARRAYS
} whirl_ensemble_seen;

/// Writes what was observed of a lane into the arrays of `seen`.
void whirl_ensemble_read(const whirl_ensemble *ensemble, size_t lane, const whirl_ensemble_seen *seen);

/// The same of a motion that the caller follows: nothing is seen of it yet, and contacts that are closed at x
/// [dimension] do not count as begun. All arrays are needed; `touching` [contact_count], the caller's, holds which
/// contacts are closed.
void whirl_seen_begin(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen, double *touching);

/// Adds an instant.
void whirl_seen_instant(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen, double *touching);

/// Makes means of sums over so many instants, and roots of squares. No array is NULL.
void whirl_seen_end(const whirl_system *system, size_t instants, const whirl_ensemble_seen *seen);

#ifdef __cplusplus
}
#endif
#endif
