// Comparison of claims with results. A claim states one or more parts (regime, contact, lines, ...); each part is
// compared separately.
#ifndef REPORT_CLAIM_PARTS_H
#define REPORT_CLAIM_PARTS_H

#include <stdbool.h>
#include <stddef.h>

#include "quantities.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/claims.h"
#include "whirl/engine/result.h"

/// A claim, and the table with which it is compared.
typedef struct claim_view {
    const whirl_claim *claim;
    const whirl_result *result;
    const whirl_table *table;
    size_t station;
} claim_view;

/// Counts over the computed points of a range.
typedef struct claim_census {
    size_t points, in_class[CLASS_COUNT]; ///< all points; points of each regime
    size_t rubbing, rub_known, always;    ///< points with contact, with a known share of contact, always in contact
    size_t whipping, whip_known;          ///< points in dry whip, points for which that is known
    double rub_low, rub_high;             ///< values of the parameter between which there is contact
    double largest_low, largest_high;     ///< orders of the largest lines
    size_t largest_known;
    double backward_low, backward_high;
    size_t backward_known;
} claim_census;

void claim_census_add(claim_census *census, const claim_view *view, size_t point);

typedef struct claim_part {
    const char *name;
    bool (*stated)(const whirl_claim *claim);
    /// Returns the agreement at a point: 1 if it agrees, 0 if not, 0.5 if half of the part does; NaN if the result has
    /// no data.
    double (*score)(const claim_view *view, size_t point);
    /// Writes what was found at a point as a short line of at most `size` bytes.
    void (*at_point)(const claim_view *view, size_t point, char *text, size_t size);
    /// Writes what was found over a range; NULL: the number of points that agree is written.
    void (*over_range)(const claim_view *view, const claim_census *census, char *text, size_t size);
} claim_part;

/// Returns all parts; static, ended by an entry with a NULL name.
const claim_part *claim_parts(void);

/// Tolerance of a line's position, in orders.
static const double LINE_TOLERANCE = 0.02;

/// Returns the lines of a spectrum that count in a comparison: those of at least a twentieth of the largest.
numbers claim_lines(const claim_view *view, size_t point);

/// Contents of the claimed band.
typedef struct claim_band {
    double share; ///< part of the power of all lines below the running speed; NaN without lines
    size_t lines;
} claim_band;
claim_band claim_band_of(const claim_view *view, size_t point);

/// Share of the time in contact from which on contact counts as permanent.
static const double ALWAYS = 1.0 - 1e-9;

/// Functions that write what was found about a part as a line (claim_text.c).
void claim_regime_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_regime_over(const claim_view *view, const claim_census *census, char *text, size_t size);
void claim_curves_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_contact_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_contact_over(const claim_view *view, const claim_census *census, char *text, size_t size);
void claim_dry_whip_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_dry_whip_over(const claim_view *view, const claim_census *census, char *text, size_t size);
void claim_lines_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_band_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_largest_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_largest_over(const claim_view *view, const claim_census *census, char *text, size_t size);
void claim_whirl_at(const claim_view *view, size_t point, char *text, size_t size);
void claim_whirl_over(const claim_view *view, const claim_census *census, char *text, size_t size);

enum { MAX_FINDINGS = 12, FINDING_SIZE = 240 };

/// Verdict on a part of a claim, with its reason.
typedef struct claim_finding {
    whirl_agreement agreement;
    char text[FINDING_SIZE];
} claim_finding;

/// Comparison of a claim with a result: one finding for each part that the claim states, in the order of claim_parts().
typedef struct claim_outcome {
    whirl_agreement agreement;
    size_t count;
    claim_finding findings[MAX_FINDINGS];
    char note[FINDING_SIZE]; ///< place of the comparison if it is not the claimed one, or reason why there was no
                             ///< comparison; else ""
} claim_outcome;

/// Points to which a claim applies: a table and the range of its parameter.
typedef struct claim_selection {
    const whirl_table *table;
    double from, to;
    size_t count;
    double nearest; ///< value of the point used for a claim of one value
} claim_selection;

/// Returns the table with that role and parameter; NULL if there is none with a point.
const whirl_table *claim_table_over(const whirl_result *result, whirl_role role, const char *parameter);
claim_selection claim_select(const whirl_result *result, const char *parameter, const whirl_claim *claim);
bool claim_selected(const claim_selection *of, size_t point);
size_t claim_station(const whirl_result *result, const char *name); ///< SIZE_MAX if no station has the name

/// claim_of_branches: returns true if a claim states something about branches. claim_compare_branches: compares it with
/// the branches of a result and appends the findings.
bool claim_of_branches(const whirl_claim *claim);
void claim_compare_branches(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                            claim_outcome *outcome);

/// Returns true if a claim applies to this result, that is, if fixed parameters have the claimed values; else writes
/// why not.
bool claim_is_given(const whirl_claim *claim, const whirl_result *result, char *text, size_t size);

/// Writes where a claim fails and where it is met: over a range the values at which it fails, for a single value the
/// nearest value of the sweep at which it holds. At most `size` bytes.
void claim_whereabouts(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result, char *text,
                       size_t size);

void claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                   claim_outcome *outcome);

#endif
