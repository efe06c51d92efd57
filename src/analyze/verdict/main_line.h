/// The largest line of a record that is no multiple of the speed.
#ifndef ANALYZE_MAIN_LINE_H
#define ANALYZE_MAIN_LINE_H

#include <stdbool.h>

#include "whirl/engine/analyze.h"

/// The largest line of the record off whole orders, at the station where it is the largest part of the motion.
typedef struct main_line {
    double order; ///< NaN without one
    double share; ///< amplitude over half the diagonal of the station's box
    double trend; ///< rate of its amplitude per revolution, from two halves of the record; NaN unless in both
    double drift; ///< change of its order in the second half
    bool two; ///< all significant lines are combinations of this frequency and the shaft's, and the lines are the whole
              ///< motion
} main_line;

main_line main_line_find(const whirl_record *record);

/// Returns true if the line belongs to a motion of two frequencies that neither grows nor decays.
bool main_line_stays(const main_line *line, const whirl_record *record);

#endif
