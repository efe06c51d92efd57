// Results as one JSON document, written point by point.
#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "quantities.h"
#include "utf8.h"
#include "whirl/result.h"
#include "whirl/version.h"

// 17 digits give the same double back.
enum { DUMP_FLAGS = JSON_REAL_PRECISION(17) | JSON_ENCODE_ANY, TEXT_SIZE = 1024 };

// JSON has no number for what is missing or infinite.
static json_t *number(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

// Text from a file may be anything; what is not UTF-8 becomes question marks.
static const char *make_valid(const char *from, char valid[TEXT_SIZE]) {
    size_t length = 0;
    while (*from && length + 4 < TEXT_SIZE) {
        const size_t bytes = utf8_length_of_text(from);
        if (bytes == 0) valid[length++] = '?';
        for (size_t i = 0; i < bytes; ++i) valid[length++] = from[i];
        from += bytes > 0 ? bytes : 1;
    }
    valid[length] = '\0';
    return valid;
}

static json_t *text(const char *from) {
    char valid[TEXT_SIZE];
    return json_string(make_valid(from, valid));
}

// Containers being filled; `well` becomes false where memory ran out.
static void put(bool *well, json_t *object, const char *key, json_t *value) {
    char valid[TEXT_SIZE];
    if (json_object_set_new(object, make_valid(key, valid), value) != 0) *well = false;
}

static void append(bool *well, json_t *array, json_t *value) {
    if (json_array_append_new(array, value) != 0) *well = false;
}

static json_t *numbers_array(bool *well, const double *values, size_t count) {
    json_t *array = json_array();
    for (size_t i = 0; i < count; ++i) append(well, array, number(values[i]));
    return array;
}

// ---------------------------------------------------------------- the parts of a point

// Given values; those of expressions belong to the case as written, not to the point. The one that varies has its own.
static json_t *point_parameters(bool *well, const whirl_result *result, const whirl_table *table, size_t point) {
    json_t *object = json_object();
    for (size_t i = 0; i < result->parameter_count; ++i) {
        const whirl_parameter *parameter = &result->parameters[i];
        const bool expression = parameter->text[strspn(parameter->text, " \t")] == '=';
        if (!expression) put(well, object, parameter->name, number(parameter->value));
    }
    if (*table->parameter) put(well, object, table->parameter, number(table->values[point]));
    return object;
}

// "confirmed" is the verdict at the second tolerance, null where there was none; "advice" what would settle it.
static void put_confidence(bool *well, json_t *object, const whirl_verdict *verdict) {
    char advice[WHIRL_MESSAGE_SIZE];
    whirl_verdict_advice(verdict, advice, sizeof advice);
    put(well, object, "confidence", text(whirl_confidence_name(verdict->confidence)));
    put(well, object, "advice", *advice ? text(advice) : json_null());
    json_t *confirmed = verdict->confirmed ? json_object() : json_null();
    if (verdict->confirmed) {
        put(well, confirmed, "regime", text(whirl_regime_name(verdict->other_regime)));
        put(well, confirmed, "period", json_integer(verdict->other_period));
    }
    put(well, object, "confirmed", confirmed);
}

// What refinement did to the point, and how the motion was integrated that the numbers are of.
static void put_refinement(bool *well, json_t *object, const whirl_table *table, size_t point) {
    json_t *refined = json_object();
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *field = &table->layout.fields[i];
        const numbers found = point_numbers(table, point, field->name, 0);
        if (strncmp(field->name, "refine/", 7) != 0 || !found.at) continue;
        put(well, refined, field->name + 7, number(found.at[0]));
    }
    if (json_object_size(refined) > 0)
        put(well, object, "refined", refined);
    else
        json_decref(refined);
}

