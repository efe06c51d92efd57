// Bifurcation diagrams: the Poincare section of a station against the swept parameter, coloured by regime, above the
// verdict and its confidence, the largest Lyapunov exponent, the largest radius and the time in contact on the same
// axis.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figures.h"
#include "gnuplot.h"
#include "quantities.h"
#include "regimes.h"
#include "typeset.h"

enum {
    GRID = 2000,        ///< dots nearer to each other than 1/GRID of the axis are written once
    MOST_DOTS = 100000, ///< of a figure, so that its PDF stays small
    LEAST_DOTS = 64,    ///< of a point
    MANY_POINTS = 150   ///< of a sweep: so many stand so close together that small dots are enough
};

/// What the panels share.
typedef struct diagram {
    const whirl_result *result;
    const whirl_table *table;
    size_t station;
    const char *data; ///< file of the section
    span parameter, x, y, exponent, radius;
    bool rub, confidence, present[CLASS_COUNT], both;
    const shown_units *units;
    double length, value; ///< what displacements and values of the parameter are multiplied by to be shown
    double share;         ///< largest share of the time in contact, with a margin
    double gap;           ///< radius at which the station touches a stator, 0 where none is near
    bool ratios;          ///< the points have equal ratios: the axis is logarithmic
} diagram;

static int by_value(const void *left, const void *right) {
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/// The range of the exponents without the rare deep minima at superstable points, which would flatten all else.
static span exponent_span(const whirl_table *table) {
    span range = span_empty();
    double *sorted = malloc((table->count + 1) * sizeof *sorted);
    size_t count = 0;
    for (size_t i = 0; sorted && i < table->count; i++) {
        const double value = point_exponent(table, i).value;
        if (isfinite(value)) sorted[count++] = value;
    }
    if (count > 0) {
        qsort(sorted, count, sizeof *sorted, by_value);
        const double low = sorted[count / 20], high = sorted[count - 1 - count / 20], reach = 1.5 * (high - low);
        span_widen(&range, fmax(sorted[0], low - reach));
        span_widen(&range, fmin(sorted[count - 1], high + reach));
        span_widen(&range, 0.0);
    }
    free(sorted);
    return span_with_margin(range, 0.08, 0.01);
}

/// How many places of the study lie between two points of the table; 0 across branches.
static double places_between(const whirl_table *table, size_t a, size_t b) {
    if (b >= table->count || table->branch[a] != table->branch[b]) return 0.0;
    return (double)whirl_table_slot(table, b) - (double)whirl_table_slot(table, a);
}

/// Whether a sweep was made with `scale: log`: the ratios of neighbours are the same throughout, their differences are
/// not.
static bool has_equal_ratios(const whirl_table *table) {
    const double *v = table->values;
    if (places_between(table, 0, 1) == 0.0 || places_between(table, 1, 2) == 0.0 || !(v[0] > 0.0)) return false;
    const double ratio = log(v[1] / v[0]) / places_between(table, 0, 1);
    for (size_t i = 1; i < table->count && places_between(table, i - 1, i) != 0.0; i++)
        if (!(v[i] > 0.0) ||
            !(fabs(log(v[i] / v[i - 1]) / places_between(table, i - 1, i) - ratio) < 1e-6 * fabs(ratio)))
            return false;
    const double first = (v[1] - v[0]) / places_between(table, 0, 1),
                 next = (v[2] - v[1]) / places_between(table, 1, 2);
    return fabs(next - first) > 1e-6 * fabs(first);
}

/// Half-way between two values, as the axis has it.
static double middle(const diagram *of, double a, double b) {
    return of->ratios ? sqrt(a * b) : 0.5 * (a + b);
}

/// Where a value lies that is as far from `a` as `b` is, on the other side.
static double mirrored(const diagram *of, double a, double b) {
    return of->ratios ? a * (a / b) : a + (a - b);
}

/// The value beside a point, one place further on (1) or before (-1); NaN where the table does not tell.
static double value_beside(const diagram *of, size_t i, int side) {
    const whirl_table *const table = of->table;
    if (side < 0 && i == 0) return NAN;
    const size_t other = side < 0 ? i - 1 : i + 1;
    const double apart = side < 0 ? places_between(table, other, i) : places_between(table, i, other);
    if (apart <= 0.0) return NAN;
    const double at = table->values[i], there = table->values[other];
    return of->ratios ? at * pow(there / at, 1.0 / apart) : at + (there - at) / apart;
}

/// What of the axis belongs to a point, in SI: up to half-way to its neighbours in its branch.
static void point_edges(const diagram *of, size_t i, double *low, double *high) {
    const double at = of->table->values[i];
    double before = value_beside(of, i, -1), after = value_beside(of, i, 1);
    if (isnan(before)) before = isnan(after) ? at - 1.0 : mirrored(of, at, after);
    if (isnan(after)) after = mirrored(of, at, before);
    *low = fmin(middle(of, at, before), middle(of, at, after));
    *high = fmax(middle(of, at, before), middle(of, at, after));
}

static void survey(diagram *of) {
    const whirl_table *table = of->table;
    span parameter = span_empty(), x = span_empty(), y = span_empty(), radius = span_empty();
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const numbers section = point_section(table, i, of->station);
        const whirl_verdict verdict = whirl_table_verdict(table, i);
        of->present[regime_class_of(&verdict)] = true;
        of->both |= table->branch[i] < 0;
        span_widen(&parameter, of->value * table->values[i]);
        span_widen(&radius, of->length * max_radius(table, i, of->station));
        of->share = fmax(of->share, 1.1 * rub_share(table, i, of->result->contact_count));
        for (size_t k = 0; k < section.rows; k++) {
            span_widen(&x, of->length * section.at[4 * k]);
            span_widen(&y, of->length * section.at[4 * k + 1]);
        }
    }
    of->share = of->share > 0.0 ? of->share : 0.01;
    of->ratios = has_equal_ratios(table);
    for (size_t i = 0; i < table->count; i++) {
        double low, high;
        if (!whirl_table_done(table, i)) continue;
        point_edges(of, i, &low, &high);
        span_widen(&parameter, of->value * low);
        span_widen(&parameter, of->value * high);
    }
    of->parameter = of->ratios ? parameter : span_with_margin(parameter, 0.012, 0.0);
    of->x = span_with_margin(x, 0.04, 1e-6 * of->length);
    of->y = span_with_margin(y, 0.04, 1e-6 * of->length);
    of->gap = of->length * of->result->stations[of->station].gap;
    if (of->gap > 2.0 * radius.high) of->gap = 0.0; // so far off that the radius would be a line at the bottom
    if (of->gap > 0.0) span_widen(&radius, of->gap);
    of->radius = span_with_margin(radius, 0.08, 1e-6 * of->length);
    of->exponent = exponent_span(table);
    of->rub = has_rub(table, of->result->contact_count);
    of->confidence = whirl_layout_field(&table->layout, "regime/confidence") != NULL;
}

