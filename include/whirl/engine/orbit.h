/// Periodic orbits: found by shooting, with their Floquet multipliers.
///
/// A periodic orbit of a forced machine closes after a whole number of revolutions; one of a machine that nothing
/// drives in time (the oil whirl of a balanced rotor) after a time of its own. Newton's method on the map over that
/// time, with the exact derivative of the integrator's steps and of what happens at switches, finds orbits whether or
/// not they are stable. The time may be cut into segments whose ends are unknowns of their own (multiple shooting:
/// Stoer, Bulirsch 2002, 7.3.5): what grows along an unstable orbit then grows over one segment only.
#ifndef WHIRL_ORBIT_H
#define WHIRL_ORBIT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    WHIRL_MAX_ORBIT = 64,     ///< most revolutions of an orbit
    WHIRL_MAX_SEGMENTS = 1024 ///< most segments of an orbit
};

/// How orbits are found.
typedef struct whirl_orbit_options {
    whirl_integrate_options integrate; ///< method: rk4, dop853 or rodas5p; "auto" is dop853
    int segments;     ///< of a revolution; of an orbit with a time of its own, of all of it. At least 1
    double tolerance; ///< by which an orbit may fail to close, over the largest coordinate of its nodes
    int most_steps;   ///< of Newton's method
} whirl_orbit_options;

/// dop853 with rtol 1e-13 and contacts looked for at 512 instants of a revolution, one segment, tolerance 1e-12, 25
/// steps.
whirl_orbit_options whirl_orbit_default(void);

/// A Floquet multiplier, by which a small perturbation changes over the orbit's period; of an equilibrium an eigenvalue
/// of its Jacobian, by which perturbations grow in the system's unit of time.
typedef struct whirl_multiplier {
    double real, imaginary; ///< its parts
} whirl_multiplier;

/// One station's or coupling's contact along an orbit, by the switching function whose zeros are where it begins and
/// ends.
typedef struct whirl_touch {
    size_t index;     ///< of the switching function
    size_t intervals; ///< in which the contact is closed, over the orbit's period (1 where it is closed all the time)
    double nearest;   ///< of the switching function's extremes along the orbit, the value nearest to 0: at 0 it grazes
    double share;     ///< of the period that the contact is closed
} whirl_touch;

/// An orbit; freed by whirl_orbit_free.
typedef struct whirl_orbit {
    size_t dimension;     ///< of the system
    size_t revolutions;   ///< after which it closes; 0: it has a time of its own
    double period;        ///< in the system's unit of time; 0: it is an equilibrium
    size_t segment_count; ///< of all of it
    double *nodes;        ///< [segment_count][dimension] the states at the beginnings of segments; the first at t = 0
    double residual;      ///< by which it fails to close, as the tolerance is meant
    /// By falling modulus, of equilibria by falling real part; turning coordinates (whirl_system.turns) have none. An
    /// orbit with a time of its own has one that is 1, for shifts along itself; where all others lie within the unit
    /// circle, it is stable.
    size_t multiplier_count;
    whirl_multiplier *multipliers; ///< [dimension] by falling modulus
    /// Sum of ln|multiplier| by the divergence along the orbit (Liouville) and the saltations; NaN where the system
    /// gives no divergence or the motion slides along a switch; of equilibria their sum. Small multipliers agree with
    /// it.
    double volume;
    size_t
        unstable; ///< multipliers beyond the unit circle, the one that is 1 by itself left out; eigenvalues that grow
    double *low;  ///< [dimension] bounds of every coordinate
    double *high; ///< [dimension]
    size_t touch_count;   ///< of touches
    whirl_touch *touches; ///< [touch_count] of the switching functions at which contacts begin
} whirl_orbit;

/// Finds the orbit of `revolutions` revolutions near start [dimension], by damped Newton steps: the first segment
/// begins at start, the others where the motion leads from there. WHIRL_BAD_INPUT where revolutions are 0 or too many,
/// or not a multiple of those after which turning coordinates come back, where the system gives no Jacobian, and with a
/// sentence that tells how far it came where no orbit is found; WHIRL_NO_MEMORY.
whirl_status whirl_orbit_find(const whirl_system *system, const double *start, size_t revolutions,
                              const whirl_orbit_options *options, whirl_orbit **orbit);

/// The same for a system that nothing drives in time, whose orbit closes after a time near `period` that is found with
/// it: of all points of the orbit the one nearest to start is the first node. WHIRL_BAD_INPUT where it is driven, too,
/// and where the search ends at an equilibrium.
whirl_status whirl_orbit_find_free(const whirl_system *system, const double *start, double period,
                                   const whirl_orbit_options *options, whirl_orbit **orbit);

/// The equilibrium of a machine near start, as whirl_equilibrium finds it, as an orbit without a period: so that its
/// branch can be followed, too.
whirl_status whirl_orbit_rest(const whirl_system *system, const double *start, const whirl_orbit_options *options,
                              whirl_orbit **orbit);

