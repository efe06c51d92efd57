#include "support_tangent.h"

#include <math.h>
#include <string.h>

#include "support_flow.h"

static void joint_forcing(const void *model, double t, double *forcing) {
    const whirl_system *base = ((const tangent_model *)model)->base;
    base->forcing(base->model, t, forcing);
}

static void joint_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const tangent_model *tangent = model;
    const size_t n = tangent->base->dimension;
    double jacobian[MAX_TANGENT * MAX_TANGENT];
    tangent->base->rhs(tangent->base->model, t, forcing, x, dxdt);
    tangent->jacobian(tangent->parameters, t, x, jacobian);
    for (size_t column = 0; column < n; column++) {
        const double *y = x + n * (column + 1);
        double *slope = dxdt + n * (column + 1);
        for (size_t i = 0; i < n; i++) {
            slope[i] = 0.0;
            for (size_t j = 0; j < n; j++) slope[i] += jacobian[n * i + j] * y[j];
        }
    }
}

static void joint_switches(const void *model, double t, const double *x, double *values) {
    const whirl_system *base = ((const tangent_model *)model)->base;
    base->switches(base->model, t, x, values);
}

whirl_system make_tangent_system(const tangent_model *model) {
    const whirl_system *base = model->base;
    return (whirl_system){.dimension = base->dimension * (base->dimension + 1),
                          .period = base->period,
                          .forcing_count = base->forcing_count,
                          .forcing = base->forcing ? joint_forcing : NULL,
                          .rhs = joint_rhs,
                          .switch_count = base->switch_count,
                          .switches = base->switches ? joint_switches : NULL,
                          .model = model};
}

static void set_identity(size_t n, double *columns) {
    memset(columns, 0, n * n * sizeof *columns);
    for (size_t i = 0; i < n; i++) columns[n * i + i] = 1.0;
}

void carry_tangents(whirl_integrator *integrator, size_t n, double *x, int revolutions, double *matrix) {
    double joint[MAX_DIMENSION];
    memcpy(joint, x, n * sizeof *x);
    set_identity(n, joint + n);
    revolve(integrator, joint, revolutions);
    memcpy(x, joint, n * sizeof *x);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) matrix[n * i + j] = joint[n * (j + 1) + i];
}

/// Makes the columns orthonormal (Gram and Schmidt) and adds the logarithms of their lengths.
static void orthogonalise(size_t n, double *columns, double *logarithms) {
    for (size_t k = 0; k < n; k++) {
        double *y = columns + n * k, length = 0.0;
        for (size_t earlier = 0; earlier < k; earlier++) {
            const double *z = columns + n * earlier;
            double product = 0.0;
            for (size_t i = 0; i < n; i++) product += y[i] * z[i];
            for (size_t i = 0; i < n; i++) y[i] -= product * z[i];
        }
        for (size_t i = 0; i < n; i++) length += y[i] * y[i];
        length = sqrt(length);
        for (size_t i = 0; i < n; i++) y[i] /= length;
        logarithms[k] += log(length);
    }
}

void lyapunov_spectrum(whirl_integrator *integrator, size_t n, double *x, int transient, int revolutions,
                       double *exponents) {
    double joint[MAX_DIMENSION], unused[MAX_TANGENT] = {0.0};
    memcpy(joint, x, n * sizeof *x);
    set_identity(n, joint + n);
    for (int i = 0; i < transient; i++) {
        revolve(integrator, joint, 1);
        orthogonalise(n, joint + n, unused);
    }
    memset(exponents, 0, n * sizeof *exponents);
    for (int i = 0; i < revolutions; i++) {
        revolve(integrator, joint, 1);
        orthogonalise(n, joint + n, exponents);
    }
    memcpy(x, joint, n * sizeof *x);
    for (size_t k = 0; k < n; k++) exponents[k] /= revolutions;
}
