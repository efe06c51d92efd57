// Branches of orbits over a parameter, on the section of a sweep where there is one, and the multipliers that say why
// they change; curves of special points over two parameters.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figures.h"
#include "figures_tori.h"
#include "quantities.h"
#include "typeset.h"

static const double two_pi = 6.283185307179586476925;

// Kinds of special points, as whirl_special has them.
static const struct {
    const char *title, *colour;
    int mark; ///< gnuplot's pointtype
} kinds[] = {
    {"", "#000000", 7},
    {"fold", "#000000", 13},
    {"branching", "#CC79A7", 15},
    {"period doubling", "#D55E00", 9},
    {"Neimark\u2013Sacker", "#009E73", 7},
    {"Hopf", "#0072B2", 5},
    {"grazing", "#56B4E9", 4},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static bool is_special(const whirl_table *table, size_t point) {
    return point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL) > 0.0;
}

static bool are_one(const whirl_table *table, size_t a, size_t b) {
    return point_number(table, a, WHIRL_FIELD_TRACE_NUMBER) == point_number(table, b, WHIRL_FIELD_TRACE_NUMBER);
}

/// Whether orbits between two neighbouring points are stable: special points are on the verge.
static bool is_stable(const whirl_table *table, size_t a, size_t b) {
    const size_t told = is_special(table, a) ? b : a;
    return point_number(table, told, WHIRL_FIELD_TRACE_UNSTABLE) == 0.0;
}

/// Largest modulus of a multiplier; of an equilibrium that over a revolution.
static double multiplier_of(const whirl_table *table, size_t point) {
    const double largest = point_number(table, point, WHIRL_FIELD_TRACE_LARGEST);
    return point_number(table, point, WHIRL_FIELD_TRACE_PERIOD) > 0.0 ? largest : exp(two_pi * largest);
}

// ---------------------------------------------------------------- data

/// The lines that a point is drawn as: of a forced orbit one a revolution, of others the bounds of their motion.
static size_t lines_of(const whirl_table *table, size_t point) {
    const double revolutions = point_number(table, point, WHIRL_FIELD_TRACE_REVOLUTIONS);
    return revolutions > 0.0 ? (size_t)revolutions : point_number(table, point, WHIRL_FIELD_TRACE_PERIOD) > 0.0 ? 2 : 1;
}

/// Of the parameter, over all that is drawn.
static span range_of(const drawing *to, const whirl_table *table) {
    span range = span_empty();
    const whirl_table *sweep = whirl_result_table(to->result, "sweep");
    for (size_t i = 0; i < table->count; i++) span_widen(&range, table->values[i]);
    for (size_t i = 0; sweep && i < sweep->count; i++) span_widen(&range, sweep->values[i]);
    return range;
}

static void write_at(FILE *stream, const drawing *to, const whirl_table *table, size_t point, size_t station,
                     size_t line) {
    const bool forced = point_number(table, point, WHIRL_FIELD_TRACE_REVOLUTIONS) > 0.0;
    const double *at =
        forced ? whirl_table_field(table, point, WHIRL_FIELD_TRACE_SECTION, station) + 4 * line
               : whirl_table_field(table, point, line == 0 ? WHIRL_FIELD_TRACE_HIGH : WHIRL_FIELD_TRACE_LOW, station);
    const double own = whirl_shown_length(to->units, table, point) / to->units->length;
    fprintf(stream, "%.10g %.9g %.9g %.9g %.0f %d\n", table->values[point], own * at[0], own * at[1],
            multiplier_of(table, point), point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL), line == 0);
}

/// Pieces of branches that are stable, or those that are not: blocks with empty lines between.
static void write_pieces(FILE *stream, const drawing *to, const whirl_table *table, size_t station, bool stable) {
    for (size_t first = 0; first + 1 < table->count; first++) {
        size_t last = first;
        while (last + 1 < table->count && are_one(table, last, last + 1) && is_stable(table, last, last + 1) == stable)
            last++;
        if (last == first) continue;
        for (size_t line = 0; line < lines_of(table, first); line++) {
            for (size_t point = first; point <= last; point++) write_at(stream, to, table, point, station, line);
            fputc('\n', stream);
        }
        first = last - 1;
    }
}

