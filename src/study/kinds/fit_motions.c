#include "fit_motions.h"
#include "fit_place.h"
#include "fit_rest.h"
#include "fit_run.h"
#include "fit_special.h"
#include "fit_statistics.h"
#include "two_pi.h"
#include "varied.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/orbit.h"
#include "whirl/engine/sensitivity.h"

whirl_status fit_motions_make(fit_motions *m) {
    m->kept = calloc(2 * m->fit->motion_count, sizeof *m->kept);
    m->tried = m->kept + m->fit->motion_count;
    m->model = calloc(m->fit->number_count + 1, sizeof *m->model);
    m->status = whirl_ok();
    return m->kept && m->model ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for motions of a fit");
}

/// Copies the kept orbits. Returns false without memory.
static bool copy_kept(const fit_motions *from, fit_motions *to) {
    for (size_t i = 0; i < from->fit->motion_count; i++) {
        const fit_orbit *own = &from->kept[i];
        const size_t n = own->dimension, numbers = (1 + from->fit->unknown_count) * n;
        to->kept[i] = *own;
        to->kept[i].node = malloc((numbers + 1) * sizeof *own->node);
        if (!to->kept[i].node) return false;
        to->kept[i].slopes = to->kept[i].node + n;
        if (n > 0) memcpy(to->kept[i].node, own->node, numbers * sizeof *own->node);
    }
    return true;
}

whirl_status fit_motions_copy(const fit_motions *from, fit_motions *to) {
    *to = *from;
    const whirl_status status = fit_motions_make(to);
    if (status.code != WHIRL_OK) return status;
    return copy_kept(from, to) ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for motions of a fit");
}

void fit_motions_free(fit_motions *m) {
    for (size_t i = 0; m->kept && i < 2 * m->fit->motion_count; i++) free(m->kept[i].node);
    free(m->kept);
    free(m->model);
    m->kept = NULL;
    m->model = NULL;
}

void fit_motions_keep(void *motions) {
    fit_motions *m = motions;
    for (size_t i = 0; i < m->fit->motion_count; i++) {
        const fit_orbit before = m->kept[i];
        m->kept[i] = m->tried[i];
        m->tried[i] = before;
    }
}

// ---------------------------------------------------------------- one motion

/// Refuses measured waveforms of a machine whose speed depends on an unknown: the angle of the shaft at a time would
/// depend on it, too.
static whirl_status place_check_speed(const fit_place *p, const whirl_machine *machine, const fit_orbit *kept) {
    const whirl_fit *fit = p->of->fit;
    const size_t motion = (size_t)(p->motion - fit->motions);
    if (kept->dimension == 0 || kept->speed == machine->speed) return whirl_ok();
    for (size_t i = 0; i < fit->number_count; i++)
        if (fit->numbers[i].motion == motion && fit->numbers[i].quantity == WHIRL_FIT_WAVEFORM)
            return whirl_fail(WHIRL_BAD_INPUT, "displacements over time need a speed that depends on no unknown");
    return whirl_ok();
}

/// Finds the orbit: from the kept one and its derivatives, or after a transient.
static whirl_status place_find(const fit_place *p, const whirl_machine *machine, const fit_orbit *kept,
                               whirl_orbit **orbit) {
    const whirl_system *system = machine->system;
    const size_t n = system->dimension, revolutions = (size_t)p->of->batch->record.fit.revolutions;
    const bool known = kept->dimension == n;
    double *x = calloc(n + 1, sizeof *x);
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion of a fit");
    memcpy(x, known ? kept->node : machine->start, n * sizeof *x);
    for (size_t u = 0; u < p->of->fit->unknown_count && known; u++)
        for (size_t i = 0; i < n; i++) x[i] += (p->values[u] - kept->at[u]) * kept->slopes[u * n + i];
    const whirl_status status =
        known ? whirl_orbit_find(system, x, revolutions, &p->options, orbit) : fit_place_begin(p, system, x, orbit);
    free(x);
    return status;
}

