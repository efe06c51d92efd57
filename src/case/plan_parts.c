// Reading `study:`: everything that can be read without the values of the parameters.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan.h"
#include "plan_parts.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/integrate.h"

void plan_read_part(case_reader *reader, const setting_list *study, const char *key, const whirl_group *group,
                    setting_list *part) {
    const setting *given = settings_find(study, key);
    *part = (setting_list){.name = group->name, .group = group, .place = study->place};
    if (given) settings_read(reader, given->place, group, part);
}

// ---------------------------------------------------------------- sweep

const parameter *plan_find_parameter(case_reader *reader, const setting *given) {
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    const parameter_table *parameters = reader->parameters;
    if (given->place->kind != NODE_TEXT) {
        problem_at(reader->problems, given->place, "is %s, expected the name of a parameter",
                   node_shown(given->place, shown));
        return NULL;
    }
    const size_t index = parameters_find(parameters, given->place->text);
    if (index < parameters->count) return &parameters->items[index];
    describe_names(given->place->text, parameters->names, parameters->count, advice);
    problem_at(reader->problems, given->place, "is %s, which is no parameter, %s", node_shown(given->place, shown),
               advice);
    return NULL;
}

/// Reads a value of the swept parameter. Its unit is the parameter's own, or that of the keys using it; if both are
/// unknown, the first value with a unit determines that of the others.
static void read_swept_value(case_reader *reader, const file_node *where, axis_parts *axis, number_formula *result) {
    char why[WHY_SIZE];
    quantity read;
    const whirl_key key = {.name = axis->parameter->name, .unit = axis->unit, .range = WHIRL_ANY};
    if (!formula_read(reader, where, &key, result) || axis->unit[0]) return;
    if (result->expression) {
        axis->unit = expression_unit(reader->parameters, result->expression);
    } else if (quantity_read(where->text, "", &read, why)) {
        const char *unit = arena_text(reader->arena, read.unit, strlen(read.unit));
        reader->no_memory = reader->no_memory || !unit;
        axis->unit = unit ? unit : "";
    }
    if (strcmp(axis->unit, "1") == 0) axis->unit = ""; // a plain number is one in SI
}

/// Reads a list of at most `most` values of the swept parameter.
static void read_values(case_reader *reader, const file_node *where, size_t most, axis_parts *axis,
                        formula_list *result) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_LIST || where->count == 0 || where->count > most) {
        problem_at(reader->problems, where, "is %s, expected a list of 1 to %zu values",
                   where->kind == NODE_LIST ? where->count ? "a longer list" : "an empty list"
                                            : node_shown(where, shown),
                   most);
        return;
    }
    result->items = arena_take(reader->arena, where->count * sizeof *result->items);
    result->places = arena_take(reader->arena, where->count * sizeof *result->places);
    reader->no_memory = reader->no_memory || !result->items || !result->places;
    if (reader->no_memory) return;
    for (const file_node *item = where->first; item; item = item->next) {
        result->places[result->count] = item;
        read_swept_value(reader, item, axis, &result->items[result->count++]);
    }
}

/// Reports missing keys of a sweep without a list of values.
static void check_range_keys(case_reader *reader, const setting_list *sweep) {
    static const char *const ends[] = {"from", "to"};
    const setting *points = settings_find(sweep, "points"), *step = settings_find(sweep, "step");
    if (!settings_find(sweep, "from") && !settings_find(sweep, "to") && !points && !step) {
        problem_at(reader->problems, sweep->place, "has no values, expected from, to and points, or values: [...]");
        return;
    }
    for (size_t i = 0; i < 2; i++)
        if (!settings_find(sweep, ends[i]) && !settings_misspelt(sweep, ends[i]))
            problem_missing(reader->problems, sweep->place, ends[i], "is missing, expected %s, or values: [...]",
                            whirl_group_key(sweep->group, ends[i])->meaning);
    if (points && step)
        problem_at_key(reader->problems, step->place, "is given together with points, expected one of the two");
    else if (!points && !step && !settings_misspelt(sweep, "points") && !settings_misspelt(sweep, "step"))
        problem_missing(reader->problems, sweep->place, "points", "is missing, expected the number of values, or step");
    if (step && strcmp(settings_word(sweep, "scale"), "log") == 0)
        problem_at_key(reader->problems, step->place, "has no meaning with scale: log, expected points");
}

