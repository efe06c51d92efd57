// Figures of spectra in run-ups: waterfalls over the time, cascades over the speed, and spectrograms.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "quantities.h"
#include "runup_panels.h"
#include "two_pi.h"
#include "units.h"

/// Figures of spectra: values of figure_place.which.
enum { WATERFALL, CASCADE, SPECTROGRAM, KINDS };

/// Number of figures: of x and y, then of axial displacements and of twists.
enum { ALL_KINDS = 3 * KINDS };

/// Motions of a station that have spectra.
typedef enum spectra_motion { OF_PLANE, ALONG_AXIS, ABOUT_AXIS } spectra_motion;

/// Fields of their spectra.
static const char *const spectra_fields[] = {WHIRL_FIELD_RUNUP_SPECTRUM, WHIRL_FIELD_RUNUP_AXIAL_SPECTRUM,
                                             WHIRL_FIELD_RUNUP_TWIST_SPECTRUM};

/// MAX_LINES: largest number of spectra that are drawn as lines. MAX_TIMES, MAX_BOXES: largest numbers of boxes along
/// the time and, in each direction of whirl, along the frequency. A box joins several spectra or bins, and has their
/// largest amplitude.
enum { MAX_LINES = 60, MAX_TIMES = 240, MAX_BOXES = 200 };

/// TALL: height of the largest peak of a line, as a part of the axis. MIN_AMPLITUDE: least amplitude of a box, relative
/// to the largest.
static const double TALL = 0.12, MIN_AMPLITUDE = 1e-3;

/// The spectra of a run at a station.
typedef struct run_spectra {
    size_t count, bins;
    const double *times, *speeds, *orders; ///< [count], [count], [bins]
    const double *amplitudes;              ///< [count][bins][2] forward, backward; else than of x and y [count][bins]
    bool axial;                            ///< of an axial displacement or a twist, which do not whirl
    bool twist;
    double length, largest; ///< factor to shown amplitudes; largest shown amplitude
} run_spectra;

static bool spectra_of(const drawing *of, const whirl_table *table, size_t station, spectra_motion motion,
                       run_spectra *out) {
    const bool axial = motion != OF_PLANE;
    size_t runs[MAX_RUNS];
    if (!table_has(table, WHIRL_FIELD_RUNUP_SPECTRUM) || runup_list_runs(table, runs) == 0) return false;
    *out = (run_spectra){.count = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_SPECTRUM_TIME)->rows,
                         .bins = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_SPECTRUM_ORDER)->rows,
                         .times = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_SPECTRUM_TIME, 0),
                         .speeds = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_SPECTRUM_SPEED, 0),
                         .orders = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_SPECTRUM_ORDER, 0),
                         .amplitudes = whirl_table_field(table, runs[0], spectra_fields[motion], station),
                         .axial = axial,
                         .twist = motion == ABOUT_AXIS,
                         .length = motion == ABOUT_AXIS ? 180.0 / acos(-1.0)
                                                        : units_length(of->units, table, runs[0], WHIRL_AMPLITUDE)};
    if (!out->times || !out->speeds || !out->orders || !out->amplitudes) return false;
    for (size_t k = 0; k < (axial ? 1 : 2) * out->count * out->bins; k++)
        if (out->length * out->amplitudes[k] > out->largest) out->largest = out->length * out->amplitudes[k];
    return out->largest > 0.0;
}

/// Returns the shown amplitude of a bin; negative bins are backward.
static double spectra_at(const run_spectra *of, size_t spectrum, long bin) {
    const size_t place = spectrum * of->bins + (size_t)labs(bin);
    return of->length * of->amplitudes[of->axial ? place : 2 * place + (bin < 0)];
}

/// Returns the shown frequency of an order at a speed; in Hz if the units show frequencies as orders.
static double spectra_frequency(const drawing *of, double order, double speed) {
    return order * speed / two_pi / (of->units->frequency > 0.0 ? of->units->frequency : 1.0);
}

static void spectra_label_frequency(const drawing *of, bool axial, whirl_axis *axis) {
    snprintf(axis->label, sizeof axis->label, axial ? "frequency (%s)" : "frequency (%s, negative: backward whirl)",
             of->units->frequency > 0.0 ? of->units->frequency_name : "Hz");
}

/// Returns the first bin of spectra; negative bins are backward.
static long spectra_first_bin(const run_spectra *of) {
    return of->axial ? 0 : 1 - (long)of->bins;
}

