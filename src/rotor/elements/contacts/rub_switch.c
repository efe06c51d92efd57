// First and second derivatives of a rub's switching functions.
//
// With the normal n = (x, y)/r, r' = n . v and the turning of n by a displacement u, e(u) = (u - n (n . u))/r:
//
//     r - gap                    by place n                        second e(u)
//     K (r - gap) + D r'         by place K n + D e(v), by velocity D n
//     R r + x y' - y x'          by place R n + (y', -x'), by velocity (-y, x)
#include "rub_switch.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "rub_kernel.h"

/// Computes normal and radius; the normal is zero at the centre.
static double normal_at(const double *q, double n[2]) {
    const double r = fmax(sqrt(q[0] * q[0] + q[1] * q[1]), 0x1p-1022);
    n[0] = q[0] / r;
    n[1] = q[1] / r;
    return r;
}

static double rub_switch_dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1];
}

/// Computes the change of the normal when the station moves by u.
static void turn(const double n[2], double r, const double *u, double e[2]) {
    const double along = rub_switch_dot(n, u);
    for (int i = 0; i < 2; i++) e[i] = (u[i] - n[i] * along) / r;
}

void radial_gradient(radial_form of, const double *q, const double *v, double *by_q, double *by_v) {
    double n[2], e[2];
    const double r = normal_at(q, n);
    turn(n, r, v, e);
    by_v[0] = by_v[1] = 0.0;
    if (of.slip) {
        by_q[0] = of.by_r * n[0] + v[1];
        by_q[1] = of.by_r * n[1] - v[0];
        by_v[0] = -q[1];
        by_v[1] = q[0];
        return;
    }
    for (int i = 0; i < 2; i++) {
        by_q[i] = of.by_r * n[i];
        if (of.by_growth == 0.0) continue;
        by_q[i] += of.by_growth * e[i];
        by_v[i] = of.by_growth * n[i];
    }
}

void radial_curvature(radial_form of, const double *q, const double *v, const double *uq, const double *uv,
                      double *by_q, double *by_v) {
    double n[2], e[2], swing[2], push[2];
    const double r = normal_at(q, n);
    turn(n, r, uq, e);
    turn(n, r, v, swing);
    turn(n, r, uv, push);
    by_v[0] = by_v[1] = 0.0;
    if (of.slip) {
        by_q[0] = of.by_r * e[0] + uv[1];
        by_q[1] = of.by_r * e[1] - uv[0];
        by_v[0] = -uq[1];
        by_v[1] = uq[0];
        return;
    }
    // The change of e(v) = (v - n (n . v))/r has three parts: n turns, r grows, v changes.
    const double growth = rub_switch_dot(n, v), turned = rub_switch_dot(e, v), grown = rub_switch_dot(n, uq);
    for (int i = 0; i < 2; i++) {
        by_q[i] = of.by_r * e[i];
        if (of.by_growth == 0.0) continue;
        by_q[i] += of.by_growth * (push[i] - (e[i] * growth + n[i] * turned + swing[i] * grown) / r);
        by_v[i] = of.by_growth * e[i];
    }
}

/// Returns the form of the switch with this index: depth, normal force, slip.
static radial_form form_of(const element *own, size_t index) {
    if (index == 0) return (radial_form){.by_r = 1.0};
    if (rub_sharp(own) && index == rub_slip_switch(own)) return (radial_form){true, own->number[RUB_SURFACE], 0.0};
    return (radial_form){false, own->number[RUB_STIFFNESS], own->number[RUB_DAMPING]};
}

void rub_switch_gradient(const element *own, const element_place *at, size_t index, element_place *by) {
    radial_gradient(form_of(own, index), at->q, at->v, by->q, by->v);
}

void rub_switch_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                          element_place *by) {
    radial_curvature(form_of(own, index), at->q, at->v, along->q, along->v, by->q, by->v);
}
#endif
