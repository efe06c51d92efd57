// Writes what was found about a claim, as a short line for each part.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"
#include "regimes.h"

enum { MAX_LINES = 6 };

static double rub_at(const claim_view *view, size_t point) {
    return rub_share(view->table, point, view->result->contact_count);
}

void claim_census_add(claim_census *census, const claim_view *view, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    const double value = view->table->values[point];
    // Count the point by its regime.
    census->points++;
    census->in_class[regime_class_of(&verdict)]++;
    // Note the range of parameter values with contact, and count points with permanent contact.
    const double share = rub_at(view, point);
    census->rub_known += !isnan(share);
    if (share > 0.0) {
        census->rub_low = census->rubbing ? fmin(census->rub_low, value) : value;
        census->rub_high = census->rubbing ? fmax(census->rub_high, value) : value;
        census->rubbing++;
        census->always += share >= ALWAYS;
    }
    // Note dry whip.
    const double whip = whirl_table_number(view->table, point, WHIRL_FIELD_WINDING_DRY_WHIP, view->station);
    census->whip_known += !isnan(whip);
    census->whipping += whip > 0.0;
    // Note the range of the largest line of the spectrum.
    const numbers lines = claim_lines(view, point);
    if (lines.rows > 0) {
        census->largest_low = census->largest_known ? fmin(census->largest_low, lines.at[0]) : lines.at[0];
        census->largest_high = census->largest_known ? fmax(census->largest_high, lines.at[0]) : lines.at[0];
        census->largest_known++;
    }
    // Note the range of the backward share.
    const double backward = backward_share(view->table, point, view->station);
    if (isnan(backward)) return;
    census->backward_low = census->backward_known ? fmin(census->backward_low, backward) : backward;
    census->backward_high = census->backward_known ? fmax(census->backward_high, backward) : backward;
    census->backward_known++;
}

// ---------------------------------------------------------------- regime and curves

void claim_regime_at(const claim_view *view, size_t point, char *text, size_t size) {
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    if (verdict.regime == WHIRL_DIVERGING || view->claim->curves == 0)
        whirl_verdict_name(&verdict, text, size);
    else
        regime_name(&verdict, text, size); // without the number of curves, which is another part
    const size_t used = strlen(text);
    const bool known = point_numbers(view->table, point, WHIRL_FIELD_REGIME_CONFIDENCE, 0).at != NULL;
    if (known && verdict.confidence == WHIRL_LOW && verdict.regime != WHIRL_UNDETERMINED)
        snprintf(text + used, size - used, ", of low confidence");
}

/// Writes the regimes of a range: "P-1 at 96.6 %, quasi-periodic at 3.4 % of 297 points".
void claim_regime_over(const claim_view *view, const claim_census *census, char *text, size_t size) {
    size_t used = 0;
    (void)view;
    for (int kind = 0; kind < CLASS_COUNT && used < size; kind++) {
        const size_t count = census->in_class[kind];
        const char *name = regime_class_name((regime_class)kind);
        if (count > 0 && count == census->points) {
            snprintf(text, size, "%s at all %zu points", name, count);
            return;
        }
        if (count > 0)
            used += (size_t)snprintf(text + used, size - used,
                                     count * 10 < census->points ? "%s%s at %.2g %%" : "%s%s at %.3g %%",
                                     used ? ", " : "", name, 100.0 * (double)count / (double)census->points);
    }
    if (used < size) snprintf(text + used, size - used, " of %zu points", census->points);
}

void claim_curves_at(const claim_view *view, size_t point, char *text, size_t size) {
    const int curves = whirl_table_verdict(view->table, point).curves;
    if (curves == 0)
        snprintf(text, size, "no closed curve");
    else
        snprintf(text, size, "%d closed curve%s", curves, curves == 1 ? "" : "s");
}

// ---------------------------------------------------------------- contact

void claim_contact_at(const claim_view *view, size_t point, char *text, size_t size) {
    const double share = rub_at(view, point);
    if (share > 0.0)
        snprintf(text, size, "rub %.2g %% of the time", 100.0 * share);
    else
        snprintf(text, size, "no rub");
}

