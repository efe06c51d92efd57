// Writes the summary of several motions: each one if they are few, else windows of one regime, or counts of verdicts.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "regimes.h"
#include "summary.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/status.h"

enum { LONGEST_LIST = 12 };

static bool rubs(const whirl_result *result, const whirl_table *table, size_t point) {
    for (size_t i = 0; i < result->contact_count; i++)
        if (whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, i) > 0) return true;
    return false;
}

static void print_list(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_result *result = units->result;
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        char name[VERDICT_SIZE] = "";
        const bool judged = verdict.regime != WHIRL_NOT_JUDGED;
        if (judged) whirl_verdict_name(&verdict, name, sizeof name);
        fprintf(out, "  %10.6g %s%s%-26s", table->values[point] / unit.size, unit.name, *unit.name ? "  " : " ", name);
        fprintf(out, " %-5s", judged ? whirl_confidence_name(verdict.confidence) : "");
        if (isfinite(verdict.exponent.value))
            fprintf(out, " exponent %8.4f +- %-7.1g", verdict.exponent.value,
                    fmax(verdict.exponent.error, 1e-4)); // an error of at least the last digit shown
        else if (verdict.exponents_failed)
            fprintf(out, " %-28s", "exponents failed");
        fputs(rubs(result, table, point) ? "  rub" : "", out);
        summarize_share(out, table, point, "  ");
        fputc('\n', out);
    }
}

void summary_range(const whirl_unit *unit, const whirl_table *table, size_t first, size_t last, char *text,
                   size_t size) {
    const double from = table->values[first] / unit->size, to = table->values[last] / unit->size;
    const char *gap = *unit->name ? " " : "";
    if (last > first)
        snprintf(text, size, "%.6g to %.6g%s%s", from, to, gap, unit->name);
    else
        snprintf(text, size, "%.6g%s%s", from, gap, unit->name);
}

/// Writes "2000 to 6000 rpm  P-1", one line for each window of one regime, in the order of the sweep. Returns false,
/// and writes nothing, if there are too many windows.
static bool print_windows(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    regime_interval windows[LONGEST_LIST];
    const size_t count = regime_intervals(table, units->result->contact_count, windows, LONGEST_LIST);
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    for (size_t i = 0; i < count && count <= LONGEST_LIST; i++) {
        const regime_interval *const one = &windows[i];
        char range[VERDICT_SIZE];
        summary_range(&unit, table, one->first, one->last, range, sizeof range);
        fprintf(out, "  %-24s %s%s", range, one->name, one->branch < 0 ? ", from the last value on" : "");
        if (table->attractors) fprintf(out, ", attractor %zu", table->attractors[one->first].number);
        fputc('\n', out);
    }
    return count <= LONGEST_LIST;
}

/// Finds the number of grid cells that each point of a refined map covers [count]; NULL for other tables. Returns false
/// without memory.
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

/// Writes "refined from squares of 16: 5210 of 66049 points computed (7.9 %), 612 revolutions each; all would have
/// taken about 4.04e+07 revolutions".
static void print_grid(FILE *out, const whirl_table *table) {
    size_t done = 0;
    if (table->refine == 0) return;
    for (size_t point = 0; point < table->count; point++) done += whirl_table_done(table, point);
    const double each = whirl_table_revolutions(table), grid = (double)table->grid;
    fprintf(
        out,
        "  refined from squares of %zu: %zu of %zu points computed (%.1f %%), %.0f revolutions each; all would have "
        "taken about %.3g revolutions\n",
        table->refine, done, table->grid, 100.0 * (double)done / grid, each, whirl_table_grid_revolutions(table));
}

size_t summary_counts(const whirl_table *table, verdict_count counts[SUMMARY_VERDICTS]) {
    size_t found = 0, *weights = NULL;
    const bool weighed = whirl_layout_has_verdict(&table->layout) && weights_of(table, &weights);
    for (size_t point = 0; weighed && point < table->count; point++) {
        char name[VERDICT_SIZE];
        size_t i = 0;
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        regime_name(&verdict, name, sizeof name);
        while (i < found && strcmp(counts[i].name, name) != 0) i++;
        if (i == SUMMARY_VERDICTS) continue;
        if (i == found) {
            counts[found] = (verdict_count){.points = 0};
            memcpy(counts[found++].name, name, sizeof name);
        }
        counts[i].points += weight_of(weights, point);
    }
    free(weights);
    return found;
}

summary_tally summary_tally_of(const whirl_shown_units *units, const whirl_table *table) {
    summary_tally tally = {.rubbing = 0};
    size_t *weights;
    const bool weighed = weights_of(table, &weights);
    for (size_t point = 0; weighed && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const size_t weight = weight_of(weights, point);
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        tally.all += weight;
        tally.rubbing += rubs(units->result, table, point) ? weight : 0;
        tally.failed += verdict.exponents_failed ? weight : 0;
        tally.sure[verdict.confidence] += weight;
    }
    free(weights);
    return tally;
}

