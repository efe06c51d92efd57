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

bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out) {
    whirl_study study;
    if (!machine || whirl_case_study(machine, &study).code != WHIRL_OK) return false;
    for (size_t i = 0; i < study.batch_count; i++) {
        whirl_batch *batch = &study.batches[i];
        if (strcmp(batch->name, table->name) != 0) continue;
        batch->second_value = whirl_table_second(table, point);
        batch->third_value = whirl_table_third(table, point);
        return study.machine(study.family, batch, table->values[point], out).code == WHIRL_OK;
    }
    return false;
}

double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point) {
    whirl_machine own;
    if (!machine_at(machine, table, point, &own)) return *table->parameter ? (double)NAN : whirl_result_clock(result);
    const double clock = own.clock;
    own.release(own.owner);
    return clock;
}

machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station) {
    whirl_machine own;
    const bool made = machine_at(machine, table, point, &own);
    const whirl_probe *probe = made ? &own.system->probes[station] : &result->stations[station];
    const machine_walls walls = {probe->clearance, probe->gap};
    if (made) own.release(own.owner);
    return walls;
}
