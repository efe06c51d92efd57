#include "gnuplot_script.h"
#include "gnuplot.h"

#include <math.h>
#include <string.h>

#include "figure_build.h"
#include "number_text.h"

enum { MARKUP_SIZE = 1024 };

/// Point types of gnuplot, one for each whirl_mark.
static const int point_types[] = {7, 6, 5, 4, 9, 11, 13, 2};

/// Sizes in points of a mark of pointsize 1 and a line of linewidth 1, with the terminals below.
static const double MARK = 4.5, LINE = 0.75;

// ---------------------------------------------------------------- text

void gnuplot_markup(const char *label, char *markup, size_t size) {
    size_t used = 0;
    bool symbol = false, below = false;
    for (; *label && used + 16 < size; label++) {
        if (*label == '$') {
            used += (size_t)snprintf(markup + used, size - used, "%s", symbol ? (below ? "" : "}") : "{/:Italic ");
            symbol = !symbol;
            below = false;
        } else if (symbol && label[0] == '_' && label[1] == '{') {
            used += (size_t)snprintf(markup + used, size - used, "}_{");
            label++;
            below = true;
        } else if (symbol && below && *label == '}') {
            markup[used++] = '}';
        } else {
            if (strchr("^_@&~{}\\", *label)) markup[used++] = '\\';
            markup[used++] = *label;
        }
    }
    markup[used] = '\0';
}

static void put_text(FILE *script, const char *label) {
    char markup[MARKUP_SIZE];
    gnuplot_markup(label, markup, sizeof markup);
    gnuplot_string(script, markup);
}

// ---------------------------------------------------------------- numbers

/// Returns the place of a value on an axis. A logarithmic axis is drawn as a linear axis of logarithms with ticks of
/// its own, since a logarithmic axis of gnuplot stays linked to the axes of the following panels.
static double place(const whirl_axis *axis, double value) {
    if (!axis->logarithmic) return value;
    return value > 0.0 ? log10(value) : (double)NAN;
}

static void gnuplot_put_number(FILE *data, double value, bool last) {
    char text[NUMBER_SIZE] = "NaN";
    if (isfinite(value)) snprintf(text, sizeof text, "%.9g", value);
    fprintf(data, "%s%c", text, last ? '\n' : ' ');
}

static const char *columns_of(const whirl_series *series) {
    switch (series->shape) {
    case WHIRL_AREA:
    case WHIRL_BARS:
        return "x y y_to";
    case WHIRL_BOXES:
        return series->values ? "x y x_to y_to value" : "x y x_to y_to";
    default:
        return "x y";
    }
}

/// Returns true for a point that breaks a line or an area.
static bool is_break(const whirl_series *series, size_t k) {
    return (series->shape == WHIRL_LINE || series->shape == WHIRL_AREA) && (isnan(series->x[k]) || isnan(series->y[k]));
}

static void write_series(FILE *data, const whirl_panel *panel, const whirl_series *series) {
    bool open = false; // inside a line: an empty line of text breaks it, two would end the block
    for (size_t k = 0; k < series->count; k++) {
        if (is_break(series, k)) {
            if (open) fputc('\n', data);
            open = false;
            continue;
        }
        open = true;
        gnuplot_put_number(data, place(&panel->x, series->x[k]), false);
        gnuplot_put_number(data, place(&panel->y, series->y[k]), !series->y_to && !series->x_to && !series->values);
        if (series->x_to) gnuplot_put_number(data, place(&panel->x, series->x_to[k]), false);
        if (series->y_to) gnuplot_put_number(data, place(&panel->y, series->y_to[k]), !series->values);
        if (series->values) gnuplot_put_number(data, series->values[k], true);
    }
}

/// Returns true if a series has a data block. Texts are in the script. A series that is empty, or has only breaks, has
/// no block: gnuplot would not count it.
static bool has_block(const whirl_series *series) {
    size_t k = 0;
    while (k < series->count && is_break(series, k)) k++;
    return k < series->count && series->shape != WHIRL_TEXTS;
}

