// Bifurcation diagrams: the Poincare section of a station against the swept parameter, coloured by regime, above the
// verdict and its confidence, the largest Lyapunov exponent, the largest radius and the time in contact on the same
// axis. The data files and panels are made elsewhere (bifurcation.h); here is what holds them together.
#include <math.h>
#include <stdio.h>

#include "bifurcation.h"
#include "figures.h"
#include "regimes.h"
#include "typeset.h"

enum { MANY_POINTS = 150 }; ///< of a sweep: so many stand so close together that small dots are enough

/// A logarithmic axis; where it has few decades, 2 and 5 are labelled in each.
static void write_log_axis(FILE *script, span range) {
    const int first = (int)floor(log10(range.low)), last = (int)ceil(log10(range.high));
    fputs("set logscale x\n", script);
    if (last - first > 3) return;
    for (int k = first; k <= last; k++)
        fprintf(script, "set xtics add (%.10g, %.10g, %.10g)\n", pow(10, k), 2 * pow(10, k), 5 * pow(10, k));
}

static void write_colour_function(FILE *script) {
    fputs("colours = '", script);
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(script, "%s0x%s", kind ? " " : "", regime_class_colour((regime_class)kind) + 1);
    fputs("'\nattractor_colours = '", script);
    for (size_t k = 1; k <= ATTRACTOR_COLOURS; k++)
        fprintf(script, "%s0x%s", k > 1 ? " " : "", attractor_colour(k) + 1);
    fprintf(script, "'\nattractor_colour(number) = int(word(attractor_colours, int(number - 1) %% %d + 1))\n",
            ATTRACTOR_COLOURS);
    fputs("colour(class) = int(word(colours, int(class) + 1))\n"
          "trust_colour(level) = int(word('0xD55E00 0xA8A8A8 0xDCDCDC', int(level) + 1))\n",
          script);
}

/// What stands at the axes, and what the numbers of the data files are multiplied by.
static void write_labels(FILE *script, const bifurcation *of) {
    const whirl_shown_units units = typeset_units(of->units);
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

static whirl_status write_script(const drawing *to, const bifurcation *of, const figure *what) {
    report_file file;
    const double height = (of->rub ? 16.0 : 14.5) + (of->confidence ? 0.8 : 0.0);
    const whirl_status status = script_begin(&file, to, what, 8.5, height, 6.5);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    write_labels(script, of);
    fprintf(script, "dot_size = %g\n", of->table->count > MANY_POINTS ? 0.06 : 0.1);
    write_colour_function(script);
    fprintf(script, "set xrange [%.10g:%.10g]\n", of->parameter.low, of->parameter.high);
    if (of->ratios) write_log_axis(script, of->parameter);
    script_loop(script);
    fputs("set format x ''\nunset xlabel\n", script);
    bifurcation_write_rub_bands(script, of);
    bifurcation_write_panels(script, of);
    fputs("unset object\n", script);
    script_end(script);
    return report_file_close(&file);
}

/// What the strips of regimes stand for, and what there is below them for attractors alone.
static const char *strips_of(const bifurcation *of) {
    if (of->attractors == 0)
        return of->both ? " (upper strip: followed from the first value on; lower strip: from the last)" : "";
    if (of->table->source->neighbours == 0)
        return " (a strip an attractor, the first at the top) and the share of the starts";
    return " (a strip an attractor, the first at the top) and the share of the starts (circles: found from neighbours "
           "alone)";
}

static whirl_status draw_station(const drawing *to, bifurcation *of) {
    const char *station = to->result->stations[of->station].name;
    char stem[STEM_SIZE];
    snprintf(stem, sizeof stem, "bifurcation-%s", station);
    figure *what = figure_add(to->list, to->index, stem);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = of->station;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    snprintf(what->data[1], sizeof what->data[1], "sweep.dat");
    snprintf(what->title, sizeof what->title, "Bifurcation diagram of %s over %s", station, of->table->parameter);
    snprintf(what->caption, sizeof what->caption,
             "Poincar\u00e9 section of %s (one dot a revolution) over %s, coloured by %s.%s Below: the regime%s%s, the "
             "largest Lyapunov exponent with its standard error, %s%s%s%s.",
             station, of->table->parameter, of->attractors > 0 ? "the attractor that starts lead to" : "regime",
             of->shaded ? " Shaded: the rotor rubs." : "", strips_of(of),
             !of->confidence ? ""
             : of->both      ? ", how far it can be trusted (bars: from the first value on; lines: from the last)"
                             : ", how far it can be trusted",
             of->clearance > 0.0 ? "largest eccentricity ratio" : "largest radius",
             of->gap > 0.0 ? " (dashed: the gap to the stator)" : "", of->rub ? ", share of the time in contact" : "",
             of->both ? " (blue: from the first value on; orange: from the last)" : "");
    of->data = what->data[0];
    const whirl_status status = bifurcation_write_section(to, of, what->data[0]);
    return status.code == WHIRL_OK ? write_script(to, of, what) : status;
}

whirl_status draw_bifurcations(const drawing *to) {
    const whirl_table *table = whirl_result_table(to->result, "sweep");
    if (!table || table->count == 0 || !whirl_layout_field(&table->layout, WHIRL_FIELD_POINCARE_SECTION))
        return whirl_ok();
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < to->result->station_count && status.code == WHIRL_OK; s++) {
        bifurcation of = {.result = to->result,
                          .table = table,
                          .machine = to->machine,
                          .station = s,
                          .units = to->units,
                          .length = to->units->length,
                          .value = 1.0 / whirl_shown_parameter(to->units, table->parameter).size};
        bifurcation_survey(&of);
        if (s == 0) status = bifurcation_write_sweep(to, &of);
        if (status.code == WHIRL_OK) status = draw_station(to, &of);
    }
    return status;
}
