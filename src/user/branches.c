// Branches of orbits or equilibria of a user's system: sets their parameter and starts, and makes the batches of their
// study.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number_text.h"
#include "user.h"
#include "whirl/status.h"

// ---------------------------------------------------------------- parameters and starts

static bool lies_between(double value, const double bounds[2]) {
    return value >= fmin(bounds[0], bounds[1]) && value <= fmax(bounds[0], bounds[1]);
}

static whirl_status check_bounds(const char *parameter, const double bounds[2]) {
    if (isfinite(bounds[0]) && isfinite(bounds[1]) && bounds[0] != bounds[1]) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "branches go over %s from %g to %g, expected two different finite numbers",
                      parameter, bounds[0], bounds[1]);
}

whirl_status whirl_user_system_branch(whirl_user_system *system, const char *parameter, double from, double to,
                                      const double *at, size_t count) {
    user_branches *own = &system->branches;
    const double bounds[2] = {from, to};
    size_t index;
    whirl_status status = user_require_parameter(system, parameter, &index);
    if (status.code == WHIRL_OK) status = check_bounds(parameter, bounds);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < count; i++)
        if (!lies_between(at[i], bounds))
            return whirl_fail(WHIRL_BAD_INPUT, "a branch begins at %s = %g, expected a value from %g to %g", parameter,
                              at[i], from, to);
    double *copy = count > 0 ? malloc(count * sizeof *copy) : NULL;
    if (count > 0 && !copy) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu values", count);
    if (copy) memcpy(copy, at, count * sizeof *copy);
    free(own->at);
    own->wanted = true;
    own->parameter = index;
    memcpy(own->bounds, bounds, sizeof bounds);
    own->count = count;
    own->at = copy;
    return status;
}

whirl_status whirl_user_system_curves(whirl_user_system *system, const char *parameter, double from, double to) {
    const double bounds[2] = {from, to};
    size_t index;
    whirl_status status = user_require_parameter(system, parameter, &index);
    if (status.code == WHIRL_OK) status = check_bounds(parameter, bounds);
    if (status.code != WHIRL_OK) return status;
    if (!lies_between(system->parameters[index].value, bounds))
        return whirl_fail(WHIRL_BAD_INPUT, "curves go over %s from %g to %g, expected two bounds around its value, %g",
                          parameter, from, to, system->parameters[index].value);
    system->branches.curves = true;
    system->branches.second = index;
    memcpy(system->branches.second_bounds, bounds, sizeof bounds);
    return status;
}

static void branches_put_number(FILE *out, const char *before, double number) {
    char text[NUMBER_SIZE];
    number_text(number, text);
    fprintf(out, "%s%s", before, text);
}

void user_put_branches(const whirl_user_system *system, FILE *out) {
    const user_branches *own = &system->branches;
    fprintf(out, "over %s", system->parameters[own->parameter].name);
    branches_put_number(out, " from ", own->bounds[0]);
    branches_put_number(out, " to ", own->bounds[1]);
    for (size_t i = 0; i < own->count; i++) branches_put_number(out, i > 0 ? ", " : ", begun at ", own->at[i]);
    if (!own->curves) return;
    fprintf(out, "; curves over %s", system->parameters[own->second].name);
    branches_put_number(out, " from ", own->second_bounds[0]);
    branches_put_number(out, " to ", own->second_bounds[1]);
}

// ---------------------------------------------------------------- their study

static whirl_status branches_check(const whirl_user_system *system) {
    const user_branches *own = &system->branches;
    const whirl_trace_options *trace = &system->record.trace;
    if (system->axis_count > 0)
        return whirl_fail(WHIRL_BAD_INPUT, "%s varies, and branches are followed, expected one of the two",
                          system->parameters[system->axes[0].parameter].name);
    if (system->analyses != 0 || system->options.confirm)
        return whirl_fail(WHIRL_BAD_INPUT, "a branch has neither analyses nor verdicts of motions, expected none");
    if (own->curves && own->second == own->parameter)
        return whirl_fail(WHIRL_BAD_INPUT, "curves go over %s, as the branches do, expected another parameter",
                          system->parameters[own->second].name);
    if (trace->tori && trace->rest)
        return whirl_fail(WHIRL_BAD_INPUT, "tori begin at orbits of systems that are driven in time, expected none "
                                           "with equilibria");
    return whirl_ok();
}

/// Clears the recording options: branches record nothing.
static void clear_record(whirl_record_options *record) {
    record->spectra = record->waveform = record->orbits = false;
    record->growth = WHIRL_GROWTH_NONE;
    record->waveform_revolutions = record->watch = 0;
}