void gnuplot_write_data(FILE *data, const whirl_figure *figure) {
    bool first = true;
    for (size_t p = 0; p < figure->count; p++)
        for (size_t s = 0; s < figure->panels[p]->count; s++) {
            const whirl_panel *panel = figure->panels[p];
            const whirl_series *series = panel->series[s];
            if (!has_block(series)) continue;
            if (!first) fputs("\n\n", data);
            first = false;
            fprintf(data, "# panel %s%s%s: %s", panel->name, panel->x.logarithmic ? ", log10 of x" : "",
                    panel->y.logarithmic ? ", log10 of y" : "", columns_of(series));
            fputs(*series->name ? " of " : "", data);
            gnuplot_comment(data, series->name);
            fputc('\n', data);
            write_series(data, panel, series);
        }
}

// ---------------------------------------------------------------- axes

/// Writes small ticks between the powers of a logarithmic axis.
static void write_small_ticks(FILE *script, const whirl_axis *axis) {
    for (int k = (int)floor(log10(axis->low)); k <= (int)ceil(log10(axis->high)); k++)
        for (int digit = 2; digit < 10; digit++) {
            const double at = digit * pow(10.0, k);
            if (at > axis->low && at < axis->high) fprintf(script, ", '' %.8g 1", log10(at));
        }
}

static void write_ticks(FILE *script, const whirl_axis *axis, char which) {
    fprintf(script, "set %ctics (", which);
    for (size_t i = 0; i < axis->tick_count; i++) {
        fputs(i ? ", " : "", script);
        put_text(script, axis->shown ? axis->tick_texts[i] : "");
        fprintf(script, " %.9g", place(axis, axis->ticks[i]));
    }
    if (axis->logarithmic && axis->tick_count > 0) write_small_ticks(script, axis);
    fputs(")\n", script);
}

static void write_axis(FILE *script, const whirl_axis *axis, char which) {
    fprintf(script, "set %crange [%.9g:%.9g]\n", which, place(axis, axis->low), place(axis, axis->high));
    write_ticks(script, axis, which);
    if (axis->shown && *axis->label && which == 'x') {
        fputs("set xlabel ", script);
        put_text(script, axis->label);
        fputs(" offset 0, 0.5\n", script);
    } else if (which == 'x') {
        fputs("unset xlabel\n", script);
    }
}

/// Writes the label of a vertical axis, in line with the labels of other panels.
static void write_upright_label(FILE *script, const whirl_figure *figure, const whirl_panel *panel) {
    char label[MARKUP_SIZE];
    if (!panel->y.shown || !*panel->y.label) return;
    gnuplot_markup(panel->y.label, label, sizeof label);
    const bool flat = panel->height < FIGURE_LOW_PANEL;
    const double labels = figure_number_width(figure) + (flat ? 0.95 : 0.58);
    char *rest = strchr(label, '\n');
    // A second line comes between the first and the numbers: both move by half a line.
    const double left = panel->left - (labels + (rest ? 0.021 * figure->font : 0.0)) / figure->width;
    fputs("set label 2 ", script);
    // Write the line break as a double-quoted text: single quotes do not expand it.
    if (rest) *rest = '\0';
    gnuplot_string(script, label);
    if (rest) {
        fputs(".\"\\n\".", script);
        gnuplot_string(script, rest + 1);
    }
    fprintf(script, " at screen %.5f, graph 0.5 %s\n", left, flat ? "left" : "center rotate");
}

// ---------------------------------------------------------------- series

static void write_style(FILE *script, const whirl_series *series) {
    switch (series->shape) {
    case WHIRL_DOTS:
        fprintf(script, "with points pointtype %d pointsize %.3g linewidth %.3g linecolor rgb '%s'",
                point_types[series->mark], series->size / MARK, series->size > 2.0 ? 0.8 : 0.3, series->colour);
        break;
    case WHIRL_LINE:
        fprintf(script, "with lines linewidth %.3g %slinecolor rgb '%s'", series->size / LINE,
                series->dashed ? "dashtype (6,4) " : "", series->colour);
        break;
    case WHIRL_AREA:
        fprintf(script, "with filledcurves fillcolor rgb '%s' fillstyle transparent solid %.2f noborder",
                series->colour, series->opacity);
        break;
    case WHIRL_BARS:
        fprintf(script, "with vectors nohead linewidth %.3g linecolor rgb '%s'", series->size / LINE, series->colour);
        break;
    default:
        break;
    }
}

