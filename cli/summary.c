#include "summary.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "phases.h"
#include "summary_doubts.h"
#include "summary_starts.h"
#include "summary_tori.h"
#include "whirl/shown.h"

enum { LONGEST_LIST = 12, MAX_VERDICTS = WHIRL_MAX_PERIOD + 8, VERDICT_SIZE = 96 };

static const char *plural(double count) {
    return count == 1 ? "" : "s";
}

static bool rubs(const whirl_result *result, const whirl_table *table, size_t point) {
    for (size_t i = 0; i < result->contact_count; i++)
        if (whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, i) > 0) return true;
    return false;
}

/// The verdict without what is different from point to point: all divergences are one, and all quasi-periodic motions.
static void short_name(const whirl_verdict *verdict, char *name, size_t size) {
    if (verdict->regime == WHIRL_PERIODIC)
        whirl_verdict_name(verdict, name, size);
    else
        snprintf(name, size, "%s", whirl_regime_name(verdict->regime));
}

// ---------------------------------------------------------------- one point

static void print_rubs(const whirl_result *result, const whirl_table *table, size_t point) {
    for (size_t i = 0; i < result->contact_count; i++) {
        const double share = whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, i);
        if (share > 0)
            printf("  %s: %.3g %% of the time\n", result->contacts[i], 100 * share);
        else if (share >= 0)
            printf("  %s: no contact\n", result->contacts[i]);
    }
}

/// The unit of lengths: the one that the case asks for, else the one that it writes them in.
static whirl_unit length_unit(const whirl_shown_units *units) {
    return units->size.size > 0.0 ? units->size : whirl_result_length_unit(units->result);
}

static whirl_shown_units shown_units(const whirl_result *result) {
    whirl_shown_units units;
    whirl_result_shown_units(result, NULL, &units); // what a file says that is no unit chooses nothing
    return units;
}

/// "largest radius: disc 1.154, journal 0.957 (in 0.2 mm)", or "disc 231, journal 191 µm" where the case asks for a
/// unit.
static void print_radii(const whirl_result *result, const whirl_table *table, size_t point) {
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_ORBIT_MAX_RADIUS)) return;
    const whirl_shown_units units = shown_units(result);
    const whirl_unit unit = length_unit(&units);
    const double scale = whirl_result_length_scale(result, table, point),
                 size = units.size.size > 0.0 ? scale / unit.size : 1.0;
    fputs("  largest radius:", stdout);
    for (size_t i = 0; i < result->station_count; i++)
        printf("%s %s %.4g", i ? "," : "", result->stations[i].name,
               size * whirl_table_number(table, point, WHIRL_FIELD_ORBIT_MAX_RADIUS, i));
    if (size != 1.0 || scale == unit.size)
        printf(" %s\n", unit.name);
    else
        printf(" (in %.6g %s)\n", scale / unit.size, unit.name);
}

/// "at 1X: disc x 0.0225 mm 0-p lag 86.6 deg, y 0.0193 mm 0-p lag 128 deg", a line a station; phases as
/// whirl_synchronous has them.
static void print_synchronous(const whirl_result *result, const whirl_table *table, size_t point) {
    const whirl_shown_units units = shown_units(result);
    const whirl_unit unit = length_unit(&units);
    const double size = units.amplitude * whirl_result_length_scale(result, table, point) / unit.size;
    const char *way = units.amplitude_name;
    for (size_t i = 0; i < result->station_count; i++) {
        const double *amplitude = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, i);
        const double *lag = whirl_table_field(table, point, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, i);
        if (!amplitude || !lag || !isfinite(lag[0]) || !isfinite(lag[1])) continue;
        printf("  at 1X: %s x %.4g %s %s lag %.1f deg, y %.4g %s %s lag %.1f deg\n", result->stations[i].name,
               size * amplitude[0], unit.name, way, lag[0], size * amplitude[1], unit.name, way, lag[1]);
    }
}

/// "confidence: fair (one tolerance only); to settle it, let it run 2 times as long".
static void print_confidence(const whirl_verdict *verdict) {
    char other[VERDICT_SIZE], advice[WHIRL_MESSAGE_SIZE];
    // A motion rests where it does at both tolerances.
    const whirl_verdict second = {
        .regime = verdict->other_regime, .period = verdict->other_period, .rests = verdict->rests};
    short_name(&second, other, sizeof other);
    whirl_verdict_advice(verdict, advice, sizeof advice);
    printf("  confidence: %s (", whirl_confidence_name(verdict->confidence));
    printf(verdict->confirmed ? "at the second tolerance: %s)" : "one tolerance only)", other);
    if (verdict->confidence == WHIRL_LOW && *advice) printf("; to settle it, %s", advice);
    putchar('\n');
}

