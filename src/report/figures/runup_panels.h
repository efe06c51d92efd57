/// Panels that several figures of run-ups share.
#ifndef REPORT_RUNUP_PANELS_H
#define REPORT_RUNUP_PANELS_H

#include "figure_kinds.h"

/// Most runs in a figure.
enum { MAX_RUNS = 6 };

/// Fills in the runs that are drawn, the first ones that were done; returns how many.
size_t runup_list_runs(const whirl_table *table, size_t runs[MAX_RUNS]);

/// Notes in the caption that a figure shows the first `shown` of several runs.
void runup_caption_runs(const drawing *of, const whirl_table *table, size_t shown, whirl_figure *figure);

/// Labels the horizontal axis of a panel, or the vertical one (upright), with speed or time and its unit. Returns the
/// size of the unit.
double runup_label_over(const drawing *of, whirl_axis *axis, bool by_speed);

/// Marks some places of a line with the speed in its unit, as far apart on the line as one another; speeds [of the
/// line's points] in rad/s.
void runup_label_speeds(const drawing *of, whirl_figure *figure, whirl_panel *panel, const whirl_series *line,
                        const double *speeds);

/// Returns WHIRL_BAD_INPUT if a name begins with the stem of figures of a field that no table has, with the option of
/// `runup` that gives it.
whirl_status runup_find(const drawing *of, const char *name, const char *stem, const char *field, const char *option);

#endif
