/// Deflection of shafts between stations, computed again by the machine of a point.
#ifndef REPORT_SHAFT_BENDS_H
#define REPORT_SHAFT_BENDS_H

#include "figure_kinds.h"
#include "machine_along.h"
#include "whirl/engine/result.h"
#include "whirl/internal/line.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct shaft_bends shaft_bends;

/// bends_new: builds the machine at a point of a study at rest, with its shaft lines; NULL if it cannot be built or has
/// no shafts of finite elements. Free with bends_free.
shaft_bends *bends_new(const drawing *of, const whirl_table *table, size_t point);
void bends_free(shaft_bends *bends);

/// Return the shaft line, and the length scale of the machine in m.
const whirl_shaft_line *bends_line(const shaft_bends *bends);
double bends_length(const shaft_bends *bends);

/// Write moved [places][4], the displacements of the shaft line as x_cos, x_sin, y_cos, y_sin: for a mode scaled as
/// `modes/shape`, for the unbalance response as lengths. Return false if the shape differs from the result's stations
/// by more than 1e-6 of its largest value.
bool bends_mode(shaft_bends *bends, size_t mode, double *moved);
bool bends_response(shaft_bends *bends, double *moved);

/// Adds a column of moved [places][columns] to a series, shaft by shaft.
void bends_draw(whirl_figure *figure, whirl_series *to, const shaft_bends *bends, const machine_along *along,
                const double *moved, size_t columns, size_t column);

/// A curve over a machine: a column of `moved`. Columns 0 and 1 are along x, 2 and 3 along y; even ones are drawn with
/// full lines, odd ones dashed.
typedef struct along_curve {
    const drawing *of;
    const machine_along *along;
    const shaft_bends *bends; ///< NULL: lines go from station to station
    const double *moved;      ///< [places][columns] in units of the panel
    size_t columns, column;
} along_curve;

/// Draws the curve, with marks at stations. values [stations]: the same column at the stations; NaN: no mark.
void along_shape(whirl_figure *figure, whirl_panel *panel, const along_curve *of, const double *values);

#endif