static void print_verdict(const char *table, const whirl_verdict *verdict) {
    char text[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(verdict, text, sizeof text);
    printf("%s: %s\n", table, text);
    whirl_verdict_reason(verdict, text, sizeof text);
    if (text[0]) printf("  %s\n", text);
    print_confidence(verdict);
}

/// "exponents failed: their sum is -4.186, the equations give -1.257; take a smaller tolerance or more steps".
static void print_failed_exponents(const whirl_table *table, size_t point) {
    if (!(whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_FAILED, 0) > 0.5)) return;
    printf("  exponents failed: their sum is %.4g, the equations give %.4g; take a smaller tolerance or more steps\n",
           whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_SUM, 0),
           whirl_table_number(table, point, WHIRL_FIELD_EXPONENTS_SUM_EXACT, 0));
}

static void print_point(const whirl_result *result, const whirl_table *table, size_t point) {
    if (!whirl_table_done(table, point)) {
        printf("%s: not computed\n", table->name);
        return;
    }
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    if (whirl_layout_has_verdict(&table->layout))
        print_verdict(table->name, &verdict);
    else
        printf("%s: no verdict, as the analyses have no regime\n", table->name);
    if (verdict.regime == WHIRL_DIVERGING) return;
    print_failed_exponents(table, point);
    print_rubs(result, table, point);
    print_radii(result, table, point);
    print_synchronous(result, table, point);
}

/// The one point of a response, or every attractor that its starts lead to.
static void print_response(const whirl_result *result, const whirl_table *table) {
    const size_t count = table->attractors ? table->count : 1;
    for (size_t point = 0; point < count; point++) {
        print_point(result, table, point);
        summarize_share(table, point, "  ");
        if (table->attractors) putchar('\n');
    }
    summarize_starts(result, table);
}

// ---------------------------------------------------------------- machines at rest

static bool has_modes(const whirl_table *table) {
    return whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY) != NULL;
}

static bool is_at_rest(const whirl_table *table) {
    const whirl_kind *kind = whirl_analysis_kind(table->analyses);
    return !kind->moves && !kind->found;
}

/// Lowest modes of a point, a line each: "  254.1 rad/s  (40.44 Hz, 2426 rpm)  damping ratio 0.0213  forward".
static void print_modes(const whirl_table *table, size_t point) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    const double *ratio = whirl_table_field(table, point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
    const double *direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0);
    const double rigid = whirl_table_number(table, point, WHIRL_FIELD_MODES_RIGID_BODY, 0);
    if (rigid > 0) printf("  %10d rad/s: %g rigid-body mode%s, which nothing holds\n", 0, rigid, plural(rigid));
    for (size_t i = 0; field && frequency && i < field->rows && isfinite(frequency[i]); i++) {
        const char *const whirls = direction[i] > 0.05 ? " forward" : direction[i] < -0.05 ? " backward" : "";
        printf("  %10.6g rad/s (%.6g Hz)  damping ratio %-*.4g%s\n", frequency[i], frequency[i] / 6.283185307179586,
               *whirls ? 10 : 0, ratio[i], whirls);
    }
    const double stability = whirl_table_number(table, point, WHIRL_FIELD_MODES_STABILITY, 0);
    const double modulo = whirl_table_number(table, point, WHIRL_FIELD_MODES_MODULO, 0);
    if (isfinite(modulo))
        printf("  frequencies are known but for multiples of %.6g rad/s: coefficients turn with the shaft\n", modulo);
    if (isfinite(stability))
        printf("  %s: the largest real part of all%s eigenvalues is %.4g 1/s\n", stability > 0 ? "unstable" : "stable",
               rigid > 0 ? " other" : "", stability);
}

