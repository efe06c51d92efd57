#include "margins.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "name_list.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/internal/response_peaks.h"

bool margin_running(const whirl_table *table, double *low, double *high) {
    const double from = table->record.running_low, to = table->record.running_high;
    *low = from > 0.0 ? from : to;
    *high = to > 0.0 ? to : from;
    return *low > 0.0;
}

bool margin_asked(const whirl_table *table) {
    double low, high;
    return margin_running(table, &low, &high);
}

bool margin_probed(const whirl_result *result, const whirl_table *table, size_t station) {
    const char *list = table->record.probes_at;
    char name[WHIRL_NAME_SIZE];
    bool probed = !*list;
    while (!probed && name_list_next(&list, name)) probed = strcmp(name, result->stations[station].name) == 0;
    return probed;
}

const char *margin_lacks(const whirl_table *table) {
    static const double rounding = 1e-9;
    double low, high, first = INFINITY, last = 0.0;
    margin_running(table, &low, &high);
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const double speed = whirl_table_number(table, i, WHIRL_FIELD_UNBALANCE_SPEED, 0);
        if (isfinite(first) && !(speed > last)) return "points do not rise along the speed";
        first = fmin(first, speed);
        last = speed;
    }
    const bool over = first <= low * (1.0 + rounding) && last >= high * (1.0 - rounding);
    return over ? NULL : "points do not reach over the running speeds: compute more points";
}

size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags) {
    size_t count = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const double speed = whirl_table_number(table, i, WHIRL_FIELD_UNBALANCE_SPEED, 0);
        if (count > 0 && !(speed > speeds[count - 1])) return 0;
        speeds[count] = speed;
        sizes[count] = whirl_table_field(table, i, WHIRL_FIELD_UNBALANCE_PROBE, station)[probe] *
                       whirl_result_length_scale(result, table, i);
        lags[count++] = whirl_table_field(table, i, WHIRL_FIELD_UNBALANCE_PROBE_LAG, station)[probe];
    }
    return count;
}

/// Finds the peaks at probe 0 or 1 of a station.
static size_t find_peaks(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                         whirl_response_peak peaks[MARGIN_PEAKS]) {
    double *speeds = malloc((3 * table->count + 1) * sizeof *speeds);
    if (!speeds) return 0;
    double *sizes = speeds + table->count, *lags = sizes + table->count;
    const size_t count = margin_response(result, table, station, probe, speeds, sizes, lags);
    const size_t found = whirl_response_peaks(count, speeds, sizes, lags, MARGIN_PEAKS, peaks);
    free(speeds);
    return found;
}

static void write_way(const whirl_response_peak *peak, char text[MARGIN_TEXT]) {
    static const char *const ways[] = {"half power", "half power on one side", "phase slope"};
    const double enough = 8.0; // half-power points above this give the closed form's factor to 1 % (test_margins.c)
    if (peak->points < enough)
        snprintf(text, MARGIN_TEXT, "%s, of %.2g points: compute more there", ways[peak->way], peak->points);
    else
        snprintf(text, MARGIN_TEXT, "%s", ways[peak->way]);
}

/// Sets the required margin of a peak, the margin found, and the verdict.
static void ask_margin(const whirl_table *table, bool probed, const whirl_response_peak *peak, margin_row *row) {
    double low, high;
    row->had = row->asked = NAN;
    row->verdict = "";
    if (!margin_running(table, &low, &high)) return;
    if (!probed) {
        row->verdict = "not judged: no probe";
        return;
    }
    const bool above = peak->speed > high, below = peak->speed < low;
    row->asked = whirl_margin_required(peak->amplification, above);
    if (above) row->had = 100.0 * (peak->speed / high - 1.0);
    if (below) row->had = 100.0 * (1.0 - peak->speed / low);
    row->side = above ? "above" : below ? "below" : "within";
    row->judged = row->asked > 0.0;
    row->holds = row->had >= row->asked;
    row->verdict = !row->judged ? "no margin asked for (amplification below 2.5)" : row->holds ? "holds" : "fails";
}

size_t margin_rows(const whirl_result *result, const whirl_table *table, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]) {
    static const double degree = 3.14159265358979323846 / 180.0;
    const bool probed = margin_probed(result, table, station);
    whirl_response_peak peaks[MARGIN_PEAKS];
    size_t used = 0;
    for (size_t probe = 0; probe < 2; probe++) {
        const size_t count = find_peaks(result, table, station, probe, peaks);
        for (size_t i = 0; i < count; i++) {
            margin_row *row = &rows[used++];
            *row = (margin_row){.probe = table->record.probe_angle / degree + (probe ? 90.0 : 0.0),
                                .speed = peaks[i].speed,
                                .amplitude = peaks[i].amplitude,
                                .amplification = peaks[i].amplification,
                                .side = ""};
            write_way(&peaks[i], row->way);
            ask_margin(table, probed, &peaks[i], row);
        }
    }
    return used;
}

margin_tally margin_count(const whirl_result *result, const whirl_table *table) {
    margin_tally all = {.more = INFINITY};
    margin_row rows[2 * MARGIN_PEAKS];
    for (size_t station = 0; station < result->station_count; station++) {
        const size_t count = margin_rows(result, table, station, rows);
        for (const margin_row *row = rows; row < rows + count; row++) {
            const double more = isnan(row->had) ? -(double)INFINITY : row->had - row->asked;
            all.unjudged +=
                !margin_probed(result, table, station) && whirl_margin_required(row->amplification, true) > 0.0;
            if (!row->judged) continue;
            if (all.judged++ == 0 || more < all.more) all.worst = *row, all.more = more, all.station = station;
            all.held += row->holds;
        }
    }
    if (margin_asked(table)) all.lacks = margin_lacks(table);
    all.verdict = all.held < all.judged ? WHIRL_FAILS
                  : all.lacks           ? WHIRL_NOT_KNOWN
                  : all.judged > 0      ? WHIRL_HOLDS
                                        : WHIRL_NOT_ASKED;
    return all;
}
