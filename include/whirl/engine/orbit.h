/// Periodic orbits, found by shooting, with their Floquet multipliers.
///
/// A periodic orbit of a forced machine closes after a whole number of revolutions; one of a machine without forcing in
/// time (the oil whirl of a balanced rotor) after a period of its own. Newton's method on the map over that time, with
/// the exact derivative of the integrator's steps and of the jumps at switches, finds stable and unstable orbits. The
/// time may be divided into segments whose ends are unknowns of their own (multiple shooting: Stoer, Bulirsch 2002,
/// 7.3.5), so that perturbations of an unstable orbit grow over one segment only.
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

/// Limits of orbits.
enum {
    WHIRL_MAX_ORBIT = 64,     ///< most revolutions of an orbit
    WHIRL_MAX_SEGMENTS = 1024 ///< most segments of an orbit
};

/// Options of finding orbits.
typedef struct whirl_orbit_options {
    whirl_integrate_options integrate; ///< method: rk4, dop853 or rodas5p; "auto" is dop853
    int segments; ///< segments of a revolution; of the whole period for an orbit with a period of its own. At least 1
    double tolerance; ///< largest closing error, over the largest coordinate of the nodes
    int most_steps;   ///< most steps of Newton's method
} whirl_orbit_options;

/// Returns the defaults: dop853 with rtol 1e-13 and contacts looked for at 512 instants of a revolution, one segment,
/// tolerance 1e-12, 25 steps.
whirl_orbit_options whirl_orbit_default(void);

/// A Floquet multiplier: factor of a small perturbation over the orbit's period. For an equilibrium an eigenvalue of
/// its Jacobian: growth rate of perturbations in the system's unit of time.
typedef struct whirl_multiplier {
    double real, imaginary; ///< real and imaginary part
} whirl_multiplier;

/// The contact of one station or coupling along an orbit, from its switching function, which is 0 where the contact
/// begins and ends.
typedef struct whirl_touch {
    size_t index;     ///< index of the switching function
    size_t intervals; ///< number of intervals in which the contact is closed, in one period (1 if it is always closed)
    double nearest;   ///< the extreme nearest to 0 of the switching function along the orbit: 0 when it grazes
    double share;     ///< share of the period in which the contact is closed
} whirl_touch;

/// An orbit; freed by whirl_orbit_free.
typedef struct whirl_orbit {
    size_t dimension;     ///< dimension of the system
    size_t revolutions;   ///< revolutions of its period; 0: it has a period of its own
    double period;        ///< in the system's unit of time; 0: it is an equilibrium
    size_t segment_count; ///< segments of the whole period
    double *nodes;        ///< [segment_count][dimension] the states at the beginnings of segments; the first at t = 0
    double residual;      ///< closing error, in the measure of the tolerance
    /// Number of multipliers; turning coordinates (whirl_system.turns) have none. An orbit with a period of its own has
    /// one equal to 1, for shifts along itself; it is stable if all others are inside the unit circle.
    size_t multiplier_count;
    whirl_multiplier *multipliers; ///< [dimension] by falling modulus; eigenvalues of equilibria by falling real part
    /// Sum of ln|multiplier| from the divergence along the orbit (Liouville) and the saltations; NaN if the system has
    /// no divergence or the motion slides along a switch; for equilibria the sum of eigenvalues. Small multipliers
    /// agree with it.
    double volume;
    size_t
        unstable; ///< number of multipliers outside the unit circle, without the one for shifts; of growing eigenvalues
    double *low;  ///< [dimension] bounds of every coordinate
    double *high; ///< [dimension]
    size_t touch_count;   ///< number of touches
    whirl_touch *touches; ///< [touch_count] of the switching functions at which contacts begin
} whirl_orbit;

/// Finds the orbit of `revolutions` revolutions near start [dimension] by damped Newton steps: the first segment begins
/// at start, the others on the motion from there. WHIRL_BAD_INPUT if `revolutions` is 0, too large or not a multiple of
/// the system's `repeats`, if the system has no Jacobian, and if no orbit is found (the sentence gives the error
/// reached); WHIRL_NO_MEMORY.
whirl_status whirl_orbit_find(const whirl_system *system, const double *start, size_t revolutions,
                              const whirl_orbit_options *options, whirl_orbit **orbit);

/// Finds an orbit of a system without forcing in time, together with its period, which is near `period`. The first node
/// is the point of the orbit nearest to start. WHIRL_BAD_INPUT also if the system is forced, and if the search ends at
/// an equilibrium.
whirl_status whirl_orbit_find_free(const whirl_system *system, const double *start, double period,
                                   const whirl_orbit_options *options, whirl_orbit **orbit);

/// Finds the equilibrium of a machine near start with whirl_equilibrium, as an orbit without a period, so that its
/// branch can be followed.
whirl_status whirl_orbit_rest(const whirl_system *system, const double *start, const whirl_orbit_options *options,
                              whirl_orbit **orbit);