/// Writes boxes with an edge of their own colour, so that no gap is visible between neighbours.
static void write_boxes(FILE *script, const whirl_series *series) {
    if (series->values)
        fputs(
            "using ($1/2+$3/2):($2/2+$4/2):1:3:2:4:5 with boxxyerror fillstyle solid 1 border linewidth 0.3 linecolor "
            "palette",
            script);
    else
        fprintf(script,
                "using ($1/2+$3/2):($2/2+$4/2):1:3:2:4 with boxxyerror fillstyle solid %.2f border linewidth 0.2 "
                "linecolor rgb '%s'",
                series->opacity, series->colour);
}

static void write_plot(FILE *script, const whirl_series *series, size_t index) {
    fprintf(script, "data index %zu ", index);
    switch (series->shape) {
    case WHIRL_BOXES:
        write_boxes(script, series);
        break;
    case WHIRL_AREA:
        fputs("using 1:2:3 ", script);
        write_style(script, series);
        break;
    case WHIRL_BARS:
        fputs("using 1:2:(0):($3-$2) ", script);
        write_style(script, series);
        break;
    default:
        fputs("using 1:2 ", script);
        write_style(script, series);
    }
    fputs(" notitle", script);
}

/// Writes an entry of a legend; its dots are larger than in the panel, to be visible.
static void write_entry(FILE *script, const whirl_series *series) {
    const bool box = series->shape == WHIRL_BOXES || series->shape == WHIRL_AREA;
    fputs("keyentry ", script);
    if (box)
        fprintf(script, "with boxes fillstyle solid %.2f noborder linecolor rgb '%s'", series->opacity, series->colour);
    else if (series->shape == WHIRL_DOTS)
        fprintf(script, "with points pointtype %d pointsize %.2g linewidth 0.7 linecolor rgb '%s'",
                point_types[series->mark], fmax(series->size / MARK, 0.45), series->colour);
    else
        write_style(script, series);
    fputs(" title ", script);
    put_text(script, series->name);
}

static bool is_in_legend_before(const whirl_figure *figure, size_t p, size_t s) {
    const char *name = figure->panels[p]->series[s]->name;
    for (size_t i = 0; i <= p; i++)
        for (size_t k = 0; k < (i == p ? s : figure->panels[i]->count); k++)
            if (!figure->panels[i]->keyed && strcmp(figure->panels[i]->series[k]->name, name) == 0) return true;
    return false;
}

/// Writes the entries of the legend inside a panel or, for an index past the last panel, of the figure's legend.
/// Returns their number.
static size_t write_entries(FILE *script, const whirl_figure *figure, size_t panel) {
    const bool own = panel < figure->count;
    size_t count = 0;
    for (size_t p = own ? panel : 0; p < (own ? panel + 1 : figure->count); p++)
        for (size_t s = 0; s < figure->panels[p]->count; s++) {
            const whirl_series *series = figure->panels[p]->series[s];
            if (!*series->name || figure->panels[p]->keyed != own || (!own && is_in_legend_before(figure, p, s)))
                continue;
            fputs(count++ ? ", \\\n  " : "plot ", script);
            write_entry(script, series);
        }
    return count;
}

static void write_texts(FILE *script, const whirl_panel *panel, const whirl_series *series) {
    static const char *const places[] = {"center offset 0, 0.45",
                                         "center offset 0, -0.6",
                                         "right offset -0.6, 0.7",
                                         "left offset 0.6, -0.7",
                                         "left offset 0.2, 0.5 rotate by 60",
                                         "left offset 0.5, 0"};
    for (size_t k = 0; k < series->count; k++) {
        const double x = place(&panel->x, series->x[k]), y = place(&panel->y, series->y[k]);
        if (!isfinite(x) || !isfinite(y)) continue;
        fputs("set label ", script);
        put_text(script, series->texts[k]);
        fprintf(script, " at first %.9g, first %.9g %s font small_font textcolor rgb '%s' front\n", x, y,
                places[series->side], series->colour);
    }
}

