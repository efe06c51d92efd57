// Makes the JSON object of one point of a result.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "document.h"
#include "json_point.h"
#include "quantities.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"

static json_t *numbers_array(bool *well, const double *values, size_t count) {
    json_t *array = json_array();
    for (size_t i = 0; i < count; ++i) document_append(well, array, document_number(values[i]));
    return array;
}

json_t *point_parameters(bool *well, const whirl_result *result, const whirl_table *table, size_t point) {
    json_t *object = json_object();
    for (size_t i = 0; i < result->parameter_count; ++i) {
        const whirl_parameter *parameter = &result->parameters[i];
        const bool expression = parameter->text[strspn(parameter->text, " \t")] == '=';
        if (!expression) document_put(well, object, parameter->name, document_number(parameter->value));
    }
    if (*table->parameter) document_put(well, object, table->parameter, document_number(table->values[point]));
    if (table->row > 0) document_put(well, object, table->second, document_number(whirl_table_second(table, point)));
    if (table->plane > 0) document_put(well, object, table->third, document_number(whirl_table_third(table, point)));
    return object;
}

// Puts the confidence of a verdict. "confirmed" is the verdict at the second tolerance, null without one; "advice" is a
// change of settings that would make the verdict definite.
static void put_confidence(bool *well, json_t *object, const whirl_verdict *verdict) {
    char advice[WHIRL_MESSAGE_SIZE];
    whirl_verdict_advice(verdict, advice, sizeof advice);
    document_put(well, object, "confidence", document_text(whirl_confidence_name(verdict->confidence)));
    document_put(well, object, "advice", *advice ? document_text(advice) : json_null());
    json_t *confirmed = verdict->confirmed ? json_object() : json_null();
    if (verdict->confirmed) {
        document_put(well, confirmed, "regime", document_text(whirl_regime_name(verdict->other_regime)));
        document_put(well, confirmed, "period", json_integer(verdict->other_period));
    }
    document_put(well, object, "confirmed", confirmed);
}

// Writes what refinement changed at the point, and the method of the final motion.
static void put_refinement(bool *well, json_t *object, const whirl_table *table, size_t point) {
    json_t *refined = json_object();
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *field = &table->layout.fields[i];
        const numbers found = point_numbers(table, point, field->name, 0);
        if (strncmp(field->name, "refine/", 7) != 0 || !found.at) continue;
        document_put(well, refined, field->name + 7, document_number(found.at[0]));
    }
    if (json_object_size(refined) > 0)
        document_put(well, object, "refined", refined);
    else
        json_decref(refined);
}

