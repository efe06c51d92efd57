// Spectra of one point at a station, with the orders of their largest lines.
#include "machine_at.h"
#include "named_lines.h"
#include "point_panels.h"
#include "units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "figure_kinds.h"
#include "whirl/internal/spectrum.h"

enum {
    MAX_BINS = 2500, ///< largest number of bins in a drawn spectrum; of more, each group of bins is drawn as its
                     ///< largest (peak hold)
    MAX_LABELS = 8   ///< largest number of spectral lines with a label
};

static double order_size(const subject *of) {
    return isnan(of->order) ? 1.0 : of->order;
}

static double amplitude(const double *line, int full) {
    return full ? fmax(line[3], line[4]) : fmax(line[1], line[2]);
}

/// Axis of amplitudes: logarithmic if some lines would be too small on a linear one.
typedef struct scale {
    bool logarithmic;
    double low, high; ///< limits, in shown units
} scale;

/// Least amplitude, relative to the largest, that is visible on a linear axis.
static const double SEEN = 0.01;

/// Makes the axis of amplitudes, with room for the label of the tallest line.
static scale scale_of(const subject *of, int full, double room) {
    double tallest = 0.0, least = INFINITY;
    for (size_t k = 0; k < of->spectrum.rows; k++) tallest = fmax(tallest, amplitude(&of->spectrum.at[5 * k], full));
    for (size_t k = 0; k < of->lines.rows; k++) {
        const double height = amplitude(&of->lines.at[5 * k], full);
        if (height > 0.0) least = fmin(least, height);
    }
    const double high = of->amplitude * (tallest > 0.0 ? tallest : 1.0);
    if (!(least < SEEN * tallest)) return (scale){false, 0.0, room * high};
    const double low = fmin(0.3 * of->amplitude * least, 1e-3 * high);
    return (scale){true, low, high * pow(high / low, room - 1.0)};
}

/// Returns the position of an amplitude on the axis, from 0 to 1.
static double scale_place(const scale *axis, double height) {
    if (!axis->logarithmic) return height / axis->high;
    return fmax(log(fmax(height, axis->low) / axis->low) / log(axis->high / axis->low), 0.0);
}

/// Returns the amplitude at a position of the axis.
static double scale_height(const scale *axis, double place) {
    return axis->logarithmic ? axis->low * pow(axis->high / axis->low, place) : place * axis->high;
}

/// A peak that may have a label: its frequency (place), negative for backward peaks of a full spectrum, and its height
/// on the axis, 0 to 1.
typedef struct peak {
    double place, height;
} peak;

static int by_height(const void *left, const void *right) {
    const double a = ((const peak *)left)->height, b = ((const peak *)right)->height;
    return (a < b) - (a > b);
}

/// Returns the height of the drawn curve near an order, in shown units. The amplitude of a line whose order is between
/// two bins is slightly higher.
static double drawn_height(const subject *of, double order, int column) {
    double most = 0.0;
    const double *at = of->spectrum.at;
    const double step = of->spectrum.rows > 1 ? at[5] - at[0] : 1.0;
    const double middle = step > 0.0 ? fmin((order - at[0]) / step, (double)of->spectrum.rows) : 0.0;
    const size_t first = middle > 2.0 ? (size_t)middle - 2 : 0;
    for (size_t k = first; k < of->spectrum.rows && k < first + 5; k++) most = fmax(most, at[5 * k + (size_t)column]);
    return of->amplitude * most;
}

static size_t find_peaks(const subject *of, const scale *axis, int full, peak *peaks) {
    size_t count = 0;
    for (size_t k = 0; k < of->lines.rows && k < WHIRL_MAX_LINES; k++) {
        const double order = of->lines.at[5 * k], at = order_size(of) * order;
        if (!full) peaks[count++] = (peak){at, fmax(drawn_height(of, order, 1), drawn_height(of, order, 2))};
        if (full) peaks[count++] = (peak){at, drawn_height(of, order, 3)};
        if (full) peaks[count++] = (peak){-at, drawn_height(of, order, 4)};
    }
    for (size_t k = 0; k < count; k++) peaks[k].height = scale_place(axis, peaks[k].height);
    if (count > 1) qsort(peaks, count, sizeof *peaks, by_height);
    return count;
}

/// Box of a label over the axis of frequencies; empty if low is not below high.
typedef struct label {
    double low, high, height;
} label;

static bool label_fits(const label *candidate, const label *placed, int count, double tall) {
    for (int i = 0; i < count; i++)
        if (candidate->low < placed[i].high && candidate->high > placed[i].low &&
            fabs(candidate->height - placed[i].height) < tall)
            return false;
    return true;
}

