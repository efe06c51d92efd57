// Figures of branches: their orbits over a parameter, with the section of a sweep behind them if there is one, and the
// largest Floquet multiplier; and curves of special points over two parameters.
#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "quantities.h"
#include "tori_bands.h"
#include "two_pi.h"

// Kinds of special points, in the order of whirl_special.
static const struct {
    const char *title, *colour;
    whirl_mark mark;
} kinds[] = {
    {"", "#000000", WHIRL_DISC},
    {"fold", "#000000", WHIRL_DIAMOND},
    {"branching", "#CC79A7", WHIRL_SQUARE},
    {"period doubling", "#D55E00", WHIRL_UP},
    {"Neimark\u2013Sacker", "#009E73", WHIRL_DISC},
    {"Hopf", "#0072B2", WHIRL_DOWN},
    {"grazing", "#56B4E9", WHIRL_FRAME},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static int branch_kind(const whirl_table *table, size_t point) {
    const double kind = point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL);
    return kind > 0.0 && kind < KINDS ? (int)kind : 0;
}

/// Returns true if two points belong to the same branch or curve.
static bool branch_same(const whirl_table *table, size_t a, size_t b) {
    return point_number(table, a, WHIRL_FIELD_TRACE_NUMBER) == point_number(table, b, WHIRL_FIELD_TRACE_NUMBER);
}

/// Returns true if the orbits between two neighbouring points are stable. Point a decides or, if a is a special point,
/// at which stability changes, point b.
static bool is_stable(const whirl_table *table, size_t a, size_t b) {
    const size_t solid = branch_kind(table, a) ? b : a;
    return point_number(table, solid, WHIRL_FIELD_TRACE_UNSTABLE) == 0.0;
}

/// Returns the largest modulus of an orbit's Floquet multipliers; for an equilibrium, of growth over one revolution.
static double multiplier_of(const whirl_table *table, size_t point) {
    const double largest = point_number(table, point, WHIRL_FIELD_TRACE_LARGEST);
    return point_number(table, point, WHIRL_FIELD_TRACE_PERIOD) > 0.0 ? largest : exp(two_pi * largest);
}

static bool has_kind(const whirl_table *table, int kind) {
    for (size_t point = 0; point < table->count; point++)
        if (branch_kind(table, point) == kind) return true;
    return false;
}

// ---------------------------------------------------------------- a panel of branches

/// A panel, and the number it shows of every point: a coordinate of a station's section, or the multiplier.
typedef struct view {
    const drawing *of;
    const whirl_table *table;
    size_t station, column; ///< column: 0 for x, 1 for y, 2 for the multiplier
    double size;            ///< one unit of the parameter, in SI
    span range;             ///< range of the parameter in the figure
} view;

/// Returns the number of lines of a point. Of a forced orbit there is one for each revolution, of an orbit with a
/// period of its own two (the bounds), of an equilibrium one. The panel of the multiplier has one line.
static size_t lines_of(const view *v, size_t point) {
    const double revolutions = point_number(v->table, point, WHIRL_FIELD_TRACE_REVOLUTIONS);
    if (v->column == 2) return 1;
    return revolutions > 0.0                                               ? (size_t)revolutions
           : point_number(v->table, point, WHIRL_FIELD_TRACE_PERIOD) > 0.0 ? 2
                                                                           : 1;
}

/// Returns what the panel shows of a point, on one of its lines_of(), in shown units.
static double branch_shown(const view *v, size_t point, size_t line) {
    if (v->column == 2) return multiplier_of(v->table, point);
    const bool forced = point_number(v->table, point, WHIRL_FIELD_TRACE_REVOLUTIONS) > 0.0;
    const double *at = forced
                           ? whirl_table_field(v->table, point, WHIRL_FIELD_TRACE_SECTION, v->station) + 4 * line
                           : whirl_table_field(v->table, point,
                                               line == 0 ? WHIRL_FIELD_TRACE_HIGH : WHIRL_FIELD_TRACE_LOW, v->station);
    return whirl_shown_length(v->of->units, v->table, point) * at[v->column];
}

/// Returns the value of the parameter at a point, in its shown unit.
static double branch_parameter(const view *v, size_t point) {
    return v->table->values[point] / v->size;
}

/// Adds lines for the stable pieces of branches, or for the unstable ones.
static void add_pieces(whirl_figure *figure, whirl_panel *panel, const view *v, bool stable) {
    const whirl_table *table = v->table;
    whirl_series *lines = panel_named(figure, panel, WHIRL_LINE, stable ? "stable" : "unstable",
                                      stable ? "#0072B2" : "#D55E00", stable ? 0.8 : 0.6);
    if (lines) lines->dashed = !stable;
    for (size_t first = 0; first + 1 < table->count; first++) {
        size_t last = first;
        while (last + 1 < table->count && branch_same(table, last, last + 1) &&
               is_stable(table, last, last + 1) == stable)
            last++;
        if (last == first) continue;
        for (size_t line = 0; line < lines_of(v, first); line++) {
            for (size_t point = first; point <= last; point++)
                series_add(figure, lines, branch_parameter(v, point), branch_shown(v, point, line));
            series_break(figure, lines);
        }
        first = last - 1;
    }
}

