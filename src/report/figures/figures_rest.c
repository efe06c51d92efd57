// Figures of machines at rest: frequencies and damping over a parameter (Campbell's diagram), shapes of modes, and the
// response to unbalance (Bode's and the polar diagram, the centreline of the shaft).
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figures.h"
#include "typeset.h"

static const double two_pi = 6.283185307179586476925;

/// What frequencies are shown in: the parameter's unit where that is the speed of the shaft, else Hz.
typedef struct frequency_unit {
    double size; ///< rad/s
    char name[WHIRL_NAME_SIZE];
    bool of_speed;
} frequency_unit;

static frequency_unit unit_of(const drawing *to, const whirl_table *table, const char *speeds) {
    const whirl_unit unit = whirl_shown_parameter(to->units, table->parameter);
    frequency_unit found = {.size = two_pi, .name = "Hz", .of_speed = true};
    for (size_t point = 0; point < table->count; point++) {
        const double *speed = whirl_table_field(table, point, speeds, 0);
        if (speed && whirl_table_done(table, point) && fabs(*speed - table->values[point]) > 1e-9 * fabs(*speed))
            found.of_speed = false;
    }
    if (!found.of_speed) return found;
    found.size = unit.size;
    snprintf(found.name, sizeof found.name, "%s", *unit.name ? unit.name : "rad/s");
    return found;
}

static double shown_value(const drawing *to, const whirl_table *table, size_t point) {
    return table->values[point] / whirl_shown_parameter(to->units, table->parameter).size;
}

static void write_parameter_label(FILE *script, const drawing *to, const whirl_table *table) {
    char label[TYPESET_SIZE];
    typeset_parameter(to->units, table->parameter, label, sizeof label);
    script_label(script, "parameter_label", label);
}

// ---------------------------------------------------------------- Campbell's diagram

static whirl_status write_modes(const drawing *to, const whirl_table *table, const char *name, double unit) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    fputs("# value, frequency, damping ratio, logarithmic decrement, direction of whirl, speed\n", file.stream);
    for (size_t mode = 0; table->count > 0 && mode < field->rows; mode++) {
        for (size_t point = 0; point < table->count; point++) {
            const double *block = whirl_table_done(table, point) ? whirl_table_block(table, point) : NULL;
            if (!block) continue;
            fprintf(file.stream, "%.10g %.10g %.10g %.10g %.6g %.10g\n", shown_value(to, table, point),
                    whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode] / unit,
                    whirl_table_field(table, point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0)[mode],
                    whirl_table_field(table, point, WHIRL_FIELD_MODES_DECREMENT, 0)[mode],
                    whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0)[mode],
                    whirl_table_field(table, point, WHIRL_FIELD_MODES_SPEED, 0)[0] / unit);
        }
        fputc('\n', file.stream);
    }
    return report_file_close(&file);
}

/// Of all points, in their order; how many, at most as many as there is room for.
static size_t gather_critical(const whirl_table *table, size_t room, const double **rows) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t count = 0;
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (isfinite(row[0]) && count < room) rows[count++] = row;
    }
    return count;
}

/// Where the value stands beside the mark: 1 right below, -1 left above, where the next one or the edge is near.
static int label_side(const whirl_table *table, const double *const *rows, size_t count, size_t i) {
    const double first = table->values[0], last = table->values[table->count - 1];
    const double near = 0.1 * fabs(last - first);
    const bool crowded = i + 1 < count && fabs(rows[i + 1][1] - rows[i][1]) < near;
    return crowded || fmax(first, last) - rows[i][1] < near ? -1 : 1;
}

