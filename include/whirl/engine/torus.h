/// Tori: quasi-periodic motions of forced machines, by the closed curve of their Poincare section.
///
/// Past a Neimark-Sacker point a machine has a second frequency, incommensurate with the revolutions. Its sections, one
/// every k revolutions, lie on a closed curve x(theta), which the map P over these revolutions turns by a constant
/// angle: P(x(theta)) = x(theta + 2 pi rho), with the rotation number rho. The curve is a trigonometric polynomial
/// through an odd number of nodes, at which that equation is satisfied. Newton's method with the map's exact derivative
/// finds stable and unstable tori (Jorba 2001; Schilder, Osinga, Vogt 2005).
#ifndef WHIRL_TORUS_H
#define WHIRL_TORUS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/orbit.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of tori.
enum {
    WHIRL_MIN_TORUS_NODES = 5,    ///< nodes of a curve
    WHIRL_MAX_TORUS_NODES = 1023, ///< nodes of a curve
    WHIRL_MIN_TORUS_SECTIONS = 64 ///< sections from which a torus is found
};

/// Options of finding tori.
typedef struct whirl_torus_options {
    whirl_integrate_options integrate; ///< method: rk4, dop853 or rodas5p; "auto" is dop853
    double tolerance; ///< largest error of the equation at nodes, over the largest coordinate of the nodes
    /// Largest error between nodes, over the curve's radius, as far as the tolerance permits; the number of nodes is
    /// raised to reach it.
    double accuracy;
    int most_steps;    ///< most steps of Newton's method
    size_t most_nodes; ///< odd; a curve that needs more counts as rough
} whirl_torus_options;

/// Returns the defaults: dop853 with rtol 1e-13 as whirl_orbit_default, tolerance 1e-11, accuracy 1e-7, 15 steps, 127
/// nodes.
whirl_torus_options whirl_torus_default(void);

/// A torus; freed by whirl_torus_free.
typedef struct whirl_torus {
    size_t dimension;   ///< dimension of the system
    size_t revolutions; ///< k, from one section to the next
    size_t node_count;  ///< odd
    double *nodes;      ///< [node_count][dimension] the curve at t = 0, at equal angles 2 pi j/node_count
    double radius;      ///< greatest distance of a coordinate from its mean along the curve
    /// Rotation number: turns of the curve from one section to the next. The frequencies of the motion are |i + j
    /// rotation|/revolutions for whole numbers i, j, in units of the speed (whirl_torus_line finds the one that
    /// dominates a coordinate). Sections determine it up to sign and whole turns: 0 to 1/2 where a torus is found,
    /// continuous along a branch.
    double rotation;
    double residual; ///< error of the equation at the nodes, in the measure of the tolerance
    double error;    ///< error of the equation half way between nodes, over the radius
    double tail;     ///< amplitude of the last two harmonics of the curve, over the largest
    /// Smallest q up to 12 for which the rotation number is within 0.05/q^2 of some p/q. Near such a resonance the
    /// motion may lock to an orbit of q times as many revolutions. 0 if there is none.
    size_t resonance;
    /// Number of normal Lyapunov exponents (growth of perturbations across the torus). Exponents along it, which are 0,
    /// are left out; the torus is stable if all are below 0.
    size_t exponent_count;
    double *exponents; ///< [exponent_count] natural logarithms per revolution, falling
    /// [exponent_count] from the two halves of a walk along the curve, and from the curve's error.
    double *exponent_errors;
    /// Mean over the torus of the integral of the divergence, per revolution: the sum of all exponents, including those
    /// too small for doubles (NaN as in whirl_orbit).
    double volume;
    size_t unstable; ///< number of exponents above 0 by more than their errors
} whirl_torus;

/// Finds the torus of a motion from its sections, `points` [count][dimension]: states at the beginning of every
/// revolutions-th revolution, in sequence, settled, though not necessarily to the last digit. `rotation` is the
/// rotation number, or NaN to find it from the points by weighted Birkhoff averages (Das, Saiki, Sander, Yorke 2017).
///
/// WHIRL_BAD_INPUT with a sentence: fewer than WHIRL_MIN_TORUS_SECTIONS points; points that repeat, or that are not on
/// a closed curve; no torus found; a curve that needs more nodes than allowed (a sign of a resonance nearby); as
/// whirl_orbit_find. WHIRL_NO_MEMORY.
whirl_status whirl_torus_find(const whirl_system *system, const double *points, size_t count, size_t revolutions,
                              double rotation, const whirl_torus_options *options, whirl_torus **torus);

/// Frees a torus; accepts NULL.
void whirl_torus_free(whirl_torus *torus);

/// Computes the point of the curve at an angle theta, rad: x [dimension]; turning coordinates as in the nodes.
void whirl_torus_at(const whirl_torus *torus, double theta, double *x);

/// Follows the motions from `angles` equal angles of the curve over its revolutions, one motion after the other: calls
/// observe at the end of each of `instants` equal parts of every revolution, t in (0, period] of it. Gives bounds,
/// contacts and waveforms of unstable tori, too. WHIRL_BAD_INPUT if they cannot be followed.
whirl_status whirl_torus_observe(const whirl_system *system, const whirl_torus *torus,
                                 const whirl_torus_options *options, size_t angles, size_t instants,
                                 whirl_observe_fn observe, void *observer);

/// Bounds and strongest lines of a torus, for every coordinate; NaN for turning ones. Freed by whirl_torus_view_free.
typedef struct whirl_torus_view {
    size_t dimension, revolutions; ///< dimension of the system; revolutions from one section to the next
    double *low, *high;            ///< [dimension] bounds of the motion
    /// [revolutions][dimension] bounds of the closed curve of the sections at the beginning of each of its revolutions.
    double *section_low, *section_high;
    /// [dimension] frequency and amplitude of the strongest line, as from whirl_torus_line.
    double *frequency, *amplitude;
} whirl_torus_view;

/// Computes a view from the motions from all nodes at 64 instants of a revolution. Bounds are those of trigonometric
/// polynomials along the curve, and of parabolas between instants. Errors as whirl_torus_observe; WHIRL_NO_MEMORY.
whirl_status whirl_torus_look(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              whirl_torus_view **view);

/// Frees a view; accepts NULL.
void whirl_torus_view_free(whirl_torus_view *view);

/// Finds the strongest line of a coordinate among up to 32 at |i + rotation|/revolutions, in units of the speed: the
/// second frequency in its spectrum. The amplitude is in the coordinate's unit. WHIRL_BAD_INPUT for a coordinate that
/// is out of range or turning; else errors as whirl_torus_look.
whirl_status whirl_torus_line(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              size_t coordinate, double *frequency, double *amplitude);

#ifdef __cplusplus
}
#endif
#endif