static void put_verdict(bool *well, json_t *object, const whirl_table *table, size_t point) {
    if (!whirl_layout_has_verdict(&table->layout)) return;
    // Put the regime, and where a diverging motion left its bounds.
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    char name[WHIRL_NAME_SIZE], reason[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(&verdict, name, sizeof name);
    whirl_verdict_reason(&verdict, reason, sizeof reason);
    document_put(well, object, "regime", document_text(whirl_regime_name(verdict.regime)));
    document_put(well, object, "period", json_integer(verdict.period));
    document_put(well, object, "curves", json_integer(verdict.curves));
    if (verdict.regime == WHIRL_DIVERGING)
        document_put(well, object, "diverged_at", document_number(verdict.diverged_at));
    if (verdict.limit > 0.0) {
        document_put(well, object, "limit", document_number(verdict.limit));
        document_put(well, object, "limit_coordinate", json_integer(verdict.limit_coordinate));
    }
    // Put the verdict in words, and how far it can be trusted.
    document_put(well, object, "verdict", document_text(name));
    document_put(well, object, "reason", document_text(reason));
    put_confidence(well, object, &verdict);
    // Put the numbers from which the verdict follows.
    json_t *evidence = json_object();
    document_put(well, evidence, "exponent", document_number(verdict.exponent.value));
    document_put(well, evidence, "exponent_error", document_number(verdict.exponent.error));
    document_put(well, evidence, "recurrence", document_number(verdict.recurrence));
    document_put(well, evidence, "recurrence_period", json_integer(verdict.recurrence_period));
    document_put(well, evidence, "recurrence_trend", document_number(verdict.recurrence_trend));
    document_put(well, evidence, "regularity", document_number(verdict.regularity));
    document_put(well, evidence, "chaos", document_number(verdict.chaos));
    document_put(well, evidence, "rotation", document_number(verdict.rotation));
    document_put(well, evidence, "neighbours", json_integer(verdict.neighbours));
    document_put(well, evidence, "followed", document_number(verdict.followed));
    document_put(well, evidence, "swelling", document_number(verdict.swelling));
    document_put(well, evidence, "coexisting", verdict.sought ? json_integer(verdict.coexisting) : json_null());
    document_put(well, evidence, "survived", verdict.survived > 0.0 ? document_number(verdict.survived) : json_null());
    document_put(well, evidence, "ended", verdict.survived > 0.0 ? json_integer(verdict.ended) : json_null());
    document_put(well, evidence, "settling", document_number(verdict.settling.value));
    document_put(well, evidence, "settling_error", document_number(verdict.settling.error));
    document_put(well, evidence, "line", document_number(verdict.line));
    document_put(well, evidence, "line_share", document_number(verdict.line_share));
    document_put(well, evidence, "line_trend", document_number(verdict.line_trend));
    document_put(well, evidence, "second", document_number(verdict.second));
    document_put(well, evidence, "second_share", document_number(verdict.second_share));
    document_put(well, evidence, "second_trend", document_number(verdict.second_trend));
    document_put(well, evidence, "rest_distance", document_number(verdict.rest_distance));
    document_put(well, evidence, "rest_order", document_number(verdict.rest_order));
    document_put(well, object, "evidence", evidence);
}

static void put_lyapunov(bool *well, json_t *object, const whirl_table *table, size_t point) {
    const double *largest = whirl_table_field(table, point, WHIRL_FIELD_LYAPUNOV_LARGEST, 0);
    const double *error = whirl_table_field(table, point, WHIRL_FIELD_LYAPUNOV_ERROR, 0);
    if (!largest || !error) return;
    json_t *exponent = json_object();
    document_put(well, exponent, "largest", document_number(*largest));
    document_put(well, exponent, "error", document_number(*error));
    document_put(well, object, "lyapunov", exponent);
}

static void put_exponents(bool *well, json_t *object, const whirl_table *table, size_t point) {
    const double *values = whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_VALUES, 0);
    const double *errors = whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_ERRORS, 0);
    const double *sum = whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_SUM, 0);
    const double *exact = whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_SUM_EXACT, 0);
    const double *dimension = whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_DIMENSION, 0);
    const double *failed =
        whirl_table_field(table, point, WHIRL_FIELD_EXPONENTS_FAILED, 0); // absent in results of older versions
    if (!values || !errors || !sum || !exact || !dimension) return;
    const size_t count = whirl_layout_field(&table->layout, WHIRL_FIELD_EXPONENTS_VALUES)->rows;
    json_t *exponents = json_object();
    document_put(well, exponents, "values", numbers_array(well, values, count));
    document_put(well, exponents, "errors", numbers_array(well, errors, count));
    document_put(well, exponents, "sum", document_number(*sum));
    document_put(well, exponents, "sum_exact", document_number(*exact));
    document_put(well, exponents, "dimension", document_number(*dimension));
    if (failed) document_put(well, exponents, "failed", json_boolean(*failed > 0.5));
    document_put(well, object, "exponents", exponents);
}

// Returns an object with all numbers and rows of an analysis ("orbit/") at a point, station or contact: max_radius,
// mean, ... newtons: factor from stored forces to N.
static json_t *numbers_of(const char *analysis, whirl_extent extent, double newtons, bool *well,
                          const whirl_table *table, size_t point, size_t which) {
    const size_t length = strlen(analysis);
    json_t *object = json_object();
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *field = &table->layout.fields[i];
        if (field->extent != extent || field->rows != 1 || strncmp(field->name, analysis, length) != 0) continue;
        const double *values = whirl_table_field(table, point, field->name, which);
        const double factor = strcmp(field->unit, "force") == 0 ? newtons : 1.0;
        if (!values || field->columns == 0) continue;
        document_put(well, object, field->name + length,
                     field->columns == 1 ? document_number(factor * *values)
                                         : numbers_array(well, values, field->columns));
    }
    return object;
}