/// What was located along the parameter: "  critical speed at 2753.2 rpm: forward, damping ratio 0.02".
static void print_critical(const whirl_result *result, const whirl_table *table) {
    static const char *const names[] = {"", "critical speed", "instability begins", "instability ends"};
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    for (size_t point = 0; point < table->count; point++) {
        const double *rows = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        if (!whirl_table_done(table, point) || !rows) continue;
        for (size_t i = 0; i < field->rows; i++, rows += field->columns) {
            if (!(rows[0] >= 1 && rows[0] <= 3)) continue;
            printf("  %-18s at %.9g%s%s: %s, %.6g rad/s, damping ratio %.3g\n", names[(int)rows[0]],
                   rows[1] / unit.size, *unit.name ? " " : "", unit.name,
                   rows[5] > 0.05    ? "forward"
                   : rows[5] < -0.05 ? "backward"
                                     : "to and fro",
                   rows[3], rows[4]);
        }
    }
}

/// The largest response of every station, and where.
static void print_peaks(const whirl_result *result, const whirl_table *table) {
    const whirl_shown_units units = shown_units(result);
    const whirl_unit unit = whirl_shown_parameter(&units, table->parameter), length = length_unit(&units);
    for (size_t station = 0; station < result->station_count; station++) {
        double largest = 0.0;
        size_t where = 0;
        for (size_t point = 0; point < table->count; point++) {
            const double *axes = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
            if (!whirl_table_done(table, point) || !axes || !(axes[0] > largest)) continue;
            largest = axes[0];
            where = point;
        }
        printf("  %s: largest response %.4g %s %s", result->stations[station].name,
               units.amplitude * largest * whirl_result_length_scale(result, table, where) / length.size, length.name,
               units.amplitude_name);
        if (table->parameter[0])
            printf(" at %.6g%s%s", table->values[where] / unit.size, *unit.name ? " " : "", unit.name);
        putchar('\n');
    }
}

/// Motions of a table with several starts that began where those of neighbours ended.
static size_t count_from_neighbours(const whirl_table *table) {
    size_t count = 0;
    for (size_t i = 0; i < table->source->count; i++) count += whirl_table_from_neighbour(table->source, i);
    return count;
}

/// " and rho: 32 x 16 points", ", rho and sigma: 32 x 16 x 3 points".
static void print_axes(const whirl_table *table) {
    const size_t planes = whirl_table_planes(table);
    const bool stacked = table->plane > 0;
    printf("%s%s%s%s: %zu x %zu", stacked ? ", " : " and ", table->second, stacked ? " and " : "", table->third,
           table->row, whirl_table_rows(table));
    if (stacked) printf(" x %zu", planes);
    fputs(" points", stdout);
}

/// "sweep of r_k: 512 points", "map of r_k and rho: 32 x 16 points".
static void print_heading(const whirl_table *table) {
    const size_t planned = whirl_table_planned(table);
    printf("%s of %s", table->name, table->parameter);
    if (table->row > 0)
        print_axes(table);
    else
        printf(": %zu point%s", planned, plural((double)planned));
    if (table->source) printf(", %zu starts each", table->source->starts);
    if (table->source && table->source->neighbours > 0)
        printf(" and %zu from neighbours", count_from_neighbours(table));
    putchar('\n');
}

/// The modes at the first and the last value that are done.
static void print_modes_at_ends(const whirl_result *result, const whirl_table *table) {
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    size_t first = 0, last = table->count;
    while (first < table->count && !whirl_table_done(table, first)) first++;
    while (last > first && !whirl_table_done(table, last - 1)) last--;
    for (size_t point = first; point < last; point += point + 1 < last ? last - 1 - point : 1) {
        printf(" modes at %.6g%s%s:\n", table->values[point] / unit.size, *unit.name ? " " : "", unit.name);
        print_modes(table, point);
    }
}

static void print_at_rest(const whirl_result *result, const whirl_table *table) {
    const size_t planned = whirl_table_planned(table);
    if (table->parameter[0])
        print_heading(table);
    else
        printf("%s:\n", table->name);
    if (!has_modes(table))
        print_peaks(result, table);
    else if (planned > 1) {
        print_critical(result, table);
        print_modes_at_ends(result, table);
    } else if (whirl_table_done(table, 0))
        print_modes(table, 0);
}

// ---------------------------------------------------------------- branches

