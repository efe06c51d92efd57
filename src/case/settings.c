#include "settings.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dimension.h"
#include "number_text.h"
#include "parameters.h"
#include "problem.h"
#include "quantity.h"
#include "schema.h"
#include "tree.h"
#include "unit_words.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

void describe_names(const char *word, const char *const *names, size_t count, char text[WHY_SIZE]) {
    const char *near = whirl_nearest_name(word, names, count);
    if (near) {
        snprintf(text, WHY_SIZE, "did you mean %.63s?", near);
        return;
    }
    snprintf(text, WHY_SIZE, "expected %s", count == 0 ? "none" : count == 1 ? "" : "one of ");
    for (size_t i = 0; i < count; i++) {
        const size_t used = strlen(text);
        if (used + strlen(names[i]) + 8 > WHY_SIZE) {
            snprintf(text + used, WHY_SIZE - used, ", ...");
            return;
        }
        snprintf(text + used, WHY_SIZE - used, "%s%s", i ? ", " : "", names[i]);
    }
}

// ---------------------------------------------------------------- keys

static size_t key_names(const whirl_group *group, const char *names[SETTINGS_MAX]) {
    size_t count = 0;
    for (const whirl_key *key; count < SETTINGS_MAX && (key = whirl_group_at(group, count)); count++)
        names[count] = key->name;
    return count;
}

/// Returns the name of a group as a case has it: groups of parts of `fit` have names of their own in the reference.
static const char *name_in_case(const whirl_group *group) {
    return group == &schema_fit_data ? "fit.data" : group == &schema_fit_unknown ? "fit.unknown" : group->name;
}

static void report_unknown(case_reader *reader, const file_node *member, const whirl_group *group) {
    const char *names[SETTINGS_MAX];
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    if (isdigit((unsigned char)*member->key) && node_is_null(member)) { // {gap: 0,9 mm, ...}
        problem_at_key(reader->problems, member,
                       "follows a comma, which begins another key, expected a point before decimals");
        return;
    }
    describe_names(member->key, names, key_names(group, names), advice);
    problem_at_key(reader->problems, member, "%s has no key %s, %s", name_in_case(group),
                   text_shown(member->key, shown), advice);
}

/// Returns true if a required key was misspelt: it is reported as unknown, not also as missing.
static bool is_misspelt(const file_node *mapping, const whirl_group *group, const whirl_key *key) {
    const char *names[SETTINGS_MAX];
    const size_t count = key_names(group, names);
    for (const file_node *member = mapping->first; member; member = member->next) {
        if (whirl_group_key(group, member->key)) continue;
        const char *near = whirl_nearest_name(member->key, names, count);
        if (near && strcmp(near, key->name) == 0) return true;
    }
    return false;
}

bool settings_misspelt(const setting_list *settings, const char *key) {
    return is_misspelt(settings->place, settings->group, whirl_group_key(settings->group, key));
}

static void report_missing(case_reader *reader, const file_node *mapping, const whirl_group *group) {
    const whirl_key *key;
    for (size_t k = 0; (key = whirl_group_at(group, k)) != NULL; k++) {
        if (!key->required || (mapping->first && (node_member(mapping, key->name) || is_misspelt(mapping, group, key))))
            continue;
        const bool unit = key->unit[0] && strcmp(key->unit, "1") != 0;
        problem_missing(reader->problems, mapping, key->name, "is missing, expected %s%s%s%s", key->meaning,
                        unit ? " (" : "", unit ? key->unit : "", unit ? ")" : "");
    }
}

// ---------------------------------------------------------------- values

/// Cuts "a|b|c" into names.
static size_t split_choices(char *choices, const char *names[SETTINGS_MAX]) {
    size_t count = 0;
    for (char *word = choices; word && count < SETTINGS_MAX; count++) {
        names[count] = word;
        word = strchr(word, '|');
        if (word) *word++ = '\0';
    }
    return count;
}