/// Returns true if no labelled peak is within a distance: of the peaks of a broad hump only the largest has a label.
static bool peak_stands_alone(const peak *candidate, const peak *labelled, int count, double distance) {
    for (int i = 0; i < count; i++)
        if (fabs(labelled[i].place - candidate->place) < distance) return false;
    return true;
}

/// Returns the side of the nearest other peak of about this height: -1 left, 1 right, 0 none.
static int neighbour_side(const peak *peaks, size_t count, const peak *of, double wide, double tall) {
    const peak *nearest = NULL;
    for (const peak *other = peaks; other < peaks + count; other++) {
        if (other == of || fabs(other->height - of->height) > tall || fabs(other->place - of->place) > wide) continue;
        if (!nearest || fabs(other->place - of->place) < fabs(nearest->place - of->place)) nearest = other;
    }
    return !nearest ? 0 : nearest->place < of->place ? -1 : 1;
}

/// Places a label above the peak or, if it has a neighbour, on the other side; else on any free side. Returns an empty
/// label if none fits.
static label place_label(const peak *of, int neighbour, const label *placed, int count, double wide, double tall) {
    const label tries[] = {{of->place - 0.5 * wide, of->place + 0.5 * wide, of->height},
                           {of->place - 0.1 * wide, of->place + 0.9 * wide, of->height},
                           {of->place - 0.9 * wide, of->place + 0.1 * wide, of->height}};
    const int first = neighbour == 0 ? 0 : neighbour < 0 ? 1 : 2;
    for (int i = 0; i < 3; i++)
        if (label_fits(&tries[(first + i) % 3], placed, count, tall)) return tries[(first + i) % 3];
    return (label){0};
}

/// Writes the frequency of a peak and the machine's name for its order, "3.58 (BPFO)". Returns the number of letters.
static int label_text(const subject *of, const whirl_machine *named, double place, char *text, size_t size) {
    const int letters = snprintf(text, size, "%.3g", place);
    char name[LINE_NAME_SIZE];
    whirl_named_order whose;
    if (!named || !named_line(named->system, place / order_size(of), of->station, name, &whose)) return letters;
    return letters + snprintf(text + letters, size - (size_t)letters, " (%s)", name);
}

/// Labels the largest lines with their orders.
static void add_line_labels(whirl_figure *figure, whirl_panel *panel, const subject *of, const scale *axis,
                            double highest, int full) {
    peak peaks[2 * WHIRL_MAX_LINES], labelled[MAX_LABELS];
    label placed[MAX_LABELS];
    const size_t found = find_peaks(of, axis, full, peaks);
    whirl_series *texts = panel_series(figure, panel, WHIRL_TEXTS, "#000000", 1.0);
    int count = 0;
    whirl_machine own;
    const bool made = machine_at(of->machine, of->table, of->point, &own);
    for (size_t k = 0; k < found && count < MAX_LABELS; k++) {
        if (peaks[k].height < 0.05 * peaks[0].height || fabs(peaks[k].place) > 0.97 * highest) continue;
        if (!peak_stands_alone(&peaks[k], labelled, count, 0.025 * highest)) continue;
        char text[32 + LINE_NAME_SIZE];
        const int letters = label_text(of, made ? &own : NULL, fabs(peaks[k].place), text, sizeof text);
        // Keep half a letter between neighbouring labels.
        const double wide = 0.017 * highest * (letters + 0.5), tall = 0.06;
        const int neighbour = neighbour_side(peaks, found, &peaks[k], wide, tall);
        const label here = place_label(&peaks[k], neighbour, placed, count, wide, tall);
        if (!(here.low < here.high)) continue;
        labelled[count] = peaks[k];
        placed[count++] = here;
        series_add_text(figure, texts, 0.5 * (here.low + here.high), scale_height(axis, here.height), text);
    }
    if (made) own.release(own.owner);
}

/// Returns the highest frequency drawn, in its shown unit.
static double highest_order(const subject *of) {
    const double last = of->spectrum.at[5 * (of->spectrum.rows - 1)];
    return order_size(of) * (last > 0.0 ? last : 1.0);
}

static void label_spectrum(whirl_panel *panel, const subject *of, int full) {
    panel->keyed = true;
    symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude", panel->y.label, sizeof panel->y.label);
    units_order_label(of->units, isnan(of->order), full, panel->x.label, sizeof panel->x.label);
}

/// Sets up a spectrum's axes and labels its largest lines. Returns its axis of amplitudes.
static scale begin_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of, int full) {
    const double highest = highest_order(of);
    const scale axis = scale_of(of, full, full ? 1.24 : 1.22);
    label_spectrum(panel, of, full);
    axis_show(&panel->x, (span){full ? -highest : 0.0, highest});
    axis_show(&panel->y, (span){axis.low, axis.high});
    panel->y.logarithmic = axis.logarithmic;
    add_line_labels(figure, panel, of, &axis, highest, full);
    return axis;
}