/// "  branch 3: P-2, 76 points from 0.3374, where branch 2 changes".
static void print_branch(const whirl_unit *unit, const whirl_trace *first, size_t count) {
    char name[VERDICT_SIZE];
    whirl_orbit_name(first->point.orbit, name, sizeof name);
    printf("  branch %zu: %s, %zu point%s from %.6g%s%s", first->branch, name, count, plural((double)count),
           first->point.value / unit->size, *unit->name ? " " : "", unit->name);
    if (first->parent > 0) printf(", where branch %zu changes", first->parent);
    putchar('\n');
}

static void print_special(const whirl_unit *unit, const whirl_trace *at) {
    char text[WHIRL_MESSAGE_SIZE];
    whirl_special_text(&at->point, text, sizeof text);
    printf("    %14.9g%s%s  %-15s %s\n", at->point.value / unit->size, *unit->name ? " " : "", unit->name,
           whirl_special_name(at->point.special), text);
}

static size_t points_of(const whirl_table *table, size_t first) {
    const double branch = whirl_table_number(table, first, WHIRL_FIELD_TRACE_NUMBER, 0);
    size_t count = 0;
    while (first + count < table->count &&
           whirl_table_number(table, first + count, WHIRL_FIELD_TRACE_NUMBER, 0) == branch)
        count++;
    return count;
}

/// What was found along every branch, and where and why it ends.
static void print_branches(const whirl_result *result, const whirl_table *table) {
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        whirl_trace at;
        const bool begins = point == 0 || whirl_table_number(table, point, WHIRL_FIELD_TRACE_NUMBER, 0) !=
                                              whirl_table_number(table, point - 1, WHIRL_FIELD_TRACE_NUMBER, 0);
        if (whirl_table_trace(table, point, &at).code != WHIRL_OK) continue;
        if (begins) print_branch(&unit, &at, points_of(table, point));
        if (at.point.special != WHIRL_REGULAR && isnan(at.point.second)) print_special(&unit, &at);
        if (!isnan(at.end))
            printf("    %14.9g%s%s  %s\n", at.point.value / unit.size, *unit.name ? " " : "", unit.name,
                   whirl_branch_end_text((whirl_branch_end)at.end));
        whirl_orbit_free(at.point.orbit);
    }
}

// ---------------------------------------------------------------- many points

static void print_list(const whirl_result *result, const whirl_table *table) {
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        char name[VERDICT_SIZE] = "";
        if (whirl_layout_has_verdict(&table->layout)) whirl_verdict_name(&verdict, name, sizeof name);
        printf("  %10.6g %s%s%-26s", table->values[point] / unit.size, unit.name, *unit.name ? "  " : " ", name);
        printf(" %-5s", whirl_layout_has_verdict(&table->layout) ? whirl_confidence_name(verdict.confidence) : "");
        if (isfinite(verdict.exponent.value))
            printf(" exponent %8.4f +- %-7.1g", verdict.exponent.value,
                   fmax(verdict.exponent.error, 1e-4)); // not below what the digits show
        else if (verdict.exponents_failed)
            printf(" %-28s", "exponents failed");
        fputs(rubs(result, table, point) ? "  rub" : "", stdout);
        summarize_share(table, point, "  ");
        putchar('\n');
    }
}

typedef struct verdict_counts {
    size_t count, of[MAX_VERDICTS];
    char names[MAX_VERDICTS][VERDICT_SIZE];
} verdict_counts;

static void count_verdict(verdict_counts *tally, const whirl_verdict *verdict, size_t weight) {
    char name[VERDICT_SIZE];
    short_name(verdict, name, sizeof name);
    size_t i = 0;
    while (i < tally->count && strcmp(tally->names[i], name) != 0) i++;
    if (i == MAX_VERDICTS) return;
    if (i == tally->count) memcpy(tally->names[tally->count++], name, sizeof name);
    tally->of[i] += weight;
}

/// Neighbouring points of one verdict.
typedef struct window {
    size_t first, last;
    char name[VERDICT_SIZE];
} window;

/// The windows of a sweep in its order; as many as there are, of which `most` are written.
static size_t find_windows(const whirl_table *table, window *windows, size_t most) {
    size_t count = 0;
    window now = {.name = ""};
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        char name[VERDICT_SIZE];
        short_name(&verdict, name, sizeof name);
        const bool next_to = count > 0 && whirl_table_slot(table, point) == whirl_table_slot(table, now.last) + 1;
        if (!next_to || strcmp(name, now.name) != 0 || table->branch[point] != table->branch[now.last]) {
            count++;
            now.first = point;
            memcpy(now.name, name, sizeof name);
        }
        now.last = point;
        if (count <= most) windows[count - 1] = now;
    }
    return count;
}

