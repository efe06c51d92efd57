// Campbell's diagram: frequencies and damping of modes over a parameter, with critical speeds and thresholds; and the
// logarithmic decrement of modes by name.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asked.h"
#include "figure_build.h"
#include "figure_kinds.h"
#include "margins.h"
#include "mode_lines.h"
#include "shown_kinds.h"
#include "speed_unit.h"
#include "units.h"

enum { MAX_CRITICAL = 256 };

/// Names, colours and marks of modes: forward, backward, to and fro; torsional; axial.
static const struct {
    int way;
    const char *name, *colour;
    whirl_mark mark;
} directions[] = {{MODE_FORWARD, "forward", "#0072B2", WHIRL_UP},
                  {MODE_BACKWARD, "backward", "#D55E00", WHIRL_DOWN},
                  {MODE_TO_AND_FRO, "", "#606060", WHIRL_SQUARE},
                  {MODE_TORSIONAL, "torsional", "#009E73", WHIRL_DIAMOND},
                  {MODE_AXIAL, "axial", "#CC79A7", WHIRL_FRAME}};

typedef struct view {
    const drawing *of;
    const whirl_table *table;
    speed_unit unit;  ///< unit of frequencies
    double top;       ///< largest frequency shown, in its unit
    double size;      ///< size of the parameter's unit, in SI
    mode_lines lines; ///< empty if modes were not followed
} view;

static const double *frequencies_of(const view *v, size_t point) {
    return whirl_table_done(v->table, point) ? whirl_table_field(v->table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)
                                             : NULL;
}

/// Returns a mode's frequency in its shown unit, or a number of a field.
static double height_of(const view *v, const char *field, size_t point, size_t mode) {
    const bool frequency = strcmp(field, WHIRL_FIELD_MODES_FREQUENCY) == 0;
    return whirl_table_field(v->table, point, field, 0)[mode] / (frequency ? v->unit.size : 1.0);
}

static size_t modes_of(const view *v) {
    return whirl_layout_field(&v->table->layout, WHIRL_FIELD_MODES_FREQUENCY)->rows;
}

// ---------------------------------------------------------------- ranges

/// Returns the highest frequency to show. If the parameter is a speed, this frequency is above all crossings, and above
/// all frequencies below twice the largest speed.
static double top_of(const view *v) {
    double fastest = 0.0, highest = 0.0, lowest = (double)INFINITY, near = 0.0;
    for (size_t point = 0; v->unit.of_speed && point < v->table->count; point++)
        if (whirl_table_done(v->table, point))
            fastest = fmax(fastest, fabs(whirl_table_number(v->table, point, WHIRL_FIELD_MODES_SPEED, 0)));
    for (size_t point = 0; point < v->table->count; point++) {
        const double *frequency = frequencies_of(v, point);
        for (size_t i = 0; frequency && i < modes_of(v) && !mode_is_overdamped(v->table, point, i); i++) {
            highest = fmax(highest, frequency[i]);
            lowest = fmin(lowest, frequency[i]);
            if (frequency[i] <= 2.0 * fastest) near = fmax(near, frequency[i]);
        }
    }
    const bool cut = fastest > 0.0 && 2.0 * fastest < highest;
    const double top = cut ? fmax(fmin(2.0 * fastest, 1.1 * fmax(fastest, near)), 1.2 * lowest) : 1.05 * highest;
    return top > 0.0 ? top / v->unit.size : 1.0;
}

/// Returns the range of a damping field to show. Damping above `most` is cut off, unless even the least damping is near
/// or above it.
static span damping_of(const view *v, const char *field, double most) {
    span shown = {0.0, 0.0};
    double least = (double)INFINITY;
    for (int pass = 0; pass < 2; pass++)
        for (size_t point = 0; point < v->table->count; point++) {
            const double *frequency = frequencies_of(v, point);
            const double *damping = whirl_table_field(v->table, point, field, 0);
            for (size_t i = 0; frequency && i < modes_of(v) && !mode_is_overdamped(v->table, point, i); i++) {
                if (!(frequency[i] <= v->top * v->unit.size)) continue;
                if (pass == 0) least = fmin(least, damping[i]);
                if (pass == 1 && damping[i] <= fmax(most, 1.5 * least)) span_widen(&shown, damping[i]);
            }
        }
    // Widen a range that is as small as rounding.
    return span_with_margin(shown, 0.08, shown.high - shown.low > 1e-10 ? 0.0 : 0.02);
}

// ---------------------------------------------------------------- modes

