// The panels of a bifurcation diagram, one above the other, as gnuplot draws them.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bifurcation.h"
#include "quantities.h"

static void band_limits(const bifurcation *of, size_t first, size_t last, double *low, double *high) {
    double a[2], b[2];
    bifurcation_edges(of, first, &a[0], &a[1]);
    bifurcation_edges(of, last, &b[0], &b[1]);
    *low = of->value * fmin(a[0], b[0]);
    *high = of->value * fmax(a[1], b[1]);
}

void bifurcation_write_rub_bands(FILE *script, const bifurcation *of) {
    const whirl_table *table = of->table;
    const size_t contacts = of->result->contact_count;
    for (size_t i = 0; of->shaded && i < table->count; i++) {
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

/// Where the strip of an interval lies in its panel: one above the other for both branches, and for attractors.
static void strip_limits(const bifurcation *of, const regime_interval *interval, double *bottom, double *top) {
    const double count = of->attractors > 0 ? (double)of->attractors : of->both ? 2.0 : 1.0;
    const bool lower = of->both && interval->branch < 0;
    const double place = of->attractors > 0 ? (double)((interval->branch - 1) % ATTRACTOR_COLOURS) : lower ? 1.0 : 0.0;
    *top = 1.0 - place / count;
    *bottom = *top - (of->attractors > 1 ? 0.85 : 1.0) / count;
}

/// The regime of every point as a strip, the branch from the first value on above that from the last.
static void write_regime_panel(FILE *script, const bifurcation *of) {
    const size_t most = of->table->count;
    regime_interval *intervals = malloc((most + 1) * sizeof *intervals);
    const size_t count = intervals ? regime_intervals(of->table, of->result->contact_count, intervals, most) : 0;
    for (size_t i = 0; i < count; i++) {
        double low, high, bottom, top;
        band_limits(of, intervals[i].first, intervals[i].last, &low, &high);
        strip_limits(of, &intervals[i], &bottom, &top);
        fprintf(script,
                "set object %zu rectangle from %.8g, graph %.3f to %.8g, graph %.3f front fillcolor rgb '%s' "
                "fillstyle solid noborder\n",
                1000 + i, low, bottom, high, top, regime_class_colour(intervals[i].kind));
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
static void write_confidence_panel(FILE *script, const bifurcation *of) {
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

static bool has_class(const bifurcation *of, regime_class wanted) {
    for (size_t i = 0; i < of->table->count; i++) {
        const whirl_verdict verdict = whirl_table_verdict(of->table, i);
        if (regime_class_of(&verdict) == wanted) return true;
    }
    return false;
}

static int count_classes(const bifurcation *of) {
    int count = 0;
    for (int kind = 0; kind < CLASS_COUNT; kind++) count += has_class(of, (regime_class)kind);
    return count;
}

static int key_entries(const bifurcation *of) {
    int count = of->shaded + (of->both ? 2 : 0);
    for (size_t kind = 0; kind < bifurcation_kinds(of); kind++) count += of->present[kind];
    return count + (of->attractors > 0 ? count_classes(of) : 0);
}

static int key_columns(const bifurcation *of) {
    return of->both ? 2 : 3;
}

static int key_rows(const bifurcation *of) {
    return (key_entries(of) + key_columns(of) - 1) / key_columns(of);
}

static void write_key(FILE *script, const bifurcation *of) {
    fprintf(
        script,
        "set key at screen 0.53, screen 0.995*top center top horizontal maxrows %d Left reverse samplen 0.2 width %s "
        "font small_font\n",
        key_rows(of), of->both ? "-4" : "-2");
    fputs("plot ", script);
    for (size_t kind = 0; kind < bifurcation_kinds(of); kind++) {
        char name[WHIRL_NAME_SIZE];
        bifurcation_kind_name(of, kind, name);
        if (of->present[kind])
            fprintf(script, "keyentry with points pointtype 7 pointsize 0.4 linecolor rgb '%s' title '%s', \\\n  ",
                    bifurcation_kind_colour(of, kind), name);
    }
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        if (of->attractors > 0 && has_class(of, (regime_class)kind))
            fprintf(script, "keyentry with boxes fillstyle solid 1 noborder linecolor rgb '%s' title '%s', \\\n  ",
                    regime_class_colour((regime_class)kind), regime_class_name((regime_class)kind));
    if (of->shaded)
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
    fprintf(script, "set label 2 %s at screen 0.029, graph 0.5 center rotate\n", expression);
}

/// Regimes that have few dots, or dots in doubt, which shall be seen.
static bool has_large_dots(const bifurcation *of, size_t kind) {
    return of->attractors > 0 || kind == CLASS_UNDETERMINED || kind == CLASS_P1 || kind == CLASS_P2 ||
           kind == CLASS_P4 || kind == CLASS_OTHER_PERIOD;
}

/// The dots of coordinate `column` of the section.
static void write_section_panel(FILE *script, const bifurcation *of, char coordinate, int column) {
    const span range = column == 2 ? of->x : of->y;
    write_range(script, range, 7);
    write_axis_label(script, coordinate == 'x' ? "x_label" : "y_label");
    const bool key = column == 2;
    if (key)
        write_key(script, of);
    else
        fputs("unset key\nplot ", script);
    int index = 0;
    for (size_t kind = 0; kind < bifurcation_kinds(of); kind++) {
        if (!of->present[kind]) continue;
        for (int branch = 1; branch >= (of->both ? -1 : 1); branch -= 2)
            fprintf(script,
                    "%s'%s' index %d using (value*$1):(length*$%d) with points pointtype %d pointsize %s linewidth 0.3 "
                    "linecolor rgb '%s' "
                    "notitle",
                    index ? ", \\\n  " : "", of->data, index, column, branch > 0 ? 7 : 2,
                    branch < 0                 ? "2.5*dot_size"
                    : has_large_dots(of, kind) ? "2*dot_size"
                                               : "dot_size",
                    bifurcation_kind_colour(of, kind)),
                index++;
    }
    fputc('\n', script);
}

static void write_exponent_panel(FILE *script, const bifurcation *of) {
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

static void write_line_panel(FILE *script, const bifurcation *of, size_t column, const char *scale, const char *style) {
    for (int branch = 0; branch < (of->both ? 2 : 1); branch++)
        fprintf(script, "%s'sweep.dat' index %d using (value*$1):(%s*$%zu) %s notitle", branch ? ", \\\n  " : "",
                branch, scale, column, branch ? "with lines linestyle 2" : style);
    fputc('\n', script);
}

/// How near the curve of the largest radius comes to the gap within a tenth of the axis around a place (0: left, 1:
/// right).
static double room_for_label(const bifurcation *of, double place) {
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
static void write_gap(FILE *script, const bifurcation *of, double height) {
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

static void write_radius_panel(FILE *script, const bifurcation *of) {
    const double clearance = of->clearance, scale = clearance > 0.0 ? 1.0 / clearance : 1.0;
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

static void write_rub_panel(FILE *script, const bifurcation *of) {
    write_axis_label(script, "\"time in\\ncontact (%)\"");
    write_range(script, (span){0.0, 100.0 * of->share}, 5);
    fputs("plot ", script);
    write_line_panel(script, of, 6, "100", "with lines linestyle 1");
}

/// The share of the starts that lead to each attractor, with its standard error; circles where it is 0, for those that
/// were found from neighbours.
static void write_share_panel(FILE *script, const bifurcation *of) {
    const size_t column = 9 + of->result->station_count;
    write_axis_label(script, "\"share of\\nstarts (%)\"");
    write_range(script, (span){-4.0, 104.0}, 5);
    fprintf(script,
            "plot 'sweep.dat' using (value*$1):($%zu-$%zu):(0):(2*$%zu):(attractor_colour($%zu)) with vectors nohead "
            "linewidth 0.5 linecolor rgb variable notitle, \\\n"
            "  'sweep.dat' using (value*$1):($%zu > 0 ? $%zu : 1/0):(attractor_colour($%zu)) with points pointtype 7 "
            "pointsize 3*dot_size linecolor rgb variable notitle, \\\n"
            "  'sweep.dat' using (value*$1):($%zu > 0 ? 1/0 : $%zu):(attractor_colour($%zu)) with points pointtype 6 "
            "pointsize 0.6 linecolor rgb variable notitle\n",
            column + 1, column + 2, column + 2, column, column + 1, column + 1, column, column + 1, column + 1, column);
}

typedef void (*panel_writer)(FILE *script, const bifurcation *of);

static void write_x_panel(FILE *script, const bifurcation *of) {
    write_section_panel(script, of, 'x', 2);
}

static void write_y_panel(FILE *script, const bifurcation *of) {
    write_section_panel(script, of, 'y', 3);
}

void bifurcation_write_panels(FILE *script, const bifurcation *of) {
    const struct {
        panel_writer write;
        double part;
        bool there;
    } all[] = {
        {write_x_panel, 3.0, true},
        {write_y_panel, 3.0, true},
        {write_regime_panel,
         of->attractors > 1 ? 0.2 * (double)of->attractors
         : of->both         ? 0.44
                            : 0.3,
         true},
        {write_share_panel, 1.1, of->attractors > 0},
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