/// Writes the Floquet analysis of a settled motion; missing numbers are null.
static void put_floquet(bool *well, json_t *object, const whirl_table *table, size_t point) {
    const double *multipliers = whirl_table_field(table, point, WHIRL_FIELD_FLOQUET_MULTIPLIERS, 0);
    if (!multipliers) return;
    json_t *floquet = numbers_of("floquet/", WHIRL_PER_POINT, 1.0, well, table, point, 0), *pairs = json_array();
    const size_t count = whirl_layout_field(&table->layout, WHIRL_FIELD_FLOQUET_MULTIPLIERS)->rows;
    for (size_t i = 0; i < count && !isnan(multipliers[2 * i]); i++)
        document_append(well, pairs, numbers_array(well, multipliers + 2 * i, 2));
    document_put(well, floquet, "multipliers", pairs);
    document_put(well, object, "floquet", floquet);
}

// Returns the numbers of a contact; "fraction" is an older name of "share".
static json_t *contact_numbers(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                               size_t contact) {
    json_t *object = numbers_of("rub/", WHIRL_PER_CONTACT, result->force_scale, well, table, point, contact);
    const double *share = whirl_table_field(table, point, WHIRL_FIELD_RUB_SHARE, contact);
    if (share) document_put(well, object, "fraction", document_number(*share));
    return object;
}

// Writes times in contact as shares of the record, forces in newtons; "fraction" is the largest of all contacts.
static void put_rub(bool *well, json_t *object, const whirl_result *result, const whirl_table *table, size_t point) {
    const double *contact = whirl_table_field(table, point, WHIRL_FIELD_RUB_CONTACT, 0);
    if (!contact) return;
    json_t *rub = json_object();
    json_t *contacts = json_object();
    document_put(well, rub, "contact", isnan(*contact) ? json_null() : json_boolean(*contact != 0.0));
    // Without contacts the share is 0; a diverged motion has none.
    const double none = isnan(*contact) ? (double)NAN : 0.0;
    document_put(well, rub, "fraction",
                 document_number(result->contact_count ? rub_share(table, point, result->contact_count) : none));
    for (size_t i = 0; i < result->contact_count; ++i)
        document_put(well, contacts, result->contacts[i], contact_numbers(well, result, table, point, i));
    document_put(well, rub, "contacts", contacts);
    document_put(well, object, "rub", rub);
}

static json_t *station_orbit(bool *well, const whirl_table *table, size_t point, size_t station) {
    return numbers_of("orbit/", WHIRL_PER_STATION, 1.0, well, table, point, station);
}

static json_t *station_winding(bool *well, const whirl_table *table, size_t point, size_t station) {
    return numbers_of("winding/", WHIRL_PER_STATION, 1.0, well, table, point, station);
}

// Returns the points of the section, [x, y].
static json_t *station_section(bool *well, const whirl_table *table, size_t point, size_t station) {
    const numbers section = point_section(table, point, station);
    json_t *array = json_array();
    for (size_t n = 0; n < section.rows; ++n)
        document_append(well, array, numbers_array(well, section.at + n * section.columns, 2));
    return array;
}

// Returns the lines of the spectrum, largest first. "amplitude" is the amplitude of x; all amplitudes are zero to peak.
static json_t *station_lines(bool *well, const whirl_table *table, size_t point, size_t station) {
    enum { ORDER, X, Y, FORWARD, BACKWARD };
    const numbers lines = point_lines(table, point, station);
    json_t *array = json_array();
    for (size_t n = 0; n < lines.rows; ++n) {
        const double *row = lines.at + n * lines.columns;
        json_t *object = json_object();
        document_put(well, object, "order", document_number(row[ORDER]));
        document_put(well, object, "amplitude", document_number(row[X]));
        document_put(well, object, "direction", document_text(row[FORWARD] >= row[BACKWARD] ? "forward" : "backward"));
        document_put(well, object, "x", document_number(row[X]));
        document_put(well, object, "y", document_number(row[Y]));
        document_put(well, object, "forward", document_number(row[FORWARD]));
        document_put(well, object, "backward", document_number(row[BACKWARD]));
        document_append(well, array, object);
    }
    return array;
}

// Returns the lines of a motion besides x and y, largest first.
static json_t *extra_lines(bool *well, const whirl_table *table, const char *name, size_t point, size_t station) {
    const whirl_field *field = whirl_layout_field(&table->layout, name);
    const double *lines = whirl_table_field(table, point, name, station);
    json_t *array = json_array();
    for (size_t n = 0; field && lines && n < field->rows && !isnan(lines[2 * n]); ++n) {
        json_t *object = json_object();
        document_put(well, object, "order", document_number(lines[2 * n]));
        document_put(well, object, "amplitude", document_number(lines[2 * n + 1]));
        document_append(well, array, object);
    }
    return array;
}

