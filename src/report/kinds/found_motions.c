// Shared by the findings on motions: kinds of tables, rows of points, weights of points.
#include "found_motions.h"

#include <math.h>
#include <stdlib.h>

#include "machine_at.h"
#include "quantities.h"
#include "regimes.h"
#include "shown_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

bool find_alone(const finder *of) {
    return !*of->table->parameter && !of->table->attractors && whirl_table_planned(of->table) == 1;
}

bool accompanying_motions(const whirl_table *table) {
    return table->role == WHIRL_ROLE_MOTIONS;
}

bool find_described_together(const whirl_table *table) {
    return accompanying_motions(table) || !whirl_layout_has_verdict(&table->layout);
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

void sheet_exponent(const finder *of, whirl_sheet *sheet) {
    sheet_list(of, sheet, "exponent", "largest exponent per revolution", WHIRL_QUANTITY_NUMBER, 6, " +- ");
}

void cell_exponent(const finder *of, whirl_sheet *sheet, size_t point) {
    const shown_estimate shown = estimate_shown(point_exponent(of->table, point));
    const double both[] = {shown.value, shown.error};
    cell_numbers(of, sheet, isfinite(shown.value) ? isfinite(shown.error) ? 2 : 1 : 0, both);
}

const whirl_probe *point_probes(const finder *of, size_t point, point_machine *own) {
    own->made = machine_at(of->machine, of->table, point, &own->machine);
    return own->made ? own->machine.system->probes : of->result->stations;
}

void point_release(point_machine *own) {
    if (own->made) own->machine.release(own->machine.owner);
}

void starts_count(const whirl_table *source, size_t *done, size_t *undetermined) {
    *done = *undetermined = 0;
    for (size_t i = 0; i < source->count; i++) {
        if (!whirl_table_done(source, i)) continue;
        ++*done;
        *undetermined += whirl_table_verdict(source, i).regime == WHIRL_UNDETERMINED;
    }
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
