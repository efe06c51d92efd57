/// What the parts of a record have of one another: how motions are followed, watched, and kept.
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
// Memory as bytes and back: one description of what belongs to a state serves measuring, writing and reading it.

typedef enum archive_way { ARCHIVE_MEASURE, ARCHIVE_WRITE, ARCHIVE_READ } archive_way;

typedef struct archive {
    archive_way way;
    unsigned char *bytes; ///< [size] written or read; NULL while measuring
    size_t size, at;
    bool sound; ///< false when what is read does not fit
} archive;

/// Goes on over `size` bytes of memory.
void archive_part(archive *a, void *memory, size_t size);

/// ... over a number that must be the same when it is read.
void archive_same(archive *a, double number);

/// ... over a count, at most `most` when it is read.
void archive_count(archive *a, size_t *count, size_t most);

// ---------------------------------------------------------------- settling
// Whether a motion has settled on a periodic orbit: then the rest of its transient teaches nothing.

/// The last states of a section, and for every k how many revolutions in a row have returned after k.
typedef struct settling settling;

/// Of motions of the system, which is borrowed: what turns has no part in returns. NULL without memory. Freed by
/// settling_free.
settling *settling_new(const whirl_system *system);
void settling_free(settling *settling);

/// Goes over its state.
void settling_archive(settling *settling, archive *a);

/// Takes the state x [dimension] at the end of a revolution. The least k <= 128 after which the motion has returned to
/// 1e-11 of its size for three periods and 32 revolutions; 0: none.
size_t settling_note(settling *settling, const double *x);

/// The state [dimension] so many revolutions before the last one; NULL where it is no longer, or was never, there. 129
/// are kept.
const double *settling_state(const settling *settling, size_t back);

// ---------------------------------------------------------------- shots
// Newton's method on the map over k revolutions, for several motions side by side: the orbits on which they come to
// rest, with all their multipliers.

/// A motion on its way onto an orbit; one block, freed by free.
typedef struct shot {
    const whirl_system *system; ///< borrowed
    size_t dimension, kept;     ///< coordinates, and those that do not turn on and on
    size_t revolutions;         ///< after which the orbit closes
    double *nodes;              ///< [revolutions][dimension] the states at the beginnings of its revolutions
    double *factors;            ///< [revolutions][kept][kept] the derivatives of their ends by these, rows first
    whirl_multiplier *values;   ///< [kept] multipliers by falling modulus
    double residual;            ///< by which it fails to close, over its largest coordinate
    double volume;              ///< sum of ln|multiplier| by the divergence; NaN where the system gives none
    double carried;             ///< revolutions that were computed, with all perturbations
    bool found;
    bool flies, done; ///< it is under way, or has come to its end
} shot;

/// A shot from the state x [dimension], or for one that is read (NULL); NULL without memory.
shot *shot_new(const whirl_system *system, size_t revolutions, const double *x);

/// Goes over what was found; the shot was made for the same system and as many revolutions.
void shot_archive(shot *s, archive *a);

/// The derivative of the map over all revolutions, matrix [kept][kept]; `room` has as many.
void shot_monodromy(const shot *s, double *matrix, double *room);

/// The coordinates of x - node that do not turn: out [kept].
void shot_difference(const shot *s, const double *x, double *out);

/// Their Euclidean length.
double shot_distance(const shot *s, const double *x);

/// Where shots are carried: machines of one structure, by the method that their motions go by, more exactly where that
/// has a tolerance.
typedef struct shooter shooter;

/// WHIRL_BAD_INPUT where the system gives no Jacobian, or the method takes no perturbations along. Freed by
/// shooter_free.
whirl_status shooter_new(const whirl_system *system, const whirl_integrate_options *integrate, shooter **out);
void shooter_free(shooter *s);

/// How many shots go side by side.
size_t shooter_lanes(const shooter *s);

/// Takes shots [count], those that fly among them, towards their orbits from starts that are close, by full steps, few
/// of them, until fewer than `least` >= 1 are left: those that have come to their end are done. Where one closes after
/// fewer revolutions that divide its own, it has these. What flies must not be freed before it is done.
/// WHIRL_NO_MEMORY.
whirl_status shooter_fire(shooter *s, shot *const *shots, size_t count, size_t least);

// ---------------------------------------------------------------- approach
// A motion on its way to a periodic orbit: when Newton's method is worth a try, and whether the motion itself reaches
// the orbit that was found. See docs/theory.md, "Orbits of settled motions".

typedef struct approach approach;

/// For motions of the system that go by these options; NULL without memory. Freed by approach_free.
approach *approach_new(const whirl_system *system, const whirl_integrate_options *integrate,
                       const whirl_record_options *options);
void approach_free(approach *a);

/// Goes over its state.
void approach_archive(approach *a, archive *to);

/// After `revolution` revolutions, the last states of which `states` has: of how many revolutions an orbit may be
/// near, 0 where Newton's method is not worth a try.
size_t approach_tries(approach *a, const settling *states, int revolution);

/// Takes what Newton's method made of that state: *s belongs to the approach from then on. Errors: WHIRL_NO_MEMORY.
whirl_status approach_take(approach *a, shot *s, const settling *states, int revolution);

/// Before the next revolution's end is looked at: what that was, where an orbit is known.
void approach_goes_on(approach *a, const settling *states);

