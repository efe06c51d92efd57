// Bifurcation diagrams: the Poincare section of a station against the swept parameter, coloured by regime, above the
// verdict and its confidence, the largest Lyapunov exponent, the largest radius and the time in contact on the same
// axis.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bifurcation.h"
#include "figure_build.h"
#include "figure_kinds.h"
#include "quantities.h"
#include "regimes.h"

enum {
    MANY_POINTS = 150, ///< number of points of a sweep above which small dots suffice
    GRID = 2000,       ///< dots nearer to each other than 1/GRID of the axis are drawn once
    MAX_DOTS = 100000, ///< largest number of dots in a figure, which limits the size of its PDF
    MIN_DOTS = 64      ///< least number of dots of a point
};

static const char grey[] = "#9A9A9A", dark[] = "#303030", rubbing[] = "#F3DFC5";

// ---------------------------------------------------------------- what panels share

static double shown_value(const bifurcation *of, size_t point) {
    return of->value * of->table->values[point];
}

static void band_limits(const bifurcation *of, size_t first, size_t last, span *band) {
    span own = span_empty();
    double low, high;
    const size_t ends[] = {first, last};
    for (int i = 0; i < 2; i++) {
        bifurcation_edges(of, ends[i], &low, &high);
        span_widen(&own, of->value * low);
        span_widen(&own, of->value * high);
    }
    *band = own;
}

/// Returns true if point i + 1 is the next place of the grid in the same branch as point i.
static bool goes_on(const whirl_table *table, size_t i) {
    return i + 1 < table->count && table->branch[i + 1] == table->branch[i] &&
           whirl_table_slot(table, i + 1) == whirl_table_slot(table, i) + 1;
}

/// Adds shaded bands for parameter ranges with contact, behind the other series of a panel.
static void add_rub_bands(whirl_figure *figure, whirl_panel *panel, const bifurcation *of) {
    const whirl_table *table = of->table;
    const size_t contacts = of->result->contact_count;
    if (!of->shaded || !panel) return;
    whirl_series *bands = panel_named(figure, panel, WHIRL_BOXES, "rub", rubbing, 1.0);
    for (size_t i = 0; i < table->count; i++) {
        if (!(rub_share(table, i, contacts) > 0.0)) continue;
        size_t last = i;
        while (goes_on(table, last) && rub_share(table, last + 1, contacts) > 0.0) last++;
        span band;
        band_limits(of, i, last, &band);
        series_add_box(figure, bands, band, (span){panel->y.low, panel->y.high});
        i = last;
    }
}

static whirl_panel *bifurcation_add_panel(whirl_figure *figure, const bifurcation *of, const char *name, double height,
                                          span range) {
    whirl_panel *panel = figure_panel(figure, name, 1.0, height);
    if (!panel) return NULL;
    axis_show(&panel->x, of->parameter);
    axis_show(&panel->y, range);
    panel->x.logarithmic = of->ratios;
    panel->x.shown = false;
    symbol_parameter(of->units, of->table->parameter, panel->x.label, sizeof panel->x.label);
    return panel;
}

// ---------------------------------------------------------------- the section

/// A dot in a cell of the panel's grid (GRID), and its row in the section.
typedef struct dot {
    int x, y;
    size_t row;
} dot;

static int by_place(const void *left, const void *right) {
    const dot *a = left, *b = right;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    if (a->y != b->y) return a->y < b->y ? -1 : 1;
    return (a->row > b->row) - (a->row < b->row);
}

static int cell(double value, span range) {
    return (int)fmin(fmax(GRID * (value - range.low) / (range.high - range.low), -1.0), GRID + 1.0);
}

static void add_dots(whirl_figure *figure, whirl_series *to, const bifurcation *of, size_t point, size_t column,
                     dot *dots) {
    const numbers section = point_section(of->table, point, of->station);
    const size_t share = MAX_DOTS / (of->table->count + 1), most = share > MIN_DOTS ? share : MIN_DOTS;
    const size_t count = section.rows < most ? section.rows : most;
    const double length = whirl_shown_length(of->units, of->table, point);
    for (size_t k = 0; k < count; k++) {
        const size_t row = section.rows - count + k;
        dots[k] = (dot){cell(length * section.at[4 * row], of->x), cell(length * section.at[4 * row + 1], of->y), row};
    }
    qsort(dots, count, sizeof *dots, by_place);
    for (size_t k = 0; k < count; k++)
        if (k == 0 || dots[k].x != dots[k - 1].x || dots[k].y != dots[k - 1].y)
            series_add(figure, to, shown_value(of, point), length * section.at[4 * dots[k].row + column]);
}

