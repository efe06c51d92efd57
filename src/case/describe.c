// Descriptions of a case in its result; whirl_case_run.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "content.h"
#include "plan.h"

static whirl_status describe_parameters(const case_content *content, whirl_result *result) {
    const parameter_table *parameters = &content->parameters;
    valuation v;
    const whirl_status status = valuation_open(&v, parameters, NULL, 0);
    if (status.code == WHIRL_OK) result->parameters = calloc(parameters->count + 1, sizeof *result->parameters);
    if (status.code == WHIRL_OK && result->parameters) {
        result->parameter_count = parameters->count;
        for (size_t i = 0; i < parameters->count; i++) {
            const parameter *from = &parameters->items[i];
            whirl_parameter *to = &result->parameters[i];
            snprintf(to->name, sizeof to->name, "%s", from->name);
            const char *const unit = parameter_expected_unit(from);
            snprintf(to->unit, sizeof to->unit, "%s", unit[0] ? unit : "SI");
            snprintf(to->text, sizeof to->text, "%s", from->text);
            whirl_make_plain(to->text);
            to->value = v.values[i];
        }
    }
    valuation_close(&v);
    if (status.code != WHIRL_OK || result->parameters) return status;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the parameters of a result");
}

/// Adds a fact for every range of a law: "range 1" is "film at journal: eccentricity ratio up to 0.95, to which its
/// coefficients were found".
static whirl_status describe_ranges(const whirl_system *system, whirl_result *result) {
    whirl_status status = whirl_ok();
    whirl_law_range range;
    for (size_t i = 0; status.code == WHIRL_OK && system->range(system->model, i, NULL, &range); i++) {
        char name[WHIRL_NAME_SIZE], text[8 * WHIRL_NAME_SIZE];
        const char *const unit = strcmp(range.unit, "1") == 0 ? "" : range.unit;
        snprintf(name, sizeof name, "range %zu", i + 1);
        snprintf(text, sizeof text, "%s: %s up to %.4g%s%s, %s", range.part, range.quantity, range.most,
                 *unit ? " " : "", unit, range.limit);
        status = whirl_result_add_fact(result, name, text);
    }
    return status;
}

/// Adds "weight": "9.80665 m/s2 across the shafts", or the reason why there is none.
static whirl_status describe_weight(const case_content *content, whirl_result *result) {
    // Evaluate the weight with the case's values.
    char text[4 * WHIRL_NAME_SIZE];
    whirl_weight weight;
    valuation v;
    whirl_status status = valuation_open(&v, &content->parameters, NULL, 0);
    if (status.code == WHIRL_OK) status = machine_weight(&content->machine, &v, &weight);
    valuation_close(&v);
    if (status.code != WHIRL_OK) return status;
    // Describe it.
    if (!weight.given)
        snprintf(text, sizeof text, "none: the machine has no gravity");
    else if (weight.stands && weight.across > 0.0)
        snprintf(text, sizeof text, "%.6g m/s2 along the shafts, which lean, and %.6g m/s2 across", weight.along,
                 weight.across);
    else if (weight.stands)
        snprintf(text, sizeof text,
                 "%.6g m/s2 along the shafts: the machine stands vertically, and weight loads no journal bearing",
                 weight.along);
    else if (weight.across > 0.0)
        snprintf(text, sizeof text, "%.6g m/s2 across the shafts", weight.across);
    else
        snprintf(text, sizeof text, "none: gravity is 0");
    return whirl_result_add_fact(result, "weight", text);
}

