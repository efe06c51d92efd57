// The points of a batch, which may lie in a plane of two parameters. The second one of a map stands in the blocks:
// files, CSV and JSON have it as they have all fields.
#include <math.h>

#include "passes.h"

whirl_status whirl_study_machine(const whirl_study *study, const whirl_batch *batch, size_t point,
                                 whirl_machine *machine) {
    whirl_batch own = *batch;
    const size_t index = batch->starts > 1 ? point % batch->count : point;
    const double value = batch->values ? batch->values[index] : (double)NAN;
    // Motions from neighbours begin from a state of their own.
    if (batch->starts > 1) own.start = point / batch->count < batch->starts ? point / batch->count : 0;
    if (batch->second_values) own.second_value = batch->second_values[index];
    return study->machine(study->family, &own, value, machine);
}

static const char *const second_field = "map/second";

whirl_status map_add_field(const whirl_batch *batch, whirl_layout *layout) {
    if (!batch->second_values) return whirl_ok();
    if (layout->field_count + 1 >= WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS - 2);
    study_add_field(layout, second_field, "1", "value of the second parameter, in SI");
    if (batch->refine > 0)
        study_add_field(layout, MAP_WIDTH, "1",
                        "points of the grid along both axes, from this one on, that it stands for: more than 1 where a "
                        "square was not divided");
    return whirl_ok();
}

void map_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block) {
    const whirl_field *field = whirl_layout_field(layout, second_field);
    const whirl_field *width = whirl_layout_field(layout, MAP_WIDTH);
    if (field && batch->second_values) block[field->offset] = batch->second_values[point];
    if (width) block[width->offset] = 1.0; // what it stands for besides is known in the end
}
