/// Derivatives of a rub's switching functions (rub_kernel.h), for element.h.
#ifndef ROTOR_RUB_SWITCH_H
#define ROTOR_RUB_SWITCH_H

#include "element.h"

/// A function of a displacement (x, y) and its velocity: by_r r + by_growth r'; or, for a slip, by_r r + x y' - y x'.
typedef struct radial_form {
    bool slip;
    double by_r, by_growth;
} radial_form;

/// Computes the derivatives of this function by displacement and velocity, [2] each.
void radial_gradient(radial_form of, const double *q, const double *v, double *by_q, double *by_v);
/// Computes the second derivatives of this function applied to the perturbation (uq, uv).
void radial_curvature(radial_form of, const double *q, const double *v, const double *uq, const double *uv,
                      double *by_q, double *by_v);

/// Implement element_type.switch_gradient and element_type.switch_curvature for rubs.
void rub_switch_gradient(const element *own, const element_place *at, size_t index, element_place *by);
void rub_switch_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                          element_place *by);

#endif