static whirl_status describe_rotor(const whirl_case *object, whirl_result *result) {
    // Make the machine, without its film tables.
    whirl_rotor *rotor;
    const whirl_status status = whirl_case_rotor_outline(object, NULL, 0.0, &rotor);
    if (status.code != WHIRL_OK) return status;
    const whirl_system *system = whirl_rotor_system(rotor);
    // Copy scales, stations and contacts.
    result->speed = whirl_rotor_speed(rotor);
    result->length_scale = whirl_rotor_length_scale(rotor);
    result->force_scale = 1.0;
    result->stations = calloc(system->probe_count + 1, sizeof *result->stations);
    result->contacts = calloc(system->contact_count + 1, sizeof *result->contacts);
    const bool done = result->stations && result->contacts;
    if (done) {
        result->station_count = system->probe_count;
        result->contact_count = system->contact_count;
        memcpy(result->stations, system->probes, system->probe_count * sizeof *result->stations);
        for (size_t i = 0; i < result->station_count; i++) result->stations[i].runout_count = 0;
        for (size_t i = 0; i < system->contact_count; i++)
            snprintf(result->contacts[i], sizeof result->contacts[i], "%s", whirl_rotor_contact_names(rotor)[i]);
    }
    whirl_status known = done ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the stations of a result");
    // Say what a revolution is, if sections are not those of the shaft.
    if (known.code == WHIRL_OK && (*whirl_rotor_keyphasor(rotor) || *whirl_result_keyphasor(result))) {
        char rate[WHIRL_NAME_SIZE];
        snprintf(rate, sizeof rate, "%.17g rad/s", whirl_rotor_clock(rotor));
        known = whirl_result_add_fact(result, "keyphasor", whirl_rotor_keyphasor(rotor));
        if (known.code == WHIRL_OK) known = whirl_result_add_fact(result, "keyphasor rate", rate);
    }
    if (known.code == WHIRL_OK) known = describe_ranges(system, result);
    whirl_rotor_free(rotor);
    return known;
}

/// Adds "unit of gap": "mm = 0.001 m", the unit in which the study writes a parameter's values if the parameter has
/// another one.
static whirl_status describe_unit(const char *of, whirl_unit written, const char *unit, whirl_result *result) {
    char name[2 * WHIRL_NAME_SIZE], text[4 * WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "unit of %s", of);
    if (!(written.size > 0.0) || *whirl_result_fact(result, name)) return whirl_ok();
    snprintf(text, sizeof text, "%s = %.17g%s%s", written.name, written.size, *unit ? " " : "", unit);
    return whirl_result_add_fact(result, name, text);
}

/// Returns the SI unit of a parameter; "" for a plain number.
static const char *known_unit(const case_content *content, size_t index) {
    const char *const known = parameter_expected_unit(&content->parameters.items[index]);
    return strcmp(known, "1") == 0 ? "" : known;
}

/// Adds facts about axes: units of values, and "sweep ends at": "0.0018 m, short of 0.002 m".
static whirl_status describe_axes(const case_content *content, const whirl_batch *batch, const plan_origin *origin,
                                  whirl_result *result) {
    const char *const names[] = {batch->parameter, batch->second, batch->third};
    char text[4 * WHIRL_NAME_SIZE], name[2 * WHIRL_NAME_SIZE];
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < 3 && status.code == WHIRL_OK; i++) {
        const size_t index = parameters_find(&content->parameters, names[i]);
        if (index < content->parameters.count)
            status = describe_unit(names[i], origin->units[i], known_unit(content, index), result);
    }
    if (isnan(origin->end) || status.code != WHIRL_OK) return status;
    const char *const unit = known_unit(content, parameters_find(&content->parameters, batch->parameter));
    const char *const gap = *unit ? " " : "";
    snprintf(name, sizeof name, "%s ends at", batch->name);
    snprintf(text, sizeof text, "%.17g%s%s, short of %.17g%s%s", batch->values[batch->count - 1], gap, unit,
             origin->end, gap, unit);
    return whirl_result_add_fact(result, name, text);
}

/// Adds the parameter values of a batch's condition in the units of the case: "unbalance_minimum with": "clearance = 90
/// um".
static whirl_status describe_given(const case_content *content, const whirl_batch *batch, whirl_result *result) {
    char name[2 * WHIRL_NAME_SIZE], text[WHIRL_MESSAGE_SIZE] = "";
    if (batch->given_count == 0) return whirl_ok();
    snprintf(name, sizeof name, "%s with", batch->name);
    for (size_t i = 0; i < batch->given_count; i++) {
        const whirl_given *own = &batch->given[i];
        char value[3 * WHIRL_NAME_SIZE];
        value_text(&content->parameters, own->name, own->value, value, sizeof value);
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s = %s", i ? ", " : "", own->name, value);
    }
    return whirl_result_add_fact(result, name, text);
}

