/// The equations of a torus: the map over its revolutions turns its curve by a constant angle.
#ifndef ORBIT_TORUS_EQUATIONS_H
#define ORBIT_TORUS_EQUATIONS_H

#include "section_map.h"
#include "whirl/engine/torus.h"

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

#endif
