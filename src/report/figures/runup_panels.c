// What figures of run-ups share.
#include "runup_panels.h"

#include <stdio.h>
#include <string.h>

static bool runup_is_done(const whirl_table *table, size_t point) {
    return whirl_table_done(table, point) && whirl_table_number(table, point, WHIRL_FIELD_RUNUP_END, 0) >= 0.0;
}

size_t runup_list_runs(const whirl_table *table, size_t runs[MAX_RUNS]) {
    size_t count = 0;
    for (size_t point = 0; point < table->count && count < MAX_RUNS; point++)
        if (runup_is_done(table, point)) runs[count++] = point;
    return count;
}

void runup_caption_run(const drawing *of, const whirl_table *table, whirl_figure *figure) {
    const size_t used = strlen(figure->caption);
    char label[UNIT_LABEL_SIZE] = "";
    size_t runs[MAX_RUNS], done = 0;
    for (size_t point = 0; point < table->count; point++) done += runup_is_done(table, point);
    if (done <= 1) return;
    runup_list_runs(table, runs);
    units_point_label(of->units, table, runs[0], label, sizeof label);
    snprintf(figure->caption + used, sizeof figure->caption - used, " The run at %s, the first of %zu.", label, done);
}

double runup_label_over(const drawing *of, whirl_axis *axis, bool by_speed) {
    const whirl_unit *unit = &of->units->of[by_speed ? WHIRL_QUANTITY_SPEED : WHIRL_QUANTITY_TIME];
    snprintf(axis->label, sizeof axis->label, "%s (%s)", by_speed ? "speed" : "time", unit->name);
    return unit->size;
}

whirl_status runup_find(const drawing *of, const char *name, const char *stem, const char *field, const char *option) {
    if (strncmp(name, stem, strlen(stem)) != 0) return whirl_ok();
    for (size_t t = 0; t < of->result->table_count; t++)
        if (table_has(&of->result->tables[t], field)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "there is no figure '%.80s': 'study: {runup: {..., %s: ...}}' in a case has one",
                      name, option);
}
