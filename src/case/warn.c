// Warnings about a case: valid input that is probably not meant, such as values outside an element's validity, and
// empty ranges.
#include "content.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan.h"
#include "plan_batches.h"
#include "plan_course.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/result.h"

/// State of collecting warnings: the parameter values of the machine in question, and the result that receives the
/// warnings.
typedef struct warner {
    const case_content *content;
    whirl_result *result;
    size_t count; ///< number of warnings so far
    const whirl_given *given;
    size_t given_count;
    whirl_status status;
} warner;

/// Returns true if there is already a warning for a `path`.
static bool is_warned_of(const warner *w, const char *path) {
    for (size_t i = 0; i < w->count; i++)
        if (strncmp(whirl_result_warning(w->result, i), path, strlen(path)) == 0) return true;
    return false;
}

static void warn(warner *w, const char *path, const char *sentence) {
    char name[WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE];
    snprintf(text, sizeof text, "%s: ", path);
    if (w->status.code != WHIRL_OK || is_warned_of(w, text)) return;
    snprintf(name, sizeof name, "warning %zu", ++w->count);
    snprintf(text, sizeof text, "%s: %s", path, sentence);
    w->status = whirl_result_add_fact(w->result, name, text);
}

// ---------------------------------------------------------------- machines

/// Returns true if an element depends on a varied parameter.
static bool varies(const warner *w, const setting_list *element) {
    for (size_t k = 0; k < w->given_count; k++)
        if (case_list_depends(w->content, element, w->given[k].name)) return true;
    return false;
}

static void take_doubt(void *context, size_t index, const char *key, const char *sentence) {
    warner *w = context;
    const setting_list *element = &w->content->machine.elements[index];
    char path[160], text[WHIRL_MESSAGE_SIZE], at[PLAN_GIVEN_TEXT] = "";
    node_path(element->place, path, sizeof path);
    snprintf(path + strlen(path), sizeof path - strlen(path), ".%s", key);
    if (varies(w, element)) given_text(&w->content->parameters, w->given, w->given_count, at, sizeof at);
    snprintf(text, sizeof text, "%s%s%s", sentence, *at ? ", at " : "", at);
    warn(w, path, text);
}

/// Warns of stations nearly without mass. Slow modes come from small differences between forces of films and springs:
/// they are lost in rounding next to the accelerations of such a station.
static void warn_of_masses(warner *w, valuation *v) {
    static const double least = 5e-9; // of the largest mass; measured on a ring in its films
    const named_list *stations = &w->content->machine.stations;
    double largest = 0.0;
    for (size_t i = 0; i < stations->count; i++)
        largest = fmax(largest, settings_number(v, &stations->items[i], "mass"));
    for (size_t i = 0; i < stations->count; i++) {
        const setting_list *station = &stations->items[i];
        const double mass = settings_number(v, station, "mass");
        char path[160], text[WHIRL_MESSAGE_SIZE];
        if (!settings_find(station, "mass") || !(mass > 0.0) || mass >= least * largest) continue;
        node_path(station->place, path, sizeof path);
        snprintf(path + strlen(path), sizeof path - strlen(path), ".mass");
        snprintf(text, sizeof text,
                 "is %.3g of the largest mass of a station: rounding of its accelerations hides slow modes, expected "
                 "%.0g of it or more, which does not change slow modes either",
                 mass / largest, least);
        warn(w, path, text);
    }
}

static void warn_of_machine(warner *w, const whirl_given *given, size_t count) {
    valuation v;
    w->given = given;
    w->given_count = count;
    whirl_status status = valuation_open(&v, &w->content->parameters, given, count);
    if (status.code == WHIRL_OK) status = machine_doubts(&w->content->machine, &v, take_doubt, w);
    if (status.code == WHIRL_OK) warn_of_masses(w, &v);
    valuation_close(&v);
    w->given = NULL;
    w->given_count = 0;
    // A machine that cannot be built at these values is reported elsewhere.
    if (status.code == WHIRL_NO_MEMORY) w->status = status;
}