/// "2000 to 6000 rpm  P-1", one line a window, in the order of the sweep. False, and nothing, where they are too many.
static bool print_windows(const whirl_result *result, const whirl_table *table) {
    window windows[LONGEST_LIST];
    const size_t count = find_windows(table, windows, LONGEST_LIST);
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    for (size_t i = 0; i < count && count <= LONGEST_LIST; i++) {
        const window *const one = &windows[i];
        const double a = table->values[one->first] / unit.size, b = table->values[one->last] / unit.size;
        char range[VERDICT_SIZE];
        int length = snprintf(range, sizeof range, "%.6g", a);
        if (one->last > one->first) length += snprintf(range + length, sizeof range - (size_t)length, " to %.6g", b);
        snprintf(range + length, sizeof range - (size_t)length, "%s%s", *unit.name ? " " : "", unit.name);
        printf("  %-24s %s%s", range, one->name, table->branch[one->first] < 0 ? ", from the last value on" : "");
        if (table->attractors) printf(", attractor %zu", table->attractors[one->first].number);
        putchar('\n');
    }
    return count <= LONGEST_LIST;
}

/// How many points of the grid of a refined map each of its points stands for [count]; NULL where points stand for
/// themselves. False without memory.
static bool weights_of(const whirl_table *table, size_t **weights) {
    const size_t grid = whirl_table_grid(table);
    *weights = NULL;
    if (table->refine == 0) return true;
    size_t *own = *weights = calloc(table->count + 1, sizeof *own), *cover = calloc(grid + 1, sizeof *cover);
    if (cover) whirl_table_cover(table, cover);
    for (size_t i = 0; own && cover && i < grid; i++) own[cover[i]] += cover[i] < table->count;
    const bool made = own && cover;
    free(cover);
    return made;
}

static size_t weight_of(const size_t *weights, size_t point) {
    return weights ? weights[point] : 1;
}

/// "refined from squares of 16: 5210 of 66049 points computed (7.9 %), 612 revolutions each; all would have taken about
/// 4.04e+07 revolutions".
static void print_grid(const whirl_table *table) {
    size_t done = 0;
    if (table->refine == 0) return;
    for (size_t point = 0; point < table->count; point++) done += whirl_table_done(table, point);
    const double each = whirl_table_revolutions(table), grid = (double)table->grid;
    printf("  refined from squares of %zu: %zu of %zu points computed (%.1f %%), %.0f revolutions each; all would have "
           "taken about %.3g revolutions\n",
           table->refine, done, table->grid, 100.0 * (double)done / grid, each, whirl_table_grid_revolutions(table));
}

/// Verdicts in the order in which the sweep meets them, with their ranges where these are few; in a refined map those
/// of its grid, told or computed.
static void print_counts(const whirl_result *result, const whirl_table *table) {
    verdict_counts tally = {.count = 0};
    size_t rubbing = 0, failed = 0, sure[WHIRL_HIGH + 1] = {0}, *weights;
    const bool weighed = weights_of(table, &weights);
    for (size_t point = 0; weighed && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const size_t weight = weight_of(weights, point);
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        if (whirl_layout_has_verdict(&table->layout)) count_verdict(&tally, &verdict, weight);
        rubbing += rubs(result, table, point) ? weight : 0;
        failed += verdict.exponents_failed ? weight : 0;
        sure[verdict.confidence] += weight;
    }
    free(weights);
    const bool listed = !whirl_layout_has_verdict(&table->layout) || (table->row == 0 && print_windows(result, table));
    for (size_t i = 0; i < tally.count && !listed; i++) printf("  %6zu  %s\n", tally.of[i], tally.names[i]);
    if (result->contact_count > 0) printf("  %6zu  with rub\n", rubbing);
    if (failed > 0) printf("  %6zu  with failed exponents: take a smaller tolerance, or more steps\n", failed);
    if (whirl_layout_has_verdict(&table->layout))
        printf("  confidence: %zu high, %zu fair, %zu low\n", sure[WHIRL_HIGH], sure[WHIRL_FAIR], sure[WHIRL_LOW]);
}

static bool is_basin(const whirl_table *table) {
    return strcmp(table->name, "basin") == 0;
}

