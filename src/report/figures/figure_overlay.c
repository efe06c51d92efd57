// Draws the series of one figure into another one, to compare two results.
#include "figure_build.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool overlay_is_coloured(const whirl_figure *figure) {
    for (size_t i = 0; i < figure->count; i++)
        for (size_t k = 0; k < figure->panels[i]->count; k++)
            if (figure->panels[i]->series[k]->shape == WHIRL_BOXES || figure->panels[i]->series[k]->shape == WHIRL_AREA)
                return true;
    return false;
}

static const whirl_panel *overlay_panel(const whirl_figure *figure, const char *name) {
    for (size_t i = 0; i < figure->count; i++)
        if (strcmp(figure->panels[i]->name, name) == 0) return figure->panels[i];
    return NULL;
}

/// Returns the main line of a panel, the thickest of its lines; NULL if a series has a name.
static const whirl_series *overlay_main_line(const whirl_panel *panel) {
    const whirl_series *found = NULL;
    for (size_t k = 0; k < panel->count; k++) {
        const whirl_series *own = panel->series[k];
        if (*own->name) return NULL;
        if (own->shape == WHIRL_LINE && (!found || own->size > found->size)) found = own;
    }
    return found;
}

/// Appends the word for a result ("measured") to the legend name of one of its series. A series without a name stays
/// unnamed, except the main line of a panel, whose name becomes the word.
static void overlay_name(whirl_series *series, bool main, const char *word) {
    const size_t used = strlen(series->name);
    if (used > 0 || main) snprintf(series->name + used, sizeof series->name - used, used > 0 ? ", %s" : "%s", word);
}

/// Widens an axis that has a range, so that it includes the range of another axis.
static void overlay_widen(whirl_axis *axis, const whirl_axis *by) {
    if (!isfinite(axis->low) || !isfinite(by->low) || !(axis->high > axis->low)) return;
    axis->low = fmin(axis->low, by->low);
    axis->high = fmax(axis->high, by->high);
}

static void overlay_series(whirl_figure *figure, whirl_panel *panel, const whirl_series *from, bool main,
                           const char *its) {
    whirl_series *to = panel_series(figure, panel, from->shape, from->colour, from->size);
    if (!to) return;
    to->opacity = from->opacity, to->mark = from->mark, to->side = from->side, to->movable = from->movable;
    to->dashed = true;
    memcpy(to->name, from->name, sizeof to->name);
    overlay_name(to, main, its);
    for (size_t i = 0; i < from->count; i++) {
        if (from->texts)
            series_add_text(figure, to, from->x[i], from->y[i], from->texts[i]);
        else if (from->y_to)
            series_add_to(figure, to, from->x[i], from->y[i], from->y_to[i]);
        else
            series_add(figure, to, from->x[i], from->y[i]);
    }
}

whirl_status figure_overlay(whirl_figure *figure, const whirl_figure *other, const char *own, const char *its) {
    // Reject maps: the colours of one would hide the other.
    if (overlay_is_coloured(figure) || overlay_is_coloured(other))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the figure %.80s has areas of colours, two of which cannot share one picture", figure->name);
    // Join panels of the same name.
    for (size_t i = 0; i < figure->count; i++) {
        whirl_panel *panel = figure->panels[i];
        const whirl_panel *from = overlay_panel(other, panel->name);
        const whirl_series *main = overlay_main_line(panel);
        // The figure's own series are named after it in the legend.
        for (size_t k = 0; k < panel->count; k++) overlay_name(panel->series[k], panel->series[k] == main, own);
        if (!from) continue;
        main = overlay_main_line(from);
        // Axes have to show the same quantities in the same units.
        const bool x = strcmp(panel->x.label, from->x.label) != 0;
        if (x || strcmp(panel->y.label, from->y.label) != 0)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "one result has the axis '%.80s' and the other '%.80s', expected the same: give both the "
                              "same units",
                              x ? panel->x.label : panel->y.label, x ? from->x.label : from->y.label);
        // Widen axes, and add the other figure's series.
        overlay_widen(&panel->x, &from->x);
        overlay_widen(&panel->y, &from->y);
        for (size_t k = 0; k < from->count; k++)
            overlay_series(figure, panel, from->series[k], from->series[k] == main, its);
    }
    // Describe the two kinds of lines.
    const size_t used = strlen(figure->caption);
    snprintf(figure->caption + used, sizeof figure->caption - used, " Full lines are %s, dashed ones %s.", own, its);
    return figure->failed ? whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure %.80s", figure->name) : whirl_ok();
}
