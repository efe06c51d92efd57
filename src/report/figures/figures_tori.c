#include "figures_tori.h"

#include <math.h>
#include <string.h>

#include "gnuplot.h"
#include "quantities.h"
#include "typeset.h"

static const char *const colours[] = {"#0072B2", "#D55E00", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
enum { COLOURS = sizeof colours / sizeof *colours };

const char tori_caption[] =
    " Green: the bands that quasi-periodic motions fill, with solid edges where they are stable, dashed where not.";

static bool is_torus(const whirl_table *table, size_t point) {
    return isfinite(point_number(table, point, WHIRL_FIELD_TORUS_ROTATION));
}

static bool is_stable(const whirl_table *table, size_t point) {
    return point_number(table, point, WHIRL_FIELD_TORUS_UNSTABLE) == 0.0;
}

const whirl_table *tori_table(const whirl_result *result) {
    const whirl_table *table = whirl_result_table(result, "tori");
    for (size_t point = 0; table && point < table->count; point++)
        if (whirl_layout_field(&table->layout, WHIRL_FIELD_TORUS_NUMBER) && is_torus(table, point)) return table;
    return NULL;
}

// ---------------------------------------------------------------- bands

/// A band of a station at one value: where one of the closed curves of its section lies, x and y.
typedef struct band {
    double value, low[2], high[2];
    bool stable;
} band;

/// The orbit at which a branch of tori begins, of no width.
static bool beginning(const drawing *to, const whirl_table *table, size_t first, size_t station, size_t line,
                      band *out) {
    const whirl_table *branches = whirl_result_table(to->result, "branch");
    const double row = point_number(table, first, WHIRL_FIELD_TORUS_POINT);
    if (!branches || !(row >= 1.0 && row <= (double)branches->count)) return false;
    const whirl_field *field = whirl_layout_field(&branches->layout, WHIRL_FIELD_TRACE_SECTION);
    if (!field || line >= field->rows) return false;
    const double *section = whirl_table_field(branches, (size_t)row - 1, field->name, station);
    *out = (band){.value = point_number(table, first, WHIRL_FIELD_TORUS_BEGINS), .stable = is_stable(table, first)};
    for (size_t c = 0; section && c < 2; c++) out->low[c] = out->high[c] = section[4 * line + c];
    return section != NULL;
}

/// Where it shrinks to an orbit, the middle of its last band.
static bool closing(const whirl_table *table, size_t last, size_t station, size_t line, band *out) {
    const double *low = whirl_table_field(table, last, WHIRL_FIELD_TORUS_SECTION_LOW, station);
    const double *high = whirl_table_field(table, last, WHIRL_FIELD_TORUS_SECTION_HIGH, station);
    if (point_number(table, last, WHIRL_FIELD_TORUS_END) != WHIRL_TORUS_SHRANK) return false;
    *out = (band){.value = point_number(table, last, WHIRL_FIELD_TORUS_LIMIT), .stable = is_stable(table, last)};
    for (size_t c = 0; c < 2; c++) out->low[c] = out->high[c] = 0.5 * (low[2 * line + c] + high[2 * line + c]);
    return true;
}

/// The bands of a branch by index: the beginning, its rows, the end; false where there is none of that index.
static bool band_at(const drawing *to, const whirl_table *table, whirl_tori own, size_t index, size_t station,
                    size_t line, band *out) {
    if (index == 0) return beginning(to, table, own.first, station, line, out);
    const size_t point = own.first + index - 1;
    if (point > own.last) return closing(table, own.last, station, line, out);
    const double *low = whirl_table_field(table, point, WHIRL_FIELD_TORUS_SECTION_LOW, station);
    const double *high = whirl_table_field(table, point, WHIRL_FIELD_TORUS_SECTION_HIGH, station);
    *out = (band){.value = table->values[point], .stable = is_stable(table, point)};
    memcpy(out->low, low + 2 * line, sizeof out->low);
    memcpy(out->high, high + 2 * line, sizeof out->high);
    return is_torus(table, point);
}

static void write_band(FILE *stream, const band *b, double length) {
    fprintf(stream, "%.10g %.9g %.9g %.9g %.9g\n", b->value, length * b->low[0], length * b->high[0],
            length * b->low[1], length * b->high[1]);
}

/// Which bands are written.
typedef enum choice { ALL = -1, UNSTABLE = 0, STABLE = 1 } choice;

/// Those of one branch and one line of its section; pieces that are stable, or not, meet where that changes.
static void write_line(FILE *stream, const drawing *to, const whirl_table *table, whirl_tori own, size_t station,
                       size_t line, choice which) {
    const double length = whirl_shown_length(to->units, table, own.first) / to->units->length;
    const size_t count = own.last - own.first + 3;
    band now, before = {.value = NAN};
    bool open = false;
    for (size_t index = 0; index < count; index++) {
        if (!band_at(to, table, own, index, station, line, &now)) continue;
        const bool meant = which == ALL || (which == STABLE) == now.stable;
        if (meant && !open && isfinite(before.value)) write_band(stream, &before, length);
        if (meant) write_band(stream, &now, length);
        if (!meant && open) fputc('\n', stream);
        open = meant;
        before = now;
    }
    fputc('\n', stream);
}

static void write_choice(FILE *stream, const drawing *to, const whirl_table *table, size_t station, choice which) {
    fputs("NaN NaN NaN NaN NaN\n\n", stream); // keeps the count of the blocks where one is empty
    for (size_t first = 0; first < table->count; first++) {
        const whirl_tori own = whirl_table_tori(table, first);
        const double lines = point_number(table, first, WHIRL_FIELD_TORUS_REVOLUTIONS);
        for (size_t line = 0; (double)line < lines; line++) write_line(stream, to, table, own, station, line, which);
        first = own.last;
    }
    fputc('\n', stream);
}

whirl_status tori_write_bands(const drawing *to, size_t station, const char *name) {
    const whirl_table *table = tori_table(to->result);
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream,
            "# parameter (SI), low and high of x, of y (in %.10g m), of the closed curves of sections of tori\n"
            "# three blocks: all, stable ones, unstable ones\n",
            to->result->length_scale);
    write_choice(file.stream, to, table, station, ALL);
    write_choice(file.stream, to, table, station, STABLE);
    write_choice(file.stream, to, table, station, UNSTABLE);
    return report_file_close(&file);
}

