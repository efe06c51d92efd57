// Figures of fits: measured numbers of a file, those of the fitted machine, and their differences.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "shown_kinds.h"
#include "two_pi.h"
#include "whirl/engine/fit.h"
#include "whirl/internal/fit_columns.h"

/// Kinds of panels.
enum { FIT_DISPLACEMENT, FIT_RESIDUAL, FIT_LAG };

static void fit_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_FIT_NUMBER);
    const size_t point = field ? fit_best(table) : table->count;
    (void)of;
    if (point == table->count) return;
    const double *rows = whirl_table_field(table, point, WHIRL_FIELD_FIT_NUMBER, 0);
    double last = -1.0;
    for (size_t i = 0; i < field->rows; i++) {
        const double set = rows[FIT_NUMBER_COLUMNS * i + FIT_SET];
        if (set == last || !whirl_fit_is_motion((whirl_fit_quantity)rows[FIT_NUMBER_COLUMNS * i + FIT_QUANTITY]))
            continue;
        last = set;
        const figure_place place = {.kind = &fit_figure, .table = table, .point = (long)point, .which = (size_t)set};
        char name[WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "fit-%.0f", set + 1.0);
        list_figure(to, &place, name, "Measured numbers of file %.0f and the fitted machine", set + 1.0);
    }
}

/// Returns true if two rows belong to one line of a panel: same probe, for statistics the same
/// kind of number and, except for samples and waveforms, the same order.
static bool fit_is_line(const double *a, const double *b) {
    const bool both = a[FIT_STATION] == b[FIT_STATION] && a[FIT_ANGLE] == b[FIT_ANGLE];
    const bool statistics = whirl_fit_is_statistic((whirl_fit_quantity)a[FIT_QUANTITY]);
    if (!both || (statistics && a[FIT_QUANTITY] != b[FIT_QUANTITY])) return false;
    return a[FIT_QUANTITY] == WHIRL_FIT_SAMPLE || a[FIT_QUANTITY] == WHIRL_FIT_WAVEFORM || a[FIT_AT] == b[FIT_AT];
}

/// Writes what a panel shows of a row, measured and of the model, in SI. A row with a cosine part is followed by that
/// with the sine part. Returns false for rows that the panel does not show.
static bool fit_seen(const double *row, int panel, double seen[2]) {
    const bool parts = row[FIT_QUANTITY] == WHIRL_FIT_COS;
    const double *sine = row + FIT_NUMBER_COLUMNS;
    if (!whirl_fit_is_motion((whirl_fit_quantity)row[FIT_QUANTITY])) return false;
    if (row[FIT_QUANTITY] == WHIRL_FIT_SIN || (panel == FIT_LAG && !parts)) return false;
    for (int i = 0; i < 2; i++) {
        const double own = row[FIT_MEASURED + i], other = parts ? sine[FIT_MEASURED + i] : 0.0;
        seen[i] = panel == FIT_LAG ? fmod(atan2(other, own) + two_pi, two_pi) : parts ? hypot(own, other) : own;
    }
    if (panel == FIT_RESIDUAL) seen[0] -= seen[1];
    return true;
}

/// Moves lags by whole turns: the model's next to `before`, that of the previous row, and the measured one next to the
/// model's.
static void fit_unwind(double seen[2], double before) {
    seen[1] -= two_pi * round((seen[1] - before) / two_pi);
    seen[0] -= two_pi * round((seen[0] - seen[1]) / two_pi);
}

/// A panel of one file.
typedef struct fit_panel {
    const drawing *of;
    const whirl_table *table;
    size_t point, first, count; ///< rows of the file
    bool samples, waveform;     ///< displacements over the angle or the time; else parts of orders over the speed
    double x_unit;
} fit_panel;

static const double *fit_row(const fit_panel *p, size_t i) {
    return whirl_table_field(p->table, p->point, WHIRL_FIELD_FIT_NUMBER, 0) + FIT_NUMBER_COLUMNS * (p->first + i);
}

/// Returns the place of a row along the axis: degrees, seconds, or the speed of its motion.
static double fit_along(const fit_panel *p, const double *row) {
    if (p->samples) return 360.0 * row[FIT_AT];
    if (p->waveform) return row[FIT_AT];
    const double *motions = whirl_table_field(p->table, p->point, WHIRL_FIELD_FIT_MOTION, 0);
    return motions[FIT_MOTION_COLUMNS * (size_t)row[FIT_MOTION]] / p->x_unit;
}

