/// Making figures: panels and series that grow. What lacks memory is noted in the figure, and told in the end.
#ifndef REPORT_FIGURE_BUILD_H
#define REPORT_FIGURE_BUILD_H

#include "whirl/engine/figure.h"

/// A range of numbers.
typedef struct span {
    double low, high;
} span;

/// The empty one, to be widened; values that are not finite are left out.
span span_empty(void);
void span_widen(span *range, double value);

/// With a margin of its width on both sides, and at least `least` wide.
span span_with_margin(span range, double margin, double least);

/// Ready to be drawn: whether it holds anything.
bool span_has_any(span range);

/// A panel below those before, or beside them: `width` of the figure's width, `height` cm. NULL without memory.
whirl_panel *figure_panel(whirl_figure *figure, const char *name, double width, double height);

/// A series over those before; the panel may be NULL. NULL without memory.
whirl_series *panel_series(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *colour,
                           double size);

/// The same with a name in the legend.
whirl_series *panel_named(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *name,
                          const char *colour, double size);

/// Add a point to a series, which may be NULL. A break ends a line.
void series_add(whirl_figure *figure, whirl_series *series, double x, double y);
void series_break(whirl_figure *figure, whirl_series *series);
void series_add_to(whirl_figure *figure, whirl_series *series, double x, double y, double y_to); ///< areas and bars
void series_add_box(whirl_figure *figure, whirl_series *series, span x, span y);
void series_add_text(whirl_figure *figure, whirl_series *series, double x, double y, const char *text);
void series_value(whirl_figure *figure, whirl_series *series, double value); ///< of the box added last

/// A tick with a text of its own.
void axis_tick(whirl_figure *figure, whirl_axis *axis, double at, const char *text);

/// What an axis shows; a logarithmic one only where all of it is above 0.
void axis_show(whirl_axis *axis, span range);

/// A line from edge to edge of a panel at a height, or at a place; the axes are shown.
whirl_series *panel_level(whirl_figure *figure, whirl_panel *panel, double y, const char *colour, double width);
whirl_series *panel_upright(whirl_figure *figure, whirl_panel *panel, double x, const char *colour, double width);

/// Leaves the panels of these names ("x,exponent") alone. WHIRL_BAD_INPUT for a name that there is none of.
whirl_status figure_choose(whirl_figure *figure, const char *names);

/// Gives axes that show nothing yet the range of their series, makes those logarithmic that `log` names (NULL: none),
/// and places the panels: from the top, as many in a row as there is room for.
void figure_finish(whirl_figure *figure, const char *log);

/// Rows that the legend above the figure has.
size_t figure_legend_rows(const whirl_figure *figure);

/// The distance of ticks (1, 2 or 5 times a power of ten) that gives at most `most` of them in a range.
double tick_step(double width, int most);

/// Fills in ticks, at most so many, where an axis has none.
void axis_fill_ticks(whirl_figure *figure, whirl_axis *axis, int most);

/// cm that the numbers at the vertical axes take, in all panels alike: labels stand in one line.
double figure_number_width(const whirl_figure *figure);

/// Beside panels lower than this (cm) labels of vertical axes do not stand.
#define FIGURE_LOW_PANEL 0.7

/// cm of text of so many letters.
double figure_text_width(const whirl_figure *figure, size_t letters);

#endif
