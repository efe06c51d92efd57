// The figures of a report: every one is a gnuplot script with data files beside it.
#ifndef REPORT_FIGURES_H
#define REPORT_FIGURES_H

#include <stdbool.h>
#include <stddef.h>

#include "report_file.h"
#include "units.h"
#include "whirl/case.h"
#include "whirl/result.h"
#include "whirl/status.h"

enum { STEM_SIZE = 200, NO_POINT = -1 };

typedef struct figure {
    size_t result; ///< index of the result it shows
    long point;    ///< of the detail table, or NO_POINT for a diagram over a parameter
    size_t station;
    char stem[STEM_SIZE];    ///< file name without ending; STEM.gp, STEM.png, STEM.pdf
    char data[3][STEM_SIZE]; ///< names of the data files, "" where there are fewer
    char title[280];
    char caption[700];
    bool drawn;
} figure;

typedef struct figure_list {
    size_t count, capacity;
    figure *items;
} figure_list;

/// Room for one more figure of a result at the end of the list, zeroed but for its stem, which is `stem` made a file
/// name that no other figure of the result has. NULL when memory ran out.
figure *figure_add(figure_list *list, size_t result, const char *stem);

/// What figures are made from and where they go.
typedef struct drawing {
    const whirl_result *result;
    size_t index;                   ///< of the result
    const whirl_shown_units *units; ///< of its numbers
    const whirl_case *machine;      ///< that it is of (machine_at.h), or NULL
    const char *folder;             ///< where its files go
    figure_list *list;
} drawing;

/// Writes data and scripts of the bifurcation diagrams, one a station, of the table "sweep" if there is one.
whirl_status draw_bifurcations(const drawing *to);

/// Writes data and scripts of the diagrams of tables of one kind (shown_kinds.h): modes over a parameter, and their
/// shapes; the response of every station to unbalance; branches, one a station, or curves of special points; rotation
/// numbers, amplitudes and exponents of tori over the parameter, one a branch of tori.
whirl_status draw_modes(const drawing *to, const whirl_table *table);
whirl_status draw_unbalance(const drawing *to, const whirl_table *table);
whirl_status draw_branches(const drawing *to, const whirl_table *table);
whirl_status draw_tori(const drawing *to, const whirl_table *table);

/// Writes data and scripts of maps over two parameters: regimes, and numbers of the points.
whirl_status draw_maps(const drawing *to);

/// Writes data and scripts of the panels of every point of the detail table and every station.
whirl_status draw_points(const drawing *to);

/// Makes the file of a script, STEM.gp, to be closed by report_file_close, and writes its beginning: what it draws, and
/// the variables and settings that all figures share. Sizes in cm (a column of a journal is about 8.5 cm wide, two are
/// 17.5 to 18), the font in points. WHIRL_IO_ERROR with path and reason.
whirl_status script_begin(report_file *file, const drawing *to, const figure *what, double width, double height,
                          double font);

/// Writes `name = 'text'`; text in gnuplot's markup.
void script_label(FILE *script, const char *name, const char *markup);

/// Begins the loop over the two formats; what follows is drawn once as PNG and once as PDF.
void script_loop(FILE *script);
void script_end(FILE *script);

/// The distance of tics (1, 2 or 5 times a power of ten) that gives at most `most` of them in the range.
double tic_step(double width, int most);

/// Places the next panel: left, right, bottom, top as shares of the figure.
void script_panel(FILE *script, double left, double right, double bottom, double top);

/// A range that holds low .. high with a margin on both sides, and is at least `least` wide.
typedef struct span {
    double low, high;
} span;

/// The empty span, to be widened.
span span_empty(void);
void span_widen(span *range, double value); ///< values that are not finite are left out
span span_with_margin(span range, double margin, double least);

#endif
