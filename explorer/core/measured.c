// Tables of measured numbers, and the spectra of measured motions.
#include "core.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/internal/measured.h"
#include "whirl/signals.h"

static text answer;

/// Writes a table in the form of MeasuredTable of protocol.ts.
static void measured_write(text *t, const whirl_measured_table *measured) {
    const whirl_fit *fit = &measured->fit;
    // One parameter, given[0], varies from row to row of vectors, as the table is read without values of others.
    const whirl_fit_motion *first = fit->motion_count > 0 ? &fit->motions[0] : NULL;
    text_add(t, "{");
    json_name(t, "title");
    json_text(t, measured->title);
    json_name(t, "parameter");
    json_text(t, first && first->given_count > 0 ? first->given[0].name : "");
    json_name(t, "motions");
    text_add(t, "[");
    for (size_t i = 0; i < fit->motion_count; i++) {
        const whirl_fit_motion *motion = &fit->motions[i];
        json_next(t);
        json_number(t, motion->given_count > 0 ? motion->given[0].value : motion->speed > 0.0 ? motion->speed : NAN);
    }
    text_add(t, "]");
    json_name(t, "numbers");
    text_add(t, "[");
    for (size_t i = 0; i < fit->number_count; i++) {
        const whirl_fit_number *number = &fit->numbers[i];
        json_next(t);
        text_add(t, "[%zu,%zu,%.17g,%d,%.17g,%.17g]", number->motion, number->station, number->angle,
                 (int)number->quantity, number->at, number->value);
    }
    text_add(t, "]}");
}

/// Most columns that are chosen.
enum { MEASURED_COLUMNS = 256 };

/// Takes the columns of a text, a line for each, which it changes. Returns their number.
static size_t measured_choose(char *lines, csv_chosen chosen[MEASURED_COLUMNS]) {
    size_t count = 0;
    for (char *line = lines; *line && count < MEASURED_COLUMNS;) {
        char *tab = strchr(line, '\t'), *end = strchr(line, '\n');
        if (!tab || !end || tab > end) break;
        *tab = *end = '\0';
        chosen[count++] = (csv_chosen){line, tab + 1};
        line = end + 1;
    }
    return count;
}

EXPORTED const char *explorer_measured(const whirl_case *object, const char *name, const void *bytes, size_t size,
                                       const char *columns) {
    whirl_measured_table *measured = NULL;
    csv_chosen chosen[MEASURED_COLUMNS];
    char *lines = malloc(strlen(columns) + 1);
    whirl_status status = lines ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for columns");
    if (status.code == WHIRL_OK) {
        strcpy(lines, columns);
        const size_t count = measured_choose(lines, chosen);
        status = whirl_measured_read(object, name, bytes, size, chosen, count, &measured);
    }
    free(lines);
    if (!explorer_good(&status)) return NULL;
    text_clear(&answer);
    measured_write(&answer, measured);
    whirl_measured_free(measured);
    return text_bytes(&answer);
}

EXPORTED const char *explorer_measured_columns(const char *name, const void *bytes, size_t size) {
    csv_listed *columns;
    size_t count;
    const whirl_status status = csv_list(name, bytes, size, &columns, &count);
    if (!explorer_good(&status)) return NULL;
    text_clear(&answer);
    text_add(&answer, "[");
    for (size_t i = 0; i < count; i++) {
        json_next(&answer);
        text_add(&answer, "{");
        json_name(&answer, "name");
        json_text(&answer, columns[i].name);
        json_name(&answer, "unit");
        json_text(&answer, columns[i].unit);
        json_name(&answer, "count");
        json_number(&answer, (double)columns[i].count);
        text_add(&answer, "}");
    }
    text_add(&answer, "]");
    free(columns);
    return text_bytes(&answer);
}

// ---------------------------------------------------------------- spectra

/// Highest order of spectra, largest number of their revolutions, and samples of a revolution and order of the
/// polynomials of a record that is sampled again.
enum { MEASURED_ORDER = 10, MEASURED_REVOLUTIONS = 512, MEASURED_SAMPLES = 128, MEASURED_POLYNOMIAL = 7 };

/// Samples of both axes at equal angles, over whole revolutions.
typedef struct measured_turns {
    double *samples; ///< [2][turns each]
    size_t turns, each;
} measured_turns;

/// Returns the number of samples in a revolution if they are at equal angles, else 0.
static size_t measured_equal(const double *turn, size_t count) {
    const double each = count > 1 ? round(1.0 / (turn[1] - turn[0])) : 0.0;
    for (size_t i = 0; i < count; i++)
        if (!(fabs((turn[i] - turn[0]) * each - (double)i) < 0.01)) return 0;
    return each >= 4.0 && each <= (double)count ? (size_t)each : 0;
}

