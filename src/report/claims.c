// Setting a claim beside a result. A claim is taken apart into what it states (regime, curves, contact, lines, ...); each
// part is compared at every point that the claim speaks of, and scores the share of the points that agree.
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"
#include "quantities.h"
#include "whirl/claims.h"

/// The points that a claim speaks of: a table and the range of its parameter.
typedef struct selection {
    const whirl_table *table;
    double from, to;
    size_t count;
    double nearest; ///< value of the point taken for a claim of one value
} selection;

static bool near(double a, double b) {
    return fabs(a - b) <= 1e-9 * fmax(fabs(a), fabs(b));
}

static const whirl_table *table_over(const whirl_result *result, const char *name, const char *parameter) {
    const whirl_table *table = whirl_result_table(result, name);
    return table && table->count > 0 && strcmp(table->parameter, parameter) == 0 ? table : NULL;
}

static size_t nearest_point(const whirl_table *table, double value) {
    size_t best = 0;
    for (size_t i = 1; i < table->count; i++)
        if (fabs(table->values[i] - value) < fabs(table->values[best] - value)) best = i;
    return best;
}

/// How far the sweep's points lie apart, at most.
static double spacing(const whirl_table *table) {
    double most = 0.0;
    for (size_t i = 1; i < table->count; i++)
        if (table->branch[i] == table->branch[i - 1]) most = fmax(most, fabs(table->values[i] - table->values[i - 1]));
    return most;
}

/// One value: the detail point at it, else a single point computed there, else the sweep's nearest within one spacing.
static selection select_point(const whirl_result *result, const char *parameter, double value) {
    const whirl_table *detail = table_over(result, "detail", parameter);
    if (detail) {
        const double found = detail->values[nearest_point(detail, value)];
        if (near(found, value)) return (selection){detail, found, found, 1, found};
    }
    const whirl_table *response = whirl_result_table(result, "response");
    for (size_t i = 0; response && response->count == 1 && i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, parameter) == 0 && near(result->parameters[i].value, value))
            return (selection){response, NAN, NAN, 1, value};
    const whirl_table *sweep = table_over(result, "sweep", parameter);
    if (sweep) {
        const double found = sweep->values[nearest_point(sweep, value)];
        if (fabs(found - value) <= spacing(sweep) || near(found, value))
            return (selection){sweep, found, found, 1, found};
    }
    return (selection){0};
}

static bool selected(const selection *of, size_t point) {
    if (isnan(of->from)) return true;
    const double value = of->table->values[point];
    return (value >= of->from && value <= of->to) || near(value, of->from) || near(value, of->to);
}

static selection select_points(const whirl_result *result, const char *parameter, const whirl_claim *claim) {
    if (near(claim->from, claim->to)) return select_point(result, parameter, claim->from);
    selection of = {table_over(result, "sweep", parameter), fmin(claim->from, claim->to), fmax(claim->from, claim->to),
                    0, 0.0};
    for (size_t i = 0; of.table && i < of.table->count; i++) of.count += selected(&of, i);
    return of;
}

static size_t station_index(const whirl_result *result, const char *name) {
    for (size_t s = 0; s < result->station_count; s++)
        if (strcmp(result->stations[s].name, name) == 0) return s;
    return SIZE_MAX;
}

/// Writes at the end of a text of `size` bytes.
static void append(char *text, size_t size, const char *format, ...) {
    const size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

/// One part of the claim over all its points: whether it agrees, and what was found.
static whirl_agreement compare_part(const claim_part *part, const claim_view *view, const selection *of, char *found,
                                    size_t size) {
    size_t compared = 0;
    double agreeing = 0.0;
    for (size_t i = 0; i < of->table->count; i++) {
        if (!selected(of, i)) continue;
        const double score = part->score(view, i);
        if (isnan(score)) continue;
        compared++;
        agreeing += score;
    }
    if (compared == 0) {
        append(found, size, "; %s not computed", part->name);
        return WHIRL_NOT_COMPARED;
    }
    const double share = agreeing / (double)compared;
    if (of->count > 1)
        append(found, size, "; %s as claimed at %.3g %% of %zu points", part->name, 100.0 * share, compared);
    if (compared < of->count) append(found, size, " (unknown at %zu more)", of->count - compared);
    if (share < 0.5) return WHIRL_DISAGREES;
    return share == 1.0 && compared == of->count ? WHIRL_AGREES : WHIRL_AGREES_PARTLY;
}

static whirl_agreement all_parts(const claim_view *view, const selection *of, char *found, size_t size) {
    size_t agree = 0, partly = 0, disagree = 0;
    for (const claim_part *part = claim_parts(); part->name; part++) {
        if (!part->stated(view->claim)) continue;
        const whirl_agreement outcome = compare_part(part, view, of, found, size);
        agree += outcome == WHIRL_AGREES;
        partly += outcome == WHIRL_AGREES_PARTLY;
        disagree += outcome == WHIRL_DISAGREES;
    }
    if (agree + partly + disagree == 0) return WHIRL_NOT_COMPARED;
    if (agree + partly == 0) return WHIRL_DISAGREES;
    return partly + disagree == 0 ? WHIRL_AGREES : WHIRL_AGREES_PARTLY;
}

/// What is found over a range: the regimes and their shares, and where there is contact.
static void describe_range(const claim_view *view, const selection *of, char *found, size_t size) {
    claim_census census = {0};
    for (size_t i = 0; i < of->table->count; i++)
        if (selected(of, i)) claim_census_add(&census, view, i);
    claim_census_text(&census, view->claim, found, size);
}

whirl_agreement whirl_claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                                    char *found, size_t size) {
    char text[1024] = "";
    const selection of = select_points(result, claims->parameter, claim);
    const size_t station = station_index(result, claims->station);
    whirl_agreement outcome = WHIRL_NOT_COMPARED;
    if (station == SIZE_MAX) {
        snprintf(text, sizeof text, "the result has no station %s", claims->station);
    } else if (of.count == 0) {
        snprintf(text, sizeof text, "no point of the result lies there");
    } else {
        const claim_view view = {claim, result, of.table, station};
        if (of.count > 1) {
            describe_range(&view, &of, text, sizeof text);
        } else {
            size_t point = 0;
            while (!selected(&of, point)) point++;
            claim_point_text(&view, point, text, sizeof text);
            if (!near(of.nearest, claim->from))
                append(text, sizeof text, "; at the nearest point computed, %s = %.6g", claims->parameter, of.nearest);
        }
        outcome = all_parts(&view, &of, text, sizeof text);
    }
    if (size > 0) snprintf(found, size, "%s", text);
    return outcome;
}
