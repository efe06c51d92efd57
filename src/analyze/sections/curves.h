/// Closed curves on which the points of a section lie.
#ifndef ANALYZE_CURVES_H
#define ANALYZE_CURVES_H

#include "section.h"

/// Closed curves on which the points lie and which they visit in turn.
typedef struct closed_curves {
    int count; ///< 0 without such curves
    /// Median of the revolutions between the visits of neighbours on a curve. It is q for a motion that settles on an
    /// orbit of q revolutions: its section has q branches, one toward each point of the orbit, and neighbours on a
    /// branch are q revolutions apart.
    int neighbours;
} closed_curves;

/// Finds the curves from the last 2000 points. None also without memory.
closed_curves curves_find(const section *all);

#endif
