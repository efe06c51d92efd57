// Findings on attractors: those of a basin, and those to which several starts for each point lead.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "found_motions.h"
#include "quantities.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

// ---------------------------------------------------------------- a basin

/// Returns the number of points that are done; for a refined map those of its grid.
static size_t basin_done(const finder *of) {
    size_t done = 0, *weights;
    const bool weighed = motions_weights(of, &weights);
    for (size_t i = 0; weighed && i < of->table->count; i++)
        done += whirl_table_done(of->table, i) ? weights ? weights[i] : 1 : 0;
    free(weights);
    return done;
}

static void find_basin(const finder *of) {
    enum { MAX_ATTRACTORS = 64 };
    const whirl_table *table = of->table;
    whirl_attractor found[MAX_ATTRACTORS];
    size_t count, known = 0;
    const whirl_status status = whirl_table_attractors(table, NULL, found, MAX_ATTRACTORS, &count);
    if (status.code == WHIRL_NO_MEMORY) of->findings->failed = true;
    if (status.code != WHIRL_OK) return;
    // Add a row for each attractor.
    whirl_sheet *sheet = find_sheet(of, "attractors", "Attractors");
    sheet->about =
        find_text(of->findings,
                  "Motions that the starts settle on%s. Errors are the standard errors of as many independent "
                  "random starts.",
                  count > MAX_ATTRACTORS ? "; those with the most starts are listed" : "");
    sheet_column(of, sheet, "attractor", "attractor", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "motion", "motion");
    sheet_column(of, sheet, "starts", "starts", WHIRL_QUANTITY_NUMBER, 9);
    sheet_list(of, sheet, "share", "share (%)", WHIRL_QUANTITY_NUMBER, 3, " +- ");
    sheet_list(of, sheet, "first", find_text(of->findings, "first start (%s, %s)", table->parameter, table->second),
               WHIRL_QUANTITY_NUMBER, 5, ", ");
    sheet_exponent(of, sheet);
    for (size_t k = 0; k < count && k < MAX_ATTRACTORS; k++) {
        const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
        const double first[] = {table->values[found[k].first], whirl_table_second(table, found[k].first)};
        const double share[] = {100.0 * found[k].share, 100.0 * found[k].error};
        char name[LABEL_SIZE];
        whirl_verdict_name(&verdict, name, sizeof name);
        known += found[k].points;
        sheet_row(of, sheet);
        cell_number(of, sheet, (double)(k + 1));
        cell_colour(of, sheet, attractor_colour(k + 1));
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        cell_number(of, sheet, (double)found[k].points);
        cell_numbers(of, sheet, 2, share);
        cell_numbers(of, sheet, 2, first);
        cell_exponent(of, sheet, found[k].first);
    }
    find_sheet_end(of);
    // State the starts without a verdict.
    const size_t done = basin_done(of);
    if (count > MAX_ATTRACTORS || known >= done) return;
    phrase_text(of, &find_statement(of, "without a verdict")->found,
                "%zu start%s, %.1f %%: a longer transient may settle them", done - known, done - known == 1 ? "" : "s",
                100.0 * (double)(done - known) / (double)done);
}

// ---------------------------------------------------------------- several starts for each point

/// Returns "P-1, P-2, chaotic": the motions of consecutive rows, each named once.
static const char *attractor_motions(const finder *of, size_t first, size_t end) {
    enum { MAX_NAMES = 6 };
    char names[MAX_NAMES][LABEL_SIZE];
    const char *text = "";
    size_t count = 0;
    for (size_t i = first; i < end; i++) {
        const whirl_verdict verdict = whirl_table_verdict(of->table, i);
        char name[LABEL_SIZE];
        size_t k = 0;
        regime_name(&verdict, name, sizeof name);
        while (k < count && strcmp(names[k], name) != 0) k++;
        if (k < count) continue;
        if (count == MAX_NAMES) return find_text(of->findings, "%s, ...", text);
        memcpy(names[count], name, sizeof name);
        text = find_text(of->findings, "%s%s%s", text, count++ > 0 ? ", " : "", name);
    }
    return text;
}

/// Adds the row of an attractor, from its consecutive rows in the table.
static void attractor_row(const finder *of, whirl_sheet *sheet, size_t first, size_t end) {
    const whirl_table *table = of->table;
    const whirl_coexisting *one = &table->attractors[first];
    double share[] = {100.0 * one->share, 100.0 * one->share}, error = one->error;
    size_t met = 0;
    for (size_t i = first; i < end; i++) {
        share[0] = fmin(share[0], 100.0 * table->attractors[i].share);
        share[1] = fmax(share[1], 100.0 * table->attractors[i].share);
        error = fmax(error, table->attractors[i].error);
        met += table->attractors[i].starts > 0;
    }
    sheet_row(of, sheet);
    cell_number(of, sheet, (double)one->number);
    cell_colour(of, sheet, attractor_colour(one->number));
    cell_text(of, sheet, attractor_motions(of, first, end));
    cell_value(of, sheet, first);
    cell_value(of, sheet, end - 1);
    cell_number(of, sheet, (double)(end - first));
    cell_numbers(of, sheet, share[1] > share[0] ? 2 : 1, share);
    cell_number(of, sheet, met < end - first ? (double)(end - first - met) : (double)NAN);
    cell_number(of, sheet, 100.0 * error);
}