/// Returns true for kinds whose dots are few or doubtful, and are drawn larger.
static bool has_large_dots(const bifurcation *of, size_t kind) {
    return of->attractors > 0 || kind == CLASS_UNDETERMINED || kind == CLASS_P1 || kind == CLASS_P2 ||
           kind == CLASS_P4 || kind == CLASS_OTHER_PERIOD;
}

static double dot_size(const bifurcation *of) {
    return of->table->count > MANY_POINTS ? 0.27 : 0.45;
}

/// Adds the dots of one kind and one branch.
static void add_kind(whirl_figure *figure, whirl_panel *panel, const bifurcation *of, size_t kind, int branch,
                     size_t column, dot *dots) {
    char name[WHIRL_NAME_SIZE];
    const double size = branch < 0 ? 2.5 : has_large_dots(of, kind) ? 2.0 : 1.0;
    bifurcation_kind_name(of, kind, name);
    whirl_series *to =
        panel_named(figure, panel, WHIRL_DOTS, name, bifurcation_kind_colour(of, kind), size * dot_size(of));
    if (to && branch < 0) to->mark = WHIRL_CROSS;
    for (size_t i = 0; i < of->table->count; i++)
        if (whirl_table_done(of->table, i) && bifurcation_kind(of, i) == kind &&
            (of->table->branch[i] < 0 ? -1 : 1) == branch)
            add_dots(figure, to, of, i, column, dots);
}

/// Adds the dots of coordinate `column` of the section.
static void add_section(whirl_figure *figure, const bifurcation *of, size_t column) {
    const size_t rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_POINCARE_SECTION)->rows;
    whirl_panel *panel = bifurcation_add_panel(figure, of, column == 0 ? "x" : "y", 3.9, column == 0 ? of->x : of->y);
    dot *dots = malloc((rows + 1) * sizeof *dots);
    figure->failed = figure->failed || !dots;
    if (panel && dots) {
        symbol_length(of->units, WHIRL_FROM_CENTRE, column == 0 ? "$x$" : "$y$", panel->y.label, sizeof panel->y.label);
        add_rub_bands(figure, panel, of);
        for (size_t kind = 0; kind < bifurcation_kinds(of); kind++)
            for (int branch = 1; of->present[kind] && branch >= (of->both ? -1 : 1); branch -= 2)
                add_kind(figure, panel, of, kind, branch, column, dots);
        if (of->both && column == 0) {
            panel_named(figure, panel, WHIRL_DOTS, "first value to last", dark, 1.0);
            whirl_series *down = panel_named(figure, panel, WHIRL_DOTS, "last value to first", dark, 2.0);
            if (down) down->mark = WHIRL_CROSS;
        }
    }
    free(dots);
}

// ---------------------------------------------------------------- verdicts

/// Returns the vertical range of an interval's strip in its panel: strips of both branches, or of attractors, are
/// stacked.
static span strip_of(const bifurcation *of, const regime_interval *interval) {
    const double count = of->attractors > 0 ? (double)of->attractors : of->both ? 2.0 : 1.0;
    const bool lower = of->both && interval->branch < 0;
    const double place = of->attractors > 0 ? (double)((interval->branch - 1) % ATTRACTOR_COLOURS) : lower ? 1.0 : 0.0;
    const double top = 1.0 - place / count;
    return (span){top - (of->attractors > 1 ? 0.85 : of->both ? 0.96 : 1.0) / count, top};
}

