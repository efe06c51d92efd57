// What is gathered at every instant of the record. Radii are kept squared and shares as sums until the record is
// closed.
#include "observer.h"

#include <math.h>

static void observe_coordinates(whirl_record *record, const double *x) {
    for (size_t i = 0; i < record->dimension; i++) {
        record->low[i] = x[i] < record->low[i] ? x[i] : record->low[i];
        record->high[i] = x[i] > record->high[i] ? x[i] : record->high[i];
    }
}

static void observe_probes(whirl_record *record, const double *x) {
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

static void observe_contacts(observer *o, const double *x) {
    whirl_record *record = o->record;
    double force[WHIRL_MAX_CONTACTS];
    if (record->contact_count == 0) return;
    o->system->contacts(o->system->model, x, force);
    for (size_t i = 0; i < record->contact_count; i++) {
        const bool touching = force[i] > 0.0;
        record->contact_share[i] += touching ? 1.0 : 0.0;
        record->contact_number[i] += touching && !o->touching[i] ? 1.0 : 0.0;
        record->contact_force[i] = force[i] > record->contact_force[i] ? force[i] : record->contact_force[i];
        o->touching[i] = touching;
    }
}

void observer_instant(void *context, double t, const double *x) {
    observer *o = context;
    whirl_record *record = o->record;
    (void)t;
    observe_coordinates(record, x);
    observe_probes(record, x);
    observe_contacts(o, x);
    o->instants++;
    if (o->stride == 0 || o->instants % o->stride != 0) return;
    const size_t n = record->sample_count++;
    for (size_t i = 0; i < record->probe_count; i++) {
        record->waveform[2 * i * o->sample_capacity + n] = x[record->probes[i].x];
        record->waveform[(2 * i + 1) * o->sample_capacity + n] = x[record->probes[i].y];
    }
}

void observer_open(observer *o, const whirl_system *system, const whirl_integrate_options *integrate,
                   whirl_record *record) {
    *o = (observer){.system = system, .record = record};
    if (record->samples_per_revolution > 0) {
        o->stride = (size_t)integrate->steps_per_revolution / record->samples_per_revolution;
        o->sample_capacity = record->record_count * record->samples_per_revolution;
    }
    for (size_t i = 0; i < record->dimension; i++) {
        record->low[i] = INFINITY;
        record->high[i] = -INFINITY;
    }
    for (size_t i = 0; i < record->probe_count; i++) record->min_radius[i] = INFINITY;
}

void observer_note_contacts(observer *o, const double *x) {
    double force[WHIRL_MAX_CONTACTS];
    if (o->record->contact_count == 0) return;
    o->system->contacts(o->system->model, x, force);
    for (size_t i = 0; i < o->record->contact_count; i++) o->touching[i] = force[i] > 0.0;
}

void observer_close(const observer *o) {
    whirl_record *record = o->record;
    const double share = 1.0 / (double)o->instants;
    for (size_t i = 0; i < record->probe_count; i++) {
        record->max_radius[i] = sqrt(record->max_radius[i]);
        record->min_radius[i] = sqrt(record->min_radius[i]);
        record->mean[2 * i] *= share;
        record->mean[2 * i + 1] *= share;
        record->backward[i] *= share;
    }
    for (size_t i = 0; i < record->contact_count; i++) record->contact_share[i] *= share;
}
