// From a file to a checked case.
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arena.h"
#include "content.h"
#include "exhausted.h"
#include "file.h"
#include "path.h"
#include "plan.h"
#include "plan_asked.h"
#include "plan_batches.h"
#include "plan_dataset.h"
#include "plan_parts.h"
#include "plan_resting.h"
#include "plan_sensitivity.h"
#include "plan_tolerances.h"
#include "problem.h"
#include "schema.h"
#include "settings.h"
#include "source.h"
#include "tree.h"
#include "utf8.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/ensemble.h"
#include "whirl/status.h"

// ---------------------------------------------------------------- checks with values

/// Limit of the effort to check points of the study before the run, in characters of evaluated expressions; an element
/// or station counts as ELEMENT_COST characters.
enum { CHECK_BUDGET = 1 << 18, ELEMENT_COST = 64 };

/// Number of points between the ends of a sweep, or between the corners of a map, whose machines are built before the
/// run.
enum { INNER_POINTS = 7 };

/// Checks of machines at points of the study.
typedef struct point_check {
    case_reader *reader;
    case_content *content;
    const plan_parts *parts;
    whirl_rotor *first; ///< the first moving machine, whose states all moving machines must have; or NULL
} point_check;

/// Builds the machine of a point as a run does, and makes the same requests.
static whirl_status check_machine(point_check *check, size_t index, valuation *v) {
    case_content *content = check->content;
    const whirl_batch *batch = &content->plan.batches[index];
    whirl_rotor *rotor = NULL;
    whirl_status status = machine_build(&content->machine, v, plan_moves(batch), &rotor);
    if (status.code == WHIRL_OK) status = plan_check_speed(batch, whirl_rotor_speed(rotor));
    if (status.code == WHIRL_OK && plan_moves(batch) && check->first)
        status = whirl_ensemble_check(whirl_rotor_system(check->first), whirl_rotor_system(rotor));
    if (status.code == WHIRL_OK) plan_check_start(check->reader, &content->plan, index, v, &content->machine, rotor);
    if (status.code == WHIRL_OK)
        plan_raise_order(check->parts, whirl_rotor_system(rotor), &content->plan.batches[index]);
    if (status.code == WHIRL_OK && plan_moves(batch) && !check->first)
        check->first = rotor;
    else
        whirl_rotor_free(rotor);
    return status;
}

static void check_machine_at(point_check *check, size_t index, const file_node *where, size_t point) {
    valuation v;
    case_reader *reader = check->reader;
    const parameter_table *parameters = &check->content->parameters;
    whirl_given given[PLAN_MAX_GIVEN];
    const size_t count = plan_given_at(&check->content->plan.batches[index], point, given);
    whirl_status status = valuation_open(&v, parameters, given, count);
    if (status.code == WHIRL_OK) status = check_machine(check, index, &v);
    valuation_close(&v);
    reader->no_memory = reader->no_memory || status.code == WHIRL_NO_MEMORY;
    if (status.code == WHIRL_OK) return;
    char at[PLAN_GIVEN_TEXT];
    given_text(parameters, given, count, at, sizeof at);
    problem_at(reader->problems, where, "gives no machine at %s: %s", at, status.message);
}

/// Returns true if an earlier batch at rest has already checked the same machine, at one of its ends: same conditions,
/// same parameter, and no problem so far.
static bool is_checked(const case_reader *reader, const study_plan *plan, size_t index, size_t point) {
    const whirl_batch *own = &plan->batches[index];
    const whirl_kind *kind = whirl_analysis_kind(own->analyses);
    for (size_t b = 0; b < index && !kind->moves && !kind->found && reader->problems->count == 0; b++) {
        const whirl_batch *other = &plan->batches[b];
        if (whirl_analysis_kind(other->analyses) != kind || !other->values || other->given != own->given) continue;
        if (strcmp(other->parameter, own->parameter) != 0) continue;
        if (other->values[0] == own->values[point] || other->values[other->count - 1] == own->values[point])
            return true;
    }
    return false;
}