/// Reports keys that exclude a list of values.
static void check_list_keys(case_reader *reader, const setting_list *sweep) {
    for (size_t i = 1; i + 1 < schema_axis.key_count; i++) {
        const setting *other = settings_find(sweep, schema_axis.keys[i].name);
        if (other)
            problem_at_key(reader->problems, other->place, "is given together with values, expected one of the two");
    }
}

/// Notes the unit of the first of these values that has one, unless it is the parameter's own unit.
static void note_unit(case_reader *reader, axis_parts *axis, const setting *const *given, size_t count) {
    const char *const expected = axis->unit;
    const char *const text = axis->parameter->value.expression ? "" : axis->parameter->text;
    const whirl_unit own = formula_unit(reader->parameters, text, expected);
    for (size_t i = 0; i < count && axis->written.size == 0.0; i++) {
        const file_node *const at = !given[i] || given[i]->place->kind == NODE_LIST
                                        ? given[i] ? given[i]->place->first : NULL
                                        : given[i]->place;
        if (at && at->kind == NODE_TEXT) axis->written = formula_unit(reader->parameters, at->text, expected);
    }
    if (strcmp(axis->written.name, own.name) == 0) axis->written = (whirl_unit){.size = 0.0};
}

void plan_read_axis(case_reader *reader, axis_parts *axis) {
    const setting_list *sweep = &axis->keys;
    const setting *name = settings_find(sweep, "parameter"), *values = settings_find(sweep, "values");
    const setting *from = settings_find(sweep, "from"), *to = settings_find(sweep, "to");
    const setting *step = settings_find(sweep, "step");
    if (values)
        check_list_keys(reader, sweep);
    else
        check_range_keys(reader, sweep);
    if (name) axis->parameter = plan_find_parameter(reader, name);
    if (axis->parameter) axis->unit = parameter_expected_unit(axis->parameter);
    if (axis->parameter && from) read_swept_value(reader, from->place, axis, &axis->from);
    if (axis->parameter && to) read_swept_value(reader, to->place, axis, &axis->to);
    if (axis->parameter && step) read_swept_value(reader, step->place, axis, &axis->step);
    if (axis->parameter && values) read_values(reader, values->place, SCHEMA_MAX_POINTS, axis, &axis->values);
    if (axis->parameter) note_unit(reader, axis, (const setting *[]){from, to, step, values}, 4);
}

static void read_sweep(case_reader *reader, plan_parts *parts) {
    plan_read_part(reader, &parts->study, "sweep", &schema_sweep, &parts->sweep.keys);
    plan_read_axis(reader, &parts->sweep);
    const setting *direction = settings_find(&parts->sweep.keys, "direction");
    if (direction && strcmp(settings_word(&parts->sweep.keys, "start"), "carry") != 0)
        problem_at_key(reader->problems, direction->place, "has a meaning only with start: carry");
}

/// Reads an axis of a map from one of its keys.
static void read_map_axis(case_reader *reader, const setting_list *map, const char *key, axis_parts *axis) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(map, key);
    if (!given) return; // has been reported, or the map has one plane
    if (given->place->kind == NODE_MAPPING) {
        settings_read(reader, given->place, &schema_axis, &axis->keys);
        plan_read_axis(reader, axis);
    } else {
        problem_at(reader->problems, given->place, "is %s, expected {parameter: ..., from: ..., to: ..., points: ...}",
                   node_shown(given->place, shown));
    }
}

/// Checks that the axes of a map have different parameters.
static void check_other_axis(case_reader *reader, const axis_parts *axis, const axis_parts *other, const char *key) {
    if (axis->parameter && axis->parameter == other->parameter)
        problem_at(reader->problems, settings_find(&axis->keys, "parameter")->place,
                   "is %s, which varies along %s already, expected another parameter", axis->parameter->name, key);
}

