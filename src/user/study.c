// Runs the study of a user's system, and describes the system in its result.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "user.h"
#include "whirl/engine/case.h"

/// A system with the additional data of a run: a station, if it has none, and the values of all points.
typedef struct prepared {
    whirl_user_system system; ///< a copy that borrows the arrays of the user's system
    whirl_probe station;
    whirl_study study;
    double *values; ///< [axes][count]
} prepared;

static whirl_status machine_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    const whirl_user_system *system = family;
    const double varied[USER_AXES] = {value, batch->second_value, batch->third_value};
    double parameters[USER_MAX_PARAMETERS] = {0};
    for (size_t k = 0; k < system->parameter_count; k++) parameters[k] = system->parameters[k].value;
    for (size_t i = 0; i < system->axis_count && i < USER_AXES; i++)
        if (i != 1 || *batch->second) parameters[system->axes[i].parameter] = varied[i];
    return user_machine(system, parameters, batch->stop, machine);
}

// ---------------------------------------------------------------- a study

static whirl_status study_check(const whirl_user_system *system) {
    if (!system->rates && !system->lanes)
        return whirl_fail(WHIRL_BAD_INPUT, "the system has no function for its slopes");
    if (system->event_count > 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the system has events, which only motions over time can have, expected none in "
                          "a study");
    for (size_t i = 0; i < system->station_count && system->displacements > 0; i++) {
        const whirl_probe *one = &system->stations[i];
        const size_t d = system->displacements;
        if (one->x >= d || one->y >= d || one->vx != d + one->x || one->vy != d + one->y)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "station %s is of coordinates %zu and %zu, expected displacements, 0 to %zu, with their "
                              "velocities",
                              one->name, one->x, one->y, d - 1);
    }
    if (system->carry != WHIRL_CARRY_NONE && system->axis_count != 1)
        return whirl_fail(WHIRL_BAD_INPUT, "carry needs a sweep, of one parameter that varies");
    return whirl_ok();
}

/// Makes a station of the first two coordinates, or of the first two displacements.
static whirl_probe first_station(const whirl_user_system *system) {
    const size_t d = system->displacements, n = d > 0 ? d : system->dimension;
    whirl_probe one = {.name = "state", .x = 0, .y = n > 1 ? 1 : 0};
    one.vx = d + one.x;
    one.vy = d + one.y;
    return one;
}

