/// Functions that build a figure of panels and series. Without memory they mark the figure as failed.
#ifndef REPORT_FIGURE_BUILD_H
#define REPORT_FIGURE_BUILD_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/figure.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/// A range of numbers.
typedef struct span {
    double low, high;
} span;

/// span_empty: the empty span. span_widen: includes a value; values that are not finite are ignored.
span span_empty(void);
void span_widen(span *range, double value);

/// Returns a span widened by a margin (a share of its width) on both sides, and at least `least` wide.
span span_with_margin(span range, double margin, double least);

/// Returns a span of a panel that is extended upwards by the height of a legend within the panel.
span span_below_legend(span range);

/// Returns true if a span has any value.
bool span_has_any(span range);

/// Adds a panel of `width` (share of the figure's width) and `height` cm, next to the previous one or below it. NULL
/// without memory.
whirl_panel *figure_panel(whirl_figure *figure, const char *name, double width, double height);

/// Adds a series above the previous ones; `panel` may be NULL. NULL without memory.
whirl_series *panel_series(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *colour,
                           double size);

/// Like panel_series, with a name in the legend.
whirl_series *panel_named(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *name,
                          const char *colour, double size);

/// Add an item to a series, which may be NULL. A break ends a line.
void series_add(whirl_figure *figure, whirl_series *series, double x, double y);
void series_break(whirl_figure *figure, whirl_series *series);
void series_add_to(whirl_figure *figure, whirl_series *series, double x, double y, double y_to); ///< areas and bars
void series_add_box(whirl_figure *figure, whirl_series *series, span x, span y);
void series_add_text(whirl_figure *figure, whirl_series *series, double x, double y, const char *text);
void series_value(whirl_figure *figure, whirl_series *series, double value); ///< value of the last box

/// Adds a hot spot: the box of a panel that shows a station, which the explorer makes a button for that station.
void panel_spot(whirl_figure *figure, whirl_panel *panel, const char *station, span x, span y);

/// Adds a tick with a given text.
void axis_tick(whirl_figure *figure, whirl_axis *axis, double at, const char *text);

/// Sets the range of an axis; a logarithmic axis needs a positive one. If the range is not finite, figure_finish sets
/// that of the finite numbers of the series.
void axis_show(whirl_axis *axis, span range);

/// Add a line from edge to edge of a panel: horizontal at y, or upright at x. The axes must have their ranges.
whirl_series *panel_level(whirl_figure *figure, whirl_panel *panel, double y, const char *colour, double width);
whirl_series *panel_upright(whirl_figure *figure, whirl_panel *panel, double x, const char *colour, double width);

/// Adds the series of another figure with the same panels, dashed; must be called before figure_finish. `own` and `its`
/// name both figures in the legend. WHIRL_BAD_INPUT if axes have different units, or if colours show numbers;
/// WHIRL_NO_MEMORY.
whirl_status figure_overlay(whirl_figure *figure, const whirl_figure *other, const char *own, const char *its);

/// Keeps only the named panels ("x,exponent"). WHIRL_BAD_INPUT for an unknown name.
whirl_status figure_choose(whirl_figure *figure, const char *names);

/// Finishes a figure: gives axes without a range the range of their series, makes the axes named by `log` ("x", "y",
/// "xy", NULL) logarithmic, and places the panels from the top, as many in a row as fit.
void figure_finish(whirl_figure *figure, const char *log);

/// Returns the number of rows of the legend above the figure.
size_t figure_legend_rows(const whirl_figure *figure);

/// Returns a distance of ticks, 1, 2 or 5 times a power of ten, with at most `most` ticks in a range of this width.
double tick_step(double width, int most);

/// Adds at most `most` ticks to an axis without ticks.
void axis_fill_ticks(whirl_figure *figure, whirl_axis *axis, int most);

/// Returns the width in cm that the numbers at vertical axes take; it is the same for all panels, so that labels line
/// up.
double figure_number_width(const whirl_figure *figure);

/// Least height of a panel with a vertical label (cm).
#define FIGURE_LOW_PANEL 0.7

/// Returns the width in cm of a text with `letters` letters.
double figure_text_width(const whirl_figure *figure, size_t letters);

/// Returns the number of letters of a text in UTF-8.
size_t figure_letters(const char *text);

/// Places the movable texts of a panel so that they overlap no other text, legend or edge. Its axes and box must be
/// final.
void figure_place_texts(whirl_figure *figure, whirl_panel *panel);

// ---------------------------------------------------------------- script_data
// Writes data into an HTML page: JSON whose texts cannot end a script element, and arrays of numbers as base64.

/// Writes a JSON string, quotes included. '<', '>' and '&' are escaped, so that no text is ever markup; bytes that are
/// not UTF-8 become U+FFFD.
void script_text(FILE *stream, const char *text);

/// Writes a number with the digits that give the same double back, null for NaN and infinities.
void script_number(FILE *stream, double value);

/// Writes a member of an object: `before` is `{` for the first member, else `,`. script_key writes the key alone, the
/// caller the value.
void script_key(FILE *stream, char before, const char *key);
void script_text_member(FILE *stream, char before, const char *key, const char *text);
void script_number_member(FILE *stream, char before, const char *key, double value);

/// Writes ',"NAME":VALUE' for every member of a struct that has a name.
void script_members(FILE *stream, const whirl_member *member, const void *from);

/// A stream of bytes that is written as base64 (RFC 4648); initial value: {stream}.
typedef struct base64 {
    FILE *stream;
    uint32_t bits;
    unsigned count; ///< bytes in `bits`, 0 to 2
} base64;

void base64_byte(base64 *to, uint8_t byte);
void base64_float32(base64 *to, double value); ///< little-endian; NaN stays NaN
void base64_float64(base64 *to, double value); ///< little-endian
void base64_end(base64 *to);                   ///< writes the remaining bytes, with padding

// ---------------------------------------------------------------- symbols
// Symbols, words and units as journals set them, in labels of figures: letters between dollars are symbols, in italics
// with subscripts.

enum { SYMBOL_SIZE = 256 };

/// Writes a name as a symbol: "r_k" becomes "$r_{k}$", "k1" "$k_{1}$"; "omega" and "r_delta" get Greek letters; words
/// are unchanged.
void symbol_of(const char *name, char *text, size_t size);

/// Returns the units; if lengths are shown over a length scale with a name ("c"), the name becomes a symbol ("$c$").
whirl_shown_units symbol_units(const whirl_shown_units *units);

/// Writes the axis label of a parameter: symbol and unit.
void symbol_parameter(const whirl_shown_units *units, const char *name, char *text, size_t size);

/// Writes the axis label of x or y of a station, "$x$ (mm)", or of another length, "radius (mm)".
void symbol_length(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *text,
                   size_t size);

#endif
