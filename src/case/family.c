// A case as a family of machines, and as a study.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "content.h"
#include "exhausted.h"
#include "mapped.h"
#include "plan.h"
#include "plan_dataset.h"
#include "plan_fit.h"
#include "whirl/engine/running.h"

typedef struct member {
    whirl_rotor *rotor;
    double *start;                  ///< [dimension]
    whirl_station_statics *statics; ///< [stations] if requested
    double *influence;              ///< [stations][stations]
    double changed_speed;           ///< rad/s, of the drive without load after a change; 0: none
    course_run *course;             ///< events and laws of a run-up, or NULL
    whirl_runup_options run;        ///< options of its run, in place of those of the batch
    bool recorded;                  ///< `run` is set
    double delay;                   ///< s, time at which its run begins in the table of a fit
} member;

static void family_release(void *owner) {
    member *m = owner;
    whirl_rotor_free(m->rotor);
    free(m->start);
    free(m->statics);
    free(m->influence);
    course_free(m->course);
    free(m);
}

/// Makes the initial state of a rotor.
static whirl_status make_start(const case_content *content, const whirl_batch *batch, valuation *v, member *m) {
    const whirl_system *system = whirl_rotor_system(m->rotor);
    m->start = calloc(system->dimension, sizeof *m->start);
    if (!m->start) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    return plan_start_state(&content->plan, plan_batch(&content->plan, batch->name), batch->start, v, m->rotor,
                            m->start);
}

/// Returns the changes to the machine that a batch's variant asks for.
static machine_choice choose(const whirl_batch *batch) {
    machine_choice choice = {.placed_count = batch->placed_count,
                             .placed = batch->placed,
                             .stages = 1.0,
                             .in_time = plan_moves(batch),
                             .spool_count = batch->spool_count,
                             .spool_speeds = batch->spool_speeds,
                             .spools_vary = batch->spools_vary,
                             .asynchronous = batch->asynchronous,
                             .frequency = batch->frequency};
    if (batch->variant == WHIRL_WITH_STAGES) choice.drag = WHIRL_DRAG_STAGES, choice.stages = batch->variant_value;
    if (batch->variant == WHIRL_WITH_DRAG_AT)
        choice.drag = WHIRL_DRAG_AT, choice.drag_at = (size_t)batch->variant_value;
    return choice;
}

/// Builds the variant of a batch.
static whirl_status family_build(const machine_parts *machine, const whirl_batch *batch, double value, valuation *v,
                                 whirl_rotor **rotor) {
    const machine_choice choice = choose(batch);
    if (batch->variant == WHIRL_BEARINGS_OF_IT) return machine_build_bearings(machine, v, batch->speed, rotor);
    if (batch->variant == WHIRL_HELD)
        return machine_build_on_springs(machine, v, batch->speed, WHIRL_BEARINGS_HELD, batch->variant_value, rotor);
    if (batch->variant != WHIRL_AS_STUDIED || !batch->record.bearings)
        return machine_build_with(machine, v, batch->speed, &choice, rotor);
    if (value < 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the stiffness of bearings is %.10g N/m, expected 0 or a number above",
                          value);
    return machine_build_on_springs(machine, v, batch->speed, WHIRL_BEARINGS_SPRINGS, value, rotor);
}

/// Runs the static analysis, if requested.
static whirl_status make_statics(const case_content *content, const whirl_batch *batch, valuation *v, member *m) {
    const size_t stations = content->machine.stations.count;
    if (batch->variant != WHIRL_WITH_STATICS) return whirl_ok();
    m->statics = calloc(stations + 1, sizeof *m->statics);
    m->influence = calloc(stations * stations + 1, sizeof *m->influence);
    if (!m->statics || !m->influence) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    return machine_statics(&content->machine, v, batch->record.coupling, m->statics, m->influence);
}

/// Returns the places of a batch in the case, or NULL.
static const plan_origin *family_origin(const case_content *content, const whirl_batch *batch) {
    const size_t index = plan_batch(&content->plan, batch->name);
    return index < content->plan.batch_count ? &content->plan.origins[index] : NULL;
}

/// Returns the part of a fit's data whose run a batch requests, or NULL.
static const fit_set *family_fit_set(const plan_origin *origin, const whirl_batch *batch) {
    return origin && origin->fit && batch->fit_run > 0 ? &origin->fit->sets[batch->fit_run - 1] : NULL;
}

/// Returns the events and laws of a batch's runs, or NULL.
static const course_parts *family_course(const case_content *content, const whirl_batch *batch) {
    const plan_origin *origin = family_origin(content, batch);
    const fit_set *set = family_fit_set(origin, batch);
    return set ? set->course : origin ? origin->course : NULL;
}

/// Returns the keys of a batch's runs, or NULL.
static const setting_list *family_run_keys(const plan_origin *origin, const whirl_batch *batch) {
    const fit_set *set = family_fit_set(origin, batch);
    return set ? set->runup : origin ? origin->runup : NULL;
}