/// "attractor 1: P-1 at 1931 starts, 64.3 % +- 0.9 %", one line an attractor.
static whirl_status print_attractors(const whirl_table *table) {
    enum { SHOWN = 16 };
    whirl_attractor found[SHOWN];
    size_t count = 0;
    const whirl_status status =
        is_basin(table) ? whirl_table_attractors(table, NULL, found, SHOWN, &count) : whirl_ok();
    if (!is_basin(table) || status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    for (size_t k = 0; k < count && k < SHOWN; k++) {
        const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
        char name[VERDICT_SIZE];
        short_name(&verdict, name, sizeof name);
        printf("  attractor %zu: %s from %zu start%s, %.1f %% +- %.1f %%\n", k + 1, name, found[k].points,
               plural((double)found[k].points), 100.0 * found[k].share, 100.0 * found[k].error);
    }
    if (count > SHOWN) printf("  and %zu more\n", count - SHOWN);
    size_t done = 0, told = 0, *weights;
    const bool weighed = weights_of(table, &weights);
    for (size_t i = 0; weighed && i < table->count; i++) done += whirl_table_done(table, i) ? weight_of(weights, i) : 0;
    free(weights);
    for (size_t k = 0; k < count && k < SHOWN; k++) told += found[k].points;
    if (count <= SHOWN && told < done)
        printf("  without a verdict: %zu start%s, %.1f %%: a longer transient may tell\n", done - told,
               plural((double)(done - told)), 100.0 * (double)(done - told) / (double)done);
    return weighed ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the shares of attractors");
}

/// "refined: 5 points, 2 still in doubt".
static void print_refinement(const whirl_table *table) {
    size_t refined = 0, doubtful = 0;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_REFINE_ROUNDS)) return;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        refined += whirl_table_number(table, point, WHIRL_FIELD_REFINE_ROUNDS, 0) > 0;
        doubtful += whirl_table_verdict(table, point).confidence == WHIRL_LOW;
    }
    printf("  refined: %zu point%s, %zu still in doubt\n", refined, plural((double)refined), doubtful);
}

/// "4 jumps within a regime, first between 0.188 and 0.186: two motions side by side, or one that changes suddenly".
static void print_jumps(const whirl_result *result, const whirl_table *table) {
    whirl_jump first;
    size_t count;
    if (whirl_table_jumps(table, &first, 1, &count).code != WHIRL_OK || count == 0) return;
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    printf("  %zu jump%s within a regime%s between %.5g and %.5g%s%s: two motions side by side, or one that changes "
           "suddenly\n",
           count, plural((double)count), count > 1 ? ", first" : "", table->values[first.from] / unit.size,
           table->values[first.to] / unit.size, *unit.name ? " " : "", unit.name);
}

void summarize_end(const whirl_result *result, const char *parameter, double first) {
    const char *const said = whirl_result_fact(result, "sweep ends at"), *const missed = strstr(said, "short of ");
    if (!missed) return;
    const whirl_unit unit = whirl_result_unit(result, parameter);
    const char *const gap = *unit.name ? " " : "";
    const double last = strtod(said, NULL), end = strtod(missed + strlen("short of "), NULL);
    if (last == first)
        printf("  the step is larger than the range: %.6g%s%s is the only value\n", last / unit.size, gap, unit.name);
    else
        printf("  the steps end at %.6g%s%s, short of %.6g%s%s\n", last / unit.size, gap, unit.name, end / unit.size,
               gap, unit.name);
}

static whirl_status print_tables(const whirl_result *result) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < result->table_count && status.code == WHIRL_OK; i++) {
        const whirl_table *const table = &result->tables[i];
        if (table->integrate.chosen) printf("method auto took %s for the %s\n", table->integrate.method, table->name);
        const size_t planned = whirl_table_planned(table);
        if (is_at_rest(table)) {
            print_at_rest(result, table);
            continue;
        }
        if (table->parameter[0] == '\0' && planned == 1) {
            print_response(result, table);
            print_refinement(table->source ? table->source : table);
            continue;
        }
        print_heading(table);
        print_grid(table);
        if (strcmp(table->name, "sweep") == 0 && table->count > 0)
            summarize_end(result, table->parameter, table->values[0]);
        if (whirl_analysis_has(table->analyses, "torus"))
            summarize_tori(result, table);
        else if (whirl_analysis_kind(table->analyses)->found)
            print_branches(result, table);
        else if (planned <= LONGEST_LIST && table->row == 0)
            print_list(result, table);
        else
            print_counts(result, table);
        if (planned > 1) summarize_doubts(result, table);
        status = print_attractors(table);
        if (status.code == WHIRL_OK) status = summarize_starts(result, table);
        print_refinement(table->source ? table->source : table);
        print_jumps(result, table);
    }
    return status;
}

