/// Derivatives of a rub's switching functions (rub_kernel.h), as element.h has them.
#ifndef ROTOR_RUB_SWITCH_H
#define ROTOR_RUB_SWITCH_H

#include "element.h"

void rub_switch_gradient(const element *own, const double *q, const double *v, size_t index, double *by_q,
                         double *by_v);
void rub_switch_curvature(const element *own, const double *q, const double *v, size_t index, const double *uq,
                          const double *uv, double *by_q, double *by_v);

#endif