/// Takes whole revolutions of samples at equal angles, at most the last MEASURED_REVOLUTIONS.
static whirl_status measured_take(const double *values, size_t count, size_t each, measured_turns *out) {
    out->each = each;
    out->turns = count / each < MEASURED_REVOLUTIONS ? count / each : MEASURED_REVOLUTIONS;
    const size_t size = out->turns * each;
    out->samples = malloc(2 * size * sizeof *out->samples);
    if (!out->samples) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a spectrum");
    for (size_t axis = 0; axis < 2; axis++)
        for (size_t i = 0; i < size; i++) out->samples[axis * size + i] = values[(axis + 1) * count - size + i];
    return whirl_ok();
}

/// Interpolates samples at equal angles over whole revolutions of a record, at most the last MEASURED_REVOLUTIONS.
static whirl_status measured_resample(const double *turn, const double *values, size_t count, measured_turns *out) {
    const double first = ceil(turn[0]), last = floor(turn[count - 1]);
    const double most = fmin(last - first, (double)MEASURED_REVOLUTIONS);
    if (!(most >= 1.0)) return whirl_fail(WHIRL_BAD_INPUT, "the record has no whole revolution");
    out->turns = (size_t)most;
    out->each = MEASURED_SAMPLES;
    double *marks = malloc((out->turns + 1) * sizeof *marks);
    out->samples = malloc(2 * out->turns * out->each * sizeof *out->samples);
    whirl_status status = marks && out->samples ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for a spectrum");
    for (size_t i = 0; status.code == WHIRL_OK && i <= out->turns; i++) marks[i] = last - most + (double)i;
    if (status.code == WHIRL_OK)
        status = whirl_signals_resample(turn, values, count, 2, marks, out->turns + 1, out->each, MEASURED_POLYNOMIAL,
                                        out->samples);
    free(marks);
    return status;
}

/// Writes the columns of whirl_signals_spectrum from the exact parts of all orders k/turns, for records that are too
/// short for a window.
static whirl_status measured_track(const measured_turns *of, size_t count, double *rows) {
    double *orders = malloc(5 * count * sizeof *orders);
    if (!orders) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a spectrum");
    double *vectors = orders + count;
    for (size_t k = 0; k < count; k++) orders[k] = (double)k / (double)of->turns;
    const whirl_status status =
        whirl_signals_track(of->samples, 2, of->turns, of->each, orders, count, of->turns, vectors);
    for (size_t k = 0; status.code == WHIRL_OK && k < count; k++) {
        const double *x = vectors + 2 * k, *y = vectors + 2 * (count + k);
        double *row = rows + (size_t)WHIRL_SIGNALS_COLUMNS * k;
        row[0] = orders[k];
        // The mean is no vibration.
        row[1] = k > 0 ? hypot(x[0], x[1]) : 0.0;
        row[2] = k > 0 ? hypot(y[0], y[1]) : 0.0;
        // x + i y is a e^(i k angle) + b e^(-i k angle).
        row[3] = k > 0 ? 0.5 * hypot(x[0] - y[1], x[1] + y[0]) : 0.0;
        row[4] = k > 0 ? 0.5 * hypot(x[0] + y[1], x[1] - y[0]) : 0.0;
    }
    free(orders);
    return status;
}

EXPORTED size_t explorer_measured_orders(void) {
    return (size_t)MEASURED_ORDER * MEASURED_REVOLUTIONS + 1;
}

EXPORTED int explorer_measured_spectrum(const double *turn, const double *values, size_t count, double *rows) {
    measured_turns of = {.samples = NULL};
    const size_t each = measured_equal(turn, count);
    whirl_status status = count < 8  ? whirl_fail(WHIRL_BAD_INPUT, "the record has fewer than 8 samples")
                          : each > 0 ? measured_take(values, count, each, &of)
                                     : measured_resample(turn, values, count, &of);
    size_t orders = 0;
    if (status.code == WHIRL_OK) {
        const size_t size = of.turns * of.each;
        orders = whirl_signals_orders(size, of.each, MEASURED_ORDER);
        double lines[WHIRL_SIGNALS_LINES * WHIRL_SIGNALS_COLUMNS], synchronous[8];
        size_t lines_found;
        status = of.turns >= WHIRL_SIGNALS_MIN_REVOLUTIONS
                     ? whirl_signals_spectrum(of.samples, of.samples + size, size, of.each, MEASURED_ORDER, rows, lines,
                                              &lines_found, synchronous)
                     : measured_track(&of, orders, rows);
    }
    free(of.samples);
    return explorer_good(&status) ? (int)orders : 0;
}
