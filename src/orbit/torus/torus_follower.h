/// A branch of tori that is being followed.
#ifndef ORBIT_TORUS_FOLLOWER_H
#define ORBIT_TORUS_FOLLOWER_H

#include "curve.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/torus.h"
#include "whirl/status.h"

#include <stddef.h>

// ---------------------------------------------------------------- section_map
// The map from one section to the next but k, with its derivative.

typedef struct section_map {
    size_t revolutions;
    size_t dimension;
    size_t count;                 ///< of coordinates that do not turn on and on: a point of a section
    size_t *kept;                 ///< [count] which these are
    whirl_ensemble *lanes;        ///< points side by side; NULL: the integrator carries one after the other
    whirl_integrator *integrator; ///< NULL with lanes
    size_t side_by_side;          ///< points that are carried at once
    double *rest;                 ///< [dimension] turning coordinates at every section
    double *states;               ///< [side_by_side][dimension] workspace
    double *vectors;              ///< [side_by_side][count][dimension] workspace
    whirl_perturbations *columns; ///< [side_by_side] of these
} section_map;

/// Makes that of a system, which must outlive it, over so many revolutions. WHIRL_BAD_INPUT where its angles do not
/// come back after them, where it gives no Jacobian, and as whirl_integrator_new; WHIRL_NO_MEMORY. Freed by
/// section_map_free, NULL included.
whirl_status section_map_new(const whirl_system *system, const whirl_integrate_options *options, size_t revolutions,
                             section_map **out);
void section_map_free(section_map *map);

/// A state's point, and a point's state.
void section_map_take(const section_map *map, const double *state, double *point);
void section_map_put(const section_map *map, const double *point, double *state);

/// Where points [many][count] go: images [many][count] and, unless NULL, their derivatives [many][count][count] and the
/// mean of the integrals of the divergence (as whirl_perturbations have it). False where a motion is not bounded.
bool section_map_carry(section_map *map, size_t many, const double *points, double *images, double *derivatives,
                       double *volume);

// ---------------------------------------------------------------- torus_equations
// The equations of a torus: the map over its revolutions turns its curve by a constant angle.

/// Unknowns: the nodes [count][n] of the curve, n what does not turn on and on; the angle by which the map turns it,
/// rad; the parameter, where machines are one of a family. Equations: P(x_j) - x(theta_j + angle) at every node, and
/// the one that says which point of the curve is at theta = 0: of all shifts the one nearest to a reference curve.
typedef struct torus_equations {
    const whirl_torus_options *options;
    const whirl_family *family; ///< NULL: one machine, no parameter
    whirl_machine machine;      ///< of the family, at `value`
    double value;
    double reach; ///< from which derivatives by the parameter are taken, in its unit
    section_map *map;
    size_t revolutions, n;
    size_t count;             ///< of nodes
    double *images;           ///< [count][n] of the last evaluation
    double *matrices;         ///< [count][n][n] of the last one with a derivative
    double volume;            ///< mean over the nodes of it
    double *along;            ///< [count][n] derivative of the reference curve by the angle
    double *weights, *slopes; ///< [count] of x(angle)
    double *series;           ///< [count][n] workspace
    double *beside;           ///< [3][count][n] workspace
} torus_equations;

/// Makes those of a machine, or of a family at a value (system NULL), without nodes. `at` [dimension], a state of
/// theirs, tells where what turns on and on is at sections. Errors as whirl_torus_find and those of machines. Freed by
/// torus_equations_free, whether they were made or not.
whirl_status torus_equations_make(torus_equations *e, const whirl_system *system, const whirl_family *family,
                                  double value, const whirl_torus_options *options, size_t revolutions,
                                  size_t dimension, const double *at);
void torus_equations_free(torus_equations *e);

/// Makes room for so many nodes. False where memory is lacking.
bool torus_equations_resize(torus_equations *e, size_t count);

/// Numbers of equations and, with the parameter, of unknowns.
size_t torus_equations_count(const torus_equations *e);
size_t torus_equations_unknowns(const torus_equations *e);

/// Lets the curve of u be the reference.
void torus_equations_refer(torus_equations *e, const double *u);

/// The largest modulus of the nodes' coordinates, and of what they are off their mean.
double torus_equations_reach(const torus_equations *e, const double *u);
double torus_equations_radius(const torus_equations *e, const double *u);

/// What counts as 1 in lengths along a branch: of nodes, on average, the curve's own size; of the angle one radian; the
/// span of the parameter. scale [unknowns]
void torus_equations_scale(const torus_equations *e, const double *u, double span, double *scale);

/// As newton_problem has them.
bool torus_equations_evaluate(void *e, const double *u, double *value, double *derivative);
double torus_equations_size(void *e, const double *u, const double *value);

