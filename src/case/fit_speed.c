#include "fit_speed.h"

const parameter *fit_shaft_parameter(const case_reader *reader, const fit_parts *parts) {
    const setting *speed = settings_find(&parts->machine->rotor, "speed");
    const parameter *own = speed ? formula_parameter(reader->parameters, &speed->value) : NULL;
    return own && !own->value.expression ? own : NULL;
}

const parameter *fit_speed_parameter(const case_reader *reader, const fit_parts *parts, const fit_set *set) {
    const parameter *own = fit_shaft_parameter(reader, parts);
    for (size_t u = 0; u < parts->unknown_count; u++)
        if (parts->unknowns[u].parameter == own) return NULL;
    for (size_t i = 0; i < set->at.count; i++)
        if (set->at.parameters[i] == own) return NULL;
    return own;
}