/// Returns true if the legend has samples of lines, which need room.
static bool has_lines(const whirl_figure *figure) {
    for (size_t p = 0; p < figure->count; p++)
        for (size_t s = 0; s < figure->panels[p]->count && !figure->panels[p]->keyed; s++)
            if (*figure->panels[p]->series[s]->name && figure->panels[p]->series[s]->shape == WHIRL_LINE) return true;
    return false;
}

/// Returns the number of characters by which gnuplot shall narrow entries of the legend: it takes all letters for wide
/// ones, so that long names get too much room.
static size_t legend_excess(const whirl_figure *figure) {
    enum { LETTERS = 8, MAX_EXCESS = 1 };
    size_t longest = 0;
    for (size_t p = 0; p < figure->count; p++)
        for (size_t s = 0; s < figure->panels[p]->count; s++) {
            const size_t letters = figure_letters(figure->panels[p]->series[s]->name);
            if (!figure->panels[p]->keyed && letters > longest) longest = letters;
        }
    return longest / LETTERS < MAX_EXCESS ? longest / LETTERS : MAX_EXCESS;
}

/// Writes the figure's legend as a separate plot as wide as the figure.
static void write_legend(FILE *script, const whirl_figure *figure) {
    const size_t rows = figure_legend_rows(figure);
    if (rows == 0) return;
    fprintf(script,
            "\n# ---- legend\nset lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen 0.1\n"
            "set tmargin at screen 0.9\nset border 0\nunset tics\nunset xlabel\nset xrange [0:1]\nset yrange [0:1]\n"
            "set key at screen 0.52, screen 0.997*top center top horizontal maxrows %zu Left reverse samplen %s "
            "width -%zu font small_font\n",
            rows, has_lines(figure) ? "1.0" : "0.2", legend_excess(figure));
    write_entries(script, figure, figure->count);
    fputs(", NaN notitle\nunset key\nset border 31 linewidth 0.5 linecolor rgb '#303030'\n"
          "set tics scale 0.4 font small_font textcolor rgb '#000000'\nset xtics nomirror\nset ytics nomirror\n",
          script);
}

static void write_scale(FILE *script, const whirl_figure *figure, bool first) {
    if (!*figure->scale.label) return;
    if (!first) {
        fputs("unset colorbox\n", script);
        return;
    }
    const whirl_panel *panel = figure->panels[0], *last = figure->panels[figure->count - 1];
    fprintf(script, "set colorbox user origin screen %.5f, screen %.5f size screen %.5f, screen %.5f\nset cblabel ",
            1.0 - 1.85 / figure->width, last->bottom, 0.35 / figure->width, panel->top - last->bottom);
    put_text(script, figure->scale.label);
    fputc('\n', script);
}

static void write_panel(FILE *script, const whirl_figure *figure, size_t p, size_t *index) {
    const whirl_panel *panel = figure->panels[p];
    // Set margins, title and axes.
    fprintf(
        script,
        "\n# ---- panel %s\nset lmargin at screen %.5f\nset rmargin at screen %.5f\nset bmargin at screen %.5f*top\n"
        "set tmargin at screen %.5f*top\nunset label\n",
        panel->name, panel->left, panel->right, panel->bottom, panel->top);
    if (p == 0)
        fputs("if (show_title) { set label 1 title_text at screen 0.5, screen 0.5*(1 + top) center }\n", script);
    write_axis(script, &panel->x, 'x');
    write_axis(script, &panel->y, 'y');
    write_upright_label(script, figure, panel);
    // Write the letter and the title of the panel.
    if (panel->letter)
        fprintf(script, "set label 97 '(%c)' at graph 0, graph 1 right offset -1.2, 0.7\n", panel->letter);
    if (*panel->title) {
        fputs("set label 98 ", script);
        put_text(script, panel->title);
        fputs(" at graph 0.5, graph 1 center offset 0, 0.6 font small_font\n", script);
    }
    // Write its colour scale, texts and legend.
    write_scale(script, figure, p == 0);
    for (size_t s = 0; s < panel->count; s++)
        if (panel->series[s]->shape == WHIRL_TEXTS) write_texts(script, panel, panel->series[s]);
    if (panel->keyed)
        fputs("set key inside top right horizontal Left reverse samplen 1.2 width 1 font small_font\n", script);
    else
        fputs("unset key\n", script);
    size_t written = panel->keyed ? write_entries(script, figure, p) : 0;
    // Write one plot command with all series that have data.
    for (size_t s = 0; s < panel->count; s++) {
        if (!has_block(panel->series[s])) continue;
        fputs(written++ ? ", \\\n  " : "plot ", script);
        write_plot(script, panel->series[s], (*index)++);
    }
    fputs(written ? "\n" : "plot NaN notitle\n", script);
}