/// Derives the orbit by all unknowns. `lengths` gets the metres of a unit of displacement and their derivatives.
static whirl_status place_derive(const fit_place *p, const whirl_orbit *orbit, whirl_orbit_sensitivity **out,
                                 double lengths[1 + WHIRL_MAX_UNKNOWNS]) {
    varied_parameter unknowns[WHIRL_MAX_UNKNOWNS];
    fit_place_unknowns(p, unknowns);
    return varied_orbit(p->of->study, &p->batch, NAN, p->of->fit->unknown_count, unknowns, orbit, &p->options,
                        p->motion->instants, lengths, out);
}

// ---------------------------------------------------------------- measured numbers

/// The displacement of a probe along a direction at one instant, m: its value, and its derivatives [unknowns].
typedef struct probe_view {
    const whirl_probe *probe;
    double cos, sin; ///< cosine and sine of the direction
    double speed;    ///< rad/s
    double lengths[1 + WHIRL_MAX_UNKNOWNS];
} probe_view;

static double view_along(const probe_view *v, const double *state) {
    return v->cos * whirl_probe_value(v->probe, state, 0) + v->sin * whirl_probe_value(v->probe, state, 1);
}

/// Returns a weighted sum of the displacement and its derivative by the angle of the shaft.
static double view_weighed(const probe_view *v, const double *state, const double weights[2]) {
    return weights[0] * view_along(v, state) + weights[1] * (v->cos * whirl_probe_value(v->probe, state, 2) +
                                                             v->sin * whirl_probe_value(v->probe, state, 3));
}

static void view_instant(const probe_view *v, const whirl_orbit_sensitivity *orbit, size_t index, double *value,
                         double *slopes) {
    const size_t n = orbit->dimension;
    const double turn = (double)(index % orbit->instants) / (double)orbit->instants;
    const double runout =
        v->cos * whirl_probe_runout(v->probe, 0, turn) + v->sin * whirl_probe_runout(v->probe, 1, turn);
    const double displacement = view_along(v, orbit->states + index * n) + runout;
    *value = v->lengths[0] * displacement;
    for (size_t u = 0; u < orbit->count; u++)
        slopes[u] = v->lengths[0] * view_along(v, orbit->slopes + (index * orbit->count + u) * n) +
                    v->lengths[1 + u] * displacement;
}

/// Writes the displacement at any place of the orbit, in revolutions, by the cubic polynomials with the values and
/// slopes of the neighbouring instants.
static void view_between(const probe_view *v, const whirl_orbit_sensitivity *orbit, double revolutions, double *value,
                         double *slopes) {
    const size_t n = orbit->dimension, all = orbit->revolutions * orbit->instants;
    const double place = revolutions * (double)orbit->instants, below = floor(place), t = place - below;
    const double step = two_pi / (double)orbit->instants;
    const double weights[2][2] = {{(1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t), step * t * (1.0 - t) * (1.0 - t)},
                                  {t * t * (3.0 - 2.0 * t), step * t * t * (t - 1.0)}};
    const double runout =
        v->cos * whirl_probe_runout(v->probe, 0, revolutions) + v->sin * whirl_probe_runout(v->probe, 1, revolutions);
    double displacement = runout;
    for (size_t u = 0; u < orbit->count; u++) slopes[u] = 0.0;
    for (size_t k = 0; k < 2; k++) {
        const size_t index = ((size_t)below + k) % all;
        displacement += view_weighed(v, orbit->states + index * n, weights[k]);
        for (size_t u = 0; u < orbit->count; u++)
            slopes[u] += v->lengths[0] * view_weighed(v, orbit->slopes + (index * orbit->count + u) * n, weights[k]);
    }
    *value = v->lengths[0] * displacement;
    for (size_t u = 0; u < orbit->count; u++) slopes[u] += v->lengths[1 + u] * displacement;
}