/// Adds dots of modes in the colours of their whirl, and marks on some of them.
static void add_modes(whirl_figure *figure, whirl_panel *panel, const view *v, const char *field) {
    const size_t few = v->table->count / 25 + 1;
    for (size_t d = 0; d < sizeof directions / sizeof *directions; d++) {
        whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, directions[d].colour, 0.45);
        whirl_series *marks = panel_named(figure, panel, WHIRL_DOTS, directions[d].name, directions[d].colour, 2.2);
        if (marks) marks->mark = directions[d].mark;
        for (size_t point = 0; point < v->table->count; point++) {
            const double *frequency = frequencies_of(v, point);
            for (size_t i = 0; frequency && i < modes_of(v) && isfinite(frequency[i]); i++) {
                if (mode_is_overdamped(v->table, point, i)) break; // overdamped modes are the last
                if (mode_way(v->table, point, i) != directions[d].way ||
                    height_of(v, WHIRL_FIELD_MODES_FREQUENCY, point, i) > v->top)
                    continue;
                const double x = v->table->values[point] / v->size, y = height_of(v, field, point, i);
                series_add(figure, dots, x, y);
                if (point % few == 0) series_add(figure, marks, x, y);
            }
        }
    }
}

/// The end of a line at its largest parameter value, where its name is written.
typedef struct line_end {
    size_t line, points; ///< index of the line; number of its shown points
    double at, number, height;
    double step; ///< `number` rounded to a step too small to see; names are ordered by it, so that rounding errors do
                 ///< not change their order
    const char *name, *colour;
} line_end;

static int by_height(const void *a, const void *b) {
    const line_end *p = a, *q = b;
    if (p->step != q->step) return p->step < q->step ? -1 : 1;
    return p->line < q->line ? -1 : p->line > q->line;
}

/// Moves names apart so that none overlaps another, as near to their lines as possible.
static void spread_names(const whirl_panel *panel, line_end *ends, size_t count, double apart) {
    enum { ROUNDS = 200 };
    const double low = panel->y.low + 0.5 * apart, high = panel->y.high - 0.5 * apart;
    for (size_t i = 0; i < count; i++) ends[i].height = fmin(fmax(ends[i].number, low), high);
    for (int round = 0; round < ROUNDS; round++)
        for (size_t i = 0; i + 1 < count; i++) {
            const double lack = apart - (ends[i + 1].height - ends[i].height);
            if (lack <= 0.0) continue;
            ends[i].height = fmax(ends[i].height - 0.5 * lack, low);
            ends[i + 1].height = fmin(ends[i + 1].height + 0.5 * lack, high);
        }
    for (size_t i = 1; i < count; i++) ends[i].height = fmax(ends[i].height, ends[i - 1].height + apart);
    for (size_t i = count; i-- > 0;)
        ends[i].height = fmin(ends[i].height, i + 1 < count ? ends[i + 1].height - apart : high);
}

/// Adds the names of lines that end at the right edge, as many as fit, each with a stroke from its line.
static void add_names(whirl_figure *figure, whirl_panel *panel, line_end *ends, size_t count) {
    const double apart = 0.29 / panel->height * (panel->y.high - panel->y.low); // 0.29 cm
    const double stroke = 0.02 * (panel->x.high - panel->x.low);
    const size_t room = (size_t)((panel->y.high - panel->y.low) / apart);
    for (size_t i = 0; i < count; i++) ends[i].step = rint(1e6 * ends[i].number / (panel->y.high - panel->y.low));
    qsort(ends, count, sizeof *ends, by_height);
    if (count > room) count = room;
    spread_names(panel, ends, count, apart);
    for (size_t i = 0; i < count; i++) {
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, ends[i].colour, 0.3);
        whirl_series *name = panel_series(figure, panel, WHIRL_TEXTS, ends[i].colour, 1.0);
        series_add(figure, line, ends[i].at, ends[i].number);
        series_add(figure, line, ends[i].at + stroke, ends[i].height);
        if (name) name->side = WHIRL_BESIDE;
        series_add_text(figure, name, ends[i].at + stroke, ends[i].height, ends[i].name);
    }
}

/// Adds one line as far as its frequencies are shown. Returns its end, whose number is NaN if no part is visible.
static line_end add_line(whirl_figure *figure, whirl_series *series, const view *v, size_t line, const char *field) {
    const mode_lines *lines = &v->lines;
    line_end end = {.line = line, .at = -INFINITY, .number = NAN, .name = lines->names[line]};
    for (size_t point = 0; point < v->table->count; point++) {
        const double x = v->table->values[point] / v->size;
        size_t i = 0;
        while (i < lines->modes && lines->line[point * lines->modes + i] != line) i++;
        if (i < lines->modes && height_of(v, WHIRL_FIELD_MODES_FREQUENCY, point, i) <= v->top) {
            const double y = height_of(v, field, point, i);
            series_add(figure, series, x, y);
            end.points++;
            if (x > end.at) end.at = x, end.number = y;
        } else {
            series_break(figure, series);
        }
    }
    return end;
}