static void put_verdict(bool *well, json_t *object, const whirl_table *table, size_t point) {
    if (!whirl_layout_field(&table->layout, "regime/code")) return;
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    char name[WHIRL_NAME_SIZE], reason[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(&verdict, name, sizeof name);
    whirl_verdict_reason(&verdict, reason, sizeof reason);
    put(well, object, "regime", text(whirl_regime_name(verdict.regime)));
    put(well, object, "period", json_integer(verdict.period));
    put(well, object, "curves", json_integer(verdict.curves));
    if (verdict.regime == WHIRL_DIVERGING) put(well, object, "diverged_at", number(verdict.diverged_at));
    put(well, object, "verdict", text(name));
    put(well, object, "reason", text(reason));
    put_confidence(well, object, &verdict);
    json_t *evidence = json_object();
    put(well, evidence, "exponent", number(verdict.exponent.value));
    put(well, evidence, "exponent_error", number(verdict.exponent.error));
    put(well, evidence, "recurrence", number(verdict.recurrence));
    put(well, evidence, "recurrence_period", json_integer(verdict.recurrence_period));
    put(well, evidence, "recurrence_trend", number(verdict.recurrence_trend));
    put(well, evidence, "regularity", number(verdict.regularity));
    put(well, object, "evidence", evidence);
}

static void put_lyapunov(bool *well, json_t *object, const whirl_table *table, size_t point) {
    const double *largest = whirl_table_field(table, point, "lyapunov/largest", 0);
    const double *error = whirl_table_field(table, point, "lyapunov/error", 0);
    if (!largest || !error) return;
    json_t *exponent = json_object();
    put(well, exponent, "largest", number(*largest));
    put(well, exponent, "error", number(*error));
    put(well, object, "lyapunov", exponent);
}

static json_t *contact_statistics(bool *well, const whirl_result *result, const whirl_table *table, size_t point,
                                  size_t contact) {
    const double *share = whirl_table_field(table, point, "rub/share", contact);
    const double *times = whirl_table_field(table, point, "rub/number", contact);
    const double *force = whirl_table_field(table, point, "rub/max_force", contact);
    json_t *object = json_object();
    if (share) put(well, object, "fraction", number(*share));
    if (times) put(well, object, "number", number(*times));
    if (force) put(well, object, "max_force", number(*force * result->force_scale));
    return object;
}

// Times in contact as shares of the record, forces in newtons; "fraction" is the largest of all contacts.
static void put_rub(bool *well, json_t *object, const whirl_result *result, const whirl_table *table, size_t point) {
    const double *contact = whirl_table_field(table, point, "rub/contact", 0);
    if (!contact) return;
    json_t *rub = json_object();
    json_t *contacts = json_object();
    put(well, rub, "contact", isnan(*contact) ? json_null() : json_boolean(*contact != 0.0));
    // A machine without contacts never touches; a motion that diverged left no statistics.
    const double none = isnan(*contact) ? (double)NAN : 0.0;
    put(well, rub, "fraction", number(result->contact_count ? rub_share(table, point, result->contact_count) : none));
    for (size_t i = 0; i < result->contact_count; ++i)
        put(well, contacts, result->contacts[i], contact_statistics(well, result, table, point, i));
    put(well, rub, "contacts", contacts);
    put(well, object, "rub", rub);
}

// Every single number, or row of them, that an analysis gives of a station: orbit/max_radius, orbit/mean, ...
static json_t *station_numbers(bool *well, const whirl_table *table, size_t point, size_t station) {
    json_t *object = json_object();
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *field = &table->layout.fields[i];
        if (field->extent != WHIRL_PER_STATION || field->rows != 1 || strncmp(field->name, "orbit/", 6) != 0) continue;
        const double *values = whirl_table_field(table, point, field->name, station);
        if (!values || field->columns == 0) continue;
        put(well, object, field->name + 6,
            field->columns == 1 ? number(*values) : numbers_array(well, values, field->columns));
    }
    return object;
}

// Points of the section, [x, y].
static json_t *station_section(bool *well, const whirl_table *table, size_t point, size_t station) {
    const numbers section = point_section(table, point, station);
    json_t *array = json_array();
    for (size_t n = 0; n < section.rows; ++n)
        append(well, array, numbers_array(well, section.at + n * section.columns, 2));
    return array;
}

// Lines of the spectrum, largest first. "amplitude" is that of x, zero to peak, as the other amplitudes are.
static json_t *station_lines(bool *well, const whirl_table *table, size_t point, size_t station) {
    enum { ORDER, X, Y, FORWARD, BACKWARD };
    const numbers lines = point_lines(table, point, station);
    json_t *array = json_array();
    for (size_t n = 0; n < lines.rows; ++n) {
        const double *row = lines.at + n * lines.columns;
        json_t *object = json_object();
        put(well, object, "order", number(row[ORDER]));
        put(well, object, "amplitude", number(row[X]));
        put(well, object, "direction", text(row[FORWARD] >= row[BACKWARD] ? "forward" : "backward"));
        put(well, object, "x", number(row[X]));
        put(well, object, "y", number(row[Y]));
        put(well, object, "forward", number(row[FORWARD]));
        put(well, object, "backward", number(row[BACKWARD]));
        append(well, array, object);
    }
    return array;
}

typedef json_t *(*station_part)(bool *well, const whirl_table *table, size_t point, size_t station);

