/// A branch of tori that is being followed, and the parts of its continuation.
#ifndef ORBIT_TORUS_FOLLOWER_H
#define ORBIT_TORUS_FOLLOWER_H

#include "curve.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/torus_branch.h"
#include "whirl/status.h"

#include <stddef.h>

// ---------------------------------------------------------------- section_map
// The map over k revolutions, from section to section, with its derivative.

typedef struct section_map {
    size_t revolutions;
    size_t dimension;
    size_t count;                 ///< coordinates of a section's point: those that do not turn
    size_t *kept;                 ///< [count] their indices
    whirl_ensemble *lanes;        ///< points side by side; NULL: the integrator carries one after the other
    whirl_integrator *integrator; ///< NULL with lanes
    size_t side_by_side;          ///< points that run at once
    double *rest;                 ///< [dimension] turning coordinates, the same at every section
    double *states;               ///< [side_by_side][dimension] workspace
    double *vectors;              ///< [side_by_side][count][dimension] workspace
    whirl_perturbations *columns; ///< [side_by_side] perturbations of these
} section_map;

/// Makes the map of a system, which must outlive it, over so many revolutions. WHIRL_BAD_INPUT if its angles do not
/// return after them, if it has no Jacobian, and as whirl_integrator_new; WHIRL_NO_MEMORY. Freed by section_map_free,
/// NULL included.
whirl_status section_map_new(const whirl_system *system, const whirl_integrate_options *options, size_t revolutions,
                             section_map **out);
void section_map_free(section_map *map);

/// Convert a state to its point, and a point to its state.
void section_map_take(const section_map *map, const double *state, double *point);
void section_map_put(const section_map *map, const double *point, double *state);

/// Maps points [many][count]: images [many][count] and, unless NULL, their derivatives [many][count][count] and the
/// mean of the integrals of the divergence (whirl_perturbations). False if a motion is not bounded.
bool section_map_carry(section_map *map, size_t many, const double *points, double *images, double *derivatives,
                       double *volume);

// ---------------------------------------------------------------- torus_equations
// Equations of a torus: the map over its revolutions turns its curve by a constant angle.

/// Unknowns: the nodes [count][n] of the curve, n coordinates that do not turn; the angle by which the map turns it,
/// rad; the parameter, if machines form a family. Equations: P(x_j) - x(theta_j + angle) at every node, and the phase
/// condition: of all shifts the curve has the one nearest to a reference curve.
typedef struct torus_equations {
    const whirl_torus_options *options;
    const whirl_family *family; ///< NULL: one machine, no parameter
    whirl_machine machine;      ///< machine of the family at `value`
    double value;
    double reach; ///< step of derivatives by the parameter, in its unit
    section_map *map;
    size_t revolutions, n;
    size_t count;             ///< number of nodes
    double *images;           ///< [count][n] images of the last evaluation
    double *matrices;         ///< [count][n][n] derivatives of the last evaluation that has any
    double volume;            ///< mean of its volume over the nodes
    double *along;            ///< [count][n] derivative of the reference curve by the angle
    double *weights, *slopes; ///< [count] weights of x(angle) and of its derivative
    double *series;           ///< [count][n] workspace
    double *beside;           ///< [3][count][n] workspace
} torus_equations;

/// Makes the equations of a machine, or of a family at a value (system NULL), without nodes. `at` [dimension], a state,
/// gives the turning coordinates at sections. Errors as whirl_torus_find and those of machines. Freed by
/// torus_equations_free, after a failure too.
whirl_status torus_equations_make(torus_equations *e, const whirl_system *system, const whirl_family *family,
                                  double value, const whirl_torus_options *options, size_t revolutions,
                                  size_t dimension, const double *at);
void torus_equations_free(torus_equations *e);

/// Allocates so many nodes. False without memory.
bool torus_equations_resize(torus_equations *e, size_t count);

/// Return the numbers of equations and, with the parameter, of unknowns.
size_t torus_equations_count(const torus_equations *e);
size_t torus_equations_unknowns(const torus_equations *e);

/// Makes the curve of u the reference.
void torus_equations_refer(torus_equations *e, const double *u);

/// Return the largest modulus of the nodes' coordinates, and of their deviation from the mean.
double torus_equations_reach(const torus_equations *e, const double *u);
double torus_equations_radius(const torus_equations *e, const double *u);

/// Sets unit lengths along a branch, scale [unknowns]: of nodes, on average, the curve's own size; of the angle one
/// radian; the span of the parameter.
void torus_equations_scale(const torus_equations *e, const double *u, double span, double *scale);

/// Functions for newton_problem.
bool torus_equations_evaluate(void *e, const double *u, double *value, double *derivative);
double torus_equations_size(void *e, const double *u, const double *value);

