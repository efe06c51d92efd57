// Compares claims with branches: special points in a range, their sense (super- or subcritical), the order of the whirl
// that begins, and the number of parts of the curve of Hopf points.
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"

/// Relative tolerances for a claim of one value, and for a claimed order.
static const double NEAR_VALUE = 0.02, NEAR_ORDER = 0.05;

enum { MAX_SHOWN = 4 };

typedef struct claim_range {
    const whirl_table *branches;
    double from, to;
} claim_range;

static void changes_put(char *text, size_t size, const char *format, ...) {
    const size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

static double number_at(const whirl_table *table, size_t row, const char *field) {
    return whirl_table_number(table, row, field, 0);
}

const whirl_table *claim_table_over(const whirl_result *result, whirl_role role, const char *parameter) {
    const whirl_table *table = whirl_result_role(result, role);
    return table && table->count > 0 && strcmp(table->parameter, parameter) == 0 ? table : NULL;
}

static claim_range changes_range(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result) {
    const double aside = claim->from == claim->to ? NEAR_VALUE * fabs(claim->from) : 0.0;
    return (claim_range){claim_table_over(result, WHIRL_ROLE_BRANCHES, claims->parameter), claim->from - aside,
                         claim->to + aside};
}

/// Returns true if a row of the branches is a special point of this kind within the range.
static bool is_change(const claim_range *of, size_t row, whirl_special kind) {
    const double value = of->branches->values[row];
    return number_at(of->branches, row, WHIRL_FIELD_TRACE_SPECIAL) == (double)kind && value >= of->from &&
           value <= of->to;
}

static size_t count_changes(const claim_range *of, whirl_special kind) {
    size_t count = 0;
    for (size_t i = 0; i < of->branches->count; i++) count += is_change(of, i, kind);
    return count;
}

/// Returns the row of the special point with the least parameter value; SIZE_MAX if there is none.
static size_t first_change(const claim_range *of, whirl_special kind) {
    size_t first = SIZE_MAX;
    for (size_t i = 0; i < of->branches->count; i++)
        if (is_change(of, i, kind) && (first == SIZE_MAX || of->branches->values[i] < of->branches->values[first]))
            first = i;
    return first;
}

/// Appends the special points of a kind: "fold at 1.5, 1.7", or "no fold".
static void put_kind(const claim_range *of, whirl_special kind, char *text, size_t size) {
    size_t shown = 0;
    const size_t count = count_changes(of, kind);
    changes_put(text, size, *text ? ", %s%s" : "%s%s", count ? "" : "no ", whirl_special_name(kind));
    for (size_t i = 0; i < of->branches->count && shown < MAX_SHOWN; i++)
        if (is_change(of, i, kind)) changes_put(text, size, shown++ ? ", %.6g" : " at %.6g", of->branches->values[i]);
    if (count > shown) changes_put(text, size, " and %zu more", count - shown);
}

/// Returns the share of the range that the branches cover.
static double covered(const claim_range *of) {
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < of->branches->count; i++) {
        low = fmin(low, of->branches->values[i]);
        high = fmax(high, of->branches->values[i]);
    }
    const double within = fmin(high, of->to) - fmax(low, of->from);
    return of->to > of->from ? fmax(within, 0.0) / (of->to - of->from) : (double)(low <= of->to && high >= of->from);
}

static whirl_agreement agreement_of(size_t agreeing, size_t count) {
    if (agreeing == 0) return WHIRL_DISAGREES;
    return agreeing == count ? WHIRL_AGREES : WHIRL_AGREES_PARTLY;
}

// ---------------------------------------------------------------- parts

static void compare_kinds(const claim_range *of, const whirl_claim_kinds *kinds, bool there, claim_finding *found) {
    size_t agreeing = 0;
    for (size_t k = 0; k < kinds->count; k++) {
        agreeing += (count_changes(of, kinds->list[k]) > 0) == there;
        put_kind(of, kinds->list[k], found->text, FINDING_SIZE);
    }
    found->agreement = agreement_of(agreeing, kinds->count);
    const double share = covered(of);
    if (share >= 1.0 - 1e-9) return;
    changes_put(found->text, FINDING_SIZE, " (branches were followed over %.3g %% of the range)", 100.0 * share);
    if (found->agreement == WHIRL_AGREES && !there) found->agreement = WHIRL_AGREES_PARTLY;
    if (share == 0.0) found->agreement = WHIRL_NOT_COMPARED;
}

static void compare_sense(const claim_range *of, const whirl_claim *claim, claim_finding *found) {
    const size_t row = first_change(of, claim->changes.list[0]);
    const double sense = row == SIZE_MAX ? (double)NAN : number_at(of->branches, row, WHIRL_FIELD_TRACE_CRITICALITY);
    changes_put(found->text, FINDING_SIZE, "%s",
                isnan(sense)  ? "sense not known"
                : sense < 0.0 ? "supercritical"
                              : "subcritical");
    if (!isnan(sense)) found->agreement = (sense < 0.0) == (claim->sense < 0) ? WHIRL_AGREES : WHIRL_DISAGREES;
}

