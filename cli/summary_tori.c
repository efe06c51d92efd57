#include "summary_tori.h"

#include <math.h>
#include <stdio.h>

/// ", stable", ", unstable", ", 12 of them stable".
static void print_stability(const whirl_tori *own) {
    if (own->stable > 0 && own->stable < own->found)
        printf(", %zu of them stable", own->stable);
    else
        fputs(own->stable > 0 ? ", stable" : ", unstable", stdout);
}

/// "rotation number 0.39865 to 0.41552; second line of disc, y: order 0.60135 to 0.58448".
static void print_lines(const whirl_result *result, const whirl_table *table, const whirl_tori *own) {
    printf("      rotation number %.6g to %.6g", whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_ROTATION, 0),
           whirl_table_number(table, own->last, WHIRL_FIELD_TORUS_ROTATION, 0));
    if (own->station < result->station_count) {
        const double *first = whirl_table_field(table, own->first, WHIRL_FIELD_TORUS_FREQUENCY, own->station);
        const double *last = whirl_table_field(table, own->last, WHIRL_FIELD_TORUS_FREQUENCY, own->station);
        printf("; second line of %s, %c: order %.6g to %.6g", result->stations[own->station].name, "xy"[own->axis],
               first[own->axis], last[own->axis]);
    }
    putchar('\n');
}

static void print_end(const whirl_table *table, const whirl_unit *unit, size_t point) {
    const double *resonance = whirl_table_field(table, point, WHIRL_FIELD_TORUS_RESONANCE, 0);
    const double limit = whirl_table_number(table, point, WHIRL_FIELD_TORUS_LIMIT, 0);
    char text[WHIRL_MESSAGE_SIZE];
    whirl_torus_end_text(whirl_table_number(table, point, WHIRL_FIELD_TORUS_END, 0), resonance[0], resonance[1], text,
                         sizeof text);
    printf("    %14.9g%s%s  %s", table->values[point] / unit->size, *unit->name ? " " : "", unit->name, text);
    if (isfinite(limit)) printf(" at %.6g", limit / unit->size);
    putchar('\n');
}

static void print_tori(const whirl_result *result, const whirl_table *table, const whirl_unit *unit,
                       const whirl_tori *own) {
    printf("  torus %.0f: ", whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_NUMBER, 0));
    if (own->found > 0) printf("%zu point%s ", own->found, own->found == 1 ? "" : "s");
    printf("from %.6g%s%s, where branch %.0f changes",
           whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_BEGINS, 0) / unit->size, *unit->name ? " " : "",
           unit->name, whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_BRANCH, 0));
    if (own->found > 0) print_stability(own);
    putchar('\n');
    if (own->found > 0) print_lines(result, table, own);
    if (!isnan(whirl_table_number(table, own->last, WHIRL_FIELD_TORUS_END, 0))) print_end(table, unit, own->last);
}

void summarize_tori(const whirl_result *result, const whirl_table *table) {
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        const whirl_tori own = whirl_table_tori(table, point);
        print_tori(result, table, &unit, &own);
        point = own.last;
    }
}
