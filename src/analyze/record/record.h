/// Internal interfaces of recording: how motions are followed, watched, and stored.
#ifndef ANALYZE_RECORD_H
#define ANALYZE_RECORD_H

#include "section.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- archive
// Serialization: one description of a state's parts serves measuring, writing and reading.

typedef enum archive_way { ARCHIVE_MEASURE, ARCHIVE_WRITE, ARCHIVE_READ } archive_way;

typedef struct archive {
    archive_way way;
    unsigned char *bytes; ///< [size] written or read; NULL while measuring
    size_t size, at;
    bool sound; ///< false if the data read do not fit
} archive;

/// Processes `size` bytes of memory.
void archive_part(archive *a, void *memory, size_t size);

/// Processes a number that must be equal when it is read.
void archive_same(archive *a, double number);

/// Processes a count, at most `most` when it is read.
void archive_count(archive *a, size_t *count, size_t most);

// ---------------------------------------------------------------- settling
// Detection of motions that have settled on a periodic orbit, whose transient can then be cut short.

/// The last states of a section, and for every k how many revolutions in a row have returned after k.
typedef struct settling settling;

/// Makes one for motions of the system, which is borrowed: coordinates that turn do not count for returns. NULL without
/// memory. Freed by settling_free.
settling *settling_new(const whirl_system *system);
void settling_free(settling *settling);

/// Serializes its state.
void settling_archive(settling *settling, archive *a);

/// Adds the state x [dimension] at the end of a revolution. Returns the least k <= 128 after which the motion has
/// returned to 1e-11 of its size for three periods and 32 revolutions; 0 without one.
size_t settling_note(settling *settling, const double *x);

/// Returns the state [dimension] so many revolutions before the last one; NULL if it is not kept. 129 are kept.
const double *settling_state(const settling *settling, size_t back);

// ---------------------------------------------------------------- orbit_search
// Shooting: Newton's method on the map over k revolutions, for several motions side by side. Finds the orbits on which
// they settle, with all their multipliers.

/// A search for a motion's orbit; one block, freed by free.
typedef struct orbit_search {
    const whirl_system *system; ///< borrowed
    size_t dimension, kept;     ///< coordinates, and those that do not turn
    size_t revolutions;         ///< period of the orbit
    double *nodes;              ///< [revolutions][dimension] the states at the beginnings of its revolutions
    double *factors; ///< [revolutions][kept][kept] derivative of a revolution's end by its beginning, rows first
    whirl_multiplier *values; ///< [kept] multipliers by falling modulus
    double residual;          ///< distance by which it fails to close, over its largest coordinate
    double volume;            ///< sum of ln|multiplier| from the divergence; NaN if the system gives none
    double carried;           ///< revolutions that were computed, with all perturbations
    bool found;
    bool in_lane, done; ///< it is in a lane, or has ended
} orbit_search;

/// Makes a search from the state x [dimension], or one to be read (NULL). NULL without memory.
orbit_search *orbit_search_new(const whirl_system *system, size_t revolutions, const double *x);

/// Serializes the result; the search must be for the same system and period.
void orbit_search_archive(orbit_search *s, archive *a);

/// Computes the derivative of the map over all revolutions, matrix [kept][kept]; `room` has as many.
void orbit_search_monodromy(const orbit_search *s, double *matrix, double *room);

/// Computes the coordinates of x - node that do not turn: out [kept].
void orbit_search_difference(const orbit_search *s, const double *x, double *out);

/// Returns the Euclidean length of that difference.
double orbit_search_distance(const orbit_search *s, const double *x);

/// The ensemble that carries searches: machines of one structure, by their motions' method, with a tighter tolerance if
/// it has one.
typedef struct orbit_searches orbit_searches;

/// Makes one. WHIRL_BAD_INPUT if the system has no Jacobian, or the method does not carry perturbations. Freed by
/// orbit_searches_free.
whirl_status orbit_searches_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                orbit_searches **out);
void orbit_searches_free(orbit_searches *s);

/// Number of searches that run side by side.
size_t orbit_searches_lanes(const orbit_searches *s);

/// Runs the searches [count], including those in lanes, by full Newton steps from close starts, few of them, until
/// fewer than `least` >= 1 are left; the others are done. An orbit that closes after fewer revolutions, a divisor, gets
/// these. Searches in lanes must not be freed before they are done. WHIRL_NO_MEMORY.
whirl_status orbit_searches_run(orbit_searches *s, orbit_search *const *searches, size_t count, size_t least);

// ---------------------------------------------------------------- approach
// A motion's approach to a periodic orbit: when Newton's method is worth a try, and whether the motion itself reaches
// the orbit that was found. See docs/theory.md, "Orbits of settled motions".

typedef struct approach approach;

/// Makes one for motions of the system with these options. NULL without memory. Freed by approach_free.
approach *approach_new(const whirl_system *system, const whirl_integrate_options *integrate,
                       const whirl_record_options *options);
void approach_free(approach *a);

/// Serializes its state.
void approach_archive(approach *a, archive *to);

/// Returns the period of an orbit that may be near after `revolution` revolutions, given the last states; 0 if Newton's
/// method is not worth a try.
size_t approach_tries(approach *a, const settling *states, int revolution);

/// Takes the result of Newton's method from that state: the approach then owns *s. WHIRL_NO_MEMORY.
whirl_status approach_take(approach *a, orbit_search *s, const settling *states, int revolution);

/// Checks the last revolution, if an orbit is known. Called before approach_arrives.
void approach_goes_on(approach *a, const settling *states);

/// Returns true if the motion, at the start of the orbit's first revolution, is so near a stable orbit, and approaches
/// it as its multipliers predict, that it must settle on it.
bool approach_arrives(const approach *a, const settling *states);