// ---------------------------------------------------------------- data

/// A dot on the grid of the figure, and where in the section it comes from.
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

static void write_dots(FILE *data, const diagram *of, size_t point, dot *dots) {
    const numbers section = point_section(of->table, point, of->station);
    const size_t share = MOST_DOTS / (of->table->count + 1), most = share > LEAST_DOTS ? share : LEAST_DOTS;
    const size_t count = section.rows < most ? section.rows : most;
    for (size_t k = 0; k < count; k++) {
        const size_t row = section.rows - count + k;
        dots[k] = (dot){cell(of->length * section.at[4 * row], of->x),
                        cell(of->length * section.at[4 * row + 1], of->y), row};
    }
    qsort(dots, count, sizeof *dots, by_place);
    for (size_t k = 0; k < count; k++) {
        if (k > 0 && dots[k].x == dots[k - 1].x && dots[k].y == dots[k - 1].y) continue;
        const double *at = &section.at[4 * dots[k].row];
        fprintf(data, "%.10g %.7g %.7g\n", of->table->values[point], at[0], at[1]);
    }
}

/// One block (gnuplot: index) for each class that is present and each branch, in that order.
static whirl_status write_section_data(const drawing *to, const diagram *of, const char *name) {
    report_file file;
    whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    const size_t rows = whirl_layout_field(&of->table->layout, "poincare/section")->rows;
    dot *dots = malloc((rows + 1) * sizeof *dots);
    fprintf(file.stream, "# parameter (SI)  x  y (lengths in %.10g m); dots that coincide in print stand once\n",
            of->result->length_scale);
    for (int kind = 0; kind < CLASS_COUNT && dots; kind++) {
        if (!of->present[kind]) continue;
        for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
            fprintf(file.stream, "\n\n# %s%s\n", regime_class_name((regime_class)kind),
                    of->both ? branch > 0 ? ", from the first value on" : ", from the last value on" : "");
            fprintf(file.stream, "nan nan nan\n"); // keeps the count of the blocks where a block is empty
            for (size_t i = 0; i < of->table->count; i++) {
                if (!whirl_table_done(of->table, i)) continue;
                const whirl_verdict verdict = whirl_table_verdict(of->table, i);
                const int side = of->table->branch[i] < 0 ? -1 : 1;
                if ((int)regime_class_of(&verdict) == kind && side == branch) write_dots(file.stream, of, i, dots);
            }
        }
    }
    const bool memory = dots != NULL;
    free(dots);
    status = report_file_close(&file);
    return memory ? status : whirl_fail(WHIRL_NO_MEMORY, "no memory for the dots of a bifurcation diagram");
}