void claim_contact_over(const claim_view *view, const claim_census *census, char *text, size_t size) {
    if (census->rubbing == 0)
        snprintf(text, size, "no rub at any of %zu points", census->points);
    else if (census->always == census->points)
        snprintf(text, size, "rub at all %zu points, always", census->points);
    else if (census->rubbing == census->points && view->claim->contact >= WHIRL_CONTACT_AT_TIMES)
        snprintf(text, size, "rub at all %zu points, always at %zu of them", census->points, census->always);
    else if (census->rubbing == census->points)
        snprintf(text, size, "rub at all %zu points", census->points);
    else
        snprintf(text, size, "rub at %.3g %% of %zu points (%s = %.4g to %.4g)",
                 100.0 * (double)census->rubbing / (double)census->points, census->points, view->table->parameter,
                 census->rub_low, census->rub_high);
}

void claim_dry_whip_at(const claim_view *view, size_t point, char *text, size_t size) {
    const bool whips = whirl_table_number(view->table, point, WHIRL_FIELD_WINDING_DRY_WHIP, view->station) > 0.0;
    const double turns = whirl_table_number(view->table, point, WHIRL_FIELD_WINDING_WINDING, view->station);
    snprintf(text, size, "%s, %.4g turns of the station in a revolution", whips ? "dry whip" : "no dry whip", turns);
}

void claim_dry_whip_over(const claim_view *view, const claim_census *census, char *text, size_t size) {
    (void)view;
    if (census->whipping == 0 || census->whipping == census->whip_known)
        snprintf(text, size, "%s of %zu points", census->whipping ? "dry whip at all" : "dry whip at none",
                 census->whip_known);
    else
        snprintf(text, size, "dry whip at %zu of %zu points", census->whipping, census->whip_known);
}

// ---------------------------------------------------------------- spectrum

void claim_lines_at(const claim_view *view, size_t point, char *text, size_t size) {
    const numbers lines = claim_lines(view, point);
    size_t used = (size_t)snprintf(text, size, lines.rows == 1 ? "line" : "lines");
    for (size_t i = 0; i < lines.rows && i < MAX_LINES && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s %.3g", i ? "," : "", lines.at[5 * i]);
    if (used < size)
        snprintf(text + used, size - used,
                 lines.rows == 0          ? ": none"
                 : lines.rows > MAX_LINES ? " X, and smaller ones"
                                          : " X");
}

void claim_band_at(const claim_view *view, size_t point, char *text, size_t size) {
    const claim_band found = claim_band_of(view, point);
    snprintf(text, size, "%zu line%s in %.3g to %.3g X with %.0f %% of the power below 1 X", found.lines,
             found.lines == 1 ? "" : "s", view->claim->band[0], view->claim->band[1], 100.0 * found.share);
}

void claim_largest_at(const claim_view *view, size_t point, char *text, size_t size) {
    snprintf(text, size, "largest line %.3g X", claim_lines(view, point).at[0]);
}

void claim_largest_over(const claim_view *view, const claim_census *census, char *text, size_t size) {
    (void)view;
    snprintf(text, size, "largest line %.3g to %.3g X", census->largest_low, census->largest_high);
}

// ---------------------------------------------------------------- sense of whirl

void claim_whirl_at(const claim_view *view, size_t point, char *text, size_t size) {
    const double backward = backward_share(view->table, point, view->station);
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    if (verdict.regime == WHIRL_DIVERGING)
        whirl_verdict_name(&verdict, text, size);
    else
        snprintf(text, size, "bounded; against the rotation %.3g %% of the time", 100.0 * backward);
}

void claim_whirl_over(const claim_view *view, const claim_census *census, char *text, size_t size) {
    const size_t diverged = census->in_class[CLASS_DIVERGED];
    const double low = 100.0 * census->backward_low, high = 100.0 * census->backward_high;
    size_t used = 0;
    (void)view;
    if (diverged == 0)
        used = (size_t)snprintf(text, size, "bounded everywhere");
    else
        used = (size_t)snprintf(text, size, "diverged at %zu of %zu points", diverged, census->points);
    if (census->backward_known == 0 || used >= size) return;
    if (high - low < 0.05)
        snprintf(text + used, size - used, "; against the rotation %.3g %% of the time", high);
    else
        snprintf(text + used, size - used, "; against the rotation %.3g to %.3g %% of the time", low, high);
}
