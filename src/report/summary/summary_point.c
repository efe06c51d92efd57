// Writes the summary of one motion.
#include <math.h>
#include <stdio.h>

#include "machine_at.h"
#include "named_lines.h"
#include "quantities.h"
#include "regimes.h"
#include "summary.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/spectrum.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

static void print_rubs(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point) {
    const whirl_result *result = units->result;
    for (size_t i = 0; i < result->contact_count; i++) {
        const double share = whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, i);
        if (share > 0)
            fprintf(out, "  %s: %.3g %% of the time\n", result->contacts[i], 100 * share);
        else if (share >= 0)
            fprintf(out, "  %s: no contact\n", result->contacts[i]);
    }
}

/// Writes "largest radius: disc 1.154, journal 0.957 (in 0.2 mm 0-p)", or "disc 231, journal 191 µm 0-p" if the case
/// asks for a unit.
static void print_radii(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point) {
    const whirl_result *result = units->result;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_ORBIT_MAX_RADIUS)) return;
    const whirl_unit unit = summary_length_unit(units);
    const double scale = whirl_result_length_scale(result, table, point),
                 size = units->size.size > 0.0 ? scale / unit.size : 1.0;
    fputs("  largest radius:", out);
    for (size_t i = 0; i < result->station_count; i++)
        fprintf(out, "%s %s %.4g", i ? "," : "", result->stations[i].name,
                size * whirl_table_number(table, point, WHIRL_FIELD_ORBIT_MAX_RADIUS, i));
    if (size != 1.0 || scale == unit.size)
        fprintf(out, " %s 0-p\n", unit.name);
    else
        fprintf(out, " (in %.6g %s 0-p)\n", scale / unit.size, unit.name);
}

/// Writes "at 1X: disc x 0.0225 mm 0-p lag 86.6 deg, y 0.0193 mm 0-p lag 128 deg", a line for each station; phases as
/// whirl_synchronous has them.
static void print_synchronous(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point) {
    const whirl_result *result = units->result;
    const whirl_unit unit = summary_length_unit(units);
    const double size = units->amplitude * whirl_result_length_scale(result, table, point) / unit.size;
    const char *way = units->amplitude_name;
    for (size_t i = 0; i < result->station_count; i++) {
        const double *amplitude = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, i);
        const double *lag = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, i);
        if (!amplitude || !lag || !isfinite(lag[0]) || !isfinite(lag[1])) continue;
        fprintf(out, "  at 1X: %s x %.4g %s %s lag %.1f deg, y %.4g %s %s lag %.1f deg\n", result->stations[i].name,
                size * amplitude[0], unit.name, way, lag[0], size * amplitude[1], unit.name, way, lag[1]);
    }
}

/// Writes "at BPFO 3.085X of ball_bearing at rear: wheel x 0.0225 um 0-p, y 0.0193 um 0-p", for the largest lines of a
/// station whose orders have a name in the machine.
static void print_named(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point,
                        const whirl_system *system) {
    const whirl_result *result = units->result;
    enum { MOST = 4 };
    const double least = 0.01;
    const whirl_unit unit = summary_length_unit(units);
    const double size = units->amplitude * whirl_result_length_scale(result, table, point) / unit.size;
    for (size_t s = 0; s < result->station_count; s++) {
        const numbers lines = point_lines(table, point, s);
        int shown = 0;
        for (size_t i = 0; i < lines.rows && shown < MOST; i++) {
            const double *line = lines.at + i * lines.columns;
            char name[LINE_NAME_SIZE];
            whirl_named_order of;
            if (hypot(line[1], line[2]) < least * hypot(lines.at[1], lines.at[2])) break;
            if (!named_line(system, line[0], s, name, &of)) continue;
            fprintf(out, "  at %s %.4gX of %s: %s x %.4g %s %s, y %.4g %s %s\n", name, line[0], of.part,
                    result->stations[s].name, size * line[1], unit.name, units->amplitude_name, size * line[2],
                    unit.name, units->amplitude_name);
            shown++;
        }
    }
}