static void read_map(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts) {
    (void)given;
    plan_read_part(reader, &parts->study, group->name, group, &parts->map);
    read_map_axis(reader, &parts->map, "x", &parts->sweep);
    read_map_axis(reader, &parts->map, "y", &parts->across);
    read_map_axis(reader, &parts->map, "z", &parts->planes);
    check_other_axis(reader, &parts->across, &parts->sweep, "x");
    check_other_axis(reader, &parts->planes, &parts->sweep, "x");
    check_other_axis(reader, &parts->planes, &parts->across, "y");
}

/// Reports keys without effect in studies that record no motions. `settles`: motions are integrated until they settle,
/// and `integrate` has an effect.
static void check_lone_keys(case_reader *reader, const plan_parts *parts, const char *kind, bool settles) {
    static const char *const others[] = {"keep", "analyze", "detail", "confirm", "starts", "integrate"};
    for (size_t i = 0; i < sizeof others / sizeof *others - settles; i++) {
        const setting *given = settings_find(&parts->study, others[i]);
        if (given)
            problem_at_key(reader->problems, given->place, "has no meaning with %s, which follows no motion", kind);
    }
}

// ---------------------------------------------------------------- branches

/// Reads the parameter of branches; next to a sweep it is the sweep's.
static void read_branch_parameter(case_reader *reader, plan_parts *parts) {
    char shown[SHOWN_SIZE];
    const setting *name = settings_find(&parts->branch, "parameter");
    if (!parts->swept_too) {
        if (name) parts->sweep.parameter = plan_find_parameter(reader, name);
        if (parts->sweep.parameter) parts->sweep.unit = parameter_expected_unit(parts->sweep.parameter);
        if (!name && !settings_misspelt(&parts->branch, "parameter"))
            problem_missing(reader->problems, parts->branch.place, "parameter",
                            "is missing, expected the name of the parameter that varies");
    } else if (name && parts->sweep.parameter &&
               (name->place->kind != NODE_TEXT || strcmp(name->place->text, parts->sweep.parameter->name) != 0)) {
        problem_at(reader->problems, name->place, "is %s, expected %s, the parameter of the sweep",
                   node_shown(name->place, shown), parts->sweep.parameter->name);
    }
}

static void read_branch_values(case_reader *reader, plan_parts *parts) {
    static const char *const ends[] = {"from", "to"};
    const setting *from = settings_find(&parts->branch, "from"), *to = settings_find(&parts->branch, "to");
    const setting *at = settings_find(&parts->branch, "at");
    for (size_t i = 0; i < 2 && !parts->swept_too; i++)
        if (!settings_find(&parts->branch, ends[i]) && !settings_misspelt(&parts->branch, ends[i]))
            problem_missing(reader->problems, parts->branch.place, ends[i], "is missing, expected a bound of %s",
                            parts->sweep.parameter ? parts->sweep.parameter->name : "the parameter");
    if (!parts->sweep.parameter) return;
    if (from) read_swept_value(reader, from->place, &parts->sweep, &parts->low);
    if (to) read_swept_value(reader, to->place, &parts->sweep, &parts->high);
    if (at) read_values(reader, at->place, SCHEMA_MAX_DETAIL, &parts->sweep, &parts->begins);
    if (!parts->swept_too) note_unit(reader, &parts->sweep, (const setting *[]){from, to, at}, 3);
}

/// Reads the second parameter of curves and its bounds.
static void read_curves(case_reader *reader, plan_parts *parts) {
    plan_read_part(reader, &parts->study, "curves", &schema_curves, &parts->curves);
    const setting *given = settings_find(&parts->study, "curves");
    const setting *name = settings_find(&parts->curves, "parameter");
    const setting *from = settings_find(&parts->curves, "from"), *to = settings_find(&parts->curves, "to");
    if (given && !parts->branches)
        problem_at_key(reader->problems, given->place, "needs branch, whose special points it follows");
    if (!given || !name || !from || !to) return; // has been reported
    parts->second = plan_find_parameter(reader, name);
    if (!parts->second) return;
    if (parts->second == parts->sweep.parameter)
        problem_at(reader->problems, name->place, "is %s, along which the branches go, expected another parameter",
                   parts->second->name);
    const whirl_key key = {
        .name = parts->second->name, .unit = parameter_expected_unit(parts->second), .range = WHIRL_ANY};
    formula_read(reader, from->place, &key, &parts->second_low);
    formula_read(reader, to->place, &key, &parts->second_high);
}

