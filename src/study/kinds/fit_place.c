#include "fit_place.h"
#include "orbit_options.h"
#include "turns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_place_make(fit_place *p, const fit_motions *of, size_t index, const double *values) {
    const whirl_fit_options *fit = &of->batch->record.fit;
    *p = (fit_place){.of = of, .motion = &of->fit->motions[index], .values = values, .batch = *of->batch};
    size_t count = 0;
    for (size_t i = 0; i < p->motion->given_count; i++) p->given[count++] = p->motion->given[i];
    for (size_t i = 0; i < of->fit->unknown_count; i++)
        p->given[count++] = (whirl_given){of->fit->unknowns[i].name, values[i]};
    p->batch.given = p->given;
    p->batch.given_count = count;
    p->batch.speed = p->motion->run ? 0.0 : p->motion->speed;
    p->options = orbit_options_by(fit->method, fit->rtol);
}

whirl_status fit_place_machine(const fit_place *p, whirl_machine *machine) {
    return p->of->study->machine(p->of->study->family, &p->batch, NAN, machine);
}

/// Returns true if a state repeats the state `before`, to 1e-6 of the largest coordinate.
static bool place_repeats(const whirl_system *system, const double *before, const double *x) {
    double change = 0.0, size = 0.0;
    for (size_t i = 0; i < system->dimension; i++) {
        change = fmax(change, fabs(part_apart(system->turns, system->angles, i, x, before)));
        if (!turns_on(system->turns, i)) size = fmax(size, fabs(x[i]));
    }
    return change <= 1e-6 * size;
}

/// Moves x towards its orbit over *left revolutions. `early`: it may end where x repeats after the orbit's period.
static whirl_status place_settle(const fit_place *p, const whirl_system *system, bool early, int *left, double *x) {
    const int period = p->of->batch->record.fit.revolutions;
    const size_t n = system->dimension;
    whirl_integrate_options options = p->options.integrate;
    whirl_integrator *integrator = NULL;
    options.rtol = fmax(options.rtol, 1e-8);
    options.atol = fmax(options.atol, 1e-10);
    double *before = malloc((n + 1) * sizeof *before);
    whirl_status status = before ? whirl_integrator_new(system, &options, &integrator)
                                 : whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion of a fit");
    for (bool near = false; *left > 0 && status.code == WHIRL_OK && !near; --*left) {
        const int turn = (p->of->batch->record.fit.transient - *left) % period;
        if (turn == 0) memcpy(before, x, n * sizeof *x);
        if (whirl_integrator_revolve(integrator, x, NULL, NULL) != WHIRL_BOUNDED)
            status = whirl_fail(WHIRL_BAD_INPUT, "its motion leaves its bounds after %d revolutions",
                                p->of->batch->record.fit.transient - *left);
        near = early && turn == period - 1 && place_repeats(system, before, x);
    }
    whirl_integrator_free(integrator);
    free(before);
    return status;
}

whirl_status fit_place_begin(const fit_place *p, const whirl_system *system, double *x, whirl_orbit **orbit) {
    const size_t revolutions = (size_t)p->of->batch->record.fit.revolutions;
    int left = p->of->batch->record.fit.transient;
    whirl_status status = place_settle(p, system, true, &left, x);
    if (status.code != WHIRL_OK) return status;
    status = whirl_orbit_find(system, x, revolutions, &p->options, orbit);
    if (left == 0 || status.code == WHIRL_NO_MEMORY || (status.code == WHIRL_OK && whirl_orbit_largest(*orbit) < 1.0))
        return status;
    whirl_orbit_free(*orbit);
    *orbit = NULL;
    status = place_settle(p, system, false, &left, x);
    return status.code == WHIRL_OK ? whirl_orbit_find(system, x, revolutions, &p->options, orbit) : status;
}

whirl_status fit_place_note(const fit_place *p, size_t dimension, const double *node, const double *slopes,
                            fit_orbit *out) {
    const size_t count = p->of->fit->unknown_count;
    double *numbers = calloc((1 + count) * dimension + 1, sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a number of a fit");
    free(out->node);
    *out = (fit_orbit){
        .dimension = dimension, .node = numbers, .slopes = numbers + dimension, .largest = NAN, .speed = NAN};
    memcpy(out->at, p->values, count * sizeof *p->values);
    if (dimension > 0) memcpy(out->node, node, dimension * sizeof *node);
    if (dimension > 0 && slopes) memcpy(out->slopes, slopes, count * dimension * sizeof *slopes);
    return whirl_ok();
}

void fit_place_unknowns(const fit_place *p, varied_parameter out[WHIRL_MAX_UNKNOWNS]) {
    for (size_t u = 0; u < p->of->fit->unknown_count; u++) {
        const whirl_fit_unknown *own = &p->of->fit->unknowns[u];
        const double reach = 1e-3 * (own->high - own->low);
        out[u] = (varied_parameter){.name = own->name, .value = p->values[u]};
        if (p->values[u] == 0.0) out[u].reach = isfinite(reach) ? reach : 1e-3;
    }
}
