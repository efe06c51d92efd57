/// The figures that results have: one file a kind in this folder, a line in the registry and
/// one below.
#ifndef REPORT_FIGURE_KINDS_H
#define REPORT_FIGURE_KINDS_H

#include <stdbool.h>
#include <stddef.h>

#include "figure_build.h"
#include "units.h"
#include "whirl/engine/case.h"

/// What figures are made from.
typedef struct drawing {
    const whirl_result *result;
    const whirl_shown_units *units; ///< of its numbers
    const whirl_case *machine;      ///< that it is of (machine_at.h), or NULL
} drawing;

typedef struct figure_kind figure_kind;

enum { NO_POINT = -1 };

/// A figure that there is.
typedef struct figure_place {
    const figure_kind *kind;
    const whirl_table *table; ///< whose
    long point;               ///< or NO_POINT
    size_t station, which;    ///< of several alike
    const whirl_field *field; ///< whose numbers any figure of fields shows,
    size_t column;            ///< and which of them; `which` is the station or contact
    whirl_figure_name name;
} figure_place;

typedef struct figure_list {
    size_t count, room;
    figure_place *items;
    bool failed; ///< memory was lacking
} figure_list;

struct figure_kind {
    /// Adds the figures of a table, if it has any of this kind.
    void (*list)(figure_list *list, const drawing *of, const whirl_table *table);
    /// Makes one of them; name and title are there.
    void (*describe)(const drawing *of, const figure_place *place, whirl_figure *figure);
    /// Optional: adds the figure of a name that is not on the list, made as it is asked for. WHIRL_BAD_INPUT where the
    /// name is meant for this kind, and there is no such figure.
    whirl_status (*find)(figure_list *list, const drawing *of, const char *name);
};

/// A number of a point in the unit that is shown, of a figure of fields, in a row of the field; and what it is called.
double shown_number(const drawing *of, const figure_place *place, size_t point, size_t row);
void shown_label(const drawing *of, const figure_place *place, char *label, size_t size);

/// What the number is called without its unit: its column, or the meaning of the field up to what is said beside it;
/// and the station or contact that it is of, "" of a point's.
void shown_quantity(const figure_place *place, char *text, size_t size);
const char *shown_owner(const drawing *of, const figure_place *place);

/// A map of a field's numbers.
void map_describe(const drawing *of, const figure_place *place, whirl_figure *figure);

/// Adds one; `name` is made a file name that no other has.
void list_figure(figure_list *list, const figure_place *place, const char *name, const char *title, ...)
    __attribute__((format(printf, 4, 5)));

/// All of a result, to be freed by free. WHIRL_NO_MEMORY.
whirl_status figures_list(const drawing *of, figure_list *list);

/// Makes one of them. WHIRL_NO_MEMORY, and WHIRL_BAD_INPUT for panels that it has not.
whirl_status figure_make(const drawing *of, const figure_place *place, const whirl_figure_options *options,
                         whirl_figure **figure);

/// "#0072B2", "#D55E00", ...: the colours of lines, by their number.
const char *line_colour(size_t number);

/// Whether a table has a field.
bool table_has(const whirl_table *table, const char *field);

/// Whether a table has the motions of a sweep over one parameter.
bool table_is_sweep(const drawing *of, const whirl_table *table);

extern const figure_kind bifurcation_figure, waterfall_figure, map_figure, branch_figure, curves_figure, torus_figure,
    campbell_figure, shapes_figure, unbalance_figure, critical_speeds_figure, stability_figure, screening_figure,
    orbits_figure, point_figure, field_figure;

#endif
