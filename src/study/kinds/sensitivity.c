// Derivatives by a parameter: extrapolated differences of neighbouring machines, and the machine with its parameters as
// states.
#include "whirl/engine/sensitivity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "extended.h"
#include "lanes.h"
#include "richardson.h"
#include "sensitivity_lanes.h"
#include "varied.h"

enum { LEVELS = RICHARDSON_LEVELS, MACHINES = 1 + 2 * LEVELS, MAX_HALVINGS = 40 };

/// Levels whose machines are made at once; equations that are linear in the parameter need no further ones.
enum { FIRST_LEVELS = 2, FIRST_MACHINES = 2 * FIRST_LEVELS };

struct whirl_sensitivity {
    const whirl_study *study;
    whirl_batch batch;
    varied_given given; ///< values of the batch's parameters
    double value, reach;
    size_t levels;                    ///< number of levels whose machines can be made, as far as it is known
    bool exhausted;                   ///< memory ran out when one was made
    whirl_machine machines[MACHINES]; ///< at the value, then above and below it, from the largest h on
    double *rows;                     ///< [MACHINES][larger of dimension and switch_count] workspace
    double *sides;                    ///< [switch_count] workspace
    double *lines, *errors;           ///< [entries of a row][LEVELS] and [entries] workspace
};

static const whirl_system *system_of(const whirl_sensitivity *s, size_t machine) {
    return s->machines[machine].system;
}

static void sensitivity_release(whirl_sensitivity *s) {
    for (size_t i = 0; i < MACHINES; i++)
        if (s->machines[i].release) s->machines[i].release(s->machines[i].owner);
    memset(s->machines, 0, sizeof s->machines);
}

/// Returns the length of a row of the workspace.
static size_t sensitivity_width(const whirl_sensitivity *s) {
    const whirl_system *system = system_of(s, 0);
    return system->dimension > system->switch_count ? system->dimension : system->switch_count;
}

/// Makes machine `index`.
static whirl_status sensitivity_build(whirl_sensitivity *s, size_t index) {
    const double h = index == 0 ? 0.0 : richardson_step(s->reach, (index - 1) / 2);
    whirl_machine *machine = &s->machines[index];
    const whirl_status status =
        s->study->machine(s->study->family, &s->batch, index % 2 ? s->value + h : s->value - h, machine);
    if (status.code != WHIRL_OK || (machine->system->dimension == system_of(s, 0)->dimension &&
                                    machine->system->switch_count == system_of(s, 0)->switch_count))
        return status;
    if (machine->release) machine->release(machine->owner);
    *machine = (whirl_machine){.system = NULL};
    return whirl_fail(WHIRL_BAD_INPUT, "the machine near %g has other states, expected the same ones", s->value);
}

static whirl_status sensitivity_build_first(whirl_sensitivity *s) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i <= FIRST_MACHINES && status.code == WHIRL_OK; i++) status = sensitivity_build(s, i);
    return status;
}

