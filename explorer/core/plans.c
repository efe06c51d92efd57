// Plans: options for the computation of points, and the layout of their blocks.
#include "core.h"
#include "looks.h"
#include "pieces.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static text answer;

static const whirl_batch *find_batch(const whirl_study *study, const char *name) {
    for (size_t i = 0; i < study->batch_count; i++)
        if (!*name || strcmp(study->batches[i].name, name) == 0) return &study->batches[i];
    return NULL;
}

/// Chooses the method for "auto" from the values of the batch, as in the command; dop853 if no machine can be built.
static void choose_method(const plan *p, const whirl_batch *from, whirl_integrate_options *how) {
    whirl_study one = {.batch_count = 1, .batches = {*from}, .machine = p->study.machine, .family = p->study.family};
    whirl_integrate_options *taken = &one.batches[0].integrate;
    snprintf(taken->method, sizeof taken->method, "auto");
    const bool well = whirl_study_choose_methods(&one).code == WHIRL_OK;
    snprintf(how->method, sizeof how->method, "%s", well ? taken->method : "dop853");
}

EXPORTED const char *explorer_plan_choose(plan *p, const char *known) {
    whirl_integrate_options *how = &p->batch.integrate;
    if (strcmp(how->method, "auto") != 0) return how->method;
    how->chosen = true;
    if (*known)
        snprintf(how->method, sizeof how->method, "%s", known);
    else
        choose_method(p, find_batch(&p->study, p->batch.name), how);
    return how->method;
}

EXPORTED plan *explorer_plan_new(const whirl_case *object, const char *batch, const char *parameter) {
    // Find the batch.
    plan *p = calloc(1, sizeof *p);
    whirl_status status = p ? whirl_case_study(object, &p->study) : whirl_fail(WHIRL_NO_MEMORY, "no memory");
    const whirl_batch *found = p && status.code == WHIRL_OK ? find_batch(&p->study, batch) : NULL;
    if (status.code == WHIRL_OK && !found)
        status = whirl_fail(WHIRL_BAD_INPUT, "the study has no batch that is called %.40s", batch);
    if (!explorer_good(&status)) {
        free(p);
        return NULL;
    }
    // Copy it without values: a plan varies one parameter, the others of a map have the values of the case.
    p->object = object;
    p->batch = *found;
    p->batch.values = p->batch.second_values = p->batch.third_values = NULL;
    p->batch.count = 1;
    p->batch.row = p->batch.plane = p->batch.refine = 0;
    *p->batch.second = *p->batch.third = '\0';
    p->batch.carry = WHIRL_CARRY_NONE;
    if (parameter) snprintf(p->batch.parameter, sizeof p->batch.parameter, "%s", parameter);
    status = whirl_study_place(&p->study, &p->batch, &p->placed);
    if (explorer_good(&status)) return p;
    explorer_plan_free(p);
    return NULL;
}

EXPORTED void explorer_plan_free(plan *p) {
    if (p) free(p->placed);
    free(p);
}

// ---------------------------------------------------------------- options

EXPORTED int explorer_plan_number(plan *p, const char *name, double value) {
    const whirl_member *member = whirl_member_find(whirl_integrate_members(), name);
    void *options = &p->batch.integrate;
    if (!member) {
        member = whirl_member_find(whirl_record_members(), name);
        options = &p->batch.record;
    }
    if (!member) {
        member = whirl_member_find(whirl_runup_members(), name);
        options = &p->batch.record.runup;
    }
    whirl_status status = whirl_fail(WHIRL_BAD_INPUT, "no option is called %.40s", name);
    if (member) status = whirl_key_check_number(&member->key, value);
    if (member && status.code != WHIRL_OK) status = whirl_fail(status.code, "%s %s", name, status.message);
    if (status.code == WHIRL_OK) whirl_member_set(member, options, value);
    return explorer_good(&status);
}

EXPORTED int explorer_plan_method(plan *p, const char *method) {
    snprintf(p->batch.integrate.method, sizeof p->batch.integrate.method, "%s", method);
    p->batch.integrate.chosen = false;
    return 1;
}

/// Analyses for the points of a diagram, and for the panels of one point.
static const char *const shown_of_many[] = {"poincare", "orbit", "rub", "lyapunov", "regime", NULL};
static const char *const shown_of_one[] = {"poincare", "orbit",    "rub",      "lyapunov",
                                           "regime",   "spectrum", "waveform", NULL};

static const char *const shown_of_orbit[] = {"poincare", "orbit", "rub", "spectrum", "waveform", NULL};

/// Least number of recorded revolutions of an orbit, for its spectrum.
enum { ORBIT_RECORD = 32 };

static void add_analyses(plan *p, const char *const *names) {
    for (; *names; names++) whirl_analysis_add(&p->batch.analyses, *names);
}

EXPORTED void explorer_plan_diagram(plan *p) {
    p->batch.analyses = 0;
    add_analyses(p, shown_of_many);
    p->batch.record.spectra = false;
    p->batch.record.waveform = false;
    p->batch.record.growth = true;
    p->batch.record.waveform_revolutions = 0;
}

EXPORTED void explorer_plan_spectra(plan *p) {
    whirl_analysis_add(&p->batch.analyses, "spectrum");
    p->batch.record.waveform = true;
}

EXPORTED void explorer_plan_everything(plan *p, int waveform) {
    add_analyses(p, shown_of_one);
    p->batch.record.spectra = true;
    p->batch.record.waveform = true;
    p->batch.record.growth = true;
    p->batch.record.waveform_revolutions = waveform < p->batch.record.record ? waveform : p->batch.record.record;
}

