#include "machine.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "problem.h"
#include "schema.h"
#include "tree.h"

size_t named_find(const named_list *in, const char *name) {
    for (size_t i = 0; i < in->count; i++)
        if (strcmp(in->names[i], name) == 0) return i;
    return in->count;
}

// ---------------------------------------------------------------- parts with names

/// A kind of parts, as messages name it.
typedef struct part_kind {
    const char *one, *all;
    const whirl_group *group;
    size_t most;
} part_kind;

static bool is_name(const char *name) {
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-') return false;
    return name[0] && strlen(name) < WHIRL_NAME_SIZE;
}

/// Returns true for a valid name of a part; "ground" is reserved, since it may appear instead of a station.
static bool is_usable(const char *name) {
    return is_name(name) && strcmp(name, "ground") != 0;
}

static void check_name(case_reader *reader, const file_node *where, const part_kind *kind) {
    if (strcmp(where->key, "ground") == 0)
        problem_at_key(reader->problems, where, "is the name of the ground, expected another name");
    else if (!is_name(where->key))
        problem_at_key(reader->problems, where, "is no name for a %s, expected letters, digits, '_' and '-'",
                       kind->one);
}

static void read_named(case_reader *reader, const file_node *where, const part_kind *kind, named_list *result) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_MAPPING || where->count == 0) {
        problem_at(reader->problems, where, "is %s, expected names of %s with their keys",
                   node_is_null(where) || where->kind == NODE_MAPPING ? "empty" : node_shown(where, shown), kind->all);
        return;
    }
    if (where->count > kind->most)
        problem_at(reader->problems, where, "has %zu %s, expected at most %zu", where->count, kind->all, kind->most);
    result->items = arena_take(reader->arena, kind->most * sizeof *result->items);
    result->names = arena_take(reader->arena, kind->most * sizeof *result->names);
    reader->no_memory = reader->no_memory || !result->items || !result->names;
    if (reader->no_memory) return;
    for (const file_node *member = where->first; member; member = member->next) {
        if (named_find(result, member->key) < result->count) continue; // a duplicate name
        if (result->count == kind->most) break;
        const size_t i = result->count++;
        result->names[i] = member->key;
        check_name(reader, member, kind);
        settings_read(reader, member, kind->group, &result->items[i]);
        result->items[i].name = member->key;
    }
}

static void read_parts(case_reader *reader, machine_parts *result) {
    const part_kind stations = {"station", "stations", whirl_station_keys(), WHIRL_MAX_STATIONS};
    const part_kind shafts = {"shaft", "shafts", whirl_shaft_keys(), WHIRL_MAX_SHAFTS};
    const part_kind materials = {"material", "materials", whirl_material_keys(), WHIRL_MAX_MATERIALS};
    const setting *given[] = {settings_find(&result->rotor, "stations"), settings_find(&result->rotor, "shafts"),
                              settings_find(&result->rotor, "materials")};
    if (given[0]) read_named(reader, given[0]->place, &stations, &result->stations);
    if (given[1]) read_named(reader, given[1]->place, &shafts, &result->shafts);
    if (given[2]) read_named(reader, given[2]->place, &materials, &result->materials);
}

/// Checks names of shafts and materials in the settings of a part.
static bool check_names(case_reader *reader, const machine_parts *machine, const setting_list *part) {
    bool good = true;
    for (size_t i = 0; i < part->count; i++) {
        char shown[SHOWN_SIZE], advice[WHY_SIZE];
        const setting *item = &part->items[i];
        if (!item->good || item->key->kind != WHIRL_KEY_NAME) continue;
        const bool of_shafts = strcmp(item->key->choices, "shafts") == 0;
        const named_list *in = of_shafts ? &machine->shafts : &machine->materials;
        if (named_find(in, item->word) < in->count || (!of_shafts && strcmp(item->word, "steel") == 0)) continue;
        good = false;
        describe_names(item->word, in->names, in->count, advice);
        problem_at(reader->problems, item->place, "is %s, which is no %s, %s", text_shown(item->word, shown),
                   of_shafts ? "shaft" : "material",
                   in->count > 0 ? advice
                   : of_shafts   ? "expected a name of shafts"
                                 : "expected steel");
    }
    return good;
}

// ---------------------------------------------------------------- elements

