/// Parameters of the points of a batch, and the fields of their values.
#ifndef STUDY_BATCH_POINTS_H
#define STUDY_BATCH_POINTS_H

#include <stddef.h>

#include "whirl/engine/study.h"

/// Chooses the machine of a point in a copy of its batch, by the point's index: its second and third parameter, its
/// sample or its record.
void batch_choose(whirl_batch *own, size_t index);

/// Adds the fields of the second and third parameters' values, "map/second" and "map/third", to a batch's layout, and
/// for a refined map the field "map/width". WHIRL_BAD_INPUT if it has too many fields.
whirl_status map_add_field(const whirl_batch *batch, whirl_layout *layout);

/// Notes these values in the block of a point, by its index in the batch.
void map_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block);

/// Adds the fields "tolerances/..." of a study of tolerances. WHIRL_BAD_INPUT if it has too many fields.
whirl_status sample_add_fields(const whirl_batch *batch, whirl_layout *layout);

/// Notes sample, machine and parameters of a point, by its index in the batch, in its block.
void sample_note(const whirl_batch *batch, size_t point, const whirl_layout *layout, double *block);

#endif