static void add_marks(whirl_figure *figure, whirl_panel *panel, const view *v) {
    for (int kind = 1; kind < KINDS; kind++) {
        if (!has_kind(v->table, kind)) continue;
        whirl_series *marks = panel_named(figure, panel, WHIRL_DOTS, kinds[kind].title, kinds[kind].colour, 2.3);
        if (marks) marks->mark = kinds[kind].mark;
        for (size_t point = 0; point < v->table->count; point++)
            for (size_t line = 0; branch_kind(v->table, point) == kind && line < lines_of(v, point); line++)
                series_add(figure, marks, branch_parameter(v, point), branch_shown(v, point, line));
    }
}

/// Adds the parameter values of special points as texts.
static void add_labels(whirl_figure *figure, whirl_panel *panel, const view *v) {
    whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    if (texts) texts->movable = true;
    for (size_t point = 0; point < v->table->count; point++) {
        char text[32];
        if (branch_kind(v->table, point) == 0) continue;
        snprintf(text, sizeof text, "%.5g", branch_parameter(v, point));
        series_add_text(figure, texts, branch_parameter(v, point), branch_shown(v, point, 0), text);
    }
}

/// Adds the section of the sweep in grey.
static void add_sweep(whirl_figure *figure, whirl_panel *panel, const view *v) {
    enum { MAX_DOTS = 40000 };
    const whirl_table *sweep = whirl_result_role(v->of->result, WHIRL_ROLE_SURVEY);
    if (!sweep || !table_has(sweep, WHIRL_FIELD_POINCARE_SECTION)) return;
    whirl_series *dots = panel_named(figure, panel, WHIRL_DOTS, "sweep", "#C4C4C4", 0.27);
    for (size_t i = 0; i < sweep->count; i++) {
        if (!whirl_table_done(sweep, i)) continue;
        const numbers section = point_section(sweep, i, v->station);
        const double length = whirl_shown_length(v->of->units, sweep, i);
        const size_t most = MAX_DOTS / sweep->count + 8, first = section.rows > most ? section.rows - most : 0;
        double before = NAN;
        for (size_t k = first; k < section.rows; k++) {
            const double at = length * section.at[4 * k + v->column];
            // Points of a periodic motion repeat: one dot is enough.
            if (!(fabs(at - before) <= 1e-6 * v->of->units->length))
                series_add(figure, dots, sweep->values[i] / v->size, at);
            before = at;
        }
    }
}

static whirl_panel *branch_add_panel(whirl_figure *figure, const view *v, const char *name) {
    whirl_panel *panel = figure_panel(figure, name, 1.0, 4.0);
    if (!panel) return NULL;
    axis_show(&panel->x, v->range);
    panel->x.shown = v->column == 2;
    symbol_parameter(v->of->units, v->table->parameter, panel->x.label, sizeof panel->x.label);
    return panel;
}

static void add_section(whirl_figure *figure, view v, size_t column) {
    v.column = column;
    whirl_panel *panel = branch_add_panel(figure, &v, column == 0 ? "x" : "y");
    if (!panel) return;
    symbol_length(v.of->units, WHIRL_FROM_CENTRE, column == 0 ? "$x$" : "$y$", panel->y.label, sizeof panel->y.label);
    add_sweep(figure, panel, &v);
    tori_add_bands(figure, panel, v.of, v.station, column, v.size);
    add_pieces(figure, panel, &v, true);
    add_pieces(figure, panel, &v, false);
    add_marks(figure, panel, &v);
}

static void add_multipliers(whirl_figure *figure, view v) {
    v.column = 2;
    whirl_panel *panel = branch_add_panel(figure, &v, "multiplier");
    if (!panel) return;
    snprintf(panel->y.label, sizeof panel->y.label, "largest multiplier");
    panel->y.logarithmic = true;
    whirl_series *one = panel_level(figure, panel, 1.0, "#9A9A9A", 0.4);
    if (one) one->dashed = true;
    add_pieces(figure, panel, &v, true);
    add_pieces(figure, panel, &v, false);
    add_marks(figure, panel, &v);
    add_labels(figure, panel, &v);
}

// ---------------------------------------------------------------- branches