static whirl_status write_critical(const drawing *to, const whirl_table *table, const char *name, double unit) {
    enum { MOST = 256 };
    const double *rows[MOST];
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    const size_t count = gather_critical(table, MOST, rows);
    const double size = whirl_shown_parameter(to->units, table->parameter).size;
    const double first = shown_value(to, table, 0);
    // gnuplot falls over labels of which none is a number: kind 0 stands below the axis and is never seen.
    fprintf(file.stream,
            "# kind (1: critical speed, 2: instability begins, 3: it ends; 0: none), value, frequency, damping ratio, "
            "side of the label\n0 %.10g -1 NaN 1\n0 %.10g -1 NaN -1\n",
            first, first);
    for (size_t i = 0; i < count; i++)
        fprintf(file.stream, "%g %.10g %.10g %.10g %d\n", rows[i][0], rows[i][1] / size, rows[i][3] / unit, rows[i][4],
                label_side(table, rows, count, i));
    return report_file_close(&file);
}

/// Up to where frequencies are shown: where the parameter is a speed, what it meets and what lies below twice its
/// largest value.
static double frequency_top(const whirl_table *table, const frequency_unit *unit) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    double fastest = 0.0, highest = 0.0, lowest = (double)INFINITY, near = 0.0;
    for (size_t point = 0; unit->of_speed && point < table->count; point++)
        if (whirl_table_done(table, point))
            fastest = fmax(fastest, fabs(whirl_table_field(table, point, WHIRL_FIELD_MODES_SPEED, 0)[0]));
    for (size_t point = 0; point < table->count; point++) {
        const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
        for (size_t i = 0; frequency && whirl_table_done(table, point) && i < field->rows; i++) {
            highest = fmax(highest, frequency[i]);
            lowest = fmin(lowest, frequency[i]);
            if (frequency[i] <= 2.0 * fastest) near = fmax(near, frequency[i]);
        }
    }
    const bool cut = fastest > 0.0 && 2.0 * fastest < highest;
    const double top = cut ? fmax(fmin(2.0 * fastest, 1.1 * fmax(fastest, near)), 1.2 * lowest) : 1.05 * highest;
    return top > 0.0 ? top / unit->size : 1.0;
}

/// What is shown of damping: of modes whose frequencies are. More than 0.25 leaves no peak of a response to unbalance
/// (amplification below 2.5, API 617): more is shown where no mode has less.
static span damping_span(const whirl_table *table, double top) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    span shown = {0.0, 0.0};
    double least = (double)INFINITY;
    for (int pass = 0; pass < 2; pass++)
        for (size_t point = 0; point < table->count; point++) {
            const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
            const double *ratio = whirl_table_field(table, point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
            for (size_t i = 0; frequency && whirl_table_done(table, point) && i < field->rows; i++) {
                if (!(frequency[i] <= top)) continue;
                if (pass == 0) least = fmin(least, ratio[i]);
                if (pass == 1 && ratio[i] <= fmax(0.25, 1.5 * least)) span_widen(&shown, ratio[i]);
            }
        }
    // What rounding leaves of no damping is no picture.
    return span_with_margin(shown, 0.08, shown.high - shown.low > 1e-10 ? 0.0 : 0.02);
}

