// Other places of rest of a machine: those to which the places of rest of neighbouring points lead. A table that steps
// from one to another would else do so without a word.
#include "kinds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Places that differ by less than this part of the larger one, or of a length scale times the second, are one.
static const double same_part = 1e-5, same_length = 1e-10;

void known_rests_free(known_rests *rests) {
    for (size_t i = 0; i < 3; i++) free(rests->of[i].x);
    *rests = (known_rests){0};
}

/// Finds where a machine rests from its start; nowhere where the search fails.
static whirl_status rest_of(const whirl_machine *machine, known_rest *out) {
    const size_t d = machine->system->dimension;
    out->dimension = d;
    out->x = malloc((d + 1) * sizeof *out->x);
    if (!out->x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the place of rest of %zu coordinates", d);
    memcpy(out->x, machine->start, d * sizeof *out->x);
    const whirl_status status = whirl_equilibrium(machine->system, out->x);
    out->known = status.code != WHIRL_NO_MEMORY;
    if (status.code == WHIRL_OK) return status;
    free(out->x);
    out->x = NULL;
    return out->known ? whirl_ok() : status;
}

/// The rest of a point, kept where it is known already; `machine`: of it, NULL: to be made.
static whirl_status look_up(const whirl_study *study, const whirl_batch *batch, const double *values, size_t slot,
                            const whirl_machine *machine, known_rests *rests, const known_rest **out) {
    known_rest *own = &rests->of[slot % 3];
    whirl_machine made;
    *out = own;
    if (own->known && own->slot == slot) return whirl_ok();
    free(own->x);
    *own = (known_rest){.slot = slot};
    if (machine) return rest_of(machine, own);
    whirl_status status = study->machine(study->family, batch, values[slot], &made);
    if (status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED) return status;
    own->known = true; // a machine that cannot be made rests nowhere
    if (status.code != WHIRL_OK) return whirl_ok();
    status = rest_of(&made, own);
    if (made.release) made.release(made.owner);
    return status;
}

/// Returns true if stations are at the same places.
static bool is_same(const whirl_system *system, const double *a, const double *b) {
    double apart = 0.0, size = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        apart = fmax(apart, hypot(a[probe->x] - b[probe->x], a[probe->y] - b[probe->y]));
        size = fmax(size, fmax(hypot(a[probe->x], a[probe->y]), hypot(b[probe->x], b[probe->y])));
    }
    return !(apart > same_part * size + same_length);
}

/// Writes which coordinates nothing holds at x (work [2][dimension]): idle ones (whirl_settled) that stay where they
/// are put. A pad without a film but with a spring comes back.
static void find_loose(const whirl_system *system, const double *x, double *work, whirl_settled *kinds, bool *loose) {
    const size_t d = system->dimension;
    const double aside = 0x1p-13;
    double *moved = work + d;
    memcpy(work, x, d * sizeof *x);
    if (!system->settle(system->model, work, kinds)) return;
    for (size_t i = 0; i < d; i++) work[i] = kinds[i] == WHIRL_IDLE;
    for (size_t i = 0; i < d; i++) {
        if (work[i] == 0.0) continue;
        memcpy(moved, x, d * sizeof *x);
        const double there = moved[i] += aside;
        loose[i] = loose[i] || (system->settle(system->model, moved, kinds) && moved[i] == there);
    }
}

/// Returns true if the machine rests at x and at `rest` because what nothing holds stands otherwise: with that as at
/// `rest`, the search from x leads to `rest`. What an idle pad's film still carries moves the others, and no equation
/// says how the pad stands: a place of rest is known to that.
static whirl_status is_loosely_same(const whirl_system *system, const double *x, const double *rest, bool *same) {
    // Only systems with coordinates that settle by themselves have loose ones.
    const size_t d = system->dimension;
    bool any = false;
    *same = false;
    if (!system->settle) return whirl_ok();
    double *work = calloc(3 * d, sizeof *work);
    whirl_settled *kinds = calloc(d, sizeof *kinds);
    bool *loose = calloc(d, sizeof *loose);
    whirl_status status = whirl_ok();
    // Put loose coordinates as they are at `rest`, and search from there.
    if (work && kinds && loose) {
        find_loose(system, x, work, kinds, loose);
        find_loose(system, rest, work, kinds, loose);
        for (size_t i = 0; i < d; i++) {
            work[i] = loose[i] ? rest[i] : x[i];
            any = any || work[i] != x[i];
        }
        if (any) status = whirl_equilibrium(system, work);
        *same = any && status.code == WHIRL_OK && is_same(system, work, rest);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the place of rest of %zu coordinates", d);
    }
    free(work);
    free(kinds);
    free(loose);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

/// Goes from a neighbour's place to where the machine rests near it. A place that moves free, to which no force brings
/// it back, is no other one.
static whirl_status follow(const whirl_machine *machine, const double *rest, const double *from, double **elsewhere,
                           double *growth) {
    const size_t d = machine->system->dimension;
    whirl_modes *modes = NULL;
    double *x = malloc((d + 1) * sizeof *x);
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the place of rest of %zu coordinates", d);
    memcpy(x, from, d * sizeof *x);
    whirl_status status = whirl_equilibrium(machine->system, x);
    bool same = status.code != WHIRL_OK || is_same(machine->system, x, rest);
    if (!same) status = is_loosely_same(machine->system, x, rest, &same);
    if (status.code == WHIRL_OK && !same) {
        status = whirl_modes_new(machine->system, x, &modes);
        if (status.code == WHIRL_OK && modes->free == 0 && !(modes->period > 0.0)) {
            *growth = modes->growth;
            *elsewhere = x;
            x = NULL;
        }
        whirl_modes_free(modes);
    }
    free(x);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

whirl_status elsewhere_find(const whirl_study *study, const whirl_batch *batch, const double *values, size_t slot,
                            const whirl_machine *machine, known_rests *rests, const double **rest, double **elsewhere,
                            double *growth) {
    const size_t neighbours[] = {slot - 1, slot + 1};
    const known_rest *own, *beside;
    *elsewhere = NULL;
    whirl_status status = look_up(study, batch, values, slot, machine, rests, &own);
    *rest = own->x;
    for (size_t i = 0; i < 2 && status.code == WHIRL_OK && own->x && !*elsewhere; i++) {
        const size_t other = neighbours[i];
        if (other >= batch->count || (batch->row > 0 && other / batch->row != slot / batch->row)) continue;
        status = look_up(study, batch, values, other, NULL, rests, &beside);
        if (status.code == WHIRL_OK && beside->x && beside->dimension == own->dimension &&
            !is_same(machine->system, own->x, beside->x))
            status = follow(machine, own->x, beside->x, elsewhere, growth);
    }
    return status;
}