/// Adds all lines. coloured: each in its own colour with its name where it ends, dashed for modes that do not whirl
/// forward; else thin and grey, with names only at the right edge. named: false leaves out all names.
static void add_lines(whirl_figure *figure, whirl_panel *panel, const view *v, const char *field, bool coloured,
                      bool named) {
    const double edge = fmax(v->table->values[0], v->table->values[v->table->count - 1]) / v->size;
    line_end *ends = calloc(v->lines.count + 1, sizeof *ends);
    size_t count = 0;
    for (size_t i = 0; ends && i < v->lines.count; i++) {
        const char *const colour = coloured ? line_colour(i) : "#B0B0B0";
        whirl_series *series = panel_series(figure, panel, WHIRL_LINE, colour, coloured ? 0.8 : 0.3);
        line_end end = add_line(figure, series, v, i, field);
        end.colour = coloured ? colour : "#000000";
        if (series) series->dashed = coloured && !strchr(end.name, 'F');
        if (!named || !(end.number >= panel->y.low && end.number <= panel->y.high)) continue;
        if (end.at == edge) ends[count++] = end;
        if (!coloured || end.at == edge) continue;
        if (end.points == 1) // a line of one point would be invisible
            series_add(figure, panel_series(figure, panel, WHIRL_DOTS, colour, 2.2), end.at, end.number);
        whirl_series *name = panel_series(figure, panel, WHIRL_TEXTS, colour, 1.0);
        if (name) name->side = WHIRL_BESIDE;
        series_add_text(figure, name, end.at, end.number, end.name);
    }
    if (ends) add_names(figure, panel, ends, count);
    free(ends);
}

static void add_synchronous(whirl_figure *figure, whirl_panel *panel, const view *v) {
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, "1X", "#9A9A9A", 0.4);
    if (line) line->dashed = true;
    for (size_t point = 0; point < v->table->count; point++)
        if (whirl_table_done(v->table, point))
            series_add(figure, line, v->table->values[point] / v->size,
                       whirl_table_number(v->table, point, WHIRL_FIELD_MODES_SPEED, 0) / v->unit.size);
}

/// Adds the excitations of torsion except 1X, each with its name at its end.
static void add_excitations(whirl_figure *figure, whirl_panel *panel, const view *v) {
    for (int k = 0; k < torsion_excitation_count(v->table); k++) {
        // Leave out 1X of the shaft, which has its own line.
        const torsion_excitation by = torsion_excitation_at(v->table, k);
        if (!by.line && by.order == 1) continue;
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#9A9A9A", 0.3);
        whirl_series *name = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
        // Draw its frequency over the speed, as far as the axis goes.
        double x = NAN, y = NAN;
        for (size_t point = 0; point < v->table->count; point++) {
            if (!whirl_table_done(v->table, point)) continue;
            const double speed = whirl_table_number(v->table, point, WHIRL_FIELD_MODES_SPEED, 0);
            const double height = torsion_excitation_frequency(v->table, by, speed) / v->unit.size;
            if (height > v->top) continue;
            x = v->table->values[point] / v->size;
            y = height;
            series_add(figure, line, x, y);
        }
        // Write its name at the last drawn point.
        char text[24];
        if (by.line)
            snprintf(text, sizeof text, "%sline", by.order == 1 ? "" : "2 x ");
        else
            snprintf(text, sizeof text, "%dX", by.order);
        if (line) line->dashed = true;
        if (name) name->side = WHIRL_LEFT;
        if (name) name->movable = true;
        if (isfinite(y)) series_add_text(figure, name, x, y, text);
    }
}

/// Adds the bounds of the running speeds, if the parameter is a speed.
static void add_running(whirl_figure *figure, whirl_panel *panel, const view *v) {
    double ends[2];
    if (!v->unit.of_speed || !margin_running(v->table, &ends[0], &ends[1])) return;
    for (size_t i = 0; i < 2; i++) {
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#56B4E9", 0.4);
        series_add(figure, line, ends[i] / v->size, 0.0);
        series_add(figure, line, ends[i] / v->size, v->top);
    }
}

// ---------------------------------------------------------------- critical speeds and thresholds

