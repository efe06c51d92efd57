/// Figures as data: panels with axes and series of a result, in shown units. Renderers (gnuplot by whirl_figure_write,
/// and readers of the JSON) treat all figures alike.
#ifndef WHIRL_FIGURE_H
#define WHIRL_FIGURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/result.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Ways of drawing a series. A point with NaN breaks lines and areas; other shapes skip it.
typedef enum whirl_shape {
    WHIRL_DOTS,  ///< marks at x, y
    WHIRL_LINE,  ///< from point to point
    WHIRL_AREA,  ///< filled from y to y_to
    WHIRL_BARS,  ///< upright lines from y to y_to
    WHIRL_BOXES, ///< filled from x, y to x_to, y_to
    WHIRL_TEXTS  ///< texts at x, y
} whirl_shape;

/// Marks of dots.
typedef enum whirl_mark {
    WHIRL_DISC,
    WHIRL_RING,
    WHIRL_SQUARE,
    WHIRL_FRAME, ///< an open square
    WHIRL_UP,    ///< a triangle
    WHIRL_DOWN,
    WHIRL_DIAMOND,
    WHIRL_CROSS
} whirl_mark;

/// Position of a text relative to its point.
typedef enum whirl_side {
    WHIRL_ABOVE,
    WHIRL_BELOW,
    WHIRL_LEFT,
    WHIRL_RIGHT,
    WHIRL_SLANTED, ///< to the right, rising
    WHIRL_BESIDE   ///< to the right, at its height
} whirl_side;

/// Numbers that are drawn in one way. The figure owns the arrays.
typedef struct whirl_series {
    whirl_shape shape;          ///< way of drawing
    char name[WHIRL_NAME_SIZE]; ///< name in the legend; "" to leave it out
    size_t count;               ///< number of points
    double *x, *y;              ///< [count]
    double *x_to, *y_to;        ///< [count] for boxes; y_to also for areas and bars; else NULL
    double *values;             ///< [count] numbers for the colours of boxes in the figure's scale; else NULL
    char **texts;               ///< [count] for texts, else NULL
    char colour[8];             ///< "#0072B2"
    double opacity;             ///< 1: opaque
    double size;                ///< pt: the diameter of marks, the width of lines
    whirl_mark mark;            ///< for dots
    bool dashed;                ///< for lines
    whirl_side side;            ///< for texts
    bool movable; ///< for texts: a text that would overlap others moves to another side; without room it is left out
} whirl_series;

/// An axis. Labels have symbols between dollar signs, "$r_{k}$ (mm)": italic letters with subscripts.
typedef struct whirl_axis {
    char label[4 * WHIRL_NAME_SIZE]; ///< quantity and unit
    double low, high;                ///< range shown
    bool logarithmic;                ///< both ends are then above 0
    bool shown;                      ///< true if label and numbers are drawn
    size_t tick_count;               ///< number of ticks; 0: renderers choose
    double *ticks;                   ///< [tick_count] positions
    char **tick_texts;               ///< [tick_count] texts
} whirl_axis;

/// A part of a panel that shows a station: a click on it selects that station.
typedef struct whirl_spot {
    char station[WHIRL_NAME_SIZE]; ///< its name
    double x, y, x_to, y_to;       ///< a box, in coordinates of the axes
} whirl_spot;

/// A panel.
typedef struct whirl_panel {
    char name[WHIRL_NAME_SIZE];      ///< name within the figure: "x", "exponent"
    char title[2 * WHIRL_NAME_SIZE]; ///< title above it, or ""
    char letter;                     ///< the letter of its label "(a)", or 0
    double left, right, bottom, top; ///< edges, as shares of the figure's width and height
    double width, height;            ///< share of the figure's width, labels included; height of the axes in cm
    whirl_axis x, y;                 ///< its axes
    bool equal;                      ///< both axes have one scale
    bool keyed;                      ///< the legend is inside the panel, else above the figure
    size_t count;                    ///< number of series
    whirl_series **series;           ///< [count] later ones over earlier ones
    size_t spot_count;               ///< number of spots
    whirl_spot *spots;               ///< [spot_count] parts that show stations
} whirl_panel;

/// A scale of colours for numbers.
typedef struct whirl_colour_scale {
    char label[4 * WHIRL_NAME_SIZE]; ///< "" if the figure has none
    double low, high;                ///< numbers of the first and the last colour
    bool logarithmic;                ///< equal steps of colour are equal ratios
    size_t count;                    ///< number of colours
    const char *const *colours;      ///< [count] "#440154", from low to high; static
    size_t tick_count;               ///< number of ticks
    double *ticks;                   ///< [tick_count] positions
    char **tick_texts;               ///< [tick_count] texts
} whirl_colour_scale;

/// A figure.
typedef struct whirl_figure {
    char name[200];             ///< "bifurcation-disc": a name for its files, of letters, digits, '-', '_', '.'
    char title[280];            ///< one line
    char caption[900];          ///< explanation of the figure, and of its marks and colours
    double width, height, font; ///< cm; size of letters, pt
    size_t count;               ///< number of panels
    whirl_panel **panels;       ///< [count] from top to bottom
    whirl_colour_scale scale;   ///< for series with values
    bool failed;                ///< true if memory was exhausted while the figure was built
} whirl_figure;

/// Options of the figures of a result.
typedef struct whirl_figure_options {
    const char *units;  ///< units as in whirl_result_shown_units; NULL: those of the result
    const char *panels; ///< "x,exponent": only these; NULL: all
    /// "x", "y" or "xy": axes that are logarithmic if all their numbers are above 0; NULL: the figure's default.
    const char *log;
    /// NULL, or a result whose figure of the same name is drawn into this one, dashed and in the same units: a measured
    /// record over a model.
    const whirl_result *with;
} whirl_figure_options;

/// Name and subject of a figure of a result.
typedef struct whirl_figure_name {
    char name[200];  ///< whirl_figure.name
    char title[280]; ///< whirl_figure.title
    long point;      ///< index in the table of points in detail; -1 for diagrams over a parameter
    size_t station;  ///< index in the result; SIZE_MAX for a response of all stations in one figure
} whirl_figure_name;

/// Lists names and titles of the figures of a result, [*count], to be freed by free. WHIRL_NO_MEMORY, and
/// WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_figure_names(const whirl_result *result, const char *units, whirl_figure_name **names,
                                size_t *count);

/// Builds a figure by its name (NULL: the first). WHIRL_BAD_INPUT with a sentence for an unknown name, for words that
/// are not units, and for two results whose figures cannot lie in one picture: other units, or colours that have a
/// meaning. Freed by whirl_figure_free.
whirl_status whirl_figure_new(const whirl_result *result, const char *name, const whirl_figure_options *options,
                              whirl_figure **figure);

/// Frees a figure; accepts NULL.
void whirl_figure_free(whirl_figure *figure);

/// Writes a figure to a file, completely or not at all, in the format of its extension: .png, .pdf or .svg by gnuplot
/// (`program`; NULL: "gnuplot" on the PATH), or .json. Errors as whirl_report_write.
whirl_status whirl_figure_write(const whirl_figure *figure, const char *path, const char *program);

/// Writes a figure as one JSON object (docs/figures.md). WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_figure_write_json(const whirl_figure *figure, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
