/// Quasi-periodic motions of forced machines: tori, by the closed curve in which sections meet them.
///
/// Past a Neimark-Sacker point a machine runs with a second frequency that fits no whole number of revolutions. Its
/// sections, one every k revolutions, lie on a closed curve x(theta) that the map P over these revolutions turns by a
/// constant angle: P(x(theta)) = x(theta + 2 pi rho), rho its rotation number. The curve is a trigonometric polynomial
/// through an odd number of nodes, where that equation holds; Newton's method with the map's exact derivative finds it,
/// whether or not the torus is stable (Jorba 2001; Schilder, Osinga, Vogt 2005).
#ifndef WHIRL_TORUS_H
#define WHIRL_TORUS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/orbit.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Bounds of what tori are found with.
enum {
    WHIRL_MIN_TORUS_NODES = 5,    ///< of a curve
    WHIRL_MAX_TORUS_NODES = 1023, ///< of a curve
    WHIRL_MIN_TORUS_SECTIONS = 64 ///< from which a torus is found
};

/// How tori are found.
typedef struct whirl_torus_options {
    whirl_integrate_options integrate; ///< method: rk4, dop853 or rodas5p; "auto" is dop853
    double tolerance; ///< by which the equation may fail at nodes, over the largest coordinate of the nodes
    /// By which it may fail between nodes, over the curve's radius, where the tolerance allows it: more nodes are taken
    /// until then.
    double accuracy;
    int most_steps;    ///< of Newton's method
    size_t most_nodes; ///< odd; a curve that needs more counts as rough
} whirl_torus_options;

/// dop853 with rtol 1e-13 as whirl_orbit_default, tolerance 1e-11, accuracy 1e-7, 15 steps, 127 nodes.
whirl_torus_options whirl_torus_default(void);

/// A torus; freed by whirl_torus_free.
typedef struct whirl_torus {
    size_t dimension;   ///< of the system
    size_t revolutions; ///< k, from one section to the next
    size_t node_count;  ///< odd
    double *nodes;      ///< [node_count][dimension] the curve at t = 0, at equal angles 2 pi j/node_count
    double radius;      ///< greatest distance of a coordinate from its mean along the curve
    /// Turns of the curve from one section to the next: the frequencies of the motion are |i + j rotation|/revolutions
    /// for whole numbers i, j, in units of the speed (whirl_torus_line says which one a coordinate shows). Only its
    /// fraction is told by sections, and whether a turn is counted forward or backward is a choice: 0 to 1/2 where a
    /// torus is found; along a branch it is continuous.
    double rotation;
    double residual; ///< by which the equation fails at the nodes, as the tolerance is meant
    double error;    ///< by which it fails half way between them, over the radius
    double tail;     ///< the last two harmonics of the curve, over its largest
    /// Smallest q up to 12 with a whole p so that the rotation number is within 0.05/q^2 of p/q: near such a resonance
    /// the motion may lock to an orbit of q times as many revolutions. 0 where there is none.
    size_t resonance;
    /// Normal Lyapunov exponents, natural logarithms per revolution, falling: growth of perturbations across the torus.
    /// Those along it, whose exponents are 0, are left out; the torus is stable where all are below 0.
    size_t exponent_count;
    double *exponents;       ///< [exponent_count]
    double *exponent_errors; ///< [exponent_count] by their two halves of a walk along the curve, and by its error
    /// Mean over the torus of the integral of the divergence, per revolution: the sum of all exponents, small ones that
    /// doubles do not hold included (NaN as whirl_orbit has it).
    double volume;
    size_t unstable; ///< exponents above 0 by more than their errors
} whirl_torus;

/// Finds the torus on which a motion runs from its sections, `points` [count][dimension]: states at the beginning of
/// every revolutions-th revolution, one after the other, settled. They need not be its last word: Newton's method goes
/// on from them. `rotation` is its number as above, or NaN: then it is found from the points by weighted Birkhoff
/// averages (Das, Saiki, Sander, Yorke 2017).
///
/// WHIRL_BAD_INPUT with a sentence: fewer than WHIRL_MIN_TORUS_SECTIONS points; points that repeat, that lie on no
/// closed curve; no torus found; a curve that needs more nodes than allowed (which tells of a resonance nearby); as
/// whirl_orbit_find. WHIRL_NO_MEMORY.
whirl_status whirl_torus_find(const whirl_system *system, const double *points, size_t count, size_t revolutions,
                              double rotation, const whirl_torus_options *options, whirl_torus **torus);

/// Frees a torus; NULL is none.
void whirl_torus_free(whirl_torus *torus);

/// The curve at an angle theta, rad: x [dimension]; turning coordinates as nodes have them.
void whirl_torus_at(const whirl_torus *torus, double theta, double *x);

/// Follows the motions from `angles` equal angles of the curve over its revolutions: calls observe at the end of each
/// of `instants` equal parts of every revolution, t in (0, period] of it, all of one motion in turn. So bounds,
/// contacts and waveforms are told of a torus that is not stable, too. WHIRL_BAD_INPUT where they cannot be followed.
whirl_status whirl_torus_observe(const whirl_system *system, const whirl_torus *torus,
                                 const whirl_torus_options *options, size_t angles, size_t instants,
                                 whirl_observe_fn observe, void *observer);