/// Describes a distribution: "c: uniform from 0.19 mm to 0.21 mm".
enum { DISTRIBUTION_TEXT = 6 * WHIRL_NAME_SIZE };
static void distribution_text(const case_content *content, const char *drawn, const whirl_tolerance *own,
                              char text[DISTRIBUTION_TEXT]) {
    const double numbers[] = {own->mean, own->deviation, own->low, own->high};
    char shown[4][WHIRL_NAME_SIZE];
    for (size_t k = 0; k < 4; k++) value_text(&content->parameters, drawn, numbers[k], shown[k], sizeof shown[k]);
    const bool low = isfinite(own->low), high = isfinite(own->high), normal = own->deviation > 0.0;
    snprintf(text, DISTRIBUTION_TEXT, "%s: %s%s%s%s%s%s%s%s", drawn, normal ? "normal, mean " : "uniform",
             normal ? shown[0] : "", normal ? ", standard deviation " : "", normal ? shown[1] : "", low ? " from " : "",
             low ? shown[2] : "", high ? " to " : "", high ? shown[3] : "");
}

/// Adds the parameters with tolerances, "tolerance 1": "c: uniform from 0.19 mm to 0.21 mm", and the numbers that are
/// asked of all samples, "limit 1", as whirl_spread_read reads them.
static whirl_status describe_tolerances(const case_content *content, whirl_result *result) {
    const study_plan *plan = &content->plan;
    // Describe each parameter and its distribution.
    char name[WHIRL_NAME_SIZE], text[WHIRL_SPREAD_TEXT + DISTRIBUTION_TEXT];
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < plan->tolerated_count && status.code == WHIRL_OK; i++) {
        snprintf(name, sizeof name, "tolerance %zu", i + 1);
        distribution_text(content, plan->tolerated[i].name, &plan->tolerated[i], text);
        status = whirl_result_add_fact(result, name, text);
    }
    // Add each number that is asked of the samples.
    for (size_t i = 0; i < plan->spread_count && status.code == WHIRL_OK; i++) {
        snprintf(name, sizeof name, "limit %zu", i + 1);
        whirl_spread_text(&plan->spreads[i], text);
        status = whirl_result_add_fact(result, name, text);
    }
    return status;
}

/// Adds the parameters by which numbers are differentiated, "sensitivity 1", and the numbers, "derived 1".
static whirl_status describe_derivatives(const case_content *content, whirl_result *result) {
    const whirl_derivatives *own = content->plan.derivatives;
    char name[WHIRL_NAME_SIZE], text[WHIRL_SPREAD_TEXT];
    whirl_status status = whirl_ok();
    for (size_t i = 0; own && i < own->parameter_count && status.code == WHIRL_OK; i++) {
        snprintf(name, sizeof name, "sensitivity %zu", i + 1);
        status = whirl_result_add_fact(result, name, own->parameters[i].name);
    }
    for (size_t i = 0; own && i < own->number_count && status.code == WHIRL_OK; i++) {
        snprintf(name, sizeof name, "derived %zu", i + 1);
        whirl_spread_text(&own->numbers[i], text);
        status = whirl_result_add_fact(result, name, text);
    }
    return status;
}

/// Adds a fact of a data set, "dataset machines 1".
static void dataset_fact(whirl_status *status, whirl_result *result, const char *what, size_t number,
                         const char *text) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "dataset %s %zu", what, number);
    if (status->code == WHIRL_OK) *status = whirl_result_add_fact(result, name, text);
}

/// Adds a fact for each parameter of a list, with its distribution.
static void drawn_facts(const case_content *content, whirl_status *status, whirl_result *result, const char *what,
                        size_t count, const whirl_drawn *drawn) {
    char text[DISTRIBUTION_TEXT];
    for (size_t i = 0; i < count; i++) {
        distribution_text(content, content->plan.dataset->parameters[drawn[i].parameter], &drawn[i].of, text);
        dataset_fact(status, result, what, i + 1, text);
    }
}

/// Describes a label: "rub: gap from 90 um to 30 um by severity, mu: uniform from 0.1 to 0.3".
static void label_text(const case_content *content, const whirl_label *label, char *text, size_t size) {
    const char *const *names = content->plan.dataset->parameters;
    char ends[2][3 * WHIRL_NAME_SIZE], own[DISTRIBUTION_TEXT];
    snprintf(text, size, "%s%s", label->name, label->graded_count + label->varied_count > 0 ? ": " : "");
    for (size_t i = 0; i < label->graded_count; i++) {
        const whirl_graded *graded = &label->graded[i];
        value_text(&content->parameters, names[graded->parameter], graded->from, ends[0], sizeof ends[0]);
        value_text(&content->parameters, names[graded->parameter], graded->to, ends[1], sizeof ends[1]);
        const size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s from %s to %s by severity", i ? ", " : "", names[graded->parameter],
                 ends[0], ends[1]);
    }
    for (size_t i = 0; i < label->varied_count; i++) {
        distribution_text(content, names[label->varied[i].parameter], &label->varied[i].of, own);
        const size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", i + label->graded_count ? ", " : "", own);
    }
}

