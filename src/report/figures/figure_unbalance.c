// Figures of the response of a station to unbalance: Bode diagram, polar diagram, and centreline of the shaft.
#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "margins.h"
#include "two_pi.h"
#include "units.h"

typedef struct view {
    const drawing *of;
    const whirl_table *table;
    size_t station;
    double size; ///< one unit of the parameter, in SI
} view;

static const double *field_of(const view *v, size_t point, const char *field) {
    return whirl_table_done(v->table, point) ? whirl_table_field(v->table, point, field, v->station) : NULL;
}

static double length_at(const view *v, size_t point) {
    return whirl_shown_length(v->of->units, v->table, point);
}

static double amplitude_at(const view *v, size_t point) {
    return units_length(v->of->units, v->table, point, WHIRL_AMPLITUDE);
}

static double value_at(const view *v, size_t point) {
    return v->table->values[point] / v->size;
}

/// Finds the part of the running speeds within `shown`. Returns false if there is none, or if the parameter is no
/// speed.
static bool running_of(const view *v, span shown, span *out) {
    double from, to;
    if (!margin_running(v->table, &from, &to) || !units_of_speed(v->table, WHIRL_FIELD_UNBALANCE_SPEED)) return false;
    const double margin = 1e-3 * (shown.high - shown.low); // so that a single speed is a line
    *out = (span){fmax(from / v->size - margin, shown.low), fmin(to / v->size + margin, shown.high)};
    return out->low < out->high;
}

static void add_running(whirl_figure *figure, whirl_panel *panel, const view *v, double high) {
    span running;
    if (!running_of(v, (span){panel->x.low, panel->x.high}, &running)) return;
    series_add_box(figure, panel_series(figure, panel, WHIRL_BOXES, "#D8D8D8", 1.0), running, (span){0.0, high});
}

static void add_lags(whirl_figure *figure, whirl_panel *panel, const view *v) {
    snprintf(panel->y.label, sizeof panel->y.label, "lag (deg)");
    axis_show(&panel->y, (span){0.0, 360.0});
    for (int lag = 0; lag <= 360; lag += 90) {
        char text[8];
        snprintf(text, sizeof text, "%d", lag);
        axis_tick(figure, &panel->y, lag, text);
    }
    add_running(figure, panel, v, 360.0);
    for (size_t probe = 0; probe < 2; probe++) {
        whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, line_colour(probe), 0.9);
        for (size_t point = 0; point < v->table->count; point++) {
            const double *lags = field_of(v, point, WHIRL_FIELD_UNBALANCE_PROBE_LAG);
            if (lags) series_add(figure, dots, value_at(v, point), lags[probe]);
        }
    }
}

/// Returns the field of curve `which`: the first probe, the second probe, the major axis.
static const char *source_of(size_t which) {
    return which == 2 ? WHIRL_FIELD_UNBALANCE_AXES : WHIRL_FIELD_UNBALANCE_PROBE;
}

static void add_amplitudes(whirl_figure *figure, whirl_panel *panel, const view *v) {
    // Find the largest amplitude.
    double most = 0.0;
    symbol_length(v->of->units, WHIRL_AMPLITUDE, "amplitude", panel->y.label, sizeof panel->y.label);
    for (size_t point = 0; point < v->table->count; point++)
        for (size_t which = 0; which < 3; which++) {
            const double *at = field_of(v, point, source_of(which));
            if (at) most = fmax(most, amplitude_at(v, point) * at[which % 2]);
        }
    // Show the axis, and the speeds at which the machine runs.
    const double high = most > 0.0 ? 1.06 * most : 1.0;
    axis_show(&panel->y, (span){0.0, high});
    add_running(figure, panel, v, high);
    // Draw both probes and the major axis.
    for (size_t which = 0; which < 3; which++) {
        char name[WHIRL_NAME_SIZE] = "major axis";
        if (which < 2)
            snprintf(name, sizeof name, "probe at %.4g\u00b0",
                     v->table->record.probe_angle * 360.0 / two_pi + (which ? 90.0 : 0.0));
        whirl_series *line =
            panel_named(figure, panel, WHIRL_LINE, name, which == 2 ? "#9A9A9A" : line_colour(which), 0.55);
        if (line) line->dashed = which == 2;
        for (size_t point = 0; point < v->table->count; point++) {
            const double *at = field_of(v, point, source_of(which));
            if (at) series_add(figure, line, value_at(v, point), amplitude_at(v, point) * at[which % 2]);
        }
    }
}

