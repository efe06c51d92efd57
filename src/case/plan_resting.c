// Studies that a case may have several of, each at all its conditions: studies of machines at rest, and motions with
// the unbalances of such a study.
#include "plan_resting.h"
#include "plan.h"
#include "plan_batches.h"
#include "plan_course.h"
#include "plan_fit.h"
#include "plan_names.h"
#include "plan_parts.h"
#include "schema.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "problem.h"
#include "tree.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"

// ---------------------------------------------------------------- reading

/// Checks that the parameter is the stiffness, in N/m, if bearings are springs.
static void check_bearings(case_reader *reader, const axis_parts *axis) {
    char shown[SHOWN_SIZE];
    const setting *bearings = settings_find(&axis->keys, "bearings"), *name = settings_find(&axis->keys, "parameter");
    if (!bearings || !settings_yes(&axis->keys, "bearings")) return;
    if (!name)
        problem_at(reader->problems, bearings->place,
                   "is yes, but there is no parameter that their stiffness would be");
    else if (axis->parameter && *axis->unit && strcmp(axis->unit, "1") != 0 && strcmp(axis->unit, "N/m") != 0)
        problem_at(reader->problems, name->place,
                   "is %s, in %s, expected a stiffness in N/m, the stiffness of bearings with bearings: yes",
                   text_shown(axis->parameter->name, shown), axis->unit);
}

/// Returns true for a valid name of a table, which is also a name in Python, Octave and file systems.
static bool is_name_of_table(const char *name) {
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_') return false;
    return *name && strlen(name) <= WHIRL_NAME_SIZE / 3;
}

/// Sets the name of a study's table: "unbalance", or "unbalance_NAME".
static void resting_read_name(case_reader *reader, const plan_parts *parts, resting_parts *resting) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&resting->axis.keys, "name");
    const char *group = resting->axis.keys.group->name, *own = given ? given->place->text : NULL;
    snprintf(resting->name, sizeof resting->name, "%.20s", group);
    if (given && (given->place->kind != NODE_TEXT || !is_name_of_table(own)))
        problem_at(reader->problems, given->place, "is %s, expected at most %d letters, digits and '_'",
                   node_shown(given->place, shown), WHIRL_NAME_SIZE / 3);
    else if (given)
        snprintf(resting->name, sizeof resting->name, "%.20s_%.21s", group, own);
    for (const resting_parts *other = parts->resting; other < resting; other++)
        if (strcmp(other->name, resting->name) == 0)
            problem_at(reader->problems, given ? given->place : resting->axis.keys.place,
                       "is another %s of the same name, expected a name of its own: {name: ..., ...}", group);
}

/// Reads the study at rest whose unbalances by rule these motions have.
static void read_unbalances(case_reader *reader, const plan_parts *parts, resting_parts *resting) {
    // Find both keys, which belong together.
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    const char *names[PLAN_MAX_RESTING];
    const setting *given = settings_find(&resting->axis.keys, "unbalance");
    const setting *factor = settings_find(&resting->axis.keys, "factor");
    size_t count = 0;
    if (factor && !given)
        problem_at_key(reader->problems, factor->place, "needs unbalance, the study whose unbalances it multiplies");
    if (!given) return;
    // Find the study of that name among earlier studies of unbalance.
    const char *text = given->place->kind == NODE_TEXT ? given->place->text : "";
    for (const resting_parts *one = parts->resting; one < resting; one++) {
        const char *own = one->name;
        if (one->axis.keys.group != &schema_at_rest[SCHEMA_AT_REST_unbalance]) continue;
        own += strncmp(own, "unbalance_", 10) == 0 ? 10 : 0;
        names[count++] = own;
        if (strcmp(own, text) == 0) resting->unbalances = one;
    }
    // Refuse the name of an unknown study, and a study without unbalances by rule.
    describe_names(text, names, count, advice);
    if (!resting->unbalances)
        problem_at(reader->problems, given->place, "is %s, which is no study of unbalance here, %s",
                   node_shown(given->place, shown), count > 0 ? advice : "expected one in the same study");
    else if (!settings_find(&resting->unbalances->axis.keys, "antinodes_of") &&
             !settings_find(&resting->unbalances->axis.keys, "at"))
        problem_at(reader->problems, given->place,
                   "is %s, which has no unbalances by rule, expected one with antinodes_of or at",
                   node_shown(given->place, shown));
}

