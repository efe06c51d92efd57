/// Flow maps, fixed points and multipliers, through the public integrators.
#ifndef SUPPORT_FLOW_H
#define SUPPORT_FLOW_H

#include <complex.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/system.h"

enum { MAX_DIMENSION = 32 };

/// An integrator of that method; adaptive ones at rtol 1e-15, atol 1e-16, as accurate as doubles allow.
whirl_integrator *make_integrator(const whirl_system *system, const char *method, int steps_per_revolution);

/// Carries x over whole revolutions; the test ends when it does not stay bounded.
void revolve(whirl_integrator *integrator, double *x, int revolutions);

/// Computes d(x after the revolutions)/dx [n][n], row-major, by central differences of fourth order.
void flow_jacobian(whirl_integrator *integrator, size_t n, const double *x, int revolutions, double step,
                   double *matrix);

/// Newton's method from x on x(revolutions) - x = 0.
void find_fixed_point(whirl_integrator *integrator, size_t n, double *x, int revolutions);

/// d(dx/dt)/dx [n][n] of a system at t by central differences of tenth order.
void rhs_jacobian(const whirl_system *system, double t, const double *x, double step, double *matrix);

/// The same exactly, as the system gives it.
void exact_jacobian(const whirl_system *system, double t, const double *x, double *matrix);

/// Largest difference of gradient and curvature of switch `which` at t = 0 from central differences by `step` of the
/// switch and of the gradient, and the gradient's largest entry; of up to 64 coordinates and switches.
double switch_apart(const whirl_system *system, const double *x, size_t which, double step, double *largest);

/// Writes dx/dt at t.
void evaluate_rhs(const whirl_system *system, double t, const double *x, double *dxdt);

/// Eigenvalues [n] of a row-major matrix of any size, by LAPACK.
void eigenvalues(size_t n, const double *matrix, double complex *values);

double largest_modulus(size_t n, const double *matrix);

/// Largest real part; *imaginary (may be NULL) gets the modulus of the imaginary part that goes with it.
double largest_real_part(size_t n, const double *matrix, double *imaginary);

/// Solves matrix x = right in place of right.
void solve_linear(size_t n, const double *matrix, double *right);

double determinant(size_t n, const double *matrix);

#endif