/// Appends ", gap 0.001 m" with the words `before`, if the number is finite and not 0.
static void channel_number(char *text, size_t size, const char *before, double number, const char *unit) {
    const size_t used = strlen(text);
    if (number != 0.0 && isfinite(number))
        snprintf(text + used, size - used, ", %s%.9g%s%s", before, number, *unit ? " " : "", unit);
}

/// Describes a channel: "front [V]: proximity at disc, direction 0 deg, 7870 V/m, gap 0.001 m".
static void channel_text(const case_content *content, const whirl_channel *own, char *text, size_t size) {
    const char *measured = whirl_sensor_unit(own->sensor);
    const bool pulses = own->sensor == WHIRL_SENSOR_KEYPHASOR, volts = own->in_volts;
    const char *unit = volts ? "V" : measured;
    const double degrees = 180.0 / 3.141592653589793238463;
    snprintf(text, size, "%s [%s]: %s", own->name, unit, whirl_sensor_name(own->sensor));
    size_t used = strlen(text);
    if (pulses)
        snprintf(text + used, size - used, ", %d a turn of %.6g deg, jitter %.6g deg", own->pulses,
                 degrees * own->width, degrees * own->jitter);
    else
        snprintf(text + used, size - used, " at %s, direction %.6g deg", content->machine.stations.names[own->station],
                 degrees * own->angle);
    if (volts) channel_number(text, size, "", own->sensitivity, whirl_sensor_sensitivity_unit(own->sensor));
    channel_number(text, size, "gap ", own->gap, "m");
    channel_number(text, size, "from ", own->low, measured);
    channel_number(text, size, "to ", own->high, measured);
    channel_number(text, size, "resonance ", own->resonance, "Hz");
    if (own->resonance > 0.0) channel_number(text, size, "damping ratio ", own->damping, "");
    channel_number(text, size, "high pass ", own->high_pass, "Hz");
    channel_number(text, size, "noise ", own->noise, unit);
    used = strlen(text);
    if (own->bits > 0)
        snprintf(text + used, size - used, ", %d bits from %.6g to %.6g %s", own->bits, -own->full_scale,
                 own->full_scale, unit);
}

/// Describes the law of the speed in records of runs as the case has it: "law: speed_from = low, rate 50 rpm/s".
static void law_text(const setting_list *keys, char *text, size_t size) {
    static const char *const names[] = {"speed_from", "speed_to", "rate", "speeds"};
    const char *between = "law: ";
    *text = '\0';
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const setting *given = settings_find(keys, names[i]);
        if (!given) continue;
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", between, names[i]);
        between = ", ";
        const file_node *row = given->place->kind == NODE_LIST ? given->place->first : given->place;
        for (; row; row = row == given->place ? NULL : row->next)
            for (const file_node *one = row->kind == NODE_LIST ? row->first : row; one;
                 one = one == row ? NULL : one->next) {
                used = strlen(text);
                snprintf(text + used, size - used, " %s", one->text ? one->text : "");
            }
    }
}

/// Describes an event of the runs of a data set as the case has it: "event: time = lost, loss_at disc".
static void event_text(const file_node *event, char *text, size_t size) {
    snprintf(text, size, "event: ");
    for (const file_node *key = event->first; key; key = key->next) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", key == event->first ? "" : ", ", key->key);
        for (const file_node *one = key->kind == NODE_MAPPING ? key->first : key; one;
             one = one == key ? NULL : one->next) {
            used = strlen(text);
            snprintf(text + used, size - used, "%s%s %s", one == key ? "" : " ", one == key ? "" : one->key,
                     one->text ? one->text : "");
        }
    }
}

