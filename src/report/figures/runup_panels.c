// Panels that several figures of run-ups share.
#include "runup_panels.h"
#include "figure_build.h"
#include "units.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const shaft_torque_names[SHAFT_TORQUES] = {"motor", "load", "friction", "rotor", "drag"};

static bool runup_is_done(const whirl_table *table, size_t point) {
    return whirl_table_done(table, point) && whirl_table_number(table, point, WHIRL_FIELD_RUNUP_END, 0) >= 0.0;
}

size_t runup_list_runs(const whirl_table *table, size_t runs[MAX_RUNS]) {
    size_t count = 0;
    for (size_t point = 0; point < table->count && count < MAX_RUNS; point++)
        if (runup_is_done(table, point)) runs[count++] = point;
    return count;
}

void runup_show_below_legend(whirl_panel *panel) {
    span range = span_empty();
    panel->keyed = true;
    for (size_t i = 0; i < panel->count; i++)
        for (size_t k = 0; k < panel->series[i]->count; k++) span_widen(&range, panel->series[i]->y[k]);
    const double size = 0.1 * fmax(fabs(range.low), fabs(range.high));
    axis_show(&panel->y, span_below_legend(span_with_margin(range, 0.06, size > 0.0 ? size : 1.0)));
}

void runup_caption_runs(const drawing *of, const whirl_table *table, size_t shown, whirl_figure *figure) {
    const size_t used = strlen(figure->caption);
    char label[UNIT_LABEL_SIZE] = "";
    size_t runs[MAX_RUNS], done = 0;
    for (size_t point = 0; point < table->count; point++) done += runup_is_done(table, point);
    if (done <= shown) return;
    runup_list_runs(table, runs);
    units_point_label(of->units, table, runs[0], label, sizeof label);
    if (shown == 1)
        snprintf(figure->caption + used, sizeof figure->caption - used, " The run at %s, the first of %zu.", label,
                 done);
    else
        snprintf(figure->caption + used, sizeof figure->caption - used, " The first %zu of %zu runs.", shown, done);
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

void runup_label_speeds(const drawing *of, whirl_figure *figure, whirl_panel *panel, const whirl_series *line,
                        const double *speeds) {
    enum { MAX_LABELS = 8 };
    const double unit = of->units->of[WHIRL_QUANTITY_SPEED].size;
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, line->colour, 2.0);
    whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#404040", 5.5);
    if (!dots || !texts) return;
    double length = 0.0, passed = 0.0, next = 0.0;
    for (size_t k = 1; k < line->count; k++) length += hypot(line->x[k] - line->x[k - 1], line->y[k] - line->y[k - 1]);
    texts->movable = true;
    texts->side = WHIRL_RIGHT;
    for (size_t k = 0; k < line->count; k++) {
        char text[32];
        if (k > 0) passed += hypot(line->x[k] - line->x[k - 1], line->y[k] - line->y[k - 1]);
        if (passed < next && k + 1 < line->count) continue;
        snprintf(text, sizeof text, "%.4g", speeds[k] / unit);
        series_add(figure, dots, line->x[k], line->y[k]);
        series_add_text(figure, texts, line->x[k], line->y[k], text);
        while (next <= passed) next += length > 0.0 ? length / MAX_LABELS : 1.0;
    }
}