/// Refuses tori together with branches of equilibria, since tori begin at orbits of forced machines.
static void check_tori(case_reader *reader, const plan_parts *parts) {
    const setting *given = settings_find(&parts->branch, "tori");
    if (given && settings_yes(&parts->branch, "tori") && settings_yes(&parts->branch, "rest"))
        problem_at(reader->problems, given->place,
                   "is yes together with rest: yes, expected one of the two: tori begin at orbits of machines that are "
                   "driven");
}

static void read_branch(case_reader *reader, plan_parts *parts) {
    plan_read_part(reader, &parts->study, "branch", &schema_branch, &parts->branch);
    parts->branches = settings_find(&parts->study, "branch") != NULL;
    parts->swept_too = parts->branches && settings_find(&parts->study, "sweep");
    if (parts->branches && !parts->moves && !parts->beside) check_lone_keys(reader, parts, "branch", true);
    if (parts->branches) {
        read_branch_parameter(reader, parts);
        read_branch_values(reader, parts);
        check_tori(reader, parts);
    }
    read_curves(reader, parts);
}

// ---------------------------------------------------------------- kinds of study

/// A kind of study with its own key, and its reading function.
typedef struct kind_of_study {
    const whirl_group *group; ///< group of the key's value, with the key's name
    void (*read)(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts);
} kind_of_study;

static void read_response(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts) {
    setting_list nothing;
    (void)given;
    plan_read_part(reader, &parts->study, group->name, group, &nothing);
}

static void read_sweep_alone(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts) {
    char shown[SHOWN_SIZE];
    (void)group;
    if (given->place->kind == NODE_MAPPING)
        read_sweep(reader, parts);
    else
        problem_at(reader->problems, given->place, "is %s, expected {parameter: ..., from: ..., to: ..., points: ...}",
                   node_shown(given->place, shown));
}

/// Leaves a data set to dataset_read.
static void read_nothing(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts) {
    (void)reader, (void)given, (void)group, (void)parts;
}

/// Reads branches without a sweep; read_branch reads the rest.
static void read_no_sweep(case_reader *reader, const setting *given, const whirl_group *group, plan_parts *parts) {
    (void)given, (void)group;
    plan_read_part(reader, &parts->study, schema_sweep.name, &schema_sweep, &parts->sweep.keys);
}

