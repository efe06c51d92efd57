// Panels of one point and station, as the 2015 paper's figures 4 to 11 show them: waveform, orbit, spectrum and
// Poincaré map, and the full spectrum below.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figures.h"
#include "gnuplot.h"
#include "machine_at.h"
#include "quantities.h"
#include "typeset.h"

/// An orbit is near a circle that it misses or passes by this share of its size.
static const double NEAR = 0.35;

enum {
    MOST_BINS = 2500, ///< of a drawn spectrum: more are grouped and the largest of a group is kept (peak hold)
    MOST_LABELS = 8,  ///< spectral lines that get their order written beside them
    SHOWN_TURNS = 10  ///< revolutions of the waveform panel
};

/// A point at a station with what there is of it.
typedef struct subject {
    const whirl_result *result;
    const whirl_table *table;
    size_t point, station;
    numbers waveform, section, spectrum, lines;
    machine_walls walls; ///< around the station
    size_t turn;         ///< samples of the waveform a revolution
    span x, y;           ///< of the orbit, or of the section where there is no waveform; as shown
    double size;         ///< of the motion: the larger side of its box; as shown
    const whirl_shown_units *units;
    /// What numbers of the result are multiplied by to be shown: displacements, amplitudes, orders (NaN: they stay
    /// orders).
    double length, amplitude, order;
} subject;

static double order_size(const subject *of) {
    return isnan(of->order) ? 1.0 : of->order;
}

static subject subject_of(const drawing *to, const whirl_table *table, size_t point, size_t station) {
    const whirl_shown_units *units = to->units;
    subject of = {.result = to->result, .table = table, .point = point, .station = station, .units = units};
    of.length = whirl_shown_length(units, table, point);
    of.amplitude = of.length * units->amplitude;
    of.order = units_order(units, machine_clock(to->machine, to->result, table, point));
    of.walls = machine_walls_at(to->machine, to->result, table, point, station);
    of.waveform = point_waveform(table, point, station);
    of.section = point_section(table, point, station);
    of.spectrum = point_spectrum(table, point, station);
    of.lines = point_lines(table, point, station);
    of.turn = (size_t)whirl_record_samples(&table->record, table->integrate.steps_per_revolution);
    if (of.turn == 0) of.turn = 1;
    of.x = of.y = span_empty();
    for (size_t k = 0; k < of.waveform.rows; k++) {
        span_widen(&of.x, of.length * of.waveform.at[2 * k]);
        span_widen(&of.y, of.length * of.waveform.at[2 * k + 1]);
    }
    for (size_t k = 0; k < of.section.rows; k++) {
        span_widen(&of.x, of.length * of.section.at[4 * k]);
        span_widen(&of.y, of.length * of.section.at[4 * k + 1]);
    }
    of.size = fmax(fmax(of.x.high - of.x.low, of.y.high - of.y.low), 1e-9 * of.length);
    return of;
}

// ---------------------------------------------------------------- data

/// Revolutions before the end, x, y; the end of every revolution (the instant of the section) stands in a second block.
static void write_waveform(FILE *data, const subject *of) {
    const size_t rows = of->waveform.rows;
    fprintf(data, "# revolution  x  y (lengths in %.10g m)\n",
            whirl_result_length_scale(of->result, of->table, of->point));
    for (int marks = 0; marks < 2; marks++) {
        for (size_t k = 0; k < rows; k++)
            if (!marks || (rows - 1 - k) % of->turn == 0)
                fprintf(data, "%.8g %.8g %.8g\n", (double)(k + 1) / (double)of->turn, of->waveform.at[2 * k],
                        of->waveform.at[2 * k + 1]);
        if (!marks) fputs("\n\n# once a revolution\n", data);
    }
}

static void write_section(FILE *data, const subject *of) {
    fprintf(data, "# x  y (lengths in %.10g m)  x'  y' (per radian of the rotation), once a revolution\n",
            whirl_result_length_scale(of->result, of->table, of->point));
    for (size_t k = 0; k < of->section.rows; k++) {
        const double *at = &of->section.at[4 * k];
        fprintf(data, "%.10g %.10g %.10g %.10g\n", at[0], at[1], at[2], at[3]);
    }
}