static bool read_choice(case_reader *reader, const file_node *where, const whirl_key *key, setting *result) {
    char shown[SHOWN_SIZE], choices[WHY_SIZE], advice[WHY_SIZE];
    const char *names[SETTINGS_MAX];
    if (result->word && whirl_key_choice(key, result->word) >= 0) return true;
    snprintf(choices, sizeof choices, "%s", key->choices);
    describe_names(where->kind == NODE_TEXT ? where->text : "", names, split_choices(choices, names), advice);
    problem_at(reader->problems, where, "is %s, %s", node_shown(where, shown), advice);
    return false;
}

/// Reads the name of a station, or of a `kind`.
static bool settings_read_name(case_reader *reader, const file_node *where, const char *kind, setting *result) {
    char shown[SHOWN_SIZE];
    result->word = where->kind == NODE_TEXT ? where->text : NULL;
    if (result->word && result->word[0]) return true;
    problem_at(reader->problems, where, "is %s, expected the name of %s", node_shown(where, shown), kind);
    return false;
}

/// Reads a pair of names, [a, b] or "a, b", as "a, b".
static bool read_stations(case_reader *reader, const file_node *where, setting *result) {
    char shown[SHOWN_SIZE];
    result->word = where->text;
    if (where->kind == NODE_TEXT && strchr(where->text, ',')) return true;
    const file_node *a = where->first, *b = a ? a->next : NULL;
    if (where->kind != NODE_LIST || where->count != 2 || a->kind != NODE_TEXT || b->kind != NODE_TEXT) {
        problem_at(reader->problems, where, "is %s, expected two stations: [one, other]", node_shown(where, shown));
        return false;
    }
    const size_t size = strlen(a->text) + strlen(b->text) + 3;
    char *word = arena_take(reader->arena, size);
    reader->no_memory = reader->no_memory || !word;
    if (word) snprintf(word, size, "%s, %s", a->text, b->text);
    result->word = word;
    return word != NULL;
}

/// Checks the dimension of an expression, which decides whether its value is in scales or in the unit: "= c/2" is a
/// length, "= gap/c" a plain number. Returns false after a problem.
static bool read_dimension(case_reader *reader, const file_node *where, const char *unit, setting *result) {
    char shown[SHOWN_SIZE];
    const char *const expression = result->value.expression;
    if (!expression || result->scaled || reader->problems->count > 0) return true;
    const value_dimension dimension = expression_dimension(reader->parameters, expression, unit);
    result->scaled = dimension == DIMENSION_OF_UNIT;
    if (dimension == DIMENSION_OTHER)
        problem_at(reader->problems, where, "= %s is neither in %s nor a plain number", text_shown(expression, shown),
                   unit);
    return dimension != DIMENSION_OTHER;
}

/// Reads a number; a number of the state may be plain, in scales, or have a unit.
static bool settings_read_number(case_reader *reader, const file_node *where, const whirl_key *key, setting *result) {
    const char *const unit = schema_scaled_unit(key);
    whirl_key given = *key;
    result->scaled = unit[0] && where->kind == NODE_TEXT && formula_has_unit(reader, where->text);
    if (result->scaled) given.unit = unit;
    if (!formula_read(reader, where, &given, &result->value)) return false;
    return !unit[0] || read_dimension(reader, where, unit, result);
}

/// Reads the numbers of a list into entries, from *count on. The first one that is an expression sets *varies.
static bool read_entries(case_reader *reader, const file_node *where, const whirl_key *key, setting *result,
                         bool *varies) {
    for (const file_node *item = where->first; item; item = item->next) {
        setting *entry = &result->entries[result->entry_count++];
        *entry = (setting){.key = key, .place = item};
        if (!formula_read(reader, item, key, &entry->value)) return false;
        entry->good = true;
        *varies = *varies || entry->value.expression;
    }
    return true;
}

/// Appends number `index` of a list.
static char *append_number(const setting *list, size_t index, double number, char *text) {
    if (index > 0) text += strlen(strcpy(text, index % list->row_length > 0 ? ", " : "; "));
    number_text(number, text);
    return text + strlen(text);
}

static bool check_count(case_reader *reader, const file_node *where, const char *what) {
    if (where->count > 0 && where->count <= WHIRL_MAX_LIST) return true;
    problem_at(reader->problems, where, "has %zu %s, expected 1 to %d", where->count, what, WHIRL_MAX_LIST);
    return false;
}