static whirl_status write_campbell(const drawing *to, const whirl_table *table, const figure *what,
                                   const frequency_unit *unit) {
    report_file file;
    const whirl_status status = script_begin(&file, to, what, 12.0, 11.0, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    char label[TYPESET_SIZE];
    write_parameter_label(script, to, table);
    snprintf(label, sizeof label, "damped frequency (%.40s)", unit->name);
    script_label(script, "frequency_label", label);
    fputs("modes = ", script);
    fprintf(script, "'%s'\ncritical = '%s'\n", what->data[0], what->data[1]);
    const double top = frequency_top(table, unit);
    const span damping = damping_span(table, top * unit->size);
    fprintf(script, "most = %.6g\nfew = %zu\n", top, table->count / 25 + 1);
    fputs("colour(d) = d > 0.05 ? 0x0072B2 : d < -0.05 ? 0xD55E00 : 0x606060\n"
          "mark(d) = d > 0.05 ? 9 : d < -0.05 ? 11 : 5\n",
          script);
    script_loop(script);
    fputs("set format x ''\nunset xlabel\nset ylabel frequency_label\n"
          "set key at graph 0,1.03 left bottom horizontal reverse Left samplen 0.7 width -3 maxrows 1 font small_font\n"
          "set yrange [0:most]\n",
          script);
    script_panel(script, 0.13, 0.95, 0.44, 0.92);
    fputs(
        "plot modes using 1:6 with lines linestyle 9 title '1X', \\\n"
        "  modes using 1:2:(colour($5)) with points pointtype 7 pointsize 0.1 linecolor rgb variable notitle, \\\n"
        "  modes every few using 1:2:(mark($5)):(colour($5)) with points pointtype variable pointsize 0.5 "
        "linecolor rgb variable notitle, \\\n"
        "  NaN with points pointtype 9 pointsize 0.6 linecolor rgb '#0072B2' title 'forward', \\\n"
        "  NaN with points pointtype 11 pointsize 0.6 linecolor rgb '#D55E00' title 'backward', \\\n"
        "  critical using ($1 == 1 ? $2 : NaN):3 with points pointtype 6 pointsize 0.8 linewidth 1 "
        "linecolor rgb '#000000' title 'critical speed', \\\n"
        "  critical using ($1 > 1 ? $2 : NaN):3 with points pointtype 2 pointsize 0.8 linewidth 1.2 "
        "linecolor rgb '#CC0000' title 'threshold', \\\n"
        "  critical using 2:($5 > 0 ? $3 : NaN):(sprintf('%.5g', $2)) with labels left offset 0.6,-0.7 font small_font "
        "notitle, \\\n"
        "  critical using 2:($5 < 0 ? $3 : NaN):(sprintf('%.5g', $2)) with labels right offset -0.6,0.7 "
        "font small_font notitle\n"
        "unset key\nset format x '% h'\nset xlabel parameter_label\nset ylabel 'damping ratio'\n",
        script);
    fprintf(script, "set yrange [%.6g:%.6g]\n", damping.low, damping.high);
    script_panel(script, 0.13, 0.95, 0.09, 0.40);
    fputs("plot 0 with lines linestyle 9, \\\n"
          "  modes using 1:($2 <= most ? $3 : NaN):(colour($5)) with points pointtype 7 pointsize 0.1 "
          "linecolor rgb variable, \\\n"
          "  modes every few using 1:($2 <= most ? $3 : NaN):(mark($5)):(colour($5)) with points pointtype variable "
          "pointsize 0.5 linecolor rgb variable, \\\n"
          "  critical using ($1 > 1 ? $2 : NaN):4 with points pointtype 2 pointsize 0.8 linewidth 1.2 "
          "linecolor rgb '#CC0000'\n",
          script);
    script_end(script);
    return report_file_close(&file);
}

static whirl_status draw_campbell(const drawing *to, const whirl_table *table) {
    const frequency_unit unit = unit_of(to, table, WHIRL_FIELD_MODES_SPEED);
    figure *what = figure_add(to->list, to->index, "campbell");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->data[0], sizeof what->data[0], "modes.dat");
    snprintf(what->data[1], sizeof what->data[1], "critical.dat");
    snprintf(what->title, sizeof what->title, "Campbell diagram over %s", table->parameter);
    snprintf(
        what->caption, sizeof what->caption,
        "Campbell diagram: damped natural frequencies over %s; blue, pointing up: the whirl goes with the rotation, "
        "orange, pointing down: against it, grey squares: to and fro; dashed: the speed of the shaft; circles: "
        "critical speeds; crosses: thresholds of stability. Below: damping ratios of the same modes, up to 0.25, "
        "negative where a mode grows.",
        table->parameter);
    whirl_status status = write_modes(to, table, what->data[0], unit.size);
    if (status.code == WHIRL_OK) status = write_critical(to, table, what->data[1], unit.size);
    return status.code == WHIRL_OK ? write_campbell(to, table, what, &unit) : status;
}

// ---------------------------------------------------------------- shapes

enum { SHAPES = 6 };

