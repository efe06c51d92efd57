// How responses to unbalance are shown.
#include "shown_kinds.h"
#include "summary.h"

/// The largest response of every station, and where.
static void summarize(FILE *out, const whirl_result *result, const whirl_table *table) {
    const whirl_shown_units units = summary_units(result);
    const whirl_unit unit = whirl_shown_parameter(&units, table->parameter), length = summary_length_unit(&units);
    for (size_t station = 0; station < result->station_count; station++) {
        double largest = 0.0;
        size_t where = 0;
        for (size_t point = 0; point < table->count; point++) {
            const double *axes = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
            if (!whirl_table_done(table, point) || !axes || !(axes[0] > largest)) continue;
            largest = axes[0];
            where = point;
        }
        fprintf(out, "  %s: largest response %.4g %s %s", result->stations[station].name,
                units.amplitude * largest * whirl_result_length_scale(result, table, where) / length.size, length.name,
                units.amplitude_name);
        if (table->parameter[0])
            fprintf(out, " at %.6g%s%s", table->values[where] / unit.size, *unit.name ? " " : "", unit.name);
        fputc('\n', out);
    }
}

const shown_kind shown_unbalance = {.field = WHIRL_FIELD_UNBALANCE_AMPLITUDE, .explored = true, .summarize = summarize};
