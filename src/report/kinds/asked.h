/// Judgements by acceptance criteria after API 617: requirements, values found and verdicts, for all renderers. The
/// user has to check which edition applies.
#ifndef REPORT_ASKED_H
#define REPORT_ASKED_H

#include "findings_build.h"
#include "whirl/engine/result.h"

enum { ASKED_TEXT = 320 };

/// The required logarithmic decrement.
extern const double asked_decrement;

/// Stability at a point. Numbers that were not found are NaN.
typedef struct asked_stability {
    bool stages;               ///< cross coupling is anticipated, so that there is a Level I
    double anticipated, limit; ///< cross coupling, N/m; limit NaN: above 1000 times the anticipated
    double ratio, factor;      ///< limit over anticipated, and its required value: 10 in region B, else 2
    double region;             ///< region of the screening diagram: 0: A, 1: B
    double decrement;          ///< least decrement with bearings and stages
    double complete;           ///< least decrement with seals and impellers too
    whirl_judgement level_one; ///< for bearings and stages; WHIRL_NOT_ASKED without stages
    bool decides;              ///< Level I does not hold, so that seals and impellers must be included (Level II)
    whirl_judgement level_two; ///< for the machine with seals and impellers, the final judgement at the point
} asked_stability;

asked_stability asked_stability_at(const whirl_table *table, size_t point);

/// Writes "decrement above 0.1 and limit above 2 times the anticipated: holds by Level I".
void asked_stability_text(const asked_stability *at, char text[ASKED_TEXT]);

/// Stability at all points of a table.
typedef struct asked_stability_tally {
    size_t points, without; ///< number of computed points, and of those whose modes are all backward
    size_t screened, dense; ///< points in the screening diagram, and in its region B
    asked_stability
        least; ///< point with the least decrement with seals and impellers; its decrement is NaN if no point has one
    asked_stability coupled; ///< worst point by Level I, of those with stages
    double decrement;        ///< least decrement with bearings and stages, of points with stages
    whirl_judgement level_one, level_two;
} asked_stability_tally;

asked_stability_tally asked_stability_count(const whirl_table *table);

/// Judges a response with running speeds: margins, vibration, clearances.
void ask_response(const finder *of);

/// Judges the stability at all points of a table.
void ask_stability(const finder *of);

#endif