/// Checks the ends of a sweep, or the corners of a map, which has more than one row or plane.
static void check_corners(point_check *check, size_t b) {
    const study_plan *plan = &check->content->plan;
    const whirl_batch *batch = &plan->batches[b];
    const plan_origin *origin = &plan->origins[b];
    const size_t row = batch->row > 0 ? batch->row : batch->count;
    if (!is_checked(check->reader, plan, b, 0)) check_machine_at(check, b, origin->first, 0);
    if (!is_checked(check->reader, plan, b, row - 1)) check_machine_at(check, b, origin->last, row - 1);
    if (batch->row == 0 || check->reader->problems->count > 0) return;
    const size_t plane = batch->plane > 0 ? batch->plane : batch->count;
    check_machine_at(check, b, origin->across, plane - row);
    check_machine_at(check, b, origin->across, plane - 1);
    if (batch->plane == 0) return;
    check_machine_at(check, b, origin->planes, batch->count - plane);
    check_machine_at(check, b, origin->planes, batch->count - 1);
}

/// Checks the ends of a sweep, or the corners of a map, and some points between them; failures at other points appear
/// during the run.
static void check_points(case_reader *reader, case_content *content, const plan_parts *parts) {
    const size_t members = content->machine.stations.count + content->machine.element_count;
    const size_t affordable = CHECK_BUDGET / (reader->expression_bytes + ELEMENT_COST * members + 1) + 2;
    const size_t inner = affordable - 2 < INNER_POINTS ? affordable - 2 : INNER_POINTS;
    point_check check = {.reader = reader, .content = content, .parts = parts};
    for (size_t b = 0; b < content->plan.batch_count; b++) {
        const whirl_batch *batch = &content->plan.batches[b];
        const plan_origin *origin = &content->plan.origins[b];
        if (!batch->values) continue;
        for (size_t i = 0; origin->each && i < batch->count && i < affordable; i++)
            check_machine_at(&check, b, origin->each[i], i);
        if (origin->each) continue;
        check_corners(&check, b);
        for (size_t i = 1, last = 0; i <= inner && reader->problems->count == 0; i++) {
            const size_t point = i * (batch->count - 1) / (inner + 1);
            if (point > last) check_machine_at(&check, b, origin->first, point);
            last = point;
        }
    }
    whirl_rotor_free(check.first);
}

/// Checks that the machines of a basin differ only in their initial state.
static void check_basin(case_reader *reader, const case_content *content, const plan_parts *parts) {
    const axis_parts *const axes[] = {&parts->sweep, &parts->across, &parts->planes};
    if (parts->map.group != &schema_basin) return;
    for (size_t i = 0; i < 3 && axes[i]->parameter; i++) {
        const setting *use = case_machine_use(content, axes[i]->parameter->name);
        if (!use) continue;
        char path[PATH_SIZE];
        node_path(use->place, path, sizeof path);
        problem_at(reader->problems, settings_find(&axes[i]->keys, "parameter")->place,
                   "is %s, on which the machine depends (%.200s), expected a parameter of the initial state alone",
                   axes[i]->parameter->name, path);
    }
}

/// Reports why a static analysis is impossible.
static void check_statics(case_reader *reader, case_content *content, size_t index, valuation *v) {
    const size_t stations = content->machine.stations.count;
    const whirl_batch *batch = &content->plan.batches[index];
    double *influence = calloc(stations * stations + 1, sizeof *influence);
    whirl_station_statics *statics = calloc(stations + 1, sizeof *statics);
    reader->no_memory = reader->no_memory || !influence || !statics;
    if (!reader->no_memory) {
        const whirl_status status = machine_statics(&content->machine, v, batch->record.coupling, statics, influence);
        reader->no_memory = status.code == WHIRL_NO_MEMORY;
        if (status.code == WHIRL_BAD_INPUT)
            problem_at(reader->problems, content->plan.origins[index].place, "%s", status.message);
    }
    free(influence);
    free(statics);
}

/// Returns true if a batch needs the static analysis.
static bool needs_statics(const whirl_batch *batch) {
    return whirl_analysis_has(batch->analyses, "statics") || batch->record.antinodes_of > 0 || *batch->record.placed_at;
}