/// What a torus shows of every coordinate; NaN where that turns on and on. Freed by whirl_torus_view_free.
typedef struct whirl_torus_view {
    size_t dimension, revolutions; ///< of the system, and from one section to the next
    double *low, *high;            ///< [dimension] bounds of the motion
    /// [revolutions][dimension] bounds of the closed curve in which the sections at the beginning of each of its
    /// revolutions lie.
    double *section_low, *section_high;
    double *frequency, *amplitude; ///< [dimension] of its strongest line, as whirl_torus_line tells it
} whirl_torus_view;

/// Looks at the motions from all nodes at 64 instants of a revolution. Bounds are those of the trigonometric
/// polynomials through them, between instants of parabolas. Errors as whirl_torus_observe; WHIRL_NO_MEMORY.
whirl_status whirl_torus_look(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              whirl_torus_view **view);

/// Frees a view; NULL is none.
void whirl_torus_view_free(whirl_torus_view *view);

/// The strongest line of a coordinate among those at |i + rotation|/revolutions, in units of the speed, up to 32 of
/// them: what a spectrum of it shows as the second frequency; its amplitude, in the coordinate's unit. WHIRL_BAD_INPUT
/// where there is no such coordinate or it turns on and on; else errors as whirl_torus_look.
whirl_status whirl_torus_line(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              size_t coordinate, double *frequency, double *amplitude);

// ---------------------------------------------------------------- branches

/// How a branch of tori is followed.
typedef struct whirl_torus_branch_options {
    whirl_torus_options torus; ///< how each is found
    double from, to;           ///< bounds of the parameter
    double step; ///< first, in the branch's own length: 1 is to - from, or a change of the curve by its own size
    double least_step, most_step; ///< shortest and longest
    size_t most_points;           ///< of the branch
    /// Called with every torus as it is found, which stays the branch's; false ends the branch with it. May be NULL.
    bool (*found)(void *context, double value, const whirl_torus *torus);
    void *context; ///< borrowed
} whirl_torus_branch_options;

/// From `from` to `to` in steps of 1e-4 to 0.05, at first 0.01, at most 200 points.
whirl_torus_branch_options whirl_torus_branch_default(double from, double to);

/// The first torus of the branch that a Neimark-Sacker point of the family leads to: its curve is an ellipse around the
/// orbit, whose mean distance is about `step` of the orbit's largest coordinate; *value is its parameter.
/// WHIRL_BAD_INPUT where none is found there, near strong resonances (orbits of up to four times the period), and where
/// the point is none; WHIRL_NO_MEMORY.
whirl_status whirl_torus_begin(const whirl_family *family, const whirl_branch_point *point, double step,
                               const whirl_torus_branch_options *options, whirl_torus **torus, double *value);

/// A point of a branch of tori.
typedef struct whirl_torus_point {
    double value;       ///< of the parameter
    whirl_torus *torus; ///< of the branch
} whirl_torus_point;

/// Why a branch of tori ends.
typedef enum whirl_torus_end {
    WHIRL_TORUS_END_OF_RANGE = 0, ///< the parameter left its bounds
    WHIRL_TORUS_END_OF_POINTS,    ///< as many points as were asked for
    WHIRL_TORUS_SHRANK,           ///< to an orbit, of which it is the Neimark-Sacker point
    WHIRL_TORUS_ROUGH,            ///< the curve needs more nodes than allowed: it loses its smoothness, or locks
    WHIRL_TORUS_LOST,             ///< steps as short as allowed found no curve
    WHIRL_TORUS_STOPPED           ///< whirl_torus_branch_options.found said so
} whirl_torus_end;

/// A branch of tori, in the order in which it was followed; freed by whirl_torus_branch_free.
typedef struct whirl_torus_branch {
    size_t count;              ///< of points
    whirl_torus_point *points; ///< [count]
    whirl_torus_end end;       ///< why it ends
    /// Value of the parameter to which the last two tori point: where the radius of one that shrinks vanishes, its
    /// square falling evenly, or where a rough one near a resonance locks, the square of the distance of its rotation
    /// number from that falling evenly. NaN where they point nowhere.
    double limit;
    char why[WHIRL_MESSAGE_SIZE]; ///< the end in a sentence, with where and its numbers
} whirl_torus_branch;

/// Follows the branch of a torus of the family at `value` by pseudo-arclength continuation, its rotation number going
/// with it, first to where the parameter changes in the direction of `direction` (+1, -1). Errors as
/// whirl_branch_follow.
whirl_status whirl_torus_follow(const whirl_family *family, const whirl_torus *start, double value, int direction,
                                const whirl_torus_branch_options *options, whirl_torus_branch **branch);

/// Frees a branch with its tori; NULL is none.
void whirl_torus_branch_free(whirl_torus_branch *branch);

#ifdef __cplusplus
}
#endif
#endif
