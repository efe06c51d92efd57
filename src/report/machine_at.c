#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine_at.h"
#include "two_pi.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

whirl_status machine_of(const whirl_result *result, whirl_case **machine) {
    const char *text = result->case_text ? result->case_text : "";
    whirl_status status = whirl_case_parse(text, strlen(text), "case", NULL, machine);
    for (size_t i = 0; i < result->parameter_count && status.code == WHIRL_OK; i++) {
        const whirl_parameter *parameter = &result->parameters[i];
        double value;
        char assignment[sizeof parameter->name + sizeof parameter->text + 2];
        if (whirl_case_parameter(*machine, parameter->name, &value).code == WHIRL_OK && value == parameter->value)
            continue;
        snprintf(assignment, sizeof assignment, "%s=%s", parameter->name, parameter->text);
        status = whirl_case_set(*machine, assignment);
        if (status.code != WHIRL_OK) whirl_case_free(*machine);
    }
    if (status.code == WHIRL_OK) return status;
    *machine = NULL;
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

whirl_status machines_of(const whirl_result *const *results, size_t count, whirl_case ***machines) {
    whirl_status status = whirl_ok();
    *machines = calloc(count + 1, sizeof **machines);
    if (!*machines) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the cases of %zu results", count);
    for (size_t r = 0; r < count && status.code == WHIRL_OK; r++) status = machine_of(results[r], &(*machines)[r]);
    return status;
}

void machines_free(whirl_case **machines, size_t count) {
    for (size_t r = 0; machines && r < count; r++) whirl_case_free(machines[r]);
    free((void *)machines);
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

/// Finds the largest eccentricity of a journal in every direction, with all other stations centred. Returns false if
/// the wall is unknown.
static bool find_wall(const whirl_system *system, size_t station, double clearance, double *radius) {
    const whirl_probe *probe = &system->probes[station];
    whirl_film_gap gap;
    double *x = system->film ? calloc(system->dimension + 1, sizeof *x) : NULL;
    bool found = x != NULL && probe->x != probe->y;
    for (size_t k = 0; k < WALL_ANGLES && found; k++) {
        const double angle = two_pi * (double)k / WALL_ANGLES;
        x[probe->x] = 0.5 * clearance * cos(angle);
        x[probe->y] = 0.5 * clearance * sin(angle);
        found = system->film(system->model, x, station, &gap) && gap.wall > 0.0 && isfinite(gap.wall);
        if (found) radius[k] = gap.wall;
    }
    free(x);
    return found;
}

void machine_wall_at(const whirl_case *machine, const whirl_table *table, size_t point, size_t station,
                     double clearance, machine_wall *out) {
    static const double rounding = 1e-9;
    whirl_machine own;
    const bool made = clearance > 0.0 && machine_at(machine, table, point, &own);
    const bool found = made && find_wall(own.system, station, clearance, out->radius);
    if (made) own.release(own.owner);
    for (size_t k = 0; k < WALL_ANGLES && !found; k++) out->radius[k] = clearance;
    out->round = true;
    for (size_t k = 0; k < WALL_ANGLES; k++)
        out->round = out->round && fabs(out->radius[k] - clearance) <= rounding * clearance;
}

double machine_wall_radius(const machine_wall *wall, double angle) {
    const double at = (angle / two_pi - floor(angle / two_pi)) * WALL_ANGLES;
    const size_t k = (size_t)at % WALL_ANGLES, next = (k + 1) % WALL_ANGLES;
    return wall->radius[k] + (at - floor(at)) * (wall->radius[next] - wall->radius[k]);
}