/// Adds the spectra from `first` to `end` - 1 as lines, each raised to its time or speed.
static void spectra_add_lines(const drawing *of, const run_spectra *s, bool by_speed, size_t first, size_t end,
                              const char *name, double width, whirl_figure *figure) {
    whirl_panel *panel = figure_panel(figure, name, width, 9.5);
    if (!panel) return;
    // Choose the axis along which spectra are raised, and draw at most MAX_LINES of them.
    const double unit = runup_label_over(of, &panel->y, by_speed);
    const double *const over = by_speed ? s->speeds : s->times;
    const size_t step = (end - first + MAX_LINES - 1) / MAX_LINES;
    // Find the ranges of both axes.
    span range = span_empty();
    double reach = 0.0;
    for (size_t k = first; k < end; k++) {
        const double last = s->orders[s->bins - 1];
        span_widen(&range, over[k] / unit);
        if (isfinite(over[k])) reach = fmax(reach, by_speed ? spectra_frequency(of, last, s->speeds[k]) : last);
    }
    // Label and show the axes.
    if (by_speed)
        spectra_label_frequency(of, s->axial, &panel->x);
    else
        units_order_label(of->units, true, !s->axial, panel->x.label, sizeof panel->x.label);
    const double high = range.high > range.low ? range.high - range.low : fmax(fabs(range.high), 1.0);
    axis_show(&panel->x, (span){s->axial ? 0.0 : -reach, reach});
    axis_show(&panel->y, (span){range.low - 0.02 * high, range.high + 1.1 * TALL * high});
    // Draw each spectrum from the highest backward order to the highest forward one.
    const long bins = (long)s->bins;
    for (size_t k = first; k < end; k += step) {
        if (!isfinite(over[k])) continue;
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.4);
        for (long bin = spectra_first_bin(s); bin < bins; bin++) {
            const double order = (bin < 0 ? -1.0 : 1.0) * s->orders[labs(bin)];
            series_add(figure, line, by_speed ? spectra_frequency(of, order, s->speeds[k]) : order,
                       over[k] / unit + TALL * high * spectra_at(s, k, bin) / s->largest);
        }
    }
}

/// Returns the number of spectra up to the one with the highest speed, if the speed falls clearly after it; else the
/// number of all spectra.
static size_t spectra_turning(const run_spectra *s) {
    size_t top = 0, last = 0;
    for (size_t k = 0; k < s->count; k++) {
        if (!isfinite(s->speeds[k])) continue;
        if (!isfinite(s->speeds[top]) || s->speeds[k] > s->speeds[top]) top = k;
        last = k;
    }
    const bool rises = top > 2 && s->count - top > 2 && s->speeds[last] < 0.95 * s->speeds[top];
    return rises ? top + 1 : s->count;
}

/// Draws amplitudes as coloured boxes over time and frequency.
static void spectra_add_boxes(const drawing *of, const run_spectra *s, whirl_figure *figure) {
    whirl_panel *panel = figure_panel(figure, "spectrogram", 1.0, 8.4);
    if (!panel) return;
    const double unit = runup_label_over(of, &panel->x, false);
    const double half = s->bins > 1 ? 0.5 * (s->orders[1] - s->orders[0]) : 0.5;
    const size_t step = (s->count + MAX_TIMES - 1) / MAX_TIMES;
    const long bins = (long)s->bins, wide = (bins + MAX_BOXES - 1) / MAX_BOXES;
    spectra_label_frequency(of, s->axial, &panel->y);
    whirl_series *boxes = panel_series(figure, panel, WHIRL_BOXES, "#000000", 1.0);
    for (size_t k = 0; k < s->count; k += step) {
        const size_t next = k + step < s->count ? k + step : s->count;
        // A box lasts from half-way after the spectrum before it to half-way before the spectrum after it.
        const double before = k > 0 && isfinite(s->times[k - 1]) ? s->times[k - 1] : s->times[k];
        const double after = next < s->count && isfinite(s->times[next]) ? s->times[next] : s->times[next - 1];
        const span x = {0.5 * (before + s->times[k]) / unit, 0.5 * (s->times[next - 1] + after) / unit};
        if (!isfinite(x.low) || !isfinite(x.high)) continue;
        for (long bin = spectra_first_bin(s); bin < bins; bin += wide) {
            const long end = bin + wide < bins ? bin + wide : bins;
            double most = 0.0;
            for (size_t i = k; i < next; i++)
                for (long b = bin; b < end; b++) most = fmax(most, spectra_at(s, i, b));
            if (!(most >= MIN_AMPLITUDE * s->largest)) continue;
            const double low = 2.0 * half * (double)bin - half, high = 2.0 * half * (double)(end - 1) + half;
            series_add_box(figure, boxes, x,
                           (span){spectra_frequency(of, low, s->speeds[k]), spectra_frequency(of, high, s->speeds[k])});
            series_value(figure, boxes, most);
        }
    }
    // Set the scale of colours.
    figure->scale = (whirl_colour_scale){.low = MIN_AMPLITUDE * s->largest,
                                         .high = s->largest,
                                         .logarithmic = true,
                                         .colours = waterfall_colours,
                                         .count = WATERFALL_COLOURS};
    if (s->twist)
        snprintf(figure->scale.label, sizeof figure->scale.label, "amplitude (\u00b0)");
    else
        symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude", figure->scale.label, sizeof figure->scale.label);
}

