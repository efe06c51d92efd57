/// Telling the attractors of one machine apart.
#ifndef STUDY_ATTRACTORS_H
#define STUDY_ATTRACTORS_H

#include "motion.h"

enum { MOST_ATTRACTORS = 64 };

/// Attractors in the order in which the points come to them, with a motion on each.
typedef struct told_apart {
    size_t done; ///< points that are done, without those from neighbours, which count nowhere here
    size_t count;
    whirl_attractor found[MOST_ATTRACTORS];
    motion *motions[MOST_ATTRACTORS];
} told_apart;

/// Tells those of `count` points (NULL: the first ones) apart. Writes the index of its attractor to of[point],
/// MOST_ATTRACTORS where it has none. WHIRL_NO_MEMORY. Freed by attractors_free, after a failure too.
whirl_status attractors_tell(const whirl_table *table, const size_t *points, size_t count, size_t *of,
                             told_apart *told);
void attractors_free(told_apart *told);

#endif