/// Adds the regime of every point as a strip, the branch from the first value above the branch from the last.
static void add_regimes(whirl_figure *figure, const bifurcation *of) {
    // Find intervals of points with the same regime.
    const size_t most = of->table->count;
    const double height = of->attractors > 1 ? 0.26 * (double)of->attractors : of->both ? 0.57 : 0.39;
    whirl_panel *panel = bifurcation_add_panel(figure, of, "regime", height, (span){0.0, 1.0});
    regime_interval *intervals = malloc((most + 1) * sizeof *intervals);
    figure->failed = figure->failed || !intervals;
    const size_t count = intervals ? regime_intervals(of->table, of->result->contact_count, intervals, most) : 0;
    if (panel) snprintf(panel->y.label, sizeof panel->y.label, "regime");
    // Add the boxes of one regime after another, so that the legend has each once.
    for (int kind = 0; kind < CLASS_COUNT && panel; kind++) {
        whirl_series *strip = NULL;
        for (size_t i = 0; i < count; i++) {
            if ((int)intervals[i].kind != kind) continue;
            if (!strip)
                strip = panel_named(figure, panel, WHIRL_BOXES, regime_class_name((regime_class)kind),
                                    regime_class_colour((regime_class)kind), 1.0);
            span band;
            band_limits(of, intervals[i].first, intervals[i].last, &band);
            series_add_box(figure, strip, band, strip_of(of, &intervals[i]));
        }
    }
    if (panel) axis_tick(figure, &panel->y, -1.0, "");
    free(intervals);
}

/// Adds the confidence of each verdict as a bar: long and pale for trusted verdicts, short and coloured for doubtful
/// ones. Bars are for the branch from the first value on; that from the last value on is drawn as lines.
static void add_confidence(whirl_figure *figure, const bifurcation *of) {
    static const char *const colours[] = {"#D55E00", "#A8A8A8", "#DCDCDC"};
    static const char *const names[] = {"low", "", "high"};
    whirl_panel *panel = bifurcation_add_panel(figure, of, "confidence", 0.8, (span){0.0, 3.4});
    if (!panel) return;
    // Add bars of points from the first value on.
    snprintf(panel->y.label, sizeof panel->y.label, "trust");
    for (int level = 0; level < 3; level++) {
        whirl_series *bars = panel_series(figure, panel, WHIRL_BOXES, colours[level], 1.0);
        axis_tick(figure, &panel->y, level + 1.0, names[level]);
        for (size_t i = 0; i < of->table->count; i++) {
            span band;
            if (!whirl_table_done(of->table, i) || of->table->branch[i] < 0 ||
                (int)whirl_table_verdict(of->table, i).confidence != level)
                continue;
            band_limits(of, i, i, &band);
            series_add_box(figure, bars, band, (span){0.0, level + 1.0});
        }
    }
    // Add the branch from the last value on as lines.
    whirl_series *down = of->both ? panel_series(figure, panel, WHIRL_LINE, dark, 0.9) : NULL;
    for (size_t i = 0; i < of->table->count && down; i++) {
        span band;
        if (!whirl_table_done(of->table, i) || of->table->branch[i] >= 0) continue;
        band_limits(of, i, i, &band);
        const double level = 1.0 + (double)whirl_table_verdict(of->table, i).confidence;
        series_add(figure, down, band.low, level);
        series_add(figure, down, band.high, level);
        series_break(figure, down);
    }
}

static void add_exponents(whirl_figure *figure, const bifurcation *of) {
    // Set up the panel, with bands where the motion rubs and a line at 0.
    whirl_panel *panel = bifurcation_add_panel(figure, of, "exponent", 2.45, of->exponent);
    if (!panel) return;
    snprintf(panel->y.label, sizeof panel->y.label, "largest exponent (1/revolution)");
    add_rub_bands(figure, panel, of);
    whirl_series *zero = panel_level(figure, panel, 0.0, grey, 0.4);
    if (zero) zero->dashed = true;
    // Draw error bars.
    whirl_series *errors = panel_series(figure, panel, WHIRL_BARS, grey, 0.4);
    for (size_t i = 0; i < of->table->count; i++) {
        const whirl_estimate exponent = point_exponent(of->table, i);
        if (whirl_table_done(of->table, i) && exponent.error > 0.0)
            series_add_to(figure, errors, shown_value(of, i), exponent.value - exponent.error,
                          exponent.value + exponent.error);
    }
    // Draw dots in the colour of their regime, crosses on the branch from the last value on.
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
            whirl_series *dots = NULL;
            for (size_t i = 0; i < of->table->count; i++) {
                const whirl_verdict verdict = whirl_table_verdict(of->table, i);
                if (!whirl_table_done(of->table, i) || (int)regime_class_of(&verdict) != kind ||
                    (of->table->branch[i] < 0 ? -1 : 1) != branch)
                    continue;
                if (!dots)
                    dots =
                        panel_named(figure, panel, WHIRL_DOTS, regime_class_name((regime_class)kind),
                                    regime_class_colour((regime_class)kind), (branch < 0 ? 3.0 : 2.0) * dot_size(of));
                if (dots && branch < 0) dots->mark = WHIRL_CROSS;
                series_add(figure, dots, shown_value(of, i), point_exponent(of->table, i).value);
            }
        }
}

