#include "machine.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "problem.h"
#include "schema.h"

size_t machine_station(const machine_parts *machine, const char *name) {
    for (size_t i = 0; i < machine->station_count; i++)
        if (strcmp(machine->station_names[i], name) == 0) return i;
    return machine->station_count;
}

// ---------------------------------------------------------------- stations

static bool is_station_name(const char *name) {
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-') return false;
    return name[0] && strlen(name) < WHIRL_NAME_SIZE;
}

/// As a name of a station, not "ground", which some places take beside it.
static bool is_usable(const char *name) {
    return is_station_name(name) && strcmp(name, "ground") != 0;
}

static void check_station_name(case_reader *reader, const file_node *where) {
    const bool ground = strcmp(where->key, "ground") == 0;
    if (ground)
        problem_at_key(reader->problems, where, "stands for the ground itself, expected another name");
    else if (!is_station_name(where->key))
        problem_at_key(reader->problems, where, "is no name for a station, expected letters, digits, '_' and '-'");
}

static void read_stations(case_reader *reader, const file_node *where, machine_parts *result) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_MAPPING || where->count == 0) {
        problem_at(reader->problems, where, "is %s, expected names of stations with their keys",
                   node_is_null(where) || where->kind == NODE_MAPPING ? "empty" : node_shown(where, shown));
        return;
    }
    if (where->count > WHIRL_MAX_STATIONS)
        problem_at(reader->problems, where, "has %zu stations, expected at most %d", where->count, WHIRL_MAX_STATIONS);
    result->stations = arena_take(reader->arena, WHIRL_MAX_STATIONS * sizeof *result->stations);
    result->station_names = arena_take(reader->arena, WHIRL_MAX_STATIONS * sizeof *result->station_names);
    reader->no_memory = reader->no_memory || !result->stations || !result->station_names;
    if (reader->no_memory) return;
    for (const file_node *member = where->first; member; member = member->next) {
        if (machine_station(result, member->key) < result->station_count) continue; // a name that stands twice
        if (result->station_count == WHIRL_MAX_STATIONS) break;
        const size_t i = result->station_count++;
        result->station_names[i] = member->key;
        check_station_name(reader, member);
        settings_read(reader, member, whirl_station_keys(), &result->stations[i]);
        result->stations[i].name = member->key;
    }
}

// ---------------------------------------------------------------- elements

void machine_advise(const machine_parts *machine, const char *word, bool ground, char advice[WHY_SIZE]) {
    const char *names[WHIRL_MAX_STATIONS + 1];
    size_t count = 0;
    for (size_t i = 0; i < machine->station_count; i++)
        if (is_usable(machine->station_names[i])) names[count++] = machine->station_names[i];
    if (count == 0)
        snprintf(advice, WHY_SIZE, "expected the name of a station");
    else if (ground)
        names[count++] = "ground";
    if (count > 0) describe_names(word, names, count, advice);
}

static bool check_station(case_reader *reader, const machine_parts *machine, const file_node *where, const char *name,
                          bool ground) {
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    if (machine_station(machine, name) < machine->station_count || (ground && strcmp(name, "ground") == 0)) return true;
    if (!reader_reports(reader, "station", name)) return false;
    machine_advise(machine, name, ground, advice);
    problem_at(reader->problems, where, "is %s, which is no station, %s", text_shown(name, shown), advice);
    return false;
}

/// The names of a list are reported where each of them stands.
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
    if (machine->station_count == 0) return true; // said already
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

