// Fields that refinement notes in a point's block: rounds, cost, and the options that an advice may change.
#include <stdio.h>

#include "added_field.h"
#include "pass.h"
#include "refine_fields.h"

bool refine_option(size_t index, refined_option *option) {
    const refined_option all[] = {{whirl_record_members(), offsetof(pass, record), "revolution"},
                                  {whirl_integrate_members(), offsetof(pass, integrate), "1"}};
    for (size_t t = 0; t < sizeof all / sizeof *all; t++)
        for (const whirl_member *member = all[t].member; member->part; member++) {
            if (!member->refined || index-- > 0) continue;
            *option = (refined_option){member, all[t].offset, all[t].unit};
            return true;
        }
    return false;
}

void study_add_field(whirl_layout *layout, const char *name, const char *unit, const char *meaning) {
    whirl_field *field = &layout->fields[layout->field_count++];
    *field = (whirl_field){.unit = unit,
                           .meaning = meaning,
                           .extent = WHIRL_PER_POINT,
                           .rows = 1,
                           .columns = 1,
                           .repeat = 1,
                           .offset = layout->size++};
    snprintf(field->name, sizeof field->name, "%s", name);
}

whirl_status refine_add_fields(whirl_layout *layout) {
    refined_option option;
    size_t count = 0;
    while (refine_option(count, &option)) count++;
    if (layout->field_count + REFINE_OPTIONS + count > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses and refinement have more than %d fields",
                          WHIRL_MAX_FIELDS);
    study_add_field(layout, WHIRL_FIELD_REFINE_ROUNDS, "1",
                    "rounds of refinement, 0 for a point that was not in doubt or too dear");
    study_add_field(
        layout, WHIRL_FIELD_REFINE_REVOLUTIONS, "revolution",
        "revolutions spent on refining, second tolerance included; those at n times the study's steps count n times");
    for (size_t i = 0; refine_option(i, &option); i++) {
        char name[WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "refine/%.50s", option.member->name);
        study_add_field(layout, name, option.unit, option.member->key.meaning);
    }
    return whirl_ok();
}

double *refine_noted(const whirl_layout *layout, double *block) {
    const whirl_field *first = whirl_layout_field(layout, WHIRL_FIELD_REFINE_ROUNDS);
    return first ? block + first->offset : NULL;
}

void refine_note(const whirl_layout *layout, double *block, const pass *p, double spent) {
    double *numbers = refine_noted(layout, block);
    refined_option option;
    pass done = *p;
    if (!numbers) return;
    done.record.watch = whirl_record_watch(&p->record);
    numbers[REFINE_ROUNDS] = p->round;
    numbers[REFINE_SPENT] = spent;
    for (size_t i = 0; refine_option(i, &option); i++)
        numbers[REFINE_OPTIONS + i] = whirl_member_number(option.member, (const char *)&done + option.offset);
}

void refine_recall(const double *numbers, pass *p) {
    refined_option option;
    for (size_t i = 0; refine_option(i, &option); i++)
        whirl_member_set(option.member, (char *)p + option.offset, numbers[REFINE_OPTIONS + i]);
}

double refine_spent(const whirl_layout *layout, const double *block) {
    const whirl_field *field = whirl_layout_field(layout, WHIRL_FIELD_REFINE_REVOLUTIONS);
    return field ? block[field->offset] : 0.0;
}

void refine_add_spent(const whirl_layout *layout, double *block, double revolutions) {
    double *numbers = refine_noted(layout, block);
    if (numbers) numbers[REFINE_SPENT] += revolutions;
}