static void read_condition(case_reader *reader, const file_node *where, plan_parts *parts) {
    char shown[SHOWN_SIZE];
    if (!is_name_of_table(where->key))
        problem_at_key(reader->problems, where, "is no name for a condition, expected letters, digits and '_'");
    if (where->kind != NODE_MAPPING && !node_is_null(where)) {
        problem_at(reader->problems, where, "is %s, expected parameters with their values there",
                   node_shown(where, shown));
        return;
    }
    if (where->count > WHIRL_MAX_GIVEN)
        problem_at(reader->problems, where, "has %zu parameters, expected at most %d", where->count, WHIRL_MAX_GIVEN);
    condition_parts *condition = &parts->conditions[parts->condition_count++];
    condition->place = where;
    for (const file_node *one = where->first; one && condition->count < WHIRL_MAX_GIVEN; one = one->next)
        plan_read_given(reader, one, condition);
}

static void read_conditions(case_reader *reader, plan_parts *parts) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&parts->study, "conditions");
    if (!given) return;
    const file_node *where = given->place;
    if (where->kind != NODE_MAPPING || where->count == 0 || where->count > PLAN_MAX_CONDITIONS) {
        problem_at(reader->problems, where, "is %s, expected 1 to %d names of conditions with values of parameters",
                   where->kind == NODE_MAPPING ? where->count ? "a longer list" : "empty" : node_shown(where, shown),
                   PLAN_MAX_CONDITIONS);
        return;
    }
    if (parts->resting_count == 0)
        problem_at_key(reader->problems, where, "needs a study of machines at rest or motions, which is done at each");
    for (const file_node *one = where->first; one; one = one->next) read_condition(reader, one, parts);
}

static void read_one(case_reader *reader, const file_node *where, const whirl_group *group,
                     const machine_parts *machine, plan_parts *parts) {
    // Add a study, unless there are too many.
    if (parts->resting_count == PLAN_MAX_RESTING) {
        problem_at(reader->problems, where,
                   "is one study too many at rest or of motions with unbalances by rule, expected at most %d",
                   PLAN_MAX_RESTING);
        return;
    }
    // Read its keys, its name and its axis.
    resting_parts *resting = &parts->resting[parts->resting_count++];
    axis_parts *axis = &resting->axis;
    axis->keys = (setting_list){.name = group->name, .group = group, .place = where};
    settings_read(reader, where, group, &axis->keys);
    resting_read_name(reader, parts, resting);
    const bool varies = settings_find(&axis->keys, "parameter") != NULL;
    if (varies) plan_read_axis(reader, axis);
    // Read stations, the course of a run-up, the parts of a fit, and the unbalances of motions.
    check_bearings(reader, axis);
    plan_read_stations(reader, machine, &axis->keys, "at", false);
    plan_read_stations(reader, machine, &axis->keys, "probes_at", true);
    plan_read_stations(reader, machine, &axis->keys, "coupling", true);
    plan_read_stations(reader, machine, &axis->keys, "loss_at", false);
    if (group == &schema_at_rest[SCHEMA_AT_REST_runup]) resting->course = course_read(reader, machine, &axis->keys);
    if (group == &schema_at_rest[SCHEMA_AT_REST_fit]) resting->fit = fit_read(reader, machine, &axis->keys);
    if (group == &schema_motions) read_unbalances(reader, parts, resting);
    // Refuse keys of an axis without a parameter.
    for (size_t i = 1; i < schema_axis.key_count && !varies; i++) {
        const setting *given = settings_find(&axis->keys, schema_axis.keys[i].name);
        if (given) problem_at_key(reader->problems, given->place, "needs parameter, whose values it gives");
    }
}

/// Reads the study, or the list of studies, of a kind.
static void read_group(case_reader *reader, const whirl_group *group, const machine_parts *machine, plan_parts *parts) {
    const setting *given = settings_find(&parts->study, group->name);
    if (!given) return;
    if (given->place->kind != NODE_LIST) read_one(reader, given->place, group, machine, parts);
    if (given->place->kind == NODE_LIST && given->place->count == 0)
        problem_at(reader->problems, given->place, "is an empty list, expected one study or a list of some");
    const file_node *first = given->place->kind == NODE_LIST ? given->place->first : NULL;
    for (const file_node *one = first; one; one = one->next) read_one(reader, one, group, machine, parts);
}

