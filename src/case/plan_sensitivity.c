// Derivatives of the numbers of every point by parameters of the case.
#include "plan_sensitivity.h"

#include <string.h>

#include "plan_asked.h"
#include "plan_batches.h"
#include "plan_names.h"
#include "problem.h"
#include "tree.h"

void sensitivity_read(case_reader *reader, plan_parts *parts) {
    // Find the part; without it nothing is differentiated.
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    sensitivity_parts *own = &parts->sensitivity;
    const setting *given = settings_find(&parts->study, "sensitivity");
    plan_read_part(reader, &parts->study, "sensitivity", &schema_sensitivity, &own->keys);
    if (!given) {
        own->keys.place = NULL;
        return;
    }
    // Read the names of the parameters.
    const setting *names = settings_find(&own->keys, "parameters");
    const bool list = names && names->place->kind == NODE_LIST;
    if (names && (!list || names->place->count < 1 || names->place->count > WHIRL_MAX_SENSITIVITIES))
        problem_at(reader->problems, names->place, "is %s, expected a list of 1 to %d names of parameters",
                   !list                     ? node_shown(names->place, shown)
                   : names->place->count < 1 ? "an empty list"
                                             : "a longer list",
                   WHIRL_MAX_SENSITIVITIES);
    const parameter_table *all = reader->parameters;
    for (const file_node *one = list ? names->place->first : NULL; one && own->count < WHIRL_MAX_SENSITIVITIES;
         one = one->next) {
        const char *name = one->kind == NODE_TEXT ? one->text : "";
        const size_t index = parameters_find(all, name);
        if (index == all->count) {
            describe_names(name, all->names, all->count, advice);
            problem_at(reader->problems, one, "%s is no parameter, %s", node_shown(one, shown), advice);
        } else if (all->items[index].value.expression) {
            problem_at(reader->problems, one,
                       "is = %s in the case, expected a parameter with a number of its own, not an expression",
                       text_shown(all->items[index].value.expression, shown));
        } else {
            own->places[own->count] = one;
            own->parameters[own->count++] = &all->items[index];
        }
    }
    asked_read(reader, settings_find(&own->keys, "of"), &schema_number, &own->asked);
}

/// Returns true for a batch whose points have derivatives.
static bool sensitivity_fits(const whirl_batch *batch) {
    return batch->role == WHIRL_ROLE_POINT || batch->role == WHIRL_ROLE_SURVEY || batch->role == WHIRL_ROLE_MAP ||
           batch->role == WHIRL_ROLE_BRANCHES ||
           (batch->role == WHIRL_ROLE_REST && !whirl_analysis_has(batch->analyses, "fit"));
}

void sensitivity_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const sensitivity_parts *own = &parts->sensitivity;
    if (!own->keys.place || own->count == 0) return;
    // Collect the parameters with their values, and the numbers.
    whirl_derivatives *derivatives = arena_take(reader->arena, sizeof *derivatives);
    whirl_given *given = arena_take(reader->arena, own->count * sizeof *given);
    whirl_spread_of *numbers = arena_take(reader->arena, (own->asked.count + 1) * sizeof *numbers);
    reader->no_memory = reader->no_memory || !derivatives || !given || !numbers;
    if (reader->no_memory) return;
    for (size_t i = 0; i < own->count; i++) {
        const double value = v->values[own->parameters[i] - v->parameters->items];
        given[i] = (whirl_given){own->parameters[i]->name, value};
        if (value == 0.0)
            problem_at(reader->problems, own->places[i],
                       "is a parameter with the value 0, expected another value: derivatives are taken from changes "
                       "of a part of it");
        for (size_t k = 0; k < i; k++)
            if (own->parameters[k] == own->parameters[i])
                problem_at(reader->problems, own->places[i], "is named twice, expected once");
    }
    memcpy(numbers, own->asked.spreads, own->asked.count * sizeof *numbers);
    if (!settings_check(reader, v, &own->keys)) return;
    const bool differs = settings_find(&own->keys, "difference") != NULL;
    *derivatives = (whirl_derivatives){.parameter_count = own->count,
                                       .parameters = given,
                                       .number_count = own->asked.count,
                                       .numbers = numbers,
                                       .difference = differs ? settings_number(v, &own->keys, "difference") : 0.0};
    // Ask for the derivatives at the points of the batches. Folds of branches need one more derivative, by the branch's
    // own parameter.
    bool any = false;
    for (size_t b = 0; b < result->batch_count; b++) {
        if (!sensitivity_fits(&result->batches[b])) continue;
        if (result->batches[b].role == WHIRL_ROLE_BRANCHES && own->count == WHIRL_MAX_SENSITIVITIES)
            problem_at(reader->problems, own->places[own->count - 1],
                       "is one parameter too many for a branch, expected at most %d", WHIRL_MAX_SENSITIVITIES - 1);
        result->batches[b].derivatives = derivatives;
        any = true;
    }
    if (!any)
        problem_at_key(
            reader->problems, own->keys.place,
            "needs a response, a sweep, a map, a branch, a run-up or a study of machines at rest, whose numbers it "
            "differentiates");
    result->derivatives = derivatives;
}