/// Returns true if an earlier batch of the same study, under another condition, has asked for the same static analysis.
static bool is_weighed(const study_plan *plan, size_t index) {
    for (size_t b = 0; b < index; b++)
        if (needs_statics(&plan->batches[b]) && plan->origins[b].place == plan->origins[index].place) return true;
    return false;
}

/// Checks layouts of the analyses (too many fields, missing records), and the behaviour of moving machines.
static void check_layouts(case_reader *reader, case_content *content, plan_parts *parts, valuation *v) {
    whirl_rotor *rotor = NULL;
    bool built_to_move = false;
    asked_parts *limits = &parts->tolerances.asked, *derived = &parts->sensitivity.asked;
    for (size_t b = 0; b < content->plan.batch_count; b++) {
        whirl_layout layout;
        const whirl_batch *batch = &content->plan.batches[b];
        whirl_status status = whirl_ok();
        // Machines of motions and of studies at rest differ by states.
        if (!rotor || plan_moves(batch) != built_to_move) {
            whirl_rotor_free(rotor);
            built_to_move = plan_moves(batch);
            status = machine_build(&content->machine, v, built_to_move, &rotor);
        }
        if (status.code != WHIRL_OK) {
            problem_at(reader->problems, content->plan.origins[b].place, "%s", status.message);
            continue;
        }
        // Check the layout, the record, the initial state and the statics of the batch.
        plan_raise_order(parts, whirl_rotor_system(rotor), &content->plan.batches[b]);
        plan_lower_tolerance(parts, whirl_rotor_system(rotor), &content->plan.batches[b]);
        status = whirl_analysis_check(whirl_rotor_system(rotor), batch->analyses);
        if (status.code == WHIRL_OK)
            status = whirl_layout_new(whirl_rotor_system(rotor), &batch->integrate, &batch->record, batch->analyses,
                                      &layout);
        if (status.code == WHIRL_OK)
            status = whirl_record_check(whirl_rotor_system(rotor), &batch->integrate, &batch->record);
        if (status.code != WHIRL_OK) problem_at(reader->problems, content->plan.origins[b].place, "%s", status.message);
        if (status.code == WHIRL_OK && batch->role == WHIRL_ROLE_TOLERANCES)
            asked_check(reader, limits, batch, &layout, &content->machine, rotor, false);
        if (status.code == WHIRL_OK && batch->derivatives)
            asked_check(reader, derived, batch, &layout, &content->machine, rotor, true);
        if (!batch->values) plan_check_start(reader, &content->plan, b, v, &content->machine, rotor);
        if (needs_statics(batch) && !is_weighed(&content->plan, b)) check_statics(reader, content, b, v);
    }
    if (parts->tolerances.keys.place) asked_report_unfound(reader, limits);
    if (parts->sensitivity.keys.place) asked_report_unfound(reader, derived);
    whirl_rotor_free(rotor);
}

static void check_with_values(case_reader *reader, case_content *content, plan_parts *parts) {
    // Evaluate the parameters.
    valuation v;
    const whirl_status status = valuation_open(&v, &content->parameters, NULL, 0);
    reader->no_memory = reader->no_memory || status.code == WHIRL_NO_MEMORY;
    // Make machine and plan with these values, which reports what does not fit.
    if (status.code == WHIRL_OK) {
        machine_check(reader, &v, &content->machine);
        plan_make(reader, &v, parts, &content->plan);
        resting_make(reader, &v, parts, &content->plan);
        dataset_make(reader, &v, parts, &content->plan);
        tolerances_make(reader, &v, parts, &content->plan);
        sensitivity_make(reader, &v, parts, &content->plan);
        check_basin(reader, content, parts);
        parameters_settle(&v, &content->parameters);
        machine_settle(&v, &content->machine);
        if (reader->problems->count == 0) check_layouts(reader, content, parts, &v);
        // Report the parameter whose expression has no value.
    } else if (v.evaluator && v.culprit < content->parameters.count) {
        char why[WHY_SIZE];
        const parameter *culprit = &content->parameters.items[v.culprit];
        double value;
        evaluator_value(v.evaluator, culprit->value.expression, &value, why);
        problem_at(reader->problems, culprit->place, "%s", why);
    }
    // Try single points last, when everything before is right.
    valuation_close(&v);
    if (reader->problems->count == 0 && !reader->no_memory) check_points(reader, content, parts);
}