/// An orbit of the sizes of another (dimension, revolutions, period, segments, multipliers, touches), all other numbers
/// of it 0; NULL without memory. Freed by whirl_orbit_free.
whirl_orbit *whirl_orbit_new(const whirl_orbit *like);

/// Frees an orbit; NULL is none.
void whirl_orbit_free(whirl_orbit *orbit);

/// The same orbit once more; NULL without memory. Freed by whirl_orbit_free.
whirl_orbit *whirl_orbit_copy(const whirl_orbit *orbit);

/// The largest modulus of its multipliers, of an orbit with a time of its own without the one that is 1: the orbit is
/// stable where it is below 1. Of an equilibrium the largest real part, stable below 0.
double whirl_orbit_largest(const whirl_orbit *orbit);

/// How far a state [dimension] at a section is from the nearest of the orbit's sections, over the largest coordinate of
/// that: 0 for the first node of the same orbit, whichever revolution it begins at. Coordinates that turn are left out.
/// An orbit with a time of its own, and an equilibrium, has its first node for a section.
double whirl_orbit_distance(const whirl_system *system, const whirl_orbit *orbit, const double *state);

/// Switching functions of a system at which contacts begin: touches that its orbits have.
size_t whirl_touch_count(const whirl_system *system);

/// Calls observe at the end of each of `instants` equal parts of every segment, in turn: t in (0, period].
/// WHIRL_BAD_INPUT where the motion cannot be followed.
whirl_status whirl_orbit_observe(const whirl_system *system, const whirl_orbit *orbit,
                                 const whirl_orbit_options *options, size_t instants, whirl_observe_fn observe,
                                 void *observer);

// ---------------------------------------------------------------- all stable orbits

/// How the orbits of a machine are collected.
typedef struct whirl_collect_options {
    whirl_orbit_options orbit; ///< how each is found
    size_t starts;             ///< motions that are followed
    const double *low, *high;  ///< [dimension] of the box that the starts fill evenly; borrowed
    size_t around_count;       ///< states that take turns as the origin of the box; 0: it stands where it is
    const double *around;      ///< [around_count][dimension]; borrowed
    size_t settle;             ///< revolutions before an orbit is looked for, for the first time
    size_t most_revolutions;   ///< after which a motion is given up
    size_t longest;            ///< most revolutions of an orbit, 1 to WHIRL_MAX_ORBIT
} whirl_collect_options;

/// 64 starts in the box, 500 revolutions, at most 16000, orbits of up to 32.
whirl_collect_options whirl_collect_default(const double *low, const double *high);

/// The stable orbits of a machine that motions lead to; freed by whirl_collection_free.
typedef struct whirl_collection {
    size_t count;         ///< of orbits
    whirl_orbit **orbits; ///< [count] no two of them are the same motion; each of its least number of revolutions
    size_t *reached;      ///< [count] by how many motions each was reached
    size_t elsewhere;     ///< motions that came to none: they go on in a torus or in chaos, or settle too slowly
    size_t lost;          ///< motions that left the bounds
} whirl_collection;

/// Follows motions from starts that fill a box, the same ones in every run (an additive recurrence: Roberts 2018), side
/// by side, and looks again and again for orbits by Newton's method from where they nearly return. An orbit counts
/// where it is stable, and as reached by the motions that come to lie on it; motions are told apart by all their nodes.
/// Orbits whose basins no start lies in are not found. WHIRL_BAD_INPUT where the options make no sense or the system
/// gives no Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_orbit_collect(const whirl_system *system, const whirl_collect_options *options,
                                 whirl_collection **collection);

/// Frees a collection with its orbits; NULL is none.
void whirl_collection_free(whirl_collection *collection);

// ---------------------------------------------------------------- branches