/// Where stations stand along a figure: those of shafts of finite elements at their places, the others beyond the last
/// of these, one by one; without shafts all one by one.
typedef struct along {
    bool shafts;
    size_t aside; ///< stations on no shaft, where there are shafts
    span range;   ///< mm, or numbers of stations
    double end;   ///< mm; beyond it stations lie on no shaft
    double at[WHIRL_MAX_PROBES];
} along;

static void place_stations(const whirl_result *result, along *out) {
    span places = span_empty();
    *out = (along){.range = {0.5, (double)result->station_count + 0.5}};
    for (size_t s = 0; s < result->station_count; s++) {
        out->at[s] = (double)s + 1.0;
        if (result->stations[s].shaft > 0) span_widen(&places, 1e3 * result->stations[s].position);
    }
    if (!(places.low <= places.high)) return;
    const double step = places.high > places.low ? 0.16 * (places.high - places.low) : 1.0;
    out->shafts = true;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        out->at[s] = station->shaft > 0 ? 1e3 * station->position : places.high + step * (double)++out->aside;
    }
    out->end = places.high + 0.5 * step;
    out->range = (span){places.low - 0.3 * step, places.high + step * ((double)out->aside + 0.3)};
}

/// The station that follows one on its shaft, along it; station_count where there is none, or none is asked for.
static size_t next_on_shaft(const whirl_result *result, size_t shaft, double after) {
    size_t next = result->station_count;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        if (station->shaft != shaft || !(station->position > after)) continue;
        if (next == result->station_count || station->position < result->stations[next].position) next = s;
    }
    return next;
}

static void write_station(FILE *stream, const along *places, const double *row, size_t station) {
    if (isfinite(row[0]))
        fprintf(stream, "%.8g %.6g %.6g %.6g %.6g\n", places->at[station], row[0], row[1], row[2], row[3]);
}

/// The stations of every shaft, along it, and a line alone for each of the others.
static void write_shape(FILE *stream, const whirl_result *result, const whirl_table *table, size_t point, size_t mode,
                        const along *places) {
    for (size_t shaft = 1; shaft <= WHIRL_MAX_SHAFTS; shaft++) {
        size_t s = next_on_shaft(result, shaft, -(double)INFINITY);
        if (s == result->station_count) continue;
        for (; s < result->station_count; s = next_on_shaft(result, shaft, result->stations[s].position))
            write_station(stream, places, whirl_table_field(table, point, WHIRL_FIELD_MODES_SHAPE, s) + 4 * mode, s);
        fputc('\n', stream);
    }
    for (size_t s = 0; s < result->station_count; s++) {
        if (result->stations[s].shaft > 0) continue;
        write_station(stream, places, whirl_table_field(table, point, WHIRL_FIELD_MODES_SHAPE, s) + 4 * mode, s);
        if (places->shafts) fputc('\n', stream);
    }
}

/// Of the lowest modes of a point: a block a mode, a line a station.
static whirl_status write_shapes(const drawing *to, const whirl_table *table, size_t point, const char *name,
                                 const along *places) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_SHAPE);
    fputs("# place of the station, then x cos, x sin, y cos, y sin of the motion of unit size: x = x_cos cos + x_sin "
          "sin\n",
          file.stream);
    for (size_t mode = 0; mode < field->rows && mode < SHAPES; mode++) {
        write_shape(file.stream, to->result, table, point, mode, places);
        fputs("\n\n", file.stream);
    }
    return report_file_close(&file);
}