/// Checks that all rows of a nested list are as long as the first.
static bool check_rows(case_reader *reader, const file_node *where) {
    char shown[SHOWN_SIZE];
    if (!check_count(reader, where, "lists")) return false;
    for (const file_node *row = where->first; row; row = row->next) {
        if (row->kind != NODE_LIST) {
            problem_at(reader->problems, row, "is %s, expected a list as the one before", node_shown(row, shown));
            return false;
        }
        if (!check_count(reader, row, "numbers")) return false;
        if (row->count == where->first->count) continue;
        problem_at(reader->problems, row, "has %zu numbers, expected %zu as the first list has", row->count,
                   where->first->count);
        return false;
    }
    return true;
}

/// Reads a list: [12 MN/m, 14 MN/m] becomes "12000000, 14000000", and [[1, 2], [3, 4]] "1, 2; 3, 4". Lists with
/// expressions keep their entries.
static bool read_list(case_reader *reader, const file_node *where, const whirl_key *key, setting *result) {
    const bool nested = where->count > 0 && where->first->kind == NODE_LIST;
    bool varies = false;
    if (nested ? !check_rows(reader, where) : !check_count(reader, where, "numbers")) return false;
    result->row_length = nested ? where->first->count : where->count;
    const size_t count = nested ? where->count * result->row_length : where->count;
    result->entries = arena_take(reader->arena, count * sizeof *result->entries);
    char *text = arena_take(reader->arena, count * (NUMBER_SIZE + 2));
    reader->no_memory = reader->no_memory || !result->entries || !text;
    if (!result->entries || !text) return false;
    if (!nested && !read_entries(reader, where, key, result, &varies)) return false;
    for (const file_node *row = nested ? where->first : NULL; row; row = row->next)
        if (!read_entries(reader, row, key, result, &varies)) return false;
    if (varies) return true;
    result->word = text;
    for (size_t i = 0; i < count; i++) text = append_number(result, i, result->entries[i].value.number, text);
    result->entries = NULL;
    result->entry_count = 0;
    return true;
}

static bool read_value(case_reader *reader, const file_node *where, const whirl_key *key, setting *result) {
    switch (key->kind) {
    case WHIRL_KEY_NUMBER:
    case WHIRL_KEY_WHOLE:
        return key->unit[0] == '\0' || settings_read_number(reader, where, key, result);
    case WHIRL_KEY_CHOICE:
        result->word = where->kind == NODE_TEXT ? where->text : NULL;
        return key->choices[0] == '\0' || read_choice(reader, where, key, result);
    case WHIRL_KEY_STATION:
        return settings_read_name(reader, where, "a station", result);
    case WHIRL_KEY_NAME:
        return settings_read_name(reader, where, strcmp(key->choices, "shafts") == 0 ? "a shaft" : "a material",
                                  result);
    case WHIRL_KEY_STATIONS:
        return read_stations(reader, where, result);
    case WHIRL_KEY_NUMBERS:
        return where->kind == NODE_LIST ? read_list(reader, where, key, result)
                                        : settings_read_number(reader, where, key, result);
    }
    return false;
}

static void add_setting(case_reader *reader, const file_node *where, const whirl_key *key, setting_list *result) {
    setting *item = &result->items[result->count++];
    *item = (setting){.key = key, .place = where};
    item->good = read_value(reader, where, key, item);
}

static void read_members(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *result) {
    for (const file_node *member = where->first; member; member = member->next) {
        const whirl_key *key = whirl_group_key(group, member->key);
        if (!key)
            report_unknown(reader, member, group);
        else if (!settings_find(result, key->name)) // of a duplicate key the first counts
            add_setting(reader, member, key, result);
    }
    report_missing(reader, where, group);
}