void tori_plot_bands(FILE *script, int column, bool keyed) {
    fprintf(script,
            "bands index 0 using (value*$1):(length*$%d):(length*$%d) with filledcurves fillcolor rgb '#009E73' "
            "fillstyle transparent solid 0.30 noborder %s, \\\n  ",
            column, column + 1, keyed ? "title 'torus'" : "notitle");
    for (int stable = 1; stable >= 0; stable--)
        for (int side = 0; side < 2; side++)
            fprintf(script,
                    "bands index %d using (value*$1):(length*$%d) with lines linewidth 0.6 %slinecolor rgb '#009E73' "
                    "notitle, \\\n  ",
                    stable ? 1 : 2, column + side, stable ? "" : "dashtype (5,4) ");
}

// ---------------------------------------------------------------- numbers over the parameter

/// The larger amplitude of both coordinates of a station's second line, in the case's own length scale.
static double amplitude_of(const drawing *to, const whirl_table *table, size_t point, size_t station) {
    const double *amplitude = whirl_table_field(table, point, WHIRL_FIELD_TORUS_AMPLITUDE, station);
    return whirl_shown_length(to->units, table, point) / to->units->length * fmax(amplitude[0], amplitude[1]);
}

static void write_point(FILE *stream, const drawing *to, const whirl_table *table, size_t point) {
    fprintf(stream, "%.10g %.10g %.9g %.3g", table->values[point],
            point_number(table, point, WHIRL_FIELD_TORUS_ROTATION),
            point_number(table, point, WHIRL_FIELD_TORUS_EXPONENT),
            point_number(table, point, WHIRL_FIELD_TORUS_EXPONENT_ERROR));
    for (size_t s = 0; s < to->result->station_count; s++) fprintf(stream, " %.9g", amplitude_of(to, table, point, s));
    fputc('\n', stream);
}