static void write_shape_panels(FILE *script, const whirl_table *table, size_t point, size_t count,
                               const frequency_unit *unit) {
    const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    const double *direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0);
    for (size_t mode = 0; mode < count; mode++) {
        const double left = mode % 2 ? 0.58 : 0.09, bottom = 0.72 - 0.315 * (double)(mode / 2);
        script_panel(script, left, left + 0.39, bottom, bottom + 0.22);
        fputs(mode + 2 < count ? "unset xlabel\n" : "set xlabel place_label\n", script);
        fprintf(script,
                "set title '%zu: %.5g %s%s' offset 0,-0.7\n"
                "plot shapes index %zu using 1:2 with linespoints linestyle 1 pointtype 7 pointsize 0.3, \\\n"
                "  shapes index %zu using 1:3 with linespoints linestyle 1 dashtype 2 pointtype 6 pointsize 0.3, \\\n"
                "  shapes index %zu using 1:4 with linespoints linestyle 2 pointtype 7 pointsize 0.3, \\\n"
                "  shapes index %zu using 1:5 with linespoints linestyle 2 dashtype 2 pointtype 6 pointsize 0.3\n",
                mode + 1, frequency[mode] / unit->size, unit->name,
                direction[mode] > 0.05    ? ", forward"
                : direction[mode] < -0.05 ? ", backward"
                                          : "",
                mode, mode, mode, mode);
    }
}

/// The horizontal axis: places along the shaft, or the names of stations where there is none.
static void write_places(FILE *script, const whirl_result *result, const along *places) {
    const size_t stations = result->station_count;
    char name[TYPESET_SIZE];
    fprintf(script, "set xrange [%.8g:%.8g]\nset yrange [-1.1:1.1]\nset ytics 1\n", places->range.low,
            places->range.high);
    if (places->shafts) {
        const double high = places->aside > 0 ? places->end : places->range.high;
        const double step = tic_step(high - places->range.low, 4);
        fprintf(script, "set xtics %.8g,%.6g,%.8g\nplace_label = '{/:Italic z} (mm)'\n",
                step * ceil(places->range.low / step), step, high);
    } else
        fputs("place_label = ''\nset xtics (", script);
    for (size_t s = 0; s < stations; s++) {
        typeset_text(result->stations[s].name, name, sizeof name);
        if (!places->shafts && (stations <= 8 || s == 0 || s + 1 == stations))
            fprintf(script, "%s'%s' %zu", s ? ", " : "", name, s + 1);
        if (places->shafts && result->stations[s].shaft == 0)
            fprintf(script, "set label '%s' at %.8g,-1 rotate left offset -0.6,0 font small_font textcolor '#606060'\n",
                    name, places->at[s]);
    }
    if (!places->shafts) fputs(")\n", script);
    if (places->aside > 0)
        fprintf(script, "set arrow from %.8g,-1.1 to %.8g,1.1 nohead dashtype 3 linecolor rgb '#909090'\n", places->end,
                places->end);
}

static whirl_status draw_shapes(const drawing *to, const whirl_table *table) {
    const size_t point = table->count - 1, stations = to->result->station_count;
    const frequency_unit unit = unit_of(to, table, WHIRL_FIELD_MODES_SPEED);
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    size_t count = 0;
    along places;
    if (!whirl_table_done(table, point) || !frequency || stations < 2) return whirl_ok();
    place_stations(to->result, &places);
    while (count < field->rows && count < SHAPES && isfinite(frequency[count])) count++;
    figure *what = figure_add(to->list, to->index, "shapes");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->data[0], sizeof what->data[0], "shapes.dat");
    snprintf(what->title, sizeof what->title, "Shapes of the lowest modes");
    char label[UNIT_LABEL_SIZE];
    units_point_label(to->units, table, point, label, sizeof label);
    snprintf(what->caption, sizeof what->caption,
             "Shapes of the %zu lowest modes at %s, over %s: blue x, orange y; full lines at the instant at which the "
             "largest displacement peaks, dashed lines a quarter of a period later.",
             count, label,
             !places.shafts     ? "the stations"
             : places.aside > 0 ? "the place of the stations along the shaft, and those on no shaft"
                                : "the place of the stations along the shaft");
    whirl_status status = write_shapes(to, table, point, what->data[0], &places);
    report_file file;
    if (status.code == WHIRL_OK) status = script_begin(&file, to, what, 12.0, 10.0, 6.5);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream, "shapes = '%s'\n", what->data[0]);
    write_places(file.stream, to->result, &places);
    script_loop(file.stream);
    write_shape_panels(file.stream, table, point, count, &unit);
    script_end(file.stream);
    return report_file_close(&file);
}

