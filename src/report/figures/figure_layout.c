// Places the panels of a figure, and chooses the ranges of their axes.
#include <math.h>
#include <string.h>

#include "figure_build.h"

// Margins around a panel in cm: BARE left of its numbers; LABEL for the label of the vertical axis; RIGHT right of the
// panel; BELOW below a panel with numbers and label, APART below one without them; TITLE above a panel with a title.
static const double BARE = 0.45, LABEL = 0.62, RIGHT = 0.3, BELOW = 0.95, APART = 0.16, TITLE = 0.45;
/// Width in cm of the colour scale on the right.
static const double SCALE = 2.0;

double figure_number_width(const whirl_figure *figure) {
    size_t most = 1;
    for (size_t p = 0; p < figure->count; p++) {
        const whirl_axis *axis = &figure->panels[p]->y;
        for (size_t i = 0; axis->shown && i < axis->tick_count; i++)
            if (figure_letters(axis->tick_texts[i]) > most) most = figure_letters(axis->tick_texts[i]);
    }
    return 0.9 * figure_text_width(figure, most);
}

// ---------------------------------------------------------------- axes

/// Returns the range of all numbers along an axis.
static span layout_range(const whirl_panel *panel, bool upright) {
    span range = span_empty();
    for (size_t i = 0; i < panel->count; i++) {
        const whirl_series *series = panel->series[i];
        const double *from = upright ? series->y : series->x, *to = upright ? series->y_to : series->x_to;
        for (size_t k = 0; k < series->count; k++) {
            span_widen(&range, from[k]);
            if (to) span_widen(&range, to[k]);
        }
    }
    return range;
}

/// Returns the smallest number above 0 along an axis, at most `most`.
static double least_of(const whirl_panel *panel, bool upright, double most) {
    double least = most;
    for (size_t i = 0; i < panel->count; i++) {
        const double *at = upright ? panel->series[i]->y : panel->series[i]->x;
        for (size_t k = 0; k < panel->series[i]->count; k++)
            if (at[k] > 0.0) least = fmin(least, at[k]);
    }
    return least;
}

/// Returns the range of a logarithmic axis with a margin on both sides, as a share of its width.
static span around(span range, double margin) {
    const double ratio = pow(range.high / range.low, margin);
    return (span){range.low / ratio, range.high * ratio};
}

static void fit_axis(const whirl_panel *panel, whirl_axis *axis, bool upright, bool log) {
    const span all = layout_range(panel, upright);
    const bool open = !isfinite(axis->low) || !isfinite(axis->high);
    const double most = fmax(fabs(all.low), fabs(all.high));
    const bool may = axis->logarithmic || (axis->tick_count == 0 && !panel->equal);
    if (log && may && all.high > 0.0) {
        axis->logarithmic = true;
        if (open || !(axis->low > 0.0)) {
            const double top = axis->high > 0.0 ? axis->high : all.high;
            const span kept = {fmax(least_of(panel, upright, top), 1e-6 * top), top};
            axis_show(axis, kept.low < kept.high ? kept : (span){0.5 * top, 2.0 * top});
        }
        return;
    }
    if (open && axis->logarithmic && all.low > 0.0 && all.high > all.low)
        axis_show(axis, around(all, upright ? 0.06 : 0.0));
    else if (open)
        axis_show(axis, span_with_margin(all, 0.05, most > 0.0 ? 1e-7 * most : 1.0));
    if (!(axis->low > 0.0)) axis->logarithmic = false;
    const double wide = fmax(1.0, 1e-6 * fabs(axis->low)); // width of a range of one number
    if (!(axis->low < axis->high)) axis_show(axis, span_with_margin((span){axis->low, axis->low}, 0.0, wide));
}

/// Gives an axis without a valid range (for example with infinite numbers only) the range from 0 to 1, and makes a
/// logarithmic axis linear unless its range is positive.
static void bound_axis(whirl_axis *axis) {
    if (!(axis->low > 0.0)) axis->logarithmic = false;
    if (isfinite(axis->low) && isfinite(axis->high) && axis->low < axis->high) return;
    axis->logarithmic = false;
    axis_show(axis, (span){0.0, 1.0});
}

// ---------------------------------------------------------------- the legend