static void write_sweep_line(FILE *data, const diagram *of, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(of->table, point);
    const whirl_estimate exponent = point_exponent(of->table, point);
    fprintf(data, "%.10g %d %d %.6g %.3g %.6g", of->table->values[point], (int)regime_class_of(&verdict),
            (int)verdict.confidence, exponent.value, exponent.error,
            rub_share(of->table, point, of->result->contact_count));
    for (size_t s = 0; s < of->result->station_count; s++) fprintf(data, " %.7g", max_radius(of->table, point, s));
    double low, high;
    point_edges(of, point, &low, &high);
    fprintf(data, " %.10g %.10g\n", low, high);
}

/// One line a point, one block a branch; an empty line where points were not computed.
static whirl_status write_sweep_data(const drawing *to, const diagram *of) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, "sweep.dat");
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream,
            "# parameter (SI)  class  confidence (0 low, 1 fair, 2 high)  exponent (1/revolution)  its error  "
            "rub share");
    for (size_t s = 0; s < of->result->station_count; s++)
        fprintf(file.stream, "  largest radius of station %zu (%.10g m)", s + 1, of->result->length_scale);
    fputs("  half-way to the points beside it (SI), below and above", file.stream);
    fprintf(file.stream, "\n# classes:");
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(file.stream, " %d %s;", kind, regime_class_name((regime_class)kind));
    fputc('\n', file.stream);
    for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2) {
        bool any = false;
        size_t before = 0;
        for (size_t i = 0; i < of->table->count; i++) {
            if ((of->table->branch[i] < 0 ? -1 : 1) != branch) continue;
            if (!whirl_table_done(of->table, i)) continue;
            const size_t slot = whirl_table_slot(of->table, i);
            if (any && slot != before + 1) fputc('\n', file.stream);
            write_sweep_line(file.stream, of, i);
            any = true;
            before = slot;
        }
        fputs("\n\n", file.stream);
    }
    return report_file_close(&file);
}

// ---------------------------------------------------------------- script

/// A logarithmic axis; where it has few decades, 2 and 5 are labelled in each.
static void write_log_axis(FILE *script, span range) {
    const int first = (int)floor(log10(range.low)), last = (int)ceil(log10(range.high));
    fputs("set logscale x\n", script);
    if (last - first > 3) return;
    for (int k = first; k <= last; k++)
        fprintf(script, "set xtics add (%.10g, %.10g, %.10g)\n", pow(10, k), 2 * pow(10, k), 5 * pow(10, k));
}

static void band_limits(const diagram *of, size_t first, size_t last, double *low, double *high) {
    double a[2], b[2];
    point_edges(of, first, &a[0], &a[1]);
    point_edges(of, last, &b[0], &b[1]);
    *low = of->value * fmin(a[0], b[0]);
    *high = of->value * fmax(a[1], b[1]);
}

