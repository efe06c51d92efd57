/// Figures as data: panels with axes and series of a result, in the units in which they are shown. Renderers draw them
/// and know none by its name: gnuplot (whirl_figure_write), and whoever reads the JSON of it.
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

/// How the numbers of a series are drawn. NaN breaks lines and areas, and leaves out all else.
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

/// Where a text stands from its point.
typedef enum whirl_side {
    WHIRL_ABOVE,
    WHIRL_BELOW,
    WHIRL_LEFT,
    WHIRL_RIGHT,
    WHIRL_SLANTED, ///< to the right, rising
    WHIRL_BESIDE   ///< to the right, at its height
} whirl_side;

/// Numbers that are drawn in one way. Arrays are the figure's.
typedef struct whirl_series {
    whirl_shape shape;          ///< how they are drawn
    char name[WHIRL_NAME_SIZE]; ///< in the legend; "" where it is not there
    size_t count;               ///< of points
    double *x, *y;              ///< [count]
    double *x_to, *y_to;        ///< [count] of boxes; y_to of areas and bars, too; else NULL
    double *values;             ///< [count] by which boxes have colours of the figure's scale; else NULL
    char **texts;               ///< [count] of texts, else NULL
    char colour[8];             ///< "#0072B2"
    double opacity;             ///< 1: nothing shines through
    double size;                ///< pt: the diameter of marks, the width of lines
    whirl_mark mark;            ///< of dots
    bool dashed;                ///< of lines
    whirl_side side;            ///< of texts
} whirl_series;

/// An axis. Labels have symbols between dollars, "$r_{k}$ (mm)": letters in italics with subscripts.
typedef struct whirl_axis {
    char label[4 * WHIRL_NAME_SIZE]; ///< quantity and unit
    double low, high;                ///< what is shown
    bool logarithmic;                ///< both are above 0 then
    bool shown;                      ///< with label and numbers
    size_t tick_count;               ///< of ticks; 0: where renderers like
    double *ticks;                   ///< [tick_count] where they stand
    char **tick_texts;               ///< [tick_count] and what is written there
} whirl_axis;

/// A part of a panel that shows a station: where figures can be clicked on, it stands for that.
typedef struct whirl_spot {
    char station[WHIRL_NAME_SIZE]; ///< its name
    double x, y, x_to, y_to;       ///< a box, in numbers of the axes
} whirl_spot;

/// A panel.
typedef struct whirl_panel {
    char name[WHIRL_NAME_SIZE];      ///< among those of the figure: "x", "exponent"
    char title[2 * WHIRL_NAME_SIZE]; ///< above it, or ""
    char letter;                     ///< "(a)" beside it, or 0
    double left, right, bottom, top; ///< shares of the figure's width and height
    double width, height;            ///< share of the width that it takes with its labels; cm
    whirl_axis x, y;                 ///< its axes
    bool equal;                      ///< both axes have one scale
    bool keyed;                      ///< names of series stand in a legend inside it, else above the figure
    size_t count;                    ///< of series
    whirl_series **series;           ///< [count] later ones over earlier ones
    size_t spot_count;               ///< of spots
    whirl_spot *spots;               ///< [spot_count] parts that show stations
} whirl_panel;

/// The colours of numbers.
typedef struct whirl_colour_scale {
    char label[4 * WHIRL_NAME_SIZE]; ///< "" where the figure has none
    double low, high;                ///< numbers of the first and the last colour
    bool logarithmic;                ///< colours stand for ratios
    size_t count;                    ///< of colours
    const char *const *colours;      ///< [count] "#440154", from low to high; static
    size_t tick_count;               ///< of ticks
    double *ticks;                   ///< [tick_count] where they stand
    char **tick_texts;               ///< [tick_count] and what is written there
} whirl_colour_scale;

/// A figure.
typedef struct whirl_figure {
    char name[200];             ///< "bifurcation-disc": a name for its files, of letters, digits, '-', '_', '.'
    char title[280];            ///< one line
    char caption[900];          ///< what it shows, and what marks and colours mean
    double width, height, font; ///< cm; of letters, pt
    size_t count;               ///< of panels
    whirl_panel **panels;       ///< [count] from the top
    whirl_colour_scale scale;   ///< of series with values
    bool failed;                ///< memory was lacking while it was made
} whirl_figure;

/// How figures of a result are made.
typedef struct whirl_figure_options {
    const char *units;  ///< as whirl_result_shown_units has them; NULL: those of the result
    const char *panels; ///< "x,exponent": these alone; NULL: all
    const char *log; ///< "x", "y" or "xy": axes that are logarithmic where all is above 0; NULL: as the figure has them
} whirl_figure_options;

/// What a figure of a result is called.
typedef struct whirl_figure_name {
    char name[200];  ///< whirl_figure.name
    char title[280]; ///< whirl_figure.title
    long point;      ///< of the table of points in detail; -1 of diagrams over a parameter
    size_t station;  ///< of the result; SIZE_MAX of a response of all stations in one figure
} whirl_figure_name;

/// Names and titles of the figures of a result, [*count], to be freed by free. WHIRL_NO_MEMORY, and WHIRL_BAD_INPUT for
/// words that are no units.
whirl_status whirl_figure_names(const whirl_result *result, const char *units, whirl_figure_name **names,
                                size_t *count);

/// Makes a figure by its name (NULL: the first). WHIRL_BAD_INPUT with a sentence for names that there are none of, and
/// words that are no units. Freed by whirl_figure_free.
whirl_status whirl_figure_new(const whirl_result *result, const char *name, const whirl_figure_options *options,
                              whirl_figure **figure);

/// Frees a figure; NULL is none.
void whirl_figure_free(whirl_figure *figure);

/// Writes it to a file, whole or not at all, by its ending: .png, .pdf or .svg by gnuplot (`program`; NULL: "gnuplot"
/// on the PATH), or .json. Errors as whirl_report_write.
whirl_status whirl_figure_write(const whirl_figure *figure, const char *path, const char *program);

/// Writes it as one JSON object (docs/figures.md). WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status whirl_figure_write_json(const whirl_figure *figure, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