/// Evaluates the parameters of a requested machine, as changed by the events of its run that have happened.
static whirl_status family_open(const case_content *content, const whirl_batch *batch, double value, valuation *v) {
    whirl_given given[PLAN_MAX_GIVEN + WHIRL_MAX_EVENTS * WHIRL_MAX_GIVEN];
    size_t count = plan_given(batch, value, batch->second_value, batch->third_value, given);
    whirl_status status = valuation_open(v, &content->parameters, given, count);
    if (batch->happened_count == 0 || status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < batch->happened_count && status.code == WHIRL_OK; i++)
        status = course_given(family_course(content, batch), batch->happened[i], v, given, &count);
    valuation_close(v);
    return status.code == WHIRL_OK ? valuation_open(v, &content->parameters, given, count) : status;
}

/// Checks that the machine may change as an event says, and finds the speed of its drive without load after that.
static whirl_status check_change(const case_content *content, const whirl_batch *batch, double value, size_t event,
                                 const whirl_rotor *rotor, double *highest) {
    valuation v;
    whirl_rotor *changed = NULL;
    *highest = 0.0;
    whirl_batch after = *batch;
    after.outline = true;
    after.happened_count = 1;
    after.happened[0] = (unsigned char)event;
    whirl_status status = family_open(content, &after, value, &v);
    if (status.code == WHIRL_OK) status = family_build(&content->machine, &after, value, &v, &changed);
    if (status.code == WHIRL_BAD_INPUT)
        status = whirl_fail(WHIRL_BAD_INPUT, "after its change: %.300s", status.message);
    if (status.code == WHIRL_OK)
        status = whirl_running_check_change(whirl_rotor_system(rotor), whirl_rotor_system(changed));
    if (status.code == WHIRL_OK) whirl_rotor_drive(changed, highest);
    whirl_rotor_free(changed);
    valuation_close(&v);
    return status;
}

/// Returns the length of a run, s; 0 if it is that of its table of speeds.
static double run_length(const whirl_runup_options *options) {
    return options->duration > 0.0 || options->rate > 0.0 ? whirl_runup_duration(options) : 0.0;
}

/// Returns true if an offset is in a list, which SIZE_MAX ends.
static bool is_offset(size_t offset, const size_t *list) {
    while (*list != SIZE_MAX && *list != offset) list++;
    return *list == offset;
}

/// Evaluates the numbers of a run at the parameters of its machine. The tolerances and the highest order of spectra are
/// those of the batch, and so is whether something happens at all.
static whirl_status run_numbers(const setting_list *keys, const whirl_runup_options *batch, valuation *v,
                                whirl_runup_options *options) {
#define OF(member) offsetof(whirl_runup_options, member)
    static const size_t of_batch[] = {OF(highest_order), OF(rtol), OF(atol), SIZE_MAX};
    static const size_t may_vanish[] = {OF(from), OF(angle), OF(settle), OF(loss_moment), OF(loss_angle), SIZE_MAX};
#undef OF
    whirl_runup_options own = *batch;
    *options = *batch;
    settings_take(v, keys, whirl_runup_members(), &own);
    for (const whirl_member *m = whirl_runup_members(); m->part; m++) {
        if (m->type != WHIRL_MEMBER_NUMBER || is_offset(m->offset, of_batch) || !settings_find(keys, m->key.name))
            continue;
        double *to = (double *)((char *)options + m->offset);
        const double number = *(const double *)((const char *)&own + m->offset);
        if ((number == 0.0) != (*to == 0.0) && !is_offset(m->offset, may_vanish))
            return whirl_fail(WHIRL_BAD_INPUT, "%s is %.10g here and %.10g at the parameters of the case, expected %s",
                              m->key.name, number, *to, *to == 0.0 ? "0 for all runs" : "another number than 0");
        *to = number;
    }
    return whirl_ok();
}

