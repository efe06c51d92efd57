// Compares claims with a result. A claim has parts (regime, curves, contact, lines, ...). Each part is compared at
// every point of the claim's range; its score is the share of points that agree.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"
#include "whirl/engine/claims.h"

static bool near(double a, double b) {
    return fabs(a - b) <= 1e-9 * fmax(fabs(a), fabs(b));
}

static size_t nearest_point(const whirl_table *table, double value) {
    size_t best = 0;
    for (size_t i = 1; i < table->count; i++)
        if (fabs(table->values[i] - value) < fabs(table->values[best] - value)) best = i;
    return best;
}

/// Returns the largest distance of neighbouring points of a sweep.
static double spacing(const whirl_table *table) {
    double most = 0.0;
    for (size_t i = 1; i < table->count; i++)
        if (table->branch[i] == table->branch[i - 1]) most = fmax(most, fabs(table->values[i] - table->values[i - 1]));
    return most;
}

/// Selects the point for a claim of one value: the detail point with this value, else a single point computed there,
/// else the nearest point of the sweep, if it is within one spacing.
static claim_selection select_point(const whirl_result *result, const char *parameter, double value) {
    const whirl_table *detail = claim_table_over(result, WHIRL_ROLE_DETAIL, parameter);
    if (detail) {
        const double found = detail->values[nearest_point(detail, value)];
        if (near(found, value)) return (claim_selection){detail, found, found, 1, found};
    }
    const whirl_table *response = whirl_result_role(result, WHIRL_ROLE_POINT);
    for (size_t i = 0; response && response->count == 1 && i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, parameter) == 0 && near(result->parameters[i].value, value))
            return (claim_selection){response, NAN, NAN, 1, value};
    const whirl_table *sweep = claim_table_over(result, WHIRL_ROLE_SURVEY, parameter);
    if (sweep) {
        const double found = sweep->values[nearest_point(sweep, value)];
        if (fabs(found - value) <= spacing(sweep) || near(found, value))
            return (claim_selection){sweep, found, found, 1, found};
    }
    return (claim_selection){0};
}

bool claim_selected(const claim_selection *of, size_t point) {
    if (isnan(of->from)) return true;
    const double value = of->table->values[point];
    return (value >= of->from && value <= of->to) || near(value, of->from) || near(value, of->to);
}

claim_selection claim_select(const whirl_result *result, const char *parameter, const whirl_claim *claim) {
    if (near(claim->from, claim->to)) return select_point(result, parameter, claim->from);
    claim_selection of = {claim_table_over(result, WHIRL_ROLE_SURVEY, parameter), fmin(claim->from, claim->to),
                          fmax(claim->from, claim->to), 0, 0.0};
    for (size_t i = 0; of.table && i < of.table->count; i++) of.count += claim_selected(&of, i);
    return of;
}

size_t claim_station(const whirl_result *result, const char *name) {
    for (size_t s = 0; s < result->station_count; s++)
        if (strcmp(result->stations[s].name, name) == 0) return s;
    return SIZE_MAX;
}

/// Compares one part at the selected points. `share` is the share of agreeing points among the `compared` points that
/// have data.
static whirl_agreement score_part(const claim_part *part, const claim_view *view, const claim_selection *of,
                                  double *share, size_t *compared) {
    double agreeing = 0.0;
    *compared = 0;
    for (size_t i = 0; i < of->table->count; i++) {
        if (!claim_selected(of, i) || !whirl_table_done(of->table, i)) continue;
        const double score = part->score(view, i);
        if (isnan(score)) continue;
        ++*compared;
        agreeing += score;
    }
    *share = *compared ? agreeing / (double)*compared : 0.0;
    if (*compared == 0) return WHIRL_NOT_COMPARED;
    if (*share < 0.5) return WHIRL_DISAGREES;
    return *share == 1.0 && *compared == of->count ? WHIRL_AGREES : WHIRL_AGREES_PARTLY;
}

