// Reads measured records as results: signals over time are resampled turn by turn and become a run of the study
// `runup`.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "two_pi.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/internal/csv.h"
#include "whirl/signals.h"

/// Largest number of probes of a record.
enum { MAX_CHANNELS = 2 * WHIRL_MAX_PROBES };
/// Sizes of the run.
enum {
    ROWS = 400,
    SPECTRA = 100,
    SPECTRUM_TURNS = 16,
    ORBITS = 8,
    MIN_SAMPLES = 32,
    MAX_SAMPLES = 256,
    POLYNOMIAL = 7
};

/// A column of the table.
typedef struct record_column {
    enum { COLUMN_TIME, COLUMN_KEYPHASOR, COLUMN_SPEED, COLUMN_CHANNEL } kind;
    char station[WHIRL_NAME_SIZE];
    double angle; ///< direction of a channel, rad from the x axis in the sense of rotation
    double size;  ///< SI per unit
    int place;    ///< position of its heading in the line, from 1, for messages
} record_column;

/// A record. Its numbers are in SI.
typedef struct record {
    csv_table table;
    record_column columns[MAX_CHANNELS + 3]; ///< kinds and units of the columns of `table`
    size_t station_count;
    whirl_probe stations[WHIRL_MAX_PROBES];
    size_t channels[WHIRL_MAX_PROBES][2]; ///< columns of the two probes of a station
} record;

/// Returns a failure with the position of a heading in the file.
#define RECORD_FAIL(r, at, ...) csv_fail(&(r)->table, (r)->table.heading, (at), __VA_ARGS__)

// ---------------------------------------------------------------- headings

/// Reads the heading of a column: "time [s]", "keyphasor [V]", "speed [rpm]", "de x [um]", "de 45 [mil]".
static whirl_status record_heading(record *r, size_t column) {
    // Columns of time, mark and speed have fixed names.
    const csv_column *heading = &r->table.columns[column];
    record_column *own = &r->columns[column];
    char text[CSV_TEXT], *end;
    *own = (record_column){.kind = COLUMN_CHANNEL, .size = 1.0, .place = heading->place};
    memcpy(text, heading->name, sizeof text);
    if (strcmp(text, "time") == 0) {
        own->kind = COLUMN_TIME;
        return csv_unit(&r->table, column, "s", "s", &own->size);
    }
    if (strcmp(text, "keyphasor") == 0) {
        own->kind = COLUMN_KEYPHASOR;
        return whirl_ok();
    }
    if (strcmp(text, "speed") == 0) {
        own->kind = COLUMN_SPEED;
        return csv_unit(&r->table, column, "rad/s", "rpm", &own->size);
    }
    // A probe is named by its station and its direction. Variables of MATLAB have no blanks: "de_x".
    char *direction = strrchr(text, ' ');
    if (!direction && r->table.vectors) direction = strrchr(text, '_');
    if (direction) *direction = ' ';
    if (!direction)
        return RECORD_FAIL(r, own->place,
                           "'%.40s' is no column, expected time, keyphasor, speed, or a station and the direction of a "
                           "probe: 'de x', 'de 45'",
                           text);
    // Read the direction: an axis or degrees from x.
    double degrees = strtod(direction + 1, &end);
    const bool axis = strcmp(direction + 1, "x") == 0 || strcmp(direction + 1, "y") == 0;
    if (axis) degrees = direction[1] == 'y' ? 90.0 : 0.0;
    if (!axis && (end == direction + 1 || *end || !isfinite(degrees)))
        return RECORD_FAIL(r, own->place, "'%.20s' is no direction of a probe, expected x, y or degrees from x",
                           direction + 1);
    // The text before it is the station.
    while (direction > text && isspace((unsigned char)direction[-1])) direction--;
    *direction = '\0';
    if (strlen(text) >= sizeof own->station)
        return RECORD_FAIL(r, own->place, "the name '%.20s...' of a station has %zu bytes, expected at most %zu", text,
                           strlen(text), sizeof own->station - 1);
    snprintf(own->station, sizeof own->station, "%s", text);
    own->angle = degrees * two_pi / 360.0;
    return csv_unit(&r->table, column, "m", "um", &own->size);
}

static const record_column *record_find(const record *r, int kind) {
    for (size_t c = 0; c < r->table.column_count; c++)
        if ((int)r->columns[c].kind == kind) return &r->columns[c];
    return NULL;
}

