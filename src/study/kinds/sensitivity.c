// Derivatives by a parameter: extrapolated differences of neighbouring machines, and the motion with its sensitivity.
#include "whirl/engine/sensitivity.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lanes.h"

enum { LEVELS = 7, MACHINES = 1 + 2 * LEVELS, MAX_HALVINGS = 40 };

struct whirl_sensitivity {
    double reach;
    whirl_machine machines[MACHINES]; ///< at the value, then above and below it, from the largest h on
    whirl_system joint;               ///< system of (x, s)
    double *slopes;                   ///< [MACHINES][dimension] workspace
    double *sides;                    ///< [switch_count] workspace
};

static const whirl_system *system_of(const whirl_sensitivity *s, size_t machine) {
    return s->machines[machine].system;
}

static void sensitivity_release(whirl_sensitivity *s) {
    for (size_t i = 0; i < MACHINES; i++)
        if (s->machines[i].release) s->machines[i].release(s->machines[i].owner);
    memset(s->machines, 0, sizeof s->machines);
}

static double sensitivity_step(const whirl_sensitivity *s, size_t level) {
    return ldexp(s->reach, -(int)level);
}

static whirl_status sensitivity_build(whirl_sensitivity *s, const whirl_study *study, const whirl_batch *batch,
                                      double value) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < MACHINES && status.code == WHIRL_OK; i++) {
        const double h = i == 0 ? 0.0 : sensitivity_step(s, (i - 1) / 2);
        status = study->machine(study->family, batch, i % 2 ? value + h : value - h, &s->machines[i]);
        if (status.code == WHIRL_OK && (system_of(s, i)->dimension != system_of(s, 0)->dimension ||
                                        system_of(s, i)->switch_count != system_of(s, 0)->switch_count))
            status = whirl_fail(WHIRL_BAD_INPUT, "the machine near %g has other states, expected the same ones", value);
    }
    return status;
}

