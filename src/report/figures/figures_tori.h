// Tori in the figures of branches, and figures of their own.
#ifndef REPORT_FIGURES_TORI_H
#define REPORT_FIGURES_TORI_H

#include "figures.h"

/// The table of tori of the result, NULL where it has none or all are without one.
const whirl_table *tori_table(const whirl_result *result);

/// Writes the bands in which the sections of a station lie, from the orbits at which they begin.
whirl_status tori_write_bands(const drawing *to, size_t station, const char *name);

/// The part of gnuplot's `plot` that fills them, a comma after it: `column` is 2 for x, 4 for y of the file `bands`.
void tori_plot_bands(FILE *script, int column, bool keyed);

/// What a caption says of them.
extern const char tori_caption[];

#endif
