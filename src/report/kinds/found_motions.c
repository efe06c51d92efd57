// What the findings on motions share: kinds of tables, rows of points, weights of points.
#include "found_motions.h"

#include <stdlib.h>

#include "regimes.h"
#include "shown_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

bool find_alone(const finder *of) {
    return !*of->table->parameter && !of->table->attractors && whirl_table_planned(of->table) == 1;
}

bool motions_beside(const whirl_table *table) {
    return table->role == WHIRL_ROLE_MOTIONS;
}

bool find_beside_asked(const whirl_table *table) {
    return motions_beside(table) || !whirl_layout_has_verdict(&table->layout);
}

void sheet_points(const finder *of, whirl_sheet *sheet) {
    sheet_values(of, sheet, "", 6);
    if (of->table->attractors) sheet_column(of, sheet, "attractor", "attractor", WHIRL_QUANTITY_NUMBER, 6);
}

void cells_point(const finder *of, whirl_sheet *sheet, size_t point) {
    const whirl_table *table = of->table;
    cell_value(of, sheet, point);
    if (!table->attractors) return;
    cell_number(of, sheet, (double)table->attractors[point].number);
    cell_colour(of, sheet, attractor_colour(table->attractors[point].number));
}

void cell_regime(const finder *of, whirl_sheet *sheet, const char *name, regime_class kind) {
    cell_text(of, sheet, find_text(of->findings, "%s", name));
    cell_colour(of, sheet, regime_class_colour(kind));
}

bool motions_weights(const finder *of, size_t **weights) {
    const whirl_table *table = of->table;
    const size_t grid = whirl_table_grid(table);
    *weights = NULL;
    if (table->refine == 0) return true;
    size_t *own = *weights = calloc(table->count + 1, sizeof *own), *cover = calloc(grid + 1, sizeof *cover);
    if (cover) whirl_table_cover(table, cover);
    for (size_t i = 0; own && cover && i < grid; i++) own[cover[i]] += cover[i] < table->count;
    const bool made = own && cover;
    free(cover);
    if (!made) of->findings->failed = true;
    return made;
}