/// Warns of statics of a machine without weight.
static void warn_of_weight(warner *w, const whirl_batch *batch, const whirl_given *given, size_t count) {
    char path[2 * WHIRL_NAME_SIZE];
    whirl_weight weight = {.given = true};
    valuation v;
    if (w->status.code != WHIRL_OK || !whirl_analysis_has(batch->analyses, "statics")) return;
    whirl_status status = valuation_open(&v, &w->content->parameters, given, count);
    if (status.code == WHIRL_OK) status = machine_weight(&w->content->machine, &v, &weight);
    valuation_close(&v);
    if (status.code == WHIRL_NO_MEMORY) w->status = status;
    snprintf(path, sizeof path, "study.%s", batch->name);
    if (!weight.given)
        warn(w, path,
             "the machine has no gravity: no weight is taken, bearings carry nothing and shafts do not sag; expected "
             "the element gravity");
}

/// Warns of torques without effect in a run whose speed a rate changes.
static void warn_of_rate(warner *w, const whirl_batch *batch) {
    static const char *const kinds[] = {"drive", "induction_motor", "synchronous_start", "short_circuit",
                                        "timed_torque"};
    char path[2 * WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE] = "";
    if (!whirl_analysis_has(batch->analyses, "runup") || !(batch->record.runup.rate > 0.0)) return;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (size_t i = 0; i < w->content->machine.element_count; i++)
            if (strcmp(w->content->machine.elements[i].name, kinds[k]) == 0 &&
                !settings_find(&w->content->machine.elements[i], "shaft")) {
                snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", *text ? ", " : "", kinds[k]);
                break;
            }
    if (!*text) return;
    snprintf(text + strlen(text), sizeof text - strlen(text), " %s",
             "has no effect where a rate changes the speed; without a rate torques do");
    snprintf(path, sizeof path, "study.%s.rate", batch->name);
    warn(w, path, text);
}

/// Warns of drives of shafts with a speed of their own that turn nothing, as a law gives the speed or none is asked
/// for.
static void warn_of_shaft_drives(warner *w, const whirl_batch *batch) {
    const machine_parts *machine = &w->content->machine;
    const course_parts *course = w->content->plan.origins[batch - w->content->plan.batches].course;
    for (size_t i = 0; i < machine->element_count && course; i++) {
        const setting *shaft = settings_find(&machine->elements[i], "shaft");
        if (strcmp(machine->elements[i].name, "drive") != 0 || !shaft || !shaft->word) continue;
        for (size_t k = 0; k < course->shaft_count; k++) {
            const course_shaft *own = &course->shafts[k];
            const bool lawful = own->speeds.count > 0 || own->formulas[WHIRL_SPOOL_SPEED] ||
                                (own->place && settings_find(&own->keys, "rate"));
            char path[2 * WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE];
            if (strcmp(own->name, shaft->word) != 0 || (own->place && !lawful)) continue;
            snprintf(path, sizeof path, "study.%s.shafts", batch->name);
            snprintf(text, sizeof text,
                     lawful ? "the drive of shaft '%.40s' has no effect where a law gives its speed"
                            : "the drive of shaft '%.40s' has no effect: the run does not list the shaft, which keeps "
                              "its speed",
                     own->name);
            warn(w, path, text);
        }
    }
}