// ---------------------------------------------------------------- unbalance

static whirl_status write_response(const drawing *to, const whirl_table *table, size_t station, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fputs("# value; amplitude and lag (degrees) of the first and the second probe; mean x, y; major and minor axis\n",
          file.stream);
    for (size_t point = 0; point < table->count; point++) {
        const double *probe = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_PROBE, station);
        if (!whirl_table_done(table, point) || !probe) continue;
        const double *lag = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_PROBE_LAG, station);
        const double *rest = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_REST, station);
        const double *axes = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
        const double length = whirl_shown_length(to->units, table, point), amplitude = length * to->units->amplitude;
        fprintf(file.stream, "%.10g %.8g %.8g %.8g %.8g %.8g %.8g %.8g %.8g\n", shown_value(to, table, point),
                amplitude * probe[0], lag[0], amplitude * probe[1], lag[1], length * rest[0], length * rest[1],
                amplitude * axes[0], amplitude * axes[1]);
    }
    return report_file_close(&file);
}

/// Ranges of the centreline, as wide in x as in y: what moves less than a thousandth of its place stands still.
static void write_centre_ranges(FILE *script, const drawing *to, const whirl_table *table, size_t station) {
    span x = span_empty(), y = span_empty();
    double size = 0.0;
    for (size_t point = 0; point < table->count; point++) {
        const double *rest = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_REST, station);
        const double length = whirl_shown_length(to->units, table, point);
        if (!whirl_table_done(table, point) || !rest) continue;
        span_widen(&x, length * rest[0]);
        span_widen(&y, length * rest[1]);
        size = fmax(size, length * hypot(rest[0], rest[1]));
    }
    const double width = fmax(1.2 * fmax(x.high - x.low, y.high - y.low), size > 0.0 ? 1e-3 * size : 1.0);
    x = span_with_margin(x, 0.1, width);
    y = span_with_margin(y, 0.1, width);
    fprintf(script, "set xrange [%.8g:%.8g]\nset yrange [%.8g:%.8g]\nset xtics %.6g\nset ytics %.6g\n", x.low, x.high,
            y.low, y.high, tic_step(x.high - x.low, 3), tic_step(y.high - y.low, 4));
}

/// Ranges of the polar diagram, one scale for both axes, with room for its origin.
static void write_polar_ranges(FILE *script, const drawing *to, const whirl_table *table, size_t station) {
    span x = {0.0, 0.0}, y = {0.0, 0.0};
    for (size_t point = 0; point < table->count; point++) {
        const double *probe = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_PROBE, station);
        const double *lag = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_PROBE_LAG, station);
        const double size = whirl_shown_length(to->units, table, point) * to->units->amplitude;
        for (size_t i = 0; i < 2 && probe && whirl_table_done(table, point); i++) {
            span_widen(&x, size * probe[i] * cos(lag[i] * two_pi / 360.0));
            span_widen(&y, -size * probe[i] * sin(lag[i] * two_pi / 360.0));
        }
    }
    const double width = fmax(1.16 * fmax(x.high - x.low, y.high - y.low), 1e-300);
    x = span_with_margin(x, 0.08, width);
    y = span_with_margin(y, 0.08, width);
    const double step = tic_step(width, 4);
    fprintf(script, "set xrange [%.8g:%.8g]\nset yrange [%.8g:%.8g]\nset xtics %.6g\nset ytics %.6g\n", x.low, x.high,
            y.low, y.high, step, step);
}