/// Creates an orbit of the sizes of another (dimension, revolutions, period, segments, multipliers, touches), with all
/// other numbers 0; NULL if memory is exhausted. Freed by whirl_orbit_free.
whirl_orbit *whirl_orbit_new(const whirl_orbit *like);

/// Frees an orbit; accepts NULL.
void whirl_orbit_free(whirl_orbit *orbit);

/// Copies an orbit; NULL if memory is exhausted. Freed by whirl_orbit_free.
whirl_orbit *whirl_orbit_copy(const whirl_orbit *orbit);

/// Returns the largest modulus of the multipliers, without the one for shifts of an orbit with a period of its own:
/// stable below 1. For an equilibrium the largest real part: stable below 0.
double whirl_orbit_largest(const whirl_orbit *orbit);

/// Returns the distance of a state [dimension] at a section from the nearest section of the orbit, over the largest
/// coordinate of that section: 0 for the first node of the same orbit, whichever revolution it begins at. Turning
/// coordinates are skipped. The section of an equilibrium, and of an orbit with a period of its own, is the first node.
double whirl_orbit_distance(const whirl_system *system, const whirl_orbit *orbit, const double *state);

/// Returns the number of switching functions at which contacts begin: the touches of the system's orbits.
size_t whirl_touch_count(const whirl_system *system);

/// Calls observe at the end of each of `instants` equal parts of every segment, in turn: t in (0, period].
/// WHIRL_BAD_INPUT if the motion cannot be followed.
whirl_status whirl_orbit_observe(const whirl_system *system, const whirl_orbit *orbit,
                                 const whirl_orbit_options *options, size_t instants, whirl_observe_fn observe,
                                 void *observer);

// ---------------------------------------------------------------- all stable orbits of a machine

/// Options of collecting the orbits of a machine.
typedef struct whirl_collect_options {
    whirl_orbit_options orbit; ///< options of finding each
    size_t starts;             ///< number of motions
    const double *low, *high;  ///< [dimension] box that the starts fill evenly; borrowed
    size_t around_count;       ///< number of states that take turns as the origin of the box; 0: the box is not moved
    const double *around;      ///< [around_count][dimension]; borrowed
    size_t settle;             ///< revolutions before the first search for an orbit
    size_t most_revolutions;   ///< revolutions after which a motion is abandoned
    size_t longest;            ///< most revolutions of an orbit, 1 to WHIRL_MAX_ORBIT
} whirl_collect_options;

/// Returns the defaults: 64 starts in the box, 500 revolutions, at most 16000, orbits of up to 32.
whirl_collect_options whirl_collect_default(const double *low, const double *high);

/// Stable orbits on which motions of a machine settle; freed by whirl_collection_free.
typedef struct whirl_collection {
    size_t count;         ///< number of orbits
    whirl_orbit **orbits; ///< [count] all different motions, each with its least number of revolutions
    size_t *reached;      ///< [count] number of motions that reached each
    size_t elsewhere;     ///< motions that reached none: they end on a torus or in chaos, or settle too slowly
    size_t lost;          ///< motions that left the bounds
} whirl_collection;

/// Follows motions in parallel from starts that fill a box, the same ones in every run (an additive recurrence: Roberts
/// 2018), and repeatedly searches for orbits by Newton's method from states that nearly return. Collects the stable
/// orbits, with the motions that settle on each; orbits are compared by all their nodes. Orbits without a start in
/// their basin are not found. WHIRL_BAD_INPUT for invalid options and a system without a Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_orbit_collect(const whirl_system *system, const whirl_collect_options *options,
                                 whirl_collection **collection);

/// Frees a collection with its orbits; accepts NULL.
void whirl_collection_free(whirl_collection *collection);

// ---------------------------------------------------------------- branches