// ---------------------------------------------------------------- reading

/// Rejects a file of another version, whose meaning is unknown.
static bool is_known_version(case_reader *reader, const setting_list *file) {
    const setting *version = settings_find(file, "whirl");
    if (!version || !version->good) return true;
    if (!version->value.expression && version->value.number == (double)SCHEMA_VERSION) return true;
    char shown[SHOWN_SIZE];
    problem_at(reader->problems, version->place, "is %s, expected %d, the version of the format that this whirl reads",
               node_shown(version->place, shown), SCHEMA_VERSION);
    return false;
}

/// Returns true if the study has an analysis for a shaft at speed 0. Motions need a speed, since they are counted in
/// revolutions.
static bool may_stand_still(const setting *study) {
    if (!study || study->place->kind != NODE_MAPPING) return false;
    for (const whirl_analysis *one = whirl_analyses(); one->name; one++)
        if (one->kind->still && node_member(study->place, one->name)) return true;
    return false;
}

static void read_content(case_reader *reader, const file_node *root, void *into) {
    case_content *content = into;
    setting_list file;
    plan_parts parts = {0};
    char shown[SHOWN_SIZE];
    const parameter_table none = {0};
    content->root = root;
    // Check the file as a whole: its keys and its version.
    if (root->kind != NODE_MAPPING) {
        problem_at(reader->problems, root, "is %s, expected a mapping that begins with whirl: %d",
                   node_shown(root, shown), SCHEMA_VERSION);
        return;
    }
    reader->parameters = &none;
    settings_read(reader, root, &schema_case, &file);
    if (reader->no_memory || !is_known_version(reader, &file)) return;
    // Read the title and the document data.
    settings_text(reader, &file, "title", content->title, sizeof content->title);
    const setting *document = settings_find(&file, "document");
    if (document) settings_read(reader, document->place, &schema_document, &content->document);
    if (reader->no_memory) return;
    for (size_t i = 0; i < content->document.count; i++) {
        char text[DOCUMENT_TEXT];
        settings_text(reader, &content->document, content->document.items[i].key->name, text, sizeof text);
    }
    // Read the parameters, then the parts whose expressions use them.
    const setting *given = settings_find(&file, "parameters");
    parameters_read(reader, given ? given->place : NULL, content->overrides, content->override_count,
                    &content->parameters);
    reader->parameters = &content->parameters;
    const setting *rotor = settings_find(&file, "rotor"), *study = settings_find(&file, "study");
    if (rotor && !reader->no_memory) machine_read(reader, rotor->place, may_stand_still(study), &content->machine);
    if (study && !reader->no_memory) plan_read_parts(reader, study->place, &content->machine, &parts, &content->plan);
    if (study && !reader->no_memory) resting_read(reader, &content->machine, &parts);
    if (study && !reader->no_memory) dataset_read(reader, &content->machine, &parts);
    if (study && !reader->no_memory) tolerances_read(reader, &parts);
    if (study && !reader->no_memory) sensitivity_read(reader, &parts);
    if (study && !reader->no_memory) settings_units(reader, &parts.study, content->units, sizeof content->units);
    if (reader->no_memory) return;
    // Check with values, or without if some values are unknown.
    if (reader->problems->count == 0)
        check_with_values(reader, content, &parts);
    else
        machine_check_alone(reader, &content->machine);
}

/// Fills `content`, whose overrides are set, from the text of the case.
static whirl_status make_content(const whirl_case *object, case_content *content, whirl_problems *problems) {
    case_reader reader = {.arena = &content->arena, .problems = problems};
    return file_read(&reader, object->text, object->length, object->name, read_content, content);
}

static whirl_case *new_case(const char *text, size_t length, const char *name) {
    whirl_case *object = calloc(1, sizeof *object);
    if (!object) return NULL;
    // A text that is too long is refused without a copy of it.
    object->length = length;
    object->text = malloc(length + 1);
    if (!object->text) {
        free(object);
        return NULL;
    }
    if (length > 0) memcpy(object->text, text, length);
    object->text[length] = '\0';
    snprintf(object->name, sizeof object->name, "%s", name);
    return object;
}