whirl_status whirl_sensitivity_new(const whirl_study *study, const whirl_batch *batch, double value, double reach,
                                   whirl_sensitivity **out) {
    *out = NULL;
    if (!(reach >= 0.0 && isfinite(value) && isfinite(reach)) || (reach == 0.0 && value == 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "reach is %g at the value %g, expected a number above 0", reach, value);
    whirl_sensitivity *s = calloc(1, sizeof *s);
    if (!s) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a sensitivity");
    s->reach = reach > 0.0 ? reach : 0.125 * fabs(value);
    whirl_status status = sensitivity_build(s, study, batch, value);
    for (int i = 0; i < MAX_HALVINGS && status.code == WHIRL_BAD_INPUT && s->machines[0].system; i++) {
        sensitivity_release(s);
        s->reach *= 0.5;
        status = sensitivity_build(s, study, batch, value);
    }
    if (status.code == WHIRL_OK) {
        s->slopes = calloc(MACHINES * system_of(s, 0)->dimension, sizeof *s->slopes);
        s->sides = calloc(system_of(s, 0)->switch_count + 1, sizeof *s->sides);
        if (!s->slopes || !s->sides) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a sensitivity");
    }
    if (status.code == WHIRL_OK)
        *out = s;
    else
        whirl_sensitivity_free(s);
    return status;
}

void whirl_sensitivity_free(whirl_sensitivity *s) {
    if (!s) return;
    sensitivity_release(s);
    free(s->slopes);
    free(s->sides);
    free(s);
}

const whirl_system *whirl_sensitivity_machine(const whirl_sensitivity *s) {
    return system_of(s, 0);
}

// ---------------------------------------------------------------- differences

static void slope_on_sides(const whirl_system *system, double t, const double *forcing, const double *x,
                           const double *sides, double *slope) {
    if (sides && system->rhs_on_sides)
        system->rhs_on_sides(system->model, t, forcing, x, sides, slope);
    else
        system->rhs(system->model, t, forcing, x, slope);
}

/// Slope of machine `index` at the phase of its period that t has in the first one's.
static void slope_of(const whirl_sensitivity *s, size_t index, double t, const double *x, const double *sides) {
    const whirl_system *system = system_of(s, index);
    const double longer = system->period / system_of(s, 0)->period;
    double forcing[WHIRL_MAX_FORCING], *slope = s->slopes + index * system->dimension;
    if (system->forcing_count > 0) system->forcing(system->model, longer * t, forcing);
    slope_on_sides(system, longer * t, forcing, x, sides, slope);
    for (size_t i = 0; i < system->dimension; i++) slope[i] *= longer;
}

/// Derivative of component i and its error: the entry of Neville's table that differs least from its neighbours.
static double sensitivity_extrapolate(const whirl_sensitivity *s, size_t i, double *error) {
    const size_t n = system_of(s, 0)->dimension;
    double table[LEVELS][LEVELS], best = 0.0;
    *error = INFINITY;
    for (size_t k = 0; k < LEVELS; k++) {
        const double above = s->slopes[(2 * k + 1) * n + i], below = s->slopes[(2 * k + 2) * n + i];
        const double rounding = 8.0 * DBL_EPSILON * fmax(fabs(above), fabs(below)) / sensitivity_step(s, k);
        table[k][0] = (above - below) / (2.0 * sensitivity_step(s, k));
        for (size_t j = 1; j <= k; j++) {
            const double less = ldexp(1.0, 2 * (int)j) - 1.0;
            table[k][j] = table[k][j - 1] + (table[k][j - 1] - table[k - 1][j - 1]) / less;
            const double off =
                fmax(fabs(table[k][j] - table[k][j - 1]), fabs(table[k][j] - table[k - 1][j - 1])) + rounding;
            if (off < *error) {
                best = table[k][j];
                *error = off;
            }
        }
    }
    return isfinite(*error) ? best : table[LEVELS - 1][LEVELS - 1];
}

void whirl_sensitivity_slope(const whirl_sensitivity *s, double t, const double *x, const double *sides, double *slope,
                             double *error) {
    const whirl_system *system = system_of(s, 0);
    if (!sides && system->switch_count > 0) {
        system->switches(system->model, t, x, s->sides);
        for (size_t i = 0; i < system->switch_count; i++) s->sides[i] = s->sides[i] > 0.0 ? 1.0 : -1.0;
        sides = s->sides;
    }
    for (size_t i = 1; i < MACHINES; i++) slope_of(s, i, t, x, sides);
    for (size_t i = 0; i < system->dimension; i++) {
        double off;
        slope[i] = sensitivity_extrapolate(s, i, &off);
        if (error) error[i] = off;
    }
}

// ---------------------------------------------------------------- the motion with its sensitivity

static void joint_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           double *dxdt) {
    const whirl_sensitivity *s = model;
    const whirl_system *system = system_of(s, 0);
    const size_t n = system->dimension;
    whirl_sensitivity_slope(s, t, x, sides, dxdt, NULL);
    system->tangent(system->model, t, forcing, x, sides, 1, x + n, dxdt + n);
    for (size_t i = 0; i < n; i++) dxdt[n + i] += dxdt[i];
    slope_on_sides(system, t, forcing, x, sides, dxdt);
}

static void joint_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    joint_on_sides(model, t, forcing, x, NULL, dxdt);
}

static void joint_forcing(const void *model, double t, double *forcing) {
    const whirl_system *system = system_of(model, 0);
    system->forcing(system->model, t, forcing);
}

static void joint_switches(const void *model, double t, const double *x, double *values) {
    const whirl_system *system = system_of(model, 0);
    system->switches(system->model, t, x, values);
}

whirl_status whirl_sensitivity_system(whirl_sensitivity *s, const whirl_system **out) {
    const whirl_system *system = system_of(s, 0);
    *out = NULL;
    if (!system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine gives no Jacobian, expected one for the sensitivity of its motion");
    if (system->lanes && (system->lanes->jumps || system->lanes->slides))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine's forces jump where a contact or a slip begins, expected continuous "
                          "ones for the sensitivity of its motion");
    s->joint = (whirl_system){.dimension = 2 * system->dimension,
                              .period = system->period,
                              .forcing_count = system->forcing_count,
                              .forcing = system->forcing ? joint_forcing : NULL,
                              .rhs = joint_rhs,
                              .kinked = system->kinked,
                              .switch_count = system->switch_count,
                              .switches = system->switches ? joint_switches : NULL,
                              .rhs_on_sides = system->rhs_on_sides ? joint_on_sides : NULL,
                              .probe_count = system->probe_count,
                              .probes = system->probes,
                              .model = s};
    *out = &s->joint;
    return whirl_ok();
}
