// Datasets of one point after the other: what writing and reading have in common.
#include "items.h"

#include <stdlib.h>
#include <string.h>

void column_lay(column *of, shape points, const size_t *dimensions, int rank, size_t element) {
    *of = (column){.dataset = H5I_INVALID_HID, .type = H5I_INVALID_HID, .rank = rank, .width = points.sizes[1]};
    of->size = element;
    for (int i = 0; i < rank; ++i) of->dimensions[i] = dimensions[i];
    for (int i = points.rank; i < rank; ++i) of->size *= dimensions[i];
}

bool column_buffer(column *of, const hsize_t *chunk) {
    const bool pieces = of->width > 1 && chunk[1] < of->width;
    of->most = (size_t)(pieces ? chunk[1] : chunk[0] * of->width);
    if (of->most == 0) of->most = 1;
    of->buffer = malloc(of->most * of->size + 1);
    return of->buffer;
}

size_t column_room(const column *of) {
    const size_t left = of->width - of->done % of->width;
    return of->most < of->width && left < of->most ? left : of->most;
}

void column_box(const column *of, size_t points, hsize_t *first, hsize_t *count) {
    for (int i = 0; i < of->rank; ++i) {
        first[i] = 0;
        count[i] = of->dimensions[i];
    }
    first[0] = of->done / of->width;
    count[0] = points < of->width ? 1 : points / of->width;
    if (of->width == 1) return;
    first[1] = of->done % of->width;
    count[1] = points < of->width ? points : of->width;
}
