/// Kinds of figures of results: one file for each kind in this folder, a line in the registry and one below.
#ifndef REPORT_FIGURE_KINDS_H
#define REPORT_FIGURE_KINDS_H

#include "figure_build.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/line.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/system.h"
#include "whirl/internal/model.h"
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
    size_t station, which;    ///< index among several alike
    const whirl_field *field; ///< field shown by a figure of fields
    size_t column;            ///< column of the field; `which` is the station or contact
    whirl_figure_name name;
    char within[176]; ///< name within its table
} figure_place;

typedef struct figure_list {
    size_t count, room;
    figure_place *items;
    bool failed; ///< memory was lacking
} figure_list;

struct figure_kind {
    /// Adds the figures of a table, if it has any of this kind.
    void (*list)(figure_list *list, const drawing *of, const whirl_table *table);
    /// Makes one of these figures, whose name and title are already set.
    void (*describe)(const drawing *of, const figure_place *place, whirl_figure *figure);
    /// Optional: adds a figure that is not on the list but can be made on request. WHIRL_BAD_INPUT if the name is of
    /// this kind but no such figure can be made.
    whirl_status (*find)(figure_list *list, const drawing *of, const char *name);
    const char *stem;  ///< beginning of all names of this kind, or NULL
    const char *study; ///< the study in a case that makes these figures
    bool samples;      ///< figures of studies of tolerances, which have no others
    bool whole;        ///< figures of the whole result: `list` is called once, with its first table or NULL
};

/// shown_number: a number of a point in its shown unit, for figures of fields, from a row of the field. shown_label:
/// its label.
double shown_number(const drawing *of, const figure_place *place, size_t point, size_t row);
void shown_label(const drawing *of, const figure_place *place, char *label, size_t size);

/// shown_quantity: name of the number without unit, either its column or the meaning of the field up to the remark.
/// shown_owner: the station or contact, "" for numbers of a point.
void shown_quantity(const figure_place *place, char *text, size_t size);
const char *shown_owner(const drawing *of, const figure_place *place);

/// Draws a map of a field's numbers.
void map_describe(const drawing *of, const figure_place *place, whirl_figure *figure);

/// Adds a figure to the list; `name` becomes a unique file name.
void list_figure(figure_list *list, const figure_place *place, const char *name, const char *title, ...)
    __attribute__((format(printf, 4, 5)));

/// Lists all figures of a result; the caller frees the list by free(). WHIRL_NO_MEMORY.
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
    kind(runup_motion) kind(twists) kind(fit) kind(point) kind(field) kind(tolerances)
// clang-format on
#define FIGURE_KIND(name) extern const figure_kind name##_figure;
FIGURE_KINDS(FIGURE_KIND)

/// Colours of amplitudes in waterfalls and spectrograms: viridis from its bright end, so that on white the largest are
/// the darkest.
enum { WATERFALL_COLOURS = 8 };
extern const char *const waterfall_colours[WATERFALL_COLOURS];

// ---------------------------------------------------------------- machine_layout
// Positions of the parts of a machine in its drawing.

/// Layout of a machine's drawing. Lengths are in m; without shafts of finite elements they have no meaning.
typedef struct machine_layout {
    const whirl_result *result;
    whirl_model model;
    bool to_scale;                                           ///< the machine has shafts of finite elements
    double offset[WHIRL_MAX_SHAFTS], axis[WHIRL_MAX_SHAFTS]; ///< start of a shaft; its height
    bool placed_shaft[WHIRL_MAX_SHAFTS];
    bool placed[WHIRL_MAX_PROBES];
    double x[WHIRL_MAX_PROBES], y[WHIRL_MAX_PROBES], radius[WHIRL_MAX_PROBES]; ///< positions and radii of all stations
    double symbol;                                                             ///< size of symbols
    double top, bottom;                                                        ///< range of the whole drawing
    span along;
} machine_layout;

/// layout_new: lays out the machine of a drawing; NULL without a machine or without memory. Free with layout_free.
machine_layout *layout_new(const drawing *of);
void layout_free(machine_layout *layout);

/// Letters of the longest name of a station.
size_t layout_longest_name(const whirl_result *result);

/// Returns true for a station of the layout, false for the ground.
bool layout_has_station(const machine_layout *l, size_t station);

/// layout_largest_radius: largest radius of a shaft and the parts on it. layout_rim_radius: radius of a station's disc,
/// else of its shaft. m.
double layout_largest_radius(const machine_layout *l, size_t shaft);
double layout_rim_radius(const machine_layout *l, size_t station);

