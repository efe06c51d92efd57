// Shapes of the lowest modes along the shaft.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "figure_kinds.h"
#include "machine_along.h"
#include "machine_layout.h"
#include "shaft_bends.h"
#include "shown_kinds.h"
#include "speed_unit.h"
#include "units.h"

enum { SHAPES = 6 };

/// Adds a panel with a mode: along the shaft lines if these are known (`moved` is a buffer for them), else from station
/// to station.
static void add_mode(whirl_figure *figure, const drawing *of, const whirl_table *table, size_t mode, bool lowest,
                     const machine_along *places, shaft_bends *bends, double *moved) {
    const size_t point = table->count - 1;
    // Name and title the panel by frequency and direction of the mode.
    const speed_unit unit = speed_unit_of(of, table, WHIRL_FIELD_MODES_SPEED);
    const double frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode];
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "mode-%zu", mode + 1);
    whirl_panel *panel = figure_panel(figure, name, 0.5, 2.1);
    if (!panel) return;
    const int way = mode_way(table, point, mode);
    const bool lateral = way <= MODE_FORWARD, torsional = way == MODE_TORSIONAL, named = way != MODE_TO_AND_FRO;
    snprintf(panel->title, sizeof panel->title, "%zu: %.5g %.40s%s%s", mode + 1, frequency / unit.size, unit.name,
             named ? ", " : "", named ? mode_way_name(way) : "");
    // Compute the shape between stations, where the shaft is known, and draw the machine behind it.
    const bool bent = moved && lateral && bends_mode(bends, mode, moved);
    double most = 1.0;
    for (size_t i = 0; bent && i < 4 * bends_line(bends)->count; i++) most = fmax(most, fabs(moved[i]));
    axis_show(&panel->y, (span){-1.1 * most, 1.1 * most});
    along_machine(figure, panel, places, most);
    along_axis(figure, panel, of, places);
    if (!lowest) *panel->x.label = '\0';
    // Draw real and imaginary parts along x and y; for a torsional or axial mode those of the twist or of the axial
    // displacement.
    const char *field = lateral     ? WHIRL_FIELD_MODES_SHAPE
                        : torsional ? WHIRL_FIELD_MODES_TWIST
                                    : WHIRL_FIELD_MODES_AXIAL;
    const size_t columns = lateral ? 4 : 2;
    for (size_t column = 0; column < columns; column++) {
        double values[WHIRL_MAX_PROBES];
        for (size_t s = 0; s < of->result->station_count; s++)
            values[s] = whirl_table_field(table, point, field, s)[columns * mode + column];
        along_shape(figure, panel,
                    &(along_curve){of, places, bent ? bends : NULL, moved, 4, lateral ? column : 4 + column}, values);
    }
}

static size_t count_modes(const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, table->count - 1, WHIRL_FIELD_MODES_FREQUENCY, 0);
    size_t count = 0;
    while (frequency && count < field->rows && count < SHAPES && isfinite(frequency[count]) &&
           !mode_is_overdamped(table, table->count - 1, count))
        count++;
    return whirl_table_done(table, table->count - 1) ? count : 0;
}

static void shapes_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &shapes_figure, .table = table, .point = NO_POINT};
    if (table_has(table, WHIRL_FIELD_MODES_FREQUENCY) && of->result->station_count > 1 && count_modes(table) > 0)
        list_figure(to, &place, "shapes", "Shapes of the lowest modes");
}

static void shapes_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    // Compute places along the shafts once for all modes.
    const size_t count = count_modes(table);
    char label[UNIT_LABEL_SIZE];
    machine_along places;
    shaft_bends *bends = bends_new(of, table, table->count - 1);
    double *moved = bends ? calloc(4 * bends_line(bends)->count, sizeof *moved) : NULL;
    figure->font = 6.5;
    along_place(of, &places);
    // Add a panel for each mode.
    for (size_t mode = 0; mode < count; mode++)
        add_mode(figure, of, table, mode, mode + 2 >= count, &places, bends, moved);
    free(moved);
    bends_free(bends);
    // Describe the panels.
    const bool twists = table_has(table, WHIRL_FIELD_MODES_TWIST), axial = table_has(table, WHIRL_FIELD_MODES_AXIAL);
    units_point_label(of->units, table, table->count - 1, label, sizeof label);
    snprintf(
        figure->caption, sizeof figure->caption,
        "Shapes of the %zu lowest modes at %s, over %s: blue x, orange y%s%s; full lines at the instant at which the "
        "largest displacement peaks, dashed lines a quarter of a period later; marks at stations.%s",
        count, label,
        !places.shafts     ? "the stations"
        : places.aside > 0 ? "the place of the stations along the shaft, and those on no shaft"
                           : "the place of the stations along the shaft",
        twists ? ", purple the twist of torsional modes" : "",
        !axial   ? ""
        : twists ? " and the axial displacement of axial ones"
                 : ", purple the axial displacement of axial modes",
        along_caption(&places));
    layout_free(places.layout);
}

const figure_kind shapes_figure = {.list = shapes_list, .describe = shapes_describe};