/// Finds the stations of the channels; each must have two probes.
static whirl_status record_stations(record *r) {
    // The time is needed, and a keyphasor or the speed.
    const record_column *time = record_find(r, COLUMN_TIME), *mark = record_find(r, COLUMN_KEYPHASOR);
    if (!time) return RECORD_FAIL(r, 1, "there is no column 'time [s]'");
    if (!mark && !record_find(r, COLUMN_SPEED))
        return RECORD_FAIL(r, 1, "there is neither a column 'keyphasor' nor a column 'speed [rpm]'");
    // Sort the channels by station; each has two.
    for (size_t c = 0; c < r->table.column_count; c++) {
        const record_column *own = &r->columns[c];
        if (own->kind != COLUMN_CHANNEL && record_find(r, (int)own->kind) != own)
            return RECORD_FAIL(r, own->place, "is a second column of this kind");
        if (own->kind != COLUMN_CHANNEL) continue;
        size_t s = 0;
        while (s < r->station_count && strcmp(r->stations[s].name, own->station) != 0) s++;
        if (s < r->station_count && r->channels[s][1] > 0)
            return RECORD_FAIL(r, own->place, "is a third probe at %.40s, expected two", own->station);
        if (s < r->station_count) {
            r->channels[s][1] = c;
            continue;
        }
        if (s == WHIRL_MAX_PROBES) return RECORD_FAIL(r, own->place, "has more than %d stations", WHIRL_MAX_PROBES);
        memcpy(r->stations[s].name, own->station, sizeof own->station);
        r->stations[s].x = 2 * s, r->stations[s].y = 2 * s + 1;
        r->channels[s][0] = c;
        r->station_count++;
    }
    // Refuse stations with one probe.
    for (size_t s = 0; s < r->station_count; s++)
        if (r->channels[s][1] == 0)
            return RECORD_FAIL(r, r->columns[r->channels[s][0]].place,
                               "%.40s has one probe, expected two: x and y, or two directions in degrees",
                               r->stations[s].name);
    return r->station_count > 0 ? whirl_ok()
                                : RECORD_FAIL(r, 1, "there is no probe, expected columns such as 'de x [um]'");
}

/// Reads all headings, converts numbers to SI and checks the time.
static whirl_status record_understand(record *r) {
    csv_table *table = &r->table;
    whirl_status status = whirl_ok();
    for (size_t c = 0; c < table->column_count && status.code == WHIRL_OK; c++) status = record_heading(r, c);
    if (status.code == WHIRL_OK && table->column_count > 0) status = record_stations(r);
    if (status.code != WHIRL_OK) return status;
    if (table->count < 16)
        return RECORD_FAIL(r, 1, "there are %zu rows of numbers, expected a line of headings and at least 16",
                           table->count);
    for (size_t c = 0; c < table->column_count; c++)
        for (size_t i = 0; i < table->count; i++) table->numbers[c * table->capacity + i] *= r->columns[c].size;
    const record_column *time = record_find(r, COLUMN_TIME);
    const double *instants = csv_numbers(table, (size_t)(time - r->columns));
    for (size_t i = 1; i < table->count; i++)
        if (!(instants[i] > instants[i - 1]))
            return csv_fail(table, table->lines[i], time->place, "the time %g s is not later than the one before",
                            instants[i]);
    return whirl_ok();
}

// ---------------------------------------------------------------- numbers

static const double *record_numbers(const record *r, const record_column *of) {
    return csv_numbers(&r->table, (size_t)(of - r->columns));
}

// ---------------------------------------------------------------- turns

/// Finds the instants at which turns begin: pulses of the keyphasor, or without it full turns of the integral of the
/// speed from the first sample on.
static whirl_status record_pulses(const record *r, double *instants, size_t *pulses) {
    const double *time = record_numbers(r, record_find(r, COLUMN_TIME));
    const record_column *mark = record_find(r, COLUMN_KEYPHASOR);
    double threshold, hysteresis, angle = 0.0;
    if (mark) {
        const double *voltage = record_numbers(r, mark);
        whirl_status status = whirl_signals_threshold(voltage, r->table.count, &threshold, &hysteresis);
        if (status.code == WHIRL_OK)
            status = whirl_signals_pulses(time, voltage, r->table.count, threshold, hysteresis, true, instants, pulses);
        return status;
    }
    // Integrate the speed, which is linear between samples.
    const double *speed = record_numbers(r, record_find(r, COLUMN_SPEED));
    *pulses = 0;
    for (size_t i = 0; i + 1 < r->table.count; i++) {
        const double span = time[i + 1] - time[i], turned = 0.5 * (speed[i] + speed[i + 1]) * span;
        for (double next = ceil(angle / two_pi) * two_pi; turned > 0.0 && next < angle + turned; next += two_pi) {
            // Within a step the angle is a parabola: find where it reaches a full turn.
            const double a = 0.5 * (speed[i + 1] - speed[i]) / span, b = speed[i], c = next - angle;
            const double root = sqrt(fmax(b * b + 4.0 * a * c, 0.0));
            if (*pulses < r->table.count / 2 + 1)
                instants[(*pulses)++] = time[i] + (c > 0.0 ? 2.0 * c / (b + root) : 0.0);
        }
        angle += turned;
    }
    return whirl_ok();
}