/// Adds a column of the spectrum as a curve; of too many bins, each group is drawn as its largest.
static void add_spectrum(whirl_figure *figure, whirl_series *line, const subject *of, const scale *axis, int column,
                         double direction) {
    const size_t group = (of->spectrum.rows + MAX_BINS - 1) / MAX_BINS;
    for (size_t first = 0; first < of->spectrum.rows; first += group) {
        double most = 0.0, place = of->spectrum.at[5 * first];
        for (size_t k = first; k < first + group && k < of->spectrum.rows; k++) {
            const double *at = &of->spectrum.at[5 * k];
            if (at[column] > most) place = at[0];
            most = fmax(most, at[column]);
        }
        series_add(figure, line, direction * order_size(of) * place, fmax(of->amplitude * most, axis->low));
    }
}

void add_half_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    const scale axis = begin_spectrum(figure, panel, of, 0);
    panel_named(figure, panel, WHIRL_LINE, "$x$", line_colour(0), 0.53);
    add_spectrum(figure, panel_named(figure, panel, WHIRL_LINE, "$y$", line_colour(1), 0.38), of, &axis, 2, 1.0);
    add_spectrum(figure, panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.38), of, &axis, 1, 1.0);
}

void add_full_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    const scale axis = begin_spectrum(figure, panel, of, 1);
    add_spectrum(figure, panel_named(figure, panel, WHIRL_LINE, "backward", line_colour(1), 0.38), of, &axis, 4, -1.0);
    add_spectrum(figure, panel_named(figure, panel, WHIRL_LINE, "forward", line_colour(0), 0.38), of, &axis, 3, 1.0);
}

void add_lines(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    double highest = 0.0, tallest = 0.0;
    for (size_t k = 0; k < of->lines.rows && !isnan(of->lines.at[5 * k]); k++) {
        highest = fmax(highest, order_size(of) * of->lines.at[5 * k]);
        tallest = fmax(tallest, of->amplitude * amplitude(&of->lines.at[5 * k], 1));
    }
    label_spectrum(panel, of, 1);
    axis_show(&panel->x, (span){-1.08 * highest, 1.08 * highest});
    axis_show(&panel->y, (span){0.0, 1.2 * (tallest > 0.0 ? tallest : 1.0)});
    for (size_t way = 0; way < 2; way++) {
        whirl_series *bars =
            panel_named(figure, panel, WHIRL_BARS, way ? "forward" : "backward", line_colour(1 - way), 1.1);
        for (size_t k = 0; k < of->lines.rows && !isnan(of->lines.at[5 * k]); k++)
            series_add_to(figure, bars, (way ? 1.0 : -1.0) * order_size(of) * of->lines.at[5 * k], 0.0,
                          of->amplitude * of->lines.at[5 * k + (way ? 3 : 4)]);
    }
}

/// Draws a spectrum of a motion besides x and y, or its lines if the whole spectrum was not stored; size: factor from
/// its amplitudes to those shown.
static void add_extra_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of, const numbers *spectrum,
                               const numbers *lines, double size) {
    const bool whole = spectrum->at != NULL;
    const numbers *own = whole ? spectrum : lines;
    whirl_series *line = panel_series(figure, panel, whole ? WHIRL_LINE : WHIRL_BARS, line_colour(2), 0.53);
    double highest = 0.0, tallest = 0.0;
    units_order_label(of->units, isnan(of->order), 0, panel->x.label, sizeof panel->x.label);
    for (size_t k = 0; k < own->rows && !isnan(own->at[2 * k]); k++) {
        const double order = order_size(of) * own->at[2 * k], height = size * own->at[2 * k + 1];
        highest = fmax(highest, order);
        tallest = fmax(tallest, height);
        if (whole)
            series_add(figure, line, order, height);
        else
            series_add_to(figure, line, order, 0.0, height);
    }
    axis_show(&panel->x, (span){0.0, whole ? highest : 1.08 * highest});
    axis_show(&panel->y, (span){0.0, 1.2 * (tallest > 0.0 ? tallest : 1.0)});
}

void add_axial_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude", panel->y.label, sizeof panel->y.label);
    add_extra_spectrum(figure, panel, of, &of->axial_spectrum, &of->axial_lines, of->amplitude);
}

void add_twist_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    snprintf(panel->y.label, sizeof panel->y.label, "amplitude (\u00b0)");
    add_extra_spectrum(figure, panel, of, &of->twist_spectrum, &of->twist_lines, 180.0 / acos(-1.0));
}