// ---------------------------------------------------------------- the whole

static void write_head(FILE *script, const whirl_figure *figure, const char *name, const char *data) {
    fprintf(script, "# %s: ", name);
    gnuplot_comment(script, figure->title);
    fprintf(script, "\n# Run in this folder to draw it again:  gnuplot %s.gp\n", name);
    fputs("# Journals want the title in the caption; with show_title = 1 it is in the picture, too.\nshow_title = 0\n",
          script);
    fputs("title_text = ", script);
    put_text(script, figure->title);
    fprintf(script,
            "\nname = '%s'\ndata = '%s'\nwidth_cm = %.2f\nheight_cm = %.2f\ndots_per_inch = 300\nfont_name = 'Sans'\n"
            "font_size = %.3g\nbase_font = sprintf('%%s,%%.3g', font_name, font_size)\n"
            "small_font = sprintf('%%s,%%.3g', font_name, 0.9*font_size)\n",
            name, data, figure->width, figure->height, figure->font);
    fputs("top = show_title ? 0.975 : 1 # share of the height that the panels have\n"
          "set encoding utf8\nset minussign\n"
          "set border 31 linewidth 0.5 linecolor rgb '#303030'\n"
          "set tics scale 0.4 font small_font textcolor rgb '#000000'\n"
          "set xtics nomirror\nset ytics nomirror\nunset key\n",
          script);
}

static void write_palette(FILE *script, const whirl_colour_scale *scale) {
    if (!*scale->label) return;
    fputs("set palette defined (", script);
    for (size_t i = 0; i < scale->count; i++) fprintf(script, "%s%zu '%s'", i ? ", " : "", i, scale->colours[i]);
    fprintf(script, ")\nset cbrange [%.17g:%.17g]\n", scale->low, scale->high);
    if (scale->logarithmic) fputs("set logscale cb 10\n", script);
    fputs("set cbtics (", script);
    for (size_t i = 0; i < scale->tick_count; i++) {
        fputs(i ? ", " : "", script);
        put_text(script, scale->tick_texts[i]);
        fprintf(script, " %.9g", scale->ticks[i]);
    }
    fputs(")\n", script);
}

void gnuplot_write_script(FILE *script, const whirl_figure *figure, const char *name, const char *data,
                          const char *formats) {
    size_t index = 0;
    write_head(script, figure, name, data);
    write_palette(script, &figure->scale);
    // Scale fonts, lines and points, as a point of Cairo is 1/96 inch.
    fprintf(script,
            "do for [format in '%s'] {\n"
            "if (format eq 'png') {\n"
            "  set terminal pngcairo enhanced background 'white' font base_font \\\n"
            "    size int(width_cm/2.54*dots_per_inch), int(height_cm/2.54*dots_per_inch) \\\n"
            "    fontscale dots_per_inch/96.0 linewidth dots_per_inch/96.0 pointscale dots_per_inch/96.0\n"
            "}\nif (format eq 'pdf') {\n"
            "  set terminal pdfcairo enhanced background 'white' font base_font \\\n"
            "    fontscale 0.75 linewidth 0.75 pointscale 0.75 size width_cm cm, height_cm cm\n"
            "}\nif (format eq 'svg') {\n"
            "  set terminal svg enhanced background 'white' font base_font \\\n"
            "    size int(width_cm/2.54*96), int(height_cm/2.54*96)\n"
            "}\n"
            "set output name.'.'.format\n"
            "set multiplot\n",
            formats);
    write_legend(script, figure);
    for (size_t p = 0; p < figure->count; p++) write_panel(script, figure, p, &index);
    fputs("unset multiplot\nunset output\n}\n", script);
}
