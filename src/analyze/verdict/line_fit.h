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
    bool matches; ///< false: the line is none
    int times[2];
    double whole;
} line_combination;

/// Finds the combination that an order is, within a fifth of a bin of the width `resolution`: of one frequency up to
/// its eighth multiple, of two up to four of both together.
line_combination line_combination_of(const line_bases *bases, double order, double resolution);

/// Lines of a record, and what they leave unexplained.
typedef struct line_fit {
    bool found;         ///< false: the record is too short to tell its lines apart
    line_bases bases;   ///< frequencies, refined
    double wander[2];   ///< their change per revolution
    double trend[2];    ///< growth rates of the amplitudes of the lines at these, per revolution
    double unexplained; ///< share of the mean square about the mean that no line has
} line_fit;

/// Fits lines to the samples of a station: those of a spectrum, and low combinations of the bases that are not hidden
/// among these. Combinations move with the bases, which are refined; other lines stay.
line_fit line_fit_record(const whirl_record *record, size_t station, const whirl_spectrum *spectrum,
                         const line_bases *bases);

#endif