/// Makes the course of a run, and checks it and the options against the rotor.
static whirl_status make_run(const case_content *content, const whirl_batch *batch, double value, valuation *v,
                             member *m) {
    // Check the options against the drive.
    const course_parts *parts = family_course(content, batch);
    const plan_origin *origin = family_origin(content, batch);
    const setting_list *keys = family_run_keys(origin, batch);
    const whirl_runup_options *options = &batch->record.runup;
    whirl_status status = whirl_ok();
    if (!batch->dataset && keys) {
        status = run_numbers(keys, options, v, &m->run);
        options = &m->run;
        m->recorded = true;
    }
    const fit_set *set = family_fit_set(origin, batch);
    if (set) m->delay = settings_number(v, &set->keys, "delay");
    const bool driven = whirl_runup_driven(options);
    double highest = 0.0;
    const bool has_drive = whirl_rotor_drive(m->rotor, &highest);
    if (status.code == WHIRL_OK) status = whirl_runup_check(options, has_drive, highest);
    if (status.code == WHIRL_OK) status = whirl_running_check(whirl_rotor_system(m->rotor), driven);
    // Machines within a run, after events or at other speeds, have no course of their own.
    if (status.code != WHIRL_OK || !parts || batch->happened_count > 0 || batch->speed != 0.0) return status;
    status = course_make(parts, &content->machine, v, whirl_rotor_length_scale(m->rotor), &m->course);
    if (status.code == WHIRL_OK)
        status = course_make_shafts(parts, v, whirl_rotor_system(m->rotor), run_length(options), m->course);
    if (status.code == WHIRL_OK && batch->dataset) {
        m->recorded = true;
        status = dataset_run(keys, batch, v, m->course, &m->run);
    } else if (status.code == WHIRL_OK)
        status = course_covers(m->course, options->from, whirl_runup_duration(options));
    // Check each event; the machine may change with it.
    for (size_t i = 0; i < parts->event_count && status.code == WHIRL_OK; i++) {
        const whirl_run_event *event = &course_shown(m->course)->events[i];
        double after = 0.0;
        if (event->trip && !driven)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "event %zu is a trip of the drive and the run has a given speed, "
                              "expected one of them",
                              i + 1);
        if (event->changes) status = check_change(content, batch, value, i, m->rotor, &after);
        m->changed_speed = fmax(m->changed_speed, after);
    }
    return status;
}

static whirl_status make_member(const case_content *content, const whirl_batch *batch, double value, member *m) {
    valuation v;
    whirl_status status = family_open(content, batch, value, &v);
    if (status.code == WHIRL_OK) status = family_build(&content->machine, batch, value, &v, &m->rotor);
    if (status.code == WHIRL_OK) status = plan_check_speed(batch, whirl_rotor_speed(m->rotor));
    if (status.code == WHIRL_OK && whirl_analysis_has(batch->analyses, "runup"))
        status = make_run(content, batch, value, &v, m);
    if (status.code == WHIRL_OK && !batch->outline) status = whirl_rotor_hold(m->rotor, batch->stop);
    if (status.code == WHIRL_OK) status = make_start(content, batch, &v, m);
    if (status.code == WHIRL_OK) status = make_statics(content, batch, &v, m);
    valuation_close(&v);
    return status;
}

whirl_status case_machine(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    const whirl_case *object = family;
    member *m = calloc(1, sizeof *m);
    if (!m) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    const int before = exhausted_watch();
    whirl_status status = make_member(&object->content, batch, value, m);
    if (exhausted(before)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    // A failure names the parameter values.
    if (status.code != WHIRL_OK) {
        family_release(m);
        char at[PLAN_GIVEN_TEXT];
        whirl_given given[PLAN_MAX_GIVEN];
        const size_t count = plan_given(batch, value, batch->second_value, batch->third_value, given);
        if (status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED || count == 0) return status;
        given_text(&object->content.parameters, given, count, at, sizeof at);
        return whirl_fail(status.code, "at %s: %.300s", at, status.message);
    }
    *machine = (whirl_machine){.system = whirl_rotor_system(m->rotor),
                               .start = m->start,
                               .owner = m,
                               .release = family_release,
                               .clock = whirl_rotor_clock(m->rotor),
                               .speed = whirl_rotor_speed(m->rotor),
                               .length = whirl_rotor_length_scale(m->rotor),
                               .cross_coupling = whirl_rotor_cross_coupling(m->rotor),
                               .statics = m->statics,
                               .influence = m->influence};
    whirl_rotor_drive(m->rotor, &machine->drive_speed);
    machine->drive_speed = fmax(machine->drive_speed, m->changed_speed);
    machine->course = course_shown(m->course);
    machine->run = m->recorded ? &m->run : NULL;
    machine->delay = m->delay;
    return whirl_ok();
}

whirl_status whirl_case_line(const whirl_case *object, const whirl_batch *batch, double value, whirl_shaft_line *out) {
    valuation v;
    whirl_given given[PLAN_MAX_GIVEN];
    const machine_choice choice = choose(batch);
    const char *couplings = batch->variant == WHIRL_WITH_STATICS ? batch->record.coupling : NULL;
    const size_t count = plan_given(batch, value, batch->second_value, batch->third_value, given);
    *out = (whirl_shaft_line){0};
    whirl_status status = valuation_open(&v, &object->content.parameters, given, count);
    if (status.code == WHIRL_OK)
        status = machine_line(&object->content.machine, &v, batch->speed, &choice, couplings, out);
    valuation_close(&v);
    return status;
}

void whirl_case_refine(whirl_case *object, whirl_budget budget) {
    object->refine = budget;
}

whirl_status whirl_case_study(const whirl_case *object, whirl_study *study) {
    const study_plan *plan = &object->content.plan;
    *study = (whirl_study){
        .batch_count = plan->batch_count, .machine = case_machine, .family = object, .refine = object->refine};
    memcpy(study->batches, plan->batches, sizeof study->batches);
    for (size_t i = 0; i < study->batch_count; i++) study->batches[i].mapped = object->content.arena.mapped;
    mapped_evict(object->content.arena.mapped);
    return whirl_ok();
}