// ---------------------------------------------------------------- lines

/// Adds a number of all points as a line for each branch: blue from the first value on, orange from the last.
static void add_lines(whirl_figure *figure, whirl_panel *panel, const bifurcation *of,
                      double (*number)(const bifurcation *of, size_t point)) {
    for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(branch < 0), 0.53);
        for (size_t i = 0; i < of->table->count; i++) {
            if ((of->table->branch[i] < 0 ? -1 : 1) != branch) continue;
            if (whirl_table_done(of->table, i)) series_add(figure, line, shown_value(of, i), number(of, i));
            if (!goes_on(of->table, i) || !whirl_table_done(of->table, i)) series_break(figure, line);
        }
    }
}

static double radius_of(const bifurcation *of, size_t point) {
    const double scale = of->clearance > 0.0 ? 1.0 / of->clearance : 1.0;
    return scale * whirl_shown_length(of->units, of->table, point) * max_radius(of->table, point, of->station);
}

static double contact_of(const bifurcation *of, size_t point) {
    return 100.0 * rub_share(of->table, point, of->result->contact_count);
}

/// Returns the least distance between the curve of the radius and the line of the gap, within a tenth of the axis
/// around a place (0: left, 1: right).
static double label_distance(const bifurcation *of, double place) {
    const double width = of->parameter.high - of->parameter.low;
    double nearest = (double)INFINITY;
    for (size_t i = 0; i < of->table->count; i++) {
        const double value = shown_value(of, i);
        const double at = of->ratios ? log(value / of->parameter.low) / log(of->parameter.high / of->parameter.low)
                                     : (value - of->parameter.low) / width;
        if (fabs(at - place) > 0.1) continue;
        nearest =
            fmin(nearest, fabs(of->length * max_radius(of->table, i, of->station) - of->gap)); // fmin leaves NaN out
    }
    return nearest;
}

/// Adds the gap as a line, with its name where the curve of the radius is far away.
static void add_gap(whirl_figure *figure, whirl_panel *panel, const bifurcation *of, double height) {
    static const double places[] = {0.93, 0.07, 0.5};
    int best = 0;
    for (int i = 1; i < 3; i++)
        if (label_distance(of, places[i]) > label_distance(of, places[best])) best = i;
    whirl_series *line = panel_level(figure, panel, height, "#606060", 0.53);
    if (line) line->dashed = true;
    whirl_series *text = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
    const double share = places[best], low = of->parameter.low, high = of->parameter.high;
    series_add_text(figure, text, of->ratios ? low * pow(high / low, share) : low + share * (high - low), height,
                    "gap");
}

static void add_radius(whirl_figure *figure, const bifurcation *of) {
    const double clearance = of->clearance, scale = clearance > 0.0 ? 1.0 / clearance : 1.0;
    whirl_panel *panel =
        bifurcation_add_panel(figure, of, "radius", 1.7, (span){scale * of->radius.low, scale * of->radius.high});
    if (!panel) return;
    if (clearance > 0.0)
        snprintf(panel->y.label, sizeof panel->y.label, "largest eccentricity");
    else
        symbol_length(of->units, WHIRL_ZERO_TO_PEAK, "largest radius", panel->y.label, sizeof panel->y.label);
    add_rub_bands(figure, panel, of);
    if (of->gap > 0.0) add_gap(figure, panel, of, scale * of->gap);
    add_lines(figure, panel, of, radius_of);
}

static void add_contact(whirl_figure *figure, const bifurcation *of) {
    whirl_panel *panel = bifurcation_add_panel(figure, of, "contact", 1.45, (span){0.0, 100.0 * of->share});
    if (!panel) return;
    snprintf(panel->y.label, sizeof panel->y.label, "time in contact (%%)");
    add_rub_bands(figure, panel, of);
    add_lines(figure, panel, of, contact_of);
}

