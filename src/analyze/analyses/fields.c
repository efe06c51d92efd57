// Where the numbers of a field lie in the block of a point.
#include <string.h>

#include "analysis.h"

const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name) {
    for (size_t f = 0; f < layout->field_count; f++) {
        if (strcmp(layout->fields[f].name, name) == 0) return &layout->fields[f];
    }
    return NULL;
}

double *view_numbers(const block_view *view, size_t field, size_t which) {
    const whirl_field *f = view->fields[field];
    return f && which < f->repeat ? view->block + f->offset + which * f->rows * f->columns : NULL;
}