void machine_advise(const machine_parts *machine, const char *word, bool ground, char advice[WHY_SIZE]) {
    const char *names[WHIRL_MAX_STATIONS + 1];
    size_t count = 0;
    for (size_t i = 0; i < machine->stations.count; i++)
        if (is_usable(machine->stations.names[i])) names[count++] = machine->stations.names[i];
    if (count == 0)
        snprintf(advice, WHY_SIZE, "expected the name of a station");
    else if (ground)
        names[count++] = "ground";
    if (count > 0) describe_names(word, names, count, advice);
}

static bool check_station(case_reader *reader, const machine_parts *machine, const file_node *where, const char *name,
                          bool ground) {
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    if (named_find(&machine->stations, name) < machine->stations.count || (ground && strcmp(name, "ground") == 0))
        return true;
    if (!reader_reports(reader, "station", name)) return false;
    machine_advise(machine, name, ground, advice);
    problem_at(reader->problems, where, "is %s, which is no station, %s", text_shown(name, shown), advice);
    return false;
}

/// Checks both stations of a list, and reports each at its place.
static bool check_pair(case_reader *reader, const machine_parts *machine, const setting *pair) {
    const file_node *place = pair->place;
    if (place->kind == NODE_LIST) {
        const bool first = check_station(reader, machine, place->first, place->first->text, true);
        return check_station(reader, machine, place->first->next, place->first->next->text, true) && first;
    }
    const char *text = pair->word;
    bool good = true;
    for (int i = 0; i < 2; i++) {
        char name[WHIRL_NAME_SIZE];
        text += strspn(text, " ,");
        const size_t length = strcspn(text, " ,");
        snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), text);
        good = check_station(reader, machine, place, name, true) && good;
        text += length;
    }
    return good;
}

static bool check_stations(case_reader *reader, const machine_parts *machine, const setting_list *element) {
    bool good = true;
    if (machine->stations.count == 0) return true; // has been reported
    for (size_t i = 0; i < element->count; i++) {
        const setting *item = &element->items[i];
        if (!item->good) continue;
        if (item->key->kind == WHIRL_KEY_STATION)
            good = check_station(reader, machine, item->place, item->word, false) && good;
        if (item->key->kind == WHIRL_KEY_STATIONS) good = check_pair(reader, machine, item) && good;
    }
    return good;
}

static void report_unknown_element(case_reader *reader, const file_node *where, const char *kind) {
    const char *names[SETTINGS_MAX];
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    size_t count = 0;
    for (const whirl_group *const *group = whirl_element_groups(); *group && count < SETTINGS_MAX; group++)
        names[count++] = (*group)->name;
    describe_names(kind, names, count, advice);
    problem_at_key(reader->problems, where, "no element is called %s, %s", text_shown(kind, shown), advice);
}

/// Reads an element: a kind with its keys, or a kind alone with their defaults, such as "- gravity".
static void read_element(case_reader *reader, const file_node *item, machine_parts *result) {
    // Find the kind: an item is one kind with its keys, or a kind alone.
    char shown[SHOWN_SIZE];
    const bool bare = item->kind == NODE_TEXT && !item->quoted && whirl_element_group(item->text);
    if (!bare && (item->kind != NODE_MAPPING || item->count != 1)) {
        problem_at(reader->problems, item, "is %s, expected one element behind every '- ': a kind with its keys",
                   item->kind == NODE_MAPPING ? item->count ? "more than one element" : "empty"
                                              : node_shown(item, shown));
        return;
    }
    const file_node *where = bare ? item : item->first;
    const char *kind = bare ? item->text : where->key;
    const whirl_group *group = whirl_element_group(kind);
    if (!group) {
        report_unknown_element(reader, where, kind);
        return;
    }
    // Read its keys; a kind alone has none.
    file_node nothing = *where;
    if (bare) nothing.text = "";
    const size_t problems = reader->problems->count;
    setting_list *element = &result->elements[result->element_count++];
    settings_read(reader, bare ? &nothing : where, group, element);
    element->place = where;
    // An element is sound if nothing about it was refused.
    element->sound = check_stations(reader, result, element) && check_names(reader, result, element) &&
                     reader->problems->count == problems;
    for (size_t i = 0; i < element->count; i++) element->sound = element->sound && element->items[i].good;
}