void resting_read(case_reader *reader, const machine_parts *machine, plan_parts *parts) {
    for (const whirl_group *group = schema_at_rest; group->name; group++) read_group(reader, group, machine, parts);
    read_group(reader, &schema_motions, machine, parts); // last, since they name other studies
    read_conditions(reader, parts);
}

// ---------------------------------------------------------------- batches

/// Sets the recording options of studies at rest, which have no motions.
static whirl_record_options resting_options(valuation *v, const resting_parts *resting,
                                            const whirl_integrate_options *integrate) {
    whirl_record_options options = whirl_record_default();
    if (options.samples_per_revolution > integrate->steps_per_revolution)
        options.samples_per_revolution = integrate->steps_per_revolution;
    settings_take(v, &resting->axis.keys, whirl_record_members(), &options);
    settings_take(v, &resting->axis.keys, whirl_runup_members(), &options.runup);
    settings_take(v, &resting->axis.keys, whirl_fit_members(), &options.fit);
    return options;
}

static void check_running(case_reader *reader, const resting_parts *resting, const whirl_record_options *options) {
    const setting *to = settings_find(&resting->axis.keys, "running_to");
    if (to && options->running_high < options->running_low)
        problem_at(reader->problems, to->place, "is %.10g rad/s, expected at least running_from (%.10g rad/s)",
                   options->running_high, options->running_low);
    const setting *trip = settings_find(&resting->axis.keys, "trip");
    const double highest = options->running_high > 0.0 ? options->running_high : options->running_low;
    if (trip && !(options->trip >= highest && highest > 0.0))
        problem_at(reader->problems, trip->place,
                   highest > 0.0 ? "is %.10g rad/s, expected at least the highest running speed (%.10g rad/s)"
                                 : "is %.10g rad/s, expected running_from or running_to as well",
                   options->trip, highest);
}

/// Checks unbalances by rule, which need the running speed, and exclude each other.
static void check_placed(case_reader *reader, const resting_parts *resting, const whirl_record_options *options) {
    const setting *antinodes = settings_find(&resting->axis.keys, "antinodes_of");
    const setting *at = settings_find(&resting->axis.keys, "at");
    const setting *weight = settings_find(&resting->axis.keys, "weight");
    if (antinodes && at)
        problem_at_key(reader->problems, at->place, "is given together with antinodes_of, expected one of the two");
    if (weight && !at) problem_at_key(reader->problems, weight->place, "needs at, the station where it counts");
    if ((antinodes || at) && !(options->running_high > 0.0))
        problem_at_key(reader->problems, (at ? at : antinodes)->place,
                       "needs running_to, the speed that determines unbalances");
}

/// Returns the values that a condition gives, evaluated once for all studies; NULL after a problem.
static const whirl_given *condition_values(case_reader *reader, valuation *v, const condition_parts *condition) {
    whirl_given *given = arena_take(reader->arena, (condition->count + 1) * sizeof *given);
    reader->no_memory = reader->no_memory || !given;
    for (size_t i = 0; given && i < condition->count; i++) {
        given[i].name = condition->parameters[i]->name;
        if (!plan_formula_value(reader, v, condition->places[i], &condition->values[i], &given[i].value)) return NULL;
    }
    return given;
}

/// Refuses conditions that set the varied parameter.
static void check_varied(case_reader *reader, const condition_parts *condition, const resting_parts *resting) {
    for (size_t i = 0; i < condition->count; i++)
        if (condition->parameters[i] == resting->axis.parameter &&
            reader_reports(reader, "condition", condition->parameters[i]->name))
            problem_at_key(reader->problems, condition->places[i],
                           "is the varied parameter of %s, expected another one", resting->name);
}

/// Completes a batch at rest with the study's own options.
static void finish_resting(case_reader *reader, valuation *v, const resting_parts *resting, whirl_batch *batch) {
    whirl_analysis_set own = 0;
    whirl_analysis_add(&own, resting->axis.keys.group->name);
    batch->integrate = whirl_integrate_default();
    batch->record = resting_options(v, resting, &batch->integrate);
    if (resting->course) batch->record.runup.event_count = (int)resting->course->event_count;
    if (resting->course) course_name_shafts(resting->course, &batch->record.runup);
    check_running(reader, resting, &batch->record);
    check_placed(reader, resting, &batch->record);
    plan_choose_analyses(batch, own, false);
    if (resting->fit) fit_make(reader, v, resting->fit, batch);
}

