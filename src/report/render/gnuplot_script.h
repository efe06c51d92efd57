/// Figures as gnuplot draws them: a script with its data beside it.
#ifndef REPORT_GNUPLOT_SCRIPT_H
#define REPORT_GNUPLOT_SCRIPT_H

#include <stdio.h>

#include "whirl/engine/figure.h"

/// Writes the numbers of a figure, a block a series in the order of panels and series.
void gnuplot_write_data(FILE *data, const whirl_figure *figure);

/// Writes the script that draws them from the file `data` into NAME.FORMAT for each word of `formats` ("png pdf").
void gnuplot_write_script(FILE *script, const whirl_figure *figure, const char *name, const char *data,
                          const char *formats);

/// A label in gnuplot's enhanced text: symbols in italics, and no letter that means anything to it. At most `size`
/// bytes, never cut within an escape.
void gnuplot_markup(const char *label, char *markup, size_t size);

#endif