whirl_status whirl_case_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                              whirl_case **out) {
    whirl_problems own = {0};
    *out = NULL;
    if (!problems) problems = &own;
    text = utf8_skip_mark(text, &length);
    if (length > TREE_MAX_BYTES) length = TREE_MAX_BYTES + 1; // the reader rejects a text of this length
    whirl_case *object = new_case(text, length, name);
    if (!object) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %.200s", name);
    const whirl_status status = make_content(object, &object->content, problems);
    whirl_problems_free(&own);
    if (status.code != WHIRL_OK)
        whirl_case_free(object);
    else
        *out = object;
    return status;
}

whirl_status whirl_case_load(const char *path, whirl_problems *problems, whirl_case **out) {
    char *text;
    size_t length;
    *out = NULL;
    whirl_status status = source_load(path, problems, &text, &length);
    if (status.code == WHIRL_OK) status = whirl_case_parse(text, length, path, problems, out);
    free(text);
    return status;
}

void whirl_case_free(whirl_case *object) {
    if (!object) return;
    arena_free(&object->content.arena);
    free(object->text);
    free(object);
}

// ---------------------------------------------------------------- setting parameters and keys

/// Limits of a name and of a value (an expression), in bytes.
enum { SHOWN_NAME = 128, LONGEST_VALUE = 8192 };

/// Copies the overrides into the arena of the new content, with one more if `name` is given.
static bool copy_overrides(const case_content *old, case_content *content, const char *name, const char *text) {
    parameter_override *all = arena_take(&content->arena, (old->override_count + 1) * sizeof *all);
    if (!all) return false;
    size_t count = 0;
    const parameter_override added = {.name = name, .text = text};
    for (size_t i = 0; i <= old->override_count; i++) {
        const parameter_override *one = i < old->override_count ? &old->overrides[i] : &added;
        if (!one->name || (one != &added && name && strcmp(one->name, name) == 0)) continue; // none, or replaced
        all[count].name = arena_text(&content->arena, one->name, strlen(one->name));
        all[count].text = arena_text(&content->arena, one->text, strlen(one->text));
        if (!all[count].name || !all[count].text) return false;
        count++;
    }
    content->overrides = all;
    content->override_count = count;
    return true;
}

/// Finds the length of the name before '=', without blanks.
static whirl_status split_assignment(const char *assignment, size_t *length) {
    const char *equals = strchr(assignment, '=');
    if (!equals || equals == assignment)
        return whirl_fail(WHIRL_BAD_INPUT, "'%.80s' sets nothing, expected NAME=VALUE", assignment);
    *length = (size_t)(equals - assignment);
    while (*length > 1 && assignment[*length - 1] == ' ') --*length;
    return whirl_ok();
}

/// Returns the problem of a value given outside of the file without file and line.
static whirl_status without_file(const whirl_problems *problems, const whirl_status *status) {
    if (!problems->items || problems->count == 0 || problems->items[0].line > 0 || !problems->items[0].key[0])
        return *status;
    return whirl_fail(status->code, "%s: %s", problems->items[0].key, problems->items[0].message);
}

/// Returns the values that a batch gives to a parameter; NULL if it does not vary it.
static const double *values_of(const whirl_batch *batch, const char *name) {
    if (strcmp(batch->parameter, name) == 0) return batch->values;
    if (strcmp(batch->second, name) == 0) return batch->second_values;
    return strcmp(batch->third, name) == 0 ? batch->third_values : NULL;
}

/// Refuses to set a swept parameter, unless the study's values depend on it.
static whirl_status refuse_swept(const study_plan *old, const study_plan *new, const char *name) {
    const double *values = NULL;
    for (size_t b = old->batch_count; b-- > 0;) {
        values = values_of(&old->batches[b], name);
        const double *now = values ? values_of(&new->batches[b], name) : NULL;
        if (!now || old->batches[b].count != new->batches[b].count) return whirl_ok();
        for (size_t i = 0; i < old->batches[b].count; i++)
            if (now[i] != values[i]) return whirl_ok();
    }
    const whirl_batch *sweep = &old->batches[0];
    return values ? whirl_fail(WHIRL_BAD_INPUT,
                               "the study sweeps %s from %.10g to %.10g, so that setting it changes nothing; change %s "
                               "in the case, or write response: {} in its place",
                               name, values[0], values[sweep->count - 1], sweep->name)
                  : whirl_ok();
}