static void write_spectrum(FILE *data, const subject *of) {
    const size_t group = (of->spectrum.rows + MOST_BINS - 1) / MOST_BINS;
    fprintf(data, "# order  x  y  forward  backward (amplitudes, zero to peak, in %.10g m)\n",
            whirl_result_length_scale(of->result, of->table, of->point));
    if (group > 1)
        fprintf(data, "# %zu bins of %.6g orders each stand as one: the largest amplitudes\n", group,
                of->spectrum.rows > 1 ? of->spectrum.at[5] - of->spectrum.at[0] : 0.0);
    for (size_t first = 0; first < of->spectrum.rows; first += group) {
        double most[5] = {of->spectrum.at[5 * first], 0.0, 0.0, 0.0, 0.0};
        for (size_t k = first; k < first + group && k < of->spectrum.rows; k++) {
            const double *at = &of->spectrum.at[5 * k];
            if (fmax(at[1], at[2]) > fmax(most[1], most[2])) most[0] = at[0];
            for (int c = 1; c < 5; c++) most[c] = fmax(most[c], at[c]);
        }
        fprintf(data, "%.8g %.6g %.6g %.6g %.6g\n", most[0], most[1], most[2], most[3], most[4]);
    }
}

static whirl_status write_data(const drawing *to, const subject *of, figure *what) {
    static const char *const kinds[] = {"waveform", "section", "spectrum"};
    static void (*const writers[])(FILE *, const subject *) = {write_waveform, write_section, write_spectrum};
    const numbers arrays[] = {of->waveform, of->section, of->spectrum};
    for (int i = 0; i < 3; i++) {
        if (!arrays[i].at) continue;
        report_file file;
        snprintf(what->data[i], sizeof what->data[i], "%.180s-%s.dat", what->stem, kinds[i]);
        whirl_status status = report_file_open(&file, to->folder, what->data[i]);
        if (status.code != WHIRL_OK) return status;
        writers[i](file.stream, of);
        status = report_file_close(&file);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- panels

/// The letter that the caption names the panel by, and where labels stand.
static void write_panel_letter(FILE *script, char letter) {
    fprintf(
        script,
        "set label 97 '(%c)' at graph 0, graph 1 right offset -1.2, 0.7\nset xlabel offset 0, 0.5\nset ylabel offset "
        "1, 0\n",
        letter);
}

static void write_waveform_panel(FILE *script, const subject *of, const figure *what) {
    const double turns = (double)of->waveform.rows / (double)of->turn, shown = fmin(turns, SHOWN_TURNS);
    span both = of->x;
    span_widen(&both, of->y.low);
    span_widen(&both, of->y.high);
    both = span_with_margin(both, 0.12, 1e-9 * of->length);
    fprintf(script,
            "set xlabel 'revolution'\nset ylabel xy_label\n"
            "set xrange [%.8g:%.8g]\nset yrange [%.10g:%.10g]\n"
            "set xtics %g\nset ytics %g\nset key inside top right horizontal samplen 1.5\n"
            "plot '%s' index 0 using 1:(length*$2) with lines linestyle 1 title '{/:Italic x}', \\\n"
            "  '' index 0 using 1:(length*$3) with lines linestyle 2 title '{/:Italic y}', \\\n"
            "  '' index 1 using 1:(length*$2) with points pointtype 7 pointsize 0.2 linecolor rgb '#303030' notitle, "
            "'' index 1 using 1:(length*$3) with points pointtype 7 pointsize 0.2 linecolor rgb '#303030' notitle\n"
            "unset key\n",
            turns - shown, turns, both.low, both.high, tic_step(shown, 10), tic_step(both.high - both.low, 8),
            what->data[0]);
}

/// A square of the plane: its middle and its side.
typedef struct window {
    double x, y, side;
} window;

static window window_around(span x, span y, double side) {
    return (window){0.5 * (x.low + x.high), 0.5 * (y.low + y.high), side};
}

static void write_window(FILE *script, const window *in) {
    fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n", in->x - 0.5 * in->side,
            in->x + 0.5 * in->side, in->y - 0.5 * in->side, in->y + 0.5 * in->side);
    fprintf(script,
            "set xlabel x_label\nset ylabel y_label\n"
            "set size ratio -1\nset xtics %g\nset ytics %g\n",
            tic_step(in->side, 6), tic_step(in->side, 6));
}

/// Whether a circle around (0, 0) passes through a window; one of radius 0 is none.
static bool circle_shows(const window *in, double radius) {
    const double half = 0.5 * in->side, x = fabs(in->x), y = fabs(in->y);
    return radius > 0.0 && radius >= hypot(fmax(x - half, 0.0), fmax(y - half, 0.0)) &&
           radius <= hypot(x + half, y + half);
}

/// The part of a circle around (0, 0) that falls into a window, as a plot.
static void write_circle(FILE *script, const window *in, double radius, const char *style) {
    // From outside of it the window is seen from the centre under an angle below that of its circumscribed circle.
    const double distance = hypot(in->x, in->y), reach = 0.7072 * in->side, pi = acos(-1.0);
    const double half = distance > reach ? asin(reach / distance) : pi, middle = atan2(in->y, in->x);
    fprintf(script,
            "sample [angle = %.8g:%.8g:%.8g] '+' using (%.10g*cos(angle)):(%.10g*sin(angle)) with lines %s, \\\n  ",
            middle - half, middle + half, half / 500.0, radius, radius, style);
}

/// The window holds the orbit and, where the orbit comes near a circle, the nearest part of that too.
static window orbit_window(const subject *of) {
    span x = of->x, y = of->y;
    const double circles[] = {of->length * of->walls.clearance, of->length * of->walls.gap};
    size_t far = 0;
    double most = 0.0;
    for (size_t k = 0; k < of->waveform.rows; k++) {
        const double r = of->length * hypot(of->waveform.at[2 * k], of->waveform.at[2 * k + 1]);
        if (r > most) far = k, most = r;
    }
    for (int i = 0; i < 2 && most > 0.0; i++) {
        const double r = circles[i];
        if (r <= 0.0 || fabs(r - most) > NEAR * of->size) continue;
        span_widen(&x, of->length * of->waveform.at[2 * far] * r / most);
        span_widen(&y, of->length * of->waveform.at[2 * far + 1] * r / most);
        if (of->size < r) continue; // a small orbit: an arc is enough
        for (int side = -1; side <= 1; side += 2) span_widen(&x, side * r), span_widen(&y, side * r);
    }
    return window_around(x, y, 1.16 * fmax(x.high - x.low, y.high - y.low));
}

/// Which circles the orbit's window shows: bit 0 the bearing, bit 1 the stator.
static unsigned shown_circles(const subject *of) {
    const window in = orbit_window(of);
    return (unsigned)circle_shows(&in, of->length * of->walls.clearance) |
           (unsigned)circle_shows(&in, of->length * of->walls.gap) << 1;
}

static void write_orbit_panel(FILE *script, const subject *of, const figure *what) {
    const window in = orbit_window(of);
    const unsigned circles = shown_circles(of);
    write_window(script, &in);
    fputs("plot ", script);
    if (circles & 1u)
        write_circle(script, &in, of->length * of->walls.clearance, "linewidth 1.2 linecolor rgb '#9A9A9A'");
    if (circles & 2u)
        write_circle(script, &in, of->length * of->walls.gap, "linewidth 0.7 linecolor rgb '#707070' dashtype 2");
    fprintf(
        script,
        "'%s' index 0 using (length*$2):(length*$3) with lines linestyle 1 linewidth 0.5, \\\n"
        "  '' index 1 using (length*$2):(length*$3) with points pointtype 7 pointsize 0.25 linecolor rgb '#D55E00'\n"
        "set size noratio\n",
        what->data[0]);
}

/// The window follows the section, but never below a fifth of the motion: rounding noise of a fixed point is no
/// structure.
static void write_section_panel(FILE *script, const subject *of, const figure *what) {
    span x = span_empty(), y = span_empty();
    for (size_t k = 0; k < of->section.rows; k++) {
        span_widen(&x, of->length * of->section.at[4 * k]);
        span_widen(&y, of->length * of->section.at[4 * k + 1]);
    }
    const double extent = fmax(x.high - x.low, y.high - y.low);
    const window in = window_around(x, y, fmax(1.24 * extent, 0.2 * of->size));
    write_window(script, &in);
    const double size = of->section.rows > 1000 && extent > 1e-3 * of->size &&
                                whirl_table_verdict(of->table, of->point).regime != WHIRL_PERIODIC
                            ? 0.08
                            : 0.25;
    fprintf(script,
            "plot '%s' using (length*$1):(length*$2) with points pointtype 7 pointsize %.2f linecolor rgb "
            "'#0072B2'\nset size noratio\n",
            what->data[1], size);
}

static double amplitude(const double *line, int full) {
    return full ? fmax(line[3], line[4]) : fmax(line[1], line[2]);
}

/// The axis of amplitudes: logarithmic where lines would be lost at the foot of a linear one.
typedef struct scale {
    bool logarithmic;
    double low, high; ///< as shown
} scale;

/// Lines of a spectrum below this share of the largest are not seen on a linear axis.
static const double SEEN = 0.01;

/// Over the tallest line stands room for its label.
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

/// Where on the axis an amplitude stands, from 0 to 1.
static double scale_place(const scale *axis, double height) {
    if (!axis->logarithmic) return height / axis->high;
    return fmax(log(fmax(height, axis->low) / axis->low) / log(axis->high / axis->low), 0.0);
}

/// gnuplot's own logarithmic axes leave the panels that follow with a linked axis, so that logarithms are drawn.
static void write_scale(FILE *script, const scale *axis, int tics) {
    if (axis->logarithmic)
        fprintf(script,
                "height(amplitude) = log10(amplitude > %.8g ? amplitude : %.8g)\n"
                "set yrange [%.8g:%.8g]\nset ytics 1\nset format y '10^{%%g}'\n",
                axis->low, axis->low, log10(axis->low), log10(axis->high));
    else
        fprintf(script, "height(amplitude) = amplitude\nset yrange [0:%.8g]\nset ytics %g\n", axis->high,
                tic_step(axis->high, tics));
}

/// After a panel with that axis.
static void end_scale(FILE *script, const scale *axis) {
    if (axis->logarithmic) fputs("set format y '% h'\n", script);
}

/// A peak that may get its order written above it, and its height on the axis; in a full spectrum backward ones stand
/// on the left.
typedef struct peak {
    double place, height;
} peak;

static int by_height(const void *left, const void *right) {
    const double a = ((const peak *)left)->height, b = ((const peak *)right)->height;
    return (a < b) - (a > b);
}

/// Height of the drawn curve, as shown, near an order: that of a line between two bins is a little larger.
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

/// The place of a label: its side of the peak and the orders that it covers.
typedef struct label {
    const char *side;
    double low, high, height;
} label;

static bool label_fits(const label *candidate, const label *placed, int count, double tall) {
    for (int i = 0; i < count; i++)
        if (candidate->low < placed[i].high && candidate->high > placed[i].low &&
            fabs(candidate->height - placed[i].height) < tall)
            return false;
    return true;
}

/// Peaks of one broad hump share the label of the largest.
static bool peak_stands_alone(const peak *candidate, const peak *labelled, int count, double distance) {
    for (int i = 0; i < count; i++)
        if (fabs(labelled[i].place - candidate->place) < distance) return false;
    return true;
}

/// Where another peak of about this height stands beside it: -1 left, 1 right, 0 nowhere. Of two the nearer counts.
static int neighbour_side(const peak *peaks, size_t count, const peak *of, double wide, double tall) {
    const peak *nearest = NULL;
    for (const peak *other = peaks; other < peaks + count; other++) {
        if (other == of || fabs(other->height - of->height) > tall || fabs(other->place - of->place) > wide) continue;
        if (!nearest || fabs(other->place - of->place) < fabs(nearest->place - of->place)) nearest = other;
    }
    return !nearest ? 0 : nearest->place < of->place ? -1 : 1;
}

/// Above the peak or, where it has a neighbour, on the side away from that; else on whatever side no label is there.
/// side NULL where nothing fits.
static label place_label(const peak *of, int neighbour, const label *placed, int count, double wide, double tall) {
    const label tries[] = {{"center", of->place - 0.5 * wide, of->place + 0.5 * wide, of->height},
                           {"left", of->place - 0.1 * wide, of->place + 0.9 * wide, of->height},
                           {"right", of->place - 0.9 * wide, of->place + 0.1 * wide, of->height}};
    const int first = neighbour == 0 ? 0 : neighbour < 0 ? 1 : 2;
    for (int i = 0; i < 3; i++)
        if (label_fits(&tries[(first + i) % 3], placed, count, tall)) return tries[(first + i) % 3];
    return (label){0};
}

/// Writes the orders of the largest lines above them.
static void write_line_labels(FILE *script, const subject *of, const scale *axis, double highest, int full) {
    peak peaks[2 * WHIRL_MAX_LINES], labelled[MOST_LABELS];
    label placed[MOST_LABELS];
    const size_t found = find_peaks(of, axis, full, peaks);
    int count = 0;
    for (size_t k = 0; k < found && count < MOST_LABELS; k++) {
        if (peaks[k].height < 0.05 * peaks[0].height || fabs(peaks[k].place) > 0.97 * highest) continue;
        if (!peak_stands_alone(&peaks[k], labelled, count, 0.025 * highest)) continue;
        char text[32];
        const int letters = snprintf(text, sizeof text, "%.3g", fabs(peaks[k].place));
        // Half a letter between neighbours.
        const double wide = 0.017 * highest * (letters + 0.5), tall = 0.06;
        const int neighbour = neighbour_side(peaks, found, &peaks[k], wide, tall);
        const label here = place_label(&peaks[k], neighbour, placed, count, wide, tall);
        if (!here.side) continue;
        labelled[count] = peaks[k];
        placed[count++] = here;
        const double anchor = *here.side == 'l' ? here.low : *here.side == 'r' ? here.high : peaks[k].place;
        fprintf(script, "set label %d '%s' at first %.6g, graph %.4f %s offset 0, 0.35 font small_font\n", 100 + count,
                text, anchor, peaks[k].height, here.side);
    }
}

/// The frequency up to which the spectrum is drawn, as shown.
static double highest_order(const subject *of) {
    const double last = of->spectrum.at[5 * (of->spectrum.rows - 1)];
    return order_size(of) * (last > 0.0 ? last : 1.0);
}

/// What a spectrum's panel begins with: axes, and the orders of the largest lines. Gives its axis of amplitudes.
static scale begin_spectrum(FILE *script, const subject *of, int full) {
    const double highest = highest_order(of);
    const scale axis = scale_of(of, full, full ? 1.24 : 1.22);
    fprintf(script, "set xlabel frequency_label%s\nset ylabel amplitude_label\nset xrange [%.6g:%.6g]\nset xtics %g\n",
            full ? ".' (negative: backward whirl)'" : "", full ? -highest : 0.0, highest, tic_step(highest, 6));
    write_scale(script, &axis, full ? 5 : 6);
    write_line_labels(script, of, &axis, highest, full);
    return axis;
}

static void write_spectrum_panel(FILE *script, const subject *of, const figure *what) {
    const scale axis = begin_spectrum(script, of, 0);
    fprintf(
        script,
        "set key inside top right horizontal samplen 1.5\n"
        "plot keyentry with lines linestyle 1 title '{/:Italic x}', \\\n"
        "  '%s' using (order*$1):(height(amplitude*$3)) with lines linestyle 2 linewidth 0.5 title '{/:Italic y}', \\\n"
        "  '' using (order*$1):(height(amplitude*$2)) with lines linestyle 1 linewidth 0.5 notitle\n"
        "unset key\ndo for [i = 101:%d] { unset label i }\n",
        what->data[2], 100 + MOST_LABELS);
    end_scale(script, &axis);
}

static void write_full_spectrum_panel(FILE *script, const subject *of, const figure *what) {
    const scale axis = begin_spectrum(script, of, 1);
    fprintf(script,
            "set label 98 'backward' at graph 0.015, 0.9 left textcolor rgb '#D55E00'\n"
            "set label 99 'forward' at graph 0.985, 0.9 right textcolor rgb '#0072B2'\n"
            "plot '%s' using (-order*$1):(height(amplitude*$5)) with lines linestyle 2 linewidth 0.5, \\\n"
            "  '' using (order*$1):(height(amplitude*$4)) with lines linestyle 1 linewidth 0.5\n"
            "do for [i = 98:%d] { unset label i }\n",
            what->data[2], 100 + MOST_LABELS);
    end_scale(script, &axis);
}

enum { WAVEFORM_PANEL, ORBIT_PANEL, SPECTRUM_PANEL, SECTION_PANEL, FULL_PANEL, PANEL_COUNT };

/// Which panels there are data for, in the order in which they are lettered.
static void panels_there(const subject *of, bool there[PANEL_COUNT]) {
    there[WAVEFORM_PANEL] = there[ORBIT_PANEL] = of->waveform.at != NULL;
    there[SPECTRUM_PANEL] = there[FULL_PANEL] = of->spectrum.at != NULL;
    there[SECTION_PANEL] = of->section.at != NULL;
}

static const double WIDTH = 17.5, SIDE = 6.5, GAP = 1.5, LOW_PANEL = 4.2; // cm

/// Draws the panels, two a row, the full spectrum across below.
static void write_panels(FILE *script, const subject *of, const figure *what, double height) {
    static void (*const panels[])(FILE *, const subject *, const figure *) = {
        write_waveform_panel, write_orbit_panel, write_spectrum_panel, write_section_panel};
    bool there[PANEL_COUNT];
    panels_there(of, there);
    const double side = SIDE / height, gap = GAP / height, square = SIDE / WIDTH;
    double high = 1.0 - 0.7 / height;
    int place = 0;
    for (int i = 0; i < FULL_PANEL; i++) {
        if (!there[i]) continue;
        // The right column is square, for orbits and maps; where only they are left they may stand on the left too.
        if (place % 2 == 0)
            script_panel(script, 0.085, i % 2 ? 0.085 + square : 0.505, high - side, high);
        else
            script_panel(script, 0.975 - square, 0.975, high - side, high);
        write_panel_letter(script, (char)('a' + place));
        panels[i](script, of, what);
        if (place == 0) fputs("unset label 1\n", script);
        if (place % 2 == 1) high -= side + gap;
        place++;
    }
    if (place % 2 == 1) high -= side + gap;
    if (!there[FULL_PANEL]) return;
    script_panel(script, 0.085, 0.975, high - LOW_PANEL / height, high);
    write_panel_letter(script, (char)('a' + place));
    write_full_spectrum_panel(script, of, what);
}

static double figure_height(const subject *of) {
    const int panels = (of->waveform.at ? 2 : 0) + (of->spectrum.at ? 1 : 0) + (of->section.at ? 1 : 0);
    const int rows = (panels + 1) / 2;
    return 0.7 + rows * (SIDE + GAP) + (of->spectrum.at ? LOW_PANEL + 1.1 : -0.4);
}

/// What stands at the axes, and what the numbers of the data files are multiplied by.
static void write_labels(FILE *script, const subject *of) {
    const whirl_shown_units units = typeset_units(of->units);
    char text[TYPESET_SIZE];
    units_length_label(&units, "{/:Italic x}", text, sizeof text);
    script_label(script, "x_label", text);
    units_length_label(&units, "{/:Italic y}", text, sizeof text);
    script_label(script, "y_label", text);
    fprintf(script, units.ratio ? "xy_label = x_label.', '.y_label\n" : "xy_label = '{/:Italic x}, '.y_label\n");
    units_amplitude_label(&units, "amplitude", text, sizeof text);
    script_label(script, "amplitude_label", text);
    const char *keyphasor = whirl_result_keyphasor(of->result);
    if (isnan(of->order))
        snprintf(text, sizeof text, "order of the %s", *keyphasor ? keyphasor : "running speed");
    else
        snprintf(text, sizeof text, "frequency (%s)", of->units->frequency_name);
    script_label(script, "frequency_label", text);
    fprintf(script, "# Of one unit of the data files:\nlength = %.15g\namplitude = %.15g\norder = %.15g\n", of->length,
            of->amplitude, order_size(of));
}

static whirl_status write_script(const drawing *to, const subject *of, const figure *what) {
    report_file file;
    const double height = figure_height(of);
    const whirl_status status = script_begin(&file, to, what, WIDTH, height, 8.0);
    if (status.code != WHIRL_OK) return status;
    write_labels(file.stream, of);
    script_loop(file.stream);
    write_panels(file.stream, of, what, height);
    script_end(file.stream);
    return report_file_close(&file);
}

/// " (a) Waveform, (b) orbit (grey: bearing), ...": what the letters stand for.
static void name_panels(const subject *of, char *text, size_t size) {
    const unsigned circles = of->waveform.at ? shown_circles(of) : 0;
    const char *orbit = circles == 3u   ? "orbit (grey: bearing, dashed: stator)"
                        : circles == 1u ? "orbit (grey: bearing)"
                        : circles == 2u ? "orbit (dashed: stator)"
                                        : "orbit";
    const char *const names[] = {"waveform", orbit, "spectrum", "Poincar\u00e9 map (once a revolution)",
                                 "full spectrum of x + iy"};
    bool there[PANEL_COUNT];
    size_t used = 0;
    char letter = 'a';
    panels_there(of, there);
    text[0] = '\0';
    for (int i = 0; i < PANEL_COUNT && used < size; i++)
        if (there[i]) {
            used += (size_t)snprintf(text + used, size - used, "%s (%c) %s", letter > 'a' ? "," : "", letter, names[i]);
            letter++;
        }
}

static whirl_status draw_point(const drawing *to, const subject *of) {
    char point[UNIT_LABEL_SIZE], verdict_text[LABEL_SIZE], stem[STEM_SIZE], panels[280];
    const char *station = of->result->stations[of->station].name;
    const whirl_verdict verdict = whirl_table_verdict(of->table, of->point);
    const whirl_unit unit = whirl_shown_parameter(of->units, of->table->parameter);
    units_point_label(of->units, of->table, of->point, point, sizeof point);
    whirl_verdict_name(&verdict, verdict_text, sizeof verdict_text);
    if (*of->table->parameter)
        snprintf(stem, sizeof stem, "%.63s-%.6g%.20s-%.63s", of->table->parameter,
                 of->table->values[of->point] / unit.size, unit.name, station);
    else
        snprintf(stem, sizeof stem, "%s-%s", of->table->name, station);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->point = (long)of->point;
    what->station = of->station;
    snprintf(what->title, sizeof what->title, "%.80s, %.60s: %.54s", point, station, verdict_text);
    name_panels(of, panels, sizeof panels);
    snprintf(what->caption, sizeof what->caption, "%.120s, %.60s: %.100s.%s.%s", point, station, verdict_text, panels,
             of->waveform.at ? "" : " No waveform was kept.");
    const whirl_status status = write_data(to, of, what);
    return status.code == WHIRL_OK ? write_script(to, of, what) : status;
}

whirl_status draw_points(const drawing *to) {
    const whirl_table *table = detail_table(to->result);
    whirl_status status = whirl_ok();
    for (size_t i = 0; table && i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        for (size_t s = 0; s < to->result->station_count && status.code == WHIRL_OK; s++) {
            const subject of = subject_of(to, table, i, s);
            if (of.waveform.at || of.section.at || of.spectrum.at) status = draw_point(to, &of);
        }
    }
    return status;
}