/// Returns the words that explain starts and the numbers of attractors.
static const char *starts_about(const finder *of) {
    const whirl_table *source = of->table->source;
    return find_text(
        of->findings,
        "Every point was started from %zu states: the initial state and %zu that fill the ranges of the starts. "
        "%sAttractors of neighbouring points have one number where each is the nearest of the other and the motion "
        "changes by less than half of its extent%s. Errors are the standard errors of as many independent random "
        "starts.",
        source->starts, source->starts - 1,
        source->neighbours > 0
            ? "If a neighbouring point had an attractor that none of these starts reached, the point "
              "was also started from the end of that motion: an attractor found only so has a share "
              "of 0. "
            : "",
        of->table->row > 0 ? "; the maps show the one of every point that most starts lead to" : "");
}

static void sheet_attractors(const finder *of) {
    const whirl_table *table = of->table;
    whirl_sheet *sheet = find_sheet(of, "attractors", "Attractors");
    sheet->unsummarized = find_alone(of);
    sheet->about = starts_about(of);
    sheet_column(of, sheet, "attractor", "attractor", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "motion", "motion");
    sheet_values(of, sheet, "from", 6);
    sheet_values(of, sheet, "to", 6);
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 9);
    sheet_list(of, sheet, "share", "% of the starts", WHIRL_QUANTITY_NUMBER, 3, " to ");
    sheet_column(of, sheet, "neighbours", "points found from neighbours alone", WHIRL_QUANTITY_NUMBER, 9);
    sheet_column(of, sheet, "error", "standard error at most", WHIRL_QUANTITY_PERCENT, 2);
    for (size_t first = 0, end; first < table->count; first = end) {
        for (end = first; end < table->count && table->attractors[end].number == table->attractors[first].number;)
            end++;
        attractor_row(of, sheet, first, end);
    }
    find_sheet_end(of);
}

/// Finds the number of attractors and the value of the parameter at every place [2][places]; to be freed.
static double *places_of(const finder *of, size_t places) {
    const whirl_table *source = of->table->source;
    double *found = calloc(2 * places + 1, sizeof *found);
    if (!found) of->findings->failed = true;
    for (size_t i = 0; found && i < of->table->count; i++)
        found[of->table->attractors[i].place] = (double)of->table->attractors[i].coexisting;
    for (size_t i = 0; found && i < source->count; i++)
        found[places + whirl_table_place(source, i)] = source->values[i];
    return found;
}

/// Adds the statement of how many points have several attractors; along one parameter also the ranges of its values.
static void state_places(const finder *of) {
    enum { MAX_RANGES = 8 };
    const size_t places = whirl_table_places(of->table->source);
    double *coexisting = places_of(of, places);
    const double *values = coexisting ? coexisting + places : NULL;
    size_t several = 0, ranges = 0;
    for (size_t k = 0; coexisting && k < places; k++) several += coexisting[k] > 1.5;
    whirl_phrase *found = &find_statement(of, "several attractors")->found;
    if (several == 0)
        phrase_text(of, found, "found at no point");
    else
        phrase_text(of, found, "coexist at %zu of %zu point%s", several, places, places == 1 ? "" : "s");
    for (size_t k = 0; coexisting && *of->table->parameter && of->table->row == 0 && k < places; k++) {
        size_t last = k;
        if (!(coexisting[k] > 1.5)) continue;
        while (last + 1 < places && coexisting[last + 1] > 1.5) last++;
        if (ranges++ < MAX_RANGES) {
            phrase_text(of, found, ranges == 1 ? ": " : ", ");
            phrase_value(of, found, 6, values[k]);
            if (last > k) {
                phrase_text(of, found, " to ");
                phrase_value(of, found, 6, values[last]);
            }
        }
        k = last;
    }
    if (ranges > MAX_RANGES) phrase_text(of, found, " and %zu more ranges", ranges - MAX_RANGES);
    free(coexisting);
}

static void find_starts(const finder *of) {
    const whirl_table *source = of->table->source;
    size_t done, undetermined;
    if (of->table->row == 0) sheet_attractors(of);
    state_places(of);
    starts_count(source, &done, &undetermined);
    if (undetermined > 0)
        phrase_text(of, &find_statement(of, "without a verdict")->found,
                    "%zu of %zu starts: a longer transient may settle them", undetermined, done);
    phrase_text(of, &find_statement(of, "starts")->found,
                "%zu for each point: with a chance of 5 %% they all miss an attractor to which %.2g %% of starts lead",
                source->starts, 100.0 * whirl_missed_share(source->starts));
}

void find_attractors(const finder *of) {
    if (of->table->role == WHIRL_ROLE_BASIN) find_basin(of);
    if (of->table->attractors) find_starts(of);
}