static json_t *station_axial_lines(bool *well, const whirl_table *table, size_t point, size_t station) {
    return extra_lines(well, table, WHIRL_FIELD_SPECTRUM_AXIAL_LINES, point, station);
}

static json_t *station_twist_lines(bool *well, const whirl_table *table, size_t point, size_t station) {
    return extra_lines(well, table, WHIRL_FIELD_SPECTRUM_TWIST_LINES, point, station);
}

// Adds amplitude and lag of a motion besides x and y, if the table has it.
static void put_extra_part(bool *well, json_t *object, const whirl_table *table, size_t point, size_t station,
                           const char *name, const char *amplitude, const char *lag) {
    const double *size = whirl_table_field(table, point, amplitude, station);
    const double *behind = whirl_table_field(table, point, lag, station);
    if (!size || !behind) return;
    json_t *part = json_object();
    document_put(well, part, "amplitude", document_number(*size));
    document_put(well, part, "lag", document_number(*behind));
    document_put(well, object, name, part);
}

// Returns the synchronous part: amplitude, zero to peak, and phase lag in degrees, of x, y and both circular motions,
// of the axial displacement of stations that move along their shafts, and of the twist of those that also move
// otherwise (rad).
static json_t *station_synchronous(bool *well, const whirl_table *table, size_t point, size_t station) {
    static const char *const parts[] = {"x", "y", "forward", "backward"};
    const double *amplitude = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, station);
    const double *lag = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, station);
    json_t *object = json_object();
    for (size_t i = 0; i < 4 && amplitude && lag; ++i) {
        json_t *part = json_object();
        document_put(well, part, "amplitude", document_number(amplitude[i]));
        document_put(well, part, "lag", document_number(lag[i]));
        document_put(well, object, parts[i], part);
    }
    put_extra_part(well, object, table, point, station, "axial", WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS,
                   WHIRL_FIELD_SPECTRUM_AXIAL_LAG);
    put_extra_part(well, object, table, point, station, "twist", WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS,
                   WHIRL_FIELD_SPECTRUM_TWIST_LAG);
    return object;
}

// Returns the share of the motion that is in the lines of the spectrum.
static json_t *station_share(bool *well, const whirl_table *table, size_t point, size_t station) {
    (void)well;
    return document_number(whirl_table_number(table, point, WHIRL_FIELD_SPECTRUM_SHARE, station));
}

typedef json_t *(*station_part)(bool *well, const whirl_table *table, size_t point, size_t station);

static void put_stations(bool *well, json_t *object, const char *key, station_part part, const whirl_result *result,
                         const whirl_table *table, size_t point) {
    json_t *stations = json_object();
    for (size_t i = 0; i < result->station_count; ++i)
        document_put(well, stations, result->stations[i].name, part(well, table, point, i));
    document_put(well, object, key, stations);
}

// Returns the orbit of a station: bounds, and the section once a revolution, [x, y].
static json_t *station_trace(bool *well, const whirl_table *table, size_t point, size_t station) {
    json_t *object = numbers_of("trace/", WHIRL_PER_STATION, 1.0, well, table, point, station);
    const double *section = whirl_table_field(table, point, WHIRL_FIELD_TRACE_SECTION, station);
    const size_t rows = whirl_layout_field(&table->layout, WHIRL_FIELD_TRACE_SECTION)->rows;
    json_t *array = json_array();
    for (size_t n = 0; n < rows && !isnan(section[4 * n]); ++n)
        document_append(well, array, numbers_array(well, section + 4 * n, 2));
    document_put(well, object, "section", array);
    return object;
}

static json_t *multipliers_of(bool *well, const whirl_orbit *orbit) {
    json_t *array = json_array();
    for (size_t i = 0; i < orbit->multiplier_count; ++i) {
        const double both[2] = {orbit->multipliers[i].real, orbit->multipliers[i].imaginary};
        document_append(well, array, numbers_array(well, both, 2));
    }
    return array;
}

