// Names in studies: stations of the machine, and parameters with values.
#include "plan_names.h"
#include "plan_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "name_list.h"
#include "problem.h"
#include "tree.h"
#include "whirl/engine/descriptor.h"

/// Appends the name of a station; returns false after a problem.
static bool add_station(case_reader *reader, const file_node *where, const machine_parts *machine, const char *name,
                        char names[WHIRL_NAME_SIZE]) {
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    const size_t used = strlen(names), length = strlen(name);
    if (named_find(&machine->stations, name) == machine->stations.count) {
        machine_advise(machine, name, false, advice);
        problem_at(reader->problems, where, "is %s, which is no station, %s", text_shown(name, shown), advice);
        return false;
    }
    if (used + length + 2 > WHIRL_NAME_SIZE) {
        problem_at(reader->problems, where, "is one name too many, expected names of at most %d letters together",
                   WHIRL_NAME_SIZE - 1);
        return false;
    }
    if (used > 0) names[used] = ' ';
    memcpy(names + used + (used > 0), name, length + 1);
    return true;
}

/// Appends the stations of a text; returns false after a problem.
static bool add_stations(case_reader *reader, const file_node *where, const machine_parts *machine,
                         char names[WHIRL_NAME_SIZE]) {
    char shown[SHOWN_SIZE], name[WHIRL_NAME_SIZE];
    const char *text = where->kind == NODE_TEXT ? where->text : "";
    bool any = false;
    for (; name_list_next(&text, name); any = true)
        if (!add_station(reader, where, machine, name, names)) return false;
    if (!any) problem_at(reader->problems, where, "is %s, expected the name of a station", node_shown(where, shown));
    return any;
}

void plan_read_stations(case_reader *reader, const machine_parts *machine, const setting_list *keys, const char *key,
                        bool several) {
    char names[WHIRL_NAME_SIZE] = "";
    for (size_t i = 0; i < keys->count; i++) {
        setting *given = &keys->items[i];
        if (strcmp(given->key->name, key) != 0) continue;
        const file_node *where = given->place, *first = where->kind == NODE_LIST ? where->first : where;
        for (const file_node *one = first; one; one = where->kind == NODE_LIST ? one->next : NULL)
            if (!add_stations(reader, one, machine, names)) return;
        if (!*names || (!several && strchr(names, ' '))) {
            problem_at(reader->problems, where, "names %s station, expected one", *names ? "more than one" : "no");
            return;
        }
        given->word = arena_text(reader->arena, names, strlen(names));
        reader->no_memory = reader->no_memory || !given->word;
    }
}

const parameter *plan_find_named(case_reader *reader, const file_node *where) {
    char advice[WHY_SIZE];
    const parameter_table *parameters = reader->parameters;
    const size_t index = parameters_find(parameters, where->key);
    if (index < parameters->count) return &parameters->items[index];
    describe_names(where->key, parameters->names, parameters->count, advice);
    problem_at_key(reader->problems, where, "is no parameter, %s", advice);
    return NULL;
}

bool plan_check_free(case_reader *reader, const file_node *where, const parameter *own) {
    char shown[SHOWN_SIZE];
    if (!own->value.expression) return true;
    problem_at_key(reader->problems, where,
                   "is = %s in the case, expected a parameter with a number of its own, not an expression",
                   text_shown(own->value.expression, shown));
    return false;
}

void plan_read_given(case_reader *reader, const file_node *where, condition_parts *condition) {
    const parameter *own = plan_find_named(reader, where);
    if (!own) return;
    const whirl_key key = {.name = own->name, .unit = parameter_expected_unit(own), .range = WHIRL_ANY};
    if (!formula_read(reader, where, &key, &condition->values[condition->count])) return;
    condition->parameters[condition->count] = own;
    condition->places[condition->count++] = where;
}

void plan_read_change(case_reader *reader, setting_list *keys, condition_parts *change) {
    char shown[SHOWN_SIZE], names[WHIRL_NAME_SIZE] = "";
    setting *given = NULL;
    for (size_t i = 0; i < keys->count; i++)
        if (strcmp(keys->items[i].key->name, "change") == 0) given = &keys->items[i];
    if (!given) return;
    const file_node *where = given->place;
    change->place = where;
    if (where->kind != NODE_MAPPING || where->count == 0 || where->count > WHIRL_MAX_GIVEN) {
        problem_at(reader->problems, where, "is %s, expected 1 to %d parameters with their values after the change",
                   where->kind == NODE_MAPPING ? where->count ? "a longer list" : "empty" : node_shown(where, shown),
                   WHIRL_MAX_GIVEN);
        return;
    }
    for (const file_node *one = where->first; one; one = one->next) {
        const size_t used = strlen(names);
        plan_read_given(reader, one, change);
        snprintf(names + used, sizeof names - used, "%s%.40s", used ? ", " : "", one->key);
    }
    given->word = arena_text(reader->arena, names, strlen(names));
    reader->no_memory = reader->no_memory || !given->word;
}