/// Collects the critical speeds of all points in order. Returns their number, at most `room`.
static size_t gather_critical(const whirl_table *table, size_t room, const double **rows) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t count = 0;
    for (size_t point = 0; field && point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (isfinite(row[0]) && count < room) rows[count++] = row;
    }
    return count;
}

/// Returns the side of a mark on which its value is written: right, or left if the next mark or the edge is near.
static whirl_side side_of(const whirl_table *table, const double *const *rows, size_t count, size_t i) {
    const double first = table->values[0], last = table->values[table->count - 1];
    const double near = 0.1 * fabs(last - first);
    const bool crowded = i + 1 < count && fabs(rows[i + 1][1] - rows[i][1]) < near;
    return crowded || fmax(first, last) - rows[i][1] < near ? WHIRL_LEFT : WHIRL_RIGHT;
}

static void add_critical(whirl_figure *figure, whirl_panel *panel, const view *v, bool damping) {
    const double *rows[MAX_CRITICAL];
    const size_t count = gather_critical(v->table, MAX_CRITICAL, rows);
    // Critical speeds are marked only in the panel of frequencies, thresholds of stability in both.
    whirl_series *rings = damping ? NULL : panel_named(figure, panel, WHIRL_DOTS, "critical speed", "#000000", 3.6);
    whirl_series *crosses = panel_named(figure, panel, WHIRL_DOTS, "threshold", "#CC0000", 3.6);
    whirl_series *right = damping ? NULL : panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    whirl_series *left = damping ? NULL : panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    if (rings) rings->mark = WHIRL_RING;
    if (crosses) crosses->mark = WHIRL_CROSS;
    if (right) right->side = WHIRL_RIGHT;
    if (left) left->side = WHIRL_LEFT;
    if (right) right->movable = true;
    if (left) left->movable = true;
    // Draw each of them, with its value.
    for (size_t i = 0; i < count; i++) {
        const double x = rows[i][1] / v->size, frequency = rows[i][3] / v->unit.size;
        char text[32];
        snprintf(text, sizeof text, "%.5g", x);
        if ((rows[i][0] == WHIRL_ONSET || rows[i][0] == WHIRL_RECOVERY) && (!damping || frequency <= v->top))
            series_add(figure, crosses, x, damping ? rows[i][4] : frequency);
        if (damping || frequency > v->top) continue;
        if (rows[i][0] == WHIRL_CRITICAL_SPEED) series_add(figure, rings, x, frequency);
        series_add_text(figure, side_of(v->table, rows, count, i) == WHIRL_LEFT ? left : right, x, frequency, text);
    }
}

// ---------------------------------------------------------------- the figure

static void campbell_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &campbell_figure, .table = table, .point = NO_POINT};
    (void)of;
    if (table_has(table, WHIRL_FIELD_MODES_FREQUENCY) && table->count > 1)
        list_figure(to, &place, "campbell", "Campbell diagram over %s", table->parameter);
}

/// Returns the range of the parameter, with room at the right for names of followed modes.
static span campbell_range(const view *v) {
    span range = span_empty();
    for (size_t i = 0; i < v->table->count; i++) span_widen(&range, v->table->values[i] / v->size);
    if (v->lines.count > 0) range.high += 0.07 * (range.high - range.low);
    return span_with_margin(range, 0.0, 1e-300);
}

/// Makes the view of a table; the caller frees its lines.
static view view_of(const drawing *of, const whirl_table *table) {
    view v = {.of = of, .table = table, .unit = speed_unit_of(of, table, WHIRL_FIELD_MODES_SPEED)};
    v.size = whirl_shown_parameter(of->units, table->parameter).size;
    v.top = top_of(&v);
    mode_lines_of(table, &v.lines);
    return v;
}