/// Pieces of a branch that are stable, or those that are not, with empty lines between.
static void write_numbers(FILE *stream, const drawing *to, const whirl_table *table, const whirl_tori *own,
                          bool stable) {
    fputs("NaN NaN NaN NaN", stream); // keeps the count of the blocks where one is empty
    for (size_t s = 0; s < to->result->station_count; s++) fputs(" NaN", stream);
    fputs("\n\n", stream);
    for (size_t point = own->first; point <= own->last; point++) {
        if (is_stable(table, point) != stable) continue;
        if (point > own->first && is_stable(table, point - 1) != stable) write_point(stream, to, table, point - 1);
        write_point(stream, to, table, point);
        if (point == own->last || is_stable(table, point + 1) != stable) fputc('\n', stream);
    }
    fputc('\n', stream);
}

static whirl_status write_data(const drawing *to, const whirl_table *table, const whirl_tori *own, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream,
            "# parameter (SI), rotation number, largest normal exponent per revolution, its error, and for each "
            "station\n# the larger amplitude of its second line (in %.10g m, zero to peak)\n"
            "# two blocks: stable tori, unstable ones\n",
            to->result->length_scale);
    write_numbers(file.stream, to, table, own, true);
    write_numbers(file.stream, to, table, own, false);
    return report_file_close(&file);
}

// ---------------------------------------------------------------- the figure

static size_t common_divisor(size_t p, size_t q) {
    return p == 0 ? q : common_divisor(q % p, p);
}

/// Simple fractions of the range as lines: those of the smallest q, some.
static void write_resonances(FILE *script, const span *range) {
    enum { LARGEST = 12, SOME = 5 };
    const double turns = 1e3; // rotation numbers are below 1; a file may say otherwise
    size_t drawn = 0;
    if (!(range->low > -turns && range->high < turns)) return;
    for (size_t q = 1; q <= LARGEST && drawn < SOME; q++) {
        const double first = ceil(range->low * (double)q);
        for (double p = first + 0.0; p / (double)q <= range->high; p++) {
            if (common_divisor((size_t)fabs(p), q) != 1) continue;
            const double at = p / (double)q, below = (range->high - at) < 0.1 * (range->high - range->low) ? -1.0 : 1.0;
            fprintf(script,
                    "set arrow from graph 0, first %.10g to graph 1, first %.10g nohead linestyle 9 back\n"
                    "set label '%.0f/%zu' at graph 0.99, first %.10g right offset 0,%.1f font small_font "
                    "textcolor rgb '#606060'\n",
                    at, at, p, q, at, 0.5 * below);
            drawn++;
        }
    }
}

/// Of the rotation numbers, and of the resonance at which tori end.
static span rotations_of(const whirl_table *table, const whirl_tori *own) {
    const double *resonance = whirl_table_field(table, own->last, WHIRL_FIELD_TORUS_RESONANCE, 0);
    span range = span_empty();
    for (size_t point = own->first; point <= own->last; point++)
        span_widen(&range, point_number(table, point, WHIRL_FIELD_TORUS_ROTATION));
    if (point_number(table, own->last, WHIRL_FIELD_TORUS_END) == WHIRL_TORUS_ROUGH)
        span_widen(&range, resonance[0] / resonance[1]);
    return span_with_margin(range, 0.12, 1e-6);
}

/// Solid where tori are stable, dashed where not.
static void plot_both(FILE *script, const char *using, const char *colour, const char *title) {
    fprintf(script,
            "tori index 0 using (value*$1):%s with linespoints pointtype 7 pointsize 0.25 linewidth 1.1 linecolor rgb "
            "'%s' ",
            using, colour);
    fputs(*title ? "title " : "notitle", script);
    if (*title) gnuplot_string(script, title);
    fprintf(script,
            ", \\\n  tori index 1 using (value*$1):%s with linespoints pointtype 6 pointsize 0.25 linewidth 0.8 "
            "dashtype (6,4) linecolor rgb '%s' notitle",
            using, colour);
}

static void write_amplitudes(FILE *script, const drawing *to) {
    fputs("set key top right Left reverse samplen 1.5 font small_font\nset yrange [0:*]\nplot ", script);
    for (size_t s = 0; s < to->result->station_count; s++) {
        char using[64], title[TYPESET_SIZE];
        snprintf(using, sizeof using, "(amplitude*$%zu)", 5 + s);
        typeset_text(to->result->stations[s].name, title, sizeof title);
        if (s > 0) fputs(", \\\n  ", script);
        plot_both(script, using, colours[s % COLOURS], title);
    }
    fputs("\nunset key\nset yrange [*:*]\n", script);
}