static json_t *touches_of(bool *well, const whirl_orbit *orbit) {
    json_t *array = json_array();
    for (size_t i = 0; i < orbit->touch_count; ++i) {
        json_t *touch = json_object();
        document_put(well, touch, "intervals", json_integer((json_int_t)orbit->touches[i].intervals));
        document_put(well, touch, "nearest", document_number(orbit->touches[i].nearest));
        document_put(well, touch, "share", document_number(orbit->touches[i].share));
        document_append(well, array, touch);
    }
    return array;
}

// Writes a point of a branch: its orbit, its special point, and its multipliers.
static void put_trace(bool *well, json_t *object, const whirl_table *table, size_t point) {
    whirl_trace at;
    // Read the point of the branch.
    char name[WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE];
    if (whirl_table_trace(table, point, &at).code != WHIRL_OK) return;
    const whirl_orbit *orbit = at.point.orbit;
    whirl_orbit_name(orbit, name, sizeof name);
    whirl_special_text(&at.point, text, sizeof text);
    // Put its place among branches, and what happens there.
    document_put(well, object, "of_branch", json_integer((json_int_t)at.branch));
    document_put(well, object, "parent", json_integer((json_int_t)at.parent));
    document_put(well, object, "motion", document_text(name));
    document_put(well, object, "special", document_text(whirl_special_name(at.point.special)));
    document_put(well, object, "meaning", document_text(text));
    document_put(well, object, "criticality", document_number(at.point.criticality));
    document_put(well, object, "second", document_number(at.point.second));
    document_put(well, object, "end",
                 isnan(at.end) ? json_null() : document_text(whirl_branch_end_text((whirl_branch_end)at.end)));
    // Put the orbit with its multipliers and contacts.
    document_put(well, object, "revolutions", json_integer((json_int_t)orbit->revolutions));
    document_put(well, object, "period", document_number(orbit->period));
    document_put(well, object, "unstable", json_integer((json_int_t)orbit->unstable));
    document_put(well, object, "residual", document_number(orbit->residual));
    document_put(well, object, "multipliers", multipliers_of(well, orbit));
    document_put(well, object, "touches", touches_of(well, orbit));
    document_put(well, object, "nodes", numbers_array(well, orbit->nodes, orbit->segment_count * orbit->dimension));
    whirl_orbit_free(at.point.orbit);
}

// Returns the rows of a field that have numbers.
static json_t *rows_of(bool *well, const whirl_table *table, size_t point, const char *field, size_t which) {
    const whirl_field *found = whirl_layout_field(&table->layout, field);
    const double *row = whirl_table_field(table, point, field, which);
    json_t *array = json_array();
    for (size_t n = 0; row && n < found->rows && !isnan(row[0]); ++n, row += found->columns)
        document_append(well, array, found->columns == 1 ? document_number(row[0]) : numbers_array(well, row, 2));
    return array;
}

// Returns the torus at a station: frequency and amplitude of its second line, bounds, and the closed curve of its
// section with bounds once a revolution, [x, y].
static json_t *station_torus(bool *well, const whirl_table *table, size_t point, size_t station) {
    json_t *object = numbers_of("torus/", WHIRL_PER_STATION, 1.0, well, table, point, station);
    document_put(well, object, "section", rows_of(well, table, point, WHIRL_FIELD_TORUS_SECTION, station));
    document_put(well, object, "section_low", rows_of(well, table, point, WHIRL_FIELD_TORUS_SECTION_LOW, station));
    document_put(well, object, "section_high", rows_of(well, table, point, WHIRL_FIELD_TORUS_SECTION_HIGH, station));
    return object;
}

// Writes a torus: its branch, its rotation number, exponents [value, error], and the nodes of its curve.
static void put_torus(bool *well, json_t *object, const whirl_table *table, size_t point) {
    const double end = *whirl_table_field(table, point, WHIRL_FIELD_TORUS_END, 0);
    const double *resonance = whirl_table_field(table, point, WHIRL_FIELD_TORUS_RESONANCE, 0);
    char text[WHIRL_MESSAGE_SIZE];
    json_t *torus = numbers_of("torus/", WHIRL_PER_POINT, 1.0, well, table, point, 0);
    whirl_torus_end_text(end, resonance[0], resonance[1], text, sizeof text);
    document_put(well, torus, "end", isnan(end) ? json_null() : document_text(text));
    document_put(well, torus, "exponents", rows_of(well, table, point, WHIRL_FIELD_TORUS_EXPONENTS, 0));
    document_put(well, torus, "nodes", rows_of(well, table, point, WHIRL_FIELD_TORUS_NODES, 0));
    document_put(well, object, "torus", torus);
}

