/// Closed curves on which the points of a section lie.
#ifndef ANALYZE_CURVES_H
#define ANALYZE_CURVES_H

#include "section.h"

/// Closed curves on which the points lie and which they visit in turn.
typedef struct closed_curves {
    int count; ///< 0 without such curves
    /// Median of the revolutions between the visits of neighbours on a curve. A motion that settles on a lock of period
    /// q never passes the start of another of its q branches, so that neighbours are a return apart: q.
    int neighbours;
} closed_curves;

/// Finds the curves from the last 2000 points. None also without memory.
closed_curves curves_find(const section *all);

#endif
