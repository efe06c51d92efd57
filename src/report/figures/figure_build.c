#include "figure_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- ranges

span span_empty(void) {
    return (span){(double)INFINITY, -(double)INFINITY};
}

void span_widen(span *range, double value) {
    if (!isfinite(value)) return;
    if (value < range->low) range->low = value;
    if (value > range->high) range->high = value;
}

bool span_has_any(span range) {
    return range.low <= range.high;
}

span span_with_margin(span range, double margin, double least) {
    if (!span_has_any(range)) return (span){0.0, 1.0};
    const double middle = 0.5 * (range.low + range.high);
    const double width = fmax((1.0 + 2.0 * margin) * (range.high - range.low), least);
    return (span){middle - 0.5 * width, middle + 0.5 * width};
}

span span_below_legend(span range) {
    const double legend = 0.16; // of the panel's height
    return (span){range.low, range.high + legend / (1.0 - legend) * (range.high - range.low)};
}

// ---------------------------------------------------------------- parts

/// Makes room for one more item in an array of `count` items. The array grows when `count` is 0 or a power of two: to
/// 1, or to twice the size.
static bool figure_make_room(whirl_figure *figure, void *array, size_t count, size_t size) {
    void **at = array;
    if (figure->failed) return false;
    if (count != 0 && (count & (count - 1)) != 0) return true;
    void *grown = realloc(*at, (count == 0 ? 1 : 2 * count) * size);
    if (grown)
        *at = grown;
    else
        figure->failed = true;
    return grown != NULL;
}

static char *copy_text(whirl_figure *figure, const char *text) {
    char *copy = malloc(strlen(text) + 1);
    if (copy)
        strcpy(copy, text);
    else
        figure->failed = true;
    return copy;
}

whirl_panel *figure_panel(whirl_figure *figure, const char *name, double width, double height) {
    whirl_panel *panel = calloc(1, sizeof *panel);
    if (!panel || !figure_make_room(figure, (void *)&figure->panels, figure->count, sizeof *figure->panels)) {
        free(panel);
        figure->failed = true;
        return NULL;
    }
    *panel = (whirl_panel){.width = width, .height = height};
    snprintf(panel->name, sizeof panel->name, "%s", name);
    panel->x = panel->y = (whirl_axis){.low = NAN, .high = NAN, .shown = true};
    figure->panels[figure->count++] = panel;
    return panel;
}

whirl_series *panel_named(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *name,
                          const char *colour, double size) {
    whirl_series *series = panel ? calloc(1, sizeof *series) : NULL;
    if (!series || !figure_make_room(figure, (void *)&panel->series, panel->count, sizeof *panel->series)) {
        free(series);
        figure->failed = true;
        return NULL;
    }
    *series = (whirl_series){.shape = shape, .opacity = 1.0, .size = size};
    snprintf(series->name, sizeof series->name, "%s", name);
    snprintf(series->colour, sizeof series->colour, "%s", colour);
    panel->series[panel->count++] = series;
    return series;
}

whirl_series *panel_series(whirl_figure *figure, whirl_panel *panel, whirl_shape shape, const char *colour,
                           double size) {
    return panel_named(figure, panel, shape, "", colour, size);
}

static bool figure_add(whirl_figure *figure, whirl_series *series, double x, double y) {
    if (!series || !figure_make_room(figure, (void *)&series->x, series->count, sizeof *series->x) ||
        !figure_make_room(figure, (void *)&series->y, series->count, sizeof *series->y))
        return false;
    series->x[series->count] = x;
    series->y[series->count] = y;
    return true;
}

void series_add(whirl_figure *figure, whirl_series *series, double x, double y) {
    if (figure_add(figure, series, x, y)) series->count++;
}

void series_break(whirl_figure *figure, whirl_series *series) {
    if (!series || series->count == 0 || isnan(series->x[series->count - 1])) return;
    if (series->y_to)
        series_add_to(figure, series, NAN, NAN, NAN);
    else
        series_add(figure, series, NAN, NAN);
}

void series_add_to(whirl_figure *figure, whirl_series *series, double x, double y, double y_to) {
    if (!figure_add(figure, series, x, y) ||
        !figure_make_room(figure, (void *)&series->y_to, series->count, sizeof *series->y_to))
        return;
    series->y_to[series->count++] = y_to;
}

void series_add_box(whirl_figure *figure, whirl_series *series, span x, span y) {
    if (!figure_add(figure, series, x.low, y.low) ||
        !figure_make_room(figure, (void *)&series->x_to, series->count, sizeof *series->x_to) ||
        !figure_make_room(figure, (void *)&series->y_to, series->count, sizeof *series->y_to))
        return;
    series->x_to[series->count] = x.high;
    series->y_to[series->count++] = y.high;
}

void series_value(whirl_figure *figure, whirl_series *series, double value) {
    if (!series || series->count == 0) return;
    const size_t at = series->count - 1;
    if (figure_make_room(figure, (void *)&series->values, at, sizeof *series->values)) series->values[at] = value;
}