/// Adds facts about a data set: the parameters that differ between its records, its labels and its channels.
static whirl_status describe_dataset(const case_content *content, whirl_result *result) {
    const whirl_dataset *own = content->plan.dataset;
    char text[WHIRL_MESSAGE_SIZE + 16 * DISTRIBUTION_TEXT];
    whirl_status status = whirl_ok();
    if (!own) return status;
    for (size_t i = 0; i < own->parameter_count; i++)
        dataset_fact(&status, result, "parameter", i + 1, own->parameters[i]);
    drawn_facts(content, &status, result, "machines", own->machine_count, own->machine);
    drawn_facts(content, &status, result, "records", own->condition_count, own->conditions);
    for (size_t i = 0; i < own->label_count; i++) {
        label_text(content, &own->labels[i], text, sizeof text);
        dataset_fact(&status, result, "label", i + 1, text);
    }
    for (size_t i = 0; i < own->channel_count; i++) {
        channel_text(content, &own->channels[i], text, sizeof text);
        dataset_fact(&status, result, "channel", i + 1, text);
    }
    const size_t batch = plan_batch(&content->plan, "records");
    const setting_list *runup = batch < content->plan.batch_count ? content->plan.origins[batch].runup : NULL;
    if (runup) {
        law_text(runup, text, sizeof text);
        dataset_fact(&status, result, "law", 1, text);
        const setting *events = settings_find(runup, "events");
        size_t count = 1;
        for (const file_node *one = events ? events->place->first : NULL; one; one = one->next) {
            event_text(one, text, sizeof text);
            dataset_fact(&status, result, "law", ++count, text);
        }
    }
    return status;
}

/// Finds the length scale at a point of a batch's table; that of the unchanged case if the point is not done.
static whirl_status scale_at(const case_content *content, const whirl_batch *batch, const whirl_table *table,
                             size_t point, double *scale) {
    const number_formula *formula = &settings_find(&content->machine.rotor, "length_scale")->value;
    whirl_given given[PLAN_MAX_GIVEN];
    valuation v;
    if (*table->parameter && isnan(table->values[point])) return whirl_ok();
    whirl_batch own = *batch;
    if (batch->tolerances.samples > 0) own.sampled = 1 + whirl_table_slot(table, point) / batch->row;
    if (batch->dataset) own.sampled = 1 + whirl_table_slot(table, point);
    const size_t count = plan_given(&own, *table->parameter ? table->values[point] : (double)NAN,
                                    whirl_table_second(table, point), whirl_table_third(table, point), given);
    whirl_status status = valuation_open(&v, &content->parameters, given, count);
    if (status.code == WHIRL_OK) status = valuation_number(&v, formula, scale);
    valuation_close(&v);
    return status;
}

/// Finds the length scale of every point of a table, if a parameter changes it.
static whirl_status describe_scales(const case_content *content, const whirl_result *result, whirl_table *table) {
    const setting *given = settings_find(&content->machine.rotor, "length_scale");
    const char *expression = given ? given->value.expression : NULL;
    const size_t index = plan_batch(&content->plan, table->name);
    const whirl_batch *batch = &content->plan.batches[index < content->plan.batch_count ? index : 0];
    if (index == content->plan.batch_count || !expression || !case_depends_on_batch(content, expression, batch))
        return whirl_ok();
    double *scales = malloc((table->count + 1) * sizeof *scales);
    whirl_status status =
        scales ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the scales of %zu points", table->count);
    bool changes = false;
    for (size_t i = 0; i < table->count && status.code == WHIRL_OK; i++) {
        scales[i] = result->length_scale;
        status = scale_at(content, batch, table, i, &scales[i]);
        changes = changes || (status.code == WHIRL_OK && scales[i] != result->length_scale);
    }
    if (status.code == WHIRL_OK && changes)
        table->length_scales = scales;
    else
        free(scales);
    return status;
}

/// Values along an axis of a table; for branches, the ends of their range.
typedef struct axis_values {
    const char *name;
    const double *values;
    size_t count;
} axis_values;

/// Finds out whether the speed of the shaft is proportional to the value of the axis, and the factor.
static whirl_status find_factor(const case_content *content, const whirl_batch *batch, const axis_values *axis,
                                double *factor, bool *found) {
    const number_formula *formula = &settings_find(&content->machine.rotor, "speed")->value;
    *found = axis->count > 0;
    *factor = (double)NAN;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < axis->count && *found && status.code == WHIRL_OK; i++) {
        whirl_given given[WHIRL_MAX_GIVEN + 1] = {{axis->name, axis->values[i]}};
        double speed = 0.0;
        valuation v;
        for (size_t k = 0; k < batch->given_count; k++) given[k + 1] = batch->given[k];
        status = valuation_open(&v, &content->parameters, given, batch->given_count + 1);
        if (status.code == WHIRL_OK) status = valuation_number(&v, formula, &speed);
        valuation_close(&v);
        if (isnan(*factor) && given->value != 0.0) *factor = speed / given->value;
        *found = fabs(speed - (isnan(*factor) ? 0.0 : *factor) * given->value) <= 1e-12 * fabs(speed);
    }
    *found = *found && isfinite(*factor);
    return status;
}