static void describe_part(const claim_part *part, const claim_view *view, const claim_selection *of, double share,
                          size_t compared, char *text, size_t size) {
    if (of->count == 1) {
        size_t point = 0;
        while (!claim_selected(of, point)) point++;
        part->at_point(view, point, text, size);
    } else if (part->over_range) {
        claim_census census = {0};
        for (size_t i = 0; i < of->table->count; i++)
            if (claim_selected(of, i) && whirl_table_done(of->table, i)) claim_census_add(&census, view, i);
        part->over_range(view, &census, text, size);
    } else {
        snprintf(text, size, "%s as claimed at %.3g %% of %zu points", part->name, 100.0 * share, compared);
    }
}

/// Compares one part of a claim over all its points, and writes the finding.
static void compare_part(const claim_part *part, const claim_view *view, const claim_selection *of,
                         claim_finding *found) {
    double share;
    size_t compared;
    found->agreement = score_part(part, view, of, &share, &compared);
    if (compared == 0) {
        snprintf(found->text, FINDING_SIZE, "%s not computed", part->name);
        return;
    }
    describe_part(part, view, of, share, compared, found->text, FINDING_SIZE);
    const size_t used = strlen(found->text);
    if (compared < of->count)
        snprintf(found->text + used, FINDING_SIZE - used, " (unknown at %zu more)", of->count - compared);
}

/// Returns the verdict on a claim: it agrees if all parts agree, and partly if some do.
static whirl_agreement all_parts(const claim_outcome *outcome) {
    size_t agree = 0, partly = 0, disagree = 0;
    for (size_t i = 0; i < outcome->count; i++) {
        agree += outcome->findings[i].agreement == WHIRL_AGREES;
        partly += outcome->findings[i].agreement == WHIRL_AGREES_PARTLY;
        disagree += outcome->findings[i].agreement == WHIRL_DISAGREES;
    }
    if (agree + partly + disagree == 0) return WHIRL_NOT_COMPARED;
    if (agree + partly == 0) return WHIRL_DISAGREES;
    return partly + disagree == 0 ? WHIRL_AGREES : WHIRL_AGREES_PARTLY;
}

void claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                   claim_outcome *outcome) {
    const claim_selection of = claim_select(result, claims->parameter, claim);
    const size_t station = claim_station(result, claims->station);
    *outcome = (claim_outcome){.agreement = WHIRL_NOT_COMPARED};
    if (station == SIZE_MAX) {
        snprintf(outcome->note, sizeof outcome->note, "the result has no station %s", claims->station);
        return;
    }
    if (!claim_is_given(claim, result, outcome->note, sizeof outcome->note)) return;
    *outcome->note = '\0';
    if (claim_of_branches(claim)) claim_compare_branches(claims, claim, result, outcome);
    bool stated = false;
    for (const claim_part *part = claim_parts(); part->name; part++) stated = stated || part->stated(claim);
    if (stated && of.count == 0) snprintf(outcome->note, sizeof outcome->note, "no point of the result lies there");
    const claim_view view = {claim, result, of.table, station};
    for (const claim_part *part = claim_parts(); part->name && outcome->count < MAX_FINDINGS && of.count > 0; part++)
        if (part->stated(claim)) compare_part(part, &view, &of, &outcome->findings[outcome->count++]);
    if (stated && of.count == 1 && near(claim->from, claim->to) && !near(of.nearest, claim->from))
        snprintf(outcome->note, sizeof outcome->note, "at the nearest point computed, %s = %.6g", claims->parameter,
                 of.nearest);
    outcome->agreement = all_parts(outcome);
}

whirl_agreement whirl_claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                                    char *found, size_t size) {
    claim_outcome outcome;
    char text[(MAX_FINDINGS + 1) * (FINDING_SIZE + 2)] = "";
    size_t used = 0;
    claim_compare(claims, claim, result, &outcome);
    for (size_t i = 0; i < outcome.count; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", used ? "; " : "", outcome.findings[i].text);
    if (*outcome.note) snprintf(text + used, sizeof text - used, "%s%s", used ? "; " : "", outcome.note);
    if (size > 0) snprintf(found, size, "%s", text);
    return outcome.agreement;
}