whirl_status whirl_sensitivity_new(const whirl_study *study, const whirl_batch *batch, double value, double reach,
                                   whirl_sensitivity **out) {
    *out = NULL;
    if (!(reach >= 0.0 && isfinite(value) && isfinite(reach)) || (reach == 0.0 && value == 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "reach is %g at the value %g, expected a number above 0", reach, value);
    whirl_sensitivity *s = calloc(1, sizeof *s);
    if (!s) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a sensitivity");
    // Make machines around the value, nearer to it if those farther away are impossible.
    s->study = study;
    s->batch = *batch;
    for (size_t i = 0; i < batch->given_count; i++) s->given[i] = batch->given[i];
    s->batch.given = s->given;
    s->value = value;
    s->levels = LEVELS;
    s->reach = reach > 0.0 ? reach : 0.125 * fabs(value);
    whirl_status status = sensitivity_build_first(s);
    for (int i = 0; i < MAX_HALVINGS && status.code == WHIRL_BAD_INPUT && s->machines[0].system; i++) {
        sensitivity_release(s);
        s->reach *= 0.5;
        status = sensitivity_build_first(s);
    }
    // Make memory for rows of numbers and their extrapolation.
    if (status.code == WHIRL_OK) {
        s->rows = calloc((MACHINES + LEVELS + 1) * sensitivity_width(s), sizeof *s->rows);
        s->lines = s->rows + MACHINES * sensitivity_width(s);
        s->errors = s->lines + LEVELS * sensitivity_width(s);
        s->sides = calloc(system_of(s, 0)->switch_count + 1, sizeof *s->sides);
        if (!s->rows || !s->sides) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a sensitivity");
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
    free(s->rows);
    free(s->sides);
    free(s);
}

/// Returns the unit of the parameter in extended machines.
static double sensitivity_unit(const whirl_sensitivity *s) {
    return s->value != 0.0 ? fabs(s->value) : 8.0 * s->reach;
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

/// Returns the factor from the first machine's time to that of machine `index`, at the same fraction of a period.
static double time_factor(const whirl_sensitivity *s, size_t index) {
    return system_of(s, index)->period / system_of(s, 0)->period;
}

/// Writes the slope of machine `index`, per time of the first machine, to its row. The time t is that of the first
/// machine; the other machine is at the same fraction of its period.
static void slope_of(const whirl_sensitivity *s, size_t index, double t, const double *x, const double *sides) {
    const whirl_system *system = system_of(s, index);
    const double longer = time_factor(s, index);
    double forcing[WHIRL_MAX_FORCING], *slope = s->rows + index * sensitivity_width(s);
    if (system->forcing_count > 0) system->forcing(system->model, longer * t, forcing);
    slope_on_sides(system, longer * t, forcing, x, sides, slope);
    for (size_t i = 0; i < system->dimension; i++) slope[i] *= longer;
}

/// Makes the machines of a level unless it has them. Returns false if they cannot be made; then later levels cannot
/// either.
static bool sensitivity_level(whirl_sensitivity *s, size_t level) {
    whirl_status status = whirl_ok();
    for (size_t i = 2 * level + 1; i <= 2 * level + 2 && status.code == WHIRL_OK && level < s->levels; i++)
        if (!s->machines[i].system) status = sensitivity_build(s, i);
    if (status.code != WHIRL_OK) s->levels = level;
    s->exhausted = s->exhausted || status.code == WHIRL_NO_MEMORY;
    return level < s->levels;
}

/// Extrapolates the first `count` entries of the rows, which `fill` writes for one machine: derivatives [count], and
/// unless NULL their errors. Levels are computed until all entries are known to rounding, or a machine is impossible.
static void sensitivity_derive(whirl_sensitivity *s, size_t count,
                               void (*fill)(const whirl_sensitivity *s, size_t machine, const void *at), const void *at,
                               double *derivatives, double *errors) {
    bool known = false;
    for (size_t k = 0; k < LEVELS && !known; k++) {
        if (k >= FIRST_LEVELS && !sensitivity_level(s, k)) break;
        fill(s, 2 * k + 1, at);
        fill(s, 2 * k + 2, at);
        known = k > 0;
        const double step = richardson_step(s->reach, k);
        const double *above = s->rows + (2 * k + 1) * sensitivity_width(s), *below = above + sensitivity_width(s);
        for (size_t i = 0; i < count; i++)
            known =
                richardson_add(above[i], below[i], step, k, s->lines + LEVELS * i, &derivatives[i], &s->errors[i]) &&
                known;
    }
    if (errors) memcpy(errors, s->errors, count * sizeof *errors);
}

/// A state of a motion at which derivatives are taken.
typedef struct derived_at {
    double t;
    const double *x, *sides;
    size_t which; ///< switching function
    /// NULL, or lanes that have the slopes of the first machines, from lane `first` on. Slopes are then those of
    /// velocities and further states only: the slopes of the `degrees` displacements are the velocities, whatever the
    /// parameter.
    const sensitivity_lanes *lanes;
    size_t first, degrees;
} derived_at;

static void fill_slope(const whirl_sensitivity *s, size_t machine, const void *at) {
    const derived_at *own = at;
    double *row = s->rows + machine * sensitivity_width(s);
    if (own->lanes && machine <= FIRST_MACHINES) {
        sensitivity_lanes_rates(own->lanes, own->first + machine - 1, row);
        return;
    }
    slope_of(s, machine, own->t, own->x, own->sides);
    if (own->lanes) memmove(row, row + own->degrees, (system_of(s, 0)->dimension - own->degrees) * sizeof *row);
}

static void fill_length(const whirl_sensitivity *s, size_t machine, const void *at) {
    (void)at;
    s->rows[machine * sensitivity_width(s)] = s->machines[machine].length;
}

static void fill_switch(const whirl_sensitivity *s, size_t machine, const void *at) {
    const derived_at *own = at;
    const whirl_system *system = system_of(s, machine);
    double *row = s->rows + machine * sensitivity_width(s);
    system->switches(system->model, time_factor(s, machine) * own->t, own->x, row);
    row[0] = row[own->which];
}

static void fill_gradient(const whirl_sensitivity *s, size_t machine, const void *at) {
    const derived_at *own = at;
    const whirl_system *system = system_of(s, machine);
    double by_time;
    system->switch_gradient(system->model, time_factor(s, machine) * own->t, own->x, own->which,
                            s->rows + machine * sensitivity_width(s), &by_time);
}

/// Returns the sides of the switches on which the laws are kept: the given ones, or those of x.
static const double *sensitivity_sides(whirl_sensitivity *s, double t, const double *x, const double *sides) {
    const whirl_system *system = system_of(s, 0);
    if (sides || system->switch_count == 0) return sides;
    system->switches(system->model, t, x, s->sides);
    for (size_t i = 0; i < system->switch_count; i++) s->sides[i] = s->sides[i] > 0.0 ? 1.0 : -1.0;
    return s->sides;
}

void whirl_sensitivity_slope(whirl_sensitivity *s, double t, const double *x, const double *sides, double *slope,
                             double *error) {
    const derived_at at = {.t = t, .x = x, .sides = sensitivity_sides(s, t, x, sides)};
    sensitivity_derive(s, system_of(s, 0)->dimension, fill_slope, &at, slope, error);
}

double whirl_sensitivity_length(whirl_sensitivity *s, double *length) {
    double slope;
    *length = s->machines[0].length;
    sensitivity_derive(s, 1, fill_length, NULL, &slope, NULL);
    return slope;
}

/// Returns the derivative by the parameter of switching function `which`, continued beyond its zero.
static double switch_by_parameter(whirl_sensitivity *s, double t, const double *x, size_t which) {
    const derived_at at = {.t = t, .x = x, .which = which};
    double slope;
    sensitivity_derive(s, 1, fill_switch, &at, &slope, NULL);
    return slope;
}

/// Computes the derivative by the parameter of the gradient of switching function `which`: out [dimension].
static void gradient_by_parameter(whirl_sensitivity *s, double t, const double *x, size_t which, double *out) {
    const derived_at at = {.t = t, .x = x, .which = which};
    sensitivity_derive(s, system_of(s, 0)->dimension, fill_gradient, &at, out, NULL);
}

// ---------------------------------------------------------------- the machine with its parameters as states

struct whirl_extended {
    whirl_system system; ///< system of (x, q)
    size_t own, count;   ///< number of coordinates of x, and of parameters
    whirl_sensitivity *by[WHIRL_MAX_SENSITIVITIES];
    double *periods;  ///< [2][own + count] periods of turning coordinates and of angles
    double *in, *out; ///< [own + count][own] workspace: perturbations of x, and their slopes
    double *slope;    ///< [own] workspace
    /// The first machines of every parameter side by side, one parameter after the other; NULL: one by one.
    sensitivity_lanes *lanes;
};

static const whirl_system *extended_base(const whirl_extended *e) {
    return system_of(e->by[0], 0);
}

static void extended_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                              double *dxdt) {
    const whirl_extended *e = model;
    slope_on_sides(extended_base(e), t, forcing, x, sides, dxdt);
    memset(dxdt + e->own, 0, e->count * sizeof *dxdt);
}

static void extended_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    extended_on_sides(model, t, forcing, x, NULL, dxdt);
}

static void extended_forcing(const void *model, double t, double *forcing) {
    const whirl_system *system = extended_base(model);
    system->forcing(system->model, t, forcing);
}

static void extended_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                             size_t count, const double *dx, double *ddxdt) {
    const whirl_extended *e = model;
    const whirl_system *system = extended_base(e);
    const size_t own = e->own, all = own + e->count;
    // Apply the Jacobian to the perturbations of x.
    for (size_t k = 0; k < count; k++) memcpy(e->in + k * own, dx + k * all, own * sizeof *dx);
    system->tangent(system->model, t, forcing, x, sides, count, e->in, e->out);
    for (size_t k = 0; k < count; k++) {
        memcpy(ddxdt + k * all, e->out + k * own, own * sizeof *dx);
        memset(ddxdt + k * all + own, 0, e->count * sizeof *dx);
    }
    // Add the derivatives by the parameters that a perturbation changes.
    derived_at at = {.t = t, .x = x, .lanes = e->lanes};
    if (e->lanes) at.degrees = system->lanes->degrees;
    memset(e->slope, 0, at.degrees * sizeof *e->slope);
    bool taken = false;
    for (size_t p = 0; p < e->count; p++) {
        bool known = false;
        for (size_t k = 0; k < count; k++) {
            const double change = dx[k * all + own + p] * sensitivity_unit(e->by[p]);
            if (change == 0.0) continue;
            if (!taken) {
                at.sides = sensitivity_sides(e->by[0], t, x, sides);
                if (e->lanes) sensitivity_lanes_take(e->lanes, forcing, x, at.sides);
            }
            at.first = p * FIRST_MACHINES;
            if (!known) sensitivity_derive(e->by[p], own - at.degrees, fill_slope, &at, e->slope + at.degrees, NULL);
            taken = known = true;
            for (size_t i = 0; i < own; i++) ddxdt[k * all + i] += change * e->slope[i];
        }
    }
}

