#include "equations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rest_equations.h"
#include "shooting.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

static void equations_release(whirl_machine *machine) {
    if (machine->release) machine->release(machine->owner);
    *machine = (whirl_machine){.system = NULL};
}

/// Releases the present machine and the one for which the workspace was made.
static void release_all(orbit_equations *e) {
    shooting_free(e->s);
    e->s = NULL;
    equations_release(&e->machine);
    equations_release(&e->first);
}

whirl_status equations_make(orbit_equations *e, const whirl_system *system, const whirl_family *family, double value,
                            const whirl_orbit_options *options, size_t revolutions, double period) {
    *e = (orbit_equations){.options = options, .family = family, .value = value};
    whirl_status status = family ? family->machine(family->context, value, &e->machine) : whirl_ok();
    if (status.code == WHIRL_OK)
        status = shooting_new(family ? e->machine.system : system, options, revolutions, period, &e->s);
    if (status.code != WHIRL_OK) return status;
    const size_t d = e->s->dimension, m = e->s->count;
    e->nodes = calloc((3 * m + 3) * d + 1, sizeof *e->nodes);
    if (!e->nodes) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", m);
    e->at = e->nodes + m * d;
    e->flow = e->at + d;
    e->work = e->flow + d;
    return status;
}

void equations_free(orbit_equations *e) {
    release_all(e);
    free(e->nodes);
    e->nodes = NULL;
}

size_t equations_count(const orbit_equations *e) {
    return e->s->count * e->s->kept_count + (e->s->revolutions == 0 && !shooting_rests(e->s));
}

size_t equations_unknowns(const orbit_equations *e) {
    return equations_count(e) + (e->family != NULL);
}

double equations_period(const orbit_equations *e, const double *u) {
    return e->s->revolutions > 0 || shooting_rests(e->s) ? e->s->period : u[e->s->count * e->s->kept_count];
}

void equations_put(orbit_equations *e, const double *u) {
    const shooting *s = e->s;
    for (size_t j = 0; j < s->count; j++)
        for (size_t i = 0; i < s->kept_count; i++) e->nodes[j * s->dimension + s->kept[i]] = u[j * s->kept_count + i];
}

void equations_take(const orbit_equations *e, const double *nodes, double *u) {
    const shooting *s = e->s;
    for (size_t j = 0; j < s->count; j++)
        for (size_t i = 0; i < s->kept_count; i++) u[j * s->kept_count + i] = nodes[j * s->dimension + s->kept[i]];
}

/// Size below which an orbit counts as at zero; residuals are then absolute.
static const double nothing = 1e-12;

/// Returns the least size by which equations of a branch's orbits are scaled, a share of the largest orbit. The size of
/// a single orbit would not do: along a branch an equilibrium, or the states of a section, may come near zero.
static double least_size(const orbit_equations *e) {
    return (shooting_rests(e->s) ? 0.1 : 0.01) * e->largest;
}

void equations_scale(orbit_equations *e, double span, double *scale) {
    const size_t nodes = e->s->count * e->s->kept_count, n = equations_count(e);
    const double own = shooting_size(e->s, e->nodes), size = fmax(own, least_size(e));
    e->largest = fmax(e->largest, own);
    if (shooting_rests(e->s)) e->steepest = fmax(e->steepest, rest_rate(e->s));
    for (size_t i = 0; i < nodes; i++) scale[i] = (size > nothing ? size : 1.0) * sqrt((double)e->s->count);
    for (size_t i = nodes; i < n; i++) scale[i] = e->s->period;
    if (e->family) scale[n] = span;
}

void equations_begin_at(orbit_equations *e, const double *x) {
    const whirl_system *system = e->s->system;
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, 0.0, forcing);
    memcpy(e->at, x, e->s->dimension * sizeof *x);
    system->rhs(system->model, 0.0, forcing, x, e->flow);
}

// ---------------------------------------------------------------- another machine

/// Replaces the present machine by the one at another value.
static bool turn_to(orbit_equations *e, double value) {
    whirl_machine machine = {.system = NULL};
    shooting *s = NULL;
    if (value == e->value) return true;
    // Reuse the integrators for the new machine, or make new ones if its structure differs.
    whirl_status status = e->family->machine(e->family->context, value, &machine);
    const bool renewed = status.code == WHIRL_OK && shooting_renew(e->s, machine.system);
    if (status.code == WHIRL_OK && !renewed && machine.system->dimension == e->s->dimension)
        status = shooting_new(machine.system, e->options, e->s->revolutions, e->s->period, &s);
    if (!s && !renewed) {
        equations_release(&machine);
        return false;
    }
    // Keep the first machine: reused integrators refer to it.
    if (!renewed) {
        release_all(e);
        e->s = s;
    } else if (!e->first.system) {
        e->first = e->machine;
    } else {
        equations_release(&e->machine);
    }
    e->machine = machine;
    e->value = value;
    return true;
}

/// Computes the ends of the segments of a neighbouring machine, from the same nodes.
static bool ends_at(const orbit_equations *e, double value, double period, double *ends) {
    whirl_machine machine = {.system = NULL};
    shooting *s = NULL;
    whirl_status status = e->family->machine(e->family->context, value, &machine);
    if (status.code == WHIRL_OK && machine.system->dimension == e->s->dimension)
        status = shooting_new(machine.system, e->options, e->s->revolutions, e->s->period, &s);
    const bool rests = shooting_rests(e->s);
    const bool good =
        s && (rests ? rest_slope(s, e->nodes, s->ends, false) : shooting_carry(s, e->nodes, period, false));
    // The equations of an equilibrium have one number for each kept coordinate: move it to the place of that coordinate
    // in a node.
    for (size_t i = s && rests ? s->kept_count : 0; i-- > 0;) s->ends[s->kept[i]] = s->ends[i];
    if (good) memcpy(ends, s->ends, s->count * s->dimension * sizeof *ends);
    shooting_free(s);
    equations_release(&machine);
    return good;
}

