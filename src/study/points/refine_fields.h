/// Fields of the cost and the options of a point's refinement, in blocks of points.
#ifndef STUDY_REFINE_FIELDS_H
#define STUDY_REFINE_FIELDS_H

#include <stdbool.h>
#include <stddef.h>

#include "pass.h"
#include "whirl/engine/study.h"

/// Returns true if doubtful points are computed again.
static inline bool study_is_refined(const whirl_study *study) {
    return study->refine.revolutions > 0.0 || study->refine.seconds > 0.0;
}

/// The fields "refine/...", in this order; from REFINE_OPTIONS on, one for every option of refine_option.
enum { REFINE_ROUNDS, REFINE_SPENT, REFINE_OPTIONS };

/// An option that an advice may change, the offset of its struct in a pass, and the unit of its field.
typedef struct refined_option {
    const whirl_member *member;
    size_t offset;
    const char *unit;
} refined_option;

/// Writes option number `index`, from 0; false past the last.
bool refine_option(size_t index, refined_option *option);

/// Returns the refinement's numbers in a block, NULL if the layout has none.
double *refine_noted(const whirl_layout *layout, double *block);

/// Sets a pass's options to those noted in `numbers` (refine_noted).
void refine_recall(const double *numbers, pass *pass);

/// Adds the fields "refine/..." to the layout of a table. WHIRL_BAD_INPUT if it has too many.
whirl_status refine_add_fields(whirl_layout *layout);

/// Notes the options of a finished point in its block, if it has such fields; `spent` is its cost so far.
void refine_note(const whirl_layout *layout, double *block, const pass *pass, double spent);

/// refine_spent returns the cost of refining a point so far, in revolutions, 0 if nothing was noted; refine_add_spent
/// adds to it.
double refine_spent(const whirl_layout *layout, const double *block);
void refine_add_spent(const whirl_layout *layout, double *block, double revolutions);

#endif