/// Finds out whether the axis changes the rate of an element that is the keyphasor: compares both ends and the middle.
static whirl_status find_change(const whirl_case *object, const axis_values *axis, bool *found) {
    double first = 0.0;
    whirl_status status = whirl_ok();
    *found = false;
    for (size_t i = 0; i < 3 && axis->count > 0 && status.code == WHIRL_OK; i++) {
        whirl_rotor *rotor;
        status = whirl_case_rotor_outline(object, axis->name, axis->values[i * (axis->count - 1) / 2], &rotor);
        if (status.code != WHIRL_OK) break;
        const double clock = whirl_rotor_clock(rotor);
        if (i == 0) first = clock;
        *found = *found || clock != first;
        whirl_rotor_free(rotor);
    }
    return status;
}

/// Describes how the clock of every point of a table depends on its parameters.
static whirl_status describe_clock(const whirl_case *object, const whirl_result *result, whirl_table *table) {
    const case_content *content = &object->content;
    const setting *given = settings_find(&content->machine.rotor, "speed");
    const char *expression = given ? given->value.expression : NULL;
    const size_t index = plan_batch(&content->plan, table->name);
    table->clock_of = 0;
    table->clock_factor = 1.0;
    if (index >= content->plan.batch_count) return whirl_ok();
    const whirl_batch *batch = &content->plan.batches[index];
    // A condition that sets the speed sets it for all points.
    for (size_t i = 0; i < batch->given_count && expression; i++)
        if (case_depends(content, expression, batch->given[i].name)) table->clock_of = WHIRL_CLOCK_UNKNOWN;
    for (int i = 0; i < batch->tolerances.parameters && expression; i++)
        if (case_depends(content, expression, batch->tolerated[i].name)) table->clock_of = WHIRL_CLOCK_UNKNOWN;
    for (size_t i = 0; batch->dataset && expression && i < batch->dataset->parameter_count; i++)
        if (case_depends(content, expression, batch->dataset->parameters[i])) table->clock_of = WHIRL_CLOCK_UNKNOWN;
    if (!*table->parameter || table->clock_of == WHIRL_CLOCK_UNKNOWN) return whirl_ok();
    const bool traced = batch->values == NULL, keyphasor = *whirl_result_keyphasor(result) != '\0';
    const axis_values axes[] = {{batch->parameter, traced ? batch->bounds : batch->values, traced ? 2 : batch->count},
                                {batch->second, batch->second_values ? batch->second_values : batch->second_bounds,
                                 batch->second_values ? batch->count : 2},
                                {batch->third, batch->third_values, batch->count}};
    whirl_status status = whirl_ok();
    for (int i = 0; i < 3 && status.code == WHIRL_OK; i++) {
        if (!*axes[i].name) continue;
        bool changes = expression && case_depends(content, expression, axes[i].name);
        if (keyphasor) status = find_change(object, &axes[i], &changes);
        if (changes) table->clock_of = keyphasor || table->clock_of ? WHIRL_CLOCK_UNKNOWN : i + 1;
    }
    if (status.code != WHIRL_OK || table->clock_of == 0 || table->clock_of == WHIRL_CLOCK_UNKNOWN) return status;
    const axis_values *axis = &axes[table->clock_of - 1];
    bool found = strcmp(expression, axis->name) == 0; // the usual case, also of maps with a million points
    if (!found) status = find_factor(content, batch, axis, &table->clock_factor, &found);
    if (!found) {
        table->clock_of = WHIRL_CLOCK_UNKNOWN;
        table->clock_factor = 1.0;
    }
    return status;
}

static void forget(whirl_result *result) {
    for (size_t i = 0; i < result->table_count; i++) {
        free(result->tables[i].length_scales);
        result->tables[i].length_scales = NULL;
    }
    free(result->case_text);
    free(result->parameters);
    free(result->stations);
    free(result->contacts);
    result->case_text = NULL;
    result->parameters = NULL;
    result->stations = NULL;
    result->contacts = NULL;
    result->parameter_count = result->station_count = result->contact_count = 0;
}

