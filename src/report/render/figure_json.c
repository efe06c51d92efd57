// Writes a figure as JSON (docs/figures.md).
#include <jansson.h>
#include <string.h>

#include "document.h"
#include "whirl/engine/figure.h"
#include "whirl/status.h"

static const char *const shapes[] = {"dots", "line", "area", "bars", "boxes", "texts"};
static const char *const marks[] = {"disc", "ring", "square", "frame", "up", "down", "diamond", "cross"};
static const char *const sides[] = {"above", "below", "left", "right", "slanted", "beside"};

/// Puts a label; one with two lines becomes two texts.
static void put_label(bool *well, json_t *object, const char *label) {
    char first[sizeof((whirl_axis *)NULL)->label];
    snprintf(first, sizeof first, "%s", label);
    char *gap = strchr(first, '\n');
    if (gap) *gap = '\0';
    json_t *above = document_text(first), *below = document_text(gap ? gap + 1 : "");
    document_put(well, object, "label",
                 json_sprintf(gap ? "%s\n%s" : "%s%s", json_string_value(above), json_string_value(below)));
    json_decref(above);
    json_decref(below);
}

static void put_text(bool *well, json_t *object, const char *key, const char *text) {
    document_put(well, object, key, document_text(text));
}

static void put_numbers(bool *well, json_t *object, const char *key, const double *numbers, size_t count) {
    if (!numbers) return;
    json_t *array = json_array();
    for (size_t i = 0; i < count && *well; i++) document_append(well, array, document_number(numbers[i]));
    document_put(well, object, key, array);
}

static void put_texts(bool *well, json_t *object, const char *key, char *const *texts, size_t count) {
    if (!texts) return;
    json_t *array = json_array();
    for (size_t i = 0; i < count && *well; i++) document_append(well, array, document_text(texts[i]));
    document_put(well, object, key, array);
}

static json_t *axis_object(bool *well, const whirl_axis *axis) {
    json_t *object = json_object();
    put_label(well, object, axis->label);
    document_put(well, object, "low", document_number(axis->low));
    document_put(well, object, "high", document_number(axis->high));
    document_put(well, object, "log", json_boolean(axis->logarithmic));
    document_put(well, object, "shown", json_boolean(axis->shown));
    if (axis->tick_count > 0) put_numbers(well, object, "ticks", axis->ticks, axis->tick_count);
    if (axis->tick_count > 0) put_texts(well, object, "tick_texts", axis->tick_texts, axis->tick_count);
    return object;
}

static json_t *series_object(bool *well, const whirl_series *series) {
    json_t *object = json_object();
    put_text(well, object, "shape", shapes[series->shape]);
    put_text(well, object, "name", series->name);
    put_text(well, object, "colour", series->colour);
    document_put(well, object, "opacity", document_number(series->opacity));
    document_put(well, object, "size", document_number(series->size));
    if (series->shape == WHIRL_DOTS) put_text(well, object, "mark", marks[series->mark]);
    if (series->shape == WHIRL_LINE) document_put(well, object, "dashed", json_boolean(series->dashed));
    if (series->shape == WHIRL_TEXTS) put_text(well, object, "side", sides[series->side]);
    put_numbers(well, object, "x", series->count ? series->x : NULL, series->count);
    put_numbers(well, object, "y", series->count ? series->y : NULL, series->count);
    put_numbers(well, object, "x_to", series->x_to, series->count);
    put_numbers(well, object, "y_to", series->y_to, series->count);
    put_numbers(well, object, "values", series->values, series->count);
    put_texts(well, object, "texts", series->texts, series->count);
    return object;
}

static json_t *spots_array(bool *well, const whirl_panel *panel) {
    json_t *array = json_array();
    for (size_t i = 0; i < panel->spot_count && *well; i++) {
        const whirl_spot *own = &panel->spots[i];
        const double box[] = {own->x, own->x_to, own->y, own->y_to};
        json_t *object = json_object();
        put_text(well, object, "station", own->station);
        put_numbers(well, object, "box", box, 4);
        document_append(well, array, object);
    }
    return array;
}

static json_t *panel_object(bool *well, const whirl_panel *panel) {
    json_t *object = json_object(), *series = json_array();
    const char letter[2] = {panel->letter, '\0'};
    put_text(well, object, "name", panel->name);
    put_text(well, object, "title", panel->title);
    put_text(well, object, "letter", letter);
    const double box[] = {panel->left, panel->right, panel->bottom, panel->top};
    put_numbers(well, object, "box", box, 4);
    document_put(well, object, "equal", json_boolean(panel->equal));
    document_put(well, object, "legend_inside", json_boolean(panel->keyed));
    document_put(well, object, "x", axis_object(well, &panel->x));
    document_put(well, object, "y", axis_object(well, &panel->y));
    for (size_t s = 0; s < panel->count && *well; s++)
        document_append(well, series, series_object(well, panel->series[s]));
    document_put(well, object, "series", series);
    if (panel->spot_count > 0) document_put(well, object, "spots", spots_array(well, panel));
    return object;
}

static json_t *scale_object(bool *well, const whirl_colour_scale *scale) {
    json_t *object = json_object(), *colours = json_array();
    put_text(well, object, "label", scale->label);
    document_put(well, object, "low", document_number(scale->low));
    document_put(well, object, "high", document_number(scale->high));
    document_put(well, object, "log", json_boolean(scale->logarithmic));
    for (size_t i = 0; i < scale->count && *well; i++) document_append(well, colours, document_text(scale->colours[i]));
    document_put(well, object, "colours", colours);
    if (scale->tick_count > 0) put_numbers(well, object, "ticks", scale->ticks, scale->tick_count);
    if (scale->tick_count > 0) put_texts(well, object, "tick_texts", scale->tick_texts, scale->tick_count);
    return object;
}

whirl_status whirl_figure_write_json(const whirl_figure *figure, FILE *stream) {
    json_t *object = json_object(), *panels = json_array();
    bool well = object && panels;
    document_put(&well, object, "whirl_figure", json_integer(1));
    put_text(&well, object, "name", figure->name);
    put_text(&well, object, "title", figure->title);
    put_text(&well, object, "caption", figure->caption);
    document_put(&well, object, "width_cm", document_number(figure->width));
    document_put(&well, object, "height_cm", document_number(figure->height));
    document_put(&well, object, "font_pt", document_number(figure->font));
    for (size_t p = 0; p < figure->count && well; p++)
        document_append(&well, panels, panel_object(&well, figure->panels[p]));
    document_put(&well, object, "panels", panels);
    if (*figure->scale.label) document_put(&well, object, "scale", scale_object(&well, &figure->scale));
    const bool made = well, written = document_write(made, object, stream) && fputc('\n', stream) != EOF;
    if (!made) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure %.100s", figure->name);
    return written ? whirl_ok() : whirl_fail(WHIRL_IO_ERROR, "the figure %.100s was not written", figure->name);
}