/// Returns the member `name` of an object, itself an object; creates it if necessary.
static json_t *member(bool *well, json_t *object, const char *name) {
    if (!json_object_get(object, name)) document_put(well, object, name, json_object());
    return json_object_get(object, name);
}

/// Returns the rows of a field up to the last one with a number: numbers, or rows of numbers.
static json_t *whole_field(bool *well, const whirl_table *table, size_t point, const whirl_field *field, size_t which) {
    const double *const values = whirl_table_field(table, point, field->name, which);
    if (field->rows == 1 && field->columns == 1) return document_number(*values);
    if (field->rows == 1) return numbers_array(well, values, field->columns);
    size_t count = field->rows * field->columns;
    while (count > 0 && isnan(values[count - 1])) count--;
    json_t *array = json_array();
    for (size_t n = 0; n < count; n += field->columns)
        document_append(well, array,
                        field->columns == 1 ? document_number(values[n])
                                            : numbers_array(well, values + n, field->columns));
    return array;
}

/// Puts the values that a point reached in the validity ranges of laws, and the forces (N) of contacts closed at rest:
/// "ranges": {"left": 1, "reached": [[0.97, 0.95], ...], "held": {"rub at disc": 120}}.
static void put_ranges(bool *well, json_t *object, const whirl_result *result, const whirl_table *table, size_t point) {
    const whirl_field *const field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_REACHED);
    if (field) {
        const double *const reached = whirl_table_field(table, point, field->name, 0);
        json_t *ranges = member(well, object, "ranges"), *rows = json_array();
        document_put(well, ranges, "left",
                     document_number(whirl_table_number(table, point, WHIRL_FIELD_RANGES_LEFT, 0)));
        for (size_t i = 0; i < field->rows; i++) document_append(well, rows, numbers_array(well, reached + 2 * i, 2));
        document_put(well, ranges, "reached", rows);
    }
    for (size_t c = 0; c < result->contact_count && whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_HELD); c++) {
        const double force = whirl_table_number(table, point, WHIRL_FIELD_RANGES_HELD, c);
        document_put(well, member(well, member(well, object, "ranges"), "held"), result->contacts[c],
                     document_number(result->force_scale * force));
    }
}

/// Writes all fields of a machine at rest: "modes": {"frequency": [...], ..., "stations": {"disc": {"shape": [...]}}}.
static void put_rest(bool *well, json_t *object, const whirl_result *result, const whirl_table *table, size_t point) {
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *const field = &table->layout.fields[i];
        const char *const name = strchr(field->name, '/');
        if (!name) continue;
        char analysis[WHIRL_NAME_SIZE];
        snprintf(analysis, sizeof analysis, "%.*s", (int)(name - field->name), field->name);
        if (strcmp(analysis, whirl_analysis_of_ranges()) == 0) continue;
        json_t *const part = member(well, object, analysis);
        if (field->extent == WHIRL_PER_POINT)
            document_put(well, part, name + 1, whole_field(well, table, point, field, 0));
        for (size_t s = 0; field->extent == WHIRL_PER_STATION && s < result->station_count; ++s)
            document_put(well, member(well, member(well, part, "stations"), result->stations[s].name), name + 1,
                         whole_field(well, table, point, field, s));
        for (size_t c = 0; field->extent == WHIRL_PER_CONTACT && c < result->contact_count; ++c)
            document_put(well, member(well, member(well, part, "contacts"), result->contacts[c]), name + 1,
                         whole_field(well, table, point, field, c));
    }
}

