/// Equations of a torus: the map over its revolutions turns its curve by a constant angle.
#ifndef ORBIT_TORUS_EQUATIONS_H
#define ORBIT_TORUS_EQUATIONS_H

#include "section_map.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/torus.h"
#include "whirl/status.h"

#include <stddef.h>

/// Unknowns: the nodes [count][n] of the curve, without coordinates that turn; the angle by which the map turns the
/// curve, rad; the parameter, if machines form a family. Equations: P(x_j) - x(theta_j + angle) = 0 at every node; and
/// the phase condition, which selects of all shifts of the curve the one nearest to a reference curve.
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
    double *workspace;        ///< [3][count][n] workspace
} torus_equations;

/// Makes the equations of a machine, or of a family at a value (system NULL), without nodes. The state `at` [dimension]
/// gives the turning coordinates at sections. Errors as whirl_torus_find, and the errors of making machines. Freed by
/// torus_equations_free, after a failure too.
whirl_status torus_equations_make(torus_equations *e, const whirl_system *system, const whirl_family *family,
                                  double value, const whirl_torus_options *options, size_t revolutions,
                                  size_t dimension, const double *at);
void torus_equations_free(torus_equations *e);

/// Allocates `count` nodes. Returns false without memory.
bool torus_equations_resize(torus_equations *e, size_t count);

/// Return the number of equations, and of unknowns including the parameter.
size_t torus_equations_count(const torus_equations *e);
size_t torus_equations_unknowns(const torus_equations *e);

/// Makes the curve of u the reference.
void torus_equations_refer(torus_equations *e, const double *u);

/// Return the largest modulus of the nodes' coordinates, and of their deviation from the mean.
double torus_equations_reach(const torus_equations *e, const double *u);
double torus_equations_radius(const torus_equations *e, const double *u);

/// Sets unit lengths along a branch, scale [unknowns]. The unit of nodes is on average the curve's own size; that of
/// the angle, one radian; that of the parameter, its span.
void torus_equations_scale(const torus_equations *e, const double *u, double span, double *scale);

/// Functions for newton_problem.
bool torus_equations_evaluate(void *e, const double *u, double *value, double *derivative);
double torus_equations_size(void *e, const double *u, const double *value);

#endif