/// Machines that differ in one parameter.
typedef struct whirl_family {
    /// Makes the machine for a value of the parameter, in SI. All have the same coordinates and switches.
    whirl_status (*machine)(const void *context, double value, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_family;

/// Kinds of points of a branch.
typedef enum whirl_special {
    WHIRL_REGULAR = 0,    ///< an ordinary point
    WHIRL_FOLD,           ///< the branch turns back: a multiplier is 1
    WHIRL_BRANCHING,      ///< another branch crosses it (a symmetry breaks): a multiplier is 1
    WHIRL_DOUBLING,       ///< a branch of twice the period begins: a multiplier is -1
    WHIRL_NEIMARK_SACKER, ///< a torus begins: a pair of complex multipliers is on the unit circle
    WHIRL_HOPF,           ///< an equilibrium begins to whirl: a pair of its eigenvalues is imaginary
    WHIRL_GRAZE           ///< a contact begins, ends, parts or joins: a switching function has an extreme at 0
} whirl_special;

/// A point of a branch.
typedef struct whirl_branch_point {
    double value;          ///< value of the parameter
    double second;         ///< value of the second parameter on a curve over two; else NaN
    whirl_special special; ///< located to 1e-10 of the branch's span, or regular
    double angle; ///< angle of the multipliers at a Neimark-Sacker point, rad; the torus turns by it in a period
    /// Cubic coefficient of the normal form at doublings, Neimark-Sacker and Hopf points (Kuznetsov 2004, 5.4, with
    /// eigenvectors of length 1; for doublings with the other sign). Below 0 (supercritical) the new motion exists
    /// where the orbit is unstable, and is stable unless another multiplier is outside the unit circle. Above 0
    /// (subcritical) it exists where the orbit is stable, and stability is lost suddenly. NaN if unknown: at other
    /// points, near a third or a fourth of a turn, and on curves except those of Hopf points.
    double criticality;
    size_t touch;       ///< index of the touch of the orbit that grazes
    whirl_orbit *orbit; ///< the orbit there; owned by the branch
} whirl_branch_point;

/// Reasons for the end of a branch.
typedef enum whirl_branch_end {
    WHIRL_END_OF_RANGE = 0, ///< the parameter left its bounds
    WHIRL_END_OF_POINTS,    ///< it has the requested number of points
    WHIRL_END_CLOSED,       ///< it returned to its first point
    WHIRL_END_LOST,         ///< the shortest step found no orbit: the branch may end there
    WHIRL_END_HALVED,       ///< its orbits close after half their period there: at a doubling of another branch
    WHIRL_END_STOPPED,      ///< whirl_branch_options.found returned false
    WHIRL_END_MIRRORED      ///< its orbits become their own mirror images there: at a pitchfork of a symmetric branch
} whirl_branch_end;

/// A branch, in the order in which it was followed; freed by whirl_branch_free.
typedef struct whirl_branch {
    size_t count;               ///< number of points
    whirl_branch_point *points; ///< [count]
    whirl_branch_end end;       ///< reason for its end
} whirl_branch;

/// Options of following a branch.
typedef struct whirl_branch_options {
    whirl_orbit_options orbit; ///< options of finding its orbits
    double from, to;           ///< bounds of the parameter
    double step; ///< first step, in the branch's own length: 1 is to - from, or a change of the orbit by its own size
    double least_step;  ///< shortest step
    double most_step;   ///< longest step
    size_t most_points; ///< most points of the branch
    bool special;       ///< locate special points
    /// Receives every point as it is found; false ends the branch with that point. May be NULL.
    bool (*found)(void *context, const whirl_branch_point *point);
    void *context; ///< borrowed
} whirl_branch_options;

/// Returns the defaults: steps of at most 0.05, at most 1000 points, special points located.
whirl_branch_options whirl_branch_default(double from, double to);

/// Follows the branch of an orbit or equilibrium of the family at `value` by pseudo-arclength continuation (Keller
/// 1977). `direction` (+1, -1) is the first direction of the parameter. WHIRL_BAD_INPUT if there is no such orbit near
/// the given one, and for invalid bounds and steps; WHIRL_NO_MEMORY.
whirl_status whirl_branch_follow(const whirl_family *family, const whirl_orbit *start, double value, int direction,
                                 const whirl_branch_options *options, whirl_branch **branch);

/// Frees a branch with its orbits; accepts NULL.
void whirl_branch_free(whirl_branch *branch);

/// Finds the first orbit of the branch that begins at a doubling, branching or Hopf point, at a distance of `step` (as
/// in whirl_branch_options) from it; *value is its parameter. WHIRL_BAD_INPUT if none is found, and for points of other
/// kinds.
whirl_status whirl_branch_switch(const whirl_family *family, const whirl_branch_point *point, double step,
                                 const whirl_branch_options *options, whirl_orbit **orbit, double *value);

/// Machines that differ in two parameters.
typedef struct whirl_plane {
    /// Makes the machine for two values.
    whirl_status (*machine)(const void *context, double value, double second, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_plane;

/// Follows a special point (fold, doubling, Neimark-Sacker, Hopf or graze) over two parameters, as a curve of points of
/// the same kind. The curve begins at `start`, which was found at the value `second` of the second parameter;
/// `direction` is the first direction of that parameter. It ends where either parameter leaves its bounds: those of the
/// options, and bounds[0] < bounds[1]. Freed by whirl_branch_free. Errors as whirl_branch_follow.
whirl_status whirl_curve_follow(const whirl_plane *plane, const whirl_branch_point *start, double second, int direction,
                                const double bounds[2], const whirl_branch_options *options, whirl_branch **out);

/// Computes the eigenvalues of the product factors[count - 1] ... factors[0] of matrices [count][n][n], by falling
/// modulus, without forming the product: orthogonal iteration through the factors gives triangular factors, and each
/// eigenvalue to its own relative accuracy (periodic Schur form: Bojanczyk, Golub, Van Dooren 1992). Pairs with the
/// positive imaginary part first. Returns false if memory is exhausted or a number is not finite.
bool whirl_product_eigenvalues(size_t n, size_t count, const double *factors, whirl_multiplier *values);

#ifdef __cplusplus
}
#endif
#endif