/// Kinds of studies in the order of messages; those at rest follow.
static const kind_of_study kinds[] = {{&schema_response, read_response}, {&schema_sweep, read_sweep_alone},
                                      {&schema_map, read_map},           {&schema_basin, read_map},
                                      {&schema_dataset, read_nothing},   {&schema_branch, read_no_sweep}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/// Reports that a study has none of the kinds, which the message lists in their order.
static void report_no_kind(case_reader *reader, const file_node *study) {
    char names[WHY_SIZE] = "";
    for (size_t i = 0, used = 0; i < KINDS + SCHEMA_AT_REST; i++)
        used += (size_t)snprintf(names + used, sizeof names - used, "%s%s",
                                 i == 0                           ? ""
                                 : i + 1 < KINDS + SCHEMA_AT_REST ? ", "
                                                                  : " and ",
                                 i < KINDS ? kinds[i].group->name : schema_at_rest[i - KINDS].name);
    problem_at(reader->problems, study, "has none of %s, expected one of them", names);
}

/// Reads the kind of motions: the first one that is given. A second one is an error, except for branches next to a
/// sweep.
static void read_kind_of_motions(case_reader *reader, plan_parts *parts) {
    const setting *found = NULL;
    size_t chosen = 0;
    for (size_t i = 0; i < KINDS; i++) {
        const setting *given = settings_find(&parts->study, kinds[i].group->name);
        if (!given || (found && kinds[chosen].group == &schema_sweep && kinds[i].group == &schema_branch)) continue;
        // Next to a sweep the response, which is the default, is the superfluous key.
        const bool first = found && kinds[i].group == &schema_sweep;
        if (found)
            problem_at_key(reader->problems, (first ? found : given)->place,
                           "is given together with %s, expected one of the two", (first ? given : found)->key->name);
        else
            found = given, chosen = i;
    }
    if (!found) return;
    parts->moves = kinds[chosen].group != &schema_branch;
    kinds[chosen].read(reader, found, kinds[chosen].group, parts);
}

/// Returns the first study at rest in the file; NULL if there is none.
static const whirl_group *find_resting(const plan_parts *parts) {
    for (const whirl_group *group = schema_at_rest; group->name; group++)
        if (settings_find(&parts->study, group->name)) return group;
    return NULL;
}

/// Reads the kinds of a study: motions, studies at rest (plan_resting.c), or both.
static void read_kinds(case_reader *reader, plan_parts *parts) {
    const whirl_group *resting = find_resting(parts);
    read_kind_of_motions(reader, parts);
    parts->beside = settings_find(&parts->study, schema_motions.name) != NULL;
    if (parts->moves || parts->beside || settings_find(&parts->study, schema_branch.name)) return;
    if (resting)
        check_lone_keys(reader, parts, resting->name, false);
    else
        report_no_kind(reader, parts->study.place);
}

// ---------------------------------------------------------------- detail

static void read_detail(case_reader *reader, plan_parts *parts) {
    plan_read_part(reader, &parts->study, "detail", &schema_detail, &parts->detail);
    const setting *given = settings_find(&parts->study, "detail");
    if (!given) return;
    if (!settings_find(&parts->study, "sweep"))
        problem_at_key(reader->problems, given->place, "needs a sweep, whose parameter it gives values to");
    const setting *at = settings_find(&parts->detail, "at");
    if (at && parts->sweep.parameter) read_values(reader, at->place, SCHEMA_MAX_DETAIL, &parts->sweep, &parts->at);
}

// ---------------------------------------------------------------- initial state

/// Returns the station that a member of a mapping names; the number of stations, after a problem, if there is none.
static size_t find_station(case_reader *reader, const file_node *member, const machine_parts *machine) {
    char advice[WHY_SIZE];
    const size_t station = named_find(&machine->stations, member->key);
    if (station == machine->stations.count && reader_reports(reader, "station", member->key)) {
        machine_advise(machine, member->key, false, advice);
        problem_at_key(reader->problems, member, "is no station, %s", advice);
    }
    return station;
}

static void read_initial(case_reader *reader, const file_node *where, const machine_parts *machine,
                         study_plan *result) {
    char shown[SHOWN_SIZE];
    if (node_is_null(where)) return;
    if (where->kind != NODE_MAPPING) {
        problem_at(reader->problems, where, "is %s, expected names of stations with x, y, vx, vy",
                   node_shown(where, shown));
        return;
    }
    result->starts = arena_take(reader->arena, (where->count + 1) * sizeof *result->starts);
    reader->no_memory = reader->no_memory || !result->starts;
    if (!result->starts) return;
    for (const file_node *member = where->first; member; member = member->next) {
        const size_t station = find_station(reader, member, machine);
        if (station == machine->stations.count) continue;
        plan_start *start = &result->starts[result->start_count++];
        start->station = station;
        settings_read(reader, member, &schema_initial, &start->state);
    }
}

// ---------------------------------------------------------------- several starts

/// Refuses several starts in studies whose points have one start each.
static void check_starts(case_reader *reader, const plan_parts *parts, const setting *given) {
    if (parts->map.group == &schema_basin)
        problem_at_key(reader->problems, given->place, "has no meaning with basin, whose points are starts");
    if (parts->sweep.keys.group == &schema_sweep && strcmp(settings_word(&parts->sweep.keys, "start"), "carry") == 0)
        problem_at_key(
            reader->problems, given->place,
            "is given together with start: carry, expected one of the two: carried points have one start each");
}

static void read_ranges(case_reader *reader, const file_node *where, const machine_parts *machine, study_plan *result) {
    char shown[SHOWN_SIZE];
    size_t count = 0;
    if (where->kind != NODE_MAPPING || !where->first) {
        problem_at(reader->problems, where, "is %s, expected names of stations with ranges: {%s: {x: [-1, 1]}}",
                   where->kind == NODE_MAPPING ? "empty" : node_shown(where, shown),
                   machine->stations.count > 0 ? machine->stations.names[0] : "disc");
        return;
    }
    result->ranges = arena_take(reader->arena, (where->count + 1) * sizeof *result->ranges);
    reader->no_memory = reader->no_memory || !result->ranges;
    for (const file_node *member = where->first; result->ranges && member; member = member->next) {
        const size_t station = find_station(reader, member, machine);
        if (station == machine->stations.count) continue;
        plan_range *range = &result->ranges[result->range_count++];
        range->station = station;
        settings_read_ranges(reader, member, &schema_initial, &range->low, &range->high);
        count += range->low.count;
    }
    if (count > WHIRL_MAX_RANGES)
        problem_at(reader->problems, where, "has %zu ranges, expected at most %d", count, WHIRL_MAX_RANGES);
}

/// Reads the number of a grid's values in a range; 0 after a problem.
static size_t read_points(case_reader *reader, const file_node *where, const plan_range *range, const char *name) {
    const whirl_key key = {
        .name = name, .unit = "1", .kind = WHIRL_KEY_WHOLE, .range = WHIRL_FROM_TO(1, WHIRL_MAX_STARTS - 1)};
    const file_node *station = node_member(where, range->low.place->key);
    const file_node *given = station ? node_member(station, name) : NULL;
    char shown[SHOWN_SIZE];
    number_formula read;
    if (station && station->kind != NODE_MAPPING) return 0; // has been reported
    if (!given) {
        problem_at_key(reader->problems, where, "has no number for %s of %s, expected one for every range of within",
                       name, range->low.place->key);
        return 0;
    }
    if (!formula_read(reader, given, &key, &read)) return 0;
    if (!read.expression) return (size_t)read.number;
    problem_at(reader->problems, given, "is %s, expected a whole number, no expression", node_shown(given, shown));
    return 0;
}

/// Checks that everything a grid names has a range.
static void check_grid(case_reader *reader, const file_node *where, const file_node *within) {
    char shown[SHOWN_SIZE];
    for (const file_node *station = where->first; station; station = station->next) {
        const file_node *ranges = node_member(within, station->key);
        if (!ranges) problem_at_key(reader->problems, station, "has no ranges in within");
        if (station->kind != NODE_MAPPING)
            problem_at(reader->problems, station, "is %s, expected numbers of values: {x: 5}",
                       node_shown(station, shown));
        for (const file_node *one = ranges ? station->first : NULL; one; one = one->next)
            if (one->key && !node_member(ranges, one->key))
                problem_at_key(reader->problems, one, "has no range in within");
    }
}

/// Reads the numbers of values for all ranges of a grid.
static void read_grid(case_reader *reader, const file_node *where, const file_node *within, study_plan *result) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_MAPPING || !where->first) {
        problem_at(reader->problems, where, "is %s, expected names of stations with numbers of values: {disc: {x: 5}}",
                   where->kind == NODE_MAPPING ? "empty" : node_shown(where, shown));
        return;
    }
    if (within && within->kind == NODE_MAPPING) check_grid(reader, where, within);
    for (size_t i = 0; i < result->range_count; i++) {
        plan_range *range = &result->ranges[i];
        range->points = arena_take(reader->arena, (range->low.count + 1) * sizeof *range->points);
        reader->no_memory = reader->no_memory || !range->points;
        for (size_t k = 0; range->points && k < range->low.count; k++)
            range->points[k] = read_points(reader, where, range, range->low.items[k].key->name);
    }
}