/// Shades the ranges of the parameter in which there is contact, behind the panels that follow.
static void write_rub_bands(FILE *script, const diagram *of) {
    const whirl_table *table = of->table;
    const size_t contacts = of->result->contact_count;
    for (size_t i = 0; of->rub && i < table->count; i++) {
        if (!(rub_share(table, i, contacts) > 0.0)) continue;
        size_t last = i;
        while (last + 1 < table->count && table->branch[last + 1] == table->branch[i] &&
               whirl_table_slot(table, last + 1) == whirl_table_slot(table, last) + 1 &&
               rub_share(table, last + 1, contacts) > 0.0)
            last++;
        double low, high;
        band_limits(of, i, last, &low, &high);
        fprintf(script,
                "set object rectangle from %.8g, graph 0 to %.8g, graph 1 behind fillcolor rgb '#F7EBDD' "
                "fillstyle solid noborder\n",
                low, high);
        i = last;
    }
}

/// The regime of every point as a strip, the branch from the first value on above that from the last.
static void write_regime_panel(FILE *script, const diagram *of) {
    const size_t most = of->table->count;
    regime_interval *intervals = malloc((most + 1) * sizeof *intervals);
    const size_t count = intervals ? regime_intervals(of->table, of->result->contact_count, intervals, most) : 0;
    for (size_t i = 0; i < count; i++) {
        double low, high;
        band_limits(of, intervals[i].first, intervals[i].last, &low, &high);
        const double bottom = of->both && intervals[i].branch >= 0 ? 0.5 : 0.0;
        fprintf(script,
                "set object %zu rectangle from %.8g, graph %.3f to %.8g, graph %.3f front fillcolor rgb '%s' "
                "fillstyle solid noborder\n",
                1000 + i, low, bottom, high, bottom + (of->both ? 0.5 : 1.0), regime_class_colour(intervals[i].kind));
    }
    if (of->both)
        fprintf(script,
                "set object %zu rectangle from graph 0, graph 0.49 to graph 1, graph 0.51 front fillcolor rgb "
                "'white' fillstyle solid noborder\n",
                1000 + count);
    fputs("set label 2 'regime' at screen 0.008, graph 0.5 left\n"
          "unset ytics\nunset key\nset yrange [0:1]\nplot NaN notitle\n"
          "set ytics nomirror\n",
          script);
    fprintf(script, "do for [i = 1000:%zu] { unset object i }\n", 1000 + count);
    free(intervals);
}

/// Bars that are pale and long where a verdict is trusted, short and coloured where it is in doubt; the branch from the
/// last value on as lines.
static void write_confidence_panel(FILE *script, const diagram *of) {
    fprintf(
        script,
        "set label 2 'confidence' at screen 0.008, graph 0.5 left\n"
        "set yrange [0:3.4]\nunset ytics\nset y2range [0:3.4]\nset y2tics ('low' 1, '' 2, 'high' 3) font small_font "
        "offset -0.6, 0\n"
        "set style fill solid 1 noborder\nunset key\nlow = %zu\nhigh = %zu\n"
        "plot 'sweep.dat' index 0 using (value*$1):($3+1):(value*(1.02*column(low)-0.02*column(high))):"
        "(value*(1.02*column(high)-0.02*column(low))):(0):($3+1):(trust_colour($3)) with boxxyerror linecolor rgb "
        "variable "
        "notitle",
        7 + of->result->station_count, 8 + of->result->station_count);
    if (of->both)
        fprintf(script,
                ", \\\n  'sweep.dat' index 1 using (value*column(low)):($3+1):(value*(column(high)-column(low))):(0) "
                "with vectors nohead linewidth 1.2 linecolor rgb '#303030' notitle");
    fputs("\nunset y2tics\nset ytics nomirror font small_font\n", script);
}

static int key_entries(const diagram *of) {
    int count = of->rub + (of->both ? 2 : 0);
    for (int kind = 0; kind < CLASS_COUNT; kind++) count += of->present[kind];
    return count;
}

static int key_columns(const diagram *of) {
    return of->both ? 2 : 3;
}

static int key_rows(const diagram *of) {
    return (key_entries(of) + key_columns(of) - 1) / key_columns(of);
}