/// Returns the orbit that was found last, NULL without one; owned by the approach.
orbit_search *approach_orbit(const approach *a);

/// Returns the revolutions that Newton's method has taken.
double approach_spent(const approach *a);

// ---------------------------------------------------------------- at_rest
// Detection of motions at rest at an equilibrium.

/// Searches the equilibrium of a recorded motion that hardly moves (record->rest). Does nothing for others. The only
/// error is WHIRL_NO_MEMORY.
whirl_status at_rest_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

// ---------------------------------------------------------------- orbits
// Orbits of settled motions, as a record reports them.

/// Returns true if a search for an orbit of k revolutions costs little compared with the motion itself, given that
/// Newton's method has already taken `spent` revolutions of it.
bool orbits_pay(size_t dimension, const whirl_record_options *options, size_t k, double spent);

/// Returns the revolutions after which the motion of a complete record returns; 0 if it does not, or if a search costs
/// too much.
size_t orbits_settled_period(const whirl_record *record, const whirl_record_options *options);

/// Notes in a record with known bounds the orbit that Newton's method found, or that it found none, at this distance
/// from the motion.
void orbits_record(whirl_record *record, const orbit_search *s, double distance);

// ---------------------------------------------------------------- record_block
// The memory of a record.

/// Returns the revolution at which a motion continues that has settled on P-`period` after `revolution` revolutions: it
/// skips the rest of the transient except the last 64 revolutions, or three periods if these are longer than 64.
int record_skip(const whirl_record_options *options, int revolution, size_t period);

/// Makes an empty record for a motion of the system, all zero. NULL without memory. Freed by whirl_record_free.
whirl_record *record_new(const whirl_system *system, const whirl_integrate_options *integrate,
                         const whirl_record_options *options);

/// Prepares the record of a motion on an orbit of k <= options->record revolutions, which are recorded at the end of
/// sections and waveforms.
void record_begin_orbit(whirl_record *record, const whirl_record_options *options, size_t k);

/// Fills the rest of the record, before means are scaled, by repeating these revolutions, and growths by the largest
/// multiplier of record->orbit.
void record_repeat_orbit(whirl_record *record, const whirl_record_options *options);

/// Returns the section so far. An angle is replaced by a point on a circle whose arcs are as long as the angles'
/// differences, so that states that differ by whole turns agree. Valid until the next call.
section record_points(const whirl_record *record);

/// Clears coordinates that turn from a complete record: they have no size and no place in the section.
void record_close_turns(whirl_record *record);

/// Serializes the options and sizes that a record's meaning depends on, and its content so far.
void record_archive(whirl_record *record, const whirl_integrate_options *integrate, const whirl_record_options *options,
                    archive *a);

/// Sets the initial perturbations [count][dimension]. A single one lies across all axes; the k-th of all is sin(k
/// theta_i), theta_i = pi i/(n + 1) for the i-th axis of n. They are orthonormal, and since sin(k theta)/sin(theta) are
/// polynomials of rising degree in cos(theta), any k axes see the first k of them as independent: even if the motion
/// decouples planes, or other groups of coordinates, the fastest growth comes first. Coordinates that turn have axes of
/// their own, the last: orthogonalized in turn, the others never mix with them.
void record_place_perturbations(const whirl_record *record, size_t count, double *perturbations);

// ---------------------------------------------------------------- steps
// Fixed steps that are too long for a motion, and their effect on its verdict.

/// Fills record->steps of a finished motion, by a few of its revolutions. Methods with a tolerance are skipped.
whirl_status steps_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

/// Corrects a verdict for steps that are too long: none if they are unstable or wrong, less confidence if they are
/// coarse.
void steps_weigh(whirl_verdict *verdict, const whirl_step_quality *steps);

/// Writes why steps leave a verdict undetermined; false if they do not.
bool steps_reason(const whirl_verdict *verdict, char *text, size_t size);

// ---------------------------------------------------------------- perturbed_copy
// A perturbation followed by a second trajectory.

/// A perturbed copy of a motion: a second trajectory close to the first, rescaled to its distance after every
/// revolution (Benettin et al. 1980).
typedef struct perturbed_copy {
    size_t dimension;
    const double *turns, *angles; ///< as in whirl_system: coordinates that turn are not perturbed
    double share;                 ///< relative to the state's size
    double least;                 ///< distance, in the state's units
    double distance;
    double range; ///< half the range of the motion over the first revolution that was followed; 0: not known yet
    double *x;    ///< NULL: no copy
} perturbed_copy;

/// Makes a perturbed copy at x, yet to be placed, for motions of these options. Steps of one-step methods are a smooth
/// function of the state: motion and copy have the same errors. CVODE's orders and steps have a history, so each motion
/// has errors of its own, and the copy is 10^4 tolerances away, which makes these errors a small part of the distance.
/// (Other methods would lose by it: a distance d adds errors of the order of d.)
perturbed_copy perturbed_copy_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x);

/// Places the copy next to the state x.
void perturbed_copy_begin(perturbed_copy *copy, const double *x);

/// Takes the extremes low, high [dimension] of the motion over a revolution: a state that is tiny at the section is no
/// size of the motion.
void perturbed_copy_size(perturbed_copy *copy, const double *low, const double *high);

/// Returns the natural logarithm of the growth since the last call, and rescales the copy's distance from x. `first`:
/// the call follows perturbed_copy_size, and the distance was chosen without the motion's range. If the distance is
/// lost in rounding or overflows, the growth is the limit of what can be resolved.
double perturbed_copy_growth(perturbed_copy *copy, const double *x, bool first, bool bounded);

#endif