void settings_read(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *result) {
    char shown[SHOWN_SIZE];
    *result = (setting_list){.name = group->name, .group = group, .place = where};
    const char *names[SETTINGS_MAX];
    result->items = arena_take(reader->arena, (key_names(group, names) + 1) * sizeof *result->items);
    if (!result->items) {
        reader->no_memory = true;
    } else if (where->kind == NODE_MAPPING || node_is_null(where)) {
        read_members(reader, where, group, result);
    } else if (where->kind == NODE_TEXT && group->shorthand) {
        add_setting(reader, where, whirl_group_key(group, group->shorthand), result);
        for (size_t k = 0; k < group->key_count; k++)
            if (group->keys[k].required && strcmp(group->keys[k].name, group->shorthand) != 0)
                problem_missing(reader->problems, where, group->keys[k].name, "is missing, expected %s",
                                group->keys[k].meaning);
    } else {
        problem_at(reader->problems, where, "is %s, expected a mapping with the keys of %s", node_shown(where, shown),
                   group->name);
    }
}

static void add_range(case_reader *reader, const file_node *where, const whirl_key *key, setting_list *low,
                      setting_list *high) {
    char shown[SHOWN_SIZE];
    if (where->kind == NODE_LIST && where->count == 2) {
        add_setting(reader, where->first, key, low);
        add_setting(reader, where->first->next, key, high);
    } else {
        problem_at(reader->problems, where, "is %s, expected the two ends of a range: [-1, 1]",
                   node_shown(where, shown));
    }
}

void settings_read_ranges(case_reader *reader, const file_node *where, const whirl_group *group, setting_list *low,
                          setting_list *high) {
    char shown[SHOWN_SIZE];
    const char *names[SETTINGS_MAX];
    const size_t most = key_names(group, names) + 1;
    *low = *high = (setting_list){.name = group->name, .group = group, .place = where};
    low->items = arena_take(reader->arena, 2 * most * sizeof *low->items);
    if (!low->items) {
        reader->no_memory = true;
        return;
    }
    high->items = low->items + most;
    if (where->kind != NODE_MAPPING)
        problem_at(reader->problems, where, "is %s, expected ranges of coordinates: {x: [-1, 1]}",
                   node_shown(where, shown));
    for (const file_node *member = where->kind == NODE_MAPPING ? where->first : NULL; member; member = member->next) {
        const whirl_key *key = whirl_group_key(group, member->key);
        if (!key)
            report_unknown(reader, member, group);
        else if (!settings_find(low, key->name))
            add_range(reader, member, key, low, high);
    }
}

// ---------------------------------------------------------------- use

const setting *settings_find(const setting_list *settings, const char *key) {
    for (size_t i = 0; i < settings->count; i++)
        if (strcmp(settings->items[i].key->name, key) == 0) return &settings->items[i];
    return NULL;
}

size_t setting_numbers(const setting *item, const setting **first) {
    *first = item->entries ? item->entries : item;
    return item->entries ? item->entry_count : 1;
}

size_t setting_list_size(const setting *item) {
    return item->entry_count * (NUMBER_SIZE + 2) + 1;
}

whirl_status setting_list_text(valuation *v, const setting *item, char *text) {
    for (size_t i = 0; i < item->entry_count; i++) {
        double number;
        const whirl_status status = valuation_number(v, &item->entries[i].value, &number);
        if (status.code != WHIRL_OK) return status;
        text = append_number(item, i, number, text);
    }
    return whirl_ok();
}

/// Checks the value of one number that is an expression; returns false after a problem.
static bool check_expression(case_reader *reader, valuation *v, const setting *item) {
    char shown[SHOWN_SIZE], why[WHY_SIZE];
    double number;
    whirl_status status = valuation_number(v, &item->value, &number);
    const bool evaluated = status.code == WHIRL_OK;
    if (evaluated) status = formula_check(v->parameters, item->key, &item->value, number);
    const bool turned = strcmp(expression_unit(v->parameters, item->value.expression), "rad") == 0;
    if (status.code == WHIRL_OK && !turned && !angle_is_likely(item->key, number, why))
        status = whirl_fail(WHIRL_BAD_INPUT, "%s", why);
    if (status.code == WHIRL_OK) return true;
    if (evaluated)
        problem_at(reader->problems, item->place, "= %s %s", text_shown(item->value.expression, shown), status.message);
    else
        problem_at(reader->problems, item->place, "%s", status.message);
    return false;
}

