// Other equilibria of a machine: those that searches from the equilibria of neighbouring points find. Without them a
// table would jump from one equilibrium to another unnoticed.
#include "kinds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Equilibria are the same if the displacements of stations differ by less than same_part of the larger one, or by less
/// than same_length length scales.
static const double same_part = 1e-5, same_length = 1e-10;

void known_rests_free(known_rests *rests) {
    for (size_t i = 0; i < 3; i++) free(rests->of[i].x);
    *rests = (known_rests){0};
}

/// Finds the equilibrium of a machine from its start; out->x is NULL if the search fails.
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

/// Finds the equilibrium of a point, or takes it from `rests`. `machine` is the machine of the point; NULL: it is made
/// here.
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
    own->known = true; // a machine that cannot be made has no equilibrium
    if (status.code != WHIRL_OK) return whirl_ok();
    status = rest_of(&made, own);
    if (made.release) made.release(made.owner);
    return status;
}

/// Returns true if the displacements of all stations are the same.
static bool is_same(const whirl_system *system, const double *a, const double *b) {
    double apart = 0.0, size = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        apart = fmax(apart, hypot(a[probe->x] - b[probe->x], a[probe->y] - b[probe->y]));
        size = fmax(size, fmax(hypot(a[probe->x], a[probe->y]), hypot(b[probe->x], b[probe->y])));
    }
    return !(apart > same_part * size + same_length);
}

/// Marks in loose [dimension] the coordinates that no force holds at x: idle ones (WHIRL_IDLE) that stay where they are
/// displaced to. A pad without a film but with a spring returns, so it is not loose. work: [2][dimension].
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

/// Sets *same if the equilibria x and `rest` differ only by their loose coordinates: if these are set as at `rest`, the
/// search from x leads to `rest`. No equation determines a loose pad, but the small force that its film still has moves
/// the journal.
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
    // Set loose coordinates as they are at `rest`, and search from there.
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

/// Searches for an equilibrium from a neighbour's, `from`. An equilibrium with rigid-body modes does not count as
/// another one.
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
    const known_rest *own, *neighbour;
    *elsewhere = NULL;
    whirl_status status = look_up(study, batch, values, slot, machine, rests, &own);
    *rest = own->x;
    for (size_t i = 0; i < 2 && status.code == WHIRL_OK && own->x && !*elsewhere; i++) {
        const size_t other = neighbours[i];
        if (other >= batch->count || (batch->row > 0 && other / batch->row != slot / batch->row)) continue;
        status = look_up(study, batch, values, other, NULL, rests, &neighbour);
        if (status.code == WHIRL_OK && neighbour->x && neighbour->dimension == own->dimension &&
            !is_same(machine->system, own->x, neighbour->x))
            status = follow(machine, own->x, neighbour->x, elsewhere, growth);
    }
    return status;
}