whirl_status whirl_case_speed(const whirl_case *object, const char *name, double value, double *speed) {
    whirl_rotor *rotor;
    const whirl_status status = whirl_case_rotor_outline(object, name, value, &rotor);
    *speed = status.code == WHIRL_OK ? whirl_rotor_speed(rotor) : (double)NAN;
    whirl_rotor_free(rotor);
    return status;
}

/// Adds the facts "document tag", "document author", ..., with which reports begin.
static whirl_status describe_document(const case_content *content, whirl_result *result) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < content->document.count && status.code == WHIRL_OK; i++) {
        const setting *own = &content->document.items[i];
        char name[WHIRL_NAME_SIZE], text[DOCUMENT_TEXT];
        snprintf(name, sizeof name, "document %.40s", own->key->name);
        snprintf(text, sizeof text, "%s", own->place->text);
        whirl_make_plain(text);
        status = whirl_result_add_fact(result, name, text);
    }
    return status;
}

whirl_status whirl_case_describe_result(const whirl_case *object, whirl_result *result) {
    forget(result);
    snprintf(result->title, sizeof result->title, "%s", object->content.title);
    snprintf(result->case_name, sizeof result->case_name, "%s", object->name);
    // A file may have any name; both may have been cut within a character.
    whirl_make_plain(result->title);
    whirl_make_plain(result->case_name);
    result->case_text = malloc(object->length + 1);
    if (!result->case_text) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the text of a case");
    memcpy(result->case_text, object->text, object->length + 1);
    whirl_status status = describe_parameters(&object->content, result);
    if (status.code == WHIRL_OK) status = describe_rotor(object, result);
    if (status.code == WHIRL_OK) status = describe_document(&object->content, result);
    if (status.code == WHIRL_OK) status = describe_weight(&object->content, result);
    for (size_t i = 0; i < result->table_count && status.code == WHIRL_OK; i++)
        status = describe_scales(&object->content, result, &result->tables[i]);
    for (size_t i = 0; i < result->table_count && status.code == WHIRL_OK; i++)
        status = describe_clock(object, result, &result->tables[i]);
    for (size_t i = 0; i < object->content.plan.batch_count && status.code == WHIRL_OK; i++) {
        const whirl_batch *batch = &object->content.plan.batches[i];
        status = describe_axes(&object->content, batch, &object->content.plan.origins[i], result);
        if (status.code == WHIRL_OK) status = describe_given(&object->content, batch, result);
    }
    if (status.code == WHIRL_OK) status = describe_tolerances(&object->content, result);
    if (status.code == WHIRL_OK) status = describe_derivatives(&object->content, result);
    if (status.code == WHIRL_OK) status = describe_dataset(&object->content, result);
    if (status.code == WHIRL_OK && *object->content.units)
        status = whirl_result_add_fact(result, "units", object->content.units);
    if (status.code == WHIRL_OK) status = case_warn(&object->content, result);
    return status;
}

/// Adds the descriptions of the case and of the build to a result. Frees a result that cannot be described.
static whirl_status describe_whole(const whirl_case *object, whirl_result **result) {
    whirl_status status = whirl_case_describe_result(object, *result);
    if (status.code == WHIRL_OK) status = whirl_result_add_provenance(*result);
    if (status.code == WHIRL_OK) return status;
    whirl_result_free(*result);
    *result = NULL;
    return status;
}

whirl_status whirl_case_outline(const whirl_case *object, whirl_result **outline) {
    whirl_study study;
    *outline = NULL;
    whirl_status status = whirl_case_study(object, &study);
    if (status.code == WHIRL_OK) status = whirl_study_outline(&study, outline);
    return status.code == WHIRL_OK ? describe_whole(object, outline) : status;
}

whirl_status whirl_case_run(const whirl_case *object, const whirl_run_options *options, whirl_result **result) {
    whirl_study study;
    *result = NULL;
    whirl_status status = whirl_case_study(object, &study);
    if (status.code == WHIRL_OK) status = whirl_study_run(&study, options, result);
    if (!*result) return status;
    const whirl_status described = describe_whole(object, result);
    return described.code == WHIRL_OK ? status : described;
}