static void read_elements(case_reader *reader, const file_node *where, machine_parts *result) {
    char shown[SHOWN_SIZE];
    result->elements_place = where;
    if (node_is_null(where)) return;
    if (where->kind != NODE_LIST) {
        problem_at(reader->problems, where, "is %s, expected a list of elements: - shaft: {...}",
                   node_shown(where, shown));
        return;
    }
    if (where->count > WHIRL_MAX_ELEMENTS) {
        problem_at(reader->problems, where, "has %zu elements, expected at most %d", where->count, WHIRL_MAX_ELEMENTS);
        return;
    }
    result->elements = arena_take(reader->arena, (where->count + 1) * sizeof *result->elements);
    reader->no_memory = reader->no_memory || !result->elements;
    if (!result->elements) return;
    for (const file_node *item = where->first; item; item = item->next) read_element(reader, item, result);
}

void machine_read(case_reader *reader, const file_node *where, bool may_stand_still, machine_parts *result) {
    *result = (machine_parts){.elements_place = where};
    settings_read(reader, where, may_stand_still ? &schema_still_rotor : &schema_rotor, &result->rotor);
    const setting *elements = settings_find(&result->rotor, "elements");
    read_parts(reader, result);
    for (size_t i = 0; i < result->stations.count; i++) check_names(reader, result, &result->stations.items[i]);
    for (size_t i = 0; i < result->shafts.count; i++) check_names(reader, result, &result->shafts.items[i]);
    if (elements) read_elements(reader, elements->place, result);
}

// ---------------------------------------------------------------- building

static void settle_list(valuation *v, setting_list *list) {
    for (size_t i = 0; i < list->count; i++) {
        setting *item = &list->items[i];
        formula_settle(v, &item->value);
        for (size_t k = 0; k < item->entry_count; k++) formula_settle(v, &item->entries[k].value);
    }
}

void machine_settle(valuation *v, machine_parts *machine) {
    named_list *const named[] = {&machine->materials, &machine->shafts, &machine->stations};
    settle_list(v, &machine->rotor);
    for (size_t kind = 0; kind < 3; kind++)
        for (size_t i = 0; i < named[kind]->count; i++) settle_list(v, &named[kind]->items[i]);
    for (size_t i = 0; i < machine->element_count; i++) settle_list(v, &machine->elements[i]);
}

/// Input of the rotor layer: numbers in SI, and words.
typedef struct evaluated {
    whirl_setting values[SETTINGS_MAX];
    char *texts; ///< texts of lists with expressions, one after the other; or NULL
} evaluated;

/// Allocates the texts of lists with expressions. Returns false without memory.
static bool make_texts(const setting_list *settings, evaluated *out) {
    size_t size = 0;
    for (size_t i = 0; i < settings->count; i++)
        if (settings->items[i].entries) size += setting_list_size(&settings->items[i]);
    out->texts = size > 0 ? malloc(size) : NULL;
    return size == 0 || out->texts;
}

/// Evaluates settings; out->texts is freed by the caller, after a failure too.
static whirl_status evaluate(const setting_list *settings, valuation *v, evaluated *out) {
    if (!make_texts(settings, out)) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the lists of a machine");
    char *text = out->texts;
    for (size_t i = 0; i < settings->count && i < SETTINGS_MAX; i++) {
        const setting *item = &settings->items[i];
        out->values[i] = (whirl_setting){.key = item->key->name, .text = item->entries ? text : item->word};
        if (item->word) continue;
        const whirl_status status = item->entries ? setting_list_text(v, item, text)
                                                  : valuation_number(v, &item->value, &out->values[i].number);
        if (item->entries) text += setting_list_size(item);
        if (status.code == WHIRL_OK) continue;
        return whirl_fail(status.code, "%.63s.%s %.250s", settings->name, item->key->name, status.message);
    }
    return whirl_ok();
}

static whirl_status new_design(const machine_parts *machine, valuation *v, double speed, whirl_design **design) {
    *design = NULL;
    if (speed == 0.0) speed = settings_number(v, &machine->rotor, "speed");
    const double length = settings_number(v, &machine->rotor, "length_scale");
    if (speed < 0.0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "rotor.speed is %.10g rad/s, expected a number above 0, and rotation: clockwise for a rotor that turns "
            "from y to x",
            speed);
    const bool clockwise = strcmp(settings_word(&machine->rotor, "rotation"), "clockwise") == 0;
    return whirl_design_new(clockwise ? -speed : speed, length, design);
}

typedef whirl_status add_part_fn(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

static whirl_status add_parts(const named_list *parts, valuation *v, add_part_fn *add, whirl_design *design) {
    evaluated settings;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < parts->count && status.code == WHIRL_OK; i++) {
        status = evaluate(&parts->items[i], v, &settings);
        if (status.code == WHIRL_OK) status = add(design, parts->names[i], settings.values, parts->items[i].count);
        free(settings.texts);
    }
    return status;
}

