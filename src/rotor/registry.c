// Registry of elements, one line each, in the order in which they act.
#include <string.h>

#include "registry.h"
#include "shafts.h"
#include "whirl/engine/rotor.h"

#define ADDRESS(name) &name##_element,
const element_type *const element_types[] = {ELEMENTS(ADDRESS) NULL};

#define GROUP(name) &name##_element.group,
static const whirl_group *const groups[] = {ELEMENTS(GROUP) NULL};

const whirl_group *whirl_station_keys(void) {
    return &station_group;
}

const whirl_group *whirl_shaft_keys(void) {
    return &shaft_group;
}

const whirl_group *whirl_material_keys(void) {
    return &material_group;
}

const whirl_group *const *whirl_element_groups(void) {
    return groups;
}

const whirl_group *whirl_element_group(const char *name) {
    for (const whirl_group *const *group = groups; *group; group++)
        if (strcmp((*group)->name, name) == 0) return *group;
    return NULL;
}
