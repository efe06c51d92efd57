// Where the numbers of a field lie in the block of a point.
#include <string.h>

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