static whirl_status add_element(const machine_parts *machine, size_t index, valuation *v, whirl_design *design) {
    evaluated settings;
    const setting_list *element = &machine->elements[index];
    whirl_status status = evaluate(element, v, &settings);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, element->name, settings.values, element->count);
    free(settings.texts);
    return status;
}

static whirl_status make_design(const machine_parts *machine, valuation *v, double speed, whirl_design **design) {
    whirl_status status = new_design(machine, v, speed, design);
    if (status.code == WHIRL_OK) status = add_parts(&machine->materials, v, whirl_design_material, *design);
    if (status.code == WHIRL_OK) status = add_parts(&machine->shafts, v, whirl_design_shaft, *design);
    if (status.code == WHIRL_OK) status = add_parts(&machine->stations, v, whirl_design_station, *design);
    for (size_t i = 0; i < machine->element_count && status.code == WHIRL_OK; i++)
        status = add_element(machine, i, v, *design);
    return status;
}

/// Builds the rotor and frees the design.
static whirl_status build_and_free(whirl_status status, whirl_design *design, whirl_rotor **rotor) {
    *rotor = NULL;
    if (status.code == WHIRL_OK) status = whirl_rotor_outline(design, rotor);
    whirl_design_free(design);
    return status;
}

static whirl_status make_chosen_design(const machine_parts *machine, valuation *v, double speed,
                                       const machine_choice *choice, whirl_design **design) {
    const whirl_status status = make_design(machine, v, speed, design);
    if (status.code != WHIRL_OK) return status;
    whirl_design_unbalances(*design, choice->placed_count, choice->placed);
    if (choice->in_time) whirl_design_in_time(*design);
    if (choice->spool_count > 0)
        whirl_design_spools(*design, choice->spool_count, choice->spool_speeds, choice->spools_vary);
    if (choice->asynchronous) whirl_design_frequency(*design, choice->frequency);
    whirl_design_drag(*design, choice->drag, choice->drag_at, choice->stages);
    return status;
}

whirl_status machine_build_with(const machine_parts *machine, valuation *v, double speed, const machine_choice *choice,
                                whirl_rotor **rotor) {
    whirl_design *design;
    const whirl_status status = make_chosen_design(machine, v, speed, choice, &design);
    return build_and_free(status, design, rotor);
}

whirl_status machine_line(const machine_parts *machine, valuation *v, double speed, const machine_choice *choice,
                          const char *couplings, whirl_shaft_line *out) {
    whirl_design *design;
    whirl_status status = make_chosen_design(machine, v, speed, choice, &design);
    if (status.code == WHIRL_OK) status = whirl_design_line(design, couplings, out);
    whirl_design_free(design);
    return status;
}

whirl_status machine_build(const machine_parts *machine, valuation *v, bool in_time, whirl_rotor **rotor) {
    return machine_build_with(machine, v, 0.0, &(machine_choice){.stages = 1.0, .in_time = in_time}, rotor);
}

whirl_status machine_build_on_springs(const machine_parts *machine, valuation *v, double speed, whirl_bearings what,
                                      double stiffness, whirl_rotor **rotor) {
    whirl_design *design;
    const whirl_status status = make_design(machine, v, speed, &design);
    if (status.code == WHIRL_OK) whirl_design_bearings(design, what, stiffness);
    return build_and_free(status, design, rotor);
}

/// Makes a design of the machine's stations, each with 1 kg, and nothing else.
static whirl_status new_stations(const machine_parts *machine, valuation *v, double speed, whirl_design **design) {
    const whirl_setting mass = {.key = "mass", .number = 1.0};
    whirl_status status = new_design(machine, v, speed, design);
    for (size_t i = 0; i < machine->stations.count && status.code == WHIRL_OK; i++)
        status = whirl_design_station(*design, machine->stations.names[i], &mass, 1);
    return status;
}

whirl_status machine_build_bearings(const machine_parts *machine, valuation *v, double speed, whirl_rotor **rotor) {
    whirl_design *design;
    whirl_status status = new_stations(machine, v, speed, &design);
    for (size_t i = 0; i < machine->element_count && status.code == WHIRL_OK; i++)
        if (whirl_element_is_bearing(machine->elements[i].name)) status = add_element(machine, i, v, design);
    if (status.code == WHIRL_OK) whirl_design_bearings(design, WHIRL_BEARINGS_ALONE, 0.0);
    return build_and_free(status, design, rotor);
}

