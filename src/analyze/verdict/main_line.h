/// The largest lines of a record that are no multiples of the speed.
#ifndef ANALYZE_MAIN_LINE_H
#define ANALYZE_MAIN_LINE_H

#include <stdbool.h>

#include "whirl/engine/analyze.h"

/// The main line: the largest line of the record away from whole orders, at the station where it is the largest part of
/// the motion. The second line is the largest one there that is no combination of the main line and whole orders.
typedef struct main_line {
    double order; ///< NaN without one
    double share; ///< amplitude over half the diagonal of the station's box
    double trend; ///< rate of its amplitude per revolution; NaN if its neighbours hide it
    double drift; ///< change of its order from half to half of the record; NaN as for `trend`
    double second, second_share, second_trend, second_drift; ///< the same for the second line; NaN without one
    /// Number of independent frequencies, the shaft's included: 2 or 3 if all significant lines are combinations of so
    /// many frequencies and make up the whole motion; else 0.
    int frequencies;
} main_line;

/// Finds the lines of a record. All numbers are NaN without a waveform, for fewer than 32 recorded revolutions, and
/// without memory.
main_line main_line_find(const whirl_record *record);

/// Returns true if the lines belong to a motion of two or three frequencies that neither grows nor decays.
bool main_line_stays(const main_line *line, const whirl_record *record);

#endif
