// Makes the record that a motion on an orbit would have, stable or not.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "record_block.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/orbit.h"

/// The states of an orbit at equal time steps: the first at its beginning, which is also its end.
typedef struct path {
    size_t count, dimension, next;
    double per_revolution; ///< steps per revolution
    double *states;        ///< [count][dimension]
} path;

static void orbit_record_keep(void *context, double t, const double *x) {
    path *p = context;
    (void)t;
    p->next = (p->next + 1) % p->count;
    memcpy(p->states + p->next * p->dimension, x, p->dimension * sizeof *x);
}

/// Returns the number of instants of a segment. A revolution has as many instants as the options have steps; an orbit
/// with a free period has as many in its whole period. For an orbit of whole revolutions the number is raised until
/// samples fall on instants.
static size_t instants_of(const whirl_orbit *orbit, const whirl_orbit_options *options, size_t samples) {
    const size_t steps = (size_t)options->integrate.steps_per_revolution;
    const size_t segments = orbit->segment_count / (orbit->revolutions > 0 ? orbit->revolutions : 1);
    size_t instants = (steps + segments - 1) / segments;
    while (orbit->revolutions > 0 && instants * segments % samples != 0) instants++;
    return instants;
}

/// Computes the states of an orbit. Freed by free(p->states).
static whirl_status orbit_record_follow(const whirl_system *system, const whirl_orbit *orbit,
                                        const whirl_orbit_options *options, size_t samples, path *p) {
    const bool rests = orbit->period == 0.0;
    const size_t instants = rests ? 1 : instants_of(orbit, options, samples);
    *p = (path){.count = rests ? 1 : instants * orbit->segment_count, .dimension = orbit->dimension};
    p->per_revolution = rests ? 0.0 : system->period / orbit->period * (double)p->count;
    p->states = malloc(p->count * p->dimension * sizeof *p->states);
    if (!p->states) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the path of an orbit");
    memcpy(p->states, orbit->nodes, p->dimension * sizeof *p->states);
    return rests ? whirl_ok() : whirl_orbit_observe(system, orbit, options, instants, orbit_record_keep, p);
}

/// Interpolates the state after a number of revolutions, by a cubic between two states of the path. The slope at a
/// state is that of the chord from the state before to the state after.
static void state_after(const path *p, double revolutions, double *x) {
    const double at = fmod(revolutions * p->per_revolution, (double)p->count), whole = floor(at + 1e-9);
    const double s = fabs(at - whole) <= 1e-9 ? 0.0 : at - whole;
    const double *z[4];
    for (size_t i = 0; i < 4; i++) z[i] = p->states + (((size_t)whole + p->count - 1 + i) % p->count) * p->dimension;
    for (size_t i = 0; i < p->dimension; i++) {
        const double rise = z[2][i] - z[1][i], from = 0.5 * (z[2][i] - z[0][i]), to = 0.5 * (z[3][i] - z[1][i]);
        const double bend = s * (1.0 - s) * ((1.0 - s) * (from - rise) - s * (to - rise));
        x[i] = z[1][i] + (s > 0.0 ? s * rise + bend : 0.0);
    }
}

/// Observes bounds, and all that is watched, along one period of the orbit; counts are those of the whole record.
static whirl_status orbit_record_observe(const whirl_system *system, const path *p, whirl_record *record) {
#define SEEN(array, ...) .array = record->array,
    const whirl_ensemble_seen seen = {.low = record->low, .high = record->high, WHIRL_WATCHED(SEEN)};
#undef SEEN
    double *touching = calloc(system->contact_count + 1, sizeof *touching);
    if (!touching) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the contacts of an orbit");
    whirl_seen_begin(system, p->states, &seen, touching);
    for (size_t i = 0; i < p->count; i++)
        whirl_seen_instant(system, p->states + (i + 1) % p->count * p->dimension, &seen, touching);
    whirl_seen_end(system, p->count, &seen);
    const double times = (double)record->record_count * p->per_revolution / (double)p->count;
    for (size_t c = 0; c < system->contact_count; c++)
        record->contact_number[c] = round(times * record->contact_number[c]);
    free(touching);
    return whirl_ok();
}

/// Writes sections and waveforms, revolution after revolution.
static void write_revolutions(const whirl_system *system, const path *p, whirl_record *record) {
    const size_t samples = record->samples_per_revolution;
    double *x = record->end;
    record->section_count = record->record_count;
    record->sample_count = record->record_count * samples;
    for (size_t n = 0; n < record->record_count; n++) {
        for (size_t i = 0; i < samples; i++) {
            const size_t at = n * samples + i;
            state_after(p, (double)n + (double)(i + 1) / (double)samples, x);
            for (size_t k = 0; k < 2 * whirl_watched_probes(system); k++)
                record->waveform[k * record->sample_count + at] = whirl_probe_value(&system->probes[k / 2], x, k % 2);
        }
        state_after(p, (double)(n + 1), x);
        memcpy(record->section + n * record->dimension, x, record->dimension * sizeof *x);
    }
}

whirl_status whirl_record_along(const whirl_system *system, const whirl_orbit *orbit,
                                const whirl_orbit_options *options, const whirl_record_options *wanted,
                                whirl_record **out) {
    whirl_record_options own = *wanted;
    own.transient = own.watch = 0;
    own.growth = WHIRL_GROWTH_NONE;
    own.orbits = false;
    *out = NULL;
    whirl_status status = whirl_record_check(system, &options->integrate, &own);
    path p = {.states = NULL};
    const size_t samples = (size_t)whirl_record_samples(&own, options->integrate.steps_per_revolution);
    if (status.code == WHIRL_OK) status = orbit_record_follow(system, orbit, options, samples, &p);
    whirl_record *record = status.code == WHIRL_OK ? record_new(system, &options->integrate, &own) : NULL;
    if (status.code == WHIRL_OK && !record) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    if (status.code == WHIRL_OK) status = orbit_record_observe(system, &p, record);
    if (status.code == WHIRL_OK) {
        write_revolutions(system, &p, record);
        record_close_turns(record);
        *out = record;
    } else
        whirl_record_free(record);
    free(p.states);
    return status;
}
