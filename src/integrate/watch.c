#include "watch.h"

#include <math.h>

#include "kernels/watched_kernel.h"

static void watch_take(double *so_far, whirl_fold fold, double value) {
    *so_far = watched_with(fold, value, *so_far);
}

static void watch_probe(const whirl_probe *probe, size_t p, const double *x, size_t stride,
                        const whirl_ensemble_seen *seen) {
    const watched_instant now = watched_at(probe, x[probe->x], x[probe->y], x[probe->vx], x[probe->vy]);
#define WATCH(array, extent, columns, fold, ...)                                                                       \
    for (size_t c = 0; c < (columns); c++) watch_take(&seen->array[((columns)*p + c) * stride], fold, now.array[c]);
    WHIRL_WATCHED_OF_STATIONS(WATCH)
#undef WATCH
}

static void watch_contacts(const whirl_system *system, const double *x, size_t stride, const whirl_ensemble_seen *seen,
                           double *touching) {
    double force[WHIRL_MAX_CONTACTS], friction[WHIRL_MAX_CONTACTS][2];
    if (system->contact_count == 0) return;
    for (size_t c = 0; c < system->contact_count; c++) force[c] = friction[c][0] = friction[c][1] = 0.0;
    system->contacts(system->model, x, force);
    if (system->friction) system->friction(system->model, x, friction[0]);
    for (size_t c = 0; c < system->contact_count; c++) {
        watch_contact(force[c] > 0.0 ? 1.0 : 0.0, 1.0, 1.0, &touching[c * stride], &seen->contact_share[c * stride],
                      &seen->contact_number[c * stride]);
        watch_take(&seen->contact_force[c * stride], WHIRL_LARGEST, force[c]);
        watch_friction(friction[c][0], friction[c][1], &seen->contact_torque[c * stride],
                       &seen->contact_most[c * stride], &seen->contact_power[c * stride]);
    }
}

void watch_instant(const whirl_system *system, const double *x, size_t stride, const whirl_ensemble_seen *seen,
                   double *touching) {
    for (size_t i = 0; i < system->dimension; i++) {
        watch_take(&seen->low[i * stride], WHIRL_SMALLEST, x[i]);
        watch_take(&seen->high[i * stride], WHIRL_LARGEST, x[i]);
    }
    for (size_t p = 0; p < whirl_watched_probes(system); p++) watch_probe(&system->probes[p], p, x, stride, seen);
    watch_contacts(system, x, stride, seen, touching);
}

// ---------------------------------------------------------------- for motions that no ensemble carries

static void watch_begin(double *array, size_t count, whirl_fold fold) {
    for (size_t i = 0; i < count; i++) array[i] = fold_none(fold);
}

void whirl_seen_begin(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen, double *touching) {
    const size_t probes = whirl_watched_probes(system);
    watch_begin(seen->low, system->dimension, WHIRL_SMALLEST);
    watch_begin(seen->high, system->dimension, WHIRL_LARGEST);
#define BEGIN(array, extent, columns, fold, ...)                                                                       \
    watch_begin(seen->array, WHIRL_WATCHED_SIZE(extent, columns, probes, system->contact_count), fold);
    WHIRL_WATCHED(BEGIN)
#undef BEGIN
    if (system->contact_count > 0) system->contacts(system->model, x, touching);
    for (size_t c = 0; c < system->contact_count; c++) touching[c] = touching[c] > 0.0 ? 1.0 : 0.0;
}

void whirl_seen_instant(const whirl_system *system, const double *x, const whirl_ensemble_seen *seen,
                        double *touching) {
    watch_instant(system, x, 1, seen, touching);
}

void whirl_seen_end(const whirl_system *system, size_t instants, const whirl_ensemble_seen *seen) {
    const double share = 1.0 / (double)instants;
    const size_t probes = whirl_watched_probes(system);
#define END(array, extent, columns, fold, square, ...)                                                                 \
    for (size_t i = 0, all = WHIRL_WATCHED_SIZE(extent, columns, probes, system->contact_count); i < all; i++)         \
        seen->array[i] = fold_end(fold, square, seen->array[i], share);
    WHIRL_WATCHED(END)
#undef END
}