static void write_response_panels(FILE *script, const drawing *to, const whirl_table *table, size_t station) {
    fputs("set format x ''\nunset xlabel\nset ylabel 'lag (deg)'\nset yrange [0:360]\nset ytics 90\n", script);
    script_panel(script, 0.09, 0.57, 0.66, 0.97);
    fputs(
        "plot response using 1:3 with points pointtype 7 pointsize 0.2 linecolor rgb '#0072B2', \\\n"
        "  response using 1:5 with points pointtype 7 pointsize 0.2 linecolor rgb '#D55E00'\n"
        "set format x '% h'\nset xlabel parameter_label\nset ylabel amplitude_label\nset yrange [0:*]\nset ytics auto\n"
        "set key top right samplen 1.5\n",
        script);
    script_panel(script, 0.09, 0.57, 0.12, 0.63);
    fputs("plot response using 1:2 with lines linestyle 1 title 'first probe', \\\n"
          "  response using 1:4 with lines linestyle 2 title 'second probe', \\\n"
          "  response using 1:8 with lines linestyle 9 title 'major axis'\n"
          "unset key\nset size ratio 1\nset xlabel polar_label\nunset ylabel\n",
          script);
    write_polar_ranges(script, to, table, station);
    script_panel(script, 0.68, 0.98, 0.60, 0.97);
    fputs("plot response using ($2*cosd($3)):(-$2*sind($3)) with lines linestyle 1, \\\n"
          "  response using ($4*cosd($5)):(-$4*sind($5)) with lines linestyle 2\n"
          "set xlabel x_label\nset ylabel y_label\n",
          script);
    write_centre_ranges(script, to, table, station);
    script_panel(script, 0.68, 0.98, 0.12, 0.47);
    fputs("plot response using 6:7 with linespoints linestyle 1 pointtype 7 pointsize 0.2\n"
          "set size noratio\nset xrange [*:*]\nset yrange [*:*]\nset xtics auto\nset ytics auto\n",
          script);
}

static whirl_status draw_response(const drawing *to, const whirl_table *table, size_t station) {
    const char *name = to->result->stations[station].name;
    char stem[STEM_SIZE], label[TYPESET_SIZE];
    snprintf(stem, sizeof stem, "unbalance-%s", name);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = station;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    snprintf(what->title, sizeof what->title, "Response of %s to unbalance over %s", name, table->parameter);
    snprintf(
        what->caption, sizeof what->caption,
        "Synchronous response of %s over %s. Left: by how much the peak comes after the mark, and amplitude, of two "
        "probes, the first at %.4g degrees from the x axis. Right: polar diagram (against the rotation the lag "
        "grows); centreline of the shaft.",
        name, table->parameter, table->record.probe_angle * 360.0 / two_pi);
    whirl_status status = write_response(to, table, station, what->data[0]);
    report_file file;
    if (status.code == WHIRL_OK) status = script_begin(&file, to, what, 17.5, 9.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    const whirl_shown_units units = typeset_units(to->units);
    write_parameter_label(file.stream, to, table);
    units_amplitude_label(&units, "amplitude", label, sizeof label);
    script_label(file.stream, "amplitude_label", label);
    script_label(file.stream, "polar_label", label);
    units_length_label(&units, "{/:Italic x}", label, sizeof label);
    script_label(file.stream, "x_label", label);
    units_length_label(&units, "{/:Italic y}", label, sizeof label);
    script_label(file.stream, "y_label", label);
    fprintf(file.stream, "response = '%s'\ncosd(a) = cos(a*pi/180)\nsind(a) = sin(a*pi/180)\n", what->data[0]);
    script_loop(file.stream);
    write_response_panels(file.stream, to, table, station);
    script_end(file.stream);
    return report_file_close(&file);
}

whirl_status draw_modes(const drawing *to, const whirl_table *table) {
    if (table->count < 1) return whirl_ok();
    const whirl_status status = table->count > 1 ? draw_campbell(to, table) : whirl_ok();
    return status.code == WHIRL_OK ? draw_shapes(to, table) : status;
}

whirl_status draw_unbalance(const drawing *to, const whirl_table *table) {
    whirl_status status = whirl_ok();
    for (size_t s = 0; table->count > 1 && s < to->result->station_count && status.code == WHIRL_OK; s++)
        status = draw_response(to, table, s);
    return status;
}