void series_add_text(whirl_figure *figure, whirl_series *series, double x, double y, const char *text) {
    if (!figure_add(figure, series, x, y) ||
        !figure_make_room(figure, (void *)&series->texts, series->count, sizeof *series->texts))
        return;
    series->texts[series->count] = copy_text(figure, text);
    if (series->texts[series->count]) series->count++;
}

void panel_spot(whirl_figure *figure, whirl_panel *panel, const char *station, span x, span y) {
    if (!panel || !figure_make_room(figure, (void *)&panel->spots, panel->spot_count, sizeof *panel->spots)) return;
    whirl_spot *own = &panel->spots[panel->spot_count++];
    *own = (whirl_spot){.x = x.low, .y = y.low, .x_to = x.high, .y_to = y.high};
    snprintf(own->station, sizeof own->station, "%s", station);
}

void axis_tick(whirl_figure *figure, whirl_axis *axis, double at, const char *text) {
    if (!figure_make_room(figure, (void *)&axis->ticks, axis->tick_count, sizeof *axis->ticks) ||
        !figure_make_room(figure, (void *)&axis->tick_texts, axis->tick_count, sizeof *axis->tick_texts))
        return;
    axis->ticks[axis->tick_count] = at;
    axis->tick_texts[axis->tick_count] = copy_text(figure, text);
    if (axis->tick_texts[axis->tick_count]) axis->tick_count++;
}

void axis_show(whirl_axis *axis, span range) {
    const bool finite = isfinite(range.low) && isfinite(range.high) && isfinite(range.high - range.low);
    axis->low = finite ? range.low : (double)NAN;
    axis->high = finite ? range.high : (double)NAN;
}

whirl_series *panel_level(whirl_figure *figure, whirl_panel *panel, double y, const char *colour, double width) {
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, colour, width);
    if (!line) return NULL;
    series_add(figure, line, panel->x.low, y);
    series_add(figure, line, panel->x.high, y);
    return line;
}

whirl_series *panel_upright(whirl_figure *figure, whirl_panel *panel, double x, const char *colour, double width) {
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, colour, width);
    if (!line) return NULL;
    series_add(figure, line, x, panel->y.low);
    series_add(figure, line, x, panel->y.high);
    return line;
}

// ---------------------------------------------------------------- freeing

static void free_texts(char **texts, size_t count) {
    for (size_t i = 0; texts && i < count; i++) free(texts[i]);
    free((void *)texts);
}

static void free_axis(const whirl_axis *axis) {
    free(axis->ticks);
    free_texts(axis->tick_texts, axis->tick_count);
}

static void free_panel(whirl_panel *panel) {
    for (size_t i = 0; i < panel->count; i++) {
        whirl_series *series = panel->series[i];
        free(series->x);
        free(series->y);
        free(series->x_to);
        free(series->y_to);
        free(series->values);
        free_texts(series->texts, series->count);
        free(series);
    }
    free((void *)panel->series);
    free(panel->spots);
    free_axis(&panel->x);
    free_axis(&panel->y);
    free(panel);
}

void whirl_figure_free(whirl_figure *figure) {
    for (size_t i = 0; figure && i < figure->count; i++) free_panel(figure->panels[i]);
    if (!figure) return;
    free((void *)figure->panels);
    free(figure->scale.ticks);
    free_texts(figure->scale.tick_texts, figure->scale.tick_count);
    free(figure);
}

static bool is_named(const char *names, const char *name) {
    const size_t length = strlen(name);
    for (const char *at = names; at && *at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
        if (strncmp(at, name, length) == 0 && (at[length] == ',' || at[length] == '\0')) return true;
    return false;
}

whirl_status figure_choose(whirl_figure *figure, const char *names) {
    size_t kept = 0;
    char all[WHIRL_MESSAGE_SIZE / 2] = "";
    // Reject names that no panel has, and list the names of panels.
    for (const char *at = names; *at;) {
        const size_t length = strcspn(at, ",");
        bool found = false;
        for (size_t i = 0; i < figure->count; i++)
            found = found ||
                    (strlen(figure->panels[i]->name) == length && strncmp(at, figure->panels[i]->name, length) == 0);
        for (size_t i = 0, used = 0; i < figure->count && !found && used + WHIRL_NAME_SIZE < sizeof all; i++)
            used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", figure->panels[i]->name);
        if (!found)
            return whirl_fail(WHIRL_BAD_INPUT, "%.100s has no panel '%.*s', expected one of %s", figure->name,
                              (int)(length < 64 ? length : 64), at, all);
        at += length + (at[length] == ',');
    }
    // Keep the named panels; the last of them shows the axis that panels share.
    for (size_t i = 0; i < figure->count; i++) {
        whirl_panel *panel = figure->panels[i];
        if (is_named(names, panel->name))
            figure->panels[kept++] = panel;
        else
            free_panel(panel);
    }
    figure->count = kept;
    if (kept > 0) figure->panels[kept - 1]->x.shown = true;
    return whirl_ok();
}
