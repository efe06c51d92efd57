// Records of data sets as measured numbers: what proximity probes saw, and the parameters of the machine.
#include "fit_record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit_speed.h"
#include "tree.h"
#include "two_pi.h"
#include "whirl/engine/analyze.h"
#include "whirl/internal/arrays.h"

/// The group of a data set's records in its file, and the place of its facts.
#define RECORDS "records"
#define FACTS "provenance"

enum { RECORD_TEXT = 1024 };

/// A record while it is read.
typedef struct record_reader {
    fit_maker *m;
    const fit_set *set;
    arrays_file *file;
    const char *path;
    size_t number, row;               ///< number from 1; row in the arrays of the file
    double speed, begin, rate, turns; ///< rad/s; revolutions at the first sample; Hz; samples a revolution, or 0
    bool runs;                        ///< the speed changes in the record; `speed` is that of its first sample
    size_t samples;
} record_reader;

/// Fails for the record.
#define RECORD_FAIL(r, ...) csv_fail(&(r)->m->table, 0, 0, __VA_ARGS__)

/// Reads one number of the record's row.
static whirl_status record_number(const record_reader *r, const char *name, double *out) {
    char path[CSV_TEXT];
    const size_t first[] = {r->row}, count[] = {1};
    snprintf(path, sizeof path, RECORDS "/%s", name);
    return arrays_read(r->file, path, first, count, out);
}

