// The parts that a claim may state, each compared at one point.
#ifndef REPORT_CLAIM_PARTS_H
#define REPORT_CLAIM_PARTS_H

#include <stdbool.h>
#include <stddef.h>

#include "regimes.h"
#include "whirl/claims.h"

/// A claim beside the table it is compared with.
typedef struct claim_view {
    const whirl_claim *claim;
    const whirl_result *result;
    const whirl_table *table;
    size_t station;
} claim_view;

typedef struct claim_part {
    const char *name;
    bool (*stated)(const whirl_claim *claim);
    /// 1 where the point agrees, 0 where it does not, between where half of it does; NaN where the result cannot tell.
    double (*score)(const claim_view *view, size_t point);
} claim_part;

/// All parts; static, ended by an entry whose name is NULL.
const claim_part *claim_parts(void);

/// Share of the power of the lines below the running speed that lies in the claimed band; NaN without lines.
double claim_band_share(const claim_view *view, size_t point);

/// What is found at a point: "quasi-periodic (1 curve); lines 0.412, 1, 0.588; no rub". At most `size` bytes.
void claim_point_text(const claim_view *view, size_t point, char *text, size_t size);

/// Counts over the points of a range.
typedef struct claim_census {
    size_t points, in_class[CLASS_COUNT], rubbing, rub_known;
    double rub_low, rub_high; ///< values of the parameter between which there is contact
    double backward_low, backward_high;
    size_t backward_known;
} claim_census;

void claim_census_add(claim_census *census, const claim_view *view, size_t point);

/// "P-1 96.6 %, quasi-periodic 3.4 % of 297 points", and contact or sense of whirl where the claim speaks of them.
void claim_census_text(const claim_census *census, const whirl_claim *claim, char *text, size_t size);

#endif
