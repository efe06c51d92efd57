#include "claim_parts.h"

#include <math.h>
#include <string.h>

// ---------------------------------------------------------------- regime and curves

static bool states_regime(const whirl_claim *claim) {
    return claim->has_regime;
}

static double score_regime(const claim_view *view, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    if (verdict.regime != view->claim->regime) return 0.0;
    return view->claim->period == 0 || verdict.period == view->claim->period ? 1.0 : 0.0;
}

static bool states_curves(const whirl_claim *claim) {
    return claim->curves > 0;
}

static double score_curves(const claim_view *view, size_t point) {
    return whirl_table_verdict(view->table, point).curves == view->claim->curves ? 1.0 : 0.0;
}

// ---------------------------------------------------------------- contact

static bool states_contact(const whirl_claim *claim) {
    return claim->has_contact;
}

static double score_contact(const claim_view *view, size_t point) {
    // A rotor without contacts has a share of 0.
    const double share = view->result->contact_count ? rub_share(view->table, point, view->result->contact_count) : 0.0;
    if (isnan(share)) return NAN;
    switch (view->claim->contact) {
    case WHIRL_CONTACT_NEVER:
        return share > 0.0 ? 0.0 : 1.0;
    case WHIRL_CONTACT_AT_TIMES:
        return share > 0.0 && share < ALWAYS ? 1.0 : 0.0;
    case WHIRL_CONTACT_ALWAYS:
        return share >= ALWAYS ? 1.0 : 0.0;
    default:
        return share > 0.0 ? 1.0 : 0.0;
    }
}

static bool states_dry_whip(const whirl_claim *claim) {
    return claim->has_dry_whip;
}

static double score_dry_whip(const claim_view *view, size_t point) {
    const double found = whirl_table_number(view->table, point, WHIRL_FIELD_WINDING_DRY_WHIP, view->station);
    if (isnan(found)) return NAN;
    return (found > 0.0) == view->claim->dry_whip ? 1.0 : 0.0;
}

// ---------------------------------------------------------------- lines

static bool states_lines(const whirl_claim *claim) {
    return claim->line_count > 0;
}

static bool claims_line(const whirl_claim *claim, double order) {
    for (size_t c = 0; c < claim->line_count; c++)
        if (fabs(order - claim->lines[c]) <= LINE_TOLERANCE) return true;
    return false;
}

/// Scores 1 if all claimed lines are found and, if the claim says "only", no others. Both conditions are one part,
/// since nearly every rotor has a line at the running speed.
static double score_lines(const claim_view *view, size_t point) {
    const numbers lines = claim_lines(view, point);
    if (!lines.at) return NAN;
    for (size_t c = 0; c < view->claim->line_count; c++) {
        bool there = false;
        for (size_t i = 0; i < lines.rows; i++)
            there = there || fabs(lines.at[5 * i] - view->claim->lines[c]) <= LINE_TOLERANCE;
        if (!there) return 0.0;
    }
    for (size_t i = 0; i < lines.rows && view->claim->only_lines; i++)
        if (!claims_line(view->claim, lines.at[5 * i])) return 0.0;
    return 1.0;
}

// ---------------------------------------------------------------- band

static bool states_band(const whirl_claim *claim) {
    return claim->has_band;
}

/// Scores 0.5 if the band has three quarters of the power of all lines below the running speed, and 1 if it also has
/// three lines or more.
static double score_band(const claim_view *view, size_t point) {
    const claim_band found = claim_band_of(view, point);
    if (isnan(found.share)) return NAN;
    if (found.share < 0.75) return 0.0;
    return found.lines >= 3 ? 1.0 : 0.5;
}

// ---------------------------------------------------------------- largest line

static bool states_largest(const whirl_claim *claim) {
    return claim->has_largest;
}

static double score_largest(const claim_view *view, size_t point) {
    const numbers lines = claim_lines(view, point);
    const double *range = view->claim->largest;
    if (lines.rows == 0) return NAN;
    return lines.at[0] >= range[0] - LINE_TOLERANCE && lines.at[0] <= range[1] + LINE_TOLERANCE ? 1.0 : 0.0;
}

// ---------------------------------------------------------------- sense of whirl

static bool states_whirl(const whirl_claim *claim) {
    return claim->has_whirl;
}

/// Scores the sense of whirl. For "diverging-backward" a bounded motion that whirls backward most of the time scores
/// 0.5.
static double score_whirl(const claim_view *view, size_t point) {
    const bool diverged = whirl_table_verdict(view->table, point).regime == WHIRL_DIVERGING;
    const bool diverging = strcmp(view->claim->whirl, "diverging-backward") == 0;
    if (diverging && diverged) return 1.0;
    const double backward = backward_share(view->table, point, view->station);
    if (isnan(backward)) return diverged ? 0.0 : NAN;
    if (strcmp(view->claim->whirl, "forward") == 0) return backward < 0.5 ? 1.0 : 0.0;
    return backward > 0.5 ? (diverging ? 0.5 : 1.0) : 0.0;
}

const claim_part *claim_parts(void) {
    static const claim_part parts[] = {
        {"regime", states_regime, score_regime, claim_regime_at, claim_regime_over},
        {"number of curves", states_curves, score_curves, claim_curves_at, NULL},
        {"contact", states_contact, score_contact, claim_contact_at, claim_contact_over},
        {"dry whip", states_dry_whip, score_dry_whip, claim_dry_whip_at, claim_dry_whip_over},
        {"lines", states_lines, score_lines, claim_lines_at, NULL},
        {"band of lines", states_band, score_band, claim_band_at, NULL},
        {"largest line", states_largest, score_largest, claim_largest_at, claim_largest_over},
        {"whirl", states_whirl, score_whirl, claim_whirl_at, claim_whirl_over},
        {NULL, NULL, NULL, NULL, NULL},
    };
    return parts;
}