static bool is_new(const whirl_figure *figure, size_t p, size_t s) {
    const char *name = figure->panels[p]->series[s]->name;
    for (size_t i = 0; i <= p; i++)
        for (size_t k = 0; k < (i == p ? s : figure->panels[i]->count); k++)
            if (!figure->panels[i]->keyed && strcmp(figure->panels[i]->series[k]->name, name) == 0) return false;
    return true;
}

size_t figure_legend_rows(const whirl_figure *figure) {
    double longest = 0.0, count = 0.0;
    for (size_t p = 0; p < figure->count; p++)
        for (size_t s = 0; s < figure->panels[p]->count && !figure->panels[p]->keyed; s++) {
            if (!*figure->panels[p]->series[s]->name || !is_new(figure, p, s)) continue;
            longest = fmax(longest,
                           0.65 + 0.9 * figure_text_width(figure, figure_letters(figure->panels[p]->series[s]->name)));
            count++;
        }
    const double across = fmax(floor((figure->width - 0.4) / fmax(longest, 0.1)), 1.0);
    return (size_t)ceil(count / across);
}

// ---------------------------------------------------------------- places

/// Returns the end of the row of panels that begins with `first`.
static size_t row_end(const whirl_figure *figure, size_t first) {
    double width = 0.0;
    size_t end = first;
    while (end < figure->count && (end == first || width + figure->panels[end]->width <= 1.0 + 1e-9))
        width += figure->panels[end++]->width;
    return end;
}

/// Computes the margins in cm above and below a row of panels.
static double above_row(const whirl_figure *figure, size_t first, size_t end) {
    double above = 0.0;
    for (size_t i = first; i < end; i++)
        if (*figure->panels[i]->title || figure->panels[i]->letter) above = TITLE;
    return above;
}

static double below_row(const whirl_figure *figure, size_t first, size_t end) {
    double below = APART;
    for (size_t i = first; i < end; i++)
        if (figure->panels[i]->x.shown) below = fmax(below, BELOW + (*figure->panels[i]->x.label ? 0.0 : -0.35));
    return below;
}

static double row_height(const whirl_figure *figure, size_t first, size_t end) {
    double height = 0.0;
    for (size_t i = first; i < end; i++) height = fmax(height, figure->panels[i]->height);
    return height;
}

/// Returns the left margin of a panel, cm.
static double left_of(const whirl_figure *figure, const whirl_panel *panel) {
    const double label = *panel->y.label ? LABEL : 0.0;
    return panel->y.shown ? BARE + figure_number_width(figure) + label : BARE;
}

/// Returns the left margin of a panel, cm. Rows with the same number and widths of panels share their margins: in each
/// column the largest that one of its panels needs, so that the axes line up.
static double left_in_column(const whirl_figure *figure, size_t first, size_t end, size_t panel) {
    double left = 0.0;
    for (size_t other = 0, next; other < figure->count; other = next) {
        next = row_end(figure, other);
        bool alike = next - other == end - first;
        for (size_t i = 0; alike && i < end - first; i++)
            alike = fabs(figure->panels[other + i]->width - figure->panels[first + i]->width) < 1e-9;
        if (alike) left = fmax(left, left_of(figure, figure->panels[other + panel - first]));
    }
    return left;
}

/// Places the panels of a row; they share the width that numbers and labels leave.
static void place_row(whirl_figure *figure, size_t first, size_t end, double top) {
    const double wide = figure->width - (*figure->scale.label ? SCALE : 0.0);
    double shares = 0.0, inner = 0.0, left = 0.0;
    for (size_t i = first; i < end; i++) shares += figure->panels[i]->width;
    inner = shares * wide;
    for (size_t i = first; i < end; i++) inner -= left_in_column(figure, first, end, i) + RIGHT;
    for (size_t i = first; i < end; i++) {
        whirl_panel *panel = figure->panels[i];
        panel->left = (left + left_in_column(figure, first, end, i)) / figure->width;
        panel->right = panel->left + inner * panel->width / shares / figure->width;
        panel->top = 1.0 - top / figure->height;
        panel->bottom = 1.0 - (top + panel->height) / figure->height;
        left = panel->right * figure->width + RIGHT;
    }
}

/// Splits labels of vertical axes into two lines if they are longer than their panels are high.
static void break_label(const whirl_figure *figure, whirl_panel *panel) {
    const size_t letters = figure_letters(panel->y.label);
    char *gap = strchr(panel->y.label + strlen(panel->y.label) / 3, ' ');
    if (panel->height >= FIGURE_LOW_PANEL && gap && figure_text_width(figure, letters) > panel->height) *gap = '\n';
}