static void write_key(FILE *script, const diagram *of) {
    fprintf(
        script,
        "set key at screen 0.53, screen 0.995*top center top horizontal maxrows %d Left reverse samplen 0.2 width %s "
        "font small_font\n",
        key_rows(of), of->both ? "-4" : "-2");
    fputs("plot ", script);
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        if (of->present[kind])
            fprintf(script, "keyentry with points pointtype 7 pointsize 0.4 linecolor rgb '%s' title '%s', \\\n  ",
                    regime_class_colour((regime_class)kind), regime_class_name((regime_class)kind));
    if (of->rub)
        fputs("keyentry with boxes fillstyle solid 1 noborder linecolor rgb '#EBCFAE' title 'rub', \\\n  ", script);
    if (of->both)
        fputs(
            "keyentry with points pointtype 7 pointsize 0.25 linecolor rgb '#303030' title 'first value to last', \\\n"
            "  keyentry with points pointtype 2 pointsize 0.4 linewidth 0.5 linecolor rgb '#303030' "
            "title 'last value to first', \\\n  ",
            script);
}

static void write_range(FILE *script, span range, int tics) {
    fprintf(script, "set yrange [%.8g:%.8g]\nset ytics %.6g\n", range.low, range.high,
            tic_step(range.high - range.low, tics));
}

/// The label of a vertical axis, a gnuplot expression; all stand in one line, whatever the width of the tics.
static void write_axis_label(FILE *script, const char *expression) {
    fprintf(script, "set label 2 %s at screen 0.042, graph 0.5 center rotate\n", expression);
}

/// Regimes that have few dots, or dots in doubt, which shall be seen.
static bool has_large_dots(int kind) {
    return kind == CLASS_UNDETERMINED || kind == CLASS_P1 || kind == CLASS_P2 || kind == CLASS_P4 ||
           kind == CLASS_OTHER_PERIOD;
}

/// The dots of coordinate `column` of the section.
static void write_section_panel(FILE *script, const diagram *of, char coordinate, int column) {
    const span range = column == 2 ? of->x : of->y;
    write_range(script, range, 7);
    write_axis_label(script, coordinate == 'x' ? "x_label" : "y_label");
    const bool key = column == 2;
    if (key)
        write_key(script, of);
    else
        fputs("unset key\nplot ", script);
    int index = 0;
    for (int kind = 0; kind < CLASS_COUNT; kind++) {
        if (!of->present[kind]) continue;
        for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2)
            fprintf(script,
                    "%s'%s' index %d using (value*$1):(length*$%d) with points pointtype %d pointsize %s linewidth 0.3 "
                    "linecolor rgb '%s' "
                    "notitle",
                    index ? ", \\\n  " : "", of->data, index, column, branch > 0 ? 7 : 2,
                    branch < 0             ? "2.5*dot_size"
                    : has_large_dots(kind) ? "2*dot_size"
                                           : "dot_size",
                    regime_class_colour((regime_class)kind)),
                index++;
    }
    fputc('\n', script);
}

static void write_exponent_panel(FILE *script, const diagram *of) {
    write_range(script, of->exponent, 6);
    write_axis_label(script, "\"largest exponent\\n(1/revolution)\"");
    fputs("plot 0 linestyle 9 notitle, \\\n"
          "  'sweep.dat' using (value*$1):($4-$5):(0):(2*$5) with vectors nohead linewidth 0.5 linecolor rgb '#9A9A9A' "
          "notitle",
          script);
    for (int branch = 0; branch < (of->both ? 2 : 1); branch++)
        fprintf(script,
                ", \\\n  'sweep.dat' index %d using (value*$1):4:(colour($2)) with points pointtype %d pointsize %s "
                "linewidth "
                "0.3 linecolor rgb variable notitle",
                branch, branch ? 2 : 7, branch ? "3*dot_size" : "2*dot_size");
    fputc('\n', script);
}

static void write_line_panel(FILE *script, const diagram *of, size_t column, const char *scale, const char *style) {
    for (int branch = 0; branch < (of->both ? 2 : 1); branch++)
        fprintf(script, "%s'sweep.dat' index %d using (value*$1):(%s*$%zu) %s notitle", branch ? ", \\\n  " : "",
                branch, scale, column, branch ? "with lines linestyle 2" : style);
    fputc('\n', script);
}

