// What refinement notes of a point in its block.
#include <stdio.h>

#include "passes.h"

static const struct {
    const char *name, *unit, *meaning;
} fields[REFINE_FIELDS] = {
    [REFINE_ROUNDS] = {"refine/rounds", "1", "rounds of refinement, 0 for a point that was not in doubt or too dear"},
    [REFINE_SPENT] = {"refine/revolutions", "revolution",
                      "spent on refining, second tolerance included; those at n times the study's steps count n times"},
    [REFINE_TRANSIENT] = {"refine/transient", "revolution", "transient of the motion that the numbers are of"},
    [REFINE_WATCH] = {"refine/watch", "revolution", "watched revolutions of that motion"},
    [REFINE_STEPS] = {"refine/steps_per_revolution", "1", "its steps a revolution"},
    [REFINE_RTOL] = {"refine/rtol", "1", "its relative tolerance, of adaptive methods"},
    [REFINE_ATOL] = {"refine/atol", "1", "its absolute tolerance, of adaptive methods"},
};

whirl_status refine_add_fields(whirl_layout *layout) {
    if (layout->field_count + REFINE_FIELDS > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses and refinement have more than %d fields",
                          WHIRL_MAX_FIELDS);
    for (int i = 0; i < REFINE_FIELDS; i++) {
        whirl_field *field = &layout->fields[layout->field_count++];
        *field = (whirl_field){.unit = fields[i].unit,
                               .meaning = fields[i].meaning,
                               .extent = WHIRL_PER_POINT,
                               .rows = 1,
                               .columns = 1,
                               .repeat = 1,
                               .offset = layout->size++};
        snprintf(field->name, sizeof field->name, "%s", fields[i].name);
    }
    return whirl_ok();
}

double *refine_noted(const whirl_layout *layout, double *block) {
    const whirl_field *first = whirl_layout_field(layout, fields[REFINE_ROUNDS].name);
    return first ? block + first->offset : NULL;
}

void refine_note(const whirl_layout *layout, double *block, const pass *p, double spent) {
    double *numbers = refine_noted(layout, block);
    if (!numbers) return;
    numbers[REFINE_ROUNDS] = p->round;
    numbers[REFINE_SPENT] = spent;
    numbers[REFINE_TRANSIENT] = p->record.transient;
    numbers[REFINE_WATCH] = whirl_record_watch(&p->record);
    numbers[REFINE_STEPS] = p->integrate.steps_per_revolution;
    numbers[REFINE_RTOL] = p->integrate.rtol;
    numbers[REFINE_ATOL] = p->integrate.atol;
}

double refine_spent(const whirl_layout *layout, const double *block) {
    const whirl_field *field = whirl_layout_field(layout, fields[REFINE_SPENT].name);
    return field ? block[field->offset] : 0.0;
}

void refine_add_spent(const whirl_layout *layout, double *block, double revolutions) {
    double *numbers = refine_noted(layout, block);
    if (numbers) numbers[REFINE_SPENT] += revolutions;
}