/// Adds ticks to the vertical (upright) or horizontal axes; their number depends on the length of the axis.
static void fill_ticks(whirl_figure *figure, bool upright) {
    for (size_t i = 0; i < figure->count; i++) {
        whirl_panel *panel = figure->panels[i];
        const double across = (panel->right - panel->left) * figure->width;
        if (upright)
            axis_fill_ticks(figure, &panel->y, (int)fmax(3.0, panel->height / 0.75));
        else
            axis_fill_ticks(figure, &panel->x, (int)fmax(3.0, across / 1.15));
    }
}

/// Widens one axis of a panel so that both axes have the same scale.
static void match_scales(const whirl_figure *figure, whirl_panel *panel) {
    const double across = (panel->right - panel->left) * figure->width, up = panel->height;
    const double x = (panel->x.high - panel->x.low) / across, y = (panel->y.high - panel->y.low) / up;
    whirl_axis *narrow = x < y ? &panel->x : &panel->y;
    const double middle = 0.5 * (narrow->low + narrow->high), half = 0.5 * fmax(x, y) * (x < y ? across : up);
    axis_show(narrow, (span){middle - half, middle + half});
}

/// Narrows the figure to its panels if each is alone in its row and narrower than the figure.
static void fit_width(whirl_figure *figure) {
    const double scale_width = *figure->scale.label ? SCALE : 0.0;
    double widest = 0.0;
    for (size_t first = 0, end; first < figure->count; first = end) {
        double shares = 0.0;
        end = row_end(figure, first);
        for (size_t i = first; i < end; i++) shares += figure->panels[i]->width;
        widest = fmax(widest, shares);
    }
    if (!(widest > 0.0 && widest < 1.0 - 1e-9)) return;
    figure->width = scale_width + widest * (figure->width - scale_width);
    for (size_t i = 0; i < figure->count; i++) figure->panels[i]->width /= widest;
}

static void fill_scale_ticks(whirl_figure *figure) {
    whirl_colour_scale *scale = &figure->scale;
    whirl_axis axis = {.low = scale->low, .high = scale->high, .logarithmic = scale->logarithmic};
    if (!*scale->label) return;
    if (!isfinite(axis.low) || !isfinite(axis.high)) axis = (whirl_axis){.low = 0.0, .high = 1.0};
    scale->low = axis.low;
    scale->high = axis.high;
    axis_fill_ticks(figure, &axis, (int)fmax(3.0, figure->height / 1.5));
    scale->tick_count = axis.tick_count;
    scale->ticks = axis.ticks;
    scale->tick_texts = axis.tick_texts;
}

void figure_finish(whirl_figure *figure, const char *log) {
    // Ranges of axes, and horizontal positions.
    fit_width(figure);
    for (size_t i = 0; i < figure->count; i++) {
        whirl_panel *panel = figure->panels[i];
        fit_axis(panel, &panel->x, false, log && strchr(log, 'x'));
        fit_axis(panel, &panel->y, true, log && strchr(log, 'y'));
        bound_axis(&panel->x);
        bound_axis(&panel->y);
        break_label(figure, panel);
    }
    fill_ticks(figure, true);
    // Height of the figure.
    const size_t rows = figure_legend_rows(figure);
    double height = 0.15 + 0.046 * figure->font * (double)rows;
    const double first_top = height;
    for (size_t first = 0, end; first < figure->count; first = end) {
        end = row_end(figure, first);
        height += above_row(figure, first, end) + row_height(figure, first, end) + below_row(figure, first, end);
    }
    figure->height = height;
    // Vertical positions, row by row.
    double top = first_top;
    for (size_t first = 0, end; first < figure->count; first = end) {
        end = row_end(figure, first);
        top += above_row(figure, first, end);
        place_row(figure, first, end, top);
        for (size_t i = first; i < end; i++)
            if (figure->panels[i]->equal) match_scales(figure, figure->panels[i]);
        top += row_height(figure, first, end) + below_row(figure, first, end);
    }
    // Vertical ticks depend on the heights, texts on everything else.
    fill_ticks(figure, false);
    fill_scale_ticks(figure);
    for (size_t i = 0; i < figure->count; i++) figure_place_texts(figure, figure->panels[i]);
}