/// A point on the way, with as many nodes as it takes.
typedef struct torus_waypoint {
    size_t count;        ///< nodes
    double *u, *tangent; ///< unknowns, room for the most nodes
    whirl_torus *torus;  ///< NULL: none was found
    bool rough;          ///< one was found that is not accurate with the most nodes
    double pace;         ///< curve_pace
} torus_waypoint;

typedef struct torus_follower {
    torus_equations equations;
    curve curve;
    const whirl_torus_branch_options *options;
    size_t room;                         ///< unknowns with the most nodes
    double *trial, *direction, *forward; ///< [room] of the search under way
} torus_follower;

/// Makes one at a value, for tori of so many revolutions; what turns on and on is at sections where it is in `at`
/// [dimension]. Its
/// curve has no nodes yet. Errors as torus_equations_make and those of options. Freed by torus_follower_end, whether it
/// was made or not.
whirl_status torus_follower_begin(torus_follower *f, const whirl_family *family, size_t revolutions, size_t dimension,
                                  const double *at, double value, const whirl_torus_branch_options *options);
void torus_follower_end(torus_follower *f);

whirl_status torus_waypoint_new(const torus_follower *f, torus_waypoint *out);
void torus_waypoint_free(torus_waypoint *p);

/// Gives the curve so many nodes, and lengths by the size of u, which has them. False where memory is lacking.
bool torus_follower_resize(torus_follower *f, size_t count, const double *u);

/// The point across `direction` from the trial, its tangent on the side of `forward`; the search has all three, with as
/// many nodes as the equations, and takes more where accuracy asks for them. WHIRL_NO_MEMORY.
whirl_status torus_follower_find(torus_follower *f, torus_waypoint *out);

// ---------------------------------------------------------------- harmonics
// Closed curves as trigonometric polynomials through an odd number of points at equal angles.

/// The series of `count` points [count][n]: series [count][n], the mean, then cosine and sine of each harmonic.
void harmonics_of(size_t count, size_t n, const double *points, double *series);

/// The curve at an angle and, unless NULL, its derivative by the angle: [n].
void harmonics_at(size_t count, size_t n, const double *series, double angle, double *value, double *slope);

/// The curve at `many` equal angles, the first of which is `from`: values and, unless NULL, slopes [many][n]. Harmonics
/// that so many points do not hold are left out.
void harmonics_spread(size_t count, size_t n, const double *series, double from, size_t many, double *values,
                      double *slopes);

/// What each point counts for at an angle, and for its derivative: weights, slopes [count].
void harmonics_weights(size_t count, double angle, double *weights, double *slopes);

/// Euclidean amplitude of a harmonic.
double harmonics_size(size_t n, const double *series, size_t harmonic);

// ---------------------------------------------------------------- torus_describe
// Tori in memory, and how many nodes they need.

/// The torus of the unknowns u that have just been evaluated with a derivative. WHIRL_NO_MEMORY.
whirl_status torus_describe(torus_equations *e, const double *u, double residual, whirl_torus **out);

/// Whether the torus of u is as accurate as the options ask, or as their tolerance allows where it is small.
bool torus_is_accurate(const torus_equations *e, const double *u, const whirl_torus *torus);

/// Nodes with which the curve of u, whose error is that between its nodes, is about as accurate as the options ask:
/// odd, at most as many as they allow.
size_t torus_nodes_wanted(torus_equations *e, const double *u, double error);

/// Writes unknowns `from` with `count` nodes as those `to` with `many` nodes. False where memory is lacking.
bool torus_resample(const torus_equations *e, size_t count, const double *from, size_t many, double *to);

/// Says that the torus is rough, and near which resonance it is, in `size` bytes of text.
void torus_say_rough(const torus_equations *e, const whirl_torus *torus, char *text, size_t size);

/// Normal exponents of a curve whose derivatives are the last that were evaluated: the torus' exponents [n - 1] and
/// their error. False where memory is lacking or the curve has no direction.
bool torus_find_exponents(const torus_equations *e, const double *u, whirl_torus *torus);

// ---------------------------------------------------------------- torus_options
// Whether the options of tori make sense.

/// WHIRL_BAD_INPUT with a sentence where they do not.
whirl_status torus_check_options(const whirl_torus_options *options);

// ---------------------------------------------------------------- torus_start
// A curve to begin the search for a torus with, from the sections of a motion.

/// Fits a curve to `count` states that follow one another, [count][dimension], by its rotation number, or with NaN by
/// one found for them: gives the equations as many nodes as it takes, and *u [unknowns], malloc'd. Errors as
/// whirl_torus_find.
whirl_status torus_fit(torus_equations *e, const double *states, size_t count, double rotation, double **u);

#endif
