// Findings on derivatives: the parameters that change a number most, and a row for every number and point.
#include <math.h>

#include "number_name.h"
#include "sensitivity_view.h"
#include "shown_kinds.h"

/// A parameter of a map other than the first one.
typedef struct map_axis {
    const char *name; ///< "": the table has no such parameter
    double (*at)(const whirl_table *table, size_t point);
} map_axis;

enum { MORE_AXES = 2 };

static void map_axes(const whirl_table *table, map_axis axes[MORE_AXES]) {
    const bool map = table->role == WHIRL_ROLE_MAP;
    axes[0] = (map_axis){map ? table->second : "", whirl_table_second};
    axes[1] = (map_axis){map ? table->third : "", whirl_table_third};
}

/// States the parameters that change a number most at a point.
static void state_at(const finder *of, const whirl_spread_of *own, size_t number, size_t point) {
    enum { NAMED = 3 };
    size_t order[WHIRL_MAX_SENSITIVITIES];
    char name[NUMBER_NAME_SIZE];
    const size_t known = sensitivity_order(of->table, point, number, order);
    if (known == 0) return;
    number_name(of->table, own, name);
    whirl_statement *statement = find_statement(of, "sensitivity");
    statement_value(of, statement, point);
    map_axis axes[MORE_AXES];
    map_axes(of->table, axes);
    for (size_t i = 0; i < MORE_AXES && *axes[i].name; i++) {
        const whirl_unit unit = whirl_shown_parameter(of->units, axes[i].name);
        phrase_text(of, &statement->at, ", %s = ", axes[i].name);
        phrase_unit(of, &statement->at, &unit, 6, axes[i].at(of->table, point));
    }
    phrase_text(of, &statement->found, "%s changes", name);
    for (size_t k = 0; k < known && k < NAMED; k++) {
        phrase_text(of, &statement->found, k == 0 ? " by " : ", ");
        phrase_number(of, &statement->found, WHIRL_QUANTITY_PERCENT, 3,
                      sensitivity_of(of->table, point, number, order[k]).change);
        phrase_text(of, &statement->found, " for 1 %% more %s", sensitivity_parameter(of->result, order[k]));
    }
}

/// States the derivatives of the numbers that the case lists, else of the first usual ones, each at the point where it
/// is largest; for branches, at each special point.
static void state_numbers(const finder *of) {
    enum { STATED = 4, POINTS = 8 };
    const whirl_table *table = of->table;
    const bool asked = *whirl_result_fact(of->result, "derived 1") != '\0';
    whirl_spread_of own;
    size_t stated = 0;
    for (size_t i = 0; (asked || i < STATED) && whirl_table_derived(of->result, table, i, &own); i++) {
        if (whirl_layout_field(&table->layout, WHIRL_FIELD_TRACE_SPECIAL)) {
            for (size_t p = 0; p < table->count && stated < POINTS; p++)
                if (isfinite(sensitivity_of(table, p, i, 0).number) && ++stated) state_at(of, &own, i, p);
        } else if (sensitivity_largest(table, i) < table->count) {
            state_at(of, &own, i, sensitivity_largest(table, i));
        }
    }
}

/// States how many motions are not periodic, and the meaning of their derivatives if they have any.
static void state_not_periodic(const finder *of) {
    const whirl_table *table = of->table;
    const bool moves =
        table->role == WHIRL_ROLE_POINT || table->role == WHIRL_ROLE_SURVEY || table->role == WHIRL_ROLE_MAP;
    size_t others = 0, known = 0, done = 0;
    for (size_t point = 0; moves && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        done++;
        const whirl_regime regime = whirl_table_verdict(table, point).regime;
        if (regime != WHIRL_QUASI_PERIODIC && regime != WHIRL_CHAOTIC) continue;
        others++;
        bool any = false;
        whirl_spread_of own;
        for (size_t i = 0; whirl_table_derived(of->result, table, i, &own) && !any; i++)
            for (size_t p = 0; p < sensitivity_parameters(table) && !any; p++)
                any = isfinite(sensitivity_of(table, point, i, p).slope);
        known += any;
    }
    if (others == 0) return;
    whirl_statement *statement = find_statement(of, "sensitivity");
    if (known == 0)
        phrase_text(of, &statement->found,
                    "%zu of %zu motions are not periodic and have no derivatives; with `difference` they have "
                    "differences of records",
                    others, done);
    else
        phrase_text(of, &statement->found,
                    "%zu of %zu motions are not periodic: their derivatives are slopes over records at eight "
                    "neighbouring values, with 95 %% errors",
                    known, done);
}

void find_derivatives(const finder *of) {
    const whirl_table *table = of->table;
    const size_t parameters = sensitivity_parameters(table);
    whirl_spread_of own;
    if (parameters == 0) return;
    state_numbers(of);
    state_not_periodic(of);
    // Set up a column for each parameter.
    whirl_sheet *sheet = find_sheet(of, "sensitivity", "Sensitivity to parameters");
    sheet->about = "Change of a number if the parameter of the column grows by 1 %, all others as they are. The result "
                   "has the derivatives in SI, with their errors (sensitivity/slopes).";
    sheet->of_points = true;
    sheet_texts(of, sheet, "what", "of");
    sheet_values(of, sheet, "", 6);
    map_axis axes[MORE_AXES];
    map_axes(table, axes);
    for (size_t k = 0; k < MORE_AXES && *axes[k].name; k++) {
        const whirl_unit unit = whirl_shown_parameter(of->units, axes[k].name);
        const char *name = find_text(of->findings, "%s", axes[k].name);
        sheet_units(of, sheet, name, name, &unit, 6);
    }
    for (size_t p = 0; p < parameters; p++) {
        const char *name = find_text(of->findings, "%s", sensitivity_parameter(of->result, p));
        sheet_column(of, sheet, find_text(of->findings, "change_%s", name), name, WHIRL_QUANTITY_PERCENT, 4);
    }
    // Add a row for each number and point.
    for (size_t i = 0; whirl_table_derived(of->result, table, i, &own); i++) {
        char name[NUMBER_NAME_SIZE];
        number_name(table, &own, name);
        const char *what = find_text(of->findings, "%s", name);
        for (size_t point = 0; point < table->count; point++) {
            bool any = false;
            for (size_t p = 0; p < parameters && whirl_table_done(table, point); p++)
                any = any || isfinite(sensitivity_of(table, point, i, p).change);
            if (!any) continue;
            sheet_row(of, sheet);
            cell_text(of, sheet, what);
            cell_value(of, sheet, point);
            for (size_t k = 0; k < MORE_AXES && *axes[k].name; k++) cell_number(of, sheet, axes[k].at(table, point));
            for (size_t p = 0; p < parameters; p++) cell_number(of, sheet, sensitivity_of(table, point, i, p).change);
        }
    }
    find_sheet_end(of);
}