/// Writes the named lines of a point (print_named) with the machine at that point.
static void print_named_of(FILE *out, const whirl_shown_units *units, const whirl_case *machine,
                           const whirl_table *table, size_t point) {
    whirl_machine own;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_LINES)) return;
    if (!machine_at(machine, table, point, &own)) return;
    print_named(out, units, table, point, own.system);
    own.release(own.owner);
}

/// Writes "lines of its spectrum hold 61 % of the motion of disc" for stations with a share below FEW_LINES.
static void print_shares(FILE *out, const whirl_result *result, const whirl_table *table, size_t point) {
    for (size_t s = 0; s < result->station_count; s++) {
        const double share = line_share(table, point, s);
        if (share < FEW_LINES)
            fprintf(out, "  lines of its spectrum hold %.3g %% of the motion of %s\n", 100.0 * share,
                    result->stations[s].name);
    }
}

/// Writes "confidence: fair (one tolerance only); to settle it, let it run 2 times as long".
static void print_confidence(FILE *out, const whirl_verdict *verdict) {
    char other[VERDICT_SIZE], advice[WHIRL_MESSAGE_SIZE];
    // At the second tolerance only the regime is stored; a motion at rest is at rest at both.
    const whirl_verdict second = {
        .regime = verdict->other_regime, .period = verdict->other_period, .rests = verdict->rests};
    regime_name(&second, other, sizeof other);
    whirl_verdict_advice(verdict, advice, sizeof advice);
    fprintf(out, "  confidence: %s (", whirl_confidence_name(verdict->confidence));
    fprintf(out, verdict->confirmed ? "at the second tolerance: %s)" : "one tolerance only)", other);
    if (verdict->confidence == WHIRL_LOW && *advice) fprintf(out, "; to settle it, %s", advice);
    fputc('\n', out);
}

static void print_verdict(FILE *out, const char *table, const whirl_verdict *verdict) {
    char text[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(verdict, text, sizeof text);
    fprintf(out, "%s: %s\n", table, text);
    whirl_verdict_reason(verdict, text, sizeof text);
    if (text[0]) fprintf(out, "  %s\n", text);
    print_confidence(out, verdict);
}

/// Writes "exponents failed: their sum is -4.186, the equations give -1.257; take a smaller tolerance or more steps".
static void print_failed_exponents(FILE *out, const whirl_table *table, size_t point) {
    if (!(whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_FAILED, 0) > 0.5)) return;
    fprintf(out,
            "  exponents failed: their sum is %.4g, the equations give %.4g; take a smaller tolerance or more steps\n",
            whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_SUM, 0),
            whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_SUM_EXACT, 0));
}

static void print_point(FILE *out, const whirl_shown_units *units, const whirl_case *machine, const whirl_table *table,
                        size_t point) {
    if (!whirl_table_done(table, point)) {
        fprintf(out, "%s: not computed\n", table->name);
        return;
    }
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    if (whirl_layout_has_verdict(&table->layout))
        print_verdict(out, table->name, &verdict);
    else
        fprintf(out, "%s: no verdict, as the analyses have no regime\n", table->name);
    if (verdict.regime == WHIRL_DIVERGING || motion_lost(table, point)) return;
    print_failed_exponents(out, table, point);
    print_rubs(out, units, table, point);
    print_radii(out, units, table, point);
    print_synchronous(out, units, table, point);
    print_named_of(out, units, machine, table, point);
    print_shares(out, units->result, table, point);
}

whirl_status summarize_response(FILE *out, const whirl_shown_units *units, const whirl_case *machine,
                                const whirl_table *table) {
    const size_t count = table->attractors ? table->count : 1;
    for (size_t point = 0; point < count; point++) {
        print_point(out, units, machine, table, point);
        summarize_share(out, table, point, "  ");
        if (table->attractors) fputc('\n', out);
    }
    return summarize_starts(out, units, table);
}