/// How near the curve of the largest radius comes to the gap within a tenth of the axis around a place (0: left, 1:
/// right).
static double room_for_label(const diagram *of, double place) {
    const double width = of->parameter.high - of->parameter.low;
    double nearest = (double)INFINITY;
    for (size_t i = 0; i < of->table->count; i++) {
        const double value = of->value * of->table->values[i];
        const double at = of->ratios ? log(value / of->parameter.low) / log(of->parameter.high / of->parameter.low)
                                     : (value - of->parameter.low) / width;
        if (fabs(at - place) > 0.1) continue;
        nearest =
            fmin(nearest, fabs(of->length * max_radius(of->table, i, of->station) - of->gap)); // fmin leaves NaN out
    }
    return nearest;
}

/// Begins the plot of the panel with the gap, its name where the curve is far away.
static void write_gap(FILE *script, const diagram *of, double height) {
    static const struct {
        double at;
        const char *side;
    } places[] = {{0.992, "right"}, {0.008, "left"}, {0.5, "center"}};
    int best = 0;
    for (int i = 1; i < 3; i++)
        if (room_for_label(of, places[i].at) > room_for_label(of, places[best].at)) best = i;
    fprintf(script,
            "set label 3 'gap' at graph %.3f, first %.10g %s offset 0, 0.4 font small_font textcolor rgb '#606060'\n",
            places[best].at, height, places[best].side);
    fprintf(script, "plot %.10g with lines linecolor rgb '#606060' linewidth 0.7 dashtype 2 notitle, \\\n  ", height);
}

static void write_radius_panel(FILE *script, const diagram *of) {
    const double clearance = of->length * of->result->stations[of->station].clearance;
    const double scale = clearance > 0.0 ? 1.0 / clearance : 1.0;
    write_range(script, (span){scale * of->radius.low, scale * of->radius.high}, 4);
    write_axis_label(script, clearance > 0.0 ? "\"largest\\neccentricity\"" : "\"largest\\n\".radius_label");
    char factor[48];
    snprintf(factor, sizeof factor, "%.10g*length", scale);
    if (of->gap > 0.0)
        write_gap(script, of, scale * of->gap);
    else
        fputs("plot ", script);
    write_line_panel(script, of, 7 + of->station, factor, "with lines linestyle 1");
    fputs("unset label 3\n", script);
}

static void write_rub_panel(FILE *script, const diagram *of) {
    write_axis_label(script, "\"time in\\ncontact (%)\"");
    write_range(script, (span){0.0, 100.0 * of->share}, 5);
    fputs("plot ", script);
    write_line_panel(script, of, 6, "100", "with lines linestyle 1");
}

static void write_colour_function(FILE *script) {
    fputs("colours = '", script);
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(script, "%s0x%s", kind ? " " : "", regime_class_colour((regime_class)kind) + 1);
    fputs("'\ncolour(class) = int(word(colours, int(class) + 1))\n"
          "trust_colour(level) = int(word('0xD55E00 0xA8A8A8 0xDCDCDC', int(level) + 1))\n",
          script);
}

typedef void (*panel_writer)(FILE *script, const diagram *of);

static void write_x_panel(FILE *script, const diagram *of) {
    write_section_panel(script, of, 'x', 2);
}

static void write_y_panel(FILE *script, const diagram *of) {
    write_section_panel(script, of, 'y', 3);
}

/// The panels from the top, with their heights in parts.
static void write_panels(FILE *script, const diagram *of) {
    const struct {
        panel_writer write;
        double part;
        bool there;
    } all[] = {
        {write_x_panel, 3.0, true},
        {write_y_panel, 3.0, true},
        {write_regime_panel, of->both ? 0.44 : 0.3, true},
        {write_confidence_panel, 0.62, of->confidence},
        {write_exponent_panel, 1.9, true},
        {write_radius_panel, 1.3, true},
        {write_rub_panel, 1.1, of->rub},
    };
    enum { PANELS = sizeof all / sizeof *all };
    const double bottom = 0.058, top = 1.0 - 0.0155 * key_rows(of) - 0.008, gap = 0.011;
    double sum = 0.0;
    int count = 0, last = 0;
    for (int i = 0; i < PANELS; i++) {
        if (!all[i].there) continue;
        sum += all[i].part;
        last = i;
        count++;
    }
    const double unit = (top - bottom - gap * (count - 1)) / sum;
    double high = top;
    for (int i = 0; i < PANELS; i++) {
        if (!all[i].there) continue;
        const double low = high - all[i].part * unit;
        script_panel(script, 0.172, 0.93, low, high);
        if (i == last) fputs("set format x '%g'\nset xlabel parameter_label offset 0, 0.5\n", script);
        all[i].write(script, of);
        fputs("unset label\n", script);
        high = low - gap;
    }
}

