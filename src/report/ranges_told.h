/// What is told of points beyond the range of a law.
#ifndef REPORT_RANGES_TOLD_H
#define REPORT_RANGES_TOLD_H

#include "whirl/engine/shown.h"

enum { RANGES_TOLD_SIZE = 1024 };

/// Of range `index` of a table: "film at journal: eccentricity ratio up to 0.95, to which its coefficients were found;
/// reached 0.97 (37 of 256 points, first at 6400 rpm)"; false where no point has left it.
bool ranges_told(const whirl_shown_units *units, const whirl_table *table, size_t index, char text[RANGES_TOLD_SIZE]);

#endif