/// Machines that differ by one parameter.
typedef struct whirl_family {
    /// Makes the machine for a value of the parameter, in SI. All have the same coordinates and switches.
    whirl_status (*machine)(const void *context, double value, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_family;

/// What happens at a point of a branch.
typedef enum whirl_special {
    WHIRL_REGULAR = 0,    ///< nothing
    WHIRL_FOLD,           ///< the branch turns back: a multiplier is 1
    WHIRL_BRANCHING,      ///< another branch crosses it (a symmetry breaks): a multiplier is 1
    WHIRL_DOUBLING,       ///< a branch of twice the period begins: a multiplier is -1
    WHIRL_NEIMARK_SACKER, ///< a torus begins: a pair of complex multipliers is on the unit circle
    WHIRL_HOPF,           ///< an equilibrium begins to whirl: a pair of its eigenvalues is imaginary
    WHIRL_GRAZE           ///< a contact begins, ends, parts or joins: a switching function has an extreme at 0
} whirl_special;

/// A point of a branch.
typedef struct whirl_branch_point {
    double value;          ///< of the parameter
    double second;         ///< of the second parameter, on a curve over two; else not a number
    whirl_special special; ///< located to 1e-10 of the branch's span, or regular
    double angle; ///< of the pair's multipliers at a Neimark-Sacker point, rad; of a torus its rotation per period
    /// Cubic coefficient of the normal form at doublings, Neimark-Sacker and Hopf points (Kuznetsov 2004, 5.4, with
    /// eigenvectors of length 1; of doublings with the other sign): below 0 what begins there lies where the orbit is
    /// unstable, and is stable if nothing else is not (supercritical); above 0 it lies where the orbit is stable, and
    /// the loss of it is sudden. NaN where it is not known: of other points, near a third or a fourth of a turn, on
    /// curves but for those of Hopf points.
    double criticality;
    size_t touch;       ///< at a graze, which of the orbit's touches
    whirl_orbit *orbit; ///< the orbit there; of the branch
} whirl_branch_point;

/// Why a branch ends.
typedef enum whirl_branch_end {
    WHIRL_END_OF_RANGE = 0, ///< the parameter left its bounds
    WHIRL_END_OF_POINTS,    ///< as many points as were asked for
    WHIRL_END_CLOSED,       ///< it came back to where it began
    WHIRL_END_LOST,         ///< steps as short as allowed found no orbit: the branch may end there
    WHIRL_END_HALVED,       ///< its orbits close after half their time there: at a doubling of another branch
    WHIRL_END_STOPPED,      ///< whirl_branch_options.found said so
    WHIRL_END_MIRRORED      ///< its orbits become their own mirror images there: at a pitchfork of a symmetric branch
} whirl_branch_end;

/// A branch, in the order in which it was followed; freed by whirl_branch_free.
typedef struct whirl_branch {
    size_t count;               ///< of points
    whirl_branch_point *points; ///< [count]
    whirl_branch_end end;       ///< why it ends
} whirl_branch;

/// How a branch is followed.
typedef struct whirl_branch_options {
    whirl_orbit_options orbit; ///< how its orbits are found
    double from, to;           ///< bounds of the parameter
    double step;        ///< first, in the branch's own length: 1 is to - from, or a change of the orbit by its own size
    double least_step;  ///< by which it must get on
    double most_step;   ///< longest
    size_t most_points; ///< of the branch
    bool special;       ///< locate special points
    /// Called with every point as it is found; false ends the branch with it. May be NULL.
    bool (*found)(void *context, const whirl_branch_point *point);
    void *context; ///< borrowed
} whirl_branch_options;

/// From `from` to `to` in steps of at most 0.05, at most 1000 points, special points located.
whirl_branch_options whirl_branch_default(double from, double to);

/// Follows the branch of an orbit, or of an equilibrium, of the family at `value` by pseudo-arclength continuation
/// (Keller 1977), first to where the parameter changes in the direction of `direction` (+1, -1). WHIRL_BAD_INPUT where
/// there is no such orbit near the given one, and where bounds and steps make no sense; WHIRL_NO_MEMORY.
whirl_status whirl_branch_follow(const whirl_family *family, const whirl_orbit *start, double value, int direction,
                                 const whirl_branch_options *options, whirl_branch **branch);

/// Frees a branch with its orbits; NULL is none.
void whirl_branch_free(whirl_branch *branch);

/// The first orbit of the branch that a doubling, branching or Hopf point leads to, at a distance of `step` (as in
/// whirl_branch_options) from it: *value is its parameter. WHIRL_BAD_INPUT where none is found, or the point is none of
/// these.
whirl_status whirl_branch_switch(const whirl_family *family, const whirl_branch_point *point, double step,
                                 const whirl_branch_options *options, whirl_orbit **orbit, double *value);

// ---------------------------------------------------------------- curves of special points

/// Machines that differ by two parameters.
typedef struct whirl_plane {
    /// Makes the machine of two values.
    whirl_status (*machine)(const void *context, double value, double second, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_plane;

/// Follows a special point, fold, doubling, Neimark-Sacker, Hopf or graze, over both parameters: a curve whose points
/// all are of its kind. It begins at `start`, found with the second parameter at `second`, first to where that changes
/// in the direction of `direction`; it ends where either parameter leaves its bounds, those of the options and
/// bounds[0] < bounds[1]. Freed by whirl_branch_free. Errors as whirl_branch_follow.
whirl_status whirl_curve_follow(const whirl_plane *plane, const whirl_branch_point *start, double second, int direction,
                                const double bounds[2], const whirl_branch_options *options, whirl_branch **out);

// ---------------------------------------------------------------- products

/// Eigenvalues of the product factors[count - 1] ... factors[0] of matrices [count][n][n], by falling modulus, without
/// the product: by orthogonal iteration through the factors, whose triangular parts then show the eigenvalues, each as
/// exact as its own size (periodic Schur form: Bojanczyk, Golub, Van Dooren 1992). Real ones alone, pairs with the
/// positive imaginary part first. False where memory is lacking or a number is not finite.
bool whirl_product_eigenvalues(size_t n, size_t count, const double *factors, whirl_multiplier *values);

#ifdef __cplusplus
}
#endif
#endif
