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

/// A Floquet multiplier: factor of a small perturbation over the orbit's period. For an equilibrium it is an eigenvalue
/// of the Jacobian: a growth rate of perturbations in the system's unit of time.
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
    /// no divergence or the motion slides along a switch; for equilibria the sum of eigenvalues. It checks the
    /// multipliers, the small ones included.
    double volume;
    /// Number of multipliers outside the unit circle, without the one for shifts; of an equilibrium growing
    /// eigenvalues.
    size_t unstable;
    double *low;          ///< [dimension] bounds of every coordinate
    double *high;         ///< [dimension]
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

/// Returns how many times the contact of a touch closes in a period; 0 if it is always closed.
size_t whirl_touch_closings(const whirl_touch *touch);

/// Calls observe at the end of each of `instants` equal parts of every segment, in turn: t in (0, period].
/// WHIRL_BAD_INPUT if the motion cannot be followed.
whirl_status whirl_orbit_observe(const whirl_system *system, const whirl_orbit *orbit,
                                 const whirl_orbit_options *options, size_t instants, whirl_observe_fn observe,
                                 void *observer);

/// Computes the eigenvalues of the product factors[count - 1] ... factors[0] of matrices [count][n][n], by falling
/// modulus, without forming the product: orthogonal iteration through the factors gives triangular factors, and each
/// eigenvalue to its own relative accuracy (periodic Schur form: Bojanczyk, Golub, Van Dooren 1992). Pairs with the
/// positive imaginary part first. Returns false if memory is exhausted or a number is not finite.
bool whirl_product_eigenvalues(size_t n, size_t count, const double *factors, whirl_multiplier *values);

#ifdef __cplusplus
}
#endif
#endif