whirl_status summarize_result(const whirl_result *result) {
    size_t done, total;
    whirl_result *view;
    puts(result->title[0] ? result->title : result->case_name);
    for (size_t i = 0; *whirl_result_warning(result, i); i++) printf("warning: %s\n", whirl_result_warning(result, i));
    const char *const keyphasor = whirl_result_keyphasor(result);
    if (*keyphasor) tell_keyphasor(keyphasor, whirl_result_clock(result));
    if (whirl_result_partial(result, &done, &total)) {
        if (done == 0)
            printf("partial: stopped before the first of %zu point%s\n", total, plural((double)total));
        else if (done < total)
            printf("partial: stopped after %zu of %zu point%s\n", done, total, plural((double)total));
        else
            puts("partial: stopped when all points were done, before all were confirmed or refined");
    }
    whirl_status status = whirl_result_by_attractor(result, &view);
    if (status.code != WHIRL_OK) return status;
    status = print_tables(view);
    whirl_result_view_free(view);
    return status;
}

/// What a batch along branches may find.
static void print_room(const whirl_batch *batch) {
    const double points = (double)batch->count;
    printf("%s%s: at most %d points, from ", *batch->second ? " and " : "", batch->second, batch->record.trace.points);
    if (whirl_analysis_has(batch->analyses, "torus"))
        puts("the Neimark-Sacker points of the branches on");
    else
        printf("%.0f value%s on\n", points, plural(points));
}

/// ": 25 points from 48 starts each, and from neighbours in up to 20 rounds, 8100 revolutions a start".
static void print_starts(const whirl_batch *batch, double revolutions) {
    printf(": %zu point%s from %zu starts each, ", batch->count, plural((double)batch->count), batch->starts);
    if (batch->neighbours > 0)
        printf("and from neighbours in up to %zu round%s, ", batch->neighbours, plural((double)batch->neighbours));
    printf("%.0f revolution%s a start", revolutions, plural(revolutions));
}

void summarize_study(const whirl_study *study) {
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *const batch = &study->batches[i];
        const char *const name = batch->integrate.method;
        const whirl_method *method = NULL;
        const int steps = batch->integrate.steps_per_revolution;
        const size_t copies = batch->starts > 1 ? batch->starts : batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
        const double points = (double)batch->count * (double)copies;
        const double revolutions = (double)batch->record.transient + batch->record.record;
        printf("  %s", batch->name);
        if (batch->parameter[0]) printf(" of %s", batch->parameter);
        if (batch->row > 0) printf("%s%s", batch->plane > 0 ? ", " : " and ", batch->second);
        if (batch->plane > 0) printf(" and %s", batch->third);
        if (batch->refine > 0) printf(", refined from squares of %zu", batch->refine);
        if (!whirl_analysis_kind(batch->analyses)->settles) {
            printf(": %.0f point%s about where the machine rests\n", points, plural(points));
            continue;
        }
        if (whirl_analysis_kind(batch->analyses)->found) {
            print_room(batch);
            continue;
        }
        if (batch->starts > 1)
            print_starts(batch, revolutions);
        else
            printf(": %s%.0f point%s, %.0f revolution%s each", batch->refine > 0 ? "at most " : "", points,
                   plural(points), revolutions, plural(revolutions));
        if (whirl_method_find(name, &method).code == WHIRL_OK && method->adaptive) {
            printf(" by %s%s%s\n", name, batch->integrate.chosen ? " (chosen by auto)" : "",
                   batch->confirm ? ", confirmed at a tolerance 16 times smaller" : "");
            continue;
        }
        const double all = points * revolutions * steps * (batch->confirm ? 3 : 1);
        printf(" by %s of %d step%s", name, steps, plural(steps));
        if (batch->confirm) printf(", confirmed with %d", 2 * steps);
        printf(", %.3g step%s in all\n", all, plural(all));
    }
}
