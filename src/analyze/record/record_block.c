// The memory of a record.
#include "record_block.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "archive.h"
#include "recurrence.h"
#include "section.h"
#include "turns.h"

int record_skip(const whirl_record_options *options, int revolution, size_t period) {
    enum { STILL_WATCHED = 64 };
    const int three = period > SHORT_PERIOD ? 3 * (int)period - options->record : 0;
    const int first_watched = options->transient + options->record - whirl_record_watch(options);
    const int late = options->transient - (three > STILL_WATCHED ? three : STILL_WATCHED);
    const int target = late > first_watched ? late : first_watched;
    return revolution < target ? target : revolution;
}

/// Numbers in every part of a record; lay_out fixes the order of the parts.
typedef struct sizes {
    size_t section, points, growth, growths, waveform, multipliers, dimension, probes, contacts;
} sizes;

static sizes record_block_measure(const whirl_system *system, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options) {
    const size_t watch = (size_t)whirl_record_watch(options);
    const size_t samples = (size_t)whirl_record_samples(options, integrate->steps_per_revolution);
    const size_t angles = turns_count(system->angles, system->dimension);
    return (sizes){.section = watch * system->dimension,
                   .points = angles > 0 ? watch * (system->dimension + angles) : 0,
                   .growth = options->growth != WHIRL_GROWTH_NONE ? watch : 0,
                   .growths = options->growth == WHIRL_GROWTH_ALL ? watch : 0,
                   .waveform =
                       options->waveform ? 2 * whirl_watched_probes(system) * (size_t)options->record * samples : 0,
                   .multipliers = options->orbits ? 2 * system->dimension : 0,
                   .dimension = system->dimension,
                   .probes = whirl_watched_probes(system),
                   .contacts = system->contact_count};
}

static double *record_block_cut(double **block, size_t count) {
    double *part = *block;
    *block += count;
    return part;
}

static void record_block_lay_out(whirl_record *record, double *block, const sizes *size) {
    record->section = record_block_cut(&block, size->section);
    if (size->points > 0) record->points = record_block_cut(&block, size->points);
    record->growth = record_block_cut(&block, size->growth);
    if (size->growths > 0) {
        record->growths = record_block_cut(&block, size->growths * size->dimension);
        record->volume = record_block_cut(&block, size->growths);
    }
    record->orbit.multipliers = record_block_cut(&block, size->multipliers);
    record->waveform = record_block_cut(&block, size->waveform);
    record->low = record_block_cut(&block, size->dimension);
    record->high = record_block_cut(&block, size->dimension);
    record->end = record_block_cut(&block, size->dimension);
#define CUT(array, extent, columns, ...)                                                                               \
    record->array = record_block_cut(&block, WHIRL_WATCHED_SIZE(extent, columns, size->probes, size->contacts));
    WHIRL_WATCHED(CUT)
#undef CUT
}

/// Returns how many numbers of a record are observed at every instant.
static size_t record_block_observed(size_t dimension, size_t probes, size_t contacts) {
#define COUNT(array, extent, columns, ...) +WHIRL_WATCHED_SIZE(extent, columns, probes, contacts)
    return 3 * dimension WHIRL_WATCHED(COUNT);
#undef COUNT
}

whirl_record *record_new(const whirl_system *system, const whirl_integrate_options *integrate,
                         const whirl_record_options *options) {
    // One allocation holds the record and its arrays.
    const sizes size = record_block_measure(system, integrate, options);
    const size_t numbers = size.section + size.points + size.growth + size.growths * (size.dimension + 1) +
                           size.waveform + size.multipliers +
                           record_block_observed(size.dimension, size.probes, size.contacts);
    whirl_record *record = calloc(1, sizeof *record + numbers * sizeof(double));
    if (!record) return NULL;
    record_block_lay_out(record, (double *)(record + 1), &size);
    // Copy what analyses need to know of the system.
    record->dimension = system->dimension;
    record->probe_count = system->probe_count;
    record->extra_count = system->extra_count;
    record->extras = system->extras;
    record->contact_count = system->contact_count;
    record->probes = system->probes;
    record->turns = system->turns;
    record->angles = system->angles;
    record->repeats = system->repeats;
    record->period = system->period;
    record->system = system;
    record->steps = (whirl_step_quality){(double)NAN, (double)NAN, 1.0};
    record->record_count = (size_t)options->record;
    if (options->waveform)
        record->samples_per_revolution = (size_t)whirl_record_samples(options, integrate->steps_per_revolution);
    return record;
}

/// Archives (saves or compares) options: a saved state continues only with the same ones.
static void options_archive(const whirl_member *member, const void *options, archive *a) {
    for (; member->part; member++) {
        const char *letter = (const char *)options + member->offset;
        if (member->type != WHIRL_MEMBER_WORD) archive_same(a, whirl_member_number(member, options));
        for (; member->type == WHIRL_MEMBER_WORD && *letter; letter++) archive_same(a, *letter);
    }
}

