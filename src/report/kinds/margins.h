/// Critical speeds as peaks of a response to unbalance, and their margins.
#ifndef REPORT_MARGINS_H
#define REPORT_MARGINS_H

#include "whirl/engine/findings.h"
#include "whirl/engine/result.h"

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// Finds the running speeds, rad/s; a single speed is both. Returns false if none is given.
bool margin_running(const whirl_table *table, double *low, double *high);

/// Returns true if margins and clearances are required: the table gives running speeds.
bool margin_asked(const whirl_table *table);

/// Returns true if margins are required of a station's peaks: it is one of probes_at, or probes_at is not given.
bool margin_probed(const whirl_result *result, const whirl_table *table, size_t station);

/// Reason why peaks may have been missed: points along another parameter, or not over all running speeds; NULL if none.
const char *margin_lacks(const whirl_table *table);

/// A peak, and its required margin.
typedef struct margin_row {
    double probe;          ///< its angle, degrees
    double speed;          ///< rad/s
    double amplitude;      ///< m, zero to peak
    double amplification;  ///< factor
    char way[MARGIN_TEXT]; ///< "half power", ...; "half power, of 1.2 points: compute more there"
    bool judged, holds;    ///< margin required; margin met (holds)
    double had, asked;     ///< margins in %; NaN without running speeds or probe, or within these speeds
    const char *side;      ///< "above", "below" or "within" the running speeds; "" without these
    const char *verdict;   ///< "holds", "not judged: no probe", ...; "" without running speeds
} margin_row;

/// Gathers speed, amplitude in m and lag [points of the table] at probe 0 or 1 of a station. Returns their number, 0 if
/// speeds do not rise along the table.
size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags);

/// Finds the peaks at both probes of a station; none if speeds do not rise along the table, or there are too few
/// points.
size_t margin_rows(const whirl_result *result, const whirl_table *table, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]);

/// All peaks of a response with a required margin. `verdict` applies to the response: unknown if all known peaks have
/// their margin, but others may have been missed.
typedef struct margin_tally {
    whirl_judgement verdict;
    const char *lacks; ///< reason why peaks may have been missed (margin_lacks); NULL: none, or nothing is required
    size_t judged, held;
    size_t unjudged;  ///< peaks with amplification of 2.5 or more at stations outside probes_at
    margin_row worst; ///< peak with the largest deficit or, if none has one, the least surplus
    double more;      ///< surplus of that peak, %; minus infinity within the running speeds
    size_t station;   ///< station of that peak
} margin_tally;

margin_tally margin_count(const whirl_result *result, const whirl_table *table);

#endif
