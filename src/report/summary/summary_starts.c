// Writes the attractors to which the starts of every point lead.
#include "summary.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { MAX_RANGES = 6, MAX_ATTRACTORS = 12 };

void summarize_share(FILE *out, const whirl_table *table, size_t point, const char *before) {
    if (!table->attractors) return;
    const whirl_coexisting *one = &table->attractors[point];
    if (one->starts == 0) {
        fprintf(out, "%sattractor %zu, found from a neighbour: 0 of %zu starts", before, one->number, one->of);
        return;
    }
    fprintf(out, "%sattractor %zu, %.3g %% +- %.2g %% of the starts", before, one->number, 100.0 * one->share,
            100.0 * one->error);
}

/// Writes "attractor 2: at 5 points, 0 % to 12.5 % of the starts; at 2 found from neighbours alone". Rows of one
/// attractor are consecutive.
static void print_attractors(FILE *out, const whirl_table *table) {
    size_t shown = 0;
    for (size_t i = 0; i < table->count;) {
        const whirl_coexisting *one = &table->attractors[i];
        double low = 1.0, high = 0.0;
        size_t points = 0, met = 0;
        for (; i < table->count && table->attractors[i].number == one->number; i++, points++) {
            low = fmin(low, table->attractors[i].share);
            high = fmax(high, table->attractors[i].share);
            met += table->attractors[i].starts > 0;
        }
        if (shown++ >= MAX_ATTRACTORS) continue;
        fprintf(out, "  attractor %zu: at %zu point%s, %.3g %%", one->number, points, summary_plural((double)points),
                100.0 * low);
        if (high > low) fprintf(out, " to %.3g %%", 100.0 * high);
        fputs(" of the starts", out);
        if (met < points) fprintf(out, "; at %zu found from neighbours alone", points - met);
        fputc('\n', out);
    }
    if (shown > MAX_ATTRACTORS) fprintf(out, "  and %zu more\n", shown - MAX_ATTRACTORS);
}

/// Returns the number of attractors at every point [places], which the caller frees; NULL without memory.
static size_t *count_beside(const whirl_table *table, size_t places) {
    size_t *beside = calloc(places + 1, sizeof *beside);
    for (size_t i = 0; beside && i < table->count; i++)
        beside[table->attractors[i].place] = table->attractors[i].beside;
    return beside;
}

static void print_range(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t first,
                        size_t last) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    const double *values = table->source->values; // parameter value of each start
    double ends[2] = {NAN, NAN};
    for (size_t i = 0; i < table->source->count; i++) {
        const size_t place = whirl_table_place(table->source, i);
        if (place == first) ends[0] = values[i] / unit.size;
        if (place == last) ends[1] = values[i] / unit.size;
    }
    fprintf(out, first == last ? " %.6g" : " %.6g to %.6g", ends[0], ends[1]);
    fprintf(out, "%s%s", *unit.name ? " " : "", unit.name);
}

/// Writes "several attractors side by side at 7 of 41 points: 0.29 to 0.31, 0.498"; for a map without the ranges.
static whirl_status print_coexisting(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    // Count the points with several attractors; a single point has another summary (summarize_response).
    const size_t places = whirl_table_planned(table);
    size_t several = 0, ranges = 0, *beside = count_beside(table, places);
    if (!beside) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu points", places);
    for (size_t place = 0; place < places; place++) several += beside[place] > 1;
    if (several == 0 || places == 1) {
        free(beside);
        return whirl_ok();
    }
    // Print the number of such points and, along one parameter, their ranges.
    fprintf(out, "  several attractors side by side at %zu of %zu points", several, places);
    for (size_t place = 0; place < places && table->row == 0; place++) {
        if (beside[place] < 2) continue;
        size_t last = place;
        while (last + 1 < places && beside[last + 1] > 1) last++;
        if (ranges++ < MAX_RANGES) {
            fputs(ranges == 1 ? ":" : ",", out);
            print_range(out, units, table, place, last);
        }
        place = last;
    }
    if (ranges > MAX_RANGES) fprintf(out, " and %zu more ranges", ranges - MAX_RANGES);
    fputc('\n', out);
    free(beside);
    return whirl_ok();
}

whirl_status summarize_starts(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    size_t done = 0, untold = 0;
    if (!table->attractors) return whirl_ok();
    const whirl_table *source = table->source;
    if (table->row == 0 && whirl_table_planned(table) > 1) print_attractors(out, table);
    const whirl_status status = print_coexisting(out, units, table);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < source->count; i++) {
        done += whirl_table_done(source, i);
        untold += whirl_table_done(source, i) && whirl_table_verdict(source, i).regime == WHIRL_UNDETERMINED;
    }
    if (untold > 0) fprintf(out, "  without a verdict: %zu of %zu starts: a longer transient may tell\n", untold, done);
    fprintf(out, "  %zu starts a point miss an attractor that %.2g %% of all lead to with a chance of 5 %%\n",
            source->starts, 100.0 * whirl_missed_share(source->starts));
    return whirl_ok();
}