/// What stands at the axes, and what the numbers of the data files are multiplied by.
static void write_labels(FILE *script, const diagram *of) {
    const shown_units units = typeset_units(of->units);
    char label[TYPESET_SIZE];
    typeset_parameter(of->units, of->table->parameter, label, sizeof label);
    script_label(script, "parameter_label", label);
    units_length_label(&units, "{/:Italic x}", label, sizeof label);
    script_label(script, "x_label", label);
    units_length_label(&units, "{/:Italic y}", label, sizeof label);
    script_label(script, "y_label", label);
    units_length_label(&units, "radius", label, sizeof label);
    script_label(script, "radius_label", label);
    fprintf(script, "# Of one unit of the data files:\nlength = %.15g\nvalue = %.15g\n", of->length, of->value);
}

static whirl_status write_script(const drawing *to, const diagram *of, const figure *what) {
    char name[STEM_SIZE + 4];
    report_file file;
    snprintf(name, sizeof name, "%s.gp", what->stem);
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    script_begin(script, what, 8.5, (of->rub ? 16.0 : 14.5) + (of->confidence ? 0.8 : 0.0), 6.5);
    write_labels(script, of);
    fprintf(script, "dot_size = %g\n", of->table->count > MANY_POINTS ? 0.06 : 0.1);
    write_colour_function(script);
    fprintf(script, "set xrange [%.10g:%.10g]\n", of->parameter.low, of->parameter.high);
    if (of->ratios) write_log_axis(script, of->parameter);
    script_loop(script);
    fputs("set format x ''\nunset xlabel\n", script);
    write_rub_bands(script, of);
    write_panels(script, of);
    fputs("unset object\n", script);
    script_end(script);
    return report_file_close(&file);
}

static whirl_status draw_station(const drawing *to, diagram *of) {
    const char *station = to->result->stations[of->station].name;
    char stem[STEM_SIZE];
    snprintf(stem, sizeof stem, "bifurcation-%s", station);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = of->station;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    snprintf(what->data[1], sizeof what->data[1], "sweep.dat");
    snprintf(what->title, sizeof what->title, "Bifurcation diagram of %s over %s", station, of->table->parameter);
    snprintf(
        what->caption, sizeof what->caption,
        "Poincar\u00e9 section of %s (one dot a revolution) over %s, coloured by regime.%s Below: the regime%s%s, the "
        "largest Lyapunov exponent with its standard error, %s%s%s%s.",
        station, of->table->parameter, of->rub ? " Shaded: the rotor rubs." : "",
        of->both ? " (upper strip: followed from the first value on; lower strip: from the last)" : "",
        !of->confidence ? ""
        : of->both      ? ", how far it can be trusted (bars: from the first value on; lines: from the last)"
                        : ", how far it can be trusted",
        to->result->stations[of->station].clearance > 0.0 ? "largest eccentricity ratio" : "largest radius",
        of->gap > 0.0 ? " (dashed: the gap to the stator)" : "", of->rub ? ", share of the time in contact" : "",
        of->both ? " (blue: from the first value on; orange: from the last)" : "");
    of->data = what->data[0];
    const whirl_status status = write_section_data(to, of, what->data[0]);
    return status.code == WHIRL_OK ? write_script(to, of, what) : status;
}

whirl_status draw_bifurcations(const drawing *to) {
    const whirl_table *table = whirl_result_table(to->result, "sweep");
    if (!table || table->count == 0 || !whirl_layout_field(&table->layout, "poincare/section")) return whirl_ok();
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < to->result->station_count && status.code == WHIRL_OK; s++) {
        diagram of = {.result = to->result,
                      .table = table,
                      .station = s,
                      .units = to->units,
                      .length = to->units->length,
                      .value = 1.0 / units_parameter(to->units, table->parameter).size};
        survey(&of);
        if (s == 0) status = write_sweep_data(to, &of);
        if (status.code == WHIRL_OK) status = draw_station(to, &of);
    }
    return status;
}
