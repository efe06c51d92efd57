// The parts that a claim may state, each compared on its own.
#ifndef REPORT_CLAIM_PARTS_H
#define REPORT_CLAIM_PARTS_H

#include <stdbool.h>
#include <stddef.h>

#include "quantities.h"
#include "report_parts.h"
#include "whirl/engine/claims.h"

/// A claim beside the table it is compared with.
typedef struct claim_view {
    const whirl_claim *claim;
    const whirl_result *result;
    const whirl_table *table;
    size_t station;
} claim_view;

/// Counts over the points of a range that are done.
typedef struct claim_census {
    size_t points, in_class[CLASS_COUNT], rubbing, rub_known, always, whipping, whip_known;
    double rub_low, rub_high;         ///< values of the parameter between which there is contact
    double largest_low, largest_high; ///< orders of the largest lines
    size_t largest_known;
    double backward_low, backward_high;
    size_t backward_known;
} claim_census;

void claim_census_add(claim_census *census, const claim_view *view, size_t point);

typedef struct claim_part {
    const char *name;
    bool (*stated)(const whirl_claim *claim);
    /// 1 where the point agrees, 0 where it does not, between where half of it does; NaN where the result cannot tell.
    double (*score)(const claim_view *view, size_t point);
    /// What is found at a point, in a short line. At most `size` bytes.
    void (*at_point)(const claim_view *view, size_t point, char *text, size_t size);
    /// What is found over a range; NULL: only at how many points it is as claimed.
    void (*over_range)(const claim_view *view, const claim_census *census, char *text, size_t size);
} claim_part;

/// All parts; static, ended by an entry whose name is NULL.
const claim_part *claim_parts(void);

/// A line is where the claim says it is within this many orders.
static const double LINE_TOLERANCE = 0.02;

/// The lines of the spectrum that count in a comparison: at least a twentieth of the largest.
numbers claim_lines(const claim_view *view, size_t point);

/// What lies in the claimed band.
typedef struct claim_band {
    double share; ///< of the power of the lines below the running speed; NaN without lines
    size_t lines;
} claim_band;
claim_band claim_band_of(const claim_view *view, size_t point);

/// A contact that lasts is there for this share of the time at least.
static const double ALWAYS = 1.0 - 1e-9;

/// The lines that parts write (claim_text.c).
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

/// A part of a claim beside what was found.
typedef struct claim_finding {
    whirl_agreement agreement;
    char text[FINDING_SIZE];
} claim_finding;

/// A claim beside a result: one finding for each part that it states, in the order of claim_parts().
typedef struct claim_outcome {
    whirl_agreement agreement;
    size_t count;
    claim_finding findings[MAX_FINDINGS];
    char note[FINDING_SIZE]; ///< where it was looked instead, or why nothing was compared; "" where neither applies
} claim_outcome;

/// The points that a claim speaks of: a table and the range of its parameter.
typedef struct claim_selection {
    const whirl_table *table;
    double from, to;
    size_t count;
    double nearest; ///< value of the point taken for a claim of one value
} claim_selection;

/// The table with that role whose parameter is the given one; NULL where there is none with a point.
const whirl_table *claim_table_over(const whirl_result *result, whirl_role role, const char *parameter);
claim_selection claim_select(const whirl_result *result, const char *parameter, const whirl_claim *claim);
bool claim_selected(const claim_selection *of, size_t point);
size_t claim_station(const whirl_result *result, const char *name); ///< SIZE_MAX where there is none of that name

/// Whether a claim says something of branches, and how that stands beside a result's: findings that are added.
bool claim_of_branches(const whirl_claim *claim);
void claim_compare_branches(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                            claim_outcome *outcome);

/// Whether a claim speaks of results with this one's value of the parameter that is given; else why not.
bool claim_is_given(const whirl_claim *claim, const whirl_result *result, char *text, size_t size);

/// Where a claim that is not met in full fails, and where it is met: over a range the values at which it does not hold,
/// for a single value the nearest of the sweep at which it does. At most `size` bytes.
void claim_whereabouts(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result, char *text,
                       size_t size);

void claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                   claim_outcome *outcome);

#endif