/// Computes radius and width (m) of a steel disc with a station's mass and polar inertia; for a mass without inertia,
/// of a cube.
double layout_disc_radius(const whirl_model_mass *of);
double layout_disc_width(const whirl_model_mass *of);

/// The mass that a station is drawn by: its own, or that of a steel disc of its polar inertia.
double layout_mass(const whirl_model_mass *of);

/// Drawn size of a station's disc or mass: half of its width, and its outer radius; both large enough to be visible. m.
typedef struct layout_disc {
    double half, radius;
} layout_disc;
layout_disc layout_disc_of(const machine_layout *l, size_t station);

/// Returns the positions of both ends of a shaft; an empty span without sections.
span layout_shaft_ends(const machine_layout *l, size_t shaft);

/// layout_unit: unit of places along shafts in m. layout_label: label of their axis. Inches if lengths are in mils or
/// inches, else mm.
double layout_unit(const whirl_shown_units *units);
const char *layout_label(const whirl_shown_units *units);

// ---------------------------------------------------------------- machine_along
// Shapes of a machine over the places of its stations, with the machine in grey behind.

/// Positions of stations and shafts along a figure. Stations of shafts of finite elements are at their places; shafts
/// on different axes follow one another; stations on no shaft come last. Without shafts stations are spaced evenly.
typedef struct machine_along {
    machine_layout *layout;                               ///< layout of the machine, to scale; NULL: none
    bool shafts;                                          ///< the machine has shafts of finite elements
    size_t aside;                                         ///< number of stations on no shaft, if there are shafts
    double unit;                                          ///< m of one unit
    span range;                                           ///< in units, or numbers of stations
    double step, end;                                     ///< spacing of stations on no shaft, which begin at `end`
    double at[WHIRL_MAX_PROBES], start[WHIRL_MAX_SHAFTS]; ///< positions of stations; of place 0 of shafts
} machine_along;

/// Finds the positions along a figure; the caller frees `layout` by layout_free.
void along_place(const drawing *of, machine_along *out);

/// Sets up the horizontal axis of a panel: places along shafts, or names of stations without shafts.
void along_axis(whirl_figure *figure, whirl_panel *panel, const drawing *of, const machine_along *along);

/// Caption of the machine; "" if it is not drawn.
const char *along_caption(const machine_along *along);

/// Draws the machine in grey behind a panel whose vertical axis goes from -high to high: to scale along the axis, and
/// across as large as fits.
void along_machine(whirl_figure *figure, whirl_panel *panel, const machine_along *along, double high);

// ---------------------------------------------------------------- shaft_bends
// Deflection of shafts between stations: the machine of a point, computed again, with its shaft lines.

typedef struct shaft_bends shaft_bends;

/// bends_new: the shaft lines of the machine at a point of a study at rest; NULL if the machine cannot be built or has
/// no shafts of finite elements. Free with bends_free.
shaft_bends *bends_new(const drawing *of, const whirl_table *table, size_t point);
void bends_free(shaft_bends *bends);

/// Return the shaft line, and the length scale of the machine in m.
const whirl_shaft_line *bends_line(const shaft_bends *bends);
double bends_length(const shaft_bends *bends);

/// Fill moved [places][4] with x_cos, x_sin, y_cos, y_sin of the shaft line: for a mode scaled as `modes/shape`, for
/// the unbalance response as lengths. Return false if the shape differs from the result's stations by more than 1e-6 of
/// its largest value.
bool bends_mode(shaft_bends *bends, size_t mode, double *moved);
bool bends_response(shaft_bends *bends, double *moved);

/// Adds a column of moved [places][columns] to a series, shaft by shaft.
void bends_draw(whirl_figure *figure, whirl_series *to, const shaft_bends *bends, const machine_along *along,
                const double *moved, size_t columns, size_t column);

/// A shape over a machine: which column of moved is drawn, 0 and 1 along x, 2 and 3 along y, even ones with full lines.
typedef struct along_curve {
    const drawing *of;
    const machine_along *along;
    const shaft_bends *bends; ///< NULL: lines go from station to station
    const double *moved;      ///< [places][columns] in units of the panel
    size_t columns, column;
} along_curve;

/// Draws the curve, with marks at stations from values [stations], the same column; NaN: no mark.
void along_shape(whirl_figure *figure, whirl_panel *panel, const along_curve *of, const double *values);

// ---------------------------------------------------------------- bifurcation
// A bifurcation diagram of a station: its data, shared by its panels.