EXPORTED void explorer_plan_orbit(plan *p, int revolutions) {
    whirl_record_options *record = &p->batch.record;
    const int round = revolutions > 0 ? revolutions : 1;
    explorer_plan_choose(p, "");
    p->batch.analyses = 0;
    add_analyses(p, shown_of_orbit);
    p->batch.integrate = whirl_batch_orbits(&p->batch).integrate;
    record->transient = record->watch = 0;
    record->record = (ORBIT_RECORD + round - 1) / round * round;
    record->growth = WHIRL_GROWTH_NONE;
    record->spectra = record->waveform = true;
    record->waveform_revolutions = revolutions > 0 ? revolutions : ORBIT_RECORD;
}

// ---------------------------------------------------------------- layout

static const char *extent_name(whirl_extent extent) {
    return extent == WHIRL_PER_STATION ? "station" : extent == WHIRL_PER_CONTACT ? "contact" : "point";
}

static void add_field(const whirl_field *field) {
    json_next(&answer);
    text_add(&answer, "{");
    json_name(&answer, "name");
    json_text(&answer, field->name);
    json_name(&answer, "unit");
    json_text(&answer, field->unit);
    json_name(&answer, "meaning");
    json_text(&answer, field->meaning);
    json_name(&answer, "extent");
    json_text(&answer, extent_name(field->extent));
    text_add(&answer, ",\"rows\":%zu,\"columns\":%zu,\"repeat\":%zu,\"offset\":%zu}", field->rows, field->columns,
             field->repeat, field->offset);
}

/// Makes the machine of the plan at a value, with its start.
static whirl_status make_machine(const plan *p, double value, whirl_machine *machine) {
    return p->study.machine(p->study.family, &p->batch, value, machine);
}

EXPORTED const char *explorer_plan_layout(plan *p, double value) {
    whirl_machine machine;
    explorer_plan_choose(p, "");
    whirl_status status = make_machine(p, value, &machine);
    if (status.code == WHIRL_OK) {
        p->dimension = machine.system->dimension;
        status = whirl_layout_new(machine.system, &p->batch.integrate, &p->batch.record, p->batch.analyses, &p->layout);
        machine.release(machine.owner);
    }
    if (!explorer_good(&status)) return NULL;
    text_clear(&answer);
    text_add(&answer, "{\"layout\":{\"size\":%zu,\"fields\":[", p->layout.size);
    for (size_t i = 0; i < p->layout.field_count; i++) add_field(&p->layout.fields[i]);
    text_add(&answer, "]}");
    add_options(&answer, &p->batch);
    text_add(&answer, ",\"revolutions\":%d", p->batch.record.transient + p->batch.record.record);
    text_add(&answer, ",\"waveformSamples\":%d}",
             whirl_record_samples(&p->batch.record, p->batch.integrate.steps_per_revolution));
    return text_bytes(&answer);
}

EXPORTED size_t explorer_block_size(const plan *p) {
    return p->layout.size;
}

EXPORTED size_t explorer_dimension(const plan *p) {
    return p->dimension;
}

EXPORTED const char *explorer_machine(const plan *p, double value) {
    whirl_rotor *rotor;
    const char *parameter = p->batch.parameter[0] ? p->batch.parameter : NULL;
    const whirl_status status = whirl_case_rotor(p->object, parameter, value, &rotor);
    if (!explorer_good(&status)) return NULL;
    const whirl_system *system = whirl_rotor_system(rotor);
    text_clear(&answer);
    text_add(&answer, "{");
    add_scales(&answer, whirl_rotor_length_scale(rotor), whirl_rotor_clock(rotor), whirl_rotor_keyphasor(rotor));
    add_stations(&answer, system->probes, system->probe_count);
    text_add(&answer, "}");
    whirl_rotor_free(rotor);
    return text_bytes(&answer);
}

// ---------------------------------------------------------------- verdicts

static void add_reason(const plan *p, const double *block, const whirl_verdict *verdict) {
    char sentence[WHIRL_MESSAGE_SIZE];
    text reason = {0};
    const bool provisional = look_is_provisional(p, block);
    whirl_verdict_reason(verdict, sentence, sizeof sentence);
    if (provisional) look_reason(p, &reason);
    json_text(&answer, provisional ? text_bytes(&reason) : sentence);
    free(reason.bytes);
    text_add(&answer, ",\"provisional\":%s", provisional ? "true" : "false");
}

EXPORTED const char *explorer_verdict(const plan *p, const double *block) {
    // Write the verdict with its reason.
    const whirl_verdict verdict = whirl_block_verdict(&p->layout, block);
    char sentence[WHIRL_MESSAGE_SIZE];
    text_clear(&answer);
    text_add(&answer, "{");
    json_name(&answer, "regime");
    json_text(&answer, whirl_regime_name(verdict.regime));
    json_name(&answer, "name");
    whirl_verdict_name(&verdict, sentence, sizeof sentence);
    json_text(&answer, sentence);
    json_name(&answer, "reason");
    add_reason(p, block, &verdict);
    // Write its confidence, and advice.
    json_name(&answer, "confidence");
    json_text(&answer, whirl_confidence_name(verdict.confidence));
    json_name(&answer, "advice");
    whirl_verdict_advice(&verdict, sentence, sizeof sentence);
    json_text(&answer, sentence);
    // Write the numbers that the page shows.
    text_add(&answer, ",\"period\":%d,\"curves\":%d", verdict.period, verdict.curves);
    json_name(&answer, "divergedAt");
    json_number(&answer, verdict.diverged_at);
    json_name(&answer, "exponent");
    json_number(&answer, verdict.exponent.value);
    json_name(&answer, "exponentError");
    json_number(&answer, verdict.exponent.error);
    text_add(&answer, "}");
    return text_bytes(&answer);
}