// ---------------------------------------------------------------- the figures

static const struct {
    const char *name, *title;
} alike[ALL_KINDS] = {{"runup-waterfall", "Spectra of %.60s over the time"},
                      {"runup-cascade", "Spectra of %.60s over the speed"},
                      {"runup-spectrogram", "Frequencies of %.60s over the time"},
                      {"runup-axial-waterfall", "Spectra of %.60s along the shaft over the time"},
                      {"runup-axial-cascade", "Spectra of %.60s along the shaft over the speed"},
                      {"runup-axial-spectrogram", "Frequencies of %.60s along the shaft over the time"},
                      {"runup-twist-waterfall", "Spectra of the twist of %.60s over the time"},
                      {"runup-twist-cascade", "Spectra of the twist of %.60s over the speed"},
                      {"runup-twist-spectrogram", "Frequencies of the twist of %.60s over the time"}};

static void spectra_list(figure_list *to, const drawing *of, const whirl_table *table) {
    run_spectra spectra;
    char name[2 * WHIRL_NAME_SIZE];
    for (size_t s = 0; s < of->result->station_count; s++)
        for (size_t which = 0; which < ALL_KINDS; which++) {
            const spectra_motion motion = (spectra_motion)(which / KINDS);
            if (motion == OF_PLANE && of->result->stations[s].twists) continue;
            if (!spectra_of(of, table, s, motion, &spectra)) continue;
            const figure_place place = {
                .kind = &runup_spectra_figure, .table = table, .point = NO_POINT, .station = s, .which = which};
            snprintf(name, sizeof name, "%s-%.63s", alike[which].name, of->result->stations[s].name);
            list_figure(to, &place, name, alike[which].title, of->result->stations[s].name);
        }
}

static whirl_status spectra_find(figure_list *list, const drawing *of, const char *name) {
    whirl_status status = whirl_ok();
    (void)list;
    for (size_t which = 0; which < ALL_KINDS && status.code == WHIRL_OK; which++)
        status = runup_find(of, name, alike[which].name, spectra_fields[which / KINDS], "spectra");
    return status;
}

static void spectra_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    run_spectra s;
    // Draw coloured boxes, or lines; a cascade of a run whose speed falls again has a panel for each direction.
    const spectra_motion motion = (spectra_motion)(place->which / KINDS);
    const size_t which = place->which % KINDS;
    if (!spectra_of(of, table, place->station, motion, &s)) return;
    const size_t turning = which == CASCADE ? spectra_turning(&s) : s.count;
    if (which == SPECTROGRAM) {
        spectra_add_boxes(of, &s, figure);
    } else if (turning == s.count) {
        spectra_add_lines(of, &s, which == CASCADE, 0, s.count, "spectra", 1.0, figure);
    } else {
        figure->width = 17.5;
        spectra_add_lines(of, &s, true, 0, turning, "up", 0.5, figure);
        spectra_add_lines(of, &s, true, turning - 1, s.count, "down", 0.5, figure);
        for (size_t i = 0; i < figure->count; i++)
            snprintf(figure->panels[i]->title, sizeof figure->panels[i]->title, i == 0 ? "up" : "down");
    }
    // Describe the spectra, and their largest amplitude.
    char largest[4 * WHIRL_NAME_SIZE];
    if (s.twist)
        snprintf(largest, sizeof largest, "amplitude (\u00b0)");
    else
        units_length_label(of->units, WHIRL_AMPLITUDE, "amplitude", largest, sizeof largest);
    snprintf(figure->caption, sizeof figure->caption,
             s.twist ? "Spectra of the twist of %.60s over the angle of the shaft, each over %d turns with a Hann "
                       "window. "
             : s.axial
                 ? "Spectra of the axial displacement of %.60s over the angle of the shaft, each over %d turns "
                   "with a Hann window. "
                 : "Spectra of x + iy of %.60s over the angle of the shaft, each over %d turns with a Hann window: "
                   "forward whirl on the positive side, backward whirl on the negative one. ",
             of->result->stations[place->station].name, table->record.runup.spectrum_turns);
    const size_t used = strlen(figure->caption);
    if (which == SPECTROGRAM)
        snprintf(figure->caption + used, sizeof figure->caption - used,
                 "Amplitudes below a thousandth of the largest are left white.");
    else
        snprintf(figure->caption + used, sizeof figure->caption - used, "The tallest peak has %.4g as %s.", s.largest,
                 largest);
    runup_caption_runs(of, table, 1, figure);
}

const figure_kind runup_spectra_figure = {.list = spectra_list, .describe = spectra_describe, .find = spectra_find};