/// Keeps the last revolutions of motions for their orbits, unless there are too many motions.
static void keep_orbits(const plan_parts *parts, whirl_batch *batch) {
    enum { MAX_MOTIONS = 64, REVOLUTIONS = 2 };
    const size_t starts = batch->starts > 1 ? batch->starts : 1;
    whirl_record_options *record = &batch->record;
    if (settings_find(&parts->keep, "waveform") || batch->count * starts > MAX_MOTIONS) return;
    record->waveform_revolutions = record->record < REVOLUTIONS ? record->record : REVOLUTIONS;
    whirl_analysis_add(&batch->analyses, "waveform");
    whirl_analysis_needs(batch->analyses, record);
}

/// Completes a batch of motions with the options of all motions, and the unbalances of its study at rest.
static void finish_moving(case_reader *reader, valuation *v, const plan_parts *parts, const resting_parts *resting,
                          const study_plan *plan, whirl_batch *batch) {
    plan_options(v, parts, &batch->integrate, &batch->record);
    if (resting->unbalances) {
        settings_take(v, &resting->unbalances->axis.keys, whirl_record_members(), &batch->record);
        settings_take(v, &resting->axis.keys, whirl_record_members(), &batch->record);
    }
    plan_finish_points(reader, v, parts, plan, batch);
    keep_orbits(parts, batch);
}

static void make_one(case_reader *reader, valuation *v, const plan_parts *parts, const resting_parts *resting,
                     const condition_parts *condition, const whirl_given *given, study_plan *result) {
    // Refuse more batches than a study may have.
    const setting_list *keys = &resting->axis.keys;
    if (result->batch_count == WHIRL_MAX_BATCHES) {
        problem_at_key(reader->problems, keys->place, "at all conditions makes more than %d parts of a study",
                       WHIRL_MAX_BATCHES);
        return;
    }
    // Name the batch after the study and its condition.
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "%.38s%s%.21s", resting->name, condition ? "_" : "",
             condition ? condition->place->key : "");
    if (plan_batch(result, name) < result->batch_count)
        problem_at_key(reader->problems, keys->place, "makes a second %s, expected another name", name);
    // Add the batch, with an axis or as a single point.
    const whirl_role role = keys->group == &schema_motions ? WHIRL_ROLE_MOTIONS : WHIRL_ROLE_REST;
    whirl_batch *batch = resting->axis.parameter ? plan_make_axis(reader, v, &resting->axis, role, result)
                                                 : plan_add_batch(result, role, resting->name, keys->place);
    if (!batch) return;
    memcpy(batch->name, name, sizeof batch->name);
    // Finish it as a study of motions, or at rest.
    plan_origin *origin = &result->origins[result->batch_count - 1];
    origin->course = resting->course;
    origin->fit = resting->fit;
    if (keys->group == &schema_at_rest[SCHEMA_AT_REST_runup])
        origin->runup = plan_keep_keys(reader, keys);
    else
        origin->options[PLAN_OWN_OPTIONS] = plan_keep_keys(reader, keys);
    batch->given = given;
    batch->given_count = condition ? condition->count : 0;
    if (keys->group == &schema_motions) plan_keep_options(reader, parts, batch, origin);
    if (keys->group == &schema_motions)
        finish_moving(reader, v, parts, resting, result, batch);
    else
        finish_resting(reader, v, resting, batch);
}

void resting_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const whirl_given *given[PLAN_MAX_CONDITIONS];
    for (size_t i = 0; i < parts->resting_count; i++) {
        const resting_parts *resting = &parts->resting[i];
        if (!settings_check(reader, v, &resting->axis.keys)) return;
        if (resting->course && !course_check(reader, v, resting->course)) return;
    }
    for (size_t c = 0; c < parts->condition_count; c++) {
        given[c] = condition_values(reader, v, &parts->conditions[c]);
        if (!given[c]) return;
    }
    for (size_t i = 0; i < parts->resting_count; i++) {
        if (parts->condition_count == 0) make_one(reader, v, parts, &parts->resting[i], NULL, NULL, result);
        for (size_t c = 0; c < parts->condition_count; c++) {
            check_varied(reader, &parts->conditions[c], &parts->resting[i]);
            make_one(reader, v, parts, &parts->resting[i], &parts->conditions[c], given[c], result);
        }
    }
}