/// A point of the continuation, with as many nodes as it needs.
typedef struct torus_waypoint {
    size_t count;        ///< number of nodes
    double *u, *tangent; ///< unknowns, with space for the most nodes
    whirl_torus *torus;  ///< NULL: none was found
    bool rough;          ///< one was found that is not accurate even with the most nodes
    double pace;         ///< curve_pace
} torus_waypoint;

typedef struct torus_follower {
    torus_equations equations;
    curve curve;
    const whirl_torus_branch_options *options;
    size_t room;                         ///< number of unknowns with the most nodes
    double *trial, *direction, *forward; ///< [room] of the present search
} torus_follower;

/// Makes one at a value, for tori of so many revolutions, with turning coordinates at sections from `at` [dimension].
/// Its curve has no nodes yet. Errors as torus_equations_make and those of options. Freed by torus_follower_end, after
/// a failure too.
whirl_status torus_follower_begin(torus_follower *f, const whirl_family *family, size_t revolutions, size_t dimension,
                                  const double *at, double value, const whirl_torus_branch_options *options);
void torus_follower_end(torus_follower *f);

whirl_status torus_waypoint_new(const torus_follower *f, torus_waypoint *out);
void torus_waypoint_free(torus_waypoint *p);

/// Gives the curve so many nodes, and unit lengths by the size of u, which has them. False without memory.
bool torus_follower_resize(torus_follower *f, size_t count, const double *u);

/// Finds the point orthogonal to `direction` from the trial, with its tangent on the side of `forward`; all three are
/// the search's, with as many nodes as the equations. Uses more nodes if accuracy requires them. WHIRL_NO_MEMORY.
whirl_status torus_follower_find(torus_follower *f, torus_waypoint *out);

// ---------------------------------------------------------------- harmonics
// Closed curves as trigonometric polynomials through an odd number of points at equal angles.

/// Computes the series of `count` points [count][n]: series [count][n], the mean, then cosine and sine of each
/// harmonic.
void harmonics_of(size_t count, size_t n, const double *points, double *series);

/// Evaluates the curve at an angle and, unless NULL, its derivative by the angle: [n].
void harmonics_at(size_t count, size_t n, const double *series, double angle, double *value, double *slope);

/// Evaluates the curve at `many` equal angles, the first of which is `from`: values and, unless NULL, slopes [many][n].
/// Harmonics that so many points do not resolve are left out.
void harmonics_spread(size_t count, size_t n, const double *series, double from, size_t many, double *values,
                      double *slopes);

/// Computes the weight of each point in the value at an angle, and in its derivative: weights, slopes [count].
void harmonics_weights(size_t count, double angle, double *weights, double *slopes);

/// Returns the Euclidean amplitude of a harmonic.
double harmonics_size(size_t n, const double *series, size_t harmonic);

// ---------------------------------------------------------------- torus_describe
// Tori in memory, and how many nodes they need.

/// Makes the torus of the unknowns u that have just been evaluated with a derivative. WHIRL_NO_MEMORY.
whirl_status torus_describe(torus_equations *e, const double *u, double residual, whirl_torus **out);

/// Returns true if the torus of u is as accurate as the options require, or as their tolerance allows if it is small.
bool torus_is_accurate(const torus_equations *e, const double *u, const whirl_torus *torus);

/// Returns the number of nodes with which the curve of u, whose error between its nodes is `error`, is about as
/// accurate as the options require: odd, at most as many as they allow.
size_t torus_nodes_wanted(torus_equations *e, const double *u, double error);

/// Converts unknowns `from` with `count` nodes to `to` with `many` nodes. False without memory.
bool torus_resample(const torus_equations *e, size_t count, const double *from, size_t many, double *to);

/// Writes that the torus is inaccurate, and near which resonance it is, in `size` bytes of text.
void torus_say_rough(const torus_equations *e, const whirl_torus *torus, char *text, size_t size);

/// Computes the normal exponents of a curve whose derivatives were evaluated last: the torus' exponents [n - 1] and
/// their error. False without memory or if the curve has no direction.
bool torus_find_exponents(const torus_equations *e, const double *u, whirl_torus *torus);

// ---------------------------------------------------------------- torus_options
// Checks of options of tori.

/// Returns WHIRL_BAD_INPUT with a sentence for invalid options.
whirl_status torus_check_options(const whirl_torus_options *options);

// ---------------------------------------------------------------- torus_start
// A first curve for the search of a torus, from the sections of a motion.

/// Fits a curve to `count` consecutive states [count][dimension], by its rotation number, or with NaN by one found for
/// them: gives the equations as many nodes as needed, and *u [unknowns], malloc'd. Errors as whirl_torus_find.
whirl_status torus_fit(torus_equations *e, const double *states, size_t count, double rotation, double **u);

#endif
