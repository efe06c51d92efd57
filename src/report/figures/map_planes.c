#include "map_planes.h"

#include <math.h>
#include <stdio.h>

#include "figures.h"
#include "typeset.h"

bool map_planes_make(const whirl_shown_units *units, const whirl_table *table, map_planes *planes) {
    const size_t all = whirl_table_planes(table), count = all < MOST_PLANES ? all : MOST_PLANES;
    *planes = (map_planes){.units = units, .table = table, .count = count};
    for (size_t k = 0; k < count; k++) {
        const size_t plane = count > 1 ? k * (all - 1) / (count - 1) : 0;
        if (!map_cells_make(units, table, plane, &planes->cells[k])) return false;
    }
    return true;
}

void map_planes_free(map_planes *planes) {
    for (size_t k = 0; k < planes->count; k++) map_cells_free(&planes->cells[k]);
}

/// Panels side by side: up to three, or as many as above each other, or one more.
static size_t panels_across(const map_planes *planes) {
    return planes->count <= 3 ? planes->count : (size_t)ceil(sqrt((double)planes->count));
}

double map_planes_height(const map_planes *planes, double single) {
    const size_t across = panels_across(planes), down = (planes->count + across - 1) / across;
    return planes->count > 1 ? 2.4 + 15.0 / (double)across * 0.9 * (double)down : single;
}

/// The value of the third parameter in a plane, above its panel.
static void write_value(FILE *script, const map_planes *planes, size_t k) {
    const whirl_table *table = planes->table;
    const whirl_unit unit = whirl_shown_parameter(planes->units, table->third);
    char symbol[TYPESET_SIZE / 2], words[2 * WHIRL_NAME_SIZE], label[TYPESET_SIZE];
    typeset_symbol(table->third, symbol, sizeof symbol);
    typeset_text(unit.name, words, sizeof words);
    if (isnan(planes->cells[k].z)) return;
    snprintf(label, sizeof label, "%s = %.4g%s%s", symbol, planes->cells[k].z, *words ? " " : "", words);
    script_label(script, "plane_label", label);
    fputs("set label 2 plane_label at graph 0.5, graph 1 center offset 0, 0.6 font small_font\n", script);
}

void map_planes_panel(FILE *script, const map_planes *planes, size_t k, map_area area) {
    if (planes->count == 1) {
        script_panel(script, area.left, area.right, area.bottom, area.top);
        fputs("set xlabel parameter_label\nset ylabel second_label\n", script);
        return;
    }
    const map_cells *cells = &planes->cells[0];
    const size_t across = panels_across(planes), down = (planes->count + across - 1) / across;
    const double wide = (area.right - area.left) / (double)across, high = (area.top - area.bottom) / (double)down;
    const double left = area.left + wide * (double)(k % across), top = area.top - high * (double)(k / across);
    script_panel(script, left, left + 0.93 * wide, top - 0.86 * high, top);
    const bool lowest = k + across >= planes->count;
    fprintf(script, "%s\nset format x '%s'\n", lowest ? "set xlabel parameter_label" : "unset xlabel",
            lowest ? "% h" : "");
    fprintf(script, "%s\nset format y '%s'\n", k % across == 0 ? "set ylabel second_label" : "unset ylabel",
            k % across == 0 ? "% h" : "");
    if (!cells->x_ratios)
        fprintf(script, "set xtics %.10g\n",
                tic_step(fabs(cells->x[cells->columns] - cells->x[0]), across > 2 ? 6 : 9));
    write_value(script, planes, k);
}

void map_planes_note(const map_planes *planes, char *text, size_t size) {
    const size_t all = whirl_table_planes(planes->table);
    *text = '\0';
    if (all > planes->count)
        snprintf(text, size, " Of %zu planes %zu are shown.", all, planes->count);
    else if (all > 1)
        snprintf(text, size, " A panel for every %.63s.", planes->table->third);
}