static void campbell_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Set up both panels with a common axis of speeds.
    whirl_panel *frequency = figure_panel(figure, "frequency", 1.0, 5.3);
    whirl_panel *damping = figure_panel(figure, "damping", 1.0, 3.4);
    if (!frequency || !damping) return;
    view v = view_of(of, place->table);
    symbol_parameter(of->units, v.table->parameter, damping->x.label, sizeof damping->x.label);
    frequency->x = damping->x;
    frequency->x.shown = false;
    axis_show(&frequency->x, campbell_range(&v));
    axis_show(&damping->x, campbell_range(&v));
    axis_show(&frequency->y, (span){0.0, v.top});
    // Leave out modes that hardly show in a response. API 617 asks for no margin from peaks with an amplification below
    // 2.5. One degree of freedom with unbalance is below 2.5 if its damping ratio is above 0.17 (docs/theory.md); the
    // axis ends a little above that.
    axis_show(&damping->y, damping_of(&v, WHIRL_FIELD_MODES_DAMPING_RATIO, 0.25));
    snprintf(frequency->y.label, sizeof frequency->y.label, "damped frequency (%.40s)", v.unit.name);
    snprintf(damping->y.label, sizeof damping->y.label, "damping ratio");
    // Draw frequencies: the running speed, excitations, modes and critical speeds.
    const bool torsion = table_has(v.table, WHIRL_FIELD_MODES_TORSION);
    add_running(figure, frequency, &v);
    add_synchronous(figure, frequency, &v);
    if (torsion) add_excitations(figure, frequency, &v);
    add_lines(figure, frequency, &v, WHIRL_FIELD_MODES_FREQUENCY, false, true);
    add_modes(figure, frequency, &v, WHIRL_FIELD_MODES_FREQUENCY);
    add_critical(figure, frequency, &v, false);
    // Draw damping ratios of the same modes.
    whirl_series *zero = panel_level(figure, damping, 0.0, "#9A9A9A", 0.4);
    if (zero) zero->dashed = true;
    add_lines(figure, damping, &v, WHIRL_FIELD_MODES_DAMPING_RATIO, false, false);
    add_modes(figure, damping, &v, WHIRL_FIELD_MODES_DAMPING_RATIO);
    add_critical(figure, damping, &v, true);
    // Describe both panels.
    snprintf(
        figure->caption, sizeof figure->caption,
        "Campbell diagram: damped natural frequencies over %s; blue, pointing up: the whirl goes with the rotation, "
        "orange, pointing down: against it, grey squares: to and fro; dashed: the speed of the shaft; circles: "
        "critical speeds; crosses: thresholds of stability. Below: damping ratios of the same modes, without "
        "large ones, negative where a mode grows.%s%s%s",
        v.table->parameter,
        v.lines.count > 0
            ? " Names count modes that go forward (F), backward (B) or to and fro (M) at the last value, by rising "
              "frequency."
            : "",
        torsion
            ? " Green diamonds, T: torsional modes; dashed grey lines: orders of the speed and the frequency of the "
              "line, which excite them."
            : "",
        table_has(v.table, WHIRL_FIELD_MODES_AXIAL_SHARE) ? " Open purple squares, A: axial modes." : "");
    mode_lines_free(&v.lines);
}

const figure_kind campbell_figure = {.list = campbell_list,
                                     .describe = campbell_describe,
                                     .stem = "campbell",
                                     .study = "{modes: {parameter: ..., from: ..., to: ...}}"};

static void list_decrement(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &decrement_figure, .table = table, .point = NO_POINT};
    mode_lines lines;
    (void)of;
    if (table->count < 2 || !mode_lines_of(table, &lines)) return;
    mode_lines_free(&lines);
    list_figure(to, &place, "decrement", "Logarithmic decrement of modes over %s", table->parameter);
}

static void describe_decrement(const drawing *of, const figure_place *place, whirl_figure *figure) {
    whirl_panel *panel = figure_panel(figure, "decrement", 1.0, 5.3);
    if (!panel) return;
    view v = view_of(of, place->table);
    v.top = INFINITY; // all modes, whatever their frequency
    symbol_parameter(of->units, v.table->parameter, panel->x.label, sizeof panel->x.label);
    snprintf(panel->y.label, sizeof panel->y.label, "logarithmic decrement");
    axis_show(&panel->x, campbell_range(&v));
    axis_show(&panel->y, damping_of(&v, WHIRL_FIELD_MODES_DECREMENT, 1.6));
    whirl_series *zero = panel_level(figure, panel, 0.0, "#9A9A9A", 0.4);
    whirl_series *asked = panel_level(figure, panel, asked_decrement, "#9A9A9A", 0.4);
    if (zero) zero->dashed = true;
    if (asked) asked->dashed = true;
    add_lines(figure, panel, &v, WHIRL_FIELD_MODES_DECREMENT, true, true);
    snprintf(figure->caption, sizeof figure->caption,
             "Logarithmic decrement of the lowest modes over %s, followed by shape and frequency from value to value. "
             "Names count by rising frequency at the last value, then those that end before it; F: forward (solid), B: "
             "backward, M: to and fro (dashed)%s%s. Grey: 0, below which a mode grows, and %g.",
             v.table->parameter, table_has(v.table, WHIRL_FIELD_MODES_TORSION) ? ", T: torsional" : "",
             table_has(v.table, WHIRL_FIELD_MODES_AXIAL_SHARE) ? ", A: axial" : "", asked_decrement);
    mode_lines_free(&v.lines);
}

const figure_kind decrement_figure = {.list = list_decrement, .describe = describe_decrement};