static json_t *point_object(bool *well, const whirl_result *result, const whirl_table *table, size_t point) {
    // Put what all kinds of points have.
    json_t *object = json_object();
    document_put(well, object, "parameters", point_parameters(well, result, table, point));
    if (table->length_scales) document_put(well, object, "length_scale", document_number(table->length_scales[point]));
    if (table->branch[point] != 0) document_put(well, object, "branch", json_integer(table->branch[point]));
    // Points of tori, of branches and of machines at rest have other data than motions.
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_TORUS_NUMBER)) {
        put_torus(well, object, table, point);
        put_stations(well, object, "stations", station_torus, result, table, point);
        return object;
    }
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_TRACE_NUMBER)) {
        put_trace(well, object, table, point);
        put_stations(well, object, "stations", station_trace, result, table, point);
        return object;
    }
    if (!whirl_analysis_kind(table->analyses)->moves) {
        put_rest(well, object, result, table, point);
        put_ranges(well, object, result, table, point);
        return object;
    }
    // Put the verdict of a motion, its stability and its contacts.
    if (table->refine > 0)
        document_put(well, object, "width",
                     document_number(whirl_table_number(table, point, WHIRL_FIELD_MAP_WIDTH, 0)));
    put_verdict(well, object, table, point);
    put_ranges(well, object, result, table, point);
    put_refinement(well, object, table, point);
    put_lyapunov(well, object, table, point);
    put_exponents(well, object, table, point);
    put_floquet(well, object, table, point);
    put_rub(well, object, result, table, point);
    // Put the analyses of each station.
    put_stations(well, object, "stations", station_orbit, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_WINDING_WINDING))
        put_stations(well, object, "winding", station_winding, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_POINCARE_SECTION))
        put_stations(well, object, "poincare", station_section, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_LINES))
        put_stations(well, object, "spectrum", station_lines, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_AXIAL_LINES))
        put_stations(well, object, "axial_spectrum", station_axial_lines, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_TWIST_LINES))
        put_stations(well, object, "twist_spectrum", station_twist_lines, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_SHARE))
        put_stations(well, object, "spectrum_share", station_share, result, table, point);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS))
        put_stations(well, object, "synchronous", station_synchronous, result, table, point);
    return object;
}

/// Removes arrays with a row for every revolution or node, which are the largest part of a document.
static void leave_out_rows(json_t *point) {
    static const char *const rows[] = {"section", "section_low", "section_high"};
    const char *name;
    json_t *station;
    json_object_del(point, "poincare");
    json_object_del(point, "nodes");
    json_object_del(json_object_get(point, "torus"), "nodes");
    json_object_foreach(json_object_get(point, "stations"), name, station) for (size_t i = 0;
                                                                                i < sizeof rows / sizeof *rows; ++i)
        json_object_del(station, rows[i]);
}

// Writes the start of a motion if points have several starts: its number, the neighbour that it continues, its initial
// state, and its attractor, null if unknown.
static void put_start(bool *well, json_t *object, const whirl_result *result, const whirl_table *table, size_t point,
                      const whirl_coexistence *found) {
    json_t *start = json_object();
    const double number = whirl_table_number(table, point, WHIRL_FIELD_STARTS_NUMBER, 0);
    document_put(well, start, "number", json_integer(isfinite(number) ? (json_int_t)number : 0));
    if (table->neighbours > 0) {
        const double neighbour = whirl_table_number(table, point, WHIRL_FIELD_STARTS_NEIGHBOUR, 0);
        document_put(well, start, "neighbour", neighbour > 0.0 ? json_integer((json_int_t)neighbour) : json_null());
    }
    for (size_t s = 0; s < result->station_count; ++s) {
        const double *state = whirl_table_field(table, point, WHIRL_FIELD_STARTS_STATE, s);
        if (state) document_put(well, start, result->stations[s].name, numbers_array(well, state, 4));
    }
    document_put(well, object, "start", start);
    const size_t label = found->labels[point];
    document_put(well, object, "attractor", label > 0 ? json_integer((json_int_t)label) : json_null());
}

/// Writes the names of a point's modes along the parameter, by rising frequency as in the fields.
static void put_mode_names(bool *well, json_t *object, const whirl_table *table, const mode_lines *lines,
                           size_t point) {
    json_t *names = json_array();
    const double *const frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    const size_t least = lines->modes == 1; // a single name is not a list, as in whole_field
    size_t count = lines->modes;
    while (count > least && isnan(frequency[count - 1])) count--;
    for (size_t i = 0; i < count; i++) {
        const char *name = mode_lines_name(lines, point, i);
        document_append(well, names, *name ? document_text(name) : json_null());
    }
    json_t *own = names;
    if (least == 1) {
        own = json_incref(json_array_get(names, 0));
        json_decref(names);
    }
    document_put(well, member(well, object, "modes"), "name", own);
}

json_t *point_json(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                   const whirl_coexistence *found, const mode_lines *lines, bool full) {
    json_t *object = point_object(well, result, table, point);
    if (!full) leave_out_rows(object);
    if (found->labels) put_start(well, object, result, table, point, found);
    if (lines) put_mode_names(well, object, table, lines, point);
    return object;
}