static void write_panels(FILE *script, const drawing *to, const span *range) {
    fputs("set format x ''\nunset xlabel\nset ylabel 'rotation number'\n", script);
    script_panel(script, 0.155, 0.96, 0.680, 0.975);
    write_resonances(script, range);
    fprintf(script, "set yrange [%.10g:%.10g]\nplot ", range->low, range->high);
    plot_both(script, "2", colours[0], "");
    fputs("\nunset arrow\nunset label\nset yrange [*:*]\nset ylabel amplitude_label\n", script);
    script_panel(script, 0.155, 0.96, 0.380, 0.660);
    write_amplitudes(script, to);
    fputs("set format x '%g'\nset xlabel parameter_label\nset ylabel 'normal exponent / rev.'\n", script);
    script_panel(script, 0.155, 0.96, 0.080, 0.360);
    fputs("set offsets graph 0, graph 0, graph 0.06, graph 0.06\nplot 0 with lines linestyle 9 notitle, \\\n  ",
          script);
    plot_both(script, "3", colours[0], "");
    fputc('\n', script);
}

/// From where the tori begin to where they end, or seem to.
static void write_axis(FILE *script, const whirl_table *table, const whirl_tori *own, double unit) {
    span range = span_empty();
    span_widen(&range, unit * point_number(table, own->first, WHIRL_FIELD_TORUS_BEGINS));
    span_widen(&range, unit * point_number(table, own->last, WHIRL_FIELD_TORUS_LIMIT));
    for (size_t point = own->first; point <= own->last; point++) span_widen(&range, unit * table->values[point]);
    range = span_with_margin(range, 0.03, 0.0);
    fprintf(script, "set xrange [%.10g:%.10g]\nset xtics %.10g\n", range.low, range.high,
            tic_step(range.high - range.low, 6));
}

static whirl_status write_script(const drawing *to, const whirl_table *table, const whirl_tori *own,
                                 const figure *what) {
    report_file file;
    const whirl_status status = script_begin(&file, to, what, 12.0, 14.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    const whirl_shown_units units = typeset_units(to->units);
    const span range = rotations_of(table, own);
    char label[TYPESET_SIZE];
    typeset_parameter(to->units, table->parameter, label, sizeof label);
    script_label(file.stream, "parameter_label", label);
    units_amplitude_label(&units, "amplitude", label, sizeof label);
    script_label(file.stream, "amplitude_label", label);
    fprintf(file.stream, "tori = '%s'\nvalue = %.15g\namplitude = %.15g\n", what->data[0],
            1.0 / whirl_shown_parameter(to->units, table->parameter).size, to->units->length * to->units->amplitude);
    write_axis(file.stream, table, own, 1.0 / whirl_shown_parameter(to->units, table->parameter).size);
    script_loop(file.stream);
    write_panels(file.stream, to, &range);
    script_end(file.stream);
    return report_file_close(&file);
}

static whirl_status draw_one(const drawing *to, const whirl_table *table, const whirl_tori *own) {
    const double number = point_number(table, own->first, WHIRL_FIELD_TORUS_NUMBER);
    char stem[STEM_SIZE];
    snprintf(stem, sizeof stem, "torus-%.0f", number);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    snprintf(what->title, sizeof what->title, "Torus %.0f over %s", number, table->parameter);
    snprintf(what->caption, sizeof what->caption,
             "Quasi-periodic motions over %s, solid where they are stable, dashed where not. Above: the rotation "
             "number, turns round the closed curve of the section from one to the next, with simple fractions, near "
             "which motions may lock. Middle: the amplitude of the strongest line of the second frequency, the larger "
             "one of both coordinates. Below: the largest Lyapunov exponent across the torus.",
             table->parameter);
    const whirl_status status = write_data(to, table, own, what->data[0]);
    return status.code == WHIRL_OK ? write_script(to, table, own, what) : status;
}

whirl_status draw_tori(const drawing *to, const whirl_table *table) {
    whirl_status status = whirl_ok();
    for (size_t point = 0; point < table->count && status.code == WHIRL_OK; point++) {
        const whirl_tori own = whirl_table_tori(table, point);
        if (own.found > 1) status = draw_one(to, table, &own);
        point = own.last;
    }
    return status;
}