static void put_stations(bool *well, json_t *object, const char *key, station_part part, const whirl_result *result,
                         const whirl_table *table, size_t point) {
    json_t *stations = json_object();
    for (size_t i = 0; i < result->station_count; ++i)
        put(well, stations, result->stations[i].name, part(well, table, point, i));
    put(well, object, key, stations);
}

static json_t *point_object(bool *well, const whirl_result *result, const whirl_table *table, size_t point) {
    json_t *object = json_object();
    put(well, object, "parameters", point_parameters(well, result, table, point));
    if (table->branch[point] != 0) put(well, object, "branch", json_integer(table->branch[point]));
    put_verdict(well, object, table, point);
    put_refinement(well, object, table, point);
    put_lyapunov(well, object, table, point);
    put_rub(well, object, result, table, point);
    put_stations(well, object, "stations", station_numbers, result, table, point);
    if (whirl_layout_field(&table->layout, "poincare/section"))
        put_stations(well, object, "poincare", station_section, result, table, point);
    if (whirl_layout_field(&table->layout, "spectrum/lines"))
        put_stations(well, object, "spectrum", station_lines, result, table, point);
    return object;
}

// ---------------------------------------------------------------- the document

// Writes one value and lets go of it.
static bool dump(bool well, json_t *value, FILE *stream) {
    const bool done = well && value && json_dumpf(value, stream, DUMP_FLAGS) == 0;
    json_decref(value);
    return done;
}

// Writes "key": value, with what goes before.
static bool dump_member(const char *before, const char *key, json_t *value, FILE *stream) {
    fputs(before, stream);
    const bool named = dump(true, text(key), stream);
    fputs(": ", stream);
    return dump(true, value, stream) && named;
}

static bool dump_points(const char *key, const whirl_result *result, const whirl_table *table, FILE *stream) {
    fprintf(stream, ",\n\"%s\": [", key);
    bool first = true;
    for (size_t point = 0; point < table->count; ++point) {
        bool well = true;
        if (!whirl_table_done(table, point)) continue;
        json_t *object = point_object(&well, result, table, point);
        fputs(first ? "\n" : ",\n", stream);
        if (!dump(well, object, stream)) return false;
        first = false;
    }
    fputs("\n]", stream);
    return true;
}

// The version that computed the result, where it says so.
static const char *version_of(const whirl_result *result) {
    for (size_t i = 0; i < result->fact_count; ++i)
        if (strcmp(result->facts[i].name, "version") == 0) return result->facts[i].value;
    return WHIRL_VERSION;
}

static bool dump_head(const whirl_result *result, FILE *stream) {
    const whirl_table *first = result->table_count ? &result->tables[0] : NULL;
    size_t done, total;
    const bool partial = whirl_result_partial(result, &done, &total);
    return dump_member("{", "whirl", text(version_of(result)), stream) &&
           dump_member(",\n", "title", text(result->title), stream) &&
           dump_member(",\n", "case", text(result->case_name), stream) &&
           dump_member(",\n", "speed", number(result->speed), stream) &&
           dump_member(",\n", "length_scale", number(result->length_scale), stream) &&
           dump_member(",\n", "force_scale", number(result->force_scale), stream) &&
           dump_member(",\n", "partial", json_boolean(partial), stream) &&
           dump_member(",\n", "table", first ? text(first->name) : json_null(), stream);
}

// Names of tables become keys beside these.
static whirl_status check_names(const whirl_result *result) {
    static const char *const taken[] = {"whirl",        "title",       "case",    "speed",
                                        "length_scale", "force_scale", "partial", "table",
                                        "points",       "parameters",  ""};
    for (size_t t = 0; t < result->table_count; ++t)
        for (size_t i = 0; i < sizeof taken / sizeof *taken; ++i)
            if (strcmp(result->tables[t].name, taken[i]) == 0 || strpbrk(result->tables[t].name, "\"\\\n"))
                return whirl_fail(WHIRL_BAD_INPUT, "'%s' cannot name a table in JSON", result->tables[t].name);
    return whirl_ok();
}

whirl_status whirl_result_write_json(const whirl_result *result, FILE *stream) {
    const whirl_status names = check_names(result);
    if (names.code != WHIRL_OK) return names;
    errno = 0;
    bool well = dump_head(result, stream);
    if (result->table_count == 0) fputs(",\n\"points\": []", stream);
    for (size_t i = 0; well && i < result->table_count; ++i)
        well = dump_points(i == 0 ? "points" : result->tables[i].name, result, &result->tables[i], stream);
    fputs("}\n", stream);
    if (fflush(stream) != 0 || ferror(stream))
        return whirl_fail(WHIRL_IO_ERROR, "cannot write JSON: %s", strerror(errno ? errno : EIO));
    return well ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to write JSON");
}
