#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report_parts.h"

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

whirl_batch *machine_batch(const whirl_case *machine, const whirl_table *table, size_t point, whirl_study *study) {
    if (!machine || whirl_case_study(machine, study).code != WHIRL_OK) return NULL;
    for (size_t i = 0; i < study->batch_count; i++) {
        whirl_batch *batch = &study->batches[i];
        if (strcmp(batch->name, table->name) != 0) continue;
        batch->second_value = whirl_table_second(table, point);
        batch->third_value = whirl_table_third(table, point);
        return batch;
    }
    return NULL;
}

bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out) {
    whirl_study study;
    const whirl_batch *batch = machine_batch(machine, table, point, &study);
    return batch && study.machine(study.family, batch, table->values[point], out).code == WHIRL_OK;
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

// ---------------------------------------------------------------- named_lines

/// Orders of lines are interpolated between bins.
static const double tolerance = 0.005;

/// Of multiples and sidebands of a named order, which of them a line is, the simplest first; 0: none.
static int simplest(double line, const whirl_named_order *of, char name[LINE_NAME_SIZE]) {
    enum { MULTIPLES = 4 };
    for (int n = 1; n <= MULTIPLES; n++) {
        if (fabs(line - n * of->order) > tolerance) continue;
        if (n == 1)
            snprintf(name, LINE_NAME_SIZE, "%s", of->name);
        else
            snprintf(name, LINE_NAME_SIZE, "%d %s", n, of->name);
        return n;
    }
    for (int side = -1; side <= 1; side += 2) {
        if (fabs(line - of->order - side) > tolerance) continue;
        snprintf(name, LINE_NAME_SIZE, "%s %c 1X", of->name, side < 0 ? '-' : '+');
        return MULTIPLES + 1;
    }
    return 0;
}

bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of) {
    int best = 0;
    whirl_named_order next;
    for (size_t i = 0; system->named_order && system->named_order(system->model, i, &next); i++) {
        char called[LINE_NAME_SIZE];
        const int rank = 2 * simplest(order, &next, called) + (next.probe != station);
        if (rank < 2 || (best > 0 && rank >= best)) continue;
        best = rank;
        *of = next;
        snprintf(name, LINE_NAME_SIZE, "%s", called);
    }
    return best > 0;
}
