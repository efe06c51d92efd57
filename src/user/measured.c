// Measured records as results: a table of numbers over the time becomes a run of the study `runup`, turn by turn.
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/signals.h"

/// Limits of a record; largest gap of words in a message.
enum { MAX_CHANNELS = 2 * WHIRL_MAX_PROBES, MAX_BYTES = 1 << 30, TEXT = 96 };
/// Numbers of the run: rows, spectra, turns of a spectrum, orbits, samples of a turn, order of interpolation.
enum {
    ROWS = 400,
    SPECTRA = 100,
    SPECTRUM_TURNS = 16,
    ORBITS = 8,
    MIN_SAMPLES = 32,
    MAX_SAMPLES = 256,
    POLYNOMIAL = 7
};

static const double two_pi = 6.283185307179586476925;

/// A column of the table.
typedef struct record_column {
    enum { COLUMN_TIME, COLUMN_KEYPHASOR, COLUMN_SPEED, COLUMN_CHANNEL } kind;
    char station[WHIRL_NAME_SIZE];
    double angle; ///< rad of a channel from the x axis, in the sense of rotation
    double size;  ///< SI per unit
    int place;    ///< column of its heading in its line, from 1
} record_column;

/// A record while it is read. Numbers are in SI, channels in metres.
typedef struct record {
    const char *path;
    int line;
    char separator;
    size_t column_count, count, room; ///< columns, rows of numbers, and room for them
    record_column columns[MAX_CHANNELS + 3];
    double *numbers; ///< [columns][room] while reading; [columns][count] afterwards
    char title[256];
    size_t station_count;
    whirl_probe stations[WHIRL_MAX_PROBES];
    size_t channels[WHIRL_MAX_PROBES][2]; ///< columns of a station
} record;

/// Fails at a place of the file: line and column from 1.
#define RECORD_FAIL(r, at, ...) record_fail((r)->path, (r)->line, (at), __VA_ARGS__)