/// Whether the motion, at the beginning of the orbit's first revolution now, has come so near to a stable orbit, by a
/// way that its multipliers foretell, that it cannot but come to rest on it.
bool approach_arrives(const approach *a, const settling *states);

/// The orbit that was found last, NULL where there is none; it belongs to the approach.
shot *approach_orbit(const approach *a);

/// Revolutions that Newton's method has taken.
double approach_spent(const approach *a);

// ---------------------------------------------------------------- at_rest
// Whether a motion has come to rest at an equilibrium.

/// Looks for the equilibrium of a recorded motion that hardly moves (record->rest). Does nothing for others.
/// WHIRL_NO_MEMORY alone is an error.
whirl_status at_rest_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

// ---------------------------------------------------------------- orbits
// The orbits of settled motions: what a record says of them.

/// Whether a search for an orbit of k revolutions costs little beside the motion itself, where Newton's method has
/// taken `spent` revolutions of it before.
bool orbits_pay(size_t dimension, const whirl_record_options *options, size_t k, double spent);

/// After how many revolutions the motion of a complete record returns; 0 where it does not, or a search does not pay.
size_t orbits_settled_period(const whirl_record *record, const whirl_record_options *options);

/// Tells a record whose bounds are known of the orbit that Newton's method found, or did not, at this distance from the
/// motion.
void orbits_tell(whirl_record *record, const shot *s, double distance);

// ---------------------------------------------------------------- record_block
// The memory of a record.

/// Where a motion that has settled on P-`period` after `revolution` revolutions goes on: it leaves out what is left of
/// the transient but for the last 64 revolutions, or as many as three of a period beyond 64 need.
int record_skip(const whirl_record_options *options, int revolution, size_t period);

/// An empty record for a motion of the system, all zero; NULL without memory. Freed by whirl_record_free.
whirl_record *record_new(const whirl_system *system, const whirl_integrate_options *integrate,
                         const whirl_record_options *options);

/// A motion was set upon an orbit of k <= options->record revolutions: what is recorded of these stands at the end of
/// sections and waveforms.
void record_begin_orbit(whirl_record *record, const whirl_record_options *options, size_t k);

/// Fills the rest of them, before means are scaled, with these revolutions again and again, and growths by the
/// largest multiplier of record->orbit.
void record_repeat_orbit(whirl_record *record, const whirl_record_options *options);

/// What the section holds so far: where coordinates are angles, with the points of circles in their places, whose arcs
/// are as long as the angles' differences. States that differ by whole turns are the same there. Valid until the next
/// call.
section record_points(const whirl_record *record);

/// Coordinates that turn on and on have no size and no place in the section, once the record is complete.
void record_close_turns(whirl_record *record);

/// Goes over the options and sizes that a record's meaning depends on, and over what it has gathered so far.
void record_archive(whirl_record *record, const whirl_integrate_options *integrate, const whirl_record_options *options,
                    archive *a);

/// Perturbations [count][dimension] as they are at first: a single one across all axes; of all of them the k-th is
/// sin(k theta_i), theta_i = pi i/(n + 1) for the i-th axis of n. They are orthonormal, and since sin(k
/// theta)/sin(theta) are polynomials of rising degree in cos(theta), any k axes see the first k of them as independent
/// ones: also where the motion leaves planes, or other groups of coordinates, to themselves, the fastest growth comes
/// first (along the axes, the first ones would stay in the first group). What turns on and on has axes of its own, the
/// last: made orthogonal in turn, the others never know of it, and their growth is that of the rest alone.
void record_place_perturbations(const whirl_record *record, size_t count, double *perturbations);

// ---------------------------------------------------------------- steps
// Fixed steps that are too long for a motion, and what its verdict is worth then.

/// Fills record->steps of a finished motion, by a few of its revolutions. Methods with a tolerance are left out.
whirl_status steps_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

/// Takes back what steps that are too long do not bear: the verdict where they are unstable or wrong, confidence where
/// they are coarse.
void steps_weigh(whirl_verdict *verdict, const whirl_step_quality *steps);

/// Why steps leave a verdict open; false where they do not.
bool steps_reason(const whirl_verdict *verdict, char *text, size_t size);

// ---------------------------------------------------------------- twin
// A perturbation followed by a second trajectory.

/// A second trajectory close to the first, drawn back to its distance after every revolution (Benettin et al. 1980).
typedef struct trajectory_twin {
    size_t dimension;
    const double *turns, *angles; ///< as whirl_system has them: what turns is not perturbed
    double share;                 ///< of the state's size (twin_share)
    double least;                 ///< distance, in the state's units
    double distance;
    double *x; ///< NULL: no twin
} trajectory_twin;

/// A twin at x, yet to be placed, of motions that are carried in that way. Steps of one-step methods are a smooth
/// function of the state: twin and motion err alike. CVODE's orders and steps have a history, each motion errs on its
/// own, and the twin stands 10^4 tolerances off, so that what they err by is a small part of the distance. (All others
/// would lose by it: a distance d adds errors of the order of d.)
trajectory_twin twin_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x);

/// Places the twin beside the state x.
void twin_begin(trajectory_twin *twin, const double *x);

/// Natural logarithm of the growth since the last call; the twin is drawn back to its distance from x.
/// Where the distance is lost in rounding or out of all bounds, the growth is the limit of what can be told.
double twin_growth(trajectory_twin *twin, const double *x, bool bounded);

#endif
