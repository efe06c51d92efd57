/// Critical speeds as peaks of responses to unbalance, and their separation margins.
#ifndef REPORT_MARGINS_H
#define REPORT_MARGINS_H

#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// Finds the lowest and the highest running speed, rad/s; both are equal if one speed is given. Returns false if none
/// is given.
bool margin_running(const whirl_table *table, double *low, double *high);

/// Returns true if margins and clearances are required: the table gives running speeds.
bool margin_asked(const whirl_table *table);

/// Returns true if margins are required for peaks at a station: it is one of probes_at, or probes_at is not given.
bool margin_probed(const whirl_result *result, const whirl_table *table, size_t station);

/// Returns why peaks may have been missed: points are along another parameter, or do not cover all running speeds.
/// NULL: none can have been missed.
const char *margin_lacks(const whirl_table *table);

/// A peak, and its required margin.
typedef struct margin_row {
    double probe;          ///< angle of the probe, degrees
    double speed;          ///< rad/s
    double amplitude;      ///< m, zero to peak
    double amplification;  ///< amplification factor
    char way[MARGIN_TEXT]; ///< method by which the factor was found: "half power", ...; "half power, of 1.2 points:
                           ///< compute more there"
    bool judged, holds;    ///< judged: a margin is required; holds: the peak has that margin
    double had,
        asked; ///< margin found and required margin, %; NaN without running speeds or probe, or within these speeds
    const char *side;    ///< "above", "below" or "within" the running speeds; "" without these
    const char *verdict; ///< "holds", "not judged: no probe", ...; "" without running speeds
} margin_row;

/// Gathers speed, amplitude in m and lag [points of the table] at probe 0 or 1 of a station. Returns their number, 0 if
/// speeds do not rise along the table.
size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags);

/// Finds the peaks at both probes of a station; none if speeds do not rise along the table, or there are too few
/// points.
size_t margin_rows(const whirl_result *result, const whirl_table *table, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]);

/// Judgement of all peaks of a response with a required margin. verdict: not known if all known peaks have their margin
/// but others may have been missed.
typedef struct margin_tally {
    whirl_judgement verdict;
    const char *lacks;   ///< reason why peaks may have been missed (margin_lacks); NULL: none, or nothing is required
    size_t judged, held; ///< numbers of judged peaks, and of those that have their margin
    size_t unjudged;     ///< number of peaks with an amplification of 2.5 or more at stations without a probe
    margin_row worst;    ///< peak with the largest deficit or, if none has one, the least surplus
    double more;         ///< surplus of that peak, %; minus infinity within the running speeds
    size_t station;      ///< station of that peak
} margin_tally;

margin_tally margin_count(const whirl_result *result, const whirl_table *table);

#endif