static whirl_status record_fail(const char *path, int line, int column, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
static whirl_status record_fail(const char *path, int line, int column, const char *format, ...) {
    char text[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return whirl_fail(WHIRL_BAD_INPUT, "%.150s:%d:%d: %.300s", path, line, column, text);
}

// ---------------------------------------------------------------- headings

/// Takes the next cell of a line without blanks and quotes around it. Returns false after the last one.
static bool record_cell(const record *r, const char **at, const char *end, char *text, size_t size,
                        const char **first) {
    if (!*at || *at > end) return false;
    const char *from = *at, *stop = memchr(from, r->separator, (size_t)(end - from));
    const char *to = stop ? stop : end;
    *at = stop ? stop + 1 : NULL;
    while (from < to && (isspace((unsigned char)*from) || *from == '"')) from++;
    while (to > from && (isspace((unsigned char)to[-1]) || to[-1] == '"')) to--;
    *first = from;
    snprintf(text, size, "%.*s", (int)(to - from), from);
    return true;
}

/// Reads the unit of a heading: its size in SI, of the dimension of `si`.
static whirl_status record_unit(const record *r, const char *unit, const char *si, int place, double *size) {
    char text[TEXT];
    *size = 1.0;
    const bool length = strcmp(si, "m") == 0, time = strcmp(si, "s") == 0;
    if (!*unit)
        return RECORD_FAIL(r, place, "this column has no unit, expected one in brackets: [%s]",
                           length ? "um"
                           : time ? "s"
                                  : "rpm");
    snprintf(text, sizeof text, "1 %.60s", unit);
    if (whirl_quantity_value(text, si, size).code == WHIRL_OK && *size > 0.0) return whirl_ok();
    return RECORD_FAIL(r, place, "[%.40s] is no unit of a %s", unit, length ? "length" : time ? "time" : "speed");
}

/// Reads a heading: "time [s]", "keyphasor [V]", "speed [rpm]", "de x [um]", "de 45 [mil]".
static whirl_status record_heading(record *r, char *text, int place) {
    record_column *own = &r->columns[r->column_count];
    char *unit = strpbrk(text, "[("), *end;
    *own = (record_column){.kind = COLUMN_CHANNEL, .size = 1.0, .place = place};
    if (r->column_count == MAX_CHANNELS + 3) return RECORD_FAIL(r, place, "has more than %d columns", MAX_CHANNELS + 3);
    if (unit) {
        *unit++ = '\0';
        unit[strcspn(unit, "])")] = '\0';
    } else {
        unit = text + strlen(text);
    }
    for (end = text + strlen(text); end > text && isspace((unsigned char)end[-1]);) *--end = '\0';
    r->column_count++;
    if (strcmp(text, "time") == 0) {
        own->kind = COLUMN_TIME;
        return record_unit(r, unit, "s", place, &own->size);
    }
    if (strcmp(text, "keyphasor") == 0) {
        own->kind = COLUMN_KEYPHASOR;
        return whirl_ok();
    }
    if (strcmp(text, "speed") == 0) {
        own->kind = COLUMN_SPEED;
        return record_unit(r, unit, "rad/s", place, &own->size);
    }
    char *direction = strrchr(text, ' ');
    if (!direction)
        return RECORD_FAIL(r, place,
                           "'%.40s' is no column, expected time, keyphasor, speed, or a station and the direction of a "
                           "probe: 'de x', 'de 45'",
                           text);
    double degrees = strtod(direction + 1, &end);
    const bool axis = strcmp(direction + 1, "x") == 0 || strcmp(direction + 1, "y") == 0;
    if (axis) degrees = direction[1] == 'y' ? 90.0 : 0.0;
    if (!axis && (end == direction + 1 || *end || !isfinite(degrees)))
        return RECORD_FAIL(r, place, "'%.20s' is no direction of a probe, expected x, y or degrees from x",
                           direction + 1);
    while (direction > text && isspace((unsigned char)direction[-1])) direction--;
    *direction = '\0';
    snprintf(own->station, sizeof own->station, "%.60s", text);
    own->angle = degrees * two_pi / 360.0;
    return record_unit(r, unit, "m", place, &own->size);
}

static const record_column *record_find(const record *r, int kind) {
    for (size_t c = 0; c < r->column_count; c++)
        if ((int)r->columns[c].kind == kind) return &r->columns[c];
    return NULL;
}

/// Finds the stations of the channels: two probes each.
static whirl_status record_stations(record *r) {
    const record_column *time = record_find(r, COLUMN_TIME), *mark = record_find(r, COLUMN_KEYPHASOR);
    if (!time) return RECORD_FAIL(r, 1, "there is no column 'time [s]'");
    if (!mark && !record_find(r, COLUMN_SPEED))
        return RECORD_FAIL(r, 1, "there is neither a column 'keyphasor' nor a column 'speed [rpm]'");
    for (size_t c = 0; c < r->column_count; c++) {
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
    for (size_t s = 0; s < r->station_count; s++)
        if (r->channels[s][1] == 0)
            return RECORD_FAIL(r, r->columns[r->channels[s][0]].place,
                               "%.40s has one probe, expected two: x and y, or two directions in degrees",
                               r->stations[s].name);
    return r->station_count > 0 ? whirl_ok()
                                : RECORD_FAIL(r, 1, "there is no probe, expected columns such as 'de x [um]'");
}

static whirl_status record_headings(record *r, const char *from, const char *end) {
    char text[TEXT];
    const char *at = from, *first;
    const size_t length = (size_t)(end - from);
    whirl_status status = whirl_ok();
    r->separator = memchr(from, ',', length) ? ',' : memchr(from, ';', length) ? ';' : '\t';
    while (status.code == WHIRL_OK && record_cell(r, &at, end, text, sizeof text, &first))
        status = record_heading(r, text, (int)(first - from) + 1);
    return status.code == WHIRL_OK ? record_stations(r) : status;
}

// ---------------------------------------------------------------- numbers

static whirl_status record_grow(record *r) {
    const size_t room = r->room > 0 ? 2 * r->room : 4096;
    if (r->count < r->room) return whirl_ok();
    double *numbers = malloc(r->column_count * room * sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu samples", room);
    for (size_t c = 0; c < r->column_count && r->count > 0; c++)
        memcpy(numbers + c * room, r->numbers + c * r->room, r->count * sizeof *numbers);
    free(r->numbers);
    r->numbers = numbers;
    r->room = room;
    return whirl_ok();
}

static whirl_status record_row(record *r, const char *from, const char *end) {
    char text[TEXT], *rest;
    const char *at = from, *first;
    size_t cells = 0;
    whirl_status status = record_grow(r);
    while (status.code == WHIRL_OK && record_cell(r, &at, end, text, sizeof text, &first)) {
        const int place = (int)(first - from) + 1;
        if (cells == r->column_count)
            return RECORD_FAIL(r, place, "there are more cells than the %zu headings", r->column_count);
        double *own = r->numbers + cells * r->room + r->count;
        *own = strtod(text, &rest) * r->columns[cells].size;
        if (!*text) return RECORD_FAIL(r, place, "the cell is empty, expected a number: cut the record at its gaps");
        if (rest == text || *rest || !isfinite(*own)) return RECORD_FAIL(r, place, "'%.30s' is no number", text);
        if (r->columns[cells].kind == COLUMN_TIME && r->count > 0 && !(*own > own[-1]))
            return RECORD_FAIL(r, place, "the time %.30s is not later than the one before", text);
        cells++;
    }
    if (status.code == WHIRL_OK && cells < r->column_count)
        return RECORD_FAIL(r, (int)(end - from) + 1, "there are %zu cells, expected %zu as the headings", cells,
                           r->column_count);
    r->count++;
    return status;
}

/// Reads all lines: empty ones and those after # are left out, the first of these is the title.
static whirl_status record_lines(record *r, const char *text, size_t length) {
    const char *end = text + length;
    whirl_status status = whirl_ok();
    for (const char *from = text; from < end && status.code == WHIRL_OK;) {
        const char *stop = memchr(from, '\n', (size_t)(end - from)), *last = stop ? stop : end, *next = last + 1;
        r->line++;
        while (last > from && isspace((unsigned char)last[-1]) && last[-1] != '\t') last--;
        const char *begin = from;
        while (begin < last && isspace((unsigned char)*begin)) begin++;
        if (begin < last && *begin == '#') {
            begin += 1 + strspn(begin + 1, " ");
            if (!*r->title && begin < last) snprintf(r->title, sizeof r->title, "%.*s", (int)(last - begin), begin);
        } else if (begin < last) {
            status = r->column_count == 0 ? record_headings(r, from, last) : record_row(r, from, last);
        }
        from = next;
    }
    if (status.code == WHIRL_OK && r->count < 16)
        status =
            RECORD_FAIL(r, 1, "there are %zu rows of numbers, expected a line of headings and at least 16", r->count);
    return status;
}

static const double *record_numbers(const record *r, const record_column *of) {
    return r->numbers + (size_t)(of - r->columns) * r->room;
}

// ---------------------------------------------------------------- turns

/// Finds the instants of the mark: pulses of the keyphasor, or full turns of the integral of the speed from the first
/// sample on.
static whirl_status record_pulses(const record *r, double *instants, size_t *pulses) {
    const double *time = record_numbers(r, record_find(r, COLUMN_TIME));
    const record_column *mark = record_find(r, COLUMN_KEYPHASOR);
    double threshold, hysteresis, angle = 0.0;
    if (mark) {
        const double *voltage = record_numbers(r, mark);
        whirl_status status = whirl_signals_threshold(voltage, r->count, &threshold, &hysteresis);
        if (status.code == WHIRL_OK)
            status = whirl_signals_pulses(time, voltage, r->count, threshold, hysteresis, true, instants, pulses);
        return status;
    }
    const double *speed = record_numbers(r, record_find(r, COLUMN_SPEED));
    *pulses = 0;
    for (size_t i = 0; i + 1 < r->count; i++) {
        const double span = time[i + 1] - time[i], turned = 0.5 * (speed[i] + speed[i + 1]) * span;
        for (double next = ceil(angle / two_pi) * two_pi; turned > 0.0 && next < angle + turned; next += two_pi) {
            // The part of the step at which the parabola of the angle reaches the mark.
            const double a = 0.5 * (speed[i + 1] - speed[i]) / span, b = speed[i], c = next - angle;
            const double root = sqrt(fmax(b * b + 4.0 * a * c, 0.0));
            if (*pulses < r->count / 2 + 1) instants[(*pulses)++] = time[i] + (c > 0.0 ? 2.0 * c / (b + root) : 0.0);
        }
        angle += turned;
    }
    return whirl_ok();
}

/// Resamples at equal angles: signals [2 stations + 1][turns][samples], the time last. The turn before the second
/// pulse is left out: its first sample is before the first pulse.
static whirl_status record_turns(const record *r, const double *instants, size_t pulses, size_t samples, double length,
                                 double *out) {
    const size_t turns = pulses - 2, all = 2 * r->station_count + 1, size = (pulses - 1) * samples;
    double *signals = malloc((all * r->count + size) * sizeof *signals);
    if (!signals) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    double *turned = signals + all * r->count;
    const double *time = record_numbers(r, record_find(r, COLUMN_TIME));
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < r->station_count && status.code == WHIRL_OK; s++) {
        const record_column *u = &r->columns[r->channels[s][0]], *v = &r->columns[r->channels[s][1]];
        status = whirl_signals_axes(record_numbers(r, u), record_numbers(r, v), r->count, u->angle, v->angle,
                                    signals + 2 * s * r->count, signals + (2 * s + 1) * r->count);
        if (status.code != WHIRL_OK) status = RECORD_FAIL(r, v->place, "%.200s", status.message);
    }
    memcpy(signals + (all - 1) * r->count, time, r->count * sizeof *time);
    for (size_t c = 0; c < all && status.code == WHIRL_OK; c++) {
        status = whirl_signals_resample(time, signals + c * r->count, r->count, 1, instants, pulses, samples,
                                        POLYNOMIAL, turned);
        const double factor = c + 1 < all ? 1.0 / length : 1.0, offset = c + 1 < all ? 0.0 : time[0];
        // The last sample of a turn is at the pulse: it begins the next one.
        for (size_t i = 0; i < turns * samples; i++)
            out[c * turns * samples + i] = factor * (turned[samples - 1 + i] - offset);
    }
    free(signals);
    return status;
}

// ---------------------------------------------------------------- the result

static whirl_status record_describe(record *r, double length, whirl_result *result) {
    const char *name = strrchr(r->path, '/');
    snprintf(result->title, sizeof result->title, "%s", *r->title ? r->title : name ? name + 1 : r->path);
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
    const whirl_status status = whirl_result_add_fact(result, "measured", r->path);
    if (status.code != WHIRL_OK || record_find(r, COLUMN_KEYPHASOR)) return status;
    return whirl_result_add_fact(result, "keyphasor", "none: lags count from the first sample");
}

/// Makes the table of the run from its turns.
static whirl_status record_table(const record *r, const whirl_measured *measured, whirl_table *table) {
    const whirl_system system = {
        .dimension = 4 * r->station_count, .probe_count = r->station_count, .probes = r->stations};
    const whirl_resting point = {.system = &system, .measured = measured};
    whirl_runup_options *o = &table->record.runup;
    snprintf(table->name, sizeof table->name, "runup");
    table->clock_factor = 1.0;
    table->count = 1;
    table->integrate = whirl_integrate_default();
    table->record = whirl_record_default();
    whirl_members_default(whirl_runup_members(), o);
    o->rate = 1.0; // no drive
    o->duration = measured->end[measured->turns - 1] * (1.0 + 1e-12);
    o->rows = measured->turns < ROWS ? (int)measured->turns + 1 : ROWS;
    o->samples = (int)measured->samples;
    o->stationary = 0;
    o->spectra = measured->turns >= SPECTRUM_TURNS ? SPECTRA : 0;
    o->spectrum_turns = SPECTRUM_TURNS;
    o->orbits = ORBITS;
    whirl_analysis_add(&table->analyses, "runup");
    whirl_status status = whirl_layout_new(&system, &table->integrate, &table->record, table->analyses, &table->layout);
    table->values = malloc(sizeof *table->values);
    table->branch = calloc(1, sizeof *table->branch);
    table->blocks = status.code == WHIRL_OK ? malloc((table->layout.size + 1) * sizeof *table->blocks) : NULL;
    if (status.code == WHIRL_OK && (!table->values || !table->branch || !table->blocks))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    if (status.code != WHIRL_OK) return status;
    table->values[0] = NAN;
    return whirl_analyze_resting(&point, &table->record, table->analyses, &table->layout, table->blocks);
}

static whirl_status record_result(record *r, whirl_result *result) {
    double *instants = malloc((r->count / 2 + 1) * sizeof *instants), *turned = NULL;
    const double length = r->columns[r->channels[0][0]].size, *time = record_numbers(r, record_find(r, COLUMN_TIME));
    size_t pulses = 0, samples = 0;
    whirl_status status = instants ? record_pulses(r, instants, &pulses)
                                   : whirl_fail(WHIRL_NO_MEMORY, "no memory for the pulses of a record");
    if (status.code == WHIRL_OK && pulses < 4)
        status = whirl_fail(WHIRL_BAD_INPUT, "the shaft turns %zu times past its mark, expected at least 4", pulses);
    if (status.code == WHIRL_OK) status = whirl_signals_samples(time, r->count, instants, pulses, &samples);
    if (status.code != WHIRL_OK && status.code != WHIRL_NO_MEMORY)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.150s: %.300s", r->path, status.message);
    samples = samples < MIN_SAMPLES ? MIN_SAMPLES : samples > MAX_SAMPLES ? MAX_SAMPLES : samples;
    const size_t turns = pulses >= 4 ? pulses - 2 : 0, size = turns * samples;
    if (status.code == WHIRL_OK) {
        turned = malloc(((2 * r->station_count + 1) * size + 2 * r->station_count * size + 1) * sizeof *turned);
        status = turned ? record_turns(r, instants, pulses, samples, length, turned)
                        : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu turns", turns);
    }
    if (status.code == WHIRL_OK) status = record_describe(r, length, result);
    if (status.code == WHIRL_OK) {
        // x of all stations, then y of all.
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
    record *r = calloc(1, sizeof *r);
    char *text = NULL;
    size_t length = 0;
    input_file in;
    *result = NULL;
    if (!r) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a record");
    r->path = path;
    whirl_status status = whirl_ok();
    if (!input_read(path, MAX_BYTES, &in, &text, &length))
        status =
            whirl_fail(in.no_memory ? WHIRL_NO_MEMORY : WHIRL_BAD_INPUT, "cannot read %.200s: %.128s", path, in.reason);
    else if (in.size > length)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: is larger than 1 GiB", path);
    const size_t mark = status.code == WHIRL_OK && length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    if (status.code == WHIRL_OK) status = record_lines(r, text + mark, length - mark);
    if (status.code == WHIRL_OK) {
        *result = calloc(1, sizeof **result);
        status = *result ? record_result(r, *result) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a result");
    }
    if (status.code != WHIRL_OK) {
        whirl_result_free(*result);
        *result = NULL;
    }
    free(text);
    free(r->numbers);
    free(r);
    return status;
}
