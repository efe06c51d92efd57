/// Regularity of a motion: agreement of weighted averages over two halves of its section.
#ifndef ANALYZE_BIRKHOFF_H
#define ANALYZE_BIRKHOFF_H

#include "section.h"

/// Agreement of weighted averages over the two halves of the section.
typedef struct regularity {
    double digits; ///< decimal digits to which the averages agree, at most 16
    double spread; ///< size of the second half over that of the first
} regularity;

/// Compares the halves. `size` is that of the motion; coordinates that move by less than 1e-9 of it count as constant.
regularity regularity_find(const section *all, double size);

#endif