/// Special points that have room for a label: none that is labelled before it is nearer than a 30th of the axis.
static void write_labelled(FILE *stream, const drawing *to, const whirl_table *table, size_t station) {
    const span range = range_of(to, table);
    const double near = (range.high - range.low) / 30.0;
    double taken[64];
    size_t count = 0;
    for (size_t point = 0; point < table->count && count < sizeof taken / sizeof *taken; point++) {
        bool room = is_special(table, point);
        for (size_t k = 0; k < count && room; k++) room = fabs(taken[k] - table->values[point]) >= near;
        if (!room) continue;
        taken[count++] = table->values[point];
        write_at(stream, to, table, point, station, 0);
    }
}

static whirl_status write_branches(const drawing *to, const whirl_table *table, size_t station, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream,
            "# parameter (SI), x, y (in %.10g m), largest multiplier, kind of special point, 1: of its first line\n"
            "# four blocks: stable orbits, unstable ones, special points, those that have room for a label\n",
            to->result->length_scale);
    for (int stable = 1; stable >= 0; stable--) {
        fputs("NaN NaN NaN NaN 0 0\n\n", file.stream); // keeps the count of the blocks where one is empty
        write_pieces(file.stream, to, table, station, stable);
        fputs("\n", file.stream);
    }
    fputs("NaN NaN NaN NaN 0 0\n", file.stream);
    for (size_t point = 0; point < table->count; point++)
        for (size_t line = 0; is_special(table, point) && line < lines_of(table, point); line++)
            write_at(file.stream, to, table, point, station, line);
    fputs("\n\n", file.stream);
    write_labelled(file.stream, to, table, station);
    return report_file_close(&file);
}

// ---------------------------------------------------------------- the figure

static bool has_kind(const whirl_table *table, int kind) {
    for (size_t point = 0; point < table->count; point++)
        if (point_number(table, point, WHIRL_FIELD_TRACE_SPECIAL) == kind) return true;
    return false;
}

static void write_marks(FILE *script, const whirl_table *table, const char *column, bool keyed) {
    for (int kind = 1; kind < KINDS; kind++)
        if (has_kind(table, kind))
            fprintf(script,
                    ", \\\n  branches index 2 using ($5 == %d%s ? value*$1 : NaN):(%s) with points pointtype %d "
                    "pointsize 0.5 linewidth 0.8 linecolor rgb '%s' %s%s%s",
                    kind, keyed ? "" : " && $6 == 1", column, kinds[kind].mark, kinds[kind].colour,
                    keyed ? "title '" : "notitle", keyed ? kinds[kind].title : "", keyed ? "'" : "");
    fputc('\n', script);
}

static void write_section_panel(FILE *script, const whirl_table *table, const figure *what, int column, bool keyed) {
    const char *dots = what->data[1];
    if (keyed)
        fprintf(script,
                "set key at screen 0.55, screen 0.998*top center top horizontal maxrows 2 Left reverse samplen 1.5 "
                "width %d font small_font\n",
                *what->data[2] ? -3 : -1);
    else
        fputs("unset key\n", script);
    fputs("plot ", script);
    if (*dots)
        fprintf(script,
                "'%s' using (value*$1):(length*$%d) with points pointtype 7 pointsize 0.06 linewidth 0.3 "
                "linecolor rgb '#C4C4C4' notitle, \\\n  ",
                dots, column);
    if (*what->data[2]) tori_plot_bands(script, 2 * column - 2, keyed);
    fprintf(script,
            "branches index 0 using (value*$1):(length*$%d) with lines linewidth 1.1 linecolor rgb '#0072B2' title "
            "'stable', \\\n"
            "  branches index 1 using (value*$1):(length*$%d) with lines linewidth 0.8 dashtype (6,4) "
            "linecolor rgb '#D55E00' title 'unstable'",
            column, column);
    char scaled[32];
    snprintf(scaled, sizeof scaled, "length*$%d", column);
    write_marks(script, table, scaled, keyed);
}