/// Resamples all channels and the time at equal angles of the shaft: out is [2 stations + 1][turns][samples], the time
/// last. The turn before the second pulse is left out, since its first sample would be before the first pulse.
static whirl_status record_turns(const record *r, const double *instants, size_t pulses, size_t samples, double length,
                                 double *out) {
    const size_t turns = pulses - 2, all = 2 * r->station_count + 1, size = (pulses - 1) * samples;
    double *signals = malloc((all * r->table.count + size) * sizeof *signals);
    if (!signals) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    double *turned = signals + all * r->table.count;
    const double *time = record_numbers(r, record_find(r, COLUMN_TIME));
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < r->station_count && status.code == WHIRL_OK; s++) {
        const record_column *u = &r->columns[r->channels[s][0]], *v = &r->columns[r->channels[s][1]];
        status = whirl_signals_axes(record_numbers(r, u), record_numbers(r, v), r->table.count, u->angle, v->angle,
                                    signals + 2 * s * r->table.count, signals + (2 * s + 1) * r->table.count);
        if (status.code != WHIRL_OK) status = RECORD_FAIL(r, v->place, "%.200s", status.message);
    }
    memcpy(signals + (all - 1) * r->table.count, time, r->table.count * sizeof *time);
    for (size_t c = 0; c < all && status.code == WHIRL_OK; c++) {
        status = whirl_signals_resample(time, signals + c * r->table.count, r->table.count, 1, instants, pulses,
                                        samples, POLYNOMIAL, turned);
        const double factor = c + 1 < all ? 1.0 / length : 1.0, offset = c + 1 < all ? 0.0 : time[0];
        // The last sample of a turn is at the pulse, and is written as the first one of the next turn.
        for (size_t i = 0; i < turns * samples; i++)
            out[c * turns * samples + i] = factor * (turned[samples - 1 + i] - offset);
    }
    free(signals);
    return status;
}

// ---------------------------------------------------------------- the result

static whirl_status record_describe(record *r, double length, whirl_result *result) {
    const char *name = strrchr(r->table.path, '/');
    snprintf(result->title, sizeof result->title, "%s",
             *r->table.title ? r->table.title
             : name          ? name + 1
                             : r->table.path);
    result->length_scale = length;
    result->force_scale = 1.0;
    result->case_text = calloc(1, 1);
    result->parameters = calloc(1, sizeof *result->parameters);
    result->contacts = calloc(1, sizeof *result->contacts);
    result->stations = calloc(r->station_count + 1, sizeof *result->stations);
    result->tables = calloc(1, sizeof *result->tables);
    if (!result->case_text || !result->parameters || !result->contacts || !result->stations || !result->tables)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    memcpy(result->stations, r->stations, r->station_count * sizeof *r->stations);
    result->station_count = r->station_count;
    result->table_count = 1;
    const whirl_status status = whirl_result_add_fact(result, "measured", r->table.path);
    if (status.code != WHIRL_OK || record_find(r, COLUMN_KEYPHASOR)) return status;
    return whirl_result_add_fact(result, "keyphasor", "none: lags count from the first sample");
}

/// Makes the table of the run from its turns.
static whirl_status record_table(const record *r, const whirl_measured *measured, whirl_table *table) {
    const whirl_system system = {
        .dimension = 4 * r->station_count, .probe_count = r->station_count, .probes = r->stations};
    const whirl_resting point = {.system = &system, .measured = measured};
    whirl_runup_options *o = &table->record.runup;
    // Name and options.
    snprintf(table->name, sizeof table->name, "runup");
    table->clock_factor = 1.0;
    table->count = 1;
    table->integrate = whirl_integrate_default();
    table->record = whirl_record_default();
    whirl_members_default(whirl_runup_members(), o);
    o->rate = 1.0; // the speed is measured, not driven
    o->duration = measured->end[measured->turns - 1] * (1.0 + 1e-12);
    o->rows = measured->turns < ROWS ? (int)measured->turns + 1 : ROWS;
    o->samples = (int)measured->samples;
    o->stationary = 0;
    o->spectra = measured->turns >= SPECTRUM_TURNS ? SPECTRA : 0;
    o->spectrum_turns = SPECTRUM_TURNS;
    o->orbits = ORBITS;
    // One point, with a block for its fields.
    whirl_analysis_add(&table->analyses, "runup");
    whirl_status status = whirl_layout_new(&system, &table->integrate, &table->record, table->analyses, &table->layout);
    table->values = malloc(sizeof *table->values);
    table->branch = calloc(1, sizeof *table->branch);
    table->blocks = status.code == WHIRL_OK ? malloc((table->layout.size + 1) * sizeof *table->blocks) : NULL;
    if (status.code == WHIRL_OK && (!table->values || !table->branch || !table->blocks))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    // Analyze the measured turns.
    if (status.code != WHIRL_OK) return status;
    table->values[0] = NAN;
    return whirl_analyze_resting(&point, &table->record, table->analyses, &table->layout, table->blocks);
}