void record_archive(whirl_record *r, const whirl_integrate_options *integrate, const whirl_record_options *options,
                    archive *a) {
    const size_t samples = r->record_count * r->samples_per_revolution, probes = r->probe_count + r->extra_count;
    options_archive(whirl_integrate_members(), integrate, a);
    options_archive(whirl_record_members(), options, a);
    archive_same(a, (double)r->dimension);
    archive_same(a, (double)probes);
    archive_same(a, (double)r->contact_count);
    archive_part(a, &r->revolutions, sizeof r->revolutions);
    archive_part(a, &r->orbit.set_at, sizeof r->orbit.set_at);
    archive_part(a, &r->orbit.revolutions, sizeof r->orbit.revolutions);
    archive_count(a, &r->section_count, (size_t)whirl_record_watch(options));
    archive_count(a, &r->growth_count, options->growth ? (size_t)whirl_record_watch(options) : 0);
    archive_count(a, &r->sample_count, samples);
    archive_part(a, r->section, r->section_count * r->dimension * sizeof *r->section);
    archive_part(a, r->growth, r->growth_count * sizeof *r->growth);
    if (r->growths) archive_part(a, r->growths, r->growth_count * r->dimension * sizeof *r->growths);
    if (r->growths) archive_part(a, r->volume, r->growth_count * sizeof *r->volume);
    for (size_t i = 0; i < 2 * probes; i++)
        archive_part(a, r->waveform + i * samples, r->sample_count * sizeof *r->waveform);
    // The numbers observed at every instant follow the waveform, to the end.
    archive_part(a, r->low, record_block_observed(r->dimension, probes, r->contact_count) * sizeof *r->low);
}

/// Repeats the last k of `count` rows of `width` numbers over all rows before them.
static void repeat_rows(double *rows, size_t count, size_t width, size_t k) {
    for (size_t i = count - k; i-- > 0;) memcpy(rows + i * width, rows + (i + k) * width, width * sizeof *rows);
}

void record_begin_orbit(whirl_record *record, const whirl_record_options *options, size_t k) {
    record->section_count = (size_t)whirl_record_watch(options) - k;
    record->sample_count = options->waveform ? (record->record_count - k) * record->samples_per_revolution : 0;
    record->growth_count = 0;
}

void record_repeat_orbit(whirl_record *record, const whirl_record_options *options) {
    const size_t k = (size_t)record->orbit.period, samples = record->samples_per_revolution;
    const size_t probes = record->probe_count + record->extra_count;
    const double times = (double)record->record_count / (double)k;
    repeat_rows(record->section, record->section_count, record->dimension, k);
    for (size_t i = 0; i < 2 * probes && options->waveform; i++)
        repeat_rows(record->waveform + i * record->record_count * samples, record->record_count, samples, k);
#define REPEAT(array, extent, columns, fold, ...)                                                                      \
    for (size_t i = 0, all = WHIRL_WATCHED_SIZE(extent, columns, probes, record->contact_count); i < all; i++) {       \
        if ((fold) == WHIRL_MEAN) record->array[i] *= times;                                                           \
        if ((fold) == WHIRL_SUM) record->array[i] = round(record->array[i] * times);                                   \
    }
    WHIRL_WATCHED(REPEAT)
#undef REPEAT
    if (options->growth == WHIRL_GROWTH_NONE) return;
    record->growth_count = record->section_count;
    for (size_t n = 0; n < record->growth_count; n++) record->growth[n] = log(record->orbit.modulus) / (double)k;
}

void whirl_record_free(whirl_record *record) {
    free(record);
}

section record_points(const whirl_record *record) {
    const size_t d = record->dimension, wide = d + turns_count(record->angles, d);
    const double *x = record->section;
    double *to = record->points;
    if (!to) return (section){record->section_count, d, x};
    for (size_t n = 0; n < record->section_count; n++)
        for (size_t i = 0; i < d; i++, x++) {
            const double radius = turns_on(record->angles, i) ? record->angles[i] / two_pi : 0.0;
            *to++ = radius > 0.0 ? radius * cos(*x / radius) : *x;
            if (radius > 0.0) *to++ = radius * sin(*x / radius);
        }
    return (section){record->section_count, wide, record->points};
}

void record_close_turns(whirl_record *record) {
    for (size_t i = 0; i < record->dimension; i++) {
        if (!turns_on(record->turns, i)) continue;
        record->low[i] = record->high[i] = 0.0;
        for (size_t n = 0; n < record->section_count; n++) record->section[n * record->dimension + i] = 0.0;
    }
}

void record_place_perturbations(const whirl_record *record, size_t count, double *perturbations) {
    const double pi = 3.14159265358979323846;
    const size_t n = record->dimension, steady = n - turns_count(record->turns, n);
    memset(perturbations, 0, count * n * sizeof *perturbations);
    for (size_t i = 0, at = 0, last = steady; i < n; i++) {
        const bool turning = turns_on(record->turns, i);
        if (count < n) perturbations[i] = turning ? 0.0 : 1.0 / sqrt((double)n);
        if (count < n) continue;
        if (turning) perturbations[last++ * n + i] = 1.0;
        if (turning) continue;
        const double angle = pi * (double)++at / (double)(steady + 1);
        for (size_t k = 0; k < steady; k++)
            perturbations[k * n + i] = sqrt(2.0 / (double)(steady + 1)) * sin((double)(k + 1) * angle);
    }
}
