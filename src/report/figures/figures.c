#include "figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gnuplot.h"
#include "typeset.h"

static bool taken(const figure_list *list, const figure *what) {
    for (const figure *other = list->items; other < what; other++)
        if (other->result == what->result && strcmp(other->stem, what->stem) == 0) return true;
    return false;
}

figure *figure_add(figure_list *list, size_t result, const char *stem) {
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity ? 2 * list->capacity : 32;
        figure *items = realloc(list->items, capacity * sizeof *items);
        if (!items) return NULL;
        list->items = items;
        list->capacity = capacity;
    }
    figure *what = &list->items[list->count++];
    *what = (figure){.result = result, .point = NO_POINT};
    char safe[STEM_SIZE - 24];
    safe_name(stem, safe, sizeof safe);
    snprintf(what->stem, sizeof what->stem, "%s", safe);
    for (unsigned again = 2; taken(list, what); again++) snprintf(what->stem, sizeof what->stem, "%s-%u", safe, again);
    return what;
}

void script_label(FILE *script, const char *name, const char *markup) {
    fprintf(script, "%s = ", name);
    gnuplot_string(script, markup);
    fputc('\n', script);
}

whirl_status script_begin(report_file *file, const drawing *to, const figure *what, double width, double height,
                          double font) {
    char name[STEM_SIZE + 4], title[2 * sizeof what->title];
    snprintf(name, sizeof name, "%s.gp", what->stem);
    const whirl_status status = report_file_open(file, to->folder, name);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file->stream;
    typeset_text(what->title, title, sizeof title);
    fprintf(script, "# %s: ", what->stem);
    gnuplot_comment(script, what->title);
    fprintf(script, "\n# Run in this folder to draw it again:  gnuplot %s.gp\n", what->stem);
    fputs(
        "# Journals want the title in the caption; with show_title = 1 it stands in the picture too.\nshow_title = 0\n",
        script);
    script_label(script, "title_text", title);
    fprintf(
        script,
        "name = '%s'\nwidth_cm = %.2f\nheight_cm = %.2f\ndots_per_inch = 300\nfont_name = 'Sans'\nfont_size = %.3g\n"
        "base_font = sprintf('%%s,%%.3g', font_name, font_size)\n"
        "small_font = sprintf('%%s,%%.3g', font_name, 0.9*font_size)\n",
        what->stem, width, height, font);
    fputs("top = show_title ? 0.975 : 1 # share of the height that the panels have\n"
          "set encoding utf8\nset minussign\n"
          "set border 31 linewidth 0.5 linecolor rgb '#303030'\n"
          "set tics scale 0.4 font small_font textcolor rgb '#000000'\n"
          "set xtics nomirror\nset ytics nomirror\n"
          "set style line 1 linecolor rgb '#0072B2' linewidth 0.7\n"
          "set style line 2 linecolor rgb '#D55E00' linewidth 0.7\n"
          "set style line 9 linecolor rgb '#9A9A9A' linewidth 0.5 dashtype 2\n"
          "unset key\n",
          script);
    return status;
}

void script_loop(FILE *script) {
    // Cairo takes a point for 1/96 inch: the scales make fonts, lines and points as large as they say.
    fputs("do for [format in 'png pdf'] {\n"
          "if (format eq 'png') {\n"
          "  set terminal pngcairo enhanced background 'white' font base_font \\\n"
          "    size int(width_cm/2.54*dots_per_inch), int(height_cm/2.54*dots_per_inch) \\\n"
          "    fontscale dots_per_inch/96.0 linewidth dots_per_inch/96.0 pointscale dots_per_inch/96.0\n"
          "} else {\n"
          "  set terminal pdfcairo enhanced background 'white' font base_font \\\n"
          "    fontscale 0.75 linewidth 0.75 pointscale 0.75 size width_cm cm, height_cm cm\n"
          "}\n"
          "set output name.'.'.format\n"
          "set multiplot\n"
          "if (show_title) { set label 1 title_text at screen 0.5, screen 0.5*(1 + top) center }\n",
          script);
}

void script_end(FILE *script) {
    fputs("unset multiplot\nunset output\n}\n", script);
}

void script_panel(FILE *script, double left, double right, double bottom, double top) {
    fprintf(script, "set lmargin at screen %.5f\nset rmargin at screen %.5f\n", left, right);
    fprintf(script, "set bmargin at screen %.5f*top\nset tmargin at screen %.5f*top\n", bottom, top);
}

double tic_step(double width, int most) {
    const double least = width / most;
    if (!(least > 0.0) || !isfinite(least)) return 1.0;
    const double power = pow(10.0, floor(log10(least))), lead = least / power;
    return (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0) * power;
}

span span_empty(void) {
    return (span){(double)INFINITY, -(double)INFINITY};
}

void span_widen(span *range, double value) {
    if (!isfinite(value)) return;
    if (value < range->low) range->low = value;
    if (value > range->high) range->high = value;
}

span span_with_margin(span range, double margin, double least) {
    if (range.low > range.high) return (span){0.0, 1.0};
    const double middle = 0.5 * (range.low + range.high);
    const double width = fmax((1.0 + 2.0 * margin) * (range.high - range.low), least);
    return (span){middle - 0.5 * width, middle + 0.5 * width};
}