enum { MAX_KINDS = (int)CLASS_COUNT > (int)ATTRACTOR_COLOURS ? (int)CLASS_COUNT : (int)ATTRACTOR_COLOURS };

typedef struct bifurcation {
    const whirl_result *result;
    const whirl_table *table;
    const whirl_case *machine; ///< their machine (machine_at.h), or NULL
    size_t station;
    span parameter, x, y, exponent, radius;
    bool rub, confidence, both;
    bool shaded;             ///< ranges with contact are shaded: some points have contact, but not all
    bool present[MAX_KINDS]; ///< kinds of points that occur
    size_t attractors; ///< number of attractors with a strip or colour; 0: one start at each place, kinds are regimes
    const whirl_shown_units *units;
    double length, value; ///< factors from SI to shown displacements and parameter values
    double share;         ///< largest share of the time in contact, with a margin
    double gap;           ///< radius of contact with a stator; 0 if none is near, or it changes
    double clearance;     ///< bearing clearance; 0 if there is none or it changes
    bool ratios;          ///< parameter values have equal ratios: the axis is logarithmic
} bifurcation;

/// Kinds of points: classes of regimes, or attractors if there are several starts at a place.
size_t bifurcation_kinds(const bifurcation *of);
size_t bifurcation_kind(const bifurcation *of, size_t point);
const char *bifurcation_kind_colour(const bifurcation *of, size_t kind);
void bifurcation_kind_name(const bifurcation *of, size_t kind, char text[WHIRL_NAME_SIZE]);

/// Fills in ranges and flags from result, table, machine, station, units, length and value.
void bifurcation_survey(bifurcation *of);

/// Returns the part of the axis that belongs to a point, in SI: half-way to its neighbours in its branch.
void bifurcation_edges(const bifurcation *of, size_t i, double *low, double *high);

// ---------------------------------------------------------------- map_cells
// Cells of a plane of a map: a point of its grid represents the part of the plane nearest to it.

typedef struct map_cells {
    size_t plane, columns, rows;
    double *x, *y;           ///< [columns + 1], [rows + 1] edges, in shown units
    double z;                ///< value of the third parameter in the plane, in its shown unit; NaN without one
    bool x_ratios, y_ratios; ///< the axes are logarithmic
    bool refined;
    size_t *cover;           ///< [rows][columns] the point of the table that covers a cell (whirl_table_cover)
    double *memory;          ///< memory of the edges
    size_t *cover_of_planes; ///< covers of all planes; `cover` is a part of it
} map_cells;

/// Lays out the cells of a plane of a table with rows, also of a partial result. Returns false without memory. Freed by
/// map_cells_free.
bool map_cells_make(const whirl_shown_units *units, const whirl_table *table, size_t plane, map_cells *cells);
void map_cells_free(map_cells *cells);

/// Cells of one value that are drawn as one: in a refined map neighbours in a row. Starts as {0}.
typedef struct map_run {
    size_t next;  ///< first cell after the run
    double value; ///< value of the cells
    span x, y;
} map_run;

/// Advances to the next run of equal values in [rows][columns]; cells without a value (NaN) are skipped. Returns false
/// at the end.
bool map_cells_next(const map_cells *cells, const double *values, map_run *run);

/// Adds borders between cells of different labels [rows][columns]; label 0 (no verdict) has no border.
void map_cells_add_borders(whirl_figure *figure, whirl_series *to, const map_cells *cells, const long *labels);

// ---------------------------------------------------------------- speed_unit
// Unit of frequencies in figures over a parameter.

typedef struct speed_unit {
    double size; ///< rad/s
    char name[WHIRL_NAME_SIZE];
    bool of_speed; ///< the parameter is the speed of the shaft
} speed_unit;

/// Returns the parameter's unit if the parameter is the shaft's speed (field `speeds` of every point), else Hz.
speed_unit speed_unit_of(const drawing *of, const whirl_table *table, const char *speeds);

// ---------------------------------------------------------------- tori
// Tori in the figures of branches.

/// Returns the result's table of tori; NULL if there is none, or it has no torus.
const whirl_table *tori_table(const whirl_result *result);

/// Adds the bands covered by a coordinate (0: x, 1: y) of a station's section, starting from the orbits where tori
/// begin; `size` is one unit of the parameter.
void tori_add_bands(whirl_figure *figure, whirl_panel *panel, const drawing *of, size_t station, size_t column,
                    double size);

/// Caption of the bands of tori.
extern const char tori_caption[];

#endif