/// Checks that exactly one of the keys count and grid is given.
static void check_number_of_starts(case_reader *reader, const plan_parts *parts) {
    const setting *count = settings_find(&parts->starts, "count"), *grid = settings_find(&parts->starts, "grid");
    if (count && grid)
        problem_at_key(reader->problems, grid->place, "is given together with count, expected one of the two");
    const bool misspelt = settings_misspelt(&parts->starts, "count") || settings_misspelt(&parts->starts, "grid");
    if (!count && !grid && !misspelt && parts->starts.place->kind == NODE_MAPPING)
        problem_missing(reader->problems, parts->starts.place, "count",
                        "is missing, expected the starts of every point, or a grid");
}

static void read_starts(case_reader *reader, const machine_parts *machine, plan_parts *parts, study_plan *result) {
    const setting *given = settings_find(&parts->study, "starts");
    plan_read_part(reader, &parts->study, "starts", &schema_starts, &parts->starts);
    if (!given) return;
    check_starts(reader, parts, given);
    const setting *within = settings_find(&parts->starts, "within"), *grid = settings_find(&parts->starts, "grid");
    if (within) read_ranges(reader, within->place, machine, result);
    check_number_of_starts(reader, parts);
    if (grid) read_grid(reader, grid->place, within ? within->place : NULL, result);
}