static void print_tally(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const summary_tally tally = summary_tally_of(units, table);
    if (units->result->contact_count > 0) fprintf(out, "  %6zu  with rub\n", tally.rubbing);
    if (tally.failed > 0)
        fprintf(out, "  %6zu  with failed exponents: take a smaller tolerance, or more steps\n", tally.failed);
    if (whirl_layout_has_verdict(&table->layout))
        fprintf(out, "  confidence: %zu high, %zu fair, %zu low\n", tally.sure[WHIRL_HIGH], tally.sure[WHIRL_FAIR],
                tally.sure[WHIRL_LOW]);
}

/// Writes windows in the order of the sweep if they are few, else the number of points of each verdict; for a refined
/// map the points of its grid, with those that were not computed.
static void print_counts(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    verdict_count counts[SUMMARY_VERDICTS];
    const bool listed =
        !whirl_layout_has_verdict(&table->layout) || (table->row == 0 && print_windows(out, units, table));
    const size_t found = listed ? 0 : summary_counts(table, counts);
    for (size_t i = 0; i < found; i++) fprintf(out, "  %6zu  %s\n", counts[i].points, counts[i].name);
    print_tally(out, units, table);
}

static bool is_basin(const whirl_table *table) {
    return table->role == WHIRL_ROLE_BASIN;
}

/// Writes "attractor 1: P-1 from 1931 starts, 64.3 % +- 0.9 %", one line for each attractor.
static whirl_status print_attractors(FILE *out, const whirl_table *table) {
    // Find the attractors, which only a basin has here.
    enum { SHOWN = 16 };
    whirl_attractor found[SHOWN];
    size_t count = 0;
    const whirl_status status =
        is_basin(table) ? whirl_table_attractors(table, NULL, found, SHOWN, &count) : whirl_ok();
    if (!is_basin(table) || status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    // Print the largest.
    for (size_t k = 0; k < count && k < SHOWN; k++) {
        const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
        char name[VERDICT_SIZE];
        regime_name(&verdict, name, sizeof name);
        fprintf(out, "  attractor %zu: %s from %zu start%s, %.1f %% +- %.1f %%\n", k + 1, name, found[k].points,
                summary_plural((double)found[k].points), 100.0 * found[k].share, 100.0 * found[k].error);
    }
    if (count > SHOWN) fprintf(out, "  and %zu more\n", count - SHOWN);
    // Print the share of starts without a verdict.
    size_t done = 0, known = 0, *weights;
    const bool weighed = weights_of(table, &weights);
    for (size_t i = 0; weighed && i < table->count; i++) done += whirl_table_done(table, i) ? weight_of(weights, i) : 0;
    free(weights);
    for (size_t k = 0; k < count && k < SHOWN; k++) known += found[k].points;
    if (count <= SHOWN && known < done)
        fprintf(out, "  without a verdict: %zu start%s, %.1f %%: a longer transient may tell\n", done - known,
                summary_plural((double)(done - known)), 100.0 * (double)(done - known) / (double)done);
    return weighed ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the shares of attractors");
}

/// Writes "refined: 5 points, 2 still in doubt".
void summarize_refinement(FILE *out, const whirl_table *table) {
    size_t refined = 0, doubtful = 0;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_REFINE_ROUNDS)) return;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        refined += whirl_table_number(table, point, WHIRL_FIELD_REFINE_ROUNDS, 0) > 0;
        doubtful += whirl_table_verdict(table, point).confidence == WHIRL_LOW;
    }
    fprintf(out, "  refined: %zu point%s, %zu still in doubt\n", refined, summary_plural((double)refined), doubtful);
}

/// Writes "4 jumps within a regime, first between 0.188 and 0.186: two motions side by side, or one that changes
/// suddenly".
static void print_jumps(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    whirl_jump first;
    size_t count;
    if (whirl_table_jumps(table, &first, 1, &count).code != WHIRL_OK || count == 0) return;
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    fprintf(out,
            "  %zu jump%s within a regime%s between %.5g and %.5g%s%s: two motions side by side, or one that changes "
            "suddenly\n",
            count, summary_plural((double)count), count > 1 ? ", first" : "", table->values[first.from] / unit.size,
            table->values[first.to] / unit.size, *unit.name ? " " : "", unit.name);
}

whirl_status summarize_notes(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    if (whirl_table_planned(table) > 1) summarize_doubts(out, units, table);
    whirl_status status = print_attractors(out, table);
    if (status.code == WHIRL_OK) status = summarize_starts(out, units, table);
    summarize_refinement(out, table->source ? table->source : table);
    print_jumps(out, units, table);
    return status;
}

whirl_status summarize_points(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    print_grid(out, table);
    if (whirl_table_planned(table) <= LONGEST_LIST && table->row == 0)
        print_list(out, units, table);
    else
        print_counts(out, units, table);
    return summarize_notes(out, units, table);
}
