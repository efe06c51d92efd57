#include "path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "schema.h"

enum { MOST_NAMES = WHIRL_MAX_STATIONS + 64 };

// ---------------------------------------------------------------- elements

/// "film" or "film[2]": the kind, and which of its elements (0 where none is said).
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

/// An element by its number among those of its kind, from 1.
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
    // `gravity: 9.81 m/s2`: the value stands where the mapping would.
    const bool alone = element->place->kind == NODE_TEXT && element->group->shorthand &&
                       strcmp(element->group->shorthand, key) == 0 && element->place->key;
    snprintf(path, PATH_SIZE, alone ? "%.200s" : "%.200s.%s", place, key);
    return whirl_ok();
}

// ---------------------------------------------------------------- all names

/// What the first word of a short name may be.
static size_t collect_names(const case_content *content, const char *names[MOST_NAMES]) {
    const machine_parts *const machine = &content->machine;
    size_t count = 0;
    for (size_t i = 0; i < machine->station_count; i++) names[count++] = machine->station_names[i];
    for (const whirl_group *const *group = whirl_element_groups(); *group && count < MOST_NAMES; group++)
        if (count_kind(machine, (*group)->name) > 0) names[count++] = (*group)->name;
    for (size_t k = 0; k < schema_study.key_count && count < MOST_NAMES; k++)
        names[count++] = schema_study.keys[k].name;
    return count;
}

static bool is_root(const char *head) {
    return whirl_group_key(&schema_case, head) != NULL;
}

whirl_status path_of_name(const case_content *content, const char *name, char path[PATH_SIZE]) {
    const machine_parts *const machine = &content->machine;
    const char *names[MOST_NAMES], *const dot = strchr(name, '.');
    char head[WHIRL_NAME_SIZE], advice[WHY_SIZE];
    if (!dot || dot == name || (size_t)(dot - name) >= sizeof head || strlen(name) >= PATH_SIZE - 32 || !dot[1])
        return whirl_fail(WHIRL_BAD_INPUT, "%.60s is no key, expected a name as in disc.mass", name);
    memcpy(head, name, (size_t)(dot - name));
    head[dot - name] = '\0';
    const element_name element = split_element(head);
    if (is_root(head))
        snprintf(path, PATH_SIZE, "%s", name);
    else if (machine_station(machine, head) < machine->station_count)
        snprintf(path, PATH_SIZE, "rotor.stations.%s", name);
    else if (count_kind(machine, element.kind) > 0)
        return element_path(machine, head, dot + 1, path);
    else if (whirl_group_key(&schema_study, head))
        snprintf(path, PATH_SIZE, "study.%s", name);
    else {
        describe_names(element.kind, names, collect_names(content, names), advice);
        return whirl_fail(WHIRL_BAD_INPUT, "the case has no %.60s whose %.60s could be set, %s", head, dot + 1, advice);
    }
    return whirl_ok();
}