/// Fills in the values of all points, the first axis fastest.
static whirl_status fill_values(prepared *p, whirl_batch *batch) {
    const whirl_user_system *system = &p->system;
    double count = 1.0;
    for (size_t i = 0; i < system->axis_count; i++) count *= (double)system->axes[i].count;
    if (count > 1e7) return whirl_fail(WHIRL_BAD_INPUT, "the study has %.0f points, expected at most 10000000", count);
    batch->count = (size_t)count;
    if (system->axis_count == 0) return whirl_ok();
    p->values = malloc(system->axis_count * batch->count * sizeof *p->values);
    if (!p->values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the values of %zu points", batch->count);
    for (size_t i = 0, step = 1; i < system->axis_count; step *= system->axes[i++].count)
        for (size_t k = 0; k < batch->count; k++)
            p->values[i * batch->count + k] = system->axes[i].values[k / step % system->axes[i].count];
    return whirl_ok();
}

static void name_axes(const prepared *p, whirl_batch *batch) {
    const user_axis *axes = p->system.axes;
    const whirl_parameter *names = p->system.parameters;
    const size_t count = p->system.axis_count;
    if (count > 0) memcpy(batch->parameter, names[axes[0].parameter].name, sizeof batch->parameter);
    batch->values = p->values;
    if (count < 2) return;
    memcpy(batch->second, names[axes[1].parameter].name, sizeof batch->second);
    batch->second_values = p->values + batch->count;
    batch->row = axes[0].count;
    if (count < 3) return;
    memcpy(batch->third, names[axes[2].parameter].name, sizeof batch->third);
    batch->third_values = p->values + 2 * batch->count;
    batch->plane = axes[0].count * axes[1].count;
}

/// Returns the direction of carrying. "up" means along rising values, also if values are listed from large to small.
static whirl_carry carry_of(const whirl_user_system *system) {
    const user_axis *axis = &system->axes[0];
    const bool falls = system->axis_count > 0 && axis->values[axis->count - 1] < axis->values[0];
    if (system->carry == WHIRL_CARRY_FORWARD && falls) return WHIRL_CARRY_REVERSE;
    return system->carry == WHIRL_CARRY_REVERSE && falls ? WHIRL_CARRY_FORWARD : system->carry;
}

/// Prepares the only batch of a study of motions, with a point for all values of the axes.
static whirl_status prepare_points(prepared *p) {
    static const char *const usual[] = {"poincare", "regime", "lyapunov", "orbit"};
    static const char *const names[] = {"response", "sweep", "map", "map"};
    static const whirl_role roles[] = {WHIRL_ROLE_POINT, WHIRL_ROLE_SURVEY, WHIRL_ROLE_MAP, WHIRL_ROLE_MAP};
    const whirl_user_system *system = &p->system;
    whirl_batch *batch = &p->study.batches[0];
    // Copy the options of the system, with its axes.
    *batch = system->options;
    snprintf(batch->name, sizeof batch->name, "%s", names[system->axis_count]);
    batch->role = roles[system->axis_count];
    whirl_status status = fill_values(p, batch);
    if (status.code != WHIRL_OK) return status;
    name_axes(p, batch);
    batch->carry = carry_of(system);
    batch->integrate = system->integrate;
    batch->record = system->record;
    batch->analyses = system->analyses;
    // Use the default analyses if the user names none.
    for (size_t i = 0; system->analyses == 0 && i < sizeof usual / sizeof *usual; i++)
        whirl_analysis_add(&batch->analyses, usual[i]);
    whirl_analysis_needs(batch->analyses, &batch->record);
    p->system.smooth = system->kinked || batch->record.growth == WHIRL_GROWTH_ALL;
    p->study.batch_count = 1;
    return status;
}

static void prepared_free(const prepared *p) {
    free(p->values);
    free(p->system.units);
}

/// Prepares a system. Freed by prepared_free, also after a failure.
static whirl_status study_prepare(const whirl_user_system *system, prepared *p) {
    *p = (prepared){.system = *system, .station = first_station(system)};
    whirl_status status = study_check(system);
    if (status.code != WHIRL_OK) return status;
    if (system->station_count == 0) {
        p->system.stations = &p->station;
        p->system.station_count = 1;
    }
    p->study.machine = machine_at;
    p->study.family = &p->system;
    status = system->branches.wanted ? user_prepare_branches(&p->system, &p->study) : prepare_points(p);
    if (status.code == WHIRL_OK) status = user_check_form(&p->system);
    if (status.code == WHIRL_OK) status = user_choose_units(&p->system, &p->study);
    // Failures during trial runs are discarded.
    atomic_store(&p->system.failure->code, 0);
    atomic_store(&p->system.failure->reported, 0);
    return status;
}

// ---------------------------------------------------------------- a result

/// Sets clock_of of a table: the number of its parameter that sets the period.
static void name_clock(const whirl_user_system *system, whirl_table *table) {
    const char *const names[USER_AXES] = {table->parameter, table->second, table->third};
    for (size_t i = 0; i < system->axis_count; i++)
        if (system->axes[i].parameter == system->speed && *names[i]) table->clock_of = (int)i + 1;
}

static whirl_status study_describe(const whirl_user_system *system, whirl_result *result) {
    double values[USER_MAX_PARAMETERS], period;
    // Rates and scales.
    for (size_t k = 0; k < system->parameter_count; k++) values[k] = system->parameters[k].value;
    whirl_status status = user_period(system, values, &period);
    if (status.code != WHIRL_OK) return status;
    snprintf(result->title, sizeof result->title, "%s", system->title);
    result->speed = 2.0 * acos(-1.0) / period;
    result->length_scale = result->force_scale = 1.0;
    // Copy parameters and stations.
    result->parameters = calloc(system->parameter_count + 1, sizeof *result->parameters);
    result->stations = calloc(system->station_count, sizeof *result->stations);
    result->contacts = calloc(1, sizeof *result->contacts);
    if (!result->parameters || !result->stations || !result->contacts)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the parameters of a result");
    if (system->parameter_count > 0)
        memcpy(result->parameters, system->parameters, system->parameter_count * sizeof *result->parameters);
    memcpy(result->stations, system->stations, system->station_count * sizeof *result->stations);
    result->parameter_count = system->parameter_count;
    result->station_count = system->station_count;
    // Name the clock of each table, then add equations, warnings and provenance.
    for (size_t k = 0; k < result->table_count; k++) name_clock(system, &result->tables[k]);
    status = user_add_equations(system, result);
    if (status.code == WHIRL_OK) status = user_warn_of_units(system, result);
    return status.code == WHIRL_OK ? whirl_result_add_provenance(result) : status;
}

/// Returns the outcome of a run: a result from failed slopes is discarded.
static whirl_status study_outcome(const whirl_user_system *system, whirl_status status, whirl_result **result) {
    const int code = atomic_load(&system->failure->code);
    if (code == USER_JUMP)
        status = whirl_fail(WHIRL_NUMERICAL_FAILURE,
                            "slope %zu of the system jumps by %.3g at t = %.10g, expected slopes without jumps where "
                            "the derivative is used, for kinked systems, exponents and multipliers: leave these out "
                            "(a damped contact is not kinked)",
                            system->failure->slope, system->failure->jump, system->failure->time);
    else if (code != 0)
        status = whirl_fail(WHIRL_NUMERICAL_FAILURE, "a function of the system gave %d at t = %.10g, expected 0", code,
                            atomic_load(&system->failure->reported) ? system->failure->time : (double)NAN);
    if (*result && code == 0) {
        whirl_status described = study_describe(system, *result);
        for (size_t i = 0; i < (*result)->table_count && described.code == WHIRL_OK; i++)
            described = user_restore(system, &(*result)->tables[i]);
        if (described.code == WHIRL_OK) return status;
        status = described;
    }
    whirl_result_free(*result);
    *result = NULL;
    return status;
}

static whirl_status study_run_points(const void *subject, const whirl_run_options *options, whirl_result **result) {
    prepared p;
    *result = NULL;
    whirl_status status = study_prepare(subject, &p);
    if (status.code == WHIRL_OK) status = user_check_rest(&p.study);
    if (status.code == WHIRL_OK) {
        status = whirl_study_run(&p.study, options, result);
        status = study_outcome(&p.system, status, result);
    }
    prepared_free(&p);
    return status;
}

whirl_status whirl_user_system_outline(const whirl_user_system *system, whirl_result **outline) {
    prepared p;
    *outline = NULL;
    if (!system->identity)
        return whirl_fail(WHIRL_BAD_INPUT, "the system has no identity, by which a journal would know its functions "
                                           "again, expected a name and a version (whirl_user_system_identity)");
    whirl_status status = study_prepare(system, &p);
    if (status.code == WHIRL_OK) {
        status = whirl_study_outline(&p.study, outline);
        status = study_outcome(&p.system, status, outline);
    }
    prepared_free(&p);
    return status;
}

whirl_status whirl_job_of_user_system(const whirl_user_system *system, whirl_job **job) {
    return whirl_job_of(study_run_points, system, job);
}
