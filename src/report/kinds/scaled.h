/// Responses to unbalance scaled to the vibration limit, and what they take of clearances (after API 617: which edition
/// counts is for the user to check).
#ifndef REPORT_SCALED_H
#define REPORT_SCALED_H

#include "whirl/engine/shown.h"

/// The scale of a table's responses: lengths in m peak to peak.
typedef struct scaled {
    double limit;   ///< of vibration, min(25.4, 25.4 sqrt(12000/N)) um, N rpm the highest running speed
    double largest; ///< that any of the probes sees between the running speeds
    size_t station; ///< at which
    double factor;  ///< limit over largest, 6 at most
    bool beyond;    ///< the largest is beyond the limit: the factor is below 1
    double trip;    ///< rad/s, up to which clearances are looked at; 0: not said, at all speeds
    bool reaches;   ///< points reach over the trip speed
} scaled;

/// What the response takes of a station's clearance.
typedef struct scaled_row {
    size_t station;
    double axis;      ///< m, the largest scaled major axis at any point, peak to peak
    double speed;     ///< rad/s, where
    double clearance; ///< m, the diametral one there
    bool holds;       ///< the axis is at most 75 % of it
} scaled_row;

/// The unit of these lengths: the one that is asked for, else um, in which the limit is told.
whirl_unit scaled_unit(const whirl_shown_units *units);

/// Whether a station is one that engineers look at: with probes, where these are said (probes_at), a clearance or an
/// unbalance by rule; all where probes are not said.
bool scaled_watches(const whirl_result *result, const whirl_table *table, size_t station);

/// Whether a table tells running speeds, and what it lacks where scaled_of fails then.
bool scaled_asked(const whirl_table *table);
extern const char *const scaled_lacks;

/// False where the table does not tell running speeds, or its points do not reach over them.
bool scaled_of(const whirl_result *result, const whirl_table *table, scaled *out);

/// What follows a sentence that tells the factor: that the limit is passed, and up to which speed clearances count.
enum { SCALED_TEXT = 200 };
void scaled_told(const whirl_shown_units *units, const scaled *by, char text[SCALED_TEXT]);

/// Rows [station count] of all stations with a clearance; how many.
size_t scaled_rows(const whirl_result *result, const whirl_table *table, const scaled *by, scaled_row *rows);

#endif
