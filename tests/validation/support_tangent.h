/// A system together with its variational equations: the state x [n], then the columns of Y [n][n] with
/// dY/dt = J(t, x) Y. The Jacobian is the test's own, so it checks the motion independently of the library's perturbed
/// copy. Where the right-hand side is continuous at its switches (elastic contact), Y is too.
#ifndef SUPPORT_TANGENT_H
#define SUPPORT_TANGENT_H

#include "whirl/engine/integrate.h"
#include "whirl/engine/system.h"

enum { MAX_TANGENT = 4 };

/// Writes d(dx/dt)/dx [n][n], row-major.
typedef void (*jacobian_fn)(const void *parameters, double t, const double *x, double *jacobian);

typedef struct tangent_model {
    const whirl_system *base;
    jacobian_fn jacobian;
    const void *parameters;
} tangent_model;

/// The joint system; `model` is borrowed and must outlive it.
whirl_system make_tangent_system(const tangent_model *model);

/// x goes over whole revolutions; matrix [n][n], row-major, gets d(end)/d(start).
void carry_tangents(whirl_integrator *integrator, size_t n, double *x, int revolutions, double *matrix);

/// Computes all Lyapunov exponents [n] per revolution, largest first: tangents orthogonalised every revolution
/// (Benettin et al. 1980) over `revolutions` after `transient`. x is carried along.
void lyapunov_spectrum(whirl_integrator *integrator, size_t n, double *x, int transient, int revolutions,
                       double *exponents);

#endif