static double extended_divergence(const void *model, double t, const double *forcing, const double *x,
                                  const double *sides) {
    const whirl_system *system = extended_base(model);
    return system->divergence(system->model, t, forcing, x, sides);
}

/// Computes the switching functions at the parameters of the state. Moving a sliding motion back onto its switch
/// changes q by rounding, which these functions include.
static void extended_switches(const void *model, double t, const double *x, double *values) {
    const whirl_extended *e = model;
    const whirl_system *system = extended_base(e);
    system->switches(system->model, t, x, values);
    for (size_t p = 0; p < e->count; p++)
        for (size_t i = 0; i < system->switch_count && x[e->own + p] != 0.0; i++)
            values[i] += sensitivity_unit(e->by[p]) * x[e->own + p] * switch_by_parameter(e->by[p], t, x, i);
}

static void extended_switch_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                                     double *by_time) {
    const whirl_extended *e = model;
    const whirl_system *system = extended_base(e);
    system->switch_gradient(system->model, t, x, index, gradient, by_time);
    for (size_t p = 0; p < e->count; p++)
        gradient[e->own + p] = sensitivity_unit(e->by[p]) * switch_by_parameter(e->by[p], t, x, index);
}

static void extended_switch_curvature(const void *model, double t, const double *x, size_t index, const double *u,
                                      double *out) {
    const whirl_extended *e = model;
    const whirl_system *system = extended_base(e);
    system->switch_curvature(system->model, t, x, index, u, out);
    memset(out + e->own, 0, e->count * sizeof *out);
    for (size_t p = 0; p < e->count; p++) {
        const double change = u[e->own + p] * sensitivity_unit(e->by[p]);
        if (change == 0.0) continue;
        gradient_by_parameter(e->by[p], t, x, index, e->slope);
        for (size_t i = 0; i < e->own; i++) {
            out[i] += change * e->slope[i];
            out[e->own + p] += sensitivity_unit(e->by[p]) * u[i] * e->slope[i];
        }
    }
}

