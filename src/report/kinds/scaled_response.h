/// Responses to unbalance, scaled to the vibration limit, compared with clearances (after API 617; the user has to
/// check which edition applies).
#ifndef REPORT_SCALED_RESPONSE_H
#define REPORT_SCALED_RESPONSE_H

#include "whirl/engine/result.h"

/// The scale of a table's responses; lengths are in m, peak to peak.
typedef struct response_scale {
    double limit;   ///< vibration limit, min(25.4, 25.4 sqrt(12000/N)) um, N rpm the highest running speed
    double largest; ///< largest response at any probe between the running speeds
    size_t station; ///< station of the largest response
    double factor;  ///< limit over largest response, at most 6
    bool beyond;    ///< the largest response exceeds the limit: the factor is below 1
    double trip;    ///< rad/s, highest speed at which clearances are checked; 0: not given, all speeds
    bool reaches;   ///< points reach beyond the trip speed
} response_scale;

/// Scaled response of a station compared with its clearance.
typedef struct scaled_response {
    size_t station;
    double axis;      ///< m, the largest scaled major axis at any point, peak to peak
    double speed;     ///< rad/s, at that axis
    double clearance; ///< m, diametral clearance there
    bool holds;       ///< the axis is at most 75 % of the clearance
} scaled_response;

/// Returns true for stations that are checked: all stations if probes_at is not given, else those with probes, a
/// clearance or an unbalance by rule.
bool scaled_response_checks(const whirl_result *result, const whirl_table *table, size_t station);

/// The reason why scaled_response_scale fails for a table with running speeds.
extern const char *const scaled_response_lacks;

/// Finds the scale of a table's responses. Returns false if the table gives no running speeds, or its points do not
/// cover them.
bool scaled_response_scale(const whirl_result *result, const whirl_table *table, response_scale *out);

/// Writes rows [station count] for all stations with a clearance; returns their number.
size_t scaled_response_all(const whirl_result *result, const whirl_table *table, const response_scale *by,
                           scaled_response *rows);

/// Finds the first of the rows with the largest share of its clearance. Returns false if there is none.
bool scaled_response_tightest(const whirl_result *result, const whirl_table *table, const response_scale *by,
                              scaled_response *row);

#endif