static void write_multiplier_panel(FILE *script, const whirl_table *table) {
    fputs("unset key\nset logscale y\nset format y '%g'\n"
          "plot 1 with lines linestyle 9 notitle, \\\n"
          "  branches index 0 using (value*$1):4 with lines linewidth 1.1 linecolor rgb '#0072B2' notitle, \\\n"
          "  branches index 1 using (value*$1):4 with lines linewidth 0.8 dashtype (6,4) linecolor rgb '#D55E00' "
          "notitle",
          script);
    bool any = false;
    for (size_t i = 0; i < table->count; i++) any = any || is_special(table, i);
    if (any) // gnuplot falls over labels of which there is none
        fputs(", \\\n  branches index 3 using (value*$1):4:(sprintf('%.5g', value*$1)) with labels rotate by 60 left "
              "offset 0.2,0.5 font small_font notitle",
              script);
    write_marks(script, table, "$4", false);
    fputs("unset logscale y\n", script);
}

/// The section of the sweep beside the branches, "" where there is none.
static const char *dots_of(const drawing *to, size_t station) {
    for (size_t i = 0; i < to->list->count; i++) {
        const figure *other = &to->list->items[i];
        if (other->result == to->index && other->station == station && strncmp(other->stem, "bifurcation-", 12) == 0)
            return other->data[0];
    }
    return "";
}

