#include "machine_at.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

whirl_case *machine_of(const whirl_result *result) {
    whirl_case *machine;
    const char *text = result->case_text ? result->case_text : "";
    if (whirl_case_parse(text, strlen(text), "case", NULL, &machine).code != WHIRL_OK) return NULL;
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *parameter = &result->parameters[i];
        double value;
        char assignment[sizeof parameter->name + sizeof parameter->text + 2];
        if (whirl_case_parameter(machine, parameter->name, &value).code == WHIRL_OK && value == parameter->value)
            continue;
        snprintf(assignment, sizeof assignment, "%s=%s", parameter->name, parameter->text);
        if (whirl_case_set(machine, assignment).code == WHIRL_OK) continue;
        whirl_case_free(machine);
        return NULL;
    }
    return machine;
}

double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point) {
    whirl_rotor *rotor;
    if (!*table->parameter) return whirl_result_clock(result);
    if (!machine || whirl_case_rotor(machine, table->parameter, table->values[point], &rotor).code != WHIRL_OK)
        return (double)NAN;
    const double clock = whirl_rotor_clock(rotor);
    whirl_rotor_free(rotor);
    return clock;
}

machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station) {
    const whirl_probe *probe = &result->stations[station];
    whirl_rotor *rotor = NULL;
    if (machine && *table->parameter &&
        whirl_case_rotor(machine, table->parameter, table->values[point], &rotor).code == WHIRL_OK)
        probe = &whirl_rotor_system(rotor)->probes[station];
    const machine_walls walls = {probe->clearance, probe->gap};
    whirl_rotor_free(rotor);
    return walls;
}
