/// Tori in the figures of branches.
#ifndef REPORT_TORI_H
#define REPORT_TORI_H

#include "figure_kinds.h"

/// The table of tori of the result, NULL where it has none or all are without one.
const whirl_table *tori_table(const whirl_result *result);

/// Adds the bands in which a coordinate (0: x, 1: y) of the sections of a station lies, from the orbits at which they
/// begin; `size` is one unit of the parameter.
void tori_add_bands(whirl_figure *figure, whirl_panel *panel, const drawing *of, size_t station, size_t column,
                    double size);

/// What a caption says of them.
extern const char tori_caption[];

#endif
