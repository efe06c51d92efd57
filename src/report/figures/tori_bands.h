/// Bands of tori in the figures of branches.
#ifndef REPORT_TORI_BANDS_H
#define REPORT_TORI_BANDS_H

#include "figure_kinds.h"
#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>

/// Returns the result's table of tori; NULL if there is none, or it has no torus.
const whirl_table *tori_table(const whirl_result *result);

/// Returns true if the torus of a point is stable.
bool tori_is_stable(const whirl_table *table, size_t point);

/// Adds the bands that a coordinate (column 0: x, 1: y) of a station's section covers, starting at the orbits where
/// tori begin. size: one shown unit of the parameter, in SI.
void tori_add_bands(whirl_figure *figure, whirl_panel *panel, const drawing *of, size_t station, size_t column,
                    double size);

/// Caption of the bands of tori.
extern const char tori_caption[];

#endif