/// Adds circles of equal amplitude and rays of equal lag, with their names; `high`: the largest amplitude shown.
static void add_lag_axes(whirl_figure *figure, whirl_panel *panel, double high) {
    enum { STEPS = 96, RAYS = 8 };
    const double step = tick_step(high, 4);
    whirl_series *grid = panel_series(figure, panel, WHIRL_LINE, "#C8C8C8", 0.35);
    whirl_series *numbers = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
    whirl_series *lags = panel_series(figure, panel, WHIRL_TEXTS, "#303030", 1.0);
    // Circles with their amplitudes.
    for (int k = 1; k * step <= 1.001 * high; k++) {
        char text[32];
        for (int i = 0; i <= STEPS; i++)
            series_add(figure, grid, k * step * cos(two_pi * i / STEPS), k * step * sin(two_pi * i / STEPS));
        series_break(figure, grid);
        snprintf(text, sizeof text, "%g", k * step);
        series_add_text(figure, numbers, k * step * cos(two_pi / 16.0), k * step * sin(two_pi / 16.0), text);
    }
    // Rays with their lags.
    for (int k = 0; k < RAYS; k++) {
        const double angle = -two_pi * k / RAYS; // lag is counted against the rotation
        char text[16];
        series_add(figure, grid, 0.0, 0.0);
        series_add(figure, grid, high * cos(angle), high * sin(angle));
        series_break(figure, grid);
        snprintf(text, sizeof text, "%d\u00b0", 360 / RAYS * k);
        series_add_text(figure, lags, 1.13 * high * cos(angle), (1.13 * sin(angle) - 0.055) * high, text);
    }
}

/// Writes the place of a probe's amplitude and lag in the polar diagram. Returns false if they are unknown.
static bool polar_place(const view *v, size_t point, size_t probe, double place[2]) {
    const double *at = field_of(v, point, WHIRL_FIELD_UNBALANCE_PROBE);
    const double *lag = field_of(v, point, WHIRL_FIELD_UNBALANCE_PROBE_LAG);
    if (!at || !lag || !isfinite(lag[probe])) return false;
    const double size = amplitude_at(v, point) * at[probe], angle = lag[probe] * two_pi / 360.0;
    place[0] = size * cos(angle);
    place[1] = -size * sin(angle);
    return true;
}

/// Marks round values of the parameter on a probe's line.
static void add_speeds(whirl_figure *figure, whirl_panel *panel, const view *v, size_t probe) {
    span range = span_empty();
    // Choose the distance of marks, and their appearance.
    for (size_t point = 0; point < v->table->count; point++) span_widen(&range, value_at(v, point));
    const double step = tick_step(range.high - range.low, 6);
    whirl_series *marks = panel_series(figure, panel, WHIRL_DOTS, line_colour(probe), 1.8);
    whirl_series *names = panel_series(figure, panel, WHIRL_TEXTS, line_colour(probe), 1.0);
    if (names) names->side = WHIRL_BESIDE;
    if (names) names->movable = true;
    // Mark each round value between the two points around it.
    for (double value = step * ceil(range.low / step); step > 0.0 && value <= range.high; value += step) {
        double one[2], other[2];
        size_t point = 0;
        while (point + 2 < v->table->count && !(value_at(v, point + 1) >= value)) point++;
        if (point + 1 >= v->table->count) return;
        const double from = value_at(v, point), share = (value - from) / (value_at(v, point + 1) - from);
        if (!(share >= 0.0 && share <= 1.0) || !polar_place(v, point, probe, one) ||
            !polar_place(v, point + 1, probe, other))
            continue;
        const double x = one[0] + share * (other[0] - one[0]), y = one[1] + share * (other[1] - one[1]);
        char text[32];
        series_add(figure, marks, x, y);
        snprintf(text, sizeof text, "%g", value);
        series_add_text(figure, names, x, y, text);
    }
}

/// Adds the polar diagram of both probes, with the origin in the middle.
static void add_polar(whirl_figure *figure, whirl_panel *panel, const view *v) {
    double most = 0.0, place[2];
    symbol_length(v->of->units, WHIRL_AMPLITUDE, "amplitude", panel->x.label, sizeof panel->x.label);
    for (size_t i = 0; i < 2 * v->table->count; i++)
        if (polar_place(v, i / 2, i % 2, place)) most = fmax(most, hypot(place[0], place[1]));
    const double high = most > 0.0 ? 1.04 * most : 1.0;
    add_lag_axes(figure, panel, high);
    for (size_t probe = 0; probe < 2; probe++) {
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(probe), 0.53);
        for (size_t point = 0; point < v->table->count; point++)
            if (polar_place(v, point, probe, place)) series_add(figure, line, place[0], place[1]);
        add_speeds(figure, panel, v, probe);
    }
    axis_show(&panel->x, (span){-1.3 * high, 1.3 * high});
    axis_show(&panel->y, (span){-1.3 * high, 1.3 * high});
    panel->y.shown = false;
    axis_tick(figure, &panel->x, 0.0, "");
    axis_tick(figure, &panel->y, 0.0, "");
}

