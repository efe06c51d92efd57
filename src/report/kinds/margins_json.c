#include "shown_kinds.h"

#include <math.h>
#include <stdlib.h>

/// In SI, zero to peak.
static const whirl_shown_units plain = {
    .size = {.name = "m", .size = 1.0}, .speed = {.name = "rad/s", .size = 1.0}, .amplitude = 1.0};

static json_t *placed_json(bool *well, const whirl_result *result, const whirl_table *table) {
    static const double degree = 3.14159265358979323846 / 180.0;
    json_t *array = json_array();
    for (size_t station = 0; station < result->station_count; station++) {
        const double *at = table->count > 0 ? whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_PLACED, station) : NULL;
        if (!at || !(hypot(at[0], at[1]) > 0.0)) continue;
        json_t *one = json_object();
        document_put(well, one, "station", document_text(result->stations[station].name));
        document_put(well, one, "moment", document_number(hypot(at[0], at[1])));
        document_put(well, one, "angle", document_number(atan2(at[1], at[0]) / degree));
        document_append(well, array, one);
    }
    return array;
}

static json_t *peaks_json(bool *well, const whirl_result *result, const whirl_table *table) {
    margin_row rows[2 * MARGIN_PEAKS];
    json_t *array = json_array();
    for (size_t station = 0; station < result->station_count; station++) {
        const size_t count = margin_rows(result, table, &plain, station, rows);
        for (const margin_row *row = rows; row < rows + count; row++) {
            json_t *one = json_object();
            document_put(well, one, "station", document_text(result->stations[station].name));
            document_put(well, one, "probe", document_number(row->probe));
            document_put(well, one, "speed", document_number(row->speed));
            document_put(well, one, "amplitude", document_number(row->amplitude));
            document_put(well, one, "amplification", document_number(row->amplification));
            document_put(well, one, "found_by", document_text(row->way));
            document_put(well, one, "margin", document_number(row->had));
            document_put(well, one, "asked", document_number(row->asked));
            document_put(well, one, "above", json_boolean(row->above));
            document_put(well, one, "holds", isnan(row->asked) ? json_null() : json_boolean(row->holds || !row->told));
            document_append(well, array, one);
        }
    }
    return array;
}

/// What scaled responses take of clearances; null where they are not scaled.
static json_t *scaled_json(bool *well, const whirl_result *result, const whirl_table *table) {
    scaled by;
    scaled_row *rows = malloc((result->station_count + 1) * sizeof *rows);
    *well = *well && rows;
    if (!rows || !scaled_of(result, table, &by)) {
        free(rows);
        return json_null();
    }
    json_t *object = json_object(), *array = json_array();
    document_put(well, object, "limit", document_number(by.limit));
    document_put(well, object, "largest", document_number(by.largest));
    document_put(well, object, "station", document_text(result->stations[by.station].name));
    document_put(well, object, "factor", document_number(by.factor));
    document_put(well, object, "beyond_limit", json_boolean(by.beyond));
    document_put(well, object, "trip", by.trip > 0.0 ? document_number(by.trip) : json_null());
    document_put(well, object, "reaches_trip", by.trip > 0.0 ? json_boolean(by.reaches) : json_null());
    const size_t count = scaled_rows(result, table, &by, rows);
    for (const scaled_row *row = rows; row < rows + count; row++) {
        json_t *one = json_object();
        document_put(well, one, "station", document_text(result->stations[row->station].name));
        document_put(well, one, "axis", document_number(row->axis));
        document_put(well, one, "speed", document_number(row->speed));
        document_put(well, one, "clearance", document_number(row->clearance));
        document_put(well, one, "holds", json_boolean(row->holds));
        document_append(well, array, one);
    }
    document_put(well, object, "clearances", array);
    free(rows);
    return object;
}

json_t *asked_json(bool *well, const whirl_result *result) {
    json_t *array = json_array();
    whirl_shown_units units; // sentences are those of the report, in its units
    *well = *well && whirl_result_shown_units(result, NULL, &units).code == WHIRL_OK;
    for (size_t t = 0; t < result->table_count && *well; t++) {
        const whirl_table *table = &result->tables[t];
        const asked_rows all = asked_of(&units, table);
        for (const asked_row *row = all.rows; row < all.rows + all.count; row++) {
            json_t *one = json_object();
            document_put(well, one, "table", document_text(table->name));
            document_put(well, one, "what", document_text(row->what));
            document_put(well, one, "asked", document_text(row->asked));
            document_put(well, one, "found", document_text(row->found));
            document_put(well, one, "verdict", document_text(asked_verdict_name(row->verdict)));
            document_put(well, one, "told", document_text(row->told));
            document_append(well, array, one);
        }
    }
    return array;
}

json_t *margins_json(bool *well, const whirl_result *result) {
    json_t *object = json_object();
    for (size_t t = 0; t < result->table_count; t++) {
        const whirl_table *table = &result->tables[t];
        if (table->count == 0 || !whirl_layout_field(&table->layout, WHIRL_FIELD_UNBALANCE_PROBE)) continue;
        json_t *one = json_object();
        document_put(well, one, "placed", placed_json(well, result, table));
        document_put(well, one, "peaks", peaks_json(well, result, table));
        document_put(well, one, "scaled", scaled_json(well, result, table));
        document_put(well, object, table->name, one);
    }
    return object;
}