static void branch_list(figure_list *to, const drawing *of, const whirl_table *table) {
    if (!table_has(table, WHIRL_FIELD_TRACE_NUMBER) || *table->second || table->count < 2) return;
    for (size_t s = 0; s < of->result->station_count; s++) {
        const char *station = of->result->stations[s].name;
        const figure_place place = {.kind = &branch_figure, .table = table, .point = NO_POINT, .station = s};
        char name[2 * WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "branch-%s", station);
        list_figure(to, &place, name, "Branches of %s over %s", station, table->parameter);
    }
}

static void branch_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table, *sweep = whirl_result_role(of->result, WHIRL_ROLE_SURVEY);
    view v = {.of = of, .table = table, .station = place->station, .range = span_empty()};
    v.size = whirl_shown_parameter(of->units, table->parameter).size;
    for (size_t i = 0; i < table->count; i++) span_widen(&v.range, table->values[i] / v.size);
    for (size_t i = 0; sweep && i < sweep->count; i++) span_widen(&v.range, sweep->values[i] / v.size);
    snprintf(figure->caption, sizeof figure->caption,
             "Periodic orbits of %s over %s, once a revolution (if they have a period of their own: largest and "
             "smallest values): solid where they are stable, dashed where not.%s%s Marks: special points, which the "
             "table lists. Below: the largest modulus of a Floquet multiplier.",
             of->result->stations[place->station].name, table->parameter,
             sweep ? " Grey: the section of the motions that the sweep settled on." : "",
             tori_table(of->result) ? tori_caption : "");
    add_section(figure, v, 0);
    add_section(figure, v, 1);
    add_multipliers(figure, v);
}

const figure_kind branch_figure = {
    .list = branch_list, .describe = branch_describe, .stem = "branch-", .study = "{branch: ...}"};

// ---------------------------------------------------------------- curves

static void list_curves(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &curves_figure, .table = table, .point = NO_POINT};
    if (table_has(table, WHIRL_FIELD_TRACE_NUMBER) && *table->second && table->count > 1)
        list_figure(to, &place, "curves", "Where motions change, over %s and %.60s", table->parameter,
                    whirl_result_fact(of->result, "second parameter"));
}

/// Returns true if the orbits that begin at a Hopf point of a curve are unstable (subcritical); false for other points.
static bool is_subcritical(const whirl_table *table, size_t point) {
    return point_number(table, point, WHIRL_FIELD_TRACE_CRITICALITY) > 0.0;
}

/// Adds the curves of a kind: all of them, or their subcritical parts.
static void add_curves(whirl_figure *figure, whirl_panel *panel, const view *v, int kind, double second_size,
                       bool subcritical) {
    const whirl_table *table = v->table;
    whirl_series *lines = NULL;
    char title[64];
    snprintf(title, sizeof title, "%s%s", kinds[kind].title, subcritical ? ", subcritical" : "");
    for (size_t i = 0; i < table->count; i++) {
        if (branch_kind(table, i) != kind || is_subcritical(table, i) != subcritical) continue;
        if (!lines) lines = panel_named(figure, panel, WHIRL_LINE, title, kinds[kind].colour, 0.9);
        if (!lines) return;
        lines->dashed = subcritical;
        const bool first = i == 0 || !branch_same(table, i - 1, i),
                   last = i + 1 == table->count || !branch_same(table, i, i + 1);
        // Neighbouring pieces share the point at which the sense changes, so that there is no gap.
        for (size_t k = first || is_subcritical(table, i - 1) == subcritical ? i : i - 1; k <= i; k++)
            series_add(figure, lines, table->values[k] / v->size,
                       point_number(table, k, WHIRL_FIELD_TRACE_SECOND) / second_size);
        if (last || is_subcritical(table, i + 1) != subcritical) series_break(figure, lines);
    }
}

static void describe_curves(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const char *second = whirl_result_fact(of->result, "second parameter");
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    const double second_size = whirl_shown_parameter(of->units, second).size;
    whirl_panel *panel = figure_panel(figure, "curves", 1.0, 7.5);
    if (!panel) return;
    symbol_parameter(of->units, table->parameter, panel->x.label, sizeof panel->x.label);
    symbol_parameter(of->units, second, panel->y.label, sizeof panel->y.label);
    const view v = {.of = of, .table = table, .size = size};
    for (int kind = 1; kind < KINDS; kind++) {
        add_curves(figure, panel, &v, kind, second_size, false);
        add_curves(figure, panel, &v, kind, second_size, true);
    }
    snprintf(
        figure->caption, sizeof figure->caption,
        "Curves over %s and %.60s along which motions change; between the curves the kind of motion stays the same.%s",
        table->parameter, second,
        has_kind(table, WHIRL_HOPF) ? " Dashed: the whirl that begins there is unstable (subcritical)." : "");
}

const figure_kind curves_figure = {
    .list = list_curves, .describe = describe_curves, .stem = "curves", .study = "{branch: ..., curves: ...}"};
