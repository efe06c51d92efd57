/// Kinds of figures of results. Each kind has a file in this folder and a word in FIGURE_KINDS below.
#ifndef REPORT_FIGURE_KINDS_H
#define REPORT_FIGURE_KINDS_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/job.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>

/// Input of figures.
typedef struct drawing {
    const whirl_result *result;
    const whirl_shown_units *units; ///< units of the figure's numbers
    const whirl_case *machine;      ///< case of the result (machine_at.h), or NULL
} drawing;

typedef struct figure_kind figure_kind;

enum { NO_POINT = -1 };

/// A figure that can be made.
typedef struct figure_place {
    const figure_kind *kind;
    const whirl_table *table; ///< its table
    long point;               ///< point of the table; or NO_POINT
    size_t station, which;    ///< `which` is the index among several figures of a kind, as the kind defines it
    const whirl_field *field; ///< field shown by a figure of fields
    size_t column;            ///< column of the field; `which` is the station or contact
    whirl_figure_name name;
    char within[176]; ///< name within its table
} figure_place;

typedef struct figure_list {
    size_t count, capacity;
    figure_place *items;
    bool failed; ///< memory ran out
} figure_list;

struct figure_kind {
    /// Adds the figures of a table, if it has any of this kind.
    void (*list)(figure_list *list, const drawing *of, const whirl_table *table);
    /// Makes a figure, whose name and title are already set.
    void (*describe)(const drawing *of, const figure_place *place, whirl_figure *figure);
    /// Optional: adds a figure that is not on the list but can be made on request. WHIRL_BAD_INPUT if the name is of
    /// this kind but no such figure can be made.
    whirl_status (*find)(figure_list *list, const drawing *of, const char *name);
    const char *stem;  ///< beginning of all names of this kind; NULL: none
    const char *study; ///< the study in a case that makes these figures
    bool samples;      ///< the kind is for studies of tolerances, which have figures of no other kind
    bool whole;        ///< figures of the whole result: `list` is called once, with its first table or NULL
};

/// For figures of fields. shown_number: returns a number of a point, from a row of the field, in its shown unit.
/// shown_label: writes its label.
double shown_number(const drawing *of, const figure_place *place, size_t point, size_t row);
void shown_label(const drawing *of, const figure_place *place, char *label, size_t size);

/// shown_quantity: writes the name of the number without unit: its column, or the meaning of the field without remarks.
/// shown_owner: returns the station or contact, "" for numbers of a point.
void shown_quantity(const figure_place *place, char *text, size_t size);
const char *shown_owner(const drawing *of, const figure_place *place);

/// Draws a map of a field's numbers.
void map_describe(const drawing *of, const figure_place *place, whirl_figure *figure);

/// Adds a figure to the list; `name` becomes a unique file name.
void list_figure(figure_list *list, const figure_place *place, const char *name, const char *title, ...)
    __attribute__((format(printf, 4, 5)));

/// Lists all figures of a result; the caller frees list->items by free(). WHIRL_NO_MEMORY.
whirl_status figures_list(const drawing *of, figure_list *list);

/// Makes a figure of the list. WHIRL_NO_MEMORY, and WHIRL_BAD_INPUT for panels that it does not have.
whirl_status figure_make(const drawing *of, const figure_place *place, const whirl_figure_options *options,
                         whirl_figure **figure);

/// Returns the colour of a line by its number: "#0072B2", "#D55E00", ...
const char *line_colour(size_t number);

/// Returns true if a table has a field.
bool table_has(const whirl_table *table, const char *field);

/// Returns true if a table has the motions of a sweep over one parameter.
bool table_is_sweep(const drawing *of, const whirl_table *table);

// clang-format off
/// The kinds, in the order of lists of figures.
#define FIGURE_KINDS(kind)                                                                                             \
    kind(rotor) kind(bifurcation) kind(waterfall) kind(map) kind(branch) kind(curves) kind(torus) kind(campbell)       \
    kind(decrement) kind(shapes) kind(sag) kind(deflected) kind(unbalance) kind(critical_speeds) kind(stability)       \
    kind(screening) kind(centreline) kind(orbits) kind(transient) kind(runup) kind(runup_polar) kind(runup_spectra)    \
    kind(runup_motion) kind(runup_turn) kind(twists) kind(fit) kind(point) kind(field) kind(sensitivity)               \
    kind(tolerances)
// clang-format on
#define FIGURE_KIND(name) extern const figure_kind name##_figure;
FIGURE_KINDS(FIGURE_KIND)

/// Colours of amplitudes in waterfalls and spectrograms: viridis from its bright end, so that on white the largest
/// amplitudes are the darkest.
enum { WATERFALL_COLOURS = 8 };
extern const char *const waterfall_colours[WATERFALL_COLOURS];

#endif