// ---------------------------------------------------------------- analyses and method

static void report_unknown_analysis(case_reader *reader, const file_node *where) {
    const char *names[SETTINGS_MAX];
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    size_t count = 0;
    for (const whirl_analysis *a = whirl_analyses(); a->name && count < SETTINGS_MAX; a++)
        if (a->kind->moves) names[count++] = a->name;
    describe_names(where->kind == NODE_TEXT ? where->text : "", names, count, advice);
    problem_at(reader->problems, where, "is %s, which is no analysis, %s", node_shown(where, shown), advice);
}

static void read_analyses(case_reader *reader, plan_parts *parts) {
    // Motions have analyses, the usual ones by default.
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&parts->study, "analyze");
    if (!parts->moves && !parts->beside) return;
    if (!given) {
        parts->analyses = whirl_analysis_usual();
        return;
    }
    // Add each analysis of the list; those of studies of their own are refused.
    const file_node *where = given->place;
    if (where->kind != NODE_LIST || where->count == 0) {
        problem_at(reader->problems, where, "is %s, expected a list of analyses: [poincare, regime]",
                   where->kind == NODE_LIST ? "an empty list" : node_shown(where, shown));
        return;
    }
    for (const file_node *item = where->first; item; item = item->next) {
        whirl_analysis_set one = 0;
        if (item->kind != NODE_TEXT || !whirl_analysis_add(&one, item->text))
            report_unknown_analysis(reader, item);
        else if (whirl_analysis_kind(one)->found)
            problem_at(reader->problems, item,
                       "is %s, of points of branches, expected branch: {...} in addition to the sweep", item->text);
        else if (!whirl_analysis_kind(one)->moves)
            problem_at(reader->problems, item,
                       "is %s, which is a study of its own, expected %s: {...} in place of "
                       "response or sweep, or in addition",
                       item->text, item->text);
        parts->analyses |= one;
    }
}

static void check_method(case_reader *reader, const plan_parts *parts) {
    const setting *given = settings_find(&parts->integrate, "method");
    const char *names[SETTINGS_MAX];
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    size_t count = 0;
    if (!given) return;
    for (const whirl_method *method; count < SETTINGS_MAX && (method = whirl_method_at(count)); count++) {
        names[count] = method->name;
        if (given->place->kind == NODE_TEXT && strcmp(method->name, given->place->text) == 0) return;
    }
    describe_names(given->place->kind == NODE_TEXT ? given->place->text : "", names, count, advice);
    problem_at(reader->problems, given->place, "is %s, which is no method, %s", node_shown(given->place, shown),
               advice);
}

void plan_read_parts(case_reader *reader, const file_node *where, const machine_parts *machine, plan_parts *parts,
                     study_plan *result) {
    *parts = (plan_parts){0};
    *result = (study_plan){0};
    settings_read(reader, where, &schema_study, &parts->study);
    if (where->kind != NODE_MAPPING && !node_is_null(where)) return;  // has been reported
    const setting *initial = settings_find(&parts->study, "initial"); // first, since ranges may use the swept parameter
    if (initial) read_initial(reader, initial->place, machine, result);
    read_kinds(reader, parts);
    read_branch(reader, parts);
    read_starts(reader, machine, parts, result);
    plan_read_part(reader, &parts->study, "integrate", &schema_integrate, &parts->integrate);
    plan_read_part(reader, &parts->study, "keep", &schema_keep, &parts->keep);
    read_analyses(reader, parts);
    check_method(reader, parts);
    read_detail(reader, parts);
}