/// Adds up one part of an order, 2/N sum x cos or sin.
static void view_order(const probe_view *v, const whirl_orbit_sensitivity *orbit, double order, bool sine,
                       double *value, double *slopes) {
    const size_t all = orbit->revolutions * orbit->instants;
    double at[1 + WHIRL_MAX_UNKNOWNS];
    *value = 0.0;
    memset(slopes, 0, orbit->count * sizeof *slopes);
    for (size_t k = 0; k < all; k++) {
        const double angle = two_pi * order * (double)k / (double)orbit->instants;
        const double weight = 2.0 / (double)all * (sine ? sin(angle) : cos(angle));
        view_instant(v, orbit, k, &at[0], at + 1);
        *value += weight * at[0];
        for (size_t u = 0; u < orbit->count; u++) slopes[u] += weight * at[1 + u];
    }
}

static void view_number(const probe_view *v, const whirl_orbit_sensitivity *orbit, const whirl_fit_number *number,
                        double *value, double *slopes) {
    double sine, by_sine[WHIRL_MAX_UNKNOWNS];
    switch (number->quantity) {
    case WHIRL_FIT_SAMPLE:
        view_instant(v, orbit, (size_t)lround(number->at * (double)orbit->instants), value, slopes);
        break;
    case WHIRL_FIT_WAVEFORM: {
        const double period = (double)orbit->revolutions, passed = number->at * fabs(v->speed) / two_pi;
        view_between(v, orbit, passed - period * floor(passed / period), value, slopes);
        break;
    }
    case WHIRL_FIT_COS:
    case WHIRL_FIT_SIN:
        view_order(v, orbit, number->at, number->quantity == WHIRL_FIT_SIN, value, slopes);
        break;
    default: // WHIRL_FIT_AMPLITUDE
        view_order(v, orbit, number->at, false, value, slopes);
        view_order(v, orbit, number->at, true, &sine, by_sine);
        const double size = hypot(*value, sine);
        for (size_t u = 0; u < orbit->count; u++)
            slopes[u] = size > 0.0 ? (*value * slopes[u] + sine * by_sine[u]) / size : 0.0;
        *value = size;
        break;
    }
}

/// Computes the values of a motion's measured quantities on its orbit, and their derivatives [numbers][unknowns].
static void place_numbers(const fit_place *p, const whirl_machine *machine, const whirl_orbit_sensitivity *orbit,
                          const double *lengths, double *model, double *slopes) {
    const whirl_fit *fit = p->of->fit;
    const size_t motion = (size_t)(p->motion - fit->motions);
    for (size_t i = 0; i < fit->number_count; i++) {
        const whirl_fit_number *number = &fit->numbers[i];
        if (number->motion != motion) continue;
        probe_view view = {.probe = &machine->system->probes[number->station],
                           .cos = cos(number->angle),
                           .sin = sin(number->angle),
                           .speed = machine->speed};
        memcpy(view.lengths, lengths, sizeof view.lengths);
        view_number(&view, orbit, number, &model[i], slopes + i * fit->unknown_count);
    }
}

/// Notes an orbit as the one tried.
static whirl_status place_note(const fit_place *p, const whirl_machine *machine, const whirl_orbit *orbit,
                               const whirl_orbit_sensitivity *derived, fit_orbit *out) {
    const whirl_status status = fit_place_note(p, orbit->dimension, orbit->nodes, derived->slopes, out);
    if (status.code != WHIRL_OK) return status;
    out->largest = whirl_orbit_largest(orbit);
    out->speed = machine->speed;
    return status;
}

/// Returns the index of a motion's first number.
static size_t place_first(const fit_motions *m, size_t index) {
    size_t i = 0;
    while (i + 1 < m->fit->number_count && m->fit->numbers[i].motion != index) i++;
    return i;
}

