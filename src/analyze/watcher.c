// What is gathered at every instant of the record. Radii are kept squared and shares as sums until the record is closed.
#include "watcher.h"

#include <math.h>

static void watch_coordinates(whirl_record *record, const double *x) {
    for (size_t i = 0; i < record->dimension; i++) {
        record->low[i] = x[i] < record->low[i] ? x[i] : record->low[i];
        record->high[i] = x[i] > record->high[i] ? x[i] : record->high[i];
    }
}

static void watch_probes(whirl_record *record, const double *x) {
    for (size_t i = 0; i < record->probe_count; i++) {
        const whirl_probe *probe = &record->probes[i];
        const double px = x[probe->x], py = x[probe->y];
        const double square = px * px + py * py;
        record->max_radius[i] = square > record->max_radius[i] ? square : record->max_radius[i];
        record->min_radius[i] = square < record->min_radius[i] ? square : record->min_radius[i];
        record->mean[2 * i] += px;
        record->mean[2 * i + 1] += py;
        record->backward[i] += px * x[probe->vy] - py * x[probe->vx] < 0.0 ? 1.0 : 0.0;
    }
}

static void watch_contacts(instant_watcher *watcher, const double *x) {
    whirl_record *record = watcher->record;
    double force[WHIRL_MAX_CONTACTS];
    if (record->contact_count == 0) return;
    watcher->system->contacts(watcher->system->model, x, force);
    for (size_t i = 0; i < record->contact_count; i++) {
        const bool touching = force[i] > 0.0;
        record->contact_share[i] += touching ? 1.0 : 0.0;
        record->contact_number[i] += touching && !watcher->touching[i] ? 1.0 : 0.0;
        record->contact_force[i] = force[i] > record->contact_force[i] ? force[i] : record->contact_force[i];
        watcher->touching[i] = touching;
    }
}

void watch_instant(void *observer, double t, const double *x) {
    instant_watcher *watcher = observer;
    whirl_record *record = watcher->record;
    (void)t;
    watch_coordinates(record, x);
    watch_probes(record, x);
    watch_contacts(watcher, x);
    watcher->instants++;
    if (watcher->stride == 0 || watcher->instants % watcher->stride != 0) return;
    const size_t n = record->sample_count++;
    for (size_t i = 0; i < record->probe_count; i++) {
        record->waveform[2 * i * watcher->sample_capacity + n] = x[record->probes[i].x];
        record->waveform[(2 * i + 1) * watcher->sample_capacity + n] = x[record->probes[i].y];
    }
}

void watch_open(instant_watcher *watcher, const whirl_system *system, const whirl_integrate_options *integrate,
                whirl_record *record) {
    *watcher = (instant_watcher){.system = system, .record = record};
    if (record->samples_per_revolution > 0) {
        watcher->stride = (size_t)integrate->steps_per_revolution / record->samples_per_revolution;
        watcher->sample_capacity = record->record_count * record->samples_per_revolution;
    }
    for (size_t i = 0; i < record->dimension; i++) {
        record->low[i] = INFINITY;
        record->high[i] = -INFINITY;
    }
    for (size_t i = 0; i < record->probe_count; i++) record->min_radius[i] = INFINITY;
}

void watch_note_contacts(instant_watcher *watcher, const double *x) {
    double force[WHIRL_MAX_CONTACTS];
    if (watcher->record->contact_count == 0) return;
    watcher->system->contacts(watcher->system->model, x, force);
    for (size_t i = 0; i < watcher->record->contact_count; i++) watcher->touching[i] = force[i] > 0.0;
}

void watch_close(const instant_watcher *watcher) {
    whirl_record *record = watcher->record;
    const double share = 1.0 / (double)watcher->instants;
    for (size_t i = 0; i < record->probe_count; i++) {
        record->max_radius[i] = sqrt(record->max_radius[i]);
        record->min_radius[i] = sqrt(record->min_radius[i]);
        record->mean[2 * i] *= share;
        record->mean[2 * i + 1] *= share;
        record->backward[i] *= share;
    }
    for (size_t i = 0; i < record->contact_count; i++) record->contact_share[i] *= share;
}