/// Returns the name of an element whose drag is unknown, "film by its load"; NULL if it is known or there is none.
static const char *unknown_drag(const setting_list *element) {
    static const char *const kinds[][3] = {{"film", "load", "film by its load"},
                                           {"seal", "ratio", "seal of law muszynska"},
                                           {"bearing", NULL, "bearing"},
                                           {"ball_bearing", NULL, "ball_bearing"},
                                           {"roller_bearing", NULL, "roller_bearing"}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        if (strcmp(element->name, kinds[k][0]) == 0 && (!kinds[k][1] || settings_find(element, kinds[k][1])))
            return kinds[k][2];
    return NULL;
}

/// Warns of films, seals and bearings that brake no shaft, as their drag does not follow from their keys.
static void warn_of_drag(warner *w, const whirl_batch *batch) {
    const machine_parts *machine = &w->content->machine;
    char path[2 * WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE] = "";
    const whirl_runup_options *o = &batch->record.runup;
    if (!whirl_analysis_has(batch->analyses, "runup") || !whirl_runup_driven(o) || !o->drag) return;
    for (size_t i = 0; i < machine->element_count; i++) {
        const char *own = unknown_drag(&machine->elements[i]);
        if (own && !strstr(text, own))
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", *text ? ", " : "", own);
    }
    if (!*text) return;
    snprintf(text + strlen(text), sizeof text - strlen(text), ": %s",
             "their drag does not follow from their keys and does not brake the shaft, expected it in the load");
    snprintf(path, sizeof path, "study.%s.drag", batch->name);
    warn(w, path, text);
}

/// Warns of unbalances on stations that twist in a run by torques.
static void warn_of_twisted_unbalances(warner *w, const whirl_batch *batch, const whirl_given *given, size_t count) {
    char path[2 * WHIRL_NAME_SIZE];
    valuation v;
    whirl_model model = {0};
    bool any = false;
    if (w->status.code != WHIRL_OK || !whirl_analysis_has(batch->analyses, "runup") || batch->record.runup.rate > 0.0)
        return;
    whirl_status status = valuation_open(&v, &w->content->parameters, given, count);
    if (status.code == WHIRL_OK) status = machine_model(&w->content->machine, &v, &model);
    valuation_close(&v);
    if (status.code == WHIRL_NO_MEMORY) w->status = status;
    for (size_t s = 0; s < model.station_count && status.code == WHIRL_OK; s++)
        any = any || (model.stations[s].unbalanced && isfinite(model.stations[s].twist));
    whirl_model_free(&model);
    snprintf(path, sizeof path, "study.%s", batch->name);
    if (any)
        warn(
            w, path,
            "unbalances of stations that twist turn with the mean angle of the train: their phase errs by the twist of "
            "their station from that mean");
}

/// Warns of an absolute tolerance that is given in length scales and coarse for the smallest clearance or gap.
static void warn_of_tolerance(warner *w, const whirl_batch *batch, const whirl_given *given, size_t count) {
    const double coarse = 1e-4, usual = whirl_integrate_default().atol;
    char text[WHIRL_MESSAGE_SIZE];
    valuation v;
    whirl_rotor *rotor = NULL;
    const bool runs = !plan_moves(batch);
    const double tolerance = runs ? batch->record.runup.atol : batch->integrate.atol;
    if (w->status.code != WHIRL_OK || !(tolerance > usual)) return;
    whirl_status status = valuation_open(&v, &w->content->parameters, given, count);
    if (status.code == WHIRL_OK) status = machine_build(&w->content->machine, &v, true, &rotor);
    valuation_close(&v);
    if (status.code == WHIRL_NO_MEMORY) w->status = status;
    const double share = rotor ? tolerance / plan_smallest_gap(whirl_rotor_system(rotor)) : 0.0;
    whirl_rotor_free(rotor);
    if (!(share > coarse)) return;
    snprintf(text, sizeof text,
             "%.3g length scales are %.3g of the smallest clearance or gap: motions in it are coarse, expected %.0g of "
             "it or less",
             tolerance, share, coarse);
    warn(w, runs ? "study.runup.atol" : "study.integrate.atol", text);
}

/// Warns about a point of a batch, given by its index among the values of its axes.
static void warn_of_point(warner *w, const whirl_batch *batch, size_t point) {
    whirl_given given[PLAN_MAX_GIVEN];
    char path[2 * WHIRL_NAME_SIZE], doubt[WHIRL_MESSAGE_SIZE];
    const size_t count = plan_given_at(batch, point, given);
    warn_of_machine(w, given, count);
    warn_of_weight(w, batch, given, count);
    warn_of_rate(w, batch);
    if (whirl_analysis_has(batch->analyses, "runup")) warn_of_shaft_drives(w, batch);
    warn_of_drag(w, batch);
    warn_of_twisted_unbalances(w, batch, given, count);
    warn_of_tolerance(w, batch, given, count);
    if (w->status.code != WHIRL_OK || !plan_moves(batch)) return;
    w->status = case_tell_fits(w->content, given, count, w->result, doubt);
    snprintf(path, sizeof path, "study.%s", batch->name);
    if (*doubt) warn(w, path, doubt);
}

// ---------------------------------------------------------------- keys

/// Warns of keys without effect, because the key they belong to is missing.
static void warn_of_keys(warner *w, const setting_list *list) {
    for (size_t i = 0; i < list->count; i++) {
        const whirl_key *key = list->items[i].key;
        char path[160], text[WHIRL_MESSAGE_SIZE];
        if (!key->of || settings_find(list, key->of)) continue;
        node_path(list->items[i].place, path, sizeof path);
        snprintf(text, sizeof text, "has no effect without %s", key->of);
        warn(w, path, text);
    }
}

static void warn_of_parts(warner *w) {
    const machine_parts *machine = &w->content->machine;
    const named_list *const lists[] = {&machine->stations, &machine->shafts, &machine->materials};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
        for (size_t i = 0; i < lists[k]->count; i++) warn_of_keys(w, &lists[k]->items[i]);
    for (size_t i = 0; i < machine->element_count; i++) warn_of_keys(w, &machine->elements[i]);
}

/// Returns true if a number depends on a parameter by which the points of a batch are differentiated.
static bool is_differentiated(const warner *w, const char *expression, const whirl_batch *batch) {
    const whirl_derivatives *by = batch->derivatives;
    for (size_t p = 0; by && p < by->parameter_count; p++)
        if (case_depends(w->content, expression, by->parameters[p].name)) return true;
    return false;
}

/// Warns of an option that depends on what differs between the points of a batch, which all have the same option.
static void warn_of_option(warner *w, const whirl_batch *batch, const setting *option) {
    char path[160], text[WHIRL_MESSAGE_SIZE];
    const char *expression = option->key ? option->value.expression : NULL;
    if (!expression) return;
    const bool varies = case_depends_on_batch(w->content, expression, batch);
    if (!varies && !is_differentiated(w, expression, batch)) return;
    node_path(option->place, path, sizeof path);
    snprintf(text, sizeof text, "is = %.80s, %s", expression,
             varies ? "which the study varies: all points have the value of the case"
                    : "by which the study differentiates: the derivatives leave out what this option changes");
    warn(w, path, text);
}

static void warn_of_options(warner *w, const whirl_batch *batch, const plan_origin *origin) {
    for (size_t l = 0; l < PLAN_OPTIONS; l++)
        for (size_t i = 0; origin->options[l] && i < origin->options[l]->count; i++) {
            const setting *number;
            const size_t count = setting_numbers(&origin->options[l]->items[i], &number);
            for (size_t k = 0; k < count; k++) warn_of_option(w, batch, &number[k]);
        }
}

// ---------------------------------------------------------------- ranges

/// Warns of `count` equal values, one every `stride`.
static void warn_of_range(warner *w, const char *batch, const char *name, const double *values, size_t stride,
                          size_t count) {
    char path[2 * WHIRL_NAME_SIZE], all[3 * WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE];
    for (size_t i = 1; i < count; i++)
        if (values[i * stride] != values[0]) return;
    if (count < 2) return;
    value_text(&w->content->parameters, name, values[0], all, sizeof all);
    snprintf(path, sizeof path, "study.%s.%s", batch, name);
    snprintf(text, sizeof text, "all %zu values are %s: the range is empty", count, all);
    warn(w, path, text);
}

/// Warns of empty ranges. The values of an axis are those of every `strides[axis]`-th point, up to the first of the
/// next axis.
static void warn_of_ranges(warner *w, const whirl_batch *batch) {
    const char *name;
    const double *values;
    size_t count;
    for (size_t axis = 0; (values = whirl_batch_values(batch, axis, &name, &count)) != NULL; axis++) {
        const size_t row = batch->row > 0 ? batch->row : count, plane = batch->plane > 0 ? batch->plane : count;
        const size_t strides[] = {1, row, plane, count};
        warn_of_range(w, batch->name, name, values, strides[axis], strides[axis + 1] / strides[axis]);
    }
}

// ---------------------------------------------------------------- the whole

whirl_status case_warn(const case_content *content, whirl_result *result) {
    warner w = {.content = content, .result = result, .status = whirl_ok()};
    warn_of_parts(&w);
    for (size_t i = 0; i < content->plan.batch_count; i++) {
        const whirl_batch *batch = &content->plan.batches[i];
        const char *name;
        size_t count;
        warn_of_options(&w, batch, &content->plan.origins[i]);
        if (!whirl_batch_values(batch, 0, &name, &count)) {
            warn_of_point(&w, batch, 0);
            continue;
        }
        const size_t row = batch->row > 0 ? batch->row : count, corners[] = {0, row - 1, count - row, count - 1};
        for (size_t k = 0; k < 4; k++) warn_of_point(&w, batch, corners[k]);
        warn_of_ranges(&w, batch);
    }
    return w.status;
}
