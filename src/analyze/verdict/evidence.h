/// Evidence for verdicts.
#ifndef ANALYZE_EVIDENCE_H
#define ANALYZE_EVIDENCE_H

#include <stdbool.h>
#include <stddef.h>

#include "birkhoff.h"
#include "recurrence.h"
#include "section.h"

/// Evidence of a record that is inexpensive to gather.
typedef struct evidence {
    section points;
    double size;         ///< size of the motion
    double rounding;     ///< distances over the size that are insignificant
    size_t growth_count; ///< number of growths after the first tenth, in which the perturbation aligns
    const double *growth;
    recurrence returns;
    regularity averages;
    whirl_estimate exponent;
    whirl_estimate second; ///< sharp, for regular motions; NaN unless all perturbations were followed
    bool forced;           ///< the phase that drives the motion does not repeat after whole revolutions: even a stable
                           ///< motion does not return then
    bool exponents_failed; ///< the growth is invalid
} evidence;

/// Gathers the inexpensive evidence.
evidence evidence_gather(const whirl_record *record);

/// Returns the evidence of the later half of the recorded revolutions, for a motion that settled late.
evidence evidence_later_half(const evidence *all);

/// Returns the growth rate of returns, natural logarithm per revolution; negative while the motion settles. Compares
/// the returns in the first quarter of the recorded revolutions with those in the last quarter, three quarters later.
double settling_rate(const evidence *e);

#endif