/// Computes one motion: its orbit, or its threshold or mode, and its part of the model and of the derivatives.
static whirl_status place_compute(const fit_motions *m, size_t index, const double *values, double *slopes) {
    fit_place p;
    whirl_machine machine = {.system = NULL};
    whirl_orbit *orbit = NULL;
    whirl_orbit_sensitivity *derived = NULL;
    double lengths[1 + WHIRL_MAX_UNKNOWNS] = {1.0};
    fit_place_make(&p, m, index, values);
    // A threshold or a mode, in place of a motion, has a single number.
    const size_t first = place_first(m, index);
    const whirl_fit_number *number = &m->fit->numbers[first];
    double *own = slopes + first * m->fit->unknown_count;
    if (p.motion->statistics) return fit_statistics(&p, first, &m->tried[index], m->model, slopes);
    if (number->quantity == WHIRL_FIT_ORBIT_ONSET)
        return fit_orbit_onset(&p, &m->kept[index], &m->tried[index], &m->model[first], own);
    if (!whirl_fit_is_motion(number->quantity))
        return fit_at_rest(&p, number, &m->kept[index], &m->tried[index], &m->model[first], own);
    whirl_status status = fit_place_machine(&p, &machine);
    if (status.code == WHIRL_OK) status = place_check_speed(&p, &machine, &m->kept[index]);
    if (status.code == WHIRL_OK) status = place_find(&p, &machine, &m->kept[index], &orbit);
    if (status.code == WHIRL_OK) status = place_derive(&p, orbit, &derived, lengths);
    if (status.code == WHIRL_OK) place_numbers(&p, &machine, derived, lengths, m->model, slopes);
    if (status.code == WHIRL_OK) status = place_note(&p, &machine, orbit, derived, &m->tried[index]);
    whirl_orbit_sensitivity_free(derived);
    whirl_orbit_free(orbit);
    if (machine.release) machine.release(machine.owner);
    return status;
}

// ---------------------------------------------------------------- all motions

/// Replaces a residual by the one whose square is Huber's loss, and its derivatives: r up to k, then
/// sqrt(2 k |r| - k^2).
static void soften(double k, size_t count, double *residual, double *derivatives) {
    const double size = fabs(*residual);
    if (size <= k) return;
    const double less = sqrt(2.0 * k * size - k * k);
    for (size_t u = 0; u < count; u++) derivatives[u] *= k / less;
    *residual = copysign(less, *residual);
}

/// Notes that a motion is lost; the first one is reported.
static void motions_lose(fit_motions *m, size_t index, const whirl_status *status) {
    if (status->code == WHIRL_OK || index >= m->lost) return;
    m->lost = index;
    m->status = *status;
}

bool fit_motions_evaluate(void *motions, const double *values, double *residuals, double *derivatives) {
    // Compute all motions, those of runs together.
    fit_motions *m = motions;
    const whirl_fit *fit = m->fit;
    const size_t count = fit->unknown_count;
    m->lost = fit->motion_count;
    for (size_t i = 0; i < fit->motion_count; i++) {
        if (!fit->motions[i].run || fit->motions[i].run->first != i) continue;
        fit_place p;
        size_t lost = i;
        fit_place_make(&p, m, i, values);
        const whirl_status status = fit_run(&p, m->tried, m->model, derivatives, &lost);
        motions_lose(m, lost, &status);
    }
#pragma omp parallel for num_threads(m->threads) schedule(dynamic)
    for (size_t i = 0; i < fit->motion_count; i++) {
        const whirl_status status = fit->motions[i].run ? whirl_ok() : place_compute(m, i, values, derivatives);
#pragma omp critical(whirl_fit)
        motions_lose(m, i, &status);
    }
    if (m->goes_on && !m->goes_on(m->of)) m->status = whirl_fail(WHIRL_STOPPED, "stopped");
    if (m->lost < fit->motion_count || m->status.code == WHIRL_STOPPED) return false;
    m->status = whirl_ok();
    // Weigh residuals and derivatives by the noise; outliers count less with loss: huber.
    const whirl_fit_options *options = &m->batch->record.fit;
    const bool huber = strcmp(options->loss, "huber") == 0;
    for (size_t i = 0; i < fit->number_count; i++) {
        const double noise = fit->numbers[i].noise;
        residuals[i] = (m->model[i] - fit->numbers[i].value) / noise;
        for (size_t u = 0; u < count; u++) derivatives[i * count + u] /= noise;
        if (huber) soften(options->huber, count, &residuals[i], derivatives + i * count);
    }
    return true;
}
