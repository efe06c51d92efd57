/// Lines of a few frequencies fitted to a record by least squares.
#ifndef ANALYZE_LINE_FIT_H
#define ANALYZE_LINE_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"
#include "whirl/internal/spectrum.h"

/// One or two frequencies of a motion besides the shaft's.
typedef struct line_bases {
    size_t count;
    double orders[2];
} line_bases;

/// A line as a combination of these frequencies: times[0] orders[0] + times[1] orders[1] + whole.
typedef struct line_combination {
    bool matches; ///< false: the line is no such combination
    int times[2];
    double whole;
} line_combination;

/// Finds the combination whose order is nearest to an order, within a fifth of a bin of the width `resolution`. One
/// frequency has multiples up to the eighth; with two frequencies the moduli of both multiples sum to at most 4.
line_combination line_combination_of(const line_bases *bases, double order, double resolution);

/// Lines of a record, and what they leave unexplained.
typedef struct line_fit {
    bool found;         ///< false: the record is too short to distinguish its lines
    line_bases bases;   ///< frequencies, refined
    double wander[2];   ///< change of the frequencies per revolution
    double trend[2];    ///< growth rates of the amplitudes of the lines at these frequencies, per revolution
    double unexplained; ///< share of the mean square about the mean that is in no line
} line_fit;

/// Fits lines to the samples of a station: those of a spectrum, and low combinations of the bases that are not too
/// close to these. Combinations move with the bases, which are refined; other lines stay.
line_fit line_fit_record(const whirl_record *record, size_t station, const whirl_spectrum *spectrum,
                         const line_bases *bases);

#endif
