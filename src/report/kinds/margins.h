/// Critical speeds as peaks of a response to unbalance, and their margins.
#ifndef REPORT_MARGINS_H
#define REPORT_MARGINS_H

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// The logarithmic decrement that is asked for (API 617; which edition counts is for the user to check).
extern const double margin_decrement;

/// By how much the limit of the cross coupling of stages shall exceed the anticipated one at a point, 10 times in
/// region B of the screening diagram, else 2; and whether it does and the decrement with stages is large enough, so
/// that bearings and stages tell enough (Level I).
double margin_coupling(const whirl_table *table, size_t point);
bool margin_level_one(const whirl_table *table, size_t point);

/// A peak as it is told.
typedef struct margin_row {
    double probe;           ///< its angle, degrees
    double speed;           ///< in margin_speed_unit
    double amplitude;       ///< in the unit of lengths and the kind of amplitude that are shown
    double amplification;   ///< factor
    char way[MARGIN_TEXT];  ///< "half power", ...; "half power, of 1.2 points: compute more there"
    bool told, holds;       ///< whether a margin is asked for, and had
    bool above;             ///< the peak lies above the running speeds
    double had, asked;      ///< margins in %; NaN where running speeds are not said, or the peak is within them
    char text[MARGIN_TEXT]; ///< "margin 31.2 % above, 24.5 % asked for: holds"; "" where running speeds are not said
} margin_row;

/// The unit of speeds of the shaft: the one that is shown, else rpm.
whirl_unit margin_speed_unit(const whirl_shown_units *units);

/// Speed, amplitude in m and lag [points of the table] that probe 0 or 1 of a station sees; how many, 0 where speeds do
/// not rise along the table.
size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags);

/// The peaks that both probes of a station see; none where speeds do not rise along the table, or too few points are
/// there.
size_t margin_rows(const whirl_result *result, const whirl_table *table, const whirl_shown_units *units, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]);

#endif