static void compare_orders(const claim_range *of, const whirl_claim *claim, claim_finding *found) {
    const size_t row = first_change(of, WHIRL_HOPF);
    if (row == SIZE_MAX) {
        changes_put(found->text, FINDING_SIZE, "no whirl begins");
        found->agreement = WHIRL_DISAGREES;
        return;
    }
    const double order = number_at(of->branches, row, WHIRL_FIELD_TRACE_ANGLE);
    bool met = false;
    for (size_t i = 0; i < claim->order_count; i++)
        met = met || fabs(order - claim->orders[i]) <= NEAR_ORDER * claim->orders[i];
    changes_put(found->text, FINDING_SIZE, "whirl of %.4g orders begins first, at %.6g", order,
                of->branches->values[row]);
    found->agreement = met ? WHIRL_AGREES : WHIRL_DISAGREES;
}

// ---------------------------------------------------------------- parts of a curve

/// A curve of `count` rows of a table from `first` on. It has two legs from the same start: rows of the first leg
/// (`other` of them), then rows of the second. In order along the curve they are the second leg backwards, then the
/// first.
typedef struct claim_curve {
    const whirl_table *table;
    size_t first, other, count;
} claim_curve;

static size_t curve_row(const claim_curve *of, size_t k) {
    const size_t second = of->count - of->other;
    return k < second ? of->first + of->count - 1 - k : of->first + (k - second);
}

static size_t leg_length(const whirl_table *table, size_t first) {
    size_t count = 0;
    const double number = first < table->count ? number_at(table, first, WHIRL_FIELD_TRACE_NUMBER) : (double)NAN;
    while (first + count < table->count && number_at(table, first + count, WHIRL_FIELD_TRACE_NUMBER) == number) count++;
    return count;
}

/// Returns the first curve of Hopf points; a curve without rows if there is none.
static claim_curve hopf_curve(const whirl_result *result) {
    claim_curve curve = {whirl_result_role(result, WHIRL_ROLE_CURVES), 0, 0, 0};
    const whirl_table *table = curve.table;
    if (!table) return curve;
    while (curve.first < table->count && number_at(table, curve.first, WHIRL_FIELD_TRACE_SPECIAL) != WHIRL_HOPF)
        curve.first++;
    curve.other = leg_length(table, curve.first);
    const size_t next = curve.first + curve.other;
    const bool both = next < table->count && table->values[next] == table->values[curve.first] &&
                      number_at(table, next, WHIRL_FIELD_TRACE_SPECIAL) == WHIRL_HOPF;
    curve.count = curve.other + (both ? leg_length(table, next) : 0);
    return curve;
}

/// Writes the parts of the curve of Hopf points: "supercritical from s = 3, subcritical from s = 2", and compares their
/// number.
static void compare_regions(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                            claim_finding *found) {
    const claim_curve curve = hopf_curve(result);
    int regions = 0, sign = 0;
    char parts[FINDING_SIZE] = "";
    for (size_t k = 0; k < curve.count; k++) {
        const size_t row = curve_row(&curve, k);
        const double sense = number_at(curve.table, row, WHIRL_FIELD_TRACE_CRITICALITY);
        if (isnan(sense) || sense == 0.0 || (sense > 0.0 ? 1 : -1) == sign) continue;
        sign = sense > 0.0 ? 1 : -1;
        regions++;
        changes_put(parts, sizeof parts, regions == 1 ? "%s from %s = %.4g" : ", %s from %s = %.4g",
                    sign > 0 ? "subcritical" : "supercritical", claims->parameter, curve.table->values[row]);
    }
    changes_put(found->text, FINDING_SIZE, regions ? "%d: %s" : "the result has no curve of Hopf points", regions,
                parts);
    if (regions > 0) found->agreement = regions == claim->regions ? WHIRL_AGREES : WHIRL_DISAGREES;
}

// ---------------------------------------------------------------- the whole claim

bool claim_of_branches(const whirl_claim *claim) {
    return claim->changes.count > 0 || claim->unchanged.count > 0 || claim->order_count > 0 || claim->regions > 0;
}

static claim_finding *next_finding(claim_outcome *outcome) {
    claim_finding *one = &outcome->findings[outcome->count++];
    *one = (claim_finding){.agreement = WHIRL_NOT_COMPARED};
    return one;
}

void claim_compare_branches(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                            claim_outcome *outcome) {
    const claim_range of = changes_range(claims, claim, result);
    if (claim->regions > 0) compare_regions(claims, claim, result, next_finding(outcome));
    if (claim->changes.count + claim->unchanged.count + claim->order_count == 0) return;
    if (!of.branches) {
        changes_put(next_finding(outcome)->text, FINDING_SIZE, "the result has no branches over %s", claims->parameter);
        return;
    }
    if (claim->changes.count > 0) compare_kinds(&of, &claim->changes, true, next_finding(outcome));
    if (claim->unchanged.count > 0) compare_kinds(&of, &claim->unchanged, false, next_finding(outcome));
    if (claim->sense) compare_sense(&of, claim, next_finding(outcome));
    if (claim->order_count > 0) compare_orders(&of, claim, next_finding(outcome));
}

bool claim_is_given(const whirl_claim *claim, const whirl_result *result, char *text, size_t size) {
    if (!*claim->given) return true;
    for (size_t i = 0; i < result->parameter_count; i++) {
        const double value = result->parameters[i].value;
        if (strcmp(result->parameters[i].name, claim->given) != 0) continue;
        snprintf(text, size, "of %s = %.5g to %.5g, here it is %.5g", claim->given, claim->given_from, claim->given_to,
                 value);
        return value >= claim->given_from && value <= claim->given_to;
    }
    snprintf(text, size, "the case has no parameter %s", claim->given);
    return false;
}
