#include "explorer_bands.h"

#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/spread.h"

/// Numbers that diagrams of the page show of every station, in addition to those that the case asks for.
static const struct {
    const char *field, *column;
} band_usual[] = {{WHIRL_FIELD_ORBIT_MAX_RADIUS, ""},         {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "x"},
                  {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "y"},    {WHIRL_FIELD_UNBALANCE_AXES, "major"},
                  {WHIRL_FIELD_UNBALANCE_PROBE, "first"},     {WHIRL_FIELD_UNBALANCE_PROBE, "second"},
                  {WHIRL_FIELD_UNBALANCE_PROBE_LAG, "first"}, {WHIRL_FIELD_UNBALANCE_PROBE_LAG, "second"}};

enum { BAND_USUAL = sizeof band_usual / sizeof *band_usual, MAX_BANDS = 256, MAX_VALUES = 4096 };

/// The bands of a result while they are written.
typedef struct band_list {
    FILE *stream;
    const whirl_result *result;
    const whirl_table *table; ///< table of the samples
    bool first, well;
    size_t count;
    struct {
        const whirl_field *field;
        size_t which, index;
    } written[MAX_BANDS]; ///< places in the table's blocks that have been written
} band_list;

/// Returns true for a place that has no band yet, and notes it.
static bool band_is_new(band_list *to, const whirl_spread_at *at) {
    for (size_t i = 0; i < to->count; i++)
        if (to->written[i].field == at->field && to->written[i].which == at->which && to->written[i].index == at->index)
            return false;
    if (to->count == MAX_BANDS) return false;
    to->written[to->count].field = at->field;
    to->written[to->count].which = at->which;
    to->written[to->count++].index = at->index;
    return true;
}

/// Begins the band of a place in the table's blocks over a parameter.
static void band_begin(band_list *to, const whirl_spread_at *at, const char *parameter) {
    fputs(to->first ? ",\"bands\":[" : ",", to->stream);
    to->first = false;
    script_text_member(to->stream, '{', "parameter", parameter);
    script_text_member(to->stream, ',', "field", at->field->name);
    fprintf(to->stream, ",\"which\":%zu,\"column\":%zu,\"samples\":%d", at->which, at->index,
            to->table->tolerances.samples);
    script_key(to->stream, ',', "places");
    fputc('[', to->stream);
}

/// Writes the quantiles at a value of the parameter, plus `shift`.
static void band_write_place(const band_list *to, size_t place, double value, const whirl_spread *spread,
                             double shift) {
    fputs(place > 0 ? ",[" : "[", to->stream);
    script_number(to->stream, value);
    for (size_t q = 0; q < WHIRL_QUANTILES; q++) {
        fputc(',', to->stream);
        script_number(to->stream, spread->quantiles[q].value + shift);
    }
    fputc(']', to->stream);
}

static void band_write(band_list *to, const whirl_spread_of *of) {
    whirl_spread_at at;
    if (!whirl_spread_place(to->result, to->table, of, &at) || at.field->rows != 1 || !band_is_new(to, &at)) return;
    const size_t places = whirl_table_places(to->table);
    const double period = whirl_spread_period(&at);
    double before = NAN; // the previous median; an angle is unwrapped to within half a period of it
    band_begin(to, &at, to->table->parameter);
    for (size_t place = 0; place < places; place++) {
        whirl_spread spread = {.samples = 0};
        to->well = whirl_table_spread(to->result, to->table, of, place, 0, &spread).code == WHIRL_OK && to->well;
        const double middle = spread.quantiles[WHIRL_QUANTILES / 2].value;
        const double turns = period > 0.0 ? rint((before - middle) / period) : 0.0;
        const double shift = isfinite(turns) ? period * turns : 0.0;
        if (isfinite(middle)) before = middle + shift;
        band_write_place(to, place, to->table->values[place], &spread, shift);
    }
    fputs("]}", to->stream);
}

/// Numbers that the diagram of a run-up shows of every station, in rows over the time.
static const struct {
    const char *field, *column;
} band_rows[] = {
    {WHIRL_FIELD_RUNUP_AMPLITUDE, "x1"}, {WHIRL_FIELD_RUNUP_AMPLITUDE, "y1"}, {WHIRL_FIELD_RUNUP_RADIUS, ""}};

/// Writes the band of a number of a run-up over the time: a place for each row, at the median of its times.
static void band_write_rows(band_list *to, whirl_spread_of *of) {
    whirl_spread_at at;
    whirl_spread_of time = {.field = WHIRL_FIELD_RUNUP_TIME, .above = -INFINITY, .below = INFINITY};
    of->row = 0;
    if (!whirl_spread_place(to->result, to->table, of, &at) || at.field->rows < 2) return;
    band_begin(to, &at, "time");
    for (size_t row = 0; row < at.field->rows; row++) {
        whirl_spread spread = {.samples = 0}, times = {.samples = 0};
        of->row = time.row = row;
        to->well = whirl_table_spread(to->result, to->table, of, 0, 0, &spread).code == WHIRL_OK && to->well;
        to->well = whirl_table_spread(to->result, to->table, &time, 0, 0, &times).code == WHIRL_OK && to->well;
        band_write_place(to, row, times.quantiles[WHIRL_QUANTILES / 2].value, &spread, 0.0);
    }
    fputs("]}", to->stream);
}

/// Writes the bands of a single run-up with tolerances.
static void bands_of_run(band_list *to) {
    for (size_t i = 0; i < sizeof band_rows / sizeof *band_rows; i++)
        for (size_t s = 0; s < to->result->station_count; s++) {
            whirl_spread_of of = {.above = -INFINITY, .below = INFINITY};
            snprintf(of.field, sizeof of.field, "%s", band_rows[i].field);
            snprintf(of.column, sizeof of.column, "%s", band_rows[i].column);
            snprintf(of.at, sizeof of.at, "%s", to->result->stations[s].name);
            band_write_rows(to, &of);
        }
}

bool explorer_write_bands(FILE *stream, const whirl_result *result) {
    band_list to = {.stream = stream, .result = result, .first = true, .well = true};
    for (size_t t = 0; t < result->table_count; t++) {
        to.table = &result->tables[t];
        to.count = 0;
        const size_t places = to.table->tolerances.samples > 0 ? whirl_table_places(to.table) : 0;
        if (places == 1) bands_of_run(&to);
        if (places < 2 || places > MAX_VALUES || !*to.table->parameter) continue;
        whirl_spread_of of;
        for (size_t i = 0; whirl_table_asked(result, to.table, i, &of); i++) band_write(&to, &of);
        for (size_t i = 0; i < BAND_USUAL; i++)
            for (size_t s = 0; s < result->station_count; s++) {
                of = (whirl_spread_of){.above = -INFINITY, .below = INFINITY};
                snprintf(of.field, sizeof of.field, "%s", band_usual[i].field);
                snprintf(of.column, sizeof of.column, "%s", band_usual[i].column);
                snprintf(of.at, sizeof of.at, "%s", result->stations[s].name);
                band_write(&to, &of);
            }
    }
    if (!to.first) fputc(']', stream);
    return to.well;
}
