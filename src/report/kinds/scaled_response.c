#include "scaled_response.h"
#include "margins.h"

#include <math.h>
#include <stdlib.h>

#include "whirl/engine/analyze.h"
#include "whirl/internal/response_peaks.h"

/// Returns true if any station has a clearance.
static bool scaled_has_clearances(const whirl_result *result, const whirl_table *table) {
    for (size_t s = 0; s < result->station_count; s++)
        if (table->count > 0 && whirl_table_number(table, 0, WHIRL_FIELD_UNBALANCE_CLEARANCE, s) > 0.0) return true;
    return false;
}

static bool scaled_has_probes(const whirl_result *result, const whirl_table *table, size_t station, bool clearances) {
    if (*table->record.probes_at) return margin_probed(result, table, station);
    return !clearances || whirl_table_number(table, 0, WHIRL_FIELD_UNBALANCE_CLEARANCE, station) > 0.0;
}

bool scaled_response_checks(const whirl_result *result, const whirl_table *table, size_t station) {
    const double *placed = whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_PLACED, station);
    return margin_probed(result, table, station) || (placed && hypot(placed[0], placed[1]) > 0.0) ||
           whirl_table_number(table, 0, WHIRL_FIELD_UNBALANCE_CLEARANCE, station) > 0.0;
}

const char *const scaled_response_lacks =
    "points do not reach over the running speeds, or nothing moves there: compute more points";

/// Returns the largest amplitude in m at a probe between two speeds: that of a point or, if speeds rise along the
/// table, interpolated between points. work [3 x points of the table] is workspace.
static double scaled_largest_seen(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                                  double low, double high, double *work) {
    double *const sizes = work + table->count;
    const size_t rising = margin_response(result, table, station, probe, work, sizes, sizes + table->count);
    if (rising > 0) return whirl_response_largest(rising, work, sizes, low, high);
    double largest = 0.0;
    for (size_t point = 0; point < table->count; point++) {
        const double speed = whirl_table_number(table, point, WHIRL_FIELD_UNBALANCE_SPEED, 0);
        if (!whirl_table_done(table, point) || speed < low * (1.0 - 1e-9) || speed > high * (1.0 + 1e-9)) continue;
        largest = fmax(largest, whirl_result_length_scale(result, table, point) *
                                    whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_PROBE, station)[probe]);
    }
    return largest;
}

/// Returns the speed up to which clearances are checked: that of the first point at or above the trip speed, so that
/// the points on both sides of the trip speed are included. Infinite if no trip speed is given, or no point reaches it.
static double scaled_last_speed(const whirl_table *table) {
    double last = INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        const double speed = whirl_table_number(table, i, WHIRL_FIELD_UNBALANCE_SPEED, 0);
        if (table->record.trip > 0.0 && whirl_table_done(table, i) && speed >= table->record.trip * (1.0 - 1e-9))
            last = fmin(last, speed);
    }
    return last;
}

bool scaled_response_scale(const whirl_result *result, const whirl_table *table, response_scale *out) {
    static const double rpm = 0.104719755119659774, most = 6.0;
    const bool clearances = scaled_has_clearances(result, table);
    double low, high;
    const bool running = margin_running(table, &low, &high);
    *out = (response_scale){.limit = 25.4e-6 * fmin(1.0, sqrt(12000.0 * rpm / high))};
    double *const work = running ? malloc((3 * table->count + 1) * sizeof *work) : NULL;
    if (!work) return false;
    for (size_t s = 0; s < result->station_count; s++)
        for (size_t probe = 0; probe < 2 && scaled_has_probes(result, table, s, clearances); probe++) {
            const double seen = 2.0 * scaled_largest_seen(result, table, s, probe, low, high, work);
            if (seen > out->largest) out->largest = seen, out->station = s;
        }
    free(work);
    out->factor = fmin(most, out->limit / out->largest);
    out->beyond = out->largest > out->limit;
    out->trip = table->record.trip;
    out->reaches = isfinite(scaled_last_speed(table));
    return out->largest > 0.0;
}

size_t scaled_response_all(const whirl_result *result, const whirl_table *table, const response_scale *by,
                           scaled_response *rows) {
    static const double share = 0.75;
    const double last = scaled_last_speed(table);
    size_t count = 0;
    // Find the speed at which each station comes nearest to its clearance.
    for (size_t s = 0; s < result->station_count; s++) {
        scaled_response row = {.station = s, .axis = -1.0};
        for (size_t point = 0; point < table->count; point++) {
            const double length = 2.0 * whirl_result_length_scale(result, table, point);
            const double axis = by->factor * length * whirl_table_number(table, point, WHIRL_FIELD_UNBALANCE_AXES, s);
            const double clearance = length * whirl_table_number(table, point, WHIRL_FIELD_UNBALANCE_CLEARANCE, s);
            const double speed = whirl_table_number(table, point, WHIRL_FIELD_UNBALANCE_SPEED, 0);
            if (!whirl_table_done(table, point) || !(clearance > 0.0) || speed > last ||
                !(axis / clearance > row.axis / row.clearance || row.axis < 0.0))
                continue;
            row.axis = axis;
            row.clearance = clearance;
            row.speed = speed;
        }
        // The station holds if it takes at most `share` of its clearance.
        row.holds = row.axis <= share * row.clearance;
        if (row.axis >= 0.0) rows[count++] = row;
    }
    return count;
}

bool scaled_response_tightest(const whirl_result *result, const whirl_table *table, const response_scale *by,
                              scaled_response *row) {
    scaled_response *rows = calloc(result->station_count + 1, sizeof *rows);
    const size_t count = rows ? scaled_response_all(result, table, by, rows) : 0;
    for (size_t i = 0; i < count; i++)
        if (i == 0 || rows[i].axis / rows[i].clearance > row->axis / row->clearance) *row = rows[i];
    free(rows);
    return count > 0;
}
