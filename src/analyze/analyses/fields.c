// Places of fields in the block of a point.
#include <string.h>

#include <math.h>

#include "analysis.h"

const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name) {
    for (size_t f = 0; f < layout->field_count; f++) {
        if (strcmp(layout->fields[f].name, name) == 0) return &layout->fields[f];
    }
    return NULL;
}

size_t rows_per_coordinate(const block_shape *shape) {
    return shape->dimension;
}

size_t rows_of_axial(const block_shape *shape) {
    return shape->axial ? 1 : 0;
}

size_t rows_of_twist(const block_shape *shape) {
    return shape->also_twists ? 1 : 0;
}

void probe_bounds(const whirl_probe *probe, const double *low, const double *high, size_t axis, double out[2]) {
    // A station that a gear turns the other way has a unit below 0.
    const double ends[2] = {whirl_probe_value(probe, low, axis), whirl_probe_value(probe, high, axis)};
    out[0] = ends[0] <= ends[1] ? ends[0] : ends[1];
    out[1] = ends[0] <= ends[1] ? ends[1] : ends[0];
}

size_t rows_of_longest_orbit(const block_shape *shape) {
    return (size_t)shape->options->trace.longest;
}

block_view view_of(const analysis_plan *plan, const whirl_layout *layout, double *block) {
    block_view view = {.block = block};
    for (size_t f = 0; f < plan->field_count; f++) view.fields[f] = whirl_layout_field(layout, plan->fields[f].name);
    return view;
}

double *view_numbers(const block_view *view, size_t field, size_t which) {
    const whirl_field *f = view->fields[field];
    return f && which < f->repeat ? view->block + f->offset + which * f->rows * f->columns : NULL;
}

void fill_seen(const whirl_record *record, size_t probe, size_t count, double *seen) {
    const whirl_probe *own = &record->probes[probe];
    const size_t all = record->sample_count, turn = record->samples_per_revolution;
    for (size_t axis = 0; axis < 2; axis++, seen += count) {
        const double *last = record->waveform + (2 * probe + axis + 1) * all - count;
        memcpy(seen, last, count * sizeof *seen);
        for (size_t j = 0; j < count && own->runout_count > 0; j++)
            seen[j] += whirl_probe_runout(own, axis, (double)((all - count + j + 1) % turn) / (double)turn);
    }
}

void shape_peak_note(shape_peak *peak, const double *x) {
    const double size = hypot(x[0], x[1]);
    if (size > (1.0 + 1e-9) * peak->size) *peak = (shape_peak){size, x[0] / size, x[1] / size};
}

/// Writes the motion Re(X exp(i w t)), x = [Re X, Im X], as out[0] cos(w t) + out[1] sin(w t), divided by the size of
/// the peak; t = 0 is the instant of the peak.
void shape_peak_write(const shape_peak *peak, const double *x, double *out) {
    out[0] = (x[0] * peak->cos + x[1] * peak->sin) / peak->size;
    out[1] = -(x[1] * peak->cos - x[0] * peak->sin) / peak->size;
}

void fill_shape(const whirl_system *system, const double *v, size_t row, size_t field, const block_view *view) {
    shape_peak peak = {0.0, 1.0, 0.0};
    for (size_t p = 0; p < 2 * system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p / 2];
        shape_peak_note(&peak, v + 2 * (p % 2 ? probe->y : probe->x));
    }
    for (size_t p = 0; p < 2 * system->probe_count && peak.size > 0.0; p++) {
        const whirl_probe *probe = &system->probes[p / 2];
        double *out = view_numbers(view, field, p / 2) + 4 * row + 2 * (p % 2);
        if (whirl_probe_sees(probe, p % 2))
            shape_peak_write(&peak, v + 2 * (p % 2 ? probe->y : probe->x), out);
        else
            out[0] = out[1] = 0.0;
    }
}

bool whirl_field_column_names(const whirl_field *field, char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE]) {
    if (field->columns < 2 || field->columns > WHIRL_MAX_COLUMNS) return false;
    const char *from = field->meaning;
    for (size_t i = 0; i < field->columns; i++) {
        const size_t length = strcspn(from, ",(");
        size_t end = length;
        while (end > 0 && from[end - 1] == ' ') end--;
        if (end == 0 || end >= WHIRL_NAME_SIZE) return false;
        memcpy(names[i], from, end);
        names[i][end] = '\0';
        from += length;
        // A comma must follow every name but the last.
        if ((*from == ',') != (i + 1 < field->columns)) return false;
        if (*from == ',') from += 1 + strspn(from + 1, " ");
    }
    return true;
}

const char *whirl_column_unit(const whirl_field *field, size_t column) {
    static const struct {
        const char *field, *column, *unit;
    } own[] = {{"length", "order", "1"},    {"length", "vx", "length/radian"}, {"length", "vy", "length/radian"},
               {"1", "value", "parameter"}, {"1", "speed", "rad/s"},           {"1", "frequency", "rad/s"}};
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    if (!whirl_field_column_names(field, names) || column >= field->columns) return field->unit;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (strcmp(field->unit, own[i].field) == 0 && strcmp(names[column], own[i].column) == 0) return own[i].unit;
    return field->unit;
}

whirl_counting whirl_field_counting(const whirl_field *field) {
    return strstr(field->meaning, "0-p amplitude") ? WHIRL_AMPLITUDE
           : strstr(field->meaning, "0-p")         ? WHIRL_ZERO_TO_PEAK
                                                   : WHIRL_FROM_CENTRE;
}