whirl_status machine_statics(const machine_parts *machine, valuation *v, const char *couplings,
                             whirl_station_statics *out, double *influence) {
    whirl_design *design;
    whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) status = whirl_design_statics(design, couplings, out, influence);
    whirl_design_free(design);
    return status;
}

whirl_status machine_weight(const machine_parts *machine, valuation *v, whirl_weight *out) {
    whirl_design *design;
    const whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) *out = whirl_design_weight(design);
    whirl_design_free(design);
    return status;
}

whirl_status machine_doubts(const machine_parts *machine, valuation *v, whirl_design_tell *tell, void *context) {
    whirl_design *design;
    const whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) whirl_design_doubts(design, tell, context);
    whirl_design_free(design);
    return status;
}

/// Returns the index of an element by kind and number, "film[2]"; the number of elements if there is none.
static size_t find_element(const machine_parts *machine, const char *element) {
    const size_t length = strcspn(element, "[");
    size_t wanted = 1;
    if (element[length]) {
        char *end;
        wanted = strtoul(element + length + 1, &end, 10);
        if (wanted == 0 || strcmp(end, "]") != 0) return machine->element_count;
    }
    for (size_t i = 0; i < machine->element_count; i++)
        if (strlen(machine->elements[i].name) == length && strncmp(machine->elements[i].name, element, length) == 0 &&
            --wanted == 0)
            return i;
    return machine->element_count;
}

static whirl_status no_element(const machine_parts *machine, const char *element) {
    const char *names[WHIRL_MAX_ELEMENTS];
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    for (size_t i = 0; i < machine->element_count; i++) names[i] = machine->elements[i].name;
    describe_names(element, names, machine->element_count, advice);
    return whirl_fail(WHIRL_BAD_INPUT, "the case has no element %s, %s", text_shown(element, shown),
                      machine->element_count ? advice : "for it has none at all");
}

whirl_status machine_build_element(const machine_parts *machine, valuation *v, const char *element,
                                   whirl_rotor **rotor) {
    const size_t index = find_element(machine, element);
    whirl_design *design;
    *rotor = NULL;
    if (index == machine->element_count) return no_element(machine, element);
    whirl_status status = new_stations(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) status = add_element(machine, index, v, design);
    return build_and_free(status, design, rotor);
}

whirl_status machine_shafts(const machine_parts *machine, valuation *v, whirl_shaft_summary *out, size_t *count) {
    whirl_design *design;
    *count = 0;
    whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) status = whirl_design_shafts(design, out, count);
    whirl_design_free(design);
    return status;
}

whirl_status machine_model(const machine_parts *machine, valuation *v, whirl_model *out) {
    whirl_design *design;
    *out = (whirl_model){0};
    whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) status = whirl_design_model(design, out);
    whirl_design_free(design);
    return status;
}

// ---------------------------------------------------------------- checking

static bool machine_report(case_reader *reader, const file_node *where, const whirl_status *status) {
    reader->no_memory = reader->no_memory || status->code == WHIRL_NO_MEMORY;
    if (status->code != WHIRL_OK) problem_at_key(reader->problems, where, "%s", status->message);
    return status->code == WHIRL_OK;
}

static bool check_values(case_reader *reader, valuation *v, const machine_parts *machine) {
    bool good = settings_check(reader, v, &machine->rotor);
    const named_list *const named[] = {&machine->materials, &machine->shafts, &machine->stations};
    for (int kind = 0; kind < 3; kind++)
        for (size_t i = 0; i < named[kind]->count; i++)
            good = settings_check(reader, v, &named[kind]->items[i]) && good;
    for (size_t i = 0; i < machine->element_count; i++) good = settings_check(reader, v, &machine->elements[i]) && good;
    return good;
}

/// Receiver of a design's problems.
typedef struct teller {
    case_reader *reader;
    const machine_parts *machine;
} teller;

static void tell_of_element(void *context, size_t element, const whirl_status *status) {
    const teller *to = context;
    const bool known = element < to->machine->element_count;
    machine_report(to->reader, known ? to->machine->elements[element].place : to->machine->rotor.place, status);
}

/// Reports settings that contradict each other, each problem at its line.
static void check_together(case_reader *reader, valuation *v, const machine_parts *machine) {
    whirl_design *design;
    whirl_rotor *rotor = NULL;
    size_t problems = 0;
    teller to = {reader, machine};
    whirl_status status = make_design(machine, v, 0.0, &design);
    if (status.code == WHIRL_OK) {
        status = whirl_rotor_outline(design, &rotor);
        if (status.code == WHIRL_BAD_INPUT) {
            const whirl_status checked = whirl_rotor_check(design, tell_of_element, &to, &problems);
            if (checked.code != WHIRL_OK || problems > 0) status = checked;
        }
    }
    machine_report(reader, machine->elements_place, &status);
    whirl_rotor_free(rotor);
    whirl_design_free(design);
}