static whirl_status write_script(const drawing *to, const whirl_table *table, const figure *what) {
    report_file file;
    const whirl_status status = script_begin(&file, to, what, 12.0, 14.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    const whirl_shown_units units = typeset_units(to->units);
    const double value = 1.0 / whirl_shown_parameter(to->units, table->parameter).size;
    const span range = range_of(to, table);
    char label[TYPESET_SIZE];
    typeset_parameter(to->units, table->parameter, label, sizeof label);
    script_label(script, "parameter_label", label);
    units_length_label(&units, "{/:Italic x}", label, sizeof label);
    script_label(script, "x_label", label);
    units_length_label(&units, "{/:Italic y}", label, sizeof label);
    script_label(script, "y_label", label);
    fprintf(script, "branches = '%s'\nlength = %.15g\nvalue = %.15g\n", what->data[0], to->units->length, value);
    fprintf(script, "set xrange [%.10g:%.10g]\n", value * range.low, value * range.high);
    if (*what->data[2]) fprintf(script, "bands = '%s'\n", what->data[2]);
    script_loop(script);
    fputs("set format x ''\nunset xlabel\nset ylabel x_label\n", script);
    script_panel(script, 0.13, 0.96, 0.670, 0.945);
    write_section_panel(script, table, what, 2, true);
    fputs("set ylabel y_label\n", script);
    script_panel(script, 0.13, 0.96, 0.375, 0.650);
    write_section_panel(script, table, what, 3, false);
    fputs("set format x '%g'\nset xlabel parameter_label\nset ylabel 'largest multiplier'\n", script);
    script_panel(script, 0.13, 0.96, 0.080, 0.355);
    write_multiplier_panel(script, table);
    script_end(script);
    return report_file_close(&file);
}

static whirl_status draw_station(const drawing *to, const whirl_table *table, size_t station) {
    const char *name = to->result->stations[station].name, *dots = dots_of(to, station);
    char stem[STEM_SIZE], section[STEM_SIZE];
    snprintf(section, sizeof section, "%s", dots);
    snprintf(stem, sizeof stem, "branch-%s", name);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = station;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    snprintf(what->data[1], sizeof what->data[1], "%s", section);
    snprintf(what->title, sizeof what->title, "Branches of %s over %s", name, table->parameter);
    snprintf(what->caption, sizeof what->caption,
             "Periodic orbits of %s over %s, once a revolution (of motions with a time of their own: largest and "
             "smallest values): solid where they are stable, dashed where not.%s%s Marks: where they change, as the "
             "table tells. Below: the largest modulus of a Floquet multiplier.",
             name, table->parameter, *section ? " Grey: the section of the motions that the sweep settled on." : "",
             tori_table(to->result) ? tori_caption : "");
    whirl_status status = write_branches(to, table, station, what->data[0]);
    if (status.code == WHIRL_OK && tori_table(to->result)) {
        snprintf(what->data[2], sizeof what->data[2], "%.180s-tori.dat", what->stem);
        status = tori_write_bands(to, station, what->data[2]);
    }
    return status.code == WHIRL_OK ? write_script(to, table, what) : status;
}

// ---------------------------------------------------------------- curves

static whirl_status write_curves(const drawing *to, const whirl_table *table, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fputs("# both parameters (SI), kind; a block a kind of special points, each curve ends with an empty line\n",
          file.stream);
    for (int kind = 1; kind < KINDS; kind++) {
        fputs("NaN NaN 0\n\n", file.stream);
        for (size_t i = 0; i < table->count; i++) {
            if (point_number(table, i, WHIRL_FIELD_TRACE_SPECIAL) != kind) continue;
            fprintf(file.stream, "%.10g %.10g %d\n", table->values[i], point_number(table, i, WHIRL_FIELD_TRACE_SECOND),
                    kind);
            if (i + 1 == table->count || !are_one(table, i, i + 1)) fputc('\n', file.stream);
        }
        fputc('\n', file.stream);
    }
    return report_file_close(&file);
}

static whirl_status draw_curves(const drawing *to, const whirl_table *table) {
    const char *second = whirl_result_fact(to->result, "second parameter");
    report_file file;
    figure *what = figure_add(to->list, to->index, "curves");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->data[0], sizeof what->data[0], "curves.dat");
    snprintf(what->title, sizeof what->title, "Where motions change, over %s and %.60s", table->parameter, second);
    snprintf(what->caption, sizeof what->caption,
             "Curves over %s and %.60s along which periodic orbits change: what lies between them is of one kind.",
             table->parameter, second);
    whirl_status status = write_curves(to, table, what->data[0]);
    if (status.code == WHIRL_OK) status = script_begin(&file, to, what, 12.0, 9.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    char label[TYPESET_SIZE];
    typeset_parameter(to->units, table->parameter, label, sizeof label);
    script_label(script, "parameter_label", label);
    typeset_parameter(to->units, second, label, sizeof label);
    script_label(script, "second_label", label);
    fprintf(script, "curves = '%s'\nvalue = %.15g\nsecond = %.15g\n", what->data[0],
            1.0 / whirl_shown_parameter(to->units, table->parameter).size,
            1.0 / whirl_shown_parameter(to->units, second).size);
    script_loop(script);
    script_panel(script, 0.13, 0.96, 0.11, 0.92);
    fputs("set xlabel parameter_label\nset ylabel second_label\n"
          "set key at screen 0.55, screen 0.995*top center top horizontal maxrows 1 Left reverse samplen 1.5 "
          "font small_font\nplot NaN notitle",
          script);
    for (int kind = 1; kind < KINDS; kind++)
        if (has_kind(table, kind))
            fprintf(script,
                    ", \\\n  curves index %d using (value*$1):(second*$2) with lines linewidth 1.2 linecolor rgb '%s' "
                    "title '%s'",
                    kind - 1, kinds[kind].colour, kinds[kind].title);
    fputc('\n', script);
    script_end(script);
    return report_file_close(&file);
}

whirl_status draw_branches(const drawing *to, const whirl_table *table) {
    whirl_status status = whirl_ok();
    if (table->count < 2) return status;
    if (*table->second) return draw_curves(to, table);
    for (size_t s = 0; s < to->result->station_count && status.code == WHIRL_OK; s++)
        status = draw_station(to, table, s);
    return status;
}
