/// Points of a Poincare section, oldest first, and the properties that verdicts use.
#ifndef ANALYZE_SECTION_H
#define ANALYZE_SECTION_H

#include <stddef.h>

#include "whirl/engine/analyze.h"

typedef struct section {
    size_t count, dimension;
    const double *points; ///< [count][dimension]
} section;

/// Returns the last `count` points.
section section_tail(const section *all, size_t count);

/// Returns the Euclidean distance of points a and b.
double section_distance(const section *all, size_t a, size_t b);

/// Returns the size against which distances are judged: half the diagonal of the motion's bounds over the record. It is
/// at least 1e-6 of the largest coordinate and 1e-12, so that an equilibrium counts as returning although rounding
/// moves it.
double motion_size(const whirl_record *record);

/// Returns the largest distance, over the size of the motion, that may be accumulated rounding.
double motion_rounding(const whirl_record *record);

#endif
