#include "path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "schema.h"

enum { MAX_NAMES = WHIRL_MAX_STATIONS + WHIRL_MAX_SHAFTS + WHIRL_MAX_MATERIALS + 64 };

// ---------------------------------------------------------------- elements

/// Kind and number of an element (0 without one), from "film" or "film[2]".
typedef struct element_name {
    char kind[WHIRL_NAME_SIZE];
    size_t which;
} element_name;

static element_name split_element(const char *head) {
    element_name result = {.which = 0};
    const size_t length = strcspn(head, "[");
    snprintf(result.kind, sizeof result.kind, "%.*s", (int)(length < sizeof result.kind ? length : 0), head);
    if (head[length] == '[') result.which = (size_t)strtoul(head + length + 1, NULL, 10);
    return result;
}

static size_t count_kind(const machine_parts *machine, const char *kind) {
    size_t count = 0;
    for (size_t i = 0; i < machine->element_count; i++) count += strcmp(machine->elements[i].name, kind) == 0;
    return count;
}

/// Finds an element by kind and number, from 1.
static const setting_list *find_element(const machine_parts *machine, const element_name *name) {
    size_t which = name->which > 0 ? name->which : 1;
    for (size_t i = 0; i < machine->element_count; i++)
        if (strcmp(machine->elements[i].name, name->kind) == 0 && --which == 0) return &machine->elements[i];
    return NULL;
}

static whirl_status element_path(const machine_parts *machine, const char *head, const char *key, char *path) {
    const element_name name = split_element(head);
    const size_t count = count_kind(machine, name.kind);
    const setting_list *const element = find_element(machine, &name);
    char place[PATH_SIZE];
    if (name.which == 0 && count > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "the case has %zu elements %s, expected %s[1].%s to %s[%zu].%s", count,
                          name.kind, name.kind, key, name.kind, count, key);
    if (!element || (strchr(head, '[') && name.which == 0))
        return whirl_fail(WHIRL_BAD_INPUT, "%.60s is no element, the case has %zu of that kind", head, count);
    node_path(element->place, place, sizeof place);
    // `gravity: 9.81 m/s2`: a shorthand value in place of the mapping.
    const bool alone = element->place->kind == NODE_TEXT && element->group->shorthand &&
                       strcmp(element->group->shorthand, key) == 0 && element->place->key;
    snprintf(path, PATH_SIZE, alone ? "%.200s" : "%.200s.%s", place, key);
    return whirl_ok();
}

// ---------------------------------------------------------------- all names

/// Collects the words that may begin a short name.
static size_t collect_names(const case_content *content, const char *names[MAX_NAMES]) {
    const machine_parts *const machine = &content->machine;
    size_t count = 0;
    for (size_t i = 0; i < machine->stations.count; i++) names[count++] = machine->stations.names[i];
    for (size_t i = 0; i < machine->shafts.count; i++) names[count++] = machine->shafts.names[i];
    for (size_t i = 0; i < machine->materials.count; i++) names[count++] = machine->materials.names[i];
    for (const whirl_group *const *group = whirl_element_groups(); *group && count < MAX_NAMES; group++)
        if (count_kind(machine, (*group)->name) > 0) names[count++] = (*group)->name;
    const whirl_key *key;
    for (size_t k = 0; count < MAX_NAMES && (key = whirl_group_at(&schema_study, k)) != NULL; k++)
        names[count++] = key->name;
    return count;
}

/// Returns the first element that has such a key, or the first element.
static const setting_list *element_with(const machine_parts *machine, const char *key) {
    for (size_t i = 0; i < machine->element_count; i++)
        if (whirl_group_key(machine->elements[i].group, key)) return &machine->elements[i];
    return &machine->elements[0];
}

/// Rejects "elements.0.gap": elements are numbered among their kind, not in the file's order.
static whirl_status refuse_number(const machine_parts *machine, const char *rest) {
    const char *const dot = strrchr(rest, '.'), *const key = dot ? dot + 1 : rest;
    const setting_list *const element = element_with(machine, key);
    const bool known = whirl_group_key(element->group, key) != NULL;
    return whirl_fail(WHIRL_BAD_INPUT, "elements are set by their kind, expected a name as in %s.%s", element->name,
                      known ? key : element->group->keys[0].name);
}

/// Reports how a name must begin, if an element needs a number, or a key of the rotor has no element.
static whirl_status refuse_name(const case_content *content, const char *head, const char *rest) {
    const machine_parts *const machine = &content->machine;
    const char *names[MAX_NAMES];
    char advice[WHY_SIZE];
    const element_name element = split_element(head);
    if (strcmp(element.kind, "elements") == 0 && machine->element_count > 0) return refuse_number(machine, rest);
    if (whirl_group_key(&schema_rotor, element.kind))
        return whirl_fail(WHIRL_BAD_INPUT, "%.60s is a key of the rotor, did you mean rotor.%.60s.%.60s?", head, head,
                          rest);
    describe_names(element.kind, names, collect_names(content, names), advice);
    if (strchr(rest, '.')) return whirl_fail(WHIRL_BAD_INPUT, "the case has no %.60s, %s", head, advice);
    return whirl_fail(WHIRL_BAD_INPUT, "the case has no %.60s whose %.60s could be set, %s", head, rest, advice);
}

static bool is_root(const char *head) {
    return whirl_group_key(&schema_case, head) != NULL;
}

whirl_status path_of_name(const case_content *content, const char *name, char path[PATH_SIZE]) {
    // Split the name at its first dot.
    const machine_parts *const machine = &content->machine;
    const char *const dot = strchr(name, '.');
    char head[WHIRL_NAME_SIZE];
    if (!dot || dot == name || (size_t)(dot - name) >= sizeof head || strlen(name) >= PATH_SIZE - 32 || !dot[1])
        return whirl_fail(WHIRL_BAD_INPUT, "%.60s is no key, expected a name as in disc.mass", name);
    memcpy(head, name, (size_t)(dot - name));
    head[dot - name] = '\0';
    // Find the part of the case that has the first word as a key or as a name.
    const element_name element = split_element(head);
    if (is_root(head))
        snprintf(path, PATH_SIZE, "%s", name);
    else if (named_find(&machine->stations, head) < machine->stations.count)
        snprintf(path, PATH_SIZE, "rotor.stations.%s", name);
    else if (named_find(&machine->shafts, head) < machine->shafts.count)
        snprintf(path, PATH_SIZE, "rotor.shafts.%s", name);
    else if (named_find(&machine->materials, head) < machine->materials.count)
        snprintf(path, PATH_SIZE, "rotor.materials.%s", name);
    else if (count_kind(machine, element.kind) > 0)
        return element_path(machine, head, dot + 1, path);
    else if (whirl_group_key(&schema_study, head))
        snprintf(path, PATH_SIZE, "study.%s", name);
    else
        return refuse_name(content, head, dot + 1);
    return whirl_ok();
}
