// Builds designs. Settings are checked against the descriptors here and nowhere else.
#include "design.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "registry.h"
#include "shafts.h"

whirl_status whirl_design_new(double speed, double length_scale, whirl_design **design) {
    *design = NULL;
    if (!isfinite(speed)) return whirl_fail(WHIRL_BAD_INPUT, "speed is %g rad/s, expected a number", speed);
    if (!(isfinite(length_scale) && length_scale > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "length_scale is %g m, expected a number above 0", length_scale);
    *design = calloc(1, sizeof **design);
    if (!*design) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a design");
    (*design)->speed = speed;
    (*design)->length = length_scale;
    (*design)->stages = 1.0;
    for (const element_type *const *type = element_types; *type; type++)
        (*design)->types[(*design)->type_count++] = *type;
    return whirl_ok();
}

void whirl_design_bearings(whirl_design *design, whirl_bearings what, double stiffness) {
    design->bearings = what;
    design->stiffness = stiffness;
}

void whirl_design_drag(whirl_design *design, whirl_drag what, size_t station, double stages) {
    design->drag = what;
    design->drag_at = station;
    design->stages = stages;
}

void whirl_design_frequency(whirl_design *design, double frequency) {
    design->asynchronous = true;
    design->frequency = frequency;
}

void whirl_design_in_time(whirl_design *design) {
    design->in_time = true;
}

void whirl_design_spools(whirl_design *design, size_t count, const double *speeds, bool vary) {
    design->spools_vary = vary;
    design->spool_count = count;
    memcpy(design->spool_speeds, speeds, count * sizeof *speeds);
}

void whirl_design_unbalances(whirl_design *design, size_t count, const whirl_placed *placed) {
    design->placed_count = count;
    design->placed = placed;
}

bool whirl_element_is_bearing(const char *kind) {
    for (const element_type *const *type = element_types; *type; type++)
        if (strcmp((*type)->group.name, kind) == 0) return (*type)->carries;
    return false;
}

static void free_values(const whirl_group *group, key_value *values) {
    for (size_t i = 0; i < group->key_count; i++) free(values[i].list);
    free(values);
}

void whirl_design_free(whirl_design *design) {
    if (!design) return;
    for (size_t i = 0; i < design->station_count; i++) free_values(&station_group, design->stations[i].values);
    for (size_t i = 0; i < design->shaft_count; i++) free_values(&shaft_group, design->shafts[i].values);
    for (size_t i = 0; i < design->material_count; i++) free_values(&material_group, design->materials[i].values);
    for (size_t i = 0; i < design->element_count; i++)
        free_values(&design->elements[i].type->group, design->elements[i].values);
    free(design);
}

// ---------------------------------------------------------------- names

/// The named parts of one kind.
typedef struct part_list {
    const char *kind; ///< "station"
    design_part *parts;
    size_t *count, most;
    const whirl_group *group;
} part_list;

static part_list stations_of(whirl_design *design) {
    return (part_list){"station", design->stations, &design->station_count, WHIRL_MAX_STATIONS, &station_group};
}
static part_list shafts_of(whirl_design *design) {
    return (part_list){"shaft", design->shafts, &design->shaft_count, WHIRL_MAX_SHAFTS, &shaft_group};
}
static part_list materials_of(whirl_design *design) {
    return (part_list){"material", design->materials, &design->material_count, WHIRL_MAX_MATERIALS, &material_group};
}

static bool find_part(const part_list *in, const char *name, size_t length, size_t *index) {
    for (size_t i = 0; i < *in->count; i++) {
        const char *known = in->parts[i].name;
        if (strlen(known) == length && strncmp(known, name, length) == 0) {
            *index = i;
            return true;
        }
    }
    return false;
}

static whirl_status unknown_part(const part_list *in, const char *name, size_t length) {
    const char *names[WHIRL_MAX_STATIONS];
    char word[WHIRL_NAME_SIZE] = "";
    memcpy(word, name, length < sizeof word ? length : sizeof word - 1);
    for (size_t i = 0; i < *in->count; i++) names[i] = in->parts[i].name;
    const char *near = whirl_nearest_name(word, names, *in->count);
    if (near) return whirl_fail(WHIRL_BAD_INPUT, "no %s is called '%s', did you mean '%s'?", in->kind, word, near);
    return whirl_fail(WHIRL_BAD_INPUT, "no %s is called '%s'", in->kind, word);
}

/// Reads the name of a shaft or a material. If the design does not define steel, its index is one past the last
/// material.
static whirl_status design_read_name(whirl_design *design, const whirl_key *key, const char *name, size_t *index) {
    const bool is_material = strcmp(key->choices, "materials") == 0;
    const part_list in = is_material ? materials_of(design) : shafts_of(design);
    *index = *in.count;
    if (find_part(&in, name, strlen(name), index) || (is_material && strcmp(name, "steel") == 0)) return whirl_ok();
    return unknown_part(&in, name, strlen(name));
}

static whirl_status read_station(whirl_design *design, const char *name, size_t length, bool ground_allowed,
                                 size_t *station) {
    if (ground_allowed && length == strlen("ground") && strncmp(name, "ground", length) == 0) {
        *station = GROUND;
        return whirl_ok();
    }
    const part_list in = stations_of(design);
    return find_part(&in, name, length, station) ? whirl_ok() : unknown_part(&in, name, length);
}

/// Reads two stations, "disc, journal", with any space around the names.
static whirl_status read_stations(whirl_design *design, const char *text, size_t stations[2]) {
    for (int i = 0; i < 2; i++) {
        text += strspn(text, " \t");
        const size_t length = strcspn(text, ", \t");
        const char *end = text + length;
        end += strspn(end, " \t");
        if (length == 0 || *end != (i == 0 ? ',' : '\0'))
            return whirl_fail(WHIRL_BAD_INPUT, "is not two stations, expected 'one, other'");
        const whirl_status status = read_station(design, text, length, true, &stations[i]);
        if (status.code != WHIRL_OK) return status;
        text = end + 1;
    }
    if (stations[0] == GROUND && stations[1] == GROUND)
        return whirl_fail(WHIRL_BAD_INPUT, "joins ground with ground, expected at least one station");
    return whirl_ok();
}

/// Allocates memory for all numbers of a text.
static bool make_list(const char *text, key_value *value) {
    size_t most = 1;
    for (const char *c = text; *c; c++) most += *c == ',' || *c == ';';
    value->list = malloc(most * sizeof *value->list);
    value->rows = 1;
    return value->list != NULL;
}

/// Reads a list of numbers, "1e7, 1.2e7", or rows with equally many numbers, "1e7, 1.2e7; 2e7, 2.1e7".
static whirl_status read_list(const whirl_key *key, const char *text, key_value *value) {
    static const char *const expected = "is no list of numbers, expected 'one, other, ...'";
    size_t first = 0, width = 0; // start of the row, and number of numbers in the previous row
    if (!make_list(text, value)) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a list of numbers");
    for (;;) {
        // Read a number.
        char *end;
        const double number = strtod(text, &end);
        if (end == text) return whirl_fail(WHIRL_BAD_INPUT, "%s", expected);
        const whirl_status status = whirl_key_check_number(key, number);
        if (status.code != WHIRL_OK) return status;
        value->list[value->count++] = number;
        // Check the lengths of the list and of its rows.
        end += strspn(end, " \t");
        if (value->count - first > WHIRL_MAX_LIST || value->rows > WHIRL_MAX_LIST)
            return whirl_fail(WHIRL_BAD_INPUT, "has more than %d numbers", WHIRL_MAX_LIST);
        if (*end != ',' && *end != ';' && *end != '\0') return whirl_fail(WHIRL_BAD_INPUT, "%s", expected);
        if (*end != ',') {
            if (value->rows > 1 && value->count - first != width)
                return whirl_fail(WHIRL_BAD_INPUT, "has lists of %zu and of %zu numbers, expected equal ones", width,
                                  value->count - first);
            width = value->count - first;
            first = value->count;
        }
        // End, or continue with the next number or row.
        if (*end == '\0') {
            if (value->count == 1) value->number = number; // a list of one number is that number
            return whirl_ok();
        }
        value->rows += *end == ';';
        text = end + 1;
    }
}

static whirl_status read_value(whirl_design *design, const whirl_key *key, const whirl_setting *setting,
                               key_value *value) {
    const bool is_word = key->kind == WHIRL_KEY_CHOICE || key->kind == WHIRL_KEY_STATION ||
                         key->kind == WHIRL_KEY_STATIONS || key->kind == WHIRL_KEY_NAME;
    if (key->kind != WHIRL_KEY_NUMBERS && is_word != (setting->text != NULL))
        return whirl_fail(WHIRL_BAD_INPUT, "expected a %s", is_word ? "word" : "number");
    value->given = true;
    switch (key->kind) {
    case WHIRL_KEY_NUMBER:
    case WHIRL_KEY_WHOLE:
        value->number = setting->number;
        return whirl_key_check_number(key, setting->number);
    case WHIRL_KEY_CHOICE:
        value->choice = whirl_key_choice(key, setting->text);
        if (value->choice < 0)
            return whirl_fail(WHIRL_BAD_INPUT, "is '%.40s', expected one of %s", setting->text, key->choices);
        return whirl_ok();
    case WHIRL_KEY_STATION:
        return read_station(design, setting->text, strlen(setting->text), false, &value->station[0]);
    case WHIRL_KEY_STATIONS:
        return read_stations(design, setting->text, value->station);
    case WHIRL_KEY_NAME:
        return design_read_name(design, key, setting->text, &value->station[0]);
    case WHIRL_KEY_NUMBERS:
        value->number = setting->number;
        return setting->text ? read_list(key, setting->text, value) : whirl_key_check_number(key, setting->number);
    }
    return whirl_ok();
}

static void set_fallback(const whirl_key *key, key_value *value) {
    if (key->fallback[0] == '\0' || key->kind == WHIRL_KEY_NAME) return;
    if (key->kind == WHIRL_KEY_CHOICE)
        value->choice = whirl_key_choice(key, key->fallback);
    else
        value->number = strtod(key->fallback, NULL);
}

static whirl_status unknown_key(const whirl_group *group, const char *name) {
    const char *names[MAX_KEYS];
    for (size_t i = 0; i < group->key_count; i++) names[i] = group->keys[i].name;
    const char *near = whirl_nearest_name(name, names, group->key_count);
    if (near) return whirl_fail(WHIRL_BAD_INPUT, "%s has no key '%.40s', did you mean '%s'?", group->name, name, near);
    return whirl_fail(WHIRL_BAD_INPUT, "%s has no key '%.40s'", group->name, name);
}

static whirl_status read_settings(whirl_design *design, const whirl_group *group, const whirl_setting *settings,
                                  size_t count, key_value *values) {
    for (size_t i = 0; i < group->key_count; i++) set_fallback(&group->keys[i], &values[i]);
    for (size_t i = 0; i < count; i++) {
        const whirl_key *key = whirl_group_key(group, settings[i].key);
        if (!key) return unknown_key(group, settings[i].key);
        key_value *value = &values[key - group->keys];
        if (value->given) return whirl_fail(WHIRL_BAD_INPUT, "%s gives %s twice", group->name, key->name);
        const whirl_status status = read_value(design, key, &settings[i], value);
        if (status.code != WHIRL_OK)
            return whirl_fail(status.code, "%s.%s %.300s", group->name, key->name, status.message);
    }
    for (size_t i = 0; i < group->key_count; i++)
        if (group->keys[i].required && !values[i].given)
            return whirl_fail(WHIRL_BAD_INPUT, "%s has no %s, expected %s", group->name, group->keys[i].name,
                              group->keys[i].meaning);
    return whirl_ok();
}

static whirl_status check_name(const part_list *in, const char *name) {
    size_t index;
    const size_t length = strlen(name);
    if (length == 0 || length >= WHIRL_NAME_SIZE)
        return whirl_fail(WHIRL_BAD_INPUT, "a %s's name has %zu letters, expected 1 to %d", in->kind, length,
                          WHIRL_NAME_SIZE - 1);
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
            return whirl_fail(WHIRL_BAD_INPUT, "%s '%s' is no name, expected letters, digits, '_' and '-'", in->kind,
                              name);
    if (strcmp(name, "ground") == 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "a %s is called 'ground', expected another name: elements call the ground so", in->kind);
    if (find_part(in, name, length, &index))
        return whirl_fail(WHIRL_BAD_INPUT, "%s '%s' is defined twice", in->kind, name);
    if (*in->count == in->most) return whirl_fail(WHIRL_BAD_INPUT, "there are more than %zu %ss", in->most, in->kind);
    return whirl_ok();
}

static whirl_status add_part(whirl_design *design, const part_list *to, const char *name, const whirl_setting *settings,
                             size_t count) {
    whirl_status status = check_name(to, name);
    if (status.code != WHIRL_OK) return status;
    key_value *values = calloc(to->group->key_count, sizeof *values);
    if (!values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %s '%s'", to->kind, name);
    status = read_settings(design, to->group, settings, count, values);
    if (status.code != WHIRL_OK) {
        free_values(to->group, values);
        return status;
    }
    design_part *part = &to->parts[(*to->count)++];
    strcpy(part->name, name);
    part->values = values;
    return whirl_ok();
}

whirl_status whirl_design_station(whirl_design *design, const char *name, const whirl_setting *settings, size_t count) {
    const part_list to = stations_of(design);
    return add_part(design, &to, name, settings, count);
}

whirl_status whirl_design_shaft(whirl_design *design, const char *name, const whirl_setting *settings, size_t count) {
    const part_list to = shafts_of(design);
    return add_part(design, &to, name, settings, count);
}

whirl_status whirl_design_material(whirl_design *design, const char *name, const whirl_setting *settings,
                                   size_t count) {
    const part_list to = materials_of(design);
    return add_part(design, &to, name, settings, count);
}

static const element_type *find_type(const whirl_design *design, const char *kind) {
    for (size_t i = 0; i < design->type_count; i++)
        if (strcmp(design->types[i]->group.name, kind) == 0) return design->types[i];
    return NULL;
}

static whirl_status unknown_element(const whirl_design *design, const char *kind) {
    const char *names[MAX_TYPES];
    for (size_t i = 0; i < design->type_count; i++) names[i] = design->types[i]->group.name;
    const char *near = whirl_nearest_name(kind, names, design->type_count);
    if (near) return whirl_fail(WHIRL_BAD_INPUT, "no element is called '%.40s', did you mean '%s'?", kind, near);
    return whirl_fail(WHIRL_BAD_INPUT, "no element is called '%.40s'", kind);
}

whirl_status whirl_design_add_type(whirl_design *design, const whirl_element_type *type) {
    if (find_type(design, type->group.name))
        return whirl_fail(WHIRL_BAD_INPUT, "there is an element '%.40s' already", type->group.name);
    if (design->type_count == MAX_TYPES)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d kinds of elements", MAX_TYPES);
    if (type->group.key_count > MAX_KEYS)
        return whirl_fail(WHIRL_BAD_INPUT, "element '%.40s' has %zu keys, expected at most %d", type->group.name,
                          type->group.key_count, MAX_KEYS);
    design->types[design->type_count++] = type;
    return whirl_ok();
}

whirl_status whirl_design_element(whirl_design *design, const char *kind, const whirl_setting *settings, size_t count) {
    const element_type *type = find_type(design, kind);
    if (!type) return unknown_element(design, kind);
    if (design->element_count == WHIRL_MAX_ELEMENTS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d elements", WHIRL_MAX_ELEMENTS);
    if (type == &segment_element && design->shaft_count == 0) {
        const whirl_status status = whirl_design_shaft(design, "shaft", NULL, 0);
        if (status.code != WHIRL_OK) return status;
    }
    key_value *values = calloc(type->group.key_count, sizeof *values);
    if (!values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a %s", kind);
    const whirl_status status = read_settings(design, &type->group, settings, count, values);
    if (status.code != WHIRL_OK) {
        free_values(&type->group, values);
        return status;
    }
    design->elements[design->element_count++] = (design_element){type, values};
    return whirl_ok();
}