static bool extended_switch_touches(const void *model, size_t index) {
    const whirl_system *system = extended_base(model);
    return system->switch_touches(system->model, index);
}

/// Copies periods of coordinates, with 0 for the parameters; NULL for NULL.
static const double *extended_periods(const whirl_extended *e, size_t row, const double *periods) {
    if (!periods) return NULL;
    double *out = e->periods + row * (e->own + e->count);
    memcpy(out, periods, e->own * sizeof *out);
    return out;
}

whirl_status whirl_extended_new(size_t count, whirl_sensitivity *const *by, whirl_extended **out) {
    *out = NULL;
    if (count < 1 || count > WHIRL_MAX_SENSITIVITIES)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu parameters, expected 1 to %d", count, WHIRL_MAX_SENSITIVITIES);
    const whirl_system *base = system_of(by[0], 0);
    if (!base->tangent)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine gives no Jacobian, expected one for the sensitivity of its motion");
    for (size_t p = 1; p < count; p++)
        if (system_of(by[p], 0)->dimension != base->dimension)
            return whirl_fail(WHIRL_BAD_INPUT, "sensitivities of different machines, expected those of one");
    // Make the workspace.
    const size_t own = base->dimension, all = own + count;
    whirl_extended *e = calloc(1, sizeof *e);
    if (e) e->periods = calloc(2 * all + 2 * all * own + own, sizeof *e->periods);
    if (!e || !e->periods) {
        free(e);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine with %zu parameters", count);
    }
    e->in = e->periods + 2 * all;
    e->out = e->in + all * own;
    e->slope = e->out + all * own;
    e->own = own;
    e->count = count;
    memcpy(e->by, by, count * sizeof *by);
    const whirl_system *machines[WHIRL_MAX_SENSITIVITIES * FIRST_MACHINES];
    for (size_t p = 0; p < count; p++)
        for (size_t i = 0; i < FIRST_MACHINES; i++) machines[p * FIRST_MACHINES + i] = system_of(by[p], 1 + i);
    if (!sensitivity_lanes_new(count * FIRST_MACHINES, machines, &e->lanes)) {
        whirl_extended_free(e);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine with %zu parameters", count);
    }
    // Describe the system.
    e->system = (whirl_system){.dimension = all,
                               .period = base->period,
                               .forcing_count = base->forcing_count,
                               .forcing = base->forcing ? extended_forcing : NULL,
                               .rhs = extended_rhs,
                               .turns = extended_periods(e, 0, base->turns),
                               .repeats = base->repeats,
                               .kinked = base->kinked,
                               .switch_count = base->switch_count,
                               .switches = base->switches ? extended_switches : NULL,
                               .rhs_on_sides = base->rhs_on_sides ? extended_on_sides : NULL,
                               .tangent = extended_tangent,
                               .divergence = base->divergence ? extended_divergence : NULL,
                               .switch_gradient = base->switch_gradient ? extended_switch_gradient : NULL,
                               .switch_curvature = base->switch_curvature ? extended_switch_curvature : NULL,
                               .switch_touches = base->switch_touches ? extended_switch_touches : NULL,
                               .probe_count = base->probe_count,
                               .probes = base->probes,
                               .angles = extended_periods(e, 1, base->angles),
                               .model = e,
                               .stop = base->stop};
    *out = e;
    return whirl_ok();
}

void whirl_extended_free(whirl_extended *e) {
    if (!e) return;
    sensitivity_lanes_free(e->lanes);
    free(e->periods);
    free(e);
}

const whirl_system *whirl_extended_system(const whirl_extended *e) {
    return &e->system;
}

bool extended_exhausted(const whirl_extended *e) {
    for (size_t p = 0; p < e->count; p++)
        if (e->by[p]->exhausted) return true;
    return false;
}

double whirl_extended_unit(const whirl_extended *e, size_t parameter) {
    return sensitivity_unit(e->by[parameter]);
}