/// Returns a number that stands for an expression whose value may be unknown, within the key's range.
static double stand_in(const whirl_key *key, double number) {
    const whirl_range *range = &key->range;
    if (number > range->low && number < range->high) return number;
    if (isinf(range->low) || isinf(range->high)) return isinf(range->low) ? range->high - number : range->low + number;
    // Between two bounds take an even number: counts of poles have to be even.
    const double middle = 0.5 * (range->low + range->high), even = 2.0 * floor(0.5 * middle);
    return even > range->low ? even : middle;
}

/// Builds a rotor of the element alone, with stations of 1 kg and 1 kg m2 that move in all directions, unless they lie
/// on its shaft. `number` stands for expressions.
static whirl_status build_alone(const machine_parts *machine, const setting_list *element, double number) {
    const whirl_setting unit[] = {{.key = "mass", .number = 1.0},
                                  {.key = "diametral", .number = 1.0},
                                  {.key = "polar", .number = 1.0},
                                  {.key = "moves", .text = "all"},
                                  {.key = "axial", .text = "yes"}};
    // Segments define the shaft themselves, on which stations twist and move along it with the shaft.
    const bool moves = strcmp(element->name, "segment") != 0;
    whirl_setting values[SETTINGS_MAX];
    whirl_design *design;
    whirl_rotor *rotor = NULL;
    whirl_status status = whirl_design_new(1.0, 1.0, &design);
    // Copy the element's keys.
    for (size_t i = 0; i < element->count && i < SETTINGS_MAX; i++) {
        const setting *item = &element->items[i];
        const double value = item->value.expression ? stand_in(item->key, number) : item->value.number;
        values[i] = (whirl_setting){.key = item->key->name, .number = value, .text = item->word};
    }
    // Build the rotor.
    for (size_t i = 0; i < machine->stations.count && status.code == WHIRL_OK; i++)
        if (is_usable(machine->stations.names[i]))
            status = whirl_design_station(design, machine->stations.names[i], unit, moves ? 5 : 2);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, element->name, values, element->count);
    if (status.code == WHIRL_OK) status = whirl_rotor_outline(design, &rotor);
    whirl_rotor_free(rotor);
    whirl_design_free(design);
    return status;
}

/// Returns true for an element that cannot be checked alone: one with a name of a shaft or material, such as a segment,
/// or with a list of numbers, such as a table over the speed.
static bool needs_others(const setting_list *element) {
    for (size_t k = 0; k < element->group->key_count; k++)
        if (element->group->keys[k].kind == WHIRL_KEY_NAME) return true;
    for (size_t i = 0; i < element->count; i++)
        if (element->items[i].key->kind == WHIRL_KEY_NUMBERS && (element->items[i].word || element->items[i].entries))
            return true;
    return false;
}

/// Reports a contradiction of an element that remains for very different values of its expressions: it follows from the
/// presence of keys.
static void check_alone(case_reader *reader, const machine_parts *machine, const setting_list *element) {
    static const double others[] = {1e-6, 1e6};
    char message[WHIRL_MESSAGE_SIZE];
    whirl_status status = build_alone(machine, element, 1.0);
    snprintf(message, sizeof message, "%s", status.message);
    for (size_t i = 0; i < 2 && status.code == WHIRL_BAD_INPUT; i++) {
        status = build_alone(machine, element, others[i]);
        if (strcmp(status.message, message) != 0) return;
    }
    machine_report(reader, element->place, &status);
}

void machine_check_alone(case_reader *reader, const machine_parts *machine) {
    bool usable = false;
    for (size_t i = 0; i < machine->stations.count; i++) usable = usable || is_usable(machine->stations.names[i]);
    for (size_t i = 0; usable && i < machine->element_count; i++) {
        if (!machine->elements[i].sound || needs_others(&machine->elements[i])) continue;
        check_alone(reader, machine, &machine->elements[i]);
    }
}

void machine_check(case_reader *reader, valuation *v, const machine_parts *machine) {
    if (!check_values(reader, v, machine)) {
        machine_check_alone(reader, machine);
        return;
    }
    check_together(reader, v, machine);
}