/// `- gravity` alone is an element with its defaults.
static void read_element(case_reader *reader, const file_node *item, machine_parts *result) {
    char shown[SHOWN_SIZE];
    const bool bare = item->kind == NODE_TEXT && !item->quoted && whirl_element_group(item->text);
    if (!bare && (item->kind != NODE_MAPPING || item->count != 1)) {
        problem_at(reader->problems, item, "is %s, expected one element: a kind with its keys",
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
    file_node nothing = *where;
    if (bare) nothing.text = "";
    const size_t problems = reader->problems->count;
    setting_list *element = &result->elements[result->element_count++];
    settings_read(reader, bare ? &nothing : where, group, element);
    element->place = where;
    element->sound = check_stations(reader, result, element) && reader->problems->count == problems;
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

void machine_read(case_reader *reader, const file_node *where, machine_parts *result) {
    *result = (machine_parts){.elements_place = where};
    settings_read(reader, where, &schema_rotor, &result->rotor);
    const setting *stations = settings_find(&result->rotor, "stations");
    const setting *elements = settings_find(&result->rotor, "elements");
    if (stations) read_stations(reader, stations->place, result);
    if (elements) read_elements(reader, elements->place, result);
}

// ---------------------------------------------------------------- building

/// What the rotor layer takes: numbers in SI, and words.
static whirl_status evaluate(const setting_list *settings, valuation *v, whirl_setting values[SETTINGS_MAX]) {
    for (size_t i = 0; i < settings->count && i < SETTINGS_MAX; i++) {
        const setting *item = &settings->items[i];
        values[i] = (whirl_setting){.key = item->key->name, .text = item->word};
        if (item->word) continue;
        const whirl_status status = valuation_number(v, &item->value, &values[i].number);
        if (status.code == WHIRL_OK) continue;
        return whirl_fail(status.code, "%.63s.%s %.250s", settings->name, item->key->name, status.message);
    }
    return whirl_ok();
}

static whirl_status new_design(const machine_parts *machine, valuation *v, whirl_design **design) {
    *design = NULL;
    const double speed = settings_number(v, &machine->rotor, "speed");
    const double length = settings_number(v, &machine->rotor, "length_scale");
    return whirl_design_new(speed, length, design);
}

static whirl_status add_station(const machine_parts *machine, size_t index, valuation *v, whirl_design *design) {
    whirl_setting values[SETTINGS_MAX];
    const setting_list *station = &machine->stations[index];
    whirl_status status = evaluate(station, v, values);
    if (status.code == WHIRL_OK) status = whirl_design_station(design, station->name, values, station->count);
    return status;
}

static whirl_status add_element(const machine_parts *machine, size_t index, valuation *v, whirl_design *design) {
    whirl_setting values[SETTINGS_MAX];
    const setting_list *element = &machine->elements[index];
    whirl_status status = evaluate(element, v, values);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, element->name, values, element->count);
    return status;
}

static whirl_status make_design(const machine_parts *machine, valuation *v, whirl_design **design) {
    whirl_status status = new_design(machine, v, design);
    for (size_t i = 0; i < machine->station_count && status.code == WHIRL_OK; i++)
        status = add_station(machine, i, v, *design);
    for (size_t i = 0; i < machine->element_count && status.code == WHIRL_OK; i++)
        status = add_element(machine, i, v, *design);
    return status;
}

whirl_status machine_build(const machine_parts *machine, valuation *v, whirl_rotor **rotor) {
    whirl_design *design;
    *rotor = NULL;
    whirl_status status = make_design(machine, v, &design);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

// ---------------------------------------------------------------- checking

static bool tell(case_reader *reader, const file_node *where, const whirl_status *status) {
    reader->no_memory = reader->no_memory || status->code == WHIRL_NO_MEMORY;
    if (status->code != WHIRL_OK) problem_at_key(reader->problems, where, "%s", status->message);
    return status->code == WHIRL_OK;
}

static bool check_values(case_reader *reader, valuation *v, const machine_parts *machine) {
    bool good = settings_check(reader, v, &machine->rotor);
    for (size_t i = 0; i < machine->station_count; i++) good = settings_check(reader, v, &machine->stations[i]) && good;
    for (size_t i = 0; i < machine->element_count; i++) good = settings_check(reader, v, &machine->elements[i]) && good;
    return good;
}

/// Whom problems of a design are told to.
typedef struct teller {
    case_reader *reader;
    const machine_parts *machine;
} teller;

static void tell_of_element(void *context, size_t element, const whirl_status *status) {
    const teller *to = context;
    const bool known = element < to->machine->element_count;
    tell(to->reader, known ? to->machine->elements[element].place : to->machine->rotor.place, status);
}

/// What is left are settings that contradict each other: each problem has its line.
static void check_together(case_reader *reader, valuation *v, const machine_parts *machine) {
    whirl_design *design;
    whirl_rotor *rotor = NULL;
    size_t problems = 0;
    teller to = {reader, machine};
    whirl_status status = make_design(machine, v, &design);
    if (status.code == WHIRL_OK) {
        status = whirl_rotor_new(design, &rotor);
        if (status.code == WHIRL_BAD_INPUT) {
            const whirl_status checked = whirl_rotor_check(design, tell_of_element, &to, &problems);
            if (checked.code != WHIRL_OK || problems > 0) status = checked;
        }
    }
    tell(reader, machine->elements_place, &status);
    whirl_rotor_free(rotor);
    whirl_design_free(design);
}

/// A rotor with the element alone, its stations of 1 kg and 1 kg m2. Expressions, whose values may not be known, count
/// as 1: what contradicts each other are keys that are there and keys that are not.
static whirl_status build_alone(const machine_parts *machine, const setting_list *element) {
    const whirl_setting unit[] = {{.key = "mass", .number = 1.0}, {.key = "diametral", .number = 1.0}};
    whirl_setting values[SETTINGS_MAX];
    whirl_design *design;
    whirl_rotor *rotor = NULL;
    whirl_status status = whirl_design_new(1.0, 1.0, &design);
    for (size_t i = 0; i < element->count && i < SETTINGS_MAX; i++) {
        const setting *item = &element->items[i];
        const double number = item->value.expression ? 1.0 : item->value.number;
        values[i] = (whirl_setting){.key = item->key->name, .number = number, .text = item->word};
    }
    for (size_t i = 0; i < machine->station_count && status.code == WHIRL_OK; i++)
        if (is_usable(machine->station_names[i]))
            status = whirl_design_station(design, machine->station_names[i], unit, 2);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, element->name, values, element->count);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, &rotor);
    whirl_rotor_free(rotor);
    whirl_design_free(design);
    return status;
}

/// A table may be of the speed, which is not known here.
static bool has_list(const setting_list *element) {
    for (size_t i = 0; i < element->count; i++)
        if (element->items[i].key->kind == WHIRL_KEY_NUMBERS && element->items[i].word) return true;
    return false;
}

void machine_check_alone(case_reader *reader, const machine_parts *machine) {
    bool usable = false;
    for (size_t i = 0; i < machine->station_count; i++) usable = usable || is_usable(machine->station_names[i]);
    for (size_t i = 0; usable && i < machine->element_count; i++) {
        if (!machine->elements[i].sound || has_list(&machine->elements[i])) continue;
        const whirl_status status = build_alone(machine, &machine->elements[i]);
        tell(reader, machine->elements[i].place, &status);
    }
}

void machine_check(case_reader *reader, valuation *v, const machine_parts *machine) {
    if (!check_values(reader, v, machine)) {
        machine_check_alone(reader, machine);
        return;
    }
    check_together(reader, v, machine);
}