/// Adds the centreline of the shaft. It is drawn as one point if it moves by less than a thousandth of its distance
/// from the centre.
static void add_centreline(whirl_figure *figure, whirl_panel *panel, const view *v) {
    span x = span_empty(), y = span_empty();
    double size = 0.0;
    symbol_length(v->of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
    symbol_length(v->of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.53);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, line_colour(0), 0.9);
    for (size_t point = 0; point < v->table->count; point++) {
        const double *rest = field_of(v, point, WHIRL_FIELD_UNBALANCE_REST), length = length_at(v, point);
        if (!rest) continue;
        series_add(figure, line, length * rest[0], length * rest[1]);
        series_add(figure, dots, length * rest[0], length * rest[1]);
        span_widen(&x, length * rest[0]);
        span_widen(&y, length * rest[1]);
        size = fmax(size, length * hypot(rest[0], rest[1]));
    }
    const double width = fmax(1.2 * fmax(x.high - x.low, y.high - y.low), size > 0.0 ? 1e-3 * size : 1.0);
    axis_show(&panel->x, span_with_margin(x, 0.1, width));
    axis_show(&panel->y, span_with_margin(y, 0.1, width));
}

static void unbalance_list(figure_list *to, const drawing *of, const whirl_table *table) {
    if (!table_has(table, WHIRL_FIELD_UNBALANCE_AMPLITUDE) || table->count < 2) return;
    for (size_t s = 0; s < of->result->station_count; s++) {
        const char *station = of->result->stations[s].name;
        const figure_place place = {.kind = &unbalance_figure, .table = table, .point = NO_POINT, .station = s};
        char name[2 * WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "unbalance-%s", station);
        list_figure(to, &place, name, "Response of %s to unbalance over %s", station, table->parameter);
    }
}

static void unbalance_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const view v = {of, table, place->station, whirl_shown_parameter(of->units, table->parameter).size};
    span range = span_empty(), running;
    figure->width = 17.5;
    // Set up four panels, two of them over the parameter.
    for (size_t i = 0; i < table->count; i++) span_widen(&range, table->values[i] / v.size);
    whirl_panel *lag = figure_panel(figure, "lag", 0.6, 4.6), *polar = figure_panel(figure, "polar", 0.4, 4.6);
    whirl_panel *amplitude = figure_panel(figure, "amplitude", 0.6, 4.6);
    whirl_panel *centreline = figure_panel(figure, "centreline", 0.4, 4.6);
    if (!lag || !polar || !amplitude || !centreline) return;
    symbol_parameter(of->units, table->parameter, lag->x.label, sizeof lag->x.label);
    symbol_parameter(of->units, table->parameter, amplitude->x.label, sizeof amplitude->x.label);
    axis_show(&lag->x, span_with_margin(range, 0.0, 1e-300));
    axis_show(&amplitude->x, span_with_margin(range, 0.0, 1e-300));
    polar->equal = centreline->equal = true;
    // Draw them.
    add_lags(figure, lag, &v);
    add_polar(figure, polar, &v);
    add_amplitudes(figure, amplitude, &v);
    add_centreline(figure, centreline, &v);
    // Describe the panels.
    snprintf(
        figure->caption, sizeof figure->caption,
        "Synchronous response of %s over %s. Left: by how much the peak comes after the mark, and amplitude, of two "
        "probes, the first at %.4g degrees from the x axis. Right: polar diagram (against the rotation the lag grows), "
        "with marks at round values of %s; centreline of the shaft.%s",
        of->result->stations[v.station].name, table->parameter, table->record.probe_angle * 360.0 / two_pi,
        table->parameter, running_of(&v, range, &running) ? " Grey: where the machine runs." : "");
}

const figure_kind unbalance_figure = {.list = unbalance_list,
                                      .describe = unbalance_describe,
                                      .stem = "unbalance-",
                                      .study = "{unbalance: {parameter: ..., from: ..., to: ...}}"};
