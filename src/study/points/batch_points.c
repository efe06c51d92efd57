// Parameter values of a batch's points, which may form a plane of two parameters, or several planes over a third. Maps
// store them in the blocks, so that files, CSV and JSON have them as fields.
#include <math.h>
#include <stdlib.h>

#include "added_field.h"
#include "batch_points.h"
#include "whirl/engine/study.h"

void batch_choose(whirl_batch *own, size_t index) {
    if (own->second_values) own->second_value = own->second_values[index];
    if (own->third_values) own->third_value = own->third_values[index];
    if (own->tolerances.samples > 0) own->sampled = 1 + (own->row > 0 ? index / own->row : 0);
    if (own->dataset) own->sampled = 1 + index;
}

whirl_status whirl_study_machine(const whirl_study *study, const whirl_batch *batch, size_t point,
                                 whirl_machine *machine) {
    whirl_batch own = *batch;
    whirl_placed *placed;
    const size_t index = batch->starts > 1 ? point % batch->count : point;
    const double value = batch->values ? batch->values[index] : (double)NAN;
    // Starts from neighbours have a state of their own.
    if (batch->starts > 1) own.start = point / batch->count < batch->starts ? point / batch->count : 0;
    batch_choose(&own, index);
    whirl_status status = whirl_study_place(study, &own, &placed);
    if (status.code == WHIRL_OK) status = study->machine(study->family, &own, value, machine);
    free(placed);
    return status;
}

const double *whirl_batch_values(const whirl_batch *batch, size_t axis, const char **name, size_t *count) {
    const bool found = whirl_analysis_kind(batch->analyses)->found;
    const double *const values[] = {found ? batch->bounds : batch->values, batch->second_values, batch->third_values};
    const char *const names[] = {batch->parameter, batch->second, batch->third};
    if (axis >= sizeof values / sizeof *values || !values[axis]) return NULL;
    *name = names[axis];
    *count = found ? 2 : batch->count;
    return values[axis];
}

whirl_status map_add_field(const whirl_batch *batch, whirl_layout *layout) {
    if (!batch->second_values) return whirl_ok();
    if (layout->field_count + 2 >= WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS - 3);
    study_add_field(layout, WHIRL_FIELD_MAP_SECOND, "1", "value of the second parameter, in SI");
    if (batch->third_values) study_add_field(layout, WHIRL_FIELD_MAP_THIRD, "1", "value of the third parameter, in SI");
    if (batch->refine > 0)
        study_add_field(
            layout, WHIRL_FIELD_MAP_WIDTH, "1",
            "number of grid points along each axis, from this one on, that this point represents: more than 1 where a "
            "square was not divided");
    return whirl_ok();
}

void map_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block) {
    const whirl_field *field = whirl_layout_field(layout, WHIRL_FIELD_MAP_SECOND);
    const whirl_field *third = whirl_layout_field(layout, WHIRL_FIELD_MAP_THIRD);
    const whirl_field *width = whirl_layout_field(layout, WHIRL_FIELD_MAP_WIDTH);
    if (field && batch->second_values) block[field->offset] = batch->second_values[point];
    if (third && batch->third_values) block[third->offset] = batch->third_values[point];
    if (width) block[width->offset] = 1.0; // a refined map's final widths are noted at the end
}

whirl_status sample_add_fields(const whirl_batch *batch, whirl_layout *layout) {
    const size_t count = (size_t)batch->tolerances.parameters;
    if (batch->tolerances.samples == 0) return whirl_ok();
    if (layout->field_count + 3 > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS - 3);
    study_add_field(layout, WHIRL_FIELD_TOLERANCES_SAMPLE, "1", "number of the sample, from 1");
    study_add_field(layout, WHIRL_FIELD_TOLERANCES_MACHINE, "1",
                    "0: the sample (A), 1: another one for indices (B), above: A with one parameter of B");
    study_add_field(layout, WHIRL_FIELD_TOLERANCES_VALUES, "1",
                    "values of the parameters with tolerances, in their order, in SI");
    layout->fields[layout->field_count - 1].rows = count;
    layout->size += count - 1;
    return whirl_ok();
}

void sample_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block) {
    const whirl_field *sample = whirl_layout_field(layout, WHIRL_FIELD_TOLERANCES_SAMPLE);
    const whirl_field *machine = whirl_layout_field(layout, WHIRL_FIELD_TOLERANCES_MACHINE);
    const whirl_field *values = whirl_layout_field(layout, WHIRL_FIELD_TOLERANCES_VALUES);
    if (batch->tolerances.samples == 0 || !sample || !machine || !values) return;
    const size_t index = batch->row > 0 ? point / batch->row : 0, each = whirl_tolerance_each(&batch->tolerances);
    block[sample->offset] = (double)(index / each + 1);
    block[machine->offset] = (double)(index % each);
    whirl_tolerance_values(&batch->tolerances, batch->tolerated, index, block + values->offset);
}
