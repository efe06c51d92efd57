// Fields of the numbers that are differentiated by parameters.
#include "derived_fields.h"

#include "added_field.h"
#include "spread_usual.h"

/// Finds the place of a chosen number; false if the layout does not have it.
static bool derived_find(const whirl_system *system, const whirl_layout *layout, const whirl_spread_of *of,
                         whirl_spread_at *at) {
    const char *names[WHIRL_MAX_PROBES];
    for (size_t i = 0; i < system->probe_count; i++) names[i] = system->probes[i].name;
    return !whirl_spread_find(of, layout, names, system->probe_count, NULL, 0, at);
}

size_t derived_list(const whirl_derivatives *derivatives, const whirl_system *system, const whirl_layout *layout,
                    whirl_spread_at numbers[WHIRL_MAX_DERIVED]) {
    // Take the chosen numbers that the layout has.
    size_t count = 0;
    for (size_t i = 0; i < derivatives->number_count && count < WHIRL_MAX_DERIVED; i++)
        count += derived_find(system, layout, &derivatives->numbers[i], &numbers[count]);
    // Without any choice, take the usual ones.
    whirl_spread_of of;
    size_t which;
    for (size_t i = 0;
         derivatives->number_count == 0 && count < WHIRL_MAX_DERIVED && spread_usual(layout, true, i, &of, &which);
         i++) {
        if (which < system->probe_count && whirl_layout_field(layout, of.field)->extent == WHIRL_PER_STATION)
            snprintf(of.at, sizeof of.at, "%s", system->probes[which].name);
        count += derived_find(system, layout, &of, &numbers[count]);
    }
    return count;
}

whirl_status derived_add_fields(const whirl_batch *batch, const whirl_system *system, whirl_layout *layout) {
    whirl_spread_at numbers[WHIRL_MAX_DERIVED];
    if (!batch->derivatives) return whirl_ok();
    const size_t parameters = batch->derivatives->parameter_count;
    const size_t count = derived_list(batch->derivatives, system, layout, numbers);
    if (count == 0) return whirl_ok();
    if (layout->field_count + 3 > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS - 3);
    study_add_field(layout, WHIRL_FIELD_SENSITIVITY_PARAMETERS, "1", "values of the parameters, in their order, in SI");
    layout->fields[layout->field_count - 1].rows = parameters;
    study_add_field(layout, WHIRL_FIELD_SENSITIVITY_NUMBERS, "1",
                    "numbers that are differentiated, in their order, in SI");
    layout->fields[layout->field_count - 1].rows = count;
    study_add_field(layout, WHIRL_FIELD_SENSITIVITY_SLOPES, "1",
                    "slope, error (of each number by each parameter in turn, in SI)");
    whirl_field *slopes = &layout->fields[layout->field_count - 1];
    slopes->rows = count * parameters;
    slopes->columns = 2;
    // Each field was added with one number; leave room for all of them.
    layout->fields[layout->field_count - 2].offset += parameters - 1;
    slopes->offset += parameters - 1 + count - 1;
    layout->size += parameters - 1 + count - 1 + 2 * count * parameters - 1;
    return whirl_ok();
}