/// Computes the ends of several machines, side by side in lanes; ends [count][segments][dimension].
static bool all_ends_at(const orbit_equations *e, size_t count, const double *values, double period, double *ends) {
    whirl_machine machines[MAX_MACHINES] = {0};
    const whirl_system *systems[MAX_MACHINES];
    const size_t size = e->s->count * e->s->dimension;
    bool good = e->s->lanes != NULL;
    for (size_t k = 0; k < count && good; k++) {
        good = e->family->machine(e->family->context, values[k], &machines[k]).code == WHIRL_OK;
        systems[k] = machines[k].system;
    }
    good = good && shooting_carry_machines(e->s, count, systems, e->nodes, period, ends);
    for (size_t k = 0; k < count; k++) equations_release(&machines[k]);
    if (good) return true;
    for (size_t k = 0; k < count; k++)
        if (!ends_at(e, values[k], period, ends + k * size)) return false;
    return true;
}

/// Computes the derivative of the ends [segments][dimension] by the parameter, by central differences, and writes it
/// to the workspace `work`, behind its first `dimension` numbers. Its error is a sixth of the third derivative times
/// reach^2, plus the error of the ends over reach.
static bool by_parameter(orbit_equations *e, double period) {
    const double values[2] = {e->value + e->reach, e->value - e->reach};
    const size_t size = e->s->count * e->s->dimension;
    double *ends = e->work + e->s->dimension;
    if (!all_ends_at(e, 2, values, period, ends)) return false;
    for (size_t i = 0; i < size; i++) ends[i] = (ends[i] - ends[size + i]) / (values[0] - values[1]);
    return true;
}

void equations_reach(orbit_equations *e, double span) {
    e->reach = 0.25 * cbrt(e->options->integrate.rtol) * fabs(span);
}

// ---------------------------------------------------------------- values and derivatives

static void write_by_nodes(const orbit_equations *e, size_t columns, double *out) {
    const shooting *s = e->s;
    const size_t n = s->kept_count, m = s->count;
    for (size_t j = 0; j < m; j++)
        for (size_t i = 0; i < n; i++) {
            double *row = out + (j * n + i) * columns;
            for (size_t k = 0; k < n; k++) row[j * n + k] += s->matrices[(j * n + i) * n + k];
            if (!shooting_rests(s)) row[(j + 1) % m * n + i] -= 1.0;
        }
}

/// Writes the derivative by the period, and the phase condition, which selects the first node.
static void write_by_period(const orbit_equations *e, size_t columns, double *out) {
    const shooting *s = e->s;
    const size_t n = s->kept_count, own = s->count * n;
    for (size_t j = 0; j < s->count; j++) {
        shooting_by_period(s, j, e->work);
        for (size_t i = 0; i < n; i++) out[(j * n + i) * columns + own] = e->work[s->kept[i]];
    }
    for (size_t i = 0; i < n; i++) out[own * columns + i] = e->flow[s->kept[i]];
}

static bool write_derivative(orbit_equations *e, double period, double *out) {
    const shooting *s = e->s;
    const size_t n = s->kept_count, columns = equations_unknowns(e);
    memset(out, 0, equations_count(e) * columns * sizeof *out);
    write_by_nodes(e, columns, out);
    if (equations_count(e) > s->count * n) write_by_period(e, columns, out);
    if (!e->family) return true;
    if (!by_parameter(e, period)) return false;
    const double *slopes = e->work + s->dimension;
    for (size_t j = 0; j < s->count; j++)
        for (size_t i = 0; i < n; i++) out[(j * n + i + 1) * columns - 1] = slopes[j * s->dimension + s->kept[i]];
    return true;
}

bool equations_evaluate(void *context, const double *u, double *value, double *derivative) {
    orbit_equations *e = context;
    const double period = equations_period(e, u);
    if (!(isfinite(period) && period >= 0.0)) return false;
    if (e->family && !turn_to(e, u[equations_unknowns(e) - 1])) return false;
    shooting *s = e->s;
    equations_put(e, u);
    if (shooting_rests(s))
        return rest_slope(s, e->nodes, value, true) && (!derivative || write_derivative(e, period, derivative));
    if (period == 0.0) return false;
    if (!shooting_carry(s, e->nodes, period, derivative != NULL)) return false;
    shooting_turn(s, e->nodes);
    shooting_gap(s, e->nodes, value);
    if (s->revolutions == 0) {
        double *phase = value + s->count * s->kept_count;
        *phase = 0.0;
        for (size_t i = 0; i < s->dimension; i++) *phase += e->flow[i] * (e->nodes[i] - e->at[i]);
    }
    return !derivative || write_derivative(e, period, derivative);
}

double equations_size(void *context, const double *u, const double *value) {
    const orbit_equations *e = context;
    const double own = fmax(shooting_size(e->s, e->nodes), least_size(e)), size = own > nothing ? own : 0.0;
    double largest = 0.0;
    (void)u;
    if (shooting_rests(e->s)) return rest_size(e->s, value, size, fmax(rest_rate(e->s), 0.1 * e->steepest));
    for (size_t i = 0; i < e->s->count * e->s->kept_count; i++) largest = fmax(largest, fabs(value[i]));
    return size > 0.0 ? largest / size : largest;
}