bool settings_check(case_reader *reader, valuation *v, const setting_list *settings) {
    bool good = true;
    for (size_t i = 0; i < settings->count; i++) {
        const setting *item = &settings->items[i], *number;
        const size_t count = setting_numbers(item, &number);
        good = good && item->good;
        for (size_t k = 0; k < count && item->good; k++)
            if (number[k].value.expression) good = check_expression(reader, v, &number[k]) && good;
    }
    return good;
}

double settings_number(valuation *v, const setting_list *settings, const char *key) {
    const setting *item = settings_find(settings, key);
    if (!item) return strtod(whirl_group_key(settings->group, key)->fallback, NULL);
    double number = NAN;
    valuation_number(v, &item->value, &number);
    return number;
}

double settings_plain(case_reader *reader, const setting_list *settings, const char *name) {
    const setting *given = settings_find(settings, name);
    const whirl_key *key = whirl_group_key(settings->group, name);
    if (!given) return *key->fallback ? strtod(key->fallback, NULL) : NAN;
    if (given->value.expression) problem_at(reader->problems, given->place, "is an expression, expected a number");
    return given->good && !given->value.expression ? given->value.number : NAN;
}

size_t settings_list_plain(case_reader *reader, const setting_list *settings, const char *name, double *out,
                           size_t most) {
    const setting *given = settings_find(settings, name);
    if (given && !given->good) return 0;
    if (given && given->entries) {
        problem_at(reader->problems, given->place, "has an expression, expected numbers");
        return 0;
    }
    if (!given || !given->word) {
        *out = settings_plain(reader, settings, name);
        return isfinite(*out) ? 1 : 0;
    }
    if (given->place->count > most) {
        problem_at(reader->problems, given->place, "has %zu numbers, expected 1 to %zu", given->place->count, most);
        return 0;
    }
    size_t count = 0;
    for (const char *text = given->word; text && count < most; text = strchr(text, ',')) {
        if (*text == ',') text++;
        out[count++] = strtod(text, NULL);
    }
    return count;
}

const char *settings_word(const setting_list *settings, const char *key) {
    const setting *item = settings_find(settings, key);
    return item && item->word ? item->word : whirl_group_key(settings->group, key)->fallback;
}

bool settings_yes(const setting_list *settings, const char *key) {
    const char *word = settings_word(settings, key);
    return strcmp(word, "yes") == 0 || strcmp(word, "true") == 0;
}

void settings_take(valuation *v, const setting_list *settings, const whirl_member *table, void *object) {
    for (; table->part; table++) {
        const whirl_key *key = &table->key;
        const bool said = settings_find(settings, key->name) || *key->fallback;
        if (strcmp(table->part, settings->group->name) != 0 || !said)
            continue;
        else if (key->kind == WHIRL_KEY_CHOICE)
            whirl_member_say(table, object, settings_word(settings, key->name));
        else
            whirl_member_set(table, object, settings_number(v, settings, key->name));
    }
}

void settings_units(case_reader *reader, const setting_list *settings, char *text, size_t size) {
    unit_choice choice;
    settings_text(reader, settings, "units", text, size);
    const whirl_status status = unit_choice_read(text, &choice);
    if (status.code == WHIRL_OK) return;
    problem_at(reader->problems, settings_find(settings, "units")->place, "%s", status.message);
    text[0] = '\0';
}

void settings_text(case_reader *reader, const setting_list *settings, const char *key, char *text, size_t size) {
    char shown[SHOWN_SIZE];
    text[0] = '\0';
    const setting *item = settings_find(settings, key);
    if (!item) return;
    if (item->place->kind != NODE_TEXT) {
        problem_at(reader->problems, item->place, "is %s, expected a text", node_shown(item->place, shown));
    } else if (strlen(item->place->text) >= size) {
        problem_at(reader->problems, item->place, "has %zu bytes, expected at most %zu", strlen(item->place->text),
                   size - 1);
    } else {
        snprintf(text, size, "%s", item->place->text);
        for (char *c = text; *c; c++)
            if (*c == '\n' || *c == '\t') *c = ' ';
    }
}