static whirl_status check_value(const char *name, const char *value) {
    whirl_problems problems = {0};
    source_check(value, strlen(value), &problems);
    const bool good = problems.count == 0;
    whirl_problems_free(&problems);
    return good ? whirl_ok() : whirl_fail(WHIRL_BAD_INPUT, "the value of %s is not text in UTF-8", name);
}

static void take_content(whirl_case *object, const case_content *content) {
    arena_free(&object->content.arena);
    object->content = *content;
}

/// Overrides a parameter; a swept one only if `swept_too`.
static whirl_status set_parameter(whirl_case *object, const char *name, const char *value, bool swept_too) {
    case_content content = {0};
    whirl_problems problems = {0};
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "no memory to set %s", name);
    if (copy_overrides(&object->content, &content, name, value)) status = make_content(object, &content, &problems);
    if (status.code == WHIRL_OK && !swept_too) status = refuse_swept(&object->content.plan, &content.plan, name);
    if (status.code == WHIRL_OK)
        take_content(object, &content);
    else
        status = without_file(&problems, &status);
    if (status.code != WHIRL_OK) arena_free(&content.arena);
    whirl_problems_free(&problems);
    return status;
}

/// Sets a key in the text of the case, which is stored in the result.
static whirl_status set_key(whirl_case *object, const char *name, const char *value) {
    char path[PATH_SIZE];
    // Edit a copy of the text, and read it again.
    whirl_case changed = *object;
    whirl_problems problems = {0};
    changed.content = (case_content){0};
    whirl_status status = path_of_name(&object->content, name, path);
    if (status.code != WHIRL_OK) return status;
    status = whirl_case_edit(object->text, object->length, path, value, &changed.text);
    if (status.code != WHIRL_OK) return status;
    changed.length = strlen(changed.text);
    if (copy_overrides(&object->content, &changed.content, NULL, NULL))
        status = make_content(&changed, &changed.content, &problems);
    else
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to set %s", name);
    // Replace the case, or report why the changed text is no case.
    if (status.code == WHIRL_OK) {
        free(object->text);
        arena_free(&object->content.arena);
        *object = changed;
    } else {
        if (status.code == WHIRL_BAD_INPUT && problems.items)
            status = whirl_fail(status.code, "%s: %s", problems.items[0].key, problems.items[0].message);
        free(changed.text);
        arena_free(&changed.content.arena);
    }
    whirl_problems_free(&problems);
    return status;
}

static whirl_status set_name(whirl_case *object, const char *assignment, bool swept_too) {
    // Split the assignment into name and value, without blanks around.
    const parameter_table *parameters = &object->content.parameters;
    char name[SHOWN_NAME], text[LONGEST_VALUE], advice[WHY_SIZE];
    size_t length = 0;
    whirl_status status = split_assignment(assignment, &length);
    if (status.code != WHIRL_OK) return status;
    snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), assignment);
    const char *value = strchr(assignment, '=') + 1;
    value += strspn(value, " ");
    size_t used = strlen(value);
    while (used > 0 && value[used - 1] == ' ') used--;
    if (used >= sizeof text) return whirl_fail(WHIRL_BAD_INPUT, "the value of %s is too long", name);
    snprintf(text, sizeof text, "%.*s", (int)used, value);
    // Check value and name before anything is searched.
    status = check_value(name, text);
    if (status.code != WHIRL_OK) return status;
    if (length >= sizeof name) return whirl_fail(WHIRL_BAD_INPUT, "%.60s... is too long for a name", name);
    // Set a parameter, or else a key of the case.
    if (parameters_find(parameters, name) < parameters->count) return set_parameter(object, name, text, swept_too);
    if (strncmp(name, "parameters.", 11) == 0 && parameters_find(parameters, name + 11) < parameters->count)
        return set_parameter(object, name + 11, text, swept_too);
    if (strchr(name, '.')) return set_key(object, name, text);
    // Explain what the name could mean.
    if (whirl_group_key(&schema_rotor, name))
        return whirl_fail(WHIRL_BAD_INPUT, "no parameter is called %s, did you mean rotor.%s?", name, name);
    describe_names(name, parameters->names, parameters->count, advice);
    return whirl_fail(WHIRL_BAD_INPUT, "no parameter is called %s, %s", name, advice);
}

