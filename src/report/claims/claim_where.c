// Writes where in the sweep a claim holds or fails; the table of claims only counts points.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"

enum { MAX_RANGES = 5 };

static bool speaks_of_points(const whirl_claim *claim) {
    for (const claim_part *part = claim_parts(); part->name; part++)
        if (part->stated(claim)) return true;
    return false;
}

/// Returns the score of a point for the whole claim: the least score of its parts; NaN if a part cannot be scored.
static double score_all(const claim_view *view, size_t point) {
    double least = 1.0;
    for (const claim_part *part = claim_parts(); part->name; part++) {
        if (!part->stated(view->claim)) continue;
        const double score = part->score(view, point);
        if (isnan(score)) return score;
        least = fmin(least, score);
    }
    return least;
}

static void append(char *text, size_t size, const char *more) {
    const size_t used = strlen(text);
    snprintf(text + used, size - used, "%s", more);
}

static void append_range(char *text, size_t size, const whirl_table *table, size_t first, size_t last, bool more) {
    char range[96];
    const double a = table->values[first], b = table->values[last];
    if (first == last)
        snprintf(range, sizeof range, "%s%.5g", more ? ", " : "", a);
    else
        snprintf(range, sizeof range, "%s%.5g to %.5g", more ? ", " : "", fmin(a, b), fmax(a, b));
    append(text, size, range);
}

/// Writes where a claim fails: "does not hold at r_k = 0.49824 to 0.5, 0.48 (9 of 296 points)".
static void where_missed(const claim_view *view, const claim_selection *of, const char *parameter, char *text,
                         size_t size) {
    size_t ranges = 0, missed = 0, compared = 0, first = SIZE_MAX;
    const size_t count = of->table->count;
    snprintf(text, size, "does not hold at %s = ", parameter);
    // Collect ranges of neighbouring points at which the claim fails; the round after the last point closes the last
    // range.
    for (size_t i = 0; i <= count; i++) {
        const bool here = i < count && claim_selected(of, i) && whirl_table_done(of->table, i);
        const double score = here ? score_all(view, i) : (double)NAN;
        const bool misses = score < 1.0;
        compared += !isnan(score);
        missed += misses;
        if (misses && first == SIZE_MAX) first = i;
        if (misses || first == SIZE_MAX) continue;
        if (ranges++ < MAX_RANGES) append_range(text, size, of->table, first, i - 1, ranges > 1);
        first = SIZE_MAX;
    }
    // Add the number of points; one sentence replaces the ranges if all points fail or none can be compared.
    char rest[96];
    if (ranges > MAX_RANGES)
        snprintf(rest, sizeof rest, " and in %zu more ranges (%zu of %zu points)", ranges - MAX_RANGES, missed,
                 compared);
    else
        snprintf(rest, sizeof rest, " (%zu of %zu points)", missed, compared);
    if (missed == 0)
        snprintf(text, size, "cannot be compared at every point");
    else if (missed == compared)
        snprintf(text, size, "holds at none of %zu points", compared);
    else
        append(text, size, rest);
}

/// Writes "holds at r_k = 0.4191, the nearest of the sweep", or that the claim holds nowhere.
static void where_met(const claim_view *view, const char *parameter, double value, char *text, size_t size) {
    const whirl_table *sweep = view->table;
    size_t best = SIZE_MAX, compared = 0;
    for (size_t i = 0; i < sweep->count; i++) {
        const double score = whirl_table_done(sweep, i) ? score_all(view, i) : (double)NAN;
        compared += !isnan(score);
        if (score == 1.0 && (best == SIZE_MAX || fabs(sweep->values[i] - value) < fabs(sweep->values[best] - value)))
            best = i;
    }
    if (compared == 0)
        snprintf(text, size, "no point of the sweep can be compared with it");
    else if (best == SIZE_MAX)
        snprintf(text, size, "holds at none of the %zu points of the sweep", compared);
    else
        snprintf(text, size, "holds in full at %s = %.5g, the nearest such point of the sweep", parameter,
                 sweep->values[best]);
}

void claim_whereabouts(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result, char *text,
                       size_t size) {
    const claim_selection of = claim_select(result, claims->parameter, claim);
    const whirl_table *sweep = claim_table_over(result, WHIRL_ROLE_SURVEY, claims->parameter);
    const size_t station = claim_station(result, claims->station);
    snprintf(text, size, "not compared");
    if (station == SIZE_MAX || (speaks_of_points(claim) && of.count == 0)) return;
    if (!speaks_of_points(claim)) {
        snprintf(text, size, "along the branches");
        return;
    }
    const claim_view view = {claim, result, of.count > 1 ? of.table : sweep, station};
    if (of.count > 1)
        where_missed(&view, &of, claims->parameter, text, size);
    else if (sweep)
        where_met(&view, claims->parameter, claim->from, text, size);
    else
        snprintf(text, size, "there is no sweep to find where it would hold");
}
