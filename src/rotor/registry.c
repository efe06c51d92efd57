// The elements that a rotor can be made of, one line each, in the order in which they act.
#include <string.h>

#include "element.h"
#include "whirl/rotor.h"

const element_type *const element_types[] = {
    &unbalance_element, &gravity_element, &shaft_element, &film_element, &rub_element, NULL,
};

enum { ELEMENT_TYPES = sizeof element_types / sizeof *element_types };

const whirl_group *whirl_station_keys(void) {
    return &station_group;
}

const whirl_group *const *whirl_element_groups(void) {
    static const whirl_group *const groups[ELEMENT_TYPES] = {
        &unbalance_element.group, &gravity_element.group, &shaft_element.group,
        &film_element.group,      &rub_element.group,     NULL,
    };
    return groups;
}

const whirl_group *whirl_element_group(const char *name) {
    for (const whirl_group *const *group = whirl_element_groups(); *group; group++)
        if (strcmp((*group)->name, name) == 0) return *group;
    return NULL;
}