whirl_status whirl_case_set(whirl_case *object, const char *assignment) {
    return set_name(object, assignment, false);
}

whirl_status whirl_case_assign(whirl_case *object, const char *assignment) {
    return set_name(object, assignment, true);
}

// ---------------------------------------------------------------- asking

const char *whirl_case_title(const whirl_case *object) {
    return object->content.title;
}

whirl_status whirl_case_parameter(const whirl_case *object, const char *name, double *value) {
    const parameter_table *parameters = &object->content.parameters;
    const size_t index = parameters_find(parameters, name);
    char advice[WHY_SIZE];
    if (index == parameters->count) {
        describe_names(name, parameters->names, parameters->count, advice);
        return whirl_fail(WHIRL_BAD_INPUT, "no parameter is called %.63s, %s", name, advice);
    }
    valuation v;
    const whirl_status status = valuation_open(&v, parameters, NULL, 0);
    *value = status.code == WHIRL_OK ? v.values[index] : NAN;
    valuation_close(&v);
    return status;
}

/// Completes the built outline to a rotor, or frees it after a failure.
static whirl_status hold(whirl_status status, whirl_rotor **rotor) {
    if (status.code == WHIRL_OK) status = whirl_rotor_hold(*rotor, NULL);
    if (status.code == WHIRL_OK) return status;
    whirl_rotor_free(*rotor);
    *rotor = NULL;
    return status;
}

whirl_status whirl_case_element(const whirl_case *object, const char *element, whirl_rotor **rotor) {
    valuation v;
    *rotor = NULL;
    const int before = exhausted_watch();
    whirl_status status = valuation_open(&v, &object->content.parameters, NULL, 0);
    if (status.code == WHIRL_OK) status = machine_build_element(&object->content.machine, &v, element, rotor);
    status = hold(status, rotor);
    if (status.code != WHIRL_OK && exhausted(before)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an element");
    valuation_close(&v);
    return status;
}

static bool any_moves(const study_plan *plan) {
    for (size_t b = 0; b < plan->batch_count; b++)
        if (plan_moves(&plan->batches[b])) return true;
    return false;
}

whirl_status whirl_case_rotor(const whirl_case *object, const char *name, double value, whirl_rotor **rotor) {
    return hold(whirl_case_rotor_outline(object, name, value, rotor), rotor);
}

whirl_status whirl_case_rotor_outline(const whirl_case *object, const char *name, double value, whirl_rotor **rotor) {
    const whirl_given given = {name, value};
    valuation v;
    *rotor = NULL;
    const int before = exhausted_watch();
    whirl_status status = valuation_open(&v, &object->content.parameters, &given, name && *name ? 1 : 0);
    if (status.code == WHIRL_OK)
        status = machine_build(&object->content.machine, &v, any_moves(&object->content.plan), rotor);
    if (status.code != WHIRL_OK && exhausted(before)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor");
    valuation_close(&v);
    return status;
}

whirl_status whirl_case_model(const whirl_case *object, whirl_model *out) {
    valuation v;
    *out = (whirl_model){0};
    whirl_status status = valuation_open(&v, &object->content.parameters, NULL, 0);
    if (status.code == WHIRL_OK) status = machine_model(&object->content.machine, &v, out);
    valuation_close(&v);
    return status;
}

whirl_status whirl_case_shafts(const whirl_case *object, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count) {
    valuation v;
    *count = 0;
    whirl_status status = valuation_open(&v, &object->content.parameters, NULL, 0);
    if (status.code == WHIRL_OK) status = machine_shafts(&object->content.machine, &v, out, count);
    valuation_close(&v);
    return status;
}
