/// What verdicts are judged from.
#ifndef ANALYZE_EVIDENCE_H
#define ANALYZE_EVIDENCE_H

#include <stdbool.h>

#include "section.h"

typedef struct evidence {
    section points;
    double size;         ///< of the motion
    double rounding;     ///< distances over the size that say nothing
    size_t growth_count; ///< after the first tenth, in which the perturbation turns
    const double *growth;
    recurrence returns;
    regularity averages;
    whirl_estimate exponent;
    whirl_estimate second; ///< sharp, of regular motions; NaN where not all perturbations were followed
    bool forced;           ///< by a phase that fits no revolution: then a stable motion does not return
    bool exponents_failed; ///< then there is no growth that says anything
} evidence;

/// All that costs little.
evidence evidence_gather(const whirl_record *record);

/// The evidence of the later half of the watched revolutions, for a motion that took long to come to its attractor.
evidence evidence_later_half(const evidence *all);

/// Rate at which returns grow, natural logarithm per revolution, below 0 while the motion settles: from those in the
/// first and in the last quarter of the watched revolutions, which are three quarters apart.
double settling_rate(const evidence *e);

#endif
