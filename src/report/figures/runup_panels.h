/// Panels that several figures of run-ups share.
#ifndef REPORT_RUNUP_PANELS_H
#define REPORT_RUNUP_PANELS_H

#include "figure_kinds.h"

/// Largest number of runs in a figure.
enum { MAX_RUNS = 6 };

/// Names of the torques on a shaft: the columns of runup/torque.
enum { SHAFT_TORQUES = 5 };
extern const char *const shaft_torque_names[SHAFT_TORQUES];

/// Finds the runs to draw, the first finished ones; returns their number.
size_t runup_list_runs(const whirl_table *table, size_t runs[MAX_RUNS]);

/// Notes in the caption that a figure shows the first `shown` of several runs.
void runup_caption_runs(const drawing *of, const whirl_table *table, size_t shown, whirl_figure *figure);

/// Shows all values of a panel of lines, with space above them for its legend, which is within the panel.
void runup_show_below_legend(whirl_panel *panel);

/// Labels an axis with the speed or the time and its unit. Returns the size of the unit in SI.
double runup_label_over(const drawing *of, whirl_axis *axis, bool by_speed);

/// Writes the speed at some points of a line, at equal distances along the line. speeds: of the line's points, rad/s.
void runup_label_speeds(const drawing *of, whirl_figure *figure, whirl_panel *panel, const whirl_series *line,
                        const double *speeds);

/// Adds a panel with an orbit [samples][2] of the station within its walls, with a dot where the mark is at the x axis.
/// time, speed: of its turn, s and rad/s.
void runup_orbit_panel(const drawing *of, const figure_place *place, size_t run, const double *orbit, double time,
                       double speed, const char *what, whirl_figure *figure);

/// Fails if a name begins with the stem of figures whose field no table has. WHIRL_BAD_INPUT, with the option of
/// `runup` that makes the field.
whirl_status runup_find(const drawing *of, const char *name, const char *stem, const char *field, const char *option);

#endif