static whirl_status record_result(record *r, whirl_result *result) {
    double *instants = malloc((r->table.count / 2 + 1) * sizeof *instants), *turned = NULL;
    const double length = r->columns[r->channels[0][0]].size, *time = record_numbers(r, record_find(r, COLUMN_TIME));
    // Find the turns and the number of samples of a turn.
    size_t pulses = 0, samples = 0;
    whirl_status status = instants ? record_pulses(r, instants, &pulses)
                                   : whirl_fail(WHIRL_NO_MEMORY, "no memory for the pulses of a record");
    if (status.code == WHIRL_OK && pulses < 4)
        status = whirl_fail(WHIRL_BAD_INPUT, "the shaft turns %zu times past its mark, expected at least 4", pulses);
    if (status.code == WHIRL_OK) status = whirl_signals_samples(time, r->table.count, instants, pulses, &samples);
    if (status.code != WHIRL_OK && status.code != WHIRL_NO_MEMORY)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.150s: %.300s", r->table.path, status.message);
    samples = samples < MIN_SAMPLES ? MIN_SAMPLES : samples > MAX_SAMPLES ? MAX_SAMPLES : samples;
    // Resample the signals.
    const size_t turns = pulses >= 4 ? pulses - 2 : 0, size = turns * samples;
    if (status.code == WHIRL_OK) {
        turned = malloc(((2 * r->station_count + 1) * size + 2 * r->station_count * size + 1) * sizeof *turned);
        status = turned ? record_turns(r, instants, pulses, samples, length, turned)
                        : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu turns", turns);
    }
    if (status.code == WHIRL_OK) status = record_describe(r, length, result);
    if (status.code == WHIRL_OK) {
        // Sort the channels: x of all stations, then y of all stations. Instants count from the first sample.
        double *x = turned + (2 * r->station_count + 1) * size, *y = x + r->station_count * size;
        for (size_t s = 0; s < r->station_count; s++) {
            memcpy(x + s * size, turned + 2 * s * size, size * sizeof *x);
            memcpy(y + s * size, turned + (2 * s + 1) * size, size * sizeof *y);
        }
        for (size_t n = 0; n < turns; n++) instants[n] = instants[n + 2] - time[0];
        const whirl_measured measured = {turns, samples, turned + 2 * r->station_count * size, instants, x, y};
        result->speed = two_pi / (instants[0] - measured.time[0]);
        status = record_table(r, &measured, &result->tables[0]);
    }
    free(instants);
    free(turned);
    return status;
}

whirl_status whirl_result_read_record(const char *path, whirl_result **result) {
    return whirl_result_read_record_columns(path, NULL, NULL, 0, result);
}

whirl_status whirl_result_read_record_columns(const char *path, const char *const *headings, const char *const *names,
                                              size_t count, whirl_result **result) {
    csv_chosen chosen[MAX_CHANNELS + 3];
    *result = NULL;
    if (count > sizeof chosen / sizeof *chosen)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu columns are chosen, expected at most %zu", count,
                          sizeof chosen / sizeof *chosen);
    for (size_t i = 0; i < count; i++) chosen[i] = (csv_chosen){headings[i], names[i]};
    record *r = calloc(1, sizeof *r);
    if (!r) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    whirl_status status = csv_load_chosen(path, chosen, count, MAX_CHANNELS + 3, &r->table);
    if (status.code == WHIRL_OK) status = record_understand(r);
    if (status.code == WHIRL_OK) {
        *result = calloc(1, sizeof **result);
        status = *result ? record_result(r, *result) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a result");
    }
    if (status.code != WHIRL_OK) {
        whirl_result_free(*result);
        *result = NULL;
    }
    csv_free(&r->table);
    free(r);
    return status;
}
