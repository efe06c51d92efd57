/// Writes figures for gnuplot: a script and its data.
#ifndef REPORT_GNUPLOT_SCRIPT_H
#define REPORT_GNUPLOT_SCRIPT_H

#include "whirl/engine/figure.h"

#include <stddef.h>
#include <stdio.h>

/// Writes the numbers of a figure, one block for each series, in the order of panels and series.
void gnuplot_write_data(FILE *data, const whirl_figure *figure);

/// Writes the script that draws the numbers of the file `data` into NAME.FORMAT, for each word of `formats` ("png
/// pdf").
void gnuplot_write_script(FILE *script, const whirl_figure *figure, const char *name, const char *data,
                          const char *formats);

/// Converts a label to gnuplot's enhanced text: symbols in italics, special characters escaped. At most `size` bytes,
/// never cut within an escape.
void gnuplot_markup(const char *label, char *markup, size_t size);

#endif