static whirl_batch branch_batch(const whirl_user_system *system) {
    const user_branches *own = &system->branches;
    whirl_batch batch = system->options;
    snprintf(batch.name, sizeof batch.name, "branch");
    batch.role = WHIRL_ROLE_BRANCHES;
    memcpy(batch.parameter, system->parameters[own->parameter].name, sizeof batch.parameter);
    batch.count = own->count > 0 ? own->count : 1;
    batch.values = own->count > 0 ? own->at : own->bounds;
    memcpy(batch.bounds, own->bounds, sizeof batch.bounds);
    batch.integrate = system->integrate;
    batch.record = system->record;
    clear_record(&batch.record);
    whirl_analysis_add(&batch.analyses, "trace");
    return batch;
}

static whirl_batch curves_batch(const whirl_user_system *system, const whirl_batch *branch) {
    const user_branches *own = &system->branches;
    whirl_batch batch = *branch;
    snprintf(batch.name, sizeof batch.name, "curves");
    batch.role = WHIRL_ROLE_CURVES;
    memcpy(batch.second, system->parameters[own->second].name, sizeof batch.second);
    batch.second_value = system->parameters[own->second].value;
    memcpy(batch.second_bounds, own->second_bounds, sizeof batch.second_bounds);
    return batch;
}

static whirl_batch tori_batch(const whirl_batch *branch) {
    whirl_batch batch = *branch;
    snprintf(batch.name, sizeof batch.name, "tori");
    batch.role = WHIRL_ROLE_TORI;
    batch.analyses = 0;
    whirl_analysis_add(&batch.analyses, "torus");
    return batch;
}

whirl_status user_prepare_branches(whirl_user_system *copy, whirl_study *study) {
    const user_branches *own = &copy->branches;
    const whirl_status status = branches_check(copy);
    if (status.code != WHIRL_OK) return status;
    copy->axis_count = own->curves ? 2 : 1;
    copy->axes[0] = (user_axis){.parameter = own->parameter};
    copy->axes[1] = (user_axis){.parameter = own->second};
    copy->smooth = true;
    study->batches[study->batch_count++] = branch_batch(copy);
    if (own->curves) study->batches[study->batch_count++] = curves_batch(copy, &study->batches[0]);
    if (copy->record.trace.tori) study->batches[study->batch_count++] = tori_batch(&study->batches[0]);
    return status;
}

// ---------------------------------------------------------------- systems that depend on time

/// Returns true if the slopes at a state [dimension] depend on time; slopes [2][dimension] is workspace.
static bool changes_with_time(const whirl_system *system, const double *x, double *slopes, size_t *which) {
    enum { LOOKS = 5 };
    double *other = slopes + system->dimension;
    for (int look = 0; look < LOOKS; look++) {
        const double t = system->period * 0.19 * look; // instants without any symmetry
        system->rhs(system->model, t, &t, x, look == 0 ? slopes : other);
        for (size_t i = 0; i < system->dimension && look > 0; i++)
            if (fabs(other[i] - slopes[i]) > 1e-12 * fmax(fabs(other[i]), fabs(slopes[i]))) {
                *which = i;
                return true;
            }
    }
    return false;
}

/// Checks that a machine's slopes do not depend on time, at its start and at a state near it, since a drive may vanish
/// at one of the two.
static whirl_status check_machine(const whirl_batch *batch, double value, const whirl_machine *machine) {
    const size_t n = machine->system->dimension;
    size_t which = 0;
    double *slopes = malloc(3 * n * sizeof *slopes), *shifted = slopes ? slopes + 2 * n : NULL;
    if (!slopes) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu slopes", n);
    for (size_t i = 0; i < n; i++)
        shifted[i] = machine->start[i] + 0.01 * (1.0 + 0.37 * (double)i) * (1.0 + fabs(machine->start[i]));
    const bool driven = changes_with_time(machine->system, machine->start, slopes, &which) ||
                        changes_with_time(machine->system, shifted, slopes, &which);
    free(slopes);
    if (!driven) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "slope %zu changes with t at %s = %.10g, expected a system that nothing drives "
                      "in time, which has equilibria (trace_rest)",
                      which, batch->parameter, value);
}

whirl_status user_check_rest(const whirl_study *study) {
    const whirl_batch *batch = &study->batches[0];
    whirl_status status = whirl_ok();
    if (!whirl_analysis_kind(batch->analyses)->found || !batch->record.trace.rest) return status;
    for (size_t i = 0; i < batch->count + 2 && status.code == WHIRL_OK; i++) {
        const double value = i < 2 ? batch->bounds[i] : batch->values[i - 2];
        whirl_machine machine;
        status = study->machine(study->family, batch, value, &machine);
        if (status.code != WHIRL_OK) break;
        status = check_machine(batch, value, &machine);
        if (machine.release) machine.release(machine.owner);
    }
    return status;
}