/// Finds the row of the record. A file of a single shard or record has not all of them.
static whirl_status record_find(record_reader *r) {
    static const char path[] = RECORDS "/" WHIRL_FIELD_DATASET_RECORD;
    arrays_item item;
    whirl_status status = arrays_find(r->file, path, &item);
    if (status.code != WHIRL_OK)
        return status.code == WHIRL_BAD_INPUT ? RECORD_FAIL(r, "it is no data set, which study: dataset makes")
                                              : status;
    const size_t first[] = {0}, count[] = {item.rank == 1 ? item.sizes[0] : 0};
    enum { MOST = 1 << 26 };
    if (count[0] > MOST) return RECORD_FAIL(r, "it has %zu records, expected at most %d", count[0], MOST);
    double *numbers = malloc((count[0] + 1) * sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the records of a data set");
    status = count[0] > 0 ? arrays_read(r->file, path, first, count, numbers) : whirl_ok();
    for (r->row = 0; r->row < count[0] && status.code == WHIRL_OK && numbers[r->row] != (double)r->number;) r->row++;
    if (status.code == WHIRL_OK && r->row == count[0])
        status = RECORD_FAIL(r, "it has no record %zu, but %zu others%s", r->number, count[0],
                             count[0] > 0 ? ", from 1 on" : "");
    free(numbers);
    return status;
}

/// Reads how the record was sampled.
static whirl_status record_sampling(record_reader *r) {
    arrays_item signals, rate;
    double factor = 1.0;
    r->runs = arrays_find(r->file, RECORDS "/" WHIRL_FIELD_DATASET_RATE, &rate).code == WHIRL_OK;
    if (r->runs != (r->set->runup != NULL))
        return r->runs
                   ? RECORD_FAIL(r, "record %zu shows a run, expected runup, with the keys of its data set", r->number)
                   : RECORD_FAIL(r, "record %zu shows a motion at a constant speed, expected no runup", r->number);
    whirl_status status = arrays_find(r->file, RECORDS "/" WHIRL_FIELD_DATASET_SIGNALS, &signals);
    if (status.code == WHIRL_OK && signals.rank != 3) status = RECORD_FAIL(r, "it is damaged");
    if (status.code == WHIRL_OK) r->samples = signals.sizes[2];
    if (status.code == WHIRL_OK) status = record_number(r, WHIRL_FIELD_DATASET_SPEED, &r->speed);
    if (status.code == WHIRL_OK) status = record_number(r, WHIRL_FIELD_DATASET_BEGIN, &r->begin);
    if (status.code == WHIRL_OK) status = arrays_number(r->file, RECORDS, "dataset_rate", &r->rate);
    if (status.code == WHIRL_OK) status = arrays_number(r->file, RECORDS, "dataset_per_revolution", &r->turns);
    if (status.code == WHIRL_OK) status = arrays_number(r->file, RECORDS, "clock_factor", &factor);
    if (status.code != WHIRL_OK) return status;
    if (fabs(factor - 1.0) > 1e-12)
        return RECORD_FAIL(r, "its angles count by a keyphasor that turns at another speed than the shaft");
    const bool turning = r->runs ? r->speed >= 0.0 : r->speed > 0.0;
    if (!turning || !(r->begin >= 0.0 && r->begin < 1.0)) return RECORD_FAIL(r, "it is damaged");
    if (r->turns > 0.0) r->rate = r->turns * r->speed / two_pi;
    return r->rate > 0.0 ? whirl_ok() : RECORD_FAIL(r, "it is damaged");
}

/// Finds a number after some words of a channel's description, ", gap 0.00127 m"; 0 without them.
static double record_word(const char *text, const char *words) {
    const char *found = strstr(text, words);
    return found ? strtod(found + strlen(words), NULL) : 0.0;
}

/// Adds a channel to the table if it is a proximity probe: "front [V]: proximity at disc, direction 0 deg, 7870 V/m,
/// gap 0.00127 m". A high pass changes the waveform, and leaves it out.
static whirl_status record_channel(record_reader *r, size_t channel, const char *text, double *numbers, bool *last) {
    static const char at[] = "]: proximity at ", along[] = ", direction ";
    char heading[CSV_TEXT], source[CSV_TEXT];
    const char *station = strstr(text, at), *direction = station ? strstr(station, along) : NULL;
    if (!direction || strstr(direction, ", high pass ")) return whirl_ok();
    const double degrees = strtod(direction + strlen(along), NULL), gap = record_word(direction, ", gap ");
    const bool volts = station > text + 1 && station[-1] == 'V' && station[-2] == '[';
    const double sensitivity = volts ? record_word(direction, " deg, ") : 1.0;
    if (!(fabs(sensitivity) > 0.0)) return RECORD_FAIL(r, "channel %zu has no sensitivity", channel + 1);
    // Read the signal: sensitivity (gap + displacement).
    const size_t first[] = {r->row, channel, 0}, count[] = {1, 1, r->samples};
    whirl_status status = arrays_read(r->file, RECORDS "/" WHIRL_FIELD_DATASET_SIGNALS, first, count, numbers);
    for (size_t i = 0; i < r->samples && status.code == WHIRL_OK; i++) {
        if (!isfinite(numbers[i]))
            return RECORD_FAIL(r, "record %zu has no signals, as its motion did not last", r->number);
        numbers[i] = numbers[i] / sensitivity - gap;
    }
    station += strlen(at);
    const size_t used = (size_t)(direction - station);
    if (used + 32 > sizeof heading) return whirl_ok();
    char angle[32];
    snprintf(angle, sizeof angle, "%.9g", degrees);
    snprintf(heading, sizeof heading, "%.*s %s", (int)used, station,
             degrees == 0.0    ? "x"
             : degrees == 90.0 ? "y"
                               : angle);
    snprintf(source, sizeof source, "channel %zu", channel + 1);
    *last = true;
    return status.code == WHIRL_OK ? csv_add_vector(&r->m->table, heading, "m", source, numbers, r->samples) : status;
}

/// Adds the time and all probes to the table. The mark is at the x axis at time 0; the time of a run is 0 at its first
/// sample.
static whirl_status record_channels(record_reader *r) {
    char name[CSV_TEXT], text[RECORD_TEXT];
    double *numbers = malloc((r->samples + 1) * sizeof *numbers);
    bool any = false;
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    const double first = r->runs ? 0.0 : r->begin * two_pi / r->speed;
    for (size_t i = 0; i < r->samples; i++) numbers[i] = first + (double)i / r->rate;
    whirl_status status = csv_add_vector(&r->m->table, "time", "s", "time", numbers, r->samples);
    for (size_t channel = 0; status.code == WHIRL_OK; channel++) {
        snprintf(name, sizeof name, "dataset channel %zu", channel + 1);
        status = arrays_text(r->file, FACTS, name, text, sizeof text);
        if (status.code != WHIRL_OK || !*text) break;
        status = record_channel(r, channel, text, numbers, &any);
    }
    free(numbers);
    if (status.code != WHIRL_OK || any) return status;
    return RECORD_FAIL(r, "there is no proximity probe without a high pass, expected one that sees displacements");
}

/// Returns true for a parameter that is looked for, or given for the set.
static bool record_parameter_is_taken(const record_reader *r, const parameter *own) {
    const fit_parts *parts = r->m->parts;
    for (size_t u = 0; u < parts->unknown_count; u++)
        if (parts->unknowns[u].parameter == own) return true;
    for (size_t i = 0; i < r->set->at.count; i++)
        if (r->set->at.parameters[i] == own) return true;
    return false;
}

/// Adds the values of parameters that differ between records, and the speed.
static whirl_status record_parameters(record_reader *r) {
    char name[CSV_TEXT], text[RECORD_TEXT];
    const parameter_table *all = r->m->reader->parameters;
    const parameter *speed = r->runs ? NULL : fit_speed_parameter(r->m->reader, r->m->parts, r->set);
    whirl_given *given = arena_take(r->m->reader->arena, (FIT_MAX_AT + 1) * sizeof *given);
    if (!given) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    size_t count = 0;
    for (; count < r->m->at_count; count++) given[count] = r->m->at[count];
    whirl_status status = whirl_ok();
    for (size_t i = 0; status.code == WHIRL_OK; i++) {
        snprintf(name, sizeof name, "dataset parameter %zu", i + 1);
        status = arrays_text(r->file, FACTS, name, text, sizeof text);
        if (status.code != WHIRL_OK || !*text) break;
        const size_t index = parameters_find(all, text);
        if (index == all->count || record_parameter_is_taken(r, &all->items[index])) continue;
        const parameter *own = &all->items[index];
        if (own->value.expression) continue; // it follows from others
        if (count == FIT_MAX_AT)
            return RECORD_FAIL(r, "record %zu gives more than %d parameters", r->number, FIT_MAX_AT);
        const size_t first[] = {r->row, i}, one[] = {1, 1};
        given[count].name = own->name;
        status = arrays_read(r->file, RECORDS "/" WHIRL_FIELD_DATASET_VALUES, first, one, &given[count].value);
        if (status.code == WHIRL_OK && !isfinite(given[count].value)) status = RECORD_FAIL(r, "it is damaged");
        if (own == speed) speed = NULL;
        count++;
    }
    if (speed) given[count++] = (whirl_given){speed->name, r->speed};
    if (!r->runs && !fit_shaft_parameter(r->m->reader, r->m->parts)) r->m->speed = r->speed;
    r->m->record.is = r->runs;
    r->m->record.angle = two_pi * r->begin;
    r->m->record.speed = r->speed;
    r->m->record.duration = (double)r->samples / r->rate;
    r->m->at = given;
    r->m->at_count = count;
    return status;
}

whirl_status fit_record_read(fit_maker *m, const fit_set *set, const char *path, size_t number) {
    record_reader r = {.m = m, .set = set, .path = path, .number = number};
    m->table = (csv_table){.path = path, .vectors = true};
    whirl_status status = arrays_open(path, &r.file);
    if (status.code == WHIRL_OK) status = record_find(&r);
    if (status.code == WHIRL_OK) status = record_sampling(&r);
    if (status.code == WHIRL_OK) status = record_channels(&r);
    if (status.code == WHIRL_OK) status = record_parameters(&r);
    arrays_close(r.file);
    return status;
}