/// Adds the share of starts that lead to each attractor, with its standard error. Rings mark a share of 0: attractors
/// found only from neighbours.
static void add_shares(whirl_figure *figure, const bifurcation *of) {
    whirl_panel *panel = bifurcation_add_panel(figure, of, "share", 1.45, (span){-4.0, 104.0});
    if (!panel) return;
    snprintf(panel->y.label, sizeof panel->y.label, "share of starts (%%)");
    for (size_t kind = 0; kind < of->attractors; kind++) {
        const char *colour = bifurcation_kind_colour(of, kind);
        char name[WHIRL_NAME_SIZE];
        bifurcation_kind_name(of, kind, name);
        whirl_series *errors = panel_series(figure, panel, WHIRL_BARS, colour, 0.4);
        whirl_series *dots = panel_named(figure, panel, WHIRL_DOTS, name, colour, 1.3);
        whirl_series *rings = panel_series(figure, panel, WHIRL_DOTS, colour, 2.7);
        if (rings) rings->mark = WHIRL_RING;
        for (size_t i = 0; i < of->table->count; i++) {
            if (!whirl_table_done(of->table, i) || bifurcation_kind(of, i) != kind) continue;
            const whirl_coexisting *one = &of->table->attractors[i];
            const double share = 100.0 * one->share, error = 100.0 * one->error;
            series_add(figure, share > 0.0 ? dots : rings, shown_value(of, i), share);
            if (error > 0.0) series_add_to(figure, errors, shown_value(of, i), share - error, share + error);
        }
    }
}

// ---------------------------------------------------------------- the figure

/// Returns the words of the caption on the strips, and on the panel of shares that diagrams of attractors have.
static const char *strips_of(const bifurcation *of) {
    if (of->attractors == 0)
        return of->both ? " (upper strip: followed from the first value on; lower strip: from the last)" : "";
    if (of->table->source->neighbours == 0)
        return " (a strip for each attractor, the first at the top) and the share of the starts";
    return " (a strip for each attractor, the first at the top) and the share of the starts (circles: found from "
           "neighbours "
           "alone)";
}

static void write_caption(const bifurcation *of, whirl_figure *figure) {
    snprintf(figure->caption, sizeof figure->caption,
             "Poincar\u00e9 section of %s (one dot a revolution) over %s, coloured by %s.%s Below: the regime%s%s, the "
             "largest Lyapunov exponent with its standard error, %s%s%s%s.",
             of->result->stations[of->station].name, of->table->parameter,
             of->attractors > 0 ? "the attractor that starts lead to" : "regime",
             of->shaded ? " Shaded: the rotor rubs." : "", strips_of(of),
             !of->confidence ? ""
             : of->both      ? ", how far it can be trusted (bars: from the first value on; lines: from the last)"
                             : ", how far it can be trusted",
             of->clearance > 0.0 ? "largest eccentricity ratio" : "largest radius",
             of->gap > 0.0 ? " (dashed: the gap to the stator)" : "", of->rub ? ", share of the time in contact" : "",
             of->both ? " (blue: from the first value on; orange: from the last)" : "");
}

static void bifurcation_list(figure_list *to, const drawing *of, const whirl_table *table) {
    if (!table_is_sweep(of, table) || !table_has(table, WHIRL_FIELD_POINCARE_SECTION)) return;
    for (size_t s = 0; s < of->result->station_count; s++) {
        const char *station = of->result->stations[s].name;
        const figure_place place = {.kind = &bifurcation_figure, .table = table, .point = NO_POINT, .station = s};
        char name[2 * WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "bifurcation-%s", station);
        list_figure(to, &place, name, "Bifurcation diagram of %s over %s", station, table->parameter);
    }
}

static void bifurcation_describe(const drawing *to, const figure_place *place, whirl_figure *figure) {
    bifurcation of = {.result = to->result,
                      .table = place->table,
                      .machine = to->machine,
                      .station = place->station,
                      .units = to->units,
                      .length = to->units->length,
                      .value = 1.0 / whirl_shown_parameter(to->units, place->table->parameter).size};
    bifurcation_survey(&of);
    figure->width = 8.5;
    figure->font = 6.5;
    write_caption(&of, figure);
    add_section(figure, &of, 0);
    add_section(figure, &of, 1);
    add_regimes(figure, &of);
    if (of.attractors > 0) add_shares(figure, &of);
    if (of.confidence) add_confidence(figure, &of);
    add_exponents(figure, &of);
    add_radius(figure, &of);
    if (of.rub) add_contact(figure, &of);
    if (figure->count > 0) figure->panels[figure->count - 1]->x.shown = true;
}

const figure_kind bifurcation_figure = {.list = bifurcation_list,
                                        .describe = bifurcation_describe,
                                        .stem = "bifurcation-",
                                        .study = "{sweep: ..., analyze: [poincare]}"};