static void fit_draw(const fit_panel *p, int kind, double y_unit, whirl_figure *figure, whirl_panel *panel) {
    size_t colour = 0;
    // Draw each line (a probe of a motion) once, at its first row.
    for (size_t i = 0; i < p->count; i++) {
        const double *first = fit_row(p, i);
        bool drawn = false;
        for (size_t k = 0; k < i && !drawn; k++) drawn = fit_is_line(fit_row(p, k), first);
        double seen[2];
        if (drawn || !fit_seen(first, kind, seen)) continue;
        // Name and colour the line.
        char name[2 * WHIRL_NAME_SIZE], both[2 * WHIRL_NAME_SIZE + 16];
        fit_name_probe(p->of->result, first, name, sizeof name);
        const char *shown = line_colour(colour++);
        // Draw measured numbers as dots, those of the fitted machine as a line.
        for (int which = 0; which < (kind == FIT_RESIDUAL ? 1 : 2); which++) {
            snprintf(both, sizeof both, "%.100s, %s", name, which ? "fitted" : "measured");
            whirl_series *series = panel_named(figure, panel, which ? WHIRL_LINE : WHIRL_DOTS,
                                               kind == FIT_DISPLACEMENT ? both : "", shown, which ? 0.8 : 2.0);
            // Collect the points of the line; lags continue across 360 degrees.
            double before = 0.0;
            for (size_t k = i; k < p->count; k++) {
                if (!fit_is_line(first, fit_row(p, k)) || !fit_seen(fit_row(p, k), kind, seen)) continue;
                if (kind == FIT_LAG) fit_unwind(seen, before);
                before = seen[1];
                series_add(figure, series, fit_along(p, fit_row(p, k)), seen[which] / y_unit);
            }
        }
    }
}

/// Keeps the rows around the largest displacement of a long waveform. Returns the number of its samples, 0 if all are
/// shown.
static size_t fit_shorten(fit_panel *p) {
    enum { SHOWN = 2000 };
    size_t probes = 1, largest = 0;
    while (probes < p->count && fit_row(p, probes)[FIT_AT] == fit_row(p, 0)[FIT_AT]) probes++;
    const size_t samples = p->count / probes, shown = SHOWN * probes;
    if (!p->waveform || samples <= SHOWN) return 0;
    for (size_t i = 1; i < p->count; i++)
        if (fabs(fit_row(p, i)[FIT_MEASURED]) > fabs(fit_row(p, largest)[FIT_MEASURED])) largest = i;
    const size_t middle = largest / probes * probes, before = shown / 2;
    size_t begin = middle > before ? middle - before : 0;
    if (begin + shown > p->count) begin = (p->count - shown) / probes * probes;
    p->first += begin;
    p->count = shown;
    return samples;
}

static void fit_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_field *field = whirl_layout_field(&place->table->layout, WHIRL_FIELD_FIT_NUMBER);
    fit_panel p = {.of = of, .table = place->table, .point = (size_t)place->point};
    const double *rows = whirl_table_field(p.table, p.point, WHIRL_FIELD_FIT_NUMBER, 0);
    // The rows of the file.
    while (p.first < field->rows && rows[FIT_NUMBER_COLUMNS * p.first + FIT_SET] != (double)place->which) p.first++;
    while (p.first + p.count < field->rows &&
           rows[FIT_NUMBER_COLUMNS * (p.first + p.count) + FIT_SET] == (double)place->which)
        p.count++;
    if (p.count == 0) return;
    const whirl_unit *length = &of->units->of[WHIRL_QUANTITY_LENGTH], *speed = &of->units->of[WHIRL_QUANTITY_SPEED];
    bool lags = false;
    p.samples = fit_row(&p, 0)[FIT_QUANTITY] == WHIRL_FIT_SAMPLE;
    p.waveform = fit_row(&p, 0)[FIT_QUANTITY] == WHIRL_FIT_WAVEFORM;
    p.x_unit = speed->size;
    const size_t samples = fit_shorten(&p);
    for (size_t i = 0; i < p.count; i++) lags = lags || fit_row(&p, i)[FIT_QUANTITY] == WHIRL_FIT_COS;
    // Displacements or amplitudes, their residuals, and lags.
    for (int kind = FIT_DISPLACEMENT; kind <= FIT_LAG; kind++) {
        static const char *const names[] = {"displacement", "residual", "lag"};
        if (kind == FIT_LAG && !lags) continue;
        whirl_panel *panel = figure_panel(figure, names[kind], 1.0, kind == FIT_DISPLACEMENT ? 5.0 : 2.6);
        if (!panel) return;
        if (p.samples)
            snprintf(panel->x.label, sizeof panel->x.label, "angle of the shaft (deg)");
        else if (p.waveform)
            snprintf(panel->x.label, sizeof panel->x.label, "time (s)");
        else
            snprintf(panel->x.label, sizeof panel->x.label, "speed (%s)", speed->name);
        if (kind == FIT_LAG)
            snprintf(panel->y.label, sizeof panel->y.label, "lag (deg)");
        else
            snprintf(panel->y.label, sizeof panel->y.label, "%s (%s)",
                     kind == FIT_RESIDUAL      ? "residual"
                     : p.samples || p.waveform ? "displacement"
                                               : "amplitude",
                     length->name);
        fit_draw(&p, kind, kind == FIT_LAG ? two_pi / 360.0 : length->size, figure, panel);
    }
    snprintf(figure->caption, sizeof figure->caption,
             "Measured numbers (dots) and those of the machine with the fitted parameters (lines). Residuals are "
             "measured less fitted%s.",
             p.samples || p.waveform ? "" : ", of amplitudes");
    const size_t used = strlen(figure->caption);
    if (samples > 0)
        snprintf(figure->caption + used, sizeof figure->caption - used,
                 " Of %zu samples those around the largest displacement are shown.", samples);
}

const figure_kind fit_figure = {
    .list = fit_list, .describe = fit_describe, .stem = "fit-", .study = "{fit: {unknown: {...}, data: ...}}"};
